/* built from web/ by "npm run build"; sources 935dfac1aaac763b3137186728bf53d2313bb373e9627ddd8f84a14c7c4e33be */
"use strict";(()=>{var br={SIMULTANEOUS:0,SWARM_TURNS:1,AGENT_TURNS:2},rt={DISAPPEAR:0,REACH:1,BOUNCE:2},wr={OCCUPATION:0,SURROUND:1},xr={FAULT:0,INVOLVED:1};var Sn=["obstacle","teammate","adversary"],Mn=["vertex","edge","chain"],Sr=["turn","kind","form","first","second","row","col","at_fault","held","doomed"],Tn=["p\
ursuer_{number}","evader_{number}"],Mr={obstacle:"{first} ran into the obstacle or border at {cell}",vertex:"{first} and {second} both headed for {cell}",edge:"\
{first} and {second} meant to swap, {first} to {cell}",chain:"{first} headed for {cell}, where {second} had to stay"},ot={"both held":"both bounce","both doomed":"\
both disappear",held:"{agent} bounces",doomed:"{agent} disappears",none:"nobody is stopped"},Tr="{event}: {outcome}",An={random:"any action, all equally likely",
still:"always stays",chaser:"moves to where the nearest adversary in view is nearest",fleer:"moves to where the nearest adversary in view is farthest","clumsy-c\
haser":"a chaser that takes any action in half of the steps",hunter:"a chaser of the nearest adversary in view to which no teammate in view is nearer",surrounder:"\
a chaser of the nearest free cell beside an adversary without a teammate","clumsy-fleer":"a fleer that takes any action in half of the steps",dodger:"moves to w\
here all adversaries in view together are farthest","team-surrounder":"shares the free cells beside adversaries with its teammates, and searches","careful-rando\
m":"as random, but takes only moves that right of way allows","careful-chaser":"as chaser, but takes only moves that right of way allows","careful-fleer":"as fl\
eer, but takes only moves that right of way allows","careful-clumsy-chaser":"as clumsy-chaser, but takes only moves that right of way allows","careful-hunter":"\
as hunter, but takes only moves that right of way allows","careful-surrounder":"as surrounder, but takes only moves that right of way allows","careful-clumsy-fl\
eer":"as clumsy-fleer, but takes only moves that right of way allows","careful-dodger":"as dodger, but takes only moves that right of way allows","careful-team-\
surrounder":"as team-surrounder, but takes only moves that right of way allows"},Fe={adversary:"distance to the nearest adversary (0 to 2, in half views)",pressure:"\
sum over adversaries of 1 / (1 + moves)^2 (0 or more)",unclaimed:"distance to the nearest adversary to which no teammate is nearer than the agent is now; withou\
t one, to the nearest adversary (0 to 2, in half views)",open_side:"distance to the nearest cell beside an adversary that holds no obstacle and no teammate (0 t\
o 2, in half views)",teammate:"distance to the nearest teammate (0 to 2, in half views)",exits:"share of the cells around that are no obstacle (0 to 1)",room:"d\
istance to the nearest obstacle to the north, east, south or west (0 to 1, in half views)",must_yield:"1 if right of way forbids the move (0 to 1)",ahead:"1 if \
it is the direction that the agent draws for each 12 steps (0 to 1)",search:"1 if it leads on along the way on which an agent of team-surrounder searches the gr\
id (0 to 1)",escapes:"share of the cells that an evader may be on after its next move which hold no obstacle and which no pursuer in view reaches in one move: o\
f the nearest adversary, or an evader's own (0 to 1)",opposite:"(1 - cosine) / 2 of the angle at the nearest adversary between the agent and the teammate neares\
t to it; for an evader, of the angle at itself between its two nearest adversaries (0 to 1)",parity:"1 if the distance to the nearest adversary is odd (0 to 1)"},
Ar={free:".GS",blocked:"#@OTW"};var ze=1+Sr.length;function st(t,e){return t.replace(/\{(\w+)\}/g,(n,r)=>String(e[r]))}function ee(t,e){return t<e?st(Tn[0],{number:t}):st(Tn[1],{number:t-e})}function Na(t,e){
let[n,r,o,s,a,i,l,...c]=Array.from(t),m=a<0?[s]:[s,a],[u,d,h]=c.map(v=>m.filter((w,b)=>v>>b&1)),y=m.map(v=>ee(v,e)),f=st(Mr[a<0?"obstacle":Mn[o]],{first:y[0],second:y[y.
length-1],cell:`(${i}, ${l})`}),g=st(Tr,{event:f,outcome:Ia(m.length,d,h,e)});return{kind:Sn[r],form:Mn[o],agents:m,cell:[i,l],at_fault:u,held:d,doomed:h,turn:n,
text:g}}function Ia(t,e,n,r){if(t===2&&e.length===2)return ot["both held"];if(t===2&&n.length===2)return ot["both doomed"];let o=s=>a=>st(ot[s],{agent:ee(a,r)});
return[...e.map(o("held")),...n.map(o("doomed"))].join(", ")||ot.none}function kt(t,e){let n=[];for(let r=0;r<t.length;r+=ze)n.push(Na(t.subarray(r+1,r+ze),e));
return n}var Me=class extends Error{name="EngineError"};function z(t,e,n){let r=typeof n=="string"?`'${n}'`:typeof n=="object"?JSON.stringify(n):String(n);return new Me(
`${t}: expected ${e}, got ${r}`)}var Be=class{bytes;constructor(e){this.bytes=e}},kr=0,En=[Uint8Array,Uint8Array,Int32Array,BigInt64Array,BigUint64Array,Float32Array,Float64Array],Cr=4,Er=4,La=new TextEncoder,
Wa=new TextDecoder;function Ua(t){for(let e=En.length-1;e>kr;--e)if(t instanceof En[e])return e;throw new TypeError("array: expected a typed array of the engine\
's numbers, got another")}function Cn(t){return new Uint8Array(t.buffer,t.byteOffset,t.byteLength)}function Da(t){return La.encode(`${t}\0`)}var kn=class{engine;addresses=[];constructor(e){
this.engine=e}copy(e){let n=this.engine._malloc(Math.max(e.length,1));if(n===0)throw new Me("memory: expected room for the arguments, got none");return this.addresses.
push(n),this.engine.HEAPU8.set(e,n),n}text(e){return this.copy(Da(e))}arrays(e){let n=Object.entries(e),r=n.flatMap(([s,a])=>{let i=a instanceof Be,l=i?a.bytes:
a;return[this.text(s),i?kr:Ua(l),l.length,this.copy(Cn(l))]}),o=this.copy(Cn(Int32Array.from(r)));return this.copy(Cn(Int32Array.of(n.length,o)))}free(){for(let e of this.
addresses)this.engine._free(e)}};function Rr(t,e){let n=t.HEAPU8;return Wa.decode(n.subarray(e,n.indexOf(0,e)))}function He(t){let e=new Int32Array(t.HEAPU8.buffer),
n=t._last_outputs()/Cr,r=e[n+1]/Cr,o={};for(let s=r;s<r+e[n]*Er;s+=Er){let a=En[e[s+1]],i=e[s+2]*a.BYTES_PER_ELEMENT,l=e[s+3];o[Rr(t,e[s])]=new a(t.HEAPU8.slice(
l,l+i).buffer)}return o}function Te(t,e){let n=new kn(t);try{let r=e(n);if(r===0)throw new Me(Rr(t,t._last_error()));return r}finally{n.free()}}var Fa=2**31-1,Or=["none","gru"],za=2n**64n-1n,Ba=34028234663852886e22;function me(t,e){if(typeof e!="number"||!Number.isInteger(e)||Math.abs(e)>Fa)throw z(t,"a\
n integer",e);return Int32Array.of(e)}function Rt(t,e){if(typeof e!="boolean")throw z(t,"true or false",e);return new Be(Uint8Array.of(Number(e)))}function ke(t,e,n){
let r=typeof e=="string"&&Object.hasOwn(n,e)?n[e]:void 0;if(r===void 0)throw z(t,`one of ${Object.keys(n).join(", ")}`,e);return Int32Array.of(r)}function Rn(t,e){
if(typeof e!="number"||!(Math.abs(e)<=Ba))throw z(t,"a finite number",e);return e}function at(t,e){let r=typeof e=="bigint"||typeof e=="number"&&Number.isSafeInteger(
e)?BigInt(e):-1n;if(r<0n||r>za)throw z(t,"an integer from 0 to 2^64 - 1",e);return BigUint64Array.of(r)}function Ha(t){return{"rules.interaction":ke("interactio\
n",t.interaction,br),"rules.obstacle":ke("obstacle",t.obstacle,rt),"rules.teammate":ke("teammate",t.teammate,rt),"rules.evader":ke("evader",t.evader,rt),"rules.\
pursuer":ke("pursuer",t.pursuer,rt),"rules.capture":ke("capture",t.capture,wr),"rules.captured_disappear":Rt("captured_disappear",t.captured_disappear)}}function $r(t,e){
let n=typeof e=="number"?[e,e,e]:e;if(!Array.isArray(n)||n.length!==3)throw z(t,"1 or 3 numbers",e);return Float32Array.from(n,r=>Rn(t,r))}function Ga(t){let e=(n,r)=>Float32Array.
of(Rn(n,t[n]),Rn(r,t[r]));return{"rewards.capture":e("pursuer_capture","evader_capture"),"rewards.neighbor":e("pursuer_neighbor","evader_neighbor"),"rewards.ste\
p":e("pursuer_step","evader_step"),"rewards.pursuer_collide":$r("pursuer_collide",t.pursuer_collide),"rewards.evader_collide":$r("evader_collide",t.evader_collide),
"rewards.blame":ke("blame",t.blame,xr),"rewards.capture_repeats":Rt("capture_repeats",t.capture_repeats)}}function Nr(t){if(t===void 0||typeof t=="number")return new Uint8Array(
0);if(t instanceof Uint8Array)return t;let{free:e,blocked:n}=Ar;for(let[r,o]of t.entries()){if(o.length!==t[0]?.length)throw z(`map, row ${r}`,`${t[0]?.length} \
cells as in row 0`,o.length);let s=[...o].find(a=>!e.includes(a)&&!n.includes(a));if(s)throw z(`map, row ${r}`,`'${e}' (free) or '${n}' (obstacle)`,s)}return Uint8Array.
from([...t.join("")],r=>Number(n.includes(r)))}function Ir(t,e){if(!Array.isArray(t))return;let n=[t.length,t[0]?.length??0];if(!(n[0]===e.rows&&n[1]===e.cols))
throw z("obstacle map",`shape (${e.rows}, ${e.cols}), the rows and cols`,n)}function Ge(t){Ir(t.obstacles,t);let e=typeof t.obstacles=="number"?t.obstacles:0;return{
...Ha(t.rules),...Ga(t.rewards),rows:me("rows",t.rows),cols:me("cols",t.cols),n_pursuers:me("n_pursuers",t.n_pursuers),n_evaders:me("n_evaders",t.n_evaders),fov:me(
"fov",t.fov),diagonal:Rt("diagonal",t.diagonal),max_steps:me("max_steps",t.max_steps),density:Float64Array.of(e),map:Nr(t.obstacles)}}function Pr(t,e){return Int32Array.
from((e??[]).flat(),n=>me(t,n)[0])}function Lr(t,e){return Ir(t.obstacles,e),{seed:at("seed",t.seed??0n),episode:at("episode",t.episode??0),pursuers:Pr("pursuer\
s",t.pursuers),evaders:Pr("evaders",t.evaders),map:Nr(t.obstacles)}}function Ot(t){return{actions:Int32Array.from(t,e=>me("actions",e)[0])}}var _r=Object.keys(Fe);
function On(t){let e=_r.indexOf(t);if(e<0)throw z("inputs",`names of ${_r.join(", ")}`,t);return e}function Re(t){if(typeof t=="string"){if(!Object.hasOwn(An,t))
throw z("policy",`one of ${Object.keys(An).join(", ")}`,t);return{script:new TextEncoder().encode(t)}}if(t.kind!=="cells")return{inputs:Int32Array.from(t.inputs,
e=>On(e)),hidden:Int32Array.from(t.kind==="rating"?t.hidden:[],e=>me("hidden",e)[0]),length:me("length",t.kind==="program"?t.length:0),mask:new TextEncoder().encode(
t.mask),genome:t.genome};if(t.activation!=="relu"&&t.activation!=="tanh")throw z("activation","'relu' or 'tanh'",t.activation);if(!Or.includes(t.memory))throw z(
"memory",`one of ${Or.join(", ")}`,t.memory);return{hidden:Int32Array.from(t.hidden,e=>me("hidden",e)[0]),activation:new TextEncoder().encode(t.activation),sampled:Rt(
"sampled",t.sampled),memory:new TextEncoder().encode(t.memory),genome:t.genome}}var ja=["first_turn","terminated","truncated"];function Wr(t){let e={...t};for(let n of ja)
e[n]=new Be(t[n]);return e}var Ur="statistics.",$t=class{config;seed;episode;n_agents;statistics;first_conflict;constructor(e,n,r,o){this.config=e,this.seed=n,this.episode=r,this.n_agents=
e.n_pursuers+e.n_evaders,this.statistics=Ka(Dr(o)),Object.assign(this,o),this.first_conflict=Va(this.conflict_table,this.length)}get length(){return this.actions.
length/this.n_agents}conflicts(e){this.check(e);let n=this.first_conflict[e],r=this.first_conflict[e+1],o=this.conflict_table.subarray(n*ze,r*ze);return kt(o,this.
config.n_pursuers)}seek(e,n,r){this.check(n),(!(e.seed===this.seed&&e.episode===BigInt(this.episode))||e.turn!==0||e.steps>n)&&e.reset({seed:this.seed,episode:this.
episode});for(let s=e.steps;s<n;++s){let a=this.actions.subarray(s*this.n_agents,(s+1)*this.n_agents);r?e.replay(a,{pursuer:r.pursuers,evader:r.evaders}):e.step(
a)}}check(e){if(!(Number.isInteger(e)&&e>=0&&e<=this.length))throw z("step",`0 to ${this.length}`,e)}};function Va(t,e){let n=new Int32Array(e+2);for(let r=0;r<
t.length;r+=ze)++n[t[r]+1];for(let r=1;r<n.length;++r)n[r]+=n[r-1];return n}function Ka(t){let e=["capture_rate","ever_capture_rate","captured_fraction","length"];
return Object.fromEntries(Object.entries(t).map(([n,r])=>[n,e.includes(n)?Number(r[0]):r]))}var Dr=t=>Object.fromEntries(Object.entries(t).flatMap(([e,n])=>e.startsWith(
Ur)?[[e.slice(Ur.length),n]]:[]));function Fr(t,e,n,r){let o=[Ge(n.config),Re(n.pursuers),Re(n.evaders),r];return Te(t,s=>{let[a,i,l,c]=o.map(m=>s.arrays(m));return t[e](
a,i,l,c)}),He(t)}function zr(t,e,n,r){let o={seed:at("seed",n),episode:at("episode",r)};return new $t(e.config,n,r,Fr(t,"_play_match",e,o))}function Br(t,e,n,r){
if(!Number.isInteger(r)||r<1)throw z("n_episodes","at least 1",r);let o=Fr(t,"_play_rollout",e,{...n,n_episodes:Int32Array.of(r)});return Dr(o)}var Ya=7e6,qa=new FinalizationRegistry(([t,e])=>t._states_free(e));function Za({rules:t,rows:e,cols:n,obstacles:r,diagonal:o,n_pursuers:s,n_evaders:a}){let i=typeof r==
"number"||t.obstacle==="REACH"?0:r.join("").split("#").length-1,l=e*n-i,c=[t.obstacle,t.teammate,t.pursuer].includes("DISAPPEAR"),m=t.capture==="SURROUND"||t.evader===
"REACH",u=t.interaction==="AGENT_TURNS",d=(f,g)=>Array.from({length:g},(v,w)=>u?f:(f+w)/(w+1)).reduce((v,w)=>v*w,1),h=d(l+Number(c),s)*d(l*(1+Number(m))+2,a);return{
SIMULTANEOUS:[s+a],SWARM_TURNS:[s,a],AGENT_TURNS:Array(s+a).fill(1)}[t.interaction].reduce((f,g)=>f+h*(o?9:5)**g,0)}function Pt(t){return typeof t.obstacles=="n\
umber"&&t.obstacles>0?"obstacles are drawn anew in each episode":Za(t)>Ya?"the world is too large to be solved on the page":""}var $n=class{value;teams;matrix;n_actions;constructor(e,n){
let{matrix:r,rows:o,cols:s,value:a,agents:i}=n,[l,c]=e.actors,m=Array.from(i).filter(d=>l<=d&&d<c),u=d=>d<e.config.n_pursuers;this.value=a[0],this.matrix=r,this.
n_actions=e.n_actions,this.teams=[{agents:m.filter(u),play:o},{agents:m.filter(d=>!u(d)),play:s}]}marginal(e){let n=this.teams.find(({agents:s})=>s.includes(e));
if(!n)return null;let r=this.n_actions**(n.agents.length-1-n.agents.indexOf(e)),o=Array(this.n_actions).fill(0);return n.play.forEach((s,a)=>o[Math.floor(a/r)%this.
n_actions]+=s),o}lost(e){let[n,r]=this.teams.map(({agents:l})=>l.reduce((c,m)=>c*this.n_actions+e[m],0)),[o,s]=this.teams.map(({play:l})=>l),a=s.reduce((l,c,m)=>l+
c*this.matrix[n*s.length+m],0),i=o.reduce((l,c,m)=>l+c*this.matrix[m*s.length+r],0);return[Math.max(0,this.value-a),Math.max(0,i-this.value)]}},Pn=60,it=class{config;payoff;engine;states;n_turns;values;constructor(e,n,r){
this.engine=e,this.config=n,this.payoff=r,this.states=Te(e,i=>e._states_new(i.arrays(Ge(n)))),qa.register(this,[e,this.states]);let o={SIMULTANEOUS:1,SWARM_TURNS:2,
AGENT_TURNS:n.n_pursuers+n.n_evaders};this.n_turns=o[n.rules.interaction];let{payoffs:s}=this.call(()=>e._states_payoffs(this.states)),a=s;this.values=[[r==="ca\
pture-rate"?a:a.fill(0)]]}goBack(){let e=this.values.at(-1)[0],n=[];for(let o=this.n_turns-1;o>=0;o--){let s=n[o+1]??e;n[o]=this.backup(o,{next:s})}this.payoff===
"capture-time"&&(n[0]=n[0].map((o,s)=>s===this.config.n_evaders?0:o-1)),this.values.push(n);let r=this.payoff==="capture-rate"?this.config.max_steps:Math.min(this.
config.max_steps,Pn);return this.values.length<=r&&n[0].some((o,s)=>o!==e[s])}backup(e,n){return this.call(r=>this.engine._states_backup(this.states,e,r.arrays(
n))).values}game(e){let n=this.config.max_steps-e.steps,{turn:r}=e,o=r+1===this.n_turns,s=n>0?this.values[Math.min(n-Number(o),this.values.length-1)]?.[o?0:r+1]:
void 0;if(!s)return null;let a=this.call(i=>this.engine._states_game(this.states,e.address,i.arrays({next:s})));return a.agents.length?new $n(e,a):null}call(e){
return Te(this.engine,e),He(this.engine)}};var Hr=new FinalizationRegistry(([t,e])=>t._world_free(e)),lt=class{config;n_agents;n_actions;engine;at;freed=!1;constructor(e,n){this.engine=e,this.config=n,this.
n_agents=n.n_pursuers+n.n_evaders,this.n_actions=n.diagonal?9:5,this.at=Te(e,r=>e._world_new(r.arrays(Ge(n)))),Hr.register(this,[e,this.at],this)}free(){this.freed||
(this.freed=!0,Hr.unregister(this),this.engine._world_free(this.at))}get address(){if(this.freed)throw z("world","one that is in use","one that was freed");return this.
at}reset(e={}){let n=Lr(e,this.config);this.call(r=>this.engine._world_reset(this.address,r.arrays(n)))}step(e){let n=Ot(e);this.call(r=>this.engine._world_step(
this.address,r.arrays(n)))}playTurn(e){let n=Ot(e);this.call(r=>this.engine._world_play_turn(this.address,r.arrays(n)))}decide(e,n,r){let{n_pursuers:o}=this.config,
s={pursuer:[0,o],evader:[o,this.n_agents]},[a,i]=typeof n=="string"?s[n]:n;if(r.length!==this.n_agents)throw z("actions",String(this.n_agents),r.length);let l=[
Re(e),Ot(r)],{actions:c}=this.call(m=>this.engine._world_decide(this.address,m.arrays(l[0]),a,i,m.arrays(l[1])));return Uint8Array.from(c)}replay(e,n){let r=s=>typeof s!=
"string"&&s.kind==="cells"&&s.memory!=="none";if(!r(n.pursuer)&&!r(n.evader))return this.step(e);let{n_pursuers:o}=this.config;for(let s=this.n_turns;s>0;--s){let[
a,i]=this.actors;a<o&&this.decide(n.pursuer,[a,Math.min(i,o)],e),i>o&&this.decide(n.evader,[Math.max(a,o),i],e),this.playTurn(e)}}get n_turns(){return this.turnNumbers()[1]}get turn(){
return this.turnNumbers()[0]}get actors(){let[,,e,n]=this.turnNumbers();return[e,n]}turnNumbers(){return this.call(()=>this.engine._world_turn(this.address)).turn}get steps(){
return this.read("steps")[0]}get seed(){return this.read("seed")[0]}get episode(){return this.read("episode")[0]}get over(){return this.read("terminated")[0]===
1||this.read("truncated")[0]===1}read(e){return this.call(n=>this.engine._world_read(this.address,n.text(e)))[e]}view(e){let n=3*this.config.fov**2;return this.
read("views").slice(e*n,(e+1)*n)}map(){return this.read("state").slice(2*this.config.rows*this.config.cols)}conflicts(){return kt(this.conflictTable(),this.config.
n_pursuers)}conflictTable(){return this.call(()=>this.engine._world_conflicts(this.address)).conflict_table}answer(e,n){let r=Re(e),{logits:o,memory:s}=this.call(
l=>this.engine._world_logits(this.address,l.arrays(r),n)),a=o,i=this.decide(e,[n,n+1],new Uint8Array(this.n_agents))[n];return{logits:a,probabilities:Ja(a),action:i,
memory:s}}rate(e,n){let r=Re(e),{ratings:o,refused:s}=this.call(c=>this.engine._world_rate(this.address,c.arrays(r),n)),a=this.read("inputs"),i=a.length/this.n_agents/
this.n_actions,l=c=>Float32Array.from({length:this.n_actions},(m,u)=>a[(n*this.n_actions+u)*i+c]);return{inputs:e.inputs.map(c=>l(On(c))),ratings:o,refused:s}}snapshot(){
return this.call(()=>this.engine._world_snapshot(this.address))}restore(e){let n=Wr(e);this.call(r=>this.engine._world_restore(this.address,r.arrays(n)))}call(e){
return Te(this.engine,e),He(this.engine)}};function Ja(t){let e=Math.max(...t),n=Array.from(t,o=>Math.exp(o-e)),r=n.reduce((o,s)=>o+s,0);return Float32Array.from(
n,o=>o/r)}var _n=class{compiled;constructor(e){this.compiled=e}world(e){return new lt(this.compiled,e)}solution(e,n="capture-rate"){return new it(this.compiled,e,n)}match(e,n,r,o,s=0){
return zr(this.compiled,{config:e,pursuers:n,evaders:r},o,s)}rollouts(e,n,r,o,s){return Br(this.compiled,{config:e,pursuers:n,evaders:r},o,s)}},Gr;function jr(t=globalThis.
matrixworldEngine){return Gr??=Xa(t),Gr}async function Xa(t){if(!t)throw new Error("matrixworldEngine: expected the script engine.js before this one, got none");
let e=Uint8Array.from(atob(t.binary),n=>n.charCodeAt(0));return new _n(await t({wasmBinary:e}))}var Qa="http://www.w3.org/2000/svg";function p(t,e={},...n){return Vr(document.createElement(t),e,n)}function S(t,e={},...n){return Vr(document.createElementNS(
Qa,t),e,n)}function Vr(t,e,n){for(let[o,s]of Object.entries(e))s==null||s===!1||(typeof s=="function"?t.addEventListener(o.slice(2),s):t.setAttribute(o,s===!0?"":
String(s)));let r=n.filter(o=>o!=null&&o!==!1);return t.append(...r.map(o=>typeof o=="number"?String(o):o)),t}function Kr(t,e){let n=p("select",{onchange:()=>e(
n.value)},...t.map(([r,o])=>p("option",{value:r},o)));return n}async function Yr(t){try{await t}catch(e){let n=document.querySelector("#page, main")??document.body;
throw n.querySelector(".absent")?.remove(),n.prepend(p("p",{class:"card problem",role:"alert"},e instanceof WebAssembly.CompileError||/WebAssembly/.test(String(
e))?"This page plays by WebAssembly, which is forbidden where it lies ('wasm-unsafe-eval' is missing in the content policy): save the file, and open it from you\
r disk.":`The page could not start: ${String(e)}`)),e}finally{document.body.dataset.ready="true"}}var qr=()=>["file:","http:","https:"].includes(location.protocol);var Zr=()=>document.documentElement.dataset.theme==="dark";function ct(t){document.documentElement.dataset.theme=t?"dark":"light"}var Nn=()=>ct(!Zr());if(typeof document<
"u"){let t=matchMedia("(prefers-color-scheme: dark)");t.addEventListener("change",()=>ct(t.matches)),ct(t.matches);let e=!1;addEventListener("beforeprint",()=>{
e=Zr(),ct(!1)}),addEventListener("afterprint",()=>ct(e))}function Jr(){return p("button",{type:"button",title:"Light or dark (D)","aria-label":"Light or dark",onclick:Nn},
"◐")}var Xr=(t,e,...n)=>p("header",{class:"top"},p("div",{},p("h1",{},t),e?p("p",{class:"lead"},e):null),p("div",{class:"tools"},...n,Jr()));var ei=2n**64n-1n;function ut(t,e,n){let r=new URLSearchParams(t.replace(/^#/,"")),o=(c,m,u)=>{let d=r.get(c)??"";return/^\d{1,9}$/.test(d)&&Number(d)<m?Number(
d):u},s=o("run",e.length,n.run),[a,i]=e[s].payoff.shape,l=r.get("seed")??"";return{run:s,pursuer:o("pursuers",a,Math.min(n.pursuer,a-1)),evader:o("evaders",i,Math.
min(n.evader,i-1)),episode:o("episode",1/0,n.episode),seed:/^\d{1,20}$/.test(l)&&BigInt(l)<=ei?l:null,step:o("step",1/0,0)}}function eo(t,e,n){let r="",o=JSON.stringify(
e.selected),s=-800,a=()=>{let{run:i,pursuer:l,evader:c,episode:m,seed:u}=e.selected,d={run:i,pursuers:l,evaders:c,episode:m,...u===null?{}:{seed:u},step:n.player.
step},h=JSON.stringify(e.selected),y=h!==o&&performance.now()-s>800;h!==o&&(o=h,s=performance.now()),r=`#${Object.entries(d).map(([f,g])=>`${f}=${g}`).join("&")}`;
try{y?history.pushState(null,"",r):history.replaceState(null,"",r)}catch{}};a(),e.on("match",a),n.player.addEventListener("state",()=>n.player.playing||a()),n.player.
addEventListener("step",()=>n.player.playing||a()),window.addEventListener("hashchange",()=>{if(location.hash===r)return;let{step:i,...l}=ut(location.hash,t,e.selected);
for(let c of document.querySelectorAll("dialog[open]"))c.close();o=JSON.stringify(l),e.select(l),n.goTo(i)})}var ti=5e3,Qr=8e3;function to(t,e,n){let r=-Qr;for(let o of[
"pointerdown","pointermove","keydown","wheel"])window.addEventListener(o,()=>r=performance.now(),{passive:!0});setInterval(()=>{if(n()||performance.now()-r<Qr)return;
let{run:o,pursuer:s,evader:a}=e.selected,[i,l]=t[o].payoff.shape;s===i-1&&a===l-1&&history.replaceState(null,"",`#run=${o}`),location.reload()},ti)}var D=Uint8Array,se=Uint16Array,Hn=Int32Array,Nt=new D([0,0,0,0,0,0,0,0,1,1,1,1,2,2,2,2,3,3,3,3,4,4,4,4,5,5,5,5,0,0,0,0]),It=new D([0,0,0,0,1,1,2,2,3,3,4,4,5,5,
6,6,7,7,8,8,9,9,10,10,11,11,12,12,13,13,0,0]),Un=new D([16,17,18,0,8,7,9,6,10,5,11,4,12,3,13,2,14,1,15]),io=function(t,e){for(var n=new se(31),r=0;r<31;++r)n[r]=
e+=1<<t[r-1];for(var o=new Hn(n[30]),r=1;r<30;++r)for(var s=n[r];s<n[r+1];++s)o[s]=s-n[r]<<5|r;return{b:n,r:o}},lo=io(Nt,2),co=lo.b,Dn=lo.r;co[28]=258,Dn[258]=28;
var uo=io(It,0),ni=uo.b,no=uo.r,Fn=new se(32768);for($=0;$<32768;++$)xe=($&43690)>>1|($&21845)<<1,xe=(xe&52428)>>2|(xe&13107)<<2,xe=(xe&61680)>>4|(xe&3855)<<4,Fn[$]=
((xe&65280)>>8|(xe&255)<<8)>>1;var xe,$,ye=(function(t,e,n){for(var r=t.length,o=0,s=new se(e);o<r;++o)t[o]&&++s[t[o]-1];var a=new se(e);for(o=1;o<e;++o)a[o]=a[o-
1]+s[o-1]<<1;var i;if(n){i=new se(1<<e);var l=15-e;for(o=0;o<r;++o)if(t[o])for(var c=o<<4|t[o],m=e-t[o],u=a[t[o]-1]++<<m,d=u|(1<<m)-1;u<=d;++u)i[Fn[u]>>l]=c}else
for(i=new se(r),o=0;o<r;++o)t[o]&&(i[o]=Fn[a[t[o]-1]++]>>15-t[o]);return i}),Ae=new D(288);for($=0;$<144;++$)Ae[$]=8;var $;for($=144;$<256;++$)Ae[$]=9;var $;for($=
256;$<280;++$)Ae[$]=7;var $;for($=280;$<288;++$)Ae[$]=8;var $,dt=new D(32);for($=0;$<32;++$)dt[$]=5;var $,ri=ye(Ae,9,0),oi=ye(Ae,9,1),si=ye(dt,5,0),ai=ye(dt,5,1),
In=function(t){for(var e=t[0],n=1;n<t.length;++n)t[n]>e&&(e=t[n]);return e},pe=function(t,e,n){var r=e/8|0;return(t[r]|t[r+1]<<8)>>(e&7)&n},Ln=function(t,e){var n=e/
8|0;return(t[n]|t[n+1]<<8|t[n+2]<<16)>>(e&7)},Gn=function(t){return(t+7)/8|0},jn=function(t,e,n){return(e==null||e<0)&&(e=0),(n==null||n>t.length)&&(n=t.length),
new D(t.subarray(e,n))};var ii=["unexpected EOF","invalid block type","invalid length/literal","invalid distance","stream finished","no stream handler",,"no callback","invalid UTF-8 da\
ta","extra field too long","date not in range 1980-2099","filename too long","stream finishing","invalid zip data"],te=function(t,e,n){var r=new Error(e||ii[t]);
if(r.code=t,Error.captureStackTrace&&Error.captureStackTrace(r,te),!n)throw r;return r},li=function(t,e,n,r){var o=t.length,s=r?r.length:0;if(!o||e.f&&!e.l)return n||
new D(0);var a=!n,i=a||e.i!=2,l=e.i;a&&(n=new D(o*3));var c=function(tt){var nt=n.length;if(tt>nt){var De=new D(Math.max(nt*2,tt));De.set(n),n=De}},m=e.f||0,u=e.
p||0,d=e.b||0,h=e.l,y=e.d,f=e.m,g=e.n,v=o*8;do{if(!h){m=pe(t,u,1);var w=pe(t,u+1,3);if(u+=3,w)if(w==1)h=oi,y=ai,f=9,g=5;else if(w==2){var k=pe(t,u,31)+257,R=pe(
t,u+10,15)+4,E=k+pe(t,u+5,31)+1;u+=14;for(var T=new D(E),F=new D(19),W=0;W<R;++W)F[Un[W]]=pe(t,u+W*3,7);u+=R*3;for(var j=In(F),fe=(1<<j)-1,J=ye(F,j,1),W=0;W<E;){
var Z=J[pe(t,u,fe)];u+=Z&15;var b=Z>>4;if(b<16)T[W++]=b;else{var I=0,O=0;for(b==16?(O=3+pe(t,u,3),u+=2,I=T[W-1]):b==17?(O=3+pe(t,u,7),u+=3):b==18&&(O=11+pe(t,u,
127),u+=7);O--;)T[W++]=I}}var x=T.subarray(0,k),A=T.subarray(k);f=In(x),g=In(A),h=ye(x,f,1),y=ye(A,g,1)}else te(1);else{var b=Gn(u)+4,M=t[b-4]|t[b-3]<<8,C=b+M;if(C>
o){l&&te(0);break}i&&c(d+M),n.set(t.subarray(b,C),d),e.b=d+=M,e.p=u=C*8,e.f=m;continue}if(u>v){l&&te(0);break}}i&&c(d+131072);for(var H=(1<<f)-1,P=(1<<g)-1,V=u;;V=
u){var I=h[Ln(t,u)&H],X=I>>4;if(u+=I&15,u>v){l&&te(0);break}if(I||te(2),X<256)n[d++]=X;else if(X==256){V=u,h=null;break}else{var oe=X-254;if(X>264){var W=X-257,
U=Nt[W];oe=pe(t,u,(1<<U)-1)+co[W],u+=U}var ge=y[Ln(t,u)&P],We=ge>>4;ge||te(3),u+=ge&15;var A=ni[We];if(We>3){var U=It[We];A+=Ln(t,u)&(1<<U)-1,u+=U}if(u>v){l&&te(
0);break}i&&c(d+131072);var Ue=d+oe;if(d<A){var Ct=s-A,Et=Math.min(A,Ue);for(Ct+d<0&&te(3);d<Et;++d)n[d]=r[Ct+d]}for(;d<Ue;++d)n[d]=n[d-A]}}e.l=h,e.p=V,e.b=d,e.
f=m,h&&(m=1,e.m=f,e.d=y,e.n=g)}while(!m);return d!=n.length&&a?jn(n,0,d):n.subarray(0,d)},Se=function(t,e,n){n<<=e&7;var r=e/8|0;t[r]|=n,t[r+1]|=n>>8},mt=function(t,e,n){
n<<=e&7;var r=e/8|0;t[r]|=n,t[r+1]|=n>>8,t[r+2]|=n>>16},Wn=function(t,e){for(var n=[],r=0;r<t.length;++r)t[r]&&n.push({s:r,f:t[r]});var o=n.length,s=n.slice();if(!o)
return{t:po,l:0};if(o==1){var a=new D(n[0].s+1);return a[n[0].s]=1,{t:a,l:1}}n.sort(function(C,k){return C.f-k.f}),n.push({s:-1,f:25001});var i=n[0],l=n[1],c=0,
m=1,u=2;for(n[0]={s:-1,f:i.f+l.f,l:i,r:l};m!=o-1;)i=n[n[c].f<n[u].f?c++:u++],l=n[c!=m&&n[c].f<n[u].f?c++:u++],n[m++]={s:-1,f:i.f+l.f,l:i,r:l};for(var d=s[0].s,r=1;r<
o;++r)s[r].s>d&&(d=s[r].s);var h=new se(d+1),y=zn(n[m-1],h,0);if(y>e){var r=0,f=0,g=y-e,v=1<<g;for(s.sort(function(k,R){return h[R.s]-h[k.s]||k.f-R.f});r<o;++r){
var w=s[r].s;if(h[w]>e)f+=v-(1<<y-h[w]),h[w]=e;else break}for(f>>=g;f>0;){var b=s[r].s;h[b]<e?f-=1<<e-h[b]++-1:++r}for(;r>=0&&f;--r){var M=s[r].s;h[M]==e&&(--h[M],
++f)}y=e}return{t:new D(h),l:y}},zn=function(t,e,n){return t.s==-1?Math.max(zn(t.l,e,n+1),zn(t.r,e,n+1)):e[t.s]=n},ro=function(t){for(var e=t.length;e&&!t[--e];)
;for(var n=new se(++e),r=0,o=t[0],s=1,a=function(l){n[r++]=l},i=1;i<=e;++i)if(t[i]==o&&i!=e)++s;else{if(!o&&s>2){for(;s>138;s-=138)a(32754);s>2&&(a(s>10?s-11<<5|
28690:s-3<<5|12305),s=0)}else if(s>3){for(a(o),--s;s>6;s-=6)a(8304);s>2&&(a(s-3<<5|8208),s=0)}for(;s--;)a(o);s=1,o=t[i]}return{c:n.subarray(0,r),n:e}},pt=function(t,e){
for(var n=0,r=0;r<e.length;++r)n+=t[r]*e[r];return n},mo=function(t,e,n){var r=n.length,o=Gn(e+2);t[o]=r&255,t[o+1]=r>>8,t[o+2]=t[o]^255,t[o+3]=t[o+1]^255;for(var s=0;s<
r;++s)t[o+s+4]=n[s];return(o+4+r)*8},oo=function(t,e,n,r,o,s,a,i,l,c,m){Se(e,m++,n),++o[256];for(var u=Wn(o,15),d=u.t,h=u.l,y=Wn(s,15),f=y.t,g=y.l,v=ro(d),w=v.c,
b=v.n,M=ro(f),C=M.c,k=M.n,R=new se(19),E=0;E<w.length;++E)++R[w[E]&31];for(var E=0;E<C.length;++E)++R[C[E]&31];for(var T=Wn(R,7),F=T.t,W=T.l,j=19;j>4&&!F[Un[j-1]];--j)
;var fe=c+5<<3,J=pt(o,Ae)+pt(s,dt)+a,Z=pt(o,d)+pt(s,f)+a+14+3*j+pt(R,F)+2*R[16]+3*R[17]+7*R[18];if(l>=0&&fe<=J&&fe<=Z)return mo(e,m,t.subarray(l,l+c));var I,O,x,
A;if(Se(e,m,1+(Z<J)),m+=2,Z<J){I=ye(d,h,0),O=d,x=ye(f,g,0),A=f;var H=ye(F,W,0);Se(e,m,b-257),Se(e,m+5,k-1),Se(e,m+10,j-4),m+=14;for(var E=0;E<j;++E)Se(e,m+3*E,F[Un[E]]);
m+=3*j;for(var P=[w,C],V=0;V<2;++V)for(var X=P[V],E=0;E<X.length;++E){var oe=X[E]&31;Se(e,m,H[oe]),m+=F[oe],oe>15&&(Se(e,m,X[E]>>5&127),m+=X[E]>>12)}}else I=ri,
O=Ae,x=si,A=dt;for(var E=0;E<i;++E){var U=r[E];if(U>255){var oe=U>>18&31;mt(e,m,I[oe+257]),m+=O[oe+257],oe>7&&(Se(e,m,U>>23&31),m+=Nt[oe]);var ge=U&31;mt(e,m,x[ge]),
m+=A[ge],ge>3&&(mt(e,m,U>>5&8191),m+=It[ge])}else mt(e,m,I[U]),m+=O[U]}return mt(e,m,I[256]),m+O[256]},ci=new Hn([65540,131080,131088,131104,262176,1048704,1048832,
2114560,2117632]),po=new D(0),ui=function(t,e,n,r,o,s){var a=s.z||t.length,i=new D(r+a+5*(1+Math.ceil(a/7e3))+o),l=i.subarray(r,i.length-o),c=s.l,m=(s.r||0)&7;if(e){
m&&(l[0]=s.r>>3);for(var u=ci[e-1],d=u>>13,h=u&8191,y=(1<<n)-1,f=s.p||new se(32768),g=s.h||new se(y+1),v=Math.ceil(n/3),w=2*v,b=function(xn){return(t[xn]^t[xn+1]<<
v^t[xn+2]<<w)&y},M=new Hn(25e3),C=new se(288),k=new se(32),R=0,E=0,T=s.i||0,F=0,W=s.w||0,j=0;T+2<a;++T){var fe=b(T),J=T&32767,Z=g[fe];if(f[J]=Z,g[fe]=J,W<=T){var I=a-
T;if((R>7e3||F>24576)&&(I>423||!c)){m=oo(t,l,0,M,C,k,E,F,j,T-j,m),F=R=E=0,j=T;for(var O=0;O<286;++O)C[O]=0;for(var O=0;O<30;++O)k[O]=0}var x=2,A=0,H=h,P=J-Z&32767;
if(I>2&&fe==b(T-P))for(var V=Math.min(d,I)-1,X=Math.min(32767,T),oe=Math.min(258,I);P<=X&&--H&&J!=Z;){if(t[T+x]==t[T+x-P]){for(var U=0;U<oe&&t[T+U]==t[T+U-P];++U)
;if(U>x){if(x=U,A=P,U>V)break;for(var ge=Math.min(P,U-2),We=0,O=0;O<ge;++O){var Ue=T-P+O&32767,Ct=f[Ue],Et=Ue-Ct&32767;Et>We&&(We=Et,Z=Ue)}}}J=Z,Z=f[J],P+=J-Z&32767}
if(A){M[F++]=268435456|Dn[x]<<18|no[A];var tt=Dn[x]&31,nt=no[A]&31;E+=Nt[tt]+It[nt],++C[257+tt],++k[nt],W=T+x,++R}else M[F++]=t[T],++C[t[T]]}}for(T=Math.max(T,W);T<
a;++T)M[F++]=t[T],++C[t[T]];m=oo(t,l,c,M,C,k,E,F,j,T-j,m),c||(s.r=m&7|l[m/8|0]<<3,m-=7,s.h=g,s.p=f,s.i=T,s.w=W)}else{for(var T=s.w||0;T<a+c;T+=65535){var De=T+65535;
De>=a&&(l[m/8|0]=c,De=a),m=mo(l,m+1,t.subarray(T,De))}s.i=a}return jn(i,0,r+Gn(m)+o)},mi=(function(){for(var t=new Int32Array(256),e=0;e<256;++e){for(var n=e,r=9;--r;)
n=(n&1&&-306674912)^n>>>1;t[e]=n}return t})(),pi=function(){var t=-1;return{p:function(e){for(var n=t,r=0;r<e.length;++r)n=mi[n&255^e[r]]^n>>>8;t=n},d:function(){
return~t}}};var di=function(t,e,n,r,o){if(!o&&(o={l:1},e.dictionary)){var s=e.dictionary.subarray(-32768),a=new D(s.length+t.length);a.set(s),a.set(t,s.length),t=a,o.w=s.length}
return ui(t,e.level==null?6:e.level,e.mem==null?o.l?Math.ceil(Math.max(8,Math.min(13,Math.log(t.length)))*1.5):20:12+e.mem,n,r,o)},ho=function(t,e){var n={};for(var r in t)
n[r]=t[r];for(var r in e)n[r]=e[r];return n};var q=function(t,e,n){for(;n;++e)t[e]=n,n>>>=8};var hi=function(t,e){return((t[0]&15)!=8||t[0]>>4>7||(t[0]<<8|t[1])%31)&&te(6,"invalid zlib data"),(t[1]>>5&1)==+!e&&te(6,"invalid zlib data: "+(t[1]&32?"need":
"unexpected")+" dictionary"),(t[1]>>3&4)+2};function fi(t,e){return di(t,e||{},0,0)}function fo(t,e){return li(t.subarray(hi(t,e&&e.dictionary),-4),{i:2},e&&e.out,e&&e.dictionary)}var go=function(t,e,n,r){for(var o in t){var s=t[o],a=e+o,i=r;Array.isArray(s)&&(i=ho(r,s[1]),s=s[0]),s instanceof D?n[a]=[s,i]:(n[a+="/"]=[new D(0),i],go(s,a,n,
r))}},so=typeof TextEncoder<"u"&&new TextEncoder,gi=typeof TextDecoder<"u"&&new TextDecoder,yi=0;try{gi.decode(po,{stream:!0}),yi=1}catch{}function _t(t,e){if(e){for(var n=new D(t.length),r=0;r<t.length;++r)n[r]=t.charCodeAt(r);return n}if(so)return so.encode(t);for(var o=t.length,s=new D(t.length+
(t.length>>1)),a=0,i=function(m){s[a++]=m},r=0;r<o;++r){if(a+5>s.length){var l=new D(a+8+(o-r<<1));l.set(s),s=l}var c=t.charCodeAt(r);c<128||e?i(c):c<2048?(i(192|
c>>6),i(128|c&63)):c>55295&&c<57344?(c=65536+(c&1047552)|t.charCodeAt(++r)&1023,i(240|c>>18),i(128|c>>12&63),i(128|c>>6&63),i(128|c&63)):(i(224|c>>12),i(128|c>>
6&63),i(128|c&63))}return jn(s,0,a)}var Bn=function(t){var e=0;if(t)for(var n in t){var r=t[n].length;r>65535&&te(9),e+=r+4}return e},ao=function(t,e,n,r,o,s,a,i){var l=r.length,c=n.extra,m=i&&i.length,
u=Bn(c);q(t,e,a!=null?33639248:67324752),e+=4,a!=null&&(t[e++]=20,t[e++]=n.os),t[e]=20,e+=2,t[e++]=n.flag<<1|(s<0&&8),t[e++]=o&&8,t[e++]=n.compression&255,t[e++]=
n.compression>>8;var d=new Date(n.mtime==null?Date.now():n.mtime),h=d.getFullYear()-1980;if((h<0||h>119)&&te(10),q(t,e,h<<25|d.getMonth()+1<<21|d.getDate()<<16|
d.getHours()<<11|d.getMinutes()<<5|d.getSeconds()>>1),e+=4,s!=-1&&(q(t,e,n.crc),q(t,e+4,s<0?-s-2:s),q(t,e+8,n.size)),q(t,e+12,l),q(t,e+14,u),e+=16,a!=null&&(q(t,
e,m),q(t,e+6,n.attrs),q(t,e+10,a),e+=14),t.set(r,e),e+=l,u)for(var y in c){var f=c[y],g=f.length;q(t,e,+y),q(t,e+2,g),t.set(f,e+4),e+=4+g}return m&&(t.set(i,e),
e+=m),e},vi=function(t,e,n,r,o){q(t,e,101010256),q(t,e+8,n),q(t,e+10,n),q(t,e+12,r),q(t,e+16,o)};function yo(t,e){e||(e={});var n={},r=[];go(t,"",n,e);var o=0,s=0;for(var a in n){var i=n[a],l=i[0],c=i[1],m=c.level==0?0:8,u=_t(a),d=u.length,h=c.comment,y=h&&
_t(h),f=y&&y.length,g=Bn(c.extra);d>65535&&te(11);var v=m?fi(l,c):l,w=v.length,b=pi();b.p(l),r.push(ho(c,{size:l.length,crc:b.d(),c:v,f:u,m:y,u:d!=a.length||y&&
h.length!=f,o,compression:m})),o+=30+d+g+w,s+=76+2*(d+g)+(f||0)+w}for(var M=new D(s+22),C=o,k=s-o,R=0;R<r.length;++R){var u=r[R];ao(M,u.o,u,u.f,u.u,u.c.length);
var E=30+u.f.length+Bn(u.extra);M.set(u.c,u.o+E),ao(M,o,u,u.f,u.u,u.c.length,u.o,u.m),o+=16+E+(u.m?u.m.length:0)}return vi(M,o,r.length,k,C),M}var B=["pursuer","evader"],Oe=t=>t==="pursuer"?"evader":"pursuer";var bi={teams:{pursuer:"pursuers",evader:"evaders"},generation:{pursuer:"pursuer generation",evader:"evader generation"},score:"capture rate",means:{pursuer:"ca\
ptures",evader:"escapes"},curves:{pursuer:"captures",evader:"escapes"},ends:["0 all escape","1 all caught"],lead:"Each cell is a match between two generations: \
the brighter, the more evaders are captured. Click one to watch it.",click:"watch its match"},vo=([t,e])=>({teams:{pursuer:t,evader:e},generation:{pursuer:`gene\
ration of ${t}`,evader:`generation of ${e}`},score:`score of the ${t}`,means:{pursuer:t,evader:e},curves:{pursuer:"scores",evader:"scores"},ends:[`0 the ${e} wi\
n`,`1 the ${t} win`],lead:`Each cell is a pair of generations: the brighter, the higher the score of the ${t}. Click one to see more of it.`,click:"see more of \
it"}),wi=["0 worst","1 best"],xi=t=>({...vo([t,t]),generation:{pursuer:`generation of ${t}`,evader:"generation of the opponent"},score:"score",ends:["0 loses","\
1 wins"],lead:`Each cell is a pair of generations of ${t}: the brighter, the higher the score of the row. Click one to see more of it.`}),$e=({game:t})=>t&&t.teams[0]===
t.teams[1]?B.slice(0,1):B,_=t=>{if(!t.game)return bi;let e=$e(t).length===1?xi(t.game.teams[0]):vo(t.game.teams);return t.payoff?.others?{...e,ends:wi}:e},G=(t,e,n)=>`${_(
t).teams[e]} of generation ${n}`;var wo=()=>JSON.parse(Dt("data"));function Ce(t,e,n){let r=e-t.payoff.first[0],o=n-t.payoff.first[1],s=t.payoff.capture_rate[r]?.[o];return s===void 0?null:{rate:s,
rates:t.payoff.capture_rates[r][o],lengths:t.payoff.lengths[r]?.[o]??[]}}function je(t,e,n){let{script:r,policy:o,kept:s,genomes:a}=t.teams[e];if(r!==null||o===
null)return"";if(!s.includes(n))return`The page holds no genome of ${G(t,e,n)}: it would be too large. Choose a generation of ${s.join(", ")}.`;let i=s.length*o.
genome_size;return xo(a,o.genome_size).length===i?"":`The page is damaged: it does not hold the ${i} numbers of the ${e}s' genomes. Write it again from its run.`}
function ne(t,e,n){let{script:r,policy:o,kept:s,genomes:a}=t.teams[e];if(r!==null||o===null)return r??"random";let i=s.indexOf(n);if(i<0)throw new RangeError(`${e}\
: expected a generation whose genome the page holds, got ${n}`);let l=o.genome_size,c=xo(a,l).subarray(i*l,(i+1)*l);return{...o,genome:c}}var Lt=({teams:t},e)=>(t[e].
policy??{kind:"cells"}).kind!=="cells";function Wt({teams:t},e,n){let{kept:r,expressions:o,weights:s}=t[e],a=r.indexOf(n),i=o?.[a];return i?{expression:i,weights:s?.[a]??
null}:null}function ht(t,e){return t.kind==="program"?e?.weights??null:t.hidden.length?null:Object.fromEntries(t.inputs.map((n,r)=>[n,t.genome[r]]))}function Ut(t,e,{
pursuer:n,evader:r,episode:o,seed:s}){let a=e.seeds[n][r];return t.match(e.world,ne(e,"pursuer",n),ne(e,"evader",r),BigInt(s??a),o)}var Vn=4,bo=new Map;function xo(t,e){let n=bo.get(t);if(n)return n;let r=new Float32Array;try{let o=Mi(Kn(t),e);o.every(Number.isFinite)&&(r=o)}catch(o){if(!(o instanceof DOMException||
o instanceof RangeError||Si(o)))throw o}return bo.set(t,r),r}var Si=t=>t instanceof Error&&"code"in t;function Mi(t,e){let n=fo(t),r=n.length/Vn,o=new Uint8Array(
n.length);for(let a=0;a<o.length;a++)o[a]=n[a%Vn*r+Math.floor(a/Vn)];let s=new Uint32Array(o.buffer);for(let a=e;a<s.length;a++)s[a]^=s[a-e];return new Float32Array(
o.buffer)}function Kn(t){let e=atob(Dt(t)),n=new Uint8Array(e.length);for(let r=0;r<n.length;r++)n[r]=e.charCodeAt(r);return n}var Dt=t=>document.getElementById(
t)?.textContent??"";var ft=[.5,1,2,4,8,16,32,64],Ft=0,zt=12,Ti=2,Ve=class extends EventTarget{#e;#r;#n;#o=0;#c=0;#a=!1;#m=null;#d=0;#g=[];#h=[];glide=.28;constructor(e,{speed:n=4,still:r=!1}={}){
super(),this.#e=e,this.#r=n,this.#n=r}get step(){return this.#o}get time(){return this.#n?this.#o:this.#c}get arrived(){return this.#c===this.#o}get playing(){return this.#a}get length(){
return this.#e}set length(e){this.#e=e,this.#o>e&&this.jump(e),this.#t("state")}get marks(){return this.#g}set marks(e){this.#g=e,this.#t("state")}get ticks(){return this.#h}set ticks(e){
this.#h=e,this.#t("state")}get pace(){return this.#r||Math.max(Ti,this.#e/zt)}get speed(){return this.#r}set speed(e){this.#r=e,this.#t("state")}changeSpeed(e){
let n=ft.findIndex(r=>r>=this.pace);this.speed=ft[Math.min(ft.length-1,Math.max(0,n+e))]}play(){this.#a||!this.#e||(this.#o===this.#e&&this.jump(0),this.#a=!0,this.#t(
"state"),this.#p())}pause(){this.#a&&(this.#a=!1,this.#t("state"))}toggle(){this.#a?this.pause():this.play()}move(e){this.pause();let n=Math.min(this.#e,Math.max(
0,this.#o+e));Math.abs(n-this.#c)>1?this.jump(n):this.#u(n),this.#p()}jump(e){this.#c=Math.min(this.#e,Math.max(0,Math.round(e))),this.#u(this.#c),this.#t("fram\
e")}#u(e){e!==this.#o&&(this.#o=e,this.#t("step"),this.#n&&this.#t("frame"))}#p(){this.#m===null&&(this.#d=performance.now(),this.#m=requestAnimationFrame(()=>this.#i()))}#i(){
this.#m=null;let e=performance.now();this.#l(Math.min(.25,(e-this.#d)/1e3)),this.#d=e,(!this.#n||this.arrived)&&this.#t("frame"),(this.#a||this.#c!==this.#o)&&(this.#m=
requestAnimationFrame(()=>this.#i()))}#l(e){let n=e;for(;n>0;){if(this.#c===this.#o){if(!this.#a)return;if(this.#o===this.#e)return this.pause();this.#u(this.#o+
1)}let r=this.#a?this.pace:1/this.glide,o=this.#o-this.#c,s=Math.min(Math.abs(o),n*r);n-=s/r,this.#c=s===Math.abs(o)?this.#o:this.#c+Math.sign(o)*s}this.#a&&this.#c===
this.#e&&this.pause()}#t(e){this.dispatchEvent(new Event(e))}};function Ke(t,e){if(e.ctrlKey||e.metaKey||e.altKey)return!1;let n=e.shiftKey?10:1,o={" ":()=>t.toggle(),
ArrowRight:()=>t.move(n),ArrowLeft:()=>t.move(-n),Home:()=>t.move(-t.length),End:()=>t.move(t.length),"+":()=>t.changeSpeed(1),"-":()=>t.changeSpeed(-1)}[e.key];
return o?.(),o!==void 0}function So(t,e,...n){let r=p("dialog",{class:e,"aria-label":t,onclick:({target:o})=>o===r&&r.close()},p("div",{class:"dialog-head"},p("h2",{},t),p("button",{type:"\
button",class:"close","aria-label":"Close",onclick:()=>r.close()},"✕")),...n);return r}var Mo=t=>p("dl",{class:"keys"},...t.flatMap(([e,n])=>[p("dt",{},...e.map(
r=>p("kbd",{},r))),p("dd",{},n)])),To=t=>p("input",{type:"text",readonly:!0,"aria-label":t});function Ao(t,e){t.value=e,t.hidden=!1,t.select(),navigator.clipboard?.
writeText(e).catch(()=>{})}function Co(t,e){let n=URL.createObjectURL(new Blob([e],{type:"application/octet-stream"}));p("a",{href:n,download:t}).click(),setTimeout(
()=>URL.revokeObjectURL(n),6e4)}var N=(t,e=2)=>t==null?"-":t.toFixed(e);function Eo(t,e,n){return e===null||n===null?N(t):`${N(t)} (${N(e)} to ${N(n)})`}function gt(t){let e=Math.abs(t),n=e>=1e4?
e.toExponential(0):e.toFixed(e<100?2:0);return t<0&&Number(n)?`−${n}`:n}var ko=t=>t.toLocaleString("en-GB"),ve=t=>t.charAt(0).toUpperCase()+t.slice(1);function yt(t,e,n,r=!1){
let o=(e-t)/Math.max(1,n),s=10**Math.floor(Math.log10(o||1)),a=[1,2,5,10].map(c=>c*s).find(c=>c>=o)??10*s;r&&(a=Math.max(1,Math.round(a)));let i=Math.ceil(t/a-1e-9),
l=Math.floor(e/a+1e-9);return Array.from({length:Math.max(0,l-i+1)},(c,m)=>(i+m)*a)}var vt=[[68,1,84],[72,26,108],[71,47,125],[65,68,135],[57,86,140],[49,104,142],[42,120,142],[35,136,142],[31,152,139],[34,168,132],[53,183,121],[84,197,104],[122,
209,81],[165,219,54],[210,226,27],[253,231,37]];function Bt(t){let e=Math.min(1,Math.max(0,t))*(vt.length-1),n=Math.min(vt.length-2,Math.floor(e)),r=vt[n],o=vt[n+
1],s=a=>Math.round(r[a]+(e-n)*(o[a]-r[a]));return[s(0),s(1),s(2)]}function Ro(t){let[e,n,r]=Bt(t).map(o=>((o/255+.055)/1.055)**2.4);return .2126*e+.7152*n+.0722*
r>.179?"#000":"#fff"}var Oo=t=>`rgb(${Bt(t).join(" ")})`,$o=()=>`linear-gradient(to right, ${vt.map(t=>`rgb(${t.join(" ")})`).join(", ")})`;function Ht(t,e,n){let r=devicePixelRatio||1;for(let[a,i]of Object.entries(n))t.style.setProperty(a,`${i}px`);t.width=Math.round(n.width*r),t.height=Math.round(
n.height*r);let o=t.getContext("2d"),s=Yn(e);!o||!s||(o.imageSmoothingEnabled=!1,o.drawImage(s,0,0,t.width,t.height))}function Yn(t){let[e,n]=t.shape,r=document.
createElement("canvas");r.width=n,r.height=e;let o=r.getContext("2d");if(!o)return null;let s=o.createImageData(n,e);return t.capture_rate.forEach((a,i)=>a.forEach(
(l,c)=>{let m=4*((e-1-i-t.first[0])*n+c+t.first[1]);s.data.set([...Bt(l),255],m)})),o.putImageData(s,0,0),r}function Gt(t,e,n,r=2){t.textContent=N(e,r),t.ariaLabel=
`${n}: ${t.textContent}`,e!==void 0&&(t.style.backgroundColor=Oo(e),t.style.color=Ro(e))}function Ye(t,e){let n=p("span",{class:"gradient"});return n.style.backgroundImage=
$o(),p("p",{class:"scale-of-rates small muted"},t,n,e)}var Ai=84;function Po(t,e){let n=t.map((s,a)=>Ci(s,a,e)),r=p("nav",{class:"races","aria-label":"Runs"},...n.map(s=>s.button)),o=()=>n.forEach((s,a)=>s.update(a===
e.selected.run));return e.on("match hover",o),o(),r.hidden=t.length<2,r}function Ci(t,e,n){let[r,o]=t.payoff.shape,s=!t.name.startsWith(t.schedule),a=Ai/Math.max(
r,o),i=p("canvas",{"aria-hidden":"true"});Ht(i,t.payoff,{left:0,top:0,width:o*a,height:r*a});let l=p("span",{class:"place"}),c=p("button",{type:"button",class:"\
race",title:`${t.name} (key ${e+1})`,onclick:()=>qn(t,e,n)},p("span",{class:"small-matrix"},i,l),p("span",{class:"race-text"},p("strong",{},s?t.name:t.schedule),
p("span",{class:"small"},t.findings?t.findings.sentence:`${t.learning.map(u=>_(t).teams[u]).join(" and ")} against ${Ei(t)}`),p("span",{class:"small muted"},`${s?
`${t.schedule}, `:""}seed ${t.seed}`)));return{button:c,update:u=>{c.setAttribute("aria-current",String(u));let d=n.hover.pursuer??n.selected.pursuer,h=n.hover.
evader??n.selected.evader;l.hidden=d>=r||h>=o,l.style.left=`${(h+.5)*a}px`,l.style.top=`${(r-d-.5)*a}px`}}}var Ei=t=>t.teams.pursuer.script??t.teams.evader.script??
"another run";function qn(t,e,n){let[r,o]=t.payoff.shape,{pursuer:s,evader:a}=n.selected;n.select({run:e,pursuer:Math.min(s,r-1),evader:Math.min(a,o-1)})}var ki=t=>[[["Space"],"play or pause"],[["←","→"],"step back or forward; with Shift ten steps"],[["Home","End"],"first or last step"],[["+","−"],"faster o\
r slower"],[["N"],"next episode of the same pair; with Shift the one before"],[["R"],"another seed, not one of the evaluation"],[["O"],"the cell's own seed agai\
n"],[["P"],`next ${_(t).generation.pursuer}; with Shift the one before`],[["E"],`next ${_(t).generation.evader}; with Shift the one before`],[["M"],`to the matr\
ix: arrow keys choose a ${t.game?"pair, Enter shows it":"match, Enter plays it"}`],[["A"],"next agent: what it sees; with Shift the one before"],[["I"],"inputs \
of the next move of that agent on the board; with Shift of the one before"],[["Esc"],"no agent"],[["T"],"take over the chosen agent, or an evader, from this ste\
p on"],[["G"],"this step in the playground: any other rules, actions and places"],[["1","9"],"first to ninth run"],[["D"],"light or dark"],[["?"],"this list"]],
Ri=["P","E","M","1","D","?"],Oi="The page holds the genomes and the engine of this run. A click on a cell plays that very match: same seed, same moves. ";function _o(t){
let e=t.find(({game:r})=>!r),n=ki(e??t[0]).filter(([[r]])=>e||Ri.includes(r));return So("Keys","help",Mo(n),p("p",{class:"muted small"},`${e?Oi:""}The page load\
s nothing from elsewhere; share the file as it is.`))}function No(t,e,n,r,o,s){let a=(l,c)=>()=>{let m=t[e.selected.run].payoff.shape[l==="pursuer"?0:1];e.select(
{[l]:Math.min(m-1,Math.max(0,e.selected[l]+c))})},i={n:()=>e.select({episode:e.selected.episode+1}),N:()=>e.select({episode:Math.max(0,e.selected.episode-1)}),r:()=>e.
select({seed:String(crypto.getRandomValues(new BigUint64Array(1))[0]),episode:0}),o:()=>e.select({seed:null,episode:0}),p:a("pursuer",1),P:a("pursuer",-1),e:a("\
evader",1),E:a("evader",-1),m:()=>document.getElementById("matrix")?.focus(),a:()=>n.inspector.next(1),A:()=>n.inspector.next(-1),i:()=>n.inspector.ask(1),I:()=>n.
inspector.ask(-1),Escape:()=>n.inspector.choose(null),t:o,g:s,d:Nn,"?":()=>r.showModal()};document.addEventListener("keydown",l=>{let c=l.target instanceof HTMLSelectElement||
l.target instanceof HTMLInputElement,m=l.target instanceof HTMLButtonElement&&(l.key===" "||l.key==="Enter");if(document.querySelector("dialog[open]")||c||m||l.
defaultPrevented||l.ctrlKey||l.metaKey||l.altKey)return;let u=i[l.key]??i[l.key.toLowerCase()],d=Number(l.key)-1;if(Ke(n.player,l)||u)u?.();else if(t[d])qn(t[d],
d,e);else return;l.preventDefault()})}var ae=[[0,0],[-1,0],[0,1],[1,0],[0,-1],[-1,1],[1,1],[1,-1],[-1,-1]];function Io(t,e,n){let r=e[0]-t[0],o=e[1]-t[1];return!n&&Math.abs(r)>Math.abs(o)?o=0:n||(r=
0),ae.findIndex(([s,a])=>s===Math.sign(r)&&a===Math.sign(o))}var Pe=(t,e)=>e<t.nPursuers,L=(t,e)=>[t.positions[2*e],t.positions[2*e+1]],_e=({rows:t,cols:e},[n,r])=>n>=
0&&r>=0&&n<t&&r<e,Zn=(t,e,n=3)=>t!==void 0&&[0,1,2].slice(0,n).some(r=>t[3*e+r]),Jn=(t,e)=>Zn(t.fault,e),Lo=(t,e)=>!Jn(t,e)&&Zn(t.involved,e,2);function jt(t,e,n){
let r=L(t,n),o=L(e,n),s=r[0]!==o[0]||r[1]!==o[1],a=e.involved===void 0||Zn(e.involved,n);return!!(e.alive[n]&&e.actions?.[n]&&!s&&a)}function Vt(t,e,n){let[r,o]=L(
t,n),[s,a]=ae[e.actions?.[n]??0];return[r+s,o+a]}function bt(t,e,n){return Array.from({length:n.everCaptured.length},(o,s)=>s).filter(o=>n.everCaptured[o]&&!e.everCaptured[o]).
map(o=>t.nPursuers+o)}var Wo=t=>t.moments.flatMap((e,n)=>n&&bt(t,t.moments[n-1],e).length?[n]:[]);function Kt(t,e){return Array.from({length:e.alive.length},(r,o)=>o).
filter(r=>t.alive[r]&&!e.alive[r])}var Uo=[-.31,0,.31],Do=[{size:1,at:[[0,0]]},{size:.62,at:[[-.2,.2],[.2,-.2]]},{size:.54,at:[[-.23,.22],[.23,.22],[0,-.22]]},{size:.54,at:[[-.23,.23],[.23,.23],[
-.23,-.23],[.23,-.23]]},{size:.36,at:Uo.flatMap(t=>Uo.map(e=>[e,t]))}],$i=.3,Pi=.35,_i=.55;function wt(t,e){let n=new Map;for(let r=0;r<e.alive.length;r++){if(!e.
alive[r])continue;let[o,s]=L(e,r),a=o*t.cols+s,i=n.get(a);i?i.push(r):n.set(a,[r])}return n}function Fo(t,e){let n=Array.from(e.alive,(r,o)=>{let[s,a]=L(e,o);return{
x:a+.5,y:s+.5,size:1,alpha:0}});for(let r of wt(t,e).values()){let o=Do[Math.min(r.length,Do.length)-1];r.forEach((s,a)=>{let[i,l]=o.at[Math.min(a,o.at.length-1)],
c=n[s];c.x+=i,c.y+=l,c.size=o.size,c.alpha=1})}return n}var zo=t=>t*t*(3-2*t),qe=(t,e,n)=>t+(e-t)*n,Bo=t=>Math.min(1,Math.max(0,t));function Ho(t,e,n,r){let o={
SIMULTANEOUS:1,SWARM_TURNS:2,AGENT_TURNS:n}[t.interaction];if(o===1)return zo(r);let s=o===n?e:+!Pe(t,e),a=Math.max(1/o,Pi);return zo(Bo((r-s/(o-1)*(1-a))/a))}function Yt(t,e){
let n=t.moments.length-1,r=Math.min(Math.floor(e),n),o=t.moments[r],s=Fo(t,o);if(r===n||e===r)return s;let a=t.moments[r+1],i=Fo(t,a);return s.map((l,c)=>{let m=Ho(
t,c,s.length,e-r);return Ni(o,a,c,l,i[c],m)})}function Xn(t,e,n){let r=t.moments.length-1,o=Math.min(Math.floor(n),r),s=t.moments[o],a=t.moments[Math.min(o+1,r)],
i=Ho(t,e,s.alive.length,n-o),[l,c]=L(s,e),[m,u]=L(a,e);return[qe(c,u,i)+.5,qe(l,m,i)+.5]}function Ni(t,e,n,r,o,s){let a=r.alpha>o.alpha,i={x:qe(r.x,o.x,s),y:qe(
r.y,o.y,s),size:a?r.size:qe(r.size,o.size,s),alpha:a?Bo((1-s)/(1-_i)):qe(r.alpha,o.alpha,s)};if(jt(t,e,n)){let[l,c]=L(t,n),[m,u]=Vt(t,e,n),d=$i*Math.sin(Math.PI*
s);i.x+=(u-c)*d,i.y+=(m-l)*d}return i}var Go=2*Math.PI;function de(t,e,n,r){t.beginPath(),t.arc(e,n,r/2,0,Go)}function Ze(t,e,n,r){let o=r/2,s=[[0,-.97],[.97,.83],[-.97,.83]].map(([a,i])=>[e+a*o,n+i*
o]);t.beginPath(),t.moveTo((s[2][0]+s[0][0])/2,(s[2][1]+s[0][1])/2),s.forEach(([a,i],l)=>{let[c,m]=s[(l+1)%3];t.arcTo(a,i,c,m,r*.09)}),t.closePath()}function qt(t,e,n,r){
let o=r*.32;t.beginPath(),t.moveTo(e-o,n-o),t.lineTo(e+o,n+o),t.moveTo(e+o,n-o),t.lineTo(e-o,n+o)}function jo(t,e,n,r){t.beginPath();for(let o=0;o<16;o++){let s=r/
2*(o%2?.6:.95),a=Go*o/16;t.lineTo(e+s*Math.sin(a),n-s*Math.cos(a))}t.closePath()}function Vo(t,e,n,r,o,s){let a=Math.atan2(o-n,r-e);t.beginPath(),t.moveTo(e,n),
t.lineTo(r,o);for(let i of[-1,1])t.moveTo(r,o),t.lineTo(r-s*Math.cos(a+i*.6),o-s*Math.sin(a+i*.6))}var Ko=4,Ii=1.6,Li=.95,Wi=5,Ui=.16,Di=9,Fi=.09,zi=.2,Yo=.75,K=(t,e)=>t.left+e*t.cell,Y=(t,e)=>t.top+e*t.cell;function Je(t,e,n){return Pe(e,n)?t.colors.pursuer:
t.colors.evader}function Zt({ctx:t,colors:e},n,r,o,s,a,i=0){t.font=`700 ${Math.round(s)}px system-ui, sans-serif`,t.textAlign="center",t.textBaseline="middle",t.
strokeStyle=e.paper,t.lineWidth=i,i&&t.strokeText(n,r,o),t.fillStyle=a,t.fillText(n,r,o)}function qo({ctx:t,grid:e,colors:n}){let{left:r,top:o,cell:s,rows:a,cols:i}=e,
l=i*s,c=a*s;if(t.fillStyle=n.paper,t.fillRect(r,o,l,c),s<Wi)return;t.fillStyle=n.line;let m=Math.max(1,Math.round(s/60));for(let u=1;u<i;u++)t.fillRect(r+u*s,o,
m,c);for(let u=1;u<a;u++)t.fillRect(r,o+u*s,l,m)}function Zo({ctx:t,grid:e,colors:n},r){let{left:o,top:s,cell:a,rows:i,cols:l}=e;t.fillStyle=n.obstacle;for(let c=0;c<
i*l;c++){if(!r.obstacles[c])continue;let m=Math.floor(c/l),u=c%l;t.fillRect(o+u*a,s+m*a,a,a)}Jo({ctx:t,grid:e,colors:n})}function Jo({ctx:t,grid:{left:e,top:n,cell:r,
rows:o,cols:s},colors:a}){let i=Math.min(5,Math.max(2,Math.round(r/18)));t.strokeStyle=a.frame,t.lineWidth=i,t.strokeRect(e-i/2,n-i/2,s*r+i,o*r+i)}function Xo({
ctx:t,grid:e,colors:n},r){let{left:o,top:s,cell:a,rows:i,cols:l}=e,c=a<24*r?5:1;t.font=`500 ${Math.round(Math.min(15*r,Math.max(9*r,a*.32)))}px system-ui, sans-\
serif`,t.fillStyle=n.muted,t.textBaseline="alphabetic",t.textAlign="center";let m=5*r+a/40;for(let u=0;u<l;u+=c)t.fillText(String(u),o+(u+.5)*a,s-m);t.textAlign=
"right",t.textBaseline="middle";for(let u=0;u<i;u+=c)t.fillText(String(u),o-m,s+(u+.5)*a)}function Qo({grid:t},e,n,r){let o=Math.floor(e.fov/2)+.5,s=Math.max(0,
n-o),a=Math.min(t.cols,n+o),i=Math.max(0,r-o),l=Math.min(t.rows,r+o);return[K(t,s),Y(t,i),(a-s)*t.cell,(l-i)*t.cell]}function es(t,e,n,r){let{ctx:o,grid:s,colors:a}=t;
o.save(),o.beginPath(),o.rect(0,0,o.canvas.width,o.canvas.height),o.rect(...Qo(t,e,n,r)),o.clip("evenodd"),o.clearRect(0,0,o.canvas.width,o.canvas.height),o.fillStyle=
a.line,o.fillRect(s.left,s.top,s.cols*s.cell,s.rows*s.cell),o.restore(),Jo(t)}function ts(t,{x:e,y:n,alpha:r},o){let{ctx:s,grid:a,colors:i}=t,l=Math.max(a.cell,
16*o)*1.06,c=K(a,e),m=Y(a,n);s.globalAlpha=Math.max(r,.6),s.beginPath(),s.roundRect(c-l/2,m-l/2,l,l,l*.2),s.strokeStyle=i.focus,s.lineWidth=Math.max(2,2.5*o),s.
stroke();let u=Math.max(11*o,Math.min(18*o,a.cell*.5)),d=m-l/2<u*1.2,h=m+(d?1:-1)*(l/2+u*.7);s.lineJoin="round",Zt(t,"You",c,h,u,i.ink,u*.35),s.globalAlpha=1}function ns(t,e,n,r,o){
let{ctx:s,grid:a}=t,i=Qo(t,e,r,o),l=Je(t,e,n);s.globalAlpha=.11,s.fillStyle=l,s.fillRect(...i),s.globalAlpha=.8,s.strokeStyle=l,s.lineWidth=Math.max(1,a.cell/24),
s.strokeRect(...i),s.globalAlpha=1}function rs(t,e,n,r,o){let{ctx:s,grid:a}=t,i=Math.min(Math.ceil(n),e.moments.length-1),l=e.moments[i];s.lineCap="round",s.lineWidth=
Math.min(Di,Math.max(1,a.cell*Ui));for(let c=Math.max(1,Math.floor(n-r)+1);c<=i;c++){let m=e.moments[c-1],u=e.moments[c],d=Math.max(0,Math.min(1,(n-c)/r));s.globalAlpha=
Yo+(zi-Yo)*d;for(let h=0;h<u.alive.length;h++){let y=c===i&&n<i;if(!m.alive[h]||!(l.alive[h]||y))continue;let f=(Pe(e,h)?-1:1)*Fi,[g,v]=L(m,h),[w,b]=L(u,h);if(g===
w&&v===b)continue;let M=y?o[h].x:b+.5,C=y?o[h].y:w+.5;s.strokeStyle=Je(t,e,h),s.beginPath(),s.moveTo(K(a,v+.5+f),Y(a,g+.5+f)),s.lineTo(K(a,M+f),Y(a,C+f)),s.stroke()}}
s.globalAlpha=1}function os(t,e,n){let r=Math.min(Math.ceil(n),e.moments.length-1);for(let o=Math.max(1,r-Ko+1);o<=r;o++){let s=e.moments[o-1],a=e.moments[o],i=o>
n?Math.max(0,1-2*(o-n)):1-(n-o)/Ko,l=bt(e,s,a);for(let c of Kt(s,a))l.includes(c)||Hi(t,L(a,c),i);for(let c of l)Bi(t,L(a,c),i)}t.ctx.globalAlpha=1}function Bi({
ctx:t,grid:e,colors:n},[r,o],s){t.globalAlpha=s,jo(t,K(e,o+.5),Y(e,r+.5),Math.max(8,e.cell*Ii)),t.fillStyle=n.capture,t.fill(),t.strokeStyle=n.ink,t.lineWidth=Math.
max(1,e.cell/36),t.lineJoin="round",t.stroke()}function Hi({ctx:t,grid:e,colors:n},[r,o],s){t.globalAlpha=s,qt(t,K(e,o+.5),Y(e,r+.5),Math.max(7,e.cell*Li)),t.strokeStyle=
n.collision,t.lineWidth=Math.max(2,e.cell*.17),t.lineCap="round",t.stroke()}function ss({ctx:t,grid:e,colors:n},r,o){let s=Math.max(1,e.cell*.07);t.strokeStyle=
t.fillStyle=n.collision,t.lineWidth=Math.max(1,e.cell*.05),t.setLineDash([e.cell*.14,e.cell*.1]);for(let[a,i]of r){if(a<0||i<0||a>=e.rows||i>=e.cols)continue;let l=[
K(e,i)+s,Y(e,a)+s,e.cell-2*s,e.cell-2*s];t.globalAlpha=.2*o,t.fillRect(...l),t.globalAlpha=o,t.strokeRect(...l)}t.setLineDash([]),t.globalAlpha=1}function as({ctx:t,
grid:e,colors:n},r,o,s,a){t.globalAlpha=a,de(t,K(e,r),Y(e,o),Math.max(8,e.cell*s*1.02)),t.strokeStyle=n.collision,t.lineWidth=Math.max(1.5,e.cell*.085*Math.sqrt(
s)),t.stroke(),t.globalAlpha=1}var Gi=.8,ji=.92,Vi=15,Ki=7,Qn=9;function is(t,e,n,r,o,s){r.forEach((a,i)=>{a.alpha>0&&Yi(t,e,n,i,a,o,s)}),t.ctx.globalAlpha=1;for(let a of wt(e,n).values())a.length>
Qn&&qi(t,r[a[Qn-1]],a.length-Qn+1)}function Yi(t,e,n,r,o,s,a){let{ctx:i,grid:l,colors:c}=t,m=Pe(e,r),u=K(l,o.x),d=Y(l,o.y),h=Math.max(4,l.cell*o.size*(m?ji:Gi)),
y=Je(t,e,r),f=!m&&!!n.captured[r-e.nPursuers];if(i.globalAlpha=o.alpha,(m?Ze:de)(i,u,d,h),h>Ki*a&&(i.strokeStyle=c.paper,i.lineWidth=Math.max(2,h*.1),i.stroke()),
i.fillStyle=f?c.paper:y,i.fill(),f&&(de(i,u,d,h*.82),i.strokeStyle=y,i.lineWidth=h*.18,i.stroke()),!s||h<Vi*a)return;let g=String(m?r:r-e.nPursuers),v=h*(m?.4:.5)*
(g.length>1?.8:1);Zt(t,g,u,d+h*(m?.17:.03),v,f?y:c.paper)}function qi(t,e,n){let{cell:r}=t.grid;Zt(t,`+${n}`,K(t.grid,e.x),Y(t.grid,e.y),r*.3,t.colors.ink,r*.1)}var Zi=.46,Ji=.86,Xi=.66,ls=.48,Qi=.78,el=.58;function cs(t,e,n,r){let o=e.moments[n-1],s=e.moments[n];if(!o)return;let{ctx:a,grid:i,colors:l}=t;a.strokeStyle=l.
collision,a.lineWidth=Math.max(1.5,i.cell*.07),a.lineCap="butt",a.globalAlpha=r;for(let c=0;c<s.alive.length;c++)jt(o,s,c)&&tl(t,e,L(o,c),Vt(o,s,c));a.globalAlpha=
1}function tl({ctx:t,grid:e},n,r,o){let s=o[1]-r[1],a=o[0]-r[0],i=u=>K(e,r[1]+.5+s*u),l=u=>Y(e,r[0]+.5+a*u),c=_e(n,o)?Qi:el;t.setLineDash([e.cell*.09,e.cell*.06]),
t.beginPath(),t.moveTo(i(ls),l(ls)),t.lineTo(i(c),l(c)),t.stroke(),t.setLineDash([]);let m=.17*e.cell/Math.hypot(s,a);t.beginPath(),t.moveTo(i(c)-a*m,l(c)+s*m),
t.lineTo(i(c)+a*m,l(c)-s*m),t.stroke()}function us(t,e,n,r,o,s){let a=ae[s];if(!s||!a)return;let{ctx:i,grid:l,colors:c}=t,m=_e(e,[r[0]+a[0],r[1]+a[1]])?Ji:Xi,u=Zi*
o.size,d=[K(l,o.x+a[1]*u),Y(l,o.y+a[0]*u),K(l,o.x+a[1]*m),Y(l,o.y+a[0]*m)],h=Math.max(1.5,l.cell*.085);i.lineCap=i.lineJoin="round";for(let[y,f]of[[c.paper,h*2.1],
[Je(t,e,n),h]])i.strokeStyle=y,i.lineWidth=f,Vo(i,...d,l.cell*.2),i.stroke()}var nl=.04,ms=.3,rl=.36,ol=.13,ps=.62,Jt=.94;function hs(t,e,n){let{ctx:r,grid:o,colors:s}=t,{cell:a}=o,i=f=>K(o,f[1]+.5),l=f=>Y(o,f[0]+.5),c=Math.max(1.5,a*.06),
m=f=>_e(e,f);r.lineCap="round";for(let[f,g]of[[n.escape,s.evader],[n.held,s.pursuer]]){r.fillStyle=g,r.globalAlpha=.28;let v=a*(1-2*nl);for(let w of f.filter(m))
r.fillRect(i(w)-v/2,l(w)-v/2,v,v)}r.globalAlpha=1,r.lineWidth=c,r.fillStyle=r.strokeStyle=s.ink;let{sides:u,openSide:d,wall:h,to:y}=n;if(u){let[f,...g]=u;for(let v of g)
r.beginPath(),r.moveTo(i(f),l(f)),r.lineTo(i(v),l(v)),r.stroke()}if(h){let[f,g]=[Math.sign(h[0]-y[0]),Math.sign(h[1]-y[1])],[v,w]=[i(h)-g*a/2,l(h)-f*a/2],b=.3*a;
r.setLineDash([c,c*2]),r.beginPath(),r.moveTo(i(y),l(y)),r.lineTo(v,w),r.stroke(),r.setLineDash([]),r.beginPath(),r.moveTo(v-f*b,w-g*b),r.lineTo(v+f*b,w+g*b),r.
stroke()}for(let f of n.exits.filter(m)){let[g,v]=[i(f)-i(y),l(f)-l(y)];de(r,i(y)+ps*g,l(y)+ps*v,Math.max(3,a*ol)),r.fill()}d&&(sl(r,i(d),l(d),a*rl),r.stroke()),
r.setLineDash([a*.12,a*.08]),r.strokeRect(i(y)-a*Jt/2,l(y)-a*Jt/2,a*Jt,a*Jt),r.setLineDash([])}function fs({ctx:t,grid:e,colors:n},r,o){let{cell:s}=e,a=u=>K(e,u[1]+
.5),i=u=>Y(e,u[0]+.5),l=Math.max(3,s*.14),c=Math.max(1.5,s*.07),m=u=>{for(let[d,h]of[[n.paper,l],[n.ink,c]])t.strokeStyle=d,t.lineWidth=h,u(),t.stroke()};t.lineCap=
"round";for(let u of o.escape.filter(d=>_e(r,d)))m(()=>de(t,a(u),i(u),s*ms));for(let u of o.held.filter(d=>_e(r,d)))m(()=>qt(t,a(u),i(u),s*ms*1.4));t.setLineDash(
[s*.1,s*.08]);for(let{pursuer:u,cell:d}of o.moved)t.strokeStyle=u?n.pursuer:n.evader,t.lineWidth=c,(u?Ze:de)(t,a(d),i(d),s*.72),t.stroke();t.setLineDash([])}function sl(t,e,n,r){
t.beginPath(),t.moveTo(e,n-r),t.lineTo(e+r,n),t.lineTo(e,n+r),t.lineTo(e-r,n),t.closePath()}var ds=t=>["rect",{x:1,y:1,width:22,height:22,class:`tint-${t}`}],Xt=t=>[
"path",{d:t,class:"sign"}],er=(t,e)=>["circle",{cx:12,cy:12,r:t,class:e}],al={escapes:[["next cell of the evader that no pursuer reaches",ds("evader"),er(5,"sig\
n")],["next cell that a pursuer reaches",ds("pursuer"),Xt("M8 8l8 8m0-8l-8 8")]],opposite:[["two sides of the evader",Xt("M3 20L12 5l9 15")]],open_side:[["neare\
st free side",Xt("M12 3l9 9-9 9-9-9z")]],exits:[["way on",er(4,"filled-sign")]],room:[["nearest obstacle",Xt("M2 12h2m5 0h2m5 0h2M21 4v16")]]},il=["an agent tha\
t has moved before",er(8,"dashed-sign")],ll="Inputs of a move: point at an agent, or choose it; then point at a cell beside it, tap it or press I for another mo\
ve.";function gs(t,e){let n=t.flatMap(r=>al[r]??[]);return n.length?[p("p",{class:"small muted"},ll),p("ul",{class:"shapes small","aria-label":"Inputs of a move\
 on the board"},...[...n,...e?[il]:[]].map(([r,...o])=>p("li",{},S("svg",{viewBox:"0 0 24 24","aria-hidden":"true"},...o.map(s=>S(...s))),r)))]:[]}var vs={numbers:!0,axes:!1,trail:6,viewers:[],plan:null,inputs:null,selected:null,cursor:null,you:null,fog:!1};function bs(t,e,n,r,o){let{ctx:s,grid:a,colors:i}=t,
l=Math.min(Math.ceil(n),e.moments.length-1),c=e.moments[l],m=n===l,u=Yt(e,n),d=m?1:Math.max(0,1-2*(l-n));s.clearRect(0,0,s.canvas.width,s.canvas.height),qo(t);for(let g of r.
viewers)u[g]?.alpha&&ns(t,e,g,...Xn(e,g,n));Zo(t,e),r.axes&&Xo(t,o),rs(t,e,n,r.trail,u);let h=m?r.inputs:null;h&&hs(t,e,h),ss(t,c.contested??[],d),os(t,e,n),cs(
t,e,l,d),u.forEach(({x:g,y:v,size:w},b)=>{let M=Lo(c,b)?.4:0,C=Jn(c,b)?1:M;C&&as(t,g,v,w,C*d)});let y=m?c:e.moments[Math.max(0,l-1)];if(is(t,e,y,u,r.numbers,o),
h&&fs(t,e,h),m&&r.plan)for(let[g,v]of u.entries())v.alpha&&us(t,e,g,L(c,g),v,r.plan[g]??0);r.you!==null&&(r.fog&&es(t,e,...Xn(e,r.you,n)),ts(t,u[r.you],o)),s.lineWidth=
Math.max(2,2.5*o),s.strokeStyle=i.focus;let f=r.selected===null?void 0:u[r.selected];f?.alpha&&ys(t,f.x,f.y,f.size*.96),r.cursor&&(s.setLineDash([a.cell*.12,a.cell*
.08]),ys(t,r.cursor[1]+.5,r.cursor[0]+.5,.8),s.setLineDash([]))}function ys({ctx:t,grid:e},n,r,o){let s=o*e.cell;t.beginPath(),t.roundRect(e.left+n*e.cell-s/2,e.
top+r*e.cell-s/2,s,s,s*.1),t.stroke()}var ws=(t,e)=>(e+.24)/(t+.24);function xs(t,e,n,r,o,s){let a=n?28*s:0,i=(c,m)=>(c-a)/(m+2*.12),l=Math.max(1,Math.floor(Math.min(i(r,e),i(o,t))));return{rows:t,cols:e,
cell:l,left:Math.round((r-e*l+a)/2),top:Math.round((o-t*l+a)/2)}}function Ss(t,e,n){let r=Math.floor((n-t.top)/t.cell),o=Math.floor((e-t.left)/t.cell);return r>=
0&&r<t.rows&&o>=0&&o<t.cols?[r,o]:null}var cl=["paper","line","frame","ink","muted","obstacle"],ul=["pursuer","evader","capture","collision","focus"];function Qt(t){let e=getComputedStyle(t),n=(r,o)=>[
r,e.getPropertyValue(o+r).trim()];return Object.fromEntries([...cl.map(r=>n(r,"--board-")),...ul.map(r=>n(r,"--"))])}var Qe=()=>matchMedia("(prefers-reduced-motion: reduce)").matches,Xe=class{canvas;#e=null;#r=0;#n;#o={rows:1,cols:1,left:0,top:0,cell:1};#c=0;constructor(e,n={}){
this.canvas=e,e.classList.add("board"),e.setAttribute("role","img"),this.#n={...vs,...n},new ResizeObserver(()=>this.#m()).observe(e),new MutationObserver(()=>this.
redraw()).observe(document.documentElement,{attributes:!0}),addEventListener("beforeprint",()=>this.drawNow())}set look(e){this.#n={...this.#n,...e},this.#a(),this.
redraw()}show(e,n){this.#e=e,this.#r=Math.min(Math.max(0,n),e.moments.length-1),this.#a(),this.redraw()}redraw(){this.#c||(this.#c=requestAnimationFrame(()=>this.
drawNow()))}drawNow(){cancelAnimationFrame(this.#c),this.#c=0;let e=this.canvas.getContext("2d");if(!e||!this.#e)return;let{rows:n,cols:r}=this.#e,o=devicePixelRatio||
1;this.#o=xs(n,r,this.#n.axes,this.canvas.width,this.canvas.height,o);let s={ctx:e,grid:this.#o,colors:Qt(this.canvas)};bs(s,this.#e,this.#r,this.#n,o)}cellAt(e,n){
let r=this.canvas.getBoundingClientRect(),o=this.canvas.width/r.width;return Ss(this.#o,(e-r.left)*o,(n-r.top)*o)}agentAt(e,n){let r=this.cellAt(e,n);if(!r||!this.#e)
return null;let o=this.#e.moments[Math.round(this.#r)],s=wt(this.#e,o).get(r[0]*this.#e.cols+r[1])??[],a=Yt(this.#e,Math.round(this.#r)),i=l=>{let[c,m]=this.pointOf(
a[l].x,a[l].y);return Math.hypot(c-e,m-n)};return s.length?s.reduce((l,c)=>i(c)<i(l)?c:l):null}pointOf(e,n){let r=this.canvas.getBoundingClientRect(),o=r.width/
this.canvas.width,{left:s,top:a,cell:i}=this.#o;return[r.left+(s+e*i)*o,r.top+(a+n*i)*o]}#a(){if(!this.#e)return;let{rows:e,cols:n}=this.#e;this.canvas.style.setProperty(
"--board-aspect",String(ws(e,n)))}#m(){let e=devicePixelRatio||1,{width:n,height:r}=this.canvas.getBoundingClientRect();this.canvas.width=Math.max(1,Math.round(
n*e)),this.canvas.height=Math.max(1,Math.round(r*e)),this.drawNow()}};function tr(t,e,n){let{rows:r,cols:o,n_pursuers:s,fov:a,rules:{interaction:i}}=t;return{rows:r,cols:o,nPursuers:s,fov:a,interaction:i,obstacles:e,moments:n}}function nr(t,e){
return{positions:t.read("last_positions"),alive:t.read("alive"),captured:t.read("captured"),everCaptured:t.read("ever_captured"),actions:e,involved:t.read("invo\
lved"),fault:t.read("fault"),contested:t.conflicts().map(n=>n.cell)}}function Ms(t){let e=Array.from({length:t.length+1},(n,r)=>ml(t,r));return tr(t.config,t.map,
e)}function ml(t,e){let n=t.n_agents,r=t.config.n_evaders,o=(a,i,l)=>a.subarray(i*l,(i+1)*l),s={positions:o(t.last_positions,e,2*n),alive:o(t.alive,e,n),captured:o(
t.captured,e,r),everCaptured:o(t.ever_captured,e,r)};return e===0?s:{...s,actions:o(t.actions,e-1,n),involved:o(t.involved,e-1,3*n),fault:o(t.fault,e-1,3*n),get contested(){
return t.conflicts(e).map(a=>a.cell)}}}var pl=Array.from({length:16},(t,e)=>{let n=e%2?6.5:11,r=Math.PI*e/8;return`${12+n*Math.sin(r)} ${12-n*Math.cos(r)}`}).join(" ");function Ts(){let t=[["pursuer",
S("path",{d:"M12 3 22 20H2z",class:"filled-pursuer"})],["evader",S("circle",{cx:12,cy:12,r:9,class:"filled-evader"})],["capture",S("polygon",{points:pl,class:"f\
illed-capture"})],["captured evader",S("circle",{cx:12,cy:12,r:7.5,class:"ring-evader"})],["conflict",S("rect",{x:3,y:3,width:18,height:18,class:"dashed-conflic\
t"})]];return p("ul",{class:"shapes small","aria-label":"Shapes on the board"},...t.map(([e,n])=>p("li",{},S("svg",{viewBox:"0 0 24 24","aria-hidden":"true"},n),
e)))}var dl={first:"M6 5v14M19 5 9 12l10 7z",back:"M17 5 7 12l10 7z",play:"M7 4.5 19 12 7 19.5z",pause:"M8 5v14M16 5v14",forward:"M7 5l10 7-10 7z",last:"M18 5v14M5 5\
l10 7-10 7z"};function As(t){return S("svg",{viewBox:"0 0 24 24","aria-hidden":"true",class:"icon"},S("path",{d:dl[t]}))}function xt(t,e,n,r){return p("button",
{type:"button",class:"player-button","aria-label":e,title:`${e} (${n})`,onclick:r},As(t))}function en(t){let e=xt("play","Play","Space",()=>t.toggle()),n=p("inp\
ut",{type:"range",class:"player-scrub",min:0,step:1,"aria-label":"Step",oninput:()=>{t.pause(),t.jump(Number(n.value))}}),r=p("div",{class:"captures","aria-hidd\
en":"true",title:"Captures"}),o=p("div",{class:"losses","aria-hidden":"true"}),s=p("select",{class:"player-speed","aria-label":"Speed",title:`Steps a second, or\
 the whole in ${zt} s (+ and -)`,onchange:()=>t.speed=Number(s.value)},p("option",{value:Ft},`in ${zt} s`),...ft.map(u=>p("option",{value:u},`${u} / s`))),a=p("\
output",{class:"player-count"}),i=p("div",{class:"player",role:"group","aria-label":"Player"},xt("first","First step","Home",()=>t.move(-t.length)),xt("back","S\
tep back","←",()=>t.move(-1)),e,xt("forward","Step forward","→",()=>t.move(1)),xt("last","Last step","End",()=>t.move(t.length)),p("div",{class:"scrub"},r,o,
n),a,s),l=(u,d={})=>{let h=p("i",d);return h.style.left=`${100*u/Math.max(1,t.length)}%`,h},c=()=>{r.replaceChildren(...t.marks.map(u=>l(u))),o.replaceChildren(
...t.ticks.map(({step:u,kind:d,size:h,text:y})=>{let f=l(u,{class:d,title:`Step ${u}: ${y}`});return f.style.height=`${100*h}%`,f}))},m=()=>{e.replaceChildren(As(
t.playing?"pause":"play")),e.ariaLabel=t.playing?"Pause":"Play",e.title=`${e.ariaLabel} (Space)`,n.max=String(t.length),n.value=String(t.step),n.ariaValueText=`\
step ${t.step} of ${t.length}`,a.textContent=`${t.step} / ${t.length}`,a.style.minWidth=`${2*String(t.length).length+3}ch`,s.value=String(t.speed)};return t.addEventListener(
"step",m),t.addEventListener("state",m),t.addEventListener("state",c),i.addEventListener("keydown",u=>{!(u.target instanceof HTMLSelectElement||u.key===" "&&u.target!==
n)&&Ke(t,u)&&u.preventDefault()}),m(),i}var hl=40,tn=class{element;#e;#r=p("div",{class:"episodes",role:"group","aria-label":"Episodes of this cell"});#n=p("p",{class:"check small numbers","aria-live":"\
polite"});constructor(e){this.#e=e,this.element=p("div",{class:"strip-of-episodes"},this.#r,this.#n)}show(e,n){let{pursuer:r,evader:o,episode:s,seed:a}=this.#e.
selected,i=Ce(e,r,o);this.#r.replaceChildren(...(i?.rates??[]).slice(0,hl).map((d,h)=>this.#o(d,h)));let l=a===null?i?.rates[s]:void 0,c=n.statistics.capture_rate,
m=l!==void 0&&Math.abs(c-l)<1e-6&&n.length===i?.lengths[s],u=i?"Not an episode of the evaluation":"The evaluation played no episodes of this pair.";this.#n.dataset.
equal=String(m),this.#n.textContent=m?"As in the evaluation":l===void 0?u:`Episode ${s+1} differs from the evaluation.`,this.#n.title=`Played here: capture rate\
 ${N(c,3)} in ${n.length} steps.${i?` The cell says ${N(i.rate,3)}.`:""}`}#o(e,n){let{selected:r}=this.#e,o=p("span",{class:"bar"});return o.style.height=`${Math.
round(100*e)}%`,p("button",{type:"button",class:"episode",title:`Episode ${n+1}: capture rate ${N(e)}`,"aria-label":`Episode ${n+1}, capture rate ${N(e)}`,"aria\
-pressed":String(n===r.episode&&r.seed===null),onclick:()=>this.#e.select({episode:n,seed:null})},o,p("span",{class:"count"},n+1))}};var ie=["stay","north","east","south","west","northeast","southeast","southwest","northwest"];function Cs(t,e){let{config:n,view:r,team:o,at:s,move:a}=t,{fov:i,diagonal:l}=n,c=Math.floor(i/2),m=ae.slice(0,l?9:5),u=x=>Array.from(r.subarray(x*i*i,(x+1)*i*i)).
flatMap((A,H)=>A?[[Math.floor(H/i)-c,H%i-c]]:[]),[d,h,y]=[u(0),u(1),u(2)],[f,g]=o==="pursuer"?[h,d]:[d,h],v=(x,[A,H])=>x.some(([P,V])=>P===A&&V===H),w=(x,A)=>{let[
H,P]=[Math.abs(x[0]-A[0]),Math.abs(x[1]-A[1])];return l?Math.max(H,P):H+P},b=(x,A)=>[x[0]+A[0],x[1]+A[1]],M=x=>m.slice(1).map(A=>b(x,A)),C=(x,A)=>{let H=Math.min(
...x.map(P=>w(P,A)));return x.filter(P=>w(P,A)===H)},k=x=>!v(y,x),R=x=>b(s,x),E=[0,0],T=m[a],F=C(g,E),W=(x,A)=>{let H=[x,...M(x)].filter(k),P=V=>A.some(X=>w(X,V)<=
1);return{escape:H.filter(V=>!P(V)),held:H.filter(P)}},j=o==="evader"?[W(T,g)]:F.map(x=>W(x,[T,...f])),fe=o==="evader"?F.flatMap(x=>C(g.filter(A=>A!==x),E).map(
A=>[T,x,A])):F.flatMap(x=>C(f,x).map(A=>[x,T,A])),J=g.flatMap(M).filter(x=>Math.max(...x.map(Math.abs))<=c&&k(x)&&!v(f,x)),Z=ae.slice(1,5).flatMap(([x,A])=>Array.
from({length:c},(P,V)=>[T[0]+V*x,T[1]+V*A]).filter(P=>!k(P)).slice(0,1)),I=x=>e.includes(x),O={ways:I("escapes")?nn(j,x=>x.escape.length):null,sides:I("opposite")?
nn(fe,x=>-fl(...x)):null,openSide:I("open_side")?nn(J,x=>w(x,T)):null,exits:I("exits")?M(T).filter(k):[],wall:I("room")?nn(Z,x=>w(x,T)):null};return{to:R(T),escape:(O.
ways?.escape??[]).map(R),held:(O.ways?.held??[]).map(R),sides:O.sides&&[R(O.sides[0]),R(O.sides[1]),R(O.sides[2])],openSide:O.openSide&&R(O.openSide),exits:O.exits.
map(R),wall:O.wall&&R(O.wall)}}function nn(t,e){let n=t.map(e);return t[n.indexOf(Math.min(...n))]??null}function fl(t,e,n){let[r,o]=[e,n].map(a=>[a[0]-t[0],a[1]-
t[1]]),s=Math.hypot(...r)*Math.hypot(...o);return s?(1-(r[0]*o[0]+r[1]*o[1])/s)/2:.5}var Es=0,ks=1,gl=2,yl=176;function Os(t,e,n,r){let o=devicePixelRatio||1,s=Qt(t);t.width=t.height=yl*o;let a=t.getContext("2d");if(!a)return;let{fov:i}=e,l=t.width/
i;a.fillStyle=s.paper,a.fillRect(0,0,t.width,t.height);for(let m=0;n&&m<i*i;m++){let u=(m%i+.5)*l,d=(Math.floor(m/i)+.5)*l,h=f=>!!n[f*i*i+m];h(gl)&&(a.fillStyle=
s.obstacle,a.fillRect(u-l/2,d-l/2,l,l));let y=h(Es)&&h(ks)?l*.18:0;h(Es)&&Rs(a,de,u+y,d+y,l*.74,s.evader),h(ks)&&Rs(a,Ze,u-y,d-y,l*.86,s.pursuer)}a.strokeStyle=
r<e.n_pursuers?s.pursuer:s.evader,a.lineWidth=2*o;let c=Math.floor(i/2)*l;a.strokeRect(c,c,l,l)}function Rs(t,e,n,r,o,s){e(t,n,r,o),t.fillStyle=s,t.fill()}var vl=["stay","↑","→","↓","←","↗","↘","↙","↖"];function rr(t,e){let n=ht(t,e);if(n){let r=o=>Math.abs(n[o]??0);return t.inputs.filter(r).sort((o,s)=>r(
s)-r(o))}return t.inputs.filter(r=>!e||new RegExp(`\\b${r}\\b`).test(e.expression))}function $s(t,{inputs:e,ratings:n,refused:r},o,s,a){let i=ht(t,a),l=d=>`${d===
o?"taken":""} ${r[d]?"refused":""} ${d===s?"asked":""}`,c=(d,h)=>p("tr",{class:h.every(y=>y===h[0])?"same":""},d,...Array.from(h,(y,f)=>p("td",{class:l(f)},gt(y)))),
m=d=>{let y=`${i?`weight ${gt(i[d])} x `:""}${Fe[d]}`;return p("th",{scope:"row",title:y},d.replaceAll("_"," "))},u=p("table",{class:"why numbers"},p("thead",{},
p("tr",{},p("th",{},i?"term":"input"),...Array.from(n,(d,h)=>p("th",{scope:"col",class:l(h),title:ie[h],"aria-label":ie[h]},vl[h]))),c(p("th",{scope:"row"},i?"s\
um":"rating"),n)),p("tbody",{},...rr(t,a).map(d=>{let h=i?i[d]:1,y=e[t.inputs.indexOf(d)];return c(m(d),y.map(f=>h*f))})));return[...a?[p("p",{class:"expression"},
p("code",{},a.expression))]:[],p("div",{class:"wide-table",tabindex:0,role:"group","aria-label":"How the moves are rated"},u)]}var bl=(t,{pursuer:e,evader:n})=>({pursuers:ne(t,"pursuer",e),evaders:ne(t,"evader",n)}),Ps="What it remembers: a number for each unit, from -1 to 1",rn=class{element;#e;#r;#n=p(
"canvas",{class:"seen",role:"img"});#o=p("h3");#c=p("p",{class:"small muted"});#a=p("div",{class:"answers"});#m=p("div",{title:Ps});#d=null;#g=null;#h=null;#u=null;#p=null;#i=null;#l=null;#t=0;#y=null;#s=null;#f=new Map;constructor(e,n=null){
this.#e=e,this.#r=n,this.element=p("div",{class:"inspector","data-open":"false"},p("p",{class:"hint small muted"},"Click an agent, or press A: what it sees, and\
 why it takes its move."),p("div",{class:"inspected"},this.#n,p("div",{class:"answer"},this.#o,this.#c,this.#m),this.#a))}get agent(){return this.#l}show(e,n,r,o,s=bl(
n,o)){this.#d?.free(),this.#d=e.world(r.config),this.#h!==n&&(this.#g=null,this.#l!==null&&this.choose(null)),this.#h=n,this.#u=r,this.#p=o,this.#i=s,this.#b()}set solution(e){
this.#g=e,this.at(this.#t)}choose(e){this.#l=e,this.#b(),this.element.dataset.open=String(e!==null),this.#e(e),this.at(this.#t)}next(e){let n=this.#u;if(!n)return;
let r=this.#l??(e>0?-1:0);for(let o=0;o<n.n_agents;o++)if(r=(r+e+n.n_agents)%n.n_agents,n.alive[this.#t*n.n_agents+r])return this.choose(r)}ask(e){let n=this.#v();
if(!n.length)return;let r=n.indexOf(this.#y??this.#T(this.#l)??0);this.#y=n[(r+e+n.length)%n.length],this.at(this.#t)}askTo(e){let n=this.#S(e);return n===null?
!1:(this.#y=n,this.#s=null,this.at(this.#t),!0)}point(e,n){let r=e&&this.#S(e),o=this.#l,s=r!==null&&o!==null?{agent:o,move:r}:n!==null&&n!==o?{agent:n,move:null}:
null;s?.agent===this.#s?.agent&&s?.move===this.#s?.move||(this.#s=s,this.at(this.#t))}#b(){this.#y=this.#s=null,this.#f.clear()}#v(){let e=this.#l;if(e===null||
!this.#u||!this.#M(e))return[];let{config:n}=this.#u,r=this.#A(e)?.view,o=Math.floor(n.fov/2);return ae.slice(0,n.diagonal?9:5).flatMap(([s,a],i)=>r&&!r[(2*n.fov+
o+s)*n.fov+o+a]?[i]:[])}#S([e,n]){let r=this.#l,o=r===null?null:this.#A(r)?.at;return o?this.#v().find(s=>o[0]+ae[s][0]===e&&o[1]+ae[s][1]===n)??null:null}#w(e){
return e<this.#u.config.n_pursuers?"pursuer":"evader"}#M(e){let n=this.#i?.[`${this.#w(e)}s`];return n&&typeof n!="string"&&n.kind!=="cells"?n:null}#x(e){let n=this.#w(
e);return Wt(this.#h,n,this.#p[n])}#T(e){let{actions:n,n_agents:r}=this.#u;return n[this.#t*r+e]??null}#A(e){return this.#f.has(e)||this.#f.set(e,this.#R(e)),this.#f.
get(e)}#R(e){let[n,r,o]=[this.#u,this.#d,this.#t];n.seek(r,o,this.#i);let s=r.read("positions"),a=n.actions.subarray(o*n.n_agents,(o+1)*n.n_agents);for(;a.length&&
!r.over&&(e<r.actors[0]||e>=r.actors[1]);)r.playTurn(a);let i=r.read("alive");if(!n.alive[o*n.n_agents+e]||!i[e])return null;let l=r.read("positions"),c=u=>[l[2*
u],l[2*u+1]],m=Array.from(i,(u,d)=>d).filter(u=>i[u]&&(l[2*u]!==s[2*u]||l[2*u+1]!==s[2*u+1]));return{at:c(e),view:r.view(e),moved:m.map(u=>({pursuer:this.#w(u)===
"pursuer",cell:c(u)}))}}#C(){if(!this.#r)return;let e=this.#s?.agent??this.#l,n=e===null||!this.#u?null:this.#M(e),r=e===null||!n?null:this.#E(e),o=e===null||r===
null?null:this.#A(e);if(e===null||!n||r===null||!o)return this.#r(null);let s={config:this.#u.config,team:this.#w(e),move:r,...o},a=rr(n,this.#x(e));this.#r({...Cs(
s,a),moved:o.moved})}#E(e){let n=e===this.#l?this.#y:null;return this.#s?.move??n??this.#T(e)}at(e){e!==this.#t&&this.#b(),this.#t=e,this.#k(),this.#C()}#k(){let e=this.#u,
n=this.#d,r=this.#h,o=this.#p,s=this.#i,a=this.#l;if(!e||!n||!r||!o||!s||a===null)return;let i=this.#w(a);this.#m.replaceChildren(),this.#o.replaceChildren(p("s\
pan",{class:i},ee(a,e.config.n_pursuers)));let l=this.#R(a);if(Os(this.#n,e.config,l?.view??null,a),this.#n.ariaLabel=`Field of view of ${ee(a,e.config.n_pursuers)}\
: evaders, pursuers and obstacles around it`,!l)return this.#O([],"It is gone.");let c=this.#T(a),m=s[`${i}s`],u=typeof m!="string"&&m.kind==="cells"?n.answer(m,
a):null,d=u?.probabilities??null;u?.memory.length&&this.#m.replaceChildren(p("p",{class:"small muted"},"It remembers:"),Ml(u.memory));let h=this.#M(a),y=this.#r?
this.#E(a):null,f=h?$s(h,n.rate(h,a),c,y,this.#x(a)):[],g=this.#g?.game(n)??null,v=[["network",d],["perfect",g?.marginal(a)??null]],w=b=>p("p",{class:"small mut\
ed"},b);this.#O([...g?[w(`Value ${g.value.toFixed(2)} under perfect play.`)]:[],...xl(v,c),...f],c===null?"The episode is over.":wl(m,c))}#O(e,n){this.#a.replaceChildren(
...e),this.#c.textContent=n}};function wl(t,e){return typeof t=="string"?`The script "${t}" plays for it; it goes ${ie[e]}.`:t.kind!=="cells"?"It takes the best\
 move that its mask allows; of equal ones any.":t.sampled?"Its action is drawn from these probabilities.":"It takes the most probable action."}function xl(t,e){
let n=t.filter(([,s])=>s);if(!n.length)return[];let r=p("div",{class:"action muted"},p("span"),...n.map(([s])=>p("span",{class:"head"},s))),o=Array.from(n[0][1],
(s,a)=>p("div",{class:a===e?"action taken":"action"},p("span",{},ie[a]),...n.flatMap(([,i])=>Sl(i[a]))));return n.length>1||n[0][0]!==t[0][0]?[r,...o]:o}function Sl(t){
let e=p("span",{class:"filled"});return e.style.width=`${100*t}%`,[p("span",{class:"track"},e),p("span",{class:"numbers"},t.toFixed(2))]}function Ml(t){let e=Array.
from(t,n=>{let r=p("span",{title:n.toFixed(2)});return r.style.transform=`scaleY(${n})`,r});return p("div",{class:"units",role:"img","aria-label":Ps},...e)}var Tl=200;function _s(t,e,{pursuer:n,evader:r},o){let{text:s,image:a}=e.shows[`${n} ${r}`]??{},i=Ce(t,n,r)?.rates??[],l=`Scores of the ${e.teams[0]} in ${i.length}\
 episodes: ${i.map(m=>N(m)).join(", ")}`,c=Al(t,e,n,r);return[s===void 0?null:p("pre",{tabindex:0,"aria-label":"What the game shows of this pair"},s),a===void 0?
null:p("img",{src:a,alt:"What the game shows of this pair",onload:({target:m})=>m.classList.toggle("pixels",m.naturalWidth<Tl)}),...(s??a)===void 0?[p("p",{class:"\
muted"},e.missing),Cl(t,e,n,r,o)]:[],c?p("p",{class:"small numbers"},c):null,i.length>1?p("p",{class:"small numbers"},l):null].filter(m=>m!==null)}function Al(t,e,n,r){
let{others:o,extras:s={}}=t.payoff,a=o?.[n]?.[r],i=a===void 0?[]:[`score of the ${e.teams[1]} ${N(a)}`];for(let[l,c]of Object.entries(s)){let m=c[n]?.[r];m!==void 0&&
i.push(`${l} ${N(m)}`)}return i.length?`Means of the pair: ${i.join(", ")}`:""}function Cl(t,e,n,r,o){let s=Object.keys(e.shows).map(m=>m.split(" ").map(Number)),
a=([m,u])=>(m-n)**2+(u-r)**2,[i,l]=s.sort((m,u)=>a(m)-a(u))[0]??[];if(i===void 0||l===void 0)return null;let c=`${G(t,"pursuer",i)} against ${G(t,"evader",l)}`;
return p("p",{},p("button",{type:"button",onclick:()=>o.select({pursuer:i,evader:l})},`Nearest: ${c}`))}function Ns(t){let e=JSON.stringify(t,(n,r)=>n==="genome"?Array.from(r):r);return p("script",{type:"application/json",id:"champions"},e.replaceAll("<","\\u003c")).
outerHTML}var Is="champion",Ls=0,or=64,sr=100;var El=(t,e)=>Object.keys(t).every(n=>t[n]===e[n]);function Ws(t,e){return Object.keys(e).find(n=>El(e[n],t))??null}var St="_",kl="n",lp=2n**64n-1n;var ar={fov:11,maxSteps:500,rewards:"paper"},Rl=["rules","others","rewards","size","diagonal","fov","limit","seed","ended","walls","pursuers","evaders","played",
"next"];function Fs(t,e){let n=i=>i.map(l=>$l(l,e)).join(""),r=i=>`${Math.floor(i/t.cols)}.${i%t.cols}`,o=Ol(t.rewards,e),s=[t.seed,t.episode,t.steps].join("."),a={rules:Ds(
t.rules,e),others:t.others?Ds(t.others,e):"",rewards:o===ar.rewards?"":o,size:`${t.rows}x${t.cols}`,diagonal:t.diagonal?"1":"",fov:t.fov===ar.fov?"":String(t.fov),
limit:t.maxSteps===ar.maxSteps?"":String(t.maxSteps),seed:s==="0.0.0"?"":s,ended:t.ended?"1":"",walls:t.walls.map(r).join(St),pursuers:t.pursuers.map(Us).join(St),
evaders:t.evaders.map(Us).join(St),played:t.played.map(n).join(St),next:t.next.every(i=>i===Ls)?"":n(t.next)};return Rl.filter(i=>a[i]).map(i=>`${i}=${a[i]}`).join(
"&")}function Us({cell:t,gone:e,captured:n,everCaptured:r}){let o=n?"c":r?"e":"";return`${t[0]}.${t[1]}${o}${e?"x":""}`}function Ds(t,e){let n=e.fields.map(({name:r})=>String(
t[r]).toLowerCase());return Ws(t,e.variants)??n.join(".")}function Ol(t,e){let n=JSON.stringify(t);return Object.keys(e.rewards).find(o=>JSON.stringify(e.rewards[o])===
n)??Object.values(t).map(o=>String(o)).join(St)}function $l(t,e){if(typeof t=="number")return String(t);if(t===Is)return kl;let n=e.scripts.findIndex(({name:r})=>r===
t);return String.fromCharCode(97+n)}var Pl="/* the engine */";function zs(t,e){return p("button",{type:"button",class:"to-playground",title:"Open this step in the playground (G): the same agents a\
nd actions under any rules",onclick:()=>ir(t(),e)},"What if?")}function ir(t,e){let n=t!==null&&t.match.n_agents<=sr&&Math.max(t.match.config.rows,t.match.config.
cols)<=or,r=n?p("script",{type:"text/plain",id:"scene"},Fs(_l(t.match,t.step),e)).outerHTML:"",o=new TextDecoder().decode(Kn("playground")).replace(Pl,()=>Dt("s\
cript-engine")).replace("</noscript>",i=>i+r+(n?Ns(t.champions):"")),s=p("iframe",{title:"Playground",srcdoc:o}),a=p("dialog",{class:"what-if","aria-label":"Wha\
t if?",onclose:()=>a.remove()},p("button",{type:"button",class:"leave",onclick:()=>a.close()},"Back to the match"),s);document.body.append(a),a.showModal()}function _l(t,e){
let{config:n,n_agents:r}=t,o=Math.max(0,e-1),s=i=>{let l=o*r+i,c=o*n.n_evaders+i-n.n_pursuers,m=u=>i>=n.n_pursuers&&!!u[c];return{cell:[t.last_positions[2*l],t.
last_positions[2*l+1]],gone:!t.alive[l],captured:m(t.captured),everCaptured:m(t.ever_captured)}},a=Array.from({length:r},(i,l)=>s(l));return{rules:n.rules,others:null,
rewards:n.rewards,rows:n.rows,cols:n.cols,diagonal:n.diagonal,fov:n.fov,maxSteps:n.max_steps,seed:t.seed,episode:BigInt(t.episode),steps:o,ended:o===t.length,walls:Array.
from(t.map.keys()).filter(i=>t.map[i]),pursuers:a.slice(0,n.n_pursuers),evaders:a.slice(n.n_pursuers),played:[],next:Array.from(t.actions.subarray(o*r,(o+1)*r))}}var lr=.005,Hs=.05,Nl=4,et=new Map;function on(t,e,n="capture-rate"){let r=JSON.stringify([{...e,rewards:null},n]),o=et.get(r)??(Pt(e)?Promise.resolve(null):Il(
t,e,n));return et.delete(r),et.set(r,o),et.size>Nl&&et.delete([...et.keys()][0]),o}var Gs=({n_evaders:t})=>t===1?"capture-time":"capture-rate",Bs=()=>new Promise(
t=>setTimeout(t));async function Il(t,e,n){await Bs();let r=t.solution(e,n);for(;r.goBack();)await Bs();return r}function sn(t,e,n){let{payoff:r}=t;return n.flatMap(
(o,s)=>{let a=[0,0];for(let l=e.n_turns;l>0&&!e.over;l--)t.game(e)?.lost(o).forEach((c,m)=>a[m]+=c),e.playTurn(o);let i=r==="capture-rate"?lr:Hs;return B.map((l,c)=>({
step:s+1,team:l,lost:a[c],payoff:r})).filter(l=>l.lost>=i)})}var an=t=>t.map(e=>({step:e.step,kind:e.team,size:e.lost/Math.max(1,...t.map(({lost:n})=>n)),text:Mt(
e)})),js=({lost:t,payoff:e})=>e==="capture-rate"?`${t.toFixed(2)} of the capture rate`:`${t.toFixed(1)} steps`,Mt=t=>`The ${t.team}s lose ${js(t)} against a per\
fect opponent`;function Vs(t){let e=t.reduce((n,r)=>r.lost>n.lost?r:n);return`Your team's worst moves, in step ${e.step}, lost ${js(e)} against a perfect oppone\
nt.`}function Ks({config:t,payoff:e},{value:n},r){if(e==="capture-rate")return`value ${n.toFixed(2)}`;let o=1-n,s=Math.min(t.max_steps-r,Pn);return o>s-Hs?`free\
 for ${s} steps`:`captured after ${o.toFixed(1)} steps`}function Ys(t,e){return(t.marginal(e)??[]).map((r,o)=>({share:r,action:o})).filter(({share:r})=>r>=lr).sort(
(r,o)=>o.share-r.share).map(({share:r,action:o})=>r>1-lr?ie[o]:`${ie[o]} ${r.toFixed(2)}`).join(", ")}function ln(t,e,n){if(n===0)return[{kind:"start",text:Ll(t),agents:[]}];let r=e.moments[n-1],o=e.moments[n],s=m=>ee(m,t.config.n_pursuers),a=bt(e,r,o),i=t.conflicts(
n),l=new Set(i.flatMap(m=>m.doomed)),c=a.map(m=>({kind:"capture",text:`${s(m)} is captured`,agents:[m]}));for(let m of Kt(r,o))!a.includes(m)&&!l.has(m)&&c.push(
{kind:"end",text:`${s(m)} disappears`,agents:[m]});return c.push(...i.map(({kind:m,text:u,agents:d})=>({kind:m,text:u,agents:d}))),n===t.length&&c.unshift({kind:"\
end",text:Wl(t),agents:[]}),c}function Ll({config:t}){return`${t.n_pursuers} pursuers and ${t.n_evaders} evaders on ${t.rows} x ${t.cols} cells, at most ${t.max_steps}\
 steps`}function Wl(t){let e=Math.round(t.statistics.capture_rate*t.config.n_evaders);return`The episode ends after ${t.length} steps with ${e} of ${t.config.n_evaders}\
 evaders captured`}var Ul=60,cn=class{element;player=new Ve(0,{speed:Ft,still:Qe()});inspector;match=null;recording=null;inputs=null;actions;#e;#r;#n;#o;#c=p("h2",{class:"match-ti\
tle"});#a=p("p",{class:"tally numbers"});#m=p("ol",{class:"words",tabindex:0,"aria-live":"off","aria-label":"What happened in this step"});#d=p("p",{class:"prob\
lem",role:"alert"});#g=p("div",{class:"signs"});#h=p("div",{class:"shown","aria-live":"polite"});#u=null;#p=null;#i=0;#l=!1;#t=0;#y=[];constructor(e,n,r){this.#r=
e,this.#n=n;let o=p("canvas",{"aria-label":"The match",onclick:({clientX:s,clientY:a})=>this.#R(s,a),onpointermove:({clientX:s,clientY:a,pointerType:i})=>i==="m\
ouse"&&this.#C(s,a),onpointerleave:()=>this.inspector.point(null,null)});this.#e=new Xe(o,{numbers:!1}),this.#o=new tn(n),this.inspector=new rn(s=>this.#E(s),s=>this.#e.
look={inputs:this.inputs=s}),this.actions=p("div",{class:"match-actions"},p("button",{type:"button",class:"to-play",title:"Move the chosen agent, or an evader, \
yourself from this step on (T)",onclick:()=>this.element.dispatchEvent(new Event("takeover"))},"Take over"),r&&zs(()=>this.shown,r)),this.element=p("section",{class:"\
card match-card","aria-label":"Match",id:"match"},p("div",{class:"match"},p("header",{class:"match-head"},this.#c,this.#a),this.#d,this.#h,p("div",{class:"stage"},
o),p("div",{class:"aside"},this.#m,Ts(),this.#g,this.actions,this.inspector.element),en(this.player),this.#o.element)),this.player.addEventListener("frame",()=>this.
recording&&this.#e.show(this.recording,this.player.time)),this.player.addEventListener("step",()=>this.#T()),n.on("match",()=>this.#b()),this.#x(),this.#A(0,0)}get#s(){
return this.#r[this.#n.selected.run]}reveal(){(this.#s.game?this.#h:this.#e.canvas).scrollIntoView({block:"nearest"})}get shown(){return this.match&&this.#p&&{match:this.
match,step:this.player.step,champions:this.#p}}start(e){this.#u=e,this.#v()}playSoon(){this.#l=!0,this.#i||this.#f()}goTo(e){this.#t=e,!this.#i&&this.match&&this.#v()}#f(){
!this.#l||!this.match||(this.#l=!1,this.player.jump(0),Qe()||this.player.play())}#b(){this.#x(),clearTimeout(this.#i),this.#i=setTimeout(()=>this.#v(),Ul)}#v(){
clearTimeout(this.#i),this.#i=0,this.player.pause(),this.#x();let{selected:e}=this.#n,{game:n}=this.#s;if(this.#h.replaceChildren(...n?_s(this.#s,n,e,this.#n):[]),
n){this.match=this.recording=null,this.#l=!1,this.#w(e);return}let r=B.map(a=>je(this.#s,a,e[a])).find(Boolean)??"";if(this.#d.textContent=r,r||!this.#u)return;
this.match=Ut(this.#u,this.#s,e);let[o,s]=this.names(e);this.#p={pursuer:{name:o,policy:ne(this.#s,"pursuer",e.pursuer)},evader:{name:s,policy:ne(this.#s,"evade\
r",e.evader)}},this.recording=Ms(this.match),this.#o.show(this.#s,this.match),this.inspector.show(this.#u,this.#s,this.match,e),this.player.length=this.match.length,
this.player.marks=Wo(this.recording),this.#y=this.player.ticks=[],this.player.jump(this.#t),this.#t=0,this.#T(),this.#M(this.#u,this.match),this.#w(e),this.#f()}#S(){
let{teams:e,world:n}=this.#s,r=B.flatMap(s=>{let{policy:a}=e[s];return a&&a.kind!=="cells"?a.inputs:[]}),o=n!==null&&n.rules.interaction!=="SIMULTANEOUS";return gs(
[...new Set(r)],o)}#w({run:e,pursuer:n,evader:r,episode:o,seed:s}){this.element.dataset.played=`${e} ${n} ${r} ${o} ${s??""}`}async#M(e,n){let r=await on(e,n.config);
if(this.match!==n||!r)return;let o=e.world(n.config);n.seek(o,0),this.#y=sn(r,o,Dl(n)),o.free(),this.player.ticks=an(this.#y),this.inspector.solution=r,this.#T()}names({
run:e,pursuer:n,evader:r}){let o=this.#r[e],{teams:s}=o;return[s.pursuer.script??G(o,"pursuer",n),s.evader.script??G(o,"evader",r)]}#x(){let{episode:e,seed:n}=this.#n.
selected,{game:r,payoff:o}=this.#s;this.element.classList.toggle("of-own-game",!!r),this.element.classList.toggle("of-ratings",B.some(l=>Lt(this.#s,l))),this.#g.
replaceChildren(...this.#S());let[s,a]=this.names(this.#n.selected),i=n===null?e<o.episodes?`episode ${e+1} of ${o.episodes}`:`episode ${e+1}, not part of the c\
ell`:`seed ${n}`;this.#c.replaceChildren(p("span",{class:"pursuer"},ve(s))," against ",p("span",{class:"evader"},a),r?"":p("span",{class:"muted small"},i))}#T(){
let e=this.match;if(!e||!this.recording)return;let n=this.player.step,r=this.recording.moments[n];this.#A(Array.from(r.everCaptured).filter(Boolean).length,n),this.#m.
replaceChildren(...this.#y.filter(o=>o.step===n).map(o=>p("li",{class:`loss-${o.team}`},Mt(o))),...ln(e,this.recording,n).map(o=>p("li",{class:o.kind,"data-agen\
ts":o.agents.join(" ")},o.text))),this.inspector.at(n),this.#k()}#A(e,n){let{world:r}=this.#s;r&&this.#a.replaceChildren(p("strong",{},e),` of ${r.n_evaders} ca\
ptured`,p("span",{class:"muted"},` · step ${n}`))}#R(e,n){let r=this.#e.agentAt(e,n),o=this.#e.cellAt(e,n);r===null&&o&&this.inspector.askTo(o)||this.inspector.
choose(r)}#C(e,n){this.inspector.point(this.#e.cellAt(e,n),this.#e.agentAt(e,n))}#E(e){this.#e.look={selected:e,viewers:e===null?[]:[e]},this.#k()}#k(){let e=this.
inspector.agent;for(let n of this.#m.children){let r=n.dataset.agents?.split(" ")??[];n.classList.toggle("about",e!==null&&r.includes(String(e)))}}},Dl=({actions:t,
length:e,n_agents:n})=>Array.from({length:e},(r,o)=>t.subarray(o*n,(o+1)*n));var Fl={ArrowUp:[1,0],ArrowDown:[-1,0],ArrowRight:[0,1],ArrowLeft:[0,-1]},zl=5;function Ne(t,e,n,r="pursuer"){t.tabIndex=0,t.setAttribute("role","application"),
t.addEventListener("keydown",o=>{let s=Fl[o.key];if(!s)return;let[a,i]=r==="pursuer"?s:[s[1],s[0]],[l,c]=n(),m=o.shiftKey?zl:1,{pursuer:u,evader:d}=e.selected;e.
select({pursuer:qs(u+m*a,l),evader:qs(d+m*i,c)}),o.preventDefault(),o.stopPropagation()})}var qs=(t,e)=>Math.min(e-1,Math.max(0,t));var Bl=24,un=7,Js=t=>t<Bl&&matchMedia("(pointer: coarse)").matches;function Xs(t,e,n,r){let[o,s]=t.payoff.shape,a=Zs(e,o),i=Zs(n,s),l=Math.min(un,o),c=Math.min(
un,s),m=[];for(let f=a+l-1;f>=a;f--){m.push(p("span",{class:"pursuer"},f));for(let g=i;g<i+c;g++)m.push(Hl(t,f,g,r))}let u=Array.from({length:c},(f,g)=>p("span",
{class:"evader"},i+g)),d=p("button",{type:"button","aria-label":"Close: all cells",onclick:()=>r(null)},"✕"),y=p("div",{class:"loupe numbers",role:"group","ar\
ia-label":"Cells around the tap",onclick:f=>f.stopPropagation()},...m,d,...u);return y.style.gridTemplateColumns=`2.4rem repeat(${c}, minmax(0, 1fr))`,y}function Hl(t,e,n,r){
let o=p("button",{type:"button",onclick:()=>r({pursuer:e,evader:n})});return Gt(o,Ce(t,e,n)?.rate,`${G(t,"pursuer",e)} against ${G(t,"evader",n)}`),o}var Zs=(t,e)=>Math.
max(0,Math.min(e-un,t-Math.floor(un/2)));var ce={left:52,bottom:46,top:76,right:84},be=10,Gl=160,Tt=ce.right-be-14,Ie=ce.top-be-14,mn=class{element;#e;#r;#n=p("canvas",{"aria-hidden":"true"});#o=S("svg",
{"aria-hidden":"true"});#c=S("g");#a;#m=p("h2");#d=p("strong",{class:"rate numbers"});#g=p("span",{class:"small muted"});#h=p("p",{class:"of-both-teams small mu\
ted numbers"});#u;#p=null;constructor(e,n){this.#r=e,this.#e=n,this.#a=p("div",{class:"matrix",id:"matrix","aria-label":"Payoff matrix. Arrow keys choose a matc\
h, Enter plays it.",onpointermove:o=>this.#S(o),onpointerleave:()=>n.point({}),onclick:o=>this.#w(o),onkeydown:({key:o})=>o==="Enter"&&this.#x()},this.#n,this.#o);
let r=p("header",{class:"readout","aria-live":"polite"},p("div",{},this.#m,this.#h),p("div",{class:"of-cell"},this.#d,this.#g));this.#u=Ye(..._(this.#i).ends),this.
element=p("section",{class:"card matrix-card","aria-label":"Payoff matrix"},r,this.#a,this.#u),this.#f(),new ResizeObserver(()=>this.#l()).observe(this.#a),this.#a.
addEventListener("mousedown",o=>{o.preventDefault(),document.activeElement instanceof HTMLElement&&document.activeElement.blur()}),Ne(this.#a,n,()=>this.#i.payoff.
shape),n.on("run",()=>{let o=Ye(..._(this.#i).ends);this.#u.replaceWith(o),this.#u=o,this.#l()}),n.on("match hover",()=>this.#s())}get#i(){return this.#r[this.#e.
selected.run]}#l(){let[e,n]=this.#i.payoff.shape,{clientWidth:r,clientHeight:o}=this.#a;if(r<50)return;let a=Math.max(Gl,Math.min(r-ce.left-ce.right,o-ce.top-ce.
bottom))/Math.max(e,n),i=Math.max(ce.left,(r-n*a-ce.right+ce.left)/2),l=ce.top+Math.max(0,(o-ce.top-ce.bottom-e*a)/2),c={width:r,height:o,left:i,top:l,cell:a,rows:e,
columns:n};this.#p=c,Ht(this.#n,this.#i.payoff,{left:i,top:l,width:n*a,height:e*a});for(let[m,u,d]of[["left",i,r],["top",l,o],["width",n*a,r],["height",e*a,o]])
this.#n.style.setProperty(m,`${100*u/d}%`);this.#a.style.setProperty("--shape",`${r} / ${o}`),this.#o.setAttribute("viewBox",`0 0 ${r} ${o}`),this.#o.replaceChildren(
jl(c,_(this.#i).generation),...Vl(c),...this.#y(c),this.#c),this.#s()}#t(e){let n=this.#i.findings?.generalization;if(!n)return[];let{selected:r,hover:o}=this.#e,
s=o.pursuer??r.pursuer,a=o.evader??r.evader,[i,l]=Qs(e,n.pursuers.mean[s]??0,s),[c,m]=ea(e,n.evaders.mean[a]??0,a);return[S("circle",{class:"dot of-pursuers",cx:i,
cy:l,r:5}),S("circle",{class:"dot of-evaders",cx:c,cy:m,r:5})]}#y(e){let n=this.#i.findings?.generalization;if(!n)return[];let{left:r,top:o,cell:s,rows:a,columns:i}=e,
{curves:l}=_(this.#i),c=r+i*s+be,m=o-be,u={class:"side"};return[S("rect",{...u,x:c,y:o,width:Tt,height:a*s}),S("rect",{...u,x:r,y:m-Ie,width:i*s,height:Ie}),...ta(
n.pursuers,(d,h)=>Qs(e,d,h),"of-pursuers"),...ta(n.evaders,(d,h)=>ea(e,d,h),"of-evaders"),S("text",{class:"tick",x:c,y:o+a*s+16,"text-anchor":"start"},"0"),S("t\
ext",{class:"tick",x:c+Tt,y:o+a*s+16,"text-anchor":"end"},"1"),S("text",{class:"tick",x:r-6,y:m-4,"text-anchor":"end"},"0"),S("text",{class:"tick",x:r-6,y:m-Ie+
8,"text-anchor":"end"},"1"),S("text",{class:"label of-pursuers",x:c+Tt,y:o+a*s+34,"text-anchor":"end"},l.pursuer),S("text",{class:"label of-evaders",x:r+i*s+be,
y:m-Ie+10,"text-anchor":"start"},l.evader)]}#s(){let e=this.#p;if(!e)return;let{selected:n,hover:r}=this.#e,{left:o,top:s,cell:a,rows:i,columns:l}=e,c=y=>s+(i-1-
y)*a,m=[],u=(y,f)=>S("rect",{class:f,x:o,y:c(y),width:l*a+be+Tt,height:a}),d=(y,f)=>S("rect",{class:f,x:o+y*a,y:s-be-Ie,width:a,height:be+Ie+i*a});m.push(u(n.pursuer,
"strip pursuer"),d(n.evader,"strip evader")),r.pursuer!==null&&r.pursuer<i&&m.push(u(r.pursuer,"strip hover")),r.evader!==null&&r.evader<l&&m.push(d(r.evader,"s\
trip hover")),m.push(...this.#t(e));let h={x:o+n.evader*a,y:c(n.pursuer),width:a,height:a};m.push(S("rect",{class:"chosen under",...h}),S("rect",{class:"chosen",
...h})),this.#c.replaceChildren(...m),this.#f()}#f(){let{selected:e,hover:n}=this.#e,r=n.pursuer??e.pursuer,o=n.evader??e.evader,s=Ce(this.#i,r,o);this.#m.replaceChildren(
p("span",{class:"pursuer"},ve(G(this.#i,"pursuer",r)))," against ",p("span",{class:"evader"},G(this.#i,"evader",o))),this.#d.textContent=s?N(s.rate,3):"-";let a=s&&
s.rates.length>1?`, mean of ${s.rates.length} episodes`:"";this.#g.textContent=s?_(this.#i).score+a:"no episodes were played",this.#h.textContent=this.#b(r,o)}#b(e,n){
let r=this.#i.findings?.generalization;if(!r)return"";let o=(a,i)=>Eo(a.mean[i]??null,a.low?.[i]??null,a.high?.[i]??null),{means:s}=_(this.#i);return`Against al\
l: ${s.pursuer} ${o(r.pursuers,e)}, ${s.evader} ${o(r.evaders,n)}`}#v(e){let n=this.#p;if(!n)return null;let r=this.#a.getBoundingClientRect(),o=Math.floor((e.clientX-
r.left-n.left)/n.cell),s=n.rows-1-Math.floor((e.clientY-r.top-n.top)/n.cell),a=s>=0&&s<n.rows,i=o>=0&&o<n.columns;return a||i?{g:a?s:-1,h:i?o:-1,inside:a&&i}:null}#S(e){
let n=this.#v(e);this.#e.point(n?{pursuer:n.g<0?null:n.g,evader:n.h<0?null:n.h}:{})}#w(e){let n=this.#v(e);if(n){if(n.inside&&Js(this.#p.cell))return this.#M(n.
g,n.h);this.#e.select({...n.g<0?{}:{pursuer:n.g},...n.h<0?{}:{evader:n.h}}),n.inside&&this.#x()}}#M(e,n){let r=Xs(this.#i,e,n,o=>{r.remove(),o&&(this.#e.select(
o),this.#x())});this.#a.append(r)}#x(){this.#a.dispatchEvent(new CustomEvent("play",{bubbles:!0}))}};function jl({left:t,top:e,cell:n,rows:r,columns:o},s){let a=S(
"g",{class:"axes"}),i=e+r*n,l=c=>yt(0,c-1,Math.min(c,c*n/44),!0);for(let c of l(o))a.append(S("text",{class:"tick",x:t+(c+.5)*n,y:i+16,"text-anchor":"middle"},c));
for(let c of l(r))a.append(S("text",{class:"tick",x:t-7,y:i-(c+.5)*n,"text-anchor":"end","dominant-baseline":"middle"},c));return a.append(S("text",{class:"labe\
l of-evaders",x:t+o*n/2,y:i+36,"text-anchor":"middle"},s.evader),S("text",{class:"label of-pursuers",transform:`translate(${t-36} ${e+r*n/2}) rotate(-90)`,"text\
-anchor":"middle"},s.pursuer)),a}function Vl({left:t,top:e,cell:n,rows:r,columns:o}){let s=S("g",{class:"diagonal"}),a=Math.min(r,o);if(a<3)return[];let i=e+r*n;
for(let m of["H","V"]){let u=`M${t} ${i}`;for(let d=1;d<=a;d++){let h=`H${t+d*n}`,y=`V${i-d*n}`;u+=m==="H"?h+y:y+h}s.append(S("path",{d:u,class:"under"}),S("pat\
h",{d:u}))}let l=t+a/2*n-.7*n-4,c=i-a/2*n-.7*n-4;return[s,S("text",{class:"on-cells",transform:`translate(${l} ${c}) rotate(-45)`,"text-anchor":"middle"},"same \
generation")]}var Qs=({left:t,top:e,cell:n,rows:r,columns:o},s,a)=>[t+o*n+be+s*Tt,e+(r-a-.5)*n],ea=({left:t,top:e,cell:n},r,o)=>[t+(o+.5)*n,e-be-r*Ie];function ta(t,e,n){
let r=s=>s.map((a,i)=>e(a??0,i).map(l=>l.toFixed(1)).join(" ")),o=[];return t.low&&t.high&&o.push(S("path",{class:`band ${n}`,d:`M${[...r(t.high),...r(t.low).reverse()].
join("L")}Z`})),o.push(S("path",{class:`line ${n}`,d:`M${r(t.mean).join("L")}`})),o}function ue(t,e,...n){return p("section",{class:"card panel","aria-label":t},p("header",{},p("h2",{},t),p("p",{class:"small muted"},e)),...n)}var Kl={present:"●",
absent:"○","cannot tell":"?"};function na(t){let{findings:e}=t;if(!e?.table.length)return null;let[,...n]=e.table,r=n.map(([s,a,i,l],c)=>{let m=a==="told"?"":
ql(e.reasons[c]??"");return p("li",{class:`finding ${a.replace(" ","-")}`},p("span",{class:"sign","aria-hidden":"true"},Kl[a]??""),p("div",{},p("p",{},p("strong",
{},s),` ${a}`,p("span",{class:"muted"},` · ${l}`)),m?p("p",{class:"small"},`${m}.`):null,p("p",{class:"small muted numbers"},i)))}),o=ue("What happened","Each \
condition is present, absent, or its 95 % interval cannot tell. The intervals are about this run.",p("p",{class:"headline"},e.sentence),p("ul",{class:"findings"},
...r),...Yl(e.refused??{}),t.limits?p("p",{class:"small"},t.limits):null);return o.classList.add("diagnosis"),{element:o}}function Yl(t){return[...new Set(Object.
values(t))].map(n=>{let r=Object.keys(t).filter(o=>t[o]===n);return p("p",{class:"small muted"},`Not judged, because ${n}: ${r.join(", ")}.`)})}function ql(t){let[
,e=""]=t.split(/, because (.*)/s);return ve(e.replace(/\.$/,""))}function ra({settings:t,command:e}){let n=t.map(({name:s,value:a,help:i})=>p("tr",{},p("th",{scope:"\
row"},p("code",{},`--set ${s}=${a}`)),p("td",{class:"muted"},i))),r=p("table",{class:"small"},p("caption",{class:"heard"},"Settings other than the default"),...n),
o=ue("Settings","All others are the defaults. This command plays the race again:",p("pre",{class:"command"},e),n.length?p("div",{class:"wide-table"},r):null);return o.
classList.add("settings"),{element:o}}function oa(t,e,n){let{findings:r}=t,{teams:o,click:s}=_(t);if(!r?.table.length||!r.checkerboards)return null;let a=r.checkerboards.map(i=>Zl(t,i,(l,c)=>{e.select(
{pursuer:l,evader:c}),n()}));return{element:ue("Checkerboards",`${$e(t).length>1?"Two generations of each team":"Two generations against two others"}: each gene\
ration of the ${o.pursuer} is better against another one of the ${o.evader}. Click a cell to ${s}.`,a.length?p("div",{class:"boards"},...a):p("p",{},`No four ce\
lls differ by more than ${r.margin} in this way.`),a.length&&!t.game?.exact?p("p",{class:"small muted"},"The strongest of all pairs, so noise makes them look st\
ronger than they are. The diagnosis says whether there are more than noise makes."):null)}}function Zl(t,{pursuers:e,evaders:n},r){let o=(s,a)=>{let i=p("button",
{type:"button",class:"cell",onclick:()=>r(s,a)});return Gt(i,t.payoff.capture_rate[s][a],`${G(t,"pursuer",s)} against ${G(t,"evader",a)}`),i};return p("div",{class:"\
miniature numbers"},p("span"),...n.map(s=>p("span",{class:"evader"},s)),...e.flatMap(s=>[p("span",{class:"pursuer"},s),...n.map(a=>o(s,a))]))}function sa(t,e){let n=t.findings?.ciao;if(!n)return null;let r=$e(t).map(o=>{let{fading:s,stripes:a,period:i}=n[`${o}s`],l=`fading ${N(s)}, stripes ${N(a)}${i===
null?"":` every ${i} generations`}`;return Jl(t,o,l,e)});return{element:ue("CIAO: current individuals against ancestral opponents","The team's own score. Stripe\
s: intransitive, since wins and losses alternate with the age of the opponent; whether a team returns to earlier strategies is recurrence, under What happened. \
Darker away from the diagonal: forgetting.",p("div",{class:"triangles"},...r.map(o=>o.element)),t.payoff.others?Ye(..._(t).ends):Ye("0 loses","1 wins")),update:()=>r.
forEach(o=>o.update())}}function Jl(t,e,n,r){let o=e==="pursuer"?0:1,s=_(t),a=t.payoff.shape[o],i=t.payoff.shape[1-o],l=t.payoff.capture_rate,c=t.payoff.others,
m=Array.from({length:a},(b,M)=>Array.from({length:Math.min(M+1,i)},(C,k)=>e==="pursuer"?l[M][k]:c?.[k][M]??1-l[k][M])),u=Yn({shape:[a,i],first:[0,0],capture_rate:m}),
d=S("rect",{class:"chosen",width:1,height:1}),h=S("rect",{class:"chosen under",width:1,height:1}),y=S("svg",{viewBox:`0 0 ${i} ${a}`,preserveAspectRatio:"none",
"aria-hidden":"true"},h,d),f=p("div",{class:"triangle","aria-label":`CIAO of the ${s.teams[e]}: ${n}. Arrow keys choose a match.`,onpointermove:b=>r.point(g(b)??
{}),onpointerleave:()=>r.point({}),onclick:b=>g(b)&&r.select(g(b))},u,y);Ne(f,r,()=>t.payoff.shape,e),f.style.aspectRatio=`${i} / ${a}`;let g=b=>{let M=f.getBoundingClientRect(),
C=Math.floor((b.clientX-M.left)/M.width*i),k=a-1-Math.floor((b.clientY-M.top)/M.height*a);return C>=0&&k<a&&C<=k?{[e]:k,[Oe(e)]:C}:null},v=()=>{let b=r.hover[e]??
r.selected[e],M=r.hover[Oe(e)]??r.selected[Oe(e)];for(let C of[d,h])C.setAttribute("x",String(M)),C.setAttribute("y",String(a-1-b)),C.style.display=M<=b?"":"non\
e"};return{element:p("figure",{},p("figcaption",{class:"small"},p("span",{class:e},s.teams[e])),f,p("p",{class:"small muted"},`horizontal: ${s.generation[Oe(e)]}\
; vertical: ${s.generation[e]}`),p("p",{class:"small numbers"},n)),update:v}}var cr={right:12,top:10,bottom:42},pn={x:56,y:34,letter:8,label:30};function dn(t,e,n,r){let{top:o}=cr,s=Math.max(o+40,e-cr.bottom),a=yt(r.low,r.high,(s-o)/pn.y,
r.whole),i=pn.label+pn.letter*Math.max(2,...a.map(g=>ur(g).length)),l=Math.max(i+40,t-cr.right),c=(g,v,w)=>b=>v+(b-g.low)/(g.high-g.low||1)*(w-v),m=c(n,i,l),u=c(
r,s,o),d=S("g"),h=S("svg",{width:t,height:e,viewBox:`0 0 ${t} ${e}`,class:"plot"}),y=S("g",{class:"axes"});for(let g of a)y.append(S("line",{x1:i,x2:l,y1:u(g),y2:u(
g),class:"grid"}),S("text",{x:i-8,y:u(g),"text-anchor":"end","dominant-baseline":"middle"},ur(g)));for(let g of yt(n.low,n.high,(l-i)/pn.x,n.whole))y.append(S("\
text",{x:m(g),y:s+16,"text-anchor":"middle"},ur(g)));return y.append(S("line",{x1:i,x2:l,y1:s,y2:s,class:"axis"}),S("text",{x:(i+l)/2,y:e-6,"text-anchor":"middl\
e",class:"label"},n.label),S("text",{transform:`translate(12 ${(o+s)/2}) rotate(-90)`,"text-anchor":"middle",class:"label"},r.label)),h.append(y,d),{root:h,marks:d,
left:i,right:l,top:o,bottom:s,x:m,y:u,at:g=>{let v=g-h.getBoundingClientRect().left;return n.low+(v-i)/(l-i)*(n.high-n.low)}}}var ur=t=>String(Number(t.toPrecision(
6))).replace("-","−");function hn(t,e,n,r){let o="",s="M";n.forEach((a,i)=>{a===null?s="M":(o+=`${s}${t.x(e[i]).toFixed(1)} ${t.y(a).toFixed(1)}`,s="L")}),t.root.
insertBefore(S("path",{d:o,class:`line ${r}`}),t.marks)}function mr(t,{low:e,high:n},r){if(!e||!n)return;let o=s=>s.map((a,i)=>`${t.x(i).toFixed(1)} ${t.y(a??0).
toFixed(1)}`);t.root.insertBefore(S("path",{d:`M${[...o(n),...o(e).reverse()].join("L")}Z`,class:`band ${r}`}),t.marks)}function pr(t,e,n,r=null){let o=t.x(e);t.
marks.append(S("line",{x1:o,x2:o,y1:t.top,y2:t.bottom,class:`mark ${n}`})),r!==null&&t.marks.append(S("circle",{cx:o,cy:t.y(r),r:5,class:`dot ${n}`}))}function dr(...t){
return p("p",{class:"legend small"},...t.map(([e,n])=>p("span",{class:`key ${n}`},e)))}function fn(t,e,n=()=>{},r=()=>{}){let o=p("div",{class:"chart chooses",role:"\
img","aria-label":t}),s=null,a=()=>{s?.marks.replaceChildren(),s&&n(s)};o.addEventListener("click",l=>s&&r(s.at(l.clientX),s,l));let i=()=>{let{clientWidth:l,clientHeight:c}=o;
l<50||c<50||(s=e(l,c),o.replaceChildren(s.root),a())};return new ResizeObserver(i).observe(o),{element:o,update:a,redraw:i}}var hr=["of-pursuers","of-evaders","of-both"],Xl=2500,aa="Arrow keys choose generations.";function ia(t,e){let{training:n}=t,{score:r,teams:o}=_(t),{capture_rate:s,
generation:a,learner:i,epochs:l}=n,c=s.map((g,v)=>(v+1)*l),m=Ql(s,n.window),u=c.at(-1)??1,d=c.length>Xl?"dense":"",h=(g,v)=>{let w=a.flatMap((b,M)=>b===g&&(i[M]===
v||i[M]===2)?[M]:[]);return w.length?[c[w[0]],c[w.at(-1)]]:null},y=fn(`${ve(r)} in ${u} epochs of training. ${aa}`,(g,v)=>{let w=dn(g,v,{low:0,high:u,label:"epo\
ch",whole:!0},{low:0,high:1,label:r});for(let[b,M]of[["raw",s],[d,m]])for(let[C,k]of hr.entries()){let R=M.map((E,T)=>i[T]===C||i[T+1]===C?E:null);R.some(E=>E!==
null)&&hn(w,c,R,`${k} ${b}`)}return w},g=>B.forEach((v,w)=>{let b=h(e.hover[v]??e.selected[v],w);b&&pr(g,(b[0]+b[1])/2,hr[w])}),g=>{let v=Math.min(c.length-1,Math.
max(0,Math.round(g/l)-1)),w=a[v];i[v]!==1&&e.select({pursuer:Math.min(w,t.payoff.shape[0]-1)}),i[v]!==0&&e.select({evader:Math.min(w,t.payoff.shape[1]-1)})});Ne(
y.element,e,()=>t.payoff.shape);let f=[...new Set(i)].sort().map(g=>[`${[o.pursuer,o.evader,"both teams"][g]} learn`,hr[g]]);return{element:ue("Training",`${ko(
n.matches)} training matches. Lines: the generations that are selected.`,dr(...f),y.element),update:y.update}}function la(t){let e=t.findings?.joint;if(!e)return null;
let n=e.mean.length-1,r=fn("Mean of both scores by generation.",(s,a)=>{let i=dn(s,a,{low:0,high:n,label:"generation",whole:!0},{low:0,high:1,label:"mean of bot\
h scores"});return mr(i,e,"of-both"),hn(i,e.mean.map((l,c)=>c),e.mean,"of-both"),i}),o=`${N(e.mean[0]??null)} in the beginning, ${N(e.mean[n]??null)} at the end`;
return{element:ue("Both sides together",`The mean of both scores against contemporaries: ${o}. What one wins is not what the other loses here, so both may rise,\
 or fall.`,r.element),update:r.update}}function ca(t,e){let n=t.findings?.ratings;if(!n)return null;let r={pursuer:n.pursuers,evader:n.evaders},o={pursuer:r.pursuer.
mean,evader:r.evader.mean},s=$e(t),a=B.flatMap(h=>[r[h].mean,r[h].low??[],r[h].high??[]]).flat().map(h=>h??0),i=Math.min(...a),l=Math.max(...a),c=.06*(l-i||1),m=Math.
max(...t.payoff.shape)-1,{teams:u}=_(t),d=fn(`Elo ratings by generation. ${aa}`,(h,y)=>{let f=dn(h,y,{low:0,high:m,label:"generation",whole:!0},{low:i-c,high:l+
c,label:"Elo points"});for(let g of s)mr(f,r[g],`of-${g}s`),hn(f,o[g].map((v,w)=>w),o[g],`of-${g}s`);return f},h=>{for(let y of B){let f=e.hover[y]??e.selected[y];
pr(h,f,`of-${y}s`,o[y][f]??null)}},(h,y,f)=>{let g=Math.round(h),v=f.clientY-y.root.getBoundingClientRect().top,w=M=>Math.abs(y.y(o[M][g]??1/0)-v),b=w("pursuer")<=
w("evader")?"pursuer":"evader";g>=0&&g<o[b].length&&e.select({[b]:g})});return Ne(d.element,e,()=>t.payoff.shape),{element:ue("Ratings",`One number for each gen\
eration, which cycles do not fit${r.pursuer.low?", with 95 % intervals over episodes":""}.${s.length>1?` The game itself: ${N(n.offset,0)} points for the ${u.pursuer}\
.`:""}`,dr(...s.map(h=>[u[h],`of-${h}s`])),d.element),update:d.update}}function Ql(t,e){let n=[0];for(let r of t)n.push(n.at(-1)+r);return t.map((r,o)=>{let s=Math.
max(0,o-Math.floor((e-1)/2)),a=Math.min(t.length,o+Math.floor(e/2)+1);return(n[a]-n[s])/(a-s)})}function ua(t,e){if(B.every(r=>!t.teams[r].evolved&&!Lt(t,r)))return null;let n=p("div",{class:"evolved"});return{element:ue("What evolved","Each move is rated \
by named inputs of the cell that it leads to, and the best one is taken.",n),update:()=>n.replaceChildren(...B.map(r=>ec(t,r,e.selected[r])))}}function ec(t,e,n){
let{evolved:r}=t.teams[e],o=je(t,e,n),s=t.teams[e].script??G(t,e,n);return p("section",{"aria-label":_(t).teams[e]},p("h3",{class:e},ve(s)),...o?[p("p",{class:"\
small muted"},o)]:tc(t,e,n,ne(t,e,n)),r?p("p",{class:"small"},`Generation ${r.generation}, the best against strangers: ${r.sentence}`):null)}function tc(t,e,n,r){
if(typeof r=="string"||r.kind==="cells")return[];let o=Wt(t,e,n),s=ht(r,o);return[...o?[p("p",{},p("code",{},o.expression))]:[],...s?[nc(e,s)]:[],...r.kind==="r\
ating"&&r.hidden.length?[p("p",{class:"small muted"},`A network with ${r.hidden.join(" and ")} hidden units rates each move by ${r.inputs.length} inputs.`)]:[]]}
function nc(t,e){let n=Object.entries(e),r=Math.max(...n.map(([,o])=>Math.abs(o)))||1;return p("div",{class:"weights"},...n.flatMap(([o,s])=>{let a=p("span",{class:`\
bar ${t}${s<0?" below":""}`});return a.style.width=`${50*Math.abs(s)/r}%`,[p("span",{title:Fe[o]},o.replaceAll("_"," ")),p("span",{class:"axis"},a),p("span",{class:"\
numbers"},gt(s))]}))}function ma(t,e,n){let r=new Map,o=p("div",{class:"panels"}),s=[],a=()=>s.forEach(l=>l.update?.()),i=()=>{let l=t[e.selected.run];s=r.get(l)??rc(l,e,n),r.set(l,
s),o.replaceChildren(...s.map(c=>c.element)),a()};return e.on("run",i),e.on("match hover",a),i(),o}function rc(t,e,n){return[la(t),na(t),ua(t,e),ia(t,e),oa(t,e,
n),ca(t,e),sa(t,e),ra(t)].filter(o=>o!==null)}var pa={pursuer:null,evader:null},gn=class extends EventTarget{#e;#r=pa;constructor(e){super(),this.#e=e}get selected(){return this.#e}get hover(){return this.#r}select(e){
let n=this.#e,r=["run","pursuer","evader"].some(o=>o in e&&e[o]!==n[o]);this.#e={...n,...r?{episode:0,seed:null}:{},...e},this.#e.run!==n.run&&this.dispatchEvent(
new Event("run")),this.dispatchEvent(new Event("match"))}point(e){let n={...pa,...e};n.pursuer===this.#r.pursuer&&n.evader===this.#r.evader||(this.#r=n,this.dispatchEvent(
new Event("hover")))}on(e,n){for(let r of e.split(" "))this.addEventListener(r,n)}};var yn=class{config;start;recording;actions=[];#e;#r;#n=[[]];constructor(e,n,r){this.config=n,this.start=r,this.#e=e.world(n),this.#e.reset(r),this.#r=[nr(this.#e)],
this.recording=tr(n,this.#e.map(),this.#r)}get length(){return this.actions.length}get over(){return this.#e.over}get statistics(){return{capture_rate:this.#e.read(
"capture_rate")[0]}}conflicts(e){return this.#n[e]}game(e){return e.game(this.#e)}play(e){this.#e.step(e),this.#o(e)}step(e,n,r){let o=this.#e,s=this.config.n_pursuers,
a=new Uint8Array(o.n_agents);for(let i=o.n_turns;i>0&&!o.over;--i){let[l,c]=o.actors;l<s&&(a=o.decide(e.pursuer,[l,Math.min(c,s)],a)),c>s&&(a=o.decide(e.evader,
[Math.max(l,s),c],a)),typeof r=="number"?a[n]=r:l<=n&&n<c&&(a=o.decide(r,[n,n+1],a)),o.playTurn(a)}this.#o(a)}#o(e){this.actions.push(e),this.#r.push(nr(this.#e,
e)),this.#n.push(this.#e.conflicts())}};var we=(t,e)=>B[+(e>=t.n_pursuers)];function fr(t,e){let n=new yn(t,e.config,{seed:e.seed,episode:e.episode});for(let r of e.moves)n.over||n.step(e.policies,e.seat,
r);return n}function Le(t,e){let{moments:n,nPursuers:r}=t.recording,o=n.findIndex(({alive:a,captured:i})=>!a[e]||!!i[e-r]),s=o<0?t.length:o;return{lasted:s,out:o>=
0,captured:Array.from(n[s].everCaptured).filter(Boolean).length}}var vn=(t,e)=>t.over||Le(t,e).out;function da(t,e,n){let r=fr(t,{...e,moves:e.moves.slice(0,e.from)});
for(;!vn(r,e.seat);)r.step(e.policies,e.seat,n);return Le(r,e.seat)}function ha(t){let e=t.length-1;return[...new Set([0,Math.round(e/3),e])].map(n=>t[n])}function fa(t,{
seat:e,from:n,moves:r}){let o={...t,seat:e,...n?{from:n}:{},moves:r.join("")};return`${location.href.split("#")[0]}#${Object.entries(o).map(([s,a])=>`${s}=${a}`).
join("&")}`}function ga(t,e){let n=t.get("seat")??"",r=t.get("from")??"0",o=t.get("moves")??"";return/^\d{1,6}$/.test(n)&&Number(n)<e.n_pursuers+e.n_evaders&&(e.
diagonal?/^[0-8]+$/:/^[0-4]+$/).test(o)&&o.length<=e.max_steps&&/^\d{1,6}$/.test(r)&&Number(r)<=o.length?{seat:Number(n),from:Number(r),moves:[...o].map(Number)}:
null}function gr(t,e,n,r){let{players:o,told:s,...a}=r;e.play({...a,played:n,ending:(i,l)=>[s?p("p",{},s(Le(i,n.seat))):"",oc(t,i,l,ha(o))],again:()=>gr(t,e,{...n,moves:n.
moves.slice(0,n.from)},r)})}function oc(t,e,n,r){let o=we(n.config,n.seat)==="evader",s=o?n.config.max_steps:n.config.n_evaders,a=p("table",{class:"numbers"},p(
"caption",{},o?"Steps in your seat: same start, same others":"Captures of your team: same start, same others")),i=c=>{let m=p("span",{class:o?"bar evader":"bar \
pursuer"}),u=p("td",{},"…");return a.append(p("tr",{},p("th",{scope:"row"},c),p("td",{class:"track","aria-hidden":"true"},m),u)),({lasted:d,captured:h})=>{m.style.
width=`${100*(o?d:h)/s}%`,u.textContent=String(o?d:h)}};i("You")(Le(e,n.seat));for(let{name:c,policy:m}of r){let u=i(c);setTimeout(()=>u(da(t,n,m())))}let l=n.from?
`You took over at step ${n.from}. `:"";return p("div",{},a,p("p",{class:"small muted"},`${l}One match: luck has its part in it.`))}var ya=["·","↑","→","↓","←","↗","↘","↙","↖"];var sc={" ":0,ArrowUp:1,w:1,ArrowRight:2,d:2,ArrowDown:3,s:3,ArrowLeft:4,a:4,e:5,c:6,y:7,z:7,q:8},yr=[8,1,5,4,0,2,7,3,6],ac=[7,8,9,4,5,6,1,2,3],ic=24,lc=Math.tan(
Math.PI/8);function ba(t,e){if(t.ctrlKey||t.metaKey||t.altKey)return;let n=ac.findIndex(o=>t.code===`Numpad${o}`),r=yr[n]??sc[t.key.length===1?t.key.toLowerCase():
t.key];return r!==void 0&&r>4&&!e?void 0:r}function wa(t){let e=yr.map(n=>p("button",{type:"button","aria-label":ie[n],onclick:()=>t(n)},ya[n]));return{element:p(
"div",{class:"play-pad",role:"group","aria-label":"Your move"},...e),show:n=>e.forEach((r,o)=>r.classList.toggle("absent",yr[o]>4&&!n))}}function va(t,e,n){let r=lc*
Math.max(Math.abs(t),Math.abs(e)),o=s=>Math.abs(s)<r?0:s;return Io([0,0],n?[o(t),o(e)]:[t,e],n)}function xa(t,e,n){let r=null,{canvas:o}=t;o.addEventListener("p\
ointerdown",({button:s,clientX:a,clientY:i})=>r=s===0?[a,i]:null),o.addEventListener("pointercancel",()=>r=null),o.addEventListener("pointerup",({clientX:s,clientY:a})=>{
let i=r,l=e();if(r=null,!i||!l)return;let c=s-i[0],m=a-i[1],u=t.cellAt(s,a);Math.hypot(c,m)>=ic?n(va(m,c,l.diagonal)):u&&n(va(u[0]-l.cell[0],u[1]-l.cell[1],l.diagonal))})}
function Sa(t,e){let n=r=>{let o=e[r]-t[r],s=ae.findIndex(a=>a[r]===Math.sign(o)&&a[1-r]===0);return o?`${Math.abs(o)} ${ie[s]}`:""};return[n(0),n(1)].filter(Boolean).
join(", ")||"on your cell"}var Aa="NUMPY\0",Ma=Aa.length+2,Ta=64;function Ca(t){return yo(Object.fromEntries(Object.entries(t).map(([e,n])=>[`${e}.npy`,cc(n)])))}function cc({dtype:t,shape:e,
data:n}){let r=typeof n=="string"?Array.from(n,m=>m.codePointAt(0)):null,o=e.map(m=>`${m}, `).join(""),s=`{'descr': '${r?`<U${r.length}`:t}', 'fortran_order': F\
alse, 'shape': (${o}), }`,a=Math.ceil((Ma+s.length+1)/Ta)*Ta-Ma,i=Aa+String.fromCharCode(a&255,a>>8)+s.padEnd(a-1)+`
`,l=r?Int32Array.from(r):n,c=new Uint8Array(i.length+l.byteLength);return c.set(_t(i,!0)),c.set(new Uint8Array(l.buffer,l.byteOffset,l.byteLength),i.length),c}var uc="matrixworld episode 3";function Ea(t,e,n){let{config:r,actions:o,length:s,recording:a}=e,i=r.n_pursuers+r.n_evaders,l=r.n_evaders,c={positions:["<i4",i,
2],last_positions:["<i4",i,2],alive:["|b1",i],captured:["|b1",l],ever_captured:["|b1",l]},m={rewards:["<f4",i],involved:["|b1",i,3],fault:["|b1",i,3]},u={},d=b=>{
for(let M of Object.keys(b))(u[M]??=[]).push(Array.from(h.read(M),Number))},h=t.world(r);h.reset(e.start);let y=[];d(c);for(let b of o)h.step(b),d({...c,...m}),
y.push(...h.conflictTable());h.free();let f={"<i4":Int32Array,"<f4":Float32Array,"|b1":Uint8Array},g={};for(let[b,[M,...C]]of Object.entries({...c,...m})){let k=s+
+(b in c);g[b]={dtype:M,shape:[k,...C],data:f[M].from((u[b]??[]).flat())}}let v=b=>({dtype:"<i8",shape:[],data:Int32Array.of(b,0)}),w=b=>({dtype:"<U",shape:[],data:b});
return Ca({format:w(uc),n_pursuers:v(r.n_pursuers),config:w(JSON.stringify(r)),seat:v(n),...g,actions:{dtype:"|i1",shape:[s,i],data:Int8Array.from(o.flatMap(b=>[
...b]))},map:{dtype:"|b1",shape:[r.rows,r.cols],data:Uint8Array.from(a.obstacles,Number)},conflict_table:{dtype:"<i4",shape:[y.length/11,11],data:Int32Array.from(
y)}})}var mc=[0,1,2,4,8],bn=class{element;player=new Ve(0,{speed:4,still:Qe()});#e;#r;#n=p("canvas",{tabindex:0,"aria-describedby":"play-keys"});#o=p("h2");#c=p("p",{
class:"play-told",role:"status"});#a=wa(e=>this.act(e));#m=Kr(mc.map(e=>[e,e?`${e} / s`:"step by step"]),()=>this.#C());#d=p("input",{type:"checkbox",onchange:()=>this.#M()});#g=p(
"input",{type:"checkbox",onchange:()=>this.#$()});#h=p("label",{class:"play-choice"},this.#g,"Best move");#u=p("p",{class:"small muted play-keys",id:"play-keys"});#p=p(
"section",{class:"play-ending",tabindex:-1,"aria-labelledby":"play-headline"});#i=en(this.player);#l=null;#t=null;#y=[];#s=null;#f=null;#b=[];#v=0;#S=0;constructor(e){
this.#e=e,this.#r=new Xe(this.#n,{numbers:!1}),this.#n.setAttribute("role","application"),xa(this.#r,()=>{let n=this.#s!==null&&this.#t&&L(this.#t.recording.moments.
at(-1),this.#s);return n?{cell:n,diagonal:this.#t.config.diagonal}:null},n=>this.act(n)),this.player.addEventListener("frame",()=>this.#t&&this.#r.show(this.#t.
recording,this.player.time)),this.player.addEventListener("step",()=>this.#$()),this.element=p("div",{class:"play"},p("header",{class:"play-head"},this.#o,this.#c),
p("div",{class:"play-stage"},this.#n),p("div",{class:"play-side"},this.#p,this.#a.element,p("label",{class:"play-choice",title:"Steps a second"},"Pace ",this.#m),
p("label",{class:"play-choice"},this.#d,p("span",{},"Fog",p("span",{class:"at-length"},": see only what it sees"))),this.#h,this.#u),this.#i)}get played(){return this.#l&&
{...this.#l.played,moves:this.#y}}get live(){return this.#t}play(e){this.#w(fr(this.#e,e.played),e.played.seat,e.title),this.#l=e,this.#y=[...e.played.moves],this.#v=
0,this.element.dataset.state="playing",this.#n.focus({preventScroll:!0}),vn(this.#t,e.played.seat)&&this.#k()}watch(e,n,r){this.#l=null,this.#w(e,n,r),this.#O()}stop(){
this.#C(),this.player.pause(),this.#l=null}act(e){let n=this.#l,r=this.#t;if(!n||!r||this.element.dataset.state!=="playing")return;this.#v=e;let o=Number(this.#m.
value);this.#S||(this.#E(),o&&this.element.dataset.state==="playing"&&(this.#S=setInterval(()=>this.#E(),1e3/o)))}key(e){let{target:n,key:r}=e;if(n instanceof HTMLSelectElement||
n instanceof HTMLInputElement&&(n.type==="text"||r===" ")||n instanceof HTMLButtonElement&&(r===" "||r==="Enter")||!this.#t)return!1;if(this.element.dataset.state!==
"playing")return Ke(this.player,e);let s=ba(e,this.#t.config.diagonal);return s!==void 0&&this.act(s),s!==void 0}#w(e,n,r){this.#C(),this.player.pause(),this.#t=
e,this.#s=n,this.#o.textContent=r,this.#n.ariaLabel=`Board, ${e.config.rows} by ${e.config.cols} cells`,this.#a.show(e.config.diagonal),this.#u.replaceChildren(
p("span",{class:"at-length"},`W A S D or the arrow keys move, Space stays${e.config.diagonal?"; Q E Z C and the numeric keypad move diagonally":""}. `),"On the \
board: swipe, or tap where to go."),this.#x(e),this.#p.replaceChildren(),this.player.length=e.length,this.player.jump(e.length),this.#$()}#M(){this.#r.look={you:this.#s,
fog:this.#d.checked,viewers:this.#s===null?[]:[this.#s],plan:this.#R()}}#x(e){this.#f=null,this.#b=this.player.ticks=[],this.#h.hidden=this.#g.disabled=!!Pt(e.config),
on(this.#e,e.config,Gs(e.config)).then(n=>{this.#t===e&&(this.#f=n,this.#T(),this.#$())})}#T(){let e=this.#t,n=this.#f;if(!n||this.element.dataset.state==="play\
ing")return;let r=this.#e.world(e.config);r.reset(e.start),this.#b=sn(n,r,e.actions),r.free(),this.player.ticks=an(this.#b)}get#A(){return this.#g.checked&&this.#l&&
this.element.dataset.state==="playing"&&this.#f&&this.#t.game(this.#f)||null}#R(){let e=this.#s,n=this.#s!==null&&this.#A?.marginal(this.#s);return e!==null&&n?
Object.assign(Array(e).fill(0),{[e]:n.indexOf(Math.max(...n))}):null}#C(){clearInterval(this.#S),this.#S=0,this.#c.ariaLive=Number(this.#m.value)?"off":"polite"}#E(){
let{policies:e,seat:n}=this.#l.played,r=this.#t;r.step(e,n,this.#v),this.#y.push(this.#v),this.player.length=r.length,this.player.glide=Math.min(.22,.9/(Number(
this.#m.value)||4)),this.player.move(r.length-this.player.step),vn(r,n)&&this.#k()}#k(){this.#C();let e=this.#l,n=this.#t,r=this.played,o=qr()?e.link(r):null,s=`${ee(
r.seat,n.config.n_pursuers)}-${n.length}-steps.npz`,a=()=>Co(s,Ea(this.#e,n,r.seat)),i=To("Link to this match");i.hidden=!0,this.#p.replaceChildren(p("h3",{id:"\
play-headline"},hc(n,r.seat)),...e.ending(n,r),p("div",{class:"play-buttons"},p("button",{type:"button",class:"primary",onclick:()=>e.again()},"Again"),p("butto\
n",{type:"button",onclick:()=>this.#O()},"Watch it"),p("button",{type:"button",onclick:a},"Save"),o&&p("button",{type:"button",onclick:()=>Ao(i,o)},e.linkName??
"Link")),i),this.element.dataset.state="ended",this.player.jump(n.length),this.#T();let l=this.#b.filter(({team:c})=>c===we(n.config,r.seat));l.length&&this.#p.
children[0].after(p("p",{class:"small muted"},Vs(l))),this.#p.focus({preventScroll:!0}),this.#p.scrollIntoView({block:"nearest"})}#O(){this.element.dataset.state=
"watched",this.player.length=this.#t.length,this.player.jump(0),Qe()||this.player.play()}#$(){let e=this.#t,n=this.#s,{step:r}=this.player;if(!e||r>e.length)return;
let o=ln(e,e.recording,r).filter(({agents:l})=>n===null||l.includes(n)),s=this.#l&&r===0,a=s?[pc(e.config,n),this.#l.about??""]:[`Step ${r} of ${e.config.max_steps}`,
...o.map(({text:l})=>l)];!s&&n!==null&&a.push(dc(e,r,n)),a.push(...this.#b.filter(l=>l.step===r).map(Mt));let i=r===e.length&&n!==null?this.#A:null;i&&a.push(`P\
erfect play: ${Ys(i,n)||"decided in its turn"}; ${Ks(this.#f,i,r)}`),this.#M(),this.#c.textContent=a.filter(Boolean).map(l=>`${l}.`).join(" ")}};function pc(t,e){
let n=t.rules.capture==="SURROUND";return we(t,e)==="evader"?`Run away: you win if ${n?"the pursuers do not surround you":"no pursuer reaches your cell"} in ${t.
max_steps} steps`:`Capture evaders: ${n?"surround them with your team":"move onto their cells"}`}function dc({config:t,recording:e},n,r){let o=e.moments[n],s=we(
t,r),a=Oe(s);if(!o.alive[r])return"";let i=L(o,r),l=u=>{let[d,h]=L(o,u);return Math.max(Math.abs(d-i[0]),Math.abs(h-i[1]))},c=Array.from({length:o.alive.length},
(u,d)=>d).filter(u=>we(t,u)===a&&o.alive[u]&&!o.captured[u-t.n_pursuers]&&2*l(u)<t.fov);if(!c.length)return`No ${a} in view`;let m=c.reduce((u,d)=>l(d)<l(u)?d:u);
return`Nearest ${a}: ${Sa(i,L(o,m))}`}function hc(t,e){let{lasted:n,out:r,captured:o}=Le(t,e),{config:s}=t;return we(s,e)==="pursuer"?`Your team captured ${o} o\
f ${fc(s)} in ${n} steps.`:r?`You lasted ${n} of ${s.max_steps} steps.`:`You escaped: ${n} steps.`}var fc=({n_evaders:t})=>`${t} evader${t===1?"":"s"}`;var wn=class{dialog=p("dialog",{class:"take-over","aria-label":"Play an agent",onclose:()=>this.view?.stop(),onkeydown:e=>this.view?.key(e)&&e.preventDefault()});view=null;#e;#r;#n;#o=null;constructor(e,n,r){
this.#e=e,this.#r=n,this.#n=r,r.element.addEventListener("takeover",()=>this.open())}start(e,n=""){this.#o=e;let r=ut(n,this.#e,this.#r.selected),{world:o}=this.#e[r.
run],s=o&&ga(new URLSearchParams(n.replace(/^#/,"")),o);s&&this.play(r,s)}open(){let e=this.#n.shown;if(!e)return;let{match:n,step:r}=e;this.#n.player.pause();let o=this.#n.
inspector.agent,s=r<n.length?r:0,a=(u,d)=>!!n.alive[d*n.n_agents+u],i=Array.from({length:n.n_agents},(u,d)=>(d+n.config.n_pursuers)%n.n_agents),l=o??i.find(u=>a(
u,s)),c=a(l,s)?s:0,m=Array.from({length:c},(u,d)=>n.actions[d*n.n_agents+l]);this.play(this.#r.selected,{seat:l,from:c,moves:m})}play(e,n){let r=this.#o,o=this.#e[e.
run],{world:s}=o;if(!r||!s||B.some(v=>je(o,v,e[v])))return;let{run:a,pursuer:i,evader:l,episode:c,seed:m}=e,u=we(s,n.seat),d=o.teams[u].kept.map(v=>({name:o.teams[u].
script??`generation ${v}`,text:"",policy:()=>ne(o,u,v)}));this.view||(this.view=new bn(r),this.dialog.append(p("button",{type:"button",class:"leave",onclick:()=>this.
dialog.close()},"Close"),this.view.element)),this.dialog.open||this.dialog.showModal();let h=`You are ${ee(n.seat,s.n_pursuers)}: ${this.#n.names(e).join(" agai\
nst ")}`,y={pursuer:ne(o,"pursuer",i),evader:ne(o,"evader",l)},f={config:s,seed:BigInt(m??o.seeds[i][l]),episode:c,policies:y,...n},g={run:a,pursuers:i,evaders:l,
episode:c,...m===null?{}:{seed:m}};gr(r,this.view,f,{title:h,players:d,link:v=>fa(g,v)})}};var he=wo(),{runs:re}=he,[gc,yc]=re[0].payoff.shape,vc=ut(location.hash,re,{run:0,pursuer:gc-1,evader:yc-1,episode:0,seed:null}),{step:ka,...bc}=vc,le=new gn(bc),
Q=new cn(re,le,he.playground),Ra=new mn(re,le),At=new wn(re,le,Q),vr=_o(re),wc=location.hash,Ee=null,Oa=p("span",{class:"told","aria-live":"polite"}),$a=p("span",
{class:"small muted"}),Pa=()=>{let t=re[le.selected.run],e=t.findings?.sentence??"";Oa.textContent=t.together||e,$a.textContent=t.together?`Seed ${t.seed}: ${e}\
 ${_(t).lead}`:_(t).lead};le.on("run",Pa);Pa();var _a=()=>{Q.playSoon(),Q.reveal()};document.getElementById("page").replaceWith(Xr(he.heading,p("span",{},Oa,$a),
p("button",{type:"button",class:"keys-button",title:"Keys (?)","aria-label":"Keys (?)",onclick:()=>vr.showModal()},"?")),...he.note?[p("aside",{class:"note smal\
l muted"},he.note)]:[],Po(re,le),p("main",{class:"stages"},Ra.element,Q.element),ma(re,le,_a),p("footer",{class:"muted small"},`${he.title} · matrixworld ${he.
version}`),At.dialog,vr);Object.assign(window,{matrixworldExplorer:{get match(){return Q.match},get step(){return Q.player.step},get pace(){return Q.player.pace},
get inputs(){return Q.inputs},get playing(){return At.view},play:t=>Ee&&Ut(Ee,re[le.selected.run],{...le.selected,episode:t}),get shape(){return re[le.selected.
run].payoff.shape}}});Ra.element.addEventListener("play",_a);Q.goTo(ka);ka||Q.playSoon();eo(re,le,Q);No(re,le,Q,vr,()=>At.open(),()=>he.playground&&ir(Q.shown,he.
playground));window.addEventListener("hashchange",({newURL:t})=>Ee&&At.start(Ee,new URL(t).hash));he.growing&&to(re,le,()=>Q.player.playing||document.querySelector(
"dialog[open]")!==null);async function xc(){Ee=he.playground&&await jr(),Q.start(Ee),Ee&&At.start(Ee,wc)}requestAnimationFrame(()=>setTimeout(()=>Yr(xc())));})();
