/* built from web/ by "npm run build"; sources bd4a93ceb1aee10cff0299ec78a63fb00f6f429754408371650a49a997e8f2d0 */
"use strict";(()=>{var ln={SIMULTANEOUS:0,SWARM_TURNS:1,AGENT_TURNS:2},Xe={DISAPPEAR:0,REACH:1,BOUNCE:2},cn={OCCUPATION:0,SURROUND:1},un={FAULT:0,INVOLVED:1};var mr=["obstacle","teammate","adversary"],pr=["vertex","edge","chain"],mn=["turn","kind","form","first","second","row","col","at_fault","held","doomed"],dr=["p\
ursuer_{number}","evader_{number}"],pn={obstacle:"{first} ran into the obstacle or border at {cell}",vertex:"{first} and {second} both headed for {cell}",edge:"\
{first} and {second} meant to swap, {first} to {cell}",chain:"{first} headed for {cell}, where {second} had to stay"},Qe={"both held":"both bounce","both doomed":"\
both disappear",held:"{agent} bounces",doomed:"{agent} disappears",none:"nobody is stopped"},dn="{event}: {outcome}",hr={random:"any action, all equally likely",
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
it is the direction that the agent draws for each 12 steps (0 to 1)"},hn={free:".GS",blocked:"#@OTW"};var Ne=1+mn.length;function et(t,e){return t.replace(/\{(\w+)\}/g,(r,n)=>String(e[n]))}function Y(t,e){return t<e?et(dr[0],{number:t}):et(dr[1],{number:t-e})}function ya(t,e){
let[r,n,o,s,a,i,l,...c]=Array.from(t),m=a<0?[s]:[s,a],[p,d,h]=c.map(w=>m.filter((b,v)=>w>>v&1)),g=m.map(w=>Y(w,e)),f=et(pn[a<0?"obstacle":pr[o]],{first:g[0],second:g[g.
length-1],cell:`(${i}, ${l})`}),y=et(dn,{event:f,outcome:va(m.length,d,h,e)});return{kind:mr[n],form:pr[o],agents:m,cell:[i,l],at_fault:p,held:d,doomed:h,turn:r,
text:y}}function va(t,e,r,n){if(t===2&&e.length===2)return Qe["both held"];if(t===2&&r.length===2)return Qe["both doomed"];let o=s=>a=>et(Qe[s],{agent:Y(a,n)});
return[...e.map(o("held")),...r.map(o("doomed"))].join(", ")||Qe.none}function Mt(t,e){let r=[];for(let n=0;n<t.length;n+=Ne)r.push(ya(t.subarray(n+1,n+Ne),e));
return r}var we=class extends Error{name="EngineError"};function L(t,e,r){let n=typeof r=="string"?`'${r}'`:typeof r=="object"?JSON.stringify(r):String(r);return new we(
`${t}: expected ${e}, got ${n}`)}var Ie=class{bytes;constructor(e){this.bytes=e}},yn=0,gr=[Uint8Array,Uint8Array,Int32Array,BigInt64Array,BigUint64Array,Float32Array,Float64Array],fn=4,gn=4,ba=new TextEncoder,
wa=new TextDecoder;function xa(t){for(let e=gr.length-1;e>yn;--e)if(t instanceof gr[e])return e;throw new TypeError("array: expected a typed array of the engine\
's numbers, got another")}function fr(t){return new Uint8Array(t.buffer,t.byteOffset,t.byteLength)}function Sa(t){return ba.encode(`${t}\0`)}var yr=class{engine;addresses=[];constructor(e){
this.engine=e}copy(e){let r=this.engine._malloc(Math.max(e.length,1));if(r===0)throw new we("memory: expected room for the arguments, got none");return this.addresses.
push(r),this.engine.HEAPU8.set(e,r),r}text(e){return this.copy(Sa(e))}arrays(e){let r=Object.entries(e),n=r.flatMap(([s,a])=>{let i=a instanceof Ie,l=i?a.bytes:
a;return[this.text(s),i?yn:xa(l),l.length,this.copy(fr(l))]}),o=this.copy(fr(Int32Array.from(n)));return this.copy(fr(Int32Array.of(r.length,o)))}free(){for(let e of this.
addresses)this.engine._free(e)}};function vn(t,e){let r=t.HEAPU8;return wa.decode(r.subarray(e,r.indexOf(0,e)))}function Ue(t){let e=new Int32Array(t.HEAPU8.buffer),
r=t._last_outputs()/fn,n=e[r+1]/fn,o={};for(let s=n;s<n+e[r]*gn;s+=gn){let a=gr[e[s+1]],i=e[s+2]*a.BYTES_PER_ELEMENT,l=e[s+3];o[vn(t,e[s])]=new a(t.HEAPU8.slice(
l,l+i).buffer)}return o}function xe(t,e){let r=new yr(t);try{let n=e(r);if(n===0)throw new we(vn(t,t._last_error()));return n}finally{r.free()}}var Ma=2**31-1,bn=["none","gru"],Aa=2n**64n-1n,Ta=34028234663852886e22;function ie(t,e){if(typeof e!="number"||!Number.isInteger(e)||Math.abs(e)>Ma)throw L(t,"a\
n integer",e);return Int32Array.of(e)}function At(t,e){if(typeof e!="boolean")throw L(t,"true or false",e);return new Ie(Uint8Array.of(Number(e)))}function Te(t,e,r){
let n=typeof e=="string"&&Object.hasOwn(r,e)?r[e]:void 0;if(n===void 0)throw L(t,`one of ${Object.keys(r).join(", ")}`,e);return Int32Array.of(n)}function vr(t,e){
if(typeof e!="number"||!(Math.abs(e)<=Ta))throw L(t,"a finite number",e);return e}function tt(t,e){let n=typeof e=="bigint"||typeof e=="number"&&Number.isSafeInteger(
e)?BigInt(e):-1n;if(n<0n||n>Aa)throw L(t,"an integer from 0 to 2^64 - 1",e);return BigUint64Array.of(n)}function Ea(t){return{"rules.interaction":Te("interactio\
n",t.interaction,ln),"rules.obstacle":Te("obstacle",t.obstacle,Xe),"rules.teammate":Te("teammate",t.teammate,Xe),"rules.evader":Te("evader",t.evader,Xe),"rules.\
pursuer":Te("pursuer",t.pursuer,Xe),"rules.capture":Te("capture",t.capture,cn),"rules.captured_disappear":At("captured_disappear",t.captured_disappear)}}function wn(t,e){
let r=typeof e=="number"?[e,e,e]:e;if(!Array.isArray(r)||r.length!==3)throw L(t,"1 or 3 numbers",e);return Float32Array.from(r,n=>vr(t,n))}function Ca(t){let e=(r,n)=>Float32Array.
of(vr(r,t[r]),vr(n,t[n]));return{"rewards.capture":e("pursuer_capture","evader_capture"),"rewards.neighbor":e("pursuer_neighbor","evader_neighbor"),"rewards.ste\
p":e("pursuer_step","evader_step"),"rewards.pursuer_collide":wn("pursuer_collide",t.pursuer_collide),"rewards.evader_collide":wn("evader_collide",t.evader_collide),
"rewards.blame":Te("blame",t.blame,un),"rewards.capture_repeats":At("capture_repeats",t.capture_repeats)}}function Mn(t){if(t===void 0||typeof t=="number")return new Uint8Array(
0);if(t instanceof Uint8Array)return t;let{free:e,blocked:r}=hn;for(let[n,o]of t.entries()){if(o.length!==t[0]?.length)throw L(`map, row ${n}`,`${t[0]?.length} \
cells as in row 0`,o.length);let s=[...o].find(a=>!e.includes(a)&&!r.includes(a));if(s)throw L(`map, row ${n}`,`'${e}' (free) or '${r}' (obstacle)`,s)}return Uint8Array.
from([...t.join("")],n=>Number(r.includes(n)))}function An(t,e){if(!Array.isArray(t))return;let r=[t.length,t[0]?.length??0];if(!(r[0]===e.rows&&r[1]===e.cols))
throw L("obstacle map",`shape (${e.rows}, ${e.cols}), the rows and cols`,r)}function We(t){An(t.obstacles,t);let e=typeof t.obstacles=="number"?t.obstacles:0;return{
...Ea(t.rules),...Ca(t.rewards),rows:ie("rows",t.rows),cols:ie("cols",t.cols),n_pursuers:ie("n_pursuers",t.n_pursuers),n_evaders:ie("n_evaders",t.n_evaders),fov:ie(
"fov",t.fov),diagonal:At("diagonal",t.diagonal),max_steps:ie("max_steps",t.max_steps),density:Float64Array.of(e),map:Mn(t.obstacles)}}function xn(t,e){return Int32Array.
from((e??[]).flat(),r=>ie(t,r)[0])}function Tn(t,e){return An(t.obstacles,e),{seed:tt("seed",t.seed??0n),episode:tt("episode",t.episode??0),pursuers:xn("pursuer\
s",t.pursuers),evaders:xn("evaders",t.evaders),map:Mn(t.obstacles)}}function Tt(t){return{actions:Int32Array.from(t,e=>ie("actions",e)[0])}}var Sn=Object.keys(Le);
function br(t){let e=Sn.indexOf(t);if(e<0)throw L("inputs",`names of ${Sn.join(", ")}`,t);return e}function Ee(t){if(typeof t=="string"){if(!Object.hasOwn(hr,t))
throw L("policy",`one of ${Object.keys(hr).join(", ")}`,t);return{script:new TextEncoder().encode(t)}}if(t.kind!=="cells")return{inputs:Int32Array.from(t.inputs,
e=>br(e)),hidden:Int32Array.from(t.kind==="rating"?t.hidden:[],e=>ie("hidden",e)[0]),length:ie("length",t.kind==="program"?t.length:0),mask:new TextEncoder().encode(
t.mask),genome:t.genome};if(t.activation!=="relu"&&t.activation!=="tanh")throw L("activation","'relu' or 'tanh'",t.activation);if(!bn.includes(t.memory))throw L(
"memory",`one of ${bn.join(", ")}`,t.memory);return{hidden:Int32Array.from(t.hidden,e=>ie("hidden",e)[0]),activation:new TextEncoder().encode(t.activation),sampled:At(
"sampled",t.sampled),memory:new TextEncoder().encode(t.memory),genome:t.genome}}var ka=["first_turn","terminated","truncated"];function En(t){let e={...t};for(let r of ka)
e[r]=new Ie(t[r]);return e}var Cn="statistics.",Et=class{config;seed;episode;n_agents;statistics;first_conflict;constructor(e,r,n,o){this.config=e,this.seed=r,this.episode=n,this.n_agents=
e.n_pursuers+e.n_evaders,this.statistics=$a(kn(o)),Object.assign(this,o),this.first_conflict=Ra(this.conflict_table,this.length)}get length(){return this.actions.
length/this.n_agents}conflicts(e){this.check(e);let[r,n]=[this.first_conflict[e],this.first_conflict[e+1]],o=this.conflict_table.subarray(r*Ne,n*Ne);return Mt(o,
this.config.n_pursuers)}seek(e,r,n){this.check(r),(!(e.seed===this.seed&&e.episode===BigInt(this.episode))||e.turn!==0||e.steps>r)&&e.reset({seed:this.seed,episode:this.
episode});for(let s=e.steps;s<r;++s){let a=this.actions.subarray(s*this.n_agents,(s+1)*this.n_agents);n?e.replay(a,{pursuer:n.pursuers,evader:n.evaders}):e.step(
a)}}check(e){if(!(Number.isInteger(e)&&e>=0&&e<=this.length))throw L("step",`0 to ${this.length}`,e)}};function Ra(t,e){let r=new Int32Array(e+2);for(let n=0;n<
t.length;n+=Ne)++r[t[n]+1];for(let n=1;n<r.length;++n)r[n]+=r[n-1];return r}function $a(t){let e=["capture_rate","ever_capture_rate","captured_fraction","length"];
return Object.fromEntries(Object.entries(t).map(([r,n])=>[r,e.includes(r)?Number(n[0]):n]))}var kn=t=>Object.fromEntries(Object.entries(t).flatMap(([e,r])=>e.startsWith(
Cn)?[[e.slice(Cn.length),r]]:[]));function Rn(t,e,r,n){let o=[We(r.config),Ee(r.pursuers),Ee(r.evaders),n];return xe(t,s=>{let[a,i,l,c]=o.map(m=>s.arrays(m));return t[e](
a,i,l,c)}),Ue(t)}function $n(t,e,r,n){let o={seed:tt("seed",r),episode:tt("episode",n)};return new Et(e.config,r,n,Rn(t,"_play_match",e,o))}function On(t,e,r,n){
if(!Number.isInteger(n)||n<1)throw L("n_episodes","at least 1",n);let o=Rn(t,"_play_rollout",e,{...r,n_episodes:Int32Array.of(n)});return kn(o)}var Oa=7e6,Pa=new FinalizationRegistry(([t,e])=>t._states_free(e));function _a({rules:t,rows:e,cols:r,obstacles:n,diagonal:o,n_pursuers:s,n_evaders:a}){let i=typeof n==
"number"||t.obstacle==="REACH"?0:n.join("").split("#").length-1,l=e*r-i,c=[t.obstacle,t.teammate,t.pursuer].includes("DISAPPEAR"),m=t.capture==="SURROUND"||t.evader===
"REACH",p=t.interaction==="AGENT_TURNS",d=(f,y)=>Array.from({length:y},(w,b)=>p?f:(f+b)/(b+1)).reduce((w,b)=>w*b,1),h=d(l+Number(c),s)*d(l*(1+Number(m))+2,a);return{
SIMULTANEOUS:[s+a],SWARM_TURNS:[s,a],AGENT_TURNS:Array(s+a).fill(1)}[t.interaction].reduce((f,y)=>f+h*(o?9:5)**y,0)}function Ct(t){return typeof t.obstacles=="n\
umber"&&t.obstacles>0?"obstacles are drawn anew in each episode":_a(t)>Oa?"the world is too large to be solved on the page":""}var wr=class{value;teams;matrix;n_actions;constructor(e,r){
let{matrix:n,rows:o,cols:s,value:a,agents:i}=r,[l,c]=e.actors,m=Array.from(i).filter(d=>l<=d&&d<c),p=d=>d<e.config.n_pursuers;[this.value,this.matrix,this.n_actions]=
[a[0],n,e.n_actions],this.teams=[{agents:m.filter(p),play:o},{agents:m.filter(d=>!p(d)),play:s}]}marginal(e){let r=this.teams.find(({agents:s})=>s.includes(e));
if(!r)return null;let n=this.n_actions**(r.agents.length-1-r.agents.indexOf(e)),o=Array(this.n_actions).fill(0);return r.play.forEach((s,a)=>o[Math.floor(a/n)%this.
n_actions]+=s),o}lost(e){let[r,n]=this.teams.map(({agents:l})=>l.reduce((c,m)=>c*this.n_actions+e[m],0)),[o,s]=this.teams.map(({play:l})=>l),a=s.reduce((l,c,m)=>l+
c*this.matrix[r*s.length+m],0),i=o.reduce((l,c,m)=>l+c*this.matrix[m*s.length+n],0);return[Math.max(0,this.value-a),Math.max(0,i-this.value)]}},xr=60,rt=class{config;payoff;engine;states;n_turns;values;constructor(e,r,n){
[this.engine,this.config,this.payoff]=[e,r,n],this.states=xe(e,i=>e._states_new(i.arrays(We(r)))),Pa.register(this,[e,this.states]);let o={SIMULTANEOUS:1,SWARM_TURNS:2,
AGENT_TURNS:r.n_pursuers+r.n_evaders};this.n_turns=o[r.rules.interaction];let{payoffs:s}=this.call(()=>e._states_payoffs(this.states)),a=s;this.values=[[n==="ca\
pture-rate"?a:a.fill(0)]]}goBack(){let e=this.values.at(-1)[0],r=[];for(let o=this.n_turns-1;o>=0;o--){let s=r[o+1]??e;r[o]=this.backup(o,{next:s})}this.payoff===
"capture-time"&&(r[0]=r[0].map((o,s)=>s===this.config.n_evaders?0:o-1)),this.values.push(r);let n=this.payoff==="capture-rate"?this.config.max_steps:Math.min(this.
config.max_steps,xr);return this.values.length<=n&&r[0].some((o,s)=>o!==e[s])}backup(e,r){return this.call(n=>this.engine._states_backup(this.states,e,n.arrays(
r))).values}game(e){let[r,{turn:n}]=[this.config.max_steps-e.steps,e],o=n+1===this.n_turns,s=r>0?this.values[Math.min(r-Number(o),this.values.length-1)]?.[o?0:n+
1]:void 0;if(!s)return null;let a=this.call(i=>this.engine._states_game(this.states,e.address,i.arrays({next:s})));return a.agents.length?new wr(e,a):null}call(e){
return xe(this.engine,e),Ue(this.engine)}};var Pn=new FinalizationRegistry(([t,e])=>t._world_free(e)),nt=class{config;n_agents;n_actions;engine;at;freed=!1;constructor(e,r){this.engine=e,this.config=r,this.
n_agents=r.n_pursuers+r.n_evaders,this.n_actions=r.diagonal?9:5,this.at=xe(e,n=>e._world_new(n.arrays(We(r)))),Pn.register(this,[e,this.at],this)}free(){this.freed||
(this.freed=!0,Pn.unregister(this),this.engine._world_free(this.at))}get address(){if(this.freed)throw L("world","one that is in use","one that was freed");return this.
at}reset(e={}){let r=Tn(e,this.config);this.call(n=>this.engine._world_reset(this.address,n.arrays(r)))}step(e){let r=Tt(e);this.call(n=>this.engine._world_step(
this.address,n.arrays(r)))}playTurn(e){let r=Tt(e);this.call(n=>this.engine._world_play_turn(this.address,n.arrays(r)))}decide(e,r,n){let{n_pursuers:o}=this.config,
s={pursuer:[0,o],evader:[o,this.n_agents]},[a,i]=typeof r=="string"?s[r]:r;if(n.length!==this.n_agents)throw L("actions",String(this.n_agents),n.length);let l=[
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
this.n_actions,l=c=>Float32Array.from({length:this.n_actions},(m,p)=>a[(r*this.n_actions+p)*i+c]);return{inputs:e.inputs.map(c=>l(br(c))),ratings:o,refused:s}}snapshot(){
return this.call(()=>this.engine._world_snapshot(this.address))}restore(e){let r=En(e);this.call(n=>this.engine._world_restore(this.address,n.arrays(r)))}call(e){
return xe(this.engine,e),Ue(this.engine)}};function La(t){let e=Math.max(...t),r=Array.from(t,o=>Math.exp(o-e)),n=r.reduce((o,s)=>o+s,0);return Float32Array.from(
r,o=>o/n)}var Sr=class{compiled;constructor(e){this.compiled=e}world(e){return new nt(this.compiled,e)}solution(e,r="capture-rate"){return new rt(this.compiled,e,r)}match(e,r,n,o,s=0){
return $n(this.compiled,{config:e,pursuers:r,evaders:n},o,s)}rollouts(e,r,n,o,s){return On(this.compiled,{config:e,pursuers:r,evaders:n},o,s)}},_n;function Ln(t=globalThis.
matrixworldEngine){return _n??=Na(t),_n}async function Na(t){if(!t)throw new Error("matrixworldEngine: expected the script engine.js before this one, got none");
let e=Uint8Array.from(atob(t.binary),r=>r.charCodeAt(0));return new Sr(await t({wasmBinary:e}))}var Ia="http://www.w3.org/2000/svg";function u(t,e={},...r){return Nn(document.createElement(t),e,r)}function x(t,e={},...r){return Nn(document.createElementNS(
Ia,t),e,r)}function Nn(t,e,r){for(let[o,s]of Object.entries(e))s==null||s===!1||(typeof s=="function"?t.addEventListener(o.slice(2),s):t.setAttribute(o,s===!0?"":
String(s)));let n=r.filter(o=>o!=null&&o!==!1);return t.append(...n.map(o=>typeof o=="number"?String(o):o)),t}function In(t,e){let r=u("select",{onchange:()=>e(
r.value)},...t.map(([n,o])=>u("option",{value:n},o)));return r}async function Un(t){try{await t}catch(e){throw(document.querySelector("#page, main")??document.body).
prepend(u("p",{class:"card problem",role:"alert"},`The page could not start: ${String(e)}`)),e}finally{document.body.dataset.ready="true"}}var Wn=()=>["file:","\
http:","https:"].includes(location.protocol);var Fn=()=>document.documentElement.dataset.theme==="dark",ot=t=>{document.documentElement.dataset.theme=t?"dark":"light"},Mr=()=>ot(!Fn());if(typeof document<"\
u"){let t=matchMedia("(prefers-color-scheme: dark)");t.addEventListener("change",()=>ot(t.matches)),ot(t.matches);let e=!1;addEventListener("beforeprint",()=>{e=
Fn(),ot(!1)}),addEventListener("afterprint",()=>ot(e))}function Dn(){return u("button",{type:"button",title:"Light or dark (D)","aria-label":"Light or dark",onclick:Mr},
"◐")}var zn=(t,e,...r)=>u("header",{class:"top"},u("div",{},u("h1",{},t),e?u("p",{class:"lead"},e):null),u("div",{class:"tools"},...r,Dn()));var Ua=2n**64n-1n;function st(t,e,r){let n=new URLSearchParams(t.replace(/^#/,"")),o=(c,m,p)=>{let d=n.get(c)??"";return/^\d{1,9}$/.test(d)&&Number(d)<m?Number(
d):p},s=o("run",e.length,r.run),[a,i]=e[s].payoff.shape,l=n.get("seed")??"";return{run:s,pursuer:o("pursuers",a,Math.min(r.pursuer,a-1)),evader:o("evaders",i,Math.
min(r.evader,i-1)),episode:o("episode",1/0,r.episode),seed:/^\d{1,20}$/.test(l)&&BigInt(l)<=Ua?l:null,step:o("step",1/0,0)}}function Hn(t,e,r){let[n,o,s]=["",JSON.
stringify(e.selected),-800],a=()=>{let{run:i,pursuer:l,evader:c,episode:m,seed:p}=e.selected,d={run:i,pursuers:l,evaders:c,episode:m,...p===null?{}:{seed:p},step:r.
player.step},h=JSON.stringify(e.selected),g=h!==o&&performance.now()-s>800;h!==o&&([o,s]=[h,performance.now()]),n=`#${Object.entries(d).map(([f,y])=>`${f}=${y}`).
join("&")}`;try{g?history.pushState(null,"",n):history.replaceState(null,"",n)}catch{}};a(),e.on("match",a),r.player.addEventListener("state",()=>r.player.playing||
a()),r.player.addEventListener("step",()=>r.player.playing||a()),window.addEventListener("hashchange",()=>{if(location.hash===n)return;let{step:i,...l}=st(location.
hash,t,e.selected);for(let c of document.querySelectorAll("dialog[open]"))c.close();o=JSON.stringify(l),e.select(l),r.goTo(i)})}var Wa=5e3,Bn=8e3;function Gn(t,e,r){
let n=-Bn;for(let o of["pointerdown","pointermove","keydown","wheel"])window.addEventListener(o,()=>n=performance.now(),{passive:!0});setInterval(()=>{if(r()||performance.
now()-n<Bn)return;let{run:o,pursuer:s,evader:a}=e.selected,[i,l]=t[o].payoff.shape;s===i-1&&a===l-1&&history.replaceState(null,"",`#run=${o}`),location.reload()},
Wa)}var P=Uint8Array,re=Uint16Array,Pr=Int32Array,Rt=new P([0,0,0,0,0,0,0,0,1,1,1,1,2,2,2,2,3,3,3,3,4,4,4,4,5,5,5,5,0,0,0,0]),$t=new P([0,0,0,0,1,1,2,2,3,3,4,4,5,5,
6,6,7,7,8,8,9,9,10,10,11,11,12,12,13,13,0,0]),Cr=new P([16,17,18,0,8,7,9,6,10,5,11,4,12,3,13,2,14,1,15]),Zn=function(t,e){for(var r=new re(31),n=0;n<31;++n)r[n]=
e+=1<<t[n-1];for(var o=new Pr(r[30]),n=1;n<30;++n)for(var s=r[n];s<r[n+1];++s)o[s]=s-r[n]<<5|n;return{b:r,r:o}},Jn=Zn(Rt,2),Xn=Jn.b,kr=Jn.r;Xn[28]=258,kr[258]=28;
var Qn=Zn($t,0),Fa=Qn.b,jn=Qn.r,Rr=new re(32768);for(E=0;E<32768;++E)ye=(E&43690)>>1|(E&21845)<<1,ye=(ye&52428)>>2|(ye&13107)<<2,ye=(ye&61680)>>4|(ye&3855)<<4,Rr[E]=
((ye&65280)>>8|(ye&255)<<8)>>1;var ye,E,de=(function(t,e,r){for(var n=t.length,o=0,s=new re(e);o<n;++o)t[o]&&++s[t[o]-1];var a=new re(e);for(o=1;o<e;++o)a[o]=a[o-
1]+s[o-1]<<1;var i;if(r){i=new re(1<<e);var l=15-e;for(o=0;o<n;++o)if(t[o])for(var c=o<<4|t[o],m=e-t[o],p=a[t[o]-1]++<<m,d=p|(1<<m)-1;p<=d;++p)i[Rr[p]>>l]=c}else
for(i=new re(n),o=0;o<n;++o)t[o]&&(i[o]=Rr[a[t[o]-1]++]>>15-t[o]);return i}),Se=new P(288);for(E=0;E<144;++E)Se[E]=8;var E;for(E=144;E<256;++E)Se[E]=9;var E;for(E=
256;E<280;++E)Se[E]=7;var E;for(E=280;E<288;++E)Se[E]=8;var E,lt=new P(32);for(E=0;E<32;++E)lt[E]=5;var E,Da=de(Se,9,0),za=de(Se,9,1),Ba=de(lt,5,0),Ha=de(lt,5,1),
Ar=function(t){for(var e=t[0],r=1;r<t.length;++r)t[r]>e&&(e=t[r]);return e},le=function(t,e,r){var n=e/8|0;return(t[n]|t[n+1]<<8)>>(e&7)&r},Tr=function(t,e){var r=e/
8|0;return(t[r]|t[r+1]<<8|t[r+2]<<16)>>(e&7)},_r=function(t){return(t+7)/8|0},Lr=function(t,e,r){return(e==null||e<0)&&(e=0),(r==null||r>t.length)&&(r=t.length),
new P(t.subarray(e,r))};var Ga=["unexpected EOF","invalid block type","invalid length/literal","invalid distance","stream finished","no stream handler",,"no callback","invalid UTF-8 da\
ta","extra field too long","date not in range 1980-2099","filename too long","stream finishing","invalid zip data"],q=function(t,e,r){var n=new Error(e||Ga[t]);
if(n.code=t,Error.captureStackTrace&&Error.captureStackTrace(n,q),!r)throw n;return n},ja=function(t,e,r,n){var o=t.length,s=n?n.length:0;if(!o||e.f&&!e.l)return r||
new P(0);var a=!r,i=a||e.i!=2,l=e.i;a&&(r=new P(o*3));var c=function(Ze){var Je=r.length;if(Ze>Je){var _e=new P(Math.max(Je*2,Ze));_e.set(r),r=_e}},m=e.f||0,p=e.
p||0,d=e.b||0,h=e.l,g=e.d,f=e.m,y=e.n,w=o*8;do{if(!h){m=le(t,p,1);var b=le(t,p+1,3);if(p+=3,b)if(b==1)h=za,g=Ha,f=9,y=5;else if(b==2){var _=le(t,p,31)+257,C=le(
t,p+10,15)+4,A=_+le(t,p+5,31)+1;p+=14;for(var M=new P(A),W=new P(19),I=0;I<C;++I)W[Cr[I]]=le(t,p+I*3,7);p+=C*3;for(var B=Ar(W),be=(1<<B)-1,Q=de(W,B,1),I=0;I<A;){
var V=Q[le(t,p,be)];p+=V&15;var v=V>>4;if(v<16)M[I++]=v;else{var F=0,$=0;for(v==16?($=3+le(t,p,3),p+=2,F=M[I-1]):v==17?($=3+le(t,p,7),p+=3):v==18&&($=11+le(t,p,
127),p+=7);$--;)M[I++]=F}}var K=M.subarray(0,_),D=M.subarray(_);f=Ar(K),y=Ar(D),h=de(K,f,1),g=de(D,y,1)}else q(1);else{var v=_r(p)+4,S=t[v-4]|t[v-3]<<8,T=v+S;if(T>
o){l&&q(0);break}i&&c(d+S),r.set(t.subarray(v,T),d),e.b=d+=S,e.p=p=T*8,e.f=m;continue}if(p>w){l&&q(0);break}}i&&c(d+131072);for(var qe=(1<<f)-1,se=(1<<y)-1,ge=p;;ge=
p){var F=h[Tr(t,p)&qe],ee=F>>4;if(p+=F&15,p>w){l&&q(0);break}if(F||q(2),ee<256)r[d++]=ee;else if(ee==256){ge=p,h=null;break}else{var te=ee-254;if(ee>264){var I=ee-
257,O=Rt[I];te=le(t,p,(1<<O)-1)+Xn[I],p+=O}var pe=g[Tr(t,p)&se],Oe=pe>>4;pe||q(3),p+=pe&15;var D=Fa[Oe];if(Oe>3){var O=$t[Oe];D+=Tr(t,p)&(1<<O)-1,p+=O}if(p>w){l&&
q(0);break}i&&c(d+131072);var Pe=d+te;if(d<D){var xt=s-D,St=Math.min(D,Pe);for(xt+d<0&&q(3);d<St;++d)r[d]=n[xt+d]}for(;d<Pe;++d)r[d]=r[d-D]}}e.l=h,e.p=ge,e.b=d,
e.f=m,h&&(m=1,e.m=f,e.d=g,e.n=y)}while(!m);return d!=r.length&&a?Lr(r,0,d):r.subarray(0,d)},ve=function(t,e,r){r<<=e&7;var n=e/8|0;t[n]|=r,t[n+1]|=r>>8},at=function(t,e,r){
r<<=e&7;var n=e/8|0;t[n]|=r,t[n+1]|=r>>8,t[n+2]|=r>>16},Er=function(t,e){for(var r=[],n=0;n<t.length;++n)t[n]&&r.push({s:n,f:t[n]});var o=r.length,s=r.slice();if(!o)
return{t:to,l:0};if(o==1){var a=new P(r[0].s+1);return a[r[0].s]=1,{t:a,l:1}}r.sort(function(T,_){return T.f-_.f}),r.push({s:-1,f:25001});var i=r[0],l=r[1],c=0,
m=1,p=2;for(r[0]={s:-1,f:i.f+l.f,l:i,r:l};m!=o-1;)i=r[r[c].f<r[p].f?c++:p++],l=r[c!=m&&r[c].f<r[p].f?c++:p++],r[m++]={s:-1,f:i.f+l.f,l:i,r:l};for(var d=s[0].s,n=1;n<
o;++n)s[n].s>d&&(d=s[n].s);var h=new re(d+1),g=$r(r[m-1],h,0);if(g>e){var n=0,f=0,y=g-e,w=1<<y;for(s.sort(function(_,C){return h[C.s]-h[_.s]||_.f-C.f});n<o;++n){
var b=s[n].s;if(h[b]>e)f+=w-(1<<g-h[b]),h[b]=e;else break}for(f>>=y;f>0;){var v=s[n].s;h[v]<e?f-=1<<e-h[v]++-1:++n}for(;n>=0&&f;--n){var S=s[n].s;h[S]==e&&(--h[S],
++f)}g=e}return{t:new P(h),l:g}},$r=function(t,e,r){return t.s==-1?Math.max($r(t.l,e,r+1),$r(t.r,e,r+1)):e[t.s]=r},Vn=function(t){for(var e=t.length;e&&!t[--e];)
;for(var r=new re(++e),n=0,o=t[0],s=1,a=function(l){r[n++]=l},i=1;i<=e;++i)if(t[i]==o&&i!=e)++s;else{if(!o&&s>2){for(;s>138;s-=138)a(32754);s>2&&(a(s>10?s-11<<5|
28690:s-3<<5|12305),s=0)}else if(s>3){for(a(o),--s;s>6;s-=6)a(8304);s>2&&(a(s-3<<5|8208),s=0)}for(;s--;)a(o);s=1,o=t[i]}return{c:r.subarray(0,n),n:e}},it=function(t,e){
for(var r=0,n=0;n<e.length;++n)r+=t[n]*e[n];return r},eo=function(t,e,r){var n=r.length,o=_r(e+2);t[o]=n&255,t[o+1]=n>>8,t[o+2]=t[o]^255,t[o+3]=t[o+1]^255;for(var s=0;s<
n;++s)t[o+s+4]=r[s];return(o+4+n)*8},Kn=function(t,e,r,n,o,s,a,i,l,c,m){ve(e,m++,r),++o[256];for(var p=Er(o,15),d=p.t,h=p.l,g=Er(s,15),f=g.t,y=g.l,w=Vn(d),b=w.c,
v=w.n,S=Vn(f),T=S.c,_=S.n,C=new re(19),A=0;A<b.length;++A)++C[b[A]&31];for(var A=0;A<T.length;++A)++C[T[A]&31];for(var M=Er(C,7),W=M.t,I=M.l,B=19;B>4&&!W[Cr[B-1]];--B)
;var be=c+5<<3,Q=it(o,Se)+it(s,lt)+a,V=it(o,d)+it(s,f)+a+14+3*B+it(C,W)+2*C[16]+3*C[17]+7*C[18];if(l>=0&&be<=Q&&be<=V)return eo(e,m,t.subarray(l,l+c));var F,$,K,
D;if(ve(e,m,1+(V<Q)),m+=2,V<Q){F=de(d,h,0),$=d,K=de(f,y,0),D=f;var qe=de(W,I,0);ve(e,m,v-257),ve(e,m+5,_-1),ve(e,m+10,B-4),m+=14;for(var A=0;A<B;++A)ve(e,m+3*A,
W[Cr[A]]);m+=3*B;for(var se=[b,T],ge=0;ge<2;++ge)for(var ee=se[ge],A=0;A<ee.length;++A){var te=ee[A]&31;ve(e,m,qe[te]),m+=W[te],te>15&&(ve(e,m,ee[A]>>5&127),m+=
ee[A]>>12)}}else F=Da,$=Se,K=Ba,D=lt;for(var A=0;A<i;++A){var O=n[A];if(O>255){var te=O>>18&31;at(e,m,F[te+257]),m+=$[te+257],te>7&&(ve(e,m,O>>23&31),m+=Rt[te]);
var pe=O&31;at(e,m,K[pe]),m+=D[pe],pe>3&&(at(e,m,O>>5&8191),m+=$t[pe])}else at(e,m,F[O]),m+=$[O]}return at(e,m,F[256]),m+$[256]},Va=new Pr([65540,131080,131088,
131104,262176,1048704,1048832,2114560,2117632]),to=new P(0),Ka=function(t,e,r,n,o,s){var a=s.z||t.length,i=new P(n+a+5*(1+Math.ceil(a/7e3))+o),l=i.subarray(n,i.
length-o),c=s.l,m=(s.r||0)&7;if(e){m&&(l[0]=s.r>>3);for(var p=Va[e-1],d=p>>13,h=p&8191,g=(1<<r)-1,f=s.p||new re(32768),y=s.h||new re(g+1),w=Math.ceil(r/3),b=2*w,
v=function(ur){return(t[ur]^t[ur+1]<<w^t[ur+2]<<b)&g},S=new Pr(25e3),T=new re(288),_=new re(32),C=0,A=0,M=s.i||0,W=0,I=s.w||0,B=0;M+2<a;++M){var be=v(M),Q=M&32767,
V=y[be];if(f[Q]=V,y[be]=Q,I<=M){var F=a-M;if((C>7e3||W>24576)&&(F>423||!c)){m=Kn(t,l,0,S,T,_,A,W,B,M-B,m),W=C=A=0,B=M;for(var $=0;$<286;++$)T[$]=0;for(var $=0;$<
30;++$)_[$]=0}var K=2,D=0,qe=h,se=Q-V&32767;if(F>2&&be==v(M-se))for(var ge=Math.min(d,F)-1,ee=Math.min(32767,M),te=Math.min(258,F);se<=ee&&--qe&&Q!=V;){if(t[M+K]==
t[M+K-se]){for(var O=0;O<te&&t[M+O]==t[M+O-se];++O);if(O>K){if(K=O,D=se,O>ge)break;for(var pe=Math.min(se,O-2),Oe=0,$=0;$<pe;++$){var Pe=M-se+$&32767,xt=f[Pe],St=Pe-
xt&32767;St>Oe&&(Oe=St,V=Pe)}}}Q=V,V=f[Q],se+=Q-V&32767}if(D){S[W++]=268435456|kr[K]<<18|jn[D];var Ze=kr[K]&31,Je=jn[D]&31;A+=Rt[Ze]+$t[Je],++T[257+Ze],++_[Je],
I=M+K,++C}else S[W++]=t[M],++T[t[M]]}}for(M=Math.max(M,I);M<a;++M)S[W++]=t[M],++T[t[M]];m=Kn(t,l,c,S,T,_,A,W,B,M-B,m),c||(s.r=m&7|l[m/8|0]<<3,m-=7,s.h=y,s.p=f,s.
i=M,s.w=I)}else{for(var M=s.w||0;M<a+c;M+=65535){var _e=M+65535;_e>=a&&(l[m/8|0]=c,_e=a),m=eo(l,m+1,t.subarray(M,_e))}s.i=a}return Lr(i,0,n+_r(m)+o)},Ya=(function(){
for(var t=new Int32Array(256),e=0;e<256;++e){for(var r=e,n=9;--n;)r=(r&1&&-306674912)^r>>>1;t[e]=r}return t})(),qa=function(){var t=-1;return{p:function(e){for(var r=t,
n=0;n<e.length;++n)r=Ya[r&255^e[n]]^r>>>8;t=r},d:function(){return~t}}};var Za=function(t,e,r,n,o){if(!o&&(o={l:1},e.dictionary)){var s=e.dictionary.subarray(-32768),a=new P(s.length+t.length);a.set(s),a.set(t,s.length),t=a,o.w=s.length}
return Ka(t,e.level==null?6:e.level,e.mem==null?o.l?Math.ceil(Math.max(8,Math.min(13,Math.log(t.length)))*1.5):20:12+e.mem,r,n,o)},ro=function(t,e){var r={};for(var n in t)
r[n]=t[n];for(var n in e)r[n]=e[n];return r};var z=function(t,e,r){for(;r;++e)t[e]=r,r>>>=8};var Ja=function(t,e){return((t[0]&15)!=8||t[0]>>4>7||(t[0]<<8|t[1])%31)&&q(6,"invalid zlib data"),(t[1]>>5&1)==+!e&&q(6,"invalid zlib data: "+(t[1]&32?"need":"u\
nexpected")+" dictionary"),(t[1]>>3&4)+2};function Xa(t,e){return Za(t,e||{},0,0)}function no(t,e){return ja(t.subarray(Ja(t,e&&e.dictionary),-4),{i:2},e&&e.out,e&&e.dictionary)}var oo=function(t,e,r,n){for(var o in t){var s=t[o],a=e+o,i=n;Array.isArray(s)&&(i=ro(n,s[1]),s=s[0]),s instanceof P?r[a]=[s,i]:(r[a+="/"]=[new P(0),i],oo(s,a,r,
n))}},Yn=typeof TextEncoder<"u"&&new TextEncoder,Qa=typeof TextDecoder<"u"&&new TextDecoder,ei=0;try{Qa.decode(to,{stream:!0}),ei=1}catch{}function kt(t,e){if(e){for(var r=new P(t.length),n=0;n<t.length;++n)r[n]=t.charCodeAt(n);return r}if(Yn)return Yn.encode(t);for(var o=t.length,s=new P(t.length+
(t.length>>1)),a=0,i=function(m){s[a++]=m},n=0;n<o;++n){if(a+5>s.length){var l=new P(a+8+(o-n<<1));l.set(s),s=l}var c=t.charCodeAt(n);c<128||e?i(c):c<2048?(i(192|
c>>6),i(128|c&63)):c>55295&&c<57344?(c=65536+(c&1047552)|t.charCodeAt(++n)&1023,i(240|c>>18),i(128|c>>12&63),i(128|c>>6&63),i(128|c&63)):(i(224|c>>12),i(128|c>>
6&63),i(128|c&63))}return Lr(s,0,a)}var Or=function(t){var e=0;if(t)for(var r in t){var n=t[r].length;n>65535&&q(9),e+=n+4}return e},qn=function(t,e,r,n,o,s,a,i){var l=n.length,c=r.extra,m=i&&i.length,
p=Or(c);z(t,e,a!=null?33639248:67324752),e+=4,a!=null&&(t[e++]=20,t[e++]=r.os),t[e]=20,e+=2,t[e++]=r.flag<<1|(s<0&&8),t[e++]=o&&8,t[e++]=r.compression&255,t[e++]=
r.compression>>8;var d=new Date(r.mtime==null?Date.now():r.mtime),h=d.getFullYear()-1980;if((h<0||h>119)&&q(10),z(t,e,h<<25|d.getMonth()+1<<21|d.getDate()<<16|d.
getHours()<<11|d.getMinutes()<<5|d.getSeconds()>>1),e+=4,s!=-1&&(z(t,e,r.crc),z(t,e+4,s<0?-s-2:s),z(t,e+8,r.size)),z(t,e+12,l),z(t,e+14,p),e+=16,a!=null&&(z(t,e,
m),z(t,e+6,r.attrs),z(t,e+10,a),e+=14),t.set(n,e),e+=l,p)for(var g in c){var f=c[g],y=f.length;z(t,e,+g),z(t,e+2,y),t.set(f,e+4),e+=4+y}return m&&(t.set(i,e),e+=
m),e},ti=function(t,e,r,n,o){z(t,e,101010256),z(t,e+8,r),z(t,e+10,r),z(t,e+12,n),z(t,e+16,o)};function so(t,e){e||(e={});var r={},n=[];oo(t,"",r,e);var o=0,s=0;for(var a in r){var i=r[a],l=i[0],c=i[1],m=c.level==0?0:8,p=kt(a),d=p.length,h=c.comment,g=h&&
kt(h),f=g&&g.length,y=Or(c.extra);d>65535&&q(11);var w=m?Xa(l,c):l,b=w.length,v=qa();v.p(l),n.push(ro(c,{size:l.length,crc:v.d(),c:w,f:p,m:g,u:d!=a.length||g&&h.
length!=f,o,compression:m})),o+=30+d+y+b,s+=76+2*(d+y)+(f||0)+b}for(var S=new P(s+22),T=o,_=s-o,C=0;C<n.length;++C){var p=n[C];qn(S,p.o,p,p.f,p.u,p.c.length);var A=30+
p.f.length+Or(p.extra);S.set(p.c,p.o+A),qn(S,o,p,p.f,p.u,p.c.length,p.o,p.m),o+=16+A+(p.m?p.m.length:0)}return ti(S,o,n.length,_,T),S}var N=(t,e=2)=>t==null?"-":t.toFixed(e);function ao(t,e,r){return e===null||r===null?N(t):`${N(t)} (${N(e)} to ${N(r)})`}function ct(t){let e=Math.abs(t),r=e>=1e4?
e.toExponential(0):e.toFixed(e<100?2:0);return t<0&&Number(r)?`−${r}`:r}var io=t=>t.toLocaleString("en-GB"),ce=t=>t.charAt(0).toUpperCase()+t.slice(1);function ut(t,e,r,n=!1){
let o=(e-t)/Math.max(1,r),s=10**Math.floor(Math.log10(o||1)),a=[1,2,5,10].map(c=>c*s).find(c=>c>=o)??10*s;n&&(a=Math.max(1,Math.round(a)));let i=Math.ceil(t/a-1e-9),
l=Math.floor(e/a+1e-9);return Array.from({length:Math.max(0,l-i+1)},(c,m)=>(i+m)*a)}var ri={teams:{pursuer:"pursuers",evader:"evaders"},generation:{pursuer:"pursuer generation",evader:"evader generation"},score:"capture rate",means:{pursuer:"ca\
ptures",evader:"escapes"},curves:{pursuer:"captures",evader:"escapes"},ends:["0 all escape","1 all caught"],lead:"Each cell is a match between two generations: \
the brighter, the more evaders are captured. Click one to watch it.",click:"watch its match"},ni=([t,e])=>({teams:{pursuer:t,evader:e},generation:{pursuer:`gene\
ration of ${t}`,evader:`generation of ${e}`},score:`score of the ${t}`,means:{pursuer:t,evader:e},curves:{pursuer:"scores",evader:"scores"},ends:[`0 the ${e} wi\
n`,`1 the ${t} win`],lead:`Each cell is a pair of generations: the brighter, the higher the score of the ${t}. Click one to see more of it.`,click:"see more of \
it"}),k=({game:t})=>t?ni(t.teams):ri,U=(t,e,r)=>`${k(t).teams[e]} of generation ${r}`,oi=200;function lo(t,e,{pursuer:r,evader:n},o){let{text:s,image:a}=e.shows[`${r}\
 ${n}`]??{},i=Me(t,r,n)?.rates??[],l=`Scores of the ${e.teams[0]} in ${i.length} episodes: ${i.map(c=>N(c)).join(", ")}`;return[s===void 0?null:u("pre",{tabindex:0,
"aria-label":"What the game shows of this pair"},s),a===void 0?null:u("img",{src:a,alt:"What the game shows of this pair",onload:({target:c})=>c.classList.toggle(
"pixels",c.naturalWidth<oi)}),...(s??a)===void 0?[u("p",{class:"muted"},e.missing),si(t,e,r,n,o)]:[],i.length>1?u("p",{class:"small numbers"},l):null].filter(c=>c!==
null)}function si(t,e,r,n,o){let s=Object.keys(e.shows).map(m=>m.split(" ").map(Number)),a=([m,p])=>(m-r)**2+(p-n)**2,[i,l]=s.sort((m,p)=>a(m)-a(p))[0]??[];if(i===
void 0||l===void 0)return null;let c=`${U(t,"pursuer",i)} against ${U(t,"evader",l)}`;return u("p",{},u("button",{type:"button",onclick:()=>o.select({pursuer:i,
evader:l})},`Nearest: ${c}`))}var H=["pursuer","evader"],uo=()=>JSON.parse(Lt("data"));function Me(t,e,r){let[n,o]=[e-t.payoff.first[0],r-t.payoff.first[1]],s=t.payoff.capture_rate[n]?.[o];return s===
void 0?null:{rate:s,rates:t.payoff.capture_rates[n][o],lengths:t.payoff.lengths[n]?.[o]??[]}}function Fe(t,e,r){let{script:n,policy:o,kept:s,genomes:a}=t.teams[e];
if(n!==null||o===null)return"";if(!s.includes(r))return`The page holds no genome of ${U(t,e,r)}: it would be too large. Choose a generation of ${s.join(", ")}.`;
let i=s.length*o.genome_size;return mo(a,o.genome_size).length===i?"":`The page is damaged: it does not hold the ${i} numbers of the ${e}s' genomes. Write it ag\
ain from its run.`}function Z(t,e,r){let{script:n,policy:o,kept:s,genomes:a}=t.teams[e];if(n!==null||o===null)return n??"random";let i=s.indexOf(r);if(i<0)throw new RangeError(
`${e}: expected a generation whose genome the page holds, got ${r}`);let l=o.genome_size,c=mo(a,l).subarray(i*l,(i+1)*l);return{...o,genome:c}}var Ot=({teams:t},e)=>(t[e].
policy??{kind:"cells"}).kind!=="cells",Pt=({teams:t},e,r)=>t[e].expressions?.[t[e].kept.indexOf(r)]??"";function _t(t,e,{pursuer:r,evader:n,episode:o,seed:s}){let a=e.
seeds[r][n];return t.match(e.world,Z(e,"pursuer",r),Z(e,"evader",n),BigInt(s??a),o)}var Nr=4,co=new Map;function mo(t,e){let r=co.get(t);if(r)return r;let n=new Float32Array;try{let o=ii(Ir(t),e);o.every(Number.isFinite)&&(n=o)}catch(o){if(!(o instanceof DOMException||
o instanceof RangeError||ai(o)))throw o}return co.set(t,n),n}var ai=t=>t instanceof Error&&"code"in t;function ii(t,e){let r=no(t),n=r.length/Nr,o=new Uint8Array(
r.length);for(let a=0;a<o.length;a++)o[a]=r[a%Nr*n+Math.floor(a/Nr)];let s=new Uint32Array(o.buffer);for(let a=e;a<s.length;a++)s[a]^=s[a-e];return new Float32Array(
o.buffer)}function Ir(t){let e=atob(Lt(t)),r=new Uint8Array(e.length);for(let n=0;n<r.length;n++)r[n]=e.charCodeAt(n);return r}var Lt=t=>document.getElementById(
t)?.textContent??"";var mt=[.5,1,2,4,8,16,32,64],Nt=0,It=12,li=2,De=class extends EventTarget{#e;#r;#t;#n=0;#a=0;#s=!1;#u=null;#f=0;#h=[];#m=[];glide=.28;constructor(e,{speed:r=4,still:n=!1}={}){
super(),[this.#e,this.#r,this.#t]=[e,r,n]}get step(){return this.#n}get time(){return this.#t?this.#n:this.#a}get arrived(){return this.#a===this.#n}get playing(){
return this.#s}get length(){return this.#e}set length(e){this.#e=e,this.#n>e&&this.jump(e),this.#o("state")}get marks(){return this.#h}set marks(e){this.#h=e,this.#o(
"state")}get ticks(){return this.#m}set ticks(e){this.#m=e,this.#o("state")}get pace(){return this.#r||Math.max(li,this.#e/It)}get speed(){return this.#r}set speed(e){
this.#r=e,this.#o("state")}changeSpeed(e){let r=mt.findIndex(n=>n>=this.pace);this.speed=mt[Math.min(mt.length-1,Math.max(0,r+e))]}play(){this.#s||!this.#e||(this.#n===
this.#e&&this.jump(0),this.#s=!0,this.#o("state"),this.#l())}pause(){this.#s&&(this.#s=!1,this.#o("state"))}toggle(){this.#s?this.pause():this.play()}move(e){this.
pause();let r=Math.min(this.#e,Math.max(0,this.#n+e));Math.abs(r-this.#a)>1?this.jump(r):this.#p(r),this.#l()}jump(e){this.#a=Math.min(this.#e,Math.max(0,Math.round(
e))),this.#p(this.#a),this.#o("frame")}#p(e){e!==this.#n&&(this.#n=e,this.#o("step"),this.#t&&this.#o("frame"))}#l(){this.#u===null&&(this.#f=performance.now(),
this.#u=requestAnimationFrame(()=>this.#i()))}#i(){this.#u=null;let e=performance.now();this.#c(Math.min(.25,(e-this.#f)/1e3)),this.#f=e,(!this.#t||this.arrived)&&
this.#o("frame"),(this.#s||this.#a!==this.#n)&&(this.#u=requestAnimationFrame(()=>this.#i()))}#c(e){let r=e;for(;r>0;){if(this.#a===this.#n){if(!this.#s)return;
if(this.#n===this.#e)return this.pause();this.#p(this.#n+1)}let n=this.#s?this.pace:1/this.glide,o=this.#n-this.#a,s=Math.min(Math.abs(o),r*n);r-=s/n,this.#a=s===
Math.abs(o)?this.#n:this.#a+Math.sign(o)*s}this.#s&&this.#a===this.#e&&this.pause()}#o(e){this.dispatchEvent(new Event(e))}};function ze(t,e){if(e.ctrlKey||e.metaKey||
e.altKey)return!1;let r=e.shiftKey?10:1,o={" ":()=>t.toggle(),ArrowRight:()=>t.move(r),ArrowLeft:()=>t.move(-r),Home:()=>t.move(-t.length),End:()=>t.move(t.length),
"+":()=>t.changeSpeed(1),"-":()=>t.changeSpeed(-1)}[e.key];return o?.(),o!==void 0}function po(t,e,...r){let n=u("dialog",{class:e,"aria-label":t,onclick:({target:o})=>o===n&&n.close()},u("div",{class:"dialog-head"},u("h2",{},t),u("button",{type:"\
button",class:"close","aria-label":"Close",onclick:()=>n.close()},"✕")),...r);return n}var ho=t=>u("dl",{class:"keys"},...t.flatMap(([e,r])=>[u("dt",{},...e.map(
n=>u("kbd",{},n))),u("dd",{},r)])),fo=t=>u("input",{type:"text",readonly:!0,"aria-label":t});function go(t,e){let r=URL.createObjectURL(new Blob([e],{type:"appl\
ication/octet-stream"}));u("a",{href:r,download:t}).click(),setTimeout(()=>URL.revokeObjectURL(r),6e4)}var pt=[[68,1,84],[72,26,108],[71,47,125],[65,68,135],[57,86,140],[49,104,142],[42,120,142],[35,136,142],[31,152,139],[34,168,132],[53,183,121],[84,197,104],[122,
209,81],[165,219,54],[210,226,27],[253,231,37]];function Ut(t){let e=Math.min(1,Math.max(0,t))*(pt.length-1),r=Math.min(pt.length-2,Math.floor(e)),[n,o]=[pt[r],
pt[r+1]],s=a=>Math.round(n[a]+(e-r)*(o[a]-n[a]));return[s(0),s(1),s(2)]}function yo(t){let[e,r,n]=Ut(t).map(o=>((o/255+.055)/1.055)**2.4);return .2126*e+.7152*r+
.0722*n>.179?"#000":"#fff"}var vo=t=>`rgb(${Ut(t).join(" ")})`,bo=()=>`linear-gradient(to right, ${pt.map(t=>`rgb(${t.join(" ")})`).join(", ")})`;function Wt(t,e,r){let n=devicePixelRatio||1;for(let[a,i]of Object.entries(r))t.style.setProperty(a,`${i}px`);t.width=Math.round(r.width*n),t.height=Math.round(
r.height*n);let o=t.getContext("2d"),s=Ur(e);!o||!s||(o.imageSmoothingEnabled=!1,o.drawImage(s,0,0,t.width,t.height))}function Ur(t){let[e,r]=t.shape,n=document.
createElement("canvas");[n.width,n.height]=[r,e];let o=n.getContext("2d");if(!o)return null;let s=o.createImageData(r,e);return t.capture_rate.forEach((a,i)=>a.
forEach((l,c)=>{let m=4*((e-1-i-t.first[0])*r+c+t.first[1]);s.data.set([...Ut(l),255],m)})),o.putImageData(s,0,0),n}function Ft(t,e,r,n=2){t.textContent=N(e,n),
t.ariaLabel=`${r}: ${t.textContent}`,e!==void 0&&([t.style.backgroundColor,t.style.color]=[vo(e),yo(e)])}function dt(t,e){let r=u("span",{class:"gradient"});return r.
style.backgroundImage=bo(),u("p",{class:"scale-of-rates small muted"},t,r,e)}var ci=84;function wo(t,e){let r=t.map((s,a)=>ui(s,a,e)),n=u("nav",{class:"races","aria-label":"Runs"},...r.map(s=>s.button)),o=()=>r.forEach((s,a)=>s.update(a===
e.selected.run));return e.on("match hover",o),o(),n.hidden=t.length<2,n}function ui(t,e,r){let[n,o]=t.payoff.shape,s=!t.name.startsWith(t.schedule),a=ci/Math.max(
n,o),i=u("canvas",{"aria-hidden":"true"});Wt(i,t.payoff,{left:0,top:0,width:o*a,height:n*a});let l=u("span",{class:"place"}),c=u("button",{type:"button",class:"\
race",title:`${t.name} (key ${e+1})`,onclick:()=>Wr(t,e,r)},u("span",{class:"small-matrix"},i,l),u("span",{class:"race-text"},u("strong",{},s?t.name:t.schedule),
u("span",{class:"small"},t.findings?t.findings.headline:`${t.learning.map(p=>k(t).teams[p]).join(" and ")} against ${mi(t)}`),u("span",{class:"small muted"},`${s?
`${t.schedule}, `:""}seed ${t.seed}`)));return{button:c,update:p=>{c.setAttribute("aria-current",String(p));let d=r.hover.pursuer??r.selected.pursuer,h=r.hover.
evader??r.selected.evader;l.hidden=d>=n||h>=o,l.style.left=`${(h+.5)*a}px`,l.style.top=`${(n-d-.5)*a}px`}}}var mi=t=>t.teams.pursuer.script??t.teams.evader.script??
"another run";function Wr(t,e,r){let[n,o]=t.payoff.shape,{pursuer:s,evader:a}=r.selected;r.select({run:e,pursuer:Math.min(s,n-1),evader:Math.min(a,o-1)})}var pi=t=>[[["Space"],"play or pause"],[["←","→"],"step back or forward; with Shift ten steps"],[["Home","End"],"first or last step"],[["+","−"],"faster o\
r slower"],[["N"],"next episode of the same pair; with Shift the one before"],[["R"],"another seed, not one of the evaluation"],[["O"],"the cell's own seed agai\
n"],[["P"],`next ${k(t).generation.pursuer}; with Shift the one before`],[["E"],`next ${k(t).generation.evader}; with Shift the one before`],[["M"],`to the matr\
ix: arrow keys choose a ${t.game?"pair, Enter shows it":"match, Enter plays it"}`],[["A"],"next agent: what it sees; with Shift the one before"],[["Esc"],"no ag\
ent"],[["T"],"take over the chosen agent, or an evader, from this step on"],[["G"],"this step in the playground: any other rules, actions and places"],[["1","9"],
"first to ninth run"],[["D"],"light or dark"],[["?"],"this list"]],di=["P","E","M","1","D","?"],hi="The page holds the genomes and the engine of this run. A cli\
ck on a cell plays that very match: same seed, same moves. ";function xo(t){let e=t.find(({game:n})=>!n),r=pi(e??t[0]).filter(([[n]])=>e||di.includes(n));return po(
"Keys","help",ho(r),u("p",{class:"muted small"},`${e?hi:""}The page loads nothing from elsewhere; share the file as it is.`))}function So(t,e,r,n,o,s){let a=(l,c)=>()=>{
let m=t[e.selected.run].payoff.shape[l==="pursuer"?0:1];e.select({[l]:Math.min(m-1,Math.max(0,e.selected[l]+c))})},i={n:()=>e.select({episode:e.selected.episode+
1}),N:()=>e.select({episode:Math.max(0,e.selected.episode-1)}),r:()=>e.select({seed:String(crypto.getRandomValues(new BigUint64Array(1))[0]),episode:0}),o:()=>e.
select({seed:null,episode:0}),p:a("pursuer",1),P:a("pursuer",-1),e:a("evader",1),E:a("evader",-1),m:()=>document.getElementById("matrix")?.focus(),a:()=>r.inspector.
next(1),A:()=>r.inspector.next(-1),Escape:()=>r.inspector.choose(null),t:o,g:s,d:Mr,"?":()=>n.showModal()};document.addEventListener("keydown",l=>{let c=l.target instanceof
HTMLSelectElement||l.target instanceof HTMLInputElement,m=l.target instanceof HTMLButtonElement&&(l.key===" "||l.key==="Enter");if(document.querySelector("dialo\
g[open]")||c||m||l.defaultPrevented||l.ctrlKey||l.metaKey||l.altKey)return;let p=i[l.key]??i[l.key.toLowerCase()],d=Number(l.key)-1;if(ze(r.player,l)||p)p?.();else if(t[d])
Wr(t[d],d,e);else return;l.preventDefault()})}var Be=[[0,0],[-1,0],[0,1],[1,0],[0,-1],[-1,1],[1,1],[1,-1],[-1,-1]];function Mo(t,e,r){let[n,o]=[e[0]-t[0],e[1]-t[1]];return!r&&Math.abs(n)>Math.abs(o)?o=0:r||
(n=0),Be.findIndex(([s,a])=>s===Math.sign(n)&&a===Math.sign(o))}var Ce=(t,e)=>e<t.nPursuers,R=(t,e)=>[t.positions[2*e],t.positions[2*e+1]],Fr=({rows:t,cols:e},[
r,n])=>r>=0&&n>=0&&r<t&&n<e,Dr=(t,e,r=3)=>t!==void 0&&[0,1,2].slice(0,r).some(n=>t[3*e+n]),zr=(t,e)=>Dr(t.fault,e),Ao=(t,e)=>!zr(t,e)&&Dr(t.involved,e,2);function Dt(t,e,r){
let[n,o]=[R(t,r),R(e,r)],s=n[0]!==o[0]||n[1]!==o[1],a=e.involved===void 0||Dr(e.involved,r);return!!(e.alive[r]&&e.actions?.[r]&&!s&&a)}function zt(t,e,r){let[n,
o]=R(t,r),[s,a]=Be[e.actions?.[r]??0];return[n+s,o+a]}function ht(t,e,r){return Array.from({length:r.everCaptured.length},(o,s)=>s).filter(o=>r.everCaptured[o]&&
!e.everCaptured[o]).map(o=>t.nPursuers+o)}var To=t=>t.moments.flatMap((e,r)=>r&&ht(t,t.moments[r-1],e).length?[r]:[]);function Bt(t,e){return Array.from({length:e.
alive.length},(n,o)=>o).filter(n=>t.alive[n]&&!e.alive[n])}var Eo=[-.31,0,.31],Co=[{size:1,at:[[0,0]]},{size:.62,at:[[-.2,.2],[.2,-.2]]},{size:.54,at:[[-.23,.22],[.23,.22],[0,-.22]]},{size:.54,at:[[-.23,.23],[.23,.23],[
-.23,-.23],[.23,-.23]]},{size:.36,at:Eo.flatMap(t=>Eo.map(e=>[e,t]))}],fi=.3,gi=.35,yi=.55;function ft(t,e){let r=new Map;for(let n=0;n<e.alive.length;n++){if(!e.
alive[n])continue;let[o,s]=R(e,n),a=o*t.cols+s,i=r.get(a);i?i.push(n):r.set(a,[n])}return r}function ko(t,e){let r=Array.from(e.alive,(n,o)=>{let[s,a]=R(e,o);return{
x:a+.5,y:s+.5,size:1,alpha:0}});for(let n of ft(t,e).values()){let o=Co[Math.min(n.length,Co.length)-1];n.forEach((s,a)=>{let[i,l]=o.at[Math.min(a,o.at.length-1)],
c=r[s];c.x+=i,c.y+=l,c.size=o.size,c.alpha=1})}return r}var Ro=t=>t*t*(3-2*t),He=(t,e,r)=>t+(e-t)*r,$o=t=>Math.min(1,Math.max(0,t));function Oo(t,e,r,n){let o={
SIMULTANEOUS:1,SWARM_TURNS:2,AGENT_TURNS:r}[t.interaction];if(o===1)return Ro(n);let s=o===r?e:+!Ce(t,e),a=Math.max(1/o,gi);return Ro($o((n-s/(o-1)*(1-a))/a))}function Ht(t,e){
let r=t.moments.length-1,n=Math.min(Math.floor(e),r),o=t.moments[n],s=ko(t,o);if(n===r||e===n)return s;let a=t.moments[n+1],i=ko(t,a);return s.map((l,c)=>{let m=Oo(
t,c,s.length,e-n);return vi(o,a,c,l,i[c],m)})}function Br(t,e,r){let n=t.moments.length-1,o=Math.min(Math.floor(r),n),[s,a]=[t.moments[o],t.moments[Math.min(o+1,
n)]],i=Oo(t,e,s.alive.length,r-o),[[l,c],[m,p]]=[R(s,e),R(a,e)];return[He(c,p,i)+.5,He(l,m,i)+.5]}function vi(t,e,r,n,o,s){let a=n.alpha>o.alpha,i={x:He(n.x,o.x,
s),y:He(n.y,o.y,s),size:a?n.size:He(n.size,o.size,s),alpha:a?$o((1-s)/(1-yi)):He(n.alpha,o.alpha,s)};if(Dt(t,e,r)){let[l,c]=R(t,r),[m,p]=zt(t,e,r),d=fi*Math.sin(
Math.PI*s);i.x+=(p-c)*d,i.y+=(m-l)*d}return i}var Po=2*Math.PI;function ke(t,e,r,n){t.beginPath(),t.arc(e,r,n/2,0,Po)}function Gt(t,e,r,n){let o=n/2,s=[[0,-.97],[.97,.83],[-.97,.83]].map(([a,i])=>[e+a*o,r+i*
o]);t.beginPath(),t.moveTo((s[2][0]+s[0][0])/2,(s[2][1]+s[0][1])/2),s.forEach(([a,i],l)=>{let[c,m]=s[(l+1)%3];t.arcTo(a,i,c,m,n*.09)}),t.closePath()}function _o(t,e,r,n){
let o=n*.32;t.beginPath(),t.moveTo(e-o,r-o),t.lineTo(e+o,r+o),t.moveTo(e+o,r-o),t.lineTo(e-o,r+o)}function Lo(t,e,r,n){t.beginPath();for(let o=0;o<16;o++){let s=n/
2*(o%2?.6:.95),a=Po*o/16;t.lineTo(e+s*Math.sin(a),r-s*Math.cos(a))}t.closePath()}function No(t,e,r,n,o,s){let a=Math.atan2(o-r,n-e);t.beginPath(),t.moveTo(e,r),
t.lineTo(n,o);for(let i of[-1,1])t.moveTo(n,o),t.lineTo(n-s*Math.cos(a+i*.6),o-s*Math.sin(a+i*.6))}var Io=4,bi=1.6,wi=.95,xi=5,Si=.16,Mi=9,Ai=.09,Ti=.2,Uo=.75,G=(t,e)=>t.left+e*t.cell,j=(t,e)=>t.top+e*t.cell;function Ge(t,e,r){return Ce(e,r)?t.colors.pursuer:
t.colors.evader}function jt({ctx:t,colors:e},r,n,o,s,a,i=0){t.font=`700 ${Math.round(s)}px system-ui, sans-serif`,t.textAlign="center",t.textBaseline="middle",t.
strokeStyle=e.paper,t.lineWidth=i,i&&t.strokeText(r,n,o),t.fillStyle=a,t.fillText(r,n,o)}function Wo({ctx:t,grid:e,colors:r}){let{left:n,top:o,cell:s,rows:a,cols:i}=e,
[l,c]=[i*s,a*s];if(t.fillStyle=r.paper,t.fillRect(n,o,l,c),s<xi)return;t.fillStyle=r.line;let m=Math.max(1,Math.round(s/60));for(let p=1;p<i;p++)t.fillRect(n+p*
s,o,m,c);for(let p=1;p<a;p++)t.fillRect(n,o+p*s,l,m)}function Fo({ctx:t,grid:e,colors:r},n){let{left:o,top:s,cell:a,rows:i,cols:l}=e;t.fillStyle=r.obstacle;for(let c=0;c<
i*l;c++){if(!n.obstacles[c])continue;let[m,p]=[Math.floor(c/l),c%l];t.fillRect(o+p*a,s+m*a,a,a)}Do({ctx:t,grid:e,colors:r})}function Do({ctx:t,grid:{left:e,top:r,
cell:n,rows:o,cols:s},colors:a}){let i=Math.min(5,Math.max(2,Math.round(n/18)));t.strokeStyle=a.frame,t.lineWidth=i,t.strokeRect(e-i/2,r-i/2,s*n+i,o*n+i)}function zo({
ctx:t,grid:e,colors:r},n){let{left:o,top:s,cell:a,rows:i,cols:l}=e,c=a<24*n?5:1;t.font=`500 ${Math.round(Math.min(15*n,Math.max(9*n,a*.32)))}px system-ui, sans-\
serif`,t.fillStyle=r.muted,t.textBaseline="alphabetic",t.textAlign="center";let m=5*n+a/40;for(let p=0;p<l;p+=c)t.fillText(String(p),o+(p+.5)*a,s-m);t.textAlign=
"right",t.textBaseline="middle";for(let p=0;p<i;p+=c)t.fillText(String(p),o-m,s+(p+.5)*a)}function Bo({grid:t},e,r,n){let o=Math.floor(e.fov/2)+.5,[s,a]=[Math.max(
0,r-o),Math.min(t.cols,r+o)],[i,l]=[Math.max(0,n-o),Math.min(t.rows,n+o)];return[G(t,s),j(t,i),(a-s)*t.cell,(l-i)*t.cell]}function Ho(t,e,r,n){let{ctx:o,grid:s,
colors:a}=t;o.save(),o.beginPath(),o.rect(0,0,o.canvas.width,o.canvas.height),o.rect(...Bo(t,e,r,n)),o.clip("evenodd"),o.clearRect(0,0,o.canvas.width,o.canvas.height),
o.fillStyle=a.line,o.fillRect(s.left,s.top,s.cols*s.cell,s.rows*s.cell),o.restore(),Do(t)}function Go(t,{x:e,y:r,alpha:n},o){let{ctx:s,grid:a,colors:i}=t,l=Math.
max(a.cell,16*o)*1.06,[c,m]=[G(a,e),j(a,r)];s.globalAlpha=Math.max(n,.6),s.beginPath(),s.roundRect(c-l/2,m-l/2,l,l,l*.2),s.strokeStyle=i.focus,s.lineWidth=Math.
max(2,2.5*o),s.stroke();let p=Math.max(11*o,Math.min(18*o,a.cell*.5)),d=m-l/2<p*1.2,h=m+(d?1:-1)*(l/2+p*.7);s.lineJoin="round",jt(t,"You",c,h,p,i.ink,p*.35),s.globalAlpha=
1}function jo(t,e,r,n,o){let{ctx:s,grid:a}=t,i=Bo(t,e,n,o),l=Ge(t,e,r);s.globalAlpha=.11,s.fillStyle=l,s.fillRect(...i),s.globalAlpha=.8,s.strokeStyle=l,s.lineWidth=
Math.max(1,a.cell/24),s.strokeRect(...i),s.globalAlpha=1}function Vo(t,e,r,n,o){let{ctx:s,grid:a}=t,i=Math.min(Math.ceil(r),e.moments.length-1),l=e.moments[i];s.
lineCap="round",s.lineWidth=Math.min(Mi,Math.max(1,a.cell*Si));for(let c=Math.max(1,Math.floor(r-n)+1);c<=i;c++){let[m,p]=[e.moments[c-1],e.moments[c]],d=Math.max(
0,Math.min(1,(r-c)/n));s.globalAlpha=Uo+(Ti-Uo)*d;for(let h=0;h<p.alive.length;h++){let g=c===i&&r<i;if(!m.alive[h]||!(l.alive[h]||g))continue;let f=(Ce(e,h)?-1:
1)*Ai,[y,w]=R(m,h),[b,v]=R(p,h);if(y===b&&w===v)continue;let S=g?o[h].x:v+.5,T=g?o[h].y:b+.5;s.strokeStyle=Ge(t,e,h),s.beginPath(),s.moveTo(G(a,w+.5+f),j(a,y+.5+
f)),s.lineTo(G(a,S+f),j(a,T+f)),s.stroke()}}s.globalAlpha=1}function Ko(t,e,r){let n=Math.min(Math.ceil(r),e.moments.length-1);for(let o=Math.max(1,n-Io+1);o<=n;o++){
let[s,a]=[e.moments[o-1],e.moments[o]],i=o>r?Math.max(0,1-2*(o-r)):1-(r-o)/Io,l=ht(e,s,a);for(let c of Bt(s,a))l.includes(c)||Ci(t,R(a,c),i);for(let c of l)Ei(t,
R(a,c),i)}t.ctx.globalAlpha=1}function Ei({ctx:t,grid:e,colors:r},[n,o],s){t.globalAlpha=s,Lo(t,G(e,o+.5),j(e,n+.5),Math.max(8,e.cell*bi)),t.fillStyle=r.capture,
t.fill(),t.strokeStyle=r.ink,t.lineWidth=Math.max(1,e.cell/36),t.lineJoin="round",t.stroke()}function Ci({ctx:t,grid:e,colors:r},[n,o],s){t.globalAlpha=s,_o(t,G(
e,o+.5),j(e,n+.5),Math.max(7,e.cell*wi)),t.strokeStyle=r.collision,t.lineWidth=Math.max(2,e.cell*.17),t.lineCap="round",t.stroke()}function Yo({ctx:t,grid:e,colors:r},n,o){
let s=Math.max(1,e.cell*.07);t.strokeStyle=t.fillStyle=r.collision,t.lineWidth=Math.max(1,e.cell*.05),t.setLineDash([e.cell*.14,e.cell*.1]);for(let[a,i]of n){if(a<
0||i<0||a>=e.rows||i>=e.cols)continue;let l=[G(e,i)+s,j(e,a)+s,e.cell-2*s,e.cell-2*s];t.globalAlpha=.2*o,t.fillRect(...l),t.globalAlpha=o,t.strokeRect(...l)}t.setLineDash(
[]),t.globalAlpha=1}function qo({ctx:t,grid:e,colors:r},n,o,s,a){t.globalAlpha=a,ke(t,G(e,n),j(e,o),Math.max(8,e.cell*s*1.02)),t.strokeStyle=r.collision,t.lineWidth=
Math.max(1.5,e.cell*.085*Math.sqrt(s)),t.stroke(),t.globalAlpha=1}var ki=.8,Ri=.92,$i=15,Oi=7,Hr=9;function Zo(t,e,r,n,o,s){n.forEach((a,i)=>{a.alpha>0&&Pi(t,e,r,i,a,o,s)}),t.ctx.globalAlpha=1;for(let a of ft(e,r).values())a.length>
Hr&&_i(t,n[a[Hr-1]],a.length-Hr+1)}function Pi(t,e,r,n,o,s,a){let{ctx:i,grid:l,colors:c}=t,m=Ce(e,n),[p,d]=[G(l,o.x),j(l,o.y)],h=Math.max(4,l.cell*o.size*(m?Ri:
ki)),g=Ge(t,e,n),f=!m&&!!r.captured[n-e.nPursuers];if(i.globalAlpha=o.alpha,(m?Gt:ke)(i,p,d,h),h>Oi*a&&(i.strokeStyle=c.paper,i.lineWidth=Math.max(2,h*.1),i.stroke()),
i.fillStyle=f?c.paper:g,i.fill(),f&&(ke(i,p,d,h*.82),i.strokeStyle=g,i.lineWidth=h*.18,i.stroke()),!s||h<$i*a)return;let y=String(m?n:n-e.nPursuers),w=h*(m?.4:.5)*
(y.length>1?.8:1);jt(t,y,p,d+h*(m?.17:.03),w,f?g:c.paper)}function _i(t,e,r){let{cell:n}=t.grid;jt(t,`+${r}`,G(t.grid,e.x),j(t.grid,e.y),n*.3,t.colors.ink,n*.1)}var Li=.46,Ni=.86,Ii=.66,Jo=.48,Ui=.78,Wi=.58;function Xo(t,e,r,n){let[o,s]=[e.moments[r-1],e.moments[r]];if(!o)return;let{ctx:a,grid:i,colors:l}=t;a.strokeStyle=
l.collision,a.lineWidth=Math.max(1.5,i.cell*.07),a.lineCap="butt",a.globalAlpha=n;for(let c=0;c<s.alive.length;c++)Dt(o,s,c)&&Fi(t,e,R(o,c),zt(o,s,c));a.globalAlpha=
1}function Fi({ctx:t,grid:e},r,n,o){let[s,a]=[o[1]-n[1],o[0]-n[0]],i=p=>G(e,n[1]+.5+s*p),l=p=>j(e,n[0]+.5+a*p),c=Fr(r,o)?Ui:Wi;t.setLineDash([e.cell*.09,e.cell*
.06]),t.beginPath(),t.moveTo(i(Jo),l(Jo)),t.lineTo(i(c),l(c)),t.stroke(),t.setLineDash([]);let m=.17*e.cell/Math.hypot(s,a);t.beginPath(),t.moveTo(i(c)-a*m,l(c)+
s*m),t.lineTo(i(c)+a*m,l(c)-s*m),t.stroke()}function Qo(t,e,r,n,o,s){let a=Be[s];if(!s||!a)return;let{ctx:i,grid:l,colors:c}=t,m=Fr(e,[n[0]+a[0],n[1]+a[1]])?Ni:
Ii,p=Li*o.size,d=[G(l,o.x+a[1]*p),j(l,o.y+a[0]*p),G(l,o.x+a[1]*m),j(l,o.y+a[0]*m)],h=Math.max(1.5,l.cell*.085);i.lineCap=i.lineJoin="round";for(let[g,f]of[[c.paper,
h*2.1],[Ge(t,e,r),h]])i.strokeStyle=g,i.lineWidth=f,No(i,...d,l.cell*.2),i.stroke()}var ts={numbers:!0,axes:!1,trail:6,viewers:[],plan:null,selected:null,cursor:null,you:null,fog:!1};function rs(t,e,r,n,o){let{ctx:s,grid:a,colors:i}=t,l=Math.min(
Math.ceil(r),e.moments.length-1),c=e.moments[l],m=r===l,p=Ht(e,r),d=m?1:Math.max(0,1-2*(l-r));s.clearRect(0,0,s.canvas.width,s.canvas.height),Wo(t);for(let f of n.
viewers)p[f]?.alpha&&jo(t,e,f,...Br(e,f,r));Fo(t,e),n.axes&&zo(t,o),Vo(t,e,r,n.trail,p),Yo(t,c.contested??[],d),Ko(t,e,r),Xo(t,e,l,d),p.forEach(({x:f,y,size:w},b)=>{
let v=Ao(c,b)?.4:0,S=zr(c,b)?1:v;S&&qo(t,f,y,w,S*d)});let h=m?c:e.moments[Math.max(0,l-1)];if(Zo(t,e,h,p,n.numbers,o),m&&n.plan)for(let[f,y]of p.entries())y.alpha&&
Qo(t,e,f,R(c,f),y,n.plan[f]??0);n.you!==null&&(n.fog&&Ho(t,e,...Br(e,n.you,r)),Go(t,p[n.you],o)),s.lineWidth=Math.max(2,2.5*o),s.strokeStyle=i.focus;let g=n.selected===
null?void 0:p[n.selected];g?.alpha&&es(t,g.x,g.y,g.size*.96),n.cursor&&(s.setLineDash([a.cell*.12,a.cell*.08]),es(t,n.cursor[1]+.5,n.cursor[0]+.5,.8),s.setLineDash(
[]))}function es({ctx:t,grid:e},r,n,o){let s=o*e.cell;t.beginPath(),t.roundRect(e.left+r*e.cell-s/2,e.top+n*e.cell-s/2,s,s,s*.1),t.stroke()}var ns=(t,e)=>(e+.24)/(t+.24);function os(t,e,r,n,o,s){let a=r?28*s:0,i=(c,m)=>(c-a)/(m+2*.12),l=Math.max(1,Math.floor(Math.min(i(n,e),i(o,t))));return{rows:t,cols:e,
cell:l,left:Math.round((n-e*l+a)/2),top:Math.round((o-t*l+a)/2)}}function ss(t,e,r){let n=Math.floor((r-t.top)/t.cell),o=Math.floor((e-t.left)/t.cell);return n>=
0&&n<t.rows&&o>=0&&o<t.cols?[n,o]:null}var Di=["paper","line","frame","ink","muted","obstacle"],zi=["pursuer","evader","capture","collision","focus"];function Vt(t){let e=getComputedStyle(t),r=(n,o)=>[
n,e.getPropertyValue(o+n).trim()];return Object.fromEntries([...Di.map(n=>r(n,"--board-")),...zi.map(n=>r(n,"--"))])}var Ve=()=>matchMedia("(prefers-reduced-motion: reduce)").matches,je=class{canvas;#e=null;#r=0;#t;#n={rows:1,cols:1,left:0,top:0,cell:1};#a=0;constructor(e,r={}){
this.canvas=e,e.classList.add("board"),e.setAttribute("role","img"),this.#t={...ts,...r},new ResizeObserver(()=>this.#u()).observe(e),new MutationObserver(()=>this.
redraw()).observe(document.documentElement,{attributes:!0}),addEventListener("beforeprint",()=>this.drawNow())}set look(e){this.#t={...this.#t,...e},this.#s(),this.
redraw()}show(e,r){this.#e=e,this.#r=Math.min(Math.max(0,r),e.moments.length-1),this.#s(),this.redraw()}redraw(){this.#a||(this.#a=requestAnimationFrame(()=>this.
drawNow()))}drawNow(){cancelAnimationFrame(this.#a),this.#a=0;let e=this.canvas.getContext("2d");if(!e||!this.#e)return;let{rows:r,cols:n}=this.#e,o=devicePixelRatio||
1;this.#n=os(r,n,this.#t.axes,this.canvas.width,this.canvas.height,o);let s={ctx:e,grid:this.#n,colors:Vt(this.canvas)};rs(s,this.#e,this.#r,this.#t,o)}cellAt(e,r){
let n=this.canvas.getBoundingClientRect(),o=this.canvas.width/n.width;return ss(this.#n,(e-n.left)*o,(r-n.top)*o)}agentAt(e,r){let n=this.cellAt(e,r);if(!n||!this.#e)
return null;let o=this.#e.moments[Math.round(this.#r)],s=ft(this.#e,o).get(n[0]*this.#e.cols+n[1])??[],a=Ht(this.#e,Math.round(this.#r)),i=l=>{let[c,m]=this.pointOf(
a[l].x,a[l].y);return Math.hypot(c-e,m-r)};return s.length?s.reduce((l,c)=>i(c)<i(l)?c:l):null}pointOf(e,r){let n=this.canvas.getBoundingClientRect(),o=n.width/
this.canvas.width,{left:s,top:a,cell:i}=this.#n;return[n.left+(s+e*i)*o,n.top+(a+r*i)*o]}#s(){if(!this.#e)return;let{rows:e,cols:r}=this.#e;this.canvas.style.setProperty(
"--board-aspect",String(ns(e,r)))}#u(){let e=devicePixelRatio||1,{width:r,height:n}=this.canvas.getBoundingClientRect();this.canvas.width=Math.max(1,Math.round(
r*e)),this.canvas.height=Math.max(1,Math.round(n*e)),this.drawNow()}};function Gr(t,e,r){let{rows:n,cols:o,n_pursuers:s,fov:a,rules:{interaction:i}}=t;return{rows:n,cols:o,nPursuers:s,fov:a,interaction:i,obstacles:e,moments:r}}function jr(t,e){
return{positions:t.read("last_positions"),alive:t.read("alive"),captured:t.read("captured"),everCaptured:t.read("ever_captured"),actions:e,involved:t.read("invo\
lved"),fault:t.read("fault"),contested:t.conflicts().map(r=>r.cell)}}function as(t){let e=Array.from({length:t.length+1},(r,n)=>Bi(t,n));return Gr(t.config,t.map,
e)}function Bi(t,e){let r=t.n_agents,n=t.config.n_evaders,o=(a,i,l)=>a.subarray(i*l,(i+1)*l),s={positions:o(t.last_positions,e,2*r),alive:o(t.alive,e,r),captured:o(
t.captured,e,n),everCaptured:o(t.ever_captured,e,n)};return e===0?s:{...s,actions:o(t.actions,e-1,r),involved:o(t.involved,e-1,3*r),fault:o(t.fault,e-1,3*r),get contested(){
return t.conflicts(e).map(a=>a.cell)}}}var Hi=Array.from({length:16},(t,e)=>{let[r,n]=[e%2?6.5:11,Math.PI*e/8];return`${12+r*Math.sin(n)} ${12-r*Math.cos(n)}`}).join(" ");function is(){let t=[["pursu\
er",x("path",{d:"M12 3 22 20H2z",class:"filled-pursuer"})],["evader",x("circle",{cx:12,cy:12,r:9,class:"filled-evader"})],["capture",x("polygon",{points:Hi,class:"\
filled-capture"})],["captured evader",x("circle",{cx:12,cy:12,r:7.5,class:"ring-evader"})],["conflict",x("rect",{x:3,y:3,width:18,height:18,class:"dashed-confli\
ct"})]];return u("ul",{class:"shapes small","aria-label":"Shapes on the board"},...t.map(([e,r])=>u("li",{},x("svg",{viewBox:"0 0 24 24","aria-hidden":"true"},r),
e)))}var Gi={first:"M6 5v14M19 5 9 12l10 7z",back:"M17 5 7 12l10 7z",play:"M7 4.5 19 12 7 19.5z",pause:"M8 5v14M16 5v14",forward:"M7 5l10 7-10 7z",last:"M18 5v14M5 5\
l10 7-10 7z"};function ls(t){return x("svg",{viewBox:"0 0 24 24","aria-hidden":"true",class:"icon"},x("path",{d:Gi[t]}))}function gt(t,e,r,n){return u("button",
{type:"button",class:"player-button","aria-label":e,title:`${e} (${r})`,onclick:n},ls(t))}function Kt(t){let e=gt("play","Play","Space",()=>t.toggle()),r=u("inp\
ut",{type:"range",class:"player-scrub",min:0,step:1,"aria-label":"Step",oninput:()=>{t.pause(),t.jump(Number(r.value))}}),n=u("div",{class:"captures","aria-hidd\
en":"true",title:"Captures"}),o=u("div",{class:"losses","aria-hidden":"true"}),s=u("select",{class:"player-speed","aria-label":"Speed",title:`Steps a second, or\
 the whole in ${It} s (+ and -)`,onchange:()=>t.speed=Number(s.value)},u("option",{value:Nt},`in ${It} s`),...mt.map(p=>u("option",{value:p},`${p} / s`))),a=u("\
output",{class:"player-count"}),i=u("div",{class:"player",role:"group","aria-label":"Player"},gt("first","First step","Home",()=>t.move(-t.length)),gt("back","S\
tep back","←",()=>t.move(-1)),e,gt("forward","Step forward","→",()=>t.move(1)),gt("last","Last step","End",()=>t.move(t.length)),u("div",{class:"scrub"},n,o,
r),a,s),l=(p,d={})=>{let h=u("i",d);return h.style.left=`${100*p/Math.max(1,t.length)}%`,h},c=()=>{n.replaceChildren(...t.marks.map(p=>l(p))),o.replaceChildren(
...t.ticks.map(({step:p,kind:d,size:h,text:g})=>{let f=l(p,{class:d,title:`Step ${p}: ${g}`});return f.style.height=`${100*h}%`,f}))},m=()=>{e.replaceChildren(ls(
t.playing?"pause":"play")),e.ariaLabel=t.playing?"Pause":"Play",e.title=`${e.ariaLabel} (Space)`,r.max=String(t.length),r.value=String(t.step),r.ariaValueText=`\
step ${t.step} of ${t.length}`,a.textContent=`${t.step} / ${t.length}`,a.style.minWidth=`${2*String(t.length).length+3}ch`,s.value=String(t.speed)};return t.addEventListener(
"step",m),t.addEventListener("state",m),t.addEventListener("state",c),i.addEventListener("keydown",p=>{!(p.target instanceof HTMLSelectElement||p.key===" "&&p.target!==
r)&&ze(t,p)&&p.preventDefault()}),m(),i}var ji=40,Yt=class{element;#e;#r=u("div",{class:"episodes",role:"group","aria-label":"Episodes of this cell"});#t=u("p",{class:"check small numbers","aria-live":"\
polite"});constructor(e){this.#e=e,this.element=u("div",{class:"strip-of-episodes"},this.#r,this.#t)}show(e,r){let{pursuer:n,evader:o,episode:s,seed:a}=this.#e.
selected,i=Me(e,n,o);this.#r.replaceChildren(...(i?.rates??[]).slice(0,ji).map((d,h)=>this.#n(d,h)));let l=a===null?i?.rates[s]:void 0,c=r.statistics.capture_rate,
m=l!==void 0&&Math.abs(c-l)<1e-6&&r.length===i?.lengths[s],p=i?"Not an episode of the evaluation":"The evaluation played no episodes of this pair.";this.#t.dataset.
equal=String(m),this.#t.textContent=m?"As in the evaluation":l===void 0?p:`Episode ${s+1} differs from the evaluation.`,this.#t.title=`Played here: capture rate\
 ${N(c,3)} in ${r.length} steps.${i?` The cell says ${N(i.rate,3)}.`:""}`}#n(e,r){let{selected:n}=this.#e,o=u("span",{class:"bar"});return o.style.height=`${Math.
round(100*e)}%`,u("button",{type:"button",class:"episode",title:`Episode ${r+1}: capture rate ${N(e)}`,"aria-label":`Episode ${r+1}, capture rate ${N(e)}`,"aria\
-pressed":String(r===n.episode&&n.seed===null),onclick:()=>this.#e.select({episode:r,seed:null})},o,u("span",{class:"count"},r+1))}};var ne=["stay","north","east","south","west","northeast","southeast","southwest","northwest"];var cs=0,us=1,Vi=2,Ki=176;function ps(t,e,r,n){let o=devicePixelRatio||1,s=Vt(t);t.width=t.height=Ki*o;let a=t.getContext("2d");if(!a)return;let{fov:i}=e,l=t.width/
i;a.fillStyle=s.paper,a.fillRect(0,0,t.width,t.height);for(let m=0;r&&m<i*i;m++){let[p,d]=[(m%i+.5)*l,(Math.floor(m/i)+.5)*l],h=f=>!!r[f*i*i+m];h(Vi)&&(a.fillStyle=
s.obstacle,a.fillRect(p-l/2,d-l/2,l,l));let g=h(cs)&&h(us)?l*.18:0;h(cs)&&ms(a,ke,p+g,d+g,l*.74,s.evader),h(us)&&ms(a,Gt,p-g,d-g,l*.86,s.pursuer)}a.strokeStyle=
n<e.n_pursuers?s.pursuer:s.evader,a.lineWidth=2*o;let c=Math.floor(i/2)*l;a.strokeRect(c,c,l,l)}function ms(t,e,r,n,o,s){e(t,r,n,o),t.fillStyle=s,t.fill()}var Yi=["stay","↑","→","↓","←","↗","↘","↙","↖"];function ds(t,{inputs:e,ratings:r,refused:n},o,s){let a=t.kind==="rating"&&!t.hidden.length?t.genome:
null,i=g=>a?.[g]??1,l=g=>t.kind==="rating"?i(g)!==0:new RegExp(`\\b${t.inputs[g]}\\b`).test(s),c=[...t.inputs.keys()].filter(l).sort((g,f)=>Math.abs(i(f))-Math.
abs(i(g))),m=g=>`${g===o?"taken":""} ${n[g]?"refused":""}`,p=(g,f)=>u("tr",{class:f.every(y=>y===f[0])?"same":""},g,...Array.from(f,(y,w)=>u("td",{class:m(w)},ct(
y)))),d=g=>{let f=t.inputs[g];return u("th",{scope:"row",title:`${a?`weight ${ct(i(g))} x `:""}${Le[f]}`},f.replaceAll("_"," "))},h=u("table",{class:"why number\
s"},u("thead",{},u("tr",{},u("th",{},a?"term":"input"),...Array.from(r,(g,f)=>u("th",{scope:"col",class:m(f),title:ne[f],"aria-label":ne[f]},Yi[f]))),p(u("th",{
scope:"row"},a?"sum":"rating"),r)),u("tbody",{},...c.map(g=>p(d(g),e[g].map(f=>i(g)*f)))));return[...s?[u("p",{class:"expression"},u("code",{},s))]:[],u("div",{
class:"wide-table",tabindex:0,role:"group","aria-label":"How the moves are rated"},h)]}var hs="What it remembers: a number for each unit, from -1 to 1",qt=class{element;#e;#r=u("canvas",{class:"seen",role:"img"});#t=u("h3");#n=u("p",{class:"small \
muted"});#a=u("div",{class:"answers"});#s=u("div",{title:hs});#u=null;#f=null;#h=null;#m=null;#p=null;#l=null;#i=0;constructor(e){this.#e=e,this.element=u("div",
{class:"inspector","data-open":"false"},u("p",{class:"hint small muted"},"Click an agent, or press A: what it sees, and why it takes its move."),u("div",{class:"\
inspected"},this.#r,u("div",{class:"answer"},this.#t,this.#n,this.#s),this.#a))}get agent(){return this.#l}show(e,r,n,o){this.#u?.free(),this.#u=e.world(n.config),
this.#h!==r&&(this.#f=null,this.#l!==null&&this.choose(null)),[this.#h,this.#m,this.#p]=[r,n,o]}set solution(e){this.#f=e,this.at(this.#i)}choose(e){this.#l=e,this.
element.dataset.open=String(e!==null),this.#e(e),this.at(this.#i)}next(e){let r=this.#m;if(!r)return;let n=this.#l??(e>0?-1:0);for(let o=0;o<r.n_agents;o++)if(n=
(n+e+r.n_agents)%r.n_agents,r.alive[this.#i*r.n_agents+n])return this.choose(n)}at(e){this.#i=e;let[r,n,o,s,a]=[this.#m,this.#u,this.#h,this.#p,this.#l];if(!r||
!n||!o||!s||a===null)return;let i=a<r.config.n_pursuers?"pursuer":"evader";this.#s.replaceChildren(),this.#t.replaceChildren(u("span",{class:i},Y(a,r.config.n_pursuers)));
let l={pursuers:Z(o,"pursuer",s.pursuer),evaders:Z(o,"evader",s.evader)};r.seek(n,e,l);let c=r.actions.subarray(e*r.n_agents,(e+1)*r.n_agents);for(;c.length&&!n.
over&&(a<n.actors[0]||a>=n.actors[1]);)n.playTurn(c);let m=!!(r.alive[e*r.n_agents+a]&&n.read("alive")[a]);ps(this.#r,r.config,m?n.view(a):null,a),this.#r.ariaLabel=
`Field of view of ${Y(a,r.config.n_pursuers)}: evaders, pursuers and obstacles around it`;let p=c[a]??null;if(!m)return this.#c([],"It is gone.");let d=l[`${i}s`],
h=typeof d!="string"&&d.kind==="cells"?n.answer(d,a):null,g=h?.probabilities??null;h?.memory.length&&this.#s.replaceChildren(u("p",{class:"small muted"},"It rem\
embers:"),Ji(h.memory));let f=typeof d!="string"&&d.kind!=="cells"?ds(d,n.rate(d,a),p,Pt(o,i,s[i])):[],y=this.#f?.game(n)??null,w=typeof d=="string"?`The script\
 "${d}" plays for it${p===null?"":`; it goes ${ne[p]}`}.`:d.kind!=="cells"?"It takes the best move that its mask allows; of equal ones any.":d.sampled?"Its acti\
on is drawn from these probabilities.":"It takes the most probable action.",b=[["network",g],["perfect",y?.marginal(a)??null]],v=S=>u("p",{class:"small muted"},
S);this.#c([...y?[v(`Value ${y.value.toFixed(2)} under perfect play.`)]:[],...qi(b,p),...f],p===null?"The episode is over.":w)}#c(e,r){this.#a.replaceChildren(...e),
this.#n.textContent=r}};function qi(t,e){let r=t.filter(([,s])=>s);if(!r.length)return[];let n=u("div",{class:"action muted"},u("span"),...r.map(([s])=>u("span",
{class:"head"},s))),o=Array.from(r[0][1],(s,a)=>u("div",{class:a===e?"action taken":"action"},u("span",{},ne[a]),...r.flatMap(([,i])=>Zi(i[a]))));return r.length>
1||r[0][0]!==t[0][0]?[n,...o]:o}function Zi(t){let e=u("span",{class:"filled"});return e.style.width=`${100*t}%`,[u("span",{class:"track"},e),u("span",{class:"n\
umbers"},t.toFixed(2))]}function Ji(t){let e=Array.from(t,r=>{let n=u("span",{title:r.toFixed(2)});return n.style.transform=`scaleY(${r})`,n});return u("div",{class:"\
units",role:"img","aria-label":hs},...e)}function fs(t){let e=JSON.stringify(t,(r,n)=>r==="genome"?Array.from(n):n);return u("script",{type:"application/json",id:"champions"},e.replaceAll("<","\\u003c")).
outerHTML}var gs="champion",ys=0,Vr=64,Kr=100;var Xi=(t,e)=>Object.keys(t).every(r=>t[r]===e[r]);function vs(t,e){return Object.keys(e).find(r=>Xi(e[r],t))??null}var yt="_",Qi="n",vm=2n**64n-1n;var Yr={fov:11,maxSteps:500,rewards:"paper"},el=["rules","others","rewards","size","diagonal","fov","limit","seed","ended","walls","pursuers","evaders","played",
"next"];function xs(t,e){let r=i=>i.map(l=>rl(l,e)).join(""),n=i=>`${Math.floor(i/t.cols)}.${i%t.cols}`,o=tl(t.rewards,e),s=[t.seed,t.episode,t.steps].join("."),a={rules:ws(
t.rules,e),others:t.others?ws(t.others,e):"",rewards:o===Yr.rewards?"":o,size:`${t.rows}x${t.cols}`,diagonal:t.diagonal?"1":"",fov:t.fov===Yr.fov?"":String(t.fov),
limit:t.maxSteps===Yr.maxSteps?"":String(t.maxSteps),seed:s==="0.0.0"?"":s,ended:t.ended?"1":"",walls:t.walls.map(n).join(yt),pursuers:t.pursuers.map(bs).join(yt),
evaders:t.evaders.map(bs).join(yt),played:t.played.map(r).join(yt),next:t.next.every(i=>i===ys)?"":r(t.next)};return el.filter(i=>a[i]).map(i=>`${i}=${a[i]}`).join(
"&")}function bs({cell:t,gone:e,captured:r,everCaptured:n}){let o=r?"c":n?"e":"";return`${t[0]}.${t[1]}${o}${e?"x":""}`}function ws(t,e){let r=e.fields.map(({name:n})=>String(
t[n]).toLowerCase());return vs(t,e.variants)??r.join(".")}function tl(t,e){let r=JSON.stringify(t);return Object.keys(e.rewards).find(o=>JSON.stringify(e.rewards[o])===
r)??Object.values(t).map(o=>String(o)).join(yt)}function rl(t,e){if(typeof t=="number")return String(t);if(t===gs)return Qi;let r=e.scripts.findIndex(({name:n})=>n===
t);return String.fromCharCode(97+r)}var nl="/* the engine */";function Ss(t,e){return u("button",{type:"button",class:"to-playground",title:"Open this step in the playground (G): the same agents a\
nd actions under any rules",onclick:()=>qr(t(),e)},"What if?")}function qr(t,e){let r=t!==null&&t.match.n_agents<=Kr&&Math.max(t.match.config.rows,t.match.config.
cols)<=Vr,n=r?xs(ol(t.match,t.step),e):"",o=new TextDecoder().decode(Ir("playground")).replace(nl,()=>Lt("script-engine")).replace("</noscript>",s=>r?s+fs(t.champions):
s);window.open(`${URL.createObjectURL(new Blob([o],{type:"text/html"}))}#${n}`)}function ol(t,e){let{config:r,n_agents:n}=t,o=Math.max(0,e-1),s=i=>{let l=o*n+i,
c=o*r.n_evaders+i-r.n_pursuers,m=p=>i>=r.n_pursuers&&!!p[c];return{cell:[t.last_positions[2*l],t.last_positions[2*l+1]],gone:!t.alive[l],captured:m(t.captured),
everCaptured:m(t.ever_captured)}},a=Array.from({length:n},(i,l)=>s(l));return{rules:r.rules,others:null,rewards:r.rewards,rows:r.rows,cols:r.cols,diagonal:r.diagonal,
fov:r.fov,maxSteps:r.max_steps,seed:t.seed,episode:BigInt(t.episode),steps:o,ended:o===t.length,walls:Array.from(t.map.keys()).filter(i=>t.map[i]),pursuers:a.slice(
0,r.n_pursuers),evaders:a.slice(r.n_pursuers),played:[],next:Array.from(t.actions.subarray(o*n,(o+1)*n))}}var Zr=.005,As=.05,sl=["pursuer","evader"],al=4,Ke=new Map;function Zt(t,e,r="capture-rate"){let n=JSON.stringify([{...e,rewards:null},r]),o=Ke.get(n)??(Ct(e)?Promise.
resolve(null):il(t,e,r));return Ke.delete(n),Ke.set(n,o),Ke.size>al&&Ke.delete([...Ke.keys()][0]),o}var Ts=({n_evaders:t})=>t===1?"capture-time":"capture-rate",
Ms=()=>new Promise(t=>setTimeout(t));async function il(t,e,r){await Ms();let n=t.solution(e,r);for(;n.goBack();)await Ms();return n}function Jt(t,e,r){let{payoff:n}=t;
return r.flatMap((o,s)=>{let a=[0,0];for(let l=e.n_turns;l>0&&!e.over;l--)t.game(e)?.lost(o).forEach((c,m)=>a[m]+=c),e.playTurn(o);let i=n==="capture-rate"?Zr:As;
return sl.map((l,c)=>({step:s+1,team:l,lost:a[c],payoff:n})).filter(l=>l.lost>=i)})}var Xt=t=>t.map(e=>({step:e.step,kind:e.team,size:e.lost/Math.max(1,...t.map(
({lost:r})=>r)),text:vt(e)})),Es=({lost:t,payoff:e})=>e==="capture-rate"?`${t.toFixed(2)} of the capture rate`:`${t.toFixed(1)} steps`,vt=t=>`The ${t.team}s los\
e ${Es(t)} against a perfect opponent`;function Cs(t){let e=t.reduce((r,n)=>n.lost>r.lost?n:r);return`Your team's worst moves, in step ${e.step}, lost ${Es(e)} \
against a perfect opponent.`}function ks({config:t,payoff:e},{value:r},n){if(e==="capture-rate")return`value ${r.toFixed(2)}`;let[o,s]=[1-r,Math.min(t.max_steps-
n,xr)];return o>s-As?`free for ${s} steps`:`captured after ${o.toFixed(1)} steps`}function Rs(t,e){return(t.marginal(e)??[]).map((n,o)=>({share:n,action:o})).filter(
({share:n})=>n>=Zr).sort((n,o)=>o.share-n.share).map(({share:n,action:o})=>n>1-Zr?ne[o]:`${ne[o]} ${n.toFixed(2)}`).join(", ")}function Qt(t,e,r){if(r===0)return[{kind:"start",text:ll(t),agents:[]}];let[n,o]=[e.moments[r-1],e.moments[r]],s=m=>Y(m,t.config.n_pursuers),a=ht(e,n,o),i=t.conflicts(
r),l=new Set(i.flatMap(m=>m.doomed)),c=a.map(m=>({kind:"capture",text:`${s(m)} is captured`,agents:[m]}));for(let m of Bt(n,o))!a.includes(m)&&!l.has(m)&&c.push(
{kind:"end",text:`${s(m)} disappears`,agents:[m]});return c.push(...i.map(({kind:m,text:p,agents:d})=>({kind:m,text:p,agents:d}))),r===t.length&&c.unshift({kind:"\
end",text:cl(t),agents:[]}),c}function ll({config:t}){return`${t.n_pursuers} pursuers and ${t.n_evaders} evaders on ${t.rows} x ${t.cols} cells, at most ${t.max_steps}\
 steps`}function cl(t){let e=Math.round(t.statistics.capture_rate*t.config.n_evaders);return`The episode ends after ${t.length} steps with ${e} of ${t.config.n_evaders}\
 evaders captured`}var ul=60,er=class{element;player=new De(0,{speed:Nt,still:Ve()});inspector;match=null;recording=null;actions;#e;#r;#t;#n;#a=u("h2",{class:"match-title"});#s=u(
"p",{class:"tally numbers"});#u=u("ol",{class:"words",tabindex:0,"aria-live":"off","aria-label":"What happened in this step"});#f=u("p",{class:"problem",role:"a\
lert"});#h=u("div",{class:"shown","aria-live":"polite"});#m=null;#p=null;#l=0;#i=!1;#c=0;#o=[];constructor(e,r,n){[this.#r,this.#t]=[e,r];let o=u("canvas",{"ari\
a-label":"The match",onclick:({clientX:s,clientY:a})=>this.inspector.choose(this.#e.agentAt(s,a))});this.#e=new je(o,{numbers:!1}),this.#n=new Yt(r),this.inspector=
new qt(s=>this.#T(s)),this.actions=u("div",{class:"beside"},u("button",{type:"button",class:"to-play",title:"Move the chosen agent, or an evader, yourself from \
this step on (T)",onclick:()=>this.element.dispatchEvent(new Event("takeover"))},"Take over"),n&&Ss(()=>this.shown,n)),this.element=u("section",{class:"card mat\
ch-card","aria-label":"Match",id:"match"},u("div",{class:"match"},u("header",{class:"match-head"},this.#a,this.#s),this.#f,this.#h,u("div",{class:"stage"},o),u(
"div",{class:"aside"},this.#u,is(),this.actions,this.inspector.element),Kt(this.player),this.#n.element)),this.player.addEventListener("frame",()=>this.recording&&
this.#e.show(this.recording,this.player.time)),this.player.addEventListener("step",()=>this.#S()),r.on("match",()=>this.#y()),this.#x(),this.#M(0,0)}get#d(){return this.#r[this.#t.
selected.run]}reveal(){(this.#d.game?this.#h:this.#e.canvas).scrollIntoView({block:"nearest"})}get shown(){return this.match&&this.#p&&{match:this.match,step:this.
player.step,champions:this.#p}}start(e){this.#m=e,this.#v()}playSoon(){this.#i=!0,this.#l||this.#g()}goTo(e){this.#c=e,!this.#l&&this.match&&this.#v()}#g(){!this.#i||
!this.match||(this.#i=!1,this.player.jump(0),Ve()||this.player.play())}#y(){this.#x(),clearTimeout(this.#l),this.#l=setTimeout(()=>this.#v(),ul)}#v(){clearTimeout(
this.#l),this.#l=0,this.player.pause(),this.#x();let{selected:e}=this.#t,{game:r}=this.#d;if(this.#h.replaceChildren(...r?lo(this.#d,r,e,this.#t):[]),r){this.match=
this.recording=null,this.#i=!1,this.#b(e);return}let n=H.map(a=>Fe(this.#d,a,e[a])).find(Boolean)??"";if(this.#f.textContent=n,n||!this.#m)return;this.match=_t(
this.#m,this.#d,e);let[o,s]=this.names(e);this.#p={pursuer:{name:o,policy:Z(this.#d,"pursuer",e.pursuer)},evader:{name:s,policy:Z(this.#d,"evader",e.evader)}},this.
recording=as(this.match),this.#n.show(this.#d,this.match),this.inspector.show(this.#m,this.#d,this.match,e),this.player.length=this.match.length,this.player.marks=
To(this.recording),this.#o=this.player.ticks=[],this.player.jump(this.#c),this.#c=0,this.#S(),this.#w(this.#m,this.match),this.#b(e),this.#g()}#b({run:e,pursuer:r,
evader:n,episode:o,seed:s}){this.element.dataset.played=`${e} ${r} ${n} ${o} ${s??""}`}async#w(e,r){let n=await Zt(e,r.config);if(this.match!==r||!n)return;let o=e.
world(r.config);r.seek(o,0),this.#o=Jt(n,o,ml(r)),o.free(),this.player.ticks=Xt(this.#o),this.inspector.solution=n,this.#S()}names({run:e,pursuer:r,evader:n}){let o=this.#r[e],
{teams:s}=o;return[s.pursuer.script??U(o,"pursuer",r),s.evader.script??U(o,"evader",n)]}#x(){let{episode:e,seed:r}=this.#t.selected,{game:n,payoff:o}=this.#d;this.
element.classList.toggle("of-own-game",!!n),this.element.classList.toggle("of-ratings",H.some(l=>Ot(this.#d,l)));let[s,a]=this.names(this.#t.selected),i=r===null?
e<o.episodes?`episode ${e+1} of ${o.episodes}`:`episode ${e+1}, not part of the cell`:`seed ${r}`;this.#a.replaceChildren(u("span",{class:"pursuer"},ce(s))," ag\
ainst ",u("span",{class:"evader"},a),n?"":u("span",{class:"muted small"},i))}#S(){let e=this.match;if(!e||!this.recording)return;let r=this.player.step,n=this.recording.
moments[r];this.#M(Array.from(n.everCaptured).filter(Boolean).length,r),this.#u.replaceChildren(...this.#o.filter(o=>o.step===r).map(o=>u("li",{class:`loss-${o.
team}`},vt(o))),...Qt(e,this.recording,r).map(o=>u("li",{class:o.kind,"data-agents":o.agents.join(" ")},o.text))),this.inspector.at(r),this.#A()}#M(e,r){let{world:n}=this.#d;
n&&this.#s.replaceChildren(u("strong",{},e),` of ${n.n_evaders} captured`,u("span",{class:"muted"},` · step ${r}`))}#T(e){this.#e.look={selected:e,viewers:e===
null?[]:[e]},this.#A()}#A(){let e=this.inspector.agent;for(let r of this.#u.children){let n=r.dataset.agents?.split(" ")??[];r.classList.toggle("about",e!==null&&
n.includes(String(e)))}}},ml=({actions:t,length:e,n_agents:r})=>Array.from({length:e},(n,o)=>t.subarray(o*r,(o+1)*r));var pl={ArrowUp:[1,0],ArrowDown:[-1,0],ArrowRight:[0,1],ArrowLeft:[0,-1]},dl=5;function Re(t,e,r,n="pursuer"){t.tabIndex=0,t.setAttribute("role","application"),
t.addEventListener("keydown",o=>{let s=pl[o.key];if(!s)return;let[a,i]=n==="pursuer"?s:[s[1],s[0]],[l,c]=r(),m=o.shiftKey?dl:1,{pursuer:p,evader:d}=e.selected;e.
select({pursuer:$s(p+m*a,l),evader:$s(d+m*i,c)}),o.preventDefault(),o.stopPropagation()})}var $s=(t,e)=>Math.min(e-1,Math.max(0,t));var hl=24,tr=7,Ps=t=>t<hl&&matchMedia("(pointer: coarse)").matches;function _s(t,e,r,n){let[o,s]=t.payoff.shape,[a,i]=[Os(e,o),Os(r,s)],[l,c]=[Math.min(tr,o),Math.
min(tr,s)],m=[];for(let f=a+l-1;f>=a;f--){m.push(u("span",{class:"pursuer"},f));for(let y=i;y<i+c;y++)m.push(fl(t,f,y,n))}let p=Array.from({length:c},(f,y)=>u("\
span",{class:"evader"},i+y)),d=u("button",{type:"button","aria-label":"Close: all cells",onclick:()=>n(null)},"✕"),g=u("div",{class:"loupe numbers",role:"grou\
p","aria-label":"Cells around the tap",onclick:f=>f.stopPropagation()},...m,d,...p);return g.style.gridTemplateColumns=`2.4rem repeat(${c}, minmax(0, 1fr))`,g}function fl(t,e,r,n){
let o=u("button",{type:"button",onclick:()=>n({pursuer:e,evader:r})});return Ft(o,Me(t,e,r)?.rate,`${U(t,"pursuer",e)} against ${U(t,"evader",r)}`),o}var Os=(t,e)=>Math.
max(0,Math.min(e-tr,t-Math.floor(tr/2)));var ae={left:52,bottom:46,top:76,right:84},he=10,gl=160,bt=ae.right-he-14,$e=ae.top-he-14,rr=class{element;#e;#r;#t=u("canvas",{"aria-hidden":"true"});#n=x("svg",
{"aria-hidden":"true"});#a=x("g");#s;#u=u("h2");#f=u("strong",{class:"rate numbers"});#h=u("span",{class:"small muted"});#m=u("p",{class:"of-both-teams small mu\
ted numbers"});#p;#l=null;constructor(e,r){[this.#r,this.#e]=[e,r],this.#s=u("div",{class:"matrix",id:"matrix","aria-label":"Payoff matrix. Arrow keys choose a \
match, Enter plays it.",onpointermove:o=>this.#w(o),onpointerleave:()=>r.point({}),onclick:o=>this.#x(o),onkeydown:({key:o})=>o==="Enter"&&this.#M()},this.#t,this.#n);
let n=u("header",{class:"readout","aria-live":"polite"},u("div",{},this.#u,this.#m),u("div",{class:"of-cell"},this.#f,this.#h));this.#p=dt(...k(this.#i).ends),this.
element=u("section",{class:"card matrix-card","aria-label":"Payoff matrix"},n,this.#s,this.#p),this.#y(),new ResizeObserver(()=>this.#c()).observe(this.#s),this.#s.
addEventListener("mousedown",o=>{o.preventDefault(),document.activeElement instanceof HTMLElement&&document.activeElement.blur()}),Re(this.#s,r,()=>this.#i.payoff.
shape),r.on("run",()=>{let o=dt(...k(this.#i).ends);this.#p.replaceWith(o),this.#p=o,this.#c()}),r.on("match hover",()=>this.#g())}get#i(){return this.#r[this.#e.
selected.run]}#c(){let[e,r]=this.#i.payoff.shape,{clientWidth:n,clientHeight:o}=this.#s;if(n<50)return;let a=Math.max(gl,Math.min(n-ae.left-ae.right,o-ae.top-ae.
bottom))/Math.max(e,r),i=Math.max(ae.left,(n-r*a-ae.right+ae.left)/2),l=ae.top+Math.max(0,(o-ae.top-ae.bottom-e*a)/2),c={width:n,height:o,left:i,top:l,cell:a,rows:e,
columns:r};this.#l=c,Wt(this.#t,this.#i.payoff,{left:i,top:l,width:r*a,height:e*a});for(let[m,p,d]of[["left",i,n],["top",l,o],["width",r*a,n],["height",e*a,o]])
this.#t.style.setProperty(m,`${100*p/d}%`);this.#s.style.setProperty("--shape",`${n} / ${o}`),this.#n.setAttribute("viewBox",`0 0 ${n} ${o}`),this.#n.replaceChildren(
yl(c,k(this.#i).generation),...vl(c),...this.#d(c),this.#a),this.#g()}#o(e){let r=this.#i.findings?.generalization;if(!r)return[];let{selected:n,hover:o}=this.#e,
[s,a]=[o.pursuer??n.pursuer,o.evader??n.evader],[i,l]=Ls(e,r.pursuers.mean[s]??0,s),[c,m]=Ns(e,r.evaders.mean[a]??0,a);return[x("circle",{class:"dot of-pursuers",
cx:i,cy:l,r:5}),x("circle",{class:"dot of-evaders",cx:c,cy:m,r:5})]}#d(e){let r=this.#i.findings?.generalization;if(!r)return[];let{left:n,top:o,cell:s,rows:a,columns:i}=e,
{curves:l}=k(this.#i),[c,m]=[n+i*s+he,o-he],p={class:"side"};return[x("rect",{...p,x:c,y:o,width:bt,height:a*s}),x("rect",{...p,x:n,y:m-$e,width:i*s,height:$e}),
...Is(r.pursuers,(d,h)=>Ls(e,d,h),"of-pursuers"),...Is(r.evaders,(d,h)=>Ns(e,d,h),"of-evaders"),x("text",{class:"tick",x:c,y:o+a*s+16,"text-anchor":"start"},"0"),
x("text",{class:"tick",x:c+bt,y:o+a*s+16,"text-anchor":"end"},"1"),x("text",{class:"tick",x:n-6,y:m-4,"text-anchor":"end"},"0"),x("text",{class:"tick",x:n-6,y:m-
$e+8,"text-anchor":"end"},"1"),x("text",{class:"label of-pursuers",x:c+bt,y:o+a*s+34,"text-anchor":"end"},l.pursuer),x("text",{class:"label of-evaders",x:n+i*s+
he,y:m-$e+10,"text-anchor":"start"},l.evader)]}#g(){let e=this.#l;if(!e)return;let{selected:r,hover:n}=this.#e,{left:o,top:s,cell:a,rows:i,columns:l}=e,c=g=>s+(i-
1-g)*a,m=[],p=(g,f)=>x("rect",{class:f,x:o,y:c(g),width:l*a+he+bt,height:a}),d=(g,f)=>x("rect",{class:f,x:o+g*a,y:s-he-$e,width:a,height:he+$e+i*a});m.push(p(r.
pursuer,"strip pursuer"),d(r.evader,"strip evader")),n.pursuer!==null&&n.pursuer<i&&m.push(p(n.pursuer,"strip hover")),n.evader!==null&&n.evader<l&&m.push(d(n.evader,
"strip hover")),m.push(...this.#o(e));let h={x:o+r.evader*a,y:c(r.pursuer),width:a,height:a};m.push(x("rect",{class:"chosen under",...h}),x("rect",{class:"chose\
n",...h})),this.#a.replaceChildren(...m),this.#y()}#y(){let{selected:e,hover:r}=this.#e,n=r.pursuer??e.pursuer,o=r.evader??e.evader,s=Me(this.#i,n,o);this.#u.replaceChildren(
u("span",{class:"pursuer"},ce(U(this.#i,"pursuer",n)))," against ",u("span",{class:"evader"},U(this.#i,"evader",o))),this.#f.textContent=s?N(s.rate,3):"-";let a=s&&
s.rates.length>1?`, mean of ${s.rates.length} episodes`:"";this.#h.textContent=s?k(this.#i).score+a:"no episodes were played",this.#m.textContent=this.#v(n,o)}#v(e,r){
let n=this.#i.findings?.generalization;if(!n)return"";let o=(a,i)=>ao(a.mean[i]??null,a.low?.[i]??null,a.high?.[i]??null),{means:s}=k(this.#i);return`Against al\
l: ${s.pursuer} ${o(n.pursuers,e)}, ${s.evader} ${o(n.evaders,r)}`}#b(e){let r=this.#l;if(!r)return null;let n=this.#s.getBoundingClientRect(),o=Math.floor((e.clientX-
n.left-r.left)/r.cell),s=r.rows-1-Math.floor((e.clientY-n.top-r.top)/r.cell),[a,i]=[s>=0&&s<r.rows,o>=0&&o<r.columns];return a||i?{g:a?s:-1,h:i?o:-1,inside:a&&i}:
null}#w(e){let r=this.#b(e);this.#e.point(r?{pursuer:r.g<0?null:r.g,evader:r.h<0?null:r.h}:{})}#x(e){let r=this.#b(e);if(r){if(r.inside&&Ps(this.#l.cell))return this.#S(
r.g,r.h);this.#e.select({...r.g<0?{}:{pursuer:r.g},...r.h<0?{}:{evader:r.h}}),r.inside&&this.#M()}}#S(e,r){let n=_s(this.#i,e,r,o=>{n.remove(),o&&(this.#e.select(
o),this.#M())});this.#s.append(n)}#M(){this.#s.dispatchEvent(new CustomEvent("play",{bubbles:!0}))}};function yl({left:t,top:e,cell:r,rows:n,columns:o},s){let a=x(
"g",{class:"axes"}),i=e+n*r,l=c=>ut(0,c-1,Math.min(c,c*r/44),!0);for(let c of l(o))a.append(x("text",{class:"tick",x:t+(c+.5)*r,y:i+16,"text-anchor":"middle"},c));
for(let c of l(n))a.append(x("text",{class:"tick",x:t-7,y:i-(c+.5)*r,"text-anchor":"end","dominant-baseline":"middle"},c));return a.append(x("text",{class:"labe\
l of-evaders",x:t+o*r/2,y:i+36,"text-anchor":"middle"},s.evader),x("text",{class:"label of-pursuers",transform:`translate(${t-36} ${e+n*r/2}) rotate(-90)`,"text\
-anchor":"middle"},s.pursuer)),a}function vl({left:t,top:e,cell:r,rows:n,columns:o}){let s=x("g",{class:"diagonal"}),a=Math.min(n,o);if(a<3)return[];let i=e+n*r;
for(let m of["H","V"]){let p=`M${t} ${i}`;for(let d=1;d<=a;d++){let[h,g]=[`H${t+d*r}`,`V${i-d*r}`];p+=m==="H"?h+g:g+h}s.append(x("path",{d:p,class:"under"}),x("\
path",{d:p}))}let[l,c]=[t+a/2*r-.7*r-4,i-a/2*r-.7*r-4];return[s,x("text",{class:"on-cells",transform:`translate(${l} ${c}) rotate(-45)`,"text-anchor":"middle"},
"same generation")]}var Ls=({left:t,top:e,cell:r,rows:n,columns:o},s,a)=>[t+o*r+he+s*bt,e+(n-a-.5)*r],Ns=({left:t,top:e,cell:r},n,o)=>[t+(o+.5)*r,e-he-n*$e];function Is(t,e,r){
let n=s=>s.map((a,i)=>e(a??0,i).map(l=>l.toFixed(1)).join(" ")),o=[];return t.low&&t.high&&o.push(x("path",{class:`band ${r}`,d:`M${[...n(t.high),...n(t.low).reverse()].
join("L")}Z`})),o.push(x("path",{class:`line ${r}`,d:`M${n(t.mean).join("L")}`})),o}function ue(t,e,...r){return u("section",{class:"card panel","aria-label":t},u("header",{},u("h2",{},t),u("p",{class:"small muted"},e)),...r)}var bl={present:"●",
absent:"○","cannot tell":"?"};function Us(t){let{findings:e}=t;if(!e?.table.length)return null;let[,...r]=e.table,n=r.map(([s,a,i,l],c)=>{let m=wl(e.reasons[c]??
"");return u("li",{class:`finding ${a.replace(" ","-")}`},u("span",{class:"sign","aria-hidden":"true"},bl[a]??""),u("div",{},u("p",{},u("strong",{},s),` ${a}`,u(
"span",{class:"muted"},` · ${l}`)),m?u("p",{class:"small"},`${m}.`):null,u("p",{class:"small muted numbers"},i)))}),o=ue("What happened","Each condition is pre\
sent, absent, or its 95 % interval cannot tell. The intervals are about this run.",u("p",{class:"headline"},e.sentence),u("p",{},e.headline),...e.numbers.map(s=>u(
"p",{class:"numbers"},`${ce(s)}.`)),u("ul",{class:"findings"},...n),t.limits?u("p",{class:"small"},t.limits):null);return o.classList.add("diagnosis"),{element:o}}
function wl(t){let[,e=""]=t.split(/, because (.*)/s);return ce(e.replace(/\.$/,""))}function Ws({settings:t,schedule:e,seed:r}){let n=t.map(({name:a,value:i,help:l})=>u(
"tr",{},u("th",{scope:"row"},`--${a.replaceAll("_","-")}`),u("td",{class:"numbers"},i),u("td",{class:"muted"},l))),o=u("table",{class:"small"},u("caption",{class:"\
heard"},"Settings other than the default"),...n),s=ue("Settings",`${e}, seed ${r}; all others are the defaults of matrixworld evolve.`,n.length?u("div",{class:"\
wide-table"},o):null);return s.classList.add("settings"),{element:s}}function Fs(t,e,r){let{findings:n}=t,{teams:o,click:s}=k(t);if(!n?.table.length)return null;let a=n.checkerboards.map(i=>xl(t,i,(l,c)=>{e.select({pursuer:l,evader:c}),
r()}));return{element:ue("Checkerboards",`Two generations of each team: each generation of the ${o.pursuer} is better against another one of the ${o.evader}. Cl\
ick a cell to ${s}.`,a.length?u("div",{class:"boards"},...a):u("p",{},`No four cells differ by more than ${n.margin} in this way.`),a.length&&!t.game?.exact?u("\
p",{class:"small muted"},"The strongest of all pairs, so noise makes them look stronger than they are. The diagnosis says whether there are more than noise make\
s."):null)}}function xl(t,{pursuers:e,evaders:r},n){let o=(s,a)=>{let i=u("button",{type:"button",class:"cell",onclick:()=>n(s,a)});return Ft(i,t.payoff.capture_rate[s][a],
`${U(t,"pursuer",s)} against ${U(t,"evader",a)}`),i};return u("div",{class:"miniature numbers"},u("span"),...r.map(s=>u("span",{class:"evader"},s)),...e.flatMap(
s=>[u("span",{class:"pursuer"},s),...r.map(a=>o(s,a))]))}var nr={pursuer:"evader",evader:"pursuer"};function Ds(t,e){let r=t.findings?.ciao;if(!r)return null;let n=["pursuer","evader"].map(o=>{let{fading:s,stripes:a,period:i}=r[`${o}\
s`],l=`fading ${N(s)}, stripes ${N(a)}${i===null?"":` every ${i} generations`}`;return Sl(t,o,l,e)});return{element:ue("CIAO: current individuals against ancest\
ral opponents","The team's own score. Stripes: intransitive, since wins and losses alternate with the age of the opponent; whether a team returns to earlier str\
ategies is recurrence, under What happened. Darker away from the diagonal: forgetting.",u("div",{class:"triangles"},...n.map(o=>o.element)),dt("0 loses","1 wins")),
update:()=>n.forEach(o=>o.update())}}function Sl(t,e,r,n){let o=e==="pursuer"?0:1,s=k(t),[a,i]=[t.payoff.shape[o],t.payoff.shape[1-o]],l=t.payoff.capture_rate,c=Array.
from({length:a},(b,v)=>Array.from({length:Math.min(v+1,i)},(S,T)=>e==="pursuer"?l[v][T]:1-l[T][v])),m=Ur({shape:[a,i],first:[0,0],capture_rate:c}),p=x("rect",{class:"\
chosen",width:1,height:1}),d=x("rect",{class:"chosen under",width:1,height:1}),h=x("svg",{viewBox:`0 0 ${i} ${a}`,preserveAspectRatio:"none","aria-hidden":"true"},
d,p),g=u("div",{class:"triangle","aria-label":`CIAO of the ${s.teams[e]}: ${r}. Arrow keys choose a match.`,onpointermove:b=>n.point(f(b)??{}),onpointerleave:()=>n.
point({}),onclick:b=>f(b)&&n.select(f(b))},m,h);Re(g,n,()=>t.payoff.shape,e),g.style.aspectRatio=`${i} / ${a}`;let f=b=>{let v=g.getBoundingClientRect(),S=Math.
floor((b.clientX-v.left)/v.width*i),T=a-1-Math.floor((b.clientY-v.top)/v.height*a);return S>=0&&T<a&&S<=T?{[e]:T,[nr[e]]:S}:null},y=()=>{let b=n.hover[e]??n.selected[e],
v=n.hover[nr[e]]??n.selected[nr[e]];for(let S of[p,d])S.setAttribute("x",String(v)),S.setAttribute("y",String(a-1-b)),S.style.display=v<=b?"":"none"};return{element:u(
"figure",{},u("figcaption",{class:"small"},u("span",{class:e},s.teams[e])),g,u("p",{class:"small muted"},`horizontal: ${s.generation[nr[e]]}; vertical: ${s.generation[e]}`),
u("p",{class:"small numbers"},r)),update:y}}var or={left:46,right:12,top:10,bottom:42},zs={x:56,y:34};function Jr(t,e,r,n){let[o,s]=[or.left,or.top],a=Math.max(o+40,t-or.right),i=Math.max(s+40,e-or.bottom),
l=(f,y,w)=>b=>y+(b-f.low)/(f.high-f.low||1)*(w-y),[c,m]=[l(r,o,a),l(n,i,s)],p=x("g"),d=x("svg",{width:t,height:e,viewBox:`0 0 ${t} ${e}`,class:"plot"}),h=x("g",
{class:"axes"});for(let f of ut(n.low,n.high,(i-s)/zs.y,n.whole))h.append(x("line",{x1:o,x2:a,y1:m(f),y2:m(f),class:"grid"}),x("text",{x:o-8,y:m(f),"text-anchor":"\
end","dominant-baseline":"middle"},Bs(f)));for(let f of ut(r.low,r.high,(a-o)/zs.x,r.whole))h.append(x("text",{x:c(f),y:i+16,"text-anchor":"middle"},Bs(f)));return h.
append(x("line",{x1:o,x2:a,y1:i,y2:i,class:"axis"}),x("text",{x:(o+a)/2,y:e-6,"text-anchor":"middle",class:"label"},r.label),x("text",{transform:`translate(12 ${(s+
i)/2}) rotate(-90)`,"text-anchor":"middle",class:"label"},n.label)),d.append(h,p),{root:d,marks:p,left:o,right:a,top:s,bottom:i,x:c,y:m,at:f=>{let y=f-d.getBoundingClientRect().
left;return r.low+(y-o)/(a-o)*(r.high-r.low)}}}var Bs=t=>String(Number(t.toPrecision(6))).replace("-","−");function Xr(t,e,r,n){let o="",s="M";r.forEach((a,i)=>{
a===null?s="M":(o+=`${s}${t.x(e[i]).toFixed(1)} ${t.y(a).toFixed(1)}`,s="L")}),t.root.insertBefore(x("path",{d:o,class:`line ${n}`}),t.marks)}function Hs(t,{low:e,
high:r},n){if(!e||!r)return;let o=s=>s.map((a,i)=>`${t.x(i).toFixed(1)} ${t.y(a??0).toFixed(1)}`);t.root.insertBefore(x("path",{d:`M${[...o(r),...o(e).reverse()].
join("L")}Z`,class:`band ${n}`}),t.marks)}function Qr(t,e,r,n=null){let o=t.x(e);t.marks.append(x("line",{x1:o,x2:o,y1:t.top,y2:t.bottom,class:`mark ${r}`})),n!==
null&&t.marks.append(x("circle",{cx:o,cy:t.y(n),r:5,class:`dot ${r}`}))}function en(...t){return u("p",{class:"legend small"},...t.map(([e,r])=>u("span",{class:`\
key ${r}`},e)))}function tn(t,e,r,n){let o=u("div",{class:"chart chooses",role:"img","aria-label":t}),s=null,a=()=>{s?.marks.replaceChildren(),s&&r(s)};o.addEventListener(
"click",l=>s&&n(s.at(l.clientX),s,l));let i=()=>{let{clientWidth:l,clientHeight:c}=o;l<50||c<50||(s=e(l,c),o.replaceChildren(s.root),a())};return new ResizeObserver(
i).observe(o),{element:o,update:a,redraw:i}}var rn=["of-pursuers","of-evaders","of-both"],Ml=2500,Gs="Arrow keys choose generations.";function js(t,e){let{training:r}=t,{score:n,teams:o}=k(t),{capture_rate:s,
generation:a,learner:i,epochs:l}=r,c=s.map((y,w)=>(w+1)*l),m=Al(s,r.window),p=c.at(-1)??1,d=c.length>Ml?"dense":"",h=(y,w)=>{let b=a.flatMap((v,S)=>v===y&&(i[S]===
w||i[S]===2)?[S]:[]);return b.length?[c[b[0]],c[b.at(-1)]]:null},g=tn(`${ce(n)} in ${p} epochs of training. ${Gs}`,(y,w)=>{let b=Jr(y,w,{low:0,high:p,label:"epo\
ch",whole:!0},{low:0,high:1,label:n});for(let[v,S]of[["raw",s],[d,m]])for(let[T,_]of rn.entries()){let C=S.map((A,M)=>i[M]===T||i[M+1]===T?A:null);C.some(A=>A!==
null)&&Xr(b,c,C,`${_} ${v}`)}return b},y=>H.forEach((w,b)=>{let v=h(e.hover[w]??e.selected[w],b);v&&Qr(y,(v[0]+v[1])/2,rn[b])}),y=>{let w=Math.min(c.length-1,Math.
max(0,Math.round(y/l)-1)),b=a[w];i[w]!==1&&e.select({pursuer:Math.min(b,t.payoff.shape[0]-1)}),i[w]!==0&&e.select({evader:Math.min(b,t.payoff.shape[1]-1)})});Re(
g.element,e,()=>t.payoff.shape);let f=[...new Set(i)].sort().map(y=>[`${[o.pursuer,o.evader,"both teams"][y]} learn`,rn[y]]);return{element:ue("Training",`${io(
r.matches)} training matches. Lines: the generations that are selected.`,en(...f),g.element),update:g.update}}function Vs(t,e){let r=t.findings?.ratings;if(!r)return null;
let n={pursuer:r.pursuers,evader:r.evaders},o={pursuer:n.pursuer.mean,evader:n.evader.mean},s=H.flatMap(d=>[n[d].mean,n[d].low??[],n[d].high??[]]).flat().map(d=>d??
0),[a,i]=[Math.min(...s),Math.max(...s)],l=.06*(i-a||1),c=Math.max(...t.payoff.shape)-1,{teams:m}=k(t),p=tn(`Elo ratings by generation. ${Gs}`,(d,h)=>{let g=Jr(
d,h,{low:0,high:c,label:"generation",whole:!0},{low:a-l,high:i+l,label:"Elo points"});for(let f of H)Hs(g,n[f],`of-${f}s`),Xr(g,o[f].map((y,w)=>w),o[f],`of-${f}\
s`);return g},d=>{for(let h of H){let g=e.hover[h]??e.selected[h];Qr(d,g,`of-${h}s`,o[h][g]??null)}},(d,h,g)=>{let f=Math.round(d),y=g.clientY-h.root.getBoundingClientRect().
top,w=v=>Math.abs(h.y(o[v][f]??1/0)-y),b=w("pursuer")<=w("evader")?"pursuer":"evader";f>=0&&f<o[b].length&&e.select({[b]:f})});return Re(p.element,e,()=>t.payoff.
shape),{element:ue("Ratings",`One number for each generation, which cycles do not fit${n.pursuer.low?", with 95 % intervals over episodes":""}. The game itself:\
 ${N(r.offset,0)} points for the ${m.pursuer}.`,en([m.pursuer,"of-pursuers"],[m.evader,"of-evaders"]),p.element),update:p.update}}function Al(t,e){let r=[0];for(let n of t)
r.push(r.at(-1)+n);return t.map((n,o)=>{let[s,a]=[Math.max(0,o-Math.floor((e-1)/2)),Math.min(t.length,o+Math.floor(e/2)+1)];return(r[a]-r[s])/(a-s)})}function Ks(t,e){if(H.every(n=>!t.teams[n].words&&!Ot(t,n)))return null;let r=u("div",{class:"evolved"});return{element:ue("What evolved","Each move is rated by\
 named inputs of the cell that it leads to, and the best one is taken.",r),update:()=>r.replaceChildren(...H.map(n=>Tl(t,n,e.selected[n])))}}function Tl(t,e,r){
let{words:n,kept:o}=t.teams[e],s=Fe(t,e,r),a=t.teams[e].script??U(t,e,r);return u("section",{"aria-label":k(t).teams[e]},u("h3",{class:e},ce(a)),n&&r===o.at(-1)?
u("p",{},n):null,s?u("p",{class:"small muted"},s):El(e,Z(t,e,r),Pt(t,e,r)))}function El(t,e,r){if(typeof e=="string"||e.kind==="cells")return null;if(e.kind==="\
program")return u("p",{},u("code",{},r));if(e.hidden.length)return u("p",{class:"small muted"},`A network with ${e.hidden.join(" and ")} hidden units rates each\
 move by ${e.inputs.length} inputs.`);let n=Math.max(...e.genome.map(Math.abs))||1;return u("div",{class:"weights"},...e.inputs.flatMap((o,s)=>{let a=e.genome[s],
i=u("span",{class:`bar ${t}${a<0?" below":""}`});return i.style.width=`${50*Math.abs(a)/n}%`,[u("span",{title:Le[o]},o.replaceAll("_"," ")),u("span",{class:"axi\
s"},i),u("span",{class:"numbers"},ct(a))]}))}function Ys(t,e,r){let n=new Map,o=u("div",{class:"panels"}),s=[],a=()=>s.forEach(l=>l.update?.()),i=()=>{let l=t[e.selected.run];s=n.get(l)??Cl(l,e,r),n.set(l,
s),o.replaceChildren(...s.map(c=>c.element)),a()};return e.on("run",i),e.on("match hover",a),i(),o}function Cl(t,e,r){return[Us(t),Ks(t,e),js(t,e),Fs(t,e,r),Vs(
t,e),Ds(t,e),Ws(t)].filter(o=>o!==null)}var qs={pursuer:null,evader:null},sr=class extends EventTarget{#e;#r=qs;constructor(e){super(),this.#e=e}get selected(){return this.#e}get hover(){return this.#r}select(e){
let r=this.#e,n=["run","pursuer","evader"].some(o=>o in e&&e[o]!==r[o]);this.#e={...r,...n?{episode:0,seed:null}:{},...e},this.#e.run!==r.run&&this.dispatchEvent(
new Event("run")),this.dispatchEvent(new Event("match"))}point(e){let r={...qs,...e};r.pursuer===this.#r.pursuer&&r.evader===this.#r.evader||(this.#r=r,this.dispatchEvent(
new Event("hover")))}on(e,r){for(let n of e.split(" "))this.addEventListener(n,r)}};var ar=class{config;start;recording;actions=[];#e;#r;#t=[[]];constructor(e,r,n){[this.config,this.start]=[r,n],this.#e=e.world(r),this.#e.reset(n),this.#r=[jr(this.#e)],
this.recording=Gr(r,this.#e.map(),this.#r)}get length(){return this.actions.length}get over(){return this.#e.over}get statistics(){return{capture_rate:this.#e.read(
"capture_rate")[0]}}conflicts(e){return this.#t[e]}game(e){return e.game(this.#e)}play(e){this.#e.step(e),this.#n(e)}step(e,r,n){let[o,s]=[this.#e,this.config.n_pursuers],
a=new Uint8Array(o.n_agents);for(let i=o.n_turns;i>0&&!o.over;--i){let[l,c]=o.actors;l<s&&(a=o.decide(e.pursuer,[l,Math.min(c,s)],a)),c>s&&(a=o.decide(e.evader,
[Math.max(l,s),c],a)),typeof n=="number"?a[r]=n:l<=r&&r<c&&(a=o.decide(n,[r,r+1],a)),o.playTurn(a)}this.#n(a)}#n(e){this.actions.push(e),this.#r.push(jr(this.#e,
e)),this.#t.push(this.#e.conflicts())}};var fe=(t,e)=>H[+(e>=t.n_pursuers)];function nn(t,e){let r=new ar(t,e.config,{seed:e.seed,episode:e.episode});for(let n of e.moves)r.over||r.step(e.policies,e.seat,
n);return r}function Ye(t,e){let{moments:r,nPursuers:n}=t.recording,o=r.findIndex(({alive:a,captured:i})=>!a[e]||!!i[e-n]),s=o<0?t.length:o;return{lasted:s,out:o>=
0,captured:Array.from(r[s].everCaptured).filter(Boolean).length}}var ir=(t,e)=>t.over||Ye(t,e).out;function Zs(t,e,r){let n=nn(t,{...e,moves:e.moves.slice(0,e.from)});
for(;!ir(n,e.seat);)n.step(e.policies,e.seat,r);return Ye(n,e.seat)}function Js(t){let e=t.length-1;return[...new Set([0,Math.round(e/3),e])].map(r=>t[r])}function Xs(t,{
seat:e,from:r,moves:n}){let o={...t,seat:e,...r?{from:r}:{},moves:n.join("")};return`${location.href.split("#")[0]}#${Object.entries(o).map(([s,a])=>`${s}=${a}`).
join("&")}`}function Qs(t,e){let[r,n,o]=[t.get("seat")??"",t.get("from")??"0",t.get("moves")??""];return/^\d{1,6}$/.test(r)&&Number(r)<e.n_pursuers+e.n_evaders&&
(e.diagonal?/^[0-8]+$/:/^[0-4]+$/).test(o)&&o.length<=e.max_steps&&/^\d{1,6}$/.test(n)&&Number(n)<=o.length?{seat:Number(r),from:Number(n),moves:[...o].map(Number)}:
null}function on(t,e,r,n,o,s){e.play({title:r,played:n,ending:(a,i)=>[kl(t,a,i,Js(o))],again:()=>on(t,e,r,{...n,moves:n.moves.slice(0,n.from)},o,s),link:a=>s&&Xs(s,a)})}
function kl(t,e,r,n){let o=fe(r.config,r.seat)==="evader",s=o?r.config.max_steps:r.config.n_evaders,a=u("table",{class:"numbers"},u("caption",{},o?"Steps in you\
r seat: same start, same others":"Captures of your team: same start, same others")),i=c=>{let[m,p]=[u("span",{class:o?"bar evader":"bar pursuer"}),u("td",{},"…")];
return a.append(u("tr",{},u("th",{scope:"row"},c),u("td",{class:"track","aria-hidden":"true"},m),p)),({lasted:d,captured:h})=>{m.style.width=`${100*(o?d:h)/s}%`,
p.textContent=String(o?d:h)}};i("You")(Ye(e,r.seat));for(let{name:c,policy:m}of n){let p=i(c);setTimeout(()=>p(Zs(t,r,m())))}let l=r.from?`You took over at step\
 ${r.from}. `:"";return u("div",{},a,u("p",{class:"small muted"},`${l}One match: luck has its part in it.`))}var ea=["·","↑","→","↓","←","↗","↘","↙","↖"];var Rl={" ":0,ArrowUp:1,w:1,ArrowRight:2,d:2,ArrowDown:3,s:3,ArrowLeft:4,a:4,e:5,c:6,y:7,z:7,q:8},sn=[8,1,5,4,0,2,7,3,6],$l=[7,8,9,4,5,6,1,2,3],Ol=24,Pl=Math.tan(
Math.PI/8);function ra(t,e){if(t.ctrlKey||t.metaKey||t.altKey)return;let r=$l.findIndex(o=>t.code===`Numpad${o}`),n=sn[r]??Rl[t.key.length===1?t.key.toLowerCase():
t.key];return n!==void 0&&n>4&&!e?void 0:n}function na(t){let e=sn.map(r=>u("button",{type:"button","aria-label":ne[r],onclick:()=>t(r)},ea[r]));return{element:u(
"div",{class:"play-pad",role:"group","aria-label":"Your move"},...e),show:r=>e.forEach((n,o)=>n.classList.toggle("absent",sn[o]>4&&!r))}}function ta(t,e,r){let n=Pl*
Math.max(Math.abs(t),Math.abs(e)),o=s=>Math.abs(s)<n?0:s;return Mo([0,0],r?[o(t),o(e)]:[t,e],r)}function oa(t,e,r){let n=null,{canvas:o}=t;o.addEventListener("p\
ointerdown",({button:s,clientX:a,clientY:i})=>n=s===0?[a,i]:null),o.addEventListener("pointercancel",()=>n=null),o.addEventListener("pointerup",({clientX:s,clientY:a})=>{
let[i,l]=[n,e()];if(n=null,!i||!l)return;let[c,m]=[s-i[0],a-i[1]],p=t.cellAt(s,a);Math.hypot(c,m)>=Ol?r(ta(m,c,l.diagonal)):p&&r(ta(p[0]-l.cell[0],p[1]-l.cell[1],
l.diagonal))})}function sa(t,e){let r=n=>{let o=e[n]-t[n],s=Be.findIndex(a=>a[n]===Math.sign(o)&&a[1-n]===0);return o?`${Math.abs(o)} ${ne[s]}`:""};return[r(0),
r(1)].filter(Boolean).join(", ")||"on your cell"}var la="NUMPY\0",aa=la.length+2,ia=64;function ca(t){return so(Object.fromEntries(Object.entries(t).map(([e,r])=>[`${e}.npy`,_l(r)])))}function _l({dtype:t,shape:e,
data:r}){let n=typeof r=="string"?Array.from(r,m=>m.codePointAt(0)):null,o=e.map(m=>`${m}, `).join(""),s=`{'descr': '${n?`<U${n.length}`:t}', 'fortran_order': F\
alse, 'shape': (${o}), }`,a=Math.ceil((aa+s.length+1)/ia)*ia-aa,i=la+String.fromCharCode(a&255,a>>8)+s.padEnd(a-1)+`
`,l=n?Int32Array.from(n):r,c=new Uint8Array(i.length+l.byteLength);return c.set(kt(i,!0)),c.set(new Uint8Array(l.buffer,l.byteOffset,l.byteLength),i.length),c}var Ll="matrixworld episode 3";function ua(t,e,r){let{config:n,actions:o,length:s,recording:a}=e,[i,l]=[n.n_pursuers+n.n_evaders,n.n_evaders],c={positions:["<i4",
i,2],last_positions:["<i4",i,2],alive:["|b1",i],captured:["|b1",l],ever_captured:["|b1",l]},m={rewards:["<f4",i],involved:["|b1",i,3],fault:["|b1",i,3]},p={},d=v=>{
for(let S of Object.keys(v))(p[S]??=[]).push(Array.from(h.read(S),Number))},h=t.world(n);h.reset(e.start);let g=[];d(c);for(let v of o)h.step(v),d({...c,...m}),
g.push(...h.conflictTable());h.free();let f={"<i4":Int32Array,"<f4":Float32Array,"|b1":Uint8Array},y={};for(let[v,[S,...T]]of Object.entries({...c,...m})){let _=s+
+(v in c);y[v]={dtype:S,shape:[_,...T],data:f[S].from((p[v]??[]).flat())}}let w=v=>({dtype:"<i8",shape:[],data:Int32Array.of(v,0)}),b=v=>({dtype:"<U",shape:[],data:v});
return ca({format:b(Ll),n_pursuers:w(n.n_pursuers),config:b(JSON.stringify(n)),seat:w(r),...y,actions:{dtype:"|i1",shape:[s,i],data:Int8Array.from(o.flatMap(v=>[
...v]))},map:{dtype:"|b1",shape:[n.rows,n.cols],data:Uint8Array.from(a.obstacles,Number)},conflict_table:{dtype:"<i4",shape:[g.length/11,11],data:Int32Array.from(
g)}})}var Nl=[0,1,2,4,8],lr=class{element;player=new De(0,{speed:4,still:Ve()});#e;#r;#t=u("canvas",{tabindex:0,"aria-describedby":"play-keys"});#n=u("h2");#a=u("p",{
class:"play-told",role:"status"});#s=na(e=>this.act(e));#u=In(Nl.map(e=>[e,e?`${e} / s`:"step by step"]),()=>this.#E());#f=u("input",{type:"checkbox",onchange:()=>this.#S()});#h=u(
"input",{type:"checkbox",onchange:()=>this.#C()});#m=u("label",{class:"play-choice"},this.#h,"Best move");#p=u("p",{class:"small muted play-keys",id:"play-keys"});#l=u(
"section",{class:"play-ending",tabindex:-1,"aria-labelledby":"play-headline"});#i=Kt(this.player);#c=null;#o=null;#d=[];#g=null;#y=null;#v=[];#b=0;#w=0;constructor(e){
this.#e=e,this.#r=new je(this.#t,{numbers:!1}),this.#t.setAttribute("role","application"),oa(this.#r,()=>{let r=this.#g!==null&&this.#o&&R(this.#o.recording.moments.
at(-1),this.#g);return r?{cell:r,diagonal:this.#o.config.diagonal}:null},r=>this.act(r)),this.player.addEventListener("frame",()=>this.#o&&this.#r.show(this.#o.
recording,this.player.time)),this.player.addEventListener("step",()=>this.#C()),this.element=u("div",{class:"play"},u("header",{class:"play-head"},this.#n,this.#a),
u("div",{class:"play-stage"},this.#t),u("div",{class:"play-side"},this.#l,this.#s.element,u("label",{class:"play-choice",title:"Steps a second"},"Pace ",this.#u),
u("label",{class:"play-choice"},this.#f,u("span",{},"Fog",u("span",{class:"at-length"},": see only what it sees"))),this.#m,this.#p),this.#i)}get played(){return this.#c&&
{...this.#c.played,moves:this.#d}}get live(){return this.#o}play(e){this.#x(nn(this.#e,e.played),e.played.seat,e.title),[this.#c,this.#d,this.#b]=[e,[...e.played.
moves],0],this.element.dataset.state="playing",this.#t.focus({preventScroll:!0}),ir(this.#o,e.played.seat)&&this.#R()}watch(e,r,n){this.#c=null,this.#x(e,r,n),this.#$()}stop(){
this.#E(),this.player.pause(),this.#c=null}act(e){let[r,n]=[this.#c,this.#o];if(!r||!n||this.element.dataset.state!=="playing")return;this.#b=e;let o=Number(this.#u.
value);this.#w||(this.#k(),o&&this.element.dataset.state==="playing"&&(this.#w=setInterval(()=>this.#k(),1e3/o)))}key(e){let{target:r,key:n}=e;if(r instanceof HTMLSelectElement||
r instanceof HTMLInputElement&&(r.type==="text"||n===" ")||r instanceof HTMLButtonElement&&(n===" "||n==="Enter")||!this.#o)return!1;if(this.element.dataset.state!==
"playing")return ze(this.player,e);let s=ra(e,this.#o.config.diagonal);return s!==void 0&&this.act(s),s!==void 0}#x(e,r,n){this.#E(),this.player.pause(),[this.#o,
this.#g]=[e,r],this.#n.textContent=n,this.#t.ariaLabel=`Board, ${e.config.rows} by ${e.config.cols} cells`,this.#s.show(e.config.diagonal),this.#p.replaceChildren(
u("span",{class:"at-length"},`W A S D or the arrow keys move, Space stays${e.config.diagonal?"; Q E Z C and the numeric keypad move diagonally":""}. `),"On the \
board: swipe, or tap where to go."),this.#M(e),this.#l.replaceChildren(),this.player.length=e.length,this.player.jump(e.length),this.#C()}#S(){this.#r.look={you:this.#g,
fog:this.#f.checked,viewers:this.#g===null?[]:[this.#g],plan:this.#O()}}#M(e){this.#y=null,this.#v=this.player.ticks=[],this.#m.hidden=this.#h.disabled=!!Ct(e.config),
Zt(this.#e,e.config,Ts(e.config)).then(r=>{this.#o===e&&(this.#y=r,this.#T(),this.#C())})}#T(){let[e,r]=[this.#o,this.#y];if(!r||this.element.dataset.state==="p\
laying")return;let n=this.#e.world(e.config);n.reset(e.start),this.#v=Jt(r,n,e.actions),n.free(),this.player.ticks=Xt(this.#v)}get#A(){return this.#h.checked&&this.#c&&
this.element.dataset.state==="playing"&&this.#y&&this.#o.game(this.#y)||null}#O(){let[e,r]=[this.#g,this.#g!==null&&this.#A?.marginal(this.#g)];return e!==null&&
r?Object.assign(Array(e).fill(0),{[e]:r.indexOf(Math.max(...r))}):null}#E(){clearInterval(this.#w),this.#w=0,this.#a.ariaLive=Number(this.#u.value)?"off":"polit\
e"}#k(){let[{policies:e,seat:r},n]=[this.#c.played,this.#o];n.step(e,r,this.#b),this.#d.push(this.#b),this.player.length=n.length,this.player.glide=Math.min(.22,
.9/(Number(this.#u.value)||4)),this.player.move(n.length-this.player.step),ir(n,r)&&this.#R()}#R(){this.#E();let[e,r,n]=[this.#c,this.#o,this.played],o=Wn()?e.link(
n):null,s=`${Y(n.seat,r.config.n_pursuers)}-${r.length}-steps.npz`,a=()=>go(s,ua(this.#e,r,n.seat));this.#l.replaceChildren(u("h3",{id:"play-headline"},Wl(r,n.seat)),
...e.ending(r,n),u("div",{class:"play-buttons"},u("button",{type:"button",class:"primary",onclick:()=>e.again()},"Again"),u("button",{type:"button",onclick:()=>this.#$()},
"Watch it"),u("button",{type:"button",onclick:a},"Save"),o&&u("button",{type:"button",onclick:({currentTarget:l})=>Dl(l,o)},"Link"))),this.element.dataset.state=
"ended",this.#T();let i=this.#v.filter(({team:l})=>l===fe(r.config,n.seat));i.length&&this.#l.children[0].after(u("p",{class:"small muted"},Cs(i))),this.#l.focus(
{preventScroll:!0}),this.#l.scrollIntoView({block:"nearest"})}#$(){this.element.dataset.state="watched",this.player.length=this.#o.length,this.player.jump(0),Ve()||
this.player.play()}#C(){let[e,r,{step:n}]=[this.#o,this.#g,this.player];if(!e||n>e.length)return;let o=Qt(e,e.recording,n).filter(({agents:l})=>r===null||l.includes(
r)),s=this.#c&&n===0,a=s?[Il(e.config,r),this.#c.about??""]:[`Step ${n} of ${e.config.max_steps}`,...o.map(({text:l})=>l)];!s&&r!==null&&a.push(Ul(e,n,r)),a.push(
...this.#v.filter(l=>l.step===n).map(vt));let i=n===e.length&&r!==null?this.#A:null;i&&a.push(`Perfect play: ${Rs(i,r)||"decided in its turn"}; ${ks(this.#y,i,n)}`),
this.#S(),this.#a.textContent=a.filter(Boolean).map(l=>`${l}.`).join(" ")}};function Il(t,e){let r=t.rules.capture==="SURROUND";return fe(t,e)==="evader"?`Run a\
way: you win if ${r?"the pursuers do not surround you":"no pursuer reaches your cell"} in ${t.max_steps} steps`:`Capture evaders: ${r?"surround them with your t\
eam":"move onto their cells"}`}function Ul({config:t,recording:e},r,n){let o=e.moments[r],a=fe(t,n)==="pursuer"?"evader":"pursuer";if(!o.alive[n])return"";let i=R(
o,n),l=p=>{let[d,h]=R(o,p);return Math.max(Math.abs(d-i[0]),Math.abs(h-i[1]))},c=Array.from({length:o.alive.length},(p,d)=>d).filter(p=>fe(t,p)===a&&o.alive[p]&&
!o.captured[p-t.n_pursuers]&&2*l(p)<t.fov);if(!c.length)return`No ${a} in view`;let m=c.reduce((p,d)=>l(d)<l(p)?d:p);return`Nearest ${a}: ${sa(i,R(o,m))}`}function Wl(t,e){
let[{lasted:r,out:n,captured:o},{config:s}]=[Ye(t,e),t];return fe(s,e)==="pursuer"?`Your team captured ${o} of ${Fl(s)} in ${r} steps.`:n?`You lasted ${r} of ${s.
max_steps} steps.`:`You escaped: ${r} steps.`}var Fl=({n_evaders:t})=>`${t} evader${t===1?"":"s"}`;function Dl(t,e){let r=fo("Link to this match");r.value=e,t.replaceWith(
r),r.select(),navigator.clipboard?.writeText(e).catch(()=>{})}var cr=class{dialog=u("dialog",{class:"take-over","aria-label":"Play an agent",onclose:()=>this.view?.stop(),onkeydown:e=>this.view?.key(e)&&e.preventDefault()});view=null;#e;#r;#t;#n;#a=null;constructor(e,r,n,o=!0){
[this.#e,this.#r,this.#t,this.#n]=[e,r,n,o],n.element.addEventListener("takeover",()=>this.open())}start(e,r=""){this.#a=e;let n=st(r,this.#e,this.#r.selected),
{world:o}=this.#e[n.run],s=o&&Qs(new URLSearchParams(r.replace(/^#/,"")),o);s&&this.play(n,s)}open(){let e=this.#t.shown;if(!e)return;let{match:r,step:n}=e;this.#t.
player.pause();let o=this.#t.inspector.agent,s=n<r.length?n:0,a=(p,d)=>!!r.alive[d*r.n_agents+p],i=Array.from({length:r.n_agents},(p,d)=>(d+r.config.n_pursuers)%
r.n_agents),l=o??i.find(p=>a(p,s)),c=a(l,s)?s:0,m=Array.from({length:c},(p,d)=>r.actions[d*r.n_agents+l]);this.play(this.#r.selected,{seat:l,from:c,moves:m})}play(e,r){
let[n,o]=[this.#a,this.#e[e.run]],{world:s}=o;if(!n||!s||H.some(w=>Fe(o,w,e[w])))return;let{run:a,pursuer:i,evader:l,episode:c,seed:m}=e,p=fe(s,r.seat),d=o.teams[p].
kept.map(w=>({name:o.teams[p].script??`generation ${w}`,text:"",policy:()=>Z(o,p,w)}));this.view||(this.view=new lr(n),this.dialog.append(u("button",{type:"butt\
on",class:"leave",onclick:()=>this.dialog.close()},"Close"),this.view.element)),this.dialog.open||this.dialog.showModal();let h=`You are ${Y(r.seat,s.n_pursuers)}\
: ${this.#t.names(e).join(" against ")}`,g={pursuer:Z(o,"pursuer",i),evader:Z(o,"evader",l)},f={config:s,seed:BigInt(m??o.seeds[i][l]),episode:c,policies:g,...r},
y={run:a,pursuers:i,evaders:l,episode:c,...m===null?{}:{seed:m}};on(n,this.view,h,f,d,this.#n?y:null)}};var me=uo(),{runs:X}=me,[zl,Bl]=X[0].payoff.shape,Hl=st(location.hash,X,{run:0,pursuer:zl-1,evader:Bl-1,episode:0,seed:null}),{step:ma,...Gl}=Hl,oe=new sr(Gl),J=new er(
X,oe,me.playground),pa=new rr(X,oe),wt=new cr(X,oe,J),an=xo(X),jl=location.hash,Ae=null,da=u("span",{class:"told","aria-live":"polite"}),ha=u("span",{class:"sma\
ll muted"}),fa=()=>{let t=X[oe.selected.run];[da.textContent,ha.textContent]=[t.findings?.sentence??"",k(t).lead]};oe.on("run",fa);fa();var ga=()=>{J.playSoon(),
J.reveal()};document.getElementById("page").replaceWith(zn(me.heading,u("span",{},da,ha),u("button",{type:"button",class:"keys-button",title:"Keys (?)","aria-la\
bel":"Keys (?)",onclick:()=>an.showModal()},"?")),...me.note?[u("aside",{class:"note small muted"},me.note)]:[],wo(X,oe),u("main",{class:"stages"},pa.element,J.
element),Ys(X,oe,ga),u("footer",{class:"muted small"},`${me.title} · matrixworld ${me.version}`),wt.dialog,an);Object.assign(window,{matrixworldExplorer:{get match(){
return J.match},get step(){return J.player.step},get pace(){return J.player.pace},get playing(){return wt.view},play:t=>Ae&&_t(Ae,X[oe.selected.run],{...oe.selected,
episode:t}),get shape(){return X[oe.selected.run].payoff.shape}}});pa.element.addEventListener("play",ga);J.goTo(ma);ma||J.playSoon();Hn(X,oe,J);So(X,oe,J,an,()=>wt.
open(),()=>me.playground&&qr(J.shown,me.playground));window.addEventListener("hashchange",({newURL:t})=>Ae&&wt.start(Ae,new URL(t).hash));me.growing&&Gn(X,oe,()=>J.
player.playing||document.querySelector("dialog[open]")!==null);async function Vl(){Ae=me.playground&&await Ln(),J.start(Ae),Ae&&wt.start(Ae,jl)}requestAnimationFrame(
()=>setTimeout(()=>Un(Vl())));})();
