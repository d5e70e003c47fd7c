/* built from web/ by "npm run build"; sources 935dfac1aaac763b3137186728bf53d2313bb373e9627ddd8f84a14c7c4e33be */
"use strict";(()=>{var jr={SIMULTANEOUS:0,SWARM_TURNS:1,AGENT_TURNS:2},at={DISAPPEAR:0,REACH:1,BOUNCE:2},Vr={OCCUPATION:0,SURROUND:1},qr={FAULT:0,INVOLVED:1};var Kr=["obstacle","teammate","adversary"],In=["vertex","edge","chain"],Yr=["turn","kind","form","first","second","row","col","at_fault","held","doomed"],Nn=["p\
ursuer_{number}","evader_{number}"],Zr={obstacle:"{first} ran into the obstacle or border at {cell}",vertex:"{first} and {second} both headed for {cell}",edge:"\
{first} and {second} meant to swap, {first} to {cell}",chain:"{first} headed for {cell}, where {second} had to stay"},it={"both held":"both bounce","both doomed":"\
both disappear",held:"{agent} bounces",doomed:"{agent} disappears",none:"nobody is stopped"},Jr="{event}: {outcome}",Ln={random:"any action, all equally likely",
still:"always stays",chaser:"moves to where the nearest adversary in view is nearest",fleer:"moves to where the nearest adversary in view is farthest","clumsy-c\
haser":"a chaser that takes any action in half of the steps",hunter:"a chaser of the nearest adversary in view to which no teammate in view is nearer",surrounder:"\
a chaser of the nearest free cell beside an adversary without a teammate","clumsy-fleer":"a fleer that takes any action in half of the steps",dodger:"moves to w\
here all adversaries in view together are farthest","team-surrounder":"shares the free cells beside adversaries with its teammates, and searches","careful-rando\
m":"as random, but takes only moves that right of way allows","careful-chaser":"as chaser, but takes only moves that right of way allows","careful-fleer":"as fl\
eer, but takes only moves that right of way allows","careful-clumsy-chaser":"as clumsy-chaser, but takes only moves that right of way allows","careful-hunter":"\
as hunter, but takes only moves that right of way allows","careful-surrounder":"as surrounder, but takes only moves that right of way allows","careful-clumsy-fl\
eer":"as clumsy-fleer, but takes only moves that right of way allows","careful-dodger":"as dodger, but takes only moves that right of way allows","careful-team-\
surrounder":"as team-surrounder, but takes only moves that right of way allows"},xe={adversary:"distance to the nearest adversary (0 to 2, in half views)",pressure:"\
sum over adversaries of 1 / (1 + moves)^2 (0 or more)",unclaimed:"distance to the nearest adversary to which no teammate is nearer than the agent is now; withou\
t one, to the nearest adversary (0 to 2, in half views)",open_side:"distance to the nearest cell beside an adversary that holds no obstacle and no teammate (0 t\
o 2, in half views)",teammate:"distance to the nearest teammate (0 to 2, in half views)",exits:"share of the cells around that are no obstacle (0 to 1)",room:"d\
istance to the nearest obstacle to the north, east, south or west (0 to 1, in half views)",must_yield:"1 if right of way forbids the move (0 to 1)",ahead:"1 if \
it is the direction that the agent draws for each 12 steps (0 to 1)",search:"1 if it leads on along the way on which an agent of team-surrounder searches the gr\
id (0 to 1)",escapes:"share of the cells that an evader may be on after its next move which hold no obstacle and which no pursuer in view reaches in one move: o\
f the nearest adversary, or an evader's own (0 to 1)",opposite:"(1 - cosine) / 2 of the angle at the nearest adversary between the agent and the teammate neares\
t to it; for an evader, of the angle at itself between its two nearest adversaries (0 to 1)",parity:"1 if the distance to the nearest adversary is odd (0 to 1)"},
Xr={free:".GS",blocked:"#@OTW"};var Ne=1+Yr.length;function lt(n,e){return n.replace(/\{(\w+)\}/g,(t,r)=>String(e[r]))}function ee(n,e){return n<e?lt(Nn[0],{number:n}):lt(Nn[1],{number:n-e})}function xi(n,e){
let[t,r,s,o,a,i,l,...c]=Array.from(n),m=a<0?[o]:[o,a],[d,h,p]=c.map(v=>m.filter((b,x)=>v>>x&1)),f=m.map(v=>ee(v,e)),y=lt(Zr[a<0?"obstacle":In[s]],{first:f[0],second:f[f.
length-1],cell:`(${i}, ${l})`}),g=lt(Jr,{event:y,outcome:Si(m.length,h,p,e)});return{kind:Kr[r],form:In[s],agents:m,cell:[i,l],at_fault:d,held:h,doomed:p,turn:t,
text:g}}function Si(n,e,t,r){if(n===2&&e.length===2)return it["both held"];if(n===2&&t.length===2)return it["both doomed"];let s=o=>a=>lt(it[o],{agent:ee(a,r)});
return[...e.map(s("held")),...t.map(s("doomed"))].join(", ")||it.none}function _t(n,e){let t=[];for(let r=0;r<n.length;r+=Ne)t.push(xi(n.subarray(r+1,r+Ne),e));
return t}var Se=class extends Error{name="EngineError"};function R(n,e,t){let r=typeof t=="string"?`'${t}'`:typeof t=="object"?JSON.stringify(t):String(t);return new Se(
`${n}: expected ${e}, got ${r}`)}var Le=class{bytes;constructor(e){this.bytes=e}},ts=0,Dn=[Uint8Array,Uint8Array,Int32Array,BigInt64Array,BigUint64Array,Float32Array,Float64Array],Qr=4,es=4,Mi=new TextEncoder,
Ai=new TextDecoder;function Ti(n){for(let e=Dn.length-1;e>ts;--e)if(n instanceof Dn[e])return e;throw new TypeError("array: expected a typed array of the engine\
's numbers, got another")}function Fn(n){return new Uint8Array(n.buffer,n.byteOffset,n.byteLength)}function Ei(n){return Mi.encode(`${n}\0`)}var Wn=class{engine;addresses=[];constructor(e){
this.engine=e}copy(e){let t=this.engine._malloc(Math.max(e.length,1));if(t===0)throw new Se("memory: expected room for the arguments, got none");return this.addresses.
push(t),this.engine.HEAPU8.set(e,t),t}text(e){return this.copy(Ei(e))}arrays(e){let t=Object.entries(e),r=t.flatMap(([o,a])=>{let i=a instanceof Le,l=i?a.bytes:
a;return[this.text(o),i?ts:Ti(l),l.length,this.copy(Fn(l))]}),s=this.copy(Fn(Int32Array.from(r)));return this.copy(Fn(Int32Array.of(t.length,s)))}free(){for(let e of this.
addresses)this.engine._free(e)}};function ns(n,e){let t=n.HEAPU8;return Ai.decode(t.subarray(e,t.indexOf(0,e)))}function Fe(n){let e=new Int32Array(n.HEAPU8.buffer),
t=n._last_outputs()/Qr,r=e[t+1]/Qr,s={};for(let o=r;o<r+e[t]*es;o+=es){let a=Dn[e[o+1]],i=e[o+2]*a.BYTES_PER_ELEMENT,l=e[o+3];s[ns(n,e[o])]=new a(n.HEAPU8.slice(
l,l+i).buffer)}return s}function pe(n,e){let t=new Wn(n);try{let r=e(t);if(r===0)throw new Se(ns(n,n._last_error()));return r}finally{t.free()}}var Ci=2**31-1,rs=["none","gru"],Oi=2n**64n-1n,ki=34028234663852886e22;function Y(n,e){if(typeof e!="number"||!Number.isInteger(e)||Math.abs(e)>Ci)throw R(n,"an\
 integer",e);return Int32Array.of(e)}function It(n,e){if(typeof e!="boolean")throw R(n,"true or false",e);return new Le(Uint8Array.of(Number(e)))}function Me(n,e,t){
let r=typeof e=="string"&&Object.hasOwn(t,e)?t[e]:void 0;if(r===void 0)throw R(n,`one of ${Object.keys(t).join(", ")}`,e);return Int32Array.of(r)}function Un(n,e){
if(typeof e!="number"||!(Math.abs(e)<=ki))throw R(n,"a finite number",e);return e}function ct(n,e){let r=typeof e=="bigint"||typeof e=="number"&&Number.isSafeInteger(
e)?BigInt(e):-1n;if(r<0n||r>Oi)throw R(n,"an integer from 0 to 2^64 - 1",e);return BigUint64Array.of(r)}function Ri(n){return{"rules.interaction":Me("interactio\
n",n.interaction,jr),"rules.obstacle":Me("obstacle",n.obstacle,at),"rules.teammate":Me("teammate",n.teammate,at),"rules.evader":Me("evader",n.evader,at),"rules.\
pursuer":Me("pursuer",n.pursuer,at),"rules.capture":Me("capture",n.capture,Vr),"rules.captured_disappear":It("captured_disappear",n.captured_disappear)}}function ss(n,e){
let t=typeof e=="number"?[e,e,e]:e;if(!Array.isArray(t)||t.length!==3)throw R(n,"1 or 3 numbers",e);return Float32Array.from(t,r=>Un(n,r))}function Pi(n){let e=(t,r)=>Float32Array.
of(Un(t,n[t]),Un(r,n[r]));return{"rewards.capture":e("pursuer_capture","evader_capture"),"rewards.neighbor":e("pursuer_neighbor","evader_neighbor"),"rewards.ste\
p":e("pursuer_step","evader_step"),"rewards.pursuer_collide":ss("pursuer_collide",n.pursuer_collide),"rewards.evader_collide":ss("evader_collide",n.evader_collide),
"rewards.blame":Me("blame",n.blame,qr),"rewards.capture_repeats":It("capture_repeats",n.capture_repeats)}}function is(n){if(n===void 0||typeof n=="number")return new Uint8Array(
0);if(n instanceof Uint8Array)return n;let{free:e,blocked:t}=Xr;for(let[r,s]of n.entries()){if(s.length!==n[0]?.length)throw R(`map, row ${r}`,`${n[0]?.length} \
cells as in row 0`,s.length);let o=[...s].find(a=>!e.includes(a)&&!t.includes(a));if(o)throw R(`map, row ${r}`,`'${e}' (free) or '${t}' (obstacle)`,o)}return Uint8Array.
from([...n.join("")],r=>Number(t.includes(r)))}function ls(n,e){if(!Array.isArray(n))return;let t=[n.length,n[0]?.length??0];if(!(t[0]===e.rows&&t[1]===e.cols))
throw R("obstacle map",`shape (${e.rows}, ${e.cols}), the rows and cols`,t)}function De(n){ls(n.obstacles,n);let e=typeof n.obstacles=="number"?n.obstacles:0;return{
...Ri(n.rules),...Pi(n.rewards),rows:Y("rows",n.rows),cols:Y("cols",n.cols),n_pursuers:Y("n_pursuers",n.n_pursuers),n_evaders:Y("n_evaders",n.n_evaders),fov:Y("\
fov",n.fov),diagonal:It("diagonal",n.diagonal),max_steps:Y("max_steps",n.max_steps),density:Float64Array.of(e),map:is(n.obstacles)}}function os(n,e){return Int32Array.
from((e??[]).flat(),t=>Y(n,t)[0])}function cs(n,e){return ls(n.obstacles,e),{seed:ct("seed",n.seed??0n),episode:ct("episode",n.episode??0),pursuers:os("pursuers",
n.pursuers),evaders:os("evaders",n.evaders),map:is(n.obstacles)}}function Nt(n){return{actions:Int32Array.from(n,e=>Y("actions",e)[0])}}var as=Object.keys(xe);function Hn(n){
let e=as.indexOf(n);if(e<0)throw R("inputs",`names of ${as.join(", ")}`,n);return e}function Ae(n){if(typeof n=="string"){if(!Object.hasOwn(Ln,n))throw R("polic\
y",`one of ${Object.keys(Ln).join(", ")}`,n);return{script:new TextEncoder().encode(n)}}if(n.kind!=="cells")return{inputs:Int32Array.from(n.inputs,e=>Hn(e)),hidden:Int32Array.
from(n.kind==="rating"?n.hidden:[],e=>Y("hidden",e)[0]),length:Y("length",n.kind==="program"?n.length:0),mask:new TextEncoder().encode(n.mask),genome:n.genome};
if(n.activation!=="relu"&&n.activation!=="tanh")throw R("activation","'relu' or 'tanh'",n.activation);if(!rs.includes(n.memory))throw R("memory",`one of ${rs.join(
", ")}`,n.memory);return{hidden:Int32Array.from(n.hidden,e=>Y("hidden",e)[0]),activation:new TextEncoder().encode(n.activation),sampled:It("sampled",n.sampled),
memory:new TextEncoder().encode(n.memory),genome:n.genome}}var $i=["first_turn","terminated","truncated"];function us(n){let e={...n};for(let t of $i)e[t]=new Le(
n[t]);return e}var ds="statistics.",Lt=class{config;seed;episode;n_agents;statistics;first_conflict;constructor(e,t,r,s){this.config=e,this.seed=t,this.episode=r,this.n_agents=
e.n_pursuers+e.n_evaders,this.statistics=Ii(ms(s)),Object.assign(this,s),this.first_conflict=_i(this.conflict_table,this.length)}get length(){return this.actions.
length/this.n_agents}conflicts(e){this.check(e);let t=this.first_conflict[e],r=this.first_conflict[e+1],s=this.conflict_table.subarray(t*Ne,r*Ne);return _t(s,this.
config.n_pursuers)}seek(e,t,r){this.check(t),(!(e.seed===this.seed&&e.episode===BigInt(this.episode))||e.turn!==0||e.steps>t)&&e.reset({seed:this.seed,episode:this.
episode});for(let o=e.steps;o<t;++o){let a=this.actions.subarray(o*this.n_agents,(o+1)*this.n_agents);r?e.replay(a,{pursuer:r.pursuers,evader:r.evaders}):e.step(
a)}}check(e){if(!(Number.isInteger(e)&&e>=0&&e<=this.length))throw R("step",`0 to ${this.length}`,e)}};function _i(n,e){let t=new Int32Array(e+2);for(let r=0;r<
n.length;r+=Ne)++t[n[r]+1];for(let r=1;r<t.length;++r)t[r]+=t[r-1];return t}function Ii(n){let e=["capture_rate","ever_capture_rate","captured_fraction","length"];
return Object.fromEntries(Object.entries(n).map(([t,r])=>[t,e.includes(t)?Number(r[0]):r]))}var ms=n=>Object.fromEntries(Object.entries(n).flatMap(([e,t])=>e.startsWith(
ds)?[[e.slice(ds.length),t]]:[]));function hs(n,e,t,r){let s=[De(t.config),Ae(t.pursuers),Ae(t.evaders),r];return pe(n,o=>{let[a,i,l,c]=s.map(m=>o.arrays(m));return n[e](
a,i,l,c)}),Fe(n)}function ps(n,e,t,r){let s={seed:ct("seed",t),episode:ct("episode",r)};return new Lt(e.config,t,r,hs(n,"_play_match",e,s))}function fs(n,e,t,r){
if(!Number.isInteger(r)||r<1)throw R("n_episodes","at least 1",r);let s=hs(n,"_play_rollout",e,{...t,n_episodes:Int32Array.of(r)});return ms(s)}var Ni=7e6,Li=new FinalizationRegistry(([n,e])=>n._states_free(e));function Fi({rules:n,rows:e,cols:t,obstacles:r,diagonal:s,n_pursuers:o,n_evaders:a}){let i=typeof r==
"number"||n.obstacle==="REACH"?0:r.join("").split("#").length-1,l=e*t-i,c=[n.obstacle,n.teammate,n.pursuer].includes("DISAPPEAR"),m=n.capture==="SURROUND"||n.evader===
"REACH",d=n.interaction==="AGENT_TURNS",h=(y,g)=>Array.from({length:g},(v,b)=>d?y:(y+b)/(b+1)).reduce((v,b)=>v*b,1),p=h(l+Number(c),o)*h(l*(1+Number(m))+2,a);return{
SIMULTANEOUS:[o+a],SWARM_TURNS:[o,a],AGENT_TURNS:Array(o+a).fill(1)}[n.interaction].reduce((y,g)=>y+p*(s?9:5)**g,0)}function gs(n){return typeof n.obstacles=="n\
umber"&&n.obstacles>0?"obstacles are drawn anew in each episode":Fi(n)>Ni?"the world is too large to be solved on the page":""}var zn=class{value;teams;matrix;n_actions;constructor(e,t){
let{matrix:r,rows:s,cols:o,value:a,agents:i}=t,[l,c]=e.actors,m=Array.from(i).filter(h=>l<=h&&h<c),d=h=>h<e.config.n_pursuers;this.value=a[0],this.matrix=r,this.
n_actions=e.n_actions,this.teams=[{agents:m.filter(d),play:s},{agents:m.filter(h=>!d(h)),play:o}]}marginal(e){let t=this.teams.find(({agents:o})=>o.includes(e));
if(!t)return null;let r=this.n_actions**(t.agents.length-1-t.agents.indexOf(e)),s=Array(this.n_actions).fill(0);return t.play.forEach((o,a)=>s[Math.floor(a/r)%this.
n_actions]+=o),s}lost(e){let[t,r]=this.teams.map(({agents:l})=>l.reduce((c,m)=>c*this.n_actions+e[m],0)),[s,o]=this.teams.map(({play:l})=>l),a=o.reduce((l,c,m)=>l+
c*this.matrix[t*o.length+m],0),i=s.reduce((l,c,m)=>l+c*this.matrix[m*o.length+r],0);return[Math.max(0,this.value-a),Math.max(0,i-this.value)]}},ys=60,ut=class{config;payoff;engine;states;n_turns;values;constructor(e,t,r){
this.engine=e,this.config=t,this.payoff=r,this.states=pe(e,i=>e._states_new(i.arrays(De(t)))),Li.register(this,[e,this.states]);let s={SIMULTANEOUS:1,SWARM_TURNS:2,
AGENT_TURNS:t.n_pursuers+t.n_evaders};this.n_turns=s[t.rules.interaction];let{payoffs:o}=this.call(()=>e._states_payoffs(this.states)),a=o;this.values=[[r==="ca\
pture-rate"?a:a.fill(0)]]}goBack(){let e=this.values.at(-1)[0],t=[];for(let s=this.n_turns-1;s>=0;s--){let o=t[s+1]??e;t[s]=this.backup(s,{next:o})}this.payoff===
"capture-time"&&(t[0]=t[0].map((s,o)=>o===this.config.n_evaders?0:s-1)),this.values.push(t);let r=this.payoff==="capture-rate"?this.config.max_steps:Math.min(this.
config.max_steps,ys);return this.values.length<=r&&t[0].some((s,o)=>s!==e[o])}backup(e,t){return this.call(r=>this.engine._states_backup(this.states,e,r.arrays(
t))).values}game(e){let t=this.config.max_steps-e.steps,{turn:r}=e,s=r+1===this.n_turns,o=t>0?this.values[Math.min(t-Number(s),this.values.length-1)]?.[s?0:r+1]:
void 0;if(!o)return null;let a=this.call(i=>this.engine._states_game(this.states,e.address,i.arrays({next:o})));return a.agents.length?new zn(e,a):null}call(e){
return pe(this.engine,e),Fe(this.engine)}};var vs=new FinalizationRegistry(([n,e])=>n._world_free(e)),dt=class{config;n_agents;n_actions;engine;at;freed=!1;constructor(e,t){this.engine=e,this.config=t,this.
n_agents=t.n_pursuers+t.n_evaders,this.n_actions=t.diagonal?9:5,this.at=pe(e,r=>e._world_new(r.arrays(De(t)))),vs.register(this,[e,this.at],this)}free(){this.freed||
(this.freed=!0,vs.unregister(this),this.engine._world_free(this.at))}get address(){if(this.freed)throw R("world","one that is in use","one that was freed");return this.
at}reset(e={}){let t=cs(e,this.config);this.call(r=>this.engine._world_reset(this.address,r.arrays(t)))}step(e){let t=Nt(e);this.call(r=>this.engine._world_step(
this.address,r.arrays(t)))}playTurn(e){let t=Nt(e);this.call(r=>this.engine._world_play_turn(this.address,r.arrays(t)))}decide(e,t,r){let{n_pursuers:s}=this.config,
o={pursuer:[0,s],evader:[s,this.n_agents]},[a,i]=typeof t=="string"?o[t]:t;if(r.length!==this.n_agents)throw R("actions",String(this.n_agents),r.length);let l=[
Ae(e),Nt(r)],{actions:c}=this.call(m=>this.engine._world_decide(this.address,m.arrays(l[0]),a,i,m.arrays(l[1])));return Uint8Array.from(c)}replay(e,t){let r=o=>typeof o!=
"string"&&o.kind==="cells"&&o.memory!=="none";if(!r(t.pursuer)&&!r(t.evader))return this.step(e);let{n_pursuers:s}=this.config;for(let o=this.n_turns;o>0;--o){let[
a,i]=this.actors;a<s&&this.decide(t.pursuer,[a,Math.min(i,s)],e),i>s&&this.decide(t.evader,[Math.max(a,s),i],e),this.playTurn(e)}}get n_turns(){return this.turnNumbers()[1]}get turn(){
return this.turnNumbers()[0]}get actors(){let[,,e,t]=this.turnNumbers();return[e,t]}turnNumbers(){return this.call(()=>this.engine._world_turn(this.address)).turn}get steps(){
return this.read("steps")[0]}get seed(){return this.read("seed")[0]}get episode(){return this.read("episode")[0]}get over(){return this.read("terminated")[0]===
1||this.read("truncated")[0]===1}read(e){return this.call(t=>this.engine._world_read(this.address,t.text(e)))[e]}view(e){let t=3*this.config.fov**2;return this.
read("views").slice(e*t,(e+1)*t)}map(){return this.read("state").slice(2*this.config.rows*this.config.cols)}conflicts(){return _t(this.conflictTable(),this.config.
n_pursuers)}conflictTable(){return this.call(()=>this.engine._world_conflicts(this.address)).conflict_table}answer(e,t){let r=Ae(e),{logits:s,memory:o}=this.call(
l=>this.engine._world_logits(this.address,l.arrays(r),t)),a=s,i=this.decide(e,[t,t+1],new Uint8Array(this.n_agents))[t];return{logits:a,probabilities:Di(a),action:i,
memory:o}}rate(e,t){let r=Ae(e),{ratings:s,refused:o}=this.call(c=>this.engine._world_rate(this.address,c.arrays(r),t)),a=this.read("inputs"),i=a.length/this.n_agents/
this.n_actions,l=c=>Float32Array.from({length:this.n_actions},(m,d)=>a[(t*this.n_actions+d)*i+c]);return{inputs:e.inputs.map(c=>l(Hn(c))),ratings:s,refused:o}}snapshot(){
return this.call(()=>this.engine._world_snapshot(this.address))}restore(e){let t=us(e);this.call(r=>this.engine._world_restore(this.address,r.arrays(t)))}call(e){
return pe(this.engine,e),Fe(this.engine)}};function Di(n){let e=Math.max(...n),t=Array.from(n,s=>Math.exp(s-e)),r=t.reduce((s,o)=>s+o,0);return Float32Array.from(
t,s=>s/r)}var Gn=class{compiled;constructor(e){this.compiled=e}world(e){return new dt(this.compiled,e)}solution(e,t="capture-rate"){return new ut(this.compiled,e,t)}match(e,t,r,s,o=0){
return ps(this.compiled,{config:e,pursuers:t,evaders:r},s,o)}rollouts(e,t,r,s,o){return fs(this.compiled,{config:e,pursuers:t,evaders:r},s,o)}},bs;function Ft(n=globalThis.
matrixworldEngine){return bs??=Wi(n),bs}async function Wi(n){if(!n)throw new Error("matrixworldEngine: expected the script engine.js before this one, got none");
let e=Uint8Array.from(atob(n.binary),t=>t.charCodeAt(0));return new Gn(await n({wasmBinary:e}))}var q=Uint8Array,We=Uint16Array,Ui=Int32Array,ws=new q([0,0,0,0,0,0,0,0,1,1,1,1,2,2,2,2,3,3,3,3,4,4,4,4,5,5,5,5,0,0,0,0]),xs=new q([0,0,0,0,1,1,2,2,3,3,4,4,5,5,
6,6,7,7,8,8,9,9,10,10,11,11,12,12,13,13,0,0]),Hi=new q([16,17,18,0,8,7,9,6,10,5,11,4,12,3,13,2,14,1,15]),Ss=function(n,e){for(var t=new We(31),r=0;r<31;++r)t[r]=
e+=1<<n[r-1];for(var s=new Ui(t[30]),r=1;r<30;++r)for(var o=t[r];o<t[r+1];++o)s[o]=o-t[r]<<5|r;return{b:t,r:s}},Ms=Ss(ws,2),As=Ms.b,zi=Ms.r;As[28]=258,zi[258]=28;
var Ts=Ss(xs,0),Gi=Ts.b,xd=Ts.r,Vn=new We(32768);for(O=0;O<32768;++O)ce=(O&43690)>>1|(O&21845)<<1,ce=(ce&52428)>>2|(ce&13107)<<2,ce=(ce&61680)>>4|(ce&3855)<<4,Vn[O]=
((ce&65280)>>8|(ce&255)<<8)>>1;var ce,O,mt=(function(n,e,t){for(var r=n.length,s=0,o=new We(e);s<r;++s)n[s]&&++o[n[s]-1];var a=new We(e);for(s=1;s<e;++s)a[s]=a[s-
1]+o[s-1]<<1;var i;if(t){i=new We(1<<e);var l=15-e;for(s=0;s<r;++s)if(n[s])for(var c=s<<4|n[s],m=e-n[s],d=a[n[s]-1]++<<m,h=d|(1<<m)-1;d<=h;++d)i[Vn[d]>>l]=c}else
for(i=new We(r),s=0;s<r;++s)n[s]&&(i[s]=Vn[a[n[s]-1]++]>>15-n[s]);return i}),ht=new q(288);for(O=0;O<144;++O)ht[O]=8;var O;for(O=144;O<256;++O)ht[O]=9;var O;for(O=
256;O<280;++O)ht[O]=7;var O;for(O=280;O<288;++O)ht[O]=8;var O,Es=new q(32);for(O=0;O<32;++O)Es[O]=5;var O;var Bi=mt(ht,9,1);var ji=mt(Es,5,1),Bn=function(n){for(var e=n[0],t=1;t<n.length;++t)n[t]>e&&(e=n[t]);return e},Z=function(n,e,t){var r=e/8|0;return(n[r]|n[r+1]<<8)>>(e&7)&t},jn=function(n,e){
var t=e/8|0;return(n[t]|n[t+1]<<8|n[t+2]<<16)>>(e&7)},Vi=function(n){return(n+7)/8|0},qi=function(n,e,t){return(e==null||e<0)&&(e=0),(t==null||t>n.length)&&(t=n.
length),new q(n.subarray(e,t))};var Ki=["unexpected EOF","invalid block type","invalid length/literal","invalid distance","stream finished","no stream handler",,"no callback","invalid UTF-8 da\
ta","extra field too long","date not in range 1980-2099","filename too long","stream finishing","invalid zip data"],J=function(n,e,t){var r=new Error(e||Ki[n]);
if(r.code=n,Error.captureStackTrace&&Error.captureStackTrace(r,J),!t)throw r;return r},Yi=function(n,e,t,r){var s=n.length,o=r?r.length:0;if(!s||e.f&&!e.l)return t||
new q(0);var a=!t,i=a||e.i!=2,l=e.i;a&&(t=new q(s*3));var c=function(zr){var Gr=t.length;if(zr>Gr){var Br=new q(Math.max(Gr*2,zr));Br.set(t),t=Br}},m=e.f||0,d=e.
p||0,h=e.b||0,p=e.l,f=e.d,y=e.m,g=e.n,v=s*8;do{if(!p){m=Z(n,d,1);var b=Z(n,d+1,3);if(d+=3,b)if(b==1)p=Bi,f=ji,y=9,g=5;else if(b==2){var $=Z(n,d,31)+257,_=Z(n,d+
10,15)+4,z=$+Z(n,d+5,31)+1;d+=14;for(var I=new q(z),we=new q(19),U=0;U<_;++U)we[Hi[U]]=Z(n,d+U*3,7);d+=_*3;for(var Pt=Bn(we),Rn=(1<<Pt)-1,Pn=mt(we,Pt,1),U=0;U<z;){
var $t=Pn[Z(n,d,Rn)];d+=$t&15;var x=$t>>4;if(x<16)I[U++]=x;else{var j=0,D=0;for(x==16?(D=3+Z(n,d,3),d+=2,j=I[U-1]):x==17?(D=3+Z(n,d,7),d+=3):x==18&&(D=11+Z(n,d,
127),d+=7);D--;)I[U++]=j}}var S=I.subarray(0,$),C=I.subarray($);y=Bn(S),g=Bn(C),p=mt(S,y,1),f=mt(C,g,1)}else J(1);else{var x=Vi(d)+4,T=n[x-4]|n[x-3]<<8,A=x+T;if(A>
s){l&&J(0);break}i&&c(h+T),t.set(n.subarray(x,A),h),e.b=h+=T,e.p=d=A*8,e.f=m;continue}if(d>v){l&&J(0);break}}i&&c(h+131072);for(var H=(1<<y)-1,W=(1<<g)-1,V=d;;V=
d){var j=p[jn(n,d)&H],he=j>>4;if(d+=j&15,d>v){l&&J(0);break}if(j||J(2),he<256)t[h++]=he;else if(he==256){V=d,p=null;break}else{var Wr=he-254;if(he>264){var U=he-
257,ot=ws[U];Wr=Z(n,d,(1<<ot)-1)+As[U],d+=ot}var $n=f[jn(n,d)&W],_n=$n>>4;$n||J(3),d+=$n&15;var C=Gi[_n];if(_n>3){var ot=xs[_n];C+=jn(n,d)&(1<<ot)-1,d+=ot}if(d>
v){l&&J(0);break}i&&c(h+131072);var Ur=h+Wr;if(h<C){var Hr=o-C,wi=Math.min(C,Ur);for(Hr+h<0&&J(3);h<wi;++h)t[h]=r[Hr+h]}for(;h<Ur;++h)t[h]=t[h-C]}}e.l=p,e.p=V,e.
b=h,e.f=m,p&&(m=1,e.m=y,e.d=f,e.n=g)}while(!m);return h!=t.length&&a?qi(t,0,h):t.subarray(0,h)};var Zi=new q(0);var Ji=function(n,e){return((n[0]&15)!=8||n[0]>>4>7||(n[0]<<8|n[1])%31)&&J(6,"invalid zlib data"),(n[1]>>5&1)==+!e&&J(6,"invalid zlib data: "+(n[1]&32?"need":"u\
nexpected")+" dictionary"),(n[1]>>3&4)+2};function Cs(n,e){return Yi(n.subarray(Ji(n,e&&e.dictionary),-4),{i:2},e&&e.out,e&&e.dictionary)}var Xi=typeof TextDecoder<"u"&&new TextDecoder,Qi=0;try{Xi.decode(Zi,{stream:!0}),Qi=1}catch{}var M=["pursuer","evader"],te=n=>n==="pursuer"?"evader":"pursuer";var el={teams:{pursuer:"pursuers",evader:"evaders"},generation:{pursuer:"pursuer generation",evader:"evader generation"},score:"capture rate",means:{pursuer:"ca\
ptures",evader:"escapes"},curves:{pursuer:"captures",evader:"escapes"},ends:["0 all escape","1 all caught"],lead:"Each cell is a match between two generations: \
the brighter, the more evaders are captured. Click one to watch it.",click:"watch its match"},Os=([n,e])=>({teams:{pursuer:n,evader:e},generation:{pursuer:`gene\
ration of ${n}`,evader:`generation of ${e}`},score:`score of the ${n}`,means:{pursuer:n,evader:e},curves:{pursuer:"scores",evader:"scores"},ends:[`0 the ${e} wi\
n`,`1 the ${n} win`],lead:`Each cell is a pair of generations: the brighter, the higher the score of the ${n}. Click one to see more of it.`,click:"see more of \
it"}),tl=["0 worst","1 best"],nl=n=>({...Os([n,n]),generation:{pursuer:`generation of ${n}`,evader:"generation of the opponent"},score:"score",ends:["0 loses","\
1 wins"],lead:`Each cell is a pair of generations of ${n}: the brighter, the higher the score of the row. Click one to see more of it.`}),rl=({game:n})=>n&&n.teams[0]===
n.teams[1]?M.slice(0,1):M,ne=n=>{if(!n.game)return el;let e=rl(n).length===1?nl(n.game.teams[0]):Os(n.game.teams);return n.payoff?.others?{...e,ends:tl}:e},G=(n,e,t)=>`${ne(
n).teams[e]} of generation ${t}`;function ge(n,e,t){let r=e-n.payoff.first[0],s=t-n.payoff.first[1],o=n.payoff.capture_rate[r]?.[s];return o===void 0?null:{rate:o,rates:n.payoff.capture_rates[r][s],
lengths:n.payoff.lengths[r]?.[s]??[]}}function ks(n,e,t){let{script:r,policy:s,kept:o,genomes:a}=n.teams[e];if(r!==null||s===null)return"";if(!o.includes(t))return`\
The page holds no genome of ${G(n,e,t)}: it would be too large. Choose a generation of ${o.join(", ")}.`;let i=o.length*s.genome_size;return _s(a,s.genome_size).
length===i?"":`The page is damaged: it does not hold the ${i} numbers of the ${e}s' genomes. Write it again from its run.`}function fe(n,e,t){let{script:r,policy:s,
kept:o,genomes:a}=n.teams[e];if(r!==null||s===null)return r??"random";let i=o.indexOf(t);if(i<0)throw new RangeError(`${e}: expected a generation whose genome t\
he page holds, got ${t}`);let l=s.genome_size,c=_s(a,l).subarray(i*l,(i+1)*l);return{...s,genome:c}}var Rs=({teams:n},e)=>(n[e].policy??{kind:"cells"}).kind!=="\
cells";function Ps({teams:n},e,t){let{kept:r,expressions:s,weights:o}=n[e],a=r.indexOf(t),i=s?.[a];return i?{expression:i,weights:o?.[a]??null}:null}function Yn(n,e){
return n.kind==="program"?e?.weights??null:n.hidden.length?null:Object.fromEntries(n.inputs.map((t,r)=>[t,n.genome[r]]))}function Dt(n,e,{pursuer:t,evader:r,episode:s,
seed:o}){let a=e.seeds[t][r];return n.match(e.world,fe(e,"pursuer",t),fe(e,"evader",r),BigInt(o??a),s)}var qn=4,Kn=new Map,$s=(n,e)=>{Kn.set(n,e)};function _s(n,e){
let t=Kn.get(n);if(t)return t;let r=new Float32Array;try{let s=ol(Zn(n),e);s.every(Number.isFinite)&&(r=s)}catch(s){if(!(s instanceof DOMException||s instanceof
RangeError||sl(s)))throw s}return Kn.set(n,r),r}var sl=n=>n instanceof Error&&"code"in n;function ol(n,e){let t=Cs(n),r=t.length/qn,s=new Uint8Array(t.length);for(let a=0;a<
s.length;a++)s[a]=t[a%qn*r+Math.floor(a/qn)];let o=new Uint32Array(s.buffer);for(let a=e;a<o.length;a++)o[a]^=o[a-e];return new Float32Array(s.buffer)}function Zn(n){
let e=atob(ue(n)),t=new Uint8Array(e.length);for(let r=0;r<t.length;r++)t[r]=e.charCodeAt(r);return t}var ue=n=>document.getElementById(n)?.textContent??"";var Fs={initial:1,noise:2,learn:3,opponents:4},Xn={pursuer:1,evader:2,both:3},Te=4,Jn=2n**32n;function Is(n){let e=[],t=BigInt(n);do e.push(Number(t%Jn)),t/=Jn;while(t>
0n);return e}function Ns(n,e){let t=n;return r=>{let s=r^t;return t=Math.imul(t,e),s=Math.imul(s,t),s^s>>>16}}function Ls(n,e){let t=Math.imul(3389127133,n)-Math.
imul(1232336661,e)|0;return t^t>>>16}function Qn(n,e,t){let r=n.flatMap(Is);if(e.length){for(;r.length<Te;)r.push(0);r.push(...e.flatMap(Is))}let s=Ns(1135663077,
2468251765),o=Array.from({length:Te},(i,l)=>s(r[l]??0));for(let i=0;i<Te;i++)for(let l=0;l<Te;l++)i!==l&&(o[l]=Ls(o[l],s(o[i])));for(let i of r.slice(Te))for(let l=0;l<
Te;l++)o[l]=Ls(o[l],s(i));let a=Ns(2337405405,1492356589);return Uint32Array.from({length:t},(i,l)=>a(o[l%Te]))}function pt(n,e){let t=Qn(n,[],2*e);return BigUint64Array.
from({length:e},(r,s)=>BigInt(t[2*s])+Jn*BigInt(t[2*s+1]))}var Wt=(n,e,t)=>pt([n,e,t],1)[0];var Ds=n=>(e,...t)=>new er(Qn([n],[Fs[e],...t],3)),er=class{#e;#n;#t;#r=1;constructor(e){this.#e=e[0],this.#n=e[1],this.#t=e[2];for(let t=0;t<12;t++)this.#a()}#a(){
let e=this.#e+this.#n+this.#r++|0;return this.#e=this.#n^this.#n>>>9,this.#n=this.#t+(this.#t<<3)|0,this.#t=(this.#t<<21|this.#t>>>11)+e|0,e>>>0}#s(){return(this.#a()+
.5)/2**32}normals(e){let t=new Float32Array(e);for(let r=0;r<e;r+=2){let s=Math.sqrt(-2*Math.log(this.#s())),o=2*Math.PI*this.#s();t[r]=s*Math.cos(o),r+1<e&&(t[r+
1]=s*Math.sin(o))}return t}integers(e,t){return Int32Array.from({length:t},()=>Math.floor(this.#s()*e))}permutation(e){return this.choice(e,e)}choice(e,t){let r=Int32Array.
from({length:e},(s,o)=>o);for(let s=0;s<t;s++){let o=s+Math.floor(this.#s()*(e-s));[r[s],r[o]]=[r[o],r[s]]}return r.slice(0,t)}};var k=Math.fround,al=5,il=256,Ut=class{size;sigma;fixed;#e;constructor(e,t,r,s){this.size=e,this.sigma=r,this.fixed=s,this.#e=t.normals((1+il)*e);for(let o=0;o<
this.#e.length;o++)this.#e[o]*=k(r)}draw(e,t){let r=t.integers(this.#e.length-this.size+1,e);return Array.from(r,s=>{let o=this.#e.subarray(s,s+this.size);return this.
fixed?o.map((a,i)=>this.fixed[i]?0:a):o})}},tr=class{#e;#n;#t=0;constructor(e){this.#e=new Float32Array(e),this.#n=new Float32Array(e)}moved(e,t,r){let a=k(1e-8);
this.#t+=1;let i=k(1-.9),l=k(1-.999),c=k(1-.9**this.#t),m=k(1-.999**this.#t);return e.map((d,h)=>{let p=t[h],f=this.#e[h]+=k(i*k(p-this.#e[h])),y=this.#n[h]+=k(
l*k(k(p*p)-this.#n[h])),g=k(k(Math.sqrt(k(k(y)/m)))+a);return k(d+k(k(k(r)*k(k(f)/c))/g))})}};function ll(n){let e=Array.from(n).sort((t,r)=>t-r);return n.map(t=>(e.
indexOf(t)+e.lastIndexOf(t))/(2*(n.length-1))-.5)}var Ht=class{genome;groups;#e;#n;#t;#r=[];constructor(e,t,r){this.genome=e,this.#n=t,this.#e=r,this.#t=new tr(
e.length),this.groups=Int32Array.from({length:r.population},(s,o)=>o%(r.population/2))}get#a(){let{sigma:e,fixed:t}=this.#n,r=0,s=0;return this.genome.forEach((o,a)=>{
t?.[a]||(r+=o*o,s+=1)}),Math.max(e,this.#e.relative_sigma*Math.sqrt(r/s))}ask(e){let t=this.#e.population/2,r=this.genome.length;this.#r=this.#n.draw(t,e);let s=k(
this.#a/this.#n.sigma),o=new Float32Array(2*t*r);return this.#r.forEach((a,i)=>{for(let l=0;l<r;l++){let c=k(s*a[l]);o[i*r+l]=this.genome[l]+c,o[(t+i)*r+l]=this.
genome[l]-c}}),o}tell(e){let t=ll(e),r=this.#r.length,s=new Float32Array(this.genome.length);this.#r.forEach((o,a)=>{let i=k((t[a]-t[r+a])/(2*r*this.#n.sigma**2));
for(let l=0;l<s.length;l++)s[l]+=k(i*o[l])}),this.genome=this.#t.moved(this.genome,s,this.#e.learning_rate)}},ft=class{population;groups;#e;#n;#t=new Float64Array(
0);#r=0;constructor(e,t,r){this.population=e,this.#n=t,this.#e=r,this.groups=new Int32Array(r.population)}get genome(){return this.#a(this.#r).slice()}#a(e){let{
size:t}=this.#n;return this.population.subarray(e*t,(e+1)*t)}#s(e,t){let r=this.#e.tournament??al,s=t.integers(this.#t.length,e*r);return Array.from({length:e},
(o,a)=>s.subarray(a*r,(a+1)*r).reduce((i,l)=>this.#t[l]>this.#t[i]?l:i))}ask(e){if(!this.#t.length)return this.population;let{size:t}=this.#n,{population:r,elites:s}=this.#e,
o=r-s,a=this.#s(o,e);this.#s(o,e);let i=Array.from(this.#t.keys()).sort((c,m)=>this.#t[m]-this.#t[c]).slice(0,s),l=new Float32Array(this.population.length);return[
...i,...a].forEach((c,m)=>l.set(this.#a(c),m*t)),this.#n.draw(o,e).forEach((c,m)=>{let d=(s+m)*t;for(let h=0;h<t;h++)l[d+h]+=c[h]}),this.population=l,l}tell(e){
this.#t=e,this.#r=e.indexOf(Math.max(...e))}};var E=n=>Array.from(n).reduce((e,t)=>e+t,0)/n.length,nr=(n,e)=>e==="pursuer"?n:n[0].map((t,r)=>n.map(s=>1-s[r]));var Ws=-12676506002282294e14,Us=({hidden:n,mask:e})=>n.map(t=>t+(e?4:0));function gt(n){let e=[3*n.fov**2,...Us(n),5],t=0;return e.slice(1).map((r,s)=>{let o={at:t,
inputs:e[s],outputs:r};return t+=(o.inputs+1)*r,o})}function Ee(n){if(n.kind==="rating")return n.inputs.length;let{at:e,inputs:t,outputs:r}=gt(n).at(-1);return e+
(t+1)*r}var yt=(n,e)=>n.kind==="rating"?{...n,genome:e}:{kind:"cells",hidden:Us(n),activation:"relu",sampled:!0,memory:"none",genome:e};function Hs(n,e,t){let r=t.
initial_weight;if(n.kind==="rating"||t.kind==="rating")return e.normals(Ee(n)).map(i=>Math.fround(r)*i);let s=t.initial_head,o=new Float32Array(Ee(n)),a=gt(n);return a.
forEach(({at:i,inputs:l,outputs:c},m)=>{let d=Math.fround(m===a.length-1?s:r);e.normals(l*c).forEach((h,p)=>o[i+p]=d*h)}),o}function rr(n){if(n.kind==="rating")
return null;let{fov:e,mask:t}=n;if(!t)return null;let r=new Uint8Array(Ee(n)),s=new Float32Array(Ee(n)),o=gt(n),a=o.length-1,i=Math.floor(e/2);return o.forEach(
({at:l,inputs:c,outputs:m},d)=>{let h=(p,f)=>l+p*m+f;for(let p=0;p<4;p++)if(d>0&&r.fill(1,h(c-4+p,0),h(c-4+p+1,0)),d<a)for(let f=0;f<=c;f++)r[h(f,m-4+p)]=1;t.forEach(
(p,f)=>{let y=d===a?1+f:m-4+f,g=d===0?p.map(([v,b,x])=>(v*e+i+b)*e+i+x):[c-4+f];for(let v of g)r[h(v,y)]=1,s[h(v,y)]=d===a?Ws:1})}),{fixed:r,values:s}}function sr(n,e){
return e?n.map((t,r)=>e.fixed[r]?e.values[r]:t):n}function zs(n,e,t){if(e.kind==="rating"||t.kind==="rating")return n;let r=new Float32Array(Ee(t)),s=gt(e),o=gt(
t),a=Math.floor(t.fov/2)-Math.floor(e.fov/2),i=c=>c>=0&&c<t.fov,l=c=>{let m=Math.floor(c/e.fov**2),d=Math.floor(c/e.fov)%e.fov+a,h=c%e.fov+a;return i(d)&&i(h)?(m*
t.fov+d)*t.fov+h:-1};return s.forEach((c,m)=>{let d=o[m],h=e.hidden[m]??5;for(let p=0;p<(m?e.hidden[m-1]:c.inputs);p++){let f=m?p:l(p);if(!(f<0))for(let y=0;y<h;y++)
r[d.at+f*d.outputs+y]=n[c.at+p*c.outputs+y]}for(let p=0;p<h;p++)r[d.at+d.inputs*d.outputs+p]=n[c.at+c.inputs*c.outputs+p]}),sr(r.map(c=>c<=Ws/2?0:c),rr(t))}function Gs(n,e,t,r){let s=n.length,o=Math.max(...n)+1,a=o>1?s/o:1,i=Array.from(n.keys()).sort((d,h)=>n[d]-n[h]),l=[],c=[];for(let d=0;d<e;d++){let h=d%a;h===0&&
(c=Array.from(r.permutation(s/a)).flatMap(p=>i.slice(p*a,(p+1)*a))),l.push([i,c.map((p,f)=>c[f-f%a+(f%a-h+a)%a])])}let m=d=>i.map(()=>s+d);for(let d=0;d<t[1];d++)
l.push([i,m(d)]);for(let d=0;d<t[0];d++)l.push([m(d),i]);return{pursuer:Int32Array.from(l.flatMap(([d])=>d)),evader:Int32Array.from(l.flatMap(([,d])=>d)),group:Int32Array.
from(l.flatMap((d,h)=>i.map(p=>h*o+n[p])))}}function Bs(n,e,t,r){let s=Math.max(...e)+1,o=new Float64Array(t*s),a=new Float64Array(t*s);r.forEach((l,c)=>{if(n[c]>=
t)return;let m=n[c]*s+e[c];o[m]+=l,a[m]+=1});let i=o.map((l,c)=>a[c]?l/a[c]:0);return Float64Array.from({length:t},(l,c)=>{let m=i.subarray(c*s,(c+1)*s);return or(
m)/a.subarray(c*s,(c+1)*s).filter(Boolean).length})}var cl=128,Ue=8;function or(n){let{length:e}=n;if(e>cl){let h=Math.floor(e/2)-Math.floor(e/2)%Ue;return or(n.
subarray(0,h))+or(n.subarray(h))}if(e<Ue)return n.reduce((h,p)=>h+p,0);let t=n.slice(0,Ue),r=e-e%Ue;for(let h=Ue;h<r;h++)t[h%Ue]+=n[h];let[s,o,a,i,l,c,m,d]=t;return n.
subarray(r).reduce((h,p)=>h+p,s+o+(a+i)+(l+c+(m+d)))}function js({inputs:n},e){return(r=>typeof r[0]!="string")(n)?n[e==="pursuer"?0:1]:n}var ul=.2,Vs=({world:n})=>n.rules.teammate==="REACH"?ul:0;var Gt={pursuer:["random","clumsy-fleer"],evader:["random","clumsy-chaser"]},dl=20,ml=8,hl=-1;function Bt({world:n,policy:e},t,r){return e.kind==="rating"?{...e,
inputs:js(e,r)}:{kind:"cells",fov:n.fov,hidden:e.hidden,mask:e.mask==="none"?null:t[r]}}var He=class{settings;epochs=0;until=1/0;archive={pursuer:[],evader:[]};rows=[];cells=new Map;counters={
pursuer:[],evader:[]};#e;#n;#t;#r={};#a=new Set;#s={pursuer:0,evader:0};#l=0;#d=0;#m=0;constructor(e,t,r,s=Ds(t.seed)){this.#e=e,this.settings=t,this.#n=r,this.#t=
s;for(let o of M){let a=s("initial",M.indexOf(o)),i=t.learner.kind==="ga"?t.learner.population:1,l=Array.from({length:i},()=>Hs(this.shape(o),a,t.policy));this.#c(
o,l),this.archive[o].push(this.#r[o].genome)}this.#y(...M)}shape(e){return Bt(this.settings,this.#n,e)}get finished(){return Math.min(this.archive.pursuer.length,
this.archive.evader.length)}*run(){this.finished===1&&(yield*this.#x(0));for(let e=this.finished;e<=this.settings.schedule.generations;e++){if(this.settings.schedule.
kind==="alternating")for(let t of M)yield*this.#f(t,e),this.#y(t);else yield*this.#o(e),this.#y(...M);yield*this.#x(e)}}change(e){let t=this.settings,r={pursuer:this.
shape("pursuer"),evader:this.shape("evader")},s=l=>JSON.stringify(l(t))===JSON.stringify(l(e));this.settings=e;let o=s(l=>[l.world.fov,l.policy]);if(!o||!s(l=>l.
learner))for(let l of M){let c=m=>zs(m,r[l],this.shape(l));this.archive[l]=this.archive[l].map(c),this.#c(l,this.#p(l).map(c))}if(o&&s(l=>l.world))return null;this.
cells.clear(),this.#a.clear();let{pursuer:a,evader:i}=this.archive;return{type:"anew",settings:e,genomes:{pursuer:a.slice(0,this.finished),evader:i.slice(0,this.
finished)}}}#p(e){let t=this.#r[e];if(!(t instanceof ft))return[t.genome];let r=t.genome.length,s=Array.from({length:t.population.length/r},(o,a)=>t.population.
slice(a*r,(a+1)*r));return Array.from({length:this.settings.learner.population},(o,a)=>a===0?t.genome:s[a%s.length])}#c(e,t){let{learner:r}=this.settings,s=this.
shape(e),o=r.kind==="ga"?r.mutation:r.sigma,a=rr(s),i=new Ut(Ee(s),this.#t("noise",M.indexOf(e)),o,a?.fixed??null),l=t.map(c=>sr(c,a));this.#r[e]=r.kind==="ga"?
new ft(zt(l),i,r):new Ht(l[0],i,r)}*#f(e,t){this.#s[e]>=this.archive[te(e)].length-1&&(this.#s[e]=0);for(let r=0;r<this.#g(e);r++){for(;this.epochs>=this.until;)
yield{type:"rest"};let s=this.archive[te(e)].length,o=this.settings.schedule[`${e}s_meet`],a=o==="latest"?s-1:o==="round-robin"?this.#s[e]%s:this.#t("opponents",
M.indexOf(e),t,r).choice(s,1)[0];this.#s[e]++;let i=e==="pursuer"?[t,a]:[a,t],l=this.#r[e],{groups:c}=l,m=pt([this.settings.seed,...i,Xn[e],r],Math.max(...c)+1),
d=l.ask(this.#t("learn",M.indexOf(e),t,r)),h=Int32Array.from(c.keys()),p=new Int32Array(c.length),f={[e]:d,[te(e)]:this.archive[te(e)][a]},y={[e]:h,[te(e)]:p},g=this.#v(
f,y,BigUint64Array.from(c,b=>m[b])),v=this.#w(g,e);this.#M(g,v,{generation:t,team:e,epoch:r,opponent:a}),l.tell(v),yield*this.#h(t,r,e)}this.archive[e].push(this.#r[e].
genome)}*#o(e){for(let t=0;t<this.#g("pursuer");t++){for(;this.epochs>=this.until;)yield{type:"rest"};let{schedule:r,learner:{population:s}}=this.settings,[o,a]=r.
kind==="hall-of-fame"?[r.hall_sample,r.contemporaries]:[0,1],i={pursuer:this.#u("pursuer",e,t),evader:this.#u("evader",e,t)},l=this.#t("opponents",0,e,t),c={pursuer:this.#i(
o,l),evader:this.#i(o,l)},m=g=>zt([i[g],...Array.from(c[te(g)],v=>this.archive[g][v])]),d=[c.evader.length,c.pursuer.length],h=Gs(this.#r.pursuer.groups,a,d,l),
p=pt([this.settings.seed,e,e,Xn.both,t],Math.max(...h.group)+1),f={pursuer:m("pursuer"),evader:m("evader")},y=this.#v(f,h,BigUint64Array.from(h.group,g=>p[g]));
for(let g of M){let v=Bs(h[g],h[te(g)],s,this.#w(y,g));this.#M(y,v,{generation:e,team:g,epoch:t,opponent:hl}),this.#r[g].tell(v)}yield*this.#h(e,t,"both")}for(let t of M)
this.archive[t].push(this.#r[t].genome)}#u(e,t,r){return this.#r[e].ask(this.#t("learn",M.indexOf(e),t,r))}#i(e,t){let r=this.archive.pursuer.length;return e?t.
choice(r,Math.min(e,r)):new Int32Array(0)}#g(e){let{schedule:t}=this.settings;return t.kind==="hall-of-fame"?t.joint_epochs:t[`${e}_epochs`]}*#h(e,t,r){let[s,o]=this.
settings.schedule.kind==="hall-of-fame"?[this.#g("pursuer"),0]:[this.#g("pursuer"),this.#g("evader")],a=t+1+(r==="evader"?s:0),i=s+o;this.epochs+=1,yield{type:"\
epoch",done:(e-1)*i+a,of:this.settings.schedule.generations*i},yield*this.catchUp()}#v(e,t,r){let s={...this.settings.world,max_steps:this.settings.train_steps},
o=this.#e.rollouts(s,this.#b("pursuer",e.pursuer),this.#b("evader",e.evader),{...t,seed:r},1);this.#l+=o.length.length;for(let a of o.length)this.#d+=Number(a);
for(let a of o.agent_steps)this.#m+=Number(a);return o}#b(e,t){return yt(this.shape(e),t)}#w({captured_fraction:e,overlap:t},r){let s=Vs(this.settings);return Float64Array.
from(e,(o,a)=>r==="pursuer"?o:1-o-s*Number(t[2*a+1]))}#M(e,t,r){let s=E(t),o=[0,0];e.faults.forEach((a,i)=>o[Math.floor(i/3)%2]+=Number(a)),this.rows.push({...r,
fitness_mean:s,fitness_std:Math.sqrt(E(t.map(a=>(a-s)**2))),fitness_best:Math.max(...t),capture_rate:E(e.capture_rate),length:E(e.length),pursuer_faults:o[0]/e.
length.length,evader_faults:o[1]/e.length.length,matches:this.#l,steps:this.#d})}#y(...e){for(let t of e)this.counters[t].push({matches:this.#l,steps:this.#d,agent_steps:this.#m})}*#x(e){
yield{type:"generation",number:e,genomes:{pursuer:this.archive.pursuer[e],evader:this.archive.evader[e]}},yield*this.catchUp()}*catchUp(){for(let e=this.finished-
1;e>=0;e--){for(let t=e;t>=0;t--)for(let[r,s]of t===e?[[e,e]]:[[e,t],[t,e]]){if(this.cells.has(`${r} ${s}`))continue;let o=this.#S(r,s);this.cells.set(`${r} ${s}`,
o),yield{type:"cell",cell:o}}this.#a.has(e)||(this.#a.add(e),yield{type:"scores",number:e,scores:{pursuer:this.#A("pursuer",e),evader:this.#A("evader",e)}})}}#S(e,t){
let{world:r,evaluation_episodes:s,seed:o}=this.settings,a={pursuer:new Int32Array(1),evader:new Int32Array(1),seed:BigUint64Array.of(Wt(o,e,t))},i=M.map(m=>this.#b(
m,this.archive[m][m==="pursuer"?e:t])),l=this.#e.rollouts(r,...i,a,s),c=m=>{let d=Array.from(l[m],Number),h=d.length/s;return Array.from({length:h},(p,f)=>E(d.filter(
(y,g)=>g%h===f)))};return{pursuer:e,evader:t,capture_rates:Array.from(l.capture_rate),lengths:Array.from(l.length),means:{collisions:c("collisions"),faults:c("f\
aults"),agent_steps:c("agent_steps"),survivors:c("survivors")}}}#A(e,t){let{world:r,seed:s}=this.settings,o=this.#b(e,this.archive[e][t]),a=new Int32Array(1);return E(
Gt[e].map((i,l)=>{let c=pt([s,M.indexOf(e),l,ml],1),m=e==="pursuer"?[o,i]:[i,o],d=E(this.#e.rollouts(r,...m,{pursuer:a,evader:a,seed:c},dl).capture_rate);return e===
"pursuer"?d:1-d}))}};function zt(n){let e=new Float32Array(n.reduce((r,{length:s})=>r+s,0)),t=0;for(let r of n)e.set(r,t),t+=r.length;return e}var pl=12,jt=class{#e=null;#n=null;#t=[];#r;constructor(e,t){this.#r=t;try{let r=new Blob([ue("script-engine"),`
`,ue(`script-${e}`)],{type:"text/javascript"});this.#n=new Worker(URL.createObjectURL(r)),this.#n.onerror=()=>this.#e||this.#a(),this.#n.onmessage=()=>this.#s(this.#n)}catch{
this.#a()}}send(e){this.#e?this.#e.postMessage(e):this.#t.push(e)}close(){this.send({type:"stop"}),this.#n?.terminate()}#a(){let{port1:e,port2:t}=new MessageChannel;
ar(t),this.#s(e)}#s(e){this.#e=e,e.onmessage=({data:t})=>t.type!=="ready"&&this.#r(t);for(let t of this.#t.splice(0))e.postMessage(t)}};function ar(n){let e=v=>n.
postMessage(v),t=Ft(),r=null,s=null,o=null,a=[],i=!1,l=0,c=!1,m=new MessageChannel,d=v=>{let b=r.change(v);e({type:"changed",at:r.epochs,settings:v}),b&&e(b),!s&&
r.finished<=v.schedule.generations?(s=r.run(),i=!0):i||(o=r.catchUp())},h=()=>{i=!1,o=r.catchUp(),e({type:"stopped",at:r.epochs})},p=()=>{if(i&&s){for(;a.length&&
a[0].at<=r.epochs;)d(a.shift().settings);let{value:b,done:x}=s.next();return x?(s=null,i=!1,o=r.catchUp(),e({type:"end",at:r.epochs,seconds:l/1e3})):b.type==="r\
est"?h():e(b),!0}let v=o?.next();return v&&!v.done?e(v.value):o=null,!!o},f=()=>{let v=performance.now(),b=!0;for(;b&&performance.now()<v+pl;)b=p();l+=performance.
now()-v,!(!b||c)&&(c=!0,m.port2.postMessage(null))},y=async v=>{if(v.type==="start")r=new He(await t,v.settings,v.masks),s=r.run(),o=null,a=[...v.plan],i=!0,l=0,
r.until=v.until,e({type:"began"});else if(r)if(v.type==="change")a=[],r.until=1/0,d(v.settings);else if(v.type==="go")r.until=1/0,i=!0;else if(v.type==="stop")i&&
h();else{let{settings:b,archive:x,rows:T,cells:A,counters:$,finished:_}=r;e({type:"saved",race:{settings:b,archive:x,rows:T,cells:A,counters:$,finished:_}})}else
return;f()},g=v=>{Promise.resolve().then(v).catch(b=>{s=o=null,e({type:"failed",message:String(b)})})};m.port1.onmessage=()=>{c=!1,g(f)},n.onmessage=({data:v})=>g(
()=>y(v)),e({type:"ready"})}var fl="http://www.w3.org/2000/svg";function u(n,e={},...t){return qs(document.createElement(n),e,t)}function w(n,e={},...t){return qs(document.createElementNS(
fl,n),e,t)}function qs(n,e,t){for(let[s,o]of Object.entries(e))o==null||o===!1||(typeof o=="function"?n.addEventListener(s.slice(2),o):n.setAttribute(s,o===!0?"":
String(o)));let r=t.filter(s=>s!=null&&s!==!1);return n.append(...r.map(s=>typeof s=="number"?String(s):s)),n}function Ks(n,e){let t=u("select",{onchange:()=>e(
t.value)},...n.map(([r,s])=>u("option",{value:r},s)));return t}async function ir(n){try{await n}catch(e){let t=document.querySelector("#page, main")??document.body;
throw t.querySelector(".absent")?.remove(),t.prepend(u("p",{class:"card problem",role:"alert"},e instanceof WebAssembly.CompileError||/WebAssembly/.test(String(
e))?"This page plays by WebAssembly, which is forbidden where it lies ('wasm-unsafe-eval' is missing in the content policy): save the file, and open it from you\
r disk.":`The page could not start: ${String(e)}`)),e}finally{document.body.dataset.ready="true"}}function Vt(n,e){let t=URL.createObjectURL(new Blob([e],{type:"application/octet-stream"}));u("a",{href:t,download:n}).click(),setTimeout(()=>URL.revokeObjectURL(
t),6e4)}var Ys=()=>document.documentElement.dataset.theme==="dark";function vt(n){document.documentElement.dataset.theme=n?"dark":"light"}var gl=()=>vt(!Ys());if(typeof document<
"u"){let n=matchMedia("(prefers-color-scheme: dark)");n.addEventListener("change",()=>vt(n.matches)),vt(n.matches);let e=!1;addEventListener("beforeprint",()=>{
e=Ys(),vt(!1)}),addEventListener("afterprint",()=>vt(e))}function Zs(){return u("button",{type:"button",title:"Light or dark (D)","aria-label":"Light or dark",onclick:gl},
"◐")}var qt=(n,e,...t)=>u("header",{class:"top"},u("div",{},u("h1",{},n),e?u("p",{class:"lead"},e):null),u("div",{class:"tools"},...t,Zs()));var Kt=n=>n!==void 0&&"predict"in n,Yt=({sections:n})=>new Map(n.flatMap(({parts:e})=>e.filter(Kt).map(t=>[t.predict,t]))),Js=()=>JSON.parse(ue("data"));var re=[[0,0],[-1,0],[0,1],[1,0],[0,-1],[-1,1],[1,1],[1,-1],[-1,-1]];var Ce=(n,e)=>e<n.nPursuers,N=(n,e)=>[n.positions[2*e],n.positions[2*e+1]],Oe=({rows:n,cols:e},[t,r])=>t>=0&&r>=0&&t<n&&r<e,lr=(n,e,t=3)=>n!==void 0&&[0,1,2].slice(
0,t).some(r=>n[3*e+r]),cr=(n,e)=>lr(n.fault,e),Xs=(n,e)=>!cr(n,e)&&lr(n.involved,e,2);function Zt(n,e,t){let r=N(n,t),s=N(e,t),o=r[0]!==s[0]||r[1]!==s[1],a=e.involved===
void 0||lr(e.involved,t);return!!(e.alive[t]&&e.actions?.[t]&&!o&&a)}function Jt(n,e,t){let[r,s]=N(n,t),[o,a]=re[e.actions?.[t]??0];return[r+o,s+a]}function bt(n,e,t){
return Array.from({length:t.everCaptured.length},(s,o)=>o).filter(s=>t.everCaptured[s]&&!e.everCaptured[s]).map(s=>n.nPursuers+s)}var Xt=n=>n.moments.flatMap((e,t)=>t&&
bt(n,n.moments[t-1],e).length?[t]:[]);function Qt(n,e){return Array.from({length:e.alive.length},(r,s)=>s).filter(r=>n.alive[r]&&!e.alive[r])}var Qs=[-.31,0,.31],eo=[{size:1,at:[[0,0]]},{size:.62,at:[[-.2,.2],[.2,-.2]]},{size:.54,at:[[-.23,.22],[.23,.22],[0,-.22]]},{size:.54,at:[[-.23,.23],[.23,.23],[
-.23,-.23],[.23,-.23]]},{size:.36,at:Qs.flatMap(n=>Qs.map(e=>[e,n]))}],yl=.3,vl=.35,bl=.55;function wt(n,e){let t=new Map;for(let r=0;r<e.alive.length;r++){if(!e.
alive[r])continue;let[s,o]=N(e,r),a=s*n.cols+o,i=t.get(a);i?i.push(r):t.set(a,[r])}return t}function to(n,e){let t=Array.from(e.alive,(r,s)=>{let[o,a]=N(e,s);return{
x:a+.5,y:o+.5,size:1,alpha:0}});for(let r of wt(n,e).values()){let s=eo[Math.min(r.length,eo.length)-1];r.forEach((o,a)=>{let[i,l]=s.at[Math.min(a,s.at.length-1)],
c=t[o];c.x+=i,c.y+=l,c.size=s.size,c.alpha=1})}return t}var no=n=>n*n*(3-2*n),ze=(n,e,t)=>n+(e-n)*t,ro=n=>Math.min(1,Math.max(0,n));function so(n,e,t,r){let s={
SIMULTANEOUS:1,SWARM_TURNS:2,AGENT_TURNS:t}[n.interaction];if(s===1)return no(r);let o=s===t?e:+!Ce(n,e),a=Math.max(1/s,vl);return no(ro((r-o/(s-1)*(1-a))/a))}function en(n,e){
let t=n.moments.length-1,r=Math.min(Math.floor(e),t),s=n.moments[r],o=to(n,s);if(r===t||e===r)return o;let a=n.moments[r+1],i=to(n,a);return o.map((l,c)=>{let m=so(
n,c,o.length,e-r);return wl(s,a,c,l,i[c],m)})}function ur(n,e,t){let r=n.moments.length-1,s=Math.min(Math.floor(t),r),o=n.moments[s],a=n.moments[Math.min(s+1,r)],
i=so(n,e,o.alive.length,t-s),[l,c]=N(o,e),[m,d]=N(a,e);return[ze(c,d,i)+.5,ze(l,m,i)+.5]}function wl(n,e,t,r,s,o){let a=r.alpha>s.alpha,i={x:ze(r.x,s.x,o),y:ze(
r.y,s.y,o),size:a?r.size:ze(r.size,s.size,o),alpha:a?ro((1-o)/(1-bl)):ze(r.alpha,s.alpha,o)};if(Zt(n,e,t)){let[l,c]=N(n,t),[m,d]=Jt(n,e,t),h=yl*Math.sin(Math.PI*
o);i.x+=(d-c)*h,i.y+=(m-l)*h}return i}var oo=2*Math.PI;function X(n,e,t,r){n.beginPath(),n.arc(e,t,r/2,0,oo)}function Ge(n,e,t,r){let s=r/2,o=[[0,-.97],[.97,.83],[-.97,.83]].map(([a,i])=>[e+a*s,t+i*
s]);n.beginPath(),n.moveTo((o[2][0]+o[0][0])/2,(o[2][1]+o[0][1])/2),o.forEach(([a,i],l)=>{let[c,m]=o[(l+1)%3];n.arcTo(a,i,c,m,r*.09)}),n.closePath()}function tn(n,e,t,r){
let s=r*.32;n.beginPath(),n.moveTo(e-s,t-s),n.lineTo(e+s,t+s),n.moveTo(e+s,t-s),n.lineTo(e-s,t+s)}function ao(n,e,t,r){n.beginPath();for(let s=0;s<16;s++){let o=r/
2*(s%2?.6:.95),a=oo*s/16;n.lineTo(e+o*Math.sin(a),t-o*Math.cos(a))}n.closePath()}function io(n,e,t,r,s,o){let a=Math.atan2(s-t,r-e);n.beginPath(),n.moveTo(e,t),
n.lineTo(r,s);for(let i of[-1,1])n.moveTo(r,s),n.lineTo(r-o*Math.cos(a+i*.6),s-o*Math.sin(a+i*.6))}var lo=4,xl=1.6,Sl=.95,Ml=5,Al=.16,Tl=9,El=.09,Cl=.2,co=.75,L=(n,e)=>n.left+e*n.cell,F=(n,e)=>n.top+e*n.cell;function Be(n,e,t){return Ce(e,t)?n.colors.pursuer:
n.colors.evader}function nn({ctx:n,colors:e},t,r,s,o,a,i=0){n.font=`700 ${Math.round(o)}px system-ui, sans-serif`,n.textAlign="center",n.textBaseline="middle",n.
strokeStyle=e.paper,n.lineWidth=i,i&&n.strokeText(t,r,s),n.fillStyle=a,n.fillText(t,r,s)}function uo({ctx:n,grid:e,colors:t}){let{left:r,top:s,cell:o,rows:a,cols:i}=e,
l=i*o,c=a*o;if(n.fillStyle=t.paper,n.fillRect(r,s,l,c),o<Ml)return;n.fillStyle=t.line;let m=Math.max(1,Math.round(o/60));for(let d=1;d<i;d++)n.fillRect(r+d*o,s,
m,c);for(let d=1;d<a;d++)n.fillRect(r,s+d*o,l,m)}function mo({ctx:n,grid:e,colors:t},r){let{left:s,top:o,cell:a,rows:i,cols:l}=e;n.fillStyle=t.obstacle;for(let c=0;c<
i*l;c++){if(!r.obstacles[c])continue;let m=Math.floor(c/l),d=c%l;n.fillRect(s+d*a,o+m*a,a,a)}ho({ctx:n,grid:e,colors:t})}function ho({ctx:n,grid:{left:e,top:t,cell:r,
rows:s,cols:o},colors:a}){let i=Math.min(5,Math.max(2,Math.round(r/18)));n.strokeStyle=a.frame,n.lineWidth=i,n.strokeRect(e-i/2,t-i/2,o*r+i,s*r+i)}function po({
ctx:n,grid:e,colors:t},r){let{left:s,top:o,cell:a,rows:i,cols:l}=e,c=a<24*r?5:1;n.font=`500 ${Math.round(Math.min(15*r,Math.max(9*r,a*.32)))}px system-ui, sans-\
serif`,n.fillStyle=t.muted,n.textBaseline="alphabetic",n.textAlign="center";let m=5*r+a/40;for(let d=0;d<l;d+=c)n.fillText(String(d),s+(d+.5)*a,o-m);n.textAlign=
"right",n.textBaseline="middle";for(let d=0;d<i;d+=c)n.fillText(String(d),s-m,o+(d+.5)*a)}function fo({grid:n},e,t,r){let s=Math.floor(e.fov/2)+.5,o=Math.max(0,
t-s),a=Math.min(n.cols,t+s),i=Math.max(0,r-s),l=Math.min(n.rows,r+s);return[L(n,o),F(n,i),(a-o)*n.cell,(l-i)*n.cell]}function go(n,e,t,r){let{ctx:s,grid:o,colors:a}=n;
s.save(),s.beginPath(),s.rect(0,0,s.canvas.width,s.canvas.height),s.rect(...fo(n,e,t,r)),s.clip("evenodd"),s.clearRect(0,0,s.canvas.width,s.canvas.height),s.fillStyle=
a.line,s.fillRect(o.left,o.top,o.cols*o.cell,o.rows*o.cell),s.restore(),ho(n)}function yo(n,{x:e,y:t,alpha:r},s){let{ctx:o,grid:a,colors:i}=n,l=Math.max(a.cell,
16*s)*1.06,c=L(a,e),m=F(a,t);o.globalAlpha=Math.max(r,.6),o.beginPath(),o.roundRect(c-l/2,m-l/2,l,l,l*.2),o.strokeStyle=i.focus,o.lineWidth=Math.max(2,2.5*s),o.
stroke();let d=Math.max(11*s,Math.min(18*s,a.cell*.5)),h=m-l/2<d*1.2,p=m+(h?1:-1)*(l/2+d*.7);o.lineJoin="round",nn(n,"You",c,p,d,i.ink,d*.35),o.globalAlpha=1}function vo(n,e,t,r,s){
let{ctx:o,grid:a}=n,i=fo(n,e,r,s),l=Be(n,e,t);o.globalAlpha=.11,o.fillStyle=l,o.fillRect(...i),o.globalAlpha=.8,o.strokeStyle=l,o.lineWidth=Math.max(1,a.cell/24),
o.strokeRect(...i),o.globalAlpha=1}function bo(n,e,t,r,s){let{ctx:o,grid:a}=n,i=Math.min(Math.ceil(t),e.moments.length-1),l=e.moments[i];o.lineCap="round",o.lineWidth=
Math.min(Tl,Math.max(1,a.cell*Al));for(let c=Math.max(1,Math.floor(t-r)+1);c<=i;c++){let m=e.moments[c-1],d=e.moments[c],h=Math.max(0,Math.min(1,(t-c)/r));o.globalAlpha=
co+(Cl-co)*h;for(let p=0;p<d.alive.length;p++){let f=c===i&&t<i;if(!m.alive[p]||!(l.alive[p]||f))continue;let y=(Ce(e,p)?-1:1)*El,[g,v]=N(m,p),[b,x]=N(d,p);if(g===
b&&v===x)continue;let T=f?s[p].x:x+.5,A=f?s[p].y:b+.5;o.strokeStyle=Be(n,e,p),o.beginPath(),o.moveTo(L(a,v+.5+y),F(a,g+.5+y)),o.lineTo(L(a,T+y),F(a,A+y)),o.stroke()}}
o.globalAlpha=1}function wo(n,e,t){let r=Math.min(Math.ceil(t),e.moments.length-1);for(let s=Math.max(1,r-lo+1);s<=r;s++){let o=e.moments[s-1],a=e.moments[s],i=s>
t?Math.max(0,1-2*(s-t)):1-(t-s)/lo,l=bt(e,o,a);for(let c of Qt(o,a))l.includes(c)||kl(n,N(a,c),i);for(let c of l)Ol(n,N(a,c),i)}n.ctx.globalAlpha=1}function Ol({
ctx:n,grid:e,colors:t},[r,s],o){n.globalAlpha=o,ao(n,L(e,s+.5),F(e,r+.5),Math.max(8,e.cell*xl)),n.fillStyle=t.capture,n.fill(),n.strokeStyle=t.ink,n.lineWidth=Math.
max(1,e.cell/36),n.lineJoin="round",n.stroke()}function kl({ctx:n,grid:e,colors:t},[r,s],o){n.globalAlpha=o,tn(n,L(e,s+.5),F(e,r+.5),Math.max(7,e.cell*Sl)),n.strokeStyle=
t.collision,n.lineWidth=Math.max(2,e.cell*.17),n.lineCap="round",n.stroke()}function xo({ctx:n,grid:e,colors:t},r,s){let o=Math.max(1,e.cell*.07);n.strokeStyle=
n.fillStyle=t.collision,n.lineWidth=Math.max(1,e.cell*.05),n.setLineDash([e.cell*.14,e.cell*.1]);for(let[a,i]of r){if(a<0||i<0||a>=e.rows||i>=e.cols)continue;let l=[
L(e,i)+o,F(e,a)+o,e.cell-2*o,e.cell-2*o];n.globalAlpha=.2*s,n.fillRect(...l),n.globalAlpha=s,n.strokeRect(...l)}n.setLineDash([]),n.globalAlpha=1}function So({ctx:n,
grid:e,colors:t},r,s,o,a){n.globalAlpha=a,X(n,L(e,r),F(e,s),Math.max(8,e.cell*o*1.02)),n.strokeStyle=t.collision,n.lineWidth=Math.max(1.5,e.cell*.085*Math.sqrt(
o)),n.stroke(),n.globalAlpha=1}var Rl=.8,Pl=.92,$l=15,_l=7,dr=9;function Mo(n,e,t,r,s,o){r.forEach((a,i)=>{a.alpha>0&&Il(n,e,t,i,a,s,o)}),n.ctx.globalAlpha=1;for(let a of wt(e,t).values())a.length>
dr&&Nl(n,r[a[dr-1]],a.length-dr+1)}function Il(n,e,t,r,s,o,a){let{ctx:i,grid:l,colors:c}=n,m=Ce(e,r),d=L(l,s.x),h=F(l,s.y),p=Math.max(4,l.cell*s.size*(m?Pl:Rl)),
f=Be(n,e,r),y=!m&&!!t.captured[r-e.nPursuers];if(i.globalAlpha=s.alpha,(m?Ge:X)(i,d,h,p),p>_l*a&&(i.strokeStyle=c.paper,i.lineWidth=Math.max(2,p*.1),i.stroke()),
i.fillStyle=y?c.paper:f,i.fill(),y&&(X(i,d,h,p*.82),i.strokeStyle=f,i.lineWidth=p*.18,i.stroke()),!o||p<$l*a)return;let g=String(m?r:r-e.nPursuers),v=p*(m?.4:.5)*
(g.length>1?.8:1);nn(n,g,d,h+p*(m?.17:.03),v,y?f:c.paper)}function Nl(n,e,t){let{cell:r}=n.grid;nn(n,`+${t}`,L(n.grid,e.x),F(n.grid,e.y),r*.3,n.colors.ink,r*.1)}var Ll=.46,Fl=.86,Dl=.66,Ao=.48,Wl=.78,Ul=.58;function To(n,e,t,r){let s=e.moments[t-1],o=e.moments[t];if(!s)return;let{ctx:a,grid:i,colors:l}=n;a.strokeStyle=l.
collision,a.lineWidth=Math.max(1.5,i.cell*.07),a.lineCap="butt",a.globalAlpha=r;for(let c=0;c<o.alive.length;c++)Zt(s,o,c)&&Hl(n,e,N(s,c),Jt(s,o,c));a.globalAlpha=
1}function Hl({ctx:n,grid:e},t,r,s){let o=s[1]-r[1],a=s[0]-r[0],i=d=>L(e,r[1]+.5+o*d),l=d=>F(e,r[0]+.5+a*d),c=Oe(t,s)?Wl:Ul;n.setLineDash([e.cell*.09,e.cell*.06]),
n.beginPath(),n.moveTo(i(Ao),l(Ao)),n.lineTo(i(c),l(c)),n.stroke(),n.setLineDash([]);let m=.17*e.cell/Math.hypot(o,a);n.beginPath(),n.moveTo(i(c)-a*m,l(c)+o*m),
n.lineTo(i(c)+a*m,l(c)-o*m),n.stroke()}function Eo(n,e,t,r,s,o){let a=re[o];if(!o||!a)return;let{ctx:i,grid:l,colors:c}=n,m=Oe(e,[r[0]+a[0],r[1]+a[1]])?Fl:Dl,d=Ll*
s.size,h=[L(l,s.x+a[1]*d),F(l,s.y+a[0]*d),L(l,s.x+a[1]*m),F(l,s.y+a[0]*m)],p=Math.max(1.5,l.cell*.085);i.lineCap=i.lineJoin="round";for(let[f,y]of[[c.paper,p*2.1],
[Be(n,e,t),p]])i.strokeStyle=f,i.lineWidth=y,io(i,...h,l.cell*.2),i.stroke()}var zl=.04,Co=.3,Gl=.36,Bl=.13,Oo=.62,rn=.94;function Ro(n,e,t){let{ctx:r,grid:s,colors:o}=n,{cell:a}=s,i=y=>L(s,y[1]+.5),l=y=>F(s,y[0]+.5),c=Math.max(1.5,a*.06),
m=y=>Oe(e,y);r.lineCap="round";for(let[y,g]of[[t.escape,o.evader],[t.held,o.pursuer]]){r.fillStyle=g,r.globalAlpha=.28;let v=a*(1-2*zl);for(let b of y.filter(m))
r.fillRect(i(b)-v/2,l(b)-v/2,v,v)}r.globalAlpha=1,r.lineWidth=c,r.fillStyle=r.strokeStyle=o.ink;let{sides:d,openSide:h,wall:p,to:f}=t;if(d){let[y,...g]=d;for(let v of g)
r.beginPath(),r.moveTo(i(y),l(y)),r.lineTo(i(v),l(v)),r.stroke()}if(p){let[y,g]=[Math.sign(p[0]-f[0]),Math.sign(p[1]-f[1])],[v,b]=[i(p)-g*a/2,l(p)-y*a/2],x=.3*a;
r.setLineDash([c,c*2]),r.beginPath(),r.moveTo(i(f),l(f)),r.lineTo(v,b),r.stroke(),r.setLineDash([]),r.beginPath(),r.moveTo(v-y*x,b-g*x),r.lineTo(v+y*x,b+g*x),r.
stroke()}for(let y of t.exits.filter(m)){let[g,v]=[i(y)-i(f),l(y)-l(f)];X(r,i(f)+Oo*g,l(f)+Oo*v,Math.max(3,a*Bl)),r.fill()}h&&(jl(r,i(h),l(h),a*Gl),r.stroke()),
r.setLineDash([a*.12,a*.08]),r.strokeRect(i(f)-a*rn/2,l(f)-a*rn/2,a*rn,a*rn),r.setLineDash([])}function Po({ctx:n,grid:e,colors:t},r,s){let{cell:o}=e,a=d=>L(e,d[1]+
.5),i=d=>F(e,d[0]+.5),l=Math.max(3,o*.14),c=Math.max(1.5,o*.07),m=d=>{for(let[h,p]of[[t.paper,l],[t.ink,c]])n.strokeStyle=h,n.lineWidth=p,d(),n.stroke()};n.lineCap=
"round";for(let d of s.escape.filter(h=>Oe(r,h)))m(()=>X(n,a(d),i(d),o*Co));for(let d of s.held.filter(h=>Oe(r,h)))m(()=>tn(n,a(d),i(d),o*Co*1.4));n.setLineDash(
[o*.1,o*.08]);for(let{pursuer:d,cell:h}of s.moved)n.strokeStyle=d?t.pursuer:t.evader,n.lineWidth=c,(d?Ge:X)(n,a(h),i(h),o*.72),n.stroke();n.setLineDash([])}function jl(n,e,t,r){
n.beginPath(),n.moveTo(e,t-r),n.lineTo(e+r,t),n.lineTo(e,t+r),n.lineTo(e-r,t),n.closePath()}var ko=n=>["rect",{x:1,y:1,width:22,height:22,class:`tint-${n}`}],sn=n=>[
"path",{d:n,class:"sign"}],mr=(n,e)=>["circle",{cx:12,cy:12,r:n,class:e}],Vl={escapes:[["next cell of the evader that no pursuer reaches",ko("evader"),mr(5,"sig\
n")],["next cell that a pursuer reaches",ko("pursuer"),sn("M8 8l8 8m0-8l-8 8")]],opposite:[["two sides of the evader",sn("M3 20L12 5l9 15")]],open_side:[["neare\
st free side",sn("M12 3l9 9-9 9-9-9z")]],exits:[["way on",mr(4,"filled-sign")]],room:[["nearest obstacle",sn("M2 12h2m5 0h2m5 0h2M21 4v16")]]},ql=["an agent tha\
t has moved before",mr(8,"dashed-sign")],Kl="Inputs of a move: point at an agent, or choose it; then point at a cell beside it, tap it or press I for another mo\
ve.";function $o(n,e){let t=n.flatMap(r=>Vl[r]??[]);return t.length?[u("p",{class:"small muted"},Kl),u("ul",{class:"shapes small","aria-label":"Inputs of a move\
 on the board"},...[...t,...e?[ql]:[]].map(([r,...s])=>u("li",{},w("svg",{viewBox:"0 0 24 24","aria-hidden":"true"},...s.map(o=>w(...o))),r)))]:[]}var Io={numbers:!0,axes:!1,trail:6,viewers:[],plan:null,inputs:null,selected:null,cursor:null,you:null,fog:!1};function No(n,e,t,r,s){let{ctx:o,grid:a,colors:i}=n,
l=Math.min(Math.ceil(t),e.moments.length-1),c=e.moments[l],m=t===l,d=en(e,t),h=m?1:Math.max(0,1-2*(l-t));o.clearRect(0,0,o.canvas.width,o.canvas.height),uo(n);for(let g of r.
viewers)d[g]?.alpha&&vo(n,e,g,...ur(e,g,t));mo(n,e),r.axes&&po(n,s),bo(n,e,t,r.trail,d);let p=m?r.inputs:null;p&&Ro(n,e,p),xo(n,c.contested??[],h),wo(n,e,t),To(
n,e,l,h),d.forEach(({x:g,y:v,size:b},x)=>{let T=Xs(c,x)?.4:0,A=cr(c,x)?1:T;A&&So(n,g,v,b,A*h)});let f=m?c:e.moments[Math.max(0,l-1)];if(Mo(n,e,f,d,r.numbers,s),
p&&Po(n,e,p),m&&r.plan)for(let[g,v]of d.entries())v.alpha&&Eo(n,e,g,N(c,g),v,r.plan[g]??0);r.you!==null&&(r.fog&&go(n,e,...ur(e,r.you,t)),yo(n,d[r.you],s)),o.lineWidth=
Math.max(2,2.5*s),o.strokeStyle=i.focus;let y=r.selected===null?void 0:d[r.selected];y?.alpha&&_o(n,y.x,y.y,y.size*.96),r.cursor&&(o.setLineDash([a.cell*.12,a.cell*
.08]),_o(n,r.cursor[1]+.5,r.cursor[0]+.5,.8),o.setLineDash([]))}function _o({ctx:n,grid:e},t,r,s){let o=s*e.cell;n.beginPath(),n.roundRect(e.left+t*e.cell-o/2,e.
top+r*e.cell-o/2,o,o,o*.1),n.stroke()}var Lo=(n,e)=>(e+.24)/(n+.24);function Fo(n,e,t,r,s,o){let a=t?28*o:0,i=(c,m)=>(c-a)/(m+2*.12),l=Math.max(1,Math.floor(Math.min(i(r,e),i(s,n))));return{rows:n,cols:e,
cell:l,left:Math.round((r-e*l+a)/2),top:Math.round((s-n*l+a)/2)}}function Do(n,e,t){let r=Math.floor((t-n.top)/n.cell),s=Math.floor((e-n.left)/n.cell);return r>=
0&&r<n.rows&&s>=0&&s<n.cols?[r,s]:null}var Yl=["paper","line","frame","ink","muted","obstacle"],Zl=["pursuer","evader","capture","collision","focus"];function on(n){let e=getComputedStyle(n),t=(r,s)=>[
r,e.getPropertyValue(s+r).trim()];return Object.fromEntries([...Yl.map(r=>t(r,"--board-")),...Zl.map(r=>t(r,"--"))])}var ye=()=>matchMedia("(prefers-reduced-motion: reduce)").matches,je=class{canvas;#e=null;#n=0;#t;#r={rows:1,cols:1,left:0,top:0,cell:1};#a=0;constructor(e,t={}){
this.canvas=e,e.classList.add("board"),e.setAttribute("role","img"),this.#t={...Io,...t},new ResizeObserver(()=>this.#l()).observe(e),new MutationObserver(()=>this.
redraw()).observe(document.documentElement,{attributes:!0}),addEventListener("beforeprint",()=>this.drawNow())}set look(e){this.#t={...this.#t,...e},this.#s(),this.
redraw()}show(e,t){this.#e=e,this.#n=Math.min(Math.max(0,t),e.moments.length-1),this.#s(),this.redraw()}redraw(){this.#a||(this.#a=requestAnimationFrame(()=>this.
drawNow()))}drawNow(){cancelAnimationFrame(this.#a),this.#a=0;let e=this.canvas.getContext("2d");if(!e||!this.#e)return;let{rows:t,cols:r}=this.#e,s=devicePixelRatio||
1;this.#r=Fo(t,r,this.#t.axes,this.canvas.width,this.canvas.height,s);let o={ctx:e,grid:this.#r,colors:on(this.canvas)};No(o,this.#e,this.#n,this.#t,s)}cellAt(e,t){
let r=this.canvas.getBoundingClientRect(),s=this.canvas.width/r.width;return Do(this.#r,(e-r.left)*s,(t-r.top)*s)}agentAt(e,t){let r=this.cellAt(e,t);if(!r||!this.#e)
return null;let s=this.#e.moments[Math.round(this.#n)],o=wt(this.#e,s).get(r[0]*this.#e.cols+r[1])??[],a=en(this.#e,Math.round(this.#n)),i=l=>{let[c,m]=this.pointOf(
a[l].x,a[l].y);return Math.hypot(c-e,m-t)};return o.length?o.reduce((l,c)=>i(c)<i(l)?c:l):null}pointOf(e,t){let r=this.canvas.getBoundingClientRect(),s=r.width/
this.canvas.width,{left:o,top:a,cell:i}=this.#r;return[r.left+(o+e*i)*s,r.top+(a+t*i)*s]}#s(){if(!this.#e)return;let{rows:e,cols:t}=this.#e;this.canvas.style.setProperty(
"--board-aspect",String(Lo(e,t)))}#l(){let e=devicePixelRatio||1,{width:t,height:r}=this.canvas.getBoundingClientRect();this.canvas.width=Math.max(1,Math.round(
t*e)),this.canvas.height=Math.max(1,Math.round(r*e)),this.drawNow()}};var xt=[.5,1,2,4,8,16,32,64],an=0,ln=12,Jl=2,ve=class extends EventTarget{#e;#n;#t;#r=0;#a=0;#s=!1;#l=null;#d=0;#m=[];#p=[];glide=.28;constructor(e,{speed:t=4,still:r=!1}={}){
super(),this.#e=e,this.#n=t,this.#t=r}get step(){return this.#r}get time(){return this.#t?this.#r:this.#a}get arrived(){return this.#a===this.#r}get playing(){return this.#s}get length(){
return this.#e}set length(e){this.#e=e,this.#r>e&&this.jump(e),this.#i("state")}get marks(){return this.#m}set marks(e){this.#m=e,this.#i("state")}get ticks(){return this.#p}set ticks(e){
this.#p=e,this.#i("state")}get pace(){return this.#n||Math.max(Jl,this.#e/ln)}get speed(){return this.#n}set speed(e){this.#n=e,this.#i("state")}changeSpeed(e){
let t=xt.findIndex(r=>r>=this.pace);this.speed=xt[Math.min(xt.length-1,Math.max(0,t+e))]}play(){this.#s||!this.#e||(this.#r===this.#e&&this.jump(0),this.#s=!0,this.#i(
"state"),this.#f())}pause(){this.#s&&(this.#s=!1,this.#i("state"))}toggle(){this.#s?this.pause():this.play()}move(e){this.pause();let t=Math.min(this.#e,Math.max(
0,this.#r+e));Math.abs(t-this.#a)>1?this.jump(t):this.#c(t),this.#f()}jump(e){this.#a=Math.min(this.#e,Math.max(0,Math.round(e))),this.#c(this.#a),this.#i("fram\
e")}#c(e){e!==this.#r&&(this.#r=e,this.#i("step"),this.#t&&this.#i("frame"))}#f(){this.#l===null&&(this.#d=performance.now(),this.#l=requestAnimationFrame(()=>this.#o()))}#o(){
this.#l=null;let e=performance.now();this.#u(Math.min(.25,(e-this.#d)/1e3)),this.#d=e,(!this.#t||this.arrived)&&this.#i("frame"),(this.#s||this.#a!==this.#r)&&(this.#l=
requestAnimationFrame(()=>this.#o()))}#u(e){let t=e;for(;t>0;){if(this.#a===this.#r){if(!this.#s)return;if(this.#r===this.#e)return this.pause();this.#c(this.#r+
1)}let r=this.#s?this.pace:1/this.glide,s=this.#r-this.#a,o=Math.min(Math.abs(s),t*r);t-=o/r,this.#a=o===Math.abs(s)?this.#r:this.#a+Math.sign(s)*o}this.#s&&this.#a===
this.#e&&this.pause()}#i(e){this.dispatchEvent(new Event(e))}};function Wo(n,e){if(e.ctrlKey||e.metaKey||e.altKey)return!1;let t=e.shiftKey?10:1,s={" ":()=>n.toggle(),
ArrowRight:()=>n.move(t),ArrowLeft:()=>n.move(-t),Home:()=>n.move(-n.length),End:()=>n.move(n.length),"+":()=>n.changeSpeed(1),"-":()=>n.changeSpeed(-1)}[e.key];
return s?.(),s!==void 0}var Xl={first:"M6 5v14M19 5 9 12l10 7z",back:"M17 5 7 12l10 7z",play:"M7 4.5 19 12 7 19.5z",pause:"M8 5v14M16 5v14",forward:"M7 5l10 7-10 7z",last:"M18 5v14M5 5\
l10 7-10 7z"};function Uo(n){return w("svg",{viewBox:"0 0 24 24","aria-hidden":"true",class:"icon"},w("path",{d:Xl[n]}))}function St(n,e,t,r){return u("button",
{type:"button",class:"player-button","aria-label":e,title:`${e} (${t})`,onclick:r},Uo(n))}function Ve(n){let e=St("play","Play","Space",()=>n.toggle()),t=u("inp\
ut",{type:"range",class:"player-scrub",min:0,step:1,"aria-label":"Step",oninput:()=>{n.pause(),n.jump(Number(t.value))}}),r=u("div",{class:"captures","aria-hidd\
en":"true",title:"Captures"}),s=u("div",{class:"losses","aria-hidden":"true"}),o=u("select",{class:"player-speed","aria-label":"Speed",title:`Steps a second, or\
 the whole in ${ln} s (+ and -)`,onchange:()=>n.speed=Number(o.value)},u("option",{value:an},`in ${ln} s`),...xt.map(d=>u("option",{value:d},`${d} / s`))),a=u("\
output",{class:"player-count"}),i=u("div",{class:"player",role:"group","aria-label":"Player"},St("first","First step","Home",()=>n.move(-n.length)),St("back","S\
tep back","←",()=>n.move(-1)),e,St("forward","Step forward","→",()=>n.move(1)),St("last","Last step","End",()=>n.move(n.length)),u("div",{class:"scrub"},r,s,
t),a,o),l=(d,h={})=>{let p=u("i",h);return p.style.left=`${100*d/Math.max(1,n.length)}%`,p},c=()=>{r.replaceChildren(...n.marks.map(d=>l(d))),s.replaceChildren(
...n.ticks.map(({step:d,kind:h,size:p,text:f})=>{let y=l(d,{class:h,title:`Step ${d}: ${f}`});return y.style.height=`${100*p}%`,y}))},m=()=>{e.replaceChildren(Uo(
n.playing?"pause":"play")),e.ariaLabel=n.playing?"Pause":"Play",e.title=`${e.ariaLabel} (Space)`,t.max=String(n.length),t.value=String(n.step),t.ariaValueText=`\
step ${n.step} of ${n.length}`,a.textContent=`${n.step} / ${n.length}`,a.style.minWidth=`${2*String(n.length).length+3}ch`,o.value=String(n.speed)};return n.addEventListener(
"step",m),n.addEventListener("state",m),n.addEventListener("state",c),i.addEventListener("keydown",d=>{!(d.target instanceof HTMLSelectElement||d.key===" "&&d.target!==
t)&&Wo(n,d)&&d.preventDefault()}),m(),i}var P=(n,e=2)=>n==null?"-":n.toFixed(e);function Ho(n,e,t){return e===null||t===null?P(n):`${P(n)} (${P(e)} to ${P(t)})`}function qe(n){let e=Math.abs(n),t=e>=1e4?
e.toExponential(0):e.toFixed(e<100?2:0);return n<0&&Number(t)?`−${t}`:t}var de=n=>n.charAt(0).toUpperCase()+n.slice(1);function Mt(n,e,t,r=!1){let s=(e-n)/Math.max(1,t),o=10**Math.floor(Math.log10(s||1)),a=[1,2,5,10].map(c=>c*o).find(
c=>c>=s)??10*o;r&&(a=Math.max(1,Math.round(a)));let i=Math.ceil(n/a-1e-9),l=Math.floor(e/a+1e-9);return Array.from({length:Math.max(0,l-i+1)},(c,m)=>(i+m)*a)}var hr={right:12,top:10,bottom:42},cn={x:56,y:34,letter:8,label:30};function se(n,e,t,r){let{top:s}=hr,o=Math.max(s+40,e-hr.bottom),a=Mt(r.low,r.high,(o-s)/cn.y,
r.whole),i=cn.label+cn.letter*Math.max(2,...a.map(g=>pr(g).length)),l=Math.max(i+40,n-hr.right),c=(g,v,b)=>x=>v+(x-g.low)/(g.high-g.low||1)*(b-v),m=c(t,i,l),d=c(
r,o,s),h=w("g"),p=w("svg",{width:n,height:e,viewBox:`0 0 ${n} ${e}`,class:"plot"}),f=w("g",{class:"axes"});for(let g of a)f.append(w("line",{x1:i,x2:l,y1:d(g),y2:d(
g),class:"grid"}),w("text",{x:i-8,y:d(g),"text-anchor":"end","dominant-baseline":"middle"},pr(g)));for(let g of Mt(t.low,t.high,(l-i)/cn.x,t.whole))f.append(w("\
text",{x:m(g),y:o+16,"text-anchor":"middle"},pr(g)));return f.append(w("line",{x1:i,x2:l,y1:o,y2:o,class:"axis"}),w("text",{x:(i+l)/2,y:e-6,"text-anchor":"middl\
e",class:"label"},t.label),w("text",{transform:`translate(12 ${(s+o)/2}) rotate(-90)`,"text-anchor":"middle",class:"label"},r.label)),p.append(f,h),{root:p,marks:h,
left:i,right:l,top:s,bottom:o,x:m,y:d,at:g=>{let v=g-p.getBoundingClientRect().left;return t.low+(v-i)/(l-i)*(t.high-t.low)}}}var pr=n=>String(Number(n.toPrecision(
6))).replace("-","−");function oe(n,e,t,r){let s="",o="M";t.forEach((a,i)=>{a===null?o="M":(s+=`${o}${n.x(e[i]).toFixed(1)} ${n.y(a).toFixed(1)}`,o="L")}),n.root.
insertBefore(w("path",{d:s,class:`line ${r}`}),n.marks)}function zo(n,e,t,r=null){let s=n.x(e);n.marks.append(w("line",{x1:s,x2:s,y1:n.top,y2:n.bottom,class:`mark ${t}`})),r!==null&&n.marks.append(w("circle",{cx:s,cy:n.
y(r),r:5,class:`dot ${t}`}))}function Ke(...n){return u("p",{class:"legend small"},...n.map(([e,t])=>u("span",{class:`key ${t}`},e)))}function ae(n,e,t=()=>{},r=()=>{}){
let s=u("div",{class:"chart chooses",role:"img","aria-label":n}),o=null,a=()=>{o?.marks.replaceChildren(),o&&t(o)};s.addEventListener("click",l=>o&&r(o.at(l.clientX),
o,l));let i=()=>{let{clientWidth:l,clientHeight:c}=s;l<50||c<50||(o=e(l,c),s.replaceChildren(o.root),a())};return new ResizeObserver(i).observe(s),{element:s,update:a,
redraw:i}}var At=[[68,1,84],[72,26,108],[71,47,125],[65,68,135],[57,86,140],[49,104,142],[42,120,142],[35,136,142],[31,152,139],[34,168,132],[53,183,121],[84,197,104],[122,
209,81],[165,219,54],[210,226,27],[253,231,37]];function un(n){let e=Math.min(1,Math.max(0,n))*(At.length-1),t=Math.min(At.length-2,Math.floor(e)),r=At[t],s=At[t+
1],o=a=>Math.round(r[a]+(e-t)*(s[a]-r[a]));return[o(0),o(1),o(2)]}function Go(n){let[e,t,r]=un(n).map(s=>((s/255+.055)/1.055)**2.4);return .2126*e+.7152*t+.0722*
r>.179?"#000":"#fff"}var Bo=n=>`rgb(${un(n).join(" ")})`,jo=()=>`linear-gradient(to right, ${At.map(n=>`rgb(${n.join(" ")})`).join(", ")})`;function Ye(n,e,t){let r=devicePixelRatio||1;for(let[a,i]of Object.entries(t))n.style.setProperty(a,`${i}px`);n.width=Math.round(t.width*r),n.height=Math.round(
t.height*r);let s=n.getContext("2d"),o=Ql(e);!s||!o||(s.imageSmoothingEnabled=!1,s.drawImage(o,0,0,n.width,n.height))}function Ql(n){let[e,t]=n.shape,r=document.
createElement("canvas");r.width=t,r.height=e;let s=r.getContext("2d");if(!s)return null;let o=s.createImageData(t,e);return n.capture_rate.forEach((a,i)=>a.forEach(
(l,c)=>{let m=4*((e-1-i-n.first[0])*t+c+n.first[1]);o.data.set([...un(l),255],m)})),s.putImageData(o,0,0),r}function dn(n,e,t,r=2){n.textContent=P(e,r),n.ariaLabel=
`${t}: ${n.textContent}`,e!==void 0&&(n.style.backgroundColor=Bo(e),n.style.color=Go(e))}function me(n,e){let t=u("span",{class:"gradient"});return t.style.backgroundImage=
jo(),u("p",{class:"scale-of-rates small muted"},n,t,e)}function ke(n,e,t=n.length){let r=u("canvas",{role:"img","aria-label":e}),s=u("div",{class:"cells-of-matrix"},r),o=u("figure",{},u("figcaption",{},e),s,u("p",{class:"\
small muted"},u("span",{class:"pursuer"},"↑ pursuers")," ",u("span",{class:"evader"},"evaders →")));return o.draw=()=>{let a=s.clientWidth;a&&Ye(r,{shape:[t,
t],first:[0,0],capture_rate:n},{left:0,top:0,width:a,height:a})},new ResizeObserver(()=>o.draw?.()).observe(s),o}var qo=()=>me("0 all escape","1 all caught"),Ko=({
runs:n})=>u("div",{class:"widget"},u("div",{class:"matrices"},...n.map((e,t)=>ke(e.payoff.capture_rate,`Matrix ${"ABC"[t]}`))),qo()),mn=31,Vo=.016;function Yo(){
let n=t=>Array.from({length:mn},(r,s)=>Array.from({length:mn},(o,a)=>.5+t*(s-a))),e=[[Vo,"Both get better"],[-Vo,"Both get worse"],[0,"Nothing happens"]];return u(
"div",{class:"widget"},u("div",{class:"matrices"},...e.map(([t,r])=>ke(n(t),r))),qo())}function Zo(){let n=Array.from({length:mn},(t,r)=>r),e=ae("A capture rate\
 that stays at one half from generation 0 to 30",(t,r)=>{let s=se(t,r,{low:0,high:mn-1,label:"generation",whole:!0},{low:0,high:1,label:"capture rate"});return oe(
s,n,n.map(()=>.5),"of-both"),s},()=>{},()=>{});return u("div",{class:"widget"},e.element)}var ie=32,Jo=({crossings:n=[]})=>u("div",{class:"widget crossings"},...n.
map(e=>u("figure",{},u("figcaption",{},e.title),ec(e),u("p",{class:"small muted"},e.text))));function ec({title:n,text:e,ways:t}){let r=[0,1,2,3].map(s=>`M${s*ie}\
 0V${3*ie}M0 ${s*ie}H${3*ie}`).join("");return w("svg",{viewBox:`-1 -1 ${3*ie+2} ${3*ie+2}`,role:"img","aria-label":`${n}: ${e}`},w("path",{class:"grid",d:r}),...t.
map(([s,o,a],i)=>w("g",{transform:`translate(${1.5*ie} ${1.5*ie})`},w("g",{transform:`translate(${-ie*o} ${-ie*s})`},w("path",{class:"filled-pursuer",d:"M0 -12 \
12 9H-12z"}),w("text",{y:6.5,"text-anchor":"middle"},`P${i}`)),w("path",{class:a?"goes":"waits",d:a?"M-18 0H-5M-9 -4 -4 0 -9 4":"M-16 -13V13",transform:`rotate(${Math.
atan2(s,o)*180/Math.PI})`}))))}function Re(n,e,t,r,s){let o=u("input",{type:"range",min:0,max:e.length-1,step:1,"aria-label":n,oninput:()=>s(i())}),a=u("output",{class:"numbers"}),i=()=>{let l=e[Number(
o.value)];return a.textContent=o.ariaValueText=r(l),l};return o.value=String(e.indexOf(t)),i(),u("label",{class:"slider"},u("span",{},n),o,a)}function Xo(n,e,t){
return u("label",{class:"slider"},u("span",{},n),Ks(e.map(r=>[r,r]),t))}function be(n){let e=n>>>0;return()=>{e=e+1831565813>>>0;let t=Math.imul(e^e>>>15,e|1);return t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/2**32}}var gr=["rock",
"paper","scissors"],yr=[[.5,0,1],[1,.5,0],[0,1,.5]],tc=1e-9,ta=n=>yr.map(e=>e.reduce((t,r,s)=>t+r*n[s],0));function vr(n,e){let t=n.slice(-e);return gr.map((r,s)=>t.
filter(o=>o===s).length/t.length)}var br=n=>Math.max(...ta(n));function Qo(n,e,t){let r=ta(vr(n,e)),s=r.flatMap((o,a)=>o>Math.max(...r)-tc?[a]:[]);return s[s.length>
1?Math.floor(t()*s.length):0]}function pn(n,e,t){let r={pursuers:[0],evaders:[0]};for(let s=1;s<=n;s++)r.pursuers.push(Qo(r.evaders,e,t)),r.evaders.push(Qo(r.pursuers,
e,t));return r}var Tt=100,fn={scalar:{dimensions:1,greatest:!0},focusing:{dimensions:10,greatest:!0},intransitive:{dimensions:2,greatest:!1}};function fr(n,e,t){
let{greatest:r}=fn[n],s=e[0]-t[0];for(let o=1;o<e.length;o++){let a=e[o]-t[o];(r?Math.abs(a)>Math.abs(s):Math.abs(a)<Math.abs(s))&&(s=a)}return(1+Math.sign(s))/
2}var wr=(n,e,t)=>e.reduce((r,s)=>r+t.reduce((o,a)=>o+fr(n,s,a),0),0)/(e.length*t.length),Je={population:25,mutation:.005,opponents:15,hall:0},Ze=class{game;settings;generation=0;#e;#n;#t=[
[],[]];constructor(e,t,r){this.game=e,this.settings=t,this.#e=r;let s=()=>Array.from({length:t.population},()=>new Uint8Array(Tt));this.#n=[s(),s()]}ones(e){let{
dimensions:t}=fn[this.game],r=Tt/t;return this.#n[e].map(s=>Array.from({length:t},(o,a)=>hn(s.subarray(a*r,(a+1)*r))))}objective=e=>hn(this.#n[e].map(hn))/this.
settings.population;step(){let e=[this.ones(0),this.ones(1)],t=this.#r(e);for(let r of[0,1]){this.#t[r].push(e[r][t[r].indexOf(Math.max(...t[r]))]);let s=this.#s(
t[r]);this.#n[r]=s.map(o=>this.#a(this.#n[r][o]))}this.generation++}#r(e){let{population:t,opponents:r,hall:s}=this.settings,o=[new Array(t).fill(0),new Array(t).
fill(0)];for(let a=0;a<r;a++)ea(t,this.#e).forEach((i,l)=>{let c=fr(this.game,e[0][l],e[1][i]);o[0][l]+=+(c===1),o[1][i]+=+(c===0)});for(let a of[0,1]){let i=this.#t[1-
a];for(let l of ea(i.length,this.#e,s))e[a].forEach((c,m)=>o[a][m]+=+(fr(this.game,c,i[l])===1))}return o}#a(e){let t=e.slice();for(let r=0;r<t.length;r++)this.#e()<
this.settings.mutation&&(t[r]^=1);return t}#s(e){let t=hn(e),r=t?e:e.map(()=>1);return e.map(()=>{let s=this.#e()*(t||e.length),o=r.findIndex(a=>(s-=a)<0);return o<
0?e.length-1:o})}};function ea(n,e,t=n){let r=Array.from({length:n},(o,a)=>a),s=Math.min(t,n);for(let o=0;o<s;o++){let a=o+Math.floor(e()*(n-o));[r[o],r[a]]=[r[a],
r[o]]}return r.slice(0,s)}function hn(n){let e=0;for(let t=0;t<n.length;t++)e+=n[t];return e}var xr=1,gn=["pursuers","evaders"],sa=[[150,42],[266,232],[34,232]],nc={pursuers:-7,evaders:7},na=n=>[0,1].map(e=>n.reduce((t,r,s)=>t+r*sa[s][e],0)),ra=(n,e)=>n.
map((t,r)=>vr(n.slice(0,r+1),e));function oa({memories:n=[1],memory:e=n[0],generations:t=30}){let r=new ve(t,{speed:t>100?16:2,still:ye()}),s=e,o=pn(t,s,be(xr)),
a={pursuers:[],evaders:[]},i={pursuers:w("polyline",{class:"way of-pursuers"}),evaders:w("polyline",{class:"way of-evaders"})},l={pursuers:w("path",{class:"fill\
ed-pursuer",d:"M0 -11 11 9H-11z"}),evaders:w("circle",{class:"filled-evader",r:9})},c=w("svg",{viewBox:"0 0 300 270",class:"hands-triangle",role:"img","aria-lab\
el":"The shares of rock, paper and scissors among the remembered hands of both teams"},w("polygon",{class:"frame",points:sa.map(g=>g.join()).join(" ")}),w("circ\
le",{class:"middle",cx:150,cy:168.7,r:4}),w("text",{x:150,y:192,"text-anchor":"middle"},"one third each"),w("text",{class:"label",x:150,y:18,"text-anchor":"midd\
le"},"rock"),w("text",{class:"label",x:266,y:262,"text-anchor":"middle"},"paper"),w("text",{class:"label",x:34,y:262,"text-anchor":"middle"},"scissors"),...gn.map(
g=>i[g]),...gn.map(g=>l[g])),m=u("p",{class:"numbers"}),d=ae("What the best answer wins against the remembered hands, by generation",(g,v)=>{let b=se(g,v,{low:0,
high:t,label:"generation",whole:!0},{low:.4,high:1,label:"best answer wins"});oe(b,[0,t],[.5,.5],"half");for(let x of gn)oe(b,o[x].map((T,A)=>A),a[x].map(br),`o\
f-${x}`);return b},g=>zo(g,r.step,"of-both"),g=>r.jump(g)),h=()=>{let g=r.step;for(let b of gn){i[b].setAttribute("points",a[b].slice(0,g+1).map(A=>na(A).map($=>$.
toFixed(1)).join()).join(" "));let[x,T]=na(a[b][g]);l[b].setAttribute("transform",`translate(${x+nc[b]} ${T})`)}let v=b=>u("span",{class:b.slice(0,-1)},`${b} sh\
ow ${gr[o[b][g]]}`);m.replaceChildren(`Generation ${g}: `,v("pursuers"),", ",v("evaders"),".",...n.length>1?[` The best answer to the remembered hands of the pu\
rsuers wins ${P(br(a.pursuers[g]))}.`]:[]),d.update()},p=()=>{o=pn(t,s,be(xr)),a={pursuers:ra(o.pursuers,s),evaders:ra(o.evaders,s)},d.redraw(),h()};r.addEventListener(
"step",h),p();let f=n.at(-1),y=Re("memory (hands)",n,e,g=>g===f?"all":String(g),g=>{s=g,p()});return u("div",{class:"widget"},n.length>1&&y,u("div",{class:"two"},
u("div",{},c),n.length>1&&u("div",{},Ke(["pursuers' hands","of-pursuers"],["evaders' hands","of-evaders"]),d.element)),m,Ve(r))}function aa({generations:n=30}){
let{pursuers:e,evaders:t}=pn(n,1,be(xr)),r=e.map(o=>t.map(a=>yr[o][a])),s=r.at(-1);return u("div",{class:"widget"},u("div",{class:"matrices"},ke(r,`The last pur\
suers score ${P(s.reduce((o,a)=>o+a,0)/s.length)} against all evaders.`)),me("0 loses","1 wins"))}var Et=600,Xe=20,Sr=5,Ct=10,Mr={"Game A":"intransitive","Game B":"scalar","Game C":"focusing"},la={low:0,high:Et,label:"generation",whole:!0},ca={low:0,high:Tt,
label:"ones of side 1"},Pe=()=>{},rc=()=>new Promise(n=>setTimeout(n));async function Ar(n,e,t){for(e();n.generation<Et&&t();e()){for(let r=0;r<Xe;r++)n.step();
await rc()}}var yn=new Map,ua=[];async function sc(){for(let n of Object.keys(Mr))yn.set(n,[]);for(let n=0;n<Sr;n++)for(let[e,t]of Object.entries(Mr)){let r={score:[],
ones:[]};yn.get(e).push(r);let s=new Ze(t,Je,be(n));await Ar(s,()=>{r.score.push(wr(t,s.ones(0),s.ones(1))),r.ones.push(s.objective(0))},()=>!0),ua.forEach(o=>o())}}
function da({shows:n="score"}){yn.size||sc();let e=n==="score"?{low:0,high:1,label:"score of side 1"}:ca,t=Object.entries(Mr).map(([r,s])=>{let o=n==="score"?r:
`${r}: ${s}`,a=ae(`${o}: ${e.label} in ${Sr} races`,(i,l)=>{let c=se(i,l,la,e);for(let m of yn.get(r))oe(c,m[n].map((d,h)=>h*Xe),m[n],"of-both dense");return c},
Pe,Pe);return ua.push(a.redraw),u("figure",{},u("figcaption",{},o),a.element)});return u("div",{class:"widget"},u("div",{class:"matrices"},...t),u("p",{class:"s\
mall muted"},`Each line is a race; there are ${Sr} of each game, played now, in this page.`))}var oc=[5,10,15,25,40,60],ac=[5e-4,.001,.002,.005,.01,.02,.05],ic=[
0,1,5,15,30],ia=15,lc=Array.from({length:20},(n,e)=>e);function ma({hall:n=!1}){let e="scalar",t=0,r={...Je,hall:n?ia:0},s=0,o=b=>{r={...r,...b}},a=[[],[]],i=[ke(
a[0],"Score of side 1",Et/Xe+1),ke(a[1],"Score of side 2",Et/Xe+1)];i.forEach(b=>b.querySelector("p").replaceChildren(`↑ generation, → opponent (${Xe} a cel\
l)`));let l=[[],[]],c=ae("Ones of both sides by generation",(b,x)=>{let T=se(b,x,la,{...ca,label:"ones"});return l.forEach((A,$)=>oe(T,A.map((_,z)=>z*Xe),A,$?"o\
f-evaders":"of-pursuers")),T},Pe,Pe),m=u("p",{class:"numbers",role:"status"}),d=b=>{m.textContent=b},h=async()=>{let b=++s;for(let A of[...a,...l])A.length=0;let x=[
[],[]],T=new Ze(e,r,be(t));await Ar(T,()=>{for(let A of[0,1])x[A].push(T.ones(A)),l[A].push(T.objective(A));for(let A of[0,1])a[A].push(x[1-A].map($=>wr(T.game,
x[A].at(-1),$)));i.forEach(A=>A.draw?.()),c.redraw()},()=>s===b),s===b&&d(`${de(T.game)} game, seed ${t}: after ${Et} generations side 1 has ${l[0].at(-1).toFixed(
0)} ones, side 2 ${l[1].at(-1).toFixed(0)}.`)},p=[],f=ae("Ones of side 1 at the end of ten races, a row for each choice of settings",(b,x)=>cc(p,b,x),Pe,Pe);f.element.
classList.add("dots");let y=async b=>{let x=++s,T=[],{population:A,mutation:$}=b,_=`${e}${A===Je.population?"":`, ${A} players`}${$===Je.mutation?"":`, mutation\
 ${$}`}, hall ${b.hall}`;p=[...p.filter(z=>z.ends.length===Ct&&z.text!==_).slice(1-Tr),{text:_,ends:T}];for(let z=0;z<Ct&&s===x;z++){let I=new Ze(e,b,be(z));await Ar(
I,Pe,()=>s===x),s===x&&T.push(I.objective(0)),f.redraw()}s===x&&d(`${de(_)}: side 1 ends with ${ha(T)} ones in the mean of ${Ct} races.`)},g=(b,x,T="")=>u("butt\
on",{type:"button",class:T,onclick:()=>{b()}},x),v=u("div",{class:"sliders"},Xo("game",Object.keys(fn),b=>e=b),Re("population",oc,r.population,String,b=>o({population:b})),
Re("mutation",ac,r.mutation,String,b=>o({mutation:b})),...n?[Re("hall of fame",ic,ia,String,b=>o({hall:b}))]:[Re("seed",lc,0,String,b=>t=b)]);return n?(y(Je).then(
()=>s===1?y(r):void 0),u("div",{class:"widget"},v,u("div",{class:"buttons"},g(()=>y(r),"Play ten races","primary")),m,f.element)):u("div",{class:"widget"},v,u("\
div",{class:"buttons"},g(h,"Play a race","primary"),g(async()=>{s++},"Stop")),u("div",{class:"matrices"},...i,u("figure",{},u("figcaption",{},"The truth: ones"),
Ke(["side 1","of-pursuers"],["side 2","of-evaders"]),c.element)),me("0 loses","1 wins"),m)}var Tr=6,ha=n=>(n.reduce((e,t)=>e+t,0)/n.length).toFixed(1);function cc(n,e,t){
let r=se(e,t,{low:0,high:Tt,label:"ones of side 1 at the end",whole:!0},{low:0,high:Tr,label:""});return r.root.querySelectorAll(".axes .grid, .axes [text-ancho\
r=end]").forEach(s=>s.remove()),n.forEach(({text:s,ends:o},a)=>{let i=r.y(Tr-a-.7);r.marks.before(w("text",{class:"label",x:r.left,y:i-12},`${s}: ${o.length<Ct?
`${o.length} of ${Ct} races`:`mean ${ha(o)}`}`)),o.forEach(l=>r.marks.before(w("circle",{class:"dot of-both",cx:r.x(l),cy:i,r:5})))}),r}var fa=n=>n.answer===void 0?dc():uc(n,n.answer);function uc(n,e){let t=u("input",{type:"text",inputmode:"decimal",size:8,"aria-label":"Your answer, a number",autocomplete:"\
off"});return{input:t,check:()=>{let s=t.value.trim().replace(",","."),o=Number(s);if(s===""||Number.isNaN(o))return"Expected a number, such as 0.5.";let a=i=>Math.
abs(o-i)<=(n.tolerance??0)+1e-9;return a(e)?null:n.clues?.find(([i])=>a(i))?.[1]??n.otherwise??"Expected another number."},answer:()=>t.value,set:s=>t.value=s}}
var Q=4,Er=[.5,.8,.2];function dc(){let n=new Array(Q*Q).fill(.5),e=(l,c)=>dn(l,n[c],`generation ${Math.floor(c/Q)} of the pursuers against generation ${c%Q} of\
 the evaders`,1),t=n.map((l,c)=>{let m=u("button",{type:"button",disabled:c%(Q+1)===0,onclick:()=>{n[c]=Er[(Er.indexOf(n[c])+1)%Er.length],e(m,c)}});return e(m,
c),m}),r=Array.from({length:Q},(l,c)=>c),s=u("div",{class:"cells numbers",role:"group","aria-label":"Capture rates: rows are pursuers, columns evaders"},u("span"),
u("span",{class:"evader all"},"generation of the evaders"),u("span",{class:"pursuer"},"generation of the pursuers"),...r.map(l=>u("span",{class:"evader"},l)),...r.
flatMap(l=>[u("span",{class:"pursuer"},l),...t.slice(l*Q,(l+1)*Q)])),o=l=>r.map(c=>r.reduce((m,d)=>m+n[l(c,d)],0)/Q);return{input:s,check:()=>{let l=o((d,h)=>d*
Q+h),c=o((d,h)=>h*Q+d),m=(d,h)=>d.every((p,f)=>!f||h*(p-d[f-1])>1e-9);return m(l,1)?m(c,-1)?null:`The means of the columns are ${pa(c)}. They say how often the \
evaders are captured, and should fall from column to column.`:`The means of the rows are ${pa(l)}. They are the strengths of the pursuers, and should grow from \
row to row.`},answer:()=>n.join(" "),set:l=>{l.split(" ").forEach((c,m)=>n[m]=Number(c)),t.forEach(e)}}}var pa=n=>n.map(e=>e.toFixed(2)).join(", ");var Ot=n=>n.trim().split(/\n\s*\n/).map(e=>u("p",{},...Cr(e))),Cr=n=>n.split("**").map((e,t)=>t%2?u("strong",{},e):document.createTextNode(e));function ga(n,e){
let{predict:t,options:r}=n,s=u("p",{class:"small muted",role:"status"}),o=u("button",{type:"submit",class:"primary"},"This is my prediction"),a=Object.keys(r).map(
c=>u("input",{type:"radio",name:`prediction-${t}`,value:c})),i=u("form",{class:"prediction",id:`prediction-${t}`},u("fieldset",{},u("legend",{},u("strong",{},"P\
redict. "),n.question),...a.map(c=>u("label",{class:"option"},c,u("span",{},r[c.value])))),u("div",{class:"buttons"},o,s)),l=()=>{let c=e.choice(t);if(c!==void 0){
for(let m of a)m.checked=m.value===c,m.disabled=!0;o.hidden=o.disabled=!0,s.replaceChildren(),i.append(n.later?u("p",{class:"reply"},n.later):mc(n,c,n.again&&e.
choice(n.again)))}};return i.addEventListener("submit",c=>{c.preventDefault();let m=a.find(d=>d.checked);m?(e.choose(t,m.value),l()):s.textContent="Choose one f\
irst. Any prediction is a good one."}),l(),i}function mc(n,e,t){let{options:r,outcome:s}=n,o=e===s;return u("div",{class:"reply",role:"status","data-right":String(
o)},t&&u("p",{},u("strong",{},"At the beginning you predicted: "),r[t]),u("p",{},u("strong",{},o?"✓ As you predicted: ":"You predicted: "),r[e]),o?null:u("p",
{},u("strong",{},"The outcome: "),r[s]),...Ot(n.explanation??""),n.note&&u("p",{class:"small muted"},n.note))}function ya(n,e){let{input:t,check:r,answer:s,set:o}=fa(
n),a=u("p",{class:"reply",role:"status",hidden:!0}),i=m=>{a.hidden=!1,a.dataset.right=String(m===null),a.replaceChildren(u("strong",{},m===null?"✓ Right. ":"✗\
 Not yet. "),m??n.explanation)},l=u("form",{class:"exercise",id:`exercise-${n.exercise}`},u("div",{class:"text"},u("p",{},u("strong",{},"Exercise. "),...Cr(n.question))),
n.matrix&&hc(n.matrix),u("div",{class:"buttons"},t,u("button",{type:"submit"},"Check")),a);l.addEventListener("submit",m=>{m.preventDefault();let d=r();d===null&&
e.solve(n.exercise,s()),i(d)});let c=e.solved(n.exercise);return c!==void 0&&(o(c),i(null)),l}function hc(n){let e=n.map((t,r)=>r);return u("div",{class:"wide-t\
able",tabindex:0},u("table",{class:"rates numbers"},u("thead",{},u("tr",{},u("td"),u("th",{scope:"colgroup",colspan:e.length,class:"evader"},"generation of the \
evaders")),u("tr",{},u("th",{class:"pursuer"},"generation of the pursuers"),...e.map(t=>u("th",{scope:"col"},t)))),u("tbody",{},...n.map((t,r)=>u("tr",{},u("th",
{scope:"row"},r),...t.map(s=>u("td",{},s.toFixed(1))))))))}var pc=40;function va({question:n="",points:e=[]},t){let r=u("textarea",{id:"exit-answer",rows:8,oninput:()=>{
t.exit={exit:r.value},s.textContent=r.value}}),s=u("p",{class:"printed"}),o=u("p",{class:"small muted",role:"status"}),a=u("button",{type:"submit",class:"primar\
y"},"I am done"),i=u("form",{class:"exercise"},u("label",{for:"exit-answer"},u("strong",{},"Exit question. "),n),r,s,u("div",{class:"buttons"},a,u("button",{type:"\
button",onclick:()=>Vt("exit_answer.txt",`${n}

${r.value}
`)},"Save my answer"),o)),l=()=>{s.textContent=t.exit.exit,t.exit.done&&(r.readOnly=!0,a.hidden=!0,i.append(u("div",{class:"reply"},u("p",{},u("strong",{},"A go\
od answer has:")),u("ul",{},...e.map(c=>u("li",{},...Cr(c)))))))};return r.value=t.exit.exit,i.addEventListener("submit",c=>{if(c.preventDefault(),r.value.trim().
length<pc){o.textContent="Write two explanations and an experiment first. Then the page shows what a good answer has.";return}o.textContent="",t.exit={done:!0},
l()}),l(),u("div",{class:"widget"},i)}var fc=Array.from({length:16},(n,e)=>{let t=e%2?6.5:11,r=Math.PI*e/8;return`${12+t*Math.sin(r)} ${12-t*Math.cos(r)}`}).join(" ");function vn(){let n=[["pursuer",
w("path",{d:"M12 3 22 20H2z",class:"filled-pursuer"})],["evader",w("circle",{cx:12,cy:12,r:9,class:"filled-evader"})],["capture",w("polygon",{points:fc,class:"f\
illed-capture"})],["captured evader",w("circle",{cx:12,cy:12,r:7.5,class:"ring-evader"})],["conflict",w("rect",{x:3,y:3,width:18,height:18,class:"dashed-conflic\
t"})]];return u("ul",{class:"shapes small","aria-label":"Shapes on the board"},...n.map(([e,t])=>u("li",{},w("svg",{viewBox:"0 0 24 24","aria-hidden":"true"},t),
e)))}function gc(n,e,t){let{rows:r,cols:s,n_pursuers:o,fov:a,rules:{interaction:i}}=n;return{rows:r,cols:s,nPursuers:o,fov:a,interaction:i,obstacles:e,moments:t}}function bn(n){let e=Array.from({length:n.length+1},(t,r)=>yc(n,r));return gc(n.config,n.map,e)}function yc(n,e){let t=n.n_agents,r=n.config.n_evaders,s=(a,i,l)=>a.
subarray(i*l,(i+1)*l),o={positions:s(n.last_positions,e,2*t),alive:s(n.alive,e,t),captured:s(n.captured,e,r),everCaptured:s(n.ever_captured,e,r)};return e===0?o:
{...o,actions:s(n.actions,e-1,t),involved:s(n.involved,e-1,3*t),fault:s(n.fault,e-1,3*t),get contested(){return n.conflicts(e).map(a=>a.cell)}}}var vc=8,bc=900,ba=1800,$e=class extends EventTarget{element;player=new ve(0,{speed:vc,still:ye()});match=null;agent=null;#e=u("figcaption");#n=u("canvas",{onclick:({
clientX:e,clientY:t})=>this.#d(e,t)});#t;#r=u("p",{class:"small muted numbers"});#a=u("p",{class:"small",role:"status"});#s=null;#l=!1;constructor(){super(),this.#t=
new je(this.#n,{numbers:!1}),this.element=u("figure",{class:"chase"},this.#e,this.#n,this.#r,this.#a),this.player.addEventListener("frame",()=>this.#m()),this.player.
addEventListener("step",()=>this.#p()),this.player.addEventListener("state",()=>this.over&&this.dispatchEvent(new Event("over")))}get over(){return this.player.
length>0&&!this.player.playing&&this.player.step===this.player.length}get title(){return this.#e.textContent}get recording(){return this.#s}show(e,t){this.match=
e,this.#s=bn(e),this.#e.textContent=t,this.#n.ariaLabel=`A match. ${t}`,this.player.jump(0),this.player.length=e.length,this.player.marks=Xt(this.#s),this.#p()}choose(e){
this.agent=e,this.#t.look={selected:e,viewers:e===null?[]:[e]},this.dispatchEvent(new Event("agent"))}#d(e,t){this.#l||this.choose(this.#t.agentAt(e,t))}#m(){this.#s&&
this.#t.show(this.#s,this.player.time)}#p(){let e=this.#s?.moments[this.player.step]?.everCaptured;e&&(this.#r.textContent=`${Array.from(e).filter(Boolean).length}\
 of ${e.length} caught in ${this.player.step} steps`),this.dispatchEvent(new Event("step"))}drawWalls(e){let t=!1,r=!0,s=[0,0],o=([l,c])=>!!this.#s?.obstacles[l*
this.#s.cols+c],a=(l,c)=>{this.#a.textContent=e(l,c)},i=l=>{let c=this.#t.cellAt(l.clientX,l.clientY);c&&o(c)!==r&&a(c,r)};return this.#n.addEventListener("poin\
terdown",l=>{let c=t&&this.#t.cellAt(l.clientX,l.clientY);c&&(this.#n.setPointerCapture(l.pointerId),r=!o(c),i(l))}),this.#n.addEventListener("pointermove",l=>t&&
l.buttons&&i(l)),this.#n.addEventListener("keydown",l=>{let c={ArrowUp:[-1,0],ArrowDown:[1,0],ArrowLeft:[0,-1],ArrowRight:[0,1]}[l.key];if(!t||!this.#s||!(c||l.
key===" "))return;l.preventDefault();let m=(p,f)=>Math.min(f-1,Math.max(0,p)),{rows:d,cols:h}=this.#s;c?s=[m(s[0]+c[0],d),m(s[1]+c[1],h)]:a(s,!o(s)),this.#t.look=
{cursor:s}}),l=>{t=this.#l=l,this.#n.classList.toggle("drawn-on",l),this.#n.tabIndex=l?0:-1,this.#n.setAttribute("role",l?"application":"img"),this.#t.look={cursor:null}}}showWalls(e){
this.#s&&(this.#s={...this.#s,obstacles:e},this.#m())}},Qe=class{boards;#e;#n=-1/0;#t=0;#r=!ye();constructor(e,...t){this.#e=e,this.boards=t;for(let r of t)r.addEventListener(
"over",()=>this.#r&&t.every(({over:s})=>s)&&this.#a(bc))}get runs(){return this.#r}set runs(e){this.#r=e,clearTimeout(this.#t),this.#t=0;for(let{player:t}of this.
boards)e?t.play():t.pause()}renew(e=!1){e||performance.now()-this.#n>ba?this.#s():this.#t||this.#a(ba)}#a(e){clearTimeout(this.#t),this.#t=setTimeout(()=>this.#s(),
e)}#s(){if(clearTimeout(this.#t),this.#t=0,this.#n=performance.now(),this.#e(),this.#r)for(let{player:e}of this.boards)e.play()}};function Or(n,e){let t=n.runs;
new IntersectionObserver(([r])=>{r.isIntersecting?t&&!n.runs&&(n.runs=!0):(t=n.runs,n.runs=!1)}).observe(e)}var _e=["stay","north","east","south","west","northeast","southeast","southwest","northwest"];var wa="champion",xa=0,kr=64,Rr=100;var wc=(n,e)=>Object.keys(n).every(t=>n[t]===e[t]);function Sa(n,e){return Object.keys(e).find(t=>wc(e[t],n))??null}function Ma(n,e,t){let r=new Set(n);return Array.
from({length:e},(s,o)=>Array.from({length:t},(a,i)=>r.has(o*t+i)?"#":".").join(""))}var Ta={"specialist-specialist":"Specialists: both teams meet only the newest opponent","generalist-specialist":"Pursuers meet all earlier evaders, evaders only\
 the newest pursuers","generalist-generalist":"Generalists: both teams meet all earlier opponents","hall-of-fame":"Halls of fame: both teams learn at once, and \
meet earlier champions"};function Aa({schedule:n}){if(n.kind==="hall-of-fame")return n.kind;let e={latest:"specialist","round-robin":"generalist",uniform:"unifo\
rm"};return`${e[n.pursuers_meet]}-${e[n.evaders_meet]}`}var wn=n=>Ta[Aa(n)]??Aa(n);var xc=15;function Ea(n,e=""){let t=Object.hasOwn(n.worlds,e)?e:Object.keys(n.worlds)[0],{n_pursuers:r,n_evaders:s,fov:o,max_steps:a}=n.worlds[t];return{world:t,schedule:"\
generalist-generalist",beside:"",learner:"es",policy:"rating",seed:0,generations:xc,way:!1,population:0,pursuers:r,evaders:s,view:o,steps:a,walls:null}}function Ca(n,e,t=e.
schedule){let r=n.races[e.policy][e.learner][t],s=n.worlds[e.world],o={...s,n_pursuers:e.pursuers,n_evaders:e.evaders,fov:e.view,max_steps:e.steps,obstacles:e.walls?
Ma(e.walls,s.rows,s.cols):s.obstacles},a=e.way?"right-of-way":e.policy==="rating"?"obstacles":"none";return{...r,world:o,train_steps:e.steps,seed:e.seed,policy:{
...r.policy,mask:a},learner:{...r.learner,population:e.population||r.learner.population},schedule:{...r.schedule,generations:e.generations}}}function Oa(n,e){let{config:t,view:r,team:s,at:o,move:a}=n,{fov:i,diagonal:l}=t,c=Math.floor(i/2),m=re.slice(0,l?9:5),d=S=>Array.from(r.subarray(S*i*i,(S+1)*i*i)).
flatMap((C,H)=>C?[[Math.floor(H/i)-c,H%i-c]]:[]),[h,p,f]=[d(0),d(1),d(2)],[y,g]=s==="pursuer"?[p,h]:[h,p],v=(S,[C,H])=>S.some(([W,V])=>W===C&&V===H),b=(S,C)=>{let[
H,W]=[Math.abs(S[0]-C[0]),Math.abs(S[1]-C[1])];return l?Math.max(H,W):H+W},x=(S,C)=>[S[0]+C[0],S[1]+C[1]],T=S=>m.slice(1).map(C=>x(S,C)),A=(S,C)=>{let H=Math.min(
...S.map(W=>b(W,C)));return S.filter(W=>b(W,C)===H)},$=S=>!v(f,S),_=S=>x(o,S),z=[0,0],I=m[a],we=A(g,z),U=(S,C)=>{let H=[S,...T(S)].filter($),W=V=>C.some(he=>b(he,
V)<=1);return{escape:H.filter(V=>!W(V)),held:H.filter(W)}},Pt=s==="evader"?[U(I,g)]:we.map(S=>U(S,[I,...y])),Rn=s==="evader"?we.flatMap(S=>A(g.filter(C=>C!==S),
z).map(C=>[I,S,C])):we.flatMap(S=>A(y,S).map(C=>[S,I,C])),Pn=g.flatMap(T).filter(S=>Math.max(...S.map(Math.abs))<=c&&$(S)&&!v(y,S)),$t=re.slice(1,5).flatMap(([S,
C])=>Array.from({length:c},(W,V)=>[I[0]+V*S,I[1]+V*C]).filter(W=>!$(W)).slice(0,1)),j=S=>e.includes(S),D={ways:j("escapes")?xn(Pt,S=>S.escape.length):null,sides:j(
"opposite")?xn(Rn,S=>-Sc(...S)):null,openSide:j("open_side")?xn(Pn,S=>b(S,I)):null,exits:j("exits")?T(I).filter($):[],wall:j("room")?xn($t,S=>b(S,I)):null};return{
to:_(I),escape:(D.ways?.escape??[]).map(_),held:(D.ways?.held??[]).map(_),sides:D.sides&&[_(D.sides[0]),_(D.sides[1]),_(D.sides[2])],openSide:D.openSide&&_(D.openSide),
exits:D.exits.map(_),wall:D.wall&&_(D.wall)}}function xn(n,e){let t=n.map(e);return n[t.indexOf(Math.min(...t))]??null}function Sc(n,e,t){let[r,s]=[e,t].map(a=>[
a[0]-n[0],a[1]-n[1]]),o=Math.hypot(...r)*Math.hypot(...s);return o?(1-(r[0]*s[0]+r[1]*s[1])/o)/2:.5}var ka=0,Ra=1,Mc=2,Ac=176;function $a(n,e,t,r){let s=devicePixelRatio||1,o=on(n);n.width=n.height=Ac*s;let a=n.getContext("2d");if(!a)return;let{fov:i}=e,l=n.width/
i;a.fillStyle=o.paper,a.fillRect(0,0,n.width,n.height);for(let m=0;t&&m<i*i;m++){let d=(m%i+.5)*l,h=(Math.floor(m/i)+.5)*l,p=y=>!!t[y*i*i+m];p(Mc)&&(a.fillStyle=
o.obstacle,a.fillRect(d-l/2,h-l/2,l,l));let f=p(ka)&&p(Ra)?l*.18:0;p(ka)&&Pa(a,X,d+f,h+f,l*.74,o.evader),p(Ra)&&Pa(a,Ge,d-f,h-f,l*.86,o.pursuer)}a.strokeStyle=r<
e.n_pursuers?o.pursuer:o.evader,a.lineWidth=2*s;let c=Math.floor(i/2)*l;a.strokeRect(c,c,l,l)}function Pa(n,e,t,r,s,o){e(n,t,r,s),n.fillStyle=o,n.fill()}var Tc=["stay","↑","→","↓","←","↗","↘","↙","↖"];function Pr(n,e){let t=Yn(n,e);if(t){let r=s=>Math.abs(t[s]??0);return n.inputs.filter(r).sort((s,o)=>r(
o)-r(s))}return n.inputs.filter(r=>!e||new RegExp(`\\b${r}\\b`).test(e.expression))}function _a(n,{inputs:e,ratings:t,refused:r},s,o,a){let i=Yn(n,a),l=h=>`${h===
s?"taken":""} ${r[h]?"refused":""} ${h===o?"asked":""}`,c=(h,p)=>u("tr",{class:p.every(f=>f===p[0])?"same":""},h,...Array.from(p,(f,y)=>u("td",{class:l(y)},qe(f)))),
m=h=>{let f=`${i?`weight ${qe(i[h])} x `:""}${xe[h]}`;return u("th",{scope:"row",title:f},h.replaceAll("_"," "))},d=u("table",{class:"why numbers"},u("thead",{},
u("tr",{},u("th",{},i?"term":"input"),...Array.from(t,(h,p)=>u("th",{scope:"col",class:l(p),title:_e[p],"aria-label":_e[p]},Tc[p]))),c(u("th",{scope:"row"},i?"s\
um":"rating"),t)),u("tbody",{},...Pr(n,a).map(h=>{let p=i?i[h]:1,f=e[n.inputs.indexOf(h)];return c(m(h),f.map(y=>p*y))})));return[...a?[u("p",{class:"expression"},
u("code",{},a.expression))]:[],u("div",{class:"wide-table",tabindex:0,role:"group","aria-label":"How the moves are rated"},d)]}var Ec=(n,{pursuer:e,evader:t})=>({pursuers:fe(n,"pursuer",e),evaders:fe(n,"evader",t)}),Ia="What it remembers: a number for each unit, from -1 to 1",et=class{element;#e;#n;#t=u(
"canvas",{class:"seen",role:"img"});#r=u("h3");#a=u("p",{class:"small muted"});#s=u("div",{class:"answers"});#l=u("div",{title:Ia});#d=null;#m=null;#p=null;#c=null;#f=null;#o=null;#u=null;#i=0;#g=null;#h=null;#v=new Map;constructor(e,t=null){
this.#e=e,this.#n=t,this.element=u("div",{class:"inspector","data-open":"false"},u("p",{class:"hint small muted"},"Click an agent, or press A: what it sees, and\
 why it takes its move."),u("div",{class:"inspected"},this.#t,u("div",{class:"answer"},this.#r,this.#a,this.#l),this.#s))}get agent(){return this.#u}show(e,t,r,s,o=Ec(
t,s)){this.#d?.free(),this.#d=e.world(r.config),this.#p!==t&&(this.#m=null,this.#u!==null&&this.choose(null)),this.#p=t,this.#c=r,this.#f=s,this.#o=o,this.#b()}set solution(e){
this.#m=e,this.at(this.#i)}choose(e){this.#u=e,this.#b(),this.element.dataset.open=String(e!==null),this.#e(e),this.at(this.#i)}next(e){let t=this.#c;if(!t)return;
let r=this.#u??(e>0?-1:0);for(let s=0;s<t.n_agents;s++)if(r=(r+e+t.n_agents)%t.n_agents,t.alive[this.#i*t.n_agents+r])return this.choose(r)}ask(e){let t=this.#w();
if(!t.length)return;let r=t.indexOf(this.#g??this.#A(this.#u)??0);this.#g=t[(r+e+t.length)%t.length],this.at(this.#i)}askTo(e){let t=this.#M(e);return t===null?
!1:(this.#g=t,this.#h=null,this.at(this.#i),!0)}point(e,t){let r=e&&this.#M(e),s=this.#u,o=r!==null&&s!==null?{agent:s,move:r}:t!==null&&t!==s?{agent:t,move:null}:
null;o?.agent===this.#h?.agent&&o?.move===this.#h?.move||(this.#h=o,this.at(this.#i))}#b(){this.#g=this.#h=null,this.#v.clear()}#w(){let e=this.#u;if(e===null||
!this.#c||!this.#x(e))return[];let{config:t}=this.#c,r=this.#T(e)?.view,s=Math.floor(t.fov/2);return re.slice(0,t.diagonal?9:5).flatMap(([o,a],i)=>r&&!r[(2*t.fov+
s+o)*t.fov+s+a]?[i]:[])}#M([e,t]){let r=this.#u,s=r===null?null:this.#T(r)?.at;return s?this.#w().find(o=>s[0]+re[o][0]===e&&s[1]+re[o][1]===t)??null:null}#y(e){
return e<this.#c.config.n_pursuers?"pursuer":"evader"}#x(e){let t=this.#o?.[`${this.#y(e)}s`];return t&&typeof t!="string"&&t.kind!=="cells"?t:null}#S(e){let t=this.#y(
e);return Ps(this.#p,t,this.#f[t])}#A(e){let{actions:t,n_agents:r}=this.#c;return t[this.#i*r+e]??null}#T(e){return this.#v.has(e)||this.#v.set(e,this.#C(e)),this.#v.
get(e)}#C(e){let[t,r,s]=[this.#c,this.#d,this.#i];t.seek(r,s,this.#o);let o=r.read("positions"),a=t.actions.subarray(s*t.n_agents,(s+1)*t.n_agents);for(;a.length&&
!r.over&&(e<r.actors[0]||e>=r.actors[1]);)r.playTurn(a);let i=r.read("alive");if(!t.alive[s*t.n_agents+e]||!i[e])return null;let l=r.read("positions"),c=d=>[l[2*
d],l[2*d+1]],m=Array.from(i,(d,h)=>h).filter(d=>i[d]&&(l[2*d]!==o[2*d]||l[2*d+1]!==o[2*d+1]));return{at:c(e),view:r.view(e),moved:m.map(d=>({pursuer:this.#y(d)===
"pursuer",cell:c(d)}))}}#O(){if(!this.#n)return;let e=this.#h?.agent??this.#u,t=e===null||!this.#c?null:this.#x(e),r=e===null||!t?null:this.#E(e),s=e===null||r===
null?null:this.#T(e);if(e===null||!t||r===null||!s)return this.#n(null);let o={config:this.#c.config,team:this.#y(e),move:r,...s},a=Pr(t,this.#S(e));this.#n({...Oa(
o,a),moved:s.moved})}#E(e){let t=e===this.#u?this.#g:null;return this.#h?.move??t??this.#A(e)}at(e){e!==this.#i&&this.#b(),this.#i=e,this.#k(),this.#O()}#k(){let e=this.#c,
t=this.#d,r=this.#p,s=this.#f,o=this.#o,a=this.#u;if(!e||!t||!r||!s||!o||a===null)return;let i=this.#y(a);this.#l.replaceChildren(),this.#r.replaceChildren(u("s\
pan",{class:i},ee(a,e.config.n_pursuers)));let l=this.#C(a);if($a(this.#t,e.config,l?.view??null,a),this.#t.ariaLabel=`Field of view of ${ee(a,e.config.n_pursuers)}\
: evaders, pursuers and obstacles around it`,!l)return this.#$([],"It is gone.");let c=this.#A(a),m=o[`${i}s`],d=typeof m!="string"&&m.kind==="cells"?t.answer(m,
a):null,h=d?.probabilities??null;d?.memory.length&&this.#l.replaceChildren(u("p",{class:"small muted"},"It remembers:"),Rc(d.memory));let p=this.#x(a),f=this.#n?
this.#E(a):null,y=p?_a(p,t.rate(p,a),c,f,this.#S(a)):[],g=this.#m?.game(t)??null,v=[["network",h],["perfect",g?.marginal(a)??null]],b=x=>u("p",{class:"small mut\
ed"},x);this.#$([...g?[b(`Value ${g.value.toFixed(2)} under perfect play.`)]:[],...Oc(v,c),...y],c===null?"The episode is over.":Cc(m,c))}#$(e,t){this.#s.replaceChildren(
...e),this.#a.textContent=t}};function Cc(n,e){return typeof n=="string"?`The script "${n}" plays for it; it goes ${_e[e]}.`:n.kind!=="cells"?"It takes the best\
 move that its mask allows; of equal ones any.":n.sampled?"Its action is drawn from these probabilities.":"It takes the most probable action."}function Oc(n,e){
let t=n.filter(([,o])=>o);if(!t.length)return[];let r=u("div",{class:"action muted"},u("span"),...t.map(([o])=>u("span",{class:"head"},o))),s=Array.from(t[0][1],
(o,a)=>u("div",{class:a===e?"action taken":"action"},u("span",{},_e[a]),...t.flatMap(([,i])=>kc(i[a]))));return t.length>1||t[0][0]!==n[0][0]?[r,...s]:s}function kc(n){
let e=u("span",{class:"filled"});return e.style.width=`${100*n}%`,[u("span",{class:"track"},e),u("span",{class:"numbers"},n.toFixed(2))]}function Rc(n){let e=Array.
from(n,t=>{let r=u("span",{title:t.toFixed(2)});return r.style.transform=`scaleY(${t})`,r});return u("div",{class:"units",role:"img","aria-label":Ia},...e)}var Pc=40,Sn=class{element;#e;#n=u("div",{class:"episodes",role:"group","aria-label":"Episodes of this cell"});#t=u("p",{class:"check small numbers","aria-live":"\
polite"});constructor(e){this.#e=e,this.element=u("div",{class:"strip-of-episodes"},this.#n,this.#t)}show(e,t){let{pursuer:r,evader:s,episode:o,seed:a}=this.#e.
selected,i=ge(e,r,s);this.#n.replaceChildren(...(i?.rates??[]).slice(0,Pc).map((h,p)=>this.#r(h,p)));let l=a===null?i?.rates[o]:void 0,c=t.statistics.capture_rate,
m=l!==void 0&&Math.abs(c-l)<1e-6&&t.length===i?.lengths[o],d=i?"Not an episode of the evaluation":"The evaluation played no episodes of this pair.";this.#t.dataset.
equal=String(m),this.#t.textContent=m?"As in the evaluation":l===void 0?d:`Episode ${o+1} differs from the evaluation.`,this.#t.title=`Played here: capture rate\
 ${P(c,3)} in ${t.length} steps.${i?` The cell says ${P(i.rate,3)}.`:""}`}#r(e,t){let{selected:r}=this.#e,s=u("span",{class:"bar"});return s.style.height=`${Math.
round(100*e)}%`,u("button",{type:"button",class:"episode",title:`Episode ${t+1}: capture rate ${P(e)}`,"aria-label":`Episode ${t+1}, capture rate ${P(e)}`,"aria\
-pressed":String(t===r.episode&&r.seed===null),onclick:()=>this.#e.select({episode:t,seed:null})},s,u("span",{class:"count"},t+1))}};var $c=200;function Na(n,e,{pursuer:t,evader:r},s){let{text:o,image:a}=e.shows[`${t} ${r}`]??{},i=ge(n,t,r)?.rates??[],l=`Scores of the ${e.teams[0]} in ${i.length}\
 episodes: ${i.map(m=>P(m)).join(", ")}`,c=_c(n,e,t,r);return[o===void 0?null:u("pre",{tabindex:0,"aria-label":"What the game shows of this pair"},o),a===void 0?
null:u("img",{src:a,alt:"What the game shows of this pair",onload:({target:m})=>m.classList.toggle("pixels",m.naturalWidth<$c)}),...(o??a)===void 0?[u("p",{class:"\
muted"},e.missing),Ic(n,e,t,r,s)]:[],c?u("p",{class:"small numbers"},c):null,i.length>1?u("p",{class:"small numbers"},l):null].filter(m=>m!==null)}function _c(n,e,t,r){
let{others:s,extras:o={}}=n.payoff,a=s?.[t]?.[r],i=a===void 0?[]:[`score of the ${e.teams[1]} ${P(a)}`];for(let[l,c]of Object.entries(o)){let m=c[t]?.[r];m!==void 0&&
i.push(`${l} ${P(m)}`)}return i.length?`Means of the pair: ${i.join(", ")}`:""}function Ic(n,e,t,r,s){let o=Object.keys(e.shows).map(m=>m.split(" ").map(Number)),
a=([m,d])=>(m-t)**2+(d-r)**2,[i,l]=o.sort((m,d)=>a(m)-a(d))[0]??[];if(i===void 0||l===void 0)return null;let c=`${G(n,"pursuer",i)} against ${G(n,"evader",l)}`;
return u("p",{},u("button",{type:"button",onclick:()=>s.select({pursuer:i,evader:l})},`Nearest: ${c}`))}function La(n){let e=JSON.stringify(n,(t,r)=>t==="genome"?Array.from(r):r);return u("script",{type:"application/json",id:"champions"},e.replaceAll("<","\\u003c")).
outerHTML}var kt="_",Nc="n",$p=2n**64n-1n;var $r={fov:11,maxSteps:500,rewards:"paper"},Lc=["rules","others","rewards","size","diagonal","fov","limit","seed","ended","walls","pursuers","evaders","played",
"next"];function Wa(n,e){let t=i=>i.map(l=>Dc(l,e)).join(""),r=i=>`${Math.floor(i/n.cols)}.${i%n.cols}`,s=Fc(n.rewards,e),o=[n.seed,n.episode,n.steps].join("."),a={rules:Da(
n.rules,e),others:n.others?Da(n.others,e):"",rewards:s===$r.rewards?"":s,size:`${n.rows}x${n.cols}`,diagonal:n.diagonal?"1":"",fov:n.fov===$r.fov?"":String(n.fov),
limit:n.maxSteps===$r.maxSteps?"":String(n.maxSteps),seed:o==="0.0.0"?"":o,ended:n.ended?"1":"",walls:n.walls.map(r).join(kt),pursuers:n.pursuers.map(Fa).join(kt),
evaders:n.evaders.map(Fa).join(kt),played:n.played.map(t).join(kt),next:n.next.every(i=>i===xa)?"":t(n.next)};return Lc.filter(i=>a[i]).map(i=>`${i}=${a[i]}`).join(
"&")}function Fa({cell:n,gone:e,captured:t,everCaptured:r}){let s=t?"c":r?"e":"";return`${n[0]}.${n[1]}${s}${e?"x":""}`}function Da(n,e){let t=e.fields.map(({name:r})=>String(
n[r]).toLowerCase());return Sa(n,e.variants)??t.join(".")}function Fc(n,e){let t=JSON.stringify(n);return Object.keys(e.rewards).find(s=>JSON.stringify(e.rewards[s])===
t)??Object.values(n).map(s=>String(s)).join(kt)}function Dc(n,e){if(typeof n=="number")return String(n);if(n===wa)return Nc;let t=e.scripts.findIndex(({name:r})=>r===
n);return String.fromCharCode(97+t)}var Wc="/* the engine */";function Ua(n,e){return u("button",{type:"button",class:"to-playground",title:"Open this step in the playground (G): the same agents a\
nd actions under any rules",onclick:()=>Uc(n(),e)},"What if?")}function Uc(n,e){let t=n!==null&&n.match.n_agents<=Rr&&Math.max(n.match.config.rows,n.match.config.
cols)<=kr,r=t?u("script",{type:"text/plain",id:"scene"},Wa(Hc(n.match,n.step),e)).outerHTML:"",s=new TextDecoder().decode(Zn("playground")).replace(Wc,()=>ue("s\
cript-engine")).replace("</noscript>",i=>i+r+(t?La(n.champions):"")),o=u("iframe",{title:"Playground",srcdoc:s}),a=u("dialog",{class:"what-if","aria-label":"Wha\
t if?",onclose:()=>a.remove()},u("button",{type:"button",class:"leave",onclick:()=>a.close()},"Back to the match"),o);document.body.append(a),a.showModal()}function Hc(n,e){
let{config:t,n_agents:r}=n,s=Math.max(0,e-1),o=i=>{let l=s*r+i,c=s*t.n_evaders+i-t.n_pursuers,m=d=>i>=t.n_pursuers&&!!d[c];return{cell:[n.last_positions[2*l],n.
last_positions[2*l+1]],gone:!n.alive[l],captured:m(n.captured),everCaptured:m(n.ever_captured)}},a=Array.from({length:r},(i,l)=>o(l));return{rules:t.rules,others:null,
rewards:t.rewards,rows:t.rows,cols:t.cols,diagonal:t.diagonal,fov:t.fov,maxSteps:t.max_steps,seed:n.seed,episode:BigInt(n.episode),steps:s,ended:s===n.length,walls:Array.
from(n.map.keys()).filter(i=>n.map[i]),pursuers:a.slice(0,t.n_pursuers),evaders:a.slice(t.n_pursuers),played:[],next:Array.from(n.actions.subarray(s*r,(s+1)*r))}}var zc=.005,Gc=.05,Bc=4,tt=new Map;function za(n,e,t="capture-rate"){let r=JSON.stringify([{...e,rewards:null},t]),s=tt.get(r)??(gs(e)?Promise.resolve(null):jc(
n,e,t));return tt.delete(r),tt.set(r,s),tt.size>Bc&&tt.delete([...tt.keys()][0]),s}var Ha=()=>new Promise(n=>setTimeout(n));async function jc(n,e,t){await Ha();let r=n.solution(e,t);for(;r.goBack();)await Ha();return r}function Ga(n,e,t){let{payoff:r}=n;
return t.flatMap((s,o)=>{let a=[0,0];for(let l=e.n_turns;l>0&&!e.over;l--)n.game(e)?.lost(s).forEach((c,m)=>a[m]+=c),e.playTurn(s);let i=r==="capture-rate"?zc:Gc;
return M.map((l,c)=>({step:o+1,team:l,lost:a[c],payoff:r})).filter(l=>l.lost>=i)})}var Ba=n=>n.map(e=>({step:e.step,kind:e.team,size:e.lost/Math.max(1,...n.map(
({lost:t})=>t)),text:_r(e)})),Vc=({lost:n,payoff:e})=>e==="capture-rate"?`${n.toFixed(2)} of the capture rate`:`${n.toFixed(1)} steps`,_r=n=>`The ${n.team}s los\
e ${Vc(n)} against a perfect opponent`;function ja(n,e,t){if(t===0)return[{kind:"start",text:qc(n),agents:[]}];let r=e.moments[t-1],s=e.moments[t],o=m=>ee(m,n.config.n_pursuers),a=bt(e,r,s),i=n.conflicts(
t),l=new Set(i.flatMap(m=>m.doomed)),c=a.map(m=>({kind:"capture",text:`${o(m)} is captured`,agents:[m]}));for(let m of Qt(r,s))!a.includes(m)&&!l.has(m)&&c.push(
{kind:"end",text:`${o(m)} disappears`,agents:[m]});return c.push(...i.map(({kind:m,text:d,agents:h})=>({kind:m,text:d,agents:h}))),t===n.length&&c.unshift({kind:"\
end",text:Kc(n),agents:[]}),c}function qc({config:n}){return`${n.n_pursuers} pursuers and ${n.n_evaders} evaders on ${n.rows} x ${n.cols} cells, at most ${n.max_steps}\
 steps`}function Kc(n){let e=Math.round(n.statistics.capture_rate*n.config.n_evaders);return`The episode ends after ${n.length} steps with ${e} of ${n.config.n_evaders}\
 evaders captured`}var Yc=60,nt=class{element;player=new ve(0,{speed:an,still:ye()});inspector;match=null;recording=null;inputs=null;actions;#e;#n;#t;#r;#a=u("h2",{class:"match-ti\
tle"});#s=u("p",{class:"tally numbers"});#l=u("ol",{class:"words",tabindex:0,"aria-live":"off","aria-label":"What happened in this step"});#d=u("p",{class:"prob\
lem",role:"alert"});#m=u("div",{class:"signs"});#p=u("div",{class:"shown","aria-live":"polite"});#c=null;#f=null;#o=0;#u=!1;#i=0;#g=[];constructor(e,t,r){this.#n=
e,this.#t=t;let s=u("canvas",{"aria-label":"The match",onclick:({clientX:o,clientY:a})=>this.#C(o,a),onpointermove:({clientX:o,clientY:a,pointerType:i})=>i==="m\
ouse"&&this.#O(o,a),onpointerleave:()=>this.inspector.point(null,null)});this.#e=new je(s,{numbers:!1}),this.#r=new Sn(t),this.inspector=new et(o=>this.#E(o),o=>this.#e.
look={inputs:this.inputs=o}),this.actions=u("div",{class:"match-actions"},u("button",{type:"button",class:"to-play",title:"Move the chosen agent, or an evader, \
yourself from this step on (T)",onclick:()=>this.element.dispatchEvent(new Event("takeover"))},"Take over"),r&&Ua(()=>this.shown,r)),this.element=u("section",{class:"\
card match-card","aria-label":"Match",id:"match"},u("div",{class:"match"},u("header",{class:"match-head"},this.#a,this.#s),this.#d,this.#p,u("div",{class:"stage"},
s),u("div",{class:"aside"},this.#l,vn(),this.#m,this.actions,this.inspector.element),Ve(this.player),this.#r.element)),this.player.addEventListener("frame",()=>this.
recording&&this.#e.show(this.recording,this.player.time)),this.player.addEventListener("step",()=>this.#A()),t.on("match",()=>this.#b()),this.#S(),this.#T(0,0)}get#h(){
return this.#n[this.#t.selected.run]}reveal(){(this.#h.game?this.#p:this.#e.canvas).scrollIntoView({block:"nearest"})}get shown(){return this.match&&this.#f&&{match:this.
match,step:this.player.step,champions:this.#f}}start(e){this.#c=e,this.#w()}playSoon(){this.#u=!0,this.#o||this.#v()}goTo(e){this.#i=e,!this.#o&&this.match&&this.#w()}#v(){
!this.#u||!this.match||(this.#u=!1,this.player.jump(0),ye()||this.player.play())}#b(){this.#S(),clearTimeout(this.#o),this.#o=setTimeout(()=>this.#w(),Yc)}#w(){
clearTimeout(this.#o),this.#o=0,this.player.pause(),this.#S();let{selected:e}=this.#t,{game:t}=this.#h;if(this.#p.replaceChildren(...t?Na(this.#h,t,e,this.#t):[]),
t){this.match=this.recording=null,this.#u=!1,this.#y(e);return}let r=M.map(a=>ks(this.#h,a,e[a])).find(Boolean)??"";if(this.#d.textContent=r,r||!this.#c)return;
this.match=Dt(this.#c,this.#h,e);let[s,o]=this.names(e);this.#f={pursuer:{name:s,policy:fe(this.#h,"pursuer",e.pursuer)},evader:{name:o,policy:fe(this.#h,"evade\
r",e.evader)}},this.recording=bn(this.match),this.#r.show(this.#h,this.match),this.inspector.show(this.#c,this.#h,this.match,e),this.player.length=this.match.length,
this.player.marks=Xt(this.recording),this.#g=this.player.ticks=[],this.player.jump(this.#i),this.#i=0,this.#A(),this.#x(this.#c,this.match),this.#y(e),this.#v()}#M(){
let{teams:e,world:t}=this.#h,r=M.flatMap(o=>{let{policy:a}=e[o];return a&&a.kind!=="cells"?a.inputs:[]}),s=t!==null&&t.rules.interaction!=="SIMULTANEOUS";return $o(
[...new Set(r)],s)}#y({run:e,pursuer:t,evader:r,episode:s,seed:o}){this.element.dataset.played=`${e} ${t} ${r} ${s} ${o??""}`}async#x(e,t){let r=await za(e,t.config);
if(this.match!==t||!r)return;let s=e.world(t.config);t.seek(s,0),this.#g=Ga(r,s,Zc(t)),s.free(),this.player.ticks=Ba(this.#g),this.inspector.solution=r,this.#A()}names({
run:e,pursuer:t,evader:r}){let s=this.#n[e],{teams:o}=s;return[o.pursuer.script??G(s,"pursuer",t),o.evader.script??G(s,"evader",r)]}#S(){let{episode:e,seed:t}=this.#t.
selected,{game:r,payoff:s}=this.#h;this.element.classList.toggle("of-own-game",!!r),this.element.classList.toggle("of-ratings",M.some(l=>Rs(this.#h,l))),this.#m.
replaceChildren(...this.#M());let[o,a]=this.names(this.#t.selected),i=t===null?e<s.episodes?`episode ${e+1} of ${s.episodes}`:`episode ${e+1}, not part of the c\
ell`:`seed ${t}`;this.#a.replaceChildren(u("span",{class:"pursuer"},de(o))," against ",u("span",{class:"evader"},a),r?"":u("span",{class:"muted small"},i))}#A(){
let e=this.match;if(!e||!this.recording)return;let t=this.player.step,r=this.recording.moments[t];this.#T(Array.from(r.everCaptured).filter(Boolean).length,t),this.#l.
replaceChildren(...this.#g.filter(s=>s.step===t).map(s=>u("li",{class:`loss-${s.team}`},_r(s))),...ja(e,this.recording,t).map(s=>u("li",{class:s.kind,"data-agen\
ts":s.agents.join(" ")},s.text))),this.inspector.at(t),this.#k()}#T(e,t){let{world:r}=this.#h;r&&this.#s.replaceChildren(u("strong",{},e),` of ${r.n_evaders} ca\
ptured`,u("span",{class:"muted"},` · step ${t}`))}#C(e,t){let r=this.#e.agentAt(e,t),s=this.#e.cellAt(e,t);r===null&&s&&this.inspector.askTo(s)||this.inspector.
choose(r)}#O(e,t){this.inspector.point(this.#e.cellAt(e,t),this.#e.agentAt(e,t))}#E(e){this.#e.look={selected:e,viewers:e===null?[]:[e]},this.#k()}#k(){let e=this.
inspector.agent;for(let t of this.#l.children){let r=t.dataset.agents?.split(" ")??[];t.classList.toggle("about",e!==null&&r.includes(String(e)))}}},Zc=({actions:n,
length:e,n_agents:t})=>Array.from({length:e},(r,s)=>n.subarray(s*t,(s+1)*t));var Jc={ArrowUp:[1,0],ArrowDown:[-1,0],ArrowRight:[0,1],ArrowLeft:[0,-1]},Xc=5;function qa(n,e,t,r="pursuer"){n.tabIndex=0,n.setAttribute("role","application"),
n.addEventListener("keydown",s=>{let o=Jc[s.key];if(!o)return;let[a,i]=r==="pursuer"?o:[o[1],o[0]],[l,c]=t(),m=s.shiftKey?Xc:1,{pursuer:d,evader:h}=e.selected;e.
select({pursuer:Va(d+m*a,l),evader:Va(h+m*i,c)}),s.preventDefault(),s.stopPropagation()})}var Va=(n,e)=>Math.min(e-1,Math.max(0,n));var Qc=24,Mn=7,Ya=n=>n<Qc&&matchMedia("(pointer: coarse)").matches;function Za(n,e,t,r){let[s,o]=n.payoff.shape,a=Ka(e,s),i=Ka(t,o),l=Math.min(Mn,s),c=Math.min(
Mn,o),m=[];for(let y=a+l-1;y>=a;y--){m.push(u("span",{class:"pursuer"},y));for(let g=i;g<i+c;g++)m.push(eu(n,y,g,r))}let d=Array.from({length:c},(y,g)=>u("span",
{class:"evader"},i+g)),h=u("button",{type:"button","aria-label":"Close: all cells",onclick:()=>r(null)},"✕"),f=u("div",{class:"loupe numbers",role:"group","ar\
ia-label":"Cells around the tap",onclick:y=>y.stopPropagation()},...m,h,...d);return f.style.gridTemplateColumns=`2.4rem repeat(${c}, minmax(0, 1fr))`,f}function eu(n,e,t,r){
let s=u("button",{type:"button",onclick:()=>r({pursuer:e,evader:t})});return dn(s,ge(n,e,t)?.rate,`${G(n,"pursuer",e)} against ${G(n,"evader",t)}`),s}var Ka=(n,e)=>Math.
max(0,Math.min(e-Mn,n-Math.floor(Mn/2)));var K={left:52,bottom:46,top:76,right:84},le=10,tu=160,Rt=K.right-le-14,Ie=K.top-le-14,rt=class{element;#e;#n;#t=u("canvas",{"aria-hidden":"true"});#r=w("svg",{
"aria-hidden":"true"});#a=w("g");#s;#l=u("h2");#d=u("strong",{class:"rate numbers"});#m=u("span",{class:"small muted"});#p=u("p",{class:"of-both-teams small mut\
ed numbers"});#c;#f=null;constructor(e,t){this.#n=e,this.#e=t,this.#s=u("div",{class:"matrix",id:"matrix","aria-label":"Payoff matrix. Arrow keys choose a match\
, Enter plays it.",onpointermove:s=>this.#M(s),onpointerleave:()=>t.point({}),onclick:s=>this.#y(s),onkeydown:({key:s})=>s==="Enter"&&this.#S()},this.#t,this.#r);
let r=u("header",{class:"readout","aria-live":"polite"},u("div",{},this.#l,this.#p),u("div",{class:"of-cell"},this.#d,this.#m));this.#c=me(...ne(this.#o).ends),
this.element=u("section",{class:"card matrix-card","aria-label":"Payoff matrix"},r,this.#s,this.#c),this.#v(),new ResizeObserver(()=>this.#u()).observe(this.#s),
this.#s.addEventListener("mousedown",s=>{s.preventDefault(),document.activeElement instanceof HTMLElement&&document.activeElement.blur()}),qa(this.#s,t,()=>this.#o.
payoff.shape),t.on("run",()=>{let s=me(...ne(this.#o).ends);this.#c.replaceWith(s),this.#c=s,this.#u()}),t.on("match hover",()=>this.#h())}get#o(){return this.#n[this.#e.
selected.run]}#u(){let[e,t]=this.#o.payoff.shape,{clientWidth:r,clientHeight:s}=this.#s;if(r<50)return;let a=Math.max(tu,Math.min(r-K.left-K.right,s-K.top-K.bottom))/
Math.max(e,t),i=Math.max(K.left,(r-t*a-K.right+K.left)/2),l=K.top+Math.max(0,(s-K.top-K.bottom-e*a)/2),c={width:r,height:s,left:i,top:l,cell:a,rows:e,columns:t};
this.#f=c,Ye(this.#t,this.#o.payoff,{left:i,top:l,width:t*a,height:e*a});for(let[m,d,h]of[["left",i,r],["top",l,s],["width",t*a,r],["height",e*a,s]])this.#t.style.
setProperty(m,`${100*d/h}%`);this.#s.style.setProperty("--shape",`${r} / ${s}`),this.#r.setAttribute("viewBox",`0 0 ${r} ${s}`),this.#r.replaceChildren(nu(c,ne(
this.#o).generation),...ru(c),...this.#g(c),this.#a),this.#h()}#i(e){let t=this.#o.findings?.generalization;if(!t)return[];let{selected:r,hover:s}=this.#e,o=s.pursuer??
r.pursuer,a=s.evader??r.evader,[i,l]=Ja(e,t.pursuers.mean[o]??0,o),[c,m]=Xa(e,t.evaders.mean[a]??0,a);return[w("circle",{class:"dot of-pursuers",cx:i,cy:l,r:5}),
w("circle",{class:"dot of-evaders",cx:c,cy:m,r:5})]}#g(e){let t=this.#o.findings?.generalization;if(!t)return[];let{left:r,top:s,cell:o,rows:a,columns:i}=e,{curves:l}=ne(
this.#o),c=r+i*o+le,m=s-le,d={class:"side"};return[w("rect",{...d,x:c,y:s,width:Rt,height:a*o}),w("rect",{...d,x:r,y:m-Ie,width:i*o,height:Ie}),...Qa(t.pursuers,
(h,p)=>Ja(e,h,p),"of-pursuers"),...Qa(t.evaders,(h,p)=>Xa(e,h,p),"of-evaders"),w("text",{class:"tick",x:c,y:s+a*o+16,"text-anchor":"start"},"0"),w("text",{class:"\
tick",x:c+Rt,y:s+a*o+16,"text-anchor":"end"},"1"),w("text",{class:"tick",x:r-6,y:m-4,"text-anchor":"end"},"0"),w("text",{class:"tick",x:r-6,y:m-Ie+8,"text-ancho\
r":"end"},"1"),w("text",{class:"label of-pursuers",x:c+Rt,y:s+a*o+34,"text-anchor":"end"},l.pursuer),w("text",{class:"label of-evaders",x:r+i*o+le,y:m-Ie+10,"te\
xt-anchor":"start"},l.evader)]}#h(){let e=this.#f;if(!e)return;let{selected:t,hover:r}=this.#e,{left:s,top:o,cell:a,rows:i,columns:l}=e,c=f=>o+(i-1-f)*a,m=[],d=(f,y)=>w(
"rect",{class:y,x:s,y:c(f),width:l*a+le+Rt,height:a}),h=(f,y)=>w("rect",{class:y,x:s+f*a,y:o-le-Ie,width:a,height:le+Ie+i*a});m.push(d(t.pursuer,"strip pursuer"),
h(t.evader,"strip evader")),r.pursuer!==null&&r.pursuer<i&&m.push(d(r.pursuer,"strip hover")),r.evader!==null&&r.evader<l&&m.push(h(r.evader,"strip hover")),m.push(
...this.#i(e));let p={x:s+t.evader*a,y:c(t.pursuer),width:a,height:a};m.push(w("rect",{class:"chosen under",...p}),w("rect",{class:"chosen",...p})),this.#a.replaceChildren(
...m),this.#v()}#v(){let{selected:e,hover:t}=this.#e,r=t.pursuer??e.pursuer,s=t.evader??e.evader,o=ge(this.#o,r,s);this.#l.replaceChildren(u("span",{class:"purs\
uer"},de(G(this.#o,"pursuer",r)))," against ",u("span",{class:"evader"},G(this.#o,"evader",s))),this.#d.textContent=o?P(o.rate,3):"-";let a=o&&o.rates.length>1?
`, mean of ${o.rates.length} episodes`:"";this.#m.textContent=o?ne(this.#o).score+a:"no episodes were played",this.#p.textContent=this.#b(r,s)}#b(e,t){let r=this.#o.
findings?.generalization;if(!r)return"";let s=(a,i)=>Ho(a.mean[i]??null,a.low?.[i]??null,a.high?.[i]??null),{means:o}=ne(this.#o);return`Against all: ${o.pursuer}\
 ${s(r.pursuers,e)}, ${o.evader} ${s(r.evaders,t)}`}#w(e){let t=this.#f;if(!t)return null;let r=this.#s.getBoundingClientRect(),s=Math.floor((e.clientX-r.left-t.
left)/t.cell),o=t.rows-1-Math.floor((e.clientY-r.top-t.top)/t.cell),a=o>=0&&o<t.rows,i=s>=0&&s<t.columns;return a||i?{g:a?o:-1,h:i?s:-1,inside:a&&i}:null}#M(e){
let t=this.#w(e);this.#e.point(t?{pursuer:t.g<0?null:t.g,evader:t.h<0?null:t.h}:{})}#y(e){let t=this.#w(e);if(t){if(t.inside&&Ya(this.#f.cell))return this.#x(t.
g,t.h);this.#e.select({...t.g<0?{}:{pursuer:t.g},...t.h<0?{}:{evader:t.h}}),t.inside&&this.#S()}}#x(e,t){let r=Za(this.#o,e,t,s=>{r.remove(),s&&(this.#e.select(
s),this.#S())});this.#s.append(r)}#S(){this.#s.dispatchEvent(new CustomEvent("play",{bubbles:!0}))}};function nu({left:n,top:e,cell:t,rows:r,columns:s},o){let a=w(
"g",{class:"axes"}),i=e+r*t,l=c=>Mt(0,c-1,Math.min(c,c*t/44),!0);for(let c of l(s))a.append(w("text",{class:"tick",x:n+(c+.5)*t,y:i+16,"text-anchor":"middle"},c));
for(let c of l(r))a.append(w("text",{class:"tick",x:n-7,y:i-(c+.5)*t,"text-anchor":"end","dominant-baseline":"middle"},c));return a.append(w("text",{class:"labe\
l of-evaders",x:n+s*t/2,y:i+36,"text-anchor":"middle"},o.evader),w("text",{class:"label of-pursuers",transform:`translate(${n-36} ${e+r*t/2}) rotate(-90)`,"text\
-anchor":"middle"},o.pursuer)),a}function ru({left:n,top:e,cell:t,rows:r,columns:s}){let o=w("g",{class:"diagonal"}),a=Math.min(r,s);if(a<3)return[];let i=e+r*t;
for(let m of["H","V"]){let d=`M${n} ${i}`;for(let h=1;h<=a;h++){let p=`H${n+h*t}`,f=`V${i-h*t}`;d+=m==="H"?p+f:f+p}o.append(w("path",{d,class:"under"}),w("path",
{d}))}let l=n+a/2*t-.7*t-4,c=i-a/2*t-.7*t-4;return[o,w("text",{class:"on-cells",transform:`translate(${l} ${c}) rotate(-45)`,"text-anchor":"middle"},"same gener\
ation")]}var Ja=({left:n,top:e,cell:t,rows:r,columns:s},o,a)=>[n+s*t+le+o*Rt,e+(r-a-.5)*t],Xa=({left:n,top:e,cell:t},r,s)=>[n+(s+.5)*t,e-le-r*Ie];function Qa(n,e,t){
let r=o=>o.map((a,i)=>e(a??0,i).map(l=>l.toFixed(1)).join(" ")),s=[];return n.low&&n.high&&s.push(w("path",{class:`band ${t}`,d:`M${[...r(n.high),...r(n.low).reverse()].
join("L")}Z`})),s.push(w("path",{class:`line ${t}`,d:`M${r(n.mean).join("L")}`})),s}var ei={pursuer:null,evader:null},st=class extends EventTarget{#e;#n=ei;constructor(e){super(),this.#e=e}get selected(){return this.#e}get hover(){return this.#n}select(e){
let t=this.#e,r=["run","pursuer","evader"].some(s=>s in e&&e[s]!==t[s]);this.#e={...t,...r?{episode:0,seed:null}:{},...e},this.#e.run!==t.run&&this.dispatchEvent(
new Event("run")),this.dispatchEvent(new Event("match"))}point(e){let t={...ei,...e};t.pursuer===this.#n.pursuer&&t.evader===this.#n.evader||(this.#n=t,this.dispatchEvent(
new Event("hover")))}on(e,t){for(let r of e.split(" "))this.addEventListener(r,t)}};var Ir=n=>Array.from({length:n},()=>Array(n)),An=class{learning=M;settings=[];command="";training={capture_rate:[],generation:[],learner:[],epochs:1,window:1,matches:0};limits="";name;schedule;seed;seeds=[];world;payoff;teams;findings=null;genomes={
pursuer:[],evader:[]};best=null;#e;#n;#t;constructor(e,t,r,s){this.#t=e,this.#e=t,this.#n=s,this.name=r,this.schedule=r,this.world=e.world,this.seed=String(e.seed),
this.payoff=this.#r(),this.teams=this.#a()}get newest(){return this.genomes.pursuer.length-1}#r(){let{seed:e,schedule:{generations:t}}=this.#t,r=t+1;return this.
seeds=Array.from({length:r},(s,o)=>Array.from({length:r},(a,i)=>String(Wt(e,o,i)))),{first:[0,0],shape:[r,r],episodes:this.#t.evaluation_episodes,capture_rate:Ir(
r),capture_rates:Ir(r),lengths:Ir(r)}}#a(){let e=t=>{let r=`${this.#n} ${t}`;$s(r,zt(this.genomes[t]));let{genome:s,...o}=yt(Bt(this.#t,this.#e,t),this.genomes[t][0]??
new Float32Array(0));return{script:null,policy:{...o,genome_size:s.length},kept:[...this.genomes[t].keys()],genomes:r}};return{pursuer:e("pursuer"),evader:e("ev\
ader")}}policy(e,t){return this.playing(e,this.genomes[e][t])}playing(e,t){return yt(Bt(this.#t,this.#e,e),t)}genomesOf({pursuer:e,evader:t}){return{pursuer:this.
genomes.pursuer[e],evader:this.genomes.evader[t]}}extend(e){let{capture_rate:t,capture_rates:r,lengths:s,shape:[o]}=this.payoff;if(this.#t={...this.#t,schedule:e.
schedule},!(o>e.schedule.generations)){this.payoff=this.#r();for(let a=0;a<o;a++)Object.assign(this.payoff.capture_rate[a],t[a]),Object.assign(this.payoff.capture_rates[a],
r[a]),Object.assign(this.payoff.lengths[a],s[a])}}add(e){for(let t of M)this.genomes[t].push(e[t]);this.teams=this.#a()}change(e,t){this.#t=e,this.world=e.world;
for(let r of M)this.genomes[r]=[...t[r]];this.best=null,this.payoff=this.#r(),this.teams=this.#a(),this.findings=null}addCell({pursuer:e,evader:t,capture_rates:r,
lengths:s}){this.payoff.capture_rate[e][t]=E(r),this.payoff.capture_rates[e][t]=[...r],this.payoff.lengths[e][t]=[...s],this.findings={generalization:this.#s()}}#s(){
let e=this.payoff.capture_rate,t=o=>({mean:o,low:null,high:null}),r=o=>{let a=o.filter(i=>i!==void 0);return a.length?E(a):null},s=[...this.genomes.pursuer.keys()];
return{pursuers:t(s.map(o=>r(e[o]))),evaders:t(s.map(o=>r(e.map(a=>a[o]===void 0?void 0:1-a[o]))))}}};var su=1/4,ni=1.96,ti=.05,Nr=5;function ri(n,e){let t=Array.from({length:e},(d,h)=>Array.from({length:e},(p,f)=>n.get(`${h} ${f}`)?.capture_rates));if(e<2||t.some(
d=>d.includes(void 0)))return null;let r=t.map(d=>d.map(h=>E(h))),s=t.map(d=>d.map(h=>au(h))),o=Math.max(1,Math.round(e*su)),a=d=>{let h=nr(r,d),p=d==="pursuer"?
s:ou(s),f=[h[0].slice(-o)],y=h.slice(-o).map(T=>T.slice(-o)),g=T=>E(T.map(A=>E(A.slice(-o))/o))/T.length,v={value:E(y.map(E))-E(f.map(E)),reach:ni*Math.sqrt(g(p.
slice(-o))+g([p[0]]))},b=iu(h,p),x=cu(v,b);return{verdict:x==="better"&&!lu(h.map(E),b.value)?"better by a jump":x,before:E(f[0]),after:E(y.map(E))}},i={pursuer:a(
"pursuer"),evader:a("evader")},l=d=>{let h=nr(r,d).map(E);return h.lastIndexOf(Math.max(...h))},c={pursuer:l("pursuer"),evader:l("evader")},m=r[c.pursuer][c.evader];
return{rate:m,best:c,teams:i,sentence:du(m,i)}}var ou=n=>n[0].map((e,t)=>n.map(r=>r[t])),au=n=>n.reduce((e,t)=>e+(t-E(n))**2,0)/Math.max(1,n.length-1)/n.length;
function iu(n,e){let t=n.length-1,r=n.map((i,l)=>l-t/2),s=r.reduce((i,l)=>i+l*l,0),o=r.map(i=>t*i/s),a=e.map(i=>E(i)/i.length);return{value:n.reduce((i,l,c)=>i+
o[c]*E(l),0),reach:ni*Math.sqrt(a.reduce((i,l,c)=>i+o[c]**2*l,0))}}function lu(n,e){let t=n.map(c=>c*Math.sign(e)),r=Math.floor(n.length/Nr),s=n.length%Nr,o=Array.
from({length:Nr},(c,m)=>E(t.slice(m*r+Math.min(m,s),(m+1)*r+Math.min(m+1,s)))),a=Math.max(2,Math.floor(n.length/10)),i=Math.max(...t.slice(a).map((c,m)=>c-t[m])),
l=Math.max(...o.slice(1).map((c,m)=>o[m]-c));return i<Math.abs(e)/2&&l<Math.abs(e)/4}function cu(...n){return n.every(({value:e,reach:t})=>e-t>ti)?"better":n.every(
({value:e,reach:t})=>e+t<-ti)?"weaker":"cannot tell"}var B=n=>`${Math.round(100*n)} %`,uu={better:"better than in generation 0","better by a jump":"better than \
in generation 0, most of it in one jump",weaker:"weaker than in generation 0","cannot tell":""};function du(n,e){let t=`The best pursuers now catch ${B(n)} of t\
he best evaders.`,r=M.map(o=>uu[e[o].verdict]);if(r[0]===r[1])return r[0]?`${t} Both teams are ${r[0]}.`:`${t} Whether a team has become better since generation\
 0, this race cannot tell.`;let s=M.map((o,a)=>r[a]?`the ${o}s are ${r[a]}`:`of the ${o}s this race cannot tell`);return`${t} ${s[0][0].toUpperCase()}${s[0].slice(
1)}; ${s[1]}.`}function si(n,{before:e,after:t}){let[r,s]=n==="pursuer"?[e,t]:[1-e,1-t];return n==="pursuer"?`Of the last ${te(n)}s, pursuers of generation 0 ca\
tch ${B(r)}, the last pursuers ${B(s)}.`:`The last pursuers catch ${B(r)} of the evaders of generation 0, and ${B(s)} of the last evaders.`}var oi=1/3,mu=1/10,hu=4,pu=2,fu=12,ai=n=>n.length>1?`${n.slice(0,-1).join(", ")} and ${n.at(-1)}`:n[0]??"";function ii({phrases:n,words:e},t,r){let s=Object.entries(
r).map(([c,m])=>[c,Math.abs(m)]).sort(([,c],[,m])=>m-c),o=s[0]?.[1]||1/0,a=s.filter(([,c])=>c/o>=oi).slice(0,hu).map(([c])=>n[c][r[c]>0?1:0]),i=s.filter(([,c])=>c/
o>=mu&&c/o<oi).slice(0,pu).map(([c])=>n[c][2]),l=ai([...a,...i.length?[`minds ${ai(i)} little`]:[]])||"takes any move that is allowed";return`{A} ${t} ${l}.`.replaceAll(
/\{(\w+)\}/g,(c,m)=>e[t][m])}function li(n,e,t,r){let s=r[t];if(s.kind!=="rating")return{};let{n_pursuers:o,n_evaders:a}=e.config,i=Array.from({length:t==="purs\
uer"?o:a},(m,d)=>d+(t==="pursuer"?0:o)),l=n.world(e.config),c=s.inputs.map(()=>[]);for(let m=0;m<e.length;m+=Math.max(1,Math.floor(e.length/fu))){e.seek(l,m,{pursuers:r.
pursuer,evaders:r.evader});for(let d of i.filter(h=>e.alive[m*e.n_agents+h])){let{inputs:h,refused:p}=l.rate(s,d);h.forEach((f,y)=>{let g=Array.from(f).filter((v,b)=>!p[b]);
g.length&&c[y].push(E(g.map(v=>(v-E(g))**2)))})}}return l.free(),Object.fromEntries(s.inputs.map((m,d)=>[m,s.genome[d]*Math.sqrt(c[d].length?E(c[d]):0)]))}var gu=2,yu=1.5,Tn=class{element=u("section",{class:"card weights-card","aria-label":"Weights of named inputs",hidden:!0});#e;#n;#t;#r=u("div",{class:"evolved"});#a=u(
"p",{class:"numbers",role:"status"});#s=u("button",{type:"button",onclick:()=>this.#u()},"As evolved");#l={pursuer:u("p"),evader:u("p")};#d=null;#m=null;constructor(e,t,r){
this.#e=e,this.#n=t,this.#t=r,this.element.append(u("h3",{},"What they have learned"),u("p",{class:"small muted"},"An agent takes the move with the largest sum \
of weight x input. Drag a weight, and see at once what becomes of the team."),u("div",{class:"doings"},this.#s,this.#a),this.#r)}genome(e){return this.#m?.[e]??
this.#c[e]}get#p(){let{newest:e,best:t}=this.#d;return t??{pursuer:e,evader:e}}get#c(){return this.#d.genomesOf(this.#p)}show(e){e!==this.#d&&(this.#m=null),this.#d=
e;let t=M.flatMap(r=>{let{policy:s}=e.teams[r];return s?.kind==="rating"?[[r,s.inputs]]:[]});this.element.hidden=!t.length||e.newest<1,!this.element.hidden&&(this.#m||
this.#r.replaceChildren(...t.map(r=>this.#f(...r))),this.#i())}#f(e,t){let r=this.genome(e),s=Math.max(gu,yu*Math.max(...r.map(Math.abs)));return u("div",{class:"\
weights"},u("h4",{class:e},`${e}s`),this.#l[e],...t.flatMap((o,a)=>{let i=u("span",{class:"numbers"},qe(r[a])),l=u("input",{type:"range",class:e,min:-s,max:s,step:"\
any",value:r[a],title:xe[o],"aria-label":`${e}s: ${o}`});return l.addEventListener("input",()=>{i.textContent=qe(Number(l.value)),this.#o(e,a,Number(l.value))}),
[u("span",{title:xe[o]},o.replaceAll("_"," ")),l,i]}))}#o(e,t,r){this.#m??={pursuer:this.genome("pursuer").slice(),evader:this.genome("evader").slice()},this.#m[e][t]=
r,this.#i(),this.#t()}#u(){this.#m=null,this.show(this.#d),this.#t()}#i(){this.#s.disabled=!this.#m;let e=B(this.rate(this.#c));this.#a.textContent=this.#m?`You\
rs: ${B(this.rate(this.#m))} are caught; as evolved: ${e}`:`${e} are caught`;let t=this.#d,r={pursuer:t.playing("pursuer",this.genome("pursuer")),evader:t.playing(
"evader",this.genome("evader"))},s=this.#e.match(t.world,r.pursuer,r.evader,BigInt(t.seed));for(let o of M)this.#l[o].textContent=ii(this.#n,o,li(this.#e,s,o,r))}rate({
pursuer:e,evader:t},r=this.#p,s=this.#d){let o=new Int32Array(1),a={pursuer:o,evader:o,seed:BigUint64Array.of(BigInt(s.seeds[r.pursuer][r.evader]))};return E(this.#e.
rollouts(s.world,s.playing("pursuer",e),s.playing("evader",t),a,s.payoff.episodes).capture_rate)}};var vu=100,bu=.3,wu="By chance: evaders that have not learned to flee run into pursuers that have not learned to hunt.",En={pursuer:0,evader:0},ci=0,Cn=class extends EventTarget{element;chases;boards;before=new $e;after=new $e;settings;state="\
waiting";done=0;epochs=0;changed=[];seconds=0;outcome=null;kept=null;#e;#n;#t;#r=u("h2",{class:"lane-title"});#a=u("p",{class:"facts numbers"});#s=u("div",{class:"\
lane-room"});#l=u("section",{class:"card measures"});#d=u("details",{class:"lane-more",hidden:!0},u("summary",{},"More: every generation against every other, sc\
ores and collisions"),this.#s,this.#l);#m=u("div");#p=new et(()=>{});#c=u("section",{class:"card asked","aria-label":"An agent",hidden:!0},u("button",{type:"but\
ton",class:"leave",onclick:()=>this.#_(null,null)},"Close"),this.#p.element);#f;#o;#u={pursuer:[],evader:[]};#i=new Map;#g;#h=()=>{};#v=0;#b=!0;#w=!1;#M=0;#y=null;constructor(e,t,r,s){
super(),this.#e=e,this.#n=t,this.settings=s,this.#t=new jt(r,o=>this.#S(o)),this.chases=new Qe(()=>this.#F(),this.before,this.after),this.before.element.classList.
add("before"),this.boards=u("div",{class:"pair"},this.before.element,this.after.element),this.#f=new Tn(t,e,()=>this.#R(!0));for(let o of[this.before,this.after])
o.addEventListener("agent",()=>o.agent!==null&&this.#_(o,o.agent)),o.addEventListener("step",()=>!this.#c.hidden&&o.agent!==null&&this.#I(o));this.element=u("se\
ction",{class:"lane"},this.#r,this.#a,this.boards,u("p",{class:"hint small muted"},"Click an agent, or press A: what it sees, and why it moves."),this.#c,this.#f.
element,this.#d,this.#m),this.reset(s)}reset(e){this.#t.send({type:"stop"}),this.#E(e),this.state="waiting";let{archive:t}=new He(this.#n,e,this.#e.masks);this.#o.
add({pursuer:t.pursuer[0],evader:t.evader[0]}),this.#R(!0),this.#P()}start(e,t=[],r=1/0){this.#E(e),this.state="evolving",this.settings=t.at(-1)?.settings??e,this.#x(
{type:"start",settings:e,masks:this.#e.masks,plan:t,until:r}),this.#P()}restore(e,t,r,s){this.#E(t.settings),this.settings=e,this.kept=t;for(let o=0;o<t.finished;o++)
this.#o.add({pursuer:t.archive.pursuer[o],evader:t.archive.evader[o]});for(let[o,a]of t.cells)this.#o.addCell(a),this.#i.set(o,a);this.#u={pursuer:[...t.scores.
pursuer],evader:[...t.scores.evader]},this.seconds=t.seconds,this.done=1,this.epochs=r,this.changed.push(...s),this.#T("ended"),this.#C()}stop(){this.#x({type:"\
stop"})}go(){this.state="evolving",this.#x({type:"go"}),this.#P()}change(e){if(this.state==="waiting")return this.reset(e);this.settings=e,this.#x({type:"change",
settings:e}),this.#P()}saved(){return this.kept?Promise.resolve(this.kept):new Promise(e=>{this.#y=e,this.#x({type:"save"})})}async keep(){return{...await this.
saved(),scores:this.#u,seconds:this.seconds}}get newestGeneration(){return this.#o.newest}get champions(){return{pursuer:this.#f.genome("pursuer"),evader:this.#f.
genome("evader")}}get run(){return this.#o}close(){this.#t.close(),this.chases.runs=!1}#x(e){this.#t.send(e)}#S(e){if(e.type==="began"&&(this.#w=!0),!!this.#w){
if(e.type==="generation")this.#o.add(e.genomes),this.#R(e.number===0);else if(e.type==="cell"){let{pursuer:t,evader:r}=e.cell;this.#o.addCell(e.cell),this.#b&&t===
r&&t===this.#o.newest&&this.#g.select({pursuer:t,evader:r}),this.#i.set(`${t} ${r}`,e.cell),(this.state==="stopped"||this.state==="ended")&&this.#T(this.state)}else if(e.
type==="scores")for(let t of M)this.#u[t][e.number]=e.scores[t];else e.type==="changed"?(this.#o.extend(e.settings),this.changed.push(e.at),this.epochs=e.at,e.settings.
schedule.generations>this.#o.newest&&this.state==="ended"&&this.#A()):e.type==="anew"?(this.#o.change(e.settings,e.genomes),this.#O(),this.#R(!0)):e.type==="epo\
ch"?(this.epochs+=1,this.done=e.done/e.of):e.type==="stopped"?this.#T("stopped"):e.type==="end"?(this.seconds=e.seconds,this.done=1,this.#T("ended")):e.type==="\
saved"?this.#y?.(e.race):e.type==="failed"&&(this.#a.textContent=`The race failed: ${e.message}`,this.state="stopped");this.#M||(this.#M=setTimeout(()=>requestAnimationFrame(
()=>this.#C()),vu))}}#A(){this.state="evolving",this.outcome=null,this.#o.best=null}#T(e){let t=this.outcome;this.state=e,this.outcome=ri(this.#i,this.#o.newest+
1),this.#o.best=this.outcome?.best??null,this.outcome&&!t&&this.#R(!0),this.#U()}#C(){this.#M=0,this.#g.dispatchEvent(new Event("run")),this.#h(),this.#P()}#O(){
this.#i=new Map,this.#u={pursuer:[],evader:[]},this.outcome=null,this.#l.hidden=!0}#E(e){this.settings=e,this.done=0,this.epochs=0,this.changed.splice(0),this.kept=
null;let t=wn(e);this.#o=new An(e,this.#e.masks,t,`race ${ci}`),ci+=1,this.#O(),this.#_(null,null),this.#b=!0,this.#w=!1,this.#g=new st({run:0,pursuer:0,evader:0,
episode:0,seed:null});let r=new rt([this.#o],this.#g);r.element.ariaLabel=`Payoff matrix. ${t}`,this.#m.replaceChildren(this.#k(r)),this.#s.replaceChildren(r.element,
this.#$())}#k(e){let t=new nt([this.#o],this.#g,null);t.actions.remove();let r=u("dialog",{class:"of-cell-match","aria-label":"Match",onclose:()=>t.player.pause()},
u("button",{type:"button",class:"leave",onclick:()=>r.close()},"Close"),t.element),s=!1;return e.element.addEventListener("play",()=>{let{pursuer:o,evader:a}=this.#g.
selected;this.#b=!1,this.#o.payoff.capture_rate[o][a]!==void 0&&(r.showModal(),s||t.start(this.#n),s=!0,t.playSoon())}),r}#$(){let e=`${Gt.pursuer.join(", ")} a\
nd ${Gt.evader.join(", ")}`,t=ae(`Scores against scripts, by generation: ${e}`,(s,o)=>this.#L(s,o),()=>{},s=>{let o=Math.min(this.#o.newest,Math.max(0,Math.round(
s)));this.#g.select({pursuer:o,evader:o})});return this.#h=t.redraw,u("section",{class:"card scores"},u("h3",{},"Against opponents that never change"),u("p",{class:"\
small muted"},"Captures of random walkers and of clumsy fleers; escapes from random walkers and from clumsy chasers."),Ke(["pursuers","of-pursuers"],["evaders",
"of-evaders"]),t.element)}#L(e,t){let{generations:r}=this.settings.schedule,o=se(e,t,{low:0,high:r,label:"generation",whole:!0},{low:0,high:1,label:"score"});for(let a of M){
let i=Array.from(this.#u[a],l=>l??null);oe(o,[...i.keys()],i,`of-${a}s`)}return o}#F(){if(this.#o.newest<0)return;let e=BigInt(this.#o.seeds[0][0]),t=this.#v%this.#o.
payoff.episodes;this.#v+=1;let r=s=>this.#n.match(this.#o.world,...this.#N(s),e,t);this.before.show(r(this.#o.genomesOf(En)),"Before: generation 0"),this.after.
show(r(this.champions),this.#D());for(let s of[this.before,this.after])s.agent!==null&&this.#I(s,!0)}#D(){let{newest:e,best:t}=this.#o;if(e===0)return"Generatio\
n 0: nobody has learned anything yet";let{pursuer:r,evader:s}=t??{pursuer:e,evader:e},o=r===s?`generation ${r}`:`pursuers of generation ${r}, evaders of generat\
ion ${s}`;return t?`After: ${o}`:`Now: ${o}`}#N({pursuer:e,evader:t}){return[this.#o.playing("pursuer",e),this.#o.playing("evader",t)]}#R(e){this.#f.show(this.#o),
this.chases.renew(e)}#_(e,t){for(let r of[this.before,this.after])r!==e&&r.agent!==null&&r.choose(null);this.#c.hidden=!e,e&&(this.#I(e,!0),this.#p.choose(t))}askNext(){
let{match:e,player:t,agent:r}=this.after;if(!e)return;let s=e.n_agents,o=(r??-1)+1,i=Array.from({length:s},(l,c)=>(o+c)%s).find(l=>e.alive[t.step*s+l]);i!==void 0&&
this.after.choose(i)}#I(e,t=!1){if(t){let r=e===this.before,[s,o]=this.#N(r?this.#o.genomesOf(En):this.champions),a=r?0:this.#o.newest;this.#p.show(this.#n,this.#o,
e.match,{run:0,pursuer:a,evader:a,episode:0,seed:null},{pursuers:s,evaders:o})}this.#p.at(e.player.step)}#P(){let{newest:e}=this.#o;this.element.dataset.state=this.
state,this.#r.textContent=wn(this.settings),this.#d.hidden=this.state==="waiting",this.#a.replaceChildren(...this.#W().map(t=>u("span",{},t))),this.element.dataset.
newest=String(e),this.dispatchEvent(new Event("state"))}#W(){let{newest:e}=this.#o;if(this.outcome)return[this.outcome.sentence];if(e<0)return[];let t=a=>{let i=this.#i.
get(`${a} ${a}`);return i?E(i.capture_rates):null};if(this.state==="waiting"||e<1){let a=t(0)??this.#f.rate(this.#o.genomesOf(En),En),i=`${B(a)} of the evaders \
are caught.`;return a>bu?[i,wu]:[i]}let r=`Generation ${e} of ${this.settings.schedule.generations}`,s=t(e)??t(e-1),o=t(0);return s===null||o===null?[`${r}.`]:[
`${r}: the pursuers catch ${B(s)} of the evaders; those of generation 0 caught ${B(o)}.`]}#U(){let{outcome:e}=this;if(this.#l.hidden=!e,this.#l.ariaLabel=`What \
came out. ${wn(this.settings)}`,!e)return;let t=this.#i.get(`${this.#o.newest} ${this.#o.newest}`),r=[["Score against scripts: generation 0",s=>B(this.#u[s][0]??
0)],["Score against scripts: newest generation",s=>B(this.#u[s].at(-1)??0)],["Collisions at fault in 1000 moves of the newest generation",(s,o)=>xu(t,o).toFixed(
1)]];this.#l.replaceChildren(u("h3",{},"In numbers"),...M.map(s=>u("p",{},si(s,e.teams[s]))),u("table",{class:"numbers"},u("thead",{},u("tr",{},u("td"),...M.map(
s=>u("th",{scope:"col",class:s},`${s}s`)))),u("tbody",{},...r.map(([s,o])=>u("tr",{},u("th",{scope:"row"},s),...M.map((a,i)=>u("td",{},o(a,i))))))),u("p",{class:"\
small muted"},"One race proves little: save it, and ",u("code",{},"matrixworld judge")," says what happened on its way, and how surely."))}};function xu({means:{
faults:n,agent_steps:e}},t){let r=n.length/M.length;return 1e3*n.slice(t*r,(t+1)*r).reduce((s,o)=>s+o,0)/Math.max(1,e[t])}function Su(n,e,...t){return u("section",{class:"card panel","aria-label":n},u("header",{},u("h2",{},n),u("p",{class:"small muted"},e)),...t)}var Mu={present:"●",
absent:"○","cannot tell":"?"};function ui(n){let{findings:e}=n;if(!e?.table.length)return null;let[,...t]=e.table,r=t.map(([o,a,i,l],c)=>{let m=a==="told"?"":
Tu(e.reasons[c]??"");return u("li",{class:`finding ${a.replace(" ","-")}`},u("span",{class:"sign","aria-hidden":"true"},Mu[a]??""),u("div",{},u("p",{},u("strong",
{},o),` ${a}`,u("span",{class:"muted"},` · ${l}`)),m?u("p",{class:"small"},`${m}.`):null,u("p",{class:"small muted numbers"},i)))}),s=Su("What happened","Each \
condition is present, absent, or its 95 % interval cannot tell. The intervals are about this run.",u("p",{class:"headline"},e.sentence),u("ul",{class:"findings"},
...r),...Au(e.refused??{}),n.limits?u("p",{class:"small"},n.limits):null);return s.classList.add("diagnosis"),{element:s}}function Au(n){return[...new Set(Object.
values(n))].map(t=>{let r=Object.keys(n).filter(s=>n[s]===t);return u("p",{class:"small muted"},`Not judged, because ${t}: ${r.join(", ")}.`)})}function Tu(n){let[
,e=""]=n.split(/, because (.*)/s);return de(e.replace(/\.$/,""))}var Eu=84;function di(n,e){let t=n.map((o,a)=>Cu(o,a,e)),r=u("nav",{class:"races","aria-label":"Runs"},...t.map(o=>o.button)),s=()=>t.forEach((o,a)=>o.update(a===
e.selected.run));return e.on("match hover",s),s(),r.hidden=n.length<2,r}function Cu(n,e,t){let[r,s]=n.payoff.shape,o=!n.name.startsWith(n.schedule),a=Eu/Math.max(
r,s),i=u("canvas",{"aria-hidden":"true"});Ye(i,n.payoff,{left:0,top:0,width:s*a,height:r*a});let l=u("span",{class:"place"}),c=u("button",{type:"button",class:"\
race",title:`${n.name} (key ${e+1})`,onclick:()=>ku(n,e,t)},u("span",{class:"small-matrix"},i,l),u("span",{class:"race-text"},u("strong",{},o?n.name:n.schedule),
u("span",{class:"small"},n.findings?n.findings.sentence:`${n.learning.map(d=>ne(n).teams[d]).join(" and ")} against ${Ou(n)}`),u("span",{class:"small muted"},`${o?
`${n.schedule}, `:""}seed ${n.seed}`)));return{button:c,update:d=>{c.setAttribute("aria-current",String(d));let h=t.hover.pursuer??t.selected.pursuer,p=t.hover.
evader??t.selected.evader;l.hidden=h>=r||p>=s,l.style.left=`${(p+.5)*a}px`,l.style.top=`${(r-h-.5)*a}px`}}}var Ou=n=>n.teams.pursuer.script??n.teams.evader.script??
"another run";function ku(n,e,t){let[r,s]=n.payoff.shape,{pursuer:o,evader:a}=t.selected;t.select({run:e,pursuer:Math.min(o,r-1),evader:Math.min(a,s-1)})}var mi=1,Ru="meadow";function hi({runs:n},e){let t=n[mi],{shape:[r,s],episodes:o}=t.payoff,a=new $e,i=0;return e.then(l=>{let c=new Qe(()=>a.show(Dt(l,t,{run:mi,
pursuer:r-1,evader:s-1,episode:i++%o,seed:null}),`Generation ${r-1} of both teams`),a);c.renew(),Or(c,a.element)}),u("div",{class:"widget"},a.element,Ve(a.player),
vn())}function pi({evolve:n},e,{grows:t=!1}){let r=u("button",{type:"button",class:"evolve",disabled:!0},"Evolve"),s=u("progress",{max:1,value:0,"aria-label":"P\
rogress of the race"}),o=u("div",{class:"lanes","data-count":1});return e.then(a=>{let i=-1,l=()=>Ca(n,{...Ea(n,Ru),policy:"cells",seed:Math.max(0,i)}),c=new Cn(
n,a,"lesson",l()),m=()=>{r.textContent=c.state==="waiting"?"Evolve":c.state==="evolving"?"Stop":"Again, with other luck",s.value=c.done};r.addEventListener("cli\
ck",()=>{if(c.state==="evolving")return c.stop();i++,c.start(l())}),c.addEventListener("state",m),t&&(c.element.querySelector("details").open=!0),o.append(c.element),
Or(c.chases,c.boards),r.disabled=!1}),u("div",{class:`widget evolving ${t?"grows":"boards"}`},u("div",{class:"buttons"},r,s),o)}function fi({runs:n,playground:e},t){
let r=n[0].payoff.shape.map(c=>c-1),s=new st({run:0,pursuer:r[0],evader:r[1],episode:0,seed:null}),o=new nt(n,s,e),a=new rt(n,s);o.actions.remove(),a.element.addEventListener(
"play",()=>{o.playSoon(),o.reveal()}),t.then(c=>o.start(c));let{seed:i}=n[0],l=n[0].world;return u("div",{class:"widget wide"},di(n,s),u("div",{class:"stages"},
a.element,o.element),u("p",{class:"small muted"},"Three races of ",u("code",{},`matrixworld evolve --seed ${i}`),`: ${l.n_pursuers} pursuers and ${l.n_evaders} \
evaders on ${l.rows} x ${l.cols} cells.`))}function gi({runs:n}){let e=n[0],t=n[0].findings,[r,...s]=t.table,o=s.findIndex(([i])=>i==="arms race"),a={sentence:e.
name,table:[r,s[o]],reasons:[t.reasons[o]]};return u("div",{class:"widget text"},ui({...e,findings:{...t,...a}}).element)}var Lr=()=>{let[n]=crypto.getRandomValues(new Uint32Array(1));return{pupil:n.toString(16).padStart(8,"0"),choices:[],solved:{},exit:"",done:!1}},On=class extends EventTarget{#e;#n;#t;keeps=!0;constructor(e){
super(),this.#n=e,this.#t=`matrixworld lesson ${e}`,this.#e=this.#r(),this.#a({})}choice=e=>this.#e.choices.find(({prediction:t})=>t===e)?.choice;choose(e,t){let r=new Date().
toISOString().replace(/\.\d+Z$/,"+00:00");this.#a({choices:[...this.#e.choices,{prediction:e,choice:t,time:r}]}),this.dispatchEvent(new CustomEvent("choice",{detail:e}))}solved=e=>this.#e.
solved[e];solve=(e,t)=>this.#a({solved:{...this.#e.solved,[e]:t}});get exit(){return this.#e}set exit(e){this.#a(e)}get count(){return this.#e.choices.length}get file(){
let{choices:e,pupil:t}=this.#e;return e.map(r=>`${JSON.stringify({...r,edition:this.#n,pupil:t})}
`).join("")}forget=()=>this.#a(Lr());#r(){try{return{...Lr(),...JSON.parse(localStorage.getItem(this.#t)??"{}")}}catch{return Lr()}}#a(e){this.#e={...this.#e,...e};
try{localStorage.setItem(this.#t,JSON.stringify(this.#e))}catch{this.keeps=!1}}};function yi(n,e){let t=[],r=[];for(let i of n)try{r.push({...i,...Pu(i.text,e)})}catch(l){t.push({file:i.name,reason:l.message})}let s=new Map([...e.predictions].
map(([i,{options:l}])=>[i,new Map(Object.keys(l).map(c=>[c,0]))])),o=new Map,a=new Map;for(let{name:i,text:l,pupil:c,choices:m}of r.sort((d,h)=>h.choices.size-d.
choices.size)){let d=[...m].filter(([p])=>!o.has(`${c} ${p}`)),h=a.get(l)??(d.length?void 0:o.get(`${c} ${[...m.keys()][0]}`));if(h!==void 0){t.push({file:i,reason:a.
has(l)?`double: the same content as ${h}`:`double: the pupil of ${h}`});continue}a.set(l,i);for(let[p,f]of d)o.set(`${c} ${p}`,i),s.get(p).set(f,s.get(p).get(f)+
1)}return{counts:s,pupils:new Set([...o.keys()].map(i=>i.split(" ")[0])).size,left:t}}function Pu(n,{edition:e,predictions:t}){if(n===null)throw new Error("expe\
cted at most 65536 bytes");let r=new Map,s="",o=n.split(/\r?\n/).filter(a=>a.trim());if(!o.length)throw new Error("expected predictions that the lesson has save\
d, got an empty file");return o.forEach((a,i)=>{let l=$u(a),{prediction:c,choice:m}=l;if(typeof c!="string"||typeof m!="string")throw new Error(`line ${i+1}: ex\
pected a prediction and its choice`);if(l.edition!==e)throw new Error(`line ${i+1}: expected edition ${e} of the course, got ${Fr(l.edition)}`);let d=t.get(c)?.
options;if(!d)throw new Error(`line ${i+1}: expected a prediction of the lesson, got ${Fr(c)}`);if(!Object.hasOwn(d,m))throw new Error(`line ${i+1}: expected on\
e of ${Object.keys(d).join(", ")} for ${c}, got ${Fr(m)}`);if(s||=String(l.pupil??""),!/^[0-9a-f]{8}$/.test(s)||l.pupil!==s)throw new Error(`line ${i+1}: expect\
ed lines of one pupil`);r.has(c)||r.set(c,m)}),{pupil:s,choices:r}}function $u(n){try{let e=JSON.parse(n);return typeof e=="object"&&e!==null?e:{}}catch{return{}}}
var Fr=n=>n===void 0?"none":JSON.stringify(n).slice(0,40);function vi(n){let e={edition:n.edition,predictions:Yt(n)},t=u("p",{role:"status"}),r=u("ul",{class:"left"}),s=u("div",{class:"questions"}),o=new Set,a=[],i=()=>{
let h=yi(a,e);t.textContent=a.length?`${a.length} ${a.length===1?"file":"files"}, ${h.pupils} ${h.pupils===1?"pupil":"pupils"}.${h.left.length?" Not counted:":""}`:
"No files yet.",r.replaceChildren(...h.left.map(({file:p,reason:f})=>u("li",{},u("strong",{},p),` ${f}`))),s.replaceChildren(...[...e.predictions.values()].map(
p=>Iu(p,h,o,i)))},l=async h=>{let p=[...h].map(async f=>({name:f.name,text:f.size>65536?null:await f.text()}));a=[...a,...await Promise.all(p)],i()},c=u("input",
{type:"file",multiple:!0,accept:".jsonl",id:"vote-files",onchange:()=>{l(c.files).then(()=>c.value="")}}),m=u("button",{type:"button",onclick:()=>{a=[],o.clear(),
i()}},"Remove all files"),d=u("section",{class:"card drop","aria-label":"Files"},u("p",{},u("label",{for:"vote-files"},"Drop the files that your pupils have sav\
ed anywhere on this page, or choose them: ")),c,u("div",{class:"buttons"},t,m),r,u("p",{class:"small muted"},"A pupil saves predictions.jsonl at the end of the \
lesson. Names of files do not matter. Each pupil counts once: a second file of a pupil is named as double. Nothing leaves this computer."));document.addEventListener(
"dragover",h=>h.preventDefault()),document.addEventListener("drop",h=>{h.preventDefault(),l(h.dataTransfer?.files??[])}),document.getElementById("page").replaceWith(
qt("How the class voted",u("span",{},`${n.title} `,u("a",{href:"#"},"Back to the lesson"))),u("main",{},d,s),u("footer",{class:"small muted"},`matrixworld ${n.version}\
, edition ${n.edition} of the course`)),i()}function Iu(n,e,t,r){let{predict:s,options:o,outcome:a}=n,i=e.counts.get(s),l=[...i.values()].reduce((p,f)=>p+f,0),c=t.
has(s),m=n.again?e.counts.get(n.again):void 0,d=Object.entries(o).map(([p,f])=>{let y=u("span",{class:"filled"});y.style.width=`${100*i.get(p)/Math.max(1,l)}%`;
let g=c&&p===a;return u("li",{class:g?"vote right":"vote"},u("span",{},`${p}. ${f}`,g&&u("strong",{}," ✓ the outcome")),u("span",{class:"bar","aria-hidden":"t\
rue"},y),u("span",{class:"numbers"},`${i.get(p)} of ${l}`,m&&u("span",{class:"muted"},`, at first ${m.get(p)}`)))}),h=u("button",{type:"button",id:`outcome-${s}`,
onclick:()=>{t.add(s),r()}},"Show the outcome");return u("section",{class:"card question",id:`votes-${s}`},u("h2",{},n.question),u("ul",{class:"of-votes"},...d),
n.later?u("p",{class:"muted"},n.later):c?u("div",{class:"reply"},...Ot(n.explanation??"")):u("div",{},h))}var bi="#votes",Nu=["explorer"],Lu=n=>"needs"in n?n.needs:void 0,kn=n=>"widget"in n;function Fu(n){let e=[];for(let t of n){let r=e.at(-1);!r||"text"in t||kn(t)&&
r.some(kn)?e.push([t]):r.push(t)}return e}function Du(n){let e=n.find(kn);return e&&n.length>1&&!Nu.includes(e.widget)&&!e.grows?"block beside":"block"}var Dr=class{#e;#n;#t=()=>{};#r=new Promise(
e=>this.#t=e);#a={chase:()=>hi(this.#e,this.#r),evolving:e=>pi(this.#e,this.#r,e),"right-of-way":Jo,flat:Zo,hands:oa,"hands-matrix":aa,games:da,numbers:ma,matrices:()=>Ko(
this.#e),explorer:()=>fi(this.#e,this.#r),judgement:()=>gi(this.#e),"same-diagonal":Yo,exit:e=>va(e,this.#n)};constructor(e){this.#e=e,this.#n=new On(e.edition);
let t=this.#n,r=Yt(e).size,s=u("span",{class:"small muted",role:"status"}),o=()=>{let i=t.keeps?"They stay in this browser.":"This browser keeps nothing: save b\
efore you close the page.";s.textContent=`${t.count} of ${r} predictions made. ${i}`};t.addEventListener("choice",o);let a=()=>{confirm("Delete all predictions \
and answers in this browser, for another student? Save them first.")&&(t.forget(),location.reload())};document.getElementById("page").replaceWith(qt(e.title,e.lead),
u("nav",{class:"sections","aria-label":"Sections"},...e.sections.map((i,l)=>u("a",{href:`#${i.id}`},`${l+1}. ${i.title}`))),u("main",{},...e.sections.map((i,l)=>this.#l(
i,l))),u("footer",{class:"card"},u("div",{class:"buttons"},u("button",{type:"button",class:"primary save",onclick:()=>Vt("predictions.jsonl",t.file)},"Save my p\
redictions"),u("button",{type:"button",onclick:()=>print()},"Print"),u("button",{type:"button",onclick:a},"Start anew"),s),u("p",{class:"small muted"},`The page\
 sends nothing anywhere. matrixworld ${e.version}, edition ${e.edition} of the course. Teachers: `,u("a",{href:bi},"count the votes of a class"),"."))),o()}async load(){
this.#t(await Ft())}#s(e){return"text"in e?u("div",{class:"text"},...Ot(e.text)):kn(e)?this.#a[e.widget](e):"exercise"in e?ya(e,this.#n):ga(e,this.#n)}#l(e,t){let{
sections:r}=this.#e,s=u("p",{class:"waiting muted",role:"status"}),o=u("section",{class:"card",id:e.id,"aria-labelledby":`title-${e.id}`},u("h2",{id:`title-${e.
id}`},`${t+1}. ${e.title}`,u("span",{class:"muted small"},`${e.minutes} minutes`)),s),a=Fu(e.parts),i=a.map(d=>u("div",{class:Du(d)})),l=a.flatMap((d,h)=>d.map(
()=>i[h])),c=0,m=()=>{for(s.textContent="";c<e.parts.length;c++){let d=e.parts[c-1],h=e.parts[c],p=[Kt(d)?d.predict:void 0,Lu(h)].find(f=>f&&this.#n.choice(f)===
void 0);if(p){let f=r.findIndex(({parts:y})=>y.some(g=>Kt(g)&&g.predict===p));s.textContent=`This section goes on with your prediction${f===t?"":` in section ${f+
1}`}.`;return}s.before(l[c]),l[c].append(this.#s(h))}s.remove()};return this.#n.addEventListener("choice",m),m(),o}};function Wu(){let n=Js(),e=()=>location.hash===
bi,t=e();if(window.addEventListener("hashchange",()=>e()!==t&&location.reload()),t)return void ir(Promise.resolve(vi(n)));let r=new Dr(n);requestAnimationFrame(
()=>setTimeout(()=>ir(r.load())))}typeof document>"u"?ar(globalThis):Wu();})();
