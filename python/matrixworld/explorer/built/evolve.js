/* built from web/ by "npm run build"; sources 375ad6f9c682ca80ffe5d51f8c090c2748043aaa7cd41730dfe01403747bff92 */
"use strict";(()=>{var ys={SIMULTANEOUS:0,SWARM_TURNS:1,AGENT_TURNS:2},dt={DISAPPEAR:0,REACH:1,BOUNCE:2},gs={OCCUPATION:0,SURROUND:1},vs={FAULT:0,INVOLVED:1};var tn=["obstacle","teammate","adversary"],rn=["vertex","edge","chain"],bs=["turn","kind","form","first","second","row","col","at_fault","held","doomed"],nn=["p\
ursuer_{number}","evader_{number}"],ws={obstacle:"{first} ran into the obstacle or border at {cell}",vertex:"{first} and {second} both headed for {cell}",edge:"\
{first} and {second} meant to swap, {first} to {cell}",chain:"{first} headed for {cell}, where {second} had to stay"},mt={"both held":"both bounce","both doomed":"\
both disappear",held:"{agent} bounces",doomed:"{agent} disappears",none:"nobody is stopped"},xs="{event}: {outcome}",sn={random:"any action, all equally likely",
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
id (0 to 1)"},Ss={free:".GS",blocked:"#@OTW"};var He=1+bs.length;function pt(r,e){return r.replace(/\{(\w+)\}/g,(t,n)=>String(e[n]))}function se(r,e){return r<e?pt(nn[0],{number:r}):pt(nn[1],{number:r-e})}function Di(r,e){
let[t,n,s,o,a,i,l,...c]=Array.from(r),u=a<0?[o]:[o,a],[h,m,p]=c.map(v=>u.filter((x,w)=>v>>w&1)),y=u.map(v=>se(v,e)),f=pt(ws[a<0?"obstacle":rn[s]],{first:y[0],second:y[y.
length-1],cell:`(${i}, ${l})`}),g=pt(xs,{event:f,outcome:Ui(u.length,m,p,e)});return{kind:tn[n],form:rn[s],agents:u,cell:[i,l],at_fault:h,held:m,doomed:p,turn:t,
text:g}}function Ui(r,e,t,n){if(r===2&&e.length===2)return mt["both held"];if(r===2&&t.length===2)return mt["both doomed"];let s=o=>a=>pt(mt[o],{agent:se(a,n)});
return[...e.map(s("held")),...t.map(s("doomed"))].join(", ")||mt.none}function Ht(r,e){let t=[];for(let n=0;n<r.length;n+=He)t.push(Di(r.subarray(n+1,n+He),e));
return t}var Me=class extends Error{name="EngineError"};function F(r,e,t){let n=typeof t=="string"?`'${t}'`:typeof t=="object"?JSON.stringify(t):String(t);return new Me(
`${r}: expected ${e}, got ${n}`)}var Ve=class{bytes;constructor(e){this.bytes=e}},Ts=0,an=[Uint8Array,Uint8Array,Int32Array,BigInt64Array,BigUint64Array,Float32Array,Float64Array],As=4,Ms=4,Wi=new TextEncoder,
Bi=new TextDecoder;function ji(r){for(let e=an.length-1;e>Ts;--e)if(r instanceof an[e])return e;throw new TypeError("array: expected a typed array of the engine\
's numbers, got another")}function on(r){return new Uint8Array(r.buffer,r.byteOffset,r.byteLength)}function zi(r){return Wi.encode(`${r}\0`)}var ln=class{engine;addresses=[];constructor(e){
this.engine=e}copy(e){let t=this.engine._malloc(Math.max(e.length,1));if(t===0)throw new Me("memory: expected room for the arguments, got none");return this.addresses.
push(t),this.engine.HEAPU8.set(e,t),t}text(e){return this.copy(zi(e))}arrays(e){let t=Object.entries(e),n=t.flatMap(([o,a])=>{let i=a instanceof Ve,l=i?a.bytes:
a;return[this.text(o),i?Ts:ji(l),l.length,this.copy(on(l))]}),s=this.copy(on(Int32Array.from(n)));return this.copy(on(Int32Array.of(t.length,s)))}free(){for(let e of this.
addresses)this.engine._free(e)}};function Es(r,e){let t=r.HEAPU8;return Bi.decode(t.subarray(e,t.indexOf(0,e)))}function Ke(r){let e=new Int32Array(r.HEAPU8.buffer),
t=r._last_outputs()/As,n=e[t+1]/As,s={};for(let o=n;o<n+e[t]*Ms;o+=Ms){let a=an[e[o+1]],i=e[o+2]*a.BYTES_PER_ELEMENT,l=e[o+3];s[Es(r,e[o])]=new a(r.HEAPU8.slice(
l,l+i).buffer)}return s}function Te(r,e){let t=new ln(r);try{let n=e(t);if(n===0)throw new Me(Es(r,r._last_error()));return n}finally{t.free()}}var Gi=2**31-1,Os=["none","gru"],Hi=2n**64n-1n,Vi=34028234663852886e22;function le(r,e){if(typeof e!="number"||!Number.isInteger(e)||Math.abs(e)>Gi)throw F(r,"a\
n integer",e);return Int32Array.of(e)}function Vt(r,e){if(typeof e!="boolean")throw F(r,"true or false",e);return new Ve(Uint8Array.of(Number(e)))}function Ne(r,e,t){
let n=typeof e=="string"&&Object.hasOwn(t,e)?t[e]:void 0;if(n===void 0)throw F(r,`one of ${Object.keys(t).join(", ")}`,e);return Int32Array.of(n)}function cn(r,e){
if(typeof e!="number"||!(Math.abs(e)<=Vi))throw F(r,"a finite number",e);return e}function ft(r,e){let n=typeof e=="bigint"||typeof e=="number"&&Number.isSafeInteger(
e)?BigInt(e):-1n;if(n<0n||n>Hi)throw F(r,"an integer from 0 to 2^64 - 1",e);return BigUint64Array.of(n)}function Ki(r){return{"rules.interaction":Ne("interactio\
n",r.interaction,ys),"rules.obstacle":Ne("obstacle",r.obstacle,dt),"rules.teammate":Ne("teammate",r.teammate,dt),"rules.evader":Ne("evader",r.evader,dt),"rules.\
pursuer":Ne("pursuer",r.pursuer,dt),"rules.capture":Ne("capture",r.capture,gs),"rules.captured_disappear":Vt("captured_disappear",r.captured_disappear)}}function Cs(r,e){
let t=typeof e=="number"?[e,e,e]:e;if(!Array.isArray(t)||t.length!==3)throw F(r,"1 or 3 numbers",e);return Float32Array.from(t,n=>cn(r,n))}function Yi(r){let e=(t,n)=>Float32Array.
of(cn(t,r[t]),cn(n,r[n]));return{"rewards.capture":e("pursuer_capture","evader_capture"),"rewards.neighbor":e("pursuer_neighbor","evader_neighbor"),"rewards.ste\
p":e("pursuer_step","evader_step"),"rewards.pursuer_collide":Cs("pursuer_collide",r.pursuer_collide),"rewards.evader_collide":Cs("evader_collide",r.evader_collide),
"rewards.blame":Ne("blame",r.blame,vs),"rewards.capture_repeats":Vt("capture_repeats",r.capture_repeats)}}function _s(r){if(r===void 0||typeof r=="number")return new Uint8Array(
0);if(r instanceof Uint8Array)return r;let{free:e,blocked:t}=Ss;for(let[n,s]of r.entries()){if(s.length!==r[0]?.length)throw F(`map, row ${n}`,`${r[0]?.length} \
cells as in row 0`,s.length);let o=[...s].find(a=>!e.includes(a)&&!t.includes(a));if(o)throw F(`map, row ${n}`,`'${e}' (free) or '${t}' (obstacle)`,o)}return Uint8Array.
from([...r.join("")],n=>Number(t.includes(n)))}function $s(r,e){if(!Array.isArray(r))return;let t=[r.length,r[0]?.length??0];if(!(t[0]===e.rows&&t[1]===e.cols))
throw F("obstacle map",`shape (${e.rows}, ${e.cols}), the rows and cols`,t)}function Ye(r){$s(r.obstacles,r);let e=typeof r.obstacles=="number"?r.obstacles:0;return{
...Ki(r.rules),...Yi(r.rewards),rows:le("rows",r.rows),cols:le("cols",r.cols),n_pursuers:le("n_pursuers",r.n_pursuers),n_evaders:le("n_evaders",r.n_evaders),fov:le(
"fov",r.fov),diagonal:Vt("diagonal",r.diagonal),max_steps:le("max_steps",r.max_steps),density:Float64Array.of(e),map:_s(r.obstacles)}}function ks(r,e){return Int32Array.
from((e??[]).flat(),t=>le(r,t)[0])}function Ps(r,e){return $s(r.obstacles,e),{seed:ft("seed",r.seed??0n),episode:ft("episode",r.episode??0),pursuers:ks("pursuer\
s",r.pursuers),evaders:ks("evaders",r.evaders),map:_s(r.obstacles)}}function Kt(r){return{actions:Int32Array.from(r,e=>le("actions",e)[0])}}var Rs=Object.keys(Pe);
function un(r){let e=Rs.indexOf(r);if(e<0)throw F("inputs",`names of ${Rs.join(", ")}`,r);return e}function Le(r){if(typeof r=="string"){if(!Object.hasOwn(sn,r))
throw F("policy",`one of ${Object.keys(sn).join(", ")}`,r);return{script:new TextEncoder().encode(r)}}if(r.kind!=="cells")return{inputs:Int32Array.from(r.inputs,
e=>un(e)),hidden:Int32Array.from(r.kind==="rating"?r.hidden:[],e=>le("hidden",e)[0]),length:le("length",r.kind==="program"?r.length:0),mask:new TextEncoder().encode(
r.mask),genome:r.genome};if(r.activation!=="relu"&&r.activation!=="tanh")throw F("activation","'relu' or 'tanh'",r.activation);if(!Os.includes(r.memory))throw F(
"memory",`one of ${Os.join(", ")}`,r.memory);return{hidden:Int32Array.from(r.hidden,e=>le("hidden",e)[0]),activation:new TextEncoder().encode(r.activation),sampled:Vt(
"sampled",r.sampled),memory:new TextEncoder().encode(r.memory),genome:r.genome}}var qi=["first_turn","terminated","truncated"];function Ns(r){let e={...r};for(let t of qi)
e[t]=new Ve(r[t]);return e}var Ls="statistics.",Yt=class{config;seed;episode;n_agents;statistics;first_conflict;constructor(e,t,n,s){this.config=e,this.seed=t,this.episode=n,this.n_agents=
e.n_pursuers+e.n_evaders,this.statistics=Zi(Is(s)),Object.assign(this,s),this.first_conflict=Ji(this.conflict_table,this.length)}get length(){return this.actions.
length/this.n_agents}conflicts(e){this.check(e);let[t,n]=[this.first_conflict[e],this.first_conflict[e+1]],s=this.conflict_table.subarray(t*He,n*He);return Ht(s,
this.config.n_pursuers)}seek(e,t,n){this.check(t),(!(e.seed===this.seed&&e.episode===BigInt(this.episode))||e.turn!==0||e.steps>t)&&e.reset({seed:this.seed,episode:this.
episode});for(let o=e.steps;o<t;++o){let a=this.actions.subarray(o*this.n_agents,(o+1)*this.n_agents);n?e.replay(a,{pursuer:n.pursuers,evader:n.evaders}):e.step(
a)}}check(e){if(!(Number.isInteger(e)&&e>=0&&e<=this.length))throw F("step",`0 to ${this.length}`,e)}};function Ji(r,e){let t=new Int32Array(e+2);for(let n=0;n<
r.length;n+=He)++t[r[n]+1];for(let n=1;n<t.length;++n)t[n]+=t[n-1];return t}function Zi(r){let e=["capture_rate","ever_capture_rate","captured_fraction","length"];
return Object.fromEntries(Object.entries(r).map(([t,n])=>[t,e.includes(t)?Number(n[0]):n]))}var Is=r=>Object.fromEntries(Object.entries(r).flatMap(([e,t])=>e.startsWith(
Ls)?[[e.slice(Ls.length),t]]:[]));function Fs(r,e,t,n){let s=[Ye(t.config),Le(t.pursuers),Le(t.evaders),n];return Te(r,o=>{let[a,i,l,c]=s.map(u=>o.arrays(u));return r[e](
a,i,l,c)}),Ke(r)}function Ds(r,e,t,n){let s={seed:ft("seed",t),episode:ft("episode",n)};return new Yt(e.config,t,n,Fs(r,"_play_match",e,s))}function Us(r,e,t,n){
if(!Number.isInteger(n)||n<1)throw F("n_episodes","at least 1",n);let s=Fs(r,"_play_rollout",e,{...t,n_episodes:Int32Array.of(n)});return Is(s)}var Xi=7e6,Qi=new FinalizationRegistry(([r,e])=>r._states_free(e));function el({rules:r,rows:e,cols:t,obstacles:n,diagonal:s,n_pursuers:o,n_evaders:a}){let i=typeof n==
"number"||r.obstacle==="REACH"?0:n.join("").split("#").length-1,l=e*t-i,c=[r.obstacle,r.teammate,r.pursuer].includes("DISAPPEAR"),u=r.capture==="SURROUND"||r.evader===
"REACH",h=r.interaction==="AGENT_TURNS",m=(f,g)=>Array.from({length:g},(v,x)=>h?f:(f+x)/(x+1)).reduce((v,x)=>v*x,1),p=m(l+Number(c),o)*m(l*(1+Number(u))+2,a);return{
SIMULTANEOUS:[o+a],SWARM_TURNS:[o,a],AGENT_TURNS:Array(o+a).fill(1)}[r.interaction].reduce((f,g)=>f+p*(s?9:5)**g,0)}function qt(r){return typeof r.obstacles=="n\
umber"&&r.obstacles>0?"obstacles are drawn anew in each episode":el(r)>Xi?"the world is too large to be solved on the page":""}var hn=class{value;teams;matrix;n_actions;constructor(e,t){
let{matrix:n,rows:s,cols:o,value:a,agents:i}=t,[l,c]=e.actors,u=Array.from(i).filter(m=>l<=m&&m<c),h=m=>m<e.config.n_pursuers;[this.value,this.matrix,this.n_actions]=
[a[0],n,e.n_actions],this.teams=[{agents:u.filter(h),play:s},{agents:u.filter(m=>!h(m)),play:o}]}marginal(e){let t=this.teams.find(({agents:o})=>o.includes(e));
if(!t)return null;let n=this.n_actions**(t.agents.length-1-t.agents.indexOf(e)),s=Array(this.n_actions).fill(0);return t.play.forEach((o,a)=>s[Math.floor(a/n)%this.
n_actions]+=o),s}lost(e){let[t,n]=this.teams.map(({agents:l})=>l.reduce((c,u)=>c*this.n_actions+e[u],0)),[s,o]=this.teams.map(({play:l})=>l),a=o.reduce((l,c,u)=>l+
c*this.matrix[t*o.length+u],0),i=s.reduce((l,c,u)=>l+c*this.matrix[u*o.length+n],0);return[Math.max(0,this.value-a),Math.max(0,i-this.value)]}},dn=60,yt=class{config;payoff;engine;states;n_turns;values;constructor(e,t,n){
[this.engine,this.config,this.payoff]=[e,t,n],this.states=Te(e,i=>e._states_new(i.arrays(Ye(t)))),Qi.register(this,[e,this.states]);let s={SIMULTANEOUS:1,SWARM_TURNS:2,
AGENT_TURNS:t.n_pursuers+t.n_evaders};this.n_turns=s[t.rules.interaction];let{payoffs:o}=this.call(()=>e._states_payoffs(this.states)),a=o;this.values=[[n==="ca\
pture-rate"?a:a.fill(0)]]}goBack(){let e=this.values.at(-1)[0],t=[];for(let s=this.n_turns-1;s>=0;s--){let o=t[s+1]??e;t[s]=this.backup(s,{next:o})}this.payoff===
"capture-time"&&(t[0]=t[0].map((s,o)=>o===this.config.n_evaders?0:s-1)),this.values.push(t);let n=this.payoff==="capture-rate"?this.config.max_steps:Math.min(this.
config.max_steps,dn);return this.values.length<=n&&t[0].some((s,o)=>s!==e[o])}backup(e,t){return this.call(n=>this.engine._states_backup(this.states,e,n.arrays(
t))).values}game(e){let[t,{turn:n}]=[this.config.max_steps-e.steps,e],s=n+1===this.n_turns,o=t>0?this.values[Math.min(t-Number(s),this.values.length-1)]?.[s?0:n+
1]:void 0;if(!o)return null;let a=this.call(i=>this.engine._states_game(this.states,e.address,i.arrays({next:o})));return a.agents.length?new hn(e,a):null}call(e){
return Te(this.engine,e),Ke(this.engine)}};var Ws=new FinalizationRegistry(([r,e])=>r._world_free(e)),gt=class{config;n_agents;n_actions;engine;at;freed=!1;constructor(e,t){this.engine=e,this.config=t,this.
n_agents=t.n_pursuers+t.n_evaders,this.n_actions=t.diagonal?9:5,this.at=Te(e,n=>e._world_new(n.arrays(Ye(t)))),Ws.register(this,[e,this.at],this)}free(){this.freed||
(this.freed=!0,Ws.unregister(this),this.engine._world_free(this.at))}get address(){if(this.freed)throw F("world","one that is in use","one that was freed");return this.
at}reset(e={}){let t=Ps(e,this.config);this.call(n=>this.engine._world_reset(this.address,n.arrays(t)))}step(e){let t=Kt(e);this.call(n=>this.engine._world_step(
this.address,n.arrays(t)))}playTurn(e){let t=Kt(e);this.call(n=>this.engine._world_play_turn(this.address,n.arrays(t)))}decide(e,t,n){let{n_pursuers:s}=this.config,
o={pursuer:[0,s],evader:[s,this.n_agents]},[a,i]=typeof t=="string"?o[t]:t;if(n.length!==this.n_agents)throw F("actions",String(this.n_agents),n.length);let l=[
Le(e),Kt(n)],{actions:c}=this.call(u=>this.engine._world_decide(this.address,u.arrays(l[0]),a,i,u.arrays(l[1])));return Uint8Array.from(c)}replay(e,t){let n=o=>typeof o!=
"string"&&o.kind==="cells"&&o.memory!=="none";if(!n(t.pursuer)&&!n(t.evader))return this.step(e);let{n_pursuers:s}=this.config;for(let o=this.n_turns;o>0;--o){let[
a,i]=this.actors;a<s&&this.decide(t.pursuer,[a,Math.min(i,s)],e),i>s&&this.decide(t.evader,[Math.max(a,s),i],e),this.playTurn(e)}}get n_turns(){return this.turnNumbers()[1]}get turn(){
return this.turnNumbers()[0]}get actors(){let[,,e,t]=this.turnNumbers();return[e,t]}turnNumbers(){return this.call(()=>this.engine._world_turn(this.address)).turn}get steps(){
return this.read("steps")[0]}get seed(){return this.read("seed")[0]}get episode(){return this.read("episode")[0]}get over(){return this.read("terminated")[0]===
1||this.read("truncated")[0]===1}read(e){return this.call(t=>this.engine._world_read(this.address,t.text(e)))[e]}view(e){let t=3*this.config.fov**2;return this.
read("views").slice(e*t,(e+1)*t)}map(){return this.read("state").slice(2*this.config.rows*this.config.cols)}conflicts(){return Ht(this.conflictTable(),this.config.
n_pursuers)}conflictTable(){return this.call(()=>this.engine._world_conflicts(this.address)).conflict_table}answer(e,t){let n=Le(e),{logits:s,memory:o}=this.call(
l=>this.engine._world_logits(this.address,l.arrays(n),t)),a=s,i=this.decide(e,[t,t+1],new Uint8Array(this.n_agents))[t];return{logits:a,probabilities:tl(a),action:i,
memory:o}}rate(e,t){let n=Le(e),{ratings:s,refused:o}=this.call(c=>this.engine._world_rate(this.address,c.arrays(n),t)),a=this.read("inputs"),i=a.length/this.n_agents/
this.n_actions,l=c=>Float32Array.from({length:this.n_actions},(u,h)=>a[(t*this.n_actions+h)*i+c]);return{inputs:e.inputs.map(c=>l(un(c))),ratings:s,refused:o}}snapshot(){
return this.call(()=>this.engine._world_snapshot(this.address))}restore(e){let t=Ns(e);this.call(n=>this.engine._world_restore(this.address,n.arrays(t)))}call(e){
return Te(this.engine,e),Ke(this.engine)}};function tl(r){let e=Math.max(...r),t=Array.from(r,s=>Math.exp(s-e)),n=t.reduce((s,o)=>s+o,0);return Float32Array.from(
t,s=>s/n)}var mn=class{compiled;constructor(e){this.compiled=e}world(e){return new gt(this.compiled,e)}solution(e,t="capture-rate"){return new yt(this.compiled,e,t)}match(e,t,n,s,o=0){
return Ds(this.compiled,{config:e,pursuers:t,evaders:n},s,o)}rollouts(e,t,n,s,o){return Us(this.compiled,{config:e,pursuers:t,evaders:n},s,o)}},Bs;function Jt(r=globalThis.
matrixworldEngine){return Bs??=rl(r),Bs}async function rl(r){if(!r)throw new Error("matrixworldEngine: expected the script engine.js before this one, got none");
let e=Uint8Array.from(atob(r.binary),t=>t.charCodeAt(0));return new mn(await r({wasmBinary:e}))}var nl="http://www.w3.org/2000/svg";function d(r,e={},...t){return js(document.createElement(r),e,t)}function S(r,e={},...t){return js(document.createElementNS(
nl,r),e,t)}function js(r,e,t){for(let[s,o]of Object.entries(e))o==null||o===!1||(typeof o=="function"?r.addEventListener(s.slice(2),o):r.setAttribute(s,o===!0?"":
String(o)));let n=t.filter(s=>s!=null&&s!==!1);return r.append(...n.map(s=>typeof s=="number"?String(s):s)),r}function Q(r,e){let t=d("select",{onchange:()=>e(t.
value)},...r.map(([n,s])=>d("option",{value:n},s)));return t}async function zs(r){try{await r}catch(e){let t=document.querySelector("#page, main")??document.body;
throw t.querySelector(".absent")?.remove(),t.prepend(d("p",{class:"card problem",role:"alert"},e instanceof WebAssembly.CompileError||/WebAssembly/.test(String(
e))?"This page plays by WebAssembly, which is forbidden where it lies ('wasm-unsafe-eval' is missing in the content policy): save the file, and open it from you\
r disk.":`The page could not start: ${String(e)}`)),e}finally{document.body.dataset.ready="true"}}var he=()=>["file:","http:","https:"].includes(location.protocol);var Zt=r=>d("input",{type:"text",readonly:!0,"aria-label":r});function Xt(r,e){r.value=e,r.hidden=!1,r.select(),navigator.clipboard?.writeText(e).catch(()=>{})}
function qe(r,e){let t=URL.createObjectURL(new Blob([e],{type:"application/octet-stream"}));d("a",{href:t,download:r}).click(),setTimeout(()=>URL.revokeObjectURL(
t),6e4)}var Gs=()=>document.documentElement.dataset.theme==="dark",vt=r=>{document.documentElement.dataset.theme=r?"dark":"light"},pn=()=>vt(!Gs());if(typeof document<"\
u"){let r=matchMedia("(prefers-color-scheme: dark)");r.addEventListener("change",()=>vt(r.matches)),vt(r.matches);let e=!1;addEventListener("beforeprint",()=>{e=
Gs(),vt(!1)}),addEventListener("afterprint",()=>vt(e))}function Hs(){return d("button",{type:"button",title:"Light or dark (D)","aria-label":"Light or dark",onclick:pn},
"◐")}var Vs=(r,e,...t)=>d("header",{class:"top"},d("div",{},d("h1",{},r),e?d("p",{class:"lead"},e):null),d("div",{class:"tools"},...t,Hs()));var sl=Array.from({length:16},(r,e)=>{let[t,n]=[e%2?6.5:11,Math.PI*e/8];return`${12+t*Math.sin(n)} ${12-t*Math.cos(n)}`}).join(" ");function Qt(){let r=[["pursu\
er",S("path",{d:"M12 3 22 20H2z",class:"filled-pursuer"})],["evader",S("circle",{cx:12,cy:12,r:9,class:"filled-evader"})],["capture",S("polygon",{points:sl,class:"\
filled-capture"})],["captured evader",S("circle",{cx:12,cy:12,r:7.5,class:"ring-evader"})],["conflict",S("rect",{x:3,y:3,width:18,height:18,class:"dashed-confli\
ct"})]];return d("ul",{class:"shapes small","aria-label":"Shapes on the board"},...r.map(([e,t])=>d("li",{},S("svg",{viewBox:"0 0 24 24","aria-hidden":"true"},t),
e)))}var ee=["stay","north","east","south","west","northeast","southeast","southwest","northwest"];var Ks="champion",Ys=0,fn=64,yn=100;var ol=(r,e)=>Object.keys(r).every(t=>r[t]===e[t]);function qs(r,e){return Object.keys(e).find(t=>ol(e[t],r))??null}function Js(r,e,t){let n=new Set(r);return Array.
from({length:e},(s,o)=>Array.from({length:t},(a,i)=>n.has(o*t+i)?"#":".").join(""))}function er(r,e,t){let n=r.filter(s=>s!==e);return t?[...n,e].sort((s,o)=>s-
o):n}var I=Uint8Array,te=Uint16Array,Tn=Int32Array,tr=new I([0,0,0,0,0,0,0,0,1,1,1,1,2,2,2,2,3,3,3,3,4,4,4,4,5,5,5,5,0,0,0,0]),rr=new I([0,0,0,0,1,1,2,2,3,3,4,4,5,5,
6,6,7,7,8,8,9,9,10,10,11,11,12,12,13,13,0,0]),wn=new I([16,17,18,0,8,7,9,6,10,5,11,4,12,3,13,2,14,1,15]),ro=function(r,e){for(var t=new te(31),n=0;n<31;++n)t[n]=
e+=1<<r[n-1];for(var s=new Tn(t[30]),n=1;n<30;++n)for(var o=t[n];o<t[n+1];++o)s[o]=o-t[n]<<5|n;return{b:t,r:s}},no=ro(tr,2),so=no.b,xn=no.r;so[28]=258,xn[258]=28;
var oo=ro(rr,0),al=oo.b,Zs=oo.r,Sn=new te(32768);for(C=0;C<32768;++C)ge=(C&43690)>>1|(C&21845)<<1,ge=(ge&52428)>>2|(ge&13107)<<2,ge=(ge&61680)>>4|(ge&3855)<<4,Sn[C]=
((ge&65280)>>8|(ge&255)<<8)>>1;var ge,C,de=(function(r,e,t){for(var n=r.length,s=0,o=new te(e);s<n;++s)r[s]&&++o[r[s]-1];var a=new te(e);for(s=1;s<e;++s)a[s]=a[s-
1]+o[s-1]<<1;var i;if(t){i=new te(1<<e);var l=15-e;for(s=0;s<n;++s)if(r[s])for(var c=s<<4|r[s],u=e-r[s],h=a[r[s]-1]++<<u,m=h|(1<<u)-1;h<=m;++h)i[Sn[h]>>l]=c}else
for(i=new te(n),s=0;s<n;++s)r[s]&&(i[s]=Sn[a[r[s]-1]++]>>15-r[s]);return i}),Ee=new I(288);for(C=0;C<144;++C)Ee[C]=8;var C;for(C=144;C<256;++C)Ee[C]=9;var C;for(C=
256;C<280;++C)Ee[C]=7;var C;for(C=280;C<288;++C)Ee[C]=8;var C,xt=new I(32);for(C=0;C<32;++C)xt[C]=5;var C,il=de(Ee,9,0),ll=de(Ee,9,1),cl=de(xt,5,0),ul=de(xt,5,1),
gn=function(r){for(var e=r[0],t=1;t<r.length;++t)r[t]>e&&(e=r[t]);return e},ce=function(r,e,t){var n=e/8|0;return(r[n]|r[n+1]<<8)>>(e&7)&t},vn=function(r,e){var t=e/
8|0;return(r[t]|r[t+1]<<8|r[t+2]<<16)>>(e&7)},En=function(r){return(r+7)/8|0},On=function(r,e,t){return(e==null||e<0)&&(e=0),(t==null||t>r.length)&&(t=r.length),
new I(r.subarray(e,t))};var hl=["unexpected EOF","invalid block type","invalid length/literal","invalid distance","stream finished","no stream handler",,"no callback","invalid UTF-8 da\
ta","extra field too long","date not in range 1980-2099","filename too long","stream finishing","invalid zip data"],q=function(r,e,t){var n=new Error(e||hl[r]);
if(n.code=r,Error.captureStackTrace&&Error.captureStackTrace(n,q),!t)throw n;return n},dl=function(r,e,t,n){var s=r.length,o=n?n.length:0;if(!s||e.f&&!e.l)return t||
new I(0);var a=!t,i=a||e.i!=2,l=e.i;a&&(t=new I(s*3));var c=function(ut){var ht=t.length;if(ut>ht){var Ge=new I(Math.max(ht*2,ut));Ge.set(t),t=Ge}},u=e.f||0,h=e.
p||0,m=e.b||0,p=e.l,y=e.d,f=e.m,g=e.n,v=s*8;do{if(!p){u=ce(r,h,1);var x=ce(r,h+1,3);if(h+=3,x)if(x==1)p=ll,y=ul,f=9,g=5;else if(x==2){var k=ce(r,h,31)+257,R=ce(
r,h+10,15)+4,E=k+ce(r,h+5,31)+1;h+=14;for(var A=new I(E),D=new I(19),_=0;_<R;++_)D[wn[_]]=ce(r,h+_*3,7);h+=R*3;for(var j=gn(D),Ae=(1<<j)-1,J=de(D,j,1),_=0;_<E;){
var K=J[ce(r,h,Ae)];h+=K&15;var w=K>>4;if(w<16)A[_++]=w;else{var U=0,N=0;for(w==16?(N=3+ce(r,h,3),h+=2,U=A[_-1]):w==17?(N=3+ce(r,h,7),h+=3):w==18&&(N=11+ce(r,h,
127),h+=7);N--;)A[_++]=U}}var Y=A.subarray(0,k),W=A.subarray(k);f=gn(Y),g=gn(W),p=de(Y,f,1),y=de(W,g,1)}else q(1);else{var w=En(h)+4,b=r[w-4]|r[w-3]<<8,O=w+b;if(O>
s){l&&q(0);break}i&&c(m+b),t.set(r.subarray(w,O),m),e.b=m+=b,e.p=h=O*8,e.f=u;continue}if(h>v){l&&q(0);break}}i&&c(m+131072);for(var ct=(1<<f)-1,ne=(1<<g)-1,ye=h;;ye=
h){var U=p[vn(r,h)&ct],Z=U>>4;if(h+=U&15,h>v){l&&q(0);break}if(U||q(2),Z<256)t[m++]=Z;else if(Z==256){ye=h,p=null;break}else{var X=Z-254;if(Z>264){var _=Z-257,L=tr[_];
X=ce(r,h,(1<<L)-1)+so[_],h+=L}var ue=y[vn(r,h)&ne],je=ue>>4;ue||q(3),h+=ue&15;var W=al[je];if(je>3){var L=rr[je];W+=vn(r,h)&(1<<L)-1,h+=L}if(h>v){l&&q(0);break}
i&&c(m+131072);var ze=m+X;if(m<W){var zt=o-W,Gt=Math.min(W,ze);for(zt+m<0&&q(3);m<Gt;++m)t[m]=n[zt+m]}for(;m<ze;++m)t[m]=t[m-W]}}e.l=p,e.p=ye,e.b=m,e.f=u,p&&(u=
1,e.m=f,e.d=y,e.n=g)}while(!u);return m!=t.length&&a?On(t,0,m):t.subarray(0,m)},ve=function(r,e,t){t<<=e&7;var n=e/8|0;r[n]|=t,r[n+1]|=t>>8},bt=function(r,e,t){
t<<=e&7;var n=e/8|0;r[n]|=t,r[n+1]|=t>>8,r[n+2]|=t>>16},bn=function(r,e){for(var t=[],n=0;n<r.length;++n)r[n]&&t.push({s:n,f:r[n]});var s=t.length,o=t.slice();if(!s)
return{t:io,l:0};if(s==1){var a=new I(t[0].s+1);return a[t[0].s]=1,{t:a,l:1}}t.sort(function(O,k){return O.f-k.f}),t.push({s:-1,f:25001});var i=t[0],l=t[1],c=0,
u=1,h=2;for(t[0]={s:-1,f:i.f+l.f,l:i,r:l};u!=s-1;)i=t[t[c].f<t[h].f?c++:h++],l=t[c!=u&&t[c].f<t[h].f?c++:h++],t[u++]={s:-1,f:i.f+l.f,l:i,r:l};for(var m=o[0].s,n=1;n<
s;++n)o[n].s>m&&(m=o[n].s);var p=new te(m+1),y=An(t[u-1],p,0);if(y>e){var n=0,f=0,g=y-e,v=1<<g;for(o.sort(function(k,R){return p[R.s]-p[k.s]||k.f-R.f});n<s;++n){
var x=o[n].s;if(p[x]>e)f+=v-(1<<y-p[x]),p[x]=e;else break}for(f>>=g;f>0;){var w=o[n].s;p[w]<e?f-=1<<e-p[w]++-1:++n}for(;n>=0&&f;--n){var b=o[n].s;p[b]==e&&(--p[b],
++f)}y=e}return{t:new I(p),l:y}},An=function(r,e,t){return r.s==-1?Math.max(An(r.l,e,t+1),An(r.r,e,t+1)):e[r.s]=t},Xs=function(r){for(var e=r.length;e&&!r[--e];)
;for(var t=new te(++e),n=0,s=r[0],o=1,a=function(l){t[n++]=l},i=1;i<=e;++i)if(r[i]==s&&i!=e)++o;else{if(!s&&o>2){for(;o>138;o-=138)a(32754);o>2&&(a(o>10?o-11<<5|
28690:o-3<<5|12305),o=0)}else if(o>3){for(a(s),--o;o>6;o-=6)a(8304);o>2&&(a(o-3<<5|8208),o=0)}for(;o--;)a(s);o=1,s=r[i]}return{c:t.subarray(0,n),n:e}},wt=function(r,e){
for(var t=0,n=0;n<e.length;++n)t+=r[n]*e[n];return t},ao=function(r,e,t){var n=t.length,s=En(e+2);r[s]=n&255,r[s+1]=n>>8,r[s+2]=r[s]^255,r[s+3]=r[s+1]^255;for(var o=0;o<
n;++o)r[s+o+4]=t[o];return(s+4+n)*8},Qs=function(r,e,t,n,s,o,a,i,l,c,u){ve(e,u++,t),++s[256];for(var h=bn(s,15),m=h.t,p=h.l,y=bn(o,15),f=y.t,g=y.l,v=Xs(m),x=v.c,
w=v.n,b=Xs(f),O=b.c,k=b.n,R=new te(19),E=0;E<x.length;++E)++R[x[E]&31];for(var E=0;E<O.length;++E)++R[O[E]&31];for(var A=bn(R,7),D=A.t,_=A.l,j=19;j>4&&!D[wn[j-1]];--j)
;var Ae=c+5<<3,J=wt(s,Ee)+wt(o,xt)+a,K=wt(s,m)+wt(o,f)+a+14+3*j+wt(R,D)+2*R[16]+3*R[17]+7*R[18];if(l>=0&&Ae<=J&&Ae<=K)return ao(e,u,r.subarray(l,l+c));var U,N,Y,
W;if(ve(e,u,1+(K<J)),u+=2,K<J){U=de(m,p,0),N=m,Y=de(f,g,0),W=f;var ct=de(D,_,0);ve(e,u,w-257),ve(e,u+5,k-1),ve(e,u+10,j-4),u+=14;for(var E=0;E<j;++E)ve(e,u+3*E,
D[wn[E]]);u+=3*j;for(var ne=[x,O],ye=0;ye<2;++ye)for(var Z=ne[ye],E=0;E<Z.length;++E){var X=Z[E]&31;ve(e,u,ct[X]),u+=D[X],X>15&&(ve(e,u,Z[E]>>5&127),u+=Z[E]>>12)}}else
U=il,N=Ee,Y=cl,W=xt;for(var E=0;E<i;++E){var L=n[E];if(L>255){var X=L>>18&31;bt(e,u,U[X+257]),u+=N[X+257],X>7&&(ve(e,u,L>>23&31),u+=tr[X]);var ue=L&31;bt(e,u,Y[ue]),
u+=W[ue],ue>3&&(bt(e,u,L>>5&8191),u+=rr[ue])}else bt(e,u,U[L]),u+=N[L]}return bt(e,u,U[256]),u+N[256]},ml=new Tn([65540,131080,131088,131104,262176,1048704,1048832,
2114560,2117632]),io=new I(0),pl=function(r,e,t,n,s,o){var a=o.z||r.length,i=new I(n+a+5*(1+Math.ceil(a/7e3))+s),l=i.subarray(n,i.length-s),c=o.l,u=(o.r||0)&7;if(e){
u&&(l[0]=o.r>>3);for(var h=ml[e-1],m=h>>13,p=h&8191,y=(1<<t)-1,f=o.p||new te(32768),g=o.h||new te(y+1),v=Math.ceil(t/3),x=2*v,w=function(en){return(r[en]^r[en+1]<<
v^r[en+2]<<x)&y},b=new Tn(25e3),O=new te(288),k=new te(32),R=0,E=0,A=o.i||0,D=0,_=o.w||0,j=0;A+2<a;++A){var Ae=w(A),J=A&32767,K=g[Ae];if(f[J]=K,g[Ae]=J,_<=A){var U=a-
A;if((R>7e3||D>24576)&&(U>423||!c)){u=Qs(r,l,0,b,O,k,E,D,j,A-j,u),D=R=E=0,j=A;for(var N=0;N<286;++N)O[N]=0;for(var N=0;N<30;++N)k[N]=0}var Y=2,W=0,ct=p,ne=J-K&32767;
if(U>2&&Ae==w(A-ne))for(var ye=Math.min(m,U)-1,Z=Math.min(32767,A),X=Math.min(258,U);ne<=Z&&--ct&&J!=K;){if(r[A+Y]==r[A+Y-ne]){for(var L=0;L<X&&r[A+L]==r[A+L-ne];++L)
;if(L>Y){if(Y=L,W=ne,L>ye)break;for(var ue=Math.min(ne,L-2),je=0,N=0;N<ue;++N){var ze=A-ne+N&32767,zt=f[ze],Gt=ze-zt&32767;Gt>je&&(je=Gt,K=ze)}}}J=K,K=f[J],ne+=
J-K&32767}if(W){b[D++]=268435456|xn[Y]<<18|Zs[W];var ut=xn[Y]&31,ht=Zs[W]&31;E+=tr[ut]+rr[ht],++O[257+ut],++k[ht],_=A+Y,++R}else b[D++]=r[A],++O[r[A]]}}for(A=Math.
max(A,_);A<a;++A)b[D++]=r[A],++O[r[A]];u=Qs(r,l,c,b,O,k,E,D,j,A-j,u),c||(o.r=u&7|l[u/8|0]<<3,u-=7,o.h=g,o.p=f,o.i=A,o.w=_)}else{for(var A=o.w||0;A<a+c;A+=65535){
var Ge=A+65535;Ge>=a&&(l[u/8|0]=c,Ge=a),u=ao(l,u+1,r.subarray(A,Ge))}o.i=a}return On(i,0,n+En(u)+s)},fl=(function(){for(var r=new Int32Array(256),e=0;e<256;++e){
for(var t=e,n=9;--n;)t=(t&1&&-306674912)^t>>>1;r[e]=t}return r})(),yl=function(){var r=-1;return{p:function(e){for(var t=r,n=0;n<e.length;++n)t=fl[t&255^e[n]]^t>>>
8;r=t},d:function(){return~r}}};var gl=function(r,e,t,n,s){if(!s&&(s={l:1},e.dictionary)){var o=e.dictionary.subarray(-32768),a=new I(o.length+r.length);a.set(o),a.set(r,o.length),r=a,s.w=o.length}
return pl(r,e.level==null?6:e.level,e.mem==null?s.l?Math.ceil(Math.max(8,Math.min(13,Math.log(r.length)))*1.5):20:12+e.mem,t,n,s)},lo=function(r,e){var t={};for(var n in r)
t[n]=r[n];for(var n in e)t[n]=e[n];return t};var B=function(r,e,t){for(;t;++e)r[e]=t,t>>>=8};var vl=function(r,e){return((r[0]&15)!=8||r[0]>>4>7||(r[0]<<8|r[1])%31)&&q(6,"invalid zlib data"),(r[1]>>5&1)==+!e&&q(6,"invalid zlib data: "+(r[1]&32?"need":"u\
nexpected")+" dictionary"),(r[1]>>3&4)+2};function bl(r,e){return gl(r,e||{},0,0)}function co(r,e){return dl(r.subarray(vl(r,e&&e.dictionary),-4),{i:2},e&&e.out,e&&e.dictionary)}var uo=function(r,e,t,n){for(var s in r){var o=r[s],a=e+s,i=n;Array.isArray(o)&&(i=lo(n,o[1]),o=o[0]),o instanceof I?t[a]=[o,i]:(t[a+="/"]=[new I(0),i],uo(o,a,t,
n))}},eo=typeof TextEncoder<"u"&&new TextEncoder,wl=typeof TextDecoder<"u"&&new TextDecoder,xl=0;try{wl.decode(io,{stream:!0}),xl=1}catch{}function Ie(r,e){if(e){for(var t=new I(r.length),n=0;n<r.length;++n)t[n]=r.charCodeAt(n);return t}if(eo)return eo.encode(r);for(var s=r.length,o=new I(r.length+
(r.length>>1)),a=0,i=function(u){o[a++]=u},n=0;n<s;++n){if(a+5>o.length){var l=new I(a+8+(s-n<<1));l.set(o),o=l}var c=r.charCodeAt(n);c<128||e?i(c):c<2048?(i(192|
c>>6),i(128|c&63)):c>55295&&c<57344?(c=65536+(c&1047552)|r.charCodeAt(++n)&1023,i(240|c>>18),i(128|c>>12&63),i(128|c>>6&63),i(128|c&63)):(i(224|c>>12),i(128|c>>
6&63),i(128|c&63))}return On(o,0,a)}var Mn=function(r){var e=0;if(r)for(var t in r){var n=r[t].length;n>65535&&q(9),e+=n+4}return e},to=function(r,e,t,n,s,o,a,i){var l=n.length,c=t.extra,u=i&&i.length,
h=Mn(c);B(r,e,a!=null?33639248:67324752),e+=4,a!=null&&(r[e++]=20,r[e++]=t.os),r[e]=20,e+=2,r[e++]=t.flag<<1|(o<0&&8),r[e++]=s&&8,r[e++]=t.compression&255,r[e++]=
t.compression>>8;var m=new Date(t.mtime==null?Date.now():t.mtime),p=m.getFullYear()-1980;if((p<0||p>119)&&q(10),B(r,e,p<<25|m.getMonth()+1<<21|m.getDate()<<16|m.
getHours()<<11|m.getMinutes()<<5|m.getSeconds()>>1),e+=4,o!=-1&&(B(r,e,t.crc),B(r,e+4,o<0?-o-2:o),B(r,e+8,t.size)),B(r,e+12,l),B(r,e+14,h),e+=16,a!=null&&(B(r,e,
u),B(r,e+6,t.attrs),B(r,e+10,a),e+=14),r.set(n,e),e+=l,h)for(var y in c){var f=c[y],g=f.length;B(r,e,+y),B(r,e+2,g),r.set(f,e+4),e+=4+g}return u&&(r.set(i,e),e+=
u),e},Sl=function(r,e,t,n,s){B(r,e,101010256),B(r,e+8,t),B(r,e+10,t),B(r,e+12,n),B(r,e+16,s)};function nr(r,e){e||(e={});var t={},n=[];uo(r,"",t,e);var s=0,o=0;for(var a in t){var i=t[a],l=i[0],c=i[1],u=c.level==0?0:8,h=Ie(a),m=h.length,p=c.comment,y=p&&
Ie(p),f=y&&y.length,g=Mn(c.extra);m>65535&&q(11);var v=u?bl(l,c):l,x=v.length,w=yl();w.p(l),n.push(lo(c,{size:l.length,crc:w.d(),c:v,f:h,m:y,u:m!=a.length||y&&p.
length!=f,o:s,compression:u})),s+=30+m+g+x,o+=76+2*(m+g)+(f||0)+x}for(var b=new I(o+22),O=s,k=o-s,R=0;R<n.length;++R){var h=n[R];to(b,h.o,h,h.f,h.u,h.c.length);
var E=30+h.f.length+Mn(h.extra);b.set(h.c,h.o+E),to(b,s,h,h.f,h.u,h.c.length,h.o,h.m),s+=16+E+(h.m?h.m.length:0)}return Sl(b,s,n.length,k,O),b}var G=(r,e=2)=>r==null?"-":r.toFixed(e);function ho(r,e,t){return e===null||t===null?G(r):`${G(r)} (${G(e)} to ${G(t)})`}function Je(r){let e=Math.abs(r),t=e>=1e4?
e.toExponential(0):e.toFixed(e<100?2:0);return r<0&&Number(t)?`−${t}`:t}var sr=r=>r.charAt(0).toUpperCase()+r.slice(1);function St(r,e,t,n=!1){let s=(e-r)/Math.max(1,t),o=10**Math.floor(Math.log10(s||1)),a=[1,2,5,10].map(c=>c*o).find(
c=>c>=s)??10*o;n&&(a=Math.max(1,Math.round(a)));let i=Math.ceil(r/a-1e-9),l=Math.floor(e/a+1e-9);return Array.from({length:Math.max(0,l-i+1)},(c,u)=>(i+u)*a)}var Al={teams:{pursuer:"pursuers",evader:"evaders"},generation:{pursuer:"pursuer generation",evader:"evader generation"},score:"capture rate",means:{pursuer:"ca\
ptures",evader:"escapes"},curves:{pursuer:"captures",evader:"escapes"},ends:["0 all escape","1 all caught"],lead:"Each cell is a match between two generations: \
the brighter, the more evaders are captured. Click one to watch it.",click:"watch its match"},Ml=([r,e])=>({teams:{pursuer:r,evader:e},generation:{pursuer:`gene\
ration of ${r}`,evader:`generation of ${e}`},score:`score of the ${r}`,means:{pursuer:r,evader:e},curves:{pursuer:"scores",evader:"scores"},ends:[`0 the ${e} wi\
n`,`1 the ${r} win`],lead:`Each cell is a pair of generations: the brighter, the higher the score of the ${r}. Click one to see more of it.`,click:"see more of \
it"}),Oe=({game:r})=>r?Ml(r.teams):Al,re=(r,e,t)=>`${Oe(r).teams[e]} of generation ${t}`,Tl=200;function mo(r,e,{pursuer:t,evader:n},s){let{text:o,image:a}=e.shows[`${t}\
 ${n}`]??{},i=Ce(r,t,n)?.rates??[],l=`Scores of the ${e.teams[0]} in ${i.length} episodes: ${i.map(c=>G(c)).join(", ")}`;return[o===void 0?null:d("pre",{tabindex:0,
"aria-label":"What the game shows of this pair"},o),a===void 0?null:d("img",{src:a,alt:"What the game shows of this pair",onload:({target:c})=>c.classList.toggle(
"pixels",c.naturalWidth<Tl)}),...(o??a)===void 0?[d("p",{class:"muted"},e.missing),El(r,e,t,n,s)]:[],i.length>1?d("p",{class:"small numbers"},l):null].filter(c=>c!==
null)}function El(r,e,t,n,s){let o=Object.keys(e.shows).map(u=>u.split(" ").map(Number)),a=([u,h])=>(u-t)**2+(h-n)**2,[i,l]=o.sort((u,h)=>a(u)-a(h))[0]??[];if(i===
void 0||l===void 0)return null;let c=`${re(r,"pursuer",i)} against ${re(r,"evader",l)}`;return d("p",{},d("button",{type:"button",onclick:()=>s.select({pursuer:i,
evader:l})},`Nearest: ${c}`))}var At=["pursuer","evader"];function Ce(r,e,t){let[n,s]=[e-r.payoff.first[0],t-r.payoff.first[1]],o=r.payoff.capture_rate[n]?.[s];return o===void 0?null:{rate:o,rates:r.payoff.capture_rates[n][s],
lengths:r.payoff.lengths[n]?.[s]??[]}}function po(r,e,t){let{script:n,policy:s,kept:o,genomes:a}=r.teams[e];if(n!==null||s===null)return"";if(!o.includes(t))return`\
The page holds no genome of ${re(r,e,t)}: it would be too large. Choose a generation of ${o.join(", ")}.`;let i=o.length*s.genome_size;return bo(a,s.genome_size).
length===i?"":`The page is damaged: it does not hold the ${i} numbers of the ${e}s' genomes. Write it again from its run.`}function ke(r,e,t){let{script:n,policy:s,
kept:o,genomes:a}=r.teams[e];if(n!==null||s===null)return n??"random";let i=o.indexOf(t);if(i<0)throw new RangeError(`${e}: expected a generation whose genome t\
he page holds, got ${t}`);let l=s.genome_size,c=bo(a,l).subarray(i*l,(i+1)*l);return{...s,genome:c}}var fo=({teams:r},e)=>(r[e].policy??{kind:"cells"}).kind!=="\
cells",yo=({teams:r},e,t)=>r[e].expressions?.[r[e].kept.indexOf(t)]??"";function go(r,e,{pursuer:t,evader:n,episode:s,seed:o}){let a=e.seeds[t][n];return r.match(
e.world,ke(e,"pursuer",t),ke(e,"evader",n),BigInt(o??a),s)}var Cn=4,kn=new Map,vo=(r,e)=>{kn.set(r,e)};function bo(r,e){let t=kn.get(r);if(t)return t;let n=new Float32Array;
try{let s=Cl(Rn(r),e);s.every(Number.isFinite)&&(n=s)}catch(s){if(!(s instanceof DOMException||s instanceof RangeError||Ol(s)))throw s}return kn.set(r,n),n}var Ol=r=>r instanceof
Error&&"code"in r;function Cl(r,e){let t=co(r),n=t.length/Cn,s=new Uint8Array(t.length);for(let a=0;a<s.length;a++)s[a]=t[a%Cn*n+Math.floor(a/Cn)];let o=new Uint32Array(
s.buffer);for(let a=e;a<o.length;a++)o[a]^=o[a-e];return new Float32Array(s.buffer)}function Rn(r){let e=atob(me(r)),t=new Uint8Array(e.length);for(let n=0;n<t.
length;n++)t[n]=e.charCodeAt(n);return t}var me=r=>document.getElementById(r)?.textContent??"";function _n(r,e,t){let{rows:n,cols:s,n_pursuers:o,fov:a,rules:{interaction:i}}=r;return{rows:n,cols:s,nPursuers:o,fov:a,interaction:i,obstacles:e,moments:t}}function $n(r,e){
return{positions:r.read("last_positions"),alive:r.read("alive"),captured:r.read("captured"),everCaptured:r.read("ever_captured"),actions:e,involved:r.read("invo\
lved"),fault:r.read("fault"),contested:r.conflicts().map(t=>t.cell)}}function or(r){let e=Array.from({length:r.length+1},(t,n)=>kl(r,n));return _n(r.config,r.map,
e)}function kl(r,e){let t=r.n_agents,n=r.config.n_evaders,s=(a,i,l)=>a.subarray(i*l,(i+1)*l),o={positions:s(r.last_positions,e,2*t),alive:s(r.alive,e,t),captured:s(
r.captured,e,n),everCaptured:s(r.ever_captured,e,n)};return e===0?o:{...o,actions:s(r.actions,e-1,t),involved:s(r.involved,e-1,3*t),fault:s(r.fault,e-1,3*t),get contested(){
return r.conflicts(e).map(a=>a.cell)}}}var Mt=class{config;start;recording;actions=[];#e;#r;#t=[[]];constructor(e,t,n){[this.config,this.start]=[t,n],this.#e=e.world(t),this.#e.reset(n),this.#r=[$n(this.#e)],
this.recording=_n(t,this.#e.map(),this.#r)}get length(){return this.actions.length}get over(){return this.#e.over}get statistics(){return{capture_rate:this.#e.read(
"capture_rate")[0]}}conflicts(e){return this.#t[e]}game(e){return e.game(this.#e)}play(e){this.#e.step(e),this.#n(e)}step(e,t,n){let[s,o]=[this.#e,this.config.n_pursuers],
a=new Uint8Array(s.n_agents);for(let i=s.n_turns;i>0&&!s.over;--i){let[l,c]=s.actors;l<o&&(a=s.decide(e.pursuer,[l,Math.min(c,o)],a)),c>o&&(a=s.decide(e.evader,
[Math.max(l,o),c],a)),typeof n=="number"?a[t]=n:l<=t&&t<c&&(a=s.decide(n,[t,t+1],a)),s.playTurn(a)}this.#n(a)}#n(e){this.actions.push(e),this.#r.push($n(this.#e,
e)),this.#t.push(this.#e.conflicts())}};var pe=(r,e)=>At[+(e>=r.n_pursuers)];function Tt(r,e){let t=new Mt(r,e.config,{seed:e.seed,episode:e.episode});for(let n of e.moves)t.over||t.step(e.policies,e.
seat,n);return t}function be(r,e){let{moments:t,nPursuers:n}=r.recording,s=t.findIndex(({alive:a,captured:i})=>!a[e]||!!i[e-n]),o=s<0?r.length:s;return{lasted:o,
out:s>=0,captured:Array.from(t[o].everCaptured).filter(Boolean).length}}var ar=(r,e)=>r.over||be(r,e).out;function wo(r,e,t){let n=Tt(r,{...e,moves:e.moves.slice(
0,e.from)});for(;!ar(n,e.seat);)n.step(e.policies,e.seat,t);return be(n,e.seat)}function xo(r){let e=r.length-1;return[...new Set([0,Math.round(e/3),e])].map(t=>r[t])}var Rl=()=>crypto.getRandomValues(new BigUint64Array(1))[0],_l=8;function Pn(r,e,t){let{n_pursuers:n,n_evaders:s}=e,o=Array.from({length:n+s},(l,c)=>c).filter(l=>pe(
e,l)!==pe(e,t)),a=l=>{let c=new Mt(r,e,{seed:l}).recording.moments[0].positions,u=(h,m)=>Math.abs(c[2*t+h]-c[2*m+h]);return Math.min(...o.map(h=>u(0,h)+u(1,h)))};
return Array.from({length:_l},Rl).map(l=>[l,a(l)]).reduce((l,c)=>c[1]>l[1]?c:l)[0]}var So=()=>JSON.parse(me("data")),Ze={"specialist-specialist":"Specialists: both teams meet only the newest opponent","generalist-specialist":"Pursuers meet all\
 earlier evaders, evaders only the newest pursuers","generalist-generalist":"Generalists: both teams meet all earlier opponents","hall-of-fame":"Halls of fame: \
both teams learn at once, and meet earlier champions"};function ir({schedule:r}){if(r.kind==="hall-of-fame")return r.kind;let e={latest:"specialist","round-robi\
n":"generalist",uniform:"uniform"};return`${e[r.pursuers_meet]}-${e[r.evaders_meet]}`}var lr=r=>Ze[ir(r)]??ir(r);var ur=10,hr=999999,Xe=15,dr=90,Ln=[3,5,7,9,11],mr=5,In=[8,16,32,64],Fn=[6,10,30,60,90,120,200];function Nn(r,e=""){let t=Object.hasOwn(r.worlds,e)?e:Object.keys(
r.worlds)[0],{n_pursuers:n,n_evaders:s,fov:o,max_steps:a}=r.worlds[t];return{world:t,schedule:"generalist-generalist",beside:"",learner:"es",policy:"rating",seed:0,
generations:Xe,way:!1,population:0,pursuers:n,evaders:s,view:o,steps:a,walls:null}}function pr(r,e,t=e.schedule){let n=r.races[e.policy][e.learner][t],s=r.worlds[e.
world],o={...s,n_pursuers:e.pursuers,n_evaders:e.evaders,fov:e.view,max_steps:e.steps,obstacles:e.walls?Js(e.walls,s.rows,s.cols):s.obstacles},a=e.way?"right-of\
-way":e.policy==="rating"?"obstacles":"none";return{...n,world:o,train_steps:e.steps,seed:e.seed,policy:{...n.policy,mask:a},learner:{...n.learner,population:e.
population||n.learner.population},schedule:{...n.schedule,generations:e.generations}}}function fr({walls:r,pursuers:e,evaders:t},{rows:n,cols:s}){if(!r)return"";
let o=new Set(Array.from({length:n*s},(i,l)=>l).filter(i=>!r.includes(i)));if(o.size<e+t)return`There is no room: ${e+t} agents need a free cell each.`;let a=[Math.
min(...o)];o.delete(a[0]);for(let i of a){let l=i%s,c=[i-s,i+s,...l>0?[i-1]:[],...l<s-1?[i+1]:[]];a.push(...c.filter(u=>o.delete(u)))}return o.size?"Nobody may \
be walled in: all free cells have to be connected, side by side.":""}var cr=r=>Array.isArray(r)?r.join(".")||"none":r===null?"usual":String(typeof r=="boolean"?
Number(r):r);function Ao(r,e){let[t,n]=[Nn(r,e.world),Nn(r)];return Object.fromEntries(Object.keys(e).filter(s=>cr(e[s])!==cr((s==="world"?n:t)[s])).map(s=>[s,cr(
e[s])]))}var Mo=r=>Object.fromEntries(Object.entries(r).map(([e,t])=>[e,cr(t)]));function Dn(r,e,t,n){let s=n??Nn(r,e.world),{rows:o,cols:a}=r.worlds[s.world],i=(f,g)=>v=>/^\d{1,6}$/.
test(v)&&Number(v)>=f&&Number(v)<=g?Number(v):void 0,l=(...f)=>g=>f.find(v=>String(v)===g),c=f=>{if(f==="usual"||f==="none")return f==="usual"?null:[];let g=f.split(
".").map(v=>i(0,o*a-1)(v));return g.includes(void 0)?void 0:g.reduce((v,x)=>er(v,x,!0),[])},u={world:l(...Object.keys(r.worlds)),schedule:l(...Object.keys(Ze)),
beside:l("",...Object.keys(Ze)),learner:l("es","ga"),policy:l("rating","cells"),way:f=>/^[01]$/.test(f)?f==="1":void 0,seed:i(0,hr),generations:i(Xe,dr),pursuers:i(
1,ur),evaders:i(1,ur),view:l(...Ln),steps:l(...Fn),population:l(0,...In),walls:c},h=Object.entries(e).map(([f,g])=>{let v=Object.hasOwn(u,f)?u[f](g):void 0;return v===
void 0&&t(`${f}=${g}`),[f,v]}),m={...s,...Object.fromEntries(h.filter(([,f])=>f!==void 0))},p=m.way?{...m,view:Math.max(mr,m.view)}:m,y=fr(p,r.worlds[p.world]);
return y&&t(y),y?{...p,walls:null}:p}var $l=1e3,Pl=5;function oe(r,e,t,n=""){return d("label",{class:`field ${n}`,title:e},d("span",{class:"field-name"},r),t,d("span",{class:"about small muted"},e))}
function To(r,e){let t=Object.entries(Ze),n=b=>{let{n_pursuers:O,n_evaders:k,max_steps:R}=r.worlds[b];return{world:b,pursuers:O,evaders:k,steps:R,walls:null}},s=b=>{
let{rows:O,cols:k,n_pursuers:R,n_evaders:E}=r.worlds[b];return`${b}: ${O} x ${k}, ${R} against ${E}`},o=Q(Object.keys(r.worlds).map(b=>[b,s(b)]),b=>e(n(b),!0)),
a=Q(t,b=>e({schedule:b})),i=Q([["","Nothing"],...t],b=>e({beside:b},!0)),l=Array.from({length:ur},(b,O)=>[O+1,String(O+1)]),c=Q(l,b=>e({pursuers:Number(b)})),u=Q(
l,b=>e({evaders:Number(b)})),h=Q(Ln.map(b=>[b,`${b} x ${b}`]),b=>e({view:Number(b),...Number(b)<mr?{way:!1}:{}})),m=d("input",{type:"checkbox",onchange:()=>e({way:m.
checked,...m.checked?{view:Math.max(mr,Number(h.value))}:{}})}),p=Q([[0,"usual"],...In.map(b=>[b,String(b)])],b=>e({population:Number(b)})),y=Q(Fn.map(b=>[b,String(
b)]),b=>e({steps:Number(b)})),f=Q([["es","evolution strategy"],["ga","genetic algorithm"]],b=>e({learner:b},!0)),g=Q([["rating","weights of named inputs"],["cel\
ls","a network over the cells of its view"]],b=>e({policy:b,...b==="cells"?{view:Pl}:{}},!0)),v=d("input",{type:"number",min:0,max:hr,step:1,inputmode:"numeric"});
v.addEventListener("change",()=>e({seed:Math.min(hr,Math.max(0,Math.round(Number(v.value))||0))},!0));let x=d("button",{type:"button",onclick:()=>e({seed:Math.floor(
Math.random()*$l)},!0)},"Another seed"),w=(b,O,...k)=>d("section",{class:`controls ${O}`,"aria-label":b},d("fieldset",{},d("legend",{},b),...k));return{main:w("\
Try something else","card",oe("World","where they meet; begins a new race",o,"wide"),oe("Pursuers","triangles; at once",c),oe("Evaders","discs; at once",u),oe("\
Steps","after which evaders that are free have won",y),oe("Seed","the luck of the race; begins a new one",d("span",{class:"seed"},v,x),"half")),more:d("details",
{class:"card more-controls"},d("summary",{},"More: whom they meet, how they learn, what they see"),w("How they learn","",oe("Opponents","whom the teams meet whi\
le they learn",a,"wide"),oe("Side by side with","a second race of the same seed",i,"wide"),oe("What evolves","what an agent decides by",g,"half"),oe("Learner","\
how a team learns",f,"half"),oe("View","cells that an agent sees around itself",h),oe("Right of way","agents never take a move that could put them at fault",d("\
span",{},m)),oe("Population","candidates that are compared at a time",p))),show:b=>{[o.value,a.value,i.value,h.value,f.value]=[b.world,b.schedule,b.beside,String(
b.view),b.learner],[p.value,y.value,v.value,m.checked]=[String(b.population),String(b.steps),String(b.seed),b.way],[g.value,c.value,u.value]=[b.policy,String(b.
pursuers),String(b.evaders)]}}}function Un(r,e,t,n){let{players:s,told:o,...a}=n;e.play({...a,played:t,ending:(i,l)=>[o?d("p",{},o(be(i,t.seat))):"",Nl(r,i,l,xo(s))],again:()=>Un(r,e,{...t,moves:t.
moves.slice(0,t.from)},n)})}function Nl(r,e,t,n){let s=pe(t.config,t.seat)==="evader",o=s?t.config.max_steps:t.config.n_evaders,a=d("table",{class:"numbers"},d(
"caption",{},s?"Steps in your seat: same start, same others":"Captures of your team: same start, same others")),i=c=>{let[u,h]=[d("span",{class:s?"bar evader":"\
bar pursuer"}),d("td",{},"…")];return a.append(d("tr",{},d("th",{scope:"row"},c),d("td",{class:"track","aria-hidden":"true"},u),h)),({lasted:m,captured:p})=>{
u.style.width=`${100*(s?m:p)/o}%`,h.textContent=String(s?m:p)}};i("You")(be(e,t.seat));for(let{name:c,policy:u}of n){let h=i(c);setTimeout(()=>h(wo(r,t,u())))}let l=t.
from?`You took over at step ${t.from}. `:"";return d("div",{},a,d("p",{class:"small muted"},`${l}One match: luck has its part in it.`))}var Qe=[[0,0],[-1,0],[0,1],[1,0],[0,-1],[-1,1],[1,1],[1,-1],[-1,-1]];function Eo(r,e,t){let[n,s]=[e[0]-r[0],e[1]-r[1]];return!t&&Math.abs(n)>Math.abs(s)?s=0:t||
(n=0),Qe.findIndex(([o,a])=>o===Math.sign(n)&&a===Math.sign(s))}var Fe=(r,e)=>e<r.nPursuers,P=(r,e)=>[r.positions[2*e],r.positions[2*e+1]],Wn=({rows:r,cols:e},[
t,n])=>t>=0&&n>=0&&t<r&&n<e,Bn=(r,e,t=3)=>r!==void 0&&[0,1,2].slice(0,t).some(n=>r[3*e+n]),jn=(r,e)=>Bn(r.fault,e),Oo=(r,e)=>!jn(r,e)&&Bn(r.involved,e,2);function yr(r,e,t){
let[n,s]=[P(r,t),P(e,t)],o=n[0]!==s[0]||n[1]!==s[1],a=e.involved===void 0||Bn(e.involved,t);return!!(e.alive[t]&&e.actions?.[t]&&!o&&a)}function gr(r,e,t){let[n,
s]=P(r,t),[o,a]=Qe[e.actions?.[t]??0];return[n+o,s+a]}function Et(r,e,t){return Array.from({length:t.everCaptured.length},(s,o)=>o).filter(s=>t.everCaptured[s]&&
!e.everCaptured[s]).map(s=>r.nPursuers+s)}var vr=r=>r.moments.flatMap((e,t)=>t&&Et(r,r.moments[t-1],e).length?[t]:[]);function br(r,e){return Array.from({length:e.
alive.length},(n,s)=>s).filter(n=>r.alive[n]&&!e.alive[n])}var Co=[-.31,0,.31],ko=[{size:1,at:[[0,0]]},{size:.62,at:[[-.2,.2],[.2,-.2]]},{size:.54,at:[[-.23,.22],[.23,.22],[0,-.22]]},{size:.54,at:[[-.23,.23],[.23,.23],[
-.23,-.23],[.23,-.23]]},{size:.36,at:Co.flatMap(r=>Co.map(e=>[e,r]))}],Ll=.3,Il=.35,Fl=.55;function Ot(r,e){let t=new Map;for(let n=0;n<e.alive.length;n++){if(!e.
alive[n])continue;let[s,o]=P(e,n),a=s*r.cols+o,i=t.get(a);i?i.push(n):t.set(a,[n])}return t}function Ro(r,e){let t=Array.from(e.alive,(n,s)=>{let[o,a]=P(e,s);return{
x:a+.5,y:o+.5,size:1,alpha:0}});for(let n of Ot(r,e).values()){let s=ko[Math.min(n.length,ko.length)-1];n.forEach((o,a)=>{let[i,l]=s.at[Math.min(a,s.at.length-1)],
c=t[o];c.x+=i,c.y+=l,c.size=s.size,c.alpha=1})}return t}var _o=r=>r*r*(3-2*r),et=(r,e,t)=>r+(e-r)*t,$o=r=>Math.min(1,Math.max(0,r));function Po(r,e,t,n){let s={
SIMULTANEOUS:1,SWARM_TURNS:2,AGENT_TURNS:t}[r.interaction];if(s===1)return _o(n);let o=s===t?e:+!Fe(r,e),a=Math.max(1/s,Il);return _o($o((n-o/(s-1)*(1-a))/a))}function wr(r,e){
let t=r.moments.length-1,n=Math.min(Math.floor(e),t),s=r.moments[n],o=Ro(r,s);if(n===t||e===n)return o;let a=r.moments[n+1],i=Ro(r,a);return o.map((l,c)=>{let u=Po(
r,c,o.length,e-n);return Dl(s,a,c,l,i[c],u)})}function zn(r,e,t){let n=r.moments.length-1,s=Math.min(Math.floor(t),n),[o,a]=[r.moments[s],r.moments[Math.min(s+1,
n)]],i=Po(r,e,o.alive.length,t-s),[[l,c],[u,h]]=[P(o,e),P(a,e)];return[et(c,h,i)+.5,et(l,u,i)+.5]}function Dl(r,e,t,n,s,o){let a=n.alpha>s.alpha,i={x:et(n.x,s.x,
o),y:et(n.y,s.y,o),size:a?n.size:et(n.size,s.size,o),alpha:a?$o((1-o)/(1-Fl)):et(n.alpha,s.alpha,o)};if(yr(r,e,t)){let[l,c]=P(r,t),[u,h]=gr(r,e,t),m=Ll*Math.sin(
Math.PI*o);i.x+=(h-c)*m,i.y+=(u-l)*m}return i}var No=2*Math.PI;function De(r,e,t,n){r.beginPath(),r.arc(e,t,n/2,0,No)}function xr(r,e,t,n){let s=n/2,o=[[0,-.97],[.97,.83],[-.97,.83]].map(([a,i])=>[e+a*s,t+i*
s]);r.beginPath(),r.moveTo((o[2][0]+o[0][0])/2,(o[2][1]+o[0][1])/2),o.forEach(([a,i],l)=>{let[c,u]=o[(l+1)%3];r.arcTo(a,i,c,u,n*.09)}),r.closePath()}function Lo(r,e,t,n){
let s=n*.32;r.beginPath(),r.moveTo(e-s,t-s),r.lineTo(e+s,t+s),r.moveTo(e+s,t-s),r.lineTo(e-s,t+s)}function Io(r,e,t,n){r.beginPath();for(let s=0;s<16;s++){let o=n/
2*(s%2?.6:.95),a=No*s/16;r.lineTo(e+o*Math.sin(a),t-o*Math.cos(a))}r.closePath()}function Fo(r,e,t,n,s,o){let a=Math.atan2(s-t,n-e);r.beginPath(),r.moveTo(e,t),
r.lineTo(n,s);for(let i of[-1,1])r.moveTo(n,s),r.lineTo(n-o*Math.cos(a+i*.6),s-o*Math.sin(a+i*.6))}var Do=4,Ul=1.6,Wl=.95,Bl=5,jl=.16,zl=9,Gl=.09,Hl=.2,Uo=.75,H=(r,e)=>r.left+e*r.cell,V=(r,e)=>r.top+e*r.cell;function tt(r,e,t){return Fe(e,t)?r.colors.pursuer:
r.colors.evader}function Sr({ctx:r,colors:e},t,n,s,o,a,i=0){r.font=`700 ${Math.round(o)}px system-ui, sans-serif`,r.textAlign="center",r.textBaseline="middle",r.
strokeStyle=e.paper,r.lineWidth=i,i&&r.strokeText(t,n,s),r.fillStyle=a,r.fillText(t,n,s)}function Wo({ctx:r,grid:e,colors:t}){let{left:n,top:s,cell:o,rows:a,cols:i}=e,
[l,c]=[i*o,a*o];if(r.fillStyle=t.paper,r.fillRect(n,s,l,c),o<Bl)return;r.fillStyle=t.line;let u=Math.max(1,Math.round(o/60));for(let h=1;h<i;h++)r.fillRect(n+h*
o,s,u,c);for(let h=1;h<a;h++)r.fillRect(n,s+h*o,l,u)}function Bo({ctx:r,grid:e,colors:t},n){let{left:s,top:o,cell:a,rows:i,cols:l}=e;r.fillStyle=t.obstacle;for(let c=0;c<
i*l;c++){if(!n.obstacles[c])continue;let[u,h]=[Math.floor(c/l),c%l];r.fillRect(s+h*a,o+u*a,a,a)}jo({ctx:r,grid:e,colors:t})}function jo({ctx:r,grid:{left:e,top:t,
cell:n,rows:s,cols:o},colors:a}){let i=Math.min(5,Math.max(2,Math.round(n/18)));r.strokeStyle=a.frame,r.lineWidth=i,r.strokeRect(e-i/2,t-i/2,o*n+i,s*n+i)}function zo({
ctx:r,grid:e,colors:t},n){let{left:s,top:o,cell:a,rows:i,cols:l}=e,c=a<24*n?5:1;r.font=`500 ${Math.round(Math.min(15*n,Math.max(9*n,a*.32)))}px system-ui, sans-\
serif`,r.fillStyle=t.muted,r.textBaseline="alphabetic",r.textAlign="center";let u=5*n+a/40;for(let h=0;h<l;h+=c)r.fillText(String(h),s+(h+.5)*a,o-u);r.textAlign=
"right",r.textBaseline="middle";for(let h=0;h<i;h+=c)r.fillText(String(h),s-u,o+(h+.5)*a)}function Go({grid:r},e,t,n){let s=Math.floor(e.fov/2)+.5,[o,a]=[Math.max(
0,t-s),Math.min(r.cols,t+s)],[i,l]=[Math.max(0,n-s),Math.min(r.rows,n+s)];return[H(r,o),V(r,i),(a-o)*r.cell,(l-i)*r.cell]}function Ho(r,e,t,n){let{ctx:s,grid:o,
colors:a}=r;s.save(),s.beginPath(),s.rect(0,0,s.canvas.width,s.canvas.height),s.rect(...Go(r,e,t,n)),s.clip("evenodd"),s.clearRect(0,0,s.canvas.width,s.canvas.height),
s.fillStyle=a.line,s.fillRect(o.left,o.top,o.cols*o.cell,o.rows*o.cell),s.restore(),jo(r)}function Vo(r,{x:e,y:t,alpha:n},s){let{ctx:o,grid:a,colors:i}=r,l=Math.
max(a.cell,16*s)*1.06,[c,u]=[H(a,e),V(a,t)];o.globalAlpha=Math.max(n,.6),o.beginPath(),o.roundRect(c-l/2,u-l/2,l,l,l*.2),o.strokeStyle=i.focus,o.lineWidth=Math.
max(2,2.5*s),o.stroke();let h=Math.max(11*s,Math.min(18*s,a.cell*.5)),m=u-l/2<h*1.2,p=u+(m?1:-1)*(l/2+h*.7);o.lineJoin="round",Sr(r,"You",c,p,h,i.ink,h*.35),o.globalAlpha=
1}function Ko(r,e,t,n,s){let{ctx:o,grid:a}=r,i=Go(r,e,n,s),l=tt(r,e,t);o.globalAlpha=.11,o.fillStyle=l,o.fillRect(...i),o.globalAlpha=.8,o.strokeStyle=l,o.lineWidth=
Math.max(1,a.cell/24),o.strokeRect(...i),o.globalAlpha=1}function Yo(r,e,t,n,s){let{ctx:o,grid:a}=r,i=Math.min(Math.ceil(t),e.moments.length-1),l=e.moments[i];o.
lineCap="round",o.lineWidth=Math.min(zl,Math.max(1,a.cell*jl));for(let c=Math.max(1,Math.floor(t-n)+1);c<=i;c++){let[u,h]=[e.moments[c-1],e.moments[c]],m=Math.max(
0,Math.min(1,(t-c)/n));o.globalAlpha=Uo+(Hl-Uo)*m;for(let p=0;p<h.alive.length;p++){let y=c===i&&t<i;if(!u.alive[p]||!(l.alive[p]||y))continue;let f=(Fe(e,p)?-1:
1)*Gl,[g,v]=P(u,p),[x,w]=P(h,p);if(g===x&&v===w)continue;let b=y?s[p].x:w+.5,O=y?s[p].y:x+.5;o.strokeStyle=tt(r,e,p),o.beginPath(),o.moveTo(H(a,v+.5+f),V(a,g+.5+
f)),o.lineTo(H(a,b+f),V(a,O+f)),o.stroke()}}o.globalAlpha=1}function qo(r,e,t){let n=Math.min(Math.ceil(t),e.moments.length-1);for(let s=Math.max(1,n-Do+1);s<=n;s++){
let[o,a]=[e.moments[s-1],e.moments[s]],i=s>t?Math.max(0,1-2*(s-t)):1-(t-s)/Do,l=Et(e,o,a);for(let c of br(o,a))l.includes(c)||Kl(r,P(a,c),i);for(let c of l)Vl(r,
P(a,c),i)}r.ctx.globalAlpha=1}function Vl({ctx:r,grid:e,colors:t},[n,s],o){r.globalAlpha=o,Io(r,H(e,s+.5),V(e,n+.5),Math.max(8,e.cell*Ul)),r.fillStyle=t.capture,
r.fill(),r.strokeStyle=t.ink,r.lineWidth=Math.max(1,e.cell/36),r.lineJoin="round",r.stroke()}function Kl({ctx:r,grid:e,colors:t},[n,s],o){r.globalAlpha=o,Lo(r,H(
e,s+.5),V(e,n+.5),Math.max(7,e.cell*Wl)),r.strokeStyle=t.collision,r.lineWidth=Math.max(2,e.cell*.17),r.lineCap="round",r.stroke()}function Jo({ctx:r,grid:e,colors:t},n,s){
let o=Math.max(1,e.cell*.07);r.strokeStyle=r.fillStyle=t.collision,r.lineWidth=Math.max(1,e.cell*.05),r.setLineDash([e.cell*.14,e.cell*.1]);for(let[a,i]of n){if(a<
0||i<0||a>=e.rows||i>=e.cols)continue;let l=[H(e,i)+o,V(e,a)+o,e.cell-2*o,e.cell-2*o];r.globalAlpha=.2*s,r.fillRect(...l),r.globalAlpha=s,r.strokeRect(...l)}r.setLineDash(
[]),r.globalAlpha=1}function Zo({ctx:r,grid:e,colors:t},n,s,o,a){r.globalAlpha=a,De(r,H(e,n),V(e,s),Math.max(8,e.cell*o*1.02)),r.strokeStyle=t.collision,r.lineWidth=
Math.max(1.5,e.cell*.085*Math.sqrt(o)),r.stroke(),r.globalAlpha=1}var Yl=.8,ql=.92,Jl=15,Zl=7,Gn=9;function Xo(r,e,t,n,s,o){n.forEach((a,i)=>{a.alpha>0&&Xl(r,e,t,i,a,s,o)}),r.ctx.globalAlpha=1;for(let a of Ot(e,t).values())a.length>
Gn&&Ql(r,n[a[Gn-1]],a.length-Gn+1)}function Xl(r,e,t,n,s,o,a){let{ctx:i,grid:l,colors:c}=r,u=Fe(e,n),[h,m]=[H(l,s.x),V(l,s.y)],p=Math.max(4,l.cell*s.size*(u?ql:
Yl)),y=tt(r,e,n),f=!u&&!!t.captured[n-e.nPursuers];if(i.globalAlpha=s.alpha,(u?xr:De)(i,h,m,p),p>Zl*a&&(i.strokeStyle=c.paper,i.lineWidth=Math.max(2,p*.1),i.stroke()),
i.fillStyle=f?c.paper:y,i.fill(),f&&(De(i,h,m,p*.82),i.strokeStyle=y,i.lineWidth=p*.18,i.stroke()),!o||p<Jl*a)return;let g=String(u?n:n-e.nPursuers),v=p*(u?.4:.5)*
(g.length>1?.8:1);Sr(r,g,h,m+p*(u?.17:.03),v,f?y:c.paper)}function Ql(r,e,t){let{cell:n}=r.grid;Sr(r,`+${t}`,H(r.grid,e.x),V(r.grid,e.y),n*.3,r.colors.ink,n*.1)}var ec=.46,tc=.86,rc=.66,Qo=.48,nc=.78,sc=.58;function ea(r,e,t,n){let[s,o]=[e.moments[t-1],e.moments[t]];if(!s)return;let{ctx:a,grid:i,colors:l}=r;a.strokeStyle=
l.collision,a.lineWidth=Math.max(1.5,i.cell*.07),a.lineCap="butt",a.globalAlpha=n;for(let c=0;c<o.alive.length;c++)yr(s,o,c)&&oc(r,e,P(s,c),gr(s,o,c));a.globalAlpha=
1}function oc({ctx:r,grid:e},t,n,s){let[o,a]=[s[1]-n[1],s[0]-n[0]],i=h=>H(e,n[1]+.5+o*h),l=h=>V(e,n[0]+.5+a*h),c=Wn(t,s)?nc:sc;r.setLineDash([e.cell*.09,e.cell*
.06]),r.beginPath(),r.moveTo(i(Qo),l(Qo)),r.lineTo(i(c),l(c)),r.stroke(),r.setLineDash([]);let u=.17*e.cell/Math.hypot(o,a);r.beginPath(),r.moveTo(i(c)-a*u,l(c)+
o*u),r.lineTo(i(c)+a*u,l(c)-o*u),r.stroke()}function ta(r,e,t,n,s,o){let a=Qe[o];if(!o||!a)return;let{ctx:i,grid:l,colors:c}=r,u=Wn(e,[n[0]+a[0],n[1]+a[1]])?tc:
rc,h=ec*s.size,m=[H(l,s.x+a[1]*h),V(l,s.y+a[0]*h),H(l,s.x+a[1]*u),V(l,s.y+a[0]*u)],p=Math.max(1.5,l.cell*.085);i.lineCap=i.lineJoin="round";for(let[y,f]of[[c.paper,
p*2.1],[tt(r,e,t),p]])i.strokeStyle=y,i.lineWidth=f,Fo(i,...m,l.cell*.2),i.stroke()}var Ar={numbers:!0,axes:!1,trail:6,viewers:[],plan:null,selected:null,cursor:null,you:null,fog:!1};function Mr(r,e,t,n,s){let{ctx:o,grid:a,colors:i}=r,l=Math.min(
Math.ceil(t),e.moments.length-1),c=e.moments[l],u=t===l,h=wr(e,t),m=u?1:Math.max(0,1-2*(l-t));o.clearRect(0,0,o.canvas.width,o.canvas.height),Wo(r);for(let f of n.
viewers)h[f]?.alpha&&Ko(r,e,f,...zn(e,f,t));Bo(r,e),n.axes&&zo(r,s),Yo(r,e,t,n.trail,h),Jo(r,c.contested??[],m),qo(r,e,t),ea(r,e,l,m),h.forEach(({x:f,y:g,size:v},x)=>{
let w=Oo(c,x)?.4:0,b=jn(c,x)?1:w;b&&Zo(r,f,g,v,b*m)});let p=u?c:e.moments[Math.max(0,l-1)];if(Xo(r,e,p,h,n.numbers,s),u&&n.plan)for(let[f,g]of h.entries())g.alpha&&
ta(r,e,f,P(c,f),g,n.plan[f]??0);n.you!==null&&(n.fog&&Ho(r,e,...zn(e,n.you,t)),Vo(r,h[n.you],s)),o.lineWidth=Math.max(2,2.5*s),o.strokeStyle=i.focus;let y=n.selected===
null?void 0:h[n.selected];y?.alpha&&ra(r,y.x,y.y,y.size*.96),n.cursor&&(o.setLineDash([a.cell*.12,a.cell*.08]),ra(r,n.cursor[1]+.5,n.cursor[0]+.5,.8),o.setLineDash(
[]))}function ra({ctx:r,grid:e},t,n,s){let o=s*e.cell;r.beginPath(),r.roundRect(e.left+t*e.cell-o/2,e.top+n*e.cell-o/2,o,o,o*.1),r.stroke()}var na=(r,e)=>(e+.24)/(r+.24);function Tr(r,e,t,n,s,o){let a=t?28*o:0,i=(c,u)=>(c-a)/(u+2*.12),l=Math.max(1,Math.floor(Math.min(i(n,e),i(s,r))));return{rows:r,cols:e,
cell:l,left:Math.round((n-e*l+a)/2),top:Math.round((s-r*l+a)/2)}}function sa(r,e,t){let n=Math.floor((t-r.top)/r.cell),s=Math.floor((e-r.left)/r.cell);return n>=
0&&n<r.rows&&s>=0&&s<r.cols?[n,s]:null}var ac=["paper","line","frame","ink","muted","obstacle"],ic=["pursuer","evader","capture","collision","focus"];function rt(r){let e=getComputedStyle(r),t=(n,s)=>[
n,e.getPropertyValue(s+n).trim()];return Object.fromEntries([...ac.map(n=>t(n,"--board-")),...ic.map(n=>t(n,"--"))])}var we=()=>matchMedia("(prefers-reduced-motion: reduce)").matches,Re=class{canvas;#e=null;#r=0;#t;#n={rows:1,cols:1,left:0,top:0,cell:1};#a=0;constructor(e,t={}){
this.canvas=e,e.classList.add("board"),e.setAttribute("role","img"),this.#t={...Ar,...t},new ResizeObserver(()=>this.#u()).observe(e),new MutationObserver(()=>this.
redraw()).observe(document.documentElement,{attributes:!0}),addEventListener("beforeprint",()=>this.drawNow())}set look(e){this.#t={...this.#t,...e},this.#s(),this.
redraw()}show(e,t){this.#e=e,this.#r=Math.min(Math.max(0,t),e.moments.length-1),this.#s(),this.redraw()}redraw(){this.#a||(this.#a=requestAnimationFrame(()=>this.
drawNow()))}drawNow(){cancelAnimationFrame(this.#a),this.#a=0;let e=this.canvas.getContext("2d");if(!e||!this.#e)return;let{rows:t,cols:n}=this.#e,s=devicePixelRatio||
1;this.#n=Tr(t,n,this.#t.axes,this.canvas.width,this.canvas.height,s);let o={ctx:e,grid:this.#n,colors:rt(this.canvas)};Mr(o,this.#e,this.#r,this.#t,s)}cellAt(e,t){
let n=this.canvas.getBoundingClientRect(),s=this.canvas.width/n.width;return sa(this.#n,(e-n.left)*s,(t-n.top)*s)}agentAt(e,t){let n=this.cellAt(e,t);if(!n||!this.#e)
return null;let s=this.#e.moments[Math.round(this.#r)],o=Ot(this.#e,s).get(n[0]*this.#e.cols+n[1])??[],a=wr(this.#e,Math.round(this.#r)),i=l=>{let[c,u]=this.pointOf(
a[l].x,a[l].y);return Math.hypot(c-e,u-t)};return o.length?o.reduce((l,c)=>i(c)<i(l)?c:l):null}pointOf(e,t){let n=this.canvas.getBoundingClientRect(),s=n.width/
this.canvas.width,{left:o,top:a,cell:i}=this.#n;return[n.left+(o+e*i)*s,n.top+(a+t*i)*s]}#s(){if(!this.#e)return;let{rows:e,cols:t}=this.#e;this.canvas.style.setProperty(
"--board-aspect",String(na(e,t)))}#u(){let e=devicePixelRatio||1,{width:t,height:n}=this.canvas.getBoundingClientRect();this.canvas.width=Math.max(1,Math.round(
t*e)),this.canvas.height=Math.max(1,Math.round(n*e)),this.drawNow()}};var Ct=[.5,1,2,4,8,16,32,64],Er=0,Or=12,lc=2,_e=class extends EventTarget{#e;#r;#t;#n=0;#a=0;#s=!1;#u=null;#m=0;#d=[];#p=[];glide=.28;constructor(e,{speed:t=4,still:n=!1}={}){
super(),[this.#e,this.#r,this.#t]=[e,t,n]}get step(){return this.#n}get time(){return this.#t?this.#n:this.#a}get arrived(){return this.#a===this.#n}get playing(){
return this.#s}get length(){return this.#e}set length(e){this.#e=e,this.#n>e&&this.jump(e),this.#i("state")}get marks(){return this.#d}set marks(e){this.#d=e,this.#i(
"state")}get ticks(){return this.#p}set ticks(e){this.#p=e,this.#i("state")}get pace(){return this.#r||Math.max(lc,this.#e/Or)}get speed(){return this.#r}set speed(e){
this.#r=e,this.#i("state")}changeSpeed(e){let t=Ct.findIndex(n=>n>=this.pace);this.speed=Ct[Math.min(Ct.length-1,Math.max(0,t+e))]}play(){this.#s||!this.#e||(this.#n===
this.#e&&this.jump(0),this.#s=!0,this.#i("state"),this.#o())}pause(){this.#s&&(this.#s=!1,this.#i("state"))}toggle(){this.#s?this.pause():this.play()}move(e){this.
pause();let t=Math.min(this.#e,Math.max(0,this.#n+e));Math.abs(t-this.#a)>1?this.jump(t):this.#f(t),this.#o()}jump(e){this.#a=Math.min(this.#e,Math.max(0,Math.round(
e))),this.#f(this.#a),this.#i("frame")}#f(e){e!==this.#n&&(this.#n=e,this.#i("step"),this.#t&&this.#i("frame"))}#o(){this.#u===null&&(this.#m=performance.now(),
this.#u=requestAnimationFrame(()=>this.#l()))}#l(){this.#u=null;let e=performance.now();this.#c(Math.min(.25,(e-this.#m)/1e3)),this.#m=e,(!this.#t||this.arrived)&&
this.#i("frame"),(this.#s||this.#a!==this.#n)&&(this.#u=requestAnimationFrame(()=>this.#l()))}#c(e){let t=e;for(;t>0;){if(this.#a===this.#n){if(!this.#s)return;
if(this.#n===this.#e)return this.pause();this.#f(this.#n+1)}let n=this.#s?this.pace:1/this.glide,s=this.#n-this.#a,o=Math.min(Math.abs(s),t*n);t-=o/n,this.#a=o===
Math.abs(s)?this.#n:this.#a+Math.sign(s)*o}this.#s&&this.#a===this.#e&&this.pause()}#i(e){this.dispatchEvent(new Event(e))}};function Cr(r,e){if(e.ctrlKey||e.metaKey||
e.altKey)return!1;let t=e.shiftKey?10:1,s={" ":()=>r.toggle(),ArrowRight:()=>r.move(t),ArrowLeft:()=>r.move(-t),Home:()=>r.move(-r.length),End:()=>r.move(r.length),
"+":()=>r.changeSpeed(1),"-":()=>r.changeSpeed(-1)}[e.key];return s?.(),s!==void 0}var cc={first:"M6 5v14M19 5 9 12l10 7z",back:"M17 5 7 12l10 7z",play:"M7 4.5 19 12 7 19.5z",pause:"M8 5v14M16 5v14",forward:"M7 5l10 7-10 7z",last:"M18 5v14M5 5\
l10 7-10 7z"};function oa(r){return S("svg",{viewBox:"0 0 24 24","aria-hidden":"true",class:"icon"},S("path",{d:cc[r]}))}function kt(r,e,t,n){return d("button",
{type:"button",class:"player-button","aria-label":e,title:`${e} (${t})`,onclick:n},oa(r))}function kr(r){let e=kt("play","Play","Space",()=>r.toggle()),t=d("inp\
ut",{type:"range",class:"player-scrub",min:0,step:1,"aria-label":"Step",oninput:()=>{r.pause(),r.jump(Number(t.value))}}),n=d("div",{class:"captures","aria-hidd\
en":"true",title:"Captures"}),s=d("div",{class:"losses","aria-hidden":"true"}),o=d("select",{class:"player-speed","aria-label":"Speed",title:`Steps a second, or\
 the whole in ${Or} s (+ and -)`,onchange:()=>r.speed=Number(o.value)},d("option",{value:Er},`in ${Or} s`),...Ct.map(h=>d("option",{value:h},`${h} / s`))),a=d("\
output",{class:"player-count"}),i=d("div",{class:"player",role:"group","aria-label":"Player"},kt("first","First step","Home",()=>r.move(-r.length)),kt("back","S\
tep back","←",()=>r.move(-1)),e,kt("forward","Step forward","→",()=>r.move(1)),kt("last","Last step","End",()=>r.move(r.length)),d("div",{class:"scrub"},n,s,
t),a,o),l=(h,m={})=>{let p=d("i",m);return p.style.left=`${100*h/Math.max(1,r.length)}%`,p},c=()=>{n.replaceChildren(...r.marks.map(h=>l(h))),s.replaceChildren(
...r.ticks.map(({step:h,kind:m,size:p,text:y})=>{let f=l(h,{class:m,title:`Step ${h}: ${y}`});return f.style.height=`${100*p}%`,f}))},u=()=>{e.replaceChildren(oa(
r.playing?"pause":"play")),e.ariaLabel=r.playing?"Pause":"Play",e.title=`${e.ariaLabel} (Space)`,t.max=String(r.length),t.value=String(r.step),t.ariaValueText=`\
step ${r.step} of ${r.length}`,a.textContent=`${r.step} / ${r.length}`,a.style.minWidth=`${2*String(r.length).length+3}ch`,o.value=String(r.speed)};return r.addEventListener(
"step",u),r.addEventListener("state",u),r.addEventListener("state",c),i.addEventListener("keydown",h=>{!(h.target instanceof HTMLSelectElement||h.key===" "&&h.target!==
t)&&Cr(r,h)&&h.preventDefault()}),u(),i}function Rr(r,e,t){if(t===0)return[{kind:"start",text:uc(r),agents:[]}];let[n,s]=[e.moments[t-1],e.moments[t]],o=u=>se(u,r.config.n_pursuers),a=Et(e,n,s),i=r.conflicts(
t),l=new Set(i.flatMap(u=>u.doomed)),c=a.map(u=>({kind:"capture",text:`${o(u)} is captured`,agents:[u]}));for(let u of br(n,s))!a.includes(u)&&!l.has(u)&&c.push(
{kind:"end",text:`${o(u)} disappears`,agents:[u]});return c.push(...i.map(({kind:u,text:h,agents:m})=>({kind:u,text:h,agents:m}))),t===r.length&&c.unshift({kind:"\
end",text:hc(r),agents:[]}),c}function uc({config:r}){return`${r.n_pursuers} pursuers and ${r.n_evaders} evaders on ${r.rows} x ${r.cols} cells, at most ${r.max_steps}\
 steps`}function hc(r){let e=Math.round(r.statistics.capture_rate*r.config.n_evaders);return`The episode ends after ${r.length} steps with ${e} of ${r.config.n_evaders}\
 evaders captured`}var Hn=.005,ia=.05,dc=["pursuer","evader"],mc=4,nt=new Map;function _r(r,e,t="capture-rate"){let n=JSON.stringify([{...e,rewards:null},t]),s=nt.get(n)??(qt(e)?Promise.
resolve(null):pc(r,e,t));return nt.delete(n),nt.set(n,s),nt.size>mc&&nt.delete([...nt.keys()][0]),s}var la=({n_evaders:r})=>r===1?"capture-time":"capture-rate",
aa=()=>new Promise(r=>setTimeout(r));async function pc(r,e,t){await aa();let n=r.solution(e,t);for(;n.goBack();)await aa();return n}function $r(r,e,t){let{payoff:n}=r;
return t.flatMap((s,o)=>{let a=[0,0];for(let l=e.n_turns;l>0&&!e.over;l--)r.game(e)?.lost(s).forEach((c,u)=>a[u]+=c),e.playTurn(s);let i=n==="capture-rate"?Hn:ia;
return dc.map((l,c)=>({step:o+1,team:l,lost:a[c],payoff:n})).filter(l=>l.lost>=i)})}var Pr=r=>r.map(e=>({step:e.step,kind:e.team,size:e.lost/Math.max(1,...r.map(
({lost:t})=>t)),text:Rt(e)})),ca=({lost:r,payoff:e})=>e==="capture-rate"?`${r.toFixed(2)} of the capture rate`:`${r.toFixed(1)} steps`,Rt=r=>`The ${r.team}s los\
e ${ca(r)} against a perfect opponent`;function ua(r){let e=r.reduce((t,n)=>n.lost>t.lost?n:t);return`Your team's worst moves, in step ${e.step}, lost ${ca(e)} \
against a perfect opponent.`}function ha({config:r,payoff:e},{value:t},n){if(e==="capture-rate")return`value ${t.toFixed(2)}`;let[s,o]=[1-t,Math.min(r.max_steps-
n,dn)];return s>o-ia?`free for ${o} steps`:`captured after ${s.toFixed(1)} steps`}function da(r,e){return(r.marginal(e)??[]).map((n,s)=>({share:n,action:s})).filter(
({share:n})=>n>=Hn).sort((n,s)=>s.share-n.share).map(({share:n,action:s})=>n>1-Hn?ee[s]:`${ee[s]} ${n.toFixed(2)}`).join(", ")}var ma=["·","↑","→","↓","←","↗","↘","↙","↖"];var fc={" ":0,ArrowUp:1,w:1,ArrowRight:2,d:2,ArrowDown:3,s:3,ArrowLeft:4,a:4,e:5,c:6,y:7,z:7,q:8},Vn=[8,1,5,4,0,2,7,3,6],yc=[7,8,9,4,5,6,1,2,3],gc=24,vc=Math.tan(
Math.PI/8);function fa(r,e){if(r.ctrlKey||r.metaKey||r.altKey)return;let t=yc.findIndex(s=>r.code===`Numpad${s}`),n=Vn[t]??fc[r.key.length===1?r.key.toLowerCase():
r.key];return n!==void 0&&n>4&&!e?void 0:n}function ya(r){let e=Vn.map(t=>d("button",{type:"button","aria-label":ee[t],onclick:()=>r(t)},ma[t]));return{element:d(
"div",{class:"play-pad",role:"group","aria-label":"Your move"},...e),show:t=>e.forEach((n,s)=>n.classList.toggle("absent",Vn[s]>4&&!t))}}function pa(r,e,t){let n=vc*
Math.max(Math.abs(r),Math.abs(e)),s=o=>Math.abs(o)<n?0:o;return Eo([0,0],t?[s(r),s(e)]:[r,e],t)}function ga(r,e,t){let n=null,{canvas:s}=r;s.addEventListener("p\
ointerdown",({button:o,clientX:a,clientY:i})=>n=o===0?[a,i]:null),s.addEventListener("pointercancel",()=>n=null),s.addEventListener("pointerup",({clientX:o,clientY:a})=>{
let[i,l]=[n,e()];if(n=null,!i||!l)return;let[c,u]=[o-i[0],a-i[1]],h=r.cellAt(o,a);Math.hypot(c,u)>=gc?t(pa(u,c,l.diagonal)):h&&t(pa(h[0]-l.cell[0],h[1]-l.cell[1],
l.diagonal))})}function va(r,e){let t=n=>{let s=e[n]-r[n],o=Qe.findIndex(a=>a[n]===Math.sign(s)&&a[1-n]===0);return s?`${Math.abs(s)} ${ee[o]}`:""};return[t(0),
t(1)].filter(Boolean).join(", ")||"on your cell"}var xa="NUMPY\0",ba=xa.length+2,wa=64;function _t(r){return nr(Object.fromEntries(Object.entries(r).map(([e,t])=>[`${e}.npy`,bc(t)])))}function bc({dtype:r,shape:e,
data:t}){let n=typeof t=="string"?Array.from(t,u=>u.codePointAt(0)):null,s=e.map(u=>`${u}, `).join(""),o=`{'descr': '${n?`<U${n.length}`:r}', 'fortran_order': F\
alse, 'shape': (${s}), }`,a=Math.ceil((ba+o.length+1)/wa)*wa-ba,i=xa+String.fromCharCode(a&255,a>>8)+o.padEnd(a-1)+`
`,l=n?Int32Array.from(n):t,c=new Uint8Array(i.length+l.byteLength);return c.set(Ie(i,!0)),c.set(new Uint8Array(l.buffer,l.byteOffset,l.byteLength),i.length),c}var wc="matrixworld episode 3";function Sa(r,e,t){let{config:n,actions:s,length:o,recording:a}=e,[i,l]=[n.n_pursuers+n.n_evaders,n.n_evaders],c={positions:["<i4",
i,2],last_positions:["<i4",i,2],alive:["|b1",i],captured:["|b1",l],ever_captured:["|b1",l]},u={rewards:["<f4",i],involved:["|b1",i,3],fault:["|b1",i,3]},h={},m=w=>{
for(let b of Object.keys(w))(h[b]??=[]).push(Array.from(p.read(b),Number))},p=r.world(n);p.reset(e.start);let y=[];m(c);for(let w of s)p.step(w),m({...c,...u}),
y.push(...p.conflictTable());p.free();let f={"<i4":Int32Array,"<f4":Float32Array,"|b1":Uint8Array},g={};for(let[w,[b,...O]]of Object.entries({...c,...u})){let k=o+
+(w in c);g[w]={dtype:b,shape:[k,...O],data:f[b].from((h[w]??[]).flat())}}let v=w=>({dtype:"<i8",shape:[],data:Int32Array.of(w,0)}),x=w=>({dtype:"<U",shape:[],data:w});
return _t({format:x(wc),n_pursuers:v(n.n_pursuers),config:x(JSON.stringify(n)),seat:v(t),...g,actions:{dtype:"|i1",shape:[o,i],data:Int8Array.from(s.flatMap(w=>[
...w]))},map:{dtype:"|b1",shape:[n.rows,n.cols],data:Uint8Array.from(a.obstacles,Number)},conflict_table:{dtype:"<i4",shape:[y.length/11,11],data:Int32Array.from(
y)}})}var xc=[0,1,2,4,8],Nr=class{element;player=new _e(0,{speed:4,still:we()});#e;#r;#t=d("canvas",{tabindex:0,"aria-describedby":"play-keys"});#n=d("h2");#a=d("p",{
class:"play-told",role:"status"});#s=ya(e=>this.act(e));#u=Q(xc.map(e=>[e,e?`${e} / s`:"step by step"]),()=>this.#C());#m=d("input",{type:"checkbox",onchange:()=>this.#A()});#d=d(
"input",{type:"checkbox",onchange:()=>this.#E()});#p=d("label",{class:"play-choice"},this.#d,"Best move");#f=d("p",{class:"small muted play-keys",id:"play-keys"});#o=d(
"section",{class:"play-ending",tabindex:-1,"aria-labelledby":"play-headline"});#l=kr(this.player);#c=null;#i=null;#y=[];#g=null;#w=null;#b=[];#v=0;#h=0;constructor(e){
this.#e=e,this.#r=new Re(this.#t,{numbers:!1}),this.#t.setAttribute("role","application"),ga(this.#r,()=>{let t=this.#g!==null&&this.#i&&P(this.#i.recording.moments.
at(-1),this.#g);return t?{cell:t,diagonal:this.#i.config.diagonal}:null},t=>this.act(t)),this.player.addEventListener("frame",()=>this.#i&&this.#r.show(this.#i.
recording,this.player.time)),this.player.addEventListener("step",()=>this.#E()),this.element=d("div",{class:"play"},d("header",{class:"play-head"},this.#n,this.#a),
d("div",{class:"play-stage"},this.#t),d("div",{class:"play-side"},this.#o,this.#s.element,d("label",{class:"play-choice",title:"Steps a second"},"Pace ",this.#u),
d("label",{class:"play-choice"},this.#m,d("span",{},"Fog",d("span",{class:"at-length"},": see only what it sees"))),this.#p,this.#f),this.#l)}get played(){return this.#c&&
{...this.#c.played,moves:this.#y}}get live(){return this.#i}play(e){this.#x(Tt(this.#e,e.played),e.played.seat,e.title),[this.#c,this.#y,this.#v]=[e,[...e.played.
moves],0],this.element.dataset.state="playing",this.#t.focus({preventScroll:!0}),ar(this.#i,e.played.seat)&&this.#_()}watch(e,t,n){this.#c=null,this.#x(e,t,n),this.#k()}stop(){
this.#C(),this.player.pause(),this.#c=null}act(e){let[t,n]=[this.#c,this.#i];if(!t||!n||this.element.dataset.state!=="playing")return;this.#v=e;let s=Number(this.#u.
value);this.#h||(this.#P(),s&&this.element.dataset.state==="playing"&&(this.#h=setInterval(()=>this.#P(),1e3/s)))}key(e){let{target:t,key:n}=e;if(t instanceof HTMLSelectElement||
t instanceof HTMLInputElement&&(t.type==="text"||n===" ")||t instanceof HTMLButtonElement&&(n===" "||n==="Enter")||!this.#i)return!1;if(this.element.dataset.state!==
"playing")return Cr(this.player,e);let o=fa(e,this.#i.config.diagonal);return o!==void 0&&this.act(o),o!==void 0}#x(e,t,n){this.#C(),this.player.pause(),[this.#i,
this.#g]=[e,t],this.#n.textContent=n,this.#t.ariaLabel=`Board, ${e.config.rows} by ${e.config.cols} cells`,this.#s.show(e.config.diagonal),this.#f.replaceChildren(
d("span",{class:"at-length"},`W A S D or the arrow keys move, Space stays${e.config.diagonal?"; Q E Z C and the numeric keypad move diagonally":""}. `),"On the \
board: swipe, or tap where to go."),this.#S(e),this.#o.replaceChildren(),this.player.length=e.length,this.player.jump(e.length),this.#E()}#A(){this.#r.look={you:this.#g,
fog:this.#m.checked,viewers:this.#g===null?[]:[this.#g],plan:this.#T()}}#S(e){this.#w=null,this.#b=this.player.ticks=[],this.#p.hidden=this.#d.disabled=!!qt(e.config),
_r(this.#e,e.config,la(e.config)).then(t=>{this.#i===e&&(this.#w=t,this.#O(),this.#E())})}#O(){let[e,t]=[this.#i,this.#w];if(!t||this.element.dataset.state==="p\
laying")return;let n=this.#e.world(e.config);n.reset(e.start),this.#b=$r(t,n,e.actions),n.free(),this.player.ticks=Pr(this.#b)}get#M(){return this.#d.checked&&this.#c&&
this.element.dataset.state==="playing"&&this.#w&&this.#i.game(this.#w)||null}#T(){let[e,t]=[this.#g,this.#g!==null&&this.#M?.marginal(this.#g)];return e!==null&&
t?Object.assign(Array(e).fill(0),{[e]:t.indexOf(Math.max(...t))}):null}#C(){clearInterval(this.#h),this.#h=0,this.#a.ariaLive=Number(this.#u.value)?"off":"polit\
e"}#P(){let[{policies:e,seat:t},n]=[this.#c.played,this.#i];n.step(e,t,this.#v),this.#y.push(this.#v),this.player.length=n.length,this.player.glide=Math.min(.22,
.9/(Number(this.#u.value)||4)),this.player.move(n.length-this.player.step),ar(n,t)&&this.#_()}#_(){this.#C();let[e,t,n]=[this.#c,this.#i,this.played],s=he()?e.link(
n):null,o=`${se(n.seat,t.config.n_pursuers)}-${t.length}-steps.npz`,a=()=>qe(o,Sa(this.#e,t,n.seat)),i=Zt("Link to this match");i.hidden=!0,this.#o.replaceChildren(
d("h3",{id:"play-headline"},Mc(t,n.seat)),...e.ending(t,n),d("div",{class:"play-buttons"},d("button",{type:"button",class:"primary",onclick:()=>e.again()},"Agai\
n"),d("button",{type:"button",onclick:()=>this.#k()},"Watch it"),d("button",{type:"button",onclick:a},"Save"),s&&d("button",{type:"button",onclick:()=>Xt(i,s)},
e.linkName??"Link")),i),this.element.dataset.state="ended",this.player.jump(t.length),this.#O();let l=this.#b.filter(({team:c})=>c===pe(t.config,n.seat));l.length&&
this.#o.children[0].after(d("p",{class:"small muted"},ua(l))),this.#o.focus({preventScroll:!0}),this.#o.scrollIntoView({block:"nearest"})}#k(){this.element.dataset.
state="watched",this.player.length=this.#i.length,this.player.jump(0),we()||this.player.play()}#E(){let[e,t,{step:n}]=[this.#i,this.#g,this.player];if(!e||n>e.length)
return;let s=Rr(e,e.recording,n).filter(({agents:l})=>t===null||l.includes(t)),o=this.#c&&n===0,a=o?[Sc(e.config,t),this.#c.about??""]:[`Step ${n} of ${e.config.
max_steps}`,...s.map(({text:l})=>l)];!o&&t!==null&&a.push(Ac(e,n,t)),a.push(...this.#b.filter(l=>l.step===n).map(Rt));let i=n===e.length&&t!==null?this.#M:null;
i&&a.push(`Perfect play: ${da(i,t)||"decided in its turn"}; ${ha(this.#w,i,n)}`),this.#A(),this.#a.textContent=a.filter(Boolean).map(l=>`${l}.`).join(" ")}};function Sc(r,e){
let t=r.rules.capture==="SURROUND";return pe(r,e)==="evader"?`Run away: you win if ${t?"the pursuers do not surround you":"no pursuer reaches your cell"} in ${r.
max_steps} steps`:`Capture evaders: ${t?"surround them with your team":"move onto their cells"}`}function Ac({config:r,recording:e},t,n){let s=e.moments[t],a=pe(
r,n)==="pursuer"?"evader":"pursuer";if(!s.alive[n])return"";let i=P(s,n),l=h=>{let[m,p]=P(s,h);return Math.max(Math.abs(m-i[0]),Math.abs(p-i[1]))},c=Array.from(
{length:s.alive.length},(h,m)=>m).filter(h=>pe(r,h)===a&&s.alive[h]&&!s.captured[h-r.n_pursuers]&&2*l(h)<r.fov);if(!c.length)return`No ${a} in view`;let u=c.reduce(
(h,m)=>l(m)<l(h)?m:h);return`Nearest ${a}: ${va(i,P(s,u))}`}function Mc(r,e){let[{lasted:t,out:n,captured:s},{config:o}]=[be(r,e),r];return pe(o,e)==="pursuer"?
`Your team captured ${s} of ${Tc(o)} in ${t} steps.`:n?`You lasted ${t} of ${o.max_steps} steps.`:`You escaped: ${t} steps.`}var Tc=({n_evaders:r})=>`${r} evade\
r${r===1?"":"s"}`;var Ec=60,Oc={evader:"Can you escape them?",pursuer:"Can you catch them?"},Lr=class{dialog=d("dialog",{class:"take-over","aria-label":"Play against the champion\
s",onclose:()=>this.view?.stop(),onkeydown:e=>this.view?.key(e)&&e.preventDefault()});view=null;#e;#r;constructor(e,t){[this.#e,this.#r]=[e,t]}play(e,{world:t,policies:n,
players:s,seed:o,rate:a,friend:i},l){this.view||(this.view=new Nr(this.#e),this.dialog.append(d("button",{type:"button",class:"leave",onclick:()=>this.dialog.close()},
"Close"),this.view.element)),this.dialog.open||this.dialog.showModal();let c={...t,max_steps:Math.min(Ec,t.max_steps)},u=e==="evader"?c.n_pursuers:0,h=({lasted:f,
captured:g})=>e==="evader"?f:g,m=e==="evader"?c.max_steps:c.n_evaders,p=f=>e==="evader"?`survived ${f} of ${m} steps`:`caught ${f} of ${m} with the team`,y=f=>({
pursuer:n.pursuer.genome,evader:n.evader.genome,seed:String(f.seed),episode:f.episode,seat:u,rate:a,score:h(be(Tt(this.#e,f),u))});Un(this.#e,this.view,{config:c,
seed:BigInt(l.seed),episode:l.episode,policies:n,seat:u,from:0,moves:[]},{title:Oc[e],players:s,linkName:"Challenge a friend",about:`Seed ${o}: these pursuers c\
atch ${a} %. ${i?`Your friend ${p(i.score)}`:"You have the seat with the ring"}`,told:f=>i?h(f)>i.score?`You beat your friend, who ${p(i.score)}.`:`Your friend ${p(
i.score)}: ${h(f)===i.score?"a draw":"not beaten yet"}.`:"",link:f=>this.#r(y(f))})}};var Kn={right:12,top:10,bottom:42},Ir={x:56,y:34,letter:8,label:30};function Aa(r,e,t,n){let{top:s}=Kn,o=Math.max(s+40,e-Kn.bottom),a=St(n.low,n.high,(o-s)/Ir.y,
n.whole),i=Ir.label+Ir.letter*Math.max(2,...a.map(g=>Yn(g).length)),l=Math.max(i+40,r-Kn.right),c=(g,v,x)=>w=>v+(w-g.low)/(g.high-g.low||1)*(x-v),[u,h]=[c(t,i,l),
c(n,o,s)],m=S("g"),p=S("svg",{width:r,height:e,viewBox:`0 0 ${r} ${e}`,class:"plot"}),y=S("g",{class:"axes"});for(let g of a)y.append(S("line",{x1:i,x2:l,y1:h(g),
y2:h(g),class:"grid"}),S("text",{x:i-8,y:h(g),"text-anchor":"end","dominant-baseline":"middle"},Yn(g)));for(let g of St(t.low,t.high,(l-i)/Ir.x,t.whole))y.append(
S("text",{x:u(g),y:o+16,"text-anchor":"middle"},Yn(g)));return y.append(S("line",{x1:i,x2:l,y1:o,y2:o,class:"axis"}),S("text",{x:(i+l)/2,y:e-6,"text-anchor":"mi\
ddle",class:"label"},t.label),S("text",{transform:`translate(12 ${(s+o)/2}) rotate(-90)`,"text-anchor":"middle",class:"label"},n.label)),p.append(y,m),{root:p,marks:m,
left:i,right:l,top:s,bottom:o,x:u,y:h,at:g=>{let v=g-p.getBoundingClientRect().left;return t.low+(v-i)/(l-i)*(t.high-t.low)}}}var Yn=r=>String(Number(r.toPrecision(
6))).replace("-","−");function Ma(r,e,t,n){let s="",o="M";t.forEach((a,i)=>{a===null?o="M":(s+=`${o}${r.x(e[i]).toFixed(1)} ${r.y(a).toFixed(1)}`,o="L")}),r.root.
insertBefore(S("path",{d:s,class:`line ${n}`}),r.marks)}function Ta(...r){return d("p",{class:"legend small"},...r.map(([e,t])=>d("span",{class:`key ${t}`},e)))}function Ea(r,e,t,n){let s=d("div",{class:"chart choose\
s",role:"img","aria-label":r}),o=null,a=()=>{o?.marks.replaceChildren(),o&&t(o)};s.addEventListener("click",l=>o&&n(o.at(l.clientX),o,l));let i=()=>{let{clientWidth:l,
clientHeight:c}=s;l<50||c<50||(o=e(l,c),s.replaceChildren(o.root),a())};return new ResizeObserver(i).observe(s),{element:s,update:a,redraw:i}}var Oa=0,Ca=1,Cc=2,kc=176;function Ra(r,e,t,n){let s=devicePixelRatio||1,o=rt(r);r.width=r.height=kc*s;let a=r.getContext("2d");if(!a)return;let{fov:i}=e,l=r.width/
i;a.fillStyle=o.paper,a.fillRect(0,0,r.width,r.height);for(let u=0;t&&u<i*i;u++){let[h,m]=[(u%i+.5)*l,(Math.floor(u/i)+.5)*l],p=f=>!!t[f*i*i+u];p(Cc)&&(a.fillStyle=
o.obstacle,a.fillRect(h-l/2,m-l/2,l,l));let y=p(Oa)&&p(Ca)?l*.18:0;p(Oa)&&ka(a,De,h+y,m+y,l*.74,o.evader),p(Ca)&&ka(a,xr,h-y,m-y,l*.86,o.pursuer)}a.strokeStyle=
n<e.n_pursuers?o.pursuer:o.evader,a.lineWidth=2*s;let c=Math.floor(i/2)*l;a.strokeRect(c,c,l,l)}function ka(r,e,t,n,s,o){e(r,t,n,s),r.fillStyle=o,r.fill()}var Rc=["stay","↑","→","↓","←","↗","↘","↙","↖"];function _a(r,{inputs:e,ratings:t,refused:n},s,o){let a=r.kind==="rating"&&!r.hidden.length?r.genome:
null,i=y=>a?.[y]??1,l=y=>r.kind==="rating"?i(y)!==0:new RegExp(`\\b${r.inputs[y]}\\b`).test(o),c=[...r.inputs.keys()].filter(l).sort((y,f)=>Math.abs(i(f))-Math.
abs(i(y))),u=y=>`${y===s?"taken":""} ${n[y]?"refused":""}`,h=(y,f)=>d("tr",{class:f.every(g=>g===f[0])?"same":""},y,...Array.from(f,(g,v)=>d("td",{class:u(v)},Je(
g)))),m=y=>{let f=r.inputs[y];return d("th",{scope:"row",title:`${a?`weight ${Je(i(y))} x `:""}${Pe[f]}`},f.replaceAll("_"," "))},p=d("table",{class:"why number\
s"},d("thead",{},d("tr",{},d("th",{},a?"term":"input"),...Array.from(t,(y,f)=>d("th",{scope:"col",class:u(f),title:ee[f],"aria-label":ee[f]},Rc[f]))),h(d("th",{
scope:"row"},a?"sum":"rating"),t)),d("tbody",{},...c.map(y=>h(m(y),e[y].map(f=>i(y)*f)))));return[...o?[d("p",{class:"expression"},d("code",{},o))]:[],d("div",{
class:"wide-table",tabindex:0,role:"group","aria-label":"How the moves are rated"},p)]}var _c=(r,{pursuer:e,evader:t})=>({pursuers:ke(r,"pursuer",e),evaders:ke(r,"evader",t)}),$a="What it remembers: a number for each unit, from -1 to 1",st=class{element;#e;#r=d(
"canvas",{class:"seen",role:"img"});#t=d("h3");#n=d("p",{class:"small muted"});#a=d("div",{class:"answers"});#s=d("div",{title:$a});#u=null;#m=null;#d=null;#p=null;#f=null;#o=null;#l=null;#c=0;constructor(e){
this.#e=e,this.element=d("div",{class:"inspector","data-open":"false"},d("p",{class:"hint small muted"},"Click an agent, or press A: what it sees, and why it ta\
kes its move."),d("div",{class:"inspected"},this.#r,d("div",{class:"answer"},this.#t,this.#n,this.#s),this.#a))}get agent(){return this.#l}show(e,t,n,s,o=_c(t,s)){
this.#u?.free(),this.#u=e.world(n.config),this.#d!==t&&(this.#m=null,this.#l!==null&&this.choose(null)),[this.#d,this.#p,this.#f,this.#o]=[t,n,s,o]}set solution(e){
this.#m=e,this.at(this.#c)}choose(e){this.#l=e,this.element.dataset.open=String(e!==null),this.#e(e),this.at(this.#c)}next(e){let t=this.#p;if(!t)return;let n=this.#l??
(e>0?-1:0);for(let s=0;s<t.n_agents;s++)if(n=(n+e+t.n_agents)%t.n_agents,t.alive[this.#c*t.n_agents+n])return this.choose(n)}at(e){this.#c=e;let[t,n,s,o,a,i]=[this.#p,
this.#u,this.#d,this.#f,this.#o,this.#l];if(!t||!n||!s||!o||!a||i===null)return;let l=i<t.config.n_pursuers?"pursuer":"evader";this.#s.replaceChildren(),this.#t.
replaceChildren(d("span",{class:l},se(i,t.config.n_pursuers))),t.seek(n,e,a);let c=t.actions.subarray(e*t.n_agents,(e+1)*t.n_agents);for(;c.length&&!n.over&&(i<
n.actors[0]||i>=n.actors[1]);)n.playTurn(c);let u=!!(t.alive[e*t.n_agents+i]&&n.read("alive")[i]);Ra(this.#r,t.config,u?n.view(i):null,i),this.#r.ariaLabel=`Fie\
ld of view of ${se(i,t.config.n_pursuers)}: evaders, pursuers and obstacles around it`;let h=c[i]??null;if(!u)return this.#i([],"It is gone.");let m=a[`${l}s`],
p=typeof m!="string"&&m.kind==="cells"?n.answer(m,i):null,y=p?.probabilities??null;p?.memory.length&&this.#s.replaceChildren(d("p",{class:"small muted"},"It rem\
embers:"),Nc(p.memory));let f=typeof m!="string"&&m.kind!=="cells"?_a(m,n.rate(m,i),h,yo(s,l,o[l])):[],g=this.#m?.game(n)??null,v=typeof m=="string"?`The script\
 "${m}" plays for it${h===null?"":`; it goes ${ee[h]}`}.`:m.kind!=="cells"?"It takes the best move that its mask allows; of equal ones any.":m.sampled?"Its acti\
on is drawn from these probabilities.":"It takes the most probable action.",x=[["network",y],["perfect",g?.marginal(i)??null]],w=b=>d("p",{class:"small muted"},
b);this.#i([...g?[w(`Value ${g.value.toFixed(2)} under perfect play.`)]:[],...$c(x,h),...f],h===null?"The episode is over.":v)}#i(e,t){this.#a.replaceChildren(...e),
this.#n.textContent=t}};function $c(r,e){let t=r.filter(([,o])=>o);if(!t.length)return[];let n=d("div",{class:"action muted"},d("span"),...t.map(([o])=>d("span",
{class:"head"},o))),s=Array.from(t[0][1],(o,a)=>d("div",{class:a===e?"action taken":"action"},d("span",{},ee[a]),...t.flatMap(([,i])=>Pc(i[a]))));return t.length>
1||t[0][0]!==r[0][0]?[n,...s]:s}function Pc(r){let e=d("span",{class:"filled"});return e.style.width=`${100*r}%`,[d("span",{class:"track"},e),d("span",{class:"n\
umbers"},r.toFixed(2))]}function Nc(r){let e=Array.from(r,t=>{let n=d("span",{title:t.toFixed(2)});return n.style.transform=`scaleY(${t})`,n});return d("div",{class:"\
units",role:"img","aria-label":$a},...e)}var Lc=40,Fr=class{element;#e;#r=d("div",{class:"episodes",role:"group","aria-label":"Episodes of this cell"});#t=d("p",{class:"check small numbers","aria-live":"\
polite"});constructor(e){this.#e=e,this.element=d("div",{class:"strip-of-episodes"},this.#r,this.#t)}show(e,t){let{pursuer:n,evader:s,episode:o,seed:a}=this.#e.
selected,i=Ce(e,n,s);this.#r.replaceChildren(...(i?.rates??[]).slice(0,Lc).map((m,p)=>this.#n(m,p)));let l=a===null?i?.rates[o]:void 0,c=t.statistics.capture_rate,
u=l!==void 0&&Math.abs(c-l)<1e-6&&t.length===i?.lengths[o],h=i?"Not an episode of the evaluation":"The evaluation played no episodes of this pair.";this.#t.dataset.
equal=String(u),this.#t.textContent=u?"As in the evaluation":l===void 0?h:`Episode ${o+1} differs from the evaluation.`,this.#t.title=`Played here: capture rate\
 ${G(c,3)} in ${t.length} steps.${i?` The cell says ${G(i.rate,3)}.`:""}`}#n(e,t){let{selected:n}=this.#e,s=d("span",{class:"bar"});return s.style.height=`${Math.
round(100*e)}%`,d("button",{type:"button",class:"episode",title:`Episode ${t+1}: capture rate ${G(e)}`,"aria-label":`Episode ${t+1}, capture rate ${G(e)}`,"aria\
-pressed":String(t===n.episode&&n.seed===null),onclick:()=>this.#e.select({episode:t,seed:null})},s,d("span",{class:"count"},t+1))}};function Pa(r){let e=JSON.stringify(r,(t,n)=>t==="genome"?Array.from(n):n);return d("script",{type:"application/json",id:"champions"},e.replaceAll("<","\\u003c")).
outerHTML}var $t="_",Ic="n",hp=2n**64n-1n;var qn={fov:11,maxSteps:500,rewards:"paper"},Fc=["rules","others","rewards","size","diagonal","fov","limit","seed","ended","walls","pursuers","evaders","played",
"next"];function Ia(r,e){let t=i=>i.map(l=>Uc(l,e)).join(""),n=i=>`${Math.floor(i/r.cols)}.${i%r.cols}`,s=Dc(r.rewards,e),o=[r.seed,r.episode,r.steps].join("."),a={rules:La(
r.rules,e),others:r.others?La(r.others,e):"",rewards:s===qn.rewards?"":s,size:`${r.rows}x${r.cols}`,diagonal:r.diagonal?"1":"",fov:r.fov===qn.fov?"":String(r.fov),
limit:r.maxSteps===qn.maxSteps?"":String(r.maxSteps),seed:o==="0.0.0"?"":o,ended:r.ended?"1":"",walls:r.walls.map(n).join($t),pursuers:r.pursuers.map(Na).join($t),
evaders:r.evaders.map(Na).join($t),played:r.played.map(t).join($t),next:r.next.every(i=>i===Ys)?"":t(r.next)};return Fc.filter(i=>a[i]).map(i=>`${i}=${a[i]}`).join(
"&")}function Na({cell:r,gone:e,captured:t,everCaptured:n}){let s=t?"c":n?"e":"";return`${r[0]}.${r[1]}${s}${e?"x":""}`}function La(r,e){let t=e.fields.map(({name:n})=>String(
r[n]).toLowerCase());return qs(r,e.variants)??t.join(".")}function Dc(r,e){let t=JSON.stringify(r);return Object.keys(e.rewards).find(s=>JSON.stringify(e.rewards[s])===
t)??Object.values(r).map(s=>String(s)).join($t)}function Uc(r,e){if(typeof r=="number")return String(r);if(r===Ks)return Ic;let t=e.scripts.findIndex(({name:n})=>n===
r);return String.fromCharCode(97+t)}var Wc="/* the engine */";function Fa(r,e){return d("button",{type:"button",class:"to-playground",title:"Open this step in the playground (G): the same agents a\
nd actions under any rules",onclick:()=>Bc(r(),e)},"What if?")}function Bc(r,e){let t=r!==null&&r.match.n_agents<=yn&&Math.max(r.match.config.rows,r.match.config.
cols)<=fn,n=t?d("script",{type:"text/plain",id:"scene"},Ia(jc(r.match,r.step),e)).outerHTML:"",s=new TextDecoder().decode(Rn("playground")).replace(Wc,()=>me("s\
cript-engine")).replace("</noscript>",i=>i+n+(t?Pa(r.champions):"")),o=d("iframe",{title:"Playground",srcdoc:s}),a=d("dialog",{class:"what-if","aria-label":"Wha\
t if?",onclose:()=>a.remove()},d("button",{type:"button",class:"leave",onclick:()=>a.close()},"Back to the match"),o);document.body.append(a),a.showModal()}function jc(r,e){
let{config:t,n_agents:n}=r,s=Math.max(0,e-1),o=i=>{let l=s*n+i,c=s*t.n_evaders+i-t.n_pursuers,u=h=>i>=t.n_pursuers&&!!h[c];return{cell:[r.last_positions[2*l],r.
last_positions[2*l+1]],gone:!r.alive[l],captured:u(r.captured),everCaptured:u(r.ever_captured)}},a=Array.from({length:n},(i,l)=>o(l));return{rules:t.rules,others:null,
rewards:t.rewards,rows:t.rows,cols:t.cols,diagonal:t.diagonal,fov:t.fov,maxSteps:t.max_steps,seed:r.seed,episode:BigInt(r.episode),steps:s,ended:s===r.length,walls:Array.
from(r.map.keys()).filter(i=>r.map[i]),pursuers:a.slice(0,t.n_pursuers),evaders:a.slice(t.n_pursuers),played:[],next:Array.from(r.actions.subarray(s*n,(s+1)*n))}}var zc=60,Dr=class{element;player=new _e(0,{speed:Er,still:we()});inspector;match=null;recording=null;actions;#e;#r;#t;#n;#a=d("h2",{class:"match-title"});#s=d(
"p",{class:"tally numbers"});#u=d("ol",{class:"words",tabindex:0,"aria-live":"off","aria-label":"What happened in this step"});#m=d("p",{class:"problem",role:"a\
lert"});#d=d("div",{class:"shown","aria-live":"polite"});#p=null;#f=null;#o=0;#l=!1;#c=0;#i=[];constructor(e,t,n){[this.#r,this.#t]=[e,t];let s=d("canvas",{"ari\
a-label":"The match",onclick:({clientX:o,clientY:a})=>this.inspector.choose(this.#e.agentAt(o,a))});this.#e=new Re(s,{numbers:!1}),this.#n=new Fr(t),this.inspector=
new st(o=>this.#O(o)),this.actions=d("div",{class:"match-actions"},d("button",{type:"button",class:"to-play",title:"Move the chosen agent, or an evader, yoursel\
f from this step on (T)",onclick:()=>this.element.dispatchEvent(new Event("takeover"))},"Take over"),n&&Fa(()=>this.shown,n)),this.element=d("section",{class:"c\
ard match-card","aria-label":"Match",id:"match"},d("div",{class:"match"},d("header",{class:"match-head"},this.#a,this.#s),this.#m,this.#d,d("div",{class:"stage"},
s),d("div",{class:"aside"},this.#u,Qt(),this.actions,this.inspector.element),kr(this.player),this.#n.element)),this.player.addEventListener("frame",()=>this.recording&&
this.#e.show(this.recording,this.player.time)),this.player.addEventListener("step",()=>this.#A()),t.on("match",()=>this.#w()),this.#x(),this.#S(0,0)}get#y(){return this.#r[this.#t.
selected.run]}reveal(){(this.#y.game?this.#d:this.#e.canvas).scrollIntoView({block:"nearest"})}get shown(){return this.match&&this.#f&&{match:this.match,step:this.
player.step,champions:this.#f}}start(e){this.#p=e,this.#b()}playSoon(){this.#l=!0,this.#o||this.#g()}goTo(e){this.#c=e,!this.#o&&this.match&&this.#b()}#g(){!this.#l||
!this.match||(this.#l=!1,this.player.jump(0),we()||this.player.play())}#w(){this.#x(),clearTimeout(this.#o),this.#o=setTimeout(()=>this.#b(),zc)}#b(){clearTimeout(
this.#o),this.#o=0,this.player.pause(),this.#x();let{selected:e}=this.#t,{game:t}=this.#y;if(this.#d.replaceChildren(...t?mo(this.#y,t,e,this.#t):[]),t){this.match=
this.recording=null,this.#l=!1,this.#v(e);return}let n=At.map(a=>po(this.#y,a,e[a])).find(Boolean)??"";if(this.#m.textContent=n,n||!this.#p)return;this.match=go(
this.#p,this.#y,e);let[s,o]=this.names(e);this.#f={pursuer:{name:s,policy:ke(this.#y,"pursuer",e.pursuer)},evader:{name:o,policy:ke(this.#y,"evader",e.evader)}},
this.recording=or(this.match),this.#n.show(this.#y,this.match),this.inspector.show(this.#p,this.#y,this.match,e),this.player.length=this.match.length,this.player.
marks=vr(this.recording),this.#i=this.player.ticks=[],this.player.jump(this.#c),this.#c=0,this.#A(),this.#h(this.#p,this.match),this.#v(e),this.#g()}#v({run:e,pursuer:t,
evader:n,episode:s,seed:o}){this.element.dataset.played=`${e} ${t} ${n} ${s} ${o??""}`}async#h(e,t){let n=await _r(e,t.config);if(this.match!==t||!n)return;let s=e.
world(t.config);t.seek(s,0),this.#i=$r(n,s,Gc(t)),s.free(),this.player.ticks=Pr(this.#i),this.inspector.solution=n,this.#A()}names({run:e,pursuer:t,evader:n}){let s=this.#r[e],
{teams:o}=s;return[o.pursuer.script??re(s,"pursuer",t),o.evader.script??re(s,"evader",n)]}#x(){let{episode:e,seed:t}=this.#t.selected,{game:n,payoff:s}=this.#y;
this.element.classList.toggle("of-own-game",!!n),this.element.classList.toggle("of-ratings",At.some(l=>fo(this.#y,l)));let[o,a]=this.names(this.#t.selected),i=t===
null?e<s.episodes?`episode ${e+1} of ${s.episodes}`:`episode ${e+1}, not part of the cell`:`seed ${t}`;this.#a.replaceChildren(d("span",{class:"pursuer"},sr(o)),
" against ",d("span",{class:"evader"},a),n?"":d("span",{class:"muted small"},i))}#A(){let e=this.match;if(!e||!this.recording)return;let t=this.player.step,n=this.
recording.moments[t];this.#S(Array.from(n.everCaptured).filter(Boolean).length,t),this.#u.replaceChildren(...this.#i.filter(s=>s.step===t).map(s=>d("li",{class:`\
loss-${s.team}`},Rt(s))),...Rr(e,this.recording,t).map(s=>d("li",{class:s.kind,"data-agents":s.agents.join(" ")},s.text))),this.inspector.at(t),this.#M()}#S(e,t){
let{world:n}=this.#y;n&&this.#s.replaceChildren(d("strong",{},e),` of ${n.n_evaders} captured`,d("span",{class:"muted"},` · step ${t}`))}#O(e){this.#e.look={selected:e,
viewers:e===null?[]:[e]},this.#M()}#M(){let e=this.inspector.agent;for(let t of this.#u.children){let n=t.dataset.agents?.split(" ")??[];t.classList.toggle("abo\
ut",e!==null&&n.includes(String(e)))}}},Gc=({actions:r,length:e,n_agents:t})=>Array.from({length:e},(n,s)=>r.subarray(s*t,(s+1)*t));var Hc={ArrowUp:[1,0],ArrowDown:[-1,0],ArrowRight:[0,1],ArrowLeft:[0,-1]},Vc=5;function Ua(r,e,t,n="pursuer"){r.tabIndex=0,r.setAttribute("role","application"),
r.addEventListener("keydown",s=>{let o=Hc[s.key];if(!o)return;let[a,i]=n==="pursuer"?o:[o[1],o[0]],[l,c]=t(),u=s.shiftKey?Vc:1,{pursuer:h,evader:m}=e.selected;e.
select({pursuer:Da(h+u*a,l),evader:Da(m+u*i,c)}),s.preventDefault(),s.stopPropagation()})}var Da=(r,e)=>Math.min(e-1,Math.max(0,r));var Pt=[[68,1,84],[72,26,108],[71,47,125],[65,68,135],[57,86,140],[49,104,142],[42,120,142],[35,136,142],[31,152,139],[34,168,132],[53,183,121],[84,197,104],[122,
209,81],[165,219,54],[210,226,27],[253,231,37]];function Ur(r){let e=Math.min(1,Math.max(0,r))*(Pt.length-1),t=Math.min(Pt.length-2,Math.floor(e)),[n,s]=[Pt[t],
Pt[t+1]],o=a=>Math.round(n[a]+(e-t)*(s[a]-n[a]));return[o(0),o(1),o(2)]}function Wa(r){let[e,t,n]=Ur(r).map(s=>((s/255+.055)/1.055)**2.4);return .2126*e+.7152*t+
.0722*n>.179?"#000":"#fff"}var Ba=r=>`rgb(${Ur(r).join(" ")})`,ja=()=>`linear-gradient(to right, ${Pt.map(r=>`rgb(${r.join(" ")})`).join(", ")})`;function za(r,e,t){let n=devicePixelRatio||1;for(let[a,i]of Object.entries(t))r.style.setProperty(a,`${i}px`);r.width=Math.round(t.width*n),r.height=Math.round(
t.height*n);let s=r.getContext("2d"),o=Kc(e);!s||!o||(s.imageSmoothingEnabled=!1,s.drawImage(o,0,0,r.width,r.height))}function Kc(r){let[e,t]=r.shape,n=document.
createElement("canvas");[n.width,n.height]=[t,e];let s=n.getContext("2d");if(!s)return null;let o=s.createImageData(t,e);return r.capture_rate.forEach((a,i)=>a.
forEach((l,c)=>{let u=4*((e-1-i-r.first[0])*t+c+r.first[1]);o.data.set([...Ur(l),255],u)})),s.putImageData(o,0,0),n}function Ga(r,e,t,n=2){r.textContent=G(e,n),
r.ariaLabel=`${t}: ${r.textContent}`,e!==void 0&&([r.style.backgroundColor,r.style.color]=[Ba(e),Wa(e)])}function Jn(r,e){let t=d("span",{class:"gradient"});return t.
style.backgroundImage=ja(),d("p",{class:"scale-of-rates small muted"},r,t,e)}var Yc=24,Wr=7,Va=r=>r<Yc&&matchMedia("(pointer: coarse)").matches;function Ka(r,e,t,n){let[s,o]=r.payoff.shape,[a,i]=[Ha(e,s),Ha(t,o)],[l,c]=[Math.min(Wr,s),Math.
min(Wr,o)],u=[];for(let f=a+l-1;f>=a;f--){u.push(d("span",{class:"pursuer"},f));for(let g=i;g<i+c;g++)u.push(qc(r,f,g,n))}let h=Array.from({length:c},(f,g)=>d("\
span",{class:"evader"},i+g)),m=d("button",{type:"button","aria-label":"Close: all cells",onclick:()=>n(null)},"✕"),y=d("div",{class:"loupe numbers",role:"grou\
p","aria-label":"Cells around the tap",onclick:f=>f.stopPropagation()},...u,m,...h);return y.style.gridTemplateColumns=`2.4rem repeat(${c}, minmax(0, 1fr))`,y}function qc(r,e,t,n){
let s=d("button",{type:"button",onclick:()=>n({pursuer:e,evader:t})});return Ga(s,Ce(r,e,t)?.rate,`${re(r,"pursuer",e)} against ${re(r,"evader",t)}`),s}var Ha=(r,e)=>Math.
max(0,Math.min(e-Wr,r-Math.floor(Wr/2)));var ae={left:52,bottom:46,top:76,right:84},fe=10,Jc=160,Nt=ae.right-fe-14,Ue=ae.top-fe-14,Br=class{element;#e;#r;#t=d("canvas",{"aria-hidden":"true"});#n=S("svg",
{"aria-hidden":"true"});#a=S("g");#s;#u=d("h2");#m=d("strong",{class:"rate numbers"});#d=d("span",{class:"small muted"});#p=d("p",{class:"of-both-teams small mu\
ted numbers"});#f;#o=null;constructor(e,t){[this.#r,this.#e]=[e,t],this.#s=d("div",{class:"matrix",id:"matrix","aria-label":"Payoff matrix. Arrow keys choose a \
match, Enter plays it.",onpointermove:s=>this.#h(s),onpointerleave:()=>t.point({}),onclick:s=>this.#x(s),onkeydown:({key:s})=>s==="Enter"&&this.#S()},this.#t,this.#n);
let n=d("header",{class:"readout","aria-live":"polite"},d("div",{},this.#u,this.#p),d("div",{class:"of-cell"},this.#m,this.#d));this.#f=Jn(...Oe(this.#l).ends),
this.element=d("section",{class:"card matrix-card","aria-label":"Payoff matrix"},n,this.#s,this.#f),this.#w(),new ResizeObserver(()=>this.#c()).observe(this.#s),
this.#s.addEventListener("mousedown",s=>{s.preventDefault(),document.activeElement instanceof HTMLElement&&document.activeElement.blur()}),Ua(this.#s,t,()=>this.#l.
payoff.shape),t.on("run",()=>{let s=Jn(...Oe(this.#l).ends);this.#f.replaceWith(s),this.#f=s,this.#c()}),t.on("match hover",()=>this.#g())}get#l(){return this.#r[this.#e.
selected.run]}#c(){let[e,t]=this.#l.payoff.shape,{clientWidth:n,clientHeight:s}=this.#s;if(n<50)return;let a=Math.max(Jc,Math.min(n-ae.left-ae.right,s-ae.top-ae.
bottom))/Math.max(e,t),i=Math.max(ae.left,(n-t*a-ae.right+ae.left)/2),l=ae.top+Math.max(0,(s-ae.top-ae.bottom-e*a)/2),c={width:n,height:s,left:i,top:l,cell:a,rows:e,
columns:t};this.#o=c,za(this.#t,this.#l.payoff,{left:i,top:l,width:t*a,height:e*a});for(let[u,h,m]of[["left",i,n],["top",l,s],["width",t*a,n],["height",e*a,s]])
this.#t.style.setProperty(u,`${100*h/m}%`);this.#s.style.setProperty("--shape",`${n} / ${s}`),this.#n.setAttribute("viewBox",`0 0 ${n} ${s}`),this.#n.replaceChildren(
Zc(c,Oe(this.#l).generation),...Xc(c),...this.#y(c),this.#a),this.#g()}#i(e){let t=this.#l.findings?.generalization;if(!t)return[];let{selected:n,hover:s}=this.#e,
[o,a]=[s.pursuer??n.pursuer,s.evader??n.evader],[i,l]=Ya(e,t.pursuers.mean[o]??0,o),[c,u]=qa(e,t.evaders.mean[a]??0,a);return[S("circle",{class:"dot of-pursuers",
cx:i,cy:l,r:5}),S("circle",{class:"dot of-evaders",cx:c,cy:u,r:5})]}#y(e){let t=this.#l.findings?.generalization;if(!t)return[];let{left:n,top:s,cell:o,rows:a,columns:i}=e,
{curves:l}=Oe(this.#l),[c,u]=[n+i*o+fe,s-fe],h={class:"side"};return[S("rect",{...h,x:c,y:s,width:Nt,height:a*o}),S("rect",{...h,x:n,y:u-Ue,width:i*o,height:Ue}),
...Ja(t.pursuers,(m,p)=>Ya(e,m,p),"of-pursuers"),...Ja(t.evaders,(m,p)=>qa(e,m,p),"of-evaders"),S("text",{class:"tick",x:c,y:s+a*o+16,"text-anchor":"start"},"0"),
S("text",{class:"tick",x:c+Nt,y:s+a*o+16,"text-anchor":"end"},"1"),S("text",{class:"tick",x:n-6,y:u-4,"text-anchor":"end"},"0"),S("text",{class:"tick",x:n-6,y:u-
Ue+8,"text-anchor":"end"},"1"),S("text",{class:"label of-pursuers",x:c+Nt,y:s+a*o+34,"text-anchor":"end"},l.pursuer),S("text",{class:"label of-evaders",x:n+i*o+
fe,y:u-Ue+10,"text-anchor":"start"},l.evader)]}#g(){let e=this.#o;if(!e)return;let{selected:t,hover:n}=this.#e,{left:s,top:o,cell:a,rows:i,columns:l}=e,c=y=>o+(i-
1-y)*a,u=[],h=(y,f)=>S("rect",{class:f,x:s,y:c(y),width:l*a+fe+Nt,height:a}),m=(y,f)=>S("rect",{class:f,x:s+y*a,y:o-fe-Ue,width:a,height:fe+Ue+i*a});u.push(h(t.
pursuer,"strip pursuer"),m(t.evader,"strip evader")),n.pursuer!==null&&n.pursuer<i&&u.push(h(n.pursuer,"strip hover")),n.evader!==null&&n.evader<l&&u.push(m(n.evader,
"strip hover")),u.push(...this.#i(e));let p={x:s+t.evader*a,y:c(t.pursuer),width:a,height:a};u.push(S("rect",{class:"chosen under",...p}),S("rect",{class:"chose\
n",...p})),this.#a.replaceChildren(...u),this.#w()}#w(){let{selected:e,hover:t}=this.#e,n=t.pursuer??e.pursuer,s=t.evader??e.evader,o=Ce(this.#l,n,s);this.#u.replaceChildren(
d("span",{class:"pursuer"},sr(re(this.#l,"pursuer",n)))," against ",d("span",{class:"evader"},re(this.#l,"evader",s))),this.#m.textContent=o?G(o.rate,3):"-";let a=o&&
o.rates.length>1?`, mean of ${o.rates.length} episodes`:"";this.#d.textContent=o?Oe(this.#l).score+a:"no episodes were played",this.#p.textContent=this.#b(n,s)}#b(e,t){
let n=this.#l.findings?.generalization;if(!n)return"";let s=(a,i)=>ho(a.mean[i]??null,a.low?.[i]??null,a.high?.[i]??null),{means:o}=Oe(this.#l);return`Against a\
ll: ${o.pursuer} ${s(n.pursuers,e)}, ${o.evader} ${s(n.evaders,t)}`}#v(e){let t=this.#o;if(!t)return null;let n=this.#s.getBoundingClientRect(),s=Math.floor((e.
clientX-n.left-t.left)/t.cell),o=t.rows-1-Math.floor((e.clientY-n.top-t.top)/t.cell),[a,i]=[o>=0&&o<t.rows,s>=0&&s<t.columns];return a||i?{g:a?o:-1,h:i?s:-1,inside:a&&
i}:null}#h(e){let t=this.#v(e);this.#e.point(t?{pursuer:t.g<0?null:t.g,evader:t.h<0?null:t.h}:{})}#x(e){let t=this.#v(e);if(t){if(t.inside&&Va(this.#o.cell))return this.#A(
t.g,t.h);this.#e.select({...t.g<0?{}:{pursuer:t.g},...t.h<0?{}:{evader:t.h}}),t.inside&&this.#S()}}#A(e,t){let n=Ka(this.#l,e,t,s=>{n.remove(),s&&(this.#e.select(
s),this.#S())});this.#s.append(n)}#S(){this.#s.dispatchEvent(new CustomEvent("play",{bubbles:!0}))}};function Zc({left:r,top:e,cell:t,rows:n,columns:s},o){let a=S(
"g",{class:"axes"}),i=e+n*t,l=c=>St(0,c-1,Math.min(c,c*t/44),!0);for(let c of l(s))a.append(S("text",{class:"tick",x:r+(c+.5)*t,y:i+16,"text-anchor":"middle"},c));
for(let c of l(n))a.append(S("text",{class:"tick",x:r-7,y:i-(c+.5)*t,"text-anchor":"end","dominant-baseline":"middle"},c));return a.append(S("text",{class:"labe\
l of-evaders",x:r+s*t/2,y:i+36,"text-anchor":"middle"},o.evader),S("text",{class:"label of-pursuers",transform:`translate(${r-36} ${e+n*t/2}) rotate(-90)`,"text\
-anchor":"middle"},o.pursuer)),a}function Xc({left:r,top:e,cell:t,rows:n,columns:s}){let o=S("g",{class:"diagonal"}),a=Math.min(n,s);if(a<3)return[];let i=e+n*t;
for(let u of["H","V"]){let h=`M${r} ${i}`;for(let m=1;m<=a;m++){let[p,y]=[`H${r+m*t}`,`V${i-m*t}`];h+=u==="H"?p+y:y+p}o.append(S("path",{d:h,class:"under"}),S("\
path",{d:h}))}let[l,c]=[r+a/2*t-.7*t-4,i-a/2*t-.7*t-4];return[o,S("text",{class:"on-cells",transform:`translate(${l} ${c}) rotate(-45)`,"text-anchor":"middle"},
"same generation")]}var Ya=({left:r,top:e,cell:t,rows:n,columns:s},o,a)=>[r+s*t+fe+o*Nt,e+(n-a-.5)*t],qa=({left:r,top:e,cell:t},n,s)=>[r+(s+.5)*t,e-fe-n*Ue];function Ja(r,e,t){
let n=o=>o.map((a,i)=>e(a??0,i).map(l=>l.toFixed(1)).join(" ")),s=[];return r.low&&r.high&&s.push(S("path",{class:`band ${t}`,d:`M${[...n(r.high),...n(r.low).reverse()].
join("L")}Z`})),s.push(S("path",{class:`line ${t}`,d:`M${n(r.mean).join("L")}`})),s}var Za={pursuer:null,evader:null},jr=class extends EventTarget{#e;#r=Za;constructor(e){super(),this.#e=e}get selected(){return this.#e}get hover(){return this.#r}select(e){
let t=this.#e,n=["run","pursuer","evader"].some(s=>s in e&&e[s]!==t[s]);this.#e={...t,...n?{episode:0,seed:null}:{},...e},this.#e.run!==t.run&&this.dispatchEvent(
new Event("run")),this.dispatchEvent(new Event("match"))}point(e){let t={...Za,...e};t.pursuer===this.#r.pursuer&&t.evader===this.#r.evader||(this.#r=t,this.dispatchEvent(
new Event("hover")))}on(e,t){for(let n of e.split(" "))this.addEventListener(n,t)}};var Qc=8,eu=900,Xa=1800,Lt=class extends EventTarget{element;player=new _e(0,{speed:Qc,still:we()});match=null;agent=null;#e=d("figcaption");#r=d("canvas",{onclick:({
clientX:e,clientY:t})=>this.#m(e,t)});#t;#n=d("p",{class:"small muted numbers"});#a=d("p",{class:"small",role:"status"});#s=null;#u=!1;constructor(){super(),this.#t=
new Re(this.#r,{numbers:!1}),this.element=d("figure",{class:"chase"},this.#e,this.#r,this.#n,this.#a),this.player.addEventListener("frame",()=>this.#d()),this.player.
addEventListener("step",()=>this.#p()),this.player.addEventListener("state",()=>this.over&&this.dispatchEvent(new Event("over")))}get over(){return this.player.
length>0&&!this.player.playing&&this.player.step===this.player.length}get title(){return this.#e.textContent}get recording(){return this.#s}show(e,t){[this.match,
this.#s]=[e,or(e)],this.#e.textContent=t,this.#r.ariaLabel=`A match. ${t}`,this.player.jump(0),this.player.length=e.length,this.player.marks=vr(this.#s),this.#p()}choose(e){
this.agent=e,this.#t.look={selected:e,viewers:e===null?[]:[e]},this.dispatchEvent(new Event("agent"))}#m(e,t){this.#u||this.choose(this.#t.agentAt(e,t))}#d(){this.#s&&
this.#t.show(this.#s,this.player.time)}#p(){let e=this.#s?.moments[this.player.step]?.everCaptured;e&&(this.#n.textContent=`${Array.from(e).filter(Boolean).length}\
 of ${e.length} caught in ${this.player.step} steps`),this.dispatchEvent(new Event("step"))}drawWalls(e){let t=!1,n=!0,s=[0,0],o=([l,c])=>!!this.#s?.obstacles[l*
this.#s.cols+c],a=(l,c)=>{this.#a.textContent=e(l,c)},i=l=>{let c=this.#t.cellAt(l.clientX,l.clientY);c&&o(c)!==n&&a(c,n)};return this.#r.addEventListener("poin\
terdown",l=>{let c=t&&this.#t.cellAt(l.clientX,l.clientY);c&&(this.#r.setPointerCapture(l.pointerId),n=!o(c),i(l))}),this.#r.addEventListener("pointermove",l=>t&&
l.buttons&&i(l)),this.#r.addEventListener("keydown",l=>{let c={ArrowUp:[-1,0],ArrowDown:[1,0],ArrowLeft:[0,-1],ArrowRight:[0,1]}[l.key];if(!t||!this.#s||!(c||l.
key===" "))return;l.preventDefault();let u=(p,y)=>Math.min(y-1,Math.max(0,p)),{rows:h,cols:m}=this.#s;c?s=[u(s[0]+c[0],h),u(s[1]+c[1],m)]:a(s,!o(s)),this.#t.look=
{cursor:s}}),l=>{t=this.#u=l,this.#r.classList.toggle("drawn-on",l),this.#r.tabIndex=l?0:-1,this.#r.setAttribute("role",l?"application":"img"),this.#t.look={cursor:null}}}showWalls(e){
this.#s&&(this.#s={...this.#s,obstacles:e},this.#d())}},zr=class{boards;#e;#r=-1/0;#t=0;#n=!we();constructor(e,...t){[this.#e,this.boards]=[e,t];for(let n of t)
n.addEventListener("over",()=>this.#n&&t.every(({over:s})=>s)&&this.#a(eu))}get runs(){return this.#n}set runs(e){this.#n=e,clearTimeout(this.#t),this.#t=0;for(let{
player:t}of this.boards)e?t.play():t.pause()}renew(e=!1){e||performance.now()-this.#r>Xa?this.#s():this.#t||this.#a(Xa)}#a(e){clearTimeout(this.#t),this.#t=setTimeout(
()=>this.#s(),e)}#s(){if(clearTimeout(this.#t),[this.#t,this.#r]=[0,performance.now()],this.#e(),this.#n)for(let{player:e}of this.boards)e.play()}};var M=r=>Array.from(r).reduce((e,t)=>e+t,0)/r.length,Zn=(r,e)=>e==="pursuer"?r:r[0].map((t,n)=>r.map(s=>1-s[n]));var Qa=-12676506002282294e14,ei=({hidden:r,mask:e})=>r.map(t=>t+(e?4:0));function It(r){let e=[3*r.fov**2,...ei(r),5],t=0;return e.slice(1).map((n,s)=>{let o={at:t,
inputs:e[s],outputs:n};return t+=(o.inputs+1)*n,o})}function xe(r){if(r.kind==="rating")return r.inputs.length;let{at:e,inputs:t,outputs:n}=It(r).at(-1);return e+
(t+1)*n}var Ft=(r,e)=>r.kind==="rating"?{...r,genome:e}:{kind:"cells",hidden:ei(r),activation:"relu",sampled:!0,memory:"none",genome:e};function ti(r,e,t){let n=t.
initial_weight;if(r.kind==="rating"||t.kind==="rating")return e.normals(xe(r)).map(i=>Math.fround(n)*i);let s=t.initial_head,o=new Float32Array(xe(r)),a=It(r);return a.
forEach(({at:i,inputs:l,outputs:c},u)=>{let h=Math.fround(u===a.length-1?s:n);e.normals(l*c).forEach((m,p)=>o[i+p]=h*m)}),o}function Xn(r){if(r.kind==="rating")
return null;let{fov:e,mask:t}=r;if(!t)return null;let[n,s]=[new Uint8Array(xe(r)),new Float32Array(xe(r))],o=It(r),a=o.length-1,i=Math.floor(e/2);return o.forEach(
({at:l,inputs:c,outputs:u},h)=>{let m=(p,y)=>l+p*u+y;for(let p=0;p<4;p++)if(h>0&&n.fill(1,m(c-4+p,0),m(c-4+p+1,0)),h<a)for(let y=0;y<=c;y++)n[m(y,u-4+p)]=1;t.forEach(
(p,y)=>{let f=h===a?1+y:u-4+y,g=h===0?p.map(([v,x,w])=>(v*e+i+x)*e+i+w):[c-4+y];for(let v of g)n[m(v,f)]=1,s[m(v,f)]=h===a?Qa:1})}),{fixed:n,values:s}}function Qn(r,e){
return e?r.map((t,n)=>e.fixed[n]?e.values[n]:t):r}function ri(r,e,t){if(e.kind==="rating"||t.kind==="rating")return r;let n=new Float32Array(xe(t)),[s,o]=[It(e),
It(t)],a=Math.floor(t.fov/2)-Math.floor(e.fov/2),i=c=>c>=0&&c<t.fov,l=c=>{let[u,h,m]=[Math.floor(c/e.fov**2),Math.floor(c/e.fov)%e.fov+a,c%e.fov+a];return i(h)&&
i(m)?(u*t.fov+h)*t.fov+m:-1};return s.forEach((c,u)=>{let h=o[u],m=e.hidden[u]??5;for(let p=0;p<(u?e.hidden[u-1]:c.inputs);p++){let y=u?p:l(p);if(!(y<0))for(let f=0;f<
m;f++)n[h.at+y*h.outputs+f]=r[c.at+p*c.outputs+f]}for(let p=0;p<m;p++)n[h.at+h.inputs*h.outputs+p]=r[c.at+c.inputs*c.outputs+p]}),Qn(n.map(c=>c<=Qa/2?0:c),Xn(t))}var ai={initial:1,noise:2,learn:3,opponents:4},ts={pursuer:1,evader:2,both:3},We=4,es=2n**32n;function ni(r){let e=[],t=BigInt(r);do e.push(Number(t%es)),t/=es;while(t>
0n);return e}function si(r,e){let t=r;return n=>{let s=n^t;return t=Math.imul(t,e),s=Math.imul(s,t),s^s>>>16}}function oi(r,e){let t=Math.imul(3389127133,r)-Math.
imul(1232336661,e)|0;return t^t>>>16}function rs(r,e,t){let n=r.flatMap(ni);if(e.length){for(;n.length<We;)n.push(0);n.push(...e.flatMap(ni))}let s=si(1135663077,
2468251765),o=Array.from({length:We},(i,l)=>s(n[l]??0));for(let i=0;i<We;i++)for(let l=0;l<We;l++)i!==l&&(o[l]=oi(o[l],s(o[i])));for(let i of n.slice(We))for(let l=0;l<
We;l++)o[l]=oi(o[l],s(i));let a=si(2337405405,1492356589);return Uint32Array.from({length:t},(i,l)=>a(o[l%We]))}function Dt(r,e){let t=rs(r,[],2*e);return BigUint64Array.
from({length:e},(n,s)=>BigInt(t[2*s])+es*BigInt(t[2*s+1]))}var Gr=(r,e,t)=>Dt([r,e,t],1)[0];var ii=r=>(e,...t)=>new ns(rs([r],[ai[e],...t],3)),ns=class{#e;#r;#t;#n=1;constructor(e){[this.#e,this.#r,this.#t]=[e[0],e[1],e[2]];for(let t=0;t<12;t++)this.#a()}#a(){
let e=this.#e+this.#r+this.#n++|0;return this.#e=this.#r^this.#r>>>9,this.#r=this.#t+(this.#t<<3)|0,this.#t=(this.#t<<21|this.#t>>>11)+e|0,e>>>0}#s(){return(this.#a()+
.5)/2**32}normals(e){let t=new Float32Array(e);for(let n=0;n<e;n+=2){let[s,o]=[Math.sqrt(-2*Math.log(this.#s())),2*Math.PI*this.#s()];t[n]=s*Math.cos(o),n+1<e&&
(t[n+1]=s*Math.sin(o))}return t}integers(e,t){return Int32Array.from({length:t},()=>Math.floor(this.#s()*e))}permutation(e){return this.choice(e,e)}choice(e,t){
let n=Int32Array.from({length:e},(s,o)=>o);for(let s=0;s<t;s++){let o=s+Math.floor(this.#s()*(e-s));[n[s],n[o]]=[n[o],n[s]]}return n.slice(0,t)}};var $=Math.fround,tu=5,ru=256,Hr=class{size;sigma;fixed;#e;constructor(e,t,n,s){[this.size,this.sigma,this.fixed]=[e,n,s],this.#e=t.normals((1+ru)*e);for(let o=0;o<
this.#e.length;o++)this.#e[o]*=$(n)}draw(e,t){let n=t.integers(this.#e.length-this.size+1,e);return Array.from(n,s=>{let o=this.#e.subarray(s,s+this.size);return this.
fixed?o.map((a,i)=>this.fixed[i]?0:a):o})}},ss=class{#e;#r;#t=0;constructor(e){[this.#e,this.#r]=[new Float32Array(e),new Float32Array(e)]}moved(e,t,n){let[s,o,
a]=[.9,.999,$(1e-8)];this.#t+=1;let[i,l]=[$(1-s),$(1-o)],[c,u]=[$(1-s**this.#t),$(1-o**this.#t)];return e.map((h,m)=>{let p=t[m],y=this.#e[m]+=$(i*$(p-this.#e[m])),
f=this.#r[m]+=$(l*$($(p*p)-this.#r[m])),g=$($(Math.sqrt($($(f)/u)))+a);return $(h+$($($(n)*$($(y)/c))/g))})}};function nu(r){let e=Array.from(r).sort((t,n)=>t-n);
return r.map(t=>(e.indexOf(t)+e.lastIndexOf(t))/(2*(r.length-1))-.5)}var Vr=class{genome;groups;#e;#r;#t;#n=[];constructor(e,t,n){[this.genome,this.#r,this.#e,this.#t]=
[e,t,n,new ss(e.length)],this.groups=Int32Array.from({length:n.population},(s,o)=>o%(n.population/2))}get#a(){let{sigma:e,fixed:t}=this.#r,[n,s]=[0,0];return this.
genome.forEach((o,a)=>{t?.[a]||(n+=o*o,s+=1)}),Math.max(e,this.#e.relative_sigma*Math.sqrt(n/s))}ask(e){let[t,n]=[this.#e.population/2,this.genome.length];this.#n=
this.#r.draw(t,e);let s=$(this.#a/this.#r.sigma),o=new Float32Array(2*t*n);return this.#n.forEach((a,i)=>{for(let l=0;l<n;l++){let c=$(s*a[l]);o[i*n+l]=this.genome[l]+
c,o[(t+i)*n+l]=this.genome[l]-c}}),o}tell(e){let[t,n]=[nu(e),this.#n.length],s=new Float32Array(this.genome.length);this.#n.forEach((o,a)=>{let i=$((t[a]-t[n+a])/
(2*n*this.#r.sigma**2));for(let l=0;l<s.length;l++)s[l]+=$(i*o[l])}),this.genome=this.#t.moved(this.genome,s,this.#e.learning_rate)}},Ut=class{population;groups;#e;#r;#t=new Float64Array(
0);#n=0;constructor(e,t,n){[this.population,this.#r,this.#e]=[e,t,n],this.groups=new Int32Array(n.population)}get genome(){return this.#a(this.#n).slice()}#a(e){
let{size:t}=this.#r;return this.population.subarray(e*t,(e+1)*t)}#s(e,t){let n=this.#e.tournament??tu,s=t.integers(this.#t.length,e*n);return Array.from({length:e},
(o,a)=>s.subarray(a*n,(a+1)*n).reduce((i,l)=>this.#t[l]>this.#t[i]?l:i))}ask(e){if(!this.#t.length)return this.population;let{size:t}=this.#r,{population:n,elites:s}=this.#e,
o=n-s,a=this.#s(o,e);this.#s(o,e);let i=Array.from(this.#t.keys()).sort((c,u)=>this.#t[u]-this.#t[c]).slice(0,s),l=new Float32Array(this.population.length);return[
...i,...a].forEach((c,u)=>l.set(this.#a(c),u*t)),this.#r.draw(o,e).forEach((c,u)=>{let h=(s+u)*t;for(let m=0;m<t;m++)l[h+m]+=c[m]}),this.population=l,l}tell(e){
this.#t=e,this.#n=e.indexOf(Math.max(...e))}};function li(r,e,t,n){let[s,o]=[r.length,Math.max(...r)+1],a=o>1?s/o:1,i=Array.from(r.keys()).sort((h,m)=>r[h]-r[m]),l=[],c=[];for(let h=0;h<e;h++){let m=h%a;m===
0&&(c=Array.from(n.permutation(s/a)).flatMap(p=>i.slice(p*a,(p+1)*a))),l.push([i,c.map((p,y)=>c[y-y%a+(y%a-m+a)%a])])}let u=h=>i.map(()=>s+h);for(let h=0;h<t[1];h++)
l.push([i,u(h)]);for(let h=0;h<t[0];h++)l.push([u(h),i]);return{pursuer:Int32Array.from(l.flatMap(([h])=>h)),evader:Int32Array.from(l.flatMap(([,h])=>h)),group:Int32Array.
from(l.flatMap((h,m)=>i.map(p=>m*o+r[p])))}}function ci(r,e,t,n){let s=Math.max(...e)+1,[o,a]=[new Float64Array(t*s),new Float64Array(t*s)];n.forEach((l,c)=>{if(r[c]>=
t)return;let u=r[c]*s+e[c];o[u]+=l,a[u]+=1});let i=o.map((l,c)=>a[c]?l/a[c]:0);return Float64Array.from({length:t},(l,c)=>{let u=i.subarray(c*s,(c+1)*s);return os(
u)/a.subarray(c*s,(c+1)*s).filter(Boolean).length})}var su=128,ot=8;function os(r){let{length:e}=r;if(e>su){let m=Math.floor(e/2)-Math.floor(e/2)%ot;return os(r.
subarray(0,m))+os(r.subarray(m))}if(e<ot)return r.reduce((m,p)=>m+p,0);let t=r.slice(0,ot),n=e-e%ot;for(let m=ot;m<n;m++)t[m%ot]+=r[m];let[s,o,a,i,l,c,u,h]=t;return r.
subarray(n).reduce((m,p)=>m+p,s+o+(a+i)+(l+c+(u+h)))}var T=["pursuer","evader"],Se=r=>r==="pursuer"?"evader":"pursuer";var ui=({world:r})=>r.rules.teammate==="REACH"?.2:0;var hi=["generation","team","epoch","opponent","fitness_mean","fitness_std","fitness_best","capture_rate","length","pursuer_faults","evader_faults","matches","s\
teps"],Yr={pursuer:["random","clumsy-fleer"],evader:["random","clumsy-chaser"]},ou=20,au=8,iu=-1,it=({world:r,policy:e},t,n)=>e.kind==="rating"?e:{kind:"cells",
fov:r.fov,hidden:e.hidden,mask:e.mask==="none"?null:t[n]},at=class{settings;epochs=0;until=1/0;archive={pursuer:[],evader:[]};rows=[];cells=new Map;counters={pursuer:[],
evader:[]};#e;#r;#t;#n={};#a=new Set;#s=0;#u=0;#m=0;constructor(e,t,n,s=ii(t.seed)){[this.#e,this.settings,this.#r,this.#t]=[e,t,n,s];for(let o of T){let a=s("i\
nitial",T.indexOf(o)),i=t.learner.kind==="ga"?t.learner.population:1,l=Array.from({length:i},()=>ti(this.shape(o),a,t.policy));this.#p(o,l),this.archive[o].push(
this.#n[o].genome)}this.#h(...T)}shape(e){return it(this.settings,this.#r,e)}get finished(){return Math.min(this.archive.pursuer.length,this.archive.evader.length)}*run(){
this.finished===1&&(yield*this.#x(0));for(let e=this.finished;e<=this.settings.schedule.generations;e++){if(this.settings.schedule.kind==="alternating")for(let t of T)
yield*this.#f(t,e),this.#h(t);else yield*this.#o(e),this.#h(...T);yield*this.#x(e)}}change(e){let t=this.settings,n={pursuer:this.shape("pursuer"),evader:this.shape(
"evader")},s=l=>JSON.stringify(l(t))===JSON.stringify(l(e));this.settings=e;let o=s(l=>[l.world.fov,l.policy]);if(!o||!s(l=>l.learner))for(let l of T){let c=u=>ri(
u,n[l],this.shape(l));this.archive[l]=this.archive[l].map(c),this.#p(l,this.#d(l).map(c))}if(o&&s(l=>l.world))return null;this.cells.clear(),this.#a.clear();let{
pursuer:a,evader:i}=this.archive;return{type:"anew",settings:e,genomes:{pursuer:a.slice(0,this.finished),evader:i.slice(0,this.finished)}}}#d(e){let t=this.#n[e];
if(!(t instanceof Ut))return[t.genome];let n=t.genome.length,s=Array.from({length:t.population.length/n},(o,a)=>t.population.slice(a*n,(a+1)*n));return Array.from(
{length:this.settings.learner.population},(o,a)=>a===0?t.genome:s[a%s.length])}#p(e,t){let{learner:n}=this.settings,[s,o]=[this.shape(e),n.kind==="ga"?n.mutation:
n.sigma],a=Xn(s),i=new Hr(xe(s),this.#t("noise",T.indexOf(e)),o,a?.fixed??null),l=t.map(c=>Qn(c,a));this.#n[e]=n.kind==="ga"?new Ut(Kr(l),i,n):new Vr(l[0],i,n)}*#f(e,t){
for(let n=0;n<this.#i(e);n++){for(;this.epochs>=this.until;)yield{type:"rest"};let s=this.archive[Se(e)].length,o=this.settings.schedule[`${e}s_meet`],a=o==="la\
test"?s-1:o==="round-robin"?n%s:this.#t("opponents",T.indexOf(e),t,n).choice(s,1)[0],i=e==="pursuer"?[t,a]:[a,t],l=this.#n[e],{groups:c}=l,u=Dt([this.settings.seed,
...i,ts[e],n],Math.max(...c)+1),h=l.ask(this.#t("learn",T.indexOf(e),t,n)),[m,p]=[Int32Array.from(c.keys()),new Int32Array(c.length)],y={[e]:h,[Se(e)]:this.archive[Se(
e)][a]},f={[e]:m,[Se(e)]:p},g=this.#g(y,f,BigUint64Array.from(c,x=>u[x])),v=this.#b(g,e);this.#v(g,v,{generation:t,team:e,epoch:n,opponent:a}),l.tell(v),yield*this.#y(
t,n,e)}this.archive[e].push(this.#n[e].genome)}*#o(e){for(let t=0;t<this.#i("pursuer");t++){for(;this.epochs>=this.until;)yield{type:"rest"};let{schedule:n,learner:{
population:s}}=this.settings,[o,a]=n.kind==="hall-of-fame"?[n.hall_sample,n.contemporaries]:[0,1],i={pursuer:this.#l("pursuer",e,t),evader:this.#l("evader",e,t)},
l=this.#t("opponents",0,e,t),c={pursuer:this.#c(o,l),evader:this.#c(o,l)},u=g=>Kr([i[g],...Array.from(c[Se(g)],v=>this.archive[g][v])]),h=[c.evader.length,c.pursuer.
length],m=li(this.#n.pursuer.groups,a,h,l),p=Dt([this.settings.seed,e,e,ts.both,t],Math.max(...m.group)+1),y={pursuer:u("pursuer"),evader:u("evader")},f=this.#g(
y,m,BigUint64Array.from(m.group,g=>p[g]));for(let g of T){let v=ci(m[g],m[Se(g)],s,this.#b(f,g));this.#v(f,v,{generation:e,team:g,epoch:t,opponent:iu}),this.#n[g].
tell(v)}yield*this.#y(e,t,"both")}for(let t of T)this.archive[t].push(this.#n[t].genome)}#l(e,t,n){return this.#n[e].ask(this.#t("learn",T.indexOf(e),t,n))}#c(e,t){
let n=this.archive.pursuer.length;return e?t.choice(n,Math.min(e,n)):new Int32Array(0)}#i(e){let{schedule:t}=this.settings;return t.kind==="hall-of-fame"?t.joint_epochs:
t[`${e}_epochs`]}*#y(e,t,n){let[s,o]=this.settings.schedule.kind==="hall-of-fame"?[this.#i("pursuer"),0]:[this.#i("pursuer"),this.#i("evader")],a=t+1+(n==="evad\
er"?s:0),i=s+o;this.epochs+=1,yield{type:"epoch",done:(e-1)*i+a,of:this.settings.schedule.generations*i},yield*this.catchUp()}#g(e,t,n){let s={...this.settings.
world,max_steps:this.settings.train_steps},o=this.#e.rollouts(s,this.#w("pursuer",e.pursuer),this.#w("evader",e.evader),{...t,seed:n},1);this.#s+=o.length.length;
for(let a of o.length)this.#u+=Number(a);for(let a of o.agent_steps)this.#m+=Number(a);return o}#w(e,t){return Ft(this.shape(e),t)}#b({captured_fraction:e,overlap:t},n){
let s=ui(this.settings);return Float64Array.from(e,(o,a)=>n==="pursuer"?o:1-o-s*Number(t[2*a+1]))}#v(e,t,n){let s=M(t),o=[0,0];e.faults.forEach((a,i)=>o[Math.floor(
i/3)%2]+=Number(a)),this.rows.push({...n,fitness_mean:s,fitness_std:Math.sqrt(M(t.map(a=>(a-s)**2))),fitness_best:Math.max(...t),capture_rate:M(e.capture_rate),
length:M(e.length),pursuer_faults:o[0]/e.length.length,evader_faults:o[1]/e.length.length,matches:this.#s,steps:this.#u})}#h(...e){for(let t of e)this.counters[t].
push({matches:this.#s,steps:this.#u,agent_steps:this.#m})}*#x(e){yield{type:"generation",number:e,genomes:{pursuer:this.archive.pursuer[e],evader:this.archive.evader[e]}},
yield*this.catchUp()}*catchUp(){for(let e=this.finished-1;e>=0;e--){for(let t=e;t>=0;t--)for(let[n,s]of t===e?[[e,e]]:[[e,t],[t,e]]){if(this.cells.has(`${n} ${s}`))
continue;let o=this.#A(n,s);this.cells.set(`${n} ${s}`,o),yield{type:"cell",cell:o}}this.#a.has(e)||(this.#a.add(e),yield{type:"scores",number:e,scores:{pursuer:this.#S(
"pursuer",e),evader:this.#S("evader",e)}})}}#A(e,t){let{world:n,evaluation_episodes:s,seed:o}=this.settings,a={pursuer:new Int32Array(1),evader:new Int32Array(1),
seed:BigUint64Array.of(Gr(o,e,t))},i=T.map(u=>this.#w(u,this.archive[u][u==="pursuer"?e:t])),l=this.#e.rollouts(n,...i,a,s),c=u=>{let h=Array.from(l[u],Number),
m=h.length/s;return Array.from({length:m},(p,y)=>M(h.filter((f,g)=>g%m===y)))};return{pursuer:e,evader:t,capture_rates:Array.from(l.capture_rate),lengths:Array.
from(l.length),means:{collisions:c("collisions"),faults:c("faults"),agent_steps:c("agent_steps"),survivors:c("survivors")}}}#S(e,t){let{world:n,seed:s}=this.settings,
[o,a]=[this.#w(e,this.archive[e][t]),new Int32Array(1)];return M(Yr[e].map((i,l)=>{let c=Dt([s,T.indexOf(e),l,au],1),u=e==="pursuer"?[o,i]:[i,o],h=M(this.#e.rollouts(
n,...u,{pursuer:a,evader:a,seed:c},ou).capture_rate);return e==="pursuer"?h:1-h}))}};function Kr(r){let e=new Float32Array(r.reduce((n,{length:s})=>n+s,0)),t=0;
for(let n of r)e.set(n,t),t+=n.length;return e}var as=r=>Array.from({length:r},()=>Array(r)),qr=class{learning=T;settings=[];command="";training={capture_rate:[],generation:[],learner:[],epochs:1,window:1,matches:0};limits="";name;schedule;seed;seeds=[];world;payoff;teams;findings=null;genomes={
pursuer:[],evader:[]};best=null;#e;#r;#t;constructor(e,t,n,s){[this.#t,this.#e,this.#r,this.name,this.schedule]=[e,t,s,n,n],[this.world,this.seed]=[e.world,String(
e.seed)],this.payoff=this.#n(),this.teams=this.#a()}get newest(){return this.genomes.pursuer.length-1}#n(){let{seed:e,schedule:{generations:t}}=this.#t,n=t+1;return this.
seeds=Array.from({length:n},(s,o)=>Array.from({length:n},(a,i)=>String(Gr(e,o,i)))),{first:[0,0],shape:[n,n],episodes:this.#t.evaluation_episodes,capture_rate:as(
n),capture_rates:as(n),lengths:as(n)}}#a(){let e=t=>{let n=`${this.#r} ${t}`;vo(n,Kr(this.genomes[t]));let{genome:s,...o}=Ft(it(this.#t,this.#e,t),this.genomes[t][0]??
new Float32Array(0));return{script:null,policy:{...o,genome_size:s.length},kept:[...this.genomes[t].keys()],genomes:n}};return{pursuer:e("pursuer"),evader:e("ev\
ader")}}policy(e,t){return this.playing(e,this.genomes[e][t])}playing(e,t){return Ft(it(this.#t,this.#e,e),t)}genomesOf({pursuer:e,evader:t}){return{pursuer:this.
genomes.pursuer[e],evader:this.genomes.evader[t]}}extend(e){let{capture_rate:t,capture_rates:n,lengths:s,shape:[o]}=this.payoff;if(this.#t={...this.#t,schedule:e.
schedule},!(o>e.schedule.generations)){this.payoff=this.#n();for(let a=0;a<o;a++)Object.assign(this.payoff.capture_rate[a],t[a]),Object.assign(this.payoff.capture_rates[a],
n[a]),Object.assign(this.payoff.lengths[a],s[a])}}add(e){for(let t of T)this.genomes[t].push(e[t]);this.teams=this.#a()}change(e,t){this.#t=e,this.world=e.world;
for(let n of T)this.genomes[n]=[...t[n]];this.best=null,[this.payoff,this.teams,this.findings]=[this.#n(),this.#a(),null]}addCell({pursuer:e,evader:t,capture_rates:n,
lengths:s}){this.payoff.capture_rate[e][t]=M(n),this.payoff.capture_rates[e][t]=[...n],this.payoff.lengths[e][t]=[...s],this.findings={generalization:this.#s()}}#s(){
let e=this.payoff.capture_rate,t=o=>({mean:o,low:null,high:null}),n=o=>{let a=o.filter(i=>i!==void 0);return a.length?M(a):null},s=[...this.genomes.pursuer.keys()];
return{pursuers:t(s.map(o=>n(e[o]))),evaders:t(s.map(o=>n(e.map(a=>a[o]===void 0?void 0:1-a[o]))))}}};var lu=1/4,mi=1.96,di=.05,is=5;function pi(r,e){let t=Array.from({length:e},(h,m)=>Array.from({length:e},(p,y)=>r.get(`${m} ${y}`)?.capture_rates));if(e<2||t.some(
h=>h.includes(void 0)))return null;let[n,s]=[t.map(h=>h.map(m=>M(m))),t.map(h=>h.map(m=>uu(m)))],o=Math.max(1,Math.round(e*lu)),a=h=>{let[m,p]=[Zn(n,h),h==="pur\
suer"?s:cu(s)],[y,f]=[[m[0].slice(-o)],m.slice(-o).map(b=>b.slice(-o))],g=b=>M(b.map(O=>M(O.slice(-o))/o))/b.length,v={value:M(f.map(M))-M(y.map(M)),reach:mi*Math.
sqrt(g(p.slice(-o))+g([p[0]]))},x=hu(m,p),w=mu(v,x);return{verdict:w==="better"&&!du(m.map(M),x.value)?"better by a jump":w,before:M(y[0]),after:M(f.map(M))}},i={
pursuer:a("pursuer"),evader:a("evader")},l=h=>{let m=Zn(n,h).map(M);return m.lastIndexOf(Math.max(...m))},c={pursuer:l("pursuer"),evader:l("evader")},u=n[c.pursuer][c.
evader];return{rate:u,best:c,teams:i,sentence:fu(u,i)}}var cu=r=>r[0].map((e,t)=>r.map(n=>n[t])),uu=r=>r.reduce((e,t)=>e+(t-M(r))**2,0)/Math.max(1,r.length-1)/r.
length;function hu(r,e){let t=r.length-1,n=r.map((i,l)=>l-t/2),s=n.reduce((i,l)=>i+l*l,0),o=n.map(i=>t*i/s),a=e.map(i=>M(i)/i.length);return{value:r.reduce((i,l,c)=>i+
o[c]*M(l),0),reach:mi*Math.sqrt(a.reduce((i,l,c)=>i+o[c]**2*l,0))}}function du(r,e){let t=r.map(c=>c*Math.sign(e)),[n,s]=[Math.floor(r.length/is),r.length%is],o=Array.
from({length:is},(c,u)=>M(t.slice(u*n+Math.min(u,s),(u+1)*n+Math.min(u+1,s)))),a=Math.max(2,Math.floor(r.length/10)),i=Math.max(...t.slice(a).map((c,u)=>c-t[u])),
l=Math.max(...o.slice(1).map((c,u)=>o[u]-c));return i<Math.abs(e)/2&&l<Math.abs(e)/4}function mu(...r){return r.every(({value:e,reach:t})=>e-t>di)?"better":r.every(
({value:e,reach:t})=>e+t<-di)?"weaker":"cannot tell"}var z=r=>`${Math.round(100*r)} %`,pu={better:"better than in generation 0","better by a jump":"better than \
in generation 0, most of it in one jump",weaker:"weaker than in generation 0","cannot tell":""};function fu(r,e){let t=`The best pursuers now catch ${z(r)} of t\
he best evaders.`,n=T.map(o=>pu[e[o].verdict]);if(n[0]===n[1])return n[0]?`${t} Both teams are ${n[0]}.`:`${t} Whether a team has become better since generation\
 0, this race cannot tell.`;let s=T.map((o,a)=>n[a]?`the ${o}s are ${n[a]}`:`of the ${o}s this race cannot tell`);return`${t} ${s[0][0].toUpperCase()}${s[0].slice(
1)}; ${s[1]}.`}function fi(r,{before:e,after:t}){let[n,s]=r==="pursuer"?[e,t]:[1-e,1-t];return r==="pursuer"?`Of the last ${Se(r)}s, pursuers of generation 0 ca\
tch ${z(n)}, the last pursuers ${z(s)}.`:`The last pursuers catch ${z(n)} of the evaders of generation 0, and ${z(s)} of the last evaders.`}var[yi,yu]=[1/3,1/10],[gu,vu]=[4,2],bu=12,gi=r=>r.length>1?`${r.slice(0,-1).join(", ")} and ${r.at(-1)}`:r[0]??"";function vi({phrases:r,words:e},t,n){let s=Object.
entries(n).map(([c,u])=>[c,Math.abs(u)]).sort(([,c],[,u])=>u-c),o=s[0]?.[1]||1/0,a=s.filter(([,c])=>c/o>=yi).slice(0,gu).map(([c])=>r[c][n[c]>0?1:0]),i=s.filter(
([,c])=>c/o>=yu&&c/o<yi).slice(0,vu).map(([c])=>r[c][2]),l=gi([...a,...i.length?[`minds ${gi(i)} little`]:[]])||"takes any move that is allowed";return`${t==="p\
ursuer"?"A":"An"} ${t} ${l}.`.replaceAll(/\{(\w+)\}/g,(c,u)=>e[t][u])}function bi(r,e,t,n){let s=n[t];if(s.kind!=="rating")return{};let{n_pursuers:o,n_evaders:a}=e.
config,i=Array.from({length:t==="pursuer"?o:a},(u,h)=>h+(t==="pursuer"?0:o)),l=r.world(e.config),c=s.inputs.map(()=>[]);for(let u=0;u<e.length;u+=Math.max(1,Math.
floor(e.length/bu))){e.seek(l,u,{pursuers:n.pursuer,evaders:n.evader});for(let h of i.filter(m=>e.alive[u*e.n_agents+m])){let{inputs:m,refused:p}=l.rate(s,h);m.
forEach((y,f)=>{let g=Array.from(y).filter((v,x)=>!p[x]);g.length&&c[f].push(M(g.map(v=>(v-M(g))**2)))})}}return l.free(),Object.fromEntries(s.inputs.map((u,h)=>[
u,s.genome[h]*Math.sqrt(c[h].length?M(c[h]):0)]))}var wu=2,xu=1.5,Jr=class{element=d("section",{class:"card weights-card","aria-label":"Weights of named inputs",hidden:!0});#e;#r;#t;#n=d("div",{class:"evolved"});#a=d(
"p",{class:"numbers",role:"status"});#s=d("button",{type:"button",onclick:()=>this.#c()},"As evolved");#u={pursuer:d("p"),evader:d("p")};#m=null;#d=null;constructor(e,t,n){
[this.#e,this.#r,this.#t]=[e,t,n],this.element.append(d("h3",{},"What they have learned"),d("p",{class:"small muted"},"An agent takes the move with the largest \
sum of weight x input. Drag a weight, and see at once what becomes of the team."),d("div",{class:"doings"},this.#s,this.#a),this.#n)}genome(e){return this.#d?.[e]??
this.#f[e]}get#p(){let{newest:e,best:t}=this.#m;return t??{pursuer:e,evader:e}}get#f(){return this.#m.genomesOf(this.#p)}show(e){e!==this.#m&&(this.#d=null),this.#m=
e;let{policy:t}=e.teams.pursuer;this.element.hidden=t?.kind!=="rating"||e.newest<1,!(t?.kind!=="rating"||this.element.hidden)&&(this.#d||this.#n.replaceChildren(
...T.map(n=>this.#o(n,t.inputs))),this.#i())}#o(e,t){let n=this.genome(e),s=Math.max(wu,xu*Math.max(...n.map(Math.abs)));return d("div",{class:"weights"},d("h4",
{class:e},`${e}s`),this.#u[e],...t.flatMap((o,a)=>{let i=d("span",{class:"numbers"},Je(n[a])),l=d("input",{type:"range",class:e,min:-s,max:s,step:"any",value:n[a],
title:Pe[o],"aria-label":`${e}s: ${o}`});return l.addEventListener("input",()=>{i.textContent=Je(Number(l.value)),this.#l(e,a,Number(l.value))}),[d("span",{title:Pe[o]},
o.replaceAll("_"," ")),l,i]}))}#l(e,t,n){this.#d??={pursuer:this.genome("pursuer").slice(),evader:this.genome("evader").slice()},this.#d[e][t]=n,this.#i(),this.#t()}#c(){
this.#d=null,this.show(this.#m),this.#t()}#i(){this.#s.disabled=!this.#d;let e=z(this.rate(this.#f));this.#a.textContent=this.#d?`Yours: ${z(this.rate(this.#d))}\
 are caught; as evolved: ${e}`:`${e} are caught`;let t=this.#m,n={pursuer:t.playing("pursuer",this.genome("pursuer")),evader:t.playing("evader",this.genome("eva\
der"))},s=this.#e.match(t.world,n.pursuer,n.evader,BigInt(t.seed));for(let o of T)this.#u[o].textContent=vi(this.#r,o,bi(this.#e,s,o,n))}rate({pursuer:e,evader:t},n=this.#p,s=this.#m){
let o=new Int32Array(1),a={pursuer:o,evader:o,seed:BigUint64Array.of(BigInt(s.seeds[n.pursuer][n.evader]))};return M(this.#e.rollouts(s.world,s.playing("pursuer",
e),s.playing("evader",t),a,s.payoff.episodes).capture_rate)}};var Su=12,Zr=class{#e=null;#r=null;#t=[];#n;constructor(e,t){this.#n=t;try{let n=new Blob([me("script-engine"),`
`,me(`script-${e}`)],{type:"text/javascript"});this.#r=new Worker(URL.createObjectURL(n)),this.#r.onerror=()=>this.#e||this.#a(),this.#r.onmessage=()=>this.#s(this.#r)}catch{
this.#a()}}send(e){this.#e?this.#e.postMessage(e):this.#t.push(e)}close(){this.send({type:"stop"}),this.#r?.terminate()}#a(){let{port1:e,port2:t}=new MessageChannel;
ls(t),this.#s(e)}#s(e){this.#e=e,e.onmessage=({data:t})=>t.type!=="ready"&&this.#n(t);for(let t of this.#t.splice(0))e.postMessage(t)}};function ls(r){let e=v=>r.
postMessage(v),t=Jt(),n=null,s=null,o=null,a=[],i=!1,l=0,c=!1,u=new MessageChannel,h=v=>{let x=n.change(v);e({type:"changed",at:n.epochs,settings:v}),x&&e(x),!s&&
n.finished<=v.schedule.generations?[s,i]=[n.run(),!0]:i||(o=n.catchUp())},m=()=>{i=!1,o=n.catchUp(),e({type:"stopped",at:n.epochs})},p=()=>{if(i&&s){for(;a.length&&
a[0].at<=n.epochs;)h(a.shift().settings);let{value:x,done:w}=s.next();return w?([s,i,o]=[null,!1,n.catchUp()],e({type:"end",at:n.epochs,seconds:l/1e3})):x.type===
"rest"?m():e(x),!0}let v=o?.next();return v&&!v.done?e(v.value):o=null,!!o},y=()=>{let v=performance.now(),x=!0;for(;x&&performance.now()<v+Su;)x=p();l+=performance.
now()-v,!(!x||c)&&(c=!0,u.port2.postMessage(null))},f=async v=>{if(v.type==="start")n=new at(await t,v.settings,v.masks),[s,o,a,i,l,n.until]=[n.run(),null,[...v.
plan],!0,0,v.until],e({type:"began"});else if(n)if(v.type==="change")a=[],n.until=1/0,h(v.settings);else if(v.type==="go")[n.until,i]=[1/0,!0];else if(v.type===
"stop")i&&m();else{let{settings:x,archive:w,rows:b,cells:O,counters:k,finished:R}=n;e({type:"saved",race:{settings:x,archive:w,rows:b,cells:O,counters:k,finished:R}})}else
return;y()},g=v=>{Promise.resolve().then(v).catch(x=>{s=o=null,e({type:"failed",message:String(x)})})};u.port1.onmessage=()=>{c=!1,g(y)},r.onmessage=({data:v})=>g(
()=>f(v)),e({type:"ready"})}var Au=100,Mu=.3,Tu=0,Xr=class extends EventTarget{element;chases;boards;before=new Lt;after=new Lt;settings;state="waiting";done=0;epochs=0;changed=[];seconds=0;outcome=null;kept=null;#e;#r;#t;#n=d(
"h2",{class:"lane-title"});#a=d("p",{class:"facts numbers"});#s=d("div",{class:"lane-room"});#u=d("section",{class:"card measures"});#m=d("details",{class:"lane\
-more",hidden:!0},d("summary",{},"More: every generation against every other, scores and collisions"),this.#s,this.#u);#d=d("div");#p;#f;#o;#l={pursuer:[],evader:[]};#c=new Map;#i;#y=()=>{};#g=0;#w=!0;#b=!1;#v=0;#h=null;constructor(e,t,n,s){
super(),[this.#e,this.#r,this.settings]=[e,t,s],this.#t=new Zr(n,a=>this.#A(a)),this.chases=new zr(()=>this.#P(),this.before,this.after),this.before.element.classList.
add("before"),this.boards=d("div",{class:"pair"},this.before.element,this.after.element),this.#f=new Jr(t,e,()=>this.#k(!0)),this.#p=new st(()=>{});let o=d("sec\
tion",{class:"card asked","aria-label":"An agent",hidden:!0},d("button",{type:"button",class:"leave",onclick:()=>this.#E(null,null)},"Close"),this.#p.element);for(let a of[
this.before,this.after])a.addEventListener("agent",()=>a.agent!==null&&this.#E(a,a.agent)),a.addEventListener("step",()=>!o.hidden&&a.agent!==null&&this.#R(a));
this.element=d("section",{class:"lane"},this.#n,this.#a,this.boards,d("p",{class:"hint small muted"},"Click an agent, or press A: what it sees, and why it moves\
."),o,this.#f.element,this.#m,this.#d),this.reset(s)}reset(e){this.#t.send({type:"stop"}),[this.settings,this.state,this.done,this.epochs,this.kept]=[e,"waiting",
0,0,null],this.#C();let{archive:t}=new at(this.#r,e,this.#e.masks);this.#o.add({pursuer:t.pursuer[0],evader:t.evader[0]}),this.#k(!0),this.#$()}start(e,t=[],n=1/0){
this.settings=e,this.#C(),this.settings=t.at(-1)?.settings??e,[this.state,this.done,this.epochs,this.kept]=["evolving",0,0,null],this.changed.splice(0),this.#x(
{type:"start",settings:e,masks:this.#e.masks,plan:t,until:n}),this.#$()}restore(e,t,n,s){this.settings=t.settings,this.#C();for(let o of Array(t.finished).keys())
this.#o.add({pursuer:t.archive.pursuer[o],evader:t.archive.evader[o]});for(let[o,a]of t.cells)this.#o.addCell(a),this.#c.set(o,a);this.#l={pursuer:[...t.scores.
pursuer],evader:[...t.scores.evader]},[this.settings,this.kept,this.seconds,this.epochs,this.done]=[e,t,t.seconds,n,1],this.changed.splice(0,1/0,...s),this.#O("\
ended"),this.#M()}stop(){this.#x({type:"stop"})}go(){this.state="evolving",this.#x({type:"go"}),this.#$()}change(e){if(this.state==="waiting")return this.reset(
e);this.settings=e,this.#x({type:"change",settings:e}),this.#$()}saved(){return this.kept?Promise.resolve(this.kept):new Promise(e=>{this.#h=e,this.#x({type:"sa\
ve"})})}async keep(){return{...await this.saved(),scores:this.#l,seconds:this.seconds}}get newestGeneration(){return this.#o.newest}get champions(){return{pursuer:this.#f.
genome("pursuer"),evader:this.#f.genome("evader")}}get run(){return this.#o}close(){this.#t.close(),this.chases.runs=!1}#x(e){this.#t.send(e)}#A(e){if(e.type===
"began"&&(this.#b=!0),!!this.#b){if(e.type==="generation")this.#o.add(e.genomes),this.#k(e.number===0);else if(e.type==="cell"){let{pursuer:t,evader:n}=e.cell;this.#o.
addCell(e.cell),this.#w&&t===n&&t===this.#o.newest&&this.#i.select({pursuer:t,evader:n}),this.#c.set(`${t} ${n}`,e.cell),(this.state==="stopped"||this.state==="\
ended")&&this.#O(this.state)}else if(e.type==="scores")for(let t of T)this.#l[t][e.number]=e.scores[t];else e.type==="changed"?(this.#o.extend(e.settings),this.
changed.push(e.at),this.epochs=e.at,e.settings.schedule.generations>this.#o.newest&&this.state==="ended"&&this.#S()):e.type==="anew"?(this.#o.change(e.settings,
e.genomes),this.#T(),this.#k(!0)):e.type==="epoch"?(this.epochs+=1,this.done=e.done/e.of):e.type==="stopped"?this.#O("stopped"):e.type==="end"?([this.seconds,this.
done]=[e.seconds,1],this.#O("ended")):e.type==="saved"?this.#h?.(e.race):e.type==="failed"&&(this.#a.textContent=`The race failed: ${e.message}`,this.state="sto\
pped");this.#v||(this.#v=setTimeout(()=>requestAnimationFrame(()=>this.#M()),Au))}}#S(){[this.state,this.outcome]=["evolving",null],this.#o.best=null}#O(e){let t=this.
outcome;this.state=e,this.outcome=pi(this.#c,this.#o.newest+1),this.#o.best=this.outcome?.best??null,this.outcome&&!t&&this.#k(!0),this.#N()}#M(){this.#v=0,this.#i.
dispatchEvent(new Event("run")),this.#y(),this.#$()}#T(){this.#c=new Map,this.#l={pursuer:[],evader:[]},this.outcome=null,this.#u.hidden=!0}#C(){let e=`race ${Tu++}`,
t=lr(this.settings);this.#o=new qr(this.settings,this.#e.masks,t,e),this.#T(),this.#E(null,null),[this.#w,this.#b]=[!0,!1],this.#i=new jr({run:0,pursuer:0,evader:0,
episode:0,seed:null});let[n,s]=[new Br([this.#o],this.#i),new Dr([this.#o],this.#i,null)];n.element.ariaLabel=`Payoff matrix. ${t}`,s.actions.remove();let o=d("\
dialog",{class:"of-cell-match","aria-label":"Match",onclose:()=>s.player.pause()},d("button",{type:"button",class:"leave",onclick:()=>o.close()},"Close"),s.element),
a=!1;n.element.addEventListener("play",()=>{let{pursuer:l,evader:c}=this.#i.selected;this.#w=!1,this.#o.payoff.capture_rate[l][c]!==void 0&&(o.showModal(),a||s.
start(this.#r),a=!0,s.playSoon())});let i=Ea(`Scores against scripts, by generation: ${Yr.pursuer.join(", ")} and ${Yr.evader.join(", ")}`,(l,c)=>{let u=this.settings.
schedule.generations,h=Aa(l,c,{low:0,high:u,label:"generation",whole:!0},{low:0,high:1,label:"score"});for(let m of T){let p=Array.from(this.#l[m],y=>y??null);Ma(
h,[...p.keys()],p,`of-${m}s`)}return h},()=>{},l=>{let c=Math.min(this.#o.newest,Math.max(0,Math.round(l)));this.#i.select({pursuer:c,evader:c})});this.#y=i.redraw,
this.#s.replaceChildren(n.element,d("section",{class:"card scores"},d("h3",{},"Against opponents that never change"),d("p",{class:"small muted"},"Captures of ra\
ndom walkers and of clumsy fleers; escapes from random walkers and from clumsy chasers."),Ta(["pursuers","of-pursuers"],["evaders","of-evaders"]),i.element)),this.#d.
replaceChildren(o)}#P(){let{newest:e,best:t}=this.#o;if(e<0)return;let[n,s]=[{pursuer:0,evader:0},this.#g++%this.#o.payoff.episodes],o=c=>this.#r.match(this.#o.
world,...this.#_(c),BigInt(this.#o.seeds[0][0]),s),{pursuer:a,evader:i}=t??{pursuer:e,evader:e},l=a===i?`generation ${a}`:`pursuers of generation ${a}, evaders \
of generation ${i}`;this.before.show(o(this.#o.genomesOf(n)),"Before: generation 0"),this.after.show(o(this.champions),e?t?`After: ${l}`:`Now: ${l}`:"Generation\
 0: nobody has learned anything yet");for(let c of[this.before,this.after])c.agent!==null&&this.#R(c,!0)}#_({pursuer:e,evader:t}){return[this.#o.playing("pursue\
r",e),this.#o.playing("evader",t)]}#k(e){this.#f.show(this.#o),this.chases.renew(e)}#E(e,t){for(let n of[this.before,this.after])n!==e&&n.agent!==null&&n.choose(
null);(this.#p.element.parentElement??{hidden:!0}).hidden=!e,e&&(this.#R(e,!0),this.#p.choose(t))}askNext(){let{match:e,player:{step:t},agent:n}=this.after,o=Array.
from({length:e?.n_agents??0},(a,i)=>((n??-1)+1+i)%e.n_agents).find(a=>e.alive[t*e.n_agents+a]);o!==void 0&&this.after.choose(o)}#R(e,t=!1){if(t){let n=e===this.
before,[s,o]=this.#_(n?this.#o.genomesOf({pursuer:0,evader:0}):this.champions),a=n?0:this.#o.newest;this.#p.show(this.#r,this.#o,e.match,{run:0,pursuer:a,evader:a,
episode:0,seed:null},{pursuers:s,evaders:o})}this.#p.at(e.player.step)}#$(){let{newest:e}=this.#o;this.element.dataset.state=this.state,this.#n.textContent=lr(this.
settings),this.#m.hidden=this.state==="waiting",this.#a.replaceChildren(...this.#I().map(t=>d("span",{},t))),this.element.dataset.newest=String(e),this.dispatchEvent(
new Event("state"))}#I(){let{newest:e}=this.#o;if(this.outcome)return[this.outcome.sentence];if(e<0)return[];let t=a=>{let i=this.#c.get(`${a} ${a}`);return i?M(
i.capture_rates):null};if(this.state==="waiting"||e<1){let a=t(0)??this.#f.rate(this.#o.genomesOf({pursuer:0,evader:0}),{pursuer:0,evader:0});return[`${z(a)} of\
 the evaders are caught.`,...a>Mu?["By chance: evaders that have not learned to flee run into pursuers that have not learned to hunt."]:[]]}let[n,s]=[t(e)??t(e-
1),t(0)],o=n===null||s===null?"":`: the pursuers catch ${z(n)} of the evaders; those of generation 0 caught ${z(s)}`;return[`Generation ${e} of ${this.settings.
schedule.generations}${o}.`]}#N(){let{outcome:e}=this;if(this.#u.hidden=!e,this.#u.ariaLabel=`What came out. ${lr(this.settings)}`,!e)return;let t=this.#c.get(`${this.#o.
newest} ${this.#o.newest}`),n=[["Score against scripts: generation 0",s=>z(this.#l[s][0]??0)],["Score against scripts: newest generation",s=>z(this.#l[s].at(-1)??
0)],["Collisions at fault in 1000 moves of the newest generation",(s,o)=>Eu(t,o).toFixed(1)]];this.#u.replaceChildren(d("h3",{},"In numbers"),...T.map(s=>d("p",
{},fi(s,e.teams[s]))),d("table",{class:"numbers"},d("thead",{},d("tr",{},d("td"),...T.map(s=>d("th",{scope:"col",class:s},`${s}s`)))),d("tbody",{},...n.map(([s,
o])=>d("tr",{},d("th",{scope:"row"},s),...T.map((a,i)=>d("td",{},o(a,i))))))),d("p",{class:"small muted"},"One race proves little: save it, and ",d("code",{},"m\
atrixworld judge")," says what happened on its way, and how surely."))}};function Eu({means:{faults:r,agent_steps:e}},t){let n=r.length/T.length;return 1e3*r.slice(
t*n,(t+1)*n).reduce((s,o)=>s+o,0)/Math.max(1,e[t])}var wi=r=>Ie(JSON.stringify(r,null,2)),cs=(r,...e)=>({dtype:"<f8",shape:e,data:Float64Array.from(r)}),Ou=r=>Math.sqrt(M(r.map(e=>(e-M(r))**2)));function Cu({settings:r,
finished:e}){let t=r.schedule.kind==="alternating"?T.map(n=>[n]):[T];return Array.from({length:e},(n,s)=>(s?t:[T]).map(o=>[s,o])).flat()}function ku({archive:r,
rows:e,counters:t},n,[s,o]){let a=e.filter(c=>c.generation===s&&o.includes(c.team)),i=Ie(a.map(c=>`${[n,...hi.map(u=>c[u])].join(",")}
`).join("")),l=c=>({dtype:"<f4",shape:[1,r[c][s].length],data:r[c][s]});return{...Object.fromEntries(o.map(c=>[`${c}s`,l(c)])),log:{dtype:`|S${Math.max(1,i.length)}`,
shape:[],data:i.length?i:new Uint8Array(1)},...Object.fromEntries(Object.entries(t[o.at(-1)][s]).map(([c,u])=>[c,cs([u])])),...n?{score:cs([M(a.slice(Math.floor(
a.length/2)).map(c=>c.capture_rate))])}:{}}}function Ru(r){let e=r.finished,t=Array.from({length:e*e},(o,a)=>r.cells.get(`${Math.floor(a/e)} ${a%e}`)),n=t[0].lengths.
length,s=(o,...a)=>cs(t.flatMap(o),e,e,...a);return{scores:{dtype:"<f4",shape:[e,e,n],data:Float32Array.from(t.flatMap(({capture_rates:o})=>o))},mean:s(({capture_rates:o})=>M(
o)),std:s(({capture_rates:o})=>Ou(o)),lengths:{dtype:"<i4",shape:[e,e,n],data:Int32Array.from(t.flatMap(({lengths:o})=>o))},collisions:s(({means:o})=>o.collisions,
2,3),faults:s(({means:o})=>o.faults,2,3),agent_steps:s(({means:o})=>o.agent_steps,2),pursuer_survivors:s(({means:o})=>o.survivors[0]),evader_survivors:s(({means:o})=>o.
survivors[1])}}function _u(r,{format:e,version:t}){let n=r.finished-1,s={...r.settings,schedule:{...r.settings.schedule,generations:n}},o={format:e,matrixworld:t,
settings:s,drawn_by:"page"},a=Cu(r),{matches:i,steps:l,agent_steps:c}=r.counters.evader[n],u={training_matches:i,training_steps:l,training_agent_steps:c},h={stages:a.
length-1,...u,disengagement:[],evaluation_matches:r.finished**2*r.settings.evaluation_episodes};return{"config.json":wi(o),...Object.fromEntries(a.map((m,p)=>[`\
stage-${String(p).padStart(4,"0")}.npz`,_t(ku(r,p,m))])),"payoff.npz":_t(Ru(r)),"summary.json":wi(h)}}function xi(r,e){let t=r.flatMap(({name:n,race:s})=>Object.
entries(_u(s,e)).map(([o,a])=>[r.length>1?`${n}/${o}`:o,a]));return nr(Object.fromEntries(t))}var us=r=>r.finished>1&&r.cells.size>=r.finished**2&&T.every(e=>r.
archive[e].length);var[$u,Pu]=[12,150],Si=256,lt=5,Nu=4096;function Mi(r){let{width:e,height:t}=r[0],{table:n,place:s}=Lu(r),o=[...Ai("GIF89a"),...Wt(e),...Wt(t),247,0,0,...n];return o.
push(33,255,11,...Ai("NETSCAPE2.0"),3,1,0,0,0),r.forEach((a,i)=>{o.push(33,249,4,0,...Wt(i===r.length-1?Pu:$u),0,0),o.push(44,0,0,0,0,...Wt(e),...Wt(t),0,8);let l=Iu(
Ti(a).map(c=>s[c]));for(let c=0;c<l.length;c+=255){let u=l.slice(c,c+255);o.push(u.length,...u)}o.push(0)}),Uint8Array.from([...o,59])}var Ai=r=>[...r].map(e=>e.
charCodeAt(0)),Wt=r=>[r&255,r>>8];function Ti({data:r}){let e=new Uint16Array(r.length/4),t=8-lt;for(let n=0;n<e.length;n++)e[n]=r[4*n]>>t<<2*lt|r[4*n+1]>>t<<lt|
r[4*n+2]>>t;return e}function Lu(r){let e=new Map;for(let i of r)for(let l of Ti(i))e.set(l,(e.get(l)??0)+1);let t=[...e].sort(([,i],[,l])=>l-i).slice(0,Si).map(
([i])=>i),n=i=>[i>>2*lt,i>>lt&31,i&31],s=(i,l)=>n(i).reduce((c,u,h)=>c+(u-n(l)[h])**2,0),o=new Uint8Array(2**(3*lt));for(let i of e.keys()){let l=t.indexOf(i);o[i]=
l>=0?l:t.reduce((c,u,h)=>s(i,u)<s(i,t[c])?h:c,0)}let a=t.flatMap(i=>n(i).map(l=>Math.round(l*255/31)));return{table:[...a,...Array(3*Si-a.length).fill(0)],place:o}}
function Iu(r){let[e,t]=[256,257],n=[],s=new Map,[o,a,i,l]=[t+1,9,0,0],c=h=>{for(i|=h<<l,l+=a;l>=8;l-=8)n.push(i&255),i>>>=8};c(e);let u=r[0];for(let h of r.subarray(
1)){let m=s.get(u*256+h);if(m!==void 0){u=m;continue}c(u),o===Nu?(c(e),[s,o,a]=[new Map,t+1,9]):(s.set(u*256+h,o),o===2**a&&(a+=1),o+=1),u=h}return c(u),c(t),l&&
n.push(i&255),n}var Fu={...Ar,numbers:!1},Du={side:260,gap:12,head:30},Uu={width:1200,height:800,side:520,gap:48},Wu=60;function hs(r,e){let t=Object.assign(document.createElement(
"canvas"),{width:r,height:e});return[t,t.getContext("2d",{willReadFrequently:!0})]}function Ei({recording:r},e,t){let[n,s]=hs(t,t),o=Tr(r.rows,r.cols,!1,t,t,1);
return Mr({ctx:s,grid:o,colors:rt(document.querySelector("canvas.board"))},r,Math.min(e,r.moments.length-1),Fu,1),n}function Oi(r,e){let t=getComputedStyle(document.
body);r.fillStyle=t.backgroundColor,r.fillRect(0,0,r.canvas.width,r.canvas.height),r.fillStyle=t.color,r.font=`${e} ${t.fontFamily}`}function Ci(r){let{side:e,gap:t,
head:n}=Du,s=Math.min(Wu,Math.max(...r.map(({recording:i})=>i.moments.length-1))),[o,a]=hs(r.length*e+(r.length+1)*t,n+e+t);return Mi(Array.from({length:s+1},(i,l)=>(Oi(
a,"600 15px"),r.forEach((c,u)=>{let h=t+u*(e+t);a.fillText(c.title,h,21,e),a.drawImage(Ei(c,l,e),h,n)}),a.getImageData(0,0,o.width,o.height))))}function ki(r,e){
let{width:t,height:n,side:s,gap:o}=Uu,[a,i]=hs(t,n);return Oi(i,"600 30px"),r.forEach((l,c)=>{let u=o+c*(s+o+16);i.fillText(l.title,u,60,s),i.drawImage(Ei(l,1/0,
s),u,80)}),e.forEach((l,c)=>{i.font=i.font.replace(/^\S+ \S+/,c<e.length-2?"500 27px":"400 19px"),i.fillText(l,o,650+37*c,t-2*o)}),new Promise(l=>a.toBlob(c=>l(
c)))}var Be="matrixworld-evolve",ds=()=>JSON.parse(ms()?.getItem(Be)??"[]");function ms(){try{return sessionStorage}catch{return null}}var Ri=ds,Qr=({address:r})=>r.
split(/&?race=/)[0];function _i(r,e){let t=ms(),n=JSON.stringify(e,(a,i)=>i instanceof Float32Array?{floats:Array.from(i)}:i instanceof Map?{entries:[...i]}:i),
s=ds().filter(a=>Qr(a)!==Qr(r));for(let{address:a}of ds().filter(i=>Qr(i)===Qr(r)))t?.removeItem(`${Be} ${a}`);let o=[...s,r];for(let a=0;t&&a<=8;a++){for(let i of o.
splice(0,Math.max(0,o.length-8)))t.removeItem(`${Be} ${i.address}`);try{t.setItem(`${Be} ${r.address}`,n),t.setItem(Be,JSON.stringify(o));return}catch(i){if(!(i instanceof
DOMException)||o.length<2)return;t.removeItem(`${Be} ${o[0].address}`),o=o.slice(1)}}}function $i(r){let e=ms()?.getItem(`${Be} ${r}`);return e?JSON.parse(e,(t,n)=>Array.
isArray(n?.floats)?Float32Array.from(n.floats):Array.isArray(n?.entries)?new Map(n.entries):n):null}var Bt=8e3;function Li(r){let e=2166136261;for(let t of me("script-engine")+JSON.stringify(r))e=Math.imul(e^t.charCodeAt(0),16777619);return(e>>>0).toString(36)}
var $e={changes:"~~",parts:"~",value:":",races:"_"},Ii="end",ps=({choice:r,changes:e})=>e.reduce((t,{change:n})=>({...t,...n}),r);function jt(r,{choice:e,changes:t,
watched:n},s){let o=l=>l.map(c=>c===1/0?Ii:c).join($e.races),a=t.map(({change:l,at:c})=>[o(c),...Object.entries(Mo(l)).map(u=>u.join($e.value))].join($e.parts)).
join($e.changes),i={...Ao(r,e),...n.length?{race:Li(r),to:o(n),...a?{then:a}:{}}:{},...s?{play:[s.seed,s.episode,s.seat,s.score,s.rate].join("."),pursuer:Pi(s.pursuer),
evader:Pi(s.evader)}:{}};return Object.entries(i).map(([l,c])=>`${l}=${c}`).join("&")}function Fi(r,e){let t=[...new URLSearchParams(e.length>2*Bt?"":e.replace(
/^#/,""))],{race:n="",to:s="",then:o="",play:a="",pursuer:i="",evader:l="",...c}=Object.fromEntries(t),u=[],h=Dn(r,c,w=>u.push(w)),m=w=>w.split($e.races).map(b=>b===
Ii?1/0:/^\d{1,6}$/.test(b)?Number(b):NaN),p=o.split($e.changes).filter(Boolean).reduce((w,b)=>{let[O="",...k]=b.split($e.parts),R=ps({choice:h,changes:w,watched:[]}),
E=Object.fromEntries(k.map(_=>_.split($e.value))),A=Dn(r,E,_=>u.push(_),R),D=Object.fromEntries(Object.entries(A).filter(([_])=>_ in E));return[...w,{change:D,at:m(
O)}]},[]),y=n||s?m(s):[],f=h.beside?2:1,g=[...p.map(({at:w})=>w),...y.length?[y]:[]].every(w=>w.length===f&&!w.some(Number.isNaN)),v=a?Bu(r,h,a,i,l):null;g||u.push(
`to=${s}`),a&&!v&&u.push(`play=${a}`);let x=e.length>2*Bt?"The link is too long, and shows nothing. ":u.length?`Something in the link is wrong, and left out: ${u.
slice(0,3).map(w=>w.slice(0,60)).join("; ")}. `:y.length&&n!==Li(r)?"The link is of another version of this page: the race may be another one. ":"";return{story:{
choice:h,changes:g?p:[],watched:g?y:[]},dare:v,problem:x}}function Bu(r,e,t,n,s){let[o,a]=[/^(\d{1,20})\.(\d{1,4})\.(\d{1,3})\.(\d{1,4})\.(\d{1,3})$/.exec(t),[Ni(
n),Ni(s)]];if(!o||!a[0]?.length||!a[1]?.length||Number(o[3])>=e.pursuers+e.evaders)return null;let i=pr(r,e);if(T.some((m,p)=>a[p].length!==xe(it(i,r.masks,m))))
return null;let[l,c,u,h]=o.slice(2).map(Number);return{pursuer:a[0],evader:a[1],seed:String(BigInt.asUintN(64,BigInt(o[1]))),episode:l,seat:c,score:u,rate:h}}var Pi=r=>btoa(
String.fromCharCode(...new Uint8Array(r.slice().buffer))).replaceAll("+","-").replaceAll("/",".").replaceAll("=","");function Ni(r){if(!/^[\w.-]*$/.test(r))return null;
try{let e=Uint8Array.from(atob(r.replaceAll("-","+").replaceAll(".","/")),n=>n.charCodeAt(0)),t=e.length%4?null:new Float32Array(e.buffer);return t?.every(Number.
isFinite)?t:null}catch{return null}}var ju=250,ie=(r,e,t,n="")=>d("button",{type:"button",title:e||null,class:n||null,onclick:t},r),fs=class{#e;#r;lanes=[];#t=d("div",{class:"lanes"});#n=d("div",{
class:"of-race"});#a=ie("Evolve","",()=>this.#P(),"evolve");#s=d("progress",{max:1,value:0,"aria-label":"Progress of the race"});#u=d("p",{class:"small muted nu\
mbers",role:"status"});#m=ie("Draw walls","Drag over the board to draw walls, and over walls to remove them",()=>this.#I());#d=ie("Usual walls","Each match draw\
s its walls anew",()=>this.#R({walls:null}));#p=ie("Pause","",()=>this.#W());#f=ie("Again","Another race, with other luck",()=>this.#R({seed:this.#h.seed+1},!0));#o=ie(
`${Xe} more generations`,"",()=>this.#R({generations:this.#h.generations+Xe}));#l=Zt("Link to this race");#c=d("span",{class:"told small",role:"status"});#i=d("\
nav",{class:"shelf small","aria-label":"Races of this visit",hidden:!0});#y;#g;#w=[];#b;#v=[];#h;#x=0;#A=!1;#S="";constructor(e,t){[this.#e,this.#r]=[e,t];let{story:n,
dare:s,problem:o}=Fi(e,he()?location.hash:"");[this.#b,this.#v,this.#h]=[n.choice,n.changes.map(({change:a})=>a),ps(n)],this.#y=To(e,(a,i)=>this.#R(a,i)),this.#g=
new Lr(t,a=>he()?this.#L(a):null),this.#n.append(d("div",{class:"ending",role:"group","aria-label":"What to do now"},ie("Can you escape them?","Be an evader, ag\
ainst the best pursuers",()=>this.#N("evader"),"primary largest"),ie("Can you catch them?","Be a pursuer, against the best evaders",()=>this.#N("pursuer")),this.#o,
this.#f),d("div",{class:"doings",role:"group","aria-label":"What can be done"},this.#p,this.#m,this.#d,he()&&ie("Link","An address at which this race evolves ag\
ain, on any computer",()=>this.#j()),ie("GIF","Both boards as a film",()=>this.#G()),ie("Picture","Both boards and what came out",()=>{this.#H()}),ie("Save","An\
 archive that matrixworld judge, explore and replay read",()=>{this.#V()}),this.#l,this.#c)),document.getElementById("page").replaceWith(Vs("Evolve a chase","Tr\
iangles chase discs. Nobody has told either team how. Press Evolve, and both learn by trial and error, against each other."),d("main",{},d("div",{class:"start"},
this.#a,d("div",{class:"progress"},this.#s,this.#u)),this.#t,this.#i,this.#y.main,this.#y.more,d("div",{class:"card below"},Qt(),d("p",{class:"small muted"},"Th\
e page plays and learns with the engine of matrixworld, in this browser; nothing is sent."),d("p",{class:"small muted of-saving"},"A saved race is an archive: ",
d("code",{},"matrixworld judge"),", ",d("code",{},"explore")," and ",d("code",{},"replay")," read it. Python plays its matches again, and does not continue it."))),
d("footer",{class:"muted small"},`matrixworld ${e.version}`),this.#g.dialog),this.#C(),this.#c.textContent=o,this.#O(n,s)}#O(e,t){let n=e.watched.length?$i(jt(this.#e,
e)):null;if(n?.length===this.lanes.length){this.#S=jt(this.#e,e);for(let[c,u]of this.lanes.entries())u.restore(this.#T(c),n[c],e.watched[c],e.changes.map(({at:h})=>h[c]))}
let s=()=>{e.watched.length&&!n&&this.#k(e)};if(!t)return s();let o=this.#T(0),a={pursuer:this.lanes[0].run.playing("pursuer",t.pursuer),evader:this.lanes[0].run.
playing("evader",t.evader)},i=t.seat<o.world.n_pursuers?"pursuer":"evader",l=[{name:`the best ${i}s`,text:"",policy:()=>a[i]}];this.#g.play(i,{world:o.world,policies:a,
players:l,seed:o.seed,rate:t.rate,friend:t},t),this.#g.dialog.addEventListener("close",s,{once:!0})}#M(e=this.#h){return[e.schedule,...e.beside?[e.beside]:[]]}#T(e,t=this.#h){
return pr(this.#e,t,this.#M(t)[e])}#C(){for(let e of this.lanes.splice(0))e.close();for(let[e]of this.#M().entries()){let t=new Xr(this.#e,this.#r,"evolve",this.#T(
e));t.addEventListener("state",()=>this.#F()),this.lanes.push(t)}this.#w=this.lanes.map(e=>e.after.drawWalls(([t,n],s)=>this.#$(t,n,s))),this.#m.ariaPressed="fa\
lse",this.#t.dataset.count=String(this.lanes.length),this.#t.replaceChildren(...this.lanes.map(({element:e})=>e)),(this.lanes.length>1?this.#t:this.lanes[0].boards)[this.
lanes.length>1?"before":"after"](this.#n),this.#y.show(this.#h),this.#F()}#P(){let e=this.lanes.map(({state:t})=>t);e.includes("evolving")?this.lanes.forEach(t=>t.
stop()):e.includes("stopped")?this.lanes.forEach(t=>t.state==="stopped"&&t.go()):this.#_()}#_(){[this.#c.textContent,this.#S]=["",""];for(let[e,t]of this.lanes.
entries())t.start(this.#T(e))}#k({choice:e,changes:t,watched:n}){this.#A=!0;let s=e,o=t.map(({change:a})=>s={...s,...a});for(let[a,i]of this.lanes.entries()){let l=t.
map(({at:c},u)=>({at:c[a],settings:this.#T(a,o[u])}));i.start(this.#T(a,e),l,n[a])}}get#E(){let e=this.lanes.some(({state:t})=>t==="waiting");return{choice:this.#b,
changes:this.#v.map((t,n)=>({change:t,at:this.lanes.map(({changed:s,epochs:o})=>s[n]??o)})),watched:e?[]:this.lanes.map(({state:t,epochs:n})=>t==="evolving"?1/0:
n)}}#R=(e,t=!1)=>{let n=this.#M().length,s=this.lanes.every(({state:l})=>l==="waiting");this.#A&&!t&&(this.#v=this.#v.slice(0,Math.min(...this.lanes.map(({changed:l})=>l.
length))),this.#h=this.#v.reduce((l,c)=>({...l,...c}),this.#b)),this.#A=!1;let o={...this.#h,...e},a=o.generations>dr?`A race has at most ${dr} generations here\
.`:fr(o,this.#e.worlds[o.world]);if(this.#y.show(a?this.#h:o),this.#c.textContent=a,a)return;this.#h=o;let i=this.#E;if(t||s){if([this.#b,this.#v]=[{...o,generations:Xe},
[]],this.#h=this.#b,!s&&he()&&history.pushState(null,"","#"),this.#M().length!==n&&this.#C(),!s)return this.#_()}else this.#v.push(e);if(this.lanes.some(l=>l.kept))
this.#S="",this.#k({...i,changes:[...i.changes,{change:e,at:i.watched}],watched:this.lanes.map(()=>1/0)});else for(let[l,c]of this.lanes.entries())c.change(this.#T(
l))};#$(e,t,n){let{settings:{world:{rows:s,cols:o}},after:a}=this.lanes[0],i=Array.from({length:s*o},(m,p)=>p).filter(m=>a.recording.obstacles[m]),l={...this.#h,
walls:er(this.#h.walls??i,e*o+t,n)},c=fr(l,this.#e.worlds[l.world]);if(c)return c;let{walls:u}=this.#h=l,h=Uint8Array.from({length:s*o},(m,p)=>Number(u.includes(
p)));for(let m of this.lanes)m.after.showWalls(h);return clearTimeout(this.#x),this.#x=setTimeout(()=>this.#R({walls:u}),ju),""}#I(){let e=this.#m.ariaPressed!==
"true";this.#m.ariaPressed=String(e);for(let t of this.#w)t(e)}#N(e){let{run:t,champions:n,outcome:s}=this.lanes[0],o={pursuer:t.playing("pursuer",n.pursuer),evader:t.
playing("evader",n.evader)},a=Array.from({length:(t.best?.[e]??t.newest)+1},(i,l)=>({name:`generation ${l}`,text:"",policy:()=>t.policy(e,l)}));this.#g.play(e,{
world:t.world,policies:o,players:a,seed:this.#h.seed,rate:Math.round(100*(s?.rate??0)),friend:null},{seed:String(Pn(this.#r,t.world,e==="evader"?t.world.n_pursuers:
0)),episode:0})}#W(){let e=!this.lanes[0].chases.runs;for(let{chases:t}of this.lanes)t.runs=e;this.#F()}#F(){if(!this.lanes.length)return;let e=this.lanes.map(({
state:i})=>i),t=e.every(i=>i==="waiting")?"waiting":e.includes("evolving")?"evolving":e.includes("stopped")?"stopped":"ended";document.body.dataset.state=t,this.#a.
textContent={waiting:"Evolve",evolving:"Stop",stopped:"Go on",ended:""}[t],this.#a.hidden=t==="ended",this.#p.textContent=this.lanes[0].chases.runs?"Pause":"Pla\
y",this.#d.hidden=!this.#h.walls,this.#f.textContent=`Again, with seed ${this.#h.seed+1}`,this.#s.value=Math.min(...this.lanes.map(({done:i})=>i));let n=Math.max(
...this.lanes.map(i=>i.seconds)),{seed:s}=this.#h,o=this.lanes.map(i=>i.newestGeneration).join(" and ");this.#u.textContent={waiting:"",evolving:`Seed ${s}: gen\
eration ${o}`,stopped:`Seed ${s}: stopped at generation ${o}.`,ended:`Seed ${s}: ${o} generations in ${n.toFixed(1)} seconds.`}[t];let a=jt(this.#e,this.#E);this.#l.
hidden=this.#l.value!==this.#L(),he()&&a.length<=Bt&&location.hash.slice(1)!==a&&history.replaceState(null,"",`#${a}`),(t==="ended"||t==="stopped")&&(this.#A=!1),
t==="ended"&&this.lanes.every(({outcome:i})=>i)&&this.#B(a),this.#D()}async#B(e){if(this.#S===e||!he())return;this.#S=e;let t=`${this.#h.world}, seed ${this.#h.
seed}: ${z(this.lanes[0].outcome.rate)} are caught`,n=await Promise.all(this.lanes.map(s=>s.keep()));this.#S!==e||!n.every(us)||(_i({address:e,title:t},n),this.#D())}#D(){
let e=he()?Ri().filter(({address:n})=>n!==location.hash.slice(1)):[],t=e.map(({address:n})=>n).join(" ");this.#i.dataset.shown!==t&&(this.#i.dataset.shown=t,this.#i.
hidden=!e.length,this.#i.replaceChildren("Races before: ",...e.map(({address:n,title:s})=>d("a",{href:`#${n}`},s))))}#L(e){let t=jt(this.#e,this.#E,e);return t.
length>Bt?null:`${location.href.split("#")[0]}#${t}`}#j(){let e=this.#L();e?Xt(this.#l,e):this.#c.textContent="This race has too many changes for a link: save i\
t."}get#z(){let e=this.#L()??location.href;return location.protocol==="file:"?e.slice(e.split("#")[0].lastIndexOf("/")+1):e}get#U(){let{before:e,after:t}=this.lanes[0];
return[e,t].filter(({recording:n})=>n).map(n=>({title:n.title.split(":")[0],recording:n.recording}))}#G(){qe(`chase-seed-${this.#h.seed}.gif`,Ci(this.#U))}async#H(){
let{outcome:e,settings:t}=this.lanes[0],n=[...e?.sentence.split(new RegExp("(?<=\\.) "))??[`Generation ${this.lanes[0].newestGeneration}`],`${this.#h.world}, se\
ed ${t.seed}, ${t.schedule.generations} generations of pursuers and evaders that learn against each other`,this.#z];qe(`chase-seed-${this.#h.seed}.png`,await ki(
this.#U,n))}async#V(){let e=await Promise.all(this.lanes.map(async n=>({name:ir(n.settings),race:await n.saved()})));if(!e.every(({race:n})=>us(n))){this.#c.textContent=
"Wait for the next generation, and save then.";return}let t=`${e.map(n=>n.name).join("-and-")}-seed-${this.#h.seed}.zip`;qe(t,xi(e,this.#e)),this.#c.textContent=
`Saved as ${t}.`}};async function zu(){let r=new fs(So(),await Jt());document.addEventListener("keydown",({key:e,target:t,ctrlKey:n,metaKey:s,altKey:o})=>{t instanceof
HTMLInputElement||t instanceof HTMLSelectElement||document.querySelector("dialog[open]")||n||s||o||(e.toLowerCase()==="d"?pn():e.toLowerCase()==="a"&&r.lanes[0].
askNext())}),window.addEventListener("hashchange",()=>location.reload()),Object.assign(window,{matrixworldEvolve:r})}typeof document>"u"?ls(globalThis):zs(zu());})();
