/* built from web/ by "npm run build"; sources 637dcc609ddcbfe705272d79515cbc7778461d40c614fda4d0efe9b586fdd0d8 */
"use strict";(()=>{var dt={SIMULTANEOUS:0,SWARM_TURNS:1,AGENT_TURNS:2},J={DISAPPEAR:0,REACH:1,BOUNCE:2},ut={OCCUPATION:0,SURROUND:1},pt={FAULT:0,INVOLVED:1};var mt=["obstacle","teammate","adversary"],Ie=["vertex","edge","chain"],ht=["turn","kind","form","first","second","row","col","at_fault","held","doomed"],Pe=["p\
ursuer_{number}","evader_{number}"],ft={obstacle:"{first} ran into the obstacle or border at {cell}",vertex:"{first} and {second} both headed for {cell}",edge:"\
{first} and {second} meant to swap, {first} to {cell}",chain:"{first} headed for {cell}, where {second} had to stay"},X={"both held":"both bounce","both doomed":"\
both disappear",held:"{agent} bounces",doomed:"{agent} disappears",none:"nobody is stopped"},gt="{event}: {outcome}",Ue={random:"any action, all equally likely",
still:"always stays",chaser:"moves to where the nearest adversary in view is nearest",fleer:"moves to where the nearest adversary in view is farthest","clumsy-c\
haser":"a chaser that takes any action in half of the steps","clumsy-fleer":"a fleer that takes any action in half of the steps",hunter:"a chaser of the nearest\
 adversary in view to which no teammate in view is nearer",surrounder:"a chaser of the nearest free cell beside an adversary in view without a teammate",dodger:"\
moves to where all adversaries in view together are farthest; each cell that holds some weighs 2**14 // (1 + moves)**2"},bt={free:".GS",blocked:"#@OTW"};var B=1+ht.length;function Z(e,t){return e.replace(/\{(\w+)\}/g,(r,n)=>String(t[n]))}function $e(e,t){return e<t?Z(Pe[0],{number:e}):Z(Pe[1],{number:e-t})}function cn(e,t){
let[r,n,o,s,a,i,l,...d]=Array.from(e),u=a<0?[s]:[s,a],[p,h,m]=d.map(C=>u.filter(($,D)=>C>>D&1)),g=u.map(C=>$e(C,t)),f=Z(ft[a<0?"obstacle":Ie[o]],{first:g[0],second:g[g.
length-1],cell:`(${i}, ${l})`}),w=Z(gt,{event:f,outcome:dn(u.length,h,m,t)});return{kind:mt[n],form:Ie[o],agents:u,cell:[i,l],at_fault:p,held:h,doomed:m,turn:r,
text:w}}function dn(e,t,r,n){if(e===2&&t.length===2)return X["both held"];if(e===2&&r.length===2)return X["both doomed"];let o=s=>a=>Z(X[s],{agent:$e(a,n)});return[
...t.map(o("held")),...r.map(o("doomed"))].join(", ")||X.none}function de(e,t){let r=[];for(let n=0;n<e.length;n+=B)r.push(cn(e.subarray(n+1,n+B),t));return r}var x=class extends Error{name="EngineError"};function y(e,t,r){let n=typeof r=="string"?`'${r}'`:typeof r=="object"?JSON.stringify(r):String(r);return new x(`${e}\
: expected ${t}, got ${n}`)}var H=class{bytes;constructor(t){this.bytes=t}},wt=0,Be=[Uint8Array,Uint8Array,Int32Array,BigInt64Array,BigUint64Array,Float32Array,Float64Array],yt=4,vt=4,un=new TextEncoder,
pn=new TextDecoder;function mn(e){for(let t=Be.length-1;t>wt;--t)if(e instanceof Be[t])return t;throw new TypeError("array: expected a typed array of the engine\
's numbers, got another")}function De(e){return new Uint8Array(e.buffer,e.byteOffset,e.byteLength)}function hn(e){return un.encode(`${e}\0`)}var He=class{engine;addresses=[];constructor(t){
this.engine=t}copy(t){let r=this.engine._malloc(Math.max(t.length,1));if(r===0)throw new x("memory: expected room for the arguments, got none");return this.addresses.
push(r),this.engine.HEAPU8.set(t,r),r}text(t){return this.copy(hn(t))}arrays(t){let r=Object.entries(t),n=r.flatMap(([s,a])=>{let i=a instanceof H,l=i?a.bytes:a;
return[this.text(s),i?wt:mn(l),l.length,this.copy(De(l))]}),o=this.copy(De(Int32Array.from(n)));return this.copy(De(Int32Array.of(r.length,o)))}free(){for(let t of this.
addresses)this.engine._free(t)}};function St(e,t){let r=e.HEAPU8;return pn.decode(r.subarray(t,r.indexOf(0,t)))}function ue(e){let t=new Int32Array(e.HEAPU8.buffer),
r=e._last_outputs()/yt,n=t[r+1]/yt,o={};for(let s=n;s<n+t[r]*vt;s+=vt){let a=Be[t[s+1]],i=t[s+2]*a.BYTES_PER_ELEMENT,l=t[s+3];o[St(e,t[s])]=new a(e.HEAPU8.slice(
l,l+i).buffer)}return o}function Q(e,t){let r=new He(e);try{let n=t(r);if(n===0)throw new x(St(e,e._last_error()));return n}finally{r.free()}}var fn=2**31-1,gn=2n**64n-1n,bn=34028234663852886e22;function M(e,t){if(typeof t!="number"||!Number.isInteger(t)||Math.abs(t)>fn)throw y(e,"an integer",t);return Int32Array.
of(t)}function pe(e,t){if(typeof t!="boolean")throw y(e,"true or false",t);return new H(Uint8Array.of(Number(t)))}function L(e,t,r){let n=typeof t=="string"&&Object.
hasOwn(r,t)?r[t]:void 0;if(n===void 0)throw y(e,`one of ${Object.keys(r).join(", ")}`,t);return Int32Array.of(n)}function We(e,t){if(typeof t!="number"||!(Math.
abs(t)<=bn))throw y(e,"a finite number",t);return t}function W(e,t){let n=typeof t=="bigint"||typeof t=="number"&&Number.isSafeInteger(t)?BigInt(t):-1n;if(n<0n||
n>gn)throw y(e,"an integer from 0 to 2^64 - 1",t);return BigUint64Array.of(n)}function yn(e){return{"rules.interaction":L("interaction",e.interaction,dt),"rules\
.obstacle":L("obstacle",e.obstacle,J),"rules.teammate":L("teammate",e.teammate,J),"rules.evader":L("evader",e.evader,J),"rules.pursuer":L("pursuer",e.pursuer,J),
"rules.capture":L("capture",e.capture,ut),"rules.captured_disappear":pe("captured_disappear",e.captured_disappear)}}function xt(e,t){let r=typeof t=="number"?[t,
t,t]:t;if(!Array.isArray(r)||r.length!==3)throw y(e,"1 or 3 numbers",t);return Float32Array.from(r,n=>We(e,n))}function vn(e){let t=(r,n)=>Float32Array.of(We(r,
e[r]),We(n,e[n]));return{"rewards.capture":t("pursuer_capture","evader_capture"),"rewards.neighbor":t("pursuer_neighbor","evader_neighbor"),"rewards.step":t("pu\
rsuer_step","evader_step"),"rewards.pursuer_collide":xt("pursuer_collide",e.pursuer_collide),"rewards.evader_collide":xt("evader_collide",e.evader_collide),"rew\
ards.blame":L("blame",e.blame,pt),"rewards.capture_repeats":pe("capture_repeats",e.capture_repeats)}}function Et(e){if(e===void 0||typeof e=="number")return new Uint8Array(
0);if(e instanceof Uint8Array)return e;let{free:t,blocked:r}=bt;for(let[n,o]of e.entries()){if(o.length!==e[0]?.length)throw y(`map, row ${n}`,`${e[0]?.length} \
cells as in row 0`,o.length);let s=[...o].find(a=>!t.includes(a)&&!r.includes(a));if(s)throw y(`map, row ${n}`,`'${t}' (free) or '${r}' (obstacle)`,s)}return Uint8Array.
from([...e.join("")],n=>Number(r.includes(n)))}function _t(e,t){if(!Array.isArray(e))return;let r=[e.length,e[0]?.length??0];if(!(r[0]===t.rows&&r[1]===t.cols))
throw y("obstacle map",`shape (${t.rows}, ${t.cols}), the rows and cols`,r)}function me(e){_t(e.obstacles,e);let t=typeof e.obstacles=="number"?e.obstacles:0;return{
...yn(e.rules),...vn(e.rewards),rows:M("rows",e.rows),cols:M("cols",e.cols),n_pursuers:M("n_pursuers",e.n_pursuers),n_evaders:M("n_evaders",e.n_evaders),fov:M("\
fov",e.fov),diagonal:pe("diagonal",e.diagonal),max_steps:M("max_steps",e.max_steps),density:Float64Array.of(t),map:Et(e.obstacles)}}function At(e,t){return Int32Array.
from((t??[]).flat(),r=>M(e,r)[0])}function Ct(e,t){return _t(e.obstacles,t),{seed:W("seed",e.seed??0n),episode:W("episode",e.episode??0),pursuers:At("pursuers",
e.pursuers),evaders:At("evaders",e.evaders),map:Et(e.obstacles)}}function he(e){return{actions:Int32Array.from(e,t=>M("actions",t)[0])}}function F(e){if(typeof e==
"string"){if(!Object.hasOwn(Ue,e))throw y("policy",`one of ${Object.keys(Ue).join(", ")}`,e);return{script:new TextEncoder().encode(e)}}if(e.activation!=="relu"&&
e.activation!=="tanh")throw y("activation","'relu' or 'tanh'",e.activation);return{hidden:Int32Array.from(e.hidden,t=>M("hidden",t)[0]),activation:new TextEncoder().
encode(e.activation),sampled:pe("sampled",e.sampled),genome:e.genome}}var wn=["first_turn","terminated","truncated"];function Mt(e){let t={...e};for(let r of wn)
t[r]=new H(e[r]);return t}var fe=class{config;seed;episode;n_agents;statistics;positions;last_positions;alive;captured;ever_captured;actions;rewards;involved;fault;map;conflict_table;first_conflict;constructor(t,r,n,o){
this.config=t,this.seed=r,this.episode=n,this.n_agents=t.n_pursuers+t.n_evaders,this.statistics=Tt(o,0),this.positions=o.positions,this.last_positions=o.last_positions,
this.alive=o.alive,this.captured=o.captured,this.ever_captured=o.ever_captured,this.actions=o.actions,this.rewards=o.rewards,this.involved=o.involved,this.fault=
o.fault,this.map=o.map,this.conflict_table=o.conflict_table,this.first_conflict=Sn(this.conflict_table,this.length)}get length(){return this.actions.length/this.
n_agents}conflicts(t){this.check(t);let[r,n]=[this.first_conflict[t],this.first_conflict[t+1]],o=this.conflict_table.subarray(r*B,n*B);return de(o,this.config.n_pursuers)}seek(t,r){
this.check(r),(!(t.seed===this.seed&&t.episode===BigInt(this.episode))||t.turn!==0||t.steps>r)&&t.reset({seed:this.seed,episode:this.episode});for(let o=t.steps;o<
r;++o)t.step(this.actions.subarray(o*this.n_agents,(o+1)*this.n_agents))}check(t){if(!(Number.isInteger(t)&&t>=0&&t<=this.length))throw y("step",`0 to ${this.length}`,
t)}};function Sn(e,t){let r=new Int32Array(t+2);for(let n=0;n<e.length;n+=B)++r[e[n]+1];for(let n=1;n<r.length;++n)r[n]+=r[n-1];return r}function Tt(e,t){let r=e["\
statistics.length"].length,n=s=>{let a=e[`statistics.${s}`],i=a.length/r;return a.slice(t*i,(t+1)*i)},o=s=>Number(n(s)[0]);return{capture_rate:o("capture_rate"),
ever_capture_rate:o("ever_capture_rate"),captured_fraction:o("captured_fraction"),length:o("length"),return:n("return"),survivors:n("survivors"),overlap:n("over\
lap"),collisions:n("collisions"),faults:n("faults"),agent_steps:n("agent_steps")}}function Rt(e,t,r,n){let o=[me(r.config),F(r.pursuers),F(r.evaders),n];return Q(
e,s=>{let[a,i,l,d]=o.map(u=>s.arrays(u));return e[t](a,i,l,d)}),ue(e)}function kt(e,t,r,n){let o={seed:W("seed",r),episode:W("episode",n)};return new fe(t.config,
r,n,Rt(e,"_play_match",t,o))}function Nt(e,t,r,n){if(!Number.isInteger(n)||n<1)throw y("n_episodes","at least 1",n);let o={seed:W("seed",r),n_episodes:Int32Array.
of(n)},s=Rt(e,"_play_rollout",t,o);return Array.from({length:n},(a,i)=>Tt(s,i))}var Ot=new FinalizationRegistry(([e,t])=>e._world_free(t)),ee=class{config;n_agents;n_actions;engine;at;freed=!1;constructor(t,r){this.engine=t,this.config=r,this.
n_agents=r.n_pursuers+r.n_evaders,this.n_actions=r.diagonal?9:5,this.at=Q(t,n=>t._world_new(n.arrays(me(r)))),Ot.register(this,[t,this.at],this)}free(){this.freed||
(this.freed=!0,Ot.unregister(this),this.engine._world_free(this.at))}reset(t={}){let r=Ct(t,this.config);this.call(n=>this.engine._world_reset(this.at,n.arrays(
r)))}step(t){let r=he(t);this.call(n=>this.engine._world_step(this.at,n.arrays(r)))}playTurn(t){let r=he(t);this.call(n=>this.engine._world_play_turn(this.at,n.
arrays(r)))}decide(t,r,n){let{n_pursuers:o}=this.config,s=r==="pursuer"?[0,o]:[o,this.n_agents];return this.choose(t,s,n)}choose(t,[r,n],o){if(o.length!==this.n_agents)
throw y("actions",String(this.n_agents),o.length);let s=[F(t),he(o)],{actions:a}=this.call(i=>this.engine._world_decide(this.at,i.arrays(s[0]),r,n,i.arrays(s[1])));
return Uint8Array.from(a)}get n_turns(){return this.turnNumbers()[1]}get turn(){return this.turnNumbers()[0]}get actors(){let[,,t,r]=this.turnNumbers();return[t,
r]}turnNumbers(){return this.call(()=>this.engine._world_turn(this.at)).turn}get steps(){return this.read("steps")[0]}get seed(){return this.read("seed")[0]}get episode(){
return this.read("episode")[0]}get over(){return this.read("terminated")[0]===1||this.read("truncated")[0]===1}read(t){return this.call(r=>this.engine._world_read(
this.at,r.text(t)))[t]}view(t){let r=3*this.config.fov**2;return this.read("views").slice(t*r,(t+1)*r)}map(){return this.read("state").slice(2*this.config.rows*
this.config.cols)}conflicts(){let{conflict_table:t}=this.call(()=>this.engine._world_conflicts(this.at));return de(t,this.config.n_pursuers)}answer(t,r){let n=F(
t),{logits:o}=this.call(i=>this.engine._world_logits(this.at,i.arrays(n),r)),s=o,a=this.choose(t,[r,r+1],new Uint8Array(this.n_agents))[r];return{logits:s,probabilities:xn(
s),action:a}}snapshot(){return this.call(()=>this.engine._world_snapshot(this.at))}restore(t){let r=Mt(t);this.call(n=>this.engine._world_restore(this.at,n.arrays(
r)))}call(t){if(this.freed)throw y("world","one that is in use","one that was freed");return Q(this.engine,t),ue(this.engine)}};function xn(e){let t=Math.max(...e),
r=Array.from(e,o=>Math.exp(o-t)),n=r.reduce((o,s)=>o+s,0);return Float32Array.from(r,o=>o/n)}var Fe=class{compiled;constructor(t){this.compiled=t}world(t){return new ee(this.compiled,t)}match(t,r,n,o,s=0){return kt(this.compiled,{config:t,pursuers:r,evaders:n},
o,s)}rollout(t,r,n,o,s){return Nt(this.compiled,{config:t,pursuers:r,evaders:n},o,s)}},Lt;function It(e=globalThis.matrixworldEngine){return Lt??=An(e),Lt}async function An(e){
if(!e)throw new Error("matrixworldEngine: expected the script engine.js before this one, got none");let t=Uint8Array.from(atob(e.binary),r=>r.charCodeAt(0));return new Fe(
await e({wasmBinary:t}))}var En="http://www.w3.org/2000/svg";function c(e,t={},...r){return Pt(document.createElement(e),t,r)}function ge(e,t={},...r){return Pt(document.createElementNS(
En,e),t,r)}function Pt(e,t,r){for(let[n,o]of Object.entries(t))o==null||o===!1||(typeof o=="function"?e.addEventListener(n.slice(2),o):e.setAttribute(n,o===!0?"":
String(o)));return e.append(...r.filter(_n).map(n=>typeof n=="number"?String(n):n)),e}function _n(e){return e!=null&&e!==!1}var je=e=>({cell:e,gone:!1,captured:!1,everCaptured:!1}),A=e=>[...e.pursuers,...e.evaders],S=e=>e.pursuers.length+e.evaders.length,Ge=(e,t)=>t<e.pursuers.length?
"pursuers":"evaders";function T(e,t){let r=e.pursuers.length;return t<r?`pursuer_${t}`:`evader_${t-r}`}var ze=(e,t)=>Object.keys(e).every(r=>e[r]===t[r]);function j(e,t){
return Object.keys(t).find(r=>ze(t[r],e))??null}function Ut(e,t){let r=new Set(e.walls),n=Array.from({length:e.rows},(o,s)=>Array.from({length:e.cols},(a,i)=>r.
has(s*e.cols+i)?"#":".").join(""));return{rules:t,rows:e.rows,cols:e.cols,n_pursuers:e.pursuers.length,n_evaders:e.evaders.length,fov:e.fov,diagonal:e.diagonal,
max_steps:e.maxSteps,obstacles:n,rewards:e.rewards}}var be=(e,t,r)=>({...e,next:e.next.map((n,o)=>o===t?r:n)}),$t=e=>({...e,played:[...e.played,e.next],next:e.next.
map(t=>typeof t=="number"?0:t)}),Dt=e=>({...e,played:e.played.slice(0,-1),next:e.played.at(-1)??e.next});function Ke(e,t,r){let n=(o,s)=>o.map((a,i)=>i===s?{...a,cell:r}:a);return{...e,pursuers:n(e.pursuers,t),evaders:n(e.evaders,t-e.pursuers.length)}}function Bt(e,t,r){
let n=t==="pursuers"?e.pursuers.length:S(e);return{...e,[t]:[...e[t],je(r)],next:[...e.next.slice(0,n),0,...e.next.slice(n)],ended:!1}}function ye(e,t){let r=Ge(
e,t),n=r==="pursuers"?t:t-e.pursuers.length;return{...e,[r]:e[r].filter((o,s)=>s!==n),next:e.next.filter((o,s)=>s!==t)}}function Ve(e,t,r){let n=t[0]*e.cols+t[1],
o=e.walls.filter(s=>s!==n);return{...e,walls:r?[...o,n].sort((s,a)=>s-a):o}}function Ht(e,t,r){let n=([s,a])=>s<t&&a<r,o=A(e).map(({cell:s})=>n(s));return{...e,
rows:t,cols:r,walls:e.walls.map(s=>[Math.floor(s/e.cols),s%e.cols]).filter(n).map(([s,a])=>s*r+a),pursuers:e.pursuers.filter((s,a)=>o[a]),evaders:e.evaders.filter(
(s,a)=>o[e.pursuers.length+a]),next:e.next.filter((s,a)=>o[a])}}function R(e,[t,r]){let n=A(e).findIndex(({cell:o,gone:s})=>!s&&o[0]===t&&o[1]===r);return n<0?null:
n}var k=(e,[t,r])=>e.walls.includes(t*e.cols+r);function Wt(e){let t=Array.from({length:e.rows*e.cols},(o,s)=>[Math.floor(s/e.cols),s%e.cols]),r=([o,s])=>Math.abs(
o-(e.rows-1)/2)+Math.abs(s-(e.cols-1)/2),n=t.filter(o=>R(e,o)===null&&!k(e,o));return n.length?n.reduce((o,s)=>r(s)<r(o)?s:o):null}var ne=class extends Error{},I="_",Ft=2n**64n-1n,jt=2e4,Gt=40,P={fov:11,maxSteps:500,rewards:"paper"},Ye=["rules","others","rewards","size","diagonal","fov","li\
mit","seed","ended","walls","pursuers","evaders","played","next"];function b(e,t,r){let n=r.length>Gt?`${r.slice(0,Gt)}…`:r;throw new ne(`${e}: expected ${t},\
 got "${n}"`)}function oe(e,t){let r=i=>i.map(l=>Mn(l,t)).join(""),n=i=>`${Math.floor(i/e.cols)}.${i%e.cols}`,o=Cn(e.rewards,t),s=[e.seed,e.episode,e.steps].join(
"."),a={rules:Kt(e.rules,t),others:e.others?Kt(e.others,t):"",rewards:o===P.rewards?"":o,size:`${e.rows}x${e.cols}`,diagonal:e.diagonal?"1":"",fov:e.fov===P.fov?
"":String(e.fov),limit:e.maxSteps===P.maxSteps?"":String(e.maxSteps),seed:s==="0.0.0"?"":s,ended:e.ended?"1":"",walls:e.walls.map(n).join(I),pursuers:e.pursuers.
map(zt).join(I),evaders:e.evaders.map(zt).join(I),played:e.played.map(r).join(I),next:e.next.every(i=>i===0)?"":r(e.next)};return Ye.filter(i=>a[i]).map(i=>`${i}\
=${a[i]}`).join("&")}function zt({cell:e,gone:t,captured:r,everCaptured:n}){let o=r?"c":n?"e":"";return`${e[0]}.${e[1]}${o}${t?"x":""}`}function Kt(e,t){let r=t.
fields.map(({name:n})=>String(e[n]).toLowerCase());return j(e,t.variants)??r.join(".")}function Cn(e,t){let r=JSON.stringify(e);return Object.keys(t.rewards).find(
o=>JSON.stringify(t.rewards[o])===r)??Object.values(e).map(o=>String(o)).join(I)}function Mn(e,t){if(typeof e=="number")return String(e);let r=t.scripts.findIndex(
({name:n})=>n===e);return String.fromCharCode(97+r)}function se(e,t){e.length>jt&&b("link",`at most ${jt} characters`,`${e.length} characters`);let r=Tn(e),n=(h,m="")=>r.
get(h)??m,o=Yt("rules",n("rules"),t),[s,a]=Rn(n("size")),i=h=>qe(n(h)).map(m=>kn(h,m,s,a)),[l,d,u]=In(n("seed","0.0.0")),p={rules:o,others:r.has("others")?Yt("o\
thers",n("others"),t):null,rewards:On(n("rewards",P.rewards),t),rows:s,cols:a,seed:l,episode:d,steps:u,diagonal:Vt("diagonal",n("diagonal","0")),fov:ve("fov",n(
"fov",String(P.fov)),1,255),maxSteps:ve("limit",n("limit",String(P.maxSteps)),1,2**31-1),ended:Vt("ended",n("ended","0")),walls:Nn(n("walls"),s,a),pursuers:i("p\
ursuers"),evaders:i("evaders"),played:[],next:[]};return Pn(p),Un(p,qe(n("played")),n("next"),t)}function Tn(e){let t=new Map;for(let r of e.replace(/^#/,"").split(
"&").filter(Boolean)){let[n,o]=r.includes("=")?[r.slice(0,r.indexOf("=")),r.slice(r.indexOf("=")+1)]:[r,""];Ye.includes(n)||b("link",`parts ${Ye.join(", ")}`,n),
t.has(n)&&b(n,"it once","it twice"),t.set(n,o)}return t}var qe=e=>e?e.split(I):[];function ve(e,t,r,n){let o=/^\d{1,10}$/.test(t)?Number(t):NaN;return o>=r&&o<=
n||b(e,`a number from ${r} to ${n}`,t),o}function Vt(e,t){return t!=="0"&&t!=="1"&&b(e,"0 or 1",t),t==="1"}function Rn(e){let[t,r,...n]=e.split("x");return(t===
void 0||r===void 0||n.length)&&b("size","rows and columns, such as 4x6",e),[ve("size",t,1,64),ve("size",r,1,64)]}function qt(e,t,r,n){let o=/^(\d{1,4})\.(\d{1,4})$/.
exec(t),s=[Number(o?.[1]),Number(o?.[2])];return(!o||s[0]>=r||s[1]>=n)&&b(e,`cells of a ${r} x ${n} grid, such as 0.2`,t),s}function kn(e,t,r,n){let o=/^(.*?)([ce]?)(x?)$/.
exec(t),s=qt(e,o[1],r,n);return e==="pursuers"&&o[2]&&b(e,"no captured pursuer",t),{cell:s,gone:o[3]==="x",captured:o[2]==="c",everCaptured:o[2]!==""}}function Nn(e,t,r){
let n=qe(e).map(o=>{let[s,a]=qt("walls",o,t,r);return s*r+a});return[...new Set(n)].sort((o,s)=>o-s)}function Yt(e,t,r){let n=Object.hasOwn(r.variants,t)?r.variants[t]:
void 0;if(n)return n;let o=t.split("."),s=`${Object.keys(r.variants).join(", ")} or ${r.fields.length} values joined by "."`;o.length!==r.fields.length&&b(e,s,t);
let a=r.fields.map(({name:i,values:l},d)=>{let u=l.find(p=>p.name.toLowerCase()===o[d])?.name;return u===void 0&&b(`${e}, ${i}`,l.map(p=>p.name.toLowerCase()).join(
" or "),o[d]),[i,u==="true"?!0:u==="false"?!1:u]});return Object.fromEntries(a)}function On(e,t){if(Object.hasOwn(t.rewards,e))return t.rewards[e];let r=Object.
entries(t.rewards[P.rewards]),n=e.split(I);return n.length!==r.length&&b("rewards",`${Object.keys(t.rewards).join(", ")} or ${r.length} values`,e),Object.fromEntries(
r.map(([o,s],a)=>[o,Ln(o,n[a],s)]))}function Ln(e,t,r){if(e==="blame"&&(t==="FAULT"||t==="INVOLVED"))return t;if(typeof r=="boolean"&&(t==="true"||t==="false"))
return t==="true";let n=t.split(",").map(a=>/^-?[\d.]+(e[+-]?\d+)?$/i.test(a)?Number(a):NaN),o=e.endsWith("_collide")?[1,3]:[1];return(typeof r!="number"||!o.includes(
n.length)||!n.every(a=>Math.abs(a)<34e37))&&b(`rewards, ${e}`,`a value like ${r}`,t),n.length===1?n[0]:n}function In(e){let t=/^(\d{1,20})\.(\d{1,20})\.(\d{1,9})$/.
exec(e);if(!t)return b("seed","seed.episode.steps, such as 0.0.0",e);let[r,n]=[BigInt(t[1]),BigInt(t[2])];return(r>Ft||n>Ft)&&b("seed","numbers below 2^64",e),[
r,n,Number(t[3])]}function Pn(e){for(let t of["pursuers","evaders"]){let r=e[t].length;(r<1||r>100)&&b(t,`1 to ${100} agents`,`${r}`)}e.fov%2===0&&b("fov","an o\
dd number",String(e.fov)),e.steps>e.maxSteps&&b("seed",`at most ${e.maxSteps} steps`,String(e.steps))}function Un(e,t,r,n){let o=A(e).length;t.length>300&&b("pl\
ayed",`at most ${300} steps`,`${t.length} steps`);let s=a=>i=>(i.length!==o&&b(a,`${o} characters, one for each agent`,i),[...i].map(l=>$n(a,l,e.diagonal?9:5,n)));
return{...e,played:t.map(s("played")),next:r?s("next")(r):Array(o).fill(0)}}function $n(e,t,r,n){let o=/^\d$/.test(t)?Number(t):NaN;if(o<r)return o;let s=n.scripts[t.
charCodeAt(0)-97],a=String.fromCharCode(97+n.scripts.length-1);return s?.name??b(e,`actions 0 to ${r-1} or scripts a to ${a}`,t)}var Dn={now:()=>performance.now(),request:e=>requestAnimationFrame(e),cancel:e=>cancelAnimationFrame(e)},Se=[.5,1,2,4,8,16,32,64],xe=class extends EventTarget{#t;#e;#o;#a;#n=0;#r=0;#s=!1;#c=null;#i=0;glide=.28;constructor(t,r={}){
super(),this.#t=t,this.#e=r.speed??4,this.#a=r.still??!1,this.#o=r.clock??Dn}get step(){return this.#n}get time(){return this.#a?this.#n:this.#r}get arrived(){return this.#r===
this.#n}get playing(){return this.#s}get length(){return this.#t}set length(t){this.#t=t,this.#n>t&&this.jump(t),this.#l("state")}get speed(){return this.#e}set speed(t){
this.#e=t,this.#l("state")}changeSpeed(t){let r=Se.findIndex(n=>n>=this.#e);this.speed=Se[Math.min(Se.length-1,Math.max(0,r+t))]}play(){this.#s||!this.#t||(this.#n===
this.#t&&this.jump(0),this.#s=!0,this.#l("state"),this.#p())}pause(){this.#s&&(this.#s=!1,this.#l("state"))}toggle(){this.#s?this.pause():this.play()}move(t){this.
pause();let r=Math.min(this.#t,Math.max(0,this.#n+t));Math.abs(r-this.#r)>1?this.jump(r):this.#d(r),this.#p()}jump(t){this.#r=Math.min(this.#t,Math.max(0,Math.round(
t))),this.#d(this.#r),this.#l("frame")}#d(t){t!==this.#n&&(this.#n=t,this.#l("step"),this.#a&&this.#l("frame"))}#p(){this.#c===null&&(this.#i=this.#o.now(),this.#c=
this.#o.request(()=>this.#u()))}#u(){this.#c=null;let t=this.#o.now();this.#m(Math.min(.25,(t-this.#i)/1e3)),this.#i=t,(!this.#a||this.arrived)&&this.#l("frame"),
(this.#s||this.#r!==this.#n)&&(this.#c=this.#o.request(()=>this.#u()))}#m(t){let r=t;for(;r>0;){if(this.#r===this.#n){if(!this.#s)return;if(this.#n===this.#t)return this.
pause();this.#d(this.#n+1)}let n=this.#s?this.#e:1/this.glide,o=this.#n-this.#r,s=Math.min(Math.abs(o),r*n);r-=s/n,this.#r=s===Math.abs(o)?this.#n:this.#r+Math.
sign(o)*s}this.#s&&this.#r===this.#t&&this.pause()}#l(t){this.dispatchEvent(new Event(t))}};var z=[[0,0],[-1,0],[0,1],[1,0],[0,-1],[-1,1],[1,1],[1,-1],[-1,-1]],U=(e,t)=>t<e.nPursuers,v=(e,t)=>[e.positions[2*t],e.positions[2*t+1]],Bn=(e,t)=>e[0]===t[0]&&
e[1]===t[1],Je=({rows:e,cols:t},[r,n])=>r>=0&&n>=0&&r<e&&n<t,Xe=(e,t,r=3)=>e!==void 0&&[0,1,2].slice(0,r).some(n=>e[3*t+n]),Ze=(e,t)=>Xe(e.fault,t),Jt=(e,t)=>!Ze(
e,t)&&Xe(e.involved,t,2);function Ae(e,t,r){let n=!Bn(v(e,r),v(t,r)),o=t.involved===void 0||Xe(t.involved,r);return!!(t.alive[r]&&t.actions?.[r]&&!n&&o)}function Ee(e,t,r){
let[n,o]=v(e,r),[s,a]=z[t.actions?.[r]??0];return[n+s,o+a]}function Xt(e,t,r){return Array.from({length:r.everCaptured.length},(o,s)=>s).filter(o=>r.everCaptured[o]&&
!t.everCaptured[o]).map(o=>e.nPursuers+o)}function Zt(e,t){return Array.from({length:t.alive.length},(n,o)=>o).filter(n=>e.alive[n]&&!t.alive[n])}var Qt=[-.31,0,.31],er=[{size:1,at:[[0,0]]},{size:.62,at:[[-.2,.2],[.2,-.2]]},{size:.54,at:[[-.23,.22],[.23,.22],[0,-.22]]},{size:.54,at:[[-.23,.23],[.23,.23],[
-.23,-.23],[.23,-.23]]},{size:.36,at:Qt.flatMap(e=>Qt.map(t=>[t,e]))}],Hn=.3,Wn=.35,Fn=.55;function ae(e,t){let r=new Map;for(let n=0;n<t.alive.length;n++){if(!t.
alive[n])continue;let[o,s]=v(t,n),a=o*e.cols+s,i=r.get(a);i?i.push(n):r.set(a,[n])}return r}function tr(e,t){let r=Array.from(t.alive,(n,o)=>{let[s,a]=v(t,o);return{
x:a+.5,y:s+.5,size:1,alpha:0}});for(let n of ae(e,t).values()){let o=er[Math.min(n.length,er.length)-1];n.forEach((s,a)=>{let[i,l]=o.at[Math.min(a,o.at.length-1)],
d=r[s];d.x+=i,d.y+=l,d.size=o.size,d.alpha=1})}return r}var rr=e=>e*e*(3-2*e),K=(e,t,r)=>e+(t-e)*r,nr=e=>Math.min(1,Math.max(0,e));function or(e,t,r,n){let o={1:2,
2:r}[e.interaction]??1;if(o===1)return rr(n);let s=o===r?t:+!U(e,t),a=Math.max(1/o,Wn);return rr(nr((n-s/(o-1)*(1-a))/a))}function _e(e,t){let r=e.moments.length-
1,n=Math.min(Math.floor(t),r),o=e.moments[n],s=tr(e,o);if(n===r||t===n)return s;let a=e.moments[n+1],i=tr(e,a);return s.map((l,d)=>{let u=or(e,d,s.length,t-n);return jn(
o,a,d,l,i[d],u)})}function sr(e,t,r){let n=e.moments.length-1,o=Math.min(Math.floor(r),n),[s,a]=[e.moments[o],e.moments[Math.min(o+1,n)]],i=or(e,t,s.alive.length,
r-o),[[l,d],[u,p]]=[v(s,t),v(a,t)];return[K(d,p,i)+.5,K(l,u,i)+.5]}function jn(e,t,r,n,o,s){let a=n.alpha>o.alpha,i={x:K(n.x,o.x,s),y:K(n.y,o.y,s),size:a?n.size:
K(n.size,o.size,s),alpha:a?nr((1-s)/(1-Fn)):K(n.alpha,o.alpha,s)};if(Ae(e,t,r)){let[l,d]=v(e,r),[u,p]=Ee(e,t,r),h=Hn*Math.sin(Math.PI*s);i.x+=(p-d)*h,i.y+=(u-l)*
h}return i}var ar=2*Math.PI;function ie(e,t,r,n){e.beginPath(),e.arc(t,r,n/2,0,ar)}function ir(e,t,r,n){let o=n/2,s=[[0,-.97],[.97,.83],[-.97,.83]].map(([a,i])=>[t+a*o,r+i*
o]);e.beginPath(),e.moveTo((s[2][0]+s[0][0])/2,(s[2][1]+s[0][1])/2),s.forEach(([a,i],l)=>{let[d,u]=s[(l+1)%3];e.arcTo(a,i,d,u,n*.09)}),e.closePath()}function lr(e,t,r,n){
let o=n*.32;e.beginPath(),e.moveTo(t-o,r-o),e.lineTo(t+o,r+o),e.moveTo(t+o,r-o),e.lineTo(t-o,r+o)}function cr(e,t,r,n){e.beginPath();for(let o=0;o<16;o++){let s=n/
2*(o%2?.6:.95),a=ar*o/16;e.lineTo(t+s*Math.sin(a),r-s*Math.cos(a))}e.closePath()}function dr(e,t,r,n,o,s){let a=Math.atan2(o-r,n-t);e.beginPath(),e.moveTo(t,r),
e.lineTo(n,o);for(let i of[-1,1])e.moveTo(n,o),e.lineTo(n-s*Math.cos(a+i*.6),o-s*Math.sin(a+i*.6))}var ur=4,Gn=1.6,zn=.95,Kn=5,Vn=.16,Yn=9,qn=.09,Jn=.2,pr=.75,E=(e,t)=>e.left+t*e.cell,_=(e,t)=>e.top+t*e.cell;function V(e,t,r){return U(t,r)?e.colors.pursuer:e.
colors.evader}function mr({ctx:e,grid:t,colors:r}){let{left:n,top:o,cell:s,rows:a,cols:i}=t,[l,d]=[i*s,a*s];if(e.fillStyle=r.paper,e.fillRect(n,o,l,d),s<Kn)return;
e.fillStyle=r.line;let u=Math.max(1,Math.round(s/60));for(let p=1;p<i;p++)e.fillRect(n+p*s,o,u,d);for(let p=1;p<a;p++)e.fillRect(n,o+p*s,l,u)}function hr({ctx:e,
grid:t,colors:r},n){let{left:o,top:s,cell:a,rows:i,cols:l}=t;e.fillStyle=r.obstacle;for(let u=0;u<i*l;u++){if(!n.obstacles[u])continue;let[p,h]=[Math.floor(u/l),
u%l];e.fillRect(o+h*a,s+p*a,a,a)}let d=Math.min(5,Math.max(2,Math.round(a/18)));e.strokeStyle=r.frame,e.lineWidth=d,e.strokeRect(o-d/2,s-d/2,l*a+d,i*a+d)}function fr({
ctx:e,grid:t,colors:r},n){let{left:o,top:s,cell:a,rows:i,cols:l}=t,d=a<24*n?5:1;e.font=`500 ${Math.round(Math.min(15*n,Math.max(9*n,a*.32)))}px system-ui, sans-\
serif`,e.fillStyle=r.muted,e.textBaseline="alphabetic",e.textAlign="center";let u=5*n+a/40;for(let p=0;p<l;p+=d)e.fillText(String(p),o+(p+.5)*a,s-u);e.textAlign=
"right",e.textBaseline="middle";for(let p=0;p<i;p+=d)e.fillText(String(p),o-u,s+(p+.5)*a)}function gr(e,t,r,n,o){let{ctx:s,grid:a}=e,i=Math.floor(t.fov/2)+.5,[l,
d]=[Math.max(0,n-i),Math.min(a.cols,n+i)],[u,p]=[Math.max(0,o-i),Math.min(a.rows,o+i)],h=[E(a,l),_(a,u),(d-l)*a.cell,(p-u)*a.cell],m=V(e,t,r);s.globalAlpha=.11,
s.fillStyle=m,s.fillRect(...h),s.globalAlpha=.8,s.strokeStyle=m,s.lineWidth=Math.max(1,a.cell/24),s.strokeRect(...h),s.globalAlpha=1}function br(e,t,r,n,o){let{
ctx:s,grid:a}=e,i=Math.min(Math.ceil(r),t.moments.length-1),l=t.moments[i];s.lineCap="round",s.lineWidth=Math.min(Yn,Math.max(1,a.cell*Vn));for(let d=Math.max(1,
Math.floor(r-n)+1);d<=i;d++){let[u,p]=[t.moments[d-1],t.moments[d]],h=Math.max(0,Math.min(1,(r-d)/n));s.globalAlpha=pr+(Jn-pr)*h;for(let m=0;m<p.alive.length;m++){
let g=d===i&&r<i;if(!u.alive[m]||!(l.alive[m]||g))continue;let f=(U(t,m)?-1:1)*qn,[w,C]=v(u,m),[$,D]=v(p,m);if(w===$&&C===D)continue;let ce=g?o[m].x:D+.5,ln=g?o[m].
y:$+.5;s.strokeStyle=V(e,t,m),s.beginPath(),s.moveTo(E(a,C+.5+f),_(a,w+.5+f)),s.lineTo(E(a,ce+f),_(a,ln+f)),s.stroke()}}s.globalAlpha=1}function yr(e,t,r){let n=Math.
min(Math.ceil(r),t.moments.length-1);for(let o=Math.max(1,n-ur+1);o<=n;o++){let[s,a]=[t.moments[o-1],t.moments[o]],i=o>r?Math.max(0,1-2*(o-r)):1-(r-o)/ur,l=Xt(t,
s,a);for(let d of Zt(s,a))l.includes(d)||Zn(e,v(a,d),i);for(let d of l)Xn(e,v(a,d),i)}e.ctx.globalAlpha=1}function Xn({ctx:e,grid:t,colors:r},[n,o],s){e.globalAlpha=
s,cr(e,E(t,o+.5),_(t,n+.5),Math.max(8,t.cell*Gn)),e.fillStyle=r.capture,e.fill(),e.strokeStyle=r.ink,e.lineWidth=Math.max(1,t.cell/36),e.lineJoin="round",e.stroke()}
function Zn({ctx:e,grid:t,colors:r},[n,o],s){e.globalAlpha=s,lr(e,E(t,o+.5),_(t,n+.5),Math.max(7,t.cell*zn)),e.strokeStyle=r.collision,e.lineWidth=Math.max(2,t.
cell*.17),e.lineCap="round",e.stroke()}function vr({ctx:e,grid:t,colors:r},n,o){let s=Math.max(1,t.cell*.07);e.strokeStyle=e.fillStyle=r.collision,e.lineWidth=Math.
max(1,t.cell*.05),e.setLineDash([t.cell*.14,t.cell*.1]);for(let[a,i]of n){if(a<0||i<0||a>=t.rows||i>=t.cols)continue;let l=[E(t,i)+s,_(t,a)+s,t.cell-2*s,t.cell-
2*s];e.globalAlpha=.2*o,e.fillRect(...l),e.globalAlpha=o,e.strokeRect(...l)}e.setLineDash([]),e.globalAlpha=1}function wr({ctx:e,grid:t,colors:r},n,o,s,a){e.globalAlpha=
a,ie(e,E(t,n),_(t,o),Math.max(8,t.cell*s*1.02)),e.strokeStyle=r.collision,e.lineWidth=Math.max(1.5,t.cell*.085*Math.sqrt(s)),e.stroke(),e.globalAlpha=1}var Qn=.8,eo=.92,to=15,ro=7,tt=9;function Sr(e,t,r,n,o,s){n.forEach((a,i)=>{a.alpha>0&&no(e,t,r,i,a,o,s)}),e.ctx.globalAlpha=1;for(let a of ae(t,r).values())a.length>
tt&&oo(e,n[a[tt-1]],a.length-tt+1)}function no(e,t,r,n,o,s,a){let{ctx:i,grid:l,colors:d}=e,u=U(t,n),[p,h]=[l.left+o.x*l.cell,l.top+o.y*l.cell],m=Math.max(4,l.cell*
o.size*(u?eo:Qn)),g=V(e,t,n),f=!u&&!!r.captured[n-t.nPursuers];if(i.globalAlpha=o.alpha,(u?ir:ie)(i,p,h,m),m>ro*a&&(i.strokeStyle=d.paper,i.lineWidth=Math.max(2,
m*.1),i.stroke()),i.fillStyle=f?d.paper:g,i.fill(),f&&(ie(i,p,h,m*.82),i.strokeStyle=g,i.lineWidth=m*.18,i.stroke()),!s||m<to*a)return;let w=String(u?n:n-t.nPursuers);
i.font=`700 ${Math.round(m*(u?.4:.5)*(w.length>1?.8:1))}px system-ui, sans-serif`,i.textAlign="center",i.textBaseline="middle",i.fillStyle=f?g:d.paper,i.fillText(
w,p,h+m*(u?.17:.03))}function oo({ctx:e,grid:t,colors:r},n,o){let[s,a]=[t.left+n.x*t.cell,t.top+n.y*t.cell];e.font=`700 ${Math.round(t.cell*.3)}px system-ui, sa\
ns-serif`,e.textAlign="center",e.textBaseline="middle",e.strokeStyle=r.paper,e.lineWidth=t.cell*.1,e.strokeText(`+${o}`,s,a),e.fillStyle=r.ink,e.fillText(`+${o}`,
s,a)}var so=.46,ao=.86,io=.66,xr=.48,lo=.78,co=.58;function Ar(e,t,r,n){let[o,s]=[t.moments[r-1],t.moments[r]];if(!o)return;let{ctx:a,grid:i,colors:l}=e;a.strokeStyle=
l.collision,a.lineWidth=Math.max(1.5,i.cell*.07),a.lineCap="butt",a.globalAlpha=n;for(let d=0;d<s.alive.length;d++)Ae(o,s,d)&&uo(e,t,v(o,d),Ee(o,s,d));a.globalAlpha=
1}function uo({ctx:e,grid:t},r,n,o){let[s,a]=[o[1]-n[1],o[0]-n[0]],i=p=>E(t,n[1]+.5+s*p),l=p=>_(t,n[0]+.5+a*p),d=Je(r,o)?lo:co;e.setLineDash([t.cell*.09,t.cell*
.06]),e.beginPath(),e.moveTo(i(xr),l(xr)),e.lineTo(i(d),l(d)),e.stroke(),e.setLineDash([]);let u=.17*t.cell/Math.hypot(s,a);e.beginPath(),e.moveTo(i(d)-a*u,l(d)+
s*u),e.lineTo(i(d)+a*u,l(d)-s*u),e.stroke()}function Er(e,t,r,n,o,s){let a=z[s];if(!s||!a)return;let{ctx:i,grid:l,colors:d}=e,u=Je(t,[n[0]+a[0],n[1]+a[1]])?ao:io,
p=so*o.size,h=[E(l,o.x+a[1]*p),_(l,o.y+a[0]*p),E(l,o.x+a[1]*u),_(l,o.y+a[0]*u)],m=Math.max(1.5,l.cell*.085);i.lineCap=i.lineJoin="round";for(let[g,f]of[[d.paper,
m*2.1],[V(e,t,r),m]])i.strokeStyle=g,i.lineWidth=f,dr(i,...h,l.cell*.2),i.stroke()}var Cr={numbers:!0,axes:!1,trail:6,viewers:[],plan:null,selected:null,cursor:null};function Mr(e,t,r,n,o){let{ctx:s,grid:a,colors:i}=e,l=Math.min(Math.ceil(r),t.
moments.length-1),d=t.moments[l],u=r===l,p=_e(t,r),h=u?1:Math.max(0,1-2*(l-r));s.clearRect(0,0,s.canvas.width,s.canvas.height),mr(e);for(let f of n.viewers)p[f]?.
alpha&&gr(e,t,f,...sr(t,f,r));hr(e,t),n.axes&&fr(e,o),br(e,t,r,n.trail,p),vr(e,d.contested??[],h),yr(e,t,r),Ar(e,t,l,h),p.forEach(({x:f,y:w,size:C},$)=>{let D=Jt(
d,$)?.4:0,ce=Ze(d,$)?1:D;ce&&wr(e,f,w,C,ce*h)});let m=u?d:t.moments[Math.max(0,l-1)];if(Sr(e,t,m,p,n.numbers,o),u&&n.plan)for(let[f,w]of p.entries())w.alpha&&Er(
e,t,f,v(d,f),w,n.plan[f]??0);s.lineWidth=Math.max(2,2.5*o),s.strokeStyle=i.focus;let g=n.selected===null?void 0:p[n.selected];g?.alpha&&_r(e,g.x,g.y,g.size*.96),
n.cursor&&(s.setLineDash([a.cell*.12,a.cell*.08]),_r(e,n.cursor[1]+.5,n.cursor[0]+.5,.8),s.setLineDash([]))}function _r({ctx:e,grid:t},r,n,o){let s=o*t.cell;e.beginPath(),
e.roundRect(t.left+r*t.cell-s/2,t.top+n*t.cell-s/2,s,s,s*.1),e.stroke()}var Tr=(e,t)=>(t+.24)/(e+.24);function Rr(e,t,r,n,o,s){let a=r?28*s:0,i=(d,u)=>(d-a)/(u+2*.12),l=Math.max(1,Math.floor(Math.min(i(n,t),i(o,e))));return{rows:e,cols:t,
cell:l,left:Math.round((n-t*l+a)/2),top:Math.round((o-e*l+a)/2)}}function kr(e,t,r){let n=Math.floor((r-e.top)/e.cell),o=Math.floor((t-e.left)/e.cell);return n>=
0&&n<e.rows&&o>=0&&o<e.cols?[n,o]:null}var po={paper:"--board-paper",line:"--board-line",frame:"--board-frame",ink:"--board-ink",muted:"--board-muted",obstacle:"--board-obstacle",pursuer:"--pursuer",
evader:"--evader",capture:"--capture",collision:"--collision",focus:"--focus"};function Nr(e){let t=getComputedStyle(e),r=Object.entries(po).map(([n,o])=>[n,t.getPropertyValue(
o).trim()]);return Object.fromEntries(r)}var Or=()=>matchMedia("(prefers-reduced-motion: reduce)").matches,Ce=class{canvas;#t=null;#e=0;#o;#a={rows:1,cols:1,left:0,top:0,cell:1};#n=0;#r;#s;constructor(t,r={}){
this.canvas=t,t.classList.add("board"),t.setAttribute("role","img"),this.#o={...Cr,...r},this.#r=new ResizeObserver(()=>this.#i()),this.#r.observe(t),this.#s=new MutationObserver(
()=>this.redraw()),this.#s.observe(document.documentElement,{attributes:!0}),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",this.redraw)}close(){
this.#r.disconnect(),this.#s.disconnect(),matchMedia("(prefers-color-scheme: dark)").removeEventListener("change",this.redraw),cancelAnimationFrame(this.#n)}get look(){
return this.#o}set look(t){this.#o={...this.#o,...t},this.#c(),this.redraw()}get time(){return this.#e}show(t,r){this.#t=t,this.#e=Math.min(Math.max(0,r),t.moments.
length-1),this.#c(),this.redraw()}redraw=()=>{this.#n||(this.#n=requestAnimationFrame(()=>this.drawNow()))};drawNow(){cancelAnimationFrame(this.#n),this.#n=0;let t=this.
canvas.getContext("2d");if(!t||!this.#t)return;let{rows:r,cols:n}=this.#t,o=devicePixelRatio||1;this.#a=Rr(r,n,this.#o.axes,this.canvas.width,this.canvas.height,
o);let s={ctx:t,grid:this.#a,colors:Nr(this.canvas)};Mr(s,this.#t,this.#e,this.#o,o)}cellAt(t,r){let n=this.canvas.getBoundingClientRect(),o=this.canvas.width/n.
width;return kr(this.#a,(t-n.left)*o,(r-n.top)*o)}agentAt(t,r){let n=this.cellAt(t,r);if(!n||!this.#t)return null;let o=this.#t.moments[Math.round(this.#e)],s=ae(
this.#t,o).get(n[0]*this.#t.cols+n[1])??[],a=_e(this.#t,Math.round(this.#e)),i=l=>{let[d,u]=this.pointOf(a[l].x,a[l].y);return Math.hypot(d-t,u-r)};return s.length?
s.reduce((l,d)=>i(d)<i(l)?d:l):null}pointOf(t,r){let n=this.canvas.getBoundingClientRect(),o=n.width/this.canvas.width,{left:s,top:a,cell:i}=this.#a;return[n.left+
(s+t*i)*o,n.top+(a+r*i)*o]}#c(){if(!this.#t)return;let{rows:t,cols:r}=this.#t;this.canvas.style.setProperty("--board-aspect",String(Tr(t,r)))}#i(){let t=devicePixelRatio||
1,{width:r,height:n}=this.canvas.getBoundingClientRect();this.canvas.width=Math.max(1,Math.round(r*t)),this.canvas.height=Math.max(1,Math.round(n*t)),this.drawNow()}};var ho={SIMULTANEOUS:0,SWARM_TURNS:1,AGENT_TURNS:2};function Lr(e,t,r){return{rows:e.rows,cols:e.cols,nPursuers:e.n_pursuers,fov:e.fov,interaction:ho[e.rules.interaction],
obstacles:t,moments:r}}function Ir(e,t){return{positions:e.read("last_positions"),alive:e.read("alive"),captured:e.read("captured"),everCaptured:e.read("ever_ca\
ptured"),actions:t,involved:e.read("involved"),fault:e.read("fault"),contested:e.conflicts().map(r=>r.cell)}}var Me=class{recording;rules;outcomes=[];#t;#e;#o=[];#a=[];constructor(t,r,n){this.#t=r,this.rules=n;let o=Ut(r,n);this.#e=t.world(o),this.#e.restore(go(this.#e,
r)),this.recording=Lr(o,this.#e.map(),this.#o),this.#r(void 0);for(let s of r.played)this.#n(s)}follow(t){if(!bo(this.#t,t))return!1;let r=this.#t.played,n=t.played.
findIndex((a,i)=>a!==r[i]),o=n<0?t.played.length:n,s=Math.min(o+1,this.#o.length);this.#o.length=this.outcomes.length=this.#a.length=s,this.#e.restore(this.#a.at(
-1));for(let a of t.played.slice(s-1))this.#n(a);return this.#t=t,!0}get length(){return this.#o.length-1}get over(){let{terminated:t,truncated:r}=this.outcomes.
at(-1);return t||r}actions(t){let r=Uint8Array.from(t,o=>typeof o=="number"?o:0),n=new Set(t.filter(o=>typeof o=="string"));for(let o of this.over?[]:n)for(let s of[
"pursuer","evader"]){let a=this.#e.decide(o,s,r);t.forEach((i,l)=>{i===o&&l<this.#t.pursuers.length==(s==="pursuer")&&(r[l]=a[l])})}return r}scene(){let t=this.#e,
[r,n]=[t.read("last_positions"),t.read("alive")],[o,s]=[t.read("captured"),t.read("ever_captured")],a=this.#t.pursuers.length,i=A(this.#t).map((l,d)=>({...je([r[2*
d],r[2*d+1]]),gone:!n[d],captured:d>=a&&!!o[d-a],everCaptured:d>=a&&!!s[d-a]}));return{...this.#t,played:[],steps:t.steps,ended:this.outcomes.at(-1).terminated,
pursuers:i.slice(0,a),evaders:i.slice(a)}}free(){this.#e.free()}#n(t){if(this.over)return;let r=this.actions(t);this.#e.step(r),this.#r(r)}#r(t){let r=this.#e;this.#o.
push(t?Ir(r,t):fo(r)),this.#a.push(r.snapshot()),this.outcomes.push({conflicts:t?r.conflicts():[],rewards:r.read("rewards"),captors:r.read("captors"),terminated:!!r.
read("terminated")[0],truncated:!!r.read("truncated")[0]})}};function fo(e){return{positions:e.read("last_positions"),alive:e.read("alive"),captured:e.read("cap\
tured"),everCaptured:e.read("ever_captured")}}function go(e,t){let r=A(t),n=r.map(({cell:s})=>s[0]*t.cols+s[1]),o=s=>Uint8Array.from(t.evaders,a=>Number(a[s]));
return{...e.snapshot(),seed:BigUint64Array.of(t.seed),episode:BigUint64Array.of(t.episode),cells:Int32Array.from(n,(s,a)=>r[a].gone?-1:s),last_cells:Int32Array.
from(n,(s,a)=>r[a].gone?s:-1),captured:o("captured"),ever_captured:o("everCaptured"),capture_paid:o("everCaptured"),captors:new Int32Array(t.evaders.length),rewards:new Float32Array(
S(t)),report:new Int32Array(S(t)),participants:new Int32Array(0),steps:Int32Array.of(t.steps),terminated:Uint8Array.of(Number(t.ended)),truncated:Uint8Array.of(
+(t.steps>=t.maxSteps))}}function bo(e,t){return Object.keys(e).every(n=>["played","next","rules","others"].includes(n)||e[n]===t[n])}var yo={SIMULTANEOUS:.45,SWARM_TURNS:.9,AGENT_TURNS:1.4},vo=200,Te=class extends EventTarget{data;player;#t;#e;#o;#a=[];#n=[];#r=[];#s=!1;#c="act";#i=0;#d=null;constructor(t,r,n,o=null){
super(),this.#d=o,this.#t=t,this.data=r,this.#e=n,this.#o=this.#u(n),this.player=new xe(this.game.length,{still:Or()}),this.player.jump(this.game.length),this.player.
addEventListener("frame",()=>this.#f()),this.#l()}get scene(){return this.#e}get game(){return this.#o[0]}get games(){return this.#o}get mode(){return this.#c}set mode(t){
this.stop(),this.#c=t,this.#h()}get selected(){return this.#i}set selected(t){this.#i=t,this.#h()}get running(){return this.#s}get example(){return this.#d}get canStep(){
return!this.game.over&&this.#e.played.length<300}change(t,r={}){let n;try{n=this.#u(t)}catch(o){if(!(o instanceof x))throw o;return this.say(o.message,!0),!1}return r.
part||(this.#a=[...this.#a,this.#e].slice(-vo)),this.#n=[],r.example!==void 0&&(this.#d=r.example),this.#r=[],this.#m(t,n),!0}step(){if(!this.canStep){this.stop(),
this.say(this.game.over?"The episode has ended. Go back, or restart.":`The playground plays ${300} steps.`,!0);return}let r=this.#r.at(-1)===this.#e.next?this.#r.
slice(0,-1):[],n=$t(this.#e);this.change({...n,next:r.at(-1)??n.next}),this.#r=r}back(){this.stop();let{played:t}=this.#e;if(!this.game.length)return;let r=this.#e,
n=this.#r.at(-1)===r.next?[...this.#r]:[];for(let o=t.length;o>=this.game.length;o--)r=Dt(r),n.push(r.next);this.change(r),this.#r=n}restart(){this.stop();let{played:t}=this.#e;
if(!t.length)return;let r=[...this.#r.at(-1)===this.#e.next?this.#r:[],...[...t].reverse()];this.change({...this.#e,played:[],next:t[0]}),this.#r=r}run(){if(this.#s)
return this.stop();this.#s=this.canStep,this.step()}stop(){this.#s&&(this.#s=!1,this.#h())}undo(){this.#p(this.#a,this.#n)}redo(){this.#p(this.#n,this.#a)}get canUndo(){
return this.#a.length>0}say(t,r=!1){this.dispatchEvent(new CustomEvent("message",{detail:{text:t,problem:r}}))}#p(t,r){let n=t.pop();n&&(this.stop(),r.push(this.#e),
this.#r=[],this.#m(n,this.#u(n)))}#u(t){let r=t.others?[t.rules,t.others]:[t.rules],n=this.#o??[];return r.map(o=>{let s=n.find(a=>a.rules===o);return s?.follow(
t)?s:new Me(this.#t,t,o)})}#m(t,r){let[n,o]=[this.#e,this.#o.length];for(let l of this.#o)r.includes(l)||l.free();this.#e=t,this.#o=r,this.#i!==null&&this.#i>=A(
t).length&&(this.#i=null);let s=this.game.length,[a,i]=[this.player.step,n.rules!==t.rules||t.others!==null&&o<2];this.player.length=s,this.#l(),i&&s&&this.player.
jump(s-1),i&&s||Math.abs(s-a)===1?this.player.move(s-this.player.step):this.player.jump(s),this.#h()}#l(){this.player.glide=yo[this.#e.rules.interaction]}#f(){this.#s&&
this.player.arrived&&this.step()}#h(){this.dispatchEvent(new Event("change"))}};function Pr(e,t,r){let n=s=>new Te(e,t,se(s,t),$r(t,s)),o=t.gallery[0].scene;try{return{store:n(r||o),problem:""}}catch(s){return{store:n(o),problem:Ur(s)}}}function Ur(e){
if(e instanceof ne||e instanceof x)return`This link holds no scene. ${e.message}`;throw e}function $r(e,t){return e.gallery.find(r=>r.scene===t)??null}var Re=()=>[
"file:","http:","https:"].includes(location.protocol);function le(){try{return decodeURIComponent(location.hash.slice(1))}catch{return location.hash.slice(1)}}var wo=100;
function Dr(e){let[t,r,n]=[oe(e.scene,e.data),le(),0],o=()=>{n=0,le()===r&&(r=t,history.replaceState(null,"",`#${t}`))};e.addEventListener("change",()=>{t=oe(e.
scene,e.data),t!==r&&!n&&(n=setTimeout(o,wo))}),window.addEventListener("hashchange",()=>{if(r=le(),r!==t)try{e.change(se(r,e.data),{example:$r(e.data,r)})}catch(s){
e.say(Ur(s),!0)}})}function Br(){return JSON.parse(document.getElementById("data").textContent)}var So=matchMedia("(prefers-color-scheme: dark)");function xo(){let e=document.documentElement.dataset.theme;return e?e==="dark":So.matches}function rt(){document.
documentElement.dataset.theme=xo()?"light":"dark"}function Hr(){return c("button",{type:"button",title:"Light or dark (D)","aria-label":"Light or dark",onclick:rt},"◐")}var N=["stay","north","east","south","west","northeast","southeast","southwest","northwest"],nt=["·","↑","→","↓","←","↗","↘","↙","↖"],Wr=e=>typeof e==
"number"?`${nt[e]} ${N[e]}`:e,Ao={obstacle:["obstacle"],teammate:["teammate"],adversary:["evader","pursuer"]},Eo=e=>e.length<2?e.join(""):`${e.slice(0,-1).join(
", ")} and ${e.at(-1)}`;function ke(e,t,r){let[n,o,s]=[t.recording.moments[r-1],t.recording.moments[r],t.outcomes[r]];if(!n||!o||!s)return[];let a=[...s.conflicts.
map(l=>_o(e,t.rules,l)),...Co(e,n,o,s.captors)],i={kind:"calm",text:"No conflict, no capture.",turn:0,blame:"",used:[]};return[...a.length?a:[i],...Mo(e,t,r)]}function _o(e,t,r){
let n=r.at_fault.map(a=>T(e,a)),o=t.interaction==="SIMULTANEOUS"?0:r.turn+1,s=n.length?`At fault: ${Eo(n)}.`:"Nobody is at fault.";return{kind:r.kind,text:`${r.
text}.`,turn:o,blame:s,used:Ao[r.kind]}}function Co(e,t,r,n){let o=[];for(let s=0;s<e.evaders.length;s++){let a=e.pursuers.length+s,i=T(e,a),l=t.alive[a]&&!r.alive[a],
d=n[s]?` by ${n[s]} ${n[s]===1?"pursuer":"pursuers"}`:"",u=["capture",...l?["captured_disappear"]:[]];r.captured[s]&&!t.captured[s]?o.push({kind:"capture",text:`${i}\
 is captured${d}${l?" and disappears":""}.`,turn:0,blame:"",used:u}):t.captured[s]&&!r.captured[s]&&r.alive[a]&&o.push({kind:"capture",text:`${i} is free again.`,
turn:0,blame:"",used:["capture"]})}return o}function Mo(e,t,r){let{terminated:n,truncated:o}=t.outcomes[r];if(!n&&!o)return[];let s=t.recording.moments[r].alive,
a=(d,u)=>Array.from(s).slice(d,u).some(Boolean),i=e.pursuers.length,l=`after ${e.maxSteps} steps`;return n&&(l=a(0,i)?"every evader is captured or gone":"no pur\
suer is left"),n&&!a(i,S(e))&&(l="no evader is left"),[{kind:"end",text:`The episode has ended: ${l}.`,turn:0,blame:"",used:[]}]}function Ne(e){return e.split(/(\(-?\d+, -?\d+\)|-[A-Z]{1,3}\b)/).
map((t,r)=>r%2?c("span",{class:"whole"},t):t)}var zr={ArrowUp:1,ArrowRight:2,ArrowDown:3,ArrowLeft:4},To={e:5,c:6,y:7,z:7,q:8};function Kr(e){let t=c("div",{class:"arena"}),r=[Fr(e,0),Fr(e,1)];t.append(...r.
map(o=>o.element));let n=()=>r.forEach(o=>o.update());return e.addEventListener("change",n),e.player.addEventListener("frame",n),n(),t}function Fr(e,t){let r=c(
"canvas",{tabindex:0,"aria-describedby":"board-keys"}),n=c("h2",{class:"arm-name"}),o=c("figure",{class:"arm"},n,r),s=new Ce(r,{axes:!0,trail:1}),a=new st;Ro(e,
s),Oo(e,r,a);let i=()=>{let l=e.games[t];if(o.hidden=!l,!l)return;let{mode:d,scene:u}=e;r.setAttribute("role","application"),r.ariaLabel=`Board, ${u.rows} by ${u.
cols} cells`,r.dataset.mode=d,n.textContent=O(e,t),n.hidden=e.games.length<2;let p=e.player.arrived&&e.player.step===e.game.length;s.look={plan:d==="act"&&p&&!l.
over?l.actions(u.next):null,selected:d==="act"?e.selected:null,cursor:d==="build"&&document.activeElement===r?a.cell:null},s.show(l.recording,e.player.time)};return r.
addEventListener("focus",i),r.addEventListener("blur",i),a.addEventListener("change",i),{element:o,update:i}}function O(e,t){let r=t?e.scene.others:e.scene.rules,
n=r&&j(r,e.data.variants);return n?`-${n}`:"own rules"}function jr(e,t,r){let[n,o]=[t[0]-e[0],t[1]-e[1]];return!r&&Math.abs(n)>Math.abs(o)?o=0:r||(n=0),z.findIndex(
([s,a])=>s===Math.sign(n)&&a===Math.sign(o))}function ot(e,t){let r=A(e.game.scene())[t];return r&&!r.gone?r.cell:null}function Ro(e,t){let r=null;t.canvas.addEventListener(
"pointerdown",n=>{let o=t.cellAt(n.clientX,n.clientY);if(!o||n.button!==0||e.running)return;t.canvas.setPointerCapture(n.pointerId);let s=t.agentAt(n.clientX,n.
clientY);r=e.mode==="build"?No(e,o,s):ko(e,o,s)}),t.canvas.addEventListener("pointermove",n=>{let o=t.cellAt(n.clientX,n.clientY);o&&r?.(o)});for(let n of["poin\
terup","pointercancel"])t.canvas.addEventListener(n,()=>{r=null})}function ko(e,t,r){if(r===null){let s=e.selected===null?null:ot(e,e.selected);return s&&Math.max(
Math.abs(s[0]-t[0]),Math.abs(s[1]-t[1]))===1&&Y(e,jr(s,t,e.scene.diagonal)),null}let n=e.selected===r;e.selected=r;let o=ot(e,r);return o?(n&&Y(e,0),s=>Y(e,jr(o,
s,e.scene.diagonal))):null}function No(e,t,r){let n=!1,o=i=>{e.change(i,{part:n}),n=!0};if(r!==null)return e.selected=r,i=>{let l=e.game.scene();R(l,i)===null&&
!k(l,i)&&o(Ke(l,r,i))};let s=!k(e.game.scene(),t),a=i=>{let l=e.game.scene();R(l,i)===null&&k(l,i)!==s&&o(Ve(l,i,s))};return a(t),a}function Y(e,t){let{selected:r,
scene:n}=e;r===null||e.running||e.game.over||(n.next[r]!==t&&e.change(be(n,r,t)),e.say(`${T(n,r)}: ${N[t]}.`))}var st=class extends EventTarget{cell=[0,0];move(t,r,n){
let o=(s,a)=>Math.min(a-1,Math.max(0,s));this.cell=[o(this.cell[0]+t[0],r),o(this.cell[1]+t[1],n)],this.dispatchEvent(new Event("change"))}};function Oo(e,t,r){
t.addEventListener("keydown",n=>{if(n.ctrlKey||n.metaKey||n.altKey)return;(e.mode==="act"?at(e,n):Lo(e,n,r))&&n.preventDefault()})}function at(e,t){let r=t.key.
length===1?t.key.toLowerCase():t.key,n=zr[r]??(e.scene.diagonal?To[r]:void 0)??{s:0,Delete:0}[r];return n!==void 0?(e.selected===null&&Gr(e,1),Y(e,n),!0):r!=="n"&&
r!=="p"?!1:(Gr(e,r==="n"?1:-1),!0)}function Gr(e,t){let r=S(e.scene),n=e.game.recording.moments.at(-1).alive,o=e.selected??(t>0?-1:r);for(let s=0;s<r;s++){if(o=
(o+t+r)%r,!n[o])continue;e.selected=o;let[a,i]=ot(e,o);return e.say(`${T(e.scene,o)} at (${a}, ${i}).`)}}function Lo(e,t,r){let n=e.game.scene(),o=zr[t.key];if(o!==
void 0){let a=t.shiftKey?R(n,r.cell):null;r.move(z[o],n.rows,n.cols);let i=R(n,r.cell)===null&&!k(n,r.cell);a!==null&&i&&e.change(Ke(n,a,r.cell));let[l,d]=r.cell;
return e.say(`(${l}, ${d}): ${Io(e,r.cell)}.`),!0}let s=R(n,r.cell);return t.key===" "||t.key==="Enter"?(s===null?e.change(Ve(n,r.cell,!k(n,r.cell))):e.selected=
s,!0):t.key==="Delete"&&s!==null?(e.change(ye(n,s)),!0):!1}function Io(e,t){let r=e.game.scene(),n=R(r,t);return n!==null?T(r,n):k(r,t)?"obstacle":"free"}function it(e){let t=e==="pursuers"?ge("path",{d:"M12 3 22 20H2z"}):ge("circle",{cx:12,cy:12,r:9.5});return ge("svg",{viewBox:"0 0 24 24",class:`glyph ${e}`,"ar\
ia-hidden":!0},t)}function Vr(e){let t=[0,1].map(()=>c("th",{class:"reward",scope:"col"})),r=c("tbody"),n=c("table",{class:"agents"},c("thead",{},c("tr",{},c("t\
h",{scope:"col"},"agent"),c("th",{scope:"col"},"next"),...t)),r),o=c("section",{class:"card agents-card"},c("h2",{},"Agents"),c("div",{class:"agents-scroll"},n)),
s=[],a="",i=()=>{let{scene:l}=e,d=`${l.pursuers.length} ${l.evaders.length} ${l.diagonal}`;d!==a&&(a=d,s=Array.from({length:S(l)},(u,p)=>Po(e,p)),r.replaceChildren(
...s.map(u=>u.element))),t.forEach((u,p)=>{u.hidden=p>=e.games.length,u.textContent=e.games.length>1&&e.games[p]?O(e,p):"reward",u.title="Reward of the step"}),
s.forEach((u,p)=>$o(e,u,p))};return e.addEventListener("change",i),e.player.addEventListener("step",i),i(),o}function Po(e,t){let{scene:r}=e,n=T(r,t),o=c("selec\
t",{"aria-label":`${n} does next`},...Uo(e,r));o.addEventListener("change",()=>{let u=o.value;e.stop(),e.change(be(e.scene,t,/^\d$/.test(u)?Number(u):u))});let s=c(
"span",{class:"state muted"}),a=c("span",{class:"heard"}),i=c("button",{type:"button",class:"agent-name",onclick:()=>e.selected=t},it(Ge(r,t)),n,a),l=[0,1].map(
()=>c("td",{class:"reward numbers"}));return{element:c("tr",{},c("th",{scope:"row"},i),c("td",{},o,s),...l),choice:o,state:s,heard:a,rewards:l}}function Uo(e,t){
let r=N.slice(0,t.diagonal?9:5).map((o,s)=>c("option",{value:s},Wr(s))),n=e.data.scripts.map(({name:o,text:s})=>c("option",{value:o,title:s},o));return[c("optgr\
oup",{label:"move"},...r),c("optgroup",{label:"script"},...n)]}function $o(e,{element:t,choice:r,state:n,heard:o,rewards:s},a){let{scene:i,game:l,player:d}=e,u=l.
recording.moments[Math.min(d.step,l.length)],p=a-i.pursuers.length,h=p>=0&&!!u.captured[p];t.classList.toggle("chosen",e.selected===a),t.classList.toggle("gone",
!u.alive[a]),r.value=String(i.next[a]),r.disabled=!u.alive[a]||l.over,r.hidden=!u.alive[a],n.hidden=!!u.alive[a],n.textContent=h?"captured":"gone",t.classList.toggle(
"captured",h),o.textContent=h?" captured":"",s.forEach((m,g)=>{let f=e.games[g];m.hidden=!f;let w=f?.outcomes[d.step]?.rewards[a];m.textContent=d.step&&w!==void 0?
Do(w):"";let C=l.outcomes[d.step]?.rewards[a];m.classList.toggle("differs",g>0&&w!==void 0&&C!==w)})}function Do(e){let t=String(Number(Math.abs(e).toPrecision(
5)));return e<0?`−${t}`:e>0?`+${t}`:"0"}function Yr(e,...t){let r=c("button",{type:"button",class:"close","aria-label":"Close"},"✕"),n=c("dialog",{"aria-label":e},c("div",{class:"dialog-head"},c("h2",
{},e),r),...t);return r.addEventListener("click",()=>n.close()),n.addEventListener("click",o=>o.target===n&&n.close()),n}function qr(e){let t=c("input",{type:"t\
ext",readonly:!0,"aria-label":"Link"}),r=c("input",{type:"text",readonly:!0,"aria-label":"Scene"}),n=c("p",{class:"muted small",role:"status"}),o=a=>async()=>{a.
select();try{await navigator.clipboard.writeText(a.value),n.textContent="Copied."}catch{n.textContent="Selected: copy it with Ctrl+C."}},s=Yr("Share this scene",
c("p",{},"The link holds the whole scene: board, agents, rules and moves. Nothing is sent anywhere."),c("label",{class:"copy",hidden:!Re()},c("span",{},"Link to\
 this page"),t,c("button",{type:"button",onclick:o(t)},"Copy")),c("label",{class:"copy"},c("span",{},"Scene, for any copy of the playground"),r,c("button",{type:"\
button",onclick:o(r)},"Copy")),n);return{element:s,open:()=>{r.value=`#${oe(e.scene,e.data)}`,t.value=location.href.split("#")[0]+r.value,n.textContent="",s.showModal()}}}
var Bo=[[["Enter"],"play a step"],[["Backspace"],"take the last step back"],[["Home"],"back to the start"],[["Space"],"run, or stop"],[["N","P"],"choose the nex\
t agent, or the one before"],[["↑","→","↓","←"],"the chosen agent moves there next"],[["Q","E","C","Y"],"the same on a diagonal, where the board allows \
it"],[["S"],"the chosen agent stays"],[["1","… 9"],"choose a variant"],[["M"],"change between Move and Build"],[["Ctrl Z","Ctrl Y"],"undo, redo"],[["L"],"link\
 to this scene"],[["D"],"light or dark"],[["?"],"these keys"]],Ho=[[["↑","→","↓","←"],"move the cursor on the board"],[["Space"],"draw or erase an obsta\
cle, or choose the agent there"],[["Shift ↑"],"carry the agent under the cursor"],[["+","-"],"add a pursuer, an evader"],[["Delete"],"remove the agent under t\
he cursor"]];function Jr(){let e=r=>c("dl",{class:"keys"},...r.flatMap(([n,o])=>[c("dt",{},...n.map(s=>c("kbd",{},s))),c("dd",{},o)])),t=c("div",{class:"keys-co\
lumns"},c("div",{},c("h3",{},"Anywhere"),e(Bo)),c("div",{},c("h3",{},"On the board, in Build"),e(Ho),c("h3",{},"With mouse or finger"),c("p",{},"Move: press an \
agent and drag it towards a cell beside it, or choose it and press that cell."),c("p",{},"Build: drag agents; draw on free cells to make obstacles, on obstacles\
 to erase them.")));return Yr("Keys",t)}function Xr(e){let t=e.data.gallery.map(s=>c("button",{type:"button",class:"chip",onclick:()=>{e.stop(),e.mode="act",e.change(se(s.scene,e.data),{example:s}),e.
selected=0}},s.title)),r=c("p",{class:"example-text"}),n=c("nav",{class:"gallery","aria-label":"Examples"},c("div",{class:"chips"},...t),r),o=()=>{e.data.gallery.
forEach((s,a)=>t[a].setAttribute("aria-pressed",String(s===e.example))),r.replaceChildren(...Ne(e.example?.text??"A scene of your own. Choose an example, or cha\
nge this one."))};return e.addEventListener("change",o),o(),n}var Wo={first:"M6 5v14M19 5 9 12l10 7z",back:"M17 5 7 12l10 7z",play:"M7 4.5 19 12 7 19.5z",pause:"M8 5v14M16 5v14",forward:"M7 5l10 7-10 7z",last:"M18 5v14M5 5\
l10 7-10 7z"};function lt(e){let t=document.createElementNS("http://www.w3.org/2000/svg","svg");t.setAttribute("viewBox","0 0 24 24"),t.setAttribute("aria-hidde\
n","true"),t.classList.add("icon");let r=document.createElementNS("http://www.w3.org/2000/svg","path");return r.setAttribute("d",Wo[e]),t.append(r),t}function Zr(e){let t=Fo(e),r=jo(e),n=zo(e),o=Go(e),s=c("p",{class:"message",role:"status"});e.addEventListener("message",l=>{let{text:d,problem:u}=l.detail;s.textContent=
d,s.classList.toggle("problem",u)});let a=[t,r,n,o],i=()=>a.forEach(l=>l.update());return e.addEventListener("change",i),e.addEventListener("change",()=>{s.textContent=
"",s.classList.remove("problem")}),e.player.addEventListener("step",i),i(),c("div",{class:"toolbar"},...a.map(l=>l.element),s)}function Oe(e,t,r,n){return c("bu\
tton",{type:"button",title:`${t} (${r})`,onclick:n},e&&lt(e),c("span",{},t))}function Fo(e){let t=Oe("first","Restart","Home",()=>e.restart()),r=Oe("back","Back",
"Backspace",()=>e.back()),n=Oe("forward","Step","Enter",()=>e.step()),o=Oe("play","Run","Space",()=>e.run());return n.classList.add("primary"),n.id="step",{element:c(
"div",{class:"buttons",role:"group","aria-label":"Steps"},t,r,n,o),update:()=>{for(let s of[t,r])s.setAttribute("aria-disabled",String(!e.game.length));n.setAttribute(
"aria-disabled",String(!e.canStep)),o.setAttribute("aria-disabled",String(!e.canStep&&!e.running)),o.replaceChildren(lt(e.running?"pause":"play"),c("span",{},e.
running?"Stop":"Run"))}}}function jo(e){let t={act:"Move",build:"Build"},r={act:"Choose agents and their moves (M)",build:"Place agents and draw obstacles (M)"},
n=Object.keys(t),o=n.map(s=>c("button",{type:"button",title:r[s],onclick:()=>e.mode=s},t[s]));return{element:c("div",{class:"buttons joined",role:"group","aria-\
label":"What the board does"},...o),update:()=>n.forEach((s,a)=>o[a].setAttribute("aria-pressed",String(e.mode===s)))}}function Go(e){let t=(s,a,i)=>c("button",
{type:"button",title:`Add ${a} (${i})`,"aria-label":`Add ${a}`,onclick:()=>Le(e,s)},"+",it(s)),r=c("button",{type:"button",title:"Remove the chosen agent (Delet\
e)",onclick:()=>ct(e)},"Remove"),n=[t("pursuers","a pursuer","+"),t("evaders","an evader","-"),r],o=c("div",{class:"buttons",role:"group","aria-label":"Agents"},
...n);return{element:o,update:()=>{o.hidden=e.mode!=="build",r.setAttribute("aria-disabled",String(e.selected===null))}}}function zo(e){let t=[8,7,4,1,0,3,2,5,6],
r=t.map(o=>c("button",{type:"button","aria-label":N[o],title:`The chosen agent: ${N[o]}`,onclick:()=>Y(e,o)},nt[o])),n=c("div",{class:"buttons pad",role:"group",
"aria-label":"Move of the chosen agent"},...r);return{element:n,update:()=>{n.hidden=e.mode==="build";let o=e.selected===null?void 0:e.scene.next[e.selected];t.
forEach((s,a)=>{let i=r[a];i.hidden=s>4&&!e.scene.diagonal,i.setAttribute("aria-disabled",String(e.selected===null||e.game.over)),i.setAttribute("aria-pressed",
String(o===s))})}}}function Qr(e){let t=c("button",{type:"button",title:"Undo the last change (Ctrl+Z)",onclick:()=>e.undo()},"Undo"),r=()=>t.setAttribute("aria\
-disabled",String(!e.canUndo));return e.addEventListener("change",r),r(),t}function Le(e,t){let r=e.game.scene(),n=Wt(r);if(!n)return e.say("Every cell is taken\
.",!0);if(r[t].length>=100)return e.say(`${t}: expected at most ${100}`,!0);let o=t==="pursuers"?r.pursuers.length:S(r);e.change(Bt(r,t,n))&&(e.selected=o)}function ct(e){
let{selected:t}=e;if(t===null)return e.say("Choose an agent to remove.",!0);let r=ye(e.game.scene(),t);r.pursuers.length&&r.evaders.length?e.change(r):e.say("A \
team needs at least one agent.",!0)}function en(e,t){let r=Object.keys(e.data.variants),n={Enter:()=>e.step(),Backspace:()=>e.back(),Home:()=>e.restart()," ":()=>e.run(),m:()=>e.mode=e.mode==="act"?
"build":"act",l:t.share,d:rt,"?":t.keys},o={"+":()=>Le(e,"pursuers"),"-":()=>Le(e,"evaders"),Delete:()=>ct(e)};document.addEventListener("keydown",s=>{if(s.defaultPrevented||
document.querySelector("dialog[open]"))return;let a=s.key.length===1?s.key.toLowerCase():s.key;if((s.ctrlKey||s.metaKey)&&!s.altKey){let d={z:()=>s.shiftKey?e.redo():
e.undo(),y:()=>e.redo()}[a];d&&!tn(s.target)&&(s.preventDefault(),d());return}if(s.altKey||Ko(s.target,a))return;let i=r[Number(a)-1],l=n[a]??(e.mode==="build"?
o[a]:void 0);if(l)l();else if(i)e.change({...e.scene,rules:e.data.variants[i]});else if(e.mode!=="act"||!at(e,s))return;s.preventDefault()})}var tn=e=>e instanceof
HTMLInputElement&&!["radio","checkbox"].includes(e.type);function Ko(e,t){return tn(e)||e instanceof HTMLSelectElement?!0:e instanceof HTMLInputElement?t===" "||
t.startsWith("Arrow"):e instanceof HTMLButtonElement?t===" "||t==="Enter":e instanceof HTMLElement&&e.classList.contains("story-body")&&t.startsWith("Arrow")}function rn(e){let t=[Vo(e),...e.data.fields.map(n=>Yo(e,n)),Jo(e),Xo(e)],r=()=>t.forEach(n=>n.update());return e.addEventListener("change",r),e.player.addEventListener(
"step",r),r(),c("section",{class:"card rules"},...t.map(n=>n.element))}var q=(e,t)=>{e.stop(),e.change(t)};function Vo(e){let t=Object.keys(e.data.variants),r=t.
map(o=>c("button",{type:"button",class:"chip",title:e.data.titles[o],onclick:()=>q(e,{...e.scene,rules:e.data.variants[o]})},`-${o}`)),n=c("p",{class:"muted sma\
ll variant-title"});return{element:c("div",{class:"variants"},c("h2",{},"Rules"),c("div",{class:"chips",role:"group","aria-label":"Variant"},...r),n),update:()=>{
let o=j(e.scene.rules,e.data.variants);t.forEach((s,a)=>r[a].setAttribute("aria-pressed",String(s===o))),n.textContent=o?e.data.titles[o]:"Rules of your own"}}}
function Yo(e,t){let r=t.values.map(({name:a})=>{let i=c("input",{type:"radio",name:t.name,value:a});return i.addEventListener("change",()=>q(e,{...e.scene,rules:qo(
e.scene.rules,t,a)})),i}),n=t.values.map(({label:a},i)=>c("label",{},r[i],c("span",{},a))),o=c("span",{class:"used-mark",title:"This rule decided what happened \
in the step that is shown"},c("span",{},"decided")),s=c("fieldset",{class:"field",title:t.text},c("legend",{},t.label,o),c("div",{class:"segments"},...n));return{
element:s,update:()=>{let{rules:a}=e.scene;r.forEach(l=>l.checked=l.value===String(a[t.name])),s.disabled=t.name==="captured_disappear"&&a.capture==="OCCUPATION";
let i=Math.min(e.player.step,e.game.length);o.hidden=!ke(e.scene,e.game,i).some(l=>l.used.includes(t.name))||s.disabled}}}function qo(e,t,r){return{...e,[t.name]:r===
"true"?!0:r==="false"?!1:r}}function Jo(e){let t=Object.keys(e.data.variants),r=c("select",{id:"compare"},c("option",{value:""},"nothing"),c("option",{value:"pr\
esent"},"the present rules"),c("option",{value:"own",hidden:!0},"own rules"),...t.map(n=>c("option",{value:n},`-${n}: ${e.data.titles[n]}`)));return r.addEventListener(
"change",()=>{let n={"":null,present:e.scene.rules}[r.value];q(e,{...e.scene,others:n===void 0?e.data.variants[r.value]:n})}),{element:c("div",{class:"pair"},c(
"label",{for:"compare"},"Compare with"),r),update:()=>{let{others:n}=e.scene,o=n&&t.find(s=>ze(n,e.data.variants[s]));r.value=n?o??"own":"",r.title=n?`Both boar\
ds play the same moves: ${O(e,0)} and ${O(e,1)}`:""}}}function Xo(e){let t=(a,i)=>{let l=c("input",{type:"number",min:1,max:64,"aria-label":i});return l.addEventListener(
"change",()=>{let d={rows:e.scene.rows,cols:e.scene.cols,[a]:Math.round(Number(l.value))};d[a]>=1&&d[a]<=64?Zo(e,d.rows,d.cols):e.say(`${a}: expected 1 to ${64}\
, got ${l.value||"nothing"}`,!0),l.value=String(e.scene[a])}),l},[r,n]=[t("rows","Rows"),t("cols","Columns")],o=c("input",{type:"checkbox",id:"diagonal"});o.addEventListener(
"change",()=>q(e,{...e.game.scene(),diagonal:o.checked,next:e.scene.next.map(a=>typeof a=="number"&&a>4?0:a)}));let s=c("select",{id:"rewards"},...Object.keys(e.
data.rewards).map(a=>c("option",{value:a},a)),c("option",{value:"own",hidden:!0},"those of the link"));return s.addEventListener("change",()=>q(e,{...e.scene,rewards:e.
data.rewards[s.value]})),{element:c("div",{class:"board-settings"},c("div",{class:"pair"},c("span",{},"Board"),c("span",{class:"sides"},r,"×",n),c("label",{class:"\
sides"},o,"diagonal")),c("div",{class:"pair"},c("label",{for:"rewards"},"Rewards"),s)),update:()=>{let{scene:a}=e;document.activeElement!==r&&(r.value=String(a.
rows)),document.activeElement!==n&&(n.value=String(a.cols)),o.checked=a.diagonal;let i=JSON.stringify(a.rewards);s.value=Object.keys(e.data.rewards).find(l=>JSON.
stringify(e.data.rewards[l])===i)??"own"}}}function Zo(e,t,r){let n=Ht(e.game.scene(),t,r);n.pursuers.length&&n.evaders.length?q(e,n):e.say(`No ${n.pursuers.length?
"evader":"pursuer"} would be left on a ${t} × ${r} board.`,!0)}var nn={obstacle:"obstacle",teammate:"teammates",adversary:"adversaries",capture:"capture",end:"end",calm:""};function on(e){let t=c("h2"),r=c("div",{class:"sto\
ry-body",tabindex:0,role:"region","aria-label":"What happened"}),n=c("div",{class:"heard",role:"status"}),o=c("section",{class:"card story"},t,r,n),s="",a=()=>{
let i=Math.min(e.player.step,e.game.length),l=e.games.map((u,p)=>{let h=ke(e.scene,u,i);return{name:e.games.length>1?O(e,p):"",lines:h,ended:i>u.length}}),d=JSON.
stringify([i,l]);d!==s&&(s=d,t.textContent=i?`Step ${i}`:"Start",r.replaceChildren(...l.map(u=>Qo(u,i))),n.textContent=i?`Step ${i}. ${l.map(ts).join(" ")}`:"")};
return e.addEventListener("change",a),e.player.addEventListener("step",a),a(),o}function Qo({name:e,lines:t,ended:r},n){let s=r||!n?c("p",{class:"muted"},r?"The\
 episode had ended.":"Give agents their moves, then play a step."):c("ul",{class:"lines"},...t.map(es));return c("div",{class:"story-part"},e&&c("h3",{},e),s)}function es({
kind:e,text:t,turn:r,blame:n}){let o=r?`${nn[e]}, turn ${r}`:nn[e];return c("li",{class:`line line-${e}`},o&&c("span",{class:"tag"},o),c("span",{class:"line-tex\
t"},...Ne(t)),n&&c("span",{class:"line-blame muted"},n))}var ts=({name:e,lines:t,ended:r})=>[e,...r?["The episode had ended."]:t.map(({text:n,blame:o})=>`${n} ${o}`)].
filter(Boolean).join(" ");function sn(e,t){let r=qr(t),n=Jr(),o=()=>n.showModal(),s=c("header",{class:"top"},c("h1",{},c("span",{class:"muted"},"matrixworld "),"playground"),c("div",{class:"\
buttons"},Qr(t),c("button",{type:"button",title:"Link to this scene (L)",onclick:r.open},"Share"),c("button",{type:"button",title:"Keys (?)",onclick:o},"Keys"),
Hr())),a=c("main",{class:"layout"},rn(t),c("section",{class:"card stage","aria-label":"Board"},Kr(t),Zr(t)),c("div",{class:"side"},on(t),Vr(t)));e.classList.add(
"playground"),e.replaceChildren(s,Xr(t),a,r.element,n),en(t,{share:r.open,keys:o})}async function rs(e){let t=Br(),{store:r,problem:n}=Pr(await It(),t,le()||t.scene);sn(e,r),Re()&&Dr(r),n&&r.say(n,!0),Object.assign(window,{playground:r})}var an=document.
getElementById("page");rs(an).catch(e=>{throw an.append(c("p",{class:"card problem",role:"alert"},`The playground could not start: ${e.message}`)),e}).finally(()=>{
document.body.dataset.ready="true"});})();
