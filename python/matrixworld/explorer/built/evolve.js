/* built from web/ by "npm run build"; sources 2a1fae05abaff1e2366678a422ba5c37c6f4bd927ab4e626582e6e45a0303b3d */
"use strict";(()=>{var fs={SIMULTANEOUS:0,SWARM_TURNS:1,AGENT_TURNS:2},ht={DISAPPEAR:0,REACH:1,BOUNCE:2},ys={OCCUPATION:0,SURROUND:1},gs={FAULT:0,INVOLVED:1};var tr=["obstacle","teammate","adversary"],nr=["vertex","edge","chain"],vs=["turn","kind","form","first","second","row","col","at_fault","held","doomed"],rr=["p\
ursuer_{number}","evader_{number}"],bs={obstacle:"{first} ran into the obstacle or border at {cell}",vertex:"{first} and {second} both headed for {cell}",edge:"\
{first} and {second} meant to swap, {first} to {cell}",chain:"{first} headed for {cell}, where {second} had to stay"},dt={"both held":"both bounce","both doomed":"\
both disappear",held:"{agent} bounces",doomed:"{agent} disappears",none:"nobody is stopped"},ws="{event}: {outcome}",sr={random:"any action, all equally likely",
still:"always stays",chaser:"moves to where the nearest adversary in view is nearest",fleer:"moves to where the nearest adversary in view is farthest","clumsy-c\
haser":"a chaser that takes any action in half of the steps",hunter:"a chaser of the nearest adversary in view to which no teammate in view is nearer",surrounder:"\
a chaser of the nearest free cell beside an adversary without a teammate","clumsy-fleer":"a fleer that takes any action in half of the steps",dodger:"moves to w\
here all adversaries in view together are farthest","team-surrounder":"shares the free cells beside adversaries with its teammates, and searches","careful-rando\
m":"as random, but takes only moves that right of way allows","careful-chaser":"as chaser, but takes only moves that right of way allows","careful-fleer":"as fl\
eer, but takes only moves that right of way allows","careful-clumsy-chaser":"as clumsy-chaser, but takes only moves that right of way allows","careful-hunter":"\
as hunter, but takes only moves that right of way allows","careful-surrounder":"as surrounder, but takes only moves that right of way allows","careful-clumsy-fl\
eer":"as clumsy-fleer, but takes only moves that right of way allows","careful-dodger":"as dodger, but takes only moves that right of way allows","careful-team-\
surrounder":"as team-surrounder, but takes only moves that right of way allows"},Pe={adversary:"distance to the nearest adversary (0 to 2, in half views)",pressure:"\
sum over adversaries of 1 / (1 + moves)^2 (0 or more)",unclaimed:"distance to the nearest adversary to which no teammate is nearer than the agent is now; withou\
t one, to the nearest adversary (0 to 2, in half views)",open_side:"distance to the nearest cell beside an adversary that holds no obstacle and no teammate (0 t\
o 2, in half views)",teammate:"distance to the nearest teammate (0 to 2, in half views)",exits:"share of the cells around that are no obstacle (0 to 1)",room:"d\
istance to the nearest obstacle to the north, east, south or west (0 to 1, in half views)",must_yield:"1 if right of way forbids the move (0 to 1)",ahead:"1 if \
it is the direction that the agent draws for each 12 steps (0 to 1)",search:"1 if it leads on along the way on which an agent of team-surrounder searches the gr\
id (0 to 1)"},xs={free:".GS",blocked:"#@OTW"};var He=1+vs.length;function mt(n,e){return n.replace(/\{(\w+)\}/g,(t,r)=>String(e[r]))}function se(n,e){return n<e?mt(rr[0],{number:n}):mt(rr[1],{number:n-e})}function Ui(n,e){
let[t,r,s,o,a,i,l,...c]=Array.from(n),u=a<0?[o]:[o,a],[h,m,p]=c.map(b=>u.filter((w,x)=>b>>x&1)),y=u.map(b=>se(b,e)),f=mt(bs[a<0?"obstacle":nr[s]],{first:y[0],second:y[y.
length-1],cell:`(${i}, ${l})`}),g=mt(ws,{event:f,outcome:Wi(u.length,m,p,e)});return{kind:tr[r],form:nr[s],agents:u,cell:[i,l],at_fault:h,held:m,doomed:p,turn:t,
text:g}}function Wi(n,e,t,r){if(n===2&&e.length===2)return dt["both held"];if(n===2&&t.length===2)return dt["both doomed"];let s=o=>a=>mt(dt[o],{agent:se(a,r)});
return[...e.map(s("held")),...t.map(s("doomed"))].join(", ")||dt.none}function Gt(n,e){let t=[];for(let r=0;r<n.length;r+=He)t.push(Ui(n.subarray(r+1,r+He),e));
return t}var Me=class extends Error{name="EngineError"};function D(n,e,t){let r=typeof t=="string"?`'${t}'`:typeof t=="object"?JSON.stringify(t):String(t);return new Me(
`${n}: expected ${e}, got ${r}`)}var Ve=class{bytes;constructor(e){this.bytes=e}},Ms=0,ar=[Uint8Array,Uint8Array,Int32Array,BigInt64Array,BigUint64Array,Float32Array,Float64Array],Ss=4,As=4,Bi=new TextEncoder,
ji=new TextDecoder;function Gi(n){for(let e=ar.length-1;e>Ms;--e)if(n instanceof ar[e])return e;throw new TypeError("array: expected a typed array of the engine\
's numbers, got another")}function or(n){return new Uint8Array(n.buffer,n.byteOffset,n.byteLength)}function zi(n){return Bi.encode(`${n}\0`)}var ir=class{engine;addresses=[];constructor(e){
this.engine=e}copy(e){let t=this.engine._malloc(Math.max(e.length,1));if(t===0)throw new Me("memory: expected room for the arguments, got none");return this.addresses.
push(t),this.engine.HEAPU8.set(e,t),t}text(e){return this.copy(zi(e))}arrays(e){let t=Object.entries(e),r=t.flatMap(([o,a])=>{let i=a instanceof Ve,l=i?a.bytes:
a;return[this.text(o),i?Ms:Gi(l),l.length,this.copy(or(l))]}),s=this.copy(or(Int32Array.from(r)));return this.copy(or(Int32Array.of(t.length,s)))}free(){for(let e of this.
addresses)this.engine._free(e)}};function Ts(n,e){let t=n.HEAPU8;return ji.decode(t.subarray(e,t.indexOf(0,e)))}function Ke(n){let e=new Int32Array(n.HEAPU8.buffer),
t=n._last_outputs()/Ss,r=e[t+1]/Ss,s={};for(let o=r;o<r+e[t]*As;o+=As){let a=ar[e[o+1]],i=e[o+2]*a.BYTES_PER_ELEMENT,l=e[o+3];s[Ts(n,e[o])]=new a(n.HEAPU8.slice(
l,l+i).buffer)}return s}function Te(n,e){let t=new ir(n);try{let r=e(t);if(r===0)throw new Me(Ts(n,n._last_error()));return r}finally{t.free()}}var Hi=2**31-1,Es=["none","gru"],Vi=2n**64n-1n,Ki=34028234663852886e22;function le(n,e){if(typeof e!="number"||!Number.isInteger(e)||Math.abs(e)>Hi)throw D(n,"a\
n integer",e);return Int32Array.of(e)}function zt(n,e){if(typeof e!="boolean")throw D(n,"true or false",e);return new Ve(Uint8Array.of(Number(e)))}function Ne(n,e,t){
let r=typeof e=="string"&&Object.hasOwn(t,e)?t[e]:void 0;if(r===void 0)throw D(n,`one of ${Object.keys(t).join(", ")}`,e);return Int32Array.of(r)}function lr(n,e){
if(typeof e!="number"||!(Math.abs(e)<=Ki))throw D(n,"a finite number",e);return e}function pt(n,e){let r=typeof e=="bigint"||typeof e=="number"&&Number.isSafeInteger(
e)?BigInt(e):-1n;if(r<0n||r>Vi)throw D(n,"an integer from 0 to 2^64 - 1",e);return BigUint64Array.of(r)}function Yi(n){return{"rules.interaction":Ne("interactio\
n",n.interaction,fs),"rules.obstacle":Ne("obstacle",n.obstacle,ht),"rules.teammate":Ne("teammate",n.teammate,ht),"rules.evader":Ne("evader",n.evader,ht),"rules.\
pursuer":Ne("pursuer",n.pursuer,ht),"rules.capture":Ne("capture",n.capture,ys),"rules.captured_disappear":zt("captured_disappear",n.captured_disappear)}}function Os(n,e){
let t=typeof e=="number"?[e,e,e]:e;if(!Array.isArray(t)||t.length!==3)throw D(n,"1 or 3 numbers",e);return Float32Array.from(t,r=>lr(n,r))}function qi(n){let e=(t,r)=>Float32Array.
of(lr(t,n[t]),lr(r,n[r]));return{"rewards.capture":e("pursuer_capture","evader_capture"),"rewards.neighbor":e("pursuer_neighbor","evader_neighbor"),"rewards.ste\
p":e("pursuer_step","evader_step"),"rewards.pursuer_collide":Os("pursuer_collide",n.pursuer_collide),"rewards.evader_collide":Os("evader_collide",n.evader_collide),
"rewards.blame":Ne("blame",n.blame,gs),"rewards.capture_repeats":zt("capture_repeats",n.capture_repeats)}}function ks(n){if(n===void 0||typeof n=="number")return new Uint8Array(
0);if(n instanceof Uint8Array)return n;let{free:e,blocked:t}=xs;for(let[r,s]of n.entries()){if(s.length!==n[0]?.length)throw D(`map, row ${r}`,`${n[0]?.length} \
cells as in row 0`,s.length);let o=[...s].find(a=>!e.includes(a)&&!t.includes(a));if(o)throw D(`map, row ${r}`,`'${e}' (free) or '${t}' (obstacle)`,o)}return Uint8Array.
from([...n.join("")],r=>Number(t.includes(r)))}function _s(n,e){if(!Array.isArray(n))return;let t=[n.length,n[0]?.length??0];if(!(t[0]===e.rows&&t[1]===e.cols))
throw D("obstacle map",`shape (${e.rows}, ${e.cols}), the rows and cols`,t)}function Ye(n){_s(n.obstacles,n);let e=typeof n.obstacles=="number"?n.obstacles:0;return{
...Yi(n.rules),...qi(n.rewards),rows:le("rows",n.rows),cols:le("cols",n.cols),n_pursuers:le("n_pursuers",n.n_pursuers),n_evaders:le("n_evaders",n.n_evaders),fov:le(
"fov",n.fov),diagonal:zt("diagonal",n.diagonal),max_steps:le("max_steps",n.max_steps),density:Float64Array.of(e),map:ks(n.obstacles)}}function Cs(n,e){return Int32Array.
from((e??[]).flat(),t=>le(n,t)[0])}function $s(n,e){return _s(n.obstacles,e),{seed:pt("seed",n.seed??0n),episode:pt("episode",n.episode??0),pursuers:Cs("pursuer\
s",n.pursuers),evaders:Cs("evaders",n.evaders),map:ks(n.obstacles)}}function Ht(n){return{actions:Int32Array.from(n,e=>le("actions",e)[0])}}var Rs=Object.keys(Pe);
function cr(n){let e=Rs.indexOf(n);if(e<0)throw D("inputs",`names of ${Rs.join(", ")}`,n);return e}function Le(n){if(typeof n=="string"){if(!Object.hasOwn(sr,n))
throw D("policy",`one of ${Object.keys(sr).join(", ")}`,n);return{script:new TextEncoder().encode(n)}}if(n.kind!=="cells")return{inputs:Int32Array.from(n.inputs,
e=>cr(e)),hidden:Int32Array.from(n.kind==="rating"?n.hidden:[],e=>le("hidden",e)[0]),length:le("length",n.kind==="program"?n.length:0),mask:new TextEncoder().encode(
n.mask),genome:n.genome};if(n.activation!=="relu"&&n.activation!=="tanh")throw D("activation","'relu' or 'tanh'",n.activation);if(!Es.includes(n.memory))throw D(
"memory",`one of ${Es.join(", ")}`,n.memory);return{hidden:Int32Array.from(n.hidden,e=>le("hidden",e)[0]),activation:new TextEncoder().encode(n.activation),sampled:zt(
"sampled",n.sampled),memory:new TextEncoder().encode(n.memory),genome:n.genome}}var Ji=["first_turn","terminated","truncated"];function Ps(n){let e={...n};for(let t of Ji)
e[t]=new Ve(n[t]);return e}var Ns="statistics.",Vt=class{config;seed;episode;n_agents;statistics;first_conflict;constructor(e,t,r,s){this.config=e,this.seed=t,this.episode=r,this.n_agents=
e.n_pursuers+e.n_evaders,this.statistics=Xi(Ls(s)),Object.assign(this,s),this.first_conflict=Zi(this.conflict_table,this.length)}get length(){return this.actions.
length/this.n_agents}conflicts(e){this.check(e);let t=this.first_conflict[e],r=this.first_conflict[e+1],s=this.conflict_table.subarray(t*He,r*He);return Gt(s,this.
config.n_pursuers)}seek(e,t,r){this.check(t),(!(e.seed===this.seed&&e.episode===BigInt(this.episode))||e.turn!==0||e.steps>t)&&e.reset({seed:this.seed,episode:this.
episode});for(let o=e.steps;o<t;++o){let a=this.actions.subarray(o*this.n_agents,(o+1)*this.n_agents);r?e.replay(a,{pursuer:r.pursuers,evader:r.evaders}):e.step(
a)}}check(e){if(!(Number.isInteger(e)&&e>=0&&e<=this.length))throw D("step",`0 to ${this.length}`,e)}};function Zi(n,e){let t=new Int32Array(e+2);for(let r=0;r<
n.length;r+=He)++t[n[r]+1];for(let r=1;r<t.length;++r)t[r]+=t[r-1];return t}function Xi(n){let e=["capture_rate","ever_capture_rate","captured_fraction","length"];
return Object.fromEntries(Object.entries(n).map(([t,r])=>[t,e.includes(t)?Number(r[0]):r]))}var Ls=n=>Object.fromEntries(Object.entries(n).flatMap(([e,t])=>e.startsWith(
Ns)?[[e.slice(Ns.length),t]]:[]));function Is(n,e,t,r){let s=[Ye(t.config),Le(t.pursuers),Le(t.evaders),r];return Te(n,o=>{let[a,i,l,c]=s.map(u=>o.arrays(u));return n[e](
a,i,l,c)}),Ke(n)}function Fs(n,e,t,r){let s={seed:pt("seed",t),episode:pt("episode",r)};return new Vt(e.config,t,r,Is(n,"_play_match",e,s))}function Ds(n,e,t,r){
if(!Number.isInteger(r)||r<1)throw D("n_episodes","at least 1",r);let s=Is(n,"_play_rollout",e,{...t,n_episodes:Int32Array.of(r)});return Ls(s)}var Qi=7e6,el=new FinalizationRegistry(([n,e])=>n._states_free(e));function tl({rules:n,rows:e,cols:t,obstacles:r,diagonal:s,n_pursuers:o,n_evaders:a}){let i=typeof r==
"number"||n.obstacle==="REACH"?0:r.join("").split("#").length-1,l=e*t-i,c=[n.obstacle,n.teammate,n.pursuer].includes("DISAPPEAR"),u=n.capture==="SURROUND"||n.evader===
"REACH",h=n.interaction==="AGENT_TURNS",m=(f,g)=>Array.from({length:g},(b,w)=>h?f:(f+w)/(w+1)).reduce((b,w)=>b*w,1),p=m(l+Number(c),o)*m(l*(1+Number(u))+2,a);return{
SIMULTANEOUS:[o+a],SWARM_TURNS:[o,a],AGENT_TURNS:Array(o+a).fill(1)}[n.interaction].reduce((f,g)=>f+p*(s?9:5)**g,0)}function Kt(n){return typeof n.obstacles=="n\
umber"&&n.obstacles>0?"obstacles are drawn anew in each episode":tl(n)>Qi?"the world is too large to be solved on the page":""}var ur=class{value;teams;matrix;n_actions;constructor(e,t){
let{matrix:r,rows:s,cols:o,value:a,agents:i}=t,[l,c]=e.actors,u=Array.from(i).filter(m=>l<=m&&m<c),h=m=>m<e.config.n_pursuers;this.value=a[0],this.matrix=r,this.
n_actions=e.n_actions,this.teams=[{agents:u.filter(h),play:s},{agents:u.filter(m=>!h(m)),play:o}]}marginal(e){let t=this.teams.find(({agents:o})=>o.includes(e));
if(!t)return null;let r=this.n_actions**(t.agents.length-1-t.agents.indexOf(e)),s=Array(this.n_actions).fill(0);return t.play.forEach((o,a)=>s[Math.floor(a/r)%this.
n_actions]+=o),s}lost(e){let[t,r]=this.teams.map(({agents:l})=>l.reduce((c,u)=>c*this.n_actions+e[u],0)),[s,o]=this.teams.map(({play:l})=>l),a=o.reduce((l,c,u)=>l+
c*this.matrix[t*o.length+u],0),i=s.reduce((l,c,u)=>l+c*this.matrix[u*o.length+r],0);return[Math.max(0,this.value-a),Math.max(0,i-this.value)]}},hr=60,ft=class{config;payoff;engine;states;n_turns;values;constructor(e,t,r){
this.engine=e,this.config=t,this.payoff=r,this.states=Te(e,i=>e._states_new(i.arrays(Ye(t)))),el.register(this,[e,this.states]);let s={SIMULTANEOUS:1,SWARM_TURNS:2,
AGENT_TURNS:t.n_pursuers+t.n_evaders};this.n_turns=s[t.rules.interaction];let{payoffs:o}=this.call(()=>e._states_payoffs(this.states)),a=o;this.values=[[r==="ca\
pture-rate"?a:a.fill(0)]]}goBack(){let e=this.values.at(-1)[0],t=[];for(let s=this.n_turns-1;s>=0;s--){let o=t[s+1]??e;t[s]=this.backup(s,{next:o})}this.payoff===
"capture-time"&&(t[0]=t[0].map((s,o)=>o===this.config.n_evaders?0:s-1)),this.values.push(t);let r=this.payoff==="capture-rate"?this.config.max_steps:Math.min(this.
config.max_steps,hr);return this.values.length<=r&&t[0].some((s,o)=>s!==e[o])}backup(e,t){return this.call(r=>this.engine._states_backup(this.states,e,r.arrays(
t))).values}game(e){let t=this.config.max_steps-e.steps,{turn:r}=e,s=r+1===this.n_turns,o=t>0?this.values[Math.min(t-Number(s),this.values.length-1)]?.[s?0:r+1]:
void 0;if(!o)return null;let a=this.call(i=>this.engine._states_game(this.states,e.address,i.arrays({next:o})));return a.agents.length?new ur(e,a):null}call(e){
return Te(this.engine,e),Ke(this.engine)}};var Us=new FinalizationRegistry(([n,e])=>n._world_free(e)),yt=class{config;n_agents;n_actions;engine;at;freed=!1;constructor(e,t){this.engine=e,this.config=t,this.
n_agents=t.n_pursuers+t.n_evaders,this.n_actions=t.diagonal?9:5,this.at=Te(e,r=>e._world_new(r.arrays(Ye(t)))),Us.register(this,[e,this.at],this)}free(){this.freed||
(this.freed=!0,Us.unregister(this),this.engine._world_free(this.at))}get address(){if(this.freed)throw D("world","one that is in use","one that was freed");return this.
at}reset(e={}){let t=$s(e,this.config);this.call(r=>this.engine._world_reset(this.address,r.arrays(t)))}step(e){let t=Ht(e);this.call(r=>this.engine._world_step(
this.address,r.arrays(t)))}playTurn(e){let t=Ht(e);this.call(r=>this.engine._world_play_turn(this.address,r.arrays(t)))}decide(e,t,r){let{n_pursuers:s}=this.config,
o={pursuer:[0,s],evader:[s,this.n_agents]},[a,i]=typeof t=="string"?o[t]:t;if(r.length!==this.n_agents)throw D("actions",String(this.n_agents),r.length);let l=[
Le(e),Ht(r)],{actions:c}=this.call(u=>this.engine._world_decide(this.address,u.arrays(l[0]),a,i,u.arrays(l[1])));return Uint8Array.from(c)}replay(e,t){let r=o=>typeof o!=
"string"&&o.kind==="cells"&&o.memory!=="none";if(!r(t.pursuer)&&!r(t.evader))return this.step(e);let{n_pursuers:s}=this.config;for(let o=this.n_turns;o>0;--o){let[
a,i]=this.actors;a<s&&this.decide(t.pursuer,[a,Math.min(i,s)],e),i>s&&this.decide(t.evader,[Math.max(a,s),i],e),this.playTurn(e)}}get n_turns(){return this.turnNumbers()[1]}get turn(){
return this.turnNumbers()[0]}get actors(){let[,,e,t]=this.turnNumbers();return[e,t]}turnNumbers(){return this.call(()=>this.engine._world_turn(this.address)).turn}get steps(){
return this.read("steps")[0]}get seed(){return this.read("seed")[0]}get episode(){return this.read("episode")[0]}get over(){return this.read("terminated")[0]===
1||this.read("truncated")[0]===1}read(e){return this.call(t=>this.engine._world_read(this.address,t.text(e)))[e]}view(e){let t=3*this.config.fov**2;return this.
read("views").slice(e*t,(e+1)*t)}map(){return this.read("state").slice(2*this.config.rows*this.config.cols)}conflicts(){return Gt(this.conflictTable(),this.config.
n_pursuers)}conflictTable(){return this.call(()=>this.engine._world_conflicts(this.address)).conflict_table}answer(e,t){let r=Le(e),{logits:s,memory:o}=this.call(
l=>this.engine._world_logits(this.address,l.arrays(r),t)),a=s,i=this.decide(e,[t,t+1],new Uint8Array(this.n_agents))[t];return{logits:a,probabilities:nl(a),action:i,
memory:o}}rate(e,t){let r=Le(e),{ratings:s,refused:o}=this.call(c=>this.engine._world_rate(this.address,c.arrays(r),t)),a=this.read("inputs"),i=a.length/this.n_agents/
this.n_actions,l=c=>Float32Array.from({length:this.n_actions},(u,h)=>a[(t*this.n_actions+h)*i+c]);return{inputs:e.inputs.map(c=>l(cr(c))),ratings:s,refused:o}}snapshot(){
return this.call(()=>this.engine._world_snapshot(this.address))}restore(e){let t=Ps(e);this.call(r=>this.engine._world_restore(this.address,r.arrays(t)))}call(e){
return Te(this.engine,e),Ke(this.engine)}};function nl(n){let e=Math.max(...n),t=Array.from(n,s=>Math.exp(s-e)),r=t.reduce((s,o)=>s+o,0);return Float32Array.from(
t,s=>s/r)}var dr=class{compiled;constructor(e){this.compiled=e}world(e){return new yt(this.compiled,e)}solution(e,t="capture-rate"){return new ft(this.compiled,e,t)}match(e,t,r,s,o=0){
return Fs(this.compiled,{config:e,pursuers:t,evaders:r},s,o)}rollouts(e,t,r,s,o){return Ds(this.compiled,{config:e,pursuers:t,evaders:r},s,o)}},Ws;function Yt(n=globalThis.
matrixworldEngine){return Ws??=rl(n),Ws}async function rl(n){if(!n)throw new Error("matrixworldEngine: expected the script engine.js before this one, got none");
let e=Uint8Array.from(atob(n.binary),t=>t.charCodeAt(0));return new dr(await n({wasmBinary:e}))}var sl="http://www.w3.org/2000/svg";function d(n,e={},...t){return Bs(document.createElement(n),e,t)}function S(n,e={},...t){return Bs(document.createElementNS(
sl,n),e,t)}function Bs(n,e,t){for(let[s,o]of Object.entries(e))o==null||o===!1||(typeof o=="function"?n.addEventListener(s.slice(2),o):n.setAttribute(s,o===!0?"":
String(o)));let r=t.filter(s=>s!=null&&s!==!1);return n.append(...r.map(s=>typeof s=="number"?String(s):s)),n}function ee(n,e){let t=d("select",{onchange:()=>e(
t.value)},...n.map(([r,s])=>d("option",{value:r},s)));return t}async function js(n){try{await n}catch(e){let t=document.querySelector("#page, main")??document.body;
throw t.querySelector(".absent")?.remove(),t.prepend(d("p",{class:"card problem",role:"alert"},e instanceof WebAssembly.CompileError||/WebAssembly/.test(String(
e))?"This page plays by WebAssembly, which is forbidden where it lies ('wasm-unsafe-eval' is missing in the content policy): save the file, and open it from you\
r disk.":`The page could not start: ${String(e)}`)),e}finally{document.body.dataset.ready="true"}}var de=()=>["file:","http:","https:"].includes(location.protocol);var qt=n=>d("input",{type:"text",readonly:!0,"aria-label":n});function Jt(n,e){n.value=e,n.hidden=!1,n.select(),navigator.clipboard?.writeText(e).catch(()=>{})}
function qe(n,e){let t=URL.createObjectURL(new Blob([e],{type:"application/octet-stream"}));d("a",{href:t,download:n}).click(),setTimeout(()=>URL.revokeObjectURL(
t),6e4)}var Gs=()=>document.documentElement.dataset.theme==="dark";function gt(n){document.documentElement.dataset.theme=n?"dark":"light"}var mr=()=>gt(!Gs());if(typeof document<
"u"){let n=matchMedia("(prefers-color-scheme: dark)");n.addEventListener("change",()=>gt(n.matches)),gt(n.matches);let e=!1;addEventListener("beforeprint",()=>{
e=Gs(),gt(!1)}),addEventListener("afterprint",()=>gt(e))}function zs(){return d("button",{type:"button",title:"Light or dark (D)","aria-label":"Light or dark",onclick:mr},
"◐")}var Hs=(n,e,...t)=>d("header",{class:"top"},d("div",{},d("h1",{},n),e?d("p",{class:"lead"},e):null),d("div",{class:"tools"},...t,zs()));var ol=Array.from({length:16},(n,e)=>{let t=e%2?6.5:11,r=Math.PI*e/8;return`${12+t*Math.sin(r)} ${12-t*Math.cos(r)}`}).join(" ");function Zt(){let n=[["pursuer",
S("path",{d:"M12 3 22 20H2z",class:"filled-pursuer"})],["evader",S("circle",{cx:12,cy:12,r:9,class:"filled-evader"})],["capture",S("polygon",{points:ol,class:"f\
illed-capture"})],["captured evader",S("circle",{cx:12,cy:12,r:7.5,class:"ring-evader"})],["conflict",S("rect",{x:3,y:3,width:18,height:18,class:"dashed-conflic\
t"})]];return d("ul",{class:"shapes small","aria-label":"Shapes on the board"},...n.map(([e,t])=>d("li",{},S("svg",{viewBox:"0 0 24 24","aria-hidden":"true"},t),
e)))}var te=["stay","north","east","south","west","northeast","southeast","southwest","northwest"];var Vs="champion",Ks=0,pr=64,fr=100;var al=(n,e)=>Object.keys(n).every(t=>n[t]===e[t]);function Ys(n,e){return Object.keys(e).find(t=>al(e[t],n))??null}function qs(n,e,t){let r=new Set(n);return Array.
from({length:e},(s,o)=>Array.from({length:t},(a,i)=>r.has(o*t+i)?"#":".").join(""))}function Xt(n,e,t){let r=n.filter(s=>s!==e);return t?[...r,e].sort((s,o)=>s-
o):r}var A=["pursuer","evader"],ce=n=>n==="pursuer"?"evader":"pursuer";function yr(n,e,t){let{rows:r,cols:s,n_pursuers:o,fov:a,rules:{interaction:i}}=n;return{rows:r,cols:s,nPursuers:o,fov:a,interaction:i,obstacles:e,moments:t}}function gr(n,e){
return{positions:n.read("last_positions"),alive:n.read("alive"),captured:n.read("captured"),everCaptured:n.read("ever_captured"),actions:e,involved:n.read("invo\
lved"),fault:n.read("fault"),contested:n.conflicts().map(t=>t.cell)}}function Qt(n){let e=Array.from({length:n.length+1},(t,r)=>il(n,r));return yr(n.config,n.map,
e)}function il(n,e){let t=n.n_agents,r=n.config.n_evaders,s=(a,i,l)=>a.subarray(i*l,(i+1)*l),o={positions:s(n.last_positions,e,2*t),alive:s(n.alive,e,t),captured:s(
n.captured,e,r),everCaptured:s(n.ever_captured,e,r)};return e===0?o:{...o,actions:s(n.actions,e-1,t),involved:s(n.involved,e-1,3*t),fault:s(n.fault,e-1,3*t),get contested(){
return n.conflicts(e).map(a=>a.cell)}}}var vt=class{config;start;recording;actions=[];#e;#n;#t=[[]];constructor(e,t,r){this.config=t,this.start=r,this.#e=e.world(t),this.#e.reset(r),this.#n=[gr(this.#e)],
this.recording=yr(t,this.#e.map(),this.#n)}get length(){return this.actions.length}get over(){return this.#e.over}get statistics(){return{capture_rate:this.#e.read(
"capture_rate")[0]}}conflicts(e){return this.#t[e]}game(e){return e.game(this.#e)}play(e){this.#e.step(e),this.#r(e)}step(e,t,r){let s=this.#e,o=this.config.n_pursuers,
a=new Uint8Array(s.n_agents);for(let i=s.n_turns;i>0&&!s.over;--i){let[l,c]=s.actors;l<o&&(a=s.decide(e.pursuer,[l,Math.min(c,o)],a)),c>o&&(a=s.decide(e.evader,
[Math.max(l,o),c],a)),typeof r=="number"?a[t]=r:l<=t&&t<c&&(a=s.decide(r,[t,t+1],a)),s.playTurn(a)}this.#r(a)}#r(e){this.actions.push(e),this.#n.push(gr(this.#e,
e)),this.#t.push(this.#e.conflicts())}};var me=(n,e)=>A[+(e>=n.n_pursuers)];function bt(n,e){let t=new vt(n,e.config,{seed:e.seed,episode:e.episode});for(let r of e.moves)t.over||t.step(e.policies,e.seat,
r);return t}function ve(n,e){let{moments:t,nPursuers:r}=n.recording,s=t.findIndex(({alive:a,captured:i})=>!a[e]||!!i[e-r]),o=s<0?n.length:s;return{lasted:o,out:s>=
0,captured:Array.from(t[o].everCaptured).filter(Boolean).length}}var en=(n,e)=>n.over||ve(n,e).out;function Js(n,e,t){let r=bt(n,{...e,moves:e.moves.slice(0,e.from)});
for(;!en(r,e.seat);)r.step(e.policies,e.seat,t);return ve(r,e.seat)}function Zs(n){let e=n.length-1;return[...new Set([0,Math.round(e/3),e])].map(t=>n[t])}var ll=()=>crypto.getRandomValues(new BigUint64Array(1))[0],cl=8;function vr(n,e,t){let{n_pursuers:r,n_evaders:s}=e,o=Array.from({length:r+s},(l,c)=>c).filter(l=>me(
e,l)!==me(e,t)),a=l=>{let c=new vt(n,e,{seed:l}).recording.moments[0].positions,u=(h,m)=>Math.abs(c[2*t+h]-c[2*m+h]);return Math.min(...o.map(h=>u(0,h)+u(1,h)))};
return Array.from({length:cl},ll).map(l=>[l,a(l)]).reduce((l,c)=>c[1]>l[1]?c:l)[0]}var I=Uint8Array,ne=Uint16Array,Or=Int32Array,tn=new I([0,0,0,0,0,0,0,0,1,1,1,1,2,2,2,2,3,3,3,3,4,4,4,4,5,5,5,5,0,0,0,0]),nn=new I([0,0,0,0,1,1,2,2,3,3,4,4,5,5,
6,6,7,7,8,8,9,9,10,10,11,11,12,12,13,13,0,0]),Sr=new I([16,17,18,0,8,7,9,6,10,5,11,4,12,3,13,2,14,1,15]),ro=function(n,e){for(var t=new ne(31),r=0;r<31;++r)t[r]=
e+=1<<n[r-1];for(var s=new Or(t[30]),r=1;r<30;++r)for(var o=t[r];o<t[r+1];++o)s[o]=o-t[r]<<5|r;return{b:t,r:s}},so=ro(tn,2),oo=so.b,Ar=so.r;oo[28]=258,Ar[258]=28;
var ao=ro(nn,0),ul=ao.b,Xs=ao.r,Mr=new ne(32768);for(C=0;C<32768;++C)be=(C&43690)>>1|(C&21845)<<1,be=(be&52428)>>2|(be&13107)<<2,be=(be&61680)>>4|(be&3855)<<4,Mr[C]=
((be&65280)>>8|(be&255)<<8)>>1;var be,C,pe=(function(n,e,t){for(var r=n.length,s=0,o=new ne(e);s<r;++s)n[s]&&++o[n[s]-1];var a=new ne(e);for(s=1;s<e;++s)a[s]=a[s-
1]+o[s-1]<<1;var i;if(t){i=new ne(1<<e);var l=15-e;for(s=0;s<r;++s)if(n[s])for(var c=s<<4|n[s],u=e-n[s],h=a[n[s]-1]++<<u,m=h|(1<<u)-1;h<=m;++h)i[Mr[h]>>l]=c}else
for(i=new ne(r),s=0;s<r;++s)n[s]&&(i[s]=Mr[a[n[s]-1]++]>>15-n[s]);return i}),Ee=new I(288);for(C=0;C<144;++C)Ee[C]=8;var C;for(C=144;C<256;++C)Ee[C]=9;var C;for(C=
256;C<280;++C)Ee[C]=7;var C;for(C=280;C<288;++C)Ee[C]=8;var C,St=new I(32);for(C=0;C<32;++C)St[C]=5;var C,hl=pe(Ee,9,0),dl=pe(Ee,9,1),ml=pe(St,5,0),pl=pe(St,5,1),
br=function(n){for(var e=n[0],t=1;t<n.length;++t)n[t]>e&&(e=n[t]);return e},ue=function(n,e,t){var r=e/8|0;return(n[r]|n[r+1]<<8)>>(e&7)&t},wr=function(n,e){var t=e/
8|0;return(n[t]|n[t+1]<<8|n[t+2]<<16)>>(e&7)},Cr=function(n){return(n+7)/8|0},Rr=function(n,e,t){return(e==null||e<0)&&(e=0),(t==null||t>n.length)&&(t=n.length),
new I(n.subarray(e,t))};var fl=["unexpected EOF","invalid block type","invalid length/literal","invalid distance","stream finished","no stream handler",,"no callback","invalid UTF-8 da\
ta","extra field too long","date not in range 1980-2099","filename too long","stream finishing","invalid zip data"],q=function(n,e,t){var r=new Error(e||fl[n]);
if(r.code=n,Error.captureStackTrace&&Error.captureStackTrace(r,q),!t)throw r;return r},yl=function(n,e,t,r){var s=n.length,o=r?r.length:0;if(!s||e.f&&!e.l)return t||
new I(0);var a=!t,i=a||e.i!=2,l=e.i;a&&(t=new I(s*3));var c=function(ct){var ut=t.length;if(ct>ut){var ze=new I(Math.max(ut*2,ct));ze.set(t),t=ze}},u=e.f||0,h=e.
p||0,m=e.b||0,p=e.l,y=e.d,f=e.m,g=e.n,b=s*8;do{if(!p){u=ue(n,h,1);var w=ue(n,h+1,3);if(h+=3,w)if(w==1)p=dl,y=pl,f=9,g=5;else if(w==2){var R=ue(n,h,31)+257,k=ue(
n,h+10,15)+4,O=R+ue(n,h+5,31)+1;h+=14;for(var M=new I(O),U=new I(19),F=0;F<k;++F)U[Sr[F]]=ue(n,h+F*3,7);h+=k*3;for(var P=br(U),Ae=(1<<P)-1,Z=pe(U,P,1),F=0;F<O;){
var K=Z[ue(n,h,Ae)];h+=K&15;var x=K>>4;if(x<16)M[F++]=x;else{var W=0,N=0;for(x==16?(N=3+ue(n,h,3),h+=2,W=M[F-1]):x==17?(N=3+ue(n,h,7),h+=3):x==18&&(N=11+ue(n,h,
127),h+=7);N--;)M[F++]=W}}var Y=M.subarray(0,R),B=M.subarray(R);f=br(Y),g=br(B),p=pe(Y,f,1),y=pe(B,g,1)}else q(1);else{var x=Cr(h)+4,v=n[x-4]|n[x-3]<<8,E=x+v;if(E>
s){l&&q(0);break}i&&c(m+v),t.set(n.subarray(x,E),m),e.b=m+=v,e.p=h=E*8,e.f=u;continue}if(h>b){l&&q(0);break}}i&&c(m+131072);for(var lt=(1<<f)-1,re=(1<<g)-1,ge=h;;ge=
h){var W=p[wr(n,h)&lt],X=W>>4;if(h+=W&15,h>b){l&&q(0);break}if(W||q(2),X<256)t[m++]=X;else if(X==256){ge=h,p=null;break}else{var Q=X-254;if(X>264){var F=X-257,L=tn[F];
Q=ue(n,h,(1<<L)-1)+oo[F],h+=L}var he=y[wr(n,h)&re],je=he>>4;he||q(3),h+=he&15;var B=ul[je];if(je>3){var L=nn[je];B+=wr(n,h)&(1<<L)-1,h+=L}if(h>b){l&&q(0);break}
i&&c(m+131072);var Ge=m+Q;if(m<B){var Bt=o-B,jt=Math.min(B,Ge);for(Bt+m<0&&q(3);m<jt;++m)t[m]=r[Bt+m]}for(;m<Ge;++m)t[m]=t[m-B]}}e.l=p,e.p=ge,e.b=m,e.f=u,p&&(u=
1,e.m=f,e.d=y,e.n=g)}while(!u);return m!=t.length&&a?Rr(t,0,m):t.subarray(0,m)},we=function(n,e,t){t<<=e&7;var r=e/8|0;n[r]|=t,n[r+1]|=t>>8},wt=function(n,e,t){
t<<=e&7;var r=e/8|0;n[r]|=t,n[r+1]|=t>>8,n[r+2]|=t>>16},xr=function(n,e){for(var t=[],r=0;r<n.length;++r)n[r]&&t.push({s:r,f:n[r]});var s=t.length,o=t.slice();if(!s)
return{t:lo,l:0};if(s==1){var a=new I(t[0].s+1);return a[t[0].s]=1,{t:a,l:1}}t.sort(function(E,R){return E.f-R.f}),t.push({s:-1,f:25001});var i=t[0],l=t[1],c=0,
u=1,h=2;for(t[0]={s:-1,f:i.f+l.f,l:i,r:l};u!=s-1;)i=t[t[c].f<t[h].f?c++:h++],l=t[c!=u&&t[c].f<t[h].f?c++:h++],t[u++]={s:-1,f:i.f+l.f,l:i,r:l};for(var m=o[0].s,r=1;r<
s;++r)o[r].s>m&&(m=o[r].s);var p=new ne(m+1),y=Tr(t[u-1],p,0);if(y>e){var r=0,f=0,g=y-e,b=1<<g;for(o.sort(function(R,k){return p[k.s]-p[R.s]||R.f-k.f});r<s;++r){
var w=o[r].s;if(p[w]>e)f+=b-(1<<y-p[w]),p[w]=e;else break}for(f>>=g;f>0;){var x=o[r].s;p[x]<e?f-=1<<e-p[x]++-1:++r}for(;r>=0&&f;--r){var v=o[r].s;p[v]==e&&(--p[v],
++f)}y=e}return{t:new I(p),l:y}},Tr=function(n,e,t){return n.s==-1?Math.max(Tr(n.l,e,t+1),Tr(n.r,e,t+1)):e[n.s]=t},Qs=function(n){for(var e=n.length;e&&!n[--e];)
;for(var t=new ne(++e),r=0,s=n[0],o=1,a=function(l){t[r++]=l},i=1;i<=e;++i)if(n[i]==s&&i!=e)++o;else{if(!s&&o>2){for(;o>138;o-=138)a(32754);o>2&&(a(o>10?o-11<<5|
28690:o-3<<5|12305),o=0)}else if(o>3){for(a(s),--o;o>6;o-=6)a(8304);o>2&&(a(o-3<<5|8208),o=0)}for(;o--;)a(s);o=1,s=n[i]}return{c:t.subarray(0,r),n:e}},xt=function(n,e){
for(var t=0,r=0;r<e.length;++r)t+=n[r]*e[r];return t},io=function(n,e,t){var r=t.length,s=Cr(e+2);n[s]=r&255,n[s+1]=r>>8,n[s+2]=n[s]^255,n[s+3]=n[s+1]^255;for(var o=0;o<
r;++o)n[s+o+4]=t[o];return(s+4+r)*8},eo=function(n,e,t,r,s,o,a,i,l,c,u){we(e,u++,t),++s[256];for(var h=xr(s,15),m=h.t,p=h.l,y=xr(o,15),f=y.t,g=y.l,b=Qs(m),w=b.c,
x=b.n,v=Qs(f),E=v.c,R=v.n,k=new ne(19),O=0;O<w.length;++O)++k[w[O]&31];for(var O=0;O<E.length;++O)++k[E[O]&31];for(var M=xr(k,7),U=M.t,F=M.l,P=19;P>4&&!U[Sr[P-1]];--P)
;var Ae=c+5<<3,Z=xt(s,Ee)+xt(o,St)+a,K=xt(s,m)+xt(o,f)+a+14+3*P+xt(k,U)+2*k[16]+3*k[17]+7*k[18];if(l>=0&&Ae<=Z&&Ae<=K)return io(e,u,n.subarray(l,l+c));var W,N,Y,
B;if(we(e,u,1+(K<Z)),u+=2,K<Z){W=pe(m,p,0),N=m,Y=pe(f,g,0),B=f;var lt=pe(U,F,0);we(e,u,x-257),we(e,u+5,R-1),we(e,u+10,P-4),u+=14;for(var O=0;O<P;++O)we(e,u+3*O,
U[Sr[O]]);u+=3*P;for(var re=[w,E],ge=0;ge<2;++ge)for(var X=re[ge],O=0;O<X.length;++O){var Q=X[O]&31;we(e,u,lt[Q]),u+=U[Q],Q>15&&(we(e,u,X[O]>>5&127),u+=X[O]>>12)}}else
W=hl,N=Ee,Y=ml,B=St;for(var O=0;O<i;++O){var L=r[O];if(L>255){var Q=L>>18&31;wt(e,u,W[Q+257]),u+=N[Q+257],Q>7&&(we(e,u,L>>23&31),u+=tn[Q]);var he=L&31;wt(e,u,Y[he]),
u+=B[he],he>3&&(wt(e,u,L>>5&8191),u+=nn[he])}else wt(e,u,W[L]),u+=N[L]}return wt(e,u,W[256]),u+N[256]},gl=new Or([65540,131080,131088,131104,262176,1048704,1048832,
2114560,2117632]),lo=new I(0),vl=function(n,e,t,r,s,o){var a=o.z||n.length,i=new I(r+a+5*(1+Math.ceil(a/7e3))+s),l=i.subarray(r,i.length-s),c=o.l,u=(o.r||0)&7;if(e){
u&&(l[0]=o.r>>3);for(var h=gl[e-1],m=h>>13,p=h&8191,y=(1<<t)-1,f=o.p||new ne(32768),g=o.h||new ne(y+1),b=Math.ceil(t/3),w=2*b,x=function(er){return(n[er]^n[er+1]<<
b^n[er+2]<<w)&y},v=new Or(25e3),E=new ne(288),R=new ne(32),k=0,O=0,M=o.i||0,U=0,F=o.w||0,P=0;M+2<a;++M){var Ae=x(M),Z=M&32767,K=g[Ae];if(f[Z]=K,g[Ae]=Z,F<=M){var W=a-
M;if((k>7e3||U>24576)&&(W>423||!c)){u=eo(n,l,0,v,E,R,O,U,P,M-P,u),U=k=O=0,P=M;for(var N=0;N<286;++N)E[N]=0;for(var N=0;N<30;++N)R[N]=0}var Y=2,B=0,lt=p,re=Z-K&32767;
if(W>2&&Ae==x(M-re))for(var ge=Math.min(m,W)-1,X=Math.min(32767,M),Q=Math.min(258,W);re<=X&&--lt&&Z!=K;){if(n[M+Y]==n[M+Y-re]){for(var L=0;L<Q&&n[M+L]==n[M+L-re];++L)
;if(L>Y){if(Y=L,B=re,L>ge)break;for(var he=Math.min(re,L-2),je=0,N=0;N<he;++N){var Ge=M-re+N&32767,Bt=f[Ge],jt=Ge-Bt&32767;jt>je&&(je=jt,K=Ge)}}}Z=K,K=f[Z],re+=
Z-K&32767}if(B){v[U++]=268435456|Ar[Y]<<18|Xs[B];var ct=Ar[Y]&31,ut=Xs[B]&31;O+=tn[ct]+nn[ut],++E[257+ct],++R[ut],F=M+Y,++k}else v[U++]=n[M],++E[n[M]]}}for(M=Math.
max(M,F);M<a;++M)v[U++]=n[M],++E[n[M]];u=eo(n,l,c,v,E,R,O,U,P,M-P,u),c||(o.r=u&7|l[u/8|0]<<3,u-=7,o.h=g,o.p=f,o.i=M,o.w=F)}else{for(var M=o.w||0;M<a+c;M+=65535){
var ze=M+65535;ze>=a&&(l[u/8|0]=c,ze=a),u=io(l,u+1,n.subarray(M,ze))}o.i=a}return Rr(i,0,r+Cr(u)+s)},bl=(function(){for(var n=new Int32Array(256),e=0;e<256;++e){
for(var t=e,r=9;--r;)t=(t&1&&-306674912)^t>>>1;n[e]=t}return n})(),wl=function(){var n=-1;return{p:function(e){for(var t=n,r=0;r<e.length;++r)t=bl[t&255^e[r]]^t>>>
8;n=t},d:function(){return~n}}};var xl=function(n,e,t,r,s){if(!s&&(s={l:1},e.dictionary)){var o=e.dictionary.subarray(-32768),a=new I(o.length+n.length);a.set(o),a.set(n,o.length),n=a,s.w=o.length}
return vl(n,e.level==null?6:e.level,e.mem==null?s.l?Math.ceil(Math.max(8,Math.min(13,Math.log(n.length)))*1.5):20:12+e.mem,t,r,s)},co=function(n,e){var t={};for(var r in n)
t[r]=n[r];for(var r in e)t[r]=e[r];return t};var j=function(n,e,t){for(;t;++e)n[e]=t,t>>>=8};var Sl=function(n,e){return((n[0]&15)!=8||n[0]>>4>7||(n[0]<<8|n[1])%31)&&q(6,"invalid zlib data"),(n[1]>>5&1)==+!e&&q(6,"invalid zlib data: "+(n[1]&32?"need":"u\
nexpected")+" dictionary"),(n[1]>>3&4)+2};function Al(n,e){return xl(n,e||{},0,0)}function uo(n,e){return yl(n.subarray(Sl(n,e&&e.dictionary),-4),{i:2},e&&e.out,e&&e.dictionary)}var ho=function(n,e,t,r){for(var s in n){var o=n[s],a=e+s,i=r;Array.isArray(o)&&(i=co(r,o[1]),o=o[0]),o instanceof I?t[a]=[o,i]:(t[a+="/"]=[new I(0),i],ho(o,a,t,
r))}},to=typeof TextEncoder<"u"&&new TextEncoder,Ml=typeof TextDecoder<"u"&&new TextDecoder,Tl=0;try{Ml.decode(lo,{stream:!0}),Tl=1}catch{}function Ie(n,e){if(e){for(var t=new I(n.length),r=0;r<n.length;++r)t[r]=n.charCodeAt(r);return t}if(to)return to.encode(n);for(var s=n.length,o=new I(n.length+
(n.length>>1)),a=0,i=function(u){o[a++]=u},r=0;r<s;++r){if(a+5>o.length){var l=new I(a+8+(s-r<<1));l.set(o),o=l}var c=n.charCodeAt(r);c<128||e?i(c):c<2048?(i(192|
c>>6),i(128|c&63)):c>55295&&c<57344?(c=65536+(c&1047552)|n.charCodeAt(++r)&1023,i(240|c>>18),i(128|c>>12&63),i(128|c>>6&63),i(128|c&63)):(i(224|c>>12),i(128|c>>
6&63),i(128|c&63))}return Rr(o,0,a)}var Er=function(n){var e=0;if(n)for(var t in n){var r=n[t].length;r>65535&&q(9),e+=r+4}return e},no=function(n,e,t,r,s,o,a,i){var l=r.length,c=t.extra,u=i&&i.length,
h=Er(c);j(n,e,a!=null?33639248:67324752),e+=4,a!=null&&(n[e++]=20,n[e++]=t.os),n[e]=20,e+=2,n[e++]=t.flag<<1|(o<0&&8),n[e++]=s&&8,n[e++]=t.compression&255,n[e++]=
t.compression>>8;var m=new Date(t.mtime==null?Date.now():t.mtime),p=m.getFullYear()-1980;if((p<0||p>119)&&q(10),j(n,e,p<<25|m.getMonth()+1<<21|m.getDate()<<16|m.
getHours()<<11|m.getMinutes()<<5|m.getSeconds()>>1),e+=4,o!=-1&&(j(n,e,t.crc),j(n,e+4,o<0?-o-2:o),j(n,e+8,t.size)),j(n,e+12,l),j(n,e+14,h),e+=16,a!=null&&(j(n,e,
u),j(n,e+6,t.attrs),j(n,e+10,a),e+=14),n.set(r,e),e+=l,h)for(var y in c){var f=c[y],g=f.length;j(n,e,+y),j(n,e+2,g),n.set(f,e+4),e+=4+g}return u&&(n.set(i,e),e+=
u),e},El=function(n,e,t,r,s){j(n,e,101010256),j(n,e+8,t),j(n,e+10,t),j(n,e+12,r),j(n,e+16,s)};function rn(n,e){e||(e={});var t={},r=[];ho(n,"",t,e);var s=0,o=0;for(var a in t){var i=t[a],l=i[0],c=i[1],u=c.level==0?0:8,h=Ie(a),m=h.length,p=c.comment,y=p&&
Ie(p),f=y&&y.length,g=Er(c.extra);m>65535&&q(11);var b=u?Al(l,c):l,w=b.length,x=wl();x.p(l),r.push(co(c,{size:l.length,crc:x.d(),c:b,f:h,m:y,u:m!=a.length||y&&p.
length!=f,o:s,compression:u})),s+=30+m+g+w,o+=76+2*(m+g)+(f||0)+w}for(var v=new I(o+22),E=s,R=o-s,k=0;k<r.length;++k){var h=r[k];no(v,h.o,h,h.f,h.u,h.c.length);
var O=30+h.f.length+Er(h.extra);v.set(h.c,h.o+O),no(v,s,h,h.f,h.u,h.c.length,h.o,h.m),s+=16+O+(h.m?h.m.length:0)}return El(v,s,r.length,R,E),v}var Ol={teams:{pursuer:"pursuers",evader:"evaders"},generation:{pursuer:"pursuer generation",evader:"evader generation"},score:"capture rate",means:{pursuer:"ca\
ptures",evader:"escapes"},curves:{pursuer:"captures",evader:"escapes"},ends:["0 all escape","1 all caught"],lead:"Each cell is a match between two generations: \
the brighter, the more evaders are captured. Click one to watch it.",click:"watch its match"},mo=([n,e])=>({teams:{pursuer:n,evader:e},generation:{pursuer:`gene\
ration of ${n}`,evader:`generation of ${e}`},score:`score of the ${n}`,means:{pursuer:n,evader:e},curves:{pursuer:"scores",evader:"scores"},ends:[`0 the ${e} wi\
n`,`1 the ${n} win`],lead:`Each cell is a pair of generations: the brighter, the higher the score of the ${n}. Click one to see more of it.`,click:"see more of \
it"}),Cl=["0 worst","1 best"],Rl=n=>({...mo([n,n]),generation:{pursuer:`generation of ${n}`,evader:"generation of the opponent"},score:"score",ends:["0 loses","\
1 wins"],lead:`Each cell is a pair of generations of ${n}: the brighter, the higher the score of the row. Click one to see more of it.`}),kl=({game:n})=>n&&n.teams[0]===
n.teams[1]?A.slice(0,1):A,Oe=n=>{if(!n.game)return Ol;let e=kl(n).length===1?Rl(n.game.teams[0]):mo(n.game.teams);return n.payoff?.others?{...e,ends:Cl}:e},J=(n,e,t)=>`${Oe(
n).teams[e]} of generation ${t}`;function Re(n,e,t){let r=e-n.payoff.first[0],s=t-n.payoff.first[1],o=n.payoff.capture_rate[r]?.[s];return o===void 0?null:{rate:o,rates:n.payoff.capture_rates[r][s],
lengths:n.payoff.lengths[r]?.[s]??[]}}function po(n,e,t){let{script:r,policy:s,kept:o,genomes:a}=n.teams[e];if(r!==null||s===null)return"";if(!o.includes(t))return`\
The page holds no genome of ${J(n,e,t)}: it would be too large. Choose a generation of ${o.join(", ")}.`;let i=o.length*s.genome_size;return wo(a,s.genome_size).
length===i?"":`The page is damaged: it does not hold the ${i} numbers of the ${e}s' genomes. Write it again from its run.`}function Ce(n,e,t){let{script:r,policy:s,
kept:o,genomes:a}=n.teams[e];if(r!==null||s===null)return r??"random";let i=o.indexOf(t);if(i<0)throw new RangeError(`${e}: expected a generation whose genome t\
he page holds, got ${t}`);let l=s.genome_size,c=wo(a,l).subarray(i*l,(i+1)*l);return{...s,genome:c}}var fo=({teams:n},e)=>(n[e].policy??{kind:"cells"}).kind!=="\
cells";function yo({teams:n},e,t){let{kept:r,expressions:s,weights:o}=n[e],a=r.indexOf(t),i=s?.[a];return i?{expression:i,weights:o?.[a]??null}:null}function go(n,e){
return n.kind==="program"?e?.weights??null:n.hidden.length?null:Object.fromEntries(n.inputs.map((t,r)=>[t,n.genome[r]]))}function vo(n,e,{pursuer:t,evader:r,episode:s,
seed:o}){let a=e.seeds[t][r];return n.match(e.world,Ce(e,"pursuer",t),Ce(e,"evader",r),BigInt(o??a),s)}var kr=4,_r=new Map,bo=(n,e)=>{_r.set(n,e)};function wo(n,e){
let t=_r.get(n);if(t)return t;let r=new Float32Array;try{let s=$l($r(n),e);s.every(Number.isFinite)&&(r=s)}catch(s){if(!(s instanceof DOMException||s instanceof
RangeError||_l(s)))throw s}return _r.set(n,r),r}var _l=n=>n instanceof Error&&"code"in n;function $l(n,e){let t=uo(n),r=t.length/kr,s=new Uint8Array(t.length);for(let a=0;a<
s.length;a++)s[a]=t[a%kr*r+Math.floor(a/kr)];let o=new Uint32Array(s.buffer);for(let a=e;a<o.length;a++)o[a]^=o[a-e];return new Float32Array(s.buffer)}function $r(n){
let e=atob(fe(n)),t=new Uint8Array(e.length);for(let r=0;r<t.length;r++)t[r]=e.charCodeAt(r);return t}var fe=n=>document.getElementById(n)?.textContent??"";var xo=()=>JSON.parse(fe("data")),Je={"specialist-specialist":"Specialists: both teams meet only the newest opponent","generalist-specialist":"Pursuers meet all\
 earlier evaders, evaders only the newest pursuers","generalist-generalist":"Generalists: both teams meet all earlier opponents","hall-of-fame":"Halls of fame: \
both teams learn at once, and meet earlier champions"};function sn({schedule:n}){if(n.kind==="hall-of-fame")return n.kind;let e={latest:"specialist","round-robi\
n":"generalist",uniform:"uniform"};return`${e[n.pursuers_meet]}-${e[n.evaders_meet]}`}var on=n=>Je[sn(n)]??sn(n);var ln=10,cn=999999,Ze=15,un=90,Nr=[3,5,7,9,11],hn=5,Lr=[8,16,32,64],Ir=[6,10,30,60,90,120,200];function Pr(n,e=""){let t=Object.hasOwn(n.worlds,e)?e:Object.keys(
n.worlds)[0],{n_pursuers:r,n_evaders:s,fov:o,max_steps:a}=n.worlds[t];return{world:t,schedule:"generalist-generalist",beside:"",learner:"es",policy:"rating",seed:0,
generations:Ze,way:!1,population:0,pursuers:r,evaders:s,view:o,steps:a,walls:null}}function dn(n,e,t=e.schedule){let r=n.races[e.policy][e.learner][t],s=n.worlds[e.
world],o={...s,n_pursuers:e.pursuers,n_evaders:e.evaders,fov:e.view,max_steps:e.steps,obstacles:e.walls?qs(e.walls,s.rows,s.cols):s.obstacles},a=e.way?"right-of\
-way":e.policy==="rating"?"obstacles":"none";return{...r,world:o,train_steps:e.steps,seed:e.seed,policy:{...r.policy,mask:a},learner:{...r.learner,population:e.
population||r.learner.population},schedule:{...r.schedule,generations:e.generations}}}function mn({walls:n,pursuers:e,evaders:t},{rows:r,cols:s}){if(!n)return"";
let o=new Set(Array.from({length:r*s},(i,l)=>l).filter(i=>!n.includes(i)));if(o.size<e+t)return`There is no room: ${e+t} agents need a free cell each.`;let a=[Math.
min(...o)];o.delete(a[0]);for(let i of a){let l=i%s,c=[i-s,i+s,...l>0?[i-1]:[],...l<s-1?[i+1]:[]];a.push(...c.filter(u=>o.delete(u)))}return o.size?"Nobody may \
be walled in: all free cells have to be connected, side by side.":""}function an(n){return Array.isArray(n)?n.join(".")||"none":n===null?"usual":String(typeof n==
"boolean"?Number(n):n)}function So(n,e){let t=Pr(n,e.world),r=Pr(n);return Object.fromEntries(Object.keys(e).filter(s=>an(e[s])!==an((s==="world"?r:t)[s])).map(
s=>[s,an(e[s])]))}var Ao=n=>Object.fromEntries(Object.entries(n).map(([e,t])=>[e,an(t)]));function Fr(n,e,t,r){let s=r??Pr(n,e.world),{rows:o,cols:a}=n.worlds[s.
world],i=(f,g)=>b=>/^\d{1,6}$/.test(b)&&Number(b)>=f&&Number(b)<=g?Number(b):void 0,l=(...f)=>g=>f.find(b=>String(b)===g),c=f=>{if(f==="usual"||f==="none")return f===
"usual"?null:[];let g=f.split(".").map(b=>i(0,o*a-1)(b));return g.includes(void 0)?void 0:g.reduce((b,w)=>Xt(b,w,!0),[])},u={world:l(...Object.keys(n.worlds)),schedule:l(
...Object.keys(Je)),beside:l("",...Object.keys(Je)),learner:l("es","ga"),policy:l("rating","cells"),way:f=>/^[01]$/.test(f)?f==="1":void 0,seed:i(0,cn),generations:i(
Ze,un),pursuers:i(1,ln),evaders:i(1,ln),view:l(...Nr),steps:l(...Ir),population:l(0,...Lr),walls:c},h=Object.entries(e).map(([f,g])=>{let b=Object.hasOwn(u,f)?u[f](
g):void 0;return b===void 0&&t(`${f}=${g}`),[f,b]}),m={...s,...Object.fromEntries(h.filter(([,f])=>f!==void 0))},p=m.way?{...m,view:Math.max(hn,m.view)}:m,y=mn(
p,n.worlds[p.world]);return y&&t(y),y?{...p,walls:null}:p}var Pl=1e3,Nl=5;function oe(n,e,t,r=""){return d("label",{class:`field ${r}`,title:e},d("span",{class:"field-name"},n),t,d("span",{class:"about small muted"},e))}
function Mo(n,e){let t=Object.entries(Je),r=v=>{let{n_pursuers:E,n_evaders:R,max_steps:k}=n.worlds[v];return{world:v,pursuers:E,evaders:R,steps:k,walls:null}},s=v=>{
let{rows:E,cols:R,n_pursuers:k,n_evaders:O}=n.worlds[v];return`${v}: ${E} x ${R}, ${k} against ${O}`},o=ee(Object.keys(n.worlds).map(v=>[v,s(v)]),v=>e(r(v),!0)),
a=ee(t,v=>e({schedule:v})),i=ee([["","Nothing"],...t],v=>e({beside:v},!0)),l=Array.from({length:ln},(v,E)=>[E+1,String(E+1)]),c=ee(l,v=>e({pursuers:Number(v)})),
u=ee(l,v=>e({evaders:Number(v)})),h=ee(Nr.map(v=>[v,`${v} x ${v}`]),v=>e({view:Number(v),...Number(v)<hn?{way:!1}:{}})),m=d("input",{type:"checkbox",onchange:()=>e(
{way:m.checked,...m.checked?{view:Math.max(hn,Number(h.value))}:{}})}),p=ee([[0,"usual"],...Lr.map(v=>[v,String(v)])],v=>e({population:Number(v)})),y=ee(Ir.map(
v=>[v,String(v)]),v=>e({steps:Number(v)})),f=ee([["es","evolution strategy"],["ga","genetic algorithm"]],v=>e({learner:v},!0)),g=ee([["rating","weights of named\
 inputs"],["cells","a network over the cells of its view"]],v=>e({policy:v,...v==="cells"?{view:Nl}:{}},!0)),b=d("input",{type:"number",min:0,max:cn,step:1,inputmode:"\
numeric"});b.addEventListener("change",()=>e({seed:Math.min(cn,Math.max(0,Math.round(Number(b.value))||0))},!0));let w=d("button",{type:"button",onclick:()=>e({
seed:Math.floor(Math.random()*Pl)},!0)},"Another seed"),x=(v,E,...R)=>d("section",{class:`controls ${E}`,"aria-label":v},d("fieldset",{},d("legend",{},v),...R));
return{main:x("Try something else","card",oe("World","where they meet; begins a new race",o,"wide"),oe("Pursuers","triangles; at once",c),oe("Evaders","discs; a\
t once",u),oe("Steps","after which evaders that are free have won",y),oe("Seed","the luck of the race; begins a new one",d("span",{class:"seed"},b,w),"half")),more:d(
"details",{class:"card more-controls"},d("summary",{},"More: whom they meet, how they learn, what they see"),x("How they learn","",oe("Opponents","whom the team\
s meet while they learn",a,"wide"),oe("Side by side with","a second race of the same seed",i,"wide"),oe("What evolves","what an agent decides by",g,"half"),oe("\
Learner","how a team learns",f,"half"),oe("View","cells that an agent sees around itself",h),oe("Right of way","agents never take a move that could put them at \
fault",d("span",{},m)),oe("Population","candidates that are compared at a time",p))),show:v=>{o.value=v.world,a.value=v.schedule,i.value=v.beside,h.value=String(
v.view),f.value=v.learner,p.value=String(v.population),y.value=String(v.steps),b.value=String(v.seed),m.checked=v.way,g.value=v.policy,c.value=String(v.pursuers),
u.value=String(v.evaders)}}}function Dr(n,e,t,r){let{players:s,told:o,...a}=r;e.play({...a,played:t,ending:(i,l)=>[o?d("p",{},o(ve(i,t.seat))):"",Ll(n,i,l,Zs(s))],again:()=>Dr(n,e,{...t,moves:t.
moves.slice(0,t.from)},r)})}function Ll(n,e,t,r){let s=me(t.config,t.seat)==="evader",o=s?t.config.max_steps:t.config.n_evaders,a=d("table",{class:"numbers"},d(
"caption",{},s?"Steps in your seat: same start, same others":"Captures of your team: same start, same others")),i=c=>{let u=d("span",{class:s?"bar evader":"bar \
pursuer"}),h=d("td",{},"…");return a.append(d("tr",{},d("th",{scope:"row"},c),d("td",{class:"track","aria-hidden":"true"},u),h)),({lasted:m,captured:p})=>{u.style.
width=`${100*(s?m:p)/o}%`,h.textContent=String(s?m:p)}};i("You")(ve(e,t.seat));for(let{name:c,policy:u}of r){let h=i(c);setTimeout(()=>h(Js(n,t,u())))}let l=t.from?
`You took over at step ${t.from}. `:"";return d("div",{},a,d("p",{class:"small muted"},`${l}One match: luck has its part in it.`))}var Xe=[[0,0],[-1,0],[0,1],[1,0],[0,-1],[-1,1],[1,1],[1,-1],[-1,-1]];function To(n,e,t){let r=e[0]-n[0],s=e[1]-n[1];return!t&&Math.abs(r)>Math.abs(s)?s=0:t||(r=
0),Xe.findIndex(([o,a])=>o===Math.sign(r)&&a===Math.sign(s))}var Fe=(n,e)=>e<n.nPursuers,$=(n,e)=>[n.positions[2*e],n.positions[2*e+1]],Ur=({rows:n,cols:e},[t,r])=>t>=
0&&r>=0&&t<n&&r<e,Wr=(n,e,t=3)=>n!==void 0&&[0,1,2].slice(0,t).some(r=>n[3*e+r]),Br=(n,e)=>Wr(n.fault,e),Eo=(n,e)=>!Br(n,e)&&Wr(n.involved,e,2);function pn(n,e,t){
let r=$(n,t),s=$(e,t),o=r[0]!==s[0]||r[1]!==s[1],a=e.involved===void 0||Wr(e.involved,t);return!!(e.alive[t]&&e.actions?.[t]&&!o&&a)}function fn(n,e,t){let[r,s]=$(
n,t),[o,a]=Xe[e.actions?.[t]??0];return[r+o,s+a]}function At(n,e,t){return Array.from({length:t.everCaptured.length},(s,o)=>o).filter(s=>t.everCaptured[s]&&!e.everCaptured[s]).
map(s=>n.nPursuers+s)}var yn=n=>n.moments.flatMap((e,t)=>t&&At(n,n.moments[t-1],e).length?[t]:[]);function gn(n,e){return Array.from({length:e.alive.length},(r,s)=>s).
filter(r=>n.alive[r]&&!e.alive[r])}var Oo=[-.31,0,.31],Co=[{size:1,at:[[0,0]]},{size:.62,at:[[-.2,.2],[.2,-.2]]},{size:.54,at:[[-.23,.22],[.23,.22],[0,-.22]]},{size:.54,at:[[-.23,.23],[.23,.23],[
-.23,-.23],[.23,-.23]]},{size:.36,at:Oo.flatMap(n=>Oo.map(e=>[e,n]))}],Il=.3,Fl=.35,Dl=.55;function Mt(n,e){let t=new Map;for(let r=0;r<e.alive.length;r++){if(!e.
alive[r])continue;let[s,o]=$(e,r),a=s*n.cols+o,i=t.get(a);i?i.push(r):t.set(a,[r])}return t}function Ro(n,e){let t=Array.from(e.alive,(r,s)=>{let[o,a]=$(e,s);return{
x:a+.5,y:o+.5,size:1,alpha:0}});for(let r of Mt(n,e).values()){let s=Co[Math.min(r.length,Co.length)-1];r.forEach((o,a)=>{let[i,l]=s.at[Math.min(a,s.at.length-1)],
c=t[o];c.x+=i,c.y+=l,c.size=s.size,c.alpha=1})}return t}var ko=n=>n*n*(3-2*n),Qe=(n,e,t)=>n+(e-n)*t,_o=n=>Math.min(1,Math.max(0,n));function $o(n,e,t,r){let s={
SIMULTANEOUS:1,SWARM_TURNS:2,AGENT_TURNS:t}[n.interaction];if(s===1)return ko(r);let o=s===t?e:+!Fe(n,e),a=Math.max(1/s,Fl);return ko(_o((r-o/(s-1)*(1-a))/a))}function vn(n,e){
let t=n.moments.length-1,r=Math.min(Math.floor(e),t),s=n.moments[r],o=Ro(n,s);if(r===t||e===r)return o;let a=n.moments[r+1],i=Ro(n,a);return o.map((l,c)=>{let u=$o(
n,c,o.length,e-r);return Ul(s,a,c,l,i[c],u)})}function jr(n,e,t){let r=n.moments.length-1,s=Math.min(Math.floor(t),r),o=n.moments[s],a=n.moments[Math.min(s+1,r)],
i=$o(n,e,o.alive.length,t-s),[l,c]=$(o,e),[u,h]=$(a,e);return[Qe(c,h,i)+.5,Qe(l,u,i)+.5]}function Ul(n,e,t,r,s,o){let a=r.alpha>s.alpha,i={x:Qe(r.x,s.x,o),y:Qe(
r.y,s.y,o),size:a?r.size:Qe(r.size,s.size,o),alpha:a?_o((1-o)/(1-Dl)):Qe(r.alpha,s.alpha,o)};if(pn(n,e,t)){let[l,c]=$(n,t),[u,h]=fn(n,e,t),m=Il*Math.sin(Math.PI*
o);i.x+=(h-c)*m,i.y+=(u-l)*m}return i}var Po=2*Math.PI;function De(n,e,t,r){n.beginPath(),n.arc(e,t,r/2,0,Po)}function bn(n,e,t,r){let s=r/2,o=[[0,-.97],[.97,.83],[-.97,.83]].map(([a,i])=>[e+a*s,t+i*
s]);n.beginPath(),n.moveTo((o[2][0]+o[0][0])/2,(o[2][1]+o[0][1])/2),o.forEach(([a,i],l)=>{let[c,u]=o[(l+1)%3];n.arcTo(a,i,c,u,r*.09)}),n.closePath()}function No(n,e,t,r){
let s=r*.32;n.beginPath(),n.moveTo(e-s,t-s),n.lineTo(e+s,t+s),n.moveTo(e+s,t-s),n.lineTo(e-s,t+s)}function Lo(n,e,t,r){n.beginPath();for(let s=0;s<16;s++){let o=r/
2*(s%2?.6:.95),a=Po*s/16;n.lineTo(e+o*Math.sin(a),t-o*Math.cos(a))}n.closePath()}function Io(n,e,t,r,s,o){let a=Math.atan2(s-t,r-e);n.beginPath(),n.moveTo(e,t),
n.lineTo(r,s);for(let i of[-1,1])n.moveTo(r,s),n.lineTo(r-o*Math.cos(a+i*.6),s-o*Math.sin(a+i*.6))}var Fo=4,Wl=1.6,Bl=.95,jl=5,Gl=.16,zl=9,Hl=.09,Vl=.2,Do=.75,H=(n,e)=>n.left+e*n.cell,V=(n,e)=>n.top+e*n.cell;function et(n,e,t){return Fe(e,t)?n.colors.pursuer:
n.colors.evader}function wn({ctx:n,colors:e},t,r,s,o,a,i=0){n.font=`700 ${Math.round(o)}px system-ui, sans-serif`,n.textAlign="center",n.textBaseline="middle",n.
strokeStyle=e.paper,n.lineWidth=i,i&&n.strokeText(t,r,s),n.fillStyle=a,n.fillText(t,r,s)}function Uo({ctx:n,grid:e,colors:t}){let{left:r,top:s,cell:o,rows:a,cols:i}=e,
l=i*o,c=a*o;if(n.fillStyle=t.paper,n.fillRect(r,s,l,c),o<jl)return;n.fillStyle=t.line;let u=Math.max(1,Math.round(o/60));for(let h=1;h<i;h++)n.fillRect(r+h*o,s,
u,c);for(let h=1;h<a;h++)n.fillRect(r,s+h*o,l,u)}function Wo({ctx:n,grid:e,colors:t},r){let{left:s,top:o,cell:a,rows:i,cols:l}=e;n.fillStyle=t.obstacle;for(let c=0;c<
i*l;c++){if(!r.obstacles[c])continue;let u=Math.floor(c/l),h=c%l;n.fillRect(s+h*a,o+u*a,a,a)}Bo({ctx:n,grid:e,colors:t})}function Bo({ctx:n,grid:{left:e,top:t,cell:r,
rows:s,cols:o},colors:a}){let i=Math.min(5,Math.max(2,Math.round(r/18)));n.strokeStyle=a.frame,n.lineWidth=i,n.strokeRect(e-i/2,t-i/2,o*r+i,s*r+i)}function jo({
ctx:n,grid:e,colors:t},r){let{left:s,top:o,cell:a,rows:i,cols:l}=e,c=a<24*r?5:1;n.font=`500 ${Math.round(Math.min(15*r,Math.max(9*r,a*.32)))}px system-ui, sans-\
serif`,n.fillStyle=t.muted,n.textBaseline="alphabetic",n.textAlign="center";let u=5*r+a/40;for(let h=0;h<l;h+=c)n.fillText(String(h),s+(h+.5)*a,o-u);n.textAlign=
"right",n.textBaseline="middle";for(let h=0;h<i;h+=c)n.fillText(String(h),s-u,o+(h+.5)*a)}function Go({grid:n},e,t,r){let s=Math.floor(e.fov/2)+.5,o=Math.max(0,
t-s),a=Math.min(n.cols,t+s),i=Math.max(0,r-s),l=Math.min(n.rows,r+s);return[H(n,o),V(n,i),(a-o)*n.cell,(l-i)*n.cell]}function zo(n,e,t,r){let{ctx:s,grid:o,colors:a}=n;
s.save(),s.beginPath(),s.rect(0,0,s.canvas.width,s.canvas.height),s.rect(...Go(n,e,t,r)),s.clip("evenodd"),s.clearRect(0,0,s.canvas.width,s.canvas.height),s.fillStyle=
a.line,s.fillRect(o.left,o.top,o.cols*o.cell,o.rows*o.cell),s.restore(),Bo(n)}function Ho(n,{x:e,y:t,alpha:r},s){let{ctx:o,grid:a,colors:i}=n,l=Math.max(a.cell,
16*s)*1.06,c=H(a,e),u=V(a,t);o.globalAlpha=Math.max(r,.6),o.beginPath(),o.roundRect(c-l/2,u-l/2,l,l,l*.2),o.strokeStyle=i.focus,o.lineWidth=Math.max(2,2.5*s),o.
stroke();let h=Math.max(11*s,Math.min(18*s,a.cell*.5)),m=u-l/2<h*1.2,p=u+(m?1:-1)*(l/2+h*.7);o.lineJoin="round",wn(n,"You",c,p,h,i.ink,h*.35),o.globalAlpha=1}function Vo(n,e,t,r,s){
let{ctx:o,grid:a}=n,i=Go(n,e,r,s),l=et(n,e,t);o.globalAlpha=.11,o.fillStyle=l,o.fillRect(...i),o.globalAlpha=.8,o.strokeStyle=l,o.lineWidth=Math.max(1,a.cell/24),
o.strokeRect(...i),o.globalAlpha=1}function Ko(n,e,t,r,s){let{ctx:o,grid:a}=n,i=Math.min(Math.ceil(t),e.moments.length-1),l=e.moments[i];o.lineCap="round",o.lineWidth=
Math.min(zl,Math.max(1,a.cell*Gl));for(let c=Math.max(1,Math.floor(t-r)+1);c<=i;c++){let u=e.moments[c-1],h=e.moments[c],m=Math.max(0,Math.min(1,(t-c)/r));o.globalAlpha=
Do+(Vl-Do)*m;for(let p=0;p<h.alive.length;p++){let y=c===i&&t<i;if(!u.alive[p]||!(l.alive[p]||y))continue;let f=(Fe(e,p)?-1:1)*Hl,[g,b]=$(u,p),[w,x]=$(h,p);if(g===
w&&b===x)continue;let v=y?s[p].x:x+.5,E=y?s[p].y:w+.5;o.strokeStyle=et(n,e,p),o.beginPath(),o.moveTo(H(a,b+.5+f),V(a,g+.5+f)),o.lineTo(H(a,v+f),V(a,E+f)),o.stroke()}}
o.globalAlpha=1}function Yo(n,e,t){let r=Math.min(Math.ceil(t),e.moments.length-1);for(let s=Math.max(1,r-Fo+1);s<=r;s++){let o=e.moments[s-1],a=e.moments[s],i=s>
t?Math.max(0,1-2*(s-t)):1-(t-s)/Fo,l=At(e,o,a);for(let c of gn(o,a))l.includes(c)||Yl(n,$(a,c),i);for(let c of l)Kl(n,$(a,c),i)}n.ctx.globalAlpha=1}function Kl({
ctx:n,grid:e,colors:t},[r,s],o){n.globalAlpha=o,Lo(n,H(e,s+.5),V(e,r+.5),Math.max(8,e.cell*Wl)),n.fillStyle=t.capture,n.fill(),n.strokeStyle=t.ink,n.lineWidth=Math.
max(1,e.cell/36),n.lineJoin="round",n.stroke()}function Yl({ctx:n,grid:e,colors:t},[r,s],o){n.globalAlpha=o,No(n,H(e,s+.5),V(e,r+.5),Math.max(7,e.cell*Bl)),n.strokeStyle=
t.collision,n.lineWidth=Math.max(2,e.cell*.17),n.lineCap="round",n.stroke()}function qo({ctx:n,grid:e,colors:t},r,s){let o=Math.max(1,e.cell*.07);n.strokeStyle=
n.fillStyle=t.collision,n.lineWidth=Math.max(1,e.cell*.05),n.setLineDash([e.cell*.14,e.cell*.1]);for(let[a,i]of r){if(a<0||i<0||a>=e.rows||i>=e.cols)continue;let l=[
H(e,i)+o,V(e,a)+o,e.cell-2*o,e.cell-2*o];n.globalAlpha=.2*s,n.fillRect(...l),n.globalAlpha=s,n.strokeRect(...l)}n.setLineDash([]),n.globalAlpha=1}function Jo({ctx:n,
grid:e,colors:t},r,s,o,a){n.globalAlpha=a,De(n,H(e,r),V(e,s),Math.max(8,e.cell*o*1.02)),n.strokeStyle=t.collision,n.lineWidth=Math.max(1.5,e.cell*.085*Math.sqrt(
o)),n.stroke(),n.globalAlpha=1}var ql=.8,Jl=.92,Zl=15,Xl=7,Gr=9;function Zo(n,e,t,r,s,o){r.forEach((a,i)=>{a.alpha>0&&Ql(n,e,t,i,a,s,o)}),n.ctx.globalAlpha=1;for(let a of Mt(e,t).values())a.length>
Gr&&ec(n,r[a[Gr-1]],a.length-Gr+1)}function Ql(n,e,t,r,s,o,a){let{ctx:i,grid:l,colors:c}=n,u=Fe(e,r),h=H(l,s.x),m=V(l,s.y),p=Math.max(4,l.cell*s.size*(u?Jl:ql)),
y=et(n,e,r),f=!u&&!!t.captured[r-e.nPursuers];if(i.globalAlpha=s.alpha,(u?bn:De)(i,h,m,p),p>Xl*a&&(i.strokeStyle=c.paper,i.lineWidth=Math.max(2,p*.1),i.stroke()),
i.fillStyle=f?c.paper:y,i.fill(),f&&(De(i,h,m,p*.82),i.strokeStyle=y,i.lineWidth=p*.18,i.stroke()),!o||p<Zl*a)return;let g=String(u?r:r-e.nPursuers),b=p*(u?.4:.5)*
(g.length>1?.8:1);wn(n,g,h,m+p*(u?.17:.03),b,f?y:c.paper)}function ec(n,e,t){let{cell:r}=n.grid;wn(n,`+${t}`,H(n.grid,e.x),V(n.grid,e.y),r*.3,n.colors.ink,r*.1)}var tc=.46,nc=.86,rc=.66,Xo=.48,sc=.78,oc=.58;function Qo(n,e,t,r){let s=e.moments[t-1],o=e.moments[t];if(!s)return;let{ctx:a,grid:i,colors:l}=n;a.strokeStyle=l.
collision,a.lineWidth=Math.max(1.5,i.cell*.07),a.lineCap="butt",a.globalAlpha=r;for(let c=0;c<o.alive.length;c++)pn(s,o,c)&&ac(n,e,$(s,c),fn(s,o,c));a.globalAlpha=
1}function ac({ctx:n,grid:e},t,r,s){let o=s[1]-r[1],a=s[0]-r[0],i=h=>H(e,r[1]+.5+o*h),l=h=>V(e,r[0]+.5+a*h),c=Ur(t,s)?sc:oc;n.setLineDash([e.cell*.09,e.cell*.06]),
n.beginPath(),n.moveTo(i(Xo),l(Xo)),n.lineTo(i(c),l(c)),n.stroke(),n.setLineDash([]);let u=.17*e.cell/Math.hypot(o,a);n.beginPath(),n.moveTo(i(c)-a*u,l(c)+o*u),
n.lineTo(i(c)+a*u,l(c)-o*u),n.stroke()}function ea(n,e,t,r,s,o){let a=Xe[o];if(!o||!a)return;let{ctx:i,grid:l,colors:c}=n,u=Ur(e,[r[0]+a[0],r[1]+a[1]])?nc:rc,h=tc*
s.size,m=[H(l,s.x+a[1]*h),V(l,s.y+a[0]*h),H(l,s.x+a[1]*u),V(l,s.y+a[0]*u)],p=Math.max(1.5,l.cell*.085);i.lineCap=i.lineJoin="round";for(let[y,f]of[[c.paper,p*2.1],
[et(n,e,t),p]])i.strokeStyle=y,i.lineWidth=f,Io(i,...m,l.cell*.2),i.stroke()}var xn={numbers:!0,axes:!1,trail:6,viewers:[],plan:null,selected:null,cursor:null,you:null,fog:!1};function Sn(n,e,t,r,s){let{ctx:o,grid:a,colors:i}=n,l=Math.min(
Math.ceil(t),e.moments.length-1),c=e.moments[l],u=t===l,h=vn(e,t),m=u?1:Math.max(0,1-2*(l-t));o.clearRect(0,0,o.canvas.width,o.canvas.height),Uo(n);for(let f of r.
viewers)h[f]?.alpha&&Vo(n,e,f,...jr(e,f,t));Wo(n,e),r.axes&&jo(n,s),Ko(n,e,t,r.trail,h),qo(n,c.contested??[],m),Yo(n,e,t),Qo(n,e,l,m),h.forEach(({x:f,y:g,size:b},w)=>{
let x=Eo(c,w)?.4:0,v=Br(c,w)?1:x;v&&Jo(n,f,g,b,v*m)});let p=u?c:e.moments[Math.max(0,l-1)];if(Zo(n,e,p,h,r.numbers,s),u&&r.plan)for(let[f,g]of h.entries())g.alpha&&
ea(n,e,f,$(c,f),g,r.plan[f]??0);r.you!==null&&(r.fog&&zo(n,e,...jr(e,r.you,t)),Ho(n,h[r.you],s)),o.lineWidth=Math.max(2,2.5*s),o.strokeStyle=i.focus;let y=r.selected===
null?void 0:h[r.selected];y?.alpha&&ta(n,y.x,y.y,y.size*.96),r.cursor&&(o.setLineDash([a.cell*.12,a.cell*.08]),ta(n,r.cursor[1]+.5,r.cursor[0]+.5,.8),o.setLineDash(
[]))}function ta({ctx:n,grid:e},t,r,s){let o=s*e.cell;n.beginPath(),n.roundRect(e.left+t*e.cell-o/2,e.top+r*e.cell-o/2,o,o,o*.1),n.stroke()}var na=(n,e)=>(e+.24)/(n+.24);function An(n,e,t,r,s,o){let a=t?28*o:0,i=(c,u)=>(c-a)/(u+2*.12),l=Math.max(1,Math.floor(Math.min(i(r,e),i(s,n))));return{rows:n,cols:e,
cell:l,left:Math.round((r-e*l+a)/2),top:Math.round((s-n*l+a)/2)}}function ra(n,e,t){let r=Math.floor((t-n.top)/n.cell),s=Math.floor((e-n.left)/n.cell);return r>=
0&&r<n.rows&&s>=0&&s<n.cols?[r,s]:null}var ic=["paper","line","frame","ink","muted","obstacle"],lc=["pursuer","evader","capture","collision","focus"];function tt(n){let e=getComputedStyle(n),t=(r,s)=>[
r,e.getPropertyValue(s+r).trim()];return Object.fromEntries([...ic.map(r=>t(r,"--board-")),...lc.map(r=>t(r,"--"))])}var xe=()=>matchMedia("(prefers-reduced-motion: reduce)").matches,ke=class{canvas;#e=null;#n=0;#t;#r={rows:1,cols:1,left:0,top:0,cell:1};#a=0;constructor(e,t={}){
this.canvas=e,e.classList.add("board"),e.setAttribute("role","img"),this.#t={...xn,...t},new ResizeObserver(()=>this.#c()).observe(e),new MutationObserver(()=>this.
redraw()).observe(document.documentElement,{attributes:!0}),addEventListener("beforeprint",()=>this.drawNow())}set look(e){this.#t={...this.#t,...e},this.#o(),this.
redraw()}show(e,t){this.#e=e,this.#n=Math.min(Math.max(0,t),e.moments.length-1),this.#o(),this.redraw()}redraw(){this.#a||(this.#a=requestAnimationFrame(()=>this.
drawNow()))}drawNow(){cancelAnimationFrame(this.#a),this.#a=0;let e=this.canvas.getContext("2d");if(!e||!this.#e)return;let{rows:t,cols:r}=this.#e,s=devicePixelRatio||
1;this.#r=An(t,r,this.#t.axes,this.canvas.width,this.canvas.height,s);let o={ctx:e,grid:this.#r,colors:tt(this.canvas)};Sn(o,this.#e,this.#n,this.#t,s)}cellAt(e,t){
let r=this.canvas.getBoundingClientRect(),s=this.canvas.width/r.width;return ra(this.#r,(e-r.left)*s,(t-r.top)*s)}agentAt(e,t){let r=this.cellAt(e,t);if(!r||!this.#e)
return null;let s=this.#e.moments[Math.round(this.#n)],o=Mt(this.#e,s).get(r[0]*this.#e.cols+r[1])??[],a=vn(this.#e,Math.round(this.#n)),i=l=>{let[c,u]=this.pointOf(
a[l].x,a[l].y);return Math.hypot(c-e,u-t)};return o.length?o.reduce((l,c)=>i(c)<i(l)?c:l):null}pointOf(e,t){let r=this.canvas.getBoundingClientRect(),s=r.width/
this.canvas.width,{left:o,top:a,cell:i}=this.#r;return[r.left+(o+e*i)*s,r.top+(a+t*i)*s]}#o(){if(!this.#e)return;let{rows:e,cols:t}=this.#e;this.canvas.style.setProperty(
"--board-aspect",String(na(e,t)))}#c(){let e=devicePixelRatio||1,{width:t,height:r}=this.canvas.getBoundingClientRect();this.canvas.width=Math.max(1,Math.round(
t*e)),this.canvas.height=Math.max(1,Math.round(r*e)),this.drawNow()}};var Tt=[.5,1,2,4,8,16,32,64],Mn=0,Tn=12,cc=2,_e=class extends EventTarget{#e;#n;#t;#r=0;#a=0;#o=!1;#c=null;#d=0;#h=[];#p=[];glide=.28;constructor(e,{speed:t=4,still:r=!1}={}){
super(),this.#e=e,this.#n=t,this.#t=r}get step(){return this.#r}get time(){return this.#t?this.#r:this.#a}get arrived(){return this.#a===this.#r}get playing(){return this.#o}get length(){
return this.#e}set length(e){this.#e=e,this.#r>e&&this.jump(e),this.#i("state")}get marks(){return this.#h}set marks(e){this.#h=e,this.#i("state")}get ticks(){return this.#p}set ticks(e){
this.#p=e,this.#i("state")}get pace(){return this.#n||Math.max(cc,this.#e/Tn)}get speed(){return this.#n}set speed(e){this.#n=e,this.#i("state")}changeSpeed(e){
let t=Tt.findIndex(r=>r>=this.pace);this.speed=Tt[Math.min(Tt.length-1,Math.max(0,t+e))]}play(){this.#o||!this.#e||(this.#r===this.#e&&this.jump(0),this.#o=!0,this.#i(
"state"),this.#m())}pause(){this.#o&&(this.#o=!1,this.#i("state"))}toggle(){this.#o?this.pause():this.play()}move(e){this.pause();let t=Math.min(this.#e,Math.max(
0,this.#r+e));Math.abs(t-this.#a)>1?this.jump(t):this.#y(t),this.#m()}jump(e){this.#a=Math.min(this.#e,Math.max(0,Math.round(e))),this.#y(this.#a),this.#i("fram\
e")}#y(e){e!==this.#r&&(this.#r=e,this.#i("step"),this.#t&&this.#i("frame"))}#m(){this.#c===null&&(this.#d=performance.now(),this.#c=requestAnimationFrame(()=>this.#s()))}#s(){
this.#c=null;let e=performance.now();this.#l(Math.min(.25,(e-this.#d)/1e3)),this.#d=e,(!this.#t||this.arrived)&&this.#i("frame"),(this.#o||this.#a!==this.#r)&&(this.#c=
requestAnimationFrame(()=>this.#s()))}#l(e){let t=e;for(;t>0;){if(this.#a===this.#r){if(!this.#o)return;if(this.#r===this.#e)return this.pause();this.#y(this.#r+
1)}let r=this.#o?this.pace:1/this.glide,s=this.#r-this.#a,o=Math.min(Math.abs(s),t*r);t-=o/r,this.#a=o===Math.abs(s)?this.#r:this.#a+Math.sign(s)*o}this.#o&&this.#a===
this.#e&&this.pause()}#i(e){this.dispatchEvent(new Event(e))}};function En(n,e){if(e.ctrlKey||e.metaKey||e.altKey)return!1;let t=e.shiftKey?10:1,s={" ":()=>n.toggle(),
ArrowRight:()=>n.move(t),ArrowLeft:()=>n.move(-t),Home:()=>n.move(-n.length),End:()=>n.move(n.length),"+":()=>n.changeSpeed(1),"-":()=>n.changeSpeed(-1)}[e.key];
return s?.(),s!==void 0}var uc={first:"M6 5v14M19 5 9 12l10 7z",back:"M17 5 7 12l10 7z",play:"M7 4.5 19 12 7 19.5z",pause:"M8 5v14M16 5v14",forward:"M7 5l10 7-10 7z",last:"M18 5v14M5 5\
l10 7-10 7z"};function sa(n){return S("svg",{viewBox:"0 0 24 24","aria-hidden":"true",class:"icon"},S("path",{d:uc[n]}))}function Et(n,e,t,r){return d("button",
{type:"button",class:"player-button","aria-label":e,title:`${e} (${t})`,onclick:r},sa(n))}function On(n){let e=Et("play","Play","Space",()=>n.toggle()),t=d("inp\
ut",{type:"range",class:"player-scrub",min:0,step:1,"aria-label":"Step",oninput:()=>{n.pause(),n.jump(Number(t.value))}}),r=d("div",{class:"captures","aria-hidd\
en":"true",title:"Captures"}),s=d("div",{class:"losses","aria-hidden":"true"}),o=d("select",{class:"player-speed","aria-label":"Speed",title:`Steps a second, or\
 the whole in ${Tn} s (+ and -)`,onchange:()=>n.speed=Number(o.value)},d("option",{value:Mn},`in ${Tn} s`),...Tt.map(h=>d("option",{value:h},`${h} / s`))),a=d("\
output",{class:"player-count"}),i=d("div",{class:"player",role:"group","aria-label":"Player"},Et("first","First step","Home",()=>n.move(-n.length)),Et("back","S\
tep back","←",()=>n.move(-1)),e,Et("forward","Step forward","→",()=>n.move(1)),Et("last","Last step","End",()=>n.move(n.length)),d("div",{class:"scrub"},r,s,
t),a,o),l=(h,m={})=>{let p=d("i",m);return p.style.left=`${100*h/Math.max(1,n.length)}%`,p},c=()=>{r.replaceChildren(...n.marks.map(h=>l(h))),s.replaceChildren(
...n.ticks.map(({step:h,kind:m,size:p,text:y})=>{let f=l(h,{class:m,title:`Step ${h}: ${y}`});return f.style.height=`${100*p}%`,f}))},u=()=>{e.replaceChildren(sa(
n.playing?"pause":"play")),e.ariaLabel=n.playing?"Pause":"Play",e.title=`${e.ariaLabel} (Space)`,t.max=String(n.length),t.value=String(n.step),t.ariaValueText=`\
step ${n.step} of ${n.length}`,a.textContent=`${n.step} / ${n.length}`,a.style.minWidth=`${2*String(n.length).length+3}ch`,o.value=String(n.speed)};return n.addEventListener(
"step",u),n.addEventListener("state",u),n.addEventListener("state",c),i.addEventListener("keydown",h=>{!(h.target instanceof HTMLSelectElement||h.key===" "&&h.target!==
t)&&En(n,h)&&h.preventDefault()}),u(),i}function Cn(n,e,t){if(t===0)return[{kind:"start",text:hc(n),agents:[]}];let r=e.moments[t-1],s=e.moments[t],o=u=>se(u,n.config.n_pursuers),a=At(e,r,s),i=n.conflicts(
t),l=new Set(i.flatMap(u=>u.doomed)),c=a.map(u=>({kind:"capture",text:`${o(u)} is captured`,agents:[u]}));for(let u of gn(r,s))!a.includes(u)&&!l.has(u)&&c.push(
{kind:"end",text:`${o(u)} disappears`,agents:[u]});return c.push(...i.map(({kind:u,text:h,agents:m})=>({kind:u,text:h,agents:m}))),t===n.length&&c.unshift({kind:"\
end",text:dc(n),agents:[]}),c}function hc({config:n}){return`${n.n_pursuers} pursuers and ${n.n_evaders} evaders on ${n.rows} x ${n.cols} cells, at most ${n.max_steps}\
 steps`}function dc(n){let e=Math.round(n.statistics.capture_rate*n.config.n_evaders);return`The episode ends after ${n.length} steps with ${e} of ${n.config.n_evaders}\
 evaders captured`}var zr=.005,aa=.05,mc=4,nt=new Map;function Rn(n,e,t="capture-rate"){let r=JSON.stringify([{...e,rewards:null},t]),s=nt.get(r)??(Kt(e)?Promise.resolve(null):pc(
n,e,t));return nt.delete(r),nt.set(r,s),nt.size>mc&&nt.delete([...nt.keys()][0]),s}var ia=({n_evaders:n})=>n===1?"capture-time":"capture-rate",oa=()=>new Promise(
n=>setTimeout(n));async function pc(n,e,t){await oa();let r=n.solution(e,t);for(;r.goBack();)await oa();return r}function kn(n,e,t){let{payoff:r}=n;return t.flatMap(
(s,o)=>{let a=[0,0];for(let l=e.n_turns;l>0&&!e.over;l--)n.game(e)?.lost(s).forEach((c,u)=>a[u]+=c),e.playTurn(s);let i=r==="capture-rate"?zr:aa;return A.map((l,c)=>({
step:o+1,team:l,lost:a[c],payoff:r})).filter(l=>l.lost>=i)})}var _n=n=>n.map(e=>({step:e.step,kind:e.team,size:e.lost/Math.max(1,...n.map(({lost:t})=>t)),text:Ot(
e)})),la=({lost:n,payoff:e})=>e==="capture-rate"?`${n.toFixed(2)} of the capture rate`:`${n.toFixed(1)} steps`,Ot=n=>`The ${n.team}s lose ${la(n)} against a per\
fect opponent`;function ca(n){let e=n.reduce((t,r)=>r.lost>t.lost?r:t);return`Your team's worst moves, in step ${e.step}, lost ${la(e)} against a perfect oppone\
nt.`}function ua({config:n,payoff:e},{value:t},r){if(e==="capture-rate")return`value ${t.toFixed(2)}`;let s=1-t,o=Math.min(n.max_steps-r,hr);return s>o-aa?`free\
 for ${o} steps`:`captured after ${s.toFixed(1)} steps`}function ha(n,e){return(n.marginal(e)??[]).map((r,s)=>({share:r,action:s})).filter(({share:r})=>r>=zr).sort(
(r,s)=>s.share-r.share).map(({share:r,action:s})=>r>1-zr?te[s]:`${te[s]} ${r.toFixed(2)}`).join(", ")}var da=["·","↑","→","↓","←","↗","↘","↙","↖"];var fc={" ":0,ArrowUp:1,w:1,ArrowRight:2,d:2,ArrowDown:3,s:3,ArrowLeft:4,a:4,e:5,c:6,y:7,z:7,q:8},Hr=[8,1,5,4,0,2,7,3,6],yc=[7,8,9,4,5,6,1,2,3],gc=24,vc=Math.tan(
Math.PI/8);function pa(n,e){if(n.ctrlKey||n.metaKey||n.altKey)return;let t=yc.findIndex(s=>n.code===`Numpad${s}`),r=Hr[t]??fc[n.key.length===1?n.key.toLowerCase():
n.key];return r!==void 0&&r>4&&!e?void 0:r}function fa(n){let e=Hr.map(t=>d("button",{type:"button","aria-label":te[t],onclick:()=>n(t)},da[t]));return{element:d(
"div",{class:"play-pad",role:"group","aria-label":"Your move"},...e),show:t=>e.forEach((r,s)=>r.classList.toggle("absent",Hr[s]>4&&!t))}}function ma(n,e,t){let r=vc*
Math.max(Math.abs(n),Math.abs(e)),s=o=>Math.abs(o)<r?0:o;return To([0,0],t?[s(n),s(e)]:[n,e],t)}function ya(n,e,t){let r=null,{canvas:s}=n;s.addEventListener("p\
ointerdown",({button:o,clientX:a,clientY:i})=>r=o===0?[a,i]:null),s.addEventListener("pointercancel",()=>r=null),s.addEventListener("pointerup",({clientX:o,clientY:a})=>{
let i=r,l=e();if(r=null,!i||!l)return;let c=o-i[0],u=a-i[1],h=n.cellAt(o,a);Math.hypot(c,u)>=gc?t(ma(u,c,l.diagonal)):h&&t(ma(h[0]-l.cell[0],h[1]-l.cell[1],l.diagonal))})}
function ga(n,e){let t=r=>{let s=e[r]-n[r],o=Xe.findIndex(a=>a[r]===Math.sign(s)&&a[1-r]===0);return s?`${Math.abs(s)} ${te[o]}`:""};return[t(0),t(1)].filter(Boolean).
join(", ")||"on your cell"}var wa="NUMPY\0",va=wa.length+2,ba=64;function Ct(n){return rn(Object.fromEntries(Object.entries(n).map(([e,t])=>[`${e}.npy`,bc(t)])))}function bc({dtype:n,shape:e,
data:t}){let r=typeof t=="string"?Array.from(t,u=>u.codePointAt(0)):null,s=e.map(u=>`${u}, `).join(""),o=`{'descr': '${r?`<U${r.length}`:n}', 'fortran_order': F\
alse, 'shape': (${s}), }`,a=Math.ceil((va+o.length+1)/ba)*ba-va,i=wa+String.fromCharCode(a&255,a>>8)+o.padEnd(a-1)+`
`,l=r?Int32Array.from(r):t,c=new Uint8Array(i.length+l.byteLength);return c.set(Ie(i,!0)),c.set(new Uint8Array(l.buffer,l.byteOffset,l.byteLength),i.length),c}var wc="matrixworld episode 3";function xa(n,e,t){let{config:r,actions:s,length:o,recording:a}=e,i=r.n_pursuers+r.n_evaders,l=r.n_evaders,c={positions:["<i4",i,
2],last_positions:["<i4",i,2],alive:["|b1",i],captured:["|b1",l],ever_captured:["|b1",l]},u={rewards:["<f4",i],involved:["|b1",i,3],fault:["|b1",i,3]},h={},m=x=>{
for(let v of Object.keys(x))(h[v]??=[]).push(Array.from(p.read(v),Number))},p=n.world(r);p.reset(e.start);let y=[];m(c);for(let x of s)p.step(x),m({...c,...u}),
y.push(...p.conflictTable());p.free();let f={"<i4":Int32Array,"<f4":Float32Array,"|b1":Uint8Array},g={};for(let[x,[v,...E]]of Object.entries({...c,...u})){let R=o+
+(x in c);g[x]={dtype:v,shape:[R,...E],data:f[v].from((h[x]??[]).flat())}}let b=x=>({dtype:"<i8",shape:[],data:Int32Array.of(x,0)}),w=x=>({dtype:"<U",shape:[],data:x});
return Ct({format:w(wc),n_pursuers:b(r.n_pursuers),config:w(JSON.stringify(r)),seat:b(t),...g,actions:{dtype:"|i1",shape:[o,i],data:Int8Array.from(s.flatMap(x=>[
...x]))},map:{dtype:"|b1",shape:[r.rows,r.cols],data:Uint8Array.from(a.obstacles,Number)},conflict_table:{dtype:"<i4",shape:[y.length/11,11],data:Int32Array.from(
y)}})}var xc=[0,1,2,4,8],$n=class{element;player=new _e(0,{speed:4,still:xe()});#e;#n;#t=d("canvas",{tabindex:0,"aria-describedby":"play-keys"});#r=d("h2");#a=d("p",{
class:"play-told",role:"status"});#o=fa(e=>this.act(e));#c=ee(xc.map(e=>[e,e?`${e} / s`:"step by step"]),()=>this.#E());#d=d("input",{type:"checkbox",onchange:()=>this.#x()});#h=d(
"input",{type:"checkbox",onchange:()=>this.#O()});#p=d("label",{class:"play-choice"},this.#h,"Best move");#y=d("p",{class:"small muted play-keys",id:"play-keys"});#m=d(
"section",{class:"play-ending",tabindex:-1,"aria-labelledby":"play-headline"});#s=On(this.player);#l=null;#i=null;#f=[];#g=null;#w=null;#b=[];#v=0;#u=0;constructor(e){
this.#e=e,this.#n=new ke(this.#t,{numbers:!1}),this.#t.setAttribute("role","application"),ya(this.#n,()=>{let t=this.#g!==null&&this.#i&&$(this.#i.recording.moments.
at(-1),this.#g);return t?{cell:t,diagonal:this.#i.config.diagonal}:null},t=>this.act(t)),this.player.addEventListener("frame",()=>this.#i&&this.#n.show(this.#i.
recording,this.player.time)),this.player.addEventListener("step",()=>this.#O()),this.element=d("div",{class:"play"},d("header",{class:"play-head"},this.#r,this.#a),
d("div",{class:"play-stage"},this.#t),d("div",{class:"play-side"},this.#m,this.#o.element,d("label",{class:"play-choice",title:"Steps a second"},"Pace ",this.#c),
d("label",{class:"play-choice"},this.#d,d("span",{},"Fog",d("span",{class:"at-length"},": see only what it sees"))),this.#p,this.#y),this.#s)}get played(){return this.#l&&
{...this.#l.played,moves:this.#f}}get live(){return this.#i}play(e){this.#A(bt(this.#e,e.played),e.played.seat,e.title),this.#l=e,this.#f=[...e.played.moves],this.#v=
0,this.element.dataset.state="playing",this.#t.focus({preventScroll:!0}),en(this.#i,e.played.seat)&&this.#$()}watch(e,t,r){this.#l=null,this.#A(e,t,r),this.#P()}stop(){
this.#E(),this.player.pause(),this.#l=null}act(e){let t=this.#l,r=this.#i;if(!t||!r||this.element.dataset.state!=="playing")return;this.#v=e;let s=Number(this.#c.
value);this.#u||(this.#k(),s&&this.element.dataset.state==="playing"&&(this.#u=setInterval(()=>this.#k(),1e3/s)))}key(e){let{target:t,key:r}=e;if(t instanceof HTMLSelectElement||
t instanceof HTMLInputElement&&(t.type==="text"||r===" ")||t instanceof HTMLButtonElement&&(r===" "||r==="Enter")||!this.#i)return!1;if(this.element.dataset.state!==
"playing")return En(this.player,e);let o=pa(e,this.#i.config.diagonal);return o!==void 0&&this.act(o),o!==void 0}#A(e,t,r){this.#E(),this.player.pause(),this.#i=
e,this.#g=t,this.#r.textContent=r,this.#t.ariaLabel=`Board, ${e.config.rows} by ${e.config.cols} cells`,this.#o.show(e.config.diagonal),this.#y.replaceChildren(
d("span",{class:"at-length"},`W A S D or the arrow keys move, Space stays${e.config.diagonal?"; Q E Z C and the numeric keypad move diagonally":""}. `),"On the \
board: swipe, or tap where to go."),this.#S(e),this.#m.replaceChildren(),this.player.length=e.length,this.player.jump(e.length),this.#O()}#x(){this.#n.look={you:this.#g,
fog:this.#d.checked,viewers:this.#g===null?[]:[this.#g],plan:this.#T()}}#S(e){this.#w=null,this.#b=this.player.ticks=[],this.#p.hidden=this.#h.disabled=!!Kt(e.config),
Rn(this.#e,e.config,ia(e.config)).then(t=>{this.#i===e&&(this.#w=t,this.#R(),this.#O())})}#R(){let e=this.#i,t=this.#w;if(!t||this.element.dataset.state==="play\
ing")return;let r=this.#e.world(e.config);r.reset(e.start),this.#b=kn(t,r,e.actions),r.free(),this.player.ticks=_n(this.#b)}get#M(){return this.#h.checked&&this.#l&&
this.element.dataset.state==="playing"&&this.#w&&this.#i.game(this.#w)||null}#T(){let e=this.#g,t=this.#g!==null&&this.#M?.marginal(this.#g);return e!==null&&t?
Object.assign(Array(e).fill(0),{[e]:t.indexOf(Math.max(...t))}):null}#E(){clearInterval(this.#u),this.#u=0,this.#a.ariaLive=Number(this.#c.value)?"off":"polite"}#k(){
let{policies:e,seat:t}=this.#l.played,r=this.#i;r.step(e,t,this.#v),this.#f.push(this.#v),this.player.length=r.length,this.player.glide=Math.min(.22,.9/(Number(
this.#c.value)||4)),this.player.move(r.length-this.player.step),en(r,t)&&this.#$()}#$(){this.#E();let e=this.#l,t=this.#i,r=this.played,s=de()?e.link(r):null,o=`${se(
r.seat,t.config.n_pursuers)}-${t.length}-steps.npz`,a=()=>qe(o,xa(this.#e,t,r.seat)),i=qt("Link to this match");i.hidden=!0,this.#m.replaceChildren(d("h3",{id:"\
play-headline"},Mc(t,r.seat)),...e.ending(t,r),d("div",{class:"play-buttons"},d("button",{type:"button",class:"primary",onclick:()=>e.again()},"Again"),d("butto\
n",{type:"button",onclick:()=>this.#P()},"Watch it"),d("button",{type:"button",onclick:a},"Save"),s&&d("button",{type:"button",onclick:()=>Jt(i,s)},e.linkName??
"Link")),i),this.element.dataset.state="ended",this.player.jump(t.length),this.#R();let l=this.#b.filter(({team:c})=>c===me(t.config,r.seat));l.length&&this.#m.
children[0].after(d("p",{class:"small muted"},ca(l))),this.#m.focus({preventScroll:!0}),this.#m.scrollIntoView({block:"nearest"})}#P(){this.element.dataset.state=
"watched",this.player.length=this.#i.length,this.player.jump(0),xe()||this.player.play()}#O(){let e=this.#i,t=this.#g,{step:r}=this.player;if(!e||r>e.length)return;
let s=Cn(e,e.recording,r).filter(({agents:l})=>t===null||l.includes(t)),o=this.#l&&r===0,a=o?[Sc(e.config,t),this.#l.about??""]:[`Step ${r} of ${e.config.max_steps}`,
...s.map(({text:l})=>l)];!o&&t!==null&&a.push(Ac(e,r,t)),a.push(...this.#b.filter(l=>l.step===r).map(Ot));let i=r===e.length&&t!==null?this.#M:null;i&&a.push(`P\
erfect play: ${ha(i,t)||"decided in its turn"}; ${ua(this.#w,i,r)}`),this.#x(),this.#a.textContent=a.filter(Boolean).map(l=>`${l}.`).join(" ")}};function Sc(n,e){
let t=n.rules.capture==="SURROUND";return me(n,e)==="evader"?`Run away: you win if ${t?"the pursuers do not surround you":"no pursuer reaches your cell"} in ${n.
max_steps} steps`:`Capture evaders: ${t?"surround them with your team":"move onto their cells"}`}function Ac({config:n,recording:e},t,r){let s=e.moments[t],o=me(
n,r),a=ce(o);if(!s.alive[r])return"";let i=$(s,r),l=h=>{let[m,p]=$(s,h);return Math.max(Math.abs(m-i[0]),Math.abs(p-i[1]))},c=Array.from({length:s.alive.length},
(h,m)=>m).filter(h=>me(n,h)===a&&s.alive[h]&&!s.captured[h-n.n_pursuers]&&2*l(h)<n.fov);if(!c.length)return`No ${a} in view`;let u=c.reduce((h,m)=>l(m)<l(h)?m:h);
return`Nearest ${a}: ${ga(i,$(s,u))}`}function Mc(n,e){let{lasted:t,out:r,captured:s}=ve(n,e),{config:o}=n;return me(o,e)==="pursuer"?`Your team captured ${s} o\
f ${Tc(o)} in ${t} steps.`:r?`You lasted ${t} of ${o.max_steps} steps.`:`You escaped: ${t} steps.`}var Tc=({n_evaders:n})=>`${n} evader${n===1?"":"s"}`;var Ec=60,Oc={evader:"Can you escape them?",pursuer:"Can you catch them?"},Pn=class{dialog=d("dialog",{class:"take-over","aria-label":"Play against the champion\
s",onclose:()=>this.view?.stop(),onkeydown:e=>this.view?.key(e)&&e.preventDefault()});view=null;#e;#n;constructor(e,t){this.#e=e,this.#n=t}play(e,{world:t,policies:r,
players:s,seed:o,rate:a,friend:i},l){this.view||(this.view=new $n(this.#e),this.dialog.append(d("button",{type:"button",class:"leave",onclick:()=>this.dialog.close()},
"Close"),this.view.element)),this.dialog.open||this.dialog.showModal();let c={...t,max_steps:Math.min(Ec,t.max_steps)},u=e==="evader"?c.n_pursuers:0,h=({lasted:f,
captured:g})=>e==="evader"?f:g,m=e==="evader"?c.max_steps:c.n_evaders,p=f=>e==="evader"?`survived ${f} of ${m} steps`:`caught ${f} of ${m} with the team`,y=f=>({
pursuer:r.pursuer.genome,evader:r.evader.genome,seed:String(f.seed),episode:f.episode,seat:u,rate:a,score:h(ve(bt(this.#e,f),u))});Dr(this.#e,this.view,{config:c,
seed:BigInt(l.seed),episode:l.episode,policies:r,seat:u,from:0,moves:[]},{title:Oc[e],players:s,linkName:"Challenge a friend",about:`Seed ${o}: these pursuers c\
atch ${a} %. ${i?`Your friend ${p(i.score)}`:"You have the seat with the ring"}`,told:f=>{if(!i)return"";let g=h(f);return g>i.score?`You beat your friend, who ${p(
i.score)}.`:`Your friend ${p(i.score)}: ${g===i.score?"a draw":"not beaten yet"}.`},link:f=>this.#n(y(f))})}};var G=(n,e=2)=>n==null?"-":n.toFixed(e);function Sa(n,e,t){return e===null||t===null?G(n):`${G(n)} (${G(e)} to ${G(t)})`}function rt(n){let e=Math.abs(n),t=e>=1e4?
e.toExponential(0):e.toFixed(e<100?2:0);return n<0&&Number(t)?`−${t}`:t}var Nn=n=>n.charAt(0).toUpperCase()+n.slice(1);function Rt(n,e,t,r=!1){let s=(e-n)/Math.max(1,t),o=10**Math.floor(Math.log10(s||1)),a=[1,2,5,10].map(c=>c*o).find(
c=>c>=s)??10*o;r&&(a=Math.max(1,Math.round(a)));let i=Math.ceil(n/a-1e-9),l=Math.floor(e/a+1e-9);return Array.from({length:Math.max(0,l-i+1)},(c,u)=>(i+u)*a)}var Vr={right:12,top:10,bottom:42},Ln={x:56,y:34,letter:8,label:30};function Aa(n,e,t,r){let{top:s}=Vr,o=Math.max(s+40,e-Vr.bottom),a=Rt(r.low,r.high,(o-s)/Ln.y,
r.whole),i=Ln.label+Ln.letter*Math.max(2,...a.map(g=>Kr(g).length)),l=Math.max(i+40,n-Vr.right),c=(g,b,w)=>x=>b+(x-g.low)/(g.high-g.low||1)*(w-b),u=c(t,i,l),h=c(
r,o,s),m=S("g"),p=S("svg",{width:n,height:e,viewBox:`0 0 ${n} ${e}`,class:"plot"}),y=S("g",{class:"axes"});for(let g of a)y.append(S("line",{x1:i,x2:l,y1:h(g),y2:h(
g),class:"grid"}),S("text",{x:i-8,y:h(g),"text-anchor":"end","dominant-baseline":"middle"},Kr(g)));for(let g of Rt(t.low,t.high,(l-i)/Ln.x,t.whole))y.append(S("\
text",{x:u(g),y:o+16,"text-anchor":"middle"},Kr(g)));return y.append(S("line",{x1:i,x2:l,y1:o,y2:o,class:"axis"}),S("text",{x:(i+l)/2,y:e-6,"text-anchor":"middl\
e",class:"label"},t.label),S("text",{transform:`translate(12 ${(s+o)/2}) rotate(-90)`,"text-anchor":"middle",class:"label"},r.label)),p.append(y,m),{root:p,marks:m,
left:i,right:l,top:s,bottom:o,x:u,y:h,at:g=>{let b=g-p.getBoundingClientRect().left;return t.low+(b-i)/(l-i)*(t.high-t.low)}}}var Kr=n=>String(Number(n.toPrecision(
6))).replace("-","−");function Ma(n,e,t,r){let s="",o="M";t.forEach((a,i)=>{a===null?o="M":(s+=`${o}${n.x(e[i]).toFixed(1)} ${n.y(a).toFixed(1)}`,o="L")}),n.root.
insertBefore(S("path",{d:s,class:`line ${r}`}),n.marks)}function Ta(...n){return d("p",{class:"legend small"},...n.map(([e,t])=>d("span",{class:`key ${t}`},e)))}function Ea(n,e,t=()=>{},r=()=>{}){let s=d("div",{class:"\
chart chooses",role:"img","aria-label":n}),o=null,a=()=>{o?.marks.replaceChildren(),o&&t(o)};s.addEventListener("click",l=>o&&r(o.at(l.clientX),o,l));let i=()=>{
let{clientWidth:l,clientHeight:c}=s;l<50||c<50||(o=e(l,c),s.replaceChildren(o.root),a())};return new ResizeObserver(i).observe(s),{element:s,update:a,redraw:i}}var Oa=0,Ca=1,Cc=2,Rc=176;function ka(n,e,t,r){let s=devicePixelRatio||1,o=tt(n);n.width=n.height=Rc*s;let a=n.getContext("2d");if(!a)return;let{fov:i}=e,l=n.width/
i;a.fillStyle=o.paper,a.fillRect(0,0,n.width,n.height);for(let u=0;t&&u<i*i;u++){let h=(u%i+.5)*l,m=(Math.floor(u/i)+.5)*l,p=f=>!!t[f*i*i+u];p(Cc)&&(a.fillStyle=
o.obstacle,a.fillRect(h-l/2,m-l/2,l,l));let y=p(Oa)&&p(Ca)?l*.18:0;p(Oa)&&Ra(a,De,h+y,m+y,l*.74,o.evader),p(Ca)&&Ra(a,bn,h-y,m-y,l*.86,o.pursuer)}a.strokeStyle=
r<e.n_pursuers?o.pursuer:o.evader,a.lineWidth=2*s;let c=Math.floor(i/2)*l;a.strokeRect(c,c,l,l)}function Ra(n,e,t,r,s,o){e(n,t,r,s),n.fillStyle=o,n.fill()}var kc=["stay","↑","→","↓","←","↗","↘","↙","↖"];function _a(n,{inputs:e,ratings:t,refused:r},s,o){let a=go(n,o),i=y=>a?a[n.inputs[y]]??0:1,l=y=>a||
!o?i(y)!==0:new RegExp(`\\b${n.inputs[y]}\\b`).test(o.expression),c=[...n.inputs.keys()].filter(l).sort((y,f)=>Math.abs(i(f))-Math.abs(i(y))),u=y=>`${y===s?"tak\
en":""} ${r[y]?"refused":""}`,h=(y,f)=>d("tr",{class:f.every(g=>g===f[0])?"same":""},y,...Array.from(f,(g,b)=>d("td",{class:u(b)},rt(g)))),m=y=>{let f=n.inputs[y];
return d("th",{scope:"row",title:`${a?`weight ${rt(i(y))} x `:""}${Pe[f]}`},f.replaceAll("_"," "))},p=d("table",{class:"why numbers"},d("thead",{},d("tr",{},d("\
th",{},a?"term":"input"),...Array.from(t,(y,f)=>d("th",{scope:"col",class:u(f),title:te[f],"aria-label":te[f]},kc[f]))),h(d("th",{scope:"row"},a?"sum":"rating"),
t)),d("tbody",{},...c.map(y=>h(m(y),e[y].map(f=>i(y)*f)))));return[...o?[d("p",{class:"expression"},d("code",{},o.expression))]:[],d("div",{class:"wide-table",tabindex:0,
role:"group","aria-label":"How the moves are rated"},p)]}var _c=(n,{pursuer:e,evader:t})=>({pursuers:Ce(n,"pursuer",e),evaders:Ce(n,"evader",t)}),$a="What it remembers: a number for each unit, from -1 to 1",st=class{element;#e;#n=d(
"canvas",{class:"seen",role:"img"});#t=d("h3");#r=d("p",{class:"small muted"});#a=d("div",{class:"answers"});#o=d("div",{title:$a});#c=null;#d=null;#h=null;#p=null;#y=null;#m=null;#s=null;#l=0;constructor(e){
this.#e=e,this.element=d("div",{class:"inspector","data-open":"false"},d("p",{class:"hint small muted"},"Click an agent, or press A: what it sees, and why it ta\
kes its move."),d("div",{class:"inspected"},this.#n,d("div",{class:"answer"},this.#t,this.#r,this.#o),this.#a))}get agent(){return this.#s}show(e,t,r,s,o=_c(t,s)){
this.#c?.free(),this.#c=e.world(r.config),this.#h!==t&&(this.#d=null,this.#s!==null&&this.choose(null)),this.#h=t,this.#p=r,this.#y=s,this.#m=o}set solution(e){
this.#d=e,this.at(this.#l)}choose(e){this.#s=e,this.element.dataset.open=String(e!==null),this.#e(e),this.at(this.#l)}next(e){let t=this.#p;if(!t)return;let r=this.#s??
(e>0?-1:0);for(let s=0;s<t.n_agents;s++)if(r=(r+e+t.n_agents)%t.n_agents,t.alive[this.#l*t.n_agents+r])return this.choose(r)}at(e){this.#l=e;let t=this.#p,r=this.#c,
s=this.#h,o=this.#y,a=this.#m,i=this.#s;if(!t||!r||!s||!o||!a||i===null)return;let l=i<t.config.n_pursuers?"pursuer":"evader";this.#o.replaceChildren(),this.#t.
replaceChildren(d("span",{class:l},se(i,t.config.n_pursuers))),t.seek(r,e,a);let c=t.actions.subarray(e*t.n_agents,(e+1)*t.n_agents);for(;c.length&&!r.over&&(i<
r.actors[0]||i>=r.actors[1]);)r.playTurn(c);let u=!!(t.alive[e*t.n_agents+i]&&r.read("alive")[i]);ka(this.#n,t.config,u?r.view(i):null,i),this.#n.ariaLabel=`Fie\
ld of view of ${se(i,t.config.n_pursuers)}: evaders, pursuers and obstacles around it`;let h=c[i]??null;if(!u)return this.#i([],"It is gone.");let m=a[`${l}s`],
p=typeof m!="string"&&m.kind==="cells"?r.answer(m,i):null,y=p?.probabilities??null;p?.memory.length&&this.#o.replaceChildren(d("p",{class:"small muted"},"It rem\
embers:"),Lc(p.memory));let f=typeof m!="string"&&m.kind!=="cells"?_a(m,r.rate(m,i),h,yo(s,l,o[l])):[],g=this.#d?.game(r)??null,b=[["network",y],["perfect",g?.marginal(
i)??null]],w=x=>d("p",{class:"small muted"},x);this.#i([...g?[w(`Value ${g.value.toFixed(2)} under perfect play.`)]:[],...Pc(b,h),...f],h===null?"The episode is\
 over.":$c(m,h))}#i(e,t){this.#a.replaceChildren(...e),this.#r.textContent=t}};function $c(n,e){return typeof n=="string"?`The script "${n}" plays for it; it go\
es ${te[e]}.`:n.kind!=="cells"?"It takes the best move that its mask allows; of equal ones any.":n.sampled?"Its action is drawn from these probabilities.":"It t\
akes the most probable action."}function Pc(n,e){let t=n.filter(([,o])=>o);if(!t.length)return[];let r=d("div",{class:"action muted"},d("span"),...t.map(([o])=>d(
"span",{class:"head"},o))),s=Array.from(t[0][1],(o,a)=>d("div",{class:a===e?"action taken":"action"},d("span",{},te[a]),...t.flatMap(([,i])=>Nc(i[a]))));return t.
length>1||t[0][0]!==n[0][0]?[r,...s]:s}function Nc(n){let e=d("span",{class:"filled"});return e.style.width=`${100*n}%`,[d("span",{class:"track"},e),d("span",{class:"\
numbers"},n.toFixed(2))]}function Lc(n){let e=Array.from(n,t=>{let r=d("span",{title:t.toFixed(2)});return r.style.transform=`scaleY(${t})`,r});return d("div",{
class:"units",role:"img","aria-label":$a},...e)}var Ic=40,In=class{element;#e;#n=d("div",{class:"episodes",role:"group","aria-label":"Episodes of this cell"});#t=d("p",{class:"check small numbers","aria-live":"\
polite"});constructor(e){this.#e=e,this.element=d("div",{class:"strip-of-episodes"},this.#n,this.#t)}show(e,t){let{pursuer:r,evader:s,episode:o,seed:a}=this.#e.
selected,i=Re(e,r,s);this.#n.replaceChildren(...(i?.rates??[]).slice(0,Ic).map((m,p)=>this.#r(m,p)));let l=a===null?i?.rates[o]:void 0,c=t.statistics.capture_rate,
u=l!==void 0&&Math.abs(c-l)<1e-6&&t.length===i?.lengths[o],h=i?"Not an episode of the evaluation":"The evaluation played no episodes of this pair.";this.#t.dataset.
equal=String(u),this.#t.textContent=u?"As in the evaluation":l===void 0?h:`Episode ${o+1} differs from the evaluation.`,this.#t.title=`Played here: capture rate\
 ${G(c,3)} in ${t.length} steps.${i?` The cell says ${G(i.rate,3)}.`:""}`}#r(e,t){let{selected:r}=this.#e,s=d("span",{class:"bar"});return s.style.height=`${Math.
round(100*e)}%`,d("button",{type:"button",class:"episode",title:`Episode ${t+1}: capture rate ${G(e)}`,"aria-label":`Episode ${t+1}, capture rate ${G(e)}`,"aria\
-pressed":String(t===r.episode&&r.seed===null),onclick:()=>this.#e.select({episode:t,seed:null})},s,d("span",{class:"count"},t+1))}};var Fc=200;function Pa(n,e,{pursuer:t,evader:r},s){let{text:o,image:a}=e.shows[`${t} ${r}`]??{},i=Re(n,t,r)?.rates??[],l=`Scores of the ${e.teams[0]} in ${i.length}\
 episodes: ${i.map(u=>G(u)).join(", ")}`,c=Dc(n,e,t,r);return[o===void 0?null:d("pre",{tabindex:0,"aria-label":"What the game shows of this pair"},o),a===void 0?
null:d("img",{src:a,alt:"What the game shows of this pair",onload:({target:u})=>u.classList.toggle("pixels",u.naturalWidth<Fc)}),...(o??a)===void 0?[d("p",{class:"\
muted"},e.missing),Uc(n,e,t,r,s)]:[],c?d("p",{class:"small numbers"},c):null,i.length>1?d("p",{class:"small numbers"},l):null].filter(u=>u!==null)}function Dc(n,e,t,r){
let{others:s,extras:o={}}=n.payoff,a=s?.[t]?.[r],i=a===void 0?[]:[`score of the ${e.teams[1]} ${G(a)}`];for(let[l,c]of Object.entries(o)){let u=c[t]?.[r];u!==void 0&&
i.push(`${l} ${G(u)}`)}return i.length?`Means of the pair: ${i.join(", ")}`:""}function Uc(n,e,t,r,s){let o=Object.keys(e.shows).map(u=>u.split(" ").map(Number)),
a=([u,h])=>(u-t)**2+(h-r)**2,[i,l]=o.sort((u,h)=>a(u)-a(h))[0]??[];if(i===void 0||l===void 0)return null;let c=`${J(n,"pursuer",i)} against ${J(n,"evader",l)}`;
return d("p",{},d("button",{type:"button",onclick:()=>s.select({pursuer:i,evader:l})},`Nearest: ${c}`))}function Na(n){let e=JSON.stringify(n,(t,r)=>t==="genome"?Array.from(r):r);return d("script",{type:"application/json",id:"champions"},e.replaceAll("<","\\u003c")).
outerHTML}var kt="_",Wc="n",bp=2n**64n-1n;var Yr={fov:11,maxSteps:500,rewards:"paper"},Bc=["rules","others","rewards","size","diagonal","fov","limit","seed","ended","walls","pursuers","evaders","played",
"next"];function Fa(n,e){let t=i=>i.map(l=>Gc(l,e)).join(""),r=i=>`${Math.floor(i/n.cols)}.${i%n.cols}`,s=jc(n.rewards,e),o=[n.seed,n.episode,n.steps].join("."),a={rules:Ia(
n.rules,e),others:n.others?Ia(n.others,e):"",rewards:s===Yr.rewards?"":s,size:`${n.rows}x${n.cols}`,diagonal:n.diagonal?"1":"",fov:n.fov===Yr.fov?"":String(n.fov),
limit:n.maxSteps===Yr.maxSteps?"":String(n.maxSteps),seed:o==="0.0.0"?"":o,ended:n.ended?"1":"",walls:n.walls.map(r).join(kt),pursuers:n.pursuers.map(La).join(kt),
evaders:n.evaders.map(La).join(kt),played:n.played.map(t).join(kt),next:n.next.every(i=>i===Ks)?"":t(n.next)};return Bc.filter(i=>a[i]).map(i=>`${i}=${a[i]}`).join(
"&")}function La({cell:n,gone:e,captured:t,everCaptured:r}){let s=t?"c":r?"e":"";return`${n[0]}.${n[1]}${s}${e?"x":""}`}function Ia(n,e){let t=e.fields.map(({name:r})=>String(
n[r]).toLowerCase());return Ys(n,e.variants)??t.join(".")}function jc(n,e){let t=JSON.stringify(n);return Object.keys(e.rewards).find(s=>JSON.stringify(e.rewards[s])===
t)??Object.values(n).map(s=>String(s)).join(kt)}function Gc(n,e){if(typeof n=="number")return String(n);if(n===Vs)return Wc;let t=e.scripts.findIndex(({name:r})=>r===
n);return String.fromCharCode(97+t)}var zc="/* the engine */";function Da(n,e){return d("button",{type:"button",class:"to-playground",title:"Open this step in the playground (G): the same agents a\
nd actions under any rules",onclick:()=>Hc(n(),e)},"What if?")}function Hc(n,e){let t=n!==null&&n.match.n_agents<=fr&&Math.max(n.match.config.rows,n.match.config.
cols)<=pr,r=t?d("script",{type:"text/plain",id:"scene"},Fa(Vc(n.match,n.step),e)).outerHTML:"",s=new TextDecoder().decode($r("playground")).replace(zc,()=>fe("s\
cript-engine")).replace("</noscript>",i=>i+r+(t?Na(n.champions):"")),o=d("iframe",{title:"Playground",srcdoc:s}),a=d("dialog",{class:"what-if","aria-label":"Wha\
t if?",onclose:()=>a.remove()},d("button",{type:"button",class:"leave",onclick:()=>a.close()},"Back to the match"),o);document.body.append(a),a.showModal()}function Vc(n,e){
let{config:t,n_agents:r}=n,s=Math.max(0,e-1),o=i=>{let l=s*r+i,c=s*t.n_evaders+i-t.n_pursuers,u=h=>i>=t.n_pursuers&&!!h[c];return{cell:[n.last_positions[2*l],n.
last_positions[2*l+1]],gone:!n.alive[l],captured:u(n.captured),everCaptured:u(n.ever_captured)}},a=Array.from({length:r},(i,l)=>o(l));return{rules:t.rules,others:null,
rewards:t.rewards,rows:t.rows,cols:t.cols,diagonal:t.diagonal,fov:t.fov,maxSteps:t.max_steps,seed:n.seed,episode:BigInt(n.episode),steps:s,ended:s===n.length,walls:Array.
from(n.map.keys()).filter(i=>n.map[i]),pursuers:a.slice(0,t.n_pursuers),evaders:a.slice(t.n_pursuers),played:[],next:Array.from(n.actions.subarray(s*r,(s+1)*r))}}var Kc=60,Fn=class{element;player=new _e(0,{speed:Mn,still:xe()});inspector;match=null;recording=null;actions;#e;#n;#t;#r;#a=d("h2",{class:"match-title"});#o=d(
"p",{class:"tally numbers"});#c=d("ol",{class:"words",tabindex:0,"aria-live":"off","aria-label":"What happened in this step"});#d=d("p",{class:"problem",role:"a\
lert"});#h=d("div",{class:"shown","aria-live":"polite"});#p=null;#y=null;#m=0;#s=!1;#l=0;#i=[];constructor(e,t,r){this.#n=e,this.#t=t;let s=d("canvas",{"aria-la\
bel":"The match",onclick:({clientX:o,clientY:a})=>this.inspector.choose(this.#e.agentAt(o,a))});this.#e=new ke(s,{numbers:!1}),this.#r=new In(t),this.inspector=
new st(o=>this.#R(o)),this.actions=d("div",{class:"match-actions"},d("button",{type:"button",class:"to-play",title:"Move the chosen agent, or an evader, yoursel\
f from this step on (T)",onclick:()=>this.element.dispatchEvent(new Event("takeover"))},"Take over"),r&&Da(()=>this.shown,r)),this.element=d("section",{class:"c\
ard match-card","aria-label":"Match",id:"match"},d("div",{class:"match"},d("header",{class:"match-head"},this.#a,this.#o),this.#d,this.#h,d("div",{class:"stage"},
s),d("div",{class:"aside"},this.#c,Zt(),this.actions,this.inspector.element),On(this.player),this.#r.element)),this.player.addEventListener("frame",()=>this.recording&&
this.#e.show(this.recording,this.player.time)),this.player.addEventListener("step",()=>this.#x()),t.on("match",()=>this.#w()),this.#A(),this.#S(0,0)}get#f(){return this.#n[this.#t.
selected.run]}reveal(){(this.#f.game?this.#h:this.#e.canvas).scrollIntoView({block:"nearest"})}get shown(){return this.match&&this.#y&&{match:this.match,step:this.
player.step,champions:this.#y}}start(e){this.#p=e,this.#b()}playSoon(){this.#s=!0,this.#m||this.#g()}goTo(e){this.#l=e,!this.#m&&this.match&&this.#b()}#g(){!this.#s||
!this.match||(this.#s=!1,this.player.jump(0),xe()||this.player.play())}#w(){this.#A(),clearTimeout(this.#m),this.#m=setTimeout(()=>this.#b(),Kc)}#b(){clearTimeout(
this.#m),this.#m=0,this.player.pause(),this.#A();let{selected:e}=this.#t,{game:t}=this.#f;if(this.#h.replaceChildren(...t?Pa(this.#f,t,e,this.#t):[]),t){this.match=
this.recording=null,this.#s=!1,this.#v(e);return}let r=A.map(a=>po(this.#f,a,e[a])).find(Boolean)??"";if(this.#d.textContent=r,r||!this.#p)return;this.match=vo(
this.#p,this.#f,e);let[s,o]=this.names(e);this.#y={pursuer:{name:s,policy:Ce(this.#f,"pursuer",e.pursuer)},evader:{name:o,policy:Ce(this.#f,"evader",e.evader)}},
this.recording=Qt(this.match),this.#r.show(this.#f,this.match),this.inspector.show(this.#p,this.#f,this.match,e),this.player.length=this.match.length,this.player.
marks=yn(this.recording),this.#i=this.player.ticks=[],this.player.jump(this.#l),this.#l=0,this.#x(),this.#u(this.#p,this.match),this.#v(e),this.#g()}#v({run:e,pursuer:t,
evader:r,episode:s,seed:o}){this.element.dataset.played=`${e} ${t} ${r} ${s} ${o??""}`}async#u(e,t){let r=await Rn(e,t.config);if(this.match!==t||!r)return;let s=e.
world(t.config);t.seek(s,0),this.#i=kn(r,s,Yc(t)),s.free(),this.player.ticks=_n(this.#i),this.inspector.solution=r,this.#x()}names({run:e,pursuer:t,evader:r}){let s=this.#n[e],
{teams:o}=s;return[o.pursuer.script??J(s,"pursuer",t),o.evader.script??J(s,"evader",r)]}#A(){let{episode:e,seed:t}=this.#t.selected,{game:r,payoff:s}=this.#f;this.
element.classList.toggle("of-own-game",!!r),this.element.classList.toggle("of-ratings",A.some(l=>fo(this.#f,l)));let[o,a]=this.names(this.#t.selected),i=t===null?
e<s.episodes?`episode ${e+1} of ${s.episodes}`:`episode ${e+1}, not part of the cell`:`seed ${t}`;this.#a.replaceChildren(d("span",{class:"pursuer"},Nn(o))," ag\
ainst ",d("span",{class:"evader"},a),r?"":d("span",{class:"muted small"},i))}#x(){let e=this.match;if(!e||!this.recording)return;let t=this.player.step,r=this.recording.
moments[t];this.#S(Array.from(r.everCaptured).filter(Boolean).length,t),this.#c.replaceChildren(...this.#i.filter(s=>s.step===t).map(s=>d("li",{class:`loss-${s.
team}`},Ot(s))),...Cn(e,this.recording,t).map(s=>d("li",{class:s.kind,"data-agents":s.agents.join(" ")},s.text))),this.inspector.at(t),this.#M()}#S(e,t){let{world:r}=this.#f;
r&&this.#o.replaceChildren(d("strong",{},e),` of ${r.n_evaders} captured`,d("span",{class:"muted"},` · step ${t}`))}#R(e){this.#e.look={selected:e,viewers:e===
null?[]:[e]},this.#M()}#M(){let e=this.inspector.agent;for(let t of this.#c.children){let r=t.dataset.agents?.split(" ")??[];t.classList.toggle("about",e!==null&&
r.includes(String(e)))}}},Yc=({actions:n,length:e,n_agents:t})=>Array.from({length:e},(r,s)=>n.subarray(s*t,(s+1)*t));var qc={ArrowUp:[1,0],ArrowDown:[-1,0],ArrowRight:[0,1],ArrowLeft:[0,-1]},Jc=5;function Wa(n,e,t,r="pursuer"){n.tabIndex=0,n.setAttribute("role","application"),
n.addEventListener("keydown",s=>{let o=qc[s.key];if(!o)return;let[a,i]=r==="pursuer"?o:[o[1],o[0]],[l,c]=t(),u=s.shiftKey?Jc:1,{pursuer:h,evader:m}=e.selected;e.
select({pursuer:Ua(h+u*a,l),evader:Ua(m+u*i,c)}),s.preventDefault(),s.stopPropagation()})}var Ua=(n,e)=>Math.min(e-1,Math.max(0,n));var _t=[[68,1,84],[72,26,108],[71,47,125],[65,68,135],[57,86,140],[49,104,142],[42,120,142],[35,136,142],[31,152,139],[34,168,132],[53,183,121],[84,197,104],[122,
209,81],[165,219,54],[210,226,27],[253,231,37]];function Dn(n){let e=Math.min(1,Math.max(0,n))*(_t.length-1),t=Math.min(_t.length-2,Math.floor(e)),r=_t[t],s=_t[t+
1],o=a=>Math.round(r[a]+(e-t)*(s[a]-r[a]));return[o(0),o(1),o(2)]}function Ba(n){let[e,t,r]=Dn(n).map(s=>((s/255+.055)/1.055)**2.4);return .2126*e+.7152*t+.0722*
r>.179?"#000":"#fff"}var ja=n=>`rgb(${Dn(n).join(" ")})`,Ga=()=>`linear-gradient(to right, ${_t.map(n=>`rgb(${n.join(" ")})`).join(", ")})`;function za(n,e,t){let r=devicePixelRatio||1;for(let[a,i]of Object.entries(t))n.style.setProperty(a,`${i}px`);n.width=Math.round(t.width*r),n.height=Math.round(
t.height*r);let s=n.getContext("2d"),o=Zc(e);!s||!o||(s.imageSmoothingEnabled=!1,s.drawImage(o,0,0,n.width,n.height))}function Zc(n){let[e,t]=n.shape,r=document.
createElement("canvas");r.width=t,r.height=e;let s=r.getContext("2d");if(!s)return null;let o=s.createImageData(t,e);return n.capture_rate.forEach((a,i)=>a.forEach(
(l,c)=>{let u=4*((e-1-i-n.first[0])*t+c+n.first[1]);o.data.set([...Dn(l),255],u)})),s.putImageData(o,0,0),r}function Ha(n,e,t,r=2){n.textContent=G(e,r),n.ariaLabel=
`${t}: ${n.textContent}`,e!==void 0&&(n.style.backgroundColor=ja(e),n.style.color=Ba(e))}function qr(n,e){let t=d("span",{class:"gradient"});return t.style.backgroundImage=
Ga(),d("p",{class:"scale-of-rates small muted"},n,t,e)}var Xc=24,Un=7,Ka=n=>n<Xc&&matchMedia("(pointer: coarse)").matches;function Ya(n,e,t,r){let[s,o]=n.payoff.shape,a=Va(e,s),i=Va(t,o),l=Math.min(Un,s),c=Math.min(
Un,o),u=[];for(let f=a+l-1;f>=a;f--){u.push(d("span",{class:"pursuer"},f));for(let g=i;g<i+c;g++)u.push(Qc(n,f,g,r))}let h=Array.from({length:c},(f,g)=>d("span",
{class:"evader"},i+g)),m=d("button",{type:"button","aria-label":"Close: all cells",onclick:()=>r(null)},"✕"),y=d("div",{class:"loupe numbers",role:"group","ar\
ia-label":"Cells around the tap",onclick:f=>f.stopPropagation()},...u,m,...h);return y.style.gridTemplateColumns=`2.4rem repeat(${c}, minmax(0, 1fr))`,y}function Qc(n,e,t,r){
let s=d("button",{type:"button",onclick:()=>r({pursuer:e,evader:t})});return Ha(s,Re(n,e,t)?.rate,`${J(n,"pursuer",e)} against ${J(n,"evader",t)}`),s}var Va=(n,e)=>Math.
max(0,Math.min(e-Un,n-Math.floor(Un/2)));var ae={left:52,bottom:46,top:76,right:84},ye=10,eu=160,$t=ae.right-ye-14,Ue=ae.top-ye-14,Wn=class{element;#e;#n;#t=d("canvas",{"aria-hidden":"true"});#r=S("svg",
{"aria-hidden":"true"});#a=S("g");#o;#c=d("h2");#d=d("strong",{class:"rate numbers"});#h=d("span",{class:"small muted"});#p=d("p",{class:"of-both-teams small mu\
ted numbers"});#y;#m=null;constructor(e,t){this.#n=e,this.#e=t,this.#o=d("div",{class:"matrix",id:"matrix","aria-label":"Payoff matrix. Arrow keys choose a matc\
h, Enter plays it.",onpointermove:s=>this.#u(s),onpointerleave:()=>t.point({}),onclick:s=>this.#A(s),onkeydown:({key:s})=>s==="Enter"&&this.#S()},this.#t,this.#r);
let r=d("header",{class:"readout","aria-live":"polite"},d("div",{},this.#c,this.#p),d("div",{class:"of-cell"},this.#d,this.#h));this.#y=qr(...Oe(this.#s).ends),
this.element=d("section",{class:"card matrix-card","aria-label":"Payoff matrix"},r,this.#o,this.#y),this.#w(),new ResizeObserver(()=>this.#l()).observe(this.#o),
this.#o.addEventListener("mousedown",s=>{s.preventDefault(),document.activeElement instanceof HTMLElement&&document.activeElement.blur()}),Wa(this.#o,t,()=>this.#s.
payoff.shape),t.on("run",()=>{let s=qr(...Oe(this.#s).ends);this.#y.replaceWith(s),this.#y=s,this.#l()}),t.on("match hover",()=>this.#g())}get#s(){return this.#n[this.#e.
selected.run]}#l(){let[e,t]=this.#s.payoff.shape,{clientWidth:r,clientHeight:s}=this.#o;if(r<50)return;let a=Math.max(eu,Math.min(r-ae.left-ae.right,s-ae.top-ae.
bottom))/Math.max(e,t),i=Math.max(ae.left,(r-t*a-ae.right+ae.left)/2),l=ae.top+Math.max(0,(s-ae.top-ae.bottom-e*a)/2),c={width:r,height:s,left:i,top:l,cell:a,rows:e,
columns:t};this.#m=c,za(this.#t,this.#s.payoff,{left:i,top:l,width:t*a,height:e*a});for(let[u,h,m]of[["left",i,r],["top",l,s],["width",t*a,r],["height",e*a,s]])
this.#t.style.setProperty(u,`${100*h/m}%`);this.#o.style.setProperty("--shape",`${r} / ${s}`),this.#r.setAttribute("viewBox",`0 0 ${r} ${s}`),this.#r.replaceChildren(
tu(c,Oe(this.#s).generation),...nu(c),...this.#f(c),this.#a),this.#g()}#i(e){let t=this.#s.findings?.generalization;if(!t)return[];let{selected:r,hover:s}=this.#e,
o=s.pursuer??r.pursuer,a=s.evader??r.evader,[i,l]=qa(e,t.pursuers.mean[o]??0,o),[c,u]=Ja(e,t.evaders.mean[a]??0,a);return[S("circle",{class:"dot of-pursuers",cx:i,
cy:l,r:5}),S("circle",{class:"dot of-evaders",cx:c,cy:u,r:5})]}#f(e){let t=this.#s.findings?.generalization;if(!t)return[];let{left:r,top:s,cell:o,rows:a,columns:i}=e,
{curves:l}=Oe(this.#s),c=r+i*o+ye,u=s-ye,h={class:"side"};return[S("rect",{...h,x:c,y:s,width:$t,height:a*o}),S("rect",{...h,x:r,y:u-Ue,width:i*o,height:Ue}),...Za(
t.pursuers,(m,p)=>qa(e,m,p),"of-pursuers"),...Za(t.evaders,(m,p)=>Ja(e,m,p),"of-evaders"),S("text",{class:"tick",x:c,y:s+a*o+16,"text-anchor":"start"},"0"),S("t\
ext",{class:"tick",x:c+$t,y:s+a*o+16,"text-anchor":"end"},"1"),S("text",{class:"tick",x:r-6,y:u-4,"text-anchor":"end"},"0"),S("text",{class:"tick",x:r-6,y:u-Ue+
8,"text-anchor":"end"},"1"),S("text",{class:"label of-pursuers",x:c+$t,y:s+a*o+34,"text-anchor":"end"},l.pursuer),S("text",{class:"label of-evaders",x:r+i*o+ye,
y:u-Ue+10,"text-anchor":"start"},l.evader)]}#g(){let e=this.#m;if(!e)return;let{selected:t,hover:r}=this.#e,{left:s,top:o,cell:a,rows:i,columns:l}=e,c=y=>o+(i-1-
y)*a,u=[],h=(y,f)=>S("rect",{class:f,x:s,y:c(y),width:l*a+ye+$t,height:a}),m=(y,f)=>S("rect",{class:f,x:s+y*a,y:o-ye-Ue,width:a,height:ye+Ue+i*a});u.push(h(t.pursuer,
"strip pursuer"),m(t.evader,"strip evader")),r.pursuer!==null&&r.pursuer<i&&u.push(h(r.pursuer,"strip hover")),r.evader!==null&&r.evader<l&&u.push(m(r.evader,"s\
trip hover")),u.push(...this.#i(e));let p={x:s+t.evader*a,y:c(t.pursuer),width:a,height:a};u.push(S("rect",{class:"chosen under",...p}),S("rect",{class:"chosen",
...p})),this.#a.replaceChildren(...u),this.#w()}#w(){let{selected:e,hover:t}=this.#e,r=t.pursuer??e.pursuer,s=t.evader??e.evader,o=Re(this.#s,r,s);this.#c.replaceChildren(
d("span",{class:"pursuer"},Nn(J(this.#s,"pursuer",r)))," against ",d("span",{class:"evader"},J(this.#s,"evader",s))),this.#d.textContent=o?G(o.rate,3):"-";let a=o&&
o.rates.length>1?`, mean of ${o.rates.length} episodes`:"";this.#h.textContent=o?Oe(this.#s).score+a:"no episodes were played",this.#p.textContent=this.#b(r,s)}#b(e,t){
let r=this.#s.findings?.generalization;if(!r)return"";let s=(a,i)=>Sa(a.mean[i]??null,a.low?.[i]??null,a.high?.[i]??null),{means:o}=Oe(this.#s);return`Against a\
ll: ${o.pursuer} ${s(r.pursuers,e)}, ${o.evader} ${s(r.evaders,t)}`}#v(e){let t=this.#m;if(!t)return null;let r=this.#o.getBoundingClientRect(),s=Math.floor((e.
clientX-r.left-t.left)/t.cell),o=t.rows-1-Math.floor((e.clientY-r.top-t.top)/t.cell),a=o>=0&&o<t.rows,i=s>=0&&s<t.columns;return a||i?{g:a?o:-1,h:i?s:-1,inside:a&&
i}:null}#u(e){let t=this.#v(e);this.#e.point(t?{pursuer:t.g<0?null:t.g,evader:t.h<0?null:t.h}:{})}#A(e){let t=this.#v(e);if(t){if(t.inside&&Ka(this.#m.cell))return this.#x(
t.g,t.h);this.#e.select({...t.g<0?{}:{pursuer:t.g},...t.h<0?{}:{evader:t.h}}),t.inside&&this.#S()}}#x(e,t){let r=Ya(this.#s,e,t,s=>{r.remove(),s&&(this.#e.select(
s),this.#S())});this.#o.append(r)}#S(){this.#o.dispatchEvent(new CustomEvent("play",{bubbles:!0}))}};function tu({left:n,top:e,cell:t,rows:r,columns:s},o){let a=S(
"g",{class:"axes"}),i=e+r*t,l=c=>Rt(0,c-1,Math.min(c,c*t/44),!0);for(let c of l(s))a.append(S("text",{class:"tick",x:n+(c+.5)*t,y:i+16,"text-anchor":"middle"},c));
for(let c of l(r))a.append(S("text",{class:"tick",x:n-7,y:i-(c+.5)*t,"text-anchor":"end","dominant-baseline":"middle"},c));return a.append(S("text",{class:"labe\
l of-evaders",x:n+s*t/2,y:i+36,"text-anchor":"middle"},o.evader),S("text",{class:"label of-pursuers",transform:`translate(${n-36} ${e+r*t/2}) rotate(-90)`,"text\
-anchor":"middle"},o.pursuer)),a}function nu({left:n,top:e,cell:t,rows:r,columns:s}){let o=S("g",{class:"diagonal"}),a=Math.min(r,s);if(a<3)return[];let i=e+r*t;
for(let u of["H","V"]){let h=`M${n} ${i}`;for(let m=1;m<=a;m++){let p=`H${n+m*t}`,y=`V${i-m*t}`;h+=u==="H"?p+y:y+p}o.append(S("path",{d:h,class:"under"}),S("pat\
h",{d:h}))}let l=n+a/2*t-.7*t-4,c=i-a/2*t-.7*t-4;return[o,S("text",{class:"on-cells",transform:`translate(${l} ${c}) rotate(-45)`,"text-anchor":"middle"},"same \
generation")]}var qa=({left:n,top:e,cell:t,rows:r,columns:s},o,a)=>[n+s*t+ye+o*$t,e+(r-a-.5)*t],Ja=({left:n,top:e,cell:t},r,s)=>[n+(s+.5)*t,e-ye-r*Ue];function Za(n,e,t){
let r=o=>o.map((a,i)=>e(a??0,i).map(l=>l.toFixed(1)).join(" ")),s=[];return n.low&&n.high&&s.push(S("path",{class:`band ${t}`,d:`M${[...r(n.high),...r(n.low).reverse()].
join("L")}Z`})),s.push(S("path",{class:`line ${t}`,d:`M${r(n.mean).join("L")}`})),s}var Xa={pursuer:null,evader:null},Bn=class extends EventTarget{#e;#n=Xa;constructor(e){super(),this.#e=e}get selected(){return this.#e}get hover(){return this.#n}select(e){
let t=this.#e,r=["run","pursuer","evader"].some(s=>s in e&&e[s]!==t[s]);this.#e={...t,...r?{episode:0,seed:null}:{},...e},this.#e.run!==t.run&&this.dispatchEvent(
new Event("run")),this.dispatchEvent(new Event("match"))}point(e){let t={...Xa,...e};t.pursuer===this.#n.pursuer&&t.evader===this.#n.evader||(this.#n=t,this.dispatchEvent(
new Event("hover")))}on(e,t){for(let r of e.split(" "))this.addEventListener(r,t)}};var ru=8,su=900,Qa=1800,Pt=class extends EventTarget{element;player=new _e(0,{speed:ru,still:xe()});match=null;agent=null;#e=d("figcaption");#n=d("canvas",{onclick:({
clientX:e,clientY:t})=>this.#d(e,t)});#t;#r=d("p",{class:"small muted numbers"});#a=d("p",{class:"small",role:"status"});#o=null;#c=!1;constructor(){super(),this.#t=
new ke(this.#n,{numbers:!1}),this.element=d("figure",{class:"chase"},this.#e,this.#n,this.#r,this.#a),this.player.addEventListener("frame",()=>this.#h()),this.player.
addEventListener("step",()=>this.#p()),this.player.addEventListener("state",()=>this.over&&this.dispatchEvent(new Event("over")))}get over(){return this.player.
length>0&&!this.player.playing&&this.player.step===this.player.length}get title(){return this.#e.textContent}get recording(){return this.#o}show(e,t){this.match=
e,this.#o=Qt(e),this.#e.textContent=t,this.#n.ariaLabel=`A match. ${t}`,this.player.jump(0),this.player.length=e.length,this.player.marks=yn(this.#o),this.#p()}choose(e){
this.agent=e,this.#t.look={selected:e,viewers:e===null?[]:[e]},this.dispatchEvent(new Event("agent"))}#d(e,t){this.#c||this.choose(this.#t.agentAt(e,t))}#h(){this.#o&&
this.#t.show(this.#o,this.player.time)}#p(){let e=this.#o?.moments[this.player.step]?.everCaptured;e&&(this.#r.textContent=`${Array.from(e).filter(Boolean).length}\
 of ${e.length} caught in ${this.player.step} steps`),this.dispatchEvent(new Event("step"))}drawWalls(e){let t=!1,r=!0,s=[0,0],o=([l,c])=>!!this.#o?.obstacles[l*
this.#o.cols+c],a=(l,c)=>{this.#a.textContent=e(l,c)},i=l=>{let c=this.#t.cellAt(l.clientX,l.clientY);c&&o(c)!==r&&a(c,r)};return this.#n.addEventListener("poin\
terdown",l=>{let c=t&&this.#t.cellAt(l.clientX,l.clientY);c&&(this.#n.setPointerCapture(l.pointerId),r=!o(c),i(l))}),this.#n.addEventListener("pointermove",l=>t&&
l.buttons&&i(l)),this.#n.addEventListener("keydown",l=>{let c={ArrowUp:[-1,0],ArrowDown:[1,0],ArrowLeft:[0,-1],ArrowRight:[0,1]}[l.key];if(!t||!this.#o||!(c||l.
key===" "))return;l.preventDefault();let u=(p,y)=>Math.min(y-1,Math.max(0,p)),{rows:h,cols:m}=this.#o;c?s=[u(s[0]+c[0],h),u(s[1]+c[1],m)]:a(s,!o(s)),this.#t.look=
{cursor:s}}),l=>{t=this.#c=l,this.#n.classList.toggle("drawn-on",l),this.#n.tabIndex=l?0:-1,this.#n.setAttribute("role",l?"application":"img"),this.#t.look={cursor:null}}}showWalls(e){
this.#o&&(this.#o={...this.#o,obstacles:e},this.#h())}},jn=class{boards;#e;#n=-1/0;#t=0;#r=!xe();constructor(e,...t){this.#e=e,this.boards=t;for(let r of t)r.addEventListener(
"over",()=>this.#r&&t.every(({over:s})=>s)&&this.#a(su))}get runs(){return this.#r}set runs(e){this.#r=e,clearTimeout(this.#t),this.#t=0;for(let{player:t}of this.
boards)e?t.play():t.pause()}renew(e=!1){e||performance.now()-this.#n>Qa?this.#o():this.#t||this.#a(Qa)}#a(e){clearTimeout(this.#t),this.#t=setTimeout(()=>this.#o(),
e)}#o(){if(clearTimeout(this.#t),this.#t=0,this.#n=performance.now(),this.#e(),this.#r)for(let{player:e}of this.boards)e.play()}};var T=n=>Array.from(n).reduce((e,t)=>e+t,0)/n.length,Jr=(n,e)=>e==="pursuer"?n:n[0].map((t,r)=>n.map(s=>1-s[r]));var ei=-12676506002282294e14,ti=({hidden:n,mask:e})=>n.map(t=>t+(e?4:0));function Nt(n){let e=[3*n.fov**2,...ti(n),5],t=0;return e.slice(1).map((r,s)=>{let o={at:t,
inputs:e[s],outputs:r};return t+=(o.inputs+1)*r,o})}function Se(n){if(n.kind==="rating")return n.inputs.length;let{at:e,inputs:t,outputs:r}=Nt(n).at(-1);return e+
(t+1)*r}var Lt=(n,e)=>n.kind==="rating"?{...n,genome:e}:{kind:"cells",hidden:ti(n),activation:"relu",sampled:!0,memory:"none",genome:e};function ni(n,e,t){let r=t.
initial_weight;if(n.kind==="rating"||t.kind==="rating")return e.normals(Se(n)).map(i=>Math.fround(r)*i);let s=t.initial_head,o=new Float32Array(Se(n)),a=Nt(n);return a.
forEach(({at:i,inputs:l,outputs:c},u)=>{let h=Math.fround(u===a.length-1?s:r);e.normals(l*c).forEach((m,p)=>o[i+p]=h*m)}),o}function Zr(n){if(n.kind==="rating")
return null;let{fov:e,mask:t}=n;if(!t)return null;let r=new Uint8Array(Se(n)),s=new Float32Array(Se(n)),o=Nt(n),a=o.length-1,i=Math.floor(e/2);return o.forEach(
({at:l,inputs:c,outputs:u},h)=>{let m=(p,y)=>l+p*u+y;for(let p=0;p<4;p++)if(h>0&&r.fill(1,m(c-4+p,0),m(c-4+p+1,0)),h<a)for(let y=0;y<=c;y++)r[m(y,u-4+p)]=1;t.forEach(
(p,y)=>{let f=h===a?1+y:u-4+y,g=h===0?p.map(([b,w,x])=>(b*e+i+w)*e+i+x):[c-4+y];for(let b of g)r[m(b,f)]=1,s[m(b,f)]=h===a?ei:1})}),{fixed:r,values:s}}function Xr(n,e){
return e?n.map((t,r)=>e.fixed[r]?e.values[r]:t):n}function ri(n,e,t){if(e.kind==="rating"||t.kind==="rating")return n;let r=new Float32Array(Se(t)),s=Nt(e),o=Nt(
t),a=Math.floor(t.fov/2)-Math.floor(e.fov/2),i=c=>c>=0&&c<t.fov,l=c=>{let u=Math.floor(c/e.fov**2),h=Math.floor(c/e.fov)%e.fov+a,m=c%e.fov+a;return i(h)&&i(m)?(u*
t.fov+h)*t.fov+m:-1};return s.forEach((c,u)=>{let h=o[u],m=e.hidden[u]??5;for(let p=0;p<(u?e.hidden[u-1]:c.inputs);p++){let y=u?p:l(p);if(!(y<0))for(let f=0;f<m;f++)
r[h.at+y*h.outputs+f]=n[c.at+p*c.outputs+f]}for(let p=0;p<m;p++)r[h.at+h.inputs*h.outputs+p]=n[c.at+c.inputs*c.outputs+p]}),Xr(r.map(c=>c<=ei/2?0:c),Zr(t))}var ii={initial:1,noise:2,learn:3,opponents:4},es={pursuer:1,evader:2,both:3},We=4,Qr=2n**32n;function si(n){let e=[],t=BigInt(n);do e.push(Number(t%Qr)),t/=Qr;while(t>
0n);return e}function oi(n,e){let t=n;return r=>{let s=r^t;return t=Math.imul(t,e),s=Math.imul(s,t),s^s>>>16}}function ai(n,e){let t=Math.imul(3389127133,n)-Math.
imul(1232336661,e)|0;return t^t>>>16}function ts(n,e,t){let r=n.flatMap(si);if(e.length){for(;r.length<We;)r.push(0);r.push(...e.flatMap(si))}let s=oi(1135663077,
2468251765),o=Array.from({length:We},(i,l)=>s(r[l]??0));for(let i=0;i<We;i++)for(let l=0;l<We;l++)i!==l&&(o[l]=ai(o[l],s(o[i])));for(let i of r.slice(We))for(let l=0;l<
We;l++)o[l]=ai(o[l],s(i));let a=oi(2337405405,1492356589);return Uint32Array.from({length:t},(i,l)=>a(o[l%We]))}function It(n,e){let t=ts(n,[],2*e);return BigUint64Array.
from({length:e},(r,s)=>BigInt(t[2*s])+Qr*BigInt(t[2*s+1]))}var Gn=(n,e,t)=>It([n,e,t],1)[0];var li=n=>(e,...t)=>new ns(ts([n],[ii[e],...t],3)),ns=class{#e;#n;#t;#r=1;constructor(e){this.#e=e[0],this.#n=e[1],this.#t=e[2];for(let t=0;t<12;t++)this.#a()}#a(){
let e=this.#e+this.#n+this.#r++|0;return this.#e=this.#n^this.#n>>>9,this.#n=this.#t+(this.#t<<3)|0,this.#t=(this.#t<<21|this.#t>>>11)+e|0,e>>>0}#o(){return(this.#a()+
.5)/2**32}normals(e){let t=new Float32Array(e);for(let r=0;r<e;r+=2){let s=Math.sqrt(-2*Math.log(this.#o())),o=2*Math.PI*this.#o();t[r]=s*Math.cos(o),r+1<e&&(t[r+
1]=s*Math.sin(o))}return t}integers(e,t){return Int32Array.from({length:t},()=>Math.floor(this.#o()*e))}permutation(e){return this.choice(e,e)}choice(e,t){let r=Int32Array.
from({length:e},(s,o)=>o);for(let s=0;s<t;s++){let o=s+Math.floor(this.#o()*(e-s));[r[s],r[o]]=[r[o],r[s]]}return r.slice(0,t)}};var _=Math.fround,ou=5,au=256,zn=class{size;sigma;fixed;#e;constructor(e,t,r,s){this.size=e,this.sigma=r,this.fixed=s,this.#e=t.normals((1+au)*e);for(let o=0;o<
this.#e.length;o++)this.#e[o]*=_(r)}draw(e,t){let r=t.integers(this.#e.length-this.size+1,e);return Array.from(r,s=>{let o=this.#e.subarray(s,s+this.size);return this.
fixed?o.map((a,i)=>this.fixed[i]?0:a):o})}},rs=class{#e;#n;#t=0;constructor(e){this.#e=new Float32Array(e),this.#n=new Float32Array(e)}moved(e,t,r){let a=_(1e-8);
this.#t+=1;let i=_(1-.9),l=_(1-.999),c=_(1-.9**this.#t),u=_(1-.999**this.#t);return e.map((h,m)=>{let p=t[m],y=this.#e[m]+=_(i*_(p-this.#e[m])),f=this.#n[m]+=_(
l*_(_(p*p)-this.#n[m])),g=_(_(Math.sqrt(_(_(f)/u)))+a);return _(h+_(_(_(r)*_(_(y)/c))/g))})}};function iu(n){let e=Array.from(n).sort((t,r)=>t-r);return n.map(t=>(e.
indexOf(t)+e.lastIndexOf(t))/(2*(n.length-1))-.5)}var Hn=class{genome;groups;#e;#n;#t;#r=[];constructor(e,t,r){this.genome=e,this.#n=t,this.#e=r,this.#t=new rs(
e.length),this.groups=Int32Array.from({length:r.population},(s,o)=>o%(r.population/2))}get#a(){let{sigma:e,fixed:t}=this.#n,r=0,s=0;return this.genome.forEach((o,a)=>{
t?.[a]||(r+=o*o,s+=1)}),Math.max(e,this.#e.relative_sigma*Math.sqrt(r/s))}ask(e){let t=this.#e.population/2,r=this.genome.length;this.#r=this.#n.draw(t,e);let s=_(
this.#a/this.#n.sigma),o=new Float32Array(2*t*r);return this.#r.forEach((a,i)=>{for(let l=0;l<r;l++){let c=_(s*a[l]);o[i*r+l]=this.genome[l]+c,o[(t+i)*r+l]=this.
genome[l]-c}}),o}tell(e){let t=iu(e),r=this.#r.length,s=new Float32Array(this.genome.length);this.#r.forEach((o,a)=>{let i=_((t[a]-t[r+a])/(2*r*this.#n.sigma**2));
for(let l=0;l<s.length;l++)s[l]+=_(i*o[l])}),this.genome=this.#t.moved(this.genome,s,this.#e.learning_rate)}},Ft=class{population;groups;#e;#n;#t=new Float64Array(
0);#r=0;constructor(e,t,r){this.population=e,this.#n=t,this.#e=r,this.groups=new Int32Array(r.population)}get genome(){return this.#a(this.#r).slice()}#a(e){let{
size:t}=this.#n;return this.population.subarray(e*t,(e+1)*t)}#o(e,t){let r=this.#e.tournament??ou,s=t.integers(this.#t.length,e*r);return Array.from({length:e},
(o,a)=>s.subarray(a*r,(a+1)*r).reduce((i,l)=>this.#t[l]>this.#t[i]?l:i))}ask(e){if(!this.#t.length)return this.population;let{size:t}=this.#n,{population:r,elites:s}=this.#e,
o=r-s,a=this.#o(o,e);this.#o(o,e);let i=Array.from(this.#t.keys()).sort((c,u)=>this.#t[u]-this.#t[c]).slice(0,s),l=new Float32Array(this.population.length);return[
...i,...a].forEach((c,u)=>l.set(this.#a(c),u*t)),this.#n.draw(o,e).forEach((c,u)=>{let h=(s+u)*t;for(let m=0;m<t;m++)l[h+m]+=c[m]}),this.population=l,l}tell(e){
this.#t=e,this.#r=e.indexOf(Math.max(...e))}};function ci(n,e,t,r){let s=n.length,o=Math.max(...n)+1,a=o>1?s/o:1,i=Array.from(n.keys()).sort((h,m)=>n[h]-n[m]),l=[],c=[];for(let h=0;h<e;h++){let m=h%a;m===0&&
(c=Array.from(r.permutation(s/a)).flatMap(p=>i.slice(p*a,(p+1)*a))),l.push([i,c.map((p,y)=>c[y-y%a+(y%a-m+a)%a])])}let u=h=>i.map(()=>s+h);for(let h=0;h<t[1];h++)
l.push([i,u(h)]);for(let h=0;h<t[0];h++)l.push([u(h),i]);return{pursuer:Int32Array.from(l.flatMap(([h])=>h)),evader:Int32Array.from(l.flatMap(([,h])=>h)),group:Int32Array.
from(l.flatMap((h,m)=>i.map(p=>m*o+n[p])))}}function ui(n,e,t,r){let s=Math.max(...e)+1,o=new Float64Array(t*s),a=new Float64Array(t*s);r.forEach((l,c)=>{if(n[c]>=
t)return;let u=n[c]*s+e[c];o[u]+=l,a[u]+=1});let i=o.map((l,c)=>a[c]?l/a[c]:0);return Float64Array.from({length:t},(l,c)=>{let u=i.subarray(c*s,(c+1)*s);return ss(
u)/a.subarray(c*s,(c+1)*s).filter(Boolean).length})}var lu=128,ot=8;function ss(n){let{length:e}=n;if(e>lu){let m=Math.floor(e/2)-Math.floor(e/2)%ot;return ss(n.
subarray(0,m))+ss(n.subarray(m))}if(e<ot)return n.reduce((m,p)=>m+p,0);let t=n.slice(0,ot),r=e-e%ot;for(let m=ot;m<r;m++)t[m%ot]+=n[m];let[s,o,a,i,l,c,u,h]=t;return n.
subarray(r).reduce((m,p)=>m+p,s+o+(a+i)+(l+c+(u+h)))}var hi=({world:n})=>n.rules.teammate==="REACH"?.2:0;var di=["generation","team","epoch","opponent","fitness_mean","fitness_std","fitness_best","capture_rate","length","pursuer_faults","evader_faults","matches","s\
teps"],Kn={pursuer:["random","clumsy-fleer"],evader:["random","clumsy-chaser"]},cu=20,uu=8,hu=-1,it=({world:n,policy:e},t,r)=>e.kind==="rating"?e:{kind:"cells",
fov:n.fov,hidden:e.hidden,mask:e.mask==="none"?null:t[r]},at=class{settings;epochs=0;until=1/0;archive={pursuer:[],evader:[]};rows=[];cells=new Map;counters={pursuer:[],
evader:[]};#e;#n;#t;#r={};#a=new Set;#o=0;#c=0;#d=0;constructor(e,t,r,s=li(t.seed)){this.#e=e,this.settings=t,this.#n=r,this.#t=s;for(let o of A){let a=s("initi\
al",A.indexOf(o)),i=t.learner.kind==="ga"?t.learner.population:1,l=Array.from({length:i},()=>ni(this.shape(o),a,t.policy));this.#p(o,l),this.archive[o].push(this.#r[o].
genome)}this.#u(...A)}shape(e){return it(this.settings,this.#n,e)}get finished(){return Math.min(this.archive.pursuer.length,this.archive.evader.length)}*run(){
this.finished===1&&(yield*this.#A(0));for(let e=this.finished;e<=this.settings.schedule.generations;e++){if(this.settings.schedule.kind==="alternating")for(let t of A)
yield*this.#y(t,e),this.#u(t);else yield*this.#m(e),this.#u(...A);yield*this.#A(e)}}change(e){let t=this.settings,r={pursuer:this.shape("pursuer"),evader:this.shape(
"evader")},s=l=>JSON.stringify(l(t))===JSON.stringify(l(e));this.settings=e;let o=s(l=>[l.world.fov,l.policy]);if(!o||!s(l=>l.learner))for(let l of A){let c=u=>ri(
u,r[l],this.shape(l));this.archive[l]=this.archive[l].map(c),this.#p(l,this.#h(l).map(c))}if(o&&s(l=>l.world))return null;this.cells.clear(),this.#a.clear();let{
pursuer:a,evader:i}=this.archive;return{type:"anew",settings:e,genomes:{pursuer:a.slice(0,this.finished),evader:i.slice(0,this.finished)}}}#h(e){let t=this.#r[e];
if(!(t instanceof Ft))return[t.genome];let r=t.genome.length,s=Array.from({length:t.population.length/r},(o,a)=>t.population.slice(a*r,(a+1)*r));return Array.from(
{length:this.settings.learner.population},(o,a)=>a===0?t.genome:s[a%s.length])}#p(e,t){let{learner:r}=this.settings,s=this.shape(e),o=r.kind==="ga"?r.mutation:r.
sigma,a=Zr(s),i=new zn(Se(s),this.#t("noise",A.indexOf(e)),o,a?.fixed??null),l=t.map(c=>Xr(c,a));this.#r[e]=r.kind==="ga"?new Ft(Vn(l),i,r):new Hn(l[0],i,r)}*#y(e,t){
for(let r=0;r<this.#i(e);r++){for(;this.epochs>=this.until;)yield{type:"rest"};let s=this.archive[ce(e)].length,o=this.settings.schedule[`${e}s_meet`],a=o==="la\
test"?s-1:o==="round-robin"?r%s:this.#t("opponents",A.indexOf(e),t,r).choice(s,1)[0],i=e==="pursuer"?[t,a]:[a,t],l=this.#r[e],{groups:c}=l,u=It([this.settings.seed,
...i,es[e],r],Math.max(...c)+1),h=l.ask(this.#t("learn",A.indexOf(e),t,r)),m=Int32Array.from(c.keys()),p=new Int32Array(c.length),y={[e]:h,[ce(e)]:this.archive[ce(
e)][a]},f={[e]:m,[ce(e)]:p},g=this.#g(y,f,BigUint64Array.from(c,w=>u[w])),b=this.#b(g,e);this.#v(g,b,{generation:t,team:e,epoch:r,opponent:a}),l.tell(b),yield*this.#f(
t,r,e)}this.archive[e].push(this.#r[e].genome)}*#m(e){for(let t=0;t<this.#i("pursuer");t++){for(;this.epochs>=this.until;)yield{type:"rest"};let{schedule:r,learner:{
population:s}}=this.settings,[o,a]=r.kind==="hall-of-fame"?[r.hall_sample,r.contemporaries]:[0,1],i={pursuer:this.#s("pursuer",e,t),evader:this.#s("evader",e,t)},
l=this.#t("opponents",0,e,t),c={pursuer:this.#l(o,l),evader:this.#l(o,l)},u=g=>Vn([i[g],...Array.from(c[ce(g)],b=>this.archive[g][b])]),h=[c.evader.length,c.pursuer.
length],m=ci(this.#r.pursuer.groups,a,h,l),p=It([this.settings.seed,e,e,es.both,t],Math.max(...m.group)+1),y={pursuer:u("pursuer"),evader:u("evader")},f=this.#g(
y,m,BigUint64Array.from(m.group,g=>p[g]));for(let g of A){let b=ui(m[g],m[ce(g)],s,this.#b(f,g));this.#v(f,b,{generation:e,team:g,epoch:t,opponent:hu}),this.#r[g].
tell(b)}yield*this.#f(e,t,"both")}for(let t of A)this.archive[t].push(this.#r[t].genome)}#s(e,t,r){return this.#r[e].ask(this.#t("learn",A.indexOf(e),t,r))}#l(e,t){
let r=this.archive.pursuer.length;return e?t.choice(r,Math.min(e,r)):new Int32Array(0)}#i(e){let{schedule:t}=this.settings;return t.kind==="hall-of-fame"?t.joint_epochs:
t[`${e}_epochs`]}*#f(e,t,r){let[s,o]=this.settings.schedule.kind==="hall-of-fame"?[this.#i("pursuer"),0]:[this.#i("pursuer"),this.#i("evader")],a=t+1+(r==="evad\
er"?s:0),i=s+o;this.epochs+=1,yield{type:"epoch",done:(e-1)*i+a,of:this.settings.schedule.generations*i},yield*this.catchUp()}#g(e,t,r){let s={...this.settings.
world,max_steps:this.settings.train_steps},o=this.#e.rollouts(s,this.#w("pursuer",e.pursuer),this.#w("evader",e.evader),{...t,seed:r},1);this.#o+=o.length.length;
for(let a of o.length)this.#c+=Number(a);for(let a of o.agent_steps)this.#d+=Number(a);return o}#w(e,t){return Lt(this.shape(e),t)}#b({captured_fraction:e,overlap:t},r){
let s=hi(this.settings);return Float64Array.from(e,(o,a)=>r==="pursuer"?o:1-o-s*Number(t[2*a+1]))}#v(e,t,r){let s=T(t),o=[0,0];e.faults.forEach((a,i)=>o[Math.floor(
i/3)%2]+=Number(a)),this.rows.push({...r,fitness_mean:s,fitness_std:Math.sqrt(T(t.map(a=>(a-s)**2))),fitness_best:Math.max(...t),capture_rate:T(e.capture_rate),
length:T(e.length),pursuer_faults:o[0]/e.length.length,evader_faults:o[1]/e.length.length,matches:this.#o,steps:this.#c})}#u(...e){for(let t of e)this.counters[t].
push({matches:this.#o,steps:this.#c,agent_steps:this.#d})}*#A(e){yield{type:"generation",number:e,genomes:{pursuer:this.archive.pursuer[e],evader:this.archive.evader[e]}},
yield*this.catchUp()}*catchUp(){for(let e=this.finished-1;e>=0;e--){for(let t=e;t>=0;t--)for(let[r,s]of t===e?[[e,e]]:[[e,t],[t,e]]){if(this.cells.has(`${r} ${s}`))
continue;let o=this.#x(r,s);this.cells.set(`${r} ${s}`,o),yield{type:"cell",cell:o}}this.#a.has(e)||(this.#a.add(e),yield{type:"scores",number:e,scores:{pursuer:this.#S(
"pursuer",e),evader:this.#S("evader",e)}})}}#x(e,t){let{world:r,evaluation_episodes:s,seed:o}=this.settings,a={pursuer:new Int32Array(1),evader:new Int32Array(1),
seed:BigUint64Array.of(Gn(o,e,t))},i=A.map(u=>this.#w(u,this.archive[u][u==="pursuer"?e:t])),l=this.#e.rollouts(r,...i,a,s),c=u=>{let h=Array.from(l[u],Number),
m=h.length/s;return Array.from({length:m},(p,y)=>T(h.filter((f,g)=>g%m===y)))};return{pursuer:e,evader:t,capture_rates:Array.from(l.capture_rate),lengths:Array.
from(l.length),means:{collisions:c("collisions"),faults:c("faults"),agent_steps:c("agent_steps"),survivors:c("survivors")}}}#S(e,t){let{world:r,seed:s}=this.settings,
o=this.#w(e,this.archive[e][t]),a=new Int32Array(1);return T(Kn[e].map((i,l)=>{let c=It([s,A.indexOf(e),l,uu],1),u=e==="pursuer"?[o,i]:[i,o],h=T(this.#e.rollouts(
r,...u,{pursuer:a,evader:a,seed:c},cu).capture_rate);return e==="pursuer"?h:1-h}))}};function Vn(n){let e=new Float32Array(n.reduce((r,{length:s})=>r+s,0)),t=0;
for(let r of n)e.set(r,t),t+=r.length;return e}var os=n=>Array.from({length:n},()=>Array(n)),Yn=class{learning=A;settings=[];command="";training={capture_rate:[],generation:[],learner:[],epochs:1,window:1,matches:0};limits="";name;schedule;seed;seeds=[];world;payoff;teams;findings=null;genomes={
pursuer:[],evader:[]};best=null;#e;#n;#t;constructor(e,t,r,s){this.#t=e,this.#e=t,this.#n=s,this.name=r,this.schedule=r,this.world=e.world,this.seed=String(e.seed),
this.payoff=this.#r(),this.teams=this.#a()}get newest(){return this.genomes.pursuer.length-1}#r(){let{seed:e,schedule:{generations:t}}=this.#t,r=t+1;return this.
seeds=Array.from({length:r},(s,o)=>Array.from({length:r},(a,i)=>String(Gn(e,o,i)))),{first:[0,0],shape:[r,r],episodes:this.#t.evaluation_episodes,capture_rate:os(
r),capture_rates:os(r),lengths:os(r)}}#a(){let e=t=>{let r=`${this.#n} ${t}`;bo(r,Vn(this.genomes[t]));let{genome:s,...o}=Lt(it(this.#t,this.#e,t),this.genomes[t][0]??
new Float32Array(0));return{script:null,policy:{...o,genome_size:s.length},kept:[...this.genomes[t].keys()],genomes:r}};return{pursuer:e("pursuer"),evader:e("ev\
ader")}}policy(e,t){return this.playing(e,this.genomes[e][t])}playing(e,t){return Lt(it(this.#t,this.#e,e),t)}genomesOf({pursuer:e,evader:t}){return{pursuer:this.
genomes.pursuer[e],evader:this.genomes.evader[t]}}extend(e){let{capture_rate:t,capture_rates:r,lengths:s,shape:[o]}=this.payoff;if(this.#t={...this.#t,schedule:e.
schedule},!(o>e.schedule.generations)){this.payoff=this.#r();for(let a=0;a<o;a++)Object.assign(this.payoff.capture_rate[a],t[a]),Object.assign(this.payoff.capture_rates[a],
r[a]),Object.assign(this.payoff.lengths[a],s[a])}}add(e){for(let t of A)this.genomes[t].push(e[t]);this.teams=this.#a()}change(e,t){this.#t=e,this.world=e.world;
for(let r of A)this.genomes[r]=[...t[r]];this.best=null,this.payoff=this.#r(),this.teams=this.#a(),this.findings=null}addCell({pursuer:e,evader:t,capture_rates:r,
lengths:s}){this.payoff.capture_rate[e][t]=T(r),this.payoff.capture_rates[e][t]=[...r],this.payoff.lengths[e][t]=[...s],this.findings={generalization:this.#o()}}#o(){
let e=this.payoff.capture_rate,t=o=>({mean:o,low:null,high:null}),r=o=>{let a=o.filter(i=>i!==void 0);return a.length?T(a):null},s=[...this.genomes.pursuer.keys()];
return{pursuers:t(s.map(o=>r(e[o]))),evaders:t(s.map(o=>r(e.map(a=>a[o]===void 0?void 0:1-a[o]))))}}};var du=1/4,pi=1.96,mi=.05,as=5;function fi(n,e){let t=Array.from({length:e},(h,m)=>Array.from({length:e},(p,y)=>n.get(`${m} ${y}`)?.capture_rates));if(e<2||t.some(
h=>h.includes(void 0)))return null;let r=t.map(h=>h.map(m=>T(m))),s=t.map(h=>h.map(m=>pu(m))),o=Math.max(1,Math.round(e*du)),a=h=>{let m=Jr(r,h),p=h==="pursuer"?
s:mu(s),y=[m[0].slice(-o)],f=m.slice(-o).map(v=>v.slice(-o)),g=v=>T(v.map(E=>T(E.slice(-o))/o))/v.length,b={value:T(f.map(T))-T(y.map(T)),reach:pi*Math.sqrt(g(p.
slice(-o))+g([p[0]]))},w=fu(m,p),x=gu(b,w);return{verdict:x==="better"&&!yu(m.map(T),w.value)?"better by a jump":x,before:T(y[0]),after:T(f.map(T))}},i={pursuer:a(
"pursuer"),evader:a("evader")},l=h=>{let m=Jr(r,h).map(T);return m.lastIndexOf(Math.max(...m))},c={pursuer:l("pursuer"),evader:l("evader")},u=r[c.pursuer][c.evader];
return{rate:u,best:c,teams:i,sentence:bu(u,i)}}var mu=n=>n[0].map((e,t)=>n.map(r=>r[t])),pu=n=>n.reduce((e,t)=>e+(t-T(n))**2,0)/Math.max(1,n.length-1)/n.length;
function fu(n,e){let t=n.length-1,r=n.map((i,l)=>l-t/2),s=r.reduce((i,l)=>i+l*l,0),o=r.map(i=>t*i/s),a=e.map(i=>T(i)/i.length);return{value:n.reduce((i,l,c)=>i+
o[c]*T(l),0),reach:pi*Math.sqrt(a.reduce((i,l,c)=>i+o[c]**2*l,0))}}function yu(n,e){let t=n.map(c=>c*Math.sign(e)),r=Math.floor(n.length/as),s=n.length%as,o=Array.
from({length:as},(c,u)=>T(t.slice(u*r+Math.min(u,s),(u+1)*r+Math.min(u+1,s)))),a=Math.max(2,Math.floor(n.length/10)),i=Math.max(...t.slice(a).map((c,u)=>c-t[u])),
l=Math.max(...o.slice(1).map((c,u)=>o[u]-c));return i<Math.abs(e)/2&&l<Math.abs(e)/4}function gu(...n){return n.every(({value:e,reach:t})=>e-t>mi)?"better":n.every(
({value:e,reach:t})=>e+t<-mi)?"weaker":"cannot tell"}var z=n=>`${Math.round(100*n)} %`,vu={better:"better than in generation 0","better by a jump":"better than \
in generation 0, most of it in one jump",weaker:"weaker than in generation 0","cannot tell":""};function bu(n,e){let t=`The best pursuers now catch ${z(n)} of t\
he best evaders.`,r=A.map(o=>vu[e[o].verdict]);if(r[0]===r[1])return r[0]?`${t} Both teams are ${r[0]}.`:`${t} Whether a team has become better since generation\
 0, this race cannot tell.`;let s=A.map((o,a)=>r[a]?`the ${o}s are ${r[a]}`:`of the ${o}s this race cannot tell`);return`${t} ${s[0][0].toUpperCase()}${s[0].slice(
1)}; ${s[1]}.`}function yi(n,{before:e,after:t}){let[r,s]=n==="pursuer"?[e,t]:[1-e,1-t];return n==="pursuer"?`Of the last ${ce(n)}s, pursuers of generation 0 ca\
tch ${z(r)}, the last pursuers ${z(s)}.`:`The last pursuers catch ${z(r)} of the evaders of generation 0, and ${z(s)} of the last evaders.`}var gi=1/3,wu=1/10,xu=4,Su=2,Au=12,vi=n=>n.length>1?`${n.slice(0,-1).join(", ")} and ${n.at(-1)}`:n[0]??"";function bi({phrases:n,words:e},t,r){let s=Object.entries(
r).map(([c,u])=>[c,Math.abs(u)]).sort(([,c],[,u])=>u-c),o=s[0]?.[1]||1/0,a=s.filter(([,c])=>c/o>=gi).slice(0,xu).map(([c])=>n[c][r[c]>0?1:0]),i=s.filter(([,c])=>c/
o>=wu&&c/o<gi).slice(0,Su).map(([c])=>n[c][2]),l=vi([...a,...i.length?[`minds ${vi(i)} little`]:[]])||"takes any move that is allowed";return`{A} ${t} ${l}.`.replaceAll(
/\{(\w+)\}/g,(c,u)=>e[t][u])}function wi(n,e,t,r){let s=r[t];if(s.kind!=="rating")return{};let{n_pursuers:o,n_evaders:a}=e.config,i=Array.from({length:t==="purs\
uer"?o:a},(u,h)=>h+(t==="pursuer"?0:o)),l=n.world(e.config),c=s.inputs.map(()=>[]);for(let u=0;u<e.length;u+=Math.max(1,Math.floor(e.length/Au))){e.seek(l,u,{pursuers:r.
pursuer,evaders:r.evader});for(let h of i.filter(m=>e.alive[u*e.n_agents+m])){let{inputs:m,refused:p}=l.rate(s,h);m.forEach((y,f)=>{let g=Array.from(y).filter((b,w)=>!p[w]);
g.length&&c[f].push(T(g.map(b=>(b-T(g))**2)))})}}return l.free(),Object.fromEntries(s.inputs.map((u,h)=>[u,s.genome[h]*Math.sqrt(c[h].length?T(c[h]):0)]))}var Mu=2,Tu=1.5,qn=class{element=d("section",{class:"card weights-card","aria-label":"Weights of named inputs",hidden:!0});#e;#n;#t;#r=d("div",{class:"evolved"});#a=d(
"p",{class:"numbers",role:"status"});#o=d("button",{type:"button",onclick:()=>this.#l()},"As evolved");#c={pursuer:d("p"),evader:d("p")};#d=null;#h=null;constructor(e,t,r){
this.#e=e,this.#n=t,this.#t=r,this.element.append(d("h3",{},"What they have learned"),d("p",{class:"small muted"},"An agent takes the move with the largest sum \
of weight x input. Drag a weight, and see at once what becomes of the team."),d("div",{class:"doings"},this.#o,this.#a),this.#r)}genome(e){return this.#h?.[e]??
this.#y[e]}get#p(){let{newest:e,best:t}=this.#d;return t??{pursuer:e,evader:e}}get#y(){return this.#d.genomesOf(this.#p)}show(e){e!==this.#d&&(this.#h=null),this.#d=
e;let{policy:t}=e.teams.pursuer;this.element.hidden=t?.kind!=="rating"||e.newest<1,!(t?.kind!=="rating"||this.element.hidden)&&(this.#h||this.#r.replaceChildren(
...A.map(r=>this.#m(r,t.inputs))),this.#i())}#m(e,t){let r=this.genome(e),s=Math.max(Mu,Tu*Math.max(...r.map(Math.abs)));return d("div",{class:"weights"},d("h4",
{class:e},`${e}s`),this.#c[e],...t.flatMap((o,a)=>{let i=d("span",{class:"numbers"},rt(r[a])),l=d("input",{type:"range",class:e,min:-s,max:s,step:"any",value:r[a],
title:Pe[o],"aria-label":`${e}s: ${o}`});return l.addEventListener("input",()=>{i.textContent=rt(Number(l.value)),this.#s(e,a,Number(l.value))}),[d("span",{title:Pe[o]},
o.replaceAll("_"," ")),l,i]}))}#s(e,t,r){this.#h??={pursuer:this.genome("pursuer").slice(),evader:this.genome("evader").slice()},this.#h[e][t]=r,this.#i(),this.#t()}#l(){
this.#h=null,this.show(this.#d),this.#t()}#i(){this.#o.disabled=!this.#h;let e=z(this.rate(this.#y));this.#a.textContent=this.#h?`Yours: ${z(this.rate(this.#h))}\
 are caught; as evolved: ${e}`:`${e} are caught`;let t=this.#d,r={pursuer:t.playing("pursuer",this.genome("pursuer")),evader:t.playing("evader",this.genome("eva\
der"))},s=this.#e.match(t.world,r.pursuer,r.evader,BigInt(t.seed));for(let o of A)this.#c[o].textContent=bi(this.#n,o,wi(this.#e,s,o,r))}rate({pursuer:e,evader:t},r=this.#p,s=this.#d){
let o=new Int32Array(1),a={pursuer:o,evader:o,seed:BigUint64Array.of(BigInt(s.seeds[r.pursuer][r.evader]))};return T(this.#e.rollouts(s.world,s.playing("pursuer",
e),s.playing("evader",t),a,s.payoff.episodes).capture_rate)}};var Eu=12,Jn=class{#e=null;#n=null;#t=[];#r;constructor(e,t){this.#r=t;try{let r=new Blob([fe("script-engine"),`
`,fe(`script-${e}`)],{type:"text/javascript"});this.#n=new Worker(URL.createObjectURL(r)),this.#n.onerror=()=>this.#e||this.#a(),this.#n.onmessage=()=>this.#o(this.#n)}catch{
this.#a()}}send(e){this.#e?this.#e.postMessage(e):this.#t.push(e)}close(){this.send({type:"stop"}),this.#n?.terminate()}#a(){let{port1:e,port2:t}=new MessageChannel;
is(t),this.#o(e)}#o(e){this.#e=e,e.onmessage=({data:t})=>t.type!=="ready"&&this.#r(t);for(let t of this.#t.splice(0))e.postMessage(t)}};function is(n){let e=b=>n.
postMessage(b),t=Yt(),r=null,s=null,o=null,a=[],i=!1,l=0,c=!1,u=new MessageChannel,h=b=>{let w=r.change(b);e({type:"changed",at:r.epochs,settings:b}),w&&e(w),!s&&
r.finished<=b.schedule.generations?(s=r.run(),i=!0):i||(o=r.catchUp())},m=()=>{i=!1,o=r.catchUp(),e({type:"stopped",at:r.epochs})},p=()=>{if(i&&s){for(;a.length&&
a[0].at<=r.epochs;)h(a.shift().settings);let{value:w,done:x}=s.next();return x?(s=null,i=!1,o=r.catchUp(),e({type:"end",at:r.epochs,seconds:l/1e3})):w.type==="r\
est"?m():e(w),!0}let b=o?.next();return b&&!b.done?e(b.value):o=null,!!o},y=()=>{let b=performance.now(),w=!0;for(;w&&performance.now()<b+Eu;)w=p();l+=performance.
now()-b,!(!w||c)&&(c=!0,u.port2.postMessage(null))},f=async b=>{if(b.type==="start")r=new at(await t,b.settings,b.masks),s=r.run(),o=null,a=[...b.plan],i=!0,l=0,
r.until=b.until,e({type:"began"});else if(r)if(b.type==="change")a=[],r.until=1/0,h(b.settings);else if(b.type==="go")r.until=1/0,i=!0;else if(b.type==="stop")i&&
m();else{let{settings:w,archive:x,rows:v,cells:E,counters:R,finished:k}=r;e({type:"saved",race:{settings:w,archive:x,rows:v,cells:E,counters:R,finished:k}})}else
return;y()},g=b=>{Promise.resolve().then(b).catch(w=>{s=o=null,e({type:"failed",message:String(w)})})};u.port1.onmessage=()=>{c=!1,g(y)},n.onmessage=({data:b})=>g(
()=>f(b)),e({type:"ready"})}var Ou=100,Cu=.3,Ru="By chance: evaders that have not learned to flee run into pursuers that have not learned to hunt.",Zn={pursuer:0,evader:0},xi=0,Xn=class extends EventTarget{element;chases;boards;before=new Pt;after=new Pt;settings;state="\
waiting";done=0;epochs=0;changed=[];seconds=0;outcome=null;kept=null;#e;#n;#t;#r=d("h2",{class:"lane-title"});#a=d("p",{class:"facts numbers"});#o=d("div",{class:"\
lane-room"});#c=d("section",{class:"card measures"});#d=d("details",{class:"lane-more",hidden:!0},d("summary",{},"More: every generation against every other, sc\
ores and collisions"),this.#o,this.#c);#h=d("div");#p=new st(()=>{});#y=d("section",{class:"card asked","aria-label":"An agent",hidden:!0},d("button",{type:"but\
ton",class:"leave",onclick:()=>this.#L(null,null)},"Close"),this.#p.element);#m;#s;#l={pursuer:[],evader:[]};#i=new Map;#f;#g=()=>{};#w=0;#b=!0;#v=!1;#u=0;#A=null;constructor(e,t,r,s){
super(),this.#e=e,this.#n=t,this.settings=s,this.#t=new Jn(r,o=>this.#S(o)),this.chases=new jn(()=>this.#N(),this.before,this.after),this.before.element.classList.
add("before"),this.boards=d("div",{class:"pair"},this.before.element,this.after.element),this.#m=new qn(t,e,()=>this.#_(!0));for(let o of[this.before,this.after])
o.addEventListener("agent",()=>o.agent!==null&&this.#L(o,o.agent)),o.addEventListener("step",()=>!this.#y.hidden&&o.agent!==null&&this.#I(o));this.element=d("se\
ction",{class:"lane"},this.#r,this.#a,this.boards,d("p",{class:"hint small muted"},"Click an agent, or press A: what it sees, and why it moves."),this.#y,this.#m.
element,this.#d,this.#h),this.reset(s)}reset(e){this.#t.send({type:"stop"}),this.#k(e),this.state="waiting";let{archive:t}=new at(this.#n,e,this.#e.masks);this.#s.
add({pursuer:t.pursuer[0],evader:t.evader[0]}),this.#_(!0),this.#C()}start(e,t=[],r=1/0){this.#k(e),this.state="evolving",this.settings=t.at(-1)?.settings??e,this.#x(
{type:"start",settings:e,masks:this.#e.masks,plan:t,until:r}),this.#C()}restore(e,t,r,s){this.#k(t.settings),this.settings=e,this.kept=t;for(let o=0;o<t.finished;o++)
this.#s.add({pursuer:t.archive.pursuer[o],evader:t.archive.evader[o]});for(let[o,a]of t.cells)this.#s.addCell(a),this.#i.set(o,a);this.#l={pursuer:[...t.scores.
pursuer],evader:[...t.scores.evader]},this.seconds=t.seconds,this.done=1,this.epochs=r,this.changed.push(...s),this.#M("ended"),this.#T()}stop(){this.#x({type:"\
stop"})}go(){this.state="evolving",this.#x({type:"go"}),this.#C()}change(e){if(this.state==="waiting")return this.reset(e);this.settings=e,this.#x({type:"change",
settings:e}),this.#C()}saved(){return this.kept?Promise.resolve(this.kept):new Promise(e=>{this.#A=e,this.#x({type:"save"})})}async keep(){return{...await this.
saved(),scores:this.#l,seconds:this.seconds}}get newestGeneration(){return this.#s.newest}get champions(){return{pursuer:this.#m.genome("pursuer"),evader:this.#m.
genome("evader")}}get run(){return this.#s}close(){this.#t.close(),this.chases.runs=!1}#x(e){this.#t.send(e)}#S(e){if(e.type==="began"&&(this.#v=!0),!!this.#v){
if(e.type==="generation")this.#s.add(e.genomes),this.#_(e.number===0);else if(e.type==="cell"){let{pursuer:t,evader:r}=e.cell;this.#s.addCell(e.cell),this.#b&&t===
r&&t===this.#s.newest&&this.#f.select({pursuer:t,evader:r}),this.#i.set(`${t} ${r}`,e.cell),(this.state==="stopped"||this.state==="ended")&&this.#M(this.state)}else if(e.
type==="scores")for(let t of A)this.#l[t][e.number]=e.scores[t];else e.type==="changed"?(this.#s.extend(e.settings),this.changed.push(e.at),this.epochs=e.at,e.settings.
schedule.generations>this.#s.newest&&this.state==="ended"&&this.#R()):e.type==="anew"?(this.#s.change(e.settings,e.genomes),this.#E(),this.#_(!0)):e.type==="epo\
ch"?(this.epochs+=1,this.done=e.done/e.of):e.type==="stopped"?this.#M("stopped"):e.type==="end"?(this.seconds=e.seconds,this.done=1,this.#M("ended")):e.type==="\
saved"?this.#A?.(e.race):e.type==="failed"&&(this.#a.textContent=`The race failed: ${e.message}`,this.state="stopped");this.#u||(this.#u=setTimeout(()=>requestAnimationFrame(
()=>this.#T()),Ou))}}#R(){this.state="evolving",this.outcome=null,this.#s.best=null}#M(e){let t=this.outcome;this.state=e,this.outcome=fi(this.#i,this.#s.newest+
1),this.#s.best=this.outcome?.best??null,this.outcome&&!t&&this.#_(!0),this.#D()}#T(){this.#u=0,this.#f.dispatchEvent(new Event("run")),this.#g(),this.#C()}#E(){
this.#i=new Map,this.#l={pursuer:[],evader:[]},this.outcome=null,this.#c.hidden=!0}#k(e){this.settings=e,this.done=0,this.epochs=0,this.changed.splice(0),this.kept=
null;let t=on(e);this.#s=new Yn(e,this.#e.masks,t,`race ${xi}`),xi+=1,this.#E(),this.#L(null,null),this.#b=!0,this.#v=!1,this.#f=new Bn({run:0,pursuer:0,evader:0,
episode:0,seed:null});let r=new Wn([this.#s],this.#f);r.element.ariaLabel=`Payoff matrix. ${t}`,this.#h.replaceChildren(this.#$(r)),this.#o.replaceChildren(r.element,
this.#P())}#$(e){let t=new Fn([this.#s],this.#f,null);t.actions.remove();let r=d("dialog",{class:"of-cell-match","aria-label":"Match",onclose:()=>t.player.pause()},
d("button",{type:"button",class:"leave",onclick:()=>r.close()},"Close"),t.element),s=!1;return e.element.addEventListener("play",()=>{let{pursuer:o,evader:a}=this.#f.
selected;this.#b=!1,this.#s.payoff.capture_rate[o][a]!==void 0&&(r.showModal(),s||t.start(this.#n),s=!0,t.playSoon())}),r}#P(){let e=`${Kn.pursuer.join(", ")} a\
nd ${Kn.evader.join(", ")}`,t=Ea(`Scores against scripts, by generation: ${e}`,(s,o)=>this.#O(s,o),()=>{},s=>{let o=Math.min(this.#s.newest,Math.max(0,Math.round(
s)));this.#f.select({pursuer:o,evader:o})});return this.#g=t.redraw,d("section",{class:"card scores"},d("h3",{},"Against opponents that never change"),d("p",{class:"\
small muted"},"Captures of random walkers and of clumsy fleers; escapes from random walkers and from clumsy chasers."),Ta(["pursuers","of-pursuers"],["evaders",
"of-evaders"]),t.element)}#O(e,t){let{generations:r}=this.settings.schedule,o=Aa(e,t,{low:0,high:r,label:"generation",whole:!0},{low:0,high:1,label:"score"});for(let a of A){
let i=Array.from(this.#l[a],l=>l??null);Ma(o,[...i.keys()],i,`of-${a}s`)}return o}#N(){if(this.#s.newest<0)return;let e=BigInt(this.#s.seeds[0][0]),t=this.#w%this.#s.
payoff.episodes;this.#w+=1;let r=s=>this.#n.match(this.#s.world,...this.#F(s),e,t);this.before.show(r(this.#s.genomesOf(Zn)),"Before: generation 0"),this.after.
show(r(this.champions),this.#W());for(let s of[this.before,this.after])s.agent!==null&&this.#I(s,!0)}#W(){let{newest:e,best:t}=this.#s;if(e===0)return"Generatio\
n 0: nobody has learned anything yet";let{pursuer:r,evader:s}=t??{pursuer:e,evader:e},o=r===s?`generation ${r}`:`pursuers of generation ${r}, evaders of generat\
ion ${s}`;return t?`After: ${o}`:`Now: ${o}`}#F({pursuer:e,evader:t}){return[this.#s.playing("pursuer",e),this.#s.playing("evader",t)]}#_(e){this.#m.show(this.#s),
this.chases.renew(e)}#L(e,t){for(let r of[this.before,this.after])r!==e&&r.agent!==null&&r.choose(null);this.#y.hidden=!e,e&&(this.#I(e,!0),this.#p.choose(t))}askNext(){
let{match:e,player:t,agent:r}=this.after;if(!e)return;let s=e.n_agents,o=(r??-1)+1,i=Array.from({length:s},(l,c)=>(o+c)%s).find(l=>e.alive[t.step*s+l]);i!==void 0&&
this.after.choose(i)}#I(e,t=!1){if(t){let r=e===this.before,[s,o]=this.#F(r?this.#s.genomesOf(Zn):this.champions),a=r?0:this.#s.newest;this.#p.show(this.#n,this.#s,
e.match,{run:0,pursuer:a,evader:a,episode:0,seed:null},{pursuers:s,evaders:o})}this.#p.at(e.player.step)}#C(){let{newest:e}=this.#s;this.element.dataset.state=this.
state,this.#r.textContent=on(this.settings),this.#d.hidden=this.state==="waiting",this.#a.replaceChildren(...this.#B().map(t=>d("span",{},t))),this.element.dataset.
newest=String(e),this.dispatchEvent(new Event("state"))}#B(){let{newest:e}=this.#s;if(this.outcome)return[this.outcome.sentence];if(e<0)return[];let t=a=>{let i=this.#i.
get(`${a} ${a}`);return i?T(i.capture_rates):null};if(this.state==="waiting"||e<1){let a=t(0)??this.#m.rate(this.#s.genomesOf(Zn),Zn),i=`${z(a)} of the evaders \
are caught.`;return a>Cu?[i,Ru]:[i]}let r=`Generation ${e} of ${this.settings.schedule.generations}`,s=t(e)??t(e-1),o=t(0);return s===null||o===null?[`${r}.`]:[
`${r}: the pursuers catch ${z(s)} of the evaders; those of generation 0 caught ${z(o)}.`]}#D(){let{outcome:e}=this;if(this.#c.hidden=!e,this.#c.ariaLabel=`What \
came out. ${on(this.settings)}`,!e)return;let t=this.#i.get(`${this.#s.newest} ${this.#s.newest}`),r=[["Score against scripts: generation 0",s=>z(this.#l[s][0]??
0)],["Score against scripts: newest generation",s=>z(this.#l[s].at(-1)??0)],["Collisions at fault in 1000 moves of the newest generation",(s,o)=>ku(t,o).toFixed(
1)]];this.#c.replaceChildren(d("h3",{},"In numbers"),...A.map(s=>d("p",{},yi(s,e.teams[s]))),d("table",{class:"numbers"},d("thead",{},d("tr",{},d("td"),...A.map(
s=>d("th",{scope:"col",class:s},`${s}s`)))),d("tbody",{},...r.map(([s,o])=>d("tr",{},d("th",{scope:"row"},s),...A.map((a,i)=>d("td",{},o(a,i))))))),d("p",{class:"\
small muted"},"One race proves little: save it, and ",d("code",{},"matrixworld judge")," says what happened on its way, and how surely."))}};function ku({means:{
faults:n,agent_steps:e}},t){let r=n.length/A.length;return 1e3*n.slice(t*r,(t+1)*r).reduce((s,o)=>s+o,0)/Math.max(1,e[t])}var Si=n=>Ie(JSON.stringify(n,null,2)),ls=(n,...e)=>({dtype:"<f8",shape:e,data:Float64Array.from(n)}),_u=n=>Math.sqrt(T(n.map(e=>(e-T(n))**2)));function $u({settings:n,
finished:e}){let t=n.schedule.kind==="alternating"?A.map(r=>[r]):[A];return Array.from({length:e},(r,s)=>(s?t:[A]).map(o=>[s,o])).flat()}function Pu({archive:n,
rows:e,counters:t},r,[s,o]){let a=e.filter(c=>c.generation===s&&o.includes(c.team)),i=Ie(a.map(c=>`${[r,...di.map(u=>c[u])].join(",")}
`).join("")),l=c=>({dtype:"<f4",shape:[1,n[c][s].length],data:n[c][s]});return{...Object.fromEntries(o.map(c=>[`${c}s`,l(c)])),log:{dtype:`|S${Math.max(1,i.length)}`,
shape:[],data:i.length?i:new Uint8Array(1)},...Object.fromEntries(Object.entries(t[o.at(-1)][s]).map(([c,u])=>[c,ls([u])])),...r?{score:ls([T(a.slice(Math.floor(
a.length/2)).map(c=>c.capture_rate))])}:{}}}function Nu(n){let e=n.finished,t=Array.from({length:e*e},(o,a)=>n.cells.get(`${Math.floor(a/e)} ${a%e}`)),r=t[0].lengths.
length,s=(o,...a)=>ls(t.flatMap(o),e,e,...a);return{scores:{dtype:"<f4",shape:[e,e,r],data:Float32Array.from(t.flatMap(({capture_rates:o})=>o))},mean:s(({capture_rates:o})=>T(
o)),std:s(({capture_rates:o})=>_u(o)),lengths:{dtype:"<i4",shape:[e,e,r],data:Int32Array.from(t.flatMap(({lengths:o})=>o))},collisions:s(({means:o})=>o.collisions,
2,3),faults:s(({means:o})=>o.faults,2,3),agent_steps:s(({means:o})=>o.agent_steps,2),pursuer_survivors:s(({means:o})=>o.survivors[0]),evader_survivors:s(({means:o})=>o.
survivors[1])}}function Lu(n,{format:e,version:t,game:r}){let s=n.finished-1,o={...n.settings,schedule:{...n.settings.schedule,generations:s}},a={format:e,matrixworld:t,
game:r,settings:o,drawn_by:"page"},i=$u(n),{matches:l,steps:c,agent_steps:u}=n.counters.evader[s],h={training_matches:l,training_steps:c,training_agent_steps:u},
m={stages:i.length-1,...h,disengagement:[],evaluation_matches:n.finished**2*n.settings.evaluation_episodes};return{"config.json":Si(a),...Object.fromEntries(i.map(
(p,y)=>[`stage-${String(y).padStart(4,"0")}.npz`,Ct(Pu(n,y,p))])),"payoff.npz":Ct(Nu(n)),"summary.json":Si(m)}}function Ai(n,e){let t=n.flatMap(({name:r,race:s})=>Object.
entries(Lu(s,e)).map(([o,a])=>[n.length>1?`${r}/${o}`:o,a]));return rn(Object.fromEntries(t))}var cs=n=>n.finished>1&&n.cells.size>=n.finished**2&&A.every(e=>n.
archive[e].length);function Ti(n){let{width:e,height:t}=n[0],{table:r,place:s}=Iu(n),o=[...Mi("GIF89a"),...Dt(e),...Dt(t),247,0,0,...r];return o.push(33,255,11,...Mi("NETSCAPE2.0"),
3,1,0,0,0),n.forEach((a,i)=>{o.push(33,249,4,0,...Dt(i===n.length-1?150:12),0,0),o.push(44,0,0,0,0,...Dt(e),...Dt(t),0,8);let l=Fu(Ei(a).map(c=>s[c]));for(let c=0;c<
l.length;c+=255){let u=l.slice(c,c+255);o.push(u.length,...u)}o.push(0)}),Uint8Array.from([...o,59])}var Mi=n=>[...n].map(e=>e.charCodeAt(0)),Dt=n=>[n&255,n>>8];
function Ei({data:n}){let e=new Uint16Array(n.length/4),t=3;for(let r=0;r<e.length;r++)e[r]=n[4*r]>>t<<10|n[4*r+1]>>t<<5|n[4*r+2]>>t;return e}function Iu(n){let e=new Map;
for(let i of n)for(let l of Ei(i))e.set(l,(e.get(l)??0)+1);let t=[...e].sort(([,i],[,l])=>l-i).slice(0,256).map(([i])=>i),r=i=>[i>>10,i>>5&31,i&31],s=(i,l)=>r(i).
reduce((c,u,h)=>c+(u-r(l)[h])**2,0),o=new Uint8Array(2**15);for(let i of e.keys()){let l=t.indexOf(i);o[i]=l>=0?l:t.reduce((c,u,h)=>s(i,u)<s(i,t[c])?h:c,0)}let a=t.
flatMap(i=>r(i).map(l=>Math.round(l*255/31)));return{table:[...a,...Array(3*256-a.length).fill(0)],place:o}}function Fu(n){let r=[],s=new Map,o=258,a=9,i=0,l=0,
c=h=>{for(i|=h<<l,l+=a;l>=8;l-=8)r.push(i&255),i>>>=8};c(256);let u=n[0];for(let h of n.subarray(1)){let m=s.get(u*256+h);if(m!==void 0){u=m;continue}c(u),o===4096?
(c(256),s=new Map,o=258,a=9):(s.set(u*256+h,o),o===2**a&&(a+=1),o+=1),u=h}return c(u),c(257),l&&r.push(i&255),r}var Du={...xn,numbers:!1},Uu={side:260,gap:12,head:30},Wu={width:1200,height:800,side:520,gap:48},Bu=60;function us(n,e){let t=Object.assign(document.createElement(
"canvas"),{width:n,height:e});return[t,t.getContext("2d",{willReadFrequently:!0})]}function Oi({recording:n},e,t){let[r,s]=us(t,t),o=An(n.rows,n.cols,!1,t,t,1);
return Sn({ctx:s,grid:o,colors:tt(document.querySelector("canvas.board"))},n,Math.min(e,n.moments.length-1),Du,1),r}function Ci(n,e){let t=getComputedStyle(document.
body);n.fillStyle=t.backgroundColor,n.fillRect(0,0,n.canvas.width,n.canvas.height),n.fillStyle=t.color,n.font=`${e} ${t.fontFamily}`}function Ri(n){let{side:e,gap:t,
head:r}=Uu,s=Math.min(Bu,Math.max(...n.map(({recording:i})=>i.moments.length-1))),[o,a]=us(n.length*e+(n.length+1)*t,r+e+t);return Ti(Array.from({length:s+1},(i,l)=>(Ci(
a,"600 15px"),n.forEach((c,u)=>{let h=t+u*(e+t);a.fillText(c.title,h,21,e),a.drawImage(Oi(c,l,e),h,r)}),a.getImageData(0,0,o.width,o.height))))}function ki(n,e){
let{width:t,height:r,side:s,gap:o}=Wu,[a,i]=us(t,r);return Ci(i,"600 30px"),n.forEach((l,c)=>{let u=o+c*(s+o+16);i.fillText(l.title,u,60,s),i.drawImage(Oi(l,1/0,
s),u,80)}),e.forEach((l,c)=>{i.font=i.font.replace(/^\S+ \S+/,c<e.length-2?"500 27px":"400 19px"),i.fillText(l,o,650+37*c,t-2*o)}),new Promise(l=>a.toBlob(c=>l(
c)))}var Be="matrixworld-evolve",hs=()=>JSON.parse(ds()?.getItem(Be)??"[]");function ds(){try{return sessionStorage}catch{return null}}var _i=hs,Qn=({address:n})=>n.
split(/&?race=/)[0];function $i(n,e){let t=ds(),r=JSON.stringify(e,(a,i)=>i instanceof Float32Array?{floats:Array.from(i)}:i instanceof Map?{entries:[...i]}:i),
s=hs().filter(a=>Qn(a)!==Qn(n));for(let{address:a}of hs().filter(i=>Qn(i)===Qn(n)))t?.removeItem(`${Be} ${a}`);let o=[...s,n];for(let a=0;t&&a<=8;a++){for(let i of o.
splice(0,Math.max(0,o.length-8)))t.removeItem(`${Be} ${i.address}`);try{t.setItem(`${Be} ${n.address}`,r),t.setItem(Be,JSON.stringify(o));return}catch(i){if(!(i instanceof
DOMException)||o.length<2)return;t.removeItem(`${Be} ${o[0].address}`),o=o.slice(1)}}}function Pi(n){let e=ds()?.getItem(`${Be} ${n}`);return e?JSON.parse(e,(t,r)=>Array.
isArray(r?.floats)?Float32Array.from(r.floats):Array.isArray(r?.entries)?new Map(r.entries):r):null}var Ut=8e3;function Ii(n){let e=2166136261;for(let t of fe("script-engine")+JSON.stringify(n))e=Math.imul(e^t.charCodeAt(0),16777619);return(e>>>0).toString(36)}
var $e={changes:"~~",parts:"~",value:":",races:"_"},Fi="end",ms=({choice:n,changes:e})=>e.reduce((t,{change:r})=>({...t,...r}),n);function Wt(n,{choice:e,changes:t,
watched:r},s){let o=l=>l.map(c=>c===1/0?Fi:c).join($e.races),a=t.map(({change:l,at:c})=>[o(c),...Object.entries(Ao(l)).map(u=>u.join($e.value))].join($e.parts)).
join($e.changes),i={...So(n,e),...r.length?{race:Ii(n),to:o(r),...a?{then:a}:{}}:{},...s?{play:[s.seed,s.episode,s.seat,s.score,s.rate].join("."),pursuer:Ni(s.pursuer),
evader:Ni(s.evader)}:{}};return Object.entries(i).map(([l,c])=>`${l}=${c}`).join("&")}function Di(n,e){let t=[...new URLSearchParams(e.length>2*Ut?"":e.replace(
/^#/,""))],{race:r="",to:s="",then:o="",play:a="",pursuer:i="",evader:l="",...c}=Object.fromEntries(t),u=[],h=Fr(n,c,v=>u.push(v)),m=v=>v===Fi?1/0:/^\d{1,6}$/.test(
v)?Number(v):NaN,p=v=>v.split($e.races).map(m),y=o.split($e.changes).filter(Boolean).reduce((v,E)=>{let[R="",...k]=E.split($e.parts),O=ms({choice:h,changes:v,watched:[]}),
M=Object.fromEntries(k.map(P=>P.split($e.value))),U=Fr(n,M,P=>u.push(P),O),F=Object.fromEntries(Object.entries(U).filter(([P])=>P in M));return[...v,{change:F,at:p(
R)}]},[]),f=r||s?p(s):[],g=h.beside?2:1,b=[...y.map(({at:v})=>v),...f.length?[f]:[]].every(v=>v.length===g&&!v.some(Number.isNaN)),w=a?ju(n,h,a,i,l):null;b||u.push(
`to=${s}`),a&&!w&&u.push(`play=${a}`);let x="";return e.length>2*Ut?x="The link is too long, and shows nothing. ":u.length?x=`Something in the link is wrong, an\
d left out: ${u.slice(0,3).map(E=>E.slice(0,60)).join("; ")}. `:f.length&&r!==Ii(n)&&(x="The link is of another version of this page: the race may be another on\
e. "),{story:{choice:h,changes:b?y:[],watched:b?f:[]},dare:w,problem:x}}function ju(n,e,t,r,s){let o=/^(\d{1,20})\.(\d{1,4})\.(\d{1,3})\.(\d{1,4})\.(\d{1,3})$/.
exec(t),a=[Li(r),Li(s)];if(!o||!a[0]?.length||!a[1]?.length||Number(o[3])>=e.pursuers+e.evaders)return null;let i=dn(n,e);if(A.some((m,p)=>a[p].length!==Se(it(i,
n.masks,m))))return null;let[l,c,u,h]=o.slice(2).map(Number);return{pursuer:a[0],evader:a[1],seed:String(BigInt.asUintN(64,BigInt(o[1]))),episode:l,seat:c,score:u,
rate:h}}var Ni=n=>btoa(String.fromCharCode(...new Uint8Array(n.slice().buffer))).replaceAll("+","-").replaceAll("/",".").replaceAll("=","");function Li(n){if(!/^[\w.-]*$/.
test(n))return null;try{let e=Uint8Array.from(atob(n.replaceAll("-","+").replaceAll(".","/")),r=>r.charCodeAt(0)),t=e.length%4?null:new Float32Array(e.buffer);return t?.
every(Number.isFinite)?t:null}catch{return null}}var Gu=250,ie=(n,e,t,r="")=>d("button",{type:"button",title:e||null,class:r||null,onclick:t},n),ps=class{#e;#n;lanes=[];#t=d("div",{class:"lanes"});#r=d("div",{
class:"of-race"});#a=ie("Evolve","",()=>this.#k(),"evolve");#o=d("progress",{max:1,value:0,"aria-label":"Progress of the race"});#c=d("p",{class:"small muted nu\
mbers",role:"status"});#d=ie("Draw walls","Drag over the board to draw walls, and over walls to remove them",()=>this.#F());#h=ie("Usual walls","Each match draw\
s its walls anew",()=>this.#N({walls:null}));#p=ie("Pause","",()=>this.#L());#y=ie("Again","Another race, with other luck",()=>this.#N({seed:this.#u.seed+1},!0));#m=ie(
`${Ze} more generations`,"",()=>this.#N({generations:this.#u.generations+Ze}));#s=qt("Link to this race");#l=d("span",{class:"told small",role:"status"});#i=d("\
nav",{class:"shelf small","aria-label":"Races of this visit",hidden:!0});#f;#g;#w=[];#b;#v=[];#u;#A=0;#x=!1;#S="";constructor(e,t){this.#e=e,this.#n=t;let{story:r,
dare:s,problem:o}=Di(e,de()?location.hash:"");this.#b=r.choice,this.#v=r.changes.map(({change:a})=>a),this.#u=ms(r),this.#f=Mo(e,(a,i)=>this.#N(a,i)),this.#g=new Pn(
t,a=>de()?this.#U(a):null),this.#r.append(d("div",{class:"ending",role:"group","aria-label":"What to do now"},ie("Can you escape them?","Be an evader, against t\
he best pursuers",()=>this.#_("evader"),"primary largest"),ie("Can you catch them?","Be a pursuer, against the best evaders",()=>this.#_("pursuer")),this.#m,this.#y),
d("div",{class:"doings",role:"group","aria-label":"What can be done"},this.#p,this.#d,this.#h,de()&&ie("Link","An address at which this race evolves again, on a\
ny computer",()=>this.#G()),ie("GIF","Both boards as a film",()=>this.#H()),ie("Picture","Both boards and what came out",()=>{this.#V()}),ie("Save","An archive \
that matrixworld judge, explore and replay read",()=>{this.#K()}),this.#s,this.#l)),document.getElementById("page").replaceWith(Hs("Evolve a chase","Triangles c\
hase discs. Nobody has told either team how. Press Evolve, and both learn by trial and error, against each other."),d("main",{},d("div",{class:"start"},this.#a,
d("div",{class:"progress"},this.#o,this.#c)),this.#t,this.#i,this.#f.main,this.#f.more,d("div",{class:"card below"},Zt(),d("p",{class:"small muted"},"The page p\
lays and learns with the engine of matrixworld, in this browser; nothing is sent."),d("p",{class:"small muted of-saving"},"A saved race is an archive: ",d("code",
{},"matrixworld judge"),", ",d("code",{},"explore")," and ",d("code",{},"replay")," read it. Python plays its matches again, and does not continue it."))),d("fo\
oter",{class:"muted small"},`matrixworld ${e.version}`),this.#g.dialog),this.#E(),this.#l.textContent=o,this.#R(r,s)}#R(e,t){let r=e.watched.length?Pi(Wt(this.#e,
e)):null;if(r?.length===this.lanes.length){this.#S=Wt(this.#e,e);for(let[c,u]of this.lanes.entries())u.restore(this.#T(c),r[c],e.watched[c],e.changes.map(({at:h})=>h[c]))}
let s=()=>{e.watched.length&&!r&&this.#P(e)};if(!t)return s();let o=this.#T(0),a={pursuer:this.lanes[0].run.playing("pursuer",t.pursuer),evader:this.lanes[0].run.
playing("evader",t.evader)},i=t.seat<o.world.n_pursuers?"pursuer":"evader",l=[{name:`the best ${i}s`,text:"",policy:()=>a[i]}];this.#g.play(i,{world:o.world,policies:a,
players:l,seed:o.seed,rate:t.rate,friend:t},t),this.#g.dialog.addEventListener("close",s,{once:!0})}#M(e=this.#u){return[e.schedule,...e.beside?[e.beside]:[]]}#T(e,t=this.#u){
return dn(this.#e,t,this.#M(t)[e])}#E(){for(let e of this.lanes.splice(0))e.close();for(let[e]of this.#M().entries()){let t=new Xn(this.#e,this.#n,"evolve",this.#T(
e));t.addEventListener("state",()=>this.#C()),this.lanes.push(t)}this.#w=this.lanes.map(e=>e.after.drawWalls(([t,r],s)=>this.#W(t,r,s))),this.#d.ariaPressed="fa\
lse",this.#t.dataset.count=String(this.lanes.length),this.#t.replaceChildren(...this.lanes.map(({element:e})=>e)),this.lanes.length>1?this.#t.before(this.#r):this.
lanes[0].boards.after(this.#r),this.#f.show(this.#u),this.#C()}#k(){let e=this.lanes.map(({state:t})=>t);e.includes("evolving")?this.lanes.forEach(t=>t.stop()):
e.includes("stopped")?this.lanes.forEach(t=>t.state==="stopped"&&t.go()):this.#$()}#$(){this.#l.textContent="",this.#S="";for(let[e,t]of this.lanes.entries())t.
start(this.#T(e))}#P({choice:e,changes:t,watched:r}){this.#x=!0;let s=e,o=t.map(({change:a})=>s={...s,...a});for(let[a,i]of this.lanes.entries()){let l=t.map(({
at:c},u)=>({at:c[a],settings:this.#T(a,o[u])}));i.start(this.#T(a,e),l,r[a])}}get#O(){let e=this.lanes.some(({state:t})=>t==="waiting");return{choice:this.#b,changes:this.#v.
map((t,r)=>({change:t,at:this.lanes.map(({changed:s,epochs:o})=>s[r]??o)})),watched:e?[]:this.lanes.map(({state:t,epochs:r})=>t==="evolving"?1/0:r)}}#N=(e,t=!1)=>{
let r=this.#M().length,s=this.lanes.every(({state:l})=>l==="waiting");this.#x&&!t&&(this.#v=this.#v.slice(0,Math.min(...this.lanes.map(({changed:l})=>l.length))),
this.#u=this.#v.reduce((l,c)=>({...l,...c}),this.#b)),this.#x=!1;let o={...this.#u,...e},a=o.generations>un?`A race has at most ${un} generations here.`:mn(o,this.#e.
worlds[o.world]);if(this.#f.show(a?this.#u:o),this.#l.textContent=a,a)return;this.#u=o;let i=this.#O;if(t||s){if(this.#b={...o,generations:Ze},this.#v=[],this.#u=
this.#b,!s&&de()&&history.pushState(null,"","#"),this.#M().length!==r&&this.#E(),!s)return this.#$()}else this.#v.push(e);if(this.lanes.some(l=>l.kept))this.#S=
"",this.#P({...i,changes:[...i.changes,{change:e,at:i.watched}],watched:this.lanes.map(()=>1/0)});else for(let[l,c]of this.lanes.entries())c.change(this.#T(l))};#W(e,t,r){
let{settings:{world:{rows:s,cols:o}},after:a}=this.lanes[0],i=Array.from({length:s*o},(m,p)=>p).filter(m=>a.recording.obstacles[m]),l={...this.#u,walls:Xt(this.#u.
walls??i,e*o+t,r)},c=mn(l,this.#e.worlds[l.world]);if(c)return c;this.#u=l;let{walls:u}=l,h=Uint8Array.from({length:s*o},(m,p)=>Number(u.includes(p)));for(let m of this.
lanes)m.after.showWalls(h);return clearTimeout(this.#A),this.#A=setTimeout(()=>this.#N({walls:u}),Gu),""}#F(){let e=this.#d.ariaPressed!=="true";this.#d.ariaPressed=
String(e);for(let t of this.#w)t(e)}#_(e){let{run:t,champions:r,outcome:s}=this.lanes[0],o={pursuer:t.playing("pursuer",r.pursuer),evader:t.playing("evader",r.evader)},
a=Array.from({length:(t.best?.[e]??t.newest)+1},(i,l)=>({name:`generation ${l}`,text:"",policy:()=>t.policy(e,l)}));this.#g.play(e,{world:t.world,policies:o,players:a,
seed:this.#u.seed,rate:Math.round(100*(s?.rate??0)),friend:null},{seed:String(vr(this.#n,t.world,e==="evader"?t.world.n_pursuers:0)),episode:0})}#L(){let e=!this.
lanes[0].chases.runs;for(let{chases:t}of this.lanes)t.runs=e;this.#C()}#I(){let e=this.lanes.map(({state:t})=>t);return e.every(t=>t==="waiting")?"waiting":e.includes(
"evolving")?"evolving":e.includes("stopped")?"stopped":"ended"}#C(){if(!this.lanes.length)return;let e=this.#I();document.body.dataset.state=e,this.#a.textContent=
{waiting:"Evolve",evolving:"Stop",stopped:"Go on",ended:""}[e],this.#a.hidden=e==="ended",this.#p.textContent=this.lanes[0].chases.runs?"Pause":"Play",this.#h.hidden=
!this.#u.walls,this.#y.textContent=`Again, with seed ${this.#u.seed+1}`,this.#o.value=Math.min(...this.lanes.map(({done:a})=>a));let t=Math.max(...this.lanes.map(
a=>a.seconds)),{seed:r}=this.#u,s=this.lanes.map(a=>a.newestGeneration).join(" and ");this.#c.textContent={waiting:"",evolving:`Seed ${r}: generation ${s}`,stopped:`\
Seed ${r}: stopped at generation ${s}.`,ended:`Seed ${r}: ${s} generations in ${t.toFixed(1)} seconds.`}[e];let o=Wt(this.#e,this.#O);this.#s.hidden=this.#s.value!==
this.#U(),de()&&o.length<=Ut&&location.hash.slice(1)!==o&&history.replaceState(null,"",`#${o}`),(e==="ended"||e==="stopped")&&(this.#x=!1),e==="ended"&&this.lanes.
every(({outcome:a})=>a)&&this.#B(o),this.#D()}async#B(e){if(this.#S===e||!de())return;this.#S=e;let t=`${this.#u.world}, seed ${this.#u.seed}: ${z(this.lanes[0].
outcome.rate)} are caught`,r=await Promise.all(this.lanes.map(s=>s.keep()));this.#S!==e||!r.every(cs)||($i({address:e,title:t},r),this.#D())}#D(){let e=de()?_i().
filter(({address:r})=>r!==location.hash.slice(1)):[],t=e.map(({address:r})=>r).join(" ");this.#i.dataset.shown!==t&&(this.#i.dataset.shown=t,this.#i.hidden=!e.length,
this.#i.replaceChildren("Races before: ",...e.map(({address:r,title:s})=>d("a",{href:`#${r}`},s))))}#U(e){let t=Wt(this.#e,this.#O,e);return t.length>Ut?null:`${location.
href.split("#")[0]}#${t}`}#G(){let e=this.#U();e?Jt(this.#s,e):this.#l.textContent="This race has too many changes for a link: save it."}get#z(){let e=this.#U()??
location.href;return location.protocol==="file:"?e.slice(e.split("#")[0].lastIndexOf("/")+1):e}get#j(){let{before:e,after:t}=this.lanes[0];return[e,t].filter(({
recording:r})=>r).map(r=>({title:r.title.split(":")[0],recording:r.recording}))}#H(){qe(`chase-seed-${this.#u.seed}.gif`,Ri(this.#j))}async#V(){let{outcome:e,settings:t}=this.
lanes[0],r=[...e?.sentence.split(new RegExp("(?<=\\.) "))??[`Generation ${this.lanes[0].newestGeneration}`],`${this.#u.world}, seed ${t.seed}, ${t.schedule.generations}\
 generations of pursuers and evaders that learn against each other`,this.#z];qe(`chase-seed-${this.#u.seed}.png`,await ki(this.#j,r))}async#K(){let e=await Promise.
all(this.lanes.map(async r=>({name:sn(r.settings),race:await r.saved()})));if(!e.every(({race:r})=>cs(r))){this.#l.textContent="Wait for the next generation, an\
d save then.";return}let t=`${e.map(r=>r.name).join("-and-")}-seed-${this.#u.seed}.zip`;qe(t,Ai(e,this.#e)),this.#l.textContent=`Saved as ${t}.`}};async function zu(){
let n=new ps(xo(),await Yt());document.addEventListener("keydown",({key:e,target:t,ctrlKey:r,metaKey:s,altKey:o})=>{t instanceof HTMLInputElement||t instanceof HTMLSelectElement||
document.querySelector("dialog[open]")||r||s||o||(e.toLowerCase()==="d"?mr():e.toLowerCase()==="a"&&n.lanes[0].askNext())}),window.addEventListener("hashchange",
()=>location.reload()),Object.assign(window,{matrixworldEvolve:n})}typeof document>"u"?is(globalThis):js(zu());})();
