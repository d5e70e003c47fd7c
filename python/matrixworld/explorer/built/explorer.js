/* built from web/ by "npm run build"; sources da027045bad70d587dc1e27d3622aafe70454b913d4aaf34a3a651bd06adcc92 */
"use strict";(()=>{var tn={SIMULTANEOUS:0,SWARM_TURNS:1,AGENT_TURNS:2},Ye={DISAPPEAR:0,REACH:1,BOUNCE:2},rn={OCCUPATION:0,SURROUND:1},nn={FAULT:0,INVOLVED:1};var ar=["obstacle","teammate","adversary"],ir=["vertex","edge","chain"],on=["turn","kind","form","first","second","row","col","at_fault","held","doomed"],lr=["p\
ursuer_{number}","evader_{number}"],sn={obstacle:"{first} ran into the obstacle or border at {cell}",vertex:"{first} and {second} both headed for {cell}",edge:"\
{first} and {second} meant to swap, {first} to {cell}",chain:"{first} headed for {cell}, where {second} had to stay"},qe={"both held":"both bounce","both doomed":"\
both disappear",held:"{agent} bounces",doomed:"{agent} disappears",none:"nobody is stopped"},an="{event}: {outcome}",cr={random:"any action, all equally likely",
still:"always stays",chaser:"moves to where the nearest adversary in view is nearest",fleer:"moves to where the nearest adversary in view is farthest","clumsy-c\
haser":"a chaser that takes any action in half of the steps",hunter:"a chaser of the nearest adversary in view to which no teammate in view is nearer",surrounder:"\
a chaser of the nearest free cell beside an adversary without a teammate","clumsy-fleer":"a fleer that takes any action in half of the steps",dodger:"moves to w\
here all adversaries in view together are farthest","team-surrounder":"shares the free cells beside adversaries with its teammates, and searches","careful-rando\
m":"as random, but takes only moves that right of way allows","careful-chaser":"as chaser, but takes only moves that right of way allows","careful-fleer":"as fl\
eer, but takes only moves that right of way allows","careful-clumsy-chaser":"as clumsy-chaser, but takes only moves that right of way allows","careful-hunter":"\
as hunter, but takes only moves that right of way allows","careful-surrounder":"as surrounder, but takes only moves that right of way allows","careful-clumsy-fl\
eer":"as clumsy-fleer, but takes only moves that right of way allows","careful-dodger":"as dodger, but takes only moves that right of way allows","careful-team-\
surrounder":"as team-surrounder, but takes only moves that right of way allows"},ln={free:".GS",blocked:"#@OTW"};var Oe=1+on.length;function Ze(t,e){return t.replace(/\{(\w+)\}/g,(r,n)=>String(e[n]))}function G(t,e){return t<e?Ze(lr[0],{number:t}):Ze(lr[1],{number:t-e})}function aa(t,e){
let[r,n,o,s,a,i,l,...c]=Array.from(t),u=a<0?[s]:[s,a],[p,d,h]=c.map(v=>u.filter((x,b)=>v>>b&1)),y=u.map(v=>G(v,e)),f=Ze(sn[a<0?"obstacle":ir[o]],{first:y[0],second:y[y.
length-1],cell:`(${i}, ${l})`}),g=Ze(an,{event:f,outcome:ia(u.length,d,h,e)});return{kind:ar[n],form:ir[o],agents:u,cell:[i,l],at_fault:p,held:d,doomed:h,turn:r,
text:g}}function ia(t,e,r,n){if(t===2&&e.length===2)return qe["both held"];if(t===2&&r.length===2)return qe["both doomed"];let o=s=>a=>Ze(qe[s],{agent:G(a,n)});
return[...e.map(o("held")),...r.map(o("doomed"))].join(", ")||qe.none}function vt(t,e){let r=[];for(let n=0;n<t.length;n+=Oe)r.push(aa(t.subarray(n+1,n+Oe),e));
return r}var ve=class extends Error{name="EngineError"};function N(t,e,r){let n=typeof r=="string"?`'${r}'`:typeof r=="object"?JSON.stringify(r):String(r);return new ve(
`${t}: expected ${e}, got ${n}`)}var $e=class{bytes;constructor(e){this.bytes=e}},pn=0,pr=[Uint8Array,Uint8Array,Int32Array,BigInt64Array,BigUint64Array,Float32Array,Float64Array],cn=4,un=4,la=new TextEncoder,
ca=new TextDecoder;function ua(t){for(let e=pr.length-1;e>pn;--e)if(t instanceof pr[e])return e;throw new TypeError("array: expected a typed array of the engine\
's numbers, got another")}function ur(t){return new Uint8Array(t.buffer,t.byteOffset,t.byteLength)}function pa(t){return la.encode(`${t}\0`)}var mr=class{engine;addresses=[];constructor(e){
this.engine=e}copy(e){let r=this.engine._malloc(Math.max(e.length,1));if(r===0)throw new ve("memory: expected room for the arguments, got none");return this.addresses.
push(r),this.engine.HEAPU8.set(e,r),r}text(e){return this.copy(pa(e))}arrays(e){let r=Object.entries(e),n=r.flatMap(([s,a])=>{let i=a instanceof $e,l=i?a.bytes:
a;return[this.text(s),i?pn:ua(l),l.length,this.copy(ur(l))]}),o=this.copy(ur(Int32Array.from(n)));return this.copy(ur(Int32Array.of(r.length,o)))}free(){for(let e of this.
addresses)this.engine._free(e)}};function mn(t,e){let r=t.HEAPU8;return ca.decode(r.subarray(e,r.indexOf(0,e)))}function _e(t){let e=new Int32Array(t.HEAPU8.buffer),
r=t._last_outputs()/cn,n=e[r+1]/cn,o={};for(let s=n;s<n+e[r]*un;s+=un){let a=pr[e[s+1]],i=e[s+2]*a.BYTES_PER_ELEMENT,l=e[s+3];o[mn(t,e[s])]=new a(t.HEAPU8.slice(
l,l+i).buffer)}return o}function be(t,e){let r=new mr(t);try{let n=e(r);if(n===0)throw new ve(mn(t,t._last_error()));return n}finally{r.free()}}var ma=2**31-1,dn=["none","gru"],da=2n**64n-1n,ha=34028234663852886e22;function me(t,e){if(typeof e!="number"||!Number.isInteger(e)||Math.abs(e)>ma)throw N(t,"a\
n integer",e);return Int32Array.of(e)}function bt(t,e){if(typeof e!="boolean")throw N(t,"true or false",e);return new $e(Uint8Array.of(Number(e)))}function xe(t,e,r){
let n=typeof e=="string"&&Object.hasOwn(r,e)?r[e]:void 0;if(n===void 0)throw N(t,`one of ${Object.keys(r).join(", ")}`,e);return Int32Array.of(n)}function dr(t,e){
if(typeof e!="number"||!(Math.abs(e)<=ha))throw N(t,"a finite number",e);return e}function Je(t,e){let n=typeof e=="bigint"||typeof e=="number"&&Number.isSafeInteger(
e)?BigInt(e):-1n;if(n<0n||n>da)throw N(t,"an integer from 0 to 2^64 - 1",e);return BigUint64Array.of(n)}function fa(t){return{"rules.interaction":xe("interactio\
n",t.interaction,tn),"rules.obstacle":xe("obstacle",t.obstacle,Ye),"rules.teammate":xe("teammate",t.teammate,Ye),"rules.evader":xe("evader",t.evader,Ye),"rules.\
pursuer":xe("pursuer",t.pursuer,Ye),"rules.capture":xe("capture",t.capture,rn),"rules.captured_disappear":bt("captured_disappear",t.captured_disappear)}}function hn(t,e){
let r=typeof e=="number"?[e,e,e]:e;if(!Array.isArray(r)||r.length!==3)throw N(t,"1 or 3 numbers",e);return Float32Array.from(r,n=>dr(t,n))}function ya(t){let e=(r,n)=>Float32Array.
of(dr(r,t[r]),dr(n,t[n]));return{"rewards.capture":e("pursuer_capture","evader_capture"),"rewards.neighbor":e("pursuer_neighbor","evader_neighbor"),"rewards.ste\
p":e("pursuer_step","evader_step"),"rewards.pursuer_collide":hn("pursuer_collide",t.pursuer_collide),"rewards.evader_collide":hn("evader_collide",t.evader_collide),
"rewards.blame":xe("blame",t.blame,nn),"rewards.capture_repeats":bt("capture_repeats",t.capture_repeats)}}function yn(t){if(t===void 0||typeof t=="number")return new Uint8Array(
0);if(t instanceof Uint8Array)return t;let{free:e,blocked:r}=ln;for(let[n,o]of t.entries()){if(o.length!==t[0]?.length)throw N(`map, row ${n}`,`${t[0]?.length} \
cells as in row 0`,o.length);let s=[...o].find(a=>!e.includes(a)&&!r.includes(a));if(s)throw N(`map, row ${n}`,`'${e}' (free) or '${r}' (obstacle)`,s)}return Uint8Array.
from([...t.join("")],n=>Number(r.includes(n)))}function gn(t,e){if(!Array.isArray(t))return;let r=[t.length,t[0]?.length??0];if(!(r[0]===e.rows&&r[1]===e.cols))
throw N("obstacle map",`shape (${e.rows}, ${e.cols}), the rows and cols`,r)}function Pe(t){gn(t.obstacles,t);let e=typeof t.obstacles=="number"?t.obstacles:0;return{
...fa(t.rules),...ya(t.rewards),rows:me("rows",t.rows),cols:me("cols",t.cols),n_pursuers:me("n_pursuers",t.n_pursuers),n_evaders:me("n_evaders",t.n_evaders),fov:me(
"fov",t.fov),diagonal:bt("diagonal",t.diagonal),max_steps:me("max_steps",t.max_steps),density:Float64Array.of(e),map:yn(t.obstacles)}}function fn(t,e){return Int32Array.
from((e??[]).flat(),r=>me(t,r)[0])}function vn(t,e){return gn(t.obstacles,e),{seed:Je("seed",t.seed??0n),episode:Je("episode",t.episode??0),pursuers:fn("pursuer\
s",t.pursuers),evaders:fn("evaders",t.evaders),map:yn(t.obstacles)}}function wt(t){return{actions:Int32Array.from(t,e=>me("actions",e)[0])}}function Ne(t){if(typeof t==
"string"){if(!Object.hasOwn(cr,t))throw N("policy",`one of ${Object.keys(cr).join(", ")}`,t);return{script:new TextEncoder().encode(t)}}if(t.activation!=="relu"&&
t.activation!=="tanh")throw N("activation","'relu' or 'tanh'",t.activation);if(!dn.includes(t.memory))throw N("memory",`one of ${dn.join(", ")}`,t.memory);return{
hidden:Int32Array.from(t.hidden,e=>me("hidden",e)[0]),activation:new TextEncoder().encode(t.activation),sampled:bt("sampled",t.sampled),memory:new TextEncoder().
encode(t.memory),genome:t.genome}}var ga=["first_turn","terminated","truncated"];function bn(t){let e={...t};for(let r of ga)e[r]=new $e(t[r]);return e}var wn="statistics.",xt=class{config;seed;episode;n_agents;statistics;first_conflict;constructor(e,r,n,o){this.config=e,this.seed=r,this.episode=n,this.n_agents=
e.n_pursuers+e.n_evaders,this.statistics=ba(xn(o)),Object.assign(this,o),this.first_conflict=va(this.conflict_table,this.length)}get length(){return this.actions.
length/this.n_agents}conflicts(e){this.check(e);let[r,n]=[this.first_conflict[e],this.first_conflict[e+1]],o=this.conflict_table.subarray(r*Oe,n*Oe);return vt(o,
this.config.n_pursuers)}seek(e,r,n){this.check(r),(!(e.seed===this.seed&&e.episode===BigInt(this.episode))||e.turn!==0||e.steps>r)&&e.reset({seed:this.seed,episode:this.
episode});for(let s=e.steps;s<r;++s){let a=this.actions.subarray(s*this.n_agents,(s+1)*this.n_agents);n?e.replay(a,{pursuer:n.pursuers,evader:n.evaders}):e.step(
a)}}check(e){if(!(Number.isInteger(e)&&e>=0&&e<=this.length))throw N("step",`0 to ${this.length}`,e)}};function va(t,e){let r=new Int32Array(e+2);for(let n=0;n<
t.length;n+=Oe)++r[t[n]+1];for(let n=1;n<r.length;++n)r[n]+=r[n-1];return r}function ba(t){let e=["capture_rate","ever_capture_rate","captured_fraction","length"];
return Object.fromEntries(Object.entries(t).map(([r,n])=>[r,e.includes(r)?Number(n[0]):n]))}var xn=t=>Object.fromEntries(Object.entries(t).flatMap(([e,r])=>e.startsWith(
wn)?[[e.slice(wn.length),r]]:[]));function Sn(t,e,r,n){let o=[Pe(r.config),Ne(r.pursuers),Ne(r.evaders),n];return be(t,s=>{let[a,i,l,c]=o.map(u=>s.arrays(u));return t[e](
a,i,l,c)}),_e(t)}function Mn(t,e,r,n){let o={seed:Je("seed",r),episode:Je("episode",n)};return new xt(e.config,r,n,Sn(t,"_play_match",e,o))}function An(t,e,r,n){
if(!Number.isInteger(n)||n<1)throw N("n_episodes","at least 1",n);let o=Sn(t,"_play_rollout",e,{...r,n_episodes:Int32Array.of(n)});return xn(o)}var wa=7e6,xa=new FinalizationRegistry(([t,e])=>t._states_free(e));function Sa({rules:t,rows:e,cols:r,obstacles:n,diagonal:o,n_pursuers:s,n_evaders:a}){let i=typeof n==
"number"||t.obstacle==="REACH"?0:n.join("").split("#").length-1,l=e*r-i,c=[t.obstacle,t.teammate,t.pursuer].includes("DISAPPEAR"),u=t.capture==="SURROUND"||t.evader===
"REACH",p=t.interaction==="AGENT_TURNS",d=(f,g)=>Array.from({length:g},(v,x)=>p?f:(f+x)/(x+1)).reduce((v,x)=>v*x,1),h=d(l+Number(c),s)*d(l*(1+Number(u))+2,a);return{
SIMULTANEOUS:[s+a],SWARM_TURNS:[s,a],AGENT_TURNS:Array(s+a).fill(1)}[t.interaction].reduce((f,g)=>f+h*(o?9:5)**g,0)}function St(t){return typeof t.obstacles=="n\
umber"&&t.obstacles>0?"obstacles are drawn anew in each episode":Sa(t)>wa?"the world is too large to be solved on the page":""}var hr=class{value;teams;matrix;n_actions;constructor(e,r){
let{matrix:n,rows:o,cols:s,value:a,agents:i}=r,[l,c]=e.actors,u=Array.from(i).filter(d=>l<=d&&d<c),p=d=>d<e.config.n_pursuers;[this.value,this.matrix,this.n_actions]=
[a[0],n,e.n_actions],this.teams=[{agents:u.filter(p),play:o},{agents:u.filter(d=>!p(d)),play:s}]}marginal(e){let r=this.teams.find(({agents:s})=>s.includes(e));
if(!r)return null;let n=this.n_actions**(r.agents.length-1-r.agents.indexOf(e)),o=Array(this.n_actions).fill(0);return r.play.forEach((s,a)=>o[Math.floor(a/n)%this.
n_actions]+=s),o}lost(e){let[r,n]=this.teams.map(({agents:l})=>l.reduce((c,u)=>c*this.n_actions+e[u],0)),[o,s]=this.teams.map(({play:l})=>l),a=s.reduce((l,c,u)=>l+
c*this.matrix[r*s.length+u],0),i=o.reduce((l,c,u)=>l+c*this.matrix[u*s.length+n],0);return[Math.max(0,this.value-a),Math.max(0,i-this.value)]}},fr=60,Xe=class{config;payoff;engine;states;n_turns;values;constructor(e,r,n){
[this.engine,this.config,this.payoff]=[e,r,n],this.states=be(e,i=>e._states_new(i.arrays(Pe(r)))),xa.register(this,[e,this.states]);let o={SIMULTANEOUS:1,SWARM_TURNS:2,
AGENT_TURNS:r.n_pursuers+r.n_evaders};this.n_turns=o[r.rules.interaction];let{payoffs:s}=this.call(()=>e._states_payoffs(this.states)),a=s;this.values=[[n==="ca\
pture-rate"?a:a.fill(0)]]}goBack(){let e=this.values.at(-1)[0],r=[];for(let o=this.n_turns-1;o>=0;o--){let s=r[o+1]??e;r[o]=this.backup(o,{next:s})}this.payoff===
"capture-time"&&(r[0]=r[0].map((o,s)=>s===this.config.n_evaders?0:o-1)),this.values.push(r);let n=this.payoff==="capture-rate"?this.config.max_steps:Math.min(this.
config.max_steps,fr);return this.values.length<=n&&r[0].some((o,s)=>o!==e[s])}backup(e,r){return this.call(n=>this.engine._states_backup(this.states,e,n.arrays(
r))).values}game(e){let[r,{turn:n}]=[this.config.max_steps-e.steps,e],o=n+1===this.n_turns,s=r>0?this.values[Math.min(r-Number(o),this.values.length-1)]?.[o?0:n+
1]:void 0;if(!s)return null;let a=this.call(i=>this.engine._states_game(this.states,e.address,i.arrays({next:s})));return a.agents.length?new hr(e,a):null}call(e){
return be(this.engine,e),_e(this.engine)}};var Tn=new FinalizationRegistry(([t,e])=>t._world_free(e)),Qe=class{config;n_agents;n_actions;engine;at;freed=!1;constructor(e,r){this.engine=e,this.config=r,this.
n_agents=r.n_pursuers+r.n_evaders,this.n_actions=r.diagonal?9:5,this.at=be(e,n=>e._world_new(n.arrays(Pe(r)))),Tn.register(this,[e,this.at],this)}free(){this.freed||
(this.freed=!0,Tn.unregister(this),this.engine._world_free(this.at))}get address(){if(this.freed)throw N("world","one that is in use","one that was freed");return this.
at}reset(e={}){let r=vn(e,this.config);this.call(n=>this.engine._world_reset(this.address,n.arrays(r)))}step(e){let r=wt(e);this.call(n=>this.engine._world_step(
this.address,n.arrays(r)))}playTurn(e){let r=wt(e);this.call(n=>this.engine._world_play_turn(this.address,n.arrays(r)))}decide(e,r,n){let{n_pursuers:o}=this.config,
s={pursuer:[0,o],evader:[o,this.n_agents]},[a,i]=typeof r=="string"?s[r]:r;if(n.length!==this.n_agents)throw N("actions",String(this.n_agents),n.length);let l=[
Ne(e),wt(n)],{actions:c}=this.call(u=>this.engine._world_decide(this.address,u.arrays(l[0]),a,i,u.arrays(l[1])));return Uint8Array.from(c)}replay(e,r){let n=s=>typeof s!=
"string"&&s.memory!=="none";if(!n(r.pursuer)&&!n(r.evader))return this.step(e);let{n_pursuers:o}=this.config;for(let s=this.n_turns;s>0;--s){let[a,i]=this.actors;
a<o&&this.decide(r.pursuer,[a,Math.min(i,o)],e),i>o&&this.decide(r.evader,[Math.max(a,o),i],e),this.playTurn(e)}}get n_turns(){return this.turnNumbers()[1]}get turn(){
return this.turnNumbers()[0]}get actors(){let[,,e,r]=this.turnNumbers();return[e,r]}turnNumbers(){return this.call(()=>this.engine._world_turn(this.address)).turn}get steps(){
return this.read("steps")[0]}get seed(){return this.read("seed")[0]}get episode(){return this.read("episode")[0]}get over(){return this.read("terminated")[0]===
1||this.read("truncated")[0]===1}read(e){return this.call(r=>this.engine._world_read(this.address,r.text(e)))[e]}view(e){let r=3*this.config.fov**2;return this.
read("views").slice(e*r,(e+1)*r)}map(){return this.read("state").slice(2*this.config.rows*this.config.cols)}conflicts(){return vt(this.conflictTable(),this.config.
n_pursuers)}conflictTable(){return this.call(()=>this.engine._world_conflicts(this.address)).conflict_table}answer(e,r){let n=Ne(e),{logits:o,memory:s}=this.call(
l=>this.engine._world_logits(this.address,l.arrays(n),r)),a=o,i=this.decide(e,[r,r+1],new Uint8Array(this.n_agents))[r];return{logits:a,probabilities:Ma(a),action:i,
memory:s}}snapshot(){return this.call(()=>this.engine._world_snapshot(this.address))}restore(e){let r=bn(e);this.call(n=>this.engine._world_restore(this.address,
n.arrays(r)))}call(e){return be(this.engine,e),_e(this.engine)}};function Ma(t){let e=Math.max(...t),r=Array.from(t,o=>Math.exp(o-e)),n=r.reduce((o,s)=>o+s,0);return Float32Array.
from(r,o=>o/n)}var yr=class{compiled;constructor(e){this.compiled=e}world(e){return new Qe(this.compiled,e)}solution(e,r="capture-rate"){return new Xe(this.compiled,e,r)}match(e,r,n,o,s=0){
return Mn(this.compiled,{config:e,pursuers:r,evaders:n},o,s)}rollouts(e,r,n,o,s){return An(this.compiled,{config:e,pursuers:r,evaders:n},o,s)}},En;function Cn(t=globalThis.
matrixworldEngine){return En??=Aa(t),En}async function Aa(t){if(!t)throw new Error("matrixworldEngine: expected the script engine.js before this one, got none");
let e=Uint8Array.from(atob(t.binary),r=>r.charCodeAt(0));return new yr(await t({wasmBinary:e}))}var Ta="http://www.w3.org/2000/svg";function m(t,e={},...r){return kn(document.createElement(t),e,r)}function w(t,e={},...r){return kn(document.createElementNS(
Ta,t),e,r)}function kn(t,e,r){for(let[o,s]of Object.entries(e))s==null||s===!1||(typeof s=="function"?t.addEventListener(o.slice(2),s):t.setAttribute(o,s===!0?"":
String(s)));let n=r.filter(o=>o!=null&&o!==!1);return t.append(...n.map(o=>typeof o=="number"?String(o):o)),t}function Rn(t,e){let r=m("select",{onchange:()=>e(
r.value)},...t.map(([n,o])=>m("option",{value:n},o)));return r}async function On(t){try{await t}catch(e){throw(document.querySelector("#page, main")??document.body).
prepend(m("p",{class:"card problem",role:"alert"},`The page could not start: ${String(e)}`)),e}finally{document.body.dataset.ready="true"}}var $n=()=>["file:","\
http:","https:"].includes(location.protocol);var _n=()=>document.documentElement.dataset.theme==="dark",et=t=>{document.documentElement.dataset.theme=t?"dark":"light"},gr=()=>et(!_n());if(typeof document<"\
u"){let t=matchMedia("(prefers-color-scheme: dark)");t.addEventListener("change",()=>et(t.matches)),et(t.matches);let e=!1;addEventListener("beforeprint",()=>{e=
_n(),et(!1)}),addEventListener("afterprint",()=>et(e))}function Pn(){return m("button",{type:"button",title:"Light or dark (D)","aria-label":"Light or dark",onclick:gr},
"◐")}var Nn=(t,e,...r)=>m("header",{class:"top"},m("div",{},m("h1",{},t),e?m("p",{class:"lead"},e):null),m("div",{class:"tools"},...r,Pn()));var Ea=2n**64n-1n;function tt(t,e,r){let n=new URLSearchParams(t.replace(/^#/,"")),o=(c,u,p)=>{let d=n.get(c)??"";return/^\d{1,9}$/.test(d)&&Number(d)<u?Number(
d):p},s=o("run",e.length,r.run),[a,i]=e[s].payoff.shape,l=n.get("seed")??"";return{run:s,pursuer:o("pursuers",a,Math.min(r.pursuer,a-1)),evader:o("evaders",i,Math.
min(r.evader,i-1)),episode:o("episode",1/0,r.episode),seed:/^\d{1,20}$/.test(l)&&BigInt(l)<=Ea?l:null,step:o("step",1/0,0)}}function In(t,e,r){let[n,o,s]=["",JSON.
stringify(e.selected),-800],a=()=>{let{run:i,pursuer:l,evader:c,episode:u,seed:p}=e.selected,d={run:i,pursuers:l,evaders:c,episode:u,...p===null?{}:{seed:p},step:r.
player.step},h=JSON.stringify(e.selected),y=h!==o&&performance.now()-s>800;h!==o&&([o,s]=[h,performance.now()]),n=`#${Object.entries(d).map(([f,g])=>`${f}=${g}`).
join("&")}`;try{y?history.pushState(null,"",n):history.replaceState(null,"",n)}catch{}};a(),e.on("match",a),r.player.addEventListener("state",()=>r.player.playing||
a()),r.player.addEventListener("step",()=>r.player.playing||a()),window.addEventListener("hashchange",()=>{if(location.hash===n)return;let{step:i,...l}=tt(location.
hash,t,e.selected);for(let c of document.querySelectorAll("dialog[open]"))c.close();o=JSON.stringify(l),e.select(l),r.goTo(i)})}var Ca=5e3,Ln=8e3;function Un(t,e,r){
let n=-Ln;for(let o of["pointerdown","pointermove","keydown","wheel"])window.addEventListener(o,()=>n=performance.now(),{passive:!0});setInterval(()=>{if(r()||performance.
now()-n<Ln)return;let{run:o,pursuer:s,evader:a}=e.selected,[i,l]=t[o].payoff.shape;s===i-1&&a===l-1&&history.replaceState(null,"",`#run=${o}`),location.reload()},
Ca)}var _=Uint8Array,X=Uint16Array,Er=Int32Array,At=new _([0,0,0,0,0,0,0,0,1,1,1,1,2,2,2,2,3,3,3,3,4,4,4,4,5,5,5,5,0,0,0,0]),Tt=new _([0,0,0,0,1,1,2,2,3,3,4,4,5,5,6,
6,7,7,8,8,9,9,10,10,11,11,12,12,13,13,0,0]),xr=new _([16,17,18,0,8,7,9,6,10,5,11,4,12,3,13,2,14,1,15]),Hn=function(t,e){for(var r=new X(31),n=0;n<31;++n)r[n]=e+=
1<<t[n-1];for(var o=new Er(r[30]),n=1;n<30;++n)for(var s=r[n];s<r[n+1];++s)o[s]=s-r[n]<<5|n;return{b:r,r:o}},jn=Hn(At,2),Gn=jn.b,Sr=jn.r;Gn[28]=258,Sr[258]=28;var Vn=Hn(
Tt,0),ka=Vn.b,Fn=Vn.r,Mr=new X(32768);for(T=0;T<32768;++T)de=(T&43690)>>1|(T&21845)<<1,de=(de&52428)>>2|(de&13107)<<2,de=(de&61680)>>4|(de&3855)<<4,Mr[T]=((de&65280)>>
8|(de&255)<<8)>>1;var de,T,ie=(function(t,e,r){for(var n=t.length,o=0,s=new X(e);o<n;++o)t[o]&&++s[t[o]-1];var a=new X(e);for(o=1;o<e;++o)a[o]=a[o-1]+s[o-1]<<1;
var i;if(r){i=new X(1<<e);var l=15-e;for(o=0;o<n;++o)if(t[o])for(var c=o<<4|t[o],u=e-t[o],p=a[t[o]-1]++<<u,d=p|(1<<u)-1;p<=d;++p)i[Mr[p]>>l]=c}else for(i=new X(
n),o=0;o<n;++o)t[o]&&(i[o]=Mr[a[t[o]-1]++]>>15-t[o]);return i}),we=new _(288);for(T=0;T<144;++T)we[T]=8;var T;for(T=144;T<256;++T)we[T]=9;var T;for(T=256;T<280;++T)
we[T]=7;var T;for(T=280;T<288;++T)we[T]=8;var T,ot=new _(32);for(T=0;T<32;++T)ot[T]=5;var T,Ra=ie(we,9,0),Oa=ie(we,9,1),$a=ie(ot,5,0),_a=ie(ot,5,1),vr=function(t){
for(var e=t[0],r=1;r<t.length;++r)t[r]>e&&(e=t[r]);return e},oe=function(t,e,r){var n=e/8|0;return(t[n]|t[n+1]<<8)>>(e&7)&r},br=function(t,e){var r=e/8|0;return(t[r]|
t[r+1]<<8|t[r+2]<<16)>>(e&7)},Cr=function(t){return(t+7)/8|0},kr=function(t,e,r){return(e==null||e<0)&&(e=0),(r==null||r>t.length)&&(r=t.length),new _(t.subarray(
e,r))};var Pa=["unexpected EOF","invalid block type","invalid length/literal","invalid distance","stream finished","no stream handler",,"no callback","invalid UTF-8 da\
ta","extra field too long","date not in range 1980-2099","filename too long","stream finishing","invalid zip data"],V=function(t,e,r){var n=new Error(e||Pa[t]);
if(n.code=t,Error.captureStackTrace&&Error.captureStackTrace(n,V),!r)throw n;return n},Na=function(t,e,r,n){var o=t.length,s=n?n.length:0;if(!o||e.f&&!e.l)return r||
new _(0);var a=!r,i=a||e.i!=2,l=e.i;a&&(r=new _(o*3));var c=function(Ve){var Ke=r.length;if(Ve>Ke){var Re=new _(Math.max(Ke*2,Ve));Re.set(r),r=Re}},u=e.f||0,p=e.
p||0,d=e.b||0,h=e.l,y=e.d,f=e.m,g=e.n,v=o*8;do{if(!h){u=oe(t,p,1);var x=oe(t,p+1,3);if(p+=3,x)if(x==1)h=Oa,y=_a,f=9,g=5;else if(x==2){var k=oe(t,p,31)+257,C=oe(
t,p+10,15)+4,A=k+oe(t,p+5,31)+1;p+=14;for(var M=new _(A),I=new _(19),P=0;P<C;++P)I[xr[P]]=oe(t,p+P*3,7);p+=C*3;for(var W=vr(I),ge=(1<<W)-1,q=ie(I,W,1),P=0;P<A;){
var H=q[oe(t,p,ge)];p+=H&15;var b=H>>4;if(b<16)M[P++]=b;else{var U=0,O=0;for(b==16?(O=3+oe(t,p,3),p+=2,U=M[P-1]):b==17?(O=3+oe(t,p,7),p+=3):b==18&&(O=11+oe(t,p,
127),p+=7);O--;)M[P++]=U}}var j=M.subarray(0,k),F=M.subarray(k);f=vr(j),g=vr(F),h=ie(j,f,1),y=ie(F,g,1)}else V(1);else{var b=Cr(p)+4,S=t[b-4]|t[b-3]<<8,E=b+S;if(E>
o){l&&V(0);break}i&&c(d+S),r.set(t.subarray(b,E),d),e.b=d+=S,e.p=p=E*8,e.f=u;continue}if(p>v){l&&V(0);break}}i&&c(d+131072);for(var Ge=(1<<f)-1,te=(1<<g)-1,pe=p;;pe=
p){var U=h[br(t,p)&Ge],Z=U>>4;if(p+=U&15,p>v){l&&V(0);break}if(U||V(2),Z<256)r[d++]=Z;else if(Z==256){pe=p,h=null;break}else{var J=Z-254;if(Z>264){var P=Z-257,$=At[P];
J=oe(t,p,(1<<$)-1)+Gn[P],p+=$}var ae=y[br(t,p)&te],Ce=ae>>4;ae||V(3),p+=ae&15;var F=ka[Ce];if(Ce>3){var $=Tt[Ce];F+=br(t,p)&(1<<$)-1,p+=$}if(p>v){l&&V(0);break}
i&&c(d+131072);var ke=d+J;if(d<F){var yt=s-F,gt=Math.min(F,ke);for(yt+d<0&&V(3);d<gt;++d)r[d]=n[yt+d]}for(;d<ke;++d)r[d]=r[d-F]}}e.l=h,e.p=pe,e.b=d,e.f=u,h&&(u=
1,e.m=f,e.d=y,e.n=g)}while(!u);return d!=r.length&&a?kr(r,0,d):r.subarray(0,d)},he=function(t,e,r){r<<=e&7;var n=e/8|0;t[n]|=r,t[n+1]|=r>>8},rt=function(t,e,r){
r<<=e&7;var n=e/8|0;t[n]|=r,t[n+1]|=r>>8,t[n+2]|=r>>16},wr=function(t,e){for(var r=[],n=0;n<t.length;++n)t[n]&&r.push({s:n,f:t[n]});var o=r.length,s=r.slice();if(!o)
return{t:Yn,l:0};if(o==1){var a=new _(r[0].s+1);return a[r[0].s]=1,{t:a,l:1}}r.sort(function(E,k){return E.f-k.f}),r.push({s:-1,f:25001});var i=r[0],l=r[1],c=0,
u=1,p=2;for(r[0]={s:-1,f:i.f+l.f,l:i,r:l};u!=o-1;)i=r[r[c].f<r[p].f?c++:p++],l=r[c!=u&&r[c].f<r[p].f?c++:p++],r[u++]={s:-1,f:i.f+l.f,l:i,r:l};for(var d=s[0].s,n=1;n<
o;++n)s[n].s>d&&(d=s[n].s);var h=new X(d+1),y=Ar(r[u-1],h,0);if(y>e){var n=0,f=0,g=y-e,v=1<<g;for(s.sort(function(k,C){return h[C.s]-h[k.s]||k.f-C.f});n<o;++n){
var x=s[n].s;if(h[x]>e)f+=v-(1<<y-h[x]),h[x]=e;else break}for(f>>=g;f>0;){var b=s[n].s;h[b]<e?f-=1<<e-h[b]++-1:++n}for(;n>=0&&f;--n){var S=s[n].s;h[S]==e&&(--h[S],
++f)}y=e}return{t:new _(h),l:y}},Ar=function(t,e,r){return t.s==-1?Math.max(Ar(t.l,e,r+1),Ar(t.r,e,r+1)):e[t.s]=r},Dn=function(t){for(var e=t.length;e&&!t[--e];)
;for(var r=new X(++e),n=0,o=t[0],s=1,a=function(l){r[n++]=l},i=1;i<=e;++i)if(t[i]==o&&i!=e)++s;else{if(!o&&s>2){for(;s>138;s-=138)a(32754);s>2&&(a(s>10?s-11<<5|
28690:s-3<<5|12305),s=0)}else if(s>3){for(a(o),--s;s>6;s-=6)a(8304);s>2&&(a(s-3<<5|8208),s=0)}for(;s--;)a(o);s=1,o=t[i]}return{c:r.subarray(0,n),n:e}},nt=function(t,e){
for(var r=0,n=0;n<e.length;++n)r+=t[n]*e[n];return r},Kn=function(t,e,r){var n=r.length,o=Cr(e+2);t[o]=n&255,t[o+1]=n>>8,t[o+2]=t[o]^255,t[o+3]=t[o+1]^255;for(var s=0;s<
n;++s)t[o+s+4]=r[s];return(o+4+n)*8},Wn=function(t,e,r,n,o,s,a,i,l,c,u){he(e,u++,r),++o[256];for(var p=wr(o,15),d=p.t,h=p.l,y=wr(s,15),f=y.t,g=y.l,v=Dn(d),x=v.c,
b=v.n,S=Dn(f),E=S.c,k=S.n,C=new X(19),A=0;A<x.length;++A)++C[x[A]&31];for(var A=0;A<E.length;++A)++C[E[A]&31];for(var M=wr(C,7),I=M.t,P=M.l,W=19;W>4&&!I[xr[W-1]];--W)
;var ge=c+5<<3,q=nt(o,we)+nt(s,ot)+a,H=nt(o,d)+nt(s,f)+a+14+3*W+nt(C,I)+2*C[16]+3*C[17]+7*C[18];if(l>=0&&ge<=q&&ge<=H)return Kn(e,u,t.subarray(l,l+c));var U,O,j,
F;if(he(e,u,1+(H<q)),u+=2,H<q){U=ie(d,h,0),O=d,j=ie(f,g,0),F=f;var Ge=ie(I,P,0);he(e,u,b-257),he(e,u+5,k-1),he(e,u+10,W-4),u+=14;for(var A=0;A<W;++A)he(e,u+3*A,
I[xr[A]]);u+=3*W;for(var te=[x,E],pe=0;pe<2;++pe)for(var Z=te[pe],A=0;A<Z.length;++A){var J=Z[A]&31;he(e,u,Ge[J]),u+=I[J],J>15&&(he(e,u,Z[A]>>5&127),u+=Z[A]>>12)}}else
U=Ra,O=we,j=$a,F=ot;for(var A=0;A<i;++A){var $=n[A];if($>255){var J=$>>18&31;rt(e,u,U[J+257]),u+=O[J+257],J>7&&(he(e,u,$>>23&31),u+=At[J]);var ae=$&31;rt(e,u,j[ae]),
u+=F[ae],ae>3&&(rt(e,u,$>>5&8191),u+=Tt[ae])}else rt(e,u,U[$]),u+=O[$]}return rt(e,u,U[256]),u+O[256]},La=new Er([65540,131080,131088,131104,262176,1048704,1048832,
2114560,2117632]),Yn=new _(0),Ia=function(t,e,r,n,o,s){var a=s.z||t.length,i=new _(n+a+5*(1+Math.ceil(a/7e3))+o),l=i.subarray(n,i.length-o),c=s.l,u=(s.r||0)&7;if(e){
u&&(l[0]=s.r>>3);for(var p=La[e-1],d=p>>13,h=p&8191,y=(1<<r)-1,f=s.p||new X(32768),g=s.h||new X(y+1),v=Math.ceil(r/3),x=2*v,b=function(sr){return(t[sr]^t[sr+1]<<
v^t[sr+2]<<x)&y},S=new Er(25e3),E=new X(288),k=new X(32),C=0,A=0,M=s.i||0,I=0,P=s.w||0,W=0;M+2<a;++M){var ge=b(M),q=M&32767,H=g[ge];if(f[q]=H,g[ge]=q,P<=M){var U=a-
M;if((C>7e3||I>24576)&&(U>423||!c)){u=Wn(t,l,0,S,E,k,A,I,W,M-W,u),I=C=A=0,W=M;for(var O=0;O<286;++O)E[O]=0;for(var O=0;O<30;++O)k[O]=0}var j=2,F=0,Ge=h,te=q-H&32767;
if(U>2&&ge==b(M-te))for(var pe=Math.min(d,U)-1,Z=Math.min(32767,M),J=Math.min(258,U);te<=Z&&--Ge&&q!=H;){if(t[M+j]==t[M+j-te]){for(var $=0;$<J&&t[M+$]==t[M+$-te];++$)
;if($>j){if(j=$,F=te,$>pe)break;for(var ae=Math.min(te,$-2),Ce=0,O=0;O<ae;++O){var ke=M-te+O&32767,yt=f[ke],gt=ke-yt&32767;gt>Ce&&(Ce=gt,H=ke)}}}q=H,H=f[q],te+=
q-H&32767}if(F){S[I++]=268435456|Sr[j]<<18|Fn[F];var Ve=Sr[j]&31,Ke=Fn[F]&31;A+=At[Ve]+Tt[Ke],++E[257+Ve],++k[Ke],P=M+j,++C}else S[I++]=t[M],++E[t[M]]}}for(M=Math.
max(M,P);M<a;++M)S[I++]=t[M],++E[t[M]];u=Wn(t,l,c,S,E,k,A,I,W,M-W,u),c||(s.r=u&7|l[u/8|0]<<3,u-=7,s.h=g,s.p=f,s.i=M,s.w=P)}else{for(var M=s.w||0;M<a+c;M+=65535){
var Re=M+65535;Re>=a&&(l[u/8|0]=c,Re=a),u=Kn(l,u+1,t.subarray(M,Re))}s.i=a}return kr(i,0,n+Cr(u)+o)},Ua=(function(){for(var t=new Int32Array(256),e=0;e<256;++e){
for(var r=e,n=9;--n;)r=(r&1&&-306674912)^r>>>1;t[e]=r}return t})(),Fa=function(){var t=-1;return{p:function(e){for(var r=t,n=0;n<e.length;++n)r=Ua[r&255^e[n]]^r>>>
8;t=r},d:function(){return~t}}};var Da=function(t,e,r,n,o){if(!o&&(o={l:1},e.dictionary)){var s=e.dictionary.subarray(-32768),a=new _(s.length+t.length);a.set(s),a.set(t,s.length),t=a,o.w=s.length}
return Ia(t,e.level==null?6:e.level,e.mem==null?o.l?Math.ceil(Math.max(8,Math.min(13,Math.log(t.length)))*1.5):20:12+e.mem,r,n,o)},qn=function(t,e){var r={};for(var n in t)
r[n]=t[n];for(var n in e)r[n]=e[n];return r};var D=function(t,e,r){for(;r;++e)t[e]=r,r>>>=8};var Wa=function(t,e){return((t[0]&15)!=8||t[0]>>4>7||(t[0]<<8|t[1])%31)&&V(6,"invalid zlib data"),(t[1]>>5&1)==+!e&&V(6,"invalid zlib data: "+(t[1]&32?"need":"u\
nexpected")+" dictionary"),(t[1]>>3&4)+2};function za(t,e){return Da(t,e||{},0,0)}function Zn(t,e){return Na(t.subarray(Wa(t,e&&e.dictionary),-4),{i:2},e&&e.out,e&&e.dictionary)}var Jn=function(t,e,r,n){for(var o in t){var s=t[o],a=e+o,i=n;Array.isArray(s)&&(i=qn(n,s[1]),s=s[0]),s instanceof _?r[a]=[s,i]:(r[a+="/"]=[new _(0),i],Jn(s,a,r,
n))}},zn=typeof TextEncoder<"u"&&new TextEncoder,Ba=typeof TextDecoder<"u"&&new TextDecoder,Ha=0;try{Ba.decode(Yn,{stream:!0}),Ha=1}catch{}function Mt(t,e){if(e){for(var r=new _(t.length),n=0;n<t.length;++n)r[n]=t.charCodeAt(n);return r}if(zn)return zn.encode(t);for(var o=t.length,s=new _(t.length+
(t.length>>1)),a=0,i=function(u){s[a++]=u},n=0;n<o;++n){if(a+5>s.length){var l=new _(a+8+(o-n<<1));l.set(s),s=l}var c=t.charCodeAt(n);c<128||e?i(c):c<2048?(i(192|
c>>6),i(128|c&63)):c>55295&&c<57344?(c=65536+(c&1047552)|t.charCodeAt(++n)&1023,i(240|c>>18),i(128|c>>12&63),i(128|c>>6&63),i(128|c&63)):(i(224|c>>12),i(128|c>>
6&63),i(128|c&63))}return kr(s,0,a)}var Tr=function(t){var e=0;if(t)for(var r in t){var n=t[r].length;n>65535&&V(9),e+=n+4}return e},Bn=function(t,e,r,n,o,s,a,i){var l=n.length,c=r.extra,u=i&&i.length,
p=Tr(c);D(t,e,a!=null?33639248:67324752),e+=4,a!=null&&(t[e++]=20,t[e++]=r.os),t[e]=20,e+=2,t[e++]=r.flag<<1|(s<0&&8),t[e++]=o&&8,t[e++]=r.compression&255,t[e++]=
r.compression>>8;var d=new Date(r.mtime==null?Date.now():r.mtime),h=d.getFullYear()-1980;if((h<0||h>119)&&V(10),D(t,e,h<<25|d.getMonth()+1<<21|d.getDate()<<16|d.
getHours()<<11|d.getMinutes()<<5|d.getSeconds()>>1),e+=4,s!=-1&&(D(t,e,r.crc),D(t,e+4,s<0?-s-2:s),D(t,e+8,r.size)),D(t,e+12,l),D(t,e+14,p),e+=16,a!=null&&(D(t,e,
u),D(t,e+6,r.attrs),D(t,e+10,a),e+=14),t.set(n,e),e+=l,p)for(var y in c){var f=c[y],g=f.length;D(t,e,+y),D(t,e+2,g),t.set(f,e+4),e+=4+g}return u&&(t.set(i,e),e+=
u),e},ja=function(t,e,r,n,o){D(t,e,101010256),D(t,e+8,r),D(t,e+10,r),D(t,e+12,n),D(t,e+16,o)};function Xn(t,e){e||(e={});var r={},n=[];Jn(t,"",r,e);var o=0,s=0;for(var a in r){var i=r[a],l=i[0],c=i[1],u=c.level==0?0:8,p=Mt(a),d=p.length,h=c.comment,y=h&&
Mt(h),f=y&&y.length,g=Tr(c.extra);d>65535&&V(11);var v=u?za(l,c):l,x=v.length,b=Fa();b.p(l),n.push(qn(c,{size:l.length,crc:b.d(),c:v,f:p,m:y,u:d!=a.length||y&&h.
length!=f,o,compression:u})),o+=30+d+g+x,s+=76+2*(d+g)+(f||0)+x}for(var S=new _(s+22),E=o,k=s-o,C=0;C<n.length;++C){var p=n[C];Bn(S,p.o,p,p.f,p.u,p.c.length);var A=30+
p.f.length+Tr(p.extra);S.set(p.c,p.o+A),Bn(S,o,p,p.f,p.u,p.c.length,p.o,p.m),o+=16+A+(p.m?p.m.length:0)}return ja(S,o,n.length,k,E),S}var K=(t,e)=>`${t}s of generation ${e}`,le=["stay","north","east","south","west","northeast","southeast","southwest","northwest"];var se=["pursuer","evader"],eo=()=>JSON.parse(kt("data"));function Le(t,e,r){let[n,o]=[e-t.payoff.first[0],r-t.payoff.first[1]],s=t.payoff.capture_rate[n]?.[o];
return s===void 0?null:{rate:s,rates:t.payoff.capture_rates[n][o],lengths:t.payoff.lengths[n][o]}}function Et(t,e,r){let{script:n,network:o,kept:s,genomes:a}=t.
teams[e];if(n!==null||o===null)return"";if(!s.includes(r))return`The page holds no genome of ${K(e,r)}: it would be too large. Choose a generation of ${s.join("\
, ")}.`;let i=s.length*o.genome_size;return to(a,o.genome_size).length===i?"":`The page is damaged: it does not hold the ${i} numbers of the ${e}s' genomes. Wri\
te it again from its run.`}function re(t,e,r){let{script:n,network:o,kept:s,genomes:a}=t.teams[e];if(n!==null||o===null)return n??"random";let i=s.indexOf(r);if(i<
0)throw new RangeError(`${e}: expected a generation whose genome the page holds, got ${r}`);let l=o.genome_size,c=to(a,l).subarray(i*l,(i+1)*l),{hidden:u,activation:p,
sampled:d,memory:h}=o;return{hidden:u,activation:p,sampled:d,memory:h,genome:c}}function Ct(t,e,{pursuer:r,evader:n,episode:o,seed:s}){let a=e.seeds[r][n];return t.
match(e.world,re(e,"pursuer",r),re(e,"evader",n),BigInt(s??a),o)}var Rr=4,Qn=new Map;function to(t,e){let r=Qn.get(t);if(r)return r;let n=new Float32Array;try{let o=Va(Or(t),e);o.every(Number.isFinite)&&(n=o)}catch(o){if(!(o instanceof DOMException||
o instanceof RangeError||Ga(o)))throw o}return Qn.set(t,n),n}var Ga=t=>t instanceof Error&&"code"in t;function Va(t,e){let r=Zn(t),n=r.length/Rr,o=new Uint8Array(
r.length);for(let a=0;a<o.length;a++)o[a]=r[a%Rr*n+Math.floor(a/Rr)];let s=new Uint32Array(o.buffer);for(let a=e;a<s.length;a++)s[a]^=s[a-e];return new Float32Array(
o.buffer)}function Or(t){let e=atob(kt(t)),r=new Uint8Array(e.length);for(let n=0;n<r.length;n++)r[n]=e.charCodeAt(n);return r}var kt=t=>document.getElementById(
t)?.textContent??"";var st=[.5,1,2,4,8,16,32,64],Rt=0,Ot=12,Ka=2,Ie=class extends EventTarget{#e;#r;#t;#n=0;#a=0;#s=!1;#c=null;#m=0;#p=[];#d=[];glide=.28;constructor(e,{speed:r=4,still:n=!1}={}){
super(),[this.#e,this.#r,this.#t]=[e,r,n]}get step(){return this.#n}get time(){return this.#t?this.#n:this.#a}get arrived(){return this.#a===this.#n}get playing(){
return this.#s}get length(){return this.#e}set length(e){this.#e=e,this.#n>e&&this.jump(e),this.#o("state")}get marks(){return this.#p}set marks(e){this.#p=e,this.#o(
"state")}get ticks(){return this.#d}set ticks(e){this.#d=e,this.#o("state")}get pace(){return this.#r||Math.max(Ka,this.#e/Ot)}get speed(){return this.#r}set speed(e){
this.#r=e,this.#o("state")}changeSpeed(e){let r=st.findIndex(n=>n>=this.pace);this.speed=st[Math.min(st.length-1,Math.max(0,r+e))]}play(){this.#s||!this.#e||(this.#n===
this.#e&&this.jump(0),this.#s=!0,this.#o("state"),this.#i())}pause(){this.#s&&(this.#s=!1,this.#o("state"))}toggle(){this.#s?this.pause():this.play()}move(e){this.
pause();let r=Math.min(this.#e,Math.max(0,this.#n+e));Math.abs(r-this.#a)>1?this.jump(r):this.#u(r),this.#i()}jump(e){this.#a=Math.min(this.#e,Math.max(0,Math.round(
e))),this.#u(this.#a),this.#o("frame")}#u(e){e!==this.#n&&(this.#n=e,this.#o("step"),this.#t&&this.#o("frame"))}#i(){this.#c===null&&(this.#m=performance.now(),
this.#c=requestAnimationFrame(()=>this.#h()))}#h(){this.#c=null;let e=performance.now();this.#l(Math.min(.25,(e-this.#m)/1e3)),this.#m=e,(!this.#t||this.arrived)&&
this.#o("frame"),(this.#s||this.#a!==this.#n)&&(this.#c=requestAnimationFrame(()=>this.#h()))}#l(e){let r=e;for(;r>0;){if(this.#a===this.#n){if(!this.#s)return;
if(this.#n===this.#e)return this.pause();this.#u(this.#n+1)}let n=this.#s?this.pace:1/this.glide,o=this.#n-this.#a,s=Math.min(Math.abs(o),r*n);r-=s/n,this.#a=s===
Math.abs(o)?this.#n:this.#a+Math.sign(o)*s}this.#s&&this.#a===this.#e&&this.pause()}#o(e){this.dispatchEvent(new Event(e))}};function Ue(t,e){if(e.ctrlKey||e.metaKey||
e.altKey)return!1;let r=e.shiftKey?10:1,o={" ":()=>t.toggle(),ArrowRight:()=>t.move(r),ArrowLeft:()=>t.move(-r),Home:()=>t.move(-t.length),End:()=>t.move(t.length),
"+":()=>t.changeSpeed(1),"-":()=>t.changeSpeed(-1)}[e.key];return o?.(),o!==void 0}function ro(t,e,...r){let n=m("dialog",{class:e,"aria-label":t,onclick:({target:o})=>o===n&&n.close()},m("div",{class:"dialog-head"},m("h2",{},t),m("button",{type:"\
button",class:"close","aria-label":"Close",onclick:()=>n.close()},"✕")),...r);return n}var no=t=>m("dl",{class:"keys"},...t.flatMap(([e,r])=>[m("dt",{},...e.map(
n=>m("kbd",{},n))),m("dd",{},r)])),oo=t=>m("input",{type:"text",readonly:!0,"aria-label":t});function so(t,e){let r=URL.createObjectURL(new Blob([e],{type:"appl\
ication/octet-stream"}));m("a",{href:r,download:t}).click(),setTimeout(()=>URL.revokeObjectURL(r),6e4)}var L=(t,e=2)=>t==null?"-":t.toFixed(e);function ao(t,e,r){return e===null||r===null?L(t):`${L(t)} (${L(e)} to ${L(r)})`}var io=t=>t.toLocaleString("en-GB"),Se=t=>t.
charAt(0).toUpperCase()+t.slice(1);function at(t,e,r,n=!1){let o=(e-t)/Math.max(1,r),s=10**Math.floor(Math.log10(o||1)),a=[1,2,5,10].map(c=>c*s).find(c=>c>=o)??
10*s;n&&(a=Math.max(1,Math.round(a)));let i=Math.ceil(t/a-1e-9),l=Math.floor(e/a+1e-9);return Array.from({length:Math.max(0,l-i+1)},(c,u)=>(i+u)*a)}var it=[[68,1,84],[72,26,108],[71,47,125],[65,68,135],[57,86,140],[49,104,142],[42,120,142],[35,136,142],[31,152,139],[34,168,132],[53,183,121],[84,197,104],[122,
209,81],[165,219,54],[210,226,27],[253,231,37]];function $t(t){let e=Math.min(1,Math.max(0,t))*(it.length-1),r=Math.min(it.length-2,Math.floor(e)),[n,o]=[it[r],
it[r+1]],s=a=>Math.round(n[a]+(e-r)*(o[a]-n[a]));return[s(0),s(1),s(2)]}function lo(t){let[e,r,n]=$t(t).map(o=>((o/255+.055)/1.055)**2.4);return .2126*e+.7152*r+
.0722*n>.179?"#000":"#fff"}var co=t=>`rgb(${$t(t).join(" ")})`,uo=()=>`linear-gradient(to right, ${it.map(t=>`rgb(${t.join(" ")})`).join(", ")})`;function _t(t,e,r){let n=devicePixelRatio||1;for(let[a,i]of Object.entries(r))t.style.setProperty(a,`${i}px`);t.width=Math.round(r.width*n),t.height=Math.round(
r.height*n);let o=t.getContext("2d"),s=$r(e);!o||!s||(o.imageSmoothingEnabled=!1,o.drawImage(s,0,0,t.width,t.height))}function $r(t){let[e,r]=t.shape,n=document.
createElement("canvas");[n.width,n.height]=[r,e];let o=n.getContext("2d");if(!o)return null;let s=o.createImageData(r,e);return t.capture_rate.forEach((a,i)=>a.
forEach((l,c)=>{let u=4*((e-1-i-t.first[0])*r+c+t.first[1]);s.data.set([...$t(l),255],u)})),o.putImageData(s,0,0),n}function Pt(t,e,r,n=2){t.textContent=L(e,n),
t.ariaLabel=`${r}: ${t.textContent}`,e!==void 0&&([t.style.backgroundColor,t.style.color]=[co(e),lo(e)])}function Nt(t,e){let r=m("span",{class:"gradient"});return r.
style.backgroundImage=uo(),m("p",{class:"scale-of-rates small muted"},t,r,e)}var Ya=84;function po(t,e){let r=t.map((s,a)=>qa(s,a,e)),n=m("nav",{class:"races","aria-label":"Runs"},...r.map(s=>s.button)),o=()=>r.forEach((s,a)=>s.update(a===
e.selected.run));return e.on("match hover",o),o(),n.hidden=t.length<2,n}function qa(t,e,r){let[n,o]=t.payoff.shape,s=!t.name.startsWith(t.schedule),a=Ya/Math.max(
n,o),i=m("canvas",{"aria-hidden":"true"});_t(i,t.payoff,{left:0,top:0,width:o*a,height:n*a});let l=m("span",{class:"place"}),c=m("button",{type:"button",class:"\
race",title:`${t.name} (key ${e+1})`,onclick:()=>_r(t,e,r)},m("span",{class:"small-matrix"},i,l),m("span",{class:"race-text"},m("strong",{},s?t.name:t.schedule),
m("span",{class:"small"},t.findings?t.findings.headline:`${t.learning.join(" and ")}s against ${Za(t)}`),m("span",{class:"small muted"},`${s?`${t.schedule}, `:""}\
seed ${t.seed}`)));return{button:c,update:p=>{c.setAttribute("aria-current",String(p));let d=r.hover.pursuer??r.selected.pursuer,h=r.hover.evader??r.selected.evader;
l.hidden=d>=n||h>=o,l.style.left=`${(h+.5)*a}px`,l.style.top=`${(n-d-.5)*a}px`}}}var Za=t=>t.teams.pursuer.script??t.teams.evader.script??"another run";function _r(t,e,r){
let[n,o]=t.payoff.shape,{pursuer:s,evader:a}=r.selected;r.select({run:e,pursuer:Math.min(s,n-1),evader:Math.min(a,o-1)})}var Ja=[[["Space"],"play or pause"],[["←","→"],"step back or forward; with Shift ten steps"],[["Home","End"],"first or last step"],[["+","−"],"faster or s\
lower"],[["N"],"next episode of the same pair; with Shift the one before"],[["R"],"another seed, not one of the evaluation"],[["O"],"the cell's own seed again"],
[["P"],"next pursuer generation; with Shift the one before"],[["E"],"next evader generation; with Shift the one before"],[["M"],"to the matrix: arrow keys choos\
e a match, Enter plays it"],[["A"],"next agent: what it sees; with Shift the one before"],[["Esc"],"no agent"],[["T"],"take over the chosen agent, or an evader,\
 from this step on"],[["G"],"this step in the playground: any other rules, actions and places"],[["1","9"],"first to ninth run"],[["D"],"light or dark"],[["?"],
"this list"]],mo=()=>ro("Keys","help",no(Ja),m("p",{class:"muted small"},"The page holds the genomes and the engine of this run. A click on a cell plays that ve\
ry match: same seed, same moves. The page loads nothing from elsewhere; share the file as it is."));function ho(t,e,r,n,o,s){let a=(l,c)=>()=>{let u=t[e.selected.
run].payoff.shape[l==="pursuer"?0:1];e.select({[l]:Math.min(u-1,Math.max(0,e.selected[l]+c))})},i={n:()=>e.select({episode:e.selected.episode+1}),N:()=>e.select(
{episode:Math.max(0,e.selected.episode-1)}),r:()=>e.select({seed:String(crypto.getRandomValues(new BigUint64Array(1))[0]),episode:0}),o:()=>e.select({seed:null,
episode:0}),p:a("pursuer",1),P:a("pursuer",-1),e:a("evader",1),E:a("evader",-1),m:()=>document.getElementById("matrix")?.focus(),a:()=>r.inspector.next(1),A:()=>r.
inspector.next(-1),Escape:()=>r.inspector.choose(null),t:o,g:s,d:gr,"?":()=>n.showModal()};document.addEventListener("keydown",l=>{let c=l.target instanceof HTMLSelectElement||
l.target instanceof HTMLInputElement,u=l.target instanceof HTMLButtonElement&&(l.key===" "||l.key==="Enter");if(document.querySelector("dialog[open]")||c||u||l.
defaultPrevented||l.ctrlKey||l.metaKey||l.altKey)return;let p=i[l.key]??i[l.key.toLowerCase()],d=Number(l.key)-1;if(Ue(r.player,l)||p)p?.();else if(t[d])_r(t[d],
d,e);else return;l.preventDefault()})}var Fe=[[0,0],[-1,0],[0,1],[1,0],[0,-1],[-1,1],[1,1],[1,-1],[-1,-1]];function fo(t,e,r){let[n,o]=[e[0]-t[0],e[1]-t[1]];return!r&&Math.abs(n)>Math.abs(o)?o=0:r||
(n=0),Fe.findIndex(([s,a])=>s===Math.sign(n)&&a===Math.sign(o))}var Me=(t,e)=>e<t.nPursuers,R=(t,e)=>[t.positions[2*e],t.positions[2*e+1]],Pr=({rows:t,cols:e},[
r,n])=>r>=0&&n>=0&&r<t&&n<e,Nr=(t,e,r=3)=>t!==void 0&&[0,1,2].slice(0,r).some(n=>t[3*e+n]),Lr=(t,e)=>Nr(t.fault,e),yo=(t,e)=>!Lr(t,e)&&Nr(t.involved,e,2);function Lt(t,e,r){
let[n,o]=[R(t,r),R(e,r)],s=n[0]!==o[0]||n[1]!==o[1],a=e.involved===void 0||Nr(e.involved,r);return!!(e.alive[r]&&e.actions?.[r]&&!s&&a)}function It(t,e,r){let[n,
o]=R(t,r),[s,a]=Fe[e.actions?.[r]??0];return[n+s,o+a]}function lt(t,e,r){return Array.from({length:r.everCaptured.length},(o,s)=>s).filter(o=>r.everCaptured[o]&&
!e.everCaptured[o]).map(o=>t.nPursuers+o)}var go=t=>t.moments.flatMap((e,r)=>r&&lt(t,t.moments[r-1],e).length?[r]:[]);function Ut(t,e){return Array.from({length:e.
alive.length},(n,o)=>o).filter(n=>t.alive[n]&&!e.alive[n])}var vo=[-.31,0,.31],bo=[{size:1,at:[[0,0]]},{size:.62,at:[[-.2,.2],[.2,-.2]]},{size:.54,at:[[-.23,.22],[.23,.22],[0,-.22]]},{size:.54,at:[[-.23,.23],[.23,.23],[
-.23,-.23],[.23,-.23]]},{size:.36,at:vo.flatMap(t=>vo.map(e=>[e,t]))}],Xa=.3,Qa=.35,ei=.55;function ct(t,e){let r=new Map;for(let n=0;n<e.alive.length;n++){if(!e.
alive[n])continue;let[o,s]=R(e,n),a=o*t.cols+s,i=r.get(a);i?i.push(n):r.set(a,[n])}return r}function wo(t,e){let r=Array.from(e.alive,(n,o)=>{let[s,a]=R(e,o);return{
x:a+.5,y:s+.5,size:1,alpha:0}});for(let n of ct(t,e).values()){let o=bo[Math.min(n.length,bo.length)-1];n.forEach((s,a)=>{let[i,l]=o.at[Math.min(a,o.at.length-1)],
c=r[s];c.x+=i,c.y+=l,c.size=o.size,c.alpha=1})}return r}var xo=t=>t*t*(3-2*t),De=(t,e,r)=>t+(e-t)*r,So=t=>Math.min(1,Math.max(0,t));function Mo(t,e,r,n){let o={
SIMULTANEOUS:1,SWARM_TURNS:2,AGENT_TURNS:r}[t.interaction];if(o===1)return xo(n);let s=o===r?e:+!Me(t,e),a=Math.max(1/o,Qa);return xo(So((n-s/(o-1)*(1-a))/a))}function Ft(t,e){
let r=t.moments.length-1,n=Math.min(Math.floor(e),r),o=t.moments[n],s=wo(t,o);if(n===r||e===n)return s;let a=t.moments[n+1],i=wo(t,a);return s.map((l,c)=>{let u=Mo(
t,c,s.length,e-n);return ti(o,a,c,l,i[c],u)})}function Ir(t,e,r){let n=t.moments.length-1,o=Math.min(Math.floor(r),n),[s,a]=[t.moments[o],t.moments[Math.min(o+1,
n)]],i=Mo(t,e,s.alive.length,r-o),[[l,c],[u,p]]=[R(s,e),R(a,e)];return[De(c,p,i)+.5,De(l,u,i)+.5]}function ti(t,e,r,n,o,s){let a=n.alpha>o.alpha,i={x:De(n.x,o.x,
s),y:De(n.y,o.y,s),size:a?n.size:De(n.size,o.size,s),alpha:a?So((1-s)/(1-ei)):De(n.alpha,o.alpha,s)};if(Lt(t,e,r)){let[l,c]=R(t,r),[u,p]=It(t,e,r),d=Xa*Math.sin(
Math.PI*s);i.x+=(p-c)*d,i.y+=(u-l)*d}return i}var Ao=2*Math.PI;function Ae(t,e,r,n){t.beginPath(),t.arc(e,r,n/2,0,Ao)}function Dt(t,e,r,n){let o=n/2,s=[[0,-.97],[.97,.83],[-.97,.83]].map(([a,i])=>[e+a*o,r+i*
o]);t.beginPath(),t.moveTo((s[2][0]+s[0][0])/2,(s[2][1]+s[0][1])/2),s.forEach(([a,i],l)=>{let[c,u]=s[(l+1)%3];t.arcTo(a,i,c,u,n*.09)}),t.closePath()}function To(t,e,r,n){
let o=n*.32;t.beginPath(),t.moveTo(e-o,r-o),t.lineTo(e+o,r+o),t.moveTo(e+o,r-o),t.lineTo(e-o,r+o)}function Eo(t,e,r,n){t.beginPath();for(let o=0;o<16;o++){let s=n/
2*(o%2?.6:.95),a=Ao*o/16;t.lineTo(e+s*Math.sin(a),r-s*Math.cos(a))}t.closePath()}function Co(t,e,r,n,o,s){let a=Math.atan2(o-r,n-e);t.beginPath(),t.moveTo(e,r),
t.lineTo(n,o);for(let i of[-1,1])t.moveTo(n,o),t.lineTo(n-s*Math.cos(a+i*.6),o-s*Math.sin(a+i*.6))}var ko=4,ri=1.6,ni=.95,oi=5,si=.16,ai=9,ii=.09,li=.2,Ro=.75,z=(t,e)=>t.left+e*t.cell,B=(t,e)=>t.top+e*t.cell;function We(t,e,r){return Me(e,r)?t.colors.pursuer:
t.colors.evader}function Wt({ctx:t,colors:e},r,n,o,s,a,i=0){t.font=`700 ${Math.round(s)}px system-ui, sans-serif`,t.textAlign="center",t.textBaseline="middle",t.
strokeStyle=e.paper,t.lineWidth=i,i&&t.strokeText(r,n,o),t.fillStyle=a,t.fillText(r,n,o)}function Oo({ctx:t,grid:e,colors:r}){let{left:n,top:o,cell:s,rows:a,cols:i}=e,
[l,c]=[i*s,a*s];if(t.fillStyle=r.paper,t.fillRect(n,o,l,c),s<oi)return;t.fillStyle=r.line;let u=Math.max(1,Math.round(s/60));for(let p=1;p<i;p++)t.fillRect(n+p*
s,o,u,c);for(let p=1;p<a;p++)t.fillRect(n,o+p*s,l,u)}function $o({ctx:t,grid:e,colors:r},n){let{left:o,top:s,cell:a,rows:i,cols:l}=e;t.fillStyle=r.obstacle;for(let c=0;c<
i*l;c++){if(!n.obstacles[c])continue;let[u,p]=[Math.floor(c/l),c%l];t.fillRect(o+p*a,s+u*a,a,a)}_o({ctx:t,grid:e,colors:r})}function _o({ctx:t,grid:{left:e,top:r,
cell:n,rows:o,cols:s},colors:a}){let i=Math.min(5,Math.max(2,Math.round(n/18)));t.strokeStyle=a.frame,t.lineWidth=i,t.strokeRect(e-i/2,r-i/2,s*n+i,o*n+i)}function Po({
ctx:t,grid:e,colors:r},n){let{left:o,top:s,cell:a,rows:i,cols:l}=e,c=a<24*n?5:1;t.font=`500 ${Math.round(Math.min(15*n,Math.max(9*n,a*.32)))}px system-ui, sans-\
serif`,t.fillStyle=r.muted,t.textBaseline="alphabetic",t.textAlign="center";let u=5*n+a/40;for(let p=0;p<l;p+=c)t.fillText(String(p),o+(p+.5)*a,s-u);t.textAlign=
"right",t.textBaseline="middle";for(let p=0;p<i;p+=c)t.fillText(String(p),o-u,s+(p+.5)*a)}function No({grid:t},e,r,n){let o=Math.floor(e.fov/2)+.5,[s,a]=[Math.max(
0,r-o),Math.min(t.cols,r+o)],[i,l]=[Math.max(0,n-o),Math.min(t.rows,n+o)];return[z(t,s),B(t,i),(a-s)*t.cell,(l-i)*t.cell]}function Lo(t,e,r,n){let{ctx:o,grid:s,
colors:a}=t;o.save(),o.beginPath(),o.rect(0,0,o.canvas.width,o.canvas.height),o.rect(...No(t,e,r,n)),o.clip("evenodd"),o.clearRect(0,0,o.canvas.width,o.canvas.height),
o.fillStyle=a.line,o.fillRect(s.left,s.top,s.cols*s.cell,s.rows*s.cell),o.restore(),_o(t)}function Io(t,{x:e,y:r,alpha:n},o){let{ctx:s,grid:a,colors:i}=t,l=Math.
max(a.cell,16*o)*1.06,[c,u]=[z(a,e),B(a,r)];s.globalAlpha=Math.max(n,.6),s.beginPath(),s.roundRect(c-l/2,u-l/2,l,l,l*.2),s.strokeStyle=i.focus,s.lineWidth=Math.
max(2,2.5*o),s.stroke();let p=Math.max(11*o,Math.min(18*o,a.cell*.5)),d=u-l/2<p*1.2,h=u+(d?1:-1)*(l/2+p*.7);s.lineJoin="round",Wt(t,"You",c,h,p,i.ink,p*.35),s.globalAlpha=
1}function Uo(t,e,r,n,o){let{ctx:s,grid:a}=t,i=No(t,e,n,o),l=We(t,e,r);s.globalAlpha=.11,s.fillStyle=l,s.fillRect(...i),s.globalAlpha=.8,s.strokeStyle=l,s.lineWidth=
Math.max(1,a.cell/24),s.strokeRect(...i),s.globalAlpha=1}function Fo(t,e,r,n,o){let{ctx:s,grid:a}=t,i=Math.min(Math.ceil(r),e.moments.length-1),l=e.moments[i];s.
lineCap="round",s.lineWidth=Math.min(ai,Math.max(1,a.cell*si));for(let c=Math.max(1,Math.floor(r-n)+1);c<=i;c++){let[u,p]=[e.moments[c-1],e.moments[c]],d=Math.max(
0,Math.min(1,(r-c)/n));s.globalAlpha=Ro+(li-Ro)*d;for(let h=0;h<p.alive.length;h++){let y=c===i&&r<i;if(!u.alive[h]||!(l.alive[h]||y))continue;let f=(Me(e,h)?-1:
1)*ii,[g,v]=R(u,h),[x,b]=R(p,h);if(g===x&&v===b)continue;let S=y?o[h].x:b+.5,E=y?o[h].y:x+.5;s.strokeStyle=We(t,e,h),s.beginPath(),s.moveTo(z(a,v+.5+f),B(a,g+.5+
f)),s.lineTo(z(a,S+f),B(a,E+f)),s.stroke()}}s.globalAlpha=1}function Do(t,e,r){let n=Math.min(Math.ceil(r),e.moments.length-1);for(let o=Math.max(1,n-ko+1);o<=n;o++){
let[s,a]=[e.moments[o-1],e.moments[o]],i=o>r?Math.max(0,1-2*(o-r)):1-(r-o)/ko,l=lt(e,s,a);for(let c of Ut(s,a))l.includes(c)||ui(t,R(a,c),i);for(let c of l)ci(t,
R(a,c),i)}t.ctx.globalAlpha=1}function ci({ctx:t,grid:e,colors:r},[n,o],s){t.globalAlpha=s,Eo(t,z(e,o+.5),B(e,n+.5),Math.max(8,e.cell*ri)),t.fillStyle=r.capture,
t.fill(),t.strokeStyle=r.ink,t.lineWidth=Math.max(1,e.cell/36),t.lineJoin="round",t.stroke()}function ui({ctx:t,grid:e,colors:r},[n,o],s){t.globalAlpha=s,To(t,z(
e,o+.5),B(e,n+.5),Math.max(7,e.cell*ni)),t.strokeStyle=r.collision,t.lineWidth=Math.max(2,e.cell*.17),t.lineCap="round",t.stroke()}function Wo({ctx:t,grid:e,colors:r},n,o){
let s=Math.max(1,e.cell*.07);t.strokeStyle=t.fillStyle=r.collision,t.lineWidth=Math.max(1,e.cell*.05),t.setLineDash([e.cell*.14,e.cell*.1]);for(let[a,i]of n){if(a<
0||i<0||a>=e.rows||i>=e.cols)continue;let l=[z(e,i)+s,B(e,a)+s,e.cell-2*s,e.cell-2*s];t.globalAlpha=.2*o,t.fillRect(...l),t.globalAlpha=o,t.strokeRect(...l)}t.setLineDash(
[]),t.globalAlpha=1}function zo({ctx:t,grid:e,colors:r},n,o,s,a){t.globalAlpha=a,Ae(t,z(e,n),B(e,o),Math.max(8,e.cell*s*1.02)),t.strokeStyle=r.collision,t.lineWidth=
Math.max(1.5,e.cell*.085*Math.sqrt(s)),t.stroke(),t.globalAlpha=1}var pi=.8,mi=.92,di=15,hi=7,Ur=9;function Bo(t,e,r,n,o,s){n.forEach((a,i)=>{a.alpha>0&&fi(t,e,r,i,a,o,s)}),t.ctx.globalAlpha=1;for(let a of ct(e,r).values())a.length>
Ur&&yi(t,n[a[Ur-1]],a.length-Ur+1)}function fi(t,e,r,n,o,s,a){let{ctx:i,grid:l,colors:c}=t,u=Me(e,n),[p,d]=[z(l,o.x),B(l,o.y)],h=Math.max(4,l.cell*o.size*(u?mi:
pi)),y=We(t,e,n),f=!u&&!!r.captured[n-e.nPursuers];if(i.globalAlpha=o.alpha,(u?Dt:Ae)(i,p,d,h),h>hi*a&&(i.strokeStyle=c.paper,i.lineWidth=Math.max(2,h*.1),i.stroke()),
i.fillStyle=f?c.paper:y,i.fill(),f&&(Ae(i,p,d,h*.82),i.strokeStyle=y,i.lineWidth=h*.18,i.stroke()),!s||h<di*a)return;let g=String(u?n:n-e.nPursuers),v=h*(u?.4:.5)*
(g.length>1?.8:1);Wt(t,g,p,d+h*(u?.17:.03),v,f?y:c.paper)}function yi(t,e,r){let{cell:n}=t.grid;Wt(t,`+${r}`,z(t.grid,e.x),B(t.grid,e.y),n*.3,t.colors.ink,n*.1)}var gi=.46,vi=.86,bi=.66,Ho=.48,wi=.78,xi=.58;function jo(t,e,r,n){let[o,s]=[e.moments[r-1],e.moments[r]];if(!o)return;let{ctx:a,grid:i,colors:l}=t;a.strokeStyle=
l.collision,a.lineWidth=Math.max(1.5,i.cell*.07),a.lineCap="butt",a.globalAlpha=n;for(let c=0;c<s.alive.length;c++)Lt(o,s,c)&&Si(t,e,R(o,c),It(o,s,c));a.globalAlpha=
1}function Si({ctx:t,grid:e},r,n,o){let[s,a]=[o[1]-n[1],o[0]-n[0]],i=p=>z(e,n[1]+.5+s*p),l=p=>B(e,n[0]+.5+a*p),c=Pr(r,o)?wi:xi;t.setLineDash([e.cell*.09,e.cell*
.06]),t.beginPath(),t.moveTo(i(Ho),l(Ho)),t.lineTo(i(c),l(c)),t.stroke(),t.setLineDash([]);let u=.17*e.cell/Math.hypot(s,a);t.beginPath(),t.moveTo(i(c)-a*u,l(c)+
s*u),t.lineTo(i(c)+a*u,l(c)-s*u),t.stroke()}function Go(t,e,r,n,o,s){let a=Fe[s];if(!s||!a)return;let{ctx:i,grid:l,colors:c}=t,u=Pr(e,[n[0]+a[0],n[1]+a[1]])?vi:
bi,p=gi*o.size,d=[z(l,o.x+a[1]*p),B(l,o.y+a[0]*p),z(l,o.x+a[1]*u),B(l,o.y+a[0]*u)],h=Math.max(1.5,l.cell*.085);i.lineCap=i.lineJoin="round";for(let[y,f]of[[c.paper,
h*2.1],[We(t,e,r),h]])i.strokeStyle=y,i.lineWidth=f,Co(i,...d,l.cell*.2),i.stroke()}var Ko={numbers:!0,axes:!1,trail:6,viewers:[],plan:null,selected:null,cursor:null,you:null,fog:!1};function Yo(t,e,r,n,o){let{ctx:s,grid:a,colors:i}=t,l=Math.min(
Math.ceil(r),e.moments.length-1),c=e.moments[l],u=r===l,p=Ft(e,r),d=u?1:Math.max(0,1-2*(l-r));s.clearRect(0,0,s.canvas.width,s.canvas.height),Oo(t);for(let f of n.
viewers)p[f]?.alpha&&Uo(t,e,f,...Ir(e,f,r));$o(t,e),n.axes&&Po(t,o),Fo(t,e,r,n.trail,p),Wo(t,c.contested??[],d),Do(t,e,r),jo(t,e,l,d),p.forEach(({x:f,y:g,size:v},x)=>{
let b=yo(c,x)?.4:0,S=Lr(c,x)?1:b;S&&zo(t,f,g,v,S*d)});let h=u?c:e.moments[Math.max(0,l-1)];if(Bo(t,e,h,p,n.numbers,o),u&&n.plan)for(let[f,g]of p.entries())g.alpha&&
Go(t,e,f,R(c,f),g,n.plan[f]??0);n.you!==null&&(n.fog&&Lo(t,e,...Ir(e,n.you,r)),Io(t,p[n.you],o)),s.lineWidth=Math.max(2,2.5*o),s.strokeStyle=i.focus;let y=n.selected===
null?void 0:p[n.selected];y?.alpha&&Vo(t,y.x,y.y,y.size*.96),n.cursor&&(s.setLineDash([a.cell*.12,a.cell*.08]),Vo(t,n.cursor[1]+.5,n.cursor[0]+.5,.8),s.setLineDash(
[]))}function Vo({ctx:t,grid:e},r,n,o){let s=o*e.cell;t.beginPath(),t.roundRect(e.left+r*e.cell-s/2,e.top+n*e.cell-s/2,s,s,s*.1),t.stroke()}var qo=(t,e)=>(e+.24)/(t+.24);function Zo(t,e,r,n,o,s){let a=r?28*s:0,i=(c,u)=>(c-a)/(u+2*.12),l=Math.max(1,Math.floor(Math.min(i(n,e),i(o,t))));return{rows:t,cols:e,
cell:l,left:Math.round((n-e*l+a)/2),top:Math.round((o-t*l+a)/2)}}function Jo(t,e,r){let n=Math.floor((r-t.top)/t.cell),o=Math.floor((e-t.left)/t.cell);return n>=
0&&n<t.rows&&o>=0&&o<t.cols?[n,o]:null}var Mi=["paper","line","frame","ink","muted","obstacle"],Ai=["pursuer","evader","capture","collision","focus"];function zt(t){let e=getComputedStyle(t),r=(n,o)=>[
n,e.getPropertyValue(o+n).trim()];return Object.fromEntries([...Mi.map(n=>r(n,"--board-")),...Ai.map(n=>r(n,"--"))])}var Be=()=>matchMedia("(prefers-reduced-motion: reduce)").matches,ze=class{canvas;#e=null;#r=0;#t;#n={rows:1,cols:1,left:0,top:0,cell:1};#a=0;constructor(e,r={}){
this.canvas=e,e.classList.add("board"),e.setAttribute("role","img"),this.#t={...Ko,...r},new ResizeObserver(()=>this.#c()).observe(e),new MutationObserver(()=>this.
redraw()).observe(document.documentElement,{attributes:!0}),addEventListener("beforeprint",()=>this.drawNow())}set look(e){this.#t={...this.#t,...e},this.#s(),this.
redraw()}show(e,r){this.#e=e,this.#r=Math.min(Math.max(0,r),e.moments.length-1),this.#s(),this.redraw()}redraw(){this.#a||(this.#a=requestAnimationFrame(()=>this.
drawNow()))}drawNow(){cancelAnimationFrame(this.#a),this.#a=0;let e=this.canvas.getContext("2d");if(!e||!this.#e)return;let{rows:r,cols:n}=this.#e,o=devicePixelRatio||
1;this.#n=Zo(r,n,this.#t.axes,this.canvas.width,this.canvas.height,o);let s={ctx:e,grid:this.#n,colors:zt(this.canvas)};Yo(s,this.#e,this.#r,this.#t,o)}cellAt(e,r){
let n=this.canvas.getBoundingClientRect(),o=this.canvas.width/n.width;return Jo(this.#n,(e-n.left)*o,(r-n.top)*o)}agentAt(e,r){let n=this.cellAt(e,r);if(!n||!this.#e)
return null;let o=this.#e.moments[Math.round(this.#r)],s=ct(this.#e,o).get(n[0]*this.#e.cols+n[1])??[],a=Ft(this.#e,Math.round(this.#r)),i=l=>{let[c,u]=this.pointOf(
a[l].x,a[l].y);return Math.hypot(c-e,u-r)};return s.length?s.reduce((l,c)=>i(c)<i(l)?c:l):null}pointOf(e,r){let n=this.canvas.getBoundingClientRect(),o=n.width/
this.canvas.width,{left:s,top:a,cell:i}=this.#n;return[n.left+(s+e*i)*o,n.top+(a+r*i)*o]}#s(){if(!this.#e)return;let{rows:e,cols:r}=this.#e;this.canvas.style.setProperty(
"--board-aspect",String(qo(e,r)))}#c(){let e=devicePixelRatio||1,{width:r,height:n}=this.canvas.getBoundingClientRect();this.canvas.width=Math.max(1,Math.round(
r*e)),this.canvas.height=Math.max(1,Math.round(n*e)),this.drawNow()}};function Fr(t,e,r){let{rows:n,cols:o,n_pursuers:s,fov:a,rules:{interaction:i}}=t;return{rows:n,cols:o,nPursuers:s,fov:a,interaction:i,obstacles:e,moments:r}}function Dr(t,e){
return{positions:t.read("last_positions"),alive:t.read("alive"),captured:t.read("captured"),everCaptured:t.read("ever_captured"),actions:e,involved:t.read("invo\
lved"),fault:t.read("fault"),contested:t.conflicts().map(r=>r.cell)}}function Xo(t){let e=Array.from({length:t.length+1},(r,n)=>Ti(t,n));return Fr(t.config,t.map,
e)}function Ti(t,e){let r=t.n_agents,n=t.config.n_evaders,o=(a,i,l)=>a.subarray(i*l,(i+1)*l),s={positions:o(t.last_positions,e,2*r),alive:o(t.alive,e,r),captured:o(
t.captured,e,n),everCaptured:o(t.ever_captured,e,n)};return e===0?s:{...s,actions:o(t.actions,e-1,r),involved:o(t.involved,e-1,3*r),fault:o(t.fault,e-1,3*r),get contested(){
return t.conflicts(e).map(a=>a.cell)}}}var Ei=Array.from({length:16},(t,e)=>{let[r,n]=[e%2?6.5:11,Math.PI*e/8];return`${12+r*Math.sin(n)} ${12-r*Math.cos(n)}`}).join(" ");function Qo(){let t=[["pursu\
er",w("path",{d:"M12 3 22 20H2z",class:"filled-pursuer"})],["evader",w("circle",{cx:12,cy:12,r:9,class:"filled-evader"})],["capture",w("polygon",{points:Ei,class:"\
filled-capture"})],["captured evader",w("circle",{cx:12,cy:12,r:7.5,class:"ring-evader"})],["conflict",w("rect",{x:3,y:3,width:18,height:18,class:"dashed-confli\
ct"})]];return m("ul",{class:"shapes small","aria-label":"Shapes on the board"},...t.map(([e,r])=>m("li",{},w("svg",{viewBox:"0 0 24 24","aria-hidden":"true"},r),
e)))}var Ci={first:"M6 5v14M19 5 9 12l10 7z",back:"M17 5 7 12l10 7z",play:"M7 4.5 19 12 7 19.5z",pause:"M8 5v14M16 5v14",forward:"M7 5l10 7-10 7z",last:"M18 5v14M5 5\
l10 7-10 7z"};function es(t){return w("svg",{viewBox:"0 0 24 24","aria-hidden":"true",class:"icon"},w("path",{d:Ci[t]}))}function ut(t,e,r,n){return m("button",
{type:"button",class:"player-button","aria-label":e,title:`${e} (${r})`,onclick:n},es(t))}function Bt(t){let e=ut("play","Play","Space",()=>t.toggle()),r=m("inp\
ut",{type:"range",class:"player-scrub",min:0,step:1,"aria-label":"Step",oninput:()=>{t.pause(),t.jump(Number(r.value))}}),n=m("div",{class:"captures","aria-hidd\
en":"true",title:"Captures"}),o=m("div",{class:"losses","aria-hidden":"true"}),s=m("select",{class:"player-speed","aria-label":"Speed",title:`Steps a second, or\
 the whole in ${Ot} s (+ and -)`,onchange:()=>t.speed=Number(s.value)},m("option",{value:Rt},`in ${Ot} s`),...st.map(p=>m("option",{value:p},`${p} / s`))),a=m("\
output",{class:"player-count"}),i=m("div",{class:"player",role:"group","aria-label":"Player"},ut("first","First step","Home",()=>t.move(-t.length)),ut("back","S\
tep back","←",()=>t.move(-1)),e,ut("forward","Step forward","→",()=>t.move(1)),ut("last","Last step","End",()=>t.move(t.length)),m("div",{class:"scrub"},n,o,
r),a,s),l=(p,d={})=>{let h=m("i",d);return h.style.left=`${100*p/Math.max(1,t.length)}%`,h},c=()=>{n.replaceChildren(...t.marks.map(p=>l(p))),o.replaceChildren(
...t.ticks.map(({step:p,kind:d,size:h,text:y})=>{let f=l(p,{class:d,title:`Step ${p}: ${y}`});return f.style.height=`${100*h}%`,f}))},u=()=>{e.replaceChildren(es(
t.playing?"pause":"play")),e.ariaLabel=t.playing?"Pause":"Play",e.title=`${e.ariaLabel} (Space)`,r.max=String(t.length),r.value=String(t.step),r.ariaValueText=`\
step ${t.step} of ${t.length}`,a.textContent=`${t.step} / ${t.length}`,a.style.minWidth=`${2*String(t.length).length+3}ch`,s.value=String(t.speed)};return t.addEventListener(
"step",u),t.addEventListener("state",u),t.addEventListener("state",c),i.addEventListener("keydown",p=>{!(p.target instanceof HTMLSelectElement||p.key===" "&&p.target!==
r)&&Ue(t,p)&&p.preventDefault()}),u(),i}var ki=40,Ht=class{element;#e;#r=m("div",{class:"episodes",role:"group","aria-label":"Episodes of this cell"});#t=m("p",{class:"check small numbers","aria-live":"\
polite"});constructor(e){this.#e=e,this.element=m("div",{class:"strip-of-episodes"},this.#r,this.#t)}show(e,r){let{pursuer:n,evader:o,episode:s,seed:a}=this.#e.
selected,i=Le(e,n,o);this.#r.replaceChildren(...(i?.rates??[]).slice(0,ki).map((d,h)=>this.#n(d,h)));let l=a===null?i?.rates[s]:void 0,c=r.statistics.capture_rate,
u=l!==void 0&&Math.abs(c-l)<1e-6&&r.length===i?.lengths[s],p=i?"Not an episode of the evaluation":"The evaluation played no episodes of this pair.";this.#t.dataset.
equal=String(u),this.#t.textContent=u?"As in the evaluation":l===void 0?p:`Episode ${s+1} differs from the evaluation.`,this.#t.title=`Played here: capture rate\
 ${L(c,3)} in ${r.length} steps.${i?` The cell says ${L(i.rate,3)}.`:""}`}#n(e,r){let{selected:n}=this.#e,o=m("span",{class:"bar"});return o.style.height=`${Math.
round(100*e)}%`,m("button",{type:"button",class:"episode",title:`Episode ${r+1}: capture rate ${L(e)}`,"aria-label":`Episode ${r+1}, capture rate ${L(e)}`,"aria\
-pressed":String(r===n.episode&&n.seed===null),onclick:()=>this.#e.select({episode:r,seed:null})},o,m("span",{class:"count"},r+1))}};var ts=0,rs=1,Ri=2,Oi=176;function os(t,e,r,n){let o=devicePixelRatio||1,s=zt(t);t.width=t.height=Oi*o;let a=t.getContext("2d");if(!a)return;let{fov:i}=e,l=t.width/
i;a.fillStyle=s.paper,a.fillRect(0,0,t.width,t.height);for(let u=0;r&&u<i*i;u++){let[p,d]=[(u%i+.5)*l,(Math.floor(u/i)+.5)*l],h=f=>!!r[f*i*i+u];h(Ri)&&(a.fillStyle=
s.obstacle,a.fillRect(p-l/2,d-l/2,l,l));let y=h(ts)&&h(rs)?l*.18:0;h(ts)&&ns(a,Ae,p+y,d+y,l*.74,s.evader),h(rs)&&ns(a,Dt,p-y,d-y,l*.86,s.pursuer)}a.strokeStyle=
n<e.n_pursuers?s.pursuer:s.evader,a.lineWidth=2*o;let c=Math.floor(i/2)*l;a.strokeRect(c,c,l,l)}function ns(t,e,r,n,o,s){e(t,r,n,o),t.fillStyle=s,t.fill()}var ss="What it remembers: a number for each unit, from -1 to 1",jt=class{element;#e;#r=m("canvas",{class:"seen",role:"img"});#t=m("h3");#n=m("p",{class:"small \
muted"});#a=m("div",{class:"answers"});#s=m("div",{title:ss});#c=null;#m=null;#p=null;#d=null;#u=null;#i=null;#h=0;constructor(e){this.#e=e,this.element=m("div",
{class:"inspector","data-open":"false"},m("p",{class:"hint small muted"},"Click an agent, or press A: what it sees, and what its network answers."),m("div",{class:"\
inspected"},this.#r,m("div",{class:"answer"},this.#t,this.#n,this.#s),this.#a))}get agent(){return this.#i}show(e,r,n,o){this.#c?.free(),this.#c=e.world(n.config),
this.#p!==r&&(this.#m=null,this.#i!==null&&this.choose(null)),[this.#p,this.#d,this.#u]=[r,n,o]}set solution(e){this.#m=e,this.at(this.#h)}choose(e){this.#i=e,this.
element.dataset.open=String(e!==null),this.#e(e),this.at(this.#h)}next(e){let r=this.#d;if(!r)return;let n=this.#i??(e>0?-1:0);for(let o=0;o<r.n_agents;o++)if(n=
(n+e+r.n_agents)%r.n_agents,r.alive[this.#h*r.n_agents+n])return this.choose(n)}at(e){this.#h=e;let[r,n,o,s,a]=[this.#d,this.#c,this.#p,this.#u,this.#i];if(!r||
!n||!o||!s||a===null)return;let i=a<r.config.n_pursuers?"pursuer":"evader";this.#s.replaceChildren(),this.#t.replaceChildren(m("span",{class:i},G(a,r.config.n_pursuers)));
let l={pursuers:re(o,"pursuer",s.pursuer),evaders:re(o,"evader",s.evader)};r.seek(n,e,l);let c=r.actions.subarray(e*r.n_agents,(e+1)*r.n_agents);for(;c.length&&
!n.over&&(a<n.actors[0]||a>=n.actors[1]);)n.playTurn(c);let u=!!(r.alive[e*r.n_agents+a]&&n.read("alive")[a]);os(this.#r,r.config,u?n.view(a):null,a),this.#r.ariaLabel=
`Field of view of ${G(a,r.config.n_pursuers)}: evaders, pursuers and obstacles around it`;let p=c[a]??null;if(!u)return this.#l([],"It is gone.");let d=l[`${i}s`],
h=typeof d=="string"?null:n.answer(d,a),y=h?.probabilities??null;h?.memory.length&&this.#s.replaceChildren(m("p",{class:"small muted"},"It remembers:"),Pi(h.memory));
let f=this.#m?.game(n)??null,g=typeof d=="string"?`The script "${d}" plays for it${p===null?"":`; it goes ${le[p]}`}.`:d.sampled?"Its action is drawn from these\
 probabilities.":"It takes the most probable action.",v=[["network",y],["perfect",f?.marginal(a)??null]],x=b=>m("p",{class:"small muted"},b);this.#l([...f?[x(`V\
alue ${f.value.toFixed(2)} under perfect play.`)]:[],...$i(v,p)],p===null?"The episode is over.":g)}#l(e,r){this.#a.replaceChildren(...e),this.#n.textContent=r}};
function $i(t,e){let r=t.filter(([,s])=>s);if(!r.length)return[];let n=m("div",{class:"action muted"},m("span"),...r.map(([s])=>m("span",{class:"head"},s))),o=Array.
from(r[0][1],(s,a)=>m("div",{class:a===e?"action taken":"action"},m("span",{},le[a]),...r.flatMap(([,i])=>_i(i[a]))));return r.length>1||r[0][0]!==t[0][0]?[n,...o]:
o}function _i(t){let e=m("span",{class:"filled"});return e.style.width=`${100*t}%`,[m("span",{class:"track"},e),m("span",{class:"numbers"},t.toFixed(2))]}function Pi(t){
let e=Array.from(t,r=>{let n=m("span",{title:r.toFixed(2)});return n.style.transform=`scaleY(${r})`,n});return m("div",{class:"units",role:"img","aria-label":ss},
...e)}function as(t){let e=JSON.stringify(t,(r,n)=>r==="genome"?Array.from(n):n);return m("script",{type:"application/json",id:"champions"},e.replaceAll("<","\\u003c")).
outerHTML}var is="champion",ls=0,Wr=64,zr=100;var Ni=(t,e)=>Object.keys(t).every(r=>t[r]===e[r]);function cs(t,e){return Object.keys(e).find(r=>Ni(e[r],t))??null}var pt="_",Li="n",zu=2n**64n-1n;var Br={fov:11,maxSteps:500,rewards:"paper"},Ii=["rules","others","rewards","size","diagonal","fov","limit","seed","ended","walls","pursuers","evaders","played",
"next"];function ms(t,e){let r=i=>i.map(l=>Fi(l,e)).join(""),n=i=>`${Math.floor(i/t.cols)}.${i%t.cols}`,o=Ui(t.rewards,e),s=[t.seed,t.episode,t.steps].join("."),a={rules:ps(
t.rules,e),others:t.others?ps(t.others,e):"",rewards:o===Br.rewards?"":o,size:`${t.rows}x${t.cols}`,diagonal:t.diagonal?"1":"",fov:t.fov===Br.fov?"":String(t.fov),
limit:t.maxSteps===Br.maxSteps?"":String(t.maxSteps),seed:s==="0.0.0"?"":s,ended:t.ended?"1":"",walls:t.walls.map(n).join(pt),pursuers:t.pursuers.map(us).join(pt),
evaders:t.evaders.map(us).join(pt),played:t.played.map(r).join(pt),next:t.next.every(i=>i===ls)?"":r(t.next)};return Ii.filter(i=>a[i]).map(i=>`${i}=${a[i]}`).join(
"&")}function us({cell:t,gone:e,captured:r,everCaptured:n}){let o=r?"c":n?"e":"";return`${t[0]}.${t[1]}${o}${e?"x":""}`}function ps(t,e){let r=e.fields.map(({name:n})=>String(
t[n]).toLowerCase());return cs(t,e.variants)??r.join(".")}function Ui(t,e){let r=JSON.stringify(t);return Object.keys(e.rewards).find(o=>JSON.stringify(e.rewards[o])===
r)??Object.values(t).map(o=>String(o)).join(pt)}function Fi(t,e){if(typeof t=="number")return String(t);if(t===is)return Li;let r=e.scripts.findIndex(({name:n})=>n===
t);return String.fromCharCode(97+r)}var Di="/* the engine */";function ds(t,e){return m("button",{type:"button",class:"to-playground",title:"Open this step in the playground (G): the same agents a\
nd actions under any rules",onclick:()=>Hr(t(),e)},"What if?")}function Hr(t,e){let r=t!==null&&t.match.n_agents<=zr&&Math.max(t.match.config.rows,t.match.config.
cols)<=Wr,n=r?ms(Wi(t.match,t.step),e):"",o=new TextDecoder().decode(Or("playground")).replace(Di,()=>kt("script-engine")).replace("</noscript>",s=>r?s+as(t.champions):
s);window.open(`${URL.createObjectURL(new Blob([o],{type:"text/html"}))}#${n}`)}function Wi(t,e){let{config:r,n_agents:n}=t,o=Math.max(0,e-1),s=i=>{let l=o*n+i,
c=o*r.n_evaders+i-r.n_pursuers,u=p=>i>=r.n_pursuers&&!!p[c];return{cell:[t.last_positions[2*l],t.last_positions[2*l+1]],gone:!t.alive[l],captured:u(t.captured),
everCaptured:u(t.ever_captured)}},a=Array.from({length:n},(i,l)=>s(l));return{rules:r.rules,others:null,rewards:r.rewards,rows:r.rows,cols:r.cols,diagonal:r.diagonal,
fov:r.fov,maxSteps:r.max_steps,seed:t.seed,episode:BigInt(t.episode),steps:o,ended:o===t.length,walls:Array.from(t.map.keys()).filter(i=>t.map[i]),pursuers:a.slice(
0,r.n_pursuers),evaders:a.slice(r.n_pursuers),played:[],next:Array.from(t.actions.subarray(o*n,(o+1)*n))}}var jr=.005,fs=.05,zi=["pursuer","evader"],Bi=4,He=new Map;function Gt(t,e,r="capture-rate"){let n=JSON.stringify([{...e,rewards:null},r]),o=He.get(n)??(St(e)?Promise.
resolve(null):Hi(t,e,r));return He.delete(n),He.set(n,o),He.size>Bi&&He.delete([...He.keys()][0]),o}var ys=({n_evaders:t})=>t===1?"capture-time":"capture-rate",
hs=()=>new Promise(t=>setTimeout(t));async function Hi(t,e,r){await hs();let n=t.solution(e,r);for(;n.goBack();)await hs();return n}function Vt(t,e,r){let{payoff:n}=t;
return r.flatMap((o,s)=>{let a=[0,0];for(let l=e.n_turns;l>0&&!e.over;l--)t.game(e)?.lost(o).forEach((c,u)=>a[u]+=c),e.playTurn(o);let i=n==="capture-rate"?jr:fs;
return zi.map((l,c)=>({step:s+1,team:l,lost:a[c],payoff:n})).filter(l=>l.lost>=i)})}var Kt=t=>t.map(e=>({step:e.step,kind:e.team,size:e.lost/Math.max(1,...t.map(
({lost:r})=>r)),text:mt(e)})),gs=({lost:t,payoff:e})=>e==="capture-rate"?`${t.toFixed(2)} of the capture rate`:`${t.toFixed(1)} steps`,mt=t=>`The ${t.team}s los\
e ${gs(t)} against a perfect opponent`;function vs(t){let e=t.reduce((r,n)=>n.lost>r.lost?n:r);return`Your team's worst moves, in step ${e.step}, lost ${gs(e)} \
against a perfect opponent.`}function bs({config:t,payoff:e},{value:r},n){if(e==="capture-rate")return`value ${r.toFixed(2)}`;let[o,s]=[1-r,Math.min(t.max_steps-
n,fr)];return o>s-fs?`free for ${s} steps`:`captured after ${o.toFixed(1)} steps`}function ws(t,e){return(t.marginal(e)??[]).map((n,o)=>({share:n,action:o})).filter(
({share:n})=>n>=jr).sort((n,o)=>o.share-n.share).map(({share:n,action:o})=>n>1-jr?le[o]:`${le[o]} ${n.toFixed(2)}`).join(", ")}function Yt(t,e,r){if(r===0)return[{kind:"start",text:ji(t),agents:[]}];let[n,o]=[e.moments[r-1],e.moments[r]],s=u=>G(u,t.config.n_pursuers),a=lt(e,n,o),i=t.conflicts(
r),l=new Set(i.flatMap(u=>u.doomed)),c=a.map(u=>({kind:"capture",text:`${s(u)} is captured`,agents:[u]}));for(let u of Ut(n,o))!a.includes(u)&&!l.has(u)&&c.push(
{kind:"end",text:`${s(u)} disappears`,agents:[u]});return c.push(...i.map(({kind:u,text:p,agents:d})=>({kind:u,text:p,agents:d}))),r===t.length&&c.unshift({kind:"\
end",text:Gi(t),agents:[]}),c}function ji({config:t}){return`${t.n_pursuers} pursuers and ${t.n_evaders} evaders on ${t.rows} x ${t.cols} cells, at most ${t.max_steps}\
 steps`}function Gi(t){let e=Math.round(t.statistics.capture_rate*t.config.n_evaders);return`The episode ends after ${t.length} steps with ${e} of ${t.config.n_evaders}\
 evaders captured`}var Vi=60,qt=class{element;player=new Ie(0,{speed:Rt,still:Be()});inspector;match=null;recording=null;actions;#e;#r;#t;#n;#a=m("h2",{class:"match-title"});#s=m(
"p",{class:"tally numbers"});#c=m("ol",{class:"words",tabindex:0,"aria-live":"off","aria-label":"What happened in this step"});#m=m("p",{class:"problem",role:"a\
lert"});#p=null;#d=null;#u=0;#i=!1;#h=0;#l=[];constructor(e,r,n){[this.#r,this.#t]=[e,r];let o=m("canvas",{"aria-label":"The match",onclick:({clientX:s,clientY:a})=>this.
inspector.choose(this.#e.agentAt(s,a))});this.#e=new ze(o,{numbers:!1}),this.#n=new Ht(r),this.inspector=new jt(s=>this.#x(s)),this.actions=m("div",{class:"besi\
de"},m("button",{type:"button",class:"to-play",title:"Move the chosen agent, or an evader, yourself from this step on (T)",onclick:()=>this.element.dispatchEvent(
new Event("takeover"))},"Take over"),n&&ds(()=>this.shown,n)),this.element=m("section",{class:"card match-card","aria-label":"Match",id:"match"},m("div",{class:"\
match"},m("header",{class:"match-head"},this.#a,this.#s),this.#m,m("div",{class:"stage"},o),m("div",{class:"aside"},this.#c,Qo(),this.actions,this.inspector.element),
Bt(this.player),this.#n.element)),this.player.addEventListener("frame",()=>this.recording&&this.#e.show(this.recording,this.player.time)),this.player.addEventListener(
"step",()=>this.#b()),r.on("match",()=>this.#f()),this.#v(),this.#S(0,0)}get#o(){return this.#r[this.#t.selected.run]}reveal(){this.#e.canvas.scrollIntoView({block:"\
nearest"})}get shown(){return this.match&&this.#d&&{match:this.match,step:this.player.step,champions:this.#d}}start(e){this.#p=e,this.#y()}playSoon(){this.#i=!0,
this.#u||this.#w()}goTo(e){this.#h=e,!this.#u&&this.match&&this.#y()}#w(){!this.#i||!this.match||(this.#i=!1,this.player.jump(0),Be()||this.player.play())}#f(){
this.#v(),clearTimeout(this.#u),this.#u=setTimeout(()=>this.#y(),Vi)}#y(){clearTimeout(this.#u),this.#u=0,this.player.pause(),this.#v();let{selected:e}=this.#t,
r=se.map(s=>Et(this.#o,s,e[s])).find(Boolean)??"";if(this.#m.textContent=r,r||!this.#p)return;this.match=Ct(this.#p,this.#o,e);let[n,o]=this.names(e);this.#d={pursuer:{
name:n,policy:re(this.#o,"pursuer",e.pursuer)},evader:{name:o,policy:re(this.#o,"evader",e.evader)}},this.recording=Xo(this.match),this.#n.show(this.#o,this.match),
this.inspector.show(this.#p,this.#o,this.match,e),this.player.length=this.match.length,this.player.marks=go(this.recording),this.#l=this.player.ticks=[],this.player.
jump(this.#h),this.#h=0,this.#b(),this.#g(this.#p,this.match),this.element.dataset.played=`${e.run} ${e.pursuer} ${e.evader} ${e.episode} ${e.seed??""}`,this.#w()}async#g(e,r){
let n=await Gt(e,r.config);if(this.match!==r||!n)return;let o=e.world(r.config);r.seek(o,0),this.#l=Vt(n,o,Ki(r)),o.free(),this.player.ticks=Kt(this.#l),this.inspector.
solution=n,this.#b()}names({run:e,pursuer:r,evader:n}){let{teams:o}=this.#r[e];return[o.pursuer.script??K("pursuer",r),o.evader.script??K("evader",n)]}#v(){let{
episode:e,seed:r}=this.#t.selected,{payoff:n}=this.#o,[o,s]=this.names(this.#t.selected),a=r===null?e<n.episodes?`episode ${e+1} of ${n.episodes}`:`episode ${e+
1}, not part of the cell`:`seed ${r}`;this.#a.replaceChildren(m("span",{class:"pursuer"},Se(o))," against ",m("span",{class:"evader"},s),m("span",{class:"muted \
small"},a))}#b(){let e=this.match;if(!e||!this.recording)return;let r=this.player.step,n=this.recording.moments[r];this.#S(Array.from(n.everCaptured).filter(Boolean).
length,r),this.#c.replaceChildren(...this.#l.filter(o=>o.step===r).map(o=>m("li",{class:`loss-${o.team}`},mt(o))),...Yt(e,this.recording,r).map(o=>m("li",{class:o.
kind,"data-agents":o.agents.join(" ")},o.text))),this.inspector.at(r),this.#M()}#S(e,r){this.#s.replaceChildren(m("strong",{},e),` of ${this.#o.world.n_evaders}\
 captured`,m("span",{class:"muted"},` · step ${r}`))}#x(e){this.#e.look={selected:e,viewers:e===null?[]:[e]},this.#M()}#M(){let e=this.inspector.agent;for(let r of this.#c.
children){let n=r.dataset.agents?.split(" ")??[];r.classList.toggle("about",e!==null&&n.includes(String(e)))}}},Ki=({actions:t,length:e,n_agents:r})=>Array.from(
{length:e},(n,o)=>t.subarray(o*r,(o+1)*r));var Yi={ArrowUp:[1,0],ArrowDown:[-1,0],ArrowRight:[0,1],ArrowLeft:[0,-1]},qi=5;function Te(t,e,r,n="pursuer"){t.tabIndex=0,t.setAttribute("role","application"),
t.addEventListener("keydown",o=>{let s=Yi[o.key];if(!s)return;let[a,i]=n==="pursuer"?s:[s[1],s[0]],[l,c]=r(),u=o.shiftKey?qi:1,{pursuer:p,evader:d}=e.selected;e.
select({pursuer:xs(p+u*a,l),evader:xs(d+u*i,c)}),o.preventDefault(),o.stopPropagation()})}var xs=(t,e)=>Math.min(e-1,Math.max(0,t));var Zi=24,Zt=7,Ms=t=>t<Zi&&matchMedia("(pointer: coarse)").matches;function As(t,e,r,n){let[o,s]=t.payoff.shape,[a,i]=[Ss(e,o),Ss(r,s)],[l,c]=[Math.min(Zt,o),Math.
min(Zt,s)],u=[];for(let f=a+l-1;f>=a;f--){u.push(m("span",{class:"pursuer"},f));for(let g=i;g<i+c;g++)u.push(Ji(t,f,g,n))}let p=Array.from({length:c},(f,g)=>m("\
span",{class:"evader"},i+g)),d=m("button",{type:"button","aria-label":"Close: all cells",onclick:()=>n(null)},"✕"),y=m("div",{class:"loupe numbers",role:"grou\
p","aria-label":"Cells around the tap",onclick:f=>f.stopPropagation()},...u,d,...p);return y.style.gridTemplateColumns=`2.4rem repeat(${c}, minmax(0, 1fr))`,y}function Ji(t,e,r,n){
let o=m("button",{type:"button",onclick:()=>n({pursuer:e,evader:r})});return Pt(o,Le(t,e,r)?.rate,`${K("pursuer",e)} against ${K("evader",r)}`),o}var Ss=(t,e)=>Math.
max(0,Math.min(e-Zt,t-Math.floor(Zt/2)));var ne={left:52,bottom:46,top:76,right:84},ce=10,Xi=160,dt=ne.right-ce-14,Ee=ne.top-ce-14,Jt=class{element;#e;#r;#t=m("canvas",{"aria-hidden":"true"});#n=w("svg",
{"aria-hidden":"true"});#a=w("g");#s;#c=m("h2");#m=m("strong",{class:"rate numbers"});#p=m("span",{class:"small muted"});#d=m("p",{class:"of-both-teams small mu\
ted numbers"});#u=null;constructor(e,r){[this.#r,this.#e]=[e,r],this.#s=m("div",{class:"matrix",id:"matrix","aria-label":"Payoff matrix. Arrow keys choose a mat\
ch, Enter plays it.",onpointermove:o=>this.#v(o),onpointerleave:()=>r.point({}),onclick:o=>this.#b(o),onkeydown:({key:o})=>o==="Enter"&&this.#x()},this.#t,this.#n);
let n=m("header",{class:"readout","aria-live":"polite"},m("div",{},this.#c,this.#d),m("div",{class:"of-cell"},this.#m,this.#p));this.element=m("section",{class:"\
card matrix-card","aria-label":"Payoff matrix"},n,this.#s,Nt("0 all escape","1 all caught")),this.#f(),new ResizeObserver(()=>this.#h()).observe(this.#s),this.#s.
addEventListener("mousedown",o=>{o.preventDefault(),document.activeElement instanceof HTMLElement&&document.activeElement.blur()}),Te(this.#s,r,()=>this.#i.payoff.
shape),r.on("run",()=>this.#h()),r.on("match hover",()=>this.#w())}get#i(){return this.#r[this.#e.selected.run]}#h(){let[e,r]=this.#i.payoff.shape,{clientWidth:n,
clientHeight:o}=this.#s;if(n<50)return;let a=Math.max(Xi,Math.min(n-ne.left-ne.right,o-ne.top-ne.bottom))/Math.max(e,r),i=Math.max(ne.left,(n-r*a-ne.right+ne.left)/
2),l=ne.top+Math.max(0,(o-ne.top-ne.bottom-e*a)/2),c={width:n,height:o,left:i,top:l,cell:a,rows:e,columns:r};this.#u=c,_t(this.#t,this.#i.payoff,{left:i,top:l,width:r*
a,height:e*a});for(let[u,p,d]of[["left",i,n],["top",l,o],["width",r*a,n],["height",e*a,o]])this.#t.style.setProperty(u,`${100*p/d}%`);this.#s.style.setProperty(
"--shape",`${n} / ${o}`),this.#n.setAttribute("viewBox",`0 0 ${n} ${o}`),this.#n.replaceChildren(Qi(c),...el(c),...this.#o(c),this.#a),this.#w()}#l(e){let r=this.#i.
findings?.generalization;if(!r)return[];let{selected:n,hover:o}=this.#e,[s,a]=[o.pursuer??n.pursuer,o.evader??n.evader],[i,l]=Ts(e,r.pursuers.mean[s]??0,s),[c,u]=Es(
e,r.evaders.mean[a]??0,a);return[w("circle",{class:"dot of-pursuers",cx:i,cy:l,r:5}),w("circle",{class:"dot of-evaders",cx:c,cy:u,r:5})]}#o(e){let r=this.#i.findings?.
generalization;if(!r)return[];let{left:n,top:o,cell:s,rows:a,columns:i}=e,[l,c]=[n+i*s+ce,o-ce],u={class:"side"};return[w("rect",{...u,x:l,y:o,width:dt,height:a*
s}),w("rect",{...u,x:n,y:c-Ee,width:i*s,height:Ee}),...Cs(r.pursuers,(p,d)=>Ts(e,p,d),"of-pursuers"),...Cs(r.evaders,(p,d)=>Es(e,p,d),"of-evaders"),w("text",{class:"\
tick",x:l,y:o+a*s+16,"text-anchor":"start"},"0"),w("text",{class:"tick",x:l+dt,y:o+a*s+16,"text-anchor":"end"},"1"),w("text",{class:"tick",x:n-6,y:c-4,"text-anc\
hor":"end"},"0"),w("text",{class:"tick",x:n-6,y:c-Ee+8,"text-anchor":"end"},"1"),w("text",{class:"label of-pursuers",x:l+dt,y:o+a*s+34,"text-anchor":"end"},"cap\
tures"),w("text",{class:"label of-evaders",x:n+i*s+ce,y:c-Ee+10,"text-anchor":"start"},"escapes")]}#w(){let e=this.#u;if(!e)return;let{selected:r,hover:n}=this.#e,
{left:o,top:s,cell:a,rows:i,columns:l}=e,c=y=>s+(i-1-y)*a,u=[],p=(y,f)=>w("rect",{class:f,x:o,y:c(y),width:l*a+ce+dt,height:a}),d=(y,f)=>w("rect",{class:f,x:o+y*
a,y:s-ce-Ee,width:a,height:ce+Ee+i*a});u.push(p(r.pursuer,"strip pursuer"),d(r.evader,"strip evader")),n.pursuer!==null&&n.pursuer<i&&u.push(p(n.pursuer,"strip \
hover")),n.evader!==null&&n.evader<l&&u.push(d(n.evader,"strip hover")),u.push(...this.#l(e));let h={x:o+r.evader*a,y:c(r.pursuer),width:a,height:a};u.push(w("r\
ect",{class:"chosen under",...h}),w("rect",{class:"chosen",...h})),this.#a.replaceChildren(...u),this.#f()}#f(){let{selected:e,hover:r}=this.#e,n=r.pursuer??e.pursuer,
o=r.evader??e.evader,s=Le(this.#i,n,o);this.#c.replaceChildren(m("span",{class:"pursuer"},Se(K("pursuer",n)))," against ",m("span",{class:"evader"},K("evader",o))),
this.#m.textContent=s?L(s.rate,3):"-",this.#p.textContent=s?`capture rate, mean of ${s.rates.length} episodes`:"no episodes were played",this.#d.textContent=this.#y(
n,o)}#y(e,r){let n=this.#i.findings?.generalization;if(!n)return"";let o=(s,a)=>ao(s.mean[a]??null,s.low?.[a]??null,s.high?.[a]??null);return`Against all: captu\
res ${o(n.pursuers,e)}, escapes ${o(n.evaders,r)}`}#g(e){let r=this.#u;if(!r)return null;let n=this.#s.getBoundingClientRect(),o=Math.floor((e.clientX-n.left-r.
left)/r.cell),s=r.rows-1-Math.floor((e.clientY-n.top-r.top)/r.cell),[a,i]=[s>=0&&s<r.rows,o>=0&&o<r.columns];return a||i?{g:a?s:-1,h:i?o:-1,inside:a&&i}:null}#v(e){
let r=this.#g(e);this.#e.point(r?{pursuer:r.g<0?null:r.g,evader:r.h<0?null:r.h}:{})}#b(e){let r=this.#g(e);if(r){if(r.inside&&Ms(this.#u.cell))return this.#S(r.
g,r.h);this.#e.select({...r.g<0?{}:{pursuer:r.g},...r.h<0?{}:{evader:r.h}}),r.inside&&this.#x()}}#S(e,r){let n=As(this.#i,e,r,o=>{n.remove(),o&&(this.#e.select(
o),this.#x())});this.#s.append(n)}#x(){this.#s.dispatchEvent(new CustomEvent("play",{bubbles:!0}))}};function Qi({left:t,top:e,cell:r,rows:n,columns:o}){let s=w(
"g",{class:"axes"}),a=e+n*r,i=l=>at(0,l-1,Math.min(l,l*r/44),!0);for(let l of i(o))s.append(w("text",{class:"tick",x:t+(l+.5)*r,y:a+16,"text-anchor":"middle"},l));
for(let l of i(n))s.append(w("text",{class:"tick",x:t-7,y:a-(l+.5)*r,"text-anchor":"end","dominant-baseline":"middle"},l));return s.append(w("text",{class:"labe\
l of-evaders",x:t+o*r/2,y:a+36,"text-anchor":"middle"},"evader generation"),w("text",{class:"label of-pursuers",transform:`translate(${t-36} ${e+n*r/2}) rotate(\
-90)`,"text-anchor":"middle"},"pursuer generation")),s}function el({left:t,top:e,cell:r,rows:n,columns:o}){let s=w("g",{class:"diagonal"}),a=Math.min(n,o);if(a<
3)return[];let i=e+n*r;for(let u of["H","V"]){let p=`M${t} ${i}`;for(let d=1;d<=a;d++){let[h,y]=[`H${t+d*r}`,`V${i-d*r}`];p+=u==="H"?h+y:y+h}s.append(w("path",{
d:p,class:"under"}),w("path",{d:p}))}let[l,c]=[t+a/2*r-.7*r-4,i-a/2*r-.7*r-4];return[s,w("text",{class:"on-cells",transform:`translate(${l} ${c}) rotate(-45)`,"\
text-anchor":"middle"},"same generation")]}var Ts=({left:t,top:e,cell:r,rows:n,columns:o},s,a)=>[t+o*r+ce+s*dt,e+(n-a-.5)*r],Es=({left:t,top:e,cell:r},n,o)=>[t+
(o+.5)*r,e-ce-n*Ee];function Cs(t,e,r){let n=s=>s.map((a,i)=>e(a??0,i).map(l=>l.toFixed(1)).join(" ")),o=[];return t.low&&t.high&&o.push(w("path",{class:`band ${r}`,
d:`M${[...n(t.high),...n(t.low).reverse()].join("L")}Z`})),o.push(w("path",{class:`line ${r}`,d:`M${n(t.mean).join("L")}`})),o}function fe(t,e,...r){return m("section",{class:"card panel","aria-label":t},m("header",{},m("h2",{},t),m("p",{class:"small muted"},e)),...r)}var tl={present:"●",
absent:"○","cannot tell":"?"};function ks(t){let{findings:e}=t;if(!e?.table.length)return null;let[,...r]=e.table,n=r.map(([s,a,i,l],c)=>{let u=rl(e.reasons[c]??
"");return m("li",{class:`finding ${a.replace(" ","-")}`},m("span",{class:"sign","aria-hidden":"true"},tl[a]??""),m("div",{},m("p",{},m("strong",{},s),` ${a}`,m(
"span",{class:"muted"},` · ${l}`)),u?m("p",{class:"small"},`${u}.`):null,m("p",{class:"small muted numbers"},i)))}),o=fe("What happened","Each condition is pre\
sent, absent, or its 95 % interval cannot tell. The intervals are about this run.",m("p",{class:"headline"},e.sentence),m("p",{},e.headline),...e.numbers.map(s=>m(
"p",{class:"numbers"},`${Se(s)}.`)),m("ul",{class:"findings"},...n),t.limits?m("p",{class:"small"},t.limits):null);return o.classList.add("diagnosis"),{element:o}}
function rl(t){let[,e=""]=t.split(/, because (.*)/s);return Se(e.replace(/\.$/,""))}function Rs({settings:t,schedule:e,seed:r}){let n=t.map(({name:a,value:i,help:l})=>m(
"tr",{},m("th",{scope:"row"},`--${a.replaceAll("_","-")}`),m("td",{class:"numbers"},i),m("td",{class:"muted"},l))),o=m("table",{class:"small"},m("caption",{class:"\
heard"},"Settings other than the default"),...n),s=fe("Settings",`${e}, seed ${r}; all others are the defaults of matrixworld evolve.`,n.length?m("div",{class:"\
wide-table"},o):null);return s.classList.add("settings"),{element:s}}function Os(t,e,r){let{findings:n}=t;if(!n?.table.length)return null;let o=n.checkerboards.map(s=>nl(t,s,(a,i)=>{e.select({pursuer:a,evader:i}),r()}));return{element:fe(
"Checkerboards","Two generations of each team: each generation of the pursuers is better against another one of the evaders. Click a cell to watch its match.",o.
length?m("div",{class:"boards"},...o):m("p",{},`No four cells differ by more than ${n.margin} in this way.`),o.length?m("p",{class:"small muted"},"The strongest\
 of all pairs, so noise makes them look stronger than they are. The diagnosis says whether there are more than noise makes."):null)}}function nl(t,{pursuers:e,evaders:r},n){
let o=(s,a)=>{let i=m("button",{type:"button",class:"cell",onclick:()=>n(s,a)});return Pt(i,t.payoff.capture_rate[s][a],`${K("pursuer",s)} against ${K("evader",
a)}`),i};return m("div",{class:"miniature numbers"},m("span"),...r.map(s=>m("span",{class:"evader"},s)),...e.flatMap(s=>[m("span",{class:"pursuer"},s),...r.map(
a=>o(s,a))]))}var Xt={pursuer:"evader",evader:"pursuer"};function $s(t,e){let r=t.findings?.ciao;if(!r)return null;let n=["pursuer","evader"].map(o=>{let{fading:s,stripes:a,period:i}=r[`${o}\
s`],l=`fading ${L(s)}, stripes ${L(a)}${i===null?"":` every ${i} generations`}`;return ol(t,o,l,e)});return{element:fe("CIAO: current individuals against ancest\
ral opponents","The team's own score. Stripes: intransitive, since wins and losses alternate with the age of the opponent; whether a team returns to earlier str\
ategies is recurrence, under What happened. Darker away from the diagonal: forgetting.",m("div",{class:"triangles"},...n.map(o=>o.element)),Nt("0 loses","1 wins")),
update:()=>n.forEach(o=>o.update())}}function ol(t,e,r,n){let o=e==="pursuer"?0:1,[s,a]=[t.payoff.shape[o],t.payoff.shape[1-o]],i=t.payoff.capture_rate,l=Array.
from({length:s},(v,x)=>Array.from({length:Math.min(x+1,a)},(b,S)=>e==="pursuer"?i[x][S]:1-i[S][x])),c=$r({shape:[s,a],first:[0,0],capture_rate:l}),u=w("rect",{class:"\
chosen",width:1,height:1}),p=w("rect",{class:"chosen under",width:1,height:1}),d=w("svg",{viewBox:`0 0 ${a} ${s}`,preserveAspectRatio:"none","aria-hidden":"true"},
p,u),h=m("div",{class:"triangle","aria-label":`CIAO of the ${e}s: ${r}. Arrow keys choose a match.`,onpointermove:v=>n.point(y(v)??{}),onpointerleave:()=>n.point(
{}),onclick:v=>y(v)&&n.select(y(v))},c,d);Te(h,n,()=>t.payoff.shape,e),h.style.aspectRatio=`${a} / ${s}`;let y=v=>{let x=h.getBoundingClientRect(),b=Math.floor(
(v.clientX-x.left)/x.width*a),S=s-1-Math.floor((v.clientY-x.top)/x.height*s);return b>=0&&S<s&&b<=S?{[e]:S,[Xt[e]]:b}:null},f=()=>{let v=n.hover[e]??n.selected[e],
x=n.hover[Xt[e]]??n.selected[Xt[e]];for(let b of[u,p])b.setAttribute("x",String(x)),b.setAttribute("y",String(s-1-v)),b.style.display=x<=v?"":"none"};return{element:m(
"figure",{},m("figcaption",{class:"small"},m("span",{class:e},`${e}s`)),h,m("p",{class:"small muted"},`horizontal: ${Xt[e]} generation; vertical: ${e} generatio\
n`),m("p",{class:"small numbers"},r)),update:f}}var Qt={left:46,right:12,top:10,bottom:42},_s={x:56,y:34};function Gr(t,e,r,n){let[o,s]=[Qt.left,Qt.top],a=Math.max(o+40,t-Qt.right),i=Math.max(s+40,e-Qt.bottom),
l=(f,g,v)=>x=>g+(x-f.low)/(f.high-f.low||1)*(v-g),[c,u]=[l(r,o,a),l(n,i,s)],p=w("g"),d=w("svg",{width:t,height:e,viewBox:`0 0 ${t} ${e}`,class:"plot"}),h=w("g",
{class:"axes"});for(let f of at(n.low,n.high,(i-s)/_s.y,n.whole))h.append(w("line",{x1:o,x2:a,y1:u(f),y2:u(f),class:"grid"}),w("text",{x:o-8,y:u(f),"text-anchor":"\
end","dominant-baseline":"middle"},Ps(f)));for(let f of at(r.low,r.high,(a-o)/_s.x,r.whole))h.append(w("text",{x:c(f),y:i+16,"text-anchor":"middle"},Ps(f)));return h.
append(w("line",{x1:o,x2:a,y1:i,y2:i,class:"axis"}),w("text",{x:(o+a)/2,y:e-6,"text-anchor":"middle",class:"label"},r.label),w("text",{transform:`translate(12 ${(s+
i)/2}) rotate(-90)`,"text-anchor":"middle",class:"label"},n.label)),d.append(h,p),{root:d,marks:p,left:o,right:a,top:s,bottom:i,x:c,y:u,at:f=>{let g=f-d.getBoundingClientRect().
left;return r.low+(g-o)/(a-o)*(r.high-r.low)}}}var Ps=t=>String(Number(t.toPrecision(6))).replace("-","−");function Vr(t,e,r,n){let o="",s="M";r.forEach((a,i)=>{
a===null?s="M":(o+=`${s}${t.x(e[i]).toFixed(1)} ${t.y(a).toFixed(1)}`,s="L")}),t.root.insertBefore(w("path",{d:o,class:`line ${n}`}),t.marks)}function Ns(t,{low:e,
high:r},n){if(!e||!r)return;let o=s=>s.map((a,i)=>`${t.x(i).toFixed(1)} ${t.y(a??0).toFixed(1)}`);t.root.insertBefore(w("path",{d:`M${[...o(r),...o(e).reverse()].
join("L")}Z`,class:`band ${n}`}),t.marks)}function Kr(t,e,r,n=null){let o=t.x(e);t.marks.append(w("line",{x1:o,x2:o,y1:t.top,y2:t.bottom,class:`mark ${r}`})),n!==
null&&t.marks.append(w("circle",{cx:o,cy:t.y(n),r:5,class:`dot ${r}`}))}function Yr(...t){return m("p",{class:"legend small"},...t.map(([e,r])=>m("span",{class:`\
key ${r}`},e)))}function qr(t,e,r,n){let o=m("div",{class:"chart chooses",role:"img","aria-label":t}),s=null,a=()=>{s?.marks.replaceChildren(),s&&r(s)};o.addEventListener(
"click",l=>s&&n(s.at(l.clientX),s,l));let i=()=>{let{clientWidth:l,clientHeight:c}=o;l<50||c<50||(s=e(l,c),o.replaceChildren(s.root),a())};return new ResizeObserver(
i).observe(o),{element:o,update:a,redraw:i}}var Zr=["of-pursuers","of-evaders","of-both"],sl=2500,Ls="Arrow keys choose generations.",al={low:0,high:1,label:"capture rate"};function Is(t,e){let{training:r}=t,
{capture_rate:n,generation:o,learner:s,epochs:a}=r,i=n.map((y,f)=>(f+1)*a),l=il(n,r.window),c=i.at(-1)??1,u=i.length>sl?"dense":"",p=(y,f)=>{let g=o.flatMap((v,x)=>v===
y&&(s[x]===f||s[x]===2)?[x]:[]);return g.length?[i[g[0]],i[g.at(-1)]]:null},d=qr(`Capture rate in ${c} epochs of training. ${Ls}`,(y,f)=>{let g=Gr(y,f,{low:0,high:c,
label:"epoch",whole:!0},al);for(let[v,x]of[["raw",n],[u,l]])for(let[b,S]of Zr.entries()){let E=x.map((k,C)=>s[C]===b||s[C+1]===b?k:null);E.some(k=>k!==null)&&Vr(
g,i,E,`${S} ${v}`)}return g},y=>se.forEach((f,g)=>{let v=p(e.hover[f]??e.selected[f],g);v&&Kr(y,(v[0]+v[1])/2,Zr[g])}),y=>{let f=Math.min(i.length-1,Math.max(0,
Math.round(y/a)-1)),g=o[f];s[f]!==1&&e.select({pursuer:Math.min(g,t.payoff.shape[0]-1)}),s[f]!==0&&e.select({evader:Math.min(g,t.payoff.shape[1]-1)})});Te(d.element,
e,()=>t.payoff.shape);let h=[...new Set(s)].sort().map(y=>[["pursuers learn","evaders learn","both teams learn"][y],Zr[y]]);return{element:fe("Training",`${io(r.
matches)} training matches. Lines: the generations that are selected.`,Yr(...h),d.element),update:d.update}}function Us(t,e){let r=t.findings?.ratings;if(!r)return null;
let n={pursuer:r.pursuers,evader:r.evaders},o={pursuer:n.pursuer.mean,evader:n.evader.mean},s=se.flatMap(p=>[n[p].mean,n[p].low??[],n[p].high??[]]).flat().map(p=>p??
0),[a,i]=[Math.min(...s),Math.max(...s)],l=.06*(i-a||1),c=Math.max(...t.payoff.shape)-1,u=qr(`Elo ratings by generation. ${Ls}`,(p,d)=>{let h=Gr(p,d,{low:0,high:c,
label:"generation",whole:!0},{low:a-l,high:i+l,label:"Elo points"});for(let y of se)Ns(h,n[y],`of-${y}s`),Vr(h,o[y].map((f,g)=>g),o[y],`of-${y}s`);return h},p=>{
for(let d of se){let h=e.hover[d]??e.selected[d];Kr(p,h,`of-${d}s`,o[d][h]??null)}},(p,d,h)=>{let y=Math.round(p),f=h.clientY-d.root.getBoundingClientRect().top,
g=x=>Math.abs(d.y(o[x][y]??1/0)-f),v=g("pursuer")<=g("evader")?"pursuer":"evader";y>=0&&y<o[v].length&&e.select({[v]:y})});return Te(u.element,e,()=>t.payoff.shape),
{element:fe("Ratings",`One number for each generation, which cycles do not fit, with 95 % intervals over episodes. The game itself: ${L(r.offset,0)} points for \
the pursuers.`,Yr(["pursuers","of-pursuers"],["evaders","of-evaders"]),u.element),update:u.update}}function il(t,e){let r=[0];for(let n of t)r.push(r.at(-1)+n);
return t.map((n,o)=>{let[s,a]=[Math.max(0,o-Math.floor((e-1)/2)),Math.min(t.length,o+Math.floor(e/2)+1)];return(r[a]-r[s])/(a-s)})}function Fs(t,e,r){let n=new Map,o=m("div",{class:"panels"}),s=[],a=()=>s.forEach(l=>l.update?.()),i=()=>{let l=t[e.selected.run];s=n.get(l)??ll(l,e,r),n.set(l,
s),o.replaceChildren(...s.map(c=>c.element)),a()};return e.on("run",i),e.on("match hover",a),i(),o}function ll(t,e,r){return[ks(t),Is(t,e),Os(t,e,r),Us(t,e),$s(
t,e),Rs(t)].filter(o=>o!==null)}var Ds={pursuer:null,evader:null},er=class extends EventTarget{#e;#r=Ds;constructor(e){super(),this.#e=e}get selected(){return this.#e}get hover(){return this.#r}select(e){
let r=this.#e,n=["run","pursuer","evader"].some(o=>o in e&&e[o]!==r[o]);this.#e={...r,...n?{episode:0,seed:null}:{},...e},this.#e.run!==r.run&&this.dispatchEvent(
new Event("run")),this.dispatchEvent(new Event("match"))}point(e){let r={...Ds,...e};r.pursuer===this.#r.pursuer&&r.evader===this.#r.evader||(this.#r=r,this.dispatchEvent(
new Event("hover")))}on(e,r){for(let n of e.split(" "))this.addEventListener(n,r)}};var tr=class{config;start;recording;actions=[];#e;#r;#t=[[]];constructor(e,r,n){[this.config,this.start]=[r,n],this.#e=e.world(r),this.#e.reset(n),this.#r=[Dr(this.#e)],
this.recording=Fr(r,this.#e.map(),this.#r)}get length(){return this.actions.length}get over(){return this.#e.over}get statistics(){return{capture_rate:this.#e.read(
"capture_rate")[0]}}conflicts(e){return this.#t[e]}game(e){return e.game(this.#e)}play(e){this.#e.step(e),this.#n(e)}step(e,r,n){let[o,s]=[this.#e,this.config.n_pursuers],
a=new Uint8Array(o.n_agents);for(let i=o.n_turns;i>0&&!o.over;--i){let[l,c]=o.actors;l<s&&(a=o.decide(e.pursuer,[l,Math.min(c,s)],a)),c>s&&(a=o.decide(e.evader,
[Math.max(l,s),c],a)),typeof n=="number"?a[r]=n:l<=r&&r<c&&(a=o.decide(n,[r,r+1],a)),o.playTurn(a)}this.#n(a)}#n(e){this.actions.push(e),this.#r.push(Dr(this.#e,
e)),this.#t.push(this.#e.conflicts())}};var ue=(t,e)=>se[+(e>=t.n_pursuers)];function Jr(t,e){let r=new tr(t,e.config,{seed:e.seed,episode:e.episode});for(let n of e.moves)r.over||r.step(e.policies,e.
seat,n);return r}function je(t,e){let{moments:r,nPursuers:n}=t.recording,o=r.findIndex(({alive:a,captured:i})=>!a[e]||!!i[e-n]),s=o<0?t.length:o;return{lasted:s,
out:o>=0,captured:Array.from(r[s].everCaptured).filter(Boolean).length}}var rr=(t,e)=>t.over||je(t,e).out;function Ws(t,e,r){let n=Jr(t,{...e,moves:e.moves.slice(
0,e.from)});for(;!rr(n,e.seat);)n.step(e.policies,e.seat,r);return je(n,e.seat)}function zs(t){let e=t.length-1;return[...new Set([0,Math.round(e/3),e])].map(r=>t[r])}
function Bs(t,{seat:e,from:r,moves:n}){let o={...t,seat:e,...r?{from:r}:{},moves:n.join("")};return`${location.href.split("#")[0]}#${Object.entries(o).map(([s,a])=>`${s}\
=${a}`).join("&")}`}function Hs(t,e){let[r,n,o]=[t.get("seat")??"",t.get("from")??"0",t.get("moves")??""];return/^\d{1,6}$/.test(r)&&Number(r)<e.n_pursuers+e.n_evaders&&
(e.diagonal?/^[0-8]+$/:/^[0-4]+$/).test(o)&&o.length<=e.max_steps&&/^\d{1,6}$/.test(n)&&Number(n)<=o.length?{seat:Number(r),from:Number(n),moves:[...o].map(Number)}:
null}function Xr(t,e,r,n,o,s){e.play({title:r,played:n,ending:(a,i)=>[cl(t,a,i,zs(o))],again:()=>Xr(t,e,r,{...n,moves:n.moves.slice(0,n.from)},o,s),link:a=>s&&Bs(s,a)})}
function cl(t,e,r,n){let o=ue(r.config,r.seat)==="evader",s=o?r.config.max_steps:r.config.n_evaders,a=m("table",{class:"numbers"},m("caption",{},o?"Steps in you\
r seat: same start, same others":"Captures of your team: same start, same others")),i=c=>{let[u,p]=[m("span",{class:o?"bar evader":"bar pursuer"}),m("td",{},"…")];
return a.append(m("tr",{},m("th",{scope:"row"},c),m("td",{class:"track","aria-hidden":"true"},u),p)),({lasted:d,captured:h})=>{u.style.width=`${100*(o?d:h)/s}%`,
p.textContent=String(o?d:h)}};i("You")(je(e,r.seat));for(let{name:c,policy:u}of n){let p=i(c);setTimeout(()=>p(Ws(t,r,u())))}let l=r.from?`You took over at step\
 ${r.from}. `:"";return m("div",{},a,m("p",{class:"small muted"},`${l}One match: luck has its part in it.`))}var js=["·","↑","→","↓","←","↗","↘","↙","↖"];var ul={" ":0,ArrowUp:1,w:1,ArrowRight:2,d:2,ArrowDown:3,s:3,ArrowLeft:4,a:4,e:5,c:6,y:7,z:7,q:8},Qr=[8,1,5,4,0,2,7,3,6],pl=[7,8,9,4,5,6,1,2,3],ml=24,dl=Math.tan(
Math.PI/8);function Vs(t,e){if(t.ctrlKey||t.metaKey||t.altKey)return;let r=pl.findIndex(o=>t.code===`Numpad${o}`),n=Qr[r]??ul[t.key.length===1?t.key.toLowerCase():
t.key];return n!==void 0&&n>4&&!e?void 0:n}function Ks(t){let e=Qr.map(r=>m("button",{type:"button","aria-label":le[r],onclick:()=>t(r)},js[r]));return{element:m(
"div",{class:"play-pad",role:"group","aria-label":"Your move"},...e),show:r=>e.forEach((n,o)=>n.classList.toggle("absent",Qr[o]>4&&!r))}}function Gs(t,e,r){let n=dl*
Math.max(Math.abs(t),Math.abs(e)),o=s=>Math.abs(s)<n?0:s;return fo([0,0],r?[o(t),o(e)]:[t,e],r)}function Ys(t,e,r){let n=null,{canvas:o}=t;o.addEventListener("p\
ointerdown",({button:s,clientX:a,clientY:i})=>n=s===0?[a,i]:null),o.addEventListener("pointercancel",()=>n=null),o.addEventListener("pointerup",({clientX:s,clientY:a})=>{
let[i,l]=[n,e()];if(n=null,!i||!l)return;let[c,u]=[s-i[0],a-i[1]],p=t.cellAt(s,a);Math.hypot(c,u)>=ml?r(Gs(u,c,l.diagonal)):p&&r(Gs(p[0]-l.cell[0],p[1]-l.cell[1],
l.diagonal))})}function qs(t,e){let r=n=>{let o=e[n]-t[n],s=Fe.findIndex(a=>a[n]===Math.sign(o)&&a[1-n]===0);return o?`${Math.abs(o)} ${le[s]}`:""};return[r(0),
r(1)].filter(Boolean).join(", ")||"on your cell"}var Xs="NUMPY\0",Zs=Xs.length+2,Js=64;function Qs(t){return Xn(Object.fromEntries(Object.entries(t).map(([e,r])=>[`${e}.npy`,hl(r)])))}function hl({dtype:t,shape:e,
data:r}){let n=typeof r=="string"?Array.from(r,u=>u.codePointAt(0)):null,o=e.map(u=>`${u}, `).join(""),s=`{'descr': '${n?`<U${n.length}`:t}', 'fortran_order': F\
alse, 'shape': (${o}), }`,a=Math.ceil((Zs+s.length+1)/Js)*Js-Zs,i=Xs+String.fromCharCode(a&255,a>>8)+s.padEnd(a-1)+`
`,l=n?Int32Array.from(n):r,c=new Uint8Array(i.length+l.byteLength);return c.set(Mt(i,!0)),c.set(new Uint8Array(l.buffer,l.byteOffset,l.byteLength),i.length),c}var fl="matrixworld episode 3";function ea(t,e,r){let{config:n,actions:o,length:s,recording:a}=e,[i,l]=[n.n_pursuers+n.n_evaders,n.n_evaders],c={positions:["<i4",
i,2],last_positions:["<i4",i,2],alive:["|b1",i],captured:["|b1",l],ever_captured:["|b1",l]},u={rewards:["<f4",i],involved:["|b1",i,3],fault:["|b1",i,3]},p={},d=b=>{
for(let S of Object.keys(b))(p[S]??=[]).push(Array.from(h.read(S),Number))},h=t.world(n);h.reset(e.start);let y=[];d(c);for(let b of o)h.step(b),d({...c,...u}),
y.push(...h.conflictTable());h.free();let f={"<i4":Int32Array,"<f4":Float32Array,"|b1":Uint8Array},g={};for(let[b,[S,...E]]of Object.entries({...c,...u})){let k=s+
+(b in c);g[b]={dtype:S,shape:[k,...E],data:f[S].from((p[b]??[]).flat())}}let v=b=>({dtype:"<i8",shape:[],data:Int32Array.of(b,0)}),x=b=>({dtype:"<U",shape:[],data:b});
return Qs({format:x(fl),n_pursuers:v(n.n_pursuers),config:x(JSON.stringify(n)),seat:v(r),...g,actions:{dtype:"|i1",shape:[s,i],data:Int8Array.from(o.flatMap(b=>[
...b]))},map:{dtype:"|b1",shape:[n.rows,n.cols],data:Uint8Array.from(a.obstacles,Number)},conflict_table:{dtype:"<i4",shape:[y.length/11,11],data:Int32Array.from(
y)}})}var yl=[0,1,2,4,8],nr=class{element;player=new Ie(0,{speed:4,still:Be()});#e;#r;#t=m("canvas",{tabindex:0,"aria-describedby":"play-keys"});#n=m("h2");#a=m("p",{
class:"play-told",role:"status"});#s=Ks(e=>this.act(e));#c=Rn(yl.map(e=>[e,e?`${e} / s`:"step by step"]),()=>this.#A());#m=m("input",{type:"checkbox",onchange:()=>this.#x()});#p=m(
"input",{type:"checkbox",onchange:()=>this.#T()});#d=m("label",{class:"play-choice"},this.#p,"Best move");#u=m("p",{class:"small muted play-keys",id:"play-keys"});#i=m(
"section",{class:"play-ending",tabindex:-1,"aria-labelledby":"play-headline"});#h=Bt(this.player);#l=null;#o=null;#w=[];#f=null;#y=null;#g=[];#v=0;#b=0;constructor(e){
this.#e=e,this.#r=new ze(this.#t,{numbers:!1}),this.#t.setAttribute("role","application"),Ys(this.#r,()=>{let r=this.#f!==null&&this.#o&&R(this.#o.recording.moments.
at(-1),this.#f);return r?{cell:r,diagonal:this.#o.config.diagonal}:null},r=>this.act(r)),this.player.addEventListener("frame",()=>this.#o&&this.#r.show(this.#o.
recording,this.player.time)),this.player.addEventListener("step",()=>this.#T()),this.element=m("div",{class:"play"},m("header",{class:"play-head"},this.#n,this.#a),
m("div",{class:"play-stage"},this.#t),m("div",{class:"play-side"},this.#i,this.#s.element,m("label",{class:"play-choice",title:"Steps a second"},"Pace ",this.#c),
m("label",{class:"play-choice"},this.#m,m("span",{},"Fog",m("span",{class:"at-length"},": see only what it sees"))),this.#d,this.#u),this.#h)}get played(){return this.#l&&
{...this.#l.played,moves:this.#w}}get live(){return this.#o}play(e){this.#S(Jr(this.#e,e.played),e.played.seat,e.title),[this.#l,this.#w,this.#v]=[e,[...e.played.
moves],0],this.element.dataset.state="playing",this.#t.focus({preventScroll:!0}),rr(this.#o,e.played.seat)&&this.#R()}watch(e,r,n){this.#l=null,this.#S(e,r,n),this.#O()}stop(){
this.#A(),this.player.pause(),this.#l=null}act(e){let[r,n]=[this.#l,this.#o];if(!r||!n||this.element.dataset.state!=="playing")return;this.#v=e;let o=Number(this.#c.
value);this.#b||(this.#k(),o&&this.element.dataset.state==="playing"&&(this.#b=setInterval(()=>this.#k(),1e3/o)))}key(e){let{target:r,key:n}=e;if(r instanceof HTMLSelectElement||
r instanceof HTMLInputElement&&(r.type==="text"||n===" ")||r instanceof HTMLButtonElement&&(n===" "||n==="Enter")||!this.#o)return!1;if(this.element.dataset.state!==
"playing")return Ue(this.player,e);let s=Vs(e,this.#o.config.diagonal);return s!==void 0&&this.act(s),s!==void 0}#S(e,r,n){this.#A(),this.player.pause(),[this.#o,
this.#f]=[e,r],this.#n.textContent=n,this.#t.ariaLabel=`Board, ${e.config.rows} by ${e.config.cols} cells`,this.#s.show(e.config.diagonal),this.#u.replaceChildren(
m("span",{class:"at-length"},`W A S D or the arrow keys move, Space stays${e.config.diagonal?"; Q E Z C and the numeric keypad move diagonally":""}. `),"On the \
board: swipe, or tap where to go."),this.#M(e),this.#i.replaceChildren(),this.player.length=e.length,this.player.jump(e.length),this.#T()}#x(){this.#r.look={you:this.#f,
fog:this.#m.checked,viewers:this.#f===null?[]:[this.#f],plan:this.#$()}}#M(e){this.#y=null,this.#g=this.player.ticks=[],this.#d.hidden=this.#p.disabled=!!St(e.config),
Gt(this.#e,e.config,ys(e.config)).then(r=>{this.#o===e&&(this.#y=r,this.#E(),this.#T())})}#E(){let[e,r]=[this.#o,this.#y];if(!r||this.element.dataset.state==="p\
laying")return;let n=this.#e.world(e.config);n.reset(e.start),this.#g=Vt(r,n,e.actions),n.free(),this.player.ticks=Kt(this.#g)}get#C(){return this.#p.checked&&this.#l&&
this.element.dataset.state==="playing"&&this.#y&&this.#o.game(this.#y)||null}#$(){let[e,r]=[this.#f,this.#f!==null&&this.#C?.marginal(this.#f)];return e!==null&&
r?Object.assign(Array(e).fill(0),{[e]:r.indexOf(Math.max(...r))}):null}#A(){clearInterval(this.#b),this.#b=0,this.#a.ariaLive=Number(this.#c.value)?"off":"polit\
e"}#k(){let[{policies:e,seat:r},n]=[this.#l.played,this.#o];n.step(e,r,this.#v),this.#w.push(this.#v),this.player.length=n.length,this.player.glide=Math.min(.22,
.9/(Number(this.#c.value)||4)),this.player.move(n.length-this.player.step),rr(n,r)&&this.#R()}#R(){this.#A();let[e,r,n]=[this.#l,this.#o,this.played],o=$n()?e.link(
n):null,s=`${G(n.seat,r.config.n_pursuers)}-${r.length}-steps.npz`,a=()=>so(s,ea(this.#e,r,n.seat));this.#i.replaceChildren(m("h3",{id:"play-headline"},bl(r,n.seat)),
...e.ending(r,n),m("div",{class:"play-buttons"},m("button",{type:"button",class:"primary",onclick:()=>e.again()},"Again"),m("button",{type:"button",onclick:()=>this.#O()},
"Watch it"),m("button",{type:"button",onclick:a},"Save"),o&&m("button",{type:"button",onclick:({currentTarget:l})=>xl(l,o)},"Link"))),this.element.dataset.state=
"ended",this.#E();let i=this.#g.filter(({team:l})=>l===ue(r.config,n.seat));i.length&&this.#i.children[0].after(m("p",{class:"small muted"},vs(i))),this.#i.focus(
{preventScroll:!0}),this.#i.scrollIntoView({block:"nearest"})}#O(){this.element.dataset.state="watched",this.player.length=this.#o.length,this.player.jump(0),Be()||
this.player.play()}#T(){let[e,r,{step:n}]=[this.#o,this.#f,this.player];if(!e||n>e.length)return;let o=Yt(e,e.recording,n).filter(({agents:l})=>r===null||l.includes(
r)),s=this.#l&&n===0,a=s?[gl(e.config,r),this.#l.about??""]:[`Step ${n} of ${e.config.max_steps}`,...o.map(({text:l})=>l)];!s&&r!==null&&a.push(vl(e,n,r)),a.push(
...this.#g.filter(l=>l.step===n).map(mt));let i=n===e.length&&r!==null?this.#C:null;i&&a.push(`Perfect play: ${ws(i,r)||"decided in its turn"}; ${bs(this.#y,i,n)}`),
this.#x(),this.#a.textContent=a.filter(Boolean).map(l=>`${l}.`).join(" ")}};function gl(t,e){let r=t.rules.capture==="SURROUND";return ue(t,e)==="evader"?`Run a\
way: you win if ${r?"the pursuers do not surround you":"no pursuer reaches your cell"} in ${t.max_steps} steps`:`Capture evaders: ${r?"surround them with your t\
eam":"move onto their cells"}`}function vl({config:t,recording:e},r,n){let o=e.moments[r],a=ue(t,n)==="pursuer"?"evader":"pursuer";if(!o.alive[n])return"";let i=R(
o,n),l=p=>{let[d,h]=R(o,p);return Math.max(Math.abs(d-i[0]),Math.abs(h-i[1]))},c=Array.from({length:o.alive.length},(p,d)=>d).filter(p=>ue(t,p)===a&&o.alive[p]&&
!o.captured[p-t.n_pursuers]&&2*l(p)<t.fov);if(!c.length)return`No ${a} in view`;let u=c.reduce((p,d)=>l(d)<l(p)?d:p);return`Nearest ${a}: ${qs(i,R(o,u))}`}function bl(t,e){
let[{lasted:r,out:n,captured:o},{config:s}]=[je(t,e),t];return ue(s,e)==="pursuer"?`Your team captured ${o} of ${wl(s)} in ${r} steps.`:n?`You lasted ${r} of ${s.
max_steps} steps.`:`You escaped: ${r} steps.`}var wl=({n_evaders:t})=>`${t} evader${t===1?"":"s"}`;function xl(t,e){let r=oo("Link to this match");r.value=e,t.replaceWith(
r),r.select(),navigator.clipboard?.writeText(e).catch(()=>{})}var or=class{dialog=m("dialog",{class:"take-over","aria-label":"Play an agent",onclose:()=>this.view?.stop(),onkeydown:e=>this.view?.key(e)&&e.preventDefault()});view=null;#e;#r;#t;#n;#a=null;constructor(e,r,n,o=!0){
[this.#e,this.#r,this.#t,this.#n]=[e,r,n,o],n.element.addEventListener("takeover",()=>this.open())}start(e,r=""){this.#a=e;let n=tt(r,this.#e,this.#r.selected),
o=Hs(new URLSearchParams(r.replace(/^#/,"")),this.#e[n.run].world);o&&this.play(n,o)}open(){let e=this.#t.shown;if(!e)return;let{match:r,step:n}=e;this.#t.player.
pause();let o=this.#t.inspector.agent,s=n<r.length?n:0,a=(p,d)=>!!r.alive[d*r.n_agents+p],i=Array.from({length:r.n_agents},(p,d)=>(d+r.config.n_pursuers)%r.n_agents),
l=o??i.find(p=>a(p,s)),c=a(l,s)?s:0,u=Array.from({length:c},(p,d)=>r.actions[d*r.n_agents+l]);this.play(this.#r.selected,{seat:l,from:c,moves:u})}play(e,r){let[
n,o]=[this.#a,this.#e[e.run]];if(!n||se.some(g=>Et(o,g,e[g])))return;let{run:s,pursuer:a,evader:i,episode:l,seed:c}=e,u=ue(o.world,r.seat),p=o.teams[u].kept.map(
g=>({name:o.teams[u].script??`generation ${g}`,text:"",policy:()=>re(o,u,g)}));this.view||(this.view=new nr(n),this.dialog.append(m("button",{type:"button",class:"\
leave",onclick:()=>this.dialog.close()},"Close"),this.view.element)),this.dialog.open||this.dialog.showModal();let d=`You are ${G(r.seat,o.world.n_pursuers)}: ${this.#t.
names(e).join(" against ")}`,h={pursuer:re(o,"pursuer",a),evader:re(o,"evader",i)},y={config:o.world,seed:BigInt(c??o.seeds[a][i]),episode:l,policies:h,...r},f={
run:s,pursuers:a,evaders:i,episode:l,...c===null?{}:{seed:c}};Xr(n,this.view,d,y,p,this.#n?f:null)}};var ye=eo(),{runs:ee}=ye,[Sl,Ml]=ee[0].payoff.shape,Al=tt(location.hash,ee,{run:0,pursuer:Sl-1,evader:Ml-1,episode:0,seed:null}),{step:ta,...Tl}=Al,Q=new er(Tl),
Y=new qt(ee,Q,ye.playground),ra=new Jt(ee,Q),ft=new or(ee,Q,Y),en=mo(),El=location.hash,ht=null,na=m("span",{class:"told","aria-live":"polite"}),oa=()=>{na.textContent=
ee[Q.selected.run].findings?.sentence??""};Q.on("run",oa);oa();var sa=()=>{Y.playSoon(),Y.reveal()},Cl="Each cell is a match between two generations: the bright\
er, the more evaders are captured. Click one to watch it.";document.getElementById("page").replaceWith(Nn(ye.heading,m("span",{},na,m("span",{class:"small muted"},
Cl)),m("button",{type:"button",class:"keys-button",title:"Keys (?)","aria-label":"Keys (?)",onclick:()=>en.showModal()},"?")),...ye.note?[m("aside",{class:"note\
 small muted"},ye.note)]:[],po(ee,Q),m("main",{class:"stages"},ra.element,Y.element),Fs(ee,Q,sa),m("footer",{class:"muted small"},`${ye.title} · matrixworld ${ye.
version}`),ft.dialog,en);Object.assign(window,{matrixworldExplorer:{get match(){return Y.match},get step(){return Y.player.step},get pace(){return Y.player.pace},
get playing(){return ft.view},play:t=>ht&&Ct(ht,ee[Q.selected.run],{...Q.selected,episode:t}),get shape(){return ee[Q.selected.run].payoff.shape}}});ra.element.
addEventListener("play",sa);Y.goTo(ta);ta||Y.playSoon();In(ee,Q,Y);ho(ee,Q,Y,en,()=>ft.open(),()=>Hr(Y.shown,ye.playground));window.addEventListener("hashchange",
({newURL:t})=>ht&&ft.start(ht,new URL(t).hash));ye.growing&&Un(ee,Q,()=>Y.player.playing||document.querySelector("dialog[open]")!==null);requestAnimationFrame(()=>setTimeout(
()=>On(Cn().then(t=>{ht=t,Y.start(t),ft.start(t,El)}))));})();
