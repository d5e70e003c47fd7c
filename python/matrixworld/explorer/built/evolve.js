/* built from web/ by "npm run build"; sources 935dfac1aaac763b3137186728bf53d2313bb373e9627ddd8f84a14c7c4e33be */
"use strict";(()=>{var Ss={SIMULTANEOUS:0,SWARM_TURNS:1,AGENT_TURNS:2},mt={DISAPPEAR:0,REACH:1,BOUNCE:2},As={OCCUPATION:0,SURROUND:1},Ms={FAULT:0,INVOLVED:1};var ar=["obstacle","teammate","adversary"],ir=["vertex","edge","chain"],Ts=["turn","kind","form","first","second","row","col","at_fault","held","doomed"],lr=["p\
ursuer_{number}","evader_{number}"],Es={obstacle:"{first} ran into the obstacle or border at {cell}",vertex:"{first} and {second} both headed for {cell}",edge:"\
{first} and {second} meant to swap, {first} to {cell}",chain:"{first} headed for {cell}, where {second} had to stay"},pt={"both held":"both bounce","both doomed":"\
both disappear",held:"{agent} bounces",doomed:"{agent} disappears",none:"nobody is stopped"},Cs="{event}: {outcome}",cr={random:"any action, all equally likely",
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
id (0 to 1)",escapes:"share of the cells that an evader may be on after its next move which hold no obstacle and which no pursuer in view reaches in one move: o\
f the nearest adversary, or an evader's own (0 to 1)",opposite:"(1 - cosine) / 2 of the angle at the nearest adversary between the agent and the teammate neares\
t to it; for an evader, of the angle at itself between its two nearest adversaries (0 to 1)",parity:"1 if the distance to the nearest adversary is odd (0 to 1)"},
Os={free:".GS",blocked:"#@OTW"};var Ke=1+Ts.length;function ft(n,e){return n.replace(/\{(\w+)\}/g,(t,r)=>String(e[r]))}function ie(n,e){return n<e?ft(lr[0],{number:n}):ft(lr[1],{number:n-e})}function Xi(n,e){
let[t,r,s,o,a,i,l,...c]=Array.from(n),u=a<0?[o]:[o,a],[h,m,p]=c.map(v=>u.filter((w,x)=>v>>x&1)),y=u.map(v=>ie(v,e)),f=ft(Es[a<0?"obstacle":ir[s]],{first:y[0],second:y[y.
length-1],cell:`(${i}, ${l})`}),g=ft(Cs,{event:f,outcome:Qi(u.length,m,p,e)});return{kind:ar[r],form:ir[s],agents:u,cell:[i,l],at_fault:h,held:m,doomed:p,turn:t,
text:g}}function Qi(n,e,t,r){if(n===2&&e.length===2)return pt["both held"];if(n===2&&t.length===2)return pt["both doomed"];let s=o=>a=>ft(pt[o],{agent:ie(a,r)});
return[...e.map(s("held")),...t.map(s("doomed"))].join(", ")||pt.none}function Ht(n,e){let t=[];for(let r=0;r<n.length;r+=Ke)t.push(Xi(n.subarray(r+1,r+Ke),e));
return t}var Ce=class extends Error{name="EngineError"};function G(n,e,t){let r=typeof t=="string"?`'${t}'`:typeof t=="object"?JSON.stringify(t):String(t);return new Ce(
`${n}: expected ${e}, got ${r}`)}var qe=class{bytes;constructor(e){this.bytes=e}},_s=0,hr=[Uint8Array,Uint8Array,Int32Array,BigInt64Array,BigUint64Array,Float32Array,Float64Array],ks=4,Rs=4,el=new TextEncoder,
tl=new TextDecoder;function nl(n){for(let e=hr.length-1;e>_s;--e)if(n instanceof hr[e])return e;throw new TypeError("array: expected a typed array of the engine\
's numbers, got another")}function ur(n){return new Uint8Array(n.buffer,n.byteOffset,n.byteLength)}function rl(n){return el.encode(`${n}\0`)}var dr=class{engine;addresses=[];constructor(e){
this.engine=e}copy(e){let t=this.engine._malloc(Math.max(e.length,1));if(t===0)throw new Ce("memory: expected room for the arguments, got none");return this.addresses.
push(t),this.engine.HEAPU8.set(e,t),t}text(e){return this.copy(rl(e))}arrays(e){let t=Object.entries(e),r=t.flatMap(([o,a])=>{let i=a instanceof qe,l=i?a.bytes:
a;return[this.text(o),i?_s:nl(l),l.length,this.copy(ur(l))]}),s=this.copy(ur(Int32Array.from(r)));return this.copy(ur(Int32Array.of(t.length,s)))}free(){for(let e of this.
addresses)this.engine._free(e)}};function Ps(n,e){let t=n.HEAPU8;return tl.decode(t.subarray(e,t.indexOf(0,e)))}function Je(n){let e=new Int32Array(n.HEAPU8.buffer),
t=n._last_outputs()/ks,r=e[t+1]/ks,s={};for(let o=r;o<r+e[t]*Rs;o+=Rs){let a=hr[e[o+1]],i=e[o+2]*a.BYTES_PER_ELEMENT,l=e[o+3];s[Ps(n,e[o])]=new a(n.HEAPU8.slice(
l,l+i).buffer)}return s}function Oe(n,e){let t=new dr(n);try{let r=e(t);if(r===0)throw new Ce(Ps(n,n._last_error()));return r}finally{t.free()}}var sl=2**31-1,$s=["none","gru"],ol=2n**64n-1n,al=34028234663852886e22;function de(n,e){if(typeof e!="number"||!Number.isInteger(e)||Math.abs(e)>sl)throw G(n,"a\
n integer",e);return Int32Array.of(e)}function Vt(n,e){if(typeof e!="boolean")throw G(n,"true or false",e);return new qe(Uint8Array.of(Number(e)))}function Fe(n,e,t){
let r=typeof e=="string"&&Object.hasOwn(t,e)?t[e]:void 0;if(r===void 0)throw G(n,`one of ${Object.keys(t).join(", ")}`,e);return Int32Array.of(r)}function mr(n,e){
if(typeof e!="number"||!(Math.abs(e)<=al))throw G(n,"a finite number",e);return e}function yt(n,e){let r=typeof e=="bigint"||typeof e=="number"&&Number.isSafeInteger(
e)?BigInt(e):-1n;if(r<0n||r>ol)throw G(n,"an integer from 0 to 2^64 - 1",e);return BigUint64Array.of(r)}function il(n){return{"rules.interaction":Fe("interactio\
n",n.interaction,Ss),"rules.obstacle":Fe("obstacle",n.obstacle,mt),"rules.teammate":Fe("teammate",n.teammate,mt),"rules.evader":Fe("evader",n.evader,mt),"rules.\
pursuer":Fe("pursuer",n.pursuer,mt),"rules.capture":Fe("capture",n.capture,As),"rules.captured_disappear":Vt("captured_disappear",n.captured_disappear)}}function Is(n,e){
let t=typeof e=="number"?[e,e,e]:e;if(!Array.isArray(t)||t.length!==3)throw G(n,"1 or 3 numbers",e);return Float32Array.from(t,r=>mr(n,r))}function ll(n){let e=(t,r)=>Float32Array.
of(mr(t,n[t]),mr(r,n[r]));return{"rewards.capture":e("pursuer_capture","evader_capture"),"rewards.neighbor":e("pursuer_neighbor","evader_neighbor"),"rewards.ste\
p":e("pursuer_step","evader_step"),"rewards.pursuer_collide":Is("pursuer_collide",n.pursuer_collide),"rewards.evader_collide":Is("evader_collide",n.evader_collide),
"rewards.blame":Fe("blame",n.blame,Ms),"rewards.capture_repeats":Vt("capture_repeats",n.capture_repeats)}}function Fs(n){if(n===void 0||typeof n=="number")return new Uint8Array(
0);if(n instanceof Uint8Array)return n;let{free:e,blocked:t}=Os;for(let[r,s]of n.entries()){if(s.length!==n[0]?.length)throw G(`map, row ${r}`,`${n[0]?.length} \
cells as in row 0`,s.length);let o=[...s].find(a=>!e.includes(a)&&!t.includes(a));if(o)throw G(`map, row ${r}`,`'${e}' (free) or '${t}' (obstacle)`,o)}return Uint8Array.
from([...n.join("")],r=>Number(t.includes(r)))}function Ds(n,e){if(!Array.isArray(n))return;let t=[n.length,n[0]?.length??0];if(!(t[0]===e.rows&&t[1]===e.cols))
throw G("obstacle map",`shape (${e.rows}, ${e.cols}), the rows and cols`,t)}function Ze(n){Ds(n.obstacles,n);let e=typeof n.obstacles=="number"?n.obstacles:0;return{
...il(n.rules),...ll(n.rewards),rows:de("rows",n.rows),cols:de("cols",n.cols),n_pursuers:de("n_pursuers",n.n_pursuers),n_evaders:de("n_evaders",n.n_evaders),fov:de(
"fov",n.fov),diagonal:Vt("diagonal",n.diagonal),max_steps:de("max_steps",n.max_steps),density:Float64Array.of(e),map:Fs(n.obstacles)}}function Ns(n,e){return Int32Array.
from((e??[]).flat(),t=>de(n,t)[0])}function Us(n,e){return Ds(n.obstacles,e),{seed:yt("seed",n.seed??0n),episode:yt("episode",n.episode??0),pursuers:Ns("pursuer\
s",n.pursuers),evaders:Ns("evaders",n.evaders),map:Fs(n.obstacles)}}function Yt(n){return{actions:Int32Array.from(n,e=>de("actions",e)[0])}}var Ls=Object.keys(Le);
function pr(n){let e=Ls.indexOf(n);if(e<0)throw G("inputs",`names of ${Ls.join(", ")}`,n);return e}function De(n){if(typeof n=="string"){if(!Object.hasOwn(cr,n))
throw G("policy",`one of ${Object.keys(cr).join(", ")}`,n);return{script:new TextEncoder().encode(n)}}if(n.kind!=="cells")return{inputs:Int32Array.from(n.inputs,
e=>pr(e)),hidden:Int32Array.from(n.kind==="rating"?n.hidden:[],e=>de("hidden",e)[0]),length:de("length",n.kind==="program"?n.length:0),mask:new TextEncoder().encode(
n.mask),genome:n.genome};if(n.activation!=="relu"&&n.activation!=="tanh")throw G("activation","'relu' or 'tanh'",n.activation);if(!$s.includes(n.memory))throw G(
"memory",`one of ${$s.join(", ")}`,n.memory);return{hidden:Int32Array.from(n.hidden,e=>de("hidden",e)[0]),activation:new TextEncoder().encode(n.activation),sampled:Vt(
"sampled",n.sampled),memory:new TextEncoder().encode(n.memory),genome:n.genome}}var cl=["first_turn","terminated","truncated"];function Ws(n){let e={...n};for(let t of cl)
e[t]=new qe(n[t]);return e}var Bs="statistics.",Kt=class{config;seed;episode;n_agents;statistics;first_conflict;constructor(e,t,r,s){this.config=e,this.seed=t,this.episode=r,this.n_agents=
e.n_pursuers+e.n_evaders,this.statistics=hl(js(s)),Object.assign(this,s),this.first_conflict=ul(this.conflict_table,this.length)}get length(){return this.actions.
length/this.n_agents}conflicts(e){this.check(e);let t=this.first_conflict[e],r=this.first_conflict[e+1],s=this.conflict_table.subarray(t*Ke,r*Ke);return Ht(s,this.
config.n_pursuers)}seek(e,t,r){this.check(t),(!(e.seed===this.seed&&e.episode===BigInt(this.episode))||e.turn!==0||e.steps>t)&&e.reset({seed:this.seed,episode:this.
episode});for(let o=e.steps;o<t;++o){let a=this.actions.subarray(o*this.n_agents,(o+1)*this.n_agents);r?e.replay(a,{pursuer:r.pursuers,evader:r.evaders}):e.step(
a)}}check(e){if(!(Number.isInteger(e)&&e>=0&&e<=this.length))throw G("step",`0 to ${this.length}`,e)}};function ul(n,e){let t=new Int32Array(e+2);for(let r=0;r<
n.length;r+=Ke)++t[n[r]+1];for(let r=1;r<t.length;++r)t[r]+=t[r-1];return t}function hl(n){let e=["capture_rate","ever_capture_rate","captured_fraction","length"];
return Object.fromEntries(Object.entries(n).map(([t,r])=>[t,e.includes(t)?Number(r[0]):r]))}var js=n=>Object.fromEntries(Object.entries(n).flatMap(([e,t])=>e.startsWith(
Bs)?[[e.slice(Bs.length),t]]:[]));function Gs(n,e,t,r){let s=[Ze(t.config),De(t.pursuers),De(t.evaders),r];return Oe(n,o=>{let[a,i,l,c]=s.map(u=>o.arrays(u));return n[e](
a,i,l,c)}),Je(n)}function zs(n,e,t,r){let s={seed:yt("seed",t),episode:yt("episode",r)};return new Kt(e.config,t,r,Gs(n,"_play_match",e,s))}function Hs(n,e,t,r){
if(!Number.isInteger(r)||r<1)throw G("n_episodes","at least 1",r);let s=Gs(n,"_play_rollout",e,{...t,n_episodes:Int32Array.of(r)});return js(s)}var dl=7e6,ml=new FinalizationRegistry(([n,e])=>n._states_free(e));function pl({rules:n,rows:e,cols:t,obstacles:r,diagonal:s,n_pursuers:o,n_evaders:a}){let i=typeof r==
"number"||n.obstacle==="REACH"?0:r.join("").split("#").length-1,l=e*t-i,c=[n.obstacle,n.teammate,n.pursuer].includes("DISAPPEAR"),u=n.capture==="SURROUND"||n.evader===
"REACH",h=n.interaction==="AGENT_TURNS",m=(f,g)=>Array.from({length:g},(v,w)=>h?f:(f+w)/(w+1)).reduce((v,w)=>v*w,1),p=m(l+Number(c),o)*m(l*(1+Number(u))+2,a);return{
SIMULTANEOUS:[o+a],SWARM_TURNS:[o,a],AGENT_TURNS:Array(o+a).fill(1)}[n.interaction].reduce((f,g)=>f+p*(s?9:5)**g,0)}function qt(n){return typeof n.obstacles=="n\
umber"&&n.obstacles>0?"obstacles are drawn anew in each episode":pl(n)>dl?"the world is too large to be solved on the page":""}var fr=class{value;teams;matrix;n_actions;constructor(e,t){
let{matrix:r,rows:s,cols:o,value:a,agents:i}=t,[l,c]=e.actors,u=Array.from(i).filter(m=>l<=m&&m<c),h=m=>m<e.config.n_pursuers;this.value=a[0],this.matrix=r,this.
n_actions=e.n_actions,this.teams=[{agents:u.filter(h),play:s},{agents:u.filter(m=>!h(m)),play:o}]}marginal(e){let t=this.teams.find(({agents:o})=>o.includes(e));
if(!t)return null;let r=this.n_actions**(t.agents.length-1-t.agents.indexOf(e)),s=Array(this.n_actions).fill(0);return t.play.forEach((o,a)=>s[Math.floor(a/r)%this.
n_actions]+=o),s}lost(e){let[t,r]=this.teams.map(({agents:l})=>l.reduce((c,u)=>c*this.n_actions+e[u],0)),[s,o]=this.teams.map(({play:l})=>l),a=o.reduce((l,c,u)=>l+
c*this.matrix[t*o.length+u],0),i=s.reduce((l,c,u)=>l+c*this.matrix[u*o.length+r],0);return[Math.max(0,this.value-a),Math.max(0,i-this.value)]}},yr=60,gt=class{config;payoff;engine;states;n_turns;values;constructor(e,t,r){
this.engine=e,this.config=t,this.payoff=r,this.states=Oe(e,i=>e._states_new(i.arrays(Ze(t)))),ml.register(this,[e,this.states]);let s={SIMULTANEOUS:1,SWARM_TURNS:2,
AGENT_TURNS:t.n_pursuers+t.n_evaders};this.n_turns=s[t.rules.interaction];let{payoffs:o}=this.call(()=>e._states_payoffs(this.states)),a=o;this.values=[[r==="ca\
pture-rate"?a:a.fill(0)]]}goBack(){let e=this.values.at(-1)[0],t=[];for(let s=this.n_turns-1;s>=0;s--){let o=t[s+1]??e;t[s]=this.backup(s,{next:o})}this.payoff===
"capture-time"&&(t[0]=t[0].map((s,o)=>o===this.config.n_evaders?0:s-1)),this.values.push(t);let r=this.payoff==="capture-rate"?this.config.max_steps:Math.min(this.
config.max_steps,yr);return this.values.length<=r&&t[0].some((s,o)=>s!==e[o])}backup(e,t){return this.call(r=>this.engine._states_backup(this.states,e,r.arrays(
t))).values}game(e){let t=this.config.max_steps-e.steps,{turn:r}=e,s=r+1===this.n_turns,o=t>0?this.values[Math.min(t-Number(s),this.values.length-1)]?.[s?0:r+1]:
void 0;if(!o)return null;let a=this.call(i=>this.engine._states_game(this.states,e.address,i.arrays({next:o})));return a.agents.length?new fr(e,a):null}call(e){
return Oe(this.engine,e),Je(this.engine)}};var Vs=new FinalizationRegistry(([n,e])=>n._world_free(e)),vt=class{config;n_agents;n_actions;engine;at;freed=!1;constructor(e,t){this.engine=e,this.config=t,this.
n_agents=t.n_pursuers+t.n_evaders,this.n_actions=t.diagonal?9:5,this.at=Oe(e,r=>e._world_new(r.arrays(Ze(t)))),Vs.register(this,[e,this.at],this)}free(){this.freed||
(this.freed=!0,Vs.unregister(this),this.engine._world_free(this.at))}get address(){if(this.freed)throw G("world","one that is in use","one that was freed");return this.
at}reset(e={}){let t=Us(e,this.config);this.call(r=>this.engine._world_reset(this.address,r.arrays(t)))}step(e){let t=Yt(e);this.call(r=>this.engine._world_step(
this.address,r.arrays(t)))}playTurn(e){let t=Yt(e);this.call(r=>this.engine._world_play_turn(this.address,r.arrays(t)))}decide(e,t,r){let{n_pursuers:s}=this.config,
o={pursuer:[0,s],evader:[s,this.n_agents]},[a,i]=typeof t=="string"?o[t]:t;if(r.length!==this.n_agents)throw G("actions",String(this.n_agents),r.length);let l=[
De(e),Yt(r)],{actions:c}=this.call(u=>this.engine._world_decide(this.address,u.arrays(l[0]),a,i,u.arrays(l[1])));return Uint8Array.from(c)}replay(e,t){let r=o=>typeof o!=
"string"&&o.kind==="cells"&&o.memory!=="none";if(!r(t.pursuer)&&!r(t.evader))return this.step(e);let{n_pursuers:s}=this.config;for(let o=this.n_turns;o>0;--o){let[
a,i]=this.actors;a<s&&this.decide(t.pursuer,[a,Math.min(i,s)],e),i>s&&this.decide(t.evader,[Math.max(a,s),i],e),this.playTurn(e)}}get n_turns(){return this.turnNumbers()[1]}get turn(){
return this.turnNumbers()[0]}get actors(){let[,,e,t]=this.turnNumbers();return[e,t]}turnNumbers(){return this.call(()=>this.engine._world_turn(this.address)).turn}get steps(){
return this.read("steps")[0]}get seed(){return this.read("seed")[0]}get episode(){return this.read("episode")[0]}get over(){return this.read("terminated")[0]===
1||this.read("truncated")[0]===1}read(e){return this.call(t=>this.engine._world_read(this.address,t.text(e)))[e]}view(e){let t=3*this.config.fov**2;return this.
read("views").slice(e*t,(e+1)*t)}map(){return this.read("state").slice(2*this.config.rows*this.config.cols)}conflicts(){return Ht(this.conflictTable(),this.config.
n_pursuers)}conflictTable(){return this.call(()=>this.engine._world_conflicts(this.address)).conflict_table}answer(e,t){let r=De(e),{logits:s,memory:o}=this.call(
l=>this.engine._world_logits(this.address,l.arrays(r),t)),a=s,i=this.decide(e,[t,t+1],new Uint8Array(this.n_agents))[t];return{logits:a,probabilities:fl(a),action:i,
memory:o}}rate(e,t){let r=De(e),{ratings:s,refused:o}=this.call(c=>this.engine._world_rate(this.address,c.arrays(r),t)),a=this.read("inputs"),i=a.length/this.n_agents/
this.n_actions,l=c=>Float32Array.from({length:this.n_actions},(u,h)=>a[(t*this.n_actions+h)*i+c]);return{inputs:e.inputs.map(c=>l(pr(c))),ratings:s,refused:o}}snapshot(){
return this.call(()=>this.engine._world_snapshot(this.address))}restore(e){let t=Ws(e);this.call(r=>this.engine._world_restore(this.address,r.arrays(t)))}call(e){
return Oe(this.engine,e),Je(this.engine)}};function fl(n){let e=Math.max(...n),t=Array.from(n,s=>Math.exp(s-e)),r=t.reduce((s,o)=>s+o,0);return Float32Array.from(
t,s=>s/r)}var gr=class{compiled;constructor(e){this.compiled=e}world(e){return new vt(this.compiled,e)}solution(e,t="capture-rate"){return new gt(this.compiled,e,t)}match(e,t,r,s,o=0){
return zs(this.compiled,{config:e,pursuers:t,evaders:r},s,o)}rollouts(e,t,r,s,o){return Hs(this.compiled,{config:e,pursuers:t,evaders:r},s,o)}},Ys;function Jt(n=globalThis.
matrixworldEngine){return Ys??=yl(n),Ys}async function yl(n){if(!n)throw new Error("matrixworldEngine: expected the script engine.js before this one, got none");
let e=Uint8Array.from(atob(n.binary),t=>t.charCodeAt(0));return new gr(await n({wasmBinary:e}))}var gl="http://www.w3.org/2000/svg";function d(n,e={},...t){return Ks(document.createElement(n),e,t)}function M(n,e={},...t){return Ks(document.createElementNS(
gl,n),e,t)}function Ks(n,e,t){for(let[s,o]of Object.entries(e))o==null||o===!1||(typeof o=="function"?n.addEventListener(s.slice(2),o):n.setAttribute(s,o===!0?"":
String(o)));let r=t.filter(s=>s!=null&&s!==!1);return n.append(...r.map(s=>typeof s=="number"?String(s):s)),n}function re(n,e){let t=d("select",{onchange:()=>e(
t.value)},...n.map(([r,s])=>d("option",{value:r},s)));return t}async function qs(n){try{await n}catch(e){let t=document.querySelector("#page, main")??document.body;
throw t.querySelector(".absent")?.remove(),t.prepend(d("p",{class:"card problem",role:"alert"},e instanceof WebAssembly.CompileError||/WebAssembly/.test(String(
e))?"This page plays by WebAssembly, which is forbidden where it lies ('wasm-unsafe-eval' is missing in the content policy): save the file, and open it from you\
r disk.":`The page could not start: ${String(e)}`)),e}finally{document.body.dataset.ready="true"}}var ge=()=>["file:","http:","https:"].includes(location.protocol);var Zt=n=>d("input",{type:"text",readonly:!0,"aria-label":n});function Xt(n,e){n.value=e,n.hidden=!1,n.select(),navigator.clipboard?.writeText(e).catch(()=>{})}
function Xe(n,e){let t=URL.createObjectURL(new Blob([e],{type:"application/octet-stream"}));d("a",{href:t,download:n}).click(),setTimeout(()=>URL.revokeObjectURL(
t),6e4)}var Js=()=>document.documentElement.dataset.theme==="dark";function bt(n){document.documentElement.dataset.theme=n?"dark":"light"}var vr=()=>bt(!Js());if(typeof document<
"u"){let n=matchMedia("(prefers-color-scheme: dark)");n.addEventListener("change",()=>bt(n.matches)),bt(n.matches);let e=!1;addEventListener("beforeprint",()=>{
e=Js(),bt(!1)}),addEventListener("afterprint",()=>bt(e))}function Zs(){return d("button",{type:"button",title:"Light or dark (D)","aria-label":"Light or dark",onclick:vr},
"◐")}var Xs=(n,e,...t)=>d("header",{class:"top"},d("div",{},d("h1",{},n),e?d("p",{class:"lead"},e):null),d("div",{class:"tools"},...t,Zs()));var vl=Array.from({length:16},(n,e)=>{let t=e%2?6.5:11,r=Math.PI*e/8;return`${12+t*Math.sin(r)} ${12-t*Math.cos(r)}`}).join(" ");function Qt(){let n=[["pursuer",
M("path",{d:"M12 3 22 20H2z",class:"filled-pursuer"})],["evader",M("circle",{cx:12,cy:12,r:9,class:"filled-evader"})],["capture",M("polygon",{points:vl,class:"f\
illed-capture"})],["captured evader",M("circle",{cx:12,cy:12,r:7.5,class:"ring-evader"})],["conflict",M("rect",{x:3,y:3,width:18,height:18,class:"dashed-conflic\
t"})]];return d("ul",{class:"shapes small","aria-label":"Shapes on the board"},...n.map(([e,t])=>d("li",{},M("svg",{viewBox:"0 0 24 24","aria-hidden":"true"},t),
e)))}var se=["stay","north","east","south","west","northeast","southeast","southwest","northwest"];var Qs="champion",eo=0,br=64,wr=100;var bl=(n,e)=>Object.keys(n).every(t=>n[t]===e[t]);function to(n,e){return Object.keys(e).find(t=>bl(e[t],n))??null}function no(n,e,t){let r=new Set(n);return Array.
from({length:e},(s,o)=>Array.from({length:t},(a,i)=>r.has(o*t+i)?"#":".").join(""))}function en(n,e,t){let r=n.filter(s=>s!==e);return t?[...r,e].sort((s,o)=>s-
o):r}var T=["pursuer","evader"],le=n=>n==="pursuer"?"evader":"pursuer";function xr(n,e,t){let{rows:r,cols:s,n_pursuers:o,fov:a,rules:{interaction:i}}=n;return{rows:r,cols:s,nPursuers:o,fov:a,interaction:i,obstacles:e,moments:t}}function Sr(n,e){
return{positions:n.read("last_positions"),alive:n.read("alive"),captured:n.read("captured"),everCaptured:n.read("ever_captured"),actions:e,involved:n.read("invo\
lved"),fault:n.read("fault"),contested:n.conflicts().map(t=>t.cell)}}function tn(n){let e=Array.from({length:n.length+1},(t,r)=>wl(n,r));return xr(n.config,n.map,
e)}function wl(n,e){let t=n.n_agents,r=n.config.n_evaders,s=(a,i,l)=>a.subarray(i*l,(i+1)*l),o={positions:s(n.last_positions,e,2*t),alive:s(n.alive,e,t),captured:s(
n.captured,e,r),everCaptured:s(n.ever_captured,e,r)};return e===0?o:{...o,actions:s(n.actions,e-1,t),involved:s(n.involved,e-1,3*t),fault:s(n.fault,e-1,3*t),get contested(){
return n.conflicts(e).map(a=>a.cell)}}}var wt=class{config;start;recording;actions=[];#e;#n;#t=[[]];constructor(e,t,r){this.config=t,this.start=r,this.#e=e.world(t),this.#e.reset(r),this.#n=[Sr(this.#e)],
this.recording=xr(t,this.#e.map(),this.#n)}get length(){return this.actions.length}get over(){return this.#e.over}get statistics(){return{capture_rate:this.#e.read(
"capture_rate")[0]}}conflicts(e){return this.#t[e]}game(e){return e.game(this.#e)}play(e){this.#e.step(e),this.#r(e)}step(e,t,r){let s=this.#e,o=this.config.n_pursuers,
a=new Uint8Array(s.n_agents);for(let i=s.n_turns;i>0&&!s.over;--i){let[l,c]=s.actors;l<o&&(a=s.decide(e.pursuer,[l,Math.min(c,o)],a)),c>o&&(a=s.decide(e.evader,
[Math.max(l,o),c],a)),typeof r=="number"?a[t]=r:l<=t&&t<c&&(a=s.decide(r,[t,t+1],a)),s.playTurn(a)}this.#r(a)}#r(e){this.actions.push(e),this.#n.push(Sr(this.#e,
e)),this.#t.push(this.#e.conflicts())}};var ve=(n,e)=>T[+(e>=n.n_pursuers)];function xt(n,e){let t=new wt(n,e.config,{seed:e.seed,episode:e.episode});for(let r of e.moves)t.over||t.step(e.policies,e.seat,
r);return t}function Se(n,e){let{moments:t,nPursuers:r}=n.recording,s=t.findIndex(({alive:a,captured:i})=>!a[e]||!!i[e-r]),o=s<0?n.length:s;return{lasted:o,out:s>=
0,captured:Array.from(t[o].everCaptured).filter(Boolean).length}}var nn=(n,e)=>n.over||Se(n,e).out;function ro(n,e,t){let r=xt(n,{...e,moves:e.moves.slice(0,e.from)});
for(;!nn(r,e.seat);)r.step(e.policies,e.seat,t);return Se(r,e.seat)}function so(n){let e=n.length-1;return[...new Set([0,Math.round(e/3),e])].map(t=>n[t])}var xl=()=>crypto.getRandomValues(new BigUint64Array(1))[0],Sl=8;function Ar(n,e,t){let{n_pursuers:r,n_evaders:s}=e,o=Array.from({length:r+s},(l,c)=>c).filter(l=>ve(
e,l)!==ve(e,t)),a=l=>{let c=new wt(n,e,{seed:l}).recording.moments[0].positions,u=(h,m)=>Math.abs(c[2*t+h]-c[2*m+h]);return Math.min(...o.map(h=>u(0,h)+u(1,h)))};
return Array.from({length:Sl},xl).map(l=>[l,a(l)]).reduce((l,c)=>c[1]>l[1]?c:l)[0]}var j=Uint8Array,oe=Uint16Array,Pr=Int32Array,rn=new j([0,0,0,0,0,0,0,0,1,1,1,1,2,2,2,2,3,3,3,3,4,4,4,4,5,5,5,5,0,0,0,0]),sn=new j([0,0,0,0,1,1,2,2,3,3,4,4,5,5,
6,6,7,7,8,8,9,9,10,10,11,11,12,12,13,13,0,0]),Cr=new j([16,17,18,0,8,7,9,6,10,5,11,4,12,3,13,2,14,1,15]),uo=function(n,e){for(var t=new oe(31),r=0;r<31;++r)t[r]=
e+=1<<n[r-1];for(var s=new Pr(t[30]),r=1;r<30;++r)for(var o=t[r];o<t[r+1];++o)s[o]=o-t[r]<<5|r;return{b:t,r:s}},ho=uo(rn,2),mo=ho.b,Or=ho.r;mo[28]=258,Or[258]=28;
var po=uo(sn,0),Al=po.b,oo=po.r,kr=new oe(32768);for($=0;$<32768;++$)Ae=($&43690)>>1|($&21845)<<1,Ae=(Ae&52428)>>2|(Ae&13107)<<2,Ae=(Ae&61680)>>4|(Ae&3855)<<4,kr[$]=
((Ae&65280)>>8|(Ae&255)<<8)>>1;var Ae,$,be=(function(n,e,t){for(var r=n.length,s=0,o=new oe(e);s<r;++s)n[s]&&++o[n[s]-1];var a=new oe(e);for(s=1;s<e;++s)a[s]=a[s-
1]+o[s-1]<<1;var i;if(t){i=new oe(1<<e);var l=15-e;for(s=0;s<r;++s)if(n[s])for(var c=s<<4|n[s],u=e-n[s],h=a[n[s]-1]++<<u,m=h|(1<<u)-1;h<=m;++h)i[kr[h]>>l]=c}else
for(i=new oe(r),s=0;s<r;++s)n[s]&&(i[s]=kr[a[n[s]-1]++]>>15-n[s]);return i}),ke=new j(288);for($=0;$<144;++$)ke[$]=8;var $;for($=144;$<256;++$)ke[$]=9;var $;for($=
256;$<280;++$)ke[$]=7;var $;for($=280;$<288;++$)ke[$]=8;var $,Mt=new j(32);for($=0;$<32;++$)Mt[$]=5;var $,Ml=be(ke,9,0),Tl=be(ke,9,1),El=be(Mt,5,0),Cl=be(Mt,5,1),
Mr=function(n){for(var e=n[0],t=1;t<n.length;++t)n[t]>e&&(e=n[t]);return e},me=function(n,e,t){var r=e/8|0;return(n[r]|n[r+1]<<8)>>(e&7)&t},Tr=function(n,e){var t=e/
8|0;return(n[t]|n[t+1]<<8|n[t+2]<<16)>>(e&7)},$r=function(n){return(n+7)/8|0},Ir=function(n,e,t){return(e==null||e<0)&&(e=0),(t==null||t>n.length)&&(t=n.length),
new j(n.subarray(e,t))};var Ol=["unexpected EOF","invalid block type","invalid length/literal","invalid distance","stream finished","no stream handler",,"no callback","invalid UTF-8 da\
ta","extra field too long","date not in range 1980-2099","filename too long","stream finishing","invalid zip data"],ee=function(n,e,t){var r=new Error(e||Ol[n]);
if(r.code=n,Error.captureStackTrace&&Error.captureStackTrace(r,ee),!t)throw r;return r},kl=function(n,e,t,r){var s=n.length,o=r?r.length:0;if(!s||e.f&&!e.l)return t||
new j(0);var a=!t,i=a||e.i!=2,l=e.i;a&&(t=new j(s*3));var c=function(ht){var dt=t.length;if(ht>dt){var Ye=new j(Math.max(dt*2,ht));Ye.set(t),t=Ye}},u=e.f||0,h=e.
p||0,m=e.b||0,p=e.l,y=e.d,f=e.m,g=e.n,v=s*8;do{if(!p){u=me(n,h,1);var w=me(n,h+1,3);if(h+=3,w)if(w==1)p=Tl,y=Cl,f=9,g=5;else if(w==2){var _=me(n,h,31)+257,R=me(
n,h+10,15)+4,k=_+me(n,h+5,31)+1;h+=14;for(var A=new j(k),D=new j(19),L=0;L<R;++L)D[Cr[L]]=me(n,h+L*3,7);h+=R*3;for(var F=Mr(D),fe=(1<<F)-1,X=be(D,F,1),L=0;L<k;){
var J=X[me(n,h,fe)];h+=J&15;var x=J>>4;if(x<16)A[L++]=x;else{var U=0,P=0;for(x==16?(P=3+me(n,h,3),h+=2,U=A[L-1]):x==17?(P=3+me(n,h,7),h+=3):x==18&&(P=11+me(n,h,
127),h+=7);P--;)A[L++]=U}}var S=A.subarray(0,_),C=A.subarray(_);f=Mr(S),g=Mr(C),p=be(S,f,1),y=be(C,g,1)}else ee(1);else{var x=$r(h)+4,b=n[x-4]|n[x-3]<<8,E=x+b;if(E>
s){l&&ee(0);break}i&&c(m+b),t.set(n.subarray(x,E),m),e.b=m+=b,e.p=h=E*8,e.f=u;continue}if(h>v){l&&ee(0);break}}i&&c(m+131072);for(var z=(1<<f)-1,I=(1<<g)-1,H=h;;H=
h){var U=p[Tr(n,h)&z],Q=U>>4;if(h+=U&15,h>v){l&&ee(0);break}if(U||ee(2),Q<256)t[m++]=Q;else if(Q==256){H=h,p=null;break}else{var ne=Q-254;if(Q>264){var L=Q-257,
B=rn[L];ne=me(n,h,(1<<B)-1)+mo[L],h+=B}var ye=y[Tr(n,h)&I],He=ye>>4;ye||ee(3),h+=ye&15;var C=Al[He];if(He>3){var B=sn[He];C+=Tr(n,h)&(1<<B)-1,h+=B}if(h>v){l&&ee(
0);break}i&&c(m+131072);var Ve=m+ne;if(m<C){var Gt=o-C,zt=Math.min(C,Ve);for(Gt+m<0&&ee(3);m<zt;++m)t[m]=r[Gt+m]}for(;m<Ve;++m)t[m]=t[m-C]}}e.l=p,e.p=H,e.b=m,e.
f=u,p&&(u=1,e.m=f,e.d=y,e.n=g)}while(!u);return m!=t.length&&a?Ir(t,0,m):t.subarray(0,m)},Me=function(n,e,t){t<<=e&7;var r=e/8|0;n[r]|=t,n[r+1]|=t>>8},St=function(n,e,t){
t<<=e&7;var r=e/8|0;n[r]|=t,n[r+1]|=t>>8,n[r+2]|=t>>16},Er=function(n,e){for(var t=[],r=0;r<n.length;++r)n[r]&&t.push({s:r,f:n[r]});var s=t.length,o=t.slice();if(!s)
return{t:yo,l:0};if(s==1){var a=new j(t[0].s+1);return a[t[0].s]=1,{t:a,l:1}}t.sort(function(E,_){return E.f-_.f}),t.push({s:-1,f:25001});var i=t[0],l=t[1],c=0,
u=1,h=2;for(t[0]={s:-1,f:i.f+l.f,l:i,r:l};u!=s-1;)i=t[t[c].f<t[h].f?c++:h++],l=t[c!=u&&t[c].f<t[h].f?c++:h++],t[u++]={s:-1,f:i.f+l.f,l:i,r:l};for(var m=o[0].s,r=1;r<
s;++r)o[r].s>m&&(m=o[r].s);var p=new oe(m+1),y=Rr(t[u-1],p,0);if(y>e){var r=0,f=0,g=y-e,v=1<<g;for(o.sort(function(_,R){return p[R.s]-p[_.s]||_.f-R.f});r<s;++r){
var w=o[r].s;if(p[w]>e)f+=v-(1<<y-p[w]),p[w]=e;else break}for(f>>=g;f>0;){var x=o[r].s;p[x]<e?f-=1<<e-p[x]++-1:++r}for(;r>=0&&f;--r){var b=o[r].s;p[b]==e&&(--p[b],
++f)}y=e}return{t:new j(p),l:y}},Rr=function(n,e,t){return n.s==-1?Math.max(Rr(n.l,e,t+1),Rr(n.r,e,t+1)):e[n.s]=t},ao=function(n){for(var e=n.length;e&&!n[--e];)
;for(var t=new oe(++e),r=0,s=n[0],o=1,a=function(l){t[r++]=l},i=1;i<=e;++i)if(n[i]==s&&i!=e)++o;else{if(!s&&o>2){for(;o>138;o-=138)a(32754);o>2&&(a(o>10?o-11<<5|
28690:o-3<<5|12305),o=0)}else if(o>3){for(a(s),--o;o>6;o-=6)a(8304);o>2&&(a(o-3<<5|8208),o=0)}for(;o--;)a(s);o=1,s=n[i]}return{c:t.subarray(0,r),n:e}},At=function(n,e){
for(var t=0,r=0;r<e.length;++r)t+=n[r]*e[r];return t},fo=function(n,e,t){var r=t.length,s=$r(e+2);n[s]=r&255,n[s+1]=r>>8,n[s+2]=n[s]^255,n[s+3]=n[s+1]^255;for(var o=0;o<
r;++o)n[s+o+4]=t[o];return(s+4+r)*8},io=function(n,e,t,r,s,o,a,i,l,c,u){Me(e,u++,t),++s[256];for(var h=Er(s,15),m=h.t,p=h.l,y=Er(o,15),f=y.t,g=y.l,v=ao(m),w=v.c,
x=v.n,b=ao(f),E=b.c,_=b.n,R=new oe(19),k=0;k<w.length;++k)++R[w[k]&31];for(var k=0;k<E.length;++k)++R[E[k]&31];for(var A=Er(R,7),D=A.t,L=A.l,F=19;F>4&&!D[Cr[F-1]];--F)
;var fe=c+5<<3,X=At(s,ke)+At(o,Mt)+a,J=At(s,m)+At(o,f)+a+14+3*F+At(R,D)+2*R[16]+3*R[17]+7*R[18];if(l>=0&&fe<=X&&fe<=J)return fo(e,u,n.subarray(l,l+c));var U,P,S,
C;if(Me(e,u,1+(J<X)),u+=2,J<X){U=be(m,p,0),P=m,S=be(f,g,0),C=f;var z=be(D,L,0);Me(e,u,x-257),Me(e,u+5,_-1),Me(e,u+10,F-4),u+=14;for(var k=0;k<F;++k)Me(e,u+3*k,D[Cr[k]]);
u+=3*F;for(var I=[w,E],H=0;H<2;++H)for(var Q=I[H],k=0;k<Q.length;++k){var ne=Q[k]&31;Me(e,u,z[ne]),u+=D[ne],ne>15&&(Me(e,u,Q[k]>>5&127),u+=Q[k]>>12)}}else U=Ml,
P=ke,S=El,C=Mt;for(var k=0;k<i;++k){var B=r[k];if(B>255){var ne=B>>18&31;St(e,u,U[ne+257]),u+=P[ne+257],ne>7&&(Me(e,u,B>>23&31),u+=rn[ne]);var ye=B&31;St(e,u,S[ye]),
u+=C[ye],ye>3&&(St(e,u,B>>5&8191),u+=sn[ye])}else St(e,u,U[B]),u+=P[B]}return St(e,u,U[256]),u+P[256]},Rl=new Pr([65540,131080,131088,131104,262176,1048704,1048832,
2114560,2117632]),yo=new j(0),_l=function(n,e,t,r,s,o){var a=o.z||n.length,i=new j(r+a+5*(1+Math.ceil(a/7e3))+s),l=i.subarray(r,i.length-s),c=o.l,u=(o.r||0)&7;if(e){
u&&(l[0]=o.r>>3);for(var h=Rl[e-1],m=h>>13,p=h&8191,y=(1<<t)-1,f=o.p||new oe(32768),g=o.h||new oe(y+1),v=Math.ceil(t/3),w=2*v,x=function(or){return(n[or]^n[or+1]<<
v^n[or+2]<<w)&y},b=new Pr(25e3),E=new oe(288),_=new oe(32),R=0,k=0,A=o.i||0,D=0,L=o.w||0,F=0;A+2<a;++A){var fe=x(A),X=A&32767,J=g[fe];if(f[X]=J,g[fe]=X,L<=A){var U=a-
A;if((R>7e3||D>24576)&&(U>423||!c)){u=io(n,l,0,b,E,_,k,D,F,A-F,u),D=R=k=0,F=A;for(var P=0;P<286;++P)E[P]=0;for(var P=0;P<30;++P)_[P]=0}var S=2,C=0,z=p,I=X-J&32767;
if(U>2&&fe==x(A-I))for(var H=Math.min(m,U)-1,Q=Math.min(32767,A),ne=Math.min(258,U);I<=Q&&--z&&X!=J;){if(n[A+S]==n[A+S-I]){for(var B=0;B<ne&&n[A+B]==n[A+B-I];++B)
;if(B>S){if(S=B,C=I,B>H)break;for(var ye=Math.min(I,B-2),He=0,P=0;P<ye;++P){var Ve=A-I+P&32767,Gt=f[Ve],zt=Ve-Gt&32767;zt>He&&(He=zt,J=Ve)}}}X=J,J=f[X],I+=X-J&32767}
if(C){b[D++]=268435456|Or[S]<<18|oo[C];var ht=Or[S]&31,dt=oo[C]&31;k+=rn[ht]+sn[dt],++E[257+ht],++_[dt],L=A+S,++R}else b[D++]=n[A],++E[n[A]]}}for(A=Math.max(A,L);A<
a;++A)b[D++]=n[A],++E[n[A]];u=io(n,l,c,b,E,_,k,D,F,A-F,u),c||(o.r=u&7|l[u/8|0]<<3,u-=7,o.h=g,o.p=f,o.i=A,o.w=L)}else{for(var A=o.w||0;A<a+c;A+=65535){var Ye=A+65535;
Ye>=a&&(l[u/8|0]=c,Ye=a),u=fo(l,u+1,n.subarray(A,Ye))}o.i=a}return Ir(i,0,r+$r(u)+s)},Pl=(function(){for(var n=new Int32Array(256),e=0;e<256;++e){for(var t=e,r=9;--r;)
t=(t&1&&-306674912)^t>>>1;n[e]=t}return n})(),$l=function(){var n=-1;return{p:function(e){for(var t=n,r=0;r<e.length;++r)t=Pl[t&255^e[r]]^t>>>8;n=t},d:function(){
return~n}}};var Il=function(n,e,t,r,s){if(!s&&(s={l:1},e.dictionary)){var o=e.dictionary.subarray(-32768),a=new j(o.length+n.length);a.set(o),a.set(n,o.length),n=a,s.w=o.length}
return _l(n,e.level==null?6:e.level,e.mem==null?s.l?Math.ceil(Math.max(8,Math.min(13,Math.log(n.length)))*1.5):20:12+e.mem,t,r,s)},go=function(n,e){var t={};for(var r in n)
t[r]=n[r];for(var r in e)t[r]=e[r];return t};var K=function(n,e,t){for(;t;++e)n[e]=t,t>>>=8};var Nl=function(n,e){return((n[0]&15)!=8||n[0]>>4>7||(n[0]<<8|n[1])%31)&&ee(6,"invalid zlib data"),(n[1]>>5&1)==+!e&&ee(6,"invalid zlib data: "+(n[1]&32?"need":
"unexpected")+" dictionary"),(n[1]>>3&4)+2};function Ll(n,e){return Il(n,e||{},0,0)}function vo(n,e){return kl(n.subarray(Nl(n,e&&e.dictionary),-4),{i:2},e&&e.out,e&&e.dictionary)}var bo=function(n,e,t,r){for(var s in n){var o=n[s],a=e+s,i=r;Array.isArray(o)&&(i=go(r,o[1]),o=o[0]),o instanceof j?t[a]=[o,i]:(t[a+="/"]=[new j(0),i],bo(o,a,t,
r))}},lo=typeof TextEncoder<"u"&&new TextEncoder,Fl=typeof TextDecoder<"u"&&new TextDecoder,Dl=0;try{Fl.decode(yo,{stream:!0}),Dl=1}catch{}function Ue(n,e){if(e){for(var t=new j(n.length),r=0;r<n.length;++r)t[r]=n.charCodeAt(r);return t}if(lo)return lo.encode(n);for(var s=n.length,o=new j(n.length+
(n.length>>1)),a=0,i=function(u){o[a++]=u},r=0;r<s;++r){if(a+5>o.length){var l=new j(a+8+(s-r<<1));l.set(o),o=l}var c=n.charCodeAt(r);c<128||e?i(c):c<2048?(i(192|
c>>6),i(128|c&63)):c>55295&&c<57344?(c=65536+(c&1047552)|n.charCodeAt(++r)&1023,i(240|c>>18),i(128|c>>12&63),i(128|c>>6&63),i(128|c&63)):(i(224|c>>12),i(128|c>>
6&63),i(128|c&63))}return Ir(o,0,a)}var _r=function(n){var e=0;if(n)for(var t in n){var r=n[t].length;r>65535&&ee(9),e+=r+4}return e},co=function(n,e,t,r,s,o,a,i){var l=r.length,c=t.extra,u=i&&i.length,
h=_r(c);K(n,e,a!=null?33639248:67324752),e+=4,a!=null&&(n[e++]=20,n[e++]=t.os),n[e]=20,e+=2,n[e++]=t.flag<<1|(o<0&&8),n[e++]=s&&8,n[e++]=t.compression&255,n[e++]=
t.compression>>8;var m=new Date(t.mtime==null?Date.now():t.mtime),p=m.getFullYear()-1980;if((p<0||p>119)&&ee(10),K(n,e,p<<25|m.getMonth()+1<<21|m.getDate()<<16|
m.getHours()<<11|m.getMinutes()<<5|m.getSeconds()>>1),e+=4,o!=-1&&(K(n,e,t.crc),K(n,e+4,o<0?-o-2:o),K(n,e+8,t.size)),K(n,e+12,l),K(n,e+14,h),e+=16,a!=null&&(K(n,
e,u),K(n,e+6,t.attrs),K(n,e+10,a),e+=14),n.set(r,e),e+=l,h)for(var y in c){var f=c[y],g=f.length;K(n,e,+y),K(n,e+2,g),n.set(f,e+4),e+=4+g}return u&&(n.set(i,e),
e+=u),e},Ul=function(n,e,t,r,s){K(n,e,101010256),K(n,e+8,t),K(n,e+10,t),K(n,e+12,r),K(n,e+16,s)};function on(n,e){e||(e={});var t={},r=[];bo(n,"",t,e);var s=0,o=0;for(var a in t){var i=t[a],l=i[0],c=i[1],u=c.level==0?0:8,h=Ue(a),m=h.length,p=c.comment,y=p&&
Ue(p),f=y&&y.length,g=_r(c.extra);m>65535&&ee(11);var v=u?Ll(l,c):l,w=v.length,x=$l();x.p(l),r.push(go(c,{size:l.length,crc:x.d(),c:v,f:h,m:y,u:m!=a.length||y&&
p.length!=f,o:s,compression:u})),s+=30+m+g+w,o+=76+2*(m+g)+(f||0)+w}for(var b=new j(o+22),E=s,_=o-s,R=0;R<r.length;++R){var h=r[R];co(b,h.o,h,h.f,h.u,h.c.length);
var k=30+h.f.length+_r(h.extra);b.set(h.c,h.o+k),co(b,s,h,h.f,h.u,h.c.length,h.o,h.m),s+=16+k+(h.m?h.m.length:0)}return Ul(b,s,r.length,_,E),b}var Wl={teams:{pursuer:"pursuers",evader:"evaders"},generation:{pursuer:"pursuer generation",evader:"evader generation"},score:"capture rate",means:{pursuer:"ca\
ptures",evader:"escapes"},curves:{pursuer:"captures",evader:"escapes"},ends:["0 all escape","1 all caught"],lead:"Each cell is a match between two generations: \
the brighter, the more evaders are captured. Click one to watch it.",click:"watch its match"},wo=([n,e])=>({teams:{pursuer:n,evader:e},generation:{pursuer:`gene\
ration of ${n}`,evader:`generation of ${e}`},score:`score of the ${n}`,means:{pursuer:n,evader:e},curves:{pursuer:"scores",evader:"scores"},ends:[`0 the ${e} wi\
n`,`1 the ${n} win`],lead:`Each cell is a pair of generations: the brighter, the higher the score of the ${n}. Click one to see more of it.`,click:"see more of \
it"}),Bl=["0 worst","1 best"],jl=n=>({...wo([n,n]),generation:{pursuer:`generation of ${n}`,evader:"generation of the opponent"},score:"score",ends:["0 loses","\
1 wins"],lead:`Each cell is a pair of generations of ${n}: the brighter, the higher the score of the row. Click one to see more of it.`}),Gl=({game:n})=>n&&n.teams[0]===
n.teams[1]?T.slice(0,1):T,Re=n=>{if(!n.game)return Wl;let e=Gl(n).length===1?jl(n.game.teams[0]):wo(n.game.teams);return n.payoff?.others?{...e,ends:Bl}:e},te=(n,e,t)=>`${Re(
n).teams[e]} of generation ${t}`;function Pe(n,e,t){let r=e-n.payoff.first[0],s=t-n.payoff.first[1],o=n.payoff.capture_rate[r]?.[s];return o===void 0?null:{rate:o,rates:n.payoff.capture_rates[r][s],
lengths:n.payoff.lengths[r]?.[s]??[]}}function xo(n,e,t){let{script:r,policy:s,kept:o,genomes:a}=n.teams[e];if(r!==null||s===null)return"";if(!o.includes(t))return`\
The page holds no genome of ${te(n,e,t)}: it would be too large. Choose a generation of ${o.join(", ")}.`;let i=o.length*s.genome_size;return Eo(a,s.genome_size).
length===i?"":`The page is damaged: it does not hold the ${i} numbers of the ${e}s' genomes. Write it again from its run.`}function _e(n,e,t){let{script:r,policy:s,
kept:o,genomes:a}=n.teams[e];if(r!==null||s===null)return r??"random";let i=o.indexOf(t);if(i<0)throw new RangeError(`${e}: expected a generation whose genome t\
he page holds, got ${t}`);let l=s.genome_size,c=Eo(a,l).subarray(i*l,(i+1)*l);return{...s,genome:c}}var So=({teams:n},e)=>(n[e].policy??{kind:"cells"}).kind!=="\
cells";function Ao({teams:n},e,t){let{kept:r,expressions:s,weights:o}=n[e],a=r.indexOf(t),i=s?.[a];return i?{expression:i,weights:o?.[a]??null}:null}function Fr(n,e){
return n.kind==="program"?e?.weights??null:n.hidden.length?null:Object.fromEntries(n.inputs.map((t,r)=>[t,n.genome[r]]))}function Mo(n,e,{pursuer:t,evader:r,episode:s,
seed:o}){let a=e.seeds[t][r];return n.match(e.world,_e(e,"pursuer",t),_e(e,"evader",r),BigInt(o??a),s)}var Nr=4,Lr=new Map,To=(n,e)=>{Lr.set(n,e)};function Eo(n,e){
let t=Lr.get(n);if(t)return t;let r=new Float32Array;try{let s=Hl(Dr(n),e);s.every(Number.isFinite)&&(r=s)}catch(s){if(!(s instanceof DOMException||s instanceof
RangeError||zl(s)))throw s}return Lr.set(n,r),r}var zl=n=>n instanceof Error&&"code"in n;function Hl(n,e){let t=vo(n),r=t.length/Nr,s=new Uint8Array(t.length);for(let a=0;a<
s.length;a++)s[a]=t[a%Nr*r+Math.floor(a/Nr)];let o=new Uint32Array(s.buffer);for(let a=e;a<o.length;a++)o[a]^=o[a-e];return new Float32Array(s.buffer)}function Dr(n){
let e=atob(we(n)),t=new Uint8Array(e.length);for(let r=0;r<t.length;r++)t[r]=e.charCodeAt(r);return t}var we=n=>document.getElementById(n)?.textContent??"";var Co=()=>JSON.parse(we("data")),Qe={"specialist-specialist":"Specialists: both teams meet only the newest opponent","generalist-specialist":"Pursuers meet all\
 earlier evaders, evaders only the newest pursuers","generalist-generalist":"Generalists: both teams meet all earlier opponents","hall-of-fame":"Halls of fame: \
both teams learn at once, and meet earlier champions"};function an({schedule:n}){if(n.kind==="hall-of-fame")return n.kind;let e={latest:"specialist","round-robi\
n":"generalist",uniform:"uniform"};return`${e[n.pursuers_meet]}-${e[n.evaders_meet]}`}var ln=n=>Qe[an(n)]??an(n);var un=10,hn=999999,et=15,dn=90,Wr=[3,5,7,9,11],mn=5,Br=[8,16,32,64],jr=[6,10,30,60,90,120,200];function Ur(n,e=""){let t=Object.hasOwn(n.worlds,e)?e:Object.keys(
n.worlds)[0],{n_pursuers:r,n_evaders:s,fov:o,max_steps:a}=n.worlds[t];return{world:t,schedule:"generalist-generalist",beside:"",learner:"es",policy:"rating",seed:0,
generations:et,way:!1,population:0,pursuers:r,evaders:s,view:o,steps:a,walls:null}}function pn(n,e,t=e.schedule){let r=n.races[e.policy][e.learner][t],s=n.worlds[e.
world],o={...s,n_pursuers:e.pursuers,n_evaders:e.evaders,fov:e.view,max_steps:e.steps,obstacles:e.walls?no(e.walls,s.rows,s.cols):s.obstacles},a=e.way?"right-of\
-way":e.policy==="rating"?"obstacles":"none";return{...r,world:o,train_steps:e.steps,seed:e.seed,policy:{...r.policy,mask:a},learner:{...r.learner,population:e.
population||r.learner.population},schedule:{...r.schedule,generations:e.generations}}}function fn({walls:n,pursuers:e,evaders:t},{rows:r,cols:s}){if(!n)return"";
let o=new Set(Array.from({length:r*s},(i,l)=>l).filter(i=>!n.includes(i)));if(o.size<e+t)return`There is no room: ${e+t} agents need a free cell each.`;let a=[Math.
min(...o)];o.delete(a[0]);for(let i of a){let l=i%s,c=[i-s,i+s,...l>0?[i-1]:[],...l<s-1?[i+1]:[]];a.push(...c.filter(u=>o.delete(u)))}return o.size?"Nobody may \
be walled in: all free cells have to be connected, side by side.":""}function cn(n){return Array.isArray(n)?n.join(".")||"none":n===null?"usual":String(typeof n==
"boolean"?Number(n):n)}function Oo(n,e){let t=Ur(n,e.world),r=Ur(n);return Object.fromEntries(Object.keys(e).filter(s=>cn(e[s])!==cn((s==="world"?r:t)[s])).map(
s=>[s,cn(e[s])]))}var ko=n=>Object.fromEntries(Object.entries(n).map(([e,t])=>[e,cn(t)]));function Gr(n,e,t,r){let s=r??Ur(n,e.world),{rows:o,cols:a}=n.worlds[s.
world],i=(f,g)=>v=>/^\d{1,6}$/.test(v)&&Number(v)>=f&&Number(v)<=g?Number(v):void 0,l=(...f)=>g=>f.find(v=>String(v)===g),c=f=>{if(f==="usual"||f==="none")return f===
"usual"?null:[];let g=f.split(".").map(v=>i(0,o*a-1)(v));return g.includes(void 0)?void 0:g.reduce((v,w)=>en(v,w,!0),[])},u={world:l(...Object.keys(n.worlds)),schedule:l(
...Object.keys(Qe)),beside:l("",...Object.keys(Qe)),learner:l("es","ga"),policy:l("rating","cells"),way:f=>/^[01]$/.test(f)?f==="1":void 0,seed:i(0,hn),generations:i(
et,dn),pursuers:i(1,un),evaders:i(1,un),view:l(...Wr),steps:l(...jr),population:l(0,...Br),walls:c},h=Object.entries(e).map(([f,g])=>{let v=Object.hasOwn(u,f)?u[f](
g):void 0;return v===void 0&&t(`${f}=${g}`),[f,v]}),m={...s,...Object.fromEntries(h.filter(([,f])=>f!==void 0))},p=m.way?{...m,view:Math.max(mn,m.view)}:m,y=fn(
p,n.worlds[p.world]);return y&&t(y),y?{...p,walls:null}:p}var Vl=1e3,Yl=5;function ce(n,e,t,r=""){return d("label",{class:`field ${r}`,title:e},d("span",{class:"field-name"},n),t,d("span",{class:"about small muted"},e))}
function Ro(n,e){let t=Object.entries(Qe),r=b=>{let{n_pursuers:E,n_evaders:_,max_steps:R}=n.worlds[b];return{world:b,pursuers:E,evaders:_,steps:R,walls:null}},s=b=>{
let{rows:E,cols:_,n_pursuers:R,n_evaders:k}=n.worlds[b];return`${b}: ${E} x ${_}, ${R} against ${k}`},o=re(Object.keys(n.worlds).map(b=>[b,s(b)]),b=>e(r(b),!0)),
a=re(t,b=>e({schedule:b})),i=re([["","Nothing"],...t],b=>e({beside:b},!0)),l=Array.from({length:un},(b,E)=>[E+1,String(E+1)]),c=re(l,b=>e({pursuers:Number(b)})),
u=re(l,b=>e({evaders:Number(b)})),h=re(Wr.map(b=>[b,`${b} x ${b}`]),b=>e({view:Number(b),...Number(b)<mn?{way:!1}:{}})),m=d("input",{type:"checkbox",onchange:()=>e(
{way:m.checked,...m.checked?{view:Math.max(mn,Number(h.value))}:{}})}),p=re([[0,"usual"],...Br.map(b=>[b,String(b)])],b=>e({population:Number(b)})),y=re(jr.map(
b=>[b,String(b)]),b=>e({steps:Number(b)})),f=re([["es","evolution strategy"],["ga","genetic algorithm"]],b=>e({learner:b},!0)),g=re([["rating","weights of named\
 inputs"],["cells","a network over the cells of its view"]],b=>e({policy:b,...b==="cells"?{view:Yl}:{}},!0)),v=d("input",{type:"number",min:0,max:hn,step:1,inputmode:"\
numeric"});v.addEventListener("change",()=>e({seed:Math.min(hn,Math.max(0,Math.round(Number(v.value))||0))},!0));let w=d("button",{type:"button",onclick:()=>e({
seed:Math.floor(Math.random()*Vl)},!0)},"Another seed"),x=(b,E,..._)=>d("section",{class:`controls ${E}`,"aria-label":b},d("fieldset",{},d("legend",{},b),..._));
return{main:x("Try something else","card",ce("World","where they meet; begins a new race",o,"wide"),ce("Pursuers","triangles; at once",c),ce("Evaders","discs; a\
t once",u),ce("Steps","after which evaders that are free have won",y),ce("Seed","the luck of the race; begins a new one",d("span",{class:"seed"},v,w),"half")),more:d(
"details",{class:"card more-controls"},d("summary",{},"More: whom they meet, how they learn, what they see"),x("How they learn","",ce("Opponents","whom the team\
s meet while they learn",a,"wide"),ce("Side by side with","a second race of the same seed",i,"wide"),ce("What evolves","what an agent decides by",g,"half"),ce("\
Learner","how a team learns",f,"half"),ce("View","cells that an agent sees around itself",h),ce("Right of way","agents never take a move that could put them at \
fault",d("span",{},m)),ce("Population","candidates that are compared at a time",p))),show:b=>{o.value=b.world,a.value=b.schedule,i.value=b.beside,h.value=String(
b.view),f.value=b.learner,p.value=String(b.population),y.value=String(b.steps),v.value=String(b.seed),m.checked=b.way,g.value=b.policy,c.value=String(b.pursuers),
u.value=String(b.evaders)}}}function zr(n,e,t,r){let{players:s,told:o,...a}=r;e.play({...a,played:t,ending:(i,l)=>[o?d("p",{},o(Se(i,t.seat))):"",Kl(n,i,l,so(s))],again:()=>zr(n,e,{...t,moves:t.
moves.slice(0,t.from)},r)})}function Kl(n,e,t,r){let s=ve(t.config,t.seat)==="evader",o=s?t.config.max_steps:t.config.n_evaders,a=d("table",{class:"numbers"},d(
"caption",{},s?"Steps in your seat: same start, same others":"Captures of your team: same start, same others")),i=c=>{let u=d("span",{class:s?"bar evader":"bar \
pursuer"}),h=d("td",{},"…");return a.append(d("tr",{},d("th",{scope:"row"},c),d("td",{class:"track","aria-hidden":"true"},u),h)),({lasted:m,captured:p})=>{u.style.
width=`${100*(s?m:p)/o}%`,h.textContent=String(s?m:p)}};i("You")(Se(e,t.seat));for(let{name:c,policy:u}of r){let h=i(c);setTimeout(()=>h(ro(n,t,u())))}let l=t.from?
`You took over at step ${t.from}. `:"";return d("div",{},a,d("p",{class:"small muted"},`${l}One match: luck has its part in it.`))}var ae=[[0,0],[-1,0],[0,1],[1,0],[0,-1],[-1,1],[1,1],[1,-1],[-1,-1]];function _o(n,e,t){let r=e[0]-n[0],s=e[1]-n[1];return!t&&Math.abs(r)>Math.abs(s)?s=0:t||(r=
0),ae.findIndex(([o,a])=>o===Math.sign(r)&&a===Math.sign(s))}var We=(n,e)=>e<n.nPursuers,W=(n,e)=>[n.positions[2*e],n.positions[2*e+1]],Be=({rows:n,cols:e},[t,r])=>t>=
0&&r>=0&&t<n&&r<e,Hr=(n,e,t=3)=>n!==void 0&&[0,1,2].slice(0,t).some(r=>n[3*e+r]),Vr=(n,e)=>Hr(n.fault,e),Po=(n,e)=>!Vr(n,e)&&Hr(n.involved,e,2);function yn(n,e,t){
let r=W(n,t),s=W(e,t),o=r[0]!==s[0]||r[1]!==s[1],a=e.involved===void 0||Hr(e.involved,t);return!!(e.alive[t]&&e.actions?.[t]&&!o&&a)}function gn(n,e,t){let[r,s]=W(
n,t),[o,a]=ae[e.actions?.[t]??0];return[r+o,s+a]}function Tt(n,e,t){return Array.from({length:t.everCaptured.length},(s,o)=>o).filter(s=>t.everCaptured[s]&&!e.everCaptured[s]).
map(s=>n.nPursuers+s)}var vn=n=>n.moments.flatMap((e,t)=>t&&Tt(n,n.moments[t-1],e).length?[t]:[]);function bn(n,e){return Array.from({length:e.alive.length},(r,s)=>s).
filter(r=>n.alive[r]&&!e.alive[r])}var $o=[-.31,0,.31],Io=[{size:1,at:[[0,0]]},{size:.62,at:[[-.2,.2],[.2,-.2]]},{size:.54,at:[[-.23,.22],[.23,.22],[0,-.22]]},{size:.54,at:[[-.23,.23],[.23,.23],[
-.23,-.23],[.23,-.23]]},{size:.36,at:$o.flatMap(n=>$o.map(e=>[e,n]))}],ql=.3,Jl=.35,Zl=.55;function Et(n,e){let t=new Map;for(let r=0;r<e.alive.length;r++){if(!e.
alive[r])continue;let[s,o]=W(e,r),a=s*n.cols+o,i=t.get(a);i?i.push(r):t.set(a,[r])}return t}function No(n,e){let t=Array.from(e.alive,(r,s)=>{let[o,a]=W(e,s);return{
x:a+.5,y:o+.5,size:1,alpha:0}});for(let r of Et(n,e).values()){let s=Io[Math.min(r.length,Io.length)-1];r.forEach((o,a)=>{let[i,l]=s.at[Math.min(a,s.at.length-1)],
c=t[o];c.x+=i,c.y+=l,c.size=s.size,c.alpha=1})}return t}var Lo=n=>n*n*(3-2*n),tt=(n,e,t)=>n+(e-n)*t,Fo=n=>Math.min(1,Math.max(0,n));function Do(n,e,t,r){let s={
SIMULTANEOUS:1,SWARM_TURNS:2,AGENT_TURNS:t}[n.interaction];if(s===1)return Lo(r);let o=s===t?e:+!We(n,e),a=Math.max(1/s,Jl);return Lo(Fo((r-o/(s-1)*(1-a))/a))}function wn(n,e){
let t=n.moments.length-1,r=Math.min(Math.floor(e),t),s=n.moments[r],o=No(n,s);if(r===t||e===r)return o;let a=n.moments[r+1],i=No(n,a);return o.map((l,c)=>{let u=Do(
n,c,o.length,e-r);return Xl(s,a,c,l,i[c],u)})}function Yr(n,e,t){let r=n.moments.length-1,s=Math.min(Math.floor(t),r),o=n.moments[s],a=n.moments[Math.min(s+1,r)],
i=Do(n,e,o.alive.length,t-s),[l,c]=W(o,e),[u,h]=W(a,e);return[tt(c,h,i)+.5,tt(l,u,i)+.5]}function Xl(n,e,t,r,s,o){let a=r.alpha>s.alpha,i={x:tt(r.x,s.x,o),y:tt(
r.y,s.y,o),size:a?r.size:tt(r.size,s.size,o),alpha:a?Fo((1-o)/(1-Zl)):tt(r.alpha,s.alpha,o)};if(yn(n,e,t)){let[l,c]=W(n,t),[u,h]=gn(n,e,t),m=ql*Math.sin(Math.PI*
o);i.x+=(h-c)*m,i.y+=(u-l)*m}return i}var Uo=2*Math.PI;function pe(n,e,t,r){n.beginPath(),n.arc(e,t,r/2,0,Uo)}function nt(n,e,t,r){let s=r/2,o=[[0,-.97],[.97,.83],[-.97,.83]].map(([a,i])=>[e+a*s,t+i*
s]);n.beginPath(),n.moveTo((o[2][0]+o[0][0])/2,(o[2][1]+o[0][1])/2),o.forEach(([a,i],l)=>{let[c,u]=o[(l+1)%3];n.arcTo(a,i,c,u,r*.09)}),n.closePath()}function xn(n,e,t,r){
let s=r*.32;n.beginPath(),n.moveTo(e-s,t-s),n.lineTo(e+s,t+s),n.moveTo(e+s,t-s),n.lineTo(e-s,t+s)}function Wo(n,e,t,r){n.beginPath();for(let s=0;s<16;s++){let o=r/
2*(s%2?.6:.95),a=Uo*s/16;n.lineTo(e+o*Math.sin(a),t-o*Math.cos(a))}n.closePath()}function Bo(n,e,t,r,s,o){let a=Math.atan2(s-t,r-e);n.beginPath(),n.moveTo(e,t),
n.lineTo(r,s);for(let i of[-1,1])n.moveTo(r,s),n.lineTo(r-o*Math.cos(a+i*.6),s-o*Math.sin(a+i*.6))}var jo=4,Ql=1.6,ec=.95,tc=5,nc=.16,rc=9,sc=.09,oc=.2,Go=.75,V=(n,e)=>n.left+e*n.cell,Y=(n,e)=>n.top+e*n.cell;function rt(n,e,t){return We(e,t)?n.colors.pursuer:
n.colors.evader}function Sn({ctx:n,colors:e},t,r,s,o,a,i=0){n.font=`700 ${Math.round(o)}px system-ui, sans-serif`,n.textAlign="center",n.textBaseline="middle",n.
strokeStyle=e.paper,n.lineWidth=i,i&&n.strokeText(t,r,s),n.fillStyle=a,n.fillText(t,r,s)}function zo({ctx:n,grid:e,colors:t}){let{left:r,top:s,cell:o,rows:a,cols:i}=e,
l=i*o,c=a*o;if(n.fillStyle=t.paper,n.fillRect(r,s,l,c),o<tc)return;n.fillStyle=t.line;let u=Math.max(1,Math.round(o/60));for(let h=1;h<i;h++)n.fillRect(r+h*o,s,
u,c);for(let h=1;h<a;h++)n.fillRect(r,s+h*o,l,u)}function Ho({ctx:n,grid:e,colors:t},r){let{left:s,top:o,cell:a,rows:i,cols:l}=e;n.fillStyle=t.obstacle;for(let c=0;c<
i*l;c++){if(!r.obstacles[c])continue;let u=Math.floor(c/l),h=c%l;n.fillRect(s+h*a,o+u*a,a,a)}Vo({ctx:n,grid:e,colors:t})}function Vo({ctx:n,grid:{left:e,top:t,cell:r,
rows:s,cols:o},colors:a}){let i=Math.min(5,Math.max(2,Math.round(r/18)));n.strokeStyle=a.frame,n.lineWidth=i,n.strokeRect(e-i/2,t-i/2,o*r+i,s*r+i)}function Yo({
ctx:n,grid:e,colors:t},r){let{left:s,top:o,cell:a,rows:i,cols:l}=e,c=a<24*r?5:1;n.font=`500 ${Math.round(Math.min(15*r,Math.max(9*r,a*.32)))}px system-ui, sans-\
serif`,n.fillStyle=t.muted,n.textBaseline="alphabetic",n.textAlign="center";let u=5*r+a/40;for(let h=0;h<l;h+=c)n.fillText(String(h),s+(h+.5)*a,o-u);n.textAlign=
"right",n.textBaseline="middle";for(let h=0;h<i;h+=c)n.fillText(String(h),s-u,o+(h+.5)*a)}function Ko({grid:n},e,t,r){let s=Math.floor(e.fov/2)+.5,o=Math.max(0,
t-s),a=Math.min(n.cols,t+s),i=Math.max(0,r-s),l=Math.min(n.rows,r+s);return[V(n,o),Y(n,i),(a-o)*n.cell,(l-i)*n.cell]}function qo(n,e,t,r){let{ctx:s,grid:o,colors:a}=n;
s.save(),s.beginPath(),s.rect(0,0,s.canvas.width,s.canvas.height),s.rect(...Ko(n,e,t,r)),s.clip("evenodd"),s.clearRect(0,0,s.canvas.width,s.canvas.height),s.fillStyle=
a.line,s.fillRect(o.left,o.top,o.cols*o.cell,o.rows*o.cell),s.restore(),Vo(n)}function Jo(n,{x:e,y:t,alpha:r},s){let{ctx:o,grid:a,colors:i}=n,l=Math.max(a.cell,
16*s)*1.06,c=V(a,e),u=Y(a,t);o.globalAlpha=Math.max(r,.6),o.beginPath(),o.roundRect(c-l/2,u-l/2,l,l,l*.2),o.strokeStyle=i.focus,o.lineWidth=Math.max(2,2.5*s),o.
stroke();let h=Math.max(11*s,Math.min(18*s,a.cell*.5)),m=u-l/2<h*1.2,p=u+(m?1:-1)*(l/2+h*.7);o.lineJoin="round",Sn(n,"You",c,p,h,i.ink,h*.35),o.globalAlpha=1}function Zo(n,e,t,r,s){
let{ctx:o,grid:a}=n,i=Ko(n,e,r,s),l=rt(n,e,t);o.globalAlpha=.11,o.fillStyle=l,o.fillRect(...i),o.globalAlpha=.8,o.strokeStyle=l,o.lineWidth=Math.max(1,a.cell/24),
o.strokeRect(...i),o.globalAlpha=1}function Xo(n,e,t,r,s){let{ctx:o,grid:a}=n,i=Math.min(Math.ceil(t),e.moments.length-1),l=e.moments[i];o.lineCap="round",o.lineWidth=
Math.min(rc,Math.max(1,a.cell*nc));for(let c=Math.max(1,Math.floor(t-r)+1);c<=i;c++){let u=e.moments[c-1],h=e.moments[c],m=Math.max(0,Math.min(1,(t-c)/r));o.globalAlpha=
Go+(oc-Go)*m;for(let p=0;p<h.alive.length;p++){let y=c===i&&t<i;if(!u.alive[p]||!(l.alive[p]||y))continue;let f=(We(e,p)?-1:1)*sc,[g,v]=W(u,p),[w,x]=W(h,p);if(g===
w&&v===x)continue;let b=y?s[p].x:x+.5,E=y?s[p].y:w+.5;o.strokeStyle=rt(n,e,p),o.beginPath(),o.moveTo(V(a,v+.5+f),Y(a,g+.5+f)),o.lineTo(V(a,b+f),Y(a,E+f)),o.stroke()}}
o.globalAlpha=1}function Qo(n,e,t){let r=Math.min(Math.ceil(t),e.moments.length-1);for(let s=Math.max(1,r-jo+1);s<=r;s++){let o=e.moments[s-1],a=e.moments[s],i=s>
t?Math.max(0,1-2*(s-t)):1-(t-s)/jo,l=Tt(e,o,a);for(let c of bn(o,a))l.includes(c)||ic(n,W(a,c),i);for(let c of l)ac(n,W(a,c),i)}n.ctx.globalAlpha=1}function ac({
ctx:n,grid:e,colors:t},[r,s],o){n.globalAlpha=o,Wo(n,V(e,s+.5),Y(e,r+.5),Math.max(8,e.cell*Ql)),n.fillStyle=t.capture,n.fill(),n.strokeStyle=t.ink,n.lineWidth=Math.
max(1,e.cell/36),n.lineJoin="round",n.stroke()}function ic({ctx:n,grid:e,colors:t},[r,s],o){n.globalAlpha=o,xn(n,V(e,s+.5),Y(e,r+.5),Math.max(7,e.cell*ec)),n.strokeStyle=
t.collision,n.lineWidth=Math.max(2,e.cell*.17),n.lineCap="round",n.stroke()}function ea({ctx:n,grid:e,colors:t},r,s){let o=Math.max(1,e.cell*.07);n.strokeStyle=
n.fillStyle=t.collision,n.lineWidth=Math.max(1,e.cell*.05),n.setLineDash([e.cell*.14,e.cell*.1]);for(let[a,i]of r){if(a<0||i<0||a>=e.rows||i>=e.cols)continue;let l=[
V(e,i)+o,Y(e,a)+o,e.cell-2*o,e.cell-2*o];n.globalAlpha=.2*s,n.fillRect(...l),n.globalAlpha=s,n.strokeRect(...l)}n.setLineDash([]),n.globalAlpha=1}function ta({ctx:n,
grid:e,colors:t},r,s,o,a){n.globalAlpha=a,pe(n,V(e,r),Y(e,s),Math.max(8,e.cell*o*1.02)),n.strokeStyle=t.collision,n.lineWidth=Math.max(1.5,e.cell*.085*Math.sqrt(
o)),n.stroke(),n.globalAlpha=1}var lc=.8,cc=.92,uc=15,hc=7,Kr=9;function na(n,e,t,r,s,o){r.forEach((a,i)=>{a.alpha>0&&dc(n,e,t,i,a,s,o)}),n.ctx.globalAlpha=1;for(let a of Et(e,t).values())a.length>
Kr&&mc(n,r[a[Kr-1]],a.length-Kr+1)}function dc(n,e,t,r,s,o,a){let{ctx:i,grid:l,colors:c}=n,u=We(e,r),h=V(l,s.x),m=Y(l,s.y),p=Math.max(4,l.cell*s.size*(u?cc:lc)),
y=rt(n,e,r),f=!u&&!!t.captured[r-e.nPursuers];if(i.globalAlpha=s.alpha,(u?nt:pe)(i,h,m,p),p>hc*a&&(i.strokeStyle=c.paper,i.lineWidth=Math.max(2,p*.1),i.stroke()),
i.fillStyle=f?c.paper:y,i.fill(),f&&(pe(i,h,m,p*.82),i.strokeStyle=y,i.lineWidth=p*.18,i.stroke()),!o||p<uc*a)return;let g=String(u?r:r-e.nPursuers),v=p*(u?.4:.5)*
(g.length>1?.8:1);Sn(n,g,h,m+p*(u?.17:.03),v,f?y:c.paper)}function mc(n,e,t){let{cell:r}=n.grid;Sn(n,`+${t}`,V(n.grid,e.x),Y(n.grid,e.y),r*.3,n.colors.ink,r*.1)}var pc=.46,fc=.86,yc=.66,ra=.48,gc=.78,vc=.58;function sa(n,e,t,r){let s=e.moments[t-1],o=e.moments[t];if(!s)return;let{ctx:a,grid:i,colors:l}=n;a.strokeStyle=l.
collision,a.lineWidth=Math.max(1.5,i.cell*.07),a.lineCap="butt",a.globalAlpha=r;for(let c=0;c<o.alive.length;c++)yn(s,o,c)&&bc(n,e,W(s,c),gn(s,o,c));a.globalAlpha=
1}function bc({ctx:n,grid:e},t,r,s){let o=s[1]-r[1],a=s[0]-r[0],i=h=>V(e,r[1]+.5+o*h),l=h=>Y(e,r[0]+.5+a*h),c=Be(t,s)?gc:vc;n.setLineDash([e.cell*.09,e.cell*.06]),
n.beginPath(),n.moveTo(i(ra),l(ra)),n.lineTo(i(c),l(c)),n.stroke(),n.setLineDash([]);let u=.17*e.cell/Math.hypot(o,a);n.beginPath(),n.moveTo(i(c)-a*u,l(c)+o*u),
n.lineTo(i(c)+a*u,l(c)-o*u),n.stroke()}function oa(n,e,t,r,s,o){let a=ae[o];if(!o||!a)return;let{ctx:i,grid:l,colors:c}=n,u=Be(e,[r[0]+a[0],r[1]+a[1]])?fc:yc,h=pc*
s.size,m=[V(l,s.x+a[1]*h),Y(l,s.y+a[0]*h),V(l,s.x+a[1]*u),Y(l,s.y+a[0]*u)],p=Math.max(1.5,l.cell*.085);i.lineCap=i.lineJoin="round";for(let[y,f]of[[c.paper,p*2.1],
[rt(n,e,t),p]])i.strokeStyle=y,i.lineWidth=f,Bo(i,...m,l.cell*.2),i.stroke()}var wc=.04,aa=.3,xc=.36,Sc=.13,ia=.62,An=.94;function ca(n,e,t){let{ctx:r,grid:s,colors:o}=n,{cell:a}=s,i=f=>V(s,f[1]+.5),l=f=>Y(s,f[0]+.5),c=Math.max(1.5,a*.06),
u=f=>Be(e,f);r.lineCap="round";for(let[f,g]of[[t.escape,o.evader],[t.held,o.pursuer]]){r.fillStyle=g,r.globalAlpha=.28;let v=a*(1-2*wc);for(let w of f.filter(u))
r.fillRect(i(w)-v/2,l(w)-v/2,v,v)}r.globalAlpha=1,r.lineWidth=c,r.fillStyle=r.strokeStyle=o.ink;let{sides:h,openSide:m,wall:p,to:y}=t;if(h){let[f,...g]=h;for(let v of g)
r.beginPath(),r.moveTo(i(f),l(f)),r.lineTo(i(v),l(v)),r.stroke()}if(p){let[f,g]=[Math.sign(p[0]-y[0]),Math.sign(p[1]-y[1])],[v,w]=[i(p)-g*a/2,l(p)-f*a/2],x=.3*a;
r.setLineDash([c,c*2]),r.beginPath(),r.moveTo(i(y),l(y)),r.lineTo(v,w),r.stroke(),r.setLineDash([]),r.beginPath(),r.moveTo(v-f*x,w-g*x),r.lineTo(v+f*x,w+g*x),r.
stroke()}for(let f of t.exits.filter(u)){let[g,v]=[i(f)-i(y),l(f)-l(y)];pe(r,i(y)+ia*g,l(y)+ia*v,Math.max(3,a*Sc)),r.fill()}m&&(Ac(r,i(m),l(m),a*xc),r.stroke()),
r.setLineDash([a*.12,a*.08]),r.strokeRect(i(y)-a*An/2,l(y)-a*An/2,a*An,a*An),r.setLineDash([])}function ua({ctx:n,grid:e,colors:t},r,s){let{cell:o}=e,a=h=>V(e,h[1]+
.5),i=h=>Y(e,h[0]+.5),l=Math.max(3,o*.14),c=Math.max(1.5,o*.07),u=h=>{for(let[m,p]of[[t.paper,l],[t.ink,c]])n.strokeStyle=m,n.lineWidth=p,h(),n.stroke()};n.lineCap=
"round";for(let h of s.escape.filter(m=>Be(r,m)))u(()=>pe(n,a(h),i(h),o*aa));for(let h of s.held.filter(m=>Be(r,m)))u(()=>xn(n,a(h),i(h),o*aa*1.4));n.setLineDash(
[o*.1,o*.08]);for(let{pursuer:h,cell:m}of s.moved)n.strokeStyle=h?t.pursuer:t.evader,n.lineWidth=c,(h?nt:pe)(n,a(m),i(m),o*.72),n.stroke();n.setLineDash([])}function Ac(n,e,t,r){
n.beginPath(),n.moveTo(e,t-r),n.lineTo(e+r,t),n.lineTo(e,t+r),n.lineTo(e-r,t),n.closePath()}var la=n=>["rect",{x:1,y:1,width:22,height:22,class:`tint-${n}`}],Mn=n=>[
"path",{d:n,class:"sign"}],qr=(n,e)=>["circle",{cx:12,cy:12,r:n,class:e}],Mc={escapes:[["next cell of the evader that no pursuer reaches",la("evader"),qr(5,"sig\
n")],["next cell that a pursuer reaches",la("pursuer"),Mn("M8 8l8 8m0-8l-8 8")]],opposite:[["two sides of the evader",Mn("M3 20L12 5l9 15")]],open_side:[["neare\
st free side",Mn("M12 3l9 9-9 9-9-9z")]],exits:[["way on",qr(4,"filled-sign")]],room:[["nearest obstacle",Mn("M2 12h2m5 0h2m5 0h2M21 4v16")]]},Tc=["an agent tha\
t has moved before",qr(8,"dashed-sign")],Ec="Inputs of a move: point at an agent, or choose it; then point at a cell beside it, tap it or press I for another mo\
ve.";function ha(n,e){let t=n.flatMap(r=>Mc[r]??[]);return t.length?[d("p",{class:"small muted"},Ec),d("ul",{class:"shapes small","aria-label":"Inputs of a move\
 on the board"},...[...t,...e?[Tc]:[]].map(([r,...s])=>d("li",{},M("svg",{viewBox:"0 0 24 24","aria-hidden":"true"},...s.map(o=>M(...o))),r)))]:[]}var Tn={numbers:!0,axes:!1,trail:6,viewers:[],plan:null,inputs:null,selected:null,cursor:null,you:null,fog:!1};function En(n,e,t,r,s){let{ctx:o,grid:a,colors:i}=n,
l=Math.min(Math.ceil(t),e.moments.length-1),c=e.moments[l],u=t===l,h=wn(e,t),m=u?1:Math.max(0,1-2*(l-t));o.clearRect(0,0,o.canvas.width,o.canvas.height),zo(n);for(let g of r.
viewers)h[g]?.alpha&&Zo(n,e,g,...Yr(e,g,t));Ho(n,e),r.axes&&Yo(n,s),Xo(n,e,t,r.trail,h);let p=u?r.inputs:null;p&&ca(n,e,p),ea(n,c.contested??[],m),Qo(n,e,t),sa(
n,e,l,m),h.forEach(({x:g,y:v,size:w},x)=>{let b=Po(c,x)?.4:0,E=Vr(c,x)?1:b;E&&ta(n,g,v,w,E*m)});let y=u?c:e.moments[Math.max(0,l-1)];if(na(n,e,y,h,r.numbers,s),
p&&ua(n,e,p),u&&r.plan)for(let[g,v]of h.entries())v.alpha&&oa(n,e,g,W(c,g),v,r.plan[g]??0);r.you!==null&&(r.fog&&qo(n,e,...Yr(e,r.you,t)),Jo(n,h[r.you],s)),o.lineWidth=
Math.max(2,2.5*s),o.strokeStyle=i.focus;let f=r.selected===null?void 0:h[r.selected];f?.alpha&&da(n,f.x,f.y,f.size*.96),r.cursor&&(o.setLineDash([a.cell*.12,a.cell*
.08]),da(n,r.cursor[1]+.5,r.cursor[0]+.5,.8),o.setLineDash([]))}function da({ctx:n,grid:e},t,r,s){let o=s*e.cell;n.beginPath(),n.roundRect(e.left+t*e.cell-o/2,e.
top+r*e.cell-o/2,o,o,o*.1),n.stroke()}var ma=(n,e)=>(e+.24)/(n+.24);function Cn(n,e,t,r,s,o){let a=t?28*o:0,i=(c,u)=>(c-a)/(u+2*.12),l=Math.max(1,Math.floor(Math.min(i(r,e),i(s,n))));return{rows:n,cols:e,
cell:l,left:Math.round((r-e*l+a)/2),top:Math.round((s-n*l+a)/2)}}function pa(n,e,t){let r=Math.floor((t-n.top)/n.cell),s=Math.floor((e-n.left)/n.cell);return r>=
0&&r<n.rows&&s>=0&&s<n.cols?[r,s]:null}var Cc=["paper","line","frame","ink","muted","obstacle"],Oc=["pursuer","evader","capture","collision","focus"];function st(n){let e=getComputedStyle(n),t=(r,s)=>[
r,e.getPropertyValue(s+r).trim()];return Object.fromEntries([...Cc.map(r=>t(r,"--board-")),...Oc.map(r=>t(r,"--"))])}var Te=()=>matchMedia("(prefers-reduced-motion: reduce)").matches,$e=class{canvas;#e=null;#n=0;#t;#r={rows:1,cols:1,left:0,top:0,cell:1};#a=0;constructor(e,t={}){
this.canvas=e,e.classList.add("board"),e.setAttribute("role","img"),this.#t={...Tn,...t},new ResizeObserver(()=>this.#h()).observe(e),new MutationObserver(()=>this.
redraw()).observe(document.documentElement,{attributes:!0}),addEventListener("beforeprint",()=>this.drawNow())}set look(e){this.#t={...this.#t,...e},this.#o(),this.
redraw()}show(e,t){this.#e=e,this.#n=Math.min(Math.max(0,t),e.moments.length-1),this.#o(),this.redraw()}redraw(){this.#a||(this.#a=requestAnimationFrame(()=>this.
drawNow()))}drawNow(){cancelAnimationFrame(this.#a),this.#a=0;let e=this.canvas.getContext("2d");if(!e||!this.#e)return;let{rows:t,cols:r}=this.#e,s=devicePixelRatio||
1;this.#r=Cn(t,r,this.#t.axes,this.canvas.width,this.canvas.height,s);let o={ctx:e,grid:this.#r,colors:st(this.canvas)};En(o,this.#e,this.#n,this.#t,s)}cellAt(e,t){
let r=this.canvas.getBoundingClientRect(),s=this.canvas.width/r.width;return pa(this.#r,(e-r.left)*s,(t-r.top)*s)}agentAt(e,t){let r=this.cellAt(e,t);if(!r||!this.#e)
return null;let s=this.#e.moments[Math.round(this.#n)],o=Et(this.#e,s).get(r[0]*this.#e.cols+r[1])??[],a=wn(this.#e,Math.round(this.#n)),i=l=>{let[c,u]=this.pointOf(
a[l].x,a[l].y);return Math.hypot(c-e,u-t)};return o.length?o.reduce((l,c)=>i(c)<i(l)?c:l):null}pointOf(e,t){let r=this.canvas.getBoundingClientRect(),s=r.width/
this.canvas.width,{left:o,top:a,cell:i}=this.#r;return[r.left+(o+e*i)*s,r.top+(a+t*i)*s]}#o(){if(!this.#e)return;let{rows:e,cols:t}=this.#e;this.canvas.style.setProperty(
"--board-aspect",String(ma(e,t)))}#h(){let e=devicePixelRatio||1,{width:t,height:r}=this.canvas.getBoundingClientRect();this.canvas.width=Math.max(1,Math.round(
t*e)),this.canvas.height=Math.max(1,Math.round(r*e)),this.drawNow()}};var Ct=[.5,1,2,4,8,16,32,64],On=0,kn=12,kc=2,Ie=class extends EventTarget{#e;#n;#t;#r=0;#a=0;#o=!1;#h=null;#m=0;#p=[];#g=[];glide=.28;constructor(e,{speed:t=4,still:r=!1}={}){
super(),this.#e=e,this.#n=t,this.#t=r}get step(){return this.#r}get time(){return this.#t?this.#r:this.#a}get arrived(){return this.#a===this.#r}get playing(){return this.#o}get length(){
return this.#e}set length(e){this.#e=e,this.#r>e&&this.jump(e),this.#i("state")}get marks(){return this.#p}set marks(e){this.#p=e,this.#i("state")}get ticks(){return this.#g}set ticks(e){
this.#g=e,this.#i("state")}get pace(){return this.#n||Math.max(kc,this.#e/kn)}get speed(){return this.#n}set speed(e){this.#n=e,this.#i("state")}changeSpeed(e){
let t=Ct.findIndex(r=>r>=this.pace);this.speed=Ct[Math.min(Ct.length-1,Math.max(0,t+e))]}play(){this.#o||!this.#e||(this.#r===this.#e&&this.jump(0),this.#o=!0,this.#i(
"state"),this.#y())}pause(){this.#o&&(this.#o=!1,this.#i("state"))}toggle(){this.#o?this.pause():this.play()}move(e){this.pause();let t=Math.min(this.#e,Math.max(
0,this.#r+e));Math.abs(t-this.#a)>1?this.jump(t):this.#d(t),this.#y()}jump(e){this.#a=Math.min(this.#e,Math.max(0,Math.round(e))),this.#d(this.#a),this.#i("fram\
e")}#d(e){e!==this.#r&&(this.#r=e,this.#i("step"),this.#t&&this.#i("frame"))}#y(){this.#h===null&&(this.#m=performance.now(),this.#h=requestAnimationFrame(()=>this.#s()))}#s(){
this.#h=null;let e=performance.now();this.#l(Math.min(.25,(e-this.#m)/1e3)),this.#m=e,(!this.#t||this.arrived)&&this.#i("frame"),(this.#o||this.#a!==this.#r)&&(this.#h=
requestAnimationFrame(()=>this.#s()))}#l(e){let t=e;for(;t>0;){if(this.#a===this.#r){if(!this.#o)return;if(this.#r===this.#e)return this.pause();this.#d(this.#r+
1)}let r=this.#o?this.pace:1/this.glide,s=this.#r-this.#a,o=Math.min(Math.abs(s),t*r);t-=o/r,this.#a=o===Math.abs(s)?this.#r:this.#a+Math.sign(s)*o}this.#o&&this.#a===
this.#e&&this.pause()}#i(e){this.dispatchEvent(new Event(e))}};function Rn(n,e){if(e.ctrlKey||e.metaKey||e.altKey)return!1;let t=e.shiftKey?10:1,s={" ":()=>n.toggle(),
ArrowRight:()=>n.move(t),ArrowLeft:()=>n.move(-t),Home:()=>n.move(-n.length),End:()=>n.move(n.length),"+":()=>n.changeSpeed(1),"-":()=>n.changeSpeed(-1)}[e.key];
return s?.(),s!==void 0}var Rc={first:"M6 5v14M19 5 9 12l10 7z",back:"M17 5 7 12l10 7z",play:"M7 4.5 19 12 7 19.5z",pause:"M8 5v14M16 5v14",forward:"M7 5l10 7-10 7z",last:"M18 5v14M5 5\
l10 7-10 7z"};function fa(n){return M("svg",{viewBox:"0 0 24 24","aria-hidden":"true",class:"icon"},M("path",{d:Rc[n]}))}function Ot(n,e,t,r){return d("button",
{type:"button",class:"player-button","aria-label":e,title:`${e} (${t})`,onclick:r},fa(n))}function _n(n){let e=Ot("play","Play","Space",()=>n.toggle()),t=d("inp\
ut",{type:"range",class:"player-scrub",min:0,step:1,"aria-label":"Step",oninput:()=>{n.pause(),n.jump(Number(t.value))}}),r=d("div",{class:"captures","aria-hidd\
en":"true",title:"Captures"}),s=d("div",{class:"losses","aria-hidden":"true"}),o=d("select",{class:"player-speed","aria-label":"Speed",title:`Steps a second, or\
 the whole in ${kn} s (+ and -)`,onchange:()=>n.speed=Number(o.value)},d("option",{value:On},`in ${kn} s`),...Ct.map(h=>d("option",{value:h},`${h} / s`))),a=d("\
output",{class:"player-count"}),i=d("div",{class:"player",role:"group","aria-label":"Player"},Ot("first","First step","Home",()=>n.move(-n.length)),Ot("back","S\
tep back","←",()=>n.move(-1)),e,Ot("forward","Step forward","→",()=>n.move(1)),Ot("last","Last step","End",()=>n.move(n.length)),d("div",{class:"scrub"},r,s,
t),a,o),l=(h,m={})=>{let p=d("i",m);return p.style.left=`${100*h/Math.max(1,n.length)}%`,p},c=()=>{r.replaceChildren(...n.marks.map(h=>l(h))),s.replaceChildren(
...n.ticks.map(({step:h,kind:m,size:p,text:y})=>{let f=l(h,{class:m,title:`Step ${h}: ${y}`});return f.style.height=`${100*p}%`,f}))},u=()=>{e.replaceChildren(fa(
n.playing?"pause":"play")),e.ariaLabel=n.playing?"Pause":"Play",e.title=`${e.ariaLabel} (Space)`,t.max=String(n.length),t.value=String(n.step),t.ariaValueText=`\
step ${n.step} of ${n.length}`,a.textContent=`${n.step} / ${n.length}`,a.style.minWidth=`${2*String(n.length).length+3}ch`,o.value=String(n.speed)};return n.addEventListener(
"step",u),n.addEventListener("state",u),n.addEventListener("state",c),i.addEventListener("keydown",h=>{!(h.target instanceof HTMLSelectElement||h.key===" "&&h.target!==
t)&&Rn(n,h)&&h.preventDefault()}),u(),i}function Pn(n,e,t){if(t===0)return[{kind:"start",text:_c(n),agents:[]}];let r=e.moments[t-1],s=e.moments[t],o=u=>ie(u,n.config.n_pursuers),a=Tt(e,r,s),i=n.conflicts(
t),l=new Set(i.flatMap(u=>u.doomed)),c=a.map(u=>({kind:"capture",text:`${o(u)} is captured`,agents:[u]}));for(let u of bn(r,s))!a.includes(u)&&!l.has(u)&&c.push(
{kind:"end",text:`${o(u)} disappears`,agents:[u]});return c.push(...i.map(({kind:u,text:h,agents:m})=>({kind:u,text:h,agents:m}))),t===n.length&&c.unshift({kind:"\
end",text:Pc(n),agents:[]}),c}function _c({config:n}){return`${n.n_pursuers} pursuers and ${n.n_evaders} evaders on ${n.rows} x ${n.cols} cells, at most ${n.max_steps}\
 steps`}function Pc(n){let e=Math.round(n.statistics.capture_rate*n.config.n_evaders);return`The episode ends after ${n.length} steps with ${e} of ${n.config.n_evaders}\
 evaders captured`}var Jr=.005,ga=.05,$c=4,ot=new Map;function $n(n,e,t="capture-rate"){let r=JSON.stringify([{...e,rewards:null},t]),s=ot.get(r)??(qt(e)?Promise.resolve(null):Ic(
n,e,t));return ot.delete(r),ot.set(r,s),ot.size>$c&&ot.delete([...ot.keys()][0]),s}var va=({n_evaders:n})=>n===1?"capture-time":"capture-rate",ya=()=>new Promise(
n=>setTimeout(n));async function Ic(n,e,t){await ya();let r=n.solution(e,t);for(;r.goBack();)await ya();return r}function In(n,e,t){let{payoff:r}=n;return t.flatMap(
(s,o)=>{let a=[0,0];for(let l=e.n_turns;l>0&&!e.over;l--)n.game(e)?.lost(s).forEach((c,u)=>a[u]+=c),e.playTurn(s);let i=r==="capture-rate"?Jr:ga;return T.map((l,c)=>({
step:o+1,team:l,lost:a[c],payoff:r})).filter(l=>l.lost>=i)})}var Nn=n=>n.map(e=>({step:e.step,kind:e.team,size:e.lost/Math.max(1,...n.map(({lost:t})=>t)),text:kt(
e)})),ba=({lost:n,payoff:e})=>e==="capture-rate"?`${n.toFixed(2)} of the capture rate`:`${n.toFixed(1)} steps`,kt=n=>`The ${n.team}s lose ${ba(n)} against a per\
fect opponent`;function wa(n){let e=n.reduce((t,r)=>r.lost>t.lost?r:t);return`Your team's worst moves, in step ${e.step}, lost ${ba(e)} against a perfect oppone\
nt.`}function xa({config:n,payoff:e},{value:t},r){if(e==="capture-rate")return`value ${t.toFixed(2)}`;let s=1-t,o=Math.min(n.max_steps-r,yr);return s>o-ga?`free\
 for ${o} steps`:`captured after ${s.toFixed(1)} steps`}function Sa(n,e){return(n.marginal(e)??[]).map((r,s)=>({share:r,action:s})).filter(({share:r})=>r>=Jr).sort(
(r,s)=>s.share-r.share).map(({share:r,action:s})=>r>1-Jr?se[s]:`${se[s]} ${r.toFixed(2)}`).join(", ")}var Aa=["·","↑","→","↓","←","↗","↘","↙","↖"];var Nc={" ":0,ArrowUp:1,w:1,ArrowRight:2,d:2,ArrowDown:3,s:3,ArrowLeft:4,a:4,e:5,c:6,y:7,z:7,q:8},Zr=[8,1,5,4,0,2,7,3,6],Lc=[7,8,9,4,5,6,1,2,3],Fc=24,Dc=Math.tan(
Math.PI/8);function Ta(n,e){if(n.ctrlKey||n.metaKey||n.altKey)return;let t=Lc.findIndex(s=>n.code===`Numpad${s}`),r=Zr[t]??Nc[n.key.length===1?n.key.toLowerCase():
n.key];return r!==void 0&&r>4&&!e?void 0:r}function Ea(n){let e=Zr.map(t=>d("button",{type:"button","aria-label":se[t],onclick:()=>n(t)},Aa[t]));return{element:d(
"div",{class:"play-pad",role:"group","aria-label":"Your move"},...e),show:t=>e.forEach((r,s)=>r.classList.toggle("absent",Zr[s]>4&&!t))}}function Ma(n,e,t){let r=Dc*
Math.max(Math.abs(n),Math.abs(e)),s=o=>Math.abs(o)<r?0:o;return _o([0,0],t?[s(n),s(e)]:[n,e],t)}function Ca(n,e,t){let r=null,{canvas:s}=n;s.addEventListener("p\
ointerdown",({button:o,clientX:a,clientY:i})=>r=o===0?[a,i]:null),s.addEventListener("pointercancel",()=>r=null),s.addEventListener("pointerup",({clientX:o,clientY:a})=>{
let i=r,l=e();if(r=null,!i||!l)return;let c=o-i[0],u=a-i[1],h=n.cellAt(o,a);Math.hypot(c,u)>=Fc?t(Ma(u,c,l.diagonal)):h&&t(Ma(h[0]-l.cell[0],h[1]-l.cell[1],l.diagonal))})}
function Oa(n,e){let t=r=>{let s=e[r]-n[r],o=ae.findIndex(a=>a[r]===Math.sign(s)&&a[1-r]===0);return s?`${Math.abs(s)} ${se[o]}`:""};return[t(0),t(1)].filter(Boolean).
join(", ")||"on your cell"}var _a="NUMPY\0",ka=_a.length+2,Ra=64;function Rt(n){return on(Object.fromEntries(Object.entries(n).map(([e,t])=>[`${e}.npy`,Uc(t)])))}function Uc({dtype:n,shape:e,
data:t}){let r=typeof t=="string"?Array.from(t,u=>u.codePointAt(0)):null,s=e.map(u=>`${u}, `).join(""),o=`{'descr': '${r?`<U${r.length}`:n}', 'fortran_order': F\
alse, 'shape': (${s}), }`,a=Math.ceil((ka+o.length+1)/Ra)*Ra-ka,i=_a+String.fromCharCode(a&255,a>>8)+o.padEnd(a-1)+`
`,l=r?Int32Array.from(r):t,c=new Uint8Array(i.length+l.byteLength);return c.set(Ue(i,!0)),c.set(new Uint8Array(l.buffer,l.byteOffset,l.byteLength),i.length),c}var Wc="matrixworld episode 3";function Pa(n,e,t){let{config:r,actions:s,length:o,recording:a}=e,i=r.n_pursuers+r.n_evaders,l=r.n_evaders,c={positions:["<i4",i,
2],last_positions:["<i4",i,2],alive:["|b1",i],captured:["|b1",l],ever_captured:["|b1",l]},u={rewards:["<f4",i],involved:["|b1",i,3],fault:["|b1",i,3]},h={},m=x=>{
for(let b of Object.keys(x))(h[b]??=[]).push(Array.from(p.read(b),Number))},p=n.world(r);p.reset(e.start);let y=[];m(c);for(let x of s)p.step(x),m({...c,...u}),
y.push(...p.conflictTable());p.free();let f={"<i4":Int32Array,"<f4":Float32Array,"|b1":Uint8Array},g={};for(let[x,[b,...E]]of Object.entries({...c,...u})){let _=o+
+(x in c);g[x]={dtype:b,shape:[_,...E],data:f[b].from((h[x]??[]).flat())}}let v=x=>({dtype:"<i8",shape:[],data:Int32Array.of(x,0)}),w=x=>({dtype:"<U",shape:[],data:x});
return Rt({format:w(Wc),n_pursuers:v(r.n_pursuers),config:w(JSON.stringify(r)),seat:v(t),...g,actions:{dtype:"|i1",shape:[o,i],data:Int8Array.from(s.flatMap(x=>[
...x]))},map:{dtype:"|b1",shape:[r.rows,r.cols],data:Uint8Array.from(a.obstacles,Number)},conflict_table:{dtype:"<i4",shape:[y.length/11,11],data:Int32Array.from(
y)}})}var Bc=[0,1,2,4,8],Ln=class{element;player=new Ie(0,{speed:4,still:Te()});#e;#n;#t=d("canvas",{tabindex:0,"aria-describedby":"play-keys"});#r=d("h2");#a=d("p",{
class:"play-told",role:"status"});#o=Ea(e=>this.act(e));#h=re(Bc.map(e=>[e,e?`${e} / s`:"step by step"]),()=>this.#C());#m=d("input",{type:"checkbox",onchange:()=>this.#x()});#p=d(
"input",{type:"checkbox",onchange:()=>this.#_()});#g=d("label",{class:"play-choice"},this.#p,"Best move");#d=d("p",{class:"small muted play-keys",id:"play-keys"});#y=d(
"section",{class:"play-ending",tabindex:-1,"aria-labelledby":"play-headline"});#s=_n(this.player);#l=null;#i=null;#f=[];#c=null;#w=null;#b=[];#v=0;#u=0;constructor(e){
this.#e=e,this.#n=new $e(this.#t,{numbers:!1}),this.#t.setAttribute("role","application"),Ca(this.#n,()=>{let t=this.#c!==null&&this.#i&&W(this.#i.recording.moments.
at(-1),this.#c);return t?{cell:t,diagonal:this.#i.config.diagonal}:null},t=>this.act(t)),this.player.addEventListener("frame",()=>this.#i&&this.#n.show(this.#i.
recording,this.player.time)),this.player.addEventListener("step",()=>this.#_()),this.element=d("div",{class:"play"},d("header",{class:"play-head"},this.#r,this.#a),
d("div",{class:"play-stage"},this.#t),d("div",{class:"play-side"},this.#y,this.#o.element,d("label",{class:"play-choice",title:"Steps a second"},"Pace ",this.#h),
d("label",{class:"play-choice"},this.#m,d("span",{},"Fog",d("span",{class:"at-length"},": see only what it sees"))),this.#g,this.#d),this.#s)}get played(){return this.#l&&
{...this.#l.played,moves:this.#f}}get live(){return this.#i}play(e){this.#S(xt(this.#e,e.played),e.played.seat,e.title),this.#l=e,this.#f=[...e.played.moves],this.#v=
0,this.element.dataset.state="playing",this.#t.focus({preventScroll:!0}),nn(this.#i,e.played.seat)&&this.#k()}watch(e,t,r){this.#l=null,this.#S(e,t,r),this.#R()}stop(){
this.#C(),this.player.pause(),this.#l=null}act(e){let t=this.#l,r=this.#i;if(!t||!r||this.element.dataset.state!=="playing")return;this.#v=e;let s=Number(this.#h.
value);this.#u||(this.#O(),s&&this.element.dataset.state==="playing"&&(this.#u=setInterval(()=>this.#O(),1e3/s)))}key(e){let{target:t,key:r}=e;if(t instanceof HTMLSelectElement||
t instanceof HTMLInputElement&&(t.type==="text"||r===" ")||t instanceof HTMLButtonElement&&(r===" "||r==="Enter")||!this.#i)return!1;if(this.element.dataset.state!==
"playing")return Rn(this.player,e);let o=Ta(e,this.#i.config.diagonal);return o!==void 0&&this.act(o),o!==void 0}#S(e,t,r){this.#C(),this.player.pause(),this.#i=
e,this.#c=t,this.#r.textContent=r,this.#t.ariaLabel=`Board, ${e.config.rows} by ${e.config.cols} cells`,this.#o.show(e.config.diagonal),this.#d.replaceChildren(
d("span",{class:"at-length"},`W A S D or the arrow keys move, Space stays${e.config.diagonal?"; Q E Z C and the numeric keypad move diagonally":""}. `),"On the \
board: swipe, or tap where to go."),this.#A(e),this.#y.replaceChildren(),this.player.length=e.length,this.player.jump(e.length),this.#_()}#x(){this.#n.look={you:this.#c,
fog:this.#m.checked,viewers:this.#c===null?[]:[this.#c],plan:this.#E()}}#A(e){this.#w=null,this.#b=this.player.ticks=[],this.#g.hidden=this.#p.disabled=!!qt(e.config),
$n(this.#e,e.config,va(e.config)).then(t=>{this.#i===e&&(this.#w=t,this.#T(),this.#_())})}#T(){let e=this.#i,t=this.#w;if(!t||this.element.dataset.state==="play\
ing")return;let r=this.#e.world(e.config);r.reset(e.start),this.#b=In(t,r,e.actions),r.free(),this.player.ticks=Nn(this.#b)}get#M(){return this.#p.checked&&this.#l&&
this.element.dataset.state==="playing"&&this.#w&&this.#i.game(this.#w)||null}#E(){let e=this.#c,t=this.#c!==null&&this.#M?.marginal(this.#c);return e!==null&&t?
Object.assign(Array(e).fill(0),{[e]:t.indexOf(Math.max(...t))}):null}#C(){clearInterval(this.#u),this.#u=0,this.#a.ariaLive=Number(this.#h.value)?"off":"polite"}#O(){
let{policies:e,seat:t}=this.#l.played,r=this.#i;r.step(e,t,this.#v),this.#f.push(this.#v),this.player.length=r.length,this.player.glide=Math.min(.22,.9/(Number(
this.#h.value)||4)),this.player.move(r.length-this.player.step),nn(r,t)&&this.#k()}#k(){this.#C();let e=this.#l,t=this.#i,r=this.played,s=ge()?e.link(r):null,o=`${ie(
r.seat,t.config.n_pursuers)}-${t.length}-steps.npz`,a=()=>Xe(o,Pa(this.#e,t,r.seat)),i=Zt("Link to this match");i.hidden=!0,this.#y.replaceChildren(d("h3",{id:"\
play-headline"},zc(t,r.seat)),...e.ending(t,r),d("div",{class:"play-buttons"},d("button",{type:"button",class:"primary",onclick:()=>e.again()},"Again"),d("butto\
n",{type:"button",onclick:()=>this.#R()},"Watch it"),d("button",{type:"button",onclick:a},"Save"),s&&d("button",{type:"button",onclick:()=>Xt(i,s)},e.linkName??
"Link")),i),this.element.dataset.state="ended",this.player.jump(t.length),this.#T();let l=this.#b.filter(({team:c})=>c===ve(t.config,r.seat));l.length&&this.#y.
children[0].after(d("p",{class:"small muted"},wa(l))),this.#y.focus({preventScroll:!0}),this.#y.scrollIntoView({block:"nearest"})}#R(){this.element.dataset.state=
"watched",this.player.length=this.#i.length,this.player.jump(0),Te()||this.player.play()}#_(){let e=this.#i,t=this.#c,{step:r}=this.player;if(!e||r>e.length)return;
let s=Pn(e,e.recording,r).filter(({agents:l})=>t===null||l.includes(t)),o=this.#l&&r===0,a=o?[jc(e.config,t),this.#l.about??""]:[`Step ${r} of ${e.config.max_steps}`,
...s.map(({text:l})=>l)];!o&&t!==null&&a.push(Gc(e,r,t)),a.push(...this.#b.filter(l=>l.step===r).map(kt));let i=r===e.length&&t!==null?this.#M:null;i&&a.push(`P\
erfect play: ${Sa(i,t)||"decided in its turn"}; ${xa(this.#w,i,r)}`),this.#x(),this.#a.textContent=a.filter(Boolean).map(l=>`${l}.`).join(" ")}};function jc(n,e){
let t=n.rules.capture==="SURROUND";return ve(n,e)==="evader"?`Run away: you win if ${t?"the pursuers do not surround you":"no pursuer reaches your cell"} in ${n.
max_steps} steps`:`Capture evaders: ${t?"surround them with your team":"move onto their cells"}`}function Gc({config:n,recording:e},t,r){let s=e.moments[t],o=ve(
n,r),a=le(o);if(!s.alive[r])return"";let i=W(s,r),l=h=>{let[m,p]=W(s,h);return Math.max(Math.abs(m-i[0]),Math.abs(p-i[1]))},c=Array.from({length:s.alive.length},
(h,m)=>m).filter(h=>ve(n,h)===a&&s.alive[h]&&!s.captured[h-n.n_pursuers]&&2*l(h)<n.fov);if(!c.length)return`No ${a} in view`;let u=c.reduce((h,m)=>l(m)<l(h)?m:h);
return`Nearest ${a}: ${Oa(i,W(s,u))}`}function zc(n,e){let{lasted:t,out:r,captured:s}=Se(n,e),{config:o}=n;return ve(o,e)==="pursuer"?`Your team captured ${s} o\
f ${Hc(o)} in ${t} steps.`:r?`You lasted ${t} of ${o.max_steps} steps.`:`You escaped: ${t} steps.`}var Hc=({n_evaders:n})=>`${n} evader${n===1?"":"s"}`;var Vc=60,Yc={evader:"Can you escape them?",pursuer:"Can you catch them?"},Fn=class{dialog=d("dialog",{class:"take-over","aria-label":"Play against the champion\
s",onclose:()=>this.view?.stop(),onkeydown:e=>this.view?.key(e)&&e.preventDefault()});view=null;#e;#n;constructor(e,t){this.#e=e,this.#n=t}play(e,{world:t,policies:r,
players:s,seed:o,rate:a,friend:i},l){this.view||(this.view=new Ln(this.#e),this.dialog.append(d("button",{type:"button",class:"leave",onclick:()=>this.dialog.close()},
"Close"),this.view.element)),this.dialog.open||this.dialog.showModal();let c={...t,max_steps:Math.min(Vc,t.max_steps)},u=e==="evader"?c.n_pursuers:0,h=({lasted:f,
captured:g})=>e==="evader"?f:g,m=e==="evader"?c.max_steps:c.n_evaders,p=f=>e==="evader"?`survived ${f} of ${m} steps`:`caught ${f} of ${m} with the team`,y=f=>({
pursuer:r.pursuer.genome,evader:r.evader.genome,seed:String(f.seed),episode:f.episode,seat:u,rate:a,score:h(Se(xt(this.#e,f),u))});zr(this.#e,this.view,{config:c,
seed:BigInt(l.seed),episode:l.episode,policies:r,seat:u,from:0,moves:[]},{title:Yc[e],players:s,linkName:"Challenge a friend",about:`Seed ${o}: these pursuers c\
atch ${a} %. ${i?`Your friend ${p(i.score)}`:"You have the seat with the ring"}`,told:f=>{if(!i)return"";let g=h(f);return g>i.score?`You beat your friend, who ${p(
i.score)}.`:`Your friend ${p(i.score)}: ${g===i.score?"a draw":"not beaten yet"}.`},link:f=>this.#n(y(f))})}};var q=(n,e=2)=>n==null?"-":n.toFixed(e);function $a(n,e,t){return e===null||t===null?q(n):`${q(n)} (${q(e)} to ${q(t)})`}function at(n){let e=Math.abs(n),t=e>=1e4?
e.toExponential(0):e.toFixed(e<100?2:0);return n<0&&Number(t)?`−${t}`:t}var Dn=n=>n.charAt(0).toUpperCase()+n.slice(1);function _t(n,e,t,r=!1){let s=(e-n)/Math.max(1,t),o=10**Math.floor(Math.log10(s||1)),a=[1,2,5,10].map(c=>c*o).find(
c=>c>=s)??10*o;r&&(a=Math.max(1,Math.round(a)));let i=Math.ceil(n/a-1e-9),l=Math.floor(e/a+1e-9);return Array.from({length:Math.max(0,l-i+1)},(c,u)=>(i+u)*a)}var Xr={right:12,top:10,bottom:42},Un={x:56,y:34,letter:8,label:30};function Ia(n,e,t,r){let{top:s}=Xr,o=Math.max(s+40,e-Xr.bottom),a=_t(r.low,r.high,(o-s)/Un.y,
r.whole),i=Un.label+Un.letter*Math.max(2,...a.map(g=>Qr(g).length)),l=Math.max(i+40,n-Xr.right),c=(g,v,w)=>x=>v+(x-g.low)/(g.high-g.low||1)*(w-v),u=c(t,i,l),h=c(
r,o,s),m=M("g"),p=M("svg",{width:n,height:e,viewBox:`0 0 ${n} ${e}`,class:"plot"}),y=M("g",{class:"axes"});for(let g of a)y.append(M("line",{x1:i,x2:l,y1:h(g),y2:h(
g),class:"grid"}),M("text",{x:i-8,y:h(g),"text-anchor":"end","dominant-baseline":"middle"},Qr(g)));for(let g of _t(t.low,t.high,(l-i)/Un.x,t.whole))y.append(M("\
text",{x:u(g),y:o+16,"text-anchor":"middle"},Qr(g)));return y.append(M("line",{x1:i,x2:l,y1:o,y2:o,class:"axis"}),M("text",{x:(i+l)/2,y:e-6,"text-anchor":"middl\
e",class:"label"},t.label),M("text",{transform:`translate(12 ${(s+o)/2}) rotate(-90)`,"text-anchor":"middle",class:"label"},r.label)),p.append(y,m),{root:p,marks:m,
left:i,right:l,top:s,bottom:o,x:u,y:h,at:g=>{let v=g-p.getBoundingClientRect().left;return t.low+(v-i)/(l-i)*(t.high-t.low)}}}var Qr=n=>String(Number(n.toPrecision(
6))).replace("-","−");function Na(n,e,t,r){let s="",o="M";t.forEach((a,i)=>{a===null?o="M":(s+=`${o}${n.x(e[i]).toFixed(1)} ${n.y(a).toFixed(1)}`,o="L")}),n.root.
insertBefore(M("path",{d:s,class:`line ${r}`}),n.marks)}function La(...n){return d("p",{class:"legend small"},...n.map(([e,t])=>d("span",{class:`key ${t}`},e)))}function Fa(n,e,t=()=>{},r=()=>{}){let s=d("div",{class:"\
chart chooses",role:"img","aria-label":n}),o=null,a=()=>{o?.marks.replaceChildren(),o&&t(o)};s.addEventListener("click",l=>o&&r(o.at(l.clientX),o,l));let i=()=>{
let{clientWidth:l,clientHeight:c}=s;l<50||c<50||(o=e(l,c),s.replaceChildren(o.root),a())};return new ResizeObserver(i).observe(s),{element:s,update:a,redraw:i}}function Da(n,e){let{config:t,view:r,team:s,at:o,move:a}=n,{fov:i,diagonal:l}=t,c=Math.floor(i/2),u=ae.slice(0,l?9:5),h=S=>Array.from(r.subarray(S*i*i,(S+1)*i*i)).
flatMap((C,z)=>C?[[Math.floor(z/i)-c,z%i-c]]:[]),[m,p,y]=[h(0),h(1),h(2)],[f,g]=s==="pursuer"?[p,m]:[m,p],v=(S,[C,z])=>S.some(([I,H])=>I===C&&H===z),w=(S,C)=>{let[
z,I]=[Math.abs(S[0]-C[0]),Math.abs(S[1]-C[1])];return l?Math.max(z,I):z+I},x=(S,C)=>[S[0]+C[0],S[1]+C[1]],b=S=>u.slice(1).map(C=>x(S,C)),E=(S,C)=>{let z=Math.min(
...S.map(I=>w(I,C)));return S.filter(I=>w(I,C)===z)},_=S=>!v(y,S),R=S=>x(o,S),k=[0,0],A=u[a],D=E(g,k),L=(S,C)=>{let z=[S,...b(S)].filter(_),I=H=>C.some(Q=>w(Q,H)<=
1);return{escape:z.filter(H=>!I(H)),held:z.filter(I)}},F=s==="evader"?[L(A,g)]:D.map(S=>L(S,[A,...f])),fe=s==="evader"?D.flatMap(S=>E(g.filter(C=>C!==S),k).map(
C=>[A,S,C])):D.flatMap(S=>E(f,S).map(C=>[S,A,C])),X=g.flatMap(b).filter(S=>Math.max(...S.map(Math.abs))<=c&&_(S)&&!v(f,S)),J=ae.slice(1,5).flatMap(([S,C])=>Array.
from({length:c},(I,H)=>[A[0]+H*S,A[1]+H*C]).filter(I=>!_(I)).slice(0,1)),U=S=>e.includes(S),P={ways:U("escapes")?Wn(F,S=>S.escape.length):null,sides:U("opposite")?
Wn(fe,S=>-Kc(...S)):null,openSide:U("open_side")?Wn(X,S=>w(S,A)):null,exits:U("exits")?b(A).filter(_):[],wall:U("room")?Wn(J,S=>w(S,A)):null};return{to:R(A),escape:(P.
ways?.escape??[]).map(R),held:(P.ways?.held??[]).map(R),sides:P.sides&&[R(P.sides[0]),R(P.sides[1]),R(P.sides[2])],openSide:P.openSide&&R(P.openSide),exits:P.exits.
map(R),wall:P.wall&&R(P.wall)}}function Wn(n,e){let t=n.map(e);return n[t.indexOf(Math.min(...t))]??null}function Kc(n,e,t){let[r,s]=[e,t].map(a=>[a[0]-n[0],a[1]-
n[1]]),o=Math.hypot(...r)*Math.hypot(...s);return o?(1-(r[0]*s[0]+r[1]*s[1])/o)/2:.5}var Ua=0,Wa=1,qc=2,Jc=176;function ja(n,e,t,r){let s=devicePixelRatio||1,o=st(n);n.width=n.height=Jc*s;let a=n.getContext("2d");if(!a)return;let{fov:i}=e,l=n.width/
i;a.fillStyle=o.paper,a.fillRect(0,0,n.width,n.height);for(let u=0;t&&u<i*i;u++){let h=(u%i+.5)*l,m=(Math.floor(u/i)+.5)*l,p=f=>!!t[f*i*i+u];p(qc)&&(a.fillStyle=
o.obstacle,a.fillRect(h-l/2,m-l/2,l,l));let y=p(Ua)&&p(Wa)?l*.18:0;p(Ua)&&Ba(a,pe,h+y,m+y,l*.74,o.evader),p(Wa)&&Ba(a,nt,h-y,m-y,l*.86,o.pursuer)}a.strokeStyle=
r<e.n_pursuers?o.pursuer:o.evader,a.lineWidth=2*s;let c=Math.floor(i/2)*l;a.strokeRect(c,c,l,l)}function Ba(n,e,t,r,s,o){e(n,t,r,s),n.fillStyle=o,n.fill()}var Zc=["stay","↑","→","↓","←","↗","↘","↙","↖"];function es(n,e){let t=Fr(n,e);if(t){let r=s=>Math.abs(t[s]??0);return n.inputs.filter(r).sort((s,o)=>r(
o)-r(s))}return n.inputs.filter(r=>!e||new RegExp(`\\b${r}\\b`).test(e.expression))}function Ga(n,{inputs:e,ratings:t,refused:r},s,o,a){let i=Fr(n,a),l=m=>`${m===
s?"taken":""} ${r[m]?"refused":""} ${m===o?"asked":""}`,c=(m,p)=>d("tr",{class:p.every(y=>y===p[0])?"same":""},m,...Array.from(p,(y,f)=>d("td",{class:l(f)},at(y)))),
u=m=>{let y=`${i?`weight ${at(i[m])} x `:""}${Le[m]}`;return d("th",{scope:"row",title:y},m.replaceAll("_"," "))},h=d("table",{class:"why numbers"},d("thead",{},
d("tr",{},d("th",{},i?"term":"input"),...Array.from(t,(m,p)=>d("th",{scope:"col",class:l(p),title:se[p],"aria-label":se[p]},Zc[p]))),c(d("th",{scope:"row"},i?"s\
um":"rating"),t)),d("tbody",{},...es(n,a).map(m=>{let p=i?i[m]:1,y=e[n.inputs.indexOf(m)];return c(u(m),y.map(f=>p*f))})));return[...a?[d("p",{class:"expression"},
d("code",{},a.expression))]:[],d("div",{class:"wide-table",tabindex:0,role:"group","aria-label":"How the moves are rated"},h)]}var Xc=(n,{pursuer:e,evader:t})=>({pursuers:_e(n,"pursuer",e),evaders:_e(n,"evader",t)}),za="What it remembers: a number for each unit, from -1 to 1",it=class{element;#e;#n;#t=d(
"canvas",{class:"seen",role:"img"});#r=d("h3");#a=d("p",{class:"small muted"});#o=d("div",{class:"answers"});#h=d("div",{title:za});#m=null;#p=null;#g=null;#d=null;#y=null;#s=null;#l=null;#i=0;#f=null;#c=null;#w=new Map;constructor(e,t=null){
this.#e=e,this.#n=t,this.element=d("div",{class:"inspector","data-open":"false"},d("p",{class:"hint small muted"},"Click an agent, or press A: what it sees, and\
 why it takes its move."),d("div",{class:"inspected"},this.#t,d("div",{class:"answer"},this.#r,this.#a,this.#h),this.#o))}get agent(){return this.#l}show(e,t,r,s,o=Xc(
t,s)){this.#m?.free(),this.#m=e.world(r.config),this.#g!==t&&(this.#p=null,this.#l!==null&&this.choose(null)),this.#g=t,this.#d=r,this.#y=s,this.#s=o,this.#b()}set solution(e){
this.#p=e,this.at(this.#i)}choose(e){this.#l=e,this.#b(),this.element.dataset.open=String(e!==null),this.#e(e),this.at(this.#i)}next(e){let t=this.#d;if(!t)return;
let r=this.#l??(e>0?-1:0);for(let s=0;s<t.n_agents;s++)if(r=(r+e+t.n_agents)%t.n_agents,t.alive[this.#i*t.n_agents+r])return this.choose(r)}ask(e){let t=this.#v();
if(!t.length)return;let r=t.indexOf(this.#f??this.#T(this.#l)??0);this.#f=t[(r+e+t.length)%t.length],this.at(this.#i)}askTo(e){let t=this.#u(e);return t===null?
!1:(this.#f=t,this.#c=null,this.at(this.#i),!0)}point(e,t){let r=e&&this.#u(e),s=this.#l,o=r!==null&&s!==null?{agent:s,move:r}:t!==null&&t!==s?{agent:t,move:null}:
null;o?.agent===this.#c?.agent&&o?.move===this.#c?.move||(this.#c=o,this.at(this.#i))}#b(){this.#f=this.#c=null,this.#w.clear()}#v(){let e=this.#l;if(e===null||
!this.#d||!this.#x(e))return[];let{config:t}=this.#d,r=this.#M(e)?.view,s=Math.floor(t.fov/2);return ae.slice(0,t.diagonal?9:5).flatMap(([o,a],i)=>r&&!r[(2*t.fov+
s+o)*t.fov+s+a]?[i]:[])}#u([e,t]){let r=this.#l,s=r===null?null:this.#M(r)?.at;return s?this.#v().find(o=>s[0]+ae[o][0]===e&&s[1]+ae[o][1]===t)??null:null}#S(e){
return e<this.#d.config.n_pursuers?"pursuer":"evader"}#x(e){let t=this.#s?.[`${this.#S(e)}s`];return t&&typeof t!="string"&&t.kind!=="cells"?t:null}#A(e){let t=this.#S(
e);return Ao(this.#g,t,this.#y[t])}#T(e){let{actions:t,n_agents:r}=this.#d;return t[this.#i*r+e]??null}#M(e){return this.#w.has(e)||this.#w.set(e,this.#E(e)),this.#w.
get(e)}#E(e){let[t,r,s]=[this.#d,this.#m,this.#i];t.seek(r,s,this.#s);let o=r.read("positions"),a=t.actions.subarray(s*t.n_agents,(s+1)*t.n_agents);for(;a.length&&
!r.over&&(e<r.actors[0]||e>=r.actors[1]);)r.playTurn(a);let i=r.read("alive");if(!t.alive[s*t.n_agents+e]||!i[e])return null;let l=r.read("positions"),c=h=>[l[2*
h],l[2*h+1]],u=Array.from(i,(h,m)=>m).filter(h=>i[h]&&(l[2*h]!==o[2*h]||l[2*h+1]!==o[2*h+1]));return{at:c(e),view:r.view(e),moved:u.map(h=>({pursuer:this.#S(h)===
"pursuer",cell:c(h)}))}}#C(){if(!this.#n)return;let e=this.#c?.agent??this.#l,t=e===null||!this.#d?null:this.#x(e),r=e===null||!t?null:this.#O(e),s=e===null||r===
null?null:this.#M(e);if(e===null||!t||r===null||!s)return this.#n(null);let o={config:this.#d.config,team:this.#S(e),move:r,...s},a=es(t,this.#A(e));this.#n({...Da(
o,a),moved:s.moved})}#O(e){let t=e===this.#l?this.#f:null;return this.#c?.move??t??this.#T(e)}at(e){e!==this.#i&&this.#b(),this.#i=e,this.#k(),this.#C()}#k(){let e=this.#d,
t=this.#m,r=this.#g,s=this.#y,o=this.#s,a=this.#l;if(!e||!t||!r||!s||!o||a===null)return;let i=this.#S(a);this.#h.replaceChildren(),this.#r.replaceChildren(d("s\
pan",{class:i},ie(a,e.config.n_pursuers)));let l=this.#E(a);if(ja(this.#t,e.config,l?.view??null,a),this.#t.ariaLabel=`Field of view of ${ie(a,e.config.n_pursuers)}\
: evaders, pursuers and obstacles around it`,!l)return this.#R([],"It is gone.");let c=this.#T(a),u=o[`${i}s`],h=typeof u!="string"&&u.kind==="cells"?t.answer(u,
a):null,m=h?.probabilities??null;h?.memory.length&&this.#h.replaceChildren(d("p",{class:"small muted"},"It remembers:"),nu(h.memory));let p=this.#x(a),y=this.#n?
this.#O(a):null,f=p?Ga(p,t.rate(p,a),c,y,this.#A(a)):[],g=this.#p?.game(t)??null,v=[["network",m],["perfect",g?.marginal(a)??null]],w=x=>d("p",{class:"small mut\
ed"},x);this.#R([...g?[w(`Value ${g.value.toFixed(2)} under perfect play.`)]:[],...eu(v,c),...f],c===null?"The episode is over.":Qc(u,c))}#R(e,t){this.#o.replaceChildren(
...e),this.#a.textContent=t}};function Qc(n,e){return typeof n=="string"?`The script "${n}" plays for it; it goes ${se[e]}.`:n.kind!=="cells"?"It takes the best\
 move that its mask allows; of equal ones any.":n.sampled?"Its action is drawn from these probabilities.":"It takes the most probable action."}function eu(n,e){
let t=n.filter(([,o])=>o);if(!t.length)return[];let r=d("div",{class:"action muted"},d("span"),...t.map(([o])=>d("span",{class:"head"},o))),s=Array.from(t[0][1],
(o,a)=>d("div",{class:a===e?"action taken":"action"},d("span",{},se[a]),...t.flatMap(([,i])=>tu(i[a]))));return t.length>1||t[0][0]!==n[0][0]?[r,...s]:s}function tu(n){
let e=d("span",{class:"filled"});return e.style.width=`${100*n}%`,[d("span",{class:"track"},e),d("span",{class:"numbers"},n.toFixed(2))]}function nu(n){let e=Array.
from(n,t=>{let r=d("span",{title:t.toFixed(2)});return r.style.transform=`scaleY(${t})`,r});return d("div",{class:"units",role:"img","aria-label":za},...e)}var ru=40,Bn=class{element;#e;#n=d("div",{class:"episodes",role:"group","aria-label":"Episodes of this cell"});#t=d("p",{class:"check small numbers","aria-live":"\
polite"});constructor(e){this.#e=e,this.element=d("div",{class:"strip-of-episodes"},this.#n,this.#t)}show(e,t){let{pursuer:r,evader:s,episode:o,seed:a}=this.#e.
selected,i=Pe(e,r,s);this.#n.replaceChildren(...(i?.rates??[]).slice(0,ru).map((m,p)=>this.#r(m,p)));let l=a===null?i?.rates[o]:void 0,c=t.statistics.capture_rate,
u=l!==void 0&&Math.abs(c-l)<1e-6&&t.length===i?.lengths[o],h=i?"Not an episode of the evaluation":"The evaluation played no episodes of this pair.";this.#t.dataset.
equal=String(u),this.#t.textContent=u?"As in the evaluation":l===void 0?h:`Episode ${o+1} differs from the evaluation.`,this.#t.title=`Played here: capture rate\
 ${q(c,3)} in ${t.length} steps.${i?` The cell says ${q(i.rate,3)}.`:""}`}#r(e,t){let{selected:r}=this.#e,s=d("span",{class:"bar"});return s.style.height=`${Math.
round(100*e)}%`,d("button",{type:"button",class:"episode",title:`Episode ${t+1}: capture rate ${q(e)}`,"aria-label":`Episode ${t+1}, capture rate ${q(e)}`,"aria\
-pressed":String(t===r.episode&&r.seed===null),onclick:()=>this.#e.select({episode:t,seed:null})},s,d("span",{class:"count"},t+1))}};var su=200;function Ha(n,e,{pursuer:t,evader:r},s){let{text:o,image:a}=e.shows[`${t} ${r}`]??{},i=Pe(n,t,r)?.rates??[],l=`Scores of the ${e.teams[0]} in ${i.length}\
 episodes: ${i.map(u=>q(u)).join(", ")}`,c=ou(n,e,t,r);return[o===void 0?null:d("pre",{tabindex:0,"aria-label":"What the game shows of this pair"},o),a===void 0?
null:d("img",{src:a,alt:"What the game shows of this pair",onload:({target:u})=>u.classList.toggle("pixels",u.naturalWidth<su)}),...(o??a)===void 0?[d("p",{class:"\
muted"},e.missing),au(n,e,t,r,s)]:[],c?d("p",{class:"small numbers"},c):null,i.length>1?d("p",{class:"small numbers"},l):null].filter(u=>u!==null)}function ou(n,e,t,r){
let{others:s,extras:o={}}=n.payoff,a=s?.[t]?.[r],i=a===void 0?[]:[`score of the ${e.teams[1]} ${q(a)}`];for(let[l,c]of Object.entries(o)){let u=c[t]?.[r];u!==void 0&&
i.push(`${l} ${q(u)}`)}return i.length?`Means of the pair: ${i.join(", ")}`:""}function au(n,e,t,r,s){let o=Object.keys(e.shows).map(u=>u.split(" ").map(Number)),
a=([u,h])=>(u-t)**2+(h-r)**2,[i,l]=o.sort((u,h)=>a(u)-a(h))[0]??[];if(i===void 0||l===void 0)return null;let c=`${te(n,"pursuer",i)} against ${te(n,"evader",l)}`;
return d("p",{},d("button",{type:"button",onclick:()=>s.select({pursuer:i,evader:l})},`Nearest: ${c}`))}function Va(n){let e=JSON.stringify(n,(t,r)=>t==="genome"?Array.from(r):r);return d("script",{type:"application/json",id:"champions"},e.replaceAll("<","\\u003c")).
outerHTML}var Pt="_",iu="n",Zp=2n**64n-1n;var ts={fov:11,maxSteps:500,rewards:"paper"},lu=["rules","others","rewards","size","diagonal","fov","limit","seed","ended","walls","pursuers","evaders","played",
"next"];function qa(n,e){let t=i=>i.map(l=>uu(l,e)).join(""),r=i=>`${Math.floor(i/n.cols)}.${i%n.cols}`,s=cu(n.rewards,e),o=[n.seed,n.episode,n.steps].join("."),a={rules:Ka(
n.rules,e),others:n.others?Ka(n.others,e):"",rewards:s===ts.rewards?"":s,size:`${n.rows}x${n.cols}`,diagonal:n.diagonal?"1":"",fov:n.fov===ts.fov?"":String(n.fov),
limit:n.maxSteps===ts.maxSteps?"":String(n.maxSteps),seed:o==="0.0.0"?"":o,ended:n.ended?"1":"",walls:n.walls.map(r).join(Pt),pursuers:n.pursuers.map(Ya).join(Pt),
evaders:n.evaders.map(Ya).join(Pt),played:n.played.map(t).join(Pt),next:n.next.every(i=>i===eo)?"":t(n.next)};return lu.filter(i=>a[i]).map(i=>`${i}=${a[i]}`).join(
"&")}function Ya({cell:n,gone:e,captured:t,everCaptured:r}){let s=t?"c":r?"e":"";return`${n[0]}.${n[1]}${s}${e?"x":""}`}function Ka(n,e){let t=e.fields.map(({name:r})=>String(
n[r]).toLowerCase());return to(n,e.variants)??t.join(".")}function cu(n,e){let t=JSON.stringify(n);return Object.keys(e.rewards).find(s=>JSON.stringify(e.rewards[s])===
t)??Object.values(n).map(s=>String(s)).join(Pt)}function uu(n,e){if(typeof n=="number")return String(n);if(n===Qs)return iu;let t=e.scripts.findIndex(({name:r})=>r===
n);return String.fromCharCode(97+t)}var hu="/* the engine */";function Ja(n,e){return d("button",{type:"button",class:"to-playground",title:"Open this step in the playground (G): the same agents a\
nd actions under any rules",onclick:()=>du(n(),e)},"What if?")}function du(n,e){let t=n!==null&&n.match.n_agents<=wr&&Math.max(n.match.config.rows,n.match.config.
cols)<=br,r=t?d("script",{type:"text/plain",id:"scene"},qa(mu(n.match,n.step),e)).outerHTML:"",s=new TextDecoder().decode(Dr("playground")).replace(hu,()=>we("s\
cript-engine")).replace("</noscript>",i=>i+r+(t?Va(n.champions):"")),o=d("iframe",{title:"Playground",srcdoc:s}),a=d("dialog",{class:"what-if","aria-label":"Wha\
t if?",onclose:()=>a.remove()},d("button",{type:"button",class:"leave",onclick:()=>a.close()},"Back to the match"),o);document.body.append(a),a.showModal()}function mu(n,e){
let{config:t,n_agents:r}=n,s=Math.max(0,e-1),o=i=>{let l=s*r+i,c=s*t.n_evaders+i-t.n_pursuers,u=h=>i>=t.n_pursuers&&!!h[c];return{cell:[n.last_positions[2*l],n.
last_positions[2*l+1]],gone:!n.alive[l],captured:u(n.captured),everCaptured:u(n.ever_captured)}},a=Array.from({length:r},(i,l)=>o(l));return{rules:t.rules,others:null,
rewards:t.rewards,rows:t.rows,cols:t.cols,diagonal:t.diagonal,fov:t.fov,maxSteps:t.max_steps,seed:n.seed,episode:BigInt(n.episode),steps:s,ended:s===n.length,walls:Array.
from(n.map.keys()).filter(i=>n.map[i]),pursuers:a.slice(0,t.n_pursuers),evaders:a.slice(t.n_pursuers),played:[],next:Array.from(n.actions.subarray(s*r,(s+1)*r))}}var pu=60,jn=class{element;player=new Ie(0,{speed:On,still:Te()});inspector;match=null;recording=null;inputs=null;actions;#e;#n;#t;#r;#a=d("h2",{class:"match-ti\
tle"});#o=d("p",{class:"tally numbers"});#h=d("ol",{class:"words",tabindex:0,"aria-live":"off","aria-label":"What happened in this step"});#m=d("p",{class:"prob\
lem",role:"alert"});#p=d("div",{class:"signs"});#g=d("div",{class:"shown","aria-live":"polite"});#d=null;#y=null;#s=0;#l=!1;#i=0;#f=[];constructor(e,t,r){this.#n=
e,this.#t=t;let s=d("canvas",{"aria-label":"The match",onclick:({clientX:o,clientY:a})=>this.#E(o,a),onpointermove:({clientX:o,clientY:a,pointerType:i})=>i==="m\
ouse"&&this.#C(o,a),onpointerleave:()=>this.inspector.point(null,null)});this.#e=new $e(s,{numbers:!1}),this.#r=new Bn(t),this.inspector=new it(o=>this.#O(o),o=>this.#e.
look={inputs:this.inputs=o}),this.actions=d("div",{class:"match-actions"},d("button",{type:"button",class:"to-play",title:"Move the chosen agent, or an evader, \
yourself from this step on (T)",onclick:()=>this.element.dispatchEvent(new Event("takeover"))},"Take over"),r&&Ja(()=>this.shown,r)),this.element=d("section",{class:"\
card match-card","aria-label":"Match",id:"match"},d("div",{class:"match"},d("header",{class:"match-head"},this.#a,this.#o),this.#m,this.#g,d("div",{class:"stage"},
s),d("div",{class:"aside"},this.#h,Qt(),this.#p,this.actions,this.inspector.element),_n(this.player),this.#r.element)),this.player.addEventListener("frame",()=>this.
recording&&this.#e.show(this.recording,this.player.time)),this.player.addEventListener("step",()=>this.#T()),t.on("match",()=>this.#b()),this.#A(),this.#M(0,0)}get#c(){
return this.#n[this.#t.selected.run]}reveal(){(this.#c.game?this.#g:this.#e.canvas).scrollIntoView({block:"nearest"})}get shown(){return this.match&&this.#y&&{match:this.
match,step:this.player.step,champions:this.#y}}start(e){this.#d=e,this.#v()}playSoon(){this.#l=!0,this.#s||this.#w()}goTo(e){this.#i=e,!this.#s&&this.match&&this.#v()}#w(){
!this.#l||!this.match||(this.#l=!1,this.player.jump(0),Te()||this.player.play())}#b(){this.#A(),clearTimeout(this.#s),this.#s=setTimeout(()=>this.#v(),pu)}#v(){
clearTimeout(this.#s),this.#s=0,this.player.pause(),this.#A();let{selected:e}=this.#t,{game:t}=this.#c;if(this.#g.replaceChildren(...t?Ha(this.#c,t,e,this.#t):[]),
t){this.match=this.recording=null,this.#l=!1,this.#S(e);return}let r=T.map(a=>xo(this.#c,a,e[a])).find(Boolean)??"";if(this.#m.textContent=r,r||!this.#d)return;
this.match=Mo(this.#d,this.#c,e);let[s,o]=this.names(e);this.#y={pursuer:{name:s,policy:_e(this.#c,"pursuer",e.pursuer)},evader:{name:o,policy:_e(this.#c,"evade\
r",e.evader)}},this.recording=tn(this.match),this.#r.show(this.#c,this.match),this.inspector.show(this.#d,this.#c,this.match,e),this.player.length=this.match.length,
this.player.marks=vn(this.recording),this.#f=this.player.ticks=[],this.player.jump(this.#i),this.#i=0,this.#T(),this.#x(this.#d,this.match),this.#S(e),this.#w()}#u(){
let{teams:e,world:t}=this.#c,r=T.flatMap(o=>{let{policy:a}=e[o];return a&&a.kind!=="cells"?a.inputs:[]}),s=t!==null&&t.rules.interaction!=="SIMULTANEOUS";return ha(
[...new Set(r)],s)}#S({run:e,pursuer:t,evader:r,episode:s,seed:o}){this.element.dataset.played=`${e} ${t} ${r} ${s} ${o??""}`}async#x(e,t){let r=await $n(e,t.config);
if(this.match!==t||!r)return;let s=e.world(t.config);t.seek(s,0),this.#f=In(r,s,fu(t)),s.free(),this.player.ticks=Nn(this.#f),this.inspector.solution=r,this.#T()}names({
run:e,pursuer:t,evader:r}){let s=this.#n[e],{teams:o}=s;return[o.pursuer.script??te(s,"pursuer",t),o.evader.script??te(s,"evader",r)]}#A(){let{episode:e,seed:t}=this.#t.
selected,{game:r,payoff:s}=this.#c;this.element.classList.toggle("of-own-game",!!r),this.element.classList.toggle("of-ratings",T.some(l=>So(this.#c,l))),this.#p.
replaceChildren(...this.#u());let[o,a]=this.names(this.#t.selected),i=t===null?e<s.episodes?`episode ${e+1} of ${s.episodes}`:`episode ${e+1}, not part of the c\
ell`:`seed ${t}`;this.#a.replaceChildren(d("span",{class:"pursuer"},Dn(o))," against ",d("span",{class:"evader"},a),r?"":d("span",{class:"muted small"},i))}#T(){
let e=this.match;if(!e||!this.recording)return;let t=this.player.step,r=this.recording.moments[t];this.#M(Array.from(r.everCaptured).filter(Boolean).length,t),this.#h.
replaceChildren(...this.#f.filter(s=>s.step===t).map(s=>d("li",{class:`loss-${s.team}`},kt(s))),...Pn(e,this.recording,t).map(s=>d("li",{class:s.kind,"data-agen\
ts":s.agents.join(" ")},s.text))),this.inspector.at(t),this.#k()}#M(e,t){let{world:r}=this.#c;r&&this.#o.replaceChildren(d("strong",{},e),` of ${r.n_evaders} ca\
ptured`,d("span",{class:"muted"},` · step ${t}`))}#E(e,t){let r=this.#e.agentAt(e,t),s=this.#e.cellAt(e,t);r===null&&s&&this.inspector.askTo(s)||this.inspector.
choose(r)}#C(e,t){this.inspector.point(this.#e.cellAt(e,t),this.#e.agentAt(e,t))}#O(e){this.#e.look={selected:e,viewers:e===null?[]:[e]},this.#k()}#k(){let e=this.
inspector.agent;for(let t of this.#h.children){let r=t.dataset.agents?.split(" ")??[];t.classList.toggle("about",e!==null&&r.includes(String(e)))}}},fu=({actions:n,
length:e,n_agents:t})=>Array.from({length:e},(r,s)=>n.subarray(s*t,(s+1)*t));var yu={ArrowUp:[1,0],ArrowDown:[-1,0],ArrowRight:[0,1],ArrowLeft:[0,-1]},gu=5;function Xa(n,e,t,r="pursuer"){n.tabIndex=0,n.setAttribute("role","application"),
n.addEventListener("keydown",s=>{let o=yu[s.key];if(!o)return;let[a,i]=r==="pursuer"?o:[o[1],o[0]],[l,c]=t(),u=s.shiftKey?gu:1,{pursuer:h,evader:m}=e.selected;e.
select({pursuer:Za(h+u*a,l),evader:Za(m+u*i,c)}),s.preventDefault(),s.stopPropagation()})}var Za=(n,e)=>Math.min(e-1,Math.max(0,n));var $t=[[68,1,84],[72,26,108],[71,47,125],[65,68,135],[57,86,140],[49,104,142],[42,120,142],[35,136,142],[31,152,139],[34,168,132],[53,183,121],[84,197,104],[122,
209,81],[165,219,54],[210,226,27],[253,231,37]];function Gn(n){let e=Math.min(1,Math.max(0,n))*($t.length-1),t=Math.min($t.length-2,Math.floor(e)),r=$t[t],s=$t[t+
1],o=a=>Math.round(r[a]+(e-t)*(s[a]-r[a]));return[o(0),o(1),o(2)]}function Qa(n){let[e,t,r]=Gn(n).map(s=>((s/255+.055)/1.055)**2.4);return .2126*e+.7152*t+.0722*
r>.179?"#000":"#fff"}var ei=n=>`rgb(${Gn(n).join(" ")})`,ti=()=>`linear-gradient(to right, ${$t.map(n=>`rgb(${n.join(" ")})`).join(", ")})`;function ni(n,e,t){let r=devicePixelRatio||1;for(let[a,i]of Object.entries(t))n.style.setProperty(a,`${i}px`);n.width=Math.round(t.width*r),n.height=Math.round(
t.height*r);let s=n.getContext("2d"),o=vu(e);!s||!o||(s.imageSmoothingEnabled=!1,s.drawImage(o,0,0,n.width,n.height))}function vu(n){let[e,t]=n.shape,r=document.
createElement("canvas");r.width=t,r.height=e;let s=r.getContext("2d");if(!s)return null;let o=s.createImageData(t,e);return n.capture_rate.forEach((a,i)=>a.forEach(
(l,c)=>{let u=4*((e-1-i-n.first[0])*t+c+n.first[1]);o.data.set([...Gn(l),255],u)})),s.putImageData(o,0,0),r}function ri(n,e,t,r=2){n.textContent=q(e,r),n.ariaLabel=
`${t}: ${n.textContent}`,e!==void 0&&(n.style.backgroundColor=ei(e),n.style.color=Qa(e))}function ns(n,e){let t=d("span",{class:"gradient"});return t.style.backgroundImage=
ti(),d("p",{class:"scale-of-rates small muted"},n,t,e)}var bu=24,zn=7,oi=n=>n<bu&&matchMedia("(pointer: coarse)").matches;function ai(n,e,t,r){let[s,o]=n.payoff.shape,a=si(e,s),i=si(t,o),l=Math.min(zn,s),c=Math.min(
zn,o),u=[];for(let f=a+l-1;f>=a;f--){u.push(d("span",{class:"pursuer"},f));for(let g=i;g<i+c;g++)u.push(wu(n,f,g,r))}let h=Array.from({length:c},(f,g)=>d("span",
{class:"evader"},i+g)),m=d("button",{type:"button","aria-label":"Close: all cells",onclick:()=>r(null)},"✕"),y=d("div",{class:"loupe numbers",role:"group","ar\
ia-label":"Cells around the tap",onclick:f=>f.stopPropagation()},...u,m,...h);return y.style.gridTemplateColumns=`2.4rem repeat(${c}, minmax(0, 1fr))`,y}function wu(n,e,t,r){
let s=d("button",{type:"button",onclick:()=>r({pursuer:e,evader:t})});return ri(s,Pe(n,e,t)?.rate,`${te(n,"pursuer",e)} against ${te(n,"evader",t)}`),s}var si=(n,e)=>Math.
max(0,Math.min(e-zn,n-Math.floor(zn/2)));var ue={left:52,bottom:46,top:76,right:84},xe=10,xu=160,It=ue.right-xe-14,je=ue.top-xe-14,Hn=class{element;#e;#n;#t=d("canvas",{"aria-hidden":"true"});#r=M("svg",
{"aria-hidden":"true"});#a=M("g");#o;#h=d("h2");#m=d("strong",{class:"rate numbers"});#p=d("span",{class:"small muted"});#g=d("p",{class:"of-both-teams small mu\
ted numbers"});#d;#y=null;constructor(e,t){this.#n=e,this.#e=t,this.#o=d("div",{class:"matrix",id:"matrix","aria-label":"Payoff matrix. Arrow keys choose a matc\
h, Enter plays it.",onpointermove:s=>this.#u(s),onpointerleave:()=>t.point({}),onclick:s=>this.#S(s),onkeydown:({key:s})=>s==="Enter"&&this.#A()},this.#t,this.#r);
let r=d("header",{class:"readout","aria-live":"polite"},d("div",{},this.#h,this.#g),d("div",{class:"of-cell"},this.#m,this.#p));this.#d=ns(...Re(this.#s).ends),
this.element=d("section",{class:"card matrix-card","aria-label":"Payoff matrix"},r,this.#o,this.#d),this.#w(),new ResizeObserver(()=>this.#l()).observe(this.#o),
this.#o.addEventListener("mousedown",s=>{s.preventDefault(),document.activeElement instanceof HTMLElement&&document.activeElement.blur()}),Xa(this.#o,t,()=>this.#s.
payoff.shape),t.on("run",()=>{let s=ns(...Re(this.#s).ends);this.#d.replaceWith(s),this.#d=s,this.#l()}),t.on("match hover",()=>this.#c())}get#s(){return this.#n[this.#e.
selected.run]}#l(){let[e,t]=this.#s.payoff.shape,{clientWidth:r,clientHeight:s}=this.#o;if(r<50)return;let a=Math.max(xu,Math.min(r-ue.left-ue.right,s-ue.top-ue.
bottom))/Math.max(e,t),i=Math.max(ue.left,(r-t*a-ue.right+ue.left)/2),l=ue.top+Math.max(0,(s-ue.top-ue.bottom-e*a)/2),c={width:r,height:s,left:i,top:l,cell:a,rows:e,
columns:t};this.#y=c,ni(this.#t,this.#s.payoff,{left:i,top:l,width:t*a,height:e*a});for(let[u,h,m]of[["left",i,r],["top",l,s],["width",t*a,r],["height",e*a,s]])
this.#t.style.setProperty(u,`${100*h/m}%`);this.#o.style.setProperty("--shape",`${r} / ${s}`),this.#r.setAttribute("viewBox",`0 0 ${r} ${s}`),this.#r.replaceChildren(
Su(c,Re(this.#s).generation),...Au(c),...this.#f(c),this.#a),this.#c()}#i(e){let t=this.#s.findings?.generalization;if(!t)return[];let{selected:r,hover:s}=this.#e,
o=s.pursuer??r.pursuer,a=s.evader??r.evader,[i,l]=ii(e,t.pursuers.mean[o]??0,o),[c,u]=li(e,t.evaders.mean[a]??0,a);return[M("circle",{class:"dot of-pursuers",cx:i,
cy:l,r:5}),M("circle",{class:"dot of-evaders",cx:c,cy:u,r:5})]}#f(e){let t=this.#s.findings?.generalization;if(!t)return[];let{left:r,top:s,cell:o,rows:a,columns:i}=e,
{curves:l}=Re(this.#s),c=r+i*o+xe,u=s-xe,h={class:"side"};return[M("rect",{...h,x:c,y:s,width:It,height:a*o}),M("rect",{...h,x:r,y:u-je,width:i*o,height:je}),...ci(
t.pursuers,(m,p)=>ii(e,m,p),"of-pursuers"),...ci(t.evaders,(m,p)=>li(e,m,p),"of-evaders"),M("text",{class:"tick",x:c,y:s+a*o+16,"text-anchor":"start"},"0"),M("t\
ext",{class:"tick",x:c+It,y:s+a*o+16,"text-anchor":"end"},"1"),M("text",{class:"tick",x:r-6,y:u-4,"text-anchor":"end"},"0"),M("text",{class:"tick",x:r-6,y:u-je+
8,"text-anchor":"end"},"1"),M("text",{class:"label of-pursuers",x:c+It,y:s+a*o+34,"text-anchor":"end"},l.pursuer),M("text",{class:"label of-evaders",x:r+i*o+xe,
y:u-je+10,"text-anchor":"start"},l.evader)]}#c(){let e=this.#y;if(!e)return;let{selected:t,hover:r}=this.#e,{left:s,top:o,cell:a,rows:i,columns:l}=e,c=y=>o+(i-1-
y)*a,u=[],h=(y,f)=>M("rect",{class:f,x:s,y:c(y),width:l*a+xe+It,height:a}),m=(y,f)=>M("rect",{class:f,x:s+y*a,y:o-xe-je,width:a,height:xe+je+i*a});u.push(h(t.pursuer,
"strip pursuer"),m(t.evader,"strip evader")),r.pursuer!==null&&r.pursuer<i&&u.push(h(r.pursuer,"strip hover")),r.evader!==null&&r.evader<l&&u.push(m(r.evader,"s\
trip hover")),u.push(...this.#i(e));let p={x:s+t.evader*a,y:c(t.pursuer),width:a,height:a};u.push(M("rect",{class:"chosen under",...p}),M("rect",{class:"chosen",
...p})),this.#a.replaceChildren(...u),this.#w()}#w(){let{selected:e,hover:t}=this.#e,r=t.pursuer??e.pursuer,s=t.evader??e.evader,o=Pe(this.#s,r,s);this.#h.replaceChildren(
d("span",{class:"pursuer"},Dn(te(this.#s,"pursuer",r)))," against ",d("span",{class:"evader"},te(this.#s,"evader",s))),this.#m.textContent=o?q(o.rate,3):"-";let a=o&&
o.rates.length>1?`, mean of ${o.rates.length} episodes`:"";this.#p.textContent=o?Re(this.#s).score+a:"no episodes were played",this.#g.textContent=this.#b(r,s)}#b(e,t){
let r=this.#s.findings?.generalization;if(!r)return"";let s=(a,i)=>$a(a.mean[i]??null,a.low?.[i]??null,a.high?.[i]??null),{means:o}=Re(this.#s);return`Against a\
ll: ${o.pursuer} ${s(r.pursuers,e)}, ${o.evader} ${s(r.evaders,t)}`}#v(e){let t=this.#y;if(!t)return null;let r=this.#o.getBoundingClientRect(),s=Math.floor((e.
clientX-r.left-t.left)/t.cell),o=t.rows-1-Math.floor((e.clientY-r.top-t.top)/t.cell),a=o>=0&&o<t.rows,i=s>=0&&s<t.columns;return a||i?{g:a?o:-1,h:i?s:-1,inside:a&&
i}:null}#u(e){let t=this.#v(e);this.#e.point(t?{pursuer:t.g<0?null:t.g,evader:t.h<0?null:t.h}:{})}#S(e){let t=this.#v(e);if(t){if(t.inside&&oi(this.#y.cell))return this.#x(
t.g,t.h);this.#e.select({...t.g<0?{}:{pursuer:t.g},...t.h<0?{}:{evader:t.h}}),t.inside&&this.#A()}}#x(e,t){let r=ai(this.#s,e,t,s=>{r.remove(),s&&(this.#e.select(
s),this.#A())});this.#o.append(r)}#A(){this.#o.dispatchEvent(new CustomEvent("play",{bubbles:!0}))}};function Su({left:n,top:e,cell:t,rows:r,columns:s},o){let a=M(
"g",{class:"axes"}),i=e+r*t,l=c=>_t(0,c-1,Math.min(c,c*t/44),!0);for(let c of l(s))a.append(M("text",{class:"tick",x:n+(c+.5)*t,y:i+16,"text-anchor":"middle"},c));
for(let c of l(r))a.append(M("text",{class:"tick",x:n-7,y:i-(c+.5)*t,"text-anchor":"end","dominant-baseline":"middle"},c));return a.append(M("text",{class:"labe\
l of-evaders",x:n+s*t/2,y:i+36,"text-anchor":"middle"},o.evader),M("text",{class:"label of-pursuers",transform:`translate(${n-36} ${e+r*t/2}) rotate(-90)`,"text\
-anchor":"middle"},o.pursuer)),a}function Au({left:n,top:e,cell:t,rows:r,columns:s}){let o=M("g",{class:"diagonal"}),a=Math.min(r,s);if(a<3)return[];let i=e+r*t;
for(let u of["H","V"]){let h=`M${n} ${i}`;for(let m=1;m<=a;m++){let p=`H${n+m*t}`,y=`V${i-m*t}`;h+=u==="H"?p+y:y+p}o.append(M("path",{d:h,class:"under"}),M("pat\
h",{d:h}))}let l=n+a/2*t-.7*t-4,c=i-a/2*t-.7*t-4;return[o,M("text",{class:"on-cells",transform:`translate(${l} ${c}) rotate(-45)`,"text-anchor":"middle"},"same \
generation")]}var ii=({left:n,top:e,cell:t,rows:r,columns:s},o,a)=>[n+s*t+xe+o*It,e+(r-a-.5)*t],li=({left:n,top:e,cell:t},r,s)=>[n+(s+.5)*t,e-xe-r*je];function ci(n,e,t){
let r=o=>o.map((a,i)=>e(a??0,i).map(l=>l.toFixed(1)).join(" ")),s=[];return n.low&&n.high&&s.push(M("path",{class:`band ${t}`,d:`M${[...r(n.high),...r(n.low).reverse()].
join("L")}Z`})),s.push(M("path",{class:`line ${t}`,d:`M${r(n.mean).join("L")}`})),s}var ui={pursuer:null,evader:null},Vn=class extends EventTarget{#e;#n=ui;constructor(e){super(),this.#e=e}get selected(){return this.#e}get hover(){return this.#n}select(e){
let t=this.#e,r=["run","pursuer","evader"].some(s=>s in e&&e[s]!==t[s]);this.#e={...t,...r?{episode:0,seed:null}:{},...e},this.#e.run!==t.run&&this.dispatchEvent(
new Event("run")),this.dispatchEvent(new Event("match"))}point(e){let t={...ui,...e};t.pursuer===this.#n.pursuer&&t.evader===this.#n.evader||(this.#n=t,this.dispatchEvent(
new Event("hover")))}on(e,t){for(let r of e.split(" "))this.addEventListener(r,t)}};var Mu=8,Tu=900,hi=1800,Nt=class extends EventTarget{element;player=new Ie(0,{speed:Mu,still:Te()});match=null;agent=null;#e=d("figcaption");#n=d("canvas",{onclick:({
clientX:e,clientY:t})=>this.#m(e,t)});#t;#r=d("p",{class:"small muted numbers"});#a=d("p",{class:"small",role:"status"});#o=null;#h=!1;constructor(){super(),this.#t=
new $e(this.#n,{numbers:!1}),this.element=d("figure",{class:"chase"},this.#e,this.#n,this.#r,this.#a),this.player.addEventListener("frame",()=>this.#p()),this.player.
addEventListener("step",()=>this.#g()),this.player.addEventListener("state",()=>this.over&&this.dispatchEvent(new Event("over")))}get over(){return this.player.
length>0&&!this.player.playing&&this.player.step===this.player.length}get title(){return this.#e.textContent}get recording(){return this.#o}show(e,t){this.match=
e,this.#o=tn(e),this.#e.textContent=t,this.#n.ariaLabel=`A match. ${t}`,this.player.jump(0),this.player.length=e.length,this.player.marks=vn(this.#o),this.#g()}choose(e){
this.agent=e,this.#t.look={selected:e,viewers:e===null?[]:[e]},this.dispatchEvent(new Event("agent"))}#m(e,t){this.#h||this.choose(this.#t.agentAt(e,t))}#p(){this.#o&&
this.#t.show(this.#o,this.player.time)}#g(){let e=this.#o?.moments[this.player.step]?.everCaptured;e&&(this.#r.textContent=`${Array.from(e).filter(Boolean).length}\
 of ${e.length} caught in ${this.player.step} steps`),this.dispatchEvent(new Event("step"))}drawWalls(e){let t=!1,r=!0,s=[0,0],o=([l,c])=>!!this.#o?.obstacles[l*
this.#o.cols+c],a=(l,c)=>{this.#a.textContent=e(l,c)},i=l=>{let c=this.#t.cellAt(l.clientX,l.clientY);c&&o(c)!==r&&a(c,r)};return this.#n.addEventListener("poin\
terdown",l=>{let c=t&&this.#t.cellAt(l.clientX,l.clientY);c&&(this.#n.setPointerCapture(l.pointerId),r=!o(c),i(l))}),this.#n.addEventListener("pointermove",l=>t&&
l.buttons&&i(l)),this.#n.addEventListener("keydown",l=>{let c={ArrowUp:[-1,0],ArrowDown:[1,0],ArrowLeft:[0,-1],ArrowRight:[0,1]}[l.key];if(!t||!this.#o||!(c||l.
key===" "))return;l.preventDefault();let u=(p,y)=>Math.min(y-1,Math.max(0,p)),{rows:h,cols:m}=this.#o;c?s=[u(s[0]+c[0],h),u(s[1]+c[1],m)]:a(s,!o(s)),this.#t.look=
{cursor:s}}),l=>{t=this.#h=l,this.#n.classList.toggle("drawn-on",l),this.#n.tabIndex=l?0:-1,this.#n.setAttribute("role",l?"application":"img"),this.#t.look={cursor:null}}}showWalls(e){
this.#o&&(this.#o={...this.#o,obstacles:e},this.#p())}},Yn=class{boards;#e;#n=-1/0;#t=0;#r=!Te();constructor(e,...t){this.#e=e,this.boards=t;for(let r of t)r.addEventListener(
"over",()=>this.#r&&t.every(({over:s})=>s)&&this.#a(Tu))}get runs(){return this.#r}set runs(e){this.#r=e,clearTimeout(this.#t),this.#t=0;for(let{player:t}of this.
boards)e?t.play():t.pause()}renew(e=!1){e||performance.now()-this.#n>hi?this.#o():this.#t||this.#a(hi)}#a(e){clearTimeout(this.#t),this.#t=setTimeout(()=>this.#o(),
e)}#o(){if(clearTimeout(this.#t),this.#t=0,this.#n=performance.now(),this.#e(),this.#r)for(let{player:e}of this.boards)e.play()}};var O=n=>Array.from(n).reduce((e,t)=>e+t,0)/n.length,rs=(n,e)=>e==="pursuer"?n:n[0].map((t,r)=>n.map(s=>1-s[r]));var di=-12676506002282294e14,mi=({hidden:n,mask:e})=>n.map(t=>t+(e?4:0));function Lt(n){let e=[3*n.fov**2,...mi(n),5],t=0;return e.slice(1).map((r,s)=>{let o={at:t,
inputs:e[s],outputs:r};return t+=(o.inputs+1)*r,o})}function Ee(n){if(n.kind==="rating")return n.inputs.length;let{at:e,inputs:t,outputs:r}=Lt(n).at(-1);return e+
(t+1)*r}var Ft=(n,e)=>n.kind==="rating"?{...n,genome:e}:{kind:"cells",hidden:mi(n),activation:"relu",sampled:!0,memory:"none",genome:e};function pi(n,e,t){let r=t.
initial_weight;if(n.kind==="rating"||t.kind==="rating")return e.normals(Ee(n)).map(i=>Math.fround(r)*i);let s=t.initial_head,o=new Float32Array(Ee(n)),a=Lt(n);return a.
forEach(({at:i,inputs:l,outputs:c},u)=>{let h=Math.fround(u===a.length-1?s:r);e.normals(l*c).forEach((m,p)=>o[i+p]=h*m)}),o}function ss(n){if(n.kind==="rating")
return null;let{fov:e,mask:t}=n;if(!t)return null;let r=new Uint8Array(Ee(n)),s=new Float32Array(Ee(n)),o=Lt(n),a=o.length-1,i=Math.floor(e/2);return o.forEach(
({at:l,inputs:c,outputs:u},h)=>{let m=(p,y)=>l+p*u+y;for(let p=0;p<4;p++)if(h>0&&r.fill(1,m(c-4+p,0),m(c-4+p+1,0)),h<a)for(let y=0;y<=c;y++)r[m(y,u-4+p)]=1;t.forEach(
(p,y)=>{let f=h===a?1+y:u-4+y,g=h===0?p.map(([v,w,x])=>(v*e+i+w)*e+i+x):[c-4+y];for(let v of g)r[m(v,f)]=1,s[m(v,f)]=h===a?di:1})}),{fixed:r,values:s}}function os(n,e){
return e?n.map((t,r)=>e.fixed[r]?e.values[r]:t):n}function fi(n,e,t){if(e.kind==="rating"||t.kind==="rating")return n;let r=new Float32Array(Ee(t)),s=Lt(e),o=Lt(
t),a=Math.floor(t.fov/2)-Math.floor(e.fov/2),i=c=>c>=0&&c<t.fov,l=c=>{let u=Math.floor(c/e.fov**2),h=Math.floor(c/e.fov)%e.fov+a,m=c%e.fov+a;return i(h)&&i(m)?(u*
t.fov+h)*t.fov+m:-1};return s.forEach((c,u)=>{let h=o[u],m=e.hidden[u]??5;for(let p=0;p<(u?e.hidden[u-1]:c.inputs);p++){let y=u?p:l(p);if(!(y<0))for(let f=0;f<m;f++)
r[h.at+y*h.outputs+f]=n[c.at+p*c.outputs+f]}for(let p=0;p<m;p++)r[h.at+h.inputs*h.outputs+p]=n[c.at+c.inputs*c.outputs+p]}),os(r.map(c=>c<=di/2?0:c),ss(t))}var bi={initial:1,noise:2,learn:3,opponents:4},is={pursuer:1,evader:2,both:3},Ge=4,as=2n**32n;function yi(n){let e=[],t=BigInt(n);do e.push(Number(t%as)),t/=as;while(t>
0n);return e}function gi(n,e){let t=n;return r=>{let s=r^t;return t=Math.imul(t,e),s=Math.imul(s,t),s^s>>>16}}function vi(n,e){let t=Math.imul(3389127133,n)-Math.
imul(1232336661,e)|0;return t^t>>>16}function ls(n,e,t){let r=n.flatMap(yi);if(e.length){for(;r.length<Ge;)r.push(0);r.push(...e.flatMap(yi))}let s=gi(1135663077,
2468251765),o=Array.from({length:Ge},(i,l)=>s(r[l]??0));for(let i=0;i<Ge;i++)for(let l=0;l<Ge;l++)i!==l&&(o[l]=vi(o[l],s(o[i])));for(let i of r.slice(Ge))for(let l=0;l<
Ge;l++)o[l]=vi(o[l],s(i));let a=gi(2337405405,1492356589);return Uint32Array.from({length:t},(i,l)=>a(o[l%Ge]))}function Dt(n,e){let t=ls(n,[],2*e);return BigUint64Array.
from({length:e},(r,s)=>BigInt(t[2*s])+as*BigInt(t[2*s+1]))}var Kn=(n,e,t)=>Dt([n,e,t],1)[0];var wi=n=>(e,...t)=>new cs(ls([n],[bi[e],...t],3)),cs=class{#e;#n;#t;#r=1;constructor(e){this.#e=e[0],this.#n=e[1],this.#t=e[2];for(let t=0;t<12;t++)this.#a()}#a(){
let e=this.#e+this.#n+this.#r++|0;return this.#e=this.#n^this.#n>>>9,this.#n=this.#t+(this.#t<<3)|0,this.#t=(this.#t<<21|this.#t>>>11)+e|0,e>>>0}#o(){return(this.#a()+
.5)/2**32}normals(e){let t=new Float32Array(e);for(let r=0;r<e;r+=2){let s=Math.sqrt(-2*Math.log(this.#o())),o=2*Math.PI*this.#o();t[r]=s*Math.cos(o),r+1<e&&(t[r+
1]=s*Math.sin(o))}return t}integers(e,t){return Int32Array.from({length:t},()=>Math.floor(this.#o()*e))}permutation(e){return this.choice(e,e)}choice(e,t){let r=Int32Array.
from({length:e},(s,o)=>o);for(let s=0;s<t;s++){let o=s+Math.floor(this.#o()*(e-s));[r[s],r[o]]=[r[o],r[s]]}return r.slice(0,t)}};var N=Math.fround,Eu=5,Cu=256,qn=class{size;sigma;fixed;#e;constructor(e,t,r,s){this.size=e,this.sigma=r,this.fixed=s,this.#e=t.normals((1+Cu)*e);for(let o=0;o<
this.#e.length;o++)this.#e[o]*=N(r)}draw(e,t){let r=t.integers(this.#e.length-this.size+1,e);return Array.from(r,s=>{let o=this.#e.subarray(s,s+this.size);return this.
fixed?o.map((a,i)=>this.fixed[i]?0:a):o})}},us=class{#e;#n;#t=0;constructor(e){this.#e=new Float32Array(e),this.#n=new Float32Array(e)}moved(e,t,r){let a=N(1e-8);
this.#t+=1;let i=N(1-.9),l=N(1-.999),c=N(1-.9**this.#t),u=N(1-.999**this.#t);return e.map((h,m)=>{let p=t[m],y=this.#e[m]+=N(i*N(p-this.#e[m])),f=this.#n[m]+=N(
l*N(N(p*p)-this.#n[m])),g=N(N(Math.sqrt(N(N(f)/u)))+a);return N(h+N(N(N(r)*N(N(y)/c))/g))})}};function Ou(n){let e=Array.from(n).sort((t,r)=>t-r);return n.map(t=>(e.
indexOf(t)+e.lastIndexOf(t))/(2*(n.length-1))-.5)}var Jn=class{genome;groups;#e;#n;#t;#r=[];constructor(e,t,r){this.genome=e,this.#n=t,this.#e=r,this.#t=new us(
e.length),this.groups=Int32Array.from({length:r.population},(s,o)=>o%(r.population/2))}get#a(){let{sigma:e,fixed:t}=this.#n,r=0,s=0;return this.genome.forEach((o,a)=>{
t?.[a]||(r+=o*o,s+=1)}),Math.max(e,this.#e.relative_sigma*Math.sqrt(r/s))}ask(e){let t=this.#e.population/2,r=this.genome.length;this.#r=this.#n.draw(t,e);let s=N(
this.#a/this.#n.sigma),o=new Float32Array(2*t*r);return this.#r.forEach((a,i)=>{for(let l=0;l<r;l++){let c=N(s*a[l]);o[i*r+l]=this.genome[l]+c,o[(t+i)*r+l]=this.
genome[l]-c}}),o}tell(e){let t=Ou(e),r=this.#r.length,s=new Float32Array(this.genome.length);this.#r.forEach((o,a)=>{let i=N((t[a]-t[r+a])/(2*r*this.#n.sigma**2));
for(let l=0;l<s.length;l++)s[l]+=N(i*o[l])}),this.genome=this.#t.moved(this.genome,s,this.#e.learning_rate)}},Ut=class{population;groups;#e;#n;#t=new Float64Array(
0);#r=0;constructor(e,t,r){this.population=e,this.#n=t,this.#e=r,this.groups=new Int32Array(r.population)}get genome(){return this.#a(this.#r).slice()}#a(e){let{
size:t}=this.#n;return this.population.subarray(e*t,(e+1)*t)}#o(e,t){let r=this.#e.tournament??Eu,s=t.integers(this.#t.length,e*r);return Array.from({length:e},
(o,a)=>s.subarray(a*r,(a+1)*r).reduce((i,l)=>this.#t[l]>this.#t[i]?l:i))}ask(e){if(!this.#t.length)return this.population;let{size:t}=this.#n,{population:r,elites:s}=this.#e,
o=r-s,a=this.#o(o,e);this.#o(o,e);let i=Array.from(this.#t.keys()).sort((c,u)=>this.#t[u]-this.#t[c]).slice(0,s),l=new Float32Array(this.population.length);return[
...i,...a].forEach((c,u)=>l.set(this.#a(c),u*t)),this.#n.draw(o,e).forEach((c,u)=>{let h=(s+u)*t;for(let m=0;m<t;m++)l[h+m]+=c[m]}),this.population=l,l}tell(e){
this.#t=e,this.#r=e.indexOf(Math.max(...e))}};function xi(n,e,t,r){let s=n.length,o=Math.max(...n)+1,a=o>1?s/o:1,i=Array.from(n.keys()).sort((h,m)=>n[h]-n[m]),l=[],c=[];for(let h=0;h<e;h++){let m=h%a;m===0&&
(c=Array.from(r.permutation(s/a)).flatMap(p=>i.slice(p*a,(p+1)*a))),l.push([i,c.map((p,y)=>c[y-y%a+(y%a-m+a)%a])])}let u=h=>i.map(()=>s+h);for(let h=0;h<t[1];h++)
l.push([i,u(h)]);for(let h=0;h<t[0];h++)l.push([u(h),i]);return{pursuer:Int32Array.from(l.flatMap(([h])=>h)),evader:Int32Array.from(l.flatMap(([,h])=>h)),group:Int32Array.
from(l.flatMap((h,m)=>i.map(p=>m*o+n[p])))}}function Si(n,e,t,r){let s=Math.max(...e)+1,o=new Float64Array(t*s),a=new Float64Array(t*s);r.forEach((l,c)=>{if(n[c]>=
t)return;let u=n[c]*s+e[c];o[u]+=l,a[u]+=1});let i=o.map((l,c)=>a[c]?l/a[c]:0);return Float64Array.from({length:t},(l,c)=>{let u=i.subarray(c*s,(c+1)*s);return hs(
u)/a.subarray(c*s,(c+1)*s).filter(Boolean).length})}var ku=128,lt=8;function hs(n){let{length:e}=n;if(e>ku){let m=Math.floor(e/2)-Math.floor(e/2)%lt;return hs(n.
subarray(0,m))+hs(n.subarray(m))}if(e<lt)return n.reduce((m,p)=>m+p,0);let t=n.slice(0,lt),r=e-e%lt;for(let m=lt;m<r;m++)t[m%lt]+=n[m];let[s,o,a,i,l,c,u,h]=t;return n.
subarray(r).reduce((m,p)=>m+p,s+o+(a+i)+(l+c+(u+h)))}function Ai({inputs:n},e){return(r=>typeof r[0]!="string")(n)?n[e==="pursuer"?0:1]:n}var Ru=.2,Mi=({world:n})=>n.rules.teammate==="REACH"?Ru:0;var Ti=["generation","team","epoch","opponent","fitness_mean","fitness_std","fitness_best","capture_rate","length","pursuer_faults","evader_faults","matches","s\
teps"],Xn={pursuer:["random","clumsy-fleer"],evader:["random","clumsy-chaser"]},_u=20,Pu=8,$u=-1;function ut({world:n,policy:e},t,r){return e.kind==="rating"?{...e,
inputs:Ai(e,r)}:{kind:"cells",fov:n.fov,hidden:e.hidden,mask:e.mask==="none"?null:t[r]}}var ct=class{settings;epochs=0;until=1/0;archive={pursuer:[],evader:[]};rows=[];cells=new Map;counters={
pursuer:[],evader:[]};#e;#n;#t;#r={};#a=new Set;#o={pursuer:0,evader:0};#h=0;#m=0;#p=0;constructor(e,t,r,s=wi(t.seed)){this.#e=e,this.settings=t,this.#n=r,this.#t=
s;for(let o of T){let a=s("initial",T.indexOf(o)),i=t.learner.kind==="ga"?t.learner.population:1,l=Array.from({length:i},()=>pi(this.shape(o),a,t.policy));this.#d(
o,l),this.archive[o].push(this.#r[o].genome)}this.#S(...T)}shape(e){return ut(this.settings,this.#n,e)}get finished(){return Math.min(this.archive.pursuer.length,
this.archive.evader.length)}*run(){this.finished===1&&(yield*this.#x(0));for(let e=this.finished;e<=this.settings.schedule.generations;e++){if(this.settings.schedule.
kind==="alternating")for(let t of T)yield*this.#y(t,e),this.#S(t);else yield*this.#s(e),this.#S(...T);yield*this.#x(e)}}change(e){let t=this.settings,r={pursuer:this.
shape("pursuer"),evader:this.shape("evader")},s=l=>JSON.stringify(l(t))===JSON.stringify(l(e));this.settings=e;let o=s(l=>[l.world.fov,l.policy]);if(!o||!s(l=>l.
learner))for(let l of T){let c=u=>fi(u,r[l],this.shape(l));this.archive[l]=this.archive[l].map(c),this.#d(l,this.#g(l).map(c))}if(o&&s(l=>l.world))return null;this.
cells.clear(),this.#a.clear();let{pursuer:a,evader:i}=this.archive;return{type:"anew",settings:e,genomes:{pursuer:a.slice(0,this.finished),evader:i.slice(0,this.
finished)}}}#g(e){let t=this.#r[e];if(!(t instanceof Ut))return[t.genome];let r=t.genome.length,s=Array.from({length:t.population.length/r},(o,a)=>t.population.
slice(a*r,(a+1)*r));return Array.from({length:this.settings.learner.population},(o,a)=>a===0?t.genome:s[a%s.length])}#d(e,t){let{learner:r}=this.settings,s=this.
shape(e),o=r.kind==="ga"?r.mutation:r.sigma,a=ss(s),i=new qn(Ee(s),this.#t("noise",T.indexOf(e)),o,a?.fixed??null),l=t.map(c=>os(c,a));this.#r[e]=r.kind==="ga"?
new Ut(Zn(l),i,r):new Jn(l[0],i,r)}*#y(e,t){this.#o[e]>=this.archive[le(e)].length-1&&(this.#o[e]=0);for(let r=0;r<this.#f(e);r++){for(;this.epochs>=this.until;)
yield{type:"rest"};let s=this.archive[le(e)].length,o=this.settings.schedule[`${e}s_meet`],a=o==="latest"?s-1:o==="round-robin"?this.#o[e]%s:this.#t("opponents",
T.indexOf(e),t,r).choice(s,1)[0];this.#o[e]++;let i=e==="pursuer"?[t,a]:[a,t],l=this.#r[e],{groups:c}=l,u=Dt([this.settings.seed,...i,is[e],r],Math.max(...c)+1),
h=l.ask(this.#t("learn",T.indexOf(e),t,r)),m=Int32Array.from(c.keys()),p=new Int32Array(c.length),y={[e]:h,[le(e)]:this.archive[le(e)][a]},f={[e]:m,[le(e)]:p},g=this.#w(
y,f,BigUint64Array.from(c,w=>u[w])),v=this.#v(g,e);this.#u(g,v,{generation:t,team:e,epoch:r,opponent:a}),l.tell(v),yield*this.#c(t,r,e)}this.archive[e].push(this.#r[e].
genome)}*#s(e){for(let t=0;t<this.#f("pursuer");t++){for(;this.epochs>=this.until;)yield{type:"rest"};let{schedule:r,learner:{population:s}}=this.settings,[o,a]=r.
kind==="hall-of-fame"?[r.hall_sample,r.contemporaries]:[0,1],i={pursuer:this.#l("pursuer",e,t),evader:this.#l("evader",e,t)},l=this.#t("opponents",0,e,t),c={pursuer:this.#i(
o,l),evader:this.#i(o,l)},u=g=>Zn([i[g],...Array.from(c[le(g)],v=>this.archive[g][v])]),h=[c.evader.length,c.pursuer.length],m=xi(this.#r.pursuer.groups,a,h,l),
p=Dt([this.settings.seed,e,e,is.both,t],Math.max(...m.group)+1),y={pursuer:u("pursuer"),evader:u("evader")},f=this.#w(y,m,BigUint64Array.from(m.group,g=>p[g]));
for(let g of T){let v=Si(m[g],m[le(g)],s,this.#v(f,g));this.#u(f,v,{generation:e,team:g,epoch:t,opponent:$u}),this.#r[g].tell(v)}yield*this.#c(e,t,"both")}for(let t of T)
this.archive[t].push(this.#r[t].genome)}#l(e,t,r){return this.#r[e].ask(this.#t("learn",T.indexOf(e),t,r))}#i(e,t){let r=this.archive.pursuer.length;return e?t.
choice(r,Math.min(e,r)):new Int32Array(0)}#f(e){let{schedule:t}=this.settings;return t.kind==="hall-of-fame"?t.joint_epochs:t[`${e}_epochs`]}*#c(e,t,r){let[s,o]=this.
settings.schedule.kind==="hall-of-fame"?[this.#f("pursuer"),0]:[this.#f("pursuer"),this.#f("evader")],a=t+1+(r==="evader"?s:0),i=s+o;this.epochs+=1,yield{type:"\
epoch",done:(e-1)*i+a,of:this.settings.schedule.generations*i},yield*this.catchUp()}#w(e,t,r){let s={...this.settings.world,max_steps:this.settings.train_steps},
o=this.#e.rollouts(s,this.#b("pursuer",e.pursuer),this.#b("evader",e.evader),{...t,seed:r},1);this.#h+=o.length.length;for(let a of o.length)this.#m+=Number(a);
for(let a of o.agent_steps)this.#p+=Number(a);return o}#b(e,t){return Ft(this.shape(e),t)}#v({captured_fraction:e,overlap:t},r){let s=Mi(this.settings);return Float64Array.
from(e,(o,a)=>r==="pursuer"?o:1-o-s*Number(t[2*a+1]))}#u(e,t,r){let s=O(t),o=[0,0];e.faults.forEach((a,i)=>o[Math.floor(i/3)%2]+=Number(a)),this.rows.push({...r,
fitness_mean:s,fitness_std:Math.sqrt(O(t.map(a=>(a-s)**2))),fitness_best:Math.max(...t),capture_rate:O(e.capture_rate),length:O(e.length),pursuer_faults:o[0]/e.
length.length,evader_faults:o[1]/e.length.length,matches:this.#h,steps:this.#m})}#S(...e){for(let t of e)this.counters[t].push({matches:this.#h,steps:this.#m,agent_steps:this.#p})}*#x(e){
yield{type:"generation",number:e,genomes:{pursuer:this.archive.pursuer[e],evader:this.archive.evader[e]}},yield*this.catchUp()}*catchUp(){for(let e=this.finished-
1;e>=0;e--){for(let t=e;t>=0;t--)for(let[r,s]of t===e?[[e,e]]:[[e,t],[t,e]]){if(this.cells.has(`${r} ${s}`))continue;let o=this.#A(r,s);this.cells.set(`${r} ${s}`,
o),yield{type:"cell",cell:o}}this.#a.has(e)||(this.#a.add(e),yield{type:"scores",number:e,scores:{pursuer:this.#T("pursuer",e),evader:this.#T("evader",e)}})}}#A(e,t){
let{world:r,evaluation_episodes:s,seed:o}=this.settings,a={pursuer:new Int32Array(1),evader:new Int32Array(1),seed:BigUint64Array.of(Kn(o,e,t))},i=T.map(u=>this.#b(
u,this.archive[u][u==="pursuer"?e:t])),l=this.#e.rollouts(r,...i,a,s),c=u=>{let h=Array.from(l[u],Number),m=h.length/s;return Array.from({length:m},(p,y)=>O(h.filter(
(f,g)=>g%m===y)))};return{pursuer:e,evader:t,capture_rates:Array.from(l.capture_rate),lengths:Array.from(l.length),means:{collisions:c("collisions"),faults:c("f\
aults"),agent_steps:c("agent_steps"),survivors:c("survivors")}}}#T(e,t){let{world:r,seed:s}=this.settings,o=this.#b(e,this.archive[e][t]),a=new Int32Array(1);return O(
Xn[e].map((i,l)=>{let c=Dt([s,T.indexOf(e),l,Pu],1),u=e==="pursuer"?[o,i]:[i,o],h=O(this.#e.rollouts(r,...u,{pursuer:a,evader:a,seed:c},_u).capture_rate);return e===
"pursuer"?h:1-h}))}};function Zn(n){let e=new Float32Array(n.reduce((r,{length:s})=>r+s,0)),t=0;for(let r of n)e.set(r,t),t+=r.length;return e}var ds=n=>Array.from({length:n},()=>Array(n)),Qn=class{learning=T;settings=[];command="";training={capture_rate:[],generation:[],learner:[],epochs:1,window:1,matches:0};limits="";name;schedule;seed;seeds=[];world;payoff;teams;findings=null;genomes={
pursuer:[],evader:[]};best=null;#e;#n;#t;constructor(e,t,r,s){this.#t=e,this.#e=t,this.#n=s,this.name=r,this.schedule=r,this.world=e.world,this.seed=String(e.seed),
this.payoff=this.#r(),this.teams=this.#a()}get newest(){return this.genomes.pursuer.length-1}#r(){let{seed:e,schedule:{generations:t}}=this.#t,r=t+1;return this.
seeds=Array.from({length:r},(s,o)=>Array.from({length:r},(a,i)=>String(Kn(e,o,i)))),{first:[0,0],shape:[r,r],episodes:this.#t.evaluation_episodes,capture_rate:ds(
r),capture_rates:ds(r),lengths:ds(r)}}#a(){let e=t=>{let r=`${this.#n} ${t}`;To(r,Zn(this.genomes[t]));let{genome:s,...o}=Ft(ut(this.#t,this.#e,t),this.genomes[t][0]??
new Float32Array(0));return{script:null,policy:{...o,genome_size:s.length},kept:[...this.genomes[t].keys()],genomes:r}};return{pursuer:e("pursuer"),evader:e("ev\
ader")}}policy(e,t){return this.playing(e,this.genomes[e][t])}playing(e,t){return Ft(ut(this.#t,this.#e,e),t)}genomesOf({pursuer:e,evader:t}){return{pursuer:this.
genomes.pursuer[e],evader:this.genomes.evader[t]}}extend(e){let{capture_rate:t,capture_rates:r,lengths:s,shape:[o]}=this.payoff;if(this.#t={...this.#t,schedule:e.
schedule},!(o>e.schedule.generations)){this.payoff=this.#r();for(let a=0;a<o;a++)Object.assign(this.payoff.capture_rate[a],t[a]),Object.assign(this.payoff.capture_rates[a],
r[a]),Object.assign(this.payoff.lengths[a],s[a])}}add(e){for(let t of T)this.genomes[t].push(e[t]);this.teams=this.#a()}change(e,t){this.#t=e,this.world=e.world;
for(let r of T)this.genomes[r]=[...t[r]];this.best=null,this.payoff=this.#r(),this.teams=this.#a(),this.findings=null}addCell({pursuer:e,evader:t,capture_rates:r,
lengths:s}){this.payoff.capture_rate[e][t]=O(r),this.payoff.capture_rates[e][t]=[...r],this.payoff.lengths[e][t]=[...s],this.findings={generalization:this.#o()}}#o(){
let e=this.payoff.capture_rate,t=o=>({mean:o,low:null,high:null}),r=o=>{let a=o.filter(i=>i!==void 0);return a.length?O(a):null},s=[...this.genomes.pursuer.keys()];
return{pursuers:t(s.map(o=>r(e[o]))),evaders:t(s.map(o=>r(e.map(a=>a[o]===void 0?void 0:1-a[o]))))}}};var Iu=1/4,Ci=1.96,Ei=.05,ms=5;function Oi(n,e){let t=Array.from({length:e},(h,m)=>Array.from({length:e},(p,y)=>n.get(`${m} ${y}`)?.capture_rates));if(e<2||t.some(
h=>h.includes(void 0)))return null;let r=t.map(h=>h.map(m=>O(m))),s=t.map(h=>h.map(m=>Lu(m))),o=Math.max(1,Math.round(e*Iu)),a=h=>{let m=rs(r,h),p=h==="pursuer"?
s:Nu(s),y=[m[0].slice(-o)],f=m.slice(-o).map(b=>b.slice(-o)),g=b=>O(b.map(E=>O(E.slice(-o))/o))/b.length,v={value:O(f.map(O))-O(y.map(O)),reach:Ci*Math.sqrt(g(p.
slice(-o))+g([p[0]]))},w=Fu(m,p),x=Uu(v,w);return{verdict:x==="better"&&!Du(m.map(O),w.value)?"better by a jump":x,before:O(y[0]),after:O(f.map(O))}},i={pursuer:a(
"pursuer"),evader:a("evader")},l=h=>{let m=rs(r,h).map(O);return m.lastIndexOf(Math.max(...m))},c={pursuer:l("pursuer"),evader:l("evader")},u=r[c.pursuer][c.evader];
return{rate:u,best:c,teams:i,sentence:Bu(u,i)}}var Nu=n=>n[0].map((e,t)=>n.map(r=>r[t])),Lu=n=>n.reduce((e,t)=>e+(t-O(n))**2,0)/Math.max(1,n.length-1)/n.length;
function Fu(n,e){let t=n.length-1,r=n.map((i,l)=>l-t/2),s=r.reduce((i,l)=>i+l*l,0),o=r.map(i=>t*i/s),a=e.map(i=>O(i)/i.length);return{value:n.reduce((i,l,c)=>i+
o[c]*O(l),0),reach:Ci*Math.sqrt(a.reduce((i,l,c)=>i+o[c]**2*l,0))}}function Du(n,e){let t=n.map(c=>c*Math.sign(e)),r=Math.floor(n.length/ms),s=n.length%ms,o=Array.
from({length:ms},(c,u)=>O(t.slice(u*r+Math.min(u,s),(u+1)*r+Math.min(u+1,s)))),a=Math.max(2,Math.floor(n.length/10)),i=Math.max(...t.slice(a).map((c,u)=>c-t[u])),
l=Math.max(...o.slice(1).map((c,u)=>o[u]-c));return i<Math.abs(e)/2&&l<Math.abs(e)/4}function Uu(...n){return n.every(({value:e,reach:t})=>e-t>Ei)?"better":n.every(
({value:e,reach:t})=>e+t<-Ei)?"weaker":"cannot tell"}var Z=n=>`${Math.round(100*n)} %`,Wu={better:"better than in generation 0","better by a jump":"better than \
in generation 0, most of it in one jump",weaker:"weaker than in generation 0","cannot tell":""};function Bu(n,e){let t=`The best pursuers now catch ${Z(n)} of t\
he best evaders.`,r=T.map(o=>Wu[e[o].verdict]);if(r[0]===r[1])return r[0]?`${t} Both teams are ${r[0]}.`:`${t} Whether a team has become better since generation\
 0, this race cannot tell.`;let s=T.map((o,a)=>r[a]?`the ${o}s are ${r[a]}`:`of the ${o}s this race cannot tell`);return`${t} ${s[0][0].toUpperCase()}${s[0].slice(
1)}; ${s[1]}.`}function ki(n,{before:e,after:t}){let[r,s]=n==="pursuer"?[e,t]:[1-e,1-t];return n==="pursuer"?`Of the last ${le(n)}s, pursuers of generation 0 ca\
tch ${Z(r)}, the last pursuers ${Z(s)}.`:`The last pursuers catch ${Z(r)} of the evaders of generation 0, and ${Z(s)} of the last evaders.`}var Ri=1/3,ju=1/10,Gu=4,zu=2,Hu=12,_i=n=>n.length>1?`${n.slice(0,-1).join(", ")} and ${n.at(-1)}`:n[0]??"";function Pi({phrases:n,words:e},t,r){let s=Object.entries(
r).map(([c,u])=>[c,Math.abs(u)]).sort(([,c],[,u])=>u-c),o=s[0]?.[1]||1/0,a=s.filter(([,c])=>c/o>=Ri).slice(0,Gu).map(([c])=>n[c][r[c]>0?1:0]),i=s.filter(([,c])=>c/
o>=ju&&c/o<Ri).slice(0,zu).map(([c])=>n[c][2]),l=_i([...a,...i.length?[`minds ${_i(i)} little`]:[]])||"takes any move that is allowed";return`{A} ${t} ${l}.`.replaceAll(
/\{(\w+)\}/g,(c,u)=>e[t][u])}function $i(n,e,t,r){let s=r[t];if(s.kind!=="rating")return{};let{n_pursuers:o,n_evaders:a}=e.config,i=Array.from({length:t==="purs\
uer"?o:a},(u,h)=>h+(t==="pursuer"?0:o)),l=n.world(e.config),c=s.inputs.map(()=>[]);for(let u=0;u<e.length;u+=Math.max(1,Math.floor(e.length/Hu))){e.seek(l,u,{pursuers:r.
pursuer,evaders:r.evader});for(let h of i.filter(m=>e.alive[u*e.n_agents+m])){let{inputs:m,refused:p}=l.rate(s,h);m.forEach((y,f)=>{let g=Array.from(y).filter((v,w)=>!p[w]);
g.length&&c[f].push(O(g.map(v=>(v-O(g))**2)))})}}return l.free(),Object.fromEntries(s.inputs.map((u,h)=>[u,s.genome[h]*Math.sqrt(c[h].length?O(c[h]):0)]))}var Vu=2,Yu=1.5,er=class{element=d("section",{class:"card weights-card","aria-label":"Weights of named inputs",hidden:!0});#e;#n;#t;#r=d("div",{class:"evolved"});#a=d(
"p",{class:"numbers",role:"status"});#o=d("button",{type:"button",onclick:()=>this.#l()},"As evolved");#h={pursuer:d("p"),evader:d("p")};#m=null;#p=null;constructor(e,t,r){
this.#e=e,this.#n=t,this.#t=r,this.element.append(d("h3",{},"What they have learned"),d("p",{class:"small muted"},"An agent takes the move with the largest sum \
of weight x input. Drag a weight, and see at once what becomes of the team."),d("div",{class:"doings"},this.#o,this.#a),this.#r)}genome(e){return this.#p?.[e]??
this.#d[e]}get#g(){let{newest:e,best:t}=this.#m;return t??{pursuer:e,evader:e}}get#d(){return this.#m.genomesOf(this.#g)}show(e){e!==this.#m&&(this.#p=null),this.#m=
e;let t=T.flatMap(r=>{let{policy:s}=e.teams[r];return s?.kind==="rating"?[[r,s.inputs]]:[]});this.element.hidden=!t.length||e.newest<1,!this.element.hidden&&(this.#p||
this.#r.replaceChildren(...t.map(r=>this.#y(...r))),this.#i())}#y(e,t){let r=this.genome(e),s=Math.max(Vu,Yu*Math.max(...r.map(Math.abs)));return d("div",{class:"\
weights"},d("h4",{class:e},`${e}s`),this.#h[e],...t.flatMap((o,a)=>{let i=d("span",{class:"numbers"},at(r[a])),l=d("input",{type:"range",class:e,min:-s,max:s,step:"\
any",value:r[a],title:Le[o],"aria-label":`${e}s: ${o}`});return l.addEventListener("input",()=>{i.textContent=at(Number(l.value)),this.#s(e,a,Number(l.value))}),
[d("span",{title:Le[o]},o.replaceAll("_"," ")),l,i]}))}#s(e,t,r){this.#p??={pursuer:this.genome("pursuer").slice(),evader:this.genome("evader").slice()},this.#p[e][t]=
r,this.#i(),this.#t()}#l(){this.#p=null,this.show(this.#m),this.#t()}#i(){this.#o.disabled=!this.#p;let e=Z(this.rate(this.#d));this.#a.textContent=this.#p?`You\
rs: ${Z(this.rate(this.#p))} are caught; as evolved: ${e}`:`${e} are caught`;let t=this.#m,r={pursuer:t.playing("pursuer",this.genome("pursuer")),evader:t.playing(
"evader",this.genome("evader"))},s=this.#e.match(t.world,r.pursuer,r.evader,BigInt(t.seed));for(let o of T)this.#h[o].textContent=Pi(this.#n,o,$i(this.#e,s,o,r))}rate({
pursuer:e,evader:t},r=this.#g,s=this.#m){let o=new Int32Array(1),a={pursuer:o,evader:o,seed:BigUint64Array.of(BigInt(s.seeds[r.pursuer][r.evader]))};return O(this.#e.
rollouts(s.world,s.playing("pursuer",e),s.playing("evader",t),a,s.payoff.episodes).capture_rate)}};var Ku=12,tr=class{#e=null;#n=null;#t=[];#r;constructor(e,t){this.#r=t;try{let r=new Blob([we("script-engine"),`
`,we(`script-${e}`)],{type:"text/javascript"});this.#n=new Worker(URL.createObjectURL(r)),this.#n.onerror=()=>this.#e||this.#a(),this.#n.onmessage=()=>this.#o(this.#n)}catch{
this.#a()}}send(e){this.#e?this.#e.postMessage(e):this.#t.push(e)}close(){this.send({type:"stop"}),this.#n?.terminate()}#a(){let{port1:e,port2:t}=new MessageChannel;
ps(t),this.#o(e)}#o(e){this.#e=e,e.onmessage=({data:t})=>t.type!=="ready"&&this.#r(t);for(let t of this.#t.splice(0))e.postMessage(t)}};function ps(n){let e=v=>n.
postMessage(v),t=Jt(),r=null,s=null,o=null,a=[],i=!1,l=0,c=!1,u=new MessageChannel,h=v=>{let w=r.change(v);e({type:"changed",at:r.epochs,settings:v}),w&&e(w),!s&&
r.finished<=v.schedule.generations?(s=r.run(),i=!0):i||(o=r.catchUp())},m=()=>{i=!1,o=r.catchUp(),e({type:"stopped",at:r.epochs})},p=()=>{if(i&&s){for(;a.length&&
a[0].at<=r.epochs;)h(a.shift().settings);let{value:w,done:x}=s.next();return x?(s=null,i=!1,o=r.catchUp(),e({type:"end",at:r.epochs,seconds:l/1e3})):w.type==="r\
est"?m():e(w),!0}let v=o?.next();return v&&!v.done?e(v.value):o=null,!!o},y=()=>{let v=performance.now(),w=!0;for(;w&&performance.now()<v+Ku;)w=p();l+=performance.
now()-v,!(!w||c)&&(c=!0,u.port2.postMessage(null))},f=async v=>{if(v.type==="start")r=new ct(await t,v.settings,v.masks),s=r.run(),o=null,a=[...v.plan],i=!0,l=0,
r.until=v.until,e({type:"began"});else if(r)if(v.type==="change")a=[],r.until=1/0,h(v.settings);else if(v.type==="go")r.until=1/0,i=!0;else if(v.type==="stop")i&&
m();else{let{settings:w,archive:x,rows:b,cells:E,counters:_,finished:R}=r;e({type:"saved",race:{settings:w,archive:x,rows:b,cells:E,counters:_,finished:R}})}else
return;y()},g=v=>{Promise.resolve().then(v).catch(w=>{s=o=null,e({type:"failed",message:String(w)})})};u.port1.onmessage=()=>{c=!1,g(y)},n.onmessage=({data:v})=>g(
()=>f(v)),e({type:"ready"})}var qu=100,Ju=.3,Zu="By chance: evaders that have not learned to flee run into pursuers that have not learned to hunt.",nr={pursuer:0,evader:0},Ii=0,rr=class extends EventTarget{element;chases;boards;before=new Nt;after=new Nt;settings;state="\
waiting";done=0;epochs=0;changed=[];seconds=0;outcome=null;kept=null;#e;#n;#t;#r=d("h2",{class:"lane-title"});#a=d("p",{class:"facts numbers"});#o=d("div",{class:"\
lane-room"});#h=d("section",{class:"card measures"});#m=d("details",{class:"lane-more",hidden:!0},d("summary",{},"More: every generation against every other, sc\
ores and collisions"),this.#o,this.#h);#p=d("div");#g=new it(()=>{});#d=d("section",{class:"card asked","aria-label":"An agent",hidden:!0},d("button",{type:"but\
ton",class:"leave",onclick:()=>this.#N(null,null)},"Close"),this.#g.element);#y;#s;#l={pursuer:[],evader:[]};#i=new Map;#f;#c=()=>{};#w=0;#b=!0;#v=!1;#u=0;#S=null;constructor(e,t,r,s){
super(),this.#e=e,this.#n=t,this.settings=s,this.#t=new tr(r,o=>this.#A(o)),this.chases=new Yn(()=>this.#I(),this.before,this.after),this.before.element.classList.
add("before"),this.boards=d("div",{class:"pair"},this.before.element,this.after.element),this.#y=new er(t,e,()=>this.#$(!0));for(let o of[this.before,this.after])
o.addEventListener("agent",()=>o.agent!==null&&this.#N(o,o.agent)),o.addEventListener("step",()=>!this.#d.hidden&&o.agent!==null&&this.#L(o));this.element=d("se\
ction",{class:"lane"},this.#r,this.#a,this.boards,d("p",{class:"hint small muted"},"Click an agent, or press A: what it sees, and why it moves."),this.#d,this.#y.
element,this.#m,this.#p),this.reset(s)}reset(e){this.#t.send({type:"stop"}),this.#O(e),this.state="waiting";let{archive:t}=new ct(this.#n,e,this.#e.masks);this.#s.
add({pursuer:t.pursuer[0],evader:t.evader[0]}),this.#$(!0),this.#P()}start(e,t=[],r=1/0){this.#O(e),this.state="evolving",this.settings=t.at(-1)?.settings??e,this.#x(
{type:"start",settings:e,masks:this.#e.masks,plan:t,until:r}),this.#P()}restore(e,t,r,s){this.#O(t.settings),this.settings=e,this.kept=t;for(let o=0;o<t.finished;o++)
this.#s.add({pursuer:t.archive.pursuer[o],evader:t.archive.evader[o]});for(let[o,a]of t.cells)this.#s.addCell(a),this.#i.set(o,a);this.#l={pursuer:[...t.scores.
pursuer],evader:[...t.scores.evader]},this.seconds=t.seconds,this.done=1,this.epochs=r,this.changed.push(...s),this.#M("ended"),this.#E()}stop(){this.#x({type:"\
stop"})}go(){this.state="evolving",this.#x({type:"go"}),this.#P()}change(e){if(this.state==="waiting")return this.reset(e);this.settings=e,this.#x({type:"change",
settings:e}),this.#P()}saved(){return this.kept?Promise.resolve(this.kept):new Promise(e=>{this.#S=e,this.#x({type:"save"})})}async keep(){return{...await this.
saved(),scores:this.#l,seconds:this.seconds}}get newestGeneration(){return this.#s.newest}get champions(){return{pursuer:this.#y.genome("pursuer"),evader:this.#y.
genome("evader")}}get run(){return this.#s}close(){this.#t.close(),this.chases.runs=!1}#x(e){this.#t.send(e)}#A(e){if(e.type==="began"&&(this.#v=!0),!!this.#v){
if(e.type==="generation")this.#s.add(e.genomes),this.#$(e.number===0);else if(e.type==="cell"){let{pursuer:t,evader:r}=e.cell;this.#s.addCell(e.cell),this.#b&&t===
r&&t===this.#s.newest&&this.#f.select({pursuer:t,evader:r}),this.#i.set(`${t} ${r}`,e.cell),(this.state==="stopped"||this.state==="ended")&&this.#M(this.state)}else if(e.
type==="scores")for(let t of T)this.#l[t][e.number]=e.scores[t];else e.type==="changed"?(this.#s.extend(e.settings),this.changed.push(e.at),this.epochs=e.at,e.settings.
schedule.generations>this.#s.newest&&this.state==="ended"&&this.#T()):e.type==="anew"?(this.#s.change(e.settings,e.genomes),this.#C(),this.#$(!0)):e.type==="epo\
ch"?(this.epochs+=1,this.done=e.done/e.of):e.type==="stopped"?this.#M("stopped"):e.type==="end"?(this.seconds=e.seconds,this.done=1,this.#M("ended")):e.type==="\
saved"?this.#S?.(e.race):e.type==="failed"&&(this.#a.textContent=`The race failed: ${e.message}`,this.state="stopped");this.#u||(this.#u=setTimeout(()=>requestAnimationFrame(
()=>this.#E()),qu))}}#T(){this.state="evolving",this.outcome=null,this.#s.best=null}#M(e){let t=this.outcome;this.state=e,this.outcome=Oi(this.#i,this.#s.newest+
1),this.#s.best=this.outcome?.best??null,this.outcome&&!t&&this.#$(!0),this.#D()}#E(){this.#u=0,this.#f.dispatchEvent(new Event("run")),this.#c(),this.#P()}#C(){
this.#i=new Map,this.#l={pursuer:[],evader:[]},this.outcome=null,this.#h.hidden=!0}#O(e){this.settings=e,this.done=0,this.epochs=0,this.changed.splice(0),this.kept=
null;let t=ln(e);this.#s=new Qn(e,this.#e.masks,t,`race ${Ii}`),Ii+=1,this.#C(),this.#N(null,null),this.#b=!0,this.#v=!1,this.#f=new Vn({run:0,pursuer:0,evader:0,
episode:0,seed:null});let r=new Hn([this.#s],this.#f);r.element.ariaLabel=`Payoff matrix. ${t}`,this.#p.replaceChildren(this.#k(r)),this.#o.replaceChildren(r.element,
this.#R())}#k(e){let t=new jn([this.#s],this.#f,null);t.actions.remove();let r=d("dialog",{class:"of-cell-match","aria-label":"Match",onclose:()=>t.player.pause()},
d("button",{type:"button",class:"leave",onclick:()=>r.close()},"Close"),t.element),s=!1;return e.element.addEventListener("play",()=>{let{pursuer:o,evader:a}=this.#f.
selected;this.#b=!1,this.#s.payoff.capture_rate[o][a]!==void 0&&(r.showModal(),s||t.start(this.#n),s=!0,t.playSoon())}),r}#R(){let e=`${Xn.pursuer.join(", ")} a\
nd ${Xn.evader.join(", ")}`,t=Fa(`Scores against scripts, by generation: ${e}`,(s,o)=>this.#_(s,o),()=>{},s=>{let o=Math.min(this.#s.newest,Math.max(0,Math.round(
s)));this.#f.select({pursuer:o,evader:o})});return this.#c=t.redraw,d("section",{class:"card scores"},d("h3",{},"Against opponents that never change"),d("p",{class:"\
small muted"},"Captures of random walkers and of clumsy fleers; escapes from random walkers and from clumsy chasers."),La(["pursuers","of-pursuers"],["evaders",
"of-evaders"]),t.element)}#_(e,t){let{generations:r}=this.settings.schedule,o=Ia(e,t,{low:0,high:r,label:"generation",whole:!0},{low:0,high:1,label:"score"});for(let a of T){
let i=Array.from(this.#l[a],l=>l??null);Na(o,[...i.keys()],i,`of-${a}s`)}return o}#I(){if(this.#s.newest<0)return;let e=BigInt(this.#s.seeds[0][0]),t=this.#w%this.#s.
payoff.episodes;this.#w+=1;let r=s=>this.#n.match(this.#s.world,...this.#F(s),e,t);this.before.show(r(this.#s.genomesOf(nr)),"Before: generation 0"),this.after.
show(r(this.champions),this.#W());for(let s of[this.before,this.after])s.agent!==null&&this.#L(s,!0)}#W(){let{newest:e,best:t}=this.#s;if(e===0)return"Generatio\
n 0: nobody has learned anything yet";let{pursuer:r,evader:s}=t??{pursuer:e,evader:e},o=r===s?`generation ${r}`:`pursuers of generation ${r}, evaders of generat\
ion ${s}`;return t?`After: ${o}`:`Now: ${o}`}#F({pursuer:e,evader:t}){return[this.#s.playing("pursuer",e),this.#s.playing("evader",t)]}#$(e){this.#y.show(this.#s),
this.chases.renew(e)}#N(e,t){for(let r of[this.before,this.after])r!==e&&r.agent!==null&&r.choose(null);this.#d.hidden=!e,e&&(this.#L(e,!0),this.#g.choose(t))}askNext(){
let{match:e,player:t,agent:r}=this.after;if(!e)return;let s=e.n_agents,o=(r??-1)+1,i=Array.from({length:s},(l,c)=>(o+c)%s).find(l=>e.alive[t.step*s+l]);i!==void 0&&
this.after.choose(i)}#L(e,t=!1){if(t){let r=e===this.before,[s,o]=this.#F(r?this.#s.genomesOf(nr):this.champions),a=r?0:this.#s.newest;this.#g.show(this.#n,this.#s,
e.match,{run:0,pursuer:a,evader:a,episode:0,seed:null},{pursuers:s,evaders:o})}this.#g.at(e.player.step)}#P(){let{newest:e}=this.#s;this.element.dataset.state=this.
state,this.#r.textContent=ln(this.settings),this.#m.hidden=this.state==="waiting",this.#a.replaceChildren(...this.#B().map(t=>d("span",{},t))),this.element.dataset.
newest=String(e),this.dispatchEvent(new Event("state"))}#B(){let{newest:e}=this.#s;if(this.outcome)return[this.outcome.sentence];if(e<0)return[];let t=a=>{let i=this.#i.
get(`${a} ${a}`);return i?O(i.capture_rates):null};if(this.state==="waiting"||e<1){let a=t(0)??this.#y.rate(this.#s.genomesOf(nr),nr),i=`${Z(a)} of the evaders \
are caught.`;return a>Ju?[i,Zu]:[i]}let r=`Generation ${e} of ${this.settings.schedule.generations}`,s=t(e)??t(e-1),o=t(0);return s===null||o===null?[`${r}.`]:[
`${r}: the pursuers catch ${Z(s)} of the evaders; those of generation 0 caught ${Z(o)}.`]}#D(){let{outcome:e}=this;if(this.#h.hidden=!e,this.#h.ariaLabel=`What \
came out. ${ln(this.settings)}`,!e)return;let t=this.#i.get(`${this.#s.newest} ${this.#s.newest}`),r=[["Score against scripts: generation 0",s=>Z(this.#l[s][0]??
0)],["Score against scripts: newest generation",s=>Z(this.#l[s].at(-1)??0)],["Collisions at fault in 1000 moves of the newest generation",(s,o)=>Xu(t,o).toFixed(
1)]];this.#h.replaceChildren(d("h3",{},"In numbers"),...T.map(s=>d("p",{},ki(s,e.teams[s]))),d("table",{class:"numbers"},d("thead",{},d("tr",{},d("td"),...T.map(
s=>d("th",{scope:"col",class:s},`${s}s`)))),d("tbody",{},...r.map(([s,o])=>d("tr",{},d("th",{scope:"row"},s),...T.map((a,i)=>d("td",{},o(a,i))))))),d("p",{class:"\
small muted"},"One race proves little: save it, and ",d("code",{},"matrixworld judge")," says what happened on its way, and how surely."))}};function Xu({means:{
faults:n,agent_steps:e}},t){let r=n.length/T.length;return 1e3*n.slice(t*r,(t+1)*r).reduce((s,o)=>s+o,0)/Math.max(1,e[t])}var Ni=n=>Ue(JSON.stringify(n,null,2)),fs=(n,...e)=>({dtype:"<f8",shape:e,data:Float64Array.from(n)}),Qu=n=>Math.sqrt(O(n.map(e=>(e-O(n))**2)));function eh({settings:n,
finished:e}){let t=n.schedule.kind==="alternating"?T.map(r=>[r]):[T];return Array.from({length:e},(r,s)=>(s?t:[T]).map(o=>[s,o])).flat()}function th({archive:n,
rows:e,counters:t},r,[s,o]){let a=e.filter(c=>c.generation===s&&o.includes(c.team)),i=Ue(a.map(c=>`${[r,...Ti.map(u=>c[u])].join(",")}
`).join("")),l=c=>({dtype:"<f4",shape:[1,n[c][s].length],data:n[c][s]});return{...Object.fromEntries(o.map(c=>[`${c}s`,l(c)])),log:{dtype:`|S${Math.max(1,i.length)}`,
shape:[],data:i.length?i:new Uint8Array(1)},...Object.fromEntries(Object.entries(t[o.at(-1)][s]).map(([c,u])=>[c,fs([u])])),...r?{score:fs([O(a.slice(Math.floor(
a.length/2)).map(c=>c.capture_rate))])}:{}}}function nh(n){let e=n.finished,t=Array.from({length:e*e},(o,a)=>n.cells.get(`${Math.floor(a/e)} ${a%e}`)),r=t[0].lengths.
length,s=(o,...a)=>fs(t.flatMap(o),e,e,...a);return{scores:{dtype:"<f4",shape:[e,e,r],data:Float32Array.from(t.flatMap(({capture_rates:o})=>o))},mean:s(({capture_rates:o})=>O(
o)),std:s(({capture_rates:o})=>Qu(o)),lengths:{dtype:"<i4",shape:[e,e,r],data:Int32Array.from(t.flatMap(({lengths:o})=>o))},collisions:s(({means:o})=>o.collisions,
2,3),faults:s(({means:o})=>o.faults,2,3),agent_steps:s(({means:o})=>o.agent_steps,2),pursuer_survivors:s(({means:o})=>o.survivors[0]),evader_survivors:s(({means:o})=>o.
survivors[1])}}function rh(n,{format:e,version:t,game:r}){let s=n.finished-1,o={...n.settings,schedule:{...n.settings.schedule,generations:s}},a={format:e,matrixworld:t,
game:r,settings:o,drawn_by:"page"},i=eh(n),{matches:l,steps:c,agent_steps:u}=n.counters.evader[s],h={training_matches:l,training_steps:c,training_agent_steps:u},
m={stages:i.length-1,...h,disengagement:[],evaluation_matches:n.finished**2*n.settings.evaluation_episodes};return{"config.json":Ni(a),...Object.fromEntries(i.map(
(p,y)=>[`stage-${String(y).padStart(4,"0")}.npz`,Rt(th(n,y,p))])),"payoff.npz":Rt(nh(n)),"summary.json":Ni(m)}}function Li(n,e){let t=n.flatMap(({name:r,race:s})=>Object.
entries(rh(s,e)).map(([o,a])=>[n.length>1?`${r}/${o}`:o,a]));return on(Object.fromEntries(t))}var ys=n=>n.finished>1&&n.cells.size>=n.finished**2&&T.every(e=>n.
archive[e].length);function Di(n){let{width:e,height:t}=n[0],{table:r,place:s}=sh(n),o=[...Fi("GIF89a"),...Wt(e),...Wt(t),247,0,0,...r];return o.push(33,255,11,...Fi("NETSCAPE2.0"),
3,1,0,0,0),n.forEach((a,i)=>{o.push(33,249,4,0,...Wt(i===n.length-1?150:12),0,0),o.push(44,0,0,0,0,...Wt(e),...Wt(t),0,8);let l=oh(Ui(a).map(c=>s[c]));for(let c=0;c<
l.length;c+=255){let u=l.slice(c,c+255);o.push(u.length,...u)}o.push(0)}),Uint8Array.from([...o,59])}var Fi=n=>[...n].map(e=>e.charCodeAt(0)),Wt=n=>[n&255,n>>8];
function Ui({data:n}){let e=new Uint16Array(n.length/4),t=3;for(let r=0;r<e.length;r++)e[r]=n[4*r]>>t<<10|n[4*r+1]>>t<<5|n[4*r+2]>>t;return e}function sh(n){let e=new Map;
for(let i of n)for(let l of Ui(i))e.set(l,(e.get(l)??0)+1);let t=[...e].sort(([,i],[,l])=>l-i).slice(0,256).map(([i])=>i),r=i=>[i>>10,i>>5&31,i&31],s=(i,l)=>r(i).
reduce((c,u,h)=>c+(u-r(l)[h])**2,0),o=new Uint8Array(2**15);for(let i of e.keys()){let l=t.indexOf(i);o[i]=l>=0?l:t.reduce((c,u,h)=>s(i,u)<s(i,t[c])?h:c,0)}let a=t.
flatMap(i=>r(i).map(l=>Math.round(l*255/31)));return{table:[...a,...Array(3*256-a.length).fill(0)],place:o}}function oh(n){let r=[],s=new Map,o=258,a=9,i=0,l=0,
c=h=>{for(i|=h<<l,l+=a;l>=8;l-=8)r.push(i&255),i>>>=8};c(256);let u=n[0];for(let h of n.subarray(1)){let m=s.get(u*256+h);if(m!==void 0){u=m;continue}c(u),o===4096?
(c(256),s=new Map,o=258,a=9):(s.set(u*256+h,o),o===2**a&&(a+=1),o+=1),u=h}return c(u),c(257),l&&r.push(i&255),r}var ah={...Tn,numbers:!1},ih={side:260,gap:12,head:30},lh={width:1200,height:800,side:520,gap:48},ch=60;function gs(n,e){let t=Object.assign(document.createElement(
"canvas"),{width:n,height:e});return[t,t.getContext("2d",{willReadFrequently:!0})]}function Wi({recording:n},e,t){let[r,s]=gs(t,t),o=Cn(n.rows,n.cols,!1,t,t,1);
return En({ctx:s,grid:o,colors:st(document.querySelector("canvas.board"))},n,Math.min(e,n.moments.length-1),ah,1),r}function Bi(n,e){let t=getComputedStyle(document.
body);n.fillStyle=t.backgroundColor,n.fillRect(0,0,n.canvas.width,n.canvas.height),n.fillStyle=t.color,n.font=`${e} ${t.fontFamily}`}function ji(n){let{side:e,gap:t,
head:r}=ih,s=Math.min(ch,Math.max(...n.map(({recording:i})=>i.moments.length-1))),[o,a]=gs(n.length*e+(n.length+1)*t,r+e+t);return Di(Array.from({length:s+1},(i,l)=>(Bi(
a,"600 15px"),n.forEach((c,u)=>{let h=t+u*(e+t);a.fillText(c.title,h,21,e),a.drawImage(Wi(c,l,e),h,r)}),a.getImageData(0,0,o.width,o.height))))}function Gi(n,e){
let{width:t,height:r,side:s,gap:o}=lh,[a,i]=gs(t,r);return Bi(i,"600 30px"),n.forEach((l,c)=>{let u=o+c*(s+o+16);i.fillText(l.title,u,60,s),i.drawImage(Wi(l,1/0,
s),u,80)}),e.forEach((l,c)=>{i.font=i.font.replace(/^\S+ \S+/,c<e.length-2?"500 27px":"400 19px"),i.fillText(l,o,650+37*c,t-2*o)}),new Promise(l=>a.toBlob(c=>l(
c)))}var ze="matrixworld-evolve",vs=()=>JSON.parse(bs()?.getItem(ze)??"[]");function bs(){try{return sessionStorage}catch{return null}}var zi=vs,sr=({address:n})=>n.
split(/&?race=/)[0];function Hi(n,e){let t=bs(),r=JSON.stringify(e,(a,i)=>i instanceof Float32Array?{floats:Array.from(i)}:i instanceof Map?{entries:[...i]}:i),
s=vs().filter(a=>sr(a)!==sr(n));for(let{address:a}of vs().filter(i=>sr(i)===sr(n)))t?.removeItem(`${ze} ${a}`);let o=[...s,n];for(let a=0;t&&a<=8;a++){for(let i of o.
splice(0,Math.max(0,o.length-8)))t.removeItem(`${ze} ${i.address}`);try{t.setItem(`${ze} ${n.address}`,r),t.setItem(ze,JSON.stringify(o));return}catch(i){if(!(i instanceof
DOMException)||o.length<2)return;t.removeItem(`${ze} ${o[0].address}`),o=o.slice(1)}}}function Vi(n){let e=bs()?.getItem(`${ze} ${n}`);return e?JSON.parse(e,(t,r)=>Array.
isArray(r?.floats)?Float32Array.from(r.floats):Array.isArray(r?.entries)?new Map(r.entries):r):null}var Bt=8e3;function qi(n){let e=2166136261;for(let t of we("script-engine")+JSON.stringify(n))e=Math.imul(e^t.charCodeAt(0),16777619);return(e>>>0).toString(36)}
var Ne={changes:"~~",parts:"~",value:":",races:"_"},Ji="end",ws=({choice:n,changes:e})=>e.reduce((t,{change:r})=>({...t,...r}),n);function jt(n,{choice:e,changes:t,
watched:r},s){let o=l=>l.map(c=>c===1/0?Ji:c).join(Ne.races),a=t.map(({change:l,at:c})=>[o(c),...Object.entries(ko(l)).map(u=>u.join(Ne.value))].join(Ne.parts)).
join(Ne.changes),i={...Oo(n,e),...r.length?{race:qi(n),to:o(r),...a?{then:a}:{}}:{},...s?{play:[s.seed,s.episode,s.seat,s.score,s.rate].join("."),pursuer:Yi(s.pursuer),
evader:Yi(s.evader)}:{}};return Object.entries(i).map(([l,c])=>`${l}=${c}`).join("&")}function Zi(n,e){let t=[...new URLSearchParams(e.length>2*Bt?"":e.replace(
/^#/,""))],{race:r="",to:s="",then:o="",play:a="",pursuer:i="",evader:l="",...c}=Object.fromEntries(t),u=[],h=Gr(n,c,b=>u.push(b)),m=b=>b===Ji?1/0:/^\d{1,6}$/.test(
b)?Number(b):NaN,p=b=>b.split(Ne.races).map(m),y=o.split(Ne.changes).filter(Boolean).reduce((b,E)=>{let[_="",...R]=E.split(Ne.parts),k=ws({choice:h,changes:b,watched:[]}),
A=Object.fromEntries(R.map(F=>F.split(Ne.value))),D=Gr(n,A,F=>u.push(F),k),L=Object.fromEntries(Object.entries(D).filter(([F])=>F in A));return[...b,{change:L,at:p(
_)}]},[]),f=r||s?p(s):[],g=h.beside?2:1,v=[...y.map(({at:b})=>b),...f.length?[f]:[]].every(b=>b.length===g&&!b.some(Number.isNaN)),w=a?uh(n,h,a,i,l):null;v||u.push(
`to=${s}`),a&&!w&&u.push(`play=${a}`);let x="";return e.length>2*Bt?x="The link is too long, and shows nothing. ":u.length?x=`Something in the link is wrong, an\
d left out: ${u.slice(0,3).map(E=>E.slice(0,60)).join("; ")}. `:f.length&&r!==qi(n)&&(x="The link is of another version of this page: the race may be another on\
e. "),{story:{choice:h,changes:v?y:[],watched:v?f:[]},dare:w,problem:x}}function uh(n,e,t,r,s){let o=/^(\d{1,20})\.(\d{1,4})\.(\d{1,3})\.(\d{1,4})\.(\d{1,3})$/.
exec(t),a=[Ki(r),Ki(s)];if(!o||!a[0]?.length||!a[1]?.length||Number(o[3])>=e.pursuers+e.evaders)return null;let i=pn(n,e);if(T.some((m,p)=>a[p].length!==Ee(ut(i,
n.masks,m))))return null;let[l,c,u,h]=o.slice(2).map(Number);return{pursuer:a[0],evader:a[1],seed:String(BigInt.asUintN(64,BigInt(o[1]))),episode:l,seat:c,score:u,
rate:h}}var Yi=n=>btoa(String.fromCharCode(...new Uint8Array(n.slice().buffer))).replaceAll("+","-").replaceAll("/",".").replaceAll("=","");function Ki(n){if(!/^[\w.-]*$/.
test(n))return null;try{let e=Uint8Array.from(atob(n.replaceAll("-","+").replaceAll(".","/")),r=>r.charCodeAt(0)),t=e.length%4?null:new Float32Array(e.buffer);return t?.
every(Number.isFinite)?t:null}catch{return null}}var hh=250,he=(n,e,t,r="")=>d("button",{type:"button",title:e||null,class:r||null,onclick:t},n),xs=class{#e;#n;lanes=[];#t=d("div",{class:"lanes"});#r=d("div",{
class:"of-race"});#a=he("Evolve","",()=>this.#O(),"evolve");#o=d("progress",{max:1,value:0,"aria-label":"Progress of the race"});#h=d("p",{class:"small muted nu\
mbers",role:"status"});#m=he("Draw walls","Drag over the board to draw walls, and over walls to remove them",()=>this.#F());#p=he("Usual walls","Each match draw\
s its walls anew",()=>this.#I({walls:null}));#g=he("Pause","",()=>this.#N());#d=he("Again","Another race, with other luck",()=>this.#I({seed:this.#u.seed+1},!0));#y=he(
`${et} more generations`,"",()=>this.#I({generations:this.#u.generations+et}));#s=Zt("Link to this race");#l=d("span",{class:"told small",role:"status"});#i=d("\
nav",{class:"shelf small","aria-label":"Races of this visit",hidden:!0});#f;#c;#w=[];#b;#v=[];#u;#S=0;#x=!1;#A="";constructor(e,t){this.#e=e,this.#n=t;let{story:r,
dare:s,problem:o}=Zi(e,ge()?location.hash:"");this.#b=r.choice,this.#v=r.changes.map(({change:a})=>a),this.#u=ws(r),this.#f=Ro(e,(a,i)=>this.#I(a,i)),this.#c=new Fn(
t,a=>ge()?this.#U(a):null),this.#r.append(d("div",{class:"ending",role:"group","aria-label":"What to do now"},he("Can you escape them?","Be an evader, against t\
he best pursuers",()=>this.#$("evader"),"primary largest"),he("Can you catch them?","Be a pursuer, against the best evaders",()=>this.#$("pursuer")),this.#y,this.#d),
d("div",{class:"doings",role:"group","aria-label":"What can be done"},this.#g,this.#m,this.#p,ge()&&he("Link","An address at which this race evolves again, on a\
ny computer",()=>this.#G()),he("GIF","Both boards as a film",()=>this.#H()),he("Picture","Both boards and what came out",()=>{this.#V()}),he("Save","An archive \
that matrixworld judge, explore and replay read",()=>{this.#Y()}),this.#s,this.#l)),document.getElementById("page").replaceWith(Xs("Evolve a chase","Triangles c\
hase discs. Nobody has told either team how. Press Evolve, and both learn by trial and error, against each other."),d("main",{},d("div",{class:"start"},this.#a,
d("div",{class:"progress"},this.#o,this.#h)),this.#t,this.#i,this.#f.main,this.#f.more,d("div",{class:"card below"},Qt(),d("p",{class:"small muted"},"The page p\
lays and learns with the engine of matrixworld, in this browser; nothing is sent."),d("p",{class:"small muted of-saving"},"A saved race is an archive: ",d("code",
{},"matrixworld judge"),", ",d("code",{},"explore")," and ",d("code",{},"replay")," read it. Python plays its matches again, and does not continue it."))),d("fo\
oter",{class:"muted small"},`matrixworld ${e.version}`),this.#c.dialog),this.#C(),this.#l.textContent=o,this.#T(r,s)}#T(e,t){let r=e.watched.length?Vi(jt(this.#e,
e)):null;if(r?.length===this.lanes.length){this.#A=jt(this.#e,e);for(let[c,u]of this.lanes.entries())u.restore(this.#E(c),r[c],e.watched[c],e.changes.map(({at:h})=>h[c]))}
let s=()=>{e.watched.length&&!r&&this.#R(e)};if(!t)return s();let o=this.#E(0),a={pursuer:this.lanes[0].run.playing("pursuer",t.pursuer),evader:this.lanes[0].run.
playing("evader",t.evader)},i=t.seat<o.world.n_pursuers?"pursuer":"evader",l=[{name:`the best ${i}s`,text:"",policy:()=>a[i]}];this.#c.play(i,{world:o.world,policies:a,
players:l,seed:o.seed,rate:t.rate,friend:t},t),this.#c.dialog.addEventListener("close",s,{once:!0})}#M(e=this.#u){return[e.schedule,...e.beside?[e.beside]:[]]}#E(e,t=this.#u){
return pn(this.#e,t,this.#M(t)[e])}#C(){for(let e of this.lanes.splice(0))e.close();for(let[e]of this.#M().entries()){let t=new rr(this.#e,this.#n,"evolve",this.#E(
e));t.addEventListener("state",()=>this.#P()),this.lanes.push(t)}this.#w=this.lanes.map(e=>e.after.drawWalls(([t,r],s)=>this.#W(t,r,s))),this.#m.ariaPressed="fa\
lse",this.#t.dataset.count=String(this.lanes.length),this.#t.replaceChildren(...this.lanes.map(({element:e})=>e)),this.lanes.length>1?this.#t.before(this.#r):this.
lanes[0].boards.after(this.#r),this.#f.show(this.#u),this.#P()}#O(){let e=this.lanes.map(({state:t})=>t);e.includes("evolving")?this.lanes.forEach(t=>t.stop()):
e.includes("stopped")?this.lanes.forEach(t=>t.state==="stopped"&&t.go()):this.#k()}#k(){this.#l.textContent="",this.#A="";for(let[e,t]of this.lanes.entries())t.
start(this.#E(e))}#R({choice:e,changes:t,watched:r}){this.#x=!0;let s=e,o=t.map(({change:a})=>s={...s,...a});for(let[a,i]of this.lanes.entries()){let l=t.map(({
at:c},u)=>({at:c[a],settings:this.#E(a,o[u])}));i.start(this.#E(a,e),l,r[a])}}get#_(){let e=this.lanes.some(({state:t})=>t==="waiting");return{choice:this.#b,changes:this.#v.
map((t,r)=>({change:t,at:this.lanes.map(({changed:s,epochs:o})=>s[r]??o)})),watched:e?[]:this.lanes.map(({state:t,epochs:r})=>t==="evolving"?1/0:r)}}#I=(e,t=!1)=>{
let r=this.#M().length,s=this.lanes.every(({state:l})=>l==="waiting");this.#x&&!t&&(this.#v=this.#v.slice(0,Math.min(...this.lanes.map(({changed:l})=>l.length))),
this.#u=this.#v.reduce((l,c)=>({...l,...c}),this.#b)),this.#x=!1;let o={...this.#u,...e},a=o.generations>dn?`A race has at most ${dn} generations here.`:fn(o,this.#e.
worlds[o.world]);if(this.#f.show(a?this.#u:o),this.#l.textContent=a,a)return;this.#u=o;let i=this.#_;if(t||s){if(this.#b={...o,generations:et},this.#v=[],this.#u=
this.#b,!s&&ge()&&history.pushState(null,"","#"),this.#M().length!==r&&this.#C(),!s)return this.#k()}else this.#v.push(e);if(this.lanes.some(l=>l.kept))this.#A=
"",this.#R({...i,changes:[...i.changes,{change:e,at:i.watched}],watched:this.lanes.map(()=>1/0)});else for(let[l,c]of this.lanes.entries())c.change(this.#E(l))};#W(e,t,r){
let{settings:{world:{rows:s,cols:o}},after:a}=this.lanes[0],i=Array.from({length:s*o},(m,p)=>p).filter(m=>a.recording.obstacles[m]),l={...this.#u,walls:en(this.#u.
walls??i,e*o+t,r)},c=fn(l,this.#e.worlds[l.world]);if(c)return c;this.#u=l;let{walls:u}=l,h=Uint8Array.from({length:s*o},(m,p)=>Number(u.includes(p)));for(let m of this.
lanes)m.after.showWalls(h);return clearTimeout(this.#S),this.#S=setTimeout(()=>this.#I({walls:u}),hh),""}#F(){let e=this.#m.ariaPressed!=="true";this.#m.ariaPressed=
String(e);for(let t of this.#w)t(e)}#$(e){let{run:t,champions:r,outcome:s}=this.lanes[0],o={pursuer:t.playing("pursuer",r.pursuer),evader:t.playing("evader",r.evader)},
a=Array.from({length:(t.best?.[e]??t.newest)+1},(i,l)=>({name:`generation ${l}`,text:"",policy:()=>t.policy(e,l)}));this.#c.play(e,{world:t.world,policies:o,players:a,
seed:this.#u.seed,rate:Math.round(100*(s?.rate??0)),friend:null},{seed:String(Ar(this.#n,t.world,e==="evader"?t.world.n_pursuers:0)),episode:0})}#N(){let e=!this.
lanes[0].chases.runs;for(let{chases:t}of this.lanes)t.runs=e;this.#P()}#L(){let e=this.lanes.map(({state:t})=>t);return e.every(t=>t==="waiting")?"waiting":e.includes(
"evolving")?"evolving":e.includes("stopped")?"stopped":"ended"}#P(){if(!this.lanes.length)return;let e=this.#L();document.body.dataset.state=e,this.#a.textContent=
{waiting:"Evolve",evolving:"Stop",stopped:"Go on",ended:""}[e],this.#a.hidden=e==="ended",this.#g.textContent=this.lanes[0].chases.runs?"Pause":"Play",this.#p.hidden=
!this.#u.walls,this.#d.textContent=`Again, with seed ${this.#u.seed+1}`,this.#o.value=Math.min(...this.lanes.map(({done:a})=>a));let t=Math.max(...this.lanes.map(
a=>a.seconds)),{seed:r}=this.#u,s=this.lanes.map(a=>a.newestGeneration).join(" and ");this.#h.textContent={waiting:"",evolving:`Seed ${r}: generation ${s}`,stopped:`\
Seed ${r}: stopped at generation ${s}.`,ended:`Seed ${r}: ${s} generations in ${t.toFixed(1)} seconds.`}[e];let o=jt(this.#e,this.#_);this.#s.hidden=this.#s.value!==
this.#U(),ge()&&o.length<=Bt&&location.hash.slice(1)!==o&&history.replaceState(null,"",`#${o}`),(e==="ended"||e==="stopped")&&(this.#x=!1),e==="ended"&&this.lanes.
every(({outcome:a})=>a)&&this.#B(o),this.#D()}async#B(e){if(this.#A===e||!ge())return;this.#A=e;let t=`${this.#u.world}, seed ${this.#u.seed}: ${Z(this.lanes[0].
outcome.rate)} are caught`,r=await Promise.all(this.lanes.map(s=>s.keep()));this.#A!==e||!r.every(ys)||(Hi({address:e,title:t},r),this.#D())}#D(){let e=ge()?zi().
filter(({address:r})=>r!==location.hash.slice(1)):[],t=e.map(({address:r})=>r).join(" ");this.#i.dataset.shown!==t&&(this.#i.dataset.shown=t,this.#i.hidden=!e.length,
this.#i.replaceChildren("Races before: ",...e.map(({address:r,title:s})=>d("a",{href:`#${r}`},s))))}#U(e){let t=jt(this.#e,this.#_,e);return t.length>Bt?null:`${location.
href.split("#")[0]}#${t}`}#G(){let e=this.#U();e?Xt(this.#s,e):this.#l.textContent="This race has too many changes for a link: save it."}get#z(){let e=this.#U()??
location.href;return location.protocol==="file:"?e.slice(e.split("#")[0].lastIndexOf("/")+1):e}get#j(){let{before:e,after:t}=this.lanes[0];return[e,t].filter(({
recording:r})=>r).map(r=>({title:r.title.split(":")[0],recording:r.recording}))}#H(){Xe(`chase-seed-${this.#u.seed}.gif`,ji(this.#j))}async#V(){let{outcome:e,settings:t}=this.
lanes[0],r=[...e?.sentence.split(new RegExp("(?<=\\.) "))??[`Generation ${this.lanes[0].newestGeneration}`],`${this.#u.world}, seed ${t.seed}, ${t.schedule.generations}\
 generations of pursuers and evaders that learn against each other`,this.#z];Xe(`chase-seed-${this.#u.seed}.png`,await Gi(this.#j,r))}async#Y(){let e=await Promise.
all(this.lanes.map(async r=>({name:an(r.settings),race:await r.saved()})));if(!e.every(({race:r})=>ys(r))){this.#l.textContent="Wait for the next generation, an\
d save then.";return}let t=`${e.map(r=>r.name).join("-and-")}-seed-${this.#u.seed}.zip`;Xe(t,Li(e,this.#e)),this.#l.textContent=`Saved as ${t}.`}};async function dh(){
let n=new xs(Co(),await Jt());document.addEventListener("keydown",({key:e,target:t,ctrlKey:r,metaKey:s,altKey:o})=>{t instanceof HTMLInputElement||t instanceof HTMLSelectElement||
document.querySelector("dialog[open]")||r||s||o||(e.toLowerCase()==="d"?vr():e.toLowerCase()==="a"&&n.lanes[0].askNext())}),window.addEventListener("hashchange",
()=>location.reload()),Object.assign(window,{matrixworldEvolve:n})}typeof document>"u"?ps(globalThis):qs(dh());})();
