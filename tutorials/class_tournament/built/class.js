/* built from web/ by "npm run build"; sources 935dfac1aaac763b3137186728bf53d2313bb373e9627ddd8f84a14c7c4e33be */
(()=>{var oe=[.5,1,2,4,8,16,32,64],we=0,xe=12,kn=2,be=class extends EventTarget{#e;#r;#n;#t=0;#o=0;#s=!1;#a=null;#l=0;#u=[];#h=[];glide=.28;constructor(e,{speed:r=4,still:n=!1}={}){
super(),this.#e=e,this.#r=r,this.#n=n}get step(){return this.#t}get time(){return this.#n?this.#t:this.#o}get arrived(){return this.#o===this.#t}get playing(){return this.#s}get length(){
return this.#e}set length(e){this.#e=e,this.#t>e&&this.jump(e),this.#i("state")}get marks(){return this.#u}set marks(e){this.#u=e,this.#i("state")}get ticks(){return this.#h}set ticks(e){
this.#h=e,this.#i("state")}get pace(){return this.#r||Math.max(kn,this.#e/xe)}get speed(){return this.#r}set speed(e){this.#r=e,this.#i("state")}changeSpeed(e){
let r=oe.findIndex(n=>n>=this.pace);this.speed=oe[Math.min(oe.length-1,Math.max(0,r+e))]}play(){this.#s||!this.#e||(this.#t===this.#e&&this.jump(0),this.#s=!0,this.#i(
"state"),this.#m())}pause(){this.#s&&(this.#s=!1,this.#i("state"))}toggle(){this.#s?this.pause():this.play()}move(e){this.pause();let r=Math.min(this.#e,Math.max(
0,this.#t+e));Math.abs(r-this.#o)>1?this.jump(r):this.#c(r),this.#m()}jump(e){this.#o=Math.min(this.#e,Math.max(0,Math.round(e))),this.#c(this.#o),this.#i("fram\
e")}#c(e){e!==this.#t&&(this.#t=e,this.#i("step"),this.#n&&this.#i("frame"))}#m(){this.#a===null&&(this.#l=performance.now(),this.#a=requestAnimationFrame(()=>this.#d()))}#d(){
this.#a=null;let e=performance.now();this.#f(Math.min(.25,(e-this.#l)/1e3)),this.#l=e,(!this.#n||this.arrived)&&this.#i("frame"),(this.#s||this.#o!==this.#t)&&(this.#a=
requestAnimationFrame(()=>this.#d()))}#f(e){let r=e;for(;r>0;){if(this.#o===this.#t){if(!this.#s)return;if(this.#t===this.#e)return this.pause();this.#c(this.#t+
1)}let n=this.#s?this.pace:1/this.glide,o=this.#t-this.#o,s=Math.min(Math.abs(o),r*n);r-=s/n,this.#o=s===Math.abs(o)?this.#t:this.#o+Math.sign(o)*s}this.#s&&this.#o===
this.#e&&this.pause()}#i(e){this.dispatchEvent(new Event(e))}};function Me(t,e){if(e.ctrlKey||e.metaKey||e.altKey)return!1;let r=e.shiftKey?10:1,o={" ":()=>t.toggle(),
ArrowRight:()=>t.move(r),ArrowLeft:()=>t.move(-r),Home:()=>t.move(-t.length),End:()=>t.move(t.length),"+":()=>t.changeSpeed(1),"-":()=>t.changeSpeed(-1)}[e.key];
return o?.(),o!==void 0}var Pt={SIMULTANEOUS:0,SWARM_TURNS:1,AGENT_TURNS:2},se={DISAPPEAR:0,REACH:1,BOUNCE:2},Nt={OCCUPATION:0,SURROUND:1},Lt={FAULT:0,INVOLVED:1};var $t=["obstacle","teammate","adversary"],qe=["vertex","edge","chain"],Ut=["turn","kind","form","first","second","row","col","at_fault","held","doomed"],Ke=["p\
ursuer_{number}","evader_{number}"],zt={obstacle:"{first} ran into the obstacle or border at {cell}",vertex:"{first} and {second} both headed for {cell}",edge:"\
{first} and {second} meant to swap, {first} to {cell}",chain:"{first} headed for {cell}, where {second} had to stay"},ae={"both held":"both bounce","both doomed":"\
both disappear",held:"{agent} bounces",doomed:"{agent} disappears",none:"nobody is stopped"},Dt="{event}: {outcome}",Ze={random:"any action, all equally likely",
still:"always stays",chaser:"moves to where the nearest adversary in view is nearest",fleer:"moves to where the nearest adversary in view is farthest","clumsy-c\
haser":"a chaser that takes any action in half of the steps",hunter:"a chaser of the nearest adversary in view to which no teammate in view is nearer",surrounder:"\
a chaser of the nearest free cell beside an adversary without a teammate","clumsy-fleer":"a fleer that takes any action in half of the steps",dodger:"moves to w\
here all adversaries in view together are farthest","team-surrounder":"shares the free cells beside adversaries with its teammates, and searches","careful-rando\
m":"as random, but takes only moves that right of way allows","careful-chaser":"as chaser, but takes only moves that right of way allows","careful-fleer":"as fl\
eer, but takes only moves that right of way allows","careful-clumsy-chaser":"as clumsy-chaser, but takes only moves that right of way allows","careful-hunter":"\
as hunter, but takes only moves that right of way allows","careful-surrounder":"as surrounder, but takes only moves that right of way allows","careful-clumsy-fl\
eer":"as clumsy-fleer, but takes only moves that right of way allows","careful-dodger":"as dodger, but takes only moves that right of way allows","careful-team-\
surrounder":"as team-surrounder, but takes only moves that right of way allows"},Ft={adversary:"distance to the nearest adversary (0 to 2, in half views)",pressure:"\
sum over adversaries of 1 / (1 + moves)^2 (0 or more)",unclaimed:"distance to the nearest adversary to which no teammate is nearer than the agent is now; withou\
t one, to the nearest adversary (0 to 2, in half views)",open_side:"distance to the nearest cell beside an adversary that holds no obstacle and no teammate (0 t\
o 2, in half views)",teammate:"distance to the nearest teammate (0 to 2, in half views)",exits:"share of the cells around that are no obstacle (0 to 1)",room:"d\
istance to the nearest obstacle to the north, east, south or west (0 to 1, in half views)",must_yield:"1 if right of way forbids the move (0 to 1)",ahead:"1 if \
it is the direction that the agent draws for each 12 steps (0 to 1)",search:"1 if it leads on along the way on which an agent of team-surrounder searches the gr\
id (0 to 1)",escapes:"share of the cells that an evader may be on after its next move which hold no obstacle and which no pursuer in view reaches in one move: o\
f the nearest adversary, or an evader's own (0 to 1)",opposite:"(1 - cosine) / 2 of the angle at the nearest adversary between the agent and the teammate neares\
t to it; for an evader, of the angle at itself between its two nearest adversaries (0 to 1)",parity:"1 if the distance to the nearest adversary is odd (0 to 1)"},
Wt={free:".GS",blocked:"#@OTW"};var q=1+Ut.length;function ie(t,e){return t.replace(/\{(\w+)\}/g,(r,n)=>String(e[n]))}function K(t,e){return t<e?ie(Ke[0],{number:t}):ie(Ke[1],{number:t-e})}function Rn(t,e){
let[r,n,o,s,a,i,l,...c]=Array.from(t),h=a<0?[s]:[s,a],[u,d,f]=c.map(v=>h.filter((C,w)=>v>>w&1)),y=h.map(v=>K(v,e)),p=ie(zt[a<0?"obstacle":qe[o]],{first:y[0],second:y[y.
length-1],cell:`(${i}, ${l})`}),g=ie(Dt,{event:p,outcome:_n(h.length,d,f,e)});return{kind:$t[n],form:qe[o],agents:h,cell:[i,l],at_fault:u,held:d,doomed:f,turn:r,
text:g}}function _n(t,e,r,n){if(t===2&&e.length===2)return ae["both held"];if(t===2&&r.length===2)return ae["both doomed"];let o=s=>a=>ie(ae[s],{agent:K(a,n)});
return[...e.map(o("held")),...r.map(o("doomed"))].join(", ")||ae.none}function Se(t,e){let r=[];for(let n=0;n<t.length;n+=q)r.push(Rn(t.subarray(n+1,n+q),e));return r}var F=class extends Error{name="EngineError"};function x(t,e,r){let n=typeof r=="string"?`'${r}'`:typeof r=="object"?JSON.stringify(r):String(r);return new F(`${t}\
: expected ${e}, got ${n}`)}var Z=class{bytes;constructor(e){this.bytes=e}},Ht=0,Xe=[Uint8Array,Uint8Array,Int32Array,BigInt64Array,BigUint64Array,Float32Array,Float64Array],Bt=4,Gt=4,On=new TextEncoder,
In=new TextDecoder;function Pn(t){for(let e=Xe.length-1;e>Ht;--e)if(t instanceof Xe[e])return e;throw new TypeError("array: expected a typed array of the engine\
's numbers, got another")}function Ye(t){return new Uint8Array(t.buffer,t.byteOffset,t.byteLength)}function Nn(t){return On.encode(`${t}\0`)}var Je=class{engine;addresses=[];constructor(e){
this.engine=e}copy(e){let r=this.engine._malloc(Math.max(e.length,1));if(r===0)throw new F("memory: expected room for the arguments, got none");return this.addresses.
push(r),this.engine.HEAPU8.set(e,r),r}text(e){return this.copy(Nn(e))}arrays(e){let r=Object.entries(e),n=r.flatMap(([s,a])=>{let i=a instanceof Z,l=i?a.bytes:a;
return[this.text(s),i?Ht:Pn(l),l.length,this.copy(Ye(l))]}),o=this.copy(Ye(Int32Array.from(n)));return this.copy(Ye(Int32Array.of(r.length,o)))}free(){for(let e of this.
addresses)this.engine._free(e)}};function jt(t,e){let r=t.HEAPU8;return In.decode(r.subarray(e,r.indexOf(0,e)))}function Y(t){let e=new Int32Array(t.HEAPU8.buffer),
r=t._last_outputs()/Bt,n=e[r+1]/Bt,o={};for(let s=n;s<n+e[r]*Gt;s+=Gt){let a=Xe[e[s+1]],i=e[s+2]*a.BYTES_PER_ELEMENT,l=e[s+3];o[jt(t,e[s])]=new a(t.HEAPU8.slice(
l,l+i).buffer)}return o}function z(t,e){let r=new Je(t);try{let n=e(r);if(n===0)throw new F(jt(t,t._last_error()));return n}finally{r.free()}}var Ln=2**31-1,Vt=["none","gru"],$n=2n**64n-1n,Un=34028234663852886e22;function _(t,e){if(typeof e!="number"||!Number.isInteger(e)||Math.abs(e)>Ln)throw x(t,"an\
 integer",e);return Int32Array.of(e)}function Ae(t,e){if(typeof e!="boolean")throw x(t,"true or false",e);return new Z(Uint8Array.of(Number(e)))}function W(t,e,r){
let n=typeof e=="string"&&Object.hasOwn(r,e)?r[e]:void 0;if(n===void 0)throw x(t,`one of ${Object.keys(r).join(", ")}`,e);return Int32Array.of(n)}function Qe(t,e){
if(typeof e!="number"||!(Math.abs(e)<=Un))throw x(t,"a finite number",e);return e}function le(t,e){let n=typeof e=="bigint"||typeof e=="number"&&Number.isSafeInteger(
e)?BigInt(e):-1n;if(n<0n||n>$n)throw x(t,"an integer from 0 to 2^64 - 1",e);return BigUint64Array.of(n)}function zn(t){return{"rules.interaction":W("interaction",
t.interaction,Pt),"rules.obstacle":W("obstacle",t.obstacle,se),"rules.teammate":W("teammate",t.teammate,se),"rules.evader":W("evader",t.evader,se),"rules.pursue\
r":W("pursuer",t.pursuer,se),"rules.capture":W("capture",t.capture,Nt),"rules.captured_disappear":Ae("captured_disappear",t.captured_disappear)}}function qt(t,e){
let r=typeof e=="number"?[e,e,e]:e;if(!Array.isArray(r)||r.length!==3)throw x(t,"1 or 3 numbers",e);return Float32Array.from(r,n=>Qe(t,n))}function Dn(t){let e=(r,n)=>Float32Array.
of(Qe(r,t[r]),Qe(n,t[n]));return{"rewards.capture":e("pursuer_capture","evader_capture"),"rewards.neighbor":e("pursuer_neighbor","evader_neighbor"),"rewards.ste\
p":e("pursuer_step","evader_step"),"rewards.pursuer_collide":qt("pursuer_collide",t.pursuer_collide),"rewards.evader_collide":qt("evader_collide",t.evader_collide),
"rewards.blame":W("blame",t.blame,Lt),"rewards.capture_repeats":Ae("capture_repeats",t.capture_repeats)}}function Yt(t){if(t===void 0||typeof t=="number")return new Uint8Array(
0);if(t instanceof Uint8Array)return t;let{free:e,blocked:r}=Wt;for(let[n,o]of t.entries()){if(o.length!==t[0]?.length)throw x(`map, row ${n}`,`${t[0]?.length} \
cells as in row 0`,o.length);let s=[...o].find(a=>!e.includes(a)&&!r.includes(a));if(s)throw x(`map, row ${n}`,`'${e}' (free) or '${r}' (obstacle)`,s)}return Uint8Array.
from([...t.join("")],n=>Number(r.includes(n)))}function Xt(t,e){if(!Array.isArray(t))return;let r=[t.length,t[0]?.length??0];if(!(r[0]===e.rows&&r[1]===e.cols))
throw x("obstacle map",`shape (${e.rows}, ${e.cols}), the rows and cols`,r)}function X(t){Xt(t.obstacles,t);let e=typeof t.obstacles=="number"?t.obstacles:0;return{
...zn(t.rules),...Dn(t.rewards),rows:_("rows",t.rows),cols:_("cols",t.cols),n_pursuers:_("n_pursuers",t.n_pursuers),n_evaders:_("n_evaders",t.n_evaders),fov:_("\
fov",t.fov),diagonal:Ae("diagonal",t.diagonal),max_steps:_("max_steps",t.max_steps),density:Float64Array.of(e),map:Yt(t.obstacles)}}function Kt(t,e){return Int32Array.
from((e??[]).flat(),r=>_(t,r)[0])}function Jt(t,e){return Xt(t.obstacles,e),{seed:le("seed",t.seed??0n),episode:le("episode",t.episode??0),pursuers:Kt("pursuers",
t.pursuers),evaders:Kt("evaders",t.evaders),map:Yt(t.obstacles)}}function Te(t){return{actions:Int32Array.from(t,e=>_("actions",e)[0])}}var Zt=Object.keys(Ft);function et(t){
let e=Zt.indexOf(t);if(e<0)throw x("inputs",`names of ${Zt.join(", ")}`,t);return e}function B(t){if(typeof t=="string"){if(!Object.hasOwn(Ze,t))throw x("policy",
`one of ${Object.keys(Ze).join(", ")}`,t);return{script:new TextEncoder().encode(t)}}if(t.kind!=="cells")return{inputs:Int32Array.from(t.inputs,e=>et(e)),hidden:Int32Array.
from(t.kind==="rating"?t.hidden:[],e=>_("hidden",e)[0]),length:_("length",t.kind==="program"?t.length:0),mask:new TextEncoder().encode(t.mask),genome:t.genome};
if(t.activation!=="relu"&&t.activation!=="tanh")throw x("activation","'relu' or 'tanh'",t.activation);if(!Vt.includes(t.memory))throw x("memory",`one of ${Vt.join(
", ")}`,t.memory);return{hidden:Int32Array.from(t.hidden,e=>_("hidden",e)[0]),activation:new TextEncoder().encode(t.activation),sampled:Ae("sampled",t.sampled),
memory:new TextEncoder().encode(t.memory),genome:t.genome}}var Fn=["first_turn","terminated","truncated"];function Qt(t){let e={...t};for(let r of Fn)e[r]=new Z(
t[r]);return e}var er="statistics.",Ce=class{config;seed;episode;n_agents;statistics;first_conflict;constructor(e,r,n,o){this.config=e,this.seed=r,this.episode=n,this.n_agents=
e.n_pursuers+e.n_evaders,this.statistics=Bn(tr(o)),Object.assign(this,o),this.first_conflict=Wn(this.conflict_table,this.length)}get length(){return this.actions.
length/this.n_agents}conflicts(e){this.check(e);let r=this.first_conflict[e],n=this.first_conflict[e+1],o=this.conflict_table.subarray(r*q,n*q);return Se(o,this.
config.n_pursuers)}seek(e,r,n){this.check(r),(!(e.seed===this.seed&&e.episode===BigInt(this.episode))||e.turn!==0||e.steps>r)&&e.reset({seed:this.seed,episode:this.
episode});for(let s=e.steps;s<r;++s){let a=this.actions.subarray(s*this.n_agents,(s+1)*this.n_agents);n?e.replay(a,{pursuer:n.pursuers,evader:n.evaders}):e.step(
a)}}check(e){if(!(Number.isInteger(e)&&e>=0&&e<=this.length))throw x("step",`0 to ${this.length}`,e)}};function Wn(t,e){let r=new Int32Array(e+2);for(let n=0;n<
t.length;n+=q)++r[t[n]+1];for(let n=1;n<r.length;++n)r[n]+=r[n-1];return r}function Bn(t){let e=["capture_rate","ever_capture_rate","captured_fraction","length"];
return Object.fromEntries(Object.entries(t).map(([r,n])=>[r,e.includes(r)?Number(n[0]):n]))}var tr=t=>Object.fromEntries(Object.entries(t).flatMap(([e,r])=>e.startsWith(
er)?[[e.slice(er.length),r]]:[]));function rr(t,e,r,n){let o=[X(r.config),B(r.pursuers),B(r.evaders),n];return z(t,s=>{let[a,i,l,c]=o.map(h=>s.arrays(h));return t[e](
a,i,l,c)}),Y(t)}function nr(t,e,r,n){let o={seed:le("seed",r),episode:le("episode",n)};return new Ce(e.config,r,n,rr(t,"_play_match",e,o))}function or(t,e,r,n){
if(!Number.isInteger(n)||n<1)throw x("n_episodes","at least 1",n);let o=rr(t,"_play_rollout",e,{...r,n_episodes:Int32Array.of(n)});return tr(o)}var Gn=new FinalizationRegistry(([t,e])=>t._states_free(e));var tt=class{value;teams;matrix;n_actions;constructor(e,r){let{matrix:n,rows:o,cols:s,value:a,agents:i}=r,[l,c]=e.actors,h=Array.from(i).filter(d=>l<=d&&d<c),u=d=>d<
e.config.n_pursuers;this.value=a[0],this.matrix=n,this.n_actions=e.n_actions,this.teams=[{agents:h.filter(u),play:o},{agents:h.filter(d=>!u(d)),play:s}]}marginal(e){
let r=this.teams.find(({agents:s})=>s.includes(e));if(!r)return null;let n=this.n_actions**(r.agents.length-1-r.agents.indexOf(e)),o=Array(this.n_actions).fill(
0);return r.play.forEach((s,a)=>o[Math.floor(a/n)%this.n_actions]+=s),o}lost(e){let[r,n]=this.teams.map(({agents:l})=>l.reduce((c,h)=>c*this.n_actions+e[h],0)),
[o,s]=this.teams.map(({play:l})=>l),a=s.reduce((l,c,h)=>l+c*this.matrix[r*s.length+h],0),i=o.reduce((l,c,h)=>l+c*this.matrix[h*s.length+n],0);return[Math.max(0,
this.value-a),Math.max(0,i-this.value)]}},Hn=60,ue=class{config;payoff;engine;states;n_turns;values;constructor(e,r,n){this.engine=e,this.config=r,this.payoff=n,
this.states=z(e,i=>e._states_new(i.arrays(X(r)))),Gn.register(this,[e,this.states]);let o={SIMULTANEOUS:1,SWARM_TURNS:2,AGENT_TURNS:r.n_pursuers+r.n_evaders};this.
n_turns=o[r.rules.interaction];let{payoffs:s}=this.call(()=>e._states_payoffs(this.states)),a=s;this.values=[[n==="capture-rate"?a:a.fill(0)]]}goBack(){let e=this.
values.at(-1)[0],r=[];for(let o=this.n_turns-1;o>=0;o--){let s=r[o+1]??e;r[o]=this.backup(o,{next:s})}this.payoff==="capture-time"&&(r[0]=r[0].map((o,s)=>s===this.
config.n_evaders?0:o-1)),this.values.push(r);let n=this.payoff==="capture-rate"?this.config.max_steps:Math.min(this.config.max_steps,Hn);return this.values.length<=
n&&r[0].some((o,s)=>o!==e[s])}backup(e,r){return this.call(n=>this.engine._states_backup(this.states,e,n.arrays(r))).values}game(e){let r=this.config.max_steps-
e.steps,{turn:n}=e,o=n+1===this.n_turns,s=r>0?this.values[Math.min(r-Number(o),this.values.length-1)]?.[o?0:n+1]:void 0;if(!s)return null;let a=this.call(i=>this.
engine._states_game(this.states,e.address,i.arrays({next:s})));return a.agents.length?new tt(e,a):null}call(e){return z(this.engine,e),Y(this.engine)}};var sr=new FinalizationRegistry(([t,e])=>t._world_free(e)),ce=class{config;n_agents;n_actions;engine;at;freed=!1;constructor(e,r){this.engine=e,this.config=r,this.
n_agents=r.n_pursuers+r.n_evaders,this.n_actions=r.diagonal?9:5,this.at=z(e,n=>e._world_new(n.arrays(X(r)))),sr.register(this,[e,this.at],this)}free(){this.freed||
(this.freed=!0,sr.unregister(this),this.engine._world_free(this.at))}get address(){if(this.freed)throw x("world","one that is in use","one that was freed");return this.
at}reset(e={}){let r=Jt(e,this.config);this.call(n=>this.engine._world_reset(this.address,n.arrays(r)))}step(e){let r=Te(e);this.call(n=>this.engine._world_step(
this.address,n.arrays(r)))}playTurn(e){let r=Te(e);this.call(n=>this.engine._world_play_turn(this.address,n.arrays(r)))}decide(e,r,n){let{n_pursuers:o}=this.config,
s={pursuer:[0,o],evader:[o,this.n_agents]},[a,i]=typeof r=="string"?s[r]:r;if(n.length!==this.n_agents)throw x("actions",String(this.n_agents),n.length);let l=[
B(e),Te(n)],{actions:c}=this.call(h=>this.engine._world_decide(this.address,h.arrays(l[0]),a,i,h.arrays(l[1])));return Uint8Array.from(c)}replay(e,r){let n=s=>typeof s!=
"string"&&s.kind==="cells"&&s.memory!=="none";if(!n(r.pursuer)&&!n(r.evader))return this.step(e);let{n_pursuers:o}=this.config;for(let s=this.n_turns;s>0;--s){let[
a,i]=this.actors;a<o&&this.decide(r.pursuer,[a,Math.min(i,o)],e),i>o&&this.decide(r.evader,[Math.max(a,o),i],e),this.playTurn(e)}}get n_turns(){return this.turnNumbers()[1]}get turn(){
return this.turnNumbers()[0]}get actors(){let[,,e,r]=this.turnNumbers();return[e,r]}turnNumbers(){return this.call(()=>this.engine._world_turn(this.address)).turn}get steps(){
return this.read("steps")[0]}get seed(){return this.read("seed")[0]}get episode(){return this.read("episode")[0]}get over(){return this.read("terminated")[0]===
1||this.read("truncated")[0]===1}read(e){return this.call(r=>this.engine._world_read(this.address,r.text(e)))[e]}view(e){let r=3*this.config.fov**2;return this.
read("views").slice(e*r,(e+1)*r)}map(){return this.read("state").slice(2*this.config.rows*this.config.cols)}conflicts(){return Se(this.conflictTable(),this.config.
n_pursuers)}conflictTable(){return this.call(()=>this.engine._world_conflicts(this.address)).conflict_table}answer(e,r){let n=B(e),{logits:o,memory:s}=this.call(
l=>this.engine._world_logits(this.address,l.arrays(n),r)),a=o,i=this.decide(e,[r,r+1],new Uint8Array(this.n_agents))[r];return{logits:a,probabilities:jn(a),action:i,
memory:s}}rate(e,r){let n=B(e),{ratings:o,refused:s}=this.call(c=>this.engine._world_rate(this.address,c.arrays(n),r)),a=this.read("inputs"),i=a.length/this.n_agents/
this.n_actions,l=c=>Float32Array.from({length:this.n_actions},(h,u)=>a[(r*this.n_actions+u)*i+c]);return{inputs:e.inputs.map(c=>l(et(c))),ratings:o,refused:s}}snapshot(){
return this.call(()=>this.engine._world_snapshot(this.address))}restore(e){let r=Qt(e);this.call(n=>this.engine._world_restore(this.address,n.arrays(r)))}call(e){
return z(this.engine,e),Y(this.engine)}};function jn(t){let e=Math.max(...t),r=Array.from(t,o=>Math.exp(o-e)),n=r.reduce((o,s)=>o+s,0);return Float32Array.from(
r,o=>o/n)}var rt=class{compiled;constructor(e){this.compiled=e}world(e){return new ce(this.compiled,e)}solution(e,r="capture-rate"){return new ue(this.compiled,e,r)}match(e,r,n,o,s=0){
return nr(this.compiled,{config:e,pursuers:r,evaders:n},o,s)}rollouts(e,r,n,o,s){return or(this.compiled,{config:e,pursuers:r,evaders:n},o,s)}},ar;function ir(t=globalThis.
matrixworldEngine){return ar??=Vn(t),ar}async function Vn(t){if(!t)throw new Error("matrixworldEngine: expected the script engine.js before this one, got none");
let e=Uint8Array.from(atob(t.binary),r=>r.charCodeAt(0));return new rt(await t({wasmBinary:e}))}var qn="http://www.w3.org/2000/svg";function m(t,e={},...r){return lr(document.createElement(t),e,r)}function M(t,e={},...r){return lr(document.createElementNS(
qn,t),e,r)}function lr(t,e,r){for(let[o,s]of Object.entries(e))s==null||s===!1||(typeof s=="function"?t.addEventListener(o.slice(2),s):t.setAttribute(o,s===!0?"":
String(s)));let n=r.filter(o=>o!=null&&o!==!1);return t.append(...n.map(o=>typeof o=="number"?String(o):o)),t}var ur=()=>document.documentElement.dataset.theme==="dark";function he(t){document.documentElement.dataset.theme=t?"dark":"light"}var nt=()=>he(!ur());if(typeof document<
"u"){let t=matchMedia("(prefers-color-scheme: dark)");t.addEventListener("change",()=>he(t.matches)),he(t.matches);let e=!1;addEventListener("beforeprint",()=>{
e=ur(),he(!1)}),addEventListener("afterprint",()=>he(e))}function cr(){return m("button",{type:"button",title:"Light or dark (D)","aria-label":"Light or dark",onclick:nt},
"◐")}var hr=(t,e,...r)=>m("header",{class:"top"},m("div",{},m("h1",{},t),e?m("p",{class:"lead"},e):null),m("div",{class:"tools"},...r,cr()));var R=Uint8Array,J=Uint16Array,Kn=Int32Array,mr=new R([0,0,0,0,0,0,0,0,1,1,1,1,2,2,2,2,3,3,3,3,4,4,4,4,5,5,5,5,0,0,0,0]),dr=new R([0,0,0,0,1,1,2,2,3,3,4,4,5,5,6,
6,7,7,8,8,9,9,10,10,11,11,12,12,13,13,0,0]),Zn=new R([16,17,18,0,8,7,9,6,10,5,11,4,12,3,13,2,14,1,15]),fr=function(t,e){for(var r=new J(31),n=0;n<31;++n)r[n]=e+=
1<<t[n-1];for(var o=new Kn(r[30]),n=1;n<30;++n)for(var s=r[n];s<r[n+1];++s)o[s]=s-r[n]<<5|n;return{b:r,r:o}},pr=fr(mr,2),yr=pr.b,Yn=pr.r;yr[28]=258,Yn[258]=28;var gr=fr(
dr,0),Xn=gr.b,Gs=gr.r,at=new J(32768);for(b=0;b<32768;++b)N=(b&43690)>>1|(b&21845)<<1,N=(N&52428)>>2|(N&13107)<<2,N=(N&61680)>>4|(N&3855)<<4,at[b]=((N&65280)>>8|
(N&255)<<8)>>1;var N,b,me=(function(t,e,r){for(var n=t.length,o=0,s=new J(e);o<n;++o)t[o]&&++s[t[o]-1];var a=new J(e);for(o=1;o<e;++o)a[o]=a[o-1]+s[o-1]<<1;var i;
if(r){i=new J(1<<e);var l=15-e;for(o=0;o<n;++o)if(t[o])for(var c=o<<4|t[o],h=e-t[o],u=a[t[o]-1]++<<h,d=u|(1<<h)-1;u<=d;++u)i[at[u]>>l]=c}else for(i=new J(n),o=0;o<
n;++o)t[o]&&(i[o]=at[a[t[o]-1]++]>>15-t[o]);return i}),de=new R(288);for(b=0;b<144;++b)de[b]=8;var b;for(b=144;b<256;++b)de[b]=9;var b;for(b=256;b<280;++b)de[b]=
7;var b;for(b=280;b<288;++b)de[b]=8;var b,vr=new R(32);for(b=0;b<32;++b)vr[b]=5;var b;var Jn=me(de,9,1);var Qn=me(vr,5,1),ot=function(t){for(var e=t[0],r=1;r<t.length;++r)t[r]>e&&(e=t[r]);return e},O=function(t,e,r){var n=e/8|0;return(t[n]|t[n+1]<<8)>>(e&7)&r},st=function(t,e){
var r=e/8|0;return(t[r]|t[r+1]<<8|t[r+2]<<16)>>(e&7)},eo=function(t){return(t+7)/8|0},to=function(t,e,r){return(e==null||e<0)&&(e=0),(r==null||r>t.length)&&(r=t.
length),new R(t.subarray(e,r))};var ro=["unexpected EOF","invalid block type","invalid length/literal","invalid distance","stream finished","no stream handler",,"no callback","invalid UTF-8 da\
ta","extra field too long","date not in range 1980-2099","filename too long","stream finishing","invalid zip data"],I=function(t,e,r){var n=new Error(e||ro[t]);
if(n.code=t,Error.captureStackTrace&&Error.captureStackTrace(n,I),!r)throw n;return n},no=function(t,e,r,n){var o=t.length,s=n?n.length:0;if(!o||e.f&&!e.l)return r||
new R(0);var a=!r,i=a||e.i!=2,l=e.i;a&&(r=new R(o*3));var c=function(_t){var Ot=r.length;if(_t>Ot){var It=new R(Math.max(Ot*2,_t));It.set(r),r=It}},h=e.f||0,u=e.
p||0,d=e.b||0,f=e.l,y=e.d,p=e.m,g=e.n,v=o*8;do{if(!f){h=O(t,u,1);var C=O(t,u+1,3);if(u+=3,C)if(C==1)f=Jn,y=Qn,p=9,g=5;else if(C==2){var Be=O(t,u,31)+257,Mt=O(t,
u+10,15)+4,St=Be+O(t,u+5,31)+1;u+=14;for(var re=new R(St),Ge=new R(19),k=0;k<Mt;++k)Ge[Zn[k]]=O(t,u+k*3,7);u+=Mt*3;for(var At=ot(Ge),Sn=(1<<At)-1,An=me(Ge,At,1),
k=0;k<St;){var Tt=An[O(t,u,Sn)];u+=Tt&15;var w=Tt>>4;if(w<16)re[k++]=w;else{var j=0,ve=0;for(w==16?(ve=3+O(t,u,3),u+=2,j=re[k-1]):w==17?(ve=3+O(t,u,7),u+=3):w==
18&&(ve=11+O(t,u,127),u+=7);ve--;)re[k++]=j}}var Ct=re.subarray(0,Be),U=re.subarray(Be);p=ot(Ct),g=ot(U),f=me(Ct,p,1),y=me(U,g,1)}else I(1);else{var w=eo(u)+4,D=t[w-
4]|t[w-3]<<8,$=w+D;if($>o){l&&I(0);break}i&&c(d+D),r.set(t.subarray(w,$),d),e.b=d+=D,e.p=u=$*8,e.f=h;continue}if(u>v){l&&I(0);break}}i&&c(d+131072);for(var Tn=(1<<
p)-1,Cn=(1<<g)-1,He=u;;He=u){var j=f[st(t,u)&Tn],V=j>>4;if(u+=j&15,u>v){l&&I(0);break}if(j||I(2),V<256)r[d++]=V;else if(V==256){He=u,f=null;break}else{var Et=V-
254;if(V>264){var k=V-257,ne=mr[k];Et=O(t,u,(1<<ne)-1)+yr[k],u+=ne}var je=y[st(t,u)&Cn],Ve=je>>4;je||I(3),u+=je&15;var U=Xn[Ve];if(Ve>3){var ne=dr[Ve];U+=st(t,u)&
(1<<ne)-1,u+=ne}if(u>v){l&&I(0);break}i&&c(d+131072);var kt=d+Et;if(d<U){var Rt=s-U,En=Math.min(U,kt);for(Rt+d<0&&I(3);d<En;++d)r[d]=n[Rt+d]}for(;d<kt;++d)r[d]=
r[d-U]}}e.l=f,e.p=He,e.b=d,e.f=h,f&&(h=1,e.m=p,e.d=y,e.n=g)}while(!h);return d!=r.length&&a?to(r,0,d):r.subarray(0,d)};var oo=new R(0);var so=function(t,e){return((t[0]&15)!=8||t[0]>>4>7||(t[0]<<8|t[1])%31)&&I(6,"invalid zlib data"),(t[1]>>5&1)==+!e&&I(6,"invalid zlib data: "+(t[1]&32?"need":"u\
nexpected")+" dictionary"),(t[1]>>3&4)+2};function br(t,e){return no(t.subarray(so(t,e&&e.dictionary),-4),{i:2},e&&e.out,e&&e.dictionary)}var ao=typeof TextDecoder<"u"&&new TextDecoder,io=0;try{ao.decode(oo,{stream:!0}),io=1}catch{}var it=t=>t==="pursuer"?"evader":"pursuer";function wr(t){let e=atob(lt(t)),r=new Uint8Array(e.length);for(let n=0;n<r.length;n++)r[n]=e.charCodeAt(n);return r}var lt=t=>document.getElementById(t)?.textContent??
"";function xr(){return JSON.parse(lt("data"))}var ut=[[0,0],[-1,0],[0,1],[1,0],[0,-1],[-1,1],[1,1],[1,-1],[-1,-1]];var G=(t,e)=>e<t.nPursuers,S=(t,e)=>[t.positions[2*e],t.positions[2*e+1]],H=({rows:t,cols:e},[r,n])=>r>=0&&n>=0&&r<t&&n<e,ct=(t,e,r=3)=>t!==void 0&&[0,1,2].slice(
0,r).some(n=>t[3*e+n]),ht=(t,e)=>ct(t.fault,e),Mr=(t,e)=>!ht(t,e)&&ct(t.involved,e,2);function Ee(t,e,r){let n=S(t,r),o=S(e,r),s=n[0]!==o[0]||n[1]!==o[1],a=e.involved===
void 0||ct(e.involved,r);return!!(e.alive[r]&&e.actions?.[r]&&!s&&a)}function ke(t,e,r){let[n,o]=S(t,r),[s,a]=ut[e.actions?.[r]??0];return[n+s,o+a]}function fe(t,e,r){
return Array.from({length:r.everCaptured.length},(o,s)=>s).filter(o=>r.everCaptured[o]&&!e.everCaptured[o]).map(o=>t.nPursuers+o)}var Sr=t=>t.moments.flatMap((e,r)=>r&&
fe(t,t.moments[r-1],e).length?[r]:[]);function Re(t,e){return Array.from({length:e.alive.length},(n,o)=>o).filter(n=>t.alive[n]&&!e.alive[n])}var Ar=[-.31,0,.31],Tr=[{size:1,at:[[0,0]]},{size:.62,at:[[-.2,.2],[.2,-.2]]},{size:.54,at:[[-.23,.22],[.23,.22],[0,-.22]]},{size:.54,at:[[-.23,.23],[.23,.23],[
-.23,-.23],[.23,-.23]]},{size:.36,at:Ar.flatMap(t=>Ar.map(e=>[e,t]))}],lo=.3,uo=.35,co=.55;function pe(t,e){let r=new Map;for(let n=0;n<e.alive.length;n++){if(!e.
alive[n])continue;let[o,s]=S(e,n),a=o*t.cols+s,i=r.get(a);i?i.push(n):r.set(a,[n])}return r}function Cr(t,e){let r=Array.from(e.alive,(n,o)=>{let[s,a]=S(e,o);return{
x:a+.5,y:s+.5,size:1,alpha:0}});for(let n of pe(t,e).values()){let o=Tr[Math.min(n.length,Tr.length)-1];n.forEach((s,a)=>{let[i,l]=o.at[Math.min(a,o.at.length-1)],
c=r[s];c.x+=i,c.y+=l,c.size=o.size,c.alpha=1})}return r}var Er=t=>t*t*(3-2*t),Q=(t,e,r)=>t+(e-t)*r,kr=t=>Math.min(1,Math.max(0,t));function Rr(t,e,r,n){let o={SIMULTANEOUS:1,
SWARM_TURNS:2,AGENT_TURNS:r}[t.interaction];if(o===1)return Er(n);let s=o===r?e:+!G(t,e),a=Math.max(1/o,uo);return Er(kr((n-s/(o-1)*(1-a))/a))}function _e(t,e){
let r=t.moments.length-1,n=Math.min(Math.floor(e),r),o=t.moments[n],s=Cr(t,o);if(n===r||e===n)return s;let a=t.moments[n+1],i=Cr(t,a);return s.map((l,c)=>{let h=Rr(
t,c,s.length,e-n);return ho(o,a,c,l,i[c],h)})}function mt(t,e,r){let n=t.moments.length-1,o=Math.min(Math.floor(r),n),s=t.moments[o],a=t.moments[Math.min(o+1,n)],
i=Rr(t,e,s.alive.length,r-o),[l,c]=S(s,e),[h,u]=S(a,e);return[Q(c,u,i)+.5,Q(l,h,i)+.5]}function ho(t,e,r,n,o,s){let a=n.alpha>o.alpha,i={x:Q(n.x,o.x,s),y:Q(n.y,
o.y,s),size:a?n.size:Q(n.size,o.size,s),alpha:a?kr((1-s)/(1-co)):Q(n.alpha,o.alpha,s)};if(Ee(t,e,r)){let[l,c]=S(t,r),[h,u]=ke(t,e,r),d=lo*Math.sin(Math.PI*s);i.
x+=(u-c)*d,i.y+=(h-l)*d}return i}var _r=2*Math.PI;function L(t,e,r,n){t.beginPath(),t.arc(e,r,n/2,0,_r)}function Oe(t,e,r,n){let o=n/2,s=[[0,-.97],[.97,.83],[-.97,.83]].map(([a,i])=>[e+a*o,r+i*
o]);t.beginPath(),t.moveTo((s[2][0]+s[0][0])/2,(s[2][1]+s[0][1])/2),s.forEach(([a,i],l)=>{let[c,h]=s[(l+1)%3];t.arcTo(a,i,c,h,n*.09)}),t.closePath()}function Ie(t,e,r,n){
let o=n*.32;t.beginPath(),t.moveTo(e-o,r-o),t.lineTo(e+o,r+o),t.moveTo(e+o,r-o),t.lineTo(e-o,r+o)}function Or(t,e,r,n){t.beginPath();for(let o=0;o<16;o++){let s=n/
2*(o%2?.6:.95),a=_r*o/16;t.lineTo(e+s*Math.sin(a),r-s*Math.cos(a))}t.closePath()}function Ir(t,e,r,n,o,s){let a=Math.atan2(o-r,n-e);t.beginPath(),t.moveTo(e,r),
t.lineTo(n,o);for(let i of[-1,1])t.moveTo(n,o),t.lineTo(n-s*Math.cos(a+i*.6),o-s*Math.sin(a+i*.6))}var Pr=4,mo=1.6,fo=.95,po=5,yo=.16,go=9,vo=.09,bo=.2,Nr=.75,A=(t,e)=>t.left+e*t.cell,T=(t,e)=>t.top+e*t.cell;function ee(t,e,r){return G(e,r)?t.colors.pursuer:t.
colors.evader}function Pe({ctx:t,colors:e},r,n,o,s,a,i=0){t.font=`700 ${Math.round(s)}px system-ui, sans-serif`,t.textAlign="center",t.textBaseline="middle",t.strokeStyle=
e.paper,t.lineWidth=i,i&&t.strokeText(r,n,o),t.fillStyle=a,t.fillText(r,n,o)}function Lr({ctx:t,grid:e,colors:r}){let{left:n,top:o,cell:s,rows:a,cols:i}=e,l=i*s,
c=a*s;if(t.fillStyle=r.paper,t.fillRect(n,o,l,c),s<po)return;t.fillStyle=r.line;let h=Math.max(1,Math.round(s/60));for(let u=1;u<i;u++)t.fillRect(n+u*s,o,h,c);for(let u=1;u<
a;u++)t.fillRect(n,o+u*s,l,h)}function $r({ctx:t,grid:e,colors:r},n){let{left:o,top:s,cell:a,rows:i,cols:l}=e;t.fillStyle=r.obstacle;for(let c=0;c<i*l;c++){if(!n.
obstacles[c])continue;let h=Math.floor(c/l),u=c%l;t.fillRect(o+u*a,s+h*a,a,a)}Ur({ctx:t,grid:e,colors:r})}function Ur({ctx:t,grid:{left:e,top:r,cell:n,rows:o,cols:s},
colors:a}){let i=Math.min(5,Math.max(2,Math.round(n/18)));t.strokeStyle=a.frame,t.lineWidth=i,t.strokeRect(e-i/2,r-i/2,s*n+i,o*n+i)}function zr({ctx:t,grid:e,colors:r},n){
let{left:o,top:s,cell:a,rows:i,cols:l}=e,c=a<24*n?5:1;t.font=`500 ${Math.round(Math.min(15*n,Math.max(9*n,a*.32)))}px system-ui, sans-serif`,t.fillStyle=r.muted,
t.textBaseline="alphabetic",t.textAlign="center";let h=5*n+a/40;for(let u=0;u<l;u+=c)t.fillText(String(u),o+(u+.5)*a,s-h);t.textAlign="right",t.textBaseline="mi\
ddle";for(let u=0;u<i;u+=c)t.fillText(String(u),o-h,s+(u+.5)*a)}function Dr({grid:t},e,r,n){let o=Math.floor(e.fov/2)+.5,s=Math.max(0,r-o),a=Math.min(t.cols,r+o),
i=Math.max(0,n-o),l=Math.min(t.rows,n+o);return[A(t,s),T(t,i),(a-s)*t.cell,(l-i)*t.cell]}function Fr(t,e,r,n){let{ctx:o,grid:s,colors:a}=t;o.save(),o.beginPath(),
o.rect(0,0,o.canvas.width,o.canvas.height),o.rect(...Dr(t,e,r,n)),o.clip("evenodd"),o.clearRect(0,0,o.canvas.width,o.canvas.height),o.fillStyle=a.line,o.fillRect(
s.left,s.top,s.cols*s.cell,s.rows*s.cell),o.restore(),Ur(t)}function Wr(t,{x:e,y:r,alpha:n},o){let{ctx:s,grid:a,colors:i}=t,l=Math.max(a.cell,16*o)*1.06,c=A(a,e),
h=T(a,r);s.globalAlpha=Math.max(n,.6),s.beginPath(),s.roundRect(c-l/2,h-l/2,l,l,l*.2),s.strokeStyle=i.focus,s.lineWidth=Math.max(2,2.5*o),s.stroke();let u=Math.
max(11*o,Math.min(18*o,a.cell*.5)),d=h-l/2<u*1.2,f=h+(d?1:-1)*(l/2+u*.7);s.lineJoin="round",Pe(t,"You",c,f,u,i.ink,u*.35),s.globalAlpha=1}function Br(t,e,r,n,o){
let{ctx:s,grid:a}=t,i=Dr(t,e,n,o),l=ee(t,e,r);s.globalAlpha=.11,s.fillStyle=l,s.fillRect(...i),s.globalAlpha=.8,s.strokeStyle=l,s.lineWidth=Math.max(1,a.cell/24),
s.strokeRect(...i),s.globalAlpha=1}function Gr(t,e,r,n,o){let{ctx:s,grid:a}=t,i=Math.min(Math.ceil(r),e.moments.length-1),l=e.moments[i];s.lineCap="round",s.lineWidth=
Math.min(go,Math.max(1,a.cell*yo));for(let c=Math.max(1,Math.floor(r-n)+1);c<=i;c++){let h=e.moments[c-1],u=e.moments[c],d=Math.max(0,Math.min(1,(r-c)/n));s.globalAlpha=
Nr+(bo-Nr)*d;for(let f=0;f<u.alive.length;f++){let y=c===i&&r<i;if(!h.alive[f]||!(l.alive[f]||y))continue;let p=(G(e,f)?-1:1)*vo,[g,v]=S(h,f),[C,w]=S(u,f);if(g===
C&&v===w)continue;let D=y?o[f].x:w+.5,$=y?o[f].y:C+.5;s.strokeStyle=ee(t,e,f),s.beginPath(),s.moveTo(A(a,v+.5+p),T(a,g+.5+p)),s.lineTo(A(a,D+p),T(a,$+p)),s.stroke()}}
s.globalAlpha=1}function Hr(t,e,r){let n=Math.min(Math.ceil(r),e.moments.length-1);for(let o=Math.max(1,n-Pr+1);o<=n;o++){let s=e.moments[o-1],a=e.moments[o],i=o>
r?Math.max(0,1-2*(o-r)):1-(r-o)/Pr,l=fe(e,s,a);for(let c of Re(s,a))l.includes(c)||xo(t,S(a,c),i);for(let c of l)wo(t,S(a,c),i)}t.ctx.globalAlpha=1}function wo({
ctx:t,grid:e,colors:r},[n,o],s){t.globalAlpha=s,Or(t,A(e,o+.5),T(e,n+.5),Math.max(8,e.cell*mo)),t.fillStyle=r.capture,t.fill(),t.strokeStyle=r.ink,t.lineWidth=Math.
max(1,e.cell/36),t.lineJoin="round",t.stroke()}function xo({ctx:t,grid:e,colors:r},[n,o],s){t.globalAlpha=s,Ie(t,A(e,o+.5),T(e,n+.5),Math.max(7,e.cell*fo)),t.strokeStyle=
r.collision,t.lineWidth=Math.max(2,e.cell*.17),t.lineCap="round",t.stroke()}function jr({ctx:t,grid:e,colors:r},n,o){let s=Math.max(1,e.cell*.07);t.strokeStyle=
t.fillStyle=r.collision,t.lineWidth=Math.max(1,e.cell*.05),t.setLineDash([e.cell*.14,e.cell*.1]);for(let[a,i]of n){if(a<0||i<0||a>=e.rows||i>=e.cols)continue;let l=[
A(e,i)+s,T(e,a)+s,e.cell-2*s,e.cell-2*s];t.globalAlpha=.2*o,t.fillRect(...l),t.globalAlpha=o,t.strokeRect(...l)}t.setLineDash([]),t.globalAlpha=1}function Vr({ctx:t,
grid:e,colors:r},n,o,s,a){t.globalAlpha=a,L(t,A(e,n),T(e,o),Math.max(8,e.cell*s*1.02)),t.strokeStyle=r.collision,t.lineWidth=Math.max(1.5,e.cell*.085*Math.sqrt(
s)),t.stroke(),t.globalAlpha=1}var Mo=.8,So=.92,Ao=15,To=7,dt=9;function qr(t,e,r,n,o,s){n.forEach((a,i)=>{a.alpha>0&&Co(t,e,r,i,a,o,s)}),t.ctx.globalAlpha=1;for(let a of pe(e,r).values())a.length>
dt&&Eo(t,n[a[dt-1]],a.length-dt+1)}function Co(t,e,r,n,o,s,a){let{ctx:i,grid:l,colors:c}=t,h=G(e,n),u=A(l,o.x),d=T(l,o.y),f=Math.max(4,l.cell*o.size*(h?So:Mo)),
y=ee(t,e,n),p=!h&&!!r.captured[n-e.nPursuers];if(i.globalAlpha=o.alpha,(h?Oe:L)(i,u,d,f),f>To*a&&(i.strokeStyle=c.paper,i.lineWidth=Math.max(2,f*.1),i.stroke()),
i.fillStyle=p?c.paper:y,i.fill(),p&&(L(i,u,d,f*.82),i.strokeStyle=y,i.lineWidth=f*.18,i.stroke()),!s||f<Ao*a)return;let g=String(h?n:n-e.nPursuers),v=f*(h?.4:.5)*
(g.length>1?.8:1);Pe(t,g,u,d+f*(h?.17:.03),v,p?y:c.paper)}function Eo(t,e,r){let{cell:n}=t.grid;Pe(t,`+${r}`,A(t.grid,e.x),T(t.grid,e.y),n*.3,t.colors.ink,n*.1)}var ko=.46,Ro=.86,_o=.66,Kr=.48,Oo=.78,Io=.58;function Zr(t,e,r,n){let o=e.moments[r-1],s=e.moments[r];if(!o)return;let{ctx:a,grid:i,colors:l}=t;a.strokeStyle=l.
collision,a.lineWidth=Math.max(1.5,i.cell*.07),a.lineCap="butt",a.globalAlpha=n;for(let c=0;c<s.alive.length;c++)Ee(o,s,c)&&Po(t,e,S(o,c),ke(o,s,c));a.globalAlpha=
1}function Po({ctx:t,grid:e},r,n,o){let s=o[1]-n[1],a=o[0]-n[0],i=u=>A(e,n[1]+.5+s*u),l=u=>T(e,n[0]+.5+a*u),c=H(r,o)?Oo:Io;t.setLineDash([e.cell*.09,e.cell*.06]),
t.beginPath(),t.moveTo(i(Kr),l(Kr)),t.lineTo(i(c),l(c)),t.stroke(),t.setLineDash([]);let h=.17*e.cell/Math.hypot(s,a);t.beginPath(),t.moveTo(i(c)-a*h,l(c)+s*h),
t.lineTo(i(c)+a*h,l(c)-s*h),t.stroke()}function Yr(t,e,r,n,o,s){let a=ut[s];if(!s||!a)return;let{ctx:i,grid:l,colors:c}=t,h=H(e,[n[0]+a[0],n[1]+a[1]])?Ro:_o,u=ko*
o.size,d=[A(l,o.x+a[1]*u),T(l,o.y+a[0]*u),A(l,o.x+a[1]*h),T(l,o.y+a[0]*h)],f=Math.max(1.5,l.cell*.085);i.lineCap=i.lineJoin="round";for(let[y,p]of[[c.paper,f*2.1],
[ee(t,e,r),f]])i.strokeStyle=y,i.lineWidth=p,Ir(i,...d,l.cell*.2),i.stroke()}var No=.04,Xr=.3,Lo=.36,$o=.13,Jr=.62,Ne=.94;function en(t,e,r){let{ctx:n,grid:o,colors:s}=t,{cell:a}=o,i=p=>A(o,p[1]+.5),l=p=>T(o,p[0]+.5),c=Math.max(1.5,a*.06),
h=p=>H(e,p);n.lineCap="round";for(let[p,g]of[[r.escape,s.evader],[r.held,s.pursuer]]){n.fillStyle=g,n.globalAlpha=.28;let v=a*(1-2*No);for(let C of p.filter(h))
n.fillRect(i(C)-v/2,l(C)-v/2,v,v)}n.globalAlpha=1,n.lineWidth=c,n.fillStyle=n.strokeStyle=s.ink;let{sides:u,openSide:d,wall:f,to:y}=r;if(u){let[p,...g]=u;for(let v of g)
n.beginPath(),n.moveTo(i(p),l(p)),n.lineTo(i(v),l(v)),n.stroke()}if(f){let[p,g]=[Math.sign(f[0]-y[0]),Math.sign(f[1]-y[1])],[v,C]=[i(f)-g*a/2,l(f)-p*a/2],w=.3*a;
n.setLineDash([c,c*2]),n.beginPath(),n.moveTo(i(y),l(y)),n.lineTo(v,C),n.stroke(),n.setLineDash([]),n.beginPath(),n.moveTo(v-p*w,C-g*w),n.lineTo(v+p*w,C+g*w),n.
stroke()}for(let p of r.exits.filter(h)){let[g,v]=[i(p)-i(y),l(p)-l(y)];L(n,i(y)+Jr*g,l(y)+Jr*v,Math.max(3,a*$o)),n.fill()}d&&(Uo(n,i(d),l(d),a*Lo),n.stroke()),
n.setLineDash([a*.12,a*.08]),n.strokeRect(i(y)-a*Ne/2,l(y)-a*Ne/2,a*Ne,a*Ne),n.setLineDash([])}function tn({ctx:t,grid:e,colors:r},n,o){let{cell:s}=e,a=u=>A(e,u[1]+
.5),i=u=>T(e,u[0]+.5),l=Math.max(3,s*.14),c=Math.max(1.5,s*.07),h=u=>{for(let[d,f]of[[r.paper,l],[r.ink,c]])t.strokeStyle=d,t.lineWidth=f,u(),t.stroke()};t.lineCap=
"round";for(let u of o.escape.filter(d=>H(n,d)))h(()=>L(t,a(u),i(u),s*Xr));for(let u of o.held.filter(d=>H(n,d)))h(()=>Ie(t,a(u),i(u),s*Xr*1.4));t.setLineDash([
s*.1,s*.08]);for(let{pursuer:u,cell:d}of o.moved)t.strokeStyle=u?r.pursuer:r.evader,t.lineWidth=c,(u?Oe:L)(t,a(d),i(d),s*.72),t.stroke();t.setLineDash([])}function Uo(t,e,r,n){
t.beginPath(),t.moveTo(e,r-n),t.lineTo(e+n,r),t.lineTo(e,r+n),t.lineTo(e-n,r),t.closePath()}var Qr=t=>["rect",{x:1,y:1,width:22,height:22,class:`tint-${t}`}],Le=t=>[
"path",{d:t,class:"sign"}],ft=(t,e)=>["circle",{cx:12,cy:12,r:t,class:e}],wa={escapes:[["next cell of the evader that no pursuer reaches",Qr("evader"),ft(5,"sig\
n")],["next cell that a pursuer reaches",Qr("pursuer"),Le("M8 8l8 8m0-8l-8 8")]],opposite:[["two sides of the evader",Le("M3 20L12 5l9 15")]],open_side:[["neare\
st free side",Le("M12 3l9 9-9 9-9-9z")]],exits:[["way on",ft(4,"filled-sign")]],room:[["nearest obstacle",Le("M2 12h2m5 0h2m5 0h2M21 4v16")]]},xa=["an agent tha\
t has moved before",ft(8,"dashed-sign")];var nn={numbers:!0,axes:!1,trail:6,viewers:[],plan:null,inputs:null,selected:null,cursor:null,you:null,fog:!1};function on(t,e,r,n,o){let{ctx:s,grid:a,colors:i}=t,
l=Math.min(Math.ceil(r),e.moments.length-1),c=e.moments[l],h=r===l,u=_e(e,r),d=h?1:Math.max(0,1-2*(l-r));s.clearRect(0,0,s.canvas.width,s.canvas.height),Lr(t);for(let g of n.
viewers)u[g]?.alpha&&Br(t,e,g,...mt(e,g,r));$r(t,e),n.axes&&zr(t,o),Gr(t,e,r,n.trail,u);let f=h?n.inputs:null;f&&en(t,e,f),jr(t,c.contested??[],d),Hr(t,e,r),Zr(
t,e,l,d),u.forEach(({x:g,y:v,size:C},w)=>{let D=Mr(c,w)?.4:0,$=ht(c,w)?1:D;$&&Vr(t,g,v,C,$*d)});let y=h?c:e.moments[Math.max(0,l-1)];if(qr(t,e,y,u,n.numbers,o),
f&&tn(t,e,f),h&&n.plan)for(let[g,v]of u.entries())v.alpha&&Yr(t,e,g,S(c,g),v,n.plan[g]??0);n.you!==null&&(n.fog&&Fr(t,e,...mt(e,n.you,r)),Wr(t,u[n.you],o)),s.lineWidth=
Math.max(2,2.5*o),s.strokeStyle=i.focus;let p=n.selected===null?void 0:u[n.selected];p?.alpha&&rn(t,p.x,p.y,p.size*.96),n.cursor&&(s.setLineDash([a.cell*.12,a.cell*
.08]),rn(t,n.cursor[1]+.5,n.cursor[0]+.5,.8),s.setLineDash([]))}function rn({ctx:t,grid:e},r,n,o){let s=o*e.cell;t.beginPath(),t.roundRect(e.left+r*e.cell-s/2,e.
top+n*e.cell-s/2,s,s,s*.1),t.stroke()}var sn=(t,e)=>(e+.24)/(t+.24);function an(t,e,r,n,o,s){let a=r?28*s:0,i=(c,h)=>(c-a)/(h+2*.12),l=Math.max(1,Math.floor(Math.min(i(n,e),i(o,t))));return{rows:t,cols:e,
cell:l,left:Math.round((n-e*l+a)/2),top:Math.round((o-t*l+a)/2)}}function ln(t,e,r){let n=Math.floor((r-t.top)/t.cell),o=Math.floor((e-t.left)/t.cell);return n>=
0&&n<t.rows&&o>=0&&o<t.cols?[n,o]:null}var zo=["paper","line","frame","ink","muted","obstacle"],Do=["pursuer","evader","capture","collision","focus"];function un(t){let e=getComputedStyle(t),r=(n,o)=>[
n,e.getPropertyValue(o+n).trim()];return Object.fromEntries([...zo.map(n=>r(n,"--board-")),...Do.map(n=>r(n,"--"))])}var pt=()=>matchMedia("(prefers-reduced-motion: reduce)").matches,$e=class{canvas;#e=null;#r=0;#n;#t={rows:1,cols:1,left:0,top:0,cell:1};#o=0;constructor(e,r={}){
this.canvas=e,e.classList.add("board"),e.setAttribute("role","img"),this.#n={...nn,...r},new ResizeObserver(()=>this.#a()).observe(e),new MutationObserver(()=>this.
redraw()).observe(document.documentElement,{attributes:!0}),addEventListener("beforeprint",()=>this.drawNow())}set look(e){this.#n={...this.#n,...e},this.#s(),this.
redraw()}show(e,r){this.#e=e,this.#r=Math.min(Math.max(0,r),e.moments.length-1),this.#s(),this.redraw()}redraw(){this.#o||(this.#o=requestAnimationFrame(()=>this.
drawNow()))}drawNow(){cancelAnimationFrame(this.#o),this.#o=0;let e=this.canvas.getContext("2d");if(!e||!this.#e)return;let{rows:r,cols:n}=this.#e,o=devicePixelRatio||
1;this.#t=an(r,n,this.#n.axes,this.canvas.width,this.canvas.height,o);let s={ctx:e,grid:this.#t,colors:un(this.canvas)};on(s,this.#e,this.#r,this.#n,o)}cellAt(e,r){
let n=this.canvas.getBoundingClientRect(),o=this.canvas.width/n.width;return ln(this.#t,(e-n.left)*o,(r-n.top)*o)}agentAt(e,r){let n=this.cellAt(e,r);if(!n||!this.#e)
return null;let o=this.#e.moments[Math.round(this.#r)],s=pe(this.#e,o).get(n[0]*this.#e.cols+n[1])??[],a=_e(this.#e,Math.round(this.#r)),i=l=>{let[c,h]=this.pointOf(
a[l].x,a[l].y);return Math.hypot(c-e,h-r)};return s.length?s.reduce((l,c)=>i(c)<i(l)?c:l):null}pointOf(e,r){let n=this.canvas.getBoundingClientRect(),o=n.width/
this.canvas.width,{left:s,top:a,cell:i}=this.#t;return[n.left+(s+e*i)*o,n.top+(a+r*i)*o]}#s(){if(!this.#e)return;let{rows:e,cols:r}=this.#e;this.canvas.style.setProperty(
"--board-aspect",String(sn(e,r)))}#a(){let e=devicePixelRatio||1,{width:r,height:n}=this.canvas.getBoundingClientRect();this.canvas.width=Math.max(1,Math.round(
r*e)),this.canvas.height=Math.max(1,Math.round(n*e)),this.drawNow()}};var Fo=Array.from({length:16},(t,e)=>{let r=e%2?6.5:11,n=Math.PI*e/8;return`${12+r*Math.sin(n)} ${12-r*Math.cos(n)}`}).join(" ");function cn(){let t=[["pursuer",
M("path",{d:"M12 3 22 20H2z",class:"filled-pursuer"})],["evader",M("circle",{cx:12,cy:12,r:9,class:"filled-evader"})],["capture",M("polygon",{points:Fo,class:"f\
illed-capture"})],["captured evader",M("circle",{cx:12,cy:12,r:7.5,class:"ring-evader"})],["conflict",M("rect",{x:3,y:3,width:18,height:18,class:"dashed-conflic\
t"})]];return m("ul",{class:"shapes small","aria-label":"Shapes on the board"},...t.map(([e,r])=>m("li",{},M("svg",{viewBox:"0 0 24 24","aria-hidden":"true"},r),
e)))}var Wo={first:"M6 5v14M19 5 9 12l10 7z",back:"M17 5 7 12l10 7z",play:"M7 4.5 19 12 7 19.5z",pause:"M8 5v14M16 5v14",forward:"M7 5l10 7-10 7z",last:"M18 5v14M5 5\
l10 7-10 7z"};function hn(t){return M("svg",{viewBox:"0 0 24 24","aria-hidden":"true",class:"icon"},M("path",{d:Wo[t]}))}function ye(t,e,r,n){return m("button",
{type:"button",class:"player-button","aria-label":e,title:`${e} (${r})`,onclick:n},hn(t))}function mn(t){let e=ye("play","Play","Space",()=>t.toggle()),r=m("inp\
ut",{type:"range",class:"player-scrub",min:0,step:1,"aria-label":"Step",oninput:()=>{t.pause(),t.jump(Number(r.value))}}),n=m("div",{class:"captures","aria-hidd\
en":"true",title:"Captures"}),o=m("div",{class:"losses","aria-hidden":"true"}),s=m("select",{class:"player-speed","aria-label":"Speed",title:`Steps a second, or\
 the whole in ${xe} s (+ and -)`,onchange:()=>t.speed=Number(s.value)},m("option",{value:we},`in ${xe} s`),...oe.map(u=>m("option",{value:u},`${u} / s`))),a=m("\
output",{class:"player-count"}),i=m("div",{class:"player",role:"group","aria-label":"Player"},ye("first","First step","Home",()=>t.move(-t.length)),ye("back","S\
tep back","←",()=>t.move(-1)),e,ye("forward","Step forward","→",()=>t.move(1)),ye("last","Last step","End",()=>t.move(t.length)),m("div",{class:"scrub"},n,o,
r),a,s),l=(u,d={})=>{let f=m("i",d);return f.style.left=`${100*u/Math.max(1,t.length)}%`,f},c=()=>{n.replaceChildren(...t.marks.map(u=>l(u))),o.replaceChildren(
...t.ticks.map(({step:u,kind:d,size:f,text:y})=>{let p=l(u,{class:d,title:`Step ${u}: ${y}`});return p.style.height=`${100*f}%`,p}))},h=()=>{e.replaceChildren(hn(
t.playing?"pause":"play")),e.ariaLabel=t.playing?"Pause":"Play",e.title=`${e.ariaLabel} (Space)`,r.max=String(t.length),r.value=String(t.step),r.ariaValueText=`\
step ${t.step} of ${t.length}`,a.textContent=`${t.step} / ${t.length}`,a.style.minWidth=`${2*String(t.length).length+3}ch`,s.value=String(t.speed)};return t.addEventListener(
"step",h),t.addEventListener("state",h),t.addEventListener("state",c),i.addEventListener("keydown",u=>{!(u.target instanceof HTMLSelectElement||u.key===" "&&u.target!==
r)&&Me(t,u)&&u.preventDefault()}),h(),i}var E=(t,e=2)=>t==null?"-":t.toFixed(e);function dn(t,e,r){if(r===0)return[{kind:"start",text:Bo(t),agents:[]}];let n=e.moments[r-1],o=e.moments[r],s=h=>K(h,t.config.n_pursuers),a=fe(e,n,o),i=t.conflicts(
r),l=new Set(i.flatMap(h=>h.doomed)),c=a.map(h=>({kind:"capture",text:`${s(h)} is captured`,agents:[h]}));for(let h of Re(n,o))!a.includes(h)&&!l.has(h)&&c.push(
{kind:"end",text:`${s(h)} disappears`,agents:[h]});return c.push(...i.map(({kind:h,text:u,agents:d})=>({kind:h,text:u,agents:d}))),r===t.length&&c.unshift({kind:"\
end",text:Go(t),agents:[]}),c}function Bo({config:t}){return`${t.n_pursuers} pursuers and ${t.n_evaders} evaders on ${t.rows} x ${t.cols} cells, at most ${t.max_steps}\
 steps`}function Go(t){let e=Math.round(t.statistics.capture_rate*t.config.n_evaders);return`The episode ends after ${t.length} steps with ${e} of ${t.config.n_evaders}\
 evaders captured`}function fn(t,e,r){let{rows:n,cols:o,n_pursuers:s,fov:a,rules:{interaction:i}}=t;return{rows:n,cols:o,nPursuers:s,fov:a,interaction:i,obstacles:e,moments:r}}function yt(t,e){
return{positions:t.read("last_positions"),alive:t.read("alive"),captured:t.read("captured"),everCaptured:t.read("ever_captured"),actions:e,involved:t.read("invo\
lved"),fault:t.read("fault"),contested:t.conflicts().map(r=>r.cell)}}var gt=class{config;start;recording;actions=[];#e;#r;#n=[[]];constructor(e,r,n){this.config=r,this.start=n,this.#e=e.world(r),this.#e.reset(n),this.#r=[yt(this.#e)],
this.recording=fn(r,this.#e.map(),this.#r)}get length(){return this.actions.length}get over(){return this.#e.over}get statistics(){return{capture_rate:this.#e.read(
"capture_rate")[0]}}conflicts(e){return this.#n[e]}game(e){return e.game(this.#e)}play(e){this.#e.step(e),this.#t(e)}step(e,r,n){let o=this.#e,s=this.config.n_pursuers,
a=new Uint8Array(o.n_agents);for(let i=o.n_turns;i>0&&!o.over;--i){let[l,c]=o.actors;l<s&&(a=o.decide(e.pursuer,[l,Math.min(c,s)],a)),c>s&&(a=o.decide(e.evader,
[Math.max(l,s),c],a)),typeof n=="number"?a[r]=n:l<=r&&r<c&&(a=o.decide(n,[r,r+1],a)),o.playTurn(a)}this.#t(a)}#t(e){this.actions.push(e),this.#r.push(yt(this.#e,
e)),this.#n.push(this.#e.conflicts())}};function pn(t,e,r,n){let o=new gt(t,e,r);for(let s of n)o.play(s);return o}var Ue=class{#e;#r;#n=new Map;#t=null;constructor(e){this.#e=e,this.#r=e.world.n_pursuers+e.world.n_evaders;let r=0;e.steps.forEach((n,o)=>n.forEach((s,a)=>{s<0||
(this.#n.set(o*n.length+a,r),r+=s*this.#r)}))}has({pursuer:e,evader:r}){return this.#e.steps[e][r]>=0}actions({pursuer:e,evader:r}){this.#t??=br(wr("recordings"));
let n=this.#n.get(e*this.#e.names.evader.length+r);return Array.from({length:this.#e.steps[e][r]},(o,s)=>this.#t.slice(n+s*this.#r,n+(s+1)*this.#r))}play(e,r){return pn(
e,this.#e.world,{seed:BigInt(this.#e.match_seed)},this.actions(r))}};var ze=class{element;player=new be(0,{speed:we,still:pt()});replay=null;#e;#r;#n;#t;#o=m("h2",{class:"match-title"});#s=m("p",{class:"tally numbers"});#a=m("ol",
{class:"words","aria-live":"off","aria-label":"What happened in this step"});#l=m("p",{class:"check small","aria-live":"polite"});#u=null;constructor(e,r){this.#e=
e,this.#r=r,this.#n=new Ue(e);let n=m("canvas",{"aria-label":"The match"});this.#t=new $e(n,{numbers:!1}),this.element=m("section",{class:"card match-card","ari\
a-label":"Match",id:"match"},m("header",{class:"match-head"},this.#o,this.#s),m("div",{class:"stage"},n),mn(this.player),this.#l,cn(),this.#a),this.player.addEventListener(
"frame",()=>this.replay&&this.#t.show(this.replay.recording,this.player.time)),this.player.addEventListener("step",()=>this.#f()),r.on("pair",()=>this.#c()),r.on(
"play",()=>this.#h()),this.#d()}start(e){this.#u=e,this.#c()}#h(){this.replay&&(this.player.jump(0),pt()||this.player.play(),this.element.scrollIntoView({block:"\
nearest"}))}#c(){this.player.pause(),this.#d();let{pair:e}=this.#r;this.#u&&(this.replay=this.#n.has(e)?this.#n.play(this.#u,e):null,this.element.dataset.played=
this.replay?`${e.pursuer} ${e.evader}`:"",this.element.classList.toggle("without-recording",!this.replay),this.player.length=this.replay?.length??0,this.player.
marks=this.replay?Sr(this.replay.recording):[],this.player.jump(0),this.#m(),this.#f())}#m(){let{pursuer:e,evader:r}=this.#r.pair;if(!this.replay){this.#l.textContent=
"The page holds no recording of this match: it would be too large.";return}let n=this.replay.statistics.capture_rate,o=this.#e.first[e][r],s=Math.abs(n-o)<.001;
this.#l.dataset.equal=String(s),this.#l.textContent=s?`Episode 1 of ${this.#e.episodes}: capture rate ${E(n)}, as in the tournament.`:`Episode 1 of ${this.#e.episodes}\
: capture rate ${E(n)}; the tournament had ${E(o)}.`}#d(){let{pursuer:e,evader:r}=this.#r.pair;this.#o.replaceChildren(m("span",{class:"pursuer"},this.#e.names.
pursuer[e])," against ",m("span",{class:"evader"},this.#e.names.evader[r]))}#f(){if(!this.replay){this.#a.replaceChildren(),this.#s.replaceChildren();return}let{
recording:e}=this.replay,r=this.player.step,n=Array.from(e.moments[r].everCaptured).filter(Boolean).length;this.#s.replaceChildren(m("strong",{},n),` of ${this.#e.
world.n_evaders} captured`,m("span",{class:"muted"},` · step ${r}`)),this.#a.replaceChildren(...dn(this.replay,e,r).map(o=>m("li",{class:o.kind},o.text)))}};var ge=[[68,1,84],[72,26,108],[71,47,125],[65,68,135],[57,86,140],[49,104,142],[42,120,142],[35,136,142],[31,152,139],[34,168,132],[53,183,121],[84,197,104],[122,
209,81],[165,219,54],[210,226,27],[253,231,37]];function vt(t){let e=Math.min(1,Math.max(0,t))*(ge.length-1),r=Math.min(ge.length-2,Math.floor(e)),n=ge[r],o=ge[r+
1],s=a=>Math.round(n[a]+(e-r)*(o[a]-n[a]));return[s(0),s(1),s(2)]}function bt(t){let[e,r,n]=vt(t).map(o=>((o/255+.055)/1.055)**2.4);return .2126*e+.7152*r+.0722*
n>.179?"#000":"#fff"}var wt=t=>`rgb(${vt(t).join(" ")})`,yn=()=>`linear-gradient(to right, ${ge.map(t=>`rgb(${t.join(" ")})`).join(", ")})`;function gn(t,e){let r=m("span",{class:"gradient"});return r.style.backgroundImage=yn(),m("p",{class:"scale-of-rates small muted"},t,r,e)}var Ho=1e3,jo=14,Vo=12,vn=16,bn=t=>t.length>vn?`${t.slice(0,vn-1)}…`:t,De=class{element;#e;#r;#n;#t;#o=m("p",{class:"readout numbers","aria-live":"polite"});#s=M(
"g",{class:"marks"});#a;constructor(e,r){this.#e=e,this.#r=r,this.#n=e.standings.pursuer.map(({number:n})=>n),this.#t=e.standings.evader.map(({number:n})=>n),this.#a=
this.#l(),this.element=m("section",{class:"card matrix-card","aria-label":"All matches"},m("header",{},m("h2",{},"All matches"),m("p",{class:"small muted"},"Cap\
ture rate; pursuers in rows, evaders in columns, the best ones first. Click a cell to watch its first episode.")),m("div",{class:"drawing"},this.#a),gn("0","1"),
this.#o),r.on("pair",()=>this.#i()),r.on("hover",()=>this.#i()),this.#i()}#l(){let e=this.#n.length,r=this.#t.length,n=Ho/Math.max(e,r),o=Math.min(26,Math.max(11,
.78*n)),s=qo([...this.#e.names.pursuer,...this.#e.names.evader].map(bn),o)+12,a=r*n+s,i=M("svg",{class:"matrix",tabindex:"0",role:"img","aria-label":"Matrix of \
capture rates; arrow keys choose a match, Enter plays it",preserveAspectRatio:"xMidYMin meet",viewBox:`${-s} ${-s} ${a} ${e*n+s}`,onpointermove:c=>this.#r.point(
this.#m(c,n)),onpointerleave:()=>this.#r.point(null),onclick:c=>{let h=this.#m(c,n);h&&this.#r.play(h)},onkeydown:c=>this.#d(c)}),l=this.#n.flatMap((c,h)=>this.#t.
map((u,d)=>{let f=this.#e.capture_rate[c][u];return M("rect",{x:d*n,y:h*n,width:n,height:n,fill:wt(f),"data-pair":`${c} ${u}`})}));return i.append(...l,...this.#u(
n),...this.#h("pursuer",n,o),...this.#h("evader",n,o),this.#s),this.#s.dataset.size=String(n),i.style.minWidth=`${Vo/o*a}px`,i}#u(e){return Math.max(this.#n.length,
this.#t.length)>jo?[]:this.#n.flatMap((r,n)=>this.#t.map((o,s)=>{let a=this.#e.capture_rate[r][o];return M("text",{x:(s+.5)*e,y:(n+.5)*e,fill:bt(a),"font-size":Math.
min(30,.38*e),class:"in-cell"},E(a))}))}#h(e,r,n){return(e==="pursuer"?this.#n:this.#t).map((s,a)=>{let i=(a+.5)*r,l=e==="pursuer"?{x:-6,y:i,"text-anchor":"end"}:
{transform:`translate(${i} -6) rotate(-90)`,"text-anchor":"start"};return M("text",{...l,class:`name ${this.#c(e,s).kind}`,"font-size":n,"data-name":`${e} ${s}`},
bn(this.#e.names[e][s]))})}#c(e,r){return this.#e.standings[e].find(n=>n.number===r)}#m(e,r){let n=new DOMPoint(e.clientX,e.clientY).matrixTransform(this.#a.getScreenCTM().
inverse()),o=this.#n[Math.floor(n.y/r)],s=this.#t[Math.floor(n.x/r)];return o===void 0||s===void 0||n.x<0||n.y<0?null:{pursuer:o,evader:s}}#d(e){let n={ArrowUp:[
-1,0],ArrowDown:[1,0],ArrowLeft:[0,-1],ArrowRight:[0,1]}[e.key];if(e.key==="Enter")this.#r.play(this.#r.pair);else if(n)this.#f(n);else return;e.preventDefault(),
e.stopPropagation()}#f([e,r]){let{pursuer:n,evader:o}=this.#r.pair,s=this.#n[this.#n.indexOf(n)+e],a=this.#t[this.#t.indexOf(o)+r];s!==void 0&&a!==void 0&&this.#r.
select({pursuer:s,evader:a})}#i(){let{pair:e,hover:r}=this.#r,n=Number(this.#s.dataset.size),o=({pursuer:a,evader:i},l)=>M("rect",{class:l,x:this.#t.indexOf(i)*
n,y:this.#n.indexOf(a)*n,width:n,height:n});this.#s.replaceChildren(o(e,"selected-halo"),o(e,"selected"),...r?[o(r,"hovered-halo"),o(r,"hovered")]:[]);let s=r??
e;for(let a of this.#a.querySelectorAll("[data-name]")){let i=[`pursuer ${s.pursuer}`,`evader ${s.evader}`].includes(a.dataset.name);a.classList.toggle("about",
i)}this.#o.replaceChildren(...this.#p(s))}#p({pursuer:e,evader:r}){let{names:n,capture_rate:o,lowest:s,highest:a,length:i,episodes:l}=this.#e,c=E(o[e][r]),h=E(s[e][r]),
u=E(a[e][r]);return[m("span",{},m("span",{class:"pursuer"},n.pursuer[e])," against ",m("span",{class:"evader"},n.evader[r])),m("span",{},m("strong",{},c),m("spa\
n",{class:"small muted"},` captured; ${h} to ${u} in ${l} episodes, ${i[e][r].toFixed(0)} steps on average`))]}};function qo(t,e){let r=document.createElement("\
canvas").getContext("2d");return r.font=`700 ${e}px ${getComputedStyle(document.body).fontFamily}`,Math.max(...t.map(n=>r.measureText(n).width))}var wn=(t,e)=>t?.pursuer===e?.pursuer&&t?.evader===e?.evader,Fe=class extends EventTarget{#e;#r=null;constructor(e){super(),this.#e=e}get pair(){return this.#e}get hover(){
return this.#r}select(e){wn(e,this.#e)||(this.#e=e,this.dispatchEvent(new Event("pair")))}play(e){this.select(e),this.dispatchEvent(new Event("play"))}point(e){
wn(e,this.#r)||(this.#r=e,this.dispatchEvent(new Event("hover")))}on(e,r){this.addEventListener(e,r)}};function xt(t,e,r){let n=t.standings[e].map(a=>Ko(t,e,a,r)),o=e==="pursuer"?"Mean capture rate":"Mean escape rate",s=["Rank","Name","Score","Best, worst"];return m(
"section",{class:"card standings","aria-label":`Standings of ${e}s`},m("header",{},m("h2",{},m("span",{class:e},`${e[0].toUpperCase()}${e.slice(1)}s`)),m("p",{class:"\
small muted"},`${o} against ${t.names[it(e)].length} opponents, with 95 % interval`)),m("div",{class:"scroll",tabindex:"0"},m("table",{},m("thead",{},m("tr",{},
...s.map(a=>m("th",{scope:"col"},a)))),m("tbody",{},...n))))}function Ko(t,e,r,n){let{kind:o,name:s,file:a,rank:i,number:l}=r,c=m("tr",{class:o,"data-number":l},
m("td",{class:"rank numbers"},i||"–"),m("th",{scope:"row",title:a},m("span",{class:"who",title:s},s),m("span",{class:"kind small muted"},o)),m("td",{class:"nu\
mbers score"},Yo(r,e),Zo(r)),m("td",{class:"matches"},...["best","worst"].map(u=>Xo(t,e,r,u,n)))),h=()=>{c.classList.toggle("about",l===(n.hover??n.pair)[e])};return n.
on("pair",h),n.on("hover",h),h(),c}function Zo({score:t,low:e,high:r}){let n=e===null||r===null?"":`${E(e)} – ${E(r)}`;return m("span",{class:"score-text"},m(
"strong",{},E(t)),m("span",{class:"small muted"},n))}function Yo({score:t,low:e,high:r},n){let o=m("span",{class:`filled of-${n}`}),s=m("span",{class:"whisker"});
return o.style.width=`${100*t}%`,e!==null&&r!==null&&(s.style.left=`${100*e}%`,s.style.width=`${100*(r-e)}%`),m("span",{class:"bar","aria-hidden":"true"},o,s)}function Xo(t,e,r,n,o){
let s=r[n],a=e==="pursuer"?{pursuer:r.number,evader:s}:{pursuer:s,evader:r.number},i=t.names[it(e)][s],l=t.capture_rate[a.pursuer][a.evader],c=E(e==="pursuer"?l:
1-l);return m("button",{type:"button",class:"to-match",title:`Watch the ${n} match: against ${i}, ${c}`,"aria-label":`Watch the ${n} match of ${r.name}: against\
 ${i}, ${c}`,onclick:()=>o.play(a)},n==="best"?"▲ ":"▼ ",i)}function xn({votes:t}){let e=Object.keys(t);if(!e.length)return[];let r=e.map(n=>{let o=Object.entries(
t[n]),s=o.reduce((i,[,l])=>i+l,0),a=o.map(([i,l])=>{let c=m("span",{class:"filled"});return c.style.width=`${100*l/s}%`,m("div",{class:"vote"},m("span",{},i),m(
"span",{class:"bar","aria-hidden":"true"},c),m("span",{class:"numbers"},`${l} of ${s}`))});return m("tr",{},m("th",{scope:"row"},n),m("td",{},...a))});return[m(
"section",{class:"card votes","aria-label":"Predictions"},m("header",{},m("h2",{},"How the class voted"),m("p",{class:"small muted"},"Predictions of the course:\
 the first choice of each student, before the experiment.")),m("table",{},m("tbody",{},...r)))]}function Mn(t){if(!t.length)return[];let e=t.map(({file:r,reason:n})=>m(
"div",{class:"refusal"},m("dt",{},r),m("dd",{},n)));return[m("section",{class:"card refused","aria-label":"Refused"},m("header",{},m("h2",{},`Refused (${t.length}\
)`),m("p",{class:"small muted"},"These did not play, or broke a rule while they played; their matches count for no one.")),m("dl",{},...e))]}var P=xr(),[Jo]=P.standings.pursuer,We=new Fe({pursuer:Jo.number,evader:P.standings.evader[0].number}),te=new ze(P,We);function Qo({world:t,episodes:e,seed:r,matrixworld:n}){
return`${t.n_pursuers} pursuers and ${t.n_evaders} evaders on ${t.rows} x ${t.cols} cells, at most ${t.max_steps} steps · ${e} episodes a pair · seed ${r} · m\
atrixworld ${n}`}var es=["Every pursuer played every evader from the same starts. A score is a mean over all opponents, scripts included. Scripts are the packag\
e's own policies, for comparison; they have no rank.","A rank such as 2 to 5 means that these episodes cannot tell which of these ranks is the true one: the dif\
ference to some others is within chance. Each range misses the true rank with a probability of at most 5 %.","Keys: Space plays, ← and → step, D changes light a\
nd dark; in the matrix arrow keys choose a match and Enter plays it."];document.getElementById("page").replaceWith(hr(P.title,Qo(P)),m("main",{class:"stages"},m(
"div",{class:"tables"},xt(P,"pursuer",We),xt(P,"evader",We)),new De(P,We).element,te.element),...xn(P),...Mn(P.refusals),m("section",{class:"card reading","aria\
-label":"How to read this page"},m("h2",{},"How to read this page"),...es.map(t=>m("p",{},t))));document.addEventListener("keydown",t=>{let e=t.target instanceof
HTMLSelectElement||t.target instanceof HTMLInputElement,r=t.target instanceof HTMLButtonElement&&(t.key===" "||t.key==="Enter");if(!(e||r||t.defaultPrevented||t.
ctrlKey||t.metaKey||t.altKey)){if(t.key.toLowerCase()==="d")nt();else if(!Me(te.player,t))return;t.preventDefault()}});Object.assign(window,{matrixworldClass:{get replay(){
return te.replay},get step(){return te.player.step}}});requestAnimationFrame(()=>setTimeout(()=>{ir().then(t=>{te.start(t),document.body.dataset.ready="true"},t=>{
te.element.prepend(m("p",{class:"problem",role:"alert"},`The engine does not start here: ${String(t)}`)),document.body.dataset.ready="true"})}));})();
