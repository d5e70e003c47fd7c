/* built from web/ by "npm run build"; sources bd4a93ceb1aee10cff0299ec78a63fb00f6f429754408371650a49a997e8f2d0 */
"use strict";(()=>{var ys={SIMULTANEOUS:0,SWARM_TURNS:1,AGENT_TURNS:2},wt={DISAPPEAR:0,REACH:1,BOUNCE:2},vs={OCCUPATION:0,SURROUND:1},bs={FAULT:0,INVOLVED:1};var sn=["obstacle","teammate","adversary"],on=["vertex","edge","chain"],ws=["turn","kind","form","first","second","row","col","at_fault","held","doomed"],an=["p\
ursuer_{number}","evader_{number}"],xs={obstacle:"{first} ran into the obstacle or border at {cell}",vertex:"{first} and {second} both headed for {cell}",edge:"\
{first} and {second} meant to swap, {first} to {cell}",chain:"{first} headed for {cell}, where {second} had to stay"},xt={"both held":"both bounce","both doomed":"\
both disappear",held:"{agent} bounces",doomed:"{agent} disappears",none:"nobody is stopped"},Ss="{event}: {outcome}",ln={random:"any action, all equally likely",
still:"always stays",chaser:"moves to where the nearest adversary in view is nearest",fleer:"moves to where the nearest adversary in view is farthest","clumsy-c\
haser":"a chaser that takes any action in half of the steps",hunter:"a chaser of the nearest adversary in view to which no teammate in view is nearer",surrounder:"\
a chaser of the nearest free cell beside an adversary without a teammate","clumsy-fleer":"a fleer that takes any action in half of the steps",dodger:"moves to w\
here all adversaries in view together are farthest","team-surrounder":"shares the free cells beside adversaries with its teammates, and searches","careful-rando\
m":"as random, but takes only moves that right of way allows","careful-chaser":"as chaser, but takes only moves that right of way allows","careful-fleer":"as fl\
eer, but takes only moves that right of way allows","careful-clumsy-chaser":"as clumsy-chaser, but takes only moves that right of way allows","careful-hunter":"\
as hunter, but takes only moves that right of way allows","careful-surrounder":"as surrounder, but takes only moves that right of way allows","careful-clumsy-fl\
eer":"as clumsy-fleer, but takes only moves that right of way allows","careful-dodger":"as dodger, but takes only moves that right of way allows","careful-team-\
surrounder":"as team-surrounder, but takes only moves that right of way allows"},_e={adversary:"distance to the nearest adversary (0 to 2, in half views)",pressure:"\
sum over adversaries of 1 / (1 + moves)^2 (0 or more)",unclaimed:"distance to the nearest adversary to which no teammate is nearer than the agent is now; withou\
t one, to the nearest adversary (0 to 2, in half views)",open_side:"distance to the nearest cell beside an adversary that holds no obstacle and no teammate (0 t\
o 2, in half views)",teammate:"distance to the nearest teammate (0 to 2, in half views)",exits:"share of the cells around that are no obstacle (0 to 1)",room:"d\
istance to the nearest obstacle to the north, east, south or west (0 to 1, in half views)",must_yield:"1 if right of way forbids the move (0 to 1)",ahead:"1 if \
it is the direction that the agent draws for each 12 steps (0 to 1)"},As={free:".GS",blocked:"#@OTW"};var Je=1+ws.length;function St(t,e){return t.replace(/\{(\w+)\}/g,(r,n)=>String(e[n]))}function Y(t,e){return t<e?St(an[0],{number:t}):St(an[1],{number:t-e})}function sl(t,e){
let[r,n,s,o,a,i,l,...c]=Array.from(t),d=a<0?[o]:[o,a],[m,p,h]=c.map(x=>d.filter((v,w)=>x>>w&1)),f=d.map(x=>Y(x,e)),g=St(xs[a<0?"obstacle":on[s]],{first:f[0],second:f[f.
length-1],cell:`(${i}, ${l})`}),y=St(Ss,{event:g,outcome:ol(d.length,p,h,e)});return{kind:sn[n],form:on[s],agents:d,cell:[i,l],at_fault:m,held:p,doomed:h,turn:r,
text:y}}function ol(t,e,r,n){if(t===2&&e.length===2)return xt["both held"];if(t===2&&r.length===2)return xt["both doomed"];let s=o=>a=>St(xt[o],{agent:Y(a,n)});
return[...e.map(s("held")),...r.map(s("doomed"))].join(", ")||xt.none}function Zt(t,e){let r=[];for(let n=0;n<t.length;n+=Je)r.push(sl(t.subarray(n+1,n+Je),e));
return r}var Te=class extends Error{name="EngineError"};function N(t,e,r){let n=typeof r=="string"?`'${r}'`:typeof r=="object"?JSON.stringify(r):String(r);return new Te(
`${t}: expected ${e}, got ${n}`)}var Ze=class{bytes;constructor(e){this.bytes=e}},Ts=0,un=[Uint8Array,Uint8Array,Int32Array,BigInt64Array,BigUint64Array,Float32Array,Float64Array],Ms=4,Es=4,al=new TextEncoder,
il=new TextDecoder;function ll(t){for(let e=un.length-1;e>Ts;--e)if(t instanceof un[e])return e;throw new TypeError("array: expected a typed array of the engine\
's numbers, got another")}function cn(t){return new Uint8Array(t.buffer,t.byteOffset,t.byteLength)}function cl(t){return al.encode(`${t}\0`)}var dn=class{engine;addresses=[];constructor(e){
this.engine=e}copy(e){let r=this.engine._malloc(Math.max(e.length,1));if(r===0)throw new Te("memory: expected room for the arguments, got none");return this.addresses.
push(r),this.engine.HEAPU8.set(e,r),r}text(e){return this.copy(cl(e))}arrays(e){let r=Object.entries(e),n=r.flatMap(([o,a])=>{let i=a instanceof Ze,l=i?a.bytes:
a;return[this.text(o),i?Ts:ll(l),l.length,this.copy(cn(l))]}),s=this.copy(cn(Int32Array.from(n)));return this.copy(cn(Int32Array.of(r.length,s)))}free(){for(let e of this.
addresses)this.engine._free(e)}};function ks(t,e){let r=t.HEAPU8;return il.decode(r.subarray(e,r.indexOf(0,e)))}function Xe(t){let e=new Int32Array(t.HEAPU8.buffer),
r=t._last_outputs()/Ms,n=e[r+1]/Ms,s={};for(let o=n;o<n+e[r]*Es;o+=Es){let a=un[e[o+1]],i=e[o+2]*a.BYTES_PER_ELEMENT,l=e[o+3];s[ks(t,e[o])]=new a(t.HEAPU8.slice(
l,l+i).buffer)}return s}function ke(t,e){let r=new dn(t);try{let n=e(r);if(n===0)throw new Te(ks(t,t._last_error()));return n}finally{r.free()}}var ul=2**31-1,Cs=["none","gru"],dl=2n**64n-1n,ml=34028234663852886e22;function oe(t,e){if(typeof e!="number"||!Number.isInteger(e)||Math.abs(e)>ul)throw N(t,"a\
n integer",e);return Int32Array.of(e)}function Xt(t,e){if(typeof e!="boolean")throw N(t,"true or false",e);return new Ze(Uint8Array.of(Number(e)))}function Le(t,e,r){
let n=typeof e=="string"&&Object.hasOwn(r,e)?r[e]:void 0;if(n===void 0)throw N(t,`one of ${Object.keys(r).join(", ")}`,e);return Int32Array.of(n)}function mn(t,e){
if(typeof e!="number"||!(Math.abs(e)<=ml))throw N(t,"a finite number",e);return e}function At(t,e){let n=typeof e=="bigint"||typeof e=="number"&&Number.isSafeInteger(
e)?BigInt(e):-1n;if(n<0n||n>dl)throw N(t,"an integer from 0 to 2^64 - 1",e);return BigUint64Array.of(n)}function pl(t){return{"rules.interaction":Le("interactio\
n",t.interaction,ys),"rules.obstacle":Le("obstacle",t.obstacle,wt),"rules.teammate":Le("teammate",t.teammate,wt),"rules.evader":Le("evader",t.evader,wt),"rules.\
pursuer":Le("pursuer",t.pursuer,wt),"rules.capture":Le("capture",t.capture,vs),"rules.captured_disappear":Xt("captured_disappear",t.captured_disappear)}}function Rs(t,e){
let r=typeof e=="number"?[e,e,e]:e;if(!Array.isArray(r)||r.length!==3)throw N(t,"1 or 3 numbers",e);return Float32Array.from(r,n=>mn(t,n))}function hl(t){let e=(r,n)=>Float32Array.
of(mn(r,t[r]),mn(n,t[n]));return{"rewards.capture":e("pursuer_capture","evader_capture"),"rewards.neighbor":e("pursuer_neighbor","evader_neighbor"),"rewards.ste\
p":e("pursuer_step","evader_step"),"rewards.pursuer_collide":Rs("pursuer_collide",t.pursuer_collide),"rewards.evader_collide":Rs("evader_collide",t.evader_collide),
"rewards.blame":Le("blame",t.blame,bs),"rewards.capture_repeats":Xt("capture_repeats",t.capture_repeats)}}function Ps(t){if(t===void 0||typeof t=="number")return new Uint8Array(
0);if(t instanceof Uint8Array)return t;let{free:e,blocked:r}=As;for(let[n,s]of t.entries()){if(s.length!==t[0]?.length)throw N(`map, row ${n}`,`${t[0]?.length} \
cells as in row 0`,s.length);let o=[...s].find(a=>!e.includes(a)&&!r.includes(a));if(o)throw N(`map, row ${n}`,`'${e}' (free) or '${r}' (obstacle)`,o)}return Uint8Array.
from([...t.join("")],n=>Number(r.includes(n)))}function _s(t,e){if(!Array.isArray(t))return;let r=[t.length,t[0]?.length??0];if(!(r[0]===e.rows&&r[1]===e.cols))
throw N("obstacle map",`shape (${e.rows}, ${e.cols}), the rows and cols`,r)}function Qe(t){_s(t.obstacles,t);let e=typeof t.obstacles=="number"?t.obstacles:0;return{
...pl(t.rules),...hl(t.rewards),rows:oe("rows",t.rows),cols:oe("cols",t.cols),n_pursuers:oe("n_pursuers",t.n_pursuers),n_evaders:oe("n_evaders",t.n_evaders),fov:oe(
"fov",t.fov),diagonal:Xt("diagonal",t.diagonal),max_steps:oe("max_steps",t.max_steps),density:Float64Array.of(e),map:Ps(t.obstacles)}}function Os(t,e){return Int32Array.
from((e??[]).flat(),r=>oe(t,r)[0])}function Ls(t,e){return _s(t.obstacles,e),{seed:At("seed",t.seed??0n),episode:At("episode",t.episode??0),pursuers:Os("pursuer\
s",t.pursuers),evaders:Os("evaders",t.evaders),map:Ps(t.obstacles)}}function Qt(t){return{actions:Int32Array.from(t,e=>oe("actions",e)[0])}}var $s=Object.keys(_e);
function pn(t){let e=$s.indexOf(t);if(e<0)throw N("inputs",`names of ${$s.join(", ")}`,t);return e}function Ne(t){if(typeof t=="string"){if(!Object.hasOwn(ln,t))
throw N("policy",`one of ${Object.keys(ln).join(", ")}`,t);return{script:new TextEncoder().encode(t)}}if(t.kind!=="cells")return{inputs:Int32Array.from(t.inputs,
e=>pn(e)),hidden:Int32Array.from(t.kind==="rating"?t.hidden:[],e=>oe("hidden",e)[0]),length:oe("length",t.kind==="program"?t.length:0),mask:new TextEncoder().encode(
t.mask),genome:t.genome};if(t.activation!=="relu"&&t.activation!=="tanh")throw N("activation","'relu' or 'tanh'",t.activation);if(!Cs.includes(t.memory))throw N(
"memory",`one of ${Cs.join(", ")}`,t.memory);return{hidden:Int32Array.from(t.hidden,e=>oe("hidden",e)[0]),activation:new TextEncoder().encode(t.activation),sampled:Xt(
"sampled",t.sampled),memory:new TextEncoder().encode(t.memory),genome:t.genome}}var fl=["first_turn","terminated","truncated"];function Ns(t){let e={...t};for(let r of fl)
e[r]=new Ze(t[r]);return e}var Is="statistics.",er=class{config;seed;episode;n_agents;statistics;first_conflict;constructor(e,r,n,s){this.config=e,this.seed=r,this.episode=n,this.n_agents=
e.n_pursuers+e.n_evaders,this.statistics=yl(Fs(s)),Object.assign(this,s),this.first_conflict=gl(this.conflict_table,this.length)}get length(){return this.actions.
length/this.n_agents}conflicts(e){this.check(e);let[r,n]=[this.first_conflict[e],this.first_conflict[e+1]],s=this.conflict_table.subarray(r*Je,n*Je);return Zt(s,
this.config.n_pursuers)}seek(e,r,n){this.check(r),(!(e.seed===this.seed&&e.episode===BigInt(this.episode))||e.turn!==0||e.steps>r)&&e.reset({seed:this.seed,episode:this.
episode});for(let o=e.steps;o<r;++o){let a=this.actions.subarray(o*this.n_agents,(o+1)*this.n_agents);n?e.replay(a,{pursuer:n.pursuers,evader:n.evaders}):e.step(
a)}}check(e){if(!(Number.isInteger(e)&&e>=0&&e<=this.length))throw N("step",`0 to ${this.length}`,e)}};function gl(t,e){let r=new Int32Array(e+2);for(let n=0;n<
t.length;n+=Je)++r[t[n]+1];for(let n=1;n<r.length;++n)r[n]+=r[n-1];return r}function yl(t){let e=["capture_rate","ever_capture_rate","captured_fraction","length"];
return Object.fromEntries(Object.entries(t).map(([r,n])=>[r,e.includes(r)?Number(n[0]):n]))}var Fs=t=>Object.fromEntries(Object.entries(t).flatMap(([e,r])=>e.startsWith(
Is)?[[e.slice(Is.length),r]]:[]));function Us(t,e,r,n){let s=[Qe(r.config),Ne(r.pursuers),Ne(r.evaders),n];return ke(t,o=>{let[a,i,l,c]=s.map(d=>o.arrays(d));return t[e](
a,i,l,c)}),Xe(t)}function Ws(t,e,r,n){let s={seed:At("seed",r),episode:At("episode",n)};return new er(e.config,r,n,Us(t,"_play_match",e,s))}function Ds(t,e,r,n){
if(!Number.isInteger(n)||n<1)throw N("n_episodes","at least 1",n);let s=Us(t,"_play_rollout",e,{...r,n_episodes:Int32Array.of(n)});return Fs(s)}var vl=7e6,bl=new FinalizationRegistry(([t,e])=>t._states_free(e));function wl({rules:t,rows:e,cols:r,obstacles:n,diagonal:s,n_pursuers:o,n_evaders:a}){let i=typeof n==
"number"||t.obstacle==="REACH"?0:n.join("").split("#").length-1,l=e*r-i,c=[t.obstacle,t.teammate,t.pursuer].includes("DISAPPEAR"),d=t.capture==="SURROUND"||t.evader===
"REACH",m=t.interaction==="AGENT_TURNS",p=(g,y)=>Array.from({length:y},(x,v)=>m?g:(g+v)/(v+1)).reduce((x,v)=>x*v,1),h=p(l+Number(c),o)*p(l*(1+Number(d))+2,a);return{
SIMULTANEOUS:[o+a],SWARM_TURNS:[o,a],AGENT_TURNS:Array(o+a).fill(1)}[t.interaction].reduce((g,y)=>g+h*(s?9:5)**y,0)}function tr(t){return typeof t.obstacles=="n\
umber"&&t.obstacles>0?"obstacles are drawn anew in each episode":wl(t)>vl?"the world is too large to be solved on the page":""}var hn=class{value;teams;matrix;n_actions;constructor(e,r){
let{matrix:n,rows:s,cols:o,value:a,agents:i}=r,[l,c]=e.actors,d=Array.from(i).filter(p=>l<=p&&p<c),m=p=>p<e.config.n_pursuers;[this.value,this.matrix,this.n_actions]=
[a[0],n,e.n_actions],this.teams=[{agents:d.filter(m),play:s},{agents:d.filter(p=>!m(p)),play:o}]}marginal(e){let r=this.teams.find(({agents:o})=>o.includes(e));
if(!r)return null;let n=this.n_actions**(r.agents.length-1-r.agents.indexOf(e)),s=Array(this.n_actions).fill(0);return r.play.forEach((o,a)=>s[Math.floor(a/n)%this.
n_actions]+=o),s}lost(e){let[r,n]=this.teams.map(({agents:l})=>l.reduce((c,d)=>c*this.n_actions+e[d],0)),[s,o]=this.teams.map(({play:l})=>l),a=o.reduce((l,c,d)=>l+
c*this.matrix[r*o.length+d],0),i=s.reduce((l,c,d)=>l+c*this.matrix[d*o.length+n],0);return[Math.max(0,this.value-a),Math.max(0,i-this.value)]}},fn=60,Mt=class{config;payoff;engine;states;n_turns;values;constructor(e,r,n){
[this.engine,this.config,this.payoff]=[e,r,n],this.states=ke(e,i=>e._states_new(i.arrays(Qe(r)))),bl.register(this,[e,this.states]);let s={SIMULTANEOUS:1,SWARM_TURNS:2,
AGENT_TURNS:r.n_pursuers+r.n_evaders};this.n_turns=s[r.rules.interaction];let{payoffs:o}=this.call(()=>e._states_payoffs(this.states)),a=o;this.values=[[n==="ca\
pture-rate"?a:a.fill(0)]]}goBack(){let e=this.values.at(-1)[0],r=[];for(let s=this.n_turns-1;s>=0;s--){let o=r[s+1]??e;r[s]=this.backup(s,{next:o})}this.payoff===
"capture-time"&&(r[0]=r[0].map((s,o)=>o===this.config.n_evaders?0:s-1)),this.values.push(r);let n=this.payoff==="capture-rate"?this.config.max_steps:Math.min(this.
config.max_steps,fn);return this.values.length<=n&&r[0].some((s,o)=>s!==e[o])}backup(e,r){return this.call(n=>this.engine._states_backup(this.states,e,n.arrays(
r))).values}game(e){let[r,{turn:n}]=[this.config.max_steps-e.steps,e],s=n+1===this.n_turns,o=r>0?this.values[Math.min(r-Number(s),this.values.length-1)]?.[s?0:n+
1]:void 0;if(!o)return null;let a=this.call(i=>this.engine._states_game(this.states,e.address,i.arrays({next:o})));return a.agents.length?new hn(e,a):null}call(e){
return ke(this.engine,e),Xe(this.engine)}};var zs=new FinalizationRegistry(([t,e])=>t._world_free(e)),Et=class{config;n_agents;n_actions;engine;at;freed=!1;constructor(e,r){this.engine=e,this.config=r,this.
n_agents=r.n_pursuers+r.n_evaders,this.n_actions=r.diagonal?9:5,this.at=ke(e,n=>e._world_new(n.arrays(Qe(r)))),zs.register(this,[e,this.at],this)}free(){this.freed||
(this.freed=!0,zs.unregister(this),this.engine._world_free(this.at))}get address(){if(this.freed)throw N("world","one that is in use","one that was freed");return this.
at}reset(e={}){let r=Ls(e,this.config);this.call(n=>this.engine._world_reset(this.address,n.arrays(r)))}step(e){let r=Qt(e);this.call(n=>this.engine._world_step(
this.address,n.arrays(r)))}playTurn(e){let r=Qt(e);this.call(n=>this.engine._world_play_turn(this.address,n.arrays(r)))}decide(e,r,n){let{n_pursuers:s}=this.config,
o={pursuer:[0,s],evader:[s,this.n_agents]},[a,i]=typeof r=="string"?o[r]:r;if(n.length!==this.n_agents)throw N("actions",String(this.n_agents),n.length);let l=[
Ne(e),Qt(n)],{actions:c}=this.call(d=>this.engine._world_decide(this.address,d.arrays(l[0]),a,i,d.arrays(l[1])));return Uint8Array.from(c)}replay(e,r){let n=o=>typeof o!=
"string"&&o.kind==="cells"&&o.memory!=="none";if(!n(r.pursuer)&&!n(r.evader))return this.step(e);let{n_pursuers:s}=this.config;for(let o=this.n_turns;o>0;--o){let[
a,i]=this.actors;a<s&&this.decide(r.pursuer,[a,Math.min(i,s)],e),i>s&&this.decide(r.evader,[Math.max(a,s),i],e),this.playTurn(e)}}get n_turns(){return this.turnNumbers()[1]}get turn(){
return this.turnNumbers()[0]}get actors(){let[,,e,r]=this.turnNumbers();return[e,r]}turnNumbers(){return this.call(()=>this.engine._world_turn(this.address)).turn}get steps(){
return this.read("steps")[0]}get seed(){return this.read("seed")[0]}get episode(){return this.read("episode")[0]}get over(){return this.read("terminated")[0]===
1||this.read("truncated")[0]===1}read(e){return this.call(r=>this.engine._world_read(this.address,r.text(e)))[e]}view(e){let r=3*this.config.fov**2;return this.
read("views").slice(e*r,(e+1)*r)}map(){return this.read("state").slice(2*this.config.rows*this.config.cols)}conflicts(){return Zt(this.conflictTable(),this.config.
n_pursuers)}conflictTable(){return this.call(()=>this.engine._world_conflicts(this.address)).conflict_table}answer(e,r){let n=Ne(e),{logits:s,memory:o}=this.call(
l=>this.engine._world_logits(this.address,l.arrays(n),r)),a=s,i=this.decide(e,[r,r+1],new Uint8Array(this.n_agents))[r];return{logits:a,probabilities:xl(a),action:i,
memory:o}}rate(e,r){let n=Ne(e),{ratings:s,refused:o}=this.call(c=>this.engine._world_rate(this.address,c.arrays(n),r)),a=this.read("inputs"),i=a.length/this.n_agents/
this.n_actions,l=c=>Float32Array.from({length:this.n_actions},(d,m)=>a[(r*this.n_actions+m)*i+c]);return{inputs:e.inputs.map(c=>l(pn(c))),ratings:s,refused:o}}snapshot(){
return this.call(()=>this.engine._world_snapshot(this.address))}restore(e){let r=Ns(e);this.call(n=>this.engine._world_restore(this.address,n.arrays(r)))}call(e){
return ke(this.engine,e),Xe(this.engine)}};function xl(t){let e=Math.max(...t),r=Array.from(t,s=>Math.exp(s-e)),n=r.reduce((s,o)=>s+o,0);return Float32Array.from(
r,s=>s/n)}var gn=class{compiled;constructor(e){this.compiled=e}world(e){return new Et(this.compiled,e)}solution(e,r="capture-rate"){return new Mt(this.compiled,e,r)}match(e,r,n,s,o=0){
return Ws(this.compiled,{config:e,pursuers:r,evaders:n},s,o)}rollouts(e,r,n,s,o){return Ds(this.compiled,{config:e,pursuers:r,evaders:n},s,o)}},Hs;function rr(t=globalThis.
matrixworldEngine){return Hs??=Sl(t),Hs}async function Sl(t){if(!t)throw new Error("matrixworldEngine: expected the script engine.js before this one, got none");
let e=Uint8Array.from(atob(t.binary),r=>r.charCodeAt(0));return new gn(await t({wasmBinary:e}))}var L=Uint8Array,Q=Uint16Array,En=Int32Array,sr=new L([0,0,0,0,0,0,0,0,1,1,1,1,2,2,2,2,3,3,3,3,4,4,4,4,5,5,5,5,0,0,0,0]),or=new L([0,0,0,0,1,1,2,2,3,3,4,4,5,5,6,
6,7,7,8,8,9,9,10,10,11,11,12,12,13,13,0,0]),wn=new L([16,17,18,0,8,7,9,6,10,5,11,4,12,3,13,2,14,1,15]),Ys=function(t,e){for(var r=new Q(31),n=0;n<31;++n)r[n]=e+=
1<<t[n-1];for(var s=new En(r[30]),n=1;n<30;++n)for(var o=r[n];o<r[n+1];++o)s[o]=o-r[n]<<5|n;return{b:r,r:s}},Ks=Ys(sr,2),Js=Ks.b,xn=Ks.r;Js[28]=258,xn[258]=28;var Zs=Ys(
or,0),Al=Zs.b,Bs=Zs.r,Sn=new Q(32768);for(T=0;T<32768;++T)xe=(T&43690)>>1|(T&21845)<<1,xe=(xe&52428)>>2|(xe&13107)<<2,xe=(xe&61680)>>4|(xe&3855)<<4,Sn[T]=((xe&65280)>>
8|(xe&255)<<8)>>1;var xe,T,ue=(function(t,e,r){for(var n=t.length,s=0,o=new Q(e);s<n;++s)t[s]&&++o[t[s]-1];var a=new Q(e);for(s=1;s<e;++s)a[s]=a[s-1]+o[s-1]<<1;
var i;if(r){i=new Q(1<<e);var l=15-e;for(s=0;s<n;++s)if(t[s])for(var c=s<<4|t[s],d=e-t[s],m=a[t[s]-1]++<<d,p=m|(1<<d)-1;m<=p;++m)i[Sn[m]>>l]=c}else for(i=new Q(
n),s=0;s<n;++s)t[s]&&(i[s]=Sn[a[t[s]-1]++]>>15-t[s]);return i}),Ce=new L(288);for(T=0;T<144;++T)Ce[T]=8;var T;for(T=144;T<256;++T)Ce[T]=9;var T;for(T=256;T<280;++T)
Ce[T]=7;var T;for(T=280;T<288;++T)Ce[T]=8;var T,Ct=new L(32);for(T=0;T<32;++T)Ct[T]=5;var T,Ml=ue(Ce,9,0),El=ue(Ce,9,1),Tl=ue(Ct,5,0),kl=ue(Ct,5,1),yn=function(t){
for(var e=t[0],r=1;r<t.length;++r)t[r]>e&&(e=t[r]);return e},ae=function(t,e,r){var n=e/8|0;return(t[n]|t[n+1]<<8)>>(e&7)&r},vn=function(t,e){var r=e/8|0;return(t[r]|
t[r+1]<<8|t[r+2]<<16)>>(e&7)},Tn=function(t){return(t+7)/8|0},kn=function(t,e,r){return(e==null||e<0)&&(e=0),(r==null||r>t.length)&&(r=t.length),new L(t.subarray(
e,r))};var Cl=["unexpected EOF","invalid block type","invalid length/literal","invalid distance","stream finished","no stream handler",,"no callback","invalid UTF-8 da\
ta","extra field too long","date not in range 1980-2099","filename too long","stream finishing","invalid zip data"],K=function(t,e,r){var n=new Error(e||Cl[t]);
if(n.code=t,Error.captureStackTrace&&Error.captureStackTrace(n,K),!r)throw n;return n},Rl=function(t,e,r,n){var s=t.length,o=n?n.length:0;if(!s||e.f&&!e.l)return r||
new L(0);var a=!r,i=a||e.i!=2,l=e.i;a&&(r=new L(s*3));var c=function(vt){var bt=r.length;if(vt>bt){var Ke=new L(Math.max(bt*2,vt));Ke.set(r),r=Ke}},d=e.f||0,m=e.
p||0,p=e.b||0,h=e.l,f=e.d,g=e.m,y=e.n,x=s*8;do{if(!h){d=ae(t,m,1);var v=ae(t,m+1,3);if(m+=3,v)if(v==1)h=El,f=kl,g=9,y=5;else if(v==2){var k=ae(t,m,31)+257,R=ae(
t,m+10,15)+4,E=k+ae(t,m+5,31)+1;m+=14;for(var M=new L(E),W=new L(19),I=0;I<R;++I)W[wn[I]]=ae(t,m+I*3,7);m+=R*3;for(var B=yn(W),Ee=(1<<B)-1,J=ue(W,B,1),I=0;I<E;){
var V=J[ae(t,m,Ee)];m+=V&15;var w=V>>4;if(w<16)M[I++]=w;else{var D=0,P=0;for(w==16?(P=3+ae(t,m,3),m+=2,D=M[I-1]):w==17?(P=3+ae(t,m,7),m+=3):w==18&&(P=11+ae(t,m,
127),m+=7);P--;)M[I++]=D}}var q=M.subarray(0,k),z=M.subarray(k);g=yn(q),y=yn(z),h=ue(q,g,1),f=ue(z,y,1)}else K(1);else{var w=Tn(m)+4,S=t[w-4]|t[w-3]<<8,A=w+S;if(A>
s){l&&K(0);break}i&&c(p+S),r.set(t.subarray(w,A),p),e.b=p+=S,e.p=m=A*8,e.f=d;continue}if(m>x){l&&K(0);break}}i&&c(p+131072);for(var yt=(1<<g)-1,re=(1<<y)-1,we=m;;we=
m){var D=h[vn(t,m)&yt],Z=D>>4;if(m+=D&15,m>x){l&&K(0);break}if(D||K(2),Z<256)r[p++]=Z;else if(Z==256){we=m,h=null;break}else{var X=Z-254;if(Z>264){var I=Z-257,_=sr[I];
X=ae(t,m,(1<<_)-1)+Js[I],m+=_}var ce=f[vn(t,m)&re],qe=ce>>4;ce||K(3),m+=ce&15;var z=Al[qe];if(qe>3){var _=or[qe];z+=vn(t,m)&(1<<_)-1,m+=_}if(m>x){l&&K(0);break}
i&&c(p+131072);var Ye=p+X;if(p<z){var Kt=o-z,Jt=Math.min(z,Ye);for(Kt+p<0&&K(3);p<Jt;++p)r[p]=n[Kt+p]}for(;p<Ye;++p)r[p]=r[p-z]}}e.l=h,e.p=we,e.b=p,e.f=d,h&&(d=
1,e.m=g,e.d=f,e.n=y)}while(!d);return p!=r.length&&a?kn(r,0,p):r.subarray(0,p)},Se=function(t,e,r){r<<=e&7;var n=e/8|0;t[n]|=r,t[n+1]|=r>>8},Tt=function(t,e,r){
r<<=e&7;var n=e/8|0;t[n]|=r,t[n+1]|=r>>8,t[n+2]|=r>>16},bn=function(t,e){for(var r=[],n=0;n<t.length;++n)t[n]&&r.push({s:n,f:t[n]});var s=r.length,o=r.slice();if(!s)
return{t:Qs,l:0};if(s==1){var a=new L(r[0].s+1);return a[r[0].s]=1,{t:a,l:1}}r.sort(function(A,k){return A.f-k.f}),r.push({s:-1,f:25001});var i=r[0],l=r[1],c=0,
d=1,m=2;for(r[0]={s:-1,f:i.f+l.f,l:i,r:l};d!=s-1;)i=r[r[c].f<r[m].f?c++:m++],l=r[c!=d&&r[c].f<r[m].f?c++:m++],r[d++]={s:-1,f:i.f+l.f,l:i,r:l};for(var p=o[0].s,n=1;n<
s;++n)o[n].s>p&&(p=o[n].s);var h=new Q(p+1),f=An(r[d-1],h,0);if(f>e){var n=0,g=0,y=f-e,x=1<<y;for(o.sort(function(k,R){return h[R.s]-h[k.s]||k.f-R.f});n<s;++n){
var v=o[n].s;if(h[v]>e)g+=x-(1<<f-h[v]),h[v]=e;else break}for(g>>=y;g>0;){var w=o[n].s;h[w]<e?g-=1<<e-h[w]++-1:++n}for(;n>=0&&g;--n){var S=o[n].s;h[S]==e&&(--h[S],
++g)}f=e}return{t:new L(h),l:f}},An=function(t,e,r){return t.s==-1?Math.max(An(t.l,e,r+1),An(t.r,e,r+1)):e[t.s]=r},Gs=function(t){for(var e=t.length;e&&!t[--e];)
;for(var r=new Q(++e),n=0,s=t[0],o=1,a=function(l){r[n++]=l},i=1;i<=e;++i)if(t[i]==s&&i!=e)++o;else{if(!s&&o>2){for(;o>138;o-=138)a(32754);o>2&&(a(o>10?o-11<<5|
28690:o-3<<5|12305),o=0)}else if(o>3){for(a(s),--o;o>6;o-=6)a(8304);o>2&&(a(o-3<<5|8208),o=0)}for(;o--;)a(s);o=1,s=t[i]}return{c:r.subarray(0,n),n:e}},kt=function(t,e){
for(var r=0,n=0;n<e.length;++n)r+=t[n]*e[n];return r},Xs=function(t,e,r){var n=r.length,s=Tn(e+2);t[s]=n&255,t[s+1]=n>>8,t[s+2]=t[s]^255,t[s+3]=t[s+1]^255;for(var o=0;o<
n;++o)t[s+o+4]=r[o];return(s+4+n)*8},js=function(t,e,r,n,s,o,a,i,l,c,d){Se(e,d++,r),++s[256];for(var m=bn(s,15),p=m.t,h=m.l,f=bn(o,15),g=f.t,y=f.l,x=Gs(p),v=x.c,
w=x.n,S=Gs(g),A=S.c,k=S.n,R=new Q(19),E=0;E<v.length;++E)++R[v[E]&31];for(var E=0;E<A.length;++E)++R[A[E]&31];for(var M=bn(R,7),W=M.t,I=M.l,B=19;B>4&&!W[wn[B-1]];--B)
;var Ee=c+5<<3,J=kt(s,Ce)+kt(o,Ct)+a,V=kt(s,p)+kt(o,g)+a+14+3*B+kt(R,W)+2*R[16]+3*R[17]+7*R[18];if(l>=0&&Ee<=J&&Ee<=V)return Xs(e,d,t.subarray(l,l+c));var D,P,q,
z;if(Se(e,d,1+(V<J)),d+=2,V<J){D=ue(p,h,0),P=p,q=ue(g,y,0),z=g;var yt=ue(W,I,0);Se(e,d,w-257),Se(e,d+5,k-1),Se(e,d+10,B-4),d+=14;for(var E=0;E<B;++E)Se(e,d+3*E,
W[wn[E]]);d+=3*B;for(var re=[v,A],we=0;we<2;++we)for(var Z=re[we],E=0;E<Z.length;++E){var X=Z[E]&31;Se(e,d,yt[X]),d+=W[X],X>15&&(Se(e,d,Z[E]>>5&127),d+=Z[E]>>12)}}else
D=Ml,P=Ce,q=Tl,z=Ct;for(var E=0;E<i;++E){var _=n[E];if(_>255){var X=_>>18&31;Tt(e,d,D[X+257]),d+=P[X+257],X>7&&(Se(e,d,_>>23&31),d+=sr[X]);var ce=_&31;Tt(e,d,q[ce]),
d+=z[ce],ce>3&&(Tt(e,d,_>>5&8191),d+=or[ce])}else Tt(e,d,D[_]),d+=P[_]}return Tt(e,d,D[256]),d+P[256]},Ol=new En([65540,131080,131088,131104,262176,1048704,1048832,
2114560,2117632]),Qs=new L(0),$l=function(t,e,r,n,s,o){var a=o.z||t.length,i=new L(n+a+5*(1+Math.ceil(a/7e3))+s),l=i.subarray(n,i.length-s),c=o.l,d=(o.r||0)&7;if(e){
d&&(l[0]=o.r>>3);for(var m=Ol[e-1],p=m>>13,h=m&8191,f=(1<<r)-1,g=o.p||new Q(32768),y=o.h||new Q(f+1),x=Math.ceil(r/3),v=2*x,w=function(nn){return(t[nn]^t[nn+1]<<
x^t[nn+2]<<v)&f},S=new En(25e3),A=new Q(288),k=new Q(32),R=0,E=0,M=o.i||0,W=0,I=o.w||0,B=0;M+2<a;++M){var Ee=w(M),J=M&32767,V=y[Ee];if(g[J]=V,y[Ee]=J,I<=M){var D=a-
M;if((R>7e3||W>24576)&&(D>423||!c)){d=js(t,l,0,S,A,k,E,W,B,M-B,d),W=R=E=0,B=M;for(var P=0;P<286;++P)A[P]=0;for(var P=0;P<30;++P)k[P]=0}var q=2,z=0,yt=h,re=J-V&32767;
if(D>2&&Ee==w(M-re))for(var we=Math.min(p,D)-1,Z=Math.min(32767,M),X=Math.min(258,D);re<=Z&&--yt&&J!=V;){if(t[M+q]==t[M+q-re]){for(var _=0;_<X&&t[M+_]==t[M+_-re];++_)
;if(_>q){if(q=_,z=re,_>we)break;for(var ce=Math.min(re,_-2),qe=0,P=0;P<ce;++P){var Ye=M-re+P&32767,Kt=g[Ye],Jt=Ye-Kt&32767;Jt>qe&&(qe=Jt,V=Ye)}}}J=V,V=g[J],re+=
J-V&32767}if(z){S[W++]=268435456|xn[q]<<18|Bs[z];var vt=xn[q]&31,bt=Bs[z]&31;E+=sr[vt]+or[bt],++A[257+vt],++k[bt],I=M+q,++R}else S[W++]=t[M],++A[t[M]]}}for(M=Math.
max(M,I);M<a;++M)S[W++]=t[M],++A[t[M]];d=js(t,l,c,S,A,k,E,W,B,M-B,d),c||(o.r=d&7|l[d/8|0]<<3,d-=7,o.h=y,o.p=g,o.i=M,o.w=I)}else{for(var M=o.w||0;M<a+c;M+=65535){
var Ke=M+65535;Ke>=a&&(l[d/8|0]=c,Ke=a),d=Xs(l,d+1,t.subarray(M,Ke))}o.i=a}return kn(i,0,n+Tn(d)+s)},Pl=(function(){for(var t=new Int32Array(256),e=0;e<256;++e){
for(var r=e,n=9;--n;)r=(r&1&&-306674912)^r>>>1;t[e]=r}return t})(),_l=function(){var t=-1;return{p:function(e){for(var r=t,n=0;n<e.length;++n)r=Pl[r&255^e[n]]^r>>>
8;t=r},d:function(){return~t}}};var Ll=function(t,e,r,n,s){if(!s&&(s={l:1},e.dictionary)){var o=e.dictionary.subarray(-32768),a=new L(o.length+t.length);a.set(o),a.set(t,o.length),t=a,s.w=o.length}
return $l(t,e.level==null?6:e.level,e.mem==null?s.l?Math.ceil(Math.max(8,Math.min(13,Math.log(t.length)))*1.5):20:12+e.mem,r,n,s)},eo=function(t,e){var r={};for(var n in t)
r[n]=t[n];for(var n in e)r[n]=e[n];return r};var H=function(t,e,r){for(;r;++e)t[e]=r,r>>>=8};var Nl=function(t,e){return((t[0]&15)!=8||t[0]>>4>7||(t[0]<<8|t[1])%31)&&K(6,"invalid zlib data"),(t[1]>>5&1)==+!e&&K(6,"invalid zlib data: "+(t[1]&32?"need":"u\
nexpected")+" dictionary"),(t[1]>>3&4)+2};function Il(t,e){return Ll(t,e||{},0,0)}function to(t,e){return Rl(t.subarray(Nl(t,e&&e.dictionary),-4),{i:2},e&&e.out,e&&e.dictionary)}var ro=function(t,e,r,n){for(var s in t){var o=t[s],a=e+s,i=n;Array.isArray(o)&&(i=eo(n,o[1]),o=o[0]),o instanceof L?r[a]=[o,i]:(r[a+="/"]=[new L(0),i],ro(o,a,r,
n))}},Vs=typeof TextEncoder<"u"&&new TextEncoder,Fl=typeof TextDecoder<"u"&&new TextDecoder,Ul=0;try{Fl.decode(Qs,{stream:!0}),Ul=1}catch{}function nr(t,e){if(e){for(var r=new L(t.length),n=0;n<t.length;++n)r[n]=t.charCodeAt(n);return r}if(Vs)return Vs.encode(t);for(var s=t.length,o=new L(t.length+
(t.length>>1)),a=0,i=function(d){o[a++]=d},n=0;n<s;++n){if(a+5>o.length){var l=new L(a+8+(s-n<<1));l.set(o),o=l}var c=t.charCodeAt(n);c<128||e?i(c):c<2048?(i(192|
c>>6),i(128|c&63)):c>55295&&c<57344?(c=65536+(c&1047552)|t.charCodeAt(++n)&1023,i(240|c>>18),i(128|c>>12&63),i(128|c>>6&63),i(128|c&63)):(i(224|c>>12),i(128|c>>
6&63),i(128|c&63))}return kn(o,0,a)}var Mn=function(t){var e=0;if(t)for(var r in t){var n=t[r].length;n>65535&&K(9),e+=n+4}return e},qs=function(t,e,r,n,s,o,a,i){var l=n.length,c=r.extra,d=i&&i.length,
m=Mn(c);H(t,e,a!=null?33639248:67324752),e+=4,a!=null&&(t[e++]=20,t[e++]=r.os),t[e]=20,e+=2,t[e++]=r.flag<<1|(o<0&&8),t[e++]=s&&8,t[e++]=r.compression&255,t[e++]=
r.compression>>8;var p=new Date(r.mtime==null?Date.now():r.mtime),h=p.getFullYear()-1980;if((h<0||h>119)&&K(10),H(t,e,h<<25|p.getMonth()+1<<21|p.getDate()<<16|p.
getHours()<<11|p.getMinutes()<<5|p.getSeconds()>>1),e+=4,o!=-1&&(H(t,e,r.crc),H(t,e+4,o<0?-o-2:o),H(t,e+8,r.size)),H(t,e+12,l),H(t,e+14,m),e+=16,a!=null&&(H(t,e,
d),H(t,e+6,r.attrs),H(t,e+10,a),e+=14),t.set(n,e),e+=l,m)for(var f in c){var g=c[f],y=g.length;H(t,e,+f),H(t,e+2,y),t.set(g,e+4),e+=4+y}return d&&(t.set(i,e),e+=
d),e},Wl=function(t,e,r,n,s){H(t,e,101010256),H(t,e+8,r),H(t,e+10,r),H(t,e+12,n),H(t,e+16,s)};function no(t,e){e||(e={});var r={},n=[];ro(t,"",r,e);var s=0,o=0;for(var a in r){var i=r[a],l=i[0],c=i[1],d=c.level==0?0:8,m=nr(a),p=m.length,h=c.comment,f=h&&
nr(h),g=f&&f.length,y=Mn(c.extra);p>65535&&K(11);var x=d?Il(l,c):l,v=x.length,w=_l();w.p(l),n.push(eo(c,{size:l.length,crc:w.d(),c:x,f:m,m:f,u:p!=a.length||f&&h.
length!=g,o:s,compression:d})),s+=30+p+y+v,o+=76+2*(p+y)+(g||0)+v}for(var S=new L(o+22),A=s,k=o-s,R=0;R<n.length;++R){var m=n[R];qs(S,m.o,m,m.f,m.u,m.c.length);
var E=30+m.f.length+Mn(m.extra);S.set(m.c,m.o+E),qs(S,s,m,m.f,m.u,m.c.length,m.o,m.m),s+=16+E+(m.m?m.m.length:0)}return Wl(S,s,n.length,k,A),S}var Dl="http://www.w3.org/2000/svg";function u(t,e={},...r){return so(document.createElement(t),e,r)}function b(t,e={},...r){return so(document.createElementNS(
Dl,t),e,r)}function so(t,e,r){for(let[s,o]of Object.entries(e))o==null||o===!1||(typeof o=="function"?t.addEventListener(s.slice(2),o):t.setAttribute(s,o===!0?"":
String(o)));let n=r.filter(s=>s!=null&&s!==!1);return t.append(...n.map(s=>typeof s=="number"?String(s):s)),t}function ar(t,e){let r=u("select",{onchange:()=>e(
r.value)},...t.map(([n,s])=>u("option",{value:n},s)));return r}async function Cn(t){try{await t}catch(e){throw(document.querySelector("#page, main")??document.body).
prepend(u("p",{class:"card problem",role:"alert"},`The page could not start: ${String(e)}`)),e}finally{document.body.dataset.ready="true"}}var oo=()=>["file:","\
http:","https:"].includes(location.protocol);var F=(t,e=2)=>t==null?"-":t.toFixed(e);function ao(t,e,r){return e===null||r===null?F(t):`${F(t)} (${F(e)} to ${F(r)})`}function et(t){let e=Math.abs(t),r=e>=1e4?
e.toExponential(0):e.toFixed(e<100?2:0);return t<0&&Number(r)?`−${r}`:r}var de=t=>t.charAt(0).toUpperCase()+t.slice(1);function Rt(t,e,r,n=!1){let s=(e-t)/Math.max(1,r),o=10**Math.floor(Math.log10(s||1)),a=[1,2,5,10].map(c=>c*o).find(
c=>c>=s)??10*o;n&&(a=Math.max(1,Math.round(a)));let i=Math.ceil(t/a-1e-9),l=Math.floor(e/a+1e-9);return Array.from({length:Math.max(0,l-i+1)},(c,d)=>(i+d)*a)}var zl={teams:{pursuer:"pursuers",evader:"evaders"},generation:{pursuer:"pursuer generation",evader:"evader generation"},score:"capture rate",means:{pursuer:"ca\
ptures",evader:"escapes"},curves:{pursuer:"captures",evader:"escapes"},ends:["0 all escape","1 all caught"],lead:"Each cell is a match between two generations: \
the brighter, the more evaders are captured. Click one to watch it.",click:"watch its match"},Hl=([t,e])=>({teams:{pursuer:t,evader:e},generation:{pursuer:`gene\
ration of ${t}`,evader:`generation of ${e}`},score:`score of the ${t}`,means:{pursuer:t,evader:e},curves:{pursuer:"scores",evader:"scores"},ends:[`0 the ${e} wi\
n`,`1 the ${t} win`],lead:`Each cell is a pair of generations: the brighter, the higher the score of the ${t}. Click one to see more of it.`,click:"see more of \
it"}),me=({game:t})=>t?Hl(t.teams):zl,ee=(t,e,r)=>`${me(t).teams[e]} of generation ${r}`,Bl=200;function io(t,e,{pursuer:r,evader:n},s){let{text:o,image:a}=e.shows[`${r}\
 ${n}`]??{},i=Re(t,r,n)?.rates??[],l=`Scores of the ${e.teams[0]} in ${i.length} episodes: ${i.map(c=>F(c)).join(", ")}`;return[o===void 0?null:u("pre",{tabindex:0,
"aria-label":"What the game shows of this pair"},o),a===void 0?null:u("img",{src:a,alt:"What the game shows of this pair",onload:({target:c})=>c.classList.toggle(
"pixels",c.naturalWidth<Bl)}),...(o??a)===void 0?[u("p",{class:"muted"},e.missing),Gl(t,e,r,n,s)]:[],i.length>1?u("p",{class:"small numbers"},l):null].filter(c=>c!==
null)}function Gl(t,e,r,n,s){let o=Object.keys(e.shows).map(d=>d.split(" ").map(Number)),a=([d,m])=>(d-r)**2+(m-n)**2,[i,l]=o.sort((d,m)=>a(d)-a(m))[0]??[];if(i===
void 0||l===void 0)return null;let c=`${ee(t,"pursuer",i)} against ${ee(t,"evader",l)}`;return u("p",{},u("button",{type:"button",onclick:()=>s.select({pursuer:i,
evader:l})},`Nearest: ${c}`))}var Ie=["pursuer","evader"];function Re(t,e,r){let[n,s]=[e-t.payoff.first[0],r-t.payoff.first[1]],o=t.payoff.capture_rate[n]?.[s];return o===void 0?null:{rate:o,rates:t.payoff.capture_rates[n][s],
lengths:t.payoff.lengths[n]?.[s]??[]}}function ir(t,e,r){let{script:n,policy:s,kept:o,genomes:a}=t.teams[e];if(n!==null||s===null)return"";if(!o.includes(r))return`\
The page holds no genome of ${ee(t,e,r)}: it would be too large. Choose a generation of ${o.join(", ")}.`;let i=o.length*s.genome_size;return mo(a,s.genome_size).
length===i?"":`The page is damaged: it does not hold the ${i} numbers of the ${e}s' genomes. Write it again from its run.`}function ne(t,e,r){let{script:n,policy:s,
kept:o,genomes:a}=t.teams[e];if(n!==null||s===null)return n??"random";let i=o.indexOf(r);if(i<0)throw new RangeError(`${e}: expected a generation whose genome t\
he page holds, got ${r}`);let l=s.genome_size,c=mo(a,l).subarray(i*l,(i+1)*l);return{...s,genome:c}}var lo=({teams:t},e)=>(t[e].policy??{kind:"cells"}).kind!=="\
cells",co=({teams:t},e,r)=>t[e].expressions?.[t[e].kept.indexOf(r)]??"";function lr(t,e,{pursuer:r,evader:n,episode:s,seed:o}){let a=e.seeds[r][n];return t.match(
e.world,ne(e,"pursuer",r),ne(e,"evader",n),BigInt(o??a),s)}var Rn=4,On=new Map,uo=(t,e)=>{On.set(t,e)};function mo(t,e){let r=On.get(t);if(r)return r;let n=new Float32Array;
try{let s=Vl($n(t),e);s.every(Number.isFinite)&&(n=s)}catch(s){if(!(s instanceof DOMException||s instanceof RangeError||jl(s)))throw s}return On.set(t,n),n}var jl=t=>t instanceof
Error&&"code"in t;function Vl(t,e){let r=to(t),n=r.length/Rn,s=new Uint8Array(r.length);for(let a=0;a<s.length;a++)s[a]=r[a%Rn*n+Math.floor(a/Rn)];let o=new Uint32Array(
s.buffer);for(let a=e;a<o.length;a++)o[a]^=o[a-e];return new Float32Array(s.buffer)}function $n(t){let e=atob(Ae(t)),r=new Uint8Array(e.length);for(let n=0;n<r.
length;n++)r[n]=e.charCodeAt(n);return r}var Ae=t=>document.getElementById(t)?.textContent??"";var go={initial:1,noise:2,learn:3,opponents:4},_n={pursuer:1,evader:2,both:3},Fe=4,Pn=2n**32n;function po(t){let e=[],r=BigInt(t);do e.push(Number(r%Pn)),r/=Pn;while(r>
0n);return e}function ho(t,e){let r=t;return n=>{let s=n^r;return r=Math.imul(r,e),s=Math.imul(s,r),s^s>>>16}}function fo(t,e){let r=Math.imul(3389127133,t)-Math.
imul(1232336661,e)|0;return r^r>>>16}function Ln(t,e,r){let n=t.flatMap(po);if(e.length){for(;n.length<Fe;)n.push(0);n.push(...e.flatMap(po))}let s=ho(1135663077,
2468251765),o=Array.from({length:Fe},(i,l)=>s(n[l]??0));for(let i=0;i<Fe;i++)for(let l=0;l<Fe;l++)i!==l&&(o[l]=fo(o[l],s(o[i])));for(let i of n.slice(Fe))for(let l=0;l<
Fe;l++)o[l]=fo(o[l],s(i));let a=ho(2337405405,1492356589);return Uint32Array.from({length:r},(i,l)=>a(o[l%Fe]))}function Ot(t,e){let r=Ln(t,[],2*e);return BigUint64Array.
from({length:e},(n,s)=>BigInt(r[2*s])+Pn*BigInt(r[2*s+1]))}var cr=(t,e,r)=>Ot([t,e,r],1)[0];var yo=t=>(e,...r)=>new Nn(Ln([t],[go[e],...r],3)),Nn=class{#e;#t;#r;#n=1;constructor(e){[this.#e,this.#t,this.#r]=[e[0],e[1],e[2]];for(let r=0;r<12;r++)this.#o()}#o(){
let e=this.#e+this.#t+this.#n++|0;return this.#e=this.#t^this.#t>>>9,this.#t=this.#r+(this.#r<<3)|0,this.#r=(this.#r<<21|this.#r>>>11)+e|0,e>>>0}#s(){return(this.#o()+
.5)/2**32}normals(e){let r=new Float32Array(e);for(let n=0;n<e;n+=2){let[s,o]=[Math.sqrt(-2*Math.log(this.#s())),2*Math.PI*this.#s()];r[n]=s*Math.cos(o),n+1<e&&
(r[n+1]=s*Math.sin(o))}return r}integers(e,r){return Int32Array.from({length:r},()=>Math.floor(this.#s()*e))}permutation(e){return this.choice(e,e)}choice(e,r){
let n=Int32Array.from({length:e},(s,o)=>o);for(let s=0;s<r;s++){let o=s+Math.floor(this.#s()*(e-s));[n[s],n[o]]=[n[o],n[s]]}return n.slice(0,r)}};var O=Math.fround,ql=5,Yl=256,ur=class{size;sigma;fixed;#e;constructor(e,r,n,s){[this.size,this.sigma,this.fixed]=[e,n,s],this.#e=r.normals((1+Yl)*e);for(let o=0;o<
this.#e.length;o++)this.#e[o]*=O(n)}draw(e,r){let n=r.integers(this.#e.length-this.size+1,e);return Array.from(n,s=>{let o=this.#e.subarray(s,s+this.size);return this.
fixed?o.map((a,i)=>this.fixed[i]?0:a):o})}},In=class{#e;#t;#r=0;constructor(e){[this.#e,this.#t]=[new Float32Array(e),new Float32Array(e)]}moved(e,r,n){let[s,o,
a]=[.9,.999,O(1e-8)];this.#r+=1;let[i,l]=[O(1-s),O(1-o)],[c,d]=[O(1-s**this.#r),O(1-o**this.#r)];return e.map((m,p)=>{let h=r[p],f=this.#e[p]+=O(i*O(h-this.#e[p])),
g=this.#t[p]+=O(l*O(O(h*h)-this.#t[p])),y=O(O(Math.sqrt(O(O(g)/d)))+a);return O(m+O(O(O(n)*O(O(f)/c))/y))})}};function Kl(t){let e=Array.from(t).sort((r,n)=>r-n);
return t.map(r=>(e.indexOf(r)+e.lastIndexOf(r))/(2*(t.length-1))-.5)}var dr=class{genome;groups;#e;#t;#r;#n=[];constructor(e,r,n){[this.genome,this.#t,this.#e,this.#r]=
[e,r,n,new In(e.length)],this.groups=Int32Array.from({length:n.population},(s,o)=>o%(n.population/2))}get#o(){let{sigma:e,fixed:r}=this.#t,[n,s]=[0,0];return this.
genome.forEach((o,a)=>{r?.[a]||(n+=o*o,s+=1)}),Math.max(e,this.#e.relative_sigma*Math.sqrt(n/s))}ask(e){let[r,n]=[this.#e.population/2,this.genome.length];this.#n=
this.#t.draw(r,e);let s=O(this.#o/this.#t.sigma),o=new Float32Array(2*r*n);return this.#n.forEach((a,i)=>{for(let l=0;l<n;l++){let c=O(s*a[l]);o[i*n+l]=this.genome[l]+
c,o[(r+i)*n+l]=this.genome[l]-c}}),o}tell(e){let[r,n]=[Kl(e),this.#n.length],s=new Float32Array(this.genome.length);this.#n.forEach((o,a)=>{let i=O((r[a]-r[n+a])/
(2*n*this.#t.sigma**2));for(let l=0;l<s.length;l++)s[l]+=O(i*o[l])}),this.genome=this.#r.moved(this.genome,s,this.#e.learning_rate)}},$t=class{population;groups;#e;#t;#r=new Float64Array(
0);#n=0;constructor(e,r,n){[this.population,this.#t,this.#e]=[e,r,n],this.groups=new Int32Array(n.population)}get genome(){return this.#o(this.#n).slice()}#o(e){
let{size:r}=this.#t;return this.population.subarray(e*r,(e+1)*r)}#s(e,r){let n=this.#e.tournament??ql,s=r.integers(this.#r.length,e*n);return Array.from({length:e},
(o,a)=>s.subarray(a*n,(a+1)*n).reduce((i,l)=>this.#r[l]>this.#r[i]?l:i))}ask(e){if(!this.#r.length)return this.population;let{size:r}=this.#t,{population:n,elites:s}=this.#e,
o=n-s,a=this.#s(o,e);this.#s(o,e);let i=Array.from(this.#r.keys()).sort((c,d)=>this.#r[d]-this.#r[c]).slice(0,s),l=new Float32Array(this.population.length);return[
...i,...a].forEach((c,d)=>l.set(this.#o(c),d*r)),this.#t.draw(o,e).forEach((c,d)=>{let m=(s+d)*r;for(let p=0;p<r;p++)l[m+p]+=c[p]}),this.population=l,l}tell(e){
this.#r=e,this.#n=e.indexOf(Math.max(...e))}};var U=t=>Array.from(t).reduce((e,r)=>e+r,0)/t.length,vo=(t,e)=>e==="pursuer"?t:t[0].map((r,n)=>t.map(s=>1-s[n])),bo=(t,e)=>U(vo(t,e).at(-1));function wo(t,e){let r=[],
n=vo(t,e).map(s=>U(s.map((o,a)=>(r[a]=Math.max(r[a]??0,o),r[a]-o))));return U(n.slice(Math.floor(n.length/2)))}var xo=-12676506002282294e14,So=({hidden:t,mask:e})=>t.map(r=>r+(e?4:0));function Pt(t){let e=[3*t.fov**2,...So(t),5],r=0;return e.slice(1).map((n,s)=>{let o={at:r,
inputs:e[s],outputs:n};return r+=(o.inputs+1)*n,o})}function Ue(t){if(t.kind==="rating")return t.inputs.length;let{at:e,inputs:r,outputs:n}=Pt(t).at(-1);return e+
(r+1)*n}var _t=(t,e)=>t.kind==="rating"?{...t,genome:e}:{kind:"cells",hidden:So(t),activation:"relu",sampled:!0,memory:"none",genome:e};function Ao(t,e,r){let n=r.
initial_weight;if(t.kind==="rating"||r.kind==="rating")return e.normals(Ue(t)).map(i=>Math.fround(n)*i);let s=r.initial_head,o=new Float32Array(Ue(t)),a=Pt(t);return a.
forEach(({at:i,inputs:l,outputs:c},d)=>{let m=Math.fround(d===a.length-1?s:n);e.normals(l*c).forEach((p,h)=>o[i+h]=m*p)}),o}function Fn(t){if(t.kind==="rating")
return null;let{fov:e,mask:r}=t;if(!r)return null;let[n,s]=[new Uint8Array(Ue(t)),new Float32Array(Ue(t))],o=Pt(t),a=o.length-1,i=Math.floor(e/2);return o.forEach(
({at:l,inputs:c,outputs:d},m)=>{let p=(h,f)=>l+h*d+f;for(let h=0;h<4;h++)if(m>0&&n.fill(1,p(c-4+h,0),p(c-4+h+1,0)),m<a)for(let f=0;f<=c;f++)n[p(f,d-4+h)]=1;r.forEach(
(h,f)=>{let g=m===a?1+f:d-4+f,y=m===0?h.map(([x,v,w])=>(x*e+i+v)*e+i+w):[c-4+f];for(let x of y)n[p(x,g)]=1,s[p(x,g)]=m===a?xo:1})}),{fixed:n,values:s}}function Un(t,e){
return e?t.map((r,n)=>e.fixed[n]?e.values[n]:r):t}function Mo(t,e,r){if(e.kind==="rating"||r.kind==="rating")return t;let n=new Float32Array(Ue(r)),[s,o]=[Pt(e),
Pt(r)],a=Math.floor(r.fov/2)-Math.floor(e.fov/2),i=c=>c>=0&&c<r.fov,l=c=>{let[d,m,p]=[Math.floor(c/e.fov**2),Math.floor(c/e.fov)%e.fov+a,c%e.fov+a];return i(m)&&
i(p)?(d*r.fov+m)*r.fov+p:-1};return s.forEach((c,d)=>{let m=o[d],p=e.hidden[d]??5;for(let h=0;h<(d?e.hidden[d-1]:c.inputs);h++){let f=d?h:l(h);if(!(f<0))for(let g=0;g<
p;g++)n[m.at+f*m.outputs+g]=t[c.at+h*c.outputs+g]}for(let h=0;h<p;h++)n[m.at+m.inputs*m.outputs+h]=t[c.at+c.inputs*c.outputs+h]}),Un(n.map(c=>c<=xo/2?0:c),Fn(r))}function Eo(t,e,r,n){let[s,o]=[t.length,Math.max(...t)+1],a=o>1?s/o:1,i=Array.from(t.keys()).sort((m,p)=>t[m]-t[p]),l=[],c=[];for(let m=0;m<e;m++){let p=m%a;p===
0&&(c=Array.from(n.permutation(s/a)).flatMap(h=>i.slice(h*a,(h+1)*a))),l.push([i,c.map((h,f)=>c[f-f%a+(f%a-p+a)%a])])}let d=m=>i.map(()=>s+m);for(let m=0;m<r[1];m++)
l.push([i,d(m)]);for(let m=0;m<r[0];m++)l.push([d(m),i]);return{pursuer:Int32Array.from(l.flatMap(([m])=>m)),evader:Int32Array.from(l.flatMap(([,m])=>m)),group:Int32Array.
from(l.flatMap((m,p)=>i.map(h=>p*o+t[h])))}}function To(t,e,r,n){let s=Math.max(...e)+1,[o,a]=[new Float64Array(r*s),new Float64Array(r*s)];n.forEach((l,c)=>{if(t[c]>=
r)return;let d=t[c]*s+e[c];o[d]+=l,a[d]+=1});let i=o.map((l,c)=>a[c]?l/a[c]:0);return Float64Array.from({length:r},(l,c)=>{let d=i.subarray(c*s,(c+1)*s);return Wn(
d)/a.subarray(c*s,(c+1)*s).filter(Boolean).length})}var Jl=128,tt=8;function Wn(t){let{length:e}=t;if(e>Jl){let p=Math.floor(e/2)-Math.floor(e/2)%tt;return Wn(t.
subarray(0,p))+Wn(t.subarray(p))}if(e<tt)return t.reduce((p,h)=>p+h,0);let r=t.slice(0,tt),n=e-e%tt;for(let p=tt;p<n;p++)r[p%tt]+=t[p];let[s,o,a,i,l,c,d,m]=r;return t.
subarray(n).reduce((p,h)=>p+h,s+o+(a+i)+(l+c+(d+m)))}var C=["pursuer","evader"],We=t=>t==="pursuer"?"evader":"pursuer";var ko=({world:t})=>t.rules.teammate==="REACH"?.2:0;var pr={pursuer:["random","clumsy-fleer"],evader:["random","clumsy-chaser"]},Zl=20,Xl=8,Ql=-1,hr=({world:t,policy:e},r,n)=>e.kind==="rating"?e:{kind:"cells",fov:t.
fov,hidden:e.hidden,mask:e.mask==="none"?null:r[n]},rt=class{settings;archive={pursuer:[],evader:[]};rows=[];cells=new Map;counters={pursuer:[],evader:[]};#e;#t;#r;#n={};#o=new Set;#s=0;#i=0;#h=0;constructor(e,r,n,s=yo(
r.seed)){[this.#e,this.settings,this.#t,this.#r]=[e,r,n,s];for(let o of C){let a=s("initial",C.indexOf(o)),i=r.learner.kind==="ga"?r.learner.population:1,l=Array.
from({length:i},()=>Ao(this.shape(o),a,r.policy));this.#a(o,l),this.archive[o].push(this.#n[o].genome)}this.#w(...C)}shape(e){return hr(this.settings,this.#t,e)}get finished(){
return Math.min(this.archive.pursuer.length,this.archive.evader.length)}*run(){yield*this.#S(0);for(let e=1;e<=this.settings.schedule.generations;e++){if(this.settings.
schedule.kind==="alternating")for(let r of C)yield*this.#d(r,e),this.#w(r);else yield*this.#u(e),this.#w(...C);yield*this.#S(e)}}change(e){let r=this.settings,n={
pursuer:this.shape("pursuer"),evader:this.shape("evader")},s=l=>JSON.stringify(l(r))===JSON.stringify(l(e));this.settings=e;let o=s(l=>[l.world.fov,l.policy]);if(!o||
!s(l=>l.learner))for(let l of C){let c=d=>Mo(d,n[l],this.shape(l));this.archive[l]=this.archive[l].map(c),this.#a(l,this.#m(l).map(c))}if(o&&s(l=>l.world))return null;
this.cells.clear(),this.#o.clear();let{pursuer:a,evader:i}=this.archive;return{type:"anew",settings:e,genomes:{pursuer:a.slice(0,this.finished),evader:i.slice(0,
this.finished)}}}#m(e){let r=this.#n[e];if(!(r instanceof $t))return[r.genome];let n=r.genome.length,s=Array.from({length:r.population.length/n},(o,a)=>r.population.
slice(a*n,(a+1)*n));return Array.from({length:this.settings.learner.population},(o,a)=>a===0?r.genome:s[a%s.length])}#a(e,r){let{learner:n}=this.settings,[s,o]=[
this.shape(e),n.kind==="ga"?n.mutation:n.sigma],a=Fn(s),i=new ur(Ue(s),this.#r("noise",C.indexOf(e)),o,a?.fixed??null),l=r.map(c=>Un(c,a));this.#n[e]=n.kind==="\
ga"?new $t(mr(l),i,n):new dr(l[0],i,n)}*#d(e,r){for(let n=0;n<this.#c(e);n++){let s=this.archive[We(e)].length,o=this.settings.schedule[`${e}s_meet`],a=o==="lat\
est"?s-1:o==="round-robin"?n%s:this.#r("opponents",C.indexOf(e),r,n).choice(s,1)[0],i=e==="pursuer"?[r,a]:[a,r],l=this.#n[e],{groups:c}=l,d=Ot([this.settings.seed,
...i,_n[e],n],Math.max(...c)+1),m=l.ask(this.#r("learn",C.indexOf(e),r,n)),[p,h]=[Int32Array.from(c.keys()),new Int32Array(c.length)],f={[e]:m,[We(e)]:this.archive[We(
e)][a]},g={[e]:p,[We(e)]:h},y=this.#g(f,g,BigUint64Array.from(c,v=>d[v])),x=this.#b(y,e);this.#v(y,x,{generation:r,team:e,epoch:n,opponent:a}),l.tell(x),yield*this.#f(
r,n,e)}this.archive[e].push(this.#n[e].genome)}*#u(e){for(let r=0;r<this.#c("pursuer");r++){let{schedule:n,learner:{population:s}}=this.settings,[o,a]=n.kind===
"hall-of-fame"?[n.hall_sample,n.contemporaries]:[0,1],i={pursuer:this.#l("pursuer",e,r),evader:this.#l("evader",e,r)},l=this.#r("opponents",0,e,r),c={pursuer:this.#p(
o,l),evader:this.#p(o,l)},d=y=>mr([i[y],...Array.from(c[We(y)],x=>this.archive[y][x])]),m=[c.evader.length,c.pursuer.length],p=Eo(this.#n.pursuer.groups,a,m,l),
h=Ot([this.settings.seed,e,e,_n.both,r],Math.max(...p.group)+1),f={pursuer:d("pursuer"),evader:d("evader")},g=this.#g(f,p,BigUint64Array.from(p.group,y=>h[y]));
for(let y of C){let x=To(p[y],p[We(y)],s,this.#b(g,y));this.#v(g,x,{generation:e,team:y,epoch:r,opponent:Ql}),this.#n[y].tell(x)}yield*this.#f(e,r,"both")}for(let r of C)
this.archive[r].push(this.#n[r].genome)}#l(e,r,n){return this.#n[e].ask(this.#r("learn",C.indexOf(e),r,n))}#p(e,r){let n=this.archive.pursuer.length;return e?r.
choice(n,Math.min(e,n)):new Int32Array(0)}#c(e){let{schedule:r}=this.settings;return r.kind==="hall-of-fame"?r.joint_epochs:r[`${e}_epochs`]}*#f(e,r,n){let[s,o]=this.
settings.schedule.kind==="hall-of-fame"?[this.#c("pursuer"),0]:[this.#c("pursuer"),this.#c("evader")],a=r+1+(n==="evader"?s:0),i=s+o;yield{type:"epoch",done:(e-
1)*i+a,of:this.settings.schedule.generations*i},yield*this.catchUp()}#g(e,r,n){let s={...this.settings.world,max_steps:this.settings.train_steps},o=this.#e.rollouts(
s,this.#y("pursuer",e.pursuer),this.#y("evader",e.evader),{...r,seed:n},1);this.#s+=o.length.length;for(let a of o.length)this.#i+=Number(a);for(let a of o.agent_steps)
this.#h+=Number(a);return o}#y(e,r){return _t(this.shape(e),r)}#b({captured_fraction:e,overlap:r},n){let s=ko(this.settings);return Float64Array.from(e,(o,a)=>n===
"pursuer"?o:1-o-s*Number(r[2*a+1]))}#v(e,r,n){let s=U(r),o=[0,0];e.faults.forEach((a,i)=>o[Math.floor(i/3)%2]+=Number(a)),this.rows.push({...n,fitness_mean:s,fitness_std:Math.
sqrt(U(r.map(a=>(a-s)**2))),fitness_best:Math.max(...r),capture_rate:U(e.capture_rate),length:U(e.length),pursuer_faults:o[0]/e.length.length,evader_faults:o[1]/
e.length.length,matches:this.#s,steps:this.#i})}#w(...e){for(let r of e)this.counters[r].push({matches:this.#s,steps:this.#i,agent_steps:this.#h})}*#S(e){yield{
type:"generation",number:e,genomes:{pursuer:this.archive.pursuer[e],evader:this.archive.evader[e]}},yield*this.catchUp()}*catchUp(){for(let e=this.finished-1;e>=
0;e--){for(let r=e;r>=0;r--)for(let[n,s]of r===e?[[e,e]]:[[e,r],[r,e]]){if(this.cells.has(`${n} ${s}`))continue;let o=this.#A(n,s);this.cells.set(`${n} ${s}`,o),
yield{type:"cell",cell:o}}this.#o.has(e)||(this.#o.add(e),yield{type:"scores",number:e,scores:{pursuer:this.#x("pursuer",e),evader:this.#x("evader",e)}})}}#A(e,r){
let{world:n,evaluation_episodes:s,seed:o}=this.settings,a={pursuer:new Int32Array(1),evader:new Int32Array(1),seed:BigUint64Array.of(cr(o,e,r))},i=C.map(d=>this.#y(
d,this.archive[d][d==="pursuer"?e:r])),l=this.#e.rollouts(n,...i,a,s),c=d=>{let m=Array.from(l[d],Number),p=m.length/s;return Array.from({length:p},(h,f)=>U(m.filter(
(g,y)=>y%p===f)))};return{pursuer:e,evader:r,capture_rates:Array.from(l.capture_rate),lengths:Array.from(l.length),means:{collisions:c("collisions"),faults:c("f\
aults"),agent_steps:c("agent_steps"),survivors:c("survivors")}}}#x(e,r){let{world:n,seed:s}=this.settings,[o,a]=[this.#y(e,this.archive[e][r]),new Int32Array(1)];
return U(pr[e].map((i,l)=>{let c=Ot([s,C.indexOf(e),l,Xl],1),d=e==="pursuer"?[o,i]:[i,o],m=U(this.#e.rollouts(n,...d,{pursuer:a,evader:a,seed:c},Zl).capture_rate);
return e==="pursuer"?m:1-m}))}};function mr(t){let e=new Float32Array(t.reduce((n,{length:s})=>n+s,0)),r=0;for(let n of t)e.set(n,r),r+=n.length;return e}var ec=12;function Co(t){let e=new Blob([Ae("script-engine"),`
`,Ae(`script-${t}`)],{type:"text/javascript"});return new Worker(URL.createObjectURL(e))}function Ro(){let t=d=>postMessage(d),e=rr(),r=null,n=null,s=0,o=!1,a=new MessageChannel,
i=()=>{let d=performance.now()+ec;for(;n&&performance.now()<d;){let{value:m,done:p}=n.next();p?(n=null,t({type:"end",seconds:(performance.now()-s)/1e3})):t(m)}!n||
o||(o=!0,a.port2.postMessage(null))},l=async d=>{if(d.type==="start")r=new rt(await e,d.settings,d.masks),[n,s]=[r.run(),performance.now()],i();else if(d.type===
"stop")n=null;else if(d.type==="change"){let m=r?.change(d.settings);if(m&&t(m),!r||!m||n)return;n=r.catchUp(),i()}else if(r){let{settings:m,archive:p,rows:h,cells:f,
counters:g,finished:y}=r;t({type:"saved",race:{settings:m,archive:p,rows:h,cells:f,counters:g,finished:y}})}},c=d=>{Promise.resolve().then(d).catch(m=>{n=null,t(
{type:"failed",message:String(m)})})};a.port1.onmessage=()=>{o=!1,c(i)},globalThis.onmessage=({data:d})=>c(()=>l(d))}var Oo=t=>u("input",{type:"text",readonly:!0,"aria-label":t});function nt(t,e){let r=URL.createObjectURL(new Blob([e],{type:"application/octet-stream"}));u("a",
{href:r,download:t}).click(),setTimeout(()=>URL.revokeObjectURL(r),6e4)}var $o=()=>document.documentElement.dataset.theme==="dark",Lt=t=>{document.documentElement.dataset.theme=t?"dark":"light"},tc=()=>Lt(!$o());if(typeof document<"\
u"){let t=matchMedia("(prefers-color-scheme: dark)");t.addEventListener("change",()=>Lt(t.matches)),Lt(t.matches);let e=!1;addEventListener("beforeprint",()=>{e=
$o(),Lt(!1)}),addEventListener("afterprint",()=>Lt(e))}function Po(){return u("button",{type:"button",title:"Light or dark (D)","aria-label":"Light or dark",onclick:tc},
"◐")}var fr=(t,e,...r)=>u("header",{class:"top"},u("div",{},u("h1",{},t),e?u("p",{class:"lead"},e):null),u("div",{class:"tools"},...r,Po()));var gr=t=>t!==void 0&&"predict"in t,yr=({sections:t})=>new Map(t.flatMap(({parts:e})=>e.filter(gr).map(r=>[r.predict,r]))),_o=()=>JSON.parse(Ae("data"));var st=[[0,0],[-1,0],[0,1],[1,0],[0,-1],[-1,1],[1,1],[1,-1],[-1,-1]];function Lo(t,e,r){let[n,s]=[e[0]-t[0],e[1]-t[1]];return!r&&Math.abs(n)>Math.abs(s)?s=0:r||
(n=0),st.findIndex(([o,a])=>o===Math.sign(n)&&a===Math.sign(s))}var De=(t,e)=>e<t.nPursuers,$=(t,e)=>[t.positions[2*e],t.positions[2*e+1]],Dn=({rows:t,cols:e},[
r,n])=>r>=0&&n>=0&&r<t&&n<e,zn=(t,e,r=3)=>t!==void 0&&[0,1,2].slice(0,r).some(n=>t[3*e+n]),Hn=(t,e)=>zn(t.fault,e),No=(t,e)=>!Hn(t,e)&&zn(t.involved,e,2);function vr(t,e,r){
let[n,s]=[$(t,r),$(e,r)],o=n[0]!==s[0]||n[1]!==s[1],a=e.involved===void 0||zn(e.involved,r);return!!(e.alive[r]&&e.actions?.[r]&&!o&&a)}function br(t,e,r){let[n,
s]=$(t,r),[o,a]=st[e.actions?.[r]??0];return[n+o,s+a]}function Nt(t,e,r){return Array.from({length:r.everCaptured.length},(s,o)=>o).filter(s=>r.everCaptured[s]&&
!e.everCaptured[s]).map(s=>t.nPursuers+s)}var wr=t=>t.moments.flatMap((e,r)=>r&&Nt(t,t.moments[r-1],e).length?[r]:[]);function xr(t,e){return Array.from({length:e.
alive.length},(n,s)=>s).filter(n=>t.alive[n]&&!e.alive[n])}var Io=[-.31,0,.31],Fo=[{size:1,at:[[0,0]]},{size:.62,at:[[-.2,.2],[.2,-.2]]},{size:.54,at:[[-.23,.22],[.23,.22],[0,-.22]]},{size:.54,at:[[-.23,.23],[.23,.23],[
-.23,-.23],[.23,-.23]]},{size:.36,at:Io.flatMap(t=>Io.map(e=>[e,t]))}],rc=.3,nc=.35,sc=.55;function It(t,e){let r=new Map;for(let n=0;n<e.alive.length;n++){if(!e.
alive[n])continue;let[s,o]=$(e,n),a=s*t.cols+o,i=r.get(a);i?i.push(n):r.set(a,[n])}return r}function Uo(t,e){let r=Array.from(e.alive,(n,s)=>{let[o,a]=$(e,s);return{
x:a+.5,y:o+.5,size:1,alpha:0}});for(let n of It(t,e).values()){let s=Fo[Math.min(n.length,Fo.length)-1];n.forEach((o,a)=>{let[i,l]=s.at[Math.min(a,s.at.length-1)],
c=r[o];c.x+=i,c.y+=l,c.size=s.size,c.alpha=1})}return r}var Wo=t=>t*t*(3-2*t),ot=(t,e,r)=>t+(e-t)*r,Do=t=>Math.min(1,Math.max(0,t));function zo(t,e,r,n){let s={
SIMULTANEOUS:1,SWARM_TURNS:2,AGENT_TURNS:r}[t.interaction];if(s===1)return Wo(n);let o=s===r?e:+!De(t,e),a=Math.max(1/s,nc);return Wo(Do((n-o/(s-1)*(1-a))/a))}function Sr(t,e){
let r=t.moments.length-1,n=Math.min(Math.floor(e),r),s=t.moments[n],o=Uo(t,s);if(n===r||e===n)return o;let a=t.moments[n+1],i=Uo(t,a);return o.map((l,c)=>{let d=zo(
t,c,o.length,e-n);return oc(s,a,c,l,i[c],d)})}function Bn(t,e,r){let n=t.moments.length-1,s=Math.min(Math.floor(r),n),[o,a]=[t.moments[s],t.moments[Math.min(s+1,
n)]],i=zo(t,e,o.alive.length,r-s),[[l,c],[d,m]]=[$(o,e),$(a,e)];return[ot(c,m,i)+.5,ot(l,d,i)+.5]}function oc(t,e,r,n,s,o){let a=n.alpha>s.alpha,i={x:ot(n.x,s.x,
o),y:ot(n.y,s.y,o),size:a?n.size:ot(n.size,s.size,o),alpha:a?Do((1-o)/(1-sc)):ot(n.alpha,s.alpha,o)};if(vr(t,e,r)){let[l,c]=$(t,r),[d,m]=br(t,e,r),p=rc*Math.sin(
Math.PI*o);i.x+=(m-c)*p,i.y+=(d-l)*p}return i}var Ho=2*Math.PI;function ze(t,e,r,n){t.beginPath(),t.arc(e,r,n/2,0,Ho)}function Ar(t,e,r,n){let s=n/2,o=[[0,-.97],[.97,.83],[-.97,.83]].map(([a,i])=>[e+a*s,r+i*
s]);t.beginPath(),t.moveTo((o[2][0]+o[0][0])/2,(o[2][1]+o[0][1])/2),o.forEach(([a,i],l)=>{let[c,d]=o[(l+1)%3];t.arcTo(a,i,c,d,n*.09)}),t.closePath()}function Bo(t,e,r,n){
let s=n*.32;t.beginPath(),t.moveTo(e-s,r-s),t.lineTo(e+s,r+s),t.moveTo(e+s,r-s),t.lineTo(e-s,r+s)}function Go(t,e,r,n){t.beginPath();for(let s=0;s<16;s++){let o=n/
2*(s%2?.6:.95),a=Ho*s/16;t.lineTo(e+o*Math.sin(a),r-o*Math.cos(a))}t.closePath()}function jo(t,e,r,n,s,o){let a=Math.atan2(s-r,n-e);t.beginPath(),t.moveTo(e,r),
t.lineTo(n,s);for(let i of[-1,1])t.moveTo(n,s),t.lineTo(n-o*Math.cos(a+i*.6),s-o*Math.sin(a+i*.6))}var Vo=4,ac=1.6,ic=.95,lc=5,cc=.16,uc=9,dc=.09,mc=.2,qo=.75,G=(t,e)=>t.left+e*t.cell,j=(t,e)=>t.top+e*t.cell;function at(t,e,r){return De(e,r)?t.colors.pursuer:
t.colors.evader}function Mr({ctx:t,colors:e},r,n,s,o,a,i=0){t.font=`700 ${Math.round(o)}px system-ui, sans-serif`,t.textAlign="center",t.textBaseline="middle",t.
strokeStyle=e.paper,t.lineWidth=i,i&&t.strokeText(r,n,s),t.fillStyle=a,t.fillText(r,n,s)}function Yo({ctx:t,grid:e,colors:r}){let{left:n,top:s,cell:o,rows:a,cols:i}=e,
[l,c]=[i*o,a*o];if(t.fillStyle=r.paper,t.fillRect(n,s,l,c),o<lc)return;t.fillStyle=r.line;let d=Math.max(1,Math.round(o/60));for(let m=1;m<i;m++)t.fillRect(n+m*
o,s,d,c);for(let m=1;m<a;m++)t.fillRect(n,s+m*o,l,d)}function Ko({ctx:t,grid:e,colors:r},n){let{left:s,top:o,cell:a,rows:i,cols:l}=e;t.fillStyle=r.obstacle;for(let c=0;c<
i*l;c++){if(!n.obstacles[c])continue;let[d,m]=[Math.floor(c/l),c%l];t.fillRect(s+m*a,o+d*a,a,a)}Jo({ctx:t,grid:e,colors:r})}function Jo({ctx:t,grid:{left:e,top:r,
cell:n,rows:s,cols:o},colors:a}){let i=Math.min(5,Math.max(2,Math.round(n/18)));t.strokeStyle=a.frame,t.lineWidth=i,t.strokeRect(e-i/2,r-i/2,o*n+i,s*n+i)}function Zo({
ctx:t,grid:e,colors:r},n){let{left:s,top:o,cell:a,rows:i,cols:l}=e,c=a<24*n?5:1;t.font=`500 ${Math.round(Math.min(15*n,Math.max(9*n,a*.32)))}px system-ui, sans-\
serif`,t.fillStyle=r.muted,t.textBaseline="alphabetic",t.textAlign="center";let d=5*n+a/40;for(let m=0;m<l;m+=c)t.fillText(String(m),s+(m+.5)*a,o-d);t.textAlign=
"right",t.textBaseline="middle";for(let m=0;m<i;m+=c)t.fillText(String(m),s-d,o+(m+.5)*a)}function Xo({grid:t},e,r,n){let s=Math.floor(e.fov/2)+.5,[o,a]=[Math.max(
0,r-s),Math.min(t.cols,r+s)],[i,l]=[Math.max(0,n-s),Math.min(t.rows,n+s)];return[G(t,o),j(t,i),(a-o)*t.cell,(l-i)*t.cell]}function Qo(t,e,r,n){let{ctx:s,grid:o,
colors:a}=t;s.save(),s.beginPath(),s.rect(0,0,s.canvas.width,s.canvas.height),s.rect(...Xo(t,e,r,n)),s.clip("evenodd"),s.clearRect(0,0,s.canvas.width,s.canvas.height),
s.fillStyle=a.line,s.fillRect(o.left,o.top,o.cols*o.cell,o.rows*o.cell),s.restore(),Jo(t)}function ea(t,{x:e,y:r,alpha:n},s){let{ctx:o,grid:a,colors:i}=t,l=Math.
max(a.cell,16*s)*1.06,[c,d]=[G(a,e),j(a,r)];o.globalAlpha=Math.max(n,.6),o.beginPath(),o.roundRect(c-l/2,d-l/2,l,l,l*.2),o.strokeStyle=i.focus,o.lineWidth=Math.
max(2,2.5*s),o.stroke();let m=Math.max(11*s,Math.min(18*s,a.cell*.5)),p=d-l/2<m*1.2,h=d+(p?1:-1)*(l/2+m*.7);o.lineJoin="round",Mr(t,"You",c,h,m,i.ink,m*.35),o.globalAlpha=
1}function ta(t,e,r,n,s){let{ctx:o,grid:a}=t,i=Xo(t,e,n,s),l=at(t,e,r);o.globalAlpha=.11,o.fillStyle=l,o.fillRect(...i),o.globalAlpha=.8,o.strokeStyle=l,o.lineWidth=
Math.max(1,a.cell/24),o.strokeRect(...i),o.globalAlpha=1}function ra(t,e,r,n,s){let{ctx:o,grid:a}=t,i=Math.min(Math.ceil(r),e.moments.length-1),l=e.moments[i];o.
lineCap="round",o.lineWidth=Math.min(uc,Math.max(1,a.cell*cc));for(let c=Math.max(1,Math.floor(r-n)+1);c<=i;c++){let[d,m]=[e.moments[c-1],e.moments[c]],p=Math.max(
0,Math.min(1,(r-c)/n));o.globalAlpha=qo+(mc-qo)*p;for(let h=0;h<m.alive.length;h++){let f=c===i&&r<i;if(!d.alive[h]||!(l.alive[h]||f))continue;let g=(De(e,h)?-1:
1)*dc,[y,x]=$(d,h),[v,w]=$(m,h);if(y===v&&x===w)continue;let S=f?s[h].x:w+.5,A=f?s[h].y:v+.5;o.strokeStyle=at(t,e,h),o.beginPath(),o.moveTo(G(a,x+.5+g),j(a,y+.5+
g)),o.lineTo(G(a,S+g),j(a,A+g)),o.stroke()}}o.globalAlpha=1}function na(t,e,r){let n=Math.min(Math.ceil(r),e.moments.length-1);for(let s=Math.max(1,n-Vo+1);s<=n;s++){
let[o,a]=[e.moments[s-1],e.moments[s]],i=s>r?Math.max(0,1-2*(s-r)):1-(r-s)/Vo,l=Nt(e,o,a);for(let c of xr(o,a))l.includes(c)||hc(t,$(a,c),i);for(let c of l)pc(t,
$(a,c),i)}t.ctx.globalAlpha=1}function pc({ctx:t,grid:e,colors:r},[n,s],o){t.globalAlpha=o,Go(t,G(e,s+.5),j(e,n+.5),Math.max(8,e.cell*ac)),t.fillStyle=r.capture,
t.fill(),t.strokeStyle=r.ink,t.lineWidth=Math.max(1,e.cell/36),t.lineJoin="round",t.stroke()}function hc({ctx:t,grid:e,colors:r},[n,s],o){t.globalAlpha=o,Bo(t,G(
e,s+.5),j(e,n+.5),Math.max(7,e.cell*ic)),t.strokeStyle=r.collision,t.lineWidth=Math.max(2,e.cell*.17),t.lineCap="round",t.stroke()}function sa({ctx:t,grid:e,colors:r},n,s){
let o=Math.max(1,e.cell*.07);t.strokeStyle=t.fillStyle=r.collision,t.lineWidth=Math.max(1,e.cell*.05),t.setLineDash([e.cell*.14,e.cell*.1]);for(let[a,i]of n){if(a<
0||i<0||a>=e.rows||i>=e.cols)continue;let l=[G(e,i)+o,j(e,a)+o,e.cell-2*o,e.cell-2*o];t.globalAlpha=.2*s,t.fillRect(...l),t.globalAlpha=s,t.strokeRect(...l)}t.setLineDash(
[]),t.globalAlpha=1}function oa({ctx:t,grid:e,colors:r},n,s,o,a){t.globalAlpha=a,ze(t,G(e,n),j(e,s),Math.max(8,e.cell*o*1.02)),t.strokeStyle=r.collision,t.lineWidth=
Math.max(1.5,e.cell*.085*Math.sqrt(o)),t.stroke(),t.globalAlpha=1}var fc=.8,gc=.92,yc=15,vc=7,Gn=9;function aa(t,e,r,n,s,o){n.forEach((a,i)=>{a.alpha>0&&bc(t,e,r,i,a,s,o)}),t.ctx.globalAlpha=1;for(let a of It(e,r).values())a.length>
Gn&&wc(t,n[a[Gn-1]],a.length-Gn+1)}function bc(t,e,r,n,s,o,a){let{ctx:i,grid:l,colors:c}=t,d=De(e,n),[m,p]=[G(l,s.x),j(l,s.y)],h=Math.max(4,l.cell*s.size*(d?gc:
fc)),f=at(t,e,n),g=!d&&!!r.captured[n-e.nPursuers];if(i.globalAlpha=s.alpha,(d?Ar:ze)(i,m,p,h),h>vc*a&&(i.strokeStyle=c.paper,i.lineWidth=Math.max(2,h*.1),i.stroke()),
i.fillStyle=g?c.paper:f,i.fill(),g&&(ze(i,m,p,h*.82),i.strokeStyle=f,i.lineWidth=h*.18,i.stroke()),!o||h<yc*a)return;let y=String(d?n:n-e.nPursuers),x=h*(d?.4:.5)*
(y.length>1?.8:1);Mr(t,y,m,p+h*(d?.17:.03),x,g?f:c.paper)}function wc(t,e,r){let{cell:n}=t.grid;Mr(t,`+${r}`,G(t.grid,e.x),j(t.grid,e.y),n*.3,t.colors.ink,n*.1)}var xc=.46,Sc=.86,Ac=.66,ia=.48,Mc=.78,Ec=.58;function la(t,e,r,n){let[s,o]=[e.moments[r-1],e.moments[r]];if(!s)return;let{ctx:a,grid:i,colors:l}=t;a.strokeStyle=
l.collision,a.lineWidth=Math.max(1.5,i.cell*.07),a.lineCap="butt",a.globalAlpha=n;for(let c=0;c<o.alive.length;c++)vr(s,o,c)&&Tc(t,e,$(s,c),br(s,o,c));a.globalAlpha=
1}function Tc({ctx:t,grid:e},r,n,s){let[o,a]=[s[1]-n[1],s[0]-n[0]],i=m=>G(e,n[1]+.5+o*m),l=m=>j(e,n[0]+.5+a*m),c=Dn(r,s)?Mc:Ec;t.setLineDash([e.cell*.09,e.cell*
.06]),t.beginPath(),t.moveTo(i(ia),l(ia)),t.lineTo(i(c),l(c)),t.stroke(),t.setLineDash([]);let d=.17*e.cell/Math.hypot(o,a);t.beginPath(),t.moveTo(i(c)-a*d,l(c)+
o*d),t.lineTo(i(c)+a*d,l(c)-o*d),t.stroke()}function ca(t,e,r,n,s,o){let a=st[o];if(!o||!a)return;let{ctx:i,grid:l,colors:c}=t,d=Dn(e,[n[0]+a[0],n[1]+a[1]])?Sc:
Ac,m=xc*s.size,p=[G(l,s.x+a[1]*m),j(l,s.y+a[0]*m),G(l,s.x+a[1]*d),j(l,s.y+a[0]*d)],h=Math.max(1.5,l.cell*.085);i.lineCap=i.lineJoin="round";for(let[f,g]of[[c.paper,
h*2.1],[at(t,e,r),h]])i.strokeStyle=f,i.lineWidth=g,jo(i,...p,l.cell*.2),i.stroke()}var da={numbers:!0,axes:!1,trail:6,viewers:[],plan:null,selected:null,cursor:null,you:null,fog:!1};function ma(t,e,r,n,s){let{ctx:o,grid:a,colors:i}=t,l=Math.min(
Math.ceil(r),e.moments.length-1),c=e.moments[l],d=r===l,m=Sr(e,r),p=d?1:Math.max(0,1-2*(l-r));o.clearRect(0,0,o.canvas.width,o.canvas.height),Yo(t);for(let g of n.
viewers)m[g]?.alpha&&ta(t,e,g,...Bn(e,g,r));Ko(t,e),n.axes&&Zo(t,s),ra(t,e,r,n.trail,m),sa(t,c.contested??[],p),na(t,e,r),la(t,e,l,p),m.forEach(({x:g,y,size:x},v)=>{
let w=No(c,v)?.4:0,S=Hn(c,v)?1:w;S&&oa(t,g,y,x,S*p)});let h=d?c:e.moments[Math.max(0,l-1)];if(aa(t,e,h,m,n.numbers,s),d&&n.plan)for(let[g,y]of m.entries())y.alpha&&
ca(t,e,g,$(c,g),y,n.plan[g]??0);n.you!==null&&(n.fog&&Qo(t,e,...Bn(e,n.you,r)),ea(t,m[n.you],s)),o.lineWidth=Math.max(2,2.5*s),o.strokeStyle=i.focus;let f=n.selected===
null?void 0:m[n.selected];f?.alpha&&ua(t,f.x,f.y,f.size*.96),n.cursor&&(o.setLineDash([a.cell*.12,a.cell*.08]),ua(t,n.cursor[1]+.5,n.cursor[0]+.5,.8),o.setLineDash(
[]))}function ua({ctx:t,grid:e},r,n,s){let o=s*e.cell;t.beginPath(),t.roundRect(e.left+r*e.cell-o/2,e.top+n*e.cell-o/2,o,o,o*.1),t.stroke()}var pa=(t,e)=>(e+.24)/(t+.24);function ha(t,e,r,n,s,o){let a=r?28*o:0,i=(c,d)=>(c-a)/(d+2*.12),l=Math.max(1,Math.floor(Math.min(i(n,e),i(s,t))));return{rows:t,cols:e,
cell:l,left:Math.round((n-e*l+a)/2),top:Math.round((s-t*l+a)/2)}}function fa(t,e,r){let n=Math.floor((r-t.top)/t.cell),s=Math.floor((e-t.left)/t.cell);return n>=
0&&n<t.rows&&s>=0&&s<t.cols?[n,s]:null}var kc=["paper","line","frame","ink","muted","obstacle"],Cc=["pursuer","evader","capture","collision","focus"];function Er(t){let e=getComputedStyle(t),r=(n,s)=>[
n,e.getPropertyValue(s+n).trim()];return Object.fromEntries([...kc.map(n=>r(n,"--board-")),...Cc.map(n=>r(n,"--"))])}var ie=()=>matchMedia("(prefers-reduced-motion: reduce)").matches,Oe=class{canvas;#e=null;#t=0;#r;#n={rows:1,cols:1,left:0,top:0,cell:1};#o=0;constructor(e,r={}){
this.canvas=e,e.classList.add("board"),e.setAttribute("role","img"),this.#r={...da,...r},new ResizeObserver(()=>this.#i()).observe(e),new MutationObserver(()=>this.
redraw()).observe(document.documentElement,{attributes:!0}),addEventListener("beforeprint",()=>this.drawNow())}set look(e){this.#r={...this.#r,...e},this.#s(),this.
redraw()}show(e,r){this.#e=e,this.#t=Math.min(Math.max(0,r),e.moments.length-1),this.#s(),this.redraw()}redraw(){this.#o||(this.#o=requestAnimationFrame(()=>this.
drawNow()))}drawNow(){cancelAnimationFrame(this.#o),this.#o=0;let e=this.canvas.getContext("2d");if(!e||!this.#e)return;let{rows:r,cols:n}=this.#e,s=devicePixelRatio||
1;this.#n=ha(r,n,this.#r.axes,this.canvas.width,this.canvas.height,s);let o={ctx:e,grid:this.#n,colors:Er(this.canvas)};ma(o,this.#e,this.#t,this.#r,s)}cellAt(e,r){
let n=this.canvas.getBoundingClientRect(),s=this.canvas.width/n.width;return fa(this.#n,(e-n.left)*s,(r-n.top)*s)}agentAt(e,r){let n=this.cellAt(e,r);if(!n||!this.#e)
return null;let s=this.#e.moments[Math.round(this.#t)],o=It(this.#e,s).get(n[0]*this.#e.cols+n[1])??[],a=Sr(this.#e,Math.round(this.#t)),i=l=>{let[c,d]=this.pointOf(
a[l].x,a[l].y);return Math.hypot(c-e,d-r)};return o.length?o.reduce((l,c)=>i(c)<i(l)?c:l):null}pointOf(e,r){let n=this.canvas.getBoundingClientRect(),s=n.width/
this.canvas.width,{left:o,top:a,cell:i}=this.#n;return[n.left+(o+e*i)*s,n.top+(a+r*i)*s]}#s(){if(!this.#e)return;let{rows:e,cols:r}=this.#e;this.canvas.style.setProperty(
"--board-aspect",String(pa(e,r)))}#i(){let e=devicePixelRatio||1,{width:r,height:n}=this.canvas.getBoundingClientRect();this.canvas.width=Math.max(1,Math.round(
r*e)),this.canvas.height=Math.max(1,Math.round(n*e)),this.drawNow()}};var Ft=[.5,1,2,4,8,16,32,64],Tr=0,kr=12,Rc=2,pe=class extends EventTarget{#e;#t;#r;#n=0;#o=0;#s=!1;#i=null;#h=0;#m=[];#a=[];glide=.28;constructor(e,{speed:r=4,still:n=!1}={}){
super(),[this.#e,this.#t,this.#r]=[e,r,n]}get step(){return this.#n}get time(){return this.#r?this.#n:this.#o}get arrived(){return this.#o===this.#n}get playing(){
return this.#s}get length(){return this.#e}set length(e){this.#e=e,this.#n>e&&this.jump(e),this.#c("state")}get marks(){return this.#m}set marks(e){this.#m=e,this.#c(
"state")}get ticks(){return this.#a}set ticks(e){this.#a=e,this.#c("state")}get pace(){return this.#t||Math.max(Rc,this.#e/kr)}get speed(){return this.#t}set speed(e){
this.#t=e,this.#c("state")}changeSpeed(e){let r=Ft.findIndex(n=>n>=this.pace);this.speed=Ft[Math.min(Ft.length-1,Math.max(0,r+e))]}play(){this.#s||!this.#e||(this.#n===
this.#e&&this.jump(0),this.#s=!0,this.#c("state"),this.#u())}pause(){this.#s&&(this.#s=!1,this.#c("state"))}toggle(){this.#s?this.pause():this.play()}move(e){this.
pause();let r=Math.min(this.#e,Math.max(0,this.#n+e));Math.abs(r-this.#o)>1?this.jump(r):this.#d(r),this.#u()}jump(e){this.#o=Math.min(this.#e,Math.max(0,Math.round(
e))),this.#d(this.#o),this.#c("frame")}#d(e){e!==this.#n&&(this.#n=e,this.#c("step"),this.#r&&this.#c("frame"))}#u(){this.#i===null&&(this.#h=performance.now(),
this.#i=requestAnimationFrame(()=>this.#l()))}#l(){this.#i=null;let e=performance.now();this.#p(Math.min(.25,(e-this.#h)/1e3)),this.#h=e,(!this.#r||this.arrived)&&
this.#c("frame"),(this.#s||this.#o!==this.#n)&&(this.#i=requestAnimationFrame(()=>this.#l()))}#p(e){let r=e;for(;r>0;){if(this.#o===this.#n){if(!this.#s)return;
if(this.#n===this.#e)return this.pause();this.#d(this.#n+1)}let n=this.#s?this.pace:1/this.glide,s=this.#n-this.#o,o=Math.min(Math.abs(s),r*n);r-=o/n,this.#o=o===
Math.abs(s)?this.#n:this.#o+Math.sign(s)*o}this.#s&&this.#o===this.#e&&this.pause()}#c(e){this.dispatchEvent(new Event(e))}};function Cr(t,e){if(e.ctrlKey||e.metaKey||
e.altKey)return!1;let r=e.shiftKey?10:1,s={" ":()=>t.toggle(),ArrowRight:()=>t.move(r),ArrowLeft:()=>t.move(-r),Home:()=>t.move(-t.length),End:()=>t.move(t.length),
"+":()=>t.changeSpeed(1),"-":()=>t.changeSpeed(-1)}[e.key];return s?.(),s!==void 0}var Oc={first:"M6 5v14M19 5 9 12l10 7z",back:"M17 5 7 12l10 7z",play:"M7 4.5 19 12 7 19.5z",pause:"M8 5v14M16 5v14",forward:"M7 5l10 7-10 7z",last:"M18 5v14M5 5\
l10 7-10 7z"};function ga(t){return b("svg",{viewBox:"0 0 24 24","aria-hidden":"true",class:"icon"},b("path",{d:Oc[t]}))}function Ut(t,e,r,n){return u("button",
{type:"button",class:"player-button","aria-label":e,title:`${e} (${r})`,onclick:n},ga(t))}function $e(t){let e=Ut("play","Play","Space",()=>t.toggle()),r=u("inp\
ut",{type:"range",class:"player-scrub",min:0,step:1,"aria-label":"Step",oninput:()=>{t.pause(),t.jump(Number(r.value))}}),n=u("div",{class:"captures","aria-hidd\
en":"true",title:"Captures"}),s=u("div",{class:"losses","aria-hidden":"true"}),o=u("select",{class:"player-speed","aria-label":"Speed",title:`Steps a second, or\
 the whole in ${kr} s (+ and -)`,onchange:()=>t.speed=Number(o.value)},u("option",{value:Tr},`in ${kr} s`),...Ft.map(m=>u("option",{value:m},`${m} / s`))),a=u("\
output",{class:"player-count"}),i=u("div",{class:"player",role:"group","aria-label":"Player"},Ut("first","First step","Home",()=>t.move(-t.length)),Ut("back","S\
tep back","←",()=>t.move(-1)),e,Ut("forward","Step forward","→",()=>t.move(1)),Ut("last","Last step","End",()=>t.move(t.length)),u("div",{class:"scrub"},n,s,
r),a,o),l=(m,p={})=>{let h=u("i",p);return h.style.left=`${100*m/Math.max(1,t.length)}%`,h},c=()=>{n.replaceChildren(...t.marks.map(m=>l(m))),s.replaceChildren(
...t.ticks.map(({step:m,kind:p,size:h,text:f})=>{let g=l(m,{class:p,title:`Step ${m}: ${f}`});return g.style.height=`${100*h}%`,g}))},d=()=>{e.replaceChildren(ga(
t.playing?"pause":"play")),e.ariaLabel=t.playing?"Pause":"Play",e.title=`${e.ariaLabel} (Space)`,r.max=String(t.length),r.value=String(t.step),r.ariaValueText=`\
step ${t.step} of ${t.length}`,a.textContent=`${t.step} / ${t.length}`,a.style.minWidth=`${2*String(t.length).length+3}ch`,o.value=String(t.speed)};return t.addEventListener(
"step",d),t.addEventListener("state",d),t.addEventListener("state",c),i.addEventListener("keydown",m=>{!(m.target instanceof HTMLSelectElement||m.key===" "&&m.target!==
r)&&Cr(t,m)&&m.preventDefault()}),d(),i}var Rr={left:46,right:12,top:10,bottom:42},ya={x:56,y:34};function he(t,e,r,n){let[s,o]=[Rr.left,Rr.top],a=Math.max(s+40,t-Rr.right),i=Math.max(o+40,e-Rr.bottom),
l=(g,y,x)=>v=>y+(v-g.low)/(g.high-g.low||1)*(x-y),[c,d]=[l(r,s,a),l(n,i,o)],m=b("g"),p=b("svg",{width:t,height:e,viewBox:`0 0 ${t} ${e}`,class:"plot"}),h=b("g",
{class:"axes"});for(let g of Rt(n.low,n.high,(i-o)/ya.y,n.whole))h.append(b("line",{x1:s,x2:a,y1:d(g),y2:d(g),class:"grid"}),b("text",{x:s-8,y:d(g),"text-anchor":"\
end","dominant-baseline":"middle"},va(g)));for(let g of Rt(r.low,r.high,(a-s)/ya.x,r.whole))h.append(b("text",{x:c(g),y:i+16,"text-anchor":"middle"},va(g)));return h.
append(b("line",{x1:s,x2:a,y1:i,y2:i,class:"axis"}),b("text",{x:(s+a)/2,y:e-6,"text-anchor":"middle",class:"label"},r.label),b("text",{transform:`translate(12 ${(o+
i)/2}) rotate(-90)`,"text-anchor":"middle",class:"label"},n.label)),p.append(h,m),{root:p,marks:m,left:s,right:a,top:o,bottom:i,x:c,y:d,at:g=>{let y=g-p.getBoundingClientRect().
left;return r.low+(y-s)/(a-s)*(r.high-r.low)}}}var va=t=>String(Number(t.toPrecision(6))).replace("-","−");function fe(t,e,r,n){let s="",o="M";r.forEach((a,i)=>{
a===null?o="M":(s+=`${o}${t.x(e[i]).toFixed(1)} ${t.y(a).toFixed(1)}`,o="L")}),t.root.insertBefore(b("path",{d:s,class:`line ${n}`}),t.marks)}function ba(t,e,r,n=null){let s=t.x(e);t.marks.append(b("line",{x1:s,x2:s,y1:t.top,y2:t.bottom,class:`mark ${r}`})),n!==null&&t.marks.append(b("circle",{cx:s,cy:t.
y(n),r:5,class:`dot ${r}`}))}function it(...t){return u("p",{class:"legend small"},...t.map(([e,r])=>u("span",{class:`key ${r}`},e)))}function ge(t,e,r,n){let s=u(
"div",{class:"chart chooses",role:"img","aria-label":t}),o=null,a=()=>{o?.marks.replaceChildren(),o&&r(o)};s.addEventListener("click",l=>o&&n(o.at(l.clientX),o,
l));let i=()=>{let{clientWidth:l,clientHeight:c}=s;l<50||c<50||(o=e(l,c),s.replaceChildren(o.root),a())};return new ResizeObserver(i).observe(s),{element:s,update:a,
redraw:i}}var Wt=[[68,1,84],[72,26,108],[71,47,125],[65,68,135],[57,86,140],[49,104,142],[42,120,142],[35,136,142],[31,152,139],[34,168,132],[53,183,121],[84,197,104],[122,
209,81],[165,219,54],[210,226,27],[253,231,37]];function Or(t){let e=Math.min(1,Math.max(0,t))*(Wt.length-1),r=Math.min(Wt.length-2,Math.floor(e)),[n,s]=[Wt[r],
Wt[r+1]],o=a=>Math.round(n[a]+(e-r)*(s[a]-n[a]));return[o(0),o(1),o(2)]}function wa(t){let[e,r,n]=Or(t).map(s=>((s/255+.055)/1.055)**2.4);return .2126*e+.7152*r+
.0722*n>.179?"#000":"#fff"}var xa=t=>`rgb(${Or(t).join(" ")})`,Sa=()=>`linear-gradient(to right, ${Wt.map(t=>`rgb(${t.join(" ")})`).join(", ")})`;function lt(t,e,r){let n=devicePixelRatio||1;for(let[a,i]of Object.entries(r))t.style.setProperty(a,`${i}px`);t.width=Math.round(r.width*n),t.height=Math.round(
r.height*n);let s=t.getContext("2d"),o=$c(e);!s||!o||(s.imageSmoothingEnabled=!1,s.drawImage(o,0,0,t.width,t.height))}function $c(t){let[e,r]=t.shape,n=document.
createElement("canvas");[n.width,n.height]=[r,e];let s=n.getContext("2d");if(!s)return null;let o=s.createImageData(r,e);return t.capture_rate.forEach((a,i)=>a.
forEach((l,c)=>{let d=4*((e-1-i-t.first[0])*r+c+t.first[1]);o.data.set([...Or(l),255],d)})),s.putImageData(o,0,0),n}function $r(t,e,r,n=2){t.textContent=F(e,n),
t.ariaLabel=`${r}: ${t.textContent}`,e!==void 0&&([t.style.backgroundColor,t.style.color]=[xa(e),wa(e)])}function Me(t,e){let r=u("span",{class:"gradient"});return r.
style.backgroundImage=Sa(),u("p",{class:"scale-of-rates small muted"},t,r,e)}function He(t,e,r=t.length){let n=u("canvas",{role:"img","aria-label":e}),s=u("div",{class:"cells-of-matrix"},n),o=u("figure",{},u("figcaption",{},e),s,u("p",{class:"\
small muted"},u("span",{class:"pursuer"},"↑ pursuers")," ",u("span",{class:"evader"},"evaders →")));return o.draw=()=>{let a=s.clientWidth;a&&lt(n,{shape:[r,
r],first:[0,0],capture_rate:t},{left:0,top:0,width:a,height:a})},new ResizeObserver(()=>o.draw?.()).observe(s),o}var Ma=()=>Me("0 all escape","1 all caught"),Ea=({
runs:t})=>u("div",{class:"widget"},u("div",{class:"matrices"},...t.map((e,r)=>He(e.payoff.capture_rate,`Matrix ${"ABC"[r]}`))),Ma()),Pr=31,Aa=.016;function Ta(){
let t=r=>Array.from({length:Pr},(n,s)=>Array.from({length:Pr},(o,a)=>.5+r*(s-a))),e=[[Aa,"Both get better"],[-Aa,"Both get worse"],[0,"Nothing happens"]];return u(
"div",{class:"widget"},u("div",{class:"matrices"},...e.map(([r,n])=>He(t(r),n))),Ma())}function ka(){let t=Array.from({length:Pr},(r,n)=>n),e=ge("A capture rate\
 that stays at one half from generation 0 to 30",(r,n)=>{let s=he(r,n,{low:0,high:Pr-1,label:"generation",whole:!0},{low:0,high:1,label:"capture rate"});return fe(
s,t,t.map(()=>.5),"of-both"),s},()=>{},()=>{});return u("div",{class:"widget"},e.element)}var ye=32,Ca=({crossings:t=[]})=>u("div",{class:"widget crossings"},...t.
map(e=>u("figure",{},u("figcaption",{},e.title),Pc(e),u("p",{class:"small muted"},e.text))));function Pc({title:t,text:e,ways:r}){let n=[0,1,2,3].map(s=>`M${s*ye}\
 0V${3*ye}M0 ${s*ye}H${3*ye}`).join("");return b("svg",{viewBox:`-1 -1 ${3*ye+2} ${3*ye+2}`,role:"img","aria-label":`${t}: ${e}`},b("path",{class:"grid",d:n}),...r.
map(([s,o,a],i)=>b("g",{transform:`translate(${1.5*ye} ${1.5*ye})`},b("g",{transform:`translate(${-ye*o} ${-ye*s})`},b("path",{class:"filled-pursuer",d:"M0 -12 \
12 9H-12z"}),b("text",{y:6.5,"text-anchor":"middle"},`P${i}`)),b("path",{class:a?"goes":"waits",d:a?"M-18 0H-5M-9 -4 -4 0 -9 4":"M-16 -13V13",transform:`rotate(${Math.
atan2(s,o)*180/Math.PI})`}))))}function Be(t,e,r,n,s){let o=u("input",{type:"range",min:0,max:e.length-1,step:1,"aria-label":t,oninput:()=>s(i())}),a=u("output",{class:"numbers"}),i=()=>{let l=e[Number(
o.value)];return a.textContent=o.ariaValueText=n(l),l};return o.value=String(e.indexOf(r)),i(),u("label",{class:"slider"},u("span",{},t),o,a)}function Ra(t,e,r){
return u("label",{class:"slider"},u("span",{},t),ar(e.map(n=>[n,n]),r))}function Pe(t){let e=t>>>0;return()=>{e=e+1831565813>>>0;let r=Math.imul(e^e>>>15,e|1);return r^=r+Math.imul(r^r>>>7,r|61),((r^r>>>14)>>>0)/2**32}}var Vn=["rock",
"paper","scissors"],qn=[[.5,0,1],[1,.5,0],[0,1,.5]],_c=1e-9,Pa=t=>qn.map(e=>e.reduce((r,n,s)=>r+n*t[s],0));function Yn(t,e){let r=t.slice(-e);return Vn.map((n,s)=>r.
filter(o=>o===s).length/r.length)}var Kn=t=>Math.max(...Pa(t));function Oa(t,e,r){let n=Pa(Yn(t,e)),s=n.flatMap((o,a)=>o>Math.max(...n)-_c?[a]:[]);return s[s.length>
1?Math.floor(r()*s.length):0]}function Lr(t,e,r){let n={pursuers:[0],evaders:[0]};for(let s=1;s<=t;s++)n.pursuers.push(Oa(n.evaders,e,r)),n.evaders.push(Oa(n.pursuers,
e,r));return n}var Dt=100,Nr={scalar:{dimensions:1,greatest:!0},focusing:{dimensions:10,greatest:!0},intransitive:{dimensions:2,greatest:!1}};function jn(t,e,r){
let{greatest:n}=Nr[t],s=e[0]-r[0];for(let o=1;o<e.length;o++){let a=e[o]-r[o];(n?Math.abs(a)>Math.abs(s):Math.abs(a)<Math.abs(s))&&(s=a)}return(1+Math.sign(s))/
2}var Jn=(t,e,r)=>e.reduce((n,s)=>n+r.reduce((o,a)=>o+jn(t,s,a),0),0)/(e.length*r.length),ut={population:25,mutation:.005,opponents:15,hall:0},ct=class{game;settings;generation=0;#e;#t;#r=[
[],[]];constructor(e,r,n){[this.game,this.settings,this.#e]=[e,r,n];let s=()=>Array.from({length:r.population},()=>new Uint8Array(Dt));this.#t=[s(),s()]}ones(e){
let{dimensions:r}=Nr[this.game],n=Dt/r;return this.#t[e].map(s=>Array.from({length:r},(o,a)=>_r(s.subarray(a*n,(a+1)*n))))}objective=e=>_r(this.#t[e].map(_r))/this.
settings.population;step(){let e=[this.ones(0),this.ones(1)],r=this.#n(e);for(let n of[0,1]){this.#r[n].push(e[n][r[n].indexOf(Math.max(...r[n]))]);let s=this.#s(
r[n]);this.#t[n]=s.map(o=>this.#o(this.#t[n][o]))}this.generation++}#n(e){let{population:r,opponents:n,hall:s}=this.settings,o=[new Array(r).fill(0),new Array(r).
fill(0)];for(let a=0;a<n;a++)$a(r,this.#e).forEach((i,l)=>{let c=jn(this.game,e[0][l],e[1][i]);o[0][l]+=+(c===1),o[1][i]+=+(c===0)});for(let a of[0,1]){let i=this.#r[1-
a];for(let l of $a(i.length,this.#e,s))e[a].forEach((c,d)=>o[a][d]+=+(jn(this.game,c,i[l])===1))}return o}#o(e){let r=e.slice();for(let n=0;n<r.length;n++)this.#e()<
this.settings.mutation&&(r[n]^=1);return r}#s(e){let r=_r(e),n=r?e:e.map(()=>1);return e.map(()=>{let s=this.#e()*(r||e.length),o=n.findIndex(a=>(s-=a)<0);return o<
0?e.length-1:o})}};function $a(t,e,r=t){let n=Array.from({length:t},(o,a)=>a),s=Math.min(r,t);for(let o=0;o<s;o++){let a=o+Math.floor(e()*(t-o));[n[o],n[a]]=[n[a],
n[o]]}return n.slice(0,s)}function _r(t){let e=0;for(let r=0;r<t.length;r++)e+=t[r];return e}var Zn=1,Ir=["pursuers","evaders"],Na=[[150,42],[266,232],[34,232]],Lc={pursuers:-7,evaders:7},_a=t=>[0,1].map(e=>t.reduce((r,n,s)=>r+n*Na[s][e],0)),La=(t,e)=>t.
map((r,n)=>Yn(t.slice(0,n+1),e));function Ia({memories:t=[1],memory:e=t[0],generations:r=30}){let n=new pe(r,{speed:r>100?16:2,still:ie()}),s=e,o=Lr(r,s,Pe(Zn)),
a={pursuers:[],evaders:[]},i={pursuers:b("polyline",{class:"way of-pursuers"}),evaders:b("polyline",{class:"way of-evaders"})},l={pursuers:b("path",{class:"fill\
ed-pursuer",d:"M0 -11 11 9H-11z"}),evaders:b("circle",{class:"filled-evader",r:9})},c=b("svg",{viewBox:"0 0 300 270",class:"hands-triangle",role:"img","aria-lab\
el":"The shares of rock, paper and scissors among the remembered hands of both teams"},b("polygon",{class:"frame",points:Na.map(y=>y.join()).join(" ")}),b("circ\
le",{class:"middle",cx:150,cy:168.7,r:4}),b("text",{x:150,y:192,"text-anchor":"middle"},"one third each"),b("text",{class:"label",x:150,y:18,"text-anchor":"midd\
le"},"rock"),b("text",{class:"label",x:266,y:262,"text-anchor":"middle"},"paper"),b("text",{class:"label",x:34,y:262,"text-anchor":"middle"},"scissors"),...Ir.map(
y=>i[y]),...Ir.map(y=>l[y])),d=u("p",{class:"numbers"}),m=ge("What the best answer wins against the remembered hands, by generation",(y,x)=>{let v=he(y,x,{low:0,
high:r,label:"generation",whole:!0},{low:.4,high:1,label:"best answer wins"});fe(v,[0,r],[.5,.5],"half");for(let w of Ir)fe(v,o[w].map((S,A)=>A),a[w].map(Kn),`o\
f-${w}`);return v},y=>ba(y,n.step,"of-both"),y=>n.jump(y)),p=()=>{let y=n.step;for(let v of Ir){i[v].setAttribute("points",a[v].slice(0,y+1).map(A=>_a(A).map(k=>k.
toFixed(1)).join()).join(" "));let[w,S]=_a(a[v][y]);l[v].setAttribute("transform",`translate(${w+Lc[v]} ${S})`)}let x=v=>u("span",{class:v.slice(0,-1)},`${v} sh\
ow ${Vn[o[v][y]]}`);d.replaceChildren(`Generation ${y}: `,x("pursuers"),", ",x("evaders"),".",...t.length>1?[` The best answer to the remembered hands of the pu\
rsuers wins ${F(Kn(a.pursuers[y]))}.`]:[]),m.update()},h=()=>{o=Lr(r,s,Pe(Zn)),a={pursuers:La(o.pursuers,s),evaders:La(o.evaders,s)},m.redraw(),p()};n.addEventListener(
"step",p),h();let f=t.at(-1),g=Be("memory (hands)",t,e,y=>y===f?"all":String(y),y=>{s=y,h()});return u("div",{class:"widget"},t.length>1&&g,u("div",{class:"two"},
u("div",{},c),t.length>1&&u("div",{},it(["pursuers' hands","of-pursuers"],["evaders' hands","of-evaders"]),m.element)),d,$e(n))}function Fa({generations:t=30}){
let{pursuers:e,evaders:r}=Lr(t,1,Pe(Zn)),n=e.map(o=>r.map(a=>qn[o][a])),s=n.at(-1);return u("div",{class:"widget"},u("div",{class:"matrices"},He(n,`The last pur\
suers score ${F(s.reduce((o,a)=>o+a,0)/s.length)} against all evaders.`)),Me("0 loses","1 wins"))}var zt=600,dt=20,Xn=5,Ht=10,Qn={"Game A":"intransitive","Game B":"scalar","Game C":"focusing"},Wa={low:0,high:zt,label:"generation",whole:!0},Da={low:0,high:Dt,
label:"ones of side 1"},Ge=()=>{},Nc=()=>new Promise(t=>setTimeout(t));async function es(t,e,r){for(e();t.generation<zt&&r();e()){for(let n=0;n<dt;n++)t.step();
await Nc()}}var Fr=new Map,za=[];async function Ic(){for(let t of Object.keys(Qn))Fr.set(t,[]);for(let t=0;t<Xn;t++)for(let[e,r]of Object.entries(Qn)){let n={score:[],
ones:[]};Fr.get(e).push(n);let s=new ct(r,ut,Pe(t));await es(s,()=>{n.score.push(Jn(r,s.ones(0),s.ones(1))),n.ones.push(s.objective(0))},()=>!0),za.forEach(o=>o())}}
function Ha({shows:t="score"}){Fr.size||Ic();let e=t==="score"?{low:0,high:1,label:"score of side 1"}:Da,r=Object.entries(Qn).map(([n,s])=>{let o=t==="score"?n:
`${n}: ${s}`,a=ge(`${o}: ${e.label} in ${Xn} races`,(i,l)=>{let c=he(i,l,Wa,e);for(let d of Fr.get(n))fe(c,d[t].map((m,p)=>p*dt),d[t],"of-both dense");return c},
Ge,Ge);return za.push(a.redraw),u("figure",{},u("figcaption",{},o),a.element)});return u("div",{class:"widget"},u("div",{class:"matrices"},...r),u("p",{class:"s\
mall muted"},`Each line is a race; there are ${Xn} of each game, played now, in this page.`))}var Fc=[5,10,15,25,40,60],Uc=[5e-4,.001,.002,.005,.01,.02,.05],Wc=[
0,1,5,15,30],Ua=15,Dc=Array.from({length:20},(t,e)=>e);function Ba({hall:t=!1}){let[e,r,n]=["scalar",0,{...ut,hall:t?Ua:0}],s=0,o=v=>{n={...n,...v}},a=[[],[]],i=[
He(a[0],"Score of side 1",zt/dt+1),He(a[1],"Score of side 2",zt/dt+1)];i.forEach(v=>v.querySelector("p").replaceChildren(`↑ generation, → opponent (${dt} a \
cell)`));let l=[[],[]],c=ge("Ones of both sides by generation",(v,w)=>{let S=he(v,w,Wa,{...Da,label:"ones"});return l.forEach((A,k)=>fe(S,A.map((R,E)=>E*dt),A,k?
"of-evaders":"of-pursuers")),S},Ge,Ge),d=u("p",{class:"numbers",role:"status"}),m=v=>{d.textContent=v},p=async()=>{let v=++s;for(let A of[...a,...l])A.length=0;
let w=[[],[]],S=new ct(e,n,Pe(r));await es(S,()=>{for(let A of[0,1])w[A].push(S.ones(A)),l[A].push(S.objective(A));for(let A of[0,1])a[A].push(w[1-A].map(k=>Jn(
S.game,w[A].at(-1),k)));i.forEach(A=>A.draw?.()),c.redraw()},()=>s===v),s===v&&m(`${de(S.game)} game, seed ${r}: after ${zt} generations side 1 has ${l[0].at(-1).
toFixed(0)} ones, side 2 ${l[1].at(-1).toFixed(0)}.`)},h=[],f=ge("Ones of side 1 at the end of ten races, a row for each choice of settings",(v,w)=>zc(h,v,w),Ge,
Ge);f.element.classList.add("dots");let g=async v=>{let w=++s,S=[],{population:A,mutation:k}=v,R=`${e}${A===ut.population?"":`, ${A} players`}${k===ut.mutation?
"":`, mutation ${k}`}, hall ${v.hall}`;h=[...h.filter(E=>E.ends.length===Ht&&E.text!==R).slice(1-ts),{text:R,ends:S}];for(let E=0;E<Ht&&s===w;E++){let M=new ct(
e,v,Pe(E));await es(M,Ge,()=>s===w),s===w&&S.push(M.objective(0)),f.redraw()}s===w&&m(`${de(R)}: side 1 ends with ${Ga(S)} ones in the mean of ${Ht} races.`)},y=(v,w,S="")=>u(
"button",{type:"button",class:S,onclick:()=>{v()}},w),x=u("div",{class:"sliders"},Ra("game",Object.keys(Nr),v=>e=v),Be("population",Fc,n.population,String,v=>o(
{population:v})),Be("mutation",Uc,n.mutation,String,v=>o({mutation:v})),...t?[Be("hall of fame",Wc,Ua,String,v=>o({hall:v}))]:[Be("seed",Dc,0,String,v=>r=v)]);return t?
(g(ut).then(()=>s===1?g(n):void 0),u("div",{class:"widget"},x,u("div",{class:"buttons"},y(()=>g(n),"Play ten races","primary")),d,f.element)):u("div",{class:"wi\
dget"},x,u("div",{class:"buttons"},y(p,"Play a race","primary"),y(async()=>{s++},"Stop")),u("div",{class:"matrices"},...i,u("figure",{},u("figcaption",{},"The t\
ruth: ones"),it(["side 1","of-pursuers"],["side 2","of-evaders"]),c.element)),Me("0 loses","1 wins"),d)}var ts=6,Ga=t=>(t.reduce((e,r)=>e+r,0)/t.length).toFixed(
1);function zc(t,e,r){let n=he(e,r,{low:0,high:Dt,label:"ones of side 1 at the end",whole:!0},{low:0,high:ts,label:""});return n.root.querySelectorAll(".axes .g\
rid, .axes [text-anchor=end]").forEach(s=>s.remove()),t.forEach(({text:s,ends:o},a)=>{let i=n.y(ts-a-.7);n.marks.before(b("text",{class:"label",x:n.left,y:i-12},
`${s}: ${o.length<Ht?`${o.length} of ${Ht} races`:`mean ${Ga(o)}`}`)),o.forEach(l=>n.marks.before(b("circle",{class:"dot of-both",cx:n.x(l),cy:i,r:5})))}),n}var Va=t=>t.answer===void 0?Bc():Hc(t,t.answer);function Hc(t,e){let r=u("input",{type:"text",inputmode:"decimal",size:8,"aria-label":"Your answer, a number",autocomplete:"\
off"});return{input:r,check:()=>{let s=r.value.trim().replace(",","."),o=Number(s);if(s===""||Number.isNaN(o))return"Expected a number, such as 0.5.";let a=i=>Math.
abs(o-i)<=(t.tolerance??0)+1e-9;return a(e)?null:t.clues?.find(([i])=>a(i))?.[1]??t.otherwise??"Expected another number."},answer:()=>r.value,set:s=>r.value=s}}
var le=4,rs=[.5,.8,.2];function Bc(){let t=new Array(le*le).fill(.5),e=(l,c)=>$r(l,t[c],`generation ${Math.floor(c/le)} of the pursuers against generation ${c%le}\
 of the evaders`,1),r=t.map((l,c)=>{let d=u("button",{type:"button",disabled:c%(le+1)===0,onclick:()=>{t[c]=rs[(rs.indexOf(t[c])+1)%rs.length],e(d,c)}});return e(
d,c),d}),n=Array.from({length:le},(l,c)=>c),s=u("div",{class:"cells numbers",role:"group","aria-label":"Capture rates: rows are pursuers, columns evaders"},u("s\
pan"),u("span",{class:"evader all"},"generation of the evaders"),u("span",{class:"pursuer"},"generation of the pursuers"),...n.map(l=>u("span",{class:"evader"},
l)),...n.flatMap(l=>[u("span",{class:"pursuer"},l),...r.slice(l*le,(l+1)*le)])),o=l=>n.map(c=>n.reduce((d,m)=>d+t[l(c,m)],0)/le);return{input:s,check:()=>{let l=o(
(m,p)=>m*le+p),c=o((m,p)=>p*le+m),d=(m,p)=>m.every((h,f)=>!f||p*(h-m[f-1])>1e-9);return d(l,1)?d(c,-1)?null:`The means of the columns are ${ja(c)}. They say how\
 often the evaders are captured, and should fall from column to column.`:`The means of the rows are ${ja(l)}. They are the strengths of the pursuers, and should\
 grow from row to row.`},answer:()=>t.join(" "),set:l=>{l.split(" ").forEach((c,d)=>t[d]=Number(c)),r.forEach(e)}}}var ja=t=>t.map(e=>e.toFixed(2)).join(", ");var Bt=t=>t.trim().split(/\n\s*\n/).map(e=>u("p",{},...ns(e))),ns=t=>t.split("**").map((e,r)=>r%2?u("strong",{},e):document.createTextNode(e));function qa(t,e){
let{predict:r,options:n}=t,s=u("p",{class:"small muted",role:"status"}),o=u("button",{type:"submit",class:"primary"},"This is my prediction"),a=Object.keys(n).map(
c=>u("input",{type:"radio",name:`prediction-${r}`,value:c})),i=u("form",{class:"prediction",id:`prediction-${r}`},u("fieldset",{},u("legend",{},u("strong",{},"P\
redict. "),t.question),...a.map(c=>u("label",{class:"option"},c,u("span",{},n[c.value])))),u("div",{class:"buttons"},o,s)),l=()=>{let c=e.choice(r);if(c!==void 0){
for(let d of a)[d.checked,d.disabled]=[d.value===c,!0];o.hidden=o.disabled=!0,s.replaceChildren(),i.append(t.later?u("p",{class:"reply"},t.later):Gc(t,c,t.again&&
e.choice(t.again)))}};return i.addEventListener("submit",c=>{c.preventDefault();let d=a.find(m=>m.checked);d?(e.choose(r,d.value),l()):s.textContent="Choose one\
 first. Any prediction is a good one."}),l(),i}function Gc(t,e,r){let{options:n,outcome:s}=t,o=e===s;return u("div",{class:"reply",role:"status","data-right":String(
o)},r&&u("p",{},u("strong",{},"At the beginning you predicted: "),n[r]),u("p",{},u("strong",{},o?"✓ As you predicted: ":"You predicted: "),n[e]),o?null:u("p",
{},u("strong",{},"The outcome: "),n[s]),...Bt(t.explanation??""),t.note&&u("p",{class:"small muted"},t.note))}function Ya(t,e){let{input:r,check:n,answer:s,set:o}=Va(
t),a=u("p",{class:"reply",role:"status",hidden:!0}),i=d=>{a.hidden=!1,a.dataset.right=String(d===null),a.replaceChildren(u("strong",{},d===null?"✓ Right. ":"✗\
 Not yet. "),d??t.explanation)},l=u("form",{class:"exercise",id:`exercise-${t.exercise}`},u("div",{class:"text"},u("p",{},u("strong",{},"Exercise. "),...ns(t.question))),
t.matrix&&jc(t.matrix),u("div",{class:"buttons"},r,u("button",{type:"submit"},"Check")),a);l.addEventListener("submit",d=>{d.preventDefault();let m=n();m===null&&
e.solve(t.exercise,s()),i(m)});let c=e.solved(t.exercise);return c!==void 0&&(o(c),i(null)),l}function jc(t){let e=t.map((r,n)=>n);return u("div",{class:"wide-t\
able",tabindex:0},u("table",{class:"rates numbers"},u("thead",{},u("tr",{},u("td"),u("th",{scope:"colgroup",colspan:e.length,class:"evader"},"generation of the \
evaders")),u("tr",{},u("th",{class:"pursuer"},"generation of the pursuers"),...e.map(r=>u("th",{scope:"col"},r)))),u("tbody",{},...t.map((r,n)=>u("tr",{},u("th",
{scope:"row"},n),...r.map(s=>u("td",{},s.toFixed(1))))))))}var Vc=40;function Ka({question:t="",points:e=[]},r){let n=u("textarea",{id:"exit-answer",rows:8,oninput:()=>{
r.exit={exit:n.value},s.textContent=n.value}}),s=u("p",{class:"printed"}),o=u("p",{class:"small muted",role:"status"}),a=u("button",{type:"submit",class:"primar\
y"},"I am done"),i=u("form",{class:"exercise"},u("label",{for:"exit-answer"},u("strong",{},"Exit question. "),t),n,s,u("div",{class:"buttons"},a,u("button",{type:"\
button",onclick:()=>nt("exit_answer.txt",`${t}

${n.value}
`)},"Save my answer"),o)),l=()=>{s.textContent=r.exit.exit,r.exit.done&&([n.readOnly,a.hidden]=[!0,!0],i.append(u("div",{class:"reply"},u("p",{},u("strong",{},"\
A good answer has:")),u("ul",{},...e.map(c=>u("li",{},...ns(c)))))))};return n.value=r.exit.exit,i.addEventListener("submit",c=>{if(c.preventDefault(),n.value.trim().
length<Vc){o.textContent="Write two explanations and an experiment first. Then the page shows what a good answer has.";return}o.textContent="",r.exit={done:!0},
l()}),l(),u("div",{class:"widget"},i)}var qc=Array.from({length:16},(t,e)=>{let[r,n]=[e%2?6.5:11,Math.PI*e/8];return`${12+r*Math.sin(n)} ${12-r*Math.cos(n)}`}).join(" ");function Ur(){let t=[["pursu\
er",b("path",{d:"M12 3 22 20H2z",class:"filled-pursuer"})],["evader",b("circle",{cx:12,cy:12,r:9,class:"filled-evader"})],["capture",b("polygon",{points:qc,class:"\
filled-capture"})],["captured evader",b("circle",{cx:12,cy:12,r:7.5,class:"ring-evader"})],["conflict",b("rect",{x:3,y:3,width:18,height:18,class:"dashed-confli\
ct"})]];return u("ul",{class:"shapes small","aria-label":"Shapes on the board"},...t.map(([e,r])=>u("li",{},b("svg",{viewBox:"0 0 24 24","aria-hidden":"true"},r),
e)))}function ss(t,e,r){let{rows:n,cols:s,n_pursuers:o,fov:a,rules:{interaction:i}}=t;return{rows:n,cols:s,nPursuers:o,fov:a,interaction:i,obstacles:e,moments:r}}function os(t,e){
return{positions:t.read("last_positions"),alive:t.read("alive"),captured:t.read("captured"),everCaptured:t.read("ever_captured"),actions:e,involved:t.read("invo\
lved"),fault:t.read("fault"),contested:t.conflicts().map(r=>r.cell)}}function Wr(t){let e=Array.from({length:t.length+1},(r,n)=>Yc(t,n));return ss(t.config,t.map,
e)}function Yc(t,e){let r=t.n_agents,n=t.config.n_evaders,s=(a,i,l)=>a.subarray(i*l,(i+1)*l),o={positions:s(t.last_positions,e,2*r),alive:s(t.alive,e,r),captured:s(
t.captured,e,n),everCaptured:s(t.ever_captured,e,n)};return e===0?o:{...o,actions:s(t.actions,e-1,r),involved:s(t.involved,e-1,3*r),fault:s(t.fault,e-1,3*r),get contested(){
return t.conflicts(e).map(a=>a.cell)}}}var Kc=8,Jc=700,Ja=1400,je=class{element;player=new pe(0,{speed:Kc,still:ie()});title=u("figcaption");generation=0;#e=u("canvas");#t;#r=u("p",{class:"small mute\
d numbers"});#n=u("p",{class:"small",role:"status"});#o;#s=null;#i=0;#h=0;#m=!ie();constructor(e){this.#o=e,this.#t=new Oe(this.#e,{numbers:!1}),this.element=u(
"figure",{class:"chase"},this.title,this.#e,this.#r,this.#n),this.player.addEventListener("frame",()=>this.#u()),this.player.addEventListener("step",()=>this.#l()),
this.player.addEventListener("state",()=>{this.#m&&!this.player.playing&&this.player.length&&this.player.step===this.player.length&&this.#a()})}set label(e){this.#e.
ariaLabel=e}get runs(){return this.#m}set runs(e){this.#m=e,clearTimeout(this.#h),e?this.player.play():this.player.pause()}renew(e=!1){e||!this.#s||performance.
now()-this.#i>Ja?this.#d():this.#a(Ja)}#a(e=Jc){clearTimeout(this.#h),this.#h=setTimeout(()=>this.#d(),e)}#d(){clearTimeout(this.#h);let e=this.#o();e&&(this.#s=
Wr(e),this.#i=performance.now(),this.player.jump(0),this.player.length=e.length,this.player.marks=wr(this.#s),this.#l(),this.#m&&this.player.play())}#u(){this.#s&&
this.#t.show(this.#s,this.player.time)}#l(){let e=this.#s?.moments[this.player.step]?.everCaptured;e&&(this.#r.textContent=`generation ${this.generation} · ${Array.
from(e).filter(Boolean).length} of ${e.length} caught · step ${this.player.step}`)}drawWalls(e){let r=!1,n=!0,s=[0,0],o=([l,c])=>!!this.#s?.obstacles[l*this.#s.
cols+c],a=(l,c)=>{this.#n.textContent=e(l,c)},i=l=>{let c=this.#t.cellAt(l.clientX,l.clientY);c&&o(c)!==n&&a(c,n)};return this.#e.addEventListener("pointerdown",
l=>{let c=r&&this.#t.cellAt(l.clientX,l.clientY);c&&(this.#e.setPointerCapture(l.pointerId),n=!o(c),i(l))}),this.#e.addEventListener("pointermove",l=>r&&l.buttons&&
i(l)),this.#e.addEventListener("keydown",l=>{let c={ArrowUp:[-1,0],ArrowDown:[1,0],ArrowLeft:[0,-1],ArrowRight:[0,1]}[l.key];if(!r||!this.#s||!(c||l.key===" "))
return;l.preventDefault();let d=(h,f)=>Math.min(f-1,Math.max(0,h)),{rows:m,cols:p}=this.#s;c?s=[d(s[0]+c[0],m),d(s[1]+c[1],p)]:a(s,!o(s)),this.#t.look={cursor:s}}),
l=>{r=l,this.#e.classList.toggle("drawn-on",l),this.#e.tabIndex=l?0:-1,this.#e.setAttribute("role",l?"application":"img"),this.#t.look={cursor:null}}}show(e){this.#s&&
(this.#s={...this.#s,obstacles:e},this.#u())}};var te=["stay","north","east","south","west","northeast","southeast","southwest","northwest"];var Za="champion",Xa=0,as=64,is=100;var Zc=(t,e)=>Object.keys(t).every(r=>t[r]===e[r]);function Qa(t,e){return Object.keys(e).find(r=>Zc(e[r],t))??null}function ei(t,e,r){let n=new Set(t);return Array.
from({length:e},(s,o)=>Array.from({length:r},(a,i)=>n.has(o*r+i)?"#":".").join(""))}var ti={"specialist-specialist":"Specialists: both teams meet only the newest opponent","generalist-specialist":"Pursuers meet all earlier evaders, evaders only\
 the newest pursuers","generalist-generalist":"Generalists: both teams meet all earlier opponents","hall-of-fame":"Halls of fame: both teams learn at once, and \
meet earlier champions"};function Gt({schedule:t}){if(t.kind==="hall-of-fame")return t.kind;let e={latest:"specialist","round-robin":"generalist",uniform:"unifo\
rm"};return`${e[t.pursuers_meet]}-${e[t.evaders_meet]}`}var Dr=t=>ti[Gt(t)]??Gt(t);function ri(t){let e=Object.values(t.races.es).find(a=>Gt(a)==="generalist-generalist"),{n_pursuers:r,n_evaders:n,fov:s,max_steps:o}=e.world;return{schedule:Gt(
e),beside:null,learner:"es",ratings:!1,seed:e.seed,way:!1,population:0,pursuers:r,evaders:n,view:s,steps:o,walls:[]}}var Xc=t=>Object.values(t.races.es)[0].world;
function ni(t,e,r=e.schedule){let n=t.races[e.learner][r],s=Xc(t),o={...s,n_pursuers:e.pursuers,n_evaders:e.evaders,fov:e.view,max_steps:e.steps,obstacles:e.walls.
length?ei(e.walls,s.rows,s.cols):s.obstacles};return{...n,world:o,train_steps:e.steps,seed:e.seed,policy:e.ratings?{...t.ratings,mask:e.way?"right-of-way":"obst\
acles"}:{...n.policy,mask:e.way?"right-of-way":"none"},learner:{...n.learner,population:e.population||n.learner.population}}}var Qc=40,zr=class{element;#e;#t=u("div",{class:"episodes",role:"group","aria-label":"Episodes of this cell"});#r=u("p",{class:"check small numbers","aria-live":"\
polite"});constructor(e){this.#e=e,this.element=u("div",{class:"strip-of-episodes"},this.#t,this.#r)}show(e,r){let{pursuer:n,evader:s,episode:o,seed:a}=this.#e.
selected,i=Re(e,n,s);this.#t.replaceChildren(...(i?.rates??[]).slice(0,Qc).map((p,h)=>this.#n(p,h)));let l=a===null?i?.rates[o]:void 0,c=r.statistics.capture_rate,
d=l!==void 0&&Math.abs(c-l)<1e-6&&r.length===i?.lengths[o],m=i?"Not an episode of the evaluation":"The evaluation played no episodes of this pair.";this.#r.dataset.
equal=String(d),this.#r.textContent=d?"As in the evaluation":l===void 0?m:`Episode ${o+1} differs from the evaluation.`,this.#r.title=`Played here: capture rate\
 ${F(c,3)} in ${r.length} steps.${i?` The cell says ${F(i.rate,3)}.`:""}`}#n(e,r){let{selected:n}=this.#e,s=u("span",{class:"bar"});return s.style.height=`${Math.
round(100*e)}%`,u("button",{type:"button",class:"episode",title:`Episode ${r+1}: capture rate ${F(e)}`,"aria-label":`Episode ${r+1}, capture rate ${F(e)}`,"aria\
-pressed":String(r===n.episode&&n.seed===null),onclick:()=>this.#e.select({episode:r,seed:null})},s,u("span",{class:"count"},r+1))}};var si=0,oi=1,eu=2,tu=176;function ii(t,e,r,n){let s=devicePixelRatio||1,o=Er(t);t.width=t.height=tu*s;let a=t.getContext("2d");if(!a)return;let{fov:i}=e,l=t.width/
i;a.fillStyle=o.paper,a.fillRect(0,0,t.width,t.height);for(let d=0;r&&d<i*i;d++){let[m,p]=[(d%i+.5)*l,(Math.floor(d/i)+.5)*l],h=g=>!!r[g*i*i+d];h(eu)&&(a.fillStyle=
o.obstacle,a.fillRect(m-l/2,p-l/2,l,l));let f=h(si)&&h(oi)?l*.18:0;h(si)&&ai(a,ze,m+f,p+f,l*.74,o.evader),h(oi)&&ai(a,Ar,m-f,p-f,l*.86,o.pursuer)}a.strokeStyle=
n<e.n_pursuers?o.pursuer:o.evader,a.lineWidth=2*s;let c=Math.floor(i/2)*l;a.strokeRect(c,c,l,l)}function ai(t,e,r,n,s,o){e(t,r,n,s),t.fillStyle=o,t.fill()}var ru=["stay","↑","→","↓","←","↗","↘","↙","↖"];function li(t,{inputs:e,ratings:r,refused:n},s,o){let a=t.kind==="rating"&&!t.hidden.length?t.genome:
null,i=f=>a?.[f]??1,l=f=>t.kind==="rating"?i(f)!==0:new RegExp(`\\b${t.inputs[f]}\\b`).test(o),c=[...t.inputs.keys()].filter(l).sort((f,g)=>Math.abs(i(g))-Math.
abs(i(f))),d=f=>`${f===s?"taken":""} ${n[f]?"refused":""}`,m=(f,g)=>u("tr",{class:g.every(y=>y===g[0])?"same":""},f,...Array.from(g,(y,x)=>u("td",{class:d(x)},et(
y)))),p=f=>{let g=t.inputs[f];return u("th",{scope:"row",title:`${a?`weight ${et(i(f))} x `:""}${_e[g]}`},g.replaceAll("_"," "))},h=u("table",{class:"why number\
s"},u("thead",{},u("tr",{},u("th",{},a?"term":"input"),...Array.from(r,(f,g)=>u("th",{scope:"col",class:d(g),title:te[g],"aria-label":te[g]},ru[g]))),m(u("th",{
scope:"row"},a?"sum":"rating"),r)),u("tbody",{},...c.map(f=>m(p(f),e[f].map(g=>i(f)*g)))));return[...o?[u("p",{class:"expression"},u("code",{},o))]:[],u("div",{
class:"wide-table",tabindex:0,role:"group","aria-label":"How the moves are rated"},h)]}var ci="What it remembers: a number for each unit, from -1 to 1",Hr=class{element;#e;#t=u("canvas",{class:"seen",role:"img"});#r=u("h3");#n=u("p",{class:"small \
muted"});#o=u("div",{class:"answers"});#s=u("div",{title:ci});#i=null;#h=null;#m=null;#a=null;#d=null;#u=null;#l=0;constructor(e){this.#e=e,this.element=u("div",
{class:"inspector","data-open":"false"},u("p",{class:"hint small muted"},"Click an agent, or press A: what it sees, and why it takes its move."),u("div",{class:"\
inspected"},this.#t,u("div",{class:"answer"},this.#r,this.#n,this.#s),this.#o))}get agent(){return this.#u}show(e,r,n,s){this.#i?.free(),this.#i=e.world(n.config),
this.#m!==r&&(this.#h=null,this.#u!==null&&this.choose(null)),[this.#m,this.#a,this.#d]=[r,n,s]}set solution(e){this.#h=e,this.at(this.#l)}choose(e){this.#u=e,this.
element.dataset.open=String(e!==null),this.#e(e),this.at(this.#l)}next(e){let r=this.#a;if(!r)return;let n=this.#u??(e>0?-1:0);for(let s=0;s<r.n_agents;s++)if(n=
(n+e+r.n_agents)%r.n_agents,r.alive[this.#l*r.n_agents+n])return this.choose(n)}at(e){this.#l=e;let[r,n,s,o,a]=[this.#a,this.#i,this.#m,this.#d,this.#u];if(!r||
!n||!s||!o||a===null)return;let i=a<r.config.n_pursuers?"pursuer":"evader";this.#s.replaceChildren(),this.#r.replaceChildren(u("span",{class:i},Y(a,r.config.n_pursuers)));
let l={pursuers:ne(s,"pursuer",o.pursuer),evaders:ne(s,"evader",o.evader)};r.seek(n,e,l);let c=r.actions.subarray(e*r.n_agents,(e+1)*r.n_agents);for(;c.length&&
!n.over&&(a<n.actors[0]||a>=n.actors[1]);)n.playTurn(c);let d=!!(r.alive[e*r.n_agents+a]&&n.read("alive")[a]);ii(this.#t,r.config,d?n.view(a):null,a),this.#t.ariaLabel=
`Field of view of ${Y(a,r.config.n_pursuers)}: evaders, pursuers and obstacles around it`;let m=c[a]??null;if(!d)return this.#p([],"It is gone.");let p=l[`${i}s`],
h=typeof p!="string"&&p.kind==="cells"?n.answer(p,a):null,f=h?.probabilities??null;h?.memory.length&&this.#s.replaceChildren(u("p",{class:"small muted"},"It rem\
embers:"),ou(h.memory));let g=typeof p!="string"&&p.kind!=="cells"?li(p,n.rate(p,a),m,co(s,i,o[i])):[],y=this.#h?.game(n)??null,x=typeof p=="string"?`The script\
 "${p}" plays for it${m===null?"":`; it goes ${te[m]}`}.`:p.kind!=="cells"?"It takes the best move that its mask allows; of equal ones any.":p.sampled?"Its acti\
on is drawn from these probabilities.":"It takes the most probable action.",v=[["network",f],["perfect",y?.marginal(a)??null]],w=S=>u("p",{class:"small muted"},
S);this.#p([...y?[w(`Value ${y.value.toFixed(2)} under perfect play.`)]:[],...nu(v,m),...g],m===null?"The episode is over.":x)}#p(e,r){this.#o.replaceChildren(...e),
this.#n.textContent=r}};function nu(t,e){let r=t.filter(([,o])=>o);if(!r.length)return[];let n=u("div",{class:"action muted"},u("span"),...r.map(([o])=>u("span",
{class:"head"},o))),s=Array.from(r[0][1],(o,a)=>u("div",{class:a===e?"action taken":"action"},u("span",{},te[a]),...r.flatMap(([,i])=>su(i[a]))));return r.length>
1||r[0][0]!==t[0][0]?[n,...s]:s}function su(t){let e=u("span",{class:"filled"});return e.style.width=`${100*t}%`,[u("span",{class:"track"},e),u("span",{class:"n\
umbers"},t.toFixed(2))]}function ou(t){let e=Array.from(t,r=>{let n=u("span",{title:r.toFixed(2)});return n.style.transform=`scaleY(${r})`,n});return u("div",{class:"\
units",role:"img","aria-label":ci},...e)}function ui(t){let e=JSON.stringify(t,(r,n)=>r==="genome"?Array.from(n):n);return u("script",{type:"application/json",id:"champions"},e.replaceAll("<","\\u003c")).
outerHTML}var jt="_",au="n",Uh=2n**64n-1n;var ls={fov:11,maxSteps:500,rewards:"paper"},iu=["rules","others","rewards","size","diagonal","fov","limit","seed","ended","walls","pursuers","evaders","played",
"next"];function pi(t,e){let r=i=>i.map(l=>cu(l,e)).join(""),n=i=>`${Math.floor(i/t.cols)}.${i%t.cols}`,s=lu(t.rewards,e),o=[t.seed,t.episode,t.steps].join("."),a={rules:mi(
t.rules,e),others:t.others?mi(t.others,e):"",rewards:s===ls.rewards?"":s,size:`${t.rows}x${t.cols}`,diagonal:t.diagonal?"1":"",fov:t.fov===ls.fov?"":String(t.fov),
limit:t.maxSteps===ls.maxSteps?"":String(t.maxSteps),seed:o==="0.0.0"?"":o,ended:t.ended?"1":"",walls:t.walls.map(n).join(jt),pursuers:t.pursuers.map(di).join(jt),
evaders:t.evaders.map(di).join(jt),played:t.played.map(r).join(jt),next:t.next.every(i=>i===Xa)?"":r(t.next)};return iu.filter(i=>a[i]).map(i=>`${i}=${a[i]}`).join(
"&")}function di({cell:t,gone:e,captured:r,everCaptured:n}){let s=r?"c":n?"e":"";return`${t[0]}.${t[1]}${s}${e?"x":""}`}function mi(t,e){let r=e.fields.map(({name:n})=>String(
t[n]).toLowerCase());return Qa(t,e.variants)??r.join(".")}function lu(t,e){let r=JSON.stringify(t);return Object.keys(e.rewards).find(s=>JSON.stringify(e.rewards[s])===
r)??Object.values(t).map(s=>String(s)).join(jt)}function cu(t,e){if(typeof t=="number")return String(t);if(t===Za)return au;let r=e.scripts.findIndex(({name:n})=>n===
t);return String.fromCharCode(97+r)}var uu="/* the engine */";function hi(t,e){return u("button",{type:"button",class:"to-playground",title:"Open this step in the playground (G): the same agents a\
nd actions under any rules",onclick:()=>du(t(),e)},"What if?")}function du(t,e){let r=t!==null&&t.match.n_agents<=is&&Math.max(t.match.config.rows,t.match.config.
cols)<=as,n=r?pi(mu(t.match,t.step),e):"",s=new TextDecoder().decode($n("playground")).replace(uu,()=>Ae("script-engine")).replace("</noscript>",o=>r?o+ui(t.champions):
o);window.open(`${URL.createObjectURL(new Blob([s],{type:"text/html"}))}#${n}`)}function mu(t,e){let{config:r,n_agents:n}=t,s=Math.max(0,e-1),o=i=>{let l=s*n+i,
c=s*r.n_evaders+i-r.n_pursuers,d=m=>i>=r.n_pursuers&&!!m[c];return{cell:[t.last_positions[2*l],t.last_positions[2*l+1]],gone:!t.alive[l],captured:d(t.captured),
everCaptured:d(t.ever_captured)}},a=Array.from({length:n},(i,l)=>o(l));return{rules:r.rules,others:null,rewards:r.rewards,rows:r.rows,cols:r.cols,diagonal:r.diagonal,
fov:r.fov,maxSteps:r.max_steps,seed:t.seed,episode:BigInt(t.episode),steps:s,ended:s===t.length,walls:Array.from(t.map.keys()).filter(i=>t.map[i]),pursuers:a.slice(
0,r.n_pursuers),evaders:a.slice(r.n_pursuers),played:[],next:Array.from(t.actions.subarray(s*n,(s+1)*n))}}var cs=.005,gi=.05,pu=["pursuer","evader"],hu=4,mt=new Map;function Br(t,e,r="capture-rate"){let n=JSON.stringify([{...e,rewards:null},r]),s=mt.get(n)??(tr(e)?Promise.
resolve(null):fu(t,e,r));return mt.delete(n),mt.set(n,s),mt.size>hu&&mt.delete([...mt.keys()][0]),s}var yi=({n_evaders:t})=>t===1?"capture-time":"capture-rate",
fi=()=>new Promise(t=>setTimeout(t));async function fu(t,e,r){await fi();let n=t.solution(e,r);for(;n.goBack();)await fi();return n}function Gr(t,e,r){let{payoff:n}=t;
return r.flatMap((s,o)=>{let a=[0,0];for(let l=e.n_turns;l>0&&!e.over;l--)t.game(e)?.lost(s).forEach((c,d)=>a[d]+=c),e.playTurn(s);let i=n==="capture-rate"?cs:gi;
return pu.map((l,c)=>({step:o+1,team:l,lost:a[c],payoff:n})).filter(l=>l.lost>=i)})}var jr=t=>t.map(e=>({step:e.step,kind:e.team,size:e.lost/Math.max(1,...t.map(
({lost:r})=>r)),text:Vt(e)})),vi=({lost:t,payoff:e})=>e==="capture-rate"?`${t.toFixed(2)} of the capture rate`:`${t.toFixed(1)} steps`,Vt=t=>`The ${t.team}s los\
e ${vi(t)} against a perfect opponent`;function bi(t){let e=t.reduce((r,n)=>n.lost>r.lost?n:r);return`Your team's worst moves, in step ${e.step}, lost ${vi(e)} \
against a perfect opponent.`}function wi({config:t,payoff:e},{value:r},n){if(e==="capture-rate")return`value ${r.toFixed(2)}`;let[s,o]=[1-r,Math.min(t.max_steps-
n,fn)];return s>o-gi?`free for ${o} steps`:`captured after ${s.toFixed(1)} steps`}function xi(t,e){return(t.marginal(e)??[]).map((n,s)=>({share:n,action:s})).filter(
({share:n})=>n>=cs).sort((n,s)=>s.share-n.share).map(({share:n,action:s})=>n>1-cs?te[s]:`${te[s]} ${n.toFixed(2)}`).join(", ")}function Vr(t,e,r){if(r===0)return[{kind:"start",text:gu(t),agents:[]}];let[n,s]=[e.moments[r-1],e.moments[r]],o=d=>Y(d,t.config.n_pursuers),a=Nt(e,n,s),i=t.conflicts(
r),l=new Set(i.flatMap(d=>d.doomed)),c=a.map(d=>({kind:"capture",text:`${o(d)} is captured`,agents:[d]}));for(let d of xr(n,s))!a.includes(d)&&!l.has(d)&&c.push(
{kind:"end",text:`${o(d)} disappears`,agents:[d]});return c.push(...i.map(({kind:d,text:m,agents:p})=>({kind:d,text:m,agents:p}))),r===t.length&&c.unshift({kind:"\
end",text:yu(t),agents:[]}),c}function gu({config:t}){return`${t.n_pursuers} pursuers and ${t.n_evaders} evaders on ${t.rows} x ${t.cols} cells, at most ${t.max_steps}\
 steps`}function yu(t){let e=Math.round(t.statistics.capture_rate*t.config.n_evaders);return`The episode ends after ${t.length} steps with ${e} of ${t.config.n_evaders}\
 evaders captured`}var vu=60,pt=class{element;player=new pe(0,{speed:Tr,still:ie()});inspector;match=null;recording=null;actions;#e;#t;#r;#n;#o=u("h2",{class:"match-title"});#s=u(
"p",{class:"tally numbers"});#i=u("ol",{class:"words",tabindex:0,"aria-live":"off","aria-label":"What happened in this step"});#h=u("p",{class:"problem",role:"a\
lert"});#m=u("div",{class:"shown","aria-live":"polite"});#a=null;#d=null;#u=0;#l=!1;#p=0;#c=[];constructor(e,r,n){[this.#t,this.#r]=[e,r];let s=u("canvas",{"ari\
a-label":"The match",onclick:({clientX:o,clientY:a})=>this.inspector.choose(this.#e.agentAt(o,a))});this.#e=new Oe(s,{numbers:!1}),this.#n=new zr(r),this.inspector=
new Hr(o=>this.#E(o)),this.actions=u("div",{class:"beside"},u("button",{type:"button",class:"to-play",title:"Move the chosen agent, or an evader, yourself from \
this step on (T)",onclick:()=>this.element.dispatchEvent(new Event("takeover"))},"Take over"),n&&hi(()=>this.shown,n)),this.element=u("section",{class:"card mat\
ch-card","aria-label":"Match",id:"match"},u("div",{class:"match"},u("header",{class:"match-head"},this.#o,this.#s),this.#h,this.#m,u("div",{class:"stage"},s),u(
"div",{class:"aside"},this.#i,Ur(),this.actions,this.inspector.element),$e(this.player),this.#n.element)),this.player.addEventListener("frame",()=>this.recording&&
this.#e.show(this.recording,this.player.time)),this.player.addEventListener("step",()=>this.#A()),r.on("match",()=>this.#y()),this.#S(),this.#x(0,0)}get#f(){return this.#t[this.#r.
selected.run]}reveal(){(this.#f.game?this.#m:this.#e.canvas).scrollIntoView({block:"nearest"})}get shown(){return this.match&&this.#d&&{match:this.match,step:this.
player.step,champions:this.#d}}start(e){this.#a=e,this.#b()}playSoon(){this.#l=!0,this.#u||this.#g()}goTo(e){this.#p=e,!this.#u&&this.match&&this.#b()}#g(){!this.#l||
!this.match||(this.#l=!1,this.player.jump(0),ie()||this.player.play())}#y(){this.#S(),clearTimeout(this.#u),this.#u=setTimeout(()=>this.#b(),vu)}#b(){clearTimeout(
this.#u),this.#u=0,this.player.pause(),this.#S();let{selected:e}=this.#r,{game:r}=this.#f;if(this.#m.replaceChildren(...r?io(this.#f,r,e,this.#r):[]),r){this.match=
this.recording=null,this.#l=!1,this.#v(e);return}let n=Ie.map(a=>ir(this.#f,a,e[a])).find(Boolean)??"";if(this.#h.textContent=n,n||!this.#a)return;this.match=lr(
this.#a,this.#f,e);let[s,o]=this.names(e);this.#d={pursuer:{name:s,policy:ne(this.#f,"pursuer",e.pursuer)},evader:{name:o,policy:ne(this.#f,"evader",e.evader)}},
this.recording=Wr(this.match),this.#n.show(this.#f,this.match),this.inspector.show(this.#a,this.#f,this.match,e),this.player.length=this.match.length,this.player.
marks=wr(this.recording),this.#c=this.player.ticks=[],this.player.jump(this.#p),this.#p=0,this.#A(),this.#w(this.#a,this.match),this.#v(e),this.#g()}#v({run:e,pursuer:r,
evader:n,episode:s,seed:o}){this.element.dataset.played=`${e} ${r} ${n} ${s} ${o??""}`}async#w(e,r){let n=await Br(e,r.config);if(this.match!==r||!n)return;let s=e.
world(r.config);r.seek(s,0),this.#c=Gr(n,s,bu(r)),s.free(),this.player.ticks=jr(this.#c),this.inspector.solution=n,this.#A()}names({run:e,pursuer:r,evader:n}){let s=this.#t[e],
{teams:o}=s;return[o.pursuer.script??ee(s,"pursuer",r),o.evader.script??ee(s,"evader",n)]}#S(){let{episode:e,seed:r}=this.#r.selected,{game:n,payoff:s}=this.#f;
this.element.classList.toggle("of-own-game",!!n),this.element.classList.toggle("of-ratings",Ie.some(l=>lo(this.#f,l)));let[o,a]=this.names(this.#r.selected),i=r===
null?e<s.episodes?`episode ${e+1} of ${s.episodes}`:`episode ${e+1}, not part of the cell`:`seed ${r}`;this.#o.replaceChildren(u("span",{class:"pursuer"},de(o)),
" against ",u("span",{class:"evader"},a),n?"":u("span",{class:"muted small"},i))}#A(){let e=this.match;if(!e||!this.recording)return;let r=this.player.step,n=this.
recording.moments[r];this.#x(Array.from(n.everCaptured).filter(Boolean).length,r),this.#i.replaceChildren(...this.#c.filter(s=>s.step===r).map(s=>u("li",{class:`\
loss-${s.team}`},Vt(s))),...Vr(e,this.recording,r).map(s=>u("li",{class:s.kind,"data-agents":s.agents.join(" ")},s.text))),this.inspector.at(r),this.#M()}#x(e,r){
let{world:n}=this.#f;n&&this.#s.replaceChildren(u("strong",{},e),` of ${n.n_evaders} captured`,u("span",{class:"muted"},` · step ${r}`))}#E(e){this.#e.look={selected:e,
viewers:e===null?[]:[e]},this.#M()}#M(){let e=this.inspector.agent;for(let r of this.#i.children){let n=r.dataset.agents?.split(" ")??[];r.classList.toggle("abo\
ut",e!==null&&n.includes(String(e)))}}},bu=({actions:t,length:e,n_agents:r})=>Array.from({length:e},(n,s)=>t.subarray(s*r,(s+1)*r));var wu={ArrowUp:[1,0],ArrowDown:[-1,0],ArrowRight:[0,1],ArrowLeft:[0,-1]},xu=5;function Ai(t,e,r,n="pursuer"){t.tabIndex=0,t.setAttribute("role","application"),
t.addEventListener("keydown",s=>{let o=wu[s.key];if(!o)return;let[a,i]=n==="pursuer"?o:[o[1],o[0]],[l,c]=r(),d=s.shiftKey?xu:1,{pursuer:m,evader:p}=e.selected;e.
select({pursuer:Si(m+d*a,l),evader:Si(p+d*i,c)}),s.preventDefault(),s.stopPropagation()})}var Si=(t,e)=>Math.min(e-1,Math.max(0,t));var Su=24,qr=7,Ei=t=>t<Su&&matchMedia("(pointer: coarse)").matches;function Ti(t,e,r,n){let[s,o]=t.payoff.shape,[a,i]=[Mi(e,s),Mi(r,o)],[l,c]=[Math.min(qr,s),Math.
min(qr,o)],d=[];for(let g=a+l-1;g>=a;g--){d.push(u("span",{class:"pursuer"},g));for(let y=i;y<i+c;y++)d.push(Au(t,g,y,n))}let m=Array.from({length:c},(g,y)=>u("\
span",{class:"evader"},i+y)),p=u("button",{type:"button","aria-label":"Close: all cells",onclick:()=>n(null)},"✕"),f=u("div",{class:"loupe numbers",role:"grou\
p","aria-label":"Cells around the tap",onclick:g=>g.stopPropagation()},...d,p,...m);return f.style.gridTemplateColumns=`2.4rem repeat(${c}, minmax(0, 1fr))`,f}function Au(t,e,r,n){
let s=u("button",{type:"button",onclick:()=>n({pursuer:e,evader:r})});return $r(s,Re(t,e,r)?.rate,`${ee(t,"pursuer",e)} against ${ee(t,"evader",r)}`),s}var Mi=(t,e)=>Math.
max(0,Math.min(e-qr,t-Math.floor(qr/2)));var se={left:52,bottom:46,top:76,right:84},ve=10,Mu=160,qt=se.right-ve-14,Ve=se.top-ve-14,ht=class{element;#e;#t;#r=u("canvas",{"aria-hidden":"true"});#n=b("svg",
{"aria-hidden":"true"});#o=b("g");#s;#i=u("h2");#h=u("strong",{class:"rate numbers"});#m=u("span",{class:"small muted"});#a=u("p",{class:"of-both-teams small mu\
ted numbers"});#d;#u=null;constructor(e,r){[this.#t,this.#e]=[e,r],this.#s=u("div",{class:"matrix",id:"matrix","aria-label":"Payoff matrix. Arrow keys choose a \
match, Enter plays it.",onpointermove:s=>this.#w(s),onpointerleave:()=>r.point({}),onclick:s=>this.#S(s),onkeydown:({key:s})=>s==="Enter"&&this.#x()},this.#r,this.#n);
let n=u("header",{class:"readout","aria-live":"polite"},u("div",{},this.#i,this.#a),u("div",{class:"of-cell"},this.#h,this.#m));this.#d=Me(...me(this.#l).ends),
this.element=u("section",{class:"card matrix-card","aria-label":"Payoff matrix"},n,this.#s,this.#d),this.#y(),new ResizeObserver(()=>this.#p()).observe(this.#s),
this.#s.addEventListener("mousedown",s=>{s.preventDefault(),document.activeElement instanceof HTMLElement&&document.activeElement.blur()}),Ai(this.#s,r,()=>this.#l.
payoff.shape),r.on("run",()=>{let s=Me(...me(this.#l).ends);this.#d.replaceWith(s),this.#d=s,this.#p()}),r.on("match hover",()=>this.#g())}get#l(){return this.#t[this.#e.
selected.run]}#p(){let[e,r]=this.#l.payoff.shape,{clientWidth:n,clientHeight:s}=this.#s;if(n<50)return;let a=Math.max(Mu,Math.min(n-se.left-se.right,s-se.top-se.
bottom))/Math.max(e,r),i=Math.max(se.left,(n-r*a-se.right+se.left)/2),l=se.top+Math.max(0,(s-se.top-se.bottom-e*a)/2),c={width:n,height:s,left:i,top:l,cell:a,rows:e,
columns:r};this.#u=c,lt(this.#r,this.#l.payoff,{left:i,top:l,width:r*a,height:e*a});for(let[d,m,p]of[["left",i,n],["top",l,s],["width",r*a,n],["height",e*a,s]])
this.#r.style.setProperty(d,`${100*m/p}%`);this.#s.style.setProperty("--shape",`${n} / ${s}`),this.#n.setAttribute("viewBox",`0 0 ${n} ${s}`),this.#n.replaceChildren(
Eu(c,me(this.#l).generation),...Tu(c),...this.#f(c),this.#o),this.#g()}#c(e){let r=this.#l.findings?.generalization;if(!r)return[];let{selected:n,hover:s}=this.#e,
[o,a]=[s.pursuer??n.pursuer,s.evader??n.evader],[i,l]=ki(e,r.pursuers.mean[o]??0,o),[c,d]=Ci(e,r.evaders.mean[a]??0,a);return[b("circle",{class:"dot of-pursuers",
cx:i,cy:l,r:5}),b("circle",{class:"dot of-evaders",cx:c,cy:d,r:5})]}#f(e){let r=this.#l.findings?.generalization;if(!r)return[];let{left:n,top:s,cell:o,rows:a,columns:i}=e,
{curves:l}=me(this.#l),[c,d]=[n+i*o+ve,s-ve],m={class:"side"};return[b("rect",{...m,x:c,y:s,width:qt,height:a*o}),b("rect",{...m,x:n,y:d-Ve,width:i*o,height:Ve}),
...Ri(r.pursuers,(p,h)=>ki(e,p,h),"of-pursuers"),...Ri(r.evaders,(p,h)=>Ci(e,p,h),"of-evaders"),b("text",{class:"tick",x:c,y:s+a*o+16,"text-anchor":"start"},"0"),
b("text",{class:"tick",x:c+qt,y:s+a*o+16,"text-anchor":"end"},"1"),b("text",{class:"tick",x:n-6,y:d-4,"text-anchor":"end"},"0"),b("text",{class:"tick",x:n-6,y:d-
Ve+8,"text-anchor":"end"},"1"),b("text",{class:"label of-pursuers",x:c+qt,y:s+a*o+34,"text-anchor":"end"},l.pursuer),b("text",{class:"label of-evaders",x:n+i*o+
ve,y:d-Ve+10,"text-anchor":"start"},l.evader)]}#g(){let e=this.#u;if(!e)return;let{selected:r,hover:n}=this.#e,{left:s,top:o,cell:a,rows:i,columns:l}=e,c=f=>o+(i-
1-f)*a,d=[],m=(f,g)=>b("rect",{class:g,x:s,y:c(f),width:l*a+ve+qt,height:a}),p=(f,g)=>b("rect",{class:g,x:s+f*a,y:o-ve-Ve,width:a,height:ve+Ve+i*a});d.push(m(r.
pursuer,"strip pursuer"),p(r.evader,"strip evader")),n.pursuer!==null&&n.pursuer<i&&d.push(m(n.pursuer,"strip hover")),n.evader!==null&&n.evader<l&&d.push(p(n.evader,
"strip hover")),d.push(...this.#c(e));let h={x:s+r.evader*a,y:c(r.pursuer),width:a,height:a};d.push(b("rect",{class:"chosen under",...h}),b("rect",{class:"chose\
n",...h})),this.#o.replaceChildren(...d),this.#y()}#y(){let{selected:e,hover:r}=this.#e,n=r.pursuer??e.pursuer,s=r.evader??e.evader,o=Re(this.#l,n,s);this.#i.replaceChildren(
u("span",{class:"pursuer"},de(ee(this.#l,"pursuer",n)))," against ",u("span",{class:"evader"},ee(this.#l,"evader",s))),this.#h.textContent=o?F(o.rate,3):"-";let a=o&&
o.rates.length>1?`, mean of ${o.rates.length} episodes`:"";this.#m.textContent=o?me(this.#l).score+a:"no episodes were played",this.#a.textContent=this.#b(n,s)}#b(e,r){
let n=this.#l.findings?.generalization;if(!n)return"";let s=(a,i)=>ao(a.mean[i]??null,a.low?.[i]??null,a.high?.[i]??null),{means:o}=me(this.#l);return`Against a\
ll: ${o.pursuer} ${s(n.pursuers,e)}, ${o.evader} ${s(n.evaders,r)}`}#v(e){let r=this.#u;if(!r)return null;let n=this.#s.getBoundingClientRect(),s=Math.floor((e.
clientX-n.left-r.left)/r.cell),o=r.rows-1-Math.floor((e.clientY-n.top-r.top)/r.cell),[a,i]=[o>=0&&o<r.rows,s>=0&&s<r.columns];return a||i?{g:a?o:-1,h:i?s:-1,inside:a&&
i}:null}#w(e){let r=this.#v(e);this.#e.point(r?{pursuer:r.g<0?null:r.g,evader:r.h<0?null:r.h}:{})}#S(e){let r=this.#v(e);if(r){if(r.inside&&Ei(this.#u.cell))return this.#A(
r.g,r.h);this.#e.select({...r.g<0?{}:{pursuer:r.g},...r.h<0?{}:{evader:r.h}}),r.inside&&this.#x()}}#A(e,r){let n=Ti(this.#l,e,r,s=>{n.remove(),s&&(this.#e.select(
s),this.#x())});this.#s.append(n)}#x(){this.#s.dispatchEvent(new CustomEvent("play",{bubbles:!0}))}};function Eu({left:t,top:e,cell:r,rows:n,columns:s},o){let a=b(
"g",{class:"axes"}),i=e+n*r,l=c=>Rt(0,c-1,Math.min(c,c*r/44),!0);for(let c of l(s))a.append(b("text",{class:"tick",x:t+(c+.5)*r,y:i+16,"text-anchor":"middle"},c));
for(let c of l(n))a.append(b("text",{class:"tick",x:t-7,y:i-(c+.5)*r,"text-anchor":"end","dominant-baseline":"middle"},c));return a.append(b("text",{class:"labe\
l of-evaders",x:t+s*r/2,y:i+36,"text-anchor":"middle"},o.evader),b("text",{class:"label of-pursuers",transform:`translate(${t-36} ${e+n*r/2}) rotate(-90)`,"text\
-anchor":"middle"},o.pursuer)),a}function Tu({left:t,top:e,cell:r,rows:n,columns:s}){let o=b("g",{class:"diagonal"}),a=Math.min(n,s);if(a<3)return[];let i=e+n*r;
for(let d of["H","V"]){let m=`M${t} ${i}`;for(let p=1;p<=a;p++){let[h,f]=[`H${t+p*r}`,`V${i-p*r}`];m+=d==="H"?h+f:f+h}o.append(b("path",{d:m,class:"under"}),b("\
path",{d:m}))}let[l,c]=[t+a/2*r-.7*r-4,i-a/2*r-.7*r-4];return[o,b("text",{class:"on-cells",transform:`translate(${l} ${c}) rotate(-45)`,"text-anchor":"middle"},
"same generation")]}var ki=({left:t,top:e,cell:r,rows:n,columns:s},o,a)=>[t+s*r+ve+o*qt,e+(n-a-.5)*r],Ci=({left:t,top:e,cell:r},n,s)=>[t+(s+.5)*r,e-ve-n*Ve];function Ri(t,e,r){
let n=o=>o.map((a,i)=>e(a??0,i).map(l=>l.toFixed(1)).join(" ")),s=[];return t.low&&t.high&&s.push(b("path",{class:`band ${r}`,d:`M${[...n(t.high),...n(t.low).reverse()].
join("L")}Z`})),s.push(b("path",{class:`line ${r}`,d:`M${n(t.mean).join("L")}`})),s}var Oi={pursuer:null,evader:null},ft=class extends EventTarget{#e;#t=Oi;constructor(e){super(),this.#e=e}get selected(){return this.#e}get hover(){return this.#t}select(e){
let r=this.#e,n=["run","pursuer","evader"].some(s=>s in e&&e[s]!==r[s]);this.#e={...r,...n?{episode:0,seed:null}:{},...e},this.#e.run!==r.run&&this.dispatchEvent(
new Event("run")),this.dispatchEvent(new Event("match"))}point(e){let r={...Oi,...e};r.pursuer===this.#t.pursuer&&r.evader===this.#t.evader||(this.#t=r,this.dispatchEvent(
new Event("hover")))}on(e,r){for(let n of e.split(" "))this.addEventListener(n,r)}};var Yr=class{config;start;recording;actions=[];#e;#t;#r=[[]];constructor(e,r,n){[this.config,this.start]=[r,n],this.#e=e.world(r),this.#e.reset(n),this.#t=[os(this.#e)],
this.recording=ss(r,this.#e.map(),this.#t)}get length(){return this.actions.length}get over(){return this.#e.over}get statistics(){return{capture_rate:this.#e.read(
"capture_rate")[0]}}conflicts(e){return this.#r[e]}game(e){return e.game(this.#e)}play(e){this.#e.step(e),this.#n(e)}step(e,r,n){let[s,o]=[this.#e,this.config.n_pursuers],
a=new Uint8Array(s.n_agents);for(let i=s.n_turns;i>0&&!s.over;--i){let[l,c]=s.actors;l<o&&(a=s.decide(e.pursuer,[l,Math.min(c,o)],a)),c>o&&(a=s.decide(e.evader,
[Math.max(l,o),c],a)),typeof n=="number"?a[r]=n:l<=r&&r<c&&(a=s.decide(n,[r,r+1],a)),s.playTurn(a)}this.#n(a)}#n(e){this.actions.push(e),this.#t.push(os(this.#e,
e)),this.#r.push(this.#e.conflicts())}};var be=(t,e)=>Ie[+(e>=t.n_pursuers)];function us(t,e){let r=new Yr(t,e.config,{seed:e.seed,episode:e.episode});for(let n of e.moves)r.over||r.step(e.policies,e.
seat,n);return r}function gt(t,e){let{moments:r,nPursuers:n}=t.recording,s=r.findIndex(({alive:a,captured:i})=>!a[e]||!!i[e-n]),o=s<0?t.length:s;return{lasted:o,
out:s>=0,captured:Array.from(r[o].everCaptured).filter(Boolean).length}}var Kr=(t,e)=>t.over||gt(t,e).out;function $i(t,e,r){let n=us(t,{...e,moves:e.moves.slice(
0,e.from)});for(;!Kr(n,e.seat);)n.step(e.policies,e.seat,r);return gt(n,e.seat)}function Pi(t){let e=t.length-1;return[...new Set([0,Math.round(e/3),e])].map(r=>t[r])}
function _i(t,{seat:e,from:r,moves:n}){let s={...t,seat:e,...r?{from:r}:{},moves:n.join("")};return`${location.href.split("#")[0]}#${Object.entries(s).map(([o,a])=>`${o}\
=${a}`).join("&")}`}function Li(t,e){let[r,n,s]=[t.get("seat")??"",t.get("from")??"0",t.get("moves")??""];return/^\d{1,6}$/.test(r)&&Number(r)<e.n_pursuers+e.n_evaders&&
(e.diagonal?/^[0-8]+$/:/^[0-4]+$/).test(s)&&s.length<=e.max_steps&&/^\d{1,6}$/.test(n)&&Number(n)<=s.length?{seat:Number(r),from:Number(n),moves:[...s].map(Number)}:
null}function ds(t,e,r,n,s,o){e.play({title:r,played:n,ending:(a,i)=>[ku(t,a,i,Pi(s))],again:()=>ds(t,e,r,{...n,moves:n.moves.slice(0,n.from)},s,o),link:a=>o&&_i(o,a)})}
function ku(t,e,r,n){let s=be(r.config,r.seat)==="evader",o=s?r.config.max_steps:r.config.n_evaders,a=u("table",{class:"numbers"},u("caption",{},s?"Steps in you\
r seat: same start, same others":"Captures of your team: same start, same others")),i=c=>{let[d,m]=[u("span",{class:s?"bar evader":"bar pursuer"}),u("td",{},"…")];
return a.append(u("tr",{},u("th",{scope:"row"},c),u("td",{class:"track","aria-hidden":"true"},d),m)),({lasted:p,captured:h})=>{d.style.width=`${100*(s?p:h)/o}%`,
m.textContent=String(s?p:h)}};i("You")(gt(e,r.seat));for(let{name:c,policy:d}of n){let m=i(c);setTimeout(()=>m($i(t,r,d())))}let l=r.from?`You took over at step\
 ${r.from}. `:"";return u("div",{},a,u("p",{class:"small muted"},`${l}One match: luck has its part in it.`))}var Ni=["·","↑","→","↓","←","↗","↘","↙","↖"];var Cu={" ":0,ArrowUp:1,w:1,ArrowRight:2,d:2,ArrowDown:3,s:3,ArrowLeft:4,a:4,e:5,c:6,y:7,z:7,q:8},ms=[8,1,5,4,0,2,7,3,6],Ru=[7,8,9,4,5,6,1,2,3],Ou=24,$u=Math.tan(
Math.PI/8);function Fi(t,e){if(t.ctrlKey||t.metaKey||t.altKey)return;let r=Ru.findIndex(s=>t.code===`Numpad${s}`),n=ms[r]??Cu[t.key.length===1?t.key.toLowerCase():
t.key];return n!==void 0&&n>4&&!e?void 0:n}function Ui(t){let e=ms.map(r=>u("button",{type:"button","aria-label":te[r],onclick:()=>t(r)},Ni[r]));return{element:u(
"div",{class:"play-pad",role:"group","aria-label":"Your move"},...e),show:r=>e.forEach((n,s)=>n.classList.toggle("absent",ms[s]>4&&!r))}}function Ii(t,e,r){let n=$u*
Math.max(Math.abs(t),Math.abs(e)),s=o=>Math.abs(o)<n?0:o;return Lo([0,0],r?[s(t),s(e)]:[t,e],r)}function Wi(t,e,r){let n=null,{canvas:s}=t;s.addEventListener("p\
ointerdown",({button:o,clientX:a,clientY:i})=>n=o===0?[a,i]:null),s.addEventListener("pointercancel",()=>n=null),s.addEventListener("pointerup",({clientX:o,clientY:a})=>{
let[i,l]=[n,e()];if(n=null,!i||!l)return;let[c,d]=[o-i[0],a-i[1]],m=t.cellAt(o,a);Math.hypot(c,d)>=Ou?r(Ii(d,c,l.diagonal)):m&&r(Ii(m[0]-l.cell[0],m[1]-l.cell[1],
l.diagonal))})}function Di(t,e){let r=n=>{let s=e[n]-t[n],o=st.findIndex(a=>a[n]===Math.sign(s)&&a[1-n]===0);return s?`${Math.abs(s)} ${te[o]}`:""};return[r(0),
r(1)].filter(Boolean).join(", ")||"on your cell"}var Bi="NUMPY\0",zi=Bi.length+2,Hi=64;function Gi(t){return no(Object.fromEntries(Object.entries(t).map(([e,r])=>[`${e}.npy`,Pu(r)])))}function Pu({dtype:t,shape:e,
data:r}){let n=typeof r=="string"?Array.from(r,d=>d.codePointAt(0)):null,s=e.map(d=>`${d}, `).join(""),o=`{'descr': '${n?`<U${n.length}`:t}', 'fortran_order': F\
alse, 'shape': (${s}), }`,a=Math.ceil((zi+o.length+1)/Hi)*Hi-zi,i=Bi+String.fromCharCode(a&255,a>>8)+o.padEnd(a-1)+`
`,l=n?Int32Array.from(n):r,c=new Uint8Array(i.length+l.byteLength);return c.set(nr(i,!0)),c.set(new Uint8Array(l.buffer,l.byteOffset,l.byteLength),i.length),c}var _u="matrixworld episode 3";function ji(t,e,r){let{config:n,actions:s,length:o,recording:a}=e,[i,l]=[n.n_pursuers+n.n_evaders,n.n_evaders],c={positions:["<i4",
i,2],last_positions:["<i4",i,2],alive:["|b1",i],captured:["|b1",l],ever_captured:["|b1",l]},d={rewards:["<f4",i],involved:["|b1",i,3],fault:["|b1",i,3]},m={},p=w=>{
for(let S of Object.keys(w))(m[S]??=[]).push(Array.from(h.read(S),Number))},h=t.world(n);h.reset(e.start);let f=[];p(c);for(let w of s)h.step(w),p({...c,...d}),
f.push(...h.conflictTable());h.free();let g={"<i4":Int32Array,"<f4":Float32Array,"|b1":Uint8Array},y={};for(let[w,[S,...A]]of Object.entries({...c,...d})){let k=o+
+(w in c);y[w]={dtype:S,shape:[k,...A],data:g[S].from((m[w]??[]).flat())}}let x=w=>({dtype:"<i8",shape:[],data:Int32Array.of(w,0)}),v=w=>({dtype:"<U",shape:[],data:w});
return Gi({format:v(_u),n_pursuers:x(n.n_pursuers),config:v(JSON.stringify(n)),seat:x(r),...y,actions:{dtype:"|i1",shape:[o,i],data:Int8Array.from(s.flatMap(w=>[
...w]))},map:{dtype:"|b1",shape:[n.rows,n.cols],data:Uint8Array.from(a.obstacles,Number)},conflict_table:{dtype:"<i4",shape:[f.length/11,11],data:Int32Array.from(
f)}})}var Lu=[0,1,2,4,8],Jr=class{element;player=new pe(0,{speed:4,still:ie()});#e;#t;#r=u("canvas",{tabindex:0,"aria-describedby":"play-keys"});#n=u("h2");#o=u("p",{
class:"play-told",role:"status"});#s=Ui(e=>this.act(e));#i=ar(Lu.map(e=>[e,e?`${e} / s`:"step by step"]),()=>this.#k());#h=u("input",{type:"checkbox",onchange:()=>this.#A()});#m=u(
"input",{type:"checkbox",onchange:()=>this.#C()});#a=u("label",{class:"play-choice"},this.#m,"Best move");#d=u("p",{class:"small muted play-keys",id:"play-keys"});#u=u(
"section",{class:"play-ending",tabindex:-1,"aria-labelledby":"play-headline"});#l=$e(this.player);#p=null;#c=null;#f=[];#g=null;#y=null;#b=[];#v=0;#w=0;constructor(e){
this.#e=e,this.#t=new Oe(this.#r,{numbers:!1}),this.#r.setAttribute("role","application"),Wi(this.#t,()=>{let r=this.#g!==null&&this.#c&&$(this.#c.recording.moments.
at(-1),this.#g);return r?{cell:r,diagonal:this.#c.config.diagonal}:null},r=>this.act(r)),this.player.addEventListener("frame",()=>this.#c&&this.#t.show(this.#c.
recording,this.player.time)),this.player.addEventListener("step",()=>this.#C()),this.element=u("div",{class:"play"},u("header",{class:"play-head"},this.#n,this.#o),
u("div",{class:"play-stage"},this.#r),u("div",{class:"play-side"},this.#u,this.#s.element,u("label",{class:"play-choice",title:"Steps a second"},"Pace ",this.#i),
u("label",{class:"play-choice"},this.#h,u("span",{},"Fog",u("span",{class:"at-length"},": see only what it sees"))),this.#a,this.#d),this.#l)}get played(){return this.#p&&
{...this.#p.played,moves:this.#f}}get live(){return this.#c}play(e){this.#S(us(this.#e,e.played),e.played.seat,e.title),[this.#p,this.#f,this.#v]=[e,[...e.played.
moves],0],this.element.dataset.state="playing",this.#r.focus({preventScroll:!0}),Kr(this.#c,e.played.seat)&&this.#O()}watch(e,r,n){this.#p=null,this.#S(e,r,n),this.#$()}stop(){
this.#k(),this.player.pause(),this.#p=null}act(e){let[r,n]=[this.#p,this.#c];if(!r||!n||this.element.dataset.state!=="playing")return;this.#v=e;let s=Number(this.#i.
value);this.#w||(this.#R(),s&&this.element.dataset.state==="playing"&&(this.#w=setInterval(()=>this.#R(),1e3/s)))}key(e){let{target:r,key:n}=e;if(r instanceof HTMLSelectElement||
r instanceof HTMLInputElement&&(r.type==="text"||n===" ")||r instanceof HTMLButtonElement&&(n===" "||n==="Enter")||!this.#c)return!1;if(this.element.dataset.state!==
"playing")return Cr(this.player,e);let o=Fi(e,this.#c.config.diagonal);return o!==void 0&&this.act(o),o!==void 0}#S(e,r,n){this.#k(),this.player.pause(),[this.#c,
this.#g]=[e,r],this.#n.textContent=n,this.#r.ariaLabel=`Board, ${e.config.rows} by ${e.config.cols} cells`,this.#s.show(e.config.diagonal),this.#d.replaceChildren(
u("span",{class:"at-length"},`W A S D or the arrow keys move, Space stays${e.config.diagonal?"; Q E Z C and the numeric keypad move diagonally":""}. `),"On the \
board: swipe, or tap where to go."),this.#x(e),this.#u.replaceChildren(),this.player.length=e.length,this.player.jump(e.length),this.#C()}#A(){this.#t.look={you:this.#g,
fog:this.#h.checked,viewers:this.#g===null?[]:[this.#g],plan:this.#T()}}#x(e){this.#y=null,this.#b=this.player.ticks=[],this.#a.hidden=this.#m.disabled=!!tr(e.config),
Br(this.#e,e.config,yi(e.config)).then(r=>{this.#c===e&&(this.#y=r,this.#E(),this.#C())})}#E(){let[e,r]=[this.#c,this.#y];if(!r||this.element.dataset.state==="p\
laying")return;let n=this.#e.world(e.config);n.reset(e.start),this.#b=Gr(r,n,e.actions),n.free(),this.player.ticks=jr(this.#b)}get#M(){return this.#m.checked&&this.#p&&
this.element.dataset.state==="playing"&&this.#y&&this.#c.game(this.#y)||null}#T(){let[e,r]=[this.#g,this.#g!==null&&this.#M?.marginal(this.#g)];return e!==null&&
r?Object.assign(Array(e).fill(0),{[e]:r.indexOf(Math.max(...r))}):null}#k(){clearInterval(this.#w),this.#w=0,this.#o.ariaLive=Number(this.#i.value)?"off":"polit\
e"}#R(){let[{policies:e,seat:r},n]=[this.#p.played,this.#c];n.step(e,r,this.#v),this.#f.push(this.#v),this.player.length=n.length,this.player.glide=Math.min(.22,
.9/(Number(this.#i.value)||4)),this.player.move(n.length-this.player.step),Kr(n,r)&&this.#O()}#O(){this.#k();let[e,r,n]=[this.#p,this.#c,this.played],s=oo()?e.link(
n):null,o=`${Y(n.seat,r.config.n_pursuers)}-${r.length}-steps.npz`,a=()=>nt(o,ji(this.#e,r,n.seat));this.#u.replaceChildren(u("h3",{id:"play-headline"},Fu(r,n.seat)),
...e.ending(r,n),u("div",{class:"play-buttons"},u("button",{type:"button",class:"primary",onclick:()=>e.again()},"Again"),u("button",{type:"button",onclick:()=>this.#$()},
"Watch it"),u("button",{type:"button",onclick:a},"Save"),s&&u("button",{type:"button",onclick:({currentTarget:l})=>Wu(l,s)},"Link"))),this.element.dataset.state=
"ended",this.#E();let i=this.#b.filter(({team:l})=>l===be(r.config,n.seat));i.length&&this.#u.children[0].after(u("p",{class:"small muted"},bi(i))),this.#u.focus(
{preventScroll:!0}),this.#u.scrollIntoView({block:"nearest"})}#$(){this.element.dataset.state="watched",this.player.length=this.#c.length,this.player.jump(0),ie()||
this.player.play()}#C(){let[e,r,{step:n}]=[this.#c,this.#g,this.player];if(!e||n>e.length)return;let s=Vr(e,e.recording,n).filter(({agents:l})=>r===null||l.includes(
r)),o=this.#p&&n===0,a=o?[Nu(e.config,r),this.#p.about??""]:[`Step ${n} of ${e.config.max_steps}`,...s.map(({text:l})=>l)];!o&&r!==null&&a.push(Iu(e,n,r)),a.push(
...this.#b.filter(l=>l.step===n).map(Vt));let i=n===e.length&&r!==null?this.#M:null;i&&a.push(`Perfect play: ${xi(i,r)||"decided in its turn"}; ${wi(this.#y,i,n)}`),
this.#A(),this.#o.textContent=a.filter(Boolean).map(l=>`${l}.`).join(" ")}};function Nu(t,e){let r=t.rules.capture==="SURROUND";return be(t,e)==="evader"?`Run a\
way: you win if ${r?"the pursuers do not surround you":"no pursuer reaches your cell"} in ${t.max_steps} steps`:`Capture evaders: ${r?"surround them with your t\
eam":"move onto their cells"}`}function Iu({config:t,recording:e},r,n){let s=e.moments[r],a=be(t,n)==="pursuer"?"evader":"pursuer";if(!s.alive[n])return"";let i=$(
s,n),l=m=>{let[p,h]=$(s,m);return Math.max(Math.abs(p-i[0]),Math.abs(h-i[1]))},c=Array.from({length:s.alive.length},(m,p)=>p).filter(m=>be(t,m)===a&&s.alive[m]&&
!s.captured[m-t.n_pursuers]&&2*l(m)<t.fov);if(!c.length)return`No ${a} in view`;let d=c.reduce((m,p)=>l(p)<l(m)?p:m);return`Nearest ${a}: ${Di(i,$(s,d))}`}function Fu(t,e){
let[{lasted:r,out:n,captured:s},{config:o}]=[gt(t,e),t];return be(o,e)==="pursuer"?`Your team captured ${s} of ${Uu(o)} in ${r} steps.`:n?`You lasted ${r} of ${o.
max_steps} steps.`:`You escaped: ${r} steps.`}var Uu=({n_evaders:t})=>`${t} evader${t===1?"":"s"}`;function Wu(t,e){let r=Oo("Link to this match");r.value=e,t.replaceWith(
r),r.select(),navigator.clipboard?.writeText(e).catch(()=>{})}var Du=2n**64n-1n;function Vi(t,e,r){let n=new URLSearchParams(t.replace(/^#/,"")),s=(c,d,m)=>{let p=n.get(c)??"";return/^\d{1,9}$/.test(p)&&Number(p)<d?Number(
p):m},o=s("run",e.length,r.run),[a,i]=e[o].payoff.shape,l=n.get("seed")??"";return{run:o,pursuer:s("pursuers",a,Math.min(r.pursuer,a-1)),evader:s("evaders",i,Math.
min(r.evader,i-1)),episode:s("episode",1/0,r.episode),seed:/^\d{1,20}$/.test(l)&&BigInt(l)<=Du?l:null,step:s("step",1/0,0)}}var Zr=class{dialog=u("dialog",{class:"take-over","aria-label":"Play an agent",onclose:()=>this.view?.stop(),onkeydown:e=>this.view?.key(e)&&e.preventDefault()});view=null;#e;#t;#r;#n;#o=null;constructor(e,r,n,s=!0){
[this.#e,this.#t,this.#r,this.#n]=[e,r,n,s],n.element.addEventListener("takeover",()=>this.open())}start(e,r=""){this.#o=e;let n=Vi(r,this.#e,this.#t.selected),
{world:s}=this.#e[n.run],o=s&&Li(new URLSearchParams(r.replace(/^#/,"")),s);o&&this.play(n,o)}open(){let e=this.#r.shown;if(!e)return;let{match:r,step:n}=e;this.#r.
player.pause();let s=this.#r.inspector.agent,o=n<r.length?n:0,a=(m,p)=>!!r.alive[p*r.n_agents+m],i=Array.from({length:r.n_agents},(m,p)=>(p+r.config.n_pursuers)%
r.n_agents),l=s??i.find(m=>a(m,o)),c=a(l,o)?o:0,d=Array.from({length:c},(m,p)=>r.actions[p*r.n_agents+l]);this.play(this.#t.selected,{seat:l,from:c,moves:d})}play(e,r){
let[n,s]=[this.#o,this.#e[e.run]],{world:o}=s;if(!n||!o||Ie.some(x=>ir(s,x,e[x])))return;let{run:a,pursuer:i,evader:l,episode:c,seed:d}=e,m=be(o,r.seat),p=s.teams[m].
kept.map(x=>({name:s.teams[m].script??`generation ${x}`,text:"",policy:()=>ne(s,m,x)}));this.view||(this.view=new Jr(n),this.dialog.append(u("button",{type:"but\
ton",class:"leave",onclick:()=>this.dialog.close()},"Close"),this.view.element)),this.dialog.open||this.dialog.showModal();let h=`You are ${Y(r.seat,o.n_pursuers)}\
: ${this.#r.names(e).join(" against ")}`,f={pursuer:ne(s,"pursuer",i),evader:ne(s,"evader",l)},g={config:o,seed:BigInt(d??s.seeds[i][l]),episode:c,policies:f,...r},
y={run:a,pursuers:i,evaders:l,episode:c,...d===null?{}:{seed:d}};ds(n,this.view,h,g,p,this.#n?y:null)}};var ps=t=>Array.from({length:t},()=>Array(t)),Xr=class{learning=C;settings=[];training={capture_rate:[],generation:[],learner:[],epochs:1,window:1,matches:0};limits="";name;schedule;seed;seeds;world;payoff;teams;findings=null;genomes={
pursuer:[],evader:[]};#e;#t;#r;constructor(e,r,n,s){[this.#r,this.#e,this.#t,this.name,this.schedule]=[e,r,s,n,n],[this.world,this.seed]=[e.world,String(e.seed)];
let o=e.schedule.generations+1;this.seeds=Array.from({length:o},(a,i)=>Array.from({length:o},(l,c)=>String(cr(e.seed,i,c)))),this.payoff=this.#n(),this.teams=this.#o()}get newest(){
return this.genomes.pursuer.length-1}#n(){let e=this.#r.schedule.generations+1;return{first:[0,0],shape:[e,e],episodes:this.#r.evaluation_episodes,capture_rate:ps(
e),capture_rates:ps(e),lengths:ps(e)}}#o(){let e=r=>{let n=`${this.#t} ${r}`;uo(n,mr(this.genomes[r]));let{genome:s,...o}=_t(hr(this.#r,this.#e,r),this.genomes[r][0]??
new Float32Array(0));return{script:null,policy:{...o,genome_size:s.length},kept:[...this.genomes[r].keys()],genomes:n}};return{pursuer:e("pursuer"),evader:e("ev\
ader")}}policy(e,r){return this.playing(e,this.genomes[e][r])}playing(e,r){return _t(hr(this.#r,this.#e,e),r)}add(e){for(let r of C)this.genomes[r].push(e[r]);this.
teams=this.#o()}change(e,r){this.#r=e,this.world=e.world;for(let n of C)this.genomes[n]=[...r[n]];[this.payoff,this.teams,this.findings]=[this.#n(),this.#o(),null]}addCell({
pursuer:e,evader:r,capture_rates:n,lengths:s}){this.payoff.capture_rate[e][r]=U(n),this.payoff.capture_rates[e][r]=[...n],this.payoff.lengths[e][r]=[...s],this.
findings={generalization:this.#s()}}#s(){let e=this.payoff.capture_rate,r=o=>({mean:o,low:null,high:null}),n=o=>{let a=o.filter(i=>i!==void 0);return a.length?U(
a):null},s=[...this.genomes.pursuer.keys()];return{pursuers:r(s.map(o=>n(e[o]))),evaders:r(s.map(o=>n(e.map(a=>a[o]===void 0?void 0:1-a[o]))))}}};var zu=2,Hu=1.5,Bu=20,Qr=class{element=u("section",{class:"card weights-card","aria-label":"Weights of named inputs",hidden:!0});#e;#t;#r=u("div",{class:"evolve\
d"});#n=u("p",{class:"numbers",role:"status"});#o=u("button",{type:"button",onclick:()=>this.#a()},"As evolved");#s=null;#i=null;constructor(e,r){[this.#e,this.#t]=
[e,r],this.element.append(u("h3",{},"What they have learned"),u("p",{class:"small muted"},"An agent takes the move with the largest sum of weight x input. Drag \
a weight, and see at once what becomes of the team."),u("div",{class:"doings"},this.#o,this.#n),this.#r)}genome(e){return this.#i?.[e]??this.#s.genomes[e].at(-1)}show(e){
e!==this.#s&&(this.#i=null),this.#s=e;let{policy:r}=e.teams.pursuer;this.element.hidden=r?.kind!=="rating"||e.newest<0,!(r?.kind!=="rating"||this.element.hidden)&&
(this.#i||this.#r.replaceChildren(...C.map(n=>this.#h(n,r.inputs))),this.#d())}#h(e,r){let n=this.genome(e),s=Math.max(zu,Hu*Math.max(...n.map(Math.abs)));return u(
"div",{class:"weights"},u("h4",{class:e},`${e}s`),...r.flatMap((o,a)=>{let i=u("span",{class:"numbers"},et(n[a])),l=u("input",{type:"range",class:e,min:-s,max:s,
step:"any",value:n[a],title:_e[o],"aria-label":`${e}s: ${o}`});return l.addEventListener("input",()=>{i.textContent=et(Number(l.value)),this.#m(e,a,Number(l.value))}),
[u("span",{title:_e[o]},o.replaceAll("_"," ")),l,i]}))}#m(e,r,n){this.#i??={pursuer:this.genome("pursuer").slice(),evader:this.genome("evader").slice()},this.#i[e][r]=
n,this.#d(),this.#t()}#a(){this.#i=null,this.show(this.#s),this.#t()}#d(){this.#o.disabled=!this.#i;let e=this.#s.newest,r=s=>`${Math.round(100*this.#u(s))} %`,
n=r({pursuer:this.#s.genomes.pursuer[e],evader:this.#s.genomes.evader[e]});this.#n.textContent=this.#i?`Yours: ${r(this.#i)} are caught; as evolved: ${n}`:`${n}\
 are caught`}#u({pursuer:e,evader:r}){let n=this.#s,s=new Int32Array(1),o={pursuer:s,evader:s,seed:BigUint64Array.of(BigInt(n.seed))};return U(this.#e.rollouts(
n.world,n.playing("pursuer",e),n.playing("evader",r),o,Bu).capture_rate)}};var Yt=t=>`${Math.round(100*t)} %`,Gu=100,ju=0,en=class extends EventTarget{element;newest;beginning;settings;state="waiting";done=0;seconds=0;#e;#t;#r;#n=u("h2",
{class:"lane-title"});#o=u("p",{class:"facts numbers"});#s=u("div",{class:"lane-room",hidden:!0});#i=u("section",{class:"card measures",hidden:!0});#h=u("div");#m;#a;#d={
pursuer:[],evader:[]};#u=new Map;#l;#p;#c=()=>{};#f=0;#g=!0;#y=0;#b=null;constructor(e,r,n,s){super(),[this.#e,this.#t,this.#r,this.settings]=[e,r,n,s],this.newest=
new je(()=>this.#E(this.#a.newest)),this.beginning=new je(()=>this.#E(0)),this.beginning.element.classList.add("beginning"),this.#m=new Qr(r,()=>this.#M(!0));let o=u(
"div",{class:"boards"},this.newest.element,this.beginning.element);this.element=u("section",{class:"lane"},this.#n,this.#o,o,this.#s,this.#m.element,this.#i,this.#h),
n.onmessage=({data:a})=>this.#w(a),this.reset(s)}reset(e){this.#v({type:"stop"}),[this.settings,this.state,this.done]=[e,"waiting",0],this.#x();let{archive:r}=new rt(
this.#t,e,this.#e.masks);this.#a.add({pursuer:r.pursuer[0],evader:r.evader[0]}),this.#s.hidden=this.#i.hidden=!0,this.#M(!0),this.#T()}start(){this.#x(),[this.state,
this.done]=["evolving",0],this.#s.hidden=!1,this.#i.hidden=!0,this.#v({type:"start",settings:this.settings,masks:this.#e.masks}),this.#T()}stop(){this.#v({type:"\
stop"}),this.state==="evolving"&&(this.state="stopped"),this.#T()}change(e){if(this.state==="waiting")return this.reset(e);this.settings=e,this.#v({type:"change",
settings:e}),this.#T()}takeOver(){let e=this.#a.newest;this.#p.play({run:0,pursuer:e,evader:e,episode:0,seed:null},{seat:this.#a.world.n_pursuers,from:0,moves:[]})}saved(){
return new Promise(e=>{this.#b=e,this.#v({type:"save"})})}get newestGeneration(){return this.#a.newest}close(){this.#r.terminate(),this.newest.runs=this.beginning.
runs=!1}#v(e){this.#r.postMessage(e)}#w(e){if(e.type==="generation"){if(this.state!=="evolving")return;this.#a.add(e.genomes),this.#M(e.number===0)}else if(e.type===
"cell"){let{pursuer:r,evader:n}=e.cell;this.#a.addCell(e.cell),this.#g&&r===n&&r===this.#a.newest&&this.#l.select({pursuer:r,evader:n}),this.#u.set(`${r} ${n}`,
e.cell)}else if(e.type==="scores")for(let r of C)this.#d[r][e.number]=e.scores[r];else e.type==="anew"?(this.#a.change(e.settings,e.genomes),this.#A(),this.#M(!0)):
e.type==="epoch"?this.done=e.done/e.of:e.type==="end"?(this.state==="evolving"&&([this.state,this.seconds,this.done]=["ended",e.seconds,1]),this.#k()):e.type===
"saved"?this.#b?.(e.race):(this.#o.textContent=`The race failed: ${e.message}`,this.state="stopped");this.#y||(this.#y=setTimeout(()=>requestAnimationFrame(()=>this.#S()),
Gu))}#S(){this.#y=0,this.#l.dispatchEvent(new Event("run")),this.#c(),this.#T()}#A(){this.#u=new Map,this.#d={pursuer:[],evader:[]},this.#i.hidden=!0}#x(){let e=`\
race ${ju++}`,r=Dr(this.settings);this.#a=new Xr(this.settings,this.#e.masks,r,e),this.#A(),this.#g=!0,this.#l=new ft({run:0,pursuer:0,evader:0,episode:0,seed:null});
let[n,s]=[new ht([this.#a],this.#l),new pt([this.#a],this.#l,null)];n.element.ariaLabel=`Payoff matrix. ${r}`,this.#p=new Zr([this.#a],this.#l,s,!1),this.#p.start(
this.#t);let o=u("dialog",{class:"of-cell-match","aria-label":"Match",onclose:()=>s.player.pause()},u("button",{type:"button",class:"leave",onclick:()=>o.close()},
"Close"),s.element),a=!1;n.element.addEventListener("play",()=>{let{pursuer:l,evader:c}=this.#l.selected;this.#g=!1,this.#a.payoff.capture_rate[l][c]!==void 0&&
(o.showModal(),a||s.start(this.#t),a=!0,s.playSoon())});let i=ge(`Scores against scripts, by generation: ${pr.pursuer.join(", ")} and ${pr.evader.join(", ")}`,(l,c)=>{
let d=this.settings.schedule.generations,m=he(l,c,{low:0,high:d,label:"generation",whole:!0},{low:0,high:1,label:"score"});for(let p of C){let h=Array.from(this.#d[p],
f=>f??null);fe(m,[...h.keys()],h,`of-${p}s`)}return m},()=>{},l=>{let c=Math.min(this.#a.newest,Math.max(0,Math.round(l)));this.#l.select({pursuer:c,evader:c})});
this.#c=i.redraw,this.#s.replaceChildren(n.element,u("section",{class:"card scores"},u("h3",{},"Against opponents that never change"),u("p",{class:"small muted"},
"Captures of random walkers and of clumsy fleers; escapes from random walkers and from clumsy chasers."),it(["pursuers","of-pursuers"],["evaders","of-evaders"]),
i.element)),this.#h.replaceChildren(o,this.#p.dialog)}#E(e){let r=this.#a.newest;if(r<0||e<0)return null;let{world:n,payoff:s,seeds:o}=this.#a,a=this.#f++%s.episodes;
this.newest.title.textContent=r?"Newest against newest":"Generation 0: nobody has learned anything yet",this.beginning.title.textContent="Pursuers of generation\
 0, newest evaders";for(let c of[this.newest,this.beginning])c.generation=r;for(let c of[this.newest,this.beginning])c.label=`A match. ${c.title.textContent}`;let[
i,l]=C.map(c=>this.#a.playing(c,c==="pursuer"&&e<r?this.#a.genomes.pursuer[e]:this.#m.genome(c)));return this.#t.match(n,i,l,BigInt(o[e][r]),a)}#M(e){this.#m.show(
this.#a),this.newest.renew(e),(this.#a.newest>0||this.state!=="waiting")&&this.beginning.renew(e)}#T(){this.element.dataset.state=this.state,this.#n.textContent=
Dr(this.settings);let e=this.#u.get(`${this.#a.newest} ${this.#a.newest}`)??this.#u.get(`${this.#a.newest-1} ${this.#a.newest-1}`),r=e?[`Generation ${this.#a.newest}\
 of ${this.settings.schedule.generations}`,`the newest pursuers catch ${Yt(U(e.capture_rates))} of the newest evaders`,`${Vu(e).toFixed(0)} collisions in 1000 m\
oves`]:[];this.#o.replaceChildren(...r.map(n=>u("span",{},n))),this.dispatchEvent(new Event("state"))}#k(){this.#i.ariaLabel=`What came out. ${Dr(this.settings)}`;
let e=this.#a.payoff.capture_rate.slice(0,this.#a.newest+1).map(n=>n.slice(0,this.#a.newest+1));if(e.length<2||e.some(n=>Array.from(n).includes(void 0)))return;
let r=[["Score against scripts: generation 0",n=>Yt(this.#d[n][0]??0)],["Score against scripts: newest generation",n=>Yt(this.#d[n].at(-1)??0)],["Newest generat\
ion against all generations of the other team",n=>Yt(bo(e,n))],["Below its own best so far, in the later half (forgetting)",n=>Yt(wo(e,n))]];this.#i.replaceChildren(
u("h3",{},"What came out"),u("table",{class:"numbers"},u("thead",{},u("tr",{},u("td"),...C.map(n=>u("th",{scope:"col",class:n},`${n}s`)))),u("tbody",{},...r.map(
([n,s])=>u("tr",{},u("th",{scope:"row"},n),...C.map(o=>u("td",{},s(o))))))),u("p",{class:"small muted"},"These are measures without a verdict: one race proves l\
ittle. Save it, and ",u("code",{},"matrixworld judge")," weighs luck and says what happened.")),this.#i.hidden=!1}};function Vu({means:{faults:t,agent_steps:e}}){
let r=n=>n.reduce((s,o)=>s+o,0);return 1e3*r(t)/Math.max(1,r(e))}function qu(t,e,...r){return u("section",{class:"card panel","aria-label":t},u("header",{},u("h2",{},t),u("p",{class:"small muted"},e)),...r)}var Yu={present:"●",
absent:"○","cannot tell":"?"};function qi(t){let{findings:e}=t;if(!e?.table.length)return null;let[,...r]=e.table,n=r.map(([o,a,i,l],c)=>{let d=Ku(e.reasons[c]??
"");return u("li",{class:`finding ${a.replace(" ","-")}`},u("span",{class:"sign","aria-hidden":"true"},Yu[a]??""),u("div",{},u("p",{},u("strong",{},o),` ${a}`,u(
"span",{class:"muted"},` · ${l}`)),d?u("p",{class:"small"},`${d}.`):null,u("p",{class:"small muted numbers"},i)))}),s=qu("What happened","Each condition is pre\
sent, absent, or its 95 % interval cannot tell. The intervals are about this run.",u("p",{class:"headline"},e.sentence),u("p",{},e.headline),...e.numbers.map(o=>u(
"p",{class:"numbers"},`${de(o)}.`)),u("ul",{class:"findings"},...n),t.limits?u("p",{class:"small"},t.limits):null);return s.classList.add("diagnosis"),{element:s}}
function Ku(t){let[,e=""]=t.split(/, because (.*)/s);return de(e.replace(/\.$/,""))}var Ju=84;function Yi(t,e){let r=t.map((o,a)=>Zu(o,a,e)),n=u("nav",{class:"races","aria-label":"Runs"},...r.map(o=>o.button)),s=()=>r.forEach((o,a)=>o.update(a===
e.selected.run));return e.on("match hover",s),s(),n.hidden=t.length<2,n}function Zu(t,e,r){let[n,s]=t.payoff.shape,o=!t.name.startsWith(t.schedule),a=Ju/Math.max(
n,s),i=u("canvas",{"aria-hidden":"true"});lt(i,t.payoff,{left:0,top:0,width:s*a,height:n*a});let l=u("span",{class:"place"}),c=u("button",{type:"button",class:"\
race",title:`${t.name} (key ${e+1})`,onclick:()=>Qu(t,e,r)},u("span",{class:"small-matrix"},i,l),u("span",{class:"race-text"},u("strong",{},o?t.name:t.schedule),
u("span",{class:"small"},t.findings?t.findings.headline:`${t.learning.map(m=>me(t).teams[m]).join(" and ")} against ${Xu(t)}`),u("span",{class:"small muted"},`${o?
`${t.schedule}, `:""}seed ${t.seed}`)));return{button:c,update:m=>{c.setAttribute("aria-current",String(m));let p=r.hover.pursuer??r.selected.pursuer,h=r.hover.
evader??r.selected.evader;l.hidden=p>=n||h>=s,l.style.left=`${(h+.5)*a}px`,l.style.top=`${(n-p-.5)*a}px`}}}var Xu=t=>t.teams.pursuer.script??t.teams.evader.script??
"another run";function Qu(t,e,r){let[n,s]=t.payoff.shape,{pursuer:o,evader:a}=r.selected;r.select({run:e,pursuer:Math.min(o,n-1),evader:Math.min(a,s-1)})}var Ki=1;function Ji({runs:t},e){let r=t[Ki],{shape:[n,s],episodes:o}=r.payoff,a=null,i=0,l=()=>a&&lr(a,r,{run:Ki,pursuer:n-1,evader:s-1,episode:i++%o,seed:null}),
c=new je(l);return c.title.textContent=`Generation ${n-1} of both teams`,c.label=`A match. ${c.title.textContent}`,c.generation=n-1,e.then(d=>{a=d,c.renew(),Xi(
c)}),u("div",{class:"widget"},c.element,$e(c.player),Ur())}function Zi({evolve:t},e,{grows:r=!1}){let n=u("button",{type:"button",class:"evolve",disabled:!0},"E\
volve"),s=u("progress",{max:1,value:0,"aria-label":"Progress of the race"}),o=u("div",{class:"lanes","data-count":1});return e.then(a=>{let i=-1,l=()=>ni(t,{...ri(
t),seed:Math.max(0,i)}),c=new en(t,a,Co("lesson"),l()),d=()=>{n.textContent=c.state==="waiting"?"Evolve":c.state==="evolving"?"Stop":"Again, with other luck",s.
value=c.done};n.addEventListener("click",()=>{if(c.state==="evolving")return c.stop();i++,c.settings=l(),c.start()}),c.addEventListener("state",d),o.append(c.element),
[c.newest,c.beginning].forEach(Xi),n.disabled=!1}),u("div",{class:`widget evolving ${r?"grows":"boards"}`},u("div",{class:"buttons"},n,s),o)}function Xi(t){let e=t.
runs;new IntersectionObserver(([r])=>{r.isIntersecting?e&&(t.runs=!0):(e=t.runs&&(t.player.playing||t.player.step===t.player.length),t.runs=!1)}).observe(t.element)}
function Qi({runs:t,playground:e},r){let n=t[0].payoff.shape.map(c=>c-1),s=new ft({run:0,pursuer:n[0],evader:n[1],episode:0,seed:null}),[o,a]=[new pt(t,s,e),new ht(
t,s)];o.actions.remove(),a.element.addEventListener("play",()=>{o.playSoon(),o.reveal()}),r.then(c=>o.start(c));let[{seed:i},l]=[t[0],t[0].world];return u("div",
{class:"widget wide"},Yi(t,s),u("div",{class:"stages"},a.element,o.element),u("p",{class:"small muted"},"Three races of ",u("code",{},`matrixworld evolve --seed\
 ${i}`),`: ${l.n_pursuers} pursuers and ${l.n_evaders} evaders on ${l.rows} x ${l.cols} cells.`))}function el({runs:t}){let[e,r]=[t[0],t[0].findings],[n,...s]=r.
table,o=s.findIndex(([i,,,l])=>i==="arms race"&&l==="last half"),a={headline:e.name,numbers:[],table:[n,s[o]],reasons:[r.reasons[o]]};return u("div",{class:"wid\
get text"},qi({...e,findings:{...r,...a}}).element)}var hs=()=>{let[t]=crypto.getRandomValues(new Uint32Array(1));return{pupil:t.toString(16).padStart(8,"0"),choices:[],solved:{},exit:"",done:!1}},tn=class extends EventTarget{#e;#t;#r;keeps=!0;constructor(e){
super(),[this.#t,this.#r]=[e,`matrixworld lesson ${e}`],this.#e=this.#n(),this.#o({})}choice=e=>this.#e.choices.find(({prediction:r})=>r===e)?.choice;choose(e,r){
let n=new Date().toISOString().replace(/\.\d+Z$/,"+00:00");this.#o({choices:[...this.#e.choices,{prediction:e,choice:r,time:n}]}),this.dispatchEvent(new CustomEvent(
"choice",{detail:e}))}solved=e=>this.#e.solved[e];solve=(e,r)=>this.#o({solved:{...this.#e.solved,[e]:r}});get exit(){return this.#e}set exit(e){this.#o(e)}get count(){
return this.#e.choices.length}get file(){let{choices:e,pupil:r}=this.#e;return e.map(n=>`${JSON.stringify({...n,edition:this.#t,pupil:r})}
`).join("")}forget=()=>this.#o(hs());#n(){try{return{...hs(),...JSON.parse(localStorage.getItem(this.#r)??"{}")}}catch{return hs()}}#o(e){this.#e={...this.#e,...e};
try{localStorage.setItem(this.#r,JSON.stringify(this.#e))}catch{this.keeps=!1}}};function tl(t,e){let r=[],n=[];for(let i of t)try{n.push({...i,...ed(i.text,e)})}catch(l){r.push({file:i.name,reason:l.message})}let s=new Map([...e.predictions].
map(([i,{options:l}])=>[i,new Map(Object.keys(l).map(c=>[c,0]))])),o=new Map,a=new Map;for(let{name:i,text:l,pupil:c,choices:d}of n.sort((m,p)=>p.choices.size-m.
choices.size)){let m=[...d].filter(([h])=>!o.has(`${c} ${h}`)),p=a.get(l)??(m.length?void 0:o.get(`${c} ${[...d.keys()][0]}`));if(p!==void 0){r.push({file:i,reason:a.
has(l)?`double: the same content as ${p}`:`double: the pupil of ${p}`});continue}a.set(l,i);for(let[h,f]of m)o.set(`${c} ${h}`,i),s.get(h).set(f,s.get(h).get(f)+
1)}return{counts:s,pupils:new Set([...o.keys()].map(i=>i.split(" ")[0])).size,left:r}}function ed(t,{edition:e,predictions:r}){if(t===null)throw new Error("expe\
cted at most 65536 bytes");let n=new Map,s="",o=t.split(/\r?\n/).filter(a=>a.trim());if(!o.length)throw new Error("expected predictions that the lesson has save\
d, got an empty file");return o.forEach((a,i)=>{let l=td(a),{prediction:c,choice:d}=l;if(typeof c!="string"||typeof d!="string")throw new Error(`line ${i+1}: ex\
pected a prediction and its choice`);if(l.edition!==e)throw new Error(`line ${i+1}: expected edition ${e} of the course, got ${fs(l.edition)}`);let m=r.get(c)?.
options;if(!m)throw new Error(`line ${i+1}: expected a prediction of the lesson, got ${fs(c)}`);if(!Object.hasOwn(m,d))throw new Error(`line ${i+1}: expected on\
e of ${Object.keys(m).join(", ")} for ${c}, got ${fs(d)}`);if(s||=String(l.pupil??""),!/^[0-9a-f]{8}$/.test(s)||l.pupil!==s)throw new Error(`line ${i+1}: expect\
ed lines of one pupil`);n.has(c)||n.set(c,d)}),{pupil:s,choices:n}}function td(t){try{let e=JSON.parse(t);return typeof e=="object"&&e!==null?e:{}}catch{return{}}}
var fs=t=>t===void 0?"none":JSON.stringify(t).slice(0,40);function rl(t){let e={edition:t.edition,predictions:yr(t)},r=u("p",{role:"status"}),n=u("ul",{class:"left"}),s=u("div",{class:"questions"}),o=new Set,a=[],i=()=>{
let p=tl(a,e);r.textContent=a.length?`${a.length} ${a.length===1?"file":"files"}, ${p.pupils} ${p.pupils===1?"pupil":"pupils"}.${p.left.length?" Not counted:":""}`:
"No files yet.",n.replaceChildren(...p.left.map(({file:h,reason:f})=>u("li",{},u("strong",{},h),` ${f}`))),s.replaceChildren(...[...e.predictions.values()].map(
h=>nd(h,p,o,i)))},l=async p=>{let h=[...p].map(async f=>({name:f.name,text:f.size>65536?null:await f.text()}));a=[...a,...await Promise.all(h)],i()},c=u("input",
{type:"file",multiple:!0,accept:".jsonl",id:"vote-files",onchange:()=>{l(c.files).then(()=>c.value="")}}),d=u("button",{type:"button",onclick:()=>{a=[],o.clear(),
i()}},"Remove all files"),m=u("section",{class:"card drop","aria-label":"Files"},u("p",{},u("label",{for:"vote-files"},"Drop the files that your pupils have sav\
ed anywhere on this page, or choose them: ")),c,u("div",{class:"buttons"},r,d),n,u("p",{class:"small muted"},"A pupil saves predictions.jsonl at the end of the \
lesson. Names of files do not matter. Each pupil counts once: a second file of a pupil is named as double. Nothing leaves this computer."));document.addEventListener(
"dragover",p=>p.preventDefault()),document.addEventListener("drop",p=>{p.preventDefault(),l(p.dataTransfer?.files??[])}),document.getElementById("page").replaceWith(
fr("How the class voted",u("span",{},`${t.title} `,u("a",{href:"#"},"Back to the lesson"))),u("main",{},m,s),u("footer",{class:"small muted"},`matrixworld ${t.version}\
, edition ${t.edition} of the course`)),i()}function nd(t,e,r,n){let{predict:s,options:o,outcome:a}=t,i=e.counts.get(s),l=[...i.values()].reduce((h,f)=>h+f,0),c=r.
has(s),d=t.again?e.counts.get(t.again):void 0,m=Object.entries(o).map(([h,f])=>{let g=u("span",{class:"filled"});g.style.width=`${100*i.get(h)/Math.max(1,l)}%`;
let y=c&&h===a;return u("li",{class:y?"vote right":"vote"},u("span",{},`${h}. ${f}`,y&&u("strong",{}," ✓ the outcome")),u("span",{class:"bar","aria-hidden":"t\
rue"},g),u("span",{class:"numbers"},`${i.get(h)} of ${l}`,d&&u("span",{class:"muted"},`, at first ${d.get(h)}`)))}),p=u("button",{type:"button",id:`outcome-${s}`,
onclick:()=>{r.add(s),n()}},"Show the outcome");return u("section",{class:"card question",id:`votes-${s}`},u("h2",{},t.question),u("ul",{class:"of-votes"},...m),
t.later?u("p",{class:"muted"},t.later):c?u("div",{class:"reply"},...Bt(t.explanation??"")):u("div",{},p))}var nl="#votes",sd=["explorer"],od=t=>"needs"in t?t.needs:void 0,rn=t=>"widget"in t;function ad(t){let e=[];for(let r of t){let n=e.at(-1);!n||"text"in r||rn(r)&&
n.some(rn)?e.push([r]):n.push(r)}return e}function id(t){let e=t.find(rn);return e&&t.length>1&&!sd.includes(e.widget)&&!e.grows?"block beside":"block"}var gs=class{#e;#t;#r=()=>{};#n=new Promise(
e=>this.#r=e);#o={chase:()=>Ji(this.#e,this.#n),evolving:e=>Zi(this.#e,this.#n,e),"right-of-way":Ca,flat:ka,hands:Ia,"hands-matrix":Fa,games:Ha,numbers:Ba,matrices:()=>Ea(
this.#e),explorer:()=>Qi(this.#e,this.#n),judgement:()=>el(this.#e),"same-diagonal":Ta,exit:e=>Ka(e,this.#t)};constructor(e){[this.#e,this.#t]=[e,new tn(e.edition)];
let r=this.#t,n=yr(e).size,s=u("span",{class:"small muted",role:"status"}),o=()=>{s.textContent=`${r.count} of ${n} predictions made. `+(r.keeps?"They stay in t\
his browser.":"This browser keeps nothing: save before you close the page.")};r.addEventListener("choice",o);let a=()=>{confirm("Delete all predictions and answ\
ers in this browser, for another student? Save them first.")&&(r.forget(),location.reload())};document.getElementById("page").replaceWith(fr(e.title,e.lead),u("\
nav",{class:"sections","aria-label":"Sections"},...e.sections.map((i,l)=>u("a",{href:`#${i.id}`},`${l+1}. ${i.title}`))),u("main",{},...e.sections.map((i,l)=>this.#i(
i,l))),u("footer",{class:"card"},u("div",{class:"buttons"},u("button",{type:"button",class:"primary save",onclick:()=>nt("predictions.jsonl",r.file)},"Save my p\
redictions"),u("button",{type:"button",onclick:()=>print()},"Print"),u("button",{type:"button",onclick:a},"Start anew"),s),u("p",{class:"small muted"},`The page\
 sends nothing anywhere. matrixworld ${e.version}, edition ${e.edition} of the course. Teachers: `,u("a",{href:nl},"count the votes of a class"),"."))),o()}async load(){
this.#r(await rr())}#s(e){return"text"in e?u("div",{class:"text"},...Bt(e.text)):rn(e)?this.#o[e.widget](e):"exercise"in e?Ya(e,this.#t):qa(e,this.#t)}#i(e,r){let{
sections:n}=this.#e,s=u("p",{class:"waiting muted",role:"status"}),o=u("section",{class:"card",id:e.id,"aria-labelledby":`title-${e.id}`},u("h2",{id:`title-${e.
id}`},`${r+1}. ${e.title}`,u("span",{class:"muted small"},`${e.minutes} minutes`)),s),a=ad(e.parts),i=a.map(m=>u("div",{class:id(m)})),l=a.flatMap((m,p)=>m.map(
()=>i[p])),c=0,d=()=>{for(s.textContent="";c<e.parts.length;c++){let[m,p]=[e.parts[c-1],e.parts[c]],h=[gr(m)?m.predict:void 0,od(p)].find(f=>f&&this.#t.choice(f)===
void 0);if(h){let f=n.findIndex(({parts:g})=>g.some(y=>gr(y)&&y.predict===h));s.textContent=`This section goes on with your prediction${f===r?"":` in section ${f+
1}`}.`;return}s.before(l[c]),l[c].append(this.#s(p))}s.remove()};return this.#t.addEventListener("choice",d),d(),o}};function ld(){let t=_o(),e=()=>location.hash===
nl,r=e();if(window.addEventListener("hashchange",()=>e()!==r&&location.reload()),r)return void Cn(Promise.resolve(rl(t)));let n=new gs(t);requestAnimationFrame(
()=>setTimeout(()=>Cn(n.load())))}typeof document>"u"?Ro():ld();})();
