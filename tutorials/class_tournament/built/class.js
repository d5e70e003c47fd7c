/* built from web/ by "npm run build"; sources 2a1fae05abaff1e2366678a422ba5c37c6f4bd927ab4e626582e6e45a0303b3d */
(()=>{var re=[.5,1,2,4,8,16,32,64],be=0,we=12,wn=2,ve=class extends EventTarget{#e;#r;#n;#t=0;#o=0;#s=!1;#a=null;#l=0;#u=[];#h=[];glide=.28;constructor(e,{speed:r=4,still:n=!1}={}){
super(),this.#e=e,this.#r=r,this.#n=n}get step(){return this.#t}get time(){return this.#n?this.#t:this.#o}get arrived(){return this.#o===this.#t}get playing(){return this.#s}get length(){
return this.#e}set length(e){this.#e=e,this.#t>e&&this.jump(e),this.#i("state")}get marks(){return this.#u}set marks(e){this.#u=e,this.#i("state")}get ticks(){return this.#h}set ticks(e){
this.#h=e,this.#i("state")}get pace(){return this.#r||Math.max(wn,this.#e/we)}get speed(){return this.#r}set speed(e){this.#r=e,this.#i("state")}changeSpeed(e){
let r=re.findIndex(n=>n>=this.pace);this.speed=re[Math.min(re.length-1,Math.max(0,r+e))]}play(){this.#s||!this.#e||(this.#t===this.#e&&this.jump(0),this.#s=!0,this.#i(
"state"),this.#m())}pause(){this.#s&&(this.#s=!1,this.#i("state"))}toggle(){this.#s?this.pause():this.play()}move(e){this.pause();let r=Math.min(this.#e,Math.max(
0,this.#t+e));Math.abs(r-this.#o)>1?this.jump(r):this.#c(r),this.#m()}jump(e){this.#o=Math.min(this.#e,Math.max(0,Math.round(e))),this.#c(this.#o),this.#i("fram\
e")}#c(e){e!==this.#t&&(this.#t=e,this.#i("step"),this.#n&&this.#i("frame"))}#m(){this.#a===null&&(this.#l=performance.now(),this.#a=requestAnimationFrame(()=>this.#f()))}#f(){
this.#a=null;let e=performance.now();this.#d(Math.min(.25,(e-this.#l)/1e3)),this.#l=e,(!this.#n||this.arrived)&&this.#i("frame"),(this.#s||this.#o!==this.#t)&&(this.#a=
requestAnimationFrame(()=>this.#f()))}#d(e){let r=e;for(;r>0;){if(this.#o===this.#t){if(!this.#s)return;if(this.#t===this.#e)return this.pause();this.#c(this.#t+
1)}let n=this.#s?this.pace:1/this.glide,o=this.#t-this.#o,s=Math.min(Math.abs(o),r*n);r-=s/n,this.#o=s===Math.abs(o)?this.#t:this.#o+Math.sign(o)*s}this.#s&&this.#o===
this.#e&&this.pause()}#i(e){this.dispatchEvent(new Event(e))}};function xe(t,e){if(e.ctrlKey||e.metaKey||e.altKey)return!1;let r=e.shiftKey?10:1,o={" ":()=>t.toggle(),
ArrowRight:()=>t.move(r),ArrowLeft:()=>t.move(-r),Home:()=>t.move(-t.length),End:()=>t.move(t.length),"+":()=>t.changeSpeed(1),"-":()=>t.changeSpeed(-1)}[e.key];
return o?.(),o!==void 0}var kt={SIMULTANEOUS:0,SWARM_TURNS:1,AGENT_TURNS:2},ne={DISAPPEAR:0,REACH:1,BOUNCE:2},_t={OCCUPATION:0,SURROUND:1},Rt={FAULT:0,INVOLVED:1};var Ot=["obstacle","teammate","adversary"],Be=["vertex","edge","chain"],Pt=["turn","kind","form","first","second","row","col","at_fault","held","doomed"],Ge=["p\
ursuer_{number}","evader_{number}"],It={obstacle:"{first} ran into the obstacle or border at {cell}",vertex:"{first} and {second} both headed for {cell}",edge:"\
{first} and {second} meant to swap, {first} to {cell}",chain:"{first} headed for {cell}, where {second} had to stay"},oe={"both held":"both bounce","both doomed":"\
both disappear",held:"{agent} bounces",doomed:"{agent} disappears",none:"nobody is stopped"},Nt="{event}: {outcome}",He={random:"any action, all equally likely",
still:"always stays",chaser:"moves to where the nearest adversary in view is nearest",fleer:"moves to where the nearest adversary in view is farthest","clumsy-c\
haser":"a chaser that takes any action in half of the steps",hunter:"a chaser of the nearest adversary in view to which no teammate in view is nearer",surrounder:"\
a chaser of the nearest free cell beside an adversary without a teammate","clumsy-fleer":"a fleer that takes any action in half of the steps",dodger:"moves to w\
here all adversaries in view together are farthest","team-surrounder":"shares the free cells beside adversaries with its teammates, and searches","careful-rando\
m":"as random, but takes only moves that right of way allows","careful-chaser":"as chaser, but takes only moves that right of way allows","careful-fleer":"as fl\
eer, but takes only moves that right of way allows","careful-clumsy-chaser":"as clumsy-chaser, but takes only moves that right of way allows","careful-hunter":"\
as hunter, but takes only moves that right of way allows","careful-surrounder":"as surrounder, but takes only moves that right of way allows","careful-clumsy-fl\
eer":"as clumsy-fleer, but takes only moves that right of way allows","careful-dodger":"as dodger, but takes only moves that right of way allows","careful-team-\
surrounder":"as team-surrounder, but takes only moves that right of way allows"},Lt={adversary:"distance to the nearest adversary (0 to 2, in half views)",pressure:"\
sum over adversaries of 1 / (1 + moves)^2 (0 or more)",unclaimed:"distance to the nearest adversary to which no teammate is nearer than the agent is now; withou\
t one, to the nearest adversary (0 to 2, in half views)",open_side:"distance to the nearest cell beside an adversary that holds no obstacle and no teammate (0 t\
o 2, in half views)",teammate:"distance to the nearest teammate (0 to 2, in half views)",exits:"share of the cells around that are no obstacle (0 to 1)",room:"d\
istance to the nearest obstacle to the north, east, south or west (0 to 1, in half views)",must_yield:"1 if right of way forbids the move (0 to 1)",ahead:"1 if \
it is the direction that the agent draws for each 12 steps (0 to 1)",search:"1 if it leads on along the way on which an agent of team-surrounder searches the gr\
id (0 to 1)"},$t={free:".GS",blocked:"#@OTW"};var H=1+Pt.length;function se(t,e){return t.replace(/\{(\w+)\}/g,(r,n)=>String(e[n]))}function j(t,e){return t<e?se(Ge[0],{number:t}):se(Ge[1],{number:t-e})}function xn(t,e){
let[r,n,o,s,a,i,l,...u]=Array.from(t),m=a<0?[s]:[s,a],[c,f,d]=u.map(C=>m.filter((P,x)=>C>>x&1)),g=m.map(C=>j(C,e)),p=se(It[a<0?"obstacle":Be[o]],{first:g[0],second:g[g.
length-1],cell:`(${i}, ${l})`}),b=se(Nt,{event:p,outcome:Mn(m.length,f,d,e)});return{kind:Ot[n],form:Be[o],agents:m,cell:[i,l],at_fault:c,held:f,doomed:d,turn:r,
text:b}}function Mn(t,e,r,n){if(t===2&&e.length===2)return oe["both held"];if(t===2&&r.length===2)return oe["both doomed"];let o=s=>a=>se(oe[s],{agent:j(a,n)});
return[...e.map(o("held")),...r.map(o("doomed"))].join(", ")||oe.none}function Me(t,e){let r=[];for(let n=0;n<t.length;n+=H)r.push(xn(t.subarray(n+1,n+H),e));return r}var z=class extends Error{name="EngineError"};function v(t,e,r){let n=typeof r=="string"?`'${r}'`:typeof r=="object"?JSON.stringify(r):String(r);return new z(`${t}\
: expected ${e}, got ${n}`)}var V=class{bytes;constructor(e){this.bytes=e}},Ft=0,Ve=[Uint8Array,Uint8Array,Int32Array,BigInt64Array,BigUint64Array,Float32Array,Float64Array],Ut=4,zt=4,An=new TextEncoder,
Sn=new TextDecoder;function Tn(t){for(let e=Ve.length-1;e>Ft;--e)if(t instanceof Ve[e])return e;throw new TypeError("array: expected a typed array of the engine\
's numbers, got another")}function je(t){return new Uint8Array(t.buffer,t.byteOffset,t.byteLength)}function Cn(t){return An.encode(`${t}\0`)}var qe=class{engine;addresses=[];constructor(e){
this.engine=e}copy(e){let r=this.engine._malloc(Math.max(e.length,1));if(r===0)throw new z("memory: expected room for the arguments, got none");return this.addresses.
push(r),this.engine.HEAPU8.set(e,r),r}text(e){return this.copy(Cn(e))}arrays(e){let r=Object.entries(e),n=r.flatMap(([s,a])=>{let i=a instanceof V,l=i?a.bytes:a;
return[this.text(s),i?Ft:Tn(l),l.length,this.copy(je(l))]}),o=this.copy(je(Int32Array.from(n)));return this.copy(je(Int32Array.of(r.length,o)))}free(){for(let e of this.
addresses)this.engine._free(e)}};function Dt(t,e){let r=t.HEAPU8;return Sn.decode(r.subarray(e,r.indexOf(0,e)))}function q(t){let e=new Int32Array(t.HEAPU8.buffer),
r=t._last_outputs()/Ut,n=e[r+1]/Ut,o={};for(let s=n;s<n+e[r]*zt;s+=zt){let a=Ve[e[s+1]],i=e[s+2]*a.BYTES_PER_ELEMENT,l=e[s+3];o[Dt(t,e[s])]=new a(t.HEAPU8.slice(
l,l+i).buffer)}return o}function U(t,e){let r=new qe(t);try{let n=e(r);if(n===0)throw new z(Dt(t,t._last_error()));return n}finally{r.free()}}var En=2**31-1,Wt=["none","gru"],kn=2n**64n-1n,_n=34028234663852886e22;function _(t,e){if(typeof e!="number"||!Number.isInteger(e)||Math.abs(e)>En)throw v(t,"an\
 integer",e);return Int32Array.of(e)}function Ae(t,e){if(typeof e!="boolean")throw v(t,"true or false",e);return new V(Uint8Array.of(Number(e)))}function F(t,e,r){
let n=typeof e=="string"&&Object.hasOwn(r,e)?r[e]:void 0;if(n===void 0)throw v(t,`one of ${Object.keys(r).join(", ")}`,e);return Int32Array.of(n)}function Ke(t,e){
if(typeof e!="number"||!(Math.abs(e)<=_n))throw v(t,"a finite number",e);return e}function ae(t,e){let n=typeof e=="bigint"||typeof e=="number"&&Number.isSafeInteger(
e)?BigInt(e):-1n;if(n<0n||n>kn)throw v(t,"an integer from 0 to 2^64 - 1",e);return BigUint64Array.of(n)}function Rn(t){return{"rules.interaction":F("interaction",
t.interaction,kt),"rules.obstacle":F("obstacle",t.obstacle,ne),"rules.teammate":F("teammate",t.teammate,ne),"rules.evader":F("evader",t.evader,ne),"rules.pursue\
r":F("pursuer",t.pursuer,ne),"rules.capture":F("capture",t.capture,_t),"rules.captured_disappear":Ae("captured_disappear",t.captured_disappear)}}function Bt(t,e){
let r=typeof e=="number"?[e,e,e]:e;if(!Array.isArray(r)||r.length!==3)throw v(t,"1 or 3 numbers",e);return Float32Array.from(r,n=>Ke(t,n))}function On(t){let e=(r,n)=>Float32Array.
of(Ke(r,t[r]),Ke(n,t[n]));return{"rewards.capture":e("pursuer_capture","evader_capture"),"rewards.neighbor":e("pursuer_neighbor","evader_neighbor"),"rewards.ste\
p":e("pursuer_step","evader_step"),"rewards.pursuer_collide":Bt("pursuer_collide",t.pursuer_collide),"rewards.evader_collide":Bt("evader_collide",t.evader_collide),
"rewards.blame":F("blame",t.blame,Rt),"rewards.capture_repeats":Ae("capture_repeats",t.capture_repeats)}}function jt(t){if(t===void 0||typeof t=="number")return new Uint8Array(
0);if(t instanceof Uint8Array)return t;let{free:e,blocked:r}=$t;for(let[n,o]of t.entries()){if(o.length!==t[0]?.length)throw v(`map, row ${n}`,`${t[0]?.length} \
cells as in row 0`,o.length);let s=[...o].find(a=>!e.includes(a)&&!r.includes(a));if(s)throw v(`map, row ${n}`,`'${e}' (free) or '${r}' (obstacle)`,s)}return Uint8Array.
from([...t.join("")],n=>Number(r.includes(n)))}function Vt(t,e){if(!Array.isArray(t))return;let r=[t.length,t[0]?.length??0];if(!(r[0]===e.rows&&r[1]===e.cols))
throw v("obstacle map",`shape (${e.rows}, ${e.cols}), the rows and cols`,r)}function K(t){Vt(t.obstacles,t);let e=typeof t.obstacles=="number"?t.obstacles:0;return{
...Rn(t.rules),...On(t.rewards),rows:_("rows",t.rows),cols:_("cols",t.cols),n_pursuers:_("n_pursuers",t.n_pursuers),n_evaders:_("n_evaders",t.n_evaders),fov:_("\
fov",t.fov),diagonal:Ae("diagonal",t.diagonal),max_steps:_("max_steps",t.max_steps),density:Float64Array.of(e),map:jt(t.obstacles)}}function Gt(t,e){return Int32Array.
from((e??[]).flat(),r=>_(t,r)[0])}function qt(t,e){return Vt(t.obstacles,e),{seed:ae("seed",t.seed??0n),episode:ae("episode",t.episode??0),pursuers:Gt("pursuers",
t.pursuers),evaders:Gt("evaders",t.evaders),map:jt(t.obstacles)}}function Se(t){return{actions:Int32Array.from(t,e=>_("actions",e)[0])}}var Ht=Object.keys(Lt);function Ze(t){
let e=Ht.indexOf(t);if(e<0)throw v("inputs",`names of ${Ht.join(", ")}`,t);return e}function D(t){if(typeof t=="string"){if(!Object.hasOwn(He,t))throw v("policy",
`one of ${Object.keys(He).join(", ")}`,t);return{script:new TextEncoder().encode(t)}}if(t.kind!=="cells")return{inputs:Int32Array.from(t.inputs,e=>Ze(e)),hidden:Int32Array.
from(t.kind==="rating"?t.hidden:[],e=>_("hidden",e)[0]),length:_("length",t.kind==="program"?t.length:0),mask:new TextEncoder().encode(t.mask),genome:t.genome};
if(t.activation!=="relu"&&t.activation!=="tanh")throw v("activation","'relu' or 'tanh'",t.activation);if(!Wt.includes(t.memory))throw v("memory",`one of ${Wt.join(
", ")}`,t.memory);return{hidden:Int32Array.from(t.hidden,e=>_("hidden",e)[0]),activation:new TextEncoder().encode(t.activation),sampled:Ae("sampled",t.sampled),
memory:new TextEncoder().encode(t.memory),genome:t.genome}}var Pn=["first_turn","terminated","truncated"];function Kt(t){let e={...t};for(let r of Pn)e[r]=new V(
t[r]);return e}var Zt="statistics.",Te=class{config;seed;episode;n_agents;statistics;first_conflict;constructor(e,r,n,o){this.config=e,this.seed=r,this.episode=n,this.n_agents=
e.n_pursuers+e.n_evaders,this.statistics=Nn(Yt(o)),Object.assign(this,o),this.first_conflict=In(this.conflict_table,this.length)}get length(){return this.actions.
length/this.n_agents}conflicts(e){this.check(e);let r=this.first_conflict[e],n=this.first_conflict[e+1],o=this.conflict_table.subarray(r*H,n*H);return Me(o,this.
config.n_pursuers)}seek(e,r,n){this.check(r),(!(e.seed===this.seed&&e.episode===BigInt(this.episode))||e.turn!==0||e.steps>r)&&e.reset({seed:this.seed,episode:this.
episode});for(let s=e.steps;s<r;++s){let a=this.actions.subarray(s*this.n_agents,(s+1)*this.n_agents);n?e.replay(a,{pursuer:n.pursuers,evader:n.evaders}):e.step(
a)}}check(e){if(!(Number.isInteger(e)&&e>=0&&e<=this.length))throw v("step",`0 to ${this.length}`,e)}};function In(t,e){let r=new Int32Array(e+2);for(let n=0;n<
t.length;n+=H)++r[t[n]+1];for(let n=1;n<r.length;++n)r[n]+=r[n-1];return r}function Nn(t){let e=["capture_rate","ever_capture_rate","captured_fraction","length"];
return Object.fromEntries(Object.entries(t).map(([r,n])=>[r,e.includes(r)?Number(n[0]):n]))}var Yt=t=>Object.fromEntries(Object.entries(t).flatMap(([e,r])=>e.startsWith(
Zt)?[[e.slice(Zt.length),r]]:[]));function Xt(t,e,r,n){let o=[K(r.config),D(r.pursuers),D(r.evaders),n];return U(t,s=>{let[a,i,l,u]=o.map(m=>s.arrays(m));return t[e](
a,i,l,u)}),q(t)}function Jt(t,e,r,n){let o={seed:ae("seed",r),episode:ae("episode",n)};return new Te(e.config,r,n,Xt(t,"_play_match",e,o))}function Qt(t,e,r,n){
if(!Number.isInteger(n)||n<1)throw v("n_episodes","at least 1",n);let o=Xt(t,"_play_rollout",e,{...r,n_episodes:Int32Array.of(n)});return Yt(o)}var Ln=new FinalizationRegistry(([t,e])=>t._states_free(e));var Ye=class{value;teams;matrix;n_actions;constructor(e,r){let{matrix:n,rows:o,cols:s,value:a,agents:i}=r,[l,u]=e.actors,m=Array.from(i).filter(f=>l<=f&&f<u),c=f=>f<
e.config.n_pursuers;this.value=a[0],this.matrix=n,this.n_actions=e.n_actions,this.teams=[{agents:m.filter(c),play:o},{agents:m.filter(f=>!c(f)),play:s}]}marginal(e){
let r=this.teams.find(({agents:s})=>s.includes(e));if(!r)return null;let n=this.n_actions**(r.agents.length-1-r.agents.indexOf(e)),o=Array(this.n_actions).fill(
0);return r.play.forEach((s,a)=>o[Math.floor(a/n)%this.n_actions]+=s),o}lost(e){let[r,n]=this.teams.map(({agents:l})=>l.reduce((u,m)=>u*this.n_actions+e[m],0)),
[o,s]=this.teams.map(({play:l})=>l),a=s.reduce((l,u,m)=>l+u*this.matrix[r*s.length+m],0),i=o.reduce((l,u,m)=>l+u*this.matrix[m*s.length+n],0);return[Math.max(0,
this.value-a),Math.max(0,i-this.value)]}},$n=60,ie=class{config;payoff;engine;states;n_turns;values;constructor(e,r,n){this.engine=e,this.config=r,this.payoff=n,
this.states=U(e,i=>e._states_new(i.arrays(K(r)))),Ln.register(this,[e,this.states]);let o={SIMULTANEOUS:1,SWARM_TURNS:2,AGENT_TURNS:r.n_pursuers+r.n_evaders};this.
n_turns=o[r.rules.interaction];let{payoffs:s}=this.call(()=>e._states_payoffs(this.states)),a=s;this.values=[[n==="capture-rate"?a:a.fill(0)]]}goBack(){let e=this.
values.at(-1)[0],r=[];for(let o=this.n_turns-1;o>=0;o--){let s=r[o+1]??e;r[o]=this.backup(o,{next:s})}this.payoff==="capture-time"&&(r[0]=r[0].map((o,s)=>s===this.
config.n_evaders?0:o-1)),this.values.push(r);let n=this.payoff==="capture-rate"?this.config.max_steps:Math.min(this.config.max_steps,$n);return this.values.length<=
n&&r[0].some((o,s)=>o!==e[s])}backup(e,r){return this.call(n=>this.engine._states_backup(this.states,e,n.arrays(r))).values}game(e){let r=this.config.max_steps-
e.steps,{turn:n}=e,o=n+1===this.n_turns,s=r>0?this.values[Math.min(r-Number(o),this.values.length-1)]?.[o?0:n+1]:void 0;if(!s)return null;let a=this.call(i=>this.
engine._states_game(this.states,e.address,i.arrays({next:s})));return a.agents.length?new Ye(e,a):null}call(e){return U(this.engine,e),q(this.engine)}};var er=new FinalizationRegistry(([t,e])=>t._world_free(e)),le=class{config;n_agents;n_actions;engine;at;freed=!1;constructor(e,r){this.engine=e,this.config=r,this.
n_agents=r.n_pursuers+r.n_evaders,this.n_actions=r.diagonal?9:5,this.at=U(e,n=>e._world_new(n.arrays(K(r)))),er.register(this,[e,this.at],this)}free(){this.freed||
(this.freed=!0,er.unregister(this),this.engine._world_free(this.at))}get address(){if(this.freed)throw v("world","one that is in use","one that was freed");return this.
at}reset(e={}){let r=qt(e,this.config);this.call(n=>this.engine._world_reset(this.address,n.arrays(r)))}step(e){let r=Se(e);this.call(n=>this.engine._world_step(
this.address,n.arrays(r)))}playTurn(e){let r=Se(e);this.call(n=>this.engine._world_play_turn(this.address,n.arrays(r)))}decide(e,r,n){let{n_pursuers:o}=this.config,
s={pursuer:[0,o],evader:[o,this.n_agents]},[a,i]=typeof r=="string"?s[r]:r;if(n.length!==this.n_agents)throw v("actions",String(this.n_agents),n.length);let l=[
D(e),Se(n)],{actions:u}=this.call(m=>this.engine._world_decide(this.address,m.arrays(l[0]),a,i,m.arrays(l[1])));return Uint8Array.from(u)}replay(e,r){let n=s=>typeof s!=
"string"&&s.kind==="cells"&&s.memory!=="none";if(!n(r.pursuer)&&!n(r.evader))return this.step(e);let{n_pursuers:o}=this.config;for(let s=this.n_turns;s>0;--s){let[
a,i]=this.actors;a<o&&this.decide(r.pursuer,[a,Math.min(i,o)],e),i>o&&this.decide(r.evader,[Math.max(a,o),i],e),this.playTurn(e)}}get n_turns(){return this.turnNumbers()[1]}get turn(){
return this.turnNumbers()[0]}get actors(){let[,,e,r]=this.turnNumbers();return[e,r]}turnNumbers(){return this.call(()=>this.engine._world_turn(this.address)).turn}get steps(){
return this.read("steps")[0]}get seed(){return this.read("seed")[0]}get episode(){return this.read("episode")[0]}get over(){return this.read("terminated")[0]===
1||this.read("truncated")[0]===1}read(e){return this.call(r=>this.engine._world_read(this.address,r.text(e)))[e]}view(e){let r=3*this.config.fov**2;return this.
read("views").slice(e*r,(e+1)*r)}map(){return this.read("state").slice(2*this.config.rows*this.config.cols)}conflicts(){return Me(this.conflictTable(),this.config.
n_pursuers)}conflictTable(){return this.call(()=>this.engine._world_conflicts(this.address)).conflict_table}answer(e,r){let n=D(e),{logits:o,memory:s}=this.call(
l=>this.engine._world_logits(this.address,l.arrays(n),r)),a=o,i=this.decide(e,[r,r+1],new Uint8Array(this.n_agents))[r];return{logits:a,probabilities:Un(a),action:i,
memory:s}}rate(e,r){let n=D(e),{ratings:o,refused:s}=this.call(u=>this.engine._world_rate(this.address,u.arrays(n),r)),a=this.read("inputs"),i=a.length/this.n_agents/
this.n_actions,l=u=>Float32Array.from({length:this.n_actions},(m,c)=>a[(r*this.n_actions+c)*i+u]);return{inputs:e.inputs.map(u=>l(Ze(u))),ratings:o,refused:s}}snapshot(){
return this.call(()=>this.engine._world_snapshot(this.address))}restore(e){let r=Kt(e);this.call(n=>this.engine._world_restore(this.address,n.arrays(r)))}call(e){
return U(this.engine,e),q(this.engine)}};function Un(t){let e=Math.max(...t),r=Array.from(t,o=>Math.exp(o-e)),n=r.reduce((o,s)=>o+s,0);return Float32Array.from(
r,o=>o/n)}var Xe=class{compiled;constructor(e){this.compiled=e}world(e){return new le(this.compiled,e)}solution(e,r="capture-rate"){return new ie(this.compiled,e,r)}match(e,r,n,o,s=0){
return Jt(this.compiled,{config:e,pursuers:r,evaders:n},o,s)}rollouts(e,r,n,o,s){return Qt(this.compiled,{config:e,pursuers:r,evaders:n},o,s)}},tr;function rr(t=globalThis.
matrixworldEngine){return tr??=zn(t),tr}async function zn(t){if(!t)throw new Error("matrixworldEngine: expected the script engine.js before this one, got none");
let e=Uint8Array.from(atob(t.binary),r=>r.charCodeAt(0));return new Xe(await t({wasmBinary:e}))}var Fn="http://www.w3.org/2000/svg";function h(t,e={},...r){return nr(document.createElement(t),e,r)}function M(t,e={},...r){return nr(document.createElementNS(
Fn,t),e,r)}function nr(t,e,r){for(let[o,s]of Object.entries(e))s==null||s===!1||(typeof s=="function"?t.addEventListener(o.slice(2),s):t.setAttribute(o,s===!0?"":
String(s)));let n=r.filter(o=>o!=null&&o!==!1);return t.append(...n.map(o=>typeof o=="number"?String(o):o)),t}var or=()=>document.documentElement.dataset.theme==="dark";function ue(t){document.documentElement.dataset.theme=t?"dark":"light"}var Je=()=>ue(!or());if(typeof document<
"u"){let t=matchMedia("(prefers-color-scheme: dark)");t.addEventListener("change",()=>ue(t.matches)),ue(t.matches);let e=!1;addEventListener("beforeprint",()=>{
e=or(),ue(!1)}),addEventListener("afterprint",()=>ue(e))}function sr(){return h("button",{type:"button",title:"Light or dark (D)","aria-label":"Light or dark",onclick:Je},
"◐")}var ar=(t,e,...r)=>h("header",{class:"top"},h("div",{},h("h1",{},t),e?h("p",{class:"lead"},e):null),h("div",{class:"tools"},...r,sr()));var k=Uint8Array,Z=Uint16Array,Dn=Int32Array,ir=new k([0,0,0,0,0,0,0,0,1,1,1,1,2,2,2,2,3,3,3,3,4,4,4,4,5,5,5,5,0,0,0,0]),lr=new k([0,0,0,0,1,1,2,2,3,3,4,4,5,5,6,
6,7,7,8,8,9,9,10,10,11,11,12,12,13,13,0,0]),Wn=new k([16,17,18,0,8,7,9,6,10,5,11,4,12,3,13,2,14,1,15]),ur=function(t,e){for(var r=new Z(31),n=0;n<31;++n)r[n]=e+=
1<<t[n-1];for(var o=new Dn(r[30]),n=1;n<30;++n)for(var s=r[n];s<r[n+1];++s)o[s]=s-r[n]<<5|n;return{b:r,r:o}},cr=ur(ir,2),hr=cr.b,Bn=cr.r;hr[28]=258,Bn[258]=28;var mr=ur(
lr,0),Gn=mr.b,Os=mr.r,tt=new Z(32768);for(y=0;y<32768;++y)N=(y&43690)>>1|(y&21845)<<1,N=(N&52428)>>2|(N&13107)<<2,N=(N&61680)>>4|(N&3855)<<4,tt[y]=((N&65280)>>8|
(N&255)<<8)>>1;var N,y,ce=(function(t,e,r){for(var n=t.length,o=0,s=new Z(e);o<n;++o)t[o]&&++s[t[o]-1];var a=new Z(e);for(o=1;o<e;++o)a[o]=a[o-1]+s[o-1]<<1;var i;
if(r){i=new Z(1<<e);var l=15-e;for(o=0;o<n;++o)if(t[o])for(var u=o<<4|t[o],m=e-t[o],c=a[t[o]-1]++<<m,f=c|(1<<m)-1;c<=f;++c)i[tt[c]>>l]=u}else for(i=new Z(n),o=0;o<
n;++o)t[o]&&(i[o]=tt[a[t[o]-1]++]>>15-t[o]);return i}),he=new k(288);for(y=0;y<144;++y)he[y]=8;var y;for(y=144;y<256;++y)he[y]=9;var y;for(y=256;y<280;++y)he[y]=
7;var y;for(y=280;y<288;++y)he[y]=8;var y,fr=new k(32);for(y=0;y<32;++y)fr[y]=5;var y;var Hn=ce(he,9,1);var jn=ce(fr,5,1),Qe=function(t){for(var e=t[0],r=1;r<t.length;++r)t[r]>e&&(e=t[r]);return e},R=function(t,e,r){var n=e/8|0;return(t[n]|t[n+1]<<8)>>(e&7)&r},et=function(t,e){
var r=e/8|0;return(t[r]|t[r+1]<<8|t[r+2]<<16)>>(e&7)},Vn=function(t){return(t+7)/8|0},qn=function(t,e,r){return(e==null||e<0)&&(e=0),(r==null||r>t.length)&&(r=t.
length),new k(t.subarray(e,r))};var Kn=["unexpected EOF","invalid block type","invalid length/literal","invalid distance","stream finished","no stream handler",,"no callback","invalid UTF-8 da\
ta","extra field too long","date not in range 1980-2099","filename too long","stream finishing","invalid zip data"],O=function(t,e,r){var n=new Error(e||Kn[t]);
if(n.code=t,Error.captureStackTrace&&Error.captureStackTrace(n,O),!r)throw n;return n},Zn=function(t,e,r,n){var o=t.length,s=n?n.length:0;if(!o||e.f&&!e.l)return r||
new k(0);var a=!r,i=a||e.i!=2,l=e.i;a&&(r=new k(o*3));var u=function(Tt){var Ct=r.length;if(Tt>Ct){var Et=new k(Math.max(Ct*2,Tt));Et.set(r),r=Et}},m=e.f||0,c=e.
p||0,f=e.b||0,d=e.l,g=e.d,p=e.m,b=e.n,C=o*8;do{if(!d){m=R(t,c,1);var P=R(t,c+1,3);if(c+=3,P)if(P==1)d=Hn,g=jn,p=9,b=5;else if(P==2){var Ue=R(t,c,31)+257,gt=R(t,
c+10,15)+4,vt=Ue+R(t,c+5,31)+1;c+=14;for(var ee=new k(vt),ze=new k(19),E=0;E<gt;++E)ze[Wn[E]]=R(t,c+E*3,7);c+=gt*3;for(var bt=Qe(ze),pn=(1<<bt)-1,yn=ce(ze,bt,1),
E=0;E<vt;){var wt=yn[R(t,c,pn)];c+=wt&15;var x=wt>>4;if(x<16)ee[E++]=x;else{var B=0,ge=0;for(x==16?(ge=3+R(t,c,3),c+=2,B=ee[E-1]):x==17?(ge=3+R(t,c,7),c+=3):x==
18&&(ge=11+R(t,c,127),c+=7);ge--;)ee[E++]=B}}var xt=ee.subarray(0,Ue),$=ee.subarray(Ue);p=Qe(xt),b=Qe($),d=ce(xt,p,1),g=ce($,b,1)}else O(1);else{var x=Vn(c)+4,L=t[x-
4]|t[x-3]<<8,Q=x+L;if(Q>o){l&&O(0);break}i&&u(f+L),r.set(t.subarray(x,Q),f),e.b=f+=L,e.p=c=Q*8,e.f=m;continue}if(c>C){l&&O(0);break}}i&&u(f+131072);for(var gn=(1<<
p)-1,vn=(1<<b)-1,Fe=c;;Fe=c){var B=d[et(t,c)&gn],G=B>>4;if(c+=B&15,c>C){l&&O(0);break}if(B||O(2),G<256)r[f++]=G;else if(G==256){Fe=c,d=null;break}else{var Mt=G-
254;if(G>264){var E=G-257,te=ir[E];Mt=R(t,c,(1<<te)-1)+hr[E],c+=te}var De=g[et(t,c)&vn],We=De>>4;De||O(3),c+=De&15;var $=Gn[We];if(We>3){var te=lr[We];$+=et(t,c)&
(1<<te)-1,c+=te}if(c>C){l&&O(0);break}i&&u(f+131072);var At=f+Mt;if(f<$){var St=s-$,bn=Math.min($,At);for(St+f<0&&O(3);f<bn;++f)r[f]=n[St+f]}for(;f<At;++f)r[f]=
r[f-$]}}e.l=d,e.p=Fe,e.b=f,e.f=m,d&&(m=1,e.m=p,e.d=g,e.n=b)}while(!m);return f!=r.length&&a?qn(r,0,f):r.subarray(0,f)};var Yn=new k(0);var Xn=function(t,e){return((t[0]&15)!=8||t[0]>>4>7||(t[0]<<8|t[1])%31)&&O(6,"invalid zlib data"),(t[1]>>5&1)==+!e&&O(6,"invalid zlib data: "+(t[1]&32?"need":"u\
nexpected")+" dictionary"),(t[1]>>3&4)+2};function dr(t,e){return Zn(t.subarray(Xn(t,e&&e.dictionary),-4),{i:2},e&&e.out,e&&e.dictionary)}var Jn=typeof TextDecoder<"u"&&new TextDecoder,Qn=0;try{Jn.decode(Yn,{stream:!0}),Qn=1}catch{}var rt=t=>t==="pursuer"?"evader":"pursuer";function pr(t){let e=atob(nt(t)),r=new Uint8Array(e.length);for(let n=0;n<r.length;n++)r[n]=e.charCodeAt(n);return r}var nt=t=>document.getElementById(t)?.textContent??
"";function yr(){return JSON.parse(nt("data"))}var ot=[[0,0],[-1,0],[0,1],[1,0],[0,-1],[-1,1],[1,1],[1,-1],[-1,-1]];var W=(t,e)=>e<t.nPursuers,w=(t,e)=>[t.positions[2*e],t.positions[2*e+1]],st=({rows:t,cols:e},[r,n])=>r>=0&&n>=0&&r<t&&n<e,at=(t,e,r=3)=>t!==void 0&&[0,1,2].slice(
0,r).some(n=>t[3*e+n]),it=(t,e)=>at(t.fault,e),gr=(t,e)=>!it(t,e)&&at(t.involved,e,2);function Ce(t,e,r){let n=w(t,r),o=w(e,r),s=n[0]!==o[0]||n[1]!==o[1],a=e.involved===
void 0||at(e.involved,r);return!!(e.alive[r]&&e.actions?.[r]&&!s&&a)}function Ee(t,e,r){let[n,o]=w(t,r),[s,a]=ot[e.actions?.[r]??0];return[n+s,o+a]}function me(t,e,r){
return Array.from({length:r.everCaptured.length},(o,s)=>s).filter(o=>r.everCaptured[o]&&!e.everCaptured[o]).map(o=>t.nPursuers+o)}var vr=t=>t.moments.flatMap((e,r)=>r&&
me(t,t.moments[r-1],e).length?[r]:[]);function ke(t,e){return Array.from({length:e.alive.length},(n,o)=>o).filter(n=>t.alive[n]&&!e.alive[n])}var br=[-.31,0,.31],wr=[{size:1,at:[[0,0]]},{size:.62,at:[[-.2,.2],[.2,-.2]]},{size:.54,at:[[-.23,.22],[.23,.22],[0,-.22]]},{size:.54,at:[[-.23,.23],[.23,.23],[
-.23,-.23],[.23,-.23]]},{size:.36,at:br.flatMap(t=>br.map(e=>[e,t]))}],eo=.3,to=.35,ro=.55;function fe(t,e){let r=new Map;for(let n=0;n<e.alive.length;n++){if(!e.
alive[n])continue;let[o,s]=w(e,n),a=o*t.cols+s,i=r.get(a);i?i.push(n):r.set(a,[n])}return r}function xr(t,e){let r=Array.from(e.alive,(n,o)=>{let[s,a]=w(e,o);return{
x:a+.5,y:s+.5,size:1,alpha:0}});for(let n of fe(t,e).values()){let o=wr[Math.min(n.length,wr.length)-1];n.forEach((s,a)=>{let[i,l]=o.at[Math.min(a,o.at.length-1)],
u=r[s];u.x+=i,u.y+=l,u.size=o.size,u.alpha=1})}return r}var Mr=t=>t*t*(3-2*t),Y=(t,e,r)=>t+(e-t)*r,Ar=t=>Math.min(1,Math.max(0,t));function Sr(t,e,r,n){let o={SIMULTANEOUS:1,
SWARM_TURNS:2,AGENT_TURNS:r}[t.interaction];if(o===1)return Mr(n);let s=o===r?e:+!W(t,e),a=Math.max(1/o,to);return Mr(Ar((n-s/(o-1)*(1-a))/a))}function _e(t,e){
let r=t.moments.length-1,n=Math.min(Math.floor(e),r),o=t.moments[n],s=xr(t,o);if(n===r||e===n)return s;let a=t.moments[n+1],i=xr(t,a);return s.map((l,u)=>{let m=Sr(
t,u,s.length,e-n);return no(o,a,u,l,i[u],m)})}function lt(t,e,r){let n=t.moments.length-1,o=Math.min(Math.floor(r),n),s=t.moments[o],a=t.moments[Math.min(o+1,n)],
i=Sr(t,e,s.alive.length,r-o),[l,u]=w(s,e),[m,c]=w(a,e);return[Y(u,c,i)+.5,Y(l,m,i)+.5]}function no(t,e,r,n,o,s){let a=n.alpha>o.alpha,i={x:Y(n.x,o.x,s),y:Y(n.y,
o.y,s),size:a?n.size:Y(n.size,o.size,s),alpha:a?Ar((1-s)/(1-ro)):Y(n.alpha,o.alpha,s)};if(Ce(t,e,r)){let[l,u]=w(t,r),[m,c]=Ee(t,e,r),f=eo*Math.sin(Math.PI*s);i.
x+=(c-u)*f,i.y+=(m-l)*f}return i}var Tr=2*Math.PI;function de(t,e,r,n){t.beginPath(),t.arc(e,r,n/2,0,Tr)}function Cr(t,e,r,n){let o=n/2,s=[[0,-.97],[.97,.83],[-.97,.83]].map(([a,i])=>[e+a*o,r+i*
o]);t.beginPath(),t.moveTo((s[2][0]+s[0][0])/2,(s[2][1]+s[0][1])/2),s.forEach(([a,i],l)=>{let[u,m]=s[(l+1)%3];t.arcTo(a,i,u,m,n*.09)}),t.closePath()}function Er(t,e,r,n){
let o=n*.32;t.beginPath(),t.moveTo(e-o,r-o),t.lineTo(e+o,r+o),t.moveTo(e+o,r-o),t.lineTo(e-o,r+o)}function kr(t,e,r,n){t.beginPath();for(let o=0;o<16;o++){let s=n/
2*(o%2?.6:.95),a=Tr*o/16;t.lineTo(e+s*Math.sin(a),r-s*Math.cos(a))}t.closePath()}function _r(t,e,r,n,o,s){let a=Math.atan2(o-r,n-e);t.beginPath(),t.moveTo(e,r),
t.lineTo(n,o);for(let i of[-1,1])t.moveTo(n,o),t.lineTo(n-s*Math.cos(a+i*.6),o-s*Math.sin(a+i*.6))}var Rr=4,oo=1.6,so=.95,ao=5,io=.16,lo=9,uo=.09,co=.2,Or=.75,A=(t,e)=>t.left+e*t.cell,S=(t,e)=>t.top+e*t.cell;function X(t,e,r){return W(e,r)?t.colors.pursuer:t.
colors.evader}function Re({ctx:t,colors:e},r,n,o,s,a,i=0){t.font=`700 ${Math.round(s)}px system-ui, sans-serif`,t.textAlign="center",t.textBaseline="middle",t.strokeStyle=
e.paper,t.lineWidth=i,i&&t.strokeText(r,n,o),t.fillStyle=a,t.fillText(r,n,o)}function Pr({ctx:t,grid:e,colors:r}){let{left:n,top:o,cell:s,rows:a,cols:i}=e,l=i*s,
u=a*s;if(t.fillStyle=r.paper,t.fillRect(n,o,l,u),s<ao)return;t.fillStyle=r.line;let m=Math.max(1,Math.round(s/60));for(let c=1;c<i;c++)t.fillRect(n+c*s,o,m,u);for(let c=1;c<
a;c++)t.fillRect(n,o+c*s,l,m)}function Ir({ctx:t,grid:e,colors:r},n){let{left:o,top:s,cell:a,rows:i,cols:l}=e;t.fillStyle=r.obstacle;for(let u=0;u<i*l;u++){if(!n.
obstacles[u])continue;let m=Math.floor(u/l),c=u%l;t.fillRect(o+c*a,s+m*a,a,a)}Nr({ctx:t,grid:e,colors:r})}function Nr({ctx:t,grid:{left:e,top:r,cell:n,rows:o,cols:s},
colors:a}){let i=Math.min(5,Math.max(2,Math.round(n/18)));t.strokeStyle=a.frame,t.lineWidth=i,t.strokeRect(e-i/2,r-i/2,s*n+i,o*n+i)}function Lr({ctx:t,grid:e,colors:r},n){
let{left:o,top:s,cell:a,rows:i,cols:l}=e,u=a<24*n?5:1;t.font=`500 ${Math.round(Math.min(15*n,Math.max(9*n,a*.32)))}px system-ui, sans-serif`,t.fillStyle=r.muted,
t.textBaseline="alphabetic",t.textAlign="center";let m=5*n+a/40;for(let c=0;c<l;c+=u)t.fillText(String(c),o+(c+.5)*a,s-m);t.textAlign="right",t.textBaseline="mi\
ddle";for(let c=0;c<i;c+=u)t.fillText(String(c),o-m,s+(c+.5)*a)}function $r({grid:t},e,r,n){let o=Math.floor(e.fov/2)+.5,s=Math.max(0,r-o),a=Math.min(t.cols,r+o),
i=Math.max(0,n-o),l=Math.min(t.rows,n+o);return[A(t,s),S(t,i),(a-s)*t.cell,(l-i)*t.cell]}function Ur(t,e,r,n){let{ctx:o,grid:s,colors:a}=t;o.save(),o.beginPath(),
o.rect(0,0,o.canvas.width,o.canvas.height),o.rect(...$r(t,e,r,n)),o.clip("evenodd"),o.clearRect(0,0,o.canvas.width,o.canvas.height),o.fillStyle=a.line,o.fillRect(
s.left,s.top,s.cols*s.cell,s.rows*s.cell),o.restore(),Nr(t)}function zr(t,{x:e,y:r,alpha:n},o){let{ctx:s,grid:a,colors:i}=t,l=Math.max(a.cell,16*o)*1.06,u=A(a,e),
m=S(a,r);s.globalAlpha=Math.max(n,.6),s.beginPath(),s.roundRect(u-l/2,m-l/2,l,l,l*.2),s.strokeStyle=i.focus,s.lineWidth=Math.max(2,2.5*o),s.stroke();let c=Math.
max(11*o,Math.min(18*o,a.cell*.5)),f=m-l/2<c*1.2,d=m+(f?1:-1)*(l/2+c*.7);s.lineJoin="round",Re(t,"You",u,d,c,i.ink,c*.35),s.globalAlpha=1}function Fr(t,e,r,n,o){
let{ctx:s,grid:a}=t,i=$r(t,e,n,o),l=X(t,e,r);s.globalAlpha=.11,s.fillStyle=l,s.fillRect(...i),s.globalAlpha=.8,s.strokeStyle=l,s.lineWidth=Math.max(1,a.cell/24),
s.strokeRect(...i),s.globalAlpha=1}function Dr(t,e,r,n,o){let{ctx:s,grid:a}=t,i=Math.min(Math.ceil(r),e.moments.length-1),l=e.moments[i];s.lineCap="round",s.lineWidth=
Math.min(lo,Math.max(1,a.cell*io));for(let u=Math.max(1,Math.floor(r-n)+1);u<=i;u++){let m=e.moments[u-1],c=e.moments[u],f=Math.max(0,Math.min(1,(r-u)/n));s.globalAlpha=
Or+(co-Or)*f;for(let d=0;d<c.alive.length;d++){let g=u===i&&r<i;if(!m.alive[d]||!(l.alive[d]||g))continue;let p=(W(e,d)?-1:1)*uo,[b,C]=w(m,d),[P,x]=w(c,d);if(b===
P&&C===x)continue;let L=g?o[d].x:x+.5,Q=g?o[d].y:P+.5;s.strokeStyle=X(t,e,d),s.beginPath(),s.moveTo(A(a,C+.5+p),S(a,b+.5+p)),s.lineTo(A(a,L+p),S(a,Q+p)),s.stroke()}}
s.globalAlpha=1}function Wr(t,e,r){let n=Math.min(Math.ceil(r),e.moments.length-1);for(let o=Math.max(1,n-Rr+1);o<=n;o++){let s=e.moments[o-1],a=e.moments[o],i=o>
r?Math.max(0,1-2*(o-r)):1-(r-o)/Rr,l=me(e,s,a);for(let u of ke(s,a))l.includes(u)||mo(t,w(a,u),i);for(let u of l)ho(t,w(a,u),i)}t.ctx.globalAlpha=1}function ho({
ctx:t,grid:e,colors:r},[n,o],s){t.globalAlpha=s,kr(t,A(e,o+.5),S(e,n+.5),Math.max(8,e.cell*oo)),t.fillStyle=r.capture,t.fill(),t.strokeStyle=r.ink,t.lineWidth=Math.
max(1,e.cell/36),t.lineJoin="round",t.stroke()}function mo({ctx:t,grid:e,colors:r},[n,o],s){t.globalAlpha=s,Er(t,A(e,o+.5),S(e,n+.5),Math.max(7,e.cell*so)),t.strokeStyle=
r.collision,t.lineWidth=Math.max(2,e.cell*.17),t.lineCap="round",t.stroke()}function Br({ctx:t,grid:e,colors:r},n,o){let s=Math.max(1,e.cell*.07);t.strokeStyle=
t.fillStyle=r.collision,t.lineWidth=Math.max(1,e.cell*.05),t.setLineDash([e.cell*.14,e.cell*.1]);for(let[a,i]of n){if(a<0||i<0||a>=e.rows||i>=e.cols)continue;let l=[
A(e,i)+s,S(e,a)+s,e.cell-2*s,e.cell-2*s];t.globalAlpha=.2*o,t.fillRect(...l),t.globalAlpha=o,t.strokeRect(...l)}t.setLineDash([]),t.globalAlpha=1}function Gr({ctx:t,
grid:e,colors:r},n,o,s,a){t.globalAlpha=a,de(t,A(e,n),S(e,o),Math.max(8,e.cell*s*1.02)),t.strokeStyle=r.collision,t.lineWidth=Math.max(1.5,e.cell*.085*Math.sqrt(
s)),t.stroke(),t.globalAlpha=1}var fo=.8,po=.92,yo=15,go=7,ut=9;function Hr(t,e,r,n,o,s){n.forEach((a,i)=>{a.alpha>0&&vo(t,e,r,i,a,o,s)}),t.ctx.globalAlpha=1;for(let a of fe(e,r).values())a.length>
ut&&bo(t,n[a[ut-1]],a.length-ut+1)}function vo(t,e,r,n,o,s,a){let{ctx:i,grid:l,colors:u}=t,m=W(e,n),c=A(l,o.x),f=S(l,o.y),d=Math.max(4,l.cell*o.size*(m?po:fo)),
g=X(t,e,n),p=!m&&!!r.captured[n-e.nPursuers];if(i.globalAlpha=o.alpha,(m?Cr:de)(i,c,f,d),d>go*a&&(i.strokeStyle=u.paper,i.lineWidth=Math.max(2,d*.1),i.stroke()),
i.fillStyle=p?u.paper:g,i.fill(),p&&(de(i,c,f,d*.82),i.strokeStyle=g,i.lineWidth=d*.18,i.stroke()),!s||d<yo*a)return;let b=String(m?n:n-e.nPursuers),C=d*(m?.4:.5)*
(b.length>1?.8:1);Re(t,b,c,f+d*(m?.17:.03),C,p?g:u.paper)}function bo(t,e,r){let{cell:n}=t.grid;Re(t,`+${r}`,A(t.grid,e.x),S(t.grid,e.y),n*.3,t.colors.ink,n*.1)}var wo=.46,xo=.86,Mo=.66,jr=.48,Ao=.78,So=.58;function Vr(t,e,r,n){let o=e.moments[r-1],s=e.moments[r];if(!o)return;let{ctx:a,grid:i,colors:l}=t;a.strokeStyle=l.
collision,a.lineWidth=Math.max(1.5,i.cell*.07),a.lineCap="butt",a.globalAlpha=n;for(let u=0;u<s.alive.length;u++)Ce(o,s,u)&&To(t,e,w(o,u),Ee(o,s,u));a.globalAlpha=
1}function To({ctx:t,grid:e},r,n,o){let s=o[1]-n[1],a=o[0]-n[0],i=c=>A(e,n[1]+.5+s*c),l=c=>S(e,n[0]+.5+a*c),u=st(r,o)?Ao:So;t.setLineDash([e.cell*.09,e.cell*.06]),
t.beginPath(),t.moveTo(i(jr),l(jr)),t.lineTo(i(u),l(u)),t.stroke(),t.setLineDash([]);let m=.17*e.cell/Math.hypot(s,a);t.beginPath(),t.moveTo(i(u)-a*m,l(u)+s*m),
t.lineTo(i(u)+a*m,l(u)-s*m),t.stroke()}function qr(t,e,r,n,o,s){let a=ot[s];if(!s||!a)return;let{ctx:i,grid:l,colors:u}=t,m=st(e,[n[0]+a[0],n[1]+a[1]])?xo:Mo,c=wo*
o.size,f=[A(l,o.x+a[1]*c),S(l,o.y+a[0]*c),A(l,o.x+a[1]*m),S(l,o.y+a[0]*m)],d=Math.max(1.5,l.cell*.085);i.lineCap=i.lineJoin="round";for(let[g,p]of[[u.paper,d*2.1],
[X(t,e,r),d]])i.strokeStyle=g,i.lineWidth=p,_r(i,...f,l.cell*.2),i.stroke()}var Zr={numbers:!0,axes:!1,trail:6,viewers:[],plan:null,selected:null,cursor:null,you:null,fog:!1};function Yr(t,e,r,n,o){let{ctx:s,grid:a,colors:i}=t,l=Math.min(
Math.ceil(r),e.moments.length-1),u=e.moments[l],m=r===l,c=_e(e,r),f=m?1:Math.max(0,1-2*(l-r));s.clearRect(0,0,s.canvas.width,s.canvas.height),Pr(t);for(let p of n.
viewers)c[p]?.alpha&&Fr(t,e,p,...lt(e,p,r));Ir(t,e),n.axes&&Lr(t,o),Dr(t,e,r,n.trail,c),Br(t,u.contested??[],f),Wr(t,e,r),Vr(t,e,l,f),c.forEach(({x:p,y:b,size:C},P)=>{
let x=gr(u,P)?.4:0,L=it(u,P)?1:x;L&&Gr(t,p,b,C,L*f)});let d=m?u:e.moments[Math.max(0,l-1)];if(Hr(t,e,d,c,n.numbers,o),m&&n.plan)for(let[p,b]of c.entries())b.alpha&&
qr(t,e,p,w(u,p),b,n.plan[p]??0);n.you!==null&&(n.fog&&Ur(t,e,...lt(e,n.you,r)),zr(t,c[n.you],o)),s.lineWidth=Math.max(2,2.5*o),s.strokeStyle=i.focus;let g=n.selected===
null?void 0:c[n.selected];g?.alpha&&Kr(t,g.x,g.y,g.size*.96),n.cursor&&(s.setLineDash([a.cell*.12,a.cell*.08]),Kr(t,n.cursor[1]+.5,n.cursor[0]+.5,.8),s.setLineDash(
[]))}function Kr({ctx:t,grid:e},r,n,o){let s=o*e.cell;t.beginPath(),t.roundRect(e.left+r*e.cell-s/2,e.top+n*e.cell-s/2,s,s,s*.1),t.stroke()}var Xr=(t,e)=>(e+.24)/(t+.24);function Jr(t,e,r,n,o,s){let a=r?28*s:0,i=(u,m)=>(u-a)/(m+2*.12),l=Math.max(1,Math.floor(Math.min(i(n,e),i(o,t))));return{rows:t,cols:e,
cell:l,left:Math.round((n-e*l+a)/2),top:Math.round((o-t*l+a)/2)}}function Qr(t,e,r){let n=Math.floor((r-t.top)/t.cell),o=Math.floor((e-t.left)/t.cell);return n>=
0&&n<t.rows&&o>=0&&o<t.cols?[n,o]:null}var Co=["paper","line","frame","ink","muted","obstacle"],Eo=["pursuer","evader","capture","collision","focus"];function en(t){let e=getComputedStyle(t),r=(n,o)=>[
n,e.getPropertyValue(o+n).trim()];return Object.fromEntries([...Co.map(n=>r(n,"--board-")),...Eo.map(n=>r(n,"--"))])}var ct=()=>matchMedia("(prefers-reduced-motion: reduce)").matches,Oe=class{canvas;#e=null;#r=0;#n;#t={rows:1,cols:1,left:0,top:0,cell:1};#o=0;constructor(e,r={}){
this.canvas=e,e.classList.add("board"),e.setAttribute("role","img"),this.#n={...Zr,...r},new ResizeObserver(()=>this.#a()).observe(e),new MutationObserver(()=>this.
redraw()).observe(document.documentElement,{attributes:!0}),addEventListener("beforeprint",()=>this.drawNow())}set look(e){this.#n={...this.#n,...e},this.#s(),this.
redraw()}show(e,r){this.#e=e,this.#r=Math.min(Math.max(0,r),e.moments.length-1),this.#s(),this.redraw()}redraw(){this.#o||(this.#o=requestAnimationFrame(()=>this.
drawNow()))}drawNow(){cancelAnimationFrame(this.#o),this.#o=0;let e=this.canvas.getContext("2d");if(!e||!this.#e)return;let{rows:r,cols:n}=this.#e,o=devicePixelRatio||
1;this.#t=Jr(r,n,this.#n.axes,this.canvas.width,this.canvas.height,o);let s={ctx:e,grid:this.#t,colors:en(this.canvas)};Yr(s,this.#e,this.#r,this.#n,o)}cellAt(e,r){
let n=this.canvas.getBoundingClientRect(),o=this.canvas.width/n.width;return Qr(this.#t,(e-n.left)*o,(r-n.top)*o)}agentAt(e,r){let n=this.cellAt(e,r);if(!n||!this.#e)
return null;let o=this.#e.moments[Math.round(this.#r)],s=fe(this.#e,o).get(n[0]*this.#e.cols+n[1])??[],a=_e(this.#e,Math.round(this.#r)),i=l=>{let[u,m]=this.pointOf(
a[l].x,a[l].y);return Math.hypot(u-e,m-r)};return s.length?s.reduce((l,u)=>i(u)<i(l)?u:l):null}pointOf(e,r){let n=this.canvas.getBoundingClientRect(),o=n.width/
this.canvas.width,{left:s,top:a,cell:i}=this.#t;return[n.left+(s+e*i)*o,n.top+(a+r*i)*o]}#s(){if(!this.#e)return;let{rows:e,cols:r}=this.#e;this.canvas.style.setProperty(
"--board-aspect",String(Xr(e,r)))}#a(){let e=devicePixelRatio||1,{width:r,height:n}=this.canvas.getBoundingClientRect();this.canvas.width=Math.max(1,Math.round(
r*e)),this.canvas.height=Math.max(1,Math.round(n*e)),this.drawNow()}};var ko=Array.from({length:16},(t,e)=>{let r=e%2?6.5:11,n=Math.PI*e/8;return`${12+r*Math.sin(n)} ${12-r*Math.cos(n)}`}).join(" ");function tn(){let t=[["pursuer",
M("path",{d:"M12 3 22 20H2z",class:"filled-pursuer"})],["evader",M("circle",{cx:12,cy:12,r:9,class:"filled-evader"})],["capture",M("polygon",{points:ko,class:"f\
illed-capture"})],["captured evader",M("circle",{cx:12,cy:12,r:7.5,class:"ring-evader"})],["conflict",M("rect",{x:3,y:3,width:18,height:18,class:"dashed-conflic\
t"})]];return h("ul",{class:"shapes small","aria-label":"Shapes on the board"},...t.map(([e,r])=>h("li",{},M("svg",{viewBox:"0 0 24 24","aria-hidden":"true"},r),
e)))}var _o={first:"M6 5v14M19 5 9 12l10 7z",back:"M17 5 7 12l10 7z",play:"M7 4.5 19 12 7 19.5z",pause:"M8 5v14M16 5v14",forward:"M7 5l10 7-10 7z",last:"M18 5v14M5 5\
l10 7-10 7z"};function rn(t){return M("svg",{viewBox:"0 0 24 24","aria-hidden":"true",class:"icon"},M("path",{d:_o[t]}))}function pe(t,e,r,n){return h("button",
{type:"button",class:"player-button","aria-label":e,title:`${e} (${r})`,onclick:n},rn(t))}function nn(t){let e=pe("play","Play","Space",()=>t.toggle()),r=h("inp\
ut",{type:"range",class:"player-scrub",min:0,step:1,"aria-label":"Step",oninput:()=>{t.pause(),t.jump(Number(r.value))}}),n=h("div",{class:"captures","aria-hidd\
en":"true",title:"Captures"}),o=h("div",{class:"losses","aria-hidden":"true"}),s=h("select",{class:"player-speed","aria-label":"Speed",title:`Steps a second, or\
 the whole in ${we} s (+ and -)`,onchange:()=>t.speed=Number(s.value)},h("option",{value:be},`in ${we} s`),...re.map(c=>h("option",{value:c},`${c} / s`))),a=h("\
output",{class:"player-count"}),i=h("div",{class:"player",role:"group","aria-label":"Player"},pe("first","First step","Home",()=>t.move(-t.length)),pe("back","S\
tep back","←",()=>t.move(-1)),e,pe("forward","Step forward","→",()=>t.move(1)),pe("last","Last step","End",()=>t.move(t.length)),h("div",{class:"scrub"},n,o,
r),a,s),l=(c,f={})=>{let d=h("i",f);return d.style.left=`${100*c/Math.max(1,t.length)}%`,d},u=()=>{n.replaceChildren(...t.marks.map(c=>l(c))),o.replaceChildren(
...t.ticks.map(({step:c,kind:f,size:d,text:g})=>{let p=l(c,{class:f,title:`Step ${c}: ${g}`});return p.style.height=`${100*d}%`,p}))},m=()=>{e.replaceChildren(rn(
t.playing?"pause":"play")),e.ariaLabel=t.playing?"Pause":"Play",e.title=`${e.ariaLabel} (Space)`,r.max=String(t.length),r.value=String(t.step),r.ariaValueText=`\
step ${t.step} of ${t.length}`,a.textContent=`${t.step} / ${t.length}`,a.style.minWidth=`${2*String(t.length).length+3}ch`,s.value=String(t.speed)};return t.addEventListener(
"step",m),t.addEventListener("state",m),t.addEventListener("state",u),i.addEventListener("keydown",c=>{!(c.target instanceof HTMLSelectElement||c.key===" "&&c.target!==
r)&&xe(t,c)&&c.preventDefault()}),m(),i}var T=(t,e=2)=>t==null?"-":t.toFixed(e);function on(t,e,r){if(r===0)return[{kind:"start",text:Ro(t),agents:[]}];let n=e.moments[r-1],o=e.moments[r],s=m=>j(m,t.config.n_pursuers),a=me(e,n,o),i=t.conflicts(
r),l=new Set(i.flatMap(m=>m.doomed)),u=a.map(m=>({kind:"capture",text:`${s(m)} is captured`,agents:[m]}));for(let m of ke(n,o))!a.includes(m)&&!l.has(m)&&u.push(
{kind:"end",text:`${s(m)} disappears`,agents:[m]});return u.push(...i.map(({kind:m,text:c,agents:f})=>({kind:m,text:c,agents:f}))),r===t.length&&u.unshift({kind:"\
end",text:Oo(t),agents:[]}),u}function Ro({config:t}){return`${t.n_pursuers} pursuers and ${t.n_evaders} evaders on ${t.rows} x ${t.cols} cells, at most ${t.max_steps}\
 steps`}function Oo(t){let e=Math.round(t.statistics.capture_rate*t.config.n_evaders);return`The episode ends after ${t.length} steps with ${e} of ${t.config.n_evaders}\
 evaders captured`}function sn(t,e,r){let{rows:n,cols:o,n_pursuers:s,fov:a,rules:{interaction:i}}=t;return{rows:n,cols:o,nPursuers:s,fov:a,interaction:i,obstacles:e,moments:r}}function ht(t,e){
return{positions:t.read("last_positions"),alive:t.read("alive"),captured:t.read("captured"),everCaptured:t.read("ever_captured"),actions:e,involved:t.read("invo\
lved"),fault:t.read("fault"),contested:t.conflicts().map(r=>r.cell)}}var mt=class{config;start;recording;actions=[];#e;#r;#n=[[]];constructor(e,r,n){this.config=r,this.start=n,this.#e=e.world(r),this.#e.reset(n),this.#r=[ht(this.#e)],
this.recording=sn(r,this.#e.map(),this.#r)}get length(){return this.actions.length}get over(){return this.#e.over}get statistics(){return{capture_rate:this.#e.read(
"capture_rate")[0]}}conflicts(e){return this.#n[e]}game(e){return e.game(this.#e)}play(e){this.#e.step(e),this.#t(e)}step(e,r,n){let o=this.#e,s=this.config.n_pursuers,
a=new Uint8Array(o.n_agents);for(let i=o.n_turns;i>0&&!o.over;--i){let[l,u]=o.actors;l<s&&(a=o.decide(e.pursuer,[l,Math.min(u,s)],a)),u>s&&(a=o.decide(e.evader,
[Math.max(l,s),u],a)),typeof n=="number"?a[r]=n:l<=r&&r<u&&(a=o.decide(n,[r,r+1],a)),o.playTurn(a)}this.#t(a)}#t(e){this.actions.push(e),this.#r.push(ht(this.#e,
e)),this.#n.push(this.#e.conflicts())}};function an(t,e,r,n){let o=new mt(t,e,r);for(let s of n)o.play(s);return o}var Pe=class{#e;#r;#n=new Map;#t=null;constructor(e){this.#e=e,this.#r=e.world.n_pursuers+e.world.n_evaders;let r=0;e.steps.forEach((n,o)=>n.forEach((s,a)=>{s<0||
(this.#n.set(o*n.length+a,r),r+=s*this.#r)}))}has({pursuer:e,evader:r}){return this.#e.steps[e][r]>=0}actions({pursuer:e,evader:r}){this.#t??=dr(pr("recordings"));
let n=this.#n.get(e*this.#e.names.evader.length+r);return Array.from({length:this.#e.steps[e][r]},(o,s)=>this.#t.slice(n+s*this.#r,n+(s+1)*this.#r))}play(e,r){return an(
e,this.#e.world,{seed:BigInt(this.#e.match_seed)},this.actions(r))}};var Ie=class{element;player=new ve(0,{speed:be,still:ct()});replay=null;#e;#r;#n;#t;#o=h("h2",{class:"match-title"});#s=h("p",{class:"tally numbers"});#a=h("ol",
{class:"words","aria-live":"off","aria-label":"What happened in this step"});#l=h("p",{class:"check small","aria-live":"polite"});#u=null;constructor(e,r){this.#e=
e,this.#r=r,this.#n=new Pe(e);let n=h("canvas",{"aria-label":"The match"});this.#t=new Oe(n,{numbers:!1}),this.element=h("section",{class:"card match-card","ari\
a-label":"Match",id:"match"},h("header",{class:"match-head"},this.#o,this.#s),h("div",{class:"stage"},n),nn(this.player),this.#l,tn(),this.#a),this.player.addEventListener(
"frame",()=>this.replay&&this.#t.show(this.replay.recording,this.player.time)),this.player.addEventListener("step",()=>this.#d()),r.on("pair",()=>this.#c()),r.on(
"play",()=>this.#h()),this.#f()}start(e){this.#u=e,this.#c()}#h(){this.replay&&(this.player.jump(0),ct()||this.player.play(),this.element.scrollIntoView({block:"\
nearest"}))}#c(){this.player.pause(),this.#f();let{pair:e}=this.#r;this.#u&&(this.replay=this.#n.has(e)?this.#n.play(this.#u,e):null,this.element.dataset.played=
this.replay?`${e.pursuer} ${e.evader}`:"",this.element.classList.toggle("without-recording",!this.replay),this.player.length=this.replay?.length??0,this.player.
marks=this.replay?vr(this.replay.recording):[],this.player.jump(0),this.#m(),this.#d())}#m(){let{pursuer:e,evader:r}=this.#r.pair;if(!this.replay){this.#l.textContent=
"The page holds no recording of this match: it would be too large.";return}let n=this.replay.statistics.capture_rate,o=this.#e.first[e][r],s=Math.abs(n-o)<.001;
this.#l.dataset.equal=String(s),this.#l.textContent=s?`Episode 1 of ${this.#e.episodes}: capture rate ${T(n)}, as in the tournament.`:`Episode 1 of ${this.#e.episodes}\
: capture rate ${T(n)}; the tournament had ${T(o)}.`}#f(){let{pursuer:e,evader:r}=this.#r.pair;this.#o.replaceChildren(h("span",{class:"pursuer"},this.#e.names.
pursuer[e])," against ",h("span",{class:"evader"},this.#e.names.evader[r]))}#d(){if(!this.replay){this.#a.replaceChildren(),this.#s.replaceChildren();return}let{
recording:e}=this.replay,r=this.player.step,n=Array.from(e.moments[r].everCaptured).filter(Boolean).length;this.#s.replaceChildren(h("strong",{},n),` of ${this.#e.
world.n_evaders} captured`,h("span",{class:"muted"},` · step ${r}`)),this.#a.replaceChildren(...on(this.replay,e,r).map(o=>h("li",{class:o.kind},o.text)))}};var ye=[[68,1,84],[72,26,108],[71,47,125],[65,68,135],[57,86,140],[49,104,142],[42,120,142],[35,136,142],[31,152,139],[34,168,132],[53,183,121],[84,197,104],[122,
209,81],[165,219,54],[210,226,27],[253,231,37]];function ft(t){let e=Math.min(1,Math.max(0,t))*(ye.length-1),r=Math.min(ye.length-2,Math.floor(e)),n=ye[r],o=ye[r+
1],s=a=>Math.round(n[a]+(e-r)*(o[a]-n[a]));return[s(0),s(1),s(2)]}function dt(t){let[e,r,n]=ft(t).map(o=>((o/255+.055)/1.055)**2.4);return .2126*e+.7152*r+.0722*
n>.179?"#000":"#fff"}var pt=t=>`rgb(${ft(t).join(" ")})`,ln=()=>`linear-gradient(to right, ${ye.map(t=>`rgb(${t.join(" ")})`).join(", ")})`;function un(t,e){let r=h("span",{class:"gradient"});return r.style.backgroundImage=ln(),h("p",{class:"scale-of-rates small muted"},t,r,e)}var Po=1e3,Io=14,No=12,cn=16,hn=t=>t.length>cn?`${t.slice(0,cn-1)}…`:t,Ne=class{element;#e;#r;#n;#t;#o=h("p",{class:"readout numbers","aria-live":"polite"});#s=M(
"g",{class:"marks"});#a;constructor(e,r){this.#e=e,this.#r=r,this.#n=e.standings.pursuer.map(({number:n})=>n),this.#t=e.standings.evader.map(({number:n})=>n),this.#a=
this.#l(),this.element=h("section",{class:"card matrix-card","aria-label":"All matches"},h("header",{},h("h2",{},"All matches"),h("p",{class:"small muted"},"Cap\
ture rate; pursuers in rows, evaders in columns, the best ones first. Click a cell to watch its first episode.")),h("div",{class:"drawing"},this.#a),un("0","1"),
this.#o),r.on("pair",()=>this.#i()),r.on("hover",()=>this.#i()),this.#i()}#l(){let e=this.#n.length,r=this.#t.length,n=Po/Math.max(e,r),o=Math.min(26,Math.max(11,
.78*n)),s=Lo([...this.#e.names.pursuer,...this.#e.names.evader].map(hn),o)+12,a=r*n+s,i=M("svg",{class:"matrix",tabindex:"0",role:"img","aria-label":"Matrix of \
capture rates; arrow keys choose a match, Enter plays it",preserveAspectRatio:"xMidYMin meet",viewBox:`${-s} ${-s} ${a} ${e*n+s}`,onpointermove:u=>this.#r.point(
this.#m(u,n)),onpointerleave:()=>this.#r.point(null),onclick:u=>{let m=this.#m(u,n);m&&this.#r.play(m)},onkeydown:u=>this.#f(u)}),l=this.#n.flatMap((u,m)=>this.#t.
map((c,f)=>{let d=this.#e.capture_rate[u][c];return M("rect",{x:f*n,y:m*n,width:n,height:n,fill:pt(d),"data-pair":`${u} ${c}`})}));return i.append(...l,...this.#u(
n),...this.#h("pursuer",n,o),...this.#h("evader",n,o),this.#s),this.#s.dataset.size=String(n),i.style.minWidth=`${No/o*a}px`,i}#u(e){return Math.max(this.#n.length,
this.#t.length)>Io?[]:this.#n.flatMap((r,n)=>this.#t.map((o,s)=>{let a=this.#e.capture_rate[r][o];return M("text",{x:(s+.5)*e,y:(n+.5)*e,fill:dt(a),"font-size":Math.
min(30,.38*e),class:"in-cell"},T(a))}))}#h(e,r,n){return(e==="pursuer"?this.#n:this.#t).map((s,a)=>{let i=(a+.5)*r,l=e==="pursuer"?{x:-6,y:i,"text-anchor":"end"}:
{transform:`translate(${i} -6) rotate(-90)`,"text-anchor":"start"};return M("text",{...l,class:`name ${this.#c(e,s).kind}`,"font-size":n,"data-name":`${e} ${s}`},
hn(this.#e.names[e][s]))})}#c(e,r){return this.#e.standings[e].find(n=>n.number===r)}#m(e,r){let n=new DOMPoint(e.clientX,e.clientY).matrixTransform(this.#a.getScreenCTM().
inverse()),o=this.#n[Math.floor(n.y/r)],s=this.#t[Math.floor(n.x/r)];return o===void 0||s===void 0||n.x<0||n.y<0?null:{pursuer:o,evader:s}}#f(e){let n={ArrowUp:[
-1,0],ArrowDown:[1,0],ArrowLeft:[0,-1],ArrowRight:[0,1]}[e.key];if(e.key==="Enter")this.#r.play(this.#r.pair);else if(n)this.#d(n);else return;e.preventDefault(),
e.stopPropagation()}#d([e,r]){let{pursuer:n,evader:o}=this.#r.pair,s=this.#n[this.#n.indexOf(n)+e],a=this.#t[this.#t.indexOf(o)+r];s!==void 0&&a!==void 0&&this.#r.
select({pursuer:s,evader:a})}#i(){let{pair:e,hover:r}=this.#r,n=Number(this.#s.dataset.size),o=({pursuer:a,evader:i},l)=>M("rect",{class:l,x:this.#t.indexOf(i)*
n,y:this.#n.indexOf(a)*n,width:n,height:n});this.#s.replaceChildren(o(e,"selected-halo"),o(e,"selected"),...r?[o(r,"hovered")]:[]);let s=r??e;for(let a of this.#a.
querySelectorAll("[data-name]")){let i=[`pursuer ${s.pursuer}`,`evader ${s.evader}`].includes(a.dataset.name);a.classList.toggle("about",i)}this.#o.replaceChildren(
...this.#p(s))}#p({pursuer:e,evader:r}){let{names:n,capture_rate:o,lowest:s,highest:a,length:i,episodes:l}=this.#e,u=T(o[e][r]),m=T(s[e][r]),c=T(a[e][r]);return[
h("span",{},h("span",{class:"pursuer"},n.pursuer[e])," against ",h("span",{class:"evader"},n.evader[r])),h("span",{},h("strong",{},u),h("span",{class:"small mut\
ed"},` captured; ${m} to ${c} in ${l} episodes, ${i[e][r].toFixed(0)} steps on average`))]}};function Lo(t,e){let r=document.createElement("canvas").getContext(
"2d");return r.font=`700 ${e}px ${getComputedStyle(document.body).fontFamily}`,Math.max(...t.map(n=>r.measureText(n).width))}var mn=(t,e)=>t?.pursuer===e?.pursuer&&t?.evader===e?.evader,Le=class extends EventTarget{#e;#r=null;constructor(e){super(),this.#e=e}get pair(){return this.#e}get hover(){
return this.#r}select(e){mn(e,this.#e)||(this.#e=e,this.dispatchEvent(new Event("pair")))}play(e){this.select(e),this.dispatchEvent(new Event("play"))}point(e){
mn(e,this.#r)||(this.#r=e,this.dispatchEvent(new Event("hover")))}on(e,r){this.addEventListener(e,r)}};function yt(t,e,r){let n=t.standings[e].map(a=>$o(t,e,a,r)),o=e==="pursuer"?"Mean capture rate":"Mean escape rate",s=["Rank","Name","Score","Best, worst"];return h(
"section",{class:"card standings","aria-label":`Standings of ${e}s`},h("header",{},h("h2",{},h("span",{class:e},`${e[0].toUpperCase()}${e.slice(1)}s`)),h("p",{class:"\
small muted"},`${o} against ${t.names[rt(e)].length} opponents, with 95 % interval`)),h("div",{class:"scroll",tabindex:"0"},h("table",{},h("thead",{},h("tr",{},
...s.map(a=>h("th",{scope:"col"},a)))),h("tbody",{},...n))))}function $o(t,e,r,n){let{kind:o,name:s,file:a,rank:i,number:l}=r,u=h("tr",{class:o,"data-number":l},
h("td",{class:"rank numbers"},i||"–"),h("th",{scope:"row",title:a},h("span",{class:"who",title:s},s),h("span",{class:"kind small muted"},o)),h("td",{class:"nu\
mbers score"},zo(r,e),Uo(r)),h("td",{class:"matches"},...["best","worst"].map(c=>Fo(t,e,r,c,n)))),m=()=>{u.classList.toggle("about",l===(n.hover??n.pair)[e])};return n.
on("pair",m),n.on("hover",m),m(),u}function Uo({score:t,low:e,high:r}){let n=e===null||r===null?"":`${T(e)} – ${T(r)}`;return h("span",{class:"score-text"},h(
"strong",{},T(t)),h("span",{class:"small muted"},n))}function zo({score:t,low:e,high:r},n){let o=h("span",{class:`filled of-${n}`}),s=h("span",{class:"whisker"});
return o.style.width=`${100*t}%`,e!==null&&r!==null&&(s.style.left=`${100*e}%`,s.style.width=`${100*(r-e)}%`),h("span",{class:"bar","aria-hidden":"true"},o,s)}function Fo(t,e,r,n,o){
let s=r[n],a=e==="pursuer"?{pursuer:r.number,evader:s}:{pursuer:s,evader:r.number},i=t.names[rt(e)][s],l=t.capture_rate[a.pursuer][a.evader],u=T(e==="pursuer"?l:
1-l);return h("button",{type:"button",class:"to-match",title:`Watch the ${n} match: against ${i}, ${u}`,"aria-label":`Watch the ${n} match of ${r.name}: against\
 ${i}, ${u}`,onclick:()=>o.play(a)},n==="best"?"▲ ":"▼ ",i)}function fn({votes:t}){let e=Object.keys(t);if(!e.length)return[];let r=e.map(n=>{let o=Object.entries(
t[n]),s=o.reduce((i,[,l])=>i+l,0),a=o.map(([i,l])=>{let u=h("span",{class:"filled"});return u.style.width=`${100*l/s}%`,h("div",{class:"vote"},h("span",{},i),h(
"span",{class:"bar","aria-hidden":"true"},u),h("span",{class:"numbers"},`${l} of ${s}`))});return h("tr",{},h("th",{scope:"row"},n),h("td",{},...a))});return[h(
"section",{class:"card votes","aria-label":"Predictions"},h("header",{},h("h2",{},"How the class voted"),h("p",{class:"small muted"},"Predictions of the course:\
 the first choice of each student, before the experiment.")),h("table",{},h("tbody",{},...r)))]}function dn(t){if(!t.length)return[];let e=t.map(({file:r,reason:n})=>h(
"div",{class:"refusal"},h("dt",{},r),h("dd",{},n)));return[h("section",{class:"card refused","aria-label":"Refused"},h("header",{},h("h2",{},`Refused (${t.length}\
)`),h("p",{class:"small muted"},"These did not play, or broke a rule while they played; their matches count for no one.")),h("dl",{},...e))]}var I=yr(),[Do]=I.standings.pursuer,$e=new Le({pursuer:Do.number,evader:I.standings.evader[0].number}),J=new Ie(I,$e);function Wo({world:t,episodes:e,seed:r,matrixworld:n}){
return`${t.n_pursuers} pursuers and ${t.n_evaders} evaders on ${t.rows} x ${t.cols} cells, at most ${t.max_steps} steps · ${e} episodes a pair · seed ${r} · m\
atrixworld ${n}`}var Bo=["Every pursuer played every evader from the same starts. A score is a mean over all opponents, scripts included. Scripts are the packag\
e's own policies, for comparison; they have no rank.","A rank such as 2 to 5 means that these episodes cannot tell which of these ranks is the true one: the dif\
ference to some others is within chance. Each range misses the true rank with a probability of at most 5 %.","Keys: Space plays, ← and → step, D changes light a\
nd dark; in the matrix arrow keys choose a match and Enter plays it."];document.getElementById("page").replaceWith(ar(I.title,Wo(I)),h("main",{class:"stages"},h(
"div",{class:"tables"},yt(I,"pursuer",$e),yt(I,"evader",$e)),new Ne(I,$e).element,J.element),...fn(I),...dn(I.refusals),h("section",{class:"card reading","aria-\
label":"How to read this page"},h("h2",{},"How to read this page"),...Bo.map(t=>h("p",{},t))));document.addEventListener("keydown",t=>{let e=t.target instanceof
HTMLSelectElement||t.target instanceof HTMLInputElement,r=t.target instanceof HTMLButtonElement&&(t.key===" "||t.key==="Enter");if(!(e||r||t.defaultPrevented||t.
ctrlKey||t.metaKey||t.altKey)){if(t.key.toLowerCase()==="d")Je();else if(!xe(J.player,t))return;t.preventDefault()}});Object.assign(window,{matrixworldClass:{get replay(){
return J.replay},get step(){return J.player.step}}});requestAnimationFrame(()=>setTimeout(()=>{rr().then(t=>{J.start(t),document.body.dataset.ready="true"},t=>{
J.element.prepend(h("p",{class:"problem",role:"alert"},`The engine does not start here: ${String(t)}`)),document.body.dataset.ready="true"})}));})();
