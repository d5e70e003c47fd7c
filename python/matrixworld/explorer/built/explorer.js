/* built from web/ by "npm run build"; sources 375ad6f9c682ca80ffe5d51f8c090c2748043aaa7cd41730dfe01403747bff92 */
"use strict";(()=>{var un={SIMULTANEOUS:0,SWARM_TURNS:1,AGENT_TURNS:2},Xe={DISAPPEAR:0,REACH:1,BOUNCE:2},mn={OCCUPATION:0,SURROUND:1},dn={FAULT:0,INVOLVED:1};var mr=["obstacle","teammate","adversary"],dr=["vertex","edge","chain"],pn=["turn","kind","form","first","second","row","col","at_fault","held","doomed"],pr=["p\
ursuer_{number}","evader_{number}"],hn={obstacle:"{first} ran into the obstacle or border at {cell}",vertex:"{first} and {second} both headed for {cell}",edge:"\
{first} and {second} meant to swap, {first} to {cell}",chain:"{first} headed for {cell}, where {second} had to stay"},Qe={"both held":"both bounce","both doomed":"\
both disappear",held:"{agent} bounces",doomed:"{agent} disappears",none:"nobody is stopped"},fn="{event}: {outcome}",hr={random:"any action, all equally likely",
still:"always stays",chaser:"moves to where the nearest adversary in view is nearest",fleer:"moves to where the nearest adversary in view is farthest","clumsy-c\
haser":"a chaser that takes any action in half of the steps",hunter:"a chaser of the nearest adversary in view to which no teammate in view is nearer",surrounder:"\
a chaser of the nearest free cell beside an adversary without a teammate","clumsy-fleer":"a fleer that takes any action in half of the steps",dodger:"moves to w\
here all adversaries in view together are farthest","team-surrounder":"shares the free cells beside adversaries with its teammates, and searches","careful-rando\
m":"as random, but takes only moves that right of way allows","careful-chaser":"as chaser, but takes only moves that right of way allows","careful-fleer":"as fl\
eer, but takes only moves that right of way allows","careful-clumsy-chaser":"as clumsy-chaser, but takes only moves that right of way allows","careful-hunter":"\
as hunter, but takes only moves that right of way allows","careful-surrounder":"as surrounder, but takes only moves that right of way allows","careful-clumsy-fl\
eer":"as clumsy-fleer, but takes only moves that right of way allows","careful-dodger":"as dodger, but takes only moves that right of way allows","careful-team-\
surrounder":"as team-surrounder, but takes only moves that right of way allows"},Le={adversary:"distance to the nearest adversary (0 to 2, in half views)",pressure:"\
sum over adversaries of 1 / (1 + moves)^2 (0 or more)",unclaimed:"distance to the nearest adversary to which no teammate is nearer than the agent is now; withou\
t one, to the nearest adversary (0 to 2, in half views)",open_side:"distance to the nearest cell beside an adversary that holds no obstacle and no teammate (0 t\
o 2, in half views)",teammate:"distance to the nearest teammate (0 to 2, in half views)",exits:"share of the cells around that are no obstacle (0 to 1)",room:"d\
istance to the nearest obstacle to the north, east, south or west (0 to 1, in half views)",must_yield:"1 if right of way forbids the move (0 to 1)",ahead:"1 if \
it is the direction that the agent draws for each 12 steps (0 to 1)",search:"1 if it leads on along the way on which an agent of team-surrounder searches the gr\
id (0 to 1)"},yn={free:".GS",blocked:"#@OTW"};var Ie=1+pn.length;function et(t,e){return t.replace(/\{(\w+)\}/g,(r,n)=>String(e[n]))}function Y(t,e){return t<e?et(pr[0],{number:t}):et(pr[1],{number:t-e})}function va(t,e){
let[r,n,o,s,a,i,l,...c]=Array.from(t),m=a<0?[s]:[s,a],[d,p,h]=c.map(b=>m.filter((w,v)=>b>>v&1)),f=m.map(b=>Y(b,e)),y=et(hn[a<0?"obstacle":dr[o]],{first:f[0],second:f[f.
length-1],cell:`(${i}, ${l})`}),g=et(fn,{event:y,outcome:ba(m.length,p,h,e)});return{kind:mr[n],form:dr[o],agents:m,cell:[i,l],at_fault:d,held:p,doomed:h,turn:r,
text:g}}function ba(t,e,r,n){if(t===2&&e.length===2)return Qe["both held"];if(t===2&&r.length===2)return Qe["both doomed"];let o=s=>a=>et(Qe[s],{agent:Y(a,n)});
return[...e.map(o("held")),...r.map(o("doomed"))].join(", ")||Qe.none}function Mt(t,e){let r=[];for(let n=0;n<t.length;n+=Ie)r.push(va(t.subarray(n+1,n+Ie),e));
return r}var we=class extends Error{name="EngineError"};function N(t,e,r){let n=typeof r=="string"?`'${r}'`:typeof r=="object"?JSON.stringify(r):String(r);return new we(
`${t}: expected ${e}, got ${n}`)}var We=class{bytes;constructor(e){this.bytes=e}},bn=0,yr=[Uint8Array,Uint8Array,Int32Array,BigInt64Array,BigUint64Array,Float32Array,Float64Array],gn=4,vn=4,wa=new TextEncoder,
xa=new TextDecoder;function Sa(t){for(let e=yr.length-1;e>bn;--e)if(t instanceof yr[e])return e;throw new TypeError("array: expected a typed array of the engine\
's numbers, got another")}function fr(t){return new Uint8Array(t.buffer,t.byteOffset,t.byteLength)}function Ma(t){return wa.encode(`${t}\0`)}var gr=class{engine;addresses=[];constructor(e){
this.engine=e}copy(e){let r=this.engine._malloc(Math.max(e.length,1));if(r===0)throw new we("memory: expected room for the arguments, got none");return this.addresses.
push(r),this.engine.HEAPU8.set(e,r),r}text(e){return this.copy(Ma(e))}arrays(e){let r=Object.entries(e),n=r.flatMap(([s,a])=>{let i=a instanceof We,l=i?a.bytes:
a;return[this.text(s),i?bn:Sa(l),l.length,this.copy(fr(l))]}),o=this.copy(fr(Int32Array.from(n)));return this.copy(fr(Int32Array.of(r.length,o)))}free(){for(let e of this.
addresses)this.engine._free(e)}};function wn(t,e){let r=t.HEAPU8;return xa.decode(r.subarray(e,r.indexOf(0,e)))}function Ue(t){let e=new Int32Array(t.HEAPU8.buffer),
r=t._last_outputs()/gn,n=e[r+1]/gn,o={};for(let s=n;s<n+e[r]*vn;s+=vn){let a=yr[e[s+1]],i=e[s+2]*a.BYTES_PER_ELEMENT,l=e[s+3];o[wn(t,e[s])]=new a(t.HEAPU8.slice(
l,l+i).buffer)}return o}function xe(t,e){let r=new gr(t);try{let n=e(r);if(n===0)throw new we(wn(t,t._last_error()));return n}finally{r.free()}}var Aa=2**31-1,xn=["none","gru"],Ta=2n**64n-1n,Ea=34028234663852886e22;function ie(t,e){if(typeof e!="number"||!Number.isInteger(e)||Math.abs(e)>Aa)throw N(t,"a\
n integer",e);return Int32Array.of(e)}function At(t,e){if(typeof e!="boolean")throw N(t,"true or false",e);return new We(Uint8Array.of(Number(e)))}function Te(t,e,r){
let n=typeof e=="string"&&Object.hasOwn(r,e)?r[e]:void 0;if(n===void 0)throw N(t,`one of ${Object.keys(r).join(", ")}`,e);return Int32Array.of(n)}function vr(t,e){
if(typeof e!="number"||!(Math.abs(e)<=Ea))throw N(t,"a finite number",e);return e}function tt(t,e){let n=typeof e=="bigint"||typeof e=="number"&&Number.isSafeInteger(
e)?BigInt(e):-1n;if(n<0n||n>Ta)throw N(t,"an integer from 0 to 2^64 - 1",e);return BigUint64Array.of(n)}function Ca(t){return{"rules.interaction":Te("interactio\
n",t.interaction,un),"rules.obstacle":Te("obstacle",t.obstacle,Xe),"rules.teammate":Te("teammate",t.teammate,Xe),"rules.evader":Te("evader",t.evader,Xe),"rules.\
pursuer":Te("pursuer",t.pursuer,Xe),"rules.capture":Te("capture",t.capture,mn),"rules.captured_disappear":At("captured_disappear",t.captured_disappear)}}function Sn(t,e){
let r=typeof e=="number"?[e,e,e]:e;if(!Array.isArray(r)||r.length!==3)throw N(t,"1 or 3 numbers",e);return Float32Array.from(r,n=>vr(t,n))}function ka(t){let e=(r,n)=>Float32Array.
of(vr(r,t[r]),vr(n,t[n]));return{"rewards.capture":e("pursuer_capture","evader_capture"),"rewards.neighbor":e("pursuer_neighbor","evader_neighbor"),"rewards.ste\
p":e("pursuer_step","evader_step"),"rewards.pursuer_collide":Sn("pursuer_collide",t.pursuer_collide),"rewards.evader_collide":Sn("evader_collide",t.evader_collide),
"rewards.blame":Te("blame",t.blame,dn),"rewards.capture_repeats":At("capture_repeats",t.capture_repeats)}}function Tn(t){if(t===void 0||typeof t=="number")return new Uint8Array(
0);if(t instanceof Uint8Array)return t;let{free:e,blocked:r}=yn;for(let[n,o]of t.entries()){if(o.length!==t[0]?.length)throw N(`map, row ${n}`,`${t[0]?.length} \
cells as in row 0`,o.length);let s=[...o].find(a=>!e.includes(a)&&!r.includes(a));if(s)throw N(`map, row ${n}`,`'${e}' (free) or '${r}' (obstacle)`,s)}return Uint8Array.
from([...t.join("")],n=>Number(r.includes(n)))}function En(t,e){if(!Array.isArray(t))return;let r=[t.length,t[0]?.length??0];if(!(r[0]===e.rows&&r[1]===e.cols))
throw N("obstacle map",`shape (${e.rows}, ${e.cols}), the rows and cols`,r)}function Fe(t){En(t.obstacles,t);let e=typeof t.obstacles=="number"?t.obstacles:0;return{
...Ca(t.rules),...ka(t.rewards),rows:ie("rows",t.rows),cols:ie("cols",t.cols),n_pursuers:ie("n_pursuers",t.n_pursuers),n_evaders:ie("n_evaders",t.n_evaders),fov:ie(
"fov",t.fov),diagonal:At("diagonal",t.diagonal),max_steps:ie("max_steps",t.max_steps),density:Float64Array.of(e),map:Tn(t.obstacles)}}function Mn(t,e){return Int32Array.
from((e??[]).flat(),r=>ie(t,r)[0])}function Cn(t,e){return En(t.obstacles,e),{seed:tt("seed",t.seed??0n),episode:tt("episode",t.episode??0),pursuers:Mn("pursuer\
s",t.pursuers),evaders:Mn("evaders",t.evaders),map:Tn(t.obstacles)}}function Tt(t){return{actions:Int32Array.from(t,e=>ie("actions",e)[0])}}var An=Object.keys(Le);
function br(t){let e=An.indexOf(t);if(e<0)throw N("inputs",`names of ${An.join(", ")}`,t);return e}function Ee(t){if(typeof t=="string"){if(!Object.hasOwn(hr,t))
throw N("policy",`one of ${Object.keys(hr).join(", ")}`,t);return{script:new TextEncoder().encode(t)}}if(t.kind!=="cells")return{inputs:Int32Array.from(t.inputs,
e=>br(e)),hidden:Int32Array.from(t.kind==="rating"?t.hidden:[],e=>ie("hidden",e)[0]),length:ie("length",t.kind==="program"?t.length:0),mask:new TextEncoder().encode(
t.mask),genome:t.genome};if(t.activation!=="relu"&&t.activation!=="tanh")throw N("activation","'relu' or 'tanh'",t.activation);if(!xn.includes(t.memory))throw N(
"memory",`one of ${xn.join(", ")}`,t.memory);return{hidden:Int32Array.from(t.hidden,e=>ie("hidden",e)[0]),activation:new TextEncoder().encode(t.activation),sampled:At(
"sampled",t.sampled),memory:new TextEncoder().encode(t.memory),genome:t.genome}}var Ra=["first_turn","terminated","truncated"];function kn(t){let e={...t};for(let r of Ra)
e[r]=new We(t[r]);return e}var Rn="statistics.",Et=class{config;seed;episode;n_agents;statistics;first_conflict;constructor(e,r,n,o){this.config=e,this.seed=r,this.episode=n,this.n_agents=
e.n_pursuers+e.n_evaders,this.statistics=Oa($n(o)),Object.assign(this,o),this.first_conflict=$a(this.conflict_table,this.length)}get length(){return this.actions.
length/this.n_agents}conflicts(e){this.check(e);let[r,n]=[this.first_conflict[e],this.first_conflict[e+1]],o=this.conflict_table.subarray(r*Ie,n*Ie);return Mt(o,
this.config.n_pursuers)}seek(e,r,n){this.check(r),(!(e.seed===this.seed&&e.episode===BigInt(this.episode))||e.turn!==0||e.steps>r)&&e.reset({seed:this.seed,episode:this.
episode});for(let s=e.steps;s<r;++s){let a=this.actions.subarray(s*this.n_agents,(s+1)*this.n_agents);n?e.replay(a,{pursuer:n.pursuers,evader:n.evaders}):e.step(
a)}}check(e){if(!(Number.isInteger(e)&&e>=0&&e<=this.length))throw N("step",`0 to ${this.length}`,e)}};function $a(t,e){let r=new Int32Array(e+2);for(let n=0;n<
t.length;n+=Ie)++r[t[n]+1];for(let n=1;n<r.length;++n)r[n]+=r[n-1];return r}function Oa(t){let e=["capture_rate","ever_capture_rate","captured_fraction","length"];
return Object.fromEntries(Object.entries(t).map(([r,n])=>[r,e.includes(r)?Number(n[0]):n]))}var $n=t=>Object.fromEntries(Object.entries(t).flatMap(([e,r])=>e.startsWith(
Rn)?[[e.slice(Rn.length),r]]:[]));function On(t,e,r,n){let o=[Fe(r.config),Ee(r.pursuers),Ee(r.evaders),n];return xe(t,s=>{let[a,i,l,c]=o.map(m=>s.arrays(m));return t[e](
a,i,l,c)}),Ue(t)}function Pn(t,e,r,n){let o={seed:tt("seed",r),episode:tt("episode",n)};return new Et(e.config,r,n,On(t,"_play_match",e,o))}function _n(t,e,r,n){
if(!Number.isInteger(n)||n<1)throw N("n_episodes","at least 1",n);let o=On(t,"_play_rollout",e,{...r,n_episodes:Int32Array.of(n)});return $n(o)}var Pa=7e6,_a=new FinalizationRegistry(([t,e])=>t._states_free(e));function Na({rules:t,rows:e,cols:r,obstacles:n,diagonal:o,n_pursuers:s,n_evaders:a}){let i=typeof n==
"number"||t.obstacle==="REACH"?0:n.join("").split("#").length-1,l=e*r-i,c=[t.obstacle,t.teammate,t.pursuer].includes("DISAPPEAR"),m=t.capture==="SURROUND"||t.evader===
"REACH",d=t.interaction==="AGENT_TURNS",p=(y,g)=>Array.from({length:g},(b,w)=>d?y:(y+w)/(w+1)).reduce((b,w)=>b*w,1),h=p(l+Number(c),s)*p(l*(1+Number(m))+2,a);return{
SIMULTANEOUS:[s+a],SWARM_TURNS:[s,a],AGENT_TURNS:Array(s+a).fill(1)}[t.interaction].reduce((y,g)=>y+h*(o?9:5)**g,0)}function Ct(t){return typeof t.obstacles=="n\
umber"&&t.obstacles>0?"obstacles are drawn anew in each episode":Na(t)>Pa?"the world is too large to be solved on the page":""}var wr=class{value;teams;matrix;n_actions;constructor(e,r){
let{matrix:n,rows:o,cols:s,value:a,agents:i}=r,[l,c]=e.actors,m=Array.from(i).filter(p=>l<=p&&p<c),d=p=>p<e.config.n_pursuers;[this.value,this.matrix,this.n_actions]=
[a[0],n,e.n_actions],this.teams=[{agents:m.filter(d),play:o},{agents:m.filter(p=>!d(p)),play:s}]}marginal(e){let r=this.teams.find(({agents:s})=>s.includes(e));
if(!r)return null;let n=this.n_actions**(r.agents.length-1-r.agents.indexOf(e)),o=Array(this.n_actions).fill(0);return r.play.forEach((s,a)=>o[Math.floor(a/n)%this.
n_actions]+=s),o}lost(e){let[r,n]=this.teams.map(({agents:l})=>l.reduce((c,m)=>c*this.n_actions+e[m],0)),[o,s]=this.teams.map(({play:l})=>l),a=s.reduce((l,c,m)=>l+
c*this.matrix[r*s.length+m],0),i=o.reduce((l,c,m)=>l+c*this.matrix[m*s.length+n],0);return[Math.max(0,this.value-a),Math.max(0,i-this.value)]}},xr=60,rt=class{config;payoff;engine;states;n_turns;values;constructor(e,r,n){
[this.engine,this.config,this.payoff]=[e,r,n],this.states=xe(e,i=>e._states_new(i.arrays(Fe(r)))),_a.register(this,[e,this.states]);let o={SIMULTANEOUS:1,SWARM_TURNS:2,
AGENT_TURNS:r.n_pursuers+r.n_evaders};this.n_turns=o[r.rules.interaction];let{payoffs:s}=this.call(()=>e._states_payoffs(this.states)),a=s;this.values=[[n==="ca\
pture-rate"?a:a.fill(0)]]}goBack(){let e=this.values.at(-1)[0],r=[];for(let o=this.n_turns-1;o>=0;o--){let s=r[o+1]??e;r[o]=this.backup(o,{next:s})}this.payoff===
"capture-time"&&(r[0]=r[0].map((o,s)=>s===this.config.n_evaders?0:o-1)),this.values.push(r);let n=this.payoff==="capture-rate"?this.config.max_steps:Math.min(this.
config.max_steps,xr);return this.values.length<=n&&r[0].some((o,s)=>o!==e[s])}backup(e,r){return this.call(n=>this.engine._states_backup(this.states,e,n.arrays(
r))).values}game(e){let[r,{turn:n}]=[this.config.max_steps-e.steps,e],o=n+1===this.n_turns,s=r>0?this.values[Math.min(r-Number(o),this.values.length-1)]?.[o?0:n+
1]:void 0;if(!s)return null;let a=this.call(i=>this.engine._states_game(this.states,e.address,i.arrays({next:s})));return a.agents.length?new wr(e,a):null}call(e){
return xe(this.engine,e),Ue(this.engine)}};var Nn=new FinalizationRegistry(([t,e])=>t._world_free(e)),nt=class{config;n_agents;n_actions;engine;at;freed=!1;constructor(e,r){this.engine=e,this.config=r,this.
n_agents=r.n_pursuers+r.n_evaders,this.n_actions=r.diagonal?9:5,this.at=xe(e,n=>e._world_new(n.arrays(Fe(r)))),Nn.register(this,[e,this.at],this)}free(){this.freed||
(this.freed=!0,Nn.unregister(this),this.engine._world_free(this.at))}get address(){if(this.freed)throw N("world","one that is in use","one that was freed");return this.
at}reset(e={}){let r=Cn(e,this.config);this.call(n=>this.engine._world_reset(this.address,n.arrays(r)))}step(e){let r=Tt(e);this.call(n=>this.engine._world_step(
this.address,n.arrays(r)))}playTurn(e){let r=Tt(e);this.call(n=>this.engine._world_play_turn(this.address,n.arrays(r)))}decide(e,r,n){let{n_pursuers:o}=this.config,
s={pursuer:[0,o],evader:[o,this.n_agents]},[a,i]=typeof r=="string"?s[r]:r;if(n.length!==this.n_agents)throw N("actions",String(this.n_agents),n.length);let l=[
Ee(e),Tt(n)],{actions:c}=this.call(m=>this.engine._world_decide(this.address,m.arrays(l[0]),a,i,m.arrays(l[1])));return Uint8Array.from(c)}replay(e,r){let n=s=>typeof s!=
"string"&&s.kind==="cells"&&s.memory!=="none";if(!n(r.pursuer)&&!n(r.evader))return this.step(e);let{n_pursuers:o}=this.config;for(let s=this.n_turns;s>0;--s){let[
a,i]=this.actors;a<o&&this.decide(r.pursuer,[a,Math.min(i,o)],e),i>o&&this.decide(r.evader,[Math.max(a,o),i],e),this.playTurn(e)}}get n_turns(){return this.turnNumbers()[1]}get turn(){
return this.turnNumbers()[0]}get actors(){let[,,e,r]=this.turnNumbers();return[e,r]}turnNumbers(){return this.call(()=>this.engine._world_turn(this.address)).turn}get steps(){
return this.read("steps")[0]}get seed(){return this.read("seed")[0]}get episode(){return this.read("episode")[0]}get over(){return this.read("terminated")[0]===
1||this.read("truncated")[0]===1}read(e){return this.call(r=>this.engine._world_read(this.address,r.text(e)))[e]}view(e){let r=3*this.config.fov**2;return this.
read("views").slice(e*r,(e+1)*r)}map(){return this.read("state").slice(2*this.config.rows*this.config.cols)}conflicts(){return Mt(this.conflictTable(),this.config.
n_pursuers)}conflictTable(){return this.call(()=>this.engine._world_conflicts(this.address)).conflict_table}answer(e,r){let n=Ee(e),{logits:o,memory:s}=this.call(
l=>this.engine._world_logits(this.address,l.arrays(n),r)),a=o,i=this.decide(e,[r,r+1],new Uint8Array(this.n_agents))[r];return{logits:a,probabilities:La(a),action:i,
memory:s}}rate(e,r){let n=Ee(e),{ratings:o,refused:s}=this.call(c=>this.engine._world_rate(this.address,c.arrays(n),r)),a=this.read("inputs"),i=a.length/this.n_agents/
this.n_actions,l=c=>Float32Array.from({length:this.n_actions},(m,d)=>a[(r*this.n_actions+d)*i+c]);return{inputs:e.inputs.map(c=>l(br(c))),ratings:o,refused:s}}snapshot(){
return this.call(()=>this.engine._world_snapshot(this.address))}restore(e){let r=kn(e);this.call(n=>this.engine._world_restore(this.address,n.arrays(r)))}call(e){
return xe(this.engine,e),Ue(this.engine)}};function La(t){let e=Math.max(...t),r=Array.from(t,o=>Math.exp(o-e)),n=r.reduce((o,s)=>o+s,0);return Float32Array.from(
r,o=>o/n)}var Sr=class{compiled;constructor(e){this.compiled=e}world(e){return new nt(this.compiled,e)}solution(e,r="capture-rate"){return new rt(this.compiled,e,r)}match(e,r,n,o,s=0){
return Pn(this.compiled,{config:e,pursuers:r,evaders:n},o,s)}rollouts(e,r,n,o,s){return _n(this.compiled,{config:e,pursuers:r,evaders:n},o,s)}},Ln;function In(t=globalThis.
matrixworldEngine){return Ln??=Ia(t),Ln}async function Ia(t){if(!t)throw new Error("matrixworldEngine: expected the script engine.js before this one, got none");
let e=Uint8Array.from(atob(t.binary),r=>r.charCodeAt(0));return new Sr(await t({wasmBinary:e}))}var Wa="http://www.w3.org/2000/svg";function u(t,e={},...r){return Wn(document.createElement(t),e,r)}function x(t,e={},...r){return Wn(document.createElementNS(
Wa,t),e,r)}function Wn(t,e,r){for(let[o,s]of Object.entries(e))s==null||s===!1||(typeof s=="function"?t.addEventListener(o.slice(2),s):t.setAttribute(o,s===!0?"":
String(s)));let n=r.filter(o=>o!=null&&o!==!1);return t.append(...n.map(o=>typeof o=="number"?String(o):o)),t}function Un(t,e){let r=u("select",{onchange:()=>e(
r.value)},...t.map(([n,o])=>u("option",{value:n},o)));return r}async function Fn(t){try{await t}catch(e){let r=document.querySelector("#page, main")??document.body;
throw r.querySelector(".absent")?.remove(),r.prepend(u("p",{class:"card problem",role:"alert"},e instanceof WebAssembly.CompileError||/WebAssembly/.test(String(
e))?"This page plays by WebAssembly, which is forbidden where it lies ('wasm-unsafe-eval' is missing in the content policy): save the file, and open it from you\
r disk.":`The page could not start: ${String(e)}`)),e}finally{document.body.dataset.ready="true"}}var Dn=()=>["file:","http:","https:"].includes(location.protocol);var zn=()=>document.documentElement.dataset.theme==="dark",ot=t=>{document.documentElement.dataset.theme=t?"dark":"light"},Mr=()=>ot(!zn());if(typeof document<"\
u"){let t=matchMedia("(prefers-color-scheme: dark)");t.addEventListener("change",()=>ot(t.matches)),ot(t.matches);let e=!1;addEventListener("beforeprint",()=>{e=
zn(),ot(!1)}),addEventListener("afterprint",()=>ot(e))}function Bn(){return u("button",{type:"button",title:"Light or dark (D)","aria-label":"Light or dark",onclick:Mr},
"◐")}var Hn=(t,e,...r)=>u("header",{class:"top"},u("div",{},u("h1",{},t),e?u("p",{class:"lead"},e):null),u("div",{class:"tools"},...r,Bn()));var Ua=2n**64n-1n;function st(t,e,r){let n=new URLSearchParams(t.replace(/^#/,"")),o=(c,m,d)=>{let p=n.get(c)??"";return/^\d{1,9}$/.test(p)&&Number(p)<m?Number(
p):d},s=o("run",e.length,r.run),[a,i]=e[s].payoff.shape,l=n.get("seed")??"";return{run:s,pursuer:o("pursuers",a,Math.min(r.pursuer,a-1)),evader:o("evaders",i,Math.
min(r.evader,i-1)),episode:o("episode",1/0,r.episode),seed:/^\d{1,20}$/.test(l)&&BigInt(l)<=Ua?l:null,step:o("step",1/0,0)}}function jn(t,e,r){let[n,o,s]=["",JSON.
stringify(e.selected),-800],a=()=>{let{run:i,pursuer:l,evader:c,episode:m,seed:d}=e.selected,p={run:i,pursuers:l,evaders:c,episode:m,...d===null?{}:{seed:d},step:r.
player.step},h=JSON.stringify(e.selected),f=h!==o&&performance.now()-s>800;h!==o&&([o,s]=[h,performance.now()]),n=`#${Object.entries(p).map(([y,g])=>`${y}=${g}`).
join("&")}`;try{f?history.pushState(null,"",n):history.replaceState(null,"",n)}catch{}};a(),e.on("match",a),r.player.addEventListener("state",()=>r.player.playing||
a()),r.player.addEventListener("step",()=>r.player.playing||a()),window.addEventListener("hashchange",()=>{if(location.hash===n)return;let{step:i,...l}=st(location.
hash,t,e.selected);for(let c of document.querySelectorAll("dialog[open]"))c.close();o=JSON.stringify(l),e.select(l),r.goTo(i)})}var Fa=5e3,Gn=8e3;function Vn(t,e,r){
let n=-Gn;for(let o of["pointerdown","pointermove","keydown","wheel"])window.addEventListener(o,()=>n=performance.now(),{passive:!0});setInterval(()=>{if(r()||performance.
now()-n<Gn)return;let{run:o,pursuer:s,evader:a}=e.selected,[i,l]=t[o].payoff.shape;s===i-1&&a===l-1&&history.replaceState(null,"",`#run=${o}`),location.reload()},
Fa)}var P=Uint8Array,re=Uint16Array,Pr=Int32Array,Rt=new P([0,0,0,0,0,0,0,0,1,1,1,1,2,2,2,2,3,3,3,3,4,4,4,4,5,5,5,5,0,0,0,0]),$t=new P([0,0,0,0,1,1,2,2,3,3,4,4,5,5,
6,6,7,7,8,8,9,9,10,10,11,11,12,12,13,13,0,0]),Cr=new P([16,17,18,0,8,7,9,6,10,5,11,4,12,3,13,2,14,1,15]),Xn=function(t,e){for(var r=new re(31),n=0;n<31;++n)r[n]=
e+=1<<t[n-1];for(var o=new Pr(r[30]),n=1;n<30;++n)for(var s=r[n];s<r[n+1];++s)o[s]=s-r[n]<<5|n;return{b:r,r:o}},Qn=Xn(Rt,2),eo=Qn.b,kr=Qn.r;eo[28]=258,kr[258]=28;
var to=Xn($t,0),Da=to.b,Kn=to.r,Rr=new re(32768);for(E=0;E<32768;++E)ge=(E&43690)>>1|(E&21845)<<1,ge=(ge&52428)>>2|(ge&13107)<<2,ge=(ge&61680)>>4|(ge&3855)<<4,Rr[E]=
((ge&65280)>>8|(ge&255)<<8)>>1;var ge,E,de=(function(t,e,r){for(var n=t.length,o=0,s=new re(e);o<n;++o)t[o]&&++s[t[o]-1];var a=new re(e);for(o=1;o<e;++o)a[o]=a[o-
1]+s[o-1]<<1;var i;if(r){i=new re(1<<e);var l=15-e;for(o=0;o<n;++o)if(t[o])for(var c=o<<4|t[o],m=e-t[o],d=a[t[o]-1]++<<m,p=d|(1<<m)-1;d<=p;++d)i[Rr[d]>>l]=c}else
for(i=new re(n),o=0;o<n;++o)t[o]&&(i[o]=Rr[a[t[o]-1]++]>>15-t[o]);return i}),Se=new P(288);for(E=0;E<144;++E)Se[E]=8;var E;for(E=144;E<256;++E)Se[E]=9;var E;for(E=
256;E<280;++E)Se[E]=7;var E;for(E=280;E<288;++E)Se[E]=8;var E,lt=new P(32);for(E=0;E<32;++E)lt[E]=5;var E,za=de(Se,9,0),Ba=de(Se,9,1),Ha=de(lt,5,0),Ga=de(lt,5,1),
Ar=function(t){for(var e=t[0],r=1;r<t.length;++r)t[r]>e&&(e=t[r]);return e},le=function(t,e,r){var n=e/8|0;return(t[n]|t[n+1]<<8)>>(e&7)&r},Tr=function(t,e){var r=e/
8|0;return(t[r]|t[r+1]<<8|t[r+2]<<16)>>(e&7)},_r=function(t){return(t+7)/8|0},Nr=function(t,e,r){return(e==null||e<0)&&(e=0),(r==null||r>t.length)&&(r=t.length),
new P(t.subarray(e,r))};var ja=["unexpected EOF","invalid block type","invalid length/literal","invalid distance","stream finished","no stream handler",,"no callback","invalid UTF-8 da\
ta","extra field too long","date not in range 1980-2099","filename too long","stream finishing","invalid zip data"],q=function(t,e,r){var n=new Error(e||ja[t]);
if(n.code=t,Error.captureStackTrace&&Error.captureStackTrace(n,q),!r)throw n;return n},Va=function(t,e,r,n){var o=t.length,s=n?n.length:0;if(!o||e.f&&!e.l)return r||
new P(0);var a=!r,i=a||e.i!=2,l=e.i;a&&(r=new P(o*3));var c=function(Ze){var Je=r.length;if(Ze>Je){var Ne=new P(Math.max(Je*2,Ze));Ne.set(r),r=Ne}},m=e.f||0,d=e.
p||0,p=e.b||0,h=e.l,f=e.d,y=e.m,g=e.n,b=o*8;do{if(!h){m=le(t,d,1);var w=le(t,d+1,3);if(d+=3,w)if(w==1)h=Ba,f=Ga,y=9,g=5;else if(w==2){var _=le(t,d,31)+257,k=le(
t,d+10,15)+4,A=_+le(t,d+5,31)+1;d+=14;for(var M=new P(A),U=new P(19),I=0;I<k;++I)U[Cr[I]]=le(t,d+I*3,7);d+=k*3;for(var B=Ar(U),be=(1<<B)-1,Q=de(U,B,1),I=0;I<A;){
var V=Q[le(t,d,be)];d+=V&15;var v=V>>4;if(v<16)M[I++]=v;else{var F=0,$=0;for(v==16?($=3+le(t,d,3),d+=2,F=M[I-1]):v==17?($=3+le(t,d,7),d+=3):v==18&&($=11+le(t,d,
127),d+=7);$--;)M[I++]=F}}var K=M.subarray(0,_),D=M.subarray(_);y=Ar(K),g=Ar(D),h=de(K,y,1),f=de(D,g,1)}else q(1);else{var v=_r(d)+4,S=t[v-4]|t[v-3]<<8,T=v+S;if(T>
o){l&&q(0);break}i&&c(p+S),r.set(t.subarray(v,T),p),e.b=p+=S,e.p=d=T*8,e.f=m;continue}if(d>b){l&&q(0);break}}i&&c(p+131072);for(var qe=(1<<y)-1,se=(1<<g)-1,ye=d;;ye=
d){var F=h[Tr(t,d)&qe],ee=F>>4;if(d+=F&15,d>b){l&&q(0);break}if(F||q(2),ee<256)r[p++]=ee;else if(ee==256){ye=d,h=null;break}else{var te=ee-254;if(ee>264){var I=ee-
257,O=Rt[I];te=le(t,d,(1<<O)-1)+eo[I],d+=O}var me=f[Tr(t,d)&se],Pe=me>>4;me||q(3),d+=me&15;var D=Da[Pe];if(Pe>3){var O=$t[Pe];D+=Tr(t,d)&(1<<O)-1,d+=O}if(d>b){l&&
q(0);break}i&&c(p+131072);var _e=p+te;if(p<D){var xt=s-D,St=Math.min(D,_e);for(xt+p<0&&q(3);p<St;++p)r[p]=n[xt+p]}for(;p<_e;++p)r[p]=r[p-D]}}e.l=h,e.p=ye,e.b=p,
e.f=m,h&&(m=1,e.m=y,e.d=f,e.n=g)}while(!m);return p!=r.length&&a?Nr(r,0,p):r.subarray(0,p)},ve=function(t,e,r){r<<=e&7;var n=e/8|0;t[n]|=r,t[n+1]|=r>>8},at=function(t,e,r){
r<<=e&7;var n=e/8|0;t[n]|=r,t[n+1]|=r>>8,t[n+2]|=r>>16},Er=function(t,e){for(var r=[],n=0;n<t.length;++n)t[n]&&r.push({s:n,f:t[n]});var o=r.length,s=r.slice();if(!o)
return{t:no,l:0};if(o==1){var a=new P(r[0].s+1);return a[r[0].s]=1,{t:a,l:1}}r.sort(function(T,_){return T.f-_.f}),r.push({s:-1,f:25001});var i=r[0],l=r[1],c=0,
m=1,d=2;for(r[0]={s:-1,f:i.f+l.f,l:i,r:l};m!=o-1;)i=r[r[c].f<r[d].f?c++:d++],l=r[c!=m&&r[c].f<r[d].f?c++:d++],r[m++]={s:-1,f:i.f+l.f,l:i,r:l};for(var p=s[0].s,n=1;n<
o;++n)s[n].s>p&&(p=s[n].s);var h=new re(p+1),f=$r(r[m-1],h,0);if(f>e){var n=0,y=0,g=f-e,b=1<<g;for(s.sort(function(_,k){return h[k.s]-h[_.s]||_.f-k.f});n<o;++n){
var w=s[n].s;if(h[w]>e)y+=b-(1<<f-h[w]),h[w]=e;else break}for(y>>=g;y>0;){var v=s[n].s;h[v]<e?y-=1<<e-h[v]++-1:++n}for(;n>=0&&y;--n){var S=s[n].s;h[S]==e&&(--h[S],
++y)}f=e}return{t:new P(h),l:f}},$r=function(t,e,r){return t.s==-1?Math.max($r(t.l,e,r+1),$r(t.r,e,r+1)):e[t.s]=r},Yn=function(t){for(var e=t.length;e&&!t[--e];)
;for(var r=new re(++e),n=0,o=t[0],s=1,a=function(l){r[n++]=l},i=1;i<=e;++i)if(t[i]==o&&i!=e)++s;else{if(!o&&s>2){for(;s>138;s-=138)a(32754);s>2&&(a(s>10?s-11<<5|
28690:s-3<<5|12305),s=0)}else if(s>3){for(a(o),--s;s>6;s-=6)a(8304);s>2&&(a(s-3<<5|8208),s=0)}for(;s--;)a(o);s=1,o=t[i]}return{c:r.subarray(0,n),n:e}},it=function(t,e){
for(var r=0,n=0;n<e.length;++n)r+=t[n]*e[n];return r},ro=function(t,e,r){var n=r.length,o=_r(e+2);t[o]=n&255,t[o+1]=n>>8,t[o+2]=t[o]^255,t[o+3]=t[o+1]^255;for(var s=0;s<
n;++s)t[o+s+4]=r[s];return(o+4+n)*8},qn=function(t,e,r,n,o,s,a,i,l,c,m){ve(e,m++,r),++o[256];for(var d=Er(o,15),p=d.t,h=d.l,f=Er(s,15),y=f.t,g=f.l,b=Yn(p),w=b.c,
v=b.n,S=Yn(y),T=S.c,_=S.n,k=new re(19),A=0;A<w.length;++A)++k[w[A]&31];for(var A=0;A<T.length;++A)++k[T[A]&31];for(var M=Er(k,7),U=M.t,I=M.l,B=19;B>4&&!U[Cr[B-1]];--B)
;var be=c+5<<3,Q=it(o,Se)+it(s,lt)+a,V=it(o,p)+it(s,y)+a+14+3*B+it(k,U)+2*k[16]+3*k[17]+7*k[18];if(l>=0&&be<=Q&&be<=V)return ro(e,m,t.subarray(l,l+c));var F,$,K,
D;if(ve(e,m,1+(V<Q)),m+=2,V<Q){F=de(p,h,0),$=p,K=de(y,g,0),D=y;var qe=de(U,I,0);ve(e,m,v-257),ve(e,m+5,_-1),ve(e,m+10,B-4),m+=14;for(var A=0;A<B;++A)ve(e,m+3*A,
U[Cr[A]]);m+=3*B;for(var se=[w,T],ye=0;ye<2;++ye)for(var ee=se[ye],A=0;A<ee.length;++A){var te=ee[A]&31;ve(e,m,qe[te]),m+=U[te],te>15&&(ve(e,m,ee[A]>>5&127),m+=
ee[A]>>12)}}else F=za,$=Se,K=Ha,D=lt;for(var A=0;A<i;++A){var O=n[A];if(O>255){var te=O>>18&31;at(e,m,F[te+257]),m+=$[te+257],te>7&&(ve(e,m,O>>23&31),m+=Rt[te]);
var me=O&31;at(e,m,K[me]),m+=D[me],me>3&&(at(e,m,O>>5&8191),m+=$t[me])}else at(e,m,F[O]),m+=$[O]}return at(e,m,F[256]),m+$[256]},Ka=new Pr([65540,131080,131088,
131104,262176,1048704,1048832,2114560,2117632]),no=new P(0),Ya=function(t,e,r,n,o,s){var a=s.z||t.length,i=new P(n+a+5*(1+Math.ceil(a/7e3))+o),l=i.subarray(n,i.
length-o),c=s.l,m=(s.r||0)&7;if(e){m&&(l[0]=s.r>>3);for(var d=Ka[e-1],p=d>>13,h=d&8191,f=(1<<r)-1,y=s.p||new re(32768),g=s.h||new re(f+1),b=Math.ceil(r/3),w=2*b,
v=function(ur){return(t[ur]^t[ur+1]<<b^t[ur+2]<<w)&f},S=new Pr(25e3),T=new re(288),_=new re(32),k=0,A=0,M=s.i||0,U=0,I=s.w||0,B=0;M+2<a;++M){var be=v(M),Q=M&32767,
V=g[be];if(y[Q]=V,g[be]=Q,I<=M){var F=a-M;if((k>7e3||U>24576)&&(F>423||!c)){m=qn(t,l,0,S,T,_,A,U,B,M-B,m),U=k=A=0,B=M;for(var $=0;$<286;++$)T[$]=0;for(var $=0;$<
30;++$)_[$]=0}var K=2,D=0,qe=h,se=Q-V&32767;if(F>2&&be==v(M-se))for(var ye=Math.min(p,F)-1,ee=Math.min(32767,M),te=Math.min(258,F);se<=ee&&--qe&&Q!=V;){if(t[M+K]==
t[M+K-se]){for(var O=0;O<te&&t[M+O]==t[M+O-se];++O);if(O>K){if(K=O,D=se,O>ye)break;for(var me=Math.min(se,O-2),Pe=0,$=0;$<me;++$){var _e=M-se+$&32767,xt=y[_e],St=_e-
xt&32767;St>Pe&&(Pe=St,V=_e)}}}Q=V,V=y[Q],se+=Q-V&32767}if(D){S[U++]=268435456|kr[K]<<18|Kn[D];var Ze=kr[K]&31,Je=Kn[D]&31;A+=Rt[Ze]+$t[Je],++T[257+Ze],++_[Je],
I=M+K,++k}else S[U++]=t[M],++T[t[M]]}}for(M=Math.max(M,I);M<a;++M)S[U++]=t[M],++T[t[M]];m=qn(t,l,c,S,T,_,A,U,B,M-B,m),c||(s.r=m&7|l[m/8|0]<<3,m-=7,s.h=g,s.p=y,s.
i=M,s.w=I)}else{for(var M=s.w||0;M<a+c;M+=65535){var Ne=M+65535;Ne>=a&&(l[m/8|0]=c,Ne=a),m=ro(l,m+1,t.subarray(M,Ne))}s.i=a}return Nr(i,0,n+_r(m)+o)},qa=(function(){
for(var t=new Int32Array(256),e=0;e<256;++e){for(var r=e,n=9;--n;)r=(r&1&&-306674912)^r>>>1;t[e]=r}return t})(),Za=function(){var t=-1;return{p:function(e){for(var r=t,
n=0;n<e.length;++n)r=qa[r&255^e[n]]^r>>>8;t=r},d:function(){return~t}}};var Ja=function(t,e,r,n,o){if(!o&&(o={l:1},e.dictionary)){var s=e.dictionary.subarray(-32768),a=new P(s.length+t.length);a.set(s),a.set(t,s.length),t=a,o.w=s.length}
return Ya(t,e.level==null?6:e.level,e.mem==null?o.l?Math.ceil(Math.max(8,Math.min(13,Math.log(t.length)))*1.5):20:12+e.mem,r,n,o)},oo=function(t,e){var r={};for(var n in t)
r[n]=t[n];for(var n in e)r[n]=e[n];return r};var z=function(t,e,r){for(;r;++e)t[e]=r,r>>>=8};var Xa=function(t,e){return((t[0]&15)!=8||t[0]>>4>7||(t[0]<<8|t[1])%31)&&q(6,"invalid zlib data"),(t[1]>>5&1)==+!e&&q(6,"invalid zlib data: "+(t[1]&32?"need":"u\
nexpected")+" dictionary"),(t[1]>>3&4)+2};function Qa(t,e){return Ja(t,e||{},0,0)}function so(t,e){return Va(t.subarray(Xa(t,e&&e.dictionary),-4),{i:2},e&&e.out,e&&e.dictionary)}var ao=function(t,e,r,n){for(var o in t){var s=t[o],a=e+o,i=n;Array.isArray(s)&&(i=oo(n,s[1]),s=s[0]),s instanceof P?r[a]=[s,i]:(r[a+="/"]=[new P(0),i],ao(s,a,r,
n))}},Zn=typeof TextEncoder<"u"&&new TextEncoder,ei=typeof TextDecoder<"u"&&new TextDecoder,ti=0;try{ei.decode(no,{stream:!0}),ti=1}catch{}function kt(t,e){if(e){for(var r=new P(t.length),n=0;n<t.length;++n)r[n]=t.charCodeAt(n);return r}if(Zn)return Zn.encode(t);for(var o=t.length,s=new P(t.length+
(t.length>>1)),a=0,i=function(m){s[a++]=m},n=0;n<o;++n){if(a+5>s.length){var l=new P(a+8+(o-n<<1));l.set(s),s=l}var c=t.charCodeAt(n);c<128||e?i(c):c<2048?(i(192|
c>>6),i(128|c&63)):c>55295&&c<57344?(c=65536+(c&1047552)|t.charCodeAt(++n)&1023,i(240|c>>18),i(128|c>>12&63),i(128|c>>6&63),i(128|c&63)):(i(224|c>>12),i(128|c>>
6&63),i(128|c&63))}return Nr(s,0,a)}var Or=function(t){var e=0;if(t)for(var r in t){var n=t[r].length;n>65535&&q(9),e+=n+4}return e},Jn=function(t,e,r,n,o,s,a,i){var l=n.length,c=r.extra,m=i&&i.length,
d=Or(c);z(t,e,a!=null?33639248:67324752),e+=4,a!=null&&(t[e++]=20,t[e++]=r.os),t[e]=20,e+=2,t[e++]=r.flag<<1|(s<0&&8),t[e++]=o&&8,t[e++]=r.compression&255,t[e++]=
r.compression>>8;var p=new Date(r.mtime==null?Date.now():r.mtime),h=p.getFullYear()-1980;if((h<0||h>119)&&q(10),z(t,e,h<<25|p.getMonth()+1<<21|p.getDate()<<16|p.
getHours()<<11|p.getMinutes()<<5|p.getSeconds()>>1),e+=4,s!=-1&&(z(t,e,r.crc),z(t,e+4,s<0?-s-2:s),z(t,e+8,r.size)),z(t,e+12,l),z(t,e+14,d),e+=16,a!=null&&(z(t,e,
m),z(t,e+6,r.attrs),z(t,e+10,a),e+=14),t.set(n,e),e+=l,d)for(var f in c){var y=c[f],g=y.length;z(t,e,+f),z(t,e+2,g),t.set(y,e+4),e+=4+g}return m&&(t.set(i,e),e+=
m),e},ri=function(t,e,r,n,o){z(t,e,101010256),z(t,e+8,r),z(t,e+10,r),z(t,e+12,n),z(t,e+16,o)};function io(t,e){e||(e={});var r={},n=[];ao(t,"",r,e);var o=0,s=0;for(var a in r){var i=r[a],l=i[0],c=i[1],m=c.level==0?0:8,d=kt(a),p=d.length,h=c.comment,f=h&&
kt(h),y=f&&f.length,g=Or(c.extra);p>65535&&q(11);var b=m?Qa(l,c):l,w=b.length,v=Za();v.p(l),n.push(oo(c,{size:l.length,crc:v.d(),c:b,f:d,m:f,u:p!=a.length||f&&h.
length!=y,o,compression:m})),o+=30+p+g+w,s+=76+2*(p+g)+(y||0)+w}for(var S=new P(s+22),T=o,_=s-o,k=0;k<n.length;++k){var d=n[k];Jn(S,d.o,d,d.f,d.u,d.c.length);var A=30+
d.f.length+Or(d.extra);S.set(d.c,d.o+A),Jn(S,o,d,d.f,d.u,d.c.length,d.o,d.m),o+=16+A+(d.m?d.m.length:0)}return ri(S,o,n.length,_,T),S}var L=(t,e=2)=>t==null?"-":t.toFixed(e);function lo(t,e,r){return e===null||r===null?L(t):`${L(t)} (${L(e)} to ${L(r)})`}function ct(t){let e=Math.abs(t),r=e>=1e4?
e.toExponential(0):e.toFixed(e<100?2:0);return t<0&&Number(r)?`−${r}`:r}var co=t=>t.toLocaleString("en-GB"),pe=t=>t.charAt(0).toUpperCase()+t.slice(1);function ut(t,e,r,n=!1){
let o=(e-t)/Math.max(1,r),s=10**Math.floor(Math.log10(o||1)),a=[1,2,5,10].map(c=>c*s).find(c=>c>=o)??10*s;n&&(a=Math.max(1,Math.round(a)));let i=Math.ceil(t/a-1e-9),
l=Math.floor(e/a+1e-9);return Array.from({length:Math.max(0,l-i+1)},(c,m)=>(i+m)*a)}var ni={teams:{pursuer:"pursuers",evader:"evaders"},generation:{pursuer:"pursuer generation",evader:"evader generation"},score:"capture rate",means:{pursuer:"ca\
ptures",evader:"escapes"},curves:{pursuer:"captures",evader:"escapes"},ends:["0 all escape","1 all caught"],lead:"Each cell is a match between two generations: \
the brighter, the more evaders are captured. Click one to watch it.",click:"watch its match"},oi=([t,e])=>({teams:{pursuer:t,evader:e},generation:{pursuer:`gene\
ration of ${t}`,evader:`generation of ${e}`},score:`score of the ${t}`,means:{pursuer:t,evader:e},curves:{pursuer:"scores",evader:"scores"},ends:[`0 the ${e} wi\
n`,`1 the ${t} win`],lead:`Each cell is a pair of generations: the brighter, the higher the score of the ${t}. Click one to see more of it.`,click:"see more of \
it"}),C=({game:t})=>t?oi(t.teams):ni,W=(t,e,r)=>`${C(t).teams[e]} of generation ${r}`,si=200;function uo(t,e,{pursuer:r,evader:n},o){let{text:s,image:a}=e.shows[`${r}\
 ${n}`]??{},i=Me(t,r,n)?.rates??[],l=`Scores of the ${e.teams[0]} in ${i.length} episodes: ${i.map(c=>L(c)).join(", ")}`;return[s===void 0?null:u("pre",{tabindex:0,
"aria-label":"What the game shows of this pair"},s),a===void 0?null:u("img",{src:a,alt:"What the game shows of this pair",onload:({target:c})=>c.classList.toggle(
"pixels",c.naturalWidth<si)}),...(s??a)===void 0?[u("p",{class:"muted"},e.missing),ai(t,e,r,n,o)]:[],i.length>1?u("p",{class:"small numbers"},l):null].filter(c=>c!==
null)}function ai(t,e,r,n,o){let s=Object.keys(e.shows).map(m=>m.split(" ").map(Number)),a=([m,d])=>(m-r)**2+(d-n)**2,[i,l]=s.sort((m,d)=>a(m)-a(d))[0]??[];if(i===
void 0||l===void 0)return null;let c=`${W(t,"pursuer",i)} against ${W(t,"evader",l)}`;return u("p",{},u("button",{type:"button",onclick:()=>o.select({pursuer:i,
evader:l})},`Nearest: ${c}`))}var H=["pursuer","evader"],po=()=>JSON.parse(Nt("data"));function Me(t,e,r){let[n,o]=[e-t.payoff.first[0],r-t.payoff.first[1]],s=t.payoff.capture_rate[n]?.[o];return s===
void 0?null:{rate:s,rates:t.payoff.capture_rates[n][o],lengths:t.payoff.lengths[n]?.[o]??[]}}function De(t,e,r){let{script:n,policy:o,kept:s,genomes:a}=t.teams[e];
if(n!==null||o===null)return"";if(!s.includes(r))return`The page holds no genome of ${W(t,e,r)}: it would be too large. Choose a generation of ${s.join(", ")}.`;
let i=s.length*o.genome_size;return ho(a,o.genome_size).length===i?"":`The page is damaged: it does not hold the ${i} numbers of the ${e}s' genomes. Write it ag\
ain from its run.`}function Z(t,e,r){let{script:n,policy:o,kept:s,genomes:a}=t.teams[e];if(n!==null||o===null)return n??"random";let i=s.indexOf(r);if(i<0)throw new RangeError(
`${e}: expected a generation whose genome the page holds, got ${r}`);let l=o.genome_size,c=ho(a,l).subarray(i*l,(i+1)*l);return{...o,genome:c}}var Ot=({teams:t},e)=>(t[e].
policy??{kind:"cells"}).kind!=="cells",Pt=({teams:t},e,r)=>t[e].expressions?.[t[e].kept.indexOf(r)]??"";function _t(t,e,{pursuer:r,evader:n,episode:o,seed:s}){let a=e.
seeds[r][n];return t.match(e.world,Z(e,"pursuer",r),Z(e,"evader",n),BigInt(s??a),o)}var Lr=4,mo=new Map;function ho(t,e){let r=mo.get(t);if(r)return r;let n=new Float32Array;try{let o=li(Ir(t),e);o.every(Number.isFinite)&&(n=o)}catch(o){if(!(o instanceof DOMException||
o instanceof RangeError||ii(o)))throw o}return mo.set(t,n),n}var ii=t=>t instanceof Error&&"code"in t;function li(t,e){let r=so(t),n=r.length/Lr,o=new Uint8Array(
r.length);for(let a=0;a<o.length;a++)o[a]=r[a%Lr*n+Math.floor(a/Lr)];let s=new Uint32Array(o.buffer);for(let a=e;a<s.length;a++)s[a]^=s[a-e];return new Float32Array(
o.buffer)}function Ir(t){let e=atob(Nt(t)),r=new Uint8Array(e.length);for(let n=0;n<r.length;n++)r[n]=e.charCodeAt(n);return r}var Nt=t=>document.getElementById(
t)?.textContent??"";var mt=[.5,1,2,4,8,16,32,64],Lt=0,It=12,ci=2,ze=class extends EventTarget{#e;#r;#t;#n=0;#i=0;#s=!1;#u=null;#f=0;#h=[];#m=[];glide=.28;constructor(e,{speed:r=4,still:n=!1}={}){
super(),[this.#e,this.#r,this.#t]=[e,r,n]}get step(){return this.#n}get time(){return this.#t?this.#n:this.#i}get arrived(){return this.#i===this.#n}get playing(){
return this.#s}get length(){return this.#e}set length(e){this.#e=e,this.#n>e&&this.jump(e),this.#o("state")}get marks(){return this.#h}set marks(e){this.#h=e,this.#o(
"state")}get ticks(){return this.#m}set ticks(e){this.#m=e,this.#o("state")}get pace(){return this.#r||Math.max(ci,this.#e/It)}get speed(){return this.#r}set speed(e){
this.#r=e,this.#o("state")}changeSpeed(e){let r=mt.findIndex(n=>n>=this.pace);this.speed=mt[Math.min(mt.length-1,Math.max(0,r+e))]}play(){this.#s||!this.#e||(this.#n===
this.#e&&this.jump(0),this.#s=!0,this.#o("state"),this.#c())}pause(){this.#s&&(this.#s=!1,this.#o("state"))}toggle(){this.#s?this.pause():this.play()}move(e){this.
pause();let r=Math.min(this.#e,Math.max(0,this.#n+e));Math.abs(r-this.#i)>1?this.jump(r):this.#d(r),this.#c()}jump(e){this.#i=Math.min(this.#e,Math.max(0,Math.round(
e))),this.#d(this.#i),this.#o("frame")}#d(e){e!==this.#n&&(this.#n=e,this.#o("step"),this.#t&&this.#o("frame"))}#c(){this.#u===null&&(this.#f=performance.now(),
this.#u=requestAnimationFrame(()=>this.#a()))}#a(){this.#u=null;let e=performance.now();this.#l(Math.min(.25,(e-this.#f)/1e3)),this.#f=e,(!this.#t||this.arrived)&&
this.#o("frame"),(this.#s||this.#i!==this.#n)&&(this.#u=requestAnimationFrame(()=>this.#a()))}#l(e){let r=e;for(;r>0;){if(this.#i===this.#n){if(!this.#s)return;
if(this.#n===this.#e)return this.pause();this.#d(this.#n+1)}let n=this.#s?this.pace:1/this.glide,o=this.#n-this.#i,s=Math.min(Math.abs(o),r*n);r-=s/n,this.#i=s===
Math.abs(o)?this.#n:this.#i+Math.sign(o)*s}this.#s&&this.#i===this.#e&&this.pause()}#o(e){this.dispatchEvent(new Event(e))}};function Be(t,e){if(e.ctrlKey||e.metaKey||
e.altKey)return!1;let r=e.shiftKey?10:1,o={" ":()=>t.toggle(),ArrowRight:()=>t.move(r),ArrowLeft:()=>t.move(-r),Home:()=>t.move(-t.length),End:()=>t.move(t.length),
"+":()=>t.changeSpeed(1),"-":()=>t.changeSpeed(-1)}[e.key];return o?.(),o!==void 0}function fo(t,e,...r){let n=u("dialog",{class:e,"aria-label":t,onclick:({target:o})=>o===n&&n.close()},u("div",{class:"dialog-head"},u("h2",{},t),u("button",{type:"\
button",class:"close","aria-label":"Close",onclick:()=>n.close()},"✕")),...r);return n}var yo=t=>u("dl",{class:"keys"},...t.flatMap(([e,r])=>[u("dt",{},...e.map(
n=>u("kbd",{},n))),u("dd",{},r)])),go=t=>u("input",{type:"text",readonly:!0,"aria-label":t});function vo(t,e){t.value=e,t.hidden=!1,t.select(),navigator.clipboard?.
writeText(e).catch(()=>{})}function bo(t,e){let r=URL.createObjectURL(new Blob([e],{type:"application/octet-stream"}));u("a",{href:r,download:t}).click(),setTimeout(
()=>URL.revokeObjectURL(r),6e4)}var dt=[[68,1,84],[72,26,108],[71,47,125],[65,68,135],[57,86,140],[49,104,142],[42,120,142],[35,136,142],[31,152,139],[34,168,132],[53,183,121],[84,197,104],[122,
209,81],[165,219,54],[210,226,27],[253,231,37]];function Wt(t){let e=Math.min(1,Math.max(0,t))*(dt.length-1),r=Math.min(dt.length-2,Math.floor(e)),[n,o]=[dt[r],
dt[r+1]],s=a=>Math.round(n[a]+(e-r)*(o[a]-n[a]));return[s(0),s(1),s(2)]}function wo(t){let[e,r,n]=Wt(t).map(o=>((o/255+.055)/1.055)**2.4);return .2126*e+.7152*r+
.0722*n>.179?"#000":"#fff"}var xo=t=>`rgb(${Wt(t).join(" ")})`,So=()=>`linear-gradient(to right, ${dt.map(t=>`rgb(${t.join(" ")})`).join(", ")})`;function Ut(t,e,r){let n=devicePixelRatio||1;for(let[a,i]of Object.entries(r))t.style.setProperty(a,`${i}px`);t.width=Math.round(r.width*n),t.height=Math.round(
r.height*n);let o=t.getContext("2d"),s=Wr(e);!o||!s||(o.imageSmoothingEnabled=!1,o.drawImage(s,0,0,t.width,t.height))}function Wr(t){let[e,r]=t.shape,n=document.
createElement("canvas");[n.width,n.height]=[r,e];let o=n.getContext("2d");if(!o)return null;let s=o.createImageData(r,e);return t.capture_rate.forEach((a,i)=>a.
forEach((l,c)=>{let m=4*((e-1-i-t.first[0])*r+c+t.first[1]);s.data.set([...Wt(l),255],m)})),o.putImageData(s,0,0),n}function Ft(t,e,r,n=2){t.textContent=L(e,n),
t.ariaLabel=`${r}: ${t.textContent}`,e!==void 0&&([t.style.backgroundColor,t.style.color]=[xo(e),wo(e)])}function pt(t,e){let r=u("span",{class:"gradient"});return r.
style.backgroundImage=So(),u("p",{class:"scale-of-rates small muted"},t,r,e)}var ui=84;function Mo(t,e){let r=t.map((s,a)=>mi(s,a,e)),n=u("nav",{class:"races","aria-label":"Runs"},...r.map(s=>s.button)),o=()=>r.forEach((s,a)=>s.update(a===
e.selected.run));return e.on("match hover",o),o(),n.hidden=t.length<2,n}function mi(t,e,r){let[n,o]=t.payoff.shape,s=!t.name.startsWith(t.schedule),a=ui/Math.max(
n,o),i=u("canvas",{"aria-hidden":"true"});Ut(i,t.payoff,{left:0,top:0,width:o*a,height:n*a});let l=u("span",{class:"place"}),c=u("button",{type:"button",class:"\
race",title:`${t.name} (key ${e+1})`,onclick:()=>Ur(t,e,r)},u("span",{class:"small-matrix"},i,l),u("span",{class:"race-text"},u("strong",{},s?t.name:t.schedule),
u("span",{class:"small"},t.findings?t.findings.sentence:`${t.learning.map(d=>C(t).teams[d]).join(" and ")} against ${di(t)}`),u("span",{class:"small muted"},`${s?
`${t.schedule}, `:""}seed ${t.seed}`)));return{button:c,update:d=>{c.setAttribute("aria-current",String(d));let p=r.hover.pursuer??r.selected.pursuer,h=r.hover.
evader??r.selected.evader;l.hidden=p>=n||h>=o,l.style.left=`${(h+.5)*a}px`,l.style.top=`${(n-p-.5)*a}px`}}}var di=t=>t.teams.pursuer.script??t.teams.evader.script??
"another run";function Ur(t,e,r){let[n,o]=t.payoff.shape,{pursuer:s,evader:a}=r.selected;r.select({run:e,pursuer:Math.min(s,n-1),evader:Math.min(a,o-1)})}var pi=t=>[[["Space"],"play or pause"],[["←","→"],"step back or forward; with Shift ten steps"],[["Home","End"],"first or last step"],[["+","−"],"faster o\
r slower"],[["N"],"next episode of the same pair; with Shift the one before"],[["R"],"another seed, not one of the evaluation"],[["O"],"the cell's own seed agai\
n"],[["P"],`next ${C(t).generation.pursuer}; with Shift the one before`],[["E"],`next ${C(t).generation.evader}; with Shift the one before`],[["M"],`to the matr\
ix: arrow keys choose a ${t.game?"pair, Enter shows it":"match, Enter plays it"}`],[["A"],"next agent: what it sees; with Shift the one before"],[["Esc"],"no ag\
ent"],[["T"],"take over the chosen agent, or an evader, from this step on"],[["G"],"this step in the playground: any other rules, actions and places"],[["1","9"],
"first to ninth run"],[["D"],"light or dark"],[["?"],"this list"]],hi=["P","E","M","1","D","?"],fi="The page holds the genomes and the engine of this run. A cli\
ck on a cell plays that very match: same seed, same moves. ";function Ao(t){let e=t.find(({game:n})=>!n),r=pi(e??t[0]).filter(([[n]])=>e||hi.includes(n));return fo(
"Keys","help",yo(r),u("p",{class:"muted small"},`${e?fi:""}The page loads nothing from elsewhere; share the file as it is.`))}function To(t,e,r,n,o,s){let a=(l,c)=>()=>{
let m=t[e.selected.run].payoff.shape[l==="pursuer"?0:1];e.select({[l]:Math.min(m-1,Math.max(0,e.selected[l]+c))})},i={n:()=>e.select({episode:e.selected.episode+
1}),N:()=>e.select({episode:Math.max(0,e.selected.episode-1)}),r:()=>e.select({seed:String(crypto.getRandomValues(new BigUint64Array(1))[0]),episode:0}),o:()=>e.
select({seed:null,episode:0}),p:a("pursuer",1),P:a("pursuer",-1),e:a("evader",1),E:a("evader",-1),m:()=>document.getElementById("matrix")?.focus(),a:()=>r.inspector.
next(1),A:()=>r.inspector.next(-1),Escape:()=>r.inspector.choose(null),t:o,g:s,d:Mr,"?":()=>n.showModal()};document.addEventListener("keydown",l=>{let c=l.target instanceof
HTMLSelectElement||l.target instanceof HTMLInputElement,m=l.target instanceof HTMLButtonElement&&(l.key===" "||l.key==="Enter");if(document.querySelector("dialo\
g[open]")||c||m||l.defaultPrevented||l.ctrlKey||l.metaKey||l.altKey)return;let d=i[l.key]??i[l.key.toLowerCase()],p=Number(l.key)-1;if(Be(r.player,l)||d)d?.();else if(t[p])
Ur(t[p],p,e);else return;l.preventDefault()})}var He=[[0,0],[-1,0],[0,1],[1,0],[0,-1],[-1,1],[1,1],[1,-1],[-1,-1]];function Eo(t,e,r){let[n,o]=[e[0]-t[0],e[1]-t[1]];return!r&&Math.abs(n)>Math.abs(o)?o=0:r||
(n=0),He.findIndex(([s,a])=>s===Math.sign(n)&&a===Math.sign(o))}var Ce=(t,e)=>e<t.nPursuers,R=(t,e)=>[t.positions[2*e],t.positions[2*e+1]],Fr=({rows:t,cols:e},[
r,n])=>r>=0&&n>=0&&r<t&&n<e,Dr=(t,e,r=3)=>t!==void 0&&[0,1,2].slice(0,r).some(n=>t[3*e+n]),zr=(t,e)=>Dr(t.fault,e),Co=(t,e)=>!zr(t,e)&&Dr(t.involved,e,2);function Dt(t,e,r){
let[n,o]=[R(t,r),R(e,r)],s=n[0]!==o[0]||n[1]!==o[1],a=e.involved===void 0||Dr(e.involved,r);return!!(e.alive[r]&&e.actions?.[r]&&!s&&a)}function zt(t,e,r){let[n,
o]=R(t,r),[s,a]=He[e.actions?.[r]??0];return[n+s,o+a]}function ht(t,e,r){return Array.from({length:r.everCaptured.length},(o,s)=>s).filter(o=>r.everCaptured[o]&&
!e.everCaptured[o]).map(o=>t.nPursuers+o)}var ko=t=>t.moments.flatMap((e,r)=>r&&ht(t,t.moments[r-1],e).length?[r]:[]);function Bt(t,e){return Array.from({length:e.
alive.length},(n,o)=>o).filter(n=>t.alive[n]&&!e.alive[n])}var Ro=[-.31,0,.31],$o=[{size:1,at:[[0,0]]},{size:.62,at:[[-.2,.2],[.2,-.2]]},{size:.54,at:[[-.23,.22],[.23,.22],[0,-.22]]},{size:.54,at:[[-.23,.23],[.23,.23],[
-.23,-.23],[.23,-.23]]},{size:.36,at:Ro.flatMap(t=>Ro.map(e=>[e,t]))}],yi=.3,gi=.35,vi=.55;function ft(t,e){let r=new Map;for(let n=0;n<e.alive.length;n++){if(!e.
alive[n])continue;let[o,s]=R(e,n),a=o*t.cols+s,i=r.get(a);i?i.push(n):r.set(a,[n])}return r}function Oo(t,e){let r=Array.from(e.alive,(n,o)=>{let[s,a]=R(e,o);return{
x:a+.5,y:s+.5,size:1,alpha:0}});for(let n of ft(t,e).values()){let o=$o[Math.min(n.length,$o.length)-1];n.forEach((s,a)=>{let[i,l]=o.at[Math.min(a,o.at.length-1)],
c=r[s];c.x+=i,c.y+=l,c.size=o.size,c.alpha=1})}return r}var Po=t=>t*t*(3-2*t),Ge=(t,e,r)=>t+(e-t)*r,_o=t=>Math.min(1,Math.max(0,t));function No(t,e,r,n){let o={
SIMULTANEOUS:1,SWARM_TURNS:2,AGENT_TURNS:r}[t.interaction];if(o===1)return Po(n);let s=o===r?e:+!Ce(t,e),a=Math.max(1/o,gi);return Po(_o((n-s/(o-1)*(1-a))/a))}function Ht(t,e){
let r=t.moments.length-1,n=Math.min(Math.floor(e),r),o=t.moments[n],s=Oo(t,o);if(n===r||e===n)return s;let a=t.moments[n+1],i=Oo(t,a);return s.map((l,c)=>{let m=No(
t,c,s.length,e-n);return bi(o,a,c,l,i[c],m)})}function Br(t,e,r){let n=t.moments.length-1,o=Math.min(Math.floor(r),n),[s,a]=[t.moments[o],t.moments[Math.min(o+1,
n)]],i=No(t,e,s.alive.length,r-o),[[l,c],[m,d]]=[R(s,e),R(a,e)];return[Ge(c,d,i)+.5,Ge(l,m,i)+.5]}function bi(t,e,r,n,o,s){let a=n.alpha>o.alpha,i={x:Ge(n.x,o.x,
s),y:Ge(n.y,o.y,s),size:a?n.size:Ge(n.size,o.size,s),alpha:a?_o((1-s)/(1-vi)):Ge(n.alpha,o.alpha,s)};if(Dt(t,e,r)){let[l,c]=R(t,r),[m,d]=zt(t,e,r),p=yi*Math.sin(
Math.PI*s);i.x+=(d-c)*p,i.y+=(m-l)*p}return i}var Lo=2*Math.PI;function ke(t,e,r,n){t.beginPath(),t.arc(e,r,n/2,0,Lo)}function Gt(t,e,r,n){let o=n/2,s=[[0,-.97],[.97,.83],[-.97,.83]].map(([a,i])=>[e+a*o,r+i*
o]);t.beginPath(),t.moveTo((s[2][0]+s[0][0])/2,(s[2][1]+s[0][1])/2),s.forEach(([a,i],l)=>{let[c,m]=s[(l+1)%3];t.arcTo(a,i,c,m,n*.09)}),t.closePath()}function Io(t,e,r,n){
let o=n*.32;t.beginPath(),t.moveTo(e-o,r-o),t.lineTo(e+o,r+o),t.moveTo(e+o,r-o),t.lineTo(e-o,r+o)}function Wo(t,e,r,n){t.beginPath();for(let o=0;o<16;o++){let s=n/
2*(o%2?.6:.95),a=Lo*o/16;t.lineTo(e+s*Math.sin(a),r-s*Math.cos(a))}t.closePath()}function Uo(t,e,r,n,o,s){let a=Math.atan2(o-r,n-e);t.beginPath(),t.moveTo(e,r),
t.lineTo(n,o);for(let i of[-1,1])t.moveTo(n,o),t.lineTo(n-s*Math.cos(a+i*.6),o-s*Math.sin(a+i*.6))}var Fo=4,wi=1.6,xi=.95,Si=5,Mi=.16,Ai=9,Ti=.09,Ei=.2,Do=.75,G=(t,e)=>t.left+e*t.cell,j=(t,e)=>t.top+e*t.cell;function je(t,e,r){return Ce(e,r)?t.colors.pursuer:
t.colors.evader}function jt({ctx:t,colors:e},r,n,o,s,a,i=0){t.font=`700 ${Math.round(s)}px system-ui, sans-serif`,t.textAlign="center",t.textBaseline="middle",t.
strokeStyle=e.paper,t.lineWidth=i,i&&t.strokeText(r,n,o),t.fillStyle=a,t.fillText(r,n,o)}function zo({ctx:t,grid:e,colors:r}){let{left:n,top:o,cell:s,rows:a,cols:i}=e,
[l,c]=[i*s,a*s];if(t.fillStyle=r.paper,t.fillRect(n,o,l,c),s<Si)return;t.fillStyle=r.line;let m=Math.max(1,Math.round(s/60));for(let d=1;d<i;d++)t.fillRect(n+d*
s,o,m,c);for(let d=1;d<a;d++)t.fillRect(n,o+d*s,l,m)}function Bo({ctx:t,grid:e,colors:r},n){let{left:o,top:s,cell:a,rows:i,cols:l}=e;t.fillStyle=r.obstacle;for(let c=0;c<
i*l;c++){if(!n.obstacles[c])continue;let[m,d]=[Math.floor(c/l),c%l];t.fillRect(o+d*a,s+m*a,a,a)}Ho({ctx:t,grid:e,colors:r})}function Ho({ctx:t,grid:{left:e,top:r,
cell:n,rows:o,cols:s},colors:a}){let i=Math.min(5,Math.max(2,Math.round(n/18)));t.strokeStyle=a.frame,t.lineWidth=i,t.strokeRect(e-i/2,r-i/2,s*n+i,o*n+i)}function Go({
ctx:t,grid:e,colors:r},n){let{left:o,top:s,cell:a,rows:i,cols:l}=e,c=a<24*n?5:1;t.font=`500 ${Math.round(Math.min(15*n,Math.max(9*n,a*.32)))}px system-ui, sans-\
serif`,t.fillStyle=r.muted,t.textBaseline="alphabetic",t.textAlign="center";let m=5*n+a/40;for(let d=0;d<l;d+=c)t.fillText(String(d),o+(d+.5)*a,s-m);t.textAlign=
"right",t.textBaseline="middle";for(let d=0;d<i;d+=c)t.fillText(String(d),o-m,s+(d+.5)*a)}function jo({grid:t},e,r,n){let o=Math.floor(e.fov/2)+.5,[s,a]=[Math.max(
0,r-o),Math.min(t.cols,r+o)],[i,l]=[Math.max(0,n-o),Math.min(t.rows,n+o)];return[G(t,s),j(t,i),(a-s)*t.cell,(l-i)*t.cell]}function Vo(t,e,r,n){let{ctx:o,grid:s,
colors:a}=t;o.save(),o.beginPath(),o.rect(0,0,o.canvas.width,o.canvas.height),o.rect(...jo(t,e,r,n)),o.clip("evenodd"),o.clearRect(0,0,o.canvas.width,o.canvas.height),
o.fillStyle=a.line,o.fillRect(s.left,s.top,s.cols*s.cell,s.rows*s.cell),o.restore(),Ho(t)}function Ko(t,{x:e,y:r,alpha:n},o){let{ctx:s,grid:a,colors:i}=t,l=Math.
max(a.cell,16*o)*1.06,[c,m]=[G(a,e),j(a,r)];s.globalAlpha=Math.max(n,.6),s.beginPath(),s.roundRect(c-l/2,m-l/2,l,l,l*.2),s.strokeStyle=i.focus,s.lineWidth=Math.
max(2,2.5*o),s.stroke();let d=Math.max(11*o,Math.min(18*o,a.cell*.5)),p=m-l/2<d*1.2,h=m+(p?1:-1)*(l/2+d*.7);s.lineJoin="round",jt(t,"You",c,h,d,i.ink,d*.35),s.globalAlpha=
1}function Yo(t,e,r,n,o){let{ctx:s,grid:a}=t,i=jo(t,e,n,o),l=je(t,e,r);s.globalAlpha=.11,s.fillStyle=l,s.fillRect(...i),s.globalAlpha=.8,s.strokeStyle=l,s.lineWidth=
Math.max(1,a.cell/24),s.strokeRect(...i),s.globalAlpha=1}function qo(t,e,r,n,o){let{ctx:s,grid:a}=t,i=Math.min(Math.ceil(r),e.moments.length-1),l=e.moments[i];s.
lineCap="round",s.lineWidth=Math.min(Ai,Math.max(1,a.cell*Mi));for(let c=Math.max(1,Math.floor(r-n)+1);c<=i;c++){let[m,d]=[e.moments[c-1],e.moments[c]],p=Math.max(
0,Math.min(1,(r-c)/n));s.globalAlpha=Do+(Ei-Do)*p;for(let h=0;h<d.alive.length;h++){let f=c===i&&r<i;if(!m.alive[h]||!(l.alive[h]||f))continue;let y=(Ce(e,h)?-1:
1)*Ti,[g,b]=R(m,h),[w,v]=R(d,h);if(g===w&&b===v)continue;let S=f?o[h].x:v+.5,T=f?o[h].y:w+.5;s.strokeStyle=je(t,e,h),s.beginPath(),s.moveTo(G(a,b+.5+y),j(a,g+.5+
y)),s.lineTo(G(a,S+y),j(a,T+y)),s.stroke()}}s.globalAlpha=1}function Zo(t,e,r){let n=Math.min(Math.ceil(r),e.moments.length-1);for(let o=Math.max(1,n-Fo+1);o<=n;o++){
let[s,a]=[e.moments[o-1],e.moments[o]],i=o>r?Math.max(0,1-2*(o-r)):1-(r-o)/Fo,l=ht(e,s,a);for(let c of Bt(s,a))l.includes(c)||ki(t,R(a,c),i);for(let c of l)Ci(t,
R(a,c),i)}t.ctx.globalAlpha=1}function Ci({ctx:t,grid:e,colors:r},[n,o],s){t.globalAlpha=s,Wo(t,G(e,o+.5),j(e,n+.5),Math.max(8,e.cell*wi)),t.fillStyle=r.capture,
t.fill(),t.strokeStyle=r.ink,t.lineWidth=Math.max(1,e.cell/36),t.lineJoin="round",t.stroke()}function ki({ctx:t,grid:e,colors:r},[n,o],s){t.globalAlpha=s,Io(t,G(
e,o+.5),j(e,n+.5),Math.max(7,e.cell*xi)),t.strokeStyle=r.collision,t.lineWidth=Math.max(2,e.cell*.17),t.lineCap="round",t.stroke()}function Jo({ctx:t,grid:e,colors:r},n,o){
let s=Math.max(1,e.cell*.07);t.strokeStyle=t.fillStyle=r.collision,t.lineWidth=Math.max(1,e.cell*.05),t.setLineDash([e.cell*.14,e.cell*.1]);for(let[a,i]of n){if(a<
0||i<0||a>=e.rows||i>=e.cols)continue;let l=[G(e,i)+s,j(e,a)+s,e.cell-2*s,e.cell-2*s];t.globalAlpha=.2*o,t.fillRect(...l),t.globalAlpha=o,t.strokeRect(...l)}t.setLineDash(
[]),t.globalAlpha=1}function Xo({ctx:t,grid:e,colors:r},n,o,s,a){t.globalAlpha=a,ke(t,G(e,n),j(e,o),Math.max(8,e.cell*s*1.02)),t.strokeStyle=r.collision,t.lineWidth=
Math.max(1.5,e.cell*.085*Math.sqrt(s)),t.stroke(),t.globalAlpha=1}var Ri=.8,$i=.92,Oi=15,Pi=7,Hr=9;function Qo(t,e,r,n,o,s){n.forEach((a,i)=>{a.alpha>0&&_i(t,e,r,i,a,o,s)}),t.ctx.globalAlpha=1;for(let a of ft(e,r).values())a.length>
Hr&&Ni(t,n[a[Hr-1]],a.length-Hr+1)}function _i(t,e,r,n,o,s,a){let{ctx:i,grid:l,colors:c}=t,m=Ce(e,n),[d,p]=[G(l,o.x),j(l,o.y)],h=Math.max(4,l.cell*o.size*(m?$i:
Ri)),f=je(t,e,n),y=!m&&!!r.captured[n-e.nPursuers];if(i.globalAlpha=o.alpha,(m?Gt:ke)(i,d,p,h),h>Pi*a&&(i.strokeStyle=c.paper,i.lineWidth=Math.max(2,h*.1),i.stroke()),
i.fillStyle=y?c.paper:f,i.fill(),y&&(ke(i,d,p,h*.82),i.strokeStyle=f,i.lineWidth=h*.18,i.stroke()),!s||h<Oi*a)return;let g=String(m?n:n-e.nPursuers),b=h*(m?.4:.5)*
(g.length>1?.8:1);jt(t,g,d,p+h*(m?.17:.03),b,y?f:c.paper)}function Ni(t,e,r){let{cell:n}=t.grid;jt(t,`+${r}`,G(t.grid,e.x),j(t.grid,e.y),n*.3,t.colors.ink,n*.1)}var Li=.46,Ii=.86,Wi=.66,es=.48,Ui=.78,Fi=.58;function ts(t,e,r,n){let[o,s]=[e.moments[r-1],e.moments[r]];if(!o)return;let{ctx:a,grid:i,colors:l}=t;a.strokeStyle=
l.collision,a.lineWidth=Math.max(1.5,i.cell*.07),a.lineCap="butt",a.globalAlpha=n;for(let c=0;c<s.alive.length;c++)Dt(o,s,c)&&Di(t,e,R(o,c),zt(o,s,c));a.globalAlpha=
1}function Di({ctx:t,grid:e},r,n,o){let[s,a]=[o[1]-n[1],o[0]-n[0]],i=d=>G(e,n[1]+.5+s*d),l=d=>j(e,n[0]+.5+a*d),c=Fr(r,o)?Ui:Fi;t.setLineDash([e.cell*.09,e.cell*
.06]),t.beginPath(),t.moveTo(i(es),l(es)),t.lineTo(i(c),l(c)),t.stroke(),t.setLineDash([]);let m=.17*e.cell/Math.hypot(s,a);t.beginPath(),t.moveTo(i(c)-a*m,l(c)+
s*m),t.lineTo(i(c)+a*m,l(c)-s*m),t.stroke()}function rs(t,e,r,n,o,s){let a=He[s];if(!s||!a)return;let{ctx:i,grid:l,colors:c}=t,m=Fr(e,[n[0]+a[0],n[1]+a[1]])?Ii:
Wi,d=Li*o.size,p=[G(l,o.x+a[1]*d),j(l,o.y+a[0]*d),G(l,o.x+a[1]*m),j(l,o.y+a[0]*m)],h=Math.max(1.5,l.cell*.085);i.lineCap=i.lineJoin="round";for(let[f,y]of[[c.paper,
h*2.1],[je(t,e,r),h]])i.strokeStyle=f,i.lineWidth=y,Uo(i,...p,l.cell*.2),i.stroke()}var os={numbers:!0,axes:!1,trail:6,viewers:[],plan:null,selected:null,cursor:null,you:null,fog:!1};function ss(t,e,r,n,o){let{ctx:s,grid:a,colors:i}=t,l=Math.min(
Math.ceil(r),e.moments.length-1),c=e.moments[l],m=r===l,d=Ht(e,r),p=m?1:Math.max(0,1-2*(l-r));s.clearRect(0,0,s.canvas.width,s.canvas.height),zo(t);for(let y of n.
viewers)d[y]?.alpha&&Yo(t,e,y,...Br(e,y,r));Bo(t,e),n.axes&&Go(t,o),qo(t,e,r,n.trail,d),Jo(t,c.contested??[],p),Zo(t,e,r),ts(t,e,l,p),d.forEach(({x:y,y:g,size:b},w)=>{
let v=Co(c,w)?.4:0,S=zr(c,w)?1:v;S&&Xo(t,y,g,b,S*p)});let h=m?c:e.moments[Math.max(0,l-1)];if(Qo(t,e,h,d,n.numbers,o),m&&n.plan)for(let[y,g]of d.entries())g.alpha&&
rs(t,e,y,R(c,y),g,n.plan[y]??0);n.you!==null&&(n.fog&&Vo(t,e,...Br(e,n.you,r)),Ko(t,d[n.you],o)),s.lineWidth=Math.max(2,2.5*o),s.strokeStyle=i.focus;let f=n.selected===
null?void 0:d[n.selected];f?.alpha&&ns(t,f.x,f.y,f.size*.96),n.cursor&&(s.setLineDash([a.cell*.12,a.cell*.08]),ns(t,n.cursor[1]+.5,n.cursor[0]+.5,.8),s.setLineDash(
[]))}function ns({ctx:t,grid:e},r,n,o){let s=o*e.cell;t.beginPath(),t.roundRect(e.left+r*e.cell-s/2,e.top+n*e.cell-s/2,s,s,s*.1),t.stroke()}var as=(t,e)=>(e+.24)/(t+.24);function is(t,e,r,n,o,s){let a=r?28*s:0,i=(c,m)=>(c-a)/(m+2*.12),l=Math.max(1,Math.floor(Math.min(i(n,e),i(o,t))));return{rows:t,cols:e,
cell:l,left:Math.round((n-e*l+a)/2),top:Math.round((o-t*l+a)/2)}}function ls(t,e,r){let n=Math.floor((r-t.top)/t.cell),o=Math.floor((e-t.left)/t.cell);return n>=
0&&n<t.rows&&o>=0&&o<t.cols?[n,o]:null}var zi=["paper","line","frame","ink","muted","obstacle"],Bi=["pursuer","evader","capture","collision","focus"];function Vt(t){let e=getComputedStyle(t),r=(n,o)=>[
n,e.getPropertyValue(o+n).trim()];return Object.fromEntries([...zi.map(n=>r(n,"--board-")),...Bi.map(n=>r(n,"--"))])}var Ke=()=>matchMedia("(prefers-reduced-motion: reduce)").matches,Ve=class{canvas;#e=null;#r=0;#t;#n={rows:1,cols:1,left:0,top:0,cell:1};#i=0;constructor(e,r={}){
this.canvas=e,e.classList.add("board"),e.setAttribute("role","img"),this.#t={...os,...r},new ResizeObserver(()=>this.#u()).observe(e),new MutationObserver(()=>this.
redraw()).observe(document.documentElement,{attributes:!0}),addEventListener("beforeprint",()=>this.drawNow())}set look(e){this.#t={...this.#t,...e},this.#s(),this.
redraw()}show(e,r){this.#e=e,this.#r=Math.min(Math.max(0,r),e.moments.length-1),this.#s(),this.redraw()}redraw(){this.#i||(this.#i=requestAnimationFrame(()=>this.
drawNow()))}drawNow(){cancelAnimationFrame(this.#i),this.#i=0;let e=this.canvas.getContext("2d");if(!e||!this.#e)return;let{rows:r,cols:n}=this.#e,o=devicePixelRatio||
1;this.#n=is(r,n,this.#t.axes,this.canvas.width,this.canvas.height,o);let s={ctx:e,grid:this.#n,colors:Vt(this.canvas)};ss(s,this.#e,this.#r,this.#t,o)}cellAt(e,r){
let n=this.canvas.getBoundingClientRect(),o=this.canvas.width/n.width;return ls(this.#n,(e-n.left)*o,(r-n.top)*o)}agentAt(e,r){let n=this.cellAt(e,r);if(!n||!this.#e)
return null;let o=this.#e.moments[Math.round(this.#r)],s=ft(this.#e,o).get(n[0]*this.#e.cols+n[1])??[],a=Ht(this.#e,Math.round(this.#r)),i=l=>{let[c,m]=this.pointOf(
a[l].x,a[l].y);return Math.hypot(c-e,m-r)};return s.length?s.reduce((l,c)=>i(c)<i(l)?c:l):null}pointOf(e,r){let n=this.canvas.getBoundingClientRect(),o=n.width/
this.canvas.width,{left:s,top:a,cell:i}=this.#n;return[n.left+(s+e*i)*o,n.top+(a+r*i)*o]}#s(){if(!this.#e)return;let{rows:e,cols:r}=this.#e;this.canvas.style.setProperty(
"--board-aspect",String(as(e,r)))}#u(){let e=devicePixelRatio||1,{width:r,height:n}=this.canvas.getBoundingClientRect();this.canvas.width=Math.max(1,Math.round(
r*e)),this.canvas.height=Math.max(1,Math.round(n*e)),this.drawNow()}};function Gr(t,e,r){let{rows:n,cols:o,n_pursuers:s,fov:a,rules:{interaction:i}}=t;return{rows:n,cols:o,nPursuers:s,fov:a,interaction:i,obstacles:e,moments:r}}function jr(t,e){
return{positions:t.read("last_positions"),alive:t.read("alive"),captured:t.read("captured"),everCaptured:t.read("ever_captured"),actions:e,involved:t.read("invo\
lved"),fault:t.read("fault"),contested:t.conflicts().map(r=>r.cell)}}function cs(t){let e=Array.from({length:t.length+1},(r,n)=>Hi(t,n));return Gr(t.config,t.map,
e)}function Hi(t,e){let r=t.n_agents,n=t.config.n_evaders,o=(a,i,l)=>a.subarray(i*l,(i+1)*l),s={positions:o(t.last_positions,e,2*r),alive:o(t.alive,e,r),captured:o(
t.captured,e,n),everCaptured:o(t.ever_captured,e,n)};return e===0?s:{...s,actions:o(t.actions,e-1,r),involved:o(t.involved,e-1,3*r),fault:o(t.fault,e-1,3*r),get contested(){
return t.conflicts(e).map(a=>a.cell)}}}var Gi=Array.from({length:16},(t,e)=>{let[r,n]=[e%2?6.5:11,Math.PI*e/8];return`${12+r*Math.sin(n)} ${12-r*Math.cos(n)}`}).join(" ");function us(){let t=[["pursu\
er",x("path",{d:"M12 3 22 20H2z",class:"filled-pursuer"})],["evader",x("circle",{cx:12,cy:12,r:9,class:"filled-evader"})],["capture",x("polygon",{points:Gi,class:"\
filled-capture"})],["captured evader",x("circle",{cx:12,cy:12,r:7.5,class:"ring-evader"})],["conflict",x("rect",{x:3,y:3,width:18,height:18,class:"dashed-confli\
ct"})]];return u("ul",{class:"shapes small","aria-label":"Shapes on the board"},...t.map(([e,r])=>u("li",{},x("svg",{viewBox:"0 0 24 24","aria-hidden":"true"},r),
e)))}var ji={first:"M6 5v14M19 5 9 12l10 7z",back:"M17 5 7 12l10 7z",play:"M7 4.5 19 12 7 19.5z",pause:"M8 5v14M16 5v14",forward:"M7 5l10 7-10 7z",last:"M18 5v14M5 5\
l10 7-10 7z"};function ms(t){return x("svg",{viewBox:"0 0 24 24","aria-hidden":"true",class:"icon"},x("path",{d:ji[t]}))}function yt(t,e,r,n){return u("button",
{type:"button",class:"player-button","aria-label":e,title:`${e} (${r})`,onclick:n},ms(t))}function Kt(t){let e=yt("play","Play","Space",()=>t.toggle()),r=u("inp\
ut",{type:"range",class:"player-scrub",min:0,step:1,"aria-label":"Step",oninput:()=>{t.pause(),t.jump(Number(r.value))}}),n=u("div",{class:"captures","aria-hidd\
en":"true",title:"Captures"}),o=u("div",{class:"losses","aria-hidden":"true"}),s=u("select",{class:"player-speed","aria-label":"Speed",title:`Steps a second, or\
 the whole in ${It} s (+ and -)`,onchange:()=>t.speed=Number(s.value)},u("option",{value:Lt},`in ${It} s`),...mt.map(d=>u("option",{value:d},`${d} / s`))),a=u("\
output",{class:"player-count"}),i=u("div",{class:"player",role:"group","aria-label":"Player"},yt("first","First step","Home",()=>t.move(-t.length)),yt("back","S\
tep back","←",()=>t.move(-1)),e,yt("forward","Step forward","→",()=>t.move(1)),yt("last","Last step","End",()=>t.move(t.length)),u("div",{class:"scrub"},n,o,
r),a,s),l=(d,p={})=>{let h=u("i",p);return h.style.left=`${100*d/Math.max(1,t.length)}%`,h},c=()=>{n.replaceChildren(...t.marks.map(d=>l(d))),o.replaceChildren(
...t.ticks.map(({step:d,kind:p,size:h,text:f})=>{let y=l(d,{class:p,title:`Step ${d}: ${f}`});return y.style.height=`${100*h}%`,y}))},m=()=>{e.replaceChildren(ms(
t.playing?"pause":"play")),e.ariaLabel=t.playing?"Pause":"Play",e.title=`${e.ariaLabel} (Space)`,r.max=String(t.length),r.value=String(t.step),r.ariaValueText=`\
step ${t.step} of ${t.length}`,a.textContent=`${t.step} / ${t.length}`,a.style.minWidth=`${2*String(t.length).length+3}ch`,s.value=String(t.speed)};return t.addEventListener(
"step",m),t.addEventListener("state",m),t.addEventListener("state",c),i.addEventListener("keydown",d=>{!(d.target instanceof HTMLSelectElement||d.key===" "&&d.target!==
r)&&Be(t,d)&&d.preventDefault()}),m(),i}var Vi=40,Yt=class{element;#e;#r=u("div",{class:"episodes",role:"group","aria-label":"Episodes of this cell"});#t=u("p",{class:"check small numbers","aria-live":"\
polite"});constructor(e){this.#e=e,this.element=u("div",{class:"strip-of-episodes"},this.#r,this.#t)}show(e,r){let{pursuer:n,evader:o,episode:s,seed:a}=this.#e.
selected,i=Me(e,n,o);this.#r.replaceChildren(...(i?.rates??[]).slice(0,Vi).map((p,h)=>this.#n(p,h)));let l=a===null?i?.rates[s]:void 0,c=r.statistics.capture_rate,
m=l!==void 0&&Math.abs(c-l)<1e-6&&r.length===i?.lengths[s],d=i?"Not an episode of the evaluation":"The evaluation played no episodes of this pair.";this.#t.dataset.
equal=String(m),this.#t.textContent=m?"As in the evaluation":l===void 0?d:`Episode ${s+1} differs from the evaluation.`,this.#t.title=`Played here: capture rate\
 ${L(c,3)} in ${r.length} steps.${i?` The cell says ${L(i.rate,3)}.`:""}`}#n(e,r){let{selected:n}=this.#e,o=u("span",{class:"bar"});return o.style.height=`${Math.
round(100*e)}%`,u("button",{type:"button",class:"episode",title:`Episode ${r+1}: capture rate ${L(e)}`,"aria-label":`Episode ${r+1}, capture rate ${L(e)}`,"aria\
-pressed":String(r===n.episode&&n.seed===null),onclick:()=>this.#e.select({episode:r,seed:null})},o,u("span",{class:"count"},r+1))}};var ne=["stay","north","east","south","west","northeast","southeast","southwest","northwest"];var ds=0,ps=1,Ki=2,Yi=176;function fs(t,e,r,n){let o=devicePixelRatio||1,s=Vt(t);t.width=t.height=Yi*o;let a=t.getContext("2d");if(!a)return;let{fov:i}=e,l=t.width/
i;a.fillStyle=s.paper,a.fillRect(0,0,t.width,t.height);for(let m=0;r&&m<i*i;m++){let[d,p]=[(m%i+.5)*l,(Math.floor(m/i)+.5)*l],h=y=>!!r[y*i*i+m];h(Ki)&&(a.fillStyle=
s.obstacle,a.fillRect(d-l/2,p-l/2,l,l));let f=h(ds)&&h(ps)?l*.18:0;h(ds)&&hs(a,ke,d+f,p+f,l*.74,s.evader),h(ps)&&hs(a,Gt,d-f,p-f,l*.86,s.pursuer)}a.strokeStyle=
n<e.n_pursuers?s.pursuer:s.evader,a.lineWidth=2*o;let c=Math.floor(i/2)*l;a.strokeRect(c,c,l,l)}function hs(t,e,r,n,o,s){e(t,r,n,o),t.fillStyle=s,t.fill()}var qi=["stay","↑","→","↓","←","↗","↘","↙","↖"];function ys(t,{inputs:e,ratings:r,refused:n},o,s){let a=t.kind==="rating"&&!t.hidden.length?t.genome:
null,i=f=>a?.[f]??1,l=f=>t.kind==="rating"?i(f)!==0:new RegExp(`\\b${t.inputs[f]}\\b`).test(s),c=[...t.inputs.keys()].filter(l).sort((f,y)=>Math.abs(i(y))-Math.
abs(i(f))),m=f=>`${f===o?"taken":""} ${n[f]?"refused":""}`,d=(f,y)=>u("tr",{class:y.every(g=>g===y[0])?"same":""},f,...Array.from(y,(g,b)=>u("td",{class:m(b)},ct(
g)))),p=f=>{let y=t.inputs[f];return u("th",{scope:"row",title:`${a?`weight ${ct(i(f))} x `:""}${Le[y]}`},y.replaceAll("_"," "))},h=u("table",{class:"why number\
s"},u("thead",{},u("tr",{},u("th",{},a?"term":"input"),...Array.from(r,(f,y)=>u("th",{scope:"col",class:m(y),title:ne[y],"aria-label":ne[y]},qi[y]))),d(u("th",{
scope:"row"},a?"sum":"rating"),r)),u("tbody",{},...c.map(f=>d(p(f),e[f].map(y=>i(f)*y)))));return[...s?[u("p",{class:"expression"},u("code",{},s))]:[],u("div",{
class:"wide-table",tabindex:0,role:"group","aria-label":"How the moves are rated"},h)]}var Zi=(t,{pursuer:e,evader:r})=>({pursuers:Z(t,"pursuer",e),evaders:Z(t,"evader",r)}),gs="What it remembers: a number for each unit, from -1 to 1",qt=class{element;#e;#r=u(
"canvas",{class:"seen",role:"img"});#t=u("h3");#n=u("p",{class:"small muted"});#i=u("div",{class:"answers"});#s=u("div",{title:gs});#u=null;#f=null;#h=null;#m=null;#d=null;#c=null;#a=null;#l=0;constructor(e){
this.#e=e,this.element=u("div",{class:"inspector","data-open":"false"},u("p",{class:"hint small muted"},"Click an agent, or press A: what it sees, and why it ta\
kes its move."),u("div",{class:"inspected"},this.#r,u("div",{class:"answer"},this.#t,this.#n,this.#s),this.#i))}get agent(){return this.#a}show(e,r,n,o,s=Zi(r,o)){
this.#u?.free(),this.#u=e.world(n.config),this.#h!==r&&(this.#f=null,this.#a!==null&&this.choose(null)),[this.#h,this.#m,this.#d,this.#c]=[r,n,o,s]}set solution(e){
this.#f=e,this.at(this.#l)}choose(e){this.#a=e,this.element.dataset.open=String(e!==null),this.#e(e),this.at(this.#l)}next(e){let r=this.#m;if(!r)return;let n=this.#a??
(e>0?-1:0);for(let o=0;o<r.n_agents;o++)if(n=(n+e+r.n_agents)%r.n_agents,r.alive[this.#l*r.n_agents+n])return this.choose(n)}at(e){this.#l=e;let[r,n,o,s,a,i]=[this.#m,
this.#u,this.#h,this.#d,this.#c,this.#a];if(!r||!n||!o||!s||!a||i===null)return;let l=i<r.config.n_pursuers?"pursuer":"evader";this.#s.replaceChildren(),this.#t.
replaceChildren(u("span",{class:l},Y(i,r.config.n_pursuers))),r.seek(n,e,a);let c=r.actions.subarray(e*r.n_agents,(e+1)*r.n_agents);for(;c.length&&!n.over&&(i<n.
actors[0]||i>=n.actors[1]);)n.playTurn(c);let m=!!(r.alive[e*r.n_agents+i]&&n.read("alive")[i]);fs(this.#r,r.config,m?n.view(i):null,i),this.#r.ariaLabel=`Field\
 of view of ${Y(i,r.config.n_pursuers)}: evaders, pursuers and obstacles around it`;let d=c[i]??null;if(!m)return this.#o([],"It is gone.");let p=a[`${l}s`],h=typeof p!=
"string"&&p.kind==="cells"?n.answer(p,i):null,f=h?.probabilities??null;h?.memory.length&&this.#s.replaceChildren(u("p",{class:"small muted"},"It remembers:"),Qi(
h.memory));let y=typeof p!="string"&&p.kind!=="cells"?ys(p,n.rate(p,i),d,Pt(o,l,s[l])):[],g=this.#f?.game(n)??null,b=typeof p=="string"?`The script "${p}" plays\
 for it${d===null?"":`; it goes ${ne[d]}`}.`:p.kind!=="cells"?"It takes the best move that its mask allows; of equal ones any.":p.sampled?"Its action is drawn f\
rom these probabilities.":"It takes the most probable action.",w=[["network",f],["perfect",g?.marginal(i)??null]],v=S=>u("p",{class:"small muted"},S);this.#o([...g?
[v(`Value ${g.value.toFixed(2)} under perfect play.`)]:[],...Ji(w,d),...y],d===null?"The episode is over.":b)}#o(e,r){this.#i.replaceChildren(...e),this.#n.textContent=
r}};function Ji(t,e){let r=t.filter(([,s])=>s);if(!r.length)return[];let n=u("div",{class:"action muted"},u("span"),...r.map(([s])=>u("span",{class:"head"},s))),
o=Array.from(r[0][1],(s,a)=>u("div",{class:a===e?"action taken":"action"},u("span",{},ne[a]),...r.flatMap(([,i])=>Xi(i[a]))));return r.length>1||r[0][0]!==t[0][0]?
[n,...o]:o}function Xi(t){let e=u("span",{class:"filled"});return e.style.width=`${100*t}%`,[u("span",{class:"track"},e),u("span",{class:"numbers"},t.toFixed(2))]}
function Qi(t){let e=Array.from(t,r=>{let n=u("span",{title:r.toFixed(2)});return n.style.transform=`scaleY(${r})`,n});return u("div",{class:"units",role:"img",
"aria-label":gs},...e)}function vs(t){let e=JSON.stringify(t,(r,n)=>r==="genome"?Array.from(n):n);return u("script",{type:"application/json",id:"champions"},e.replaceAll("<","\\u003c")).
outerHTML}var bs="champion",ws=0,Vr=64,Kr=100;var el=(t,e)=>Object.keys(t).every(r=>t[r]===e[r]);function xs(t,e){return Object.keys(e).find(r=>el(e[r],t))??null}var gt="_",tl="n",bm=2n**64n-1n;var Yr={fov:11,maxSteps:500,rewards:"paper"},rl=["rules","others","rewards","size","diagonal","fov","limit","seed","ended","walls","pursuers","evaders","played",
"next"];function As(t,e){let r=i=>i.map(l=>ol(l,e)).join(""),n=i=>`${Math.floor(i/t.cols)}.${i%t.cols}`,o=nl(t.rewards,e),s=[t.seed,t.episode,t.steps].join("."),a={rules:Ms(
t.rules,e),others:t.others?Ms(t.others,e):"",rewards:o===Yr.rewards?"":o,size:`${t.rows}x${t.cols}`,diagonal:t.diagonal?"1":"",fov:t.fov===Yr.fov?"":String(t.fov),
limit:t.maxSteps===Yr.maxSteps?"":String(t.maxSteps),seed:s==="0.0.0"?"":s,ended:t.ended?"1":"",walls:t.walls.map(n).join(gt),pursuers:t.pursuers.map(Ss).join(gt),
evaders:t.evaders.map(Ss).join(gt),played:t.played.map(r).join(gt),next:t.next.every(i=>i===ws)?"":r(t.next)};return rl.filter(i=>a[i]).map(i=>`${i}=${a[i]}`).join(
"&")}function Ss({cell:t,gone:e,captured:r,everCaptured:n}){let o=r?"c":n?"e":"";return`${t[0]}.${t[1]}${o}${e?"x":""}`}function Ms(t,e){let r=e.fields.map(({name:n})=>String(
t[n]).toLowerCase());return xs(t,e.variants)??r.join(".")}function nl(t,e){let r=JSON.stringify(t);return Object.keys(e.rewards).find(o=>JSON.stringify(e.rewards[o])===
r)??Object.values(t).map(o=>String(o)).join(gt)}function ol(t,e){if(typeof t=="number")return String(t);if(t===bs)return tl;let r=e.scripts.findIndex(({name:n})=>n===
t);return String.fromCharCode(97+r)}var sl="/* the engine */";function Ts(t,e){return u("button",{type:"button",class:"to-playground",title:"Open this step in the playground (G): the same agents a\
nd actions under any rules",onclick:()=>qr(t(),e)},"What if?")}function qr(t,e){let r=t!==null&&t.match.n_agents<=Kr&&Math.max(t.match.config.rows,t.match.config.
cols)<=Vr,n=r?u("script",{type:"text/plain",id:"scene"},As(al(t.match,t.step),e)).outerHTML:"",o=new TextDecoder().decode(Ir("playground")).replace(sl,()=>Nt("s\
cript-engine")).replace("</noscript>",i=>i+n+(r?vs(t.champions):"")),s=u("iframe",{title:"Playground",srcdoc:o}),a=u("dialog",{class:"what-if","aria-label":"Wha\
t if?",onclose:()=>a.remove()},u("button",{type:"button",class:"leave",onclick:()=>a.close()},"Back to the match"),s);document.body.append(a),a.showModal()}function al(t,e){
let{config:r,n_agents:n}=t,o=Math.max(0,e-1),s=i=>{let l=o*n+i,c=o*r.n_evaders+i-r.n_pursuers,m=d=>i>=r.n_pursuers&&!!d[c];return{cell:[t.last_positions[2*l],t.
last_positions[2*l+1]],gone:!t.alive[l],captured:m(t.captured),everCaptured:m(t.ever_captured)}},a=Array.from({length:n},(i,l)=>s(l));return{rules:r.rules,others:null,
rewards:r.rewards,rows:r.rows,cols:r.cols,diagonal:r.diagonal,fov:r.fov,maxSteps:r.max_steps,seed:t.seed,episode:BigInt(t.episode),steps:o,ended:o===t.length,walls:Array.
from(t.map.keys()).filter(i=>t.map[i]),pursuers:a.slice(0,r.n_pursuers),evaders:a.slice(r.n_pursuers),played:[],next:Array.from(t.actions.subarray(o*n,(o+1)*n))}}var Zr=.005,Cs=.05,il=["pursuer","evader"],ll=4,Ye=new Map;function Zt(t,e,r="capture-rate"){let n=JSON.stringify([{...e,rewards:null},r]),o=Ye.get(n)??(Ct(e)?Promise.
resolve(null):cl(t,e,r));return Ye.delete(n),Ye.set(n,o),Ye.size>ll&&Ye.delete([...Ye.keys()][0]),o}var ks=({n_evaders:t})=>t===1?"capture-time":"capture-rate",
Es=()=>new Promise(t=>setTimeout(t));async function cl(t,e,r){await Es();let n=t.solution(e,r);for(;n.goBack();)await Es();return n}function Jt(t,e,r){let{payoff:n}=t;
return r.flatMap((o,s)=>{let a=[0,0];for(let l=e.n_turns;l>0&&!e.over;l--)t.game(e)?.lost(o).forEach((c,m)=>a[m]+=c),e.playTurn(o);let i=n==="capture-rate"?Zr:Cs;
return il.map((l,c)=>({step:s+1,team:l,lost:a[c],payoff:n})).filter(l=>l.lost>=i)})}var Xt=t=>t.map(e=>({step:e.step,kind:e.team,size:e.lost/Math.max(1,...t.map(
({lost:r})=>r)),text:vt(e)})),Rs=({lost:t,payoff:e})=>e==="capture-rate"?`${t.toFixed(2)} of the capture rate`:`${t.toFixed(1)} steps`,vt=t=>`The ${t.team}s los\
e ${Rs(t)} against a perfect opponent`;function $s(t){let e=t.reduce((r,n)=>n.lost>r.lost?n:r);return`Your team's worst moves, in step ${e.step}, lost ${Rs(e)} \
against a perfect opponent.`}function Os({config:t,payoff:e},{value:r},n){if(e==="capture-rate")return`value ${r.toFixed(2)}`;let[o,s]=[1-r,Math.min(t.max_steps-
n,xr)];return o>s-Cs?`free for ${s} steps`:`captured after ${o.toFixed(1)} steps`}function Ps(t,e){return(t.marginal(e)??[]).map((n,o)=>({share:n,action:o})).filter(
({share:n})=>n>=Zr).sort((n,o)=>o.share-n.share).map(({share:n,action:o})=>n>1-Zr?ne[o]:`${ne[o]} ${n.toFixed(2)}`).join(", ")}function Qt(t,e,r){if(r===0)return[{kind:"start",text:ul(t),agents:[]}];let[n,o]=[e.moments[r-1],e.moments[r]],s=m=>Y(m,t.config.n_pursuers),a=ht(e,n,o),i=t.conflicts(
r),l=new Set(i.flatMap(m=>m.doomed)),c=a.map(m=>({kind:"capture",text:`${s(m)} is captured`,agents:[m]}));for(let m of Bt(n,o))!a.includes(m)&&!l.has(m)&&c.push(
{kind:"end",text:`${s(m)} disappears`,agents:[m]});return c.push(...i.map(({kind:m,text:d,agents:p})=>({kind:m,text:d,agents:p}))),r===t.length&&c.unshift({kind:"\
end",text:ml(t),agents:[]}),c}function ul({config:t}){return`${t.n_pursuers} pursuers and ${t.n_evaders} evaders on ${t.rows} x ${t.cols} cells, at most ${t.max_steps}\
 steps`}function ml(t){let e=Math.round(t.statistics.capture_rate*t.config.n_evaders);return`The episode ends after ${t.length} steps with ${e} of ${t.config.n_evaders}\
 evaders captured`}var dl=60,er=class{element;player=new ze(0,{speed:Lt,still:Ke()});inspector;match=null;recording=null;actions;#e;#r;#t;#n;#i=u("h2",{class:"match-title"});#s=u(
"p",{class:"tally numbers"});#u=u("ol",{class:"words",tabindex:0,"aria-live":"off","aria-label":"What happened in this step"});#f=u("p",{class:"problem",role:"a\
lert"});#h=u("div",{class:"shown","aria-live":"polite"});#m=null;#d=null;#c=0;#a=!1;#l=0;#o=[];constructor(e,r,n){[this.#r,this.#t]=[e,r];let o=u("canvas",{"ari\
a-label":"The match",onclick:({clientX:s,clientY:a})=>this.inspector.choose(this.#e.agentAt(s,a))});this.#e=new Ve(o,{numbers:!1}),this.#n=new Yt(r),this.inspector=
new qt(s=>this.#T(s)),this.actions=u("div",{class:"match-actions"},u("button",{type:"button",class:"to-play",title:"Move the chosen agent, or an evader, yoursel\
f from this step on (T)",onclick:()=>this.element.dispatchEvent(new Event("takeover"))},"Take over"),n&&Ts(()=>this.shown,n)),this.element=u("section",{class:"c\
ard match-card","aria-label":"Match",id:"match"},u("div",{class:"match"},u("header",{class:"match-head"},this.#i,this.#s),this.#f,this.#h,u("div",{class:"stage"},
o),u("div",{class:"aside"},this.#u,us(),this.actions,this.inspector.element),Kt(this.player),this.#n.element)),this.player.addEventListener("frame",()=>this.recording&&
this.#e.show(this.recording,this.player.time)),this.player.addEventListener("step",()=>this.#S()),r.on("match",()=>this.#g()),this.#x(),this.#M(0,0)}get#p(){return this.#r[this.#t.
selected.run]}reveal(){(this.#p.game?this.#h:this.#e.canvas).scrollIntoView({block:"nearest"})}get shown(){return this.match&&this.#d&&{match:this.match,step:this.
player.step,champions:this.#d}}start(e){this.#m=e,this.#v()}playSoon(){this.#a=!0,this.#c||this.#y()}goTo(e){this.#l=e,!this.#c&&this.match&&this.#v()}#y(){!this.#a||
!this.match||(this.#a=!1,this.player.jump(0),Ke()||this.player.play())}#g(){this.#x(),clearTimeout(this.#c),this.#c=setTimeout(()=>this.#v(),dl)}#v(){clearTimeout(
this.#c),this.#c=0,this.player.pause(),this.#x();let{selected:e}=this.#t,{game:r}=this.#p;if(this.#h.replaceChildren(...r?uo(this.#p,r,e,this.#t):[]),r){this.match=
this.recording=null,this.#a=!1,this.#b(e);return}let n=H.map(a=>De(this.#p,a,e[a])).find(Boolean)??"";if(this.#f.textContent=n,n||!this.#m)return;this.match=_t(
this.#m,this.#p,e);let[o,s]=this.names(e);this.#d={pursuer:{name:o,policy:Z(this.#p,"pursuer",e.pursuer)},evader:{name:s,policy:Z(this.#p,"evader",e.evader)}},this.
recording=cs(this.match),this.#n.show(this.#p,this.match),this.inspector.show(this.#m,this.#p,this.match,e),this.player.length=this.match.length,this.player.marks=
ko(this.recording),this.#o=this.player.ticks=[],this.player.jump(this.#l),this.#l=0,this.#S(),this.#w(this.#m,this.match),this.#b(e),this.#y()}#b({run:e,pursuer:r,
evader:n,episode:o,seed:s}){this.element.dataset.played=`${e} ${r} ${n} ${o} ${s??""}`}async#w(e,r){let n=await Zt(e,r.config);if(this.match!==r||!n)return;let o=e.
world(r.config);r.seek(o,0),this.#o=Jt(n,o,pl(r)),o.free(),this.player.ticks=Xt(this.#o),this.inspector.solution=n,this.#S()}names({run:e,pursuer:r,evader:n}){let o=this.#r[e],
{teams:s}=o;return[s.pursuer.script??W(o,"pursuer",r),s.evader.script??W(o,"evader",n)]}#x(){let{episode:e,seed:r}=this.#t.selected,{game:n,payoff:o}=this.#p;this.
element.classList.toggle("of-own-game",!!n),this.element.classList.toggle("of-ratings",H.some(l=>Ot(this.#p,l)));let[s,a]=this.names(this.#t.selected),i=r===null?
e<o.episodes?`episode ${e+1} of ${o.episodes}`:`episode ${e+1}, not part of the cell`:`seed ${r}`;this.#i.replaceChildren(u("span",{class:"pursuer"},pe(s))," ag\
ainst ",u("span",{class:"evader"},a),n?"":u("span",{class:"muted small"},i))}#S(){let e=this.match;if(!e||!this.recording)return;let r=this.player.step,n=this.recording.
moments[r];this.#M(Array.from(n.everCaptured).filter(Boolean).length,r),this.#u.replaceChildren(...this.#o.filter(o=>o.step===r).map(o=>u("li",{class:`loss-${o.
team}`},vt(o))),...Qt(e,this.recording,r).map(o=>u("li",{class:o.kind,"data-agents":o.agents.join(" ")},o.text))),this.inspector.at(r),this.#A()}#M(e,r){let{world:n}=this.#p;
n&&this.#s.replaceChildren(u("strong",{},e),` of ${n.n_evaders} captured`,u("span",{class:"muted"},` · step ${r}`))}#T(e){this.#e.look={selected:e,viewers:e===
null?[]:[e]},this.#A()}#A(){let e=this.inspector.agent;for(let r of this.#u.children){let n=r.dataset.agents?.split(" ")??[];r.classList.toggle("about",e!==null&&
n.includes(String(e)))}}},pl=({actions:t,length:e,n_agents:r})=>Array.from({length:e},(n,o)=>t.subarray(o*r,(o+1)*r));var hl={ArrowUp:[1,0],ArrowDown:[-1,0],ArrowRight:[0,1],ArrowLeft:[0,-1]},fl=5;function Re(t,e,r,n="pursuer"){t.tabIndex=0,t.setAttribute("role","application"),
t.addEventListener("keydown",o=>{let s=hl[o.key];if(!s)return;let[a,i]=n==="pursuer"?s:[s[1],s[0]],[l,c]=r(),m=o.shiftKey?fl:1,{pursuer:d,evader:p}=e.selected;e.
select({pursuer:_s(d+m*a,l),evader:_s(p+m*i,c)}),o.preventDefault(),o.stopPropagation()})}var _s=(t,e)=>Math.min(e-1,Math.max(0,t));var yl=24,tr=7,Ls=t=>t<yl&&matchMedia("(pointer: coarse)").matches;function Is(t,e,r,n){let[o,s]=t.payoff.shape,[a,i]=[Ns(e,o),Ns(r,s)],[l,c]=[Math.min(tr,o),Math.
min(tr,s)],m=[];for(let y=a+l-1;y>=a;y--){m.push(u("span",{class:"pursuer"},y));for(let g=i;g<i+c;g++)m.push(gl(t,y,g,n))}let d=Array.from({length:c},(y,g)=>u("\
span",{class:"evader"},i+g)),p=u("button",{type:"button","aria-label":"Close: all cells",onclick:()=>n(null)},"✕"),f=u("div",{class:"loupe numbers",role:"grou\
p","aria-label":"Cells around the tap",onclick:y=>y.stopPropagation()},...m,p,...d);return f.style.gridTemplateColumns=`2.4rem repeat(${c}, minmax(0, 1fr))`,f}function gl(t,e,r,n){
let o=u("button",{type:"button",onclick:()=>n({pursuer:e,evader:r})});return Ft(o,Me(t,e,r)?.rate,`${W(t,"pursuer",e)} against ${W(t,"evader",r)}`),o}var Ns=(t,e)=>Math.
max(0,Math.min(e-tr,t-Math.floor(tr/2)));var ae={left:52,bottom:46,top:76,right:84},he=10,vl=160,bt=ae.right-he-14,$e=ae.top-he-14,rr=class{element;#e;#r;#t=u("canvas",{"aria-hidden":"true"});#n=x("svg",
{"aria-hidden":"true"});#i=x("g");#s;#u=u("h2");#f=u("strong",{class:"rate numbers"});#h=u("span",{class:"small muted"});#m=u("p",{class:"of-both-teams small mu\
ted numbers"});#d;#c=null;constructor(e,r){[this.#r,this.#e]=[e,r],this.#s=u("div",{class:"matrix",id:"matrix","aria-label":"Payoff matrix. Arrow keys choose a \
match, Enter plays it.",onpointermove:o=>this.#w(o),onpointerleave:()=>r.point({}),onclick:o=>this.#x(o),onkeydown:({key:o})=>o==="Enter"&&this.#M()},this.#t,this.#n);
let n=u("header",{class:"readout","aria-live":"polite"},u("div",{},this.#u,this.#m),u("div",{class:"of-cell"},this.#f,this.#h));this.#d=pt(...C(this.#a).ends),this.
element=u("section",{class:"card matrix-card","aria-label":"Payoff matrix"},n,this.#s,this.#d),this.#g(),new ResizeObserver(()=>this.#l()).observe(this.#s),this.#s.
addEventListener("mousedown",o=>{o.preventDefault(),document.activeElement instanceof HTMLElement&&document.activeElement.blur()}),Re(this.#s,r,()=>this.#a.payoff.
shape),r.on("run",()=>{let o=pt(...C(this.#a).ends);this.#d.replaceWith(o),this.#d=o,this.#l()}),r.on("match hover",()=>this.#y())}get#a(){return this.#r[this.#e.
selected.run]}#l(){let[e,r]=this.#a.payoff.shape,{clientWidth:n,clientHeight:o}=this.#s;if(n<50)return;let a=Math.max(vl,Math.min(n-ae.left-ae.right,o-ae.top-ae.
bottom))/Math.max(e,r),i=Math.max(ae.left,(n-r*a-ae.right+ae.left)/2),l=ae.top+Math.max(0,(o-ae.top-ae.bottom-e*a)/2),c={width:n,height:o,left:i,top:l,cell:a,rows:e,
columns:r};this.#c=c,Ut(this.#t,this.#a.payoff,{left:i,top:l,width:r*a,height:e*a});for(let[m,d,p]of[["left",i,n],["top",l,o],["width",r*a,n],["height",e*a,o]])
this.#t.style.setProperty(m,`${100*d/p}%`);this.#s.style.setProperty("--shape",`${n} / ${o}`),this.#n.setAttribute("viewBox",`0 0 ${n} ${o}`),this.#n.replaceChildren(
bl(c,C(this.#a).generation),...wl(c),...this.#p(c),this.#i),this.#y()}#o(e){let r=this.#a.findings?.generalization;if(!r)return[];let{selected:n,hover:o}=this.#e,
[s,a]=[o.pursuer??n.pursuer,o.evader??n.evader],[i,l]=Ws(e,r.pursuers.mean[s]??0,s),[c,m]=Us(e,r.evaders.mean[a]??0,a);return[x("circle",{class:"dot of-pursuers",
cx:i,cy:l,r:5}),x("circle",{class:"dot of-evaders",cx:c,cy:m,r:5})]}#p(e){let r=this.#a.findings?.generalization;if(!r)return[];let{left:n,top:o,cell:s,rows:a,columns:i}=e,
{curves:l}=C(this.#a),[c,m]=[n+i*s+he,o-he],d={class:"side"};return[x("rect",{...d,x:c,y:o,width:bt,height:a*s}),x("rect",{...d,x:n,y:m-$e,width:i*s,height:$e}),
...Fs(r.pursuers,(p,h)=>Ws(e,p,h),"of-pursuers"),...Fs(r.evaders,(p,h)=>Us(e,p,h),"of-evaders"),x("text",{class:"tick",x:c,y:o+a*s+16,"text-anchor":"start"},"0"),
x("text",{class:"tick",x:c+bt,y:o+a*s+16,"text-anchor":"end"},"1"),x("text",{class:"tick",x:n-6,y:m-4,"text-anchor":"end"},"0"),x("text",{class:"tick",x:n-6,y:m-
$e+8,"text-anchor":"end"},"1"),x("text",{class:"label of-pursuers",x:c+bt,y:o+a*s+34,"text-anchor":"end"},l.pursuer),x("text",{class:"label of-evaders",x:n+i*s+
he,y:m-$e+10,"text-anchor":"start"},l.evader)]}#y(){let e=this.#c;if(!e)return;let{selected:r,hover:n}=this.#e,{left:o,top:s,cell:a,rows:i,columns:l}=e,c=f=>s+(i-
1-f)*a,m=[],d=(f,y)=>x("rect",{class:y,x:o,y:c(f),width:l*a+he+bt,height:a}),p=(f,y)=>x("rect",{class:y,x:o+f*a,y:s-he-$e,width:a,height:he+$e+i*a});m.push(d(r.
pursuer,"strip pursuer"),p(r.evader,"strip evader")),n.pursuer!==null&&n.pursuer<i&&m.push(d(n.pursuer,"strip hover")),n.evader!==null&&n.evader<l&&m.push(p(n.evader,
"strip hover")),m.push(...this.#o(e));let h={x:o+r.evader*a,y:c(r.pursuer),width:a,height:a};m.push(x("rect",{class:"chosen under",...h}),x("rect",{class:"chose\
n",...h})),this.#i.replaceChildren(...m),this.#g()}#g(){let{selected:e,hover:r}=this.#e,n=r.pursuer??e.pursuer,o=r.evader??e.evader,s=Me(this.#a,n,o);this.#u.replaceChildren(
u("span",{class:"pursuer"},pe(W(this.#a,"pursuer",n)))," against ",u("span",{class:"evader"},W(this.#a,"evader",o))),this.#f.textContent=s?L(s.rate,3):"-";let a=s&&
s.rates.length>1?`, mean of ${s.rates.length} episodes`:"";this.#h.textContent=s?C(this.#a).score+a:"no episodes were played",this.#m.textContent=this.#v(n,o)}#v(e,r){
let n=this.#a.findings?.generalization;if(!n)return"";let o=(a,i)=>lo(a.mean[i]??null,a.low?.[i]??null,a.high?.[i]??null),{means:s}=C(this.#a);return`Against al\
l: ${s.pursuer} ${o(n.pursuers,e)}, ${s.evader} ${o(n.evaders,r)}`}#b(e){let r=this.#c;if(!r)return null;let n=this.#s.getBoundingClientRect(),o=Math.floor((e.clientX-
n.left-r.left)/r.cell),s=r.rows-1-Math.floor((e.clientY-n.top-r.top)/r.cell),[a,i]=[s>=0&&s<r.rows,o>=0&&o<r.columns];return a||i?{g:a?s:-1,h:i?o:-1,inside:a&&i}:
null}#w(e){let r=this.#b(e);this.#e.point(r?{pursuer:r.g<0?null:r.g,evader:r.h<0?null:r.h}:{})}#x(e){let r=this.#b(e);if(r){if(r.inside&&Ls(this.#c.cell))return this.#S(
r.g,r.h);this.#e.select({...r.g<0?{}:{pursuer:r.g},...r.h<0?{}:{evader:r.h}}),r.inside&&this.#M()}}#S(e,r){let n=Is(this.#a,e,r,o=>{n.remove(),o&&(this.#e.select(
o),this.#M())});this.#s.append(n)}#M(){this.#s.dispatchEvent(new CustomEvent("play",{bubbles:!0}))}};function bl({left:t,top:e,cell:r,rows:n,columns:o},s){let a=x(
"g",{class:"axes"}),i=e+n*r,l=c=>ut(0,c-1,Math.min(c,c*r/44),!0);for(let c of l(o))a.append(x("text",{class:"tick",x:t+(c+.5)*r,y:i+16,"text-anchor":"middle"},c));
for(let c of l(n))a.append(x("text",{class:"tick",x:t-7,y:i-(c+.5)*r,"text-anchor":"end","dominant-baseline":"middle"},c));return a.append(x("text",{class:"labe\
l of-evaders",x:t+o*r/2,y:i+36,"text-anchor":"middle"},s.evader),x("text",{class:"label of-pursuers",transform:`translate(${t-36} ${e+n*r/2}) rotate(-90)`,"text\
-anchor":"middle"},s.pursuer)),a}function wl({left:t,top:e,cell:r,rows:n,columns:o}){let s=x("g",{class:"diagonal"}),a=Math.min(n,o);if(a<3)return[];let i=e+n*r;
for(let m of["H","V"]){let d=`M${t} ${i}`;for(let p=1;p<=a;p++){let[h,f]=[`H${t+p*r}`,`V${i-p*r}`];d+=m==="H"?h+f:f+h}s.append(x("path",{d,class:"under"}),x("pa\
th",{d}))}let[l,c]=[t+a/2*r-.7*r-4,i-a/2*r-.7*r-4];return[s,x("text",{class:"on-cells",transform:`translate(${l} ${c}) rotate(-45)`,"text-anchor":"middle"},"sam\
e generation")]}var Ws=({left:t,top:e,cell:r,rows:n,columns:o},s,a)=>[t+o*r+he+s*bt,e+(n-a-.5)*r],Us=({left:t,top:e,cell:r},n,o)=>[t+(o+.5)*r,e-he-n*$e];function Fs(t,e,r){
let n=s=>s.map((a,i)=>e(a??0,i).map(l=>l.toFixed(1)).join(" ")),o=[];return t.low&&t.high&&o.push(x("path",{class:`band ${r}`,d:`M${[...n(t.high),...n(t.low).reverse()].
join("L")}Z`})),o.push(x("path",{class:`line ${r}`,d:`M${n(t.mean).join("L")}`})),o}function ce(t,e,...r){return u("section",{class:"card panel","aria-label":t},u("header",{},u("h2",{},t),u("p",{class:"small muted"},e)),...r)}var xl={present:"●",
absent:"○","cannot tell":"?"};function Ds(t){let{findings:e}=t;if(!e?.table.length)return null;let[,...r]=e.table,n=r.map(([s,a,i,l],c)=>{let m=Sl(e.reasons[c]??
"");return u("li",{class:`finding ${a.replace(" ","-")}`},u("span",{class:"sign","aria-hidden":"true"},xl[a]??""),u("div",{},u("p",{},u("strong",{},s),` ${a}`,u(
"span",{class:"muted"},` · ${l}`)),m?u("p",{class:"small"},`${m}.`):null,u("p",{class:"small muted numbers"},i)))}),o=ce("What happened","Each condition is pre\
sent, absent, or its 95 % interval cannot tell. The intervals are about this run.",u("p",{class:"headline"},e.sentence),u("ul",{class:"findings"},...n),t.limits?
u("p",{class:"small"},t.limits):null);return o.classList.add("diagnosis"),{element:o}}function Sl(t){let[,e=""]=t.split(/, because (.*)/s);return pe(e.replace(/\.$/,
""))}function zs({settings:t,command:e}){let r=t.map(({name:s,value:a,help:i})=>u("tr",{},u("th",{scope:"row"},u("code",{},`--set ${s}=${a}`)),u("td",{class:"mu\
ted"},i))),n=u("table",{class:"small"},u("caption",{class:"heard"},"Settings other than the default"),...r),o=ce("Settings","All others are the defaults. This c\
ommand plays the race again:",u("pre",{class:"command"},e),r.length?u("div",{class:"wide-table"},n):null);return o.classList.add("settings"),{element:o}}function Bs(t,e,r){let{findings:n}=t,{teams:o,click:s}=C(t);if(!n?.table.length)return null;let a=n.checkerboards.map(i=>Ml(t,i,(l,c)=>{e.select({pursuer:l,evader:c}),
r()}));return{element:ce("Checkerboards",`Two generations of each team: each generation of the ${o.pursuer} is better against another one of the ${o.evader}. Cl\
ick a cell to ${s}.`,a.length?u("div",{class:"boards"},...a):u("p",{},`No four cells differ by more than ${n.margin} in this way.`),a.length&&!t.game?.exact?u("\
p",{class:"small muted"},"The strongest of all pairs, so noise makes them look stronger than they are. The diagnosis says whether there are more than noise make\
s."):null)}}function Ml(t,{pursuers:e,evaders:r},n){let o=(s,a)=>{let i=u("button",{type:"button",class:"cell",onclick:()=>n(s,a)});return Ft(i,t.payoff.capture_rate[s][a],
`${W(t,"pursuer",s)} against ${W(t,"evader",a)}`),i};return u("div",{class:"miniature numbers"},u("span"),...r.map(s=>u("span",{class:"evader"},s)),...e.flatMap(
s=>[u("span",{class:"pursuer"},s),...r.map(a=>o(s,a))]))}var nr={pursuer:"evader",evader:"pursuer"};function Hs(t,e){let r=t.findings?.ciao;if(!r)return null;let n=["pursuer","evader"].map(o=>{let{fading:s,stripes:a,period:i}=r[`${o}\
s`],l=`fading ${L(s)}, stripes ${L(a)}${i===null?"":` every ${i} generations`}`;return Al(t,o,l,e)});return{element:ce("CIAO: current individuals against ancest\
ral opponents","The team's own score. Stripes: intransitive, since wins and losses alternate with the age of the opponent; whether a team returns to earlier str\
ategies is recurrence, under What happened. Darker away from the diagonal: forgetting.",u("div",{class:"triangles"},...n.map(o=>o.element)),pt("0 loses","1 wins")),
update:()=>n.forEach(o=>o.update())}}function Al(t,e,r,n){let o=e==="pursuer"?0:1,s=C(t),[a,i]=[t.payoff.shape[o],t.payoff.shape[1-o]],l=t.payoff.capture_rate,c=Array.
from({length:a},(w,v)=>Array.from({length:Math.min(v+1,i)},(S,T)=>e==="pursuer"?l[v][T]:1-l[T][v])),m=Wr({shape:[a,i],first:[0,0],capture_rate:c}),d=x("rect",{class:"\
chosen",width:1,height:1}),p=x("rect",{class:"chosen under",width:1,height:1}),h=x("svg",{viewBox:`0 0 ${i} ${a}`,preserveAspectRatio:"none","aria-hidden":"true"},
p,d),f=u("div",{class:"triangle","aria-label":`CIAO of the ${s.teams[e]}: ${r}. Arrow keys choose a match.`,onpointermove:w=>n.point(y(w)??{}),onpointerleave:()=>n.
point({}),onclick:w=>y(w)&&n.select(y(w))},m,h);Re(f,n,()=>t.payoff.shape,e),f.style.aspectRatio=`${i} / ${a}`;let y=w=>{let v=f.getBoundingClientRect(),S=Math.
floor((w.clientX-v.left)/v.width*i),T=a-1-Math.floor((w.clientY-v.top)/v.height*a);return S>=0&&T<a&&S<=T?{[e]:T,[nr[e]]:S}:null},g=()=>{let w=n.hover[e]??n.selected[e],
v=n.hover[nr[e]]??n.selected[nr[e]];for(let S of[d,p])S.setAttribute("x",String(v)),S.setAttribute("y",String(a-1-w)),S.style.display=v<=w?"":"none"};return{element:u(
"figure",{},u("figcaption",{class:"small"},u("span",{class:e},s.teams[e])),f,u("p",{class:"small muted"},`horizontal: ${s.generation[nr[e]]}; vertical: ${s.generation[e]}`),
u("p",{class:"small numbers"},r)),update:g}}var Jr={right:12,top:10,bottom:42},or={x:56,y:34,letter:8,label:30};function Qr(t,e,r,n){let{top:o}=Jr,s=Math.max(o+40,e-Jr.bottom),a=ut(n.low,n.high,(s-o)/or.y,
n.whole),i=or.label+or.letter*Math.max(2,...a.map(g=>Xr(g).length)),l=Math.max(i+40,t-Jr.right),c=(g,b,w)=>v=>b+(v-g.low)/(g.high-g.low||1)*(w-b),[m,d]=[c(r,i,l),
c(n,s,o)],p=x("g"),h=x("svg",{width:t,height:e,viewBox:`0 0 ${t} ${e}`,class:"plot"}),f=x("g",{class:"axes"});for(let g of a)f.append(x("line",{x1:i,x2:l,y1:d(g),
y2:d(g),class:"grid"}),x("text",{x:i-8,y:d(g),"text-anchor":"end","dominant-baseline":"middle"},Xr(g)));for(let g of ut(r.low,r.high,(l-i)/or.x,r.whole))f.append(
x("text",{x:m(g),y:s+16,"text-anchor":"middle"},Xr(g)));return f.append(x("line",{x1:i,x2:l,y1:s,y2:s,class:"axis"}),x("text",{x:(i+l)/2,y:e-6,"text-anchor":"mi\
ddle",class:"label"},r.label),x("text",{transform:`translate(12 ${(o+s)/2}) rotate(-90)`,"text-anchor":"middle",class:"label"},n.label)),h.append(f,p),{root:h,marks:p,
left:i,right:l,top:o,bottom:s,x:m,y:d,at:g=>{let b=g-h.getBoundingClientRect().left;return r.low+(b-i)/(l-i)*(r.high-r.low)}}}var Xr=t=>String(Number(t.toPrecision(
6))).replace("-","−");function en(t,e,r,n){let o="",s="M";r.forEach((a,i)=>{a===null?s="M":(o+=`${s}${t.x(e[i]).toFixed(1)} ${t.y(a).toFixed(1)}`,s="L")}),t.root.
insertBefore(x("path",{d:o,class:`line ${n}`}),t.marks)}function Gs(t,{low:e,high:r},n){if(!e||!r)return;let o=s=>s.map((a,i)=>`${t.x(i).toFixed(1)} ${t.y(a??0).
toFixed(1)}`);t.root.insertBefore(x("path",{d:`M${[...o(r),...o(e).reverse()].join("L")}Z`,class:`band ${n}`}),t.marks)}function tn(t,e,r,n=null){let o=t.x(e);t.
marks.append(x("line",{x1:o,x2:o,y1:t.top,y2:t.bottom,class:`mark ${r}`})),n!==null&&t.marks.append(x("circle",{cx:o,cy:t.y(n),r:5,class:`dot ${r}`}))}function rn(...t){
return u("p",{class:"legend small"},...t.map(([e,r])=>u("span",{class:`key ${r}`},e)))}function nn(t,e,r,n){let o=u("div",{class:"chart chooses",role:"img","ari\
a-label":t}),s=null,a=()=>{s?.marks.replaceChildren(),s&&r(s)};o.addEventListener("click",l=>s&&n(s.at(l.clientX),s,l));let i=()=>{let{clientWidth:l,clientHeight:c}=o;
l<50||c<50||(s=e(l,c),o.replaceChildren(s.root),a())};return new ResizeObserver(i).observe(o),{element:o,update:a,redraw:i}}var on=["of-pursuers","of-evaders","of-both"],Tl=2500,js="Arrow keys choose generations.";function Vs(t,e){let{training:r}=t,{score:n,teams:o}=C(t),{capture_rate:s,
generation:a,learner:i,epochs:l}=r,c=s.map((g,b)=>(b+1)*l),m=El(s,r.window),d=c.at(-1)??1,p=c.length>Tl?"dense":"",h=(g,b)=>{let w=a.flatMap((v,S)=>v===g&&(i[S]===
b||i[S]===2)?[S]:[]);return w.length?[c[w[0]],c[w.at(-1)]]:null},f=nn(`${pe(n)} in ${d} epochs of training. ${js}`,(g,b)=>{let w=Qr(g,b,{low:0,high:d,label:"epo\
ch",whole:!0},{low:0,high:1,label:n});for(let[v,S]of[["raw",s],[p,m]])for(let[T,_]of on.entries()){let k=S.map((A,M)=>i[M]===T||i[M+1]===T?A:null);k.some(A=>A!==
null)&&en(w,c,k,`${_} ${v}`)}return w},g=>H.forEach((b,w)=>{let v=h(e.hover[b]??e.selected[b],w);v&&tn(g,(v[0]+v[1])/2,on[w])}),g=>{let b=Math.min(c.length-1,Math.
max(0,Math.round(g/l)-1)),w=a[b];i[b]!==1&&e.select({pursuer:Math.min(w,t.payoff.shape[0]-1)}),i[b]!==0&&e.select({evader:Math.min(w,t.payoff.shape[1]-1)})});Re(
f.element,e,()=>t.payoff.shape);let y=[...new Set(i)].sort().map(g=>[`${[o.pursuer,o.evader,"both teams"][g]} learn`,on[g]]);return{element:ce("Training",`${co(
r.matches)} training matches. Lines: the generations that are selected.`,rn(...y),f.element),update:f.update}}function Ks(t,e){let r=t.findings?.ratings;if(!r)return null;
let n={pursuer:r.pursuers,evader:r.evaders},o={pursuer:n.pursuer.mean,evader:n.evader.mean},s=H.flatMap(p=>[n[p].mean,n[p].low??[],n[p].high??[]]).flat().map(p=>p??
0),[a,i]=[Math.min(...s),Math.max(...s)],l=.06*(i-a||1),c=Math.max(...t.payoff.shape)-1,{teams:m}=C(t),d=nn(`Elo ratings by generation. ${js}`,(p,h)=>{let f=Qr(
p,h,{low:0,high:c,label:"generation",whole:!0},{low:a-l,high:i+l,label:"Elo points"});for(let y of H)Gs(f,n[y],`of-${y}s`),en(f,o[y].map((g,b)=>b),o[y],`of-${y}\
s`);return f},p=>{for(let h of H){let f=e.hover[h]??e.selected[h];tn(p,f,`of-${h}s`,o[h][f]??null)}},(p,h,f)=>{let y=Math.round(p),g=f.clientY-h.root.getBoundingClientRect().
top,b=v=>Math.abs(h.y(o[v][y]??1/0)-g),w=b("pursuer")<=b("evader")?"pursuer":"evader";y>=0&&y<o[w].length&&e.select({[w]:y})});return Re(d.element,e,()=>t.payoff.
shape),{element:ce("Ratings",`One number for each generation, which cycles do not fit${n.pursuer.low?", with 95 % intervals over episodes":""}. The game itself:\
 ${L(r.offset,0)} points for the ${m.pursuer}.`,rn([m.pursuer,"of-pursuers"],[m.evader,"of-evaders"]),d.element),update:d.update}}function El(t,e){let r=[0];for(let n of t)
r.push(r.at(-1)+n);return t.map((n,o)=>{let[s,a]=[Math.max(0,o-Math.floor((e-1)/2)),Math.min(t.length,o+Math.floor(e/2)+1)];return(r[a]-r[s])/(a-s)})}function Ys(t,e){if(H.every(n=>!t.teams[n].words&&!Ot(t,n)))return null;let r=u("div",{class:"evolved"});return{element:ce("What evolved","Each move is rated by\
 named inputs of the cell that it leads to, and the best one is taken.",r),update:()=>r.replaceChildren(...H.map(n=>Cl(t,n,e.selected[n])))}}function Cl(t,e,r){
let{words:n,kept:o}=t.teams[e],s=De(t,e,r),a=t.teams[e].script??W(t,e,r);return u("section",{"aria-label":C(t).teams[e]},u("h3",{class:e},pe(a)),n&&r===o.at(-1)?
u("p",{},n):null,s?u("p",{class:"small muted"},s):kl(e,Z(t,e,r),Pt(t,e,r)))}function kl(t,e,r){if(typeof e=="string"||e.kind==="cells")return null;if(e.kind==="\
program")return u("p",{},u("code",{},r));if(e.hidden.length)return u("p",{class:"small muted"},`A network with ${e.hidden.join(" and ")} hidden units rates each\
 move by ${e.inputs.length} inputs.`);let n=Math.max(...e.genome.map(Math.abs))||1;return u("div",{class:"weights"},...e.inputs.flatMap((o,s)=>{let a=e.genome[s],
i=u("span",{class:`bar ${t}${a<0?" below":""}`});return i.style.width=`${50*Math.abs(a)/n}%`,[u("span",{title:Le[o]},o.replaceAll("_"," ")),u("span",{class:"axi\
s"},i),u("span",{class:"numbers"},ct(a))]}))}function qs(t,e,r){let n=new Map,o=u("div",{class:"panels"}),s=[],a=()=>s.forEach(l=>l.update?.()),i=()=>{let l=t[e.selected.run];s=n.get(l)??Rl(l,e,r),n.set(l,
s),o.replaceChildren(...s.map(c=>c.element)),a()};return e.on("run",i),e.on("match hover",a),i(),o}function Rl(t,e,r){return[Ds(t),Ys(t,e),Vs(t,e),Bs(t,e,r),Ks(
t,e),Hs(t,e),zs(t)].filter(o=>o!==null)}var Zs={pursuer:null,evader:null},sr=class extends EventTarget{#e;#r=Zs;constructor(e){super(),this.#e=e}get selected(){return this.#e}get hover(){return this.#r}select(e){
let r=this.#e,n=["run","pursuer","evader"].some(o=>o in e&&e[o]!==r[o]);this.#e={...r,...n?{episode:0,seed:null}:{},...e},this.#e.run!==r.run&&this.dispatchEvent(
new Event("run")),this.dispatchEvent(new Event("match"))}point(e){let r={...Zs,...e};r.pursuer===this.#r.pursuer&&r.evader===this.#r.evader||(this.#r=r,this.dispatchEvent(
new Event("hover")))}on(e,r){for(let n of e.split(" "))this.addEventListener(n,r)}};var ar=class{config;start;recording;actions=[];#e;#r;#t=[[]];constructor(e,r,n){[this.config,this.start]=[r,n],this.#e=e.world(r),this.#e.reset(n),this.#r=[jr(this.#e)],
this.recording=Gr(r,this.#e.map(),this.#r)}get length(){return this.actions.length}get over(){return this.#e.over}get statistics(){return{capture_rate:this.#e.read(
"capture_rate")[0]}}conflicts(e){return this.#t[e]}game(e){return e.game(this.#e)}play(e){this.#e.step(e),this.#n(e)}step(e,r,n){let[o,s]=[this.#e,this.config.n_pursuers],
a=new Uint8Array(o.n_agents);for(let i=o.n_turns;i>0&&!o.over;--i){let[l,c]=o.actors;l<s&&(a=o.decide(e.pursuer,[l,Math.min(c,s)],a)),c>s&&(a=o.decide(e.evader,
[Math.max(l,s),c],a)),typeof n=="number"?a[r]=n:l<=r&&r<c&&(a=o.decide(n,[r,r+1],a)),o.playTurn(a)}this.#n(a)}#n(e){this.actions.push(e),this.#r.push(jr(this.#e,
e)),this.#t.push(this.#e.conflicts())}};var fe=(t,e)=>H[+(e>=t.n_pursuers)];function sn(t,e){let r=new ar(t,e.config,{seed:e.seed,episode:e.episode});for(let n of e.moves)r.over||r.step(e.policies,e.seat,
n);return r}function Oe(t,e){let{moments:r,nPursuers:n}=t.recording,o=r.findIndex(({alive:a,captured:i})=>!a[e]||!!i[e-n]),s=o<0?t.length:o;return{lasted:s,out:o>=
0,captured:Array.from(r[s].everCaptured).filter(Boolean).length}}var ir=(t,e)=>t.over||Oe(t,e).out;function Js(t,e,r){let n=sn(t,{...e,moves:e.moves.slice(0,e.from)});
for(;!ir(n,e.seat);)n.step(e.policies,e.seat,r);return Oe(n,e.seat)}function Xs(t){let e=t.length-1;return[...new Set([0,Math.round(e/3),e])].map(r=>t[r])}function Qs(t,{
seat:e,from:r,moves:n}){let o={...t,seat:e,...r?{from:r}:{},moves:n.join("")};return`${location.href.split("#")[0]}#${Object.entries(o).map(([s,a])=>`${s}=${a}`).
join("&")}`}function ea(t,e){let[r,n,o]=[t.get("seat")??"",t.get("from")??"0",t.get("moves")??""];return/^\d{1,6}$/.test(r)&&Number(r)<e.n_pursuers+e.n_evaders&&
(e.diagonal?/^[0-8]+$/:/^[0-4]+$/).test(o)&&o.length<=e.max_steps&&/^\d{1,6}$/.test(n)&&Number(n)<=o.length?{seat:Number(r),from:Number(n),moves:[...o].map(Number)}:
null}function an(t,e,r,n){let{players:o,told:s,...a}=n;e.play({...a,played:r,ending:(i,l)=>[s?u("p",{},s(Oe(i,r.seat))):"",$l(t,i,l,Xs(o))],again:()=>an(t,e,{...r,moves:r.
moves.slice(0,r.from)},n)})}function $l(t,e,r,n){let o=fe(r.config,r.seat)==="evader",s=o?r.config.max_steps:r.config.n_evaders,a=u("table",{class:"numbers"},u(
"caption",{},o?"Steps in your seat: same start, same others":"Captures of your team: same start, same others")),i=c=>{let[m,d]=[u("span",{class:o?"bar evader":"\
bar pursuer"}),u("td",{},"…")];return a.append(u("tr",{},u("th",{scope:"row"},c),u("td",{class:"track","aria-hidden":"true"},m),d)),({lasted:p,captured:h})=>{
m.style.width=`${100*(o?p:h)/s}%`,d.textContent=String(o?p:h)}};i("You")(Oe(e,r.seat));for(let{name:c,policy:m}of n){let d=i(c);setTimeout(()=>d(Js(t,r,m())))}let l=r.
from?`You took over at step ${r.from}. `:"";return u("div",{},a,u("p",{class:"small muted"},`${l}One match: luck has its part in it.`))}var ta=["·","↑","→","↓","←","↗","↘","↙","↖"];var Ol={" ":0,ArrowUp:1,w:1,ArrowRight:2,d:2,ArrowDown:3,s:3,ArrowLeft:4,a:4,e:5,c:6,y:7,z:7,q:8},ln=[8,1,5,4,0,2,7,3,6],Pl=[7,8,9,4,5,6,1,2,3],_l=24,Nl=Math.tan(
Math.PI/8);function na(t,e){if(t.ctrlKey||t.metaKey||t.altKey)return;let r=Pl.findIndex(o=>t.code===`Numpad${o}`),n=ln[r]??Ol[t.key.length===1?t.key.toLowerCase():
t.key];return n!==void 0&&n>4&&!e?void 0:n}function oa(t){let e=ln.map(r=>u("button",{type:"button","aria-label":ne[r],onclick:()=>t(r)},ta[r]));return{element:u(
"div",{class:"play-pad",role:"group","aria-label":"Your move"},...e),show:r=>e.forEach((n,o)=>n.classList.toggle("absent",ln[o]>4&&!r))}}function ra(t,e,r){let n=Nl*
Math.max(Math.abs(t),Math.abs(e)),o=s=>Math.abs(s)<n?0:s;return Eo([0,0],r?[o(t),o(e)]:[t,e],r)}function sa(t,e,r){let n=null,{canvas:o}=t;o.addEventListener("p\
ointerdown",({button:s,clientX:a,clientY:i})=>n=s===0?[a,i]:null),o.addEventListener("pointercancel",()=>n=null),o.addEventListener("pointerup",({clientX:s,clientY:a})=>{
let[i,l]=[n,e()];if(n=null,!i||!l)return;let[c,m]=[s-i[0],a-i[1]],d=t.cellAt(s,a);Math.hypot(c,m)>=_l?r(ra(m,c,l.diagonal)):d&&r(ra(d[0]-l.cell[0],d[1]-l.cell[1],
l.diagonal))})}function aa(t,e){let r=n=>{let o=e[n]-t[n],s=He.findIndex(a=>a[n]===Math.sign(o)&&a[1-n]===0);return o?`${Math.abs(o)} ${ne[s]}`:""};return[r(0),
r(1)].filter(Boolean).join(", ")||"on your cell"}var ca="NUMPY\0",ia=ca.length+2,la=64;function ua(t){return io(Object.fromEntries(Object.entries(t).map(([e,r])=>[`${e}.npy`,Ll(r)])))}function Ll({dtype:t,shape:e,
data:r}){let n=typeof r=="string"?Array.from(r,m=>m.codePointAt(0)):null,o=e.map(m=>`${m}, `).join(""),s=`{'descr': '${n?`<U${n.length}`:t}', 'fortran_order': F\
alse, 'shape': (${o}), }`,a=Math.ceil((ia+s.length+1)/la)*la-ia,i=ca+String.fromCharCode(a&255,a>>8)+s.padEnd(a-1)+`
`,l=n?Int32Array.from(n):r,c=new Uint8Array(i.length+l.byteLength);return c.set(kt(i,!0)),c.set(new Uint8Array(l.buffer,l.byteOffset,l.byteLength),i.length),c}var Il="matrixworld episode 3";function ma(t,e,r){let{config:n,actions:o,length:s,recording:a}=e,[i,l]=[n.n_pursuers+n.n_evaders,n.n_evaders],c={positions:["<i4",
i,2],last_positions:["<i4",i,2],alive:["|b1",i],captured:["|b1",l],ever_captured:["|b1",l]},m={rewards:["<f4",i],involved:["|b1",i,3],fault:["|b1",i,3]},d={},p=v=>{
for(let S of Object.keys(v))(d[S]??=[]).push(Array.from(h.read(S),Number))},h=t.world(n);h.reset(e.start);let f=[];p(c);for(let v of o)h.step(v),p({...c,...m}),
f.push(...h.conflictTable());h.free();let y={"<i4":Int32Array,"<f4":Float32Array,"|b1":Uint8Array},g={};for(let[v,[S,...T]]of Object.entries({...c,...m})){let _=s+
+(v in c);g[v]={dtype:S,shape:[_,...T],data:y[S].from((d[v]??[]).flat())}}let b=v=>({dtype:"<i8",shape:[],data:Int32Array.of(v,0)}),w=v=>({dtype:"<U",shape:[],data:v});
return ua({format:w(Il),n_pursuers:b(n.n_pursuers),config:w(JSON.stringify(n)),seat:b(r),...g,actions:{dtype:"|i1",shape:[s,i],data:Int8Array.from(o.flatMap(v=>[
...v]))},map:{dtype:"|b1",shape:[n.rows,n.cols],data:Uint8Array.from(a.obstacles,Number)},conflict_table:{dtype:"<i4",shape:[f.length/11,11],data:Int32Array.from(
f)}})}var Wl=[0,1,2,4,8],lr=class{element;player=new ze(0,{speed:4,still:Ke()});#e;#r;#t=u("canvas",{tabindex:0,"aria-describedby":"play-keys"});#n=u("h2");#i=u("p",{
class:"play-told",role:"status"});#s=oa(e=>this.act(e));#u=Un(Wl.map(e=>[e,e?`${e} / s`:"step by step"]),()=>this.#E());#f=u("input",{type:"checkbox",onchange:()=>this.#S()});#h=u(
"input",{type:"checkbox",onchange:()=>this.#C()});#m=u("label",{class:"play-choice"},this.#h,"Best move");#d=u("p",{class:"small muted play-keys",id:"play-keys"});#c=u(
"section",{class:"play-ending",tabindex:-1,"aria-labelledby":"play-headline"});#a=Kt(this.player);#l=null;#o=null;#p=[];#y=null;#g=null;#v=[];#b=0;#w=0;constructor(e){
this.#e=e,this.#r=new Ve(this.#t,{numbers:!1}),this.#t.setAttribute("role","application"),sa(this.#r,()=>{let r=this.#y!==null&&this.#o&&R(this.#o.recording.moments.
at(-1),this.#y);return r?{cell:r,diagonal:this.#o.config.diagonal}:null},r=>this.act(r)),this.player.addEventListener("frame",()=>this.#o&&this.#r.show(this.#o.
recording,this.player.time)),this.player.addEventListener("step",()=>this.#C()),this.element=u("div",{class:"play"},u("header",{class:"play-head"},this.#n,this.#i),
u("div",{class:"play-stage"},this.#t),u("div",{class:"play-side"},this.#c,this.#s.element,u("label",{class:"play-choice",title:"Steps a second"},"Pace ",this.#u),
u("label",{class:"play-choice"},this.#f,u("span",{},"Fog",u("span",{class:"at-length"},": see only what it sees"))),this.#m,this.#d),this.#a)}get played(){return this.#l&&
{...this.#l.played,moves:this.#p}}get live(){return this.#o}play(e){this.#x(sn(this.#e,e.played),e.played.seat,e.title),[this.#l,this.#p,this.#b]=[e,[...e.played.
moves],0],this.element.dataset.state="playing",this.#t.focus({preventScroll:!0}),ir(this.#o,e.played.seat)&&this.#R()}watch(e,r,n){this.#l=null,this.#x(e,r,n),this.#$()}stop(){
this.#E(),this.player.pause(),this.#l=null}act(e){let[r,n]=[this.#l,this.#o];if(!r||!n||this.element.dataset.state!=="playing")return;this.#b=e;let o=Number(this.#u.
value);this.#w||(this.#k(),o&&this.element.dataset.state==="playing"&&(this.#w=setInterval(()=>this.#k(),1e3/o)))}key(e){let{target:r,key:n}=e;if(r instanceof HTMLSelectElement||
r instanceof HTMLInputElement&&(r.type==="text"||n===" ")||r instanceof HTMLButtonElement&&(n===" "||n==="Enter")||!this.#o)return!1;if(this.element.dataset.state!==
"playing")return Be(this.player,e);let s=na(e,this.#o.config.diagonal);return s!==void 0&&this.act(s),s!==void 0}#x(e,r,n){this.#E(),this.player.pause(),[this.#o,
this.#y]=[e,r],this.#n.textContent=n,this.#t.ariaLabel=`Board, ${e.config.rows} by ${e.config.cols} cells`,this.#s.show(e.config.diagonal),this.#d.replaceChildren(
u("span",{class:"at-length"},`W A S D or the arrow keys move, Space stays${e.config.diagonal?"; Q E Z C and the numeric keypad move diagonally":""}. `),"On the \
board: swipe, or tap where to go."),this.#M(e),this.#c.replaceChildren(),this.player.length=e.length,this.player.jump(e.length),this.#C()}#S(){this.#r.look={you:this.#y,
fog:this.#f.checked,viewers:this.#y===null?[]:[this.#y],plan:this.#O()}}#M(e){this.#g=null,this.#v=this.player.ticks=[],this.#m.hidden=this.#h.disabled=!!Ct(e.config),
Zt(this.#e,e.config,ks(e.config)).then(r=>{this.#o===e&&(this.#g=r,this.#T(),this.#C())})}#T(){let[e,r]=[this.#o,this.#g];if(!r||this.element.dataset.state==="p\
laying")return;let n=this.#e.world(e.config);n.reset(e.start),this.#v=Jt(r,n,e.actions),n.free(),this.player.ticks=Xt(this.#v)}get#A(){return this.#h.checked&&this.#l&&
this.element.dataset.state==="playing"&&this.#g&&this.#o.game(this.#g)||null}#O(){let[e,r]=[this.#y,this.#y!==null&&this.#A?.marginal(this.#y)];return e!==null&&
r?Object.assign(Array(e).fill(0),{[e]:r.indexOf(Math.max(...r))}):null}#E(){clearInterval(this.#w),this.#w=0,this.#i.ariaLive=Number(this.#u.value)?"off":"polit\
e"}#k(){let[{policies:e,seat:r},n]=[this.#l.played,this.#o];n.step(e,r,this.#b),this.#p.push(this.#b),this.player.length=n.length,this.player.glide=Math.min(.22,
.9/(Number(this.#u.value)||4)),this.player.move(n.length-this.player.step),ir(n,r)&&this.#R()}#R(){this.#E();let[e,r,n]=[this.#l,this.#o,this.played],o=Dn()?e.link(
n):null,s=`${Y(n.seat,r.config.n_pursuers)}-${r.length}-steps.npz`,a=()=>bo(s,ma(this.#e,r,n.seat)),i=go("Link to this match");i.hidden=!0,this.#c.replaceChildren(
u("h3",{id:"play-headline"},Dl(r,n.seat)),...e.ending(r,n),u("div",{class:"play-buttons"},u("button",{type:"button",class:"primary",onclick:()=>e.again()},"Agai\
n"),u("button",{type:"button",onclick:()=>this.#$()},"Watch it"),u("button",{type:"button",onclick:a},"Save"),o&&u("button",{type:"button",onclick:()=>vo(i,o)},
e.linkName??"Link")),i),this.element.dataset.state="ended",this.player.jump(r.length),this.#T();let l=this.#v.filter(({team:c})=>c===fe(r.config,n.seat));l.length&&
this.#c.children[0].after(u("p",{class:"small muted"},$s(l))),this.#c.focus({preventScroll:!0}),this.#c.scrollIntoView({block:"nearest"})}#$(){this.element.dataset.
state="watched",this.player.length=this.#o.length,this.player.jump(0),Ke()||this.player.play()}#C(){let[e,r,{step:n}]=[this.#o,this.#y,this.player];if(!e||n>e.length)
return;let o=Qt(e,e.recording,n).filter(({agents:l})=>r===null||l.includes(r)),s=this.#l&&n===0,a=s?[Ul(e.config,r),this.#l.about??""]:[`Step ${n} of ${e.config.
max_steps}`,...o.map(({text:l})=>l)];!s&&r!==null&&a.push(Fl(e,n,r)),a.push(...this.#v.filter(l=>l.step===n).map(vt));let i=n===e.length&&r!==null?this.#A:null;
i&&a.push(`Perfect play: ${Ps(i,r)||"decided in its turn"}; ${Os(this.#g,i,n)}`),this.#S(),this.#i.textContent=a.filter(Boolean).map(l=>`${l}.`).join(" ")}};function Ul(t,e){
let r=t.rules.capture==="SURROUND";return fe(t,e)==="evader"?`Run away: you win if ${r?"the pursuers do not surround you":"no pursuer reaches your cell"} in ${t.
max_steps} steps`:`Capture evaders: ${r?"surround them with your team":"move onto their cells"}`}function Fl({config:t,recording:e},r,n){let o=e.moments[r],a=fe(
t,n)==="pursuer"?"evader":"pursuer";if(!o.alive[n])return"";let i=R(o,n),l=d=>{let[p,h]=R(o,d);return Math.max(Math.abs(p-i[0]),Math.abs(h-i[1]))},c=Array.from(
{length:o.alive.length},(d,p)=>p).filter(d=>fe(t,d)===a&&o.alive[d]&&!o.captured[d-t.n_pursuers]&&2*l(d)<t.fov);if(!c.length)return`No ${a} in view`;let m=c.reduce(
(d,p)=>l(p)<l(d)?p:d);return`Nearest ${a}: ${aa(i,R(o,m))}`}function Dl(t,e){let[{lasted:r,out:n,captured:o},{config:s}]=[Oe(t,e),t];return fe(s,e)==="pursuer"?
`Your team captured ${o} of ${zl(s)} in ${r} steps.`:n?`You lasted ${r} of ${s.max_steps} steps.`:`You escaped: ${r} steps.`}var zl=({n_evaders:t})=>`${t} evade\
r${t===1?"":"s"}`;var cr=class{dialog=u("dialog",{class:"take-over","aria-label":"Play an agent",onclose:()=>this.view?.stop(),onkeydown:e=>this.view?.key(e)&&e.preventDefault()});view=null;#e;#r;#t;#n=null;constructor(e,r,n){
[this.#e,this.#r,this.#t]=[e,r,n],n.element.addEventListener("takeover",()=>this.open())}start(e,r=""){this.#n=e;let n=st(r,this.#e,this.#r.selected),{world:o}=this.#e[n.
run],s=o&&ea(new URLSearchParams(r.replace(/^#/,"")),o);s&&this.play(n,s)}open(){let e=this.#t.shown;if(!e)return;let{match:r,step:n}=e;this.#t.player.pause();let o=this.#t.
inspector.agent,s=n<r.length?n:0,a=(d,p)=>!!r.alive[p*r.n_agents+d],i=Array.from({length:r.n_agents},(d,p)=>(p+r.config.n_pursuers)%r.n_agents),l=o??i.find(d=>a(
d,s)),c=a(l,s)?s:0,m=Array.from({length:c},(d,p)=>r.actions[p*r.n_agents+l]);this.play(this.#r.selected,{seat:l,from:c,moves:m})}play(e,r){let[n,o]=[this.#n,this.#e[e.
run]],{world:s}=o;if(!n||!s||H.some(b=>De(o,b,e[b])))return;let{run:a,pursuer:i,evader:l,episode:c,seed:m}=e,d=fe(s,r.seat),p=o.teams[d].kept.map(b=>({name:o.teams[d].
script??`generation ${b}`,text:"",policy:()=>Z(o,d,b)}));this.view||(this.view=new lr(n),this.dialog.append(u("button",{type:"button",class:"leave",onclick:()=>this.
dialog.close()},"Close"),this.view.element)),this.dialog.open||this.dialog.showModal();let h=`You are ${Y(r.seat,s.n_pursuers)}: ${this.#t.names(e).join(" again\
st ")}`,f={pursuer:Z(o,"pursuer",i),evader:Z(o,"evader",l)},y={config:s,seed:BigInt(m??o.seeds[i][l]),episode:c,policies:f,...r},g={run:a,pursuers:i,evaders:l,episode:c,
...m===null?{}:{seed:m}};an(n,this.view,y,{title:h,players:p,link:b=>Qs(g,b)})}};var ue=po(),{runs:X}=ue,[Bl,Hl]=X[0].payoff.shape,Gl=st(location.hash,X,{run:0,pursuer:Bl-1,evader:Hl-1,episode:0,seed:null}),{step:da,...jl}=Gl,oe=new sr(jl),J=new er(
X,oe,ue.playground),pa=new rr(X,oe),wt=new cr(X,oe,J),cn=Ao(X),Vl=location.hash,Ae=null,ha=u("span",{class:"told","aria-live":"polite"}),fa=u("span",{class:"sma\
ll muted"}),ya=()=>{let t=X[oe.selected.run],e=t.findings?.sentence??"";ha.textContent=t.together||e,fa.textContent=t.together?`Seed ${t.seed}: ${e} ${C(t).lead}`:
C(t).lead};oe.on("run",ya);ya();var ga=()=>{J.playSoon(),J.reveal()};document.getElementById("page").replaceWith(Hn(ue.heading,u("span",{},ha,fa),u("button",{type:"\
button",class:"keys-button",title:"Keys (?)","aria-label":"Keys (?)",onclick:()=>cn.showModal()},"?")),...ue.note?[u("aside",{class:"note small muted"},ue.note)]:
[],Mo(X,oe),u("main",{class:"stages"},pa.element,J.element),qs(X,oe,ga),u("footer",{class:"muted small"},`${ue.title} · matrixworld ${ue.version}`),wt.dialog,cn);
Object.assign(window,{matrixworldExplorer:{get match(){return J.match},get step(){return J.player.step},get pace(){return J.player.pace},get playing(){return wt.
view},play:t=>Ae&&_t(Ae,X[oe.selected.run],{...oe.selected,episode:t}),get shape(){return X[oe.selected.run].payoff.shape}}});pa.element.addEventListener("play",
ga);J.goTo(da);da||J.playSoon();jn(X,oe,J);To(X,oe,J,cn,()=>wt.open(),()=>ue.playground&&qr(J.shown,ue.playground));window.addEventListener("hashchange",({newURL:t})=>Ae&&
wt.start(Ae,new URL(t).hash));ue.growing&&Vn(X,oe,()=>J.player.playing||document.querySelector("dialog[open]")!==null);async function Kl(){Ae=ue.playground&&await In(),
J.start(Ae),Ae&&wt.start(Ae,Vl)}requestAnimationFrame(()=>setTimeout(()=>Fn(Kl())));})();
