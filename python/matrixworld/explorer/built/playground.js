/* built from web/ by "npm run build"; sources 2a1fae05abaff1e2366678a422ba5c37c6f4bd927ab4e626582e6e45a0303b3d */
"use strict";(()=>{var dr={SIMULTANEOUS:0,SWARM_TURNS:1,AGENT_TURNS:2},tt={DISAPPEAR:0,REACH:1,BOUNCE:2},mr={OCCUPATION:0,SURROUND:1},pr={FAULT:0,INVOLVED:1};var nt=["obstacle","teammate","adversary"],pn=["vertex","edge","chain"],hr=["turn","kind","form","first","second","row","col","at_fault","held","doomed"],hn=["p\
ursuer_{number}","evader_{number}"],fr={obstacle:"{first} ran into the obstacle or border at {cell}",vertex:"{first} and {second} both headed for {cell}",edge:"\
{first} and {second} meant to swap, {first} to {cell}",chain:"{first} headed for {cell}, where {second} had to stay"},rt={"both held":"both bounce","both doomed":"\
both disappear",held:"{agent} bounces",doomed:"{agent} disappears",none:"nobody is stopped"},gr="{event}: {outcome}",fn={random:"any action, all equally likely",
still:"always stays",chaser:"moves to where the nearest adversary in view is nearest",fleer:"moves to where the nearest adversary in view is farthest","clumsy-c\
haser":"a chaser that takes any action in half of the steps",hunter:"a chaser of the nearest adversary in view to which no teammate in view is nearer",surrounder:"\
a chaser of the nearest free cell beside an adversary without a teammate","clumsy-fleer":"a fleer that takes any action in half of the steps",dodger:"moves to w\
here all adversaries in view together are farthest","team-surrounder":"shares the free cells beside adversaries with its teammates, and searches","careful-rando\
m":"as random, but takes only moves that right of way allows","careful-chaser":"as chaser, but takes only moves that right of way allows","careful-fleer":"as fl\
eer, but takes only moves that right of way allows","careful-clumsy-chaser":"as clumsy-chaser, but takes only moves that right of way allows","careful-hunter":"\
as hunter, but takes only moves that right of way allows","careful-surrounder":"as surrounder, but takes only moves that right of way allows","careful-clumsy-fl\
eer":"as clumsy-fleer, but takes only moves that right of way allows","careful-dodger":"as dodger, but takes only moves that right of way allows","careful-team-\
surrounder":"as team-surrounder, but takes only moves that right of way allows"},yr={adversary:"distance to the nearest adversary (0 to 2, in half views)",pressure:"\
sum over adversaries of 1 / (1 + moves)^2 (0 or more)",unclaimed:"distance to the nearest adversary to which no teammate is nearer than the agent is now; withou\
t one, to the nearest adversary (0 to 2, in half views)",open_side:"distance to the nearest cell beside an adversary that holds no obstacle and no teammate (0 t\
o 2, in half views)",teammate:"distance to the nearest teammate (0 to 2, in half views)",exits:"share of the cells around that are no obstacle (0 to 1)",room:"d\
istance to the nearest obstacle to the north, east, south or west (0 to 1, in half views)",must_yield:"1 if right of way forbids the move (0 to 1)",ahead:"1 if \
it is the direction that the agent draws for each 12 steps (0 to 1)",search:"1 if it leads on along the way on which an agent of team-surrounder searches the gr\
id (0 to 1)"},vr={free:".GS",blocked:"#@OTW"};var Le=1+hr.length;function ot(e,t){return e.replace(/\{(\w+)\}/g,(n,r)=>String(t[r]))}function Q(e,t){return e<t?ot(hn[0],{number:e}):ot(hn[1],{number:e-t})}function ua(e,t){
let[n,r,o,s,a,i,l,...c]=Array.from(e),u=a<0?[s]:[s,a],[m,p,h]=c.map(v=>u.filter((x,b)=>v>>b&1)),f=u.map(v=>Q(v,t)),g=ot(fr[a<0?"obstacle":pn[o]],{first:f[0],second:f[f.
length-1],cell:`(${i}, ${l})`}),y=ot(gr,{event:g,outcome:da(u.length,p,h,t)});return{kind:nt[r],form:pn[o],agents:u,cell:[i,l],at_fault:m,held:p,doomed:h,turn:n,
text:y}}function da(e,t,n,r){if(e===2&&t.length===2)return rt["both held"];if(e===2&&n.length===2)return rt["both doomed"];let o=s=>a=>ot(rt[s],{agent:Q(a,r)});
return[...t.map(o("held")),...n.map(o("doomed"))].join(", ")||rt.none}function Nt(e,t){let n=[];for(let r=0;r<e.length;r+=Le)n.push(ua(e.subarray(r+1,r+Le),t));
return n}var K=class extends Error{name="EngineError"};function _(e,t,n){let r=typeof n=="string"?`'${n}'`:typeof n=="object"?JSON.stringify(n):String(n);return new K(`${e}\
: expected ${t}, got ${r}`)}var Ie=class{bytes;constructor(t){this.bytes=t}},xr=0,yn=[Uint8Array,Uint8Array,Int32Array,BigInt64Array,BigUint64Array,Float32Array,Float64Array],br=4,wr=4,ma=new TextEncoder,
pa=new TextDecoder;function ha(e){for(let t=yn.length-1;t>xr;--t)if(e instanceof yn[t])return t;throw new TypeError("array: expected a typed array of the engine\
's numbers, got another")}function gn(e){return new Uint8Array(e.buffer,e.byteOffset,e.byteLength)}function fa(e){return ma.encode(`${e}\0`)}var vn=class{engine;addresses=[];constructor(t){
this.engine=t}copy(t){let n=this.engine._malloc(Math.max(t.length,1));if(n===0)throw new K("memory: expected room for the arguments, got none");return this.addresses.
push(n),this.engine.HEAPU8.set(t,n),n}text(t){return this.copy(fa(t))}arrays(t){let n=Object.entries(t),r=n.flatMap(([s,a])=>{let i=a instanceof Ie,l=i?a.bytes:
a;return[this.text(s),i?xr:ha(l),l.length,this.copy(gn(l))]}),o=this.copy(gn(Int32Array.from(r)));return this.copy(gn(Int32Array.of(n.length,o)))}free(){for(let t of this.
addresses)this.engine._free(t)}};function Sr(e,t){let n=e.HEAPU8;return pa.decode(n.subarray(t,n.indexOf(0,t)))}function $e(e){let t=new Int32Array(e.HEAPU8.buffer),
n=e._last_outputs()/br,r=t[n+1]/br,o={};for(let s=r;s<r+t[n]*wr;s+=wr){let a=yn[t[s+1]],i=t[s+2]*a.BYTES_PER_ELEMENT,l=t[s+3];o[Sr(e,t[s])]=new a(e.HEAPU8.slice(
l,l+i).buffer)}return o}function fe(e,t){let n=new vn(e);try{let r=t(n);if(r===0)throw new K(Sr(e,e._last_error()));return r}finally{n.free()}}var ga=2**31-1,Ar=["none","gru"],ya=2n**64n-1n,va=34028234663852886e22;function ee(e,t){if(typeof t!="number"||!Number.isInteger(t)||Math.abs(t)>ga)throw _(e,"a\
n integer",t);return Int32Array.of(t)}function Pt(e,t){if(typeof t!="boolean")throw _(e,"true or false",t);return new Ie(Uint8Array.of(Number(t)))}function Se(e,t,n){
let r=typeof t=="string"&&Object.hasOwn(n,t)?n[t]:void 0;if(r===void 0)throw _(e,`one of ${Object.keys(n).join(", ")}`,t);return Int32Array.of(r)}function bn(e,t){
if(typeof t!="number"||!(Math.abs(t)<=va))throw _(e,"a finite number",t);return t}function st(e,t){let r=typeof t=="bigint"||typeof t=="number"&&Number.isSafeInteger(
t)?BigInt(t):-1n;if(r<0n||r>ya)throw _(e,"an integer from 0 to 2^64 - 1",t);return BigUint64Array.of(r)}function ba(e){return{"rules.interaction":Se("interactio\
n",e.interaction,dr),"rules.obstacle":Se("obstacle",e.obstacle,tt),"rules.teammate":Se("teammate",e.teammate,tt),"rules.evader":Se("evader",e.evader,tt),"rules.\
pursuer":Se("pursuer",e.pursuer,tt),"rules.capture":Se("capture",e.capture,mr),"rules.captured_disappear":Pt("captured_disappear",e.captured_disappear)}}function Tr(e,t){
let n=typeof t=="number"?[t,t,t]:t;if(!Array.isArray(n)||n.length!==3)throw _(e,"1 or 3 numbers",t);return Float32Array.from(n,r=>bn(e,r))}function wa(e){let t=(n,r)=>Float32Array.
of(bn(n,e[n]),bn(r,e[r]));return{"rewards.capture":t("pursuer_capture","evader_capture"),"rewards.neighbor":t("pursuer_neighbor","evader_neighbor"),"rewards.ste\
p":t("pursuer_step","evader_step"),"rewards.pursuer_collide":Tr("pursuer_collide",e.pursuer_collide),"rewards.evader_collide":Tr("evader_collide",e.evader_collide),
"rewards.blame":Se("blame",e.blame,pr),"rewards.capture_repeats":Pt("capture_repeats",e.capture_repeats)}}function Er(e){if(e===void 0||typeof e=="number")return new Uint8Array(
0);if(e instanceof Uint8Array)return e;let{free:t,blocked:n}=vr;for(let[r,o]of e.entries()){if(o.length!==e[0]?.length)throw _(`map, row ${r}`,`${e[0]?.length} \
cells as in row 0`,o.length);let s=[...o].find(a=>!t.includes(a)&&!n.includes(a));if(s)throw _(`map, row ${r}`,`'${t}' (free) or '${n}' (obstacle)`,s)}return Uint8Array.
from([...e.join("")],r=>Number(n.includes(r)))}function kr(e,t){if(!Array.isArray(e))return;let n=[e.length,e[0]?.length??0];if(!(n[0]===t.rows&&n[1]===t.cols))
throw _("obstacle map",`shape (${t.rows}, ${t.cols}), the rows and cols`,n)}function Ue(e){kr(e.obstacles,e);let t=typeof e.obstacles=="number"?e.obstacles:0;return{
...ba(e.rules),...wa(e.rewards),rows:ee("rows",e.rows),cols:ee("cols",e.cols),n_pursuers:ee("n_pursuers",e.n_pursuers),n_evaders:ee("n_evaders",e.n_evaders),fov:ee(
"fov",e.fov),diagonal:Pt("diagonal",e.diagonal),max_steps:ee("max_steps",e.max_steps),density:Float64Array.of(t),map:Er(e.obstacles)}}function Cr(e,t){return Int32Array.
from((t??[]).flat(),n=>ee(e,n)[0])}function Or(e,t){return kr(e.obstacles,t),{seed:st("seed",e.seed??0n),episode:st("episode",e.episode??0),pursuers:Cr("pursuer\
s",e.pursuers),evaders:Cr("evaders",e.evaders),map:Er(e.obstacles)}}function Lt(e){return{actions:Int32Array.from(e,t=>ee("actions",t)[0])}}var Mr=Object.keys(yr);
function wn(e){let t=Mr.indexOf(e);if(t<0)throw _("inputs",`names of ${Mr.join(", ")}`,e);return t}function Ae(e){if(typeof e=="string"){if(!Object.hasOwn(fn,e))
throw _("policy",`one of ${Object.keys(fn).join(", ")}`,e);return{script:new TextEncoder().encode(e)}}if(e.kind!=="cells")return{inputs:Int32Array.from(e.inputs,
t=>wn(t)),hidden:Int32Array.from(e.kind==="rating"?e.hidden:[],t=>ee("hidden",t)[0]),length:ee("length",e.kind==="program"?e.length:0),mask:new TextEncoder().encode(
e.mask),genome:e.genome};if(e.activation!=="relu"&&e.activation!=="tanh")throw _("activation","'relu' or 'tanh'",e.activation);if(!Ar.includes(e.memory))throw _(
"memory",`one of ${Ar.join(", ")}`,e.memory);return{hidden:Int32Array.from(e.hidden,t=>ee("hidden",t)[0]),activation:new TextEncoder().encode(e.activation),sampled:Pt(
"sampled",e.sampled),memory:new TextEncoder().encode(e.memory),genome:e.genome}}var xa=["first_turn","terminated","truncated"];function Rr(e){let t={...e};for(let n of xa)
t[n]=new Ie(e[n]);return t}var _r="statistics.",It=class{config;seed;episode;n_agents;statistics;first_conflict;constructor(t,n,r,o){this.config=t,this.seed=n,this.episode=r,this.n_agents=
t.n_pursuers+t.n_evaders,this.statistics=Aa(Nr(o)),Object.assign(this,o),this.first_conflict=Sa(this.conflict_table,this.length)}get length(){return this.actions.
length/this.n_agents}conflicts(t){this.check(t);let n=this.first_conflict[t],r=this.first_conflict[t+1],o=this.conflict_table.subarray(n*Le,r*Le);return Nt(o,this.
config.n_pursuers)}seek(t,n,r){this.check(n),(!(t.seed===this.seed&&t.episode===BigInt(this.episode))||t.turn!==0||t.steps>n)&&t.reset({seed:this.seed,episode:this.
episode});for(let s=t.steps;s<n;++s){let a=this.actions.subarray(s*this.n_agents,(s+1)*this.n_agents);r?t.replay(a,{pursuer:r.pursuers,evader:r.evaders}):t.step(
a)}}check(t){if(!(Number.isInteger(t)&&t>=0&&t<=this.length))throw _("step",`0 to ${this.length}`,t)}};function Sa(e,t){let n=new Int32Array(t+2);for(let r=0;r<
e.length;r+=Le)++n[e[r]+1];for(let r=1;r<n.length;++r)n[r]+=n[r-1];return n}function Aa(e){let t=["capture_rate","ever_capture_rate","captured_fraction","length"];
return Object.fromEntries(Object.entries(e).map(([n,r])=>[n,t.includes(n)?Number(r[0]):r]))}var Nr=e=>Object.fromEntries(Object.entries(e).flatMap(([t,n])=>t.startsWith(
_r)?[[t.slice(_r.length),n]]:[]));function Pr(e,t,n,r){let o=[Ue(n.config),Ae(n.pursuers),Ae(n.evaders),r];return fe(e,s=>{let[a,i,l,c]=o.map(u=>s.arrays(u));return e[t](
a,i,l,c)}),$e(e)}function Lr(e,t,n,r){let o={seed:st("seed",n),episode:st("episode",r)};return new It(t.config,n,r,Pr(e,"_play_match",t,o))}function Ir(e,t,n,r){
if(!Number.isInteger(r)||r<1)throw _("n_episodes","at least 1",r);let o=Pr(e,"_play_rollout",t,{...n,n_episodes:Int32Array.of(r)});return Nr(o)}var Ta=7e6,Ca=new FinalizationRegistry(([e,t])=>e._states_free(t));function Ma({rules:e,rows:t,cols:n,obstacles:r,diagonal:o,n_pursuers:s,n_evaders:a}){let i=typeof r==
"number"||e.obstacle==="REACH"?0:r.join("").split("#").length-1,l=t*n-i,c=[e.obstacle,e.teammate,e.pursuer].includes("DISAPPEAR"),u=e.capture==="SURROUND"||e.evader===
"REACH",m=e.interaction==="AGENT_TURNS",p=(g,y)=>Array.from({length:y},(v,x)=>m?g:(g+x)/(x+1)).reduce((v,x)=>v*x,1),h=p(l+Number(c),s)*p(l*(1+Number(u))+2,a);return{
SIMULTANEOUS:[s+a],SWARM_TURNS:[s,a],AGENT_TURNS:Array(s+a).fill(1)}[e.interaction].reduce((g,y)=>g+h*(o?9:5)**y,0)}function ze(e){return typeof e.obstacles=="n\
umber"&&e.obstacles>0?"obstacles are drawn anew in each episode":Ma(e)>Ta?"the world is too large to be solved on the page":""}var xn=class{value;teams;matrix;n_actions;constructor(t,n){
let{matrix:r,rows:o,cols:s,value:a,agents:i}=n,[l,c]=t.actors,u=Array.from(i).filter(p=>l<=p&&p<c),m=p=>p<t.config.n_pursuers;this.value=a[0],this.matrix=r,this.
n_actions=t.n_actions,this.teams=[{agents:u.filter(m),play:o},{agents:u.filter(p=>!m(p)),play:s}]}marginal(t){let n=this.teams.find(({agents:s})=>s.includes(t));
if(!n)return null;let r=this.n_actions**(n.agents.length-1-n.agents.indexOf(t)),o=Array(this.n_actions).fill(0);return n.play.forEach((s,a)=>o[Math.floor(a/r)%this.
n_actions]+=s),o}lost(t){let[n,r]=this.teams.map(({agents:l})=>l.reduce((c,u)=>c*this.n_actions+t[u],0)),[o,s]=this.teams.map(({play:l})=>l),a=s.reduce((l,c,u)=>l+
c*this.matrix[n*s.length+u],0),i=o.reduce((l,c,u)=>l+c*this.matrix[u*s.length+r],0);return[Math.max(0,this.value-a),Math.max(0,i-this.value)]}},Sn=60,at=class{config;payoff;engine;states;n_turns;values;constructor(t,n,r){
this.engine=t,this.config=n,this.payoff=r,this.states=fe(t,i=>t._states_new(i.arrays(Ue(n)))),Ca.register(this,[t,this.states]);let o={SIMULTANEOUS:1,SWARM_TURNS:2,
AGENT_TURNS:n.n_pursuers+n.n_evaders};this.n_turns=o[n.rules.interaction];let{payoffs:s}=this.call(()=>t._states_payoffs(this.states)),a=s;this.values=[[r==="ca\
pture-rate"?a:a.fill(0)]]}goBack(){let t=this.values.at(-1)[0],n=[];for(let o=this.n_turns-1;o>=0;o--){let s=n[o+1]??t;n[o]=this.backup(o,{next:s})}this.payoff===
"capture-time"&&(n[0]=n[0].map((o,s)=>s===this.config.n_evaders?0:o-1)),this.values.push(n);let r=this.payoff==="capture-rate"?this.config.max_steps:Math.min(this.
config.max_steps,Sn);return this.values.length<=r&&n[0].some((o,s)=>o!==t[s])}backup(t,n){return this.call(r=>this.engine._states_backup(this.states,t,r.arrays(
n))).values}game(t){let n=this.config.max_steps-t.steps,{turn:r}=t,o=r+1===this.n_turns,s=n>0?this.values[Math.min(n-Number(o),this.values.length-1)]?.[o?0:r+1]:
void 0;if(!s)return null;let a=this.call(i=>this.engine._states_game(this.states,t.address,i.arrays({next:s})));return a.agents.length?new xn(t,a):null}call(t){
return fe(this.engine,t),$e(this.engine)}};var $r=new FinalizationRegistry(([e,t])=>e._world_free(t)),it=class{config;n_agents;n_actions;engine;at;freed=!1;constructor(t,n){this.engine=t,this.config=n,this.
n_agents=n.n_pursuers+n.n_evaders,this.n_actions=n.diagonal?9:5,this.at=fe(t,r=>t._world_new(r.arrays(Ue(n)))),$r.register(this,[t,this.at],this)}free(){this.freed||
(this.freed=!0,$r.unregister(this),this.engine._world_free(this.at))}get address(){if(this.freed)throw _("world","one that is in use","one that was freed");return this.
at}reset(t={}){let n=Or(t,this.config);this.call(r=>this.engine._world_reset(this.address,r.arrays(n)))}step(t){let n=Lt(t);this.call(r=>this.engine._world_step(
this.address,r.arrays(n)))}playTurn(t){let n=Lt(t);this.call(r=>this.engine._world_play_turn(this.address,r.arrays(n)))}decide(t,n,r){let{n_pursuers:o}=this.config,
s={pursuer:[0,o],evader:[o,this.n_agents]},[a,i]=typeof n=="string"?s[n]:n;if(r.length!==this.n_agents)throw _("actions",String(this.n_agents),r.length);let l=[
Ae(t),Lt(r)],{actions:c}=this.call(u=>this.engine._world_decide(this.address,u.arrays(l[0]),a,i,u.arrays(l[1])));return Uint8Array.from(c)}replay(t,n){let r=s=>typeof s!=
"string"&&s.kind==="cells"&&s.memory!=="none";if(!r(n.pursuer)&&!r(n.evader))return this.step(t);let{n_pursuers:o}=this.config;for(let s=this.n_turns;s>0;--s){let[
a,i]=this.actors;a<o&&this.decide(n.pursuer,[a,Math.min(i,o)],t),i>o&&this.decide(n.evader,[Math.max(a,o),i],t),this.playTurn(t)}}get n_turns(){return this.turnNumbers()[1]}get turn(){
return this.turnNumbers()[0]}get actors(){let[,,t,n]=this.turnNumbers();return[t,n]}turnNumbers(){return this.call(()=>this.engine._world_turn(this.address)).turn}get steps(){
return this.read("steps")[0]}get seed(){return this.read("seed")[0]}get episode(){return this.read("episode")[0]}get over(){return this.read("terminated")[0]===
1||this.read("truncated")[0]===1}read(t){return this.call(n=>this.engine._world_read(this.address,n.text(t)))[t]}view(t){let n=3*this.config.fov**2;return this.
read("views").slice(t*n,(t+1)*n)}map(){return this.read("state").slice(2*this.config.rows*this.config.cols)}conflicts(){return Nt(this.conflictTable(),this.config.
n_pursuers)}conflictTable(){return this.call(()=>this.engine._world_conflicts(this.address)).conflict_table}answer(t,n){let r=Ae(t),{logits:o,memory:s}=this.call(
l=>this.engine._world_logits(this.address,l.arrays(r),n)),a=o,i=this.decide(t,[n,n+1],new Uint8Array(this.n_agents))[n];return{logits:a,probabilities:Ea(a),action:i,
memory:s}}rate(t,n){let r=Ae(t),{ratings:o,refused:s}=this.call(c=>this.engine._world_rate(this.address,c.arrays(r),n)),a=this.read("inputs"),i=a.length/this.n_agents/
this.n_actions,l=c=>Float32Array.from({length:this.n_actions},(u,m)=>a[(n*this.n_actions+m)*i+c]);return{inputs:t.inputs.map(c=>l(wn(c))),ratings:o,refused:s}}snapshot(){
return this.call(()=>this.engine._world_snapshot(this.address))}restore(t){let n=Rr(t);this.call(r=>this.engine._world_restore(this.address,r.arrays(n)))}call(t){
return fe(this.engine,t),$e(this.engine)}};function Ea(e){let t=Math.max(...e),n=Array.from(e,o=>Math.exp(o-t)),r=n.reduce((o,s)=>o+s,0);return Float32Array.from(
n,o=>o/r)}var An=class{compiled;constructor(t){this.compiled=t}world(t){return new it(this.compiled,t)}solution(t,n="capture-rate"){return new at(this.compiled,t,n)}match(t,n,r,o,s=0){
return Lr(this.compiled,{config:t,pursuers:n,evaders:r},o,s)}rollouts(t,n,r,o,s){return Ir(this.compiled,{config:t,pursuers:n,evaders:r},o,s)}},Ur;function zr(e=globalThis.
matrixworldEngine){return Ur??=ka(e),Ur}async function ka(e){if(!e)throw new Error("matrixworldEngine: expected the script engine.js before this one, got none");
let t=Uint8Array.from(atob(e.binary),n=>n.charCodeAt(0));return new An(await e({wasmBinary:t}))}var Oa="http://www.w3.org/2000/svg";function d(e,t={},...n){return Wr(document.createElement(e),t,n)}function Te(e,t={},...n){return Wr(document.createElementNS(
Oa,e),t,n)}function Wr(e,t,n){for(let[o,s]of Object.entries(t))s==null||s===!1||(typeof s=="function"?e.addEventListener(o.slice(2),s):e.setAttribute(o,s===!0?"":
String(s)));let r=n.filter(o=>o!=null&&o!==!1);return e.append(...r.map(o=>typeof o=="number"?String(o):o)),e}function lt(e,t){let n=d("select",{onchange:()=>t(
n.value)},...e.map(([r,o])=>d("option",{value:r},o)));return n}async function Dr(e){try{await e}catch(t){let n=document.querySelector("#page, main")??document.body;
throw n.querySelector(".absent")?.remove(),n.prepend(d("p",{class:"card problem",role:"alert"},t instanceof WebAssembly.CompileError||/WebAssembly/.test(String(
t))?"This page plays by WebAssembly, which is forbidden where it lies ('wasm-unsafe-eval' is missing in the content policy): save the file, and open it from you\
r disk.":`The page could not start: ${String(t)}`)),t}finally{document.body.dataset.ready="true"}}var ct=()=>["file:","http:","https:"].includes(location.protocol);var Br=()=>document.documentElement.dataset.theme==="dark";function ut(e){document.documentElement.dataset.theme=e?"dark":"light"}var Tn=()=>ut(!Br());if(typeof document<
"u"){let e=matchMedia("(prefers-color-scheme: dark)");e.addEventListener("change",()=>ut(e.matches)),ut(e.matches);let t=!1;addEventListener("beforeprint",()=>{
t=Br(),ut(!1)}),addEventListener("afterprint",()=>ut(t))}function Fr(){return d("button",{type:"button",title:"Light or dark (D)","aria-label":"Light or dark",onclick:Tn},
"◐")}var jr=(e,t,...n)=>d("header",{class:"top"},d("div",{},d("h1",{},e),t?d("p",{class:"lead"},t):null),d("div",{class:"tools"},...n,Fr()));var B=["stay","north","east","south","west","northeast","southeast","southwest","northwest"];var ge="champion",Ce=0,Me=64,We=100,De=300,Cn=e=>({cell:e,gone:!1,captured:!1,everCaptured:!1}),te=e=>[...e.pursuers,...e.evaders],V=e=>e.pursuers.length+e.evaders.
length,Mn=(e,t)=>t<e.pursuers.length?"pursuers":"evaders",ne=(e,t)=>Q(t,e.pursuers.length),En=(e,t)=>Object.keys(e).every(n=>e[n]===t[n]);function Be(e,t){return Object.
keys(t).find(n=>En(t[n],e))??null}function Ra(e,t,n){let r=new Set(e);return Array.from({length:t},(o,s)=>Array.from({length:n},(a,i)=>r.has(s*n+i)?"#":".").join(
""))}function _a(e,t,n){let r=e.filter(o=>o!==t);return n?[...r,t].sort((o,s)=>o-s):r}function Fe(e,t){let{rows:n,cols:r,fov:o,diagonal:s,rewards:a}=e;return{rules:t,
rows:n,cols:r,n_pursuers:e.pursuers.length,n_evaders:e.evaders.length,fov:o,diagonal:s,max_steps:e.maxSteps,obstacles:Ra(e.walls,n,r),rewards:a}}var $t=(e,t,n)=>({
...e,next:e.next.map((r,o)=>o===t?n:r)}),Gr=e=>({...e,played:[...e.played,e.next],next:e.next.map(t=>typeof t=="number"?Ce:t)}),Hr=e=>({...e,played:e.played.slice(
0,-1),next:e.played.at(-1)??e.next});function kn(e,t,n){let r=(o,s)=>o.map((a,i)=>i===s?{...a,cell:n}:a);return{...e,pursuers:r(e.pursuers,t),evaders:r(e.evaders,
t-e.pursuers.length)}}function Kr(e,t,n){let r=t==="pursuers"?e.pursuers.length:V(e);return{...e,[t]:[...e[t],Cn(n)],next:[...e.next.slice(0,r),Ce,...e.next.slice(
r)],ended:!1}}function Ut(e,t){let n=Mn(e,t),r=n==="pursuers"?t:t-e.pursuers.length;return{...e,[n]:e[n].filter((o,s)=>s!==r),next:e.next.filter((o,s)=>s!==t)}}
var On=(e,[t,n],r)=>({...e,walls:_a(e.walls,t*e.cols+n,r)});function Vr(e,t,n){let r=([s,a])=>s<t&&a<n,o=te(e).map(({cell:s})=>r(s));return{...e,rows:t,cols:n,walls:e.
walls.map(s=>[Math.floor(s/e.cols),s%e.cols]).filter(r).map(([s,a])=>s*n+a),pursuers:e.pursuers.filter((s,a)=>o[a]),evaders:e.evaders.filter((s,a)=>o[e.pursuers.
length+a]),next:e.next.filter((s,a)=>o[a])}}function ye(e,[t,n]){let r=te(e).findIndex(({cell:o,gone:s})=>!s&&o[0]===t&&o[1]===n);return r<0?null:r}var ve=(e,[t,
n])=>e.walls.includes(t*e.cols+n);function Yr(e){let t=Array.from({length:e.rows*e.cols},(o,s)=>[Math.floor(s/e.cols),s%e.cols]),n=([o,s])=>Math.abs(o-(e.rows-1)/
2)+Math.abs(s-(e.cols-1)/2),r=t.filter(o=>ye(e,o)===null&&!ve(e,o));return r.length?r.reduce((o,s)=>n(s)<n(o)?s:o):null}var dt=class extends Error{},Ee="_",no="n",Zr=2n**64n-1n,qr=2e4,Jr=40,ke={fov:11,maxSteps:500,rewards:"paper"},Rn=["rules","others","rewards","size","diagonal",
"fov","limit","seed","ended","walls","pursuers","evaders","played","next"];function N(e,t,n){let r=n.length>Jr?`${n.slice(0,Jr)}…`:n;throw new dt(`${e}: expec\
ted ${t}, got "${r}"`)}function Nn(e,t){let n=i=>i.map(l=>Pa(l,t)).join(""),r=i=>`${Math.floor(i/e.cols)}.${i%e.cols}`,o=Na(e.rewards,t),s=[e.seed,e.episode,e.steps].
join("."),a={rules:Qr(e.rules,t),others:e.others?Qr(e.others,t):"",rewards:o===ke.rewards?"":o,size:`${e.rows}x${e.cols}`,diagonal:e.diagonal?"1":"",fov:e.fov===
ke.fov?"":String(e.fov),limit:e.maxSteps===ke.maxSteps?"":String(e.maxSteps),seed:s==="0.0.0"?"":s,ended:e.ended?"1":"",walls:e.walls.map(r).join(Ee),pursuers:e.
pursuers.map(Xr).join(Ee),evaders:e.evaders.map(Xr).join(Ee),played:e.played.map(n).join(Ee),next:e.next.every(i=>i===Ce)?"":n(e.next)};return Rn.filter(i=>a[i]).
map(i=>`${i}=${a[i]}`).join("&")}function Xr({cell:e,gone:t,captured:n,everCaptured:r}){let o=n?"c":r?"e":"";return`${e[0]}.${e[1]}${o}${t?"x":""}`}function Qr(e,t){
let n=t.fields.map(({name:r})=>String(e[r]).toLowerCase());return Be(e,t.variants)??n.join(".")}function Na(e,t){let n=JSON.stringify(e);return Object.keys(t.rewards).
find(o=>JSON.stringify(t.rewards[o])===n)??Object.values(e).map(o=>String(o)).join(Ee)}function Pa(e,t){if(typeof e=="number")return String(e);if(e===ge)return no;
let n=t.scripts.findIndex(({name:r})=>r===e);return String.fromCharCode(97+n)}function mt(e,t){e.length>qr&&N("link",`at most ${qr} characters`,`${e.length} cha\
racters`);let n=La(e),r=(p,h="")=>n.get(p)??h,o=to("rules",r("rules"),t),[s,a]=Ia(r("size")),i=p=>_n(r(p)).map(h=>$a(p,h,s,a)),[l,c,u]=Da(r("seed","0.0.0")),m={
rules:o,others:n.has("others")?to("others",r("others"),t):null,rewards:za(r("rewards",ke.rewards),t),rows:s,cols:a,seed:l,episode:c,steps:u,diagonal:eo("diagona\
l",r("diagonal","0")),fov:zt("fov",r("fov",String(ke.fov)),1,255),maxSteps:zt("limit",r("limit",String(ke.maxSteps)),1,2**31-1),ended:eo("ended",r("ended","0")),
walls:Ua(r("walls"),s,a),pursuers:i("pursuers"),evaders:i("evaders"),played:[],next:[]};return Ba(m),Fa(m,_n(r("played")),r("next"),t)}function La(e){let t=new Map;
for(let n of e.replace(/^#/,"").split("&").filter(Boolean)){let[r,o]=n.includes("=")?[n.slice(0,n.indexOf("=")),n.slice(n.indexOf("=")+1)]:[n,""];Rn.includes(r)||
N("link",`parts ${Rn.join(", ")}`,r),t.has(r)&&N(r,"it once","it twice"),t.set(r,o)}return t}var _n=e=>e?e.split(Ee):[];function zt(e,t,n,r){let o=/^\d{1,10}$/.
test(t)?Number(t):NaN;return o>=n&&o<=r||N(e,`a number from ${n} to ${r}`,t),o}function eo(e,t){return t!=="0"&&t!=="1"&&N(e,"0 or 1",t),t==="1"}function Ia(e){
let[t,n,...r]=e.split("x");return(t===void 0||n===void 0||r.length)&&N("size","rows and columns, such as 4x6",e),[zt("size",t,1,Me),zt("size",n,1,Me)]}function ro(e,t,n,r){
let o=/^(\d{1,4})\.(\d{1,4})$/.exec(t),s=[Number(o?.[1]),Number(o?.[2])];return(!o||s[0]>=n||s[1]>=r)&&N(e,`cells of a ${n} x ${r} grid, such as 0.2`,t),s}function $a(e,t,n,r){
let o=/^(.*?)([ce]?)(x?)$/.exec(t),s=ro(e,o[1],n,r);return e==="pursuers"&&o[2]&&N(e,"no captured pursuer",t),{cell:s,gone:o[3]==="x",captured:o[2]==="c",everCaptured:o[2]!==
""}}function Ua(e,t,n){let r=_n(e).map(o=>{let[s,a]=ro("walls",o,t,n);return s*n+a});return[...new Set(r)].sort((o,s)=>o-s)}function to(e,t,n){let r=Object.hasOwn(
n.variants,t)?n.variants[t]:void 0;if(r)return r;let o=t.split("."),s=`${Object.keys(n.variants).join(", ")} or ${n.fields.length} values joined by "."`;o.length!==
n.fields.length&&N(e,s,t);let a=n.fields.map(({name:i,values:l},c)=>{let u=l.find(m=>m.name.toLowerCase()===o[c])?.name;return u===void 0&&N(`${e}, ${i}`,l.map(
m=>m.name.toLowerCase()).join(" or "),o[c]),[i,u==="true"?!0:u==="false"?!1:u]});return Object.fromEntries(a)}function za(e,t){if(Object.hasOwn(t.rewards,e))return t.
rewards[e];let n=Object.entries(t.rewards[ke.rewards]),r=e.split(Ee);return r.length!==n.length&&N("rewards",`${Object.keys(t.rewards).join(", ")} or ${n.length}\
 values`,e),Object.fromEntries(n.map(([o,s],a)=>[o,Wa(o,r[a],s)]))}function Wa(e,t,n){if(e==="blame"&&(t==="FAULT"||t==="INVOLVED"))return t;if(typeof n=="boole\
an"&&(t==="true"||t==="false"))return t==="true";let r=t.split(",").map(a=>/^-?[\d.]+(e[+-]?\d+)?$/i.test(a)?Number(a):NaN),o=e.endsWith("_collide")?[1,3]:[1];return(typeof n!=
"number"||!o.includes(r.length)||!r.every(a=>Math.abs(a)<34e37))&&N(`rewards, ${e}`,`a value like ${n}`,t),r.length===1?r[0]:r}function Da(e){let t=/^(\d{1,20})\.(\d{1,20})\.(\d{1,9})$/.
exec(e);if(!t)return N("seed","seed.episode.steps, such as 0.0.0",e);let n=BigInt(t[1]),r=BigInt(t[2]);return(n>Zr||r>Zr)&&N("seed","numbers below 2^64",e),[n,r,
Number(t[3])]}function Ba(e){for(let t of["pursuers","evaders"]){let n=e[t].length;(n<1||n>We)&&N(t,`1 to ${We} agents`,`${n}`)}e.fov%2===0&&N("fov","an odd num\
ber",String(e.fov)),e.steps>e.maxSteps&&N("seed",`at most ${e.maxSteps} steps`,String(e.steps))}function Fa(e,t,n,r){let o=te(e).length;t.length>De&&N("played",
`at most ${De} steps`,`${t.length} steps`);let s=a=>i=>(i.length!==o&&N(a,`${o} characters, one for each agent`,i),[...i].map(l=>ja(a,l,e.diagonal?9:5,r)));return{
...e,played:t.map(s("played")),next:n?s("next")(n):Array(o).fill(Ce)}}function ja(e,t,n,r){let o=/^\d$/.test(t)?Number(t):NaN;if(o<n)return o;if(t===no&&r.champions)
return ge;let s=r.scripts[t.charCodeAt(0)-97],a=String.fromCharCode(97+r.scripts.length-1);return s?.name??N(e,`actions 0 to ${n-1} or scripts a to ${a}`,t)}var pt=[.5,1,2,4,8,16,32,64],oo=0,Wt=12,Ga=2,je=class extends EventTarget{#e;#n;#t;#r=0;#o=0;#s=!1;#i=null;#h=0;#c=[];#p=[];glide=.28;constructor(t,{speed:n=4,still:r=!1}={}){
super(),this.#e=t,this.#n=n,this.#t=r}get step(){return this.#r}get time(){return this.#t?this.#r:this.#o}get arrived(){return this.#o===this.#r}get playing(){return this.#s}get length(){
return this.#e}set length(t){this.#e=t,this.#r>t&&this.jump(t),this.#a("state")}get marks(){return this.#c}set marks(t){this.#c=t,this.#a("state")}get ticks(){return this.#p}set ticks(t){
this.#p=t,this.#a("state")}get pace(){return this.#n||Math.max(Ga,this.#e/Wt)}get speed(){return this.#n}set speed(t){this.#n=t,this.#a("state")}changeSpeed(t){
let n=pt.findIndex(r=>r>=this.pace);this.speed=pt[Math.min(pt.length-1,Math.max(0,n+t))]}play(){this.#s||!this.#e||(this.#r===this.#e&&this.jump(0),this.#s=!0,this.#a(
"state"),this.#u())}pause(){this.#s&&(this.#s=!1,this.#a("state"))}toggle(){this.#s?this.pause():this.play()}move(t){this.pause();let n=Math.min(this.#e,Math.max(
0,this.#r+t));Math.abs(n-this.#o)>1?this.jump(n):this.#d(n),this.#u()}jump(t){this.#o=Math.min(this.#e,Math.max(0,Math.round(t))),this.#d(this.#o),this.#a("fram\
e")}#d(t){t!==this.#r&&(this.#r=t,this.#a("step"),this.#t&&this.#a("frame"))}#u(){this.#i===null&&(this.#h=performance.now(),this.#i=requestAnimationFrame(()=>this.#f()))}#f(){
this.#i=null;let t=performance.now();this.#l(Math.min(.25,(t-this.#h)/1e3)),this.#h=t,(!this.#t||this.arrived)&&this.#a("frame"),(this.#s||this.#o!==this.#r)&&(this.#i=
requestAnimationFrame(()=>this.#f()))}#l(t){let n=t;for(;n>0;){if(this.#o===this.#r){if(!this.#s)return;if(this.#r===this.#e)return this.pause();this.#d(this.#r+
1)}let r=this.#s?this.pace:1/this.glide,o=this.#r-this.#o,s=Math.min(Math.abs(o),n*r);n-=s/r,this.#o=s===Math.abs(o)?this.#r:this.#o+Math.sign(o)*s}this.#s&&this.#o===
this.#e&&this.pause()}#a(t){this.dispatchEvent(new Event(t))}};function Dt(e,t){if(t.ctrlKey||t.metaKey||t.altKey)return!1;let n=t.shiftKey?10:1,o={" ":()=>e.toggle(),
ArrowRight:()=>e.move(n),ArrowLeft:()=>e.move(-n),Home:()=>e.move(-e.length),End:()=>e.move(e.length),"+":()=>e.changeSpeed(1),"-":()=>e.changeSpeed(-1)}[t.key];
return o?.(),o!==void 0}var ue=[[0,0],[-1,0],[0,1],[1,0],[0,-1],[-1,1],[1,1],[1,-1],[-1,-1]];function ht(e,t,n){let r=t[0]-e[0],o=t[1]-e[1];return!n&&Math.abs(r)>Math.abs(o)?o=0:n||(r=
0),ue.findIndex(([s,a])=>s===Math.sign(r)&&a===Math.sign(o))}var Oe=(e,t)=>t<e.nPursuers,C=(e,t)=>[e.positions[2*t],e.positions[2*t+1]],ft=({rows:e,cols:t},[n,r])=>n>=
0&&r>=0&&n<e&&r<t,Pn=(e,t,n=3)=>e!==void 0&&[0,1,2].slice(0,n).some(r=>e[3*t+r]),Ln=(e,t)=>Pn(e.fault,t),so=(e,t)=>!Ln(e,t)&&Pn(e.involved,t,2);function Bt(e,t,n){
let r=C(e,n),o=C(t,n),s=r[0]!==o[0]||r[1]!==o[1],a=t.involved===void 0||Pn(t.involved,n);return!!(t.alive[n]&&t.actions?.[n]&&!s&&a)}function Ft(e,t,n){let[r,o]=C(
e,n),[s,a]=ue[t.actions?.[n]??0];return[r+s,o+a]}function jt(e,t,n){return Array.from({length:n.everCaptured.length},(o,s)=>s).filter(o=>n.everCaptured[o]&&!t.everCaptured[o]).
map(o=>e.nPursuers+o)}function Gt(e,t){return Array.from({length:t.alive.length},(r,o)=>o).filter(r=>e.alive[r]&&!t.alive[r])}var ao=[-.31,0,.31],io=[{size:1,at:[[0,0]]},{size:.62,at:[[-.2,.2],[.2,-.2]]},{size:.54,at:[[-.23,.22],[.23,.22],[0,-.22]]},{size:.54,at:[[-.23,.23],[.23,.23],[
-.23,-.23],[.23,-.23]]},{size:.36,at:ao.flatMap(e=>ao.map(t=>[t,e]))}],Ha=.3,Ka=.35,Va=.55;function gt(e,t){let n=new Map;for(let r=0;r<t.alive.length;r++){if(!t.
alive[r])continue;let[o,s]=C(t,r),a=o*e.cols+s,i=n.get(a);i?i.push(r):n.set(a,[r])}return n}function lo(e,t){let n=Array.from(t.alive,(r,o)=>{let[s,a]=C(t,o);return{
x:a+.5,y:s+.5,size:1,alpha:0}});for(let r of gt(e,t).values()){let o=io[Math.min(r.length,io.length)-1];r.forEach((s,a)=>{let[i,l]=o.at[Math.min(a,o.at.length-1)],
c=n[s];c.x+=i,c.y+=l,c.size=o.size,c.alpha=1})}return n}var co=e=>e*e*(3-2*e),Ge=(e,t,n)=>e+(t-e)*n,uo=e=>Math.min(1,Math.max(0,e));function mo(e,t,n,r){let o={
SIMULTANEOUS:1,SWARM_TURNS:2,AGENT_TURNS:n}[e.interaction];if(o===1)return co(r);let s=o===n?t:+!Oe(e,t),a=Math.max(1/o,Ka);return co(uo((r-s/(o-1)*(1-a))/a))}function Ht(e,t){
let n=e.moments.length-1,r=Math.min(Math.floor(t),n),o=e.moments[r],s=lo(e,o);if(r===n||t===r)return s;let a=e.moments[r+1],i=lo(e,a);return s.map((l,c)=>{let u=mo(
e,c,s.length,t-r);return Ya(o,a,c,l,i[c],u)})}function In(e,t,n){let r=e.moments.length-1,o=Math.min(Math.floor(n),r),s=e.moments[o],a=e.moments[Math.min(o+1,r)],
i=mo(e,t,s.alive.length,n-o),[l,c]=C(s,t),[u,m]=C(a,t);return[Ge(c,m,i)+.5,Ge(l,u,i)+.5]}function Ya(e,t,n,r,o,s){let a=r.alpha>o.alpha,i={x:Ge(r.x,o.x,s),y:Ge(
r.y,o.y,s),size:a?r.size:Ge(r.size,o.size,s),alpha:a?uo((1-s)/(1-Va)):Ge(r.alpha,o.alpha,s)};if(Bt(e,t,n)){let[l,c]=C(e,n),[u,m]=Ft(e,t,n),p=Ha*Math.sin(Math.PI*
s);i.x+=(m-c)*p,i.y+=(u-l)*p}return i}var po=2*Math.PI;function yt(e,t,n,r){e.beginPath(),e.arc(t,n,r/2,0,po)}function ho(e,t,n,r){let o=r/2,s=[[0,-.97],[.97,.83],[-.97,.83]].map(([a,i])=>[t+a*o,n+i*
o]);e.beginPath(),e.moveTo((s[2][0]+s[0][0])/2,(s[2][1]+s[0][1])/2),s.forEach(([a,i],l)=>{let[c,u]=s[(l+1)%3];e.arcTo(a,i,c,u,r*.09)}),e.closePath()}function fo(e,t,n,r){
let o=r*.32;e.beginPath(),e.moveTo(t-o,n-o),e.lineTo(t+o,n+o),e.moveTo(t+o,n-o),e.lineTo(t-o,n+o)}function go(e,t,n,r){e.beginPath();for(let o=0;o<16;o++){let s=r/
2*(o%2?.6:.95),a=po*o/16;e.lineTo(t+s*Math.sin(a),n-s*Math.cos(a))}e.closePath()}function yo(e,t,n,r,o,s){let a=Math.atan2(o-n,r-t);e.beginPath(),e.moveTo(t,n),
e.lineTo(r,o);for(let i of[-1,1])e.moveTo(r,o),e.lineTo(r-s*Math.cos(a+i*.6),o-s*Math.sin(a+i*.6))}var vo=4,Za=1.6,qa=.95,Ja=5,Xa=.16,Qa=9,ei=.09,ti=.2,bo=.75,F=(e,t)=>e.left+t*e.cell,j=(e,t)=>e.top+t*e.cell;function He(e,t,n){return Oe(t,n)?e.colors.pursuer:
e.colors.evader}function Kt({ctx:e,colors:t},n,r,o,s,a,i=0){e.font=`700 ${Math.round(s)}px system-ui, sans-serif`,e.textAlign="center",e.textBaseline="middle",e.
strokeStyle=t.paper,e.lineWidth=i,i&&e.strokeText(n,r,o),e.fillStyle=a,e.fillText(n,r,o)}function wo({ctx:e,grid:t,colors:n}){let{left:r,top:o,cell:s,rows:a,cols:i}=t,
l=i*s,c=a*s;if(e.fillStyle=n.paper,e.fillRect(r,o,l,c),s<Ja)return;e.fillStyle=n.line;let u=Math.max(1,Math.round(s/60));for(let m=1;m<i;m++)e.fillRect(r+m*s,o,
u,c);for(let m=1;m<a;m++)e.fillRect(r,o+m*s,l,u)}function xo({ctx:e,grid:t,colors:n},r){let{left:o,top:s,cell:a,rows:i,cols:l}=t;e.fillStyle=n.obstacle;for(let c=0;c<
i*l;c++){if(!r.obstacles[c])continue;let u=Math.floor(c/l),m=c%l;e.fillRect(o+m*a,s+u*a,a,a)}So({ctx:e,grid:t,colors:n})}function So({ctx:e,grid:{left:t,top:n,cell:r,
rows:o,cols:s},colors:a}){let i=Math.min(5,Math.max(2,Math.round(r/18)));e.strokeStyle=a.frame,e.lineWidth=i,e.strokeRect(t-i/2,n-i/2,s*r+i,o*r+i)}function Ao({
ctx:e,grid:t,colors:n},r){let{left:o,top:s,cell:a,rows:i,cols:l}=t,c=a<24*r?5:1;e.font=`500 ${Math.round(Math.min(15*r,Math.max(9*r,a*.32)))}px system-ui, sans-\
serif`,e.fillStyle=n.muted,e.textBaseline="alphabetic",e.textAlign="center";let u=5*r+a/40;for(let m=0;m<l;m+=c)e.fillText(String(m),o+(m+.5)*a,s-u);e.textAlign=
"right",e.textBaseline="middle";for(let m=0;m<i;m+=c)e.fillText(String(m),o-u,s+(m+.5)*a)}function To({grid:e},t,n,r){let o=Math.floor(t.fov/2)+.5,s=Math.max(0,
n-o),a=Math.min(e.cols,n+o),i=Math.max(0,r-o),l=Math.min(e.rows,r+o);return[F(e,s),j(e,i),(a-s)*e.cell,(l-i)*e.cell]}function Co(e,t,n,r){let{ctx:o,grid:s,colors:a}=e;
o.save(),o.beginPath(),o.rect(0,0,o.canvas.width,o.canvas.height),o.rect(...To(e,t,n,r)),o.clip("evenodd"),o.clearRect(0,0,o.canvas.width,o.canvas.height),o.fillStyle=
a.line,o.fillRect(s.left,s.top,s.cols*s.cell,s.rows*s.cell),o.restore(),So(e)}function Mo(e,{x:t,y:n,alpha:r},o){let{ctx:s,grid:a,colors:i}=e,l=Math.max(a.cell,
16*o)*1.06,c=F(a,t),u=j(a,n);s.globalAlpha=Math.max(r,.6),s.beginPath(),s.roundRect(c-l/2,u-l/2,l,l,l*.2),s.strokeStyle=i.focus,s.lineWidth=Math.max(2,2.5*o),s.
stroke();let m=Math.max(11*o,Math.min(18*o,a.cell*.5)),p=u-l/2<m*1.2,h=u+(p?1:-1)*(l/2+m*.7);s.lineJoin="round",Kt(e,"You",c,h,m,i.ink,m*.35),s.globalAlpha=1}function Eo(e,t,n,r,o){
let{ctx:s,grid:a}=e,i=To(e,t,r,o),l=He(e,t,n);s.globalAlpha=.11,s.fillStyle=l,s.fillRect(...i),s.globalAlpha=.8,s.strokeStyle=l,s.lineWidth=Math.max(1,a.cell/24),
s.strokeRect(...i),s.globalAlpha=1}function ko(e,t,n,r,o){let{ctx:s,grid:a}=e,i=Math.min(Math.ceil(n),t.moments.length-1),l=t.moments[i];s.lineCap="round",s.lineWidth=
Math.min(Qa,Math.max(1,a.cell*Xa));for(let c=Math.max(1,Math.floor(n-r)+1);c<=i;c++){let u=t.moments[c-1],m=t.moments[c],p=Math.max(0,Math.min(1,(n-c)/r));s.globalAlpha=
bo+(ti-bo)*p;for(let h=0;h<m.alive.length;h++){let f=c===i&&n<i;if(!u.alive[h]||!(l.alive[h]||f))continue;let g=(Oe(t,h)?-1:1)*ei,[y,v]=C(u,h),[x,b]=C(m,h);if(y===
x&&v===b)continue;let A=f?o[h].x:b+.5,E=f?o[h].y:x+.5;s.strokeStyle=He(e,t,h),s.beginPath(),s.moveTo(F(a,v+.5+g),j(a,y+.5+g)),s.lineTo(F(a,A+g),j(a,E+g)),s.stroke()}}
s.globalAlpha=1}function Oo(e,t,n){let r=Math.min(Math.ceil(n),t.moments.length-1);for(let o=Math.max(1,r-vo+1);o<=r;o++){let s=t.moments[o-1],a=t.moments[o],i=o>
n?Math.max(0,1-2*(o-n)):1-(n-o)/vo,l=jt(t,s,a);for(let c of Gt(s,a))l.includes(c)||ri(e,C(a,c),i);for(let c of l)ni(e,C(a,c),i)}e.ctx.globalAlpha=1}function ni({
ctx:e,grid:t,colors:n},[r,o],s){e.globalAlpha=s,go(e,F(t,o+.5),j(t,r+.5),Math.max(8,t.cell*Za)),e.fillStyle=n.capture,e.fill(),e.strokeStyle=n.ink,e.lineWidth=Math.
max(1,t.cell/36),e.lineJoin="round",e.stroke()}function ri({ctx:e,grid:t,colors:n},[r,o],s){e.globalAlpha=s,fo(e,F(t,o+.5),j(t,r+.5),Math.max(7,t.cell*qa)),e.strokeStyle=
n.collision,e.lineWidth=Math.max(2,t.cell*.17),e.lineCap="round",e.stroke()}function Ro({ctx:e,grid:t,colors:n},r,o){let s=Math.max(1,t.cell*.07);e.strokeStyle=
e.fillStyle=n.collision,e.lineWidth=Math.max(1,t.cell*.05),e.setLineDash([t.cell*.14,t.cell*.1]);for(let[a,i]of r){if(a<0||i<0||a>=t.rows||i>=t.cols)continue;let l=[
F(t,i)+s,j(t,a)+s,t.cell-2*s,t.cell-2*s];e.globalAlpha=.2*o,e.fillRect(...l),e.globalAlpha=o,e.strokeRect(...l)}e.setLineDash([]),e.globalAlpha=1}function _o({ctx:e,
grid:t,colors:n},r,o,s,a){e.globalAlpha=a,yt(e,F(t,r),j(t,o),Math.max(8,t.cell*s*1.02)),e.strokeStyle=n.collision,e.lineWidth=Math.max(1.5,t.cell*.085*Math.sqrt(
s)),e.stroke(),e.globalAlpha=1}var oi=.8,si=.92,ai=15,ii=7,$n=9;function No(e,t,n,r,o,s){r.forEach((a,i)=>{a.alpha>0&&li(e,t,n,i,a,o,s)}),e.ctx.globalAlpha=1;for(let a of gt(t,n).values())a.length>
$n&&ci(e,r[a[$n-1]],a.length-$n+1)}function li(e,t,n,r,o,s,a){let{ctx:i,grid:l,colors:c}=e,u=Oe(t,r),m=F(l,o.x),p=j(l,o.y),h=Math.max(4,l.cell*o.size*(u?si:oi)),
f=He(e,t,r),g=!u&&!!n.captured[r-t.nPursuers];if(i.globalAlpha=o.alpha,(u?ho:yt)(i,m,p,h),h>ii*a&&(i.strokeStyle=c.paper,i.lineWidth=Math.max(2,h*.1),i.stroke()),
i.fillStyle=g?c.paper:f,i.fill(),g&&(yt(i,m,p,h*.82),i.strokeStyle=f,i.lineWidth=h*.18,i.stroke()),!s||h<ai*a)return;let y=String(u?r:r-t.nPursuers),v=h*(u?.4:.5)*
(y.length>1?.8:1);Kt(e,y,m,p+h*(u?.17:.03),v,g?f:c.paper)}function ci(e,t,n){let{cell:r}=e.grid;Kt(e,`+${n}`,F(e.grid,t.x),j(e.grid,t.y),r*.3,e.colors.ink,r*.1)}var ui=.46,di=.86,mi=.66,Po=.48,pi=.78,hi=.58;function Lo(e,t,n,r){let o=t.moments[n-1],s=t.moments[n];if(!o)return;let{ctx:a,grid:i,colors:l}=e;a.strokeStyle=l.
collision,a.lineWidth=Math.max(1.5,i.cell*.07),a.lineCap="butt",a.globalAlpha=r;for(let c=0;c<s.alive.length;c++)Bt(o,s,c)&&fi(e,t,C(o,c),Ft(o,s,c));a.globalAlpha=
1}function fi({ctx:e,grid:t},n,r,o){let s=o[1]-r[1],a=o[0]-r[0],i=m=>F(t,r[1]+.5+s*m),l=m=>j(t,r[0]+.5+a*m),c=ft(n,o)?pi:hi;e.setLineDash([t.cell*.09,t.cell*.06]),
e.beginPath(),e.moveTo(i(Po),l(Po)),e.lineTo(i(c),l(c)),e.stroke(),e.setLineDash([]);let u=.17*t.cell/Math.hypot(s,a);e.beginPath(),e.moveTo(i(c)-a*u,l(c)+s*u),
e.lineTo(i(c)+a*u,l(c)-s*u),e.stroke()}function Io(e,t,n,r,o,s){let a=ue[s];if(!s||!a)return;let{ctx:i,grid:l,colors:c}=e,u=ft(t,[r[0]+a[0],r[1]+a[1]])?di:mi,m=ui*
o.size,p=[F(l,o.x+a[1]*m),j(l,o.y+a[0]*m),F(l,o.x+a[1]*u),j(l,o.y+a[0]*u)],h=Math.max(1.5,l.cell*.085);i.lineCap=i.lineJoin="round";for(let[f,g]of[[c.paper,h*2.1],
[He(e,t,n),h]])i.strokeStyle=f,i.lineWidth=g,yo(i,...p,l.cell*.2),i.stroke()}var Uo={numbers:!0,axes:!1,trail:6,viewers:[],plan:null,selected:null,cursor:null,you:null,fog:!1};function zo(e,t,n,r,o){let{ctx:s,grid:a,colors:i}=e,l=Math.min(
Math.ceil(n),t.moments.length-1),c=t.moments[l],u=n===l,m=Ht(t,n),p=u?1:Math.max(0,1-2*(l-n));s.clearRect(0,0,s.canvas.width,s.canvas.height),wo(e);for(let g of r.
viewers)m[g]?.alpha&&Eo(e,t,g,...In(t,g,n));xo(e,t),r.axes&&Ao(e,o),ko(e,t,n,r.trail,m),Ro(e,c.contested??[],p),Oo(e,t,n),Lo(e,t,l,p),m.forEach(({x:g,y,size:v},x)=>{
let b=so(c,x)?.4:0,A=Ln(c,x)?1:b;A&&_o(e,g,y,v,A*p)});let h=u?c:t.moments[Math.max(0,l-1)];if(No(e,t,h,m,r.numbers,o),u&&r.plan)for(let[g,y]of m.entries())y.alpha&&
Io(e,t,g,C(c,g),y,r.plan[g]??0);r.you!==null&&(r.fog&&Co(e,t,...In(t,r.you,n)),Mo(e,m[r.you],o)),s.lineWidth=Math.max(2,2.5*o),s.strokeStyle=i.focus;let f=r.selected===
null?void 0:m[r.selected];f?.alpha&&$o(e,f.x,f.y,f.size*.96),r.cursor&&(s.setLineDash([a.cell*.12,a.cell*.08]),$o(e,r.cursor[1]+.5,r.cursor[0]+.5,.8),s.setLineDash(
[]))}function $o({ctx:e,grid:t},n,r,o){let s=o*t.cell;e.beginPath(),e.roundRect(t.left+n*t.cell-s/2,t.top+r*t.cell-s/2,s,s,s*.1),e.stroke()}var Wo=(e,t)=>(t+.24)/(e+.24);function Do(e,t,n,r,o,s){let a=n?28*s:0,i=(c,u)=>(c-a)/(u+2*.12),l=Math.max(1,Math.floor(Math.min(i(r,t),i(o,e))));return{rows:e,cols:t,
cell:l,left:Math.round((r-t*l+a)/2),top:Math.round((o-e*l+a)/2)}}function Bo(e,t,n){let r=Math.floor((n-e.top)/e.cell),o=Math.floor((t-e.left)/e.cell);return r>=
0&&r<e.rows&&o>=0&&o<e.cols?[r,o]:null}var gi=["paper","line","frame","ink","muted","obstacle"],yi=["pursuer","evader","capture","collision","focus"];function Fo(e){let t=getComputedStyle(e),n=(r,o)=>[
r,t.getPropertyValue(o+r).trim()];return Object.fromEntries([...gi.map(r=>n(r,"--board-")),...yi.map(r=>n(r,"--"))])}var vt=()=>matchMedia("(prefers-reduced-motion: reduce)").matches,Ke=class{canvas;#e=null;#n=0;#t;#r={rows:1,cols:1,left:0,top:0,cell:1};#o=0;constructor(t,n={}){
this.canvas=t,t.classList.add("board"),t.setAttribute("role","img"),this.#t={...Uo,...n},new ResizeObserver(()=>this.#i()).observe(t),new MutationObserver(()=>this.
redraw()).observe(document.documentElement,{attributes:!0}),addEventListener("beforeprint",()=>this.drawNow())}set look(t){this.#t={...this.#t,...t},this.#s(),this.
redraw()}show(t,n){this.#e=t,this.#n=Math.min(Math.max(0,n),t.moments.length-1),this.#s(),this.redraw()}redraw(){this.#o||(this.#o=requestAnimationFrame(()=>this.
drawNow()))}drawNow(){cancelAnimationFrame(this.#o),this.#o=0;let t=this.canvas.getContext("2d");if(!t||!this.#e)return;let{rows:n,cols:r}=this.#e,o=devicePixelRatio||
1;this.#r=Do(n,r,this.#t.axes,this.canvas.width,this.canvas.height,o);let s={ctx:t,grid:this.#r,colors:Fo(this.canvas)};zo(s,this.#e,this.#n,this.#t,o)}cellAt(t,n){
let r=this.canvas.getBoundingClientRect(),o=this.canvas.width/r.width;return Bo(this.#r,(t-r.left)*o,(n-r.top)*o)}agentAt(t,n){let r=this.cellAt(t,n);if(!r||!this.#e)
return null;let o=this.#e.moments[Math.round(this.#n)],s=gt(this.#e,o).get(r[0]*this.#e.cols+r[1])??[],a=Ht(this.#e,Math.round(this.#n)),i=l=>{let[c,u]=this.pointOf(
a[l].x,a[l].y);return Math.hypot(c-t,u-n)};return s.length?s.reduce((l,c)=>i(c)<i(l)?c:l):null}pointOf(t,n){let r=this.canvas.getBoundingClientRect(),o=r.width/
this.canvas.width,{left:s,top:a,cell:i}=this.#r;return[r.left+(s+t*i)*o,r.top+(a+n*i)*o]}#s(){if(!this.#e)return;let{rows:t,cols:n}=this.#e;this.canvas.style.setProperty(
"--board-aspect",String(Wo(t,n)))}#i(){let t=devicePixelRatio||1,{width:n,height:r}=this.canvas.getBoundingClientRect();this.canvas.width=Math.max(1,Math.round(
n*t)),this.canvas.height=Math.max(1,Math.round(r*t)),this.drawNow()}};function Vt(e,t,n){let{rows:r,cols:o,n_pursuers:s,fov:a,rules:{interaction:i}}=e;return{rows:r,cols:o,nPursuers:s,fov:a,interaction:i,obstacles:t,moments:n}}function bt(e,t){
return{positions:e.read("last_positions"),alive:e.read("alive"),captured:e.read("captured"),everCaptured:e.read("ever_captured"),actions:t,involved:e.read("invo\
lved"),fault:e.read("fault"),contested:e.conflicts().map(n=>n.cell)}}var de=["pursuer","evader"],jo=e=>e==="pursuer"?"evader":"pursuer";var Un=.005,Ho=.05,vi=4,Ve=new Map;function Yt(e,t,n="capture-rate"){let r=JSON.stringify([{...t,rewards:null},n]),o=Ve.get(r)??(ze(t)?Promise.resolve(null):bi(
e,t,n));return Ve.delete(r),Ve.set(r,o),Ve.size>vi&&Ve.delete([...Ve.keys()][0]),o}var Zt=({n_evaders:e})=>e===1?"capture-time":"capture-rate",Go=()=>new Promise(
e=>setTimeout(e));async function bi(e,t,n){await Go();let r=e.solution(t,n);for(;r.goBack();)await Go();return r}function qt(e,t,n){let{payoff:r}=e;return n.flatMap(
(o,s)=>{let a=[0,0];for(let l=t.n_turns;l>0&&!t.over;l--)e.game(t)?.lost(o).forEach((c,u)=>a[u]+=c),t.playTurn(o);let i=r==="capture-rate"?Un:Ho;return de.map((l,c)=>({
step:s+1,team:l,lost:a[c],payoff:r})).filter(l=>l.lost>=i)})}var Ko=e=>e.map(t=>({step:t.step,kind:t.team,size:t.lost/Math.max(1,...e.map(({lost:n})=>n)),text:wt(
t)})),Vo=({lost:e,payoff:t})=>t==="capture-rate"?`${e.toFixed(2)} of the capture rate`:`${e.toFixed(1)} steps`,wt=e=>`The ${e.team}s lose ${Vo(e)} against a per\
fect opponent`;function Yo(e){let t=e.reduce((n,r)=>r.lost>n.lost?r:n);return`Your team's worst moves, in step ${t.step}, lost ${Vo(t)} against a perfect oppone\
nt.`}function Jt({config:e,payoff:t},{value:n},r){if(t==="capture-rate")return`value ${n.toFixed(2)}`;let o=1-n,s=Math.min(e.max_steps-r,Sn);return o>s-Ho?`free\
 for ${s} steps`:`captured after ${o.toFixed(1)} steps`}function Xt(e,t){return(e.marginal(t)??[]).map((r,o)=>({share:r,action:o})).filter(({share:r})=>r>=Un).sort(
(r,o)=>o.share-r.share).map(({share:r,action:o})=>r>1-Un?B[o]:`${B[o]} ${r.toFixed(2)}`).join(", ")}var Qt=class{recording;rules;outcomes=[];#e;#n;#t;#r=[];#o=[];constructor(t,n,r,o){this.#e=n,this.#n=o,this.rules=r;let s=Fe(n,r);this.#t=t.world(s),this.#t.restore(
wi(this.#t,n)),this.recording=Vt(s,this.#t.map(),this.#r),this.#i(void 0);for(let a of n.played)this.#s(a)}follow(t){if(!zn(this.#e,t))return!1;let n=this.#e.played,
r=t.played.findIndex((a,i)=>a!==n[i]),o=r<0?t.played.length:r,s=Math.min(o+1,this.#r.length);this.#r.length=this.outcomes.length=this.#o.length=s,this.#t.restore(
this.#o.at(-1));for(let a of t.played.slice(s-1))this.#s(a);return this.#e=t,!0}get length(){return this.#r.length-1}get over(){let{terminated:t,truncated:n}=this.
outcomes.at(-1);return t||n}actions(t){let n=Uint8Array.from(t,o=>typeof o=="number"?o:Ce),r=new Set(t.filter(o=>typeof o=="string"));for(let o of this.over?[]:
r)for(let s of["pursuer","evader"]){let a=this.#t.decide(o===ge?this.#n[s].policy:o,s,n);t.forEach((i,l)=>{i===o&&l<this.#e.pursuers.length==(s==="pursuer")&&(n[l]=
a[l])})}return n}scene(){let t=this.#t,n=t.read("last_positions"),r=t.read("alive"),o=t.read("captured"),s=t.read("ever_captured"),a=this.#e.pursuers.length,i=te(
this.#e).map((l,c)=>({...Cn([n[2*c],n[2*c+1]]),gone:!r[c],captured:c>=a&&!!o[c-a],everCaptured:c>=a&&!!s[c-a]}));return{...this.#e,played:[],steps:t.steps,ended:this.
outcomes.at(-1).terminated,pursuers:i.slice(0,a),evaders:i.slice(a)}}perfect(t){let n=this.#o.at(-2),r=this.#r.at(-1).actions;return n&&this.#t.restore(n),{losses:n&&
r?qt(t,this.#t,[r]):[],game:t.game(this.#t)}}free(){this.#t.free()}#s(t){if(this.over)return;let n=this.actions(t);this.#t.step(n),this.#i(n)}#i(t){let n=this.#t;
this.#r.push(bt(n,t)),this.#o.push(n.snapshot()),this.outcomes.push({conflicts:t?n.conflicts():[],rewards:n.read("rewards"),captors:n.read("captors"),terminated:!!n.
read("terminated")[0],truncated:!!n.read("truncated")[0]})}};function wi(e,t){let n=te(t),r=n.map(({cell:s})=>s[0]*t.cols+s[1]),o=s=>Uint8Array.from(t.evaders,a=>Number(
a[s]));return{...e.snapshot(),seed:BigUint64Array.of(t.seed),episode:BigUint64Array.of(t.episode),cells:Int32Array.from(r,(s,a)=>n[a].gone?-1:s),last_cells:Int32Array.
from(r,(s,a)=>n[a].gone?s:-1),captured:o("captured"),ever_captured:o("everCaptured"),capture_paid:o("everCaptured"),captors:new Int32Array(t.evaders.length),rewards:new Float32Array(
V(t)),report:new Int32Array(V(t)),participants:new Int32Array(0),steps:Int32Array.of(t.steps),terminated:Uint8Array.of(Number(t.ended)),truncated:Uint8Array.of(
+(t.steps>=t.maxSteps))}}function zn(e,t){return Object.keys(e).every(r=>["played","next","rules","others"].includes(r)||e[r]===t[r])}var xi={SIMULTANEOUS:.45,SWARM_TURNS:.9,AGENT_TURNS:1.4},Si=200,en=class extends EventTarget{data;player;#e;#n;#t;#r=[];#o=[];#s=[];#i=!1;#h="act";#c=0;#p=null;#d;constructor(t,n,r,o=null){
super(),this.#e=t,this.data=n,this.#p=o,this.#n=this.#d=r,this.#t=this.#f(r),this.player=new je(this.game.length,{still:vt()}),this.player.jump(this.game.length),
this.player.addEventListener("frame",()=>this.#g()),this.#a()}get scene(){return this.#n}get game(){return this.#t[0]}get games(){return this.#t}get mode(){return this.#h}set mode(t){
this.stop(),this.#h=t,this.#m()}get selected(){return this.#c}set selected(t){this.#c=t,this.#m()}get running(){return this.#i}get example(){return zn(this.#d,this.#n)?
this.#p:null}get canStep(){return!this.game.over&&this.#n.played.length<De}change(t,n={}){let r;try{r=this.#f(t)}catch(o){if(!(o instanceof K))throw o;return this.
say(o.message,!0),!1}return n.part||(this.#r=[...this.#r,this.#n].slice(-Si)),this.#o=[],n.example!==void 0&&(this.#p=n.example,this.#d=t),this.#s=[],this.#l(t,
r),!0}step(){if(!this.canStep){this.stop(),this.say(this.game.over?"The episode has ended. Go back, or restart.":`The playground plays ${De} steps.`,!0);return}
let n=this.#s.at(-1)===this.#n.next?this.#s.slice(0,-1):[],r=Gr(this.#n);this.change({...r,next:n.at(-1)??r.next}),this.#s=n}back(){this.stop();let{played:t}=this.#n;
if(!this.game.length)return;let n=this.#n,r=this.#s.at(-1)===n.next?[...this.#s]:[];for(let o=t.length;o>=this.game.length;o--)n=Hr(n),r.push(n.next);this.change(
n),this.#s=r}restart(){this.stop();let{played:t}=this.#n;if(!t.length)return;let n=[...this.#s.at(-1)===this.#n.next?this.#s:[],...[...t].reverse()];this.change(
{...this.#n,played:[],next:t[0]}),this.#s=n}run(){if(this.#i)return this.stop();this.#i=this.canStep,this.step()}stop(){this.#i&&(this.#i=!1,this.#m())}undo(){this.#u(
this.#r,this.#o)}redo(){this.#u(this.#o,this.#r)}solution(){let t=Fe(this.#n,this.#n.rules);return Yt(this.#e,t,Zt(t))}get canUndo(){return this.#r.length>0}shownBy(t,n="\
step"){this.addEventListener("change",t),this.player.addEventListener(n,t),t()}say(t,n=!1){this.dispatchEvent(new CustomEvent("message",{detail:{text:t,problem:n}}))}#u(t,n){
let r=t.pop();r&&(this.stop(),n.push(this.#n),this.#s=[],this.#l(r,this.#f(r)))}#f(t){let n=t.others?[t.rules,t.others]:[t.rules],r=this.#t??[];return n.map(o=>{
let s=r.find(i=>i.rules===o),a=s?.follow(t)?s:new Qt(this.#e,t,o,this.data.champions);return a.actions(t.next),a})}#l(t,n){let r=this.#n,o=this.#t.length;for(let l of this.#t)
n.includes(l)||l.free();this.#n=t,this.#t=n,this.#c!==null&&this.#c>=te(t).length&&(this.#c=null);let s=this.game.length,a=this.player.step,i=r.rules!==t.rules||
t.others!==null&&o<2;this.player.length=s,this.#a(),i&&s&&this.player.jump(s-1),i&&s||Math.abs(s-a)===1?this.player.move(s-this.player.step):this.player.jump(s),
this.#m()}#a(){this.player.glide=xi[this.#n.rules.interaction]}#g(){this.#i&&this.player.arrived&&this.step()}#m(){this.dispatchEvent(new Event("change"))}};function Zo(e,t,n){let r=s=>new en(e,t,mt(s,t),Jo(t,s)),o=t.gallery[0].scene;try{return{store:r(n||o),problem:""}}catch(s){return{store:r(o),problem:qo(s)}}}function qo(e){
if(e instanceof dt||e instanceof K)return`This link holds no scene. ${e.message}`;throw e}function Jo(e,t){return e.gallery.find(n=>n.scene===t)??null}function Re(){
try{return decodeURIComponent(location.hash.slice(1))}catch{return location.hash.slice(1)}}var xt=e=>new URLSearchParams(e).has("moves"),Ai=100;function Xo(e,t,n){
let r=Nn(e.scene,e.data),o=Re(),s=0,a=()=>{s=0,!(Re()!==o||!t())&&(o=r,history.replaceState(null,"",`#${r}`))};e.addEventListener("change",()=>{r=Nn(e.scene,e.data),
t()&&(o=Re(),r!==o&&!s&&(s=setTimeout(a,Ai)))}),window.addEventListener("hashchange",()=>{if(o=Re(),!(!o||o===r||xt(o))){t()||n();try{e.change(mt(o,e.data),{example:Jo(
e.data,o)})}catch(i){e.say(qo(i),!0)}}})}function Qo(){let e=JSON.parse(document.getElementById("data").textContent),t={...e,scene:document.getElementById("scene")?.textContent??e.scene},n=document.getElementById(
"champions")?.textContent;return n?{...t,champions:JSON.parse(n,Ti)}:t}var Ti=(e,t)=>e==="genome"?Float32Array.from(t):t;var M=Uint8Array,J=Uint16Array,Zn=Int32Array,nn=new M([0,0,0,0,0,0,0,0,1,1,1,1,2,2,2,2,3,3,3,3,4,4,4,4,5,5,5,5,0,0,0,0]),rn=new M([0,0,0,0,1,1,2,2,3,3,4,4,5,5,6,
6,7,7,8,8,9,9,10,10,11,11,12,12,13,13,0,0]),jn=new M([16,17,18,0,8,7,9,6,10,5,11,4,12,3,13,2,14,1,15]),ss=function(e,t){for(var n=new J(31),r=0;r<31;++r)n[r]=t+=
1<<e[r-1];for(var o=new Zn(n[30]),r=1;r<30;++r)for(var s=n[r];s<n[r+1];++s)o[s]=s-n[r]<<5|r;return{b:n,r:o}},as=ss(nn,2),is=as.b,Gn=as.r;is[28]=258,Gn[258]=28;var ls=ss(
rn,0),Ci=ls.b,es=ls.r,Hn=new J(32768);for(T=0;T<32768;++T)me=(T&43690)>>1|(T&21845)<<1,me=(me&52428)>>2|(me&13107)<<2,me=(me&61680)>>4|(me&3855)<<4,Hn[T]=((me&65280)>>
8|(me&255)<<8)>>1;var me,T,ie=(function(e,t,n){for(var r=e.length,o=0,s=new J(t);o<r;++o)e[o]&&++s[e[o]-1];var a=new J(t);for(o=1;o<t;++o)a[o]=a[o-1]+s[o-1]<<1;
var i;if(n){i=new J(1<<t);var l=15-t;for(o=0;o<r;++o)if(e[o])for(var c=o<<4|e[o],u=t-e[o],m=a[e[o]-1]++<<u,p=m|(1<<u)-1;m<=p;++m)i[Hn[m]>>l]=c}else for(i=new J(
r),o=0;o<r;++o)e[o]&&(i[o]=Hn[a[e[o]-1]++]>>15-e[o]);return i}),be=new M(288);for(T=0;T<144;++T)be[T]=8;var T;for(T=144;T<256;++T)be[T]=9;var T;for(T=256;T<280;++T)
be[T]=7;var T;for(T=280;T<288;++T)be[T]=8;var T,Tt=new M(32);for(T=0;T<32;++T)Tt[T]=5;var T,Mi=ie(be,9,0),Ei=ie(be,9,1),ki=ie(Tt,5,0),Oi=ie(Tt,5,1),Wn=function(e){
for(var t=e[0],n=1;n<e.length;++n)e[n]>t&&(t=e[n]);return t},re=function(e,t,n){var r=t/8|0;return(e[r]|e[r+1]<<8)>>(t&7)&n},Dn=function(e,t){var n=t/8|0;return(e[n]|
e[n+1]<<8|e[n+2]<<16)>>(t&7)},qn=function(e){return(e+7)/8|0},Ct=function(e,t,n){return(t==null||t<0)&&(t=0),(n==null||n>e.length)&&(n=e.length),new M(e.subarray(
t,n))};var Ri=["unexpected EOF","invalid block type","invalid length/literal","invalid distance","stream finished","no stream handler",,"no callback","invalid UTF-8 da\
ta","extra field too long","date not in range 1980-2099","filename too long","stream finishing","invalid zip data"],W=function(e,t,n){var r=new Error(t||Ri[e]);
if(r.code=e,Error.captureStackTrace&&Error.captureStackTrace(r,W),!n)throw r;return r},cs=function(e,t,n,r){var o=e.length,s=r?r.length:0;if(!o||t.f&&!t.l)return n||
new M(0);var a=!n,i=a||t.i!=2,l=t.i;a&&(n=new M(o*3));var c=function(Qe){var et=n.length;if(Qe>et){var Pe=new M(Math.max(et*2,Qe));Pe.set(n),n=Pe}},u=t.f||0,m=t.
p||0,p=t.b||0,h=t.l,f=t.d,g=t.m,y=t.n,v=o*8;do{if(!h){u=re(e,m,1);var x=re(e,m+1,3);if(m+=3,x)if(x==1)h=Ei,f=Oi,g=9,y=5;else if(x==2){var P=re(e,m,31)+257,R=re(
e,m+10,15)+4,S=P+re(e,m+5,31)+1;m+=14;for(var w=new M(S),I=new M(19),L=0;L<R;++L)I[jn[L]]=re(e,m+L*3,7);m+=R*3;for(var D=Wn(I),he=(1<<D)-1,Y=ie(I,D,1),L=0;L<S;){
var G=Y[re(e,m,he)];m+=G&15;var b=G>>4;if(b<16)w[L++]=b;else{var $=0,k=0;for(b==16?(k=3+re(e,m,3),m+=2,$=w[L-1]):b==17?(k=3+re(e,m,7),m+=3):b==18&&(k=11+re(e,m,
127),m+=7);k--;)w[L++]=$}}var H=w.subarray(0,P),U=w.subarray(P);g=Wn(H),y=Wn(U),h=ie(H,g,1),f=ie(U,y,1)}else W(1);else{var b=qn(m)+4,A=e[b-4]|e[b-3]<<8,E=b+A;if(E>
o){l&&W(0);break}i&&c(p+A),n.set(e.subarray(b,E),p),t.b=p+=A,t.p=m=E*8,t.f=u;continue}if(m>v){l&&W(0);break}}i&&c(p+131072);for(var Xe=(1<<g)-1,X=(1<<y)-1,ce=m;;ce=
m){var $=h[Dn(e,m)&Xe],Z=$>>4;if(m+=$&15,m>v){l&&W(0);break}if($||W(2),Z<256)n[p++]=Z;else if(Z==256){ce=m,h=null;break}else{var q=Z-254;if(Z>264){var L=Z-257,O=nn[L];
q=re(e,m,(1<<O)-1)+is[L],m+=O}var se=f[Dn(e,m)&X],_e=se>>4;se||W(3),m+=se&15;var U=Ci[_e];if(_e>3){var O=rn[_e];U+=Dn(e,m)&(1<<O)-1,m+=O}if(m>v){l&&W(0);break}i&&
c(p+131072);var Ne=p+q;if(p<U){var Rt=s-U,_t=Math.min(U,Ne);for(Rt+p<0&&W(3);p<_t;++p)n[p]=r[Rt+p]}for(;p<Ne;++p)n[p]=n[p-U]}}t.l=h,t.p=ce,t.b=p,t.f=u,h&&(u=1,t.
m=g,t.d=f,t.n=y)}while(!u);return p!=n.length&&a?Ct(n,0,p):n.subarray(0,p)},pe=function(e,t,n){n<<=t&7;var r=t/8|0;e[r]|=n,e[r+1]|=n>>8},St=function(e,t,n){n<<=
t&7;var r=t/8|0;e[r]|=n,e[r+1]|=n>>8,e[r+2]|=n>>16},Bn=function(e,t){for(var n=[],r=0;r<e.length;++r)e[r]&&n.push({s:r,f:e[r]});var o=n.length,s=n.slice();if(!o)
return{t:ds,l:0};if(o==1){var a=new M(n[0].s+1);return a[n[0].s]=1,{t:a,l:1}}n.sort(function(E,P){return E.f-P.f}),n.push({s:-1,f:25001});var i=n[0],l=n[1],c=0,
u=1,m=2;for(n[0]={s:-1,f:i.f+l.f,l:i,r:l};u!=o-1;)i=n[n[c].f<n[m].f?c++:m++],l=n[c!=u&&n[c].f<n[m].f?c++:m++],n[u++]={s:-1,f:i.f+l.f,l:i,r:l};for(var p=s[0].s,r=1;r<
o;++r)s[r].s>p&&(p=s[r].s);var h=new J(p+1),f=Kn(n[u-1],h,0);if(f>t){var r=0,g=0,y=f-t,v=1<<y;for(s.sort(function(P,R){return h[R.s]-h[P.s]||P.f-R.f});r<o;++r){
var x=s[r].s;if(h[x]>t)g+=v-(1<<f-h[x]),h[x]=t;else break}for(g>>=y;g>0;){var b=s[r].s;h[b]<t?g-=1<<t-h[b]++-1:++r}for(;r>=0&&g;--r){var A=s[r].s;h[A]==t&&(--h[A],
++g)}f=t}return{t:new M(h),l:f}},Kn=function(e,t,n){return e.s==-1?Math.max(Kn(e.l,t,n+1),Kn(e.r,t,n+1)):t[e.s]=n},ts=function(e){for(var t=e.length;t&&!e[--t];)
;for(var n=new J(++t),r=0,o=e[0],s=1,a=function(l){n[r++]=l},i=1;i<=t;++i)if(e[i]==o&&i!=t)++s;else{if(!o&&s>2){for(;s>138;s-=138)a(32754);s>2&&(a(s>10?s-11<<5|
28690:s-3<<5|12305),s=0)}else if(s>3){for(a(o),--s;s>6;s-=6)a(8304);s>2&&(a(s-3<<5|8208),s=0)}for(;s--;)a(o);s=1,o=e[i]}return{c:n.subarray(0,r),n:t}},At=function(e,t){
for(var n=0,r=0;r<t.length;++r)n+=e[r]*t[r];return n},us=function(e,t,n){var r=n.length,o=qn(t+2);e[o]=r&255,e[o+1]=r>>8,e[o+2]=e[o]^255,e[o+3]=e[o+1]^255;for(var s=0;s<
r;++s)e[o+s+4]=n[s];return(o+4+r)*8},ns=function(e,t,n,r,o,s,a,i,l,c,u){pe(t,u++,n),++o[256];for(var m=Bn(o,15),p=m.t,h=m.l,f=Bn(s,15),g=f.t,y=f.l,v=ts(p),x=v.c,
b=v.n,A=ts(g),E=A.c,P=A.n,R=new J(19),S=0;S<x.length;++S)++R[x[S]&31];for(var S=0;S<E.length;++S)++R[E[S]&31];for(var w=Bn(R,7),I=w.t,L=w.l,D=19;D>4&&!I[jn[D-1]];--D)
;var he=c+5<<3,Y=At(o,be)+At(s,Tt)+a,G=At(o,p)+At(s,g)+a+14+3*D+At(R,I)+2*R[16]+3*R[17]+7*R[18];if(l>=0&&he<=Y&&he<=G)return us(t,u,e.subarray(l,l+c));var $,k,H,
U;if(pe(t,u,1+(G<Y)),u+=2,G<Y){$=ie(p,h,0),k=p,H=ie(g,y,0),U=g;var Xe=ie(I,L,0);pe(t,u,b-257),pe(t,u+5,P-1),pe(t,u+10,D-4),u+=14;for(var S=0;S<D;++S)pe(t,u+3*S,
I[jn[S]]);u+=3*D;for(var X=[x,E],ce=0;ce<2;++ce)for(var Z=X[ce],S=0;S<Z.length;++S){var q=Z[S]&31;pe(t,u,Xe[q]),u+=I[q],q>15&&(pe(t,u,Z[S]>>5&127),u+=Z[S]>>12)}}else
$=Mi,k=be,H=ki,U=Tt;for(var S=0;S<i;++S){var O=r[S];if(O>255){var q=O>>18&31;St(t,u,$[q+257]),u+=k[q+257],q>7&&(pe(t,u,O>>23&31),u+=nn[q]);var se=O&31;St(t,u,H[se]),
u+=U[se],se>3&&(St(t,u,O>>5&8191),u+=rn[se])}else St(t,u,$[O]),u+=k[O]}return St(t,u,$[256]),u+k[256]},_i=new Zn([65540,131080,131088,131104,262176,1048704,1048832,
2114560,2117632]),ds=new M(0),Ni=function(e,t,n,r,o,s){var a=s.z||e.length,i=new M(r+a+5*(1+Math.ceil(a/7e3))+o),l=i.subarray(r,i.length-o),c=s.l,u=(s.r||0)&7;if(t){
u&&(l[0]=s.r>>3);for(var m=_i[t-1],p=m>>13,h=m&8191,f=(1<<n)-1,g=s.p||new J(32768),y=s.h||new J(f+1),v=Math.ceil(n/3),x=2*v,b=function(mn){return(e[mn]^e[mn+1]<<
v^e[mn+2]<<x)&f},A=new Zn(25e3),E=new J(288),P=new J(32),R=0,S=0,w=s.i||0,I=0,L=s.w||0,D=0;w+2<a;++w){var he=b(w),Y=w&32767,G=y[he];if(g[Y]=G,y[he]=Y,L<=w){var $=a-
w;if((R>7e3||I>24576)&&($>423||!c)){u=ns(e,l,0,A,E,P,S,I,D,w-D,u),I=R=S=0,D=w;for(var k=0;k<286;++k)E[k]=0;for(var k=0;k<30;++k)P[k]=0}var H=2,U=0,Xe=h,X=Y-G&32767;
if($>2&&he==b(w-X))for(var ce=Math.min(p,$)-1,Z=Math.min(32767,w),q=Math.min(258,$);X<=Z&&--Xe&&Y!=G;){if(e[w+H]==e[w+H-X]){for(var O=0;O<q&&e[w+O]==e[w+O-X];++O)
;if(O>H){if(H=O,U=X,O>ce)break;for(var se=Math.min(X,O-2),_e=0,k=0;k<se;++k){var Ne=w-X+k&32767,Rt=g[Ne],_t=Ne-Rt&32767;_t>_e&&(_e=_t,G=Ne)}}}Y=G,G=g[Y],X+=Y-G&
32767}if(U){A[I++]=268435456|Gn[H]<<18|es[U];var Qe=Gn[H]&31,et=es[U]&31;S+=nn[Qe]+rn[et],++E[257+Qe],++P[et],L=w+H,++R}else A[I++]=e[w],++E[e[w]]}}for(w=Math.max(
w,L);w<a;++w)A[I++]=e[w],++E[e[w]];u=ns(e,l,c,A,E,P,S,I,D,w-D,u),c||(s.r=u&7|l[u/8|0]<<3,u-=7,s.h=y,s.p=g,s.i=w,s.w=L)}else{for(var w=s.w||0;w<a+c;w+=65535){var Pe=w+
65535;Pe>=a&&(l[u/8|0]=c,Pe=a),u=us(l,u+1,e.subarray(w,Pe))}s.i=a}return Ct(i,0,r+qn(u)+o)},Pi=(function(){for(var e=new Int32Array(256),t=0;t<256;++t){for(var n=t,
r=9;--r;)n=(n&1&&-306674912)^n>>>1;e[t]=n}return e})(),Li=function(){var e=-1;return{p:function(t){for(var n=e,r=0;r<t.length;++r)n=Pi[n&255^t[r]]^n>>>8;e=n},d:function(){
return~e}}};var Ii=function(e,t,n,r,o){if(!o&&(o={l:1},t.dictionary)){var s=t.dictionary.subarray(-32768),a=new M(s.length+e.length);a.set(s),a.set(e,s.length),e=a,o.w=s.length}
return Ni(e,t.level==null?6:t.level,t.mem==null?o.l?Math.ceil(Math.max(8,Math.min(13,Math.log(e.length)))*1.5):20:12+t.mem,n,r,o)},ms=function(e,t){var n={};for(var r in e)
n[r]=e[r];for(var r in t)n[r]=t[r];return n};var ae=function(e,t){return e[t]|e[t+1]<<8},oe=function(e,t){return(e[t]|e[t+1]<<8|e[t+2]<<16|e[t+3]<<24)>>>0},Fn=function(e,t){return oe(e,t)+oe(e,t+4)*4294967296},
z=function(e,t,n){for(;n;++t)e[t]=n,n>>>=8};var $i=function(e,t){return((e[0]&15)!=8||e[0]>>4>7||(e[0]<<8|e[1])%31)&&W(6,"invalid zlib data"),(e[1]>>5&1)==+!t&&W(6,"invalid zlib data: "+(e[1]&32?"need":"u\
nexpected")+" dictionary"),(e[1]>>3&4)+2};function Ui(e,t){return Ii(e,t||{},0,0)}function zi(e,t){return cs(e,{i:2},t&&t.out,t&&t.dictionary)}function ps(e,t){return cs(e.subarray($i(e,t&&t.dictionary),-4),{i:2},t&&t.out,t&&t.dictionary)}var hs=function(e,t,n,r){for(var o in e){var s=e[o],a=t+o,i=r;Array.isArray(s)&&(i=ms(r,s[1]),s=s[0]),s instanceof M?n[a]=[s,i]:(n[a+="/"]=[new M(0),i],hs(s,a,n,
r))}},rs=typeof TextEncoder<"u"&&new TextEncoder,Vn=typeof TextDecoder<"u"&&new TextDecoder,Wi=0;try{Vn.decode(ds,{stream:!0}),Wi=1}catch{}var Di=function(e){for(var t="",
n=0;;){var r=e[n++],o=(r>127)+(r>223)+(r>239);if(n+o>e.length)return{s:t,r:Ct(e,n-1)};o?o==3?(r=((r&15)<<18|(e[n++]&63)<<12|(e[n++]&63)<<6|e[n++]&63)-65536,t+=String.
fromCharCode(55296|r>>10,56320|r&1023)):o&1?t+=String.fromCharCode((r&31)<<6|e[n++]&63):t+=String.fromCharCode((r&15)<<12|(e[n++]&63)<<6|e[n++]&63):t+=String.fromCharCode(
r)}};function tn(e,t){if(t){for(var n=new M(e.length),r=0;r<e.length;++r)n[r]=e.charCodeAt(r);return n}if(rs)return rs.encode(e);for(var o=e.length,s=new M(e.length+
(e.length>>1)),a=0,i=function(u){s[a++]=u},r=0;r<o;++r){if(a+5>s.length){var l=new M(a+8+(o-r<<1));l.set(s),s=l}var c=e.charCodeAt(r);c<128||t?i(c):c<2048?(i(192|
c>>6),i(128|c&63)):c>55295&&c<57344?(c=65536+(c&1047552)|e.charCodeAt(++r)&1023,i(240|c>>18),i(128|c>>12&63),i(128|c>>6&63),i(128|c&63)):(i(224|c>>12),i(128|c>>
6&63),i(128|c&63))}return Ct(s,0,a)}function Jn(e,t){if(t){for(var n="",r=0;r<e.length;r+=16384)n+=String.fromCharCode.apply(null,e.subarray(r,r+16384));return n}else{
if(Vn)return Vn.decode(e);var o=Di(e),s=o.s,n=o.r;return n.length&&W(8),s}}var Bi=function(e,t){return t+30+ae(e,t+26)+ae(e,t+28)},Fi=function(e,t,n){var r=ae(e,t+28),o=Jn(e.subarray(t+46,t+46+r),!(ae(e,t+8)&2048)),s=t+46+r,a=oe(e,t+20),
i=n&&a==4294967295?ji(e,s):[a,oe(e,t+24),oe(e,t+42)],l=i[0],c=i[1],u=i[2];return[ae(e,t+10),l,c,o,s+ae(e,t+30)+ae(e,t+32),u]},ji=function(e,t){for(;ae(e,t)!=1;t+=
4+ae(e,t+2));return[Fn(e,t+12),Fn(e,t+4),Fn(e,t+20)]},Yn=function(e){var t=0;if(e)for(var n in e){var r=e[n].length;r>65535&&W(9),t+=r+4}return t},os=function(e,t,n,r,o,s,a,i){
var l=r.length,c=n.extra,u=i&&i.length,m=Yn(c);z(e,t,a!=null?33639248:67324752),t+=4,a!=null&&(e[t++]=20,e[t++]=n.os),e[t]=20,t+=2,e[t++]=n.flag<<1|(s<0&&8),e[t++]=
o&&8,e[t++]=n.compression&255,e[t++]=n.compression>>8;var p=new Date(n.mtime==null?Date.now():n.mtime),h=p.getFullYear()-1980;if((h<0||h>119)&&W(10),z(e,t,h<<25|
p.getMonth()+1<<21|p.getDate()<<16|p.getHours()<<11|p.getMinutes()<<5|p.getSeconds()>>1),t+=4,s!=-1&&(z(e,t,n.crc),z(e,t+4,s<0?-s-2:s),z(e,t+8,n.size)),z(e,t+12,
l),z(e,t+14,m),t+=16,a!=null&&(z(e,t,u),z(e,t+6,n.attrs),z(e,t+10,a),t+=14),e.set(r,t),t+=l,m)for(var f in c){var g=c[f],y=g.length;z(e,t,+f),z(e,t+2,y),e.set(g,
t+4),t+=4+y}return u&&(e.set(i,t),t+=u),t},Gi=function(e,t,n,r,o){z(e,t,101010256),z(e,t+8,n),z(e,t+10,n),z(e,t+12,r),z(e,t+16,o)};function fs(e,t){t||(t={});var n={},r=[];hs(e,"",n,t);var o=0,s=0;for(var a in n){var i=n[a],l=i[0],c=i[1],u=c.level==0?0:8,m=tn(a),p=m.length,h=c.comment,f=h&&
tn(h),g=f&&f.length,y=Yn(c.extra);p>65535&&W(11);var v=u?Ui(l,c):l,x=v.length,b=Li();b.p(l),r.push(ms(c,{size:l.length,crc:b.d(),c:v,f:m,m:f,u:p!=a.length||f&&h.
length!=g,o,compression:u})),o+=30+p+y+x,s+=76+2*(p+y)+(g||0)+x}for(var A=new M(s+22),E=o,P=s-o,R=0;R<r.length;++R){var m=r[R];os(A,m.o,m,m.f,m.u,m.c.length);var S=30+
m.f.length+Yn(m.extra);A.set(m.c,m.o+S),os(A,o,m,m.f,m.u,m.c.length,m.o,m.m),o+=16+S+(m.m?m.m.length:0)}return Gi(A,o,r.length,P,E),A}function gs(e,t){for(var n={},r=e.length-22;oe(e,r)!=101010256;--r)(!r||e.length-r>65558)&&W(13);var o=ae(e,r+8);if(!o)return{};var s=oe(e,r+16),a=s==4294967295||
o==65535;if(a){var i=oe(e,r-12);a=oe(e,i)==101075792,a&&(o=oe(e,i+32),s=oe(e,i+48))}for(var l=t&&t.filter,c=0;c<o;++c){var u=Fi(e,s,a),m=u[0],p=u[1],h=u[2],f=u[3],
g=u[4],y=u[5],v=Bi(e,y);s=g,(!l||l({name:f,size:p,originalSize:h,compression:m}))&&(m?m==8?n[f]=zi(e.subarray(v,v+p),{out:new M(h)}):W(14,"unknown compression t\
ype "+m):n[f]=Ct(e,v,v+p))}return n}var Xn=4,ys=new Map;function vs(e,t){let n=ys.get(e);if(n)return n;let r=new Float32Array;try{let o=Ki(Vi(e),t);o.every(Number.isFinite)&&(r=o)}catch(o){if(!(o instanceof DOMException||
o instanceof RangeError||Hi(o)))throw o}return ys.set(e,r),r}var Hi=e=>e instanceof Error&&"code"in e;function Ki(e,t){let n=ps(e),r=n.length/Xn,o=new Uint8Array(
n.length);for(let a=0;a<o.length;a++)o[a]=n[a%Xn*r+Math.floor(a/Xn)];let s=new Uint32Array(o.buffer);for(let a=t;a<s.length;a++)s[a]^=s[a-t];return new Float32Array(
o.buffer)}function Vi(e){let t=atob(Yi(e)),n=new Uint8Array(t.length);for(let r=0;r<n.length;r++)n[r]=t.charCodeAt(r);return n}var Yi=e=>document.getElementById(
e)?.textContent??"";var Ye=class{config;start;recording;actions=[];#e;#n;#t=[[]];constructor(t,n,r){this.config=n,this.start=r,this.#e=t.world(n),this.#e.reset(r),this.#n=[bt(this.#e)],
this.recording=Vt(n,this.#e.map(),this.#n)}get length(){return this.actions.length}get over(){return this.#e.over}get statistics(){return{capture_rate:this.#e.read(
"capture_rate")[0]}}conflicts(t){return this.#t[t]}game(t){return t.game(this.#e)}play(t){this.#e.step(t),this.#r(t)}step(t,n,r){let o=this.#e,s=this.config.n_pursuers,
a=new Uint8Array(o.n_agents);for(let i=o.n_turns;i>0&&!o.over;--i){let[l,c]=o.actors;l<s&&(a=o.decide(t.pursuer,[l,Math.min(c,s)],a)),c>s&&(a=o.decide(t.evader,
[Math.max(l,s),c],a)),typeof r=="number"?a[n]=r:l<=n&&n<c&&(a=o.decide(r,[n,n+1],a)),o.playTurn(a)}this.#r(a)}#r(t){this.actions.push(t),this.#n.push(bt(this.#e,
t)),this.#t.push(this.#e.conflicts())}};function bs(e,t,n,r){let o=new Ye(e,t,n);for(let s of r)o.play(s);return o}var Zi={"|b1":e=>new Uint8Array(e),"|i1":e=>new Int8Array(e),"<i4":e=>new Int32Array(e),"<i8":e=>Int32Array.from(new BigInt64Array(e),Number),"<f4":e=>new Float32Array(
e)},xs="NUMPY\0",Ze=xs.length+2,ws=64;function Ss(e){return fs(Object.fromEntries(Object.entries(e).map(([t,n])=>[`${t}.npy`,qi(n)])))}function qi({dtype:e,shape:t,
data:n}){let r=typeof n=="string"?Array.from(n,u=>u.codePointAt(0)):null,o=t.map(u=>`${u}, `).join(""),s=`{'descr': '${r?`<U${r.length}`:e}', 'fortran_order': F\
alse, 'shape': (${o}), }`,a=Math.ceil((Ze+s.length+1)/ws)*ws-Ze,i=xs+String.fromCharCode(a&255,a>>8)+s.padEnd(a-1)+`
`,l=r?Int32Array.from(r):n,c=new Uint8Array(i.length+l.byteLength);return c.set(tn(i,!0)),c.set(new Uint8Array(l.buffer,l.byteOffset,l.byteLength),i.length),c}function As(e){
return Object.fromEntries(Object.entries(gs(e)).map(([t,n])=>[t.replace(/\.npy$/,""),Ji(n)]))}function Ji(e){let t=Ze+e[Ze-2]+256*e[Ze-1],n=Jn(e.subarray(Ze,t),
!0),r=/'descr': '([^']+)', 'fortran_order': False, 'shape': \(([\d, ]*)\)/.exec(n),o=r?.[1]??"",s=(r?.[2]??"").split(",").filter(c=>c.trim()).map(Number),a=e.slice(
t).buffer,i=o.startsWith("<U")&&String.fromCodePoint(...new Int32Array(a)),l=i===!1?Zi[o]?.(a):i.replace(/\0+$/,"");if(l===void 0)throw new TypeError(`expected \
an array of numbers or a text, got ${n.slice(0,80)}`);return{dtype:o,shape:s,data:l}}var Qn="matrixworld episode 3";function Ts(e,t,n){let{config:r,actions:o,length:s,recording:a}=t,i=r.n_pursuers+r.n_evaders,l=r.n_evaders,c={positions:["<i4",i,
2],last_positions:["<i4",i,2],alive:["|b1",i],captured:["|b1",l],ever_captured:["|b1",l]},u={rewards:["<f4",i],involved:["|b1",i,3],fault:["|b1",i,3]},m={},p=b=>{
for(let A of Object.keys(b))(m[A]??=[]).push(Array.from(h.read(A),Number))},h=e.world(r);h.reset(t.start);let f=[];p(c);for(let b of o)h.step(b),p({...c,...u}),
f.push(...h.conflictTable());h.free();let g={"<i4":Int32Array,"<f4":Float32Array,"|b1":Uint8Array},y={};for(let[b,[A,...E]]of Object.entries({...c,...u})){let P=s+
+(b in c);y[b]={dtype:A,shape:[P,...E],data:g[A].from((m[b]??[]).flat())}}let v=b=>({dtype:"<i8",shape:[],data:Int32Array.of(b,0)}),x=b=>({dtype:"<U",shape:[],data:b});
return Ss({format:x(Qn),n_pursuers:v(r.n_pursuers),config:x(JSON.stringify(r)),seat:v(n),...y,actions:{dtype:"|i1",shape:[s,i],data:Int8Array.from(o.flatMap(b=>[
...b]))},map:{dtype:"|b1",shape:[r.rows,r.cols],data:Uint8Array.from(a.obstacles,Number)},conflict_table:{dtype:"<i4",shape:[f.length/11,11],data:Int32Array.from(
f)}})}function Cs(e,t){let n=As(t),r=h=>Array.from(n[h]?.data??[]);if(n.format?.data!==Qn)throw new K(`expected a file marked "${Qn}"`);let o=JSON.parse(n.config.
data),s=o.n_pursuers+o.n_evaders,a=r("positions"),i=(h,f)=>Array.from({length:f-h},(g,y)=>[a[2*(h+y)],a[2*(h+y)+1]]),l={pursuers:i(0,o.n_pursuers),evaders:i(o.n_pursuers,
s),obstacles:Uint8Array.from(r("map"))},c=Uint8Array.from(r("actions")),u=Array.from({length:c.length/s},(h,f)=>c.subarray(f*s,(f+1)*s)),m=bs(e,o,l,u);if(Array.
from(m.recording.moments.at(-1).positions).join()!==r("last_positions").slice(-2*s).join())throw new K("expected the moves of this start to lead to its end");return{
live:m,seat:r("seat")[0]??null}}var le=(e,t)=>de[+(t>=e.n_pursuers)];function er(e,t){let n=new Ye(e,t.config,{seed:t.seed,episode:t.episode});for(let r of t.moves)n.over||n.step(t.policies,t.
seat,r);return n}function we(e,t){let{moments:n,nPursuers:r}=e.recording,o=n.findIndex(({alive:a,captured:i})=>!a[t]||!!i[t-r]),s=o<0?e.length:o;return{lasted:s,
out:o>=0,captured:Array.from(n[s].everCaptured).filter(Boolean).length}}var on=(e,t)=>e.over||we(e,t).out;function Ms(e,t,n){let r=er(e,{...t,moves:t.moves.slice(
0,t.from)});for(;!on(r,t.seat);)r.step(t.policies,t.seat,n);return we(r,t.seat)}function tr(e){let t=e.length-1;return[...new Set([0,Math.round(t/3),t])].map(n=>e[n])}
function Es(e,{seat:t,from:n,moves:r}){let o={...e,seat:t,...n?{from:n}:{},moves:r.join("")};return`${location.href.split("#")[0]}#${Object.entries(o).map(([s,a])=>`${s}\
=${a}`).join("&")}`}function ks(e,t){let n=e.get("seat")??"",r=e.get("from")??"0",o=e.get("moves")??"";return/^\d{1,6}$/.test(n)&&Number(n)<t.n_pursuers+t.n_evaders&&
(t.diagonal?/^[0-8]+$/:/^[0-4]+$/).test(o)&&o.length<=t.max_steps&&/^\d{1,6}$/.test(r)&&Number(r)<=o.length?{seat:Number(n),from:Number(r),moves:[...o].map(Number)}:
null}var nr=()=>crypto.getRandomValues(new BigUint64Array(1))[0],Xi=8;function Os(e,t,n){let{n_pursuers:r,n_evaders:o}=t,s=Array.from({length:r+o},(l,c)=>c).filter(
l=>le(t,l)!==le(t,n)),a=l=>{let c=new Ye(e,t,{seed:l}).recording.moments[0].positions,u=(m,p)=>Math.abs(c[2*n+m]-c[2*p+m]);return Math.min(...s.map(m=>u(0,m)+u(
1,m)))};return Array.from({length:Xi},nr).map(l=>[l,a(l)]).reduce((l,c)=>c[1]>l[1]?c:l)[0]}var Qi=20,el=60;function tl(e,t){let n=e.rules.capture==="SURROUND"?8:4,r=typeof e.obstacles!="number",o=a=>r?a:Math.min(a,Qi),s={...e,rows:o(e.rows),cols:o(e.cols),
max_steps:el,n_evaders:1,n_pursuers:Math.min(e.n_pursuers,n)};return tr(t).map(a=>({config:s,rival:a}))}function rr(e,t,n,r){let o=n.rounds.length?n.rounds.map(
({world:l,pursuers:c,text:u})=>({config:l,rival:{name:`${c.replaceAll("-"," ")}s`,text:u,policy:()=>c}})):tl(n.world,r),s=[],a=()=>`${s.reduce((l,c)=>l+c,0)} of\
 ${o.reduce((l,{config:c})=>l+c.max_steps,0)}`,i=()=>{let{config:l,rival:c}=o[s.length];t.play({title:`Can you escape it? Round ${s.length+1} of ${o.length}, ${l.
n_pursuers} pursuers: ${c.name}`,about:c.text&&`${c.name}: ${c.text}`,played:{config:l,seed:Os(e,l,l.n_pursuers),episode:0,seat:l.n_pursuers,from:0,moves:[],policies:{
pursuer:c.policy(),evader:"still"}},ending:u=>{s.push(we(u,l.n_pursuers).lasted);let m=o.map(({rival:{name:h}},f)=>d("tr",{},d("th",{scope:"row"},h),d("td",{},s[f]??
""))),p=s.length<o.length;return[d("table",{class:"numbers"},d("caption",{},`Steps of ${l.max_steps} in each round`),...m),d("p",{class:"play-score"},p?"Score s\
o far: ":"Your score: ",d("strong",{},a())),p?d("button",{type:"button",class:"primary",onclick:i},"Next round"):""]},again:()=>rr(e,t,n,r),link:()=>null})};i()}
function or(e,t,n,r){let{players:o,told:s,...a}=r;t.play({...a,played:n,ending:(i,l)=>[s?d("p",{},s(we(i,n.seat))):"",nl(e,i,l,tr(o))],again:()=>or(e,t,{...n,moves:n.
moves.slice(0,n.from)},r)})}function nl(e,t,n,r){let o=le(n.config,n.seat)==="evader",s=o?n.config.max_steps:n.config.n_evaders,a=d("table",{class:"numbers"},d(
"caption",{},o?"Steps in your seat: same start, same others":"Captures of your team: same start, same others")),i=c=>{let u=d("span",{class:o?"bar evader":"bar \
pursuer"}),m=d("td",{},"…");return a.append(d("tr",{},d("th",{scope:"row"},c),d("td",{class:"track","aria-hidden":"true"},u),m)),({lasted:p,captured:h})=>{u.style.
width=`${100*(o?p:h)/s}%`,m.textContent=String(o?p:h)}};i("You")(we(t,n.seat));for(let{name:c,policy:u}of r){let m=i(c);setTimeout(()=>m(Ms(e,n,u())))}let l=n.from?
`You took over at step ${n.from}. `:"";return d("div",{},a,d("p",{class:"small muted"},`${l}One match: luck has its part in it.`))}var rl={first:"M6 5v14M19 5 9 12l10 7z",back:"M17 5 7 12l10 7z",play:"M7 4.5 19 12 7 19.5z",pause:"M8 5v14M16 5v14",forward:"M7 5l10 7-10 7z",last:"M18 5v14M5 5\
l10 7-10 7z"};function Et(e){return Te("svg",{viewBox:"0 0 24 24","aria-hidden":"true",class:"icon"},Te("path",{d:rl[e]}))}function Mt(e,t,n,r){return d("button",
{type:"button",class:"player-button","aria-label":t,title:`${t} (${n})`,onclick:r},Et(e))}function Rs(e){let t=Mt("play","Play","Space",()=>e.toggle()),n=d("inp\
ut",{type:"range",class:"player-scrub",min:0,step:1,"aria-label":"Step",oninput:()=>{e.pause(),e.jump(Number(n.value))}}),r=d("div",{class:"captures","aria-hidd\
en":"true",title:"Captures"}),o=d("div",{class:"losses","aria-hidden":"true"}),s=d("select",{class:"player-speed","aria-label":"Speed",title:`Steps a second, or\
 the whole in ${Wt} s (+ and -)`,onchange:()=>e.speed=Number(s.value)},d("option",{value:oo},`in ${Wt} s`),...pt.map(m=>d("option",{value:m},`${m} / s`))),a=d("\
output",{class:"player-count"}),i=d("div",{class:"player",role:"group","aria-label":"Player"},Mt("first","First step","Home",()=>e.move(-e.length)),Mt("back","S\
tep back","←",()=>e.move(-1)),t,Mt("forward","Step forward","→",()=>e.move(1)),Mt("last","Last step","End",()=>e.move(e.length)),d("div",{class:"scrub"},r,o,
n),a,s),l=(m,p={})=>{let h=d("i",p);return h.style.left=`${100*m/Math.max(1,e.length)}%`,h},c=()=>{r.replaceChildren(...e.marks.map(m=>l(m))),o.replaceChildren(
...e.ticks.map(({step:m,kind:p,size:h,text:f})=>{let g=l(m,{class:p,title:`Step ${m}: ${f}`});return g.style.height=`${100*h}%`,g}))},u=()=>{t.replaceChildren(Et(
e.playing?"pause":"play")),t.ariaLabel=e.playing?"Pause":"Play",t.title=`${t.ariaLabel} (Space)`,n.max=String(e.length),n.value=String(e.step),n.ariaValueText=`\
step ${e.step} of ${e.length}`,a.textContent=`${e.step} / ${e.length}`,a.style.minWidth=`${2*String(e.length).length+3}ch`,s.value=String(e.speed)};return e.addEventListener(
"step",u),e.addEventListener("state",u),e.addEventListener("state",c),i.addEventListener("keydown",m=>{!(m.target instanceof HTMLSelectElement||m.key===" "&&m.target!==
n)&&Dt(e,m)&&m.preventDefault()}),u(),i}function _s(e,t,n){if(n===0)return[{kind:"start",text:ol(e),agents:[]}];let r=t.moments[n-1],o=t.moments[n],s=u=>Q(u,e.config.n_pursuers),a=jt(t,r,o),i=e.conflicts(
n),l=new Set(i.flatMap(u=>u.doomed)),c=a.map(u=>({kind:"capture",text:`${s(u)} is captured`,agents:[u]}));for(let u of Gt(r,o))!a.includes(u)&&!l.has(u)&&c.push(
{kind:"end",text:`${s(u)} disappears`,agents:[u]});return c.push(...i.map(({kind:u,text:m,agents:p})=>({kind:u,text:m,agents:p}))),n===e.length&&c.unshift({kind:"\
end",text:sl(e),agents:[]}),c}function ol({config:e}){return`${e.n_pursuers} pursuers and ${e.n_evaders} evaders on ${e.rows} x ${e.cols} cells, at most ${e.max_steps}\
 steps`}function sl(e){let t=Math.round(e.statistics.capture_rate*e.config.n_evaders);return`The episode ends after ${e.length} steps with ${t} of ${e.config.n_evaders}\
 evaders captured`}function Ns(e,t,...n){let r=d("dialog",{class:t,"aria-label":e,onclick:({target:o})=>o===r&&r.close()},d("div",{class:"dialog-head"},d("h2",{},e),d("button",{type:"\
button",class:"close","aria-label":"Close",onclick:()=>r.close()},"✕")),...n);return r}var sr=e=>d("dl",{class:"keys"},...e.flatMap(([t,n])=>[d("dt",{},...t.map(
r=>d("kbd",{},r))),d("dd",{},n)])),Ps=e=>d("input",{type:"text",readonly:!0,"aria-label":e});function Ls(e,t){e.value=t,e.hidden=!1,e.select(),navigator.clipboard?.
writeText(t).catch(()=>{})}function Is(e,t){let n=URL.createObjectURL(new Blob([t],{type:"application/octet-stream"}));d("a",{href:n,download:e}).click(),setTimeout(
()=>URL.revokeObjectURL(n),6e4)}var kt=["·","↑","→","↓","←","↗","↘","↙","↖"],$s=e=>typeof e=="number"?`${kt[e]} ${B[e]}`:e,al={obstacle:["obstacle"],teammate:["teammate"],adversary:[
"evader","pursuer"]},il=e=>e.length<2?e.join(""):`${e.slice(0,-1).join(", ")} and ${e.at(-1)}`;function sn(e,t,n){let r=t.recording.moments[n-1],o=t.recording.moments[n],
s=t.outcomes[n];if(!r||!o||!s)return[];let a=[...s.conflicts.map(l=>ll(e,t.rules,l)),...cl(e,r,o,s.captors)],i={kind:"calm",text:"No conflict, no capture.",turn:0,
blame:"",cost:"",used:[]};return[...a.length?a:[i],...ul(e,t,n)]}function ll(e,t,n){let r=n.at_fault.map(c=>ne(e,c)),o=t.interaction==="SIMULTANEOUS"?0:n.turn+1,
s=r.length?`At fault: ${il(r)}.`:"Nobody is at fault.",a=n.held.length+n.doomed.length>0,i=new Set(n.at_fault.map(c=>Us(e,c,nt.indexOf(n.kind))));i.delete(0);let l=a||
!i.size?"":`Allowed, but it costs: ${[...i].map(an).join(" and ")}.`;return{kind:n.kind,text:`${n.text}.`,turn:o,blame:s,cost:l,used:al[n.kind]}}function Us({pursuers:e,
rewards:t},n,r){let o=n<e.length?t.pursuer_collide:t.evader_collide;return typeof o=="number"?o:o[r]}function an(e){let t=String(Number(Math.abs(e).toPrecision(
5)));return e<0?`−${t}`:e>0?`+${t}`:"0"}function zs(e,t,n,r){let o=t.recording.moments[n-1],s=t.recording.moments[n],a=t.outcomes[n];if(!o?.alive[r]||!s||!a)return"";
let{rewards:i}=e,l=r<e.pursuers.length?"pursuer":"evader",c=i.blame==="FAULT"?s.fault:s.involved,u=nt.reduce((h,f,g)=>h+(c?.[3*r+g]?Us(e,r,g):0),0),m=a.rewards[r]-
u-i[`${l}_step`],p=Array.from({length:e.evaders.length+1},(h,f)=>f*i[`${l}_capture`]);for(let h of[0,i[`${l}_neighbor`]]){let f=p.find(v=>Math.abs(v+h-m)<1e-4);
if(f===void 0)continue;let g={collision:u,capture:f,neighbour:h,step:i[`${l}_step`]},y=Object.entries(g).filter(([,v])=>v).map(([v,x])=>`${an(x)} ${v}`);return y.
length>1?y.join(", "):""}return""}function cl(e,t,n,r){let o=[];for(let s=0;s<e.evaders.length;s++){let a=e.pursuers.length+s,i=ne(e,a),l=t.alive[a]&&!n.alive[a],
c=r[s]?` by ${r[s]} ${r[s]===1?"pursuer":"pursuers"}`:"",u=["capture",...l?["captured_disappear"]:[]];n.captured[s]&&!t.captured[s]?o.push({kind:"capture",text:`${i}\
 is captured${c}${l?" and disappears":""}.`,turn:0,blame:"",cost:"",used:u}):t.captured[s]&&!n.captured[s]&&n.alive[a]&&o.push({kind:"capture",text:`${i} is fre\
e again.`,turn:0,blame:"",cost:"",used:["capture"]})}return o}function ul(e,t,n){let{terminated:r,truncated:o}=t.outcomes[n];if(!r&&!o)return[];let s=t.recording.
moments[n].alive,a=(c,u)=>Array.from(s).slice(c,u).some(Boolean),i=e.pursuers.length,l=`after ${e.maxSteps} steps`;return r&&(l=a(0,i)?"every evader is captured\
 or gone":"no pursuer is left"),r&&!a(i,V(e))&&(l="no evader is left"),[{kind:"end",text:`The episode has ended: ${l}.`,turn:0,blame:"",cost:"",used:[]}]}function Ot(e){
return e.split(/(\(-?\d+, -?\d+\)|-[A-Z]{1,3}\b)/).map((t,n)=>n%2?d("span",{class:"whole"},t):t)}var dl={" ":0,ArrowUp:1,w:1,ArrowRight:2,d:2,ArrowDown:3,s:3,ArrowLeft:4,a:4,e:5,c:6,y:7,z:7,q:8},ar=[8,1,5,4,0,2,7,3,6],ml=[7,8,9,4,5,6,1,2,3],pl=24,hl=Math.tan(
Math.PI/8);function Ds(e,t){if(e.ctrlKey||e.metaKey||e.altKey)return;let n=ml.findIndex(o=>e.code===`Numpad${o}`),r=ar[n]??dl[e.key.length===1?e.key.toLowerCase():
e.key];return r!==void 0&&r>4&&!t?void 0:r}function Bs(e){let t=ar.map(n=>d("button",{type:"button","aria-label":B[n],onclick:()=>e(n)},kt[n]));return{element:d(
"div",{class:"play-pad",role:"group","aria-label":"Your move"},...t),show:n=>t.forEach((r,o)=>r.classList.toggle("absent",ar[o]>4&&!n))}}function Ws(e,t,n){let r=hl*
Math.max(Math.abs(e),Math.abs(t)),o=s=>Math.abs(s)<r?0:s;return ht([0,0],n?[o(e),o(t)]:[e,t],n)}function Fs(e,t,n){let r=null,{canvas:o}=e;o.addEventListener("p\
ointerdown",({button:s,clientX:a,clientY:i})=>r=s===0?[a,i]:null),o.addEventListener("pointercancel",()=>r=null),o.addEventListener("pointerup",({clientX:s,clientY:a})=>{
let i=r,l=t();if(r=null,!i||!l)return;let c=s-i[0],u=a-i[1],m=e.cellAt(s,a);Math.hypot(c,u)>=pl?n(Ws(u,c,l.diagonal)):m&&n(Ws(m[0]-l.cell[0],m[1]-l.cell[1],l.diagonal))})}
function js(e,t){let n=r=>{let o=t[r]-e[r],s=ue.findIndex(a=>a[r]===Math.sign(o)&&a[1-r]===0);return o?`${Math.abs(o)} ${B[s]}`:""};return[n(0),n(1)].filter(Boolean).
join(", ")||"on your cell"}var fl=[0,1,2,4,8],ln=class{element;player=new je(0,{speed:4,still:vt()});#e;#n;#t=d("canvas",{tabindex:0,"aria-describedby":"play-keys"});#r=d("h2");#o=d("p",{
class:"play-told",role:"status"});#s=Bs(t=>this.act(t));#i=lt(fl.map(t=>[t,t?`${t} / s`:"step by step"]),()=>this.#x());#h=d("input",{type:"checkbox",onchange:()=>this.#T()});#c=d(
"input",{type:"checkbox",onchange:()=>this.#S()});#p=d("label",{class:"play-choice"},this.#c,"Best move");#d=d("p",{class:"small muted play-keys",id:"play-keys"});#u=d(
"section",{class:"play-ending",tabindex:-1,"aria-labelledby":"play-headline"});#f=Rs(this.player);#l=null;#a=null;#g=[];#m=null;#y=null;#v=[];#b=0;#w=0;constructor(t){
this.#e=t,this.#n=new Ke(this.#t,{numbers:!1}),this.#t.setAttribute("role","application"),Fs(this.#n,()=>{let n=this.#m!==null&&this.#a&&C(this.#a.recording.moments.
at(-1),this.#m);return n?{cell:n,diagonal:this.#a.config.diagonal}:null},n=>this.act(n)),this.player.addEventListener("frame",()=>this.#a&&this.#n.show(this.#a.
recording,this.player.time)),this.player.addEventListener("step",()=>this.#S()),this.element=d("div",{class:"play"},d("header",{class:"play-head"},this.#r,this.#o),
d("div",{class:"play-stage"},this.#t),d("div",{class:"play-side"},this.#u,this.#s.element,d("label",{class:"play-choice",title:"Steps a second"},"Pace ",this.#i),
d("label",{class:"play-choice"},this.#h,d("span",{},"Fog",d("span",{class:"at-length"},": see only what it sees"))),this.#p,this.#d),this.#f)}get played(){return this.#l&&
{...this.#l.played,moves:this.#g}}get live(){return this.#a}play(t){this.#A(er(this.#e,t.played),t.played.seat,t.title),this.#l=t,this.#g=[...t.played.moves],this.#b=
0,this.element.dataset.state="playing",this.#t.focus({preventScroll:!0}),on(this.#a,t.played.seat)&&this.#k()}watch(t,n,r){this.#l=null,this.#A(t,n,r),this.#O()}stop(){
this.#x(),this.player.pause(),this.#l=null}act(t){let n=this.#l,r=this.#a;if(!n||!r||this.element.dataset.state!=="playing")return;this.#b=t;let o=Number(this.#i.
value);this.#w||(this.#E(),o&&this.element.dataset.state==="playing"&&(this.#w=setInterval(()=>this.#E(),1e3/o)))}key(t){let{target:n,key:r}=t;if(n instanceof HTMLSelectElement||
n instanceof HTMLInputElement&&(n.type==="text"||r===" ")||n instanceof HTMLButtonElement&&(r===" "||r==="Enter")||!this.#a)return!1;if(this.element.dataset.state!==
"playing")return Dt(this.player,t);let s=Ds(t,this.#a.config.diagonal);return s!==void 0&&this.act(s),s!==void 0}#A(t,n,r){this.#x(),this.player.pause(),this.#a=
t,this.#m=n,this.#r.textContent=r,this.#t.ariaLabel=`Board, ${t.config.rows} by ${t.config.cols} cells`,this.#s.show(t.config.diagonal),this.#d.replaceChildren(
d("span",{class:"at-length"},`W A S D or the arrow keys move, Space stays${t.config.diagonal?"; Q E Z C and the numeric keypad move diagonally":""}. `),"On the \
board: swipe, or tap where to go."),this.#R(t),this.#u.replaceChildren(),this.player.length=t.length,this.player.jump(t.length),this.#S()}#T(){this.#n.look={you:this.#m,
fog:this.#h.checked,viewers:this.#m===null?[]:[this.#m],plan:this.#_()}}#R(t){this.#y=null,this.#v=this.player.ticks=[],this.#p.hidden=this.#c.disabled=!!ze(t.config),
Yt(this.#e,t.config,Zt(t.config)).then(n=>{this.#a===t&&(this.#y=n,this.#C(),this.#S())})}#C(){let t=this.#a,n=this.#y;if(!n||this.element.dataset.state==="play\
ing")return;let r=this.#e.world(t.config);r.reset(t.start),this.#v=qt(n,r,t.actions),r.free(),this.player.ticks=Ko(this.#v)}get#M(){return this.#c.checked&&this.#l&&
this.element.dataset.state==="playing"&&this.#y&&this.#a.game(this.#y)||null}#_(){let t=this.#m,n=this.#m!==null&&this.#M?.marginal(this.#m);return t!==null&&n?
Object.assign(Array(t).fill(0),{[t]:n.indexOf(Math.max(...n))}):null}#x(){clearInterval(this.#w),this.#w=0,this.#o.ariaLive=Number(this.#i.value)?"off":"polite"}#E(){
let{policies:t,seat:n}=this.#l.played,r=this.#a;r.step(t,n,this.#b),this.#g.push(this.#b),this.player.length=r.length,this.player.glide=Math.min(.22,.9/(Number(
this.#i.value)||4)),this.player.move(r.length-this.player.step),on(r,n)&&this.#k()}#k(){this.#x();let t=this.#l,n=this.#a,r=this.played,o=ct()?t.link(r):null,s=`${Q(
r.seat,n.config.n_pursuers)}-${n.length}-steps.npz`,a=()=>Is(s,Ts(this.#e,n,r.seat)),i=Ps("Link to this match");i.hidden=!0,this.#u.replaceChildren(d("h3",{id:"\
play-headline"},vl(n,r.seat)),...t.ending(n,r),d("div",{class:"play-buttons"},d("button",{type:"button",class:"primary",onclick:()=>t.again()},"Again"),d("butto\
n",{type:"button",onclick:()=>this.#O()},"Watch it"),d("button",{type:"button",onclick:a},"Save"),o&&d("button",{type:"button",onclick:()=>Ls(i,o)},t.linkName??
"Link")),i),this.element.dataset.state="ended",this.player.jump(n.length),this.#C();let l=this.#v.filter(({team:c})=>c===le(n.config,r.seat));l.length&&this.#u.
children[0].after(d("p",{class:"small muted"},Yo(l))),this.#u.focus({preventScroll:!0}),this.#u.scrollIntoView({block:"nearest"})}#O(){this.element.dataset.state=
"watched",this.player.length=this.#a.length,this.player.jump(0),vt()||this.player.play()}#S(){let t=this.#a,n=this.#m,{step:r}=this.player;if(!t||r>t.length)return;
let o=_s(t,t.recording,r).filter(({agents:l})=>n===null||l.includes(n)),s=this.#l&&r===0,a=s?[gl(t.config,n),this.#l.about??""]:[`Step ${r} of ${t.config.max_steps}`,
...o.map(({text:l})=>l)];!s&&n!==null&&a.push(yl(t,r,n)),a.push(...this.#v.filter(l=>l.step===r).map(wt));let i=r===t.length&&n!==null?this.#M:null;i&&a.push(`P\
erfect play: ${Xt(i,n)||"decided in its turn"}; ${Jt(this.#y,i,r)}`),this.#T(),this.#o.textContent=a.filter(Boolean).map(l=>`${l}.`).join(" ")}};function gl(e,t){
let n=e.rules.capture==="SURROUND";return le(e,t)==="evader"?`Run away: you win if ${n?"the pursuers do not surround you":"no pursuer reaches your cell"} in ${e.
max_steps} steps`:`Capture evaders: ${n?"surround them with your team":"move onto their cells"}`}function yl({config:e,recording:t},n,r){let o=t.moments[n],s=le(
e,r),a=jo(s);if(!o.alive[r])return"";let i=C(o,r),l=m=>{let[p,h]=C(o,m);return Math.max(Math.abs(p-i[0]),Math.abs(h-i[1]))},c=Array.from({length:o.alive.length},
(m,p)=>p).filter(m=>le(e,m)===a&&o.alive[m]&&!o.captured[m-e.n_pursuers]&&2*l(m)<e.fov);if(!c.length)return`No ${a} in view`;let u=c.reduce((m,p)=>l(p)<l(m)?p:m);
return`Nearest ${a}: ${js(i,C(o,u))}`}function vl(e,t){let{lasted:n,out:r,captured:o}=we(e,t),{config:s}=e;return le(s,t)==="pursuer"?`Your team captured ${o} o\
f ${bl(s)} in ${n} steps.`:r?`You lasted ${n} of ${s.max_steps} steps.`:`You escaped: ${n} steps.`}var bl=({n_evaders:e})=>`${e} evader${e===1?"":"s"}`;var Hs={escape:"Can you escape it?",match:"One match",file:"A match from a file"},cn=class extends EventTarget{element;view;game="escape";#e;#n;#t;#r=lt([[0,"an\
 evader"],[1,"a pursuer"]],()=>{});#o;#s;#i;#h=d("ul",{class:"small muted about"});#c=d("p",{class:"problem",role:"alert"});#p=d("input",{type:"file",accept:".n\
pz",hidden:!0,onchange:()=>this.#g()});#d;constructor(t,n){super(),this.#e=t,this.#n=n,this.view=new ln(t),this.#t={pursuer:Gs(n,"pursuer"),evader:Gs(n,"evader")};
let r=o=>lt(this.#t[o].map(({name:s},a)=>[a,s]),()=>this.#f());this.#o={pursuer:r("pursuer"),evader:r("evader")};for(let o of de)this.#o[o].selectedIndex=n.teams[o].
usual;this.#s=d("div",{class:"of-match"},d("label",{},"You are ",this.#r),d("label",{},"Pursuers ",this.#o.pursuer),d("label",{},"Evaders ",this.#o.evader),d("b\
utton",{type:"button",class:"primary",onclick:()=>this.#l()},"Play"),this.#h),this.#i=d("div",{class:"of-match"},d("button",{type:"button",class:"primary",onclick:()=>this.#p.
click()},"Choose a file"),this.#p,d("span",{class:"small muted"},"A match that this page or matrixworld.Episode has saved (.npz)."),this.#c),this.#d=d("section",
{class:"card","aria-label":"Match"},this.view.element),this.element=d("section",{class:"games","aria-label":"Play"},d("div",{class:"card setup"},this.#s,this.#i),
this.#d)}begin(t){this.#u(t),t==="escape"?rr(this.#e,this.view,this.#n,this.#t.pursuer):t==="match"?this.#l():(this.view.stop(),this.#d.hidden=!0)}follow(t){let n=ks(
t,this.#n.world),r=Number(t.get("pursuers")??NaN),o=Number(t.get("evaders")??NaN),s=/^\d{1,20}$/.test(t.get("seed")??"")?BigInt.asUintN(64,BigInt(t.get("seed"))):
null;return!n||s===null||!this.#t.pursuer[r]||!this.#t.evader[o]?!1:(this.#o.pursuer.selectedIndex=r,this.#o.evader.selectedIndex=o,this.#r.selectedIndex=+(n.seat<
this.#n.world.n_pursuers),this.#u("match"),this.#a({pursuer:r,evader:o,seed:s},n),!0)}#u(t){this.game=t,this.#s.hidden=t!=="match",this.#i.hidden=t!=="file",this.#s.
parentElement.hidden=t==="escape",this.#d.hidden=!1,this.#c.textContent="",this.#f(),this.dispatchEvent(new Event("game"))}#f(){this.#h.replaceChildren(...de.map(
t=>{let{name:n,text:r}=this.#t[t][this.#o[t].selectedIndex];return d("li",{},d("span",{class:t},n),r&&`: ${r}`)}))}#l(){let{pursuer:t,evader:n}=this.#o,r=this.#r.
selectedIndex?0:this.#n.world.n_pursuers;this.#a({pursuer:t.selectedIndex,evader:n.selectedIndex,seed:nr()},{seat:r,from:0,moves:[]})}#a(t,n){let r=this.#n.world,
o=this.#t,s=de[+(n.seat>=r.n_pursuers)],a=o.pursuer[t.pursuer],i=o.evader[t.evader],l={pursuer:a.policy(),evader:i.policy()},c=`You are ${Q(n.seat,r.n_pursuers)}\
. Pursuers: ${a.name}; evaders: ${i.name}`;or(this.#e,this.view,{config:r,seed:t.seed,episode:0,policies:l,...n},{title:c,players:o[s],link:u=>Es({pursuers:t.pursuer,
evaders:t.evader,seed:t.seed},u)})}#g(){let[t]=this.#p.files??[];this.#c.textContent="",t?.arrayBuffer().then(n=>Cs(this.#e,new Uint8Array(n))).then(({live:n,seat:r})=>{
this.#u("file"),this.view.watch(n,r,t.name)}).catch(n=>this.#c.textContent=`${t.name} holds no match: ${n.message}`),this.#p.value=""}};function Gs({teams:e},t){
let{names:n,texts:r,scripts:o,policy:s}=e[t],a=i=>{let l=o[i];if(l||!s)return l;let c=s.genome_size,u=o.slice(0,i).filter(m=>m===null).length;return{...s,genome:vs(
t,c).subarray(u*c,(u+1)*c)}};return n.map((i,l)=>({name:i.replaceAll("-"," "),text:r[l],policy:()=>a(l)}))}var Ys={ArrowUp:1,ArrowRight:2,ArrowDown:3,ArrowLeft:4},wl={e:5,c:6,y:7,z:7,q:8};function Zs(e){let t=d("div",{class:"arena"}),n=[Ks(e,0),Ks(e,1)];return t.append(
...n.map(r=>r.element)),e.shownBy(()=>n.forEach(r=>r.update()),"frame"),t}function Ks(e,t){let n=d("canvas",{tabindex:0,"aria-describedby":"board-keys"}),r=d("h\
2",{class:"arm-name"}),o=d("figure",{class:"arm"},r,n),s=new Ke(n,{axes:!0,trail:1}),a={cell:[0,0]};xl(e,s);let i=()=>{let l=e.games[t];if(o.hidden=!l,!l)return;
let{mode:c,scene:u}=e;n.setAttribute("role","application"),n.ariaLabel=`Board, ${u.rows} by ${u.cols} cells`,n.dataset.mode=c,r.textContent=xe(e,t),r.hidden=e.games.
length<2;let m=e.player.arrived&&e.player.step===e.game.length;s.look={plan:c==="act"&&m&&!l.over?l.actions(u.next):null,selected:c==="act"?e.selected:null,cursor:c===
"build"&&document.activeElement===n?a.cell:null},s.show(l.recording,e.player.time)};return n.addEventListener("focus",i),n.addEventListener("blur",i),Tl(e,n,a,i),
{element:o,update:i}}function xe(e,t){let n=t?e.scene.others:e.scene.rules;return n&&Be(n,e.data.variants)||"own rules"}function ir(e,t){let n=te(e.game.scene())[t];
return n&&!n.gone?n.cell:null}function xl(e,t){let n=null;t.canvas.addEventListener("pointerdown",r=>{let o=t.cellAt(r.clientX,r.clientY);if(!o||r.button!==0||e.
running)return;t.canvas.setPointerCapture(r.pointerId);let s=t.agentAt(r.clientX,r.clientY);n=e.mode==="build"?Al(e,o,s):Sl(e,o,s)}),t.canvas.addEventListener("\
pointermove",r=>{let o=t.cellAt(r.clientX,r.clientY);o&&n?.(o)});for(let r of["pointerup","pointercancel"])t.canvas.addEventListener(r,()=>n=null)}function Sl(e,t,n){
if(n===null){let s=e.selected===null?null:ir(e,e.selected);return s&&Math.max(Math.abs(s[0]-t[0]),Math.abs(s[1]-t[1]))===1&&qe(e,ht(s,t,e.scene.diagonal)),null}
let r=e.selected===n;e.selected=n;let o=ir(e,n);return o?(r&&qe(e,0),s=>qe(e,ht(o,s,e.scene.diagonal))):null}function Al(e,t,n){let r=!1,o=i=>{e.change(i,{part:r}),
r=!0};if(n!==null)return e.selected=n,i=>{let l=e.game.scene();ye(l,i)===null&&!ve(l,i)&&o(kn(l,n,i))};let s=!ve(e.game.scene(),t),a=i=>{let l=e.game.scene();ye(
l,i)===null&&ve(l,i)!==s&&o(On(l,i,s))};return a(t),a}function qe(e,t){let{selected:n,scene:r}=e;n===null||e.running||e.game.over||(r.next[n]!==t&&e.change($t(r,
n,t)),e.say(`${ne(r,n)}: ${B[t]}.`))}function Tl(e,t,n,r){t.addEventListener("keydown",o=>{if(o.ctrlKey||o.metaKey||o.altKey)return;let s=e.mode==="act"?lr(e,o):
Cl(e,o,n);r(),s&&o.preventDefault()})}function lr(e,t){let n=t.key.length===1?t.key.toLowerCase():t.key,r=Ys[n]??(e.scene.diagonal?wl[n]:void 0)??{s:0,Delete:0}[n];
return r!==void 0?(e.selected===null&&Vs(e,1),qe(e,r),!0):n!=="n"&&n!=="p"?!1:(Vs(e,n==="n"?1:-1),!0)}function Vs(e,t){let n=V(e.scene),r=e.game.recording.moments.
at(-1).alive,o=e.selected??(t>0?-1:n);for(let s=0;s<n;s++){if(o=(o+t+n)%n,!r[o])continue;e.selected=o;let[a,i]=ir(e,o);return e.say(`${ne(e.scene,o)} at (${a}, ${i}\
).`)}}function Cl(e,t,n){let r=e.game.scene(),o=Ys[t.key];if(o!==void 0){let a=t.shiftKey?ye(r,n.cell):null,i=[n.cell[0]+ue[o][0],n.cell[1]+ue[o][1]];ft(r,i)&&(n.
cell=i);let l=ye(r,n.cell)===null&&!ve(r,n.cell);a!==null&&l&&e.change(kn(r,a,n.cell));let[c,u]=n.cell;return e.say(`(${c}, ${u}): ${Ml(e,n.cell)}.`),!0}let s=ye(
r,n.cell);return t.key===" "||t.key==="Enter"?(s===null?e.change(On(r,n.cell,!ve(r,n.cell))):e.selected=s,!0):t.key==="Delete"&&s!==null?(e.change(Ut(r,s)),!0):
!1}function Ml(e,t){let n=e.game.scene(),r=ye(n,t);return r!==null?ne(n,r):ve(n,t)?"obstacle":"free"}function cr(e){let t=e==="pursuers"?Te("path",{d:"M12 3 22 20H2z"}):Te("circle",{cx:12,cy:12,r:9.5});return Te("svg",{viewBox:"0 0 24 24",class:`glyph ${e}`,"ar\
ia-hidden":!0},t)}function qs(e){let t=[0,1].map(()=>d("th",{class:"reward",scope:"col"})),n=d("tbody"),r=d("table",{class:"agents"},d("thead",{},d("tr",{},d("t\
h",{scope:"col"},"agent"),d("th",{scope:"col"},"next"),...t)),n),o=d("section",{class:"card agents-card"},d("h2",{},"Agents"),e.data.champions?d("button",{type:"\
button",title:"The policies of the match move all agents but the chosen one",onclick:()=>El(e)},"Policies move all others"):"",d("div",{class:"agents-scroll"},r)),
s=[],a="",i=()=>{let{scene:l}=e,c=`${l.pursuers.length} ${l.evaders.length} ${l.diagonal}`;c!==a&&(a=c,s=Array.from({length:V(l)},(u,m)=>kl(e,m)),n.replaceChildren(
...s.map(u=>u.element))),t.forEach((u,m)=>{u.hidden=m>=e.games.length,u.textContent=e.games.length>1&&e.games[m]?xe(e,m):"reward",u.title="Reward of the step"}),
s.forEach((u,m)=>Rl(e,u,m))};return e.shownBy(i),o}function El(e){e.stop(),e.change({...e.scene,next:e.scene.next.map((t,n)=>n===e.selected?t:ge)})}function kl(e,t){
let{scene:n}=e,r=ne(n,t),o=d("select",{"aria-label":`${r} does next`,onchange:()=>{let u=o.value;e.stop(),e.change($t(e.scene,t,/^\d$/.test(u)?Number(u):u))}},...Ol(
e,n,t)),s=d("span",{class:"state muted"}),a=d("span",{class:"heard"}),i=d("button",{type:"button",class:"agent-name",onclick:()=>e.selected=t},cr(Mn(n,t)),r,a),
l=[0,1].map(()=>d("td",{class:"reward numbers"}));return{element:d("tr",{},d("th",{scope:"row"},i),d("td",{},o,s),...l),choice:o,state:s,heard:a,rewards:l}}function Ol(e,t,n){
let r=B.slice(0,t.diagonal?9:5).map((i,l)=>d("option",{value:l},$s(l))),o=e.data.scripts.map(({name:i,text:l})=>d("option",{value:i,title:l},i)),s=[d("optgroup",
{label:"move"},...r),d("optgroup",{label:"script"},...o)],a=e.data.champions?.[n<t.pursuers.length?"pursuer":"evader"];return a?[d("option",{value:ge},a.name),...s]:
s}function Rl(e,{element:t,choice:n,state:r,heard:o,rewards:s},a){let{scene:i,game:l,player:c}=e,u=l.recording.moments[Math.min(c.step,l.length)],m=a-i.pursuers.
length,p=m>=0&&!!u.captured[m];t.classList.toggle("chosen",e.selected===a),t.classList.toggle("gone",!u.alive[a]),n.value=String(i.next[a]),n.disabled=!u.alive[a]||
l.over,n.hidden=!u.alive[a],r.hidden=!!u.alive[a],r.textContent=p?"captured":"gone",t.classList.toggle("captured",p),o.textContent=p?" captured":"",s.forEach((h,f)=>{
let g=e.games[f];h.hidden=!g;let y=g?.outcomes[c.step]?.rewards[a],v=g?zs(i,g,c.step,a):"";h.replaceChildren(c.step&&y!==void 0?an(y):"",e.games.length>1?"":d("\
span",{class:"sum small muted"},v)),h.title=v;let x=l.outcomes[c.step]?.rewards[a];h.classList.toggle("differs",f>0&&y!==void 0&&x!==y)})}function Js(e){let t=e.data.gallery.map(i=>d("button",{type:"button",class:"chip",onclick:()=>{e.stop(),e.mode="act",e.change(mt(i.scene,e.data),{example:i}),e.
selected=0}},i.title)),n=d("p",{class:"example-text"}),r=d("p"),o=d("details",{class:"reveal"},d("summary",{},"Reveal"),r),s=d("nav",{class:"gallery","aria-labe\
l":"Examples"},d("div",{class:"chips"},...t),n,o),a;return e.shownBy(()=>{e.data.gallery.forEach((i,l)=>t[l].setAttribute("aria-pressed",String(i===e.example))),
n.replaceChildren(...Ot(e.example?.ask??"A scene of your own. Choose an example, or change this one.")),r.replaceChildren(...Ot(e.example?.text??"")),o.hidden=!e.
example,a!==e.example&&(o.open=!1),a=e.example}),s}function Xs(e){let t=_l(e),n=Nl(e),r=Ll(e),o=Pl(e),s=d("p",{class:"message",role:"status"});e.addEventListener("message",i=>{let{text:l,problem:c}=i.detail;s.textContent=
l,s.classList.toggle("problem",c)});let a=[t,n,r,o];return e.addEventListener("change",()=>{s.textContent="",s.classList.remove("problem")}),e.shownBy(()=>a.forEach(
i=>i.update())),d("div",{class:"toolbar"},...a.map(i=>i.element),s)}function un(e,t,n,r){return d("button",{type:"button",title:`${t} (${n})`,onclick:r},Et(e),d(
"span",{},t))}function _l(e){let t=un("first","Restart","Home",()=>e.restart()),n=un("back","Back","Backspace",()=>e.back()),r=un("forward","Step","Enter",()=>e.
step()),o=un("play","Run","Space",()=>e.run());return r.classList.add("primary"),r.id="step",{element:d("div",{class:"buttons",role:"group","aria-label":"Steps"},
t,n,r,o),update:()=>{for(let s of[t,n])s.setAttribute("aria-disabled",String(!e.game.length));r.setAttribute("aria-disabled",String(!e.canStep)),o.setAttribute(
"aria-disabled",String(!e.canStep&&!e.running)),o.replaceChildren(Et(e.running?"pause":"play"),d("span",{},e.running?"Stop":"Run"))}}}function Nl(e){let t={act:"\
Move",build:"Build"},n={act:"Choose agents and their moves (M)",build:"Place agents and draw obstacles (M)"},r=Object.keys(t),o=r.map(s=>d("button",{type:"butto\
n",title:n[s],onclick:()=>e.mode=s},t[s]));return{element:d("div",{class:"buttons joined",role:"group","aria-label":"What the board does"},...o),update:()=>r.forEach(
(s,a)=>o[a].setAttribute("aria-pressed",String(e.mode===s)))}}function Pl(e){let t=(s,a,i)=>d("button",{type:"button",title:`Add ${a} (${i})`,"aria-label":`Add ${a}`,
onclick:()=>dn(e,s)},"+",cr(s)),n=d("button",{type:"button",title:"Remove the chosen agent (Delete)",onclick:()=>ur(e)},"Remove"),r=[t("pursuers","a pursuer","+"),
t("evaders","an evader","-"),n],o=d("div",{class:"buttons",role:"group","aria-label":"Agents"},...r);return{element:o,update:()=>{o.hidden=e.mode!=="build",n.setAttribute(
"aria-disabled",String(e.selected===null))}}}function Ll(e){let t=[8,7,4,1,0,3,2,5,6],n=t.map(o=>d("button",{type:"button","aria-label":B[o],title:`The chosen a\
gent: ${B[o]}`,onclick:()=>qe(e,o)},kt[o])),r=d("div",{class:"buttons pad",role:"group","aria-label":"Move of the chosen agent"},...n);return{element:r,update:()=>{
r.hidden=e.mode==="build";let o=e.selected===null?void 0:e.scene.next[e.selected];t.forEach((s,a)=>{let i=n[a];i.hidden=s>4&&!e.scene.diagonal,i.setAttribute("a\
ria-disabled",String(e.selected===null||e.game.over)),i.setAttribute("aria-pressed",String(o===s))})}}}function Qs(e){let t=d("button",{type:"button",title:"Und\
o the last change (Ctrl+Z)",onclick:()=>e.undo()},"Undo");return e.shownBy(()=>t.setAttribute("aria-disabled",String(!e.canUndo))),t}function dn(e,t){let n=e.game.
scene(),r=Yr(n);if(!r)return e.say("Every cell is taken.",!0);if(n[t].length>=We)return e.say(`${t}: expected at most ${We}`,!0);let o=t==="pursuers"?n.pursuers.
length:V(n);e.change(Kr(n,t,r))&&(e.selected=o)}function ur(e){let{selected:t}=e;if(t===null)return e.say("Choose an agent to remove.",!0);let n=Ut(e.game.scene(),
t);n.pursuers.length&&n.evaders.length?e.change(n):e.say("A team needs at least one agent.",!0)}function ea(e,t,n){let r=Object.keys(e.data.variants),o={Enter:()=>e.step(),Backspace:()=>e.back(),Home:()=>e.restart()," ":()=>e.run(),m:()=>e.mode=e.mode==="a\
ct"?"build":"act",d:Tn,"?":t},s={"+":()=>dn(e,"pursuers"),"-":()=>dn(e,"evaders"),Delete:()=>ur(e)};document.addEventListener("keydown",a=>{if(!n()||a.defaultPrevented||
document.querySelector("dialog[open]"))return;let i=a.key.length===1?a.key.toLowerCase():a.key;if((a.ctrlKey||a.metaKey)&&!a.altKey){let u={z:()=>a.shiftKey?e.redo():
e.undo(),y:()=>e.redo()}[i];u&&!ta(a.target)&&(a.preventDefault(),u());return}if(a.altKey||Il(a.target,i))return;let l=r[Number(i)-1],c=o[i]??(e.mode==="build"?
s[i]:void 0);if(c)c();else if(l)e.change({...e.scene,rules:e.data.variants[l]});else if(e.mode!=="act"||!lr(e,a))return;a.preventDefault()})}var ta=e=>e instanceof
HTMLInputElement&&!["radio","checkbox"].includes(e.type);function Il(e,t){return ta(e)||e instanceof HTMLSelectElement?!0:e instanceof HTMLInputElement?t===" "||
t.startsWith("Arrow"):e instanceof HTMLButtonElement?t===" "||t==="Enter":e instanceof HTMLElement&&e.classList.contains("story-body")&&t.startsWith("Arrow")}var $l=[
[["Enter"],"play a step"],[["Backspace"],"take the last step back"],[["Home"],"back to the start"],[["Space"],"run, or stop"],[["N","P"],"choose the next agent,\
 or the one before"],[["↑","→","↓","←"],"the chosen agent moves there next"],[["Q","E","C","Y"],"the same on a diagonal, where the board allows it"],[["\
S"],"the chosen agent stays"],[["1","… 9"],"choose a variant"],[["M"],"change between Move and Build"],[["Ctrl Z","Ctrl Y"],"undo, redo"],[["D"],"light or dar\
k"],[["?"],"these keys"]],Ul=[[["↑","→","↓","←"],"move the cursor on the board"],[["Space"],"draw or erase an obstacle, or choose the agent there"],[["S\
hift ↑"],"carry the agent under the cursor"],[["+","-"],"add a pursuer, an evader"],[["Delete"],"remove the agent under the cursor"]],na=()=>Ns("Keys","",d("d\
iv",{class:"keys-columns"},d("div",{},d("h3",{},"Anywhere"),sr($l)),d("div",{},d("h3",{},"On the board, in Build"),sr(Ul),d("h3",{},"With mouse or finger"),d("p",
{},"Move: press an agent and drag it towards a cell beside it, or choose it and press that cell."),d("p",{},"Build: drag agents; draw on free cells to make obst\
acles, on obstacles to erase them."))));function ra(e){let t=d("ul",{class:"lines","aria-live":"polite"}),n=d("details",{class:"card perfect"},d("summary",{},d("h2",{},"Perfect play")),t,d("p",{class:"\
small muted"},"A team is one player here. An agent's shares are its part of the joint moves.")),r=0,o=(...a)=>t.replaceChildren(...a.filter(Boolean).map(i=>d("l\
i",{class:"line"},`${i}.`))),s=async()=>{let a=++r;if(!n.open)return;let i=ze(Fe(e.scene,e.scene.rules));if(i)return o(`Not known: ${i}`);let l=await e.solution();
if(a!==r||!l)return;let{game:c,losses:u}=e.game.perfect(l),m=Array.from({length:V(e.scene)},(h,f)=>{let g=c&&Xt(c,f);return g?`${ne(e.scene,f)}: ${g}`:""}),p=e.
game.over?"The episode has ended":"Not known: no start on distinct free cells leads to this moment";o(...u.map(h=>`In the last step: ${wt(h)}`),c?`From here: ${Jt(
l,c,e.game.length)}`:p,...m)};for(let[a,i]of[[e,"change"],[n,"toggle"]])a.addEventListener(i,()=>{s()});return n}function oa(e){let t=[zl(e),...e.data.fields.map(n=>Wl(e,n)),Bl(e),Fl(e)];return e.shownBy(()=>t.forEach(n=>n.update())),d("section",{class:"card rules"},...t.map(
n=>n.element))}var Je=(e,t)=>{e.stop(),e.change(t)};function zl(e){let t=Object.keys(e.data.variants),n=t.map(o=>d("button",{type:"button",class:"chip",title:e.
data.titles[o],onclick:()=>Je(e,{...e.scene,rules:e.data.variants[o]})},o)),r=d("p",{class:"muted small variant-title"});return{element:d("div",{class:"variants"},
d("h2",{},"Rules"),d("div",{class:"chips",role:"group","aria-label":"Variant"},...n),r),update:()=>{let o=Be(e.scene.rules,e.data.variants);t.forEach((s,a)=>n[a].
setAttribute("aria-pressed",String(s===o))),r.textContent=o?e.data.titles[o]:"Rules of your own"}}}function Wl(e,t){let n=t.values.map(({name:a})=>d("input",{type:"\
radio",name:t.name,value:a,onchange:()=>Je(e,{...e.scene,rules:Dl(e.scene.rules,t,a)})})),r=t.values.map(({label:a},i)=>d("label",{},n[i],d("span",{},a))),o=d("\
span",{class:"used-mark",title:"This rule decided what happened in the step that is shown"},d("span",{},"decided")),s=d("fieldset",{class:"field",title:t.text},
d("legend",{},t.label,o),d("div",{class:"segments"},...r));return{element:s,update:()=>{let{rules:a}=e.scene;n.forEach(l=>l.checked=l.value===String(a[t.name])),
s.disabled=t.name==="captured_disappear"&&a.capture==="OCCUPATION";let i=Math.min(e.player.step,e.game.length);o.hidden=!sn(e.scene,e.game,i).some(l=>l.used.includes(
t.name))||s.disabled}}}function Dl(e,t,n){return{...e,[t.name]:n==="true"?!0:n==="false"?!1:n}}function Bl(e){let t=Object.keys(e.data.variants),r=d("select",{id:"\
compare",onchange:()=>{let o={"":null,present:e.scene.rules}[r.value];Je(e,{...e.scene,others:o===void 0?e.data.variants[r.value]:o})}},d("option",{value:""},"n\
othing"),d("option",{value:"present"},"the present rules"),d("option",{value:"own",hidden:!0},"own rules"),...t.map(o=>d("option",{value:o},`${o}: ${e.data.titles[o]}`)));
return{element:d("div",{class:"pair"},d("label",{for:"compare"},"Compare with"),r),update:()=>{let{others:o}=e.scene,s=o&&t.find(a=>En(o,e.data.variants[a]));r.
value=o?s??"own":"",r.title=o?`Both boards play the same moves: ${xe(e,0)} and ${xe(e,1)}`:""}}}function Fl(e){let t=(a,i)=>{let l=d("input",{type:"number",min:1,
max:Me,"aria-label":i,onchange:()=>{let c={rows:e.scene.rows,cols:e.scene.cols,[a]:Math.round(Number(l.value))};c[a]>=1&&c[a]<=Me?jl(e,c.rows,c.cols):e.say(`${a}\
: expected 1 to ${Me}, got ${l.value||"nothing"}`,!0),l.value=String(e.scene[a])}});return l},n=t("rows","Rows"),r=t("cols","Columns"),o=d("input",{type:"checkb\
ox",id:"diagonal",onchange:()=>Je(e,{...e.game.scene(),diagonal:o.checked,next:e.scene.next.map(a=>typeof a=="number"&&a>4?0:a)})}),s=d("select",{id:"rewards",onchange:()=>Je(
e,{...e.scene,rewards:e.data.rewards[s.value]})},...Object.keys(e.data.rewards).map(a=>d("option",{value:a},a)),d("option",{value:"own",hidden:!0},"those of the\
 link"));return{element:d("div",{class:"board-settings"},d("div",{class:"pair"},d("span",{},"Board"),d("span",{class:"sides"},n,"×",r),d("label",{class:"sides"},
o,"diagonal")),d("div",{class:"pair"},d("label",{for:"rewards"},"Rewards"),s)),update:()=>{let{scene:a}=e;document.activeElement!==n&&(n.value=String(a.rows)),document.
activeElement!==r&&(r.value=String(a.cols)),o.checked=a.diagonal;let i=JSON.stringify(a.rewards);s.value=Object.keys(e.data.rewards).find(l=>JSON.stringify(e.data.
rewards[l])===i)??"own"}}}function jl(e,t,n){let r=Vr(e.game.scene(),t,n);r.pursuers.length&&r.evaders.length?Je(e,r):e.say(`No ${r.pursuers.length?"evader":"pu\
rsuer"} would be left on a ${t} × ${n} board.`,!0)}var sa={obstacle:"obstacle",teammate:"teammates",adversary:"adversaries",capture:"capture",end:"end",calm:""};function aa(e){let t=d("h2"),n=d("div",{class:"sto\
ry-body",tabindex:0,role:"region","aria-label":"What happened"}),r=d("div",{class:"heard",role:"status"}),o=d("section",{class:"card story"},t,n,r),s="";return e.
shownBy(()=>{let a=Math.min(e.player.step,e.game.length),i=e.games.map((c,u)=>{let m=sn(e.scene,c,a);return{name:e.games.length>1?xe(e,u):"",lines:m,ended:a>c.length}}),
l=JSON.stringify([a,i]);l!==s&&(s=l,t.textContent=a?`Step ${a}`:"Start",n.replaceChildren(...i.map(c=>Gl(c,a))),r.textContent=a?`Step ${a}. ${i.map(Kl).join(" ")}`:
"")}),o}function Gl({name:e,lines:t,ended:n},r){let s=n||!r?d("p",{class:"muted"},n?"The episode had ended.":"Give agents their moves, then play a step."):d("ul",
{class:"lines"},...t.map(Hl));return d("div",{class:"story-part"},e&&d("h3",{},e),s)}function Hl({kind:e,text:t,turn:n,blame:r,cost:o}){let s=n?`${sa[e]}, turn ${n}`:
sa[e];return d("li",{class:`line line-${e}`},s&&d("span",{class:"tag"},s),d("span",{class:"line-text"},...Ot(t)),r&&d("span",{class:"line-blame muted"},r),o&&d(
"strong",{},o))}var Kl=({name:e,lines:t,ended:n})=>[e,...n?["The episode had ended."]:t.map(({text:r,blame:o,cost:s})=>[r,o,s].filter(Boolean).join(" "))].filter(
Boolean).join(" ");function ia(e,t){let n=na(),r=()=>n.showModal();return ea(e,r,t),{element:d("section",{class:"scene","aria-label":"Rules and conflicts"},Js(e),d("div",{class:"l\
ayout"},oa(e),d("section",{class:"card stage","aria-label":"Board"},Zs(e),Xs(e)),d("div",{class:"side"},aa(e),qs(e),ra(e)))),tools:[Qs(e),d("button",{type:"butt\
on",title:"Keys (?)","aria-label":"Keys (?)",onclick:r},"?")],dialog:n}}var la={...Hs,scene:"Rules and conflicts"},ca={games:"You move one agent. Scripts, or policies that evolved, move all others.",scene:"Give agents their moves, p\
redict what happens, and play the step."};async function Vl(e){let t=Qo(),n=await zr(),r=Re(),{store:o,problem:s}=Zo(n,t,xt(r)?t.scene:r||t.scene),a=t.play&&new cn(
n,t.play),i="scene",l=ia(o,()=>i==="scene"),c=d("span"),u=Object.keys(la),m=u.map(f=>d("button",{type:"button",onclick:()=>f==="scene"?p(f):a.begin(f)},la[f])),
p=f=>{i=f;let g=i==="scene";u.forEach((y,v)=>m[v].setAttribute("aria-pressed",String(y===i)));for(let y of[l.element,...l.tools])y.hidden=!g;a&&(a.element.hidden=
g),c.textContent=g?ca.scene:ca.games,g?a?.view.stop():o.stop(),ct()&&(g?o.dispatchEvent(new Event("change")):history.replaceState(null,"",location.href.split("#")[0]))},
h=f=>xt(f)&&!!a?.follow(new URLSearchParams(f));a?.addEventListener("game",()=>p(a.game)),e.classList.add("playground"),e.replaceChildren(jr("Playground",c,...l.
tools),d("nav",{class:"tabs buttons","aria-label":"What to play",hidden:!a},...m),d("main",{},a&&a.element,l.element),d("footer",{class:"muted small"},`${t.title}\
 · matrixworld ${t.version}`),l.dialog),document.addEventListener("keydown",f=>i!=="scene"&&a.view.key(f)&&f.preventDefault()),ct()&&Xo(o,()=>i==="scene",()=>p(
"scene")),window.addEventListener("hashchange",()=>h(Re())),h(r)||(a&&!t.scene&&(!r||xt(r))?a.begin("escape"):p("scene")),s&&o.say(s,!0),Object.assign(window,{playground:o,
matrixworldPlay:a?.view})}Dr(Vl(document.getElementById("page")));})();
