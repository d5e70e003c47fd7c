/* built from web/ by "npm run build"; sources c99b4cbc7e8f386e30086535a47dfe8b0750db1db9febff8e06f1c5f2b5c9625 */
"use strict";(()=>{var xt={SIMULTANEOUS:0,SWARM_TURNS:1,AGENT_TURNS:2},ie={DISAPPEAR:0,REACH:1,BOUNCE:2},At={OCCUPATION:0,SURROUND:1},Ct={FAULT:0,INVOLVED:1};var le=["obstacle","teammate","adversary"],je=["vertex","edge","chain"],Mt=["turn","kind","form","first","second","row","col","at_fault","held","doomed"],Ge=["p\
ursuer_{number}","evader_{number}"],Et={obstacle:"{first} ran into the obstacle or border at {cell}",vertex:"{first} and {second} both headed for {cell}",edge:"\
{first} and {second} meant to swap, {first} to {cell}",chain:"{first} headed for {cell}, where {second} had to stay"},ce={"both held":"both bounce","both doomed":"\
both disappear",held:"{agent} bounces",doomed:"{agent} disappears",none:"nobody is stopped"},Tt="{event}: {outcome}",ze={random:"any action, all equally likely",
still:"always stays",chaser:"moves to where the nearest adversary in view is nearest",fleer:"moves to where the nearest adversary in view is farthest","clumsy-c\
haser":"a chaser that takes any action in half of the steps",hunter:"a chaser of the nearest adversary in view to which no teammate in view is nearer",surrounder:"\
a chaser of the nearest free cell beside an adversary without a teammate","clumsy-fleer":"a fleer that takes any action in half of the steps",dodger:"moves to w\
here all adversaries in view together are farthest","team-surrounder":"shares the free cells beside adversaries with its teammates, and searches","careful-rando\
m":"as random, but takes only moves that right of way allows","careful-chaser":"as chaser, but takes only moves that right of way allows","careful-fleer":"as fl\
eer, but takes only moves that right of way allows","careful-clumsy-chaser":"as clumsy-chaser, but takes only moves that right of way allows","careful-hunter":"\
as hunter, but takes only moves that right of way allows","careful-surrounder":"as surrounder, but takes only moves that right of way allows","careful-clumsy-fl\
eer":"as clumsy-fleer, but takes only moves that right of way allows","careful-dodger":"as dodger, but takes only moves that right of way allows","careful-team-\
surrounder":"as team-surrounder, but takes only moves that right of way allows"},_t={free:".GS",blocked:"#@OTW"};var K=1+Mt.length;function ue(e,t){return e.replace(/\{(\w+)\}/g,(n,r)=>String(t[r]))}function V(e,t){return e<t?ue(Ge[0],{number:e}):ue(Ge[1],{number:e-t})}function Wr(e,t){
let[n,r,o,s,a,i,l,...c]=Array.from(e),d=a<0?[s]:[s,a],[m,h,p]=c.map(b=>d.filter((x,z)=>b>>z&1)),g=d.map(b=>V(b,t)),f=ue(Et[a<0?"obstacle":je[o]],{first:g[0],second:g[g.
length-1],cell:`(${i}, ${l})`}),y=ue(Tt,{event:f,outcome:Dr(d.length,h,p,t)});return{kind:le[r],form:je[o],agents:d,cell:[i,l],at_fault:m,held:h,doomed:p,turn:n,
text:y}}function Dr(e,t,n,r){if(e===2&&t.length===2)return ce["both held"];if(e===2&&n.length===2)return ce["both doomed"];let o=s=>a=>ue(ce[s],{agent:V(a,r)});
return[...t.map(o("held")),...n.map(o("doomed"))].join(", ")||ce.none}function xe(e,t){let n=[];for(let r=0;r<e.length;r+=K)n.push(Wr(e.subarray(r+1,r+K),t));return n}var T=class extends Error{name="EngineError"};function w(e,t,n){let r=typeof n=="string"?`'${n}'`:typeof n=="object"?JSON.stringify(n):String(n);return new T(`${e}\
: expected ${t}, got ${r}`)}var Y=class{bytes;constructor(t){this.bytes=t}},Ot=0,Ve=[Uint8Array,Uint8Array,Int32Array,BigInt64Array,BigUint64Array,Float32Array,Float64Array],kt=4,Rt=4,Fr=new TextEncoder,
Br=new TextDecoder;function Hr(e){for(let t=Ve.length-1;t>Ot;--t)if(e instanceof Ve[t])return t;throw new TypeError("array: expected a typed array of the engine\
's numbers, got another")}function Ke(e){return new Uint8Array(e.buffer,e.byteOffset,e.byteLength)}function jr(e){return Fr.encode(`${e}\0`)}var Ye=class{engine;addresses=[];constructor(t){
this.engine=t}copy(t){let n=this.engine._malloc(Math.max(t.length,1));if(n===0)throw new T("memory: expected room for the arguments, got none");return this.addresses.
push(n),this.engine.HEAPU8.set(t,n),n}text(t){return this.copy(jr(t))}arrays(t){let n=Object.entries(t),r=n.flatMap(([s,a])=>{let i=a instanceof Y,l=i?a.bytes:a;
return[this.text(s),i?Ot:Hr(l),l.length,this.copy(Ke(l))]}),o=this.copy(Ke(Int32Array.from(r)));return this.copy(Ke(Int32Array.of(n.length,o)))}free(){for(let t of this.
addresses)this.engine._free(t)}};function Lt(e,t){let n=e.HEAPU8;return Br.decode(n.subarray(t,n.indexOf(0,t)))}function J(e){let t=new Int32Array(e.HEAPU8.buffer),
n=e._last_outputs()/kt,r=t[n+1]/kt,o={};for(let s=r;s<r+t[n]*Rt;s+=Rt){let a=Ve[t[s+1]],i=t[s+2]*a.BYTES_PER_ELEMENT,l=t[s+3];o[Lt(e,t[s])]=new a(e.HEAPU8.slice(
l,l+i).buffer)}return o}function O(e,t){let n=new Ye(e);try{let r=t(n);if(r===0)throw new T(Lt(e,e._last_error()));return r}finally{n.free()}}var Gr=2**31-1,Nt=["none","gru"],zr=2n**64n-1n,Kr=34028234663852886e22;function R(e,t){if(typeof t!="number"||!Number.isInteger(t)||Math.abs(t)>Gr)throw w(e,"an\
 integer",t);return Int32Array.of(t)}function Ae(e,t){if(typeof t!="boolean")throw w(e,"true or false",t);return new Y(Uint8Array.of(Number(t)))}function U(e,t,n){
let r=typeof t=="string"&&Object.hasOwn(n,t)?n[t]:void 0;if(r===void 0)throw w(e,`one of ${Object.keys(n).join(", ")}`,t);return Int32Array.of(r)}function Je(e,t){
if(typeof t!="number"||!(Math.abs(t)<=Kr))throw w(e,"a finite number",t);return t}function X(e,t){let r=typeof t=="bigint"||typeof t=="number"&&Number.isSafeInteger(
t)?BigInt(t):-1n;if(r<0n||r>zr)throw w(e,"an integer from 0 to 2^64 - 1",t);return BigUint64Array.of(r)}function Vr(e){return{"rules.interaction":U("interaction",
e.interaction,xt),"rules.obstacle":U("obstacle",e.obstacle,ie),"rules.teammate":U("teammate",e.teammate,ie),"rules.evader":U("evader",e.evader,ie),"rules.pursue\
r":U("pursuer",e.pursuer,ie),"rules.capture":U("capture",e.capture,At),"rules.captured_disappear":Ae("captured_disappear",e.captured_disappear)}}function It(e,t){
let n=typeof t=="number"?[t,t,t]:t;if(!Array.isArray(n)||n.length!==3)throw w(e,"1 or 3 numbers",t);return Float32Array.from(n,r=>Je(e,r))}function Yr(e){let t=(n,r)=>Float32Array.
of(Je(n,e[n]),Je(r,e[r]));return{"rewards.capture":t("pursuer_capture","evader_capture"),"rewards.neighbor":t("pursuer_neighbor","evader_neighbor"),"rewards.ste\
p":t("pursuer_step","evader_step"),"rewards.pursuer_collide":It("pursuer_collide",e.pursuer_collide),"rewards.evader_collide":It("evader_collide",e.evader_collide),
"rewards.blame":U("blame",e.blame,Ct),"rewards.capture_repeats":Ae("capture_repeats",e.capture_repeats)}}function $t(e){if(e===void 0||typeof e=="number")return new Uint8Array(
0);if(e instanceof Uint8Array)return e;let{free:t,blocked:n}=_t;for(let[r,o]of e.entries()){if(o.length!==e[0]?.length)throw w(`map, row ${r}`,`${e[0]?.length} \
cells as in row 0`,o.length);let s=[...o].find(a=>!t.includes(a)&&!n.includes(a));if(s)throw w(`map, row ${r}`,`'${t}' (free) or '${n}' (obstacle)`,s)}return Uint8Array.
from([...e.join("")],r=>Number(n.includes(r)))}function Ut(e,t){if(!Array.isArray(e))return;let n=[e.length,e[0]?.length??0];if(!(n[0]===t.rows&&n[1]===t.cols))
throw w("obstacle map",`shape (${t.rows}, ${t.cols}), the rows and cols`,n)}function q(e){Ut(e.obstacles,e);let t=typeof e.obstacles=="number"?e.obstacles:0;return{
...Vr(e.rules),...Yr(e.rewards),rows:R("rows",e.rows),cols:R("cols",e.cols),n_pursuers:R("n_pursuers",e.n_pursuers),n_evaders:R("n_evaders",e.n_evaders),fov:R("\
fov",e.fov),diagonal:Ae("diagonal",e.diagonal),max_steps:R("max_steps",e.max_steps),density:Float64Array.of(t),map:$t(e.obstacles)}}function Pt(e,t){return Int32Array.
from((t??[]).flat(),n=>R(e,n)[0])}function Wt(e,t){return Ut(e.obstacles,t),{seed:X("seed",e.seed??0n),episode:X("episode",e.episode??0),pursuers:Pt("pursuers",
e.pursuers),evaders:Pt("evaders",e.evaders),map:$t(e.obstacles)}}function Ce(e){return{actions:Int32Array.from(e,t=>R("actions",t)[0])}}function L(e){if(typeof e==
"string"){if(!Object.hasOwn(ze,e))throw w("policy",`one of ${Object.keys(ze).join(", ")}`,e);return{script:new TextEncoder().encode(e)}}if(e.activation!=="relu"&&
e.activation!=="tanh")throw w("activation","'relu' or 'tanh'",e.activation);if(!Nt.includes(e.memory))throw w("memory",`one of ${Nt.join(", ")}`,e.memory);return{
hidden:Int32Array.from(e.hidden,t=>R("hidden",t)[0]),activation:new TextEncoder().encode(e.activation),sampled:Ae("sampled",e.sampled),memory:new TextEncoder().
encode(e.memory),genome:e.genome}}var Jr=["first_turn","terminated","truncated"];function Dt(e){let t={...e};for(let n of Jr)t[n]=new Y(e[n]);return t}var Ft="statistics.",Me=class{config;seed;episode;n_agents;statistics;first_conflict;constructor(t,n,r,o){this.config=t,this.seed=n,this.episode=r,this.n_agents=
t.n_pursuers+t.n_evaders,this.statistics=Bt(Ht(o),0),Object.assign(this,o),this.first_conflict=Xr(this.conflict_table,this.length)}get length(){return this.actions.
length/this.n_agents}conflicts(t){this.check(t);let[n,r]=[this.first_conflict[t],this.first_conflict[t+1]],o=this.conflict_table.subarray(n*K,r*K);return xe(o,this.
config.n_pursuers)}seek(t,n,r){this.check(n),(!(t.seed===this.seed&&t.episode===BigInt(this.episode))||t.turn!==0||t.steps>n)&&t.reset({seed:this.seed,episode:this.
episode});for(let s=t.steps;s<n;++s){let a=this.actions.subarray(s*this.n_agents,(s+1)*this.n_agents);r?t.replay(a,{pursuer:r.pursuers,evader:r.evaders}):t.step(
a)}}check(t){if(!(Number.isInteger(t)&&t>=0&&t<=this.length))throw w("step",`0 to ${this.length}`,t)}};function Xr(e,t){let n=new Int32Array(t+2);for(let r=0;r<
e.length;r+=K)++n[e[r]+1];for(let r=1;r<n.length;++r)n[r]+=n[r-1];return n}function Bt(e,t){let n=e.length.length,r=s=>{let a=e[s],i=a.length/n;return a.slice(t*
i,(t+1)*i)},o=s=>Number(r(s)[0]);return{capture_rate:o("capture_rate"),ever_capture_rate:o("ever_capture_rate"),captured_fraction:o("captured_fraction"),length:o(
"length"),return:r("return"),survivors:r("survivors"),overlap:r("overlap"),collisions:r("collisions"),faults:r("faults"),agent_steps:r("agent_steps")}}var Ht=e=>Object.
fromEntries(Object.entries(e).flatMap(([t,n])=>t.startsWith(Ft)?[[t.slice(Ft.length),n]]:[]));function jt(e,t,n,r){let o=[q(n.config),L(n.pursuers),L(n.evaders),
r];return O(e,s=>{let[a,i,l,c]=o.map(d=>s.arrays(d));return e[t](a,i,l,c)}),J(e)}function Gt(e,t,n,r){let o={seed:X("seed",n),episode:X("episode",r)};return new Me(
t.config,n,r,jt(e,"_play_match",t,o))}function Xe(e,t,n,r){if(!Number.isInteger(r)||r<1)throw w("n_episodes","at least 1",r);let o=jt(e,"_play_rollout",t,{...n,
n_episodes:Int32Array.of(r)});return Ht(o)}function zt(e,t,n,r){let o={pursuer:Int32Array.of(0),evader:Int32Array.of(0),seed:X("seed",n)},s=Xe(e,t,o,r);return Array.
from({length:r},(a,i)=>Bt(s,i))}var qr=7e6,Zr=new FinalizationRegistry(([e,t])=>e._states_free(t));function Qr({rules:e,rows:t,cols:n,obstacles:r,diagonal:o,n_pursuers:s,n_evaders:a}){let i=typeof r==
"number"||e.obstacle==="REACH"?0:r.join("").split("#").length-1,l=t*n-i,c=[e.obstacle,e.teammate,e.pursuer].includes("DISAPPEAR"),d=e.capture==="SURROUND"||e.evader===
"REACH",m=e.interaction==="AGENT_TURNS",h=(f,y)=>Array.from({length:y},(b,x)=>m?f:(f+x)/(x+1)).reduce((b,x)=>b*x,1),p=h(l+Number(c),s)*h(l*(1+Number(d))+2,a);return{
SIMULTANEOUS:[s+a],SWARM_TURNS:[s,a],AGENT_TURNS:Array(s+a).fill(1)}[e.interaction].reduce((f,y)=>f+p*(o?9:5)**y,0)}function Ee(e){return typeof e.obstacles=="n\
umber"&&e.obstacles>0?"obstacles are drawn anew in each episode":Qr(e)>qr?"the world is too large to be solved on the page":""}var qe=class{value;teams;matrix;n_actions;constructor(t,n){
let{matrix:r,rows:o,cols:s,value:a,agents:i}=n,[l,c]=t.actors,d=Array.from(i).filter(h=>l<=h&&h<c),m=h=>h<t.config.n_pursuers;[this.value,this.matrix,this.n_actions]=
[a[0],r,t.n_actions],this.teams=[{agents:d.filter(m),play:o},{agents:d.filter(h=>!m(h)),play:s}]}marginal(t){let n=this.teams.find(({agents:s})=>s.includes(t));
if(!n)return null;let r=this.n_actions**(n.agents.length-1-n.agents.indexOf(t)),o=Array(this.n_actions).fill(0);return n.play.forEach((s,a)=>o[Math.floor(a/r)%this.
n_actions]+=s),o}lost(t){let[n,r]=this.teams.map(({agents:l})=>l.reduce((c,d)=>c*this.n_actions+t[d],0)),[o,s]=this.teams.map(({play:l})=>l),a=s.reduce((l,c,d)=>l+
c*this.matrix[n*s.length+d],0),i=o.reduce((l,c,d)=>l+c*this.matrix[d*s.length+r],0);return[Math.max(0,this.value-a),Math.max(0,i-this.value)]}},Ze=60,de=class{config;payoff;engine;states;n_turns;values;starts;constructor(t,n,r){
[this.engine,this.config,this.payoff]=[t,n,r],this.states=O(t,l=>t._states_new(l.arrays(q(n)))),Zr.register(this,[t,this.states]);let o={SIMULTANEOUS:1,SWARM_TURNS:2,
AGENT_TURNS:n.n_pursuers+n.n_evaders};this.n_turns=o[n.rules.interaction];let{payoffs:s,starts:a}=this.call(()=>t._states_payoffs(this.states)),i=s;this.starts=
a,this.values=[[r==="capture-rate"?i:i.fill(0)]]}goBack(){let t=this.values.at(-1)[0],n=[];for(let o=this.n_turns-1;o>=0;o--){let s=n[o+1]??t;n[o]=this.backup(o,
{next:s})}this.payoff==="capture-time"&&(n[0]=n[0].map((o,s)=>s===this.config.n_evaders?0:o-1)),this.values.push(n);let r=this.payoff==="capture-rate"?this.config.
max_steps:Math.min(this.config.max_steps,Ze);return this.values.length<=r&&n[0].some((o,s)=>o!==t[s])}get value(){return this.mean(this.values.at(-1)[0])}guaranteed(t,n){
let r=L(n),o=Array.from({length:this.n_turns},(a,i)=>this.call(l=>this.engine._states_weigh(this.states,i,+(t==="evader"),l.arrays(r))).play),s=this.values[0][0];
for(let a=0;a<this.config.max_steps;a++){let i=s;for(let l=this.n_turns-1;l>=0;l--)s=this.backup(l,{next:s,[`${t}s`]:o[l]});if(s.every((l,c)=>l===i[c]))break}return this.
mean(s)}mean(t){return this.starts.reduce((n,r)=>n+t[r],0)/this.starts.length}backup(t,n){return this.call(r=>this.engine._states_backup(this.states,t,r.arrays(
n))).values}game(t){let[n,{turn:r}]=[this.config.max_steps-t.steps,t],o=r+1===this.n_turns,s=n>0?this.values[Math.min(n-Number(o),this.values.length-1)]?.[o?0:r+
1]:void 0;if(!s)return null;let a=this.call(i=>this.engine._states_game(this.states,t.address,i.arrays({next:s})));return a.agents.length?new qe(t,a):null}call(t){
return O(this.engine,t),J(this.engine)}};var Kt=new FinalizationRegistry(([e,t])=>e._world_free(t)),me=class{config;n_agents;n_actions;engine;at;freed=!1;constructor(t,n){this.engine=t,this.config=n,this.
n_agents=n.n_pursuers+n.n_evaders,this.n_actions=n.diagonal?9:5,this.at=O(t,r=>t._world_new(r.arrays(q(n)))),Kt.register(this,[t,this.at],this)}free(){this.freed||
(this.freed=!0,Kt.unregister(this),this.engine._world_free(this.at))}get address(){if(this.freed)throw w("world","one that is in use","one that was freed");return this.
at}reset(t={}){let n=Wt(t,this.config);this.call(r=>this.engine._world_reset(this.address,r.arrays(n)))}step(t){let n=Ce(t);this.call(r=>this.engine._world_step(
this.address,r.arrays(n)))}playTurn(t){let n=Ce(t);this.call(r=>this.engine._world_play_turn(this.address,r.arrays(n)))}decide(t,n,r){let{n_pursuers:o}=this.config,
s={pursuer:[0,o],evader:[o,this.n_agents]},[a,i]=typeof n=="string"?s[n]:n;if(r.length!==this.n_agents)throw w("actions",String(this.n_agents),r.length);let l=[
L(t),Ce(r)],{actions:c}=this.call(d=>this.engine._world_decide(this.address,d.arrays(l[0]),a,i,d.arrays(l[1])));return Uint8Array.from(c)}replay(t,n){let r=s=>typeof s!=
"string"&&s.memory!=="none";if(!r(n.pursuer)&&!r(n.evader))return this.step(t);let{n_pursuers:o}=this.config;for(let s=this.n_turns;s>0;--s){let[a,i]=this.actors;
a<o&&this.decide(n.pursuer,[a,Math.min(i,o)],t),i>o&&this.decide(n.evader,[Math.max(a,o),i],t),this.playTurn(t)}}get n_turns(){return this.turnNumbers()[1]}get turn(){
return this.turnNumbers()[0]}get actors(){let[,,t,n]=this.turnNumbers();return[t,n]}turnNumbers(){return this.call(()=>this.engine._world_turn(this.address)).turn}get steps(){
return this.read("steps")[0]}get seed(){return this.read("seed")[0]}get episode(){return this.read("episode")[0]}get over(){return this.read("terminated")[0]===
1||this.read("truncated")[0]===1}read(t){return this.call(n=>this.engine._world_read(this.address,n.text(t)))[t]}view(t){let n=3*this.config.fov**2;return this.
read("views").slice(t*n,(t+1)*n)}map(){return this.read("state").slice(2*this.config.rows*this.config.cols)}conflicts(){return xe(this.conflictTable(),this.config.
n_pursuers)}conflictTable(){return this.call(()=>this.engine._world_conflicts(this.address)).conflict_table}answer(t,n){let r=L(t),{logits:o,memory:s}=this.call(
l=>this.engine._world_logits(this.address,l.arrays(r),n)),a=o,i=this.decide(t,[n,n+1],new Uint8Array(this.n_agents))[n];return{logits:a,probabilities:eo(a),action:i,
memory:s}}snapshot(){return this.call(()=>this.engine._world_snapshot(this.address))}restore(t){let n=Dt(t);this.call(r=>this.engine._world_restore(this.address,
r.arrays(n)))}call(t){return O(this.engine,t),J(this.engine)}};function eo(e){let t=Math.max(...e),n=Array.from(e,o=>Math.exp(o-t)),r=n.reduce((o,s)=>o+s,0);return Float32Array.
from(n,o=>o/r)}var Qe=class{compiled;constructor(t){this.compiled=t}world(t){return new me(this.compiled,t)}solution(t,n="capture-rate"){return new de(this.compiled,t,n)}match(t,n,r,o,s=0){
return Gt(this.compiled,{config:t,pursuers:n,evaders:r},o,s)}rollout(t,n,r,o,s){return zt(this.compiled,{config:t,pursuers:n,evaders:r},o,s)}rollouts(t,n,r,o,s){
return Xe(this.compiled,{config:t,pursuers:n,evaders:r},o,s)}},Vt;function Yt(e=globalThis.matrixworldEngine){return Vt??=to(e),Vt}async function to(e){if(!e)throw new Error(
"matrixworldEngine: expected the script engine.js before this one, got none");let t=Uint8Array.from(atob(e.binary),n=>n.charCodeAt(0));return new Qe(await e({wasmBinary:t}))}var no="http://www.w3.org/2000/svg";function u(e,t={},...n){return Jt(document.createElement(e),t,n)}function W(e,t={},...n){return Jt(document.createElementNS(
no,e),t,n)}function Jt(e,t,n){for(let[r,o]of Object.entries(t))o==null||o===!1||(typeof o=="function"?e.addEventListener(r.slice(2),o):e.setAttribute(r,o===!0?"":
String(o)));return e.append(...n.filter(ro).map(r=>typeof r=="number"?String(r):r)),e}function ro(e){return e!=null&&e!==!1}var Te=()=>["file:","http:","https:"].
includes(location.protocol);async function et(e,t){e.select();try{await navigator.clipboard.writeText(e.value),t.textContent="Copied."}catch{t.textContent="Sele\
cted: copy it with Ctrl+C."}}var C=["stay","north","east","south","west","northeast","southeast","southwest","northwest"];var N="champion",D=0,F=64,Z=100,Q=300,tt=e=>({cell:e,gone:!1,captured:!1,everCaptured:!1}),_=e=>[...e.pursuers,...e.evaders],A=e=>e.pursuers.length+e.evaders.length,
nt=(e,t)=>t<e.pursuers.length?"pursuers":"evaders",k=(e,t)=>V(t,e.pursuers.length),rt=(e,t)=>Object.keys(e).every(n=>e[n]===t[n]);function ee(e,t){return Object.
keys(t).find(n=>rt(t[n],e))??null}function te(e,t){let n=new Set(e.walls),r=Array.from({length:e.rows},(o,s)=>Array.from({length:e.cols},(a,i)=>n.has(s*e.cols+i)?
"#":".").join(""));return{rules:t,rows:e.rows,cols:e.cols,n_pursuers:e.pursuers.length,n_evaders:e.evaders.length,fov:e.fov,diagonal:e.diagonal,max_steps:e.maxSteps,
obstacles:r,rewards:e.rewards}}var _e=(e,t,n)=>({...e,next:e.next.map((r,o)=>o===t?n:r)}),Xt=e=>({...e,played:[...e.played,e.next],next:e.next.map(t=>typeof t==
"number"?D:t)}),qt=e=>({...e,played:e.played.slice(0,-1),next:e.played.at(-1)??e.next});function ot(e,t,n){let r=(o,s)=>o.map((a,i)=>i===s?{...a,cell:n}:a);return{
...e,pursuers:r(e.pursuers,t),evaders:r(e.evaders,t-e.pursuers.length)}}function Zt(e,t,n){let r=t==="pursuers"?e.pursuers.length:A(e);return{...e,[t]:[...e[t],
tt(n)],next:[...e.next.slice(0,r),D,...e.next.slice(r)],ended:!1}}function ke(e,t){let n=nt(e,t),r=n==="pursuers"?t:t-e.pursuers.length;return{...e,[n]:e[n].filter(
(o,s)=>s!==r),next:e.next.filter((o,s)=>s!==t)}}function st(e,t,n){let r=t[0]*e.cols+t[1],o=e.walls.filter(s=>s!==r);return{...e,walls:n?[...o,r].sort((s,a)=>s-
a):o}}function Qt(e,t,n){let r=([s,a])=>s<t&&a<n,o=_(e).map(({cell:s})=>r(s));return{...e,rows:t,cols:n,walls:e.walls.map(s=>[Math.floor(s/e.cols),s%e.cols]).filter(
r).map(([s,a])=>s*n+a),pursuers:e.pursuers.filter((s,a)=>o[a]),evaders:e.evaders.filter((s,a)=>o[e.pursuers.length+a]),next:e.next.filter((s,a)=>o[a])}}function I(e,[
t,n]){let r=_(e).findIndex(({cell:o,gone:s})=>!s&&o[0]===t&&o[1]===n);return r<0?null:r}var P=(e,[t,n])=>e.walls.includes(t*e.cols+n);function en(e){let t=Array.
from({length:e.rows*e.cols},(o,s)=>[Math.floor(s/e.cols),s%e.cols]),n=([o,s])=>Math.abs(o-(e.rows-1)/2)+Math.abs(s-(e.cols-1)/2),r=t.filter(o=>I(e,o)===null&&!P(
e,o));return r.length?r.reduce((o,s)=>n(s)<n(o)?s:o):null}var pe=class extends Error{},B="_",cn="n",tn=2n**64n-1n,nn=2e4,rn=40,H={fov:11,maxSteps:500,rewards:"paper"},at=["rules","others","rewards","size","diagonal","f\
ov","limit","seed","ended","walls","pursuers","evaders","played","next"];function v(e,t,n){let r=n.length>rn?`${n.slice(0,rn)}…`:n;throw new pe(`${e}: expecte\
d ${t}, got "${r}"`)}function he(e,t){let n=i=>i.map(l=>so(l,t)).join(""),r=i=>`${Math.floor(i/e.cols)}.${i%e.cols}`,o=oo(e.rewards,t),s=[e.seed,e.episode,e.steps].
join("."),a={rules:sn(e.rules,t),others:e.others?sn(e.others,t):"",rewards:o===H.rewards?"":o,size:`${e.rows}x${e.cols}`,diagonal:e.diagonal?"1":"",fov:e.fov===
H.fov?"":String(e.fov),limit:e.maxSteps===H.maxSteps?"":String(e.maxSteps),seed:s==="0.0.0"?"":s,ended:e.ended?"1":"",walls:e.walls.map(r).join(B),pursuers:e.pursuers.
map(on).join(B),evaders:e.evaders.map(on).join(B),played:e.played.map(n).join(B),next:e.next.every(i=>i===D)?"":n(e.next)};return at.filter(i=>a[i]).map(i=>`${i}\
=${a[i]}`).join("&")}function on({cell:e,gone:t,captured:n,everCaptured:r}){let o=n?"c":r?"e":"";return`${e[0]}.${e[1]}${o}${t?"x":""}`}function sn(e,t){let n=t.
fields.map(({name:r})=>String(e[r]).toLowerCase());return ee(e,t.variants)??n.join(".")}function oo(e,t){let n=JSON.stringify(e);return Object.keys(t.rewards).find(
o=>JSON.stringify(t.rewards[o])===n)??Object.values(e).map(o=>String(o)).join(B)}function so(e,t){if(typeof e=="number")return String(e);if(e===N)return cn;let n=t.
scripts.findIndex(({name:r})=>r===e);return String.fromCharCode(97+n)}function fe(e,t){e.length>nn&&v("link",`at most ${nn} characters`,`${e.length} characters`);
let n=ao(e),r=(h,p="")=>n.get(h)??p,o=ln("rules",r("rules"),t),[s,a]=io(r("size")),i=h=>it(r(h)).map(p=>lo(h,p,s,a)),[l,c,d]=po(r("seed","0.0.0")),m={rules:o,others:n.
has("others")?ln("others",r("others"),t):null,rewards:uo(r("rewards",H.rewards),t),rows:s,cols:a,seed:l,episode:c,steps:d,diagonal:an("diagonal",r("diagonal","0")),
fov:Re("fov",r("fov",String(H.fov)),1,255),maxSteps:Re("limit",r("limit",String(H.maxSteps)),1,2**31-1),ended:an("ended",r("ended","0")),walls:co(r("walls"),s,a),
pursuers:i("pursuers"),evaders:i("evaders"),played:[],next:[]};return ho(m),fo(m,it(r("played")),r("next"),t)}function ao(e){let t=new Map;for(let n of e.replace(
/^#/,"").split("&").filter(Boolean)){let[r,o]=n.includes("=")?[n.slice(0,n.indexOf("=")),n.slice(n.indexOf("=")+1)]:[n,""];at.includes(r)||v("link",`parts ${at.
join(", ")}`,r),t.has(r)&&v(r,"it once","it twice"),t.set(r,o)}return t}var it=e=>e?e.split(B):[];function Re(e,t,n,r){let o=/^\d{1,10}$/.test(t)?Number(t):NaN;
return o>=n&&o<=r||v(e,`a number from ${n} to ${r}`,t),o}function an(e,t){return t!=="0"&&t!=="1"&&v(e,"0 or 1",t),t==="1"}function io(e){let[t,n,...r]=e.split(
"x");return(t===void 0||n===void 0||r.length)&&v("size","rows and columns, such as 4x6",e),[Re("size",t,1,F),Re("size",n,1,F)]}function un(e,t,n,r){let o=/^(\d{1,4})\.(\d{1,4})$/.
exec(t),s=[Number(o?.[1]),Number(o?.[2])];return(!o||s[0]>=n||s[1]>=r)&&v(e,`cells of a ${n} x ${r} grid, such as 0.2`,t),s}function lo(e,t,n,r){let o=/^(.*?)([ce]?)(x?)$/.
exec(t),s=un(e,o[1],n,r);return e==="pursuers"&&o[2]&&v(e,"no captured pursuer",t),{cell:s,gone:o[3]==="x",captured:o[2]==="c",everCaptured:o[2]!==""}}function co(e,t,n){
let r=it(e).map(o=>{let[s,a]=un("walls",o,t,n);return s*n+a});return[...new Set(r)].sort((o,s)=>o-s)}function ln(e,t,n){let r=Object.hasOwn(n.variants,t)?n.variants[t]:
void 0;if(r)return r;let o=t.split("."),s=`${Object.keys(n.variants).join(", ")} or ${n.fields.length} values joined by "."`;o.length!==n.fields.length&&v(e,s,t);
let a=n.fields.map(({name:i,values:l},c)=>{let d=l.find(m=>m.name.toLowerCase()===o[c])?.name;return d===void 0&&v(`${e}, ${i}`,l.map(m=>m.name.toLowerCase()).join(
" or "),o[c]),[i,d==="true"?!0:d==="false"?!1:d]});return Object.fromEntries(a)}function uo(e,t){if(Object.hasOwn(t.rewards,e))return t.rewards[e];let n=Object.
entries(t.rewards[H.rewards]),r=e.split(B);return r.length!==n.length&&v("rewards",`${Object.keys(t.rewards).join(", ")} or ${n.length} values`,e),Object.fromEntries(
n.map(([o,s],a)=>[o,mo(o,r[a],s)]))}function mo(e,t,n){if(e==="blame"&&(t==="FAULT"||t==="INVOLVED"))return t;if(typeof n=="boolean"&&(t==="true"||t==="false"))
return t==="true";let r=t.split(",").map(a=>/^-?[\d.]+(e[+-]?\d+)?$/i.test(a)?Number(a):NaN),o=e.endsWith("_collide")?[1,3]:[1];return(typeof n!="number"||!o.includes(
r.length)||!r.every(a=>Math.abs(a)<34e37))&&v(`rewards, ${e}`,`a value like ${n}`,t),r.length===1?r[0]:r}function po(e){let t=/^(\d{1,20})\.(\d{1,20})\.(\d{1,9})$/.
exec(e);if(!t)return v("seed","seed.episode.steps, such as 0.0.0",e);let[n,r]=[BigInt(t[1]),BigInt(t[2])];return(n>tn||r>tn)&&v("seed","numbers below 2^64",e),[
n,r,Number(t[3])]}function ho(e){for(let t of["pursuers","evaders"]){let n=e[t].length;(n<1||n>Z)&&v(t,`1 to ${Z} agents`,`${n}`)}e.fov%2===0&&v("fov","an odd n\
umber",String(e.fov)),e.steps>e.maxSteps&&v("seed",`at most ${e.maxSteps} steps`,String(e.steps))}function fo(e,t,n,r){let o=_(e).length;t.length>Q&&v("played",
`at most ${Q} steps`,`${t.length} steps`);let s=a=>i=>(i.length!==o&&v(a,`${o} characters, one for each agent`,i),[...i].map(l=>go(a,l,e.diagonal?9:5,r)));return{
...e,played:t.map(s("played")),next:n?s("next")(n):Array(o).fill(D)}}function go(e,t,n,r){let o=/^\d$/.test(t)?Number(t):NaN;if(o<n)return o;if(t===cn&&r.champions)
return N;let s=r.scripts[t.charCodeAt(0)-97],a=String.fromCharCode(97+r.scripts.length-1);return s?.name??v(e,`actions 0 to ${n-1} or scripts a to ${a}`,t)}var Oe=[.5,1,2,4,8,16,32,64];var dn=12,yo=2,Le=class extends EventTarget{#e;#r;#t;#n=0;#s=0;#o=!1;#a=null;#c=0;#l=[];#u=[];glide=.28;constructor(t,n={}){super(),this.#e=t,this.#r=n.speed??4,
this.#t=n.still??!1}get step(){return this.#n}get time(){return this.#t?this.#n:this.#s}get arrived(){return this.#s===this.#n}get playing(){return this.#o}get length(){
return this.#e}set length(t){this.#e=t,this.#n>t&&this.jump(t),this.#i("state")}get marks(){return this.#l}set marks(t){this.#l=t,this.#i("state")}get ticks(){return this.#u}set ticks(t){
this.#u=t,this.#i("state")}get pace(){return this.#r||Math.max(yo,this.#e/dn)}get speed(){return this.#r}set speed(t){this.#r=t,this.#i("state")}changeSpeed(t){
let n=Oe.findIndex(r=>r>=this.pace);this.speed=Oe[Math.min(Oe.length-1,Math.max(0,n+t))]}play(){this.#o||!this.#e||(this.#n===this.#e&&this.jump(0),this.#o=!0,this.#i(
"state"),this.#p())}pause(){this.#o&&(this.#o=!1,this.#i("state"))}toggle(){this.#o?this.pause():this.play()}move(t){this.pause();let n=Math.min(this.#e,Math.max(
0,this.#n+t));Math.abs(n-this.#s)>1?this.jump(n):this.#d(n),this.#p()}jump(t){this.#s=Math.min(this.#e,Math.max(0,Math.round(t))),this.#d(this.#s),this.#i("fram\
e")}#d(t){t!==this.#n&&(this.#n=t,this.#i("step"),this.#t&&this.#i("frame"))}#p(){this.#a===null&&(this.#c=performance.now(),this.#a=requestAnimationFrame(()=>this.#m()))}#m(){
this.#a=null;let t=performance.now();this.#h(Math.min(.25,(t-this.#c)/1e3)),this.#c=t,(!this.#t||this.arrived)&&this.#i("frame"),(this.#o||this.#s!==this.#n)&&(this.#a=
requestAnimationFrame(()=>this.#m()))}#h(t){let n=t;for(;n>0;){if(this.#s===this.#n){if(!this.#o)return;if(this.#n===this.#e)return this.pause();this.#d(this.#n+
1)}let r=this.#o?this.pace:1/this.glide,o=this.#n-this.#s,s=Math.min(Math.abs(o),n*r);n-=s/r,this.#s=s===Math.abs(o)?this.#n:this.#s+Math.sign(o)*s}this.#o&&this.#s===
this.#e&&this.pause()}#i(t){this.dispatchEvent(new Event(t))}};var j=[[0,0],[-1,0],[0,1],[1,0],[0,-1],[-1,1],[1,1],[1,-1],[-1,-1]];function lt(e,t,n){let[r,o]=[t[0]-e[0],t[1]-e[1]];return!n&&Math.abs(r)>Math.abs(o)?o=0:n||(r=
0),j.findIndex(([s,a])=>s===Math.sign(r)&&a===Math.sign(o))}var G=(e,t)=>t<e.nPursuers,S=(e,t)=>[e.positions[2*t],e.positions[2*t+1]],bo=(e,t)=>e[0]===t[0]&&e[1]===
t[1],ge=({rows:e,cols:t},[n,r])=>n>=0&&r>=0&&n<e&&r<t,ct=(e,t,n=3)=>e!==void 0&&[0,1,2].slice(0,n).some(r=>e[3*t+r]),ut=(e,t)=>ct(e.fault,t),mn=(e,t)=>!ut(e,t)&&
ct(e.involved,t,2);function Ne(e,t,n){let r=!bo(S(e,n),S(t,n)),o=t.involved===void 0||ct(t.involved,n);return!!(t.alive[n]&&t.actions?.[n]&&!r&&o)}function Ie(e,t,n){
let[r,o]=S(e,n),[s,a]=j[t.actions?.[n]??0];return[r+s,o+a]}function pn(e,t,n){return Array.from({length:n.everCaptured.length},(o,s)=>s).filter(o=>n.everCaptured[o]&&
!t.everCaptured[o]).map(o=>e.nPursuers+o)}function hn(e,t){return Array.from({length:t.alive.length},(r,o)=>o).filter(r=>e.alive[r]&&!t.alive[r])}var fn=[-.31,0,.31],gn=[{size:1,at:[[0,0]]},{size:.62,at:[[-.2,.2],[.2,-.2]]},{size:.54,at:[[-.23,.22],[.23,.22],[0,-.22]]},{size:.54,at:[[-.23,.23],[.23,.23],[
-.23,-.23],[.23,-.23]]},{size:.36,at:fn.flatMap(e=>fn.map(t=>[t,e]))}],vo=.3,wo=.35,So=.55;function ye(e,t){let n=new Map;for(let r=0;r<t.alive.length;r++){if(!t.
alive[r])continue;let[o,s]=S(t,r),a=o*e.cols+s,i=n.get(a);i?i.push(r):n.set(a,[r])}return n}function yn(e,t){let n=Array.from(t.alive,(r,o)=>{let[s,a]=S(t,o);return{
x:a+.5,y:s+.5,size:1,alpha:0}});for(let r of ye(e,t).values()){let o=gn[Math.min(r.length,gn.length)-1];r.forEach((s,a)=>{let[i,l]=o.at[Math.min(a,o.at.length-1)],
c=n[s];c.x+=i,c.y+=l,c.size=o.size,c.alpha=1})}return n}var bn=e=>e*e*(3-2*e),ne=(e,t,n)=>e+(t-e)*n,vn=e=>Math.min(1,Math.max(0,e));function wn(e,t,n,r){let o={
SIMULTANEOUS:1,SWARM_TURNS:2,AGENT_TURNS:n}[e.interaction];if(o===1)return bn(r);let s=o===n?t:+!G(e,t),a=Math.max(1/o,wo);return bn(vn((r-s/(o-1)*(1-a))/a))}function Pe(e,t){
let n=e.moments.length-1,r=Math.min(Math.floor(t),n),o=e.moments[r],s=yn(e,o);if(r===n||t===r)return s;let a=e.moments[r+1],i=yn(e,a);return s.map((l,c)=>{let d=wn(
e,c,s.length,t-r);return xo(o,a,c,l,i[c],d)})}function dt(e,t,n){let r=e.moments.length-1,o=Math.min(Math.floor(n),r),[s,a]=[e.moments[o],e.moments[Math.min(o+1,
r)]],i=wn(e,t,s.alive.length,n-o),[[l,c],[d,m]]=[S(s,t),S(a,t)];return[ne(c,m,i)+.5,ne(l,d,i)+.5]}function xo(e,t,n,r,o,s){let a=r.alpha>o.alpha,i={x:ne(r.x,o.x,
s),y:ne(r.y,o.y,s),size:a?r.size:ne(r.size,o.size,s),alpha:a?vn((1-s)/(1-So)):ne(r.alpha,o.alpha,s)};if(Ne(e,t,n)){let[l,c]=S(e,n),[d,m]=Ie(e,t,n),h=vo*Math.sin(
Math.PI*s);i.x+=(m-c)*h,i.y+=(d-l)*h}return i}var Sn=2*Math.PI;function be(e,t,n,r){e.beginPath(),e.arc(t,n,r/2,0,Sn)}function xn(e,t,n,r){let o=r/2,s=[[0,-.97],[.97,.83],[-.97,.83]].map(([a,i])=>[t+a*o,n+i*
o]);e.beginPath(),e.moveTo((s[2][0]+s[0][0])/2,(s[2][1]+s[0][1])/2),s.forEach(([a,i],l)=>{let[c,d]=s[(l+1)%3];e.arcTo(a,i,c,d,r*.09)}),e.closePath()}function An(e,t,n,r){
let o=r*.32;e.beginPath(),e.moveTo(t-o,n-o),e.lineTo(t+o,n+o),e.moveTo(t+o,n-o),e.lineTo(t-o,n+o)}function Cn(e,t,n,r){e.beginPath();for(let o=0;o<16;o++){let s=r/
2*(o%2?.6:.95),a=Sn*o/16;e.lineTo(t+s*Math.sin(a),n-s*Math.cos(a))}e.closePath()}function Mn(e,t,n,r,o,s){let a=Math.atan2(o-n,r-t);e.beginPath(),e.moveTo(t,n),
e.lineTo(r,o);for(let i of[-1,1])e.moveTo(r,o),e.lineTo(r-s*Math.cos(a+i*.6),o-s*Math.sin(a+i*.6))}var En=4,Ao=1.6,Co=.95,Mo=5,Eo=.16,To=9,_o=.09,ko=.2,Tn=.75,M=(e,t)=>e.left+t*e.cell,E=(e,t)=>e.top+t*e.cell;function re(e,t,n){return G(t,n)?e.colors.pursuer:e.
colors.evader}function _n({ctx:e,grid:t,colors:n}){let{left:r,top:o,cell:s,rows:a,cols:i}=t,[l,c]=[i*s,a*s];if(e.fillStyle=n.paper,e.fillRect(r,o,l,c),s<Mo)return;
e.fillStyle=n.line;let d=Math.max(1,Math.round(s/60));for(let m=1;m<i;m++)e.fillRect(r+m*s,o,d,c);for(let m=1;m<a;m++)e.fillRect(r,o+m*s,l,d)}function kn({ctx:e,
grid:t,colors:n},r){let{left:o,top:s,cell:a,rows:i,cols:l}=t;e.fillStyle=n.obstacle;for(let c=0;c<i*l;c++){if(!r.obstacles[c])continue;let[d,m]=[Math.floor(c/l),
c%l];e.fillRect(o+m*a,s+d*a,a,a)}Rn({ctx:e,grid:t,colors:n})}function Rn({ctx:e,grid:{left:t,top:n,cell:r,rows:o,cols:s},colors:a}){let i=Math.min(5,Math.max(2,
Math.round(r/18)));e.strokeStyle=a.frame,e.lineWidth=i,e.strokeRect(t-i/2,n-i/2,s*r+i,o*r+i)}function On({ctx:e,grid:t,colors:n},r){let{left:o,top:s,cell:a,rows:i,
cols:l}=t,c=a<24*r?5:1;e.font=`500 ${Math.round(Math.min(15*r,Math.max(9*r,a*.32)))}px system-ui, sans-serif`,e.fillStyle=n.muted,e.textBaseline="alphabetic",e.
textAlign="center";let d=5*r+a/40;for(let m=0;m<l;m+=c)e.fillText(String(m),o+(m+.5)*a,s-d);e.textAlign="right",e.textBaseline="middle";for(let m=0;m<i;m+=c)e.fillText(
String(m),o-d,s+(m+.5)*a)}function Ln({grid:e},t,n,r){let o=Math.floor(t.fov/2)+.5,[s,a]=[Math.max(0,n-o),Math.min(e.cols,n+o)],[i,l]=[Math.max(0,r-o),Math.min(
e.rows,r+o)];return[M(e,s),E(e,i),(a-s)*e.cell,(l-i)*e.cell]}function Nn(e,t,n,r){let{ctx:o,grid:s,colors:a}=e;o.save(),o.beginPath(),o.rect(0,0,o.canvas.width,
o.canvas.height),o.rect(...Ln(e,t,n,r)),o.clip("evenodd"),o.clearRect(0,0,o.canvas.width,o.canvas.height),o.fillStyle=a.line,o.fillRect(s.left,s.top,s.cols*s.cell,
s.rows*s.cell),o.restore(),Rn(e)}function In({ctx:e,grid:t,colors:n},{x:r,y:o,alpha:s},a){let i=Math.max(t.cell,16*a)*1.06,[l,c]=[M(t,r),E(t,o)];e.globalAlpha=Math.
max(s,.6),e.beginPath(),e.roundRect(l-i/2,c-i/2,i,i,i*.2),e.strokeStyle=n.focus,e.lineWidth=Math.max(2,2.5*a),e.stroke();let d=Math.max(11*a,Math.min(18*a,t.cell*
.5));e.font=`700 ${Math.round(d)}px system-ui, sans-serif`,e.textAlign="center",e.textBaseline="middle";let m=c-i/2<d*1.2,h=c+(m?1:-1)*(i/2+d*.7);e.strokeStyle=
n.paper,e.lineJoin="round",e.lineWidth=d*.35,e.strokeText("You",l,h),e.fillStyle=n.ink,e.fillText("You",l,h),e.globalAlpha=1}function Pn(e,t,n,r,o){let{ctx:s,grid:a}=e,
i=Ln(e,t,r,o),l=re(e,t,n);s.globalAlpha=.11,s.fillStyle=l,s.fillRect(...i),s.globalAlpha=.8,s.strokeStyle=l,s.lineWidth=Math.max(1,a.cell/24),s.strokeRect(...i),
s.globalAlpha=1}function $n(e,t,n,r,o){let{ctx:s,grid:a}=e,i=Math.min(Math.ceil(n),t.moments.length-1),l=t.moments[i];s.lineCap="round",s.lineWidth=Math.min(To,
Math.max(1,a.cell*Eo));for(let c=Math.max(1,Math.floor(n-r)+1);c<=i;c++){let[d,m]=[t.moments[c-1],t.moments[c]],h=Math.max(0,Math.min(1,(n-c)/r));s.globalAlpha=
Tn+(ko-Tn)*h;for(let p=0;p<m.alive.length;p++){let g=c===i&&n<i;if(!d.alive[p]||!(l.alive[p]||g))continue;let f=(G(t,p)?-1:1)*_o,[y,b]=S(d,p),[x,z]=S(m,p);if(y===
x&&b===z)continue;let Se=g?o[p].x:z+.5,Ur=g?o[p].y:x+.5;s.strokeStyle=re(e,t,p),s.beginPath(),s.moveTo(M(a,b+.5+f),E(a,y+.5+f)),s.lineTo(M(a,Se+f),E(a,Ur+f)),s.
stroke()}}s.globalAlpha=1}function Un(e,t,n){let r=Math.min(Math.ceil(n),t.moments.length-1);for(let o=Math.max(1,r-En+1);o<=r;o++){let[s,a]=[t.moments[o-1],t.moments[o]],
i=o>n?Math.max(0,1-2*(o-n)):1-(n-o)/En,l=pn(t,s,a);for(let c of hn(s,a))l.includes(c)||Oo(e,S(a,c),i);for(let c of l)Ro(e,S(a,c),i)}e.ctx.globalAlpha=1}function Ro({
ctx:e,grid:t,colors:n},[r,o],s){e.globalAlpha=s,Cn(e,M(t,o+.5),E(t,r+.5),Math.max(8,t.cell*Ao)),e.fillStyle=n.capture,e.fill(),e.strokeStyle=n.ink,e.lineWidth=Math.
max(1,t.cell/36),e.lineJoin="round",e.stroke()}function Oo({ctx:e,grid:t,colors:n},[r,o],s){e.globalAlpha=s,An(e,M(t,o+.5),E(t,r+.5),Math.max(7,t.cell*Co)),e.strokeStyle=
n.collision,e.lineWidth=Math.max(2,t.cell*.17),e.lineCap="round",e.stroke()}function Wn({ctx:e,grid:t,colors:n},r,o){let s=Math.max(1,t.cell*.07);e.strokeStyle=
e.fillStyle=n.collision,e.lineWidth=Math.max(1,t.cell*.05),e.setLineDash([t.cell*.14,t.cell*.1]);for(let[a,i]of r){if(a<0||i<0||a>=t.rows||i>=t.cols)continue;let l=[
M(t,i)+s,E(t,a)+s,t.cell-2*s,t.cell-2*s];e.globalAlpha=.2*o,e.fillRect(...l),e.globalAlpha=o,e.strokeRect(...l)}e.setLineDash([]),e.globalAlpha=1}function Dn({ctx:e,
grid:t,colors:n},r,o,s,a){e.globalAlpha=a,be(e,M(t,r),E(t,o),Math.max(8,t.cell*s*1.02)),e.strokeStyle=n.collision,e.lineWidth=Math.max(1.5,t.cell*.085*Math.sqrt(
s)),e.stroke(),e.globalAlpha=1}var Lo=.8,No=.92,Io=15,Po=7,mt=9;function Fn(e,t,n,r,o,s){r.forEach((a,i)=>{a.alpha>0&&$o(e,t,n,i,a,o,s)}),e.ctx.globalAlpha=1;for(let a of ye(t,n).values())a.length>
mt&&Uo(e,r[a[mt-1]],a.length-mt+1)}function $o(e,t,n,r,o,s,a){let{ctx:i,grid:l,colors:c}=e,d=G(t,r),[m,h]=[l.left+o.x*l.cell,l.top+o.y*l.cell],p=Math.max(4,l.cell*
o.size*(d?No:Lo)),g=re(e,t,r),f=!d&&!!n.captured[r-t.nPursuers];if(i.globalAlpha=o.alpha,(d?xn:be)(i,m,h,p),p>Po*a&&(i.strokeStyle=c.paper,i.lineWidth=Math.max(
2,p*.1),i.stroke()),i.fillStyle=f?c.paper:g,i.fill(),f&&(be(i,m,h,p*.82),i.strokeStyle=g,i.lineWidth=p*.18,i.stroke()),!s||p<Io*a)return;let y=String(d?r:r-t.nPursuers);
i.font=`700 ${Math.round(p*(d?.4:.5)*(y.length>1?.8:1))}px system-ui, sans-serif`,i.textAlign="center",i.textBaseline="middle",i.fillStyle=f?g:c.paper,i.fillText(
y,m,h+p*(d?.17:.03))}function Uo({ctx:e,grid:t,colors:n},r,o){let[s,a]=[t.left+r.x*t.cell,t.top+r.y*t.cell];e.font=`700 ${Math.round(t.cell*.3)}px system-ui, sa\
ns-serif`,e.textAlign="center",e.textBaseline="middle",e.strokeStyle=n.paper,e.lineWidth=t.cell*.1,e.strokeText(`+${o}`,s,a),e.fillStyle=n.ink,e.fillText(`+${o}`,
s,a)}var Wo=.46,Do=.86,Fo=.66,Bn=.48,Bo=.78,Ho=.58;function Hn(e,t,n,r){let[o,s]=[t.moments[n-1],t.moments[n]];if(!o)return;let{ctx:a,grid:i,colors:l}=e;a.strokeStyle=
l.collision,a.lineWidth=Math.max(1.5,i.cell*.07),a.lineCap="butt",a.globalAlpha=r;for(let c=0;c<s.alive.length;c++)Ne(o,s,c)&&jo(e,t,S(o,c),Ie(o,s,c));a.globalAlpha=
1}function jo({ctx:e,grid:t},n,r,o){let[s,a]=[o[1]-r[1],o[0]-r[0]],i=m=>M(t,r[1]+.5+s*m),l=m=>E(t,r[0]+.5+a*m),c=ge(n,o)?Bo:Ho;e.setLineDash([t.cell*.09,t.cell*
.06]),e.beginPath(),e.moveTo(i(Bn),l(Bn)),e.lineTo(i(c),l(c)),e.stroke(),e.setLineDash([]);let d=.17*t.cell/Math.hypot(s,a);e.beginPath(),e.moveTo(i(c)-a*d,l(c)+
s*d),e.lineTo(i(c)+a*d,l(c)-s*d),e.stroke()}function jn(e,t,n,r,o,s){let a=j[s];if(!s||!a)return;let{ctx:i,grid:l,colors:c}=e,d=ge(t,[r[0]+a[0],r[1]+a[1]])?Do:Fo,
m=Wo*o.size,h=[M(l,o.x+a[1]*m),E(l,o.y+a[0]*m),M(l,o.x+a[1]*d),E(l,o.y+a[0]*d)],p=Math.max(1.5,l.cell*.085);i.lineCap=i.lineJoin="round";for(let[g,f]of[[c.paper,
p*2.1],[re(e,t,n),p]])i.strokeStyle=g,i.lineWidth=f,Mn(i,...h,l.cell*.2),i.stroke()}var zn={numbers:!0,axes:!1,trail:6,viewers:[],plan:null,selected:null,cursor:null,you:null,fog:!1};function Kn(e,t,n,r,o){let{ctx:s,grid:a,colors:i}=e,l=Math.min(
Math.ceil(n),t.moments.length-1),c=t.moments[l],d=n===l,m=Pe(t,n),h=d?1:Math.max(0,1-2*(l-n));s.clearRect(0,0,s.canvas.width,s.canvas.height),_n(e);for(let f of r.
viewers)m[f]?.alpha&&Pn(e,t,f,...dt(t,f,n));kn(e,t),r.axes&&On(e,o),$n(e,t,n,r.trail,m),Wn(e,c.contested??[],h),Un(e,t,n),Hn(e,t,l,h),m.forEach(({x:f,y,size:b},x)=>{
let z=mn(c,x)?.4:0,Se=ut(c,x)?1:z;Se&&Dn(e,f,y,b,Se*h)});let p=d?c:t.moments[Math.max(0,l-1)];if(Fn(e,t,p,m,r.numbers,o),d&&r.plan)for(let[f,y]of m.entries())y.
alpha&&jn(e,t,f,S(c,f),y,r.plan[f]??0);r.you!==null&&(r.fog&&Nn(e,t,...dt(t,r.you,n)),In(e,m[r.you],o)),s.lineWidth=Math.max(2,2.5*o),s.strokeStyle=i.focus;let g=r.
selected===null?void 0:m[r.selected];g?.alpha&&Gn(e,g.x,g.y,g.size*.96),r.cursor&&(s.setLineDash([a.cell*.12,a.cell*.08]),Gn(e,r.cursor[1]+.5,r.cursor[0]+.5,.8),
s.setLineDash([]))}function Gn({ctx:e,grid:t},n,r,o){let s=o*t.cell;e.beginPath(),e.roundRect(t.left+n*t.cell-s/2,t.top+r*t.cell-s/2,s,s,s*.1),e.stroke()}var Vn=(e,t)=>(t+.24)/(e+.24);function Yn(e,t,n,r,o,s){let a=n?28*s:0,i=(c,d)=>(c-a)/(d+2*.12),l=Math.max(1,Math.floor(Math.min(i(r,t),i(o,e))));return{rows:e,cols:t,
cell:l,left:Math.round((r-t*l+a)/2),top:Math.round((o-e*l+a)/2)}}function Jn(e,t,n){let r=Math.floor((n-e.top)/e.cell),o=Math.floor((t-e.left)/e.cell);return r>=
0&&r<e.rows&&o>=0&&o<e.cols?[r,o]:null}var Go={paper:"--board-paper",line:"--board-line",frame:"--board-frame",ink:"--board-ink",muted:"--board-muted",obstacle:"--board-obstacle",pursuer:"--pursuer",
evader:"--evader",capture:"--capture",collision:"--collision",focus:"--focus"};function Xn(e){let t=getComputedStyle(e),n=Object.entries(Go).map(([r,o])=>[r,t.getPropertyValue(
o).trim()]);return Object.fromEntries(n)}var qn=()=>matchMedia("(prefers-reduced-motion: reduce)").matches,$e=class{canvas;#e=null;#r=0;#t;#n={rows:1,cols:1,left:0,top:0,cell:1};#s=0;#o;#a;constructor(t,n={}){
this.canvas=t,t.classList.add("board"),t.setAttribute("role","img"),this.#t={...zn,...n},this.#o=new ResizeObserver(()=>this.#u()),this.#o.observe(t),this.#a=new MutationObserver(
()=>this.redraw()),this.#a.observe(document.documentElement,{attributes:!0}),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",this.redraw),addEventListener(
"beforeprint",this.#c)}close(){this.#o.disconnect(),this.#a.disconnect(),matchMedia("(prefers-color-scheme: dark)").removeEventListener("change",this.redraw),removeEventListener(
"beforeprint",this.#c),cancelAnimationFrame(this.#s)}get look(){return this.#t}set look(t){this.#t={...this.#t,...t},this.#l(),this.redraw()}show(t,n){this.#e=t,
this.#r=Math.min(Math.max(0,n),t.moments.length-1),this.#l(),this.redraw()}redraw=()=>{this.#s||(this.#s=requestAnimationFrame(()=>this.drawNow()))};#c=()=>this.
drawNow();drawNow(){cancelAnimationFrame(this.#s),this.#s=0;let t=this.canvas.getContext("2d");if(!t||!this.#e)return;let{rows:n,cols:r}=this.#e,o=devicePixelRatio||
1;this.#n=Yn(n,r,this.#t.axes,this.canvas.width,this.canvas.height,o);let s={ctx:t,grid:this.#n,colors:Xn(this.canvas)};Kn(s,this.#e,this.#r,this.#t,o)}cellAt(t,n){
let r=this.canvas.getBoundingClientRect(),o=this.canvas.width/r.width;return Jn(this.#n,(t-r.left)*o,(n-r.top)*o)}agentAt(t,n){let r=this.cellAt(t,n);if(!r||!this.#e)
return null;let o=this.#e.moments[Math.round(this.#r)],s=ye(this.#e,o).get(r[0]*this.#e.cols+r[1])??[],a=Pe(this.#e,Math.round(this.#r)),i=l=>{let[c,d]=this.pointOf(
a[l].x,a[l].y);return Math.hypot(c-t,d-n)};return s.length?s.reduce((l,c)=>i(c)<i(l)?c:l):null}pointOf(t,n){let r=this.canvas.getBoundingClientRect(),o=r.width/
this.canvas.width,{left:s,top:a,cell:i}=this.#n;return[r.left+(s+t*i)*o,r.top+(a+n*i)*o]}#l(){if(!this.#e)return;let{rows:t,cols:n}=this.#e;this.canvas.style.setProperty(
"--board-aspect",String(Vn(t,n)))}#u(){let t=devicePixelRatio||1,{width:n,height:r}=this.canvas.getBoundingClientRect();this.canvas.width=Math.max(1,Math.round(
n*t)),this.canvas.height=Math.max(1,Math.round(r*t)),this.drawNow()}};function Zn(e,t,n){return{rows:e.rows,cols:e.cols,nPursuers:e.n_pursuers,fov:e.fov,interaction:e.rules.interaction,obstacles:t,moments:n}}function Qn(e,t){return{
positions:e.read("last_positions"),alive:e.read("alive"),captured:e.read("captured"),everCaptured:e.read("ever_captured"),actions:t,involved:e.read("involved"),
fault:e.read("fault"),contested:e.conflicts().map(n=>n.cell)}}var pt=.005,tr=.05,zo=["pursuer","evader"],Ko=4,oe=new Map;function nr(e,t,n="capture-rate"){let r=JSON.stringify([{...t,rewards:null},n]),o=oe.get(r)??(Ee(t)?Promise.
resolve(null):Vo(e,t,n));return oe.delete(r),oe.set(r,o),oe.size>Ko&&oe.delete([...oe.keys()][0]),o}var rr=({n_evaders:e})=>e===1?"capture-time":"capture-rate",
er=()=>new Promise(e=>setTimeout(e));async function Vo(e,t,n){await er();let r=e.solution(t,n);for(;r.goBack();)await er();return r}function or(e,t,n){let{payoff:r}=e;
return n.flatMap((o,s)=>{let a=[0,0];for(let l=t.n_turns;l>0&&!t.over;l--)e.game(t)?.lost(o).forEach((c,d)=>a[d]+=c),t.playTurn(o);let i=r==="capture-rate"?pt:tr;
return zo.map((l,c)=>({step:s+1,team:l,lost:a[c],payoff:r})).filter(l=>l.lost>=i)})}var Yo=({lost:e,payoff:t})=>t==="capture-rate"?`${e.toFixed(2)} of the capture rate`:`${e.toFixed(1)} steps`,sr=e=>`The ${e.team}s lose ${Yo(e)} against a perfe\
ct opponent`;function ar({config:e,payoff:t},{value:n},r){if(t==="capture-rate")return`value ${n.toFixed(2)}`;let[o,s]=[1-n,Math.min(e.max_steps-r,Ze)];return o>s-tr?`free f\
or ${s} steps`:`captured after ${o.toFixed(1)} steps`}function ir(e,t){return(e.marginal(t)??[]).map((r,o)=>({share:r,action:o})).filter(({share:r})=>r>=pt).sort(
(r,o)=>o.share-r.share).map(({share:r,action:o})=>r>1-pt?C[o]:`${C[o]} ${r.toFixed(2)}`).join(", ")}var Ue=class{recording;rules;outcomes=[];#e;#r;#t;#n=[];#s=[];constructor(t,n,r,o){this.#e=n,this.#r=o,this.rules=r;let s=te(n,r);this.#t=t.world(s),this.#t.restore(
Jo(this.#t,n)),this.recording=Zn(s,this.#t.map(),this.#n),this.#a(void 0);for(let a of n.played)this.#o(a)}follow(t){if(!ht(this.#e,t))return!1;let n=this.#e.played,
r=t.played.findIndex((a,i)=>a!==n[i]),o=r<0?t.played.length:r,s=Math.min(o+1,this.#n.length);this.#n.length=this.outcomes.length=this.#s.length=s,this.#t.restore(
this.#s.at(-1));for(let a of t.played.slice(s-1))this.#o(a);return this.#e=t,!0}get length(){return this.#n.length-1}get over(){let{terminated:t,truncated:n}=this.
outcomes.at(-1);return t||n}actions(t){let n=Uint8Array.from(t,o=>typeof o=="number"?o:D),r=new Set(t.filter(o=>typeof o=="string"));for(let o of this.over?[]:r)
for(let s of["pursuer","evader"]){let a=this.#t.decide(o===N?this.#r[s].policy:o,s,n);t.forEach((i,l)=>{i===o&&l<this.#e.pursuers.length==(s==="pursuer")&&(n[l]=
a[l])})}return n}scene(){let t=this.#t,[n,r]=[t.read("last_positions"),t.read("alive")],[o,s]=[t.read("captured"),t.read("ever_captured")],a=this.#e.pursuers.length,
i=_(this.#e).map((l,c)=>({...tt([n[2*c],n[2*c+1]]),gone:!r[c],captured:c>=a&&!!o[c-a],everCaptured:c>=a&&!!s[c-a]}));return{...this.#e,played:[],steps:t.steps,ended:this.
outcomes.at(-1).terminated,pursuers:i.slice(0,a),evaders:i.slice(a)}}perfect(t){let[n,r]=[this.#s.at(-2),this.#n.at(-1).actions];return n&&this.#t.restore(n),{losses:n&&
r?or(t,this.#t,[r]):[],game:t.game(this.#t)}}free(){this.#t.free()}#o(t){if(this.over)return;let n=this.actions(t);this.#t.step(n),this.#a(n)}#a(t){let n=this.#t;
this.#n.push(Qn(n,t)),this.#s.push(n.snapshot()),this.outcomes.push({conflicts:t?n.conflicts():[],rewards:n.read("rewards"),captors:n.read("captors"),terminated:!!n.
read("terminated")[0],truncated:!!n.read("truncated")[0]})}};function Jo(e,t){let n=_(t),r=n.map(({cell:s})=>s[0]*t.cols+s[1]),o=s=>Uint8Array.from(t.evaders,a=>Number(
a[s]));return{...e.snapshot(),seed:BigUint64Array.of(t.seed),episode:BigUint64Array.of(t.episode),cells:Int32Array.from(r,(s,a)=>n[a].gone?-1:s),last_cells:Int32Array.
from(r,(s,a)=>n[a].gone?s:-1),captured:o("captured"),ever_captured:o("everCaptured"),capture_paid:o("everCaptured"),captors:new Int32Array(t.evaders.length),rewards:new Float32Array(
A(t)),report:new Int32Array(A(t)),participants:new Int32Array(0),steps:Int32Array.of(t.steps),terminated:Uint8Array.of(Number(t.ended)),truncated:Uint8Array.of(
+(t.steps>=t.maxSteps))}}function ht(e,t){return Object.keys(e).every(r=>["played","next","rules","others"].includes(r)||e[r]===t[r])}var Xo={SIMULTANEOUS:.45,SWARM_TURNS:.9,AGENT_TURNS:1.4},qo=200,We=class extends EventTarget{data;player;#e;#r;#t;#n=[];#s=[];#o=[];#a=!1;#c="act";#l=0;#u=null;#d;constructor(t,n,r,o=null){
super(),[this.#u,this.#d]=[o,r],this.#e=t,this.data=n,this.#r=r,this.#t=this.#m(r),this.player=new Le(this.game.length,{still:qn()}),this.player.jump(this.game.
length),this.player.addEventListener("frame",()=>this.#g()),this.#i()}get scene(){return this.#r}get game(){return this.#t[0]}get games(){return this.#t}get mode(){
return this.#c}set mode(t){this.stop(),this.#c=t,this.#f()}get selected(){return this.#l}set selected(t){this.#l=t,this.#f()}get running(){return this.#a}get example(){
return ht(this.#d,this.#r)?this.#u:null}get canStep(){return!this.game.over&&this.#r.played.length<Q}change(t,n={}){let r;try{r=this.#m(t)}catch(o){if(!(o instanceof
T))throw o;return this.say(o.message,!0),!1}return n.part||(this.#n=[...this.#n,this.#r].slice(-qo)),this.#s=[],n.example!==void 0&&([this.#u,this.#d]=[n.example,
t]),this.#o=[],this.#h(t,r),!0}step(){if(!this.canStep){this.stop(),this.say(this.game.over?"The episode has ended. Go back, or restart.":`The playground plays ${Q}\
 steps.`,!0);return}let n=this.#o.at(-1)===this.#r.next?this.#o.slice(0,-1):[],r=Xt(this.#r);this.change({...r,next:n.at(-1)??r.next}),this.#o=n}back(){this.stop();
let{played:t}=this.#r;if(!this.game.length)return;let n=this.#r,r=this.#o.at(-1)===n.next?[...this.#o]:[];for(let o=t.length;o>=this.game.length;o--)n=qt(n),r.push(
n.next);this.change(n),this.#o=r}restart(){this.stop();let{played:t}=this.#r;if(!t.length)return;let n=[...this.#o.at(-1)===this.#r.next?this.#o:[],...[...t].reverse()];
this.change({...this.#r,played:[],next:t[0]}),this.#o=n}run(){if(this.#a)return this.stop();this.#a=this.canStep,this.step()}stop(){this.#a&&(this.#a=!1,this.#f())}undo(){
this.#p(this.#n,this.#s)}redo(){this.#p(this.#s,this.#n)}solution(){let t=te(this.#r,this.#r.rules);return nr(this.#e,t,rr(t))}get canUndo(){return this.#n.length>
0}say(t,n=!1){this.dispatchEvent(new CustomEvent("message",{detail:{text:t,problem:n}}))}#p(t,n){let r=t.pop();r&&(this.stop(),n.push(this.#r),this.#o=[],this.#h(
r,this.#m(r)))}#m(t){let n=t.others?[t.rules,t.others]:[t.rules],r=this.#t??[];return n.map(o=>{let s=r.find(i=>i.rules===o),a=s?.follow(t)?s:new Ue(this.#e,t,o,
this.data.champions);return a.actions(t.next),a})}#h(t,n){let[r,o]=[this.#r,this.#t.length];for(let l of this.#t)n.includes(l)||l.free();this.#r=t,this.#t=n,this.#l!==
null&&this.#l>=_(t).length&&(this.#l=null);let s=this.game.length,[a,i]=[this.player.step,r.rules!==t.rules||t.others!==null&&o<2];this.player.length=s,this.#i(),
i&&s&&this.player.jump(s-1),i&&s||Math.abs(s-a)===1?this.player.move(s-this.player.step):this.player.jump(s),this.#f()}#i(){this.player.glide=Xo[this.#r.rules.interaction]}#g(){
this.#a&&this.player.arrived&&this.step()}#f(){this.dispatchEvent(new Event("change"))}};function lr(e,t,n){let r=s=>new We(e,t,fe(s,t),ur(t,s)),o=t.gallery[0].scene;try{return{store:r(n||o),problem:""}}catch(s){return{store:r(o),problem:cr(s)}}}function cr(e){
if(e instanceof pe||e instanceof T)return`This link holds no scene. ${e.message}`;throw e}function ur(e,t){return e.gallery.find(n=>n.scene===t)??null}function ve(){
try{return decodeURIComponent(location.hash.slice(1))}catch{return location.hash.slice(1)}}var Zo=100;function dr(e){let[t,n,r]=[he(e.scene,e.data),ve(),0],o=()=>{
r=0,ve()===n&&(n=t,history.replaceState(null,"",`#${t}`))};e.addEventListener("change",()=>{t=he(e.scene,e.data),t!==n&&!r&&(r=setTimeout(o,Zo))}),window.addEventListener(
"hashchange",()=>{if(n=ve(),n!==t)try{e.change(fe(n,e.data),{example:ur(e.data,n)})}catch(s){e.say(cr(s),!0)}})}function mr(){let e=JSON.parse(document.getElementById("data").textContent),t=document.getElementById("champions")?.textContent;return t?{...e,champions:JSON.parse(
t,Qo)}:e}var Qo=(e,t)=>e==="genome"?Float32Array.from(t):t;function es(){let e=document.documentElement.dataset.theme;return e?e==="dark":matchMedia("(prefers-color-scheme: dark)").matches}function ft(){document.documentElement.
dataset.theme=es()?"light":"dark"}if(typeof document<"u"){let e=document.documentElement.dataset,t=e.theme;addEventListener("beforeprint",()=>{t=e.theme,e.theme=
"light"}),addEventListener("afterprint",()=>{t?e.theme=t:delete e.theme})}function pr(){return u("button",{type:"button",title:"Light or dark (D)","aria-label":"\
Light or dark",onclick:ft},"◐")}var hr=(e,t,...n)=>u("header",{class:"top"},u("div",{},u("h1",{},e),t?u("p",{class:"lead"},t):null),u("div",{class:"tools"},...n,pr()));var yr={ArrowUp:1,ArrowRight:2,ArrowDown:3,ArrowLeft:4},ts={e:5,c:6,y:7,z:7,q:8};function br(e){let t=u("div",{class:"arena"}),n=[fr(e,0),fr(e,1)];t.append(...n.
map(o=>o.element));let r=()=>n.forEach(o=>o.update());return e.addEventListener("change",r),e.player.addEventListener("frame",r),r(),t}function fr(e,t){let n=u(
"canvas",{tabindex:0,"aria-describedby":"board-keys"}),r=u("h2",{class:"arm-name"}),o=u("figure",{class:"arm"},r,n),s=new $e(n,{axes:!0,trail:1}),a={cell:[0,0]};
ns(e,s);let i=()=>{let l=e.games[t];if(o.hidden=!l,!l)return;let{mode:c,scene:d}=e;n.setAttribute("role","application"),n.ariaLabel=`Board, ${d.rows} by ${d.cols}\
 cells`,n.dataset.mode=c,r.textContent=$(e,t),r.hidden=e.games.length<2;let m=e.player.arrived&&e.player.step===e.game.length;s.look={plan:c==="act"&&m&&!l.over?
l.actions(d.next):null,selected:c==="act"?e.selected:null,cursor:c==="build"&&document.activeElement===n?a.cell:null},s.show(l.recording,e.player.time)};return n.
addEventListener("focus",i),n.addEventListener("blur",i),ss(e,n,a,i),{element:o,update:i}}function $(e,t){let n=t?e.scene.others:e.scene.rules;return n&&ee(n,e.
data.variants)||"own rules"}function gt(e,t){let n=_(e.game.scene())[t];return n&&!n.gone?n.cell:null}function ns(e,t){let n=null;t.canvas.addEventListener("poi\
nterdown",r=>{let o=t.cellAt(r.clientX,r.clientY);if(!o||r.button!==0||e.running)return;t.canvas.setPointerCapture(r.pointerId);let s=t.agentAt(r.clientX,r.clientY);
n=e.mode==="build"?os(e,o,s):rs(e,o,s)}),t.canvas.addEventListener("pointermove",r=>{let o=t.cellAt(r.clientX,r.clientY);o&&n?.(o)});for(let r of["pointerup","p\
ointercancel"])t.canvas.addEventListener(r,()=>{n=null})}function rs(e,t,n){if(n===null){let s=e.selected===null?null:gt(e,e.selected);return s&&Math.max(Math.abs(
s[0]-t[0]),Math.abs(s[1]-t[1]))===1&&se(e,lt(s,t,e.scene.diagonal)),null}let r=e.selected===n;e.selected=n;let o=gt(e,n);return o?(r&&se(e,0),s=>se(e,lt(o,s,e.scene.
diagonal))):null}function os(e,t,n){let r=!1,o=i=>{e.change(i,{part:r}),r=!0};if(n!==null)return e.selected=n,i=>{let l=e.game.scene();I(l,i)===null&&!P(l,i)&&o(
ot(l,n,i))};let s=!P(e.game.scene(),t),a=i=>{let l=e.game.scene();I(l,i)===null&&P(l,i)!==s&&o(st(l,i,s))};return a(t),a}function se(e,t){let{selected:n,scene:r}=e;
n===null||e.running||e.game.over||(r.next[n]!==t&&e.change(_e(r,n,t)),e.say(`${k(r,n)}: ${C[t]}.`))}function ss(e,t,n,r){t.addEventListener("keydown",o=>{if(o.ctrlKey||
o.metaKey||o.altKey)return;let s=e.mode==="act"?yt(e,o):as(e,o,n);r(),s&&o.preventDefault()})}function yt(e,t){let n=t.key.length===1?t.key.toLowerCase():t.key,
r=yr[n]??(e.scene.diagonal?ts[n]:void 0)??{s:0,Delete:0}[n];return r!==void 0?(e.selected===null&&gr(e,1),se(e,r),!0):n!=="n"&&n!=="p"?!1:(gr(e,n==="n"?1:-1),!0)}
function gr(e,t){let n=A(e.scene),r=e.game.recording.moments.at(-1).alive,o=e.selected??(t>0?-1:n);for(let s=0;s<n;s++){if(o=(o+t+n)%n,!r[o])continue;e.selected=
o;let[a,i]=gt(e,o);return e.say(`${k(e.scene,o)} at (${a}, ${i}).`)}}function as(e,t,n){let r=e.game.scene(),o=yr[t.key];if(o!==void 0){let a=t.shiftKey?I(r,n.cell):
null,i=[n.cell[0]+j[o][0],n.cell[1]+j[o][1]];ge(r,i)&&(n.cell=i);let l=I(r,n.cell)===null&&!P(r,n.cell);a!==null&&l&&e.change(ot(r,a,n.cell));let[c,d]=n.cell;return e.
say(`(${c}, ${d}): ${is(e,n.cell)}.`),!0}let s=I(r,n.cell);return t.key===" "||t.key==="Enter"?(s===null?e.change(st(r,n.cell,!P(r,n.cell))):e.selected=s,!0):t.
key==="Delete"&&s!==null?(e.change(ke(r,s)),!0):!1}function is(e,t){let n=e.game.scene(),r=I(n,t);return r!==null?k(n,r):P(n,t)?"obstacle":"free"}var bt=["·","↑","→","↓","←","↗","↘","↙","↖"],vr=e=>typeof e=="number"?`${bt[e]} ${C[e]}`:e,ls={obstacle:["obstacle"],teammate:["teammate"],adversary:[
"evader","pursuer"]},cs=e=>e.length<2?e.join(""):`${e.slice(0,-1).join(", ")} and ${e.at(-1)}`;function De(e,t,n){let[r,o,s]=[t.recording.moments[n-1],t.recording.
moments[n],t.outcomes[n]];if(!r||!o||!s)return[];let a=[...s.conflicts.map(l=>us(e,t.rules,l)),...ds(e,r,o,s.captors)],i={kind:"calm",text:"No conflict, no capt\
ure.",turn:0,blame:"",cost:"",used:[]};return[...a.length?a:[i],...ms(e,t,n)]}function us(e,t,n){let r=n.at_fault.map(c=>k(e,c)),o=t.interaction==="SIMULTANEOUS"?
0:n.turn+1,s=r.length?`At fault: ${cs(r)}.`:"Nobody is at fault.",a=n.held.length+n.doomed.length>0,i=new Set(n.at_fault.map(c=>wr(e,c,le.indexOf(n.kind))));i.delete(
0);let l=a||!i.size?"":`Allowed, but it costs: ${[...i].map(Fe).join(" and ")}.`;return{kind:n.kind,text:`${n.text}.`,turn:o,blame:s,cost:l,used:ls[n.kind]}}function wr({
pursuers:e,rewards:t},n,r){let o=n<e.length?t.pursuer_collide:t.evader_collide;return typeof o=="number"?o:o[r]}function Fe(e){let t=String(Number(Math.abs(e).toPrecision(
5)));return e<0?`−${t}`:e>0?`+${t}`:"0"}function Sr(e,t,n,r){let[o,s,a]=[t.recording.moments[n-1],t.recording.moments[n],t.outcomes[n]];if(!o?.alive[r]||!s||!a)
return"";let{rewards:i}=e,l=r<e.pursuers.length?"pursuer":"evader",c=i.blame==="FAULT"?s.fault:s.involved,d=le.reduce((p,g,f)=>p+(c?.[3*r+f]?wr(e,r,f):0),0),m=a.
rewards[r]-d-i[`${l}_step`],h=Array.from({length:e.evaders.length+1},(p,g)=>g*i[`${l}_capture`]);for(let p of[0,i[`${l}_neighbor`]]){let g=h.find(b=>Math.abs(b+
p-m)<1e-4);if(g===void 0)continue;let f={collision:d,capture:g,neighbour:p,step:i[`${l}_step`]},y=Object.entries(f).filter(([,b])=>b).map(([b,x])=>`${Fe(x)} ${b}`);
return y.length>1?y.join(", "):""}return""}function ds(e,t,n,r){let o=[];for(let s=0;s<e.evaders.length;s++){let a=e.pursuers.length+s,i=k(e,a),l=t.alive[a]&&!n.
alive[a],c=r[s]?` by ${r[s]} ${r[s]===1?"pursuer":"pursuers"}`:"",d=["capture",...l?["captured_disappear"]:[]];n.captured[s]&&!t.captured[s]?o.push({kind:"captu\
re",text:`${i} is captured${c}${l?" and disappears":""}.`,turn:0,blame:"",cost:"",used:d}):t.captured[s]&&!n.captured[s]&&n.alive[a]&&o.push({kind:"capture",text:`${i}\
 is free again.`,turn:0,blame:"",cost:"",used:["capture"]})}return o}function ms(e,t,n){let{terminated:r,truncated:o}=t.outcomes[n];if(!r&&!o)return[];let s=t.recording.
moments[n].alive,a=(c,d)=>Array.from(s).slice(c,d).some(Boolean),i=e.pursuers.length,l=`after ${e.maxSteps} steps`;return r&&(l=a(0,i)?"every evader is captured\
 or gone":"no pursuer is left"),r&&!a(i,A(e))&&(l="no evader is left"),[{kind:"end",text:`The episode has ended: ${l}.`,turn:0,blame:"",cost:"",used:[]}]}function we(e){
return e.split(/(\(-?\d+, -?\d+\)|-[A-Z]{1,3}\b)/).map((t,n)=>n%2?u("span",{class:"whole"},t):t)}function vt(e){let t=e==="pursuers"?W("path",{d:"M12 3 22 20H2z"}):W("circle",{cx:12,cy:12,r:9.5});return W("svg",{viewBox:"0 0 24 24",class:`glyph ${e}`,"aria-\
hidden":!0},t)}function xr(e){let t=[0,1].map(()=>u("th",{class:"reward",scope:"col"})),n=u("tbody"),r=u("table",{class:"agents"},u("thead",{},u("tr",{},u("th",
{scope:"col"},"agent"),u("th",{scope:"col"},"next"),...t)),n),o=u("section",{class:"card agents-card"},u("h2",{},"Agents"),e.data.champions?u("button",{type:"bu\
tton",title:"The networks of the match move all agents but the chosen one",onclick:()=>ps(e)},"Networks move all others"):"",u("div",{class:"agents-scroll"},r)),
s=[],a="",i=()=>{let{scene:l}=e,c=`${l.pursuers.length} ${l.evaders.length} ${l.diagonal}`;c!==a&&(a=c,s=Array.from({length:A(l)},(d,m)=>hs(e,m)),n.replaceChildren(
...s.map(d=>d.element))),t.forEach((d,m)=>{d.hidden=m>=e.games.length,d.textContent=e.games.length>1&&e.games[m]?$(e,m):"reward",d.title="Reward of the step"}),
s.forEach((d,m)=>gs(e,d,m))};return e.addEventListener("change",i),e.player.addEventListener("step",i),i(),o}function ps(e){e.stop(),e.change({...e.scene,next:e.
scene.next.map((t,n)=>n===e.selected?t:N)})}function hs(e,t){let{scene:n}=e,r=k(n,t),o=u("select",{"aria-label":`${r} does next`},...fs(e,n,t));o.addEventListener(
"change",()=>{let d=o.value;e.stop(),e.change(_e(e.scene,t,/^\d$/.test(d)?Number(d):d))});let s=u("span",{class:"state muted"}),a=u("span",{class:"heard"}),i=u(
"button",{type:"button",class:"agent-name",onclick:()=>e.selected=t},vt(nt(n,t)),r,a),l=[0,1].map(()=>u("td",{class:"reward numbers"}));return{element:u("tr",{},
u("th",{scope:"row"},i),u("td",{},o,s),...l),choice:o,state:s,heard:a,rewards:l}}function fs(e,t,n){let r=C.slice(0,t.diagonal?9:5).map((i,l)=>u("option",{value:l},
vr(l))),o=e.data.scripts.map(({name:i,text:l})=>u("option",{value:i,title:l},i)),s=[u("optgroup",{label:"move"},...r),u("optgroup",{label:"script"},...o)],a=e.data.
champions?.[n<t.pursuers.length?"pursuer":"evader"];return a?[u("option",{value:N},a.name),...s]:s}function gs(e,{element:t,choice:n,state:r,heard:o,rewards:s},a){
let{scene:i,game:l,player:c}=e,d=l.recording.moments[Math.min(c.step,l.length)],m=a-i.pursuers.length,h=m>=0&&!!d.captured[m];t.classList.toggle("chosen",e.selected===
a),t.classList.toggle("gone",!d.alive[a]),n.value=String(i.next[a]),n.disabled=!d.alive[a]||l.over,n.hidden=!d.alive[a],r.hidden=!!d.alive[a],r.textContent=h?"c\
aptured":"gone",t.classList.toggle("captured",h),o.textContent=h?" captured":"",s.forEach((p,g)=>{let f=e.games[g];p.hidden=!f;let y=f?.outcomes[c.step]?.rewards[a],
b=f?Sr(i,f,c.step,a):"";p.replaceChildren(c.step&&y!==void 0?Fe(y):"",e.games.length>1?"":u("span",{class:"sum small muted"},b)),p.title=b;let x=l.outcomes[c.step]?.
rewards[a];p.classList.toggle("differs",g>0&&y!==void 0&&x!==y)})}function Ar(e,...t){let n=u("button",{type:"button",class:"close","aria-label":"Close"},"✕"),r=u("dialog",{"aria-label":e},u("div",{class:"dialog-head"},u("h2",
{},e),n),...t);return n.addEventListener("click",()=>r.close()),r.addEventListener("click",o=>o.target===r&&r.close()),r}function Cr(e){let t=u("input",{type:"t\
ext",readonly:!0,"aria-label":"Link"}),n=u("input",{type:"text",readonly:!0,"aria-label":"Scene"}),r=u("p",{class:"muted small",role:"status"}),o=Ar("Share this\
 scene",u("p",{},"The link holds the whole scene: board, agents, rules and moves. Nothing is sent anywhere."),u("label",{class:"copy",hidden:!Te()},u("span",{},
"Link to this page"),t,u("button",{type:"button",onclick:()=>et(t,r)},"Copy")),u("label",{class:"copy"},u("span",{},"Scene, for any copy of the playground"),n,u(
"button",{type:"button",onclick:()=>et(n,r)},"Copy")),r);return{element:o,open:()=>{n.value=`#${he(e.scene,e.data)}`,t.value=location.href.split("#")[0]+n.value,
r.textContent="",o.showModal()}}}var ys=[[["Enter"],"play a step"],[["Backspace"],"take the last step back"],[["Home"],"back to the start"],[["Space"],"run, or \
stop"],[["N","P"],"choose the next agent, or the one before"],[["↑","→","↓","←"],"the chosen agent moves there next"],[["Q","E","C","Y"],"the same on a \
diagonal, where the board allows it"],[["S"],"the chosen agent stays"],[["1","… 9"],"choose a variant"],[["M"],"change between Move and Build"],[["Ctrl Z","Ct\
rl Y"],"undo, redo"],[["L"],"link to this scene"],[["D"],"light or dark"],[["?"],"these keys"]],bs=[[["↑","→","↓","←"],"move the cursor on the board"],[
["Space"],"draw or erase an obstacle, or choose the agent there"],[["Shift ↑"],"carry the agent under the cursor"],[["+","-"],"add a pursuer, an evader"],[["D\
elete"],"remove the agent under the cursor"]];function Mr(){let e=n=>u("dl",{class:"keys"},...n.flatMap(([r,o])=>[u("dt",{},...r.map(s=>u("kbd",{},s))),u("dd",{},
o)])),t=u("div",{class:"keys-columns"},u("div",{},u("h3",{},"Anywhere"),e(ys)),u("div",{},u("h3",{},"On the board, in Build"),e(bs),u("h3",{},"With mouse or fin\
ger"),u("p",{},"Move: press an agent and drag it towards a cell beside it, or choose it and press that cell."),u("p",{},"Build: drag agents; draw on free cells \
to make obstacles, on obstacles to erase them.")));return Ar("Keys",t)}function Er(e){let t=e.data.gallery.map(l=>u("button",{type:"button",class:"chip",onclick:()=>{e.stop(),e.mode="act",e.change(fe(l.scene,e.data),{example:l}),e.
selected=0}},l.title)),n=u("p",{class:"example-text"}),r=u("p"),o=u("details",{class:"reveal"},u("summary",{},"Reveal"),r),s=u("nav",{class:"gallery","aria-labe\
l":"Examples"},u("div",{class:"chips"},...t),n,o),a,i=()=>{e.data.gallery.forEach((l,c)=>t[c].setAttribute("aria-pressed",String(l===e.example))),n.replaceChildren(
...we(e.example?.ask??"A scene of your own. Choose an example, or change this one.")),r.replaceChildren(...we(e.example?.text??"")),o.hidden=!e.example,a!==e.example&&
(o.open=!1),a=e.example};return e.addEventListener("change",i),i(),s}var vs={first:"M6 5v14M19 5 9 12l10 7z",back:"M17 5 7 12l10 7z",play:"M7 4.5 19 12 7 19.5z",pause:"M8 5v14M16 5v14",forward:"M7 5l10 7-10 7z",last:"M18 5v14M5 5\
l10 7-10 7z"};function wt(e){return W("svg",{viewBox:"0 0 24 24","aria-hidden":"true",class:"icon"},W("path",{d:vs[e]}))}function Tr(e){let t=ws(e),n=Ss(e),r=As(e),o=xs(e),s=u("p",{class:"message",role:"status"});e.addEventListener("message",l=>{let{text:c,problem:d}=l.detail;s.textContent=
c,s.classList.toggle("problem",d)});let a=[t,n,r,o],i=()=>a.forEach(l=>l.update());return e.addEventListener("change",i),e.addEventListener("change",()=>{s.textContent=
"",s.classList.remove("problem")}),e.player.addEventListener("step",i),i(),u("div",{class:"toolbar"},...a.map(l=>l.element),s)}function Be(e,t,n,r){return u("bu\
tton",{type:"button",title:`${t} (${n})`,onclick:r},wt(e),u("span",{},t))}function ws(e){let t=Be("first","Restart","Home",()=>e.restart()),n=Be("back","Back","\
Backspace",()=>e.back()),r=Be("forward","Step","Enter",()=>e.step()),o=Be("play","Run","Space",()=>e.run());return r.classList.add("primary"),r.id="step",{element:u(
"div",{class:"buttons",role:"group","aria-label":"Steps"},t,n,r,o),update:()=>{for(let s of[t,n])s.setAttribute("aria-disabled",String(!e.game.length));r.setAttribute(
"aria-disabled",String(!e.canStep)),o.setAttribute("aria-disabled",String(!e.canStep&&!e.running)),o.replaceChildren(wt(e.running?"pause":"play"),u("span",{},e.
running?"Stop":"Run"))}}}function Ss(e){let t={act:"Move",build:"Build"},n={act:"Choose agents and their moves (M)",build:"Place agents and draw obstacles (M)"},
r=Object.keys(t),o=r.map(s=>u("button",{type:"button",title:n[s],onclick:()=>e.mode=s},t[s]));return{element:u("div",{class:"buttons joined",role:"group","aria-\
label":"What the board does"},...o),update:()=>r.forEach((s,a)=>o[a].setAttribute("aria-pressed",String(e.mode===s)))}}function xs(e){let t=(s,a,i)=>u("button",
{type:"button",title:`Add ${a} (${i})`,"aria-label":`Add ${a}`,onclick:()=>He(e,s)},"+",vt(s)),n=u("button",{type:"button",title:"Remove the chosen agent (Delet\
e)",onclick:()=>St(e)},"Remove"),r=[t("pursuers","a pursuer","+"),t("evaders","an evader","-"),n],o=u("div",{class:"buttons",role:"group","aria-label":"Agents"},
...r);return{element:o,update:()=>{o.hidden=e.mode!=="build",n.setAttribute("aria-disabled",String(e.selected===null))}}}function As(e){let t=[8,7,4,1,0,3,2,5,6],
n=t.map(o=>u("button",{type:"button","aria-label":C[o],title:`The chosen agent: ${C[o]}`,onclick:()=>se(e,o)},bt[o])),r=u("div",{class:"buttons pad",role:"group",
"aria-label":"Move of the chosen agent"},...n);return{element:r,update:()=>{r.hidden=e.mode==="build";let o=e.selected===null?void 0:e.scene.next[e.selected];t.
forEach((s,a)=>{let i=n[a];i.hidden=s>4&&!e.scene.diagonal,i.setAttribute("aria-disabled",String(e.selected===null||e.game.over)),i.setAttribute("aria-pressed",
String(o===s))})}}}function _r(e){let t=u("button",{type:"button",title:"Undo the last change (Ctrl+Z)",onclick:()=>e.undo()},"Undo"),n=()=>t.setAttribute("aria\
-disabled",String(!e.canUndo));return e.addEventListener("change",n),n(),t}function He(e,t){let n=e.game.scene(),r=en(n);if(!r)return e.say("Every cell is taken\
.",!0);if(n[t].length>=Z)return e.say(`${t}: expected at most ${Z}`,!0);let o=t==="pursuers"?n.pursuers.length:A(n);e.change(Zt(n,t,r))&&(e.selected=o)}function St(e){
let{selected:t}=e;if(t===null)return e.say("Choose an agent to remove.",!0);let n=ke(e.game.scene(),t);n.pursuers.length&&n.evaders.length?e.change(n):e.say("A \
team needs at least one agent.",!0)}function kr(e,t){let n=Object.keys(e.data.variants),r={Enter:()=>e.step(),Backspace:()=>e.back(),Home:()=>e.restart()," ":()=>e.run(),m:()=>e.mode=e.mode==="act"?
"build":"act",l:t.share,d:ft,"?":t.keys},o={"+":()=>He(e,"pursuers"),"-":()=>He(e,"evaders"),Delete:()=>St(e)};document.addEventListener("keydown",s=>{if(s.defaultPrevented||
document.querySelector("dialog[open]"))return;let a=s.key.length===1?s.key.toLowerCase():s.key;if((s.ctrlKey||s.metaKey)&&!s.altKey){let c={z:()=>s.shiftKey?e.redo():
e.undo(),y:()=>e.redo()}[a];c&&!Rr(s.target)&&(s.preventDefault(),c());return}if(s.altKey||Cs(s.target,a))return;let i=n[Number(a)-1],l=r[a]??(e.mode==="build"?
o[a]:void 0);if(l)l();else if(i)e.change({...e.scene,rules:e.data.variants[i]});else if(e.mode!=="act"||!yt(e,s))return;s.preventDefault()})}var Rr=e=>e instanceof
HTMLInputElement&&!["radio","checkbox"].includes(e.type);function Cs(e,t){return Rr(e)||e instanceof HTMLSelectElement?!0:e instanceof HTMLInputElement?t===" "||
t.startsWith("Arrow"):e instanceof HTMLButtonElement?t===" "||t==="Enter":e instanceof HTMLElement&&e.classList.contains("story-body")&&t.startsWith("Arrow")}function Or(e){let t=u("ul",{class:"lines","aria-live":"polite"}),n=u("details",{class:"card perfect"},u("summary",{},u("h2",{},"Perfect play")),t,u("p",{class:"\
small muted"},"A team is one player here. An agent's shares are its part of the joint moves.")),r=0,o=(...a)=>t.replaceChildren(...a.filter(Boolean).map(i=>u("l\
i",{class:"line"},`${i}.`))),s=async()=>{let a=++r;if(!n.open)return;let i=Ee(te(e.scene,e.scene.rules));if(i)return o(`Not known: ${i}`);let l=await e.solution();
if(a!==r||!l)return;let{game:c,losses:d}=e.game.perfect(l),m=Array.from({length:A(e.scene)},(p,g)=>{let f=c&&ir(c,g);return f?`${k(e.scene,g)}: ${f}`:""}),h=e.game.
over?"The episode has ended":"Not known: no start on distinct free cells leads to this moment";o(...d.map(p=>`In the last step: ${sr(p)}`),c?`From here: ${ar(l,
c,e.game.length)}`:h,...m)};for(let[a,i]of[[e,"change"],[n,"toggle"]])a.addEventListener(i,()=>{s()});return n}function Lr(e){let t=[Ms(e),...e.data.fields.map(r=>Es(e,r)),_s(e),ks(e)],n=()=>t.forEach(r=>r.update());return e.addEventListener("change",n),e.player.addEventListener(
"step",n),n(),u("section",{class:"card rules"},...t.map(r=>r.element))}var ae=(e,t)=>{e.stop(),e.change(t)};function Ms(e){let t=Object.keys(e.data.variants),n=t.
map(o=>u("button",{type:"button",class:"chip",title:e.data.titles[o],onclick:()=>ae(e,{...e.scene,rules:e.data.variants[o]})},o)),r=u("p",{class:"muted small va\
riant-title"});return{element:u("div",{class:"variants"},u("h2",{},"Rules"),u("div",{class:"chips",role:"group","aria-label":"Variant"},...n),r),update:()=>{let o=ee(
e.scene.rules,e.data.variants);t.forEach((s,a)=>n[a].setAttribute("aria-pressed",String(s===o))),r.textContent=o?e.data.titles[o]:"Rules of your own"}}}function Es(e,t){
let n=t.values.map(({name:a})=>{let i=u("input",{type:"radio",name:t.name,value:a});return i.addEventListener("change",()=>ae(e,{...e.scene,rules:Ts(e.scene.rules,
t,a)})),i}),r=t.values.map(({label:a},i)=>u("label",{},n[i],u("span",{},a))),o=u("span",{class:"used-mark",title:"This rule decided what happened in the step th\
at is shown"},u("span",{},"decided")),s=u("fieldset",{class:"field",title:t.text},u("legend",{},t.label,o),u("div",{class:"segments"},...r));return{element:s,update:()=>{
let{rules:a}=e.scene;n.forEach(l=>l.checked=l.value===String(a[t.name])),s.disabled=t.name==="captured_disappear"&&a.capture==="OCCUPATION";let i=Math.min(e.player.
step,e.game.length);o.hidden=!De(e.scene,e.game,i).some(l=>l.used.includes(t.name))||s.disabled}}}function Ts(e,t,n){return{...e,[t.name]:n==="true"?!0:n==="fal\
se"?!1:n}}function _s(e){let t=Object.keys(e.data.variants),n=u("select",{id:"compare"},u("option",{value:""},"nothing"),u("option",{value:"present"},"the prese\
nt rules"),u("option",{value:"own",hidden:!0},"own rules"),...t.map(r=>u("option",{value:r},`${r}: ${e.data.titles[r]}`)));return n.addEventListener("change",()=>{
let r={"":null,present:e.scene.rules}[n.value];ae(e,{...e.scene,others:r===void 0?e.data.variants[n.value]:r})}),{element:u("div",{class:"pair"},u("label",{for:"\
compare"},"Compare with"),n),update:()=>{let{others:r}=e.scene,o=r&&t.find(s=>rt(r,e.data.variants[s]));n.value=r?o??"own":"",n.title=r?`Both boards play the sa\
me moves: ${$(e,0)} and ${$(e,1)}`:""}}}function ks(e){let t=(a,i)=>{let l=u("input",{type:"number",min:1,max:F,"aria-label":i});return l.addEventListener("chan\
ge",()=>{let c={rows:e.scene.rows,cols:e.scene.cols,[a]:Math.round(Number(l.value))};c[a]>=1&&c[a]<=F?Rs(e,c.rows,c.cols):e.say(`${a}: expected 1 to ${F}, got ${l.
value||"nothing"}`,!0),l.value=String(e.scene[a])}),l},[n,r]=[t("rows","Rows"),t("cols","Columns")],o=u("input",{type:"checkbox",id:"diagonal"});o.addEventListener(
"change",()=>ae(e,{...e.game.scene(),diagonal:o.checked,next:e.scene.next.map(a=>typeof a=="number"&&a>4?0:a)}));let s=u("select",{id:"rewards"},...Object.keys(
e.data.rewards).map(a=>u("option",{value:a},a)),u("option",{value:"own",hidden:!0},"those of the link"));return s.addEventListener("change",()=>ae(e,{...e.scene,
rewards:e.data.rewards[s.value]})),{element:u("div",{class:"board-settings"},u("div",{class:"pair"},u("span",{},"Board"),u("span",{class:"sides"},n,"×",r),u("l\
abel",{class:"sides"},o,"diagonal")),u("div",{class:"pair"},u("label",{for:"rewards"},"Rewards"),s)),update:()=>{let{scene:a}=e;document.activeElement!==n&&(n.value=
String(a.rows)),document.activeElement!==r&&(r.value=String(a.cols)),o.checked=a.diagonal;let i=JSON.stringify(a.rewards);s.value=Object.keys(e.data.rewards).find(
l=>JSON.stringify(e.data.rewards[l])===i)??"own"}}}function Rs(e,t,n){let r=Qt(e.game.scene(),t,n);r.pursuers.length&&r.evaders.length?ae(e,r):e.say(`No ${r.pursuers.
length?"evader":"pursuer"} would be left on a ${t} × ${n} board.`,!0)}var Nr={obstacle:"obstacle",teammate:"teammates",adversary:"adversaries",capture:"capture",end:"end",calm:""};function Ir(e){let t=u("h2"),n=u("div",{class:"sto\
ry-body",tabindex:0,role:"region","aria-label":"What happened"}),r=u("div",{class:"heard",role:"status"}),o=u("section",{class:"card story"},t,n,r),s="",a=()=>{
let i=Math.min(e.player.step,e.game.length),l=e.games.map((d,m)=>{let h=De(e.scene,d,i);return{name:e.games.length>1?$(e,m):"",lines:h,ended:i>d.length}}),c=JSON.
stringify([i,l]);c!==s&&(s=c,t.textContent=i?`Step ${i}`:"Start",n.replaceChildren(...l.map(d=>Os(d,i))),r.textContent=i?`Step ${i}. ${l.map(Ns).join(" ")}`:"")};
return e.addEventListener("change",a),e.player.addEventListener("step",a),a(),o}function Os({name:e,lines:t,ended:n},r){let s=n||!r?u("p",{class:"muted"},n?"The\
 episode had ended.":"Give agents their moves, then play a step."):u("ul",{class:"lines"},...t.map(Ls));return u("div",{class:"story-part"},e&&u("h3",{},e),s)}function Ls({
kind:e,text:t,turn:n,blame:r,cost:o}){let s=n?`${Nr[e]}, turn ${n}`:Nr[e];return u("li",{class:`line line-${e}`},s&&u("span",{class:"tag"},s),u("span",{class:"l\
ine-text"},...we(t)),r&&u("span",{class:"line-blame muted"},r),o&&u("strong",{},o))}var Ns=({name:e,lines:t,ended:n})=>[e,...n?["The episode had ended."]:t.map(
({text:r,blame:o,cost:s})=>[r,o,s].filter(Boolean).join(" "))].filter(Boolean).join(" ");function Pr(e,t){let n=Cr(t),r=Mr(),o=()=>r.showModal(),s=hr("Playground","Give agents their moves, predict what happens, and play the step.",_r(t),u("button",{
type:"button",title:"Link to this scene (L)",onclick:n.open},"Share"),u("button",{type:"button",title:"Keys (?)","aria-label":"Keys (?)",onclick:o},"?")),a=u("m\
ain",{class:"layout"},Lr(t),u("section",{class:"card stage","aria-label":"Board"},br(t),Tr(t)),u("div",{class:"side"},Ir(t),xr(t),Or(t)));e.classList.add("playg\
round"),e.replaceChildren(s,Er(t),a,n.element,r),kr(t,{share:n.open,keys:o})}async function Is(e){let t=mr(),{store:n,problem:r}=lr(await Yt(),t,ve()||t.scene);Pr(e,n),Te()&&dr(n),r&&n.say(r,!0),Object.assign(window,{playground:n})}var $r=document.
getElementById("page");Is($r).catch(e=>{throw $r.append(u("p",{class:"card problem",role:"alert"},`The playground could not start: ${e.message}`)),e}).finally(()=>{
document.body.dataset.ready="true"});})();
