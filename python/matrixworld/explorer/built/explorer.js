/* built from web/ by "npm run build"; sources 40826637b8633e2c5a6ec72003be3ad2a217f53c35a61341ec8d33963c132714 */
"use strict";(()=>{var on={SIMULTANEOUS:0,SWARM_TURNS:1,AGENT_TURNS:2},Ze={DISAPPEAR:0,REACH:1,BOUNCE:2},sn={OCCUPATION:0,SURROUND:1},an={FAULT:0,INVOLVED:1};var lr=["obstacle","teammate","adversary"],cr=["vertex","edge","chain"],ln=["turn","kind","form","first","second","row","col","at_fault","held","doomed"],ur=["p\
ursuer_{number}","evader_{number}"],cn={obstacle:"{first} ran into the obstacle or border at {cell}",vertex:"{first} and {second} both headed for {cell}",edge:"\
{first} and {second} meant to swap, {first} to {cell}",chain:"{first} headed for {cell}, where {second} had to stay"},Je={"both held":"both bounce","both doomed":"\
both disappear",held:"{agent} bounces",doomed:"{agent} disappears",none:"nobody is stopped"},un="{event}: {outcome}",mr={random:"any action, all equally likely",
still:"always stays",chaser:"moves to where the nearest adversary in view is nearest",fleer:"moves to where the nearest adversary in view is farthest","clumsy-c\
haser":"a chaser that takes any action in half of the steps",hunter:"a chaser of the nearest adversary in view to which no teammate in view is nearer",surrounder:"\
a chaser of the nearest free cell beside an adversary without a teammate","clumsy-fleer":"a fleer that takes any action in half of the steps",dodger:"moves to w\
here all adversaries in view together are farthest","team-surrounder":"shares the free cells beside adversaries with its teammates, and searches","careful-rando\
m":"as random, but takes only moves that right of way allows","careful-chaser":"as chaser, but takes only moves that right of way allows","careful-fleer":"as fl\
eer, but takes only moves that right of way allows","careful-clumsy-chaser":"as clumsy-chaser, but takes only moves that right of way allows","careful-hunter":"\
as hunter, but takes only moves that right of way allows","careful-surrounder":"as surrounder, but takes only moves that right of way allows","careful-clumsy-fl\
eer":"as clumsy-fleer, but takes only moves that right of way allows","careful-dodger":"as dodger, but takes only moves that right of way allows","careful-team-\
surrounder":"as team-surrounder, but takes only moves that right of way allows"},wt={adversary:"distance to the nearest adversary (0 to 2, in half views)",pressure:"\
sum over adversaries of 1 / (1 + moves)^2 (0 or more)",unclaimed:"distance to the nearest adversary to which no teammate is nearer than the agent; if there is n\
one, to the nearest one (0 to 2, in half views)",open_side:"distance to the nearest cell beside an adversary without an obstacle and teammate (0 to 2, in half v\
iews)",teammate:"distance to the nearest teammate (0 to 2, in half views)",crowd:"sum over teammates of 1 / (1 + moves)^2 (0 or more)",exits:"share of the cells\
 around that are no obstacle (0 to 1)",room:"distance to the nearest obstacle to the north, east, south or west (0 to 1, in half views)",must_yield:"1 if right \
of way forbids the move (0 to 1)",stay:"1 if it is no move (0 to 1)",ahead:"1 if it is the direction that the agent draws for each 12 steps (0 to 1)"},mn={free:"\
.GS",blocked:"#@OTW"};var Ne=1+ln.length;function Xe(t,e){return t.replace(/\{(\w+)\}/g,(r,n)=>String(e[n]))}function K(t,e){return t<e?Xe(ur[0],{number:t}):Xe(ur[1],{number:t-e})}function fa(t,e){
let[r,n,o,s,a,i,l,...c]=Array.from(t),u=a<0?[s]:[s,a],[p,d,h]=c.map(w=>u.filter((b,v)=>w>>v&1)),y=u.map(w=>K(w,e)),f=Xe(cn[a<0?"obstacle":cr[o]],{first:y[0],second:y[y.
length-1],cell:`(${i}, ${l})`}),g=Xe(un,{event:f,outcome:ya(u.length,d,h,e)});return{kind:lr[n],form:cr[o],agents:u,cell:[i,l],at_fault:p,held:d,doomed:h,turn:r,
text:g}}function ya(t,e,r,n){if(t===2&&e.length===2)return Je["both held"];if(t===2&&r.length===2)return Je["both doomed"];let o=s=>a=>Xe(Je[s],{agent:K(a,n)});
return[...e.map(o("held")),...r.map(o("doomed"))].join(", ")||Je.none}function xt(t,e){let r=[];for(let n=0;n<t.length;n+=Ne)r.push(fa(t.subarray(n+1,n+Ne),e));
return r}var we=class extends Error{name="EngineError"};function N(t,e,r){let n=typeof r=="string"?`'${r}'`:typeof r=="object"?JSON.stringify(r):String(r);return new we(
`${t}: expected ${e}, got ${n}`)}var Le=class{bytes;constructor(e){this.bytes=e}},hn=0,dr=[Uint8Array,Uint8Array,Int32Array,BigInt64Array,BigUint64Array,Float32Array,Float64Array],pn=4,dn=4,ga=new TextEncoder,
va=new TextDecoder;function ba(t){for(let e=dr.length-1;e>hn;--e)if(t instanceof dr[e])return e;throw new TypeError("array: expected a typed array of the engine\
's numbers, got another")}function pr(t){return new Uint8Array(t.buffer,t.byteOffset,t.byteLength)}function wa(t){return ga.encode(`${t}\0`)}var hr=class{engine;addresses=[];constructor(e){
this.engine=e}copy(e){let r=this.engine._malloc(Math.max(e.length,1));if(r===0)throw new we("memory: expected room for the arguments, got none");return this.addresses.
push(r),this.engine.HEAPU8.set(e,r),r}text(e){return this.copy(wa(e))}arrays(e){let r=Object.entries(e),n=r.flatMap(([s,a])=>{let i=a instanceof Le,l=i?a.bytes:
a;return[this.text(s),i?hn:ba(l),l.length,this.copy(pr(l))]}),o=this.copy(pr(Int32Array.from(n)));return this.copy(pr(Int32Array.of(r.length,o)))}free(){for(let e of this.
addresses)this.engine._free(e)}};function fn(t,e){let r=t.HEAPU8;return va.decode(r.subarray(e,r.indexOf(0,e)))}function Ie(t){let e=new Int32Array(t.HEAPU8.buffer),
r=t._last_outputs()/pn,n=e[r+1]/pn,o={};for(let s=n;s<n+e[r]*dn;s+=dn){let a=dr[e[s+1]],i=e[s+2]*a.BYTES_PER_ELEMENT,l=e[s+3];o[fn(t,e[s])]=new a(t.HEAPU8.slice(
l,l+i).buffer)}return o}function xe(t,e){let r=new hr(t);try{let n=e(r);if(n===0)throw new we(fn(t,t._last_error()));return n}finally{r.free()}}var xa=2**31-1,yn=["none","gru"],Sa=2n**64n-1n,Ma=34028234663852886e22;function ae(t,e){if(typeof e!="number"||!Number.isInteger(e)||Math.abs(e)>xa)throw N(t,"a\
n integer",e);return Int32Array.of(e)}function St(t,e){if(typeof e!="boolean")throw N(t,"true or false",e);return new Le(Uint8Array.of(Number(e)))}function Te(t,e,r){
let n=typeof e=="string"&&Object.hasOwn(r,e)?r[e]:void 0;if(n===void 0)throw N(t,`one of ${Object.keys(r).join(", ")}`,e);return Int32Array.of(n)}function fr(t,e){
if(typeof e!="number"||!(Math.abs(e)<=Ma))throw N(t,"a finite number",e);return e}function Qe(t,e){let n=typeof e=="bigint"||typeof e=="number"&&Number.isSafeInteger(
e)?BigInt(e):-1n;if(n<0n||n>Sa)throw N(t,"an integer from 0 to 2^64 - 1",e);return BigUint64Array.of(n)}function Aa(t){return{"rules.interaction":Te("interactio\
n",t.interaction,on),"rules.obstacle":Te("obstacle",t.obstacle,Ze),"rules.teammate":Te("teammate",t.teammate,Ze),"rules.evader":Te("evader",t.evader,Ze),"rules.\
pursuer":Te("pursuer",t.pursuer,Ze),"rules.capture":Te("capture",t.capture,sn),"rules.captured_disappear":St("captured_disappear",t.captured_disappear)}}function gn(t,e){
let r=typeof e=="number"?[e,e,e]:e;if(!Array.isArray(r)||r.length!==3)throw N(t,"1 or 3 numbers",e);return Float32Array.from(r,n=>fr(t,n))}function Ta(t){let e=(r,n)=>Float32Array.
of(fr(r,t[r]),fr(n,t[n]));return{"rewards.capture":e("pursuer_capture","evader_capture"),"rewards.neighbor":e("pursuer_neighbor","evader_neighbor"),"rewards.ste\
p":e("pursuer_step","evader_step"),"rewards.pursuer_collide":gn("pursuer_collide",t.pursuer_collide),"rewards.evader_collide":gn("evader_collide",t.evader_collide),
"rewards.blame":Te("blame",t.blame,an),"rewards.capture_repeats":St("capture_repeats",t.capture_repeats)}}function wn(t){if(t===void 0||typeof t=="number")return new Uint8Array(
0);if(t instanceof Uint8Array)return t;let{free:e,blocked:r}=mn;for(let[n,o]of t.entries()){if(o.length!==t[0]?.length)throw N(`map, row ${n}`,`${t[0]?.length} \
cells as in row 0`,o.length);let s=[...o].find(a=>!e.includes(a)&&!r.includes(a));if(s)throw N(`map, row ${n}`,`'${e}' (free) or '${r}' (obstacle)`,s)}return Uint8Array.
from([...t.join("")],n=>Number(r.includes(n)))}function xn(t,e){if(!Array.isArray(t))return;let r=[t.length,t[0]?.length??0];if(!(r[0]===e.rows&&r[1]===e.cols))
throw N("obstacle map",`shape (${e.rows}, ${e.cols}), the rows and cols`,r)}function Ue(t){xn(t.obstacles,t);let e=typeof t.obstacles=="number"?t.obstacles:0;return{
...Aa(t.rules),...Ta(t.rewards),rows:ae("rows",t.rows),cols:ae("cols",t.cols),n_pursuers:ae("n_pursuers",t.n_pursuers),n_evaders:ae("n_evaders",t.n_evaders),fov:ae(
"fov",t.fov),diagonal:St("diagonal",t.diagonal),max_steps:ae("max_steps",t.max_steps),density:Float64Array.of(e),map:wn(t.obstacles)}}function vn(t,e){return Int32Array.
from((e??[]).flat(),r=>ae(t,r)[0])}function Sn(t,e){return xn(t.obstacles,e),{seed:Qe("seed",t.seed??0n),episode:Qe("episode",t.episode??0),pursuers:vn("pursuer\
s",t.pursuers),evaders:vn("evaders",t.evaders),map:wn(t.obstacles)}}function Mt(t){return{actions:Int32Array.from(t,e=>ae("actions",e)[0])}}var bn=Object.keys(wt);
function yr(t){let e=bn.indexOf(t);if(e<0)throw N("inputs",`names of ${bn.join(", ")}`,t);return e}function Ee(t){if(typeof t=="string"){if(!Object.hasOwn(mr,t))
throw N("policy",`one of ${Object.keys(mr).join(", ")}`,t);return{script:new TextEncoder().encode(t)}}if(t.kind!=="cells")return{inputs:Int32Array.from(t.inputs,
e=>yr(e)),hidden:Int32Array.from(t.kind==="rating"?t.hidden:[],e=>ae("hidden",e)[0]),length:ae("length",t.kind==="program"?t.length:0),mask:new TextEncoder().encode(
t.mask),genome:t.genome};if(t.activation!=="relu"&&t.activation!=="tanh")throw N("activation","'relu' or 'tanh'",t.activation);if(!yn.includes(t.memory))throw N(
"memory",`one of ${yn.join(", ")}`,t.memory);return{hidden:Int32Array.from(t.hidden,e=>ae("hidden",e)[0]),activation:new TextEncoder().encode(t.activation),sampled:St(
"sampled",t.sampled),memory:new TextEncoder().encode(t.memory),genome:t.genome}}var Ea=["first_turn","terminated","truncated"];function Mn(t){let e={...t};for(let r of Ea)
e[r]=new Le(t[r]);return e}var An="statistics.",At=class{config;seed;episode;n_agents;statistics;first_conflict;constructor(e,r,n,o){this.config=e,this.seed=r,this.episode=n,this.n_agents=
e.n_pursuers+e.n_evaders,this.statistics=ka(Tn(o)),Object.assign(this,o),this.first_conflict=Ca(this.conflict_table,this.length)}get length(){return this.actions.
length/this.n_agents}conflicts(e){this.check(e);let[r,n]=[this.first_conflict[e],this.first_conflict[e+1]],o=this.conflict_table.subarray(r*Ne,n*Ne);return xt(o,
this.config.n_pursuers)}seek(e,r,n){this.check(r),(!(e.seed===this.seed&&e.episode===BigInt(this.episode))||e.turn!==0||e.steps>r)&&e.reset({seed:this.seed,episode:this.
episode});for(let s=e.steps;s<r;++s){let a=this.actions.subarray(s*this.n_agents,(s+1)*this.n_agents);n?e.replay(a,{pursuer:n.pursuers,evader:n.evaders}):e.step(
a)}}check(e){if(!(Number.isInteger(e)&&e>=0&&e<=this.length))throw N("step",`0 to ${this.length}`,e)}};function Ca(t,e){let r=new Int32Array(e+2);for(let n=0;n<
t.length;n+=Ne)++r[t[n]+1];for(let n=1;n<r.length;++n)r[n]+=r[n-1];return r}function ka(t){let e=["capture_rate","ever_capture_rate","captured_fraction","length"];
return Object.fromEntries(Object.entries(t).map(([r,n])=>[r,e.includes(r)?Number(n[0]):n]))}var Tn=t=>Object.fromEntries(Object.entries(t).flatMap(([e,r])=>e.startsWith(
An)?[[e.slice(An.length),r]]:[]));function En(t,e,r,n){let o=[Ue(r.config),Ee(r.pursuers),Ee(r.evaders),n];return xe(t,s=>{let[a,i,l,c]=o.map(u=>s.arrays(u));return t[e](
a,i,l,c)}),Ie(t)}function Cn(t,e,r,n){let o={seed:Qe("seed",r),episode:Qe("episode",n)};return new At(e.config,r,n,En(t,"_play_match",e,o))}function kn(t,e,r,n){
if(!Number.isInteger(n)||n<1)throw N("n_episodes","at least 1",n);let o=En(t,"_play_rollout",e,{...r,n_episodes:Int32Array.of(n)});return Tn(o)}var Ra=7e6,$a=new FinalizationRegistry(([t,e])=>t._states_free(e));function Oa({rules:t,rows:e,cols:r,obstacles:n,diagonal:o,n_pursuers:s,n_evaders:a}){let i=typeof n==
"number"||t.obstacle==="REACH"?0:n.join("").split("#").length-1,l=e*r-i,c=[t.obstacle,t.teammate,t.pursuer].includes("DISAPPEAR"),u=t.capture==="SURROUND"||t.evader===
"REACH",p=t.interaction==="AGENT_TURNS",d=(f,g)=>Array.from({length:g},(w,b)=>p?f:(f+b)/(b+1)).reduce((w,b)=>w*b,1),h=d(l+Number(c),s)*d(l*(1+Number(u))+2,a);return{
SIMULTANEOUS:[s+a],SWARM_TURNS:[s,a],AGENT_TURNS:Array(s+a).fill(1)}[t.interaction].reduce((f,g)=>f+h*(o?9:5)**g,0)}function Tt(t){return typeof t.obstacles=="n\
umber"&&t.obstacles>0?"obstacles are drawn anew in each episode":Oa(t)>Ra?"the world is too large to be solved on the page":""}var gr=class{value;teams;matrix;n_actions;constructor(e,r){
let{matrix:n,rows:o,cols:s,value:a,agents:i}=r,[l,c]=e.actors,u=Array.from(i).filter(d=>l<=d&&d<c),p=d=>d<e.config.n_pursuers;[this.value,this.matrix,this.n_actions]=
[a[0],n,e.n_actions],this.teams=[{agents:u.filter(p),play:o},{agents:u.filter(d=>!p(d)),play:s}]}marginal(e){let r=this.teams.find(({agents:s})=>s.includes(e));
if(!r)return null;let n=this.n_actions**(r.agents.length-1-r.agents.indexOf(e)),o=Array(this.n_actions).fill(0);return r.play.forEach((s,a)=>o[Math.floor(a/n)%this.
n_actions]+=s),o}lost(e){let[r,n]=this.teams.map(({agents:l})=>l.reduce((c,u)=>c*this.n_actions+e[u],0)),[o,s]=this.teams.map(({play:l})=>l),a=s.reduce((l,c,u)=>l+
c*this.matrix[r*s.length+u],0),i=o.reduce((l,c,u)=>l+c*this.matrix[u*s.length+n],0);return[Math.max(0,this.value-a),Math.max(0,i-this.value)]}},vr=60,et=class{config;payoff;engine;states;n_turns;values;constructor(e,r,n){
[this.engine,this.config,this.payoff]=[e,r,n],this.states=xe(e,i=>e._states_new(i.arrays(Ue(r)))),$a.register(this,[e,this.states]);let o={SIMULTANEOUS:1,SWARM_TURNS:2,
AGENT_TURNS:r.n_pursuers+r.n_evaders};this.n_turns=o[r.rules.interaction];let{payoffs:s}=this.call(()=>e._states_payoffs(this.states)),a=s;this.values=[[n==="ca\
pture-rate"?a:a.fill(0)]]}goBack(){let e=this.values.at(-1)[0],r=[];for(let o=this.n_turns-1;o>=0;o--){let s=r[o+1]??e;r[o]=this.backup(o,{next:s})}this.payoff===
"capture-time"&&(r[0]=r[0].map((o,s)=>s===this.config.n_evaders?0:o-1)),this.values.push(r);let n=this.payoff==="capture-rate"?this.config.max_steps:Math.min(this.
config.max_steps,vr);return this.values.length<=n&&r[0].some((o,s)=>o!==e[s])}backup(e,r){return this.call(n=>this.engine._states_backup(this.states,e,n.arrays(
r))).values}game(e){let[r,{turn:n}]=[this.config.max_steps-e.steps,e],o=n+1===this.n_turns,s=r>0?this.values[Math.min(r-Number(o),this.values.length-1)]?.[o?0:n+
1]:void 0;if(!s)return null;let a=this.call(i=>this.engine._states_game(this.states,e.address,i.arrays({next:s})));return a.agents.length?new gr(e,a):null}call(e){
return xe(this.engine,e),Ie(this.engine)}};var Rn=new FinalizationRegistry(([t,e])=>t._world_free(e)),tt=class{config;n_agents;n_actions;engine;at;freed=!1;constructor(e,r){this.engine=e,this.config=r,this.
n_agents=r.n_pursuers+r.n_evaders,this.n_actions=r.diagonal?9:5,this.at=xe(e,n=>e._world_new(n.arrays(Ue(r)))),Rn.register(this,[e,this.at],this)}free(){this.freed||
(this.freed=!0,Rn.unregister(this),this.engine._world_free(this.at))}get address(){if(this.freed)throw N("world","one that is in use","one that was freed");return this.
at}reset(e={}){let r=Sn(e,this.config);this.call(n=>this.engine._world_reset(this.address,n.arrays(r)))}step(e){let r=Mt(e);this.call(n=>this.engine._world_step(
this.address,n.arrays(r)))}playTurn(e){let r=Mt(e);this.call(n=>this.engine._world_play_turn(this.address,n.arrays(r)))}decide(e,r,n){let{n_pursuers:o}=this.config,
s={pursuer:[0,o],evader:[o,this.n_agents]},[a,i]=typeof r=="string"?s[r]:r;if(n.length!==this.n_agents)throw N("actions",String(this.n_agents),n.length);let l=[
Ee(e),Mt(n)],{actions:c}=this.call(u=>this.engine._world_decide(this.address,u.arrays(l[0]),a,i,u.arrays(l[1])));return Uint8Array.from(c)}replay(e,r){let n=s=>typeof s!=
"string"&&s.kind==="cells"&&s.memory!=="none";if(!n(r.pursuer)&&!n(r.evader))return this.step(e);let{n_pursuers:o}=this.config;for(let s=this.n_turns;s>0;--s){let[
a,i]=this.actors;a<o&&this.decide(r.pursuer,[a,Math.min(i,o)],e),i>o&&this.decide(r.evader,[Math.max(a,o),i],e),this.playTurn(e)}}get n_turns(){return this.turnNumbers()[1]}get turn(){
return this.turnNumbers()[0]}get actors(){let[,,e,r]=this.turnNumbers();return[e,r]}turnNumbers(){return this.call(()=>this.engine._world_turn(this.address)).turn}get steps(){
return this.read("steps")[0]}get seed(){return this.read("seed")[0]}get episode(){return this.read("episode")[0]}get over(){return this.read("terminated")[0]===
1||this.read("truncated")[0]===1}read(e){return this.call(r=>this.engine._world_read(this.address,r.text(e)))[e]}view(e){let r=3*this.config.fov**2;return this.
read("views").slice(e*r,(e+1)*r)}map(){return this.read("state").slice(2*this.config.rows*this.config.cols)}conflicts(){return xt(this.conflictTable(),this.config.
n_pursuers)}conflictTable(){return this.call(()=>this.engine._world_conflicts(this.address)).conflict_table}answer(e,r){let n=Ee(e),{logits:o,memory:s}=this.call(
l=>this.engine._world_logits(this.address,l.arrays(n),r)),a=o,i=this.decide(e,[r,r+1],new Uint8Array(this.n_agents))[r];return{logits:a,probabilities:_a(a),action:i,
memory:s}}rate(e,r){let n=Ee(e),{ratings:o,refused:s}=this.call(c=>this.engine._world_rate(this.address,c.arrays(n),r)),a=this.read("inputs"),i=a.length/this.n_agents/
this.n_actions,l=c=>Float32Array.from({length:this.n_actions},(u,p)=>a[(r*this.n_actions+p)*i+c]);return{inputs:e.inputs.map(c=>l(yr(c))),ratings:o,refused:s}}snapshot(){
return this.call(()=>this.engine._world_snapshot(this.address))}restore(e){let r=Mn(e);this.call(n=>this.engine._world_restore(this.address,n.arrays(r)))}call(e){
return xe(this.engine,e),Ie(this.engine)}};function _a(t){let e=Math.max(...t),r=Array.from(t,o=>Math.exp(o-e)),n=r.reduce((o,s)=>o+s,0);return Float32Array.from(
r,o=>o/n)}var br=class{compiled;constructor(e){this.compiled=e}world(e){return new tt(this.compiled,e)}solution(e,r="capture-rate"){return new et(this.compiled,e,r)}match(e,r,n,o,s=0){
return Cn(this.compiled,{config:e,pursuers:r,evaders:n},o,s)}rollouts(e,r,n,o,s){return kn(this.compiled,{config:e,pursuers:r,evaders:n},o,s)}},$n;function On(t=globalThis.
matrixworldEngine){return $n??=Pa(t),$n}async function Pa(t){if(!t)throw new Error("matrixworldEngine: expected the script engine.js before this one, got none");
let e=Uint8Array.from(atob(t.binary),r=>r.charCodeAt(0));return new br(await t({wasmBinary:e}))}var Na="http://www.w3.org/2000/svg";function m(t,e={},...r){return _n(document.createElement(t),e,r)}function x(t,e={},...r){return _n(document.createElementNS(
Na,t),e,r)}function _n(t,e,r){for(let[o,s]of Object.entries(e))s==null||s===!1||(typeof s=="function"?t.addEventListener(o.slice(2),s):t.setAttribute(o,s===!0?"":
String(s)));let n=r.filter(o=>o!=null&&o!==!1);return t.append(...n.map(o=>typeof o=="number"?String(o):o)),t}function Pn(t,e){let r=m("select",{onchange:()=>e(
r.value)},...t.map(([n,o])=>m("option",{value:n},o)));return r}async function Nn(t){try{await t}catch(e){throw(document.querySelector("#page, main")??document.body).
prepend(m("p",{class:"card problem",role:"alert"},`The page could not start: ${String(e)}`)),e}finally{document.body.dataset.ready="true"}}var Ln=()=>["file:","\
http:","https:"].includes(location.protocol);var In=()=>document.documentElement.dataset.theme==="dark",rt=t=>{document.documentElement.dataset.theme=t?"dark":"light"},wr=()=>rt(!In());if(typeof document<"\
u"){let t=matchMedia("(prefers-color-scheme: dark)");t.addEventListener("change",()=>rt(t.matches)),rt(t.matches);let e=!1;addEventListener("beforeprint",()=>{e=
In(),rt(!1)}),addEventListener("afterprint",()=>rt(e))}function Un(){return m("button",{type:"button",title:"Light or dark (D)","aria-label":"Light or dark",onclick:wr},
"◐")}var Wn=(t,e,...r)=>m("header",{class:"top"},m("div",{},m("h1",{},t),e?m("p",{class:"lead"},e):null),m("div",{class:"tools"},...r,Un()));var La=2n**64n-1n;function nt(t,e,r){let n=new URLSearchParams(t.replace(/^#/,"")),o=(c,u,p)=>{let d=n.get(c)??"";return/^\d{1,9}$/.test(d)&&Number(d)<u?Number(
d):p},s=o("run",e.length,r.run),[a,i]=e[s].payoff.shape,l=n.get("seed")??"";return{run:s,pursuer:o("pursuers",a,Math.min(r.pursuer,a-1)),evader:o("evaders",i,Math.
min(r.evader,i-1)),episode:o("episode",1/0,r.episode),seed:/^\d{1,20}$/.test(l)&&BigInt(l)<=La?l:null,step:o("step",1/0,0)}}function Dn(t,e,r){let[n,o,s]=["",JSON.
stringify(e.selected),-800],a=()=>{let{run:i,pursuer:l,evader:c,episode:u,seed:p}=e.selected,d={run:i,pursuers:l,evaders:c,episode:u,...p===null?{}:{seed:p},step:r.
player.step},h=JSON.stringify(e.selected),y=h!==o&&performance.now()-s>800;h!==o&&([o,s]=[h,performance.now()]),n=`#${Object.entries(d).map(([f,g])=>`${f}=${g}`).
join("&")}`;try{y?history.pushState(null,"",n):history.replaceState(null,"",n)}catch{}};a(),e.on("match",a),r.player.addEventListener("state",()=>r.player.playing||
a()),r.player.addEventListener("step",()=>r.player.playing||a()),window.addEventListener("hashchange",()=>{if(location.hash===n)return;let{step:i,...l}=nt(location.
hash,t,e.selected);for(let c of document.querySelectorAll("dialog[open]"))c.close();o=JSON.stringify(l),e.select(l),r.goTo(i)})}var Ia=5e3,Fn=8e3;function zn(t,e,r){
let n=-Fn;for(let o of["pointerdown","pointermove","keydown","wheel"])window.addEventListener(o,()=>n=performance.now(),{passive:!0});setInterval(()=>{if(r()||performance.
now()-n<Fn)return;let{run:o,pursuer:s,evader:a}=e.selected,[i,l]=t[o].payoff.shape;s===i-1&&a===l-1&&history.replaceState(null,"",`#run=${o}`),location.reload()},
Ia)}var O=Uint8Array,ee=Uint16Array,Rr=Int32Array,Ct=new O([0,0,0,0,0,0,0,0,1,1,1,1,2,2,2,2,3,3,3,3,4,4,4,4,5,5,5,5,0,0,0,0]),kt=new O([0,0,0,0,1,1,2,2,3,3,4,4,5,5,
6,6,7,7,8,8,9,9,10,10,11,11,12,12,13,13,0,0]),Ar=new O([16,17,18,0,8,7,9,6,10,5,11,4,12,3,13,2,14,1,15]),Kn=function(t,e){for(var r=new ee(31),n=0;n<31;++n)r[n]=
e+=1<<t[n-1];for(var o=new Rr(r[30]),n=1;n<30;++n)for(var s=r[n];s<r[n+1];++s)o[s]=s-r[n]<<5|n;return{b:r,r:o}},Yn=Kn(Ct,2),qn=Yn.b,Tr=Yn.r;qn[28]=258,Tr[258]=28;
var Zn=Kn(kt,0),Ua=Zn.b,Bn=Zn.r,Er=new ee(32768);for(E=0;E<32768;++E)fe=(E&43690)>>1|(E&21845)<<1,fe=(fe&52428)>>2|(fe&13107)<<2,fe=(fe&61680)>>4|(fe&3855)<<4,Er[E]=
((fe&65280)>>8|(fe&255)<<8)>>1;var fe,E,me=(function(t,e,r){for(var n=t.length,o=0,s=new ee(e);o<n;++o)t[o]&&++s[t[o]-1];var a=new ee(e);for(o=1;o<e;++o)a[o]=a[o-
1]+s[o-1]<<1;var i;if(r){i=new ee(1<<e);var l=15-e;for(o=0;o<n;++o)if(t[o])for(var c=o<<4|t[o],u=e-t[o],p=a[t[o]-1]++<<u,d=p|(1<<u)-1;p<=d;++p)i[Er[p]>>l]=c}else
for(i=new ee(n),o=0;o<n;++o)t[o]&&(i[o]=Er[a[t[o]-1]++]>>15-t[o]);return i}),Se=new O(288);for(E=0;E<144;++E)Se[E]=8;var E;for(E=144;E<256;++E)Se[E]=9;var E;for(E=
256;E<280;++E)Se[E]=7;var E;for(E=280;E<288;++E)Se[E]=8;var E,at=new O(32);for(E=0;E<32;++E)at[E]=5;var E,Wa=me(Se,9,0),Fa=me(Se,9,1),Da=me(at,5,0),za=me(at,5,1),
xr=function(t){for(var e=t[0],r=1;r<t.length;++r)t[r]>e&&(e=t[r]);return e},ie=function(t,e,r){var n=e/8|0;return(t[n]|t[n+1]<<8)>>(e&7)&r},Sr=function(t,e){var r=e/
8|0;return(t[r]|t[r+1]<<8|t[r+2]<<16)>>(e&7)},$r=function(t){return(t+7)/8|0},Or=function(t,e,r){return(e==null||e<0)&&(e=0),(r==null||r>t.length)&&(r=t.length),
new O(t.subarray(e,r))};var Ba=["unexpected EOF","invalid block type","invalid length/literal","invalid distance","stream finished","no stream handler",,"no callback","invalid UTF-8 da\
ta","extra field too long","date not in range 1980-2099","filename too long","stream finishing","invalid zip data"],Y=function(t,e,r){var n=new Error(e||Ba[t]);
if(n.code=t,Error.captureStackTrace&&Error.captureStackTrace(n,Y),!r)throw n;return n},Ha=function(t,e,r,n){var o=t.length,s=n?n.length:0;if(!o||e.f&&!e.l)return r||
new O(0);var a=!r,i=a||e.i!=2,l=e.i;a&&(r=new O(o*3));var c=function(Ye){var qe=r.length;if(Ye>qe){var Pe=new O(Math.max(qe*2,Ye));Pe.set(r),r=Pe}},u=e.f||0,p=e.
p||0,d=e.b||0,h=e.l,y=e.d,f=e.m,g=e.n,w=o*8;do{if(!h){u=ie(t,p,1);var b=ie(t,p+1,3);if(p+=3,b)if(b==1)h=Fa,y=za,f=9,g=5;else if(b==2){var P=ie(t,p,31)+257,C=ie(
t,p+10,15)+4,A=P+ie(t,p+5,31)+1;p+=14;for(var M=new O(A),U=new O(19),I=0;I<C;++I)U[Ar[I]]=ie(t,p+I*3,7);p+=C*3;for(var z=xr(U),be=(1<<z)-1,J=me(U,z,1),I=0;I<A;){
var j=J[ie(t,p,be)];p+=j&15;var v=j>>4;if(v<16)M[I++]=v;else{var W=0,R=0;for(v==16?(R=3+ie(t,p,3),p+=2,W=M[I-1]):v==17?(R=3+ie(t,p,7),p+=3):v==18&&(R=11+ie(t,p,
127),p+=7);R--;)M[I++]=W}}var V=M.subarray(0,P),F=M.subarray(P);f=xr(V),g=xr(F),h=me(V,f,1),y=me(F,g,1)}else Y(1);else{var v=$r(p)+4,S=t[v-4]|t[v-3]<<8,T=v+S;if(T>
o){l&&Y(0);break}i&&c(d+S),r.set(t.subarray(v,T),d),e.b=d+=S,e.p=p=T*8,e.f=u;continue}if(p>w){l&&Y(0);break}}i&&c(d+131072);for(var Ke=(1<<f)-1,ne=(1<<g)-1,he=p;;he=
p){var W=h[Sr(t,p)&Ke],X=W>>4;if(p+=W&15,p>w){l&&Y(0);break}if(W||Y(2),X<256)r[d++]=X;else if(X==256){he=p,h=null;break}else{var Q=X-254;if(X>264){var I=X-257,$=Ct[I];
Q=ie(t,p,(1<<$)-1)+qn[I],p+=$}var ue=y[Sr(t,p)&ne],Oe=ue>>4;ue||Y(3),p+=ue&15;var F=Ua[Oe];if(Oe>3){var $=kt[Oe];F+=Sr(t,p)&(1<<$)-1,p+=$}if(p>w){l&&Y(0);break}
i&&c(d+131072);var _e=d+Q;if(d<F){var vt=s-F,bt=Math.min(F,_e);for(vt+d<0&&Y(3);d<bt;++d)r[d]=n[vt+d]}for(;d<_e;++d)r[d]=r[d-F]}}e.l=h,e.p=he,e.b=d,e.f=u,h&&(u=
1,e.m=f,e.d=y,e.n=g)}while(!u);return d!=r.length&&a?Or(r,0,d):r.subarray(0,d)},ye=function(t,e,r){r<<=e&7;var n=e/8|0;t[n]|=r,t[n+1]|=r>>8},ot=function(t,e,r){
r<<=e&7;var n=e/8|0;t[n]|=r,t[n+1]|=r>>8,t[n+2]|=r>>16},Mr=function(t,e){for(var r=[],n=0;n<t.length;++n)t[n]&&r.push({s:n,f:t[n]});var o=r.length,s=r.slice();if(!o)
return{t:Xn,l:0};if(o==1){var a=new O(r[0].s+1);return a[r[0].s]=1,{t:a,l:1}}r.sort(function(T,P){return T.f-P.f}),r.push({s:-1,f:25001});var i=r[0],l=r[1],c=0,
u=1,p=2;for(r[0]={s:-1,f:i.f+l.f,l:i,r:l};u!=o-1;)i=r[r[c].f<r[p].f?c++:p++],l=r[c!=u&&r[c].f<r[p].f?c++:p++],r[u++]={s:-1,f:i.f+l.f,l:i,r:l};for(var d=s[0].s,n=1;n<
o;++n)s[n].s>d&&(d=s[n].s);var h=new ee(d+1),y=Cr(r[u-1],h,0);if(y>e){var n=0,f=0,g=y-e,w=1<<g;for(s.sort(function(P,C){return h[C.s]-h[P.s]||P.f-C.f});n<o;++n){
var b=s[n].s;if(h[b]>e)f+=w-(1<<y-h[b]),h[b]=e;else break}for(f>>=g;f>0;){var v=s[n].s;h[v]<e?f-=1<<e-h[v]++-1:++n}for(;n>=0&&f;--n){var S=s[n].s;h[S]==e&&(--h[S],
++f)}y=e}return{t:new O(h),l:y}},Cr=function(t,e,r){return t.s==-1?Math.max(Cr(t.l,e,r+1),Cr(t.r,e,r+1)):e[t.s]=r},Hn=function(t){for(var e=t.length;e&&!t[--e];)
;for(var r=new ee(++e),n=0,o=t[0],s=1,a=function(l){r[n++]=l},i=1;i<=e;++i)if(t[i]==o&&i!=e)++s;else{if(!o&&s>2){for(;s>138;s-=138)a(32754);s>2&&(a(s>10?s-11<<5|
28690:s-3<<5|12305),s=0)}else if(s>3){for(a(o),--s;s>6;s-=6)a(8304);s>2&&(a(s-3<<5|8208),s=0)}for(;s--;)a(o);s=1,o=t[i]}return{c:r.subarray(0,n),n:e}},st=function(t,e){
for(var r=0,n=0;n<e.length;++n)r+=t[n]*e[n];return r},Jn=function(t,e,r){var n=r.length,o=$r(e+2);t[o]=n&255,t[o+1]=n>>8,t[o+2]=t[o]^255,t[o+3]=t[o+1]^255;for(var s=0;s<
n;++s)t[o+s+4]=r[s];return(o+4+n)*8},Gn=function(t,e,r,n,o,s,a,i,l,c,u){ye(e,u++,r),++o[256];for(var p=Mr(o,15),d=p.t,h=p.l,y=Mr(s,15),f=y.t,g=y.l,w=Hn(d),b=w.c,
v=w.n,S=Hn(f),T=S.c,P=S.n,C=new ee(19),A=0;A<b.length;++A)++C[b[A]&31];for(var A=0;A<T.length;++A)++C[T[A]&31];for(var M=Mr(C,7),U=M.t,I=M.l,z=19;z>4&&!U[Ar[z-1]];--z)
;var be=c+5<<3,J=st(o,Se)+st(s,at)+a,j=st(o,d)+st(s,f)+a+14+3*z+st(C,U)+2*C[16]+3*C[17]+7*C[18];if(l>=0&&be<=J&&be<=j)return Jn(e,u,t.subarray(l,l+c));var W,R,V,
F;if(ye(e,u,1+(j<J)),u+=2,j<J){W=me(d,h,0),R=d,V=me(f,g,0),F=f;var Ke=me(U,I,0);ye(e,u,v-257),ye(e,u+5,P-1),ye(e,u+10,z-4),u+=14;for(var A=0;A<z;++A)ye(e,u+3*A,
U[Ar[A]]);u+=3*z;for(var ne=[b,T],he=0;he<2;++he)for(var X=ne[he],A=0;A<X.length;++A){var Q=X[A]&31;ye(e,u,Ke[Q]),u+=U[Q],Q>15&&(ye(e,u,X[A]>>5&127),u+=X[A]>>12)}}else
W=Wa,R=Se,V=Da,F=at;for(var A=0;A<i;++A){var $=n[A];if($>255){var Q=$>>18&31;ot(e,u,W[Q+257]),u+=R[Q+257],Q>7&&(ye(e,u,$>>23&31),u+=Ct[Q]);var ue=$&31;ot(e,u,V[ue]),
u+=F[ue],ue>3&&(ot(e,u,$>>5&8191),u+=kt[ue])}else ot(e,u,W[$]),u+=R[$]}return ot(e,u,W[256]),u+R[256]},Ga=new Rr([65540,131080,131088,131104,262176,1048704,1048832,
2114560,2117632]),Xn=new O(0),ja=function(t,e,r,n,o,s){var a=s.z||t.length,i=new O(n+a+5*(1+Math.ceil(a/7e3))+o),l=i.subarray(n,i.length-o),c=s.l,u=(s.r||0)&7;if(e){
u&&(l[0]=s.r>>3);for(var p=Ga[e-1],d=p>>13,h=p&8191,y=(1<<r)-1,f=s.p||new ee(32768),g=s.h||new ee(y+1),w=Math.ceil(r/3),b=2*w,v=function(ir){return(t[ir]^t[ir+1]<<
w^t[ir+2]<<b)&y},S=new Rr(25e3),T=new ee(288),P=new ee(32),C=0,A=0,M=s.i||0,U=0,I=s.w||0,z=0;M+2<a;++M){var be=v(M),J=M&32767,j=g[be];if(f[J]=j,g[be]=J,I<=M){var W=a-
M;if((C>7e3||U>24576)&&(W>423||!c)){u=Gn(t,l,0,S,T,P,A,U,z,M-z,u),U=C=A=0,z=M;for(var R=0;R<286;++R)T[R]=0;for(var R=0;R<30;++R)P[R]=0}var V=2,F=0,Ke=h,ne=J-j&32767;
if(W>2&&be==v(M-ne))for(var he=Math.min(d,W)-1,X=Math.min(32767,M),Q=Math.min(258,W);ne<=X&&--Ke&&J!=j;){if(t[M+V]==t[M+V-ne]){for(var $=0;$<Q&&t[M+$]==t[M+$-ne];++$)
;if($>V){if(V=$,F=ne,$>he)break;for(var ue=Math.min(ne,$-2),Oe=0,R=0;R<ue;++R){var _e=M-ne+R&32767,vt=f[_e],bt=_e-vt&32767;bt>Oe&&(Oe=bt,j=_e)}}}J=j,j=f[J],ne+=
J-j&32767}if(F){S[U++]=268435456|Tr[V]<<18|Bn[F];var Ye=Tr[V]&31,qe=Bn[F]&31;A+=Ct[Ye]+kt[qe],++T[257+Ye],++P[qe],I=M+V,++C}else S[U++]=t[M],++T[t[M]]}}for(M=Math.
max(M,I);M<a;++M)S[U++]=t[M],++T[t[M]];u=Gn(t,l,c,S,T,P,A,U,z,M-z,u),c||(s.r=u&7|l[u/8|0]<<3,u-=7,s.h=g,s.p=f,s.i=M,s.w=I)}else{for(var M=s.w||0;M<a+c;M+=65535){
var Pe=M+65535;Pe>=a&&(l[u/8|0]=c,Pe=a),u=Jn(l,u+1,t.subarray(M,Pe))}s.i=a}return Or(i,0,n+$r(u)+o)},Va=(function(){for(var t=new Int32Array(256),e=0;e<256;++e){
for(var r=e,n=9;--n;)r=(r&1&&-306674912)^r>>>1;t[e]=r}return t})(),Ka=function(){var t=-1;return{p:function(e){for(var r=t,n=0;n<e.length;++n)r=Va[r&255^e[n]]^r>>>
8;t=r},d:function(){return~t}}};var Ya=function(t,e,r,n,o){if(!o&&(o={l:1},e.dictionary)){var s=e.dictionary.subarray(-32768),a=new O(s.length+t.length);a.set(s),a.set(t,s.length),t=a,o.w=s.length}
return ja(t,e.level==null?6:e.level,e.mem==null?o.l?Math.ceil(Math.max(8,Math.min(13,Math.log(t.length)))*1.5):20:12+e.mem,r,n,o)},Qn=function(t,e){var r={};for(var n in t)
r[n]=t[n];for(var n in e)r[n]=e[n];return r};var D=function(t,e,r){for(;r;++e)t[e]=r,r>>>=8};var qa=function(t,e){return((t[0]&15)!=8||t[0]>>4>7||(t[0]<<8|t[1])%31)&&Y(6,"invalid zlib data"),(t[1]>>5&1)==+!e&&Y(6,"invalid zlib data: "+(t[1]&32?"need":"u\
nexpected")+" dictionary"),(t[1]>>3&4)+2};function Za(t,e){return Ya(t,e||{},0,0)}function eo(t,e){return Ha(t.subarray(qa(t,e&&e.dictionary),-4),{i:2},e&&e.out,e&&e.dictionary)}var to=function(t,e,r,n){for(var o in t){var s=t[o],a=e+o,i=n;Array.isArray(s)&&(i=Qn(n,s[1]),s=s[0]),s instanceof O?r[a]=[s,i]:(r[a+="/"]=[new O(0),i],to(s,a,r,
n))}},jn=typeof TextEncoder<"u"&&new TextEncoder,Ja=typeof TextDecoder<"u"&&new TextDecoder,Xa=0;try{Ja.decode(Xn,{stream:!0}),Xa=1}catch{}function Et(t,e){if(e){for(var r=new O(t.length),n=0;n<t.length;++n)r[n]=t.charCodeAt(n);return r}if(jn)return jn.encode(t);for(var o=t.length,s=new O(t.length+
(t.length>>1)),a=0,i=function(u){s[a++]=u},n=0;n<o;++n){if(a+5>s.length){var l=new O(a+8+(o-n<<1));l.set(s),s=l}var c=t.charCodeAt(n);c<128||e?i(c):c<2048?(i(192|
c>>6),i(128|c&63)):c>55295&&c<57344?(c=65536+(c&1047552)|t.charCodeAt(++n)&1023,i(240|c>>18),i(128|c>>12&63),i(128|c>>6&63),i(128|c&63)):(i(224|c>>12),i(128|c>>
6&63),i(128|c&63))}return Or(s,0,a)}var kr=function(t){var e=0;if(t)for(var r in t){var n=t[r].length;n>65535&&Y(9),e+=n+4}return e},Vn=function(t,e,r,n,o,s,a,i){var l=n.length,c=r.extra,u=i&&i.length,
p=kr(c);D(t,e,a!=null?33639248:67324752),e+=4,a!=null&&(t[e++]=20,t[e++]=r.os),t[e]=20,e+=2,t[e++]=r.flag<<1|(s<0&&8),t[e++]=o&&8,t[e++]=r.compression&255,t[e++]=
r.compression>>8;var d=new Date(r.mtime==null?Date.now():r.mtime),h=d.getFullYear()-1980;if((h<0||h>119)&&Y(10),D(t,e,h<<25|d.getMonth()+1<<21|d.getDate()<<16|d.
getHours()<<11|d.getMinutes()<<5|d.getSeconds()>>1),e+=4,s!=-1&&(D(t,e,r.crc),D(t,e+4,s<0?-s-2:s),D(t,e+8,r.size)),D(t,e+12,l),D(t,e+14,p),e+=16,a!=null&&(D(t,e,
u),D(t,e+6,r.attrs),D(t,e+10,a),e+=14),t.set(n,e),e+=l,p)for(var y in c){var f=c[y],g=f.length;D(t,e,+y),D(t,e+2,g),t.set(f,e+4),e+=4+g}return u&&(t.set(i,e),e+=
u),e},Qa=function(t,e,r,n,o){D(t,e,101010256),D(t,e+8,r),D(t,e+10,r),D(t,e+12,n),D(t,e+16,o)};function ro(t,e){e||(e={});var r={},n=[];to(t,"",r,e);var o=0,s=0;for(var a in r){var i=r[a],l=i[0],c=i[1],u=c.level==0?0:8,p=Et(a),d=p.length,h=c.comment,y=h&&
Et(h),f=y&&y.length,g=kr(c.extra);d>65535&&Y(11);var w=u?Za(l,c):l,b=w.length,v=Ka();v.p(l),n.push(Qn(c,{size:l.length,crc:v.d(),c:w,f:p,m:y,u:d!=a.length||y&&h.
length!=f,o,compression:u})),o+=30+d+g+b,s+=76+2*(d+g)+(f||0)+b}for(var S=new O(s+22),T=o,P=s-o,C=0;C<n.length;++C){var p=n[C];Vn(S,p.o,p,p.f,p.u,p.c.length);var A=30+
p.f.length+kr(p.extra);S.set(p.c,p.o+A),Vn(S,o,p,p.f,p.u,p.c.length,p.o,p.m),o+=16+A+(p.m?p.m.length:0)}return Qa(S,o,n.length,P,T),S}var L=(t,e=2)=>t==null?"-":t.toFixed(e);function no(t,e,r){return e===null||r===null?L(t):`${L(t)} (${L(e)} to ${L(r)})`}var oo=t=>t.toLocaleString("en-GB"),ge=t=>t.
charAt(0).toUpperCase()+t.slice(1);function it(t,e,r,n=!1){let o=(e-t)/Math.max(1,r),s=10**Math.floor(Math.log10(o||1)),a=[1,2,5,10].map(c=>c*s).find(c=>c>=o)??
10*s;n&&(a=Math.max(1,Math.round(a)));let i=Math.ceil(t/a-1e-9),l=Math.floor(e/a+1e-9);return Array.from({length:Math.max(0,l-i+1)},(c,u)=>(i+u)*a)}var ei={teams:{pursuer:"pursuers",evader:"evaders"},generation:{pursuer:"pursuer generation",evader:"evader generation"},score:"capture rate",means:{pursuer:"ca\
ptures",evader:"escapes"},curves:{pursuer:"captures",evader:"escapes"},ends:["0 all escape","1 all caught"],lead:"Each cell is a match between two generations: \
the brighter, the more evaders are captured. Click one to watch it.",click:"watch its match"},ti=([t,e])=>({teams:{pursuer:t,evader:e},generation:{pursuer:`gene\
ration of ${t}`,evader:`generation of ${e}`},score:`score of the ${t}`,means:{pursuer:t,evader:e},curves:{pursuer:"scores",evader:"scores"},ends:[`0 the ${e} wi\
n`,`1 the ${t} win`],lead:`Each cell is a pair of generations: the brighter, the higher the score of the ${t}. Click one to see more of it.`,click:"see more of \
it"}),_=({game:t})=>t?ti(t.teams):ei,B=(t,e,r)=>`${_(t).teams[e]} of generation ${r}`,ri=200;function so(t,e,{pursuer:r,evader:n},o){let{text:s,image:a}=e.shows[`${r}\
 ${n}`]??{},i=Me(t,r,n)?.rates??[],l=`Scores of the ${e.teams[0]} in ${i.length} episodes: ${i.map(c=>L(c)).join(", ")}`;return[s===void 0?null:m("pre",{tabindex:0,
"aria-label":"What the game shows of this pair"},s),a===void 0?null:m("img",{src:a,alt:"What the game shows of this pair",onload:({target:c})=>c.classList.toggle(
"pixels",c.naturalWidth<ri)}),...(s??a)===void 0?[m("p",{class:"muted"},e.missing),ni(t,e,r,n,o)]:[],i.length>1?m("p",{class:"small numbers"},l):null].filter(c=>c!==
null)}function ni(t,e,r,n,o){let s=Object.keys(e.shows).map(u=>u.split(" ").map(Number)),a=([u,p])=>(u-r)**2+(p-n)**2,[i,l]=s.sort((u,p)=>a(u)-a(p))[0]??[];if(i===
void 0||l===void 0)return null;let c=`${B(t,"pursuer",i)} against ${B(t,"evader",l)}`;return m("p",{},m("button",{type:"button",onclick:()=>o.select({pursuer:i,
evader:l})},`Nearest: ${c}`))}var le=["pursuer","evader"],io=()=>JSON.parse(Ot("data"));function Me(t,e,r){let[n,o]=[e-t.payoff.first[0],r-t.payoff.first[1]],s=t.payoff.capture_rate[n]?.[o];
return s===void 0?null:{rate:s,rates:t.payoff.capture_rates[n][o],lengths:t.payoff.lengths[n]?.[o]??[]}}function Rt(t,e,r){let{script:n,policy:o,kept:s,genomes:a}=t.
teams[e];if(n!==null||o===null)return"";if(!s.includes(r))return`The page holds no genome of ${B(t,e,r)}: it would be too large. Choose a generation of ${s.join(
", ")}.`;let i=s.length*o.genome_size;return co(a,o.genome_size).length===i?"":`The page is damaged: it does not hold the ${i} numbers of the ${e}s' genomes. Wr\
ite it again from its run.`}function oe(t,e,r){let{script:n,policy:o,kept:s,genomes:a}=t.teams[e];if(n!==null||o===null)return n??"random";let i=s.indexOf(r);if(i<
0)throw new RangeError(`${e}: expected a generation whose genome the page holds, got ${r}`);let l=o.genome_size,c=co(a,l).subarray(i*l,(i+1)*l);return{...o,genome:c}}
var lo=({teams:t},e,r)=>t[e].expressions?.[t[e].kept.indexOf(r)]??"";function $t(t,e,{pursuer:r,evader:n,episode:o,seed:s}){let a=e.seeds[r][n];return t.match(e.
world,oe(e,"pursuer",r),oe(e,"evader",n),BigInt(s??a),o)}var _r=4,ao=new Map;function co(t,e){let r=ao.get(t);if(r)return r;let n=new Float32Array;try{let o=si(Pr(t),e);o.every(Number.isFinite)&&(n=o)}catch(o){if(!(o instanceof DOMException||
o instanceof RangeError||oi(o)))throw o}return ao.set(t,n),n}var oi=t=>t instanceof Error&&"code"in t;function si(t,e){let r=eo(t),n=r.length/_r,o=new Uint8Array(
r.length);for(let a=0;a<o.length;a++)o[a]=r[a%_r*n+Math.floor(a/_r)];let s=new Uint32Array(o.buffer);for(let a=e;a<s.length;a++)s[a]^=s[a-e];return new Float32Array(
o.buffer)}function Pr(t){let e=atob(Ot(t)),r=new Uint8Array(e.length);for(let n=0;n<r.length;n++)r[n]=e.charCodeAt(n);return r}var Ot=t=>document.getElementById(
t)?.textContent??"";var lt=[.5,1,2,4,8,16,32,64],_t=0,Pt=12,ai=2,We=class extends EventTarget{#e;#r;#t;#n=0;#a=0;#s=!1;#u=null;#f=0;#d=[];#m=[];glide=.28;constructor(e,{speed:r=4,still:n=!1}={}){
super(),[this.#e,this.#r,this.#t]=[e,r,n]}get step(){return this.#n}get time(){return this.#t?this.#n:this.#a}get arrived(){return this.#a===this.#n}get playing(){
return this.#s}get length(){return this.#e}set length(e){this.#e=e,this.#n>e&&this.jump(e),this.#o("state")}get marks(){return this.#d}set marks(e){this.#d=e,this.#o(
"state")}get ticks(){return this.#m}set ticks(e){this.#m=e,this.#o("state")}get pace(){return this.#r||Math.max(ai,this.#e/Pt)}get speed(){return this.#r}set speed(e){
this.#r=e,this.#o("state")}changeSpeed(e){let r=lt.findIndex(n=>n>=this.pace);this.speed=lt[Math.min(lt.length-1,Math.max(0,r+e))]}play(){this.#s||!this.#e||(this.#n===
this.#e&&this.jump(0),this.#s=!0,this.#o("state"),this.#l())}pause(){this.#s&&(this.#s=!1,this.#o("state"))}toggle(){this.#s?this.pause():this.play()}move(e){this.
pause();let r=Math.min(this.#e,Math.max(0,this.#n+e));Math.abs(r-this.#a)>1?this.jump(r):this.#p(r),this.#l()}jump(e){this.#a=Math.min(this.#e,Math.max(0,Math.round(
e))),this.#p(this.#a),this.#o("frame")}#p(e){e!==this.#n&&(this.#n=e,this.#o("step"),this.#t&&this.#o("frame"))}#l(){this.#u===null&&(this.#f=performance.now(),
this.#u=requestAnimationFrame(()=>this.#i()))}#i(){this.#u=null;let e=performance.now();this.#c(Math.min(.25,(e-this.#f)/1e3)),this.#f=e,(!this.#t||this.arrived)&&
this.#o("frame"),(this.#s||this.#a!==this.#n)&&(this.#u=requestAnimationFrame(()=>this.#i()))}#c(e){let r=e;for(;r>0;){if(this.#a===this.#n){if(!this.#s)return;
if(this.#n===this.#e)return this.pause();this.#p(this.#n+1)}let n=this.#s?this.pace:1/this.glide,o=this.#n-this.#a,s=Math.min(Math.abs(o),r*n);r-=s/n,this.#a=s===
Math.abs(o)?this.#n:this.#a+Math.sign(o)*s}this.#s&&this.#a===this.#e&&this.pause()}#o(e){this.dispatchEvent(new Event(e))}};function Fe(t,e){if(e.ctrlKey||e.metaKey||
e.altKey)return!1;let r=e.shiftKey?10:1,o={" ":()=>t.toggle(),ArrowRight:()=>t.move(r),ArrowLeft:()=>t.move(-r),Home:()=>t.move(-t.length),End:()=>t.move(t.length),
"+":()=>t.changeSpeed(1),"-":()=>t.changeSpeed(-1)}[e.key];return o?.(),o!==void 0}function uo(t,e,...r){let n=m("dialog",{class:e,"aria-label":t,onclick:({target:o})=>o===n&&n.close()},m("div",{class:"dialog-head"},m("h2",{},t),m("button",{type:"\
button",class:"close","aria-label":"Close",onclick:()=>n.close()},"✕")),...r);return n}var mo=t=>m("dl",{class:"keys"},...t.flatMap(([e,r])=>[m("dt",{},...e.map(
n=>m("kbd",{},n))),m("dd",{},r)])),po=t=>m("input",{type:"text",readonly:!0,"aria-label":t});function ho(t,e){let r=URL.createObjectURL(new Blob([e],{type:"appl\
ication/octet-stream"}));m("a",{href:r,download:t}).click(),setTimeout(()=>URL.revokeObjectURL(r),6e4)}var ct=[[68,1,84],[72,26,108],[71,47,125],[65,68,135],[57,86,140],[49,104,142],[42,120,142],[35,136,142],[31,152,139],[34,168,132],[53,183,121],[84,197,104],[122,
209,81],[165,219,54],[210,226,27],[253,231,37]];function Nt(t){let e=Math.min(1,Math.max(0,t))*(ct.length-1),r=Math.min(ct.length-2,Math.floor(e)),[n,o]=[ct[r],
ct[r+1]],s=a=>Math.round(n[a]+(e-r)*(o[a]-n[a]));return[s(0),s(1),s(2)]}function fo(t){let[e,r,n]=Nt(t).map(o=>((o/255+.055)/1.055)**2.4);return .2126*e+.7152*r+
.0722*n>.179?"#000":"#fff"}var yo=t=>`rgb(${Nt(t).join(" ")})`,go=()=>`linear-gradient(to right, ${ct.map(t=>`rgb(${t.join(" ")})`).join(", ")})`;function Lt(t,e,r){let n=devicePixelRatio||1;for(let[a,i]of Object.entries(r))t.style.setProperty(a,`${i}px`);t.width=Math.round(r.width*n),t.height=Math.round(
r.height*n);let o=t.getContext("2d"),s=Nr(e);!o||!s||(o.imageSmoothingEnabled=!1,o.drawImage(s,0,0,t.width,t.height))}function Nr(t){let[e,r]=t.shape,n=document.
createElement("canvas");[n.width,n.height]=[r,e];let o=n.getContext("2d");if(!o)return null;let s=o.createImageData(r,e);return t.capture_rate.forEach((a,i)=>a.
forEach((l,c)=>{let u=4*((e-1-i-t.first[0])*r+c+t.first[1]);s.data.set([...Nt(l),255],u)})),o.putImageData(s,0,0),n}function It(t,e,r,n=2){t.textContent=L(e,n),
t.ariaLabel=`${r}: ${t.textContent}`,e!==void 0&&([t.style.backgroundColor,t.style.color]=[yo(e),fo(e)])}function ut(t,e){let r=m("span",{class:"gradient"});return r.
style.backgroundImage=go(),m("p",{class:"scale-of-rates small muted"},t,r,e)}var ii=84;function vo(t,e){let r=t.map((s,a)=>li(s,a,e)),n=m("nav",{class:"races","aria-label":"Runs"},...r.map(s=>s.button)),o=()=>r.forEach((s,a)=>s.update(a===
e.selected.run));return e.on("match hover",o),o(),n.hidden=t.length<2,n}function li(t,e,r){let[n,o]=t.payoff.shape,s=!t.name.startsWith(t.schedule),a=ii/Math.max(
n,o),i=m("canvas",{"aria-hidden":"true"});Lt(i,t.payoff,{left:0,top:0,width:o*a,height:n*a});let l=m("span",{class:"place"}),c=m("button",{type:"button",class:"\
race",title:`${t.name} (key ${e+1})`,onclick:()=>Lr(t,e,r)},m("span",{class:"small-matrix"},i,l),m("span",{class:"race-text"},m("strong",{},s?t.name:t.schedule),
m("span",{class:"small"},t.findings?t.findings.headline:`${t.learning.map(p=>_(t).teams[p]).join(" and ")} against ${ci(t)}`),m("span",{class:"small muted"},`${s?
`${t.schedule}, `:""}seed ${t.seed}`)));return{button:c,update:p=>{c.setAttribute("aria-current",String(p));let d=r.hover.pursuer??r.selected.pursuer,h=r.hover.
evader??r.selected.evader;l.hidden=d>=n||h>=o,l.style.left=`${(h+.5)*a}px`,l.style.top=`${(n-d-.5)*a}px`}}}var ci=t=>t.teams.pursuer.script??t.teams.evader.script??
"another run";function Lr(t,e,r){let[n,o]=t.payoff.shape,{pursuer:s,evader:a}=r.selected;r.select({run:e,pursuer:Math.min(s,n-1),evader:Math.min(a,o-1)})}var ui=t=>[[["Space"],"play or pause"],[["←","→"],"step back or forward; with Shift ten steps"],[["Home","End"],"first or last step"],[["+","−"],"faster o\
r slower"],[["N"],"next episode of the same pair; with Shift the one before"],[["R"],"another seed, not one of the evaluation"],[["O"],"the cell's own seed agai\
n"],[["P"],`next ${_(t).generation.pursuer}; with Shift the one before`],[["E"],`next ${_(t).generation.evader}; with Shift the one before`],[["M"],`to the matr\
ix: arrow keys choose a ${t.game?"pair, Enter shows it":"match, Enter plays it"}`],[["A"],"next agent: what it sees; with Shift the one before"],[["Esc"],"no ag\
ent"],[["T"],"take over the chosen agent, or an evader, from this step on"],[["G"],"this step in the playground: any other rules, actions and places"],[["1","9"],
"first to ninth run"],[["D"],"light or dark"],[["?"],"this list"]],mi=["P","E","M","1","D","?"],pi="The page holds the genomes and the engine of this run. A cli\
ck on a cell plays that very match: same seed, same moves. ";function bo(t){let e=t.find(({game:n})=>!n),r=ui(e??t[0]).filter(([[n]])=>e||mi.includes(n));return uo(
"Keys","help",mo(r),m("p",{class:"muted small"},`${e?pi:""}The page loads nothing from elsewhere; share the file as it is.`))}function wo(t,e,r,n,o,s){let a=(l,c)=>()=>{
let u=t[e.selected.run].payoff.shape[l==="pursuer"?0:1];e.select({[l]:Math.min(u-1,Math.max(0,e.selected[l]+c))})},i={n:()=>e.select({episode:e.selected.episode+
1}),N:()=>e.select({episode:Math.max(0,e.selected.episode-1)}),r:()=>e.select({seed:String(crypto.getRandomValues(new BigUint64Array(1))[0]),episode:0}),o:()=>e.
select({seed:null,episode:0}),p:a("pursuer",1),P:a("pursuer",-1),e:a("evader",1),E:a("evader",-1),m:()=>document.getElementById("matrix")?.focus(),a:()=>r.inspector.
next(1),A:()=>r.inspector.next(-1),Escape:()=>r.inspector.choose(null),t:o,g:s,d:wr,"?":()=>n.showModal()};document.addEventListener("keydown",l=>{let c=l.target instanceof
HTMLSelectElement||l.target instanceof HTMLInputElement,u=l.target instanceof HTMLButtonElement&&(l.key===" "||l.key==="Enter");if(document.querySelector("dialo\
g[open]")||c||u||l.defaultPrevented||l.ctrlKey||l.metaKey||l.altKey)return;let p=i[l.key]??i[l.key.toLowerCase()],d=Number(l.key)-1;if(Fe(r.player,l)||p)p?.();else if(t[d])
Lr(t[d],d,e);else return;l.preventDefault()})}var De=[[0,0],[-1,0],[0,1],[1,0],[0,-1],[-1,1],[1,1],[1,-1],[-1,-1]];function xo(t,e,r){let[n,o]=[e[0]-t[0],e[1]-t[1]];return!r&&Math.abs(n)>Math.abs(o)?o=0:r||
(n=0),De.findIndex(([s,a])=>s===Math.sign(n)&&a===Math.sign(o))}var Ce=(t,e)=>e<t.nPursuers,k=(t,e)=>[t.positions[2*e],t.positions[2*e+1]],Ir=({rows:t,cols:e},[
r,n])=>r>=0&&n>=0&&r<t&&n<e,Ur=(t,e,r=3)=>t!==void 0&&[0,1,2].slice(0,r).some(n=>t[3*e+n]),Wr=(t,e)=>Ur(t.fault,e),So=(t,e)=>!Wr(t,e)&&Ur(t.involved,e,2);function Ut(t,e,r){
let[n,o]=[k(t,r),k(e,r)],s=n[0]!==o[0]||n[1]!==o[1],a=e.involved===void 0||Ur(e.involved,r);return!!(e.alive[r]&&e.actions?.[r]&&!s&&a)}function Wt(t,e,r){let[n,
o]=k(t,r),[s,a]=De[e.actions?.[r]??0];return[n+s,o+a]}function mt(t,e,r){return Array.from({length:r.everCaptured.length},(o,s)=>s).filter(o=>r.everCaptured[o]&&
!e.everCaptured[o]).map(o=>t.nPursuers+o)}var Mo=t=>t.moments.flatMap((e,r)=>r&&mt(t,t.moments[r-1],e).length?[r]:[]);function Ft(t,e){return Array.from({length:e.
alive.length},(n,o)=>o).filter(n=>t.alive[n]&&!e.alive[n])}var Ao=[-.31,0,.31],To=[{size:1,at:[[0,0]]},{size:.62,at:[[-.2,.2],[.2,-.2]]},{size:.54,at:[[-.23,.22],[.23,.22],[0,-.22]]},{size:.54,at:[[-.23,.23],[.23,.23],[
-.23,-.23],[.23,-.23]]},{size:.36,at:Ao.flatMap(t=>Ao.map(e=>[e,t]))}],di=.3,hi=.35,fi=.55;function pt(t,e){let r=new Map;for(let n=0;n<e.alive.length;n++){if(!e.
alive[n])continue;let[o,s]=k(e,n),a=o*t.cols+s,i=r.get(a);i?i.push(n):r.set(a,[n])}return r}function Eo(t,e){let r=Array.from(e.alive,(n,o)=>{let[s,a]=k(e,o);return{
x:a+.5,y:s+.5,size:1,alpha:0}});for(let n of pt(t,e).values()){let o=To[Math.min(n.length,To.length)-1];n.forEach((s,a)=>{let[i,l]=o.at[Math.min(a,o.at.length-1)],
c=r[s];c.x+=i,c.y+=l,c.size=o.size,c.alpha=1})}return r}var Co=t=>t*t*(3-2*t),ze=(t,e,r)=>t+(e-t)*r,ko=t=>Math.min(1,Math.max(0,t));function Ro(t,e,r,n){let o={
SIMULTANEOUS:1,SWARM_TURNS:2,AGENT_TURNS:r}[t.interaction];if(o===1)return Co(n);let s=o===r?e:+!Ce(t,e),a=Math.max(1/o,hi);return Co(ko((n-s/(o-1)*(1-a))/a))}function Dt(t,e){
let r=t.moments.length-1,n=Math.min(Math.floor(e),r),o=t.moments[n],s=Eo(t,o);if(n===r||e===n)return s;let a=t.moments[n+1],i=Eo(t,a);return s.map((l,c)=>{let u=Ro(
t,c,s.length,e-n);return yi(o,a,c,l,i[c],u)})}function Fr(t,e,r){let n=t.moments.length-1,o=Math.min(Math.floor(r),n),[s,a]=[t.moments[o],t.moments[Math.min(o+1,
n)]],i=Ro(t,e,s.alive.length,r-o),[[l,c],[u,p]]=[k(s,e),k(a,e)];return[ze(c,p,i)+.5,ze(l,u,i)+.5]}function yi(t,e,r,n,o,s){let a=n.alpha>o.alpha,i={x:ze(n.x,o.x,
s),y:ze(n.y,o.y,s),size:a?n.size:ze(n.size,o.size,s),alpha:a?ko((1-s)/(1-fi)):ze(n.alpha,o.alpha,s)};if(Ut(t,e,r)){let[l,c]=k(t,r),[u,p]=Wt(t,e,r),d=di*Math.sin(
Math.PI*s);i.x+=(p-c)*d,i.y+=(u-l)*d}return i}var $o=2*Math.PI;function ke(t,e,r,n){t.beginPath(),t.arc(e,r,n/2,0,$o)}function zt(t,e,r,n){let o=n/2,s=[[0,-.97],[.97,.83],[-.97,.83]].map(([a,i])=>[e+a*o,r+i*
o]);t.beginPath(),t.moveTo((s[2][0]+s[0][0])/2,(s[2][1]+s[0][1])/2),s.forEach(([a,i],l)=>{let[c,u]=s[(l+1)%3];t.arcTo(a,i,c,u,n*.09)}),t.closePath()}function Oo(t,e,r,n){
let o=n*.32;t.beginPath(),t.moveTo(e-o,r-o),t.lineTo(e+o,r+o),t.moveTo(e+o,r-o),t.lineTo(e-o,r+o)}function _o(t,e,r,n){t.beginPath();for(let o=0;o<16;o++){let s=n/
2*(o%2?.6:.95),a=$o*o/16;t.lineTo(e+s*Math.sin(a),r-s*Math.cos(a))}t.closePath()}function Po(t,e,r,n,o,s){let a=Math.atan2(o-r,n-e);t.beginPath(),t.moveTo(e,r),
t.lineTo(n,o);for(let i of[-1,1])t.moveTo(n,o),t.lineTo(n-s*Math.cos(a+i*.6),o-s*Math.sin(a+i*.6))}var No=4,gi=1.6,vi=.95,bi=5,wi=.16,xi=9,Si=.09,Mi=.2,Lo=.75,H=(t,e)=>t.left+e*t.cell,G=(t,e)=>t.top+e*t.cell;function Be(t,e,r){return Ce(e,r)?t.colors.pursuer:
t.colors.evader}function Bt({ctx:t,colors:e},r,n,o,s,a,i=0){t.font=`700 ${Math.round(s)}px system-ui, sans-serif`,t.textAlign="center",t.textBaseline="middle",t.
strokeStyle=e.paper,t.lineWidth=i,i&&t.strokeText(r,n,o),t.fillStyle=a,t.fillText(r,n,o)}function Io({ctx:t,grid:e,colors:r}){let{left:n,top:o,cell:s,rows:a,cols:i}=e,
[l,c]=[i*s,a*s];if(t.fillStyle=r.paper,t.fillRect(n,o,l,c),s<bi)return;t.fillStyle=r.line;let u=Math.max(1,Math.round(s/60));for(let p=1;p<i;p++)t.fillRect(n+p*
s,o,u,c);for(let p=1;p<a;p++)t.fillRect(n,o+p*s,l,u)}function Uo({ctx:t,grid:e,colors:r},n){let{left:o,top:s,cell:a,rows:i,cols:l}=e;t.fillStyle=r.obstacle;for(let c=0;c<
i*l;c++){if(!n.obstacles[c])continue;let[u,p]=[Math.floor(c/l),c%l];t.fillRect(o+p*a,s+u*a,a,a)}Wo({ctx:t,grid:e,colors:r})}function Wo({ctx:t,grid:{left:e,top:r,
cell:n,rows:o,cols:s},colors:a}){let i=Math.min(5,Math.max(2,Math.round(n/18)));t.strokeStyle=a.frame,t.lineWidth=i,t.strokeRect(e-i/2,r-i/2,s*n+i,o*n+i)}function Fo({
ctx:t,grid:e,colors:r},n){let{left:o,top:s,cell:a,rows:i,cols:l}=e,c=a<24*n?5:1;t.font=`500 ${Math.round(Math.min(15*n,Math.max(9*n,a*.32)))}px system-ui, sans-\
serif`,t.fillStyle=r.muted,t.textBaseline="alphabetic",t.textAlign="center";let u=5*n+a/40;for(let p=0;p<l;p+=c)t.fillText(String(p),o+(p+.5)*a,s-u);t.textAlign=
"right",t.textBaseline="middle";for(let p=0;p<i;p+=c)t.fillText(String(p),o-u,s+(p+.5)*a)}function Do({grid:t},e,r,n){let o=Math.floor(e.fov/2)+.5,[s,a]=[Math.max(
0,r-o),Math.min(t.cols,r+o)],[i,l]=[Math.max(0,n-o),Math.min(t.rows,n+o)];return[H(t,s),G(t,i),(a-s)*t.cell,(l-i)*t.cell]}function zo(t,e,r,n){let{ctx:o,grid:s,
colors:a}=t;o.save(),o.beginPath(),o.rect(0,0,o.canvas.width,o.canvas.height),o.rect(...Do(t,e,r,n)),o.clip("evenodd"),o.clearRect(0,0,o.canvas.width,o.canvas.height),
o.fillStyle=a.line,o.fillRect(s.left,s.top,s.cols*s.cell,s.rows*s.cell),o.restore(),Wo(t)}function Bo(t,{x:e,y:r,alpha:n},o){let{ctx:s,grid:a,colors:i}=t,l=Math.
max(a.cell,16*o)*1.06,[c,u]=[H(a,e),G(a,r)];s.globalAlpha=Math.max(n,.6),s.beginPath(),s.roundRect(c-l/2,u-l/2,l,l,l*.2),s.strokeStyle=i.focus,s.lineWidth=Math.
max(2,2.5*o),s.stroke();let p=Math.max(11*o,Math.min(18*o,a.cell*.5)),d=u-l/2<p*1.2,h=u+(d?1:-1)*(l/2+p*.7);s.lineJoin="round",Bt(t,"You",c,h,p,i.ink,p*.35),s.globalAlpha=
1}function Ho(t,e,r,n,o){let{ctx:s,grid:a}=t,i=Do(t,e,n,o),l=Be(t,e,r);s.globalAlpha=.11,s.fillStyle=l,s.fillRect(...i),s.globalAlpha=.8,s.strokeStyle=l,s.lineWidth=
Math.max(1,a.cell/24),s.strokeRect(...i),s.globalAlpha=1}function Go(t,e,r,n,o){let{ctx:s,grid:a}=t,i=Math.min(Math.ceil(r),e.moments.length-1),l=e.moments[i];s.
lineCap="round",s.lineWidth=Math.min(xi,Math.max(1,a.cell*wi));for(let c=Math.max(1,Math.floor(r-n)+1);c<=i;c++){let[u,p]=[e.moments[c-1],e.moments[c]],d=Math.max(
0,Math.min(1,(r-c)/n));s.globalAlpha=Lo+(Mi-Lo)*d;for(let h=0;h<p.alive.length;h++){let y=c===i&&r<i;if(!u.alive[h]||!(l.alive[h]||y))continue;let f=(Ce(e,h)?-1:
1)*Si,[g,w]=k(u,h),[b,v]=k(p,h);if(g===b&&w===v)continue;let S=y?o[h].x:v+.5,T=y?o[h].y:b+.5;s.strokeStyle=Be(t,e,h),s.beginPath(),s.moveTo(H(a,w+.5+f),G(a,g+.5+
f)),s.lineTo(H(a,S+f),G(a,T+f)),s.stroke()}}s.globalAlpha=1}function jo(t,e,r){let n=Math.min(Math.ceil(r),e.moments.length-1);for(let o=Math.max(1,n-No+1);o<=n;o++){
let[s,a]=[e.moments[o-1],e.moments[o]],i=o>r?Math.max(0,1-2*(o-r)):1-(r-o)/No,l=mt(e,s,a);for(let c of Ft(s,a))l.includes(c)||Ti(t,k(a,c),i);for(let c of l)Ai(t,
k(a,c),i)}t.ctx.globalAlpha=1}function Ai({ctx:t,grid:e,colors:r},[n,o],s){t.globalAlpha=s,_o(t,H(e,o+.5),G(e,n+.5),Math.max(8,e.cell*gi)),t.fillStyle=r.capture,
t.fill(),t.strokeStyle=r.ink,t.lineWidth=Math.max(1,e.cell/36),t.lineJoin="round",t.stroke()}function Ti({ctx:t,grid:e,colors:r},[n,o],s){t.globalAlpha=s,Oo(t,H(
e,o+.5),G(e,n+.5),Math.max(7,e.cell*vi)),t.strokeStyle=r.collision,t.lineWidth=Math.max(2,e.cell*.17),t.lineCap="round",t.stroke()}function Vo({ctx:t,grid:e,colors:r},n,o){
let s=Math.max(1,e.cell*.07);t.strokeStyle=t.fillStyle=r.collision,t.lineWidth=Math.max(1,e.cell*.05),t.setLineDash([e.cell*.14,e.cell*.1]);for(let[a,i]of n){if(a<
0||i<0||a>=e.rows||i>=e.cols)continue;let l=[H(e,i)+s,G(e,a)+s,e.cell-2*s,e.cell-2*s];t.globalAlpha=.2*o,t.fillRect(...l),t.globalAlpha=o,t.strokeRect(...l)}t.setLineDash(
[]),t.globalAlpha=1}function Ko({ctx:t,grid:e,colors:r},n,o,s,a){t.globalAlpha=a,ke(t,H(e,n),G(e,o),Math.max(8,e.cell*s*1.02)),t.strokeStyle=r.collision,t.lineWidth=
Math.max(1.5,e.cell*.085*Math.sqrt(s)),t.stroke(),t.globalAlpha=1}var Ei=.8,Ci=.92,ki=15,Ri=7,Dr=9;function Yo(t,e,r,n,o,s){n.forEach((a,i)=>{a.alpha>0&&$i(t,e,r,i,a,o,s)}),t.ctx.globalAlpha=1;for(let a of pt(e,r).values())a.length>
Dr&&Oi(t,n[a[Dr-1]],a.length-Dr+1)}function $i(t,e,r,n,o,s,a){let{ctx:i,grid:l,colors:c}=t,u=Ce(e,n),[p,d]=[H(l,o.x),G(l,o.y)],h=Math.max(4,l.cell*o.size*(u?Ci:
Ei)),y=Be(t,e,n),f=!u&&!!r.captured[n-e.nPursuers];if(i.globalAlpha=o.alpha,(u?zt:ke)(i,p,d,h),h>Ri*a&&(i.strokeStyle=c.paper,i.lineWidth=Math.max(2,h*.1),i.stroke()),
i.fillStyle=f?c.paper:y,i.fill(),f&&(ke(i,p,d,h*.82),i.strokeStyle=y,i.lineWidth=h*.18,i.stroke()),!s||h<ki*a)return;let g=String(u?n:n-e.nPursuers),w=h*(u?.4:.5)*
(g.length>1?.8:1);Bt(t,g,p,d+h*(u?.17:.03),w,f?y:c.paper)}function Oi(t,e,r){let{cell:n}=t.grid;Bt(t,`+${r}`,H(t.grid,e.x),G(t.grid,e.y),n*.3,t.colors.ink,n*.1)}var _i=.46,Pi=.86,Ni=.66,qo=.48,Li=.78,Ii=.58;function Zo(t,e,r,n){let[o,s]=[e.moments[r-1],e.moments[r]];if(!o)return;let{ctx:a,grid:i,colors:l}=t;a.strokeStyle=
l.collision,a.lineWidth=Math.max(1.5,i.cell*.07),a.lineCap="butt",a.globalAlpha=n;for(let c=0;c<s.alive.length;c++)Ut(o,s,c)&&Ui(t,e,k(o,c),Wt(o,s,c));a.globalAlpha=
1}function Ui({ctx:t,grid:e},r,n,o){let[s,a]=[o[1]-n[1],o[0]-n[0]],i=p=>H(e,n[1]+.5+s*p),l=p=>G(e,n[0]+.5+a*p),c=Ir(r,o)?Li:Ii;t.setLineDash([e.cell*.09,e.cell*
.06]),t.beginPath(),t.moveTo(i(qo),l(qo)),t.lineTo(i(c),l(c)),t.stroke(),t.setLineDash([]);let u=.17*e.cell/Math.hypot(s,a);t.beginPath(),t.moveTo(i(c)-a*u,l(c)+
s*u),t.lineTo(i(c)+a*u,l(c)-s*u),t.stroke()}function Jo(t,e,r,n,o,s){let a=De[s];if(!s||!a)return;let{ctx:i,grid:l,colors:c}=t,u=Ir(e,[n[0]+a[0],n[1]+a[1]])?Pi:
Ni,p=_i*o.size,d=[H(l,o.x+a[1]*p),G(l,o.y+a[0]*p),H(l,o.x+a[1]*u),G(l,o.y+a[0]*u)],h=Math.max(1.5,l.cell*.085);i.lineCap=i.lineJoin="round";for(let[y,f]of[[c.paper,
h*2.1],[Be(t,e,r),h]])i.strokeStyle=y,i.lineWidth=f,Po(i,...d,l.cell*.2),i.stroke()}var Qo={numbers:!0,axes:!1,trail:6,viewers:[],plan:null,selected:null,cursor:null,you:null,fog:!1};function es(t,e,r,n,o){let{ctx:s,grid:a,colors:i}=t,l=Math.min(
Math.ceil(r),e.moments.length-1),c=e.moments[l],u=r===l,p=Dt(e,r),d=u?1:Math.max(0,1-2*(l-r));s.clearRect(0,0,s.canvas.width,s.canvas.height),Io(t);for(let f of n.
viewers)p[f]?.alpha&&Ho(t,e,f,...Fr(e,f,r));Uo(t,e),n.axes&&Fo(t,o),Go(t,e,r,n.trail,p),Vo(t,c.contested??[],d),jo(t,e,r),Zo(t,e,l,d),p.forEach(({x:f,y:g,size:w},b)=>{
let v=So(c,b)?.4:0,S=Wr(c,b)?1:v;S&&Ko(t,f,g,w,S*d)});let h=u?c:e.moments[Math.max(0,l-1)];if(Yo(t,e,h,p,n.numbers,o),u&&n.plan)for(let[f,g]of p.entries())g.alpha&&
Jo(t,e,f,k(c,f),g,n.plan[f]??0);n.you!==null&&(n.fog&&zo(t,e,...Fr(e,n.you,r)),Bo(t,p[n.you],o)),s.lineWidth=Math.max(2,2.5*o),s.strokeStyle=i.focus;let y=n.selected===
null?void 0:p[n.selected];y?.alpha&&Xo(t,y.x,y.y,y.size*.96),n.cursor&&(s.setLineDash([a.cell*.12,a.cell*.08]),Xo(t,n.cursor[1]+.5,n.cursor[0]+.5,.8),s.setLineDash(
[]))}function Xo({ctx:t,grid:e},r,n,o){let s=o*e.cell;t.beginPath(),t.roundRect(e.left+r*e.cell-s/2,e.top+n*e.cell-s/2,s,s,s*.1),t.stroke()}var ts=(t,e)=>(e+.24)/(t+.24);function rs(t,e,r,n,o,s){let a=r?28*s:0,i=(c,u)=>(c-a)/(u+2*.12),l=Math.max(1,Math.floor(Math.min(i(n,e),i(o,t))));return{rows:t,cols:e,
cell:l,left:Math.round((n-e*l+a)/2),top:Math.round((o-t*l+a)/2)}}function ns(t,e,r){let n=Math.floor((r-t.top)/t.cell),o=Math.floor((e-t.left)/t.cell);return n>=
0&&n<t.rows&&o>=0&&o<t.cols?[n,o]:null}var Wi=["paper","line","frame","ink","muted","obstacle"],Fi=["pursuer","evader","capture","collision","focus"];function Ht(t){let e=getComputedStyle(t),r=(n,o)=>[
n,e.getPropertyValue(o+n).trim()];return Object.fromEntries([...Wi.map(n=>r(n,"--board-")),...Fi.map(n=>r(n,"--"))])}var Ge=()=>matchMedia("(prefers-reduced-motion: reduce)").matches,He=class{canvas;#e=null;#r=0;#t;#n={rows:1,cols:1,left:0,top:0,cell:1};#a=0;constructor(e,r={}){
this.canvas=e,e.classList.add("board"),e.setAttribute("role","img"),this.#t={...Qo,...r},new ResizeObserver(()=>this.#u()).observe(e),new MutationObserver(()=>this.
redraw()).observe(document.documentElement,{attributes:!0}),addEventListener("beforeprint",()=>this.drawNow())}set look(e){this.#t={...this.#t,...e},this.#s(),this.
redraw()}show(e,r){this.#e=e,this.#r=Math.min(Math.max(0,r),e.moments.length-1),this.#s(),this.redraw()}redraw(){this.#a||(this.#a=requestAnimationFrame(()=>this.
drawNow()))}drawNow(){cancelAnimationFrame(this.#a),this.#a=0;let e=this.canvas.getContext("2d");if(!e||!this.#e)return;let{rows:r,cols:n}=this.#e,o=devicePixelRatio||
1;this.#n=rs(r,n,this.#t.axes,this.canvas.width,this.canvas.height,o);let s={ctx:e,grid:this.#n,colors:Ht(this.canvas)};es(s,this.#e,this.#r,this.#t,o)}cellAt(e,r){
let n=this.canvas.getBoundingClientRect(),o=this.canvas.width/n.width;return ns(this.#n,(e-n.left)*o,(r-n.top)*o)}agentAt(e,r){let n=this.cellAt(e,r);if(!n||!this.#e)
return null;let o=this.#e.moments[Math.round(this.#r)],s=pt(this.#e,o).get(n[0]*this.#e.cols+n[1])??[],a=Dt(this.#e,Math.round(this.#r)),i=l=>{let[c,u]=this.pointOf(
a[l].x,a[l].y);return Math.hypot(c-e,u-r)};return s.length?s.reduce((l,c)=>i(c)<i(l)?c:l):null}pointOf(e,r){let n=this.canvas.getBoundingClientRect(),o=n.width/
this.canvas.width,{left:s,top:a,cell:i}=this.#n;return[n.left+(s+e*i)*o,n.top+(a+r*i)*o]}#s(){if(!this.#e)return;let{rows:e,cols:r}=this.#e;this.canvas.style.setProperty(
"--board-aspect",String(ts(e,r)))}#u(){let e=devicePixelRatio||1,{width:r,height:n}=this.canvas.getBoundingClientRect();this.canvas.width=Math.max(1,Math.round(
r*e)),this.canvas.height=Math.max(1,Math.round(n*e)),this.drawNow()}};function zr(t,e,r){let{rows:n,cols:o,n_pursuers:s,fov:a,rules:{interaction:i}}=t;return{rows:n,cols:o,nPursuers:s,fov:a,interaction:i,obstacles:e,moments:r}}function Br(t,e){
return{positions:t.read("last_positions"),alive:t.read("alive"),captured:t.read("captured"),everCaptured:t.read("ever_captured"),actions:e,involved:t.read("invo\
lved"),fault:t.read("fault"),contested:t.conflicts().map(r=>r.cell)}}function os(t){let e=Array.from({length:t.length+1},(r,n)=>Di(t,n));return zr(t.config,t.map,
e)}function Di(t,e){let r=t.n_agents,n=t.config.n_evaders,o=(a,i,l)=>a.subarray(i*l,(i+1)*l),s={positions:o(t.last_positions,e,2*r),alive:o(t.alive,e,r),captured:o(
t.captured,e,n),everCaptured:o(t.ever_captured,e,n)};return e===0?s:{...s,actions:o(t.actions,e-1,r),involved:o(t.involved,e-1,3*r),fault:o(t.fault,e-1,3*r),get contested(){
return t.conflicts(e).map(a=>a.cell)}}}var zi=Array.from({length:16},(t,e)=>{let[r,n]=[e%2?6.5:11,Math.PI*e/8];return`${12+r*Math.sin(n)} ${12-r*Math.cos(n)}`}).join(" ");function ss(){let t=[["pursu\
er",x("path",{d:"M12 3 22 20H2z",class:"filled-pursuer"})],["evader",x("circle",{cx:12,cy:12,r:9,class:"filled-evader"})],["capture",x("polygon",{points:zi,class:"\
filled-capture"})],["captured evader",x("circle",{cx:12,cy:12,r:7.5,class:"ring-evader"})],["conflict",x("rect",{x:3,y:3,width:18,height:18,class:"dashed-confli\
ct"})]];return m("ul",{class:"shapes small","aria-label":"Shapes on the board"},...t.map(([e,r])=>m("li",{},x("svg",{viewBox:"0 0 24 24","aria-hidden":"true"},r),
e)))}var Bi={first:"M6 5v14M19 5 9 12l10 7z",back:"M17 5 7 12l10 7z",play:"M7 4.5 19 12 7 19.5z",pause:"M8 5v14M16 5v14",forward:"M7 5l10 7-10 7z",last:"M18 5v14M5 5\
l10 7-10 7z"};function as(t){return x("svg",{viewBox:"0 0 24 24","aria-hidden":"true",class:"icon"},x("path",{d:Bi[t]}))}function dt(t,e,r,n){return m("button",
{type:"button",class:"player-button","aria-label":e,title:`${e} (${r})`,onclick:n},as(t))}function Gt(t){let e=dt("play","Play","Space",()=>t.toggle()),r=m("inp\
ut",{type:"range",class:"player-scrub",min:0,step:1,"aria-label":"Step",oninput:()=>{t.pause(),t.jump(Number(r.value))}}),n=m("div",{class:"captures","aria-hidd\
en":"true",title:"Captures"}),o=m("div",{class:"losses","aria-hidden":"true"}),s=m("select",{class:"player-speed","aria-label":"Speed",title:`Steps a second, or\
 the whole in ${Pt} s (+ and -)`,onchange:()=>t.speed=Number(s.value)},m("option",{value:_t},`in ${Pt} s`),...lt.map(p=>m("option",{value:p},`${p} / s`))),a=m("\
output",{class:"player-count"}),i=m("div",{class:"player",role:"group","aria-label":"Player"},dt("first","First step","Home",()=>t.move(-t.length)),dt("back","S\
tep back","←",()=>t.move(-1)),e,dt("forward","Step forward","→",()=>t.move(1)),dt("last","Last step","End",()=>t.move(t.length)),m("div",{class:"scrub"},n,o,
r),a,s),l=(p,d={})=>{let h=m("i",d);return h.style.left=`${100*p/Math.max(1,t.length)}%`,h},c=()=>{n.replaceChildren(...t.marks.map(p=>l(p))),o.replaceChildren(
...t.ticks.map(({step:p,kind:d,size:h,text:y})=>{let f=l(p,{class:d,title:`Step ${p}: ${y}`});return f.style.height=`${100*h}%`,f}))},u=()=>{e.replaceChildren(as(
t.playing?"pause":"play")),e.ariaLabel=t.playing?"Pause":"Play",e.title=`${e.ariaLabel} (Space)`,r.max=String(t.length),r.value=String(t.step),r.ariaValueText=`\
step ${t.step} of ${t.length}`,a.textContent=`${t.step} / ${t.length}`,a.style.minWidth=`${2*String(t.length).length+3}ch`,s.value=String(t.speed)};return t.addEventListener(
"step",u),t.addEventListener("state",u),t.addEventListener("state",c),i.addEventListener("keydown",p=>{!(p.target instanceof HTMLSelectElement||p.key===" "&&p.target!==
r)&&Fe(t,p)&&p.preventDefault()}),u(),i}var Hi=40,jt=class{element;#e;#r=m("div",{class:"episodes",role:"group","aria-label":"Episodes of this cell"});#t=m("p",{class:"check small numbers","aria-live":"\
polite"});constructor(e){this.#e=e,this.element=m("div",{class:"strip-of-episodes"},this.#r,this.#t)}show(e,r){let{pursuer:n,evader:o,episode:s,seed:a}=this.#e.
selected,i=Me(e,n,o);this.#r.replaceChildren(...(i?.rates??[]).slice(0,Hi).map((d,h)=>this.#n(d,h)));let l=a===null?i?.rates[s]:void 0,c=r.statistics.capture_rate,
u=l!==void 0&&Math.abs(c-l)<1e-6&&r.length===i?.lengths[s],p=i?"Not an episode of the evaluation":"The evaluation played no episodes of this pair.";this.#t.dataset.
equal=String(u),this.#t.textContent=u?"As in the evaluation":l===void 0?p:`Episode ${s+1} differs from the evaluation.`,this.#t.title=`Played here: capture rate\
 ${L(c,3)} in ${r.length} steps.${i?` The cell says ${L(i.rate,3)}.`:""}`}#n(e,r){let{selected:n}=this.#e,o=m("span",{class:"bar"});return o.style.height=`${Math.
round(100*e)}%`,m("button",{type:"button",class:"episode",title:`Episode ${r+1}: capture rate ${L(e)}`,"aria-label":`Episode ${r+1}, capture rate ${L(e)}`,"aria\
-pressed":String(r===n.episode&&n.seed===null),onclick:()=>this.#e.select({episode:r,seed:null})},o,m("span",{class:"count"},r+1))}};var te=["stay","north","east","south","west","northeast","southeast","southwest","northwest"];var is=0,ls=1,Gi=2,ji=176;function us(t,e,r,n){let o=devicePixelRatio||1,s=Ht(t);t.width=t.height=ji*o;let a=t.getContext("2d");if(!a)return;let{fov:i}=e,l=t.width/
i;a.fillStyle=s.paper,a.fillRect(0,0,t.width,t.height);for(let u=0;r&&u<i*i;u++){let[p,d]=[(u%i+.5)*l,(Math.floor(u/i)+.5)*l],h=f=>!!r[f*i*i+u];h(Gi)&&(a.fillStyle=
s.obstacle,a.fillRect(p-l/2,d-l/2,l,l));let y=h(is)&&h(ls)?l*.18:0;h(is)&&cs(a,ke,p+y,d+y,l*.74,s.evader),h(ls)&&cs(a,zt,p-y,d-y,l*.86,s.pursuer)}a.strokeStyle=
n<e.n_pursuers?s.pursuer:s.evader,a.lineWidth=2*o;let c=Math.floor(i/2)*l;a.strokeRect(c,c,l,l)}function cs(t,e,r,n,o,s){e(t,r,n,o),t.fillStyle=s,t.fill()}var Vi=["•","↑","→","↓","←","↗","↘","↙","↖"],ms=t=>{let e=Math.abs(t),r=e>=1e5?e.toExponential(0):e.toFixed(e<10?2:e<100?1:0);return t<0&&Number(
r)?`−${r}`:r};function ps(t,e,r,n){let o=t.kind==="rating"&&!t.hidden.length?t.genome:null,s=(d,h)=>o?o[h]!==0:t.kind==="rating"||new RegExp(`\\b${d}\\b`).test(
n),a=t.inputs.map((d,h)=>({name:d,input:h})).filter(({name:d,input:h})=>s(d,h));o&&a.sort((d,h)=>Math.abs(o[h.input])-Math.abs(o[d.input]));let i=d=>[d===r?"tak\
en":"",e.refused[d]?"refused":""].join(" ").trim(),l=(d,h)=>m("tr",{},...d,...Array.from(h,(y,f)=>m("td",{class:i(f)},ms(y)))),c=o?2:1,u=d=>m("th",{scope:"row",
title:wt[d]},d.replaceAll("_"," ")),p=m("table",{class:"why numbers"},m("thead",{},m("tr",{},m("th",{},o?"term":"input"),o&&m("th",{},"weight"),...Array.from(e.
ratings,(d,h)=>m("th",{scope:"col",class:i(h),title:te[h]+(e.refused[h]?", which the mask forbids":"")},m("span",{"aria-hidden":"true"},Vi[h]),m("span",{class:"\
heard"},te[h]))))),m("tbody",{},...a.map(({name:d,input:h})=>l([u(d),...o?[m("td",{class:"muted"},ms(o[h]))]:[]],o?e.inputs[h].map(y=>y*o[h]):e.inputs[h]))),m("\
tfoot",{},l([m("th",{scope:"row",colspan:c},o?"sum":"rating")],e.ratings)));return[...n?[m("p",{class:"program"},m("code",{},n))]:[],m("div",{class:"wide-table",
tabindex:0,role:"group","aria-label":"Ratings of the moves"},p)]}var ds="What it remembers: a number for each unit, from -1 to 1",Vt=class{element;#e;#r=m("canvas",{class:"seen",role:"img"});#t=m("h3");#n=m("p",{class:"small \
muted"});#a=m("div",{class:"answers"});#s=m("div",{title:ds});#u=null;#f=null;#d=null;#m=null;#p=null;#l=null;#i=0;constructor(e){this.#e=e,this.element=m("div",
{class:"inspector","data-open":"false"},m("p",{class:"hint small muted"},"Click an agent, or press A: what it sees, and why it takes its move."),m("div",{class:"\
inspected"},this.#r,m("div",{class:"answer"},this.#t,this.#n,this.#s),this.#a))}get agent(){return this.#l}show(e,r,n,o){this.#u?.free(),this.#u=e.world(n.config),
this.#d!==r&&(this.#f=null,this.#l!==null&&this.choose(null)),[this.#d,this.#m,this.#p]=[r,n,o]}set solution(e){this.#f=e,this.at(this.#i)}choose(e){this.#l=e,this.
element.dataset.open=String(e!==null),this.#e(e),this.at(this.#i)}next(e){let r=this.#m;if(!r)return;let n=this.#l??(e>0?-1:0);for(let o=0;o<r.n_agents;o++)if(n=
(n+e+r.n_agents)%r.n_agents,r.alive[this.#i*r.n_agents+n])return this.choose(n)}at(e){this.#i=e;let[r,n,o,s,a]=[this.#m,this.#u,this.#d,this.#p,this.#l];if(!r||
!n||!o||!s||a===null)return;let i=a<r.config.n_pursuers?"pursuer":"evader";this.#s.replaceChildren(),this.#t.replaceChildren(m("span",{class:i},K(a,r.config.n_pursuers)));
let l={pursuers:oe(o,"pursuer",s.pursuer),evaders:oe(o,"evader",s.evader)};r.seek(n,e,l);let c=r.actions.subarray(e*r.n_agents,(e+1)*r.n_agents);for(;c.length&&
!n.over&&(a<n.actors[0]||a>=n.actors[1]);)n.playTurn(c);let u=!!(r.alive[e*r.n_agents+a]&&n.read("alive")[a]);us(this.#r,r.config,u?n.view(a):null,a),this.#r.ariaLabel=
`Field of view of ${K(a,r.config.n_pursuers)}: evaders, pursuers and obstacles around it`;let p=c[a]??null;if(!u)return this.#c([],"It is gone.");let d=l[`${i}s`],
h=typeof d!="string"&&d.kind==="cells"?n.answer(d,a):null,y=h?.probabilities??null;h?.memory.length&&this.#s.replaceChildren(m("p",{class:"small muted"},"It rem\
embers:"),qi(h.memory));let f=this.#f?.game(n)??null,g=typeof d=="string"?`The script "${d}" plays for it${p===null?"":`; it goes ${te[p]}`}.`:d.kind!=="cells"?
"It takes the best move that is allowed; of equal ones any.":d.sampled?"Its action is drawn from these probabilities.":"It takes the most probable action.",w=[[
"network",y],["perfect",f?.marginal(a)??null]],b=v=>m("p",{class:"small muted"},v);this.#c([...f?[b(`Value ${f.value.toFixed(2)} under perfect play.`)]:[],...Ki(
w,p),...typeof d=="string"||d.kind==="cells"?[]:ps(d,n.rate(d,a),p,lo(o,i,s[i]))],p===null?"The episode is over.":g)}#c(e,r){this.#a.replaceChildren(...e),this.#n.
textContent=r}};function Ki(t,e){let r=t.filter(([,s])=>s);if(!r.length)return[];let n=m("div",{class:"action muted"},m("span"),...r.map(([s])=>m("span",{class:"\
head"},s))),o=Array.from(r[0][1],(s,a)=>m("div",{class:a===e?"action taken":"action"},m("span",{},te[a]),...r.flatMap(([,i])=>Yi(i[a]))));return r.length>1||r[0][0]!==
t[0][0]?[n,...o]:o}function Yi(t){let e=m("span",{class:"filled"});return e.style.width=`${100*t}%`,[m("span",{class:"track"},e),m("span",{class:"numbers"},t.toFixed(
2))]}function qi(t){let e=Array.from(t,r=>{let n=m("span",{title:r.toFixed(2)});return n.style.transform=`scaleY(${r})`,n});return m("div",{class:"units",role:"\
img","aria-label":ds},...e)}function hs(t){let e=JSON.stringify(t,(r,n)=>r==="genome"?Array.from(n):n);return m("script",{type:"application/json",id:"champions"},e.replaceAll("<","\\u003c")).
outerHTML}var fs="champion",ys=0,Hr=64,Gr=100;var Zi=(t,e)=>Object.keys(t).every(r=>t[r]===e[r]);function gs(t,e){return Object.keys(e).find(r=>Zi(e[r],t))??null}var ht="_",Ji="n",dm=2n**64n-1n;var jr={fov:11,maxSteps:500,rewards:"paper"},Xi=["rules","others","rewards","size","diagonal","fov","limit","seed","ended","walls","pursuers","evaders","played",
"next"];function ws(t,e){let r=i=>i.map(l=>el(l,e)).join(""),n=i=>`${Math.floor(i/t.cols)}.${i%t.cols}`,o=Qi(t.rewards,e),s=[t.seed,t.episode,t.steps].join("."),a={rules:bs(
t.rules,e),others:t.others?bs(t.others,e):"",rewards:o===jr.rewards?"":o,size:`${t.rows}x${t.cols}`,diagonal:t.diagonal?"1":"",fov:t.fov===jr.fov?"":String(t.fov),
limit:t.maxSteps===jr.maxSteps?"":String(t.maxSteps),seed:s==="0.0.0"?"":s,ended:t.ended?"1":"",walls:t.walls.map(n).join(ht),pursuers:t.pursuers.map(vs).join(ht),
evaders:t.evaders.map(vs).join(ht),played:t.played.map(r).join(ht),next:t.next.every(i=>i===ys)?"":r(t.next)};return Xi.filter(i=>a[i]).map(i=>`${i}=${a[i]}`).join(
"&")}function vs({cell:t,gone:e,captured:r,everCaptured:n}){let o=r?"c":n?"e":"";return`${t[0]}.${t[1]}${o}${e?"x":""}`}function bs(t,e){let r=e.fields.map(({name:n})=>String(
t[n]).toLowerCase());return gs(t,e.variants)??r.join(".")}function Qi(t,e){let r=JSON.stringify(t);return Object.keys(e.rewards).find(o=>JSON.stringify(e.rewards[o])===
r)??Object.values(t).map(o=>String(o)).join(ht)}function el(t,e){if(typeof t=="number")return String(t);if(t===fs)return Ji;let r=e.scripts.findIndex(({name:n})=>n===
t);return String.fromCharCode(97+r)}var tl="/* the engine */";function xs(t,e){return m("button",{type:"button",class:"to-playground",title:"Open this step in the playground (G): the same agents a\
nd actions under any rules",onclick:()=>Vr(t(),e)},"What if?")}function Vr(t,e){let r=t!==null&&t.match.n_agents<=Gr&&Math.max(t.match.config.rows,t.match.config.
cols)<=Hr,n=r?ws(rl(t.match,t.step),e):"",o=new TextDecoder().decode(Pr("playground")).replace(tl,()=>Ot("script-engine")).replace("</noscript>",s=>r?s+hs(t.champions):
s);window.open(`${URL.createObjectURL(new Blob([o],{type:"text/html"}))}#${n}`)}function rl(t,e){let{config:r,n_agents:n}=t,o=Math.max(0,e-1),s=i=>{let l=o*n+i,
c=o*r.n_evaders+i-r.n_pursuers,u=p=>i>=r.n_pursuers&&!!p[c];return{cell:[t.last_positions[2*l],t.last_positions[2*l+1]],gone:!t.alive[l],captured:u(t.captured),
everCaptured:u(t.ever_captured)}},a=Array.from({length:n},(i,l)=>s(l));return{rules:r.rules,others:null,rewards:r.rewards,rows:r.rows,cols:r.cols,diagonal:r.diagonal,
fov:r.fov,maxSteps:r.max_steps,seed:t.seed,episode:BigInt(t.episode),steps:o,ended:o===t.length,walls:Array.from(t.map.keys()).filter(i=>t.map[i]),pursuers:a.slice(
0,r.n_pursuers),evaders:a.slice(r.n_pursuers),played:[],next:Array.from(t.actions.subarray(o*n,(o+1)*n))}}var Kr=.005,Ms=.05,nl=["pursuer","evader"],ol=4,je=new Map;function Kt(t,e,r="capture-rate"){let n=JSON.stringify([{...e,rewards:null},r]),o=je.get(n)??(Tt(e)?Promise.
resolve(null):sl(t,e,r));return je.delete(n),je.set(n,o),je.size>ol&&je.delete([...je.keys()][0]),o}var As=({n_evaders:t})=>t===1?"capture-time":"capture-rate",
Ss=()=>new Promise(t=>setTimeout(t));async function sl(t,e,r){await Ss();let n=t.solution(e,r);for(;n.goBack();)await Ss();return n}function Yt(t,e,r){let{payoff:n}=t;
return r.flatMap((o,s)=>{let a=[0,0];for(let l=e.n_turns;l>0&&!e.over;l--)t.game(e)?.lost(o).forEach((c,u)=>a[u]+=c),e.playTurn(o);let i=n==="capture-rate"?Kr:Ms;
return nl.map((l,c)=>({step:s+1,team:l,lost:a[c],payoff:n})).filter(l=>l.lost>=i)})}var qt=t=>t.map(e=>({step:e.step,kind:e.team,size:e.lost/Math.max(1,...t.map(
({lost:r})=>r)),text:ft(e)})),Ts=({lost:t,payoff:e})=>e==="capture-rate"?`${t.toFixed(2)} of the capture rate`:`${t.toFixed(1)} steps`,ft=t=>`The ${t.team}s los\
e ${Ts(t)} against a perfect opponent`;function Es(t){let e=t.reduce((r,n)=>n.lost>r.lost?n:r);return`Your team's worst moves, in step ${e.step}, lost ${Ts(e)} \
against a perfect opponent.`}function Cs({config:t,payoff:e},{value:r},n){if(e==="capture-rate")return`value ${r.toFixed(2)}`;let[o,s]=[1-r,Math.min(t.max_steps-
n,vr)];return o>s-Ms?`free for ${s} steps`:`captured after ${o.toFixed(1)} steps`}function ks(t,e){return(t.marginal(e)??[]).map((n,o)=>({share:n,action:o})).filter(
({share:n})=>n>=Kr).sort((n,o)=>o.share-n.share).map(({share:n,action:o})=>n>1-Kr?te[o]:`${te[o]} ${n.toFixed(2)}`).join(", ")}function Zt(t,e,r){if(r===0)return[{kind:"start",text:al(t),agents:[]}];let[n,o]=[e.moments[r-1],e.moments[r]],s=u=>K(u,t.config.n_pursuers),a=mt(e,n,o),i=t.conflicts(
r),l=new Set(i.flatMap(u=>u.doomed)),c=a.map(u=>({kind:"capture",text:`${s(u)} is captured`,agents:[u]}));for(let u of Ft(n,o))!a.includes(u)&&!l.has(u)&&c.push(
{kind:"end",text:`${s(u)} disappears`,agents:[u]});return c.push(...i.map(({kind:u,text:p,agents:d})=>({kind:u,text:p,agents:d}))),r===t.length&&c.unshift({kind:"\
end",text:il(t),agents:[]}),c}function al({config:t}){return`${t.n_pursuers} pursuers and ${t.n_evaders} evaders on ${t.rows} x ${t.cols} cells, at most ${t.max_steps}\
 steps`}function il(t){let e=Math.round(t.statistics.capture_rate*t.config.n_evaders);return`The episode ends after ${t.length} steps with ${e} of ${t.config.n_evaders}\
 evaders captured`}var ll=60,Jt=class{element;player=new We(0,{speed:_t,still:Ge()});inspector;match=null;recording=null;actions;#e;#r;#t;#n;#a=m("h2",{class:"match-title"});#s=m(
"p",{class:"tally numbers"});#u=m("ol",{class:"words",tabindex:0,"aria-live":"off","aria-label":"What happened in this step"});#f=m("p",{class:"problem",role:"a\
lert"});#d=m("div",{class:"shown","aria-live":"polite"});#m=null;#p=null;#l=0;#i=!1;#c=0;#o=[];constructor(e,r,n){[this.#r,this.#t]=[e,r];let o=m("canvas",{"ari\
a-label":"The match",onclick:({clientX:s,clientY:a})=>this.inspector.choose(this.#e.agentAt(s,a))});this.#e=new He(o,{numbers:!1}),this.#n=new jt(r),this.inspector=
new Vt(s=>this.#T(s)),this.actions=m("div",{class:"beside"},m("button",{type:"button",class:"to-play",title:"Move the chosen agent, or an evader, yourself from \
this step on (T)",onclick:()=>this.element.dispatchEvent(new Event("takeover"))},"Take over"),n&&xs(()=>this.shown,n)),this.element=m("section",{class:"card mat\
ch-card","aria-label":"Match",id:"match"},m("div",{class:"match"},m("header",{class:"match-head"},this.#a,this.#s),this.#f,this.#d,m("div",{class:"stage"},o),m(
"div",{class:"aside"},this.#u,ss(),this.actions,this.inspector.element),Gt(this.player),this.#n.element)),this.player.addEventListener("frame",()=>this.recording&&
this.#e.show(this.recording,this.player.time)),this.player.addEventListener("step",()=>this.#S()),r.on("match",()=>this.#g()),this.#x(),this.#M(0,0)}get#h(){return this.#r[this.#t.
selected.run]}reveal(){(this.#h.game?this.#d:this.#e.canvas).scrollIntoView({block:"nearest"})}get shown(){return this.match&&this.#p&&{match:this.match,step:this.
player.step,champions:this.#p}}start(e){this.#m=e,this.#v()}playSoon(){this.#i=!0,this.#l||this.#y()}goTo(e){this.#c=e,!this.#l&&this.match&&this.#v()}#y(){!this.#i||
!this.match||(this.#i=!1,this.player.jump(0),Ge()||this.player.play())}#g(){this.#x(),clearTimeout(this.#l),this.#l=setTimeout(()=>this.#v(),ll)}#v(){clearTimeout(
this.#l),this.#l=0,this.player.pause(),this.#x();let{selected:e}=this.#t,{game:r}=this.#h;if(this.#d.replaceChildren(...r?so(this.#h,r,e,this.#t):[]),r){this.match=
this.recording=null,this.#i=!1,this.#b(e);return}let n=le.map(a=>Rt(this.#h,a,e[a])).find(Boolean)??"";if(this.#f.textContent=n,n||!this.#m)return;this.match=$t(
this.#m,this.#h,e);let[o,s]=this.names(e);this.#p={pursuer:{name:o,policy:oe(this.#h,"pursuer",e.pursuer)},evader:{name:s,policy:oe(this.#h,"evader",e.evader)}},
this.recording=os(this.match),this.#n.show(this.#h,this.match),this.inspector.show(this.#m,this.#h,this.match,e),this.player.length=this.match.length,this.player.
marks=Mo(this.recording),this.#o=this.player.ticks=[],this.player.jump(this.#c),this.#c=0,this.#S(),this.#w(this.#m,this.match),this.#b(e),this.#y()}#b({run:e,pursuer:r,
evader:n,episode:o,seed:s}){this.element.dataset.played=`${e} ${r} ${n} ${o} ${s??""}`}async#w(e,r){let n=await Kt(e,r.config);if(this.match!==r||!n)return;let o=e.
world(r.config);r.seek(o,0),this.#o=Yt(n,o,cl(r)),o.free(),this.player.ticks=qt(this.#o),this.inspector.solution=n,this.#S()}names({run:e,pursuer:r,evader:n}){let o=this.#r[e],
{teams:s}=o;return[s.pursuer.script??B(o,"pursuer",r),s.evader.script??B(o,"evader",n)]}#x(){let{episode:e,seed:r}=this.#t.selected,{game:n,payoff:o}=this.#h;this.
element.classList.toggle("of-own-game",!!n);let[s,a]=this.names(this.#t.selected),i=r===null?e<o.episodes?`episode ${e+1} of ${o.episodes}`:`episode ${e+1}, not\
 part of the cell`:`seed ${r}`;this.#a.replaceChildren(m("span",{class:"pursuer"},ge(s))," against ",m("span",{class:"evader"},a),n?"":m("span",{class:"muted sm\
all"},i))}#S(){let e=this.match;if(!e||!this.recording)return;let r=this.player.step,n=this.recording.moments[r];this.#M(Array.from(n.everCaptured).filter(Boolean).
length,r),this.#u.replaceChildren(...this.#o.filter(o=>o.step===r).map(o=>m("li",{class:`loss-${o.team}`},ft(o))),...Zt(e,this.recording,r).map(o=>m("li",{class:o.
kind,"data-agents":o.agents.join(" ")},o.text))),this.inspector.at(r),this.#A()}#M(e,r){let{world:n}=this.#h;n&&this.#s.replaceChildren(m("strong",{},e),` of ${n.
n_evaders} captured`,m("span",{class:"muted"},` · step ${r}`))}#T(e){this.#e.look={selected:e,viewers:e===null?[]:[e]},this.#A()}#A(){let e=this.inspector.agent;
for(let r of this.#u.children){let n=r.dataset.agents?.split(" ")??[];r.classList.toggle("about",e!==null&&n.includes(String(e)))}}},cl=({actions:t,length:e,n_agents:r})=>Array.
from({length:e},(n,o)=>t.subarray(o*r,(o+1)*r));var ul={ArrowUp:[1,0],ArrowDown:[-1,0],ArrowRight:[0,1],ArrowLeft:[0,-1]},ml=5;function Re(t,e,r,n="pursuer"){t.tabIndex=0,t.setAttribute("role","application"),
t.addEventListener("keydown",o=>{let s=ul[o.key];if(!s)return;let[a,i]=n==="pursuer"?s:[s[1],s[0]],[l,c]=r(),u=o.shiftKey?ml:1,{pursuer:p,evader:d}=e.selected;e.
select({pursuer:Rs(p+u*a,l),evader:Rs(d+u*i,c)}),o.preventDefault(),o.stopPropagation()})}var Rs=(t,e)=>Math.min(e-1,Math.max(0,t));var pl=24,Xt=7,Os=t=>t<pl&&matchMedia("(pointer: coarse)").matches;function _s(t,e,r,n){let[o,s]=t.payoff.shape,[a,i]=[$s(e,o),$s(r,s)],[l,c]=[Math.min(Xt,o),Math.
min(Xt,s)],u=[];for(let f=a+l-1;f>=a;f--){u.push(m("span",{class:"pursuer"},f));for(let g=i;g<i+c;g++)u.push(dl(t,f,g,n))}let p=Array.from({length:c},(f,g)=>m("\
span",{class:"evader"},i+g)),d=m("button",{type:"button","aria-label":"Close: all cells",onclick:()=>n(null)},"✕"),y=m("div",{class:"loupe numbers",role:"grou\
p","aria-label":"Cells around the tap",onclick:f=>f.stopPropagation()},...u,d,...p);return y.style.gridTemplateColumns=`2.4rem repeat(${c}, minmax(0, 1fr))`,y}function dl(t,e,r,n){
let o=m("button",{type:"button",onclick:()=>n({pursuer:e,evader:r})});return It(o,Me(t,e,r)?.rate,`${B(t,"pursuer",e)} against ${B(t,"evader",r)}`),o}var $s=(t,e)=>Math.
max(0,Math.min(e-Xt,t-Math.floor(Xt/2)));var se={left:52,bottom:46,top:76,right:84},pe=10,hl=160,yt=se.right-pe-14,$e=se.top-pe-14,Qt=class{element;#e;#r;#t=m("canvas",{"aria-hidden":"true"});#n=x("svg",
{"aria-hidden":"true"});#a=x("g");#s;#u=m("h2");#f=m("strong",{class:"rate numbers"});#d=m("span",{class:"small muted"});#m=m("p",{class:"of-both-teams small mu\
ted numbers"});#p;#l=null;constructor(e,r){[this.#r,this.#e]=[e,r],this.#s=m("div",{class:"matrix",id:"matrix","aria-label":"Payoff matrix. Arrow keys choose a \
match, Enter plays it.",onpointermove:o=>this.#w(o),onpointerleave:()=>r.point({}),onclick:o=>this.#x(o),onkeydown:({key:o})=>o==="Enter"&&this.#M()},this.#t,this.#n);
let n=m("header",{class:"readout","aria-live":"polite"},m("div",{},this.#u,this.#m),m("div",{class:"of-cell"},this.#f,this.#d));this.#p=ut(..._(this.#i).ends),this.
element=m("section",{class:"card matrix-card","aria-label":"Payoff matrix"},n,this.#s,this.#p),this.#g(),new ResizeObserver(()=>this.#c()).observe(this.#s),this.#s.
addEventListener("mousedown",o=>{o.preventDefault(),document.activeElement instanceof HTMLElement&&document.activeElement.blur()}),Re(this.#s,r,()=>this.#i.payoff.
shape),r.on("run",()=>{let o=ut(..._(this.#i).ends);this.#p.replaceWith(o),this.#p=o,this.#c()}),r.on("match hover",()=>this.#y())}get#i(){return this.#r[this.#e.
selected.run]}#c(){let[e,r]=this.#i.payoff.shape,{clientWidth:n,clientHeight:o}=this.#s;if(n<50)return;let a=Math.max(hl,Math.min(n-se.left-se.right,o-se.top-se.
bottom))/Math.max(e,r),i=Math.max(se.left,(n-r*a-se.right+se.left)/2),l=se.top+Math.max(0,(o-se.top-se.bottom-e*a)/2),c={width:n,height:o,left:i,top:l,cell:a,rows:e,
columns:r};this.#l=c,Lt(this.#t,this.#i.payoff,{left:i,top:l,width:r*a,height:e*a});for(let[u,p,d]of[["left",i,n],["top",l,o],["width",r*a,n],["height",e*a,o]])
this.#t.style.setProperty(u,`${100*p/d}%`);this.#s.style.setProperty("--shape",`${n} / ${o}`),this.#n.setAttribute("viewBox",`0 0 ${n} ${o}`),this.#n.replaceChildren(
fl(c,_(this.#i).generation),...yl(c),...this.#h(c),this.#a),this.#y()}#o(e){let r=this.#i.findings?.generalization;if(!r)return[];let{selected:n,hover:o}=this.#e,
[s,a]=[o.pursuer??n.pursuer,o.evader??n.evader],[i,l]=Ps(e,r.pursuers.mean[s]??0,s),[c,u]=Ns(e,r.evaders.mean[a]??0,a);return[x("circle",{class:"dot of-pursuers",
cx:i,cy:l,r:5}),x("circle",{class:"dot of-evaders",cx:c,cy:u,r:5})]}#h(e){let r=this.#i.findings?.generalization;if(!r)return[];let{left:n,top:o,cell:s,rows:a,columns:i}=e,
{curves:l}=_(this.#i),[c,u]=[n+i*s+pe,o-pe],p={class:"side"};return[x("rect",{...p,x:c,y:o,width:yt,height:a*s}),x("rect",{...p,x:n,y:u-$e,width:i*s,height:$e}),
...Ls(r.pursuers,(d,h)=>Ps(e,d,h),"of-pursuers"),...Ls(r.evaders,(d,h)=>Ns(e,d,h),"of-evaders"),x("text",{class:"tick",x:c,y:o+a*s+16,"text-anchor":"start"},"0"),
x("text",{class:"tick",x:c+yt,y:o+a*s+16,"text-anchor":"end"},"1"),x("text",{class:"tick",x:n-6,y:u-4,"text-anchor":"end"},"0"),x("text",{class:"tick",x:n-6,y:u-
$e+8,"text-anchor":"end"},"1"),x("text",{class:"label of-pursuers",x:c+yt,y:o+a*s+34,"text-anchor":"end"},l.pursuer),x("text",{class:"label of-evaders",x:n+i*s+
pe,y:u-$e+10,"text-anchor":"start"},l.evader)]}#y(){let e=this.#l;if(!e)return;let{selected:r,hover:n}=this.#e,{left:o,top:s,cell:a,rows:i,columns:l}=e,c=y=>s+(i-
1-y)*a,u=[],p=(y,f)=>x("rect",{class:f,x:o,y:c(y),width:l*a+pe+yt,height:a}),d=(y,f)=>x("rect",{class:f,x:o+y*a,y:s-pe-$e,width:a,height:pe+$e+i*a});u.push(p(r.
pursuer,"strip pursuer"),d(r.evader,"strip evader")),n.pursuer!==null&&n.pursuer<i&&u.push(p(n.pursuer,"strip hover")),n.evader!==null&&n.evader<l&&u.push(d(n.evader,
"strip hover")),u.push(...this.#o(e));let h={x:o+r.evader*a,y:c(r.pursuer),width:a,height:a};u.push(x("rect",{class:"chosen under",...h}),x("rect",{class:"chose\
n",...h})),this.#a.replaceChildren(...u),this.#g()}#g(){let{selected:e,hover:r}=this.#e,n=r.pursuer??e.pursuer,o=r.evader??e.evader,s=Me(this.#i,n,o);this.#u.replaceChildren(
m("span",{class:"pursuer"},ge(B(this.#i,"pursuer",n)))," against ",m("span",{class:"evader"},B(this.#i,"evader",o))),this.#f.textContent=s?L(s.rate,3):"-";let a=s&&
s.rates.length>1?`, mean of ${s.rates.length} episodes`:"";this.#d.textContent=s?_(this.#i).score+a:"no episodes were played",this.#m.textContent=this.#v(n,o)}#v(e,r){
let n=this.#i.findings?.generalization;if(!n)return"";let o=(a,i)=>no(a.mean[i]??null,a.low?.[i]??null,a.high?.[i]??null),{means:s}=_(this.#i);return`Against al\
l: ${s.pursuer} ${o(n.pursuers,e)}, ${s.evader} ${o(n.evaders,r)}`}#b(e){let r=this.#l;if(!r)return null;let n=this.#s.getBoundingClientRect(),o=Math.floor((e.clientX-
n.left-r.left)/r.cell),s=r.rows-1-Math.floor((e.clientY-n.top-r.top)/r.cell),[a,i]=[s>=0&&s<r.rows,o>=0&&o<r.columns];return a||i?{g:a?s:-1,h:i?o:-1,inside:a&&i}:
null}#w(e){let r=this.#b(e);this.#e.point(r?{pursuer:r.g<0?null:r.g,evader:r.h<0?null:r.h}:{})}#x(e){let r=this.#b(e);if(r){if(r.inside&&Os(this.#l.cell))return this.#S(
r.g,r.h);this.#e.select({...r.g<0?{}:{pursuer:r.g},...r.h<0?{}:{evader:r.h}}),r.inside&&this.#M()}}#S(e,r){let n=_s(this.#i,e,r,o=>{n.remove(),o&&(this.#e.select(
o),this.#M())});this.#s.append(n)}#M(){this.#s.dispatchEvent(new CustomEvent("play",{bubbles:!0}))}};function fl({left:t,top:e,cell:r,rows:n,columns:o},s){let a=x(
"g",{class:"axes"}),i=e+n*r,l=c=>it(0,c-1,Math.min(c,c*r/44),!0);for(let c of l(o))a.append(x("text",{class:"tick",x:t+(c+.5)*r,y:i+16,"text-anchor":"middle"},c));
for(let c of l(n))a.append(x("text",{class:"tick",x:t-7,y:i-(c+.5)*r,"text-anchor":"end","dominant-baseline":"middle"},c));return a.append(x("text",{class:"labe\
l of-evaders",x:t+o*r/2,y:i+36,"text-anchor":"middle"},s.evader),x("text",{class:"label of-pursuers",transform:`translate(${t-36} ${e+n*r/2}) rotate(-90)`,"text\
-anchor":"middle"},s.pursuer)),a}function yl({left:t,top:e,cell:r,rows:n,columns:o}){let s=x("g",{class:"diagonal"}),a=Math.min(n,o);if(a<3)return[];let i=e+n*r;
for(let u of["H","V"]){let p=`M${t} ${i}`;for(let d=1;d<=a;d++){let[h,y]=[`H${t+d*r}`,`V${i-d*r}`];p+=u==="H"?h+y:y+h}s.append(x("path",{d:p,class:"under"}),x("\
path",{d:p}))}let[l,c]=[t+a/2*r-.7*r-4,i-a/2*r-.7*r-4];return[s,x("text",{class:"on-cells",transform:`translate(${l} ${c}) rotate(-45)`,"text-anchor":"middle"},
"same generation")]}var Ps=({left:t,top:e,cell:r,rows:n,columns:o},s,a)=>[t+o*r+pe+s*yt,e+(n-a-.5)*r],Ns=({left:t,top:e,cell:r},n,o)=>[t+(o+.5)*r,e-pe-n*$e];function Ls(t,e,r){
let n=s=>s.map((a,i)=>e(a??0,i).map(l=>l.toFixed(1)).join(" ")),o=[];return t.low&&t.high&&o.push(x("path",{class:`band ${r}`,d:`M${[...n(t.high),...n(t.low).reverse()].
join("L")}Z`})),o.push(x("path",{class:`line ${r}`,d:`M${n(t.mean).join("L")}`})),o}function ve(t,e,...r){return m("section",{class:"card panel","aria-label":t},m("header",{},m("h2",{},t),m("p",{class:"small muted"},e)),...r)}var gl={present:"●",
absent:"○","cannot tell":"?"};function Is(t){let{findings:e}=t;if(!e?.table.length)return null;let[,...r]=e.table,n=r.map(([s,a,i,l],c)=>{let u=vl(e.reasons[c]??
"");return m("li",{class:`finding ${a.replace(" ","-")}`},m("span",{class:"sign","aria-hidden":"true"},gl[a]??""),m("div",{},m("p",{},m("strong",{},s),` ${a}`,m(
"span",{class:"muted"},` · ${l}`)),u?m("p",{class:"small"},`${u}.`):null,m("p",{class:"small muted numbers"},i)))}),o=ve("What happened","Each condition is pre\
sent, absent, or its 95 % interval cannot tell. The intervals are about this run.",m("p",{class:"headline"},e.sentence),m("p",{},e.headline),...e.numbers.map(s=>m(
"p",{class:"numbers"},`${ge(s)}.`)),m("ul",{class:"findings"},...n),t.limits?m("p",{class:"small"},t.limits):null);return o.classList.add("diagnosis"),{element:o}}
function vl(t){let[,e=""]=t.split(/, because (.*)/s);return ge(e.replace(/\.$/,""))}function Us({settings:t,schedule:e,seed:r}){let n=t.map(({name:a,value:i,help:l})=>m(
"tr",{},m("th",{scope:"row"},`--${a.replaceAll("_","-")}`),m("td",{class:"numbers"},i),m("td",{class:"muted"},l))),o=m("table",{class:"small"},m("caption",{class:"\
heard"},"Settings other than the default"),...n),s=ve("Settings",`${e}, seed ${r}; all others are the defaults of matrixworld evolve.`,n.length?m("div",{class:"\
wide-table"},o):null);return s.classList.add("settings"),{element:s}}function Ws(t,e,r){let{findings:n}=t,{teams:o,click:s}=_(t);if(!n?.table.length)return null;let a=n.checkerboards.map(i=>bl(t,i,(l,c)=>{e.select({pursuer:l,evader:c}),
r()}));return{element:ve("Checkerboards",`Two generations of each team: each generation of the ${o.pursuer} is better against another one of the ${o.evader}. Cl\
ick a cell to ${s}.`,a.length?m("div",{class:"boards"},...a):m("p",{},`No four cells differ by more than ${n.margin} in this way.`),a.length&&!t.game?.exact?m("\
p",{class:"small muted"},"The strongest of all pairs, so noise makes them look stronger than they are. The diagnosis says whether there are more than noise make\
s."):null)}}function bl(t,{pursuers:e,evaders:r},n){let o=(s,a)=>{let i=m("button",{type:"button",class:"cell",onclick:()=>n(s,a)});return It(i,t.payoff.capture_rate[s][a],
`${B(t,"pursuer",s)} against ${B(t,"evader",a)}`),i};return m("div",{class:"miniature numbers"},m("span"),...r.map(s=>m("span",{class:"evader"},s)),...e.flatMap(
s=>[m("span",{class:"pursuer"},s),...r.map(a=>o(s,a))]))}var er={pursuer:"evader",evader:"pursuer"};function Fs(t,e){let r=t.findings?.ciao;if(!r)return null;let n=["pursuer","evader"].map(o=>{let{fading:s,stripes:a,period:i}=r[`${o}\
s`],l=`fading ${L(s)}, stripes ${L(a)}${i===null?"":` every ${i} generations`}`;return wl(t,o,l,e)});return{element:ve("CIAO: current individuals against ancest\
ral opponents","The team's own score. Stripes: intransitive, since wins and losses alternate with the age of the opponent; whether a team returns to earlier str\
ategies is recurrence, under What happened. Darker away from the diagonal: forgetting.",m("div",{class:"triangles"},...n.map(o=>o.element)),ut("0 loses","1 wins")),
update:()=>n.forEach(o=>o.update())}}function wl(t,e,r,n){let o=e==="pursuer"?0:1,s=_(t),[a,i]=[t.payoff.shape[o],t.payoff.shape[1-o]],l=t.payoff.capture_rate,c=Array.
from({length:a},(b,v)=>Array.from({length:Math.min(v+1,i)},(S,T)=>e==="pursuer"?l[v][T]:1-l[T][v])),u=Nr({shape:[a,i],first:[0,0],capture_rate:c}),p=x("rect",{class:"\
chosen",width:1,height:1}),d=x("rect",{class:"chosen under",width:1,height:1}),h=x("svg",{viewBox:`0 0 ${i} ${a}`,preserveAspectRatio:"none","aria-hidden":"true"},
d,p),y=m("div",{class:"triangle","aria-label":`CIAO of the ${s.teams[e]}: ${r}. Arrow keys choose a match.`,onpointermove:b=>n.point(f(b)??{}),onpointerleave:()=>n.
point({}),onclick:b=>f(b)&&n.select(f(b))},u,h);Re(y,n,()=>t.payoff.shape,e),y.style.aspectRatio=`${i} / ${a}`;let f=b=>{let v=y.getBoundingClientRect(),S=Math.
floor((b.clientX-v.left)/v.width*i),T=a-1-Math.floor((b.clientY-v.top)/v.height*a);return S>=0&&T<a&&S<=T?{[e]:T,[er[e]]:S}:null},g=()=>{let b=n.hover[e]??n.selected[e],
v=n.hover[er[e]]??n.selected[er[e]];for(let S of[p,d])S.setAttribute("x",String(v)),S.setAttribute("y",String(a-1-b)),S.style.display=v<=b?"":"none"};return{element:m(
"figure",{},m("figcaption",{class:"small"},m("span",{class:e},s.teams[e])),y,m("p",{class:"small muted"},`horizontal: ${s.generation[er[e]]}; vertical: ${s.generation[e]}`),
m("p",{class:"small numbers"},r)),update:g}}var tr={left:46,right:12,top:10,bottom:42},Ds={x:56,y:34};function Yr(t,e,r,n){let[o,s]=[tr.left,tr.top],a=Math.max(o+40,t-tr.right),i=Math.max(s+40,e-tr.bottom),
l=(f,g,w)=>b=>g+(b-f.low)/(f.high-f.low||1)*(w-g),[c,u]=[l(r,o,a),l(n,i,s)],p=x("g"),d=x("svg",{width:t,height:e,viewBox:`0 0 ${t} ${e}`,class:"plot"}),h=x("g",
{class:"axes"});for(let f of it(n.low,n.high,(i-s)/Ds.y,n.whole))h.append(x("line",{x1:o,x2:a,y1:u(f),y2:u(f),class:"grid"}),x("text",{x:o-8,y:u(f),"text-anchor":"\
end","dominant-baseline":"middle"},zs(f)));for(let f of it(r.low,r.high,(a-o)/Ds.x,r.whole))h.append(x("text",{x:c(f),y:i+16,"text-anchor":"middle"},zs(f)));return h.
append(x("line",{x1:o,x2:a,y1:i,y2:i,class:"axis"}),x("text",{x:(o+a)/2,y:e-6,"text-anchor":"middle",class:"label"},r.label),x("text",{transform:`translate(12 ${(s+
i)/2}) rotate(-90)`,"text-anchor":"middle",class:"label"},n.label)),d.append(h,p),{root:d,marks:p,left:o,right:a,top:s,bottom:i,x:c,y:u,at:f=>{let g=f-d.getBoundingClientRect().
left;return r.low+(g-o)/(a-o)*(r.high-r.low)}}}var zs=t=>String(Number(t.toPrecision(6))).replace("-","−");function qr(t,e,r,n){let o="",s="M";r.forEach((a,i)=>{
a===null?s="M":(o+=`${s}${t.x(e[i]).toFixed(1)} ${t.y(a).toFixed(1)}`,s="L")}),t.root.insertBefore(x("path",{d:o,class:`line ${n}`}),t.marks)}function Bs(t,{low:e,
high:r},n){if(!e||!r)return;let o=s=>s.map((a,i)=>`${t.x(i).toFixed(1)} ${t.y(a??0).toFixed(1)}`);t.root.insertBefore(x("path",{d:`M${[...o(r),...o(e).reverse()].
join("L")}Z`,class:`band ${n}`}),t.marks)}function Zr(t,e,r,n=null){let o=t.x(e);t.marks.append(x("line",{x1:o,x2:o,y1:t.top,y2:t.bottom,class:`mark ${r}`})),n!==
null&&t.marks.append(x("circle",{cx:o,cy:t.y(n),r:5,class:`dot ${r}`}))}function Jr(...t){return m("p",{class:"legend small"},...t.map(([e,r])=>m("span",{class:`\
key ${r}`},e)))}function Xr(t,e,r,n){let o=m("div",{class:"chart chooses",role:"img","aria-label":t}),s=null,a=()=>{s?.marks.replaceChildren(),s&&r(s)};o.addEventListener(
"click",l=>s&&n(s.at(l.clientX),s,l));let i=()=>{let{clientWidth:l,clientHeight:c}=o;l<50||c<50||(s=e(l,c),o.replaceChildren(s.root),a())};return new ResizeObserver(
i).observe(o),{element:o,update:a,redraw:i}}var Qr=["of-pursuers","of-evaders","of-both"],xl=2500,Hs="Arrow keys choose generations.";function Gs(t,e){let{training:r}=t,{score:n,teams:o}=_(t),{capture_rate:s,
generation:a,learner:i,epochs:l}=r,c=s.map((g,w)=>(w+1)*l),u=Sl(s,r.window),p=c.at(-1)??1,d=c.length>xl?"dense":"",h=(g,w)=>{let b=a.flatMap((v,S)=>v===g&&(i[S]===
w||i[S]===2)?[S]:[]);return b.length?[c[b[0]],c[b.at(-1)]]:null},y=Xr(`${ge(n)} in ${p} epochs of training. ${Hs}`,(g,w)=>{let b=Yr(g,w,{low:0,high:p,label:"epo\
ch",whole:!0},{low:0,high:1,label:n});for(let[v,S]of[["raw",s],[d,u]])for(let[T,P]of Qr.entries()){let C=S.map((A,M)=>i[M]===T||i[M+1]===T?A:null);C.some(A=>A!==
null)&&qr(b,c,C,`${P} ${v}`)}return b},g=>le.forEach((w,b)=>{let v=h(e.hover[w]??e.selected[w],b);v&&Zr(g,(v[0]+v[1])/2,Qr[b])}),g=>{let w=Math.min(c.length-1,Math.
max(0,Math.round(g/l)-1)),b=a[w];i[w]!==1&&e.select({pursuer:Math.min(b,t.payoff.shape[0]-1)}),i[w]!==0&&e.select({evader:Math.min(b,t.payoff.shape[1]-1)})});Re(
y.element,e,()=>t.payoff.shape);let f=[...new Set(i)].sort().map(g=>[`${[o.pursuer,o.evader,"both teams"][g]} learn`,Qr[g]]);return{element:ve("Training",`${oo(
r.matches)} training matches. Lines: the generations that are selected.`,Jr(...f),y.element),update:y.update}}function js(t,e){let r=t.findings?.ratings;if(!r)return null;
let n={pursuer:r.pursuers,evader:r.evaders},o={pursuer:n.pursuer.mean,evader:n.evader.mean},s=le.flatMap(d=>[n[d].mean,n[d].low??[],n[d].high??[]]).flat().map(d=>d??
0),[a,i]=[Math.min(...s),Math.max(...s)],l=.06*(i-a||1),c=Math.max(...t.payoff.shape)-1,{teams:u}=_(t),p=Xr(`Elo ratings by generation. ${Hs}`,(d,h)=>{let y=Yr(
d,h,{low:0,high:c,label:"generation",whole:!0},{low:a-l,high:i+l,label:"Elo points"});for(let f of le)Bs(y,n[f],`of-${f}s`),qr(y,o[f].map((g,w)=>w),o[f],`of-${f}\
s`);return y},d=>{for(let h of le){let y=e.hover[h]??e.selected[h];Zr(d,y,`of-${h}s`,o[h][y]??null)}},(d,h,y)=>{let f=Math.round(d),g=y.clientY-h.root.getBoundingClientRect().
top,w=v=>Math.abs(h.y(o[v][f]??1/0)-g),b=w("pursuer")<=w("evader")?"pursuer":"evader";f>=0&&f<o[b].length&&e.select({[b]:f})});return Re(p.element,e,()=>t.payoff.
shape),{element:ve("Ratings",`One number for each generation, which cycles do not fit${n.pursuer.low?", with 95 % intervals over episodes":""}. The game itself:\
 ${L(r.offset,0)} points for the ${u.pursuer}.`,Jr([u.pursuer,"of-pursuers"],[u.evader,"of-evaders"]),p.element),update:p.update}}function Sl(t,e){let r=[0];for(let n of t)
r.push(r.at(-1)+n);return t.map((n,o)=>{let[s,a]=[Math.max(0,o-Math.floor((e-1)/2)),Math.min(t.length,o+Math.floor(e/2)+1)];return(r[a]-r[s])/(a-s)})}function Vs(t,e,r){let n=new Map,o=m("div",{class:"panels"}),s=[],a=()=>s.forEach(l=>l.update?.()),i=()=>{let l=t[e.selected.run];s=n.get(l)??Ml(l,e,r),n.set(l,
s),o.replaceChildren(...s.map(c=>c.element)),a()};return e.on("run",i),e.on("match hover",a),i(),o}function Ml(t,e,r){return[Is(t),Gs(t,e),Ws(t,e,r),js(t,e),Fs(
t,e),Us(t)].filter(o=>o!==null)}var Ks={pursuer:null,evader:null},rr=class extends EventTarget{#e;#r=Ks;constructor(e){super(),this.#e=e}get selected(){return this.#e}get hover(){return this.#r}select(e){
let r=this.#e,n=["run","pursuer","evader"].some(o=>o in e&&e[o]!==r[o]);this.#e={...r,...n?{episode:0,seed:null}:{},...e},this.#e.run!==r.run&&this.dispatchEvent(
new Event("run")),this.dispatchEvent(new Event("match"))}point(e){let r={...Ks,...e};r.pursuer===this.#r.pursuer&&r.evader===this.#r.evader||(this.#r=r,this.dispatchEvent(
new Event("hover")))}on(e,r){for(let n of e.split(" "))this.addEventListener(n,r)}};var nr=class{config;start;recording;actions=[];#e;#r;#t=[[]];constructor(e,r,n){[this.config,this.start]=[r,n],this.#e=e.world(r),this.#e.reset(n),this.#r=[Br(this.#e)],
this.recording=zr(r,this.#e.map(),this.#r)}get length(){return this.actions.length}get over(){return this.#e.over}get statistics(){return{capture_rate:this.#e.read(
"capture_rate")[0]}}conflicts(e){return this.#t[e]}game(e){return e.game(this.#e)}play(e){this.#e.step(e),this.#n(e)}step(e,r,n){let[o,s]=[this.#e,this.config.n_pursuers],
a=new Uint8Array(o.n_agents);for(let i=o.n_turns;i>0&&!o.over;--i){let[l,c]=o.actors;l<s&&(a=o.decide(e.pursuer,[l,Math.min(c,s)],a)),c>s&&(a=o.decide(e.evader,
[Math.max(l,s),c],a)),typeof n=="number"?a[r]=n:l<=r&&r<c&&(a=o.decide(n,[r,r+1],a)),o.playTurn(a)}this.#n(a)}#n(e){this.actions.push(e),this.#r.push(Br(this.#e,
e)),this.#t.push(this.#e.conflicts())}};var de=(t,e)=>le[+(e>=t.n_pursuers)];function en(t,e){let r=new nr(t,e.config,{seed:e.seed,episode:e.episode});for(let n of e.moves)r.over||r.step(e.policies,e.
seat,n);return r}function Ve(t,e){let{moments:r,nPursuers:n}=t.recording,o=r.findIndex(({alive:a,captured:i})=>!a[e]||!!i[e-n]),s=o<0?t.length:o;return{lasted:s,
out:o>=0,captured:Array.from(r[s].everCaptured).filter(Boolean).length}}var or=(t,e)=>t.over||Ve(t,e).out;function Ys(t,e,r){let n=en(t,{...e,moves:e.moves.slice(
0,e.from)});for(;!or(n,e.seat);)n.step(e.policies,e.seat,r);return Ve(n,e.seat)}function qs(t){let e=t.length-1;return[...new Set([0,Math.round(e/3),e])].map(r=>t[r])}
function Zs(t,{seat:e,from:r,moves:n}){let o={...t,seat:e,...r?{from:r}:{},moves:n.join("")};return`${location.href.split("#")[0]}#${Object.entries(o).map(([s,a])=>`${s}\
=${a}`).join("&")}`}function Js(t,e){let[r,n,o]=[t.get("seat")??"",t.get("from")??"0",t.get("moves")??""];return/^\d{1,6}$/.test(r)&&Number(r)<e.n_pursuers+e.n_evaders&&
(e.diagonal?/^[0-8]+$/:/^[0-4]+$/).test(o)&&o.length<=e.max_steps&&/^\d{1,6}$/.test(n)&&Number(n)<=o.length?{seat:Number(r),from:Number(n),moves:[...o].map(Number)}:
null}function tn(t,e,r,n,o,s){e.play({title:r,played:n,ending:(a,i)=>[Al(t,a,i,qs(o))],again:()=>tn(t,e,r,{...n,moves:n.moves.slice(0,n.from)},o,s),link:a=>s&&Zs(s,a)})}
function Al(t,e,r,n){let o=de(r.config,r.seat)==="evader",s=o?r.config.max_steps:r.config.n_evaders,a=m("table",{class:"numbers"},m("caption",{},o?"Steps in you\
r seat: same start, same others":"Captures of your team: same start, same others")),i=c=>{let[u,p]=[m("span",{class:o?"bar evader":"bar pursuer"}),m("td",{},"…")];
return a.append(m("tr",{},m("th",{scope:"row"},c),m("td",{class:"track","aria-hidden":"true"},u),p)),({lasted:d,captured:h})=>{u.style.width=`${100*(o?d:h)/s}%`,
p.textContent=String(o?d:h)}};i("You")(Ve(e,r.seat));for(let{name:c,policy:u}of n){let p=i(c);setTimeout(()=>p(Ys(t,r,u())))}let l=r.from?`You took over at step\
 ${r.from}. `:"";return m("div",{},a,m("p",{class:"small muted"},`${l}One match: luck has its part in it.`))}var Xs=["·","↑","→","↓","←","↗","↘","↙","↖"];var Tl={" ":0,ArrowUp:1,w:1,ArrowRight:2,d:2,ArrowDown:3,s:3,ArrowLeft:4,a:4,e:5,c:6,y:7,z:7,q:8},rn=[8,1,5,4,0,2,7,3,6],El=[7,8,9,4,5,6,1,2,3],Cl=24,kl=Math.tan(
Math.PI/8);function ea(t,e){if(t.ctrlKey||t.metaKey||t.altKey)return;let r=El.findIndex(o=>t.code===`Numpad${o}`),n=rn[r]??Tl[t.key.length===1?t.key.toLowerCase():
t.key];return n!==void 0&&n>4&&!e?void 0:n}function ta(t){let e=rn.map(r=>m("button",{type:"button","aria-label":te[r],onclick:()=>t(r)},Xs[r]));return{element:m(
"div",{class:"play-pad",role:"group","aria-label":"Your move"},...e),show:r=>e.forEach((n,o)=>n.classList.toggle("absent",rn[o]>4&&!r))}}function Qs(t,e,r){let n=kl*
Math.max(Math.abs(t),Math.abs(e)),o=s=>Math.abs(s)<n?0:s;return xo([0,0],r?[o(t),o(e)]:[t,e],r)}function ra(t,e,r){let n=null,{canvas:o}=t;o.addEventListener("p\
ointerdown",({button:s,clientX:a,clientY:i})=>n=s===0?[a,i]:null),o.addEventListener("pointercancel",()=>n=null),o.addEventListener("pointerup",({clientX:s,clientY:a})=>{
let[i,l]=[n,e()];if(n=null,!i||!l)return;let[c,u]=[s-i[0],a-i[1]],p=t.cellAt(s,a);Math.hypot(c,u)>=Cl?r(Qs(u,c,l.diagonal)):p&&r(Qs(p[0]-l.cell[0],p[1]-l.cell[1],
l.diagonal))})}function na(t,e){let r=n=>{let o=e[n]-t[n],s=De.findIndex(a=>a[n]===Math.sign(o)&&a[1-n]===0);return o?`${Math.abs(o)} ${te[s]}`:""};return[r(0),
r(1)].filter(Boolean).join(", ")||"on your cell"}var aa="NUMPY\0",oa=aa.length+2,sa=64;function ia(t){return ro(Object.fromEntries(Object.entries(t).map(([e,r])=>[`${e}.npy`,Rl(r)])))}function Rl({dtype:t,shape:e,
data:r}){let n=typeof r=="string"?Array.from(r,u=>u.codePointAt(0)):null,o=e.map(u=>`${u}, `).join(""),s=`{'descr': '${n?`<U${n.length}`:t}', 'fortran_order': F\
alse, 'shape': (${o}), }`,a=Math.ceil((oa+s.length+1)/sa)*sa-oa,i=aa+String.fromCharCode(a&255,a>>8)+s.padEnd(a-1)+`
`,l=n?Int32Array.from(n):r,c=new Uint8Array(i.length+l.byteLength);return c.set(Et(i,!0)),c.set(new Uint8Array(l.buffer,l.byteOffset,l.byteLength),i.length),c}var $l="matrixworld episode 3";function la(t,e,r){let{config:n,actions:o,length:s,recording:a}=e,[i,l]=[n.n_pursuers+n.n_evaders,n.n_evaders],c={positions:["<i4",
i,2],last_positions:["<i4",i,2],alive:["|b1",i],captured:["|b1",l],ever_captured:["|b1",l]},u={rewards:["<f4",i],involved:["|b1",i,3],fault:["|b1",i,3]},p={},d=v=>{
for(let S of Object.keys(v))(p[S]??=[]).push(Array.from(h.read(S),Number))},h=t.world(n);h.reset(e.start);let y=[];d(c);for(let v of o)h.step(v),d({...c,...u}),
y.push(...h.conflictTable());h.free();let f={"<i4":Int32Array,"<f4":Float32Array,"|b1":Uint8Array},g={};for(let[v,[S,...T]]of Object.entries({...c,...u})){let P=s+
+(v in c);g[v]={dtype:S,shape:[P,...T],data:f[S].from((p[v]??[]).flat())}}let w=v=>({dtype:"<i8",shape:[],data:Int32Array.of(v,0)}),b=v=>({dtype:"<U",shape:[],data:v});
return ia({format:b($l),n_pursuers:w(n.n_pursuers),config:b(JSON.stringify(n)),seat:w(r),...g,actions:{dtype:"|i1",shape:[s,i],data:Int8Array.from(o.flatMap(v=>[
...v]))},map:{dtype:"|b1",shape:[n.rows,n.cols],data:Uint8Array.from(a.obstacles,Number)},conflict_table:{dtype:"<i4",shape:[y.length/11,11],data:Int32Array.from(
y)}})}var Ol=[0,1,2,4,8],sr=class{element;player=new We(0,{speed:4,still:Ge()});#e;#r;#t=m("canvas",{tabindex:0,"aria-describedby":"play-keys"});#n=m("h2");#a=m("p",{
class:"play-told",role:"status"});#s=ta(e=>this.act(e));#u=Pn(Ol.map(e=>[e,e?`${e} / s`:"step by step"]),()=>this.#E());#f=m("input",{type:"checkbox",onchange:()=>this.#S()});#d=m(
"input",{type:"checkbox",onchange:()=>this.#C()});#m=m("label",{class:"play-choice"},this.#d,"Best move");#p=m("p",{class:"small muted play-keys",id:"play-keys"});#l=m(
"section",{class:"play-ending",tabindex:-1,"aria-labelledby":"play-headline"});#i=Gt(this.player);#c=null;#o=null;#h=[];#y=null;#g=null;#v=[];#b=0;#w=0;constructor(e){
this.#e=e,this.#r=new He(this.#t,{numbers:!1}),this.#t.setAttribute("role","application"),ra(this.#r,()=>{let r=this.#y!==null&&this.#o&&k(this.#o.recording.moments.
at(-1),this.#y);return r?{cell:r,diagonal:this.#o.config.diagonal}:null},r=>this.act(r)),this.player.addEventListener("frame",()=>this.#o&&this.#r.show(this.#o.
recording,this.player.time)),this.player.addEventListener("step",()=>this.#C()),this.element=m("div",{class:"play"},m("header",{class:"play-head"},this.#n,this.#a),
m("div",{class:"play-stage"},this.#t),m("div",{class:"play-side"},this.#l,this.#s.element,m("label",{class:"play-choice",title:"Steps a second"},"Pace ",this.#u),
m("label",{class:"play-choice"},this.#f,m("span",{},"Fog",m("span",{class:"at-length"},": see only what it sees"))),this.#m,this.#p),this.#i)}get played(){return this.#c&&
{...this.#c.played,moves:this.#h}}get live(){return this.#o}play(e){this.#x(en(this.#e,e.played),e.played.seat,e.title),[this.#c,this.#h,this.#b]=[e,[...e.played.
moves],0],this.element.dataset.state="playing",this.#t.focus({preventScroll:!0}),or(this.#o,e.played.seat)&&this.#R()}watch(e,r,n){this.#c=null,this.#x(e,r,n),this.#$()}stop(){
this.#E(),this.player.pause(),this.#c=null}act(e){let[r,n]=[this.#c,this.#o];if(!r||!n||this.element.dataset.state!=="playing")return;this.#b=e;let o=Number(this.#u.
value);this.#w||(this.#k(),o&&this.element.dataset.state==="playing"&&(this.#w=setInterval(()=>this.#k(),1e3/o)))}key(e){let{target:r,key:n}=e;if(r instanceof HTMLSelectElement||
r instanceof HTMLInputElement&&(r.type==="text"||n===" ")||r instanceof HTMLButtonElement&&(n===" "||n==="Enter")||!this.#o)return!1;if(this.element.dataset.state!==
"playing")return Fe(this.player,e);let s=ea(e,this.#o.config.diagonal);return s!==void 0&&this.act(s),s!==void 0}#x(e,r,n){this.#E(),this.player.pause(),[this.#o,
this.#y]=[e,r],this.#n.textContent=n,this.#t.ariaLabel=`Board, ${e.config.rows} by ${e.config.cols} cells`,this.#s.show(e.config.diagonal),this.#p.replaceChildren(
m("span",{class:"at-length"},`W A S D or the arrow keys move, Space stays${e.config.diagonal?"; Q E Z C and the numeric keypad move diagonally":""}. `),"On the \
board: swipe, or tap where to go."),this.#M(e),this.#l.replaceChildren(),this.player.length=e.length,this.player.jump(e.length),this.#C()}#S(){this.#r.look={you:this.#y,
fog:this.#f.checked,viewers:this.#y===null?[]:[this.#y],plan:this.#O()}}#M(e){this.#g=null,this.#v=this.player.ticks=[],this.#m.hidden=this.#d.disabled=!!Tt(e.config),
Kt(this.#e,e.config,As(e.config)).then(r=>{this.#o===e&&(this.#g=r,this.#T(),this.#C())})}#T(){let[e,r]=[this.#o,this.#g];if(!r||this.element.dataset.state==="p\
laying")return;let n=this.#e.world(e.config);n.reset(e.start),this.#v=Yt(r,n,e.actions),n.free(),this.player.ticks=qt(this.#v)}get#A(){return this.#d.checked&&this.#c&&
this.element.dataset.state==="playing"&&this.#g&&this.#o.game(this.#g)||null}#O(){let[e,r]=[this.#y,this.#y!==null&&this.#A?.marginal(this.#y)];return e!==null&&
r?Object.assign(Array(e).fill(0),{[e]:r.indexOf(Math.max(...r))}):null}#E(){clearInterval(this.#w),this.#w=0,this.#a.ariaLive=Number(this.#u.value)?"off":"polit\
e"}#k(){let[{policies:e,seat:r},n]=[this.#c.played,this.#o];n.step(e,r,this.#b),this.#h.push(this.#b),this.player.length=n.length,this.player.glide=Math.min(.22,
.9/(Number(this.#u.value)||4)),this.player.move(n.length-this.player.step),or(n,r)&&this.#R()}#R(){this.#E();let[e,r,n]=[this.#c,this.#o,this.played],o=Ln()?e.link(
n):null,s=`${K(n.seat,r.config.n_pursuers)}-${r.length}-steps.npz`,a=()=>ho(s,la(this.#e,r,n.seat));this.#l.replaceChildren(m("h3",{id:"play-headline"},Nl(r,n.seat)),
...e.ending(r,n),m("div",{class:"play-buttons"},m("button",{type:"button",class:"primary",onclick:()=>e.again()},"Again"),m("button",{type:"button",onclick:()=>this.#$()},
"Watch it"),m("button",{type:"button",onclick:a},"Save"),o&&m("button",{type:"button",onclick:({currentTarget:l})=>Il(l,o)},"Link"))),this.element.dataset.state=
"ended",this.#T();let i=this.#v.filter(({team:l})=>l===de(r.config,n.seat));i.length&&this.#l.children[0].after(m("p",{class:"small muted"},Es(i))),this.#l.focus(
{preventScroll:!0}),this.#l.scrollIntoView({block:"nearest"})}#$(){this.element.dataset.state="watched",this.player.length=this.#o.length,this.player.jump(0),Ge()||
this.player.play()}#C(){let[e,r,{step:n}]=[this.#o,this.#y,this.player];if(!e||n>e.length)return;let o=Zt(e,e.recording,n).filter(({agents:l})=>r===null||l.includes(
r)),s=this.#c&&n===0,a=s?[_l(e.config,r),this.#c.about??""]:[`Step ${n} of ${e.config.max_steps}`,...o.map(({text:l})=>l)];!s&&r!==null&&a.push(Pl(e,n,r)),a.push(
...this.#v.filter(l=>l.step===n).map(ft));let i=n===e.length&&r!==null?this.#A:null;i&&a.push(`Perfect play: ${ks(i,r)||"decided in its turn"}; ${Cs(this.#g,i,n)}`),
this.#S(),this.#a.textContent=a.filter(Boolean).map(l=>`${l}.`).join(" ")}};function _l(t,e){let r=t.rules.capture==="SURROUND";return de(t,e)==="evader"?`Run a\
way: you win if ${r?"the pursuers do not surround you":"no pursuer reaches your cell"} in ${t.max_steps} steps`:`Capture evaders: ${r?"surround them with your t\
eam":"move onto their cells"}`}function Pl({config:t,recording:e},r,n){let o=e.moments[r],a=de(t,n)==="pursuer"?"evader":"pursuer";if(!o.alive[n])return"";let i=k(
o,n),l=p=>{let[d,h]=k(o,p);return Math.max(Math.abs(d-i[0]),Math.abs(h-i[1]))},c=Array.from({length:o.alive.length},(p,d)=>d).filter(p=>de(t,p)===a&&o.alive[p]&&
!o.captured[p-t.n_pursuers]&&2*l(p)<t.fov);if(!c.length)return`No ${a} in view`;let u=c.reduce((p,d)=>l(d)<l(p)?d:p);return`Nearest ${a}: ${na(i,k(o,u))}`}function Nl(t,e){
let[{lasted:r,out:n,captured:o},{config:s}]=[Ve(t,e),t];return de(s,e)==="pursuer"?`Your team captured ${o} of ${Ll(s)} in ${r} steps.`:n?`You lasted ${r} of ${s.
max_steps} steps.`:`You escaped: ${r} steps.`}var Ll=({n_evaders:t})=>`${t} evader${t===1?"":"s"}`;function Il(t,e){let r=po("Link to this match");r.value=e,t.replaceWith(
r),r.select(),navigator.clipboard?.writeText(e).catch(()=>{})}var ar=class{dialog=m("dialog",{class:"take-over","aria-label":"Play an agent",onclose:()=>this.view?.stop(),onkeydown:e=>this.view?.key(e)&&e.preventDefault()});view=null;#e;#r;#t;#n;#a=null;constructor(e,r,n,o=!0){
[this.#e,this.#r,this.#t,this.#n]=[e,r,n,o],n.element.addEventListener("takeover",()=>this.open())}start(e,r=""){this.#a=e;let n=nt(r,this.#e,this.#r.selected),
{world:o}=this.#e[n.run],s=o&&Js(new URLSearchParams(r.replace(/^#/,"")),o);s&&this.play(n,s)}open(){let e=this.#t.shown;if(!e)return;let{match:r,step:n}=e;this.#t.
player.pause();let o=this.#t.inspector.agent,s=n<r.length?n:0,a=(p,d)=>!!r.alive[d*r.n_agents+p],i=Array.from({length:r.n_agents},(p,d)=>(d+r.config.n_pursuers)%
r.n_agents),l=o??i.find(p=>a(p,s)),c=a(l,s)?s:0,u=Array.from({length:c},(p,d)=>r.actions[d*r.n_agents+l]);this.play(this.#r.selected,{seat:l,from:c,moves:u})}play(e,r){
let[n,o]=[this.#a,this.#e[e.run]],{world:s}=o;if(!n||!s||le.some(w=>Rt(o,w,e[w])))return;let{run:a,pursuer:i,evader:l,episode:c,seed:u}=e,p=de(s,r.seat),d=o.teams[p].
kept.map(w=>({name:o.teams[p].script??`generation ${w}`,text:"",policy:()=>oe(o,p,w)}));this.view||(this.view=new sr(n),this.dialog.append(m("button",{type:"but\
ton",class:"leave",onclick:()=>this.dialog.close()},"Close"),this.view.element)),this.dialog.open||this.dialog.showModal();let h=`You are ${K(r.seat,s.n_pursuers)}\
: ${this.#t.names(e).join(" against ")}`,y={pursuer:oe(o,"pursuer",i),evader:oe(o,"evader",l)},f={config:s,seed:BigInt(u??o.seeds[i][l]),episode:c,policies:y,...r},
g={run:a,pursuers:i,evaders:l,episode:c,...u===null?{}:{seed:u}};tn(n,this.view,h,f,d,this.#n?g:null)}};var ce=io(),{runs:Z}=ce,[Ul,Wl]=Z[0].payoff.shape,Fl=nt(location.hash,Z,{run:0,pursuer:Ul-1,evader:Wl-1,episode:0,seed:null}),{step:ca,...Dl}=Fl,re=new rr(Dl),q=new Jt(
Z,re,ce.playground),ua=new Qt(Z,re),gt=new ar(Z,re,q),nn=bo(Z),zl=location.hash,Ae=null,ma=m("span",{class:"told","aria-live":"polite"}),pa=m("span",{class:"sma\
ll muted"}),da=()=>{let t=Z[re.selected.run];[ma.textContent,pa.textContent]=[t.findings?.sentence??"",_(t).lead]};re.on("run",da);da();var ha=()=>{q.playSoon(),
q.reveal()};document.getElementById("page").replaceWith(Wn(ce.heading,m("span",{},ma,pa),m("button",{type:"button",class:"keys-button",title:"Keys (?)","aria-la\
bel":"Keys (?)",onclick:()=>nn.showModal()},"?")),...ce.note?[m("aside",{class:"note small muted"},ce.note)]:[],vo(Z,re),m("main",{class:"stages"},ua.element,q.
element),Vs(Z,re,ha),m("footer",{class:"muted small"},`${ce.title} · matrixworld ${ce.version}`),gt.dialog,nn);Object.assign(window,{matrixworldExplorer:{get match(){
return q.match},get step(){return q.player.step},get pace(){return q.player.pace},get playing(){return gt.view},play:t=>Ae&&$t(Ae,Z[re.selected.run],{...re.selected,
episode:t}),get shape(){return Z[re.selected.run].payoff.shape}}});ua.element.addEventListener("play",ha);q.goTo(ca);ca||q.playSoon();Dn(Z,re,q);wo(Z,re,q,nn,()=>gt.
open(),()=>ce.playground&&Vr(q.shown,ce.playground));window.addEventListener("hashchange",({newURL:t})=>Ae&&gt.start(Ae,new URL(t).hash));ce.growing&&zn(Z,re,()=>q.
player.playing||document.querySelector("dialog[open]")!==null);async function Bl(){Ae=ce.playground&&await On(),q.start(Ae),Ae&&gt.start(Ae,zl)}requestAnimationFrame(
()=>setTimeout(()=>Nn(Bl())));})();
