/* built from web/ by "npm run build"; sources 2a1fae05abaff1e2366678a422ba5c37c6f4bd927ab4e626582e6e45a0303b3d */
"use strict";(()=>{var dr={SIMULTANEOUS:0,SWARM_TURNS:1,AGENT_TURNS:2},tt={DISAPPEAR:0,REACH:1,BOUNCE:2},hr={OCCUPATION:0,SURROUND:1},fr={FAULT:0,INVOLVED:1};var yn=["obstacle","teammate","adversary"],bn=["vertex","edge","chain"],gr=["turn","kind","form","first","second","row","col","at_fault","held","doomed"],vn=["p\
ursuer_{number}","evader_{number}"],yr={obstacle:"{first} ran into the obstacle or border at {cell}",vertex:"{first} and {second} both headed for {cell}",edge:"\
{first} and {second} meant to swap, {first} to {cell}",chain:"{first} headed for {cell}, where {second} had to stay"},nt={"both held":"both bounce","both doomed":"\
both disappear",held:"{agent} bounces",doomed:"{agent} disappears",none:"nobody is stopped"},br="{event}: {outcome}",wn={random:"any action, all equally likely",
still:"always stays",chaser:"moves to where the nearest adversary in view is nearest",fleer:"moves to where the nearest adversary in view is farthest","clumsy-c\
haser":"a chaser that takes any action in half of the steps",hunter:"a chaser of the nearest adversary in view to which no teammate in view is nearer",surrounder:"\
a chaser of the nearest free cell beside an adversary without a teammate","clumsy-fleer":"a fleer that takes any action in half of the steps",dodger:"moves to w\
here all adversaries in view together are farthest","team-surrounder":"shares the free cells beside adversaries with its teammates, and searches","careful-rando\
m":"as random, but takes only moves that right of way allows","careful-chaser":"as chaser, but takes only moves that right of way allows","careful-fleer":"as fl\
eer, but takes only moves that right of way allows","careful-clumsy-chaser":"as clumsy-chaser, but takes only moves that right of way allows","careful-hunter":"\
as hunter, but takes only moves that right of way allows","careful-surrounder":"as surrounder, but takes only moves that right of way allows","careful-clumsy-fl\
eer":"as clumsy-fleer, but takes only moves that right of way allows","careful-dodger":"as dodger, but takes only moves that right of way allows","careful-team-\
surrounder":"as team-surrounder, but takes only moves that right of way allows"},We={adversary:"distance to the nearest adversary (0 to 2, in half views)",pressure:"\
sum over adversaries of 1 / (1 + moves)^2 (0 or more)",unclaimed:"distance to the nearest adversary to which no teammate is nearer than the agent is now; withou\
t one, to the nearest adversary (0 to 2, in half views)",open_side:"distance to the nearest cell beside an adversary that holds no obstacle and no teammate (0 t\
o 2, in half views)",teammate:"distance to the nearest teammate (0 to 2, in half views)",exits:"share of the cells around that are no obstacle (0 to 1)",room:"d\
istance to the nearest obstacle to the north, east, south or west (0 to 1, in half views)",must_yield:"1 if right of way forbids the move (0 to 1)",ahead:"1 if \
it is the direction that the agent draws for each 12 steps (0 to 1)",search:"1 if it leads on along the way on which an agent of team-surrounder searches the gr\
id (0 to 1)"},vr={free:".GS",blocked:"#@OTW"};var Ue=1+gr.length;function rt(t,e){return t.replace(/\{(\w+)\}/g,(n,r)=>String(e[r]))}function Y(t,e){return t<e?rt(vn[0],{number:t}):rt(vn[1],{number:t-e})}function Sa(t,e){
let[n,r,o,s,a,i,l,...c]=Array.from(t),m=a<0?[s]:[s,a],[p,d,h]=c.map(v=>m.filter((x,b)=>v>>b&1)),f=m.map(v=>Y(v,e)),g=rt(yr[a<0?"obstacle":bn[o]],{first:f[0],second:f[f.
length-1],cell:`(${i}, ${l})`}),y=rt(br,{event:g,outcome:Ma(m.length,d,h,e)});return{kind:yn[r],form:bn[o],agents:m,cell:[i,l],at_fault:p,held:d,doomed:h,turn:n,
text:y}}function Ma(t,e,n,r){if(t===2&&e.length===2)return nt["both held"];if(t===2&&n.length===2)return nt["both doomed"];let o=s=>a=>rt(nt[s],{agent:Y(a,r)});
return[...e.map(o("held")),...n.map(o("doomed"))].join(", ")||nt.none}function Tt(t,e){let n=[];for(let r=0;r<t.length;r+=Ue)n.push(Sa(t.subarray(r+1,r+Ue),e));
return n}var we=class extends Error{name="EngineError"};function L(t,e,n){let r=typeof n=="string"?`'${n}'`:typeof n=="object"?JSON.stringify(n):String(n);return new we(
`${t}: expected ${e}, got ${r}`)}var Fe=class{bytes;constructor(e){this.bytes=e}},Sr=0,Sn=[Uint8Array,Uint8Array,Int32Array,BigInt64Array,BigUint64Array,Float32Array,Float64Array],wr=4,xr=4,Aa=new TextEncoder,
Ta=new TextDecoder;function Ea(t){for(let e=Sn.length-1;e>Sr;--e)if(t instanceof Sn[e])return e;throw new TypeError("array: expected a typed array of the engine\
's numbers, got another")}function xn(t){return new Uint8Array(t.buffer,t.byteOffset,t.byteLength)}function Ca(t){return Aa.encode(`${t}\0`)}var Mn=class{engine;addresses=[];constructor(e){
this.engine=e}copy(e){let n=this.engine._malloc(Math.max(e.length,1));if(n===0)throw new we("memory: expected room for the arguments, got none");return this.addresses.
push(n),this.engine.HEAPU8.set(e,n),n}text(e){return this.copy(Ca(e))}arrays(e){let n=Object.entries(e),r=n.flatMap(([s,a])=>{let i=a instanceof Fe,l=i?a.bytes:
a;return[this.text(s),i?Sr:Ea(l),l.length,this.copy(xn(l))]}),o=this.copy(xn(Int32Array.from(r)));return this.copy(xn(Int32Array.of(n.length,o)))}free(){for(let e of this.
addresses)this.engine._free(e)}};function Mr(t,e){let n=t.HEAPU8;return Ta.decode(n.subarray(e,n.indexOf(0,e)))}function De(t){let e=new Int32Array(t.HEAPU8.buffer),
n=t._last_outputs()/wr,r=e[n+1]/wr,o={};for(let s=r;s<r+e[n]*xr;s+=xr){let a=Sn[e[s+1]],i=e[s+2]*a.BYTES_PER_ELEMENT,l=e[s+3];o[Mr(t,e[s])]=new a(t.HEAPU8.slice(
l,l+i).buffer)}return o}function xe(t,e){let n=new Mn(t);try{let r=e(n);if(r===0)throw new we(Mr(t,t._last_error()));return r}finally{n.free()}}var ka=2**31-1,Ar=["none","gru"],Ra=2n**64n-1n,Oa=34028234663852886e22;function le(t,e){if(typeof e!="number"||!Number.isInteger(e)||Math.abs(e)>ka)throw L(t,"a\
n integer",e);return Int32Array.of(e)}function Et(t,e){if(typeof e!="boolean")throw L(t,"true or false",e);return new Fe(Uint8Array.of(Number(e)))}function Te(t,e,n){
let r=typeof e=="string"&&Object.hasOwn(n,e)?n[e]:void 0;if(r===void 0)throw L(t,`one of ${Object.keys(n).join(", ")}`,e);return Int32Array.of(r)}function An(t,e){
if(typeof e!="number"||!(Math.abs(e)<=Oa))throw L(t,"a finite number",e);return e}function ot(t,e){let r=typeof e=="bigint"||typeof e=="number"&&Number.isSafeInteger(
e)?BigInt(e):-1n;if(r<0n||r>Ra)throw L(t,"an integer from 0 to 2^64 - 1",e);return BigUint64Array.of(r)}function $a(t){return{"rules.interaction":Te("interactio\
n",t.interaction,dr),"rules.obstacle":Te("obstacle",t.obstacle,tt),"rules.teammate":Te("teammate",t.teammate,tt),"rules.evader":Te("evader",t.evader,tt),"rules.\
pursuer":Te("pursuer",t.pursuer,tt),"rules.capture":Te("capture",t.capture,hr),"rules.captured_disappear":Et("captured_disappear",t.captured_disappear)}}function Tr(t,e){
let n=typeof e=="number"?[e,e,e]:e;if(!Array.isArray(n)||n.length!==3)throw L(t,"1 or 3 numbers",e);return Float32Array.from(n,r=>An(t,r))}function Pa(t){let e=(n,r)=>Float32Array.
of(An(n,t[n]),An(r,t[r]));return{"rewards.capture":e("pursuer_capture","evader_capture"),"rewards.neighbor":e("pursuer_neighbor","evader_neighbor"),"rewards.ste\
p":e("pursuer_step","evader_step"),"rewards.pursuer_collide":Tr("pursuer_collide",t.pursuer_collide),"rewards.evader_collide":Tr("evader_collide",t.evader_collide),
"rewards.blame":Te("blame",t.blame,fr),"rewards.capture_repeats":Et("capture_repeats",t.capture_repeats)}}function kr(t){if(t===void 0||typeof t=="number")return new Uint8Array(
0);if(t instanceof Uint8Array)return t;let{free:e,blocked:n}=vr;for(let[r,o]of t.entries()){if(o.length!==t[0]?.length)throw L(`map, row ${r}`,`${t[0]?.length} \
cells as in row 0`,o.length);let s=[...o].find(a=>!e.includes(a)&&!n.includes(a));if(s)throw L(`map, row ${r}`,`'${e}' (free) or '${n}' (obstacle)`,s)}return Uint8Array.
from([...t.join("")],r=>Number(n.includes(r)))}function Rr(t,e){if(!Array.isArray(t))return;let n=[t.length,t[0]?.length??0];if(!(n[0]===e.rows&&n[1]===e.cols))
throw L("obstacle map",`shape (${e.rows}, ${e.cols}), the rows and cols`,n)}function ze(t){Rr(t.obstacles,t);let e=typeof t.obstacles=="number"?t.obstacles:0;return{
...$a(t.rules),...Pa(t.rewards),rows:le("rows",t.rows),cols:le("cols",t.cols),n_pursuers:le("n_pursuers",t.n_pursuers),n_evaders:le("n_evaders",t.n_evaders),fov:le(
"fov",t.fov),diagonal:Et("diagonal",t.diagonal),max_steps:le("max_steps",t.max_steps),density:Float64Array.of(e),map:kr(t.obstacles)}}function Er(t,e){return Int32Array.
from((e??[]).flat(),n=>le(t,n)[0])}function Or(t,e){return Rr(t.obstacles,e),{seed:ot("seed",t.seed??0n),episode:ot("episode",t.episode??0),pursuers:Er("pursuer\
s",t.pursuers),evaders:Er("evaders",t.evaders),map:kr(t.obstacles)}}function Ct(t){return{actions:Int32Array.from(t,e=>le("actions",e)[0])}}var Cr=Object.keys(We);
function Tn(t){let e=Cr.indexOf(t);if(e<0)throw L("inputs",`names of ${Cr.join(", ")}`,t);return e}function Ee(t){if(typeof t=="string"){if(!Object.hasOwn(wn,t))
throw L("policy",`one of ${Object.keys(wn).join(", ")}`,t);return{script:new TextEncoder().encode(t)}}if(t.kind!=="cells")return{inputs:Int32Array.from(t.inputs,
e=>Tn(e)),hidden:Int32Array.from(t.kind==="rating"?t.hidden:[],e=>le("hidden",e)[0]),length:le("length",t.kind==="program"?t.length:0),mask:new TextEncoder().encode(
t.mask),genome:t.genome};if(t.activation!=="relu"&&t.activation!=="tanh")throw L("activation","'relu' or 'tanh'",t.activation);if(!Ar.includes(t.memory))throw L(
"memory",`one of ${Ar.join(", ")}`,t.memory);return{hidden:Int32Array.from(t.hidden,e=>le("hidden",e)[0]),activation:new TextEncoder().encode(t.activation),sampled:Et(
"sampled",t.sampled),memory:new TextEncoder().encode(t.memory),genome:t.genome}}var _a=["first_turn","terminated","truncated"];function $r(t){let e={...t};for(let n of _a)
e[n]=new Fe(t[n]);return e}var Pr="statistics.",kt=class{config;seed;episode;n_agents;statistics;first_conflict;constructor(e,n,r,o){this.config=e,this.seed=n,this.episode=r,this.n_agents=
e.n_pursuers+e.n_evaders,this.statistics=La(_r(o)),Object.assign(this,o),this.first_conflict=Na(this.conflict_table,this.length)}get length(){return this.actions.
length/this.n_agents}conflicts(e){this.check(e);let n=this.first_conflict[e],r=this.first_conflict[e+1],o=this.conflict_table.subarray(n*Ue,r*Ue);return Tt(o,this.
config.n_pursuers)}seek(e,n,r){this.check(n),(!(e.seed===this.seed&&e.episode===BigInt(this.episode))||e.turn!==0||e.steps>n)&&e.reset({seed:this.seed,episode:this.
episode});for(let s=e.steps;s<n;++s){let a=this.actions.subarray(s*this.n_agents,(s+1)*this.n_agents);r?e.replay(a,{pursuer:r.pursuers,evader:r.evaders}):e.step(
a)}}check(e){if(!(Number.isInteger(e)&&e>=0&&e<=this.length))throw L("step",`0 to ${this.length}`,e)}};function Na(t,e){let n=new Int32Array(e+2);for(let r=0;r<
t.length;r+=Ue)++n[t[r]+1];for(let r=1;r<n.length;++r)n[r]+=n[r-1];return n}function La(t){let e=["capture_rate","ever_capture_rate","captured_fraction","length"];
return Object.fromEntries(Object.entries(t).map(([n,r])=>[n,e.includes(n)?Number(r[0]):r]))}var _r=t=>Object.fromEntries(Object.entries(t).flatMap(([e,n])=>e.startsWith(
Pr)?[[e.slice(Pr.length),n]]:[]));function Nr(t,e,n,r){let o=[ze(n.config),Ee(n.pursuers),Ee(n.evaders),r];return xe(t,s=>{let[a,i,l,c]=o.map(m=>s.arrays(m));return t[e](
a,i,l,c)}),De(t)}function Lr(t,e,n,r){let o={seed:ot("seed",n),episode:ot("episode",r)};return new kt(e.config,n,r,Nr(t,"_play_match",e,o))}function Ir(t,e,n,r){
if(!Number.isInteger(r)||r<1)throw L("n_episodes","at least 1",r);let o=Nr(t,"_play_rollout",e,{...n,n_episodes:Int32Array.of(r)});return _r(o)}var Ia=7e6,Wa=new FinalizationRegistry(([t,e])=>t._states_free(e));function Ua({rules:t,rows:e,cols:n,obstacles:r,diagonal:o,n_pursuers:s,n_evaders:a}){let i=typeof r==
"number"||t.obstacle==="REACH"?0:r.join("").split("#").length-1,l=e*n-i,c=[t.obstacle,t.teammate,t.pursuer].includes("DISAPPEAR"),m=t.capture==="SURROUND"||t.evader===
"REACH",p=t.interaction==="AGENT_TURNS",d=(g,y)=>Array.from({length:y},(v,x)=>p?g:(g+x)/(x+1)).reduce((v,x)=>v*x,1),h=d(l+Number(c),s)*d(l*(1+Number(m))+2,a);return{
SIMULTANEOUS:[s+a],SWARM_TURNS:[s,a],AGENT_TURNS:Array(s+a).fill(1)}[t.interaction].reduce((g,y)=>g+h*(o?9:5)**y,0)}function Rt(t){return typeof t.obstacles=="n\
umber"&&t.obstacles>0?"obstacles are drawn anew in each episode":Ua(t)>Ia?"the world is too large to be solved on the page":""}var En=class{value;teams;matrix;n_actions;constructor(e,n){
let{matrix:r,rows:o,cols:s,value:a,agents:i}=n,[l,c]=e.actors,m=Array.from(i).filter(d=>l<=d&&d<c),p=d=>d<e.config.n_pursuers;this.value=a[0],this.matrix=r,this.
n_actions=e.n_actions,this.teams=[{agents:m.filter(p),play:o},{agents:m.filter(d=>!p(d)),play:s}]}marginal(e){let n=this.teams.find(({agents:s})=>s.includes(e));
if(!n)return null;let r=this.n_actions**(n.agents.length-1-n.agents.indexOf(e)),o=Array(this.n_actions).fill(0);return n.play.forEach((s,a)=>o[Math.floor(a/r)%this.
n_actions]+=s),o}lost(e){let[n,r]=this.teams.map(({agents:l})=>l.reduce((c,m)=>c*this.n_actions+e[m],0)),[o,s]=this.teams.map(({play:l})=>l),a=s.reduce((l,c,m)=>l+
c*this.matrix[n*s.length+m],0),i=o.reduce((l,c,m)=>l+c*this.matrix[m*s.length+r],0);return[Math.max(0,this.value-a),Math.max(0,i-this.value)]}},Cn=60,st=class{config;payoff;engine;states;n_turns;values;constructor(e,n,r){
this.engine=e,this.config=n,this.payoff=r,this.states=xe(e,i=>e._states_new(i.arrays(ze(n)))),Wa.register(this,[e,this.states]);let o={SIMULTANEOUS:1,SWARM_TURNS:2,
AGENT_TURNS:n.n_pursuers+n.n_evaders};this.n_turns=o[n.rules.interaction];let{payoffs:s}=this.call(()=>e._states_payoffs(this.states)),a=s;this.values=[[r==="ca\
pture-rate"?a:a.fill(0)]]}goBack(){let e=this.values.at(-1)[0],n=[];for(let o=this.n_turns-1;o>=0;o--){let s=n[o+1]??e;n[o]=this.backup(o,{next:s})}this.payoff===
"capture-time"&&(n[0]=n[0].map((o,s)=>s===this.config.n_evaders?0:o-1)),this.values.push(n);let r=this.payoff==="capture-rate"?this.config.max_steps:Math.min(this.
config.max_steps,Cn);return this.values.length<=r&&n[0].some((o,s)=>o!==e[s])}backup(e,n){return this.call(r=>this.engine._states_backup(this.states,e,r.arrays(
n))).values}game(e){let n=this.config.max_steps-e.steps,{turn:r}=e,o=r+1===this.n_turns,s=n>0?this.values[Math.min(n-Number(o),this.values.length-1)]?.[o?0:r+1]:
void 0;if(!s)return null;let a=this.call(i=>this.engine._states_game(this.states,e.address,i.arrays({next:s})));return a.agents.length?new En(e,a):null}call(e){
return xe(this.engine,e),De(this.engine)}};var Wr=new FinalizationRegistry(([t,e])=>t._world_free(e)),at=class{config;n_agents;n_actions;engine;at;freed=!1;constructor(e,n){this.engine=e,this.config=n,this.
n_agents=n.n_pursuers+n.n_evaders,this.n_actions=n.diagonal?9:5,this.at=xe(e,r=>e._world_new(r.arrays(ze(n)))),Wr.register(this,[e,this.at],this)}free(){this.freed||
(this.freed=!0,Wr.unregister(this),this.engine._world_free(this.at))}get address(){if(this.freed)throw L("world","one that is in use","one that was freed");return this.
at}reset(e={}){let n=Or(e,this.config);this.call(r=>this.engine._world_reset(this.address,r.arrays(n)))}step(e){let n=Ct(e);this.call(r=>this.engine._world_step(
this.address,r.arrays(n)))}playTurn(e){let n=Ct(e);this.call(r=>this.engine._world_play_turn(this.address,r.arrays(n)))}decide(e,n,r){let{n_pursuers:o}=this.config,
s={pursuer:[0,o],evader:[o,this.n_agents]},[a,i]=typeof n=="string"?s[n]:n;if(r.length!==this.n_agents)throw L("actions",String(this.n_agents),r.length);let l=[
Ee(e),Ct(r)],{actions:c}=this.call(m=>this.engine._world_decide(this.address,m.arrays(l[0]),a,i,m.arrays(l[1])));return Uint8Array.from(c)}replay(e,n){let r=s=>typeof s!=
"string"&&s.kind==="cells"&&s.memory!=="none";if(!r(n.pursuer)&&!r(n.evader))return this.step(e);let{n_pursuers:o}=this.config;for(let s=this.n_turns;s>0;--s){let[
a,i]=this.actors;a<o&&this.decide(n.pursuer,[a,Math.min(i,o)],e),i>o&&this.decide(n.evader,[Math.max(a,o),i],e),this.playTurn(e)}}get n_turns(){return this.turnNumbers()[1]}get turn(){
return this.turnNumbers()[0]}get actors(){let[,,e,n]=this.turnNumbers();return[e,n]}turnNumbers(){return this.call(()=>this.engine._world_turn(this.address)).turn}get steps(){
return this.read("steps")[0]}get seed(){return this.read("seed")[0]}get episode(){return this.read("episode")[0]}get over(){return this.read("terminated")[0]===
1||this.read("truncated")[0]===1}read(e){return this.call(n=>this.engine._world_read(this.address,n.text(e)))[e]}view(e){let n=3*this.config.fov**2;return this.
read("views").slice(e*n,(e+1)*n)}map(){return this.read("state").slice(2*this.config.rows*this.config.cols)}conflicts(){return Tt(this.conflictTable(),this.config.
n_pursuers)}conflictTable(){return this.call(()=>this.engine._world_conflicts(this.address)).conflict_table}answer(e,n){let r=Ee(e),{logits:o,memory:s}=this.call(
l=>this.engine._world_logits(this.address,l.arrays(r),n)),a=o,i=this.decide(e,[n,n+1],new Uint8Array(this.n_agents))[n];return{logits:a,probabilities:Fa(a),action:i,
memory:s}}rate(e,n){let r=Ee(e),{ratings:o,refused:s}=this.call(c=>this.engine._world_rate(this.address,c.arrays(r),n)),a=this.read("inputs"),i=a.length/this.n_agents/
this.n_actions,l=c=>Float32Array.from({length:this.n_actions},(m,p)=>a[(n*this.n_actions+p)*i+c]);return{inputs:e.inputs.map(c=>l(Tn(c))),ratings:o,refused:s}}snapshot(){
return this.call(()=>this.engine._world_snapshot(this.address))}restore(e){let n=$r(e);this.call(r=>this.engine._world_restore(this.address,r.arrays(n)))}call(e){
return xe(this.engine,e),De(this.engine)}};function Fa(t){let e=Math.max(...t),n=Array.from(t,o=>Math.exp(o-e)),r=n.reduce((o,s)=>o+s,0);return Float32Array.from(
n,o=>o/r)}var kn=class{compiled;constructor(e){this.compiled=e}world(e){return new at(this.compiled,e)}solution(e,n="capture-rate"){return new st(this.compiled,e,n)}match(e,n,r,o,s=0){
return Lr(this.compiled,{config:e,pursuers:n,evaders:r},o,s)}rollouts(e,n,r,o,s){return Ir(this.compiled,{config:e,pursuers:n,evaders:r},o,s)}},Ur;function Fr(t=globalThis.
matrixworldEngine){return Ur??=Da(t),Ur}async function Da(t){if(!t)throw new Error("matrixworldEngine: expected the script engine.js before this one, got none");
let e=Uint8Array.from(atob(t.binary),n=>n.charCodeAt(0));return new kn(await t({wasmBinary:e}))}var za="http://www.w3.org/2000/svg";function u(t,e={},...n){return Dr(document.createElement(t),e,n)}function w(t,e={},...n){return Dr(document.createElementNS(
za,t),e,n)}function Dr(t,e,n){for(let[o,s]of Object.entries(e))s==null||s===!1||(typeof s=="function"?t.addEventListener(o.slice(2),s):t.setAttribute(o,s===!0?"":
String(s)));let r=n.filter(o=>o!=null&&o!==!1);return t.append(...r.map(o=>typeof o=="number"?String(o):o)),t}function zr(t,e){let n=u("select",{onchange:()=>e(
n.value)},...t.map(([r,o])=>u("option",{value:r},o)));return n}async function Br(t){try{await t}catch(e){let n=document.querySelector("#page, main")??document.body;
throw n.querySelector(".absent")?.remove(),n.prepend(u("p",{class:"card problem",role:"alert"},e instanceof WebAssembly.CompileError||/WebAssembly/.test(String(
e))?"This page plays by WebAssembly, which is forbidden where it lies ('wasm-unsafe-eval' is missing in the content policy): save the file, and open it from you\
r disk.":`The page could not start: ${String(e)}`)),e}finally{document.body.dataset.ready="true"}}var Hr=()=>["file:","http:","https:"].includes(location.protocol);var jr=()=>document.documentElement.dataset.theme==="dark";function it(t){document.documentElement.dataset.theme=t?"dark":"light"}var Rn=()=>it(!jr());if(typeof document<
"u"){let t=matchMedia("(prefers-color-scheme: dark)");t.addEventListener("change",()=>it(t.matches)),it(t.matches);let e=!1;addEventListener("beforeprint",()=>{
e=jr(),it(!1)}),addEventListener("afterprint",()=>it(e))}function Gr(){return u("button",{type:"button",title:"Light or dark (D)","aria-label":"Light or dark",onclick:Rn},
"◐")}var Vr=(t,e,...n)=>u("header",{class:"top"},u("div",{},u("h1",{},t),e?u("p",{class:"lead"},e):null),u("div",{class:"tools"},...n,Gr()));var Ba=2n**64n-1n;function lt(t,e,n){let r=new URLSearchParams(t.replace(/^#/,"")),o=(c,m,p)=>{let d=r.get(c)??"";return/^\d{1,9}$/.test(d)&&Number(d)<m?Number(
d):p},s=o("run",e.length,n.run),[a,i]=e[s].payoff.shape,l=r.get("seed")??"";return{run:s,pursuer:o("pursuers",a,Math.min(n.pursuer,a-1)),evader:o("evaders",i,Math.
min(n.evader,i-1)),episode:o("episode",1/0,n.episode),seed:/^\d{1,20}$/.test(l)&&BigInt(l)<=Ba?l:null,step:o("step",1/0,0)}}function Yr(t,e,n){let r="",o=JSON.stringify(
e.selected),s=-800,a=()=>{let{run:i,pursuer:l,evader:c,episode:m,seed:p}=e.selected,d={run:i,pursuers:l,evaders:c,episode:m,...p===null?{}:{seed:p},step:n.player.
step},h=JSON.stringify(e.selected),f=h!==o&&performance.now()-s>800;h!==o&&(o=h,s=performance.now()),r=`#${Object.entries(d).map(([g,y])=>`${g}=${y}`).join("&")}`;
try{f?history.pushState(null,"",r):history.replaceState(null,"",r)}catch{}};a(),e.on("match",a),n.player.addEventListener("state",()=>n.player.playing||a()),n.player.
addEventListener("step",()=>n.player.playing||a()),window.addEventListener("hashchange",()=>{if(location.hash===r)return;let{step:i,...l}=lt(location.hash,t,e.selected);
for(let c of document.querySelectorAll("dialog[open]"))c.close();o=JSON.stringify(l),e.select(l),n.goTo(i)})}var Ha=5e3,Kr=8e3;function qr(t,e,n){let r=-Kr;for(let o of[
"pointerdown","pointermove","keydown","wheel"])window.addEventListener(o,()=>r=performance.now(),{passive:!0});setInterval(()=>{if(n()||performance.now()-r<Kr)return;
let{run:o,pursuer:s,evader:a}=e.selected,[i,l]=t[o].payoff.shape;s===i-1&&a===l-1&&history.replaceState(null,"",`#run=${o}`),location.reload()},Ha)}var N=Uint8Array,ne=Uint16Array,Un=Int32Array,$t=new N([0,0,0,0,0,0,0,0,1,1,1,1,2,2,2,2,3,3,3,3,4,4,4,4,5,5,5,5,0,0,0,0]),Pt=new N([0,0,0,0,1,1,2,2,3,3,4,4,5,5,
6,6,7,7,8,8,9,9,10,10,11,11,12,12,13,13,0,0]),_n=new N([16,17,18,0,8,7,9,6,10,5,11,4,12,3,13,2,14,1,15]),to=function(t,e){for(var n=new ne(31),r=0;r<31;++r)n[r]=
e+=1<<t[r-1];for(var o=new Un(n[30]),r=1;r<30;++r)for(var s=n[r];s<n[r+1];++s)o[s]=s-n[r]<<5|r;return{b:n,r:o}},no=to($t,2),ro=no.b,Nn=no.r;ro[28]=258,Nn[258]=28;
var oo=to(Pt,0),ja=oo.b,Zr=oo.r,Ln=new ne(32768);for(E=0;E<32768;++E)ye=(E&43690)>>1|(E&21845)<<1,ye=(ye&52428)>>2|(ye&13107)<<2,ye=(ye&61680)>>4|(ye&3855)<<4,Ln[E]=
((ye&65280)>>8|(ye&255)<<8)>>1;var ye,E,pe=(function(t,e,n){for(var r=t.length,o=0,s=new ne(e);o<r;++o)t[o]&&++s[t[o]-1];var a=new ne(e);for(o=1;o<e;++o)a[o]=a[o-
1]+s[o-1]<<1;var i;if(n){i=new ne(1<<e);var l=15-e;for(o=0;o<r;++o)if(t[o])for(var c=o<<4|t[o],m=e-t[o],p=a[t[o]-1]++<<m,d=p|(1<<m)-1;p<=d;++p)i[Ln[p]>>l]=c}else
for(i=new ne(r),o=0;o<r;++o)t[o]&&(i[o]=Ln[a[t[o]-1]++]>>15-t[o]);return i}),Se=new N(288);for(E=0;E<144;++E)Se[E]=8;var E;for(E=144;E<256;++E)Se[E]=9;var E;for(E=
256;E<280;++E)Se[E]=7;var E;for(E=280;E<288;++E)Se[E]=8;var E,mt=new N(32);for(E=0;E<32;++E)mt[E]=5;var E,Ga=pe(Se,9,0),Va=pe(Se,9,1),Ka=pe(mt,5,0),Ya=pe(mt,5,1),
On=function(t){for(var e=t[0],n=1;n<t.length;++n)t[n]>e&&(e=t[n]);return e},ce=function(t,e,n){var r=e/8|0;return(t[r]|t[r+1]<<8)>>(e&7)&n},$n=function(t,e){var n=e/
8|0;return(t[n]|t[n+1]<<8|t[n+2]<<16)>>(e&7)},Fn=function(t){return(t+7)/8|0},Dn=function(t,e,n){return(e==null||e<0)&&(e=0),(n==null||n>t.length)&&(n=t.length),
new N(t.subarray(e,n))};var qa=["unexpected EOF","invalid block type","invalid length/literal","invalid distance","stream finished","no stream handler",,"no callback","invalid UTF-8 da\
ta","extra field too long","date not in range 1980-2099","filename too long","stream finishing","invalid zip data"],q=function(t,e,n){var r=new Error(e||qa[t]);
if(r.code=t,Error.captureStackTrace&&Error.captureStackTrace(r,q),!n)throw r;return r},Za=function(t,e,n,r){var o=t.length,s=r?r.length:0;if(!o||e.f&&!e.l)return n||
new N(0);var a=!n,i=a||e.i!=2,l=e.i;a&&(n=new N(o*3));var c=function(Qe){var et=n.length;if(Qe>et){var Ie=new N(Math.max(et*2,Qe));Ie.set(n),n=Ie}},m=e.f||0,p=e.
p||0,d=e.b||0,h=e.l,f=e.d,g=e.m,y=e.n,v=o*8;do{if(!h){m=ce(t,p,1);var x=ce(t,p+1,3);if(p+=3,x)if(x==1)h=Va,f=Ya,g=9,y=5;else if(x==2){var C=ce(t,p,31)+257,R=ce(
t,p+10,15)+4,A=C+ce(t,p+5,31)+1;p+=14;for(var M=new N(A),F=new N(19),I=0;I<R;++I)F[_n[I]]=ce(t,p+I*3,7);p+=R*3;for(var H=On(F),ve=(1<<H)-1,Q=pe(F,H,1),I=0;I<A;){
var V=Q[ce(t,p,ve)];p+=V&15;var b=V>>4;if(b<16)M[I++]=b;else{var D=0,P=0;for(b==16?(P=3+ce(t,p,3),p+=2,D=M[I-1]):b==17?(P=3+ce(t,p,7),p+=3):b==18&&(P=11+ce(t,p,
127),p+=7);P--;)M[I++]=D}}var K=M.subarray(0,C),z=M.subarray(C);g=On(K),y=On(z),h=pe(K,g,1),f=pe(z,y,1)}else q(1);else{var b=Fn(p)+4,S=t[b-4]|t[b-3]<<8,T=b+S;if(T>
o){l&&q(0);break}i&&c(d+S),n.set(t.subarray(b,T),d),e.b=d+=S,e.p=p=T*8,e.f=m;continue}if(p>v){l&&q(0);break}}i&&c(d+131072);for(var Xe=(1<<g)-1,se=(1<<y)-1,ge=p;;ge=
p){var D=h[$n(t,p)&Xe],ee=D>>4;if(p+=D&15,p>v){l&&q(0);break}if(D||q(2),ee<256)n[d++]=ee;else if(ee==256){ge=p,h=null;break}else{var te=ee-254;if(ee>264){var I=ee-
257,_=$t[I];te=ce(t,p,(1<<_)-1)+ro[I],p+=_}var me=f[$n(t,p)&se],Ne=me>>4;me||q(3),p+=me&15;var z=ja[Ne];if(Ne>3){var _=Pt[Ne];z+=$n(t,p)&(1<<_)-1,p+=_}if(p>v){l&&
q(0);break}i&&c(d+131072);var Le=d+te;if(d<z){var Mt=s-z,At=Math.min(z,Le);for(Mt+d<0&&q(3);d<At;++d)n[d]=r[Mt+d]}for(;d<Le;++d)n[d]=n[d-z]}}e.l=h,e.p=ge,e.b=d,
e.f=m,h&&(m=1,e.m=g,e.d=f,e.n=y)}while(!m);return d!=n.length&&a?Dn(n,0,d):n.subarray(0,d)},be=function(t,e,n){n<<=e&7;var r=e/8|0;t[r]|=n,t[r+1]|=n>>8},ct=function(t,e,n){
n<<=e&7;var r=e/8|0;t[r]|=n,t[r+1]|=n>>8,t[r+2]|=n>>16},Pn=function(t,e){for(var n=[],r=0;r<t.length;++r)t[r]&&n.push({s:r,f:t[r]});var o=n.length,s=n.slice();if(!o)
return{t:ao,l:0};if(o==1){var a=new N(n[0].s+1);return a[n[0].s]=1,{t:a,l:1}}n.sort(function(T,C){return T.f-C.f}),n.push({s:-1,f:25001});var i=n[0],l=n[1],c=0,
m=1,p=2;for(n[0]={s:-1,f:i.f+l.f,l:i,r:l};m!=o-1;)i=n[n[c].f<n[p].f?c++:p++],l=n[c!=m&&n[c].f<n[p].f?c++:p++],n[m++]={s:-1,f:i.f+l.f,l:i,r:l};for(var d=s[0].s,r=1;r<
o;++r)s[r].s>d&&(d=s[r].s);var h=new ne(d+1),f=In(n[m-1],h,0);if(f>e){var r=0,g=0,y=f-e,v=1<<y;for(s.sort(function(C,R){return h[R.s]-h[C.s]||C.f-R.f});r<o;++r){
var x=s[r].s;if(h[x]>e)g+=v-(1<<f-h[x]),h[x]=e;else break}for(g>>=y;g>0;){var b=s[r].s;h[b]<e?g-=1<<e-h[b]++-1:++r}for(;r>=0&&g;--r){var S=s[r].s;h[S]==e&&(--h[S],
++g)}f=e}return{t:new N(h),l:f}},In=function(t,e,n){return t.s==-1?Math.max(In(t.l,e,n+1),In(t.r,e,n+1)):e[t.s]=n},Jr=function(t){for(var e=t.length;e&&!t[--e];)
;for(var n=new ne(++e),r=0,o=t[0],s=1,a=function(l){n[r++]=l},i=1;i<=e;++i)if(t[i]==o&&i!=e)++s;else{if(!o&&s>2){for(;s>138;s-=138)a(32754);s>2&&(a(s>10?s-11<<5|
28690:s-3<<5|12305),s=0)}else if(s>3){for(a(o),--s;s>6;s-=6)a(8304);s>2&&(a(s-3<<5|8208),s=0)}for(;s--;)a(o);s=1,o=t[i]}return{c:n.subarray(0,r),n:e}},ut=function(t,e){
for(var n=0,r=0;r<e.length;++r)n+=t[r]*e[r];return n},so=function(t,e,n){var r=n.length,o=Fn(e+2);t[o]=r&255,t[o+1]=r>>8,t[o+2]=t[o]^255,t[o+3]=t[o+1]^255;for(var s=0;s<
r;++s)t[o+s+4]=n[s];return(o+4+r)*8},Xr=function(t,e,n,r,o,s,a,i,l,c,m){be(e,m++,n),++o[256];for(var p=Pn(o,15),d=p.t,h=p.l,f=Pn(s,15),g=f.t,y=f.l,v=Jr(d),x=v.c,
b=v.n,S=Jr(g),T=S.c,C=S.n,R=new ne(19),A=0;A<x.length;++A)++R[x[A]&31];for(var A=0;A<T.length;++A)++R[T[A]&31];for(var M=Pn(R,7),F=M.t,I=M.l,H=19;H>4&&!F[_n[H-1]];--H)
;var ve=c+5<<3,Q=ut(o,Se)+ut(s,mt)+a,V=ut(o,d)+ut(s,g)+a+14+3*H+ut(R,F)+2*R[16]+3*R[17]+7*R[18];if(l>=0&&ve<=Q&&ve<=V)return so(e,m,t.subarray(l,l+c));var D,P,K,
z;if(be(e,m,1+(V<Q)),m+=2,V<Q){D=pe(d,h,0),P=d,K=pe(g,y,0),z=g;var Xe=pe(F,I,0);be(e,m,b-257),be(e,m+5,C-1),be(e,m+10,H-4),m+=14;for(var A=0;A<H;++A)be(e,m+3*A,
F[_n[A]]);m+=3*H;for(var se=[x,T],ge=0;ge<2;++ge)for(var ee=se[ge],A=0;A<ee.length;++A){var te=ee[A]&31;be(e,m,Xe[te]),m+=F[te],te>15&&(be(e,m,ee[A]>>5&127),m+=
ee[A]>>12)}}else D=Ga,P=Se,K=Ka,z=mt;for(var A=0;A<i;++A){var _=r[A];if(_>255){var te=_>>18&31;ct(e,m,D[te+257]),m+=P[te+257],te>7&&(be(e,m,_>>23&31),m+=$t[te]);
var me=_&31;ct(e,m,K[me]),m+=z[me],me>3&&(ct(e,m,_>>5&8191),m+=Pt[me])}else ct(e,m,D[_]),m+=P[_]}return ct(e,m,D[256]),m+P[256]},Ja=new Un([65540,131080,131088,
131104,262176,1048704,1048832,2114560,2117632]),ao=new N(0),Xa=function(t,e,n,r,o,s){var a=s.z||t.length,i=new N(r+a+5*(1+Math.ceil(a/7e3))+o),l=i.subarray(r,i.
length-o),c=s.l,m=(s.r||0)&7;if(e){m&&(l[0]=s.r>>3);for(var p=Ja[e-1],d=p>>13,h=p&8191,f=(1<<n)-1,g=s.p||new ne(32768),y=s.h||new ne(f+1),v=Math.ceil(n/3),x=2*v,
b=function(gn){return(t[gn]^t[gn+1]<<v^t[gn+2]<<x)&f},S=new Un(25e3),T=new ne(288),C=new ne(32),R=0,A=0,M=s.i||0,F=0,I=s.w||0,H=0;M+2<a;++M){var ve=b(M),Q=M&32767,
V=y[ve];if(g[Q]=V,y[ve]=Q,I<=M){var D=a-M;if((R>7e3||F>24576)&&(D>423||!c)){m=Xr(t,l,0,S,T,C,A,F,H,M-H,m),F=R=A=0,H=M;for(var P=0;P<286;++P)T[P]=0;for(var P=0;P<
30;++P)C[P]=0}var K=2,z=0,Xe=h,se=Q-V&32767;if(D>2&&ve==b(M-se))for(var ge=Math.min(d,D)-1,ee=Math.min(32767,M),te=Math.min(258,D);se<=ee&&--Xe&&Q!=V;){if(t[M+K]==
t[M+K-se]){for(var _=0;_<te&&t[M+_]==t[M+_-se];++_);if(_>K){if(K=_,z=se,_>ge)break;for(var me=Math.min(se,_-2),Ne=0,P=0;P<me;++P){var Le=M-se+P&32767,Mt=g[Le],At=Le-
Mt&32767;At>Ne&&(Ne=At,V=Le)}}}Q=V,V=g[Q],se+=Q-V&32767}if(z){S[F++]=268435456|Nn[K]<<18|Zr[z];var Qe=Nn[K]&31,et=Zr[z]&31;A+=$t[Qe]+Pt[et],++T[257+Qe],++C[et],
I=M+K,++R}else S[F++]=t[M],++T[t[M]]}}for(M=Math.max(M,I);M<a;++M)S[F++]=t[M],++T[t[M]];m=Xr(t,l,c,S,T,C,A,F,H,M-H,m),c||(s.r=m&7|l[m/8|0]<<3,m-=7,s.h=y,s.p=g,s.
i=M,s.w=I)}else{for(var M=s.w||0;M<a+c;M+=65535){var Ie=M+65535;Ie>=a&&(l[m/8|0]=c,Ie=a),m=so(l,m+1,t.subarray(M,Ie))}s.i=a}return Dn(i,0,r+Fn(m)+o)},Qa=(function(){
for(var t=new Int32Array(256),e=0;e<256;++e){for(var n=e,r=9;--r;)n=(n&1&&-306674912)^n>>>1;t[e]=n}return t})(),ei=function(){var t=-1;return{p:function(e){for(var n=t,
r=0;r<e.length;++r)n=Qa[n&255^e[r]]^n>>>8;t=n},d:function(){return~t}}};var ti=function(t,e,n,r,o){if(!o&&(o={l:1},e.dictionary)){var s=e.dictionary.subarray(-32768),a=new N(s.length+t.length);a.set(s),a.set(t,s.length),t=a,o.w=s.length}
return Xa(t,e.level==null?6:e.level,e.mem==null?o.l?Math.ceil(Math.max(8,Math.min(13,Math.log(t.length)))*1.5):20:12+e.mem,n,r,o)},io=function(t,e){var n={};for(var r in t)
n[r]=t[r];for(var r in e)n[r]=e[r];return n};var B=function(t,e,n){for(;n;++e)t[e]=n,n>>>=8};var ni=function(t,e){return((t[0]&15)!=8||t[0]>>4>7||(t[0]<<8|t[1])%31)&&q(6,"invalid zlib data"),(t[1]>>5&1)==+!e&&q(6,"invalid zlib data: "+(t[1]&32?"need":"u\
nexpected")+" dictionary"),(t[1]>>3&4)+2};function ri(t,e){return ti(t,e||{},0,0)}function lo(t,e){return Za(t.subarray(ni(t,e&&e.dictionary),-4),{i:2},e&&e.out,e&&e.dictionary)}var co=function(t,e,n,r){for(var o in t){var s=t[o],a=e+o,i=r;Array.isArray(s)&&(i=io(r,s[1]),s=s[0]),s instanceof N?n[a]=[s,i]:(n[a+="/"]=[new N(0),i],co(s,a,n,
r))}},Qr=typeof TextEncoder<"u"&&new TextEncoder,oi=typeof TextDecoder<"u"&&new TextDecoder,si=0;try{oi.decode(ao,{stream:!0}),si=1}catch{}function Ot(t,e){if(e){for(var n=new N(t.length),r=0;r<t.length;++r)n[r]=t.charCodeAt(r);return n}if(Qr)return Qr.encode(t);for(var o=t.length,s=new N(t.length+
(t.length>>1)),a=0,i=function(m){s[a++]=m},r=0;r<o;++r){if(a+5>s.length){var l=new N(a+8+(o-r<<1));l.set(s),s=l}var c=t.charCodeAt(r);c<128||e?i(c):c<2048?(i(192|
c>>6),i(128|c&63)):c>55295&&c<57344?(c=65536+(c&1047552)|t.charCodeAt(++r)&1023,i(240|c>>18),i(128|c>>12&63),i(128|c>>6&63),i(128|c&63)):(i(224|c>>12),i(128|c>>
6&63),i(128|c&63))}return Dn(s,0,a)}var Wn=function(t){var e=0;if(t)for(var n in t){var r=t[n].length;r>65535&&q(9),e+=r+4}return e},eo=function(t,e,n,r,o,s,a,i){var l=r.length,c=n.extra,m=i&&i.length,
p=Wn(c);B(t,e,a!=null?33639248:67324752),e+=4,a!=null&&(t[e++]=20,t[e++]=n.os),t[e]=20,e+=2,t[e++]=n.flag<<1|(s<0&&8),t[e++]=o&&8,t[e++]=n.compression&255,t[e++]=
n.compression>>8;var d=new Date(n.mtime==null?Date.now():n.mtime),h=d.getFullYear()-1980;if((h<0||h>119)&&q(10),B(t,e,h<<25|d.getMonth()+1<<21|d.getDate()<<16|d.
getHours()<<11|d.getMinutes()<<5|d.getSeconds()>>1),e+=4,s!=-1&&(B(t,e,n.crc),B(t,e+4,s<0?-s-2:s),B(t,e+8,n.size)),B(t,e+12,l),B(t,e+14,p),e+=16,a!=null&&(B(t,e,
m),B(t,e+6,n.attrs),B(t,e+10,a),e+=14),t.set(r,e),e+=l,p)for(var f in c){var g=c[f],y=g.length;B(t,e,+f),B(t,e+2,y),t.set(g,e+4),e+=4+y}return m&&(t.set(i,e),e+=
m),e},ai=function(t,e,n,r,o){B(t,e,101010256),B(t,e+8,n),B(t,e+10,n),B(t,e+12,r),B(t,e+16,o)};function uo(t,e){e||(e={});var n={},r=[];co(t,"",n,e);var o=0,s=0;for(var a in n){var i=n[a],l=i[0],c=i[1],m=c.level==0?0:8,p=Ot(a),d=p.length,h=c.comment,f=h&&
Ot(h),g=f&&f.length,y=Wn(c.extra);d>65535&&q(11);var v=m?ri(l,c):l,x=v.length,b=ei();b.p(l),r.push(io(c,{size:l.length,crc:b.d(),c:v,f:p,m:f,u:d!=a.length||f&&h.
length!=g,o,compression:m})),o+=30+d+y+x,s+=76+2*(d+y)+(g||0)+x}for(var S=new N(s+22),T=o,C=s-o,R=0;R<r.length;++R){var p=r[R];eo(S,p.o,p,p.f,p.u,p.c.length);var A=30+
p.f.length+Wn(p.extra);S.set(p.c,p.o+A),eo(S,o,p,p.f,p.u,p.c.length,p.o,p.m),o+=16+A+(p.m?p.m.length:0)}return ai(S,o,r.length,C,T),S}var W=["pursuer","evader"],Ce=t=>t==="pursuer"?"evader":"pursuer";var ii={teams:{pursuer:"pursuers",evader:"evaders"},generation:{pursuer:"pursuer generation",evader:"evader generation"},score:"capture rate",means:{pursuer:"ca\
ptures",evader:"escapes"},curves:{pursuer:"captures",evader:"escapes"},ends:["0 all escape","1 all caught"],lead:"Each cell is a match between two generations: \
the brighter, the more evaders are captured. Click one to watch it.",click:"watch its match"},mo=([t,e])=>({teams:{pursuer:t,evader:e},generation:{pursuer:`gene\
ration of ${t}`,evader:`generation of ${e}`},score:`score of the ${t}`,means:{pursuer:t,evader:e},curves:{pursuer:"scores",evader:"scores"},ends:[`0 the ${e} wi\
n`,`1 the ${t} win`],lead:`Each cell is a pair of generations: the brighter, the higher the score of the ${t}. Click one to see more of it.`,click:"see more of \
it"}),li=["0 worst","1 best"],ci=t=>({...mo([t,t]),generation:{pursuer:`generation of ${t}`,evader:"generation of the opponent"},score:"score",ends:["0 loses","\
1 wins"],lead:`Each cell is a pair of generations of ${t}: the brighter, the higher the score of the row. Click one to see more of it.`}),ke=({game:t})=>t&&t.teams[0]===
t.teams[1]?W.slice(0,1):W,k=t=>{if(!t.game)return ii;let e=ke(t).length===1?ci(t.game.teams[0]):mo(t.game.teams);return t.payoff?.others?{...e,ends:li}:e},U=(t,e,n)=>`${k(
t).teams[e]} of generation ${n}`;var ho=()=>JSON.parse(Wt("data"));function Me(t,e,n){let r=e-t.payoff.first[0],o=n-t.payoff.first[1],s=t.payoff.capture_rate[r]?.[o];return s===void 0?null:{rate:s,
rates:t.payoff.capture_rates[r][o],lengths:t.payoff.lengths[r]?.[o]??[]}}function Be(t,e,n){let{script:r,policy:o,kept:s,genomes:a}=t.teams[e];if(r!==null||o===
null)return"";if(!s.includes(n))return`The page holds no genome of ${U(t,e,n)}: it would be too large. Choose a generation of ${s.join(", ")}.`;let i=s.length*o.
genome_size;return fo(a,o.genome_size).length===i?"":`The page is damaged: it does not hold the ${i} numbers of the ${e}s' genomes. Write it again from its run.`}
function Z(t,e,n){let{script:r,policy:o,kept:s,genomes:a}=t.teams[e];if(r!==null||o===null)return r??"random";let i=s.indexOf(n);if(i<0)throw new RangeError(`${e}\
: expected a generation whose genome the page holds, got ${n}`);let l=o.genome_size,c=fo(a,l).subarray(i*l,(i+1)*l);return{...o,genome:c}}var _t=({teams:t},e)=>(t[e].
policy??{kind:"cells"}).kind!=="cells";function Nt({teams:t},e,n){let{kept:r,expressions:o,weights:s}=t[e],a=r.indexOf(n),i=o?.[a];return i?{expression:i,weights:s?.[a]??
null}:null}function Lt(t,e){return t.kind==="program"?e?.weights??null:t.hidden.length?null:Object.fromEntries(t.inputs.map((n,r)=>[n,t.genome[r]]))}function It(t,e,{
pursuer:n,evader:r,episode:o,seed:s}){let a=e.seeds[n][r];return t.match(e.world,Z(e,"pursuer",n),Z(e,"evader",r),BigInt(s??a),o)}var zn=4,po=new Map;function fo(t,e){let n=po.get(t);if(n)return n;let r=new Float32Array;try{let o=mi(Bn(t),e);o.every(Number.isFinite)&&(r=o)}catch(o){if(!(o instanceof DOMException||
o instanceof RangeError||ui(o)))throw o}return po.set(t,r),r}var ui=t=>t instanceof Error&&"code"in t;function mi(t,e){let n=lo(t),r=n.length/zn,o=new Uint8Array(
n.length);for(let a=0;a<o.length;a++)o[a]=n[a%zn*r+Math.floor(a/zn)];let s=new Uint32Array(o.buffer);for(let a=e;a<s.length;a++)s[a]^=s[a-e];return new Float32Array(
o.buffer)}function Bn(t){let e=atob(Wt(t)),n=new Uint8Array(e.length);for(let r=0;r<n.length;r++)n[r]=e.charCodeAt(r);return n}var Wt=t=>document.getElementById(
t)?.textContent??"";var pt=[.5,1,2,4,8,16,32,64],Ut=0,Ft=12,pi=2,He=class extends EventTarget{#e;#n;#t;#r=0;#i=0;#s=!1;#u=null;#f=0;#h=[];#m=[];glide=.28;constructor(e,{speed:n=4,still:r=!1}={}){
super(),this.#e=e,this.#n=n,this.#t=r}get step(){return this.#r}get time(){return this.#t?this.#r:this.#i}get arrived(){return this.#i===this.#r}get playing(){return this.#s}get length(){
return this.#e}set length(e){this.#e=e,this.#r>e&&this.jump(e),this.#o("state")}get marks(){return this.#h}set marks(e){this.#h=e,this.#o("state")}get ticks(){return this.#m}set ticks(e){
this.#m=e,this.#o("state")}get pace(){return this.#n||Math.max(pi,this.#e/Ft)}get speed(){return this.#n}set speed(e){this.#n=e,this.#o("state")}changeSpeed(e){
let n=pt.findIndex(r=>r>=this.pace);this.speed=pt[Math.min(pt.length-1,Math.max(0,n+e))]}play(){this.#s||!this.#e||(this.#r===this.#e&&this.jump(0),this.#s=!0,this.#o(
"state"),this.#c())}pause(){this.#s&&(this.#s=!1,this.#o("state"))}toggle(){this.#s?this.pause():this.play()}move(e){this.pause();let n=Math.min(this.#e,Math.max(
0,this.#r+e));Math.abs(n-this.#i)>1?this.jump(n):this.#p(n),this.#c()}jump(e){this.#i=Math.min(this.#e,Math.max(0,Math.round(e))),this.#p(this.#i),this.#o("fram\
e")}#p(e){e!==this.#r&&(this.#r=e,this.#o("step"),this.#t&&this.#o("frame"))}#c(){this.#u===null&&(this.#f=performance.now(),this.#u=requestAnimationFrame(()=>this.#a()))}#a(){
this.#u=null;let e=performance.now();this.#l(Math.min(.25,(e-this.#f)/1e3)),this.#f=e,(!this.#t||this.arrived)&&this.#o("frame"),(this.#s||this.#i!==this.#r)&&(this.#u=
requestAnimationFrame(()=>this.#a()))}#l(e){let n=e;for(;n>0;){if(this.#i===this.#r){if(!this.#s)return;if(this.#r===this.#e)return this.pause();this.#p(this.#r+
1)}let r=this.#s?this.pace:1/this.glide,o=this.#r-this.#i,s=Math.min(Math.abs(o),n*r);n-=s/r,this.#i=s===Math.abs(o)?this.#r:this.#i+Math.sign(o)*s}this.#s&&this.#i===
this.#e&&this.pause()}#o(e){this.dispatchEvent(new Event(e))}};function je(t,e){if(e.ctrlKey||e.metaKey||e.altKey)return!1;let n=e.shiftKey?10:1,o={" ":()=>t.toggle(),
ArrowRight:()=>t.move(n),ArrowLeft:()=>t.move(-n),Home:()=>t.move(-t.length),End:()=>t.move(t.length),"+":()=>t.changeSpeed(1),"-":()=>t.changeSpeed(-1)}[e.key];
return o?.(),o!==void 0}function go(t,e,...n){let r=u("dialog",{class:e,"aria-label":t,onclick:({target:o})=>o===r&&r.close()},u("div",{class:"dialog-head"},u("h2",{},t),u("button",{type:"\
button",class:"close","aria-label":"Close",onclick:()=>r.close()},"✕")),...n);return r}var yo=t=>u("dl",{class:"keys"},...t.flatMap(([e,n])=>[u("dt",{},...e.map(
r=>u("kbd",{},r))),u("dd",{},n)])),bo=t=>u("input",{type:"text",readonly:!0,"aria-label":t});function vo(t,e){t.value=e,t.hidden=!1,t.select(),navigator.clipboard?.
writeText(e).catch(()=>{})}function wo(t,e){let n=URL.createObjectURL(new Blob([e],{type:"application/octet-stream"}));u("a",{href:n,download:t}).click(),setTimeout(
()=>URL.revokeObjectURL(n),6e4)}var O=(t,e=2)=>t==null?"-":t.toFixed(e);function xo(t,e,n){return e===null||n===null?O(t):`${O(t)} (${O(e)} to ${O(n)})`}function dt(t){let e=Math.abs(t),n=e>=1e4?
e.toExponential(0):e.toFixed(e<100?2:0);return t<0&&Number(n)?`−${n}`:n}var So=t=>t.toLocaleString("en-GB"),de=t=>t.charAt(0).toUpperCase()+t.slice(1);function ht(t,e,n,r=!1){
let o=(e-t)/Math.max(1,n),s=10**Math.floor(Math.log10(o||1)),a=[1,2,5,10].map(c=>c*s).find(c=>c>=o)??10*s;r&&(a=Math.max(1,Math.round(a)));let i=Math.ceil(t/a-1e-9),
l=Math.floor(e/a+1e-9);return Array.from({length:Math.max(0,l-i+1)},(c,m)=>(i+m)*a)}var ft=[[68,1,84],[72,26,108],[71,47,125],[65,68,135],[57,86,140],[49,104,142],[42,120,142],[35,136,142],[31,152,139],[34,168,132],[53,183,121],[84,197,104],[122,
209,81],[165,219,54],[210,226,27],[253,231,37]];function Dt(t){let e=Math.min(1,Math.max(0,t))*(ft.length-1),n=Math.min(ft.length-2,Math.floor(e)),r=ft[n],o=ft[n+
1],s=a=>Math.round(r[a]+(e-n)*(o[a]-r[a]));return[s(0),s(1),s(2)]}function Mo(t){let[e,n,r]=Dt(t).map(o=>((o/255+.055)/1.055)**2.4);return .2126*e+.7152*n+.0722*
r>.179?"#000":"#fff"}var Ao=t=>`rgb(${Dt(t).join(" ")})`,To=()=>`linear-gradient(to right, ${ft.map(t=>`rgb(${t.join(" ")})`).join(", ")})`;function zt(t,e,n){let r=devicePixelRatio||1;for(let[a,i]of Object.entries(n))t.style.setProperty(a,`${i}px`);t.width=Math.round(n.width*r),t.height=Math.round(
n.height*r);let o=t.getContext("2d"),s=Hn(e);!o||!s||(o.imageSmoothingEnabled=!1,o.drawImage(s,0,0,t.width,t.height))}function Hn(t){let[e,n]=t.shape,r=document.
createElement("canvas");r.width=n,r.height=e;let o=r.getContext("2d");if(!o)return null;let s=o.createImageData(n,e);return t.capture_rate.forEach((a,i)=>a.forEach(
(l,c)=>{let m=4*((e-1-i-t.first[0])*n+c+t.first[1]);s.data.set([...Dt(l),255],m)})),o.putImageData(s,0,0),r}function Bt(t,e,n,r=2){t.textContent=O(e,r),t.ariaLabel=
`${n}: ${t.textContent}`,e!==void 0&&(t.style.backgroundColor=Ao(e),t.style.color=Mo(e))}function Ge(t,e){let n=u("span",{class:"gradient"});return n.style.backgroundImage=
To(),u("p",{class:"scale-of-rates small muted"},t,n,e)}var di=84;function Eo(t,e){let n=t.map((s,a)=>hi(s,a,e)),r=u("nav",{class:"races","aria-label":"Runs"},...n.map(s=>s.button)),o=()=>n.forEach((s,a)=>s.update(a===
e.selected.run));return e.on("match hover",o),o(),r.hidden=t.length<2,r}function hi(t,e,n){let[r,o]=t.payoff.shape,s=!t.name.startsWith(t.schedule),a=di/Math.max(
r,o),i=u("canvas",{"aria-hidden":"true"});zt(i,t.payoff,{left:0,top:0,width:o*a,height:r*a});let l=u("span",{class:"place"}),c=u("button",{type:"button",class:"\
race",title:`${t.name} (key ${e+1})`,onclick:()=>jn(t,e,n)},u("span",{class:"small-matrix"},i,l),u("span",{class:"race-text"},u("strong",{},s?t.name:t.schedule),
u("span",{class:"small"},t.findings?t.findings.sentence:`${t.learning.map(p=>k(t).teams[p]).join(" and ")} against ${fi(t)}`),u("span",{class:"small muted"},`${s?
`${t.schedule}, `:""}seed ${t.seed}`)));return{button:c,update:p=>{c.setAttribute("aria-current",String(p));let d=n.hover.pursuer??n.selected.pursuer,h=n.hover.
evader??n.selected.evader;l.hidden=d>=r||h>=o,l.style.left=`${(h+.5)*a}px`,l.style.top=`${(r-d-.5)*a}px`}}}var fi=t=>t.teams.pursuer.script??t.teams.evader.script??
"another run";function jn(t,e,n){let[r,o]=t.payoff.shape,{pursuer:s,evader:a}=n.selected;n.select({run:e,pursuer:Math.min(s,r-1),evader:Math.min(a,o-1)})}var gi=t=>[[["Space"],"play or pause"],[["←","→"],"step back or forward; with Shift ten steps"],[["Home","End"],"first or last step"],[["+","−"],"faster o\
r slower"],[["N"],"next episode of the same pair; with Shift the one before"],[["R"],"another seed, not one of the evaluation"],[["O"],"the cell's own seed agai\
n"],[["P"],`next ${k(t).generation.pursuer}; with Shift the one before`],[["E"],`next ${k(t).generation.evader}; with Shift the one before`],[["M"],`to the matr\
ix: arrow keys choose a ${t.game?"pair, Enter shows it":"match, Enter plays it"}`],[["A"],"next agent: what it sees; with Shift the one before"],[["Esc"],"no ag\
ent"],[["T"],"take over the chosen agent, or an evader, from this step on"],[["G"],"this step in the playground: any other rules, actions and places"],[["1","9"],
"first to ninth run"],[["D"],"light or dark"],[["?"],"this list"]],yi=["P","E","M","1","D","?"],bi="The page holds the genomes and the engine of this run. A cli\
ck on a cell plays that very match: same seed, same moves. ";function Co(t){let e=t.find(({game:r})=>!r),n=gi(e??t[0]).filter(([[r]])=>e||yi.includes(r));return go(
"Keys","help",yo(n),u("p",{class:"muted small"},`${e?bi:""}The page loads nothing from elsewhere; share the file as it is.`))}function ko(t,e,n,r,o,s){let a=(l,c)=>()=>{
let m=t[e.selected.run].payoff.shape[l==="pursuer"?0:1];e.select({[l]:Math.min(m-1,Math.max(0,e.selected[l]+c))})},i={n:()=>e.select({episode:e.selected.episode+
1}),N:()=>e.select({episode:Math.max(0,e.selected.episode-1)}),r:()=>e.select({seed:String(crypto.getRandomValues(new BigUint64Array(1))[0]),episode:0}),o:()=>e.
select({seed:null,episode:0}),p:a("pursuer",1),P:a("pursuer",-1),e:a("evader",1),E:a("evader",-1),m:()=>document.getElementById("matrix")?.focus(),a:()=>n.inspector.
next(1),A:()=>n.inspector.next(-1),Escape:()=>n.inspector.choose(null),t:o,g:s,d:Rn,"?":()=>r.showModal()};document.addEventListener("keydown",l=>{let c=l.target instanceof
HTMLSelectElement||l.target instanceof HTMLInputElement,m=l.target instanceof HTMLButtonElement&&(l.key===" "||l.key==="Enter");if(document.querySelector("dialo\
g[open]")||c||m||l.defaultPrevented||l.ctrlKey||l.metaKey||l.altKey)return;let p=i[l.key]??i[l.key.toLowerCase()],d=Number(l.key)-1;if(je(n.player,l)||p)p?.();else if(t[d])
jn(t[d],d,e);else return;l.preventDefault()})}var Ve=[[0,0],[-1,0],[0,1],[1,0],[0,-1],[-1,1],[1,1],[1,-1],[-1,-1]];function Ro(t,e,n){let r=e[0]-t[0],o=e[1]-t[1];return!n&&Math.abs(r)>Math.abs(o)?o=0:n||(r=
0),Ve.findIndex(([s,a])=>s===Math.sign(r)&&a===Math.sign(o))}var Re=(t,e)=>e<t.nPursuers,$=(t,e)=>[t.positions[2*e],t.positions[2*e+1]],Gn=({rows:t,cols:e},[n,r])=>n>=
0&&r>=0&&n<t&&r<e,Vn=(t,e,n=3)=>t!==void 0&&[0,1,2].slice(0,n).some(r=>t[3*e+r]),Kn=(t,e)=>Vn(t.fault,e),Oo=(t,e)=>!Kn(t,e)&&Vn(t.involved,e,2);function Ht(t,e,n){
let r=$(t,n),o=$(e,n),s=r[0]!==o[0]||r[1]!==o[1],a=e.involved===void 0||Vn(e.involved,n);return!!(e.alive[n]&&e.actions?.[n]&&!s&&a)}function jt(t,e,n){let[r,o]=$(
t,n),[s,a]=Ve[e.actions?.[n]??0];return[r+s,o+a]}function gt(t,e,n){return Array.from({length:n.everCaptured.length},(o,s)=>s).filter(o=>n.everCaptured[o]&&!e.everCaptured[o]).
map(o=>t.nPursuers+o)}var $o=t=>t.moments.flatMap((e,n)=>n&&gt(t,t.moments[n-1],e).length?[n]:[]);function Gt(t,e){return Array.from({length:e.alive.length},(r,o)=>o).
filter(r=>t.alive[r]&&!e.alive[r])}var Po=[-.31,0,.31],_o=[{size:1,at:[[0,0]]},{size:.62,at:[[-.2,.2],[.2,-.2]]},{size:.54,at:[[-.23,.22],[.23,.22],[0,-.22]]},{size:.54,at:[[-.23,.23],[.23,.23],[
-.23,-.23],[.23,-.23]]},{size:.36,at:Po.flatMap(t=>Po.map(e=>[e,t]))}],vi=.3,wi=.35,xi=.55;function yt(t,e){let n=new Map;for(let r=0;r<e.alive.length;r++){if(!e.
alive[r])continue;let[o,s]=$(e,r),a=o*t.cols+s,i=n.get(a);i?i.push(r):n.set(a,[r])}return n}function No(t,e){let n=Array.from(e.alive,(r,o)=>{let[s,a]=$(e,o);return{
x:a+.5,y:s+.5,size:1,alpha:0}});for(let r of yt(t,e).values()){let o=_o[Math.min(r.length,_o.length)-1];r.forEach((s,a)=>{let[i,l]=o.at[Math.min(a,o.at.length-1)],
c=n[s];c.x+=i,c.y+=l,c.size=o.size,c.alpha=1})}return n}var Lo=t=>t*t*(3-2*t),Ke=(t,e,n)=>t+(e-t)*n,Io=t=>Math.min(1,Math.max(0,t));function Wo(t,e,n,r){let o={
SIMULTANEOUS:1,SWARM_TURNS:2,AGENT_TURNS:n}[t.interaction];if(o===1)return Lo(r);let s=o===n?e:+!Re(t,e),a=Math.max(1/o,wi);return Lo(Io((r-s/(o-1)*(1-a))/a))}function Vt(t,e){
let n=t.moments.length-1,r=Math.min(Math.floor(e),n),o=t.moments[r],s=No(t,o);if(r===n||e===r)return s;let a=t.moments[r+1],i=No(t,a);return s.map((l,c)=>{let m=Wo(
t,c,s.length,e-r);return Si(o,a,c,l,i[c],m)})}function Yn(t,e,n){let r=t.moments.length-1,o=Math.min(Math.floor(n),r),s=t.moments[o],a=t.moments[Math.min(o+1,r)],
i=Wo(t,e,s.alive.length,n-o),[l,c]=$(s,e),[m,p]=$(a,e);return[Ke(c,p,i)+.5,Ke(l,m,i)+.5]}function Si(t,e,n,r,o,s){let a=r.alpha>o.alpha,i={x:Ke(r.x,o.x,s),y:Ke(
r.y,o.y,s),size:a?r.size:Ke(r.size,o.size,s),alpha:a?Io((1-s)/(1-xi)):Ke(r.alpha,o.alpha,s)};if(Ht(t,e,n)){let[l,c]=$(t,n),[m,p]=jt(t,e,n),d=vi*Math.sin(Math.PI*
s);i.x+=(p-c)*d,i.y+=(m-l)*d}return i}var Uo=2*Math.PI;function Oe(t,e,n,r){t.beginPath(),t.arc(e,n,r/2,0,Uo)}function Kt(t,e,n,r){let o=r/2,s=[[0,-.97],[.97,.83],[-.97,.83]].map(([a,i])=>[e+a*o,n+i*
o]);t.beginPath(),t.moveTo((s[2][0]+s[0][0])/2,(s[2][1]+s[0][1])/2),s.forEach(([a,i],l)=>{let[c,m]=s[(l+1)%3];t.arcTo(a,i,c,m,r*.09)}),t.closePath()}function Fo(t,e,n,r){
let o=r*.32;t.beginPath(),t.moveTo(e-o,n-o),t.lineTo(e+o,n+o),t.moveTo(e+o,n-o),t.lineTo(e-o,n+o)}function Do(t,e,n,r){t.beginPath();for(let o=0;o<16;o++){let s=r/
2*(o%2?.6:.95),a=Uo*o/16;t.lineTo(e+s*Math.sin(a),n-s*Math.cos(a))}t.closePath()}function zo(t,e,n,r,o,s){let a=Math.atan2(o-n,r-e);t.beginPath(),t.moveTo(e,n),
t.lineTo(r,o);for(let i of[-1,1])t.moveTo(r,o),t.lineTo(r-s*Math.cos(a+i*.6),o-s*Math.sin(a+i*.6))}var Bo=4,Mi=1.6,Ai=.95,Ti=5,Ei=.16,Ci=9,ki=.09,Ri=.2,Ho=.75,j=(t,e)=>t.left+e*t.cell,G=(t,e)=>t.top+e*t.cell;function Ye(t,e,n){return Re(e,n)?t.colors.pursuer:
t.colors.evader}function Yt({ctx:t,colors:e},n,r,o,s,a,i=0){t.font=`700 ${Math.round(s)}px system-ui, sans-serif`,t.textAlign="center",t.textBaseline="middle",t.
strokeStyle=e.paper,t.lineWidth=i,i&&t.strokeText(n,r,o),t.fillStyle=a,t.fillText(n,r,o)}function jo({ctx:t,grid:e,colors:n}){let{left:r,top:o,cell:s,rows:a,cols:i}=e,
l=i*s,c=a*s;if(t.fillStyle=n.paper,t.fillRect(r,o,l,c),s<Ti)return;t.fillStyle=n.line;let m=Math.max(1,Math.round(s/60));for(let p=1;p<i;p++)t.fillRect(r+p*s,o,
m,c);for(let p=1;p<a;p++)t.fillRect(r,o+p*s,l,m)}function Go({ctx:t,grid:e,colors:n},r){let{left:o,top:s,cell:a,rows:i,cols:l}=e;t.fillStyle=n.obstacle;for(let c=0;c<
i*l;c++){if(!r.obstacles[c])continue;let m=Math.floor(c/l),p=c%l;t.fillRect(o+p*a,s+m*a,a,a)}Vo({ctx:t,grid:e,colors:n})}function Vo({ctx:t,grid:{left:e,top:n,cell:r,
rows:o,cols:s},colors:a}){let i=Math.min(5,Math.max(2,Math.round(r/18)));t.strokeStyle=a.frame,t.lineWidth=i,t.strokeRect(e-i/2,n-i/2,s*r+i,o*r+i)}function Ko({
ctx:t,grid:e,colors:n},r){let{left:o,top:s,cell:a,rows:i,cols:l}=e,c=a<24*r?5:1;t.font=`500 ${Math.round(Math.min(15*r,Math.max(9*r,a*.32)))}px system-ui, sans-\
serif`,t.fillStyle=n.muted,t.textBaseline="alphabetic",t.textAlign="center";let m=5*r+a/40;for(let p=0;p<l;p+=c)t.fillText(String(p),o+(p+.5)*a,s-m);t.textAlign=
"right",t.textBaseline="middle";for(let p=0;p<i;p+=c)t.fillText(String(p),o-m,s+(p+.5)*a)}function Yo({grid:t},e,n,r){let o=Math.floor(e.fov/2)+.5,s=Math.max(0,
n-o),a=Math.min(t.cols,n+o),i=Math.max(0,r-o),l=Math.min(t.rows,r+o);return[j(t,s),G(t,i),(a-s)*t.cell,(l-i)*t.cell]}function qo(t,e,n,r){let{ctx:o,grid:s,colors:a}=t;
o.save(),o.beginPath(),o.rect(0,0,o.canvas.width,o.canvas.height),o.rect(...Yo(t,e,n,r)),o.clip("evenodd"),o.clearRect(0,0,o.canvas.width,o.canvas.height),o.fillStyle=
a.line,o.fillRect(s.left,s.top,s.cols*s.cell,s.rows*s.cell),o.restore(),Vo(t)}function Zo(t,{x:e,y:n,alpha:r},o){let{ctx:s,grid:a,colors:i}=t,l=Math.max(a.cell,
16*o)*1.06,c=j(a,e),m=G(a,n);s.globalAlpha=Math.max(r,.6),s.beginPath(),s.roundRect(c-l/2,m-l/2,l,l,l*.2),s.strokeStyle=i.focus,s.lineWidth=Math.max(2,2.5*o),s.
stroke();let p=Math.max(11*o,Math.min(18*o,a.cell*.5)),d=m-l/2<p*1.2,h=m+(d?1:-1)*(l/2+p*.7);s.lineJoin="round",Yt(t,"You",c,h,p,i.ink,p*.35),s.globalAlpha=1}function Jo(t,e,n,r,o){
let{ctx:s,grid:a}=t,i=Yo(t,e,r,o),l=Ye(t,e,n);s.globalAlpha=.11,s.fillStyle=l,s.fillRect(...i),s.globalAlpha=.8,s.strokeStyle=l,s.lineWidth=Math.max(1,a.cell/24),
s.strokeRect(...i),s.globalAlpha=1}function Xo(t,e,n,r,o){let{ctx:s,grid:a}=t,i=Math.min(Math.ceil(n),e.moments.length-1),l=e.moments[i];s.lineCap="round",s.lineWidth=
Math.min(Ci,Math.max(1,a.cell*Ei));for(let c=Math.max(1,Math.floor(n-r)+1);c<=i;c++){let m=e.moments[c-1],p=e.moments[c],d=Math.max(0,Math.min(1,(n-c)/r));s.globalAlpha=
Ho+(Ri-Ho)*d;for(let h=0;h<p.alive.length;h++){let f=c===i&&n<i;if(!m.alive[h]||!(l.alive[h]||f))continue;let g=(Re(e,h)?-1:1)*ki,[y,v]=$(m,h),[x,b]=$(p,h);if(y===
x&&v===b)continue;let S=f?o[h].x:b+.5,T=f?o[h].y:x+.5;s.strokeStyle=Ye(t,e,h),s.beginPath(),s.moveTo(j(a,v+.5+g),G(a,y+.5+g)),s.lineTo(j(a,S+g),G(a,T+g)),s.stroke()}}
s.globalAlpha=1}function Qo(t,e,n){let r=Math.min(Math.ceil(n),e.moments.length-1);for(let o=Math.max(1,r-Bo+1);o<=r;o++){let s=e.moments[o-1],a=e.moments[o],i=o>
n?Math.max(0,1-2*(o-n)):1-(n-o)/Bo,l=gt(e,s,a);for(let c of Gt(s,a))l.includes(c)||$i(t,$(a,c),i);for(let c of l)Oi(t,$(a,c),i)}t.ctx.globalAlpha=1}function Oi({
ctx:t,grid:e,colors:n},[r,o],s){t.globalAlpha=s,Do(t,j(e,o+.5),G(e,r+.5),Math.max(8,e.cell*Mi)),t.fillStyle=n.capture,t.fill(),t.strokeStyle=n.ink,t.lineWidth=Math.
max(1,e.cell/36),t.lineJoin="round",t.stroke()}function $i({ctx:t,grid:e,colors:n},[r,o],s){t.globalAlpha=s,Fo(t,j(e,o+.5),G(e,r+.5),Math.max(7,e.cell*Ai)),t.strokeStyle=
n.collision,t.lineWidth=Math.max(2,e.cell*.17),t.lineCap="round",t.stroke()}function es({ctx:t,grid:e,colors:n},r,o){let s=Math.max(1,e.cell*.07);t.strokeStyle=
t.fillStyle=n.collision,t.lineWidth=Math.max(1,e.cell*.05),t.setLineDash([e.cell*.14,e.cell*.1]);for(let[a,i]of r){if(a<0||i<0||a>=e.rows||i>=e.cols)continue;let l=[
j(e,i)+s,G(e,a)+s,e.cell-2*s,e.cell-2*s];t.globalAlpha=.2*o,t.fillRect(...l),t.globalAlpha=o,t.strokeRect(...l)}t.setLineDash([]),t.globalAlpha=1}function ts({ctx:t,
grid:e,colors:n},r,o,s,a){t.globalAlpha=a,Oe(t,j(e,r),G(e,o),Math.max(8,e.cell*s*1.02)),t.strokeStyle=n.collision,t.lineWidth=Math.max(1.5,e.cell*.085*Math.sqrt(
s)),t.stroke(),t.globalAlpha=1}var Pi=.8,_i=.92,Ni=15,Li=7,qn=9;function ns(t,e,n,r,o,s){r.forEach((a,i)=>{a.alpha>0&&Ii(t,e,n,i,a,o,s)}),t.ctx.globalAlpha=1;for(let a of yt(e,n).values())a.length>
qn&&Wi(t,r[a[qn-1]],a.length-qn+1)}function Ii(t,e,n,r,o,s,a){let{ctx:i,grid:l,colors:c}=t,m=Re(e,r),p=j(l,o.x),d=G(l,o.y),h=Math.max(4,l.cell*o.size*(m?_i:Pi)),
f=Ye(t,e,r),g=!m&&!!n.captured[r-e.nPursuers];if(i.globalAlpha=o.alpha,(m?Kt:Oe)(i,p,d,h),h>Li*a&&(i.strokeStyle=c.paper,i.lineWidth=Math.max(2,h*.1),i.stroke()),
i.fillStyle=g?c.paper:f,i.fill(),g&&(Oe(i,p,d,h*.82),i.strokeStyle=f,i.lineWidth=h*.18,i.stroke()),!s||h<Ni*a)return;let y=String(m?r:r-e.nPursuers),v=h*(m?.4:.5)*
(y.length>1?.8:1);Yt(t,y,p,d+h*(m?.17:.03),v,g?f:c.paper)}function Wi(t,e,n){let{cell:r}=t.grid;Yt(t,`+${n}`,j(t.grid,e.x),G(t.grid,e.y),r*.3,t.colors.ink,r*.1)}var Ui=.46,Fi=.86,Di=.66,rs=.48,zi=.78,Bi=.58;function os(t,e,n,r){let o=e.moments[n-1],s=e.moments[n];if(!o)return;let{ctx:a,grid:i,colors:l}=t;a.strokeStyle=l.
collision,a.lineWidth=Math.max(1.5,i.cell*.07),a.lineCap="butt",a.globalAlpha=r;for(let c=0;c<s.alive.length;c++)Ht(o,s,c)&&Hi(t,e,$(o,c),jt(o,s,c));a.globalAlpha=
1}function Hi({ctx:t,grid:e},n,r,o){let s=o[1]-r[1],a=o[0]-r[0],i=p=>j(e,r[1]+.5+s*p),l=p=>G(e,r[0]+.5+a*p),c=Gn(n,o)?zi:Bi;t.setLineDash([e.cell*.09,e.cell*.06]),
t.beginPath(),t.moveTo(i(rs),l(rs)),t.lineTo(i(c),l(c)),t.stroke(),t.setLineDash([]);let m=.17*e.cell/Math.hypot(s,a);t.beginPath(),t.moveTo(i(c)-a*m,l(c)+s*m),
t.lineTo(i(c)+a*m,l(c)-s*m),t.stroke()}function ss(t,e,n,r,o,s){let a=Ve[s];if(!s||!a)return;let{ctx:i,grid:l,colors:c}=t,m=Gn(e,[r[0]+a[0],r[1]+a[1]])?Fi:Di,p=Ui*
o.size,d=[j(l,o.x+a[1]*p),G(l,o.y+a[0]*p),j(l,o.x+a[1]*m),G(l,o.y+a[0]*m)],h=Math.max(1.5,l.cell*.085);i.lineCap=i.lineJoin="round";for(let[f,g]of[[c.paper,h*2.1],
[Ye(t,e,n),h]])i.strokeStyle=f,i.lineWidth=g,zo(i,...d,l.cell*.2),i.stroke()}var is={numbers:!0,axes:!1,trail:6,viewers:[],plan:null,selected:null,cursor:null,you:null,fog:!1};function ls(t,e,n,r,o){let{ctx:s,grid:a,colors:i}=t,l=Math.min(
Math.ceil(n),e.moments.length-1),c=e.moments[l],m=n===l,p=Vt(e,n),d=m?1:Math.max(0,1-2*(l-n));s.clearRect(0,0,s.canvas.width,s.canvas.height),jo(t);for(let g of r.
viewers)p[g]?.alpha&&Jo(t,e,g,...Yn(e,g,n));Go(t,e),r.axes&&Ko(t,o),Xo(t,e,n,r.trail,p),es(t,c.contested??[],d),Qo(t,e,n),os(t,e,l,d),p.forEach(({x:g,y,size:v},x)=>{
let b=Oo(c,x)?.4:0,S=Kn(c,x)?1:b;S&&ts(t,g,y,v,S*d)});let h=m?c:e.moments[Math.max(0,l-1)];if(ns(t,e,h,p,r.numbers,o),m&&r.plan)for(let[g,y]of p.entries())y.alpha&&
ss(t,e,g,$(c,g),y,r.plan[g]??0);r.you!==null&&(r.fog&&qo(t,e,...Yn(e,r.you,n)),Zo(t,p[r.you],o)),s.lineWidth=Math.max(2,2.5*o),s.strokeStyle=i.focus;let f=r.selected===
null?void 0:p[r.selected];f?.alpha&&as(t,f.x,f.y,f.size*.96),r.cursor&&(s.setLineDash([a.cell*.12,a.cell*.08]),as(t,r.cursor[1]+.5,r.cursor[0]+.5,.8),s.setLineDash(
[]))}function as({ctx:t,grid:e},n,r,o){let s=o*e.cell;t.beginPath(),t.roundRect(e.left+n*e.cell-s/2,e.top+r*e.cell-s/2,s,s,s*.1),t.stroke()}var cs=(t,e)=>(e+.24)/(t+.24);function us(t,e,n,r,o,s){let a=n?28*s:0,i=(c,m)=>(c-a)/(m+2*.12),l=Math.max(1,Math.floor(Math.min(i(r,e),i(o,t))));return{rows:t,cols:e,
cell:l,left:Math.round((r-e*l+a)/2),top:Math.round((o-t*l+a)/2)}}function ms(t,e,n){let r=Math.floor((n-t.top)/t.cell),o=Math.floor((e-t.left)/t.cell);return r>=
0&&r<t.rows&&o>=0&&o<t.cols?[r,o]:null}var ji=["paper","line","frame","ink","muted","obstacle"],Gi=["pursuer","evader","capture","collision","focus"];function qt(t){let e=getComputedStyle(t),n=(r,o)=>[
r,e.getPropertyValue(o+r).trim()];return Object.fromEntries([...ji.map(r=>n(r,"--board-")),...Gi.map(r=>n(r,"--"))])}var Ze=()=>matchMedia("(prefers-reduced-motion: reduce)").matches,qe=class{canvas;#e=null;#n=0;#t;#r={rows:1,cols:1,left:0,top:0,cell:1};#i=0;constructor(e,n={}){
this.canvas=e,e.classList.add("board"),e.setAttribute("role","img"),this.#t={...is,...n},new ResizeObserver(()=>this.#u()).observe(e),new MutationObserver(()=>this.
redraw()).observe(document.documentElement,{attributes:!0}),addEventListener("beforeprint",()=>this.drawNow())}set look(e){this.#t={...this.#t,...e},this.#s(),this.
redraw()}show(e,n){this.#e=e,this.#n=Math.min(Math.max(0,n),e.moments.length-1),this.#s(),this.redraw()}redraw(){this.#i||(this.#i=requestAnimationFrame(()=>this.
drawNow()))}drawNow(){cancelAnimationFrame(this.#i),this.#i=0;let e=this.canvas.getContext("2d");if(!e||!this.#e)return;let{rows:n,cols:r}=this.#e,o=devicePixelRatio||
1;this.#r=us(n,r,this.#t.axes,this.canvas.width,this.canvas.height,o);let s={ctx:e,grid:this.#r,colors:qt(this.canvas)};ls(s,this.#e,this.#n,this.#t,o)}cellAt(e,n){
let r=this.canvas.getBoundingClientRect(),o=this.canvas.width/r.width;return ms(this.#r,(e-r.left)*o,(n-r.top)*o)}agentAt(e,n){let r=this.cellAt(e,n);if(!r||!this.#e)
return null;let o=this.#e.moments[Math.round(this.#n)],s=yt(this.#e,o).get(r[0]*this.#e.cols+r[1])??[],a=Vt(this.#e,Math.round(this.#n)),i=l=>{let[c,m]=this.pointOf(
a[l].x,a[l].y);return Math.hypot(c-e,m-n)};return s.length?s.reduce((l,c)=>i(c)<i(l)?c:l):null}pointOf(e,n){let r=this.canvas.getBoundingClientRect(),o=r.width/
this.canvas.width,{left:s,top:a,cell:i}=this.#r;return[r.left+(s+e*i)*o,r.top+(a+n*i)*o]}#s(){if(!this.#e)return;let{rows:e,cols:n}=this.#e;this.canvas.style.setProperty(
"--board-aspect",String(cs(e,n)))}#u(){let e=devicePixelRatio||1,{width:n,height:r}=this.canvas.getBoundingClientRect();this.canvas.width=Math.max(1,Math.round(
n*e)),this.canvas.height=Math.max(1,Math.round(r*e)),this.drawNow()}};function Zn(t,e,n){let{rows:r,cols:o,n_pursuers:s,fov:a,rules:{interaction:i}}=t;return{rows:r,cols:o,nPursuers:s,fov:a,interaction:i,obstacles:e,moments:n}}function Jn(t,e){
return{positions:t.read("last_positions"),alive:t.read("alive"),captured:t.read("captured"),everCaptured:t.read("ever_captured"),actions:e,involved:t.read("invo\
lved"),fault:t.read("fault"),contested:t.conflicts().map(n=>n.cell)}}function ps(t){let e=Array.from({length:t.length+1},(n,r)=>Vi(t,r));return Zn(t.config,t.map,
e)}function Vi(t,e){let n=t.n_agents,r=t.config.n_evaders,o=(a,i,l)=>a.subarray(i*l,(i+1)*l),s={positions:o(t.last_positions,e,2*n),alive:o(t.alive,e,n),captured:o(
t.captured,e,r),everCaptured:o(t.ever_captured,e,r)};return e===0?s:{...s,actions:o(t.actions,e-1,n),involved:o(t.involved,e-1,3*n),fault:o(t.fault,e-1,3*n),get contested(){
return t.conflicts(e).map(a=>a.cell)}}}var Ki=Array.from({length:16},(t,e)=>{let n=e%2?6.5:11,r=Math.PI*e/8;return`${12+n*Math.sin(r)} ${12-n*Math.cos(r)}`}).join(" ");function ds(){let t=[["pursuer",
w("path",{d:"M12 3 22 20H2z",class:"filled-pursuer"})],["evader",w("circle",{cx:12,cy:12,r:9,class:"filled-evader"})],["capture",w("polygon",{points:Ki,class:"f\
illed-capture"})],["captured evader",w("circle",{cx:12,cy:12,r:7.5,class:"ring-evader"})],["conflict",w("rect",{x:3,y:3,width:18,height:18,class:"dashed-conflic\
t"})]];return u("ul",{class:"shapes small","aria-label":"Shapes on the board"},...t.map(([e,n])=>u("li",{},w("svg",{viewBox:"0 0 24 24","aria-hidden":"true"},n),
e)))}var Yi={first:"M6 5v14M19 5 9 12l10 7z",back:"M17 5 7 12l10 7z",play:"M7 4.5 19 12 7 19.5z",pause:"M8 5v14M16 5v14",forward:"M7 5l10 7-10 7z",last:"M18 5v14M5 5\
l10 7-10 7z"};function hs(t){return w("svg",{viewBox:"0 0 24 24","aria-hidden":"true",class:"icon"},w("path",{d:Yi[t]}))}function bt(t,e,n,r){return u("button",
{type:"button",class:"player-button","aria-label":e,title:`${e} (${n})`,onclick:r},hs(t))}function Zt(t){let e=bt("play","Play","Space",()=>t.toggle()),n=u("inp\
ut",{type:"range",class:"player-scrub",min:0,step:1,"aria-label":"Step",oninput:()=>{t.pause(),t.jump(Number(n.value))}}),r=u("div",{class:"captures","aria-hidd\
en":"true",title:"Captures"}),o=u("div",{class:"losses","aria-hidden":"true"}),s=u("select",{class:"player-speed","aria-label":"Speed",title:`Steps a second, or\
 the whole in ${Ft} s (+ and -)`,onchange:()=>t.speed=Number(s.value)},u("option",{value:Ut},`in ${Ft} s`),...pt.map(p=>u("option",{value:p},`${p} / s`))),a=u("\
output",{class:"player-count"}),i=u("div",{class:"player",role:"group","aria-label":"Player"},bt("first","First step","Home",()=>t.move(-t.length)),bt("back","S\
tep back","←",()=>t.move(-1)),e,bt("forward","Step forward","→",()=>t.move(1)),bt("last","Last step","End",()=>t.move(t.length)),u("div",{class:"scrub"},r,o,
n),a,s),l=(p,d={})=>{let h=u("i",d);return h.style.left=`${100*p/Math.max(1,t.length)}%`,h},c=()=>{r.replaceChildren(...t.marks.map(p=>l(p))),o.replaceChildren(
...t.ticks.map(({step:p,kind:d,size:h,text:f})=>{let g=l(p,{class:d,title:`Step ${p}: ${f}`});return g.style.height=`${100*h}%`,g}))},m=()=>{e.replaceChildren(hs(
t.playing?"pause":"play")),e.ariaLabel=t.playing?"Pause":"Play",e.title=`${e.ariaLabel} (Space)`,n.max=String(t.length),n.value=String(t.step),n.ariaValueText=`\
step ${t.step} of ${t.length}`,a.textContent=`${t.step} / ${t.length}`,a.style.minWidth=`${2*String(t.length).length+3}ch`,s.value=String(t.speed)};return t.addEventListener(
"step",m),t.addEventListener("state",m),t.addEventListener("state",c),i.addEventListener("keydown",p=>{!(p.target instanceof HTMLSelectElement||p.key===" "&&p.target!==
n)&&je(t,p)&&p.preventDefault()}),m(),i}var qi=40,Jt=class{element;#e;#n=u("div",{class:"episodes",role:"group","aria-label":"Episodes of this cell"});#t=u("p",{class:"check small numbers","aria-live":"\
polite"});constructor(e){this.#e=e,this.element=u("div",{class:"strip-of-episodes"},this.#n,this.#t)}show(e,n){let{pursuer:r,evader:o,episode:s,seed:a}=this.#e.
selected,i=Me(e,r,o);this.#n.replaceChildren(...(i?.rates??[]).slice(0,qi).map((d,h)=>this.#r(d,h)));let l=a===null?i?.rates[s]:void 0,c=n.statistics.capture_rate,
m=l!==void 0&&Math.abs(c-l)<1e-6&&n.length===i?.lengths[s],p=i?"Not an episode of the evaluation":"The evaluation played no episodes of this pair.";this.#t.dataset.
equal=String(m),this.#t.textContent=m?"As in the evaluation":l===void 0?p:`Episode ${s+1} differs from the evaluation.`,this.#t.title=`Played here: capture rate\
 ${O(c,3)} in ${n.length} steps.${i?` The cell says ${O(i.rate,3)}.`:""}`}#r(e,n){let{selected:r}=this.#e,o=u("span",{class:"bar"});return o.style.height=`${Math.
round(100*e)}%`,u("button",{type:"button",class:"episode",title:`Episode ${n+1}: capture rate ${O(e)}`,"aria-label":`Episode ${n+1}, capture rate ${O(e)}`,"aria\
-pressed":String(n===r.episode&&r.seed===null),onclick:()=>this.#e.select({episode:n,seed:null})},o,u("span",{class:"count"},n+1))}};var re=["stay","north","east","south","west","northeast","southeast","southwest","northwest"];var fs=0,gs=1,Zi=2,Ji=176;function bs(t,e,n,r){let o=devicePixelRatio||1,s=qt(t);t.width=t.height=Ji*o;let a=t.getContext("2d");if(!a)return;let{fov:i}=e,l=t.width/
i;a.fillStyle=s.paper,a.fillRect(0,0,t.width,t.height);for(let m=0;n&&m<i*i;m++){let p=(m%i+.5)*l,d=(Math.floor(m/i)+.5)*l,h=g=>!!n[g*i*i+m];h(Zi)&&(a.fillStyle=
s.obstacle,a.fillRect(p-l/2,d-l/2,l,l));let f=h(fs)&&h(gs)?l*.18:0;h(fs)&&ys(a,Oe,p+f,d+f,l*.74,s.evader),h(gs)&&ys(a,Kt,p-f,d-f,l*.86,s.pursuer)}a.strokeStyle=
r<e.n_pursuers?s.pursuer:s.evader,a.lineWidth=2*o;let c=Math.floor(i/2)*l;a.strokeRect(c,c,l,l)}function ys(t,e,n,r,o,s){e(t,n,r,o),t.fillStyle=s,t.fill()}var Xi=["stay","↑","→","↓","←","↗","↘","↙","↖"];function vs(t,{inputs:e,ratings:n,refused:r},o,s){let a=Lt(t,s),i=f=>a?a[t.inputs[f]]??0:1,l=f=>a||
!s?i(f)!==0:new RegExp(`\\b${t.inputs[f]}\\b`).test(s.expression),c=[...t.inputs.keys()].filter(l).sort((f,g)=>Math.abs(i(g))-Math.abs(i(f))),m=f=>`${f===o?"tak\
en":""} ${r[f]?"refused":""}`,p=(f,g)=>u("tr",{class:g.every(y=>y===g[0])?"same":""},f,...Array.from(g,(y,v)=>u("td",{class:m(v)},dt(y)))),d=f=>{let g=t.inputs[f];
return u("th",{scope:"row",title:`${a?`weight ${dt(i(f))} x `:""}${We[g]}`},g.replaceAll("_"," "))},h=u("table",{class:"why numbers"},u("thead",{},u("tr",{},u("\
th",{},a?"term":"input"),...Array.from(n,(f,g)=>u("th",{scope:"col",class:m(g),title:re[g],"aria-label":re[g]},Xi[g]))),p(u("th",{scope:"row"},a?"sum":"rating"),
n)),u("tbody",{},...c.map(f=>p(d(f),e[f].map(g=>i(f)*g)))));return[...s?[u("p",{class:"expression"},u("code",{},s.expression))]:[],u("div",{class:"wide-table",tabindex:0,
role:"group","aria-label":"How the moves are rated"},h)]}var Qi=(t,{pursuer:e,evader:n})=>({pursuers:Z(t,"pursuer",e),evaders:Z(t,"evader",n)}),ws="What it remembers: a number for each unit, from -1 to 1",Xt=class{element;#e;#n=u(
"canvas",{class:"seen",role:"img"});#t=u("h3");#r=u("p",{class:"small muted"});#i=u("div",{class:"answers"});#s=u("div",{title:ws});#u=null;#f=null;#h=null;#m=null;#p=null;#c=null;#a=null;#l=0;constructor(e){
this.#e=e,this.element=u("div",{class:"inspector","data-open":"false"},u("p",{class:"hint small muted"},"Click an agent, or press A: what it sees, and why it ta\
kes its move."),u("div",{class:"inspected"},this.#n,u("div",{class:"answer"},this.#t,this.#r,this.#s),this.#i))}get agent(){return this.#a}show(e,n,r,o,s=Qi(n,o)){
this.#u?.free(),this.#u=e.world(r.config),this.#h!==n&&(this.#f=null,this.#a!==null&&this.choose(null)),this.#h=n,this.#m=r,this.#p=o,this.#c=s}set solution(e){
this.#f=e,this.at(this.#l)}choose(e){this.#a=e,this.element.dataset.open=String(e!==null),this.#e(e),this.at(this.#l)}next(e){let n=this.#m;if(!n)return;let r=this.#a??
(e>0?-1:0);for(let o=0;o<n.n_agents;o++)if(r=(r+e+n.n_agents)%n.n_agents,n.alive[this.#l*n.n_agents+r])return this.choose(r)}at(e){this.#l=e;let n=this.#m,r=this.#u,
o=this.#h,s=this.#p,a=this.#c,i=this.#a;if(!n||!r||!o||!s||!a||i===null)return;let l=i<n.config.n_pursuers?"pursuer":"evader";this.#s.replaceChildren(),this.#t.
replaceChildren(u("span",{class:l},Y(i,n.config.n_pursuers))),n.seek(r,e,a);let c=n.actions.subarray(e*n.n_agents,(e+1)*n.n_agents);for(;c.length&&!r.over&&(i<r.
actors[0]||i>=r.actors[1]);)r.playTurn(c);let m=!!(n.alive[e*n.n_agents+i]&&r.read("alive")[i]);bs(this.#n,n.config,m?r.view(i):null,i),this.#n.ariaLabel=`Field\
 of view of ${Y(i,n.config.n_pursuers)}: evaders, pursuers and obstacles around it`;let p=c[i]??null;if(!m)return this.#o([],"It is gone.");let d=a[`${l}s`],h=typeof d!=
"string"&&d.kind==="cells"?r.answer(d,i):null,f=h?.probabilities??null;h?.memory.length&&this.#s.replaceChildren(u("p",{class:"small muted"},"It remembers:"),rl(
h.memory));let g=typeof d!="string"&&d.kind!=="cells"?vs(d,r.rate(d,i),p,Nt(o,l,s[l])):[],y=this.#f?.game(r)??null,v=[["network",f],["perfect",y?.marginal(i)??null]],
x=b=>u("p",{class:"small muted"},b);this.#o([...y?[x(`Value ${y.value.toFixed(2)} under perfect play.`)]:[],...tl(v,p),...g],p===null?"The episode is over.":el(
d,p))}#o(e,n){this.#i.replaceChildren(...e),this.#r.textContent=n}};function el(t,e){return typeof t=="string"?`The script "${t}" plays for it; it goes ${re[e]}\
.`:t.kind!=="cells"?"It takes the best move that its mask allows; of equal ones any.":t.sampled?"Its action is drawn from these probabilities.":"It takes the mo\
st probable action."}function tl(t,e){let n=t.filter(([,s])=>s);if(!n.length)return[];let r=u("div",{class:"action muted"},u("span"),...n.map(([s])=>u("span",{class:"\
head"},s))),o=Array.from(n[0][1],(s,a)=>u("div",{class:a===e?"action taken":"action"},u("span",{},re[a]),...n.flatMap(([,i])=>nl(i[a]))));return n.length>1||n[0][0]!==
t[0][0]?[r,...o]:o}function nl(t){let e=u("span",{class:"filled"});return e.style.width=`${100*t}%`,[u("span",{class:"track"},e),u("span",{class:"numbers"},t.toFixed(
2))]}function rl(t){let e=Array.from(t,n=>{let r=u("span",{title:n.toFixed(2)});return r.style.transform=`scaleY(${n})`,r});return u("div",{class:"units",role:"\
img","aria-label":ws},...e)}var ol=200;function xs(t,e,{pursuer:n,evader:r},o){let{text:s,image:a}=e.shows[`${n} ${r}`]??{},i=Me(t,n,r)?.rates??[],l=`Scores of the ${e.teams[0]} in ${i.length}\
 episodes: ${i.map(m=>O(m)).join(", ")}`,c=sl(t,e,n,r);return[s===void 0?null:u("pre",{tabindex:0,"aria-label":"What the game shows of this pair"},s),a===void 0?
null:u("img",{src:a,alt:"What the game shows of this pair",onload:({target:m})=>m.classList.toggle("pixels",m.naturalWidth<ol)}),...(s??a)===void 0?[u("p",{class:"\
muted"},e.missing),al(t,e,n,r,o)]:[],c?u("p",{class:"small numbers"},c):null,i.length>1?u("p",{class:"small numbers"},l):null].filter(m=>m!==null)}function sl(t,e,n,r){
let{others:o,extras:s={}}=t.payoff,a=o?.[n]?.[r],i=a===void 0?[]:[`score of the ${e.teams[1]} ${O(a)}`];for(let[l,c]of Object.entries(s)){let m=c[n]?.[r];m!==void 0&&
i.push(`${l} ${O(m)}`)}return i.length?`Means of the pair: ${i.join(", ")}`:""}function al(t,e,n,r,o){let s=Object.keys(e.shows).map(m=>m.split(" ").map(Number)),
a=([m,p])=>(m-n)**2+(p-r)**2,[i,l]=s.sort((m,p)=>a(m)-a(p))[0]??[];if(i===void 0||l===void 0)return null;let c=`${U(t,"pursuer",i)} against ${U(t,"evader",l)}`;
return u("p",{},u("button",{type:"button",onclick:()=>o.select({pursuer:i,evader:l})},`Nearest: ${c}`))}function Ss(t){let e=JSON.stringify(t,(n,r)=>n==="genome"?Array.from(r):r);return u("script",{type:"application/json",id:"champions"},e.replaceAll("<","\\u003c")).
outerHTML}var Ms="champion",As=0,Xn=64,Qn=100;var il=(t,e)=>Object.keys(t).every(n=>t[n]===e[n]);function Ts(t,e){return Object.keys(e).find(n=>il(e[n],t))??null}var vt="_",ll="n",Pm=2n**64n-1n;var er={fov:11,maxSteps:500,rewards:"paper"},cl=["rules","others","rewards","size","diagonal","fov","limit","seed","ended","walls","pursuers","evaders","played",
"next"];function ks(t,e){let n=i=>i.map(l=>ml(l,e)).join(""),r=i=>`${Math.floor(i/t.cols)}.${i%t.cols}`,o=ul(t.rewards,e),s=[t.seed,t.episode,t.steps].join("."),a={rules:Cs(
t.rules,e),others:t.others?Cs(t.others,e):"",rewards:o===er.rewards?"":o,size:`${t.rows}x${t.cols}`,diagonal:t.diagonal?"1":"",fov:t.fov===er.fov?"":String(t.fov),
limit:t.maxSteps===er.maxSteps?"":String(t.maxSteps),seed:s==="0.0.0"?"":s,ended:t.ended?"1":"",walls:t.walls.map(r).join(vt),pursuers:t.pursuers.map(Es).join(vt),
evaders:t.evaders.map(Es).join(vt),played:t.played.map(n).join(vt),next:t.next.every(i=>i===As)?"":n(t.next)};return cl.filter(i=>a[i]).map(i=>`${i}=${a[i]}`).join(
"&")}function Es({cell:t,gone:e,captured:n,everCaptured:r}){let o=n?"c":r?"e":"";return`${t[0]}.${t[1]}${o}${e?"x":""}`}function Cs(t,e){let n=e.fields.map(({name:r})=>String(
t[r]).toLowerCase());return Ts(t,e.variants)??n.join(".")}function ul(t,e){let n=JSON.stringify(t);return Object.keys(e.rewards).find(o=>JSON.stringify(e.rewards[o])===
n)??Object.values(t).map(o=>String(o)).join(vt)}function ml(t,e){if(typeof t=="number")return String(t);if(t===Ms)return ll;let n=e.scripts.findIndex(({name:r})=>r===
t);return String.fromCharCode(97+n)}var pl="/* the engine */";function Rs(t,e){return u("button",{type:"button",class:"to-playground",title:"Open this step in the playground (G): the same agents a\
nd actions under any rules",onclick:()=>tr(t(),e)},"What if?")}function tr(t,e){let n=t!==null&&t.match.n_agents<=Qn&&Math.max(t.match.config.rows,t.match.config.
cols)<=Xn,r=n?u("script",{type:"text/plain",id:"scene"},ks(dl(t.match,t.step),e)).outerHTML:"",o=new TextDecoder().decode(Bn("playground")).replace(pl,()=>Wt("s\
cript-engine")).replace("</noscript>",i=>i+r+(n?Ss(t.champions):"")),s=u("iframe",{title:"Playground",srcdoc:o}),a=u("dialog",{class:"what-if","aria-label":"Wha\
t if?",onclose:()=>a.remove()},u("button",{type:"button",class:"leave",onclick:()=>a.close()},"Back to the match"),s);document.body.append(a),a.showModal()}function dl(t,e){
let{config:n,n_agents:r}=t,o=Math.max(0,e-1),s=i=>{let l=o*r+i,c=o*n.n_evaders+i-n.n_pursuers,m=p=>i>=n.n_pursuers&&!!p[c];return{cell:[t.last_positions[2*l],t.
last_positions[2*l+1]],gone:!t.alive[l],captured:m(t.captured),everCaptured:m(t.ever_captured)}},a=Array.from({length:r},(i,l)=>s(l));return{rules:n.rules,others:null,
rewards:n.rewards,rows:n.rows,cols:n.cols,diagonal:n.diagonal,fov:n.fov,maxSteps:n.max_steps,seed:t.seed,episode:BigInt(t.episode),steps:o,ended:o===t.length,walls:Array.
from(t.map.keys()).filter(i=>t.map[i]),pursuers:a.slice(0,n.n_pursuers),evaders:a.slice(n.n_pursuers),played:[],next:Array.from(t.actions.subarray(o*r,(o+1)*r))}}var nr=.005,$s=.05,hl=4,Je=new Map;function Qt(t,e,n="capture-rate"){let r=JSON.stringify([{...e,rewards:null},n]),o=Je.get(r)??(Rt(e)?Promise.resolve(null):fl(
t,e,n));return Je.delete(r),Je.set(r,o),Je.size>hl&&Je.delete([...Je.keys()][0]),o}var Ps=({n_evaders:t})=>t===1?"capture-time":"capture-rate",Os=()=>new Promise(
t=>setTimeout(t));async function fl(t,e,n){await Os();let r=t.solution(e,n);for(;r.goBack();)await Os();return r}function en(t,e,n){let{payoff:r}=t;return n.flatMap(
(o,s)=>{let a=[0,0];for(let l=e.n_turns;l>0&&!e.over;l--)t.game(e)?.lost(o).forEach((c,m)=>a[m]+=c),e.playTurn(o);let i=r==="capture-rate"?nr:$s;return W.map((l,c)=>({
step:s+1,team:l,lost:a[c],payoff:r})).filter(l=>l.lost>=i)})}var tn=t=>t.map(e=>({step:e.step,kind:e.team,size:e.lost/Math.max(1,...t.map(({lost:n})=>n)),text:wt(
e)})),_s=({lost:t,payoff:e})=>e==="capture-rate"?`${t.toFixed(2)} of the capture rate`:`${t.toFixed(1)} steps`,wt=t=>`The ${t.team}s lose ${_s(t)} against a per\
fect opponent`;function Ns(t){let e=t.reduce((n,r)=>r.lost>n.lost?r:n);return`Your team's worst moves, in step ${e.step}, lost ${_s(e)} against a perfect oppone\
nt.`}function Ls({config:t,payoff:e},{value:n},r){if(e==="capture-rate")return`value ${n.toFixed(2)}`;let o=1-n,s=Math.min(t.max_steps-r,Cn);return o>s-$s?`free\
 for ${s} steps`:`captured after ${o.toFixed(1)} steps`}function Is(t,e){return(t.marginal(e)??[]).map((r,o)=>({share:r,action:o})).filter(({share:r})=>r>=nr).sort(
(r,o)=>o.share-r.share).map(({share:r,action:o})=>r>1-nr?re[o]:`${re[o]} ${r.toFixed(2)}`).join(", ")}function nn(t,e,n){if(n===0)return[{kind:"start",text:gl(t),agents:[]}];let r=e.moments[n-1],o=e.moments[n],s=m=>Y(m,t.config.n_pursuers),a=gt(e,r,o),i=t.conflicts(
n),l=new Set(i.flatMap(m=>m.doomed)),c=a.map(m=>({kind:"capture",text:`${s(m)} is captured`,agents:[m]}));for(let m of Gt(r,o))!a.includes(m)&&!l.has(m)&&c.push(
{kind:"end",text:`${s(m)} disappears`,agents:[m]});return c.push(...i.map(({kind:m,text:p,agents:d})=>({kind:m,text:p,agents:d}))),n===t.length&&c.unshift({kind:"\
end",text:yl(t),agents:[]}),c}function gl({config:t}){return`${t.n_pursuers} pursuers and ${t.n_evaders} evaders on ${t.rows} x ${t.cols} cells, at most ${t.max_steps}\
 steps`}function yl(t){let e=Math.round(t.statistics.capture_rate*t.config.n_evaders);return`The episode ends after ${t.length} steps with ${e} of ${t.config.n_evaders}\
 evaders captured`}var bl=60,rn=class{element;player=new He(0,{speed:Ut,still:Ze()});inspector;match=null;recording=null;actions;#e;#n;#t;#r;#i=u("h2",{class:"match-title"});#s=u(
"p",{class:"tally numbers"});#u=u("ol",{class:"words",tabindex:0,"aria-live":"off","aria-label":"What happened in this step"});#f=u("p",{class:"problem",role:"a\
lert"});#h=u("div",{class:"shown","aria-live":"polite"});#m=null;#p=null;#c=0;#a=!1;#l=0;#o=[];constructor(e,n,r){this.#n=e,this.#t=n;let o=u("canvas",{"aria-la\
bel":"The match",onclick:({clientX:s,clientY:a})=>this.inspector.choose(this.#e.agentAt(s,a))});this.#e=new qe(o,{numbers:!1}),this.#r=new Jt(n),this.inspector=
new Xt(s=>this.#T(s)),this.actions=u("div",{class:"match-actions"},u("button",{type:"button",class:"to-play",title:"Move the chosen agent, or an evader, yoursel\
f from this step on (T)",onclick:()=>this.element.dispatchEvent(new Event("takeover"))},"Take over"),r&&Rs(()=>this.shown,r)),this.element=u("section",{class:"c\
ard match-card","aria-label":"Match",id:"match"},u("div",{class:"match"},u("header",{class:"match-head"},this.#i,this.#s),this.#f,this.#h,u("div",{class:"stage"},
o),u("div",{class:"aside"},this.#u,ds(),this.actions,this.inspector.element),Zt(this.player),this.#r.element)),this.player.addEventListener("frame",()=>this.recording&&
this.#e.show(this.recording,this.player.time)),this.player.addEventListener("step",()=>this.#S()),n.on("match",()=>this.#y()),this.#x(),this.#M(0,0)}get#d(){return this.#n[this.#t.
selected.run]}reveal(){(this.#d.game?this.#h:this.#e.canvas).scrollIntoView({block:"nearest"})}get shown(){return this.match&&this.#p&&{match:this.match,step:this.
player.step,champions:this.#p}}start(e){this.#m=e,this.#b()}playSoon(){this.#a=!0,this.#c||this.#g()}goTo(e){this.#l=e,!this.#c&&this.match&&this.#b()}#g(){!this.#a||
!this.match||(this.#a=!1,this.player.jump(0),Ze()||this.player.play())}#y(){this.#x(),clearTimeout(this.#c),this.#c=setTimeout(()=>this.#b(),bl)}#b(){clearTimeout(
this.#c),this.#c=0,this.player.pause(),this.#x();let{selected:e}=this.#t,{game:n}=this.#d;if(this.#h.replaceChildren(...n?xs(this.#d,n,e,this.#t):[]),n){this.match=
this.recording=null,this.#a=!1,this.#v(e);return}let r=W.map(a=>Be(this.#d,a,e[a])).find(Boolean)??"";if(this.#f.textContent=r,r||!this.#m)return;this.match=It(
this.#m,this.#d,e);let[o,s]=this.names(e);this.#p={pursuer:{name:o,policy:Z(this.#d,"pursuer",e.pursuer)},evader:{name:s,policy:Z(this.#d,"evader",e.evader)}},this.
recording=ps(this.match),this.#r.show(this.#d,this.match),this.inspector.show(this.#m,this.#d,this.match,e),this.player.length=this.match.length,this.player.marks=
$o(this.recording),this.#o=this.player.ticks=[],this.player.jump(this.#l),this.#l=0,this.#S(),this.#w(this.#m,this.match),this.#v(e),this.#g()}#v({run:e,pursuer:n,
evader:r,episode:o,seed:s}){this.element.dataset.played=`${e} ${n} ${r} ${o} ${s??""}`}async#w(e,n){let r=await Qt(e,n.config);if(this.match!==n||!r)return;let o=e.
world(n.config);n.seek(o,0),this.#o=en(r,o,vl(n)),o.free(),this.player.ticks=tn(this.#o),this.inspector.solution=r,this.#S()}names({run:e,pursuer:n,evader:r}){let o=this.#n[e],
{teams:s}=o;return[s.pursuer.script??U(o,"pursuer",n),s.evader.script??U(o,"evader",r)]}#x(){let{episode:e,seed:n}=this.#t.selected,{game:r,payoff:o}=this.#d;this.
element.classList.toggle("of-own-game",!!r),this.element.classList.toggle("of-ratings",W.some(l=>_t(this.#d,l)));let[s,a]=this.names(this.#t.selected),i=n===null?
e<o.episodes?`episode ${e+1} of ${o.episodes}`:`episode ${e+1}, not part of the cell`:`seed ${n}`;this.#i.replaceChildren(u("span",{class:"pursuer"},de(s))," ag\
ainst ",u("span",{class:"evader"},a),r?"":u("span",{class:"muted small"},i))}#S(){let e=this.match;if(!e||!this.recording)return;let n=this.player.step,r=this.recording.
moments[n];this.#M(Array.from(r.everCaptured).filter(Boolean).length,n),this.#u.replaceChildren(...this.#o.filter(o=>o.step===n).map(o=>u("li",{class:`loss-${o.
team}`},wt(o))),...nn(e,this.recording,n).map(o=>u("li",{class:o.kind,"data-agents":o.agents.join(" ")},o.text))),this.inspector.at(n),this.#A()}#M(e,n){let{world:r}=this.#d;
r&&this.#s.replaceChildren(u("strong",{},e),` of ${r.n_evaders} captured`,u("span",{class:"muted"},` · step ${n}`))}#T(e){this.#e.look={selected:e,viewers:e===
null?[]:[e]},this.#A()}#A(){let e=this.inspector.agent;for(let n of this.#u.children){let r=n.dataset.agents?.split(" ")??[];n.classList.toggle("about",e!==null&&
r.includes(String(e)))}}},vl=({actions:t,length:e,n_agents:n})=>Array.from({length:e},(r,o)=>t.subarray(o*n,(o+1)*n));var wl={ArrowUp:[1,0],ArrowDown:[-1,0],ArrowRight:[0,1],ArrowLeft:[0,-1]},xl=5;function $e(t,e,n,r="pursuer"){t.tabIndex=0,t.setAttribute("role","application"),
t.addEventListener("keydown",o=>{let s=wl[o.key];if(!s)return;let[a,i]=r==="pursuer"?s:[s[1],s[0]],[l,c]=n(),m=o.shiftKey?xl:1,{pursuer:p,evader:d}=e.selected;e.
select({pursuer:Ws(p+m*a,l),evader:Ws(d+m*i,c)}),o.preventDefault(),o.stopPropagation()})}var Ws=(t,e)=>Math.min(e-1,Math.max(0,t));var Sl=24,on=7,Fs=t=>t<Sl&&matchMedia("(pointer: coarse)").matches;function Ds(t,e,n,r){let[o,s]=t.payoff.shape,a=Us(e,o),i=Us(n,s),l=Math.min(on,o),c=Math.min(
on,s),m=[];for(let g=a+l-1;g>=a;g--){m.push(u("span",{class:"pursuer"},g));for(let y=i;y<i+c;y++)m.push(Ml(t,g,y,r))}let p=Array.from({length:c},(g,y)=>u("span",
{class:"evader"},i+y)),d=u("button",{type:"button","aria-label":"Close: all cells",onclick:()=>r(null)},"✕"),f=u("div",{class:"loupe numbers",role:"group","ar\
ia-label":"Cells around the tap",onclick:g=>g.stopPropagation()},...m,d,...p);return f.style.gridTemplateColumns=`2.4rem repeat(${c}, minmax(0, 1fr))`,f}function Ml(t,e,n,r){
let o=u("button",{type:"button",onclick:()=>r({pursuer:e,evader:n})});return Bt(o,Me(t,e,n)?.rate,`${U(t,"pursuer",e)} against ${U(t,"evader",n)}`),o}var Us=(t,e)=>Math.
max(0,Math.min(e-on,t-Math.floor(on/2)));var ae={left:52,bottom:46,top:76,right:84},he=10,Al=160,xt=ae.right-he-14,Pe=ae.top-he-14,sn=class{element;#e;#n;#t=u("canvas",{"aria-hidden":"true"});#r=w("svg",
{"aria-hidden":"true"});#i=w("g");#s;#u=u("h2");#f=u("strong",{class:"rate numbers"});#h=u("span",{class:"small muted"});#m=u("p",{class:"of-both-teams small mu\
ted numbers"});#p;#c=null;constructor(e,n){this.#n=e,this.#e=n,this.#s=u("div",{class:"matrix",id:"matrix","aria-label":"Payoff matrix. Arrow keys choose a matc\
h, Enter plays it.",onpointermove:o=>this.#w(o),onpointerleave:()=>n.point({}),onclick:o=>this.#x(o),onkeydown:({key:o})=>o==="Enter"&&this.#M()},this.#t,this.#r);
let r=u("header",{class:"readout","aria-live":"polite"},u("div",{},this.#u,this.#m),u("div",{class:"of-cell"},this.#f,this.#h));this.#p=Ge(...k(this.#a).ends),this.
element=u("section",{class:"card matrix-card","aria-label":"Payoff matrix"},r,this.#s,this.#p),this.#y(),new ResizeObserver(()=>this.#l()).observe(this.#s),this.#s.
addEventListener("mousedown",o=>{o.preventDefault(),document.activeElement instanceof HTMLElement&&document.activeElement.blur()}),$e(this.#s,n,()=>this.#a.payoff.
shape),n.on("run",()=>{let o=Ge(...k(this.#a).ends);this.#p.replaceWith(o),this.#p=o,this.#l()}),n.on("match hover",()=>this.#g())}get#a(){return this.#n[this.#e.
selected.run]}#l(){let[e,n]=this.#a.payoff.shape,{clientWidth:r,clientHeight:o}=this.#s;if(r<50)return;let a=Math.max(Al,Math.min(r-ae.left-ae.right,o-ae.top-ae.
bottom))/Math.max(e,n),i=Math.max(ae.left,(r-n*a-ae.right+ae.left)/2),l=ae.top+Math.max(0,(o-ae.top-ae.bottom-e*a)/2),c={width:r,height:o,left:i,top:l,cell:a,rows:e,
columns:n};this.#c=c,zt(this.#t,this.#a.payoff,{left:i,top:l,width:n*a,height:e*a});for(let[m,p,d]of[["left",i,r],["top",l,o],["width",n*a,r],["height",e*a,o]])
this.#t.style.setProperty(m,`${100*p/d}%`);this.#s.style.setProperty("--shape",`${r} / ${o}`),this.#r.setAttribute("viewBox",`0 0 ${r} ${o}`),this.#r.replaceChildren(
Tl(c,k(this.#a).generation),...El(c),...this.#d(c),this.#i),this.#g()}#o(e){let n=this.#a.findings?.generalization;if(!n)return[];let{selected:r,hover:o}=this.#e,
s=o.pursuer??r.pursuer,a=o.evader??r.evader,[i,l]=zs(e,n.pursuers.mean[s]??0,s),[c,m]=Bs(e,n.evaders.mean[a]??0,a);return[w("circle",{class:"dot of-pursuers",cx:i,
cy:l,r:5}),w("circle",{class:"dot of-evaders",cx:c,cy:m,r:5})]}#d(e){let n=this.#a.findings?.generalization;if(!n)return[];let{left:r,top:o,cell:s,rows:a,columns:i}=e,
{curves:l}=k(this.#a),c=r+i*s+he,m=o-he,p={class:"side"};return[w("rect",{...p,x:c,y:o,width:xt,height:a*s}),w("rect",{...p,x:r,y:m-Pe,width:i*s,height:Pe}),...Hs(
n.pursuers,(d,h)=>zs(e,d,h),"of-pursuers"),...Hs(n.evaders,(d,h)=>Bs(e,d,h),"of-evaders"),w("text",{class:"tick",x:c,y:o+a*s+16,"text-anchor":"start"},"0"),w("t\
ext",{class:"tick",x:c+xt,y:o+a*s+16,"text-anchor":"end"},"1"),w("text",{class:"tick",x:r-6,y:m-4,"text-anchor":"end"},"0"),w("text",{class:"tick",x:r-6,y:m-Pe+
8,"text-anchor":"end"},"1"),w("text",{class:"label of-pursuers",x:c+xt,y:o+a*s+34,"text-anchor":"end"},l.pursuer),w("text",{class:"label of-evaders",x:r+i*s+he,
y:m-Pe+10,"text-anchor":"start"},l.evader)]}#g(){let e=this.#c;if(!e)return;let{selected:n,hover:r}=this.#e,{left:o,top:s,cell:a,rows:i,columns:l}=e,c=f=>s+(i-1-
f)*a,m=[],p=(f,g)=>w("rect",{class:g,x:o,y:c(f),width:l*a+he+xt,height:a}),d=(f,g)=>w("rect",{class:g,x:o+f*a,y:s-he-Pe,width:a,height:he+Pe+i*a});m.push(p(n.pursuer,
"strip pursuer"),d(n.evader,"strip evader")),r.pursuer!==null&&r.pursuer<i&&m.push(p(r.pursuer,"strip hover")),r.evader!==null&&r.evader<l&&m.push(d(r.evader,"s\
trip hover")),m.push(...this.#o(e));let h={x:o+n.evader*a,y:c(n.pursuer),width:a,height:a};m.push(w("rect",{class:"chosen under",...h}),w("rect",{class:"chosen",
...h})),this.#i.replaceChildren(...m),this.#y()}#y(){let{selected:e,hover:n}=this.#e,r=n.pursuer??e.pursuer,o=n.evader??e.evader,s=Me(this.#a,r,o);this.#u.replaceChildren(
u("span",{class:"pursuer"},de(U(this.#a,"pursuer",r)))," against ",u("span",{class:"evader"},U(this.#a,"evader",o))),this.#f.textContent=s?O(s.rate,3):"-";let a=s&&
s.rates.length>1?`, mean of ${s.rates.length} episodes`:"";this.#h.textContent=s?k(this.#a).score+a:"no episodes were played",this.#m.textContent=this.#b(r,o)}#b(e,n){
let r=this.#a.findings?.generalization;if(!r)return"";let o=(a,i)=>xo(a.mean[i]??null,a.low?.[i]??null,a.high?.[i]??null),{means:s}=k(this.#a);return`Against al\
l: ${s.pursuer} ${o(r.pursuers,e)}, ${s.evader} ${o(r.evaders,n)}`}#v(e){let n=this.#c;if(!n)return null;let r=this.#s.getBoundingClientRect(),o=Math.floor((e.clientX-
r.left-n.left)/n.cell),s=n.rows-1-Math.floor((e.clientY-r.top-n.top)/n.cell),a=s>=0&&s<n.rows,i=o>=0&&o<n.columns;return a||i?{g:a?s:-1,h:i?o:-1,inside:a&&i}:null}#w(e){
let n=this.#v(e);this.#e.point(n?{pursuer:n.g<0?null:n.g,evader:n.h<0?null:n.h}:{})}#x(e){let n=this.#v(e);if(n){if(n.inside&&Fs(this.#c.cell))return this.#S(n.
g,n.h);this.#e.select({...n.g<0?{}:{pursuer:n.g},...n.h<0?{}:{evader:n.h}}),n.inside&&this.#M()}}#S(e,n){let r=Ds(this.#a,e,n,o=>{r.remove(),o&&(this.#e.select(
o),this.#M())});this.#s.append(r)}#M(){this.#s.dispatchEvent(new CustomEvent("play",{bubbles:!0}))}};function Tl({left:t,top:e,cell:n,rows:r,columns:o},s){let a=w(
"g",{class:"axes"}),i=e+r*n,l=c=>ht(0,c-1,Math.min(c,c*n/44),!0);for(let c of l(o))a.append(w("text",{class:"tick",x:t+(c+.5)*n,y:i+16,"text-anchor":"middle"},c));
for(let c of l(r))a.append(w("text",{class:"tick",x:t-7,y:i-(c+.5)*n,"text-anchor":"end","dominant-baseline":"middle"},c));return a.append(w("text",{class:"labe\
l of-evaders",x:t+o*n/2,y:i+36,"text-anchor":"middle"},s.evader),w("text",{class:"label of-pursuers",transform:`translate(${t-36} ${e+r*n/2}) rotate(-90)`,"text\
-anchor":"middle"},s.pursuer)),a}function El({left:t,top:e,cell:n,rows:r,columns:o}){let s=w("g",{class:"diagonal"}),a=Math.min(r,o);if(a<3)return[];let i=e+r*n;
for(let m of["H","V"]){let p=`M${t} ${i}`;for(let d=1;d<=a;d++){let h=`H${t+d*n}`,f=`V${i-d*n}`;p+=m==="H"?h+f:f+h}s.append(w("path",{d:p,class:"under"}),w("pat\
h",{d:p}))}let l=t+a/2*n-.7*n-4,c=i-a/2*n-.7*n-4;return[s,w("text",{class:"on-cells",transform:`translate(${l} ${c}) rotate(-45)`,"text-anchor":"middle"},"same \
generation")]}var zs=({left:t,top:e,cell:n,rows:r,columns:o},s,a)=>[t+o*n+he+s*xt,e+(r-a-.5)*n],Bs=({left:t,top:e,cell:n},r,o)=>[t+(o+.5)*n,e-he-r*Pe];function Hs(t,e,n){
let r=s=>s.map((a,i)=>e(a??0,i).map(l=>l.toFixed(1)).join(" ")),o=[];return t.low&&t.high&&o.push(w("path",{class:`band ${n}`,d:`M${[...r(t.high),...r(t.low).reverse()].
join("L")}Z`})),o.push(w("path",{class:`line ${n}`,d:`M${r(t.mean).join("L")}`})),o}function ie(t,e,...n){return u("section",{class:"card panel","aria-label":t},u("header",{},u("h2",{},t),u("p",{class:"small muted"},e)),...n)}var Cl={present:"●",
absent:"○","cannot tell":"?"};function js(t){let{findings:e}=t;if(!e?.table.length)return null;let[,...n]=e.table,r=n.map(([s,a,i,l],c)=>{let m=a==="told"?"":
Rl(e.reasons[c]??"");return u("li",{class:`finding ${a.replace(" ","-")}`},u("span",{class:"sign","aria-hidden":"true"},Cl[a]??""),u("div",{},u("p",{},u("strong",
{},s),` ${a}`,u("span",{class:"muted"},` · ${l}`)),m?u("p",{class:"small"},`${m}.`):null,u("p",{class:"small muted numbers"},i)))}),o=ie("What happened","Each \
condition is present, absent, or its 95 % interval cannot tell. The intervals are about this run.",u("p",{class:"headline"},e.sentence),u("ul",{class:"findings"},
...r),...kl(e.refused??{}),t.limits?u("p",{class:"small"},t.limits):null);return o.classList.add("diagnosis"),{element:o}}function kl(t){return[...new Set(Object.
values(t))].map(n=>{let r=Object.keys(t).filter(o=>t[o]===n);return u("p",{class:"small muted"},`Not judged, because ${n}: ${r.join(", ")}.`)})}function Rl(t){let[
,e=""]=t.split(/, because (.*)/s);return de(e.replace(/\.$/,""))}function Gs({settings:t,command:e}){let n=t.map(({name:s,value:a,help:i})=>u("tr",{},u("th",{scope:"\
row"},u("code",{},`--set ${s}=${a}`)),u("td",{class:"muted"},i))),r=u("table",{class:"small"},u("caption",{class:"heard"},"Settings other than the default"),...n),
o=ie("Settings","All others are the defaults. This command plays the race again:",u("pre",{class:"command"},e),n.length?u("div",{class:"wide-table"},r):null);return o.
classList.add("settings"),{element:o}}function Vs(t,e,n){let{findings:r}=t,{teams:o,click:s}=k(t);if(!r?.table.length||!r.checkerboards)return null;let a=r.checkerboards.map(i=>Ol(t,i,(l,c)=>{e.select(
{pursuer:l,evader:c}),n()}));return{element:ie("Checkerboards",`${ke(t).length>1?"Two generations of each team":"Two generations against two others"}: each gene\
ration of the ${o.pursuer} is better against another one of the ${o.evader}. Click a cell to ${s}.`,a.length?u("div",{class:"boards"},...a):u("p",{},`No four ce\
lls differ by more than ${r.margin} in this way.`),a.length&&!t.game?.exact?u("p",{class:"small muted"},"The strongest of all pairs, so noise makes them look st\
ronger than they are. The diagnosis says whether there are more than noise makes."):null)}}function Ol(t,{pursuers:e,evaders:n},r){let o=(s,a)=>{let i=u("button",
{type:"button",class:"cell",onclick:()=>r(s,a)});return Bt(i,t.payoff.capture_rate[s][a],`${U(t,"pursuer",s)} against ${U(t,"evader",a)}`),i};return u("div",{class:"\
miniature numbers"},u("span"),...n.map(s=>u("span",{class:"evader"},s)),...e.flatMap(s=>[u("span",{class:"pursuer"},s),...n.map(a=>o(s,a))]))}function Ks(t,e){let n=t.findings?.ciao;if(!n)return null;let r=ke(t).map(o=>{let{fading:s,stripes:a,period:i}=n[`${o}s`],l=`fading ${O(s)}, stripes ${O(a)}${i===
null?"":` every ${i} generations`}`;return $l(t,o,l,e)});return{element:ie("CIAO: current individuals against ancestral opponents","The team's own score. Stripe\
s: intransitive, since wins and losses alternate with the age of the opponent; whether a team returns to earlier strategies is recurrence, under What happened. \
Darker away from the diagonal: forgetting.",u("div",{class:"triangles"},...r.map(o=>o.element)),t.payoff.others?Ge(...k(t).ends):Ge("0 loses","1 wins")),update:()=>r.
forEach(o=>o.update())}}function $l(t,e,n,r){let o=e==="pursuer"?0:1,s=k(t),a=t.payoff.shape[o],i=t.payoff.shape[1-o],l=t.payoff.capture_rate,c=t.payoff.others,
m=Array.from({length:a},(b,S)=>Array.from({length:Math.min(S+1,i)},(T,C)=>e==="pursuer"?l[S][C]:c?.[C][S]??1-l[C][S])),p=Hn({shape:[a,i],first:[0,0],capture_rate:m}),
d=w("rect",{class:"chosen",width:1,height:1}),h=w("rect",{class:"chosen under",width:1,height:1}),f=w("svg",{viewBox:`0 0 ${i} ${a}`,preserveAspectRatio:"none",
"aria-hidden":"true"},h,d),g=u("div",{class:"triangle","aria-label":`CIAO of the ${s.teams[e]}: ${n}. Arrow keys choose a match.`,onpointermove:b=>r.point(y(b)??
{}),onpointerleave:()=>r.point({}),onclick:b=>y(b)&&r.select(y(b))},p,f);$e(g,r,()=>t.payoff.shape,e),g.style.aspectRatio=`${i} / ${a}`;let y=b=>{let S=g.getBoundingClientRect(),
T=Math.floor((b.clientX-S.left)/S.width*i),C=a-1-Math.floor((b.clientY-S.top)/S.height*a);return T>=0&&C<a&&T<=C?{[e]:C,[Ce(e)]:T}:null},v=()=>{let b=r.hover[e]??
r.selected[e],S=r.hover[Ce(e)]??r.selected[Ce(e)];for(let T of[d,h])T.setAttribute("x",String(S)),T.setAttribute("y",String(a-1-b)),T.style.display=S<=b?"":"non\
e"};return{element:u("figure",{},u("figcaption",{class:"small"},u("span",{class:e},s.teams[e])),g,u("p",{class:"small muted"},`horizontal: ${s.generation[Ce(e)]}\
; vertical: ${s.generation[e]}`),u("p",{class:"small numbers"},n)),update:v}}var rr={right:12,top:10,bottom:42},an={x:56,y:34,letter:8,label:30};function ln(t,e,n,r){let{top:o}=rr,s=Math.max(o+40,e-rr.bottom),a=ht(r.low,r.high,(s-o)/an.y,
r.whole),i=an.label+an.letter*Math.max(2,...a.map(y=>or(y).length)),l=Math.max(i+40,t-rr.right),c=(y,v,x)=>b=>v+(b-y.low)/(y.high-y.low||1)*(x-v),m=c(n,i,l),p=c(
r,s,o),d=w("g"),h=w("svg",{width:t,height:e,viewBox:`0 0 ${t} ${e}`,class:"plot"}),f=w("g",{class:"axes"});for(let y of a)f.append(w("line",{x1:i,x2:l,y1:p(y),y2:p(
y),class:"grid"}),w("text",{x:i-8,y:p(y),"text-anchor":"end","dominant-baseline":"middle"},or(y)));for(let y of ht(n.low,n.high,(l-i)/an.x,n.whole))f.append(w("\
text",{x:m(y),y:s+16,"text-anchor":"middle"},or(y)));return f.append(w("line",{x1:i,x2:l,y1:s,y2:s,class:"axis"}),w("text",{x:(i+l)/2,y:e-6,"text-anchor":"middl\
e",class:"label"},n.label),w("text",{transform:`translate(12 ${(o+s)/2}) rotate(-90)`,"text-anchor":"middle",class:"label"},r.label)),h.append(f,d),{root:h,marks:d,
left:i,right:l,top:o,bottom:s,x:m,y:p,at:y=>{let v=y-h.getBoundingClientRect().left;return n.low+(v-i)/(l-i)*(n.high-n.low)}}}var or=t=>String(Number(t.toPrecision(
6))).replace("-","−");function cn(t,e,n,r){let o="",s="M";n.forEach((a,i)=>{a===null?s="M":(o+=`${s}${t.x(e[i]).toFixed(1)} ${t.y(a).toFixed(1)}`,s="L")}),t.root.
insertBefore(w("path",{d:o,class:`line ${r}`}),t.marks)}function sr(t,{low:e,high:n},r){if(!e||!n)return;let o=s=>s.map((a,i)=>`${t.x(i).toFixed(1)} ${t.y(a??0).
toFixed(1)}`);t.root.insertBefore(w("path",{d:`M${[...o(n),...o(e).reverse()].join("L")}Z`,class:`band ${r}`}),t.marks)}function ar(t,e,n,r=null){let o=t.x(e);t.
marks.append(w("line",{x1:o,x2:o,y1:t.top,y2:t.bottom,class:`mark ${n}`})),r!==null&&t.marks.append(w("circle",{cx:o,cy:t.y(r),r:5,class:`dot ${n}`}))}function ir(...t){
return u("p",{class:"legend small"},...t.map(([e,n])=>u("span",{class:`key ${n}`},e)))}function un(t,e,n=()=>{},r=()=>{}){let o=u("div",{class:"chart chooses",role:"\
img","aria-label":t}),s=null,a=()=>{s?.marks.replaceChildren(),s&&n(s)};o.addEventListener("click",l=>s&&r(s.at(l.clientX),s,l));let i=()=>{let{clientWidth:l,clientHeight:c}=o;
l<50||c<50||(s=e(l,c),o.replaceChildren(s.root),a())};return new ResizeObserver(i).observe(o),{element:o,update:a,redraw:i}}var lr=["of-pursuers","of-evaders","of-both"],Pl=2500,Ys="Arrow keys choose generations.";function qs(t,e){let{training:n}=t,{score:r,teams:o}=k(t),{capture_rate:s,
generation:a,learner:i,epochs:l}=n,c=s.map((y,v)=>(v+1)*l),m=_l(s,n.window),p=c.at(-1)??1,d=c.length>Pl?"dense":"",h=(y,v)=>{let x=a.flatMap((b,S)=>b===y&&(i[S]===
v||i[S]===2)?[S]:[]);return x.length?[c[x[0]],c[x.at(-1)]]:null},f=un(`${de(r)} in ${p} epochs of training. ${Ys}`,(y,v)=>{let x=ln(y,v,{low:0,high:p,label:"epo\
ch",whole:!0},{low:0,high:1,label:r});for(let[b,S]of[["raw",s],[d,m]])for(let[T,C]of lr.entries()){let R=S.map((A,M)=>i[M]===T||i[M+1]===T?A:null);R.some(A=>A!==
null)&&cn(x,c,R,`${C} ${b}`)}return x},y=>W.forEach((v,x)=>{let b=h(e.hover[v]??e.selected[v],x);b&&ar(y,(b[0]+b[1])/2,lr[x])}),y=>{let v=Math.min(c.length-1,Math.
max(0,Math.round(y/l)-1)),x=a[v];i[v]!==1&&e.select({pursuer:Math.min(x,t.payoff.shape[0]-1)}),i[v]!==0&&e.select({evader:Math.min(x,t.payoff.shape[1]-1)})});$e(
f.element,e,()=>t.payoff.shape);let g=[...new Set(i)].sort().map(y=>[`${[o.pursuer,o.evader,"both teams"][y]} learn`,lr[y]]);return{element:ie("Training",`${So(
n.matches)} training matches. Lines: the generations that are selected.`,ir(...g),f.element),update:f.update}}function Zs(t){let e=t.findings?.joint;if(!e)return null;
let n=e.mean.length-1,r=un("Mean of both scores by generation.",(s,a)=>{let i=ln(s,a,{low:0,high:n,label:"generation",whole:!0},{low:0,high:1,label:"mean of bot\
h scores"});return sr(i,e,"of-both"),cn(i,e.mean.map((l,c)=>c),e.mean,"of-both"),i}),o=`${O(e.mean[0]??null)} in the beginning, ${O(e.mean[n]??null)} at the end`;
return{element:ie("Both sides together",`The mean of both scores against contemporaries: ${o}. What one wins is not what the other loses here, so both may rise,\
 or fall.`,r.element),update:r.update}}function Js(t,e){let n=t.findings?.ratings;if(!n)return null;let r={pursuer:n.pursuers,evader:n.evaders},o={pursuer:r.pursuer.
mean,evader:r.evader.mean},s=ke(t),a=W.flatMap(h=>[r[h].mean,r[h].low??[],r[h].high??[]]).flat().map(h=>h??0),i=Math.min(...a),l=Math.max(...a),c=.06*(l-i||1),m=Math.
max(...t.payoff.shape)-1,{teams:p}=k(t),d=un(`Elo ratings by generation. ${Ys}`,(h,f)=>{let g=ln(h,f,{low:0,high:m,label:"generation",whole:!0},{low:i-c,high:l+
c,label:"Elo points"});for(let y of s)sr(g,r[y],`of-${y}s`),cn(g,o[y].map((v,x)=>x),o[y],`of-${y}s`);return g},h=>{for(let f of W){let g=e.hover[f]??e.selected[f];
ar(h,g,`of-${f}s`,o[f][g]??null)}},(h,f,g)=>{let y=Math.round(h),v=g.clientY-f.root.getBoundingClientRect().top,x=S=>Math.abs(f.y(o[S][y]??1/0)-v),b=x("pursuer")<=
x("evader")?"pursuer":"evader";y>=0&&y<o[b].length&&e.select({[b]:y})});return $e(d.element,e,()=>t.payoff.shape),{element:ie("Ratings",`One number for each gen\
eration, which cycles do not fit${r.pursuer.low?", with 95 % intervals over episodes":""}.${s.length>1?` The game itself: ${O(n.offset,0)} points for the ${p.pursuer}\
.`:""}`,ir(...s.map(h=>[p[h],`of-${h}s`])),d.element),update:d.update}}function _l(t,e){let n=[0];for(let r of t)n.push(n.at(-1)+r);return t.map((r,o)=>{let s=Math.
max(0,o-Math.floor((e-1)/2)),a=Math.min(t.length,o+Math.floor(e/2)+1);return(n[a]-n[s])/(a-s)})}function Xs(t,e){if(W.every(r=>!t.teams[r].words&&!_t(t,r)))return null;let n=u("div",{class:"evolved"});return{element:ie("What evolved","Each move is rated by\
 named inputs of the cell that it leads to, and the best one is taken.",n),update:()=>n.replaceChildren(...W.map(r=>Nl(t,r,e.selected[r])))}}function Nl(t,e,n){
let{words:r,kept:o}=t.teams[e],s=Be(t,e,n),a=t.teams[e].script??U(t,e,n);return u("section",{"aria-label":k(t).teams[e]},u("h3",{class:e},de(a)),r&&n===o.at(-1)?
u("p",{},r):null,...s?[u("p",{class:"small muted"},s)]:Ll(t,e,n,Z(t,e,n)))}function Ll(t,e,n,r){if(typeof r=="string"||r.kind==="cells")return[];let o=Nt(t,e,n),
s=Lt(r,o);return[...o?[u("p",{},u("code",{},o.expression))]:[],...s?[Il(e,r.inputs.map(a=>[a,s[a]??0]))]:[],...r.kind==="rating"&&r.hidden.length?[u("p",{class:"\
small muted"},`A network with ${r.hidden.join(" and ")} hidden units rates each move by ${r.inputs.length} inputs.`)]:[]]}function Il(t,e){let n=Math.max(...e.map(
([,r])=>Math.abs(r)))||1;return u("div",{class:"weights"},...e.flatMap(([r,o])=>{let s=u("span",{class:`bar ${t}${o<0?" below":""}`});return s.style.width=`${50*
Math.abs(o)/n}%`,[u("span",{title:We[r]},r.replaceAll("_"," ")),u("span",{class:"axis"},s),u("span",{class:"numbers"},dt(o))]}))}function Qs(t,e,n){let r=new Map,o=u("div",{class:"panels"}),s=[],a=()=>s.forEach(l=>l.update?.()),i=()=>{let l=t[e.selected.run];s=r.get(l)??Wl(l,e,n),r.set(l,
s),o.replaceChildren(...s.map(c=>c.element)),a()};return e.on("run",i),e.on("match hover",a),i(),o}function Wl(t,e,n){return[Zs(t),js(t),Xs(t,e),qs(t,e),Vs(t,e,
n),Js(t,e),Ks(t,e),Gs(t)].filter(o=>o!==null)}var ea={pursuer:null,evader:null},mn=class extends EventTarget{#e;#n=ea;constructor(e){super(),this.#e=e}get selected(){return this.#e}get hover(){return this.#n}select(e){
let n=this.#e,r=["run","pursuer","evader"].some(o=>o in e&&e[o]!==n[o]);this.#e={...n,...r?{episode:0,seed:null}:{},...e},this.#e.run!==n.run&&this.dispatchEvent(
new Event("run")),this.dispatchEvent(new Event("match"))}point(e){let n={...ea,...e};n.pursuer===this.#n.pursuer&&n.evader===this.#n.evader||(this.#n=n,this.dispatchEvent(
new Event("hover")))}on(e,n){for(let r of e.split(" "))this.addEventListener(r,n)}};var pn=class{config;start;recording;actions=[];#e;#n;#t=[[]];constructor(e,n,r){this.config=n,this.start=r,this.#e=e.world(n),this.#e.reset(r),this.#n=[Jn(this.#e)],
this.recording=Zn(n,this.#e.map(),this.#n)}get length(){return this.actions.length}get over(){return this.#e.over}get statistics(){return{capture_rate:this.#e.read(
"capture_rate")[0]}}conflicts(e){return this.#t[e]}game(e){return e.game(this.#e)}play(e){this.#e.step(e),this.#r(e)}step(e,n,r){let o=this.#e,s=this.config.n_pursuers,
a=new Uint8Array(o.n_agents);for(let i=o.n_turns;i>0&&!o.over;--i){let[l,c]=o.actors;l<s&&(a=o.decide(e.pursuer,[l,Math.min(c,s)],a)),c>s&&(a=o.decide(e.evader,
[Math.max(l,s),c],a)),typeof r=="number"?a[n]=r:l<=n&&n<c&&(a=o.decide(r,[n,n+1],a)),o.playTurn(a)}this.#r(a)}#r(e){this.actions.push(e),this.#n.push(Jn(this.#e,
e)),this.#t.push(this.#e.conflicts())}};var fe=(t,e)=>W[+(e>=t.n_pursuers)];function cr(t,e){let n=new pn(t,e.config,{seed:e.seed,episode:e.episode});for(let r of e.moves)n.over||n.step(e.policies,e.seat,
r);return n}function _e(t,e){let{moments:n,nPursuers:r}=t.recording,o=n.findIndex(({alive:a,captured:i})=>!a[e]||!!i[e-r]),s=o<0?t.length:o;return{lasted:s,out:o>=
0,captured:Array.from(n[s].everCaptured).filter(Boolean).length}}var dn=(t,e)=>t.over||_e(t,e).out;function ta(t,e,n){let r=cr(t,{...e,moves:e.moves.slice(0,e.from)});
for(;!dn(r,e.seat);)r.step(e.policies,e.seat,n);return _e(r,e.seat)}function na(t){let e=t.length-1;return[...new Set([0,Math.round(e/3),e])].map(n=>t[n])}function ra(t,{
seat:e,from:n,moves:r}){let o={...t,seat:e,...n?{from:n}:{},moves:r.join("")};return`${location.href.split("#")[0]}#${Object.entries(o).map(([s,a])=>`${s}=${a}`).
join("&")}`}function oa(t,e){let n=t.get("seat")??"",r=t.get("from")??"0",o=t.get("moves")??"";return/^\d{1,6}$/.test(n)&&Number(n)<e.n_pursuers+e.n_evaders&&(e.
diagonal?/^[0-8]+$/:/^[0-4]+$/).test(o)&&o.length<=e.max_steps&&/^\d{1,6}$/.test(r)&&Number(r)<=o.length?{seat:Number(n),from:Number(r),moves:[...o].map(Number)}:
null}function ur(t,e,n,r){let{players:o,told:s,...a}=r;e.play({...a,played:n,ending:(i,l)=>[s?u("p",{},s(_e(i,n.seat))):"",Ul(t,i,l,na(o))],again:()=>ur(t,e,{...n,moves:n.
moves.slice(0,n.from)},r)})}function Ul(t,e,n,r){let o=fe(n.config,n.seat)==="evader",s=o?n.config.max_steps:n.config.n_evaders,a=u("table",{class:"numbers"},u(
"caption",{},o?"Steps in your seat: same start, same others":"Captures of your team: same start, same others")),i=c=>{let m=u("span",{class:o?"bar evader":"bar \
pursuer"}),p=u("td",{},"…");return a.append(u("tr",{},u("th",{scope:"row"},c),u("td",{class:"track","aria-hidden":"true"},m),p)),({lasted:d,captured:h})=>{m.style.
width=`${100*(o?d:h)/s}%`,p.textContent=String(o?d:h)}};i("You")(_e(e,n.seat));for(let{name:c,policy:m}of r){let p=i(c);setTimeout(()=>p(ta(t,n,m())))}let l=n.from?
`You took over at step ${n.from}. `:"";return u("div",{},a,u("p",{class:"small muted"},`${l}One match: luck has its part in it.`))}var sa=["·","↑","→","↓","←","↗","↘","↙","↖"];var Fl={" ":0,ArrowUp:1,w:1,ArrowRight:2,d:2,ArrowDown:3,s:3,ArrowLeft:4,a:4,e:5,c:6,y:7,z:7,q:8},mr=[8,1,5,4,0,2,7,3,6],Dl=[7,8,9,4,5,6,1,2,3],zl=24,Bl=Math.tan(
Math.PI/8);function ia(t,e){if(t.ctrlKey||t.metaKey||t.altKey)return;let n=Dl.findIndex(o=>t.code===`Numpad${o}`),r=mr[n]??Fl[t.key.length===1?t.key.toLowerCase():
t.key];return r!==void 0&&r>4&&!e?void 0:r}function la(t){let e=mr.map(n=>u("button",{type:"button","aria-label":re[n],onclick:()=>t(n)},sa[n]));return{element:u(
"div",{class:"play-pad",role:"group","aria-label":"Your move"},...e),show:n=>e.forEach((r,o)=>r.classList.toggle("absent",mr[o]>4&&!n))}}function aa(t,e,n){let r=Bl*
Math.max(Math.abs(t),Math.abs(e)),o=s=>Math.abs(s)<r?0:s;return Ro([0,0],n?[o(t),o(e)]:[t,e],n)}function ca(t,e,n){let r=null,{canvas:o}=t;o.addEventListener("p\
ointerdown",({button:s,clientX:a,clientY:i})=>r=s===0?[a,i]:null),o.addEventListener("pointercancel",()=>r=null),o.addEventListener("pointerup",({clientX:s,clientY:a})=>{
let i=r,l=e();if(r=null,!i||!l)return;let c=s-i[0],m=a-i[1],p=t.cellAt(s,a);Math.hypot(c,m)>=zl?n(aa(m,c,l.diagonal)):p&&n(aa(p[0]-l.cell[0],p[1]-l.cell[1],l.diagonal))})}
function ua(t,e){let n=r=>{let o=e[r]-t[r],s=Ve.findIndex(a=>a[r]===Math.sign(o)&&a[1-r]===0);return o?`${Math.abs(o)} ${re[s]}`:""};return[n(0),n(1)].filter(Boolean).
join(", ")||"on your cell"}var da="NUMPY\0",ma=da.length+2,pa=64;function ha(t){return uo(Object.fromEntries(Object.entries(t).map(([e,n])=>[`${e}.npy`,Hl(n)])))}function Hl({dtype:t,shape:e,
data:n}){let r=typeof n=="string"?Array.from(n,m=>m.codePointAt(0)):null,o=e.map(m=>`${m}, `).join(""),s=`{'descr': '${r?`<U${r.length}`:t}', 'fortran_order': F\
alse, 'shape': (${o}), }`,a=Math.ceil((ma+s.length+1)/pa)*pa-ma,i=da+String.fromCharCode(a&255,a>>8)+s.padEnd(a-1)+`
`,l=r?Int32Array.from(r):n,c=new Uint8Array(i.length+l.byteLength);return c.set(Ot(i,!0)),c.set(new Uint8Array(l.buffer,l.byteOffset,l.byteLength),i.length),c}var jl="matrixworld episode 3";function fa(t,e,n){let{config:r,actions:o,length:s,recording:a}=e,i=r.n_pursuers+r.n_evaders,l=r.n_evaders,c={positions:["<i4",i,
2],last_positions:["<i4",i,2],alive:["|b1",i],captured:["|b1",l],ever_captured:["|b1",l]},m={rewards:["<f4",i],involved:["|b1",i,3],fault:["|b1",i,3]},p={},d=b=>{
for(let S of Object.keys(b))(p[S]??=[]).push(Array.from(h.read(S),Number))},h=t.world(r);h.reset(e.start);let f=[];d(c);for(let b of o)h.step(b),d({...c,...m}),
f.push(...h.conflictTable());h.free();let g={"<i4":Int32Array,"<f4":Float32Array,"|b1":Uint8Array},y={};for(let[b,[S,...T]]of Object.entries({...c,...m})){let C=s+
+(b in c);y[b]={dtype:S,shape:[C,...T],data:g[S].from((p[b]??[]).flat())}}let v=b=>({dtype:"<i8",shape:[],data:Int32Array.of(b,0)}),x=b=>({dtype:"<U",shape:[],data:b});
return ha({format:x(jl),n_pursuers:v(r.n_pursuers),config:x(JSON.stringify(r)),seat:v(n),...y,actions:{dtype:"|i1",shape:[s,i],data:Int8Array.from(o.flatMap(b=>[
...b]))},map:{dtype:"|b1",shape:[r.rows,r.cols],data:Uint8Array.from(a.obstacles,Number)},conflict_table:{dtype:"<i4",shape:[f.length/11,11],data:Int32Array.from(
f)}})}var Gl=[0,1,2,4,8],hn=class{element;player=new He(0,{speed:4,still:Ze()});#e;#n;#t=u("canvas",{tabindex:0,"aria-describedby":"play-keys"});#r=u("h2");#i=u("p",{
class:"play-told",role:"status"});#s=la(e=>this.act(e));#u=zr(Gl.map(e=>[e,e?`${e} / s`:"step by step"]),()=>this.#E());#f=u("input",{type:"checkbox",onchange:()=>this.#S()});#h=u(
"input",{type:"checkbox",onchange:()=>this.#C()});#m=u("label",{class:"play-choice"},this.#h,"Best move");#p=u("p",{class:"small muted play-keys",id:"play-keys"});#c=u(
"section",{class:"play-ending",tabindex:-1,"aria-labelledby":"play-headline"});#a=Zt(this.player);#l=null;#o=null;#d=[];#g=null;#y=null;#b=[];#v=0;#w=0;constructor(e){
this.#e=e,this.#n=new qe(this.#t,{numbers:!1}),this.#t.setAttribute("role","application"),ca(this.#n,()=>{let n=this.#g!==null&&this.#o&&$(this.#o.recording.moments.
at(-1),this.#g);return n?{cell:n,diagonal:this.#o.config.diagonal}:null},n=>this.act(n)),this.player.addEventListener("frame",()=>this.#o&&this.#n.show(this.#o.
recording,this.player.time)),this.player.addEventListener("step",()=>this.#C()),this.element=u("div",{class:"play"},u("header",{class:"play-head"},this.#r,this.#i),
u("div",{class:"play-stage"},this.#t),u("div",{class:"play-side"},this.#c,this.#s.element,u("label",{class:"play-choice",title:"Steps a second"},"Pace ",this.#u),
u("label",{class:"play-choice"},this.#f,u("span",{},"Fog",u("span",{class:"at-length"},": see only what it sees"))),this.#m,this.#p),this.#a)}get played(){return this.#l&&
{...this.#l.played,moves:this.#d}}get live(){return this.#o}play(e){this.#x(cr(this.#e,e.played),e.played.seat,e.title),this.#l=e,this.#d=[...e.played.moves],this.#v=
0,this.element.dataset.state="playing",this.#t.focus({preventScroll:!0}),dn(this.#o,e.played.seat)&&this.#R()}watch(e,n,r){this.#l=null,this.#x(e,n,r),this.#O()}stop(){
this.#E(),this.player.pause(),this.#l=null}act(e){let n=this.#l,r=this.#o;if(!n||!r||this.element.dataset.state!=="playing")return;this.#v=e;let o=Number(this.#u.
value);this.#w||(this.#k(),o&&this.element.dataset.state==="playing"&&(this.#w=setInterval(()=>this.#k(),1e3/o)))}key(e){let{target:n,key:r}=e;if(n instanceof HTMLSelectElement||
n instanceof HTMLInputElement&&(n.type==="text"||r===" ")||n instanceof HTMLButtonElement&&(r===" "||r==="Enter")||!this.#o)return!1;if(this.element.dataset.state!==
"playing")return je(this.player,e);let s=ia(e,this.#o.config.diagonal);return s!==void 0&&this.act(s),s!==void 0}#x(e,n,r){this.#E(),this.player.pause(),this.#o=
e,this.#g=n,this.#r.textContent=r,this.#t.ariaLabel=`Board, ${e.config.rows} by ${e.config.cols} cells`,this.#s.show(e.config.diagonal),this.#p.replaceChildren(
u("span",{class:"at-length"},`W A S D or the arrow keys move, Space stays${e.config.diagonal?"; Q E Z C and the numeric keypad move diagonally":""}. `),"On the \
board: swipe, or tap where to go."),this.#M(e),this.#c.replaceChildren(),this.player.length=e.length,this.player.jump(e.length),this.#C()}#S(){this.#n.look={you:this.#g,
fog:this.#f.checked,viewers:this.#g===null?[]:[this.#g],plan:this.#$()}}#M(e){this.#y=null,this.#b=this.player.ticks=[],this.#m.hidden=this.#h.disabled=!!Rt(e.config),
Qt(this.#e,e.config,Ps(e.config)).then(n=>{this.#o===e&&(this.#y=n,this.#T(),this.#C())})}#T(){let e=this.#o,n=this.#y;if(!n||this.element.dataset.state==="play\
ing")return;let r=this.#e.world(e.config);r.reset(e.start),this.#b=en(n,r,e.actions),r.free(),this.player.ticks=tn(this.#b)}get#A(){return this.#h.checked&&this.#l&&
this.element.dataset.state==="playing"&&this.#y&&this.#o.game(this.#y)||null}#$(){let e=this.#g,n=this.#g!==null&&this.#A?.marginal(this.#g);return e!==null&&n?
Object.assign(Array(e).fill(0),{[e]:n.indexOf(Math.max(...n))}):null}#E(){clearInterval(this.#w),this.#w=0,this.#i.ariaLive=Number(this.#u.value)?"off":"polite"}#k(){
let{policies:e,seat:n}=this.#l.played,r=this.#o;r.step(e,n,this.#v),this.#d.push(this.#v),this.player.length=r.length,this.player.glide=Math.min(.22,.9/(Number(
this.#u.value)||4)),this.player.move(r.length-this.player.step),dn(r,n)&&this.#R()}#R(){this.#E();let e=this.#l,n=this.#o,r=this.played,o=Hr()?e.link(r):null,s=`${Y(
r.seat,n.config.n_pursuers)}-${n.length}-steps.npz`,a=()=>wo(s,fa(this.#e,n,r.seat)),i=bo("Link to this match");i.hidden=!0,this.#c.replaceChildren(u("h3",{id:"\
play-headline"},Yl(n,r.seat)),...e.ending(n,r),u("div",{class:"play-buttons"},u("button",{type:"button",class:"primary",onclick:()=>e.again()},"Again"),u("butto\
n",{type:"button",onclick:()=>this.#O()},"Watch it"),u("button",{type:"button",onclick:a},"Save"),o&&u("button",{type:"button",onclick:()=>vo(i,o)},e.linkName??
"Link")),i),this.element.dataset.state="ended",this.player.jump(n.length),this.#T();let l=this.#b.filter(({team:c})=>c===fe(n.config,r.seat));l.length&&this.#c.
children[0].after(u("p",{class:"small muted"},Ns(l))),this.#c.focus({preventScroll:!0}),this.#c.scrollIntoView({block:"nearest"})}#O(){this.element.dataset.state=
"watched",this.player.length=this.#o.length,this.player.jump(0),Ze()||this.player.play()}#C(){let e=this.#o,n=this.#g,{step:r}=this.player;if(!e||r>e.length)return;
let o=nn(e,e.recording,r).filter(({agents:l})=>n===null||l.includes(n)),s=this.#l&&r===0,a=s?[Vl(e.config,n),this.#l.about??""]:[`Step ${r} of ${e.config.max_steps}`,
...o.map(({text:l})=>l)];!s&&n!==null&&a.push(Kl(e,r,n)),a.push(...this.#b.filter(l=>l.step===r).map(wt));let i=r===e.length&&n!==null?this.#A:null;i&&a.push(`P\
erfect play: ${Is(i,n)||"decided in its turn"}; ${Ls(this.#y,i,r)}`),this.#S(),this.#i.textContent=a.filter(Boolean).map(l=>`${l}.`).join(" ")}};function Vl(t,e){
let n=t.rules.capture==="SURROUND";return fe(t,e)==="evader"?`Run away: you win if ${n?"the pursuers do not surround you":"no pursuer reaches your cell"} in ${t.
max_steps} steps`:`Capture evaders: ${n?"surround them with your team":"move onto their cells"}`}function Kl({config:t,recording:e},n,r){let o=e.moments[n],s=fe(
t,r),a=Ce(s);if(!o.alive[r])return"";let i=$(o,r),l=p=>{let[d,h]=$(o,p);return Math.max(Math.abs(d-i[0]),Math.abs(h-i[1]))},c=Array.from({length:o.alive.length},
(p,d)=>d).filter(p=>fe(t,p)===a&&o.alive[p]&&!o.captured[p-t.n_pursuers]&&2*l(p)<t.fov);if(!c.length)return`No ${a} in view`;let m=c.reduce((p,d)=>l(d)<l(p)?d:p);
return`Nearest ${a}: ${ua(i,$(o,m))}`}function Yl(t,e){let{lasted:n,out:r,captured:o}=_e(t,e),{config:s}=t;return fe(s,e)==="pursuer"?`Your team captured ${o} o\
f ${ql(s)} in ${n} steps.`:r?`You lasted ${n} of ${s.max_steps} steps.`:`You escaped: ${n} steps.`}var ql=({n_evaders:t})=>`${t} evader${t===1?"":"s"}`;var fn=class{dialog=u("dialog",{class:"take-over","aria-label":"Play an agent",onclose:()=>this.view?.stop(),onkeydown:e=>this.view?.key(e)&&e.preventDefault()});view=null;#e;#n;#t;#r=null;constructor(e,n,r){
this.#e=e,this.#n=n,this.#t=r,r.element.addEventListener("takeover",()=>this.open())}start(e,n=""){this.#r=e;let r=lt(n,this.#e,this.#n.selected),{world:o}=this.#e[r.
run],s=o&&oa(new URLSearchParams(n.replace(/^#/,"")),o);s&&this.play(r,s)}open(){let e=this.#t.shown;if(!e)return;let{match:n,step:r}=e;this.#t.player.pause();let o=this.#t.
inspector.agent,s=r<n.length?r:0,a=(p,d)=>!!n.alive[d*n.n_agents+p],i=Array.from({length:n.n_agents},(p,d)=>(d+n.config.n_pursuers)%n.n_agents),l=o??i.find(p=>a(
p,s)),c=a(l,s)?s:0,m=Array.from({length:c},(p,d)=>n.actions[d*n.n_agents+l]);this.play(this.#n.selected,{seat:l,from:c,moves:m})}play(e,n){let r=this.#r,o=this.#e[e.
run],{world:s}=o;if(!r||!s||W.some(v=>Be(o,v,e[v])))return;let{run:a,pursuer:i,evader:l,episode:c,seed:m}=e,p=fe(s,n.seat),d=o.teams[p].kept.map(v=>({name:o.teams[p].
script??`generation ${v}`,text:"",policy:()=>Z(o,p,v)}));this.view||(this.view=new hn(r),this.dialog.append(u("button",{type:"button",class:"leave",onclick:()=>this.
dialog.close()},"Close"),this.view.element)),this.dialog.open||this.dialog.showModal();let h=`You are ${Y(n.seat,s.n_pursuers)}: ${this.#t.names(e).join(" again\
st ")}`,f={pursuer:Z(o,"pursuer",i),evader:Z(o,"evader",l)},g={config:s,seed:BigInt(m??o.seeds[i][l]),episode:c,policies:f,...n},y={run:a,pursuers:i,evaders:l,episode:c,
...m===null?{}:{seed:m}};ur(r,this.view,g,{title:h,players:d,link:v=>ra(y,v)})}};var ue=ho(),{runs:X}=ue,[Zl,Jl]=X[0].payoff.shape,Xl=lt(location.hash,X,{run:0,pursuer:Zl-1,evader:Jl-1,episode:0,seed:null}),{step:ga,...Ql}=Xl,oe=new mn(Ql),J=new rn(
X,oe,ue.playground),ya=new sn(X,oe),St=new fn(X,oe,J),pr=Co(X),ec=location.hash,Ae=null,ba=u("span",{class:"told","aria-live":"polite"}),va=u("span",{class:"sma\
ll muted"}),wa=()=>{let t=X[oe.selected.run],e=t.findings?.sentence??"";ba.textContent=t.together||e,va.textContent=t.together?`Seed ${t.seed}: ${e} ${k(t).lead}`:
k(t).lead};oe.on("run",wa);wa();var xa=()=>{J.playSoon(),J.reveal()};document.getElementById("page").replaceWith(Vr(ue.heading,u("span",{},ba,va),u("button",{type:"\
button",class:"keys-button",title:"Keys (?)","aria-label":"Keys (?)",onclick:()=>pr.showModal()},"?")),...ue.note?[u("aside",{class:"note small muted"},ue.note)]:
[],Eo(X,oe),u("main",{class:"stages"},ya.element,J.element),Qs(X,oe,xa),u("footer",{class:"muted small"},`${ue.title} · matrixworld ${ue.version}`),St.dialog,pr);
Object.assign(window,{matrixworldExplorer:{get match(){return J.match},get step(){return J.player.step},get pace(){return J.player.pace},get playing(){return St.
view},play:t=>Ae&&It(Ae,X[oe.selected.run],{...oe.selected,episode:t}),get shape(){return X[oe.selected.run].payoff.shape}}});ya.element.addEventListener("play",
xa);J.goTo(ga);ga||J.playSoon();Yr(X,oe,J);ko(X,oe,J,pr,()=>St.open(),()=>ue.playground&&tr(J.shown,ue.playground));window.addEventListener("hashchange",({newURL:t})=>Ae&&
St.start(Ae,new URL(t).hash));ue.growing&&qr(X,oe,()=>J.player.playing||document.querySelector("dialog[open]")!==null);async function tc(){Ae=ue.playground&&await Fr(),
J.start(Ae),Ae&&St.start(Ae,ec)}requestAnimationFrame(()=>setTimeout(()=>Br(tc())));})();
