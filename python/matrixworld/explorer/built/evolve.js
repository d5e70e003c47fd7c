/* built from web/ by "npm run build"; sources c99b4cbc7e8f386e30086535a47dfe8b0750db1db9febff8e06f1c5f2b5c9625 */
"use strict";(()=>{var zn={SIMULTANEOUS:0,SWARM_TURNS:1,AGENT_TURNS:2},st={DISAPPEAR:0,REACH:1,BOUNCE:2},Bn={OCCUPATION:0,SURROUND:1},jn={FAULT:0,INVOLVED:1};var Nr=["obstacle","teammate","adversary"],Ir=["vertex","edge","chain"],Hn=["turn","kind","form","first","second","row","col","at_fault","held","doomed"],Fr=["p\
ursuer_{number}","evader_{number}"],Gn={obstacle:"{first} ran into the obstacle or border at {cell}",vertex:"{first} and {second} both headed for {cell}",edge:"\
{first} and {second} meant to swap, {first} to {cell}",chain:"{first} headed for {cell}, where {second} had to stay"},ot={"both held":"both bounce","both doomed":"\
both disappear",held:"{agent} bounces",doomed:"{agent} disappears",none:"nobody is stopped"},Vn="{event}: {outcome}",Ur={random:"any action, all equally likely",
still:"always stays",chaser:"moves to where the nearest adversary in view is nearest",fleer:"moves to where the nearest adversary in view is farthest","clumsy-c\
haser":"a chaser that takes any action in half of the steps",hunter:"a chaser of the nearest adversary in view to which no teammate in view is nearer",surrounder:"\
a chaser of the nearest free cell beside an adversary without a teammate","clumsy-fleer":"a fleer that takes any action in half of the steps",dodger:"moves to w\
here all adversaries in view together are farthest","team-surrounder":"shares the free cells beside adversaries with its teammates, and searches","careful-rando\
m":"as random, but takes only moves that right of way allows","careful-chaser":"as chaser, but takes only moves that right of way allows","careful-fleer":"as fl\
eer, but takes only moves that right of way allows","careful-clumsy-chaser":"as clumsy-chaser, but takes only moves that right of way allows","careful-hunter":"\
as hunter, but takes only moves that right of way allows","careful-surrounder":"as surrounder, but takes only moves that right of way allows","careful-clumsy-fl\
eer":"as clumsy-fleer, but takes only moves that right of way allows","careful-dodger":"as dodger, but takes only moves that right of way allows","careful-team-\
surrounder":"as team-surrounder, but takes only moves that right of way allows"},Yn={free:".GS",blocked:"#@OTW"};var Ue=1+Hn.length;function at(r,e){return r.replace(/\{(\w+)\}/g,(t,n)=>String(e[n]))}function H(r,e){return r<e?at(Fr[0],{number:r}):at(Fr[1],{number:r-e})}function Ya(r,e){
let[t,n,s,o,a,i,l,...u]=Array.from(r),c=a<0?[o]:[o,a],[h,d,p]=u.map(b=>c.filter((x,w)=>b>>w&1)),g=c.map(b=>H(b,e)),f=at(Gn[a<0?"obstacle":Ir[s]],{first:g[0],second:g[g.
length-1],cell:`(${i}, ${l})`}),y=at(Vn,{event:f,outcome:qa(c.length,d,p,e)});return{kind:Nr[n],form:Ir[s],agents:c,cell:[i,l],at_fault:h,held:d,doomed:p,turn:t,
text:y}}function qa(r,e,t,n){if(r===2&&e.length===2)return ot["both held"];if(r===2&&t.length===2)return ot["both doomed"];let s=o=>a=>at(ot[o],{agent:H(a,n)});
return[...e.map(s("held")),...t.map(s("doomed"))].join(", ")||ot.none}function Lt(r,e){let t=[];for(let n=0;n<r.length;n+=Ue)t.push(Ya(r.subarray(n+1,n+Ue),e));
return t}var ve=class extends Error{name="EngineError"};function I(r,e,t){let n=typeof t=="string"?`'${t}'`:typeof t=="object"?JSON.stringify(t):String(t);return new ve(
`${r}: expected ${e}, got ${n}`)}var De=class{bytes;constructor(e){this.bytes=e}},Jn=0,Wr=[Uint8Array,Uint8Array,Int32Array,BigInt64Array,BigUint64Array,Float32Array,Float64Array],qn=4,Kn=4,Ka=new TextEncoder,
Ja=new TextDecoder;function Za(r){for(let e=Wr.length-1;e>Jn;--e)if(r instanceof Wr[e])return e;throw new TypeError("array: expected a typed array of the engine\
's numbers, got another")}function Dr(r){return new Uint8Array(r.buffer,r.byteOffset,r.byteLength)}function Xa(r){return Ka.encode(`${r}\0`)}var zr=class{engine;addresses=[];constructor(e){
this.engine=e}copy(e){let t=this.engine._malloc(Math.max(e.length,1));if(t===0)throw new ve("memory: expected room for the arguments, got none");return this.addresses.
push(t),this.engine.HEAPU8.set(e,t),t}text(e){return this.copy(Xa(e))}arrays(e){let t=Object.entries(e),n=t.flatMap(([o,a])=>{let i=a instanceof De,l=i?a.bytes:
a;return[this.text(o),i?Jn:Za(l),l.length,this.copy(Dr(l))]}),s=this.copy(Dr(Int32Array.from(n)));return this.copy(Dr(Int32Array.of(t.length,s)))}free(){for(let e of this.
addresses)this.engine._free(e)}};function Zn(r,e){let t=r.HEAPU8;return Ja.decode(t.subarray(e,t.indexOf(0,e)))}function We(r){let e=new Int32Array(r.HEAPU8.buffer),
t=r._last_outputs()/qn,n=e[t+1]/qn,s={};for(let o=n;o<n+e[t]*Kn;o+=Kn){let a=Wr[e[o+1]],i=e[o+2]*a.BYTES_PER_ELEMENT,l=e[o+3];s[Zn(r,e[o])]=new a(r.HEAPU8.slice(
l,l+i).buffer)}return s}function we(r,e){let t=new zr(r);try{let n=e(t);if(n===0)throw new ve(Zn(r,r._last_error()));return n}finally{t.free()}}var Qa=2**31-1,Xn=["none","gru"],ei=2n**64n-1n,ti=34028234663852886e22;function de(r,e){if(typeof e!="number"||!Number.isInteger(e)||Math.abs(e)>Qa)throw I(r,"a\
n integer",e);return Int32Array.of(e)}function $t(r,e){if(typeof e!="boolean")throw I(r,"true or false",e);return new De(Uint8Array.of(Number(e)))}function Ce(r,e,t){
let n=typeof e=="string"&&Object.hasOwn(t,e)?t[e]:void 0;if(n===void 0)throw I(r,`one of ${Object.keys(t).join(", ")}`,e);return Int32Array.of(n)}function Br(r,e){
if(typeof e!="number"||!(Math.abs(e)<=ti))throw I(r,"a finite number",e);return e}function ze(r,e){let n=typeof e=="bigint"||typeof e=="number"&&Number.isSafeInteger(
e)?BigInt(e):-1n;if(n<0n||n>ei)throw I(r,"an integer from 0 to 2^64 - 1",e);return BigUint64Array.of(n)}function ri(r){return{"rules.interaction":Ce("interactio\
n",r.interaction,zn),"rules.obstacle":Ce("obstacle",r.obstacle,st),"rules.teammate":Ce("teammate",r.teammate,st),"rules.evader":Ce("evader",r.evader,st),"rules.\
pursuer":Ce("pursuer",r.pursuer,st),"rules.capture":Ce("capture",r.capture,Bn),"rules.captured_disappear":$t("captured_disappear",r.captured_disappear)}}function Qn(r,e){
let t=typeof e=="number"?[e,e,e]:e;if(!Array.isArray(t)||t.length!==3)throw I(r,"1 or 3 numbers",e);return Float32Array.from(t,n=>Br(r,n))}function ni(r){let e=(t,n)=>Float32Array.
of(Br(t,r[t]),Br(n,r[n]));return{"rewards.capture":e("pursuer_capture","evader_capture"),"rewards.neighbor":e("pursuer_neighbor","evader_neighbor"),"rewards.ste\
p":e("pursuer_step","evader_step"),"rewards.pursuer_collide":Qn("pursuer_collide",r.pursuer_collide),"rewards.evader_collide":Qn("evader_collide",r.evader_collide),
"rewards.blame":Ce("blame",r.blame,jn),"rewards.capture_repeats":$t("capture_repeats",r.capture_repeats)}}function ts(r){if(r===void 0||typeof r=="number")return new Uint8Array(
0);if(r instanceof Uint8Array)return r;let{free:e,blocked:t}=Yn;for(let[n,s]of r.entries()){if(s.length!==r[0]?.length)throw I(`map, row ${n}`,`${r[0]?.length} \
cells as in row 0`,s.length);let o=[...s].find(a=>!e.includes(a)&&!t.includes(a));if(o)throw I(`map, row ${n}`,`'${e}' (free) or '${t}' (obstacle)`,o)}return Uint8Array.
from([...r.join("")],n=>Number(t.includes(n)))}function rs(r,e){if(!Array.isArray(r))return;let t=[r.length,r[0]?.length??0];if(!(t[0]===e.rows&&t[1]===e.cols))
throw I("obstacle map",`shape (${e.rows}, ${e.cols}), the rows and cols`,t)}function Be(r){rs(r.obstacles,r);let e=typeof r.obstacles=="number"?r.obstacles:0;return{
...ri(r.rules),...ni(r.rewards),rows:de("rows",r.rows),cols:de("cols",r.cols),n_pursuers:de("n_pursuers",r.n_pursuers),n_evaders:de("n_evaders",r.n_evaders),fov:de(
"fov",r.fov),diagonal:$t("diagonal",r.diagonal),max_steps:de("max_steps",r.max_steps),density:Float64Array.of(e),map:ts(r.obstacles)}}function es(r,e){return Int32Array.
from((e??[]).flat(),t=>de(r,t)[0])}function ns(r,e){return rs(r.obstacles,e),{seed:ze("seed",r.seed??0n),episode:ze("episode",r.episode??0),pursuers:es("pursuer\
s",r.pursuers),evaders:es("evaders",r.evaders),map:ts(r.obstacles)}}function Nt(r){return{actions:Int32Array.from(r,e=>de("actions",e)[0])}}function xe(r){if(typeof r==
"string"){if(!Object.hasOwn(Ur,r))throw I("policy",`one of ${Object.keys(Ur).join(", ")}`,r);return{script:new TextEncoder().encode(r)}}if(r.activation!=="relu"&&
r.activation!=="tanh")throw I("activation","'relu' or 'tanh'",r.activation);if(!Xn.includes(r.memory))throw I("memory",`one of ${Xn.join(", ")}`,r.memory);return{
hidden:Int32Array.from(r.hidden,e=>de("hidden",e)[0]),activation:new TextEncoder().encode(r.activation),sampled:$t("sampled",r.sampled),memory:new TextEncoder().
encode(r.memory),genome:r.genome}}var si=["first_turn","terminated","truncated"];function ss(r){let e={...r};for(let t of si)e[t]=new De(r[t]);return e}var os="statistics.",It=class{config;seed;episode;n_agents;statistics;first_conflict;constructor(e,t,n,s){this.config=e,this.seed=t,this.episode=n,this.n_agents=
e.n_pursuers+e.n_evaders,this.statistics=as(is(s),0),Object.assign(this,s),this.first_conflict=oi(this.conflict_table,this.length)}get length(){return this.actions.
length/this.n_agents}conflicts(e){this.check(e);let[t,n]=[this.first_conflict[e],this.first_conflict[e+1]],s=this.conflict_table.subarray(t*Ue,n*Ue);return Lt(s,
this.config.n_pursuers)}seek(e,t,n){this.check(t),(!(e.seed===this.seed&&e.episode===BigInt(this.episode))||e.turn!==0||e.steps>t)&&e.reset({seed:this.seed,episode:this.
episode});for(let o=e.steps;o<t;++o){let a=this.actions.subarray(o*this.n_agents,(o+1)*this.n_agents);n?e.replay(a,{pursuer:n.pursuers,evader:n.evaders}):e.step(
a)}}check(e){if(!(Number.isInteger(e)&&e>=0&&e<=this.length))throw I("step",`0 to ${this.length}`,e)}};function oi(r,e){let t=new Int32Array(e+2);for(let n=0;n<
r.length;n+=Ue)++t[r[n]+1];for(let n=1;n<t.length;++n)t[n]+=t[n-1];return t}function as(r,e){let t=r.length.length,n=o=>{let a=r[o],i=a.length/t;return a.slice(
e*i,(e+1)*i)},s=o=>Number(n(o)[0]);return{capture_rate:s("capture_rate"),ever_capture_rate:s("ever_capture_rate"),captured_fraction:s("captured_fraction"),length:s(
"length"),return:n("return"),survivors:n("survivors"),overlap:n("overlap"),collisions:n("collisions"),faults:n("faults"),agent_steps:n("agent_steps")}}var is=r=>Object.
fromEntries(Object.entries(r).flatMap(([e,t])=>e.startsWith(os)?[[e.slice(os.length),t]]:[]));function ls(r,e,t,n){let s=[Be(t.config),xe(t.pursuers),xe(t.evaders),
n];return we(r,o=>{let[a,i,l,u]=s.map(c=>o.arrays(c));return r[e](a,i,l,u)}),We(r)}function us(r,e,t,n){let s={seed:ze("seed",t),episode:ze("episode",n)};return new It(
e.config,t,n,ls(r,"_play_match",e,s))}function jr(r,e,t,n){if(!Number.isInteger(n)||n<1)throw I("n_episodes","at least 1",n);let s=ls(r,"_play_rollout",e,{...t,
n_episodes:Int32Array.of(n)});return is(s)}function cs(r,e,t,n){let s={pursuer:Int32Array.of(0),evader:Int32Array.of(0),seed:ze("seed",t)},o=jr(r,e,s,n);return Array.
from({length:n},(a,i)=>as(o,i))}var ai=7e6,ii=new FinalizationRegistry(([r,e])=>r._states_free(e));function li({rules:r,rows:e,cols:t,obstacles:n,diagonal:s,n_pursuers:o,n_evaders:a}){let i=typeof n==
"number"||r.obstacle==="REACH"?0:n.join("").split("#").length-1,l=e*t-i,u=[r.obstacle,r.teammate,r.pursuer].includes("DISAPPEAR"),c=r.capture==="SURROUND"||r.evader===
"REACH",h=r.interaction==="AGENT_TURNS",d=(f,y)=>Array.from({length:y},(b,x)=>h?f:(f+x)/(x+1)).reduce((b,x)=>b*x,1),p=d(l+Number(u),o)*d(l*(1+Number(c))+2,a);return{
SIMULTANEOUS:[o+a],SWARM_TURNS:[o,a],AGENT_TURNS:Array(o+a).fill(1)}[r.interaction].reduce((f,y)=>f+p*(s?9:5)**y,0)}function je(r){return typeof r.obstacles=="n\
umber"&&r.obstacles>0?"obstacles are drawn anew in each episode":li(r)>ai?"the world is too large to be solved on the page":""}var Hr=class{value;teams;matrix;n_actions;constructor(e,t){
let{matrix:n,rows:s,cols:o,value:a,agents:i}=t,[l,u]=e.actors,c=Array.from(i).filter(d=>l<=d&&d<u),h=d=>d<e.config.n_pursuers;[this.value,this.matrix,this.n_actions]=
[a[0],n,e.n_actions],this.teams=[{agents:c.filter(h),play:s},{agents:c.filter(d=>!h(d)),play:o}]}marginal(e){let t=this.teams.find(({agents:o})=>o.includes(e));
if(!t)return null;let n=this.n_actions**(t.agents.length-1-t.agents.indexOf(e)),s=Array(this.n_actions).fill(0);return t.play.forEach((o,a)=>s[Math.floor(a/n)%this.
n_actions]+=o),s}lost(e){let[t,n]=this.teams.map(({agents:l})=>l.reduce((u,c)=>u*this.n_actions+e[c],0)),[s,o]=this.teams.map(({play:l})=>l),a=o.reduce((l,u,c)=>l+
u*this.matrix[t*o.length+c],0),i=s.reduce((l,u,c)=>l+u*this.matrix[c*o.length+n],0);return[Math.max(0,this.value-a),Math.max(0,i-this.value)]}},Gr=60,it=class{config;payoff;engine;states;n_turns;values;starts;constructor(e,t,n){
[this.engine,this.config,this.payoff]=[e,t,n],this.states=we(e,l=>e._states_new(l.arrays(Be(t)))),ii.register(this,[e,this.states]);let s={SIMULTANEOUS:1,SWARM_TURNS:2,
AGENT_TURNS:t.n_pursuers+t.n_evaders};this.n_turns=s[t.rules.interaction];let{payoffs:o,starts:a}=this.call(()=>e._states_payoffs(this.states)),i=o;this.starts=
a,this.values=[[n==="capture-rate"?i:i.fill(0)]]}goBack(){let e=this.values.at(-1)[0],t=[];for(let s=this.n_turns-1;s>=0;s--){let o=t[s+1]??e;t[s]=this.backup(s,
{next:o})}this.payoff==="capture-time"&&(t[0]=t[0].map((s,o)=>o===this.config.n_evaders?0:s-1)),this.values.push(t);let n=this.payoff==="capture-rate"?this.config.
max_steps:Math.min(this.config.max_steps,Gr);return this.values.length<=n&&t[0].some((s,o)=>s!==e[o])}get value(){return this.mean(this.values.at(-1)[0])}guaranteed(e,t){
let n=xe(t),s=Array.from({length:this.n_turns},(a,i)=>this.call(l=>this.engine._states_weigh(this.states,i,+(e==="evader"),l.arrays(n))).play),o=this.values[0][0];
for(let a=0;a<this.config.max_steps;a++){let i=o;for(let l=this.n_turns-1;l>=0;l--)o=this.backup(l,{next:o,[`${e}s`]:s[l]});if(o.every((l,u)=>l===i[u]))break}return this.
mean(o)}mean(e){return this.starts.reduce((t,n)=>t+e[n],0)/this.starts.length}backup(e,t){return this.call(n=>this.engine._states_backup(this.states,e,n.arrays(
t))).values}game(e){let[t,{turn:n}]=[this.config.max_steps-e.steps,e],s=n+1===this.n_turns,o=t>0?this.values[Math.min(t-Number(s),this.values.length-1)]?.[s?0:n+
1]:void 0;if(!o)return null;let a=this.call(i=>this.engine._states_game(this.states,e.address,i.arrays({next:o})));return a.agents.length?new Hr(e,a):null}call(e){
return we(this.engine,e),We(this.engine)}};var hs=new FinalizationRegistry(([r,e])=>r._world_free(e)),lt=class{config;n_agents;n_actions;engine;at;freed=!1;constructor(e,t){this.engine=e,this.config=t,this.
n_agents=t.n_pursuers+t.n_evaders,this.n_actions=t.diagonal?9:5,this.at=we(e,n=>e._world_new(n.arrays(Be(t)))),hs.register(this,[e,this.at],this)}free(){this.freed||
(this.freed=!0,hs.unregister(this),this.engine._world_free(this.at))}get address(){if(this.freed)throw I("world","one that is in use","one that was freed");return this.
at}reset(e={}){let t=ns(e,this.config);this.call(n=>this.engine._world_reset(this.address,n.arrays(t)))}step(e){let t=Nt(e);this.call(n=>this.engine._world_step(
this.address,n.arrays(t)))}playTurn(e){let t=Nt(e);this.call(n=>this.engine._world_play_turn(this.address,n.arrays(t)))}decide(e,t,n){let{n_pursuers:s}=this.config,
o={pursuer:[0,s],evader:[s,this.n_agents]},[a,i]=typeof t=="string"?o[t]:t;if(n.length!==this.n_agents)throw I("actions",String(this.n_agents),n.length);let l=[
xe(e),Nt(n)],{actions:u}=this.call(c=>this.engine._world_decide(this.address,c.arrays(l[0]),a,i,c.arrays(l[1])));return Uint8Array.from(u)}replay(e,t){let n=o=>typeof o!=
"string"&&o.memory!=="none";if(!n(t.pursuer)&&!n(t.evader))return this.step(e);let{n_pursuers:s}=this.config;for(let o=this.n_turns;o>0;--o){let[a,i]=this.actors;
a<s&&this.decide(t.pursuer,[a,Math.min(i,s)],e),i>s&&this.decide(t.evader,[Math.max(a,s),i],e),this.playTurn(e)}}get n_turns(){return this.turnNumbers()[1]}get turn(){
return this.turnNumbers()[0]}get actors(){let[,,e,t]=this.turnNumbers();return[e,t]}turnNumbers(){return this.call(()=>this.engine._world_turn(this.address)).turn}get steps(){
return this.read("steps")[0]}get seed(){return this.read("seed")[0]}get episode(){return this.read("episode")[0]}get over(){return this.read("terminated")[0]===
1||this.read("truncated")[0]===1}read(e){return this.call(t=>this.engine._world_read(this.address,t.text(e)))[e]}view(e){let t=3*this.config.fov**2;return this.
read("views").slice(e*t,(e+1)*t)}map(){return this.read("state").slice(2*this.config.rows*this.config.cols)}conflicts(){return Lt(this.conflictTable(),this.config.
n_pursuers)}conflictTable(){return this.call(()=>this.engine._world_conflicts(this.address)).conflict_table}answer(e,t){let n=xe(e),{logits:s,memory:o}=this.call(
l=>this.engine._world_logits(this.address,l.arrays(n),t)),a=s,i=this.decide(e,[t,t+1],new Uint8Array(this.n_agents))[t];return{logits:a,probabilities:ui(a),action:i,
memory:o}}snapshot(){return this.call(()=>this.engine._world_snapshot(this.address))}restore(e){let t=ss(e);this.call(n=>this.engine._world_restore(this.address,
n.arrays(t)))}call(e){return we(this.engine,e),We(this.engine)}};function ui(r){let e=Math.max(...r),t=Array.from(r,s=>Math.exp(s-e)),n=t.reduce((s,o)=>s+o,0);return Float32Array.
from(t,s=>s/n)}var Vr=class{compiled;constructor(e){this.compiled=e}world(e){return new lt(this.compiled,e)}solution(e,t="capture-rate"){return new it(this.compiled,e,t)}match(e,t,n,s,o=0){
return us(this.compiled,{config:e,pursuers:t,evaders:n},s,o)}rollout(e,t,n,s,o){return cs(this.compiled,{config:e,pursuers:t,evaders:n},s,o)}rollouts(e,t,n,s,o){
return jr(this.compiled,{config:e,pursuers:t,evaders:n},s,o)}},ds;function Ft(r=globalThis.matrixworldEngine){return ds??=ci(r),ds}async function ci(r){if(!r)throw new Error(
"matrixworldEngine: expected the script engine.js before this one, got none");let e=Uint8Array.from(atob(r.binary),t=>t.charCodeAt(0));return new Vr(await r({wasmBinary:e}))}var hi="http://www.w3.org/2000/svg";function m(r,e={},...t){return ms(document.createElement(r),e,t)}function v(r,e={},...t){return ms(document.createElementNS(
hi,r),e,t)}function ms(r,e,t){for(let[n,s]of Object.entries(e))s==null||s===!1||(typeof s=="function"?r.addEventListener(n.slice(2),s):r.setAttribute(n,s===!0?"":
String(s)));return r.append(...t.filter(di).map(n=>typeof n=="number"?String(n):n)),r}function di(r){return r!=null&&r!==!1}var Ut=()=>["file:","http:","https:"].
includes(location.protocol);async function ps(r,e){r.select();try{await navigator.clipboard.writeText(r.value),e.textContent="Copied."}catch{e.textContent="Sele\
cted: copy it with Ctrl+C."}}function mi(){let r=document.documentElement.dataset.theme;return r?r==="dark":matchMedia("(prefers-color-scheme: dark)").matches}function Yr(){document.documentElement.
dataset.theme=mi()?"light":"dark"}if(typeof document<"u"){let r=document.documentElement.dataset,e=r.theme;addEventListener("beforeprint",()=>{e=r.theme,r.theme=
"light"}),addEventListener("afterprint",()=>{e?r.theme=e:delete r.theme})}function fs(){return m("button",{type:"button",title:"Light or dark (D)","aria-label":"\
Light or dark",onclick:Yr},"◐")}var ys=(r,e,...t)=>m("header",{class:"top"},m("div",{},m("h1",{},r),e?m("p",{class:"lead"},e):null),m("div",{class:"tools"},...t,fs()));var pi=Array.from({length:16},(r,e)=>{let[t,n]=[e%2?6.5:11,Math.PI*e/8];return`${12+t*Math.sin(n)} ${12-t*Math.cos(n)}`}).join(" ");function Dt(){let r=[["pursu\
er",v("path",{d:"M12 3 22 20H2z",class:"filled-pursuer"})],["evader",v("circle",{cx:12,cy:12,r:9,class:"filled-evader"})],["capture",v("polygon",{points:pi,class:"\
filled-capture"})],["captured evader",v("circle",{cx:12,cy:12,r:7.5,class:"ring-evader"})],["conflict",v("rect",{x:3,y:3,width:18,height:18,class:"dashed-confli\
ct"})]];return m("ul",{class:"shapes small","aria-label":"Shapes on the board"},...r.map(([e,t])=>m("li",{},v("svg",{viewBox:"0 0 24 24","aria-hidden":"true"},t),
e)))}var P=Uint8Array,J=Uint16Array,rn=Int32Array,Wt=new P([0,0,0,0,0,0,0,0,1,1,1,1,2,2,2,2,3,3,3,3,4,4,4,4,5,5,5,5,0,0,0,0]),zt=new P([0,0,0,0,1,1,2,2,3,3,4,4,5,5,6,
6,7,7,8,8,9,9,10,10,11,11,12,12,13,13,0,0]),Zr=new P([16,17,18,0,8,7,9,6,10,5,11,4,12,3,13,2,14,1,15]),Ss=function(r,e){for(var t=new J(31),n=0;n<31;++n)t[n]=e+=
1<<r[n-1];for(var s=new rn(t[30]),n=1;n<30;++n)for(var o=t[n];o<t[n+1];++o)s[o]=o-t[n]<<5|n;return{b:t,r:s}},As=Ss(Wt,2),Ms=As.b,Xr=As.r;Ms[28]=258,Xr[258]=28;var Es=Ss(
zt,0),fi=Es.b,gs=Es.r,Qr=new J(32768);for(E=0;E<32768;++E)me=(E&43690)>>1|(E&21845)<<1,me=(me&52428)>>2|(me&13107)<<2,me=(me&61680)>>4|(me&3855)<<4,Qr[E]=((me&65280)>>
8|(me&255)<<8)>>1;var me,E,ae=(function(r,e,t){for(var n=r.length,s=0,o=new J(e);s<n;++s)r[s]&&++o[r[s]-1];var a=new J(e);for(s=1;s<e;++s)a[s]=a[s-1]+o[s-1]<<1;
var i;if(t){i=new J(1<<e);var l=15-e;for(s=0;s<n;++s)if(r[s])for(var u=s<<4|r[s],c=e-r[s],h=a[r[s]-1]++<<c,d=h|(1<<c)-1;h<=d;++h)i[Qr[h]>>l]=u}else for(i=new J(
n),s=0;s<n;++s)r[s]&&(i[s]=Qr[a[r[s]-1]++]>>15-r[s]);return i}),Se=new P(288);for(E=0;E<144;++E)Se[E]=8;var E;for(E=144;E<256;++E)Se[E]=9;var E;for(E=256;E<280;++E)
Se[E]=7;var E;for(E=280;E<288;++E)Se[E]=8;var E,ht=new P(32);for(E=0;E<32;++E)ht[E]=5;var E,yi=ae(Se,9,0),gi=ae(Se,9,1),bi=ae(ht,5,0),vi=ae(ht,5,1),qr=function(r){
for(var e=r[0],t=1;t<r.length;++t)r[t]>e&&(e=r[t]);return e},re=function(r,e,t){var n=e/8|0;return(r[n]|r[n+1]<<8)>>(e&7)&t},Kr=function(r,e){var t=e/8|0;return(r[t]|
r[t+1]<<8|r[t+2]<<16)>>(e&7)},nn=function(r){return(r+7)/8|0},sn=function(r,e,t){return(e==null||e<0)&&(e=0),(t==null||t>r.length)&&(t=r.length),new P(r.subarray(
e,t))};var wi=["unexpected EOF","invalid block type","invalid length/literal","invalid distance","stream finished","no stream handler",,"no callback","invalid UTF-8 da\
ta","extra field too long","date not in range 1980-2099","filename too long","stream finishing","invalid zip data"],G=function(r,e,t){var n=new Error(e||wi[r]);
if(n.code=r,Error.captureStackTrace&&Error.captureStackTrace(n,G),!t)throw n;return n},xi=function(r,e,t,n){var s=r.length,o=n?n.length:0;if(!s||e.f&&!e.l)return t||
new P(0);var a=!t,i=a||e.i!=2,l=e.i;a&&(t=new P(s*3));var u=function(rt){var nt=t.length;if(rt>nt){var Fe=new P(Math.max(nt*2,rt));Fe.set(t),t=Fe}},c=e.f||0,h=e.
p||0,d=e.b||0,p=e.l,g=e.d,f=e.m,y=e.n,b=s*8;do{if(!p){c=re(r,h,1);var x=re(r,h+1,3);if(h+=3,x)if(x==1)p=gi,g=vi,f=9,y=5;else if(x==2){var $=re(r,h,31)+257,L=re(
r,h+10,15)+4,A=$+re(r,h+5,31)+1;h+=14;for(var S=new P(A),F=new P(19),N=0;N<L;++N)F[Zr[N]]=re(r,h+N*3,7);h+=L*3;for(var z=qr(F),be=(1<<z)-1,Y=ae(F,z,1),N=0;N<A;){
var B=Y[re(r,h,be)];h+=B&15;var w=B>>4;if(w<16)S[N++]=w;else{var U=0,O=0;for(w==16?(O=3+re(r,h,3),h+=2,U=S[N-1]):w==17?(O=3+re(r,h,7),h+=3):w==18&&(O=11+re(r,h,
127),h+=7);O--;)S[N++]=U}}var j=S.subarray(0,$),D=S.subarray($);f=qr(j),y=qr(D),p=ae(j,f,1),g=ae(D,y,1)}else G(1);else{var w=nn(h)+4,M=r[w-4]|r[w-3]<<8,_=w+M;if(_>
s){l&&G(0);break}i&&u(d+M),t.set(r.subarray(w,_),d),e.b=d+=M,e.p=h=_*8,e.f=c;continue}if(h>b){l&&G(0);break}}i&&u(d+131072);for(var tt=(1<<f)-1,X=(1<<y)-1,he=h;;he=
h){var U=p[Kr(r,h)&tt],q=U>>4;if(h+=U&15,h>b){l&&G(0);break}if(U||G(2),q<256)t[d++]=q;else if(q==256){he=h,p=null;break}else{var K=q-254;if(q>264){var N=q-257,R=Wt[N];
K=re(r,h,(1<<R)-1)+Ms[N],h+=R}var oe=g[Kr(r,h)&X],Ne=oe>>4;oe||G(3),h+=oe&15;var D=fi[Ne];if(Ne>3){var R=zt[Ne];D+=Kr(r,h)&(1<<R)-1,h+=R}if(h>b){l&&G(0);break}i&&
u(d+131072);var Ie=d+K;if(d<D){var Rt=o-D,Pt=Math.min(D,Ie);for(Rt+d<0&&G(3);d<Pt;++d)t[d]=n[Rt+d]}for(;d<Ie;++d)t[d]=t[d-D]}}e.l=p,e.p=he,e.b=d,e.f=c,p&&(c=1,e.
m=f,e.d=g,e.n=y)}while(!c);return d!=t.length&&a?sn(t,0,d):t.subarray(0,d)},pe=function(r,e,t){t<<=e&7;var n=e/8|0;r[n]|=t,r[n+1]|=t>>8},ut=function(r,e,t){t<<=
e&7;var n=e/8|0;r[n]|=t,r[n+1]|=t>>8,r[n+2]|=t>>16},Jr=function(r,e){for(var t=[],n=0;n<r.length;++n)r[n]&&t.push({s:n,f:r[n]});var s=t.length,o=t.slice();if(!s)
return{t:Cs,l:0};if(s==1){var a=new P(t[0].s+1);return a[t[0].s]=1,{t:a,l:1}}t.sort(function(_,$){return _.f-$.f}),t.push({s:-1,f:25001});var i=t[0],l=t[1],u=0,
c=1,h=2;for(t[0]={s:-1,f:i.f+l.f,l:i,r:l};c!=s-1;)i=t[t[u].f<t[h].f?u++:h++],l=t[u!=c&&t[u].f<t[h].f?u++:h++],t[c++]={s:-1,f:i.f+l.f,l:i,r:l};for(var d=o[0].s,n=1;n<
s;++n)o[n].s>d&&(d=o[n].s);var p=new J(d+1),g=en(t[c-1],p,0);if(g>e){var n=0,f=0,y=g-e,b=1<<y;for(o.sort(function($,L){return p[L.s]-p[$.s]||$.f-L.f});n<s;++n){
var x=o[n].s;if(p[x]>e)f+=b-(1<<g-p[x]),p[x]=e;else break}for(f>>=y;f>0;){var w=o[n].s;p[w]<e?f-=1<<e-p[w]++-1:++n}for(;n>=0&&f;--n){var M=o[n].s;p[M]==e&&(--p[M],
++f)}g=e}return{t:new P(p),l:g}},en=function(r,e,t){return r.s==-1?Math.max(en(r.l,e,t+1),en(r.r,e,t+1)):e[r.s]=t},bs=function(r){for(var e=r.length;e&&!r[--e];)
;for(var t=new J(++e),n=0,s=r[0],o=1,a=function(l){t[n++]=l},i=1;i<=e;++i)if(r[i]==s&&i!=e)++o;else{if(!s&&o>2){for(;o>138;o-=138)a(32754);o>2&&(a(o>10?o-11<<5|
28690:o-3<<5|12305),o=0)}else if(o>3){for(a(s),--o;o>6;o-=6)a(8304);o>2&&(a(o-3<<5|8208),o=0)}for(;o--;)a(s);o=1,s=r[i]}return{c:t.subarray(0,n),n:e}},ct=function(r,e){
for(var t=0,n=0;n<e.length;++n)t+=r[n]*e[n];return t},Ts=function(r,e,t){var n=t.length,s=nn(e+2);r[s]=n&255,r[s+1]=n>>8,r[s+2]=r[s]^255,r[s+3]=r[s+1]^255;for(var o=0;o<
n;++o)r[s+o+4]=t[o];return(s+4+n)*8},vs=function(r,e,t,n,s,o,a,i,l,u,c){pe(e,c++,t),++s[256];for(var h=Jr(s,15),d=h.t,p=h.l,g=Jr(o,15),f=g.t,y=g.l,b=bs(d),x=b.c,
w=b.n,M=bs(f),_=M.c,$=M.n,L=new J(19),A=0;A<x.length;++A)++L[x[A]&31];for(var A=0;A<_.length;++A)++L[_[A]&31];for(var S=Jr(L,7),F=S.t,N=S.l,z=19;z>4&&!F[Zr[z-1]];--z)
;var be=u+5<<3,Y=ct(s,Se)+ct(o,ht)+a,B=ct(s,d)+ct(o,f)+a+14+3*z+ct(L,F)+2*L[16]+3*L[17]+7*L[18];if(l>=0&&be<=Y&&be<=B)return Ts(e,c,r.subarray(l,l+u));var U,O,j,
D;if(pe(e,c,1+(B<Y)),c+=2,B<Y){U=ae(d,p,0),O=d,j=ae(f,y,0),D=f;var tt=ae(F,N,0);pe(e,c,w-257),pe(e,c+5,$-1),pe(e,c+10,z-4),c+=14;for(var A=0;A<z;++A)pe(e,c+3*A,
F[Zr[A]]);c+=3*z;for(var X=[x,_],he=0;he<2;++he)for(var q=X[he],A=0;A<q.length;++A){var K=q[A]&31;pe(e,c,tt[K]),c+=F[K],K>15&&(pe(e,c,q[A]>>5&127),c+=q[A]>>12)}}else
U=yi,O=Se,j=bi,D=ht;for(var A=0;A<i;++A){var R=n[A];if(R>255){var K=R>>18&31;ut(e,c,U[K+257]),c+=O[K+257],K>7&&(pe(e,c,R>>23&31),c+=Wt[K]);var oe=R&31;ut(e,c,j[oe]),
c+=D[oe],oe>3&&(ut(e,c,R>>5&8191),c+=zt[oe])}else ut(e,c,U[R]),c+=O[R]}return ut(e,c,U[256]),c+O[256]},Si=new rn([65540,131080,131088,131104,262176,1048704,1048832,
2114560,2117632]),Cs=new P(0),Ai=function(r,e,t,n,s,o){var a=o.z||r.length,i=new P(n+a+5*(1+Math.ceil(a/7e3))+s),l=i.subarray(n,i.length-s),u=o.l,c=(o.r||0)&7;if(e){
c&&(l[0]=o.r>>3);for(var h=Si[e-1],d=h>>13,p=h&8191,g=(1<<t)-1,f=o.p||new J(32768),y=o.h||new J(g+1),b=Math.ceil(t/3),x=2*b,w=function($r){return(r[$r]^r[$r+1]<<
b^r[$r+2]<<x)&g},M=new rn(25e3),_=new J(288),$=new J(32),L=0,A=0,S=o.i||0,F=0,N=o.w||0,z=0;S+2<a;++S){var be=w(S),Y=S&32767,B=y[be];if(f[Y]=B,y[be]=Y,N<=S){var U=a-
S;if((L>7e3||F>24576)&&(U>423||!u)){c=vs(r,l,0,M,_,$,A,F,z,S-z,c),F=L=A=0,z=S;for(var O=0;O<286;++O)_[O]=0;for(var O=0;O<30;++O)$[O]=0}var j=2,D=0,tt=p,X=Y-B&32767;
if(U>2&&be==w(S-X))for(var he=Math.min(d,U)-1,q=Math.min(32767,S),K=Math.min(258,U);X<=q&&--tt&&Y!=B;){if(r[S+j]==r[S+j-X]){for(var R=0;R<K&&r[S+R]==r[S+R-X];++R)
;if(R>j){if(j=R,D=X,R>he)break;for(var oe=Math.min(X,R-2),Ne=0,O=0;O<oe;++O){var Ie=S-X+O&32767,Rt=f[Ie],Pt=Ie-Rt&32767;Pt>Ne&&(Ne=Pt,B=Ie)}}}Y=B,B=f[Y],X+=Y-B&
32767}if(D){M[F++]=268435456|Xr[j]<<18|gs[D];var rt=Xr[j]&31,nt=gs[D]&31;A+=Wt[rt]+zt[nt],++_[257+rt],++$[nt],N=S+j,++L}else M[F++]=r[S],++_[r[S]]}}for(S=Math.max(
S,N);S<a;++S)M[F++]=r[S],++_[r[S]];c=vs(r,l,u,M,_,$,A,F,z,S-z,c),u||(o.r=c&7|l[c/8|0]<<3,c-=7,o.h=y,o.p=f,o.i=S,o.w=N)}else{for(var S=o.w||0;S<a+u;S+=65535){var Fe=S+
65535;Fe>=a&&(l[c/8|0]=u,Fe=a),c=Ts(l,c+1,r.subarray(S,Fe))}o.i=a}return sn(i,0,n+nn(c)+s)},Mi=(function(){for(var r=new Int32Array(256),e=0;e<256;++e){for(var t=e,
n=9;--n;)t=(t&1&&-306674912)^t>>>1;r[e]=t}return r})(),Ei=function(){var r=-1;return{p:function(e){for(var t=r,n=0;n<e.length;++n)t=Mi[t&255^e[n]]^t>>>8;r=t},d:function(){
return~r}}};var Ti=function(r,e,t,n,s){if(!s&&(s={l:1},e.dictionary)){var o=e.dictionary.subarray(-32768),a=new P(o.length+r.length);a.set(o),a.set(r,o.length),r=a,s.w=o.length}
return Ai(r,e.level==null?6:e.level,e.mem==null?s.l?Math.ceil(Math.max(8,Math.min(13,Math.log(r.length)))*1.5):20:12+e.mem,t,n,s)},ks=function(r,e){var t={};for(var n in r)
t[n]=r[n];for(var n in e)t[n]=e[n];return t};var W=function(r,e,t){for(;t;++e)r[e]=t,t>>>=8};var Ci=function(r,e){return((r[0]&15)!=8||r[0]>>4>7||(r[0]<<8|r[1])%31)&&G(6,"invalid zlib data"),(r[1]>>5&1)==+!e&&G(6,"invalid zlib data: "+(r[1]&32?"need":"u\
nexpected")+" dictionary"),(r[1]>>3&4)+2};function ki(r,e){return Ti(r,e||{},0,0)}function _s(r,e){return xi(r.subarray(Ci(r,e&&e.dictionary),-4),{i:2},e&&e.out,e&&e.dictionary)}var Os=function(r,e,t,n){for(var s in r){var o=r[s],a=e+s,i=n;Array.isArray(o)&&(i=ks(n,o[1]),o=o[0]),o instanceof P?t[a]=[o,i]:(t[a+="/"]=[new P(0),i],Os(o,a,t,
n))}},ws=typeof TextEncoder<"u"&&new TextEncoder,_i=typeof TextDecoder<"u"&&new TextDecoder,Oi=0;try{_i.decode(Cs,{stream:!0}),Oi=1}catch{}function fe(r,e){if(e){for(var t=new P(r.length),n=0;n<r.length;++n)t[n]=r.charCodeAt(n);return t}if(ws)return ws.encode(r);for(var s=r.length,o=new P(r.length+
(r.length>>1)),a=0,i=function(c){o[a++]=c},n=0;n<s;++n){if(a+5>o.length){var l=new P(a+8+(s-n<<1));l.set(o),o=l}var u=r.charCodeAt(n);u<128||e?i(u):u<2048?(i(192|
u>>6),i(128|u&63)):u>55295&&u<57344?(u=65536+(u&1047552)|r.charCodeAt(++n)&1023,i(240|u>>18),i(128|u>>12&63),i(128|u>>6&63),i(128|u&63)):(i(224|u>>12),i(128|u>>
6&63),i(128|u&63))}return sn(o,0,a)}var tn=function(r){var e=0;if(r)for(var t in r){var n=r[t].length;n>65535&&G(9),e+=n+4}return e},xs=function(r,e,t,n,s,o,a,i){var l=n.length,u=t.extra,c=i&&i.length,
h=tn(u);W(r,e,a!=null?33639248:67324752),e+=4,a!=null&&(r[e++]=20,r[e++]=t.os),r[e]=20,e+=2,r[e++]=t.flag<<1|(o<0&&8),r[e++]=s&&8,r[e++]=t.compression&255,r[e++]=
t.compression>>8;var d=new Date(t.mtime==null?Date.now():t.mtime),p=d.getFullYear()-1980;if((p<0||p>119)&&G(10),W(r,e,p<<25|d.getMonth()+1<<21|d.getDate()<<16|d.
getHours()<<11|d.getMinutes()<<5|d.getSeconds()>>1),e+=4,o!=-1&&(W(r,e,t.crc),W(r,e+4,o<0?-o-2:o),W(r,e+8,t.size)),W(r,e+12,l),W(r,e+14,h),e+=16,a!=null&&(W(r,e,
c),W(r,e+6,t.attrs),W(r,e+10,a),e+=14),r.set(n,e),e+=l,h)for(var g in u){var f=u[g],y=f.length;W(r,e,+g),W(r,e+2,y),r.set(f,e+4),e+=4+y}return c&&(r.set(i,e),e+=
c),e},Ri=function(r,e,t,n,s){W(r,e,101010256),W(r,e+8,t),W(r,e+10,t),W(r,e+12,n),W(r,e+16,s)};function Bt(r,e){e||(e={});var t={},n=[];Os(r,"",t,e);var s=0,o=0;for(var a in t){var i=t[a],l=i[0],u=i[1],c=u.level==0?0:8,h=fe(a),d=h.length,p=u.comment,g=p&&
fe(p),f=g&&g.length,y=tn(u.extra);d>65535&&G(11);var b=c?ki(l,u):l,x=b.length,w=Ei();w.p(l),n.push(ks(u,{size:l.length,crc:w.d(),c:b,f:h,m:g,u:d!=a.length||g&&p.
length!=f,o:s,compression:c})),s+=30+d+y+x,o+=76+2*(d+y)+(f||0)+x}for(var M=new P(o+22),_=s,$=o-s,L=0;L<n.length;++L){var h=n[L];xs(M,h.o,h,h.f,h.u,h.c.length);
var A=30+h.f.length+tn(h.extra);M.set(h.c,h.o+A),xs(M,s,h,h.f,h.u,h.c.length,h.o,h.m),s+=16+A+(h.m?h.m.length:0)}return Ri(M,s,n.length,$,_),M}var ne=(r,e)=>`${r}s of generation ${e}`,ie=["stay","north","east","south","west","northeast","southeast","southwest","northwest"];var He=["pursuer","evader"];function Ge(r,e,t){let[n,s]=[e-r.payoff.first[0],t-r.payoff.first[1]],o=r.payoff.capture_rate[n]?.[s];return o===void 0?null:{rate:o,rates:r.payoff.capture_rates[n][s],
lengths:r.payoff.lengths[n][s]}}var jt=({world:r,maps:e},t)=>e&&t!==null?{...r,obstacles:e.walls[t]}:r;function Ht(r,e,t){let{script:n,network:s,kept:o,genomes:a}=r.
teams[e];if(n!==null||s===null)return"";if(!o.includes(t))return`The page holds no genome of ${ne(e,t)}: it would be too large. Choose a generation of ${o.join(
", ")}.`;let i=o.length*s.genome_size;return Ps(a,s.genome_size).length===i?"":`The page is damaged: it does not hold the ${i} numbers of the ${e}s' genomes. Wr\
ite it again from its run.`}function Z(r,e,t){let{script:n,network:s,kept:o,genomes:a}=r.teams[e];if(n!==null||s===null)return n??"random";let i=o.indexOf(t);if(i<
0)throw new RangeError(`${e}: expected a generation whose genome the page holds, got ${t}`);let l=s.genome_size,u=Ps(a,l).subarray(i*l,(i+1)*l),{hidden:c,activation:h,
sampled:d,memory:p}=s;return{hidden:c,activation:h,sampled:d,memory:p,genome:u}}var on=4,an=new Map,Rs=(r,e)=>{an.set(r,e)};function Ps(r,e){let t=an.get(r);if(t)
return t;let n=new Float32Array;try{let s=Li(ln(r),e);s.every(Number.isFinite)&&(n=s)}catch(s){if(!(s instanceof DOMException||s instanceof RangeError||Pi(s)))throw s}
return an.set(r,n),n}var Pi=r=>r instanceof Error&&"code"in r;function Li(r,e){let t=_s(r),n=t.length/on,s=new Uint8Array(t.length);for(let a=0;a<s.length;a++)s[a]=
t[a%on*n+Math.floor(a/on)];let o=new Uint32Array(s.buffer);for(let a=e;a<o.length;a++)o[a]^=o[a-e];return new Float32Array(s.buffer)}function ln(r){let e=atob(Ae(
r)),t=new Uint8Array(e.length);for(let n=0;n<t.length;n++)t[n]=e.charCodeAt(n);return t}function Ae(r){return document.getElementById(r)?.textContent??""}var Ls=()=>JSON.parse(Ae("data")),dt={"specialist-specialist":"Specialists: both teams meet only the newest opponent","generalist-specialist":"Pursuers meet all\
 earlier evaders, evaders only the newest pursuers","generalist-generalist":"Generalists: both teams meet all earlier opponents","hall-of-fame":"Halls of fame: \
both teams learn at once, and meet earlier champions"};function ke({schedule:r}){if(r.kind==="hall-of-fame")return r.kind;let e={latest:"specialist","round-robi\
n":"generalist",uniform:"uniform"};return`${e[r.pursuers_meet.rule]}-${e[r.evaders_meet.rule]}`}var Gt=r=>dt[ke(r)]??ke(r);var Vt=10,Yt=999999,un=[3,5,7,9,11],qt=5,cn=[8,16,32,64],hn=[6,10,30,60,90,120];function $i(r){let e=Object.values(r.races.es).find(t=>ke(t)==="generalist-gener\
alist");return{schedule:ke(e),beside:null,learner:"es",seed:e.seed,way:!1,population:0,...mt(r,!1)}}var pt=(r,e)=>e?r.small:Object.values(r.races.es)[0].world;function mt(r,e){
let{n_pursuers:t,n_evaders:n,fov:s,max_steps:o}=pt(r,e);return{small:e,pursuers:t,evaders:n,view:s,steps:o,walls:[]}}function Kt(r,e,t=e.schedule){let n=r.races[e.
learner][t],s=pt(r,e.small),{rows:o,cols:a}=s,i=new Set(e.walls),l=Array.from({length:o},(c,h)=>Array.from({length:a},(d,p)=>i.has(h*a+p)?"#":".").join("")),u={
...s,n_pursuers:e.pursuers,n_evaders:e.evaders,fov:e.view,max_steps:e.steps,obstacles:i.size?l:s.obstacles};return{...n,world:u,train_steps:e.steps,seed:e.seed,
policy:{...n.policy,mask:e.way?"right-of-way":"none"},learner:{...n.learner,population:e.population||n.learner.population}}}function dn(r,e,t){let n=r.filter(s=>s!==
e);return t?[...n,e].sort((s,o)=>s-o):n}function Jt({walls:r,pursuers:e,evaders:t},{rows:n,cols:s}){let o=new Set(Array.from({length:n*s},(i,l)=>l).filter(i=>!r.
includes(i)));if(o.size<e+t)return`There is no room: ${e+t} agents need a free cell each.`;let a=[Math.min(...o)];o.delete(a[0]);for(let i of a){let l=i%s,u=[i-
s,i+s,...l>0?[i-1]:[],...l<s-1?[i+1]:[]];a.push(...u.filter(c=>o.delete(c)))}return o.size?"Nobody may be walled in: all free cells have to be connected, side b\
y side.":""}function $s(r){let{walls:e,way:t,beside:n,small:s,...o}=r,a={...o,...s?{small:1}:{},...n?{beside:n}:{},...t?{way:1}:{},...e.length?{walls:e.join(".")}:
{}};return Object.entries(a).map(([i,l])=>`${i}=${l}`).join("&")}function Ns(r,e){let t=new URLSearchParams(e.replace(/^#/,"")),n=t.get("small")==="1",s={...$i(
r),...mt(r,n)},o=(d,p)=>{let g=t.get(d)??"";return/^\d{1,6}$/.test(g)&&p(Number(g))?Number(g):s[d]},a=d=>Object.hasOwn(dt,t.get(d)??"")?t.get(d):null,i=pt(r,n),
l=(t.get("walls")??"").split(".").filter(d=>/^\d{1,4}$/.test(d)).map(Number),u=o("view",d=>un.includes(d)),c=t.get("way")==="1",h={schedule:a("schedule")??s.schedule,
beside:a("beside"),small:n,learner:t.get("learner")==="ga"?"ga":s.learner,seed:o("seed",d=>d<=Yt),pursuers:o("pursuers",d=>d>=1&&d<=Vt),evaders:o("evaders",d=>d>=
1&&d<=Vt),view:c?Math.max(qt,u):u,way:c,population:o("population",d=>cn.includes(d)),steps:o("steps",d=>hn.includes(d)),walls:l.filter(d=>d<i.rows*i.cols).reduce(
(d,p)=>dn(d,p,!0),[])};return Jt(h,i)?{...h,...mt(r,n)}:h}function ye(r,e){let t=m("select",{},...r.map(([n,s])=>m("option",{value:n},s)));return t.addEventListener("change",()=>e(t.value)),t}function se(r,e,t,n=""){return m(
"label",{class:`field ${n}`,title:e},m("span",{class:"field-name"},r),t,m("span",{class:"about small muted"},e))}function Is(r){let e=Object.entries(dt),t=ye(e,
y=>r({schedule:y})),n=ye([["","Nothing"],...e],y=>r({beside:y||null},!0)),s=Array.from({length:Vt},(y,b)=>[b+1,String(b+1)]),o=ye(s,y=>r({pursuers:Number(y)})),
a=ye(s,y=>r({evaders:Number(y)})),i=ye(un.map(y=>[y,`${y} x ${y}`]),y=>r({view:Number(y),...Number(y)<qt?{way:!1}:{}})),l=m("input",{type:"checkbox"});l.addEventListener(
"change",()=>r({way:l.checked,...l.checked?{view:Math.max(qt,Number(i.value))}:{}}));let u=ye([[0,"usual"],...cn.map(y=>[y,String(y)])],y=>r({population:Number(
y)})),c=ye(hn.map(y=>[y,String(y)]),y=>r({steps:Number(y)})),h=ye([["","12 x 12 cells"],["small","6 x 6, solved"]],y=>r({small:y==="small"},!0)),d=ye([["es","ev\
olution strategy"],["ga","genetic algorithm"]],y=>r({learner:y},!0)),p=m("input",{type:"number",min:0,max:Yt,step:1,inputmode:"numeric"});p.addEventListener("ch\
ange",()=>r({seed:Math.min(Yt,Math.max(0,Math.round(Number(p.value))||0))},!0));let g=m("button",{type:"button",onclick:()=>r({seed:Math.floor(Math.random()*1e3)},
!0)},"Another seed"),f=(y,...b)=>m("section",{class:"card controls","aria-label":y},m("fieldset",{},m("legend",{},y),...b));return{now:f("Change it while it evo\
lves",se("Opponents","whom the teams meet while they learn",t,"wide"),se("Pursuers","triangles",o),se("Evaders","discs",a),se("View","cells that an agent sees a\
round itself",i),se("Right of way","agents never take a move that could put them at fault",m("span",{},l)),se("Population","candidates that are compared at a ti\
me",u),se("Steps","of a match",c)),anew:f("Begin anew",se("Side by side with","a second race of the same seed",n,"wide"),se("World","where it is solved, the pag\
e tells exact regret",h,"half"),se("Learner","how a team learns",d,"half"),se("Seed","the luck of the race",m("span",{class:"seed"},p,g),"half")),show:y=>{[t.value,
n.value,i.value,d.value]=[y.schedule,y.beside??"",String(y.view),y.learner],[u.value,c.value,p.value,l.checked]=[String(y.population),String(y.steps),String(y.seed),
y.way],h.value=y.small?"small":"",[o.value,a.value]=[String(y.pursuers),String(y.evaders)]}}}var V=(r,e=2)=>r==null?"-":r.toFixed(e);function Fs(r,e,t){return e===null||t===null?V(r):`${V(r)} (${V(e)} to ${V(t)})`}var Zt=r=>r.charAt(0).toUpperCase()+r.slice(1);function ft(r,e,t,n=!1){let s=(e-r)/Math.max(1,t),o=10**Math.floor(Math.log10(s||1)),a=[1,2,5,10].map(u=>u*o).find(
u=>u>=s)??10*o;n&&(a=Math.max(1,Math.round(a)));let i=Math.ceil(r/a-1e-9),l=Math.floor(e/a+1e-9);return Array.from({length:Math.max(0,l-i+1)},(u,c)=>(i+c)*a)}var Xt={left:46,right:12,top:10,bottom:42},Us={x:56,y:34};function Ws(r,e,t,n){let[s,o]=[Xt.left,Xt.top],a=Math.max(s+40,r-Xt.right),i=Math.max(o+40,e-Xt.bottom),
l=(f,y,b)=>x=>y+(x-f.low)/(f.high-f.low||1)*(b-y),[u,c]=[l(t,s,a),l(n,i,o)],h=v("g"),d=v("svg",{width:r,height:e,viewBox:`0 0 ${r} ${e}`,class:"plot"}),p=v("g",
{class:"axes"});for(let f of ft(n.low,n.high,(i-o)/Us.y,n.whole))p.append(v("line",{x1:s,x2:a,y1:c(f),y2:c(f),class:"grid"}),v("text",{x:s-8,y:c(f),"text-anchor":"\
end","dominant-baseline":"middle"},Ds(f)));for(let f of ft(t.low,t.high,(a-s)/Us.x,t.whole))p.append(v("text",{x:u(f),y:i+16,"text-anchor":"middle"},Ds(t.mirrored?
Math.abs(f):f)));return p.append(v("line",{x1:s,x2:a,y1:i,y2:i,class:"axis"}),v("text",{x:(s+a)/2,y:e-6,"text-anchor":"middle",class:"label"},t.label),v("text",
{transform:`translate(12 ${(o+i)/2}) rotate(-90)`,"text-anchor":"middle",class:"label"},n.label)),d.append(p,h),{root:d,marks:h,left:s,right:a,top:o,bottom:i,x:u,
y:c,at:f=>{let y=f-d.getBoundingClientRect().left;return t.low+(y-s)/(a-s)*(t.high-t.low)}}}var Ds=r=>String(Number(r.toPrecision(6))).replace("-","−");function zs(r,e,t,n){
let s="",o="M";t.forEach((a,i)=>{a===null?o="M":(s+=`${o}${r.x(e[i]).toFixed(1)} ${r.y(a).toFixed(1)}`,o="L")}),r.root.insertBefore(v("path",{d:s,class:`line ${n}`}),
r.marks)}function Bs(...r){return m("p",{class:"legend small"},...r.map(([e,t])=>m("span",{class:`key ${t}`},e)))}function js(r,e,t,n){let s=m("div",{class:"chart choose\
s",role:"img","aria-label":r}),o=null,a=()=>{o?.marks.replaceChildren(),o&&t(o)};s.addEventListener("click",l=>o&&n(o.at(l.clientX),o,l));let i=()=>{let{clientWidth:l,
clientHeight:u}=s;l<50||u<50||(o=e(l,u),s.replaceChildren(o.root),a())};return new ResizeObserver(i).observe(s),{element:s,update:a,redraw:i}}var Ve=[[0,0],[-1,0],[0,1],[1,0],[0,-1],[-1,1],[1,1],[1,-1],[-1,-1]];function Hs(r,e,t){let[n,s]=[e[0]-r[0],e[1]-r[1]];return!t&&Math.abs(n)>Math.abs(s)?s=0:t||
(n=0),Ve.findIndex(([o,a])=>o===Math.sign(n)&&a===Math.sign(s))}var _e=(r,e)=>e<r.nPursuers,k=(r,e)=>[r.positions[2*e],r.positions[2*e+1]],Ni=(r,e)=>r[0]===e[0]&&
r[1]===e[1],mn=({rows:r,cols:e},[t,n])=>t>=0&&n>=0&&t<r&&n<e,pn=(r,e,t=3)=>r!==void 0&&[0,1,2].slice(0,t).some(n=>r[3*e+n]),fn=(r,e)=>pn(r.fault,e),Gs=(r,e)=>!fn(
r,e)&&pn(r.involved,e,2);function Qt(r,e,t){let n=!Ni(k(r,t),k(e,t)),s=e.involved===void 0||pn(e.involved,t);return!!(e.alive[t]&&e.actions?.[t]&&!n&&s)}function er(r,e,t){
let[n,s]=k(r,t),[o,a]=Ve[e.actions?.[t]??0];return[n+o,s+a]}function yt(r,e,t){return Array.from({length:t.everCaptured.length},(s,o)=>o).filter(s=>t.everCaptured[s]&&
!e.everCaptured[s]).map(s=>r.nPursuers+s)}var tr=r=>r.moments.flatMap((e,t)=>t&&yt(r,r.moments[t-1],e).length?[t]:[]);function rr(r,e){return Array.from({length:e.
alive.length},(n,s)=>s).filter(n=>r.alive[n]&&!e.alive[n])}var Vs=[-.31,0,.31],Ys=[{size:1,at:[[0,0]]},{size:.62,at:[[-.2,.2],[.2,-.2]]},{size:.54,at:[[-.23,.22],[.23,.22],[0,-.22]]},{size:.54,at:[[-.23,.23],[.23,.23],[
-.23,-.23],[.23,-.23]]},{size:.36,at:Vs.flatMap(r=>Vs.map(e=>[e,r]))}],Ii=.3,Fi=.35,Ui=.55;function gt(r,e){let t=new Map;for(let n=0;n<e.alive.length;n++){if(!e.
alive[n])continue;let[s,o]=k(e,n),a=s*r.cols+o,i=t.get(a);i?i.push(n):t.set(a,[n])}return t}function qs(r,e){let t=Array.from(e.alive,(n,s)=>{let[o,a]=k(e,s);return{
x:a+.5,y:o+.5,size:1,alpha:0}});for(let n of gt(r,e).values()){let s=Ys[Math.min(n.length,Ys.length)-1];n.forEach((o,a)=>{let[i,l]=s.at[Math.min(a,s.at.length-1)],
u=t[o];u.x+=i,u.y+=l,u.size=s.size,u.alpha=1})}return t}var Ks=r=>r*r*(3-2*r),Ye=(r,e,t)=>r+(e-r)*t,Js=r=>Math.min(1,Math.max(0,r));function Zs(r,e,t,n){let s={
SIMULTANEOUS:1,SWARM_TURNS:2,AGENT_TURNS:t}[r.interaction];if(s===1)return Ks(n);let o=s===t?e:+!_e(r,e),a=Math.max(1/s,Fi);return Ks(Js((n-o/(s-1)*(1-a))/a))}function nr(r,e){
let t=r.moments.length-1,n=Math.min(Math.floor(e),t),s=r.moments[n],o=qs(r,s);if(n===t||e===n)return o;let a=r.moments[n+1],i=qs(r,a);return o.map((l,u)=>{let c=Zs(
r,u,o.length,e-n);return Di(s,a,u,l,i[u],c)})}function yn(r,e,t){let n=r.moments.length-1,s=Math.min(Math.floor(t),n),[o,a]=[r.moments[s],r.moments[Math.min(s+1,
n)]],i=Zs(r,e,o.alive.length,t-s),[[l,u],[c,h]]=[k(o,e),k(a,e)];return[Ye(u,h,i)+.5,Ye(l,c,i)+.5]}function Di(r,e,t,n,s,o){let a=n.alpha>s.alpha,i={x:Ye(n.x,s.x,
o),y:Ye(n.y,s.y,o),size:a?n.size:Ye(n.size,s.size,o),alpha:a?Js((1-o)/(1-Ui)):Ye(n.alpha,s.alpha,o)};if(Qt(r,e,t)){let[l,u]=k(r,t),[c,h]=er(r,e,t),d=Ii*Math.sin(
Math.PI*o);i.x+=(h-u)*d,i.y+=(c-l)*d}return i}var Xs=2*Math.PI;function Oe(r,e,t,n){r.beginPath(),r.arc(e,t,n/2,0,Xs)}function sr(r,e,t,n){let s=n/2,o=[[0,-.97],[.97,.83],[-.97,.83]].map(([a,i])=>[e+a*s,t+i*
s]);r.beginPath(),r.moveTo((o[2][0]+o[0][0])/2,(o[2][1]+o[0][1])/2),o.forEach(([a,i],l)=>{let[u,c]=o[(l+1)%3];r.arcTo(a,i,u,c,n*.09)}),r.closePath()}function Qs(r,e,t,n){
let s=n*.32;r.beginPath(),r.moveTo(e-s,t-s),r.lineTo(e+s,t+s),r.moveTo(e+s,t-s),r.lineTo(e-s,t+s)}function eo(r,e,t,n){r.beginPath();for(let s=0;s<16;s++){let o=n/
2*(s%2?.6:.95),a=Xs*s/16;r.lineTo(e+o*Math.sin(a),t-o*Math.cos(a))}r.closePath()}function to(r,e,t,n,s,o){let a=Math.atan2(s-t,n-e);r.beginPath(),r.moveTo(e,t),
r.lineTo(n,s);for(let i of[-1,1])r.moveTo(n,s),r.lineTo(n-o*Math.cos(a+i*.6),s-o*Math.sin(a+i*.6))}var ro=4,Wi=1.6,zi=.95,Bi=5,ji=.16,Hi=9,Gi=.09,Vi=.2,no=.75,Q=(r,e)=>r.left+e*r.cell,ee=(r,e)=>r.top+e*r.cell;function qe(r,e,t){return _e(e,t)?r.colors.pursuer:
r.colors.evader}function so({ctx:r,grid:e,colors:t}){let{left:n,top:s,cell:o,rows:a,cols:i}=e,[l,u]=[i*o,a*o];if(r.fillStyle=t.paper,r.fillRect(n,s,l,u),o<Bi)return;
r.fillStyle=t.line;let c=Math.max(1,Math.round(o/60));for(let h=1;h<i;h++)r.fillRect(n+h*o,s,c,u);for(let h=1;h<a;h++)r.fillRect(n,s+h*o,l,c)}function oo({ctx:r,
grid:e,colors:t},n){let{left:s,top:o,cell:a,rows:i,cols:l}=e;r.fillStyle=t.obstacle;for(let u=0;u<i*l;u++){if(!n.obstacles[u])continue;let[c,h]=[Math.floor(u/l),
u%l];r.fillRect(s+h*a,o+c*a,a,a)}ao({ctx:r,grid:e,colors:t})}function ao({ctx:r,grid:{left:e,top:t,cell:n,rows:s,cols:o},colors:a}){let i=Math.min(5,Math.max(2,
Math.round(n/18)));r.strokeStyle=a.frame,r.lineWidth=i,r.strokeRect(e-i/2,t-i/2,o*n+i,s*n+i)}function io({ctx:r,grid:e,colors:t},n){let{left:s,top:o,cell:a,rows:i,
cols:l}=e,u=a<24*n?5:1;r.font=`500 ${Math.round(Math.min(15*n,Math.max(9*n,a*.32)))}px system-ui, sans-serif`,r.fillStyle=t.muted,r.textBaseline="alphabetic",r.
textAlign="center";let c=5*n+a/40;for(let h=0;h<l;h+=u)r.fillText(String(h),s+(h+.5)*a,o-c);r.textAlign="right",r.textBaseline="middle";for(let h=0;h<i;h+=u)r.fillText(
String(h),s-c,o+(h+.5)*a)}function lo({grid:r},e,t,n){let s=Math.floor(e.fov/2)+.5,[o,a]=[Math.max(0,t-s),Math.min(r.cols,t+s)],[i,l]=[Math.max(0,n-s),Math.min(
r.rows,n+s)];return[Q(r,o),ee(r,i),(a-o)*r.cell,(l-i)*r.cell]}function uo(r,e,t,n){let{ctx:s,grid:o,colors:a}=r;s.save(),s.beginPath(),s.rect(0,0,s.canvas.width,
s.canvas.height),s.rect(...lo(r,e,t,n)),s.clip("evenodd"),s.clearRect(0,0,s.canvas.width,s.canvas.height),s.fillStyle=a.line,s.fillRect(o.left,o.top,o.cols*o.cell,
o.rows*o.cell),s.restore(),ao(r)}function co({ctx:r,grid:e,colors:t},{x:n,y:s,alpha:o},a){let i=Math.max(e.cell,16*a)*1.06,[l,u]=[Q(e,n),ee(e,s)];r.globalAlpha=
Math.max(o,.6),r.beginPath(),r.roundRect(l-i/2,u-i/2,i,i,i*.2),r.strokeStyle=t.focus,r.lineWidth=Math.max(2,2.5*a),r.stroke();let c=Math.max(11*a,Math.min(18*a,
e.cell*.5));r.font=`700 ${Math.round(c)}px system-ui, sans-serif`,r.textAlign="center",r.textBaseline="middle";let h=u-i/2<c*1.2,d=u+(h?1:-1)*(i/2+c*.7);r.strokeStyle=
t.paper,r.lineJoin="round",r.lineWidth=c*.35,r.strokeText("You",l,d),r.fillStyle=t.ink,r.fillText("You",l,d),r.globalAlpha=1}function ho(r,e,t,n,s){let{ctx:o,grid:a}=r,
i=lo(r,e,n,s),l=qe(r,e,t);o.globalAlpha=.11,o.fillStyle=l,o.fillRect(...i),o.globalAlpha=.8,o.strokeStyle=l,o.lineWidth=Math.max(1,a.cell/24),o.strokeRect(...i),
o.globalAlpha=1}function mo(r,e,t,n,s){let{ctx:o,grid:a}=r,i=Math.min(Math.ceil(t),e.moments.length-1),l=e.moments[i];o.lineCap="round",o.lineWidth=Math.min(Hi,
Math.max(1,a.cell*ji));for(let u=Math.max(1,Math.floor(t-n)+1);u<=i;u++){let[c,h]=[e.moments[u-1],e.moments[u]],d=Math.max(0,Math.min(1,(t-u)/n));o.globalAlpha=
no+(Vi-no)*d;for(let p=0;p<h.alive.length;p++){let g=u===i&&t<i;if(!c.alive[p]||!(l.alive[p]||g))continue;let f=(_e(e,p)?-1:1)*Gi,[y,b]=k(c,p),[x,w]=k(h,p);if(y===
x&&b===w)continue;let M=g?s[p].x:w+.5,_=g?s[p].y:x+.5;o.strokeStyle=qe(r,e,p),o.beginPath(),o.moveTo(Q(a,b+.5+f),ee(a,y+.5+f)),o.lineTo(Q(a,M+f),ee(a,_+f)),o.stroke()}}
o.globalAlpha=1}function po(r,e,t){let n=Math.min(Math.ceil(t),e.moments.length-1);for(let s=Math.max(1,n-ro+1);s<=n;s++){let[o,a]=[e.moments[s-1],e.moments[s]],
i=s>t?Math.max(0,1-2*(s-t)):1-(t-s)/ro,l=yt(e,o,a);for(let u of rr(o,a))l.includes(u)||qi(r,k(a,u),i);for(let u of l)Yi(r,k(a,u),i)}r.ctx.globalAlpha=1}function Yi({
ctx:r,grid:e,colors:t},[n,s],o){r.globalAlpha=o,eo(r,Q(e,s+.5),ee(e,n+.5),Math.max(8,e.cell*Wi)),r.fillStyle=t.capture,r.fill(),r.strokeStyle=t.ink,r.lineWidth=
Math.max(1,e.cell/36),r.lineJoin="round",r.stroke()}function qi({ctx:r,grid:e,colors:t},[n,s],o){r.globalAlpha=o,Qs(r,Q(e,s+.5),ee(e,n+.5),Math.max(7,e.cell*zi)),
r.strokeStyle=t.collision,r.lineWidth=Math.max(2,e.cell*.17),r.lineCap="round",r.stroke()}function fo({ctx:r,grid:e,colors:t},n,s){let o=Math.max(1,e.cell*.07);
r.strokeStyle=r.fillStyle=t.collision,r.lineWidth=Math.max(1,e.cell*.05),r.setLineDash([e.cell*.14,e.cell*.1]);for(let[a,i]of n){if(a<0||i<0||a>=e.rows||i>=e.cols)
continue;let l=[Q(e,i)+o,ee(e,a)+o,e.cell-2*o,e.cell-2*o];r.globalAlpha=.2*s,r.fillRect(...l),r.globalAlpha=s,r.strokeRect(...l)}r.setLineDash([]),r.globalAlpha=
1}function yo({ctx:r,grid:e,colors:t},n,s,o,a){r.globalAlpha=a,Oe(r,Q(e,n),ee(e,s),Math.max(8,e.cell*o*1.02)),r.strokeStyle=t.collision,r.lineWidth=Math.max(1.5,
e.cell*.085*Math.sqrt(o)),r.stroke(),r.globalAlpha=1}var Ki=.8,Ji=.92,Zi=15,Xi=7,gn=9;function go(r,e,t,n,s,o){n.forEach((a,i)=>{a.alpha>0&&Qi(r,e,t,i,a,s,o)}),r.ctx.globalAlpha=1;for(let a of gt(e,t).values())a.length>
gn&&el(r,n[a[gn-1]],a.length-gn+1)}function Qi(r,e,t,n,s,o,a){let{ctx:i,grid:l,colors:u}=r,c=_e(e,n),[h,d]=[l.left+s.x*l.cell,l.top+s.y*l.cell],p=Math.max(4,l.cell*
s.size*(c?Ji:Ki)),g=qe(r,e,n),f=!c&&!!t.captured[n-e.nPursuers];if(i.globalAlpha=s.alpha,(c?sr:Oe)(i,h,d,p),p>Xi*a&&(i.strokeStyle=u.paper,i.lineWidth=Math.max(
2,p*.1),i.stroke()),i.fillStyle=f?u.paper:g,i.fill(),f&&(Oe(i,h,d,p*.82),i.strokeStyle=g,i.lineWidth=p*.18,i.stroke()),!o||p<Zi*a)return;let y=String(c?n:n-e.nPursuers);
i.font=`700 ${Math.round(p*(c?.4:.5)*(y.length>1?.8:1))}px system-ui, sans-serif`,i.textAlign="center",i.textBaseline="middle",i.fillStyle=f?g:u.paper,i.fillText(
y,h,d+p*(c?.17:.03))}function el({ctx:r,grid:e,colors:t},n,s){let[o,a]=[e.left+n.x*e.cell,e.top+n.y*e.cell];r.font=`700 ${Math.round(e.cell*.3)}px system-ui, sa\
ns-serif`,r.textAlign="center",r.textBaseline="middle",r.strokeStyle=t.paper,r.lineWidth=e.cell*.1,r.strokeText(`+${s}`,o,a),r.fillStyle=t.ink,r.fillText(`+${s}`,
o,a)}var tl=.46,rl=.86,nl=.66,bo=.48,sl=.78,ol=.58;function vo(r,e,t,n){let[s,o]=[e.moments[t-1],e.moments[t]];if(!s)return;let{ctx:a,grid:i,colors:l}=r;a.strokeStyle=
l.collision,a.lineWidth=Math.max(1.5,i.cell*.07),a.lineCap="butt",a.globalAlpha=n;for(let u=0;u<o.alive.length;u++)Qt(s,o,u)&&al(r,e,k(s,u),er(s,o,u));a.globalAlpha=
1}function al({ctx:r,grid:e},t,n,s){let[o,a]=[s[1]-n[1],s[0]-n[0]],i=h=>Q(e,n[1]+.5+o*h),l=h=>ee(e,n[0]+.5+a*h),u=mn(t,s)?sl:ol;r.setLineDash([e.cell*.09,e.cell*
.06]),r.beginPath(),r.moveTo(i(bo),l(bo)),r.lineTo(i(u),l(u)),r.stroke(),r.setLineDash([]);let c=.17*e.cell/Math.hypot(o,a);r.beginPath(),r.moveTo(i(u)-a*c,l(u)+
o*c),r.lineTo(i(u)+a*c,l(u)-o*c),r.stroke()}function wo(r,e,t,n,s,o){let a=Ve[o];if(!o||!a)return;let{ctx:i,grid:l,colors:u}=r,c=mn(e,[n[0]+a[0],n[1]+a[1]])?rl:
nl,h=tl*s.size,d=[Q(l,s.x+a[1]*h),ee(l,s.y+a[0]*h),Q(l,s.x+a[1]*c),ee(l,s.y+a[0]*c)],p=Math.max(1.5,l.cell*.085);i.lineCap=i.lineJoin="round";for(let[g,f]of[[u.
paper,p*2.1],[qe(r,e,t),p]])i.strokeStyle=g,i.lineWidth=f,to(i,...d,l.cell*.2),i.stroke()}var So={numbers:!0,axes:!1,trail:6,viewers:[],plan:null,selected:null,cursor:null,you:null,fog:!1};function Ao(r,e,t,n,s){let{ctx:o,grid:a,colors:i}=r,l=Math.min(
Math.ceil(t),e.moments.length-1),u=e.moments[l],c=t===l,h=nr(e,t),d=c?1:Math.max(0,1-2*(l-t));o.clearRect(0,0,o.canvas.width,o.canvas.height),so(r);for(let f of n.
viewers)h[f]?.alpha&&ho(r,e,f,...yn(e,f,t));oo(r,e),n.axes&&io(r,s),mo(r,e,t,n.trail,h),fo(r,u.contested??[],d),po(r,e,t),vo(r,e,l,d),h.forEach(({x:f,y,size:b},x)=>{
let w=Gs(u,x)?.4:0,M=fn(u,x)?1:w;M&&yo(r,f,y,b,M*d)});let p=c?u:e.moments[Math.max(0,l-1)];if(go(r,e,p,h,n.numbers,s),c&&n.plan)for(let[f,y]of h.entries())y.alpha&&
wo(r,e,f,k(u,f),y,n.plan[f]??0);n.you!==null&&(n.fog&&uo(r,e,...yn(e,n.you,t)),co(r,h[n.you],s)),o.lineWidth=Math.max(2,2.5*s),o.strokeStyle=i.focus;let g=n.selected===
null?void 0:h[n.selected];g?.alpha&&xo(r,g.x,g.y,g.size*.96),n.cursor&&(o.setLineDash([a.cell*.12,a.cell*.08]),xo(r,n.cursor[1]+.5,n.cursor[0]+.5,.8),o.setLineDash(
[]))}function xo({ctx:r,grid:e},t,n,s){let o=s*e.cell;r.beginPath(),r.roundRect(e.left+t*e.cell-o/2,e.top+n*e.cell-o/2,o,o,o*.1),r.stroke()}var Mo=(r,e)=>(e+.24)/(r+.24);function Eo(r,e,t,n,s,o){let a=t?28*o:0,i=(u,c)=>(u-a)/(c+2*.12),l=Math.max(1,Math.floor(Math.min(i(n,e),i(s,r))));return{rows:r,cols:e,
cell:l,left:Math.round((n-e*l+a)/2),top:Math.round((s-r*l+a)/2)}}function To(r,e,t){let n=Math.floor((t-r.top)/r.cell),s=Math.floor((e-r.left)/r.cell);return n>=
0&&n<r.rows&&s>=0&&s<r.cols?[n,s]:null}var il={paper:"--board-paper",line:"--board-line",frame:"--board-frame",ink:"--board-ink",muted:"--board-muted",obstacle:"--board-obstacle",pursuer:"--pursuer",
evader:"--evader",capture:"--capture",collision:"--collision",focus:"--focus"};function or(r){let e=getComputedStyle(r),t=Object.entries(il).map(([n,s])=>[n,e.getPropertyValue(
s).trim()]);return Object.fromEntries(t)}var ge=()=>matchMedia("(prefers-reduced-motion: reduce)").matches,Me=class{canvas;#e=null;#r=0;#t;#n={rows:1,cols:1,left:0,top:0,cell:1};#o=0;#s;#c;constructor(e,t={}){
this.canvas=e,e.classList.add("board"),e.setAttribute("role","img"),this.#t={...So,...t},this.#s=new ResizeObserver(()=>this.#a()),this.#s.observe(e),this.#c=new MutationObserver(
()=>this.redraw()),this.#c.observe(document.documentElement,{attributes:!0}),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",this.redraw),addEventListener(
"beforeprint",this.#u)}close(){this.#s.disconnect(),this.#c.disconnect(),matchMedia("(prefers-color-scheme: dark)").removeEventListener("change",this.redraw),removeEventListener(
"beforeprint",this.#u),cancelAnimationFrame(this.#o)}get look(){return this.#t}set look(e){this.#t={...this.#t,...e},this.#m(),this.redraw()}show(e,t){this.#e=e,
this.#r=Math.min(Math.max(0,t),e.moments.length-1),this.#m(),this.redraw()}redraw=()=>{this.#o||(this.#o=requestAnimationFrame(()=>this.drawNow()))};#u=()=>this.
drawNow();drawNow(){cancelAnimationFrame(this.#o),this.#o=0;let e=this.canvas.getContext("2d");if(!e||!this.#e)return;let{rows:t,cols:n}=this.#e,s=devicePixelRatio||
1;this.#n=Eo(t,n,this.#t.axes,this.canvas.width,this.canvas.height,s);let o={ctx:e,grid:this.#n,colors:or(this.canvas)};Ao(o,this.#e,this.#r,this.#t,s)}cellAt(e,t){
let n=this.canvas.getBoundingClientRect(),s=this.canvas.width/n.width;return To(this.#n,(e-n.left)*s,(t-n.top)*s)}agentAt(e,t){let n=this.cellAt(e,t);if(!n||!this.#e)
return null;let s=this.#e.moments[Math.round(this.#r)],o=gt(this.#e,s).get(n[0]*this.#e.cols+n[1])??[],a=nr(this.#e,Math.round(this.#r)),i=l=>{let[u,c]=this.pointOf(
a[l].x,a[l].y);return Math.hypot(u-e,c-t)};return o.length?o.reduce((l,u)=>i(u)<i(l)?u:l):null}pointOf(e,t){let n=this.canvas.getBoundingClientRect(),s=n.width/
this.canvas.width,{left:o,top:a,cell:i}=this.#n;return[n.left+(o+e*i)*s,n.top+(a+t*i)*s]}#m(){if(!this.#e)return;let{rows:e,cols:t}=this.#e;this.canvas.style.setProperty(
"--board-aspect",String(Mo(e,t)))}#a(){let e=devicePixelRatio||1,{width:t,height:n}=this.canvas.getBoundingClientRect();this.canvas.width=Math.max(1,Math.round(
t*e)),this.canvas.height=Math.max(1,Math.round(n*e)),this.drawNow()}};function bn(r,e,t){return{rows:r.rows,cols:r.cols,nPursuers:r.n_pursuers,fov:r.fov,interaction:r.rules.interaction,obstacles:e,moments:t}}function vn(r,e){return{
positions:r.read("last_positions"),alive:r.read("alive"),captured:r.read("captured"),everCaptured:r.read("ever_captured"),actions:e,involved:r.read("involved"),
fault:r.read("fault"),contested:r.conflicts().map(t=>t.cell)}}function ar(r){let e=Array.from({length:r.length+1},(t,n)=>ll(r,n));return bn(r.config,r.map,e)}function ll(r,e){
let t=r.n_agents,n=r.config.n_evaders,s=(a,i,l)=>a.subarray(i*l,(i+1)*l),o={positions:s(r.last_positions,e,2*t),alive:s(r.alive,e,t),captured:s(r.captured,e,n),
everCaptured:s(r.ever_captured,e,n)};return e===0?o:{...o,actions:s(r.actions,e-1,t),involved:s(r.involved,e-1,3*t),fault:s(r.fault,e-1,3*t),get contested(){return r.
conflicts(e).map(a=>a.cell)}}}var bt=[.5,1,2,4,8,16,32,64],ir=0,lr=12,ul=2,Ee=class extends EventTarget{#e;#r;#t;#n=0;#o=0;#s=!1;#c=null;#u=0;#m=[];#a=[];glide=.28;constructor(e,t={}){super(),
this.#e=e,this.#r=t.speed??4,this.#t=t.still??!1}get step(){return this.#n}get time(){return this.#t?this.#n:this.#o}get arrived(){return this.#o===this.#n}get playing(){
return this.#s}get length(){return this.#e}set length(e){this.#e=e,this.#n>e&&this.jump(e),this.#i("state")}get marks(){return this.#m}set marks(e){this.#m=e,this.#i(
"state")}get ticks(){return this.#a}set ticks(e){this.#a=e,this.#i("state")}get pace(){return this.#r||Math.max(ul,this.#e/lr)}get speed(){return this.#r}set speed(e){
this.#r=e,this.#i("state")}changeSpeed(e){let t=bt.findIndex(n=>n>=this.pace);this.speed=bt[Math.min(bt.length-1,Math.max(0,t+e))]}play(){this.#s||!this.#e||(this.#n===
this.#e&&this.jump(0),this.#s=!0,this.#i("state"),this.#l())}pause(){this.#s&&(this.#s=!1,this.#i("state"))}toggle(){this.#s?this.pause():this.play()}move(e){this.
pause();let t=Math.min(this.#e,Math.max(0,this.#n+e));Math.abs(t-this.#o)>1?this.jump(t):this.#h(t),this.#l()}jump(e){this.#o=Math.min(this.#e,Math.max(0,Math.round(
e))),this.#h(this.#o),this.#i("frame")}#h(e){e!==this.#n&&(this.#n=e,this.#i("step"),this.#t&&this.#i("frame"))}#l(){this.#c===null&&(this.#u=performance.now(),
this.#c=requestAnimationFrame(()=>this.#p()))}#p(){this.#c=null;let e=performance.now();this.#f(Math.min(.25,(e-this.#u)/1e3)),this.#u=e,(!this.#t||this.arrived)&&
this.#i("frame"),(this.#s||this.#o!==this.#n)&&(this.#c=requestAnimationFrame(()=>this.#p()))}#f(e){let t=e;for(;t>0;){if(this.#o===this.#n){if(!this.#s)return;
if(this.#n===this.#e)return this.pause();this.#h(this.#n+1)}let n=this.#s?this.pace:1/this.glide,s=this.#n-this.#o,o=Math.min(Math.abs(s),t*n);t-=o/n,this.#o=o===
Math.abs(s)?this.#n:this.#o+Math.sign(s)*o}this.#s&&this.#o===this.#e&&this.pause()}#i(e){this.dispatchEvent(new Event(e))}};function ur(r,e){if(e.ctrlKey||e.metaKey||
e.altKey)return!1;let t=e.shiftKey?10:1,s={" ":()=>r.toggle(),ArrowRight:()=>r.move(t),ArrowLeft:()=>r.move(-t),Home:()=>r.move(-r.length),End:()=>r.move(r.length),
"+":()=>r.changeSpeed(1),"-":()=>r.changeSpeed(-1)}[e.key];return s?.(),s!==void 0}var cl={first:"M6 5v14M19 5 9 12l10 7z",back:"M17 5 7 12l10 7z",play:"M7 4.5 19 12 7 19.5z",pause:"M8 5v14M16 5v14",forward:"M7 5l10 7-10 7z",last:"M18 5v14M5 5\
l10 7-10 7z"};function Co(r){return v("svg",{viewBox:"0 0 24 24","aria-hidden":"true",class:"icon"},v("path",{d:cl[r]}))}function vt(r,e,t,n){return m("button",
{type:"button",class:"player-button","aria-label":e,title:`${e} (${t})`,onclick:n},Co(r))}function cr(r){let e=vt("play","Play","Space",()=>r.toggle()),t=hl(r),
n=m("div",{class:"captures","aria-hidden":"true",title:"Captures"}),s=m("div",{class:"losses","aria-hidden":"true"}),o=dl(r),a=m("output",{class:"player-count"}),
i=m("div",{class:"player",role:"group","aria-label":"Player"},vt("first","First step","Home",()=>r.move(-r.length)),vt("back","Step back","←",()=>r.move(-1)),
e,vt("forward","Step forward","→",()=>r.move(1)),vt("last","Last step","End",()=>r.move(r.length)),m("div",{class:"scrub"},n,s,t),a,o),l=(h,d={})=>{let p=m("i",
d);return p.style.left=`${100*h/Math.max(1,r.length)}%`,p},u=()=>{n.replaceChildren(...r.marks.map(h=>l(h))),s.replaceChildren(...r.ticks.map(({step:h,kind:d,size:p,
text:g})=>{let f=l(h,{class:d,title:`Step ${h}: ${g}`});return f.style.height=`${100*p}%`,f}))},c=()=>{e.replaceChildren(Co(r.playing?"pause":"play")),e.ariaLabel=
r.playing?"Pause":"Play",e.title=`${e.ariaLabel} (Space)`,t.max=String(r.length),t.value=String(r.step),t.ariaValueText=`step ${r.step} of ${r.length}`,a.textContent=
`${r.step} / ${r.length}`,a.style.minWidth=`${2*String(r.length).length+3}ch`,o.value=String(r.speed)};return r.addEventListener("step",c),r.addEventListener("s\
tate",c),r.addEventListener("state",u),i.addEventListener("keydown",h=>{!(h.target instanceof HTMLSelectElement||h.key===" "&&h.target!==t)&&ur(r,h)&&h.preventDefault()}),
c(),i}function hl(r){let e=m("input",{type:"range",class:"player-scrub",min:0,step:1,"aria-label":"Step"});return e.addEventListener("input",()=>{r.pause(),r.jump(
Number(e.value))}),e}function dl(r){let e=`Steps a second, or the whole in ${lr} s (+ and -)`,t=m("select",{class:"player-speed","aria-label":"Speed",title:e},m(
"option",{value:ir},`in ${lr} s`),...bt.map(n=>m("option",{value:n},`${n} / s`)));return t.addEventListener("change",()=>{r.speed=Number(t.value)}),t}var ml=40,hr=class{element;#e;#r=m("div",{class:"episodes",role:"group","aria-label":"Episodes of this cell"});#t=m("p",{class:"check small numbers","aria-live":"\
polite"});constructor(e){this.#e=e,this.element=m("div",{class:"strip-of-episodes"},this.#r,this.#t)}show(e,t){let{pursuer:n,evader:s,episode:o,seed:a,map:i}=this.#e.
selected,l=Ge(e,n,s);this.#r.replaceChildren(...(l?.rates??[]).slice(0,ml).map((p,g)=>this.#n(p,g)));let u=a===null&&i===null?l?.rates[o]:void 0,c=t.statistics.
capture_rate,h=u!==void 0&&Math.abs(c-u)<1e-6&&t.length===l?.lengths[o],d=l?"Not an episode of the evaluation":"The evaluation played no episodes of this pair.";
this.#t.dataset.equal=String(h),this.#t.textContent=h?"As in the evaluation":u===void 0?d:`Episode ${o+1} differs from the evaluation.`,this.#t.title=`Played he\
re: capture rate ${V(c,3)} in ${t.length} steps.${l?` The cell says ${V(l.rate,3)}.`:""}`}#n(e,t){let{selected:n}=this.#e,s=m("span",{class:"bar"});return s.style.
height=`${Math.round(100*e)}%`,m("button",{type:"button",class:"episode",title:`Episode ${t+1}: capture rate ${V(e)}`,"aria-label":`Episode ${t+1}, capture rate\
 ${V(e)}`,"aria-pressed":String(t===n.episode&&n.seed===null&&n.map===null),onclick:()=>this.#e.select({episode:t,seed:null,map:null})},s,m("span",{class:"count"},
t+1))}};var ko=0,_o=1,pl=2,fl=176;function Ro(r,e,t,n){let s=devicePixelRatio||1,o=or(r);r.width=r.height=fl*s;let a=r.getContext("2d");if(!a)return;let{fov:i}=e,l=r.width/
i;a.fillStyle=o.paper,a.fillRect(0,0,r.width,r.height);for(let c=0;t&&c<i*i;c++){let[h,d]=[(c%i+.5)*l,(Math.floor(c/i)+.5)*l],p=f=>!!t[f*i*i+c];p(pl)&&(a.fillStyle=
o.obstacle,a.fillRect(h-l/2,d-l/2,l,l));let g=p(ko)&&p(_o)?l*.18:0;p(ko)&&Oo(a,Oe,h+g,d+g,l*.74,o.evader),p(_o)&&Oo(a,sr,h-g,d-g,l*.86,o.pursuer)}a.strokeStyle=
n<e.n_pursuers?o.pursuer:o.evader,a.lineWidth=2*s;let u=Math.floor(i/2)*l;a.strokeRect(u,u,l,l)}function Oo(r,e,t,n,s,o){e(r,t,n,s),r.fillStyle=o,r.fill()}var Po="What it remembers: a number for each unit, from -1 to 1",dr=class{element;#e;#r=m("canvas",{class:"seen",role:"img"});#t=m("h3");#n=m("p",{class:"small \
muted"});#o=m("div",{class:"answers"});#s=m("div",{title:Po});#c=null;#u=null;#m=null;#a=null;#h=null;#l=null;#p=0;constructor(e){this.#e=e,this.element=m("div",
{class:"inspector","data-open":"false"},m("p",{class:"hint small muted"},"Click an agent, or press A: what it sees, and what its network answers."),m("div",{class:"\
inspected"},this.#r,m("div",{class:"answer"},this.#t,this.#n,this.#s),this.#o))}get agent(){return this.#l}show(e,t,n,s){this.#c?.free(),this.#c=e.world(n.config),
this.#m!==t&&(this.#u=null,this.#l!==null&&this.choose(null)),[this.#m,this.#a,this.#h]=[t,n,s]}set solution(e){this.#u=e,this.at(this.#p)}choose(e){this.#l=e,this.
element.dataset.open=String(e!==null),this.#e(e),this.at(this.#p)}next(e){let t=this.#a;if(!t)return;let n=this.#l??(e>0?-1:0);for(let s=0;s<t.n_agents;s++)if(n=
(n+e+t.n_agents)%t.n_agents,t.alive[this.#p*t.n_agents+n])return this.choose(n)}at(e){this.#p=e;let[t,n,s,o,a]=[this.#a,this.#c,this.#m,this.#h,this.#l];if(!t||
!n||!s||!o||a===null)return;let i=a<t.config.n_pursuers?"pursuer":"evader";this.#s.replaceChildren(),this.#t.replaceChildren(m("span",{class:i},H(a,t.config.n_pursuers)));
let l={pursuers:Z(s,"pursuer",o.pursuer),evaders:Z(s,"evader",o.evader)};t.seek(n,e,l);let u=t.actions.subarray(e*t.n_agents,(e+1)*t.n_agents);for(;u.length&&!n.
over&&(a<n.actors[0]||a>=n.actors[1]);)n.playTurn(u);let c=!!(t.alive[e*t.n_agents+a]&&n.read("alive")[a]);Ro(this.#r,t.config,c?n.view(a):null,a),this.#r.ariaLabel=
`Field of view of ${H(a,t.config.n_pursuers)}: evaders, pursuers and obstacles around it`;let h=u[a]??null;if(!c)return this.#f([],"It is gone.");let d=l[`${i}s`],
p=typeof d=="string"?null:n.answer(d,a),g=p?.probabilities??null;p?.memory.length&&this.#s.replaceChildren(m("p",{class:"small muted"},"It remembers:"),bl(p.memory));
let f=this.#u?.game(n)??null,y=typeof d=="string"?`The script "${d}" plays for it${h===null?"":`; it goes ${ie[h]}`}.`:d.sampled?"Its action is drawn from these\
 probabilities.":"It takes the most probable action.",b=[["network",g],["perfect",f?.marginal(a)??null]],x=w=>m("p",{class:"small muted"},w);this.#f([...f?[x(`V\
alue ${f.value.toFixed(2)} under perfect play.`)]:[],...yl(b,h)],h===null?"The episode is over.":y)}#f(e,t){this.#o.replaceChildren(...e),this.#n.textContent=t}};
function yl(r,e){let t=r.filter(([,o])=>o);if(!t.length)return[];let n=m("div",{class:"action muted"},m("span"),...t.map(([o])=>m("span",{class:"head"},o))),s=Array.
from(t[0][1],(o,a)=>m("div",{class:a===e?"action taken":"action"},m("span",{},ie[a]),...t.flatMap(([,i])=>gl(i[a]))));return t.length>1||t[0][0]!==r[0][0]?[n,...s]:
s}function gl(r){let e=m("span",{class:"filled"});return e.style.width=`${100*r}%`,[m("span",{class:"track"},e),m("span",{class:"numbers"},r.toFixed(2))]}function bl(r){
let e=Array.from(r,t=>{let n=m("span",{title:t.toFixed(2)});return n.style.transform=`scaleY(${t})`,n});return m("div",{class:"units",role:"img","aria-label":Po},
...e)}function Lo(r,e,{pursuer:t,evader:n,episode:s,seed:o,map:a}){let i=e.seeds[t][n];return r.match(jt(e,a),Z(e,"pursuer",t),Z(e,"evader",n),BigInt(o??i),s)}function $o(r){let e=JSON.stringify(r,(t,n)=>t==="genome"?Array.from(n):n);return m("script",{type:"application/json",id:"champions"},e.replaceAll("<","\\u003c")).
outerHTML}var No="champion",Io=0,wn=64,xn=100;var vl=(r,e)=>Object.keys(r).every(t=>r[t]===e[t]);function Fo(r,e){return Object.keys(e).find(t=>vl(e[t],r))??null}var wt="_",wl="n",Lh=2n**64n-1n;var Sn={fov:11,maxSteps:500,rewards:"paper"},xl=["rules","others","rewards","size","diagonal","fov","limit","seed","ended","walls","pursuers","evaders","played",
"next"];function Wo(r,e){let t=i=>i.map(l=>Al(l,e)).join(""),n=i=>`${Math.floor(i/r.cols)}.${i%r.cols}`,s=Sl(r.rewards,e),o=[r.seed,r.episode,r.steps].join("."),a={rules:Do(
r.rules,e),others:r.others?Do(r.others,e):"",rewards:s===Sn.rewards?"":s,size:`${r.rows}x${r.cols}`,diagonal:r.diagonal?"1":"",fov:r.fov===Sn.fov?"":String(r.fov),
limit:r.maxSteps===Sn.maxSteps?"":String(r.maxSteps),seed:o==="0.0.0"?"":o,ended:r.ended?"1":"",walls:r.walls.map(n).join(wt),pursuers:r.pursuers.map(Uo).join(wt),
evaders:r.evaders.map(Uo).join(wt),played:r.played.map(t).join(wt),next:r.next.every(i=>i===Io)?"":t(r.next)};return xl.filter(i=>a[i]).map(i=>`${i}=${a[i]}`).join(
"&")}function Uo({cell:r,gone:e,captured:t,everCaptured:n}){let s=t?"c":n?"e":"";return`${r[0]}.${r[1]}${s}${e?"x":""}`}function Do(r,e){let t=e.fields.map(({name:n})=>String(
r[n]).toLowerCase());return Fo(r,e.variants)??t.join(".")}function Sl(r,e){let t=JSON.stringify(r);return Object.keys(e.rewards).find(s=>JSON.stringify(e.rewards[s])===
t)??Object.values(r).map(s=>String(s)).join(wt)}function Al(r,e){if(typeof r=="number")return String(r);if(r===No)return wl;let t=e.scripts.findIndex(({name:n})=>n===
r);return String.fromCharCode(97+t)}var Ml="/* the engine */";function zo(r,e){return m("button",{type:"button",class:"to-playground",title:"Open this step in the playground (G): the same agents a\
nd actions under any rules",onclick:()=>El(r(),e)},"What if?")}function El(r,e){let t=r!==null&&r.match.n_agents<=xn&&Math.max(r.match.config.rows,r.match.config.
cols)<=wn,n=t?Wo(Tl(r.match,r.step),e):"",s=new TextDecoder().decode(ln("playground")).replace(Ml,()=>Ae("script-engine")).replace("</noscript>",o=>t?o+$o(r.champions):
o);window.open(`${URL.createObjectURL(new Blob([s],{type:"text/html"}))}#${n}`)}function Tl(r,e){let{config:t,n_agents:n}=r,s=Math.max(0,e-1),o=i=>{let l=s*n+i,
u=s*t.n_evaders+i-t.n_pursuers,c=h=>i>=t.n_pursuers&&!!h[u];return{cell:[r.last_positions[2*l],r.last_positions[2*l+1]],gone:!r.alive[l],captured:c(r.captured),
everCaptured:c(r.ever_captured)}},a=Array.from({length:n},(i,l)=>o(l));return{rules:t.rules,others:null,rewards:t.rewards,rows:t.rows,cols:t.cols,diagonal:t.diagonal,
fov:t.fov,maxSteps:t.max_steps,seed:r.seed,episode:BigInt(r.episode),steps:s,ended:s===r.length,walls:Array.from(r.map.keys()).filter(i=>r.map[i]),pursuers:a.slice(
0,t.n_pursuers),evaders:a.slice(t.n_pursuers),played:[],next:Array.from(r.actions.subarray(s*n,(s+1)*n))}}var An=.005,jo=.05,Cl=["pursuer","evader"],kl=4,Ke=new Map;function Je(r,e,t="capture-rate"){let n=JSON.stringify([{...e,rewards:null},t]),s=Ke.get(n)??(je(e)?Promise.
resolve(null):_l(r,e,t));return Ke.delete(n),Ke.set(n,s),Ke.size>kl&&Ke.delete([...Ke.keys()][0]),s}var Ho=({n_evaders:r})=>r===1?"capture-time":"capture-rate",
Bo=()=>new Promise(r=>setTimeout(r));async function _l(r,e,t){await Bo();let n=r.solution(e,t);for(;n.goBack();)await Bo();return n}function mr(r,e,t){let{payoff:n}=r;
return t.flatMap((s,o)=>{let a=[0,0];for(let l=e.n_turns;l>0&&!e.over;l--)r.game(e)?.lost(s).forEach((u,c)=>a[c]+=u),e.playTurn(s);let i=n==="capture-rate"?An:jo;
return Cl.map((l,u)=>({step:o+1,team:l,lost:a[u],payoff:n})).filter(l=>l.lost>=i)})}var pr=r=>r.map(e=>({step:e.step,kind:e.team,size:e.lost/Math.max(1,...r.map(
({lost:t})=>t)),text:xt(e)})),Go=({lost:r,payoff:e})=>e==="capture-rate"?`${r.toFixed(2)} of the capture rate`:`${r.toFixed(1)} steps`,xt=r=>`The ${r.team}s los\
e ${Go(r)} against a perfect opponent`;function Vo(r){let e=r.reduce((t,n)=>n.lost>t.lost?n:t);return`Your team's worst moves, in step ${e.step}, lost ${Go(e)} \
against a perfect opponent.`}function Yo({config:r,payoff:e},{value:t},n){if(e==="capture-rate")return`value ${t.toFixed(2)}`;let[s,o]=[1-t,Math.min(r.max_steps-
n,Gr)];return s>o-jo?`free for ${o} steps`:`captured after ${s.toFixed(1)} steps`}function qo(r,e){return(r.marginal(e)??[]).map((n,s)=>({share:n,action:s})).filter(
({share:n})=>n>=An).sort((n,s)=>s.share-n.share).map(({share:n,action:s})=>n>1-An?ie[s]:`${ie[s]} ${n.toFixed(2)}`).join(", ")}function fr(r,e,t){if(t===0)return[{kind:"start",text:Ol(r),agents:[]}];let[n,s]=[e.moments[t-1],e.moments[t]],o=c=>H(c,r.config.n_pursuers),a=yt(e,n,s),i=r.conflicts(
t),l=new Set(i.flatMap(c=>c.doomed)),u=a.map(c=>({kind:"capture",text:`${o(c)} is captured`,agents:[c]}));for(let c of rr(n,s))!a.includes(c)&&!l.has(c)&&u.push(
{kind:"end",text:`${o(c)} disappears`,agents:[c]});return u.push(...i.map(({kind:c,text:h,agents:d})=>({kind:c,text:h,agents:d}))),t===r.length&&u.unshift({kind:"\
end",text:Rl(r),agents:[]}),u}function Ol({config:r}){return`${r.n_pursuers} pursuers and ${r.n_evaders} evaders on ${r.rows} x ${r.cols} cells, at most ${r.max_steps}\
 steps`}function Rl(r){let e=Math.round(r.statistics.capture_rate*r.config.n_evaders);return`The episode ends after ${r.length} steps with ${e} of ${r.config.n_evaders}\
 evaders captured`}var Pl=60,yr=class{element;player=new Ee(0,{speed:ir,still:ge()});inspector;match=null;recording=null;actions;#e;#r;#t;#n;#o=m("h2",{class:"match-title"});#s=m(
"p",{class:"tally numbers"});#c=m("ol",{class:"words",tabindex:0,"aria-live":"off","aria-label":"What happened in this step"});#u=m("p",{class:"problem",role:"a\
lert"});#m=null;#a=null;#h=0;#l=!1;#p=0;#f=[];constructor(e,t,n){[this.#r,this.#t]=[e,t];let s=m("canvas",{"aria-label":"The match"});this.#e=new Me(s,{numbers:!1}),
this.#n=new hr(t),this.inspector=new dr(o=>this.#x(o)),s.addEventListener("click",o=>this.inspector.choose(this.#e.agentAt(o.clientX,o.clientY))),this.actions=m(
"div",{class:"beside"},m("button",{type:"button",class:"to-play",title:"Move the chosen agent, or an evader, yourself from this step on (T)",onclick:()=>this.element.
dispatchEvent(new Event("takeover"))},"Take over"),n&&zo(()=>this.shown,n)),this.element=m("section",{class:"card match-card","aria-label":"Match",id:"match"},m(
"div",{class:"match"},m("header",{class:"match-head"},this.#o,this.#s),this.#u,m("div",{class:"stage"},s),m("div",{class:"aside"},this.#c,Dt(),this.actions,this.
inspector.element),cr(this.player),this.#n.element)),this.player.addEventListener("frame",()=>this.recording&&this.#e.show(this.recording,this.player.time)),this.
player.addEventListener("step",()=>this.#b()),t.on("match",()=>this.#g()),t.on("rest",()=>this.player.pause()),this.#w(),this.#S(0,0)}get#i(){return this.#r[this.#t.
selected.run]}reveal(){this.#e.canvas.scrollIntoView({block:"nearest"})}get shown(){return this.match&&this.#a&&{match:this.match,step:this.player.step,champions:this.#a}}start(e){
this.#m=e,this.#y()}playSoon(){this.#l=!0,this.#h||this.#d()}goTo(e){this.#p=e,!this.#h&&this.match&&this.#y()}#d(){!this.#l||!this.match||(this.#l=!1,this.player.
jump(0),ge()||this.player.play())}#g(){this.#w(),clearTimeout(this.#h),this.#h=setTimeout(()=>this.#y(),Pl)}#y(){clearTimeout(this.#h),this.#h=0,this.player.pause(),
this.#w();let{selected:e}=this.#t,t=He.map(o=>Ht(this.#i,o,e[o])).find(Boolean)??"";if(this.#u.textContent=t,t||!this.#m)return;this.match=Lo(this.#m,this.#i,e);
let[n,s]=this.names(e);this.#a={pursuer:{name:n,policy:Z(this.#i,"pursuer",e.pursuer)},evader:{name:s,policy:Z(this.#i,"evader",e.evader)}},this.recording=ar(this.
match),this.#n.show(this.#i,this.match),this.inspector.show(this.#m,this.#i,this.match,e),this.player.length=this.match.length,this.player.marks=tr(this.recording),
this.#f=this.player.ticks=[],this.player.jump(this.#p),this.#p=0,this.#b(),this.#v(this.#m,this.match),this.element.dataset.played=`${e.run} ${e.pursuer} ${e.evader}\
 ${e.episode} ${e.seed??""}`,this.element.dataset.map=String(e.map??""),this.#d()}async#v(e,t){let n=await Je(e,t.config);if(this.match!==t||!n)return;let s=e.world(
t.config);t.seek(s,0),this.#f=mr(n,s,Ll(t)),s.free(),this.player.ticks=pr(this.#f),this.inspector.solution=n,this.#b()}names({run:e,pursuer:t,evader:n}){let{teams:s}=this.#r[e];
return[s.pursuer.script??ne("pursuer",t),s.evader.script??ne("evader",n)]}#w(){let{episode:e,seed:t,map:n}=this.#t.selected,{payoff:s,maps:o}=this.#i,[a,i]=this.
names(this.#t.selected),l=t===null?e<s.episodes?`episode ${e+1} of ${s.episodes}`:`episode ${e+1}, not part of the cell`:`seed ${t}`,u=o&&n!==null?`, on map ${n%
o.count+1} of generation ${Math.floor(n/o.count)}`:"";this.#o.replaceChildren(m("span",{class:"pursuer"},Zt(a))," against ",m("span",{class:"evader"},i),m("span",
{class:"muted small"},l+u))}#b(){let e=this.match;if(!e||!this.recording)return;let t=this.player.step,n=this.recording.moments[t];this.#S(Array.from(n.everCaptured).
filter(Boolean).length,t),this.#c.replaceChildren(...this.#f.filter(s=>s.step===t).map(s=>m("li",{class:`loss-${s.team}`},xt(s))),...fr(e,this.recording,t).map(
s=>m("li",{class:s.kind,"data-agents":s.agents.join(" ")},s.text))),this.inspector.at(t),this.#A()}#S(e,t){this.#s.replaceChildren(m("strong",{},e),` of ${this.#i.
world.n_evaders} captured`,m("span",{class:"muted"},` · step ${t}`))}#x(e){this.#e.look={selected:e,viewers:e===null?[]:[e]},this.#A()}#A(){let e=this.inspector.
agent;for(let t of this.#c.children){let n=t.dataset.agents?.split(" ")??[];t.classList.toggle("about",e!==null&&n.includes(String(e)))}}},Ll=({actions:r,length:e,
n_agents:t})=>Array.from({length:e},(n,s)=>r.subarray(s*t,(s+1)*t));var $l={ArrowUp:[1,0],ArrowDown:[-1,0],ArrowRight:[0,1],ArrowLeft:[0,-1]},Nl=5;function Jo(r,e,t,n="pursuer"){r.tabIndex=0,r.setAttribute("role","application"),
r.addEventListener("keydown",s=>{let o=$l[s.key];if(!o)return;let[a,i]=n==="pursuer"?o:[o[1],o[0]],[l,u]=t(),c=s.shiftKey?Nl:1,{pursuer:h,evader:d}=e.selected;e.
select({pursuer:Ko(h+c*a,l),evader:Ko(d+c*i,u)}),s.preventDefault(),s.stopPropagation()})}var Ko=(r,e)=>Math.min(e-1,Math.max(0,r));var St=[[68,1,84],[72,26,108],[71,47,125],[65,68,135],[57,86,140],[49,104,142],[42,120,142],[35,136,142],[31,152,139],[34,168,132],[53,183,121],[84,197,104],[122,
209,81],[165,219,54],[210,226,27],[253,231,37]];function gr(r){let e=Math.min(1,Math.max(0,r))*(St.length-1),t=Math.min(St.length-2,Math.floor(e)),[n,s]=[St[t],
St[t+1]],o=a=>Math.round(n[a]+(e-t)*(s[a]-n[a]));return[o(0),o(1),o(2)]}function Zo(r){let[e,t,n]=gr(r).map(s=>((s/255+.055)/1.055)**2.4);return .2126*e+.7152*t+
.0722*n>.179?"#000":"#fff"}var Xo=r=>`rgb(${gr(r).join(" ")})`,Qo=()=>`linear-gradient(to right, ${St.map(r=>`rgb(${r.join(" ")})`).join(", ")})`;function ea(r,e,t){let n=devicePixelRatio||1;for(let[a,i]of Object.entries(t))r.style.setProperty(a,`${i}px`);r.width=Math.round(t.width*n),r.height=Math.round(
t.height*n);let s=r.getContext("2d"),o=Il(e);!s||!o||(s.imageSmoothingEnabled=!1,s.drawImage(o,0,0,r.width,r.height))}function Il(r){let[e,t]=r.shape,n=document.
createElement("canvas");[n.width,n.height]=[t,e];let s=n.getContext("2d");if(!s)return null;let o=s.createImageData(t,e);return r.capture_rate.forEach((a,i)=>a.
forEach((l,u)=>{let c=4*((e-1-i-r.first[0])*t+u+r.first[1]);o.data.set([...gr(l),255],c)})),s.putImageData(o,0,0),n}function ta(r,e){let t=m("span",{class:"grad\
ient"});return t.style.backgroundImage=Qo(),m("p",{class:"scale-of-rates small muted"},r,t,e)}var Fl=24,br=7,na=r=>r<Fl&&matchMedia("(pointer: coarse)").matches;function sa(r,e,t,n){let[s,o]=r.payoff.shape,[a,i]=[ra(e,s),ra(t,o)],[l,u]=[Math.min(br,s),Math.
min(br,o)],c=[];for(let g=a+l-1;g>=a;g--){c.push(m("span",{class:"pursuer"},g));for(let f=i;f<i+u;f++)c.push(Ul(r,g,f,n))}let h=Array.from({length:u},(g,f)=>m("\
span",{class:"evader"},i+f)),d=m("button",{type:"button","aria-label":"Close: all cells",onclick:()=>n(null)},"✕"),p=m("div",{class:"loupe numbers",role:"grou\
p","aria-label":"Cells around the tap"},...c,d,...h);return p.style.gridTemplateColumns=`2.4rem repeat(${u}, minmax(0, 1fr))`,p.addEventListener("click",g=>g.stopPropagation()),
p}function Ul(r,e,t,n){let s=Ge(r,e,t)?.rate,o=m("button",{type:"button","aria-label":`${V(s)}: ${ne("pursuer",e)} against ${ne("evader",t)}`,onclick:()=>n({pursuer:e,
evader:t})},V(s));return s!==void 0&&([o.style.backgroundColor,o.style.color]=[Xo(s),Zo(s)]),o}var ra=(r,e)=>Math.max(0,Math.min(e-br,r-Math.floor(br/2)));var te={left:52,bottom:46,top:76,right:84},le=10,Dl=160,At=te.right-le-14,Re=te.top-le-14,vr=class{element;#e;#r;#t=m("canvas",{"aria-hidden":"true"});#n=v("svg",
{"aria-hidden":"true"});#o=v("g");#s;#c=m("h2");#u=m("strong",{class:"rate numbers"});#m=m("span",{class:"small muted"});#a=m("p",{class:"of-both-teams small mu\
ted numbers"});#h=null;constructor(e,t){[this.#r,this.#e]=[e,t],this.#s=m("div",{class:"matrix",id:"matrix","aria-label":"Payoff matrix. Arrow keys choose a mat\
ch, Enter plays it."},this.#t,this.#n);let n=m("header",{class:"readout","aria-live":"polite"},m("div",{},this.#c,this.#a),m("div",{class:"of-cell"},this.#u,this.#m));
this.element=m("section",{class:"card matrix-card","aria-label":"Payoff matrix"},n,this.#s,ta("0 all escape","1 all caught")),this.#g(),new ResizeObserver(()=>this.#p()).
observe(this.#s),this.#s.addEventListener("pointermove",s=>this.#w(s)),this.#s.addEventListener("pointerleave",()=>t.point({})),this.#s.addEventListener("click",
s=>this.#b(s)),this.#s.addEventListener("mousedown",s=>{s.preventDefault(),document.activeElement instanceof HTMLElement&&document.activeElement.blur()}),Jo(this.#s,
t,()=>this.#l.payoff.shape),this.#s.addEventListener("keydown",s=>{s.key==="Enter"&&this.#x()}),t.on("run",()=>this.#p()),t.on("match",()=>this.#d()),t.on("hove\
r",()=>this.#d())}get#l(){return this.#r[this.#e.selected.run]}#p(){let[e,t]=this.#l.payoff.shape,{clientWidth:n,clientHeight:s}=this.#s;if(n<50)return;let a=Math.
max(Dl,Math.min(n-te.left-te.right,s-te.top-te.bottom))/Math.max(e,t),i=Math.max(te.left,(n-t*a-te.right+te.left)/2),l=te.top+Math.max(0,(s-te.top-te.bottom-e*a)/
2),u={width:n,height:s,left:i,top:l,cell:a,rows:e,columns:t};this.#h=u,ea(this.#t,this.#l.payoff,{left:i,top:l,width:t*a,height:e*a});for(let[c,h,d]of[["left",i,
n],["top",l,s],["width",t*a,n],["height",e*a,s]])this.#t.style.setProperty(c,`${100*h/d}%`);this.#s.style.setProperty("--shape",`${n} / ${s}`),this.#n.setAttribute(
"viewBox",`0 0 ${n} ${s}`),this.#n.replaceChildren(Wl(u),...zl(u),...this.#i(u),this.#o),this.#d()}#f(e){let t=this.#l.findings?.generalization;if(!t)return[];let{
selected:n,hover:s}=this.#e,[o,a]=[s.pursuer??n.pursuer,s.evader??n.evader],[i,l]=oa(e,t.pursuers.mean[o]??0,o),[u,c]=aa(e,t.evaders.mean[a]??0,a);return[v("cir\
cle",{class:"dot of-pursuers",cx:i,cy:l,r:5}),v("circle",{class:"dot of-evaders",cx:u,cy:c,r:5})]}#i(e){let t=this.#l.findings?.generalization;if(!t)return[];let{
left:n,top:s,cell:o,rows:a,columns:i}=e,[l,u]=[n+i*o+le,s-le],c={class:"side"};return[v("rect",{...c,x:l,y:s,width:At,height:a*o}),v("rect",{...c,x:n,y:u-Re,width:i*
o,height:Re}),...ia(t.pursuers,(h,d)=>oa(e,h,d),"of-pursuers"),...ia(t.evaders,(h,d)=>aa(e,h,d),"of-evaders"),v("text",{class:"tick",x:l,y:s+a*o+16,"text-anchor":"\
start"},"0"),v("text",{class:"tick",x:l+At,y:s+a*o+16,"text-anchor":"end"},"1"),v("text",{class:"tick",x:n-6,y:u-4,"text-anchor":"end"},"0"),v("text",{class:"ti\
ck",x:n-6,y:u-Re+8,"text-anchor":"end"},"1"),v("text",{class:"label of-pursuers",x:l+At,y:s+a*o+34,"text-anchor":"end"},"captures"),v("text",{class:"label of-ev\
aders",x:n+i*o+le,y:u-Re+10,"text-anchor":"start"},"escapes")]}#d(){let e=this.#h;if(!e)return;let{selected:t,hover:n}=this.#e,{left:s,top:o,cell:a,rows:i,columns:l}=e,
u=g=>o+(i-1-g)*a,c=[],h=(g,f)=>v("rect",{class:f,x:s,y:u(g),width:l*a+le+At,height:a}),d=(g,f)=>v("rect",{class:f,x:s+g*a,y:o-le-Re,width:a,height:le+Re+i*a});c.
push(h(t.pursuer,"strip pursuer"),d(t.evader,"strip evader")),n.pursuer!==null&&n.pursuer<i&&c.push(h(n.pursuer,"strip hover")),n.evader!==null&&n.evader<l&&c.push(
d(n.evader,"strip hover")),c.push(...this.#f(e));let p={x:s+t.evader*a,y:u(t.pursuer),width:a,height:a};c.push(v("rect",{class:"chosen under",...p}),v("rect",{class:"\
chosen",...p})),this.#o.replaceChildren(...c),this.#g()}#g(){let{selected:e,hover:t}=this.#e,n=t.pursuer??e.pursuer,s=t.evader??e.evader,o=Ge(this.#l,n,s);this.#c.
replaceChildren(m("span",{class:"pursuer"},Zt(ne("pursuer",n)))," against ",m("span",{class:"evader"},ne("evader",s))),this.#u.textContent=o?V(o.rate,3):"-",this.#m.
textContent=o?`capture rate, mean of ${o.rates.length} episodes`:"no episodes were played",this.#a.textContent=this.#y(n,s)}#y(e,t){let n=this.#l.findings?.generalization;
if(!n)return"";let s=(o,a)=>Fs(o.mean[a]??null,o.low?.[a]??null,o.high?.[a]??null);return`Against all: captures ${s(n.pursuers,e)}, escapes ${s(n.evaders,t)}`}#v(e){
let t=this.#h;if(!t)return null;let n=this.#s.getBoundingClientRect(),s=Math.floor((e.clientX-n.left-t.left)/t.cell),o=t.rows-1-Math.floor((e.clientY-n.top-t.top)/
t.cell),[a,i]=[o>=0&&o<t.rows,s>=0&&s<t.columns];return a||i?{g:a?o:-1,h:i?s:-1,inside:a&&i}:null}#w(e){let t=this.#v(e);this.#e.point(t?{pursuer:t.g<0?null:t.g,
evader:t.h<0?null:t.h}:{})}#b(e){let t=this.#v(e);if(t){if(t.inside&&na(this.#h.cell))return this.#S(t.g,t.h);this.#e.select({...t.g<0?{}:{pursuer:t.g},...t.h<0?
{}:{evader:t.h}}),t.inside&&this.#x()}}#S(e,t){let n=sa(this.#l,e,t,s=>{n.remove(),s&&(this.#e.select(s),this.#x())});this.#s.append(n)}#x(){this.#s.dispatchEvent(
new CustomEvent("play",{bubbles:!0}))}};function Wl({left:r,top:e,cell:t,rows:n,columns:s}){let o=v("g",{class:"axes"}),a=e+n*t,i=l=>ft(0,l-1,Math.min(l,l*t/44),
!0);for(let l of i(s))o.append(v("text",{class:"tick",x:r+(l+.5)*t,y:a+16,"text-anchor":"middle"},l));for(let l of i(n))o.append(v("text",{class:"tick",x:r-7,y:a-
(l+.5)*t,"text-anchor":"end","dominant-baseline":"middle"},l));return o.append(v("text",{class:"label of-evaders",x:r+s*t/2,y:a+36,"text-anchor":"middle"},"evad\
er generation"),v("text",{class:"label of-pursuers",transform:`translate(${r-36} ${e+n*t/2}) rotate(-90)`,"text-anchor":"middle"},"pursuer generation")),o}function zl({
left:r,top:e,cell:t,rows:n,columns:s}){let o=v("g",{class:"diagonal"}),a=Math.min(n,s);if(a<3)return[];let i=e+n*t;for(let c of["H","V"]){let h=`M${r} ${i}`;for(let d=1;d<=
a;d++){let[p,g]=[`H${r+d*t}`,`V${i-d*t}`];h+=c==="H"?p+g:g+p}o.append(v("path",{d:h,class:"under"}),v("path",{d:h}))}let[l,u]=[r+a/2*t-.7*t-4,i-a/2*t-.7*t-4];return[
o,v("text",{class:"on-cells",transform:`translate(${l} ${u}) rotate(-45)`,"text-anchor":"middle"},"same generation")]}var oa=({left:r,top:e,cell:t,rows:n,columns:s},o,a)=>[
r+s*t+le+o*At,e+(n-a-.5)*t],aa=({left:r,top:e,cell:t},n,s)=>[r+(s+.5)*t,e-le-n*Re];function ia(r,e,t){let n=o=>o.map((a,i)=>e(a??0,i).map(l=>l.toFixed(1)).join(
" ")),s=[];return r.low&&r.high&&s.push(v("path",{class:`band ${t}`,d:`M${[...n(r.high),...n(r.low).reverse()].join("L")}Z`})),s.push(v("path",{class:`line ${t}`,
d:`M${n(r.mean).join("L")}`})),s}var la={pursuer:null,evader:null},wr=class extends EventTarget{#e;#r=la;constructor(e){super(),this.#e=e}get selected(){return this.#e}get hover(){return this.#r}select(e){
let t=this.#e,n=["run","pursuer","evader"].some(o=>o in e&&e[o]!==t[o]),s=e.run!==void 0&&e.run!==t.run;this.#e={...t,...n?{episode:0,seed:null}:{},...s?{map:null}:
{},...e},this.#e.run!==t.run&&this.dispatchEvent(new Event("run")),this.dispatchEvent(new Event("match"))}point(e){let t={...la,...e};t.pursuer===this.#r.pursuer&&
t.evader===this.#r.evader||(this.#r=t,this.dispatchEvent(new Event("hover")))}on(e,t){this.addEventListener(e,t)}};var xr=class{config;start;recording;actions=[];#e;#r;#t=[[]];constructor(e,t,n){[this.config,this.start]=[t,n],this.#e=e.world(t),this.#e.reset(n),this.#r=[vn(this.#e)],
this.recording=bn(t,this.#e.map(),this.#r)}get length(){return this.actions.length}get over(){return this.#e.over}get statistics(){return{capture_rate:this.#e.read(
"capture_rate")[0]}}conflicts(e){return this.#t[e]}game(e){return e.game(this.#e)}play(e){this.#e.step(e),this.#n(e)}step(e,t,n){let[s,o]=[this.#e,this.config.n_pursuers],
a=new Uint8Array(s.n_agents);for(let i=s.n_turns;i>0&&!s.over;--i){let[l,u]=s.actors;l<o&&(a=s.decide(e.pursuer,[l,Math.min(u,o)],a)),u>o&&(a=s.decide(e.evader,
[Math.max(l,o),u],a)),typeof n=="number"?a[t]=n:l<=t&&t<u&&(a=s.decide(n,[t,t+1],a)),s.playTurn(a)}this.#n(a)}#n(e){this.actions.push(e),this.#r.push(vn(this.#e,
e)),this.#t.push(this.#e.conflicts())}};var ue=(r,e)=>He[+(e>=r.n_pursuers)];function Mn(r,e){let t=new xr(r,e.config,{seed:e.seed,episode:e.episode});for(let n of e.moves)t.over||t.step(e.policies,e.
seat,n);return t}function Ze(r,e){let{moments:t,nPursuers:n}=r.recording,s=t.findIndex(({alive:a,captured:i})=>!a[e]||!!i[e-n]),o=s<0?r.length:s;return{lasted:o,
out:s>=0,captured:Array.from(t[o].everCaptured).filter(Boolean).length}}var Sr=(r,e)=>r.over||Ze(r,e).out;function ua(r,e,t){let n=Mn(r,{...e,moves:e.moves.slice(
0,e.from)});for(;!Sr(n,e.seat);)n.step(e.policies,e.seat,t);return Ze(n,e.seat)}function ca(r){let e=r.length-1;return[...new Set([0,Math.round(e/3),e])].map(t=>r[t])}
function ha(r,{seat:e,from:t,moves:n}){let s={...r,seat:e,...t?{from:t}:{},moves:n.join("")};return`${location.href.split("#")[0]}#${Object.entries(s).map(([o,a])=>`${o}\
=${a}`).join("&")}`}function da(r,e){let[t,n,s]=[r.get("seat")??"",r.get("from")??"0",r.get("moves")??""];return/^\d{1,6}$/.test(t)&&Number(t)<e.n_pursuers+e.n_evaders&&
(e.diagonal?/^[0-8]+$/:/^[0-4]+$/).test(s)&&s.length<=e.max_steps&&/^\d{1,6}$/.test(n)&&Number(n)<=s.length?{seat:Number(t),from:Number(n),moves:[...s].map(Number)}:
null}function En(r,e,t,n,s,o){e.play({title:t,played:n,ending:(a,i)=>[Bl(r,a,i,ca(s))],again:()=>En(r,e,t,{...n,moves:n.moves.slice(0,n.from)},s,o),link:a=>o&&ha(o,a)})}
function Bl(r,e,t,n){let s=ue(t.config,t.seat)==="evader",o=s?t.config.max_steps:t.config.n_evaders,a=m("table",{class:"numbers"},m("caption",{},s?"Steps in you\
r seat: same start, same others":"Captures of your team: same start, same others")),i=u=>{let[c,h]=[m("span",{class:s?"bar evader":"bar pursuer"}),m("td",{},"…")];
return a.append(m("tr",{},m("th",{scope:"row"},u),m("td",{class:"track","aria-hidden":"true"},c),h)),({lasted:d,captured:p})=>{c.style.width=`${100*(s?d:p)/o}%`,
h.textContent=String(s?d:p)}};i("You")(Ze(e,t.seat));for(let{name:u,policy:c}of n){let h=i(u);setTimeout(()=>h(ua(r,t,c())))}let l=t.from?`You took over at step\
 ${t.from}. `:"";return m("div",{},a,m("p",{class:"small muted"},`${l}One match: luck has its part in it.`))}var ma=["·","↑","→","↓","←","↗","↘","↙","↖"];var jl={" ":0,ArrowUp:1,w:1,ArrowRight:2,d:2,ArrowDown:3,s:3,ArrowLeft:4,a:4,e:5,c:6,y:7,z:7,q:8},Tn=[8,1,5,4,0,2,7,3,6],Hl=[7,8,9,4,5,6,1,2,3],Gl=24,Vl=Math.tan(
Math.PI/8);function fa(r,e){if(r.ctrlKey||r.metaKey||r.altKey)return;let t=Hl.findIndex(s=>r.code===`Numpad${s}`),n=Tn[t]??jl[r.key.length===1?r.key.toLowerCase():
r.key];return n!==void 0&&n>4&&!e?void 0:n}function ya(r){let e=Tn.map(t=>m("button",{type:"button","aria-label":ie[t],onclick:()=>r(t)},ma[t]));return{element:m(
"div",{class:"play-pad",role:"group","aria-label":"Your move"},...e),show:t=>e.forEach((n,s)=>n.classList.toggle("absent",Tn[s]>4&&!t))}}function pa(r,e,t){let n=Vl*
Math.max(Math.abs(r),Math.abs(e)),s=o=>Math.abs(o)<n?0:o;return Hs([0,0],t?[s(r),s(e)]:[r,e],t)}function ga(r,e,t){let n=null,{canvas:s}=r;s.addEventListener("p\
ointerdown",({button:o,clientX:a,clientY:i})=>{n=o===0?[a,i]:null}),s.addEventListener("pointercancel",()=>{n=null}),s.addEventListener("pointerup",({clientX:o,
clientY:a})=>{let[i,l]=[n,e()];if(n=null,!i||!l)return;let[u,c]=[o-i[0],a-i[1]],h=r.cellAt(o,a);Math.hypot(u,c)>=Gl?t(pa(c,u,l.diagonal)):h&&t(pa(h[0]-l.cell[0],
h[1]-l.cell[1],l.diagonal))})}function ba(r,e){let t=n=>{let s=e[n]-r[n],o=Ve.findIndex(a=>a[n]===Math.sign(s)&&a[1-n]===0);return s?`${Math.abs(s)} ${ie[o]}`:""};
return[t(0),t(1)].filter(Boolean).join(", ")||"on your cell"}var xa="NUMPY\0",va=xa.length+2,wa=64;function Mt(r){return Bt(Object.fromEntries(Object.entries(r).map(([e,t])=>[`${e}.npy`,Yl(t)])))}function Yl({dtype:r,shape:e,
data:t}){let n=typeof t=="string"?Array.from(t,c=>c.codePointAt(0)):null,s=e.map(c=>`${c}, `).join(""),o=`{'descr': '${n?`<U${n.length}`:r}', 'fortran_order': F\
alse, 'shape': (${s}), }`,a=Math.ceil((va+o.length+1)/wa)*wa-va,i=xa+String.fromCharCode(a&255,a>>8)+o.padEnd(a-1)+`
`,l=n?Int32Array.from(n):t,u=new Uint8Array(i.length+l.byteLength);return u.set(fe(i,!0)),u.set(new Uint8Array(l.buffer,l.byteOffset,l.byteLength),i.length),u}var ql="matrixworld episode 3";function Sa(r,e,t){let{config:n,actions:s,length:o,recording:a}=e,[i,l]=[n.n_pursuers+n.n_evaders,n.n_evaders],u={positions:["<i4",
i,2],last_positions:["<i4",i,2],alive:["|b1",i],captured:["|b1",l],ever_captured:["|b1",l]},c={rewards:["<f4",i],involved:["|b1",i,3],fault:["|b1",i,3]},h={},d=w=>{
for(let M of Object.keys(w))(h[M]??=[]).push(Array.from(p.read(M),Number))},p=r.world(n);p.reset(e.start);let g=[];d(u);for(let w of s)p.step(w),d({...u,...c}),
g.push(...p.conflictTable());p.free();let f={"<i4":Int32Array,"<f4":Float32Array,"|b1":Uint8Array},y={};for(let[w,[M,..._]]of Object.entries({...u,...c})){let $=o+
+(w in u);y[w]={dtype:M,shape:[$,..._],data:f[M].from((h[w]??[]).flat())}}let b=w=>({dtype:"<i8",shape:[],data:Int32Array.of(w,0)}),x=w=>({dtype:"<U",shape:[],data:w});
return Mt({format:x(ql),n_pursuers:b(n.n_pursuers),config:x(JSON.stringify(n)),seat:b(t),...y,actions:{dtype:"|i1",shape:[o,i],data:Int8Array.from(s.flatMap(w=>[
...w]))},map:{dtype:"|b1",shape:[n.rows,n.cols],data:Uint8Array.from(a.obstacles,Number)},conflict_table:{dtype:"<i4",shape:[g.length/11,11],data:Int32Array.from(
g)}})}var Kl=[0,1,2,4,8],Ar=class{element;player=new Ee(0,{speed:4,still:ge()});#e;#r;#t=m("canvas",{tabindex:0,"aria-describedby":"play-keys"});#n=m("h2");#o=m("p",{
class:"play-told",role:"status"});#s=ya(e=>this.act(e));#c=m("select",{},...Kl.map(e=>m("option",{value:e},e?`${e} / s`:"step by step")));#u=m("input",{type:"ch\
eckbox"});#m=m("input",{type:"checkbox"});#a=m("label",{class:"play-choice"},this.#m,"Best move");#h=m("p",{class:"small muted play-keys",id:"play-keys"});#l=m(
"section",{class:"play-ending",tabindex:-1,"aria-labelledby":"play-headline"});#p=cr(this.player);#f=null;#i=null;#d=[];#g=null;#y=null;#v=[];#w=0;#b=0;constructor(e){
this.#e=e,this.#r=new Me(this.#t,{numbers:!1}),this.#t.setAttribute("role","application"),this.#c.addEventListener("change",()=>this.#M()),this.#u.addEventListener(
"change",()=>this.#x()),this.#m.addEventListener("change",()=>this.#O()),ga(this.#r,()=>{let t=this.#g!==null&&this.#i&&k(this.#i.recording.moments.at(-1),this.#g);
return t?{cell:t,diagonal:this.#i.config.diagonal}:null},t=>this.act(t)),this.player.addEventListener("frame",()=>this.#i&&this.#r.show(this.#i.recording,this.player.
time)),this.player.addEventListener("step",()=>this.#O()),this.element=m("div",{class:"play"},m("header",{class:"play-head"},this.#n,this.#o),m("div",{class:"pl\
ay-stage"},this.#t),m("div",{class:"play-side"},this.#l,this.#s.element,m("label",{class:"play-choice",title:"Steps a second"},"Pace ",this.#c),m("label",{class:"\
play-choice"},this.#u,m("span",{},"Fog",m("span",{class:"at-length"},": see only what it sees"))),this.#a,this.#h),this.#p)}get played(){return this.#f&&{...this.#f.
played,moves:this.#d}}get live(){return this.#i}play(e){this.#S(Mn(this.#e,e.played),e.played.seat,e.title),[this.#f,this.#d,this.#w]=[e,[...e.played.moves],0],
this.element.dataset.state="playing",this.#t.focus({preventScroll:!0}),Sr(this.#i,e.played.seat)&&this.#_()}watch(e,t,n){this.#f=null,this.#S(e,t,n),this.#R()}stop(){
this.#M(),this.player.pause(),this.#f=null}act(e){let[t,n]=[this.#f,this.#i];if(!t||!n||this.element.dataset.state!=="playing")return;this.#w=e;let s=Number(this.#c.
value);this.#b||(this.#E(),s&&this.element.dataset.state==="playing"&&(this.#b=setInterval(()=>this.#E(),1e3/s)))}key(e){let{target:t,key:n}=e;if(t instanceof HTMLSelectElement||
t instanceof HTMLInputElement&&(t.type==="text"||n===" ")||t instanceof HTMLButtonElement&&(n===" "||n==="Enter")||!this.#i)return!1;if(this.element.dataset.state!==
"playing")return ur(this.player,e);let o=fa(e,this.#i.config.diagonal);return o!==void 0&&this.act(o),o!==void 0}#S(e,t,n){this.#M(),this.player.pause(),[this.#i,
this.#g]=[e,t],this.#n.textContent=n,this.#t.ariaLabel=`Board, ${e.config.rows} by ${e.config.cols} cells`,this.#s.show(e.config.diagonal),this.#h.replaceChildren(
m("span",{class:"at-length"},`W A S D or the arrow keys move, Space stays${e.config.diagonal?"; Q E Z C and the numeric keypad move diagonally":""}. `),"On the \
board: swipe, or tap where to go."),this.#A(e),this.#l.replaceChildren(),this.player.length=e.length,this.player.jump(e.length),this.#O()}#x(){this.#r.look={you:this.#g,
fog:this.#u.checked,viewers:this.#g===null?[]:[this.#g],plan:this.#k()}}#A(e){this.#y=null,this.#v=this.player.ticks=[],this.#a.hidden=this.#m.disabled=!!je(e.config),
Je(this.#e,e.config,Ho(e.config)).then(t=>{this.#i===e&&(this.#y=t,this.#T(),this.#O())})}#T(){let[e,t]=[this.#i,this.#y];if(!t||this.element.dataset.state==="p\
laying")return;let n=this.#e.world(e.config);n.reset(e.start),this.#v=mr(t,n,e.actions),n.free(),this.player.ticks=pr(this.#v)}get#C(){return this.#m.checked&&this.#f&&
this.element.dataset.state==="playing"&&this.#y&&this.#i.game(this.#y)||null}#k(){let[e,t]=[this.#g,this.#g!==null&&this.#C?.marginal(this.#g)];return e!==null&&
t?Object.assign(Array(e).fill(0),{[e]:t.indexOf(Math.max(...t))}):null}#M(){clearInterval(this.#b),this.#b=0,this.#o.ariaLive=Number(this.#c.value)?"off":"polit\
e"}#E(){let[{policies:e,seat:t},n]=[this.#f.played,this.#i];n.step(e,t,this.#w),this.#d.push(this.#w),this.player.length=n.length,this.player.glide=Math.min(.22,
.9/(Number(this.#c.value)||4)),this.player.move(n.length-this.player.step),Sr(n,t)&&this.#_()}#_(){this.#M();let[e,t,n]=[this.#f,this.#i,this.played],s=Ut()?e.link(
n):null;this.#l.replaceChildren(m("h3",{id:"play-headline"},Xl(t,n.seat)),...e.ending(t,n),m("div",{class:"play-buttons"},m("button",{type:"button",class:"prima\
ry",onclick:()=>e.again()},"Again"),m("button",{type:"button",onclick:()=>this.#R()},"Watch it"),m("button",{type:"button",onclick:()=>this.#P(t,n.seat)},"Save"),
s&&m("button",{type:"button",onclick:({currentTarget:a})=>eu(a,s)},"Link"))),this.element.dataset.state="ended",this.#T();let o=this.#v.filter(({team:a})=>a===ue(
t.config,n.seat));o.length&&this.#l.children[0].after(m("p",{class:"small muted"},Vo(o))),this.#l.focus({preventScroll:!0}),this.#l.scrollIntoView({block:"neare\
st"})}#R(){this.element.dataset.state="watched",this.player.length=this.#i.length,this.player.jump(0),ge()||this.player.play()}#P(e,t){let n=new Blob([Sa(this.#e,
e,t)],{type:"application/octet-stream"});m("a",{href:URL.createObjectURL(n),download:`${H(t,e.config.n_pursuers)}-${e.length}-steps.npz`}).click()}#O(){let[e,t,
{step:n}]=[this.#i,this.#g,this.player];if(!e||n>e.length)return;let s=fr(e,e.recording,n).filter(({agents:l})=>t===null||l.includes(t)),o=this.#f&&n===0,a=o?[Jl(
e.config,t),this.#f.about??""]:[`Step ${n} of ${e.config.max_steps}`,...s.map(({text:l})=>l)];!o&&t!==null&&a.push(Zl(e,n,t)),a.push(...this.#v.filter(l=>l.step===
n).map(xt));let i=n===e.length&&t!==null?this.#C:null;i&&a.push(`Perfect play: ${qo(i,t)||"decided in its turn"}; ${Yo(this.#y,i,n)}`),this.#x(),this.#o.textContent=
a.filter(Boolean).map(l=>`${l}.`).join(" ")}};function Jl(r,e){let t=r.rules.capture==="SURROUND";return ue(r,e)==="evader"?`Run away: you win if ${t?"the pursu\
ers do not surround you":"no pursuer reaches your cell"} in ${r.max_steps} steps`:`Capture evaders: ${t?"surround them with your team":"move onto their cells"}`}
function Zl({config:r,recording:e},t,n){let s=e.moments[t],a=ue(r,n)==="pursuer"?"evader":"pursuer";if(!s.alive[n])return"";let i=k(s,n),l=h=>{let[d,p]=k(s,h);return Math.
max(Math.abs(d-i[0]),Math.abs(p-i[1]))},u=Array.from({length:s.alive.length},(h,d)=>d).filter(h=>ue(r,h)===a&&s.alive[h]&&!s.captured[h-r.n_pursuers]&&2*l(h)<r.
fov);if(!u.length)return`No ${a} in view`;let c=u.reduce((h,d)=>l(d)<l(h)?d:h);return`Nearest ${a}: ${ba(i,k(s,c))}`}function Xl(r,e){let[{lasted:t,out:n,captured:s},
{config:o}]=[Ze(r,e),r];return ue(o,e)==="pursuer"?`Your team captured ${s} of ${Ql(o)} in ${t} steps.`:n?`You lasted ${t} of ${o.max_steps} steps.`:`You escape\
d: ${t} steps.`}var Ql=({n_evaders:r})=>`${r} evader${r===1?"":"s"}`;function eu(r,e){let t=m("input",{type:"text",readonly:!0,value:e,"aria-label":"Link to thi\
s match"});r.replaceWith(t),t.select(),navigator.clipboard?.writeText(e).catch(()=>{})}var tu=2n**64n-1n;function Aa(r,e,t){let n=new URLSearchParams(r.replace(/^#/,"")),s=(u,c,h)=>{let d=n.get(u)??"";return/^\d{1,9}$/.test(d)&&Number(d)<c?Number(
d):h},o=s("run",e.length,t.run),[a,i]=e[o].payoff.shape,l=n.get("seed")??"";return{run:o,pursuer:s("pursuers",a,Math.min(t.pursuer,a-1)),evader:s("evaders",i,Math.
min(t.evader,i-1)),episode:s("episode",1/0,t.episode),seed:/^\d{1,20}$/.test(l)&&BigInt(l)<=tu?l:null,map:ru(s("map",e[o].maps?.walls.length??0,-1)),step:s("ste\
p",1/0,0)}}var ru=r=>r<0?null:r;var Mr=class{dialog=m("dialog",{class:"take-over","aria-label":"Play an agent"});view=null;#e;#r;#t;#n;#o=null;constructor(e,t,n,s=!0){[this.#e,this.#r,this.#t,
this.#n]=[e,t,n,s],n.element.addEventListener("takeover",()=>this.open()),this.dialog.addEventListener("keydown",o=>this.view?.key(o)&&o.preventDefault()),this.
dialog.addEventListener("close",()=>this.view?.stop())}start(e,t=""){this.#o=e;let n=Aa(t,this.#e,this.#r.selected),s=da(new URLSearchParams(t.replace(/^#/,"")),
this.#e[n.run].world);s&&this.play(n,s)}open(){let e=this.#t.shown;if(!e)return;let{match:t,step:n}=e;this.#t.player.pause();let s=this.#t.inspector.agent,o=n<t.
length?n:0,a=(h,d)=>!!t.alive[d*t.n_agents+h],i=Array.from({length:t.n_agents},(h,d)=>(d+t.config.n_pursuers)%t.n_agents),l=s??i.find(h=>a(h,o)),u=a(l,o)?o:0,c=Array.
from({length:u},(h,d)=>t.actions[d*t.n_agents+l]);this.play(this.#r.selected,{seat:l,from:u,moves:c})}play(e,t){let[n,s]=[this.#o,this.#e[e.run]];if(!n||He.some(
b=>Ht(s,b,e[b])))return;let{run:o,pursuer:a,evader:i,episode:l,seed:u,map:c}=e,h=ue(s.world,t.seat),d=s.teams[h].kept.map(b=>({name:s.teams[h].script??`generati\
on ${b}`,text:"",policy:()=>Z(s,h,b)}));this.view||(this.view=new Ar(n),this.dialog.append(m("button",{type:"button",class:"leave",onclick:()=>this.dialog.close()},
"Close"),this.view.element)),this.dialog.open||this.dialog.showModal();let p=`You are ${H(t.seat,s.world.n_pursuers)}: ${this.#t.names(e).join(" against ")}`,g={
pursuer:Z(s,"pursuer",a),evader:Z(s,"evader",i)},f={config:jt(s,c),seed:BigInt(u??s.seeds[a][i]),episode:l,policies:g,...t},y={run:o,pursuers:a,evaders:i,episode:l,
...u===null?{}:{seed:u},...c===null?{}:{map:c}};En(n,this.view,p,f,d,this.#n?y:null)}};var nu=8,su=700,Ma=1400,Et=class{element;player=new Ee(0,{speed:nu,still:ge()});title=m("figcaption");generation=0;#e=m("canvas");#r;#t=m("p",{class:"small mute\
d numbers"});#n=m("p",{class:"small",role:"status"});#o;#s=null;#c=0;#u=0;#m=!ge();constructor(e){this.#o=e,this.#r=new Me(this.#e,{numbers:!1}),this.element=m(
"figure",{class:"chase"},this.title,this.#e,this.#t,this.#n),this.player.addEventListener("frame",()=>this.#l()),this.player.addEventListener("step",()=>this.#p()),
this.player.addEventListener("state",()=>{this.#m&&!this.player.playing&&this.player.length&&this.player.step===this.player.length&&this.#a()})}set label(e){this.#e.
ariaLabel=e}get runs(){return this.#m}set runs(e){this.#m=e,clearTimeout(this.#u),e?this.player.play():this.player.pause()}renew(e=!1){e||!this.#s||performance.
now()-this.#c>Ma?this.#h():this.#a(Ma)}#a(e=su){clearTimeout(this.#u),this.#u=setTimeout(()=>this.#h(),e)}#h(){clearTimeout(this.#u);let e=this.#o();e&&(this.#s=
ar(e),this.#c=performance.now(),this.player.jump(0),this.player.length=e.length,this.player.marks=tr(this.#s),this.#p(),this.#m&&this.player.play())}#l(){this.#s&&
this.#r.show(this.#s,this.player.time)}#p(){let e=this.#s?.moments[this.player.step]?.everCaptured;e&&(this.#t.textContent=`generation ${this.generation} · ${Array.
from(e).filter(Boolean).length} of ${e.length} caught · step ${this.player.step}`)}drawWalls(e){let t=!1,n=!0,s=[0,0],o=([l,u])=>!!this.#s?.obstacles[l*this.#s.
cols+u],a=(l,u)=>{this.#n.textContent=e(l,u)},i=l=>{let u=this.#r.cellAt(l.clientX,l.clientY);u&&o(u)!==n&&a(u,n)};return this.#e.addEventListener("pointerdown",
l=>{let u=t&&this.#r.cellAt(l.clientX,l.clientY);u&&(this.#e.setPointerCapture(l.pointerId),n=!o(u),i(l))}),this.#e.addEventListener("pointermove",l=>t&&l.buttons&&
i(l)),this.#e.addEventListener("keydown",l=>{let u={ArrowUp:[-1,0],ArrowDown:[1,0],ArrowLeft:[0,-1],ArrowRight:[0,1]}[l.key];if(!t||!this.#s||!(u||l.key===" "))
return;l.preventDefault();let c=(p,g)=>Math.min(g-1,Math.max(0,p)),{rows:h,cols:d}=this.#s;u?s=[c(s[0]+u[0],h),c(s[1]+u[1],d)]:a(s,!o(s)),this.#r.look={cursor:s}}),
{active:l=>{t=l,this.#e.classList.toggle("drawn-on",l),this.#e.tabIndex=l?0:-1,this.#e.setAttribute("role",l?"application":"img"),this.#r.look={cursor:null}}}}show(e){
this.#s&&(this.#s={...this.#s,obstacles:e},this.#l())}};var Ea=-12676506002282294e14,Ta=({hidden:r,mask:e})=>r.map(t=>t+(e?4:0));function Tt(r){let e=[3*r.fov**2,...Ta(r),5],t=0;return e.slice(1).map((n,s)=>{let o={at:t,
inputs:e[s],outputs:n};return t+=(o.inputs+1)*n,o})}function Xe(r){let{at:e,inputs:t,outputs:n}=Tt(r).at(-1);return e+(t+1)*n}var Ct=(r,e)=>({hidden:Ta(r),activation:"\
relu",sampled:!0,memory:"none",genome:e});function Ca(r,e,t,n){let s=new Float32Array(Xe(r)),o=Tt(r);return o.forEach(({at:a,inputs:i,outputs:l},u)=>{let c=Math.
fround(u===o.length-1?n:t);e.normals(i*l).forEach((h,d)=>s[a+d]=c*h)}),s}function Cn(r){let{fov:e,mask:t}=r;if(!t)return null;let[n,s]=[new Uint8Array(Xe(r)),new Float32Array(
Xe(r))],o=Tt(r),a=o.length-1,i=Math.floor(e/2);return o.forEach(({at:l,inputs:u,outputs:c},h)=>{let d=(p,g)=>l+p*c+g;for(let p=0;p<4;p++)if(h>0&&n.fill(1,d(u-4+
p,0),d(u-4+p+1,0)),h<a)for(let g=0;g<=u;g++)n[d(g,c-4+p)]=1;t.forEach((p,g)=>{let f=h===a?1+g:c-4+g,y=h===0?p.map(([b,x,w])=>(b*e+i+x)*e+i+w):[u-4+g];for(let b of y)
n[d(b,f)]=1,s[d(b,f)]=h===a?Ea:1})}),{fixed:n,values:s}}function kn(r,e){return e?r.map((t,n)=>e.fixed[n]?e.values[n]:t):r}function ka(r,e,t){let n=new Float32Array(
Xe(t)),[s,o]=[Tt(e),Tt(t)],a=Math.floor(t.fov/2)-Math.floor(e.fov/2),i=u=>u>=0&&u<t.fov,l=u=>{let[c,h,d]=[Math.floor(u/e.fov**2),Math.floor(u/e.fov)%e.fov+a,u%e.
fov+a];return i(h)&&i(d)?(c*t.fov+h)*t.fov+d:-1};return s.forEach((u,c)=>{let h=o[c],d=e.hidden[c]??5;for(let p=0;p<(c?e.hidden[c-1]:u.inputs);p++){let g=c?p:l(
p);if(!(g<0))for(let f=0;f<d;f++)n[h.at+g*h.outputs+f]=r[u.at+p*u.outputs+f]}for(let p=0;p<d;p++)n[h.at+h.inputs*h.outputs+p]=r[u.at+u.inputs*u.outputs+p]}),kn(
n.map(u=>u<=Ea/2?0:u),Cn(t))}var Pa={initial:1,noise:2,learn:3,opponents:4},On={pursuer:1,evader:2,both:3},Pe=4,_n=2n**32n;function _a(r){let e=[],t=BigInt(r);do e.push(Number(t%_n)),t/=_n;while(t>
0n);return e}function Oa(r,e){let t=r;return n=>{let s=n^t;return t=Math.imul(t,e),s=Math.imul(s,t),s^s>>>16}}function Ra(r,e){let t=Math.imul(3389127133,r)-Math.
imul(1232336661,e)|0;return t^t>>>16}function Rn(r,e,t){let n=r.flatMap(_a);if(e.length){for(;n.length<Pe;)n.push(0);n.push(...e.flatMap(_a))}let s=Oa(1135663077,
2468251765),o=Array.from({length:Pe},(i,l)=>s(n[l]??0));for(let i=0;i<Pe;i++)for(let l=0;l<Pe;l++)i!==l&&(o[l]=Ra(o[l],s(o[i])));for(let i of n.slice(Pe))for(let l=0;l<
Pe;l++)o[l]=Ra(o[l],s(i));let a=Oa(2337405405,1492356589);return Uint32Array.from({length:t},(i,l)=>a(o[l%Pe]))}function kt(r,e){let t=Rn(r,[],2*e);return BigUint64Array.
from({length:e},(n,s)=>BigInt(t[2*s])+_n*BigInt(t[2*s+1]))}var Er=(r,e,t)=>kt([r,e,t],1)[0];var La=r=>(e,...t)=>new Pn(Rn([r],[Pa[e],...t],3)),Pn=class{#e;#r;#t;#n=1;constructor(e){[this.#e,this.#r,this.#t]=[e[0],e[1],e[2]];for(let t=0;t<12;t++)this.#o()}#o(){
let e=this.#e+this.#r+this.#n++|0;return this.#e=this.#r^this.#r>>>9,this.#r=this.#t+(this.#t<<3)|0,this.#t=(this.#t<<21|this.#t>>>11)+e|0,e>>>0}#s(){return(this.#o()+
.5)/2**32}normals(e){let t=new Float32Array(e);for(let n=0;n<e;n+=2){let[s,o]=[Math.sqrt(-2*Math.log(this.#s())),2*Math.PI*this.#s()];t[n]=s*Math.cos(o),n+1<e&&
(t[n+1]=s*Math.sin(o))}return t}integers(e,t){return Int32Array.from({length:t},()=>Math.floor(this.#s()*e))}permutation(e){return this.choice(e,e)}choice(e,t){
let n=Int32Array.from({length:e},(s,o)=>o);for(let s=0;s<t;s++){let o=s+Math.floor(this.#s()*(e-s));[n[s],n[o]]=[n[o],n[s]]}return n.slice(0,t)}};var T=Math.fround,ou=5,au=256,Tr=class{size;sigma;fixed;#e;constructor(e,t,n,s){[this.size,this.sigma,this.fixed]=[e,n,s],this.#e=t.normals((1+au)*e);for(let o=0;o<
this.#e.length;o++)this.#e[o]*=T(n)}draw(e,t){let n=t.integers(this.#e.length-this.size+1,e);return Array.from(n,s=>{let o=this.#e.subarray(s,s+this.size);return this.
fixed?o.map((a,i)=>this.fixed[i]?0:a):o})}},Ln=class{#e;#r;#t=0;constructor(e){[this.#e,this.#r]=[new Float32Array(e),new Float32Array(e)]}moved(e,t,n){let[s,o,
a]=[.9,.999,T(1e-8)];this.#t+=1;let[i,l]=[T(1-s),T(1-o)],[u,c]=[T(1-s**this.#t),T(1-o**this.#t)];return e.map((h,d)=>{let p=t[d],g=this.#e[d]+=T(i*T(p-this.#e[d])),
f=this.#r[d]+=T(l*T(T(p*p)-this.#r[d])),y=T(T(Math.sqrt(T(T(f)/c)))+a);return T(h+T(T(T(n)*T(T(g)/u))/y))})}};function iu(r){let e=Array.from(r).sort((t,n)=>t-n);
return r.map(t=>(e.indexOf(t)+e.lastIndexOf(t))/(2*(r.length-1))-.5)}var Cr=class{genome;groups;#e;#r;#t;#n=[];constructor(e,t,n){[this.genome,this.#r,this.#e,this.#t]=
[e,t,n,new Ln(e.length)],this.groups=Int32Array.from({length:n.population},(s,o)=>o%(n.population/2))}get#o(){let{sigma:e,fixed:t}=this.#r,[n,s]=[0,0];return this.
genome.forEach((o,a)=>{t?.[a]||(n+=o*o,s+=1)}),Math.max(e,this.#e.relative_sigma*Math.sqrt(n/s))}ask(e){let[t,n]=[this.#e.population/2,this.genome.length];this.#n=
this.#r.draw(t,e);let s=T(this.#o/this.#r.sigma),o=new Float32Array(2*t*n);return this.#n.forEach((a,i)=>{for(let l=0;l<n;l++){let u=T(s*a[l]);o[i*n+l]=this.genome[l]+
u,o[(t+i)*n+l]=this.genome[l]-u}}),o}tell(e){let[t,n]=[iu(e),this.#n.length],s=new Float32Array(this.genome.length);this.#n.forEach((o,a)=>{let i=T((t[a]-t[n+a])/
(2*n*this.#r.sigma**2));for(let l=0;l<s.length;l++)s[l]+=T(i*o[l])}),this.genome=this.#t.moved(this.genome,s,this.#e.learning_rate)}},_t=class{population;groups;#e;#r;#t=new Float64Array(
0);#n=0;constructor(e,t,n){[this.population,this.#r,this.#e]=[e,t,n],this.groups=new Int32Array(n.population)}get genome(){return this.#o(this.#n).slice()}#o(e){
let{size:t}=this.#r;return this.population.subarray(e*t,(e+1)*t)}#s(e,t){let n=this.#e.tournament??ou,s=t.integers(this.#t.length,e*n);return Array.from({length:e},
(o,a)=>s.subarray(a*n,(a+1)*n).reduce((i,l)=>this.#t[l]>this.#t[i]?l:i))}ask(e){if(!this.#t.length)return this.population;let{size:t}=this.#r,{population:n,elites:s}=this.#e,
o=n-s,a=this.#s(o,e);this.#s(o,e);let i=Array.from(this.#t.keys()).sort((u,c)=>this.#t[c]-this.#t[u]).slice(0,s),l=new Float32Array(this.population.length);return[
...i,...a].forEach((u,c)=>l.set(this.#o(u),c*t)),this.#r.draw(o,e).forEach((u,c)=>{let h=(s+c)*t;for(let d=0;d<t;d++)l[h+d]+=u[d]}),this.population=l,l}tell(e){
this.#t=e,this.#n=e.indexOf(Math.max(...e))}};function $a(r,e,t,n){let[s,o]=[r.length,Math.max(...r)+1],a=o>1?s/o:1,i=Array.from(r.keys()).sort((h,d)=>r[h]-r[d]),l=[],u=[];for(let h=0;h<e;h++){let d=h%a;d===
0&&(u=Array.from(n.permutation(s/a)).flatMap(p=>i.slice(p*a,(p+1)*a))),l.push([i,u.map((p,g)=>u[g-g%a+(g%a-d+a)%a])])}let c=h=>i.map(()=>s+h);for(let h=0;h<t[1];h++)
l.push([i,c(h)]);for(let h=0;h<t[0];h++)l.push([c(h),i]);return{pursuer:Int32Array.from(l.flatMap(([h])=>h)),evader:Int32Array.from(l.flatMap(([,h])=>h)),group:Int32Array.
from(l.flatMap((h,d)=>i.map(p=>d*o+r[p])))}}function Na(r,e,t,n){let s=Math.max(...e)+1,[o,a]=[new Float64Array(t*s),new Float64Array(t*s)];n.forEach((l,u)=>{if(r[u]>=
t)return;let c=r[u]*s+e[u];o[c]+=l,a[c]+=1});let i=o.map((l,u)=>a[u]?l/a[u]:0);return Float64Array.from({length:t},(l,u)=>{let c=i.subarray(u*s,(u+1)*s);return $n(
c)/a.subarray(u*s,(u+1)*s).filter(Boolean).length})}var lu=128,Qe=8;function $n(r){let{length:e}=r;if(e>lu){let d=Math.floor(e/2)-Math.floor(e/2)%Qe;return $n(r.
subarray(0,d))+$n(r.subarray(d))}if(e<Qe)return r.reduce((d,p)=>d+p,0);let t=r.slice(0,Qe),n=e-e%Qe;for(let d=Qe;d<n;d++)t[d%Qe]+=r[d];let[s,o,a,i,l,u,c,h]=t;return r.
subarray(n).reduce((d,p)=>d+p,s+o+(a+i)+(l+u+(c+h)))}var C=["pursuer","evader"],Le=r=>r==="pursuer"?"evader":"pursuer";var Ia=({world:r,fitness:e})=>e.overlap_penalty??(r.rules.teammate==="REACH"?.2:0);var _r={pursuer:["random","clumsy-fleer"],evader:["random","clumsy-chaser"]},uu=20,cu=8,hu=-1,$e=r=>Array.from(r).reduce((e,t)=>e+t,0)/r.length,Or=({world:r,policy:e},t,n)=>({
fov:r.fov,hidden:e.hidden,mask:e.mask==="none"?null:t[n]}),et=class{settings;archive={pursuer:[],evader:[]};rows=[];cells=new Map;counters=[];#e;#r;#t;#n={};#o=new Set;#s=0;#c=0;#u=0;constructor(e,t,n,s=La(
t.seed)){[this.#e,this.settings,this.#r,this.#t]=[e,t,n,s];for(let o of C){let{initial_weight:a,initial_head:i}=t.policy,l=s("initial",C.indexOf(o)),u=t.learner.
kind==="ga"?t.learner.population:1,c=Array.from({length:u},()=>Ca(this.shape(o),l,a,i));this.#a(o,c),this.archive[o].push(this.#n[o].genome)}this.#b()}shape(e){
return Or(this.settings,this.#r,e)}get finished(){return Math.min(this.archive.pursuer.length,this.archive.evader.length)}*run(){yield*this.#S(0);for(let e=1;e<=
this.settings.schedule.generations;e++){if(this.settings.schedule.kind==="alternating")for(let t of C)yield*this.#h(t,e);else yield*this.#l(e);this.#b(),yield*this.#S(
e)}}change(e){let t=this.settings,n={pursuer:this.shape("pursuer"),evader:this.shape("evader")},s=l=>JSON.stringify(l(t))===JSON.stringify(l(e));this.settings=e;
let o=s(l=>[l.world.fov,l.policy]);if(!o||!s(l=>l.learner))for(let l of C){let u=c=>ka(c,n[l],this.shape(l));this.archive[l]=this.archive[l].map(u),this.#a(l,this.#m(
l).map(u))}if(o&&s(l=>l.world))return null;this.cells.clear(),this.#o.clear();let{pursuer:a,evader:i}=this.archive;return{type:"anew",settings:e,genomes:{pursuer:a.
slice(0,this.finished),evader:i.slice(0,this.finished)}}}#m(e){let t=this.#n[e];if(!(t instanceof _t))return[t.genome];let n=t.genome.length,s=Array.from({length:t.
population.length/n},(o,a)=>t.population.slice(a*n,(a+1)*n));return Array.from({length:this.settings.learner.population},(o,a)=>a===0?t.genome:s[a%s.length])}#a(e,t){
let{learner:n}=this.settings,[s,o]=[this.shape(e),n.kind==="ga"?n.mutation:n.sigma],a=Cn(s),i=new Tr(Xe(s),this.#t("noise",C.indexOf(e)),o,a?.fixed??null),l=t.map(
u=>kn(u,a));this.#n[e]=n.kind==="ga"?new _t(kr(l),i,n):new Cr(l[0],i,n)}*#h(e,t){for(let n=0;n<this.#i(e);n++){let s=this.archive[Le(e)].length,o=this.settings.
schedule[`${e}s_meet`].rule,a=o==="latest"?s-1:o==="round-robin"?n%s:this.#t("opponents",C.indexOf(e),t,n).choice(s,1)[0],i=e==="pursuer"?[t,a]:[a,t],l=this.#n[e],
{groups:u}=l,c=kt([this.settings.seed,...i,On[e],n],Math.max(...u)+1),h=l.ask(this.#t("learn",C.indexOf(e),t,n)),[d,p]=[Int32Array.from(u.keys()),new Int32Array(
u.length)],g={[e]:h,[Le(e)]:this.archive[Le(e)][a]},f={[e]:d,[Le(e)]:p},y=this.#g(g,f,BigUint64Array.from(u,x=>c[x])),b=this.#v(y,e);this.#w(y,b,{generation:t,team:e,
epoch:n,opponent:a}),l.tell(b),yield*this.#d(t,n,e)}this.archive[e].push(this.#n[e].genome)}*#l(e){for(let t=0;t<this.#i("pursuer");t++){let{schedule:n,learner:{
population:s}}=this.settings,[o,a]=n.kind==="hall-of-fame"?[n.hall_sample,n.contemporaries]:[0,1],i={pursuer:this.#p("pursuer",e,t),evader:this.#p("evader",e,t)},
l=this.#t("opponents",0,e,t),u={pursuer:this.#f(o,l),evader:this.#f(o,l)},c=y=>kr([i[y],...Array.from(u[Le(y)],b=>this.archive[y][b])]),h=[u.evader.length,u.pursuer.
length],d=$a(this.#n.pursuer.groups,a,h,l),p=kt([this.settings.seed,e,e,On.both,t],Math.max(...d.group)+1),g={pursuer:c("pursuer"),evader:c("evader")},f=this.#g(
g,d,BigUint64Array.from(d.group,y=>p[y]));for(let y of C){let b=Na(d[y],d[Le(y)],s,this.#v(f,y));this.#w(f,b,{generation:e,team:y,epoch:t,opponent:hu}),this.#n[y].
tell(b)}yield*this.#d(e,t,"both")}for(let t of C)this.archive[t].push(this.#n[t].genome)}#p(e,t,n){return this.#n[e].ask(this.#t("learn",C.indexOf(e),t,n))}#f(e,t){
let n=this.archive.pursuer.length;return e?t.choice(n,Math.min(e,n)):new Int32Array(0)}#i(e){let{schedule:t}=this.settings;return t.kind==="hall-of-fame"?t.joint_epochs:
t[`${e}_epochs`]}*#d(e,t,n){let[s,o]=this.settings.schedule.kind==="hall-of-fame"?[this.#i("pursuer"),0]:[this.#i("pursuer"),this.#i("evader")],a=t+1+(n==="evad\
er"?s:0),i=s+o;yield{type:"epoch",done:(e-1)*i+a,of:this.settings.schedule.generations*i},yield*this.catchUp()}#g(e,t,n){let s={...this.settings.world,max_steps:this.
settings.train_steps},o=this.#e.rollouts(s,this.#y("pursuer",e.pursuer),this.#y("evader",e.evader),{...t,seed:n},1);this.#s+=o.length.length;for(let a of o.length)
this.#c+=Number(a);for(let a of o.agent_steps)this.#u+=Number(a);return o}#y(e,t){return Ct(this.shape(e),t)}#v({captured_fraction:e,overlap:t},n){let s=Ia(this.
settings);return Float64Array.from(e,(o,a)=>n==="pursuer"?o:1-o-s*Number(t[2*a+1]))}#w(e,t,n){let s=$e(t),o=[0,0];e.faults.forEach((a,i)=>o[Math.floor(i/3)%2]+=
Number(a)),this.rows.push({...n,fitness_mean:s,fitness_std:Math.sqrt($e(t.map(a=>(a-s)**2))),fitness_best:Math.max(...t),capture_rate:$e(e.capture_rate),length:$e(
e.length),pursuer_faults:o[0]/e.length.length,evader_faults:o[1]/e.length.length,matches:this.#s,steps:this.#c})}#b(){this.counters.push({matches:this.#s,steps:this.#c,
agent_steps:this.#u})}*#S(e){yield{type:"generation",number:e,genomes:{pursuer:this.archive.pursuer[e],evader:this.archive.evader[e]}},yield*this.catchUp()}*catchUp(){
for(let e=this.finished-1;e>=0;e--){for(let t=e;t>=0;t--)for(let[n,s]of t===e?[[e,e]]:[[e,t],[t,e]]){if(this.cells.has(`${n} ${s}`))continue;let o=this.#x(n,s);
this.cells.set(`${n} ${s}`,o),yield{type:"cell",cell:o}}this.#o.has(e)||(this.#o.add(e),yield{type:"scores",number:e,scores:{pursuer:this.#A("pursuer",e),evader:this.#A(
"evader",e)}})}}#x(e,t){let{world:n,evaluation_episodes:s,seed:o}=this.settings,a={pursuer:new Int32Array(1),evader:new Int32Array(1),seed:BigUint64Array.of(Er(
o,e,t))},i=C.map(c=>this.#y(c,this.archive[c][c==="pursuer"?e:t])),l=this.#e.rollouts(n,...i,a,s),u=c=>{let h=Array.from(l[c],Number),d=h.length/s;return Array.
from({length:d},(p,g)=>$e(h.filter((f,y)=>y%d===g)))};return{pursuer:e,evader:t,capture_rates:Array.from(l.capture_rate),lengths:Array.from(l.length),means:{collisions:u(
"collisions"),faults:u("faults"),agent_steps:u("agent_steps"),survivors:u("survivors")}}}#A(e,t){let{world:n,seed:s}=this.settings,[o,a]=[this.#y(e,this.archive[e][t]),
new Int32Array(1)];return $e(_r[e].map((i,l)=>{let u=kt([s,C.indexOf(e),l,cu],1),c=e==="pursuer"?[o,i]:[i,o],h=$e(this.#e.rollouts(n,...c,{pursuer:a,evader:a,seed:u},
uu).capture_rate);return e==="pursuer"?h:1-h}))}};function kr(r){let e=new Float32Array(r.reduce((n,{length:s})=>n+s,0)),t=0;for(let n of r)e.set(n,t),t+=n.length;
return e}var Nn=r=>Array.from({length:r},()=>Array(r)),In=r=>r.length?r.reduce((e,t)=>e+t,0)/r.length:null,Rr=class{learning=C;settings=[];training={capture_rate:[],generation:[],
learner:[],epochs:1,window:1,matches:0};maps=null;limits="";name;schedule;seed;seeds;world;payoff;teams;findings=null;genomes={pursuer:[],evader:[]};#e;#r;#t;constructor(e,t,n,s){
[this.#t,this.#e,this.#r,this.name,this.schedule]=[e,t,s,n,n],[this.world,this.seed]=[e.world,String(e.seed)];let o=e.schedule.generations+1;this.seeds=Array.from(
{length:o},(a,i)=>Array.from({length:o},(l,u)=>String(Er(e.seed,i,u)))),this.payoff=this.#n(),this.teams=this.#o()}get newest(){return this.genomes.pursuer.length-
1}#n(){let e=this.#t.schedule.generations+1;return{first:[0,0],shape:[e,e],episodes:this.#t.evaluation_episodes,capture_rate:Nn(e),capture_rates:Nn(e),lengths:Nn(
e)}}#o(){let e=t=>{let n=`${this.#r} ${t}`;Rs(n,kr(this.genomes[t]));let{genome:s,...o}=Ct(Or(this.#t,this.#e,t),this.genomes[t][0]??new Float32Array(0));return{
script:null,network:{...o,genome_size:s.length},kept:[...this.genomes[t].keys()],genomes:n}};return{pursuer:e("pursuer"),evader:e("evader")}}policy(e,t){return Ct(
Or(this.#t,this.#e,e),this.genomes[e][t])}add(e){for(let t of C)this.genomes[t].push(e[t]);this.teams=this.#o()}change(e,t){this.#t=e,this.world=e.world;for(let n of C)
this.genomes[n]=[...t[n]];[this.payoff,this.teams,this.findings]=[this.#n(),this.#o(),null]}addCell({pursuer:e,evader:t,capture_rates:n,lengths:s}){this.payoff.
capture_rate[e][t]=In(n),this.payoff.capture_rates[e][t]=[...n],this.payoff.lengths[e][t]=[...s],this.findings={generalization:this.#s()}}#s(){let e=this.payoff.
capture_rate,t=o=>({mean:o,low:null,high:null}),n=o=>o.filter(a=>a!==void 0),s=[...this.genomes.pursuer.keys()];return{pursuers:t(s.map(o=>In(n(e[o])))),evaders:t(
s.map(o=>In(n(e.map(a=>a[o])).map(a=>1-a))))}}};var Fn=r=>r.reduce((e,t)=>e+t,0)/r.length,Fa=(r,e)=>e==="pursuer"?r:r[0].map((t,n)=>r.map(s=>1-s[n])),Ua=(r,e)=>Fn(Fa(r,e).at(-1));function Da(r,e){let t=[],n=Fa(
r,e).map(s=>Fn(s.map((o,a)=>(t[a]=Math.max(t[a]??0,o),t[a]-o))));return Fn(n.slice(Math.floor(n.length/2)))}var Te=r=>`${Math.round(100*r)} %`,du=100,mu=0,Pr=class extends EventTarget{element;newest;beginning;settings;state="waiting";done=0;seconds=0;#e;#r;#t;#n=m("h2",
{class:"lane-title"});#o=m("p",{class:"facts numbers"});#s=m("p",{class:"regret small numbers",title:"Regret: what perfect play would bring, and the team does n\
ot get against an opponent that knows it"});#c=m("div",{class:"lane-room",hidden:!0});#u=m("section",{class:"card measures",hidden:!0});#m=m("div");#a;#h={pursuer:[],
evader:[]};#l=new Map;#p;#f;#i=[];#d=()=>{};#g=0;#y=!0;#v=0;#w=null;constructor(e,t,n,s){super(),[this.#e,this.#r,this.#t,this.settings]=[e,t,n,s],this.newest=new Et(
()=>this.#k(this.#a.newest)),this.beginning=new Et(()=>this.#k(0)),this.beginning.element.classList.add("beginning");let o=m("div",{class:"boards"},this.newest.
element,this.beginning.element);this.element=m("section",{class:"lane"},this.#n,this.#o,this.#s,o,this.#c,this.#u,this.#m),n.onmessage=({data:a})=>this.#S(a),this.
reset(s)}reset(e){this.#b({type:"stop"}),[this.settings,this.state,this.done]=[e,"waiting",0],this.#C();let{archive:t}=new et(this.#r,e,this.#e.masks);this.#a.add(
{pursuer:t.pursuer[0],evader:t.evader[0]}),this.#c.hidden=this.#u.hidden=!0,this.#M(!0),this.#E()}start(){this.#C(),[this.state,this.done]=["evolving",0],this.#c.
hidden=!1,this.#u.hidden=!0,this.#b({type:"start",settings:this.settings,masks:this.#e.masks}),this.#E()}stop(){this.#b({type:"stop"}),this.state==="evolving"&&
(this.state="stopped"),this.#E()}change(e){if(this.state==="waiting")return this.reset(e);this.settings=e,this.#b({type:"change",settings:e}),this.#E()}takeOver(){
let e=this.#a.newest;this.#f.play({run:0,pursuer:e,evader:e,episode:0,seed:null,map:null},{seat:this.#a.world.n_pursuers,from:0,moves:[]})}saved(){return new Promise(
e=>{this.#w=e,this.#b({type:"save"})})}get newestGeneration(){return this.#a.newest}close(){this.#t.terminate(),this.newest.runs=this.beginning.runs=!1}#b(e){this.#t.
postMessage(e)}#S(e){if(e.type==="generation"){if(this.state!=="evolving")return;this.#a.add(e.genomes),this.#M(e.number===0)}else if(e.type==="cell"){let{pursuer:t,
evader:n}=e.cell;this.#a.addCell(e.cell),this.#y&&t===n&&t===this.#a.newest&&this.#p.select({pursuer:t,evader:n}),this.#l.set(`${t} ${n}`,e.cell)}else if(e.type===
"scores")for(let t of C)this.#h[t][e.number]=e.scores[t];else e.type==="anew"?(this.#a.change(e.settings,e.genomes),this.#T(),this.#M(!0)):e.type==="epoch"?this.
done=e.done/e.of:e.type==="end"?(this.state==="evolving"&&([this.state,this.seconds,this.done]=["ended",e.seconds,1]),this.#_()):e.type==="saved"?this.#w?.(e.race):
(this.#o.textContent=`The race failed: ${e.message}`,this.state="stopped");this.#v||(this.#v=setTimeout(()=>requestAnimationFrame(()=>this.#x()),du))}#x(){this.#v=
0,this.#p.dispatchEvent(new Event("run")),this.#d(),this.#E(),this.#A()}async#A(){let e=this.#a,{world:t,newest:n}=e;if(n<0||this.#i[0]===t&&this.#i[1]===n)return;
let s=this.#i=[t,n],o=pu(t),a=o?null:await Je(this.#r,t);this.#i!==s||this.#a!==e||e.world!==t||this.#s.replaceChildren(...a?fu(a.value,C.map(i=>a.guaranteed(i,
e.policy(i,n)))):[o])}#T(){this.#l=new Map,this.#h={pursuer:[],evader:[]},this.#u.hidden=!0}#C(){let e=`race ${mu++}`,t=Gt(this.settings);this.#a=new Rr(this.settings,
this.#e.masks,t,e),this.#T(),this.#y=!0,this.#p=new wr({run:0,pursuer:0,evader:0,episode:0,seed:null,map:null});let[n,s]=[new vr([this.#a],this.#p),new yr([this.#a],
this.#p,null)];n.element.ariaLabel=`Payoff matrix. ${t}`,this.#f=new Mr([this.#a],this.#p,s,!1),this.#f.start(this.#r);let o=m("dialog",{class:"of-cell-match","\
aria-label":"Match"},m("button",{type:"button",class:"leave",onclick:()=>o.close()},"Close"),s.element);o.addEventListener("close",()=>s.player.pause());let a=!1;
n.element.addEventListener("play",()=>{let{pursuer:l,evader:u}=this.#p.selected;this.#y=!1,this.#a.payoff.capture_rate[l][u]!==void 0&&(o.showModal(),a||s.start(
this.#r),a=!0,s.playSoon())});let i=js(`Scores against scripts, by generation: ${_r.pursuer.join(", ")} and ${_r.evader.join(", ")}`,(l,u)=>{let c=this.settings.
schedule.generations,h=Ws(l,u,{low:0,high:c,label:"generation",whole:!0},{low:0,high:1,label:"score"});for(let d of C){let p=Array.from(this.#h[d],g=>g??null);zs(
h,[...p.keys()],p,`of-${d}s`)}return h},()=>{},l=>{let u=Math.min(this.#a.newest,Math.max(0,Math.round(l)));this.#p.select({pursuer:u,evader:u})});this.#d=i.redraw,
this.#c.replaceChildren(n.element,m("section",{class:"card scores"},m("h3",{},"Against opponents that never change"),m("p",{class:"small muted"},"Captures of ra\
ndom walkers and of clumsy fleers; escapes from random walkers and from clumsy chasers."),Bs(["pursuers","of-pursuers"],["evaders","of-evaders"]),i.element)),this.#m.
replaceChildren(o,this.#f.dialog)}#k(e){let t=this.#a.newest;if(t<0||e<0)return null;let{world:n,payoff:s,seeds:o}=this.#a,a=this.#g++%s.episodes;this.newest.title.
textContent=t?"Newest against newest":"Generation 0: nobody has learned anything yet",this.beginning.title.textContent="Pursuers of generation 0, newest evaders";
for(let u of[this.newest,this.beginning])u.generation=t;for(let u of[this.newest,this.beginning])u.label=`A match. ${u.title.textContent}`;let[i,l]=[this.#a.policy(
"pursuer",e),this.#a.policy("evader",t)];return this.#r.match(n,i,l,BigInt(o[e][t]),a)}#M(e){this.newest.renew(e),(this.#a.newest>0||this.state!=="waiting")&&this.
beginning.renew(e)}#E(){this.element.dataset.state=this.state,this.#n.textContent=Gt(this.settings);let e=this.#l.get(`${this.#a.newest} ${this.#a.newest}`)??this.#l.
get(`${this.#a.newest-1} ${this.#a.newest-1}`),t=e?[`Generation ${this.#a.newest} of ${this.settings.schedule.generations}`,`the newest pursuers catch ${Te(e.capture_rates.
reduce((n,s)=>n+s,0)/e.capture_rates.length)} of the newest evaders`,`${yu(e).toFixed(0)} collisions in 1000 moves`]:[];this.#o.replaceChildren(...t.map(n=>m("s\
pan",{},n))),this.dispatchEvent(new Event("state"))}#_(){this.#u.ariaLabel=`What came out. ${Gt(this.settings)}`;let e=this.#a.payoff.capture_rate.slice(0,this.#a.
newest+1).map(n=>n.slice(0,this.#a.newest+1));if(e.length<2||e.some(n=>Array.from(n).includes(void 0)))return;let t=[["Score against scripts: generation 0",n=>Te(
this.#h[n][0]??0)],["Score against scripts: newest generation",n=>Te(this.#h[n].at(-1)??0)],["Newest generation against all generations of the other team",n=>Te(
Ua(e,n))],["Below its own best so far, in the later half (forgetting)",n=>Te(Da(e,n))]];this.#u.replaceChildren(m("h3",{},"What came out"),m("table",{class:"num\
bers"},m("thead",{},m("tr",{},m("td"),...C.map(n=>m("th",{scope:"col",class:n},`${n}s`)))),m("tbody",{},...t.map(([n,s])=>m("tr",{},m("th",{scope:"row"},n),...C.
map(o=>m("td",{},s(o))))))),m("p",{class:"small muted"},"These are measures without a verdict: one race proves little. Save it, and ",m("code",{},"matrixworld j\
udge")," weighs luck and says what happened.")),this.#u.hidden=!1}};function pu(r){return!je(r)||typeof r.obstacles=="number"?"":"Exact regret of a map is known\
 where the world can be solved: choose 6 x 6 cells below, with few agents."}function fu(r,[e,t]){let n=(s,o,a)=>m("span",{},o,m("strong",{class:s},`regret ${Math.
max(0,a).toFixed(2)}`));return[m("span",{},`Perfect play captures ${Te(r)} on this map.`),n("pursuer",`The newest pursuers are sure of ${Te(e)}: `,r-e),n("evade\
r",`The newest evaders cannot prevent ${Te(t)}: `,t-r)]}function yu({means:{faults:r,agent_steps:e}}){let t=n=>n.reduce((s,o)=>s+o,0);return 1e3*t(r)/Math.max(1,
t(e))}function Wa(r,e){let t=[];for(let n=2;t.length<r;n++)t.every(s=>n%s)&&t.push(n);return Int32Array.from(t,n=>e(n)%1*2**32)}var ce=(r,e)=>r>>>e|r<<32-e;function Un(r){
let e=Wa(64,Math.cbrt),t=Wa(8,Math.sqrt),n=new Uint8Array(Math.ceil((r.length+9)/64)*64);n.set(r),n[r.length]=128;let s=new DataView(n.buffer);s.setBigUint64(n.
length-8,BigInt(r.length)*8n);let o=new Int32Array(64);for(let a=0;a<n.length;a+=64){for(let f=0;f<16;f++)o[f]=s.getInt32(a+4*f);for(let f=16;f<64;f++){let[y,b]=[
o[f-15],o[f-2]],x=ce(y,7)^ce(y,18)^y>>>3,w=ce(b,17)^ce(b,19)^b>>>10;o[f]=o[f-16]+x+o[f-7]+w}let[i,l,u,c,h,d,p,g]=t;for(let f=0;f<64;f++){let y=g+(ce(h,6)^ce(h,11)^
ce(h,25))+(h&d^~h&p)+e[f]+o[f]|0,b=(ce(i,2)^ce(i,13)^ce(i,22))+(i&l^i&u^l&u)|0;[g,p,d,h,c,u,l,i]=[p,d,h,c+y|0,u,l,i,y+b|0]}[i,l,u,c,h,d,p,g].forEach((f,y)=>t[y]+=
f)}return Array.from(t,a=>(a>>>0).toString(16).padStart(8,"0")).join("")}function Lr(r){return Array.isArray(r)?`[${r.map(Lr).join(", ")}]`:typeof r!="object"||r===null?JSON.stringify(r):`{${Object.entries(r).sort(([t],[n])=>t<n?-1:1).
map(([t,n])=>`${JSON.stringify(t)}: ${Lr(n)}`).join(", ")}}`}function za(r,e=""){return fe(JSON.stringify({...r,sha256:Un(fe(e+Lr(r)))},null,2))}var Dn=(r,...e)=>({
dtype:"<f8",shape:e,data:Float64Array.from(r)}),Ot=r=>r.reduce((e,t)=>e+t,0)/r.length,Ba=r=>Math.sqrt(Ot(r.map(e=>(e-Ot(r))**2))),gu=["generation","team","epoch",
"opponent","fitness_mean","fitness_std","fitness_best","capture_rate","length","pursuer_faults","evader_faults","matches","steps"];function bu({archive:r,rows:e,
counters:t},n){let s=e.filter(({generation:i})=>i===n),o=fe(s.map(i=>`${[n,...gu.map(l=>i[l])].join(",")}
`).join("")),a=i=>({dtype:"<f4",shape:[1,r[i][n].length],data:r[i][n]});return{pursuers:a("pursuer"),evaders:a("evader"),log:{dtype:`|S${Math.max(1,o.length)}`,
shape:[],data:o.length?o:new Uint8Array(1)},...Object.fromEntries(Object.entries(t[n]).map(([i,l])=>[i,Dn([l])])),...n?{capture_rate:Dn([Ot(s.slice(Math.floor(s.
length/2)).map(i=>i.capture_rate))])}:{}}}function vu(r){let e=r.finished,t=Array.from({length:e*e},(o,a)=>r.cells.get(`${Math.floor(a/e)} ${a%e}`)),n=t[0].lengths.
length,s=(o,...a)=>Dn(t.flatMap(o),e,e,...a);return{capture_rates:{dtype:"<f4",shape:[e,e,n],data:Float32Array.from(t.flatMap(({capture_rates:o})=>o))},lengths:{
dtype:"<i4",shape:[e,e,n],data:Int32Array.from(t.flatMap(({lengths:o})=>o))},collisions:s(({means:o})=>o.collisions,2,3),faults:s(({means:o})=>o.faults,2,3),agent_steps:s(
({means:o})=>o.agent_steps,2),pursuer_survivors:s(({means:o})=>o.survivors[0]),evader_survivors:s(({means:o})=>o.survivors[1]),capture_rate:s(({capture_rates:o})=>Ot(
o)),capture_rate_std:s(({capture_rates:o})=>Ba(o)),length:s(({lengths:o})=>Ot(o)),length_std:s(({lengths:o})=>Ba(o))}}function wu(r,{format:e,version:t}){let n=r.
finished-1,s={...r.settings,schedule:{...r.settings.schedule,generations:n}},o={format:e,matrixworld:t,settings:s,drawn_by:"page"},a=Array.from({length:r.finished},
(d,p)=>`stage-${String(p).padStart(4,"0")}.npz`),{matches:i,steps:l,agent_steps:u}=r.counters[n],h={stages:n,...{training_matches:i,training_steps:l,training_agent_steps:u},
disengagement:[],evaluation_matches:r.finished**2*r.settings.evaluation_episodes};return{"config.json":za(o),...Object.fromEntries(a.map((d,p)=>[d,Mt(bu(r,p))])),
"payoff.npz":Mt(vu(r)),"summary.json":za(h,`${Un(fe(Lr(o)))}/summary.json`)}}function ja(r,e){let t=r.flatMap(({name:n,race:s})=>Object.entries(wu(s,e)).map(([o,
a])=>[r.length>1?`${n}/${o}`:o,a]));return Bt(Object.fromEntries(t))}var Ha=r=>r.finished>1&&r.cells.size>=r.finished**2&&C.every(e=>r.archive[e].length);var xu=12;function Ga(r){let e=new Blob([Ae("script-engine"),`
`,Ae(`script-${r}`)],{type:"text/javascript"});return new Worker(URL.createObjectURL(e))}function Va(){let r=c=>postMessage(c),e=Ft(),t=null,n=null,s=0,o=!1,a=new MessageChannel,
i=()=>{let c=performance.now()+xu;for(;n&&performance.now()<c;){let{value:h,done:d}=n.next();d?(n=null,r({type:"end",seconds:(performance.now()-s)/1e3})):r(h)}!n||
o||(o=!0,a.port2.postMessage(null))},l=async c=>{if(c.type==="start")t=new et(await e,c.settings,c.masks),[n,s]=[t.run(),performance.now()],i();else if(c.type===
"stop")n=null;else if(c.type==="change"){let h=t?.change(c.settings);if(h&&r(h),!t||!h||n)return;n=t.catchUp(),i()}else if(t){let{settings:h,archive:d,rows:p,cells:g,
counters:f,finished:y}=t;r({type:"saved",race:{settings:h,archive:d,rows:p,cells:g,counters:f,finished:y}})}},u=c=>{Promise.resolve().then(c).catch(h=>{n=null,r(
{type:"failed",message:String(h)})})};a.port1.onmessage=()=>{o=!1,u(i)},globalThis.onmessage=({data:c})=>u(()=>l(c))}var Su=250,Wn=class{#e;#r;lanes=[];#t=m("div",{class:"lanes"});#n=m("button",{type:"button",class:"evolve",onclick:()=>this.#w()});#o=m("progress",{max:1,value:0,
"aria-label":"Progress of the race"});#s=m("p",{class:"small muted numbers",role:"status"});#c=m("button",{type:"button",class:"side",title:"A second race of th\
e same seed with another schedule",onclick:()=>this.#S()},"Side by side");#u=m("button",{type:"button","aria-pressed":"false",title:"Drag over the board to draw\
 walls, and over walls to remove them",onclick:()=>this.#T()},"Draw walls");#m=m("button",{type:"button",onclick:()=>this.#x({walls:[]})},"No walls");#a=m("butt\
on",{type:"button",onclick:()=>this.#C()});#h=m("input",{type:"text",readonly:!0,hidden:!0,"aria-label":"Link to this race"});#l=m("span",{class:"small muted",role:"\
status"});#p=Is((e,t)=>this.#x(e,t));#f=m("button",{type:"button",onclick:()=>{this.#_()},title:"An archive that matrixworld judge, explore and replay read"},"S\
ave");#i=[];#d;#g=0;constructor(e,t){[this.#e,this.#r,this.#d]=[e,t,Ns(e,location.hash)];let n=m("div",{class:"doings",role:"group","aria-label":"What can be do\
ne"},this.#c,m("button",{type:"button",class:"to-play",title:"Play an evader against the newest pursuers",onclick:()=>this.lanes[0].takeOver()},"Take over"),this.#u,
this.#m,this.#a,this.#f,m("button",{type:"button",class:"to-link",onclick:()=>this.#E()},"Link"),this.#h,this.#l);document.getElementById("page").replaceWith(ys(
"Evolve a chase","Triangles chase discs. Nobody has told either team how. Press Evolve, and both learn by trial and error, against each other."),m("main",{},m("\
div",{class:"start"},this.#n,n,m("div",{class:"progress"},this.#o,this.#s)),this.#p.now,this.#t,this.#p.anew,m("div",{class:"card below"},Dt(),m("p",{class:"sma\
ll muted"},"The page plays and learns with the engine of matrixworld, in this browser; nothing is sent."),m("p",{class:"small muted of-saving"},"A saved race is\
 an archive: ",m("code",{},"matrixworld judge"),", ",m("code",{},"explore")," and ",m("code",{},"replay")," read it. Python plays its matches again, and does no\
t continue it."))),m("footer",{class:"muted small"},`matrixworld ${e.version}`)),this.#v(),this.#k()}#y(){return[this.#d.schedule,...this.#d.beside?[this.#d.beside]:
[]]}#v(){for(let e of this.lanes.splice(0))e.close();for(let e of this.#y()){let t=new Pr(this.#e,this.#r,Ga("evolve"),Kt(this.#e,this.#d,e));t.addEventListener(
"state",()=>this.#M()),this.lanes.push(t)}this.#i=this.lanes.map(e=>e.newest.drawWalls(([t,n],s)=>this.#A(t,n,s))),this.#u.ariaPressed="false",this.#t.dataset.count=
String(this.lanes.length),this.#t.replaceChildren(...this.lanes.map(({element:e})=>e)),this.#p.show(this.#d),this.#M()}#w(){this.lanes.some(({state:e})=>e==="ev\
olving")?this.lanes.forEach(e=>e.stop()):this.#b()}#b(){this.#l.textContent="";for(let[e,t]of this.#y().entries()){let n=this.lanes[e];n.settings=Kt(this.#e,this.#d,
t),n.start()}}#S(){let e=this.#d.schedule==="specialist-specialist"?"generalist-generalist":"specialist-specialist";this.#x({beside:this.#d.beside?null:e},!0)}#x=(e,t=!1)=>{
let n=this.#y().length,s=this.lanes.every(({state:l})=>l==="waiting"),o=e.small===void 0?{}:mt(this.#e,e.small),a={...this.#d,...e,...o},i=Jt(a,pt(this.#e,a.small));
i||(this.#d=a),this.#p.show(this.#d),this.#l.textContent=i,!i&&(this.#h.hidden=!0,this.#y().length!==n&&this.#v(),t&&!s?this.#b():this.#y().forEach((l,u)=>this.
lanes[u].change(Kt(this.#e,this.#d,l))))};#A(e,t,n){let{rows:s,cols:o}=this.lanes[0].settings.world,a={...this.#d,walls:dn(this.#d.walls,e*o+t,n)},i=Jt(a,this.lanes[0].
settings.world);if(i)return i;let{walls:l}=this.#d=a,u=Uint8Array.from({length:s*o},(c,h)=>Number(l.includes(h)));for(let c of this.lanes)c.newest.show(u);return clearTimeout(
this.#g),this.#g=setTimeout(()=>this.#x({walls:l}),Su),""}#T(){let e=this.#u.ariaPressed!=="true";this.#u.ariaPressed=String(e);for(let t of this.#i)t.active(e)}#C(){
let e=!this.lanes[0].newest.runs;for(let{newest:t,beginning:n}of this.lanes)t.runs=n.runs=e;this.#k()}#k(){this.#a.textContent=this.lanes[0].newest.runs?"Pause \
boards":"Play boards"}#M(){if(!this.lanes.length)return;let e=this.lanes.map(({state:a})=>a),t=e.includes("evolving");document.body.dataset.state=e.every(a=>a===
"waiting")?"waiting":t?"evolving":"ended",this.#n.textContent=t?"Stop":e[0]==="waiting"?"Evolve":"Again",this.#c.ariaPressed=String(this.lanes.length>1),this.#m.
hidden=!this.#d.walls.length,this.#o.value=Math.min(...this.lanes.map(({done:a})=>a));let n=Math.max(...this.lanes.map(a=>a.seconds)),s=e.every(a=>a==="ended"),
{seed:o}=this.#d;this.#s.textContent=t?`Seed ${o}: generation ${this.lanes.map(a=>a.newestGeneration).join(" and ")}`:s?`Seed ${o}: the race took ${n.toFixed(1)}\
 seconds.`:e.includes("stopped")?"Stopped.":""}#E(){Ut()&&(this.#h.hidden=!1,this.#h.value=`${location.href.split("#")[0]}#${$s(this.#d)}`,ps(this.#h,this.#l))}async#_(){
let e=await Promise.all(this.lanes.map(async o=>({name:ke(o.settings),race:await o.saved()})));if(!e.every(({race:o})=>Ha(o))){this.#l.textContent="Wait for the\
 next generation, and save then.";return}let t=ja(e,{format:this.#e.format,version:this.#e.version}),n=new Blob([t],{type:"application/zip"}),s=`${e.map(o=>o.name).
join("-and-")}-seed-${this.#d.seed}.zip`;m("a",{href:URL.createObjectURL(n),download:s}).click(),this.#l.textContent=`Saved as ${s}.`}};async function Au(){let r=new Wn(
Ls(),await Ft());document.addEventListener("keydown",({key:e,target:t,ctrlKey:n,metaKey:s,altKey:o})=>{let a=t instanceof HTMLInputElement||t instanceof HTMLSelectElement||
document.querySelector("dialog[open]");e.toLowerCase()==="d"&&!a&&!n&&!s&&!o&&Yr()}),window.addEventListener("hashchange",()=>location.reload()),Object.assign(window,
{matrixworldEvolve:r})}typeof document>"u"?Va():Au().catch(r=>{throw(document.getElementById("page")??document.body).append(m("p",{class:"card problem",role:"al\
ert"},`The page could not start: ${String(r)}`)),r}).finally(()=>{document.body.dataset.ready="true"});})();
