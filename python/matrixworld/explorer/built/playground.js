/* built from web/ by "npm run build"; sources 935dfac1aaac763b3137186728bf53d2313bb373e9627ddd8f84a14c7c4e33be */
"use strict";(()=>{var gr={SIMULTANEOUS:0,SWARM_TURNS:1,AGENT_TURNS:2},rt={DISAPPEAR:0,REACH:1,BOUNCE:2},yr={OCCUPATION:0,SURROUND:1},vr={FAULT:0,INVOLVED:1};var ot=["obstacle","teammate","adversary"],yn=["vertex","edge","chain"],br=["turn","kind","form","first","second","row","col","at_fault","held","doomed"],vn=["p\
ursuer_{number}","evader_{number}"],wr={obstacle:"{first} ran into the obstacle or border at {cell}",vertex:"{first} and {second} both headed for {cell}",edge:"\
{first} and {second} meant to swap, {first} to {cell}",chain:"{first} headed for {cell}, where {second} had to stay"},st={"both held":"both bounce","both doomed":"\
both disappear",held:"{agent} bounces",doomed:"{agent} disappears",none:"nobody is stopped"},xr="{event}: {outcome}",bn={random:"any action, all equally likely",
still:"always stays",chaser:"moves to where the nearest adversary in view is nearest",fleer:"moves to where the nearest adversary in view is farthest","clumsy-c\
haser":"a chaser that takes any action in half of the steps",hunter:"a chaser of the nearest adversary in view to which no teammate in view is nearer",surrounder:"\
a chaser of the nearest free cell beside an adversary without a teammate","clumsy-fleer":"a fleer that takes any action in half of the steps",dodger:"moves to w\
here all adversaries in view together are farthest","team-surrounder":"shares the free cells beside adversaries with its teammates, and searches","careful-rando\
m":"as random, but takes only moves that right of way allows","careful-chaser":"as chaser, but takes only moves that right of way allows","careful-fleer":"as fl\
eer, but takes only moves that right of way allows","careful-clumsy-chaser":"as clumsy-chaser, but takes only moves that right of way allows","careful-hunter":"\
as hunter, but takes only moves that right of way allows","careful-surrounder":"as surrounder, but takes only moves that right of way allows","careful-clumsy-fl\
eer":"as clumsy-fleer, but takes only moves that right of way allows","careful-dodger":"as dodger, but takes only moves that right of way allows","careful-team-\
surrounder":"as team-surrounder, but takes only moves that right of way allows"},Sr={adversary:"distance to the nearest adversary (0 to 2, in half views)",pressure:"\
sum over adversaries of 1 / (1 + moves)^2 (0 or more)",unclaimed:"distance to the nearest adversary to which no teammate is nearer than the agent is now; withou\
t one, to the nearest adversary (0 to 2, in half views)",open_side:"distance to the nearest cell beside an adversary that holds no obstacle and no teammate (0 t\
o 2, in half views)",teammate:"distance to the nearest teammate (0 to 2, in half views)",exits:"share of the cells around that are no obstacle (0 to 1)",room:"d\
istance to the nearest obstacle to the north, east, south or west (0 to 1, in half views)",must_yield:"1 if right of way forbids the move (0 to 1)",ahead:"1 if \
it is the direction that the agent draws for each 12 steps (0 to 1)",search:"1 if it leads on along the way on which an agent of team-surrounder searches the gr\
id (0 to 1)",escapes:"share of the cells that an evader may be on after its next move which hold no obstacle and which no pursuer in view reaches in one move: o\
f the nearest adversary, or an evader's own (0 to 1)",opposite:"(1 - cosine) / 2 of the angle at the nearest adversary between the agent and the teammate neares\
t to it; for an evader, of the angle at itself between its two nearest adversaries (0 to 1)",parity:"1 if the distance to the nearest adversary is odd (0 to 1)"},
Ar={free:".GS",blocked:"#@OTW"};var $e=1+br.length;function at(e,t){return e.replace(/\{(\w+)\}/g,(n,r)=>String(t[r]))}function Q(e,t){return e<t?at(vn[0],{number:e}):at(vn[1],{number:e-t})}function va(e,t){
let[n,r,o,s,a,i,l,...c]=Array.from(e),u=a<0?[s]:[s,a],[d,p,h]=c.map(v=>u.filter((w,b)=>v>>b&1)),g=u.map(v=>Q(v,t)),f=at(wr[a<0?"obstacle":yn[o]],{first:g[0],second:g[g.
length-1],cell:`(${i}, ${l})`}),y=at(xr,{event:f,outcome:ba(u.length,p,h,t)});return{kind:ot[r],form:yn[o],agents:u,cell:[i,l],at_fault:d,held:p,doomed:h,turn:n,
text:y}}function ba(e,t,n,r){if(e===2&&t.length===2)return st["both held"];if(e===2&&n.length===2)return st["both doomed"];let o=s=>a=>at(st[s],{agent:Q(a,r)});
return[...t.map(o("held")),...n.map(o("doomed"))].join(", ")||st.none}function _t(e,t){let n=[];for(let r=0;r<e.length;r+=$e)n.push(va(e.subarray(r+1,r+$e),t));
return n}var K=class extends Error{name="EngineError"};function N(e,t,n){let r=typeof n=="string"?`'${n}'`:typeof n=="object"?JSON.stringify(n):String(n);return new K(`${e}\
: expected ${t}, got ${r}`)}var Ue=class{bytes;constructor(t){this.bytes=t}},Mr=0,xn=[Uint8Array,Uint8Array,Int32Array,BigInt64Array,BigUint64Array,Float32Array,Float64Array],Tr=4,Cr=4,wa=new TextEncoder,
xa=new TextDecoder;function Sa(e){for(let t=xn.length-1;t>Mr;--t)if(e instanceof xn[t])return t;throw new TypeError("array: expected a typed array of the engine\
's numbers, got another")}function wn(e){return new Uint8Array(e.buffer,e.byteOffset,e.byteLength)}function Aa(e){return wa.encode(`${e}\0`)}var Sn=class{engine;addresses=[];constructor(t){
this.engine=t}copy(t){let n=this.engine._malloc(Math.max(t.length,1));if(n===0)throw new K("memory: expected room for the arguments, got none");return this.addresses.
push(n),this.engine.HEAPU8.set(t,n),n}text(t){return this.copy(Aa(t))}arrays(t){let n=Object.entries(t),r=n.flatMap(([s,a])=>{let i=a instanceof Ue,l=i?a.bytes:
a;return[this.text(s),i?Mr:Sa(l),l.length,this.copy(wn(l))]}),o=this.copy(wn(Int32Array.from(r)));return this.copy(wn(Int32Array.of(n.length,o)))}free(){for(let t of this.
addresses)this.engine._free(t)}};function Er(e,t){let n=e.HEAPU8;return xa.decode(n.subarray(t,n.indexOf(0,t)))}function De(e){let t=new Int32Array(e.HEAPU8.buffer),
n=e._last_outputs()/Tr,r=t[n+1]/Tr,o={};for(let s=r;s<r+t[n]*Cr;s+=Cr){let a=xn[t[s+1]],i=t[s+2]*a.BYTES_PER_ELEMENT,l=t[s+3];o[Er(e,t[s])]=new a(e.HEAPU8.slice(
l,l+i).buffer)}return o}function ye(e,t){let n=new Sn(e);try{let r=t(n);if(r===0)throw new K(Er(e,e._last_error()));return r}finally{n.free()}}var Ta=2**31-1,kr=["none","gru"],Ca=2n**64n-1n,Ma=34028234663852886e22;function ee(e,t){if(typeof t!="number"||!Number.isInteger(t)||Math.abs(t)>Ta)throw N(e,"a\
n integer",t);return Int32Array.of(t)}function Pt(e,t){if(typeof t!="boolean")throw N(e,"true or false",t);return new Ue(Uint8Array.of(Number(t)))}function Ce(e,t,n){
let r=typeof t=="string"&&Object.hasOwn(n,t)?n[t]:void 0;if(r===void 0)throw N(e,`one of ${Object.keys(n).join(", ")}`,t);return Int32Array.of(r)}function An(e,t){
if(typeof t!="number"||!(Math.abs(t)<=Ma))throw N(e,"a finite number",t);return t}function it(e,t){let r=typeof t=="bigint"||typeof t=="number"&&Number.isSafeInteger(
t)?BigInt(t):-1n;if(r<0n||r>Ca)throw N(e,"an integer from 0 to 2^64 - 1",t);return BigUint64Array.of(r)}function Ea(e){return{"rules.interaction":Ce("interactio\
n",e.interaction,gr),"rules.obstacle":Ce("obstacle",e.obstacle,rt),"rules.teammate":Ce("teammate",e.teammate,rt),"rules.evader":Ce("evader",e.evader,rt),"rules.\
pursuer":Ce("pursuer",e.pursuer,rt),"rules.capture":Ce("capture",e.capture,yr),"rules.captured_disappear":Pt("captured_disappear",e.captured_disappear)}}function Or(e,t){
let n=typeof t=="number"?[t,t,t]:t;if(!Array.isArray(n)||n.length!==3)throw N(e,"1 or 3 numbers",t);return Float32Array.from(n,r=>An(e,r))}function ka(e){let t=(n,r)=>Float32Array.
of(An(n,e[n]),An(r,e[r]));return{"rewards.capture":t("pursuer_capture","evader_capture"),"rewards.neighbor":t("pursuer_neighbor","evader_neighbor"),"rewards.ste\
p":t("pursuer_step","evader_step"),"rewards.pursuer_collide":Or("pursuer_collide",e.pursuer_collide),"rewards.evader_collide":Or("evader_collide",e.evader_collide),
"rewards.blame":Ce("blame",e.blame,vr),"rewards.capture_repeats":Pt("capture_repeats",e.capture_repeats)}}function _r(e){if(e===void 0||typeof e=="number")return new Uint8Array(
0);if(e instanceof Uint8Array)return e;let{free:t,blocked:n}=Ar;for(let[r,o]of e.entries()){if(o.length!==e[0]?.length)throw N(`map, row ${r}`,`${e[0]?.length} \
cells as in row 0`,o.length);let s=[...o].find(a=>!t.includes(a)&&!n.includes(a));if(s)throw N(`map, row ${r}`,`'${t}' (free) or '${n}' (obstacle)`,s)}return Uint8Array.
from([...e.join("")],r=>Number(n.includes(r)))}function Pr(e,t){if(!Array.isArray(e))return;let n=[e.length,e[0]?.length??0];if(!(n[0]===t.rows&&n[1]===t.cols))
throw N("obstacle map",`shape (${t.rows}, ${t.cols}), the rows and cols`,n)}function We(e){Pr(e.obstacles,e);let t=typeof e.obstacles=="number"?e.obstacles:0;return{
...Ea(e.rules),...ka(e.rewards),rows:ee("rows",e.rows),cols:ee("cols",e.cols),n_pursuers:ee("n_pursuers",e.n_pursuers),n_evaders:ee("n_evaders",e.n_evaders),fov:ee(
"fov",e.fov),diagonal:Pt("diagonal",e.diagonal),max_steps:ee("max_steps",e.max_steps),density:Float64Array.of(t),map:_r(e.obstacles)}}function Rr(e,t){return Int32Array.
from((t??[]).flat(),n=>ee(e,n)[0])}function Lr(e,t){return Pr(e.obstacles,t),{seed:it("seed",e.seed??0n),episode:it("episode",e.episode??0),pursuers:Rr("pursuer\
s",e.pursuers),evaders:Rr("evaders",e.evaders),map:_r(e.obstacles)}}function Lt(e){return{actions:Int32Array.from(e,t=>ee("actions",t)[0])}}var Nr=Object.keys(Sr);
function Tn(e){let t=Nr.indexOf(e);if(t<0)throw N("inputs",`names of ${Nr.join(", ")}`,e);return t}function Me(e){if(typeof e=="string"){if(!Object.hasOwn(bn,e))
throw N("policy",`one of ${Object.keys(bn).join(", ")}`,e);return{script:new TextEncoder().encode(e)}}if(e.kind!=="cells")return{inputs:Int32Array.from(e.inputs,
t=>Tn(t)),hidden:Int32Array.from(e.kind==="rating"?e.hidden:[],t=>ee("hidden",t)[0]),length:ee("length",e.kind==="program"?e.length:0),mask:new TextEncoder().encode(
e.mask),genome:e.genome};if(e.activation!=="relu"&&e.activation!=="tanh")throw N("activation","'relu' or 'tanh'",e.activation);if(!kr.includes(e.memory))throw N(
"memory",`one of ${kr.join(", ")}`,e.memory);return{hidden:Int32Array.from(e.hidden,t=>ee("hidden",t)[0]),activation:new TextEncoder().encode(e.activation),sampled:Pt(
"sampled",e.sampled),memory:new TextEncoder().encode(e.memory),genome:e.genome}}var Oa=["first_turn","terminated","truncated"];function Ir(e){let t={...e};for(let n of Oa)
t[n]=new Ue(e[n]);return t}var $r="statistics.",It=class{config;seed;episode;n_agents;statistics;first_conflict;constructor(t,n,r,o){this.config=t,this.seed=n,this.episode=r,this.n_agents=
t.n_pursuers+t.n_evaders,this.statistics=Na(Ur(o)),Object.assign(this,o),this.first_conflict=Ra(this.conflict_table,this.length)}get length(){return this.actions.
length/this.n_agents}conflicts(t){this.check(t);let n=this.first_conflict[t],r=this.first_conflict[t+1],o=this.conflict_table.subarray(n*$e,r*$e);return _t(o,this.
config.n_pursuers)}seek(t,n,r){this.check(n),(!(t.seed===this.seed&&t.episode===BigInt(this.episode))||t.turn!==0||t.steps>n)&&t.reset({seed:this.seed,episode:this.
episode});for(let s=t.steps;s<n;++s){let a=this.actions.subarray(s*this.n_agents,(s+1)*this.n_agents);r?t.replay(a,{pursuer:r.pursuers,evader:r.evaders}):t.step(
a)}}check(t){if(!(Number.isInteger(t)&&t>=0&&t<=this.length))throw N("step",`0 to ${this.length}`,t)}};function Ra(e,t){let n=new Int32Array(t+2);for(let r=0;r<
e.length;r+=$e)++n[e[r]+1];for(let r=1;r<n.length;++r)n[r]+=n[r-1];return n}function Na(e){let t=["capture_rate","ever_capture_rate","captured_fraction","length"];
return Object.fromEntries(Object.entries(e).map(([n,r])=>[n,t.includes(n)?Number(r[0]):r]))}var Ur=e=>Object.fromEntries(Object.entries(e).flatMap(([t,n])=>t.startsWith(
$r)?[[t.slice($r.length),n]]:[]));function Dr(e,t,n,r){let o=[We(n.config),Me(n.pursuers),Me(n.evaders),r];return ye(e,s=>{let[a,i,l,c]=o.map(u=>s.arrays(u));return e[t](
a,i,l,c)}),De(e)}function Wr(e,t,n,r){let o={seed:it("seed",n),episode:it("episode",r)};return new It(t.config,n,r,Dr(e,"_play_match",t,o))}function zr(e,t,n,r){
if(!Number.isInteger(r)||r<1)throw N("n_episodes","at least 1",r);let o=Dr(e,"_play_rollout",t,{...n,n_episodes:Int32Array.of(r)});return Ur(o)}var _a=7e6,Pa=new FinalizationRegistry(([e,t])=>e._states_free(t));function La({rules:e,rows:t,cols:n,obstacles:r,diagonal:o,n_pursuers:s,n_evaders:a}){let i=typeof r==
"number"||e.obstacle==="REACH"?0:r.join("").split("#").length-1,l=t*n-i,c=[e.obstacle,e.teammate,e.pursuer].includes("DISAPPEAR"),u=e.capture==="SURROUND"||e.evader===
"REACH",d=e.interaction==="AGENT_TURNS",p=(f,y)=>Array.from({length:y},(v,w)=>d?f:(f+w)/(w+1)).reduce((v,w)=>v*w,1),h=p(l+Number(c),s)*p(l*(1+Number(u))+2,a);return{
SIMULTANEOUS:[s+a],SWARM_TURNS:[s,a],AGENT_TURNS:Array(s+a).fill(1)}[e.interaction].reduce((f,y)=>f+h*(o?9:5)**y,0)}function ze(e){return typeof e.obstacles=="n\
umber"&&e.obstacles>0?"obstacles are drawn anew in each episode":La(e)>_a?"the world is too large to be solved on the page":""}var Cn=class{value;teams;matrix;n_actions;constructor(t,n){
let{matrix:r,rows:o,cols:s,value:a,agents:i}=n,[l,c]=t.actors,u=Array.from(i).filter(p=>l<=p&&p<c),d=p=>p<t.config.n_pursuers;this.value=a[0],this.matrix=r,this.
n_actions=t.n_actions,this.teams=[{agents:u.filter(d),play:o},{agents:u.filter(p=>!d(p)),play:s}]}marginal(t){let n=this.teams.find(({agents:s})=>s.includes(t));
if(!n)return null;let r=this.n_actions**(n.agents.length-1-n.agents.indexOf(t)),o=Array(this.n_actions).fill(0);return n.play.forEach((s,a)=>o[Math.floor(a/r)%this.
n_actions]+=s),o}lost(t){let[n,r]=this.teams.map(({agents:l})=>l.reduce((c,u)=>c*this.n_actions+t[u],0)),[o,s]=this.teams.map(({play:l})=>l),a=s.reduce((l,c,u)=>l+
c*this.matrix[n*s.length+u],0),i=o.reduce((l,c,u)=>l+c*this.matrix[u*s.length+r],0);return[Math.max(0,this.value-a),Math.max(0,i-this.value)]}},Mn=60,lt=class{config;payoff;engine;states;n_turns;values;constructor(t,n,r){
this.engine=t,this.config=n,this.payoff=r,this.states=ye(t,i=>t._states_new(i.arrays(We(n)))),Pa.register(this,[t,this.states]);let o={SIMULTANEOUS:1,SWARM_TURNS:2,
AGENT_TURNS:n.n_pursuers+n.n_evaders};this.n_turns=o[n.rules.interaction];let{payoffs:s}=this.call(()=>t._states_payoffs(this.states)),a=s;this.values=[[r==="ca\
pture-rate"?a:a.fill(0)]]}goBack(){let t=this.values.at(-1)[0],n=[];for(let o=this.n_turns-1;o>=0;o--){let s=n[o+1]??t;n[o]=this.backup(o,{next:s})}this.payoff===
"capture-time"&&(n[0]=n[0].map((o,s)=>s===this.config.n_evaders?0:o-1)),this.values.push(n);let r=this.payoff==="capture-rate"?this.config.max_steps:Math.min(this.
config.max_steps,Mn);return this.values.length<=r&&n[0].some((o,s)=>o!==t[s])}backup(t,n){return this.call(r=>this.engine._states_backup(this.states,t,r.arrays(
n))).values}game(t){let n=this.config.max_steps-t.steps,{turn:r}=t,o=r+1===this.n_turns,s=n>0?this.values[Math.min(n-Number(o),this.values.length-1)]?.[o?0:r+1]:
void 0;if(!s)return null;let a=this.call(i=>this.engine._states_game(this.states,t.address,i.arrays({next:s})));return a.agents.length?new Cn(t,a):null}call(t){
return ye(this.engine,t),De(this.engine)}};var Br=new FinalizationRegistry(([e,t])=>e._world_free(t)),ct=class{config;n_agents;n_actions;engine;at;freed=!1;constructor(t,n){this.engine=t,this.config=n,this.
n_agents=n.n_pursuers+n.n_evaders,this.n_actions=n.diagonal?9:5,this.at=ye(t,r=>t._world_new(r.arrays(We(n)))),Br.register(this,[t,this.at],this)}free(){this.freed||
(this.freed=!0,Br.unregister(this),this.engine._world_free(this.at))}get address(){if(this.freed)throw N("world","one that is in use","one that was freed");return this.
at}reset(t={}){let n=Lr(t,this.config);this.call(r=>this.engine._world_reset(this.address,r.arrays(n)))}step(t){let n=Lt(t);this.call(r=>this.engine._world_step(
this.address,r.arrays(n)))}playTurn(t){let n=Lt(t);this.call(r=>this.engine._world_play_turn(this.address,r.arrays(n)))}decide(t,n,r){let{n_pursuers:o}=this.config,
s={pursuer:[0,o],evader:[o,this.n_agents]},[a,i]=typeof n=="string"?s[n]:n;if(r.length!==this.n_agents)throw N("actions",String(this.n_agents),r.length);let l=[
Me(t),Lt(r)],{actions:c}=this.call(u=>this.engine._world_decide(this.address,u.arrays(l[0]),a,i,u.arrays(l[1])));return Uint8Array.from(c)}replay(t,n){let r=s=>typeof s!=
"string"&&s.kind==="cells"&&s.memory!=="none";if(!r(n.pursuer)&&!r(n.evader))return this.step(t);let{n_pursuers:o}=this.config;for(let s=this.n_turns;s>0;--s){let[
a,i]=this.actors;a<o&&this.decide(n.pursuer,[a,Math.min(i,o)],t),i>o&&this.decide(n.evader,[Math.max(a,o),i],t),this.playTurn(t)}}get n_turns(){return this.turnNumbers()[1]}get turn(){
return this.turnNumbers()[0]}get actors(){let[,,t,n]=this.turnNumbers();return[t,n]}turnNumbers(){return this.call(()=>this.engine._world_turn(this.address)).turn}get steps(){
return this.read("steps")[0]}get seed(){return this.read("seed")[0]}get episode(){return this.read("episode")[0]}get over(){return this.read("terminated")[0]===
1||this.read("truncated")[0]===1}read(t){return this.call(n=>this.engine._world_read(this.address,n.text(t)))[t]}view(t){let n=3*this.config.fov**2;return this.
read("views").slice(t*n,(t+1)*n)}map(){return this.read("state").slice(2*this.config.rows*this.config.cols)}conflicts(){return _t(this.conflictTable(),this.config.
n_pursuers)}conflictTable(){return this.call(()=>this.engine._world_conflicts(this.address)).conflict_table}answer(t,n){let r=Me(t),{logits:o,memory:s}=this.call(
l=>this.engine._world_logits(this.address,l.arrays(r),n)),a=o,i=this.decide(t,[n,n+1],new Uint8Array(this.n_agents))[n];return{logits:a,probabilities:Ia(a),action:i,
memory:s}}rate(t,n){let r=Me(t),{ratings:o,refused:s}=this.call(c=>this.engine._world_rate(this.address,c.arrays(r),n)),a=this.read("inputs"),i=a.length/this.n_agents/
this.n_actions,l=c=>Float32Array.from({length:this.n_actions},(u,d)=>a[(n*this.n_actions+d)*i+c]);return{inputs:t.inputs.map(c=>l(Tn(c))),ratings:o,refused:s}}snapshot(){
return this.call(()=>this.engine._world_snapshot(this.address))}restore(t){let n=Ir(t);this.call(r=>this.engine._world_restore(this.address,r.arrays(n)))}call(t){
return ye(this.engine,t),De(this.engine)}};function Ia(e){let t=Math.max(...e),n=Array.from(e,o=>Math.exp(o-t)),r=n.reduce((o,s)=>o+s,0);return Float32Array.from(
n,o=>o/r)}var En=class{compiled;constructor(t){this.compiled=t}world(t){return new ct(this.compiled,t)}solution(t,n="capture-rate"){return new lt(this.compiled,t,n)}match(t,n,r,o,s=0){
return Wr(this.compiled,{config:t,pursuers:n,evaders:r},o,s)}rollouts(t,n,r,o,s){return zr(this.compiled,{config:t,pursuers:n,evaders:r},o,s)}},Fr;function jr(e=globalThis.
matrixworldEngine){return Fr??=$a(e),Fr}async function $a(e){if(!e)throw new Error("matrixworldEngine: expected the script engine.js before this one, got none");
let t=Uint8Array.from(atob(e.binary),n=>n.charCodeAt(0));return new En(await e({wasmBinary:t}))}var Ua="http://www.w3.org/2000/svg";function m(e,t={},...n){return Gr(document.createElement(e),t,n)}function ve(e,t={},...n){return Gr(document.createElementNS(
Ua,e),t,n)}function Gr(e,t,n){for(let[o,s]of Object.entries(t))s==null||s===!1||(typeof s=="function"?e.addEventListener(o.slice(2),s):e.setAttribute(o,s===!0?"":
String(s)));let r=n.filter(o=>o!=null&&o!==!1);return e.append(...r.map(o=>typeof o=="number"?String(o):o)),e}function ut(e,t){let n=m("select",{onchange:()=>t(
n.value)},...e.map(([r,o])=>m("option",{value:r},o)));return n}async function Hr(e){try{await e}catch(t){let n=document.querySelector("#page, main")??document.body;
throw n.querySelector(".absent")?.remove(),n.prepend(m("p",{class:"card problem",role:"alert"},t instanceof WebAssembly.CompileError||/WebAssembly/.test(String(
t))?"This page plays by WebAssembly, which is forbidden where it lies ('wasm-unsafe-eval' is missing in the content policy): save the file, and open it from you\
r disk.":`The page could not start: ${String(t)}`)),t}finally{document.body.dataset.ready="true"}}var dt=()=>["file:","http:","https:"].includes(location.protocol);var Kr=()=>document.documentElement.dataset.theme==="dark";function mt(e){document.documentElement.dataset.theme=e?"dark":"light"}var kn=()=>mt(!Kr());if(typeof document<
"u"){let e=matchMedia("(prefers-color-scheme: dark)");e.addEventListener("change",()=>mt(e.matches)),mt(e.matches);let t=!1;addEventListener("beforeprint",()=>{
t=Kr(),mt(!1)}),addEventListener("afterprint",()=>mt(t))}function Vr(){return m("button",{type:"button",title:"Light or dark (D)","aria-label":"Light or dark",onclick:kn},
"◐")}var Yr=(e,t,...n)=>m("header",{class:"top"},m("div",{},m("h1",{},e),t?m("p",{class:"lead"},t):null),m("div",{class:"tools"},...n,Vr()));var j=["stay","north","east","south","west","northeast","southeast","southwest","northwest"];var be="champion",Ee=0,ke=64,Be=100,Fe=300,On=e=>({cell:e,gone:!1,captured:!1,everCaptured:!1}),te=e=>[...e.pursuers,...e.evaders],V=e=>e.pursuers.length+e.evaders.
length,Rn=(e,t)=>t<e.pursuers.length?"pursuers":"evaders",ne=(e,t)=>Q(t,e.pursuers.length),Nn=(e,t)=>Object.keys(e).every(n=>e[n]===t[n]);function je(e,t){return Object.
keys(t).find(n=>Nn(t[n],e))??null}function Da(e,t,n){let r=new Set(e);return Array.from({length:t},(o,s)=>Array.from({length:n},(a,i)=>r.has(s*n+i)?"#":".").join(
""))}function Wa(e,t,n){let r=e.filter(o=>o!==t);return n?[...r,t].sort((o,s)=>o-s):r}function Ge(e,t){let{rows:n,cols:r,fov:o,diagonal:s,rewards:a}=e;return{rules:t,
rows:n,cols:r,n_pursuers:e.pursuers.length,n_evaders:e.evaders.length,fov:o,diagonal:s,max_steps:e.maxSteps,obstacles:Da(e.walls,n,r),rewards:a}}var $t=(e,t,n)=>({
...e,next:e.next.map((r,o)=>o===t?n:r)}),Zr=e=>({...e,played:[...e.played,e.next],next:e.next.map(t=>typeof t=="number"?Ee:t)}),qr=e=>({...e,played:e.played.slice(
0,-1),next:e.played.at(-1)??e.next});function _n(e,t,n){let r=(o,s)=>o.map((a,i)=>i===s?{...a,cell:n}:a);return{...e,pursuers:r(e.pursuers,t),evaders:r(e.evaders,
t-e.pursuers.length)}}function Jr(e,t,n){let r=t==="pursuers"?e.pursuers.length:V(e);return{...e,[t]:[...e[t],On(n)],next:[...e.next.slice(0,r),Ee,...e.next.slice(
r)],ended:!1}}function Ut(e,t){let n=Rn(e,t),r=n==="pursuers"?t:t-e.pursuers.length;return{...e,[n]:e[n].filter((o,s)=>s!==r),next:e.next.filter((o,s)=>s!==t)}}
var Pn=(e,[t,n],r)=>({...e,walls:Wa(e.walls,t*e.cols+n,r)});function Xr(e,t,n){let r=([s,a])=>s<t&&a<n,o=te(e).map(({cell:s})=>r(s));return{...e,rows:t,cols:n,walls:e.
walls.map(s=>[Math.floor(s/e.cols),s%e.cols]).filter(r).map(([s,a])=>s*n+a),pursuers:e.pursuers.filter((s,a)=>o[a]),evaders:e.evaders.filter((s,a)=>o[e.pursuers.
length+a]),next:e.next.filter((s,a)=>o[a])}}function we(e,[t,n]){let r=te(e).findIndex(({cell:o,gone:s})=>!s&&o[0]===t&&o[1]===n);return r<0?null:r}var xe=(e,[t,
n])=>e.walls.includes(t*e.cols+n);function Qr(e){let t=Array.from({length:e.rows*e.cols},(o,s)=>[Math.floor(s/e.cols),s%e.cols]),n=([o,s])=>Math.abs(o-(e.rows-1)/
2)+Math.abs(s-(e.cols-1)/2),r=t.filter(o=>we(e,o)===null&&!xe(e,o));return r.length?r.reduce((o,s)=>n(s)<n(o)?s:o):null}var pt=class extends Error{},Oe="_",io="n",eo=2n**64n-1n,to=2e4,no=40,Re={fov:11,maxSteps:500,rewards:"paper"},Ln=["rules","others","rewards","size","diagonal",
"fov","limit","seed","ended","walls","pursuers","evaders","played","next"];function _(e,t,n){let r=n.length>no?`${n.slice(0,no)}…`:n;throw new pt(`${e}: expec\
ted ${t}, got "${r}"`)}function $n(e,t){let n=i=>i.map(l=>Ba(l,t)).join(""),r=i=>`${Math.floor(i/e.cols)}.${i%e.cols}`,o=za(e.rewards,t),s=[e.seed,e.episode,e.steps].
join("."),a={rules:oo(e.rules,t),others:e.others?oo(e.others,t):"",rewards:o===Re.rewards?"":o,size:`${e.rows}x${e.cols}`,diagonal:e.diagonal?"1":"",fov:e.fov===
Re.fov?"":String(e.fov),limit:e.maxSteps===Re.maxSteps?"":String(e.maxSteps),seed:s==="0.0.0"?"":s,ended:e.ended?"1":"",walls:e.walls.map(r).join(Oe),pursuers:e.
pursuers.map(ro).join(Oe),evaders:e.evaders.map(ro).join(Oe),played:e.played.map(n).join(Oe),next:e.next.every(i=>i===Ee)?"":n(e.next)};return Ln.filter(i=>a[i]).
map(i=>`${i}=${a[i]}`).join("&")}function ro({cell:e,gone:t,captured:n,everCaptured:r}){let o=n?"c":r?"e":"";return`${e[0]}.${e[1]}${o}${t?"x":""}`}function oo(e,t){
let n=t.fields.map(({name:r})=>String(e[r]).toLowerCase());return je(e,t.variants)??n.join(".")}function za(e,t){let n=JSON.stringify(e);return Object.keys(t.rewards).
find(o=>JSON.stringify(t.rewards[o])===n)??Object.values(e).map(o=>String(o)).join(Oe)}function Ba(e,t){if(typeof e=="number")return String(e);if(e===be)return io;
let n=t.scripts.findIndex(({name:r})=>r===e);return String.fromCharCode(97+n)}function ht(e,t){e.length>to&&_("link",`at most ${to} characters`,`${e.length} cha\
racters`);let n=Fa(e),r=(p,h="")=>n.get(p)??h,o=ao("rules",r("rules"),t),[s,a]=ja(r("size")),i=p=>In(r(p)).map(h=>Ga(p,h,s,a)),[l,c,u]=Ya(r("seed","0.0.0")),d={
rules:o,others:n.has("others")?ao("others",r("others"),t):null,rewards:Ka(r("rewards",Re.rewards),t),rows:s,cols:a,seed:l,episode:c,steps:u,diagonal:so("diagona\
l",r("diagonal","0")),fov:Dt("fov",r("fov",String(Re.fov)),1,255),maxSteps:Dt("limit",r("limit",String(Re.maxSteps)),1,2**31-1),ended:so("ended",r("ended","0")),
walls:Ha(r("walls"),s,a),pursuers:i("pursuers"),evaders:i("evaders"),played:[],next:[]};return Za(d),qa(d,In(r("played")),r("next"),t)}function Fa(e){let t=new Map;
for(let n of e.replace(/^#/,"").split("&").filter(Boolean)){let[r,o]=n.includes("=")?[n.slice(0,n.indexOf("=")),n.slice(n.indexOf("=")+1)]:[n,""];Ln.includes(r)||
_("link",`parts ${Ln.join(", ")}`,r),t.has(r)&&_(r,"it once","it twice"),t.set(r,o)}return t}var In=e=>e?e.split(Oe):[];function Dt(e,t,n,r){let o=/^\d{1,10}$/.
test(t)?Number(t):NaN;return o>=n&&o<=r||_(e,`a number from ${n} to ${r}`,t),o}function so(e,t){return t!=="0"&&t!=="1"&&_(e,"0 or 1",t),t==="1"}function ja(e){
let[t,n,...r]=e.split("x");return(t===void 0||n===void 0||r.length)&&_("size","rows and columns, such as 4x6",e),[Dt("size",t,1,ke),Dt("size",n,1,ke)]}function lo(e,t,n,r){
let o=/^(\d{1,4})\.(\d{1,4})$/.exec(t),s=[Number(o?.[1]),Number(o?.[2])];return(!o||s[0]>=n||s[1]>=r)&&_(e,`cells of a ${n} x ${r} grid, such as 0.2`,t),s}function Ga(e,t,n,r){
let o=/^(.*?)([ce]?)(x?)$/.exec(t),s=lo(e,o[1],n,r);return e==="pursuers"&&o[2]&&_(e,"no captured pursuer",t),{cell:s,gone:o[3]==="x",captured:o[2]==="c",everCaptured:o[2]!==
""}}function Ha(e,t,n){let r=In(e).map(o=>{let[s,a]=lo("walls",o,t,n);return s*n+a});return[...new Set(r)].sort((o,s)=>o-s)}function ao(e,t,n){let r=Object.hasOwn(
n.variants,t)?n.variants[t]:void 0;if(r)return r;let o=t.split("."),s=`${Object.keys(n.variants).join(", ")} or ${n.fields.length} values joined by "."`;o.length!==
n.fields.length&&_(e,s,t);let a=n.fields.map(({name:i,values:l},c)=>{let u=l.find(d=>d.name.toLowerCase()===o[c])?.name;return u===void 0&&_(`${e}, ${i}`,l.map(
d=>d.name.toLowerCase()).join(" or "),o[c]),[i,u==="true"?!0:u==="false"?!1:u]});return Object.fromEntries(a)}function Ka(e,t){if(Object.hasOwn(t.rewards,e))return t.
rewards[e];let n=Object.entries(t.rewards[Re.rewards]),r=e.split(Oe);return r.length!==n.length&&_("rewards",`${Object.keys(t.rewards).join(", ")} or ${n.length}\
 values`,e),Object.fromEntries(n.map(([o,s],a)=>[o,Va(o,r[a],s)]))}function Va(e,t,n){if(e==="blame"&&(t==="FAULT"||t==="INVOLVED"))return t;if(typeof n=="boole\
an"&&(t==="true"||t==="false"))return t==="true";let r=t.split(",").map(a=>/^-?[\d.]+(e[+-]?\d+)?$/i.test(a)?Number(a):NaN),o=e.endsWith("_collide")?[1,3]:[1];return(typeof n!=
"number"||!o.includes(r.length)||!r.every(a=>Math.abs(a)<34e37))&&_(`rewards, ${e}`,`a value like ${n}`,t),r.length===1?r[0]:r}function Ya(e){let t=/^(\d{1,20})\.(\d{1,20})\.(\d{1,9})$/.
exec(e);if(!t)return _("seed","seed.episode.steps, such as 0.0.0",e);let n=BigInt(t[1]),r=BigInt(t[2]);return(n>eo||r>eo)&&_("seed","numbers below 2^64",e),[n,r,
Number(t[3])]}function Za(e){for(let t of["pursuers","evaders"]){let n=e[t].length;(n<1||n>Be)&&_(t,`1 to ${Be} agents`,`${n}`)}e.fov%2===0&&_("fov","an odd num\
ber",String(e.fov)),e.steps>e.maxSteps&&_("seed",`at most ${e.maxSteps} steps`,String(e.steps))}function qa(e,t,n,r){let o=te(e).length;t.length>Fe&&_("played",
`at most ${Fe} steps`,`${t.length} steps`);let s=a=>i=>(i.length!==o&&_(a,`${o} characters, one for each agent`,i),[...i].map(l=>Ja(a,l,e.diagonal?9:5,r)));return{
...e,played:t.map(s("played")),next:n?s("next")(n):Array(o).fill(Ee)}}function Ja(e,t,n,r){let o=/^\d$/.test(t)?Number(t):NaN;if(o<n)return o;if(t===io&&r.champions)
return be;let s=r.scripts[t.charCodeAt(0)-97],a=String.fromCharCode(97+r.scripts.length-1);return s?.name??_(e,`actions 0 to ${n-1} or scripts a to ${a}`,t)}var ft=[.5,1,2,4,8,16,32,64],co=0,Wt=12,Xa=2,He=class extends EventTarget{#e;#n;#t;#r=0;#o=0;#s=!1;#i=null;#h=0;#c=[];#p=[];glide=.28;constructor(t,{speed:n=4,still:r=!1}={}){
super(),this.#e=t,this.#n=n,this.#t=r}get step(){return this.#r}get time(){return this.#t?this.#r:this.#o}get arrived(){return this.#o===this.#r}get playing(){return this.#s}get length(){
return this.#e}set length(t){this.#e=t,this.#r>t&&this.jump(t),this.#a("state")}get marks(){return this.#c}set marks(t){this.#c=t,this.#a("state")}get ticks(){return this.#p}set ticks(t){
this.#p=t,this.#a("state")}get pace(){return this.#n||Math.max(Xa,this.#e/Wt)}get speed(){return this.#n}set speed(t){this.#n=t,this.#a("state")}changeSpeed(t){
let n=ft.findIndex(r=>r>=this.pace);this.speed=ft[Math.min(ft.length-1,Math.max(0,n+t))]}play(){this.#s||!this.#e||(this.#r===this.#e&&this.jump(0),this.#s=!0,this.#a(
"state"),this.#u())}pause(){this.#s&&(this.#s=!1,this.#a("state"))}toggle(){this.#s?this.pause():this.play()}move(t){this.pause();let n=Math.min(this.#e,Math.max(
0,this.#r+t));Math.abs(n-this.#o)>1?this.jump(n):this.#d(n),this.#u()}jump(t){this.#o=Math.min(this.#e,Math.max(0,Math.round(t))),this.#d(this.#o),this.#a("fram\
e")}#d(t){t!==this.#r&&(this.#r=t,this.#a("step"),this.#t&&this.#a("frame"))}#u(){this.#i===null&&(this.#h=performance.now(),this.#i=requestAnimationFrame(()=>this.#f()))}#f(){
this.#i=null;let t=performance.now();this.#l(Math.min(.25,(t-this.#h)/1e3)),this.#h=t,(!this.#t||this.arrived)&&this.#a("frame"),(this.#s||this.#o!==this.#r)&&(this.#i=
requestAnimationFrame(()=>this.#f()))}#l(t){let n=t;for(;n>0;){if(this.#o===this.#r){if(!this.#s)return;if(this.#r===this.#e)return this.pause();this.#d(this.#r+
1)}let r=this.#s?this.pace:1/this.glide,o=this.#r-this.#o,s=Math.min(Math.abs(o),n*r);n-=s/r,this.#o=s===Math.abs(o)?this.#r:this.#o+Math.sign(o)*s}this.#s&&this.#o===
this.#e&&this.pause()}#a(t){this.dispatchEvent(new Event(t))}};function zt(e,t){if(t.ctrlKey||t.metaKey||t.altKey)return!1;let n=t.shiftKey?10:1,o={" ":()=>e.toggle(),
ArrowRight:()=>e.move(n),ArrowLeft:()=>e.move(-n),Home:()=>e.move(-e.length),End:()=>e.move(e.length),"+":()=>e.changeSpeed(1),"-":()=>e.changeSpeed(-1)}[t.key];
return o?.(),o!==void 0}var ue=[[0,0],[-1,0],[0,1],[1,0],[0,-1],[-1,1],[1,1],[1,-1],[-1,-1]];function gt(e,t,n){let r=t[0]-e[0],o=t[1]-e[1];return!n&&Math.abs(r)>Math.abs(o)?o=0:n||(r=
0),ue.findIndex(([s,a])=>s===Math.sign(r)&&a===Math.sign(o))}var Ne=(e,t)=>t<e.nPursuers,M=(e,t)=>[e.positions[2*t],e.positions[2*t+1]],de=({rows:e,cols:t},[n,r])=>n>=
0&&r>=0&&n<e&&r<t,Un=(e,t,n=3)=>e!==void 0&&[0,1,2].slice(0,n).some(r=>e[3*t+r]),Dn=(e,t)=>Un(e.fault,t),uo=(e,t)=>!Dn(e,t)&&Un(e.involved,t,2);function Bt(e,t,n){
let r=M(e,n),o=M(t,n),s=r[0]!==o[0]||r[1]!==o[1],a=t.involved===void 0||Un(t.involved,n);return!!(t.alive[n]&&t.actions?.[n]&&!s&&a)}function Ft(e,t,n){let[r,o]=M(
e,n),[s,a]=ue[t.actions?.[n]??0];return[r+s,o+a]}function jt(e,t,n){return Array.from({length:n.everCaptured.length},(o,s)=>s).filter(o=>n.everCaptured[o]&&!t.everCaptured[o]).
map(o=>e.nPursuers+o)}function Gt(e,t){return Array.from({length:t.alive.length},(r,o)=>o).filter(r=>e.alive[r]&&!t.alive[r])}var mo=[-.31,0,.31],po=[{size:1,at:[[0,0]]},{size:.62,at:[[-.2,.2],[.2,-.2]]},{size:.54,at:[[-.23,.22],[.23,.22],[0,-.22]]},{size:.54,at:[[-.23,.23],[.23,.23],[
-.23,-.23],[.23,-.23]]},{size:.36,at:mo.flatMap(e=>mo.map(t=>[t,e]))}],Qa=.3,ei=.35,ti=.55;function yt(e,t){let n=new Map;for(let r=0;r<t.alive.length;r++){if(!t.
alive[r])continue;let[o,s]=M(t,r),a=o*e.cols+s,i=n.get(a);i?i.push(r):n.set(a,[r])}return n}function ho(e,t){let n=Array.from(t.alive,(r,o)=>{let[s,a]=M(t,o);return{
x:a+.5,y:s+.5,size:1,alpha:0}});for(let r of yt(e,t).values()){let o=po[Math.min(r.length,po.length)-1];r.forEach((s,a)=>{let[i,l]=o.at[Math.min(a,o.at.length-1)],
c=n[s];c.x+=i,c.y+=l,c.size=o.size,c.alpha=1})}return n}var fo=e=>e*e*(3-2*e),Ke=(e,t,n)=>e+(t-e)*n,go=e=>Math.min(1,Math.max(0,e));function yo(e,t,n,r){let o={
SIMULTANEOUS:1,SWARM_TURNS:2,AGENT_TURNS:n}[e.interaction];if(o===1)return fo(r);let s=o===n?t:+!Ne(e,t),a=Math.max(1/o,ei);return fo(go((r-s/(o-1)*(1-a))/a))}function Ht(e,t){
let n=e.moments.length-1,r=Math.min(Math.floor(t),n),o=e.moments[r],s=ho(e,o);if(r===n||t===r)return s;let a=e.moments[r+1],i=ho(e,a);return s.map((l,c)=>{let u=yo(
e,c,s.length,t-r);return ni(o,a,c,l,i[c],u)})}function Wn(e,t,n){let r=e.moments.length-1,o=Math.min(Math.floor(n),r),s=e.moments[o],a=e.moments[Math.min(o+1,r)],
i=yo(e,t,s.alive.length,n-o),[l,c]=M(s,t),[u,d]=M(a,t);return[Ke(c,d,i)+.5,Ke(l,u,i)+.5]}function ni(e,t,n,r,o,s){let a=r.alpha>o.alpha,i={x:Ke(r.x,o.x,s),y:Ke(
r.y,o.y,s),size:a?r.size:Ke(r.size,o.size,s),alpha:a?go((1-s)/(1-ti)):Ke(r.alpha,o.alpha,s)};if(Bt(e,t,n)){let[l,c]=M(e,n),[u,d]=Ft(e,t,n),p=Qa*Math.sin(Math.PI*
s);i.x+=(d-c)*p,i.y+=(u-l)*p}return i}var vo=2*Math.PI;function me(e,t,n,r){e.beginPath(),e.arc(t,n,r/2,0,vo)}function Kt(e,t,n,r){let o=r/2,s=[[0,-.97],[.97,.83],[-.97,.83]].map(([a,i])=>[t+a*o,n+i*
o]);e.beginPath(),e.moveTo((s[2][0]+s[0][0])/2,(s[2][1]+s[0][1])/2),s.forEach(([a,i],l)=>{let[c,u]=s[(l+1)%3];e.arcTo(a,i,c,u,r*.09)}),e.closePath()}function Vt(e,t,n,r){
let o=r*.32;e.beginPath(),e.moveTo(t-o,n-o),e.lineTo(t+o,n+o),e.moveTo(t+o,n-o),e.lineTo(t-o,n+o)}function bo(e,t,n,r){e.beginPath();for(let o=0;o<16;o++){let s=r/
2*(o%2?.6:.95),a=vo*o/16;e.lineTo(t+s*Math.sin(a),n-s*Math.cos(a))}e.closePath()}function wo(e,t,n,r,o,s){let a=Math.atan2(o-n,r-t);e.beginPath(),e.moveTo(t,n),
e.lineTo(r,o);for(let i of[-1,1])e.moveTo(r,o),e.lineTo(r-s*Math.cos(a+i*.6),o-s*Math.sin(a+i*.6))}var xo=4,ri=1.6,oi=.95,si=5,ai=.16,ii=9,li=.09,ci=.2,So=.75,I=(e,t)=>e.left+t*e.cell,$=(e,t)=>e.top+t*e.cell;function Ve(e,t,n){return Ne(t,n)?e.colors.pursuer:
e.colors.evader}function Yt({ctx:e,colors:t},n,r,o,s,a,i=0){e.font=`700 ${Math.round(s)}px system-ui, sans-serif`,e.textAlign="center",e.textBaseline="middle",e.
strokeStyle=t.paper,e.lineWidth=i,i&&e.strokeText(n,r,o),e.fillStyle=a,e.fillText(n,r,o)}function Ao({ctx:e,grid:t,colors:n}){let{left:r,top:o,cell:s,rows:a,cols:i}=t,
l=i*s,c=a*s;if(e.fillStyle=n.paper,e.fillRect(r,o,l,c),s<si)return;e.fillStyle=n.line;let u=Math.max(1,Math.round(s/60));for(let d=1;d<i;d++)e.fillRect(r+d*s,o,
u,c);for(let d=1;d<a;d++)e.fillRect(r,o+d*s,l,u)}function To({ctx:e,grid:t,colors:n},r){let{left:o,top:s,cell:a,rows:i,cols:l}=t;e.fillStyle=n.obstacle;for(let c=0;c<
i*l;c++){if(!r.obstacles[c])continue;let u=Math.floor(c/l),d=c%l;e.fillRect(o+d*a,s+u*a,a,a)}Co({ctx:e,grid:t,colors:n})}function Co({ctx:e,grid:{left:t,top:n,cell:r,
rows:o,cols:s},colors:a}){let i=Math.min(5,Math.max(2,Math.round(r/18)));e.strokeStyle=a.frame,e.lineWidth=i,e.strokeRect(t-i/2,n-i/2,s*r+i,o*r+i)}function Mo({
ctx:e,grid:t,colors:n},r){let{left:o,top:s,cell:a,rows:i,cols:l}=t,c=a<24*r?5:1;e.font=`500 ${Math.round(Math.min(15*r,Math.max(9*r,a*.32)))}px system-ui, sans-\
serif`,e.fillStyle=n.muted,e.textBaseline="alphabetic",e.textAlign="center";let u=5*r+a/40;for(let d=0;d<l;d+=c)e.fillText(String(d),o+(d+.5)*a,s-u);e.textAlign=
"right",e.textBaseline="middle";for(let d=0;d<i;d+=c)e.fillText(String(d),o-u,s+(d+.5)*a)}function Eo({grid:e},t,n,r){let o=Math.floor(t.fov/2)+.5,s=Math.max(0,
n-o),a=Math.min(e.cols,n+o),i=Math.max(0,r-o),l=Math.min(e.rows,r+o);return[I(e,s),$(e,i),(a-s)*e.cell,(l-i)*e.cell]}function ko(e,t,n,r){let{ctx:o,grid:s,colors:a}=e;
o.save(),o.beginPath(),o.rect(0,0,o.canvas.width,o.canvas.height),o.rect(...Eo(e,t,n,r)),o.clip("evenodd"),o.clearRect(0,0,o.canvas.width,o.canvas.height),o.fillStyle=
a.line,o.fillRect(s.left,s.top,s.cols*s.cell,s.rows*s.cell),o.restore(),Co(e)}function Oo(e,{x:t,y:n,alpha:r},o){let{ctx:s,grid:a,colors:i}=e,l=Math.max(a.cell,
16*o)*1.06,c=I(a,t),u=$(a,n);s.globalAlpha=Math.max(r,.6),s.beginPath(),s.roundRect(c-l/2,u-l/2,l,l,l*.2),s.strokeStyle=i.focus,s.lineWidth=Math.max(2,2.5*o),s.
stroke();let d=Math.max(11*o,Math.min(18*o,a.cell*.5)),p=u-l/2<d*1.2,h=u+(p?1:-1)*(l/2+d*.7);s.lineJoin="round",Yt(e,"You",c,h,d,i.ink,d*.35),s.globalAlpha=1}function Ro(e,t,n,r,o){
let{ctx:s,grid:a}=e,i=Eo(e,t,r,o),l=Ve(e,t,n);s.globalAlpha=.11,s.fillStyle=l,s.fillRect(...i),s.globalAlpha=.8,s.strokeStyle=l,s.lineWidth=Math.max(1,a.cell/24),
s.strokeRect(...i),s.globalAlpha=1}function No(e,t,n,r,o){let{ctx:s,grid:a}=e,i=Math.min(Math.ceil(n),t.moments.length-1),l=t.moments[i];s.lineCap="round",s.lineWidth=
Math.min(ii,Math.max(1,a.cell*ai));for(let c=Math.max(1,Math.floor(n-r)+1);c<=i;c++){let u=t.moments[c-1],d=t.moments[c],p=Math.max(0,Math.min(1,(n-c)/r));s.globalAlpha=
So+(ci-So)*p;for(let h=0;h<d.alive.length;h++){let g=c===i&&n<i;if(!u.alive[h]||!(l.alive[h]||g))continue;let f=(Ne(t,h)?-1:1)*li,[y,v]=M(u,h),[w,b]=M(d,h);if(y===
w&&v===b)continue;let A=g?o[h].x:b+.5,C=g?o[h].y:w+.5;s.strokeStyle=Ve(e,t,h),s.beginPath(),s.moveTo(I(a,v+.5+f),$(a,y+.5+f)),s.lineTo(I(a,A+f),$(a,C+f)),s.stroke()}}
s.globalAlpha=1}function _o(e,t,n){let r=Math.min(Math.ceil(n),t.moments.length-1);for(let o=Math.max(1,r-xo+1);o<=r;o++){let s=t.moments[o-1],a=t.moments[o],i=o>
n?Math.max(0,1-2*(o-n)):1-(n-o)/xo,l=jt(t,s,a);for(let c of Gt(s,a))l.includes(c)||di(e,M(a,c),i);for(let c of l)ui(e,M(a,c),i)}e.ctx.globalAlpha=1}function ui({
ctx:e,grid:t,colors:n},[r,o],s){e.globalAlpha=s,bo(e,I(t,o+.5),$(t,r+.5),Math.max(8,t.cell*ri)),e.fillStyle=n.capture,e.fill(),e.strokeStyle=n.ink,e.lineWidth=Math.
max(1,t.cell/36),e.lineJoin="round",e.stroke()}function di({ctx:e,grid:t,colors:n},[r,o],s){e.globalAlpha=s,Vt(e,I(t,o+.5),$(t,r+.5),Math.max(7,t.cell*oi)),e.strokeStyle=
n.collision,e.lineWidth=Math.max(2,t.cell*.17),e.lineCap="round",e.stroke()}function Po({ctx:e,grid:t,colors:n},r,o){let s=Math.max(1,t.cell*.07);e.strokeStyle=
e.fillStyle=n.collision,e.lineWidth=Math.max(1,t.cell*.05),e.setLineDash([t.cell*.14,t.cell*.1]);for(let[a,i]of r){if(a<0||i<0||a>=t.rows||i>=t.cols)continue;let l=[
I(t,i)+s,$(t,a)+s,t.cell-2*s,t.cell-2*s];e.globalAlpha=.2*o,e.fillRect(...l),e.globalAlpha=o,e.strokeRect(...l)}e.setLineDash([]),e.globalAlpha=1}function Lo({ctx:e,
grid:t,colors:n},r,o,s,a){e.globalAlpha=a,me(e,I(t,r),$(t,o),Math.max(8,t.cell*s*1.02)),e.strokeStyle=n.collision,e.lineWidth=Math.max(1.5,t.cell*.085*Math.sqrt(
s)),e.stroke(),e.globalAlpha=1}var mi=.8,pi=.92,hi=15,fi=7,zn=9;function Io(e,t,n,r,o,s){r.forEach((a,i)=>{a.alpha>0&&gi(e,t,n,i,a,o,s)}),e.ctx.globalAlpha=1;for(let a of yt(t,n).values())a.length>
zn&&yi(e,r[a[zn-1]],a.length-zn+1)}function gi(e,t,n,r,o,s,a){let{ctx:i,grid:l,colors:c}=e,u=Ne(t,r),d=I(l,o.x),p=$(l,o.y),h=Math.max(4,l.cell*o.size*(u?pi:mi)),
g=Ve(e,t,r),f=!u&&!!n.captured[r-t.nPursuers];if(i.globalAlpha=o.alpha,(u?Kt:me)(i,d,p,h),h>fi*a&&(i.strokeStyle=c.paper,i.lineWidth=Math.max(2,h*.1),i.stroke()),
i.fillStyle=f?c.paper:g,i.fill(),f&&(me(i,d,p,h*.82),i.strokeStyle=g,i.lineWidth=h*.18,i.stroke()),!s||h<hi*a)return;let y=String(u?r:r-t.nPursuers),v=h*(u?.4:.5)*
(y.length>1?.8:1);Yt(e,y,d,p+h*(u?.17:.03),v,f?g:c.paper)}function yi(e,t,n){let{cell:r}=e.grid;Yt(e,`+${n}`,I(e.grid,t.x),$(e.grid,t.y),r*.3,e.colors.ink,r*.1)}var vi=.46,bi=.86,wi=.66,$o=.48,xi=.78,Si=.58;function Uo(e,t,n,r){let o=t.moments[n-1],s=t.moments[n];if(!o)return;let{ctx:a,grid:i,colors:l}=e;a.strokeStyle=l.
collision,a.lineWidth=Math.max(1.5,i.cell*.07),a.lineCap="butt",a.globalAlpha=r;for(let c=0;c<s.alive.length;c++)Bt(o,s,c)&&Ai(e,t,M(o,c),Ft(o,s,c));a.globalAlpha=
1}function Ai({ctx:e,grid:t},n,r,o){let s=o[1]-r[1],a=o[0]-r[0],i=d=>I(t,r[1]+.5+s*d),l=d=>$(t,r[0]+.5+a*d),c=de(n,o)?xi:Si;e.setLineDash([t.cell*.09,t.cell*.06]),
e.beginPath(),e.moveTo(i($o),l($o)),e.lineTo(i(c),l(c)),e.stroke(),e.setLineDash([]);let u=.17*t.cell/Math.hypot(s,a);e.beginPath(),e.moveTo(i(c)-a*u,l(c)+s*u),
e.lineTo(i(c)+a*u,l(c)-s*u),e.stroke()}function Do(e,t,n,r,o,s){let a=ue[s];if(!s||!a)return;let{ctx:i,grid:l,colors:c}=e,u=de(t,[r[0]+a[0],r[1]+a[1]])?bi:wi,d=vi*
o.size,p=[I(l,o.x+a[1]*d),$(l,o.y+a[0]*d),I(l,o.x+a[1]*u),$(l,o.y+a[0]*u)],h=Math.max(1.5,l.cell*.085);i.lineCap=i.lineJoin="round";for(let[g,f]of[[c.paper,h*2.1],
[Ve(e,t,n),h]])i.strokeStyle=g,i.lineWidth=f,wo(i,...p,l.cell*.2),i.stroke()}var Ti=.04,Wo=.3,Ci=.36,Mi=.13,zo=.62,Zt=.94;function Fo(e,t,n){let{ctx:r,grid:o,colors:s}=e,{cell:a}=o,i=f=>I(o,f[1]+.5),l=f=>$(o,f[0]+.5),c=Math.max(1.5,a*.06),
u=f=>de(t,f);r.lineCap="round";for(let[f,y]of[[n.escape,s.evader],[n.held,s.pursuer]]){r.fillStyle=y,r.globalAlpha=.28;let v=a*(1-2*Ti);for(let w of f.filter(u))
r.fillRect(i(w)-v/2,l(w)-v/2,v,v)}r.globalAlpha=1,r.lineWidth=c,r.fillStyle=r.strokeStyle=s.ink;let{sides:d,openSide:p,wall:h,to:g}=n;if(d){let[f,...y]=d;for(let v of y)
r.beginPath(),r.moveTo(i(f),l(f)),r.lineTo(i(v),l(v)),r.stroke()}if(h){let[f,y]=[Math.sign(h[0]-g[0]),Math.sign(h[1]-g[1])],[v,w]=[i(h)-y*a/2,l(h)-f*a/2],b=.3*a;
r.setLineDash([c,c*2]),r.beginPath(),r.moveTo(i(g),l(g)),r.lineTo(v,w),r.stroke(),r.setLineDash([]),r.beginPath(),r.moveTo(v-f*b,w-y*b),r.lineTo(v+f*b,w+y*b),r.
stroke()}for(let f of n.exits.filter(u)){let[y,v]=[i(f)-i(g),l(f)-l(g)];me(r,i(g)+zo*y,l(g)+zo*v,Math.max(3,a*Mi)),r.fill()}p&&(Ei(r,i(p),l(p),a*Ci),r.stroke()),
r.setLineDash([a*.12,a*.08]),r.strokeRect(i(g)-a*Zt/2,l(g)-a*Zt/2,a*Zt,a*Zt),r.setLineDash([])}function jo({ctx:e,grid:t,colors:n},r,o){let{cell:s}=t,a=d=>I(t,d[1]+
.5),i=d=>$(t,d[0]+.5),l=Math.max(3,s*.14),c=Math.max(1.5,s*.07),u=d=>{for(let[p,h]of[[n.paper,l],[n.ink,c]])e.strokeStyle=p,e.lineWidth=h,d(),e.stroke()};e.lineCap=
"round";for(let d of o.escape.filter(p=>de(r,p)))u(()=>me(e,a(d),i(d),s*Wo));for(let d of o.held.filter(p=>de(r,p)))u(()=>Vt(e,a(d),i(d),s*Wo*1.4));e.setLineDash(
[s*.1,s*.08]);for(let{pursuer:d,cell:p}of o.moved)e.strokeStyle=d?n.pursuer:n.evader,e.lineWidth=c,(d?Kt:me)(e,a(p),i(p),s*.72),e.stroke();e.setLineDash([])}function Ei(e,t,n,r){
e.beginPath(),e.moveTo(t,n-r),e.lineTo(t+r,n),e.lineTo(t,n+r),e.lineTo(t-r,n),e.closePath()}var Bo=e=>["rect",{x:1,y:1,width:22,height:22,class:`tint-${e}`}],qt=e=>[
"path",{d:e,class:"sign"}],Bn=(e,t)=>["circle",{cx:12,cy:12,r:e,class:t}],wu={escapes:[["next cell of the evader that no pursuer reaches",Bo("evader"),Bn(5,"sig\
n")],["next cell that a pursuer reaches",Bo("pursuer"),qt("M8 8l8 8m0-8l-8 8")]],opposite:[["two sides of the evader",qt("M3 20L12 5l9 15")]],open_side:[["neare\
st free side",qt("M12 3l9 9-9 9-9-9z")]],exits:[["way on",Bn(4,"filled-sign")]],room:[["nearest obstacle",qt("M2 12h2m5 0h2m5 0h2M21 4v16")]]},xu=["an agent tha\
t has moved before",Bn(8,"dashed-sign")];var Ho={numbers:!0,axes:!1,trail:6,viewers:[],plan:null,inputs:null,selected:null,cursor:null,you:null,fog:!1};function Ko(e,t,n,r,o){let{ctx:s,grid:a,colors:i}=e,
l=Math.min(Math.ceil(n),t.moments.length-1),c=t.moments[l],u=n===l,d=Ht(t,n),p=u?1:Math.max(0,1-2*(l-n));s.clearRect(0,0,s.canvas.width,s.canvas.height),Ao(e);for(let y of r.
viewers)d[y]?.alpha&&Ro(e,t,y,...Wn(t,y,n));To(e,t),r.axes&&Mo(e,o),No(e,t,n,r.trail,d);let h=u?r.inputs:null;h&&Fo(e,t,h),Po(e,c.contested??[],p),_o(e,t,n),Uo(
e,t,l,p),d.forEach(({x:y,y:v,size:w},b)=>{let A=uo(c,b)?.4:0,C=Dn(c,b)?1:A;C&&Lo(e,y,v,w,C*p)});let g=u?c:t.moments[Math.max(0,l-1)];if(Io(e,t,g,d,r.numbers,o),
h&&jo(e,t,h),u&&r.plan)for(let[y,v]of d.entries())v.alpha&&Do(e,t,y,M(c,y),v,r.plan[y]??0);r.you!==null&&(r.fog&&ko(e,t,...Wn(t,r.you,n)),Oo(e,d[r.you],o)),s.lineWidth=
Math.max(2,2.5*o),s.strokeStyle=i.focus;let f=r.selected===null?void 0:d[r.selected];f?.alpha&&Go(e,f.x,f.y,f.size*.96),r.cursor&&(s.setLineDash([a.cell*.12,a.cell*
.08]),Go(e,r.cursor[1]+.5,r.cursor[0]+.5,.8),s.setLineDash([]))}function Go({ctx:e,grid:t},n,r,o){let s=o*t.cell;e.beginPath(),e.roundRect(t.left+n*t.cell-s/2,t.
top+r*t.cell-s/2,s,s,s*.1),e.stroke()}var Vo=(e,t)=>(t+.24)/(e+.24);function Yo(e,t,n,r,o,s){let a=n?28*s:0,i=(c,u)=>(c-a)/(u+2*.12),l=Math.max(1,Math.floor(Math.min(i(r,t),i(o,e))));return{rows:e,cols:t,
cell:l,left:Math.round((r-t*l+a)/2),top:Math.round((o-e*l+a)/2)}}function Zo(e,t,n){let r=Math.floor((n-e.top)/e.cell),o=Math.floor((t-e.left)/e.cell);return r>=
0&&r<e.rows&&o>=0&&o<e.cols?[r,o]:null}var ki=["paper","line","frame","ink","muted","obstacle"],Oi=["pursuer","evader","capture","collision","focus"];function qo(e){let t=getComputedStyle(e),n=(r,o)=>[
r,t.getPropertyValue(o+r).trim()];return Object.fromEntries([...ki.map(r=>n(r,"--board-")),...Oi.map(r=>n(r,"--"))])}var vt=()=>matchMedia("(prefers-reduced-motion: reduce)").matches,Ye=class{canvas;#e=null;#n=0;#t;#r={rows:1,cols:1,left:0,top:0,cell:1};#o=0;constructor(t,n={}){
this.canvas=t,t.classList.add("board"),t.setAttribute("role","img"),this.#t={...Ho,...n},new ResizeObserver(()=>this.#i()).observe(t),new MutationObserver(()=>this.
redraw()).observe(document.documentElement,{attributes:!0}),addEventListener("beforeprint",()=>this.drawNow())}set look(t){this.#t={...this.#t,...t},this.#s(),this.
redraw()}show(t,n){this.#e=t,this.#n=Math.min(Math.max(0,n),t.moments.length-1),this.#s(),this.redraw()}redraw(){this.#o||(this.#o=requestAnimationFrame(()=>this.
drawNow()))}drawNow(){cancelAnimationFrame(this.#o),this.#o=0;let t=this.canvas.getContext("2d");if(!t||!this.#e)return;let{rows:n,cols:r}=this.#e,o=devicePixelRatio||
1;this.#r=Yo(n,r,this.#t.axes,this.canvas.width,this.canvas.height,o);let s={ctx:t,grid:this.#r,colors:qo(this.canvas)};Ko(s,this.#e,this.#n,this.#t,o)}cellAt(t,n){
let r=this.canvas.getBoundingClientRect(),o=this.canvas.width/r.width;return Zo(this.#r,(t-r.left)*o,(n-r.top)*o)}agentAt(t,n){let r=this.cellAt(t,n);if(!r||!this.#e)
return null;let o=this.#e.moments[Math.round(this.#n)],s=yt(this.#e,o).get(r[0]*this.#e.cols+r[1])??[],a=Ht(this.#e,Math.round(this.#n)),i=l=>{let[c,u]=this.pointOf(
a[l].x,a[l].y);return Math.hypot(c-t,u-n)};return s.length?s.reduce((l,c)=>i(c)<i(l)?c:l):null}pointOf(t,n){let r=this.canvas.getBoundingClientRect(),o=r.width/
this.canvas.width,{left:s,top:a,cell:i}=this.#r;return[r.left+(s+t*i)*o,r.top+(a+n*i)*o]}#s(){if(!this.#e)return;let{rows:t,cols:n}=this.#e;this.canvas.style.setProperty(
"--board-aspect",String(Vo(t,n)))}#i(){let t=devicePixelRatio||1,{width:n,height:r}=this.canvas.getBoundingClientRect();this.canvas.width=Math.max(1,Math.round(
n*t)),this.canvas.height=Math.max(1,Math.round(r*t)),this.drawNow()}};function Jt(e,t,n){let{rows:r,cols:o,n_pursuers:s,fov:a,rules:{interaction:i}}=e;return{rows:r,cols:o,nPursuers:s,fov:a,interaction:i,obstacles:t,moments:n}}function bt(e,t){
return{positions:e.read("last_positions"),alive:e.read("alive"),captured:e.read("captured"),everCaptured:e.read("ever_captured"),actions:t,involved:e.read("invo\
lved"),fault:e.read("fault"),contested:e.conflicts().map(n=>n.cell)}}var pe=["pursuer","evader"],Jo=e=>e==="pursuer"?"evader":"pursuer";var Fn=.005,Qo=.05,Ri=4,Ze=new Map;function Xt(e,t,n="capture-rate"){let r=JSON.stringify([{...t,rewards:null},n]),o=Ze.get(r)??(ze(t)?Promise.resolve(null):Ni(
e,t,n));return Ze.delete(r),Ze.set(r,o),Ze.size>Ri&&Ze.delete([...Ze.keys()][0]),o}var Qt=({n_evaders:e})=>e===1?"capture-time":"capture-rate",Xo=()=>new Promise(
e=>setTimeout(e));async function Ni(e,t,n){await Xo();let r=e.solution(t,n);for(;r.goBack();)await Xo();return r}function en(e,t,n){let{payoff:r}=e;return n.flatMap(
(o,s)=>{let a=[0,0];for(let l=t.n_turns;l>0&&!t.over;l--)e.game(t)?.lost(o).forEach((c,u)=>a[u]+=c),t.playTurn(o);let i=r==="capture-rate"?Fn:Qo;return pe.map((l,c)=>({
step:s+1,team:l,lost:a[c],payoff:r})).filter(l=>l.lost>=i)})}var es=e=>e.map(t=>({step:t.step,kind:t.team,size:t.lost/Math.max(1,...e.map(({lost:n})=>n)),text:wt(
t)})),ts=({lost:e,payoff:t})=>t==="capture-rate"?`${e.toFixed(2)} of the capture rate`:`${e.toFixed(1)} steps`,wt=e=>`The ${e.team}s lose ${ts(e)} against a per\
fect opponent`;function ns(e){let t=e.reduce((n,r)=>r.lost>n.lost?r:n);return`Your team's worst moves, in step ${t.step}, lost ${ts(t)} against a perfect oppone\
nt.`}function tn({config:e,payoff:t},{value:n},r){if(t==="capture-rate")return`value ${n.toFixed(2)}`;let o=1-n,s=Math.min(e.max_steps-r,Mn);return o>s-Qo?`free\
 for ${s} steps`:`captured after ${o.toFixed(1)} steps`}function nn(e,t){return(e.marginal(t)??[]).map((r,o)=>({share:r,action:o})).filter(({share:r})=>r>=Fn).sort(
(r,o)=>o.share-r.share).map(({share:r,action:o})=>r>1-Fn?j[o]:`${j[o]} ${r.toFixed(2)}`).join(", ")}var rn=class{recording;rules;outcomes=[];#e;#n;#t;#r=[];#o=[];constructor(t,n,r,o){this.#e=n,this.#n=o,this.rules=r;let s=Ge(n,r);this.#t=t.world(s),this.#t.restore(
_i(this.#t,n)),this.recording=Jt(s,this.#t.map(),this.#r),this.#i(void 0);for(let a of n.played)this.#s(a)}follow(t){if(!jn(this.#e,t))return!1;let n=this.#e.played,
r=t.played.findIndex((a,i)=>a!==n[i]),o=r<0?t.played.length:r,s=Math.min(o+1,this.#r.length);this.#r.length=this.outcomes.length=this.#o.length=s,this.#t.restore(
this.#o.at(-1));for(let a of t.played.slice(s-1))this.#s(a);return this.#e=t,!0}get length(){return this.#r.length-1}get over(){let{terminated:t,truncated:n}=this.
outcomes.at(-1);return t||n}actions(t){let n=Uint8Array.from(t,o=>typeof o=="number"?o:Ee),r=new Set(t.filter(o=>typeof o=="string"));for(let o of this.over?[]:
r)for(let s of["pursuer","evader"]){let a=this.#t.decide(o===be?this.#n[s].policy:o,s,n);t.forEach((i,l)=>{i===o&&l<this.#e.pursuers.length==(s==="pursuer")&&(n[l]=
a[l])})}return n}scene(){let t=this.#t,n=t.read("last_positions"),r=t.read("alive"),o=t.read("captured"),s=t.read("ever_captured"),a=this.#e.pursuers.length,i=te(
this.#e).map((l,c)=>({...On([n[2*c],n[2*c+1]]),gone:!r[c],captured:c>=a&&!!o[c-a],everCaptured:c>=a&&!!s[c-a]}));return{...this.#e,played:[],steps:t.steps,ended:this.
outcomes.at(-1).terminated,pursuers:i.slice(0,a),evaders:i.slice(a)}}perfect(t){let n=this.#o.at(-2),r=this.#r.at(-1).actions;return n&&this.#t.restore(n),{losses:n&&
r?en(t,this.#t,[r]):[],game:t.game(this.#t)}}free(){this.#t.free()}#s(t){if(this.over)return;let n=this.actions(t);this.#t.step(n),this.#i(n)}#i(t){let n=this.#t;
this.#r.push(bt(n,t)),this.#o.push(n.snapshot()),this.outcomes.push({conflicts:t?n.conflicts():[],rewards:n.read("rewards"),captors:n.read("captors"),terminated:!!n.
read("terminated")[0],truncated:!!n.read("truncated")[0]})}};function _i(e,t){let n=te(t),r=n.map(({cell:s})=>s[0]*t.cols+s[1]),o=s=>Uint8Array.from(t.evaders,a=>Number(
a[s]));return{...e.snapshot(),seed:BigUint64Array.of(t.seed),episode:BigUint64Array.of(t.episode),cells:Int32Array.from(r,(s,a)=>n[a].gone?-1:s),last_cells:Int32Array.
from(r,(s,a)=>n[a].gone?s:-1),captured:o("captured"),ever_captured:o("everCaptured"),capture_paid:o("everCaptured"),captors:new Int32Array(t.evaders.length),rewards:new Float32Array(
V(t)),report:new Int32Array(V(t)),participants:new Int32Array(0),steps:Int32Array.of(t.steps),terminated:Uint8Array.of(Number(t.ended)),truncated:Uint8Array.of(
+(t.steps>=t.maxSteps))}}function jn(e,t){return Object.keys(e).every(r=>["played","next","rules","others"].includes(r)||e[r]===t[r])}var Pi={SIMULTANEOUS:.45,SWARM_TURNS:.9,AGENT_TURNS:1.4},Li=200,on=class extends EventTarget{data;player;#e;#n;#t;#r=[];#o=[];#s=[];#i=!1;#h="act";#c=0;#p=null;#d;constructor(t,n,r,o=null){
super(),this.#e=t,this.data=n,this.#p=o,this.#n=this.#d=r,this.#t=this.#f(r),this.player=new He(this.game.length,{still:vt()}),this.player.jump(this.game.length),
this.player.addEventListener("frame",()=>this.#g()),this.#a()}get scene(){return this.#n}get game(){return this.#t[0]}get games(){return this.#t}get mode(){return this.#h}set mode(t){
this.stop(),this.#h=t,this.#m()}get selected(){return this.#c}set selected(t){this.#c=t,this.#m()}get running(){return this.#i}get example(){return jn(this.#d,this.#n)?
this.#p:null}get canStep(){return!this.game.over&&this.#n.played.length<Fe}change(t,n={}){let r;try{r=this.#f(t)}catch(o){if(!(o instanceof K))throw o;return this.
say(o.message,!0),!1}return n.part||(this.#r=[...this.#r,this.#n].slice(-Li)),this.#o=[],n.example!==void 0&&(this.#p=n.example,this.#d=t),this.#s=[],this.#l(t,
r),!0}step(){if(!this.canStep){this.stop(),this.say(this.game.over?"The episode has ended. Go back, or restart.":`The playground plays ${Fe} steps.`,!0);return}
let n=this.#s.at(-1)===this.#n.next?this.#s.slice(0,-1):[],r=Zr(this.#n);this.change({...r,next:n.at(-1)??r.next}),this.#s=n}back(){this.stop();let{played:t}=this.#n;
if(!this.game.length)return;let n=this.#n,r=this.#s.at(-1)===n.next?[...this.#s]:[];for(let o=t.length;o>=this.game.length;o--)n=qr(n),r.push(n.next);this.change(
n),this.#s=r}restart(){this.stop();let{played:t}=this.#n;if(!t.length)return;let n=[...this.#s.at(-1)===this.#n.next?this.#s:[],...[...t].reverse()];this.change(
{...this.#n,played:[],next:t[0]}),this.#s=n}run(){if(this.#i)return this.stop();this.#i=this.canStep,this.step()}stop(){this.#i&&(this.#i=!1,this.#m())}undo(){this.#u(
this.#r,this.#o)}redo(){this.#u(this.#o,this.#r)}solution(){let t=Ge(this.#n,this.#n.rules);return Xt(this.#e,t,Qt(t))}get canUndo(){return this.#r.length>0}shownBy(t,n="\
step"){this.addEventListener("change",t),this.player.addEventListener(n,t),t()}say(t,n=!1){this.dispatchEvent(new CustomEvent("message",{detail:{text:t,problem:n}}))}#u(t,n){
let r=t.pop();r&&(this.stop(),n.push(this.#n),this.#s=[],this.#l(r,this.#f(r)))}#f(t){let n=t.others?[t.rules,t.others]:[t.rules],r=this.#t??[];return n.map(o=>{
let s=r.find(i=>i.rules===o),a=s?.follow(t)?s:new rn(this.#e,t,o,this.data.champions);return a.actions(t.next),a})}#l(t,n){let r=this.#n,o=this.#t.length;for(let l of this.#t)
n.includes(l)||l.free();this.#n=t,this.#t=n,this.#c!==null&&this.#c>=te(t).length&&(this.#c=null);let s=this.game.length,a=this.player.step,i=r.rules!==t.rules||
t.others!==null&&o<2;this.player.length=s,this.#a(),i&&s&&this.player.jump(s-1),i&&s||Math.abs(s-a)===1?this.player.move(s-this.player.step):this.player.jump(s),
this.#m()}#a(){this.player.glide=Pi[this.#n.rules.interaction]}#g(){this.#i&&this.player.arrived&&this.step()}#m(){this.dispatchEvent(new Event("change"))}};function rs(e,t,n){let r=s=>new on(e,t,ht(s,t),ss(t,s)),o=t.gallery[0].scene;try{return{store:r(n||o),problem:""}}catch(s){return{store:r(o),problem:os(s)}}}function os(e){
if(e instanceof pt||e instanceof K)return`This link holds no scene. ${e.message}`;throw e}function ss(e,t){return e.gallery.find(n=>n.scene===t)??null}function _e(){
try{return decodeURIComponent(location.hash.slice(1))}catch{return location.hash.slice(1)}}var xt=e=>new URLSearchParams(e).has("moves"),Ii=100;function as(e,t,n){
let r=$n(e.scene,e.data),o=_e(),s=0,a=()=>{s=0,!(_e()!==o||!t())&&(o=r,history.replaceState(null,"",`#${r}`))};e.addEventListener("change",()=>{r=$n(e.scene,e.data),
t()&&(o=_e(),r!==o&&!s&&(s=setTimeout(a,Ii)))}),window.addEventListener("hashchange",()=>{if(o=_e(),!(!o||o===r||xt(o))){t()||n();try{e.change(ht(o,e.data),{example:ss(
e.data,o)})}catch(i){e.say(os(i),!0)}}})}function is(){let e=JSON.parse(document.getElementById("data").textContent),t={...e,scene:document.getElementById("scene")?.textContent??e.scene},n=document.getElementById(
"champions")?.textContent;return n?{...t,champions:JSON.parse(n,$i)}:t}var $i=(e,t)=>e==="genome"?Float32Array.from(t):t;var E=Uint8Array,J=Uint16Array,er=Int32Array,an=new E([0,0,0,0,0,0,0,0,1,1,1,1,2,2,2,2,3,3,3,3,4,4,4,4,5,5,5,5,0,0,0,0]),ln=new E([0,0,0,0,1,1,2,2,3,3,4,4,5,5,6,
6,7,7,8,8,9,9,10,10,11,11,12,12,13,13,0,0]),Yn=new E([16,17,18,0,8,7,9,6,10,5,11,4,12,3,13,2,14,1,15]),ps=function(e,t){for(var n=new J(31),r=0;r<31;++r)n[r]=t+=
1<<e[r-1];for(var o=new er(n[30]),r=1;r<30;++r)for(var s=n[r];s<n[r+1];++s)o[s]=s-n[r]<<5|r;return{b:n,r:o}},hs=ps(an,2),fs=hs.b,Zn=hs.r;fs[28]=258,Zn[258]=28;var gs=ps(
ln,0),Ui=gs.b,ls=gs.r,qn=new J(32768);for(T=0;T<32768;++T)he=(T&43690)>>1|(T&21845)<<1,he=(he&52428)>>2|(he&13107)<<2,he=(he&61680)>>4|(he&3855)<<4,qn[T]=((he&65280)>>
8|(he&255)<<8)>>1;var he,T,ie=(function(e,t,n){for(var r=e.length,o=0,s=new J(t);o<r;++o)e[o]&&++s[e[o]-1];var a=new J(t);for(o=1;o<t;++o)a[o]=a[o-1]+s[o-1]<<1;
var i;if(n){i=new J(1<<t);var l=15-t;for(o=0;o<r;++o)if(e[o])for(var c=o<<4|e[o],u=t-e[o],d=a[e[o]-1]++<<u,p=d|(1<<u)-1;d<=p;++d)i[qn[d]>>l]=c}else for(i=new J(
r),o=0;o<r;++o)e[o]&&(i[o]=qn[a[e[o]-1]++]>>15-e[o]);return i}),Se=new E(288);for(T=0;T<144;++T)Se[T]=8;var T;for(T=144;T<256;++T)Se[T]=9;var T;for(T=256;T<280;++T)
Se[T]=7;var T;for(T=280;T<288;++T)Se[T]=8;var T,Tt=new E(32);for(T=0;T<32;++T)Tt[T]=5;var T,Di=ie(Se,9,0),Wi=ie(Se,9,1),zi=ie(Tt,5,0),Bi=ie(Tt,5,1),Gn=function(e){
for(var t=e[0],n=1;n<e.length;++n)e[n]>t&&(t=e[n]);return t},re=function(e,t,n){var r=t/8|0;return(e[r]|e[r+1]<<8)>>(t&7)&n},Hn=function(e,t){var n=t/8|0;return(e[n]|
e[n+1]<<8|e[n+2]<<16)>>(t&7)},tr=function(e){return(e+7)/8|0},Ct=function(e,t,n){return(t==null||t<0)&&(t=0),(n==null||n>e.length)&&(n=e.length),new E(e.subarray(
t,n))};var Fi=["unexpected EOF","invalid block type","invalid length/literal","invalid distance","stream finished","no stream handler",,"no callback","invalid UTF-8 da\
ta","extra field too long","date not in range 1980-2099","filename too long","stream finishing","invalid zip data"],B=function(e,t,n){var r=new Error(t||Fi[e]);
if(r.code=e,Error.captureStackTrace&&Error.captureStackTrace(r,B),!n)throw r;return r},ys=function(e,t,n,r){var o=e.length,s=r?r.length:0;if(!o||t.f&&!t.l)return n||
new E(0);var a=!n,i=a||t.i!=2,l=t.i;a&&(n=new E(o*3));var c=function(tt){var nt=n.length;if(tt>nt){var Ie=new E(Math.max(nt*2,tt));Ie.set(n),n=Ie}},u=t.f||0,d=t.
p||0,p=t.b||0,h=t.l,g=t.d,f=t.m,y=t.n,v=o*8;do{if(!h){u=re(e,d,1);var w=re(e,d+1,3);if(d+=3,w)if(w==1)h=Wi,g=Bi,f=9,y=5;else if(w==2){var P=re(e,d,31)+257,R=re(
e,d+10,15)+4,S=P+re(e,d+5,31)+1;d+=14;for(var x=new E(S),U=new E(19),L=0;L<R;++L)U[Yn[L]]=re(e,d+L*3,7);d+=R*3;for(var F=Gn(U),ge=(1<<F)-1,Y=ie(U,F,1),L=0;L<S;){
var G=Y[re(e,d,ge)];d+=G&15;var b=G>>4;if(b<16)x[L++]=b;else{var D=0,k=0;for(b==16?(k=3+re(e,d,3),d+=2,D=x[L-1]):b==17?(k=3+re(e,d,7),d+=3):b==18&&(k=11+re(e,d,
127),d+=7);k--;)x[L++]=D}}var H=x.subarray(0,P),W=x.subarray(P);f=Gn(H),y=Gn(W),h=ie(H,f,1),g=ie(W,y,1)}else B(1);else{var b=tr(d)+4,A=e[b-4]|e[b-3]<<8,C=b+A;if(C>
o){l&&B(0);break}i&&c(p+A),n.set(e.subarray(b,C),p),t.b=p+=A,t.p=d=C*8,t.f=u;continue}if(d>v){l&&B(0);break}}i&&c(p+131072);for(var et=(1<<f)-1,X=(1<<y)-1,ce=d;;ce=
d){var D=h[Hn(e,d)&et],Z=D>>4;if(d+=D&15,d>v){l&&B(0);break}if(D||B(2),Z<256)n[p++]=Z;else if(Z==256){ce=d,h=null;break}else{var q=Z-254;if(Z>264){var L=Z-257,O=an[L];
q=re(e,d,(1<<O)-1)+fs[L],d+=O}var se=g[Hn(e,d)&X],Pe=se>>4;se||B(3),d+=se&15;var W=Ui[Pe];if(Pe>3){var O=ln[Pe];W+=Hn(e,d)&(1<<O)-1,d+=O}if(d>v){l&&B(0);break}i&&
c(p+131072);var Le=p+q;if(p<W){var Rt=s-W,Nt=Math.min(W,Le);for(Rt+p<0&&B(3);p<Nt;++p)n[p]=r[Rt+p]}for(;p<Le;++p)n[p]=n[p-W]}}t.l=h,t.p=ce,t.b=p,t.f=u,h&&(u=1,t.
m=f,t.d=g,t.n=y)}while(!u);return p!=n.length&&a?Ct(n,0,p):n.subarray(0,p)},fe=function(e,t,n){n<<=t&7;var r=t/8|0;e[r]|=n,e[r+1]|=n>>8},St=function(e,t,n){n<<=
t&7;var r=t/8|0;e[r]|=n,e[r+1]|=n>>8,e[r+2]|=n>>16},Kn=function(e,t){for(var n=[],r=0;r<e.length;++r)e[r]&&n.push({s:r,f:e[r]});var o=n.length,s=n.slice();if(!o)
return{t:bs,l:0};if(o==1){var a=new E(n[0].s+1);return a[n[0].s]=1,{t:a,l:1}}n.sort(function(C,P){return C.f-P.f}),n.push({s:-1,f:25001});var i=n[0],l=n[1],c=0,
u=1,d=2;for(n[0]={s:-1,f:i.f+l.f,l:i,r:l};u!=o-1;)i=n[n[c].f<n[d].f?c++:d++],l=n[c!=u&&n[c].f<n[d].f?c++:d++],n[u++]={s:-1,f:i.f+l.f,l:i,r:l};for(var p=s[0].s,r=1;r<
o;++r)s[r].s>p&&(p=s[r].s);var h=new J(p+1),g=Jn(n[u-1],h,0);if(g>t){var r=0,f=0,y=g-t,v=1<<y;for(s.sort(function(P,R){return h[R.s]-h[P.s]||P.f-R.f});r<o;++r){
var w=s[r].s;if(h[w]>t)f+=v-(1<<g-h[w]),h[w]=t;else break}for(f>>=y;f>0;){var b=s[r].s;h[b]<t?f-=1<<t-h[b]++-1:++r}for(;r>=0&&f;--r){var A=s[r].s;h[A]==t&&(--h[A],
++f)}g=t}return{t:new E(h),l:g}},Jn=function(e,t,n){return e.s==-1?Math.max(Jn(e.l,t,n+1),Jn(e.r,t,n+1)):t[e.s]=n},cs=function(e){for(var t=e.length;t&&!e[--t];)
;for(var n=new J(++t),r=0,o=e[0],s=1,a=function(l){n[r++]=l},i=1;i<=t;++i)if(e[i]==o&&i!=t)++s;else{if(!o&&s>2){for(;s>138;s-=138)a(32754);s>2&&(a(s>10?s-11<<5|
28690:s-3<<5|12305),s=0)}else if(s>3){for(a(o),--s;s>6;s-=6)a(8304);s>2&&(a(s-3<<5|8208),s=0)}for(;s--;)a(o);s=1,o=e[i]}return{c:n.subarray(0,r),n:t}},At=function(e,t){
for(var n=0,r=0;r<t.length;++r)n+=e[r]*t[r];return n},vs=function(e,t,n){var r=n.length,o=tr(t+2);e[o]=r&255,e[o+1]=r>>8,e[o+2]=e[o]^255,e[o+3]=e[o+1]^255;for(var s=0;s<
r;++s)e[o+s+4]=n[s];return(o+4+r)*8},us=function(e,t,n,r,o,s,a,i,l,c,u){fe(t,u++,n),++o[256];for(var d=Kn(o,15),p=d.t,h=d.l,g=Kn(s,15),f=g.t,y=g.l,v=cs(p),w=v.c,
b=v.n,A=cs(f),C=A.c,P=A.n,R=new J(19),S=0;S<w.length;++S)++R[w[S]&31];for(var S=0;S<C.length;++S)++R[C[S]&31];for(var x=Kn(R,7),U=x.t,L=x.l,F=19;F>4&&!U[Yn[F-1]];--F)
;var ge=c+5<<3,Y=At(o,Se)+At(s,Tt)+a,G=At(o,p)+At(s,f)+a+14+3*F+At(R,U)+2*R[16]+3*R[17]+7*R[18];if(l>=0&&ge<=Y&&ge<=G)return vs(t,u,e.subarray(l,l+c));var D,k,H,
W;if(fe(t,u,1+(G<Y)),u+=2,G<Y){D=ie(p,h,0),k=p,H=ie(f,y,0),W=f;var et=ie(U,L,0);fe(t,u,b-257),fe(t,u+5,P-1),fe(t,u+10,F-4),u+=14;for(var S=0;S<F;++S)fe(t,u+3*S,
U[Yn[S]]);u+=3*F;for(var X=[w,C],ce=0;ce<2;++ce)for(var Z=X[ce],S=0;S<Z.length;++S){var q=Z[S]&31;fe(t,u,et[q]),u+=U[q],q>15&&(fe(t,u,Z[S]>>5&127),u+=Z[S]>>12)}}else
D=Di,k=Se,H=zi,W=Tt;for(var S=0;S<i;++S){var O=r[S];if(O>255){var q=O>>18&31;St(t,u,D[q+257]),u+=k[q+257],q>7&&(fe(t,u,O>>23&31),u+=an[q]);var se=O&31;St(t,u,H[se]),
u+=W[se],se>3&&(St(t,u,O>>5&8191),u+=ln[se])}else St(t,u,D[O]),u+=k[O]}return St(t,u,D[256]),u+k[256]},ji=new er([65540,131080,131088,131104,262176,1048704,1048832,
2114560,2117632]),bs=new E(0),Gi=function(e,t,n,r,o,s){var a=s.z||e.length,i=new E(r+a+5*(1+Math.ceil(a/7e3))+o),l=i.subarray(r,i.length-o),c=s.l,u=(s.r||0)&7;if(t){
u&&(l[0]=s.r>>3);for(var d=ji[t-1],p=d>>13,h=d&8191,g=(1<<n)-1,f=s.p||new J(32768),y=s.h||new J(g+1),v=Math.ceil(n/3),w=2*v,b=function(gn){return(e[gn]^e[gn+1]<<
v^e[gn+2]<<w)&g},A=new er(25e3),C=new J(288),P=new J(32),R=0,S=0,x=s.i||0,U=0,L=s.w||0,F=0;x+2<a;++x){var ge=b(x),Y=x&32767,G=y[ge];if(f[Y]=G,y[ge]=Y,L<=x){var D=a-
x;if((R>7e3||U>24576)&&(D>423||!c)){u=us(e,l,0,A,C,P,S,U,F,x-F,u),U=R=S=0,F=x;for(var k=0;k<286;++k)C[k]=0;for(var k=0;k<30;++k)P[k]=0}var H=2,W=0,et=h,X=Y-G&32767;
if(D>2&&ge==b(x-X))for(var ce=Math.min(p,D)-1,Z=Math.min(32767,x),q=Math.min(258,D);X<=Z&&--et&&Y!=G;){if(e[x+H]==e[x+H-X]){for(var O=0;O<q&&e[x+O]==e[x+O-X];++O)
;if(O>H){if(H=O,W=X,O>ce)break;for(var se=Math.min(X,O-2),Pe=0,k=0;k<se;++k){var Le=x-X+k&32767,Rt=f[Le],Nt=Le-Rt&32767;Nt>Pe&&(Pe=Nt,G=Le)}}}Y=G,G=f[Y],X+=Y-G&
32767}if(W){A[U++]=268435456|Zn[H]<<18|ls[W];var tt=Zn[H]&31,nt=ls[W]&31;S+=an[tt]+ln[nt],++C[257+tt],++P[nt],L=x+H,++R}else A[U++]=e[x],++C[e[x]]}}for(x=Math.max(
x,L);x<a;++x)A[U++]=e[x],++C[e[x]];u=us(e,l,c,A,C,P,S,U,F,x-F,u),c||(s.r=u&7|l[u/8|0]<<3,u-=7,s.h=y,s.p=f,s.i=x,s.w=L)}else{for(var x=s.w||0;x<a+c;x+=65535){var Ie=x+
65535;Ie>=a&&(l[u/8|0]=c,Ie=a),u=vs(l,u+1,e.subarray(x,Ie))}s.i=a}return Ct(i,0,r+tr(u)+o)},Hi=(function(){for(var e=new Int32Array(256),t=0;t<256;++t){for(var n=t,
r=9;--r;)n=(n&1&&-306674912)^n>>>1;e[t]=n}return e})(),Ki=function(){var e=-1;return{p:function(t){for(var n=e,r=0;r<t.length;++r)n=Hi[n&255^t[r]]^n>>>8;e=n},d:function(){
return~e}}};var Vi=function(e,t,n,r,o){if(!o&&(o={l:1},t.dictionary)){var s=t.dictionary.subarray(-32768),a=new E(s.length+e.length);a.set(s),a.set(e,s.length),e=a,o.w=s.length}
return Gi(e,t.level==null?6:t.level,t.mem==null?o.l?Math.ceil(Math.max(8,Math.min(13,Math.log(e.length)))*1.5):20:12+t.mem,n,r,o)},ws=function(e,t){var n={};for(var r in e)
n[r]=e[r];for(var r in t)n[r]=t[r];return n};var ae=function(e,t){return e[t]|e[t+1]<<8},oe=function(e,t){return(e[t]|e[t+1]<<8|e[t+2]<<16|e[t+3]<<24)>>>0},Vn=function(e,t){return oe(e,t)+oe(e,t+4)*4294967296},
z=function(e,t,n){for(;n;++t)e[t]=n,n>>>=8};var Yi=function(e,t){return((e[0]&15)!=8||e[0]>>4>7||(e[0]<<8|e[1])%31)&&B(6,"invalid zlib data"),(e[1]>>5&1)==+!t&&B(6,"invalid zlib data: "+(e[1]&32?"need":"u\
nexpected")+" dictionary"),(e[1]>>3&4)+2};function Zi(e,t){return Vi(e,t||{},0,0)}function qi(e,t){return ys(e,{i:2},t&&t.out,t&&t.dictionary)}function xs(e,t){return ys(e.subarray(Yi(e,t&&t.dictionary),-4),{i:2},t&&t.out,t&&t.dictionary)}var Ss=function(e,t,n,r){for(var o in e){var s=e[o],a=t+o,i=r;Array.isArray(s)&&(i=ws(r,s[1]),s=s[0]),s instanceof E?n[a]=[s,i]:(n[a+="/"]=[new E(0),i],Ss(s,a,n,
r))}},ds=typeof TextEncoder<"u"&&new TextEncoder,Xn=typeof TextDecoder<"u"&&new TextDecoder,Ji=0;try{Xn.decode(bs,{stream:!0}),Ji=1}catch{}var Xi=function(e){for(var t="",
n=0;;){var r=e[n++],o=(r>127)+(r>223)+(r>239);if(n+o>e.length)return{s:t,r:Ct(e,n-1)};o?o==3?(r=((r&15)<<18|(e[n++]&63)<<12|(e[n++]&63)<<6|e[n++]&63)-65536,t+=String.
fromCharCode(55296|r>>10,56320|r&1023)):o&1?t+=String.fromCharCode((r&31)<<6|e[n++]&63):t+=String.fromCharCode((r&15)<<12|(e[n++]&63)<<6|e[n++]&63):t+=String.fromCharCode(
r)}};function sn(e,t){if(t){for(var n=new E(e.length),r=0;r<e.length;++r)n[r]=e.charCodeAt(r);return n}if(ds)return ds.encode(e);for(var o=e.length,s=new E(e.length+
(e.length>>1)),a=0,i=function(u){s[a++]=u},r=0;r<o;++r){if(a+5>s.length){var l=new E(a+8+(o-r<<1));l.set(s),s=l}var c=e.charCodeAt(r);c<128||t?i(c):c<2048?(i(192|
c>>6),i(128|c&63)):c>55295&&c<57344?(c=65536+(c&1047552)|e.charCodeAt(++r)&1023,i(240|c>>18),i(128|c>>12&63),i(128|c>>6&63),i(128|c&63)):(i(224|c>>12),i(128|c>>
6&63),i(128|c&63))}return Ct(s,0,a)}function nr(e,t){if(t){for(var n="",r=0;r<e.length;r+=16384)n+=String.fromCharCode.apply(null,e.subarray(r,r+16384));return n}else{
if(Xn)return Xn.decode(e);var o=Xi(e),s=o.s,n=o.r;return n.length&&B(8),s}}var Qi=function(e,t){return t+30+ae(e,t+26)+ae(e,t+28)},el=function(e,t,n){var r=ae(e,t+28),o=nr(e.subarray(t+46,t+46+r),!(ae(e,t+8)&2048)),s=t+46+r,a=oe(e,t+20),
i=n&&a==4294967295?tl(e,s):[a,oe(e,t+24),oe(e,t+42)],l=i[0],c=i[1],u=i[2];return[ae(e,t+10),l,c,o,s+ae(e,t+30)+ae(e,t+32),u]},tl=function(e,t){for(;ae(e,t)!=1;t+=
4+ae(e,t+2));return[Vn(e,t+12),Vn(e,t+4),Vn(e,t+20)]},Qn=function(e){var t=0;if(e)for(var n in e){var r=e[n].length;r>65535&&B(9),t+=r+4}return t},ms=function(e,t,n,r,o,s,a,i){
var l=r.length,c=n.extra,u=i&&i.length,d=Qn(c);z(e,t,a!=null?33639248:67324752),t+=4,a!=null&&(e[t++]=20,e[t++]=n.os),e[t]=20,t+=2,e[t++]=n.flag<<1|(s<0&&8),e[t++]=
o&&8,e[t++]=n.compression&255,e[t++]=n.compression>>8;var p=new Date(n.mtime==null?Date.now():n.mtime),h=p.getFullYear()-1980;if((h<0||h>119)&&B(10),z(e,t,h<<25|
p.getMonth()+1<<21|p.getDate()<<16|p.getHours()<<11|p.getMinutes()<<5|p.getSeconds()>>1),t+=4,s!=-1&&(z(e,t,n.crc),z(e,t+4,s<0?-s-2:s),z(e,t+8,n.size)),z(e,t+12,
l),z(e,t+14,d),t+=16,a!=null&&(z(e,t,u),z(e,t+6,n.attrs),z(e,t+10,a),t+=14),e.set(r,t),t+=l,d)for(var g in c){var f=c[g],y=f.length;z(e,t,+g),z(e,t+2,y),e.set(f,
t+4),t+=4+y}return u&&(e.set(i,t),t+=u),t},nl=function(e,t,n,r,o){z(e,t,101010256),z(e,t+8,n),z(e,t+10,n),z(e,t+12,r),z(e,t+16,o)};function As(e,t){t||(t={});var n={},r=[];Ss(e,"",n,t);var o=0,s=0;for(var a in n){var i=n[a],l=i[0],c=i[1],u=c.level==0?0:8,d=sn(a),p=d.length,h=c.comment,g=h&&
sn(h),f=g&&g.length,y=Qn(c.extra);p>65535&&B(11);var v=u?Zi(l,c):l,w=v.length,b=Ki();b.p(l),r.push(ws(c,{size:l.length,crc:b.d(),c:v,f:d,m:g,u:p!=a.length||g&&h.
length!=f,o,compression:u})),o+=30+p+y+w,s+=76+2*(p+y)+(f||0)+w}for(var A=new E(s+22),C=o,P=s-o,R=0;R<r.length;++R){var d=r[R];ms(A,d.o,d,d.f,d.u,d.c.length);var S=30+
d.f.length+Qn(d.extra);A.set(d.c,d.o+S),ms(A,o,d,d.f,d.u,d.c.length,d.o,d.m),o+=16+S+(d.m?d.m.length:0)}return nl(A,o,r.length,P,C),A}function Ts(e,t){for(var n={},r=e.length-22;oe(e,r)!=101010256;--r)(!r||e.length-r>65558)&&B(13);var o=ae(e,r+8);if(!o)return{};var s=oe(e,r+16),a=s==4294967295||
o==65535;if(a){var i=oe(e,r-12);a=oe(e,i)==101075792,a&&(o=oe(e,i+32),s=oe(e,i+48))}for(var l=t&&t.filter,c=0;c<o;++c){var u=el(e,s,a),d=u[0],p=u[1],h=u[2],g=u[3],
f=u[4],y=u[5],v=Qi(e,y);s=f,(!l||l({name:g,size:p,originalSize:h,compression:d}))&&(d?d==8?n[g]=qi(e.subarray(v,v+p),{out:new E(h)}):B(14,"unknown compression t\
ype "+d):n[g]=Ct(e,v,v+p))}return n}var rr=4,Cs=new Map;function Ms(e,t){let n=Cs.get(e);if(n)return n;let r=new Float32Array;try{let o=ol(sl(e),t);o.every(Number.isFinite)&&(r=o)}catch(o){if(!(o instanceof DOMException||
o instanceof RangeError||rl(o)))throw o}return Cs.set(e,r),r}var rl=e=>e instanceof Error&&"code"in e;function ol(e,t){let n=xs(e),r=n.length/rr,o=new Uint8Array(
n.length);for(let a=0;a<o.length;a++)o[a]=n[a%rr*r+Math.floor(a/rr)];let s=new Uint32Array(o.buffer);for(let a=t;a<s.length;a++)s[a]^=s[a-t];return new Float32Array(
o.buffer)}function sl(e){let t=atob(al(e)),n=new Uint8Array(t.length);for(let r=0;r<n.length;r++)n[r]=t.charCodeAt(r);return n}var al=e=>document.getElementById(
e)?.textContent??"";var qe=class{config;start;recording;actions=[];#e;#n;#t=[[]];constructor(t,n,r){this.config=n,this.start=r,this.#e=t.world(n),this.#e.reset(r),this.#n=[bt(this.#e)],
this.recording=Jt(n,this.#e.map(),this.#n)}get length(){return this.actions.length}get over(){return this.#e.over}get statistics(){return{capture_rate:this.#e.read(
"capture_rate")[0]}}conflicts(t){return this.#t[t]}game(t){return t.game(this.#e)}play(t){this.#e.step(t),this.#r(t)}step(t,n,r){let o=this.#e,s=this.config.n_pursuers,
a=new Uint8Array(o.n_agents);for(let i=o.n_turns;i>0&&!o.over;--i){let[l,c]=o.actors;l<s&&(a=o.decide(t.pursuer,[l,Math.min(c,s)],a)),c>s&&(a=o.decide(t.evader,
[Math.max(l,s),c],a)),typeof r=="number"?a[n]=r:l<=n&&n<c&&(a=o.decide(r,[n,n+1],a)),o.playTurn(a)}this.#r(a)}#r(t){this.actions.push(t),this.#n.push(bt(this.#e,
t)),this.#t.push(this.#e.conflicts())}};function Es(e,t,n,r){let o=new qe(e,t,n);for(let s of r)o.play(s);return o}var il={"|b1":e=>new Uint8Array(e),"|i1":e=>new Int8Array(e),"<i4":e=>new Int32Array(e),"<i8":e=>Int32Array.from(new BigInt64Array(e),Number),"<f4":e=>new Float32Array(
e)},Os="NUMPY\0",Je=Os.length+2,ks=64;function Rs(e){return As(Object.fromEntries(Object.entries(e).map(([t,n])=>[`${t}.npy`,ll(n)])))}function ll({dtype:e,shape:t,
data:n}){let r=typeof n=="string"?Array.from(n,u=>u.codePointAt(0)):null,o=t.map(u=>`${u}, `).join(""),s=`{'descr': '${r?`<U${r.length}`:e}', 'fortran_order': F\
alse, 'shape': (${o}), }`,a=Math.ceil((Je+s.length+1)/ks)*ks-Je,i=Os+String.fromCharCode(a&255,a>>8)+s.padEnd(a-1)+`
`,l=r?Int32Array.from(r):n,c=new Uint8Array(i.length+l.byteLength);return c.set(sn(i,!0)),c.set(new Uint8Array(l.buffer,l.byteOffset,l.byteLength),i.length),c}function Ns(e){
return Object.fromEntries(Object.entries(Ts(e)).map(([t,n])=>[t.replace(/\.npy$/,""),cl(n)]))}function cl(e){let t=Je+e[Je-2]+256*e[Je-1],n=nr(e.subarray(Je,t),
!0),r=/'descr': '([^']+)', 'fortran_order': False, 'shape': \(([\d, ]*)\)/.exec(n),o=r?.[1]??"",s=(r?.[2]??"").split(",").filter(c=>c.trim()).map(Number),a=e.slice(
t).buffer,i=o.startsWith("<U")&&String.fromCodePoint(...new Int32Array(a)),l=i===!1?il[o]?.(a):i.replace(/\0+$/,"");if(l===void 0)throw new TypeError(`expected \
an array of numbers or a text, got ${n.slice(0,80)}`);return{dtype:o,shape:s,data:l}}var or="matrixworld episode 3";function _s(e,t,n){let{config:r,actions:o,length:s,recording:a}=t,i=r.n_pursuers+r.n_evaders,l=r.n_evaders,c={positions:["<i4",i,
2],last_positions:["<i4",i,2],alive:["|b1",i],captured:["|b1",l],ever_captured:["|b1",l]},u={rewards:["<f4",i],involved:["|b1",i,3],fault:["|b1",i,3]},d={},p=b=>{
for(let A of Object.keys(b))(d[A]??=[]).push(Array.from(h.read(A),Number))},h=e.world(r);h.reset(t.start);let g=[];p(c);for(let b of o)h.step(b),p({...c,...u}),
g.push(...h.conflictTable());h.free();let f={"<i4":Int32Array,"<f4":Float32Array,"|b1":Uint8Array},y={};for(let[b,[A,...C]]of Object.entries({...c,...u})){let P=s+
+(b in c);y[b]={dtype:A,shape:[P,...C],data:f[A].from((d[b]??[]).flat())}}let v=b=>({dtype:"<i8",shape:[],data:Int32Array.of(b,0)}),w=b=>({dtype:"<U",shape:[],data:b});
return Rs({format:w(or),n_pursuers:v(r.n_pursuers),config:w(JSON.stringify(r)),seat:v(n),...y,actions:{dtype:"|i1",shape:[s,i],data:Int8Array.from(o.flatMap(b=>[
...b]))},map:{dtype:"|b1",shape:[r.rows,r.cols],data:Uint8Array.from(a.obstacles,Number)},conflict_table:{dtype:"<i4",shape:[g.length/11,11],data:Int32Array.from(
g)}})}function Ps(e,t){let n=Ns(t),r=h=>Array.from(n[h]?.data??[]);if(n.format?.data!==or)throw new K(`expected a file marked "${or}"`);let o=JSON.parse(n.config.
data),s=o.n_pursuers+o.n_evaders,a=r("positions"),i=(h,g)=>Array.from({length:g-h},(f,y)=>[a[2*(h+y)],a[2*(h+y)+1]]),l={pursuers:i(0,o.n_pursuers),evaders:i(o.n_pursuers,
s),obstacles:Uint8Array.from(r("map"))},c=Uint8Array.from(r("actions")),u=Array.from({length:c.length/s},(h,g)=>c.subarray(g*s,(g+1)*s)),d=Es(e,o,l,u);if(Array.
from(d.recording.moments.at(-1).positions).join()!==r("last_positions").slice(-2*s).join())throw new K("expected the moves of this start to lead to its end");return{
live:d,seat:r("seat")[0]??null}}var le=(e,t)=>pe[+(t>=e.n_pursuers)];function sr(e,t){let n=new qe(e,t.config,{seed:t.seed,episode:t.episode});for(let r of t.moves)n.over||n.step(t.policies,t.
seat,r);return n}function Ae(e,t){let{moments:n,nPursuers:r}=e.recording,o=n.findIndex(({alive:a,captured:i})=>!a[t]||!!i[t-r]),s=o<0?e.length:o;return{lasted:s,
out:o>=0,captured:Array.from(n[s].everCaptured).filter(Boolean).length}}var cn=(e,t)=>e.over||Ae(e,t).out;function Ls(e,t,n){let r=sr(e,{...t,moves:t.moves.slice(
0,t.from)});for(;!cn(r,t.seat);)r.step(t.policies,t.seat,n);return Ae(r,t.seat)}function ar(e){let t=e.length-1;return[...new Set([0,Math.round(t/3),t])].map(n=>e[n])}
function Is(e,{seat:t,from:n,moves:r}){let o={...e,seat:t,...n?{from:n}:{},moves:r.join("")};return`${location.href.split("#")[0]}#${Object.entries(o).map(([s,a])=>`${s}\
=${a}`).join("&")}`}function $s(e,t){let n=e.get("seat")??"",r=e.get("from")??"0",o=e.get("moves")??"";return/^\d{1,6}$/.test(n)&&Number(n)<t.n_pursuers+t.n_evaders&&
(t.diagonal?/^[0-8]+$/:/^[0-4]+$/).test(o)&&o.length<=t.max_steps&&/^\d{1,6}$/.test(r)&&Number(r)<=o.length?{seat:Number(n),from:Number(r),moves:[...o].map(Number)}:
null}var ir=()=>crypto.getRandomValues(new BigUint64Array(1))[0],ul=8;function Us(e,t,n){let{n_pursuers:r,n_evaders:o}=t,s=Array.from({length:r+o},(l,c)=>c).filter(
l=>le(t,l)!==le(t,n)),a=l=>{let c=new qe(e,t,{seed:l}).recording.moments[0].positions,u=(d,p)=>Math.abs(c[2*n+d]-c[2*p+d]);return Math.min(...s.map(d=>u(0,d)+u(
1,d)))};return Array.from({length:ul},ir).map(l=>[l,a(l)]).reduce((l,c)=>c[1]>l[1]?c:l)[0]}var dl=20,ml=60;function pl(e,t){let n=e.rules.capture==="SURROUND"?8:4,r=typeof e.obstacles!="number",o=a=>r?a:Math.min(a,dl),s={...e,rows:o(e.rows),cols:o(e.cols),
max_steps:ml,n_evaders:1,n_pursuers:Math.min(e.n_pursuers,n)};return ar(t).map(a=>({config:s,rival:a}))}function lr(e,t,n,r){let o=n.rounds.length?n.rounds.map(
({world:l,pursuers:c,text:u})=>({config:l,rival:{name:`${c.replaceAll("-"," ")}s`,text:u,policy:()=>c}})):pl(n.world,r),s=[],a=()=>`${s.reduce((l,c)=>l+c,0)} of\
 ${o.reduce((l,{config:c})=>l+c.max_steps,0)}`,i=()=>{let{config:l,rival:c}=o[s.length];t.play({title:`Can you escape it? Round ${s.length+1} of ${o.length}, ${l.
n_pursuers} pursuers: ${c.name}`,about:c.text&&`${c.name}: ${c.text}`,played:{config:l,seed:Us(e,l,l.n_pursuers),episode:0,seat:l.n_pursuers,from:0,moves:[],policies:{
pursuer:c.policy(),evader:"still"}},ending:u=>{s.push(Ae(u,l.n_pursuers).lasted);let d=o.map(({rival:{name:h}},g)=>m("tr",{},m("th",{scope:"row"},h),m("td",{},s[g]??
""))),p=s.length<o.length;return[m("table",{class:"numbers"},m("caption",{},`Steps of ${l.max_steps} in each round`),...d),m("p",{class:"play-score"},p?"Score s\
o far: ":"Your score: ",m("strong",{},a())),p?m("button",{type:"button",class:"primary",onclick:i},"Next round"):""]},again:()=>lr(e,t,n,r),link:()=>null})};i()}
function cr(e,t,n,r){let{players:o,told:s,...a}=r;t.play({...a,played:n,ending:(i,l)=>[s?m("p",{},s(Ae(i,n.seat))):"",hl(e,i,l,ar(o))],again:()=>cr(e,t,{...n,moves:n.
moves.slice(0,n.from)},r)})}function hl(e,t,n,r){let o=le(n.config,n.seat)==="evader",s=o?n.config.max_steps:n.config.n_evaders,a=m("table",{class:"numbers"},m(
"caption",{},o?"Steps in your seat: same start, same others":"Captures of your team: same start, same others")),i=c=>{let u=m("span",{class:o?"bar evader":"bar \
pursuer"}),d=m("td",{},"…");return a.append(m("tr",{},m("th",{scope:"row"},c),m("td",{class:"track","aria-hidden":"true"},u),d)),({lasted:p,captured:h})=>{u.style.
width=`${100*(o?p:h)/s}%`,d.textContent=String(o?p:h)}};i("You")(Ae(t,n.seat));for(let{name:c,policy:u}of r){let d=i(c);setTimeout(()=>d(Ls(e,n,u())))}let l=n.from?
`You took over at step ${n.from}. `:"";return m("div",{},a,m("p",{class:"small muted"},`${l}One match: luck has its part in it.`))}var fl={first:"M6 5v14M19 5 9 12l10 7z",back:"M17 5 7 12l10 7z",play:"M7 4.5 19 12 7 19.5z",pause:"M8 5v14M16 5v14",forward:"M7 5l10 7-10 7z",last:"M18 5v14M5 5\
l10 7-10 7z"};function Et(e){return ve("svg",{viewBox:"0 0 24 24","aria-hidden":"true",class:"icon"},ve("path",{d:fl[e]}))}function Mt(e,t,n,r){return m("button",
{type:"button",class:"player-button","aria-label":t,title:`${t} (${n})`,onclick:r},Et(e))}function Ds(e){let t=Mt("play","Play","Space",()=>e.toggle()),n=m("inp\
ut",{type:"range",class:"player-scrub",min:0,step:1,"aria-label":"Step",oninput:()=>{e.pause(),e.jump(Number(n.value))}}),r=m("div",{class:"captures","aria-hidd\
en":"true",title:"Captures"}),o=m("div",{class:"losses","aria-hidden":"true"}),s=m("select",{class:"player-speed","aria-label":"Speed",title:`Steps a second, or\
 the whole in ${Wt} s (+ and -)`,onchange:()=>e.speed=Number(s.value)},m("option",{value:co},`in ${Wt} s`),...ft.map(d=>m("option",{value:d},`${d} / s`))),a=m("\
output",{class:"player-count"}),i=m("div",{class:"player",role:"group","aria-label":"Player"},Mt("first","First step","Home",()=>e.move(-e.length)),Mt("back","S\
tep back","←",()=>e.move(-1)),t,Mt("forward","Step forward","→",()=>e.move(1)),Mt("last","Last step","End",()=>e.move(e.length)),m("div",{class:"scrub"},r,o,
n),a,s),l=(d,p={})=>{let h=m("i",p);return h.style.left=`${100*d/Math.max(1,e.length)}%`,h},c=()=>{r.replaceChildren(...e.marks.map(d=>l(d))),o.replaceChildren(
...e.ticks.map(({step:d,kind:p,size:h,text:g})=>{let f=l(d,{class:p,title:`Step ${d}: ${g}`});return f.style.height=`${100*h}%`,f}))},u=()=>{t.replaceChildren(Et(
e.playing?"pause":"play")),t.ariaLabel=e.playing?"Pause":"Play",t.title=`${t.ariaLabel} (Space)`,n.max=String(e.length),n.value=String(e.step),n.ariaValueText=`\
step ${e.step} of ${e.length}`,a.textContent=`${e.step} / ${e.length}`,a.style.minWidth=`${2*String(e.length).length+3}ch`,s.value=String(e.speed)};return e.addEventListener(
"step",u),e.addEventListener("state",u),e.addEventListener("state",c),i.addEventListener("keydown",d=>{!(d.target instanceof HTMLSelectElement||d.key===" "&&d.target!==
n)&&zt(e,d)&&d.preventDefault()}),u(),i}function Ws(e,t,n){if(n===0)return[{kind:"start",text:gl(e),agents:[]}];let r=t.moments[n-1],o=t.moments[n],s=u=>Q(u,e.config.n_pursuers),a=jt(t,r,o),i=e.conflicts(
n),l=new Set(i.flatMap(u=>u.doomed)),c=a.map(u=>({kind:"capture",text:`${s(u)} is captured`,agents:[u]}));for(let u of Gt(r,o))!a.includes(u)&&!l.has(u)&&c.push(
{kind:"end",text:`${s(u)} disappears`,agents:[u]});return c.push(...i.map(({kind:u,text:d,agents:p})=>({kind:u,text:d,agents:p}))),n===e.length&&c.unshift({kind:"\
end",text:yl(e),agents:[]}),c}function gl({config:e}){return`${e.n_pursuers} pursuers and ${e.n_evaders} evaders on ${e.rows} x ${e.cols} cells, at most ${e.max_steps}\
 steps`}function yl(e){let t=Math.round(e.statistics.capture_rate*e.config.n_evaders);return`The episode ends after ${e.length} steps with ${t} of ${e.config.n_evaders}\
 evaders captured`}function zs(e,t,...n){let r=m("dialog",{class:t,"aria-label":e,onclick:({target:o})=>o===r&&r.close()},m("div",{class:"dialog-head"},m("h2",{},e),m("button",{type:"\
button",class:"close","aria-label":"Close",onclick:()=>r.close()},"✕")),...n);return r}var ur=e=>m("dl",{class:"keys"},...e.flatMap(([t,n])=>[m("dt",{},...t.map(
r=>m("kbd",{},r))),m("dd",{},n)])),Bs=e=>m("input",{type:"text",readonly:!0,"aria-label":e});function Fs(e,t){e.value=t,e.hidden=!1,e.select(),navigator.clipboard?.
writeText(t).catch(()=>{})}function js(e,t){let n=URL.createObjectURL(new Blob([t],{type:"application/octet-stream"}));m("a",{href:n,download:e}).click(),setTimeout(
()=>URL.revokeObjectURL(n),6e4)}var kt=["·","↑","→","↓","←","↗","↘","↙","↖"],Gs=e=>typeof e=="number"?`${kt[e]} ${j[e]}`:e,vl={obstacle:["obstacle"],teammate:["teammate"],adversary:[
"evader","pursuer"]},bl=e=>e.length<2?e.join(""):`${e.slice(0,-1).join(", ")} and ${e.at(-1)}`;function un(e,t,n){let r=t.recording.moments[n-1],o=t.recording.moments[n],
s=t.outcomes[n];if(!r||!o||!s)return[];let a=[...s.conflicts.map(l=>wl(e,t.rules,l)),...xl(e,r,o,s.captors)],i={kind:"calm",text:"No conflict, no capture.",turn:0,
blame:"",cost:"",used:[]};return[...a.length?a:[i],...Sl(e,t,n)]}function wl(e,t,n){let r=n.at_fault.map(c=>ne(e,c)),o=t.interaction==="SIMULTANEOUS"?0:n.turn+1,
s=r.length?`At fault: ${bl(r)}.`:"Nobody is at fault.",a=n.held.length+n.doomed.length>0,i=new Set(n.at_fault.map(c=>Hs(e,c,ot.indexOf(n.kind))));i.delete(0);let l=a||
!i.size?"":`Allowed, but it costs: ${[...i].map(dn).join(" and ")}.`;return{kind:n.kind,text:`${n.text}.`,turn:o,blame:s,cost:l,used:vl[n.kind]}}function Hs({pursuers:e,
rewards:t},n,r){let o=n<e.length?t.pursuer_collide:t.evader_collide;return typeof o=="number"?o:o[r]}function dn(e){let t=String(Number(Math.abs(e).toPrecision(
5)));return e<0?`−${t}`:e>0?`+${t}`:"0"}function Ks(e,t,n,r){let o=t.recording.moments[n-1],s=t.recording.moments[n],a=t.outcomes[n];if(!o?.alive[r]||!s||!a)return"";
let{rewards:i}=e,l=r<e.pursuers.length?"pursuer":"evader",c=i.blame==="FAULT"?s.fault:s.involved,u=ot.reduce((h,g,f)=>h+(c?.[3*r+f]?Hs(e,r,f):0),0),d=a.rewards[r]-
u-i[`${l}_step`],p=Array.from({length:e.evaders.length+1},(h,g)=>g*i[`${l}_capture`]);for(let h of[0,i[`${l}_neighbor`]]){let g=p.find(v=>Math.abs(v+h-d)<1e-4);
if(g===void 0)continue;let f={collision:u,capture:g,neighbour:h,step:i[`${l}_step`]},y=Object.entries(f).filter(([,v])=>v).map(([v,w])=>`${dn(w)} ${v}`);return y.
length>1?y.join(", "):""}return""}function xl(e,t,n,r){let o=[];for(let s=0;s<e.evaders.length;s++){let a=e.pursuers.length+s,i=ne(e,a),l=t.alive[a]&&!n.alive[a],
c=r[s]?` by ${r[s]} ${r[s]===1?"pursuer":"pursuers"}`:"",u=["capture",...l?["captured_disappear"]:[]];n.captured[s]&&!t.captured[s]?o.push({kind:"capture",text:`${i}\
 is captured${c}${l?" and disappears":""}.`,turn:0,blame:"",cost:"",used:u}):t.captured[s]&&!n.captured[s]&&n.alive[a]&&o.push({kind:"capture",text:`${i} is fre\
e again.`,turn:0,blame:"",cost:"",used:["capture"]})}return o}function Sl(e,t,n){let{terminated:r,truncated:o}=t.outcomes[n];if(!r&&!o)return[];let s=t.recording.
moments[n].alive,a=(c,u)=>Array.from(s).slice(c,u).some(Boolean),i=e.pursuers.length,l=`after ${e.maxSteps} steps`;return r&&(l=a(0,i)?"every evader is captured\
 or gone":"no pursuer is left"),r&&!a(i,V(e))&&(l="no evader is left"),[{kind:"end",text:`The episode has ended: ${l}.`,turn:0,blame:"",cost:"",used:[]}]}function Ot(e){
return e.split(/(\(-?\d+, -?\d+\)|-[A-Z]{1,3}\b)/).map((t,n)=>n%2?m("span",{class:"whole"},t):t)}var Al={" ":0,ArrowUp:1,w:1,ArrowRight:2,d:2,ArrowDown:3,s:3,ArrowLeft:4,a:4,e:5,c:6,y:7,z:7,q:8},dr=[8,1,5,4,0,2,7,3,6],Tl=[7,8,9,4,5,6,1,2,3],Cl=24,Ml=Math.tan(
Math.PI/8);function Ys(e,t){if(e.ctrlKey||e.metaKey||e.altKey)return;let n=Tl.findIndex(o=>e.code===`Numpad${o}`),r=dr[n]??Al[e.key.length===1?e.key.toLowerCase():
e.key];return r!==void 0&&r>4&&!t?void 0:r}function Zs(e){let t=dr.map(n=>m("button",{type:"button","aria-label":j[n],onclick:()=>e(n)},kt[n]));return{element:m(
"div",{class:"play-pad",role:"group","aria-label":"Your move"},...t),show:n=>t.forEach((r,o)=>r.classList.toggle("absent",dr[o]>4&&!n))}}function Vs(e,t,n){let r=Ml*
Math.max(Math.abs(e),Math.abs(t)),o=s=>Math.abs(s)<r?0:s;return gt([0,0],n?[o(e),o(t)]:[e,t],n)}function qs(e,t,n){let r=null,{canvas:o}=e;o.addEventListener("p\
ointerdown",({button:s,clientX:a,clientY:i})=>r=s===0?[a,i]:null),o.addEventListener("pointercancel",()=>r=null),o.addEventListener("pointerup",({clientX:s,clientY:a})=>{
let i=r,l=t();if(r=null,!i||!l)return;let c=s-i[0],u=a-i[1],d=e.cellAt(s,a);Math.hypot(c,u)>=Cl?n(Vs(u,c,l.diagonal)):d&&n(Vs(d[0]-l.cell[0],d[1]-l.cell[1],l.diagonal))})}
function Js(e,t){let n=r=>{let o=t[r]-e[r],s=ue.findIndex(a=>a[r]===Math.sign(o)&&a[1-r]===0);return o?`${Math.abs(o)} ${j[s]}`:""};return[n(0),n(1)].filter(Boolean).
join(", ")||"on your cell"}var El=[0,1,2,4,8],mn=class{element;player=new He(0,{speed:4,still:vt()});#e;#n;#t=m("canvas",{tabindex:0,"aria-describedby":"play-keys"});#r=m("h2");#o=m("p",{
class:"play-told",role:"status"});#s=Zs(t=>this.act(t));#i=ut(El.map(t=>[t,t?`${t} / s`:"step by step"]),()=>this.#x());#h=m("input",{type:"checkbox",onchange:()=>this.#T()});#c=m(
"input",{type:"checkbox",onchange:()=>this.#S()});#p=m("label",{class:"play-choice"},this.#c,"Best move");#d=m("p",{class:"small muted play-keys",id:"play-keys"});#u=m(
"section",{class:"play-ending",tabindex:-1,"aria-labelledby":"play-headline"});#f=Ds(this.player);#l=null;#a=null;#g=[];#m=null;#y=null;#v=[];#b=0;#w=0;constructor(t){
this.#e=t,this.#n=new Ye(this.#t,{numbers:!1}),this.#t.setAttribute("role","application"),qs(this.#n,()=>{let n=this.#m!==null&&this.#a&&M(this.#a.recording.moments.
at(-1),this.#m);return n?{cell:n,diagonal:this.#a.config.diagonal}:null},n=>this.act(n)),this.player.addEventListener("frame",()=>this.#a&&this.#n.show(this.#a.
recording,this.player.time)),this.player.addEventListener("step",()=>this.#S()),this.element=m("div",{class:"play"},m("header",{class:"play-head"},this.#r,this.#o),
m("div",{class:"play-stage"},this.#t),m("div",{class:"play-side"},this.#u,this.#s.element,m("label",{class:"play-choice",title:"Steps a second"},"Pace ",this.#i),
m("label",{class:"play-choice"},this.#h,m("span",{},"Fog",m("span",{class:"at-length"},": see only what it sees"))),this.#p,this.#d),this.#f)}get played(){return this.#l&&
{...this.#l.played,moves:this.#g}}get live(){return this.#a}play(t){this.#A(sr(this.#e,t.played),t.played.seat,t.title),this.#l=t,this.#g=[...t.played.moves],this.#b=
0,this.element.dataset.state="playing",this.#t.focus({preventScroll:!0}),cn(this.#a,t.played.seat)&&this.#k()}watch(t,n,r){this.#l=null,this.#A(t,n,r),this.#O()}stop(){
this.#x(),this.player.pause(),this.#l=null}act(t){let n=this.#l,r=this.#a;if(!n||!r||this.element.dataset.state!=="playing")return;this.#b=t;let o=Number(this.#i.
value);this.#w||(this.#E(),o&&this.element.dataset.state==="playing"&&(this.#w=setInterval(()=>this.#E(),1e3/o)))}key(t){let{target:n,key:r}=t;if(n instanceof HTMLSelectElement||
n instanceof HTMLInputElement&&(n.type==="text"||r===" ")||n instanceof HTMLButtonElement&&(r===" "||r==="Enter")||!this.#a)return!1;if(this.element.dataset.state!==
"playing")return zt(this.player,t);let s=Ys(t,this.#a.config.diagonal);return s!==void 0&&this.act(s),s!==void 0}#A(t,n,r){this.#x(),this.player.pause(),this.#a=
t,this.#m=n,this.#r.textContent=r,this.#t.ariaLabel=`Board, ${t.config.rows} by ${t.config.cols} cells`,this.#s.show(t.config.diagonal),this.#d.replaceChildren(
m("span",{class:"at-length"},`W A S D or the arrow keys move, Space stays${t.config.diagonal?"; Q E Z C and the numeric keypad move diagonally":""}. `),"On the \
board: swipe, or tap where to go."),this.#R(t),this.#u.replaceChildren(),this.player.length=t.length,this.player.jump(t.length),this.#S()}#T(){this.#n.look={you:this.#m,
fog:this.#h.checked,viewers:this.#m===null?[]:[this.#m],plan:this.#N()}}#R(t){this.#y=null,this.#v=this.player.ticks=[],this.#p.hidden=this.#c.disabled=!!ze(t.config),
Xt(this.#e,t.config,Qt(t.config)).then(n=>{this.#a===t&&(this.#y=n,this.#C(),this.#S())})}#C(){let t=this.#a,n=this.#y;if(!n||this.element.dataset.state==="play\
ing")return;let r=this.#e.world(t.config);r.reset(t.start),this.#v=en(n,r,t.actions),r.free(),this.player.ticks=es(this.#v)}get#M(){return this.#c.checked&&this.#l&&
this.element.dataset.state==="playing"&&this.#y&&this.#a.game(this.#y)||null}#N(){let t=this.#m,n=this.#m!==null&&this.#M?.marginal(this.#m);return t!==null&&n?
Object.assign(Array(t).fill(0),{[t]:n.indexOf(Math.max(...n))}):null}#x(){clearInterval(this.#w),this.#w=0,this.#o.ariaLive=Number(this.#i.value)?"off":"polite"}#E(){
let{policies:t,seat:n}=this.#l.played,r=this.#a;r.step(t,n,this.#b),this.#g.push(this.#b),this.player.length=r.length,this.player.glide=Math.min(.22,.9/(Number(
this.#i.value)||4)),this.player.move(r.length-this.player.step),cn(r,n)&&this.#k()}#k(){this.#x();let t=this.#l,n=this.#a,r=this.played,o=dt()?t.link(r):null,s=`${Q(
r.seat,n.config.n_pursuers)}-${n.length}-steps.npz`,a=()=>js(s,_s(this.#e,n,r.seat)),i=Bs("Link to this match");i.hidden=!0,this.#u.replaceChildren(m("h3",{id:"\
play-headline"},Rl(n,r.seat)),...t.ending(n,r),m("div",{class:"play-buttons"},m("button",{type:"button",class:"primary",onclick:()=>t.again()},"Again"),m("butto\
n",{type:"button",onclick:()=>this.#O()},"Watch it"),m("button",{type:"button",onclick:a},"Save"),o&&m("button",{type:"button",onclick:()=>Fs(i,o)},t.linkName??
"Link")),i),this.element.dataset.state="ended",this.player.jump(n.length),this.#C();let l=this.#v.filter(({team:c})=>c===le(n.config,r.seat));l.length&&this.#u.
children[0].after(m("p",{class:"small muted"},ns(l))),this.#u.focus({preventScroll:!0}),this.#u.scrollIntoView({block:"nearest"})}#O(){this.element.dataset.state=
"watched",this.player.length=this.#a.length,this.player.jump(0),vt()||this.player.play()}#S(){let t=this.#a,n=this.#m,{step:r}=this.player;if(!t||r>t.length)return;
let o=Ws(t,t.recording,r).filter(({agents:l})=>n===null||l.includes(n)),s=this.#l&&r===0,a=s?[kl(t.config,n),this.#l.about??""]:[`Step ${r} of ${t.config.max_steps}`,
...o.map(({text:l})=>l)];!s&&n!==null&&a.push(Ol(t,r,n)),a.push(...this.#v.filter(l=>l.step===r).map(wt));let i=r===t.length&&n!==null?this.#M:null;i&&a.push(`P\
erfect play: ${nn(i,n)||"decided in its turn"}; ${tn(this.#y,i,r)}`),this.#T(),this.#o.textContent=a.filter(Boolean).map(l=>`${l}.`).join(" ")}};function kl(e,t){
let n=e.rules.capture==="SURROUND";return le(e,t)==="evader"?`Run away: you win if ${n?"the pursuers do not surround you":"no pursuer reaches your cell"} in ${e.
max_steps} steps`:`Capture evaders: ${n?"surround them with your team":"move onto their cells"}`}function Ol({config:e,recording:t},n,r){let o=t.moments[n],s=le(
e,r),a=Jo(s);if(!o.alive[r])return"";let i=M(o,r),l=d=>{let[p,h]=M(o,d);return Math.max(Math.abs(p-i[0]),Math.abs(h-i[1]))},c=Array.from({length:o.alive.length},
(d,p)=>p).filter(d=>le(e,d)===a&&o.alive[d]&&!o.captured[d-e.n_pursuers]&&2*l(d)<e.fov);if(!c.length)return`No ${a} in view`;let u=c.reduce((d,p)=>l(p)<l(d)?p:d);
return`Nearest ${a}: ${Js(i,M(o,u))}`}function Rl(e,t){let{lasted:n,out:r,captured:o}=Ae(e,t),{config:s}=e;return le(s,t)==="pursuer"?`Your team captured ${o} o\
f ${Nl(s)} in ${n} steps.`:r?`You lasted ${n} of ${s.max_steps} steps.`:`You escaped: ${n} steps.`}var Nl=({n_evaders:e})=>`${e} evader${e===1?"":"s"}`;var Qs={escape:"Can you escape it?",match:"One match",file:"A match from a file"},pn=class extends EventTarget{element;view;game="escape";#e;#n;#t;#r=ut([[0,"an\
 evader"],[1,"a pursuer"]],()=>{});#o;#s;#i;#h=m("ul",{class:"small muted about"});#c=m("p",{class:"problem",role:"alert"});#p=m("input",{type:"file",accept:".n\
pz",hidden:!0,onchange:()=>this.#g()});#d;constructor(t,n){super(),this.#e=t,this.#n=n,this.view=new mn(t),this.#t={pursuer:Xs(n,"pursuer"),evader:Xs(n,"evader")};
let r=o=>ut(this.#t[o].map(({name:s},a)=>[a,s]),()=>this.#f());this.#o={pursuer:r("pursuer"),evader:r("evader")};for(let o of pe)this.#o[o].selectedIndex=n.teams[o].
usual;this.#s=m("div",{class:"of-match"},m("label",{},"You are ",this.#r),m("label",{},"Pursuers ",this.#o.pursuer),m("label",{},"Evaders ",this.#o.evader),m("b\
utton",{type:"button",class:"primary",onclick:()=>this.#l()},"Play"),this.#h),this.#i=m("div",{class:"of-match"},m("button",{type:"button",class:"primary",onclick:()=>this.#p.
click()},"Choose a file"),this.#p,m("span",{class:"small muted"},"A match that this page or matrixworld.Episode has saved (.npz)."),this.#c),this.#d=m("section",
{class:"card","aria-label":"Match"},this.view.element),this.element=m("section",{class:"games","aria-label":"Play"},m("div",{class:"card setup"},this.#s,this.#i),
this.#d)}begin(t){this.#u(t),t==="escape"?lr(this.#e,this.view,this.#n,this.#t.pursuer):t==="match"?this.#l():(this.view.stop(),this.#d.hidden=!0)}follow(t){let n=$s(
t,this.#n.world),r=Number(t.get("pursuers")??NaN),o=Number(t.get("evaders")??NaN),s=/^\d{1,20}$/.test(t.get("seed")??"")?BigInt.asUintN(64,BigInt(t.get("seed"))):
null;return!n||s===null||!this.#t.pursuer[r]||!this.#t.evader[o]?!1:(this.#o.pursuer.selectedIndex=r,this.#o.evader.selectedIndex=o,this.#r.selectedIndex=+(n.seat<
this.#n.world.n_pursuers),this.#u("match"),this.#a({pursuer:r,evader:o,seed:s},n),!0)}#u(t){this.game=t,this.#s.hidden=t!=="match",this.#i.hidden=t!=="file",this.#s.
parentElement.hidden=t==="escape",this.#d.hidden=!1,this.#c.textContent="",this.#f(),this.dispatchEvent(new Event("game"))}#f(){this.#h.replaceChildren(...pe.map(
t=>{let{name:n,text:r}=this.#t[t][this.#o[t].selectedIndex];return m("li",{},m("span",{class:t},n),r&&`: ${r}`)}))}#l(){let{pursuer:t,evader:n}=this.#o,r=this.#r.
selectedIndex?0:this.#n.world.n_pursuers;this.#a({pursuer:t.selectedIndex,evader:n.selectedIndex,seed:ir()},{seat:r,from:0,moves:[]})}#a(t,n){let r=this.#n.world,
o=this.#t,s=pe[+(n.seat>=r.n_pursuers)],a=o.pursuer[t.pursuer],i=o.evader[t.evader],l={pursuer:a.policy(),evader:i.policy()},c=`You are ${Q(n.seat,r.n_pursuers)}\
. Pursuers: ${a.name}; evaders: ${i.name}`;cr(this.#e,this.view,{config:r,seed:t.seed,episode:0,policies:l,...n},{title:c,players:o[s],link:u=>Is({pursuers:t.pursuer,
evaders:t.evader,seed:t.seed},u)})}#g(){let[t]=this.#p.files??[];this.#c.textContent="",t?.arrayBuffer().then(n=>Ps(this.#e,new Uint8Array(n))).then(({live:n,seat:r})=>{
this.#u("file"),this.view.watch(n,r,t.name)}).catch(n=>this.#c.textContent=`${t.name} holds no match: ${n.message}`),this.#p.value=""}};function Xs({teams:e},t){
let{names:n,texts:r,scripts:o,policy:s}=e[t],a=i=>{let l=o[i];if(l||!s)return l;let c=s.genome_size,u=o.slice(0,i).filter(d=>d===null).length;return{...s,genome:Ms(
t,c).subarray(u*c,(u+1)*c)}};return n.map((i,l)=>({name:i.replaceAll("-"," "),text:r[l],policy:()=>a(l)}))}var na={ArrowUp:1,ArrowRight:2,ArrowDown:3,ArrowLeft:4},_l={e:5,c:6,y:7,z:7,q:8};function ra(e){let t=m("div",{class:"arena"}),n=[ea(e,0),ea(e,1)];return t.append(
...n.map(r=>r.element)),e.shownBy(()=>n.forEach(r=>r.update()),"frame"),t}function ea(e,t){let n=m("canvas",{tabindex:0,"aria-describedby":"board-keys"}),r=m("h\
2",{class:"arm-name"}),o=m("figure",{class:"arm"},r,n),s=new Ye(n,{axes:!0,trail:1}),a={cell:[0,0]};Pl(e,s);let i=()=>{let l=e.games[t];if(o.hidden=!l,!l)return;
let{mode:c,scene:u}=e;n.setAttribute("role","application"),n.ariaLabel=`Board, ${u.rows} by ${u.cols} cells`,n.dataset.mode=c,r.textContent=Te(e,t),r.hidden=e.games.
length<2;let d=e.player.arrived&&e.player.step===e.game.length;s.look={plan:c==="act"&&d&&!l.over?l.actions(u.next):null,selected:c==="act"?e.selected:null,cursor:c===
"build"&&document.activeElement===n?a.cell:null},s.show(l.recording,e.player.time)};return n.addEventListener("focus",i),n.addEventListener("blur",i),$l(e,n,a,i),
{element:o,update:i}}function Te(e,t){let n=t?e.scene.others:e.scene.rules;return n&&je(n,e.data.variants)||"own rules"}function mr(e,t){let n=te(e.game.scene())[t];
return n&&!n.gone?n.cell:null}function Pl(e,t){let n=null;t.canvas.addEventListener("pointerdown",r=>{let o=t.cellAt(r.clientX,r.clientY);if(!o||r.button!==0||e.
running)return;t.canvas.setPointerCapture(r.pointerId);let s=t.agentAt(r.clientX,r.clientY);n=e.mode==="build"?Il(e,o,s):Ll(e,o,s)}),t.canvas.addEventListener("\
pointermove",r=>{let o=t.cellAt(r.clientX,r.clientY);o&&n?.(o)});for(let r of["pointerup","pointercancel"])t.canvas.addEventListener(r,()=>n=null)}function Ll(e,t,n){
if(n===null){let s=e.selected===null?null:mr(e,e.selected);return s&&Math.max(Math.abs(s[0]-t[0]),Math.abs(s[1]-t[1]))===1&&Xe(e,gt(s,t,e.scene.diagonal)),null}
let r=e.selected===n;e.selected=n;let o=mr(e,n);return o?(r&&Xe(e,0),s=>Xe(e,gt(o,s,e.scene.diagonal))):null}function Il(e,t,n){let r=!1,o=i=>{e.change(i,{part:r}),
r=!0};if(n!==null)return e.selected=n,i=>{let l=e.game.scene();we(l,i)===null&&!xe(l,i)&&o(_n(l,n,i))};let s=!xe(e.game.scene(),t),a=i=>{let l=e.game.scene();we(
l,i)===null&&xe(l,i)!==s&&o(Pn(l,i,s))};return a(t),a}function Xe(e,t){let{selected:n,scene:r}=e;n===null||e.running||e.game.over||(r.next[n]!==t&&e.change($t(r,
n,t)),e.say(`${ne(r,n)}: ${j[t]}.`))}function $l(e,t,n,r){t.addEventListener("keydown",o=>{if(o.ctrlKey||o.metaKey||o.altKey)return;let s=e.mode==="act"?pr(e,o):
Ul(e,o,n);r(),s&&o.preventDefault()})}function pr(e,t){let n=t.key.length===1?t.key.toLowerCase():t.key,r=na[n]??(e.scene.diagonal?_l[n]:void 0)??{s:0,Delete:0}[n];
return r!==void 0?(e.selected===null&&ta(e,1),Xe(e,r),!0):n!=="n"&&n!=="p"?!1:(ta(e,n==="n"?1:-1),!0)}function ta(e,t){let n=V(e.scene),r=e.game.recording.moments.
at(-1).alive,o=e.selected??(t>0?-1:n);for(let s=0;s<n;s++){if(o=(o+t+n)%n,!r[o])continue;e.selected=o;let[a,i]=mr(e,o);return e.say(`${ne(e.scene,o)} at (${a}, ${i}\
).`)}}function Ul(e,t,n){let r=e.game.scene(),o=na[t.key];if(o!==void 0){let a=t.shiftKey?we(r,n.cell):null,i=[n.cell[0]+ue[o][0],n.cell[1]+ue[o][1]];de(r,i)&&(n.
cell=i);let l=we(r,n.cell)===null&&!xe(r,n.cell);a!==null&&l&&e.change(_n(r,a,n.cell));let[c,u]=n.cell;return e.say(`(${c}, ${u}): ${Dl(e,n.cell)}.`),!0}let s=we(
r,n.cell);return t.key===" "||t.key==="Enter"?(s===null?e.change(Pn(r,n.cell,!xe(r,n.cell))):e.selected=s,!0):t.key==="Delete"&&s!==null?(e.change(Ut(r,s)),!0):
!1}function Dl(e,t){let n=e.game.scene(),r=we(n,t);return r!==null?ne(n,r):xe(n,t)?"obstacle":"free"}function hr(e){let t=e==="pursuers"?ve("path",{d:"M12 3 22 20H2z"}):ve("circle",{cx:12,cy:12,r:9.5});return ve("svg",{viewBox:"0 0 24 24",class:`glyph ${e}`,"ar\
ia-hidden":!0},t)}function oa(e){let t=[0,1].map(()=>m("th",{class:"reward",scope:"col"})),n=m("tbody"),r=m("table",{class:"agents"},m("thead",{},m("tr",{},m("t\
h",{scope:"col"},"agent"),m("th",{scope:"col"},"next"),...t)),n),o=m("section",{class:"card agents-card"},m("h2",{},"Agents"),e.data.champions?m("button",{type:"\
button",title:"The policies of the match move all agents but the chosen one",onclick:()=>Wl(e)},"Policies move all others"):"",m("div",{class:"agents-scroll"},r)),
s=[],a="",i=()=>{let{scene:l}=e,c=`${l.pursuers.length} ${l.evaders.length} ${l.diagonal}`;c!==a&&(a=c,s=Array.from({length:V(l)},(u,d)=>zl(e,d)),n.replaceChildren(
...s.map(u=>u.element))),t.forEach((u,d)=>{u.hidden=d>=e.games.length,u.textContent=e.games.length>1&&e.games[d]?Te(e,d):"reward",u.title="Reward of the step"}),
s.forEach((u,d)=>Fl(e,u,d))};return e.shownBy(i),o}function Wl(e){e.stop(),e.change({...e.scene,next:e.scene.next.map((t,n)=>n===e.selected?t:be)})}function zl(e,t){
let{scene:n}=e,r=ne(n,t),o=m("select",{"aria-label":`${r} does next`,onchange:()=>{let u=o.value;e.stop(),e.change($t(e.scene,t,/^\d$/.test(u)?Number(u):u))}},...Bl(
e,n,t)),s=m("span",{class:"state muted"}),a=m("span",{class:"heard"}),i=m("button",{type:"button",class:"agent-name",onclick:()=>e.selected=t},hr(Rn(n,t)),r,a),
l=[0,1].map(()=>m("td",{class:"reward numbers"}));return{element:m("tr",{},m("th",{scope:"row"},i),m("td",{},o,s),...l),choice:o,state:s,heard:a,rewards:l}}function Bl(e,t,n){
let r=j.slice(0,t.diagonal?9:5).map((i,l)=>m("option",{value:l},Gs(l))),o=e.data.scripts.map(({name:i,text:l})=>m("option",{value:i,title:l},i)),s=[m("optgroup",
{label:"move"},...r),m("optgroup",{label:"script"},...o)],a=e.data.champions?.[n<t.pursuers.length?"pursuer":"evader"];return a?[m("option",{value:be},a.name),...s]:
s}function Fl(e,{element:t,choice:n,state:r,heard:o,rewards:s},a){let{scene:i,game:l,player:c}=e,u=l.recording.moments[Math.min(c.step,l.length)],d=a-i.pursuers.
length,p=d>=0&&!!u.captured[d];t.classList.toggle("chosen",e.selected===a),t.classList.toggle("gone",!u.alive[a]),n.value=String(i.next[a]),n.disabled=!u.alive[a]||
l.over,n.hidden=!u.alive[a],r.hidden=!!u.alive[a],r.textContent=p?"captured":"gone",t.classList.toggle("captured",p),o.textContent=p?" captured":"",s.forEach((h,g)=>{
let f=e.games[g];h.hidden=!f;let y=f?.outcomes[c.step]?.rewards[a],v=f?Ks(i,f,c.step,a):"";h.replaceChildren(c.step&&y!==void 0?dn(y):"",e.games.length>1?"":m("\
span",{class:"sum small muted"},v)),h.title=v;let w=l.outcomes[c.step]?.rewards[a];h.classList.toggle("differs",g>0&&y!==void 0&&w!==y)})}function sa(e){let t=e.data.gallery.map(i=>m("button",{type:"button",class:"chip",onclick:()=>{e.stop(),e.mode="act",e.change(ht(i.scene,e.data),{example:i}),e.
selected=0}},i.title)),n=m("p",{class:"example-text"}),r=m("p"),o=m("details",{class:"reveal"},m("summary",{},"Reveal"),r),s=m("nav",{class:"gallery","aria-labe\
l":"Examples"},m("div",{class:"chips"},...t),n,o),a;return e.shownBy(()=>{e.data.gallery.forEach((i,l)=>t[l].setAttribute("aria-pressed",String(i===e.example))),
n.replaceChildren(...Ot(e.example?.ask??"A scene of your own. Choose an example, or change this one.")),r.replaceChildren(...Ot(e.example?.text??"")),o.hidden=!e.
example,a!==e.example&&(o.open=!1),a=e.example}),s}function aa(e){let t=jl(e),n=Gl(e),r=Kl(e),o=Hl(e),s=m("p",{class:"message",role:"status"});e.addEventListener("message",i=>{let{text:l,problem:c}=i.detail;s.textContent=
l,s.classList.toggle("problem",c)});let a=[t,n,r,o];return e.addEventListener("change",()=>{s.textContent="",s.classList.remove("problem")}),e.shownBy(()=>a.forEach(
i=>i.update())),m("div",{class:"toolbar"},...a.map(i=>i.element),s)}function hn(e,t,n,r){return m("button",{type:"button",title:`${t} (${n})`,onclick:r},Et(e),m(
"span",{},t))}function jl(e){let t=hn("first","Restart","Home",()=>e.restart()),n=hn("back","Back","Backspace",()=>e.back()),r=hn("forward","Step","Enter",()=>e.
step()),o=hn("play","Run","Space",()=>e.run());return r.classList.add("primary"),r.id="step",{element:m("div",{class:"buttons",role:"group","aria-label":"Steps"},
t,n,r,o),update:()=>{for(let s of[t,n])s.setAttribute("aria-disabled",String(!e.game.length));r.setAttribute("aria-disabled",String(!e.canStep)),o.setAttribute(
"aria-disabled",String(!e.canStep&&!e.running)),o.replaceChildren(Et(e.running?"pause":"play"),m("span",{},e.running?"Stop":"Run"))}}}function Gl(e){let t={act:"\
Move",build:"Build"},n={act:"Choose agents and their moves (M)",build:"Place agents and draw obstacles (M)"},r=Object.keys(t),o=r.map(s=>m("button",{type:"butto\
n",title:n[s],onclick:()=>e.mode=s},t[s]));return{element:m("div",{class:"buttons joined",role:"group","aria-label":"What the board does"},...o),update:()=>r.forEach(
(s,a)=>o[a].setAttribute("aria-pressed",String(e.mode===s)))}}function Hl(e){let t=(s,a,i)=>m("button",{type:"button",title:`Add ${a} (${i})`,"aria-label":`Add ${a}`,
onclick:()=>fn(e,s)},"+",hr(s)),n=m("button",{type:"button",title:"Remove the chosen agent (Delete)",onclick:()=>fr(e)},"Remove"),r=[t("pursuers","a pursuer","+"),
t("evaders","an evader","-"),n],o=m("div",{class:"buttons",role:"group","aria-label":"Agents"},...r);return{element:o,update:()=>{o.hidden=e.mode!=="build",n.setAttribute(
"aria-disabled",String(e.selected===null))}}}function Kl(e){let t=[8,7,4,1,0,3,2,5,6],n=t.map(o=>m("button",{type:"button","aria-label":j[o],title:`The chosen a\
gent: ${j[o]}`,onclick:()=>Xe(e,o)},kt[o])),r=m("div",{class:"buttons pad",role:"group","aria-label":"Move of the chosen agent"},...n);return{element:r,update:()=>{
r.hidden=e.mode==="build";let o=e.selected===null?void 0:e.scene.next[e.selected];t.forEach((s,a)=>{let i=n[a];i.hidden=s>4&&!e.scene.diagonal,i.setAttribute("a\
ria-disabled",String(e.selected===null||e.game.over)),i.setAttribute("aria-pressed",String(o===s))})}}}function ia(e){let t=m("button",{type:"button",title:"Und\
o the last change (Ctrl+Z)",onclick:()=>e.undo()},"Undo");return e.shownBy(()=>t.setAttribute("aria-disabled",String(!e.canUndo))),t}function fn(e,t){let n=e.game.
scene(),r=Qr(n);if(!r)return e.say("Every cell is taken.",!0);if(n[t].length>=Be)return e.say(`${t}: expected at most ${Be}`,!0);let o=t==="pursuers"?n.pursuers.
length:V(n);e.change(Jr(n,t,r))&&(e.selected=o)}function fr(e){let{selected:t}=e;if(t===null)return e.say("Choose an agent to remove.",!0);let n=Ut(e.game.scene(),
t);n.pursuers.length&&n.evaders.length?e.change(n):e.say("A team needs at least one agent.",!0)}function la(e,t,n){let r=Object.keys(e.data.variants),o={Enter:()=>e.step(),Backspace:()=>e.back(),Home:()=>e.restart()," ":()=>e.run(),m:()=>e.mode=e.mode==="a\
ct"?"build":"act",d:kn,"?":t},s={"+":()=>fn(e,"pursuers"),"-":()=>fn(e,"evaders"),Delete:()=>fr(e)};document.addEventListener("keydown",a=>{if(!n()||a.defaultPrevented||
document.querySelector("dialog[open]"))return;let i=a.key.length===1?a.key.toLowerCase():a.key;if((a.ctrlKey||a.metaKey)&&!a.altKey){let u={z:()=>a.shiftKey?e.redo():
e.undo(),y:()=>e.redo()}[i];u&&!ca(a.target)&&(a.preventDefault(),u());return}if(a.altKey||Vl(a.target,i))return;let l=r[Number(i)-1],c=o[i]??(e.mode==="build"?
s[i]:void 0);if(c)c();else if(l)e.change({...e.scene,rules:e.data.variants[l]});else if(e.mode!=="act"||!pr(e,a))return;a.preventDefault()})}var ca=e=>e instanceof
HTMLInputElement&&!["radio","checkbox"].includes(e.type);function Vl(e,t){return ca(e)||e instanceof HTMLSelectElement?!0:e instanceof HTMLInputElement?t===" "||
t.startsWith("Arrow"):e instanceof HTMLButtonElement?t===" "||t==="Enter":e instanceof HTMLElement&&e.classList.contains("story-body")&&t.startsWith("Arrow")}var Yl=[
[["Enter"],"play a step"],[["Backspace"],"take the last step back"],[["Home"],"back to the start"],[["Space"],"run, or stop"],[["N","P"],"choose the next agent,\
 or the one before"],[["↑","→","↓","←"],"the chosen agent moves there next"],[["Q","E","C","Y"],"the same on a diagonal, where the board allows it"],[["\
S"],"the chosen agent stays"],[["1","… 9"],"choose a variant"],[["M"],"change between Move and Build"],[["Ctrl Z","Ctrl Y"],"undo, redo"],[["D"],"light or dar\
k"],[["?"],"these keys"]],Zl=[[["↑","→","↓","←"],"move the cursor on the board"],[["Space"],"draw or erase an obstacle, or choose the agent there"],[["S\
hift ↑"],"carry the agent under the cursor"],[["+","-"],"add a pursuer, an evader"],[["Delete"],"remove the agent under the cursor"]],ua=()=>zs("Keys","",m("d\
iv",{class:"keys-columns"},m("div",{},m("h3",{},"Anywhere"),ur(Yl)),m("div",{},m("h3",{},"On the board, in Build"),ur(Zl),m("h3",{},"With mouse or finger"),m("p",
{},"Move: press an agent and drag it towards a cell beside it, or choose it and press that cell."),m("p",{},"Build: drag agents; draw on free cells to make obst\
acles, on obstacles to erase them."))));function da(e){let t=m("ul",{class:"lines","aria-live":"polite"}),n=m("details",{class:"card perfect"},m("summary",{},m("h2",{},"Perfect play")),t,m("p",{class:"\
small muted"},"A team is one player here. An agent's shares are its part of the joint moves.")),r=0,o=(...a)=>t.replaceChildren(...a.filter(Boolean).map(i=>m("l\
i",{class:"line"},`${i}.`))),s=async()=>{let a=++r;if(!n.open)return;let i=ze(Ge(e.scene,e.scene.rules));if(i)return o(`Not known: ${i}`);let l=await e.solution();
if(a!==r||!l)return;let{game:c,losses:u}=e.game.perfect(l),d=Array.from({length:V(e.scene)},(h,g)=>{let f=c&&nn(c,g);return f?`${ne(e.scene,g)}: ${f}`:""}),p=e.
game.over?"The episode has ended":"Not known: no start on distinct free cells leads to this moment";o(...u.map(h=>`In the last step: ${wt(h)}`),c?`From here: ${tn(
l,c,e.game.length)}`:p,...d)};for(let[a,i]of[[e,"change"],[n,"toggle"]])a.addEventListener(i,()=>{s()});return n}function ma(e){let t=[ql(e),...e.data.fields.map(n=>Jl(e,n)),Ql(e),ec(e)];return e.shownBy(()=>t.forEach(n=>n.update())),m("section",{class:"card rules"},...t.map(
n=>n.element))}var Qe=(e,t)=>{e.stop(),e.change(t)};function ql(e){let t=Object.keys(e.data.variants),n=t.map(o=>m("button",{type:"button",class:"chip",title:e.
data.titles[o],onclick:()=>Qe(e,{...e.scene,rules:e.data.variants[o]})},o)),r=m("p",{class:"muted small variant-title"});return{element:m("div",{class:"variants"},
m("h2",{},"Rules"),m("div",{class:"chips",role:"group","aria-label":"Variant"},...n),r),update:()=>{let o=je(e.scene.rules,e.data.variants);t.forEach((s,a)=>n[a].
setAttribute("aria-pressed",String(s===o))),r.textContent=o?e.data.titles[o]:"Rules of your own"}}}function Jl(e,t){let n=t.values.map(({name:a})=>m("input",{type:"\
radio",name:t.name,value:a,onchange:()=>Qe(e,{...e.scene,rules:Xl(e.scene.rules,t,a)})})),r=t.values.map(({label:a},i)=>m("label",{},n[i],m("span",{},a))),o=m("\
span",{class:"used-mark",title:"This rule decided what happened in the step that is shown"},m("span",{},"decided")),s=m("fieldset",{class:"field",title:t.text},
m("legend",{},t.label,o),m("div",{class:"segments"},...r));return{element:s,update:()=>{let{rules:a}=e.scene;n.forEach(l=>l.checked=l.value===String(a[t.name])),
s.disabled=t.name==="captured_disappear"&&a.capture==="OCCUPATION";let i=Math.min(e.player.step,e.game.length);o.hidden=!un(e.scene,e.game,i).some(l=>l.used.includes(
t.name))||s.disabled}}}function Xl(e,t,n){return{...e,[t.name]:n==="true"?!0:n==="false"?!1:n}}function Ql(e){let t=Object.keys(e.data.variants),r=m("select",{id:"\
compare",onchange:()=>{let o={"":null,present:e.scene.rules}[r.value];Qe(e,{...e.scene,others:o===void 0?e.data.variants[r.value]:o})}},m("option",{value:""},"n\
othing"),m("option",{value:"present"},"the present rules"),m("option",{value:"own",hidden:!0},"own rules"),...t.map(o=>m("option",{value:o},`${o}: ${e.data.titles[o]}`)));
return{element:m("div",{class:"pair"},m("label",{for:"compare"},"Compare with"),r),update:()=>{let{others:o}=e.scene,s=o&&t.find(a=>Nn(o,e.data.variants[a]));r.
value=o?s??"own":"",r.title=o?`Both boards play the same moves: ${Te(e,0)} and ${Te(e,1)}`:""}}}function ec(e){let t=(a,i)=>{let l=m("input",{type:"number",min:1,
max:ke,"aria-label":i,onchange:()=>{let c={rows:e.scene.rows,cols:e.scene.cols,[a]:Math.round(Number(l.value))};c[a]>=1&&c[a]<=ke?tc(e,c.rows,c.cols):e.say(`${a}\
: expected 1 to ${ke}, got ${l.value||"nothing"}`,!0),l.value=String(e.scene[a])}});return l},n=t("rows","Rows"),r=t("cols","Columns"),o=m("input",{type:"checkb\
ox",id:"diagonal",onchange:()=>Qe(e,{...e.game.scene(),diagonal:o.checked,next:e.scene.next.map(a=>typeof a=="number"&&a>4?0:a)})}),s=m("select",{id:"rewards",onchange:()=>Qe(
e,{...e.scene,rewards:e.data.rewards[s.value]})},...Object.keys(e.data.rewards).map(a=>m("option",{value:a},a)),m("option",{value:"own",hidden:!0},"those of the\
 link"));return{element:m("div",{class:"board-settings"},m("div",{class:"pair"},m("span",{},"Board"),m("span",{class:"sides"},n,"×",r),m("label",{class:"sides"},
o,"diagonal")),m("div",{class:"pair"},m("label",{for:"rewards"},"Rewards"),s)),update:()=>{let{scene:a}=e;document.activeElement!==n&&(n.value=String(a.rows)),document.
activeElement!==r&&(r.value=String(a.cols)),o.checked=a.diagonal;let i=JSON.stringify(a.rewards);s.value=Object.keys(e.data.rewards).find(l=>JSON.stringify(e.data.
rewards[l])===i)??"own"}}}function tc(e,t,n){let r=Xr(e.game.scene(),t,n);r.pursuers.length&&r.evaders.length?Qe(e,r):e.say(`No ${r.pursuers.length?"evader":"pu\
rsuer"} would be left on a ${t} × ${n} board.`,!0)}var pa={obstacle:"obstacle",teammate:"teammates",adversary:"adversaries",capture:"capture",end:"end",calm:""};function ha(e){let t=m("h2"),n=m("div",{class:"sto\
ry-body",tabindex:0,role:"region","aria-label":"What happened"}),r=m("div",{class:"heard",role:"status"}),o=m("section",{class:"card story"},t,n,r),s="";return e.
shownBy(()=>{let a=Math.min(e.player.step,e.game.length),i=e.games.map((c,u)=>{let d=un(e.scene,c,a);return{name:e.games.length>1?Te(e,u):"",lines:d,ended:a>c.length}}),
l=JSON.stringify([a,i]);l!==s&&(s=l,t.textContent=a?`Step ${a}`:"Start",n.replaceChildren(...i.map(c=>nc(c,a))),r.textContent=a?`Step ${a}. ${i.map(oc).join(" ")}`:
"")}),o}function nc({name:e,lines:t,ended:n},r){let s=n||!r?m("p",{class:"muted"},n?"The episode had ended.":"Give agents their moves, then play a step."):m("ul",
{class:"lines"},...t.map(rc));return m("div",{class:"story-part"},e&&m("h3",{},e),s)}function rc({kind:e,text:t,turn:n,blame:r,cost:o}){let s=n?`${pa[e]}, turn ${n}`:
pa[e];return m("li",{class:`line line-${e}`},s&&m("span",{class:"tag"},s),m("span",{class:"line-text"},...Ot(t)),r&&m("span",{class:"line-blame muted"},r),o&&m(
"strong",{},o))}var oc=({name:e,lines:t,ended:n})=>[e,...n?["The episode had ended."]:t.map(({text:r,blame:o,cost:s})=>[r,o,s].filter(Boolean).join(" "))].filter(
Boolean).join(" ");function fa(e,t){let n=ua(),r=()=>n.showModal();return la(e,r,t),{element:m("section",{class:"scene","aria-label":"Rules and conflicts"},sa(e),m("div",{class:"l\
ayout"},ma(e),m("section",{class:"card stage","aria-label":"Board"},ra(e),aa(e)),m("div",{class:"side"},ha(e),oa(e),da(e)))),tools:[ia(e),m("button",{type:"butt\
on",title:"Keys (?)","aria-label":"Keys (?)",onclick:r},"?")],dialog:n}}var ga={...Qs,scene:"Rules and conflicts"},ya={games:"You move one agent. Scripts, or policies that evolved, move all others.",scene:"Give agents their moves, p\
redict what happens, and play the step."};async function sc(e){let t=is(),n=await jr(),r=_e(),{store:o,problem:s}=rs(n,t,xt(r)?t.scene:r||t.scene),a=t.play&&new pn(
n,t.play),i="scene",l=fa(o,()=>i==="scene"),c=m("span"),u=Object.keys(ga),d=u.map(g=>m("button",{type:"button",onclick:()=>g==="scene"?p(g):a.begin(g)},ga[g])),
p=g=>{i=g;let f=i==="scene";u.forEach((y,v)=>d[v].setAttribute("aria-pressed",String(y===i)));for(let y of[l.element,...l.tools])y.hidden=!f;a&&(a.element.hidden=
f),c.textContent=f?ya.scene:ya.games,f?a?.view.stop():o.stop(),dt()&&(f?o.dispatchEvent(new Event("change")):history.replaceState(null,"",location.href.split("#")[0]))},
h=g=>xt(g)&&!!a?.follow(new URLSearchParams(g));a?.addEventListener("game",()=>p(a.game)),e.classList.add("playground"),e.replaceChildren(Yr("Playground",c,...l.
tools),m("nav",{class:"tabs buttons","aria-label":"What to play",hidden:!a},...d),m("main",{},a&&a.element,l.element),m("footer",{class:"muted small"},`${t.title}\
 · matrixworld ${t.version}`),l.dialog),document.addEventListener("keydown",g=>i!=="scene"&&a.view.key(g)&&g.preventDefault()),dt()&&as(o,()=>i==="scene",()=>p(
"scene")),window.addEventListener("hashchange",()=>h(_e())),h(r)||(a&&!t.scene&&(!r||xt(r))?a.begin("escape"):p("scene")),s&&o.say(s,!0),Object.assign(window,{playground:o,
matrixworldPlay:a?.view})}Hr(sc(document.getElementById("page")));})();
