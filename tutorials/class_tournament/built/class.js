/* built from web/ by "npm run build"; sources c5a95fe3a004d169923cbb5169ffed4ea856e5554092dbc969a9bf4432a8b4b4 */
(()=>{var re=[.5,1,2,4,8,16,32,64],be=0,we=12,gn=2,ve=class extends EventTarget{#e;#r;#n;#t=0;#o=0;#a=!1;#s=null;#l=0;#u=[];#h=[];glide=.28;constructor(e,{speed:r=4,still:n=!1}={}){
super(),[this.#e,this.#r,this.#n]=[e,r,n]}get step(){return this.#t}get time(){return this.#n?this.#t:this.#o}get arrived(){return this.#o===this.#t}get playing(){
return this.#a}get length(){return this.#e}set length(e){this.#e=e,this.#t>e&&this.jump(e),this.#i("state")}get marks(){return this.#u}set marks(e){this.#u=e,this.#i(
"state")}get ticks(){return this.#h}set ticks(e){this.#h=e,this.#i("state")}get pace(){return this.#r||Math.max(gn,this.#e/we)}get speed(){return this.#r}set speed(e){
this.#r=e,this.#i("state")}changeSpeed(e){let r=re.findIndex(n=>n>=this.pace);this.speed=re[Math.min(re.length-1,Math.max(0,r+e))]}play(){this.#a||!this.#e||(this.#t===
this.#e&&this.jump(0),this.#a=!0,this.#i("state"),this.#m())}pause(){this.#a&&(this.#a=!1,this.#i("state"))}toggle(){this.#a?this.pause():this.play()}move(e){this.
pause();let r=Math.min(this.#e,Math.max(0,this.#t+e));Math.abs(r-this.#o)>1?this.jump(r):this.#c(r),this.#m()}jump(e){this.#o=Math.min(this.#e,Math.max(0,Math.round(
e))),this.#c(this.#o),this.#i("frame")}#c(e){e!==this.#t&&(this.#t=e,this.#i("step"),this.#n&&this.#i("frame"))}#m(){this.#s===null&&(this.#l=performance.now(),
this.#s=requestAnimationFrame(()=>this.#f()))}#f(){this.#s=null;let e=performance.now();this.#d(Math.min(.25,(e-this.#l)/1e3)),this.#l=e,(!this.#n||this.arrived)&&
this.#i("frame"),(this.#a||this.#o!==this.#t)&&(this.#s=requestAnimationFrame(()=>this.#f()))}#d(e){let r=e;for(;r>0;){if(this.#o===this.#t){if(!this.#a)return;
if(this.#t===this.#e)return this.pause();this.#c(this.#t+1)}let n=this.#a?this.pace:1/this.glide,o=this.#t-this.#o,a=Math.min(Math.abs(o),r*n);r-=a/n,this.#o=a===
Math.abs(o)?this.#t:this.#o+Math.sign(o)*a}this.#a&&this.#o===this.#e&&this.pause()}#i(e){this.dispatchEvent(new Event(e))}};function xe(t,e){if(e.ctrlKey||e.metaKey||
e.altKey)return!1;let r=e.shiftKey?10:1,o={" ":()=>t.toggle(),ArrowRight:()=>t.move(r),ArrowLeft:()=>t.move(-r),Home:()=>t.move(-t.length),End:()=>t.move(t.length),
"+":()=>t.changeSpeed(1),"-":()=>t.changeSpeed(-1)}[e.key];return o?.(),o!==void 0}var Ct={SIMULTANEOUS:0,SWARM_TURNS:1,AGENT_TURNS:2},ne={DISAPPEAR:0,REACH:1,BOUNCE:2},Et={OCCUPATION:0,SURROUND:1},kt={FAULT:0,INVOLVED:1};var Rt=["obstacle","teammate","adversary"],Be=["vertex","edge","chain"],_t=["turn","kind","form","first","second","row","col","at_fault","held","doomed"],Ge=["p\
ursuer_{number}","evader_{number}"],Ot={obstacle:"{first} ran into the obstacle or border at {cell}",vertex:"{first} and {second} both headed for {cell}",edge:"\
{first} and {second} meant to swap, {first} to {cell}",chain:"{first} headed for {cell}, where {second} had to stay"},oe={"both held":"both bounce","both doomed":"\
both disappear",held:"{agent} bounces",doomed:"{agent} disappears",none:"nobody is stopped"},It="{event}: {outcome}",He={random:"any action, all equally likely",
still:"always stays",chaser:"moves to where the nearest adversary in view is nearest",fleer:"moves to where the nearest adversary in view is farthest","clumsy-c\
haser":"a chaser that takes any action in half of the steps",hunter:"a chaser of the nearest adversary in view to which no teammate in view is nearer",surrounder:"\
a chaser of the nearest free cell beside an adversary without a teammate","clumsy-fleer":"a fleer that takes any action in half of the steps",dodger:"moves to w\
here all adversaries in view together are farthest","team-surrounder":"shares the free cells beside adversaries with its teammates, and searches","careful-rando\
m":"as random, but takes only moves that right of way allows","careful-chaser":"as chaser, but takes only moves that right of way allows","careful-fleer":"as fl\
eer, but takes only moves that right of way allows","careful-clumsy-chaser":"as clumsy-chaser, but takes only moves that right of way allows","careful-hunter":"\
as hunter, but takes only moves that right of way allows","careful-surrounder":"as surrounder, but takes only moves that right of way allows","careful-clumsy-fl\
eer":"as clumsy-fleer, but takes only moves that right of way allows","careful-dodger":"as dodger, but takes only moves that right of way allows","careful-team-\
surrounder":"as team-surrounder, but takes only moves that right of way allows"},Pt={free:".GS",blocked:"#@OTW"};var G=1+_t.length;function ae(t,e){return t.replace(/\{(\w+)\}/g,(r,n)=>String(e[n]))}function H(t,e){return t<e?ae(Ge[0],{number:t}):ae(Ge[1],{number:t-e})}function vn(t,e){
let[r,n,o,a,s,i,l,...u]=Array.from(t),m=s<0?[a]:[a,s],[c,f,d]=u.map(C=>m.filter((O,x)=>C>>x&1)),g=m.map(C=>H(C,e)),p=ae(Ot[s<0?"obstacle":Be[o]],{first:g[0],second:g[g.
length-1],cell:`(${i}, ${l})`}),b=ae(It,{event:p,outcome:bn(m.length,f,d,e)});return{kind:Rt[n],form:Be[o],agents:m,cell:[i,l],at_fault:c,held:f,doomed:d,turn:r,
text:b}}function bn(t,e,r,n){if(t===2&&e.length===2)return oe["both held"];if(t===2&&r.length===2)return oe["both doomed"];let o=a=>s=>ae(oe[a],{agent:H(s,n)});
return[...e.map(o("held")),...r.map(o("doomed"))].join(", ")||oe.none}function Me(t,e){let r=[];for(let n=0;n<t.length;n+=G)r.push(vn(t.subarray(n+1,n+G),e));return r}var U=class extends Error{name="EngineError"};function v(t,e,r){let n=typeof r=="string"?`'${r}'`:typeof r=="object"?JSON.stringify(r):String(r);return new U(`${t}\
: expected ${e}, got ${n}`)}var j=class{bytes;constructor(e){this.bytes=e}},$t=0,Ve=[Uint8Array,Uint8Array,Int32Array,BigInt64Array,BigUint64Array,Float32Array,Float64Array],Nt=4,Lt=4,wn=new TextEncoder,
xn=new TextDecoder;function Mn(t){for(let e=Ve.length-1;e>$t;--e)if(t instanceof Ve[e])return e;throw new TypeError("array: expected a typed array of the engine\
's numbers, got another")}function je(t){return new Uint8Array(t.buffer,t.byteOffset,t.byteLength)}function Sn(t){return wn.encode(`${t}\0`)}var qe=class{engine;addresses=[];constructor(e){
this.engine=e}copy(e){let r=this.engine._malloc(Math.max(e.length,1));if(r===0)throw new U("memory: expected room for the arguments, got none");return this.addresses.
push(r),this.engine.HEAPU8.set(e,r),r}text(e){return this.copy(Sn(e))}arrays(e){let r=Object.entries(e),n=r.flatMap(([a,s])=>{let i=s instanceof j,l=i?s.bytes:s;
return[this.text(a),i?$t:Mn(l),l.length,this.copy(je(l))]}),o=this.copy(je(Int32Array.from(n)));return this.copy(je(Int32Array.of(r.length,o)))}free(){for(let e of this.
addresses)this.engine._free(e)}};function zt(t,e){let r=t.HEAPU8;return xn.decode(r.subarray(e,r.indexOf(0,e)))}function V(t){let e=new Int32Array(t.HEAPU8.buffer),
r=t._last_outputs()/Nt,n=e[r+1]/Nt,o={};for(let a=n;a<n+e[r]*Lt;a+=Lt){let s=Ve[e[a+1]],i=e[a+2]*s.BYTES_PER_ELEMENT,l=e[a+3];o[zt(t,e[a])]=new s(t.HEAPU8.slice(
l,l+i).buffer)}return o}function z(t,e){let r=new qe(t);try{let n=e(r);if(n===0)throw new U(zt(t,t._last_error()));return n}finally{r.free()}}var An=2**31-1,Ut=["none","gru"],Tn=2n**64n-1n,Cn=34028234663852886e22;function P(t,e){if(typeof e!="number"||!Number.isInteger(e)||Math.abs(e)>An)throw v(t,"an\
 integer",e);return Int32Array.of(e)}function Se(t,e){if(typeof e!="boolean")throw v(t,"true or false",e);return new j(Uint8Array.of(Number(e)))}function F(t,e,r){
let n=typeof e=="string"&&Object.hasOwn(r,e)?r[e]:void 0;if(n===void 0)throw v(t,`one of ${Object.keys(r).join(", ")}`,e);return Int32Array.of(n)}function Ke(t,e){
if(typeof e!="number"||!(Math.abs(e)<=Cn))throw v(t,"a finite number",e);return e}function se(t,e){let n=typeof e=="bigint"||typeof e=="number"&&Number.isSafeInteger(
e)?BigInt(e):-1n;if(n<0n||n>Tn)throw v(t,"an integer from 0 to 2^64 - 1",e);return BigUint64Array.of(n)}function En(t){return{"rules.interaction":F("interaction",
t.interaction,Ct),"rules.obstacle":F("obstacle",t.obstacle,ne),"rules.teammate":F("teammate",t.teammate,ne),"rules.evader":F("evader",t.evader,ne),"rules.pursue\
r":F("pursuer",t.pursuer,ne),"rules.capture":F("capture",t.capture,Et),"rules.captured_disappear":Se("captured_disappear",t.captured_disappear)}}function Ft(t,e){
let r=typeof e=="number"?[e,e,e]:e;if(!Array.isArray(r)||r.length!==3)throw v(t,"1 or 3 numbers",e);return Float32Array.from(r,n=>Ke(t,n))}function kn(t){let e=(r,n)=>Float32Array.
of(Ke(r,t[r]),Ke(n,t[n]));return{"rewards.capture":e("pursuer_capture","evader_capture"),"rewards.neighbor":e("pursuer_neighbor","evader_neighbor"),"rewards.ste\
p":e("pursuer_step","evader_step"),"rewards.pursuer_collide":Ft("pursuer_collide",t.pursuer_collide),"rewards.evader_collide":Ft("evader_collide",t.evader_collide),
"rewards.blame":F("blame",t.blame,kt),"rewards.capture_repeats":Se("capture_repeats",t.capture_repeats)}}function Wt(t){if(t===void 0||typeof t=="number")return new Uint8Array(
0);if(t instanceof Uint8Array)return t;let{free:e,blocked:r}=Pt;for(let[n,o]of t.entries()){if(o.length!==t[0]?.length)throw v(`map, row ${n}`,`${t[0]?.length} \
cells as in row 0`,o.length);let a=[...o].find(s=>!e.includes(s)&&!r.includes(s));if(a)throw v(`map, row ${n}`,`'${e}' (free) or '${r}' (obstacle)`,a)}return Uint8Array.
from([...t.join("")],n=>Number(r.includes(n)))}function Bt(t,e){if(!Array.isArray(t))return;let r=[t.length,t[0]?.length??0];if(!(r[0]===e.rows&&r[1]===e.cols))
throw v("obstacle map",`shape (${e.rows}, ${e.cols}), the rows and cols`,r)}function q(t){Bt(t.obstacles,t);let e=typeof t.obstacles=="number"?t.obstacles:0;return{
...En(t.rules),...kn(t.rewards),rows:P("rows",t.rows),cols:P("cols",t.cols),n_pursuers:P("n_pursuers",t.n_pursuers),n_evaders:P("n_evaders",t.n_evaders),fov:P("\
fov",t.fov),diagonal:Se("diagonal",t.diagonal),max_steps:P("max_steps",t.max_steps),density:Float64Array.of(e),map:Wt(t.obstacles)}}function Dt(t,e){return Int32Array.
from((e??[]).flat(),r=>P(t,r)[0])}function Gt(t,e){return Bt(t.obstacles,e),{seed:se("seed",t.seed??0n),episode:se("episode",t.episode??0),pursuers:Dt("pursuers",
t.pursuers),evaders:Dt("evaders",t.evaders),map:Wt(t.obstacles)}}function Ae(t){return{actions:Int32Array.from(t,e=>P("actions",e)[0])}}function K(t){if(typeof t==
"string"){if(!Object.hasOwn(He,t))throw v("policy",`one of ${Object.keys(He).join(", ")}`,t);return{script:new TextEncoder().encode(t)}}if(t.activation!=="relu"&&
t.activation!=="tanh")throw v("activation","'relu' or 'tanh'",t.activation);if(!Ut.includes(t.memory))throw v("memory",`one of ${Ut.join(", ")}`,t.memory);return{
hidden:Int32Array.from(t.hidden,e=>P("hidden",e)[0]),activation:new TextEncoder().encode(t.activation),sampled:Se("sampled",t.sampled),memory:new TextEncoder().
encode(t.memory),genome:t.genome}}var Rn=["first_turn","terminated","truncated"];function Ht(t){let e={...t};for(let r of Rn)e[r]=new j(t[r]);return e}var jt="statistics.",Te=class{config;seed;episode;n_agents;statistics;first_conflict;constructor(e,r,n,o){this.config=e,this.seed=r,this.episode=n,this.n_agents=
e.n_pursuers+e.n_evaders,this.statistics=On(Vt(o)),Object.assign(this,o),this.first_conflict=_n(this.conflict_table,this.length)}get length(){return this.actions.
length/this.n_agents}conflicts(e){this.check(e);let[r,n]=[this.first_conflict[e],this.first_conflict[e+1]],o=this.conflict_table.subarray(r*G,n*G);return Me(o,this.
config.n_pursuers)}seek(e,r,n){this.check(r),(!(e.seed===this.seed&&e.episode===BigInt(this.episode))||e.turn!==0||e.steps>r)&&e.reset({seed:this.seed,episode:this.
episode});for(let a=e.steps;a<r;++a){let s=this.actions.subarray(a*this.n_agents,(a+1)*this.n_agents);n?e.replay(s,{pursuer:n.pursuers,evader:n.evaders}):e.step(
s)}}check(e){if(!(Number.isInteger(e)&&e>=0&&e<=this.length))throw v("step",`0 to ${this.length}`,e)}};function _n(t,e){let r=new Int32Array(e+2);for(let n=0;n<
t.length;n+=G)++r[t[n]+1];for(let n=1;n<r.length;++n)r[n]+=r[n-1];return r}function On(t){let e=["capture_rate","ever_capture_rate","captured_fraction","length"];
return Object.fromEntries(Object.entries(t).map(([r,n])=>[r,e.includes(r)?Number(n[0]):n]))}var Vt=t=>Object.fromEntries(Object.entries(t).flatMap(([e,r])=>e.startsWith(
jt)?[[e.slice(jt.length),r]]:[]));function qt(t,e,r,n){let o=[q(r.config),K(r.pursuers),K(r.evaders),n];return z(t,a=>{let[s,i,l,u]=o.map(m=>a.arrays(m));return t[e](
s,i,l,u)}),V(t)}function Kt(t,e,r,n){let o={seed:se("seed",r),episode:se("episode",n)};return new Te(e.config,r,n,qt(t,"_play_match",e,o))}function Zt(t,e,r,n){
if(!Number.isInteger(n)||n<1)throw v("n_episodes","at least 1",n);let o=qt(t,"_play_rollout",e,{...r,n_episodes:Int32Array.of(n)});return Vt(o)}var In=new FinalizationRegistry(([t,e])=>t._states_free(e));var Ze=class{value;teams;matrix;n_actions;constructor(e,r){let{matrix:n,rows:o,cols:a,value:s,agents:i}=r,[l,u]=e.actors,m=Array.from(i).filter(f=>l<=f&&f<u),c=f=>f<
e.config.n_pursuers;[this.value,this.matrix,this.n_actions]=[s[0],n,e.n_actions],this.teams=[{agents:m.filter(c),play:o},{agents:m.filter(f=>!c(f)),play:a}]}marginal(e){
let r=this.teams.find(({agents:a})=>a.includes(e));if(!r)return null;let n=this.n_actions**(r.agents.length-1-r.agents.indexOf(e)),o=Array(this.n_actions).fill(
0);return r.play.forEach((a,s)=>o[Math.floor(s/n)%this.n_actions]+=a),o}lost(e){let[r,n]=this.teams.map(({agents:l})=>l.reduce((u,m)=>u*this.n_actions+e[m],0)),
[o,a]=this.teams.map(({play:l})=>l),s=a.reduce((l,u,m)=>l+u*this.matrix[r*a.length+m],0),i=o.reduce((l,u,m)=>l+u*this.matrix[m*a.length+n],0);return[Math.max(0,
this.value-s),Math.max(0,i-this.value)]}},Pn=60,ie=class{config;payoff;engine;states;n_turns;values;constructor(e,r,n){[this.engine,this.config,this.payoff]=[e,
r,n],this.states=z(e,i=>e._states_new(i.arrays(q(r)))),In.register(this,[e,this.states]);let o={SIMULTANEOUS:1,SWARM_TURNS:2,AGENT_TURNS:r.n_pursuers+r.n_evaders};
this.n_turns=o[r.rules.interaction];let{payoffs:a}=this.call(()=>e._states_payoffs(this.states)),s=a;this.values=[[n==="capture-rate"?s:s.fill(0)]]}goBack(){let e=this.
values.at(-1)[0],r=[];for(let o=this.n_turns-1;o>=0;o--){let a=r[o+1]??e;r[o]=this.backup(o,{next:a})}this.payoff==="capture-time"&&(r[0]=r[0].map((o,a)=>a===this.
config.n_evaders?0:o-1)),this.values.push(r);let n=this.payoff==="capture-rate"?this.config.max_steps:Math.min(this.config.max_steps,Pn);return this.values.length<=
n&&r[0].some((o,a)=>o!==e[a])}backup(e,r){return this.call(n=>this.engine._states_backup(this.states,e,n.arrays(r))).values}game(e){let[r,{turn:n}]=[this.config.
max_steps-e.steps,e],o=n+1===this.n_turns,a=r>0?this.values[Math.min(r-Number(o),this.values.length-1)]?.[o?0:n+1]:void 0;if(!a)return null;let s=this.call(i=>this.
engine._states_game(this.states,e.address,i.arrays({next:a})));return s.agents.length?new Ze(e,s):null}call(e){return z(this.engine,e),V(this.engine)}};var Yt=new FinalizationRegistry(([t,e])=>t._world_free(e)),le=class{config;n_agents;n_actions;engine;at;freed=!1;constructor(e,r){this.engine=e,this.config=r,this.
n_agents=r.n_pursuers+r.n_evaders,this.n_actions=r.diagonal?9:5,this.at=z(e,n=>e._world_new(n.arrays(q(r)))),Yt.register(this,[e,this.at],this)}free(){this.freed||
(this.freed=!0,Yt.unregister(this),this.engine._world_free(this.at))}get address(){if(this.freed)throw v("world","one that is in use","one that was freed");return this.
at}reset(e={}){let r=Gt(e,this.config);this.call(n=>this.engine._world_reset(this.address,n.arrays(r)))}step(e){let r=Ae(e);this.call(n=>this.engine._world_step(
this.address,n.arrays(r)))}playTurn(e){let r=Ae(e);this.call(n=>this.engine._world_play_turn(this.address,n.arrays(r)))}decide(e,r,n){let{n_pursuers:o}=this.config,
a={pursuer:[0,o],evader:[o,this.n_agents]},[s,i]=typeof r=="string"?a[r]:r;if(n.length!==this.n_agents)throw v("actions",String(this.n_agents),n.length);let l=[
K(e),Ae(n)],{actions:u}=this.call(m=>this.engine._world_decide(this.address,m.arrays(l[0]),s,i,m.arrays(l[1])));return Uint8Array.from(u)}replay(e,r){let n=a=>typeof a!=
"string"&&a.memory!=="none";if(!n(r.pursuer)&&!n(r.evader))return this.step(e);let{n_pursuers:o}=this.config;for(let a=this.n_turns;a>0;--a){let[s,i]=this.actors;
s<o&&this.decide(r.pursuer,[s,Math.min(i,o)],e),i>o&&this.decide(r.evader,[Math.max(s,o),i],e),this.playTurn(e)}}get n_turns(){return this.turnNumbers()[1]}get turn(){
return this.turnNumbers()[0]}get actors(){let[,,e,r]=this.turnNumbers();return[e,r]}turnNumbers(){return this.call(()=>this.engine._world_turn(this.address)).turn}get steps(){
return this.read("steps")[0]}get seed(){return this.read("seed")[0]}get episode(){return this.read("episode")[0]}get over(){return this.read("terminated")[0]===
1||this.read("truncated")[0]===1}read(e){return this.call(r=>this.engine._world_read(this.address,r.text(e)))[e]}view(e){let r=3*this.config.fov**2;return this.
read("views").slice(e*r,(e+1)*r)}map(){return this.read("state").slice(2*this.config.rows*this.config.cols)}conflicts(){return Me(this.conflictTable(),this.config.
n_pursuers)}conflictTable(){return this.call(()=>this.engine._world_conflicts(this.address)).conflict_table}answer(e,r){let n=K(e),{logits:o,memory:a}=this.call(
l=>this.engine._world_logits(this.address,l.arrays(n),r)),s=o,i=this.decide(e,[r,r+1],new Uint8Array(this.n_agents))[r];return{logits:s,probabilities:Nn(s),action:i,
memory:a}}snapshot(){return this.call(()=>this.engine._world_snapshot(this.address))}restore(e){let r=Ht(e);this.call(n=>this.engine._world_restore(this.address,
n.arrays(r)))}call(e){return z(this.engine,e),V(this.engine)}};function Nn(t){let e=Math.max(...t),r=Array.from(t,o=>Math.exp(o-e)),n=r.reduce((o,a)=>o+a,0);return Float32Array.
from(r,o=>o/n)}var Ye=class{compiled;constructor(e){this.compiled=e}world(e){return new le(this.compiled,e)}solution(e,r="capture-rate"){return new ie(this.compiled,e,r)}match(e,r,n,o,a=0){
return Kt(this.compiled,{config:e,pursuers:r,evaders:n},o,a)}rollouts(e,r,n,o,a){return Zt(this.compiled,{config:e,pursuers:r,evaders:n},o,a)}},Xt;function Jt(t=globalThis.
matrixworldEngine){return Xt??=Ln(t),Xt}async function Ln(t){if(!t)throw new Error("matrixworldEngine: expected the script engine.js before this one, got none");
let e=Uint8Array.from(atob(t.binary),r=>r.charCodeAt(0));return new Ye(await t({wasmBinary:e}))}var $n="http://www.w3.org/2000/svg";function h(t,e={},...r){return Qt(document.createElement(t),e,r)}function M(t,e={},...r){return Qt(document.createElementNS(
$n,t),e,r)}function Qt(t,e,r){for(let[o,a]of Object.entries(e))a==null||a===!1||(typeof a=="function"?t.addEventListener(o.slice(2),a):t.setAttribute(o,a===!0?"":
String(a)));let n=r.filter(o=>o!=null&&o!==!1);return t.append(...n.map(o=>typeof o=="number"?String(o):o)),t}var er=()=>document.documentElement.dataset.theme==="dark",ue=t=>{document.documentElement.dataset.theme=t?"dark":"light"},Xe=()=>ue(!er());if(typeof document<"\
u"){let t=matchMedia("(prefers-color-scheme: dark)");t.addEventListener("change",()=>ue(t.matches)),ue(t.matches);let e=!1;addEventListener("beforeprint",()=>{e=
er(),ue(!1)}),addEventListener("afterprint",()=>ue(e))}function tr(){return h("button",{type:"button",title:"Light or dark (D)","aria-label":"Light or dark",onclick:Xe},
"◐")}var rr=(t,e,...r)=>h("header",{class:"top"},h("div",{},h("h1",{},t),e?h("p",{class:"lead"},e):null),h("div",{class:"tools"},...r,tr()));var k=Uint8Array,Z=Uint16Array,zn=Int32Array,nr=new k([0,0,0,0,0,0,0,0,1,1,1,1,2,2,2,2,3,3,3,3,4,4,4,4,5,5,5,5,0,0,0,0]),or=new k([0,0,0,0,1,1,2,2,3,3,4,4,5,5,6,
6,7,7,8,8,9,9,10,10,11,11,12,12,13,13,0,0]),Un=new k([16,17,18,0,8,7,9,6,10,5,11,4,12,3,13,2,14,1,15]),ar=function(t,e){for(var r=new Z(31),n=0;n<31;++n)r[n]=e+=
1<<t[n-1];for(var o=new zn(r[30]),n=1;n<30;++n)for(var a=r[n];a<r[n+1];++a)o[a]=a-r[n]<<5|n;return{b:r,r:o}},sr=ar(nr,2),ir=sr.b,Fn=sr.r;ir[28]=258,Fn[258]=28;var lr=ar(
or,0),Dn=lr.b,ka=lr.r,et=new Z(32768);for(y=0;y<32768;++y)N=(y&43690)>>1|(y&21845)<<1,N=(N&52428)>>2|(N&13107)<<2,N=(N&61680)>>4|(N&3855)<<4,et[y]=((N&65280)>>8|
(N&255)<<8)>>1;var N,y,ce=(function(t,e,r){for(var n=t.length,o=0,a=new Z(e);o<n;++o)t[o]&&++a[t[o]-1];var s=new Z(e);for(o=1;o<e;++o)s[o]=s[o-1]+a[o-1]<<1;var i;
if(r){i=new Z(1<<e);var l=15-e;for(o=0;o<n;++o)if(t[o])for(var u=o<<4|t[o],m=e-t[o],c=s[t[o]-1]++<<m,f=c|(1<<m)-1;c<=f;++c)i[et[c]>>l]=u}else for(i=new Z(n),o=0;o<
n;++o)t[o]&&(i[o]=et[s[t[o]-1]++]>>15-t[o]);return i}),he=new k(288);for(y=0;y<144;++y)he[y]=8;var y;for(y=144;y<256;++y)he[y]=9;var y;for(y=256;y<280;++y)he[y]=
7;var y;for(y=280;y<288;++y)he[y]=8;var y,ur=new k(32);for(y=0;y<32;++y)ur[y]=5;var y;var Wn=ce(he,9,1);var Bn=ce(ur,5,1),Je=function(t){for(var e=t[0],r=1;r<t.length;++r)t[r]>e&&(e=t[r]);return e},R=function(t,e,r){var n=e/8|0;return(t[n]|t[n+1]<<8)>>(e&7)&r},Qe=function(t,e){
var r=e/8|0;return(t[r]|t[r+1]<<8|t[r+2]<<16)>>(e&7)},Gn=function(t){return(t+7)/8|0},Hn=function(t,e,r){return(e==null||e<0)&&(e=0),(r==null||r>t.length)&&(r=t.
length),new k(t.subarray(e,r))};var jn=["unexpected EOF","invalid block type","invalid length/literal","invalid distance","stream finished","no stream handler",,"no callback","invalid UTF-8 da\
ta","extra field too long","date not in range 1980-2099","filename too long","stream finishing","invalid zip data"],_=function(t,e,r){var n=new Error(e||jn[t]);
if(n.code=t,Error.captureStackTrace&&Error.captureStackTrace(n,_),!r)throw n;return n},Vn=function(t,e,r,n){var o=t.length,a=n?n.length:0;if(!o||e.f&&!e.l)return r||
new k(0);var s=!r,i=s||e.i!=2,l=e.i;s&&(r=new k(o*3));var u=function(St){var At=r.length;if(St>At){var Tt=new k(Math.max(At*2,St));Tt.set(r),r=Tt}},m=e.f||0,c=e.
p||0,f=e.b||0,d=e.l,g=e.d,p=e.m,b=e.n,C=o*8;do{if(!d){m=R(t,c,1);var O=R(t,c+1,3);if(c+=3,O)if(O==1)d=Wn,g=Bn,p=9,b=5;else if(O==2){var ze=R(t,c,31)+257,pt=R(t,
c+10,15)+4,yt=ze+R(t,c+5,31)+1;c+=14;for(var ee=new k(yt),Ue=new k(19),E=0;E<pt;++E)Ue[Un[E]]=R(t,c+E*3,7);c+=pt*3;for(var gt=Je(Ue),mn=(1<<gt)-1,fn=ce(Ue,gt,1),
E=0;E<yt;){var vt=fn[R(t,c,mn)];c+=vt&15;var x=vt>>4;if(x<16)ee[E++]=x;else{var W=0,ge=0;for(x==16?(ge=3+R(t,c,3),c+=2,W=ee[E-1]):x==17?(ge=3+R(t,c,7),c+=3):x==
18&&(ge=11+R(t,c,127),c+=7);ge--;)ee[E++]=W}}var bt=ee.subarray(0,ze),$=ee.subarray(ze);p=Je(bt),b=Je($),d=ce(bt,p,1),g=ce($,b,1)}else _(1);else{var x=Gn(c)+4,L=t[x-
4]|t[x-3]<<8,Q=x+L;if(Q>o){l&&_(0);break}i&&u(f+L),r.set(t.subarray(x,Q),f),e.b=f+=L,e.p=c=Q*8,e.f=m;continue}if(c>C){l&&_(0);break}}i&&u(f+131072);for(var dn=(1<<
p)-1,pn=(1<<b)-1,Fe=c;;Fe=c){var W=d[Qe(t,c)&dn],B=W>>4;if(c+=W&15,c>C){l&&_(0);break}if(W||_(2),B<256)r[f++]=B;else if(B==256){Fe=c,d=null;break}else{var wt=B-
254;if(B>264){var E=B-257,te=nr[E];wt=R(t,c,(1<<te)-1)+ir[E],c+=te}var De=g[Qe(t,c)&pn],We=De>>4;De||_(3),c+=De&15;var $=Dn[We];if(We>3){var te=or[We];$+=Qe(t,c)&
(1<<te)-1,c+=te}if(c>C){l&&_(0);break}i&&u(f+131072);var xt=f+wt;if(f<$){var Mt=a-$,yn=Math.min($,xt);for(Mt+f<0&&_(3);f<yn;++f)r[f]=n[Mt+f]}for(;f<xt;++f)r[f]=
r[f-$]}}e.l=d,e.p=Fe,e.b=f,e.f=m,d&&(m=1,e.m=p,e.d=g,e.n=b)}while(!m);return f!=r.length&&s?Hn(r,0,f):r.subarray(0,f)};var qn=new k(0);var Kn=function(t,e){return((t[0]&15)!=8||t[0]>>4>7||(t[0]<<8|t[1])%31)&&_(6,"invalid zlib data"),(t[1]>>5&1)==+!e&&_(6,"invalid zlib data: "+(t[1]&32?"need":"u\
nexpected")+" dictionary"),(t[1]>>3&4)+2};function cr(t,e){return Vn(t.subarray(Kn(t,e&&e.dictionary),-4),{i:2},e&&e.out,e&&e.dictionary)}var Zn=typeof TextDecoder<"u"&&new TextDecoder,Yn=0;try{Zn.decode(qn,{stream:!0}),Yn=1}catch{}var S=(t,e=2)=>t==null?"-":t.toFixed(e);function hr(t){let e=atob(tt(t)),r=new Uint8Array(e.length);for(let n=0;n<r.length;n++)r[n]=e.charCodeAt(n);return r}var tt=t=>document.getElementById(t)?.textContent??
"";function mr(){return JSON.parse(tt("data"))}var rt=[[0,0],[-1,0],[0,1],[1,0],[0,-1],[-1,1],[1,1],[1,-1],[-1,-1]];var D=(t,e)=>e<t.nPursuers,w=(t,e)=>[t.positions[2*e],t.positions[2*e+1]],nt=({rows:t,cols:e},[r,n])=>r>=0&&n>=0&&r<t&&n<e,ot=(t,e,r=3)=>t!==void 0&&[0,1,2].slice(
0,r).some(n=>t[3*e+n]),at=(t,e)=>ot(t.fault,e),fr=(t,e)=>!at(t,e)&&ot(t.involved,e,2);function Ce(t,e,r){let[n,o]=[w(t,r),w(e,r)],a=n[0]!==o[0]||n[1]!==o[1],s=e.
involved===void 0||ot(e.involved,r);return!!(e.alive[r]&&e.actions?.[r]&&!a&&s)}function Ee(t,e,r){let[n,o]=w(t,r),[a,s]=rt[e.actions?.[r]??0];return[n+a,o+s]}function me(t,e,r){
return Array.from({length:r.everCaptured.length},(o,a)=>a).filter(o=>r.everCaptured[o]&&!e.everCaptured[o]).map(o=>t.nPursuers+o)}var dr=t=>t.moments.flatMap((e,r)=>r&&
me(t,t.moments[r-1],e).length?[r]:[]);function ke(t,e){return Array.from({length:e.alive.length},(n,o)=>o).filter(n=>t.alive[n]&&!e.alive[n])}var pr=[-.31,0,.31],yr=[{size:1,at:[[0,0]]},{size:.62,at:[[-.2,.2],[.2,-.2]]},{size:.54,at:[[-.23,.22],[.23,.22],[0,-.22]]},{size:.54,at:[[-.23,.23],[.23,.23],[
-.23,-.23],[.23,-.23]]},{size:.36,at:pr.flatMap(t=>pr.map(e=>[e,t]))}],Xn=.3,Jn=.35,Qn=.55;function fe(t,e){let r=new Map;for(let n=0;n<e.alive.length;n++){if(!e.
alive[n])continue;let[o,a]=w(e,n),s=o*t.cols+a,i=r.get(s);i?i.push(n):r.set(s,[n])}return r}function gr(t,e){let r=Array.from(e.alive,(n,o)=>{let[a,s]=w(e,o);return{
x:s+.5,y:a+.5,size:1,alpha:0}});for(let n of fe(t,e).values()){let o=yr[Math.min(n.length,yr.length)-1];n.forEach((a,s)=>{let[i,l]=o.at[Math.min(s,o.at.length-1)],
u=r[a];u.x+=i,u.y+=l,u.size=o.size,u.alpha=1})}return r}var vr=t=>t*t*(3-2*t),Y=(t,e,r)=>t+(e-t)*r,br=t=>Math.min(1,Math.max(0,t));function wr(t,e,r,n){let o={SIMULTANEOUS:1,
SWARM_TURNS:2,AGENT_TURNS:r}[t.interaction];if(o===1)return vr(n);let a=o===r?e:+!D(t,e),s=Math.max(1/o,Jn);return vr(br((n-a/(o-1)*(1-s))/s))}function Re(t,e){
let r=t.moments.length-1,n=Math.min(Math.floor(e),r),o=t.moments[n],a=gr(t,o);if(n===r||e===n)return a;let s=t.moments[n+1],i=gr(t,s);return a.map((l,u)=>{let m=wr(
t,u,a.length,e-n);return eo(o,s,u,l,i[u],m)})}function st(t,e,r){let n=t.moments.length-1,o=Math.min(Math.floor(r),n),[a,s]=[t.moments[o],t.moments[Math.min(o+1,
n)]],i=wr(t,e,a.alive.length,r-o),[[l,u],[m,c]]=[w(a,e),w(s,e)];return[Y(u,c,i)+.5,Y(l,m,i)+.5]}function eo(t,e,r,n,o,a){let s=n.alpha>o.alpha,i={x:Y(n.x,o.x,a),
y:Y(n.y,o.y,a),size:s?n.size:Y(n.size,o.size,a),alpha:s?br((1-a)/(1-Qn)):Y(n.alpha,o.alpha,a)};if(Ce(t,e,r)){let[l,u]=w(t,r),[m,c]=Ee(t,e,r),f=Xn*Math.sin(Math.
PI*a);i.x+=(c-u)*f,i.y+=(m-l)*f}return i}var xr=2*Math.PI;function de(t,e,r,n){t.beginPath(),t.arc(e,r,n/2,0,xr)}function Mr(t,e,r,n){let o=n/2,a=[[0,-.97],[.97,.83],[-.97,.83]].map(([s,i])=>[e+s*o,r+i*
o]);t.beginPath(),t.moveTo((a[2][0]+a[0][0])/2,(a[2][1]+a[0][1])/2),a.forEach(([s,i],l)=>{let[u,m]=a[(l+1)%3];t.arcTo(s,i,u,m,n*.09)}),t.closePath()}function Sr(t,e,r,n){
let o=n*.32;t.beginPath(),t.moveTo(e-o,r-o),t.lineTo(e+o,r+o),t.moveTo(e+o,r-o),t.lineTo(e-o,r+o)}function Ar(t,e,r,n){t.beginPath();for(let o=0;o<16;o++){let a=n/
2*(o%2?.6:.95),s=xr*o/16;t.lineTo(e+a*Math.sin(s),r-a*Math.cos(s))}t.closePath()}function Tr(t,e,r,n,o,a){let s=Math.atan2(o-r,n-e);t.beginPath(),t.moveTo(e,r),
t.lineTo(n,o);for(let i of[-1,1])t.moveTo(n,o),t.lineTo(n-a*Math.cos(s+i*.6),o-a*Math.sin(s+i*.6))}var Cr=4,to=1.6,ro=.95,no=5,oo=.16,ao=9,so=.09,io=.2,Er=.75,A=(t,e)=>t.left+e*t.cell,T=(t,e)=>t.top+e*t.cell;function X(t,e,r){return D(e,r)?t.colors.pursuer:t.
colors.evader}function _e({ctx:t,colors:e},r,n,o,a,s,i=0){t.font=`700 ${Math.round(a)}px system-ui, sans-serif`,t.textAlign="center",t.textBaseline="middle",t.strokeStyle=
e.paper,t.lineWidth=i,i&&t.strokeText(r,n,o),t.fillStyle=s,t.fillText(r,n,o)}function kr({ctx:t,grid:e,colors:r}){let{left:n,top:o,cell:a,rows:s,cols:i}=e,[l,u]=[
i*a,s*a];if(t.fillStyle=r.paper,t.fillRect(n,o,l,u),a<no)return;t.fillStyle=r.line;let m=Math.max(1,Math.round(a/60));for(let c=1;c<i;c++)t.fillRect(n+c*a,o,m,u);
for(let c=1;c<s;c++)t.fillRect(n,o+c*a,l,m)}function Rr({ctx:t,grid:e,colors:r},n){let{left:o,top:a,cell:s,rows:i,cols:l}=e;t.fillStyle=r.obstacle;for(let u=0;u<
i*l;u++){if(!n.obstacles[u])continue;let[m,c]=[Math.floor(u/l),u%l];t.fillRect(o+c*s,a+m*s,s,s)}_r({ctx:t,grid:e,colors:r})}function _r({ctx:t,grid:{left:e,top:r,
cell:n,rows:o,cols:a},colors:s}){let i=Math.min(5,Math.max(2,Math.round(n/18)));t.strokeStyle=s.frame,t.lineWidth=i,t.strokeRect(e-i/2,r-i/2,a*n+i,o*n+i)}function Or({
ctx:t,grid:e,colors:r},n){let{left:o,top:a,cell:s,rows:i,cols:l}=e,u=s<24*n?5:1;t.font=`500 ${Math.round(Math.min(15*n,Math.max(9*n,s*.32)))}px system-ui, sans-\
serif`,t.fillStyle=r.muted,t.textBaseline="alphabetic",t.textAlign="center";let m=5*n+s/40;for(let c=0;c<l;c+=u)t.fillText(String(c),o+(c+.5)*s,a-m);t.textAlign=
"right",t.textBaseline="middle";for(let c=0;c<i;c+=u)t.fillText(String(c),o-m,a+(c+.5)*s)}function Ir({grid:t},e,r,n){let o=Math.floor(e.fov/2)+.5,[a,s]=[Math.max(
0,r-o),Math.min(t.cols,r+o)],[i,l]=[Math.max(0,n-o),Math.min(t.rows,n+o)];return[A(t,a),T(t,i),(s-a)*t.cell,(l-i)*t.cell]}function Pr(t,e,r,n){let{ctx:o,grid:a,
colors:s}=t;o.save(),o.beginPath(),o.rect(0,0,o.canvas.width,o.canvas.height),o.rect(...Ir(t,e,r,n)),o.clip("evenodd"),o.clearRect(0,0,o.canvas.width,o.canvas.height),
o.fillStyle=s.line,o.fillRect(a.left,a.top,a.cols*a.cell,a.rows*a.cell),o.restore(),_r(t)}function Nr(t,{x:e,y:r,alpha:n},o){let{ctx:a,grid:s,colors:i}=t,l=Math.
max(s.cell,16*o)*1.06,[u,m]=[A(s,e),T(s,r)];a.globalAlpha=Math.max(n,.6),a.beginPath(),a.roundRect(u-l/2,m-l/2,l,l,l*.2),a.strokeStyle=i.focus,a.lineWidth=Math.
max(2,2.5*o),a.stroke();let c=Math.max(11*o,Math.min(18*o,s.cell*.5)),f=m-l/2<c*1.2,d=m+(f?1:-1)*(l/2+c*.7);a.lineJoin="round",_e(t,"You",u,d,c,i.ink,c*.35),a.globalAlpha=
1}function Lr(t,e,r,n,o){let{ctx:a,grid:s}=t,i=Ir(t,e,n,o),l=X(t,e,r);a.globalAlpha=.11,a.fillStyle=l,a.fillRect(...i),a.globalAlpha=.8,a.strokeStyle=l,a.lineWidth=
Math.max(1,s.cell/24),a.strokeRect(...i),a.globalAlpha=1}function $r(t,e,r,n,o){let{ctx:a,grid:s}=t,i=Math.min(Math.ceil(r),e.moments.length-1),l=e.moments[i];a.
lineCap="round",a.lineWidth=Math.min(ao,Math.max(1,s.cell*oo));for(let u=Math.max(1,Math.floor(r-n)+1);u<=i;u++){let[m,c]=[e.moments[u-1],e.moments[u]],f=Math.max(
0,Math.min(1,(r-u)/n));a.globalAlpha=Er+(io-Er)*f;for(let d=0;d<c.alive.length;d++){let g=u===i&&r<i;if(!m.alive[d]||!(l.alive[d]||g))continue;let p=(D(e,d)?-1:
1)*so,[b,C]=w(m,d),[O,x]=w(c,d);if(b===O&&C===x)continue;let L=g?o[d].x:x+.5,Q=g?o[d].y:O+.5;a.strokeStyle=X(t,e,d),a.beginPath(),a.moveTo(A(s,C+.5+p),T(s,b+.5+
p)),a.lineTo(A(s,L+p),T(s,Q+p)),a.stroke()}}a.globalAlpha=1}function zr(t,e,r){let n=Math.min(Math.ceil(r),e.moments.length-1);for(let o=Math.max(1,n-Cr+1);o<=n;o++){
let[a,s]=[e.moments[o-1],e.moments[o]],i=o>r?Math.max(0,1-2*(o-r)):1-(r-o)/Cr,l=me(e,a,s);for(let u of ke(a,s))l.includes(u)||uo(t,w(s,u),i);for(let u of l)lo(t,
w(s,u),i)}t.ctx.globalAlpha=1}function lo({ctx:t,grid:e,colors:r},[n,o],a){t.globalAlpha=a,Ar(t,A(e,o+.5),T(e,n+.5),Math.max(8,e.cell*to)),t.fillStyle=r.capture,
t.fill(),t.strokeStyle=r.ink,t.lineWidth=Math.max(1,e.cell/36),t.lineJoin="round",t.stroke()}function uo({ctx:t,grid:e,colors:r},[n,o],a){t.globalAlpha=a,Sr(t,A(
e,o+.5),T(e,n+.5),Math.max(7,e.cell*ro)),t.strokeStyle=r.collision,t.lineWidth=Math.max(2,e.cell*.17),t.lineCap="round",t.stroke()}function Ur({ctx:t,grid:e,colors:r},n,o){
let a=Math.max(1,e.cell*.07);t.strokeStyle=t.fillStyle=r.collision,t.lineWidth=Math.max(1,e.cell*.05),t.setLineDash([e.cell*.14,e.cell*.1]);for(let[s,i]of n){if(s<
0||i<0||s>=e.rows||i>=e.cols)continue;let l=[A(e,i)+a,T(e,s)+a,e.cell-2*a,e.cell-2*a];t.globalAlpha=.2*o,t.fillRect(...l),t.globalAlpha=o,t.strokeRect(...l)}t.setLineDash(
[]),t.globalAlpha=1}function Fr({ctx:t,grid:e,colors:r},n,o,a,s){t.globalAlpha=s,de(t,A(e,n),T(e,o),Math.max(8,e.cell*a*1.02)),t.strokeStyle=r.collision,t.lineWidth=
Math.max(1.5,e.cell*.085*Math.sqrt(a)),t.stroke(),t.globalAlpha=1}var co=.8,ho=.92,mo=15,fo=7,it=9;function Dr(t,e,r,n,o,a){n.forEach((s,i)=>{s.alpha>0&&po(t,e,r,i,s,o,a)}),t.ctx.globalAlpha=1;for(let s of fe(e,r).values())s.length>
it&&yo(t,n[s[it-1]],s.length-it+1)}function po(t,e,r,n,o,a,s){let{ctx:i,grid:l,colors:u}=t,m=D(e,n),[c,f]=[A(l,o.x),T(l,o.y)],d=Math.max(4,l.cell*o.size*(m?ho:co)),
g=X(t,e,n),p=!m&&!!r.captured[n-e.nPursuers];if(i.globalAlpha=o.alpha,(m?Mr:de)(i,c,f,d),d>fo*s&&(i.strokeStyle=u.paper,i.lineWidth=Math.max(2,d*.1),i.stroke()),
i.fillStyle=p?u.paper:g,i.fill(),p&&(de(i,c,f,d*.82),i.strokeStyle=g,i.lineWidth=d*.18,i.stroke()),!a||d<mo*s)return;let b=String(m?n:n-e.nPursuers),C=d*(m?.4:.5)*
(b.length>1?.8:1);_e(t,b,c,f+d*(m?.17:.03),C,p?g:u.paper)}function yo(t,e,r){let{cell:n}=t.grid;_e(t,`+${r}`,A(t.grid,e.x),T(t.grid,e.y),n*.3,t.colors.ink,n*.1)}var go=.46,vo=.86,bo=.66,Wr=.48,wo=.78,xo=.58;function Br(t,e,r,n){let[o,a]=[e.moments[r-1],e.moments[r]];if(!o)return;let{ctx:s,grid:i,colors:l}=t;s.strokeStyle=
l.collision,s.lineWidth=Math.max(1.5,i.cell*.07),s.lineCap="butt",s.globalAlpha=n;for(let u=0;u<a.alive.length;u++)Ce(o,a,u)&&Mo(t,e,w(o,u),Ee(o,a,u));s.globalAlpha=
1}function Mo({ctx:t,grid:e},r,n,o){let[a,s]=[o[1]-n[1],o[0]-n[0]],i=c=>A(e,n[1]+.5+a*c),l=c=>T(e,n[0]+.5+s*c),u=nt(r,o)?wo:xo;t.setLineDash([e.cell*.09,e.cell*
.06]),t.beginPath(),t.moveTo(i(Wr),l(Wr)),t.lineTo(i(u),l(u)),t.stroke(),t.setLineDash([]);let m=.17*e.cell/Math.hypot(a,s);t.beginPath(),t.moveTo(i(u)-s*m,l(u)+
a*m),t.lineTo(i(u)+s*m,l(u)-a*m),t.stroke()}function Gr(t,e,r,n,o,a){let s=rt[a];if(!a||!s)return;let{ctx:i,grid:l,colors:u}=t,m=nt(e,[n[0]+s[0],n[1]+s[1]])?vo:
bo,c=go*o.size,f=[A(l,o.x+s[1]*c),T(l,o.y+s[0]*c),A(l,o.x+s[1]*m),T(l,o.y+s[0]*m)],d=Math.max(1.5,l.cell*.085);i.lineCap=i.lineJoin="round";for(let[g,p]of[[u.paper,
d*2.1],[X(t,e,r),d]])i.strokeStyle=g,i.lineWidth=p,Tr(i,...f,l.cell*.2),i.stroke()}var jr={numbers:!0,axes:!1,trail:6,viewers:[],plan:null,selected:null,cursor:null,you:null,fog:!1};function Vr(t,e,r,n,o){let{ctx:a,grid:s,colors:i}=t,l=Math.min(
Math.ceil(r),e.moments.length-1),u=e.moments[l],m=r===l,c=Re(e,r),f=m?1:Math.max(0,1-2*(l-r));a.clearRect(0,0,a.canvas.width,a.canvas.height),kr(t);for(let p of n.
viewers)c[p]?.alpha&&Lr(t,e,p,...st(e,p,r));Rr(t,e),n.axes&&Or(t,o),$r(t,e,r,n.trail,c),Ur(t,u.contested??[],f),zr(t,e,r),Br(t,e,l,f),c.forEach(({x:p,y:b,size:C},O)=>{
let x=fr(u,O)?.4:0,L=at(u,O)?1:x;L&&Fr(t,p,b,C,L*f)});let d=m?u:e.moments[Math.max(0,l-1)];if(Dr(t,e,d,c,n.numbers,o),m&&n.plan)for(let[p,b]of c.entries())b.alpha&&
Gr(t,e,p,w(u,p),b,n.plan[p]??0);n.you!==null&&(n.fog&&Pr(t,e,...st(e,n.you,r)),Nr(t,c[n.you],o)),a.lineWidth=Math.max(2,2.5*o),a.strokeStyle=i.focus;let g=n.selected===
null?void 0:c[n.selected];g?.alpha&&Hr(t,g.x,g.y,g.size*.96),n.cursor&&(a.setLineDash([s.cell*.12,s.cell*.08]),Hr(t,n.cursor[1]+.5,n.cursor[0]+.5,.8),a.setLineDash(
[]))}function Hr({ctx:t,grid:e},r,n,o){let a=o*e.cell;t.beginPath(),t.roundRect(e.left+r*e.cell-a/2,e.top+n*e.cell-a/2,a,a,a*.1),t.stroke()}var qr=(t,e)=>(e+.24)/(t+.24);function Kr(t,e,r,n,o,a){let s=r?28*a:0,i=(u,m)=>(u-s)/(m+2*.12),l=Math.max(1,Math.floor(Math.min(i(n,e),i(o,t))));return{rows:t,cols:e,
cell:l,left:Math.round((n-e*l+s)/2),top:Math.round((o-t*l+s)/2)}}function Zr(t,e,r){let n=Math.floor((r-t.top)/t.cell),o=Math.floor((e-t.left)/t.cell);return n>=
0&&n<t.rows&&o>=0&&o<t.cols?[n,o]:null}var So=["paper","line","frame","ink","muted","obstacle"],Ao=["pursuer","evader","capture","collision","focus"];function Yr(t){let e=getComputedStyle(t),r=(n,o)=>[
n,e.getPropertyValue(o+n).trim()];return Object.fromEntries([...So.map(n=>r(n,"--board-")),...Ao.map(n=>r(n,"--"))])}var lt=()=>matchMedia("(prefers-reduced-motion: reduce)").matches,Oe=class{canvas;#e=null;#r=0;#n;#t={rows:1,cols:1,left:0,top:0,cell:1};#o=0;constructor(e,r={}){
this.canvas=e,e.classList.add("board"),e.setAttribute("role","img"),this.#n={...jr,...r},new ResizeObserver(()=>this.#s()).observe(e),new MutationObserver(()=>this.
redraw()).observe(document.documentElement,{attributes:!0}),addEventListener("beforeprint",()=>this.drawNow())}set look(e){this.#n={...this.#n,...e},this.#a(),this.
redraw()}show(e,r){this.#e=e,this.#r=Math.min(Math.max(0,r),e.moments.length-1),this.#a(),this.redraw()}redraw(){this.#o||(this.#o=requestAnimationFrame(()=>this.
drawNow()))}drawNow(){cancelAnimationFrame(this.#o),this.#o=0;let e=this.canvas.getContext("2d");if(!e||!this.#e)return;let{rows:r,cols:n}=this.#e,o=devicePixelRatio||
1;this.#t=Kr(r,n,this.#n.axes,this.canvas.width,this.canvas.height,o);let a={ctx:e,grid:this.#t,colors:Yr(this.canvas)};Vr(a,this.#e,this.#r,this.#n,o)}cellAt(e,r){
let n=this.canvas.getBoundingClientRect(),o=this.canvas.width/n.width;return Zr(this.#t,(e-n.left)*o,(r-n.top)*o)}agentAt(e,r){let n=this.cellAt(e,r);if(!n||!this.#e)
return null;let o=this.#e.moments[Math.round(this.#r)],a=fe(this.#e,o).get(n[0]*this.#e.cols+n[1])??[],s=Re(this.#e,Math.round(this.#r)),i=l=>{let[u,m]=this.pointOf(
s[l].x,s[l].y);return Math.hypot(u-e,m-r)};return a.length?a.reduce((l,u)=>i(u)<i(l)?u:l):null}pointOf(e,r){let n=this.canvas.getBoundingClientRect(),o=n.width/
this.canvas.width,{left:a,top:s,cell:i}=this.#t;return[n.left+(a+e*i)*o,n.top+(s+r*i)*o]}#a(){if(!this.#e)return;let{rows:e,cols:r}=this.#e;this.canvas.style.setProperty(
"--board-aspect",String(qr(e,r)))}#s(){let e=devicePixelRatio||1,{width:r,height:n}=this.canvas.getBoundingClientRect();this.canvas.width=Math.max(1,Math.round(
r*e)),this.canvas.height=Math.max(1,Math.round(n*e)),this.drawNow()}};var To=Array.from({length:16},(t,e)=>{let[r,n]=[e%2?6.5:11,Math.PI*e/8];return`${12+r*Math.sin(n)} ${12-r*Math.cos(n)}`}).join(" ");function Xr(){let t=[["pursu\
er",M("path",{d:"M12 3 22 20H2z",class:"filled-pursuer"})],["evader",M("circle",{cx:12,cy:12,r:9,class:"filled-evader"})],["capture",M("polygon",{points:To,class:"\
filled-capture"})],["captured evader",M("circle",{cx:12,cy:12,r:7.5,class:"ring-evader"})],["conflict",M("rect",{x:3,y:3,width:18,height:18,class:"dashed-confli\
ct"})]];return h("ul",{class:"shapes small","aria-label":"Shapes on the board"},...t.map(([e,r])=>h("li",{},M("svg",{viewBox:"0 0 24 24","aria-hidden":"true"},r),
e)))}var Co={first:"M6 5v14M19 5 9 12l10 7z",back:"M17 5 7 12l10 7z",play:"M7 4.5 19 12 7 19.5z",pause:"M8 5v14M16 5v14",forward:"M7 5l10 7-10 7z",last:"M18 5v14M5 5\
l10 7-10 7z"};function Jr(t){return M("svg",{viewBox:"0 0 24 24","aria-hidden":"true",class:"icon"},M("path",{d:Co[t]}))}function pe(t,e,r,n){return h("button",
{type:"button",class:"player-button","aria-label":e,title:`${e} (${r})`,onclick:n},Jr(t))}function Qr(t){let e=pe("play","Play","Space",()=>t.toggle()),r=h("inp\
ut",{type:"range",class:"player-scrub",min:0,step:1,"aria-label":"Step",oninput:()=>{t.pause(),t.jump(Number(r.value))}}),n=h("div",{class:"captures","aria-hidd\
en":"true",title:"Captures"}),o=h("div",{class:"losses","aria-hidden":"true"}),a=h("select",{class:"player-speed","aria-label":"Speed",title:`Steps a second, or\
 the whole in ${we} s (+ and -)`,onchange:()=>t.speed=Number(a.value)},h("option",{value:be},`in ${we} s`),...re.map(c=>h("option",{value:c},`${c} / s`))),s=h("\
output",{class:"player-count"}),i=h("div",{class:"player",role:"group","aria-label":"Player"},pe("first","First step","Home",()=>t.move(-t.length)),pe("back","S\
tep back","←",()=>t.move(-1)),e,pe("forward","Step forward","→",()=>t.move(1)),pe("last","Last step","End",()=>t.move(t.length)),h("div",{class:"scrub"},n,o,
r),s,a),l=(c,f={})=>{let d=h("i",f);return d.style.left=`${100*c/Math.max(1,t.length)}%`,d},u=()=>{n.replaceChildren(...t.marks.map(c=>l(c))),o.replaceChildren(
...t.ticks.map(({step:c,kind:f,size:d,text:g})=>{let p=l(c,{class:f,title:`Step ${c}: ${g}`});return p.style.height=`${100*d}%`,p}))},m=()=>{e.replaceChildren(Jr(
t.playing?"pause":"play")),e.ariaLabel=t.playing?"Pause":"Play",e.title=`${e.ariaLabel} (Space)`,r.max=String(t.length),r.value=String(t.step),r.ariaValueText=`\
step ${t.step} of ${t.length}`,s.textContent=`${t.step} / ${t.length}`,s.style.minWidth=`${2*String(t.length).length+3}ch`,a.value=String(t.speed)};return t.addEventListener(
"step",m),t.addEventListener("state",m),t.addEventListener("state",u),i.addEventListener("keydown",c=>{!(c.target instanceof HTMLSelectElement||c.key===" "&&c.target!==
r)&&xe(t,c)&&c.preventDefault()}),m(),i}function en(t,e,r){if(r===0)return[{kind:"start",text:Eo(t),agents:[]}];let[n,o]=[e.moments[r-1],e.moments[r]],a=m=>H(m,t.config.n_pursuers),s=me(e,n,o),i=t.conflicts(
r),l=new Set(i.flatMap(m=>m.doomed)),u=s.map(m=>({kind:"capture",text:`${a(m)} is captured`,agents:[m]}));for(let m of ke(n,o))!s.includes(m)&&!l.has(m)&&u.push(
{kind:"end",text:`${a(m)} disappears`,agents:[m]});return u.push(...i.map(({kind:m,text:c,agents:f})=>({kind:m,text:c,agents:f}))),r===t.length&&u.unshift({kind:"\
end",text:ko(t),agents:[]}),u}function Eo({config:t}){return`${t.n_pursuers} pursuers and ${t.n_evaders} evaders on ${t.rows} x ${t.cols} cells, at most ${t.max_steps}\
 steps`}function ko(t){let e=Math.round(t.statistics.capture_rate*t.config.n_evaders);return`The episode ends after ${t.length} steps with ${e} of ${t.config.n_evaders}\
 evaders captured`}function tn(t,e,r){let{rows:n,cols:o,n_pursuers:a,fov:s,rules:{interaction:i}}=t;return{rows:n,cols:o,nPursuers:a,fov:s,interaction:i,obstacles:e,moments:r}}function ut(t,e){
return{positions:t.read("last_positions"),alive:t.read("alive"),captured:t.read("captured"),everCaptured:t.read("ever_captured"),actions:e,involved:t.read("invo\
lved"),fault:t.read("fault"),contested:t.conflicts().map(r=>r.cell)}}var ct=class{config;start;recording;actions=[];#e;#r;#n=[[]];constructor(e,r,n){[this.config,this.start]=[r,n],this.#e=e.world(r),this.#e.reset(n),this.#r=[ut(this.#e)],
this.recording=tn(r,this.#e.map(),this.#r)}get length(){return this.actions.length}get over(){return this.#e.over}get statistics(){return{capture_rate:this.#e.read(
"capture_rate")[0]}}conflicts(e){return this.#n[e]}game(e){return e.game(this.#e)}play(e){this.#e.step(e),this.#t(e)}step(e,r,n){let[o,a]=[this.#e,this.config.n_pursuers],
s=new Uint8Array(o.n_agents);for(let i=o.n_turns;i>0&&!o.over;--i){let[l,u]=o.actors;l<a&&(s=o.decide(e.pursuer,[l,Math.min(u,a)],s)),u>a&&(s=o.decide(e.evader,
[Math.max(l,a),u],s)),typeof n=="number"?s[r]=n:l<=r&&r<u&&(s=o.decide(n,[r,r+1],s)),o.playTurn(s)}this.#t(s)}#t(e){this.actions.push(e),this.#r.push(ut(this.#e,
e)),this.#n.push(this.#e.conflicts())}};function rn(t,e,r,n){let o=new ct(t,e,r);for(let a of n)o.play(a);return o}var Ie=class{#e;#r;#n=new Map;#t=null;constructor(e){this.#e=e,this.#r=e.world.n_pursuers+e.world.n_evaders;let r=0;e.steps.forEach((n,o)=>n.forEach((a,s)=>{a<0||
(this.#n.set(o*n.length+s,r),r+=a*this.#r)}))}has({pursuer:e,evader:r}){return this.#e.steps[e][r]>=0}actions({pursuer:e,evader:r}){this.#t??=cr(hr("recordings"));
let n=this.#n.get(e*this.#e.names.evader.length+r);return Array.from({length:this.#e.steps[e][r]},(o,a)=>this.#t.slice(n+a*this.#r,n+(a+1)*this.#r))}play(e,r){return rn(
e,this.#e.world,{seed:BigInt(this.#e.match_seed)},this.actions(r))}};var Pe=class{element;player=new ve(0,{speed:be,still:lt()});replay=null;#e;#r;#n;#t;#o=h("h2",{class:"match-title"});#a=h("p",{class:"tally numbers"});#s=h("ol",
{class:"words","aria-live":"off","aria-label":"What happened in this step"});#l=h("p",{class:"check small","aria-live":"polite"});#u=null;constructor(e,r){[this.#e,
this.#r,this.#n]=[e,r,new Ie(e)];let n=h("canvas",{"aria-label":"The match"});this.#t=new Oe(n,{numbers:!1}),this.element=h("section",{class:"card match-card","\
aria-label":"Match",id:"match"},h("header",{class:"match-head"},this.#o,this.#a),h("div",{class:"stage"},n),Qr(this.player),this.#l,Xr(),this.#s),this.player.addEventListener(
"frame",()=>this.replay&&this.#t.show(this.replay.recording,this.player.time)),this.player.addEventListener("step",()=>this.#d()),r.on("pair",()=>this.#c()),r.on(
"play",()=>this.#h()),this.#f()}start(e){this.#u=e,this.#c()}#h(){this.replay&&(this.player.jump(0),lt()||this.player.play(),this.element.scrollIntoView({block:"\
nearest"}))}#c(){this.player.pause(),this.#f();let{pair:e}=this.#r;this.#u&&(this.replay=this.#n.has(e)?this.#n.play(this.#u,e):null,this.element.dataset.played=
this.replay?`${e.pursuer} ${e.evader}`:"",this.element.classList.toggle("without-recording",!this.replay),this.player.length=this.replay?.length??0,this.player.
marks=this.replay?dr(this.replay.recording):[],this.player.jump(0),this.#m(),this.#d())}#m(){let{pursuer:e,evader:r}=this.#r.pair;if(!this.replay){this.#l.textContent=
"The page holds no recording of this match: it would be too large.";return}let[n,o]=[this.replay.statistics.capture_rate,this.#e.first[e][r]],a=Math.abs(n-o)<.001;
this.#l.dataset.equal=String(a),this.#l.textContent=a?`Episode 1 of ${this.#e.episodes}: capture rate ${S(n)}, as in the tournament.`:`Episode 1 of ${this.#e.episodes}\
: capture rate ${S(n)}; the tournament had ${S(o)}.`}#f(){let{pursuer:e,evader:r}=this.#r.pair;this.#o.replaceChildren(h("span",{class:"pursuer"},this.#e.names.
pursuer[e])," against ",h("span",{class:"evader"},this.#e.names.evader[r]))}#d(){if(!this.replay){this.#s.replaceChildren(),this.#a.replaceChildren();return}let{
recording:e}=this.replay,r=this.player.step,n=Array.from(e.moments[r].everCaptured).filter(Boolean).length;this.#a.replaceChildren(h("strong",{},n),` of ${this.#e.
world.n_evaders} captured`,h("span",{class:"muted"},` · step ${r}`)),this.#s.replaceChildren(...en(this.replay,e,r).map(o=>h("li",{class:o.kind},o.text)))}};var ye=[[68,1,84],[72,26,108],[71,47,125],[65,68,135],[57,86,140],[49,104,142],[42,120,142],[35,136,142],[31,152,139],[34,168,132],[53,183,121],[84,197,104],[122,
209,81],[165,219,54],[210,226,27],[253,231,37]];function ht(t){let e=Math.min(1,Math.max(0,t))*(ye.length-1),r=Math.min(ye.length-2,Math.floor(e)),[n,o]=[ye[r],
ye[r+1]],a=s=>Math.round(n[s]+(e-r)*(o[s]-n[s]));return[a(0),a(1),a(2)]}function mt(t){let[e,r,n]=ht(t).map(o=>((o/255+.055)/1.055)**2.4);return .2126*e+.7152*r+
.0722*n>.179?"#000":"#fff"}var ft=t=>`rgb(${ht(t).join(" ")})`,nn=()=>`linear-gradient(to right, ${ye.map(t=>`rgb(${t.join(" ")})`).join(", ")})`;function on(t,e){let r=h("span",{class:"gradient"});return r.style.backgroundImage=nn(),h("p",{class:"scale-of-rates small muted"},t,r,e)}var Ro=1e3,_o=14,Oo=12,an=16,sn=t=>t.length>an?`${t.slice(0,an-1)}…`:t,Ne=class{element;#e;#r;#n;#t;#o=h("p",{class:"readout numbers","aria-live":"polite"});#a=M(
"g",{class:"marks"});#s;constructor(e,r){[this.#e,this.#r]=[e,r],this.#n=e.standings.pursuer.map(({number:n})=>n),this.#t=e.standings.evader.map(({number:n})=>n),
this.#s=this.#l(),this.element=h("section",{class:"card matrix-card","aria-label":"All matches"},h("header",{},h("h2",{},"All matches"),h("p",{class:"small mute\
d"},"Capture rate; pursuers in rows, evaders in columns, the best ones first. Click a cell to watch its first episode.")),h("div",{class:"drawing"},this.#s),on(
"0","1"),this.#o),r.on("pair",()=>this.#i()),r.on("hover",()=>this.#i()),this.#i()}#l(){let[e,r]=[this.#n.length,this.#t.length],n=Ro/Math.max(e,r),o=Math.min(26,
Math.max(11,.78*n)),a=Io([...this.#e.names.pursuer,...this.#e.names.evader].map(sn),o)+12,s=r*n+a,i=M("svg",{class:"matrix",tabindex:"0",role:"img","aria-label":"\
Matrix of capture rates; arrow keys choose a match, Enter plays it",preserveAspectRatio:"xMidYMin meet",viewBox:`${-a} ${-a} ${s} ${e*n+a}`,onpointermove:u=>this.#r.
point(this.#m(u,n)),onpointerleave:()=>this.#r.point(null),onclick:u=>{let m=this.#m(u,n);m&&this.#r.play(m)},onkeydown:u=>this.#f(u)}),l=this.#n.flatMap((u,m)=>this.#t.
map((c,f)=>{let d=this.#e.capture_rate[u][c];return M("rect",{x:f*n,y:m*n,width:n,height:n,fill:ft(d),"data-pair":`${u} ${c}`})}));return i.append(...l,...this.#u(
n),...this.#h("pursuer",n,o),...this.#h("evader",n,o),this.#a),this.#a.dataset.size=String(n),i.style.minWidth=`${Oo/o*s}px`,i}#u(e){return Math.max(this.#n.length,
this.#t.length)>_o?[]:this.#n.flatMap((r,n)=>this.#t.map((o,a)=>{let s=this.#e.capture_rate[r][o];return M("text",{x:(a+.5)*e,y:(n+.5)*e,fill:mt(s),"font-size":Math.
min(30,.38*e),class:"in-cell"},S(s))}))}#h(e,r,n){return(e==="pursuer"?this.#n:this.#t).map((a,s)=>{let i=(s+.5)*r,l=e==="pursuer"?{x:-6,y:i,"text-anchor":"end"}:
{transform:`translate(${i} -6) rotate(-90)`,"text-anchor":"start"};return M("text",{...l,class:`name ${this.#c(e,a).kind}`,"font-size":n,"data-name":`${e} ${a}`},
sn(this.#e.names[e][a]))})}#c(e,r){return this.#e.standings[e].find(n=>n.number===r)}#m(e,r){let n=new DOMPoint(e.clientX,e.clientY).matrixTransform(this.#s.getScreenCTM().
inverse()),[o,a]=[this.#n[Math.floor(n.y/r)],this.#t[Math.floor(n.x/r)]];return o===void 0||a===void 0||n.x<0||n.y<0?null:{pursuer:o,evader:a}}#f(e){let n={ArrowUp:[
-1,0],ArrowDown:[1,0],ArrowLeft:[0,-1],ArrowRight:[0,1]}[e.key];if(e.key==="Enter")this.#r.play(this.#r.pair);else if(n)this.#d(n);else return;e.preventDefault(),
e.stopPropagation()}#d([e,r]){let{pursuer:n,evader:o}=this.#r.pair,a=this.#n[this.#n.indexOf(n)+e],s=this.#t[this.#t.indexOf(o)+r];a!==void 0&&s!==void 0&&this.#r.
select({pursuer:a,evader:s})}#i(){let{pair:e,hover:r}=this.#r,n=Number(this.#a.dataset.size),o=({pursuer:s,evader:i},l)=>M("rect",{class:l,x:this.#t.indexOf(i)*
n,y:this.#n.indexOf(s)*n,width:n,height:n});this.#a.replaceChildren(o(e,"selected-halo"),o(e,"selected"),...r?[o(r,"hovered")]:[]);let a=r??e;for(let s of this.#s.
querySelectorAll("[data-name]")){let i=[`pursuer ${a.pursuer}`,`evader ${a.evader}`].includes(s.dataset.name);s.classList.toggle("about",i)}this.#o.replaceChildren(
...this.#p(a))}#p({pursuer:e,evader:r}){let{names:n,capture_rate:o,lowest:a,highest:s,length:i,episodes:l}=this.#e,u=S(o[e][r]),[m,c]=[S(a[e][r]),S(s[e][r])];return[
h("span",{},h("span",{class:"pursuer"},n.pursuer[e])," against ",h("span",{class:"evader"},n.evader[r])),h("span",{},h("strong",{},u),h("span",{class:"small mut\
ed"},` captured; ${m} to ${c} in ${l} episodes, ${i[e][r].toFixed(0)} steps on average`))]}};function Io(t,e){let r=document.createElement("canvas").getContext(
"2d");return r.font=`700 ${e}px ${getComputedStyle(document.body).fontFamily}`,Math.max(...t.map(n=>r.measureText(n).width))}var ln=(t,e)=>t?.pursuer===e?.pursuer&&t?.evader===e?.evader,Le=class extends EventTarget{#e;#r=null;constructor(e){super(),this.#e=e}get pair(){return this.#e}get hover(){
return this.#r}select(e){ln(e,this.#e)||(this.#e=e,this.dispatchEvent(new Event("pair")))}play(e){this.select(e),this.dispatchEvent(new Event("play"))}point(e){
ln(e,this.#r)||(this.#r=e,this.dispatchEvent(new Event("hover")))}on(e,r){this.addEventListener(e,r)}};var un={pursuer:"evader",evader:"pursuer"};function dt(t,e,r){let n=t.standings[e].map(s=>Po(t,e,s,r)),o=e==="pursuer"?"Mean capture rate":"Mean escape rate",a=[
"Rank","Name","Score","Best, worst"];return h("section",{class:"card standings","aria-label":`Standings of ${e}s`},h("header",{},h("h2",{},h("span",{class:e},`${e[0].
toUpperCase()}${e.slice(1)}s`)),h("p",{class:"small muted"},`${o} against ${t.names[un[e]].length} opponents, with 95 % interval`)),h("div",{class:"scroll",tabindex:"\
0"},h("table",{},h("thead",{},h("tr",{},...a.map(s=>h("th",{scope:"col"},s)))),h("tbody",{},...n))))}function Po(t,e,r,n){let{kind:o,name:a,file:s,rank:i,number:l}=r,
u=h("tr",{class:o,"data-number":l},h("td",{class:"rank numbers"},i||"–"),h("th",{scope:"row",title:s},h("span",{class:"who",title:a},a),h("span",{class:"kind \
small muted"},o)),h("td",{class:"numbers score"},Lo(r,e),No(r)),h("td",{class:"matches"},...["best","worst"].map(c=>$o(t,e,r,c,n)))),m=()=>{u.classList.toggle("\
about",l===(n.hover??n.pair)[e])};return n.on("pair",m),n.on("hover",m),m(),u}function No({score:t,low:e,high:r}){let n=e===null||r===null?"":`${S(e)} – ${S(r)}`;
return h("span",{class:"score-text"},h("strong",{},S(t)),h("span",{class:"small muted"},n))}function Lo({score:t,low:e,high:r},n){let[o,a]=[h("span",{class:`fil\
led of-${n}`}),h("span",{class:"whisker"})];return o.style.width=`${100*t}%`,e!==null&&r!==null&&(a.style.left=`${100*e}%`,a.style.width=`${100*(r-e)}%`),h("spa\
n",{class:"bar","aria-hidden":"true"},o,a)}function $o(t,e,r,n,o){let a=r[n],s=e==="pursuer"?{pursuer:r.number,evader:a}:{pursuer:a,evader:r.number},i=t.names[un[e]][a],
l=t.capture_rate[s.pursuer][s.evader],u=S(e==="pursuer"?l:1-l);return h("button",{type:"button",class:"to-match",title:`Watch the ${n} match: against ${i}, ${u}`,
"aria-label":`Watch the ${n} match of ${r.name}: against ${i}, ${u}`,onclick:()=>o.play(s)},n==="best"?"▲ ":"▼ ",i)}function cn({votes:t}){let e=Object.keys(
t);if(!e.length)return[];let r=e.map(n=>{let o=Object.entries(t[n]),a=o.reduce((i,[,l])=>i+l,0),s=o.map(([i,l])=>{let u=h("span",{class:"filled"});return u.style.
width=`${100*l/a}%`,h("div",{class:"vote"},h("span",{},i),h("span",{class:"bar","aria-hidden":"true"},u),h("span",{class:"numbers"},`${l} of ${a}`))});return h(
"tr",{},h("th",{scope:"row"},n),h("td",{},...s))});return[h("section",{class:"card votes","aria-label":"Predictions"},h("header",{},h("h2",{},"How the class vot\
ed"),h("p",{class:"small muted"},"Predictions of the course: the first choice of each student, before the experiment.")),h("table",{},h("tbody",{},...r)))]}function hn(t){
if(!t.length)return[];let e=t.map(({file:r,reason:n})=>h("div",{class:"refusal"},h("dt",{},r),h("dd",{},n)));return[h("section",{class:"card refused","aria-labe\
l":"Refused"},h("header",{},h("h2",{},`Refused (${t.length})`),h("p",{class:"small muted"},"These did not play, or broke a rule while they played; their matches\
 count for no one.")),h("dl",{},...e))]}var I=mr(),[zo]=I.standings.pursuer,$e=new Le({pursuer:zo.number,evader:I.standings.evader[0].number}),J=new Pe(I,$e);function Uo({world:t,episodes:e,seed:r,matrixworld:n}){
return`${t.n_pursuers} pursuers and ${t.n_evaders} evaders on ${t.rows} x ${t.cols} cells, at most ${t.max_steps} steps · ${e} episodes a pair · seed ${r} · m\
atrixworld ${n}`}var Fo=["Every pursuer played every evader from the same starts. A score is a mean over all opponents, scripts included. Scripts are the packag\
e's own policies, for comparison; they have no rank.","A rank such as 2 to 5 means that these episodes cannot tell which of these ranks is the true one: the dif\
ference to some others is within chance. Each range misses the true rank with a probability of at most 5 %.","Keys: Space plays, ← and → step, D changes light a\
nd dark; in the matrix arrow keys choose a match and Enter plays it."];document.getElementById("page").replaceWith(rr(I.title,Uo(I)),h("main",{class:"stages"},h(
"div",{class:"tables"},dt(I,"pursuer",$e),dt(I,"evader",$e)),new Ne(I,$e).element,J.element),...cn(I),...hn(I.refusals),h("section",{class:"card reading","aria-\
label":"How to read this page"},h("h2",{},"How to read this page"),...Fo.map(t=>h("p",{},t))));document.addEventListener("keydown",t=>{let e=t.target instanceof
HTMLSelectElement||t.target instanceof HTMLInputElement,r=t.target instanceof HTMLButtonElement&&(t.key===" "||t.key==="Enter");if(!(e||r||t.defaultPrevented||t.
ctrlKey||t.metaKey||t.altKey)){if(t.key.toLowerCase()==="d")Xe();else if(!xe(J.player,t))return;t.preventDefault()}});Object.assign(window,{matrixworldClass:{get replay(){
return J.replay},get step(){return J.player.step}}});requestAnimationFrame(()=>setTimeout(()=>{Jt().then(t=>{J.start(t),document.body.dataset.ready="true"},t=>{
J.element.prepend(h("p",{class:"problem",role:"alert"},`The engine does not start here: ${String(t)}`)),document.body.dataset.ready="true"})}));})();
