/* built from web/ by "npm run build"; sources 2a1fae05abaff1e2366678a422ba5c37c6f4bd927ab4e626582e6e45a0303b3d */
"use strict";(()=>{var Lr={SIMULTANEOUS:0,SWARM_TURNS:1,AGENT_TURNS:2},Je={DISAPPEAR:0,REACH:1,BOUNCE:2},Nr={OCCUPATION:0,SURROUND:1},Ir={FAULT:0,INVOLVED:1};var Fr=["obstacle","teammate","adversary"],xn=["vertex","edge","chain"],Dr=["turn","kind","form","first","second","row","col","at_fault","held","doomed"],Sn=["p\
ursuer_{number}","evader_{number}"],Wr={obstacle:"{first} ran into the obstacle or border at {cell}",vertex:"{first} and {second} both headed for {cell}",edge:"\
{first} and {second} meant to swap, {first} to {cell}",chain:"{first} headed for {cell}, where {second} had to stay"},Xe={"both held":"both bounce","both doomed":"\
both disappear",held:"{agent} bounces",doomed:"{agent} disappears",none:"nobody is stopped"},Ur="{event}: {outcome}",Mn={random:"any action, all equally likely",
still:"always stays",chaser:"moves to where the nearest adversary in view is nearest",fleer:"moves to where the nearest adversary in view is farthest","clumsy-c\
haser":"a chaser that takes any action in half of the steps",hunter:"a chaser of the nearest adversary in view to which no teammate in view is nearer",surrounder:"\
a chaser of the nearest free cell beside an adversary without a teammate","clumsy-fleer":"a fleer that takes any action in half of the steps",dodger:"moves to w\
here all adversaries in view together are farthest","team-surrounder":"shares the free cells beside adversaries with its teammates, and searches","careful-rando\
m":"as random, but takes only moves that right of way allows","careful-chaser":"as chaser, but takes only moves that right of way allows","careful-fleer":"as fl\
eer, but takes only moves that right of way allows","careful-clumsy-chaser":"as clumsy-chaser, but takes only moves that right of way allows","careful-hunter":"\
as hunter, but takes only moves that right of way allows","careful-surrounder":"as surrounder, but takes only moves that right of way allows","careful-clumsy-fl\
eer":"as clumsy-fleer, but takes only moves that right of way allows","careful-dodger":"as dodger, but takes only moves that right of way allows","careful-team-\
surrounder":"as team-surrounder, but takes only moves that right of way allows"},de={adversary:"distance to the nearest adversary (0 to 2, in half views)",pressure:"\
sum over adversaries of 1 / (1 + moves)^2 (0 or more)",unclaimed:"distance to the nearest adversary to which no teammate is nearer than the agent is now; withou\
t one, to the nearest adversary (0 to 2, in half views)",open_side:"distance to the nearest cell beside an adversary that holds no obstacle and no teammate (0 t\
o 2, in half views)",teammate:"distance to the nearest teammate (0 to 2, in half views)",exits:"share of the cells around that are no obstacle (0 to 1)",room:"d\
istance to the nearest obstacle to the north, east, south or west (0 to 1, in half views)",must_yield:"1 if right of way forbids the move (0 to 1)",ahead:"1 if \
it is the direction that the agent draws for each 12 steps (0 to 1)",search:"1 if it leads on along the way on which an agent of team-surrounder searches the gr\
id (0 to 1)"},Hr={free:".GS",blocked:"#@OTW"};var Oe=1+Dr.length;function Qe(n,e){return n.replace(/\{(\w+)\}/g,(t,r)=>String(e[r]))}function B(n,e){return n<e?Qe(Sn[0],{number:n}):Qe(Sn[1],{number:n-e})}function li(n,e){
let[t,r,s,o,a,i,l,...c]=Array.from(n),d=a<0?[o]:[o,a],[m,h,p]=c.map(b=>d.filter((v,x)=>b>>x&1)),f=d.map(b=>B(b,e)),y=Qe(Wr[a<0?"obstacle":xn[s]],{first:f[0],second:f[f.
length-1],cell:`(${i}, ${l})`}),g=Qe(Ur,{event:y,outcome:ci(d.length,h,p,e)});return{kind:Fr[r],form:xn[s],agents:d,cell:[i,l],at_fault:m,held:h,doomed:p,turn:t,
text:g}}function ci(n,e,t,r){if(n===2&&e.length===2)return Xe["both held"];if(n===2&&t.length===2)return Xe["both doomed"];let s=o=>a=>Qe(Xe[o],{agent:B(a,r)});
return[...e.map(s("held")),...t.map(s("doomed"))].join(", ")||Xe.none}function Mt(n,e){let t=[];for(let r=0;r<n.length;r+=Oe)t.push(li(n.subarray(r+1,r+Oe),e));
return t}var me=class extends Error{name="EngineError"};function k(n,e,t){let r=typeof t=="string"?`'${t}'`:typeof t=="object"?JSON.stringify(t):String(t);return new me(
`${n}: expected ${e}, got ${r}`)}var ke=class{bytes;constructor(e){this.bytes=e}},Br=0,Tn=[Uint8Array,Uint8Array,Int32Array,BigInt64Array,BigUint64Array,Float32Array,Float64Array],zr=4,Gr=4,ui=new TextEncoder,
di=new TextDecoder;function mi(n){for(let e=Tn.length-1;e>Br;--e)if(n instanceof Tn[e])return e;throw new TypeError("array: expected a typed array of the engine\
's numbers, got another")}function An(n){return new Uint8Array(n.buffer,n.byteOffset,n.byteLength)}function hi(n){return ui.encode(`${n}\0`)}var En=class{engine;addresses=[];constructor(e){
this.engine=e}copy(e){let t=this.engine._malloc(Math.max(e.length,1));if(t===0)throw new me("memory: expected room for the arguments, got none");return this.addresses.
push(t),this.engine.HEAPU8.set(e,t),t}text(e){return this.copy(hi(e))}arrays(e){let t=Object.entries(e),r=t.flatMap(([o,a])=>{let i=a instanceof ke,l=i?a.bytes:
a;return[this.text(o),i?Br:mi(l),l.length,this.copy(An(l))]}),s=this.copy(An(Int32Array.from(r)));return this.copy(An(Int32Array.of(t.length,s)))}free(){for(let e of this.
addresses)this.engine._free(e)}};function jr(n,e){let t=n.HEAPU8;return di.decode(t.subarray(e,t.indexOf(0,e)))}function Re(n){let e=new Int32Array(n.HEAPU8.buffer),
t=n._last_outputs()/zr,r=e[t+1]/zr,s={};for(let o=r;o<r+e[t]*Gr;o+=Gr){let a=Tn[e[o+1]],i=e[o+2]*a.BYTES_PER_ELEMENT,l=e[o+3];s[jr(n,e[o])]=new a(n.HEAPU8.slice(
l,l+i).buffer)}return s}function oe(n,e){let t=new En(n);try{let r=e(t);if(r===0)throw new me(jr(n,n._last_error()));return r}finally{t.free()}}var pi=2**31-1,Vr=["none","gru"],fi=2n**64n-1n,gi=34028234663852886e22;function U(n,e){if(typeof e!="number"||!Number.isInteger(e)||Math.abs(e)>pi)throw k(n,"an\
 integer",e);return Int32Array.of(e)}function At(n,e){if(typeof e!="boolean")throw k(n,"true or false",e);return new ke(Uint8Array.of(Number(e)))}function he(n,e,t){
let r=typeof e=="string"&&Object.hasOwn(t,e)?t[e]:void 0;if(r===void 0)throw k(n,`one of ${Object.keys(t).join(", ")}`,e);return Int32Array.of(r)}function On(n,e){
if(typeof e!="number"||!(Math.abs(e)<=gi))throw k(n,"a finite number",e);return e}function et(n,e){let r=typeof e=="bigint"||typeof e=="number"&&Number.isSafeInteger(
e)?BigInt(e):-1n;if(r<0n||r>fi)throw k(n,"an integer from 0 to 2^64 - 1",e);return BigUint64Array.of(r)}function yi(n){return{"rules.interaction":he("interactio\
n",n.interaction,Lr),"rules.obstacle":he("obstacle",n.obstacle,Je),"rules.teammate":he("teammate",n.teammate,Je),"rules.evader":he("evader",n.evader,Je),"rules.\
pursuer":he("pursuer",n.pursuer,Je),"rules.capture":he("capture",n.capture,Nr),"rules.captured_disappear":At("captured_disappear",n.captured_disappear)}}function qr(n,e){
let t=typeof e=="number"?[e,e,e]:e;if(!Array.isArray(t)||t.length!==3)throw k(n,"1 or 3 numbers",e);return Float32Array.from(t,r=>On(n,r))}function vi(n){let e=(t,r)=>Float32Array.
of(On(t,n[t]),On(r,n[r]));return{"rewards.capture":e("pursuer_capture","evader_capture"),"rewards.neighbor":e("pursuer_neighbor","evader_neighbor"),"rewards.ste\
p":e("pursuer_step","evader_step"),"rewards.pursuer_collide":qr("pursuer_collide",n.pursuer_collide),"rewards.evader_collide":qr("evader_collide",n.evader_collide),
"rewards.blame":he("blame",n.blame,Ir),"rewards.capture_repeats":At("capture_repeats",n.capture_repeats)}}function Zr(n){if(n===void 0||typeof n=="number")return new Uint8Array(
0);if(n instanceof Uint8Array)return n;let{free:e,blocked:t}=Hr;for(let[r,s]of n.entries()){if(s.length!==n[0]?.length)throw k(`map, row ${r}`,`${n[0]?.length} \
cells as in row 0`,s.length);let o=[...s].find(a=>!e.includes(a)&&!t.includes(a));if(o)throw k(`map, row ${r}`,`'${e}' (free) or '${t}' (obstacle)`,o)}return Uint8Array.
from([...n.join("")],r=>Number(t.includes(r)))}function Jr(n,e){if(!Array.isArray(n))return;let t=[n.length,n[0]?.length??0];if(!(t[0]===e.rows&&t[1]===e.cols))
throw k("obstacle map",`shape (${e.rows}, ${e.cols}), the rows and cols`,t)}function Ce(n){Jr(n.obstacles,n);let e=typeof n.obstacles=="number"?n.obstacles:0;return{
...yi(n.rules),...vi(n.rewards),rows:U("rows",n.rows),cols:U("cols",n.cols),n_pursuers:U("n_pursuers",n.n_pursuers),n_evaders:U("n_evaders",n.n_evaders),fov:U("\
fov",n.fov),diagonal:At("diagonal",n.diagonal),max_steps:U("max_steps",n.max_steps),density:Float64Array.of(e),map:Zr(n.obstacles)}}function Kr(n,e){return Int32Array.
from((e??[]).flat(),t=>U(n,t)[0])}function Xr(n,e){return Jr(n.obstacles,e),{seed:et("seed",n.seed??0n),episode:et("episode",n.episode??0),pursuers:Kr("pursuers",
n.pursuers),evaders:Kr("evaders",n.evaders),map:Zr(n.obstacles)}}function Tt(n){return{actions:Int32Array.from(n,e=>U("actions",e)[0])}}var Yr=Object.keys(de);function kn(n){
let e=Yr.indexOf(n);if(e<0)throw k("inputs",`names of ${Yr.join(", ")}`,n);return e}function pe(n){if(typeof n=="string"){if(!Object.hasOwn(Mn,n))throw k("polic\
y",`one of ${Object.keys(Mn).join(", ")}`,n);return{script:new TextEncoder().encode(n)}}if(n.kind!=="cells")return{inputs:Int32Array.from(n.inputs,e=>kn(e)),hidden:Int32Array.
from(n.kind==="rating"?n.hidden:[],e=>U("hidden",e)[0]),length:U("length",n.kind==="program"?n.length:0),mask:new TextEncoder().encode(n.mask),genome:n.genome};
if(n.activation!=="relu"&&n.activation!=="tanh")throw k("activation","'relu' or 'tanh'",n.activation);if(!Vr.includes(n.memory))throw k("memory",`one of ${Vr.join(
", ")}`,n.memory);return{hidden:Int32Array.from(n.hidden,e=>U("hidden",e)[0]),activation:new TextEncoder().encode(n.activation),sampled:At("sampled",n.sampled),
memory:new TextEncoder().encode(n.memory),genome:n.genome}}var bi=["first_turn","terminated","truncated"];function Qr(n){let e={...n};for(let t of bi)e[t]=new ke(
n[t]);return e}var es="statistics.",Et=class{config;seed;episode;n_agents;statistics;first_conflict;constructor(e,t,r,s){this.config=e,this.seed=t,this.episode=r,this.n_agents=
e.n_pursuers+e.n_evaders,this.statistics=xi(ts(s)),Object.assign(this,s),this.first_conflict=wi(this.conflict_table,this.length)}get length(){return this.actions.
length/this.n_agents}conflicts(e){this.check(e);let t=this.first_conflict[e],r=this.first_conflict[e+1],s=this.conflict_table.subarray(t*Oe,r*Oe);return Mt(s,this.
config.n_pursuers)}seek(e,t,r){this.check(t),(!(e.seed===this.seed&&e.episode===BigInt(this.episode))||e.turn!==0||e.steps>t)&&e.reset({seed:this.seed,episode:this.
episode});for(let o=e.steps;o<t;++o){let a=this.actions.subarray(o*this.n_agents,(o+1)*this.n_agents);r?e.replay(a,{pursuer:r.pursuers,evader:r.evaders}):e.step(
a)}}check(e){if(!(Number.isInteger(e)&&e>=0&&e<=this.length))throw k("step",`0 to ${this.length}`,e)}};function wi(n,e){let t=new Int32Array(e+2);for(let r=0;r<
n.length;r+=Oe)++t[n[r]+1];for(let r=1;r<t.length;++r)t[r]+=t[r-1];return t}function xi(n){let e=["capture_rate","ever_capture_rate","captured_fraction","length"];
return Object.fromEntries(Object.entries(n).map(([t,r])=>[t,e.includes(t)?Number(r[0]):r]))}var ts=n=>Object.fromEntries(Object.entries(n).flatMap(([e,t])=>e.startsWith(
es)?[[e.slice(es.length),t]]:[]));function ns(n,e,t,r){let s=[Ce(t.config),pe(t.pursuers),pe(t.evaders),r];return oe(n,o=>{let[a,i,l,c]=s.map(d=>o.arrays(d));return n[e](
a,i,l,c)}),Re(n)}function rs(n,e,t,r){let s={seed:et("seed",t),episode:et("episode",r)};return new Et(e.config,t,r,ns(n,"_play_match",e,s))}function ss(n,e,t,r){
if(!Number.isInteger(r)||r<1)throw k("n_episodes","at least 1",r);let s=ns(n,"_play_rollout",e,{...t,n_episodes:Int32Array.of(r)});return ts(s)}var Si=7e6,Mi=new FinalizationRegistry(([n,e])=>n._states_free(e));function Ai({rules:n,rows:e,cols:t,obstacles:r,diagonal:s,n_pursuers:o,n_evaders:a}){let i=typeof r==
"number"||n.obstacle==="REACH"?0:r.join("").split("#").length-1,l=e*t-i,c=[n.obstacle,n.teammate,n.pursuer].includes("DISAPPEAR"),d=n.capture==="SURROUND"||n.evader===
"REACH",m=n.interaction==="AGENT_TURNS",h=(y,g)=>Array.from({length:g},(b,v)=>m?y:(y+v)/(v+1)).reduce((b,v)=>b*v,1),p=h(l+Number(c),o)*h(l*(1+Number(d))+2,a);return{
SIMULTANEOUS:[o+a],SWARM_TURNS:[o,a],AGENT_TURNS:Array(o+a).fill(1)}[n.interaction].reduce((y,g)=>y+p*(s?9:5)**g,0)}function os(n){return typeof n.obstacles=="n\
umber"&&n.obstacles>0?"obstacles are drawn anew in each episode":Ai(n)>Si?"the world is too large to be solved on the page":""}var Rn=class{value;teams;matrix;n_actions;constructor(e,t){
let{matrix:r,rows:s,cols:o,value:a,agents:i}=t,[l,c]=e.actors,d=Array.from(i).filter(h=>l<=h&&h<c),m=h=>h<e.config.n_pursuers;this.value=a[0],this.matrix=r,this.
n_actions=e.n_actions,this.teams=[{agents:d.filter(m),play:s},{agents:d.filter(h=>!m(h)),play:o}]}marginal(e){let t=this.teams.find(({agents:o})=>o.includes(e));
if(!t)return null;let r=this.n_actions**(t.agents.length-1-t.agents.indexOf(e)),s=Array(this.n_actions).fill(0);return t.play.forEach((o,a)=>s[Math.floor(a/r)%this.
n_actions]+=o),s}lost(e){let[t,r]=this.teams.map(({agents:l})=>l.reduce((c,d)=>c*this.n_actions+e[d],0)),[s,o]=this.teams.map(({play:l})=>l),a=o.reduce((l,c,d)=>l+
c*this.matrix[t*o.length+d],0),i=s.reduce((l,c,d)=>l+c*this.matrix[d*o.length+r],0);return[Math.max(0,this.value-a),Math.max(0,i-this.value)]}},as=60,tt=class{config;payoff;engine;states;n_turns;values;constructor(e,t,r){
this.engine=e,this.config=t,this.payoff=r,this.states=oe(e,i=>e._states_new(i.arrays(Ce(t)))),Mi.register(this,[e,this.states]);let s={SIMULTANEOUS:1,SWARM_TURNS:2,
AGENT_TURNS:t.n_pursuers+t.n_evaders};this.n_turns=s[t.rules.interaction];let{payoffs:o}=this.call(()=>e._states_payoffs(this.states)),a=o;this.values=[[r==="ca\
pture-rate"?a:a.fill(0)]]}goBack(){let e=this.values.at(-1)[0],t=[];for(let s=this.n_turns-1;s>=0;s--){let o=t[s+1]??e;t[s]=this.backup(s,{next:o})}this.payoff===
"capture-time"&&(t[0]=t[0].map((s,o)=>o===this.config.n_evaders?0:s-1)),this.values.push(t);let r=this.payoff==="capture-rate"?this.config.max_steps:Math.min(this.
config.max_steps,as);return this.values.length<=r&&t[0].some((s,o)=>s!==e[o])}backup(e,t){return this.call(r=>this.engine._states_backup(this.states,e,r.arrays(
t))).values}game(e){let t=this.config.max_steps-e.steps,{turn:r}=e,s=r+1===this.n_turns,o=t>0?this.values[Math.min(t-Number(s),this.values.length-1)]?.[s?0:r+1]:
void 0;if(!o)return null;let a=this.call(i=>this.engine._states_game(this.states,e.address,i.arrays({next:o})));return a.agents.length?new Rn(e,a):null}call(e){
return oe(this.engine,e),Re(this.engine)}};var is=new FinalizationRegistry(([n,e])=>n._world_free(e)),nt=class{config;n_agents;n_actions;engine;at;freed=!1;constructor(e,t){this.engine=e,this.config=t,this.
n_agents=t.n_pursuers+t.n_evaders,this.n_actions=t.diagonal?9:5,this.at=oe(e,r=>e._world_new(r.arrays(Ce(t)))),is.register(this,[e,this.at],this)}free(){this.freed||
(this.freed=!0,is.unregister(this),this.engine._world_free(this.at))}get address(){if(this.freed)throw k("world","one that is in use","one that was freed");return this.
at}reset(e={}){let t=Xr(e,this.config);this.call(r=>this.engine._world_reset(this.address,r.arrays(t)))}step(e){let t=Tt(e);this.call(r=>this.engine._world_step(
this.address,r.arrays(t)))}playTurn(e){let t=Tt(e);this.call(r=>this.engine._world_play_turn(this.address,r.arrays(t)))}decide(e,t,r){let{n_pursuers:s}=this.config,
o={pursuer:[0,s],evader:[s,this.n_agents]},[a,i]=typeof t=="string"?o[t]:t;if(r.length!==this.n_agents)throw k("actions",String(this.n_agents),r.length);let l=[
pe(e),Tt(r)],{actions:c}=this.call(d=>this.engine._world_decide(this.address,d.arrays(l[0]),a,i,d.arrays(l[1])));return Uint8Array.from(c)}replay(e,t){let r=o=>typeof o!=
"string"&&o.kind==="cells"&&o.memory!=="none";if(!r(t.pursuer)&&!r(t.evader))return this.step(e);let{n_pursuers:s}=this.config;for(let o=this.n_turns;o>0;--o){let[
a,i]=this.actors;a<s&&this.decide(t.pursuer,[a,Math.min(i,s)],e),i>s&&this.decide(t.evader,[Math.max(a,s),i],e),this.playTurn(e)}}get n_turns(){return this.turnNumbers()[1]}get turn(){
return this.turnNumbers()[0]}get actors(){let[,,e,t]=this.turnNumbers();return[e,t]}turnNumbers(){return this.call(()=>this.engine._world_turn(this.address)).turn}get steps(){
return this.read("steps")[0]}get seed(){return this.read("seed")[0]}get episode(){return this.read("episode")[0]}get over(){return this.read("terminated")[0]===
1||this.read("truncated")[0]===1}read(e){return this.call(t=>this.engine._world_read(this.address,t.text(e)))[e]}view(e){let t=3*this.config.fov**2;return this.
read("views").slice(e*t,(e+1)*t)}map(){return this.read("state").slice(2*this.config.rows*this.config.cols)}conflicts(){return Mt(this.conflictTable(),this.config.
n_pursuers)}conflictTable(){return this.call(()=>this.engine._world_conflicts(this.address)).conflict_table}answer(e,t){let r=pe(e),{logits:s,memory:o}=this.call(
l=>this.engine._world_logits(this.address,l.arrays(r),t)),a=s,i=this.decide(e,[t,t+1],new Uint8Array(this.n_agents))[t];return{logits:a,probabilities:Ti(a),action:i,
memory:o}}rate(e,t){let r=pe(e),{ratings:s,refused:o}=this.call(c=>this.engine._world_rate(this.address,c.arrays(r),t)),a=this.read("inputs"),i=a.length/this.n_agents/
this.n_actions,l=c=>Float32Array.from({length:this.n_actions},(d,m)=>a[(t*this.n_actions+m)*i+c]);return{inputs:e.inputs.map(c=>l(kn(c))),ratings:s,refused:o}}snapshot(){
return this.call(()=>this.engine._world_snapshot(this.address))}restore(e){let t=Qr(e);this.call(r=>this.engine._world_restore(this.address,r.arrays(t)))}call(e){
return oe(this.engine,e),Re(this.engine)}};function Ti(n){let e=Math.max(...n),t=Array.from(n,s=>Math.exp(s-e)),r=t.reduce((s,o)=>s+o,0);return Float32Array.from(
t,s=>s/r)}var Cn=class{compiled;constructor(e){this.compiled=e}world(e){return new nt(this.compiled,e)}solution(e,t="capture-rate"){return new tt(this.compiled,e,t)}match(e,t,r,s,o=0){
return rs(this.compiled,{config:e,pursuers:t,evaders:r},s,o)}rollouts(e,t,r,s,o){return ss(this.compiled,{config:e,pursuers:t,evaders:r},s,o)}},ls;function Ot(n=globalThis.
matrixworldEngine){return ls??=Ei(n),ls}async function Ei(n){if(!n)throw new Error("matrixworldEngine: expected the script engine.js before this one, got none");
let e=Uint8Array.from(atob(n.binary),t=>t.charCodeAt(0));return new Cn(await n({wasmBinary:e}))}var F=Uint8Array,$e=Uint16Array,Oi=Int32Array,cs=new F([0,0,0,0,0,0,0,0,1,1,1,1,2,2,2,2,3,3,3,3,4,4,4,4,5,5,5,5,0,0,0,0]),us=new F([0,0,0,0,1,1,2,2,3,3,4,4,5,5,
6,6,7,7,8,8,9,9,10,10,11,11,12,12,13,13,0,0]),ki=new F([16,17,18,0,8,7,9,6,10,5,11,4,12,3,13,2,14,1,15]),ds=function(n,e){for(var t=new $e(31),r=0;r<31;++r)t[r]=
e+=1<<n[r-1];for(var s=new Oi(t[30]),r=1;r<30;++r)for(var o=t[r];o<t[r+1];++o)s[o]=o-t[r]<<5|r;return{b:t,r:s}},ms=ds(cs,2),hs=ms.b,Ri=ms.r;hs[28]=258,Ri[258]=28;
var ps=ds(us,0),Ci=ps.b,Qu=ps.r,_n=new $e(32768);for(E=0;E<32768;++E)X=(E&43690)>>1|(E&21845)<<1,X=(X&52428)>>2|(X&13107)<<2,X=(X&61680)>>4|(X&3855)<<4,_n[E]=((X&
65280)>>8|(X&255)<<8)>>1;var X,E,rt=(function(n,e,t){for(var r=n.length,s=0,o=new $e(e);s<r;++s)n[s]&&++o[n[s]-1];var a=new $e(e);for(s=1;s<e;++s)a[s]=a[s-1]+o[s-
1]<<1;var i;if(t){i=new $e(1<<e);var l=15-e;for(s=0;s<r;++s)if(n[s])for(var c=s<<4|n[s],d=e-n[s],m=a[n[s]-1]++<<d,h=m|(1<<d)-1;m<=h;++m)i[_n[m]>>l]=c}else for(i=
new $e(r),s=0;s<r;++s)n[s]&&(i[s]=_n[a[n[s]-1]++]>>15-n[s]);return i}),st=new F(288);for(E=0;E<144;++E)st[E]=8;var E;for(E=144;E<256;++E)st[E]=9;var E;for(E=256;E<
280;++E)st[E]=7;var E;for(E=280;E<288;++E)st[E]=8;var E,fs=new F(32);for(E=0;E<32;++E)fs[E]=5;var E;var $i=rt(st,9,1);var Pi=rt(fs,5,1),$n=function(n){for(var e=n[0],t=1;t<n.length;++t)n[t]>e&&(e=n[t]);return e},H=function(n,e,t){var r=e/8|0;return(n[r]|n[r+1]<<8)>>(e&7)&t},Pn=function(n,e){
var t=e/8|0;return(n[t]|n[t+1]<<8|n[t+2]<<16)>>(e&7)},_i=function(n){return(n+7)/8|0},Li=function(n,e,t){return(e==null||e<0)&&(e=0),(t==null||t>n.length)&&(t=n.
length),new F(n.subarray(e,t))};var Ni=["unexpected EOF","invalid block type","invalid length/literal","invalid distance","stream finished","no stream handler",,"no callback","invalid UTF-8 da\
ta","extra field too long","date not in range 1980-2099","filename too long","stream finishing","invalid zip data"],z=function(n,e,t){var r=new Error(e||Ni[n]);
if(r.code=n,Error.captureStackTrace&&Error.captureStackTrace(r,z),!t)throw r;return r},Ii=function(n,e,t,r){var s=n.length,o=r?r.length:0;if(!s||e.f&&!e.l)return t||
new F(0);var a=!t,i=a||e.i!=2,l=e.i;a&&(t=new F(s*3));var c=function($r){var Pr=t.length;if($r>Pr){var _r=new F(Math.max(Pr*2,$r));_r.set(t),t=_r}},d=e.f||0,m=e.
p||0,h=e.b||0,p=e.l,f=e.d,y=e.m,g=e.n,b=s*8;do{if(!p){d=H(n,m,1);var v=H(n,m+1,3);if(m+=3,v)if(v==1)p=$i,f=Pi,y=9,g=5;else if(v==2){var _=H(n,m,31)+257,J=H(n,m+
10,15)+4,W=_+H(n,m+5,31)+1;m+=14;for(var re=new F(W),yn=new F(19),I=0;I<J;++I)yn[ki[I]]=H(n,m+I*3,7);m+=J*3;for(var Tr=$n(yn),ri=(1<<Tr)-1,si=rt(yn,Tr,1),I=0;I<
W;){var Er=si[H(n,m,ri)];m+=Er&15;var x=Er>>4;if(x<16)re[I++]=x;else{var Te=0,St=0;for(x==16?(St=3+H(n,m,3),m+=2,Te=re[I-1]):x==17?(St=3+H(n,m,7),m+=3):x==18&&(St=
11+H(n,m,127),m+=7);St--;)re[I++]=Te}}var Or=re.subarray(0,_),se=re.subarray(_);y=$n(Or),g=$n(se),p=rt(Or,y,1),f=rt(se,g,1)}else z(1);else{var x=_i(m)+4,A=n[x-4]|
n[x-3]<<8,T=x+A;if(T>s){l&&z(0);break}i&&c(h+A),t.set(n.subarray(x,T),h),e.b=h+=A,e.p=m=T*8,e.f=d;continue}if(m>b){l&&z(0);break}}i&&c(h+131072);for(var oi=(1<<
y)-1,ai=(1<<g)-1,vn=m;;vn=m){var Te=p[Pn(n,m)&oi],Ee=Te>>4;if(m+=Te&15,m>b){l&&z(0);break}if(Te||z(2),Ee<256)t[h++]=Ee;else if(Ee==256){vn=m,p=null;break}else{var kr=Ee-
254;if(Ee>264){var I=Ee-257,Ze=cs[I];kr=H(n,m,(1<<Ze)-1)+hs[I],m+=Ze}var bn=f[Pn(n,m)&ai],wn=bn>>4;bn||z(3),m+=bn&15;var se=Ci[wn];if(wn>3){var Ze=us[wn];se+=Pn(
n,m)&(1<<Ze)-1,m+=Ze}if(m>b){l&&z(0);break}i&&c(h+131072);var Rr=h+kr;if(h<se){var Cr=o-se,ii=Math.min(se,Rr);for(Cr+h<0&&z(3);h<ii;++h)t[h]=r[Cr+h]}for(;h<Rr;++h)
t[h]=t[h-se]}}e.l=p,e.p=vn,e.b=h,e.f=d,p&&(d=1,e.m=y,e.d=f,e.n=g)}while(!d);return h!=t.length&&a?Li(t,0,h):t.subarray(0,h)};var Fi=new F(0);var Di=function(n,e){return((n[0]&15)!=8||n[0]>>4>7||(n[0]<<8|n[1])%31)&&z(6,"invalid zlib data"),(n[1]>>5&1)==+!e&&z(6,"invalid zlib data: "+(n[1]&32?"need":"u\
nexpected")+" dictionary"),(n[1]>>3&4)+2};function gs(n,e){return Ii(n.subarray(Di(n,e&&e.dictionary),-4),{i:2},e&&e.out,e&&e.dictionary)}var Wi=typeof TextDecoder<"u"&&new TextDecoder,Ui=0;try{Wi.decode(Fi,{stream:!0}),Ui=1}catch{}var S=["pursuer","evader"],Q=n=>n==="pursuer"?"evader":"pursuer";var Hi={teams:{pursuer:"pursuers",evader:"evaders"},generation:{pursuer:"pursuer generation",evader:"evader generation"},score:"capture rate",means:{pursuer:"ca\
ptures",evader:"escapes"},curves:{pursuer:"captures",evader:"escapes"},ends:["0 all escape","1 all caught"],lead:"Each cell is a match between two generations: \
the brighter, the more evaders are captured. Click one to watch it.",click:"watch its match"},ys=([n,e])=>({teams:{pursuer:n,evader:e},generation:{pursuer:`gene\
ration of ${n}`,evader:`generation of ${e}`},score:`score of the ${n}`,means:{pursuer:n,evader:e},curves:{pursuer:"scores",evader:"scores"},ends:[`0 the ${e} wi\
n`,`1 the ${n} win`],lead:`Each cell is a pair of generations: the brighter, the higher the score of the ${n}. Click one to see more of it.`,click:"see more of \
it"}),zi=["0 worst","1 best"],Gi=n=>({...ys([n,n]),generation:{pursuer:`generation of ${n}`,evader:"generation of the opponent"},score:"score",ends:["0 loses","\
1 wins"],lead:`Each cell is a pair of generations of ${n}: the brighter, the higher the score of the row. Click one to see more of it.`}),Bi=({game:n})=>n&&n.teams[0]===
n.teams[1]?S.slice(0,1):S,j=n=>{if(!n.game)return Hi;let e=Bi(n).length===1?Gi(n.game.teams[0]):ys(n.game.teams);return n.payoff?.others?{...e,ends:zi}:e},L=(n,e,t)=>`${j(
n).teams[e]} of generation ${t}`;function ie(n,e,t){let r=e-n.payoff.first[0],s=t-n.payoff.first[1],o=n.payoff.capture_rate[r]?.[s];return o===void 0?null:{rate:o,rates:n.payoff.capture_rates[r][s],
lengths:n.payoff.lengths[r]?.[s]??[]}}function vs(n,e,t){let{script:r,policy:s,kept:o,genomes:a}=n.teams[e];if(r!==null||s===null)return"";if(!o.includes(t))return`\
The page holds no genome of ${L(n,e,t)}: it would be too large. Choose a generation of ${o.join(", ")}.`;let i=o.length*s.genome_size;return Ms(a,s.genome_size).
length===i?"":`The page is damaged: it does not hold the ${i} numbers of the ${e}s' genomes. Write it again from its run.`}function ae(n,e,t){let{script:r,policy:s,
kept:o,genomes:a}=n.teams[e];if(r!==null||s===null)return r??"random";let i=o.indexOf(t);if(i<0)throw new RangeError(`${e}: expected a generation whose genome t\
he page holds, got ${t}`);let l=s.genome_size,c=Ms(a,l).subarray(i*l,(i+1)*l);return{...s,genome:c}}var bs=({teams:n},e)=>(n[e].policy??{kind:"cells"}).kind!=="\
cells";function ws({teams:n},e,t){let{kept:r,expressions:s,weights:o}=n[e],a=r.indexOf(t),i=s?.[a];return i?{expression:i,weights:o?.[a]??null}:null}function xs(n,e){
return n.kind==="program"?e?.weights??null:n.hidden.length?null:Object.fromEntries(n.inputs.map((t,r)=>[t,n.genome[r]]))}function kt(n,e,{pursuer:t,evader:r,episode:s,
seed:o}){let a=e.seeds[t][r];return n.match(e.world,ae(e,"pursuer",t),ae(e,"evader",r),BigInt(o??a),s)}var Ln=4,Nn=new Map,Ss=(n,e)=>{Nn.set(n,e)};function Ms(n,e){
let t=Nn.get(n);if(t)return t;let r=new Float32Array;try{let s=Vi(In(n),e);s.every(Number.isFinite)&&(r=s)}catch(s){if(!(s instanceof DOMException||s instanceof
RangeError||ji(s)))throw s}return Nn.set(n,r),r}var ji=n=>n instanceof Error&&"code"in n;function Vi(n,e){let t=gs(n),r=t.length/Ln,s=new Uint8Array(t.length);for(let a=0;a<
s.length;a++)s[a]=t[a%Ln*r+Math.floor(a/Ln)];let o=new Uint32Array(s.buffer);for(let a=e;a<o.length;a++)o[a]^=o[a-e];return new Float32Array(s.buffer)}function In(n){
let e=atob(ee(n)),t=new Uint8Array(e.length);for(let r=0;r<t.length;r++)t[r]=e.charCodeAt(r);return t}var ee=n=>document.getElementById(n)?.textContent??"";var Os={initial:1,noise:2,learn:3,opponents:4},Dn={pursuer:1,evader:2,both:3},fe=4,Fn=2n**32n;function As(n){let e=[],t=BigInt(n);do e.push(Number(t%Fn)),t/=Fn;while(t>
0n);return e}function Ts(n,e){let t=n;return r=>{let s=r^t;return t=Math.imul(t,e),s=Math.imul(s,t),s^s>>>16}}function Es(n,e){let t=Math.imul(3389127133,n)-Math.
imul(1232336661,e)|0;return t^t>>>16}function Wn(n,e,t){let r=n.flatMap(As);if(e.length){for(;r.length<fe;)r.push(0);r.push(...e.flatMap(As))}let s=Ts(1135663077,
2468251765),o=Array.from({length:fe},(i,l)=>s(r[l]??0));for(let i=0;i<fe;i++)for(let l=0;l<fe;l++)i!==l&&(o[l]=Es(o[l],s(o[i])));for(let i of r.slice(fe))for(let l=0;l<
fe;l++)o[l]=Es(o[l],s(i));let a=Ts(2337405405,1492356589);return Uint32Array.from({length:t},(i,l)=>a(o[l%fe]))}function ot(n,e){let t=Wn(n,[],2*e);return BigUint64Array.
from({length:e},(r,s)=>BigInt(t[2*s])+Fn*BigInt(t[2*s+1]))}var Rt=(n,e,t)=>ot([n,e,t],1)[0];var ks=n=>(e,...t)=>new Un(Wn([n],[Os[e],...t],3)),Un=class{#e;#n;#t;#r=1;constructor(e){this.#e=e[0],this.#n=e[1],this.#t=e[2];for(let t=0;t<12;t++)this.#a()}#a(){
let e=this.#e+this.#n+this.#r++|0;return this.#e=this.#n^this.#n>>>9,this.#n=this.#t+(this.#t<<3)|0,this.#t=(this.#t<<21|this.#t>>>11)+e|0,e>>>0}#s(){return(this.#a()+
.5)/2**32}normals(e){let t=new Float32Array(e);for(let r=0;r<e;r+=2){let s=Math.sqrt(-2*Math.log(this.#s())),o=2*Math.PI*this.#s();t[r]=s*Math.cos(o),r+1<e&&(t[r+
1]=s*Math.sin(o))}return t}integers(e,t){return Int32Array.from({length:t},()=>Math.floor(this.#s()*e))}permutation(e){return this.choice(e,e)}choice(e,t){let r=Int32Array.
from({length:e},(s,o)=>o);for(let s=0;s<t;s++){let o=s+Math.floor(this.#s()*(e-s));[r[s],r[o]]=[r[o],r[s]]}return r.slice(0,t)}};var O=Math.fround,qi=5,Ki=256,Ct=class{size;sigma;fixed;#e;constructor(e,t,r,s){this.size=e,this.sigma=r,this.fixed=s,this.#e=t.normals((1+Ki)*e);for(let o=0;o<
this.#e.length;o++)this.#e[o]*=O(r)}draw(e,t){let r=t.integers(this.#e.length-this.size+1,e);return Array.from(r,s=>{let o=this.#e.subarray(s,s+this.size);return this.
fixed?o.map((a,i)=>this.fixed[i]?0:a):o})}},Hn=class{#e;#n;#t=0;constructor(e){this.#e=new Float32Array(e),this.#n=new Float32Array(e)}moved(e,t,r){let a=O(1e-8);
this.#t+=1;let i=O(1-.9),l=O(1-.999),c=O(1-.9**this.#t),d=O(1-.999**this.#t);return e.map((m,h)=>{let p=t[h],f=this.#e[h]+=O(i*O(p-this.#e[h])),y=this.#n[h]+=O(
l*O(O(p*p)-this.#n[h])),g=O(O(Math.sqrt(O(O(y)/d)))+a);return O(m+O(O(O(r)*O(O(f)/c))/g))})}};function Yi(n){let e=Array.from(n).sort((t,r)=>t-r);return n.map(t=>(e.
indexOf(t)+e.lastIndexOf(t))/(2*(n.length-1))-.5)}var $t=class{genome;groups;#e;#n;#t;#r=[];constructor(e,t,r){this.genome=e,this.#n=t,this.#e=r,this.#t=new Hn(
e.length),this.groups=Int32Array.from({length:r.population},(s,o)=>o%(r.population/2))}get#a(){let{sigma:e,fixed:t}=this.#n,r=0,s=0;return this.genome.forEach((o,a)=>{
t?.[a]||(r+=o*o,s+=1)}),Math.max(e,this.#e.relative_sigma*Math.sqrt(r/s))}ask(e){let t=this.#e.population/2,r=this.genome.length;this.#r=this.#n.draw(t,e);let s=O(
this.#a/this.#n.sigma),o=new Float32Array(2*t*r);return this.#r.forEach((a,i)=>{for(let l=0;l<r;l++){let c=O(s*a[l]);o[i*r+l]=this.genome[l]+c,o[(t+i)*r+l]=this.
genome[l]-c}}),o}tell(e){let t=Yi(e),r=this.#r.length,s=new Float32Array(this.genome.length);this.#r.forEach((o,a)=>{let i=O((t[a]-t[r+a])/(2*r*this.#n.sigma**2));
for(let l=0;l<s.length;l++)s[l]+=O(i*o[l])}),this.genome=this.#t.moved(this.genome,s,this.#e.learning_rate)}},at=class{population;groups;#e;#n;#t=new Float64Array(
0);#r=0;constructor(e,t,r){this.population=e,this.#n=t,this.#e=r,this.groups=new Int32Array(r.population)}get genome(){return this.#a(this.#r).slice()}#a(e){let{
size:t}=this.#n;return this.population.subarray(e*t,(e+1)*t)}#s(e,t){let r=this.#e.tournament??qi,s=t.integers(this.#t.length,e*r);return Array.from({length:e},
(o,a)=>s.subarray(a*r,(a+1)*r).reduce((i,l)=>this.#t[l]>this.#t[i]?l:i))}ask(e){if(!this.#t.length)return this.population;let{size:t}=this.#n,{population:r,elites:s}=this.#e,
o=r-s,a=this.#s(o,e);this.#s(o,e);let i=Array.from(this.#t.keys()).sort((c,d)=>this.#t[d]-this.#t[c]).slice(0,s),l=new Float32Array(this.population.length);return[
...i,...a].forEach((c,d)=>l.set(this.#a(c),d*t)),this.#n.draw(o,e).forEach((c,d)=>{let m=(s+d)*t;for(let h=0;h<t;h++)l[m+h]+=c[h]}),this.population=l,l}tell(e){
this.#t=e,this.#r=e.indexOf(Math.max(...e))}};var M=n=>Array.from(n).reduce((e,t)=>e+t,0)/n.length,zn=(n,e)=>e==="pursuer"?n:n[0].map((t,r)=>n.map(s=>1-s[r]));var Rs=-12676506002282294e14,Cs=({hidden:n,mask:e})=>n.map(t=>t+(e?4:0));function it(n){let e=[3*n.fov**2,...Cs(n),5],t=0;return e.slice(1).map((r,s)=>{let o={at:t,
inputs:e[s],outputs:r};return t+=(o.inputs+1)*r,o})}function ge(n){if(n.kind==="rating")return n.inputs.length;let{at:e,inputs:t,outputs:r}=it(n).at(-1);return e+
(t+1)*r}var lt=(n,e)=>n.kind==="rating"?{...n,genome:e}:{kind:"cells",hidden:Cs(n),activation:"relu",sampled:!0,memory:"none",genome:e};function $s(n,e,t){let r=t.
initial_weight;if(n.kind==="rating"||t.kind==="rating")return e.normals(ge(n)).map(i=>Math.fround(r)*i);let s=t.initial_head,o=new Float32Array(ge(n)),a=it(n);return a.
forEach(({at:i,inputs:l,outputs:c},d)=>{let m=Math.fround(d===a.length-1?s:r);e.normals(l*c).forEach((h,p)=>o[i+p]=m*h)}),o}function Gn(n){if(n.kind==="rating")
return null;let{fov:e,mask:t}=n;if(!t)return null;let r=new Uint8Array(ge(n)),s=new Float32Array(ge(n)),o=it(n),a=o.length-1,i=Math.floor(e/2);return o.forEach(
({at:l,inputs:c,outputs:d},m)=>{let h=(p,f)=>l+p*d+f;for(let p=0;p<4;p++)if(m>0&&r.fill(1,h(c-4+p,0),h(c-4+p+1,0)),m<a)for(let f=0;f<=c;f++)r[h(f,d-4+p)]=1;t.forEach(
(p,f)=>{let y=m===a?1+f:d-4+f,g=m===0?p.map(([b,v,x])=>(b*e+i+v)*e+i+x):[c-4+f];for(let b of g)r[h(b,y)]=1,s[h(b,y)]=m===a?Rs:1})}),{fixed:r,values:s}}function Bn(n,e){
return e?n.map((t,r)=>e.fixed[r]?e.values[r]:t):n}function Ps(n,e,t){if(e.kind==="rating"||t.kind==="rating")return n;let r=new Float32Array(ge(t)),s=it(e),o=it(
t),a=Math.floor(t.fov/2)-Math.floor(e.fov/2),i=c=>c>=0&&c<t.fov,l=c=>{let d=Math.floor(c/e.fov**2),m=Math.floor(c/e.fov)%e.fov+a,h=c%e.fov+a;return i(m)&&i(h)?(d*
t.fov+m)*t.fov+h:-1};return s.forEach((c,d)=>{let m=o[d],h=e.hidden[d]??5;for(let p=0;p<(d?e.hidden[d-1]:c.inputs);p++){let f=d?p:l(p);if(!(f<0))for(let y=0;y<h;y++)
r[m.at+f*m.outputs+y]=n[c.at+p*c.outputs+y]}for(let p=0;p<h;p++)r[m.at+m.inputs*m.outputs+p]=n[c.at+c.inputs*c.outputs+p]}),Bn(r.map(c=>c<=Rs/2?0:c),Gn(t))}function _s(n,e,t,r){let s=n.length,o=Math.max(...n)+1,a=o>1?s/o:1,i=Array.from(n.keys()).sort((m,h)=>n[m]-n[h]),l=[],c=[];for(let m=0;m<e;m++){let h=m%a;h===0&&
(c=Array.from(r.permutation(s/a)).flatMap(p=>i.slice(p*a,(p+1)*a))),l.push([i,c.map((p,f)=>c[f-f%a+(f%a-h+a)%a])])}let d=m=>i.map(()=>s+m);for(let m=0;m<t[1];m++)
l.push([i,d(m)]);for(let m=0;m<t[0];m++)l.push([d(m),i]);return{pursuer:Int32Array.from(l.flatMap(([m])=>m)),evader:Int32Array.from(l.flatMap(([,m])=>m)),group:Int32Array.
from(l.flatMap((m,h)=>i.map(p=>h*o+n[p])))}}function Ls(n,e,t,r){let s=Math.max(...e)+1,o=new Float64Array(t*s),a=new Float64Array(t*s);r.forEach((l,c)=>{if(n[c]>=
t)return;let d=n[c]*s+e[c];o[d]+=l,a[d]+=1});let i=o.map((l,c)=>a[c]?l/a[c]:0);return Float64Array.from({length:t},(l,c)=>{let d=i.subarray(c*s,(c+1)*s);return jn(
d)/a.subarray(c*s,(c+1)*s).filter(Boolean).length})}var Zi=128,Pe=8;function jn(n){let{length:e}=n;if(e>Zi){let h=Math.floor(e/2)-Math.floor(e/2)%Pe;return jn(n.
subarray(0,h))+jn(n.subarray(h))}if(e<Pe)return n.reduce((h,p)=>h+p,0);let t=n.slice(0,Pe),r=e-e%Pe;for(let h=Pe;h<r;h++)t[h%Pe]+=n[h];let[s,o,a,i,l,c,d,m]=t;return n.
subarray(r).reduce((h,p)=>h+p,s+o+(a+i)+(l+c+(d+m)))}var Ns=({world:n})=>n.rules.teammate==="REACH"?.2:0;var _t={pursuer:["random","clumsy-fleer"],evader:["random","clumsy-chaser"]},Ji=20,Xi=8,Qi=-1,Lt=({world:n,policy:e},t,r)=>e.kind==="rating"?e:{kind:"cells",fov:n.
fov,hidden:e.hidden,mask:e.mask==="none"?null:t[r]},_e=class{settings;epochs=0;until=1/0;archive={pursuer:[],evader:[]};rows=[];cells=new Map;counters={pursuer:[],
evader:[]};#e;#n;#t;#r={};#a=new Set;#s=0;#l=0;#u=0;constructor(e,t,r,s=ks(t.seed)){this.#e=e,this.settings=t,this.#n=r,this.#t=s;for(let o of S){let a=s("initi\
al",S.indexOf(o)),i=t.learner.kind==="ga"?t.learner.population:1,l=Array.from({length:i},()=>$s(this.shape(o),a,t.policy));this.#d(o,l),this.archive[o].push(this.#r[o].
genome)}this.#x(...S)}shape(e){return Lt(this.settings,this.#n,e)}get finished(){return Math.min(this.archive.pursuer.length,this.archive.evader.length)}*run(){
this.finished===1&&(yield*this.#S(0));for(let e=this.finished;e<=this.settings.schedule.generations;e++){if(this.settings.schedule.kind==="alternating")for(let t of S)
yield*this.#f(t,e),this.#x(t);else yield*this.#m(e),this.#x(...S);yield*this.#S(e)}}change(e){let t=this.settings,r={pursuer:this.shape("pursuer"),evader:this.shape(
"evader")},s=l=>JSON.stringify(l(t))===JSON.stringify(l(e));this.settings=e;let o=s(l=>[l.world.fov,l.policy]);if(!o||!s(l=>l.learner))for(let l of S){let c=d=>Ps(
d,r[l],this.shape(l));this.archive[l]=this.archive[l].map(c),this.#d(l,this.#c(l).map(c))}if(o&&s(l=>l.world))return null;this.cells.clear(),this.#a.clear();let{
pursuer:a,evader:i}=this.archive;return{type:"anew",settings:e,genomes:{pursuer:a.slice(0,this.finished),evader:i.slice(0,this.finished)}}}#c(e){let t=this.#r[e];
if(!(t instanceof at))return[t.genome];let r=t.genome.length,s=Array.from({length:t.population.length/r},(o,a)=>t.population.slice(a*r,(a+1)*r));return Array.from(
{length:this.settings.learner.population},(o,a)=>a===0?t.genome:s[a%s.length])}#d(e,t){let{learner:r}=this.settings,s=this.shape(e),o=r.kind==="ga"?r.mutation:r.
sigma,a=Gn(s),i=new Ct(ge(s),this.#t("noise",S.indexOf(e)),o,a?.fixed??null),l=t.map(c=>Bn(c,a));this.#r[e]=r.kind==="ga"?new at(Pt(l),i,r):new $t(l[0],i,r)}*#f(e,t){
for(let r=0;r<this.#i(e);r++){for(;this.epochs>=this.until;)yield{type:"rest"};let s=this.archive[Q(e)].length,o=this.settings.schedule[`${e}s_meet`],a=o==="lat\
est"?s-1:o==="round-robin"?r%s:this.#t("opponents",S.indexOf(e),t,r).choice(s,1)[0],i=e==="pursuer"?[t,a]:[a,t],l=this.#r[e],{groups:c}=l,d=ot([this.settings.seed,
...i,Dn[e],r],Math.max(...c)+1),m=l.ask(this.#t("learn",S.indexOf(e),t,r)),h=Int32Array.from(c.keys()),p=new Int32Array(c.length),f={[e]:m,[Q(e)]:this.archive[Q(
e)][a]},y={[e]:h,[Q(e)]:p},g=this.#w(f,y,BigUint64Array.from(c,v=>d[v])),b=this.#v(g,e);this.#b(g,b,{generation:t,team:e,epoch:r,opponent:a}),l.tell(b),yield*this.#p(
t,r,e)}this.archive[e].push(this.#r[e].genome)}*#m(e){for(let t=0;t<this.#i("pursuer");t++){for(;this.epochs>=this.until;)yield{type:"rest"};let{schedule:r,learner:{
population:s}}=this.settings,[o,a]=r.kind==="hall-of-fame"?[r.hall_sample,r.contemporaries]:[0,1],i={pursuer:this.#o("pursuer",e,t),evader:this.#o("evader",e,t)},
l=this.#t("opponents",0,e,t),c={pursuer:this.#h(o,l),evader:this.#h(o,l)},d=g=>Pt([i[g],...Array.from(c[Q(g)],b=>this.archive[g][b])]),m=[c.evader.length,c.pursuer.
length],h=_s(this.#r.pursuer.groups,a,m,l),p=ot([this.settings.seed,e,e,Dn.both,t],Math.max(...h.group)+1),f={pursuer:d("pursuer"),evader:d("evader")},y=this.#w(
f,h,BigUint64Array.from(h.group,g=>p[g]));for(let g of S){let b=Ls(h[g],h[Q(g)],s,this.#v(y,g));this.#b(y,b,{generation:e,team:g,epoch:t,opponent:Qi}),this.#r[g].
tell(b)}yield*this.#p(e,t,"both")}for(let t of S)this.archive[t].push(this.#r[t].genome)}#o(e,t,r){return this.#r[e].ask(this.#t("learn",S.indexOf(e),t,r))}#h(e,t){
let r=this.archive.pursuer.length;return e?t.choice(r,Math.min(e,r)):new Int32Array(0)}#i(e){let{schedule:t}=this.settings;return t.kind==="hall-of-fame"?t.joint_epochs:
t[`${e}_epochs`]}*#p(e,t,r){let[s,o]=this.settings.schedule.kind==="hall-of-fame"?[this.#i("pursuer"),0]:[this.#i("pursuer"),this.#i("evader")],a=t+1+(r==="evad\
er"?s:0),i=s+o;this.epochs+=1,yield{type:"epoch",done:(e-1)*i+a,of:this.settings.schedule.generations*i},yield*this.catchUp()}#w(e,t,r){let s={...this.settings.
world,max_steps:this.settings.train_steps},o=this.#e.rollouts(s,this.#y("pursuer",e.pursuer),this.#y("evader",e.evader),{...t,seed:r},1);this.#s+=o.length.length;
for(let a of o.length)this.#l+=Number(a);for(let a of o.agent_steps)this.#u+=Number(a);return o}#y(e,t){return lt(this.shape(e),t)}#v({captured_fraction:e,overlap:t},r){
let s=Ns(this.settings);return Float64Array.from(e,(o,a)=>r==="pursuer"?o:1-o-s*Number(t[2*a+1]))}#b(e,t,r){let s=M(t),o=[0,0];e.faults.forEach((a,i)=>o[Math.floor(
i/3)%2]+=Number(a)),this.rows.push({...r,fitness_mean:s,fitness_std:Math.sqrt(M(t.map(a=>(a-s)**2))),fitness_best:Math.max(...t),capture_rate:M(e.capture_rate),
length:M(e.length),pursuer_faults:o[0]/e.length.length,evader_faults:o[1]/e.length.length,matches:this.#s,steps:this.#l})}#x(...e){for(let t of e)this.counters[t].
push({matches:this.#s,steps:this.#l,agent_steps:this.#u})}*#S(e){yield{type:"generation",number:e,genomes:{pursuer:this.archive.pursuer[e],evader:this.archive.evader[e]}},
yield*this.catchUp()}*catchUp(){for(let e=this.finished-1;e>=0;e--){for(let t=e;t>=0;t--)for(let[r,s]of t===e?[[e,e]]:[[e,t],[t,e]]){if(this.cells.has(`${r} ${s}`))
continue;let o=this.#g(r,s);this.cells.set(`${r} ${s}`,o),yield{type:"cell",cell:o}}this.#a.has(e)||(this.#a.add(e),yield{type:"scores",number:e,scores:{pursuer:this.#M(
"pursuer",e),evader:this.#M("evader",e)}})}}#g(e,t){let{world:r,evaluation_episodes:s,seed:o}=this.settings,a={pursuer:new Int32Array(1),evader:new Int32Array(1),
seed:BigUint64Array.of(Rt(o,e,t))},i=S.map(d=>this.#y(d,this.archive[d][d==="pursuer"?e:t])),l=this.#e.rollouts(r,...i,a,s),c=d=>{let m=Array.from(l[d],Number),
h=m.length/s;return Array.from({length:h},(p,f)=>M(m.filter((y,g)=>g%h===f)))};return{pursuer:e,evader:t,capture_rates:Array.from(l.capture_rate),lengths:Array.
from(l.length),means:{collisions:c("collisions"),faults:c("faults"),agent_steps:c("agent_steps"),survivors:c("survivors")}}}#M(e,t){let{world:r,seed:s}=this.settings,
o=this.#y(e,this.archive[e][t]),a=new Int32Array(1);return M(_t[e].map((i,l)=>{let c=ot([s,S.indexOf(e),l,Xi],1),d=e==="pursuer"?[o,i]:[i,o],m=M(this.#e.rollouts(
r,...d,{pursuer:a,evader:a,seed:c},Ji).capture_rate);return e==="pursuer"?m:1-m}))}};function Pt(n){let e=new Float32Array(n.reduce((r,{length:s})=>r+s,0)),t=0;
for(let r of n)e.set(r,t),t+=r.length;return e}var el=12,Nt=class{#e=null;#n=null;#t=[];#r;constructor(e,t){this.#r=t;try{let r=new Blob([ee("script-engine"),`
`,ee(`script-${e}`)],{type:"text/javascript"});this.#n=new Worker(URL.createObjectURL(r)),this.#n.onerror=()=>this.#e||this.#a(),this.#n.onmessage=()=>this.#s(this.#n)}catch{
this.#a()}}send(e){this.#e?this.#e.postMessage(e):this.#t.push(e)}close(){this.send({type:"stop"}),this.#n?.terminate()}#a(){let{port1:e,port2:t}=new MessageChannel;
Vn(t),this.#s(e)}#s(e){this.#e=e,e.onmessage=({data:t})=>t.type!=="ready"&&this.#r(t);for(let t of this.#t.splice(0))e.postMessage(t)}};function Vn(n){let e=b=>n.
postMessage(b),t=Ot(),r=null,s=null,o=null,a=[],i=!1,l=0,c=!1,d=new MessageChannel,m=b=>{let v=r.change(b);e({type:"changed",at:r.epochs,settings:b}),v&&e(v),!s&&
r.finished<=b.schedule.generations?(s=r.run(),i=!0):i||(o=r.catchUp())},h=()=>{i=!1,o=r.catchUp(),e({type:"stopped",at:r.epochs})},p=()=>{if(i&&s){for(;a.length&&
a[0].at<=r.epochs;)m(a.shift().settings);let{value:v,done:x}=s.next();return x?(s=null,i=!1,o=r.catchUp(),e({type:"end",at:r.epochs,seconds:l/1e3})):v.type==="r\
est"?h():e(v),!0}let b=o?.next();return b&&!b.done?e(b.value):o=null,!!o},f=()=>{let b=performance.now(),v=!0;for(;v&&performance.now()<b+el;)v=p();l+=performance.
now()-b,!(!v||c)&&(c=!0,d.port2.postMessage(null))},y=async b=>{if(b.type==="start")r=new _e(await t,b.settings,b.masks),s=r.run(),o=null,a=[...b.plan],i=!0,l=0,
r.until=b.until,e({type:"began"});else if(r)if(b.type==="change")a=[],r.until=1/0,m(b.settings);else if(b.type==="go")r.until=1/0,i=!0;else if(b.type==="stop")i&&
h();else{let{settings:v,archive:x,rows:A,cells:T,counters:_,finished:J}=r;e({type:"saved",race:{settings:v,archive:x,rows:A,cells:T,counters:_,finished:J}})}else
return;f()},g=b=>{Promise.resolve().then(b).catch(v=>{s=o=null,e({type:"failed",message:String(v)})})};d.port1.onmessage=()=>{c=!1,g(f)},n.onmessage=({data:b})=>g(
()=>y(b)),e({type:"ready"})}var tl="http://www.w3.org/2000/svg";function u(n,e={},...t){return Is(document.createElement(n),e,t)}function w(n,e={},...t){return Is(document.createElementNS(
tl,n),e,t)}function Is(n,e,t){for(let[s,o]of Object.entries(e))o==null||o===!1||(typeof o=="function"?n.addEventListener(s.slice(2),o):n.setAttribute(s,o===!0?"":
String(o)));let r=t.filter(s=>s!=null&&s!==!1);return n.append(...r.map(s=>typeof s=="number"?String(s):s)),n}function Fs(n,e){let t=u("select",{onchange:()=>e(
t.value)},...n.map(([r,s])=>u("option",{value:r},s)));return t}async function qn(n){try{await n}catch(e){let t=document.querySelector("#page, main")??document.body;
throw t.querySelector(".absent")?.remove(),t.prepend(u("p",{class:"card problem",role:"alert"},e instanceof WebAssembly.CompileError||/WebAssembly/.test(String(
e))?"This page plays by WebAssembly, which is forbidden where it lies ('wasm-unsafe-eval' is missing in the content policy): save the file, and open it from you\
r disk.":`The page could not start: ${String(e)}`)),e}finally{document.body.dataset.ready="true"}}function It(n,e){let t=URL.createObjectURL(new Blob([e],{type:"application/octet-stream"}));u("a",{href:t,download:n}).click(),setTimeout(()=>URL.revokeObjectURL(
t),6e4)}var Ds=()=>document.documentElement.dataset.theme==="dark";function ct(n){document.documentElement.dataset.theme=n?"dark":"light"}var nl=()=>ct(!Ds());if(typeof document<
"u"){let n=matchMedia("(prefers-color-scheme: dark)");n.addEventListener("change",()=>ct(n.matches)),ct(n.matches);let e=!1;addEventListener("beforeprint",()=>{
e=Ds(),ct(!1)}),addEventListener("afterprint",()=>ct(e))}function Ws(){return u("button",{type:"button",title:"Light or dark (D)","aria-label":"Light or dark",onclick:nl},
"◐")}var Ft=(n,e,...t)=>u("header",{class:"top"},u("div",{},u("h1",{},n),e?u("p",{class:"lead"},e):null),u("div",{class:"tools"},...t,Ws()));var Dt=n=>n!==void 0&&"predict"in n,Wt=({sections:n})=>new Map(n.flatMap(({parts:e})=>e.filter(Dt).map(t=>[t.predict,t]))),Us=()=>JSON.parse(ee("data"));var Kn=[[0,0],[-1,0],[0,1],[1,0],[0,-1],[-1,1],[1,1],[1,-1],[-1,-1]];var ye=(n,e)=>e<n.nPursuers,C=(n,e)=>[n.positions[2*e],n.positions[2*e+1]],Yn=({rows:n,cols:e},[t,r])=>t>=0&&r>=0&&t<n&&r<e,Zn=(n,e,t=3)=>n!==void 0&&[0,1,2].slice(
0,t).some(r=>n[3*e+r]),Jn=(n,e)=>Zn(n.fault,e),Hs=(n,e)=>!Jn(n,e)&&Zn(n.involved,e,2);function Ut(n,e,t){let r=C(n,t),s=C(e,t),o=r[0]!==s[0]||r[1]!==s[1],a=e.involved===
void 0||Zn(e.involved,t);return!!(e.alive[t]&&e.actions?.[t]&&!o&&a)}function Ht(n,e,t){let[r,s]=C(n,t),[o,a]=Kn[e.actions?.[t]??0];return[r+o,s+a]}function ut(n,e,t){
return Array.from({length:t.everCaptured.length},(s,o)=>o).filter(s=>t.everCaptured[s]&&!e.everCaptured[s]).map(s=>n.nPursuers+s)}var zt=n=>n.moments.flatMap((e,t)=>t&&
ut(n,n.moments[t-1],e).length?[t]:[]);function Gt(n,e){return Array.from({length:e.alive.length},(r,s)=>s).filter(r=>n.alive[r]&&!e.alive[r])}var zs=[-.31,0,.31],Gs=[{size:1,at:[[0,0]]},{size:.62,at:[[-.2,.2],[.2,-.2]]},{size:.54,at:[[-.23,.22],[.23,.22],[0,-.22]]},{size:.54,at:[[-.23,.23],[.23,.23],[
-.23,-.23],[.23,-.23]]},{size:.36,at:zs.flatMap(n=>zs.map(e=>[e,n]))}],rl=.3,sl=.35,ol=.55;function dt(n,e){let t=new Map;for(let r=0;r<e.alive.length;r++){if(!e.
alive[r])continue;let[s,o]=C(e,r),a=s*n.cols+o,i=t.get(a);i?i.push(r):t.set(a,[r])}return t}function Bs(n,e){let t=Array.from(e.alive,(r,s)=>{let[o,a]=C(e,s);return{
x:a+.5,y:o+.5,size:1,alpha:0}});for(let r of dt(n,e).values()){let s=Gs[Math.min(r.length,Gs.length)-1];r.forEach((o,a)=>{let[i,l]=s.at[Math.min(a,s.at.length-1)],
c=t[o];c.x+=i,c.y+=l,c.size=s.size,c.alpha=1})}return t}var js=n=>n*n*(3-2*n),Le=(n,e,t)=>n+(e-n)*t,Vs=n=>Math.min(1,Math.max(0,n));function qs(n,e,t,r){let s={
SIMULTANEOUS:1,SWARM_TURNS:2,AGENT_TURNS:t}[n.interaction];if(s===1)return js(r);let o=s===t?e:+!ye(n,e),a=Math.max(1/s,sl);return js(Vs((r-o/(s-1)*(1-a))/a))}function Bt(n,e){
let t=n.moments.length-1,r=Math.min(Math.floor(e),t),s=n.moments[r],o=Bs(n,s);if(r===t||e===r)return o;let a=n.moments[r+1],i=Bs(n,a);return o.map((l,c)=>{let d=qs(
n,c,o.length,e-r);return al(s,a,c,l,i[c],d)})}function Xn(n,e,t){let r=n.moments.length-1,s=Math.min(Math.floor(t),r),o=n.moments[s],a=n.moments[Math.min(s+1,r)],
i=qs(n,e,o.alive.length,t-s),[l,c]=C(o,e),[d,m]=C(a,e);return[Le(c,m,i)+.5,Le(l,d,i)+.5]}function al(n,e,t,r,s,o){let a=r.alpha>s.alpha,i={x:Le(r.x,s.x,o),y:Le(
r.y,s.y,o),size:a?r.size:Le(r.size,s.size,o),alpha:a?Vs((1-o)/(1-ol)):Le(r.alpha,s.alpha,o)};if(Ut(n,e,t)){let[l,c]=C(n,t),[d,m]=Ht(n,e,t),h=rl*Math.sin(Math.PI*
o);i.x+=(m-c)*h,i.y+=(d-l)*h}return i}var Ks=2*Math.PI;function ve(n,e,t,r){n.beginPath(),n.arc(e,t,r/2,0,Ks)}function jt(n,e,t,r){let s=r/2,o=[[0,-.97],[.97,.83],[-.97,.83]].map(([a,i])=>[e+a*s,t+i*
s]);n.beginPath(),n.moveTo((o[2][0]+o[0][0])/2,(o[2][1]+o[0][1])/2),o.forEach(([a,i],l)=>{let[c,d]=o[(l+1)%3];n.arcTo(a,i,c,d,r*.09)}),n.closePath()}function Ys(n,e,t,r){
let s=r*.32;n.beginPath(),n.moveTo(e-s,t-s),n.lineTo(e+s,t+s),n.moveTo(e+s,t-s),n.lineTo(e-s,t+s)}function Zs(n,e,t,r){n.beginPath();for(let s=0;s<16;s++){let o=r/
2*(s%2?.6:.95),a=Ks*s/16;n.lineTo(e+o*Math.sin(a),t-o*Math.cos(a))}n.closePath()}function Js(n,e,t,r,s,o){let a=Math.atan2(s-t,r-e);n.beginPath(),n.moveTo(e,t),
n.lineTo(r,s);for(let i of[-1,1])n.moveTo(r,s),n.lineTo(r-o*Math.cos(a+i*.6),s-o*Math.sin(a+i*.6))}var Xs=4,il=1.6,ll=.95,cl=5,ul=.16,dl=9,ml=.09,hl=.2,Qs=.75,$=(n,e)=>n.left+e*n.cell,P=(n,e)=>n.top+e*n.cell;function Ne(n,e,t){return ye(e,t)?n.colors.pursuer:
n.colors.evader}function Vt({ctx:n,colors:e},t,r,s,o,a,i=0){n.font=`700 ${Math.round(o)}px system-ui, sans-serif`,n.textAlign="center",n.textBaseline="middle",n.
strokeStyle=e.paper,n.lineWidth=i,i&&n.strokeText(t,r,s),n.fillStyle=a,n.fillText(t,r,s)}function eo({ctx:n,grid:e,colors:t}){let{left:r,top:s,cell:o,rows:a,cols:i}=e,
l=i*o,c=a*o;if(n.fillStyle=t.paper,n.fillRect(r,s,l,c),o<cl)return;n.fillStyle=t.line;let d=Math.max(1,Math.round(o/60));for(let m=1;m<i;m++)n.fillRect(r+m*o,s,
d,c);for(let m=1;m<a;m++)n.fillRect(r,s+m*o,l,d)}function to({ctx:n,grid:e,colors:t},r){let{left:s,top:o,cell:a,rows:i,cols:l}=e;n.fillStyle=t.obstacle;for(let c=0;c<
i*l;c++){if(!r.obstacles[c])continue;let d=Math.floor(c/l),m=c%l;n.fillRect(s+m*a,o+d*a,a,a)}no({ctx:n,grid:e,colors:t})}function no({ctx:n,grid:{left:e,top:t,cell:r,
rows:s,cols:o},colors:a}){let i=Math.min(5,Math.max(2,Math.round(r/18)));n.strokeStyle=a.frame,n.lineWidth=i,n.strokeRect(e-i/2,t-i/2,o*r+i,s*r+i)}function ro({
ctx:n,grid:e,colors:t},r){let{left:s,top:o,cell:a,rows:i,cols:l}=e,c=a<24*r?5:1;n.font=`500 ${Math.round(Math.min(15*r,Math.max(9*r,a*.32)))}px system-ui, sans-\
serif`,n.fillStyle=t.muted,n.textBaseline="alphabetic",n.textAlign="center";let d=5*r+a/40;for(let m=0;m<l;m+=c)n.fillText(String(m),s+(m+.5)*a,o-d);n.textAlign=
"right",n.textBaseline="middle";for(let m=0;m<i;m+=c)n.fillText(String(m),s-d,o+(m+.5)*a)}function so({grid:n},e,t,r){let s=Math.floor(e.fov/2)+.5,o=Math.max(0,
t-s),a=Math.min(n.cols,t+s),i=Math.max(0,r-s),l=Math.min(n.rows,r+s);return[$(n,o),P(n,i),(a-o)*n.cell,(l-i)*n.cell]}function oo(n,e,t,r){let{ctx:s,grid:o,colors:a}=n;
s.save(),s.beginPath(),s.rect(0,0,s.canvas.width,s.canvas.height),s.rect(...so(n,e,t,r)),s.clip("evenodd"),s.clearRect(0,0,s.canvas.width,s.canvas.height),s.fillStyle=
a.line,s.fillRect(o.left,o.top,o.cols*o.cell,o.rows*o.cell),s.restore(),no(n)}function ao(n,{x:e,y:t,alpha:r},s){let{ctx:o,grid:a,colors:i}=n,l=Math.max(a.cell,
16*s)*1.06,c=$(a,e),d=P(a,t);o.globalAlpha=Math.max(r,.6),o.beginPath(),o.roundRect(c-l/2,d-l/2,l,l,l*.2),o.strokeStyle=i.focus,o.lineWidth=Math.max(2,2.5*s),o.
stroke();let m=Math.max(11*s,Math.min(18*s,a.cell*.5)),h=d-l/2<m*1.2,p=d+(h?1:-1)*(l/2+m*.7);o.lineJoin="round",Vt(n,"You",c,p,m,i.ink,m*.35),o.globalAlpha=1}function io(n,e,t,r,s){
let{ctx:o,grid:a}=n,i=so(n,e,r,s),l=Ne(n,e,t);o.globalAlpha=.11,o.fillStyle=l,o.fillRect(...i),o.globalAlpha=.8,o.strokeStyle=l,o.lineWidth=Math.max(1,a.cell/24),
o.strokeRect(...i),o.globalAlpha=1}function lo(n,e,t,r,s){let{ctx:o,grid:a}=n,i=Math.min(Math.ceil(t),e.moments.length-1),l=e.moments[i];o.lineCap="round",o.lineWidth=
Math.min(dl,Math.max(1,a.cell*ul));for(let c=Math.max(1,Math.floor(t-r)+1);c<=i;c++){let d=e.moments[c-1],m=e.moments[c],h=Math.max(0,Math.min(1,(t-c)/r));o.globalAlpha=
Qs+(hl-Qs)*h;for(let p=0;p<m.alive.length;p++){let f=c===i&&t<i;if(!d.alive[p]||!(l.alive[p]||f))continue;let y=(ye(e,p)?-1:1)*ml,[g,b]=C(d,p),[v,x]=C(m,p);if(g===
v&&b===x)continue;let A=f?s[p].x:x+.5,T=f?s[p].y:v+.5;o.strokeStyle=Ne(n,e,p),o.beginPath(),o.moveTo($(a,b+.5+y),P(a,g+.5+y)),o.lineTo($(a,A+y),P(a,T+y)),o.stroke()}}
o.globalAlpha=1}function co(n,e,t){let r=Math.min(Math.ceil(t),e.moments.length-1);for(let s=Math.max(1,r-Xs+1);s<=r;s++){let o=e.moments[s-1],a=e.moments[s],i=s>
t?Math.max(0,1-2*(s-t)):1-(t-s)/Xs,l=ut(e,o,a);for(let c of Gt(o,a))l.includes(c)||fl(n,C(a,c),i);for(let c of l)pl(n,C(a,c),i)}n.ctx.globalAlpha=1}function pl({
ctx:n,grid:e,colors:t},[r,s],o){n.globalAlpha=o,Zs(n,$(e,s+.5),P(e,r+.5),Math.max(8,e.cell*il)),n.fillStyle=t.capture,n.fill(),n.strokeStyle=t.ink,n.lineWidth=Math.
max(1,e.cell/36),n.lineJoin="round",n.stroke()}function fl({ctx:n,grid:e,colors:t},[r,s],o){n.globalAlpha=o,Ys(n,$(e,s+.5),P(e,r+.5),Math.max(7,e.cell*ll)),n.strokeStyle=
t.collision,n.lineWidth=Math.max(2,e.cell*.17),n.lineCap="round",n.stroke()}function uo({ctx:n,grid:e,colors:t},r,s){let o=Math.max(1,e.cell*.07);n.strokeStyle=
n.fillStyle=t.collision,n.lineWidth=Math.max(1,e.cell*.05),n.setLineDash([e.cell*.14,e.cell*.1]);for(let[a,i]of r){if(a<0||i<0||a>=e.rows||i>=e.cols)continue;let l=[
$(e,i)+o,P(e,a)+o,e.cell-2*o,e.cell-2*o];n.globalAlpha=.2*s,n.fillRect(...l),n.globalAlpha=s,n.strokeRect(...l)}n.setLineDash([]),n.globalAlpha=1}function mo({ctx:n,
grid:e,colors:t},r,s,o,a){n.globalAlpha=a,ve(n,$(e,r),P(e,s),Math.max(8,e.cell*o*1.02)),n.strokeStyle=t.collision,n.lineWidth=Math.max(1.5,e.cell*.085*Math.sqrt(
o)),n.stroke(),n.globalAlpha=1}var gl=.8,yl=.92,vl=15,bl=7,Qn=9;function ho(n,e,t,r,s,o){r.forEach((a,i)=>{a.alpha>0&&wl(n,e,t,i,a,s,o)}),n.ctx.globalAlpha=1;for(let a of dt(e,t).values())a.length>
Qn&&xl(n,r[a[Qn-1]],a.length-Qn+1)}function wl(n,e,t,r,s,o,a){let{ctx:i,grid:l,colors:c}=n,d=ye(e,r),m=$(l,s.x),h=P(l,s.y),p=Math.max(4,l.cell*s.size*(d?yl:gl)),
f=Ne(n,e,r),y=!d&&!!t.captured[r-e.nPursuers];if(i.globalAlpha=s.alpha,(d?jt:ve)(i,m,h,p),p>bl*a&&(i.strokeStyle=c.paper,i.lineWidth=Math.max(2,p*.1),i.stroke()),
i.fillStyle=y?c.paper:f,i.fill(),y&&(ve(i,m,h,p*.82),i.strokeStyle=f,i.lineWidth=p*.18,i.stroke()),!o||p<vl*a)return;let g=String(d?r:r-e.nPursuers),b=p*(d?.4:.5)*
(g.length>1?.8:1);Vt(n,g,m,h+p*(d?.17:.03),b,y?f:c.paper)}function xl(n,e,t){let{cell:r}=n.grid;Vt(n,`+${t}`,$(n.grid,e.x),P(n.grid,e.y),r*.3,n.colors.ink,r*.1)}var Sl=.46,Ml=.86,Al=.66,po=.48,Tl=.78,El=.58;function fo(n,e,t,r){let s=e.moments[t-1],o=e.moments[t];if(!s)return;let{ctx:a,grid:i,colors:l}=n;a.strokeStyle=l.
collision,a.lineWidth=Math.max(1.5,i.cell*.07),a.lineCap="butt",a.globalAlpha=r;for(let c=0;c<o.alive.length;c++)Ut(s,o,c)&&Ol(n,e,C(s,c),Ht(s,o,c));a.globalAlpha=
1}function Ol({ctx:n,grid:e},t,r,s){let o=s[1]-r[1],a=s[0]-r[0],i=m=>$(e,r[1]+.5+o*m),l=m=>P(e,r[0]+.5+a*m),c=Yn(t,s)?Tl:El;n.setLineDash([e.cell*.09,e.cell*.06]),
n.beginPath(),n.moveTo(i(po),l(po)),n.lineTo(i(c),l(c)),n.stroke(),n.setLineDash([]);let d=.17*e.cell/Math.hypot(o,a);n.beginPath(),n.moveTo(i(c)-a*d,l(c)+o*d),
n.lineTo(i(c)+a*d,l(c)-o*d),n.stroke()}function go(n,e,t,r,s,o){let a=Kn[o];if(!o||!a)return;let{ctx:i,grid:l,colors:c}=n,d=Yn(e,[r[0]+a[0],r[1]+a[1]])?Ml:Al,m=Sl*
s.size,h=[$(l,s.x+a[1]*m),P(l,s.y+a[0]*m),$(l,s.x+a[1]*d),P(l,s.y+a[0]*d)],p=Math.max(1.5,l.cell*.085);i.lineCap=i.lineJoin="round";for(let[f,y]of[[c.paper,p*2.1],
[Ne(n,e,t),p]])i.strokeStyle=f,i.lineWidth=y,Js(i,...h,l.cell*.2),i.stroke()}var vo={numbers:!0,axes:!1,trail:6,viewers:[],plan:null,selected:null,cursor:null,you:null,fog:!1};function bo(n,e,t,r,s){let{ctx:o,grid:a,colors:i}=n,l=Math.min(
Math.ceil(t),e.moments.length-1),c=e.moments[l],d=t===l,m=Bt(e,t),h=d?1:Math.max(0,1-2*(l-t));o.clearRect(0,0,o.canvas.width,o.canvas.height),eo(n);for(let y of r.
viewers)m[y]?.alpha&&io(n,e,y,...Xn(e,y,t));to(n,e),r.axes&&ro(n,s),lo(n,e,t,r.trail,m),uo(n,c.contested??[],h),co(n,e,t),fo(n,e,l,h),m.forEach(({x:y,y:g,size:b},v)=>{
let x=Hs(c,v)?.4:0,A=Jn(c,v)?1:x;A&&mo(n,y,g,b,A*h)});let p=d?c:e.moments[Math.max(0,l-1)];if(ho(n,e,p,m,r.numbers,s),d&&r.plan)for(let[y,g]of m.entries())g.alpha&&
go(n,e,y,C(c,y),g,r.plan[y]??0);r.you!==null&&(r.fog&&oo(n,e,...Xn(e,r.you,t)),ao(n,m[r.you],s)),o.lineWidth=Math.max(2,2.5*s),o.strokeStyle=i.focus;let f=r.selected===
null?void 0:m[r.selected];f?.alpha&&yo(n,f.x,f.y,f.size*.96),r.cursor&&(o.setLineDash([a.cell*.12,a.cell*.08]),yo(n,r.cursor[1]+.5,r.cursor[0]+.5,.8),o.setLineDash(
[]))}function yo({ctx:n,grid:e},t,r,s){let o=s*e.cell;n.beginPath(),n.roundRect(e.left+t*e.cell-o/2,e.top+r*e.cell-o/2,o,o,o*.1),n.stroke()}var wo=(n,e)=>(e+.24)/(n+.24);function xo(n,e,t,r,s,o){let a=t?28*o:0,i=(c,d)=>(c-a)/(d+2*.12),l=Math.max(1,Math.floor(Math.min(i(r,e),i(s,n))));return{rows:n,cols:e,
cell:l,left:Math.round((r-e*l+a)/2),top:Math.round((s-n*l+a)/2)}}function So(n,e,t){let r=Math.floor((t-n.top)/n.cell),s=Math.floor((e-n.left)/n.cell);return r>=
0&&r<n.rows&&s>=0&&s<n.cols?[r,s]:null}var kl=["paper","line","frame","ink","muted","obstacle"],Rl=["pursuer","evader","capture","collision","focus"];function qt(n){let e=getComputedStyle(n),t=(r,s)=>[
r,e.getPropertyValue(s+r).trim()];return Object.fromEntries([...kl.map(r=>t(r,"--board-")),...Rl.map(r=>t(r,"--"))])}var le=()=>matchMedia("(prefers-reduced-motion: reduce)").matches,Ie=class{canvas;#e=null;#n=0;#t;#r={rows:1,cols:1,left:0,top:0,cell:1};#a=0;constructor(e,t={}){
this.canvas=e,e.classList.add("board"),e.setAttribute("role","img"),this.#t={...vo,...t},new ResizeObserver(()=>this.#l()).observe(e),new MutationObserver(()=>this.
redraw()).observe(document.documentElement,{attributes:!0}),addEventListener("beforeprint",()=>this.drawNow())}set look(e){this.#t={...this.#t,...e},this.#s(),this.
redraw()}show(e,t){this.#e=e,this.#n=Math.min(Math.max(0,t),e.moments.length-1),this.#s(),this.redraw()}redraw(){this.#a||(this.#a=requestAnimationFrame(()=>this.
drawNow()))}drawNow(){cancelAnimationFrame(this.#a),this.#a=0;let e=this.canvas.getContext("2d");if(!e||!this.#e)return;let{rows:t,cols:r}=this.#e,s=devicePixelRatio||
1;this.#r=xo(t,r,this.#t.axes,this.canvas.width,this.canvas.height,s);let o={ctx:e,grid:this.#r,colors:qt(this.canvas)};bo(o,this.#e,this.#n,this.#t,s)}cellAt(e,t){
let r=this.canvas.getBoundingClientRect(),s=this.canvas.width/r.width;return So(this.#r,(e-r.left)*s,(t-r.top)*s)}agentAt(e,t){let r=this.cellAt(e,t);if(!r||!this.#e)
return null;let s=this.#e.moments[Math.round(this.#n)],o=dt(this.#e,s).get(r[0]*this.#e.cols+r[1])??[],a=Bt(this.#e,Math.round(this.#n)),i=l=>{let[c,d]=this.pointOf(
a[l].x,a[l].y);return Math.hypot(c-e,d-t)};return o.length?o.reduce((l,c)=>i(c)<i(l)?c:l):null}pointOf(e,t){let r=this.canvas.getBoundingClientRect(),s=r.width/
this.canvas.width,{left:o,top:a,cell:i}=this.#r;return[r.left+(o+e*i)*s,r.top+(a+t*i)*s]}#s(){if(!this.#e)return;let{rows:e,cols:t}=this.#e;this.canvas.style.setProperty(
"--board-aspect",String(wo(e,t)))}#l(){let e=devicePixelRatio||1,{width:t,height:r}=this.canvas.getBoundingClientRect();this.canvas.width=Math.max(1,Math.round(
t*e)),this.canvas.height=Math.max(1,Math.round(r*e)),this.drawNow()}};var mt=[.5,1,2,4,8,16,32,64],Kt=0,Yt=12,Cl=2,ce=class extends EventTarget{#e;#n;#t;#r=0;#a=0;#s=!1;#l=null;#u=0;#c=[];#d=[];glide=.28;constructor(e,{speed:t=4,still:r=!1}={}){
super(),this.#e=e,this.#n=t,this.#t=r}get step(){return this.#r}get time(){return this.#t?this.#r:this.#a}get arrived(){return this.#a===this.#r}get playing(){return this.#s}get length(){
return this.#e}set length(e){this.#e=e,this.#r>e&&this.jump(e),this.#i("state")}get marks(){return this.#c}set marks(e){this.#c=e,this.#i("state")}get ticks(){return this.#d}set ticks(e){
this.#d=e,this.#i("state")}get pace(){return this.#n||Math.max(Cl,this.#e/Yt)}get speed(){return this.#n}set speed(e){this.#n=e,this.#i("state")}changeSpeed(e){
let t=mt.findIndex(r=>r>=this.pace);this.speed=mt[Math.min(mt.length-1,Math.max(0,t+e))]}play(){this.#s||!this.#e||(this.#r===this.#e&&this.jump(0),this.#s=!0,this.#i(
"state"),this.#m())}pause(){this.#s&&(this.#s=!1,this.#i("state"))}toggle(){this.#s?this.pause():this.play()}move(e){this.pause();let t=Math.min(this.#e,Math.max(
0,this.#r+e));Math.abs(t-this.#a)>1?this.jump(t):this.#f(t),this.#m()}jump(e){this.#a=Math.min(this.#e,Math.max(0,Math.round(e))),this.#f(this.#a),this.#i("fram\
e")}#f(e){e!==this.#r&&(this.#r=e,this.#i("step"),this.#t&&this.#i("frame"))}#m(){this.#l===null&&(this.#u=performance.now(),this.#l=requestAnimationFrame(()=>this.#o()))}#o(){
this.#l=null;let e=performance.now();this.#h(Math.min(.25,(e-this.#u)/1e3)),this.#u=e,(!this.#t||this.arrived)&&this.#i("frame"),(this.#s||this.#a!==this.#r)&&(this.#l=
requestAnimationFrame(()=>this.#o()))}#h(e){let t=e;for(;t>0;){if(this.#a===this.#r){if(!this.#s)return;if(this.#r===this.#e)return this.pause();this.#f(this.#r+
1)}let r=this.#s?this.pace:1/this.glide,s=this.#r-this.#a,o=Math.min(Math.abs(s),t*r);t-=o/r,this.#a=o===Math.abs(s)?this.#r:this.#a+Math.sign(s)*o}this.#s&&this.#a===
this.#e&&this.pause()}#i(e){this.dispatchEvent(new Event(e))}};function Mo(n,e){if(e.ctrlKey||e.metaKey||e.altKey)return!1;let t=e.shiftKey?10:1,s={" ":()=>n.toggle(),
ArrowRight:()=>n.move(t),ArrowLeft:()=>n.move(-t),Home:()=>n.move(-n.length),End:()=>n.move(n.length),"+":()=>n.changeSpeed(1),"-":()=>n.changeSpeed(-1)}[e.key];
return s?.(),s!==void 0}var $l={first:"M6 5v14M19 5 9 12l10 7z",back:"M17 5 7 12l10 7z",play:"M7 4.5 19 12 7 19.5z",pause:"M8 5v14M16 5v14",forward:"M7 5l10 7-10 7z",last:"M18 5v14M5 5\
l10 7-10 7z"};function Ao(n){return w("svg",{viewBox:"0 0 24 24","aria-hidden":"true",class:"icon"},w("path",{d:$l[n]}))}function ht(n,e,t,r){return u("button",
{type:"button",class:"player-button","aria-label":e,title:`${e} (${t})`,onclick:r},Ao(n))}function Fe(n){let e=ht("play","Play","Space",()=>n.toggle()),t=u("inp\
ut",{type:"range",class:"player-scrub",min:0,step:1,"aria-label":"Step",oninput:()=>{n.pause(),n.jump(Number(t.value))}}),r=u("div",{class:"captures","aria-hidd\
en":"true",title:"Captures"}),s=u("div",{class:"losses","aria-hidden":"true"}),o=u("select",{class:"player-speed","aria-label":"Speed",title:`Steps a second, or\
 the whole in ${Yt} s (+ and -)`,onchange:()=>n.speed=Number(o.value)},u("option",{value:Kt},`in ${Yt} s`),...mt.map(m=>u("option",{value:m},`${m} / s`))),a=u("\
output",{class:"player-count"}),i=u("div",{class:"player",role:"group","aria-label":"Player"},ht("first","First step","Home",()=>n.move(-n.length)),ht("back","S\
tep back","←",()=>n.move(-1)),e,ht("forward","Step forward","→",()=>n.move(1)),ht("last","Last step","End",()=>n.move(n.length)),u("div",{class:"scrub"},r,s,
t),a,o),l=(m,h={})=>{let p=u("i",h);return p.style.left=`${100*m/Math.max(1,n.length)}%`,p},c=()=>{r.replaceChildren(...n.marks.map(m=>l(m))),s.replaceChildren(
...n.ticks.map(({step:m,kind:h,size:p,text:f})=>{let y=l(m,{class:h,title:`Step ${m}: ${f}`});return y.style.height=`${100*p}%`,y}))},d=()=>{e.replaceChildren(Ao(
n.playing?"pause":"play")),e.ariaLabel=n.playing?"Pause":"Play",e.title=`${e.ariaLabel} (Space)`,t.max=String(n.length),t.value=String(n.step),t.ariaValueText=`\
step ${n.step} of ${n.length}`,a.textContent=`${n.step} / ${n.length}`,a.style.minWidth=`${2*String(n.length).length+3}ch`,o.value=String(n.speed)};return n.addEventListener(
"step",d),n.addEventListener("state",d),n.addEventListener("state",c),i.addEventListener("keydown",m=>{!(m.target instanceof HTMLSelectElement||m.key===" "&&m.target!==
t)&&Mo(n,m)&&m.preventDefault()}),d(),i}var R=(n,e=2)=>n==null?"-":n.toFixed(e);function To(n,e,t){return e===null||t===null?R(n):`${R(n)} (${R(e)} to ${R(t)})`}function De(n){let e=Math.abs(n),t=e>=1e4?
e.toExponential(0):e.toFixed(e<100?2:0);return n<0&&Number(t)?`−${t}`:t}var te=n=>n.charAt(0).toUpperCase()+n.slice(1);function pt(n,e,t,r=!1){let s=(e-n)/Math.max(1,t),o=10**Math.floor(Math.log10(s||1)),a=[1,2,5,10].map(c=>c*o).find(
c=>c>=s)??10*o;r&&(a=Math.max(1,Math.round(a)));let i=Math.ceil(n/a-1e-9),l=Math.floor(e/a+1e-9);return Array.from({length:Math.max(0,l-i+1)},(c,d)=>(i+d)*a)}var er={right:12,top:10,bottom:42},Zt={x:56,y:34,letter:8,label:30};function V(n,e,t,r){let{top:s}=er,o=Math.max(s+40,e-er.bottom),a=pt(r.low,r.high,(o-s)/Zt.y,
r.whole),i=Zt.label+Zt.letter*Math.max(2,...a.map(g=>tr(g).length)),l=Math.max(i+40,n-er.right),c=(g,b,v)=>x=>b+(x-g.low)/(g.high-g.low||1)*(v-b),d=c(t,i,l),m=c(
r,o,s),h=w("g"),p=w("svg",{width:n,height:e,viewBox:`0 0 ${n} ${e}`,class:"plot"}),f=w("g",{class:"axes"});for(let g of a)f.append(w("line",{x1:i,x2:l,y1:m(g),y2:m(
g),class:"grid"}),w("text",{x:i-8,y:m(g),"text-anchor":"end","dominant-baseline":"middle"},tr(g)));for(let g of pt(t.low,t.high,(l-i)/Zt.x,t.whole))f.append(w("\
text",{x:d(g),y:o+16,"text-anchor":"middle"},tr(g)));return f.append(w("line",{x1:i,x2:l,y1:o,y2:o,class:"axis"}),w("text",{x:(i+l)/2,y:e-6,"text-anchor":"middl\
e",class:"label"},t.label),w("text",{transform:`translate(12 ${(s+o)/2}) rotate(-90)`,"text-anchor":"middle",class:"label"},r.label)),p.append(f,h),{root:p,marks:h,
left:i,right:l,top:s,bottom:o,x:d,y:m,at:g=>{let b=g-p.getBoundingClientRect().left;return t.low+(b-i)/(l-i)*(t.high-t.low)}}}var tr=n=>String(Number(n.toPrecision(
6))).replace("-","−");function q(n,e,t,r){let s="",o="M";t.forEach((a,i)=>{a===null?o="M":(s+=`${o}${n.x(e[i]).toFixed(1)} ${n.y(a).toFixed(1)}`,o="L")}),n.root.
insertBefore(w("path",{d:s,class:`line ${r}`}),n.marks)}function Eo(n,e,t,r=null){let s=n.x(e);n.marks.append(w("line",{x1:s,x2:s,y1:n.top,y2:n.bottom,class:`mark ${t}`})),r!==null&&n.marks.append(w("circle",{cx:s,cy:n.
y(r),r:5,class:`dot ${t}`}))}function We(...n){return u("p",{class:"legend small"},...n.map(([e,t])=>u("span",{class:`key ${t}`},e)))}function K(n,e,t=()=>{},r=()=>{}){
let s=u("div",{class:"chart chooses",role:"img","aria-label":n}),o=null,a=()=>{o?.marks.replaceChildren(),o&&t(o)};s.addEventListener("click",l=>o&&r(o.at(l.clientX),
o,l));let i=()=>{let{clientWidth:l,clientHeight:c}=s;l<50||c<50||(o=e(l,c),s.replaceChildren(o.root),a())};return new ResizeObserver(i).observe(s),{element:s,update:a,
redraw:i}}var ft=[[68,1,84],[72,26,108],[71,47,125],[65,68,135],[57,86,140],[49,104,142],[42,120,142],[35,136,142],[31,152,139],[34,168,132],[53,183,121],[84,197,104],[122,
209,81],[165,219,54],[210,226,27],[253,231,37]];function Jt(n){let e=Math.min(1,Math.max(0,n))*(ft.length-1),t=Math.min(ft.length-2,Math.floor(e)),r=ft[t],s=ft[t+
1],o=a=>Math.round(r[a]+(e-t)*(s[a]-r[a]));return[o(0),o(1),o(2)]}function Oo(n){let[e,t,r]=Jt(n).map(s=>((s/255+.055)/1.055)**2.4);return .2126*e+.7152*t+.0722*
r>.179?"#000":"#fff"}var ko=n=>`rgb(${Jt(n).join(" ")})`,Ro=()=>`linear-gradient(to right, ${ft.map(n=>`rgb(${n.join(" ")})`).join(", ")})`;function Ue(n,e,t){let r=devicePixelRatio||1;for(let[a,i]of Object.entries(t))n.style.setProperty(a,`${i}px`);n.width=Math.round(t.width*r),n.height=Math.round(
t.height*r);let s=n.getContext("2d"),o=Pl(e);!s||!o||(s.imageSmoothingEnabled=!1,s.drawImage(o,0,0,n.width,n.height))}function Pl(n){let[e,t]=n.shape,r=document.
createElement("canvas");r.width=t,r.height=e;let s=r.getContext("2d");if(!s)return null;let o=s.createImageData(t,e);return n.capture_rate.forEach((a,i)=>a.forEach(
(l,c)=>{let d=4*((e-1-i-n.first[0])*t+c+n.first[1]);o.data.set([...Jt(l),255],d)})),s.putImageData(o,0,0),r}function Xt(n,e,t,r=2){n.textContent=R(e,r),n.ariaLabel=
`${t}: ${n.textContent}`,e!==void 0&&(n.style.backgroundColor=ko(e),n.style.color=Oo(e))}function ne(n,e){let t=u("span",{class:"gradient"});return t.style.backgroundImage=
Ro(),u("p",{class:"scale-of-rates small muted"},n,t,e)}function be(n,e,t=n.length){let r=u("canvas",{role:"img","aria-label":e}),s=u("div",{class:"cells-of-matrix"},r),o=u("figure",{},u("figcaption",{},e),s,u("p",{class:"\
small muted"},u("span",{class:"pursuer"},"↑ pursuers")," ",u("span",{class:"evader"},"evaders →")));return o.draw=()=>{let a=s.clientWidth;a&&Ue(r,{shape:[t,
t],first:[0,0],capture_rate:n},{left:0,top:0,width:a,height:a})},new ResizeObserver(()=>o.draw?.()).observe(s),o}var $o=()=>ne("0 all escape","1 all caught"),Po=({
runs:n})=>u("div",{class:"widget"},u("div",{class:"matrices"},...n.map((e,t)=>be(e.payoff.capture_rate,`Matrix ${"ABC"[t]}`))),$o()),Qt=31,Co=.016;function _o(){
let n=t=>Array.from({length:Qt},(r,s)=>Array.from({length:Qt},(o,a)=>.5+t*(s-a))),e=[[Co,"Both get better"],[-Co,"Both get worse"],[0,"Nothing happens"]];return u(
"div",{class:"widget"},u("div",{class:"matrices"},...e.map(([t,r])=>be(n(t),r))),$o())}function Lo(){let n=Array.from({length:Qt},(t,r)=>r),e=K("A capture rate \
that stays at one half from generation 0 to 30",(t,r)=>{let s=V(t,r,{low:0,high:Qt-1,label:"generation",whole:!0},{low:0,high:1,label:"capture rate"});return q(
s,n,n.map(()=>.5),"of-both"),s},()=>{},()=>{});return u("div",{class:"widget"},e.element)}var Y=32,No=({crossings:n=[]})=>u("div",{class:"widget crossings"},...n.
map(e=>u("figure",{},u("figcaption",{},e.title),_l(e),u("p",{class:"small muted"},e.text))));function _l({title:n,text:e,ways:t}){let r=[0,1,2,3].map(s=>`M${s*Y}\
 0V${3*Y}M0 ${s*Y}H${3*Y}`).join("");return w("svg",{viewBox:`-1 -1 ${3*Y+2} ${3*Y+2}`,role:"img","aria-label":`${n}: ${e}`},w("path",{class:"grid",d:r}),...t.map(
([s,o,a],i)=>w("g",{transform:`translate(${1.5*Y} ${1.5*Y})`},w("g",{transform:`translate(${-Y*o} ${-Y*s})`},w("path",{class:"filled-pursuer",d:"M0 -12 12 9H-12\
z"}),w("text",{y:6.5,"text-anchor":"middle"},`P${i}`)),w("path",{class:a?"goes":"waits",d:a?"M-18 0H-5M-9 -4 -4 0 -9 4":"M-16 -13V13",transform:`rotate(${Math.atan2(
s,o)*180/Math.PI})`}))))}function we(n,e,t,r,s){let o=u("input",{type:"range",min:0,max:e.length-1,step:1,"aria-label":n,oninput:()=>s(i())}),a=u("output",{class:"numbers"}),i=()=>{let l=e[Number(
o.value)];return a.textContent=o.ariaValueText=r(l),l};return o.value=String(e.indexOf(t)),i(),u("label",{class:"slider"},u("span",{},n),o,a)}function Io(n,e,t){
return u("label",{class:"slider"},u("span",{},n),Fs(e.map(r=>[r,r]),t))}function ue(n){let e=n>>>0;return()=>{e=e+1831565813>>>0;let t=Math.imul(e^e>>>15,e|1);return t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/2**32}}var rr=["rock",
"paper","scissors"],sr=[[.5,0,1],[1,.5,0],[0,1,.5]],Ll=1e-9,Wo=n=>sr.map(e=>e.reduce((t,r,s)=>t+r*n[s],0));function or(n,e){let t=n.slice(-e);return rr.map((r,s)=>t.
filter(o=>o===s).length/t.length)}var ar=n=>Math.max(...Wo(n));function Fo(n,e,t){let r=Wo(or(n,e)),s=r.flatMap((o,a)=>o>Math.max(...r)-Ll?[a]:[]);return s[s.length>
1?Math.floor(t()*s.length):0]}function tn(n,e,t){let r={pursuers:[0],evaders:[0]};for(let s=1;s<=n;s++)r.pursuers.push(Fo(r.evaders,e,t)),r.evaders.push(Fo(r.pursuers,
e,t));return r}var gt=100,nn={scalar:{dimensions:1,greatest:!0},focusing:{dimensions:10,greatest:!0},intransitive:{dimensions:2,greatest:!1}};function nr(n,e,t){
let{greatest:r}=nn[n],s=e[0]-t[0];for(let o=1;o<e.length;o++){let a=e[o]-t[o];(r?Math.abs(a)>Math.abs(s):Math.abs(a)<Math.abs(s))&&(s=a)}return(1+Math.sign(s))/
2}var ir=(n,e,t)=>e.reduce((r,s)=>r+t.reduce((o,a)=>o+nr(n,s,a),0),0)/(e.length*t.length),ze={population:25,mutation:.005,opponents:15,hall:0},He=class{game;settings;generation=0;#e;#n;#t=[
[],[]];constructor(e,t,r){this.game=e,this.settings=t,this.#e=r;let s=()=>Array.from({length:t.population},()=>new Uint8Array(gt));this.#n=[s(),s()]}ones(e){let{
dimensions:t}=nn[this.game],r=gt/t;return this.#n[e].map(s=>Array.from({length:t},(o,a)=>en(s.subarray(a*r,(a+1)*r))))}objective=e=>en(this.#n[e].map(en))/this.
settings.population;step(){let e=[this.ones(0),this.ones(1)],t=this.#r(e);for(let r of[0,1]){this.#t[r].push(e[r][t[r].indexOf(Math.max(...t[r]))]);let s=this.#s(
t[r]);this.#n[r]=s.map(o=>this.#a(this.#n[r][o]))}this.generation++}#r(e){let{population:t,opponents:r,hall:s}=this.settings,o=[new Array(t).fill(0),new Array(t).
fill(0)];for(let a=0;a<r;a++)Do(t,this.#e).forEach((i,l)=>{let c=nr(this.game,e[0][l],e[1][i]);o[0][l]+=+(c===1),o[1][i]+=+(c===0)});for(let a of[0,1]){let i=this.#t[1-
a];for(let l of Do(i.length,this.#e,s))e[a].forEach((c,d)=>o[a][d]+=+(nr(this.game,c,i[l])===1))}return o}#a(e){let t=e.slice();for(let r=0;r<t.length;r++)this.#e()<
this.settings.mutation&&(t[r]^=1);return t}#s(e){let t=en(e),r=t?e:e.map(()=>1);return e.map(()=>{let s=this.#e()*(t||e.length),o=r.findIndex(a=>(s-=a)<0);return o<
0?e.length-1:o})}};function Do(n,e,t=n){let r=Array.from({length:n},(o,a)=>a),s=Math.min(t,n);for(let o=0;o<s;o++){let a=o+Math.floor(e()*(n-o));[r[o],r[a]]=[r[a],
r[o]]}return r.slice(0,s)}function en(n){let e=0;for(let t=0;t<n.length;t++)e+=n[t];return e}var lr=1,rn=["pursuers","evaders"],zo=[[150,42],[266,232],[34,232]],Nl={pursuers:-7,evaders:7},Uo=n=>[0,1].map(e=>n.reduce((t,r,s)=>t+r*zo[s][e],0)),Ho=(n,e)=>n.
map((t,r)=>or(n.slice(0,r+1),e));function Go({memories:n=[1],memory:e=n[0],generations:t=30}){let r=new ce(t,{speed:t>100?16:2,still:le()}),s=e,o=tn(t,s,ue(lr)),
a={pursuers:[],evaders:[]},i={pursuers:w("polyline",{class:"way of-pursuers"}),evaders:w("polyline",{class:"way of-evaders"})},l={pursuers:w("path",{class:"fill\
ed-pursuer",d:"M0 -11 11 9H-11z"}),evaders:w("circle",{class:"filled-evader",r:9})},c=w("svg",{viewBox:"0 0 300 270",class:"hands-triangle",role:"img","aria-lab\
el":"The shares of rock, paper and scissors among the remembered hands of both teams"},w("polygon",{class:"frame",points:zo.map(g=>g.join()).join(" ")}),w("circ\
le",{class:"middle",cx:150,cy:168.7,r:4}),w("text",{x:150,y:192,"text-anchor":"middle"},"one third each"),w("text",{class:"label",x:150,y:18,"text-anchor":"midd\
le"},"rock"),w("text",{class:"label",x:266,y:262,"text-anchor":"middle"},"paper"),w("text",{class:"label",x:34,y:262,"text-anchor":"middle"},"scissors"),...rn.map(
g=>i[g]),...rn.map(g=>l[g])),d=u("p",{class:"numbers"}),m=K("What the best answer wins against the remembered hands, by generation",(g,b)=>{let v=V(g,b,{low:0,high:t,
label:"generation",whole:!0},{low:.4,high:1,label:"best answer wins"});q(v,[0,t],[.5,.5],"half");for(let x of rn)q(v,o[x].map((A,T)=>T),a[x].map(ar),`of-${x}`);
return v},g=>Eo(g,r.step,"of-both"),g=>r.jump(g)),h=()=>{let g=r.step;for(let v of rn){i[v].setAttribute("points",a[v].slice(0,g+1).map(T=>Uo(T).map(_=>_.toFixed(
1)).join()).join(" "));let[x,A]=Uo(a[v][g]);l[v].setAttribute("transform",`translate(${x+Nl[v]} ${A})`)}let b=v=>u("span",{class:v.slice(0,-1)},`${v} show ${rr[o[v][g]]}`);
d.replaceChildren(`Generation ${g}: `,b("pursuers"),", ",b("evaders"),".",...n.length>1?[` The best answer to the remembered hands of the pursuers wins ${R(ar(a.
pursuers[g]))}.`]:[]),m.update()},p=()=>{o=tn(t,s,ue(lr)),a={pursuers:Ho(o.pursuers,s),evaders:Ho(o.evaders,s)},m.redraw(),h()};r.addEventListener("step",h),p();
let f=n.at(-1),y=we("memory (hands)",n,e,g=>g===f?"all":String(g),g=>{s=g,p()});return u("div",{class:"widget"},n.length>1&&y,u("div",{class:"two"},u("div",{},c),
n.length>1&&u("div",{},We(["pursuers' hands","of-pursuers"],["evaders' hands","of-evaders"]),m.element)),d,Fe(r))}function Bo({generations:n=30}){let{pursuers:e,
evaders:t}=tn(n,1,ue(lr)),r=e.map(o=>t.map(a=>sr[o][a])),s=r.at(-1);return u("div",{class:"widget"},u("div",{class:"matrices"},be(r,`The last pursuers score ${R(
s.reduce((o,a)=>o+a,0)/s.length)} against all evaders.`)),ne("0 loses","1 wins"))}var yt=600,Ge=20,cr=5,vt=10,ur={"Game A":"intransitive","Game B":"scalar","Game C":"focusing"},Vo={low:0,high:yt,label:"generation",whole:!0},qo={low:0,high:gt,
label:"ones of side 1"},xe=()=>{},Il=()=>new Promise(n=>setTimeout(n));async function dr(n,e,t){for(e();n.generation<yt&&t();e()){for(let r=0;r<Ge;r++)n.step();
await Il()}}var sn=new Map,Ko=[];async function Fl(){for(let n of Object.keys(ur))sn.set(n,[]);for(let n=0;n<cr;n++)for(let[e,t]of Object.entries(ur)){let r={score:[],
ones:[]};sn.get(e).push(r);let s=new He(t,ze,ue(n));await dr(s,()=>{r.score.push(ir(t,s.ones(0),s.ones(1))),r.ones.push(s.objective(0))},()=>!0),Ko.forEach(o=>o())}}
function Yo({shows:n="score"}){sn.size||Fl();let e=n==="score"?{low:0,high:1,label:"score of side 1"}:qo,t=Object.entries(ur).map(([r,s])=>{let o=n==="score"?r:
`${r}: ${s}`,a=K(`${o}: ${e.label} in ${cr} races`,(i,l)=>{let c=V(i,l,Vo,e);for(let d of sn.get(r))q(c,d[n].map((m,h)=>h*Ge),d[n],"of-both dense");return c},xe,
xe);return Ko.push(a.redraw),u("figure",{},u("figcaption",{},o),a.element)});return u("div",{class:"widget"},u("div",{class:"matrices"},...t),u("p",{class:"smal\
l muted"},`Each line is a race; there are ${cr} of each game, played now, in this page.`))}var Dl=[5,10,15,25,40,60],Wl=[5e-4,.001,.002,.005,.01,.02,.05],Ul=[0,
1,5,15,30],jo=15,Hl=Array.from({length:20},(n,e)=>e);function Zo({hall:n=!1}){let e="scalar",t=0,r={...ze,hall:n?jo:0},s=0,o=v=>{r={...r,...v}},a=[[],[]],i=[be(
a[0],"Score of side 1",yt/Ge+1),be(a[1],"Score of side 2",yt/Ge+1)];i.forEach(v=>v.querySelector("p").replaceChildren(`↑ generation, → opponent (${Ge} a cel\
l)`));let l=[[],[]],c=K("Ones of both sides by generation",(v,x)=>{let A=V(v,x,Vo,{...qo,label:"ones"});return l.forEach((T,_)=>q(A,T.map((J,W)=>W*Ge),T,_?"of-e\
vaders":"of-pursuers")),A},xe,xe),d=u("p",{class:"numbers",role:"status"}),m=v=>{d.textContent=v},h=async()=>{let v=++s;for(let T of[...a,...l])T.length=0;let x=[
[],[]],A=new He(e,r,ue(t));await dr(A,()=>{for(let T of[0,1])x[T].push(A.ones(T)),l[T].push(A.objective(T));for(let T of[0,1])a[T].push(x[1-T].map(_=>ir(A.game,
x[T].at(-1),_)));i.forEach(T=>T.draw?.()),c.redraw()},()=>s===v),s===v&&m(`${te(A.game)} game, seed ${t}: after ${yt} generations side 1 has ${l[0].at(-1).toFixed(
0)} ones, side 2 ${l[1].at(-1).toFixed(0)}.`)},p=[],f=K("Ones of side 1 at the end of ten races, a row for each choice of settings",(v,x)=>zl(p,v,x),xe,xe);f.element.
classList.add("dots");let y=async v=>{let x=++s,A=[],{population:T,mutation:_}=v,J=`${e}${T===ze.population?"":`, ${T} players`}${_===ze.mutation?"":`, mutation\
 ${_}`}, hall ${v.hall}`;p=[...p.filter(W=>W.ends.length===vt&&W.text!==J).slice(1-mr),{text:J,ends:A}];for(let W=0;W<vt&&s===x;W++){let re=new He(e,v,ue(W));await dr(
re,xe,()=>s===x),s===x&&A.push(re.objective(0)),f.redraw()}s===x&&m(`${te(J)}: side 1 ends with ${Jo(A)} ones in the mean of ${vt} races.`)},g=(v,x,A="")=>u("bu\
tton",{type:"button",class:A,onclick:()=>{v()}},x),b=u("div",{class:"sliders"},Io("game",Object.keys(nn),v=>e=v),we("population",Dl,r.population,String,v=>o({population:v})),
we("mutation",Wl,r.mutation,String,v=>o({mutation:v})),...n?[we("hall of fame",Ul,jo,String,v=>o({hall:v}))]:[we("seed",Hl,0,String,v=>t=v)]);return n?(y(ze).then(
()=>s===1?y(r):void 0),u("div",{class:"widget"},b,u("div",{class:"buttons"},g(()=>y(r),"Play ten races","primary")),d,f.element)):u("div",{class:"widget"},b,u("\
div",{class:"buttons"},g(h,"Play a race","primary"),g(async()=>{s++},"Stop")),u("div",{class:"matrices"},...i,u("figure",{},u("figcaption",{},"The truth: ones"),
We(["side 1","of-pursuers"],["side 2","of-evaders"]),c.element)),ne("0 loses","1 wins"),d)}var mr=6,Jo=n=>(n.reduce((e,t)=>e+t,0)/n.length).toFixed(1);function zl(n,e,t){
let r=V(e,t,{low:0,high:gt,label:"ones of side 1 at the end",whole:!0},{low:0,high:mr,label:""});return r.root.querySelectorAll(".axes .grid, .axes [text-anchor\
=end]").forEach(s=>s.remove()),n.forEach(({text:s,ends:o},a)=>{let i=r.y(mr-a-.7);r.marks.before(w("text",{class:"label",x:r.left,y:i-12},`${s}: ${o.length<vt?`${o.
length} of ${vt} races`:`mean ${Jo(o)}`}`)),o.forEach(l=>r.marks.before(w("circle",{class:"dot of-both",cx:r.x(l),cy:i,r:5})))}),r}var Qo=n=>n.answer===void 0?Bl():Gl(n,n.answer);function Gl(n,e){let t=u("input",{type:"text",inputmode:"decimal",size:8,"aria-label":"Your answer, a number",autocomplete:"\
off"});return{input:t,check:()=>{let s=t.value.trim().replace(",","."),o=Number(s);if(s===""||Number.isNaN(o))return"Expected a number, such as 0.5.";let a=i=>Math.
abs(o-i)<=(n.tolerance??0)+1e-9;return a(e)?null:n.clues?.find(([i])=>a(i))?.[1]??n.otherwise??"Expected another number."},answer:()=>t.value,set:s=>t.value=s}}
var G=4,hr=[.5,.8,.2];function Bl(){let n=new Array(G*G).fill(.5),e=(l,c)=>Xt(l,n[c],`generation ${Math.floor(c/G)} of the pursuers against generation ${c%G} of\
 the evaders`,1),t=n.map((l,c)=>{let d=u("button",{type:"button",disabled:c%(G+1)===0,onclick:()=>{n[c]=hr[(hr.indexOf(n[c])+1)%hr.length],e(d,c)}});return e(d,
c),d}),r=Array.from({length:G},(l,c)=>c),s=u("div",{class:"cells numbers",role:"group","aria-label":"Capture rates: rows are pursuers, columns evaders"},u("span"),
u("span",{class:"evader all"},"generation of the evaders"),u("span",{class:"pursuer"},"generation of the pursuers"),...r.map(l=>u("span",{class:"evader"},l)),...r.
flatMap(l=>[u("span",{class:"pursuer"},l),...t.slice(l*G,(l+1)*G)])),o=l=>r.map(c=>r.reduce((d,m)=>d+n[l(c,m)],0)/G);return{input:s,check:()=>{let l=o((m,h)=>m*
G+h),c=o((m,h)=>h*G+m),d=(m,h)=>m.every((p,f)=>!f||h*(p-m[f-1])>1e-9);return d(l,1)?d(c,-1)?null:`The means of the columns are ${Xo(c)}. They say how often the \
evaders are captured, and should fall from column to column.`:`The means of the rows are ${Xo(l)}. They are the strengths of the pursuers, and should grow from \
row to row.`},answer:()=>n.join(" "),set:l=>{l.split(" ").forEach((c,d)=>n[d]=Number(c)),t.forEach(e)}}}var Xo=n=>n.map(e=>e.toFixed(2)).join(", ");var bt=n=>n.trim().split(/\n\s*\n/).map(e=>u("p",{},...pr(e))),pr=n=>n.split("**").map((e,t)=>t%2?u("strong",{},e):document.createTextNode(e));function ea(n,e){
let{predict:t,options:r}=n,s=u("p",{class:"small muted",role:"status"}),o=u("button",{type:"submit",class:"primary"},"This is my prediction"),a=Object.keys(r).map(
c=>u("input",{type:"radio",name:`prediction-${t}`,value:c})),i=u("form",{class:"prediction",id:`prediction-${t}`},u("fieldset",{},u("legend",{},u("strong",{},"P\
redict. "),n.question),...a.map(c=>u("label",{class:"option"},c,u("span",{},r[c.value])))),u("div",{class:"buttons"},o,s)),l=()=>{let c=e.choice(t);if(c!==void 0){
for(let d of a)d.checked=d.value===c,d.disabled=!0;o.hidden=o.disabled=!0,s.replaceChildren(),i.append(n.later?u("p",{class:"reply"},n.later):jl(n,c,n.again&&e.
choice(n.again)))}};return i.addEventListener("submit",c=>{c.preventDefault();let d=a.find(m=>m.checked);d?(e.choose(t,d.value),l()):s.textContent="Choose one f\
irst. Any prediction is a good one."}),l(),i}function jl(n,e,t){let{options:r,outcome:s}=n,o=e===s;return u("div",{class:"reply",role:"status","data-right":String(
o)},t&&u("p",{},u("strong",{},"At the beginning you predicted: "),r[t]),u("p",{},u("strong",{},o?"✓ As you predicted: ":"You predicted: "),r[e]),o?null:u("p",
{},u("strong",{},"The outcome: "),r[s]),...bt(n.explanation??""),n.note&&u("p",{class:"small muted"},n.note))}function ta(n,e){let{input:t,check:r,answer:s,set:o}=Qo(
n),a=u("p",{class:"reply",role:"status",hidden:!0}),i=d=>{a.hidden=!1,a.dataset.right=String(d===null),a.replaceChildren(u("strong",{},d===null?"✓ Right. ":"✗\
 Not yet. "),d??n.explanation)},l=u("form",{class:"exercise",id:`exercise-${n.exercise}`},u("div",{class:"text"},u("p",{},u("strong",{},"Exercise. "),...pr(n.question))),
n.matrix&&Vl(n.matrix),u("div",{class:"buttons"},t,u("button",{type:"submit"},"Check")),a);l.addEventListener("submit",d=>{d.preventDefault();let m=r();m===null&&
e.solve(n.exercise,s()),i(m)});let c=e.solved(n.exercise);return c!==void 0&&(o(c),i(null)),l}function Vl(n){let e=n.map((t,r)=>r);return u("div",{class:"wide-t\
able",tabindex:0},u("table",{class:"rates numbers"},u("thead",{},u("tr",{},u("td"),u("th",{scope:"colgroup",colspan:e.length,class:"evader"},"generation of the \
evaders")),u("tr",{},u("th",{class:"pursuer"},"generation of the pursuers"),...e.map(t=>u("th",{scope:"col"},t)))),u("tbody",{},...n.map((t,r)=>u("tr",{},u("th",
{scope:"row"},r),...t.map(s=>u("td",{},s.toFixed(1))))))))}var ql=40;function na({question:n="",points:e=[]},t){let r=u("textarea",{id:"exit-answer",rows:8,oninput:()=>{
t.exit={exit:r.value},s.textContent=r.value}}),s=u("p",{class:"printed"}),o=u("p",{class:"small muted",role:"status"}),a=u("button",{type:"submit",class:"primar\
y"},"I am done"),i=u("form",{class:"exercise"},u("label",{for:"exit-answer"},u("strong",{},"Exit question. "),n),r,s,u("div",{class:"buttons"},a,u("button",{type:"\
button",onclick:()=>It("exit_answer.txt",`${n}

${r.value}
`)},"Save my answer"),o)),l=()=>{s.textContent=t.exit.exit,t.exit.done&&(r.readOnly=!0,a.hidden=!0,i.append(u("div",{class:"reply"},u("p",{},u("strong",{},"A go\
od answer has:")),u("ul",{},...e.map(c=>u("li",{},...pr(c)))))))};return r.value=t.exit.exit,i.addEventListener("submit",c=>{if(c.preventDefault(),r.value.trim().
length<ql){o.textContent="Write two explanations and an experiment first. Then the page shows what a good answer has.";return}o.textContent="",t.exit={done:!0},
l()}),l(),u("div",{class:"widget"},i)}var Kl=Array.from({length:16},(n,e)=>{let t=e%2?6.5:11,r=Math.PI*e/8;return`${12+t*Math.sin(r)} ${12-t*Math.cos(r)}`}).join(" ");function on(){let n=[["pursuer",
w("path",{d:"M12 3 22 20H2z",class:"filled-pursuer"})],["evader",w("circle",{cx:12,cy:12,r:9,class:"filled-evader"})],["capture",w("polygon",{points:Kl,class:"f\
illed-capture"})],["captured evader",w("circle",{cx:12,cy:12,r:7.5,class:"ring-evader"})],["conflict",w("rect",{x:3,y:3,width:18,height:18,class:"dashed-conflic\
t"})]];return u("ul",{class:"shapes small","aria-label":"Shapes on the board"},...n.map(([e,t])=>u("li",{},w("svg",{viewBox:"0 0 24 24","aria-hidden":"true"},t),
e)))}function Yl(n,e,t){let{rows:r,cols:s,n_pursuers:o,fov:a,rules:{interaction:i}}=n;return{rows:r,cols:s,nPursuers:o,fov:a,interaction:i,obstacles:e,moments:t}}function an(n){let e=Array.from({length:n.length+1},(t,r)=>Zl(n,r));return Yl(n.config,n.map,e)}function Zl(n,e){let t=n.n_agents,r=n.config.n_evaders,s=(a,i,l)=>a.
subarray(i*l,(i+1)*l),o={positions:s(n.last_positions,e,2*t),alive:s(n.alive,e,t),captured:s(n.captured,e,r),everCaptured:s(n.ever_captured,e,r)};return e===0?o:
{...o,actions:s(n.actions,e-1,t),involved:s(n.involved,e-1,3*t),fault:s(n.fault,e-1,3*t),get contested(){return n.conflicts(e).map(a=>a.cell)}}}var Jl=8,Xl=900,ra=1800,Se=class extends EventTarget{element;player=new ce(0,{speed:Jl,still:le()});match=null;agent=null;#e=u("figcaption");#n=u("canvas",{onclick:({
clientX:e,clientY:t})=>this.#u(e,t)});#t;#r=u("p",{class:"small muted numbers"});#a=u("p",{class:"small",role:"status"});#s=null;#l=!1;constructor(){super(),this.#t=
new Ie(this.#n,{numbers:!1}),this.element=u("figure",{class:"chase"},this.#e,this.#n,this.#r,this.#a),this.player.addEventListener("frame",()=>this.#c()),this.player.
addEventListener("step",()=>this.#d()),this.player.addEventListener("state",()=>this.over&&this.dispatchEvent(new Event("over")))}get over(){return this.player.
length>0&&!this.player.playing&&this.player.step===this.player.length}get title(){return this.#e.textContent}get recording(){return this.#s}show(e,t){this.match=
e,this.#s=an(e),this.#e.textContent=t,this.#n.ariaLabel=`A match. ${t}`,this.player.jump(0),this.player.length=e.length,this.player.marks=zt(this.#s),this.#d()}choose(e){
this.agent=e,this.#t.look={selected:e,viewers:e===null?[]:[e]},this.dispatchEvent(new Event("agent"))}#u(e,t){this.#l||this.choose(this.#t.agentAt(e,t))}#c(){this.#s&&
this.#t.show(this.#s,this.player.time)}#d(){let e=this.#s?.moments[this.player.step]?.everCaptured;e&&(this.#r.textContent=`${Array.from(e).filter(Boolean).length}\
 of ${e.length} caught in ${this.player.step} steps`),this.dispatchEvent(new Event("step"))}drawWalls(e){let t=!1,r=!0,s=[0,0],o=([l,c])=>!!this.#s?.obstacles[l*
this.#s.cols+c],a=(l,c)=>{this.#a.textContent=e(l,c)},i=l=>{let c=this.#t.cellAt(l.clientX,l.clientY);c&&o(c)!==r&&a(c,r)};return this.#n.addEventListener("poin\
terdown",l=>{let c=t&&this.#t.cellAt(l.clientX,l.clientY);c&&(this.#n.setPointerCapture(l.pointerId),r=!o(c),i(l))}),this.#n.addEventListener("pointermove",l=>t&&
l.buttons&&i(l)),this.#n.addEventListener("keydown",l=>{let c={ArrowUp:[-1,0],ArrowDown:[1,0],ArrowLeft:[0,-1],ArrowRight:[0,1]}[l.key];if(!t||!this.#s||!(c||l.
key===" "))return;l.preventDefault();let d=(p,f)=>Math.min(f-1,Math.max(0,p)),{rows:m,cols:h}=this.#s;c?s=[d(s[0]+c[0],m),d(s[1]+c[1],h)]:a(s,!o(s)),this.#t.look=
{cursor:s}}),l=>{t=this.#l=l,this.#n.classList.toggle("drawn-on",l),this.#n.tabIndex=l?0:-1,this.#n.setAttribute("role",l?"application":"img"),this.#t.look={cursor:null}}}showWalls(e){
this.#s&&(this.#s={...this.#s,obstacles:e},this.#c())}},Be=class{boards;#e;#n=-1/0;#t=0;#r=!le();constructor(e,...t){this.#e=e,this.boards=t;for(let r of t)r.addEventListener(
"over",()=>this.#r&&t.every(({over:s})=>s)&&this.#a(Xl))}get runs(){return this.#r}set runs(e){this.#r=e,clearTimeout(this.#t),this.#t=0;for(let{player:t}of this.
boards)e?t.play():t.pause()}renew(e=!1){e||performance.now()-this.#n>ra?this.#s():this.#t||this.#a(ra)}#a(e){clearTimeout(this.#t),this.#t=setTimeout(()=>this.#s(),
e)}#s(){if(clearTimeout(this.#t),this.#t=0,this.#n=performance.now(),this.#e(),this.#r)for(let{player:e}of this.boards)e.play()}};function fr(n,e){let t=n.runs;
new IntersectionObserver(([r])=>{r.isIntersecting?t&&!n.runs&&(n.runs=!0):(t=n.runs,n.runs=!1)}).observe(e)}var Me=["stay","north","east","south","west","northeast","southeast","southwest","northwest"];var sa="champion",oa=0,gr=64,yr=100;var Ql=(n,e)=>Object.keys(n).every(t=>n[t]===e[t]);function aa(n,e){return Object.keys(e).find(t=>Ql(e[t],n))??null}function ia(n,e,t){let r=new Set(n);return Array.
from({length:e},(s,o)=>Array.from({length:t},(a,i)=>r.has(o*t+i)?"#":".").join(""))}var ca={"specialist-specialist":"Specialists: both teams meet only the newest opponent","generalist-specialist":"Pursuers meet all earlier evaders, evaders only\
 the newest pursuers","generalist-generalist":"Generalists: both teams meet all earlier opponents","hall-of-fame":"Halls of fame: both teams learn at once, and \
meet earlier champions"};function la({schedule:n}){if(n.kind==="hall-of-fame")return n.kind;let e={latest:"specialist","round-robin":"generalist",uniform:"unifo\
rm"};return`${e[n.pursuers_meet]}-${e[n.evaders_meet]}`}var ln=n=>ca[la(n)]??la(n);var ec=15;function ua(n,e=""){let t=Object.hasOwn(n.worlds,e)?e:Object.keys(n.worlds)[0],{n_pursuers:r,n_evaders:s,fov:o,max_steps:a}=n.worlds[t];return{world:t,schedule:"\
generalist-generalist",beside:"",learner:"es",policy:"rating",seed:0,generations:ec,way:!1,population:0,pursuers:r,evaders:s,view:o,steps:a,walls:null}}function da(n,e,t=e.
schedule){let r=n.races[e.policy][e.learner][t],s=n.worlds[e.world],o={...s,n_pursuers:e.pursuers,n_evaders:e.evaders,fov:e.view,max_steps:e.steps,obstacles:e.walls?
ia(e.walls,s.rows,s.cols):s.obstacles},a=e.way?"right-of-way":e.policy==="rating"?"obstacles":"none";return{...r,world:o,train_steps:e.steps,seed:e.seed,policy:{
...r.policy,mask:a},learner:{...r.learner,population:e.population||r.learner.population},schedule:{...r.schedule,generations:e.generations}}}var ma=0,ha=1,tc=2,nc=176;function fa(n,e,t,r){let s=devicePixelRatio||1,o=qt(n);n.width=n.height=nc*s;let a=n.getContext("2d");if(!a)return;let{fov:i}=e,l=n.width/
i;a.fillStyle=o.paper,a.fillRect(0,0,n.width,n.height);for(let d=0;t&&d<i*i;d++){let m=(d%i+.5)*l,h=(Math.floor(d/i)+.5)*l,p=y=>!!t[y*i*i+d];p(tc)&&(a.fillStyle=
o.obstacle,a.fillRect(m-l/2,h-l/2,l,l));let f=p(ma)&&p(ha)?l*.18:0;p(ma)&&pa(a,ve,m+f,h+f,l*.74,o.evader),p(ha)&&pa(a,jt,m-f,h-f,l*.86,o.pursuer)}a.strokeStyle=
r<e.n_pursuers?o.pursuer:o.evader,a.lineWidth=2*s;let c=Math.floor(i/2)*l;a.strokeRect(c,c,l,l)}function pa(n,e,t,r,s,o){e(n,t,r,s),n.fillStyle=o,n.fill()}var rc=["stay","↑","→","↓","←","↗","↘","↙","↖"];function ga(n,{inputs:e,ratings:t,refused:r},s,o){let a=xs(n,o),i=f=>a?a[n.inputs[f]]??0:1,l=f=>a||
!o?i(f)!==0:new RegExp(`\\b${n.inputs[f]}\\b`).test(o.expression),c=[...n.inputs.keys()].filter(l).sort((f,y)=>Math.abs(i(y))-Math.abs(i(f))),d=f=>`${f===s?"tak\
en":""} ${r[f]?"refused":""}`,m=(f,y)=>u("tr",{class:y.every(g=>g===y[0])?"same":""},f,...Array.from(y,(g,b)=>u("td",{class:d(b)},De(g)))),h=f=>{let y=n.inputs[f];
return u("th",{scope:"row",title:`${a?`weight ${De(i(f))} x `:""}${de[y]}`},y.replaceAll("_"," "))},p=u("table",{class:"why numbers"},u("thead",{},u("tr",{},u("\
th",{},a?"term":"input"),...Array.from(t,(f,y)=>u("th",{scope:"col",class:d(y),title:Me[y],"aria-label":Me[y]},rc[y]))),m(u("th",{scope:"row"},a?"sum":"rating"),
t)),u("tbody",{},...c.map(f=>m(h(f),e[f].map(y=>i(f)*y)))));return[...o?[u("p",{class:"expression"},u("code",{},o.expression))]:[],u("div",{class:"wide-table",tabindex:0,
role:"group","aria-label":"How the moves are rated"},p)]}var sc=(n,{pursuer:e,evader:t})=>({pursuers:ae(n,"pursuer",e),evaders:ae(n,"evader",t)}),ya="What it remembers: a number for each unit, from -1 to 1",je=class{element;#e;#n=u(
"canvas",{class:"seen",role:"img"});#t=u("h3");#r=u("p",{class:"small muted"});#a=u("div",{class:"answers"});#s=u("div",{title:ya});#l=null;#u=null;#c=null;#d=null;#f=null;#m=null;#o=null;#h=0;constructor(e){
this.#e=e,this.element=u("div",{class:"inspector","data-open":"false"},u("p",{class:"hint small muted"},"Click an agent, or press A: what it sees, and why it ta\
kes its move."),u("div",{class:"inspected"},this.#n,u("div",{class:"answer"},this.#t,this.#r,this.#s),this.#a))}get agent(){return this.#o}show(e,t,r,s,o=sc(t,s)){
this.#l?.free(),this.#l=e.world(r.config),this.#c!==t&&(this.#u=null,this.#o!==null&&this.choose(null)),this.#c=t,this.#d=r,this.#f=s,this.#m=o}set solution(e){
this.#u=e,this.at(this.#h)}choose(e){this.#o=e,this.element.dataset.open=String(e!==null),this.#e(e),this.at(this.#h)}next(e){let t=this.#d;if(!t)return;let r=this.#o??
(e>0?-1:0);for(let s=0;s<t.n_agents;s++)if(r=(r+e+t.n_agents)%t.n_agents,t.alive[this.#h*t.n_agents+r])return this.choose(r)}at(e){this.#h=e;let t=this.#d,r=this.#l,
s=this.#c,o=this.#f,a=this.#m,i=this.#o;if(!t||!r||!s||!o||!a||i===null)return;let l=i<t.config.n_pursuers?"pursuer":"evader";this.#s.replaceChildren(),this.#t.
replaceChildren(u("span",{class:l},B(i,t.config.n_pursuers))),t.seek(r,e,a);let c=t.actions.subarray(e*t.n_agents,(e+1)*t.n_agents);for(;c.length&&!r.over&&(i<r.
actors[0]||i>=r.actors[1]);)r.playTurn(c);let d=!!(t.alive[e*t.n_agents+i]&&r.read("alive")[i]);fa(this.#n,t.config,d?r.view(i):null,i),this.#n.ariaLabel=`Field\
 of view of ${B(i,t.config.n_pursuers)}: evaders, pursuers and obstacles around it`;let m=c[i]??null;if(!d)return this.#i([],"It is gone.");let h=a[`${l}s`],p=typeof h!=
"string"&&h.kind==="cells"?r.answer(h,i):null,f=p?.probabilities??null;p?.memory.length&&this.#s.replaceChildren(u("p",{class:"small muted"},"It remembers:"),lc(
p.memory));let y=typeof h!="string"&&h.kind!=="cells"?ga(h,r.rate(h,i),m,ws(s,l,o[l])):[],g=this.#u?.game(r)??null,b=[["network",f],["perfect",g?.marginal(i)??null]],
v=x=>u("p",{class:"small muted"},x);this.#i([...g?[v(`Value ${g.value.toFixed(2)} under perfect play.`)]:[],...ac(b,m),...y],m===null?"The episode is over.":oc(
h,m))}#i(e,t){this.#a.replaceChildren(...e),this.#r.textContent=t}};function oc(n,e){return typeof n=="string"?`The script "${n}" plays for it; it goes ${Me[e]}\
.`:n.kind!=="cells"?"It takes the best move that its mask allows; of equal ones any.":n.sampled?"Its action is drawn from these probabilities.":"It takes the mo\
st probable action."}function ac(n,e){let t=n.filter(([,o])=>o);if(!t.length)return[];let r=u("div",{class:"action muted"},u("span"),...t.map(([o])=>u("span",{class:"\
head"},o))),s=Array.from(t[0][1],(o,a)=>u("div",{class:a===e?"action taken":"action"},u("span",{},Me[a]),...t.flatMap(([,i])=>ic(i[a]))));return t.length>1||t[0][0]!==
n[0][0]?[r,...s]:s}function ic(n){let e=u("span",{class:"filled"});return e.style.width=`${100*n}%`,[u("span",{class:"track"},e),u("span",{class:"numbers"},n.toFixed(
2))]}function lc(n){let e=Array.from(n,t=>{let r=u("span",{title:t.toFixed(2)});return r.style.transform=`scaleY(${t})`,r});return u("div",{class:"units",role:"\
img","aria-label":ya},...e)}var cc=40,cn=class{element;#e;#n=u("div",{class:"episodes",role:"group","aria-label":"Episodes of this cell"});#t=u("p",{class:"check small numbers","aria-live":"\
polite"});constructor(e){this.#e=e,this.element=u("div",{class:"strip-of-episodes"},this.#n,this.#t)}show(e,t){let{pursuer:r,evader:s,episode:o,seed:a}=this.#e.
selected,i=ie(e,r,s);this.#n.replaceChildren(...(i?.rates??[]).slice(0,cc).map((h,p)=>this.#r(h,p)));let l=a===null?i?.rates[o]:void 0,c=t.statistics.capture_rate,
d=l!==void 0&&Math.abs(c-l)<1e-6&&t.length===i?.lengths[o],m=i?"Not an episode of the evaluation":"The evaluation played no episodes of this pair.";this.#t.dataset.
equal=String(d),this.#t.textContent=d?"As in the evaluation":l===void 0?m:`Episode ${o+1} differs from the evaluation.`,this.#t.title=`Played here: capture rate\
 ${R(c,3)} in ${t.length} steps.${i?` The cell says ${R(i.rate,3)}.`:""}`}#r(e,t){let{selected:r}=this.#e,s=u("span",{class:"bar"});return s.style.height=`${Math.
round(100*e)}%`,u("button",{type:"button",class:"episode",title:`Episode ${t+1}: capture rate ${R(e)}`,"aria-label":`Episode ${t+1}, capture rate ${R(e)}`,"aria\
-pressed":String(t===r.episode&&r.seed===null),onclick:()=>this.#e.select({episode:t,seed:null})},s,u("span",{class:"count"},t+1))}};var uc=200;function va(n,e,{pursuer:t,evader:r},s){let{text:o,image:a}=e.shows[`${t} ${r}`]??{},i=ie(n,t,r)?.rates??[],l=`Scores of the ${e.teams[0]} in ${i.length}\
 episodes: ${i.map(d=>R(d)).join(", ")}`,c=dc(n,e,t,r);return[o===void 0?null:u("pre",{tabindex:0,"aria-label":"What the game shows of this pair"},o),a===void 0?
null:u("img",{src:a,alt:"What the game shows of this pair",onload:({target:d})=>d.classList.toggle("pixels",d.naturalWidth<uc)}),...(o??a)===void 0?[u("p",{class:"\
muted"},e.missing),mc(n,e,t,r,s)]:[],c?u("p",{class:"small numbers"},c):null,i.length>1?u("p",{class:"small numbers"},l):null].filter(d=>d!==null)}function dc(n,e,t,r){
let{others:s,extras:o={}}=n.payoff,a=s?.[t]?.[r],i=a===void 0?[]:[`score of the ${e.teams[1]} ${R(a)}`];for(let[l,c]of Object.entries(o)){let d=c[t]?.[r];d!==void 0&&
i.push(`${l} ${R(d)}`)}return i.length?`Means of the pair: ${i.join(", ")}`:""}function mc(n,e,t,r,s){let o=Object.keys(e.shows).map(d=>d.split(" ").map(Number)),
a=([d,m])=>(d-t)**2+(m-r)**2,[i,l]=o.sort((d,m)=>a(d)-a(m))[0]??[];if(i===void 0||l===void 0)return null;let c=`${L(n,"pursuer",i)} against ${L(n,"evader",l)}`;
return u("p",{},u("button",{type:"button",onclick:()=>s.select({pursuer:i,evader:l})},`Nearest: ${c}`))}function ba(n){let e=JSON.stringify(n,(t,r)=>t==="genome"?Array.from(r):r);return u("script",{type:"application/json",id:"champions"},e.replaceAll("<","\\u003c")).
outerHTML}var wt="_",hc="n",ep=2n**64n-1n;var vr={fov:11,maxSteps:500,rewards:"paper"},pc=["rules","others","rewards","size","diagonal","fov","limit","seed","ended","walls","pursuers","evaders","played",
"next"];function Sa(n,e){let t=i=>i.map(l=>gc(l,e)).join(""),r=i=>`${Math.floor(i/n.cols)}.${i%n.cols}`,s=fc(n.rewards,e),o=[n.seed,n.episode,n.steps].join("."),a={rules:xa(
n.rules,e),others:n.others?xa(n.others,e):"",rewards:s===vr.rewards?"":s,size:`${n.rows}x${n.cols}`,diagonal:n.diagonal?"1":"",fov:n.fov===vr.fov?"":String(n.fov),
limit:n.maxSteps===vr.maxSteps?"":String(n.maxSteps),seed:o==="0.0.0"?"":o,ended:n.ended?"1":"",walls:n.walls.map(r).join(wt),pursuers:n.pursuers.map(wa).join(wt),
evaders:n.evaders.map(wa).join(wt),played:n.played.map(t).join(wt),next:n.next.every(i=>i===oa)?"":t(n.next)};return pc.filter(i=>a[i]).map(i=>`${i}=${a[i]}`).join(
"&")}function wa({cell:n,gone:e,captured:t,everCaptured:r}){let s=t?"c":r?"e":"";return`${n[0]}.${n[1]}${s}${e?"x":""}`}function xa(n,e){let t=e.fields.map(({name:r})=>String(
n[r]).toLowerCase());return aa(n,e.variants)??t.join(".")}function fc(n,e){let t=JSON.stringify(n);return Object.keys(e.rewards).find(s=>JSON.stringify(e.rewards[s])===
t)??Object.values(n).map(s=>String(s)).join(wt)}function gc(n,e){if(typeof n=="number")return String(n);if(n===sa)return hc;let t=e.scripts.findIndex(({name:r})=>r===
n);return String.fromCharCode(97+t)}var yc="/* the engine */";function Ma(n,e){return u("button",{type:"button",class:"to-playground",title:"Open this step in the playground (G): the same agents a\
nd actions under any rules",onclick:()=>vc(n(),e)},"What if?")}function vc(n,e){let t=n!==null&&n.match.n_agents<=yr&&Math.max(n.match.config.rows,n.match.config.
cols)<=gr,r=t?u("script",{type:"text/plain",id:"scene"},Sa(bc(n.match,n.step),e)).outerHTML:"",s=new TextDecoder().decode(In("playground")).replace(yc,()=>ee("s\
cript-engine")).replace("</noscript>",i=>i+r+(t?ba(n.champions):"")),o=u("iframe",{title:"Playground",srcdoc:s}),a=u("dialog",{class:"what-if","aria-label":"Wha\
t if?",onclose:()=>a.remove()},u("button",{type:"button",class:"leave",onclick:()=>a.close()},"Back to the match"),o);document.body.append(a),a.showModal()}function bc(n,e){
let{config:t,n_agents:r}=n,s=Math.max(0,e-1),o=i=>{let l=s*r+i,c=s*t.n_evaders+i-t.n_pursuers,d=m=>i>=t.n_pursuers&&!!m[c];return{cell:[n.last_positions[2*l],n.
last_positions[2*l+1]],gone:!n.alive[l],captured:d(n.captured),everCaptured:d(n.ever_captured)}},a=Array.from({length:r},(i,l)=>o(l));return{rules:t.rules,others:null,
rewards:t.rewards,rows:t.rows,cols:t.cols,diagonal:t.diagonal,fov:t.fov,maxSteps:t.max_steps,seed:n.seed,episode:BigInt(n.episode),steps:s,ended:s===n.length,walls:Array.
from(n.map.keys()).filter(i=>n.map[i]),pursuers:a.slice(0,t.n_pursuers),evaders:a.slice(t.n_pursuers),played:[],next:Array.from(n.actions.subarray(s*r,(s+1)*r))}}var wc=.005,xc=.05,Sc=4,Ve=new Map;function Ta(n,e,t="capture-rate"){let r=JSON.stringify([{...e,rewards:null},t]),s=Ve.get(r)??(os(e)?Promise.resolve(null):Mc(
n,e,t));return Ve.delete(r),Ve.set(r,s),Ve.size>Sc&&Ve.delete([...Ve.keys()][0]),s}var Aa=()=>new Promise(n=>setTimeout(n));async function Mc(n,e,t){await Aa();let r=n.solution(e,t);for(;r.goBack();)await Aa();return r}function Ea(n,e,t){let{payoff:r}=n;
return t.flatMap((s,o)=>{let a=[0,0];for(let l=e.n_turns;l>0&&!e.over;l--)n.game(e)?.lost(s).forEach((c,d)=>a[d]+=c),e.playTurn(s);let i=r==="capture-rate"?wc:xc;
return S.map((l,c)=>({step:o+1,team:l,lost:a[c],payoff:r})).filter(l=>l.lost>=i)})}var Oa=n=>n.map(e=>({step:e.step,kind:e.team,size:e.lost/Math.max(1,...n.map(
({lost:t})=>t)),text:br(e)})),Ac=({lost:n,payoff:e})=>e==="capture-rate"?`${n.toFixed(2)} of the capture rate`:`${n.toFixed(1)} steps`,br=n=>`The ${n.team}s los\
e ${Ac(n)} against a perfect opponent`;function ka(n,e,t){if(t===0)return[{kind:"start",text:Tc(n),agents:[]}];let r=e.moments[t-1],s=e.moments[t],o=d=>B(d,n.config.n_pursuers),a=ut(e,r,s),i=n.conflicts(
t),l=new Set(i.flatMap(d=>d.doomed)),c=a.map(d=>({kind:"capture",text:`${o(d)} is captured`,agents:[d]}));for(let d of Gt(r,s))!a.includes(d)&&!l.has(d)&&c.push(
{kind:"end",text:`${o(d)} disappears`,agents:[d]});return c.push(...i.map(({kind:d,text:m,agents:h})=>({kind:d,text:m,agents:h}))),t===n.length&&c.unshift({kind:"\
end",text:Ec(n),agents:[]}),c}function Tc({config:n}){return`${n.n_pursuers} pursuers and ${n.n_evaders} evaders on ${n.rows} x ${n.cols} cells, at most ${n.max_steps}\
 steps`}function Ec(n){let e=Math.round(n.statistics.capture_rate*n.config.n_evaders);return`The episode ends after ${n.length} steps with ${e} of ${n.config.n_evaders}\
 evaders captured`}var Oc=60,qe=class{element;player=new ce(0,{speed:Kt,still:le()});inspector;match=null;recording=null;actions;#e;#n;#t;#r;#a=u("h2",{class:"match-title"});#s=u(
"p",{class:"tally numbers"});#l=u("ol",{class:"words",tabindex:0,"aria-live":"off","aria-label":"What happened in this step"});#u=u("p",{class:"problem",role:"a\
lert"});#c=u("div",{class:"shown","aria-live":"polite"});#d=null;#f=null;#m=0;#o=!1;#h=0;#i=[];constructor(e,t,r){this.#n=e,this.#t=t;let s=u("canvas",{"aria-la\
bel":"The match",onclick:({clientX:o,clientY:a})=>this.inspector.choose(this.#e.agentAt(o,a))});this.#e=new Ie(s,{numbers:!1}),this.#r=new cn(t),this.inspector=
new je(o=>this.#O(o)),this.actions=u("div",{class:"match-actions"},u("button",{type:"button",class:"to-play",title:"Move the chosen agent, or an evader, yoursel\
f from this step on (T)",onclick:()=>this.element.dispatchEvent(new Event("takeover"))},"Take over"),r&&Ma(()=>this.shown,r)),this.element=u("section",{class:"c\
ard match-card","aria-label":"Match",id:"match"},u("div",{class:"match"},u("header",{class:"match-head"},this.#a,this.#s),this.#u,this.#c,u("div",{class:"stage"},
s),u("div",{class:"aside"},this.#l,on(),this.actions,this.inspector.element),Fe(this.player),this.#r.element)),this.player.addEventListener("frame",()=>this.recording&&
this.#e.show(this.recording,this.player.time)),this.player.addEventListener("step",()=>this.#g()),t.on("match",()=>this.#y()),this.#S(),this.#M(0,0)}get#p(){return this.#n[this.#t.
selected.run]}reveal(){(this.#p.game?this.#c:this.#e.canvas).scrollIntoView({block:"nearest"})}get shown(){return this.match&&this.#f&&{match:this.match,step:this.
player.step,champions:this.#f}}start(e){this.#d=e,this.#v()}playSoon(){this.#o=!0,this.#m||this.#w()}goTo(e){this.#h=e,!this.#m&&this.match&&this.#v()}#w(){!this.#o||
!this.match||(this.#o=!1,this.player.jump(0),le()||this.player.play())}#y(){this.#S(),clearTimeout(this.#m),this.#m=setTimeout(()=>this.#v(),Oc)}#v(){clearTimeout(
this.#m),this.#m=0,this.player.pause(),this.#S();let{selected:e}=this.#t,{game:t}=this.#p;if(this.#c.replaceChildren(...t?va(this.#p,t,e,this.#t):[]),t){this.match=
this.recording=null,this.#o=!1,this.#b(e);return}let r=S.map(a=>vs(this.#p,a,e[a])).find(Boolean)??"";if(this.#u.textContent=r,r||!this.#d)return;this.match=kt(
this.#d,this.#p,e);let[s,o]=this.names(e);this.#f={pursuer:{name:s,policy:ae(this.#p,"pursuer",e.pursuer)},evader:{name:o,policy:ae(this.#p,"evader",e.evader)}},
this.recording=an(this.match),this.#r.show(this.#p,this.match),this.inspector.show(this.#d,this.#p,this.match,e),this.player.length=this.match.length,this.player.
marks=zt(this.recording),this.#i=this.player.ticks=[],this.player.jump(this.#h),this.#h=0,this.#g(),this.#x(this.#d,this.match),this.#b(e),this.#w()}#b({run:e,pursuer:t,
evader:r,episode:s,seed:o}){this.element.dataset.played=`${e} ${t} ${r} ${s} ${o??""}`}async#x(e,t){let r=await Ta(e,t.config);if(this.match!==t||!r)return;let s=e.
world(t.config);t.seek(s,0),this.#i=Ea(r,s,kc(t)),s.free(),this.player.ticks=Oa(this.#i),this.inspector.solution=r,this.#g()}names({run:e,pursuer:t,evader:r}){let s=this.#n[e],
{teams:o}=s;return[o.pursuer.script??L(s,"pursuer",t),o.evader.script??L(s,"evader",r)]}#S(){let{episode:e,seed:t}=this.#t.selected,{game:r,payoff:s}=this.#p;this.
element.classList.toggle("of-own-game",!!r),this.element.classList.toggle("of-ratings",S.some(l=>bs(this.#p,l)));let[o,a]=this.names(this.#t.selected),i=t===null?
e<s.episodes?`episode ${e+1} of ${s.episodes}`:`episode ${e+1}, not part of the cell`:`seed ${t}`;this.#a.replaceChildren(u("span",{class:"pursuer"},te(o))," ag\
ainst ",u("span",{class:"evader"},a),r?"":u("span",{class:"muted small"},i))}#g(){let e=this.match;if(!e||!this.recording)return;let t=this.player.step,r=this.recording.
moments[t];this.#M(Array.from(r.everCaptured).filter(Boolean).length,t),this.#l.replaceChildren(...this.#i.filter(s=>s.step===t).map(s=>u("li",{class:`loss-${s.
team}`},br(s))),...ka(e,this.recording,t).map(s=>u("li",{class:s.kind,"data-agents":s.agents.join(" ")},s.text))),this.inspector.at(t),this.#A()}#M(e,t){let{world:r}=this.#p;
r&&this.#s.replaceChildren(u("strong",{},e),` of ${r.n_evaders} captured`,u("span",{class:"muted"},` · step ${t}`))}#O(e){this.#e.look={selected:e,viewers:e===
null?[]:[e]},this.#A()}#A(){let e=this.inspector.agent;for(let t of this.#l.children){let r=t.dataset.agents?.split(" ")??[];t.classList.toggle("about",e!==null&&
r.includes(String(e)))}}},kc=({actions:n,length:e,n_agents:t})=>Array.from({length:e},(r,s)=>n.subarray(s*t,(s+1)*t));var Rc={ArrowUp:[1,0],ArrowDown:[-1,0],ArrowRight:[0,1],ArrowLeft:[0,-1]},Cc=5;function Ca(n,e,t,r="pursuer"){n.tabIndex=0,n.setAttribute("role","application"),
n.addEventListener("keydown",s=>{let o=Rc[s.key];if(!o)return;let[a,i]=r==="pursuer"?o:[o[1],o[0]],[l,c]=t(),d=s.shiftKey?Cc:1,{pursuer:m,evader:h}=e.selected;e.
select({pursuer:Ra(m+d*a,l),evader:Ra(h+d*i,c)}),s.preventDefault(),s.stopPropagation()})}var Ra=(n,e)=>Math.min(e-1,Math.max(0,n));var $c=24,un=7,Pa=n=>n<$c&&matchMedia("(pointer: coarse)").matches;function _a(n,e,t,r){let[s,o]=n.payoff.shape,a=$a(e,s),i=$a(t,o),l=Math.min(un,s),c=Math.min(
un,o),d=[];for(let y=a+l-1;y>=a;y--){d.push(u("span",{class:"pursuer"},y));for(let g=i;g<i+c;g++)d.push(Pc(n,y,g,r))}let m=Array.from({length:c},(y,g)=>u("span",
{class:"evader"},i+g)),h=u("button",{type:"button","aria-label":"Close: all cells",onclick:()=>r(null)},"✕"),f=u("div",{class:"loupe numbers",role:"group","ar\
ia-label":"Cells around the tap",onclick:y=>y.stopPropagation()},...d,h,...m);return f.style.gridTemplateColumns=`2.4rem repeat(${c}, minmax(0, 1fr))`,f}function Pc(n,e,t,r){
let s=u("button",{type:"button",onclick:()=>r({pursuer:e,evader:t})});return Xt(s,ie(n,e,t)?.rate,`${L(n,"pursuer",e)} against ${L(n,"evader",t)}`),s}var $a=(n,e)=>Math.
max(0,Math.min(e-un,n-Math.floor(un/2)));var D={left:52,bottom:46,top:76,right:84},Z=10,_c=160,xt=D.right-Z-14,Ae=D.top-Z-14,Ke=class{element;#e;#n;#t=u("canvas",{"aria-hidden":"true"});#r=w("svg",{"ar\
ia-hidden":"true"});#a=w("g");#s;#l=u("h2");#u=u("strong",{class:"rate numbers"});#c=u("span",{class:"small muted"});#d=u("p",{class:"of-both-teams small muted \
numbers"});#f;#m=null;constructor(e,t){this.#n=e,this.#e=t,this.#s=u("div",{class:"matrix",id:"matrix","aria-label":"Payoff matrix. Arrow keys choose a match, E\
nter plays it.",onpointermove:s=>this.#x(s),onpointerleave:()=>t.point({}),onclick:s=>this.#S(s),onkeydown:({key:s})=>s==="Enter"&&this.#M()},this.#t,this.#r);let r=u(
"header",{class:"readout","aria-live":"polite"},u("div",{},this.#l,this.#d),u("div",{class:"of-cell"},this.#u,this.#c));this.#f=ne(...j(this.#o).ends),this.element=
u("section",{class:"card matrix-card","aria-label":"Payoff matrix"},r,this.#s,this.#f),this.#y(),new ResizeObserver(()=>this.#h()).observe(this.#s),this.#s.addEventListener(
"mousedown",s=>{s.preventDefault(),document.activeElement instanceof HTMLElement&&document.activeElement.blur()}),Ca(this.#s,t,()=>this.#o.payoff.shape),t.on("r\
un",()=>{let s=ne(...j(this.#o).ends);this.#f.replaceWith(s),this.#f=s,this.#h()}),t.on("match hover",()=>this.#w())}get#o(){return this.#n[this.#e.selected.run]}#h(){
let[e,t]=this.#o.payoff.shape,{clientWidth:r,clientHeight:s}=this.#s;if(r<50)return;let a=Math.max(_c,Math.min(r-D.left-D.right,s-D.top-D.bottom))/Math.max(e,t),
i=Math.max(D.left,(r-t*a-D.right+D.left)/2),l=D.top+Math.max(0,(s-D.top-D.bottom-e*a)/2),c={width:r,height:s,left:i,top:l,cell:a,rows:e,columns:t};this.#m=c,Ue(
this.#t,this.#o.payoff,{left:i,top:l,width:t*a,height:e*a});for(let[d,m,h]of[["left",i,r],["top",l,s],["width",t*a,r],["height",e*a,s]])this.#t.style.setProperty(
d,`${100*m/h}%`);this.#s.style.setProperty("--shape",`${r} / ${s}`),this.#r.setAttribute("viewBox",`0 0 ${r} ${s}`),this.#r.replaceChildren(Lc(c,j(this.#o).generation),
...Nc(c),...this.#p(c),this.#a),this.#w()}#i(e){let t=this.#o.findings?.generalization;if(!t)return[];let{selected:r,hover:s}=this.#e,o=s.pursuer??r.pursuer,a=s.
evader??r.evader,[i,l]=La(e,t.pursuers.mean[o]??0,o),[c,d]=Na(e,t.evaders.mean[a]??0,a);return[w("circle",{class:"dot of-pursuers",cx:i,cy:l,r:5}),w("circle",{class:"\
dot of-evaders",cx:c,cy:d,r:5})]}#p(e){let t=this.#o.findings?.generalization;if(!t)return[];let{left:r,top:s,cell:o,rows:a,columns:i}=e,{curves:l}=j(this.#o),c=r+
i*o+Z,d=s-Z,m={class:"side"};return[w("rect",{...m,x:c,y:s,width:xt,height:a*o}),w("rect",{...m,x:r,y:d-Ae,width:i*o,height:Ae}),...Ia(t.pursuers,(h,p)=>La(e,h,
p),"of-pursuers"),...Ia(t.evaders,(h,p)=>Na(e,h,p),"of-evaders"),w("text",{class:"tick",x:c,y:s+a*o+16,"text-anchor":"start"},"0"),w("text",{class:"tick",x:c+xt,
y:s+a*o+16,"text-anchor":"end"},"1"),w("text",{class:"tick",x:r-6,y:d-4,"text-anchor":"end"},"0"),w("text",{class:"tick",x:r-6,y:d-Ae+8,"text-anchor":"end"},"1"),
w("text",{class:"label of-pursuers",x:c+xt,y:s+a*o+34,"text-anchor":"end"},l.pursuer),w("text",{class:"label of-evaders",x:r+i*o+Z,y:d-Ae+10,"text-anchor":"star\
t"},l.evader)]}#w(){let e=this.#m;if(!e)return;let{selected:t,hover:r}=this.#e,{left:s,top:o,cell:a,rows:i,columns:l}=e,c=f=>o+(i-1-f)*a,d=[],m=(f,y)=>w("rect",
{class:y,x:s,y:c(f),width:l*a+Z+xt,height:a}),h=(f,y)=>w("rect",{class:y,x:s+f*a,y:o-Z-Ae,width:a,height:Z+Ae+i*a});d.push(m(t.pursuer,"strip pursuer"),h(t.evader,
"strip evader")),r.pursuer!==null&&r.pursuer<i&&d.push(m(r.pursuer,"strip hover")),r.evader!==null&&r.evader<l&&d.push(h(r.evader,"strip hover")),d.push(...this.#i(
e));let p={x:s+t.evader*a,y:c(t.pursuer),width:a,height:a};d.push(w("rect",{class:"chosen under",...p}),w("rect",{class:"chosen",...p})),this.#a.replaceChildren(
...d),this.#y()}#y(){let{selected:e,hover:t}=this.#e,r=t.pursuer??e.pursuer,s=t.evader??e.evader,o=ie(this.#o,r,s);this.#l.replaceChildren(u("span",{class:"purs\
uer"},te(L(this.#o,"pursuer",r)))," against ",u("span",{class:"evader"},L(this.#o,"evader",s))),this.#u.textContent=o?R(o.rate,3):"-";let a=o&&o.rates.length>1?
`, mean of ${o.rates.length} episodes`:"";this.#c.textContent=o?j(this.#o).score+a:"no episodes were played",this.#d.textContent=this.#v(r,s)}#v(e,t){let r=this.#o.
findings?.generalization;if(!r)return"";let s=(a,i)=>To(a.mean[i]??null,a.low?.[i]??null,a.high?.[i]??null),{means:o}=j(this.#o);return`Against all: ${o.pursuer}\
 ${s(r.pursuers,e)}, ${o.evader} ${s(r.evaders,t)}`}#b(e){let t=this.#m;if(!t)return null;let r=this.#s.getBoundingClientRect(),s=Math.floor((e.clientX-r.left-t.
left)/t.cell),o=t.rows-1-Math.floor((e.clientY-r.top-t.top)/t.cell),a=o>=0&&o<t.rows,i=s>=0&&s<t.columns;return a||i?{g:a?o:-1,h:i?s:-1,inside:a&&i}:null}#x(e){
let t=this.#b(e);this.#e.point(t?{pursuer:t.g<0?null:t.g,evader:t.h<0?null:t.h}:{})}#S(e){let t=this.#b(e);if(t){if(t.inside&&Pa(this.#m.cell))return this.#g(t.
g,t.h);this.#e.select({...t.g<0?{}:{pursuer:t.g},...t.h<0?{}:{evader:t.h}}),t.inside&&this.#M()}}#g(e,t){let r=_a(this.#o,e,t,s=>{r.remove(),s&&(this.#e.select(
s),this.#M())});this.#s.append(r)}#M(){this.#s.dispatchEvent(new CustomEvent("play",{bubbles:!0}))}};function Lc({left:n,top:e,cell:t,rows:r,columns:s},o){let a=w(
"g",{class:"axes"}),i=e+r*t,l=c=>pt(0,c-1,Math.min(c,c*t/44),!0);for(let c of l(s))a.append(w("text",{class:"tick",x:n+(c+.5)*t,y:i+16,"text-anchor":"middle"},c));
for(let c of l(r))a.append(w("text",{class:"tick",x:n-7,y:i-(c+.5)*t,"text-anchor":"end","dominant-baseline":"middle"},c));return a.append(w("text",{class:"labe\
l of-evaders",x:n+s*t/2,y:i+36,"text-anchor":"middle"},o.evader),w("text",{class:"label of-pursuers",transform:`translate(${n-36} ${e+r*t/2}) rotate(-90)`,"text\
-anchor":"middle"},o.pursuer)),a}function Nc({left:n,top:e,cell:t,rows:r,columns:s}){let o=w("g",{class:"diagonal"}),a=Math.min(r,s);if(a<3)return[];let i=e+r*t;
for(let d of["H","V"]){let m=`M${n} ${i}`;for(let h=1;h<=a;h++){let p=`H${n+h*t}`,f=`V${i-h*t}`;m+=d==="H"?p+f:f+p}o.append(w("path",{d:m,class:"under"}),w("pat\
h",{d:m}))}let l=n+a/2*t-.7*t-4,c=i-a/2*t-.7*t-4;return[o,w("text",{class:"on-cells",transform:`translate(${l} ${c}) rotate(-45)`,"text-anchor":"middle"},"same \
generation")]}var La=({left:n,top:e,cell:t,rows:r,columns:s},o,a)=>[n+s*t+Z+o*xt,e+(r-a-.5)*t],Na=({left:n,top:e,cell:t},r,s)=>[n+(s+.5)*t,e-Z-r*Ae];function Ia(n,e,t){
let r=o=>o.map((a,i)=>e(a??0,i).map(l=>l.toFixed(1)).join(" ")),s=[];return n.low&&n.high&&s.push(w("path",{class:`band ${t}`,d:`M${[...r(n.high),...r(n.low).reverse()].
join("L")}Z`})),s.push(w("path",{class:`line ${t}`,d:`M${r(n.mean).join("L")}`})),s}var Fa={pursuer:null,evader:null},Ye=class extends EventTarget{#e;#n=Fa;constructor(e){super(),this.#e=e}get selected(){return this.#e}get hover(){return this.#n}select(e){
let t=this.#e,r=["run","pursuer","evader"].some(s=>s in e&&e[s]!==t[s]);this.#e={...t,...r?{episode:0,seed:null}:{},...e},this.#e.run!==t.run&&this.dispatchEvent(
new Event("run")),this.dispatchEvent(new Event("match"))}point(e){let t={...Fa,...e};t.pursuer===this.#n.pursuer&&t.evader===this.#n.evader||(this.#n=t,this.dispatchEvent(
new Event("hover")))}on(e,t){for(let r of e.split(" "))this.addEventListener(r,t)}};var wr=n=>Array.from({length:n},()=>Array(n)),dn=class{learning=S;settings=[];command="";training={capture_rate:[],generation:[],learner:[],epochs:1,window:1,matches:0};limits="";name;schedule;seed;seeds=[];world;payoff;teams;findings=null;genomes={
pursuer:[],evader:[]};best=null;#e;#n;#t;constructor(e,t,r,s){this.#t=e,this.#e=t,this.#n=s,this.name=r,this.schedule=r,this.world=e.world,this.seed=String(e.seed),
this.payoff=this.#r(),this.teams=this.#a()}get newest(){return this.genomes.pursuer.length-1}#r(){let{seed:e,schedule:{generations:t}}=this.#t,r=t+1;return this.
seeds=Array.from({length:r},(s,o)=>Array.from({length:r},(a,i)=>String(Rt(e,o,i)))),{first:[0,0],shape:[r,r],episodes:this.#t.evaluation_episodes,capture_rate:wr(
r),capture_rates:wr(r),lengths:wr(r)}}#a(){let e=t=>{let r=`${this.#n} ${t}`;Ss(r,Pt(this.genomes[t]));let{genome:s,...o}=lt(Lt(this.#t,this.#e,t),this.genomes[t][0]??
new Float32Array(0));return{script:null,policy:{...o,genome_size:s.length},kept:[...this.genomes[t].keys()],genomes:r}};return{pursuer:e("pursuer"),evader:e("ev\
ader")}}policy(e,t){return this.playing(e,this.genomes[e][t])}playing(e,t){return lt(Lt(this.#t,this.#e,e),t)}genomesOf({pursuer:e,evader:t}){return{pursuer:this.
genomes.pursuer[e],evader:this.genomes.evader[t]}}extend(e){let{capture_rate:t,capture_rates:r,lengths:s,shape:[o]}=this.payoff;if(this.#t={...this.#t,schedule:e.
schedule},!(o>e.schedule.generations)){this.payoff=this.#r();for(let a=0;a<o;a++)Object.assign(this.payoff.capture_rate[a],t[a]),Object.assign(this.payoff.capture_rates[a],
r[a]),Object.assign(this.payoff.lengths[a],s[a])}}add(e){for(let t of S)this.genomes[t].push(e[t]);this.teams=this.#a()}change(e,t){this.#t=e,this.world=e.world;
for(let r of S)this.genomes[r]=[...t[r]];this.best=null,this.payoff=this.#r(),this.teams=this.#a(),this.findings=null}addCell({pursuer:e,evader:t,capture_rates:r,
lengths:s}){this.payoff.capture_rate[e][t]=M(r),this.payoff.capture_rates[e][t]=[...r],this.payoff.lengths[e][t]=[...s],this.findings={generalization:this.#s()}}#s(){
let e=this.payoff.capture_rate,t=o=>({mean:o,low:null,high:null}),r=o=>{let a=o.filter(i=>i!==void 0);return a.length?M(a):null},s=[...this.genomes.pursuer.keys()];
return{pursuers:t(s.map(o=>r(e[o]))),evaders:t(s.map(o=>r(e.map(a=>a[o]===void 0?void 0:1-a[o]))))}}};var Ic=1/4,Wa=1.96,Da=.05,xr=5;function Ua(n,e){let t=Array.from({length:e},(m,h)=>Array.from({length:e},(p,f)=>n.get(`${h} ${f}`)?.capture_rates));if(e<2||t.some(
m=>m.includes(void 0)))return null;let r=t.map(m=>m.map(h=>M(h))),s=t.map(m=>m.map(h=>Dc(h))),o=Math.max(1,Math.round(e*Ic)),a=m=>{let h=zn(r,m),p=m==="pursuer"?
s:Fc(s),f=[h[0].slice(-o)],y=h.slice(-o).map(A=>A.slice(-o)),g=A=>M(A.map(T=>M(T.slice(-o))/o))/A.length,b={value:M(y.map(M))-M(f.map(M)),reach:Wa*Math.sqrt(g(p.
slice(-o))+g([p[0]]))},v=Wc(h,p),x=Hc(b,v);return{verdict:x==="better"&&!Uc(h.map(M),v.value)?"better by a jump":x,before:M(f[0]),after:M(y.map(M))}},i={pursuer:a(
"pursuer"),evader:a("evader")},l=m=>{let h=zn(r,m).map(M);return h.lastIndexOf(Math.max(...h))},c={pursuer:l("pursuer"),evader:l("evader")},d=r[c.pursuer][c.evader];
return{rate:d,best:c,teams:i,sentence:Gc(d,i)}}var Fc=n=>n[0].map((e,t)=>n.map(r=>r[t])),Dc=n=>n.reduce((e,t)=>e+(t-M(n))**2,0)/Math.max(1,n.length-1)/n.length;
function Wc(n,e){let t=n.length-1,r=n.map((i,l)=>l-t/2),s=r.reduce((i,l)=>i+l*l,0),o=r.map(i=>t*i/s),a=e.map(i=>M(i)/i.length);return{value:n.reduce((i,l,c)=>i+
o[c]*M(l),0),reach:Wa*Math.sqrt(a.reduce((i,l,c)=>i+o[c]**2*l,0))}}function Uc(n,e){let t=n.map(c=>c*Math.sign(e)),r=Math.floor(n.length/xr),s=n.length%xr,o=Array.
from({length:xr},(c,d)=>M(t.slice(d*r+Math.min(d,s),(d+1)*r+Math.min(d+1,s)))),a=Math.max(2,Math.floor(n.length/10)),i=Math.max(...t.slice(a).map((c,d)=>c-t[d])),
l=Math.max(...o.slice(1).map((c,d)=>o[d]-c));return i<Math.abs(e)/2&&l<Math.abs(e)/4}function Hc(...n){return n.every(({value:e,reach:t})=>e-t>Da)?"better":n.every(
({value:e,reach:t})=>e+t<-Da)?"weaker":"cannot tell"}var N=n=>`${Math.round(100*n)} %`,zc={better:"better than in generation 0","better by a jump":"better than \
in generation 0, most of it in one jump",weaker:"weaker than in generation 0","cannot tell":""};function Gc(n,e){let t=`The best pursuers now catch ${N(n)} of t\
he best evaders.`,r=S.map(o=>zc[e[o].verdict]);if(r[0]===r[1])return r[0]?`${t} Both teams are ${r[0]}.`:`${t} Whether a team has become better since generation\
 0, this race cannot tell.`;let s=S.map((o,a)=>r[a]?`the ${o}s are ${r[a]}`:`of the ${o}s this race cannot tell`);return`${t} ${s[0][0].toUpperCase()}${s[0].slice(
1)}; ${s[1]}.`}function Ha(n,{before:e,after:t}){let[r,s]=n==="pursuer"?[e,t]:[1-e,1-t];return n==="pursuer"?`Of the last ${Q(n)}s, pursuers of generation 0 cat\
ch ${N(r)}, the last pursuers ${N(s)}.`:`The last pursuers catch ${N(r)} of the evaders of generation 0, and ${N(s)} of the last evaders.`}var za=1/3,Bc=1/10,jc=4,Vc=2,qc=12,Ga=n=>n.length>1?`${n.slice(0,-1).join(", ")} and ${n.at(-1)}`:n[0]??"";function Ba({phrases:n,words:e},t,r){let s=Object.entries(
r).map(([c,d])=>[c,Math.abs(d)]).sort(([,c],[,d])=>d-c),o=s[0]?.[1]||1/0,a=s.filter(([,c])=>c/o>=za).slice(0,jc).map(([c])=>n[c][r[c]>0?1:0]),i=s.filter(([,c])=>c/
o>=Bc&&c/o<za).slice(0,Vc).map(([c])=>n[c][2]),l=Ga([...a,...i.length?[`minds ${Ga(i)} little`]:[]])||"takes any move that is allowed";return`{A} ${t} ${l}.`.replaceAll(
/\{(\w+)\}/g,(c,d)=>e[t][d])}function ja(n,e,t,r){let s=r[t];if(s.kind!=="rating")return{};let{n_pursuers:o,n_evaders:a}=e.config,i=Array.from({length:t==="purs\
uer"?o:a},(d,m)=>m+(t==="pursuer"?0:o)),l=n.world(e.config),c=s.inputs.map(()=>[]);for(let d=0;d<e.length;d+=Math.max(1,Math.floor(e.length/qc))){e.seek(l,d,{pursuers:r.
pursuer,evaders:r.evader});for(let m of i.filter(h=>e.alive[d*e.n_agents+h])){let{inputs:h,refused:p}=l.rate(s,m);h.forEach((f,y)=>{let g=Array.from(f).filter((b,v)=>!p[v]);
g.length&&c[y].push(M(g.map(b=>(b-M(g))**2)))})}}return l.free(),Object.fromEntries(s.inputs.map((d,m)=>[d,s.genome[m]*Math.sqrt(c[m].length?M(c[m]):0)]))}var Kc=2,Yc=1.5,mn=class{element=u("section",{class:"card weights-card","aria-label":"Weights of named inputs",hidden:!0});#e;#n;#t;#r=u("div",{class:"evolved"});#a=u(
"p",{class:"numbers",role:"status"});#s=u("button",{type:"button",onclick:()=>this.#h()},"As evolved");#l={pursuer:u("p"),evader:u("p")};#u=null;#c=null;constructor(e,t,r){
this.#e=e,this.#n=t,this.#t=r,this.element.append(u("h3",{},"What they have learned"),u("p",{class:"small muted"},"An agent takes the move with the largest sum \
of weight x input. Drag a weight, and see at once what becomes of the team."),u("div",{class:"doings"},this.#s,this.#a),this.#r)}genome(e){return this.#c?.[e]??
this.#f[e]}get#d(){let{newest:e,best:t}=this.#u;return t??{pursuer:e,evader:e}}get#f(){return this.#u.genomesOf(this.#d)}show(e){e!==this.#u&&(this.#c=null),this.#u=
e;let{policy:t}=e.teams.pursuer;this.element.hidden=t?.kind!=="rating"||e.newest<1,!(t?.kind!=="rating"||this.element.hidden)&&(this.#c||this.#r.replaceChildren(
...S.map(r=>this.#m(r,t.inputs))),this.#i())}#m(e,t){let r=this.genome(e),s=Math.max(Kc,Yc*Math.max(...r.map(Math.abs)));return u("div",{class:"weights"},u("h4",
{class:e},`${e}s`),this.#l[e],...t.flatMap((o,a)=>{let i=u("span",{class:"numbers"},De(r[a])),l=u("input",{type:"range",class:e,min:-s,max:s,step:"any",value:r[a],
title:de[o],"aria-label":`${e}s: ${o}`});return l.addEventListener("input",()=>{i.textContent=De(Number(l.value)),this.#o(e,a,Number(l.value))}),[u("span",{title:de[o]},
o.replaceAll("_"," ")),l,i]}))}#o(e,t,r){this.#c??={pursuer:this.genome("pursuer").slice(),evader:this.genome("evader").slice()},this.#c[e][t]=r,this.#i(),this.#t()}#h(){
this.#c=null,this.show(this.#u),this.#t()}#i(){this.#s.disabled=!this.#c;let e=N(this.rate(this.#f));this.#a.textContent=this.#c?`Yours: ${N(this.rate(this.#c))}\
 are caught; as evolved: ${e}`:`${e} are caught`;let t=this.#u,r={pursuer:t.playing("pursuer",this.genome("pursuer")),evader:t.playing("evader",this.genome("eva\
der"))},s=this.#e.match(t.world,r.pursuer,r.evader,BigInt(t.seed));for(let o of S)this.#l[o].textContent=Ba(this.#n,o,ja(this.#e,s,o,r))}rate({pursuer:e,evader:t},r=this.#d,s=this.#u){
let o=new Int32Array(1),a={pursuer:o,evader:o,seed:BigUint64Array.of(BigInt(s.seeds[r.pursuer][r.evader]))};return M(this.#e.rollouts(s.world,s.playing("pursuer",
e),s.playing("evader",t),a,s.payoff.episodes).capture_rate)}};var Zc=100,Jc=.3,Xc="By chance: evaders that have not learned to flee run into pursuers that have not learned to hunt.",hn={pursuer:0,evader:0},Va=0,pn=class extends EventTarget{element;chases;boards;before=new Se;after=new Se;settings;state="\
waiting";done=0;epochs=0;changed=[];seconds=0;outcome=null;kept=null;#e;#n;#t;#r=u("h2",{class:"lane-title"});#a=u("p",{class:"facts numbers"});#s=u("div",{class:"\
lane-room"});#l=u("section",{class:"card measures"});#u=u("details",{class:"lane-more",hidden:!0},u("summary",{},"More: every generation against every other, sc\
ores and collisions"),this.#s,this.#l);#c=u("div");#d=new je(()=>{});#f=u("section",{class:"card asked","aria-label":"An agent",hidden:!0},u("button",{type:"but\
ton",class:"leave",onclick:()=>this.#R(null,null)},"Close"),this.#d.element);#m;#o;#h={pursuer:[],evader:[]};#i=new Map;#p;#w=()=>{};#y=0;#v=!0;#b=!1;#x=0;#S=null;constructor(e,t,r,s){
super(),this.#e=e,this.#n=t,this.settings=s,this.#t=new Nt(r,o=>this.#M(o)),this.chases=new Be(()=>this.#F(),this.before,this.after),this.before.element.classList.
add("before"),this.boards=u("div",{class:"pair"},this.before.element,this.after.element),this.#m=new mn(t,e,()=>this.#T(!0));for(let o of[this.before,this.after])
o.addEventListener("agent",()=>o.agent!==null&&this.#R(o,o.agent)),o.addEventListener("step",()=>!this.#f.hidden&&o.agent!==null&&this.#C(o));this.element=u("se\
ction",{class:"lane"},this.#r,this.#a,this.boards,u("p",{class:"hint small muted"},"Click an agent, or press A: what it sees, and why it moves."),this.#f,this.#m.
element,this.#u,this.#c),this.reset(s)}reset(e){this.#t.send({type:"stop"}),this.#k(e),this.state="waiting";let{archive:t}=new _e(this.#n,e,this.#e.masks);this.#o.
add({pursuer:t.pursuer[0],evader:t.evader[0]}),this.#T(!0),this.#E()}start(e,t=[],r=1/0){this.#k(e),this.state="evolving",this.settings=t.at(-1)?.settings??e,this.#g(
{type:"start",settings:e,masks:this.#e.masks,plan:t,until:r}),this.#E()}restore(e,t,r,s){this.#k(t.settings),this.settings=e,this.kept=t;for(let o=0;o<t.finished;o++)
this.#o.add({pursuer:t.archive.pursuer[o],evader:t.archive.evader[o]});for(let[o,a]of t.cells)this.#o.addCell(a),this.#i.set(o,a);this.#h={pursuer:[...t.scores.
pursuer],evader:[...t.scores.evader]},this.seconds=t.seconds,this.done=1,this.epochs=r,this.changed.push(...s),this.#A("ended"),this.#$()}stop(){this.#g({type:"\
stop"})}go(){this.state="evolving",this.#g({type:"go"}),this.#E()}change(e){if(this.state==="waiting")return this.reset(e);this.settings=e,this.#g({type:"change",
settings:e}),this.#E()}saved(){return this.kept?Promise.resolve(this.kept):new Promise(e=>{this.#S=e,this.#g({type:"save"})})}async keep(){return{...await this.
saved(),scores:this.#h,seconds:this.seconds}}get newestGeneration(){return this.#o.newest}get champions(){return{pursuer:this.#m.genome("pursuer"),evader:this.#m.
genome("evader")}}get run(){return this.#o}close(){this.#t.close(),this.chases.runs=!1}#g(e){this.#t.send(e)}#M(e){if(e.type==="began"&&(this.#b=!0),!!this.#b){
if(e.type==="generation")this.#o.add(e.genomes),this.#T(e.number===0);else if(e.type==="cell"){let{pursuer:t,evader:r}=e.cell;this.#o.addCell(e.cell),this.#v&&t===
r&&t===this.#o.newest&&this.#p.select({pursuer:t,evader:r}),this.#i.set(`${t} ${r}`,e.cell),(this.state==="stopped"||this.state==="ended")&&this.#A(this.state)}else if(e.
type==="scores")for(let t of S)this.#h[t][e.number]=e.scores[t];else e.type==="changed"?(this.#o.extend(e.settings),this.changed.push(e.at),this.epochs=e.at,e.settings.
schedule.generations>this.#o.newest&&this.state==="ended"&&this.#O()):e.type==="anew"?(this.#o.change(e.settings,e.genomes),this.#P(),this.#T(!0)):e.type==="epo\
ch"?(this.epochs+=1,this.done=e.done/e.of):e.type==="stopped"?this.#A("stopped"):e.type==="end"?(this.seconds=e.seconds,this.done=1,this.#A("ended")):e.type==="\
saved"?this.#S?.(e.race):e.type==="failed"&&(this.#a.textContent=`The race failed: ${e.message}`,this.state="stopped");this.#x||(this.#x=setTimeout(()=>requestAnimationFrame(
()=>this.#$()),Zc))}}#O(){this.state="evolving",this.outcome=null,this.#o.best=null}#A(e){let t=this.outcome;this.state=e,this.outcome=Ua(this.#i,this.#o.newest+
1),this.#o.best=this.outcome?.best??null,this.outcome&&!t&&this.#T(!0),this.#U()}#$(){this.#x=0,this.#p.dispatchEvent(new Event("run")),this.#w(),this.#E()}#P(){
this.#i=new Map,this.#h={pursuer:[],evader:[]},this.outcome=null,this.#l.hidden=!0}#k(e){this.settings=e,this.done=0,this.epochs=0,this.changed.splice(0),this.kept=
null;let t=ln(e);this.#o=new dn(e,this.#e.masks,t,`race ${Va}`),Va+=1,this.#P(),this.#R(null,null),this.#v=!0,this.#b=!1,this.#p=new Ye({run:0,pursuer:0,evader:0,
episode:0,seed:null});let r=new Ke([this.#o],this.#p);r.element.ariaLabel=`Payoff matrix. ${t}`,this.#c.replaceChildren(this.#L(r)),this.#s.replaceChildren(r.element,
this.#N())}#L(e){let t=new qe([this.#o],this.#p,null);t.actions.remove();let r=u("dialog",{class:"of-cell-match","aria-label":"Match",onclose:()=>t.player.pause()},
u("button",{type:"button",class:"leave",onclick:()=>r.close()},"Close"),t.element),s=!1;return e.element.addEventListener("play",()=>{let{pursuer:o,evader:a}=this.#p.
selected;this.#v=!1,this.#o.payoff.capture_rate[o][a]!==void 0&&(r.showModal(),s||t.start(this.#n),s=!0,t.playSoon())}),r}#N(){let e=`${_t.pursuer.join(", ")} a\
nd ${_t.evader.join(", ")}`,t=K(`Scores against scripts, by generation: ${e}`,(s,o)=>this.#I(s,o),()=>{},s=>{let o=Math.min(this.#o.newest,Math.max(0,Math.round(
s)));this.#p.select({pursuer:o,evader:o})});return this.#w=t.redraw,u("section",{class:"card scores"},u("h3",{},"Against opponents that never change"),u("p",{class:"\
small muted"},"Captures of random walkers and of clumsy fleers; escapes from random walkers and from clumsy chasers."),We(["pursuers","of-pursuers"],["evaders",
"of-evaders"]),t.element)}#I(e,t){let{generations:r}=this.settings.schedule,o=V(e,t,{low:0,high:r,label:"generation",whole:!0},{low:0,high:1,label:"score"});for(let a of S){
let i=Array.from(this.#h[a],l=>l??null);q(o,[...i.keys()],i,`of-${a}s`)}return o}#F(){if(this.#o.newest<0)return;let e=BigInt(this.#o.seeds[0][0]),t=this.#y%this.#o.
payoff.episodes;this.#y+=1;let r=s=>this.#n.match(this.#o.world,...this.#_(s),e,t);this.before.show(r(this.#o.genomesOf(hn)),"Before: generation 0"),this.after.
show(r(this.champions),this.#D());for(let s of[this.before,this.after])s.agent!==null&&this.#C(s,!0)}#D(){let{newest:e,best:t}=this.#o;if(e===0)return"Generatio\
n 0: nobody has learned anything yet";let{pursuer:r,evader:s}=t??{pursuer:e,evader:e},o=r===s?`generation ${r}`:`pursuers of generation ${r}, evaders of generat\
ion ${s}`;return t?`After: ${o}`:`Now: ${o}`}#_({pursuer:e,evader:t}){return[this.#o.playing("pursuer",e),this.#o.playing("evader",t)]}#T(e){this.#m.show(this.#o),
this.chases.renew(e)}#R(e,t){for(let r of[this.before,this.after])r!==e&&r.agent!==null&&r.choose(null);this.#f.hidden=!e,e&&(this.#C(e,!0),this.#d.choose(t))}askNext(){
let{match:e,player:t,agent:r}=this.after;if(!e)return;let s=e.n_agents,o=(r??-1)+1,i=Array.from({length:s},(l,c)=>(o+c)%s).find(l=>e.alive[t.step*s+l]);i!==void 0&&
this.after.choose(i)}#C(e,t=!1){if(t){let r=e===this.before,[s,o]=this.#_(r?this.#o.genomesOf(hn):this.champions),a=r?0:this.#o.newest;this.#d.show(this.#n,this.#o,
e.match,{run:0,pursuer:a,evader:a,episode:0,seed:null},{pursuers:s,evaders:o})}this.#d.at(e.player.step)}#E(){let{newest:e}=this.#o;this.element.dataset.state=this.
state,this.#r.textContent=ln(this.settings),this.#u.hidden=this.state==="waiting",this.#a.replaceChildren(...this.#W().map(t=>u("span",{},t))),this.element.dataset.
newest=String(e),this.dispatchEvent(new Event("state"))}#W(){let{newest:e}=this.#o;if(this.outcome)return[this.outcome.sentence];if(e<0)return[];let t=a=>{let i=this.#i.
get(`${a} ${a}`);return i?M(i.capture_rates):null};if(this.state==="waiting"||e<1){let a=t(0)??this.#m.rate(this.#o.genomesOf(hn),hn),i=`${N(a)} of the evaders \
are caught.`;return a>Jc?[i,Xc]:[i]}let r=`Generation ${e} of ${this.settings.schedule.generations}`,s=t(e)??t(e-1),o=t(0);return s===null||o===null?[`${r}.`]:[
`${r}: the pursuers catch ${N(s)} of the evaders; those of generation 0 caught ${N(o)}.`]}#U(){let{outcome:e}=this;if(this.#l.hidden=!e,this.#l.ariaLabel=`What \
came out. ${ln(this.settings)}`,!e)return;let t=this.#i.get(`${this.#o.newest} ${this.#o.newest}`),r=[["Score against scripts: generation 0",s=>N(this.#h[s][0]??
0)],["Score against scripts: newest generation",s=>N(this.#h[s].at(-1)??0)],["Collisions at fault in 1000 moves of the newest generation",(s,o)=>Qc(t,o).toFixed(
1)]];this.#l.replaceChildren(u("h3",{},"In numbers"),...S.map(s=>u("p",{},Ha(s,e.teams[s]))),u("table",{class:"numbers"},u("thead",{},u("tr",{},u("td"),...S.map(
s=>u("th",{scope:"col",class:s},`${s}s`)))),u("tbody",{},...r.map(([s,o])=>u("tr",{},u("th",{scope:"row"},s),...S.map((a,i)=>u("td",{},o(a,i))))))),u("p",{class:"\
small muted"},"One race proves little: save it, and ",u("code",{},"matrixworld judge")," says what happened on its way, and how surely."))}};function Qc({means:{
faults:n,agent_steps:e}},t){let r=n.length/S.length;return 1e3*n.slice(t*r,(t+1)*r).reduce((s,o)=>s+o,0)/Math.max(1,e[t])}function eu(n,e,...t){return u("section",{class:"card panel","aria-label":n},u("header",{},u("h2",{},n),u("p",{class:"small muted"},e)),...t)}var tu={present:"●",
absent:"○","cannot tell":"?"};function qa(n){let{findings:e}=n;if(!e?.table.length)return null;let[,...t]=e.table,r=t.map(([o,a,i,l],c)=>{let d=a==="told"?"":
ru(e.reasons[c]??"");return u("li",{class:`finding ${a.replace(" ","-")}`},u("span",{class:"sign","aria-hidden":"true"},tu[a]??""),u("div",{},u("p",{},u("strong",
{},o),` ${a}`,u("span",{class:"muted"},` · ${l}`)),d?u("p",{class:"small"},`${d}.`):null,u("p",{class:"small muted numbers"},i)))}),s=eu("What happened","Each \
condition is present, absent, or its 95 % interval cannot tell. The intervals are about this run.",u("p",{class:"headline"},e.sentence),u("ul",{class:"findings"},
...r),...nu(e.refused??{}),n.limits?u("p",{class:"small"},n.limits):null);return s.classList.add("diagnosis"),{element:s}}function nu(n){return[...new Set(Object.
values(n))].map(t=>{let r=Object.keys(n).filter(s=>n[s]===t);return u("p",{class:"small muted"},`Not judged, because ${t}: ${r.join(", ")}.`)})}function ru(n){let[
,e=""]=n.split(/, because (.*)/s);return te(e.replace(/\.$/,""))}var su=84;function Ka(n,e){let t=n.map((o,a)=>ou(o,a,e)),r=u("nav",{class:"races","aria-label":"Runs"},...t.map(o=>o.button)),s=()=>t.forEach((o,a)=>o.update(a===
e.selected.run));return e.on("match hover",s),s(),r.hidden=n.length<2,r}function ou(n,e,t){let[r,s]=n.payoff.shape,o=!n.name.startsWith(n.schedule),a=su/Math.max(
r,s),i=u("canvas",{"aria-hidden":"true"});Ue(i,n.payoff,{left:0,top:0,width:s*a,height:r*a});let l=u("span",{class:"place"}),c=u("button",{type:"button",class:"\
race",title:`${n.name} (key ${e+1})`,onclick:()=>iu(n,e,t)},u("span",{class:"small-matrix"},i,l),u("span",{class:"race-text"},u("strong",{},o?n.name:n.schedule),
u("span",{class:"small"},n.findings?n.findings.sentence:`${n.learning.map(m=>j(n).teams[m]).join(" and ")} against ${au(n)}`),u("span",{class:"small muted"},`${o?
`${n.schedule}, `:""}seed ${n.seed}`)));return{button:c,update:m=>{c.setAttribute("aria-current",String(m));let h=t.hover.pursuer??t.selected.pursuer,p=t.hover.
evader??t.selected.evader;l.hidden=h>=r||p>=s,l.style.left=`${(p+.5)*a}px`,l.style.top=`${(r-h-.5)*a}px`}}}var au=n=>n.teams.pursuer.script??n.teams.evader.script??
"another run";function iu(n,e,t){let[r,s]=n.payoff.shape,{pursuer:o,evader:a}=t.selected;t.select({run:e,pursuer:Math.min(o,r-1),evader:Math.min(a,s-1)})}var Ya=1,lu="meadow";function Za({runs:n},e){let t=n[Ya],{shape:[r,s],episodes:o}=t.payoff,a=new Se,i=0;return e.then(l=>{let c=new Be(()=>a.show(kt(l,t,{run:Ya,
pursuer:r-1,evader:s-1,episode:i++%o,seed:null}),`Generation ${r-1} of both teams`),a);c.renew(),fr(c,a.element)}),u("div",{class:"widget"},a.element,Fe(a.player),
on())}function Ja({evolve:n},e,{grows:t=!1}){let r=u("button",{type:"button",class:"evolve",disabled:!0},"Evolve"),s=u("progress",{max:1,value:0,"aria-label":"P\
rogress of the race"}),o=u("div",{class:"lanes","data-count":1});return e.then(a=>{let i=-1,l=()=>da(n,{...ua(n,lu),policy:"cells",seed:Math.max(0,i)}),c=new pn(
n,a,"lesson",l()),d=()=>{r.textContent=c.state==="waiting"?"Evolve":c.state==="evolving"?"Stop":"Again, with other luck",s.value=c.done};r.addEventListener("cli\
ck",()=>{if(c.state==="evolving")return c.stop();i++,c.start(l())}),c.addEventListener("state",d),t&&(c.element.querySelector("details").open=!0),o.append(c.element),
fr(c.chases,c.boards),r.disabled=!1}),u("div",{class:`widget evolving ${t?"grows":"boards"}`},u("div",{class:"buttons"},r,s),o)}function Xa({runs:n,playground:e},t){
let r=n[0].payoff.shape.map(c=>c-1),s=new Ye({run:0,pursuer:r[0],evader:r[1],episode:0,seed:null}),o=new qe(n,s,e),a=new Ke(n,s);o.actions.remove(),a.element.addEventListener(
"play",()=>{o.playSoon(),o.reveal()}),t.then(c=>o.start(c));let{seed:i}=n[0],l=n[0].world;return u("div",{class:"widget wide"},Ka(n,s),u("div",{class:"stages"},
a.element,o.element),u("p",{class:"small muted"},"Three races of ",u("code",{},`matrixworld evolve --seed ${i}`),`: ${l.n_pursuers} pursuers and ${l.n_evaders} \
evaders on ${l.rows} x ${l.cols} cells.`))}function Qa({runs:n}){let e=n[0],t=n[0].findings,[r,...s]=t.table,o=s.findIndex(([i])=>i==="arms race"),a={sentence:e.
name,table:[r,s[o]],reasons:[t.reasons[o]]};return u("div",{class:"widget text"},qa({...e,findings:{...t,...a}}).element)}var Sr=()=>{let[n]=crypto.getRandomValues(new Uint32Array(1));return{pupil:n.toString(16).padStart(8,"0"),choices:[],solved:{},exit:"",done:!1}},fn=class extends EventTarget{#e;#n;#t;keeps=!0;constructor(e){
super(),this.#n=e,this.#t=`matrixworld lesson ${e}`,this.#e=this.#r(),this.#a({})}choice=e=>this.#e.choices.find(({prediction:t})=>t===e)?.choice;choose(e,t){let r=new Date().
toISOString().replace(/\.\d+Z$/,"+00:00");this.#a({choices:[...this.#e.choices,{prediction:e,choice:t,time:r}]}),this.dispatchEvent(new CustomEvent("choice",{detail:e}))}solved=e=>this.#e.
solved[e];solve=(e,t)=>this.#a({solved:{...this.#e.solved,[e]:t}});get exit(){return this.#e}set exit(e){this.#a(e)}get count(){return this.#e.choices.length}get file(){
let{choices:e,pupil:t}=this.#e;return e.map(r=>`${JSON.stringify({...r,edition:this.#n,pupil:t})}
`).join("")}forget=()=>this.#a(Sr());#r(){try{return{...Sr(),...JSON.parse(localStorage.getItem(this.#t)??"{}")}}catch{return Sr()}}#a(e){this.#e={...this.#e,...e};
try{localStorage.setItem(this.#t,JSON.stringify(this.#e))}catch{this.keeps=!1}}};function ei(n,e){let t=[],r=[];for(let i of n)try{r.push({...i,...cu(i.text,e)})}catch(l){t.push({file:i.name,reason:l.message})}let s=new Map([...e.predictions].
map(([i,{options:l}])=>[i,new Map(Object.keys(l).map(c=>[c,0]))])),o=new Map,a=new Map;for(let{name:i,text:l,pupil:c,choices:d}of r.sort((m,h)=>h.choices.size-m.
choices.size)){let m=[...d].filter(([p])=>!o.has(`${c} ${p}`)),h=a.get(l)??(m.length?void 0:o.get(`${c} ${[...d.keys()][0]}`));if(h!==void 0){t.push({file:i,reason:a.
has(l)?`double: the same content as ${h}`:`double: the pupil of ${h}`});continue}a.set(l,i);for(let[p,f]of m)o.set(`${c} ${p}`,i),s.get(p).set(f,s.get(p).get(f)+
1)}return{counts:s,pupils:new Set([...o.keys()].map(i=>i.split(" ")[0])).size,left:t}}function cu(n,{edition:e,predictions:t}){if(n===null)throw new Error("expe\
cted at most 65536 bytes");let r=new Map,s="",o=n.split(/\r?\n/).filter(a=>a.trim());if(!o.length)throw new Error("expected predictions that the lesson has save\
d, got an empty file");return o.forEach((a,i)=>{let l=uu(a),{prediction:c,choice:d}=l;if(typeof c!="string"||typeof d!="string")throw new Error(`line ${i+1}: ex\
pected a prediction and its choice`);if(l.edition!==e)throw new Error(`line ${i+1}: expected edition ${e} of the course, got ${Mr(l.edition)}`);let m=t.get(c)?.
options;if(!m)throw new Error(`line ${i+1}: expected a prediction of the lesson, got ${Mr(c)}`);if(!Object.hasOwn(m,d))throw new Error(`line ${i+1}: expected on\
e of ${Object.keys(m).join(", ")} for ${c}, got ${Mr(d)}`);if(s||=String(l.pupil??""),!/^[0-9a-f]{8}$/.test(s)||l.pupil!==s)throw new Error(`line ${i+1}: expect\
ed lines of one pupil`);r.has(c)||r.set(c,d)}),{pupil:s,choices:r}}function uu(n){try{let e=JSON.parse(n);return typeof e=="object"&&e!==null?e:{}}catch{return{}}}
var Mr=n=>n===void 0?"none":JSON.stringify(n).slice(0,40);function ti(n){let e={edition:n.edition,predictions:Wt(n)},t=u("p",{role:"status"}),r=u("ul",{class:"left"}),s=u("div",{class:"questions"}),o=new Set,a=[],i=()=>{
let h=ei(a,e);t.textContent=a.length?`${a.length} ${a.length===1?"file":"files"}, ${h.pupils} ${h.pupils===1?"pupil":"pupils"}.${h.left.length?" Not counted:":""}`:
"No files yet.",r.replaceChildren(...h.left.map(({file:p,reason:f})=>u("li",{},u("strong",{},p),` ${f}`))),s.replaceChildren(...[...e.predictions.values()].map(
p=>mu(p,h,o,i)))},l=async h=>{let p=[...h].map(async f=>({name:f.name,text:f.size>65536?null:await f.text()}));a=[...a,...await Promise.all(p)],i()},c=u("input",
{type:"file",multiple:!0,accept:".jsonl",id:"vote-files",onchange:()=>{l(c.files).then(()=>c.value="")}}),d=u("button",{type:"button",onclick:()=>{a=[],o.clear(),
i()}},"Remove all files"),m=u("section",{class:"card drop","aria-label":"Files"},u("p",{},u("label",{for:"vote-files"},"Drop the files that your pupils have sav\
ed anywhere on this page, or choose them: ")),c,u("div",{class:"buttons"},t,d),r,u("p",{class:"small muted"},"A pupil saves predictions.jsonl at the end of the \
lesson. Names of files do not matter. Each pupil counts once: a second file of a pupil is named as double. Nothing leaves this computer."));document.addEventListener(
"dragover",h=>h.preventDefault()),document.addEventListener("drop",h=>{h.preventDefault(),l(h.dataTransfer?.files??[])}),document.getElementById("page").replaceWith(
Ft("How the class voted",u("span",{},`${n.title} `,u("a",{href:"#"},"Back to the lesson"))),u("main",{},m,s),u("footer",{class:"small muted"},`matrixworld ${n.version}\
, edition ${n.edition} of the course`)),i()}function mu(n,e,t,r){let{predict:s,options:o,outcome:a}=n,i=e.counts.get(s),l=[...i.values()].reduce((p,f)=>p+f,0),c=t.
has(s),d=n.again?e.counts.get(n.again):void 0,m=Object.entries(o).map(([p,f])=>{let y=u("span",{class:"filled"});y.style.width=`${100*i.get(p)/Math.max(1,l)}%`;
let g=c&&p===a;return u("li",{class:g?"vote right":"vote"},u("span",{},`${p}. ${f}`,g&&u("strong",{}," ✓ the outcome")),u("span",{class:"bar","aria-hidden":"t\
rue"},y),u("span",{class:"numbers"},`${i.get(p)} of ${l}`,d&&u("span",{class:"muted"},`, at first ${d.get(p)}`)))}),h=u("button",{type:"button",id:`outcome-${s}`,
onclick:()=>{t.add(s),r()}},"Show the outcome");return u("section",{class:"card question",id:`votes-${s}`},u("h2",{},n.question),u("ul",{class:"of-votes"},...m),
n.later?u("p",{class:"muted"},n.later):c?u("div",{class:"reply"},...bt(n.explanation??"")):u("div",{},h))}var ni="#votes",hu=["explorer"],pu=n=>"needs"in n?n.needs:void 0,gn=n=>"widget"in n;function fu(n){let e=[];for(let t of n){let r=e.at(-1);!r||"text"in t||gn(t)&&
r.some(gn)?e.push([t]):r.push(t)}return e}function gu(n){let e=n.find(gn);return e&&n.length>1&&!hu.includes(e.widget)&&!e.grows?"block beside":"block"}var Ar=class{#e;#n;#t=()=>{};#r=new Promise(
e=>this.#t=e);#a={chase:()=>Za(this.#e,this.#r),evolving:e=>Ja(this.#e,this.#r,e),"right-of-way":No,flat:Lo,hands:Go,"hands-matrix":Bo,games:Yo,numbers:Zo,matrices:()=>Po(
this.#e),explorer:()=>Xa(this.#e,this.#r),judgement:()=>Qa(this.#e),"same-diagonal":_o,exit:e=>na(e,this.#n)};constructor(e){this.#e=e,this.#n=new fn(e.edition);
let t=this.#n,r=Wt(e).size,s=u("span",{class:"small muted",role:"status"}),o=()=>{let i=t.keeps?"They stay in this browser.":"This browser keeps nothing: save b\
efore you close the page.";s.textContent=`${t.count} of ${r} predictions made. ${i}`};t.addEventListener("choice",o);let a=()=>{confirm("Delete all predictions \
and answers in this browser, for another student? Save them first.")&&(t.forget(),location.reload())};document.getElementById("page").replaceWith(Ft(e.title,e.lead),
u("nav",{class:"sections","aria-label":"Sections"},...e.sections.map((i,l)=>u("a",{href:`#${i.id}`},`${l+1}. ${i.title}`))),u("main",{},...e.sections.map((i,l)=>this.#l(
i,l))),u("footer",{class:"card"},u("div",{class:"buttons"},u("button",{type:"button",class:"primary save",onclick:()=>It("predictions.jsonl",t.file)},"Save my p\
redictions"),u("button",{type:"button",onclick:()=>print()},"Print"),u("button",{type:"button",onclick:a},"Start anew"),s),u("p",{class:"small muted"},`The page\
 sends nothing anywhere. matrixworld ${e.version}, edition ${e.edition} of the course. Teachers: `,u("a",{href:ni},"count the votes of a class"),"."))),o()}async load(){
this.#t(await Ot())}#s(e){return"text"in e?u("div",{class:"text"},...bt(e.text)):gn(e)?this.#a[e.widget](e):"exercise"in e?ta(e,this.#n):ea(e,this.#n)}#l(e,t){let{
sections:r}=this.#e,s=u("p",{class:"waiting muted",role:"status"}),o=u("section",{class:"card",id:e.id,"aria-labelledby":`title-${e.id}`},u("h2",{id:`title-${e.
id}`},`${t+1}. ${e.title}`,u("span",{class:"muted small"},`${e.minutes} minutes`)),s),a=fu(e.parts),i=a.map(m=>u("div",{class:gu(m)})),l=a.flatMap((m,h)=>m.map(
()=>i[h])),c=0,d=()=>{for(s.textContent="";c<e.parts.length;c++){let m=e.parts[c-1],h=e.parts[c],p=[Dt(m)?m.predict:void 0,pu(h)].find(f=>f&&this.#n.choice(f)===
void 0);if(p){let f=r.findIndex(({parts:y})=>y.some(g=>Dt(g)&&g.predict===p));s.textContent=`This section goes on with your prediction${f===t?"":` in section ${f+
1}`}.`;return}s.before(l[c]),l[c].append(this.#s(h))}s.remove()};return this.#n.addEventListener("choice",d),d(),o}};function yu(){let n=Us(),e=()=>location.hash===
ni,t=e();if(window.addEventListener("hashchange",()=>e()!==t&&location.reload()),t)return void qn(Promise.resolve(ti(n)));let r=new Ar(n);requestAnimationFrame(
()=>setTimeout(()=>qn(r.load())))}typeof document>"u"?Vn(globalThis):yu();})();
