/* built from web/ by "npm run build"; sources c5a95fe3a004d169923cbb5169ffed4ea856e5554092dbc969a9bf4432a8b4b4 */
"use strict";(()=>{var Fn={SIMULTANEOUS:0,SWARM_TURNS:1,AGENT_TURNS:2},et={DISAPPEAR:0,REACH:1,BOUNCE:2},Un={OCCUPATION:0,SURROUND:1},Dn={FAULT:0,INVOLVED:1};var Lr=["obstacle","teammate","adversary"],Ir=["vertex","edge","chain"],Wn=["turn","kind","form","first","second","row","col","at_fault","held","doomed"],Fr=["p\
ursuer_{number}","evader_{number}"],zn={obstacle:"{first} ran into the obstacle or border at {cell}",vertex:"{first} and {second} both headed for {cell}",edge:"\
{first} and {second} meant to swap, {first} to {cell}",chain:"{first} headed for {cell}, where {second} had to stay"},tt={"both held":"both bounce","both doomed":"\
both disappear",held:"{agent} bounces",doomed:"{agent} disappears",none:"nobody is stopped"},Bn="{event}: {outcome}",Ur={random:"any action, all equally likely",
still:"always stays",chaser:"moves to where the nearest adversary in view is nearest",fleer:"moves to where the nearest adversary in view is farthest","clumsy-c\
haser":"a chaser that takes any action in half of the steps",hunter:"a chaser of the nearest adversary in view to which no teammate in view is nearer",surrounder:"\
a chaser of the nearest free cell beside an adversary without a teammate","clumsy-fleer":"a fleer that takes any action in half of the steps",dodger:"moves to w\
here all adversaries in view together are farthest","team-surrounder":"shares the free cells beside adversaries with its teammates, and searches","careful-rando\
m":"as random, but takes only moves that right of way allows","careful-chaser":"as chaser, but takes only moves that right of way allows","careful-fleer":"as fl\
eer, but takes only moves that right of way allows","careful-clumsy-chaser":"as clumsy-chaser, but takes only moves that right of way allows","careful-hunter":"\
as hunter, but takes only moves that right of way allows","careful-surrounder":"as surrounder, but takes only moves that right of way allows","careful-clumsy-fl\
eer":"as clumsy-fleer, but takes only moves that right of way allows","careful-dodger":"as dodger, but takes only moves that right of way allows","careful-team-\
surrounder":"as team-surrounder, but takes only moves that right of way allows"},jn={free:".GS",blocked:"#@OTW"};var Fe=1+Wn.length;function rt(r,e){return r.replace(/\{(\w+)\}/g,(t,n)=>String(e[n]))}function K(r,e){return r<e?rt(Fr[0],{number:r}):rt(Fr[1],{number:r-e})}function Ga(r,e){
let[t,n,s,o,a,i,l,...c]=Array.from(r),h=a<0?[o]:[o,a],[u,m,p]=c.map(v=>h.filter((S,w)=>v>>w&1)),y=h.map(v=>K(v,e)),f=rt(zn[a<0?"obstacle":Ir[s]],{first:y[0],second:y[y.
length-1],cell:`(${i}, ${l})`}),g=rt(Bn,{event:f,outcome:Va(h.length,m,p,e)});return{kind:Lr[n],form:Ir[s],agents:h,cell:[i,l],at_fault:u,held:m,doomed:p,turn:t,
text:g}}function Va(r,e,t,n){if(r===2&&e.length===2)return tt["both held"];if(r===2&&t.length===2)return tt["both doomed"];let s=o=>a=>rt(tt[o],{agent:K(a,n)});
return[...e.map(s("held")),...t.map(s("doomed"))].join(", ")||tt.none}function Ot(r,e){let t=[];for(let n=0;n<r.length;n+=Fe)t.push(Ga(r.subarray(n+1,n+Fe),e));
return t}var ve=class extends Error{name="EngineError"};function F(r,e,t){let n=typeof t=="string"?`'${t}'`:typeof t=="object"?JSON.stringify(t):String(t);return new ve(
`${r}: expected ${e}, got ${n}`)}var Ue=class{bytes;constructor(e){this.bytes=e}},Vn=0,Wr=[Uint8Array,Uint8Array,Int32Array,BigInt64Array,BigUint64Array,Float32Array,Float64Array],Hn=4,Gn=4,Ya=new TextEncoder,
Ka=new TextDecoder;function qa(r){for(let e=Wr.length-1;e>Vn;--e)if(r instanceof Wr[e])return e;throw new TypeError("array: expected a typed array of the engine\
's numbers, got another")}function Dr(r){return new Uint8Array(r.buffer,r.byteOffset,r.byteLength)}function Za(r){return Ya.encode(`${r}\0`)}var zr=class{engine;addresses=[];constructor(e){
this.engine=e}copy(e){let t=this.engine._malloc(Math.max(e.length,1));if(t===0)throw new ve("memory: expected room for the arguments, got none");return this.addresses.
push(t),this.engine.HEAPU8.set(e,t),t}text(e){return this.copy(Za(e))}arrays(e){let t=Object.entries(e),n=t.flatMap(([o,a])=>{let i=a instanceof Ue,l=i?a.bytes:
a;return[this.text(o),i?Vn:qa(l),l.length,this.copy(Dr(l))]}),s=this.copy(Dr(Int32Array.from(n)));return this.copy(Dr(Int32Array.of(t.length,s)))}free(){for(let e of this.
addresses)this.engine._free(e)}};function Yn(r,e){let t=r.HEAPU8;return Ka.decode(t.subarray(e,t.indexOf(0,e)))}function De(r){let e=new Int32Array(r.HEAPU8.buffer),
t=r._last_outputs()/Hn,n=e[t+1]/Hn,s={};for(let o=n;o<n+e[t]*Gn;o+=Gn){let a=Wr[e[o+1]],i=e[o+2]*a.BYTES_PER_ELEMENT,l=e[o+3];s[Yn(r,e[o])]=new a(r.HEAPU8.slice(
l,l+i).buffer)}return s}function be(r,e){let t=new zr(r);try{let n=e(t);if(n===0)throw new ve(Yn(r,r._last_error()));return n}finally{t.free()}}var Ja=2**31-1,Kn=["none","gru"],Xa=2n**64n-1n,Qa=34028234663852886e22;function me(r,e){if(typeof e!="number"||!Number.isInteger(e)||Math.abs(e)>Ja)throw F(r,"a\
n integer",e);return Int32Array.of(e)}function Rt(r,e){if(typeof e!="boolean")throw F(r,"true or false",e);return new Ue(Uint8Array.of(Number(e)))}function Te(r,e,t){
let n=typeof e=="string"&&Object.hasOwn(t,e)?t[e]:void 0;if(n===void 0)throw F(r,`one of ${Object.keys(t).join(", ")}`,e);return Int32Array.of(n)}function Br(r,e){
if(typeof e!="number"||!(Math.abs(e)<=Qa))throw F(r,"a finite number",e);return e}function nt(r,e){let n=typeof e=="bigint"||typeof e=="number"&&Number.isSafeInteger(
e)?BigInt(e):-1n;if(n<0n||n>Xa)throw F(r,"an integer from 0 to 2^64 - 1",e);return BigUint64Array.of(n)}function ei(r){return{"rules.interaction":Te("interactio\
n",r.interaction,Fn),"rules.obstacle":Te("obstacle",r.obstacle,et),"rules.teammate":Te("teammate",r.teammate,et),"rules.evader":Te("evader",r.evader,et),"rules.\
pursuer":Te("pursuer",r.pursuer,et),"rules.capture":Te("capture",r.capture,Un),"rules.captured_disappear":Rt("captured_disappear",r.captured_disappear)}}function qn(r,e){
let t=typeof e=="number"?[e,e,e]:e;if(!Array.isArray(t)||t.length!==3)throw F(r,"1 or 3 numbers",e);return Float32Array.from(t,n=>Br(r,n))}function ti(r){let e=(t,n)=>Float32Array.
of(Br(t,r[t]),Br(n,r[n]));return{"rewards.capture":e("pursuer_capture","evader_capture"),"rewards.neighbor":e("pursuer_neighbor","evader_neighbor"),"rewards.ste\
p":e("pursuer_step","evader_step"),"rewards.pursuer_collide":qn("pursuer_collide",r.pursuer_collide),"rewards.evader_collide":qn("evader_collide",r.evader_collide),
"rewards.blame":Te("blame",r.blame,Dn),"rewards.capture_repeats":Rt("capture_repeats",r.capture_repeats)}}function Jn(r){if(r===void 0||typeof r=="number")return new Uint8Array(
0);if(r instanceof Uint8Array)return r;let{free:e,blocked:t}=jn;for(let[n,s]of r.entries()){if(s.length!==r[0]?.length)throw F(`map, row ${n}`,`${r[0]?.length} \
cells as in row 0`,s.length);let o=[...s].find(a=>!e.includes(a)&&!t.includes(a));if(o)throw F(`map, row ${n}`,`'${e}' (free) or '${t}' (obstacle)`,o)}return Uint8Array.
from([...r.join("")],n=>Number(t.includes(n)))}function Xn(r,e){if(!Array.isArray(r))return;let t=[r.length,r[0]?.length??0];if(!(t[0]===e.rows&&t[1]===e.cols))
throw F("obstacle map",`shape (${e.rows}, ${e.cols}), the rows and cols`,t)}function We(r){Xn(r.obstacles,r);let e=typeof r.obstacles=="number"?r.obstacles:0;return{
...ei(r.rules),...ti(r.rewards),rows:me("rows",r.rows),cols:me("cols",r.cols),n_pursuers:me("n_pursuers",r.n_pursuers),n_evaders:me("n_evaders",r.n_evaders),fov:me(
"fov",r.fov),diagonal:Rt("diagonal",r.diagonal),max_steps:me("max_steps",r.max_steps),density:Float64Array.of(e),map:Jn(r.obstacles)}}function Zn(r,e){return Int32Array.
from((e??[]).flat(),t=>me(r,t)[0])}function Qn(r,e){return Xn(r.obstacles,e),{seed:nt("seed",r.seed??0n),episode:nt("episode",r.episode??0),pursuers:Zn("pursuer\
s",r.pursuers),evaders:Zn("evaders",r.evaders),map:Jn(r.obstacles)}}function _t(r){return{actions:Int32Array.from(r,e=>me("actions",e)[0])}}function ze(r){if(typeof r==
"string"){if(!Object.hasOwn(Ur,r))throw F("policy",`one of ${Object.keys(Ur).join(", ")}`,r);return{script:new TextEncoder().encode(r)}}if(r.activation!=="relu"&&
r.activation!=="tanh")throw F("activation","'relu' or 'tanh'",r.activation);if(!Kn.includes(r.memory))throw F("memory",`one of ${Kn.join(", ")}`,r.memory);return{
hidden:Int32Array.from(r.hidden,e=>me("hidden",e)[0]),activation:new TextEncoder().encode(r.activation),sampled:Rt("sampled",r.sampled),memory:new TextEncoder().
encode(r.memory),genome:r.genome}}var ri=["first_turn","terminated","truncated"];function es(r){let e={...r};for(let t of ri)e[t]=new Ue(r[t]);return e}var ts="statistics.",Pt=class{config;seed;episode;n_agents;statistics;first_conflict;constructor(e,t,n,s){this.config=e,this.seed=t,this.episode=n,this.n_agents=
e.n_pursuers+e.n_evaders,this.statistics=si(rs(s)),Object.assign(this,s),this.first_conflict=ni(this.conflict_table,this.length)}get length(){return this.actions.
length/this.n_agents}conflicts(e){this.check(e);let[t,n]=[this.first_conflict[e],this.first_conflict[e+1]],s=this.conflict_table.subarray(t*Fe,n*Fe);return Ot(s,
this.config.n_pursuers)}seek(e,t,n){this.check(t),(!(e.seed===this.seed&&e.episode===BigInt(this.episode))||e.turn!==0||e.steps>t)&&e.reset({seed:this.seed,episode:this.
episode});for(let o=e.steps;o<t;++o){let a=this.actions.subarray(o*this.n_agents,(o+1)*this.n_agents);n?e.replay(a,{pursuer:n.pursuers,evader:n.evaders}):e.step(
a)}}check(e){if(!(Number.isInteger(e)&&e>=0&&e<=this.length))throw F("step",`0 to ${this.length}`,e)}};function ni(r,e){let t=new Int32Array(e+2);for(let n=0;n<
r.length;n+=Fe)++t[r[n]+1];for(let n=1;n<t.length;++n)t[n]+=t[n-1];return t}function si(r){let e=["capture_rate","ever_capture_rate","captured_fraction","length"];
return Object.fromEntries(Object.entries(r).map(([t,n])=>[t,e.includes(t)?Number(n[0]):n]))}var rs=r=>Object.fromEntries(Object.entries(r).flatMap(([e,t])=>e.startsWith(
ts)?[[e.slice(ts.length),t]]:[]));function ns(r,e,t,n){let s=[We(t.config),ze(t.pursuers),ze(t.evaders),n];return be(r,o=>{let[a,i,l,c]=s.map(h=>o.arrays(h));return r[e](
a,i,l,c)}),De(r)}function ss(r,e,t,n){let s={seed:nt("seed",t),episode:nt("episode",n)};return new Pt(e.config,t,n,ns(r,"_play_match",e,s))}function os(r,e,t,n){
if(!Number.isInteger(n)||n<1)throw F("n_episodes","at least 1",n);let s=ns(r,"_play_rollout",e,{...t,n_episodes:Int32Array.of(n)});return rs(s)}var oi=7e6,ai=new FinalizationRegistry(([r,e])=>r._states_free(e));function ii({rules:r,rows:e,cols:t,obstacles:n,diagonal:s,n_pursuers:o,n_evaders:a}){let i=typeof n==
"number"||r.obstacle==="REACH"?0:n.join("").split("#").length-1,l=e*t-i,c=[r.obstacle,r.teammate,r.pursuer].includes("DISAPPEAR"),h=r.capture==="SURROUND"||r.evader===
"REACH",u=r.interaction==="AGENT_TURNS",m=(f,g)=>Array.from({length:g},(v,S)=>u?f:(f+S)/(S+1)).reduce((v,S)=>v*S,1),p=m(l+Number(c),o)*m(l*(1+Number(h))+2,a);return{
SIMULTANEOUS:[o+a],SWARM_TURNS:[o,a],AGENT_TURNS:Array(o+a).fill(1)}[r.interaction].reduce((f,g)=>f+p*(s?9:5)**g,0)}function $t(r){return typeof r.obstacles=="n\
umber"&&r.obstacles>0?"obstacles are drawn anew in each episode":ii(r)>oi?"the world is too large to be solved on the page":""}var jr=class{value;teams;matrix;n_actions;constructor(e,t){
let{matrix:n,rows:s,cols:o,value:a,agents:i}=t,[l,c]=e.actors,h=Array.from(i).filter(m=>l<=m&&m<c),u=m=>m<e.config.n_pursuers;[this.value,this.matrix,this.n_actions]=
[a[0],n,e.n_actions],this.teams=[{agents:h.filter(u),play:s},{agents:h.filter(m=>!u(m)),play:o}]}marginal(e){let t=this.teams.find(({agents:o})=>o.includes(e));
if(!t)return null;let n=this.n_actions**(t.agents.length-1-t.agents.indexOf(e)),s=Array(this.n_actions).fill(0);return t.play.forEach((o,a)=>s[Math.floor(a/n)%this.
n_actions]+=o),s}lost(e){let[t,n]=this.teams.map(({agents:l})=>l.reduce((c,h)=>c*this.n_actions+e[h],0)),[s,o]=this.teams.map(({play:l})=>l),a=o.reduce((l,c,h)=>l+
c*this.matrix[t*o.length+h],0),i=s.reduce((l,c,h)=>l+c*this.matrix[h*o.length+n],0);return[Math.max(0,this.value-a),Math.max(0,i-this.value)]}},Hr=60,st=class{config;payoff;engine;states;n_turns;values;constructor(e,t,n){
[this.engine,this.config,this.payoff]=[e,t,n],this.states=be(e,i=>e._states_new(i.arrays(We(t)))),ai.register(this,[e,this.states]);let s={SIMULTANEOUS:1,SWARM_TURNS:2,
AGENT_TURNS:t.n_pursuers+t.n_evaders};this.n_turns=s[t.rules.interaction];let{payoffs:o}=this.call(()=>e._states_payoffs(this.states)),a=o;this.values=[[n==="ca\
pture-rate"?a:a.fill(0)]]}goBack(){let e=this.values.at(-1)[0],t=[];for(let s=this.n_turns-1;s>=0;s--){let o=t[s+1]??e;t[s]=this.backup(s,{next:o})}this.payoff===
"capture-time"&&(t[0]=t[0].map((s,o)=>o===this.config.n_evaders?0:s-1)),this.values.push(t);let n=this.payoff==="capture-rate"?this.config.max_steps:Math.min(this.
config.max_steps,Hr);return this.values.length<=n&&t[0].some((s,o)=>s!==e[o])}backup(e,t){return this.call(n=>this.engine._states_backup(this.states,e,n.arrays(
t))).values}game(e){let[t,{turn:n}]=[this.config.max_steps-e.steps,e],s=n+1===this.n_turns,o=t>0?this.values[Math.min(t-Number(s),this.values.length-1)]?.[s?0:n+
1]:void 0;if(!o)return null;let a=this.call(i=>this.engine._states_game(this.states,e.address,i.arrays({next:o})));return a.agents.length?new jr(e,a):null}call(e){
return be(this.engine,e),De(this.engine)}};var as=new FinalizationRegistry(([r,e])=>r._world_free(e)),ot=class{config;n_agents;n_actions;engine;at;freed=!1;constructor(e,t){this.engine=e,this.config=t,this.
n_agents=t.n_pursuers+t.n_evaders,this.n_actions=t.diagonal?9:5,this.at=be(e,n=>e._world_new(n.arrays(We(t)))),as.register(this,[e,this.at],this)}free(){this.freed||
(this.freed=!0,as.unregister(this),this.engine._world_free(this.at))}get address(){if(this.freed)throw F("world","one that is in use","one that was freed");return this.
at}reset(e={}){let t=Qn(e,this.config);this.call(n=>this.engine._world_reset(this.address,n.arrays(t)))}step(e){let t=_t(e);this.call(n=>this.engine._world_step(
this.address,n.arrays(t)))}playTurn(e){let t=_t(e);this.call(n=>this.engine._world_play_turn(this.address,n.arrays(t)))}decide(e,t,n){let{n_pursuers:s}=this.config,
o={pursuer:[0,s],evader:[s,this.n_agents]},[a,i]=typeof t=="string"?o[t]:t;if(n.length!==this.n_agents)throw F("actions",String(this.n_agents),n.length);let l=[
ze(e),_t(n)],{actions:c}=this.call(h=>this.engine._world_decide(this.address,h.arrays(l[0]),a,i,h.arrays(l[1])));return Uint8Array.from(c)}replay(e,t){let n=o=>typeof o!=
"string"&&o.memory!=="none";if(!n(t.pursuer)&&!n(t.evader))return this.step(e);let{n_pursuers:s}=this.config;for(let o=this.n_turns;o>0;--o){let[a,i]=this.actors;
a<s&&this.decide(t.pursuer,[a,Math.min(i,s)],e),i>s&&this.decide(t.evader,[Math.max(a,s),i],e),this.playTurn(e)}}get n_turns(){return this.turnNumbers()[1]}get turn(){
return this.turnNumbers()[0]}get actors(){let[,,e,t]=this.turnNumbers();return[e,t]}turnNumbers(){return this.call(()=>this.engine._world_turn(this.address)).turn}get steps(){
return this.read("steps")[0]}get seed(){return this.read("seed")[0]}get episode(){return this.read("episode")[0]}get over(){return this.read("terminated")[0]===
1||this.read("truncated")[0]===1}read(e){return this.call(t=>this.engine._world_read(this.address,t.text(e)))[e]}view(e){let t=3*this.config.fov**2;return this.
read("views").slice(e*t,(e+1)*t)}map(){return this.read("state").slice(2*this.config.rows*this.config.cols)}conflicts(){return Ot(this.conflictTable(),this.config.
n_pursuers)}conflictTable(){return this.call(()=>this.engine._world_conflicts(this.address)).conflict_table}answer(e,t){let n=ze(e),{logits:s,memory:o}=this.call(
l=>this.engine._world_logits(this.address,l.arrays(n),t)),a=s,i=this.decide(e,[t,t+1],new Uint8Array(this.n_agents))[t];return{logits:a,probabilities:li(a),action:i,
memory:o}}snapshot(){return this.call(()=>this.engine._world_snapshot(this.address))}restore(e){let t=es(e);this.call(n=>this.engine._world_restore(this.address,
n.arrays(t)))}call(e){return be(this.engine,e),De(this.engine)}};function li(r){let e=Math.max(...r),t=Array.from(r,s=>Math.exp(s-e)),n=t.reduce((s,o)=>s+o,0);return Float32Array.
from(t,s=>s/n)}var Gr=class{compiled;constructor(e){this.compiled=e}world(e){return new ot(this.compiled,e)}solution(e,t="capture-rate"){return new st(this.compiled,e,t)}match(e,t,n,s,o=0){
return ss(this.compiled,{config:e,pursuers:t,evaders:n},s,o)}rollouts(e,t,n,s,o){return os(this.compiled,{config:e,pursuers:t,evaders:n},s,o)}},is;function Nt(r=globalThis.
matrixworldEngine){return is??=ci(r),is}async function ci(r){if(!r)throw new Error("matrixworldEngine: expected the script engine.js before this one, got none");
let e=Uint8Array.from(atob(r.binary),t=>t.charCodeAt(0));return new Gr(await r({wasmBinary:e}))}var ui="http://www.w3.org/2000/svg";function d(r,e={},...t){return ls(document.createElement(r),e,t)}function b(r,e={},...t){return ls(document.createElementNS(
ui,r),e,t)}function ls(r,e,t){for(let[s,o]of Object.entries(e))o==null||o===!1||(typeof o=="function"?r.addEventListener(s.slice(2),o):r.setAttribute(s,o===!0?"":
String(o)));let n=t.filter(s=>s!=null&&s!==!1);return r.append(...n.map(s=>typeof s=="number"?String(s):s)),r}function se(r,e){let t=d("select",{onchange:()=>e(
t.value)},...r.map(([n,s])=>d("option",{value:n},s)));return t}async function cs(r){try{await r}catch(e){throw(document.querySelector("#page, main")??document.body).
prepend(d("p",{class:"card problem",role:"alert"},`The page could not start: ${String(e)}`)),e}finally{document.body.dataset.ready="true"}}var Lt=()=>["file:","\
http:","https:"].includes(location.protocol);var us=r=>d("input",{type:"text",readonly:!0,"aria-label":r});function It(r,e){let t=URL.createObjectURL(new Blob([e],{type:"application/octet-stream"}));d("a",
{href:t,download:r}).click(),setTimeout(()=>URL.revokeObjectURL(t),6e4)}var hs=()=>document.documentElement.dataset.theme==="dark",at=r=>{document.documentElement.dataset.theme=r?"dark":"light"},Vr=()=>at(!hs());if(typeof document<"\
u"){let r=matchMedia("(prefers-color-scheme: dark)");r.addEventListener("change",()=>at(r.matches)),at(r.matches);let e=!1;addEventListener("beforeprint",()=>{e=
hs(),at(!1)}),addEventListener("afterprint",()=>at(e))}function ds(){return d("button",{type:"button",title:"Light or dark (D)","aria-label":"Light or dark",onclick:Vr},
"◐")}var ms=(r,e,...t)=>d("header",{class:"top"},d("div",{},d("h1",{},r),e?d("p",{class:"lead"},e):null),d("div",{class:"tools"},...t,ds()));var hi=Array.from({length:16},(r,e)=>{let[t,n]=[e%2?6.5:11,Math.PI*e/8];return`${12+t*Math.sin(n)} ${12-t*Math.cos(n)}`}).join(" ");function Ft(){let r=[["pursu\
er",b("path",{d:"M12 3 22 20H2z",class:"filled-pursuer"})],["evader",b("circle",{cx:12,cy:12,r:9,class:"filled-evader"})],["capture",b("polygon",{points:hi,class:"\
filled-capture"})],["captured evader",b("circle",{cx:12,cy:12,r:7.5,class:"ring-evader"})],["conflict",b("rect",{x:3,y:3,width:18,height:18,class:"dashed-confli\
ct"})]];return d("ul",{class:"shapes small","aria-label":"Shapes on the board"},...r.map(([e,t])=>d("li",{},b("svg",{viewBox:"0 0 24 24","aria-hidden":"true"},t),
e)))}var ie=["stay","north","east","south","west","northeast","southeast","southwest","northwest"];var ps="champion",fs=0,Yr=64,Kr=100;var di=(r,e)=>Object.keys(r).every(t=>r[t]===e[t]);function ys(r,e){return Object.keys(e).find(t=>di(e[t],r))??null}function gs(r,e,t){let n=new Set(r);return Array.
from({length:e},(s,o)=>Array.from({length:t},(a,i)=>n.has(o*t+i)?"#":".").join(""))}function Ut(r,e,t){let n=r.filter(s=>s!==e);return t?[...n,e].sort((s,o)=>s-
o):n}var P=Uint8Array,Q=Uint16Array,nn=Int32Array,Dt=new P([0,0,0,0,0,0,0,0,1,1,1,1,2,2,2,2,3,3,3,3,4,4,4,4,5,5,5,5,0,0,0,0]),Wt=new P([0,0,0,0,1,1,2,2,3,3,4,4,5,5,6,
6,7,7,8,8,9,9,10,10,11,11,12,12,13,13,0,0]),Xr=new P([16,17,18,0,8,7,9,6,10,5,11,4,12,3,13,2,14,1,15]),As=function(r,e){for(var t=new Q(31),n=0;n<31;++n)t[n]=e+=
1<<r[n-1];for(var s=new nn(t[30]),n=1;n<30;++n)for(var o=t[n];o<t[n+1];++o)s[o]=o-t[n]<<5|n;return{b:t,r:s}},Ms=As(Dt,2),Es=Ms.b,Qr=Ms.r;Es[28]=258,Qr[258]=28;var Ts=As(
Wt,0),mi=Ts.b,vs=Ts.r,en=new Q(32768);for(E=0;E<32768;++E)pe=(E&43690)>>1|(E&21845)<<1,pe=(pe&52428)>>2|(pe&13107)<<2,pe=(pe&61680)>>4|(pe&3855)<<4,en[E]=((pe&65280)>>
8|(pe&255)<<8)>>1;var pe,E,le=(function(r,e,t){for(var n=r.length,s=0,o=new Q(e);s<n;++s)r[s]&&++o[r[s]-1];var a=new Q(e);for(s=1;s<e;++s)a[s]=a[s-1]+o[s-1]<<1;
var i;if(t){i=new Q(1<<e);var l=15-e;for(s=0;s<n;++s)if(r[s])for(var c=s<<4|r[s],h=e-r[s],u=a[r[s]-1]++<<h,m=u|(1<<h)-1;u<=m;++u)i[en[u]>>l]=c}else for(i=new Q(
n),s=0;s<n;++s)r[s]&&(i[s]=en[a[r[s]-1]++]>>15-r[s]);return i}),we=new P(288);for(E=0;E<144;++E)we[E]=8;var E;for(E=144;E<256;++E)we[E]=9;var E;for(E=256;E<280;++E)
we[E]=7;var E;for(E=280;E<288;++E)we[E]=8;var E,ct=new P(32);for(E=0;E<32;++E)ct[E]=5;var E,pi=le(we,9,0),fi=le(we,9,1),yi=le(ct,5,0),gi=le(ct,5,1),qr=function(r){
for(var e=r[0],t=1;t<r.length;++t)r[t]>e&&(e=r[t]);return e},oe=function(r,e,t){var n=e/8|0;return(r[n]|r[n+1]<<8)>>(e&7)&t},Zr=function(r,e){var t=e/8|0;return(r[t]|
r[t+1]<<8|r[t+2]<<16)>>(e&7)},sn=function(r){return(r+7)/8|0},on=function(r,e,t){return(e==null||e<0)&&(e=0),(t==null||t>r.length)&&(t=r.length),new P(r.subarray(
e,t))};var vi=["unexpected EOF","invalid block type","invalid length/literal","invalid distance","stream finished","no stream handler",,"no callback","invalid UTF-8 da\
ta","extra field too long","date not in range 1980-2099","filename too long","stream finishing","invalid zip data"],q=function(r,e,t){var n=new Error(e||vi[r]);
if(n.code=r,Error.captureStackTrace&&Error.captureStackTrace(n,q),!t)throw n;return n},bi=function(r,e,t,n){var s=r.length,o=n?n.length:0;if(!s||e.f&&!e.l)return t||
new P(0);var a=!t,i=a||e.i!=2,l=e.i;a&&(t=new P(s*3));var c=function(Xe){var Qe=t.length;if(Xe>Qe){var Ie=new P(Math.max(Qe*2,Xe));Ie.set(t),t=Ie}},h=e.f||0,u=e.
p||0,m=e.b||0,p=e.l,y=e.d,f=e.m,g=e.n,v=s*8;do{if(!p){h=oe(r,u,1);var S=oe(r,u+1,3);if(u+=3,S)if(S==1)p=fi,y=gi,f=9,g=5;else if(S==2){var L=oe(r,u,31)+257,$=oe(
r,u+10,15)+4,A=L+oe(r,u+5,31)+1;u+=14;for(var x=new P(A),U=new P(19),I=0;I<$;++I)U[Xr[I]]=oe(r,u+I*3,7);u+=$*3;for(var B=qr(U),ge=(1<<B)-1,Z=le(U,B,1),I=0;I<A;){
var V=Z[oe(r,u,ge)];u+=V&15;var w=V>>4;if(w<16)x[I++]=w;else{var D=0,R=0;for(w==16?(R=3+oe(r,u,3),u+=2,D=x[I-1]):w==17?(R=3+oe(r,u,7),u+=3):w==18&&(R=11+oe(r,u,
127),u+=7);R--;)x[I++]=D}}var Y=x.subarray(0,L),W=x.subarray(L);f=qr(Y),g=qr(W),p=le(Y,f,1),y=le(W,g,1)}else q(1);else{var w=sn(u)+4,M=r[w-4]|r[w-3]<<8,O=w+M;if(O>
s){l&&q(0);break}i&&c(m+M),t.set(r.subarray(w,O),m),e.b=m+=M,e.p=u=O*8,e.f=h;continue}if(u>v){l&&q(0);break}}i&&c(m+131072);for(var Je=(1<<f)-1,te=(1<<g)-1,de=u;;de=
u){var D=p[Zr(r,u)&Je],J=D>>4;if(u+=D&15,u>v){l&&q(0);break}if(D||q(2),J<256)t[m++]=J;else if(J==256){de=u,p=null;break}else{var X=J-254;if(J>264){var I=J-257,_=Dt[I];
X=oe(r,u,(1<<_)-1)+Es[I],u+=_}var ae=y[Zr(r,u)&te],Ne=ae>>4;ae||q(3),u+=ae&15;var W=mi[Ne];if(Ne>3){var _=Wt[Ne];W+=Zr(r,u)&(1<<_)-1,u+=_}if(u>v){l&&q(0);break}
i&&c(m+131072);var Le=m+X;if(m<W){var Ct=o-W,kt=Math.min(W,Le);for(Ct+m<0&&q(3);m<kt;++m)t[m]=n[Ct+m]}for(;m<Le;++m)t[m]=t[m-W]}}e.l=p,e.p=de,e.b=m,e.f=h,p&&(h=
1,e.m=f,e.d=y,e.n=g)}while(!h);return m!=t.length&&a?on(t,0,m):t.subarray(0,m)},fe=function(r,e,t){t<<=e&7;var n=e/8|0;r[n]|=t,r[n+1]|=t>>8},it=function(r,e,t){
t<<=e&7;var n=e/8|0;r[n]|=t,r[n+1]|=t>>8,r[n+2]|=t>>16},Jr=function(r,e){for(var t=[],n=0;n<r.length;++n)r[n]&&t.push({s:n,f:r[n]});var s=t.length,o=t.slice();if(!s)
return{t:ks,l:0};if(s==1){var a=new P(t[0].s+1);return a[t[0].s]=1,{t:a,l:1}}t.sort(function(O,L){return O.f-L.f}),t.push({s:-1,f:25001});var i=t[0],l=t[1],c=0,
h=1,u=2;for(t[0]={s:-1,f:i.f+l.f,l:i,r:l};h!=s-1;)i=t[t[c].f<t[u].f?c++:u++],l=t[c!=h&&t[c].f<t[u].f?c++:u++],t[h++]={s:-1,f:i.f+l.f,l:i,r:l};for(var m=o[0].s,n=1;n<
s;++n)o[n].s>m&&(m=o[n].s);var p=new Q(m+1),y=tn(t[h-1],p,0);if(y>e){var n=0,f=0,g=y-e,v=1<<g;for(o.sort(function(L,$){return p[$.s]-p[L.s]||L.f-$.f});n<s;++n){
var S=o[n].s;if(p[S]>e)f+=v-(1<<y-p[S]),p[S]=e;else break}for(f>>=g;f>0;){var w=o[n].s;p[w]<e?f-=1<<e-p[w]++-1:++n}for(;n>=0&&f;--n){var M=o[n].s;p[M]==e&&(--p[M],
++f)}y=e}return{t:new P(p),l:y}},tn=function(r,e,t){return r.s==-1?Math.max(tn(r.l,e,t+1),tn(r.r,e,t+1)):e[r.s]=t},bs=function(r){for(var e=r.length;e&&!r[--e];)
;for(var t=new Q(++e),n=0,s=r[0],o=1,a=function(l){t[n++]=l},i=1;i<=e;++i)if(r[i]==s&&i!=e)++o;else{if(!s&&o>2){for(;o>138;o-=138)a(32754);o>2&&(a(o>10?o-11<<5|
28690:o-3<<5|12305),o=0)}else if(o>3){for(a(s),--o;o>6;o-=6)a(8304);o>2&&(a(o-3<<5|8208),o=0)}for(;o--;)a(s);o=1,s=r[i]}return{c:t.subarray(0,n),n:e}},lt=function(r,e){
for(var t=0,n=0;n<e.length;++n)t+=r[n]*e[n];return t},Cs=function(r,e,t){var n=t.length,s=sn(e+2);r[s]=n&255,r[s+1]=n>>8,r[s+2]=r[s]^255,r[s+3]=r[s+1]^255;for(var o=0;o<
n;++o)r[s+o+4]=t[o];return(s+4+n)*8},ws=function(r,e,t,n,s,o,a,i,l,c,h){fe(e,h++,t),++s[256];for(var u=Jr(s,15),m=u.t,p=u.l,y=Jr(o,15),f=y.t,g=y.l,v=bs(m),S=v.c,
w=v.n,M=bs(f),O=M.c,L=M.n,$=new Q(19),A=0;A<S.length;++A)++$[S[A]&31];for(var A=0;A<O.length;++A)++$[O[A]&31];for(var x=Jr($,7),U=x.t,I=x.l,B=19;B>4&&!U[Xr[B-1]];--B)
;var ge=c+5<<3,Z=lt(s,we)+lt(o,ct)+a,V=lt(s,m)+lt(o,f)+a+14+3*B+lt($,U)+2*$[16]+3*$[17]+7*$[18];if(l>=0&&ge<=Z&&ge<=V)return Cs(e,h,r.subarray(l,l+c));var D,R,Y,
W;if(fe(e,h,1+(V<Z)),h+=2,V<Z){D=le(m,p,0),R=m,Y=le(f,g,0),W=f;var Je=le(U,I,0);fe(e,h,w-257),fe(e,h+5,L-1),fe(e,h+10,B-4),h+=14;for(var A=0;A<B;++A)fe(e,h+3*A,
U[Xr[A]]);h+=3*B;for(var te=[S,O],de=0;de<2;++de)for(var J=te[de],A=0;A<J.length;++A){var X=J[A]&31;fe(e,h,Je[X]),h+=U[X],X>15&&(fe(e,h,J[A]>>5&127),h+=J[A]>>12)}}else
D=pi,R=we,Y=yi,W=ct;for(var A=0;A<i;++A){var _=n[A];if(_>255){var X=_>>18&31;it(e,h,D[X+257]),h+=R[X+257],X>7&&(fe(e,h,_>>23&31),h+=Dt[X]);var ae=_&31;it(e,h,Y[ae]),
h+=W[ae],ae>3&&(it(e,h,_>>5&8191),h+=Wt[ae])}else it(e,h,D[_]),h+=R[_]}return it(e,h,D[256]),h+R[256]},wi=new nn([65540,131080,131088,131104,262176,1048704,1048832,
2114560,2117632]),ks=new P(0),xi=function(r,e,t,n,s,o){var a=o.z||r.length,i=new P(n+a+5*(1+Math.ceil(a/7e3))+s),l=i.subarray(n,i.length-s),c=o.l,h=(o.r||0)&7;if(e){
h&&(l[0]=o.r>>3);for(var u=wi[e-1],m=u>>13,p=u&8191,y=(1<<t)-1,f=o.p||new Q(32768),g=o.h||new Q(y+1),v=Math.ceil(t/3),S=2*v,w=function(Nr){return(r[Nr]^r[Nr+1]<<
v^r[Nr+2]<<S)&y},M=new nn(25e3),O=new Q(288),L=new Q(32),$=0,A=0,x=o.i||0,U=0,I=o.w||0,B=0;x+2<a;++x){var ge=w(x),Z=x&32767,V=g[ge];if(f[Z]=V,g[ge]=Z,I<=x){var D=a-
x;if(($>7e3||U>24576)&&(D>423||!c)){h=ws(r,l,0,M,O,L,A,U,B,x-B,h),U=$=A=0,B=x;for(var R=0;R<286;++R)O[R]=0;for(var R=0;R<30;++R)L[R]=0}var Y=2,W=0,Je=p,te=Z-V&32767;
if(D>2&&ge==w(x-te))for(var de=Math.min(m,D)-1,J=Math.min(32767,x),X=Math.min(258,D);te<=J&&--Je&&Z!=V;){if(r[x+Y]==r[x+Y-te]){for(var _=0;_<X&&r[x+_]==r[x+_-te];++_)
;if(_>Y){if(Y=_,W=te,_>de)break;for(var ae=Math.min(te,_-2),Ne=0,R=0;R<ae;++R){var Le=x-te+R&32767,Ct=f[Le],kt=Le-Ct&32767;kt>Ne&&(Ne=kt,V=Le)}}}Z=V,V=f[Z],te+=
Z-V&32767}if(W){M[U++]=268435456|Qr[Y]<<18|vs[W];var Xe=Qr[Y]&31,Qe=vs[W]&31;A+=Dt[Xe]+Wt[Qe],++O[257+Xe],++L[Qe],I=x+Y,++$}else M[U++]=r[x],++O[r[x]]}}for(x=Math.
max(x,I);x<a;++x)M[U++]=r[x],++O[r[x]];h=ws(r,l,c,M,O,L,A,U,B,x-B,h),c||(o.r=h&7|l[h/8|0]<<3,h-=7,o.h=g,o.p=f,o.i=x,o.w=I)}else{for(var x=o.w||0;x<a+c;x+=65535){
var Ie=x+65535;Ie>=a&&(l[h/8|0]=c,Ie=a),h=Cs(l,h+1,r.subarray(x,Ie))}o.i=a}return on(i,0,n+sn(h)+s)},Si=(function(){for(var r=new Int32Array(256),e=0;e<256;++e){
for(var t=e,n=9;--n;)t=(t&1&&-306674912)^t>>>1;r[e]=t}return r})(),Ai=function(){var r=-1;return{p:function(e){for(var t=r,n=0;n<e.length;++n)t=Si[t&255^e[n]]^t>>>
8;r=t},d:function(){return~r}}};var Mi=function(r,e,t,n,s){if(!s&&(s={l:1},e.dictionary)){var o=e.dictionary.subarray(-32768),a=new P(o.length+r.length);a.set(o),a.set(r,o.length),r=a,s.w=o.length}
return xi(r,e.level==null?6:e.level,e.mem==null?s.l?Math.ceil(Math.max(8,Math.min(13,Math.log(r.length)))*1.5):20:12+e.mem,t,n,s)},Os=function(r,e){var t={};for(var n in r)
t[n]=r[n];for(var n in e)t[n]=e[n];return t};var z=function(r,e,t){for(;t;++e)r[e]=t,t>>>=8};var Ei=function(r,e){return((r[0]&15)!=8||r[0]>>4>7||(r[0]<<8|r[1])%31)&&q(6,"invalid zlib data"),(r[1]>>5&1)==+!e&&q(6,"invalid zlib data: "+(r[1]&32?"need":"u\
nexpected")+" dictionary"),(r[1]>>3&4)+2};function Ti(r,e){return Mi(r,e||{},0,0)}function Rs(r,e){return bi(r.subarray(Ei(r,e&&e.dictionary),-4),{i:2},e&&e.out,e&&e.dictionary)}var _s=function(r,e,t,n){for(var s in r){var o=r[s],a=e+s,i=n;Array.isArray(o)&&(i=Os(n,o[1]),o=o[0]),o instanceof P?t[a]=[o,i]:(t[a+="/"]=[new P(0),i],_s(o,a,t,
n))}},xs=typeof TextEncoder<"u"&&new TextEncoder,Ci=typeof TextDecoder<"u"&&new TextDecoder,ki=0;try{Ci.decode(ks,{stream:!0}),ki=1}catch{}function Ce(r,e){if(e){for(var t=new P(r.length),n=0;n<r.length;++n)t[n]=r.charCodeAt(n);return t}if(xs)return xs.encode(r);for(var s=r.length,o=new P(r.length+
(r.length>>1)),a=0,i=function(h){o[a++]=h},n=0;n<s;++n){if(a+5>o.length){var l=new P(a+8+(s-n<<1));l.set(o),o=l}var c=r.charCodeAt(n);c<128||e?i(c):c<2048?(i(192|
c>>6),i(128|c&63)):c>55295&&c<57344?(c=65536+(c&1047552)|r.charCodeAt(++n)&1023,i(240|c>>18),i(128|c>>12&63),i(128|c>>6&63),i(128|c&63)):(i(224|c>>12),i(128|c>>
6&63),i(128|c&63))}return on(o,0,a)}var rn=function(r){var e=0;if(r)for(var t in r){var n=r[t].length;n>65535&&q(9),e+=n+4}return e},Ss=function(r,e,t,n,s,o,a,i){var l=n.length,c=t.extra,h=i&&i.length,
u=rn(c);z(r,e,a!=null?33639248:67324752),e+=4,a!=null&&(r[e++]=20,r[e++]=t.os),r[e]=20,e+=2,r[e++]=t.flag<<1|(o<0&&8),r[e++]=s&&8,r[e++]=t.compression&255,r[e++]=
t.compression>>8;var m=new Date(t.mtime==null?Date.now():t.mtime),p=m.getFullYear()-1980;if((p<0||p>119)&&q(10),z(r,e,p<<25|m.getMonth()+1<<21|m.getDate()<<16|m.
getHours()<<11|m.getMinutes()<<5|m.getSeconds()>>1),e+=4,o!=-1&&(z(r,e,t.crc),z(r,e+4,o<0?-o-2:o),z(r,e+8,t.size)),z(r,e+12,l),z(r,e+14,u),e+=16,a!=null&&(z(r,e,
h),z(r,e+6,t.attrs),z(r,e+10,a),e+=14),r.set(n,e),e+=l,u)for(var y in c){var f=c[y],g=f.length;z(r,e,+y),z(r,e+2,g),r.set(f,e+4),e+=4+g}return h&&(r.set(i,e),e+=
h),e},Oi=function(r,e,t,n,s){z(r,e,101010256),z(r,e+8,t),z(r,e+10,t),z(r,e+12,n),z(r,e+16,s)};function zt(r,e){e||(e={});var t={},n=[];_s(r,"",t,e);var s=0,o=0;for(var a in t){var i=t[a],l=i[0],c=i[1],h=c.level==0?0:8,u=Ce(a),m=u.length,p=c.comment,y=p&&
Ce(p),f=y&&y.length,g=rn(c.extra);m>65535&&q(11);var v=h?Ti(l,c):l,S=v.length,w=Ai();w.p(l),n.push(Os(c,{size:l.length,crc:w.d(),c:v,f:u,m:y,u:m!=a.length||y&&p.
length!=f,o:s,compression:h})),s+=30+m+g+S,o+=76+2*(m+g)+(f||0)+S}for(var M=new P(o+22),O=s,L=o-s,$=0;$<n.length;++$){var u=n[$];Ss(M,u.o,u,u.f,u.u,u.c.length);
var A=30+u.f.length+rn(u.extra);M.set(u.c,u.o+A),Ss(M,s,u,u.f,u.u,u.c.length,u.o,u.m),s+=16+A+(u.m?u.m.length:0)}return Oi(M,s,n.length,L,O),M}var j=(r,e=2)=>r==null?"-":r.toFixed(e);function Ps(r,e,t){return e===null||t===null?j(r):`${j(r)} (${j(e)} to ${j(t)})`}var Bt=r=>r.charAt(0).toUpperCase()+r.slice(1);function ut(r,e,t,n=!1){let s=(e-r)/Math.max(1,t),o=10**Math.floor(Math.log10(s||1)),a=[1,2,5,10].map(c=>c*o).find(
c=>c>=s)??10*o;n&&(a=Math.max(1,Math.round(a)));let i=Math.ceil(r/a-1e-9),l=Math.floor(e/a+1e-9);return Array.from({length:Math.max(0,l-i+1)},(c,h)=>(i+h)*a)}var Ri={teams:{pursuer:"pursuers",evader:"evaders"},generation:{pursuer:"pursuer generation",evader:"evader generation"},score:"capture rate",means:{pursuer:"ca\
ptures",evader:"escapes"},curves:{pursuer:"captures",evader:"escapes"},ends:["0 all escape","1 all caught"],lead:"Each cell is a match between two generations: \
the brighter, the more evaders are captured. Click one to watch it.",click:"watch its match"},_i=([r,e])=>({teams:{pursuer:r,evader:e},generation:{pursuer:`gene\
ration of ${r}`,evader:`generation of ${e}`},score:`score of the ${r}`,means:{pursuer:r,evader:e},curves:{pursuer:"scores",evader:"scores"},ends:[`0 the ${e} wi\
n`,`1 the ${r} win`],lead:`Each cell is a pair of generations: the brighter, the higher the score of the ${r}. Click one to see more of it.`,click:"see more of \
it"}),xe=({game:r})=>r?_i(r.teams):Ri,ee=(r,e,t)=>`${xe(r).teams[e]} of generation ${t}`,Pi=200;function $s(r,e,{pursuer:t,evader:n},s){let{text:o,image:a}=e.shows[`${t}\
 ${n}`]??{},i=Se(r,t,n)?.rates??[],l=`Scores of the ${e.teams[0]} in ${i.length} episodes: ${i.map(c=>j(c)).join(", ")}`;return[o===void 0?null:d("pre",{tabindex:0,
"aria-label":"What the game shows of this pair"},o),a===void 0?null:d("img",{src:a,alt:"What the game shows of this pair",onload:({target:c})=>c.classList.toggle(
"pixels",c.naturalWidth<Pi)}),...(o??a)===void 0?[d("p",{class:"muted"},e.missing),$i(r,e,t,n,s)]:[],i.length>1?d("p",{class:"small numbers"},l):null].filter(c=>c!==
null)}function $i(r,e,t,n,s){let o=Object.keys(e.shows).map(h=>h.split(" ").map(Number)),a=([h,u])=>(h-t)**2+(u-n)**2,[i,l]=o.sort((h,u)=>a(h)-a(u))[0]??[];if(i===
void 0||l===void 0)return null;let c=`${ee(r,"pursuer",i)} against ${ee(r,"evader",l)}`;return d("p",{},d("button",{type:"button",onclick:()=>s.select({pursuer:i,
evader:l})},`Nearest: ${c}`))}var Be=["pursuer","evader"];function Se(r,e,t){let[n,s]=[e-r.payoff.first[0],t-r.payoff.first[1]],o=r.payoff.capture_rate[n]?.[s];return o===void 0?null:{rate:o,rates:r.payoff.capture_rates[n][s],
lengths:r.payoff.lengths[n]?.[s]??[]}}function jt(r,e,t){let{script:n,network:s,kept:o,genomes:a}=r.teams[e];if(n!==null||s===null)return"";if(!o.includes(t))return`\
The page holds no genome of ${ee(r,e,t)}: it would be too large. Choose a generation of ${o.join(", ")}.`;let i=o.length*s.genome_size;return Is(a,s.genome_size).
length===i?"":`The page is damaged: it does not hold the ${i} numbers of the ${e}s' genomes. Write it again from its run.`}function re(r,e,t){let{script:n,network:s,
kept:o,genomes:a}=r.teams[e];if(n!==null||s===null)return n??"random";let i=o.indexOf(t);if(i<0)throw new RangeError(`${e}: expected a generation whose genome t\
he page holds, got ${t}`);let l=s.genome_size,c=Is(a,l).subarray(i*l,(i+1)*l),{hidden:h,activation:u,sampled:m,memory:p}=s;return{hidden:h,activation:u,sampled:m,
memory:p,genome:c}}function Ns(r,e,{pursuer:t,evader:n,episode:s,seed:o}){let a=e.seeds[t][n];return r.match(e.world,re(e,"pursuer",t),re(e,"evader",n),BigInt(o??
a),s)}var an=4,ln=new Map,Ls=(r,e)=>{ln.set(r,e)};function Is(r,e){let t=ln.get(r);if(t)return t;let n=new Float32Array;try{let s=Li(cn(r),e);s.every(Number.isFinite)&&
(n=s)}catch(s){if(!(s instanceof DOMException||s instanceof RangeError||Ni(s)))throw s}return ln.set(r,n),n}var Ni=r=>r instanceof Error&&"code"in r;function Li(r,e){
let t=Rs(r),n=t.length/an,s=new Uint8Array(t.length);for(let a=0;a<s.length;a++)s[a]=t[a%an*n+Math.floor(a/an)];let o=new Uint32Array(s.buffer);for(let a=e;a<o.
length;a++)o[a]^=o[a-e];return new Float32Array(s.buffer)}function cn(r){let e=atob(Ae(r)),t=new Uint8Array(e.length);for(let n=0;n<t.length;n++)t[n]=e.charCodeAt(
n);return t}var Ae=r=>document.getElementById(r)?.textContent??"";var Fs=()=>JSON.parse(Ae("data")),ht={"specialist-specialist":"Specialists: both teams meet only the newest opponent","generalist-specialist":"Pursuers meet all\
 earlier evaders, evaders only the newest pursuers","generalist-generalist":"Generalists: both teams meet all earlier opponents","hall-of-fame":"Halls of fame: \
both teams learn at once, and meet earlier champions"};function ke({schedule:r}){if(r.kind==="hall-of-fame")return r.kind;let e={latest:"specialist","round-robi\
n":"generalist",uniform:"uniform"};return`${e[r.pursuers_meet]}-${e[r.evaders_meet]}`}var Ht=r=>ht[ke(r)]??ke(r);var Gt=10,Vt=999999,un=[3,5,7,9,11],Yt=5,hn=[8,16,32,64],dn=[6,10,30,60,90,120];function Ii(r){let e=Object.values(r.races.es).find(a=>ke(a)==="generalist-gener\
alist"),{n_pursuers:t,n_evaders:n,fov:s,max_steps:o}=e.world;return{schedule:ke(e),beside:null,learner:"es",seed:e.seed,way:!1,population:0,pursuers:t,evaders:n,
view:s,steps:o,walls:[]}}var Kt=r=>Object.values(r.races.es)[0].world;function qt(r,e,t=e.schedule){let n=r.races[e.learner][t],s=Kt(r),o={...s,n_pursuers:e.pursuers,
n_evaders:e.evaders,fov:e.view,max_steps:e.steps,obstacles:e.walls.length?gs(e.walls,s.rows,s.cols):s.obstacles};return{...n,world:o,train_steps:e.steps,seed:e.
seed,policy:{...n.policy,mask:e.way?"right-of-way":"none"},learner:{...n.learner,population:e.population||n.learner.population}}}function Zt({walls:r,pursuers:e,
evaders:t},{rows:n,cols:s}){let o=new Set(Array.from({length:n*s},(i,l)=>l).filter(i=>!r.includes(i)));if(o.size<e+t)return`There is no room: ${e+t} agents need\
 a free cell each.`;let a=[Math.min(...o)];o.delete(a[0]);for(let i of a){let l=i%s,c=[i-s,i+s,...l>0?[i-1]:[],...l<s-1?[i+1]:[]];a.push(...c.filter(h=>o.delete(
h)))}return o.size?"Nobody may be walled in: all free cells have to be connected, side by side.":""}function Us(r){let{walls:e,way:t,beside:n,...s}=r,o={...s,...n?
{beside:n}:{},...t?{way:1}:{},...e.length?{walls:e.join(".")}:{}};return Object.entries(o).map(([a,i])=>`${a}=${i}`).join("&")}function Ds(r,e){let t=new URLSearchParams(
e.replace(/^#/,"")),n=Ii(r),s=(u,m)=>{let p=t.get(u)??"";return/^\d{1,6}$/.test(p)&&m(Number(p))?Number(p):n[u]},o=u=>Object.hasOwn(ht,t.get(u)??"")?t.get(u):null,
a=Kt(r),i=(t.get("walls")??"").split(".").filter(u=>/^\d{1,4}$/.test(u)).map(Number),l=s("view",u=>un.includes(u)),c=t.get("way")==="1",h={schedule:o("schedule")??
n.schedule,beside:o("beside"),learner:t.get("learner")==="ga"?"ga":n.learner,seed:s("seed",u=>u<=Vt),pursuers:s("pursuers",u=>u>=1&&u<=Gt),evaders:s("evaders",u=>u>=
1&&u<=Gt),view:c?Math.max(Yt,l):l,way:c,population:s("population",u=>hn.includes(u)),steps:s("steps",u=>dn.includes(u)),walls:i.filter(u=>u<a.rows*a.cols).reduce(
(u,m)=>Ut(u,m,!0),[])};return Zt(h,a)?{...h,walls:[]}:h}function ce(r,e,t,n=""){return d("label",{class:`field ${n}`,title:e},d("span",{class:"field-name"},r),t,d("span",{class:"about small muted"},e))}function Ws(r){
let e=Object.entries(ht),t=se(e,f=>r({schedule:f})),n=se([["","Nothing"],...e],f=>r({beside:f||null},!0)),s=Array.from({length:Gt},(f,g)=>[g+1,String(g+1)]),o=se(
s,f=>r({pursuers:Number(f)})),a=se(s,f=>r({evaders:Number(f)})),i=se(un.map(f=>[f,`${f} x ${f}`]),f=>r({view:Number(f),...Number(f)<Yt?{way:!1}:{}})),l=d("input",
{type:"checkbox",onchange:()=>r({way:l.checked,...l.checked?{view:Math.max(Yt,Number(i.value))}:{}})}),c=se([[0,"usual"],...hn.map(f=>[f,String(f)])],f=>r({population:Number(
f)})),h=se(dn.map(f=>[f,String(f)]),f=>r({steps:Number(f)})),u=se([["es","evolution strategy"],["ga","genetic algorithm"]],f=>r({learner:f},!0)),m=d("input",{type:"\
number",min:0,max:Vt,step:1,inputmode:"numeric"});m.addEventListener("change",()=>r({seed:Math.min(Vt,Math.max(0,Math.round(Number(m.value))||0))},!0));let p=d(
"button",{type:"button",onclick:()=>r({seed:Math.floor(Math.random()*1e3)},!0)},"Another seed"),y=(f,...g)=>d("section",{class:"card controls","aria-label":f},d(
"fieldset",{},d("legend",{},f),...g));return{now:y("Change it while it evolves",ce("Opponents","whom the teams meet while they learn",t,"wide"),ce("Pursuers","t\
riangles",o),ce("Evaders","discs",a),ce("View","cells that an agent sees around itself",i),ce("Right of way","agents never take a move that could put them at fa\
ult",d("span",{},l)),ce("Population","candidates that are compared at a time",c),ce("Steps","of a match",h)),anew:y("Begin anew",ce("Side by side with","a secon\
d race of the same seed",n,"wide"),ce("Learner","how a team learns",u,"half"),ce("Seed","the luck of the race",d("span",{class:"seed"},m,p),"half")),show:f=>{[t.
value,n.value,i.value,u.value]=[f.schedule,f.beside??"",String(f.view),f.learner],[c.value,h.value,m.value,l.checked]=[String(f.population),String(f.steps),String(
f.seed),f.way],[o.value,a.value]=[String(f.pursuers),String(f.evaders)]}}}var Jt={left:46,right:12,top:10,bottom:42},zs={x:56,y:34};function js(r,e,t,n){let[s,o]=[Jt.left,Jt.top],a=Math.max(s+40,r-Jt.right),i=Math.max(o+40,e-Jt.bottom),
l=(f,g,v)=>S=>g+(S-f.low)/(f.high-f.low||1)*(v-g),[c,h]=[l(t,s,a),l(n,i,o)],u=b("g"),m=b("svg",{width:r,height:e,viewBox:`0 0 ${r} ${e}`,class:"plot"}),p=b("g",
{class:"axes"});for(let f of ut(n.low,n.high,(i-o)/zs.y,n.whole))p.append(b("line",{x1:s,x2:a,y1:h(f),y2:h(f),class:"grid"}),b("text",{x:s-8,y:h(f),"text-anchor":"\
end","dominant-baseline":"middle"},Bs(f)));for(let f of ut(t.low,t.high,(a-s)/zs.x,t.whole))p.append(b("text",{x:c(f),y:i+16,"text-anchor":"middle"},Bs(f)));return p.
append(b("line",{x1:s,x2:a,y1:i,y2:i,class:"axis"}),b("text",{x:(s+a)/2,y:e-6,"text-anchor":"middle",class:"label"},t.label),b("text",{transform:`translate(12 ${(o+
i)/2}) rotate(-90)`,"text-anchor":"middle",class:"label"},n.label)),m.append(p,u),{root:m,marks:u,left:s,right:a,top:o,bottom:i,x:c,y:h,at:f=>{let g=f-m.getBoundingClientRect().
left;return t.low+(g-s)/(a-s)*(t.high-t.low)}}}var Bs=r=>String(Number(r.toPrecision(6))).replace("-","−");function Hs(r,e,t,n){let s="",o="M";t.forEach((a,i)=>{
a===null?o="M":(s+=`${o}${r.x(e[i]).toFixed(1)} ${r.y(a).toFixed(1)}`,o="L")}),r.root.insertBefore(b("path",{d:s,class:`line ${n}`}),r.marks)}function Gs(...r){return d("p",{class:"legend small"},...r.map(([e,t])=>d("span",{class:`key ${t}`},e)))}function Vs(r,e,t,n){let s=d("div",{class:"chart choose\
s",role:"img","aria-label":r}),o=null,a=()=>{o?.marks.replaceChildren(),o&&t(o)};s.addEventListener("click",l=>o&&n(o.at(l.clientX),o,l));let i=()=>{let{clientWidth:l,
clientHeight:c}=s;l<50||c<50||(o=e(l,c),s.replaceChildren(o.root),a())};return new ResizeObserver(i).observe(s),{element:s,update:a,redraw:i}}var je=[[0,0],[-1,0],[0,1],[1,0],[0,-1],[-1,1],[1,1],[1,-1],[-1,-1]];function Ys(r,e,t){let[n,s]=[e[0]-r[0],e[1]-r[1]];return!t&&Math.abs(n)>Math.abs(s)?s=0:t||
(n=0),je.findIndex(([o,a])=>o===Math.sign(n)&&a===Math.sign(s))}var Oe=(r,e)=>e<r.nPursuers,k=(r,e)=>[r.positions[2*e],r.positions[2*e+1]],mn=({rows:r,cols:e},[
t,n])=>t>=0&&n>=0&&t<r&&n<e,pn=(r,e,t=3)=>r!==void 0&&[0,1,2].slice(0,t).some(n=>r[3*e+n]),fn=(r,e)=>pn(r.fault,e),Ks=(r,e)=>!fn(r,e)&&pn(r.involved,e,2);function Xt(r,e,t){
let[n,s]=[k(r,t),k(e,t)],o=n[0]!==s[0]||n[1]!==s[1],a=e.involved===void 0||pn(e.involved,t);return!!(e.alive[t]&&e.actions?.[t]&&!o&&a)}function Qt(r,e,t){let[n,
s]=k(r,t),[o,a]=je[e.actions?.[t]??0];return[n+o,s+a]}function dt(r,e,t){return Array.from({length:t.everCaptured.length},(s,o)=>o).filter(s=>t.everCaptured[s]&&
!e.everCaptured[s]).map(s=>r.nPursuers+s)}var er=r=>r.moments.flatMap((e,t)=>t&&dt(r,r.moments[t-1],e).length?[t]:[]);function tr(r,e){return Array.from({length:e.
alive.length},(n,s)=>s).filter(n=>r.alive[n]&&!e.alive[n])}var qs=[-.31,0,.31],Zs=[{size:1,at:[[0,0]]},{size:.62,at:[[-.2,.2],[.2,-.2]]},{size:.54,at:[[-.23,.22],[.23,.22],[0,-.22]]},{size:.54,at:[[-.23,.23],[.23,.23],[
-.23,-.23],[.23,-.23]]},{size:.36,at:qs.flatMap(r=>qs.map(e=>[e,r]))}],Fi=.3,Ui=.35,Di=.55;function mt(r,e){let t=new Map;for(let n=0;n<e.alive.length;n++){if(!e.
alive[n])continue;let[s,o]=k(e,n),a=s*r.cols+o,i=t.get(a);i?i.push(n):t.set(a,[n])}return t}function Js(r,e){let t=Array.from(e.alive,(n,s)=>{let[o,a]=k(e,s);return{
x:a+.5,y:o+.5,size:1,alpha:0}});for(let n of mt(r,e).values()){let s=Zs[Math.min(n.length,Zs.length)-1];n.forEach((o,a)=>{let[i,l]=s.at[Math.min(a,s.at.length-1)],
c=t[o];c.x+=i,c.y+=l,c.size=s.size,c.alpha=1})}return t}var Xs=r=>r*r*(3-2*r),He=(r,e,t)=>r+(e-r)*t,Qs=r=>Math.min(1,Math.max(0,r));function eo(r,e,t,n){let s={
SIMULTANEOUS:1,SWARM_TURNS:2,AGENT_TURNS:t}[r.interaction];if(s===1)return Xs(n);let o=s===t?e:+!Oe(r,e),a=Math.max(1/s,Ui);return Xs(Qs((n-o/(s-1)*(1-a))/a))}function rr(r,e){
let t=r.moments.length-1,n=Math.min(Math.floor(e),t),s=r.moments[n],o=Js(r,s);if(n===t||e===n)return o;let a=r.moments[n+1],i=Js(r,a);return o.map((l,c)=>{let h=eo(
r,c,o.length,e-n);return Wi(s,a,c,l,i[c],h)})}function yn(r,e,t){let n=r.moments.length-1,s=Math.min(Math.floor(t),n),[o,a]=[r.moments[s],r.moments[Math.min(s+1,
n)]],i=eo(r,e,o.alive.length,t-s),[[l,c],[h,u]]=[k(o,e),k(a,e)];return[He(c,u,i)+.5,He(l,h,i)+.5]}function Wi(r,e,t,n,s,o){let a=n.alpha>s.alpha,i={x:He(n.x,s.x,
o),y:He(n.y,s.y,o),size:a?n.size:He(n.size,s.size,o),alpha:a?Qs((1-o)/(1-Di)):He(n.alpha,s.alpha,o)};if(Xt(r,e,t)){let[l,c]=k(r,t),[h,u]=Qt(r,e,t),m=Fi*Math.sin(
Math.PI*o);i.x+=(u-c)*m,i.y+=(h-l)*m}return i}var to=2*Math.PI;function Re(r,e,t,n){r.beginPath(),r.arc(e,t,n/2,0,to)}function nr(r,e,t,n){let s=n/2,o=[[0,-.97],[.97,.83],[-.97,.83]].map(([a,i])=>[e+a*s,t+i*
s]);r.beginPath(),r.moveTo((o[2][0]+o[0][0])/2,(o[2][1]+o[0][1])/2),o.forEach(([a,i],l)=>{let[c,h]=o[(l+1)%3];r.arcTo(a,i,c,h,n*.09)}),r.closePath()}function ro(r,e,t,n){
let s=n*.32;r.beginPath(),r.moveTo(e-s,t-s),r.lineTo(e+s,t+s),r.moveTo(e+s,t-s),r.lineTo(e-s,t+s)}function no(r,e,t,n){r.beginPath();for(let s=0;s<16;s++){let o=n/
2*(s%2?.6:.95),a=to*s/16;r.lineTo(e+o*Math.sin(a),t-o*Math.cos(a))}r.closePath()}function so(r,e,t,n,s,o){let a=Math.atan2(s-t,n-e);r.beginPath(),r.moveTo(e,t),
r.lineTo(n,s);for(let i of[-1,1])r.moveTo(n,s),r.lineTo(n-o*Math.cos(a+i*.6),s-o*Math.sin(a+i*.6))}var oo=4,zi=1.6,Bi=.95,ji=5,Hi=.16,Gi=9,Vi=.09,Yi=.2,ao=.75,H=(r,e)=>r.left+e*r.cell,G=(r,e)=>r.top+e*r.cell;function Ge(r,e,t){return Oe(e,t)?r.colors.pursuer:
r.colors.evader}function sr({ctx:r,colors:e},t,n,s,o,a,i=0){r.font=`700 ${Math.round(o)}px system-ui, sans-serif`,r.textAlign="center",r.textBaseline="middle",r.
strokeStyle=e.paper,r.lineWidth=i,i&&r.strokeText(t,n,s),r.fillStyle=a,r.fillText(t,n,s)}function io({ctx:r,grid:e,colors:t}){let{left:n,top:s,cell:o,rows:a,cols:i}=e,
[l,c]=[i*o,a*o];if(r.fillStyle=t.paper,r.fillRect(n,s,l,c),o<ji)return;r.fillStyle=t.line;let h=Math.max(1,Math.round(o/60));for(let u=1;u<i;u++)r.fillRect(n+u*
o,s,h,c);for(let u=1;u<a;u++)r.fillRect(n,s+u*o,l,h)}function lo({ctx:r,grid:e,colors:t},n){let{left:s,top:o,cell:a,rows:i,cols:l}=e;r.fillStyle=t.obstacle;for(let c=0;c<
i*l;c++){if(!n.obstacles[c])continue;let[h,u]=[Math.floor(c/l),c%l];r.fillRect(s+u*a,o+h*a,a,a)}co({ctx:r,grid:e,colors:t})}function co({ctx:r,grid:{left:e,top:t,
cell:n,rows:s,cols:o},colors:a}){let i=Math.min(5,Math.max(2,Math.round(n/18)));r.strokeStyle=a.frame,r.lineWidth=i,r.strokeRect(e-i/2,t-i/2,o*n+i,s*n+i)}function uo({
ctx:r,grid:e,colors:t},n){let{left:s,top:o,cell:a,rows:i,cols:l}=e,c=a<24*n?5:1;r.font=`500 ${Math.round(Math.min(15*n,Math.max(9*n,a*.32)))}px system-ui, sans-\
serif`,r.fillStyle=t.muted,r.textBaseline="alphabetic",r.textAlign="center";let h=5*n+a/40;for(let u=0;u<l;u+=c)r.fillText(String(u),s+(u+.5)*a,o-h);r.textAlign=
"right",r.textBaseline="middle";for(let u=0;u<i;u+=c)r.fillText(String(u),s-h,o+(u+.5)*a)}function ho({grid:r},e,t,n){let s=Math.floor(e.fov/2)+.5,[o,a]=[Math.max(
0,t-s),Math.min(r.cols,t+s)],[i,l]=[Math.max(0,n-s),Math.min(r.rows,n+s)];return[H(r,o),G(r,i),(a-o)*r.cell,(l-i)*r.cell]}function mo(r,e,t,n){let{ctx:s,grid:o,
colors:a}=r;s.save(),s.beginPath(),s.rect(0,0,s.canvas.width,s.canvas.height),s.rect(...ho(r,e,t,n)),s.clip("evenodd"),s.clearRect(0,0,s.canvas.width,s.canvas.height),
s.fillStyle=a.line,s.fillRect(o.left,o.top,o.cols*o.cell,o.rows*o.cell),s.restore(),co(r)}function po(r,{x:e,y:t,alpha:n},s){let{ctx:o,grid:a,colors:i}=r,l=Math.
max(a.cell,16*s)*1.06,[c,h]=[H(a,e),G(a,t)];o.globalAlpha=Math.max(n,.6),o.beginPath(),o.roundRect(c-l/2,h-l/2,l,l,l*.2),o.strokeStyle=i.focus,o.lineWidth=Math.
max(2,2.5*s),o.stroke();let u=Math.max(11*s,Math.min(18*s,a.cell*.5)),m=h-l/2<u*1.2,p=h+(m?1:-1)*(l/2+u*.7);o.lineJoin="round",sr(r,"You",c,p,u,i.ink,u*.35),o.globalAlpha=
1}function fo(r,e,t,n,s){let{ctx:o,grid:a}=r,i=ho(r,e,n,s),l=Ge(r,e,t);o.globalAlpha=.11,o.fillStyle=l,o.fillRect(...i),o.globalAlpha=.8,o.strokeStyle=l,o.lineWidth=
Math.max(1,a.cell/24),o.strokeRect(...i),o.globalAlpha=1}function yo(r,e,t,n,s){let{ctx:o,grid:a}=r,i=Math.min(Math.ceil(t),e.moments.length-1),l=e.moments[i];o.
lineCap="round",o.lineWidth=Math.min(Gi,Math.max(1,a.cell*Hi));for(let c=Math.max(1,Math.floor(t-n)+1);c<=i;c++){let[h,u]=[e.moments[c-1],e.moments[c]],m=Math.max(
0,Math.min(1,(t-c)/n));o.globalAlpha=ao+(Yi-ao)*m;for(let p=0;p<u.alive.length;p++){let y=c===i&&t<i;if(!h.alive[p]||!(l.alive[p]||y))continue;let f=(Oe(e,p)?-1:
1)*Vi,[g,v]=k(h,p),[S,w]=k(u,p);if(g===S&&v===w)continue;let M=y?s[p].x:w+.5,O=y?s[p].y:S+.5;o.strokeStyle=Ge(r,e,p),o.beginPath(),o.moveTo(H(a,v+.5+f),G(a,g+.5+
f)),o.lineTo(H(a,M+f),G(a,O+f)),o.stroke()}}o.globalAlpha=1}function go(r,e,t){let n=Math.min(Math.ceil(t),e.moments.length-1);for(let s=Math.max(1,n-oo+1);s<=n;s++){
let[o,a]=[e.moments[s-1],e.moments[s]],i=s>t?Math.max(0,1-2*(s-t)):1-(t-s)/oo,l=dt(e,o,a);for(let c of tr(o,a))l.includes(c)||qi(r,k(a,c),i);for(let c of l)Ki(r,
k(a,c),i)}r.ctx.globalAlpha=1}function Ki({ctx:r,grid:e,colors:t},[n,s],o){r.globalAlpha=o,no(r,H(e,s+.5),G(e,n+.5),Math.max(8,e.cell*zi)),r.fillStyle=t.capture,
r.fill(),r.strokeStyle=t.ink,r.lineWidth=Math.max(1,e.cell/36),r.lineJoin="round",r.stroke()}function qi({ctx:r,grid:e,colors:t},[n,s],o){r.globalAlpha=o,ro(r,H(
e,s+.5),G(e,n+.5),Math.max(7,e.cell*Bi)),r.strokeStyle=t.collision,r.lineWidth=Math.max(2,e.cell*.17),r.lineCap="round",r.stroke()}function vo({ctx:r,grid:e,colors:t},n,s){
let o=Math.max(1,e.cell*.07);r.strokeStyle=r.fillStyle=t.collision,r.lineWidth=Math.max(1,e.cell*.05),r.setLineDash([e.cell*.14,e.cell*.1]);for(let[a,i]of n){if(a<
0||i<0||a>=e.rows||i>=e.cols)continue;let l=[H(e,i)+o,G(e,a)+o,e.cell-2*o,e.cell-2*o];r.globalAlpha=.2*s,r.fillRect(...l),r.globalAlpha=s,r.strokeRect(...l)}r.setLineDash(
[]),r.globalAlpha=1}function bo({ctx:r,grid:e,colors:t},n,s,o,a){r.globalAlpha=a,Re(r,H(e,n),G(e,s),Math.max(8,e.cell*o*1.02)),r.strokeStyle=t.collision,r.lineWidth=
Math.max(1.5,e.cell*.085*Math.sqrt(o)),r.stroke(),r.globalAlpha=1}var Zi=.8,Ji=.92,Xi=15,Qi=7,gn=9;function wo(r,e,t,n,s,o){n.forEach((a,i)=>{a.alpha>0&&el(r,e,t,i,a,s,o)}),r.ctx.globalAlpha=1;for(let a of mt(e,t).values())a.length>
gn&&tl(r,n[a[gn-1]],a.length-gn+1)}function el(r,e,t,n,s,o,a){let{ctx:i,grid:l,colors:c}=r,h=Oe(e,n),[u,m]=[H(l,s.x),G(l,s.y)],p=Math.max(4,l.cell*s.size*(h?Ji:
Zi)),y=Ge(r,e,n),f=!h&&!!t.captured[n-e.nPursuers];if(i.globalAlpha=s.alpha,(h?nr:Re)(i,u,m,p),p>Qi*a&&(i.strokeStyle=c.paper,i.lineWidth=Math.max(2,p*.1),i.stroke()),
i.fillStyle=f?c.paper:y,i.fill(),f&&(Re(i,u,m,p*.82),i.strokeStyle=y,i.lineWidth=p*.18,i.stroke()),!o||p<Xi*a)return;let g=String(h?n:n-e.nPursuers),v=p*(h?.4:.5)*
(g.length>1?.8:1);sr(r,g,u,m+p*(h?.17:.03),v,f?y:c.paper)}function tl(r,e,t){let{cell:n}=r.grid;sr(r,`+${t}`,H(r.grid,e.x),G(r.grid,e.y),n*.3,r.colors.ink,n*.1)}var rl=.46,nl=.86,sl=.66,xo=.48,ol=.78,al=.58;function So(r,e,t,n){let[s,o]=[e.moments[t-1],e.moments[t]];if(!s)return;let{ctx:a,grid:i,colors:l}=r;a.strokeStyle=
l.collision,a.lineWidth=Math.max(1.5,i.cell*.07),a.lineCap="butt",a.globalAlpha=n;for(let c=0;c<o.alive.length;c++)Xt(s,o,c)&&il(r,e,k(s,c),Qt(s,o,c));a.globalAlpha=
1}function il({ctx:r,grid:e},t,n,s){let[o,a]=[s[1]-n[1],s[0]-n[0]],i=u=>H(e,n[1]+.5+o*u),l=u=>G(e,n[0]+.5+a*u),c=mn(t,s)?ol:al;r.setLineDash([e.cell*.09,e.cell*
.06]),r.beginPath(),r.moveTo(i(xo),l(xo)),r.lineTo(i(c),l(c)),r.stroke(),r.setLineDash([]);let h=.17*e.cell/Math.hypot(o,a);r.beginPath(),r.moveTo(i(c)-a*h,l(c)+
o*h),r.lineTo(i(c)+a*h,l(c)-o*h),r.stroke()}function Ao(r,e,t,n,s,o){let a=je[o];if(!o||!a)return;let{ctx:i,grid:l,colors:c}=r,h=mn(e,[n[0]+a[0],n[1]+a[1]])?nl:
sl,u=rl*s.size,m=[H(l,s.x+a[1]*u),G(l,s.y+a[0]*u),H(l,s.x+a[1]*h),G(l,s.y+a[0]*h)],p=Math.max(1.5,l.cell*.085);i.lineCap=i.lineJoin="round";for(let[y,f]of[[c.paper,
p*2.1],[Ge(r,e,t),p]])i.strokeStyle=y,i.lineWidth=f,so(i,...m,l.cell*.2),i.stroke()}var Eo={numbers:!0,axes:!1,trail:6,viewers:[],plan:null,selected:null,cursor:null,you:null,fog:!1};function To(r,e,t,n,s){let{ctx:o,grid:a,colors:i}=r,l=Math.min(
Math.ceil(t),e.moments.length-1),c=e.moments[l],h=t===l,u=rr(e,t),m=h?1:Math.max(0,1-2*(l-t));o.clearRect(0,0,o.canvas.width,o.canvas.height),io(r);for(let f of n.
viewers)u[f]?.alpha&&fo(r,e,f,...yn(e,f,t));lo(r,e),n.axes&&uo(r,s),yo(r,e,t,n.trail,u),vo(r,c.contested??[],m),go(r,e,t),So(r,e,l,m),u.forEach(({x:f,y:g,size:v},S)=>{
let w=Ks(c,S)?.4:0,M=fn(c,S)?1:w;M&&bo(r,f,g,v,M*m)});let p=h?c:e.moments[Math.max(0,l-1)];if(wo(r,e,p,u,n.numbers,s),h&&n.plan)for(let[f,g]of u.entries())g.alpha&&
Ao(r,e,f,k(c,f),g,n.plan[f]??0);n.you!==null&&(n.fog&&mo(r,e,...yn(e,n.you,t)),po(r,u[n.you],s)),o.lineWidth=Math.max(2,2.5*s),o.strokeStyle=i.focus;let y=n.selected===
null?void 0:u[n.selected];y?.alpha&&Mo(r,y.x,y.y,y.size*.96),n.cursor&&(o.setLineDash([a.cell*.12,a.cell*.08]),Mo(r,n.cursor[1]+.5,n.cursor[0]+.5,.8),o.setLineDash(
[]))}function Mo({ctx:r,grid:e},t,n,s){let o=s*e.cell;r.beginPath(),r.roundRect(e.left+t*e.cell-o/2,e.top+n*e.cell-o/2,o,o,o*.1),r.stroke()}var Co=(r,e)=>(e+.24)/(r+.24);function ko(r,e,t,n,s,o){let a=t?28*o:0,i=(c,h)=>(c-a)/(h+2*.12),l=Math.max(1,Math.floor(Math.min(i(n,e),i(s,r))));return{rows:r,cols:e,
cell:l,left:Math.round((n-e*l+a)/2),top:Math.round((s-r*l+a)/2)}}function Oo(r,e,t){let n=Math.floor((t-r.top)/r.cell),s=Math.floor((e-r.left)/r.cell);return n>=
0&&n<r.rows&&s>=0&&s<r.cols?[n,s]:null}var ll=["paper","line","frame","ink","muted","obstacle"],cl=["pursuer","evader","capture","collision","focus"];function or(r){let e=getComputedStyle(r),t=(n,s)=>[
n,e.getPropertyValue(s+n).trim()];return Object.fromEntries([...ll.map(n=>t(n,"--board-")),...cl.map(n=>t(n,"--"))])}var ye=()=>matchMedia("(prefers-reduced-motion: reduce)").matches,Me=class{canvas;#e=null;#r=0;#t;#n={rows:1,cols:1,left:0,top:0,cell:1};#a=0;constructor(e,t={}){
this.canvas=e,e.classList.add("board"),e.setAttribute("role","img"),this.#t={...Eo,...t},new ResizeObserver(()=>this.#u()).observe(e),new MutationObserver(()=>this.
redraw()).observe(document.documentElement,{attributes:!0}),addEventListener("beforeprint",()=>this.drawNow())}set look(e){this.#t={...this.#t,...e},this.#s(),this.
redraw()}show(e,t){this.#e=e,this.#r=Math.min(Math.max(0,t),e.moments.length-1),this.#s(),this.redraw()}redraw(){this.#a||(this.#a=requestAnimationFrame(()=>this.
drawNow()))}drawNow(){cancelAnimationFrame(this.#a),this.#a=0;let e=this.canvas.getContext("2d");if(!e||!this.#e)return;let{rows:t,cols:n}=this.#e,s=devicePixelRatio||
1;this.#n=ko(t,n,this.#t.axes,this.canvas.width,this.canvas.height,s);let o={ctx:e,grid:this.#n,colors:or(this.canvas)};To(o,this.#e,this.#r,this.#t,s)}cellAt(e,t){
let n=this.canvas.getBoundingClientRect(),s=this.canvas.width/n.width;return Oo(this.#n,(e-n.left)*s,(t-n.top)*s)}agentAt(e,t){let n=this.cellAt(e,t);if(!n||!this.#e)
return null;let s=this.#e.moments[Math.round(this.#r)],o=mt(this.#e,s).get(n[0]*this.#e.cols+n[1])??[],a=rr(this.#e,Math.round(this.#r)),i=l=>{let[c,h]=this.pointOf(
a[l].x,a[l].y);return Math.hypot(c-e,h-t)};return o.length?o.reduce((l,c)=>i(c)<i(l)?c:l):null}pointOf(e,t){let n=this.canvas.getBoundingClientRect(),s=n.width/
this.canvas.width,{left:o,top:a,cell:i}=this.#n;return[n.left+(o+e*i)*s,n.top+(a+t*i)*s]}#s(){if(!this.#e)return;let{rows:e,cols:t}=this.#e;this.canvas.style.setProperty(
"--board-aspect",String(Co(e,t)))}#u(){let e=devicePixelRatio||1,{width:t,height:n}=this.canvas.getBoundingClientRect();this.canvas.width=Math.max(1,Math.round(
t*e)),this.canvas.height=Math.max(1,Math.round(n*e)),this.drawNow()}};function vn(r,e,t){let{rows:n,cols:s,n_pursuers:o,fov:a,rules:{interaction:i}}=r;return{rows:n,cols:s,nPursuers:o,fov:a,interaction:i,obstacles:e,moments:t}}function bn(r,e){
return{positions:r.read("last_positions"),alive:r.read("alive"),captured:r.read("captured"),everCaptured:r.read("ever_captured"),actions:e,involved:r.read("invo\
lved"),fault:r.read("fault"),contested:r.conflicts().map(t=>t.cell)}}function ar(r){let e=Array.from({length:r.length+1},(t,n)=>ul(r,n));return vn(r.config,r.map,
e)}function ul(r,e){let t=r.n_agents,n=r.config.n_evaders,s=(a,i,l)=>a.subarray(i*l,(i+1)*l),o={positions:s(r.last_positions,e,2*t),alive:s(r.alive,e,t),captured:s(
r.captured,e,n),everCaptured:s(r.ever_captured,e,n)};return e===0?o:{...o,actions:s(r.actions,e-1,t),involved:s(r.involved,e-1,3*t),fault:s(r.fault,e-1,3*t),get contested(){
return r.conflicts(e).map(a=>a.cell)}}}var pt=[.5,1,2,4,8,16,32,64],ir=0,lr=12,hl=2,Ee=class extends EventTarget{#e;#r;#t;#n=0;#a=0;#s=!1;#u=null;#m=0;#i=[];#d=[];glide=.28;constructor(e,{speed:t=4,still:n=!1}={}){
super(),[this.#e,this.#r,this.#t]=[e,t,n]}get step(){return this.#n}get time(){return this.#t?this.#n:this.#a}get arrived(){return this.#a===this.#n}get playing(){
return this.#s}get length(){return this.#e}set length(e){this.#e=e,this.#n>e&&this.jump(e),this.#o("state")}get marks(){return this.#i}set marks(e){this.#i=e,this.#o(
"state")}get ticks(){return this.#d}set ticks(e){this.#d=e,this.#o("state")}get pace(){return this.#r||Math.max(hl,this.#e/lr)}get speed(){return this.#r}set speed(e){
this.#r=e,this.#o("state")}changeSpeed(e){let t=pt.findIndex(n=>n>=this.pace);this.speed=pt[Math.min(pt.length-1,Math.max(0,t+e))]}play(){this.#s||!this.#e||(this.#n===
this.#e&&this.jump(0),this.#s=!0,this.#o("state"),this.#l())}pause(){this.#s&&(this.#s=!1,this.#o("state"))}toggle(){this.#s?this.pause():this.play()}move(e){this.
pause();let t=Math.min(this.#e,Math.max(0,this.#n+e));Math.abs(t-this.#a)>1?this.jump(t):this.#h(t),this.#l()}jump(e){this.#a=Math.min(this.#e,Math.max(0,Math.round(
e))),this.#h(this.#a),this.#o("frame")}#h(e){e!==this.#n&&(this.#n=e,this.#o("step"),this.#t&&this.#o("frame"))}#l(){this.#u===null&&(this.#m=performance.now(),
this.#u=requestAnimationFrame(()=>this.#c()))}#c(){this.#u=null;let e=performance.now();this.#p(Math.min(.25,(e-this.#m)/1e3)),this.#m=e,(!this.#t||this.arrived)&&
this.#o("frame"),(this.#s||this.#a!==this.#n)&&(this.#u=requestAnimationFrame(()=>this.#c()))}#p(e){let t=e;for(;t>0;){if(this.#a===this.#n){if(!this.#s)return;
if(this.#n===this.#e)return this.pause();this.#h(this.#n+1)}let n=this.#s?this.pace:1/this.glide,s=this.#n-this.#a,o=Math.min(Math.abs(s),t*n);t-=o/n,this.#a=o===
Math.abs(s)?this.#n:this.#a+Math.sign(s)*o}this.#s&&this.#a===this.#e&&this.pause()}#o(e){this.dispatchEvent(new Event(e))}};function cr(r,e){if(e.ctrlKey||e.metaKey||
e.altKey)return!1;let t=e.shiftKey?10:1,s={" ":()=>r.toggle(),ArrowRight:()=>r.move(t),ArrowLeft:()=>r.move(-t),Home:()=>r.move(-r.length),End:()=>r.move(r.length),
"+":()=>r.changeSpeed(1),"-":()=>r.changeSpeed(-1)}[e.key];return s?.(),s!==void 0}var dl={first:"M6 5v14M19 5 9 12l10 7z",back:"M17 5 7 12l10 7z",play:"M7 4.5 19 12 7 19.5z",pause:"M8 5v14M16 5v14",forward:"M7 5l10 7-10 7z",last:"M18 5v14M5 5\
l10 7-10 7z"};function Ro(r){return b("svg",{viewBox:"0 0 24 24","aria-hidden":"true",class:"icon"},b("path",{d:dl[r]}))}function ft(r,e,t,n){return d("button",
{type:"button",class:"player-button","aria-label":e,title:`${e} (${t})`,onclick:n},Ro(r))}function ur(r){let e=ft("play","Play","Space",()=>r.toggle()),t=d("inp\
ut",{type:"range",class:"player-scrub",min:0,step:1,"aria-label":"Step",oninput:()=>{r.pause(),r.jump(Number(t.value))}}),n=d("div",{class:"captures","aria-hidd\
en":"true",title:"Captures"}),s=d("div",{class:"losses","aria-hidden":"true"}),o=d("select",{class:"player-speed","aria-label":"Speed",title:`Steps a second, or\
 the whole in ${lr} s (+ and -)`,onchange:()=>r.speed=Number(o.value)},d("option",{value:ir},`in ${lr} s`),...pt.map(u=>d("option",{value:u},`${u} / s`))),a=d("\
output",{class:"player-count"}),i=d("div",{class:"player",role:"group","aria-label":"Player"},ft("first","First step","Home",()=>r.move(-r.length)),ft("back","S\
tep back","←",()=>r.move(-1)),e,ft("forward","Step forward","→",()=>r.move(1)),ft("last","Last step","End",()=>r.move(r.length)),d("div",{class:"scrub"},n,s,
t),a,o),l=(u,m={})=>{let p=d("i",m);return p.style.left=`${100*u/Math.max(1,r.length)}%`,p},c=()=>{n.replaceChildren(...r.marks.map(u=>l(u))),s.replaceChildren(
...r.ticks.map(({step:u,kind:m,size:p,text:y})=>{let f=l(u,{class:m,title:`Step ${u}: ${y}`});return f.style.height=`${100*p}%`,f}))},h=()=>{e.replaceChildren(Ro(
r.playing?"pause":"play")),e.ariaLabel=r.playing?"Pause":"Play",e.title=`${e.ariaLabel} (Space)`,t.max=String(r.length),t.value=String(r.step),t.ariaValueText=`\
step ${r.step} of ${r.length}`,a.textContent=`${r.step} / ${r.length}`,a.style.minWidth=`${2*String(r.length).length+3}ch`,o.value=String(r.speed)};return r.addEventListener(
"step",h),r.addEventListener("state",h),r.addEventListener("state",c),i.addEventListener("keydown",u=>{!(u.target instanceof HTMLSelectElement||u.key===" "&&u.target!==
t)&&cr(r,u)&&u.preventDefault()}),h(),i}var ml=40,hr=class{element;#e;#r=d("div",{class:"episodes",role:"group","aria-label":"Episodes of this cell"});#t=d("p",{class:"check small numbers","aria-live":"\
polite"});constructor(e){this.#e=e,this.element=d("div",{class:"strip-of-episodes"},this.#r,this.#t)}show(e,t){let{pursuer:n,evader:s,episode:o,seed:a}=this.#e.
selected,i=Se(e,n,s);this.#r.replaceChildren(...(i?.rates??[]).slice(0,ml).map((m,p)=>this.#n(m,p)));let l=a===null?i?.rates[o]:void 0,c=t.statistics.capture_rate,
h=l!==void 0&&Math.abs(c-l)<1e-6&&t.length===i?.lengths[o],u=i?"Not an episode of the evaluation":"The evaluation played no episodes of this pair.";this.#t.dataset.
equal=String(h),this.#t.textContent=h?"As in the evaluation":l===void 0?u:`Episode ${o+1} differs from the evaluation.`,this.#t.title=`Played here: capture rate\
 ${j(c,3)} in ${t.length} steps.${i?` The cell says ${j(i.rate,3)}.`:""}`}#n(e,t){let{selected:n}=this.#e,s=d("span",{class:"bar"});return s.style.height=`${Math.
round(100*e)}%`,d("button",{type:"button",class:"episode",title:`Episode ${t+1}: capture rate ${j(e)}`,"aria-label":`Episode ${t+1}, capture rate ${j(e)}`,"aria\
-pressed":String(t===n.episode&&n.seed===null),onclick:()=>this.#e.select({episode:t,seed:null})},s,d("span",{class:"count"},t+1))}};var _o=0,Po=1,pl=2,fl=176;function No(r,e,t,n){let s=devicePixelRatio||1,o=or(r);r.width=r.height=fl*s;let a=r.getContext("2d");if(!a)return;let{fov:i}=e,l=r.width/
i;a.fillStyle=o.paper,a.fillRect(0,0,r.width,r.height);for(let h=0;t&&h<i*i;h++){let[u,m]=[(h%i+.5)*l,(Math.floor(h/i)+.5)*l],p=f=>!!t[f*i*i+h];p(pl)&&(a.fillStyle=
o.obstacle,a.fillRect(u-l/2,m-l/2,l,l));let y=p(_o)&&p(Po)?l*.18:0;p(_o)&&$o(a,Re,u+y,m+y,l*.74,o.evader),p(Po)&&$o(a,nr,u-y,m-y,l*.86,o.pursuer)}a.strokeStyle=
n<e.n_pursuers?o.pursuer:o.evader,a.lineWidth=2*s;let c=Math.floor(i/2)*l;a.strokeRect(c,c,l,l)}function $o(r,e,t,n,s,o){e(r,t,n,s),r.fillStyle=o,r.fill()}var Lo="What it remembers: a number for each unit, from -1 to 1",dr=class{element;#e;#r=d("canvas",{class:"seen",role:"img"});#t=d("h3");#n=d("p",{class:"small \
muted"});#a=d("div",{class:"answers"});#s=d("div",{title:Lo});#u=null;#m=null;#i=null;#d=null;#h=null;#l=null;#c=0;constructor(e){this.#e=e,this.element=d("div",
{class:"inspector","data-open":"false"},d("p",{class:"hint small muted"},"Click an agent, or press A: what it sees, and what its network answers."),d("div",{class:"\
inspected"},this.#r,d("div",{class:"answer"},this.#t,this.#n,this.#s),this.#a))}get agent(){return this.#l}show(e,t,n,s){this.#u?.free(),this.#u=e.world(n.config),
this.#i!==t&&(this.#m=null,this.#l!==null&&this.choose(null)),[this.#i,this.#d,this.#h]=[t,n,s]}set solution(e){this.#m=e,this.at(this.#c)}choose(e){this.#l=e,this.
element.dataset.open=String(e!==null),this.#e(e),this.at(this.#c)}next(e){let t=this.#d;if(!t)return;let n=this.#l??(e>0?-1:0);for(let s=0;s<t.n_agents;s++)if(n=
(n+e+t.n_agents)%t.n_agents,t.alive[this.#c*t.n_agents+n])return this.choose(n)}at(e){this.#c=e;let[t,n,s,o,a]=[this.#d,this.#u,this.#i,this.#h,this.#l];if(!t||
!n||!s||!o||a===null)return;let i=a<t.config.n_pursuers?"pursuer":"evader";this.#s.replaceChildren(),this.#t.replaceChildren(d("span",{class:i},K(a,t.config.n_pursuers)));
let l={pursuers:re(s,"pursuer",o.pursuer),evaders:re(s,"evader",o.evader)};t.seek(n,e,l);let c=t.actions.subarray(e*t.n_agents,(e+1)*t.n_agents);for(;c.length&&
!n.over&&(a<n.actors[0]||a>=n.actors[1]);)n.playTurn(c);let h=!!(t.alive[e*t.n_agents+a]&&n.read("alive")[a]);No(this.#r,t.config,h?n.view(a):null,a),this.#r.ariaLabel=
`Field of view of ${K(a,t.config.n_pursuers)}: evaders, pursuers and obstacles around it`;let u=c[a]??null;if(!h)return this.#p([],"It is gone.");let m=l[`${i}s`],
p=typeof m=="string"?null:n.answer(m,a),y=p?.probabilities??null;p?.memory.length&&this.#s.replaceChildren(d("p",{class:"small muted"},"It remembers:"),vl(p.memory));
let f=this.#m?.game(n)??null,g=typeof m=="string"?`The script "${m}" plays for it${u===null?"":`; it goes ${ie[u]}`}.`:m.sampled?"Its action is drawn from these\
 probabilities.":"It takes the most probable action.",v=[["network",y],["perfect",f?.marginal(a)??null]],S=w=>d("p",{class:"small muted"},w);this.#p([...f?[S(`V\
alue ${f.value.toFixed(2)} under perfect play.`)]:[],...yl(v,u)],u===null?"The episode is over.":g)}#p(e,t){this.#a.replaceChildren(...e),this.#n.textContent=t}};
function yl(r,e){let t=r.filter(([,o])=>o);if(!t.length)return[];let n=d("div",{class:"action muted"},d("span"),...t.map(([o])=>d("span",{class:"head"},o))),s=Array.
from(t[0][1],(o,a)=>d("div",{class:a===e?"action taken":"action"},d("span",{},ie[a]),...t.flatMap(([,i])=>gl(i[a]))));return t.length>1||t[0][0]!==r[0][0]?[n,...s]:
s}function gl(r){let e=d("span",{class:"filled"});return e.style.width=`${100*r}%`,[d("span",{class:"track"},e),d("span",{class:"numbers"},r.toFixed(2))]}function vl(r){
let e=Array.from(r,t=>{let n=d("span",{title:t.toFixed(2)});return n.style.transform=`scaleY(${t})`,n});return d("div",{class:"units",role:"img","aria-label":Lo},
...e)}function Io(r){let e=JSON.stringify(r,(t,n)=>t==="genome"?Array.from(n):n);return d("script",{type:"application/json",id:"champions"},e.replaceAll("<","\\u003c")).
outerHTML}var yt="_",bl="n",Lh=2n**64n-1n;var wn={fov:11,maxSteps:500,rewards:"paper"},wl=["rules","others","rewards","size","diagonal","fov","limit","seed","ended","walls","pursuers","evaders","played",
"next"];function Do(r,e){let t=i=>i.map(l=>Sl(l,e)).join(""),n=i=>`${Math.floor(i/r.cols)}.${i%r.cols}`,s=xl(r.rewards,e),o=[r.seed,r.episode,r.steps].join("."),a={rules:Uo(
r.rules,e),others:r.others?Uo(r.others,e):"",rewards:s===wn.rewards?"":s,size:`${r.rows}x${r.cols}`,diagonal:r.diagonal?"1":"",fov:r.fov===wn.fov?"":String(r.fov),
limit:r.maxSteps===wn.maxSteps?"":String(r.maxSteps),seed:o==="0.0.0"?"":o,ended:r.ended?"1":"",walls:r.walls.map(n).join(yt),pursuers:r.pursuers.map(Fo).join(yt),
evaders:r.evaders.map(Fo).join(yt),played:r.played.map(t).join(yt),next:r.next.every(i=>i===fs)?"":t(r.next)};return wl.filter(i=>a[i]).map(i=>`${i}=${a[i]}`).join(
"&")}function Fo({cell:r,gone:e,captured:t,everCaptured:n}){let s=t?"c":n?"e":"";return`${r[0]}.${r[1]}${s}${e?"x":""}`}function Uo(r,e){let t=e.fields.map(({name:n})=>String(
r[n]).toLowerCase());return ys(r,e.variants)??t.join(".")}function xl(r,e){let t=JSON.stringify(r);return Object.keys(e.rewards).find(s=>JSON.stringify(e.rewards[s])===
t)??Object.values(r).map(s=>String(s)).join(yt)}function Sl(r,e){if(typeof r=="number")return String(r);if(r===ps)return bl;let t=e.scripts.findIndex(({name:n})=>n===
r);return String.fromCharCode(97+t)}var Al="/* the engine */";function Wo(r,e){return d("button",{type:"button",class:"to-playground",title:"Open this step in the playground (G): the same agents a\
nd actions under any rules",onclick:()=>Ml(r(),e)},"What if?")}function Ml(r,e){let t=r!==null&&r.match.n_agents<=Kr&&Math.max(r.match.config.rows,r.match.config.
cols)<=Yr,n=t?Do(El(r.match,r.step),e):"",s=new TextDecoder().decode(cn("playground")).replace(Al,()=>Ae("script-engine")).replace("</noscript>",o=>t?o+Io(r.champions):
o);window.open(`${URL.createObjectURL(new Blob([s],{type:"text/html"}))}#${n}`)}function El(r,e){let{config:t,n_agents:n}=r,s=Math.max(0,e-1),o=i=>{let l=s*n+i,
c=s*t.n_evaders+i-t.n_pursuers,h=u=>i>=t.n_pursuers&&!!u[c];return{cell:[r.last_positions[2*l],r.last_positions[2*l+1]],gone:!r.alive[l],captured:h(r.captured),
everCaptured:h(r.ever_captured)}},a=Array.from({length:n},(i,l)=>o(l));return{rules:t.rules,others:null,rewards:t.rewards,rows:t.rows,cols:t.cols,diagonal:t.diagonal,
fov:t.fov,maxSteps:t.max_steps,seed:r.seed,episode:BigInt(r.episode),steps:s,ended:s===r.length,walls:Array.from(r.map.keys()).filter(i=>r.map[i]),pursuers:a.slice(
0,t.n_pursuers),evaders:a.slice(t.n_pursuers),played:[],next:Array.from(r.actions.subarray(s*n,(s+1)*n))}}var xn=.005,Bo=.05,Tl=["pursuer","evader"],Cl=4,Ve=new Map;function mr(r,e,t="capture-rate"){let n=JSON.stringify([{...e,rewards:null},t]),s=Ve.get(n)??($t(e)?Promise.
resolve(null):kl(r,e,t));return Ve.delete(n),Ve.set(n,s),Ve.size>Cl&&Ve.delete([...Ve.keys()][0]),s}var jo=({n_evaders:r})=>r===1?"capture-time":"capture-rate",
zo=()=>new Promise(r=>setTimeout(r));async function kl(r,e,t){await zo();let n=r.solution(e,t);for(;n.goBack();)await zo();return n}function pr(r,e,t){let{payoff:n}=r;
return t.flatMap((s,o)=>{let a=[0,0];for(let l=e.n_turns;l>0&&!e.over;l--)r.game(e)?.lost(s).forEach((c,h)=>a[h]+=c),e.playTurn(s);let i=n==="capture-rate"?xn:Bo;
return Tl.map((l,c)=>({step:o+1,team:l,lost:a[c],payoff:n})).filter(l=>l.lost>=i)})}var fr=r=>r.map(e=>({step:e.step,kind:e.team,size:e.lost/Math.max(1,...r.map(
({lost:t})=>t)),text:gt(e)})),Ho=({lost:r,payoff:e})=>e==="capture-rate"?`${r.toFixed(2)} of the capture rate`:`${r.toFixed(1)} steps`,gt=r=>`The ${r.team}s los\
e ${Ho(r)} against a perfect opponent`;function Go(r){let e=r.reduce((t,n)=>n.lost>t.lost?n:t);return`Your team's worst moves, in step ${e.step}, lost ${Ho(e)} \
against a perfect opponent.`}function Vo({config:r,payoff:e},{value:t},n){if(e==="capture-rate")return`value ${t.toFixed(2)}`;let[s,o]=[1-t,Math.min(r.max_steps-
n,Hr)];return s>o-Bo?`free for ${o} steps`:`captured after ${s.toFixed(1)} steps`}function Yo(r,e){return(r.marginal(e)??[]).map((n,s)=>({share:n,action:s})).filter(
({share:n})=>n>=xn).sort((n,s)=>s.share-n.share).map(({share:n,action:s})=>n>1-xn?ie[s]:`${ie[s]} ${n.toFixed(2)}`).join(", ")}function yr(r,e,t){if(t===0)return[{kind:"start",text:Ol(r),agents:[]}];let[n,s]=[e.moments[t-1],e.moments[t]],o=h=>K(h,r.config.n_pursuers),a=dt(e,n,s),i=r.conflicts(
t),l=new Set(i.flatMap(h=>h.doomed)),c=a.map(h=>({kind:"capture",text:`${o(h)} is captured`,agents:[h]}));for(let h of tr(n,s))!a.includes(h)&&!l.has(h)&&c.push(
{kind:"end",text:`${o(h)} disappears`,agents:[h]});return c.push(...i.map(({kind:h,text:u,agents:m})=>({kind:h,text:u,agents:m}))),t===r.length&&c.unshift({kind:"\
end",text:Rl(r),agents:[]}),c}function Ol({config:r}){return`${r.n_pursuers} pursuers and ${r.n_evaders} evaders on ${r.rows} x ${r.cols} cells, at most ${r.max_steps}\
 steps`}function Rl(r){let e=Math.round(r.statistics.capture_rate*r.config.n_evaders);return`The episode ends after ${r.length} steps with ${e} of ${r.config.n_evaders}\
 evaders captured`}var _l=60,gr=class{element;player=new Ee(0,{speed:ir,still:ye()});inspector;match=null;recording=null;actions;#e;#r;#t;#n;#a=d("h2",{class:"match-title"});#s=d(
"p",{class:"tally numbers"});#u=d("ol",{class:"words",tabindex:0,"aria-live":"off","aria-label":"What happened in this step"});#m=d("p",{class:"problem",role:"a\
lert"});#i=d("div",{class:"shown","aria-live":"polite"});#d=null;#h=null;#l=0;#c=!1;#p=0;#o=[];constructor(e,t,n){[this.#r,this.#t]=[e,t];let s=d("canvas",{"ari\
a-label":"The match",onclick:({clientX:o,clientY:a})=>this.inspector.choose(this.#e.agentAt(o,a))});this.#e=new Me(s,{numbers:!1}),this.#n=new hr(t),this.inspector=
new dr(o=>this.#E(o)),this.actions=d("div",{class:"beside"},d("button",{type:"button",class:"to-play",title:"Move the chosen agent, or an evader, yourself from \
this step on (T)",onclick:()=>this.element.dispatchEvent(new Event("takeover"))},"Take over"),n&&Wo(()=>this.shown,n)),this.element=d("section",{class:"card mat\
ch-card","aria-label":"Match",id:"match"},d("div",{class:"match"},d("header",{class:"match-head"},this.#a,this.#s),this.#m,this.#i,d("div",{class:"stage"},s),d(
"div",{class:"aside"},this.#u,Ft(),this.actions,this.inspector.element),ur(this.player),this.#n.element)),this.player.addEventListener("frame",()=>this.recording&&
this.#e.show(this.recording,this.player.time)),this.player.addEventListener("step",()=>this.#A()),t.on("match",()=>this.#g()),this.#b(),this.#S(0,0)}get#y(){return this.#r[this.#t.
selected.run]}reveal(){(this.#y.game?this.#i:this.#e.canvas).scrollIntoView({block:"nearest"})}get shown(){return this.match&&this.#h&&{match:this.match,step:this.
player.step,champions:this.#h}}start(e){this.#d=e,this.#v()}playSoon(){this.#c=!0,this.#l||this.#f()}goTo(e){this.#p=e,!this.#l&&this.match&&this.#v()}#f(){!this.#c||
!this.match||(this.#c=!1,this.player.jump(0),ye()||this.player.play())}#g(){this.#b(),clearTimeout(this.#l),this.#l=setTimeout(()=>this.#v(),_l)}#v(){clearTimeout(
this.#l),this.#l=0,this.player.pause(),this.#b();let{selected:e}=this.#t,{game:t}=this.#y;if(this.#i.replaceChildren(...t?$s(this.#y,t,e,this.#t):[]),t){this.match=
this.recording=null,this.#c=!1,this.#w(e);return}let n=Be.map(a=>jt(this.#y,a,e[a])).find(Boolean)??"";if(this.#m.textContent=n,n||!this.#d)return;this.match=Ns(
this.#d,this.#y,e);let[s,o]=this.names(e);this.#h={pursuer:{name:s,policy:re(this.#y,"pursuer",e.pursuer)},evader:{name:o,policy:re(this.#y,"evader",e.evader)}},
this.recording=ar(this.match),this.#n.show(this.#y,this.match),this.inspector.show(this.#d,this.#y,this.match,e),this.player.length=this.match.length,this.player.
marks=er(this.recording),this.#o=this.player.ticks=[],this.player.jump(this.#p),this.#p=0,this.#A(),this.#x(this.#d,this.match),this.#w(e),this.#f()}#w({run:e,pursuer:t,
evader:n,episode:s,seed:o}){this.element.dataset.played=`${e} ${t} ${n} ${s} ${o??""}`}async#x(e,t){let n=await mr(e,t.config);if(this.match!==t||!n)return;let s=e.
world(t.config);t.seek(s,0),this.#o=pr(n,s,Pl(t)),s.free(),this.player.ticks=fr(this.#o),this.inspector.solution=n,this.#A()}names({run:e,pursuer:t,evader:n}){let s=this.#r[e],
{teams:o}=s;return[o.pursuer.script??ee(s,"pursuer",t),o.evader.script??ee(s,"evader",n)]}#b(){let{episode:e,seed:t}=this.#t.selected,{game:n,payoff:s}=this.#y;
this.element.classList.toggle("of-own-game",!!n);let[o,a]=this.names(this.#t.selected),i=t===null?e<s.episodes?`episode ${e+1} of ${s.episodes}`:`episode ${e+1}\
, not part of the cell`:`seed ${t}`;this.#a.replaceChildren(d("span",{class:"pursuer"},Bt(o))," against ",d("span",{class:"evader"},a),n?"":d("span",{class:"mut\
ed small"},i))}#A(){let e=this.match;if(!e||!this.recording)return;let t=this.player.step,n=this.recording.moments[t];this.#S(Array.from(n.everCaptured).filter(
Boolean).length,t),this.#u.replaceChildren(...this.#o.filter(s=>s.step===t).map(s=>d("li",{class:`loss-${s.team}`},gt(s))),...yr(e,this.recording,t).map(s=>d("l\
i",{class:s.kind,"data-agents":s.agents.join(" ")},s.text))),this.inspector.at(t),this.#M()}#S(e,t){let{world:n}=this.#y;n&&this.#s.replaceChildren(d("strong",{},
e),` of ${n.n_evaders} captured`,d("span",{class:"muted"},` · step ${t}`))}#E(e){this.#e.look={selected:e,viewers:e===null?[]:[e]},this.#M()}#M(){let e=this.inspector.
agent;for(let t of this.#u.children){let n=t.dataset.agents?.split(" ")??[];t.classList.toggle("about",e!==null&&n.includes(String(e)))}}},Pl=({actions:r,length:e,
n_agents:t})=>Array.from({length:e},(n,s)=>r.subarray(s*t,(s+1)*t));var $l={ArrowUp:[1,0],ArrowDown:[-1,0],ArrowRight:[0,1],ArrowLeft:[0,-1]},Nl=5;function qo(r,e,t,n="pursuer"){r.tabIndex=0,r.setAttribute("role","application"),
r.addEventListener("keydown",s=>{let o=$l[s.key];if(!o)return;let[a,i]=n==="pursuer"?o:[o[1],o[0]],[l,c]=t(),h=s.shiftKey?Nl:1,{pursuer:u,evader:m}=e.selected;e.
select({pursuer:Ko(u+h*a,l),evader:Ko(m+h*i,c)}),s.preventDefault(),s.stopPropagation()})}var Ko=(r,e)=>Math.min(e-1,Math.max(0,r));var vt=[[68,1,84],[72,26,108],[71,47,125],[65,68,135],[57,86,140],[49,104,142],[42,120,142],[35,136,142],[31,152,139],[34,168,132],[53,183,121],[84,197,104],[122,
209,81],[165,219,54],[210,226,27],[253,231,37]];function vr(r){let e=Math.min(1,Math.max(0,r))*(vt.length-1),t=Math.min(vt.length-2,Math.floor(e)),[n,s]=[vt[t],
vt[t+1]],o=a=>Math.round(n[a]+(e-t)*(s[a]-n[a]));return[o(0),o(1),o(2)]}function Zo(r){let[e,t,n]=vr(r).map(s=>((s/255+.055)/1.055)**2.4);return .2126*e+.7152*t+
.0722*n>.179?"#000":"#fff"}var Jo=r=>`rgb(${vr(r).join(" ")})`,Xo=()=>`linear-gradient(to right, ${vt.map(r=>`rgb(${r.join(" ")})`).join(", ")})`;function Qo(r,e,t){let n=devicePixelRatio||1;for(let[a,i]of Object.entries(t))r.style.setProperty(a,`${i}px`);r.width=Math.round(t.width*n),r.height=Math.round(
t.height*n);let s=r.getContext("2d"),o=Ll(e);!s||!o||(s.imageSmoothingEnabled=!1,s.drawImage(o,0,0,r.width,r.height))}function Ll(r){let[e,t]=r.shape,n=document.
createElement("canvas");[n.width,n.height]=[t,e];let s=n.getContext("2d");if(!s)return null;let o=s.createImageData(t,e);return r.capture_rate.forEach((a,i)=>a.
forEach((l,c)=>{let h=4*((e-1-i-r.first[0])*t+c+r.first[1]);o.data.set([...vr(l),255],h)})),s.putImageData(o,0,0),n}function ea(r,e,t,n=2){r.textContent=j(e,n),
r.ariaLabel=`${t}: ${r.textContent}`,e!==void 0&&([r.style.backgroundColor,r.style.color]=[Jo(e),Zo(e)])}function Sn(r,e){let t=d("span",{class:"gradient"});return t.
style.backgroundImage=Xo(),d("p",{class:"scale-of-rates small muted"},r,t,e)}var Il=24,br=7,ra=r=>r<Il&&matchMedia("(pointer: coarse)").matches;function na(r,e,t,n){let[s,o]=r.payoff.shape,[a,i]=[ta(e,s),ta(t,o)],[l,c]=[Math.min(br,s),Math.
min(br,o)],h=[];for(let f=a+l-1;f>=a;f--){h.push(d("span",{class:"pursuer"},f));for(let g=i;g<i+c;g++)h.push(Fl(r,f,g,n))}let u=Array.from({length:c},(f,g)=>d("\
span",{class:"evader"},i+g)),m=d("button",{type:"button","aria-label":"Close: all cells",onclick:()=>n(null)},"✕"),y=d("div",{class:"loupe numbers",role:"grou\
p","aria-label":"Cells around the tap",onclick:f=>f.stopPropagation()},...h,m,...u);return y.style.gridTemplateColumns=`2.4rem repeat(${c}, minmax(0, 1fr))`,y}function Fl(r,e,t,n){
let s=d("button",{type:"button",onclick:()=>n({pursuer:e,evader:t})});return ea(s,Se(r,e,t)?.rate,`${ee(r,"pursuer",e)} against ${ee(r,"evader",t)}`),s}var ta=(r,e)=>Math.
max(0,Math.min(e-br,r-Math.floor(br/2)));var ne={left:52,bottom:46,top:76,right:84},ue=10,Ul=160,bt=ne.right-ue-14,_e=ne.top-ue-14,wr=class{element;#e;#r;#t=d("canvas",{"aria-hidden":"true"});#n=b("svg",
{"aria-hidden":"true"});#a=b("g");#s;#u=d("h2");#m=d("strong",{class:"rate numbers"});#i=d("span",{class:"small muted"});#d=d("p",{class:"of-both-teams small mu\
ted numbers"});#h;#l=null;constructor(e,t){[this.#r,this.#e]=[e,t],this.#s=d("div",{class:"matrix",id:"matrix","aria-label":"Payoff matrix. Arrow keys choose a \
match, Enter plays it.",onpointermove:s=>this.#x(s),onpointerleave:()=>t.point({}),onclick:s=>this.#b(s),onkeydown:({key:s})=>s==="Enter"&&this.#S()},this.#t,this.#n);
let n=d("header",{class:"readout","aria-live":"polite"},d("div",{},this.#u,this.#d),d("div",{class:"of-cell"},this.#m,this.#i));this.#h=Sn(...xe(this.#c).ends),
this.element=d("section",{class:"card matrix-card","aria-label":"Payoff matrix"},n,this.#s,this.#h),this.#g(),new ResizeObserver(()=>this.#p()).observe(this.#s),
this.#s.addEventListener("mousedown",s=>{s.preventDefault(),document.activeElement instanceof HTMLElement&&document.activeElement.blur()}),qo(this.#s,t,()=>this.#c.
payoff.shape),t.on("run",()=>{let s=Sn(...xe(this.#c).ends);this.#h.replaceWith(s),this.#h=s,this.#p()}),t.on("match hover",()=>this.#f())}get#c(){return this.#r[this.#e.
selected.run]}#p(){let[e,t]=this.#c.payoff.shape,{clientWidth:n,clientHeight:s}=this.#s;if(n<50)return;let a=Math.max(Ul,Math.min(n-ne.left-ne.right,s-ne.top-ne.
bottom))/Math.max(e,t),i=Math.max(ne.left,(n-t*a-ne.right+ne.left)/2),l=ne.top+Math.max(0,(s-ne.top-ne.bottom-e*a)/2),c={width:n,height:s,left:i,top:l,cell:a,rows:e,
columns:t};this.#l=c,Qo(this.#t,this.#c.payoff,{left:i,top:l,width:t*a,height:e*a});for(let[h,u,m]of[["left",i,n],["top",l,s],["width",t*a,n],["height",e*a,s]])
this.#t.style.setProperty(h,`${100*u/m}%`);this.#s.style.setProperty("--shape",`${n} / ${s}`),this.#n.setAttribute("viewBox",`0 0 ${n} ${s}`),this.#n.replaceChildren(
Dl(c,xe(this.#c).generation),...Wl(c),...this.#y(c),this.#a),this.#f()}#o(e){let t=this.#c.findings?.generalization;if(!t)return[];let{selected:n,hover:s}=this.#e,
[o,a]=[s.pursuer??n.pursuer,s.evader??n.evader],[i,l]=sa(e,t.pursuers.mean[o]??0,o),[c,h]=oa(e,t.evaders.mean[a]??0,a);return[b("circle",{class:"dot of-pursuers",
cx:i,cy:l,r:5}),b("circle",{class:"dot of-evaders",cx:c,cy:h,r:5})]}#y(e){let t=this.#c.findings?.generalization;if(!t)return[];let{left:n,top:s,cell:o,rows:a,columns:i}=e,
{curves:l}=xe(this.#c),[c,h]=[n+i*o+ue,s-ue],u={class:"side"};return[b("rect",{...u,x:c,y:s,width:bt,height:a*o}),b("rect",{...u,x:n,y:h-_e,width:i*o,height:_e}),
...aa(t.pursuers,(m,p)=>sa(e,m,p),"of-pursuers"),...aa(t.evaders,(m,p)=>oa(e,m,p),"of-evaders"),b("text",{class:"tick",x:c,y:s+a*o+16,"text-anchor":"start"},"0"),
b("text",{class:"tick",x:c+bt,y:s+a*o+16,"text-anchor":"end"},"1"),b("text",{class:"tick",x:n-6,y:h-4,"text-anchor":"end"},"0"),b("text",{class:"tick",x:n-6,y:h-
_e+8,"text-anchor":"end"},"1"),b("text",{class:"label of-pursuers",x:c+bt,y:s+a*o+34,"text-anchor":"end"},l.pursuer),b("text",{class:"label of-evaders",x:n+i*o+
ue,y:h-_e+10,"text-anchor":"start"},l.evader)]}#f(){let e=this.#l;if(!e)return;let{selected:t,hover:n}=this.#e,{left:s,top:o,cell:a,rows:i,columns:l}=e,c=y=>o+(i-
1-y)*a,h=[],u=(y,f)=>b("rect",{class:f,x:s,y:c(y),width:l*a+ue+bt,height:a}),m=(y,f)=>b("rect",{class:f,x:s+y*a,y:o-ue-_e,width:a,height:ue+_e+i*a});h.push(u(t.
pursuer,"strip pursuer"),m(t.evader,"strip evader")),n.pursuer!==null&&n.pursuer<i&&h.push(u(n.pursuer,"strip hover")),n.evader!==null&&n.evader<l&&h.push(m(n.evader,
"strip hover")),h.push(...this.#o(e));let p={x:s+t.evader*a,y:c(t.pursuer),width:a,height:a};h.push(b("rect",{class:"chosen under",...p}),b("rect",{class:"chose\
n",...p})),this.#a.replaceChildren(...h),this.#g()}#g(){let{selected:e,hover:t}=this.#e,n=t.pursuer??e.pursuer,s=t.evader??e.evader,o=Se(this.#c,n,s);this.#u.replaceChildren(
d("span",{class:"pursuer"},Bt(ee(this.#c,"pursuer",n)))," against ",d("span",{class:"evader"},ee(this.#c,"evader",s))),this.#m.textContent=o?j(o.rate,3):"-";let a=o&&
o.rates.length>1?`, mean of ${o.rates.length} episodes`:"";this.#i.textContent=o?xe(this.#c).score+a:"no episodes were played",this.#d.textContent=this.#v(n,s)}#v(e,t){
let n=this.#c.findings?.generalization;if(!n)return"";let s=(a,i)=>Ps(a.mean[i]??null,a.low?.[i]??null,a.high?.[i]??null),{means:o}=xe(this.#c);return`Against a\
ll: ${o.pursuer} ${s(n.pursuers,e)}, ${o.evader} ${s(n.evaders,t)}`}#w(e){let t=this.#l;if(!t)return null;let n=this.#s.getBoundingClientRect(),s=Math.floor((e.
clientX-n.left-t.left)/t.cell),o=t.rows-1-Math.floor((e.clientY-n.top-t.top)/t.cell),[a,i]=[o>=0&&o<t.rows,s>=0&&s<t.columns];return a||i?{g:a?o:-1,h:i?s:-1,inside:a&&
i}:null}#x(e){let t=this.#w(e);this.#e.point(t?{pursuer:t.g<0?null:t.g,evader:t.h<0?null:t.h}:{})}#b(e){let t=this.#w(e);if(t){if(t.inside&&ra(this.#l.cell))return this.#A(
t.g,t.h);this.#e.select({...t.g<0?{}:{pursuer:t.g},...t.h<0?{}:{evader:t.h}}),t.inside&&this.#S()}}#A(e,t){let n=na(this.#c,e,t,s=>{n.remove(),s&&(this.#e.select(
s),this.#S())});this.#s.append(n)}#S(){this.#s.dispatchEvent(new CustomEvent("play",{bubbles:!0}))}};function Dl({left:r,top:e,cell:t,rows:n,columns:s},o){let a=b(
"g",{class:"axes"}),i=e+n*t,l=c=>ut(0,c-1,Math.min(c,c*t/44),!0);for(let c of l(s))a.append(b("text",{class:"tick",x:r+(c+.5)*t,y:i+16,"text-anchor":"middle"},c));
for(let c of l(n))a.append(b("text",{class:"tick",x:r-7,y:i-(c+.5)*t,"text-anchor":"end","dominant-baseline":"middle"},c));return a.append(b("text",{class:"labe\
l of-evaders",x:r+s*t/2,y:i+36,"text-anchor":"middle"},o.evader),b("text",{class:"label of-pursuers",transform:`translate(${r-36} ${e+n*t/2}) rotate(-90)`,"text\
-anchor":"middle"},o.pursuer)),a}function Wl({left:r,top:e,cell:t,rows:n,columns:s}){let o=b("g",{class:"diagonal"}),a=Math.min(n,s);if(a<3)return[];let i=e+n*t;
for(let h of["H","V"]){let u=`M${r} ${i}`;for(let m=1;m<=a;m++){let[p,y]=[`H${r+m*t}`,`V${i-m*t}`];u+=h==="H"?p+y:y+p}o.append(b("path",{d:u,class:"under"}),b("\
path",{d:u}))}let[l,c]=[r+a/2*t-.7*t-4,i-a/2*t-.7*t-4];return[o,b("text",{class:"on-cells",transform:`translate(${l} ${c}) rotate(-45)`,"text-anchor":"middle"},
"same generation")]}var sa=({left:r,top:e,cell:t,rows:n,columns:s},o,a)=>[r+s*t+ue+o*bt,e+(n-a-.5)*t],oa=({left:r,top:e,cell:t},n,s)=>[r+(s+.5)*t,e-ue-n*_e];function aa(r,e,t){
let n=o=>o.map((a,i)=>e(a??0,i).map(l=>l.toFixed(1)).join(" ")),s=[];return r.low&&r.high&&s.push(b("path",{class:`band ${t}`,d:`M${[...n(r.high),...n(r.low).reverse()].
join("L")}Z`})),s.push(b("path",{class:`line ${t}`,d:`M${n(r.mean).join("L")}`})),s}var ia={pursuer:null,evader:null},xr=class extends EventTarget{#e;#r=ia;constructor(e){super(),this.#e=e}get selected(){return this.#e}get hover(){return this.#r}select(e){
let t=this.#e,n=["run","pursuer","evader"].some(s=>s in e&&e[s]!==t[s]);this.#e={...t,...n?{episode:0,seed:null}:{},...e},this.#e.run!==t.run&&this.dispatchEvent(
new Event("run")),this.dispatchEvent(new Event("match"))}point(e){let t={...ia,...e};t.pursuer===this.#r.pursuer&&t.evader===this.#r.evader||(this.#r=t,this.dispatchEvent(
new Event("hover")))}on(e,t){for(let n of e.split(" "))this.addEventListener(n,t)}};var Sr=class{config;start;recording;actions=[];#e;#r;#t=[[]];constructor(e,t,n){[this.config,this.start]=[t,n],this.#e=e.world(t),this.#e.reset(n),this.#r=[bn(this.#e)],
this.recording=vn(t,this.#e.map(),this.#r)}get length(){return this.actions.length}get over(){return this.#e.over}get statistics(){return{capture_rate:this.#e.read(
"capture_rate")[0]}}conflicts(e){return this.#t[e]}game(e){return e.game(this.#e)}play(e){this.#e.step(e),this.#n(e)}step(e,t,n){let[s,o]=[this.#e,this.config.n_pursuers],
a=new Uint8Array(s.n_agents);for(let i=s.n_turns;i>0&&!s.over;--i){let[l,c]=s.actors;l<o&&(a=s.decide(e.pursuer,[l,Math.min(c,o)],a)),c>o&&(a=s.decide(e.evader,
[Math.max(l,o),c],a)),typeof n=="number"?a[t]=n:l<=t&&t<c&&(a=s.decide(n,[t,t+1],a)),s.playTurn(a)}this.#n(a)}#n(e){this.actions.push(e),this.#r.push(bn(this.#e,
e)),this.#t.push(this.#e.conflicts())}};var he=(r,e)=>Be[+(e>=r.n_pursuers)];function An(r,e){let t=new Sr(r,e.config,{seed:e.seed,episode:e.episode});for(let n of e.moves)t.over||t.step(e.policies,e.
seat,n);return t}function Ye(r,e){let{moments:t,nPursuers:n}=r.recording,s=t.findIndex(({alive:a,captured:i})=>!a[e]||!!i[e-n]),o=s<0?r.length:s;return{lasted:o,
out:s>=0,captured:Array.from(t[o].everCaptured).filter(Boolean).length}}var Ar=(r,e)=>r.over||Ye(r,e).out;function la(r,e,t){let n=An(r,{...e,moves:e.moves.slice(
0,e.from)});for(;!Ar(n,e.seat);)n.step(e.policies,e.seat,t);return Ye(n,e.seat)}function ca(r){let e=r.length-1;return[...new Set([0,Math.round(e/3),e])].map(t=>r[t])}
function ua(r,{seat:e,from:t,moves:n}){let s={...r,seat:e,...t?{from:t}:{},moves:n.join("")};return`${location.href.split("#")[0]}#${Object.entries(s).map(([o,a])=>`${o}\
=${a}`).join("&")}`}function ha(r,e){let[t,n,s]=[r.get("seat")??"",r.get("from")??"0",r.get("moves")??""];return/^\d{1,6}$/.test(t)&&Number(t)<e.n_pursuers+e.n_evaders&&
(e.diagonal?/^[0-8]+$/:/^[0-4]+$/).test(s)&&s.length<=e.max_steps&&/^\d{1,6}$/.test(n)&&Number(n)<=s.length?{seat:Number(t),from:Number(n),moves:[...s].map(Number)}:
null}function Mn(r,e,t,n,s,o){e.play({title:t,played:n,ending:(a,i)=>[zl(r,a,i,ca(s))],again:()=>Mn(r,e,t,{...n,moves:n.moves.slice(0,n.from)},s,o),link:a=>o&&ua(o,a)})}
function zl(r,e,t,n){let s=he(t.config,t.seat)==="evader",o=s?t.config.max_steps:t.config.n_evaders,a=d("table",{class:"numbers"},d("caption",{},s?"Steps in you\
r seat: same start, same others":"Captures of your team: same start, same others")),i=c=>{let[h,u]=[d("span",{class:s?"bar evader":"bar pursuer"}),d("td",{},"…")];
return a.append(d("tr",{},d("th",{scope:"row"},c),d("td",{class:"track","aria-hidden":"true"},h),u)),({lasted:m,captured:p})=>{h.style.width=`${100*(s?m:p)/o}%`,
u.textContent=String(s?m:p)}};i("You")(Ye(e,t.seat));for(let{name:c,policy:h}of n){let u=i(c);setTimeout(()=>u(la(r,t,h())))}let l=t.from?`You took over at step\
 ${t.from}. `:"";return d("div",{},a,d("p",{class:"small muted"},`${l}One match: luck has its part in it.`))}var da=["·","↑","→","↓","←","↗","↘","↙","↖"];var Bl={" ":0,ArrowUp:1,w:1,ArrowRight:2,d:2,ArrowDown:3,s:3,ArrowLeft:4,a:4,e:5,c:6,y:7,z:7,q:8},En=[8,1,5,4,0,2,7,3,6],jl=[7,8,9,4,5,6,1,2,3],Hl=24,Gl=Math.tan(
Math.PI/8);function pa(r,e){if(r.ctrlKey||r.metaKey||r.altKey)return;let t=jl.findIndex(s=>r.code===`Numpad${s}`),n=En[t]??Bl[r.key.length===1?r.key.toLowerCase():
r.key];return n!==void 0&&n>4&&!e?void 0:n}function fa(r){let e=En.map(t=>d("button",{type:"button","aria-label":ie[t],onclick:()=>r(t)},da[t]));return{element:d(
"div",{class:"play-pad",role:"group","aria-label":"Your move"},...e),show:t=>e.forEach((n,s)=>n.classList.toggle("absent",En[s]>4&&!t))}}function ma(r,e,t){let n=Gl*
Math.max(Math.abs(r),Math.abs(e)),s=o=>Math.abs(o)<n?0:o;return Ys([0,0],t?[s(r),s(e)]:[r,e],t)}function ya(r,e,t){let n=null,{canvas:s}=r;s.addEventListener("p\
ointerdown",({button:o,clientX:a,clientY:i})=>n=o===0?[a,i]:null),s.addEventListener("pointercancel",()=>n=null),s.addEventListener("pointerup",({clientX:o,clientY:a})=>{
let[i,l]=[n,e()];if(n=null,!i||!l)return;let[c,h]=[o-i[0],a-i[1]],u=r.cellAt(o,a);Math.hypot(c,h)>=Hl?t(ma(h,c,l.diagonal)):u&&t(ma(u[0]-l.cell[0],u[1]-l.cell[1],
l.diagonal))})}function ga(r,e){let t=n=>{let s=e[n]-r[n],o=je.findIndex(a=>a[n]===Math.sign(s)&&a[1-n]===0);return s?`${Math.abs(s)} ${ie[o]}`:""};return[t(0),
t(1)].filter(Boolean).join(", ")||"on your cell"}var wa="NUMPY\0",va=wa.length+2,ba=64;function wt(r){return zt(Object.fromEntries(Object.entries(r).map(([e,t])=>[`${e}.npy`,Vl(t)])))}function Vl({dtype:r,shape:e,
data:t}){let n=typeof t=="string"?Array.from(t,h=>h.codePointAt(0)):null,s=e.map(h=>`${h}, `).join(""),o=`{'descr': '${n?`<U${n.length}`:r}', 'fortran_order': F\
alse, 'shape': (${s}), }`,a=Math.ceil((va+o.length+1)/ba)*ba-va,i=wa+String.fromCharCode(a&255,a>>8)+o.padEnd(a-1)+`
`,l=n?Int32Array.from(n):t,c=new Uint8Array(i.length+l.byteLength);return c.set(Ce(i,!0)),c.set(new Uint8Array(l.buffer,l.byteOffset,l.byteLength),i.length),c}var Yl="matrixworld episode 3";function xa(r,e,t){let{config:n,actions:s,length:o,recording:a}=e,[i,l]=[n.n_pursuers+n.n_evaders,n.n_evaders],c={positions:["<i4",
i,2],last_positions:["<i4",i,2],alive:["|b1",i],captured:["|b1",l],ever_captured:["|b1",l]},h={rewards:["<f4",i],involved:["|b1",i,3],fault:["|b1",i,3]},u={},m=w=>{
for(let M of Object.keys(w))(u[M]??=[]).push(Array.from(p.read(M),Number))},p=r.world(n);p.reset(e.start);let y=[];m(c);for(let w of s)p.step(w),m({...c,...h}),
y.push(...p.conflictTable());p.free();let f={"<i4":Int32Array,"<f4":Float32Array,"|b1":Uint8Array},g={};for(let[w,[M,...O]]of Object.entries({...c,...h})){let L=o+
+(w in c);g[w]={dtype:M,shape:[L,...O],data:f[M].from((u[w]??[]).flat())}}let v=w=>({dtype:"<i8",shape:[],data:Int32Array.of(w,0)}),S=w=>({dtype:"<U",shape:[],data:w});
return wt({format:S(Yl),n_pursuers:v(n.n_pursuers),config:S(JSON.stringify(n)),seat:v(t),...g,actions:{dtype:"|i1",shape:[o,i],data:Int8Array.from(s.flatMap(w=>[
...w]))},map:{dtype:"|b1",shape:[n.rows,n.cols],data:Uint8Array.from(a.obstacles,Number)},conflict_table:{dtype:"<i4",shape:[y.length/11,11],data:Int32Array.from(
y)}})}var Kl=[0,1,2,4,8],Mr=class{element;player=new Ee(0,{speed:4,still:ye()});#e;#r;#t=d("canvas",{tabindex:0,"aria-describedby":"play-keys"});#n=d("h2");#a=d("p",{
class:"play-told",role:"status"});#s=fa(e=>this.act(e));#u=se(Kl.map(e=>[e,e?`${e} / s`:"step by step"]),()=>this.#C());#m=d("input",{type:"checkbox",onchange:()=>this.#A()});#i=d(
"input",{type:"checkbox",onchange:()=>this.#k()});#d=d("label",{class:"play-choice"},this.#i,"Best move");#h=d("p",{class:"small muted play-keys",id:"play-keys"});#l=d(
"section",{class:"play-ending",tabindex:-1,"aria-labelledby":"play-headline"});#c=ur(this.player);#p=null;#o=null;#y=[];#f=null;#g=null;#v=[];#w=0;#x=0;constructor(e){
this.#e=e,this.#r=new Me(this.#t,{numbers:!1}),this.#t.setAttribute("role","application"),ya(this.#r,()=>{let t=this.#f!==null&&this.#o&&k(this.#o.recording.moments.
at(-1),this.#f);return t?{cell:t,diagonal:this.#o.config.diagonal}:null},t=>this.act(t)),this.player.addEventListener("frame",()=>this.#o&&this.#r.show(this.#o.
recording,this.player.time)),this.player.addEventListener("step",()=>this.#k()),this.element=d("div",{class:"play"},d("header",{class:"play-head"},this.#n,this.#a),
d("div",{class:"play-stage"},this.#t),d("div",{class:"play-side"},this.#l,this.#s.element,d("label",{class:"play-choice",title:"Steps a second"},"Pace ",this.#u),
d("label",{class:"play-choice"},this.#m,d("span",{},"Fog",d("span",{class:"at-length"},": see only what it sees"))),this.#d,this.#h),this.#c)}get played(){return this.#p&&
{...this.#p.played,moves:this.#y}}get live(){return this.#o}play(e){this.#b(An(this.#e,e.played),e.played.seat,e.title),[this.#p,this.#y,this.#w]=[e,[...e.played.
moves],0],this.element.dataset.state="playing",this.#t.focus({preventScroll:!0}),Ar(this.#o,e.played.seat)&&this.#R()}watch(e,t,n){this.#p=null,this.#b(e,t,n),this.#_()}stop(){
this.#C(),this.player.pause(),this.#p=null}act(e){let[t,n]=[this.#p,this.#o];if(!t||!n||this.element.dataset.state!=="playing")return;this.#w=e;let s=Number(this.#u.
value);this.#x||(this.#O(),s&&this.element.dataset.state==="playing"&&(this.#x=setInterval(()=>this.#O(),1e3/s)))}key(e){let{target:t,key:n}=e;if(t instanceof HTMLSelectElement||
t instanceof HTMLInputElement&&(t.type==="text"||n===" ")||t instanceof HTMLButtonElement&&(n===" "||n==="Enter")||!this.#o)return!1;if(this.element.dataset.state!==
"playing")return cr(this.player,e);let o=pa(e,this.#o.config.diagonal);return o!==void 0&&this.act(o),o!==void 0}#b(e,t,n){this.#C(),this.player.pause(),[this.#o,
this.#f]=[e,t],this.#n.textContent=n,this.#t.ariaLabel=`Board, ${e.config.rows} by ${e.config.cols} cells`,this.#s.show(e.config.diagonal),this.#h.replaceChildren(
d("span",{class:"at-length"},`W A S D or the arrow keys move, Space stays${e.config.diagonal?"; Q E Z C and the numeric keypad move diagonally":""}. `),"On the \
board: swipe, or tap where to go."),this.#S(e),this.#l.replaceChildren(),this.player.length=e.length,this.player.jump(e.length),this.#k()}#A(){this.#r.look={you:this.#f,
fog:this.#m.checked,viewers:this.#f===null?[]:[this.#f],plan:this.#T()}}#S(e){this.#g=null,this.#v=this.player.ticks=[],this.#d.hidden=this.#i.disabled=!!$t(e.config),
mr(this.#e,e.config,jo(e.config)).then(t=>{this.#o===e&&(this.#g=t,this.#E(),this.#k())})}#E(){let[e,t]=[this.#o,this.#g];if(!t||this.element.dataset.state==="p\
laying")return;let n=this.#e.world(e.config);n.reset(e.start),this.#v=pr(t,n,e.actions),n.free(),this.player.ticks=fr(this.#v)}get#M(){return this.#i.checked&&this.#p&&
this.element.dataset.state==="playing"&&this.#g&&this.#o.game(this.#g)||null}#T(){let[e,t]=[this.#f,this.#f!==null&&this.#M?.marginal(this.#f)];return e!==null&&
t?Object.assign(Array(e).fill(0),{[e]:t.indexOf(Math.max(...t))}):null}#C(){clearInterval(this.#x),this.#x=0,this.#a.ariaLive=Number(this.#u.value)?"off":"polit\
e"}#O(){let[{policies:e,seat:t},n]=[this.#p.played,this.#o];n.step(e,t,this.#w),this.#y.push(this.#w),this.player.length=n.length,this.player.glide=Math.min(.22,
.9/(Number(this.#u.value)||4)),this.player.move(n.length-this.player.step),Ar(n,t)&&this.#R()}#R(){this.#C();let[e,t,n]=[this.#p,this.#o,this.played],s=Lt()?e.link(
n):null,o=`${K(n.seat,t.config.n_pursuers)}-${t.length}-steps.npz`,a=()=>It(o,xa(this.#e,t,n.seat));this.#l.replaceChildren(d("h3",{id:"play-headline"},Jl(t,n.seat)),
...e.ending(t,n),d("div",{class:"play-buttons"},d("button",{type:"button",class:"primary",onclick:()=>e.again()},"Again"),d("button",{type:"button",onclick:()=>this.#_()},
"Watch it"),d("button",{type:"button",onclick:a},"Save"),s&&d("button",{type:"button",onclick:({currentTarget:l})=>Ql(l,s)},"Link"))),this.element.dataset.state=
"ended",this.#E();let i=this.#v.filter(({team:l})=>l===he(t.config,n.seat));i.length&&this.#l.children[0].after(d("p",{class:"small muted"},Go(i))),this.#l.focus(
{preventScroll:!0}),this.#l.scrollIntoView({block:"nearest"})}#_(){this.element.dataset.state="watched",this.player.length=this.#o.length,this.player.jump(0),ye()||
this.player.play()}#k(){let[e,t,{step:n}]=[this.#o,this.#f,this.player];if(!e||n>e.length)return;let s=yr(e,e.recording,n).filter(({agents:l})=>t===null||l.includes(
t)),o=this.#p&&n===0,a=o?[ql(e.config,t),this.#p.about??""]:[`Step ${n} of ${e.config.max_steps}`,...s.map(({text:l})=>l)];!o&&t!==null&&a.push(Zl(e,n,t)),a.push(
...this.#v.filter(l=>l.step===n).map(gt));let i=n===e.length&&t!==null?this.#M:null;i&&a.push(`Perfect play: ${Yo(i,t)||"decided in its turn"}; ${Vo(this.#g,i,n)}`),
this.#A(),this.#a.textContent=a.filter(Boolean).map(l=>`${l}.`).join(" ")}};function ql(r,e){let t=r.rules.capture==="SURROUND";return he(r,e)==="evader"?`Run a\
way: you win if ${t?"the pursuers do not surround you":"no pursuer reaches your cell"} in ${r.max_steps} steps`:`Capture evaders: ${t?"surround them with your t\
eam":"move onto their cells"}`}function Zl({config:r,recording:e},t,n){let s=e.moments[t],a=he(r,n)==="pursuer"?"evader":"pursuer";if(!s.alive[n])return"";let i=k(
s,n),l=u=>{let[m,p]=k(s,u);return Math.max(Math.abs(m-i[0]),Math.abs(p-i[1]))},c=Array.from({length:s.alive.length},(u,m)=>m).filter(u=>he(r,u)===a&&s.alive[u]&&
!s.captured[u-r.n_pursuers]&&2*l(u)<r.fov);if(!c.length)return`No ${a} in view`;let h=c.reduce((u,m)=>l(m)<l(u)?m:u);return`Nearest ${a}: ${ga(i,k(s,h))}`}function Jl(r,e){
let[{lasted:t,out:n,captured:s},{config:o}]=[Ye(r,e),r];return he(o,e)==="pursuer"?`Your team captured ${s} of ${Xl(o)} in ${t} steps.`:n?`You lasted ${t} of ${o.
max_steps} steps.`:`You escaped: ${t} steps.`}var Xl=({n_evaders:r})=>`${r} evader${r===1?"":"s"}`;function Ql(r,e){let t=us("Link to this match");t.value=e,r.replaceWith(
t),t.select(),navigator.clipboard?.writeText(e).catch(()=>{})}var ec=2n**64n-1n;function Sa(r,e,t){let n=new URLSearchParams(r.replace(/^#/,"")),s=(c,h,u)=>{let m=n.get(c)??"";return/^\d{1,9}$/.test(m)&&Number(m)<h?Number(
m):u},o=s("run",e.length,t.run),[a,i]=e[o].payoff.shape,l=n.get("seed")??"";return{run:o,pursuer:s("pursuers",a,Math.min(t.pursuer,a-1)),evader:s("evaders",i,Math.
min(t.evader,i-1)),episode:s("episode",1/0,t.episode),seed:/^\d{1,20}$/.test(l)&&BigInt(l)<=ec?l:null,step:s("step",1/0,0)}}var Er=class{dialog=d("dialog",{class:"take-over","aria-label":"Play an agent",onclose:()=>this.view?.stop(),onkeydown:e=>this.view?.key(e)&&e.preventDefault()});view=null;#e;#r;#t;#n;#a=null;constructor(e,t,n,s=!0){
[this.#e,this.#r,this.#t,this.#n]=[e,t,n,s],n.element.addEventListener("takeover",()=>this.open())}start(e,t=""){this.#a=e;let n=Sa(t,this.#e,this.#r.selected),
{world:s}=this.#e[n.run],o=s&&ha(new URLSearchParams(t.replace(/^#/,"")),s);o&&this.play(n,o)}open(){let e=this.#t.shown;if(!e)return;let{match:t,step:n}=e;this.#t.
player.pause();let s=this.#t.inspector.agent,o=n<t.length?n:0,a=(u,m)=>!!t.alive[m*t.n_agents+u],i=Array.from({length:t.n_agents},(u,m)=>(m+t.config.n_pursuers)%
t.n_agents),l=s??i.find(u=>a(u,o)),c=a(l,o)?o:0,h=Array.from({length:c},(u,m)=>t.actions[m*t.n_agents+l]);this.play(this.#r.selected,{seat:l,from:c,moves:h})}play(e,t){
let[n,s]=[this.#a,this.#e[e.run]],{world:o}=s;if(!n||!o||Be.some(v=>jt(s,v,e[v])))return;let{run:a,pursuer:i,evader:l,episode:c,seed:h}=e,u=he(o,t.seat),m=s.teams[u].
kept.map(v=>({name:s.teams[u].script??`generation ${v}`,text:"",policy:()=>re(s,u,v)}));this.view||(this.view=new Mr(n),this.dialog.append(d("button",{type:"but\
ton",class:"leave",onclick:()=>this.dialog.close()},"Close"),this.view.element)),this.dialog.open||this.dialog.showModal();let p=`You are ${K(t.seat,o.n_pursuers)}\
: ${this.#t.names(e).join(" against ")}`,y={pursuer:re(s,"pursuer",i),evader:re(s,"evader",l)},f={config:o,seed:BigInt(h??s.seeds[i][l]),episode:c,policies:y,...t},
g={run:a,pursuers:i,evaders:l,episode:c,...h===null?{}:{seed:h}};Mn(n,this.view,p,f,m,this.#n?g:null)}};var tc=8,rc=700,Aa=1400,xt=class{element;player=new Ee(0,{speed:tc,still:ye()});title=d("figcaption");generation=0;#e=d("canvas");#r;#t=d("p",{class:"small mute\
d numbers"});#n=d("p",{class:"small",role:"status"});#a;#s=null;#u=0;#m=0;#i=!ye();constructor(e){this.#a=e,this.#r=new Me(this.#e,{numbers:!1}),this.element=d(
"figure",{class:"chase"},this.title,this.#e,this.#t,this.#n),this.player.addEventListener("frame",()=>this.#l()),this.player.addEventListener("step",()=>this.#c()),
this.player.addEventListener("state",()=>{this.#i&&!this.player.playing&&this.player.length&&this.player.step===this.player.length&&this.#d()})}set label(e){this.#e.
ariaLabel=e}get runs(){return this.#i}set runs(e){this.#i=e,clearTimeout(this.#m),e?this.player.play():this.player.pause()}renew(e=!1){e||!this.#s||performance.
now()-this.#u>Aa?this.#h():this.#d(Aa)}#d(e=rc){clearTimeout(this.#m),this.#m=setTimeout(()=>this.#h(),e)}#h(){clearTimeout(this.#m);let e=this.#a();e&&(this.#s=
ar(e),this.#u=performance.now(),this.player.jump(0),this.player.length=e.length,this.player.marks=er(this.#s),this.#c(),this.#i&&this.player.play())}#l(){this.#s&&
this.#r.show(this.#s,this.player.time)}#c(){let e=this.#s?.moments[this.player.step]?.everCaptured;e&&(this.#t.textContent=`generation ${this.generation} · ${Array.
from(e).filter(Boolean).length} of ${e.length} caught · step ${this.player.step}`)}drawWalls(e){let t=!1,n=!0,s=[0,0],o=([l,c])=>!!this.#s?.obstacles[l*this.#s.
cols+c],a=(l,c)=>{this.#n.textContent=e(l,c)},i=l=>{let c=this.#r.cellAt(l.clientX,l.clientY);c&&o(c)!==n&&a(c,n)};return this.#e.addEventListener("pointerdown",
l=>{let c=t&&this.#r.cellAt(l.clientX,l.clientY);c&&(this.#e.setPointerCapture(l.pointerId),n=!o(c),i(l))}),this.#e.addEventListener("pointermove",l=>t&&l.buttons&&
i(l)),this.#e.addEventListener("keydown",l=>{let c={ArrowUp:[-1,0],ArrowDown:[1,0],ArrowLeft:[0,-1],ArrowRight:[0,1]}[l.key];if(!t||!this.#s||!(c||l.key===" "))
return;l.preventDefault();let h=(p,y)=>Math.min(y-1,Math.max(0,p)),{rows:u,cols:m}=this.#s;c?s=[h(s[0]+c[0],u),h(s[1]+c[1],m)]:a(s,!o(s)),this.#r.look={cursor:s}}),
l=>{t=l,this.#e.classList.toggle("drawn-on",l),this.#e.tabIndex=l?0:-1,this.#e.setAttribute("role",l?"application":"img"),this.#r.look={cursor:null}}}show(e){this.#s&&
(this.#s={...this.#s,obstacles:e},this.#l())}};var N=r=>Array.from(r).reduce((e,t)=>e+t,0)/r.length,Ma=(r,e)=>e==="pursuer"?r:r[0].map((t,n)=>r.map(s=>1-s[n])),Ea=(r,e)=>N(Ma(r,e).at(-1));function Ta(r,e){let t=[],
n=Ma(r,e).map(s=>N(s.map((o,a)=>(t[a]=Math.max(t[a]??0,o),t[a]-o))));return N(n.slice(Math.floor(n.length/2)))}var Ca=-12676506002282294e14,ka=({hidden:r,mask:e})=>r.map(t=>t+(e?4:0));function St(r){let e=[3*r.fov**2,...ka(r),5],t=0;return e.slice(1).map((n,s)=>{let o={at:t,
inputs:e[s],outputs:n};return t+=(o.inputs+1)*n,o})}function Ke(r){let{at:e,inputs:t,outputs:n}=St(r).at(-1);return e+(t+1)*n}var At=(r,e)=>({hidden:ka(r),activation:"\
relu",sampled:!0,memory:"none",genome:e});function Oa(r,e,t,n){let s=new Float32Array(Ke(r)),o=St(r);return o.forEach(({at:a,inputs:i,outputs:l},c)=>{let h=Math.
fround(c===o.length-1?n:t);e.normals(i*l).forEach((u,m)=>s[a+m]=h*u)}),s}function Tn(r){let{fov:e,mask:t}=r;if(!t)return null;let[n,s]=[new Uint8Array(Ke(r)),new Float32Array(
Ke(r))],o=St(r),a=o.length-1,i=Math.floor(e/2);return o.forEach(({at:l,inputs:c,outputs:h},u)=>{let m=(p,y)=>l+p*h+y;for(let p=0;p<4;p++)if(u>0&&n.fill(1,m(c-4+
p,0),m(c-4+p+1,0)),u<a)for(let y=0;y<=c;y++)n[m(y,h-4+p)]=1;t.forEach((p,y)=>{let f=u===a?1+y:h-4+y,g=u===0?p.map(([v,S,w])=>(v*e+i+S)*e+i+w):[c-4+y];for(let v of g)
n[m(v,f)]=1,s[m(v,f)]=u===a?Ca:1})}),{fixed:n,values:s}}function Cn(r,e){return e?r.map((t,n)=>e.fixed[n]?e.values[n]:t):r}function Ra(r,e,t){let n=new Float32Array(
Ke(t)),[s,o]=[St(e),St(t)],a=Math.floor(t.fov/2)-Math.floor(e.fov/2),i=c=>c>=0&&c<t.fov,l=c=>{let[h,u,m]=[Math.floor(c/e.fov**2),Math.floor(c/e.fov)%e.fov+a,c%e.
fov+a];return i(u)&&i(m)?(h*t.fov+u)*t.fov+m:-1};return s.forEach((c,h)=>{let u=o[h],m=e.hidden[h]??5;for(let p=0;p<(h?e.hidden[h-1]:c.inputs);p++){let y=h?p:l(
p);if(!(y<0))for(let f=0;f<m;f++)n[u.at+y*u.outputs+f]=r[c.at+p*c.outputs+f]}for(let p=0;p<m;p++)n[u.at+u.inputs*u.outputs+p]=r[c.at+c.inputs*c.outputs+p]}),Cn(
n.map(c=>c<=Ca/2?0:c),Tn(t))}var Na={initial:1,noise:2,learn:3,opponents:4},On={pursuer:1,evader:2,both:3},Pe=4,kn=2n**32n;function _a(r){let e=[],t=BigInt(r);do e.push(Number(t%kn)),t/=kn;while(t>
0n);return e}function Pa(r,e){let t=r;return n=>{let s=n^t;return t=Math.imul(t,e),s=Math.imul(s,t),s^s>>>16}}function $a(r,e){let t=Math.imul(3389127133,r)-Math.
imul(1232336661,e)|0;return t^t>>>16}function Rn(r,e,t){let n=r.flatMap(_a);if(e.length){for(;n.length<Pe;)n.push(0);n.push(...e.flatMap(_a))}let s=Pa(1135663077,
2468251765),o=Array.from({length:Pe},(i,l)=>s(n[l]??0));for(let i=0;i<Pe;i++)for(let l=0;l<Pe;l++)i!==l&&(o[l]=$a(o[l],s(o[i])));for(let i of n.slice(Pe))for(let l=0;l<
Pe;l++)o[l]=$a(o[l],s(i));let a=Pa(2337405405,1492356589);return Uint32Array.from({length:t},(i,l)=>a(o[l%Pe]))}function Mt(r,e){let t=Rn(r,[],2*e);return BigUint64Array.
from({length:e},(n,s)=>BigInt(t[2*s])+kn*BigInt(t[2*s+1]))}var Tr=(r,e,t)=>Mt([r,e,t],1)[0];var La=r=>(e,...t)=>new _n(Rn([r],[Na[e],...t],3)),_n=class{#e;#r;#t;#n=1;constructor(e){[this.#e,this.#r,this.#t]=[e[0],e[1],e[2]];for(let t=0;t<12;t++)this.#a()}#a(){
let e=this.#e+this.#r+this.#n++|0;return this.#e=this.#r^this.#r>>>9,this.#r=this.#t+(this.#t<<3)|0,this.#t=(this.#t<<21|this.#t>>>11)+e|0,e>>>0}#s(){return(this.#a()+
.5)/2**32}normals(e){let t=new Float32Array(e);for(let n=0;n<e;n+=2){let[s,o]=[Math.sqrt(-2*Math.log(this.#s())),2*Math.PI*this.#s()];t[n]=s*Math.cos(o),n+1<e&&
(t[n+1]=s*Math.sin(o))}return t}integers(e,t){return Int32Array.from({length:t},()=>Math.floor(this.#s()*e))}permutation(e){return this.choice(e,e)}choice(e,t){
let n=Int32Array.from({length:e},(s,o)=>o);for(let s=0;s<t;s++){let o=s+Math.floor(this.#s()*(e-s));[n[s],n[o]]=[n[o],n[s]]}return n.slice(0,t)}};var C=Math.fround,nc=5,sc=256,Cr=class{size;sigma;fixed;#e;constructor(e,t,n,s){[this.size,this.sigma,this.fixed]=[e,n,s],this.#e=t.normals((1+sc)*e);for(let o=0;o<
this.#e.length;o++)this.#e[o]*=C(n)}draw(e,t){let n=t.integers(this.#e.length-this.size+1,e);return Array.from(n,s=>{let o=this.#e.subarray(s,s+this.size);return this.
fixed?o.map((a,i)=>this.fixed[i]?0:a):o})}},Pn=class{#e;#r;#t=0;constructor(e){[this.#e,this.#r]=[new Float32Array(e),new Float32Array(e)]}moved(e,t,n){let[s,o,
a]=[.9,.999,C(1e-8)];this.#t+=1;let[i,l]=[C(1-s),C(1-o)],[c,h]=[C(1-s**this.#t),C(1-o**this.#t)];return e.map((u,m)=>{let p=t[m],y=this.#e[m]+=C(i*C(p-this.#e[m])),
f=this.#r[m]+=C(l*C(C(p*p)-this.#r[m])),g=C(C(Math.sqrt(C(C(f)/h)))+a);return C(u+C(C(C(n)*C(C(y)/c))/g))})}};function oc(r){let e=Array.from(r).sort((t,n)=>t-n);
return r.map(t=>(e.indexOf(t)+e.lastIndexOf(t))/(2*(r.length-1))-.5)}var kr=class{genome;groups;#e;#r;#t;#n=[];constructor(e,t,n){[this.genome,this.#r,this.#e,this.#t]=
[e,t,n,new Pn(e.length)],this.groups=Int32Array.from({length:n.population},(s,o)=>o%(n.population/2))}get#a(){let{sigma:e,fixed:t}=this.#r,[n,s]=[0,0];return this.
genome.forEach((o,a)=>{t?.[a]||(n+=o*o,s+=1)}),Math.max(e,this.#e.relative_sigma*Math.sqrt(n/s))}ask(e){let[t,n]=[this.#e.population/2,this.genome.length];this.#n=
this.#r.draw(t,e);let s=C(this.#a/this.#r.sigma),o=new Float32Array(2*t*n);return this.#n.forEach((a,i)=>{for(let l=0;l<n;l++){let c=C(s*a[l]);o[i*n+l]=this.genome[l]+
c,o[(t+i)*n+l]=this.genome[l]-c}}),o}tell(e){let[t,n]=[oc(e),this.#n.length],s=new Float32Array(this.genome.length);this.#n.forEach((o,a)=>{let i=C((t[a]-t[n+a])/
(2*n*this.#r.sigma**2));for(let l=0;l<s.length;l++)s[l]+=C(i*o[l])}),this.genome=this.#t.moved(this.genome,s,this.#e.learning_rate)}},Et=class{population;groups;#e;#r;#t=new Float64Array(
0);#n=0;constructor(e,t,n){[this.population,this.#r,this.#e]=[e,t,n],this.groups=new Int32Array(n.population)}get genome(){return this.#a(this.#n).slice()}#a(e){
let{size:t}=this.#r;return this.population.subarray(e*t,(e+1)*t)}#s(e,t){let n=this.#e.tournament??nc,s=t.integers(this.#t.length,e*n);return Array.from({length:e},
(o,a)=>s.subarray(a*n,(a+1)*n).reduce((i,l)=>this.#t[l]>this.#t[i]?l:i))}ask(e){if(!this.#t.length)return this.population;let{size:t}=this.#r,{population:n,elites:s}=this.#e,
o=n-s,a=this.#s(o,e);this.#s(o,e);let i=Array.from(this.#t.keys()).sort((c,h)=>this.#t[h]-this.#t[c]).slice(0,s),l=new Float32Array(this.population.length);return[
...i,...a].forEach((c,h)=>l.set(this.#a(c),h*t)),this.#r.draw(o,e).forEach((c,h)=>{let u=(s+h)*t;for(let m=0;m<t;m++)l[u+m]+=c[m]}),this.population=l,l}tell(e){
this.#t=e,this.#n=e.indexOf(Math.max(...e))}};function Ia(r,e,t,n){let[s,o]=[r.length,Math.max(...r)+1],a=o>1?s/o:1,i=Array.from(r.keys()).sort((u,m)=>r[u]-r[m]),l=[],c=[];for(let u=0;u<e;u++){let m=u%a;m===
0&&(c=Array.from(n.permutation(s/a)).flatMap(p=>i.slice(p*a,(p+1)*a))),l.push([i,c.map((p,y)=>c[y-y%a+(y%a-m+a)%a])])}let h=u=>i.map(()=>s+u);for(let u=0;u<t[1];u++)
l.push([i,h(u)]);for(let u=0;u<t[0];u++)l.push([h(u),i]);return{pursuer:Int32Array.from(l.flatMap(([u])=>u)),evader:Int32Array.from(l.flatMap(([,u])=>u)),group:Int32Array.
from(l.flatMap((u,m)=>i.map(p=>m*o+r[p])))}}function Fa(r,e,t,n){let s=Math.max(...e)+1,[o,a]=[new Float64Array(t*s),new Float64Array(t*s)];n.forEach((l,c)=>{if(r[c]>=
t)return;let h=r[c]*s+e[c];o[h]+=l,a[h]+=1});let i=o.map((l,c)=>a[c]?l/a[c]:0);return Float64Array.from({length:t},(l,c)=>{let h=i.subarray(c*s,(c+1)*s);return $n(
h)/a.subarray(c*s,(c+1)*s).filter(Boolean).length})}var ac=128,qe=8;function $n(r){let{length:e}=r;if(e>ac){let m=Math.floor(e/2)-Math.floor(e/2)%qe;return $n(r.
subarray(0,m))+$n(r.subarray(m))}if(e<qe)return r.reduce((m,p)=>m+p,0);let t=r.slice(0,qe),n=e-e%qe;for(let m=qe;m<n;m++)t[m%qe]+=r[m];let[s,o,a,i,l,c,h,u]=t;return r.
subarray(n).reduce((m,p)=>m+p,s+o+(a+i)+(l+c+(h+u)))}var T=["pursuer","evader"],$e=r=>r==="pursuer"?"evader":"pursuer";var Ua=({world:r})=>r.rules.teammate==="REACH"?.2:0;var Da=["generation","team","epoch","opponent","fitness_mean","fitness_std","fitness_best","capture_rate","length","pursuer_faults","evader_faults","matches","s\
teps"],Rr={pursuer:["random","clumsy-fleer"],evader:["random","clumsy-chaser"]},ic=20,lc=8,cc=-1,_r=({world:r,policy:e},t,n)=>({fov:r.fov,hidden:e.hidden,mask:e.
mask==="none"?null:t[n]}),Ze=class{settings;archive={pursuer:[],evader:[]};rows=[];cells=new Map;counters={pursuer:[],evader:[]};#e;#r;#t;#n={};#a=new Set;#s=0;#u=0;#m=0;constructor(e,t,n,s=La(
t.seed)){[this.#e,this.settings,this.#r,this.#t]=[e,t,n,s];for(let o of T){let{initial_weight:a,initial_head:i}=t.policy,l=s("initial",T.indexOf(o)),c=t.learner.
kind==="ga"?t.learner.population:1,h=Array.from({length:c},()=>Oa(this.shape(o),l,a,i));this.#d(o,h),this.archive[o].push(this.#n[o].genome)}this.#x(...T)}shape(e){
return _r(this.settings,this.#r,e)}get finished(){return Math.min(this.archive.pursuer.length,this.archive.evader.length)}*run(){yield*this.#b(0);for(let e=1;e<=
this.settings.schedule.generations;e++){if(this.settings.schedule.kind==="alternating")for(let t of T)yield*this.#h(t,e),this.#x(t);else yield*this.#l(e),this.#x(
...T);yield*this.#b(e)}}change(e){let t=this.settings,n={pursuer:this.shape("pursuer"),evader:this.shape("evader")},s=l=>JSON.stringify(l(t))===JSON.stringify(l(
e));this.settings=e;let o=s(l=>[l.world.fov,l.policy]);if(!o||!s(l=>l.learner))for(let l of T){let c=h=>Ra(h,n[l],this.shape(l));this.archive[l]=this.archive[l].
map(c),this.#d(l,this.#i(l).map(c))}if(o&&s(l=>l.world))return null;this.cells.clear(),this.#a.clear();let{pursuer:a,evader:i}=this.archive;return{type:"anew",settings:e,
genomes:{pursuer:a.slice(0,this.finished),evader:i.slice(0,this.finished)}}}#i(e){let t=this.#n[e];if(!(t instanceof Et))return[t.genome];let n=t.genome.length,
s=Array.from({length:t.population.length/n},(o,a)=>t.population.slice(a*n,(a+1)*n));return Array.from({length:this.settings.learner.population},(o,a)=>a===0?t.genome:
s[a%s.length])}#d(e,t){let{learner:n}=this.settings,[s,o]=[this.shape(e),n.kind==="ga"?n.mutation:n.sigma],a=Tn(s),i=new Cr(Ke(s),this.#t("noise",T.indexOf(e)),
o,a?.fixed??null),l=t.map(c=>Cn(c,a));this.#n[e]=n.kind==="ga"?new Et(Or(l),i,n):new kr(l[0],i,n)}*#h(e,t){for(let n=0;n<this.#o(e);n++){let s=this.archive[$e(e)].
length,o=this.settings.schedule[`${e}s_meet`],a=o==="latest"?s-1:o==="round-robin"?n%s:this.#t("opponents",T.indexOf(e),t,n).choice(s,1)[0],i=e==="pursuer"?[t,a]:
[a,t],l=this.#n[e],{groups:c}=l,h=Mt([this.settings.seed,...i,On[e],n],Math.max(...c)+1),u=l.ask(this.#t("learn",T.indexOf(e),t,n)),[m,p]=[Int32Array.from(c.keys()),
new Int32Array(c.length)],y={[e]:u,[$e(e)]:this.archive[$e(e)][a]},f={[e]:m,[$e(e)]:p},g=this.#f(y,f,BigUint64Array.from(c,S=>h[S])),v=this.#v(g,e);this.#w(g,v,
{generation:t,team:e,epoch:n,opponent:a}),l.tell(v),yield*this.#y(t,n,e)}this.archive[e].push(this.#n[e].genome)}*#l(e){for(let t=0;t<this.#o("pursuer");t++){let{
schedule:n,learner:{population:s}}=this.settings,[o,a]=n.kind==="hall-of-fame"?[n.hall_sample,n.contemporaries]:[0,1],i={pursuer:this.#c("pursuer",e,t),evader:this.#c(
"evader",e,t)},l=this.#t("opponents",0,e,t),c={pursuer:this.#p(o,l),evader:this.#p(o,l)},h=g=>Or([i[g],...Array.from(c[$e(g)],v=>this.archive[g][v])]),u=[c.evader.
length,c.pursuer.length],m=Ia(this.#n.pursuer.groups,a,u,l),p=Mt([this.settings.seed,e,e,On.both,t],Math.max(...m.group)+1),y={pursuer:h("pursuer"),evader:h("ev\
ader")},f=this.#f(y,m,BigUint64Array.from(m.group,g=>p[g]));for(let g of T){let v=Fa(m[g],m[$e(g)],s,this.#v(f,g));this.#w(f,v,{generation:e,team:g,epoch:t,opponent:cc}),
this.#n[g].tell(v)}yield*this.#y(e,t,"both")}for(let t of T)this.archive[t].push(this.#n[t].genome)}#c(e,t,n){return this.#n[e].ask(this.#t("learn",T.indexOf(e),
t,n))}#p(e,t){let n=this.archive.pursuer.length;return e?t.choice(n,Math.min(e,n)):new Int32Array(0)}#o(e){let{schedule:t}=this.settings;return t.kind==="hall-o\
f-fame"?t.joint_epochs:t[`${e}_epochs`]}*#y(e,t,n){let[s,o]=this.settings.schedule.kind==="hall-of-fame"?[this.#o("pursuer"),0]:[this.#o("pursuer"),this.#o("eva\
der")],a=t+1+(n==="evader"?s:0),i=s+o;yield{type:"epoch",done:(e-1)*i+a,of:this.settings.schedule.generations*i},yield*this.catchUp()}#f(e,t,n){let s={...this.settings.
world,max_steps:this.settings.train_steps},o=this.#e.rollouts(s,this.#g("pursuer",e.pursuer),this.#g("evader",e.evader),{...t,seed:n},1);this.#s+=o.length.length;
for(let a of o.length)this.#u+=Number(a);for(let a of o.agent_steps)this.#m+=Number(a);return o}#g(e,t){return At(this.shape(e),t)}#v({captured_fraction:e,overlap:t},n){
let s=Ua(this.settings);return Float64Array.from(e,(o,a)=>n==="pursuer"?o:1-o-s*Number(t[2*a+1]))}#w(e,t,n){let s=N(t),o=[0,0];e.faults.forEach((a,i)=>o[Math.floor(
i/3)%2]+=Number(a)),this.rows.push({...n,fitness_mean:s,fitness_std:Math.sqrt(N(t.map(a=>(a-s)**2))),fitness_best:Math.max(...t),capture_rate:N(e.capture_rate),
length:N(e.length),pursuer_faults:o[0]/e.length.length,evader_faults:o[1]/e.length.length,matches:this.#s,steps:this.#u})}#x(...e){for(let t of e)this.counters[t].
push({matches:this.#s,steps:this.#u,agent_steps:this.#m})}*#b(e){yield{type:"generation",number:e,genomes:{pursuer:this.archive.pursuer[e],evader:this.archive.evader[e]}},
yield*this.catchUp()}*catchUp(){for(let e=this.finished-1;e>=0;e--){for(let t=e;t>=0;t--)for(let[n,s]of t===e?[[e,e]]:[[e,t],[t,e]]){if(this.cells.has(`${n} ${s}`))
continue;let o=this.#A(n,s);this.cells.set(`${n} ${s}`,o),yield{type:"cell",cell:o}}this.#a.has(e)||(this.#a.add(e),yield{type:"scores",number:e,scores:{pursuer:this.#S(
"pursuer",e),evader:this.#S("evader",e)}})}}#A(e,t){let{world:n,evaluation_episodes:s,seed:o}=this.settings,a={pursuer:new Int32Array(1),evader:new Int32Array(1),
seed:BigUint64Array.of(Tr(o,e,t))},i=T.map(h=>this.#g(h,this.archive[h][h==="pursuer"?e:t])),l=this.#e.rollouts(n,...i,a,s),c=h=>{let u=Array.from(l[h],Number),
m=u.length/s;return Array.from({length:m},(p,y)=>N(u.filter((f,g)=>g%m===y)))};return{pursuer:e,evader:t,capture_rates:Array.from(l.capture_rate),lengths:Array.
from(l.length),means:{collisions:c("collisions"),faults:c("faults"),agent_steps:c("agent_steps"),survivors:c("survivors")}}}#S(e,t){let{world:n,seed:s}=this.settings,
[o,a]=[this.#g(e,this.archive[e][t]),new Int32Array(1)];return N(Rr[e].map((i,l)=>{let c=Mt([s,T.indexOf(e),l,lc],1),h=e==="pursuer"?[o,i]:[i,o],u=N(this.#e.rollouts(
n,...h,{pursuer:a,evader:a,seed:c},ic).capture_rate);return e==="pursuer"?u:1-u}))}};function Or(r){let e=new Float32Array(r.reduce((n,{length:s})=>n+s,0)),t=0;
for(let n of r)e.set(n,t),t+=n.length;return e}var Nn=r=>Array.from({length:r},()=>Array(r)),Pr=class{learning=T;settings=[];training={capture_rate:[],generation:[],learner:[],epochs:1,window:1,matches:0};limits="";name;schedule;seed;seeds;world;payoff;teams;findings=null;genomes={
pursuer:[],evader:[]};#e;#r;#t;constructor(e,t,n,s){[this.#t,this.#e,this.#r,this.name,this.schedule]=[e,t,s,n,n],[this.world,this.seed]=[e.world,String(e.seed)];
let o=e.schedule.generations+1;this.seeds=Array.from({length:o},(a,i)=>Array.from({length:o},(l,c)=>String(Tr(e.seed,i,c)))),this.payoff=this.#n(),this.teams=this.#a()}get newest(){
return this.genomes.pursuer.length-1}#n(){let e=this.#t.schedule.generations+1;return{first:[0,0],shape:[e,e],episodes:this.#t.evaluation_episodes,capture_rate:Nn(
e),capture_rates:Nn(e),lengths:Nn(e)}}#a(){let e=t=>{let n=`${this.#r} ${t}`;Ls(n,Or(this.genomes[t]));let{genome:s,...o}=At(_r(this.#t,this.#e,t),this.genomes[t][0]??
new Float32Array(0));return{script:null,network:{...o,genome_size:s.length},kept:[...this.genomes[t].keys()],genomes:n}};return{pursuer:e("pursuer"),evader:e("e\
vader")}}policy(e,t){return At(_r(this.#t,this.#e,e),this.genomes[e][t])}add(e){for(let t of T)this.genomes[t].push(e[t]);this.teams=this.#a()}change(e,t){this.#t=
e,this.world=e.world;for(let n of T)this.genomes[n]=[...t[n]];[this.payoff,this.teams,this.findings]=[this.#n(),this.#a(),null]}addCell({pursuer:e,evader:t,capture_rates:n,
lengths:s}){this.payoff.capture_rate[e][t]=N(n),this.payoff.capture_rates[e][t]=[...n],this.payoff.lengths[e][t]=[...s],this.findings={generalization:this.#s()}}#s(){
let e=this.payoff.capture_rate,t=o=>({mean:o,low:null,high:null}),n=o=>{let a=o.filter(i=>i!==void 0);return a.length?N(a):null},s=[...this.genomes.pursuer.keys()];
return{pursuers:t(s.map(o=>n(e[o]))),evaders:t(s.map(o=>n(e.map(a=>a[o]===void 0?void 0:1-a[o]))))}}};var Tt=r=>`${Math.round(100*r)} %`,uc=100,hc=0,$r=class extends EventTarget{element;newest;beginning;settings;state="waiting";done=0;seconds=0;#e;#r;#t;#n=d("h2",
{class:"lane-title"});#a=d("p",{class:"facts numbers"});#s=d("div",{class:"lane-room",hidden:!0});#u=d("section",{class:"card measures",hidden:!0});#m=d("div");#i;#d={
pursuer:[],evader:[]};#h=new Map;#l;#c;#p=()=>{};#o=0;#y=!0;#f=0;#g=null;constructor(e,t,n,s){super(),[this.#e,this.#r,this.#t,this.settings]=[e,t,n,s],this.newest=
new xt(()=>this.#S(this.#i.newest)),this.beginning=new xt(()=>this.#S(0)),this.beginning.element.classList.add("beginning");let o=d("div",{class:"boards"},this.
newest.element,this.beginning.element);this.element=d("section",{class:"lane"},this.#n,this.#a,o,this.#s,this.#u,this.#m),n.onmessage=({data:a})=>this.#w(a),this.
reset(s)}reset(e){this.#v({type:"stop"}),[this.settings,this.state,this.done]=[e,"waiting",0],this.#A();let{archive:t}=new Ze(this.#r,e,this.#e.masks);this.#i.add(
{pursuer:t.pursuer[0],evader:t.evader[0]}),this.#s.hidden=this.#u.hidden=!0,this.#E(!0),this.#M()}start(){this.#A(),[this.state,this.done]=["evolving",0],this.#s.
hidden=!1,this.#u.hidden=!0,this.#v({type:"start",settings:this.settings,masks:this.#e.masks}),this.#M()}stop(){this.#v({type:"stop"}),this.state==="evolving"&&
(this.state="stopped"),this.#M()}change(e){if(this.state==="waiting")return this.reset(e);this.settings=e,this.#v({type:"change",settings:e}),this.#M()}takeOver(){
let e=this.#i.newest;this.#c.play({run:0,pursuer:e,evader:e,episode:0,seed:null},{seat:this.#i.world.n_pursuers,from:0,moves:[]})}saved(){return new Promise(e=>{
this.#g=e,this.#v({type:"save"})})}get newestGeneration(){return this.#i.newest}close(){this.#t.terminate(),this.newest.runs=this.beginning.runs=!1}#v(e){this.#t.
postMessage(e)}#w(e){if(e.type==="generation"){if(this.state!=="evolving")return;this.#i.add(e.genomes),this.#E(e.number===0)}else if(e.type==="cell"){let{pursuer:t,
evader:n}=e.cell;this.#i.addCell(e.cell),this.#y&&t===n&&t===this.#i.newest&&this.#l.select({pursuer:t,evader:n}),this.#h.set(`${t} ${n}`,e.cell)}else if(e.type===
"scores")for(let t of T)this.#d[t][e.number]=e.scores[t];else e.type==="anew"?(this.#i.change(e.settings,e.genomes),this.#b(),this.#E(!0)):e.type==="epoch"?this.
done=e.done/e.of:e.type==="end"?(this.state==="evolving"&&([this.state,this.seconds,this.done]=["ended",e.seconds,1]),this.#T()):e.type==="saved"?this.#g?.(e.race):
(this.#a.textContent=`The race failed: ${e.message}`,this.state="stopped");this.#f||(this.#f=setTimeout(()=>requestAnimationFrame(()=>this.#x()),uc))}#x(){this.#f=
0,this.#l.dispatchEvent(new Event("run")),this.#p(),this.#M()}#b(){this.#h=new Map,this.#d={pursuer:[],evader:[]},this.#u.hidden=!0}#A(){let e=`race ${hc++}`,t=Ht(
this.settings);this.#i=new Pr(this.settings,this.#e.masks,t,e),this.#b(),this.#y=!0,this.#l=new xr({run:0,pursuer:0,evader:0,episode:0,seed:null});let[n,s]=[new wr(
[this.#i],this.#l),new gr([this.#i],this.#l,null)];n.element.ariaLabel=`Payoff matrix. ${t}`,this.#c=new Er([this.#i],this.#l,s,!1),this.#c.start(this.#r);let o=d(
"dialog",{class:"of-cell-match","aria-label":"Match",onclose:()=>s.player.pause()},d("button",{type:"button",class:"leave",onclick:()=>o.close()},"Close"),s.element),
a=!1;n.element.addEventListener("play",()=>{let{pursuer:l,evader:c}=this.#l.selected;this.#y=!1,this.#i.payoff.capture_rate[l][c]!==void 0&&(o.showModal(),a||s.
start(this.#r),a=!0,s.playSoon())});let i=Vs(`Scores against scripts, by generation: ${Rr.pursuer.join(", ")} and ${Rr.evader.join(", ")}`,(l,c)=>{let h=this.settings.
schedule.generations,u=js(l,c,{low:0,high:h,label:"generation",whole:!0},{low:0,high:1,label:"score"});for(let m of T){let p=Array.from(this.#d[m],y=>y??null);Hs(
u,[...p.keys()],p,`of-${m}s`)}return u},()=>{},l=>{let c=Math.min(this.#i.newest,Math.max(0,Math.round(l)));this.#l.select({pursuer:c,evader:c})});this.#p=i.redraw,
this.#s.replaceChildren(n.element,d("section",{class:"card scores"},d("h3",{},"Against opponents that never change"),d("p",{class:"small muted"},"Captures of ra\
ndom walkers and of clumsy fleers; escapes from random walkers and from clumsy chasers."),Gs(["pursuers","of-pursuers"],["evaders","of-evaders"]),i.element)),this.#m.
replaceChildren(o,this.#c.dialog)}#S(e){let t=this.#i.newest;if(t<0||e<0)return null;let{world:n,payoff:s,seeds:o}=this.#i,a=this.#o++%s.episodes;this.newest.title.
textContent=t?"Newest against newest":"Generation 0: nobody has learned anything yet",this.beginning.title.textContent="Pursuers of generation 0, newest evaders";
for(let c of[this.newest,this.beginning])c.generation=t;for(let c of[this.newest,this.beginning])c.label=`A match. ${c.title.textContent}`;let[i,l]=[this.#i.policy(
"pursuer",e),this.#i.policy("evader",t)];return this.#r.match(n,i,l,BigInt(o[e][t]),a)}#E(e){this.newest.renew(e),(this.#i.newest>0||this.state!=="waiting")&&this.
beginning.renew(e)}#M(){this.element.dataset.state=this.state,this.#n.textContent=Ht(this.settings);let e=this.#h.get(`${this.#i.newest} ${this.#i.newest}`)??this.#h.
get(`${this.#i.newest-1} ${this.#i.newest-1}`),t=e?[`Generation ${this.#i.newest} of ${this.settings.schedule.generations}`,`the newest pursuers catch ${Tt(N(e.
capture_rates))} of the newest evaders`,`${dc(e).toFixed(0)} collisions in 1000 moves`]:[];this.#a.replaceChildren(...t.map(n=>d("span",{},n))),this.dispatchEvent(
new Event("state"))}#T(){this.#u.ariaLabel=`What came out. ${Ht(this.settings)}`;let e=this.#i.payoff.capture_rate.slice(0,this.#i.newest+1).map(n=>n.slice(0,this.#i.
newest+1));if(e.length<2||e.some(n=>Array.from(n).includes(void 0)))return;let t=[["Score against scripts: generation 0",n=>Tt(this.#d[n][0]??0)],["Score agains\
t scripts: newest generation",n=>Tt(this.#d[n].at(-1)??0)],["Newest generation against all generations of the other team",n=>Tt(Ea(e,n))],["Below its own best s\
o far, in the later half (forgetting)",n=>Tt(Ta(e,n))]];this.#u.replaceChildren(d("h3",{},"What came out"),d("table",{class:"numbers"},d("thead",{},d("tr",{},d(
"td"),...T.map(n=>d("th",{scope:"col",class:n},`${n}s`)))),d("tbody",{},...t.map(([n,s])=>d("tr",{},d("th",{scope:"row"},n),...T.map(o=>d("td",{},s(o))))))),d("\
p",{class:"small muted"},"These are measures without a verdict: one race proves little. Save it, and ",d("code",{},"matrixworld judge")," weighs luck and says w\
hat happened.")),this.#u.hidden=!1}};function dc({means:{faults:r,agent_steps:e}}){let t=n=>n.reduce((s,o)=>s+o,0);return 1e3*t(r)/Math.max(1,t(e))}var Wa=r=>Ce(JSON.stringify(r,null,2)),Ln=(r,...e)=>({dtype:"<f8",shape:e,data:Float64Array.from(r)}),mc=r=>Math.sqrt(N(r.map(e=>(e-N(r))**2)));function pc({settings:r,
finished:e}){let t=r.schedule.kind==="alternating"?T.map(n=>[n]):[T];return Array.from({length:e},(n,s)=>(s?t:[T]).map(o=>[s,o])).flat()}function fc({archive:r,
rows:e,counters:t},n,[s,o]){let a=e.filter(c=>c.generation===s&&o.includes(c.team)),i=Ce(a.map(c=>`${[n,...Da.map(h=>c[h])].join(",")}
`).join("")),l=c=>({dtype:"<f4",shape:[1,r[c][s].length],data:r[c][s]});return{...Object.fromEntries(o.map(c=>[`${c}s`,l(c)])),log:{dtype:`|S${Math.max(1,i.length)}`,
shape:[],data:i.length?i:new Uint8Array(1)},...Object.fromEntries(Object.entries(t[o.at(-1)][s]).map(([c,h])=>[c,Ln([h])])),...n?{score:Ln([N(a.slice(Math.floor(
a.length/2)).map(c=>c.capture_rate))])}:{}}}function yc(r){let e=r.finished,t=Array.from({length:e*e},(o,a)=>r.cells.get(`${Math.floor(a/e)} ${a%e}`)),n=t[0].lengths.
length,s=(o,...a)=>Ln(t.flatMap(o),e,e,...a);return{scores:{dtype:"<f4",shape:[e,e,n],data:Float32Array.from(t.flatMap(({capture_rates:o})=>o))},mean:s(({capture_rates:o})=>N(
o)),std:s(({capture_rates:o})=>mc(o)),lengths:{dtype:"<i4",shape:[e,e,n],data:Int32Array.from(t.flatMap(({lengths:o})=>o))},collisions:s(({means:o})=>o.collisions,
2,3),faults:s(({means:o})=>o.faults,2,3),agent_steps:s(({means:o})=>o.agent_steps,2),pursuer_survivors:s(({means:o})=>o.survivors[0]),evader_survivors:s(({means:o})=>o.
survivors[1])}}function gc(r,{format:e,version:t}){let n=r.finished-1,s={...r.settings,schedule:{...r.settings.schedule,generations:n}},o={format:e,matrixworld:t,
settings:s,drawn_by:"page"},a=pc(r),{matches:i,steps:l,agent_steps:c}=r.counters.evader[n],h={training_matches:i,training_steps:l,training_agent_steps:c},u={stages:a.
length-1,...h,disengagement:[],evaluation_matches:r.finished**2*r.settings.evaluation_episodes};return{"config.json":Wa(o),...Object.fromEntries(a.map((m,p)=>[`\
stage-${String(p).padStart(4,"0")}.npz`,wt(fc(r,p,m))])),"payoff.npz":wt(yc(r)),"summary.json":Wa(u)}}function za(r,e){let t=r.flatMap(({name:n,race:s})=>Object.
entries(gc(s,e)).map(([o,a])=>[r.length>1?`${n}/${o}`:o,a]));return zt(Object.fromEntries(t))}var Ba=r=>r.finished>1&&r.cells.size>=r.finished**2&&T.every(e=>r.
archive[e].length);var vc=12;function ja(r){let e=new Blob([Ae("script-engine"),`
`,Ae(`script-${r}`)],{type:"text/javascript"});return new Worker(URL.createObjectURL(e))}function Ha(){let r=h=>postMessage(h),e=Nt(),t=null,n=null,s=0,o=!1,a=new MessageChannel,
i=()=>{let h=performance.now()+vc;for(;n&&performance.now()<h;){let{value:u,done:m}=n.next();m?(n=null,r({type:"end",seconds:(performance.now()-s)/1e3})):r(u)}!n||
o||(o=!0,a.port2.postMessage(null))},l=async h=>{if(h.type==="start")t=new Ze(await e,h.settings,h.masks),[n,s]=[t.run(),performance.now()],i();else if(h.type===
"stop")n=null;else if(h.type==="change"){let u=t?.change(h.settings);if(u&&r(u),!t||!u||n)return;n=t.catchUp(),i()}else if(t){let{settings:u,archive:m,rows:p,cells:y,
counters:f,finished:g}=t;r({type:"saved",race:{settings:u,archive:m,rows:p,cells:y,counters:f,finished:g}})}},c=h=>{Promise.resolve().then(h).catch(u=>{n=null,r(
{type:"failed",message:String(u)})})};a.port1.onmessage=()=>{o=!1,c(i)},globalThis.onmessage=({data:h})=>c(()=>l(h))}var bc=250,In=class{#e;#r;lanes=[];#t=d("div",{class:"lanes"});#n=d("button",{type:"button",class:"evolve",onclick:()=>this.#v()});#a=d("progress",{max:1,value:0,
"aria-label":"Progress of the race"});#s=d("p",{class:"small muted numbers",role:"status"});#u=d("button",{type:"button",class:"side",title:"A second race of th\
e same seed with another schedule",onclick:()=>this.#x()},"Side by side");#m=d("button",{type:"button","aria-pressed":"false",title:"Drag over the board to draw\
 walls, and over walls to remove them",onclick:()=>this.#S()},"Draw walls");#i=d("button",{type:"button",onclick:()=>this.#b({walls:[]})},"No walls");#d=d("butt\
on",{type:"button",onclick:()=>this.#E()});#h=d("span",{class:"small muted",role:"status"});#l=Ws((e,t)=>this.#b(e,t));#c=d("button",{type:"button",onclick:()=>{
this.#C()},title:"An archive that matrixworld judge, explore and replay read"},"Save");#p=[];#o;#y=0;constructor(e,t){[this.#e,this.#r,this.#o]=[e,t,Ds(e,location.
hash)];let n=d("div",{class:"doings",role:"group","aria-label":"What can be done"},this.#u,d("button",{type:"button",class:"to-play",title:"Play an evader again\
st the newest pursuers",onclick:()=>this.lanes[0].takeOver()},"Take over"),this.#m,this.#i,this.#d,this.#c,this.#h);document.getElementById("page").replaceWith(
ms("Evolve a chase","Triangles chase discs. Nobody has told either team how. Press Evolve, and both learn by trial and error, against each other."),d("main",{},
d("div",{class:"start"},this.#n,n,d("div",{class:"progress"},this.#a,this.#s)),this.#l.now,this.#t,this.#l.anew,d("div",{class:"card below"},Ft(),d("p",{class:"\
small muted"},"The page plays and learns with the engine of matrixworld, in this browser; nothing is sent."),d("p",{class:"small muted of-saving"},"A saved race\
 is an archive: ",d("code",{},"matrixworld judge"),", ",d("code",{},"explore")," and ",d("code",{},"replay")," read it. Python plays its matches again, and does\
 not continue it."))),d("footer",{class:"muted small"},`matrixworld ${e.version}`)),this.#g(),this.#M()}#f(){return[this.#o.schedule,...this.#o.beside?[this.#o.
beside]:[]]}#g(){for(let e of this.lanes.splice(0))e.close();for(let e of this.#f()){let t=new $r(this.#e,this.#r,ja("evolve"),qt(this.#e,this.#o,e));t.addEventListener(
"state",()=>this.#T()),this.lanes.push(t)}this.#p=this.lanes.map(e=>e.newest.drawWalls(([t,n],s)=>this.#A(t,n,s))),this.#m.ariaPressed="false",this.#t.dataset.count=
String(this.lanes.length),this.#t.replaceChildren(...this.lanes.map(({element:e})=>e)),this.#l.show(this.#o),this.#T()}#v(){this.lanes.some(({state:e})=>e==="ev\
olving")?this.lanes.forEach(e=>e.stop()):this.#w()}#w(){this.#h.textContent="";for(let[e,t]of this.#f().entries()){let n=this.lanes[e];n.settings=qt(this.#e,this.#o,
t),n.start()}}#x(){let e=this.#o.schedule==="specialist-specialist"?"generalist-generalist":"specialist-specialist";this.#b({beside:this.#o.beside?null:e},!0)}#b=(e,t=!1)=>{
let n=this.#f().length,s=this.lanes.every(({state:i})=>i==="waiting"),o={...this.#o,...e},a=Zt(o,Kt(this.#e));a||(this.#o=o),this.#l.show(this.#o),this.#h.textContent=
a,!a&&(Lt()&&history.replaceState(null,"",`#${Us(this.#o)}`),this.#f().length!==n&&this.#g(),t&&!s?this.#w():this.#f().forEach((i,l)=>this.lanes[l].change(qt(this.#e,
this.#o,i))))};#A(e,t,n){let{rows:s,cols:o}=this.lanes[0].settings.world,a={...this.#o,walls:Ut(this.#o.walls,e*o+t,n)},i=Zt(a,this.lanes[0].settings.world);if(i)
return i;let{walls:l}=this.#o=a,c=Uint8Array.from({length:s*o},(h,u)=>Number(l.includes(u)));for(let h of this.lanes)h.newest.show(c);return clearTimeout(this.#y),
this.#y=setTimeout(()=>this.#b({walls:l}),bc),""}#S(){let e=this.#m.ariaPressed!=="true";this.#m.ariaPressed=String(e);for(let t of this.#p)t(e)}#E(){let e=!this.
lanes[0].newest.runs;for(let{newest:t,beginning:n}of this.lanes)t.runs=n.runs=e;this.#M()}#M(){this.#d.textContent=this.lanes[0].newest.runs?"Pause boards":"Pla\
y boards"}#T(){if(!this.lanes.length)return;let e=this.lanes.map(({state:a})=>a),t=e.includes("evolving");document.body.dataset.state=e.every(a=>a==="waiting")?
"waiting":t?"evolving":"ended",this.#n.textContent=t?"Stop":e[0]==="waiting"?"Evolve":"Again",this.#u.ariaPressed=String(this.lanes.length>1),this.#i.hidden=!this.#o.
walls.length,this.#a.value=Math.min(...this.lanes.map(({done:a})=>a));let n=Math.max(...this.lanes.map(a=>a.seconds)),s=e.every(a=>a==="ended"),{seed:o}=this.#o;
this.#s.textContent=t?`Seed ${o}: generation ${this.lanes.map(a=>a.newestGeneration).join(" and ")}`:s?`Seed ${o}: the race took ${n.toFixed(1)} seconds.`:e.includes(
"stopped")?"Stopped.":""}async#C(){let e=await Promise.all(this.lanes.map(async n=>({name:ke(n.settings),race:await n.saved()})));if(!e.every(({race:n})=>Ba(n))){
this.#h.textContent="Wait for the next generation, and save then.";return}let t=`${e.map(n=>n.name).join("-and-")}-seed-${this.#o.seed}.zip`;It(t,za(e,this.#e)),
this.#h.textContent=`Saved as ${t}.`}};async function wc(){let r=new In(Fs(),await Nt());document.addEventListener("keydown",({key:e,target:t,ctrlKey:n,metaKey:s,
altKey:o})=>{let a=t instanceof HTMLInputElement||t instanceof HTMLSelectElement||document.querySelector("dialog[open]");e.toLowerCase()==="d"&&!a&&!n&&!s&&!o&&
Vr()}),window.addEventListener("hashchange",()=>location.reload()),Object.assign(window,{matrixworldEvolve:r})}typeof document>"u"?Ha():cs(wc());})();
