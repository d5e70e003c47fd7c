/* built from web/ by "npm run build"; sources da027045bad70d587dc1e27d3622aafe70454b913d4aaf34a3a651bd06adcc92 */
"use strict";(()=>{var Ln={SIMULTANEOUS:0,SWARM_TURNS:1,AGENT_TURNS:2},Qe={DISAPPEAR:0,REACH:1,BOUNCE:2},In={OCCUPATION:0,SURROUND:1},Fn={FAULT:0,INVOLVED:1};var $r=["obstacle","teammate","adversary"],Lr=["vertex","edge","chain"],Un=["turn","kind","form","first","second","row","col","at_fault","held","doomed"],Ir=["p\
ursuer_{number}","evader_{number}"],Dn={obstacle:"{first} ran into the obstacle or border at {cell}",vertex:"{first} and {second} both headed for {cell}",edge:"\
{first} and {second} meant to swap, {first} to {cell}",chain:"{first} headed for {cell}, where {second} had to stay"},et={"both held":"both bounce","both doomed":"\
both disappear",held:"{agent} bounces",doomed:"{agent} disappears",none:"nobody is stopped"},Wn="{event}: {outcome}",Fr={random:"any action, all equally likely",
still:"always stays",chaser:"moves to where the nearest adversary in view is nearest",fleer:"moves to where the nearest adversary in view is farthest","clumsy-c\
haser":"a chaser that takes any action in half of the steps",hunter:"a chaser of the nearest adversary in view to which no teammate in view is nearer",surrounder:"\
a chaser of the nearest free cell beside an adversary without a teammate","clumsy-fleer":"a fleer that takes any action in half of the steps",dodger:"moves to w\
here all adversaries in view together are farthest","team-surrounder":"shares the free cells beside adversaries with its teammates, and searches","careful-rando\
m":"as random, but takes only moves that right of way allows","careful-chaser":"as chaser, but takes only moves that right of way allows","careful-fleer":"as fl\
eer, but takes only moves that right of way allows","careful-clumsy-chaser":"as clumsy-chaser, but takes only moves that right of way allows","careful-hunter":"\
as hunter, but takes only moves that right of way allows","careful-surrounder":"as surrounder, but takes only moves that right of way allows","careful-clumsy-fl\
eer":"as clumsy-fleer, but takes only moves that right of way allows","careful-dodger":"as dodger, but takes only moves that right of way allows","careful-team-\
surrounder":"as team-surrounder, but takes only moves that right of way allows"},zn={free:".GS",blocked:"#@OTW"};var Le=1+Un.length;function tt(r,e){return r.replace(/\{(\w+)\}/g,(t,n)=>String(e[n]))}function Y(r,e){return r<e?tt(Ir[0],{number:r}):tt(Ir[1],{number:r-e})}function ja(r,e){
let[t,n,s,o,a,i,l,...u]=Array.from(r),h=a<0?[o]:[o,a],[c,d,m]=u.map(b=>h.filter((S,w)=>b>>w&1)),y=h.map(b=>Y(b,e)),f=tt(Dn[a<0?"obstacle":Lr[s]],{first:y[0],second:y[y.
length-1],cell:`(${i}, ${l})`}),g=tt(Wn,{event:f,outcome:Ha(h.length,d,m,e)});return{kind:$r[n],form:Lr[s],agents:h,cell:[i,l],at_fault:c,held:d,doomed:m,turn:t,
text:g}}function Ha(r,e,t,n){if(r===2&&e.length===2)return et["both held"];if(r===2&&t.length===2)return et["both doomed"];let s=o=>a=>tt(et[o],{agent:Y(a,n)});
return[...e.map(s("held")),...t.map(s("doomed"))].join(", ")||et.none}function kt(r,e){let t=[];for(let n=0;n<r.length;n+=Le)t.push(ja(r.subarray(n+1,n+Le),e));
return t}var ve=class extends Error{name="EngineError"};function F(r,e,t){let n=typeof t=="string"?`'${t}'`:typeof t=="object"?JSON.stringify(t):String(t);return new ve(
`${r}: expected ${e}, got ${n}`)}var Ie=class{bytes;constructor(e){this.bytes=e}},Hn=0,Dr=[Uint8Array,Uint8Array,Int32Array,BigInt64Array,BigUint64Array,Float32Array,Float64Array],Bn=4,jn=4,Ga=new TextEncoder,
Va=new TextDecoder;function Ya(r){for(let e=Dr.length-1;e>Hn;--e)if(r instanceof Dr[e])return e;throw new TypeError("array: expected a typed array of the engine\
's numbers, got another")}function Ur(r){return new Uint8Array(r.buffer,r.byteOffset,r.byteLength)}function Ka(r){return Ga.encode(`${r}\0`)}var Wr=class{engine;addresses=[];constructor(e){
this.engine=e}copy(e){let t=this.engine._malloc(Math.max(e.length,1));if(t===0)throw new ve("memory: expected room for the arguments, got none");return this.addresses.
push(t),this.engine.HEAPU8.set(e,t),t}text(e){return this.copy(Ka(e))}arrays(e){let t=Object.entries(e),n=t.flatMap(([o,a])=>{let i=a instanceof Ie,l=i?a.bytes:
a;return[this.text(o),i?Hn:Ya(l),l.length,this.copy(Ur(l))]}),s=this.copy(Ur(Int32Array.from(n)));return this.copy(Ur(Int32Array.of(t.length,s)))}free(){for(let e of this.
addresses)this.engine._free(e)}};function Gn(r,e){let t=r.HEAPU8;return Va.decode(t.subarray(e,t.indexOf(0,e)))}function Fe(r){let e=new Int32Array(r.HEAPU8.buffer),
t=r._last_outputs()/Bn,n=e[t+1]/Bn,s={};for(let o=n;o<n+e[t]*jn;o+=jn){let a=Dr[e[o+1]],i=e[o+2]*a.BYTES_PER_ELEMENT,l=e[o+3];s[Gn(r,e[o])]=new a(r.HEAPU8.slice(
l,l+i).buffer)}return s}function be(r,e){let t=new Wr(r);try{let n=e(t);if(n===0)throw new ve(Gn(r,r._last_error()));return n}finally{t.free()}}var qa=2**31-1,Vn=["none","gru"],Za=2n**64n-1n,Ja=34028234663852886e22;function pe(r,e){if(typeof e!="number"||!Number.isInteger(e)||Math.abs(e)>qa)throw F(r,"a\
n integer",e);return Int32Array.of(e)}function Ot(r,e){if(typeof e!="boolean")throw F(r,"true or false",e);return new Ie(Uint8Array.of(Number(e)))}function Me(r,e,t){
let n=typeof e=="string"&&Object.hasOwn(t,e)?t[e]:void 0;if(n===void 0)throw F(r,`one of ${Object.keys(t).join(", ")}`,e);return Int32Array.of(n)}function zr(r,e){
if(typeof e!="number"||!(Math.abs(e)<=Ja))throw F(r,"a finite number",e);return e}function rt(r,e){let n=typeof e=="bigint"||typeof e=="number"&&Number.isSafeInteger(
e)?BigInt(e):-1n;if(n<0n||n>Za)throw F(r,"an integer from 0 to 2^64 - 1",e);return BigUint64Array.of(n)}function Xa(r){return{"rules.interaction":Me("interactio\
n",r.interaction,Ln),"rules.obstacle":Me("obstacle",r.obstacle,Qe),"rules.teammate":Me("teammate",r.teammate,Qe),"rules.evader":Me("evader",r.evader,Qe),"rules.\
pursuer":Me("pursuer",r.pursuer,Qe),"rules.capture":Me("capture",r.capture,In),"rules.captured_disappear":Ot("captured_disappear",r.captured_disappear)}}function Yn(r,e){
let t=typeof e=="number"?[e,e,e]:e;if(!Array.isArray(t)||t.length!==3)throw F(r,"1 or 3 numbers",e);return Float32Array.from(t,n=>zr(r,n))}function Qa(r){let e=(t,n)=>Float32Array.
of(zr(t,r[t]),zr(n,r[n]));return{"rewards.capture":e("pursuer_capture","evader_capture"),"rewards.neighbor":e("pursuer_neighbor","evader_neighbor"),"rewards.ste\
p":e("pursuer_step","evader_step"),"rewards.pursuer_collide":Yn("pursuer_collide",r.pursuer_collide),"rewards.evader_collide":Yn("evader_collide",r.evader_collide),
"rewards.blame":Me("blame",r.blame,Fn),"rewards.capture_repeats":Ot("capture_repeats",r.capture_repeats)}}function qn(r){if(r===void 0||typeof r=="number")return new Uint8Array(
0);if(r instanceof Uint8Array)return r;let{free:e,blocked:t}=zn;for(let[n,s]of r.entries()){if(s.length!==r[0]?.length)throw F(`map, row ${n}`,`${r[0]?.length} \
cells as in row 0`,s.length);let o=[...s].find(a=>!e.includes(a)&&!t.includes(a));if(o)throw F(`map, row ${n}`,`'${e}' (free) or '${t}' (obstacle)`,o)}return Uint8Array.
from([...r.join("")],n=>Number(t.includes(n)))}function Zn(r,e){if(!Array.isArray(r))return;let t=[r.length,r[0]?.length??0];if(!(t[0]===e.rows&&t[1]===e.cols))
throw F("obstacle map",`shape (${e.rows}, ${e.cols}), the rows and cols`,t)}function Ue(r){Zn(r.obstacles,r);let e=typeof r.obstacles=="number"?r.obstacles:0;return{
...Xa(r.rules),...Qa(r.rewards),rows:pe("rows",r.rows),cols:pe("cols",r.cols),n_pursuers:pe("n_pursuers",r.n_pursuers),n_evaders:pe("n_evaders",r.n_evaders),fov:pe(
"fov",r.fov),diagonal:Ot("diagonal",r.diagonal),max_steps:pe("max_steps",r.max_steps),density:Float64Array.of(e),map:qn(r.obstacles)}}function Kn(r,e){return Int32Array.
from((e??[]).flat(),t=>pe(r,t)[0])}function Jn(r,e){return Zn(r.obstacles,e),{seed:rt("seed",r.seed??0n),episode:rt("episode",r.episode??0),pursuers:Kn("pursuer\
s",r.pursuers),evaders:Kn("evaders",r.evaders),map:qn(r.obstacles)}}function Rt(r){return{actions:Int32Array.from(r,e=>pe("actions",e)[0])}}function De(r){if(typeof r==
"string"){if(!Object.hasOwn(Fr,r))throw F("policy",`one of ${Object.keys(Fr).join(", ")}`,r);return{script:new TextEncoder().encode(r)}}if(r.activation!=="relu"&&
r.activation!=="tanh")throw F("activation","'relu' or 'tanh'",r.activation);if(!Vn.includes(r.memory))throw F("memory",`one of ${Vn.join(", ")}`,r.memory);return{
hidden:Int32Array.from(r.hidden,e=>pe("hidden",e)[0]),activation:new TextEncoder().encode(r.activation),sampled:Ot("sampled",r.sampled),memory:new TextEncoder().
encode(r.memory),genome:r.genome}}var ei=["first_turn","terminated","truncated"];function Xn(r){let e={...r};for(let t of ei)e[t]=new Ie(r[t]);return e}var Qn="statistics.",_t=class{config;seed;episode;n_agents;statistics;first_conflict;constructor(e,t,n,s){this.config=e,this.seed=t,this.episode=n,this.n_agents=
e.n_pursuers+e.n_evaders,this.statistics=ri(es(s)),Object.assign(this,s),this.first_conflict=ti(this.conflict_table,this.length)}get length(){return this.actions.
length/this.n_agents}conflicts(e){this.check(e);let[t,n]=[this.first_conflict[e],this.first_conflict[e+1]],s=this.conflict_table.subarray(t*Le,n*Le);return kt(s,
this.config.n_pursuers)}seek(e,t,n){this.check(t),(!(e.seed===this.seed&&e.episode===BigInt(this.episode))||e.turn!==0||e.steps>t)&&e.reset({seed:this.seed,episode:this.
episode});for(let o=e.steps;o<t;++o){let a=this.actions.subarray(o*this.n_agents,(o+1)*this.n_agents);n?e.replay(a,{pursuer:n.pursuers,evader:n.evaders}):e.step(
a)}}check(e){if(!(Number.isInteger(e)&&e>=0&&e<=this.length))throw F("step",`0 to ${this.length}`,e)}};function ti(r,e){let t=new Int32Array(e+2);for(let n=0;n<
r.length;n+=Le)++t[r[n]+1];for(let n=1;n<t.length;++n)t[n]+=t[n-1];return t}function ri(r){let e=["capture_rate","ever_capture_rate","captured_fraction","length"];
return Object.fromEntries(Object.entries(r).map(([t,n])=>[t,e.includes(t)?Number(n[0]):n]))}var es=r=>Object.fromEntries(Object.entries(r).flatMap(([e,t])=>e.startsWith(
Qn)?[[e.slice(Qn.length),t]]:[]));function ts(r,e,t,n){let s=[Ue(t.config),De(t.pursuers),De(t.evaders),n];return be(r,o=>{let[a,i,l,u]=s.map(h=>o.arrays(h));return r[e](
a,i,l,u)}),Fe(r)}function rs(r,e,t,n){let s={seed:rt("seed",t),episode:rt("episode",n)};return new _t(e.config,t,n,ts(r,"_play_match",e,s))}function ns(r,e,t,n){
if(!Number.isInteger(n)||n<1)throw F("n_episodes","at least 1",n);let s=ts(r,"_play_rollout",e,{...t,n_episodes:Int32Array.of(n)});return es(s)}var ni=7e6,si=new FinalizationRegistry(([r,e])=>r._states_free(e));function oi({rules:r,rows:e,cols:t,obstacles:n,diagonal:s,n_pursuers:o,n_evaders:a}){let i=typeof n==
"number"||r.obstacle==="REACH"?0:n.join("").split("#").length-1,l=e*t-i,u=[r.obstacle,r.teammate,r.pursuer].includes("DISAPPEAR"),h=r.capture==="SURROUND"||r.evader===
"REACH",c=r.interaction==="AGENT_TURNS",d=(f,g)=>Array.from({length:g},(b,S)=>c?f:(f+S)/(S+1)).reduce((b,S)=>b*S,1),m=d(l+Number(u),o)*d(l*(1+Number(h))+2,a);return{
SIMULTANEOUS:[o+a],SWARM_TURNS:[o,a],AGENT_TURNS:Array(o+a).fill(1)}[r.interaction].reduce((f,g)=>f+m*(s?9:5)**g,0)}function Pt(r){return typeof r.obstacles=="n\
umber"&&r.obstacles>0?"obstacles are drawn anew in each episode":oi(r)>ni?"the world is too large to be solved on the page":""}var Br=class{value;teams;matrix;n_actions;constructor(e,t){
let{matrix:n,rows:s,cols:o,value:a,agents:i}=t,[l,u]=e.actors,h=Array.from(i).filter(d=>l<=d&&d<u),c=d=>d<e.config.n_pursuers;[this.value,this.matrix,this.n_actions]=
[a[0],n,e.n_actions],this.teams=[{agents:h.filter(c),play:s},{agents:h.filter(d=>!c(d)),play:o}]}marginal(e){let t=this.teams.find(({agents:o})=>o.includes(e));
if(!t)return null;let n=this.n_actions**(t.agents.length-1-t.agents.indexOf(e)),s=Array(this.n_actions).fill(0);return t.play.forEach((o,a)=>s[Math.floor(a/n)%this.
n_actions]+=o),s}lost(e){let[t,n]=this.teams.map(({agents:l})=>l.reduce((u,h)=>u*this.n_actions+e[h],0)),[s,o]=this.teams.map(({play:l})=>l),a=o.reduce((l,u,h)=>l+
u*this.matrix[t*o.length+h],0),i=s.reduce((l,u,h)=>l+u*this.matrix[h*o.length+n],0);return[Math.max(0,this.value-a),Math.max(0,i-this.value)]}},jr=60,nt=class{config;payoff;engine;states;n_turns;values;constructor(e,t,n){
[this.engine,this.config,this.payoff]=[e,t,n],this.states=be(e,i=>e._states_new(i.arrays(Ue(t)))),si.register(this,[e,this.states]);let s={SIMULTANEOUS:1,SWARM_TURNS:2,
AGENT_TURNS:t.n_pursuers+t.n_evaders};this.n_turns=s[t.rules.interaction];let{payoffs:o}=this.call(()=>e._states_payoffs(this.states)),a=o;this.values=[[n==="ca\
pture-rate"?a:a.fill(0)]]}goBack(){let e=this.values.at(-1)[0],t=[];for(let s=this.n_turns-1;s>=0;s--){let o=t[s+1]??e;t[s]=this.backup(s,{next:o})}this.payoff===
"capture-time"&&(t[0]=t[0].map((s,o)=>o===this.config.n_evaders?0:s-1)),this.values.push(t);let n=this.payoff==="capture-rate"?this.config.max_steps:Math.min(this.
config.max_steps,jr);return this.values.length<=n&&t[0].some((s,o)=>s!==e[o])}backup(e,t){return this.call(n=>this.engine._states_backup(this.states,e,n.arrays(
t))).values}game(e){let[t,{turn:n}]=[this.config.max_steps-e.steps,e],s=n+1===this.n_turns,o=t>0?this.values[Math.min(t-Number(s),this.values.length-1)]?.[s?0:n+
1]:void 0;if(!o)return null;let a=this.call(i=>this.engine._states_game(this.states,e.address,i.arrays({next:o})));return a.agents.length?new Br(e,a):null}call(e){
return be(this.engine,e),Fe(this.engine)}};var ss=new FinalizationRegistry(([r,e])=>r._world_free(e)),st=class{config;n_agents;n_actions;engine;at;freed=!1;constructor(e,t){this.engine=e,this.config=t,this.
n_agents=t.n_pursuers+t.n_evaders,this.n_actions=t.diagonal?9:5,this.at=be(e,n=>e._world_new(n.arrays(Ue(t)))),ss.register(this,[e,this.at],this)}free(){this.freed||
(this.freed=!0,ss.unregister(this),this.engine._world_free(this.at))}get address(){if(this.freed)throw F("world","one that is in use","one that was freed");return this.
at}reset(e={}){let t=Jn(e,this.config);this.call(n=>this.engine._world_reset(this.address,n.arrays(t)))}step(e){let t=Rt(e);this.call(n=>this.engine._world_step(
this.address,n.arrays(t)))}playTurn(e){let t=Rt(e);this.call(n=>this.engine._world_play_turn(this.address,n.arrays(t)))}decide(e,t,n){let{n_pursuers:s}=this.config,
o={pursuer:[0,s],evader:[s,this.n_agents]},[a,i]=typeof t=="string"?o[t]:t;if(n.length!==this.n_agents)throw F("actions",String(this.n_agents),n.length);let l=[
De(e),Rt(n)],{actions:u}=this.call(h=>this.engine._world_decide(this.address,h.arrays(l[0]),a,i,h.arrays(l[1])));return Uint8Array.from(u)}replay(e,t){let n=o=>typeof o!=
"string"&&o.memory!=="none";if(!n(t.pursuer)&&!n(t.evader))return this.step(e);let{n_pursuers:s}=this.config;for(let o=this.n_turns;o>0;--o){let[a,i]=this.actors;
a<s&&this.decide(t.pursuer,[a,Math.min(i,s)],e),i>s&&this.decide(t.evader,[Math.max(a,s),i],e),this.playTurn(e)}}get n_turns(){return this.turnNumbers()[1]}get turn(){
return this.turnNumbers()[0]}get actors(){let[,,e,t]=this.turnNumbers();return[e,t]}turnNumbers(){return this.call(()=>this.engine._world_turn(this.address)).turn}get steps(){
return this.read("steps")[0]}get seed(){return this.read("seed")[0]}get episode(){return this.read("episode")[0]}get over(){return this.read("terminated")[0]===
1||this.read("truncated")[0]===1}read(e){return this.call(t=>this.engine._world_read(this.address,t.text(e)))[e]}view(e){let t=3*this.config.fov**2;return this.
read("views").slice(e*t,(e+1)*t)}map(){return this.read("state").slice(2*this.config.rows*this.config.cols)}conflicts(){return kt(this.conflictTable(),this.config.
n_pursuers)}conflictTable(){return this.call(()=>this.engine._world_conflicts(this.address)).conflict_table}answer(e,t){let n=De(e),{logits:s,memory:o}=this.call(
l=>this.engine._world_logits(this.address,l.arrays(n),t)),a=s,i=this.decide(e,[t,t+1],new Uint8Array(this.n_agents))[t];return{logits:a,probabilities:ai(a),action:i,
memory:o}}snapshot(){return this.call(()=>this.engine._world_snapshot(this.address))}restore(e){let t=Xn(e);this.call(n=>this.engine._world_restore(this.address,
n.arrays(t)))}call(e){return be(this.engine,e),Fe(this.engine)}};function ai(r){let e=Math.max(...r),t=Array.from(r,s=>Math.exp(s-e)),n=t.reduce((s,o)=>s+o,0);return Float32Array.
from(t,s=>s/n)}var Hr=class{compiled;constructor(e){this.compiled=e}world(e){return new st(this.compiled,e)}solution(e,t="capture-rate"){return new nt(this.compiled,e,t)}match(e,t,n,s,o=0){
return rs(this.compiled,{config:e,pursuers:t,evaders:n},s,o)}rollouts(e,t,n,s,o){return ns(this.compiled,{config:e,pursuers:t,evaders:n},s,o)}},os;function Nt(r=globalThis.
matrixworldEngine){return os??=ii(r),os}async function ii(r){if(!r)throw new Error("matrixworldEngine: expected the script engine.js before this one, got none");
let e=Uint8Array.from(atob(r.binary),t=>t.charCodeAt(0));return new Hr(await r({wasmBinary:e}))}var li="http://www.w3.org/2000/svg";function p(r,e={},...t){return as(document.createElement(r),e,t)}function v(r,e={},...t){return as(document.createElementNS(
li,r),e,t)}function as(r,e,t){for(let[s,o]of Object.entries(e))o==null||o===!1||(typeof o=="function"?r.addEventListener(s.slice(2),o):r.setAttribute(s,o===!0?"":
String(o)));let n=t.filter(s=>s!=null&&s!==!1);return r.append(...n.map(s=>typeof s=="number"?String(s):s)),r}function ne(r,e){let t=p("select",{onchange:()=>e(
t.value)},...r.map(([n,s])=>p("option",{value:n},s)));return t}async function is(r){try{await r}catch(e){throw(document.querySelector("#page, main")??document.body).
prepend(p("p",{class:"card problem",role:"alert"},`The page could not start: ${String(e)}`)),e}finally{document.body.dataset.ready="true"}}var $t=()=>["file:","\
http:","https:"].includes(location.protocol);var ls=r=>p("input",{type:"text",readonly:!0,"aria-label":r});function Lt(r,e){let t=URL.createObjectURL(new Blob([e],{type:"application/octet-stream"}));p("a",
{href:t,download:r}).click(),setTimeout(()=>URL.revokeObjectURL(t),6e4)}var us=()=>document.documentElement.dataset.theme==="dark",ot=r=>{document.documentElement.dataset.theme=r?"dark":"light"},Gr=()=>ot(!us());if(typeof document<"\
u"){let r=matchMedia("(prefers-color-scheme: dark)");r.addEventListener("change",()=>ot(r.matches)),ot(r.matches);let e=!1;addEventListener("beforeprint",()=>{e=
us(),ot(!1)}),addEventListener("afterprint",()=>ot(e))}function cs(){return p("button",{type:"button",title:"Light or dark (D)","aria-label":"Light or dark",onclick:Gr},
"◐")}var hs=(r,e,...t)=>p("header",{class:"top"},p("div",{},p("h1",{},r),e?p("p",{class:"lead"},e):null),p("div",{class:"tools"},...t,cs()));var ui=Array.from({length:16},(r,e)=>{let[t,n]=[e%2?6.5:11,Math.PI*e/8];return`${12+t*Math.sin(n)} ${12-t*Math.cos(n)}`}).join(" ");function It(){let r=[["pursu\
er",v("path",{d:"M12 3 22 20H2z",class:"filled-pursuer"})],["evader",v("circle",{cx:12,cy:12,r:9,class:"filled-evader"})],["capture",v("polygon",{points:ui,class:"\
filled-capture"})],["captured evader",v("circle",{cx:12,cy:12,r:7.5,class:"ring-evader"})],["conflict",v("rect",{x:3,y:3,width:18,height:18,class:"dashed-confli\
ct"})]];return p("ul",{class:"shapes small","aria-label":"Shapes on the board"},...r.map(([e,t])=>p("li",{},v("svg",{viewBox:"0 0 24 24","aria-hidden":"true"},t),
e)))}var se=(r,e)=>`${r}s of generation ${e}`,ie=["stay","north","east","south","west","northeast","southeast","southwest","northwest"];var ds="champion",ps=0,Vr=64,Yr=100;var ci=(r,e)=>Object.keys(r).every(t=>r[t]===e[t]);function ms(r,e){return Object.keys(e).find(t=>ci(e[t],r))??null}function fs(r,e,t){let n=new Set(r);return Array.
from({length:e},(s,o)=>Array.from({length:t},(a,i)=>n.has(o*t+i)?"#":".").join(""))}function Ft(r,e,t){let n=r.filter(s=>s!==e);return t?[...n,e].sort((s,o)=>s-
o):n}var P=Uint8Array,X=Uint16Array,rn=Int32Array,Ut=new P([0,0,0,0,0,0,0,0,1,1,1,1,2,2,2,2,3,3,3,3,4,4,4,4,5,5,5,5,0,0,0,0]),Dt=new P([0,0,0,0,1,1,2,2,3,3,4,4,5,5,6,
6,7,7,8,8,9,9,10,10,11,11,12,12,13,13,0,0]),Jr=new P([16,17,18,0,8,7,9,6,10,5,11,4,12,3,13,2,14,1,15]),xs=function(r,e){for(var t=new X(31),n=0;n<31;++n)t[n]=e+=
1<<r[n-1];for(var s=new rn(t[30]),n=1;n<30;++n)for(var o=t[n];o<t[n+1];++o)s[o]=o-t[n]<<5|n;return{b:t,r:s}},Ss=xs(Ut,2),As=Ss.b,Xr=Ss.r;As[28]=258,Xr[258]=28;var Ms=xs(
Dt,0),hi=Ms.b,ys=Ms.r,Qr=new X(32768);for(E=0;E<32768;++E)me=(E&43690)>>1|(E&21845)<<1,me=(me&52428)>>2|(me&13107)<<2,me=(me&61680)>>4|(me&3855)<<4,Qr[E]=((me&65280)>>
8|(me&255)<<8)>>1;var me,E,le=(function(r,e,t){for(var n=r.length,s=0,o=new X(e);s<n;++s)r[s]&&++o[r[s]-1];var a=new X(e);for(s=1;s<e;++s)a[s]=a[s-1]+o[s-1]<<1;
var i;if(t){i=new X(1<<e);var l=15-e;for(s=0;s<n;++s)if(r[s])for(var u=s<<4|r[s],h=e-r[s],c=a[r[s]-1]++<<h,d=c|(1<<h)-1;c<=d;++c)i[Qr[c]>>l]=u}else for(i=new X(
n),s=0;s<n;++s)r[s]&&(i[s]=Qr[a[r[s]-1]++]>>15-r[s]);return i}),we=new P(288);for(E=0;E<144;++E)we[E]=8;var E;for(E=144;E<256;++E)we[E]=9;var E;for(E=256;E<280;++E)
we[E]=7;var E;for(E=280;E<288;++E)we[E]=8;var E,lt=new P(32);for(E=0;E<32;++E)lt[E]=5;var E,di=le(we,9,0),pi=le(we,9,1),mi=le(lt,5,0),fi=le(lt,5,1),Kr=function(r){
for(var e=r[0],t=1;t<r.length;++t)r[t]>e&&(e=r[t]);return e},oe=function(r,e,t){var n=e/8|0;return(r[n]|r[n+1]<<8)>>(e&7)&t},qr=function(r,e){var t=e/8|0;return(r[t]|
r[t+1]<<8|r[t+2]<<16)>>(e&7)},nn=function(r){return(r+7)/8|0},sn=function(r,e,t){return(e==null||e<0)&&(e=0),(t==null||t>r.length)&&(t=r.length),new P(r.subarray(
e,t))};var yi=["unexpected EOF","invalid block type","invalid length/literal","invalid distance","stream finished","no stream handler",,"no callback","invalid UTF-8 da\
ta","extra field too long","date not in range 1980-2099","filename too long","stream finishing","invalid zip data"],K=function(r,e,t){var n=new Error(e||yi[r]);
if(n.code=r,Error.captureStackTrace&&Error.captureStackTrace(n,K),!t)throw n;return n},gi=function(r,e,t,n){var s=r.length,o=n?n.length:0;if(!s||e.f&&!e.l)return t||
new P(0);var a=!t,i=a||e.i!=2,l=e.i;a&&(t=new P(s*3));var u=function(Je){var Xe=t.length;if(Je>Xe){var $e=new P(Math.max(Xe*2,Je));$e.set(t),t=$e}},h=e.f||0,c=e.
p||0,d=e.b||0,m=e.l,y=e.d,f=e.m,g=e.n,b=s*8;do{if(!m){h=oe(r,c,1);var S=oe(r,c+1,3);if(c+=3,S)if(S==1)m=pi,y=fi,f=9,g=5;else if(S==2){var L=oe(r,c,31)+257,N=oe(
r,c+10,15)+4,A=L+oe(r,c+5,31)+1;c+=14;for(var x=new P(A),U=new P(19),I=0;I<N;++I)U[Jr[I]]=oe(r,c+I*3,7);c+=N*3;for(var B=Kr(U),ge=(1<<B)-1,q=le(U,B,1),I=0;I<A;){
var G=q[oe(r,c,ge)];c+=G&15;var w=G>>4;if(w<16)x[I++]=w;else{var D=0,R=0;for(w==16?(R=3+oe(r,c,3),c+=2,D=x[I-1]):w==17?(R=3+oe(r,c,7),c+=3):w==18&&(R=11+oe(r,c,
127),c+=7);R--;)x[I++]=D}}var V=x.subarray(0,L),W=x.subarray(L);f=Kr(V),g=Kr(W),m=le(V,f,1),y=le(W,g,1)}else K(1);else{var w=nn(c)+4,M=r[w-4]|r[w-3]<<8,O=w+M;if(O>
s){l&&K(0);break}i&&u(d+M),t.set(r.subarray(w,O),d),e.b=d+=M,e.p=c=O*8,e.f=h;continue}if(c>b){l&&K(0);break}}i&&u(d+131072);for(var Ze=(1<<f)-1,ee=(1<<g)-1,de=c;;de=
c){var D=m[qr(r,c)&Ze],Z=D>>4;if(c+=D&15,c>b){l&&K(0);break}if(D||K(2),Z<256)t[d++]=Z;else if(Z==256){de=c,m=null;break}else{var J=Z-254;if(Z>264){var I=Z-257,_=Ut[I];
J=oe(r,c,(1<<_)-1)+As[I],c+=_}var ae=y[qr(r,c)&ee],Pe=ae>>4;ae||K(3),c+=ae&15;var W=hi[Pe];if(Pe>3){var _=Dt[Pe];W+=qr(r,c)&(1<<_)-1,c+=_}if(c>b){l&&K(0);break}
i&&u(d+131072);var Ne=d+J;if(d<W){var Tt=o-W,Ct=Math.min(W,Ne);for(Tt+d<0&&K(3);d<Ct;++d)t[d]=n[Tt+d]}for(;d<Ne;++d)t[d]=t[d-W]}}e.l=m,e.p=de,e.b=d,e.f=h,m&&(h=
1,e.m=f,e.d=y,e.n=g)}while(!h);return d!=t.length&&a?sn(t,0,d):t.subarray(0,d)},fe=function(r,e,t){t<<=e&7;var n=e/8|0;r[n]|=t,r[n+1]|=t>>8},at=function(r,e,t){
t<<=e&7;var n=e/8|0;r[n]|=t,r[n+1]|=t>>8,r[n+2]|=t>>16},Zr=function(r,e){for(var t=[],n=0;n<r.length;++n)r[n]&&t.push({s:n,f:r[n]});var s=t.length,o=t.slice();if(!s)
return{t:Ts,l:0};if(s==1){var a=new P(t[0].s+1);return a[t[0].s]=1,{t:a,l:1}}t.sort(function(O,L){return O.f-L.f}),t.push({s:-1,f:25001});var i=t[0],l=t[1],u=0,
h=1,c=2;for(t[0]={s:-1,f:i.f+l.f,l:i,r:l};h!=s-1;)i=t[t[u].f<t[c].f?u++:c++],l=t[u!=h&&t[u].f<t[c].f?u++:c++],t[h++]={s:-1,f:i.f+l.f,l:i,r:l};for(var d=o[0].s,n=1;n<
s;++n)o[n].s>d&&(d=o[n].s);var m=new X(d+1),y=en(t[h-1],m,0);if(y>e){var n=0,f=0,g=y-e,b=1<<g;for(o.sort(function(L,N){return m[N.s]-m[L.s]||L.f-N.f});n<s;++n){
var S=o[n].s;if(m[S]>e)f+=b-(1<<y-m[S]),m[S]=e;else break}for(f>>=g;f>0;){var w=o[n].s;m[w]<e?f-=1<<e-m[w]++-1:++n}for(;n>=0&&f;--n){var M=o[n].s;m[M]==e&&(--m[M],
++f)}y=e}return{t:new P(m),l:y}},en=function(r,e,t){return r.s==-1?Math.max(en(r.l,e,t+1),en(r.r,e,t+1)):e[r.s]=t},gs=function(r){for(var e=r.length;e&&!r[--e];)
;for(var t=new X(++e),n=0,s=r[0],o=1,a=function(l){t[n++]=l},i=1;i<=e;++i)if(r[i]==s&&i!=e)++o;else{if(!s&&o>2){for(;o>138;o-=138)a(32754);o>2&&(a(o>10?o-11<<5|
28690:o-3<<5|12305),o=0)}else if(o>3){for(a(s),--o;o>6;o-=6)a(8304);o>2&&(a(o-3<<5|8208),o=0)}for(;o--;)a(s);o=1,s=r[i]}return{c:t.subarray(0,n),n:e}},it=function(r,e){
for(var t=0,n=0;n<e.length;++n)t+=r[n]*e[n];return t},Es=function(r,e,t){var n=t.length,s=nn(e+2);r[s]=n&255,r[s+1]=n>>8,r[s+2]=r[s]^255,r[s+3]=r[s+1]^255;for(var o=0;o<
n;++o)r[s+o+4]=t[o];return(s+4+n)*8},vs=function(r,e,t,n,s,o,a,i,l,u,h){fe(e,h++,t),++s[256];for(var c=Zr(s,15),d=c.t,m=c.l,y=Zr(o,15),f=y.t,g=y.l,b=gs(d),S=b.c,
w=b.n,M=gs(f),O=M.c,L=M.n,N=new X(19),A=0;A<S.length;++A)++N[S[A]&31];for(var A=0;A<O.length;++A)++N[O[A]&31];for(var x=Zr(N,7),U=x.t,I=x.l,B=19;B>4&&!U[Jr[B-1]];--B)
;var ge=u+5<<3,q=it(s,we)+it(o,lt)+a,G=it(s,d)+it(o,f)+a+14+3*B+it(N,U)+2*N[16]+3*N[17]+7*N[18];if(l>=0&&ge<=q&&ge<=G)return Es(e,h,r.subarray(l,l+u));var D,R,V,
W;if(fe(e,h,1+(G<q)),h+=2,G<q){D=le(d,m,0),R=d,V=le(f,g,0),W=f;var Ze=le(U,I,0);fe(e,h,w-257),fe(e,h+5,L-1),fe(e,h+10,B-4),h+=14;for(var A=0;A<B;++A)fe(e,h+3*A,
U[Jr[A]]);h+=3*B;for(var ee=[S,O],de=0;de<2;++de)for(var Z=ee[de],A=0;A<Z.length;++A){var J=Z[A]&31;fe(e,h,Ze[J]),h+=U[J],J>15&&(fe(e,h,Z[A]>>5&127),h+=Z[A]>>12)}}else
D=di,R=we,V=mi,W=lt;for(var A=0;A<i;++A){var _=n[A];if(_>255){var J=_>>18&31;at(e,h,D[J+257]),h+=R[J+257],J>7&&(fe(e,h,_>>23&31),h+=Ut[J]);var ae=_&31;at(e,h,V[ae]),
h+=W[ae],ae>3&&(at(e,h,_>>5&8191),h+=Dt[ae])}else at(e,h,D[_]),h+=R[_]}return at(e,h,D[256]),h+R[256]},vi=new rn([65540,131080,131088,131104,262176,1048704,1048832,
2114560,2117632]),Ts=new P(0),bi=function(r,e,t,n,s,o){var a=o.z||r.length,i=new P(n+a+5*(1+Math.ceil(a/7e3))+s),l=i.subarray(n,i.length-s),u=o.l,h=(o.r||0)&7;if(e){
h&&(l[0]=o.r>>3);for(var c=vi[e-1],d=c>>13,m=c&8191,y=(1<<t)-1,f=o.p||new X(32768),g=o.h||new X(y+1),b=Math.ceil(t/3),S=2*b,w=function(Nr){return(r[Nr]^r[Nr+1]<<
b^r[Nr+2]<<S)&y},M=new rn(25e3),O=new X(288),L=new X(32),N=0,A=0,x=o.i||0,U=0,I=o.w||0,B=0;x+2<a;++x){var ge=w(x),q=x&32767,G=g[ge];if(f[q]=G,g[ge]=q,I<=x){var D=a-
x;if((N>7e3||U>24576)&&(D>423||!u)){h=vs(r,l,0,M,O,L,A,U,B,x-B,h),U=N=A=0,B=x;for(var R=0;R<286;++R)O[R]=0;for(var R=0;R<30;++R)L[R]=0}var V=2,W=0,Ze=m,ee=q-G&32767;
if(D>2&&ge==w(x-ee))for(var de=Math.min(d,D)-1,Z=Math.min(32767,x),J=Math.min(258,D);ee<=Z&&--Ze&&q!=G;){if(r[x+V]==r[x+V-ee]){for(var _=0;_<J&&r[x+_]==r[x+_-ee];++_)
;if(_>V){if(V=_,W=ee,_>de)break;for(var ae=Math.min(ee,_-2),Pe=0,R=0;R<ae;++R){var Ne=x-ee+R&32767,Tt=f[Ne],Ct=Ne-Tt&32767;Ct>Pe&&(Pe=Ct,G=Ne)}}}q=G,G=f[q],ee+=
q-G&32767}if(W){M[U++]=268435456|Xr[V]<<18|ys[W];var Je=Xr[V]&31,Xe=ys[W]&31;A+=Ut[Je]+Dt[Xe],++O[257+Je],++L[Xe],I=x+V,++N}else M[U++]=r[x],++O[r[x]]}}for(x=Math.
max(x,I);x<a;++x)M[U++]=r[x],++O[r[x]];h=vs(r,l,u,M,O,L,A,U,B,x-B,h),u||(o.r=h&7|l[h/8|0]<<3,h-=7,o.h=g,o.p=f,o.i=x,o.w=I)}else{for(var x=o.w||0;x<a+u;x+=65535){
var $e=x+65535;$e>=a&&(l[h/8|0]=u,$e=a),h=Es(l,h+1,r.subarray(x,$e))}o.i=a}return sn(i,0,n+nn(h)+s)},wi=(function(){for(var r=new Int32Array(256),e=0;e<256;++e){
for(var t=e,n=9;--n;)t=(t&1&&-306674912)^t>>>1;r[e]=t}return r})(),xi=function(){var r=-1;return{p:function(e){for(var t=r,n=0;n<e.length;++n)t=wi[t&255^e[n]]^t>>>
8;r=t},d:function(){return~r}}};var Si=function(r,e,t,n,s){if(!s&&(s={l:1},e.dictionary)){var o=e.dictionary.subarray(-32768),a=new P(o.length+r.length);a.set(o),a.set(r,o.length),r=a,s.w=o.length}
return bi(r,e.level==null?6:e.level,e.mem==null?s.l?Math.ceil(Math.max(8,Math.min(13,Math.log(r.length)))*1.5):20:12+e.mem,t,n,s)},Cs=function(r,e){var t={};for(var n in r)
t[n]=r[n];for(var n in e)t[n]=e[n];return t};var z=function(r,e,t){for(;t;++e)r[e]=t,t>>>=8};var Ai=function(r,e){return((r[0]&15)!=8||r[0]>>4>7||(r[0]<<8|r[1])%31)&&K(6,"invalid zlib data"),(r[1]>>5&1)==+!e&&K(6,"invalid zlib data: "+(r[1]&32?"need":"u\
nexpected")+" dictionary"),(r[1]>>3&4)+2};function Mi(r,e){return Si(r,e||{},0,0)}function ks(r,e){return gi(r.subarray(Ai(r,e&&e.dictionary),-4),{i:2},e&&e.out,e&&e.dictionary)}var Os=function(r,e,t,n){for(var s in r){var o=r[s],a=e+s,i=n;Array.isArray(o)&&(i=Cs(n,o[1]),o=o[0]),o instanceof P?t[a]=[o,i]:(t[a+="/"]=[new P(0),i],Os(o,a,t,
n))}},bs=typeof TextEncoder<"u"&&new TextEncoder,Ei=typeof TextDecoder<"u"&&new TextDecoder,Ti=0;try{Ei.decode(Ts,{stream:!0}),Ti=1}catch{}function Ee(r,e){if(e){for(var t=new P(r.length),n=0;n<r.length;++n)t[n]=r.charCodeAt(n);return t}if(bs)return bs.encode(r);for(var s=r.length,o=new P(r.length+
(r.length>>1)),a=0,i=function(h){o[a++]=h},n=0;n<s;++n){if(a+5>o.length){var l=new P(a+8+(s-n<<1));l.set(o),o=l}var u=r.charCodeAt(n);u<128||e?i(u):u<2048?(i(192|
u>>6),i(128|u&63)):u>55295&&u<57344?(u=65536+(u&1047552)|r.charCodeAt(++n)&1023,i(240|u>>18),i(128|u>>12&63),i(128|u>>6&63),i(128|u&63)):(i(224|u>>12),i(128|u>>
6&63),i(128|u&63))}return sn(o,0,a)}var tn=function(r){var e=0;if(r)for(var t in r){var n=r[t].length;n>65535&&K(9),e+=n+4}return e},ws=function(r,e,t,n,s,o,a,i){var l=n.length,u=t.extra,h=i&&i.length,
c=tn(u);z(r,e,a!=null?33639248:67324752),e+=4,a!=null&&(r[e++]=20,r[e++]=t.os),r[e]=20,e+=2,r[e++]=t.flag<<1|(o<0&&8),r[e++]=s&&8,r[e++]=t.compression&255,r[e++]=
t.compression>>8;var d=new Date(t.mtime==null?Date.now():t.mtime),m=d.getFullYear()-1980;if((m<0||m>119)&&K(10),z(r,e,m<<25|d.getMonth()+1<<21|d.getDate()<<16|d.
getHours()<<11|d.getMinutes()<<5|d.getSeconds()>>1),e+=4,o!=-1&&(z(r,e,t.crc),z(r,e+4,o<0?-o-2:o),z(r,e+8,t.size)),z(r,e+12,l),z(r,e+14,c),e+=16,a!=null&&(z(r,e,
h),z(r,e+6,t.attrs),z(r,e+10,a),e+=14),r.set(n,e),e+=l,c)for(var y in u){var f=u[y],g=f.length;z(r,e,+y),z(r,e+2,g),r.set(f,e+4),e+=4+g}return h&&(r.set(i,e),e+=
h),e},Ci=function(r,e,t,n,s){z(r,e,101010256),z(r,e+8,t),z(r,e+10,t),z(r,e+12,n),z(r,e+16,s)};function Wt(r,e){e||(e={});var t={},n=[];Os(r,"",t,e);var s=0,o=0;for(var a in t){var i=t[a],l=i[0],u=i[1],h=u.level==0?0:8,c=Ee(a),d=c.length,m=u.comment,y=m&&
Ee(m),f=y&&y.length,g=tn(u.extra);d>65535&&K(11);var b=h?Mi(l,u):l,S=b.length,w=xi();w.p(l),n.push(Cs(u,{size:l.length,crc:w.d(),c:b,f:c,m:y,u:d!=a.length||y&&m.
length!=f,o:s,compression:h})),s+=30+d+g+S,o+=76+2*(d+g)+(f||0)+S}for(var M=new P(o+22),O=s,L=o-s,N=0;N<n.length;++N){var c=n[N];ws(M,c.o,c,c.f,c.u,c.c.length);
var A=30+c.f.length+tn(c.extra);M.set(c.c,c.o+A),ws(M,s,c,c.f,c.u,c.c.length,c.o,c.m),s+=16+A+(c.m?c.m.length:0)}return Ci(M,s,n.length,L,O),M}var We=["pursuer","evader"];function ze(r,e,t){let[n,s]=[e-r.payoff.first[0],t-r.payoff.first[1]],o=r.payoff.capture_rate[n]?.[s];return o===void 0?null:{rate:o,rates:r.payoff.capture_rates[n][s],
lengths:r.payoff.lengths[n][s]}}function zt(r,e,t){let{script:n,network:s,kept:o,genomes:a}=r.teams[e];if(n!==null||s===null)return"";if(!o.includes(t))return`T\
he page holds no genome of ${se(e,t)}: it would be too large. Choose a generation of ${o.join(", ")}.`;let i=o.length*s.genome_size;return Ps(a,s.genome_size).length===
i?"":`The page is damaged: it does not hold the ${i} numbers of the ${e}s' genomes. Write it again from its run.`}function te(r,e,t){let{script:n,network:s,kept:o,
genomes:a}=r.teams[e];if(n!==null||s===null)return n??"random";let i=o.indexOf(t);if(i<0)throw new RangeError(`${e}: expected a generation whose genome the page\
 holds, got ${t}`);let l=s.genome_size,u=Ps(a,l).subarray(i*l,(i+1)*l),{hidden:h,activation:c,sampled:d,memory:m}=s;return{hidden:h,activation:c,sampled:d,memory:m,
genome:u}}function Rs(r,e,{pursuer:t,evader:n,episode:s,seed:o}){let a=e.seeds[t][n];return r.match(e.world,te(e,"pursuer",t),te(e,"evader",n),BigInt(o??a),s)}var on=4,
an=new Map,_s=(r,e)=>{an.set(r,e)};function Ps(r,e){let t=an.get(r);if(t)return t;let n=new Float32Array;try{let s=Oi(ln(r),e);s.every(Number.isFinite)&&(n=s)}catch(s){
if(!(s instanceof DOMException||s instanceof RangeError||ki(s)))throw s}return an.set(r,n),n}var ki=r=>r instanceof Error&&"code"in r;function Oi(r,e){let t=ks(
r),n=t.length/on,s=new Uint8Array(t.length);for(let a=0;a<s.length;a++)s[a]=t[a%on*n+Math.floor(a/on)];let o=new Uint32Array(s.buffer);for(let a=e;a<o.length;a++)
o[a]^=o[a-e];return new Float32Array(s.buffer)}function ln(r){let e=atob(xe(r)),t=new Uint8Array(e.length);for(let n=0;n<t.length;n++)t[n]=e.charCodeAt(n);return t}
var xe=r=>document.getElementById(r)?.textContent??"";var Ns=()=>JSON.parse(xe("data")),ut={"specialist-specialist":"Specialists: both teams meet only the newest opponent","generalist-specialist":"Pursuers meet all\
 earlier evaders, evaders only the newest pursuers","generalist-generalist":"Generalists: both teams meet all earlier opponents","hall-of-fame":"Halls of fame: \
both teams learn at once, and meet earlier champions"};function Te({schedule:r}){if(r.kind==="hall-of-fame")return r.kind;let e={latest:"specialist","round-robi\
n":"generalist",uniform:"uniform"};return`${e[r.pursuers_meet]}-${e[r.evaders_meet]}`}var Bt=r=>ut[Te(r)]??Te(r);var jt=10,Ht=999999,un=[3,5,7,9,11],Gt=5,cn=[8,16,32,64],hn=[6,10,30,60,90,120];function Ri(r){let e=Object.values(r.races.es).find(a=>Te(a)==="generalist-gener\
alist"),{n_pursuers:t,n_evaders:n,fov:s,max_steps:o}=e.world;return{schedule:Te(e),beside:null,learner:"es",seed:e.seed,way:!1,population:0,pursuers:t,evaders:n,
view:s,steps:o,walls:[]}}var Vt=r=>Object.values(r.races.es)[0].world;function Yt(r,e,t=e.schedule){let n=r.races[e.learner][t],s=Vt(r),o={...s,n_pursuers:e.pursuers,
n_evaders:e.evaders,fov:e.view,max_steps:e.steps,obstacles:e.walls.length?fs(e.walls,s.rows,s.cols):s.obstacles};return{...n,world:o,train_steps:e.steps,seed:e.
seed,policy:{...n.policy,mask:e.way?"right-of-way":"none"},learner:{...n.learner,population:e.population||n.learner.population}}}function Kt({walls:r,pursuers:e,
evaders:t},{rows:n,cols:s}){let o=new Set(Array.from({length:n*s},(i,l)=>l).filter(i=>!r.includes(i)));if(o.size<e+t)return`There is no room: ${e+t} agents need\
 a free cell each.`;let a=[Math.min(...o)];o.delete(a[0]);for(let i of a){let l=i%s,u=[i-s,i+s,...l>0?[i-1]:[],...l<s-1?[i+1]:[]];a.push(...u.filter(h=>o.delete(
h)))}return o.size?"Nobody may be walled in: all free cells have to be connected, side by side.":""}function $s(r){let{walls:e,way:t,beside:n,...s}=r,o={...s,...n?
{beside:n}:{},...t?{way:1}:{},...e.length?{walls:e.join(".")}:{}};return Object.entries(o).map(([a,i])=>`${a}=${i}`).join("&")}function Ls(r,e){let t=new URLSearchParams(
e.replace(/^#/,"")),n=Ri(r),s=(c,d)=>{let m=t.get(c)??"";return/^\d{1,6}$/.test(m)&&d(Number(m))?Number(m):n[c]},o=c=>Object.hasOwn(ut,t.get(c)??"")?t.get(c):null,
a=Vt(r),i=(t.get("walls")??"").split(".").filter(c=>/^\d{1,4}$/.test(c)).map(Number),l=s("view",c=>un.includes(c)),u=t.get("way")==="1",h={schedule:o("schedule")??
n.schedule,beside:o("beside"),learner:t.get("learner")==="ga"?"ga":n.learner,seed:s("seed",c=>c<=Ht),pursuers:s("pursuers",c=>c>=1&&c<=jt),evaders:s("evaders",c=>c>=
1&&c<=jt),view:u?Math.max(Gt,l):l,way:u,population:s("population",c=>cn.includes(c)),steps:s("steps",c=>hn.includes(c)),walls:i.filter(c=>c<a.rows*a.cols).reduce(
(c,d)=>Ft(c,d,!0),[])};return Kt(h,a)?{...h,walls:[]}:h}function ue(r,e,t,n=""){return p("label",{class:`field ${n}`,title:e},p("span",{class:"field-name"},r),t,p("span",{class:"about small muted"},e))}function Is(r){
let e=Object.entries(ut),t=ne(e,f=>r({schedule:f})),n=ne([["","Nothing"],...e],f=>r({beside:f||null},!0)),s=Array.from({length:jt},(f,g)=>[g+1,String(g+1)]),o=ne(
s,f=>r({pursuers:Number(f)})),a=ne(s,f=>r({evaders:Number(f)})),i=ne(un.map(f=>[f,`${f} x ${f}`]),f=>r({view:Number(f),...Number(f)<Gt?{way:!1}:{}})),l=p("input",
{type:"checkbox",onchange:()=>r({way:l.checked,...l.checked?{view:Math.max(Gt,Number(i.value))}:{}})}),u=ne([[0,"usual"],...cn.map(f=>[f,String(f)])],f=>r({population:Number(
f)})),h=ne(hn.map(f=>[f,String(f)]),f=>r({steps:Number(f)})),c=ne([["es","evolution strategy"],["ga","genetic algorithm"]],f=>r({learner:f},!0)),d=p("input",{type:"\
number",min:0,max:Ht,step:1,inputmode:"numeric"});d.addEventListener("change",()=>r({seed:Math.min(Ht,Math.max(0,Math.round(Number(d.value))||0))},!0));let m=p(
"button",{type:"button",onclick:()=>r({seed:Math.floor(Math.random()*1e3)},!0)},"Another seed"),y=(f,...g)=>p("section",{class:"card controls","aria-label":f},p(
"fieldset",{},p("legend",{},f),...g));return{now:y("Change it while it evolves",ue("Opponents","whom the teams meet while they learn",t,"wide"),ue("Pursuers","t\
riangles",o),ue("Evaders","discs",a),ue("View","cells that an agent sees around itself",i),ue("Right of way","agents never take a move that could put them at fa\
ult",p("span",{},l)),ue("Population","candidates that are compared at a time",u),ue("Steps","of a match",h)),anew:y("Begin anew",ue("Side by side with","a secon\
d race of the same seed",n,"wide"),ue("Learner","how a team learns",c,"half"),ue("Seed","the luck of the race",p("span",{class:"seed"},d,m),"half")),show:f=>{[t.
value,n.value,i.value,c.value]=[f.schedule,f.beside??"",String(f.view),f.learner],[u.value,h.value,d.value,l.checked]=[String(f.population),String(f.steps),String(
f.seed),f.way],[o.value,a.value]=[String(f.pursuers),String(f.evaders)]}}}var Q=(r,e=2)=>r==null?"-":r.toFixed(e);function Fs(r,e,t){return e===null||t===null?Q(r):`${Q(r)} (${Q(e)} to ${Q(t)})`}var qt=r=>r.charAt(0).toUpperCase()+r.slice(1);function ct(r,e,t,n=!1){let s=(e-r)/Math.max(1,t),o=10**Math.floor(Math.log10(s||1)),a=[1,2,5,10].map(u=>u*o).find(
u=>u>=s)??10*o;n&&(a=Math.max(1,Math.round(a)));let i=Math.ceil(r/a-1e-9),l=Math.floor(e/a+1e-9);return Array.from({length:Math.max(0,l-i+1)},(u,h)=>(i+h)*a)}var Zt={left:46,right:12,top:10,bottom:42},Us={x:56,y:34};function Ws(r,e,t,n){let[s,o]=[Zt.left,Zt.top],a=Math.max(s+40,r-Zt.right),i=Math.max(o+40,e-Zt.bottom),
l=(f,g,b)=>S=>g+(S-f.low)/(f.high-f.low||1)*(b-g),[u,h]=[l(t,s,a),l(n,i,o)],c=v("g"),d=v("svg",{width:r,height:e,viewBox:`0 0 ${r} ${e}`,class:"plot"}),m=v("g",
{class:"axes"});for(let f of ct(n.low,n.high,(i-o)/Us.y,n.whole))m.append(v("line",{x1:s,x2:a,y1:h(f),y2:h(f),class:"grid"}),v("text",{x:s-8,y:h(f),"text-anchor":"\
end","dominant-baseline":"middle"},Ds(f)));for(let f of ct(t.low,t.high,(a-s)/Us.x,t.whole))m.append(v("text",{x:u(f),y:i+16,"text-anchor":"middle"},Ds(f)));return m.
append(v("line",{x1:s,x2:a,y1:i,y2:i,class:"axis"}),v("text",{x:(s+a)/2,y:e-6,"text-anchor":"middle",class:"label"},t.label),v("text",{transform:`translate(12 ${(o+
i)/2}) rotate(-90)`,"text-anchor":"middle",class:"label"},n.label)),d.append(m,c),{root:d,marks:c,left:s,right:a,top:o,bottom:i,x:u,y:h,at:f=>{let g=f-d.getBoundingClientRect().
left;return t.low+(g-s)/(a-s)*(t.high-t.low)}}}var Ds=r=>String(Number(r.toPrecision(6))).replace("-","−");function zs(r,e,t,n){let s="",o="M";t.forEach((a,i)=>{
a===null?o="M":(s+=`${o}${r.x(e[i]).toFixed(1)} ${r.y(a).toFixed(1)}`,o="L")}),r.root.insertBefore(v("path",{d:s,class:`line ${n}`}),r.marks)}function Bs(...r){return p("p",{class:"legend small"},...r.map(([e,t])=>p("span",{class:`key ${t}`},e)))}function js(r,e,t,n){let s=p("div",{class:"chart choose\
s",role:"img","aria-label":r}),o=null,a=()=>{o?.marks.replaceChildren(),o&&t(o)};s.addEventListener("click",l=>o&&n(o.at(l.clientX),o,l));let i=()=>{let{clientWidth:l,
clientHeight:u}=s;l<50||u<50||(o=e(l,u),s.replaceChildren(o.root),a())};return new ResizeObserver(i).observe(s),{element:s,update:a,redraw:i}}var Be=[[0,0],[-1,0],[0,1],[1,0],[0,-1],[-1,1],[1,1],[1,-1],[-1,-1]];function Hs(r,e,t){let[n,s]=[e[0]-r[0],e[1]-r[1]];return!t&&Math.abs(n)>Math.abs(s)?s=0:t||
(n=0),Be.findIndex(([o,a])=>o===Math.sign(n)&&a===Math.sign(s))}var Ce=(r,e)=>e<r.nPursuers,k=(r,e)=>[r.positions[2*e],r.positions[2*e+1]],dn=({rows:r,cols:e},[
t,n])=>t>=0&&n>=0&&t<r&&n<e,pn=(r,e,t=3)=>r!==void 0&&[0,1,2].slice(0,t).some(n=>r[3*e+n]),mn=(r,e)=>pn(r.fault,e),Gs=(r,e)=>!mn(r,e)&&pn(r.involved,e,2);function Jt(r,e,t){
let[n,s]=[k(r,t),k(e,t)],o=n[0]!==s[0]||n[1]!==s[1],a=e.involved===void 0||pn(e.involved,t);return!!(e.alive[t]&&e.actions?.[t]&&!o&&a)}function Xt(r,e,t){let[n,
s]=k(r,t),[o,a]=Be[e.actions?.[t]??0];return[n+o,s+a]}function ht(r,e,t){return Array.from({length:t.everCaptured.length},(s,o)=>o).filter(s=>t.everCaptured[s]&&
!e.everCaptured[s]).map(s=>r.nPursuers+s)}var Qt=r=>r.moments.flatMap((e,t)=>t&&ht(r,r.moments[t-1],e).length?[t]:[]);function er(r,e){return Array.from({length:e.
alive.length},(n,s)=>s).filter(n=>r.alive[n]&&!e.alive[n])}var Vs=[-.31,0,.31],Ys=[{size:1,at:[[0,0]]},{size:.62,at:[[-.2,.2],[.2,-.2]]},{size:.54,at:[[-.23,.22],[.23,.22],[0,-.22]]},{size:.54,at:[[-.23,.23],[.23,.23],[
-.23,-.23],[.23,-.23]]},{size:.36,at:Vs.flatMap(r=>Vs.map(e=>[e,r]))}],_i=.3,Pi=.35,Ni=.55;function dt(r,e){let t=new Map;for(let n=0;n<e.alive.length;n++){if(!e.
alive[n])continue;let[s,o]=k(e,n),a=s*r.cols+o,i=t.get(a);i?i.push(n):t.set(a,[n])}return t}function Ks(r,e){let t=Array.from(e.alive,(n,s)=>{let[o,a]=k(e,s);return{
x:a+.5,y:o+.5,size:1,alpha:0}});for(let n of dt(r,e).values()){let s=Ys[Math.min(n.length,Ys.length)-1];n.forEach((o,a)=>{let[i,l]=s.at[Math.min(a,s.at.length-1)],
u=t[o];u.x+=i,u.y+=l,u.size=s.size,u.alpha=1})}return t}var qs=r=>r*r*(3-2*r),je=(r,e,t)=>r+(e-r)*t,Zs=r=>Math.min(1,Math.max(0,r));function Js(r,e,t,n){let s={
SIMULTANEOUS:1,SWARM_TURNS:2,AGENT_TURNS:t}[r.interaction];if(s===1)return qs(n);let o=s===t?e:+!Ce(r,e),a=Math.max(1/s,Pi);return qs(Zs((n-o/(s-1)*(1-a))/a))}function tr(r,e){
let t=r.moments.length-1,n=Math.min(Math.floor(e),t),s=r.moments[n],o=Ks(r,s);if(n===t||e===n)return o;let a=r.moments[n+1],i=Ks(r,a);return o.map((l,u)=>{let h=Js(
r,u,o.length,e-n);return $i(s,a,u,l,i[u],h)})}function fn(r,e,t){let n=r.moments.length-1,s=Math.min(Math.floor(t),n),[o,a]=[r.moments[s],r.moments[Math.min(s+1,
n)]],i=Js(r,e,o.alive.length,t-s),[[l,u],[h,c]]=[k(o,e),k(a,e)];return[je(u,c,i)+.5,je(l,h,i)+.5]}function $i(r,e,t,n,s,o){let a=n.alpha>s.alpha,i={x:je(n.x,s.x,
o),y:je(n.y,s.y,o),size:a?n.size:je(n.size,s.size,o),alpha:a?Zs((1-o)/(1-Ni)):je(n.alpha,s.alpha,o)};if(Jt(r,e,t)){let[l,u]=k(r,t),[h,c]=Xt(r,e,t),d=_i*Math.sin(
Math.PI*o);i.x+=(c-u)*d,i.y+=(h-l)*d}return i}var Xs=2*Math.PI;function ke(r,e,t,n){r.beginPath(),r.arc(e,t,n/2,0,Xs)}function rr(r,e,t,n){let s=n/2,o=[[0,-.97],[.97,.83],[-.97,.83]].map(([a,i])=>[e+a*s,t+i*
s]);r.beginPath(),r.moveTo((o[2][0]+o[0][0])/2,(o[2][1]+o[0][1])/2),o.forEach(([a,i],l)=>{let[u,h]=o[(l+1)%3];r.arcTo(a,i,u,h,n*.09)}),r.closePath()}function Qs(r,e,t,n){
let s=n*.32;r.beginPath(),r.moveTo(e-s,t-s),r.lineTo(e+s,t+s),r.moveTo(e+s,t-s),r.lineTo(e-s,t+s)}function eo(r,e,t,n){r.beginPath();for(let s=0;s<16;s++){let o=n/
2*(s%2?.6:.95),a=Xs*s/16;r.lineTo(e+o*Math.sin(a),t-o*Math.cos(a))}r.closePath()}function to(r,e,t,n,s,o){let a=Math.atan2(s-t,n-e);r.beginPath(),r.moveTo(e,t),
r.lineTo(n,s);for(let i of[-1,1])r.moveTo(n,s),r.lineTo(n-o*Math.cos(a+i*.6),s-o*Math.sin(a+i*.6))}var ro=4,Li=1.6,Ii=.95,Fi=5,Ui=.16,Di=9,Wi=.09,zi=.2,no=.75,j=(r,e)=>r.left+e*r.cell,H=(r,e)=>r.top+e*r.cell;function He(r,e,t){return Ce(e,t)?r.colors.pursuer:
r.colors.evader}function nr({ctx:r,colors:e},t,n,s,o,a,i=0){r.font=`700 ${Math.round(o)}px system-ui, sans-serif`,r.textAlign="center",r.textBaseline="middle",r.
strokeStyle=e.paper,r.lineWidth=i,i&&r.strokeText(t,n,s),r.fillStyle=a,r.fillText(t,n,s)}function so({ctx:r,grid:e,colors:t}){let{left:n,top:s,cell:o,rows:a,cols:i}=e,
[l,u]=[i*o,a*o];if(r.fillStyle=t.paper,r.fillRect(n,s,l,u),o<Fi)return;r.fillStyle=t.line;let h=Math.max(1,Math.round(o/60));for(let c=1;c<i;c++)r.fillRect(n+c*
o,s,h,u);for(let c=1;c<a;c++)r.fillRect(n,s+c*o,l,h)}function oo({ctx:r,grid:e,colors:t},n){let{left:s,top:o,cell:a,rows:i,cols:l}=e;r.fillStyle=t.obstacle;for(let u=0;u<
i*l;u++){if(!n.obstacles[u])continue;let[h,c]=[Math.floor(u/l),u%l];r.fillRect(s+c*a,o+h*a,a,a)}ao({ctx:r,grid:e,colors:t})}function ao({ctx:r,grid:{left:e,top:t,
cell:n,rows:s,cols:o},colors:a}){let i=Math.min(5,Math.max(2,Math.round(n/18)));r.strokeStyle=a.frame,r.lineWidth=i,r.strokeRect(e-i/2,t-i/2,o*n+i,s*n+i)}function io({
ctx:r,grid:e,colors:t},n){let{left:s,top:o,cell:a,rows:i,cols:l}=e,u=a<24*n?5:1;r.font=`500 ${Math.round(Math.min(15*n,Math.max(9*n,a*.32)))}px system-ui, sans-\
serif`,r.fillStyle=t.muted,r.textBaseline="alphabetic",r.textAlign="center";let h=5*n+a/40;for(let c=0;c<l;c+=u)r.fillText(String(c),s+(c+.5)*a,o-h);r.textAlign=
"right",r.textBaseline="middle";for(let c=0;c<i;c+=u)r.fillText(String(c),s-h,o+(c+.5)*a)}function lo({grid:r},e,t,n){let s=Math.floor(e.fov/2)+.5,[o,a]=[Math.max(
0,t-s),Math.min(r.cols,t+s)],[i,l]=[Math.max(0,n-s),Math.min(r.rows,n+s)];return[j(r,o),H(r,i),(a-o)*r.cell,(l-i)*r.cell]}function uo(r,e,t,n){let{ctx:s,grid:o,
colors:a}=r;s.save(),s.beginPath(),s.rect(0,0,s.canvas.width,s.canvas.height),s.rect(...lo(r,e,t,n)),s.clip("evenodd"),s.clearRect(0,0,s.canvas.width,s.canvas.height),
s.fillStyle=a.line,s.fillRect(o.left,o.top,o.cols*o.cell,o.rows*o.cell),s.restore(),ao(r)}function co(r,{x:e,y:t,alpha:n},s){let{ctx:o,grid:a,colors:i}=r,l=Math.
max(a.cell,16*s)*1.06,[u,h]=[j(a,e),H(a,t)];o.globalAlpha=Math.max(n,.6),o.beginPath(),o.roundRect(u-l/2,h-l/2,l,l,l*.2),o.strokeStyle=i.focus,o.lineWidth=Math.
max(2,2.5*s),o.stroke();let c=Math.max(11*s,Math.min(18*s,a.cell*.5)),d=h-l/2<c*1.2,m=h+(d?1:-1)*(l/2+c*.7);o.lineJoin="round",nr(r,"You",u,m,c,i.ink,c*.35),o.globalAlpha=
1}function ho(r,e,t,n,s){let{ctx:o,grid:a}=r,i=lo(r,e,n,s),l=He(r,e,t);o.globalAlpha=.11,o.fillStyle=l,o.fillRect(...i),o.globalAlpha=.8,o.strokeStyle=l,o.lineWidth=
Math.max(1,a.cell/24),o.strokeRect(...i),o.globalAlpha=1}function po(r,e,t,n,s){let{ctx:o,grid:a}=r,i=Math.min(Math.ceil(t),e.moments.length-1),l=e.moments[i];o.
lineCap="round",o.lineWidth=Math.min(Di,Math.max(1,a.cell*Ui));for(let u=Math.max(1,Math.floor(t-n)+1);u<=i;u++){let[h,c]=[e.moments[u-1],e.moments[u]],d=Math.max(
0,Math.min(1,(t-u)/n));o.globalAlpha=no+(zi-no)*d;for(let m=0;m<c.alive.length;m++){let y=u===i&&t<i;if(!h.alive[m]||!(l.alive[m]||y))continue;let f=(Ce(e,m)?-1:
1)*Wi,[g,b]=k(h,m),[S,w]=k(c,m);if(g===S&&b===w)continue;let M=y?s[m].x:w+.5,O=y?s[m].y:S+.5;o.strokeStyle=He(r,e,m),o.beginPath(),o.moveTo(j(a,b+.5+f),H(a,g+.5+
f)),o.lineTo(j(a,M+f),H(a,O+f)),o.stroke()}}o.globalAlpha=1}function mo(r,e,t){let n=Math.min(Math.ceil(t),e.moments.length-1);for(let s=Math.max(1,n-ro+1);s<=n;s++){
let[o,a]=[e.moments[s-1],e.moments[s]],i=s>t?Math.max(0,1-2*(s-t)):1-(t-s)/ro,l=ht(e,o,a);for(let u of er(o,a))l.includes(u)||ji(r,k(a,u),i);for(let u of l)Bi(r,
k(a,u),i)}r.ctx.globalAlpha=1}function Bi({ctx:r,grid:e,colors:t},[n,s],o){r.globalAlpha=o,eo(r,j(e,s+.5),H(e,n+.5),Math.max(8,e.cell*Li)),r.fillStyle=t.capture,
r.fill(),r.strokeStyle=t.ink,r.lineWidth=Math.max(1,e.cell/36),r.lineJoin="round",r.stroke()}function ji({ctx:r,grid:e,colors:t},[n,s],o){r.globalAlpha=o,Qs(r,j(
e,s+.5),H(e,n+.5),Math.max(7,e.cell*Ii)),r.strokeStyle=t.collision,r.lineWidth=Math.max(2,e.cell*.17),r.lineCap="round",r.stroke()}function fo({ctx:r,grid:e,colors:t},n,s){
let o=Math.max(1,e.cell*.07);r.strokeStyle=r.fillStyle=t.collision,r.lineWidth=Math.max(1,e.cell*.05),r.setLineDash([e.cell*.14,e.cell*.1]);for(let[a,i]of n){if(a<
0||i<0||a>=e.rows||i>=e.cols)continue;let l=[j(e,i)+o,H(e,a)+o,e.cell-2*o,e.cell-2*o];r.globalAlpha=.2*s,r.fillRect(...l),r.globalAlpha=s,r.strokeRect(...l)}r.setLineDash(
[]),r.globalAlpha=1}function yo({ctx:r,grid:e,colors:t},n,s,o,a){r.globalAlpha=a,ke(r,j(e,n),H(e,s),Math.max(8,e.cell*o*1.02)),r.strokeStyle=t.collision,r.lineWidth=
Math.max(1.5,e.cell*.085*Math.sqrt(o)),r.stroke(),r.globalAlpha=1}var Hi=.8,Gi=.92,Vi=15,Yi=7,yn=9;function go(r,e,t,n,s,o){n.forEach((a,i)=>{a.alpha>0&&Ki(r,e,t,i,a,s,o)}),r.ctx.globalAlpha=1;for(let a of dt(e,t).values())a.length>
yn&&qi(r,n[a[yn-1]],a.length-yn+1)}function Ki(r,e,t,n,s,o,a){let{ctx:i,grid:l,colors:u}=r,h=Ce(e,n),[c,d]=[j(l,s.x),H(l,s.y)],m=Math.max(4,l.cell*s.size*(h?Gi:
Hi)),y=He(r,e,n),f=!h&&!!t.captured[n-e.nPursuers];if(i.globalAlpha=s.alpha,(h?rr:ke)(i,c,d,m),m>Yi*a&&(i.strokeStyle=u.paper,i.lineWidth=Math.max(2,m*.1),i.stroke()),
i.fillStyle=f?u.paper:y,i.fill(),f&&(ke(i,c,d,m*.82),i.strokeStyle=y,i.lineWidth=m*.18,i.stroke()),!o||m<Vi*a)return;let g=String(h?n:n-e.nPursuers),b=m*(h?.4:.5)*
(g.length>1?.8:1);nr(r,g,c,d+m*(h?.17:.03),b,f?y:u.paper)}function qi(r,e,t){let{cell:n}=r.grid;nr(r,`+${t}`,j(r.grid,e.x),H(r.grid,e.y),n*.3,r.colors.ink,n*.1)}var Zi=.46,Ji=.86,Xi=.66,vo=.48,Qi=.78,el=.58;function bo(r,e,t,n){let[s,o]=[e.moments[t-1],e.moments[t]];if(!s)return;let{ctx:a,grid:i,colors:l}=r;a.strokeStyle=
l.collision,a.lineWidth=Math.max(1.5,i.cell*.07),a.lineCap="butt",a.globalAlpha=n;for(let u=0;u<o.alive.length;u++)Jt(s,o,u)&&tl(r,e,k(s,u),Xt(s,o,u));a.globalAlpha=
1}function tl({ctx:r,grid:e},t,n,s){let[o,a]=[s[1]-n[1],s[0]-n[0]],i=c=>j(e,n[1]+.5+o*c),l=c=>H(e,n[0]+.5+a*c),u=dn(t,s)?Qi:el;r.setLineDash([e.cell*.09,e.cell*
.06]),r.beginPath(),r.moveTo(i(vo),l(vo)),r.lineTo(i(u),l(u)),r.stroke(),r.setLineDash([]);let h=.17*e.cell/Math.hypot(o,a);r.beginPath(),r.moveTo(i(u)-a*h,l(u)+
o*h),r.lineTo(i(u)+a*h,l(u)-o*h),r.stroke()}function wo(r,e,t,n,s,o){let a=Be[o];if(!o||!a)return;let{ctx:i,grid:l,colors:u}=r,h=dn(e,[n[0]+a[0],n[1]+a[1]])?Ji:
Xi,c=Zi*s.size,d=[j(l,s.x+a[1]*c),H(l,s.y+a[0]*c),j(l,s.x+a[1]*h),H(l,s.y+a[0]*h)],m=Math.max(1.5,l.cell*.085);i.lineCap=i.lineJoin="round";for(let[y,f]of[[u.paper,
m*2.1],[He(r,e,t),m]])i.strokeStyle=y,i.lineWidth=f,to(i,...d,l.cell*.2),i.stroke()}var So={numbers:!0,axes:!1,trail:6,viewers:[],plan:null,selected:null,cursor:null,you:null,fog:!1};function Ao(r,e,t,n,s){let{ctx:o,grid:a,colors:i}=r,l=Math.min(
Math.ceil(t),e.moments.length-1),u=e.moments[l],h=t===l,c=tr(e,t),d=h?1:Math.max(0,1-2*(l-t));o.clearRect(0,0,o.canvas.width,o.canvas.height),so(r);for(let f of n.
viewers)c[f]?.alpha&&ho(r,e,f,...fn(e,f,t));oo(r,e),n.axes&&io(r,s),po(r,e,t,n.trail,c),fo(r,u.contested??[],d),mo(r,e,t),bo(r,e,l,d),c.forEach(({x:f,y:g,size:b},S)=>{
let w=Gs(u,S)?.4:0,M=mn(u,S)?1:w;M&&yo(r,f,g,b,M*d)});let m=h?u:e.moments[Math.max(0,l-1)];if(go(r,e,m,c,n.numbers,s),h&&n.plan)for(let[f,g]of c.entries())g.alpha&&
wo(r,e,f,k(u,f),g,n.plan[f]??0);n.you!==null&&(n.fog&&uo(r,e,...fn(e,n.you,t)),co(r,c[n.you],s)),o.lineWidth=Math.max(2,2.5*s),o.strokeStyle=i.focus;let y=n.selected===
null?void 0:c[n.selected];y?.alpha&&xo(r,y.x,y.y,y.size*.96),n.cursor&&(o.setLineDash([a.cell*.12,a.cell*.08]),xo(r,n.cursor[1]+.5,n.cursor[0]+.5,.8),o.setLineDash(
[]))}function xo({ctx:r,grid:e},t,n,s){let o=s*e.cell;r.beginPath(),r.roundRect(e.left+t*e.cell-o/2,e.top+n*e.cell-o/2,o,o,o*.1),r.stroke()}var Mo=(r,e)=>(e+.24)/(r+.24);function Eo(r,e,t,n,s,o){let a=t?28*o:0,i=(u,h)=>(u-a)/(h+2*.12),l=Math.max(1,Math.floor(Math.min(i(n,e),i(s,r))));return{rows:r,cols:e,
cell:l,left:Math.round((n-e*l+a)/2),top:Math.round((s-r*l+a)/2)}}function To(r,e,t){let n=Math.floor((t-r.top)/r.cell),s=Math.floor((e-r.left)/r.cell);return n>=
0&&n<r.rows&&s>=0&&s<r.cols?[n,s]:null}var rl=["paper","line","frame","ink","muted","obstacle"],nl=["pursuer","evader","capture","collision","focus"];function sr(r){let e=getComputedStyle(r),t=(n,s)=>[
n,e.getPropertyValue(s+n).trim()];return Object.fromEntries([...rl.map(n=>t(n,"--board-")),...nl.map(n=>t(n,"--"))])}var ye=()=>matchMedia("(prefers-reduced-motion: reduce)").matches,Se=class{canvas;#e=null;#r=0;#t;#n={rows:1,cols:1,left:0,top:0,cell:1};#a=0;constructor(e,t={}){
this.canvas=e,e.classList.add("board"),e.setAttribute("role","img"),this.#t={...So,...t},new ResizeObserver(()=>this.#u()).observe(e),new MutationObserver(()=>this.
redraw()).observe(document.documentElement,{attributes:!0}),addEventListener("beforeprint",()=>this.drawNow())}set look(e){this.#t={...this.#t,...e},this.#s(),this.
redraw()}show(e,t){this.#e=e,this.#r=Math.min(Math.max(0,t),e.moments.length-1),this.#s(),this.redraw()}redraw(){this.#a||(this.#a=requestAnimationFrame(()=>this.
drawNow()))}drawNow(){cancelAnimationFrame(this.#a),this.#a=0;let e=this.canvas.getContext("2d");if(!e||!this.#e)return;let{rows:t,cols:n}=this.#e,s=devicePixelRatio||
1;this.#n=Eo(t,n,this.#t.axes,this.canvas.width,this.canvas.height,s);let o={ctx:e,grid:this.#n,colors:sr(this.canvas)};Ao(o,this.#e,this.#r,this.#t,s)}cellAt(e,t){
let n=this.canvas.getBoundingClientRect(),s=this.canvas.width/n.width;return To(this.#n,(e-n.left)*s,(t-n.top)*s)}agentAt(e,t){let n=this.cellAt(e,t);if(!n||!this.#e)
return null;let s=this.#e.moments[Math.round(this.#r)],o=dt(this.#e,s).get(n[0]*this.#e.cols+n[1])??[],a=tr(this.#e,Math.round(this.#r)),i=l=>{let[u,h]=this.pointOf(
a[l].x,a[l].y);return Math.hypot(u-e,h-t)};return o.length?o.reduce((l,u)=>i(u)<i(l)?u:l):null}pointOf(e,t){let n=this.canvas.getBoundingClientRect(),s=n.width/
this.canvas.width,{left:o,top:a,cell:i}=this.#n;return[n.left+(o+e*i)*s,n.top+(a+t*i)*s]}#s(){if(!this.#e)return;let{rows:e,cols:t}=this.#e;this.canvas.style.setProperty(
"--board-aspect",String(Mo(e,t)))}#u(){let e=devicePixelRatio||1,{width:t,height:n}=this.canvas.getBoundingClientRect();this.canvas.width=Math.max(1,Math.round(
t*e)),this.canvas.height=Math.max(1,Math.round(n*e)),this.drawNow()}};function gn(r,e,t){let{rows:n,cols:s,n_pursuers:o,fov:a,rules:{interaction:i}}=r;return{rows:n,cols:s,nPursuers:o,fov:a,interaction:i,obstacles:e,moments:t}}function vn(r,e){
return{positions:r.read("last_positions"),alive:r.read("alive"),captured:r.read("captured"),everCaptured:r.read("ever_captured"),actions:e,involved:r.read("invo\
lved"),fault:r.read("fault"),contested:r.conflicts().map(t=>t.cell)}}function or(r){let e=Array.from({length:r.length+1},(t,n)=>sl(r,n));return gn(r.config,r.map,
e)}function sl(r,e){let t=r.n_agents,n=r.config.n_evaders,s=(a,i,l)=>a.subarray(i*l,(i+1)*l),o={positions:s(r.last_positions,e,2*t),alive:s(r.alive,e,t),captured:s(
r.captured,e,n),everCaptured:s(r.ever_captured,e,n)};return e===0?o:{...o,actions:s(r.actions,e-1,t),involved:s(r.involved,e-1,3*t),fault:s(r.fault,e-1,3*t),get contested(){
return r.conflicts(e).map(a=>a.cell)}}}var pt=[.5,1,2,4,8,16,32,64],ar=0,ir=12,ol=2,Ae=class extends EventTarget{#e;#r;#t;#n=0;#a=0;#s=!1;#u=null;#h=0;#i=[];#p=[];glide=.28;constructor(e,{speed:t=4,still:n=!1}={}){
super(),[this.#e,this.#r,this.#t]=[e,t,n]}get step(){return this.#n}get time(){return this.#t?this.#n:this.#a}get arrived(){return this.#a===this.#n}get playing(){
return this.#s}get length(){return this.#e}set length(e){this.#e=e,this.#n>e&&this.jump(e),this.#o("state")}get marks(){return this.#i}set marks(e){this.#i=e,this.#o(
"state")}get ticks(){return this.#p}set ticks(e){this.#p=e,this.#o("state")}get pace(){return this.#r||Math.max(ol,this.#e/ir)}get speed(){return this.#r}set speed(e){
this.#r=e,this.#o("state")}changeSpeed(e){let t=pt.findIndex(n=>n>=this.pace);this.speed=pt[Math.min(pt.length-1,Math.max(0,t+e))]}play(){this.#s||!this.#e||(this.#n===
this.#e&&this.jump(0),this.#s=!0,this.#o("state"),this.#l())}pause(){this.#s&&(this.#s=!1,this.#o("state"))}toggle(){this.#s?this.pause():this.play()}move(e){this.
pause();let t=Math.min(this.#e,Math.max(0,this.#n+e));Math.abs(t-this.#a)>1?this.jump(t):this.#c(t),this.#l()}jump(e){this.#a=Math.min(this.#e,Math.max(0,Math.round(
e))),this.#c(this.#a),this.#o("frame")}#c(e){e!==this.#n&&(this.#n=e,this.#o("step"),this.#t&&this.#o("frame"))}#l(){this.#u===null&&(this.#h=performance.now(),
this.#u=requestAnimationFrame(()=>this.#m()))}#m(){this.#u=null;let e=performance.now();this.#d(Math.min(.25,(e-this.#h)/1e3)),this.#h=e,(!this.#t||this.arrived)&&
this.#o("frame"),(this.#s||this.#a!==this.#n)&&(this.#u=requestAnimationFrame(()=>this.#m()))}#d(e){let t=e;for(;t>0;){if(this.#a===this.#n){if(!this.#s)return;
if(this.#n===this.#e)return this.pause();this.#c(this.#n+1)}let n=this.#s?this.pace:1/this.glide,s=this.#n-this.#a,o=Math.min(Math.abs(s),t*n);t-=o/n,this.#a=o===
Math.abs(s)?this.#n:this.#a+Math.sign(s)*o}this.#s&&this.#a===this.#e&&this.pause()}#o(e){this.dispatchEvent(new Event(e))}};function lr(r,e){if(e.ctrlKey||e.metaKey||
e.altKey)return!1;let t=e.shiftKey?10:1,s={" ":()=>r.toggle(),ArrowRight:()=>r.move(t),ArrowLeft:()=>r.move(-t),Home:()=>r.move(-r.length),End:()=>r.move(r.length),
"+":()=>r.changeSpeed(1),"-":()=>r.changeSpeed(-1)}[e.key];return s?.(),s!==void 0}var al={first:"M6 5v14M19 5 9 12l10 7z",back:"M17 5 7 12l10 7z",play:"M7 4.5 19 12 7 19.5z",pause:"M8 5v14M16 5v14",forward:"M7 5l10 7-10 7z",last:"M18 5v14M5 5\
l10 7-10 7z"};function Co(r){return v("svg",{viewBox:"0 0 24 24","aria-hidden":"true",class:"icon"},v("path",{d:al[r]}))}function mt(r,e,t,n){return p("button",
{type:"button",class:"player-button","aria-label":e,title:`${e} (${t})`,onclick:n},Co(r))}function ur(r){let e=mt("play","Play","Space",()=>r.toggle()),t=p("inp\
ut",{type:"range",class:"player-scrub",min:0,step:1,"aria-label":"Step",oninput:()=>{r.pause(),r.jump(Number(t.value))}}),n=p("div",{class:"captures","aria-hidd\
en":"true",title:"Captures"}),s=p("div",{class:"losses","aria-hidden":"true"}),o=p("select",{class:"player-speed","aria-label":"Speed",title:`Steps a second, or\
 the whole in ${ir} s (+ and -)`,onchange:()=>r.speed=Number(o.value)},p("option",{value:ar},`in ${ir} s`),...pt.map(c=>p("option",{value:c},`${c} / s`))),a=p("\
output",{class:"player-count"}),i=p("div",{class:"player",role:"group","aria-label":"Player"},mt("first","First step","Home",()=>r.move(-r.length)),mt("back","S\
tep back","←",()=>r.move(-1)),e,mt("forward","Step forward","→",()=>r.move(1)),mt("last","Last step","End",()=>r.move(r.length)),p("div",{class:"scrub"},n,s,
t),a,o),l=(c,d={})=>{let m=p("i",d);return m.style.left=`${100*c/Math.max(1,r.length)}%`,m},u=()=>{n.replaceChildren(...r.marks.map(c=>l(c))),s.replaceChildren(
...r.ticks.map(({step:c,kind:d,size:m,text:y})=>{let f=l(c,{class:d,title:`Step ${c}: ${y}`});return f.style.height=`${100*m}%`,f}))},h=()=>{e.replaceChildren(Co(
r.playing?"pause":"play")),e.ariaLabel=r.playing?"Pause":"Play",e.title=`${e.ariaLabel} (Space)`,t.max=String(r.length),t.value=String(r.step),t.ariaValueText=`\
step ${r.step} of ${r.length}`,a.textContent=`${r.step} / ${r.length}`,a.style.minWidth=`${2*String(r.length).length+3}ch`,o.value=String(r.speed)};return r.addEventListener(
"step",h),r.addEventListener("state",h),r.addEventListener("state",u),i.addEventListener("keydown",c=>{!(c.target instanceof HTMLSelectElement||c.key===" "&&c.target!==
t)&&lr(r,c)&&c.preventDefault()}),h(),i}var il=40,cr=class{element;#e;#r=p("div",{class:"episodes",role:"group","aria-label":"Episodes of this cell"});#t=p("p",{class:"check small numbers","aria-live":"\
polite"});constructor(e){this.#e=e,this.element=p("div",{class:"strip-of-episodes"},this.#r,this.#t)}show(e,t){let{pursuer:n,evader:s,episode:o,seed:a}=this.#e.
selected,i=ze(e,n,s);this.#r.replaceChildren(...(i?.rates??[]).slice(0,il).map((d,m)=>this.#n(d,m)));let l=a===null?i?.rates[o]:void 0,u=t.statistics.capture_rate,
h=l!==void 0&&Math.abs(u-l)<1e-6&&t.length===i?.lengths[o],c=i?"Not an episode of the evaluation":"The evaluation played no episodes of this pair.";this.#t.dataset.
equal=String(h),this.#t.textContent=h?"As in the evaluation":l===void 0?c:`Episode ${o+1} differs from the evaluation.`,this.#t.title=`Played here: capture rate\
 ${Q(u,3)} in ${t.length} steps.${i?` The cell says ${Q(i.rate,3)}.`:""}`}#n(e,t){let{selected:n}=this.#e,s=p("span",{class:"bar"});return s.style.height=`${Math.
round(100*e)}%`,p("button",{type:"button",class:"episode",title:`Episode ${t+1}: capture rate ${Q(e)}`,"aria-label":`Episode ${t+1}, capture rate ${Q(e)}`,"aria\
-pressed":String(t===n.episode&&n.seed===null),onclick:()=>this.#e.select({episode:t,seed:null})},s,p("span",{class:"count"},t+1))}};var ko=0,Oo=1,ll=2,ul=176;function _o(r,e,t,n){let s=devicePixelRatio||1,o=sr(r);r.width=r.height=ul*s;let a=r.getContext("2d");if(!a)return;let{fov:i}=e,l=r.width/
i;a.fillStyle=o.paper,a.fillRect(0,0,r.width,r.height);for(let h=0;t&&h<i*i;h++){let[c,d]=[(h%i+.5)*l,(Math.floor(h/i)+.5)*l],m=f=>!!t[f*i*i+h];m(ll)&&(a.fillStyle=
o.obstacle,a.fillRect(c-l/2,d-l/2,l,l));let y=m(ko)&&m(Oo)?l*.18:0;m(ko)&&Ro(a,ke,c+y,d+y,l*.74,o.evader),m(Oo)&&Ro(a,rr,c-y,d-y,l*.86,o.pursuer)}a.strokeStyle=
n<e.n_pursuers?o.pursuer:o.evader,a.lineWidth=2*s;let u=Math.floor(i/2)*l;a.strokeRect(u,u,l,l)}function Ro(r,e,t,n,s,o){e(r,t,n,s),r.fillStyle=o,r.fill()}var Po="What it remembers: a number for each unit, from -1 to 1",hr=class{element;#e;#r=p("canvas",{class:"seen",role:"img"});#t=p("h3");#n=p("p",{class:"small \
muted"});#a=p("div",{class:"answers"});#s=p("div",{title:Po});#u=null;#h=null;#i=null;#p=null;#c=null;#l=null;#m=0;constructor(e){this.#e=e,this.element=p("div",
{class:"inspector","data-open":"false"},p("p",{class:"hint small muted"},"Click an agent, or press A: what it sees, and what its network answers."),p("div",{class:"\
inspected"},this.#r,p("div",{class:"answer"},this.#t,this.#n,this.#s),this.#a))}get agent(){return this.#l}show(e,t,n,s){this.#u?.free(),this.#u=e.world(n.config),
this.#i!==t&&(this.#h=null,this.#l!==null&&this.choose(null)),[this.#i,this.#p,this.#c]=[t,n,s]}set solution(e){this.#h=e,this.at(this.#m)}choose(e){this.#l=e,this.
element.dataset.open=String(e!==null),this.#e(e),this.at(this.#m)}next(e){let t=this.#p;if(!t)return;let n=this.#l??(e>0?-1:0);for(let s=0;s<t.n_agents;s++)if(n=
(n+e+t.n_agents)%t.n_agents,t.alive[this.#m*t.n_agents+n])return this.choose(n)}at(e){this.#m=e;let[t,n,s,o,a]=[this.#p,this.#u,this.#i,this.#c,this.#l];if(!t||
!n||!s||!o||a===null)return;let i=a<t.config.n_pursuers?"pursuer":"evader";this.#s.replaceChildren(),this.#t.replaceChildren(p("span",{class:i},Y(a,t.config.n_pursuers)));
let l={pursuers:te(s,"pursuer",o.pursuer),evaders:te(s,"evader",o.evader)};t.seek(n,e,l);let u=t.actions.subarray(e*t.n_agents,(e+1)*t.n_agents);for(;u.length&&
!n.over&&(a<n.actors[0]||a>=n.actors[1]);)n.playTurn(u);let h=!!(t.alive[e*t.n_agents+a]&&n.read("alive")[a]);_o(this.#r,t.config,h?n.view(a):null,a),this.#r.ariaLabel=
`Field of view of ${Y(a,t.config.n_pursuers)}: evaders, pursuers and obstacles around it`;let c=u[a]??null;if(!h)return this.#d([],"It is gone.");let d=l[`${i}s`],
m=typeof d=="string"?null:n.answer(d,a),y=m?.probabilities??null;m?.memory.length&&this.#s.replaceChildren(p("p",{class:"small muted"},"It remembers:"),dl(m.memory));
let f=this.#h?.game(n)??null,g=typeof d=="string"?`The script "${d}" plays for it${c===null?"":`; it goes ${ie[c]}`}.`:d.sampled?"Its action is drawn from these\
 probabilities.":"It takes the most probable action.",b=[["network",y],["perfect",f?.marginal(a)??null]],S=w=>p("p",{class:"small muted"},w);this.#d([...f?[S(`V\
alue ${f.value.toFixed(2)} under perfect play.`)]:[],...cl(b,c)],c===null?"The episode is over.":g)}#d(e,t){this.#a.replaceChildren(...e),this.#n.textContent=t}};
function cl(r,e){let t=r.filter(([,o])=>o);if(!t.length)return[];let n=p("div",{class:"action muted"},p("span"),...t.map(([o])=>p("span",{class:"head"},o))),s=Array.
from(t[0][1],(o,a)=>p("div",{class:a===e?"action taken":"action"},p("span",{},ie[a]),...t.flatMap(([,i])=>hl(i[a]))));return t.length>1||t[0][0]!==r[0][0]?[n,...s]:
s}function hl(r){let e=p("span",{class:"filled"});return e.style.width=`${100*r}%`,[p("span",{class:"track"},e),p("span",{class:"numbers"},r.toFixed(2))]}function dl(r){
let e=Array.from(r,t=>{let n=p("span",{title:t.toFixed(2)});return n.style.transform=`scaleY(${t})`,n});return p("div",{class:"units",role:"img","aria-label":Po},
...e)}function No(r){let e=JSON.stringify(r,(t,n)=>t==="genome"?Array.from(n):n);return p("script",{type:"application/json",id:"champions"},e.replaceAll("<","\\u003c")).
outerHTML}var ft="_",pl="n",Mh=2n**64n-1n;var bn={fov:11,maxSteps:500,rewards:"paper"},ml=["rules","others","rewards","size","diagonal","fov","limit","seed","ended","walls","pursuers","evaders","played",
"next"];function Io(r,e){let t=i=>i.map(l=>yl(l,e)).join(""),n=i=>`${Math.floor(i/r.cols)}.${i%r.cols}`,s=fl(r.rewards,e),o=[r.seed,r.episode,r.steps].join("."),a={rules:Lo(
r.rules,e),others:r.others?Lo(r.others,e):"",rewards:s===bn.rewards?"":s,size:`${r.rows}x${r.cols}`,diagonal:r.diagonal?"1":"",fov:r.fov===bn.fov?"":String(r.fov),
limit:r.maxSteps===bn.maxSteps?"":String(r.maxSteps),seed:o==="0.0.0"?"":o,ended:r.ended?"1":"",walls:r.walls.map(n).join(ft),pursuers:r.pursuers.map($o).join(ft),
evaders:r.evaders.map($o).join(ft),played:r.played.map(t).join(ft),next:r.next.every(i=>i===ps)?"":t(r.next)};return ml.filter(i=>a[i]).map(i=>`${i}=${a[i]}`).join(
"&")}function $o({cell:r,gone:e,captured:t,everCaptured:n}){let s=t?"c":n?"e":"";return`${r[0]}.${r[1]}${s}${e?"x":""}`}function Lo(r,e){let t=e.fields.map(({name:n})=>String(
r[n]).toLowerCase());return ms(r,e.variants)??t.join(".")}function fl(r,e){let t=JSON.stringify(r);return Object.keys(e.rewards).find(s=>JSON.stringify(e.rewards[s])===
t)??Object.values(r).map(s=>String(s)).join(ft)}function yl(r,e){if(typeof r=="number")return String(r);if(r===ds)return pl;let t=e.scripts.findIndex(({name:n})=>n===
r);return String.fromCharCode(97+t)}var gl="/* the engine */";function Fo(r,e){return p("button",{type:"button",class:"to-playground",title:"Open this step in the playground (G): the same agents a\
nd actions under any rules",onclick:()=>vl(r(),e)},"What if?")}function vl(r,e){let t=r!==null&&r.match.n_agents<=Yr&&Math.max(r.match.config.rows,r.match.config.
cols)<=Vr,n=t?Io(bl(r.match,r.step),e):"",s=new TextDecoder().decode(ln("playground")).replace(gl,()=>xe("script-engine")).replace("</noscript>",o=>t?o+No(r.champions):
o);window.open(`${URL.createObjectURL(new Blob([s],{type:"text/html"}))}#${n}`)}function bl(r,e){let{config:t,n_agents:n}=r,s=Math.max(0,e-1),o=i=>{let l=s*n+i,
u=s*t.n_evaders+i-t.n_pursuers,h=c=>i>=t.n_pursuers&&!!c[u];return{cell:[r.last_positions[2*l],r.last_positions[2*l+1]],gone:!r.alive[l],captured:h(r.captured),
everCaptured:h(r.ever_captured)}},a=Array.from({length:n},(i,l)=>o(l));return{rules:t.rules,others:null,rewards:t.rewards,rows:t.rows,cols:t.cols,diagonal:t.diagonal,
fov:t.fov,maxSteps:t.max_steps,seed:r.seed,episode:BigInt(r.episode),steps:s,ended:s===r.length,walls:Array.from(r.map.keys()).filter(i=>r.map[i]),pursuers:a.slice(
0,t.n_pursuers),evaders:a.slice(t.n_pursuers),played:[],next:Array.from(r.actions.subarray(s*n,(s+1)*n))}}var wn=.005,Do=.05,wl=["pursuer","evader"],xl=4,Ge=new Map;function dr(r,e,t="capture-rate"){let n=JSON.stringify([{...e,rewards:null},t]),s=Ge.get(n)??(Pt(e)?Promise.
resolve(null):Sl(r,e,t));return Ge.delete(n),Ge.set(n,s),Ge.size>xl&&Ge.delete([...Ge.keys()][0]),s}var Wo=({n_evaders:r})=>r===1?"capture-time":"capture-rate",
Uo=()=>new Promise(r=>setTimeout(r));async function Sl(r,e,t){await Uo();let n=r.solution(e,t);for(;n.goBack();)await Uo();return n}function pr(r,e,t){let{payoff:n}=r;
return t.flatMap((s,o)=>{let a=[0,0];for(let l=e.n_turns;l>0&&!e.over;l--)r.game(e)?.lost(s).forEach((u,h)=>a[h]+=u),e.playTurn(s);let i=n==="capture-rate"?wn:Do;
return wl.map((l,u)=>({step:o+1,team:l,lost:a[u],payoff:n})).filter(l=>l.lost>=i)})}var mr=r=>r.map(e=>({step:e.step,kind:e.team,size:e.lost/Math.max(1,...r.map(
({lost:t})=>t)),text:yt(e)})),zo=({lost:r,payoff:e})=>e==="capture-rate"?`${r.toFixed(2)} of the capture rate`:`${r.toFixed(1)} steps`,yt=r=>`The ${r.team}s los\
e ${zo(r)} against a perfect opponent`;function Bo(r){let e=r.reduce((t,n)=>n.lost>t.lost?n:t);return`Your team's worst moves, in step ${e.step}, lost ${zo(e)} \
against a perfect opponent.`}function jo({config:r,payoff:e},{value:t},n){if(e==="capture-rate")return`value ${t.toFixed(2)}`;let[s,o]=[1-t,Math.min(r.max_steps-
n,jr)];return s>o-Do?`free for ${o} steps`:`captured after ${s.toFixed(1)} steps`}function Ho(r,e){return(r.marginal(e)??[]).map((n,s)=>({share:n,action:s})).filter(
({share:n})=>n>=wn).sort((n,s)=>s.share-n.share).map(({share:n,action:s})=>n>1-wn?ie[s]:`${ie[s]} ${n.toFixed(2)}`).join(", ")}function fr(r,e,t){if(t===0)return[{kind:"start",text:Al(r),agents:[]}];let[n,s]=[e.moments[t-1],e.moments[t]],o=h=>Y(h,r.config.n_pursuers),a=ht(e,n,s),i=r.conflicts(
t),l=new Set(i.flatMap(h=>h.doomed)),u=a.map(h=>({kind:"capture",text:`${o(h)} is captured`,agents:[h]}));for(let h of er(n,s))!a.includes(h)&&!l.has(h)&&u.push(
{kind:"end",text:`${o(h)} disappears`,agents:[h]});return u.push(...i.map(({kind:h,text:c,agents:d})=>({kind:h,text:c,agents:d}))),t===r.length&&u.unshift({kind:"\
end",text:Ml(r),agents:[]}),u}function Al({config:r}){return`${r.n_pursuers} pursuers and ${r.n_evaders} evaders on ${r.rows} x ${r.cols} cells, at most ${r.max_steps}\
 steps`}function Ml(r){let e=Math.round(r.statistics.capture_rate*r.config.n_evaders);return`The episode ends after ${r.length} steps with ${e} of ${r.config.n_evaders}\
 evaders captured`}var El=60,yr=class{element;player=new Ae(0,{speed:ar,still:ye()});inspector;match=null;recording=null;actions;#e;#r;#t;#n;#a=p("h2",{class:"match-title"});#s=p(
"p",{class:"tally numbers"});#u=p("ol",{class:"words",tabindex:0,"aria-live":"off","aria-label":"What happened in this step"});#h=p("p",{class:"problem",role:"a\
lert"});#i=null;#p=null;#c=0;#l=!1;#m=0;#d=[];constructor(e,t,n){[this.#r,this.#t]=[e,t];let s=p("canvas",{"aria-label":"The match",onclick:({clientX:o,clientY:a})=>this.
inspector.choose(this.#e.agentAt(o,a))});this.#e=new Se(s,{numbers:!1}),this.#n=new cr(t),this.inspector=new hr(o=>this.#S(o)),this.actions=p("div",{class:"besi\
de"},p("button",{type:"button",class:"to-play",title:"Move the chosen agent, or an evader, yourself from this step on (T)",onclick:()=>this.element.dispatchEvent(
new Event("takeover"))},"Take over"),n&&Fo(()=>this.shown,n)),this.element=p("section",{class:"card match-card","aria-label":"Match",id:"match"},p("div",{class:"\
match"},p("header",{class:"match-head"},this.#a,this.#s),this.#h,p("div",{class:"stage"},s),p("div",{class:"aside"},this.#u,It(),this.actions,this.inspector.element),
ur(this.player),this.#n.element)),this.player.addEventListener("frame",()=>this.recording&&this.#e.show(this.recording,this.player.time)),this.player.addEventListener(
"step",()=>this.#x()),t.on("match",()=>this.#f()),this.#b(),this.#w(0,0)}get#o(){return this.#r[this.#t.selected.run]}reveal(){this.#e.canvas.scrollIntoView({block:"\
nearest"})}get shown(){return this.match&&this.#p&&{match:this.match,step:this.player.step,champions:this.#p}}start(e){this.#i=e,this.#y()}playSoon(){this.#l=!0,
this.#c||this.#v()}goTo(e){this.#m=e,!this.#c&&this.match&&this.#y()}#v(){!this.#l||!this.match||(this.#l=!1,this.player.jump(0),ye()||this.player.play())}#f(){
this.#b(),clearTimeout(this.#c),this.#c=setTimeout(()=>this.#y(),El)}#y(){clearTimeout(this.#c),this.#c=0,this.player.pause(),this.#b();let{selected:e}=this.#t,
t=We.map(o=>zt(this.#o,o,e[o])).find(Boolean)??"";if(this.#h.textContent=t,t||!this.#i)return;this.match=Rs(this.#i,this.#o,e);let[n,s]=this.names(e);this.#p={pursuer:{
name:n,policy:te(this.#o,"pursuer",e.pursuer)},evader:{name:s,policy:te(this.#o,"evader",e.evader)}},this.recording=or(this.match),this.#n.show(this.#o,this.match),
this.inspector.show(this.#i,this.#o,this.match,e),this.player.length=this.match.length,this.player.marks=Qt(this.recording),this.#d=this.player.ticks=[],this.player.
jump(this.#m),this.#m=0,this.#x(),this.#g(this.#i,this.match),this.element.dataset.played=`${e.run} ${e.pursuer} ${e.evader} ${e.episode} ${e.seed??""}`,this.#v()}async#g(e,t){
let n=await dr(e,t.config);if(this.match!==t||!n)return;let s=e.world(t.config);t.seek(s,0),this.#d=pr(n,s,Tl(t)),s.free(),this.player.ticks=mr(this.#d),this.inspector.
solution=n,this.#x()}names({run:e,pursuer:t,evader:n}){let{teams:s}=this.#r[e];return[s.pursuer.script??se("pursuer",t),s.evader.script??se("evader",n)]}#b(){let{
episode:e,seed:t}=this.#t.selected,{payoff:n}=this.#o,[s,o]=this.names(this.#t.selected),a=t===null?e<n.episodes?`episode ${e+1} of ${n.episodes}`:`episode ${e+
1}, not part of the cell`:`seed ${t}`;this.#a.replaceChildren(p("span",{class:"pursuer"},qt(s))," against ",p("span",{class:"evader"},o),p("span",{class:"muted \
small"},a))}#x(){let e=this.match;if(!e||!this.recording)return;let t=this.player.step,n=this.recording.moments[t];this.#w(Array.from(n.everCaptured).filter(Boolean).
length,t),this.#u.replaceChildren(...this.#d.filter(s=>s.step===t).map(s=>p("li",{class:`loss-${s.team}`},yt(s))),...fr(e,this.recording,t).map(s=>p("li",{class:s.
kind,"data-agents":s.agents.join(" ")},s.text))),this.inspector.at(t),this.#A()}#w(e,t){this.#s.replaceChildren(p("strong",{},e),` of ${this.#o.world.n_evaders}\
 captured`,p("span",{class:"muted"},` · step ${t}`))}#S(e){this.#e.look={selected:e,viewers:e===null?[]:[e]},this.#A()}#A(){let e=this.inspector.agent;for(let t of this.#u.
children){let n=t.dataset.agents?.split(" ")??[];t.classList.toggle("about",e!==null&&n.includes(String(e)))}}},Tl=({actions:r,length:e,n_agents:t})=>Array.from(
{length:e},(n,s)=>r.subarray(s*t,(s+1)*t));var Cl={ArrowUp:[1,0],ArrowDown:[-1,0],ArrowRight:[0,1],ArrowLeft:[0,-1]},kl=5;function Vo(r,e,t,n="pursuer"){r.tabIndex=0,r.setAttribute("role","application"),
r.addEventListener("keydown",s=>{let o=Cl[s.key];if(!o)return;let[a,i]=n==="pursuer"?o:[o[1],o[0]],[l,u]=t(),h=s.shiftKey?kl:1,{pursuer:c,evader:d}=e.selected;e.
select({pursuer:Go(c+h*a,l),evader:Go(d+h*i,u)}),s.preventDefault(),s.stopPropagation()})}var Go=(r,e)=>Math.min(e-1,Math.max(0,r));var gt=[[68,1,84],[72,26,108],[71,47,125],[65,68,135],[57,86,140],[49,104,142],[42,120,142],[35,136,142],[31,152,139],[34,168,132],[53,183,121],[84,197,104],[122,
209,81],[165,219,54],[210,226,27],[253,231,37]];function gr(r){let e=Math.min(1,Math.max(0,r))*(gt.length-1),t=Math.min(gt.length-2,Math.floor(e)),[n,s]=[gt[t],
gt[t+1]],o=a=>Math.round(n[a]+(e-t)*(s[a]-n[a]));return[o(0),o(1),o(2)]}function Yo(r){let[e,t,n]=gr(r).map(s=>((s/255+.055)/1.055)**2.4);return .2126*e+.7152*t+
.0722*n>.179?"#000":"#fff"}var Ko=r=>`rgb(${gr(r).join(" ")})`,qo=()=>`linear-gradient(to right, ${gt.map(r=>`rgb(${r.join(" ")})`).join(", ")})`;function Zo(r,e,t){let n=devicePixelRatio||1;for(let[a,i]of Object.entries(t))r.style.setProperty(a,`${i}px`);r.width=Math.round(t.width*n),r.height=Math.round(
t.height*n);let s=r.getContext("2d"),o=Ol(e);!s||!o||(s.imageSmoothingEnabled=!1,s.drawImage(o,0,0,r.width,r.height))}function Ol(r){let[e,t]=r.shape,n=document.
createElement("canvas");[n.width,n.height]=[t,e];let s=n.getContext("2d");if(!s)return null;let o=s.createImageData(t,e);return r.capture_rate.forEach((a,i)=>a.
forEach((l,u)=>{let h=4*((e-1-i-r.first[0])*t+u+r.first[1]);o.data.set([...gr(l),255],h)})),s.putImageData(o,0,0),n}function Jo(r,e,t,n=2){r.textContent=Q(e,n),
r.ariaLabel=`${t}: ${r.textContent}`,e!==void 0&&([r.style.backgroundColor,r.style.color]=[Ko(e),Yo(e)])}function Xo(r,e){let t=p("span",{class:"gradient"});return t.
style.backgroundImage=qo(),p("p",{class:"scale-of-rates small muted"},r,t,e)}var Rl=24,vr=7,ea=r=>r<Rl&&matchMedia("(pointer: coarse)").matches;function ta(r,e,t,n){let[s,o]=r.payoff.shape,[a,i]=[Qo(e,s),Qo(t,o)],[l,u]=[Math.min(vr,s),Math.
min(vr,o)],h=[];for(let f=a+l-1;f>=a;f--){h.push(p("span",{class:"pursuer"},f));for(let g=i;g<i+u;g++)h.push(_l(r,f,g,n))}let c=Array.from({length:u},(f,g)=>p("\
span",{class:"evader"},i+g)),d=p("button",{type:"button","aria-label":"Close: all cells",onclick:()=>n(null)},"✕"),y=p("div",{class:"loupe numbers",role:"grou\
p","aria-label":"Cells around the tap",onclick:f=>f.stopPropagation()},...h,d,...c);return y.style.gridTemplateColumns=`2.4rem repeat(${u}, minmax(0, 1fr))`,y}function _l(r,e,t,n){
let s=p("button",{type:"button",onclick:()=>n({pursuer:e,evader:t})});return Jo(s,ze(r,e,t)?.rate,`${se("pursuer",e)} against ${se("evader",t)}`),s}var Qo=(r,e)=>Math.
max(0,Math.min(e-vr,r-Math.floor(vr/2)));var re={left:52,bottom:46,top:76,right:84},ce=10,Pl=160,vt=re.right-ce-14,Oe=re.top-ce-14,br=class{element;#e;#r;#t=p("canvas",{"aria-hidden":"true"});#n=v("svg",
{"aria-hidden":"true"});#a=v("g");#s;#u=p("h2");#h=p("strong",{class:"rate numbers"});#i=p("span",{class:"small muted"});#p=p("p",{class:"of-both-teams small mu\
ted numbers"});#c=null;constructor(e,t){[this.#r,this.#e]=[e,t],this.#s=p("div",{class:"matrix",id:"matrix","aria-label":"Payoff matrix. Arrow keys choose a mat\
ch, Enter plays it.",onpointermove:s=>this.#b(s),onpointerleave:()=>t.point({}),onclick:s=>this.#x(s),onkeydown:({key:s})=>s==="Enter"&&this.#S()},this.#t,this.#n);
let n=p("header",{class:"readout","aria-live":"polite"},p("div",{},this.#u,this.#p),p("div",{class:"of-cell"},this.#h,this.#i));this.element=p("section",{class:"\
card matrix-card","aria-label":"Payoff matrix"},n,this.#s,Xo("0 all escape","1 all caught")),this.#f(),new ResizeObserver(()=>this.#m()).observe(this.#s),this.#s.
addEventListener("mousedown",s=>{s.preventDefault(),document.activeElement instanceof HTMLElement&&document.activeElement.blur()}),Vo(this.#s,t,()=>this.#l.payoff.
shape),t.on("run",()=>this.#m()),t.on("match hover",()=>this.#v())}get#l(){return this.#r[this.#e.selected.run]}#m(){let[e,t]=this.#l.payoff.shape,{clientWidth:n,
clientHeight:s}=this.#s;if(n<50)return;let a=Math.max(Pl,Math.min(n-re.left-re.right,s-re.top-re.bottom))/Math.max(e,t),i=Math.max(re.left,(n-t*a-re.right+re.left)/
2),l=re.top+Math.max(0,(s-re.top-re.bottom-e*a)/2),u={width:n,height:s,left:i,top:l,cell:a,rows:e,columns:t};this.#c=u,Zo(this.#t,this.#l.payoff,{left:i,top:l,width:t*
a,height:e*a});for(let[h,c,d]of[["left",i,n],["top",l,s],["width",t*a,n],["height",e*a,s]])this.#t.style.setProperty(h,`${100*c/d}%`);this.#s.style.setProperty(
"--shape",`${n} / ${s}`),this.#n.setAttribute("viewBox",`0 0 ${n} ${s}`),this.#n.replaceChildren(Nl(u),...$l(u),...this.#o(u),this.#a),this.#v()}#d(e){let t=this.#l.
findings?.generalization;if(!t)return[];let{selected:n,hover:s}=this.#e,[o,a]=[s.pursuer??n.pursuer,s.evader??n.evader],[i,l]=ra(e,t.pursuers.mean[o]??0,o),[u,h]=na(
e,t.evaders.mean[a]??0,a);return[v("circle",{class:"dot of-pursuers",cx:i,cy:l,r:5}),v("circle",{class:"dot of-evaders",cx:u,cy:h,r:5})]}#o(e){let t=this.#l.findings?.
generalization;if(!t)return[];let{left:n,top:s,cell:o,rows:a,columns:i}=e,[l,u]=[n+i*o+ce,s-ce],h={class:"side"};return[v("rect",{...h,x:l,y:s,width:vt,height:a*
o}),v("rect",{...h,x:n,y:u-Oe,width:i*o,height:Oe}),...sa(t.pursuers,(c,d)=>ra(e,c,d),"of-pursuers"),...sa(t.evaders,(c,d)=>na(e,c,d),"of-evaders"),v("text",{class:"\
tick",x:l,y:s+a*o+16,"text-anchor":"start"},"0"),v("text",{class:"tick",x:l+vt,y:s+a*o+16,"text-anchor":"end"},"1"),v("text",{class:"tick",x:n-6,y:u-4,"text-anc\
hor":"end"},"0"),v("text",{class:"tick",x:n-6,y:u-Oe+8,"text-anchor":"end"},"1"),v("text",{class:"label of-pursuers",x:l+vt,y:s+a*o+34,"text-anchor":"end"},"cap\
tures"),v("text",{class:"label of-evaders",x:n+i*o+ce,y:u-Oe+10,"text-anchor":"start"},"escapes")]}#v(){let e=this.#c;if(!e)return;let{selected:t,hover:n}=this.#e,
{left:s,top:o,cell:a,rows:i,columns:l}=e,u=y=>o+(i-1-y)*a,h=[],c=(y,f)=>v("rect",{class:f,x:s,y:u(y),width:l*a+ce+vt,height:a}),d=(y,f)=>v("rect",{class:f,x:s+y*
a,y:o-ce-Oe,width:a,height:ce+Oe+i*a});h.push(c(t.pursuer,"strip pursuer"),d(t.evader,"strip evader")),n.pursuer!==null&&n.pursuer<i&&h.push(c(n.pursuer,"strip \
hover")),n.evader!==null&&n.evader<l&&h.push(d(n.evader,"strip hover")),h.push(...this.#d(e));let m={x:s+t.evader*a,y:u(t.pursuer),width:a,height:a};h.push(v("r\
ect",{class:"chosen under",...m}),v("rect",{class:"chosen",...m})),this.#a.replaceChildren(...h),this.#f()}#f(){let{selected:e,hover:t}=this.#e,n=t.pursuer??e.pursuer,
s=t.evader??e.evader,o=ze(this.#l,n,s);this.#u.replaceChildren(p("span",{class:"pursuer"},qt(se("pursuer",n)))," against ",p("span",{class:"evader"},se("evader",
s))),this.#h.textContent=o?Q(o.rate,3):"-",this.#i.textContent=o?`capture rate, mean of ${o.rates.length} episodes`:"no episodes were played",this.#p.textContent=
this.#y(n,s)}#y(e,t){let n=this.#l.findings?.generalization;if(!n)return"";let s=(o,a)=>Fs(o.mean[a]??null,o.low?.[a]??null,o.high?.[a]??null);return`Against al\
l: captures ${s(n.pursuers,e)}, escapes ${s(n.evaders,t)}`}#g(e){let t=this.#c;if(!t)return null;let n=this.#s.getBoundingClientRect(),s=Math.floor((e.clientX-n.
left-t.left)/t.cell),o=t.rows-1-Math.floor((e.clientY-n.top-t.top)/t.cell),[a,i]=[o>=0&&o<t.rows,s>=0&&s<t.columns];return a||i?{g:a?o:-1,h:i?s:-1,inside:a&&i}:
null}#b(e){let t=this.#g(e);this.#e.point(t?{pursuer:t.g<0?null:t.g,evader:t.h<0?null:t.h}:{})}#x(e){let t=this.#g(e);if(t){if(t.inside&&ea(this.#c.cell))return this.#w(
t.g,t.h);this.#e.select({...t.g<0?{}:{pursuer:t.g},...t.h<0?{}:{evader:t.h}}),t.inside&&this.#S()}}#w(e,t){let n=ta(this.#l,e,t,s=>{n.remove(),s&&(this.#e.select(
s),this.#S())});this.#s.append(n)}#S(){this.#s.dispatchEvent(new CustomEvent("play",{bubbles:!0}))}};function Nl({left:r,top:e,cell:t,rows:n,columns:s}){let o=v(
"g",{class:"axes"}),a=e+n*t,i=l=>ct(0,l-1,Math.min(l,l*t/44),!0);for(let l of i(s))o.append(v("text",{class:"tick",x:r+(l+.5)*t,y:a+16,"text-anchor":"middle"},l));
for(let l of i(n))o.append(v("text",{class:"tick",x:r-7,y:a-(l+.5)*t,"text-anchor":"end","dominant-baseline":"middle"},l));return o.append(v("text",{class:"labe\
l of-evaders",x:r+s*t/2,y:a+36,"text-anchor":"middle"},"evader generation"),v("text",{class:"label of-pursuers",transform:`translate(${r-36} ${e+n*t/2}) rotate(\
-90)`,"text-anchor":"middle"},"pursuer generation")),o}function $l({left:r,top:e,cell:t,rows:n,columns:s}){let o=v("g",{class:"diagonal"}),a=Math.min(n,s);if(a<
3)return[];let i=e+n*t;for(let h of["H","V"]){let c=`M${r} ${i}`;for(let d=1;d<=a;d++){let[m,y]=[`H${r+d*t}`,`V${i-d*t}`];c+=h==="H"?m+y:y+m}o.append(v("path",{
d:c,class:"under"}),v("path",{d:c}))}let[l,u]=[r+a/2*t-.7*t-4,i-a/2*t-.7*t-4];return[o,v("text",{class:"on-cells",transform:`translate(${l} ${u}) rotate(-45)`,"\
text-anchor":"middle"},"same generation")]}var ra=({left:r,top:e,cell:t,rows:n,columns:s},o,a)=>[r+s*t+ce+o*vt,e+(n-a-.5)*t],na=({left:r,top:e,cell:t},n,s)=>[r+
(s+.5)*t,e-ce-n*Oe];function sa(r,e,t){let n=o=>o.map((a,i)=>e(a??0,i).map(l=>l.toFixed(1)).join(" ")),s=[];return r.low&&r.high&&s.push(v("path",{class:`band ${t}`,
d:`M${[...n(r.high),...n(r.low).reverse()].join("L")}Z`})),s.push(v("path",{class:`line ${t}`,d:`M${n(r.mean).join("L")}`})),s}var oa={pursuer:null,evader:null},wr=class extends EventTarget{#e;#r=oa;constructor(e){super(),this.#e=e}get selected(){return this.#e}get hover(){return this.#r}select(e){
let t=this.#e,n=["run","pursuer","evader"].some(s=>s in e&&e[s]!==t[s]);this.#e={...t,...n?{episode:0,seed:null}:{},...e},this.#e.run!==t.run&&this.dispatchEvent(
new Event("run")),this.dispatchEvent(new Event("match"))}point(e){let t={...oa,...e};t.pursuer===this.#r.pursuer&&t.evader===this.#r.evader||(this.#r=t,this.dispatchEvent(
new Event("hover")))}on(e,t){for(let n of e.split(" "))this.addEventListener(n,t)}};var xr=class{config;start;recording;actions=[];#e;#r;#t=[[]];constructor(e,t,n){[this.config,this.start]=[t,n],this.#e=e.world(t),this.#e.reset(n),this.#r=[vn(this.#e)],
this.recording=gn(t,this.#e.map(),this.#r)}get length(){return this.actions.length}get over(){return this.#e.over}get statistics(){return{capture_rate:this.#e.read(
"capture_rate")[0]}}conflicts(e){return this.#t[e]}game(e){return e.game(this.#e)}play(e){this.#e.step(e),this.#n(e)}step(e,t,n){let[s,o]=[this.#e,this.config.n_pursuers],
a=new Uint8Array(s.n_agents);for(let i=s.n_turns;i>0&&!s.over;--i){let[l,u]=s.actors;l<o&&(a=s.decide(e.pursuer,[l,Math.min(u,o)],a)),u>o&&(a=s.decide(e.evader,
[Math.max(l,o),u],a)),typeof n=="number"?a[t]=n:l<=t&&t<u&&(a=s.decide(n,[t,t+1],a)),s.playTurn(a)}this.#n(a)}#n(e){this.actions.push(e),this.#r.push(vn(this.#e,
e)),this.#t.push(this.#e.conflicts())}};var he=(r,e)=>We[+(e>=r.n_pursuers)];function xn(r,e){let t=new xr(r,e.config,{seed:e.seed,episode:e.episode});for(let n of e.moves)t.over||t.step(e.policies,e.
seat,n);return t}function Ve(r,e){let{moments:t,nPursuers:n}=r.recording,s=t.findIndex(({alive:a,captured:i})=>!a[e]||!!i[e-n]),o=s<0?r.length:s;return{lasted:o,
out:s>=0,captured:Array.from(t[o].everCaptured).filter(Boolean).length}}var Sr=(r,e)=>r.over||Ve(r,e).out;function aa(r,e,t){let n=xn(r,{...e,moves:e.moves.slice(
0,e.from)});for(;!Sr(n,e.seat);)n.step(e.policies,e.seat,t);return Ve(n,e.seat)}function ia(r){let e=r.length-1;return[...new Set([0,Math.round(e/3),e])].map(t=>r[t])}
function la(r,{seat:e,from:t,moves:n}){let s={...r,seat:e,...t?{from:t}:{},moves:n.join("")};return`${location.href.split("#")[0]}#${Object.entries(s).map(([o,a])=>`${o}\
=${a}`).join("&")}`}function ua(r,e){let[t,n,s]=[r.get("seat")??"",r.get("from")??"0",r.get("moves")??""];return/^\d{1,6}$/.test(t)&&Number(t)<e.n_pursuers+e.n_evaders&&
(e.diagonal?/^[0-8]+$/:/^[0-4]+$/).test(s)&&s.length<=e.max_steps&&/^\d{1,6}$/.test(n)&&Number(n)<=s.length?{seat:Number(t),from:Number(n),moves:[...s].map(Number)}:
null}function Sn(r,e,t,n,s,o){e.play({title:t,played:n,ending:(a,i)=>[Ll(r,a,i,ia(s))],again:()=>Sn(r,e,t,{...n,moves:n.moves.slice(0,n.from)},s,o),link:a=>o&&la(o,a)})}
function Ll(r,e,t,n){let s=he(t.config,t.seat)==="evader",o=s?t.config.max_steps:t.config.n_evaders,a=p("table",{class:"numbers"},p("caption",{},s?"Steps in you\
r seat: same start, same others":"Captures of your team: same start, same others")),i=u=>{let[h,c]=[p("span",{class:s?"bar evader":"bar pursuer"}),p("td",{},"…")];
return a.append(p("tr",{},p("th",{scope:"row"},u),p("td",{class:"track","aria-hidden":"true"},h),c)),({lasted:d,captured:m})=>{h.style.width=`${100*(s?d:m)/o}%`,
c.textContent=String(s?d:m)}};i("You")(Ve(e,t.seat));for(let{name:u,policy:h}of n){let c=i(u);setTimeout(()=>c(aa(r,t,h())))}let l=t.from?`You took over at step\
 ${t.from}. `:"";return p("div",{},a,p("p",{class:"small muted"},`${l}One match: luck has its part in it.`))}var ca=["·","↑","→","↓","←","↗","↘","↙","↖"];var Il={" ":0,ArrowUp:1,w:1,ArrowRight:2,d:2,ArrowDown:3,s:3,ArrowLeft:4,a:4,e:5,c:6,y:7,z:7,q:8},An=[8,1,5,4,0,2,7,3,6],Fl=[7,8,9,4,5,6,1,2,3],Ul=24,Dl=Math.tan(
Math.PI/8);function da(r,e){if(r.ctrlKey||r.metaKey||r.altKey)return;let t=Fl.findIndex(s=>r.code===`Numpad${s}`),n=An[t]??Il[r.key.length===1?r.key.toLowerCase():
r.key];return n!==void 0&&n>4&&!e?void 0:n}function pa(r){let e=An.map(t=>p("button",{type:"button","aria-label":ie[t],onclick:()=>r(t)},ca[t]));return{element:p(
"div",{class:"play-pad",role:"group","aria-label":"Your move"},...e),show:t=>e.forEach((n,s)=>n.classList.toggle("absent",An[s]>4&&!t))}}function ha(r,e,t){let n=Dl*
Math.max(Math.abs(r),Math.abs(e)),s=o=>Math.abs(o)<n?0:o;return Hs([0,0],t?[s(r),s(e)]:[r,e],t)}function ma(r,e,t){let n=null,{canvas:s}=r;s.addEventListener("p\
ointerdown",({button:o,clientX:a,clientY:i})=>n=o===0?[a,i]:null),s.addEventListener("pointercancel",()=>n=null),s.addEventListener("pointerup",({clientX:o,clientY:a})=>{
let[i,l]=[n,e()];if(n=null,!i||!l)return;let[u,h]=[o-i[0],a-i[1]],c=r.cellAt(o,a);Math.hypot(u,h)>=Ul?t(ha(h,u,l.diagonal)):c&&t(ha(c[0]-l.cell[0],c[1]-l.cell[1],
l.diagonal))})}function fa(r,e){let t=n=>{let s=e[n]-r[n],o=Be.findIndex(a=>a[n]===Math.sign(s)&&a[1-n]===0);return s?`${Math.abs(s)} ${ie[o]}`:""};return[t(0),
t(1)].filter(Boolean).join(", ")||"on your cell"}var va="NUMPY\0",ya=va.length+2,ga=64;function bt(r){return Wt(Object.fromEntries(Object.entries(r).map(([e,t])=>[`${e}.npy`,Wl(t)])))}function Wl({dtype:r,shape:e,
data:t}){let n=typeof t=="string"?Array.from(t,h=>h.codePointAt(0)):null,s=e.map(h=>`${h}, `).join(""),o=`{'descr': '${n?`<U${n.length}`:r}', 'fortran_order': F\
alse, 'shape': (${s}), }`,a=Math.ceil((ya+o.length+1)/ga)*ga-ya,i=va+String.fromCharCode(a&255,a>>8)+o.padEnd(a-1)+`
`,l=n?Int32Array.from(n):t,u=new Uint8Array(i.length+l.byteLength);return u.set(Ee(i,!0)),u.set(new Uint8Array(l.buffer,l.byteOffset,l.byteLength),i.length),u}var zl="matrixworld episode 3";function ba(r,e,t){let{config:n,actions:s,length:o,recording:a}=e,[i,l]=[n.n_pursuers+n.n_evaders,n.n_evaders],u={positions:["<i4",
i,2],last_positions:["<i4",i,2],alive:["|b1",i],captured:["|b1",l],ever_captured:["|b1",l]},h={rewards:["<f4",i],involved:["|b1",i,3],fault:["|b1",i,3]},c={},d=w=>{
for(let M of Object.keys(w))(c[M]??=[]).push(Array.from(m.read(M),Number))},m=r.world(n);m.reset(e.start);let y=[];d(u);for(let w of s)m.step(w),d({...u,...h}),
y.push(...m.conflictTable());m.free();let f={"<i4":Int32Array,"<f4":Float32Array,"|b1":Uint8Array},g={};for(let[w,[M,...O]]of Object.entries({...u,...h})){let L=o+
+(w in u);g[w]={dtype:M,shape:[L,...O],data:f[M].from((c[w]??[]).flat())}}let b=w=>({dtype:"<i8",shape:[],data:Int32Array.of(w,0)}),S=w=>({dtype:"<U",shape:[],data:w});
return bt({format:S(zl),n_pursuers:b(n.n_pursuers),config:S(JSON.stringify(n)),seat:b(t),...g,actions:{dtype:"|i1",shape:[o,i],data:Int8Array.from(s.flatMap(w=>[
...w]))},map:{dtype:"|b1",shape:[n.rows,n.cols],data:Uint8Array.from(a.obstacles,Number)},conflict_table:{dtype:"<i4",shape:[y.length/11,11],data:Int32Array.from(
y)}})}var Bl=[0,1,2,4,8],Ar=class{element;player=new Ae(0,{speed:4,still:ye()});#e;#r;#t=p("canvas",{tabindex:0,"aria-describedby":"play-keys"});#n=p("h2");#a=p("p",{
class:"play-told",role:"status"});#s=pa(e=>this.act(e));#u=ne(Bl.map(e=>[e,e?`${e} / s`:"step by step"]),()=>this.#C());#h=p("input",{type:"checkbox",onchange:()=>this.#S()});#i=p(
"input",{type:"checkbox",onchange:()=>this.#k()});#p=p("label",{class:"play-choice"},this.#i,"Best move");#c=p("p",{class:"small muted play-keys",id:"play-keys"});#l=p(
"section",{class:"play-ending",tabindex:-1,"aria-labelledby":"play-headline"});#m=ur(this.player);#d=null;#o=null;#v=[];#f=null;#y=null;#g=[];#b=0;#x=0;constructor(e){
this.#e=e,this.#r=new Se(this.#t,{numbers:!1}),this.#t.setAttribute("role","application"),ma(this.#r,()=>{let t=this.#f!==null&&this.#o&&k(this.#o.recording.moments.
at(-1),this.#f);return t?{cell:t,diagonal:this.#o.config.diagonal}:null},t=>this.act(t)),this.player.addEventListener("frame",()=>this.#o&&this.#r.show(this.#o.
recording,this.player.time)),this.player.addEventListener("step",()=>this.#k()),this.element=p("div",{class:"play"},p("header",{class:"play-head"},this.#n,this.#a),
p("div",{class:"play-stage"},this.#t),p("div",{class:"play-side"},this.#l,this.#s.element,p("label",{class:"play-choice",title:"Steps a second"},"Pace ",this.#u),
p("label",{class:"play-choice"},this.#h,p("span",{},"Fog",p("span",{class:"at-length"},": see only what it sees"))),this.#p,this.#c),this.#m)}get played(){return this.#d&&
{...this.#d.played,moves:this.#v}}get live(){return this.#o}play(e){this.#w(xn(this.#e,e.played),e.played.seat,e.title),[this.#d,this.#v,this.#b]=[e,[...e.played.
moves],0],this.element.dataset.state="playing",this.#t.focus({preventScroll:!0}),Sr(this.#o,e.played.seat)&&this.#R()}watch(e,t,n){this.#d=null,this.#w(e,t,n),this.#_()}stop(){
this.#C(),this.player.pause(),this.#d=null}act(e){let[t,n]=[this.#d,this.#o];if(!t||!n||this.element.dataset.state!=="playing")return;this.#b=e;let s=Number(this.#u.
value);this.#x||(this.#O(),s&&this.element.dataset.state==="playing"&&(this.#x=setInterval(()=>this.#O(),1e3/s)))}key(e){let{target:t,key:n}=e;if(t instanceof HTMLSelectElement||
t instanceof HTMLInputElement&&(t.type==="text"||n===" ")||t instanceof HTMLButtonElement&&(n===" "||n==="Enter")||!this.#o)return!1;if(this.element.dataset.state!==
"playing")return lr(this.player,e);let o=da(e,this.#o.config.diagonal);return o!==void 0&&this.act(o),o!==void 0}#w(e,t,n){this.#C(),this.player.pause(),[this.#o,
this.#f]=[e,t],this.#n.textContent=n,this.#t.ariaLabel=`Board, ${e.config.rows} by ${e.config.cols} cells`,this.#s.show(e.config.diagonal),this.#c.replaceChildren(
p("span",{class:"at-length"},`W A S D or the arrow keys move, Space stays${e.config.diagonal?"; Q E Z C and the numeric keypad move diagonally":""}. `),"On the \
board: swipe, or tap where to go."),this.#A(e),this.#l.replaceChildren(),this.player.length=e.length,this.player.jump(e.length),this.#k()}#S(){this.#r.look={you:this.#f,
fog:this.#h.checked,viewers:this.#f===null?[]:[this.#f],plan:this.#T()}}#A(e){this.#y=null,this.#g=this.player.ticks=[],this.#p.hidden=this.#i.disabled=!!Pt(e.config),
dr(this.#e,e.config,Wo(e.config)).then(t=>{this.#o===e&&(this.#y=t,this.#E(),this.#k())})}#E(){let[e,t]=[this.#o,this.#y];if(!t||this.element.dataset.state==="p\
laying")return;let n=this.#e.world(e.config);n.reset(e.start),this.#g=pr(t,n,e.actions),n.free(),this.player.ticks=mr(this.#g)}get#M(){return this.#i.checked&&this.#d&&
this.element.dataset.state==="playing"&&this.#y&&this.#o.game(this.#y)||null}#T(){let[e,t]=[this.#f,this.#f!==null&&this.#M?.marginal(this.#f)];return e!==null&&
t?Object.assign(Array(e).fill(0),{[e]:t.indexOf(Math.max(...t))}):null}#C(){clearInterval(this.#x),this.#x=0,this.#a.ariaLive=Number(this.#u.value)?"off":"polit\
e"}#O(){let[{policies:e,seat:t},n]=[this.#d.played,this.#o];n.step(e,t,this.#b),this.#v.push(this.#b),this.player.length=n.length,this.player.glide=Math.min(.22,
.9/(Number(this.#u.value)||4)),this.player.move(n.length-this.player.step),Sr(n,t)&&this.#R()}#R(){this.#C();let[e,t,n]=[this.#d,this.#o,this.played],s=$t()?e.link(
n):null,o=`${Y(n.seat,t.config.n_pursuers)}-${t.length}-steps.npz`,a=()=>Lt(o,ba(this.#e,t,n.seat));this.#l.replaceChildren(p("h3",{id:"play-headline"},Gl(t,n.seat)),
...e.ending(t,n),p("div",{class:"play-buttons"},p("button",{type:"button",class:"primary",onclick:()=>e.again()},"Again"),p("button",{type:"button",onclick:()=>this.#_()},
"Watch it"),p("button",{type:"button",onclick:a},"Save"),s&&p("button",{type:"button",onclick:({currentTarget:l})=>Yl(l,s)},"Link"))),this.element.dataset.state=
"ended",this.#E();let i=this.#g.filter(({team:l})=>l===he(t.config,n.seat));i.length&&this.#l.children[0].after(p("p",{class:"small muted"},Bo(i))),this.#l.focus(
{preventScroll:!0}),this.#l.scrollIntoView({block:"nearest"})}#_(){this.element.dataset.state="watched",this.player.length=this.#o.length,this.player.jump(0),ye()||
this.player.play()}#k(){let[e,t,{step:n}]=[this.#o,this.#f,this.player];if(!e||n>e.length)return;let s=fr(e,e.recording,n).filter(({agents:l})=>t===null||l.includes(
t)),o=this.#d&&n===0,a=o?[jl(e.config,t),this.#d.about??""]:[`Step ${n} of ${e.config.max_steps}`,...s.map(({text:l})=>l)];!o&&t!==null&&a.push(Hl(e,n,t)),a.push(
...this.#g.filter(l=>l.step===n).map(yt));let i=n===e.length&&t!==null?this.#M:null;i&&a.push(`Perfect play: ${Ho(i,t)||"decided in its turn"}; ${jo(this.#y,i,n)}`),
this.#S(),this.#a.textContent=a.filter(Boolean).map(l=>`${l}.`).join(" ")}};function jl(r,e){let t=r.rules.capture==="SURROUND";return he(r,e)==="evader"?`Run a\
way: you win if ${t?"the pursuers do not surround you":"no pursuer reaches your cell"} in ${r.max_steps} steps`:`Capture evaders: ${t?"surround them with your t\
eam":"move onto their cells"}`}function Hl({config:r,recording:e},t,n){let s=e.moments[t],a=he(r,n)==="pursuer"?"evader":"pursuer";if(!s.alive[n])return"";let i=k(
s,n),l=c=>{let[d,m]=k(s,c);return Math.max(Math.abs(d-i[0]),Math.abs(m-i[1]))},u=Array.from({length:s.alive.length},(c,d)=>d).filter(c=>he(r,c)===a&&s.alive[c]&&
!s.captured[c-r.n_pursuers]&&2*l(c)<r.fov);if(!u.length)return`No ${a} in view`;let h=u.reduce((c,d)=>l(d)<l(c)?d:c);return`Nearest ${a}: ${fa(i,k(s,h))}`}function Gl(r,e){
let[{lasted:t,out:n,captured:s},{config:o}]=[Ve(r,e),r];return he(o,e)==="pursuer"?`Your team captured ${s} of ${Vl(o)} in ${t} steps.`:n?`You lasted ${t} of ${o.
max_steps} steps.`:`You escaped: ${t} steps.`}var Vl=({n_evaders:r})=>`${r} evader${r===1?"":"s"}`;function Yl(r,e){let t=ls("Link to this match");t.value=e,r.replaceWith(
t),t.select(),navigator.clipboard?.writeText(e).catch(()=>{})}var Kl=2n**64n-1n;function wa(r,e,t){let n=new URLSearchParams(r.replace(/^#/,"")),s=(u,h,c)=>{let d=n.get(u)??"";return/^\d{1,9}$/.test(d)&&Number(d)<h?Number(
d):c},o=s("run",e.length,t.run),[a,i]=e[o].payoff.shape,l=n.get("seed")??"";return{run:o,pursuer:s("pursuers",a,Math.min(t.pursuer,a-1)),evader:s("evaders",i,Math.
min(t.evader,i-1)),episode:s("episode",1/0,t.episode),seed:/^\d{1,20}$/.test(l)&&BigInt(l)<=Kl?l:null,step:s("step",1/0,0)}}var Mr=class{dialog=p("dialog",{class:"take-over","aria-label":"Play an agent",onclose:()=>this.view?.stop(),onkeydown:e=>this.view?.key(e)&&e.preventDefault()});view=null;#e;#r;#t;#n;#a=null;constructor(e,t,n,s=!0){
[this.#e,this.#r,this.#t,this.#n]=[e,t,n,s],n.element.addEventListener("takeover",()=>this.open())}start(e,t=""){this.#a=e;let n=wa(t,this.#e,this.#r.selected),
s=ua(new URLSearchParams(t.replace(/^#/,"")),this.#e[n.run].world);s&&this.play(n,s)}open(){let e=this.#t.shown;if(!e)return;let{match:t,step:n}=e;this.#t.player.
pause();let s=this.#t.inspector.agent,o=n<t.length?n:0,a=(c,d)=>!!t.alive[d*t.n_agents+c],i=Array.from({length:t.n_agents},(c,d)=>(d+t.config.n_pursuers)%t.n_agents),
l=s??i.find(c=>a(c,o)),u=a(l,o)?o:0,h=Array.from({length:u},(c,d)=>t.actions[d*t.n_agents+l]);this.play(this.#r.selected,{seat:l,from:u,moves:h})}play(e,t){let[
n,s]=[this.#a,this.#e[e.run]];if(!n||We.some(g=>zt(s,g,e[g])))return;let{run:o,pursuer:a,evader:i,episode:l,seed:u}=e,h=he(s.world,t.seat),c=s.teams[h].kept.map(
g=>({name:s.teams[h].script??`generation ${g}`,text:"",policy:()=>te(s,h,g)}));this.view||(this.view=new Ar(n),this.dialog.append(p("button",{type:"button",class:"\
leave",onclick:()=>this.dialog.close()},"Close"),this.view.element)),this.dialog.open||this.dialog.showModal();let d=`You are ${Y(t.seat,s.world.n_pursuers)}: ${this.#t.
names(e).join(" against ")}`,m={pursuer:te(s,"pursuer",a),evader:te(s,"evader",i)},y={config:s.world,seed:BigInt(u??s.seeds[a][i]),episode:l,policies:m,...t},f={
run:o,pursuers:a,evaders:i,episode:l,...u===null?{}:{seed:u}};Sn(n,this.view,d,y,c,this.#n?f:null)}};var ql=8,Zl=700,xa=1400,wt=class{element;player=new Ae(0,{speed:ql,still:ye()});title=p("figcaption");generation=0;#e=p("canvas");#r;#t=p("p",{class:"small mute\
d numbers"});#n=p("p",{class:"small",role:"status"});#a;#s=null;#u=0;#h=0;#i=!ye();constructor(e){this.#a=e,this.#r=new Se(this.#e,{numbers:!1}),this.element=p(
"figure",{class:"chase"},this.title,this.#e,this.#t,this.#n),this.player.addEventListener("frame",()=>this.#l()),this.player.addEventListener("step",()=>this.#m()),
this.player.addEventListener("state",()=>{this.#i&&!this.player.playing&&this.player.length&&this.player.step===this.player.length&&this.#p()})}set label(e){this.#e.
ariaLabel=e}get runs(){return this.#i}set runs(e){this.#i=e,clearTimeout(this.#h),e?this.player.play():this.player.pause()}renew(e=!1){e||!this.#s||performance.
now()-this.#u>xa?this.#c():this.#p(xa)}#p(e=Zl){clearTimeout(this.#h),this.#h=setTimeout(()=>this.#c(),e)}#c(){clearTimeout(this.#h);let e=this.#a();e&&(this.#s=
or(e),this.#u=performance.now(),this.player.jump(0),this.player.length=e.length,this.player.marks=Qt(this.#s),this.#m(),this.#i&&this.player.play())}#l(){this.#s&&
this.#r.show(this.#s,this.player.time)}#m(){let e=this.#s?.moments[this.player.step]?.everCaptured;e&&(this.#t.textContent=`generation ${this.generation} · ${Array.
from(e).filter(Boolean).length} of ${e.length} caught · step ${this.player.step}`)}drawWalls(e){let t=!1,n=!0,s=[0,0],o=([l,u])=>!!this.#s?.obstacles[l*this.#s.
cols+u],a=(l,u)=>{this.#n.textContent=e(l,u)},i=l=>{let u=this.#r.cellAt(l.clientX,l.clientY);u&&o(u)!==n&&a(u,n)};return this.#e.addEventListener("pointerdown",
l=>{let u=t&&this.#r.cellAt(l.clientX,l.clientY);u&&(this.#e.setPointerCapture(l.pointerId),n=!o(u),i(l))}),this.#e.addEventListener("pointermove",l=>t&&l.buttons&&
i(l)),this.#e.addEventListener("keydown",l=>{let u={ArrowUp:[-1,0],ArrowDown:[1,0],ArrowLeft:[0,-1],ArrowRight:[0,1]}[l.key];if(!t||!this.#s||!(u||l.key===" "))
return;l.preventDefault();let h=(m,y)=>Math.min(y-1,Math.max(0,m)),{rows:c,cols:d}=this.#s;u?s=[h(s[0]+u[0],c),h(s[1]+u[1],d)]:a(s,!o(s)),this.#r.look={cursor:s}}),
l=>{t=l,this.#e.classList.toggle("drawn-on",l),this.#e.tabIndex=l?0:-1,this.#e.setAttribute("role",l?"application":"img"),this.#r.look={cursor:null}}}show(e){this.#s&&
(this.#s={...this.#s,obstacles:e},this.#l())}};var $=r=>Array.from(r).reduce((e,t)=>e+t,0)/r.length,Sa=(r,e)=>e==="pursuer"?r:r[0].map((t,n)=>r.map(s=>1-s[n])),Aa=(r,e)=>$(Sa(r,e).at(-1));function Ma(r,e){let t=[],
n=Sa(r,e).map(s=>$(s.map((o,a)=>(t[a]=Math.max(t[a]??0,o),t[a]-o))));return $(n.slice(Math.floor(n.length/2)))}var Ea=-12676506002282294e14,Ta=({hidden:r,mask:e})=>r.map(t=>t+(e?4:0));function xt(r){let e=[3*r.fov**2,...Ta(r),5],t=0;return e.slice(1).map((n,s)=>{let o={at:t,
inputs:e[s],outputs:n};return t+=(o.inputs+1)*n,o})}function Ye(r){let{at:e,inputs:t,outputs:n}=xt(r).at(-1);return e+(t+1)*n}var St=(r,e)=>({hidden:Ta(r),activation:"\
relu",sampled:!0,memory:"none",genome:e});function Ca(r,e,t,n){let s=new Float32Array(Ye(r)),o=xt(r);return o.forEach(({at:a,inputs:i,outputs:l},u)=>{let h=Math.
fround(u===o.length-1?n:t);e.normals(i*l).forEach((c,d)=>s[a+d]=h*c)}),s}function Mn(r){let{fov:e,mask:t}=r;if(!t)return null;let[n,s]=[new Uint8Array(Ye(r)),new Float32Array(
Ye(r))],o=xt(r),a=o.length-1,i=Math.floor(e/2);return o.forEach(({at:l,inputs:u,outputs:h},c)=>{let d=(m,y)=>l+m*h+y;for(let m=0;m<4;m++)if(c>0&&n.fill(1,d(u-4+
m,0),d(u-4+m+1,0)),c<a)for(let y=0;y<=u;y++)n[d(y,h-4+m)]=1;t.forEach((m,y)=>{let f=c===a?1+y:h-4+y,g=c===0?m.map(([b,S,w])=>(b*e+i+S)*e+i+w):[u-4+y];for(let b of g)
n[d(b,f)]=1,s[d(b,f)]=c===a?Ea:1})}),{fixed:n,values:s}}function En(r,e){return e?r.map((t,n)=>e.fixed[n]?e.values[n]:t):r}function ka(r,e,t){let n=new Float32Array(
Ye(t)),[s,o]=[xt(e),xt(t)],a=Math.floor(t.fov/2)-Math.floor(e.fov/2),i=u=>u>=0&&u<t.fov,l=u=>{let[h,c,d]=[Math.floor(u/e.fov**2),Math.floor(u/e.fov)%e.fov+a,u%e.
fov+a];return i(c)&&i(d)?(h*t.fov+c)*t.fov+d:-1};return s.forEach((u,h)=>{let c=o[h],d=e.hidden[h]??5;for(let m=0;m<(h?e.hidden[h-1]:u.inputs);m++){let y=h?m:l(
m);if(!(y<0))for(let f=0;f<d;f++)n[c.at+y*c.outputs+f]=r[u.at+m*u.outputs+f]}for(let m=0;m<d;m++)n[c.at+c.inputs*c.outputs+m]=r[u.at+u.inputs*u.outputs+m]}),En(
n.map(u=>u<=Ea/2?0:u),Mn(t))}var Pa={initial:1,noise:2,learn:3,opponents:4},Cn={pursuer:1,evader:2,both:3},Re=4,Tn=2n**32n;function Oa(r){let e=[],t=BigInt(r);do e.push(Number(t%Tn)),t/=Tn;while(t>
0n);return e}function Ra(r,e){let t=r;return n=>{let s=n^t;return t=Math.imul(t,e),s=Math.imul(s,t),s^s>>>16}}function _a(r,e){let t=Math.imul(3389127133,r)-Math.
imul(1232336661,e)|0;return t^t>>>16}function kn(r,e,t){let n=r.flatMap(Oa);if(e.length){for(;n.length<Re;)n.push(0);n.push(...e.flatMap(Oa))}let s=Ra(1135663077,
2468251765),o=Array.from({length:Re},(i,l)=>s(n[l]??0));for(let i=0;i<Re;i++)for(let l=0;l<Re;l++)i!==l&&(o[l]=_a(o[l],s(o[i])));for(let i of n.slice(Re))for(let l=0;l<
Re;l++)o[l]=_a(o[l],s(i));let a=Ra(2337405405,1492356589);return Uint32Array.from({length:t},(i,l)=>a(o[l%Re]))}function At(r,e){let t=kn(r,[],2*e);return BigUint64Array.
from({length:e},(n,s)=>BigInt(t[2*s])+Tn*BigInt(t[2*s+1]))}var Er=(r,e,t)=>At([r,e,t],1)[0];var Na=r=>(e,...t)=>new On(kn([r],[Pa[e],...t],3)),On=class{#e;#r;#t;#n=1;constructor(e){[this.#e,this.#r,this.#t]=[e[0],e[1],e[2]];for(let t=0;t<12;t++)this.#a()}#a(){
let e=this.#e+this.#r+this.#n++|0;return this.#e=this.#r^this.#r>>>9,this.#r=this.#t+(this.#t<<3)|0,this.#t=(this.#t<<21|this.#t>>>11)+e|0,e>>>0}#s(){return(this.#a()+
.5)/2**32}normals(e){let t=new Float32Array(e);for(let n=0;n<e;n+=2){let[s,o]=[Math.sqrt(-2*Math.log(this.#s())),2*Math.PI*this.#s()];t[n]=s*Math.cos(o),n+1<e&&
(t[n+1]=s*Math.sin(o))}return t}integers(e,t){return Int32Array.from({length:t},()=>Math.floor(this.#s()*e))}permutation(e){return this.choice(e,e)}choice(e,t){
let n=Int32Array.from({length:e},(s,o)=>o);for(let s=0;s<t;s++){let o=s+Math.floor(this.#s()*(e-s));[n[s],n[o]]=[n[o],n[s]]}return n.slice(0,t)}};var T=Math.fround,Jl=5,Xl=256,Tr=class{size;sigma;fixed;#e;constructor(e,t,n,s){[this.size,this.sigma,this.fixed]=[e,n,s],this.#e=t.normals((1+Xl)*e);for(let o=0;o<
this.#e.length;o++)this.#e[o]*=T(n)}draw(e,t){let n=t.integers(this.#e.length-this.size+1,e);return Array.from(n,s=>{let o=this.#e.subarray(s,s+this.size);return this.
fixed?o.map((a,i)=>this.fixed[i]?0:a):o})}},Rn=class{#e;#r;#t=0;constructor(e){[this.#e,this.#r]=[new Float32Array(e),new Float32Array(e)]}moved(e,t,n){let[s,o,
a]=[.9,.999,T(1e-8)];this.#t+=1;let[i,l]=[T(1-s),T(1-o)],[u,h]=[T(1-s**this.#t),T(1-o**this.#t)];return e.map((c,d)=>{let m=t[d],y=this.#e[d]+=T(i*T(m-this.#e[d])),
f=this.#r[d]+=T(l*T(T(m*m)-this.#r[d])),g=T(T(Math.sqrt(T(T(f)/h)))+a);return T(c+T(T(T(n)*T(T(y)/u))/g))})}};function Ql(r){let e=Array.from(r).sort((t,n)=>t-n);
return r.map(t=>(e.indexOf(t)+e.lastIndexOf(t))/(2*(r.length-1))-.5)}var Cr=class{genome;groups;#e;#r;#t;#n=[];constructor(e,t,n){[this.genome,this.#r,this.#e,this.#t]=
[e,t,n,new Rn(e.length)],this.groups=Int32Array.from({length:n.population},(s,o)=>o%(n.population/2))}get#a(){let{sigma:e,fixed:t}=this.#r,[n,s]=[0,0];return this.
genome.forEach((o,a)=>{t?.[a]||(n+=o*o,s+=1)}),Math.max(e,this.#e.relative_sigma*Math.sqrt(n/s))}ask(e){let[t,n]=[this.#e.population/2,this.genome.length];this.#n=
this.#r.draw(t,e);let s=T(this.#a/this.#r.sigma),o=new Float32Array(2*t*n);return this.#n.forEach((a,i)=>{for(let l=0;l<n;l++){let u=T(s*a[l]);o[i*n+l]=this.genome[l]+
u,o[(t+i)*n+l]=this.genome[l]-u}}),o}tell(e){let[t,n]=[Ql(e),this.#n.length],s=new Float32Array(this.genome.length);this.#n.forEach((o,a)=>{let i=T((t[a]-t[n+a])/
(2*n*this.#r.sigma**2));for(let l=0;l<s.length;l++)s[l]+=T(i*o[l])}),this.genome=this.#t.moved(this.genome,s,this.#e.learning_rate)}},Mt=class{population;groups;#e;#r;#t=new Float64Array(
0);#n=0;constructor(e,t,n){[this.population,this.#r,this.#e]=[e,t,n],this.groups=new Int32Array(n.population)}get genome(){return this.#a(this.#n).slice()}#a(e){
let{size:t}=this.#r;return this.population.subarray(e*t,(e+1)*t)}#s(e,t){let n=this.#e.tournament??Jl,s=t.integers(this.#t.length,e*n);return Array.from({length:e},
(o,a)=>s.subarray(a*n,(a+1)*n).reduce((i,l)=>this.#t[l]>this.#t[i]?l:i))}ask(e){if(!this.#t.length)return this.population;let{size:t}=this.#r,{population:n,elites:s}=this.#e,
o=n-s,a=this.#s(o,e);this.#s(o,e);let i=Array.from(this.#t.keys()).sort((u,h)=>this.#t[h]-this.#t[u]).slice(0,s),l=new Float32Array(this.population.length);return[
...i,...a].forEach((u,h)=>l.set(this.#a(u),h*t)),this.#r.draw(o,e).forEach((u,h)=>{let c=(s+h)*t;for(let d=0;d<t;d++)l[c+d]+=u[d]}),this.population=l,l}tell(e){
this.#t=e,this.#n=e.indexOf(Math.max(...e))}};function $a(r,e,t,n){let[s,o]=[r.length,Math.max(...r)+1],a=o>1?s/o:1,i=Array.from(r.keys()).sort((c,d)=>r[c]-r[d]),l=[],u=[];for(let c=0;c<e;c++){let d=c%a;d===
0&&(u=Array.from(n.permutation(s/a)).flatMap(m=>i.slice(m*a,(m+1)*a))),l.push([i,u.map((m,y)=>u[y-y%a+(y%a-d+a)%a])])}let h=c=>i.map(()=>s+c);for(let c=0;c<t[1];c++)
l.push([i,h(c)]);for(let c=0;c<t[0];c++)l.push([h(c),i]);return{pursuer:Int32Array.from(l.flatMap(([c])=>c)),evader:Int32Array.from(l.flatMap(([,c])=>c)),group:Int32Array.
from(l.flatMap((c,d)=>i.map(m=>d*o+r[m])))}}function La(r,e,t,n){let s=Math.max(...e)+1,[o,a]=[new Float64Array(t*s),new Float64Array(t*s)];n.forEach((l,u)=>{if(r[u]>=
t)return;let h=r[u]*s+e[u];o[h]+=l,a[h]+=1});let i=o.map((l,u)=>a[u]?l/a[u]:0);return Float64Array.from({length:t},(l,u)=>{let h=i.subarray(u*s,(u+1)*s);return _n(
h)/a.subarray(u*s,(u+1)*s).filter(Boolean).length})}var eu=128,Ke=8;function _n(r){let{length:e}=r;if(e>eu){let d=Math.floor(e/2)-Math.floor(e/2)%Ke;return _n(r.
subarray(0,d))+_n(r.subarray(d))}if(e<Ke)return r.reduce((d,m)=>d+m,0);let t=r.slice(0,Ke),n=e-e%Ke;for(let d=Ke;d<n;d++)t[d%Ke]+=r[d];let[s,o,a,i,l,u,h,c]=t;return r.
subarray(n).reduce((d,m)=>d+m,s+o+(a+i)+(l+u+(h+c)))}var C=["pursuer","evader"],_e=r=>r==="pursuer"?"evader":"pursuer";var Ia=({world:r})=>r.rules.teammate==="REACH"?.2:0;var Fa=["generation","team","epoch","opponent","fitness_mean","fitness_std","fitness_best","capture_rate","length","pursuer_faults","evader_faults","matches","s\
teps"],Or={pursuer:["random","clumsy-fleer"],evader:["random","clumsy-chaser"]},tu=20,ru=8,nu=-1,Rr=({world:r,policy:e},t,n)=>({fov:r.fov,hidden:e.hidden,mask:e.
mask==="none"?null:t[n]}),qe=class{settings;archive={pursuer:[],evader:[]};rows=[];cells=new Map;counters=[];#e;#r;#t;#n={};#a=new Set;#s=0;#u=0;#h=0;constructor(e,t,n,s=Na(
t.seed)){[this.#e,this.settings,this.#r,this.#t]=[e,t,n,s];for(let o of C){let{initial_weight:a,initial_head:i}=t.policy,l=s("initial",C.indexOf(o)),u=t.learner.
kind==="ga"?t.learner.population:1,h=Array.from({length:u},()=>Ca(this.shape(o),l,a,i));this.#p(o,h),this.archive[o].push(this.#n[o].genome)}this.#x()}shape(e){
return Rr(this.settings,this.#r,e)}get finished(){return Math.min(this.archive.pursuer.length,this.archive.evader.length)}*run(){yield*this.#w(0);for(let e=1;e<=
this.settings.schedule.generations;e++){if(this.settings.schedule.kind==="alternating")for(let t of C)yield*this.#c(t,e);else yield*this.#l(e);this.#x(),yield*this.#w(
e)}}change(e){let t=this.settings,n={pursuer:this.shape("pursuer"),evader:this.shape("evader")},s=l=>JSON.stringify(l(t))===JSON.stringify(l(e));this.settings=e;
let o=s(l=>[l.world.fov,l.policy]);if(!o||!s(l=>l.learner))for(let l of C){let u=h=>ka(h,n[l],this.shape(l));this.archive[l]=this.archive[l].map(u),this.#p(l,this.#i(
l).map(u))}if(o&&s(l=>l.world))return null;this.cells.clear(),this.#a.clear();let{pursuer:a,evader:i}=this.archive;return{type:"anew",settings:e,genomes:{pursuer:a.
slice(0,this.finished),evader:i.slice(0,this.finished)}}}#i(e){let t=this.#n[e];if(!(t instanceof Mt))return[t.genome];let n=t.genome.length,s=Array.from({length:t.
population.length/n},(o,a)=>t.population.slice(a*n,(a+1)*n));return Array.from({length:this.settings.learner.population},(o,a)=>a===0?t.genome:s[a%s.length])}#p(e,t){
let{learner:n}=this.settings,[s,o]=[this.shape(e),n.kind==="ga"?n.mutation:n.sigma],a=Mn(s),i=new Tr(Ye(s),this.#t("noise",C.indexOf(e)),o,a?.fixed??null),l=t.map(
u=>En(u,a));this.#n[e]=n.kind==="ga"?new Mt(kr(l),i,n):new Cr(l[0],i,n)}*#c(e,t){for(let n=0;n<this.#o(e);n++){let s=this.archive[_e(e)].length,o=this.settings.
schedule[`${e}s_meet`],a=o==="latest"?s-1:o==="round-robin"?n%s:this.#t("opponents",C.indexOf(e),t,n).choice(s,1)[0],i=e==="pursuer"?[t,a]:[a,t],l=this.#n[e],{groups:u}=l,
h=At([this.settings.seed,...i,Cn[e],n],Math.max(...u)+1),c=l.ask(this.#t("learn",C.indexOf(e),t,n)),[d,m]=[Int32Array.from(u.keys()),new Int32Array(u.length)],y={
[e]:c,[_e(e)]:this.archive[_e(e)][a]},f={[e]:d,[_e(e)]:m},g=this.#f(y,f,BigUint64Array.from(u,S=>h[S])),b=this.#g(g,e);this.#b(g,b,{generation:t,team:e,epoch:n,
opponent:a}),l.tell(b),yield*this.#v(t,n,e)}this.archive[e].push(this.#n[e].genome)}*#l(e){for(let t=0;t<this.#o("pursuer");t++){let{schedule:n,learner:{population:s}}=this.
settings,[o,a]=n.kind==="hall-of-fame"?[n.hall_sample,n.contemporaries]:[0,1],i={pursuer:this.#m("pursuer",e,t),evader:this.#m("evader",e,t)},l=this.#t("opponen\
ts",0,e,t),u={pursuer:this.#d(o,l),evader:this.#d(o,l)},h=g=>kr([i[g],...Array.from(u[_e(g)],b=>this.archive[g][b])]),c=[u.evader.length,u.pursuer.length],d=$a(
this.#n.pursuer.groups,a,c,l),m=At([this.settings.seed,e,e,Cn.both,t],Math.max(...d.group)+1),y={pursuer:h("pursuer"),evader:h("evader")},f=this.#f(y,d,BigUint64Array.
from(d.group,g=>m[g]));for(let g of C){let b=La(d[g],d[_e(g)],s,this.#g(f,g));this.#b(f,b,{generation:e,team:g,epoch:t,opponent:nu}),this.#n[g].tell(b)}yield*this.#v(
e,t,"both")}for(let t of C)this.archive[t].push(this.#n[t].genome)}#m(e,t,n){return this.#n[e].ask(this.#t("learn",C.indexOf(e),t,n))}#d(e,t){let n=this.archive.
pursuer.length;return e?t.choice(n,Math.min(e,n)):new Int32Array(0)}#o(e){let{schedule:t}=this.settings;return t.kind==="hall-of-fame"?t.joint_epochs:t[`${e}_ep\
ochs`]}*#v(e,t,n){let[s,o]=this.settings.schedule.kind==="hall-of-fame"?[this.#o("pursuer"),0]:[this.#o("pursuer"),this.#o("evader")],a=t+1+(n==="evader"?s:0),i=s+
o;yield{type:"epoch",done:(e-1)*i+a,of:this.settings.schedule.generations*i},yield*this.catchUp()}#f(e,t,n){let s={...this.settings.world,max_steps:this.settings.
train_steps},o=this.#e.rollouts(s,this.#y("pursuer",e.pursuer),this.#y("evader",e.evader),{...t,seed:n},1);this.#s+=o.length.length;for(let a of o.length)this.#u+=
Number(a);for(let a of o.agent_steps)this.#h+=Number(a);return o}#y(e,t){return St(this.shape(e),t)}#g({captured_fraction:e,overlap:t},n){let s=Ia(this.settings);
return Float64Array.from(e,(o,a)=>n==="pursuer"?o:1-o-s*Number(t[2*a+1]))}#b(e,t,n){let s=$(t),o=[0,0];e.faults.forEach((a,i)=>o[Math.floor(i/3)%2]+=Number(a)),
this.rows.push({...n,fitness_mean:s,fitness_std:Math.sqrt($(t.map(a=>(a-s)**2))),fitness_best:Math.max(...t),capture_rate:$(e.capture_rate),length:$(e.length),pursuer_faults:o[0]/
e.length.length,evader_faults:o[1]/e.length.length,matches:this.#s,steps:this.#u})}#x(){this.counters.push({matches:this.#s,steps:this.#u,agent_steps:this.#h})}*#w(e){
yield{type:"generation",number:e,genomes:{pursuer:this.archive.pursuer[e],evader:this.archive.evader[e]}},yield*this.catchUp()}*catchUp(){for(let e=this.finished-
1;e>=0;e--){for(let t=e;t>=0;t--)for(let[n,s]of t===e?[[e,e]]:[[e,t],[t,e]]){if(this.cells.has(`${n} ${s}`))continue;let o=this.#S(n,s);this.cells.set(`${n} ${s}`,
o),yield{type:"cell",cell:o}}this.#a.has(e)||(this.#a.add(e),yield{type:"scores",number:e,scores:{pursuer:this.#A("pursuer",e),evader:this.#A("evader",e)}})}}#S(e,t){
let{world:n,evaluation_episodes:s,seed:o}=this.settings,a={pursuer:new Int32Array(1),evader:new Int32Array(1),seed:BigUint64Array.of(Er(o,e,t))},i=C.map(h=>this.#y(
h,this.archive[h][h==="pursuer"?e:t])),l=this.#e.rollouts(n,...i,a,s),u=h=>{let c=Array.from(l[h],Number),d=c.length/s;return Array.from({length:d},(m,y)=>$(c.filter(
(f,g)=>g%d===y)))};return{pursuer:e,evader:t,capture_rates:Array.from(l.capture_rate),lengths:Array.from(l.length),means:{collisions:u("collisions"),faults:u("f\
aults"),agent_steps:u("agent_steps"),survivors:u("survivors")}}}#A(e,t){let{world:n,seed:s}=this.settings,[o,a]=[this.#y(e,this.archive[e][t]),new Int32Array(1)];
return $(Or[e].map((i,l)=>{let u=At([s,C.indexOf(e),l,ru],1),h=e==="pursuer"?[o,i]:[i,o],c=$(this.#e.rollouts(n,...h,{pursuer:a,evader:a,seed:u},tu).capture_rate);
return e==="pursuer"?c:1-c}))}};function kr(r){let e=new Float32Array(r.reduce((n,{length:s})=>n+s,0)),t=0;for(let n of r)e.set(n,t),t+=n.length;return e}var Pn=r=>Array.from({length:r},()=>Array(r)),_r=class{learning=C;settings=[];training={capture_rate:[],generation:[],learner:[],epochs:1,window:1,matches:0};limits="";name;schedule;seed;seeds;world;payoff;teams;findings=null;genomes={
pursuer:[],evader:[]};#e;#r;#t;constructor(e,t,n,s){[this.#t,this.#e,this.#r,this.name,this.schedule]=[e,t,s,n,n],[this.world,this.seed]=[e.world,String(e.seed)];
let o=e.schedule.generations+1;this.seeds=Array.from({length:o},(a,i)=>Array.from({length:o},(l,u)=>String(Er(e.seed,i,u)))),this.payoff=this.#n(),this.teams=this.#a()}get newest(){
return this.genomes.pursuer.length-1}#n(){let e=this.#t.schedule.generations+1;return{first:[0,0],shape:[e,e],episodes:this.#t.evaluation_episodes,capture_rate:Pn(
e),capture_rates:Pn(e),lengths:Pn(e)}}#a(){let e=t=>{let n=`${this.#r} ${t}`;_s(n,kr(this.genomes[t]));let{genome:s,...o}=St(Rr(this.#t,this.#e,t),this.genomes[t][0]??
new Float32Array(0));return{script:null,network:{...o,genome_size:s.length},kept:[...this.genomes[t].keys()],genomes:n}};return{pursuer:e("pursuer"),evader:e("e\
vader")}}policy(e,t){return St(Rr(this.#t,this.#e,e),this.genomes[e][t])}add(e){for(let t of C)this.genomes[t].push(e[t]);this.teams=this.#a()}change(e,t){this.#t=
e,this.world=e.world;for(let n of C)this.genomes[n]=[...t[n]];[this.payoff,this.teams,this.findings]=[this.#n(),this.#a(),null]}addCell({pursuer:e,evader:t,capture_rates:n,
lengths:s}){this.payoff.capture_rate[e][t]=$(n),this.payoff.capture_rates[e][t]=[...n],this.payoff.lengths[e][t]=[...s],this.findings={generalization:this.#s()}}#s(){
let e=this.payoff.capture_rate,t=o=>({mean:o,low:null,high:null}),n=o=>{let a=o.filter(i=>i!==void 0);return a.length?$(a):null},s=[...this.genomes.pursuer.keys()];
return{pursuers:t(s.map(o=>n(e[o]))),evaders:t(s.map(o=>n(e.map(a=>a[o]===void 0?void 0:1-a[o]))))}}};var Et=r=>`${Math.round(100*r)} %`,su=100,ou=0,Pr=class extends EventTarget{element;newest;beginning;settings;state="waiting";done=0;seconds=0;#e;#r;#t;#n=p("h2",
{class:"lane-title"});#a=p("p",{class:"facts numbers"});#s=p("div",{class:"lane-room",hidden:!0});#u=p("section",{class:"card measures",hidden:!0});#h=p("div");#i;#p={
pursuer:[],evader:[]};#c=new Map;#l;#m;#d=()=>{};#o=0;#v=!0;#f=0;#y=null;constructor(e,t,n,s){super(),[this.#e,this.#r,this.#t,this.settings]=[e,t,n,s],this.newest=
new wt(()=>this.#A(this.#i.newest)),this.beginning=new wt(()=>this.#A(0)),this.beginning.element.classList.add("beginning");let o=p("div",{class:"boards"},this.
newest.element,this.beginning.element);this.element=p("section",{class:"lane"},this.#n,this.#a,o,this.#s,this.#u,this.#h),n.onmessage=({data:a})=>this.#b(a),this.
reset(s)}reset(e){this.#g({type:"stop"}),[this.settings,this.state,this.done]=[e,"waiting",0],this.#S();let{archive:t}=new qe(this.#r,e,this.#e.masks);this.#i.add(
{pursuer:t.pursuer[0],evader:t.evader[0]}),this.#s.hidden=this.#u.hidden=!0,this.#E(!0),this.#M()}start(){this.#S(),[this.state,this.done]=["evolving",0],this.#s.
hidden=!1,this.#u.hidden=!0,this.#g({type:"start",settings:this.settings,masks:this.#e.masks}),this.#M()}stop(){this.#g({type:"stop"}),this.state==="evolving"&&
(this.state="stopped"),this.#M()}change(e){if(this.state==="waiting")return this.reset(e);this.settings=e,this.#g({type:"change",settings:e}),this.#M()}takeOver(){
let e=this.#i.newest;this.#m.play({run:0,pursuer:e,evader:e,episode:0,seed:null},{seat:this.#i.world.n_pursuers,from:0,moves:[]})}saved(){return new Promise(e=>{
this.#y=e,this.#g({type:"save"})})}get newestGeneration(){return this.#i.newest}close(){this.#t.terminate(),this.newest.runs=this.beginning.runs=!1}#g(e){this.#t.
postMessage(e)}#b(e){if(e.type==="generation"){if(this.state!=="evolving")return;this.#i.add(e.genomes),this.#E(e.number===0)}else if(e.type==="cell"){let{pursuer:t,
evader:n}=e.cell;this.#i.addCell(e.cell),this.#v&&t===n&&t===this.#i.newest&&this.#l.select({pursuer:t,evader:n}),this.#c.set(`${t} ${n}`,e.cell)}else if(e.type===
"scores")for(let t of C)this.#p[t][e.number]=e.scores[t];else e.type==="anew"?(this.#i.change(e.settings,e.genomes),this.#w(),this.#E(!0)):e.type==="epoch"?this.
done=e.done/e.of:e.type==="end"?(this.state==="evolving"&&([this.state,this.seconds,this.done]=["ended",e.seconds,1]),this.#T()):e.type==="saved"?this.#y?.(e.race):
(this.#a.textContent=`The race failed: ${e.message}`,this.state="stopped");this.#f||(this.#f=setTimeout(()=>requestAnimationFrame(()=>this.#x()),su))}#x(){this.#f=
0,this.#l.dispatchEvent(new Event("run")),this.#d(),this.#M()}#w(){this.#c=new Map,this.#p={pursuer:[],evader:[]},this.#u.hidden=!0}#S(){let e=`race ${ou++}`,t=Bt(
this.settings);this.#i=new _r(this.settings,this.#e.masks,t,e),this.#w(),this.#v=!0,this.#l=new wr({run:0,pursuer:0,evader:0,episode:0,seed:null});let[n,s]=[new br(
[this.#i],this.#l),new yr([this.#i],this.#l,null)];n.element.ariaLabel=`Payoff matrix. ${t}`,this.#m=new Mr([this.#i],this.#l,s,!1),this.#m.start(this.#r);let o=p(
"dialog",{class:"of-cell-match","aria-label":"Match",onclose:()=>s.player.pause()},p("button",{type:"button",class:"leave",onclick:()=>o.close()},"Close"),s.element),
a=!1;n.element.addEventListener("play",()=>{let{pursuer:l,evader:u}=this.#l.selected;this.#v=!1,this.#i.payoff.capture_rate[l][u]!==void 0&&(o.showModal(),a||s.
start(this.#r),a=!0,s.playSoon())});let i=js(`Scores against scripts, by generation: ${Or.pursuer.join(", ")} and ${Or.evader.join(", ")}`,(l,u)=>{let h=this.settings.
schedule.generations,c=Ws(l,u,{low:0,high:h,label:"generation",whole:!0},{low:0,high:1,label:"score"});for(let d of C){let m=Array.from(this.#p[d],y=>y??null);zs(
c,[...m.keys()],m,`of-${d}s`)}return c},()=>{},l=>{let u=Math.min(this.#i.newest,Math.max(0,Math.round(l)));this.#l.select({pursuer:u,evader:u})});this.#d=i.redraw,
this.#s.replaceChildren(n.element,p("section",{class:"card scores"},p("h3",{},"Against opponents that never change"),p("p",{class:"small muted"},"Captures of ra\
ndom walkers and of clumsy fleers; escapes from random walkers and from clumsy chasers."),Bs(["pursuers","of-pursuers"],["evaders","of-evaders"]),i.element)),this.#h.
replaceChildren(o,this.#m.dialog)}#A(e){let t=this.#i.newest;if(t<0||e<0)return null;let{world:n,payoff:s,seeds:o}=this.#i,a=this.#o++%s.episodes;this.newest.title.
textContent=t?"Newest against newest":"Generation 0: nobody has learned anything yet",this.beginning.title.textContent="Pursuers of generation 0, newest evaders";
for(let u of[this.newest,this.beginning])u.generation=t;for(let u of[this.newest,this.beginning])u.label=`A match. ${u.title.textContent}`;let[i,l]=[this.#i.policy(
"pursuer",e),this.#i.policy("evader",t)];return this.#r.match(n,i,l,BigInt(o[e][t]),a)}#E(e){this.newest.renew(e),(this.#i.newest>0||this.state!=="waiting")&&this.
beginning.renew(e)}#M(){this.element.dataset.state=this.state,this.#n.textContent=Bt(this.settings);let e=this.#c.get(`${this.#i.newest} ${this.#i.newest}`)??this.#c.
get(`${this.#i.newest-1} ${this.#i.newest-1}`),t=e?[`Generation ${this.#i.newest} of ${this.settings.schedule.generations}`,`the newest pursuers catch ${Et($(e.
capture_rates))} of the newest evaders`,`${au(e).toFixed(0)} collisions in 1000 moves`]:[];this.#a.replaceChildren(...t.map(n=>p("span",{},n))),this.dispatchEvent(
new Event("state"))}#T(){this.#u.ariaLabel=`What came out. ${Bt(this.settings)}`;let e=this.#i.payoff.capture_rate.slice(0,this.#i.newest+1).map(n=>n.slice(0,this.#i.
newest+1));if(e.length<2||e.some(n=>Array.from(n).includes(void 0)))return;let t=[["Score against scripts: generation 0",n=>Et(this.#p[n][0]??0)],["Score agains\
t scripts: newest generation",n=>Et(this.#p[n].at(-1)??0)],["Newest generation against all generations of the other team",n=>Et(Aa(e,n))],["Below its own best s\
o far, in the later half (forgetting)",n=>Et(Ma(e,n))]];this.#u.replaceChildren(p("h3",{},"What came out"),p("table",{class:"numbers"},p("thead",{},p("tr",{},p(
"td"),...C.map(n=>p("th",{scope:"col",class:n},`${n}s`)))),p("tbody",{},...t.map(([n,s])=>p("tr",{},p("th",{scope:"row"},n),...C.map(o=>p("td",{},s(o))))))),p("\
p",{class:"small muted"},"These are measures without a verdict: one race proves little. Save it, and ",p("code",{},"matrixworld judge")," weighs luck and says w\
hat happened.")),this.#u.hidden=!1}};function au({means:{faults:r,agent_steps:e}}){let t=n=>n.reduce((s,o)=>s+o,0);return 1e3*t(r)/Math.max(1,t(e))}var Ua=r=>Ee(JSON.stringify(r,null,2)),Nn=(r,...e)=>({dtype:"<f8",shape:e,data:Float64Array.from(r)}),iu=r=>Math.sqrt($(r.map(e=>(e-$(r))**2)));function lu({archive:r,
rows:e,counters:t},n){let s=e.filter(({generation:i})=>i===n),o=Ee(s.map(i=>`${[n,...Fa.map(l=>i[l])].join(",")}
`).join("")),a=i=>({dtype:"<f4",shape:[1,r[i][n].length],data:r[i][n]});return{pursuers:a("pursuer"),evaders:a("evader"),log:{dtype:`|S${Math.max(1,o.length)}`,
shape:[],data:o.length?o:new Uint8Array(1)},...Object.fromEntries(Object.entries(t[n]).map(([i,l])=>[i,Nn([l])])),...n?{score:Nn([$(s.slice(Math.floor(s.length/
2)).map(i=>i.capture_rate))])}:{}}}function uu(r){let e=r.finished,t=Array.from({length:e*e},(o,a)=>r.cells.get(`${Math.floor(a/e)} ${a%e}`)),n=t[0].lengths.length,
s=(o,...a)=>Nn(t.flatMap(o),e,e,...a);return{scores:{dtype:"<f4",shape:[e,e,n],data:Float32Array.from(t.flatMap(({capture_rates:o})=>o))},mean:s(({capture_rates:o})=>$(
o)),std:s(({capture_rates:o})=>iu(o)),lengths:{dtype:"<i4",shape:[e,e,n],data:Int32Array.from(t.flatMap(({lengths:o})=>o))},collisions:s(({means:o})=>o.collisions,
2,3),faults:s(({means:o})=>o.faults,2,3),agent_steps:s(({means:o})=>o.agent_steps,2),pursuer_survivors:s(({means:o})=>o.survivors[0]),evader_survivors:s(({means:o})=>o.
survivors[1])}}function cu(r,{format:e,version:t}){let n=r.finished-1,s={...r.settings,schedule:{...r.settings.schedule,generations:n}},o={format:e,matrixworld:t,
settings:s,drawn_by:"page"},a=Array.from({length:r.finished},(d,m)=>`stage-${String(m).padStart(4,"0")}.npz`),{matches:i,steps:l,agent_steps:u}=r.counters[n],c={
stages:n,...{training_matches:i,training_steps:l,training_agent_steps:u},disengagement:[],evaluation_matches:r.finished**2*r.settings.evaluation_episodes};return{
"config.json":Ua(o),...Object.fromEntries(a.map((d,m)=>[d,bt(lu(r,m))])),"payoff.npz":bt(uu(r)),"summary.json":Ua(c)}}function Da(r,e){let t=r.flatMap(({name:n,
race:s})=>Object.entries(cu(s,e)).map(([o,a])=>[r.length>1?`${n}/${o}`:o,a]));return Wt(Object.fromEntries(t))}var Wa=r=>r.finished>1&&r.cells.size>=r.finished**
2&&C.every(e=>r.archive[e].length);var hu=12;function za(r){let e=new Blob([xe("script-engine"),`
`,xe(`script-${r}`)],{type:"text/javascript"});return new Worker(URL.createObjectURL(e))}function Ba(){let r=h=>postMessage(h),e=Nt(),t=null,n=null,s=0,o=!1,a=new MessageChannel,
i=()=>{let h=performance.now()+hu;for(;n&&performance.now()<h;){let{value:c,done:d}=n.next();d?(n=null,r({type:"end",seconds:(performance.now()-s)/1e3})):r(c)}!n||
o||(o=!0,a.port2.postMessage(null))},l=async h=>{if(h.type==="start")t=new qe(await e,h.settings,h.masks),[n,s]=[t.run(),performance.now()],i();else if(h.type===
"stop")n=null;else if(h.type==="change"){let c=t?.change(h.settings);if(c&&r(c),!t||!c||n)return;n=t.catchUp(),i()}else if(t){let{settings:c,archive:d,rows:m,cells:y,
counters:f,finished:g}=t;r({type:"saved",race:{settings:c,archive:d,rows:m,cells:y,counters:f,finished:g}})}},u=h=>{Promise.resolve().then(h).catch(c=>{n=null,r(
{type:"failed",message:String(c)})})};a.port1.onmessage=()=>{o=!1,u(i)},globalThis.onmessage=({data:h})=>u(()=>l(h))}var du=250,$n=class{#e;#r;lanes=[];#t=p("div",{class:"lanes"});#n=p("button",{type:"button",class:"evolve",onclick:()=>this.#g()});#a=p("progress",{max:1,value:0,
"aria-label":"Progress of the race"});#s=p("p",{class:"small muted numbers",role:"status"});#u=p("button",{type:"button",class:"side",title:"A second race of th\
e same seed with another schedule",onclick:()=>this.#x()},"Side by side");#h=p("button",{type:"button","aria-pressed":"false",title:"Drag over the board to draw\
 walls, and over walls to remove them",onclick:()=>this.#A()},"Draw walls");#i=p("button",{type:"button",onclick:()=>this.#w({walls:[]})},"No walls");#p=p("butt\
on",{type:"button",onclick:()=>this.#E()});#c=p("span",{class:"small muted",role:"status"});#l=Is((e,t)=>this.#w(e,t));#m=p("button",{type:"button",onclick:()=>{
this.#C()},title:"An archive that matrixworld judge, explore and replay read"},"Save");#d=[];#o;#v=0;constructor(e,t){[this.#e,this.#r,this.#o]=[e,t,Ls(e,location.
hash)];let n=p("div",{class:"doings",role:"group","aria-label":"What can be done"},this.#u,p("button",{type:"button",class:"to-play",title:"Play an evader again\
st the newest pursuers",onclick:()=>this.lanes[0].takeOver()},"Take over"),this.#h,this.#i,this.#p,this.#m,this.#c);document.getElementById("page").replaceWith(
hs("Evolve a chase","Triangles chase discs. Nobody has told either team how. Press Evolve, and both learn by trial and error, against each other."),p("main",{},
p("div",{class:"start"},this.#n,n,p("div",{class:"progress"},this.#a,this.#s)),this.#l.now,this.#t,this.#l.anew,p("div",{class:"card below"},It(),p("p",{class:"\
small muted"},"The page plays and learns with the engine of matrixworld, in this browser; nothing is sent."),p("p",{class:"small muted of-saving"},"A saved race\
 is an archive: ",p("code",{},"matrixworld judge"),", ",p("code",{},"explore")," and ",p("code",{},"replay")," read it. Python plays its matches again, and does\
 not continue it."))),p("footer",{class:"muted small"},`matrixworld ${e.version}`)),this.#y(),this.#M()}#f(){return[this.#o.schedule,...this.#o.beside?[this.#o.
beside]:[]]}#y(){for(let e of this.lanes.splice(0))e.close();for(let e of this.#f()){let t=new Pr(this.#e,this.#r,za("evolve"),Yt(this.#e,this.#o,e));t.addEventListener(
"state",()=>this.#T()),this.lanes.push(t)}this.#d=this.lanes.map(e=>e.newest.drawWalls(([t,n],s)=>this.#S(t,n,s))),this.#h.ariaPressed="false",this.#t.dataset.count=
String(this.lanes.length),this.#t.replaceChildren(...this.lanes.map(({element:e})=>e)),this.#l.show(this.#o),this.#T()}#g(){this.lanes.some(({state:e})=>e==="ev\
olving")?this.lanes.forEach(e=>e.stop()):this.#b()}#b(){this.#c.textContent="";for(let[e,t]of this.#f().entries()){let n=this.lanes[e];n.settings=Yt(this.#e,this.#o,
t),n.start()}}#x(){let e=this.#o.schedule==="specialist-specialist"?"generalist-generalist":"specialist-specialist";this.#w({beside:this.#o.beside?null:e},!0)}#w=(e,t=!1)=>{
let n=this.#f().length,s=this.lanes.every(({state:i})=>i==="waiting"),o={...this.#o,...e},a=Kt(o,Vt(this.#e));a||(this.#o=o),this.#l.show(this.#o),this.#c.textContent=
a,!a&&($t()&&history.replaceState(null,"",`#${$s(this.#o)}`),this.#f().length!==n&&this.#y(),t&&!s?this.#b():this.#f().forEach((i,l)=>this.lanes[l].change(Yt(this.#e,
this.#o,i))))};#S(e,t,n){let{rows:s,cols:o}=this.lanes[0].settings.world,a={...this.#o,walls:Ft(this.#o.walls,e*o+t,n)},i=Kt(a,this.lanes[0].settings.world);if(i)
return i;let{walls:l}=this.#o=a,u=Uint8Array.from({length:s*o},(h,c)=>Number(l.includes(c)));for(let h of this.lanes)h.newest.show(u);return clearTimeout(this.#v),
this.#v=setTimeout(()=>this.#w({walls:l}),du),""}#A(){let e=this.#h.ariaPressed!=="true";this.#h.ariaPressed=String(e);for(let t of this.#d)t(e)}#E(){let e=!this.
lanes[0].newest.runs;for(let{newest:t,beginning:n}of this.lanes)t.runs=n.runs=e;this.#M()}#M(){this.#p.textContent=this.lanes[0].newest.runs?"Pause boards":"Pla\
y boards"}#T(){if(!this.lanes.length)return;let e=this.lanes.map(({state:a})=>a),t=e.includes("evolving");document.body.dataset.state=e.every(a=>a==="waiting")?
"waiting":t?"evolving":"ended",this.#n.textContent=t?"Stop":e[0]==="waiting"?"Evolve":"Again",this.#u.ariaPressed=String(this.lanes.length>1),this.#i.hidden=!this.#o.
walls.length,this.#a.value=Math.min(...this.lanes.map(({done:a})=>a));let n=Math.max(...this.lanes.map(a=>a.seconds)),s=e.every(a=>a==="ended"),{seed:o}=this.#o;
this.#s.textContent=t?`Seed ${o}: generation ${this.lanes.map(a=>a.newestGeneration).join(" and ")}`:s?`Seed ${o}: the race took ${n.toFixed(1)} seconds.`:e.includes(
"stopped")?"Stopped.":""}async#C(){let e=await Promise.all(this.lanes.map(async n=>({name:Te(n.settings),race:await n.saved()})));if(!e.every(({race:n})=>Wa(n))){
this.#c.textContent="Wait for the next generation, and save then.";return}let t=`${e.map(n=>n.name).join("-and-")}-seed-${this.#o.seed}.zip`;Lt(t,Da(e,this.#e)),
this.#c.textContent=`Saved as ${t}.`}};async function pu(){let r=new $n(Ns(),await Nt());document.addEventListener("keydown",({key:e,target:t,ctrlKey:n,metaKey:s,
altKey:o})=>{let a=t instanceof HTMLInputElement||t instanceof HTMLSelectElement||document.querySelector("dialog[open]");e.toLowerCase()==="d"&&!a&&!n&&!s&&!o&&
Gr()}),window.addEventListener("hashchange",()=>location.reload()),Object.assign(window,{matrixworldEvolve:r})}typeof document>"u"?Ba():is(pu());})();
