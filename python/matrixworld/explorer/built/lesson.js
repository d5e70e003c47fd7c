/* built from web/ by "npm run build"; sources 8d387cd7428f784d90a57adec7c64148ede37bd5cecc189239ab20aa289bfa1a */
"use strict";(()=>{var Ln={SIMULTANEOUS:0,SWARM_TURNS:1,AGENT_TURNS:2},Je={DISAPPEAR:0,REACH:1,BOUNCE:2},Nn={OCCUPATION:0,SURROUND:1},In={FAULT:0,INVOLVED:1};var Fn=["obstacle","teammate","adversary"],wr=["vertex","edge","chain"],Dn=["turn","kind","form","first","second","row","col","at_fault","held","doomed"],xr=["p\
ursuer_{number}","evader_{number}"],Wn={obstacle:"{first} ran into the obstacle or border at {cell}",vertex:"{first} and {second} both headed for {cell}",edge:"\
{first} and {second} meant to swap, {first} to {cell}",chain:"{first} headed for {cell}, where {second} had to stay"},Xe={"both held":"both bounce","both doomed":"\
both disappear",held:"{agent} bounces",doomed:"{agent} disappears",none:"nobody is stopped"},Un="{event}: {outcome}",Sr={random:"any action, all equally likely",
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
id (0 to 1)"},Hn={free:".GS",blocked:"#@OTW"};var Oe=1+Dn.length;function Qe(r,e){return r.replace(/\{(\w+)\}/g,(t,n)=>String(e[n]))}function B(r,e){return r<e?Qe(xr[0],{number:r}):Qe(xr[1],{number:r-e})}function ai(r,e){
let[t,n,s,o,a,i,l,...c]=Array.from(r),d=a<0?[o]:[o,a],[m,h,p]=c.map(b=>d.filter((v,x)=>b>>x&1)),f=d.map(b=>B(b,e)),y=Qe(Wn[a<0?"obstacle":wr[s]],{first:f[0],second:f[f.
length-1],cell:`(${i}, ${l})`}),g=Qe(Un,{event:y,outcome:ii(d.length,h,p,e)});return{kind:Fn[n],form:wr[s],agents:d,cell:[i,l],at_fault:m,held:h,doomed:p,turn:t,
text:g}}function ii(r,e,t,n){if(r===2&&e.length===2)return Xe["both held"];if(r===2&&t.length===2)return Xe["both doomed"];let s=o=>a=>Qe(Xe[o],{agent:B(a,n)});
return[...e.map(s("held")),...t.map(s("doomed"))].join(", ")||Xe.none}function At(r,e){let t=[];for(let n=0;n<r.length;n+=Oe)t.push(ai(r.subarray(n+1,n+Oe),e));
return t}var me=class extends Error{name="EngineError"};function k(r,e,t){let n=typeof t=="string"?`'${t}'`:typeof t=="object"?JSON.stringify(t):String(t);return new me(
`${r}: expected ${e}, got ${n}`)}var ke=class{bytes;constructor(e){this.bytes=e}},Bn=0,Mr=[Uint8Array,Uint8Array,Int32Array,BigInt64Array,BigUint64Array,Float32Array,Float64Array],zn=4,Gn=4,li=new TextEncoder,
ci=new TextDecoder;function ui(r){for(let e=Mr.length-1;e>Bn;--e)if(r instanceof Mr[e])return e;throw new TypeError("array: expected a typed array of the engine\
's numbers, got another")}function Ar(r){return new Uint8Array(r.buffer,r.byteOffset,r.byteLength)}function di(r){return li.encode(`${r}\0`)}var Tr=class{engine;addresses=[];constructor(e){
this.engine=e}copy(e){let t=this.engine._malloc(Math.max(e.length,1));if(t===0)throw new me("memory: expected room for the arguments, got none");return this.addresses.
push(t),this.engine.HEAPU8.set(e,t),t}text(e){return this.copy(di(e))}arrays(e){let t=Object.entries(e),n=t.flatMap(([o,a])=>{let i=a instanceof ke,l=i?a.bytes:
a;return[this.text(o),i?Bn:ui(l),l.length,this.copy(Ar(l))]}),s=this.copy(Ar(Int32Array.from(n)));return this.copy(Ar(Int32Array.of(t.length,s)))}free(){for(let e of this.
addresses)this.engine._free(e)}};function jn(r,e){let t=r.HEAPU8;return ci.decode(t.subarray(e,t.indexOf(0,e)))}function Ce(r){let e=new Int32Array(r.HEAPU8.buffer),
t=r._last_outputs()/zn,n=e[t+1]/zn,s={};for(let o=n;o<n+e[t]*Gn;o+=Gn){let a=Mr[e[o+1]],i=e[o+2]*a.BYTES_PER_ELEMENT,l=e[o+3];s[jn(r,e[o])]=new a(r.HEAPU8.slice(
l,l+i).buffer)}return s}function oe(r,e){let t=new Tr(r);try{let n=e(t);if(n===0)throw new me(jn(r,r._last_error()));return n}finally{t.free()}}var mi=2**31-1,Vn=["none","gru"],hi=2n**64n-1n,pi=34028234663852886e22;function U(r,e){if(typeof e!="number"||!Number.isInteger(e)||Math.abs(e)>mi)throw k(r,"an\
 integer",e);return Int32Array.of(e)}function Mt(r,e){if(typeof e!="boolean")throw k(r,"true or false",e);return new ke(Uint8Array.of(Number(e)))}function he(r,e,t){
let n=typeof e=="string"&&Object.hasOwn(t,e)?t[e]:void 0;if(n===void 0)throw k(r,`one of ${Object.keys(t).join(", ")}`,e);return Int32Array.of(n)}function Er(r,e){
if(typeof e!="number"||!(Math.abs(e)<=pi))throw k(r,"a finite number",e);return e}function et(r,e){let n=typeof e=="bigint"||typeof e=="number"&&Number.isSafeInteger(
e)?BigInt(e):-1n;if(n<0n||n>hi)throw k(r,"an integer from 0 to 2^64 - 1",e);return BigUint64Array.of(n)}function fi(r){return{"rules.interaction":he("interactio\
n",r.interaction,Ln),"rules.obstacle":he("obstacle",r.obstacle,Je),"rules.teammate":he("teammate",r.teammate,Je),"rules.evader":he("evader",r.evader,Je),"rules.\
pursuer":he("pursuer",r.pursuer,Je),"rules.capture":he("capture",r.capture,Nn),"rules.captured_disappear":Mt("captured_disappear",r.captured_disappear)}}function qn(r,e){
let t=typeof e=="number"?[e,e,e]:e;if(!Array.isArray(t)||t.length!==3)throw k(r,"1 or 3 numbers",e);return Float32Array.from(t,n=>Er(r,n))}function gi(r){let e=(t,n)=>Float32Array.
of(Er(t,r[t]),Er(n,r[n]));return{"rewards.capture":e("pursuer_capture","evader_capture"),"rewards.neighbor":e("pursuer_neighbor","evader_neighbor"),"rewards.ste\
p":e("pursuer_step","evader_step"),"rewards.pursuer_collide":qn("pursuer_collide",r.pursuer_collide),"rewards.evader_collide":qn("evader_collide",r.evader_collide),
"rewards.blame":he("blame",r.blame,In),"rewards.capture_repeats":Mt("capture_repeats",r.capture_repeats)}}function Zn(r){if(r===void 0||typeof r=="number")return new Uint8Array(
0);if(r instanceof Uint8Array)return r;let{free:e,blocked:t}=Hn;for(let[n,s]of r.entries()){if(s.length!==r[0]?.length)throw k(`map, row ${n}`,`${r[0]?.length} \
cells as in row 0`,s.length);let o=[...s].find(a=>!e.includes(a)&&!t.includes(a));if(o)throw k(`map, row ${n}`,`'${e}' (free) or '${t}' (obstacle)`,o)}return Uint8Array.
from([...r.join("")],n=>Number(t.includes(n)))}function Jn(r,e){if(!Array.isArray(r))return;let t=[r.length,r[0]?.length??0];if(!(t[0]===e.rows&&t[1]===e.cols))
throw k("obstacle map",`shape (${e.rows}, ${e.cols}), the rows and cols`,t)}function Re(r){Jn(r.obstacles,r);let e=typeof r.obstacles=="number"?r.obstacles:0;return{
...fi(r.rules),...gi(r.rewards),rows:U("rows",r.rows),cols:U("cols",r.cols),n_pursuers:U("n_pursuers",r.n_pursuers),n_evaders:U("n_evaders",r.n_evaders),fov:U("\
fov",r.fov),diagonal:Mt("diagonal",r.diagonal),max_steps:U("max_steps",r.max_steps),density:Float64Array.of(e),map:Zn(r.obstacles)}}function Kn(r,e){return Int32Array.
from((e??[]).flat(),t=>U(r,t)[0])}function Xn(r,e){return Jn(r.obstacles,e),{seed:et("seed",r.seed??0n),episode:et("episode",r.episode??0),pursuers:Kn("pursuers",
r.pursuers),evaders:Kn("evaders",r.evaders),map:Zn(r.obstacles)}}function Tt(r){return{actions:Int32Array.from(r,e=>U("actions",e)[0])}}var Yn=Object.keys(de);function Or(r){
let e=Yn.indexOf(r);if(e<0)throw k("inputs",`names of ${Yn.join(", ")}`,r);return e}function pe(r){if(typeof r=="string"){if(!Object.hasOwn(Sr,r))throw k("polic\
y",`one of ${Object.keys(Sr).join(", ")}`,r);return{script:new TextEncoder().encode(r)}}if(r.kind!=="cells")return{inputs:Int32Array.from(r.inputs,e=>Or(e)),hidden:Int32Array.
from(r.kind==="rating"?r.hidden:[],e=>U("hidden",e)[0]),length:U("length",r.kind==="program"?r.length:0),mask:new TextEncoder().encode(r.mask),genome:r.genome};
if(r.activation!=="relu"&&r.activation!=="tanh")throw k("activation","'relu' or 'tanh'",r.activation);if(!Vn.includes(r.memory))throw k("memory",`one of ${Vn.join(
", ")}`,r.memory);return{hidden:Int32Array.from(r.hidden,e=>U("hidden",e)[0]),activation:new TextEncoder().encode(r.activation),sampled:Mt("sampled",r.sampled),
memory:new TextEncoder().encode(r.memory),genome:r.genome}}var yi=["first_turn","terminated","truncated"];function Qn(r){let e={...r};for(let t of yi)e[t]=new ke(
r[t]);return e}var es="statistics.",Et=class{config;seed;episode;n_agents;statistics;first_conflict;constructor(e,t,n,s){this.config=e,this.seed=t,this.episode=n,this.n_agents=
e.n_pursuers+e.n_evaders,this.statistics=bi(ts(s)),Object.assign(this,s),this.first_conflict=vi(this.conflict_table,this.length)}get length(){return this.actions.
length/this.n_agents}conflicts(e){this.check(e);let t=this.first_conflict[e],n=this.first_conflict[e+1],s=this.conflict_table.subarray(t*Oe,n*Oe);return At(s,this.
config.n_pursuers)}seek(e,t,n){this.check(t),(!(e.seed===this.seed&&e.episode===BigInt(this.episode))||e.turn!==0||e.steps>t)&&e.reset({seed:this.seed,episode:this.
episode});for(let o=e.steps;o<t;++o){let a=this.actions.subarray(o*this.n_agents,(o+1)*this.n_agents);n?e.replay(a,{pursuer:n.pursuers,evader:n.evaders}):e.step(
a)}}check(e){if(!(Number.isInteger(e)&&e>=0&&e<=this.length))throw k("step",`0 to ${this.length}`,e)}};function vi(r,e){let t=new Int32Array(e+2);for(let n=0;n<
r.length;n+=Oe)++t[r[n]+1];for(let n=1;n<t.length;++n)t[n]+=t[n-1];return t}function bi(r){let e=["capture_rate","ever_capture_rate","captured_fraction","length"];
return Object.fromEntries(Object.entries(r).map(([t,n])=>[t,e.includes(t)?Number(n[0]):n]))}var ts=r=>Object.fromEntries(Object.entries(r).flatMap(([e,t])=>e.startsWith(
es)?[[e.slice(es.length),t]]:[]));function rs(r,e,t,n){let s=[Re(t.config),pe(t.pursuers),pe(t.evaders),n];return oe(r,o=>{let[a,i,l,c]=s.map(d=>o.arrays(d));return r[e](
a,i,l,c)}),Ce(r)}function ns(r,e,t,n){let s={seed:et("seed",t),episode:et("episode",n)};return new Et(e.config,t,n,rs(r,"_play_match",e,s))}function ss(r,e,t,n){
if(!Number.isInteger(n)||n<1)throw k("n_episodes","at least 1",n);let s=rs(r,"_play_rollout",e,{...t,n_episodes:Int32Array.of(n)});return ts(s)}var wi=7e6,xi=new FinalizationRegistry(([r,e])=>r._states_free(e));function Si({rules:r,rows:e,cols:t,obstacles:n,diagonal:s,n_pursuers:o,n_evaders:a}){let i=typeof n==
"number"||r.obstacle==="REACH"?0:n.join("").split("#").length-1,l=e*t-i,c=[r.obstacle,r.teammate,r.pursuer].includes("DISAPPEAR"),d=r.capture==="SURROUND"||r.evader===
"REACH",m=r.interaction==="AGENT_TURNS",h=(y,g)=>Array.from({length:g},(b,v)=>m?y:(y+v)/(v+1)).reduce((b,v)=>b*v,1),p=h(l+Number(c),o)*h(l*(1+Number(d))+2,a);return{
SIMULTANEOUS:[o+a],SWARM_TURNS:[o,a],AGENT_TURNS:Array(o+a).fill(1)}[r.interaction].reduce((y,g)=>y+p*(s?9:5)**g,0)}function os(r){return typeof r.obstacles=="n\
umber"&&r.obstacles>0?"obstacles are drawn anew in each episode":Si(r)>wi?"the world is too large to be solved on the page":""}var kr=class{value;teams;matrix;n_actions;constructor(e,t){
let{matrix:n,rows:s,cols:o,value:a,agents:i}=t,[l,c]=e.actors,d=Array.from(i).filter(h=>l<=h&&h<c),m=h=>h<e.config.n_pursuers;this.value=a[0],this.matrix=n,this.
n_actions=e.n_actions,this.teams=[{agents:d.filter(m),play:s},{agents:d.filter(h=>!m(h)),play:o}]}marginal(e){let t=this.teams.find(({agents:o})=>o.includes(e));
if(!t)return null;let n=this.n_actions**(t.agents.length-1-t.agents.indexOf(e)),s=Array(this.n_actions).fill(0);return t.play.forEach((o,a)=>s[Math.floor(a/n)%this.
n_actions]+=o),s}lost(e){let[t,n]=this.teams.map(({agents:l})=>l.reduce((c,d)=>c*this.n_actions+e[d],0)),[s,o]=this.teams.map(({play:l})=>l),a=o.reduce((l,c,d)=>l+
c*this.matrix[t*o.length+d],0),i=s.reduce((l,c,d)=>l+c*this.matrix[d*o.length+n],0);return[Math.max(0,this.value-a),Math.max(0,i-this.value)]}},as=60,tt=class{config;payoff;engine;states;n_turns;values;constructor(e,t,n){
this.engine=e,this.config=t,this.payoff=n,this.states=oe(e,i=>e._states_new(i.arrays(Re(t)))),xi.register(this,[e,this.states]);let s={SIMULTANEOUS:1,SWARM_TURNS:2,
AGENT_TURNS:t.n_pursuers+t.n_evaders};this.n_turns=s[t.rules.interaction];let{payoffs:o}=this.call(()=>e._states_payoffs(this.states)),a=o;this.values=[[n==="ca\
pture-rate"?a:a.fill(0)]]}goBack(){let e=this.values.at(-1)[0],t=[];for(let s=this.n_turns-1;s>=0;s--){let o=t[s+1]??e;t[s]=this.backup(s,{next:o})}this.payoff===
"capture-time"&&(t[0]=t[0].map((s,o)=>o===this.config.n_evaders?0:s-1)),this.values.push(t);let n=this.payoff==="capture-rate"?this.config.max_steps:Math.min(this.
config.max_steps,as);return this.values.length<=n&&t[0].some((s,o)=>s!==e[o])}backup(e,t){return this.call(n=>this.engine._states_backup(this.states,e,n.arrays(
t))).values}game(e){let t=this.config.max_steps-e.steps,{turn:n}=e,s=n+1===this.n_turns,o=t>0?this.values[Math.min(t-Number(s),this.values.length-1)]?.[s?0:n+1]:
void 0;if(!o)return null;let a=this.call(i=>this.engine._states_game(this.states,e.address,i.arrays({next:o})));return a.agents.length?new kr(e,a):null}call(e){
return oe(this.engine,e),Ce(this.engine)}};var is=new FinalizationRegistry(([r,e])=>r._world_free(e)),rt=class{config;n_agents;n_actions;engine;at;freed=!1;constructor(e,t){this.engine=e,this.config=t,this.
n_agents=t.n_pursuers+t.n_evaders,this.n_actions=t.diagonal?9:5,this.at=oe(e,n=>e._world_new(n.arrays(Re(t)))),is.register(this,[e,this.at],this)}free(){this.freed||
(this.freed=!0,is.unregister(this),this.engine._world_free(this.at))}get address(){if(this.freed)throw k("world","one that is in use","one that was freed");return this.
at}reset(e={}){let t=Xn(e,this.config);this.call(n=>this.engine._world_reset(this.address,n.arrays(t)))}step(e){let t=Tt(e);this.call(n=>this.engine._world_step(
this.address,n.arrays(t)))}playTurn(e){let t=Tt(e);this.call(n=>this.engine._world_play_turn(this.address,n.arrays(t)))}decide(e,t,n){let{n_pursuers:s}=this.config,
o={pursuer:[0,s],evader:[s,this.n_agents]},[a,i]=typeof t=="string"?o[t]:t;if(n.length!==this.n_agents)throw k("actions",String(this.n_agents),n.length);let l=[
pe(e),Tt(n)],{actions:c}=this.call(d=>this.engine._world_decide(this.address,d.arrays(l[0]),a,i,d.arrays(l[1])));return Uint8Array.from(c)}replay(e,t){let n=o=>typeof o!=
"string"&&o.kind==="cells"&&o.memory!=="none";if(!n(t.pursuer)&&!n(t.evader))return this.step(e);let{n_pursuers:s}=this.config;for(let o=this.n_turns;o>0;--o){let[
a,i]=this.actors;a<s&&this.decide(t.pursuer,[a,Math.min(i,s)],e),i>s&&this.decide(t.evader,[Math.max(a,s),i],e),this.playTurn(e)}}get n_turns(){return this.turnNumbers()[1]}get turn(){
return this.turnNumbers()[0]}get actors(){let[,,e,t]=this.turnNumbers();return[e,t]}turnNumbers(){return this.call(()=>this.engine._world_turn(this.address)).turn}get steps(){
return this.read("steps")[0]}get seed(){return this.read("seed")[0]}get episode(){return this.read("episode")[0]}get over(){return this.read("terminated")[0]===
1||this.read("truncated")[0]===1}read(e){return this.call(t=>this.engine._world_read(this.address,t.text(e)))[e]}view(e){let t=3*this.config.fov**2;return this.
read("views").slice(e*t,(e+1)*t)}map(){return this.read("state").slice(2*this.config.rows*this.config.cols)}conflicts(){return At(this.conflictTable(),this.config.
n_pursuers)}conflictTable(){return this.call(()=>this.engine._world_conflicts(this.address)).conflict_table}answer(e,t){let n=pe(e),{logits:s,memory:o}=this.call(
l=>this.engine._world_logits(this.address,l.arrays(n),t)),a=s,i=this.decide(e,[t,t+1],new Uint8Array(this.n_agents))[t];return{logits:a,probabilities:Ai(a),action:i,
memory:o}}rate(e,t){let n=pe(e),{ratings:s,refused:o}=this.call(c=>this.engine._world_rate(this.address,c.arrays(n),t)),a=this.read("inputs"),i=a.length/this.n_agents/
this.n_actions,l=c=>Float32Array.from({length:this.n_actions},(d,m)=>a[(t*this.n_actions+m)*i+c]);return{inputs:e.inputs.map(c=>l(Or(c))),ratings:s,refused:o}}snapshot(){
return this.call(()=>this.engine._world_snapshot(this.address))}restore(e){let t=Qn(e);this.call(n=>this.engine._world_restore(this.address,n.arrays(t)))}call(e){
return oe(this.engine,e),Ce(this.engine)}};function Ai(r){let e=Math.max(...r),t=Array.from(r,s=>Math.exp(s-e)),n=t.reduce((s,o)=>s+o,0);return Float32Array.from(
t,s=>s/n)}var Cr=class{compiled;constructor(e){this.compiled=e}world(e){return new rt(this.compiled,e)}solution(e,t="capture-rate"){return new tt(this.compiled,e,t)}match(e,t,n,s,o=0){
return ns(this.compiled,{config:e,pursuers:t,evaders:n},s,o)}rollouts(e,t,n,s,o){return ss(this.compiled,{config:e,pursuers:t,evaders:n},s,o)}},ls;function Ot(r=globalThis.
matrixworldEngine){return ls??=Mi(r),ls}async function Mi(r){if(!r)throw new Error("matrixworldEngine: expected the script engine.js before this one, got none");
let e=Uint8Array.from(atob(r.binary),t=>t.charCodeAt(0));return new Cr(await r({wasmBinary:e}))}var F=Uint8Array,$e=Uint16Array,Ti=Int32Array,cs=new F([0,0,0,0,0,0,0,0,1,1,1,1,2,2,2,2,3,3,3,3,4,4,4,4,5,5,5,5,0,0,0,0]),us=new F([0,0,0,0,1,1,2,2,3,3,4,4,5,5,
6,6,7,7,8,8,9,9,10,10,11,11,12,12,13,13,0,0]),Ei=new F([16,17,18,0,8,7,9,6,10,5,11,4,12,3,13,2,14,1,15]),ds=function(r,e){for(var t=new $e(31),n=0;n<31;++n)t[n]=
e+=1<<r[n-1];for(var s=new Ti(t[30]),n=1;n<30;++n)for(var o=t[n];o<t[n+1];++o)s[o]=o-t[n]<<5|n;return{b:t,r:s}},ms=ds(cs,2),hs=ms.b,Oi=ms.r;hs[28]=258,Oi[258]=28;
var ps=ds(us,0),ki=ps.b,qu=ps.r,Pr=new $e(32768);for(E=0;E<32768;++E)X=(E&43690)>>1|(E&21845)<<1,X=(X&52428)>>2|(X&13107)<<2,X=(X&61680)>>4|(X&3855)<<4,Pr[E]=((X&
65280)>>8|(X&255)<<8)>>1;var X,E,nt=(function(r,e,t){for(var n=r.length,s=0,o=new $e(e);s<n;++s)r[s]&&++o[r[s]-1];var a=new $e(e);for(s=1;s<e;++s)a[s]=a[s-1]+o[s-
1]<<1;var i;if(t){i=new $e(1<<e);var l=15-e;for(s=0;s<n;++s)if(r[s])for(var c=s<<4|r[s],d=e-r[s],m=a[r[s]-1]++<<d,h=m|(1<<d)-1;m<=h;++m)i[Pr[m]>>l]=c}else for(i=
new $e(n),s=0;s<n;++s)r[s]&&(i[s]=Pr[a[r[s]-1]++]>>15-r[s]);return i}),st=new F(288);for(E=0;E<144;++E)st[E]=8;var E;for(E=144;E<256;++E)st[E]=9;var E;for(E=256;E<
280;++E)st[E]=7;var E;for(E=280;E<288;++E)st[E]=8;var E,fs=new F(32);for(E=0;E<32;++E)fs[E]=5;var E;var Ci=nt(st,9,1);var Ri=nt(fs,5,1),Rr=function(r){for(var e=r[0],t=1;t<r.length;++t)r[t]>e&&(e=r[t]);return e},H=function(r,e,t){var n=e/8|0;return(r[n]|r[n+1]<<8)>>(e&7)&t},$r=function(r,e){
var t=e/8|0;return(r[t]|r[t+1]<<8|r[t+2]<<16)>>(e&7)},$i=function(r){return(r+7)/8|0},Pi=function(r,e,t){return(e==null||e<0)&&(e=0),(t==null||t>r.length)&&(t=r.
length),new F(r.subarray(e,t))};var _i=["unexpected EOF","invalid block type","invalid length/literal","invalid distance","stream finished","no stream handler",,"no callback","invalid UTF-8 da\
ta","extra field too long","date not in range 1980-2099","filename too long","stream finishing","invalid zip data"],z=function(r,e,t){var n=new Error(e||_i[r]);
if(n.code=r,Error.captureStackTrace&&Error.captureStackTrace(n,z),!t)throw n;return n},Li=function(r,e,t,n){var s=r.length,o=n?n.length:0;if(!s||e.f&&!e.l)return t||
new F(0);var a=!t,i=a||e.i!=2,l=e.i;a&&(t=new F(s*3));var c=function($n){var Pn=t.length;if($n>Pn){var _n=new F(Math.max(Pn*2,$n));_n.set(t),t=_n}},d=e.f||0,m=e.
p||0,h=e.b||0,p=e.l,f=e.d,y=e.m,g=e.n,b=s*8;do{if(!p){d=H(r,m,1);var v=H(r,m+1,3);if(m+=3,v)if(v==1)p=Ci,f=Ri,y=9,g=5;else if(v==2){var _=H(r,m,31)+257,J=H(r,m+
10,15)+4,W=_+H(r,m+5,31)+1;m+=14;for(var ne=new F(W),gr=new F(19),I=0;I<J;++I)gr[Ei[I]]=H(r,m+I*3,7);m+=J*3;for(var Tn=Rr(gr),ti=(1<<Tn)-1,ri=nt(gr,Tn,1),I=0;I<
W;){var En=ri[H(r,m,ti)];m+=En&15;var x=En>>4;if(x<16)ne[I++]=x;else{var Te=0,St=0;for(x==16?(St=3+H(r,m,3),m+=2,Te=ne[I-1]):x==17?(St=3+H(r,m,7),m+=3):x==18&&(St=
11+H(r,m,127),m+=7);St--;)ne[I++]=Te}}var On=ne.subarray(0,_),se=ne.subarray(_);y=Rr(On),g=Rr(se),p=nt(On,y,1),f=nt(se,g,1)}else z(1);else{var x=$i(m)+4,M=r[x-4]|
r[x-3]<<8,T=x+M;if(T>s){l&&z(0);break}i&&c(h+M),t.set(r.subarray(x,T),h),e.b=h+=M,e.p=m=T*8,e.f=d;continue}if(m>b){l&&z(0);break}}i&&c(h+131072);for(var ni=(1<<
y)-1,si=(1<<g)-1,yr=m;;yr=m){var Te=p[$r(r,m)&ni],Ee=Te>>4;if(m+=Te&15,m>b){l&&z(0);break}if(Te||z(2),Ee<256)t[h++]=Ee;else if(Ee==256){yr=m,p=null;break}else{var kn=Ee-
254;if(Ee>264){var I=Ee-257,Ze=cs[I];kn=H(r,m,(1<<Ze)-1)+hs[I],m+=Ze}var vr=f[$r(r,m)&si],br=vr>>4;vr||z(3),m+=vr&15;var se=ki[br];if(br>3){var Ze=us[br];se+=$r(
r,m)&(1<<Ze)-1,m+=Ze}if(m>b){l&&z(0);break}i&&c(h+131072);var Cn=h+kn;if(h<se){var Rn=o-se,oi=Math.min(se,Cn);for(Rn+h<0&&z(3);h<oi;++h)t[h]=n[Rn+h]}for(;h<Cn;++h)
t[h]=t[h-se]}}e.l=p,e.p=yr,e.b=h,e.f=d,p&&(d=1,e.m=y,e.d=f,e.n=g)}while(!d);return h!=t.length&&a?Pi(t,0,h):t.subarray(0,h)};var Ni=new F(0);var Ii=function(r,e){return((r[0]&15)!=8||r[0]>>4>7||(r[0]<<8|r[1])%31)&&z(6,"invalid zlib data"),(r[1]>>5&1)==+!e&&z(6,"invalid zlib data: "+(r[1]&32?"need":"u\
nexpected")+" dictionary"),(r[1]>>3&4)+2};function gs(r,e){return Li(r.subarray(Ii(r,e&&e.dictionary),-4),{i:2},e&&e.out,e&&e.dictionary)}var Fi=typeof TextDecoder<"u"&&new TextDecoder,Di=0;try{Fi.decode(Ni,{stream:!0}),Di=1}catch{}var Wi={teams:{pursuer:"pursuers",evader:"evaders"},generation:{pursuer:"pursuer generation",evader:"evader generation"},score:"capture rate",means:{pursuer:"ca\
ptures",evader:"escapes"},curves:{pursuer:"captures",evader:"escapes"},ends:["0 all escape","1 all caught"],lead:"Each cell is a match between two generations: \
the brighter, the more evaders are captured. Click one to watch it.",click:"watch its match"},Ui=([r,e])=>({teams:{pursuer:r,evader:e},generation:{pursuer:`gene\
ration of ${r}`,evader:`generation of ${e}`},score:`score of the ${r}`,means:{pursuer:r,evader:e},curves:{pursuer:"scores",evader:"scores"},ends:[`0 the ${e} wi\
n`,`1 the ${r} win`],lead:`Each cell is a pair of generations: the brighter, the higher the score of the ${r}. Click one to see more of it.`,click:"see more of \
it"}),j=({game:r})=>r?Ui(r.teams):Wi,L=(r,e,t)=>`${j(r).teams[e]} of generation ${t}`;function ie(r,e,t){let n=e-r.payoff.first[0],s=t-r.payoff.first[1],o=r.payoff.capture_rate[n]?.[s];return o===void 0?null:{rate:o,rates:r.payoff.capture_rates[n][s],
lengths:r.payoff.lengths[n]?.[s]??[]}}function ys(r,e,t){let{script:n,policy:s,kept:o,genomes:a}=r.teams[e];if(n!==null||s===null)return"";if(!o.includes(t))return`\
The page holds no genome of ${L(r,e,t)}: it would be too large. Choose a generation of ${o.join(", ")}.`;let i=o.length*s.genome_size;return xs(a,s.genome_size).
length===i?"":`The page is damaged: it does not hold the ${i} numbers of the ${e}s' genomes. Write it again from its run.`}function ae(r,e,t){let{script:n,policy:s,
kept:o,genomes:a}=r.teams[e];if(n!==null||s===null)return n??"random";let i=o.indexOf(t);if(i<0)throw new RangeError(`${e}: expected a generation whose genome t\
he page holds, got ${t}`);let l=s.genome_size,c=xs(a,l).subarray(i*l,(i+1)*l);return{...s,genome:c}}var vs=({teams:r},e)=>(r[e].policy??{kind:"cells"}).kind!=="\
cells",bs=({teams:r},e,t)=>r[e].expressions?.[r[e].kept.indexOf(t)]??"";function kt(r,e,{pursuer:t,evader:n,episode:s,seed:o}){let a=e.seeds[t][n];return r.match(
e.world,ae(e,"pursuer",t),ae(e,"evader",n),BigInt(o??a),s)}var _r=4,Lr=new Map,ws=(r,e)=>{Lr.set(r,e)};function xs(r,e){let t=Lr.get(r);if(t)return t;let n=new Float32Array;
try{let s=zi(Nr(r),e);s.every(Number.isFinite)&&(n=s)}catch(s){if(!(s instanceof DOMException||s instanceof RangeError||Hi(s)))throw s}return Lr.set(r,n),n}var Hi=r=>r instanceof
Error&&"code"in r;function zi(r,e){let t=gs(r),n=t.length/_r,s=new Uint8Array(t.length);for(let a=0;a<s.length;a++)s[a]=t[a%_r*n+Math.floor(a/_r)];let o=new Uint32Array(
s.buffer);for(let a=e;a<o.length;a++)o[a]^=o[a-e];return new Float32Array(s.buffer)}function Nr(r){let e=atob(Q(r)),t=new Uint8Array(e.length);for(let n=0;n<t.length;n++)
t[n]=e.charCodeAt(n);return t}var Q=r=>document.getElementById(r)?.textContent??"";var S=["pursuer","evader"],ee=r=>r==="pursuer"?"evader":"pursuer";var Ts={initial:1,noise:2,learn:3,opponents:4},Fr={pursuer:1,evader:2,both:3},fe=4,Ir=2n**32n;function Ss(r){let e=[],t=BigInt(r);do e.push(Number(t%Ir)),t/=Ir;while(t>
0n);return e}function As(r,e){let t=r;return n=>{let s=n^t;return t=Math.imul(t,e),s=Math.imul(s,t),s^s>>>16}}function Ms(r,e){let t=Math.imul(3389127133,r)-Math.
imul(1232336661,e)|0;return t^t>>>16}function Dr(r,e,t){let n=r.flatMap(Ss);if(e.length){for(;n.length<fe;)n.push(0);n.push(...e.flatMap(Ss))}let s=As(1135663077,
2468251765),o=Array.from({length:fe},(i,l)=>s(n[l]??0));for(let i=0;i<fe;i++)for(let l=0;l<fe;l++)i!==l&&(o[l]=Ms(o[l],s(o[i])));for(let i of n.slice(fe))for(let l=0;l<
fe;l++)o[l]=Ms(o[l],s(i));let a=As(2337405405,1492356589);return Uint32Array.from({length:t},(i,l)=>a(o[l%fe]))}function ot(r,e){let t=Dr(r,[],2*e);return BigUint64Array.
from({length:e},(n,s)=>BigInt(t[2*s])+Ir*BigInt(t[2*s+1]))}var Ct=(r,e,t)=>ot([r,e,t],1)[0];var Es=r=>(e,...t)=>new Wr(Dr([r],[Ts[e],...t],3)),Wr=class{#e;#r;#t;#n=1;constructor(e){this.#e=e[0],this.#r=e[1],this.#t=e[2];for(let t=0;t<12;t++)this.#a()}#a(){
let e=this.#e+this.#r+this.#n++|0;return this.#e=this.#r^this.#r>>>9,this.#r=this.#t+(this.#t<<3)|0,this.#t=(this.#t<<21|this.#t>>>11)+e|0,e>>>0}#s(){return(this.#a()+
.5)/2**32}normals(e){let t=new Float32Array(e);for(let n=0;n<e;n+=2){let s=Math.sqrt(-2*Math.log(this.#s())),o=2*Math.PI*this.#s();t[n]=s*Math.cos(o),n+1<e&&(t[n+
1]=s*Math.sin(o))}return t}integers(e,t){return Int32Array.from({length:t},()=>Math.floor(this.#s()*e))}permutation(e){return this.choice(e,e)}choice(e,t){let n=Int32Array.
from({length:e},(s,o)=>o);for(let s=0;s<t;s++){let o=s+Math.floor(this.#s()*(e-s));[n[s],n[o]]=[n[o],n[s]]}return n.slice(0,t)}};var O=Math.fround,Gi=5,Bi=256,Rt=class{size;sigma;fixed;#e;constructor(e,t,n,s){this.size=e,this.sigma=n,this.fixed=s,this.#e=t.normals((1+Bi)*e);for(let o=0;o<
this.#e.length;o++)this.#e[o]*=O(n)}draw(e,t){let n=t.integers(this.#e.length-this.size+1,e);return Array.from(n,s=>{let o=this.#e.subarray(s,s+this.size);return this.
fixed?o.map((a,i)=>this.fixed[i]?0:a):o})}},Ur=class{#e;#r;#t=0;constructor(e){this.#e=new Float32Array(e),this.#r=new Float32Array(e)}moved(e,t,n){let a=O(1e-8);
this.#t+=1;let i=O(1-.9),l=O(1-.999),c=O(1-.9**this.#t),d=O(1-.999**this.#t);return e.map((m,h)=>{let p=t[h],f=this.#e[h]+=O(i*O(p-this.#e[h])),y=this.#r[h]+=O(
l*O(O(p*p)-this.#r[h])),g=O(O(Math.sqrt(O(O(y)/d)))+a);return O(m+O(O(O(n)*O(O(f)/c))/g))})}};function ji(r){let e=Array.from(r).sort((t,n)=>t-n);return r.map(t=>(e.
indexOf(t)+e.lastIndexOf(t))/(2*(r.length-1))-.5)}var $t=class{genome;groups;#e;#r;#t;#n=[];constructor(e,t,n){this.genome=e,this.#r=t,this.#e=n,this.#t=new Ur(
e.length),this.groups=Int32Array.from({length:n.population},(s,o)=>o%(n.population/2))}get#a(){let{sigma:e,fixed:t}=this.#r,n=0,s=0;return this.genome.forEach((o,a)=>{
t?.[a]||(n+=o*o,s+=1)}),Math.max(e,this.#e.relative_sigma*Math.sqrt(n/s))}ask(e){let t=this.#e.population/2,n=this.genome.length;this.#n=this.#r.draw(t,e);let s=O(
this.#a/this.#r.sigma),o=new Float32Array(2*t*n);return this.#n.forEach((a,i)=>{for(let l=0;l<n;l++){let c=O(s*a[l]);o[i*n+l]=this.genome[l]+c,o[(t+i)*n+l]=this.
genome[l]-c}}),o}tell(e){let t=ji(e),n=this.#n.length,s=new Float32Array(this.genome.length);this.#n.forEach((o,a)=>{let i=O((t[a]-t[n+a])/(2*n*this.#r.sigma**2));
for(let l=0;l<s.length;l++)s[l]+=O(i*o[l])}),this.genome=this.#t.moved(this.genome,s,this.#e.learning_rate)}},at=class{population;groups;#e;#r;#t=new Float64Array(
0);#n=0;constructor(e,t,n){this.population=e,this.#r=t,this.#e=n,this.groups=new Int32Array(n.population)}get genome(){return this.#a(this.#n).slice()}#a(e){let{
size:t}=this.#r;return this.population.subarray(e*t,(e+1)*t)}#s(e,t){let n=this.#e.tournament??Gi,s=t.integers(this.#t.length,e*n);return Array.from({length:e},
(o,a)=>s.subarray(a*n,(a+1)*n).reduce((i,l)=>this.#t[l]>this.#t[i]?l:i))}ask(e){if(!this.#t.length)return this.population;let{size:t}=this.#r,{population:n,elites:s}=this.#e,
o=n-s,a=this.#s(o,e);this.#s(o,e);let i=Array.from(this.#t.keys()).sort((c,d)=>this.#t[d]-this.#t[c]).slice(0,s),l=new Float32Array(this.population.length);return[
...i,...a].forEach((c,d)=>l.set(this.#a(c),d*t)),this.#r.draw(o,e).forEach((c,d)=>{let m=(s+d)*t;for(let h=0;h<t;h++)l[m+h]+=c[h]}),this.population=l,l}tell(e){
this.#t=e,this.#n=e.indexOf(Math.max(...e))}};var A=r=>Array.from(r).reduce((e,t)=>e+t,0)/r.length,Hr=(r,e)=>e==="pursuer"?r:r[0].map((t,n)=>r.map(s=>1-s[n]));var Os=-12676506002282294e14,ks=({hidden:r,mask:e})=>r.map(t=>t+(e?4:0));function it(r){let e=[3*r.fov**2,...ks(r),5],t=0;return e.slice(1).map((n,s)=>{let o={at:t,
inputs:e[s],outputs:n};return t+=(o.inputs+1)*n,o})}function ge(r){if(r.kind==="rating")return r.inputs.length;let{at:e,inputs:t,outputs:n}=it(r).at(-1);return e+
(t+1)*n}var lt=(r,e)=>r.kind==="rating"?{...r,genome:e}:{kind:"cells",hidden:ks(r),activation:"relu",sampled:!0,memory:"none",genome:e};function Cs(r,e,t){let n=t.
initial_weight;if(r.kind==="rating"||t.kind==="rating")return e.normals(ge(r)).map(i=>Math.fround(n)*i);let s=t.initial_head,o=new Float32Array(ge(r)),a=it(r);return a.
forEach(({at:i,inputs:l,outputs:c},d)=>{let m=Math.fround(d===a.length-1?s:n);e.normals(l*c).forEach((h,p)=>o[i+p]=m*h)}),o}function zr(r){if(r.kind==="rating")
return null;let{fov:e,mask:t}=r;if(!t)return null;let n=new Uint8Array(ge(r)),s=new Float32Array(ge(r)),o=it(r),a=o.length-1,i=Math.floor(e/2);return o.forEach(
({at:l,inputs:c,outputs:d},m)=>{let h=(p,f)=>l+p*d+f;for(let p=0;p<4;p++)if(m>0&&n.fill(1,h(c-4+p,0),h(c-4+p+1,0)),m<a)for(let f=0;f<=c;f++)n[h(f,d-4+p)]=1;t.forEach(
(p,f)=>{let y=m===a?1+f:d-4+f,g=m===0?p.map(([b,v,x])=>(b*e+i+v)*e+i+x):[c-4+f];for(let b of g)n[h(b,y)]=1,s[h(b,y)]=m===a?Os:1})}),{fixed:n,values:s}}function Gr(r,e){
return e?r.map((t,n)=>e.fixed[n]?e.values[n]:t):r}function Rs(r,e,t){if(e.kind==="rating"||t.kind==="rating")return r;let n=new Float32Array(ge(t)),s=it(e),o=it(
t),a=Math.floor(t.fov/2)-Math.floor(e.fov/2),i=c=>c>=0&&c<t.fov,l=c=>{let d=Math.floor(c/e.fov**2),m=Math.floor(c/e.fov)%e.fov+a,h=c%e.fov+a;return i(m)&&i(h)?(d*
t.fov+m)*t.fov+h:-1};return s.forEach((c,d)=>{let m=o[d],h=e.hidden[d]??5;for(let p=0;p<(d?e.hidden[d-1]:c.inputs);p++){let f=d?p:l(p);if(!(f<0))for(let y=0;y<h;y++)
n[m.at+f*m.outputs+y]=r[c.at+p*c.outputs+y]}for(let p=0;p<h;p++)n[m.at+m.inputs*m.outputs+p]=r[c.at+c.inputs*c.outputs+p]}),Gr(n.map(c=>c<=Os/2?0:c),zr(t))}function $s(r,e,t,n){let s=r.length,o=Math.max(...r)+1,a=o>1?s/o:1,i=Array.from(r.keys()).sort((m,h)=>r[m]-r[h]),l=[],c=[];for(let m=0;m<e;m++){let h=m%a;h===0&&
(c=Array.from(n.permutation(s/a)).flatMap(p=>i.slice(p*a,(p+1)*a))),l.push([i,c.map((p,f)=>c[f-f%a+(f%a-h+a)%a])])}let d=m=>i.map(()=>s+m);for(let m=0;m<t[1];m++)
l.push([i,d(m)]);for(let m=0;m<t[0];m++)l.push([d(m),i]);return{pursuer:Int32Array.from(l.flatMap(([m])=>m)),evader:Int32Array.from(l.flatMap(([,m])=>m)),group:Int32Array.
from(l.flatMap((m,h)=>i.map(p=>h*o+r[p])))}}function Ps(r,e,t,n){let s=Math.max(...e)+1,o=new Float64Array(t*s),a=new Float64Array(t*s);n.forEach((l,c)=>{if(r[c]>=
t)return;let d=r[c]*s+e[c];o[d]+=l,a[d]+=1});let i=o.map((l,c)=>a[c]?l/a[c]:0);return Float64Array.from({length:t},(l,c)=>{let d=i.subarray(c*s,(c+1)*s);return Br(
d)/a.subarray(c*s,(c+1)*s).filter(Boolean).length})}var Vi=128,Pe=8;function Br(r){let{length:e}=r;if(e>Vi){let h=Math.floor(e/2)-Math.floor(e/2)%Pe;return Br(r.
subarray(0,h))+Br(r.subarray(h))}if(e<Pe)return r.reduce((h,p)=>h+p,0);let t=r.slice(0,Pe),n=e-e%Pe;for(let h=Pe;h<n;h++)t[h%Pe]+=r[h];let[s,o,a,i,l,c,d,m]=t;return r.
subarray(n).reduce((h,p)=>h+p,s+o+(a+i)+(l+c+(d+m)))}var _s=({world:r})=>r.rules.teammate==="REACH"?.2:0;var _t={pursuer:["random","clumsy-fleer"],evader:["random","clumsy-chaser"]},qi=20,Ki=8,Yi=-1,Lt=({world:r,policy:e},t,n)=>e.kind==="rating"?e:{kind:"cells",fov:r.
fov,hidden:e.hidden,mask:e.mask==="none"?null:t[n]},_e=class{settings;epochs=0;until=1/0;archive={pursuer:[],evader:[]};rows=[];cells=new Map;counters={pursuer:[],
evader:[]};#e;#r;#t;#n={};#a=new Set;#s=0;#l=0;#u=0;constructor(e,t,n,s=Es(t.seed)){this.#e=e,this.settings=t,this.#r=n,this.#t=s;for(let o of S){let a=s("initi\
al",S.indexOf(o)),i=t.learner.kind==="ga"?t.learner.population:1,l=Array.from({length:i},()=>Cs(this.shape(o),a,t.policy));this.#d(o,l),this.archive[o].push(this.#n[o].
genome)}this.#x(...S)}shape(e){return Lt(this.settings,this.#r,e)}get finished(){return Math.min(this.archive.pursuer.length,this.archive.evader.length)}*run(){
this.finished===1&&(yield*this.#S(0));for(let e=this.finished;e<=this.settings.schedule.generations;e++){if(this.settings.schedule.kind==="alternating")for(let t of S)
yield*this.#f(t,e),this.#x(t);else yield*this.#m(e),this.#x(...S);yield*this.#S(e)}}change(e){let t=this.settings,n={pursuer:this.shape("pursuer"),evader:this.shape(
"evader")},s=l=>JSON.stringify(l(t))===JSON.stringify(l(e));this.settings=e;let o=s(l=>[l.world.fov,l.policy]);if(!o||!s(l=>l.learner))for(let l of S){let c=d=>Rs(
d,n[l],this.shape(l));this.archive[l]=this.archive[l].map(c),this.#d(l,this.#c(l).map(c))}if(o&&s(l=>l.world))return null;this.cells.clear(),this.#a.clear();let{
pursuer:a,evader:i}=this.archive;return{type:"anew",settings:e,genomes:{pursuer:a.slice(0,this.finished),evader:i.slice(0,this.finished)}}}#c(e){let t=this.#n[e];
if(!(t instanceof at))return[t.genome];let n=t.genome.length,s=Array.from({length:t.population.length/n},(o,a)=>t.population.slice(a*n,(a+1)*n));return Array.from(
{length:this.settings.learner.population},(o,a)=>a===0?t.genome:s[a%s.length])}#d(e,t){let{learner:n}=this.settings,s=this.shape(e),o=n.kind==="ga"?n.mutation:n.
sigma,a=zr(s),i=new Rt(ge(s),this.#t("noise",S.indexOf(e)),o,a?.fixed??null),l=t.map(c=>Gr(c,a));this.#n[e]=n.kind==="ga"?new at(Pt(l),i,n):new $t(l[0],i,n)}*#f(e,t){
for(let n=0;n<this.#i(e);n++){for(;this.epochs>=this.until;)yield{type:"rest"};let s=this.archive[ee(e)].length,o=this.settings.schedule[`${e}s_meet`],a=o==="la\
test"?s-1:o==="round-robin"?n%s:this.#t("opponents",S.indexOf(e),t,n).choice(s,1)[0],i=e==="pursuer"?[t,a]:[a,t],l=this.#n[e],{groups:c}=l,d=ot([this.settings.seed,
...i,Fr[e],n],Math.max(...c)+1),m=l.ask(this.#t("learn",S.indexOf(e),t,n)),h=Int32Array.from(c.keys()),p=new Int32Array(c.length),f={[e]:m,[ee(e)]:this.archive[ee(
e)][a]},y={[e]:h,[ee(e)]:p},g=this.#w(f,y,BigUint64Array.from(c,v=>d[v])),b=this.#v(g,e);this.#b(g,b,{generation:t,team:e,epoch:n,opponent:a}),l.tell(b),yield*this.#p(
t,n,e)}this.archive[e].push(this.#n[e].genome)}*#m(e){for(let t=0;t<this.#i("pursuer");t++){for(;this.epochs>=this.until;)yield{type:"rest"};let{schedule:n,learner:{
population:s}}=this.settings,[o,a]=n.kind==="hall-of-fame"?[n.hall_sample,n.contemporaries]:[0,1],i={pursuer:this.#o("pursuer",e,t),evader:this.#o("evader",e,t)},
l=this.#t("opponents",0,e,t),c={pursuer:this.#h(o,l),evader:this.#h(o,l)},d=g=>Pt([i[g],...Array.from(c[ee(g)],b=>this.archive[g][b])]),m=[c.evader.length,c.pursuer.
length],h=$s(this.#n.pursuer.groups,a,m,l),p=ot([this.settings.seed,e,e,Fr.both,t],Math.max(...h.group)+1),f={pursuer:d("pursuer"),evader:d("evader")},y=this.#w(
f,h,BigUint64Array.from(h.group,g=>p[g]));for(let g of S){let b=Ps(h[g],h[ee(g)],s,this.#v(y,g));this.#b(y,b,{generation:e,team:g,epoch:t,opponent:Yi}),this.#n[g].
tell(b)}yield*this.#p(e,t,"both")}for(let t of S)this.archive[t].push(this.#n[t].genome)}#o(e,t,n){return this.#n[e].ask(this.#t("learn",S.indexOf(e),t,n))}#h(e,t){
let n=this.archive.pursuer.length;return e?t.choice(n,Math.min(e,n)):new Int32Array(0)}#i(e){let{schedule:t}=this.settings;return t.kind==="hall-of-fame"?t.joint_epochs:
t[`${e}_epochs`]}*#p(e,t,n){let[s,o]=this.settings.schedule.kind==="hall-of-fame"?[this.#i("pursuer"),0]:[this.#i("pursuer"),this.#i("evader")],a=t+1+(n==="evad\
er"?s:0),i=s+o;this.epochs+=1,yield{type:"epoch",done:(e-1)*i+a,of:this.settings.schedule.generations*i},yield*this.catchUp()}#w(e,t,n){let s={...this.settings.
world,max_steps:this.settings.train_steps},o=this.#e.rollouts(s,this.#y("pursuer",e.pursuer),this.#y("evader",e.evader),{...t,seed:n},1);this.#s+=o.length.length;
for(let a of o.length)this.#l+=Number(a);for(let a of o.agent_steps)this.#u+=Number(a);return o}#y(e,t){return lt(this.shape(e),t)}#v({captured_fraction:e,overlap:t},n){
let s=_s(this.settings);return Float64Array.from(e,(o,a)=>n==="pursuer"?o:1-o-s*Number(t[2*a+1]))}#b(e,t,n){let s=A(t),o=[0,0];e.faults.forEach((a,i)=>o[Math.floor(
i/3)%2]+=Number(a)),this.rows.push({...n,fitness_mean:s,fitness_std:Math.sqrt(A(t.map(a=>(a-s)**2))),fitness_best:Math.max(...t),capture_rate:A(e.capture_rate),
length:A(e.length),pursuer_faults:o[0]/e.length.length,evader_faults:o[1]/e.length.length,matches:this.#s,steps:this.#l})}#x(...e){for(let t of e)this.counters[t].
push({matches:this.#s,steps:this.#l,agent_steps:this.#u})}*#S(e){yield{type:"generation",number:e,genomes:{pursuer:this.archive.pursuer[e],evader:this.archive.evader[e]}},
yield*this.catchUp()}*catchUp(){for(let e=this.finished-1;e>=0;e--){for(let t=e;t>=0;t--)for(let[n,s]of t===e?[[e,e]]:[[e,t],[t,e]]){if(this.cells.has(`${n} ${s}`))
continue;let o=this.#g(n,s);this.cells.set(`${n} ${s}`,o),yield{type:"cell",cell:o}}this.#a.has(e)||(this.#a.add(e),yield{type:"scores",number:e,scores:{pursuer:this.#A(
"pursuer",e),evader:this.#A("evader",e)}})}}#g(e,t){let{world:n,evaluation_episodes:s,seed:o}=this.settings,a={pursuer:new Int32Array(1),evader:new Int32Array(1),
seed:BigUint64Array.of(Ct(o,e,t))},i=S.map(d=>this.#y(d,this.archive[d][d==="pursuer"?e:t])),l=this.#e.rollouts(n,...i,a,s),c=d=>{let m=Array.from(l[d],Number),
h=m.length/s;return Array.from({length:h},(p,f)=>A(m.filter((y,g)=>g%h===f)))};return{pursuer:e,evader:t,capture_rates:Array.from(l.capture_rate),lengths:Array.
from(l.length),means:{collisions:c("collisions"),faults:c("faults"),agent_steps:c("agent_steps"),survivors:c("survivors")}}}#A(e,t){let{world:n,seed:s}=this.settings,
o=this.#y(e,this.archive[e][t]),a=new Int32Array(1);return A(_t[e].map((i,l)=>{let c=ot([s,S.indexOf(e),l,Ki],1),d=e==="pursuer"?[o,i]:[i,o],m=A(this.#e.rollouts(
n,...d,{pursuer:a,evader:a,seed:c},qi).capture_rate);return e==="pursuer"?m:1-m}))}};function Pt(r){let e=new Float32Array(r.reduce((n,{length:s})=>n+s,0)),t=0;
for(let n of r)e.set(n,t),t+=n.length;return e}var Zi=12,Nt=class{#e=null;#r=null;#t=[];#n;constructor(e,t){this.#n=t;try{let n=new Blob([Q("script-engine"),`
`,Q(`script-${e}`)],{type:"text/javascript"});this.#r=new Worker(URL.createObjectURL(n)),this.#r.onerror=()=>this.#e||this.#a(),this.#r.onmessage=()=>this.#s(this.#r)}catch{
this.#a()}}send(e){this.#e?this.#e.postMessage(e):this.#t.push(e)}close(){this.send({type:"stop"}),this.#r?.terminate()}#a(){let{port1:e,port2:t}=new MessageChannel;
jr(t),this.#s(e)}#s(e){this.#e=e,e.onmessage=({data:t})=>t.type!=="ready"&&this.#n(t);for(let t of this.#t.splice(0))e.postMessage(t)}};function jr(r){let e=b=>r.
postMessage(b),t=Ot(),n=null,s=null,o=null,a=[],i=!1,l=0,c=!1,d=new MessageChannel,m=b=>{let v=n.change(b);e({type:"changed",at:n.epochs,settings:b}),v&&e(v),!s&&
n.finished<=b.schedule.generations?(s=n.run(),i=!0):i||(o=n.catchUp())},h=()=>{i=!1,o=n.catchUp(),e({type:"stopped",at:n.epochs})},p=()=>{if(i&&s){for(;a.length&&
a[0].at<=n.epochs;)m(a.shift().settings);let{value:v,done:x}=s.next();return x?(s=null,i=!1,o=n.catchUp(),e({type:"end",at:n.epochs,seconds:l/1e3})):v.type==="r\
est"?h():e(v),!0}let b=o?.next();return b&&!b.done?e(b.value):o=null,!!o},f=()=>{let b=performance.now(),v=!0;for(;v&&performance.now()<b+Zi;)v=p();l+=performance.
now()-b,!(!v||c)&&(c=!0,d.port2.postMessage(null))},y=async b=>{if(b.type==="start")n=new _e(await t,b.settings,b.masks),s=n.run(),o=null,a=[...b.plan],i=!0,l=0,
n.until=b.until,e({type:"began"});else if(n)if(b.type==="change")a=[],n.until=1/0,m(b.settings);else if(b.type==="go")n.until=1/0,i=!0;else if(b.type==="stop")i&&
h();else{let{settings:v,archive:x,rows:M,cells:T,counters:_,finished:J}=n;e({type:"saved",race:{settings:v,archive:x,rows:M,cells:T,counters:_,finished:J}})}else
return;f()},g=b=>{Promise.resolve().then(b).catch(v=>{s=o=null,e({type:"failed",message:String(v)})})};d.port1.onmessage=()=>{c=!1,g(f)},r.onmessage=({data:b})=>g(
()=>y(b)),e({type:"ready"})}var Ji="http://www.w3.org/2000/svg";function u(r,e={},...t){return Ls(document.createElement(r),e,t)}function w(r,e={},...t){return Ls(document.createElementNS(
Ji,r),e,t)}function Ls(r,e,t){for(let[s,o]of Object.entries(e))o==null||o===!1||(typeof o=="function"?r.addEventListener(s.slice(2),o):r.setAttribute(s,o===!0?"":
String(o)));let n=t.filter(s=>s!=null&&s!==!1);return r.append(...n.map(s=>typeof s=="number"?String(s):s)),r}function Ns(r,e){let t=u("select",{onchange:()=>e(
t.value)},...r.map(([n,s])=>u("option",{value:n},s)));return t}async function Vr(r){try{await r}catch(e){let t=document.querySelector("#page, main")??document.body;
throw t.querySelector(".absent")?.remove(),t.prepend(u("p",{class:"card problem",role:"alert"},e instanceof WebAssembly.CompileError||/WebAssembly/.test(String(
e))?"This page plays by WebAssembly, which is forbidden where it lies ('wasm-unsafe-eval' is missing in the content policy): save the file, and open it from you\
r disk.":`The page could not start: ${String(e)}`)),e}finally{document.body.dataset.ready="true"}}function It(r,e){let t=URL.createObjectURL(new Blob([e],{type:"application/octet-stream"}));u("a",{href:t,download:r}).click(),setTimeout(()=>URL.revokeObjectURL(
t),6e4)}var Is=()=>document.documentElement.dataset.theme==="dark";function ct(r){document.documentElement.dataset.theme=r?"dark":"light"}var Xi=()=>ct(!Is());if(typeof document<
"u"){let r=matchMedia("(prefers-color-scheme: dark)");r.addEventListener("change",()=>ct(r.matches)),ct(r.matches);let e=!1;addEventListener("beforeprint",()=>{
e=Is(),ct(!1)}),addEventListener("afterprint",()=>ct(e))}function Fs(){return u("button",{type:"button",title:"Light or dark (D)","aria-label":"Light or dark",onclick:Xi},
"◐")}var Ft=(r,e,...t)=>u("header",{class:"top"},u("div",{},u("h1",{},r),e?u("p",{class:"lead"},e):null),u("div",{class:"tools"},...t,Fs()));var Dt=r=>r!==void 0&&"predict"in r,Wt=({sections:r})=>new Map(r.flatMap(({parts:e})=>e.filter(Dt).map(t=>[t.predict,t]))),Ds=()=>JSON.parse(Q("data"));var qr=[[0,0],[-1,0],[0,1],[1,0],[0,-1],[-1,1],[1,1],[1,-1],[-1,-1]];var ye=(r,e)=>e<r.nPursuers,C=(r,e)=>[r.positions[2*e],r.positions[2*e+1]],Kr=({rows:r,cols:e},[t,n])=>t>=0&&n>=0&&t<r&&n<e,Yr=(r,e,t=3)=>r!==void 0&&[0,1,2].slice(
0,t).some(n=>r[3*e+n]),Zr=(r,e)=>Yr(r.fault,e),Ws=(r,e)=>!Zr(r,e)&&Yr(r.involved,e,2);function Ut(r,e,t){let n=C(r,t),s=C(e,t),o=n[0]!==s[0]||n[1]!==s[1],a=e.involved===
void 0||Yr(e.involved,t);return!!(e.alive[t]&&e.actions?.[t]&&!o&&a)}function Ht(r,e,t){let[n,s]=C(r,t),[o,a]=qr[e.actions?.[t]??0];return[n+o,s+a]}function ut(r,e,t){
return Array.from({length:t.everCaptured.length},(s,o)=>o).filter(s=>t.everCaptured[s]&&!e.everCaptured[s]).map(s=>r.nPursuers+s)}var zt=r=>r.moments.flatMap((e,t)=>t&&
ut(r,r.moments[t-1],e).length?[t]:[]);function Gt(r,e){return Array.from({length:e.alive.length},(n,s)=>s).filter(n=>r.alive[n]&&!e.alive[n])}var Us=[-.31,0,.31],Hs=[{size:1,at:[[0,0]]},{size:.62,at:[[-.2,.2],[.2,-.2]]},{size:.54,at:[[-.23,.22],[.23,.22],[0,-.22]]},{size:.54,at:[[-.23,.23],[.23,.23],[
-.23,-.23],[.23,-.23]]},{size:.36,at:Us.flatMap(r=>Us.map(e=>[e,r]))}],Qi=.3,el=.35,tl=.55;function dt(r,e){let t=new Map;for(let n=0;n<e.alive.length;n++){if(!e.
alive[n])continue;let[s,o]=C(e,n),a=s*r.cols+o,i=t.get(a);i?i.push(n):t.set(a,[n])}return t}function zs(r,e){let t=Array.from(e.alive,(n,s)=>{let[o,a]=C(e,s);return{
x:a+.5,y:o+.5,size:1,alpha:0}});for(let n of dt(r,e).values()){let s=Hs[Math.min(n.length,Hs.length)-1];n.forEach((o,a)=>{let[i,l]=s.at[Math.min(a,s.at.length-1)],
c=t[o];c.x+=i,c.y+=l,c.size=s.size,c.alpha=1})}return t}var Gs=r=>r*r*(3-2*r),Le=(r,e,t)=>r+(e-r)*t,Bs=r=>Math.min(1,Math.max(0,r));function js(r,e,t,n){let s={
SIMULTANEOUS:1,SWARM_TURNS:2,AGENT_TURNS:t}[r.interaction];if(s===1)return Gs(n);let o=s===t?e:+!ye(r,e),a=Math.max(1/s,el);return Gs(Bs((n-o/(s-1)*(1-a))/a))}function Bt(r,e){
let t=r.moments.length-1,n=Math.min(Math.floor(e),t),s=r.moments[n],o=zs(r,s);if(n===t||e===n)return o;let a=r.moments[n+1],i=zs(r,a);return o.map((l,c)=>{let d=js(
r,c,o.length,e-n);return rl(s,a,c,l,i[c],d)})}function Jr(r,e,t){let n=r.moments.length-1,s=Math.min(Math.floor(t),n),o=r.moments[s],a=r.moments[Math.min(s+1,n)],
i=js(r,e,o.alive.length,t-s),[l,c]=C(o,e),[d,m]=C(a,e);return[Le(c,m,i)+.5,Le(l,d,i)+.5]}function rl(r,e,t,n,s,o){let a=n.alpha>s.alpha,i={x:Le(n.x,s.x,o),y:Le(
n.y,s.y,o),size:a?n.size:Le(n.size,s.size,o),alpha:a?Bs((1-o)/(1-tl)):Le(n.alpha,s.alpha,o)};if(Ut(r,e,t)){let[l,c]=C(r,t),[d,m]=Ht(r,e,t),h=Qi*Math.sin(Math.PI*
o);i.x+=(m-c)*h,i.y+=(d-l)*h}return i}var Vs=2*Math.PI;function ve(r,e,t,n){r.beginPath(),r.arc(e,t,n/2,0,Vs)}function jt(r,e,t,n){let s=n/2,o=[[0,-.97],[.97,.83],[-.97,.83]].map(([a,i])=>[e+a*s,t+i*
s]);r.beginPath(),r.moveTo((o[2][0]+o[0][0])/2,(o[2][1]+o[0][1])/2),o.forEach(([a,i],l)=>{let[c,d]=o[(l+1)%3];r.arcTo(a,i,c,d,n*.09)}),r.closePath()}function qs(r,e,t,n){
let s=n*.32;r.beginPath(),r.moveTo(e-s,t-s),r.lineTo(e+s,t+s),r.moveTo(e+s,t-s),r.lineTo(e-s,t+s)}function Ks(r,e,t,n){r.beginPath();for(let s=0;s<16;s++){let o=n/
2*(s%2?.6:.95),a=Vs*s/16;r.lineTo(e+o*Math.sin(a),t-o*Math.cos(a))}r.closePath()}function Ys(r,e,t,n,s,o){let a=Math.atan2(s-t,n-e);r.beginPath(),r.moveTo(e,t),
r.lineTo(n,s);for(let i of[-1,1])r.moveTo(n,s),r.lineTo(n-o*Math.cos(a+i*.6),s-o*Math.sin(a+i*.6))}var Zs=4,nl=1.6,sl=.95,ol=5,al=.16,il=9,ll=.09,cl=.2,Js=.75,$=(r,e)=>r.left+e*r.cell,P=(r,e)=>r.top+e*r.cell;function Ne(r,e,t){return ye(e,t)?r.colors.pursuer:
r.colors.evader}function Vt({ctx:r,colors:e},t,n,s,o,a,i=0){r.font=`700 ${Math.round(o)}px system-ui, sans-serif`,r.textAlign="center",r.textBaseline="middle",r.
strokeStyle=e.paper,r.lineWidth=i,i&&r.strokeText(t,n,s),r.fillStyle=a,r.fillText(t,n,s)}function Xs({ctx:r,grid:e,colors:t}){let{left:n,top:s,cell:o,rows:a,cols:i}=e,
l=i*o,c=a*o;if(r.fillStyle=t.paper,r.fillRect(n,s,l,c),o<ol)return;r.fillStyle=t.line;let d=Math.max(1,Math.round(o/60));for(let m=1;m<i;m++)r.fillRect(n+m*o,s,
d,c);for(let m=1;m<a;m++)r.fillRect(n,s+m*o,l,d)}function Qs({ctx:r,grid:e,colors:t},n){let{left:s,top:o,cell:a,rows:i,cols:l}=e;r.fillStyle=t.obstacle;for(let c=0;c<
i*l;c++){if(!n.obstacles[c])continue;let d=Math.floor(c/l),m=c%l;r.fillRect(s+m*a,o+d*a,a,a)}eo({ctx:r,grid:e,colors:t})}function eo({ctx:r,grid:{left:e,top:t,cell:n,
rows:s,cols:o},colors:a}){let i=Math.min(5,Math.max(2,Math.round(n/18)));r.strokeStyle=a.frame,r.lineWidth=i,r.strokeRect(e-i/2,t-i/2,o*n+i,s*n+i)}function to({
ctx:r,grid:e,colors:t},n){let{left:s,top:o,cell:a,rows:i,cols:l}=e,c=a<24*n?5:1;r.font=`500 ${Math.round(Math.min(15*n,Math.max(9*n,a*.32)))}px system-ui, sans-\
serif`,r.fillStyle=t.muted,r.textBaseline="alphabetic",r.textAlign="center";let d=5*n+a/40;for(let m=0;m<l;m+=c)r.fillText(String(m),s+(m+.5)*a,o-d);r.textAlign=
"right",r.textBaseline="middle";for(let m=0;m<i;m+=c)r.fillText(String(m),s-d,o+(m+.5)*a)}function ro({grid:r},e,t,n){let s=Math.floor(e.fov/2)+.5,o=Math.max(0,
t-s),a=Math.min(r.cols,t+s),i=Math.max(0,n-s),l=Math.min(r.rows,n+s);return[$(r,o),P(r,i),(a-o)*r.cell,(l-i)*r.cell]}function no(r,e,t,n){let{ctx:s,grid:o,colors:a}=r;
s.save(),s.beginPath(),s.rect(0,0,s.canvas.width,s.canvas.height),s.rect(...ro(r,e,t,n)),s.clip("evenodd"),s.clearRect(0,0,s.canvas.width,s.canvas.height),s.fillStyle=
a.line,s.fillRect(o.left,o.top,o.cols*o.cell,o.rows*o.cell),s.restore(),eo(r)}function so(r,{x:e,y:t,alpha:n},s){let{ctx:o,grid:a,colors:i}=r,l=Math.max(a.cell,
16*s)*1.06,c=$(a,e),d=P(a,t);o.globalAlpha=Math.max(n,.6),o.beginPath(),o.roundRect(c-l/2,d-l/2,l,l,l*.2),o.strokeStyle=i.focus,o.lineWidth=Math.max(2,2.5*s),o.
stroke();let m=Math.max(11*s,Math.min(18*s,a.cell*.5)),h=d-l/2<m*1.2,p=d+(h?1:-1)*(l/2+m*.7);o.lineJoin="round",Vt(r,"You",c,p,m,i.ink,m*.35),o.globalAlpha=1}function oo(r,e,t,n,s){
let{ctx:o,grid:a}=r,i=ro(r,e,n,s),l=Ne(r,e,t);o.globalAlpha=.11,o.fillStyle=l,o.fillRect(...i),o.globalAlpha=.8,o.strokeStyle=l,o.lineWidth=Math.max(1,a.cell/24),
o.strokeRect(...i),o.globalAlpha=1}function ao(r,e,t,n,s){let{ctx:o,grid:a}=r,i=Math.min(Math.ceil(t),e.moments.length-1),l=e.moments[i];o.lineCap="round",o.lineWidth=
Math.min(il,Math.max(1,a.cell*al));for(let c=Math.max(1,Math.floor(t-n)+1);c<=i;c++){let d=e.moments[c-1],m=e.moments[c],h=Math.max(0,Math.min(1,(t-c)/n));o.globalAlpha=
Js+(cl-Js)*h;for(let p=0;p<m.alive.length;p++){let f=c===i&&t<i;if(!d.alive[p]||!(l.alive[p]||f))continue;let y=(ye(e,p)?-1:1)*ll,[g,b]=C(d,p),[v,x]=C(m,p);if(g===
v&&b===x)continue;let M=f?s[p].x:x+.5,T=f?s[p].y:v+.5;o.strokeStyle=Ne(r,e,p),o.beginPath(),o.moveTo($(a,b+.5+y),P(a,g+.5+y)),o.lineTo($(a,M+y),P(a,T+y)),o.stroke()}}
o.globalAlpha=1}function io(r,e,t){let n=Math.min(Math.ceil(t),e.moments.length-1);for(let s=Math.max(1,n-Zs+1);s<=n;s++){let o=e.moments[s-1],a=e.moments[s],i=s>
t?Math.max(0,1-2*(s-t)):1-(t-s)/Zs,l=ut(e,o,a);for(let c of Gt(o,a))l.includes(c)||dl(r,C(a,c),i);for(let c of l)ul(r,C(a,c),i)}r.ctx.globalAlpha=1}function ul({
ctx:r,grid:e,colors:t},[n,s],o){r.globalAlpha=o,Ks(r,$(e,s+.5),P(e,n+.5),Math.max(8,e.cell*nl)),r.fillStyle=t.capture,r.fill(),r.strokeStyle=t.ink,r.lineWidth=Math.
max(1,e.cell/36),r.lineJoin="round",r.stroke()}function dl({ctx:r,grid:e,colors:t},[n,s],o){r.globalAlpha=o,qs(r,$(e,s+.5),P(e,n+.5),Math.max(7,e.cell*sl)),r.strokeStyle=
t.collision,r.lineWidth=Math.max(2,e.cell*.17),r.lineCap="round",r.stroke()}function lo({ctx:r,grid:e,colors:t},n,s){let o=Math.max(1,e.cell*.07);r.strokeStyle=
r.fillStyle=t.collision,r.lineWidth=Math.max(1,e.cell*.05),r.setLineDash([e.cell*.14,e.cell*.1]);for(let[a,i]of n){if(a<0||i<0||a>=e.rows||i>=e.cols)continue;let l=[
$(e,i)+o,P(e,a)+o,e.cell-2*o,e.cell-2*o];r.globalAlpha=.2*s,r.fillRect(...l),r.globalAlpha=s,r.strokeRect(...l)}r.setLineDash([]),r.globalAlpha=1}function co({ctx:r,
grid:e,colors:t},n,s,o,a){r.globalAlpha=a,ve(r,$(e,n),P(e,s),Math.max(8,e.cell*o*1.02)),r.strokeStyle=t.collision,r.lineWidth=Math.max(1.5,e.cell*.085*Math.sqrt(
o)),r.stroke(),r.globalAlpha=1}var ml=.8,hl=.92,pl=15,fl=7,Xr=9;function uo(r,e,t,n,s,o){n.forEach((a,i)=>{a.alpha>0&&gl(r,e,t,i,a,s,o)}),r.ctx.globalAlpha=1;for(let a of dt(e,t).values())a.length>
Xr&&yl(r,n[a[Xr-1]],a.length-Xr+1)}function gl(r,e,t,n,s,o,a){let{ctx:i,grid:l,colors:c}=r,d=ye(e,n),m=$(l,s.x),h=P(l,s.y),p=Math.max(4,l.cell*s.size*(d?hl:ml)),
f=Ne(r,e,n),y=!d&&!!t.captured[n-e.nPursuers];if(i.globalAlpha=s.alpha,(d?jt:ve)(i,m,h,p),p>fl*a&&(i.strokeStyle=c.paper,i.lineWidth=Math.max(2,p*.1),i.stroke()),
i.fillStyle=y?c.paper:f,i.fill(),y&&(ve(i,m,h,p*.82),i.strokeStyle=f,i.lineWidth=p*.18,i.stroke()),!o||p<pl*a)return;let g=String(d?n:n-e.nPursuers),b=p*(d?.4:.5)*
(g.length>1?.8:1);Vt(r,g,m,h+p*(d?.17:.03),b,y?f:c.paper)}function yl(r,e,t){let{cell:n}=r.grid;Vt(r,`+${t}`,$(r.grid,e.x),P(r.grid,e.y),n*.3,r.colors.ink,n*.1)}var vl=.46,bl=.86,wl=.66,mo=.48,xl=.78,Sl=.58;function ho(r,e,t,n){let s=e.moments[t-1],o=e.moments[t];if(!s)return;let{ctx:a,grid:i,colors:l}=r;a.strokeStyle=l.
collision,a.lineWidth=Math.max(1.5,i.cell*.07),a.lineCap="butt",a.globalAlpha=n;for(let c=0;c<o.alive.length;c++)Ut(s,o,c)&&Al(r,e,C(s,c),Ht(s,o,c));a.globalAlpha=
1}function Al({ctx:r,grid:e},t,n,s){let o=s[1]-n[1],a=s[0]-n[0],i=m=>$(e,n[1]+.5+o*m),l=m=>P(e,n[0]+.5+a*m),c=Kr(t,s)?xl:Sl;r.setLineDash([e.cell*.09,e.cell*.06]),
r.beginPath(),r.moveTo(i(mo),l(mo)),r.lineTo(i(c),l(c)),r.stroke(),r.setLineDash([]);let d=.17*e.cell/Math.hypot(o,a);r.beginPath(),r.moveTo(i(c)-a*d,l(c)+o*d),
r.lineTo(i(c)+a*d,l(c)-o*d),r.stroke()}function po(r,e,t,n,s,o){let a=qr[o];if(!o||!a)return;let{ctx:i,grid:l,colors:c}=r,d=Kr(e,[n[0]+a[0],n[1]+a[1]])?bl:wl,m=vl*
s.size,h=[$(l,s.x+a[1]*m),P(l,s.y+a[0]*m),$(l,s.x+a[1]*d),P(l,s.y+a[0]*d)],p=Math.max(1.5,l.cell*.085);i.lineCap=i.lineJoin="round";for(let[f,y]of[[c.paper,p*2.1],
[Ne(r,e,t),p]])i.strokeStyle=f,i.lineWidth=y,Ys(i,...h,l.cell*.2),i.stroke()}var go={numbers:!0,axes:!1,trail:6,viewers:[],plan:null,selected:null,cursor:null,you:null,fog:!1};function yo(r,e,t,n,s){let{ctx:o,grid:a,colors:i}=r,l=Math.min(
Math.ceil(t),e.moments.length-1),c=e.moments[l],d=t===l,m=Bt(e,t),h=d?1:Math.max(0,1-2*(l-t));o.clearRect(0,0,o.canvas.width,o.canvas.height),Xs(r);for(let y of n.
viewers)m[y]?.alpha&&oo(r,e,y,...Jr(e,y,t));Qs(r,e),n.axes&&to(r,s),ao(r,e,t,n.trail,m),lo(r,c.contested??[],h),io(r,e,t),ho(r,e,l,h),m.forEach(({x:y,y:g,size:b},v)=>{
let x=Ws(c,v)?.4:0,M=Zr(c,v)?1:x;M&&co(r,y,g,b,M*h)});let p=d?c:e.moments[Math.max(0,l-1)];if(uo(r,e,p,m,n.numbers,s),d&&n.plan)for(let[y,g]of m.entries())g.alpha&&
po(r,e,y,C(c,y),g,n.plan[y]??0);n.you!==null&&(n.fog&&no(r,e,...Jr(e,n.you,t)),so(r,m[n.you],s)),o.lineWidth=Math.max(2,2.5*s),o.strokeStyle=i.focus;let f=n.selected===
null?void 0:m[n.selected];f?.alpha&&fo(r,f.x,f.y,f.size*.96),n.cursor&&(o.setLineDash([a.cell*.12,a.cell*.08]),fo(r,n.cursor[1]+.5,n.cursor[0]+.5,.8),o.setLineDash(
[]))}function fo({ctx:r,grid:e},t,n,s){let o=s*e.cell;r.beginPath(),r.roundRect(e.left+t*e.cell-o/2,e.top+n*e.cell-o/2,o,o,o*.1),r.stroke()}var vo=(r,e)=>(e+.24)/(r+.24);function bo(r,e,t,n,s,o){let a=t?28*o:0,i=(c,d)=>(c-a)/(d+2*.12),l=Math.max(1,Math.floor(Math.min(i(n,e),i(s,r))));return{rows:r,cols:e,
cell:l,left:Math.round((n-e*l+a)/2),top:Math.round((s-r*l+a)/2)}}function wo(r,e,t){let n=Math.floor((t-r.top)/r.cell),s=Math.floor((e-r.left)/r.cell);return n>=
0&&n<r.rows&&s>=0&&s<r.cols?[n,s]:null}var Ml=["paper","line","frame","ink","muted","obstacle"],Tl=["pursuer","evader","capture","collision","focus"];function qt(r){let e=getComputedStyle(r),t=(n,s)=>[
n,e.getPropertyValue(s+n).trim()];return Object.fromEntries([...Ml.map(n=>t(n,"--board-")),...Tl.map(n=>t(n,"--"))])}var le=()=>matchMedia("(prefers-reduced-motion: reduce)").matches,Ie=class{canvas;#e=null;#r=0;#t;#n={rows:1,cols:1,left:0,top:0,cell:1};#a=0;constructor(e,t={}){
this.canvas=e,e.classList.add("board"),e.setAttribute("role","img"),this.#t={...go,...t},new ResizeObserver(()=>this.#l()).observe(e),new MutationObserver(()=>this.
redraw()).observe(document.documentElement,{attributes:!0}),addEventListener("beforeprint",()=>this.drawNow())}set look(e){this.#t={...this.#t,...e},this.#s(),this.
redraw()}show(e,t){this.#e=e,this.#r=Math.min(Math.max(0,t),e.moments.length-1),this.#s(),this.redraw()}redraw(){this.#a||(this.#a=requestAnimationFrame(()=>this.
drawNow()))}drawNow(){cancelAnimationFrame(this.#a),this.#a=0;let e=this.canvas.getContext("2d");if(!e||!this.#e)return;let{rows:t,cols:n}=this.#e,s=devicePixelRatio||
1;this.#n=bo(t,n,this.#t.axes,this.canvas.width,this.canvas.height,s);let o={ctx:e,grid:this.#n,colors:qt(this.canvas)};yo(o,this.#e,this.#r,this.#t,s)}cellAt(e,t){
let n=this.canvas.getBoundingClientRect(),s=this.canvas.width/n.width;return wo(this.#n,(e-n.left)*s,(t-n.top)*s)}agentAt(e,t){let n=this.cellAt(e,t);if(!n||!this.#e)
return null;let s=this.#e.moments[Math.round(this.#r)],o=dt(this.#e,s).get(n[0]*this.#e.cols+n[1])??[],a=Bt(this.#e,Math.round(this.#r)),i=l=>{let[c,d]=this.pointOf(
a[l].x,a[l].y);return Math.hypot(c-e,d-t)};return o.length?o.reduce((l,c)=>i(c)<i(l)?c:l):null}pointOf(e,t){let n=this.canvas.getBoundingClientRect(),s=n.width/
this.canvas.width,{left:o,top:a,cell:i}=this.#n;return[n.left+(o+e*i)*s,n.top+(a+t*i)*s]}#s(){if(!this.#e)return;let{rows:e,cols:t}=this.#e;this.canvas.style.setProperty(
"--board-aspect",String(vo(e,t)))}#l(){let e=devicePixelRatio||1,{width:t,height:n}=this.canvas.getBoundingClientRect();this.canvas.width=Math.max(1,Math.round(
t*e)),this.canvas.height=Math.max(1,Math.round(n*e)),this.drawNow()}};var mt=[.5,1,2,4,8,16,32,64],Kt=0,Yt=12,El=2,ce=class extends EventTarget{#e;#r;#t;#n=0;#a=0;#s=!1;#l=null;#u=0;#c=[];#d=[];glide=.28;constructor(e,{speed:t=4,still:n=!1}={}){
super(),this.#e=e,this.#r=t,this.#t=n}get step(){return this.#n}get time(){return this.#t?this.#n:this.#a}get arrived(){return this.#a===this.#n}get playing(){return this.#s}get length(){
return this.#e}set length(e){this.#e=e,this.#n>e&&this.jump(e),this.#i("state")}get marks(){return this.#c}set marks(e){this.#c=e,this.#i("state")}get ticks(){return this.#d}set ticks(e){
this.#d=e,this.#i("state")}get pace(){return this.#r||Math.max(El,this.#e/Yt)}get speed(){return this.#r}set speed(e){this.#r=e,this.#i("state")}changeSpeed(e){
let t=mt.findIndex(n=>n>=this.pace);this.speed=mt[Math.min(mt.length-1,Math.max(0,t+e))]}play(){this.#s||!this.#e||(this.#n===this.#e&&this.jump(0),this.#s=!0,this.#i(
"state"),this.#m())}pause(){this.#s&&(this.#s=!1,this.#i("state"))}toggle(){this.#s?this.pause():this.play()}move(e){this.pause();let t=Math.min(this.#e,Math.max(
0,this.#n+e));Math.abs(t-this.#a)>1?this.jump(t):this.#f(t),this.#m()}jump(e){this.#a=Math.min(this.#e,Math.max(0,Math.round(e))),this.#f(this.#a),this.#i("fram\
e")}#f(e){e!==this.#n&&(this.#n=e,this.#i("step"),this.#t&&this.#i("frame"))}#m(){this.#l===null&&(this.#u=performance.now(),this.#l=requestAnimationFrame(()=>this.#o()))}#o(){
this.#l=null;let e=performance.now();this.#h(Math.min(.25,(e-this.#u)/1e3)),this.#u=e,(!this.#t||this.arrived)&&this.#i("frame"),(this.#s||this.#a!==this.#n)&&(this.#l=
requestAnimationFrame(()=>this.#o()))}#h(e){let t=e;for(;t>0;){if(this.#a===this.#n){if(!this.#s)return;if(this.#n===this.#e)return this.pause();this.#f(this.#n+
1)}let n=this.#s?this.pace:1/this.glide,s=this.#n-this.#a,o=Math.min(Math.abs(s),t*n);t-=o/n,this.#a=o===Math.abs(s)?this.#n:this.#a+Math.sign(s)*o}this.#s&&this.#a===
this.#e&&this.pause()}#i(e){this.dispatchEvent(new Event(e))}};function xo(r,e){if(e.ctrlKey||e.metaKey||e.altKey)return!1;let t=e.shiftKey?10:1,s={" ":()=>r.toggle(),
ArrowRight:()=>r.move(t),ArrowLeft:()=>r.move(-t),Home:()=>r.move(-r.length),End:()=>r.move(r.length),"+":()=>r.changeSpeed(1),"-":()=>r.changeSpeed(-1)}[e.key];
return s?.(),s!==void 0}var Ol={first:"M6 5v14M19 5 9 12l10 7z",back:"M17 5 7 12l10 7z",play:"M7 4.5 19 12 7 19.5z",pause:"M8 5v14M16 5v14",forward:"M7 5l10 7-10 7z",last:"M18 5v14M5 5\
l10 7-10 7z"};function So(r){return w("svg",{viewBox:"0 0 24 24","aria-hidden":"true",class:"icon"},w("path",{d:Ol[r]}))}function ht(r,e,t,n){return u("button",
{type:"button",class:"player-button","aria-label":e,title:`${e} (${t})`,onclick:n},So(r))}function Fe(r){let e=ht("play","Play","Space",()=>r.toggle()),t=u("inp\
ut",{type:"range",class:"player-scrub",min:0,step:1,"aria-label":"Step",oninput:()=>{r.pause(),r.jump(Number(t.value))}}),n=u("div",{class:"captures","aria-hidd\
en":"true",title:"Captures"}),s=u("div",{class:"losses","aria-hidden":"true"}),o=u("select",{class:"player-speed","aria-label":"Speed",title:`Steps a second, or\
 the whole in ${Yt} s (+ and -)`,onchange:()=>r.speed=Number(o.value)},u("option",{value:Kt},`in ${Yt} s`),...mt.map(m=>u("option",{value:m},`${m} / s`))),a=u("\
output",{class:"player-count"}),i=u("div",{class:"player",role:"group","aria-label":"Player"},ht("first","First step","Home",()=>r.move(-r.length)),ht("back","S\
tep back","←",()=>r.move(-1)),e,ht("forward","Step forward","→",()=>r.move(1)),ht("last","Last step","End",()=>r.move(r.length)),u("div",{class:"scrub"},n,s,
t),a,o),l=(m,h={})=>{let p=u("i",h);return p.style.left=`${100*m/Math.max(1,r.length)}%`,p},c=()=>{n.replaceChildren(...r.marks.map(m=>l(m))),s.replaceChildren(
...r.ticks.map(({step:m,kind:h,size:p,text:f})=>{let y=l(m,{class:h,title:`Step ${m}: ${f}`});return y.style.height=`${100*p}%`,y}))},d=()=>{e.replaceChildren(So(
r.playing?"pause":"play")),e.ariaLabel=r.playing?"Pause":"Play",e.title=`${e.ariaLabel} (Space)`,t.max=String(r.length),t.value=String(r.step),t.ariaValueText=`\
step ${r.step} of ${r.length}`,a.textContent=`${r.step} / ${r.length}`,a.style.minWidth=`${2*String(r.length).length+3}ch`,o.value=String(r.speed)};return r.addEventListener(
"step",d),r.addEventListener("state",d),r.addEventListener("state",c),i.addEventListener("keydown",m=>{!(m.target instanceof HTMLSelectElement||m.key===" "&&m.target!==
t)&&xo(r,m)&&m.preventDefault()}),d(),i}var R=(r,e=2)=>r==null?"-":r.toFixed(e);function Ao(r,e,t){return e===null||t===null?R(r):`${R(r)} (${R(e)} to ${R(t)})`}function De(r){let e=Math.abs(r),t=e>=1e4?
e.toExponential(0):e.toFixed(e<100?2:0);return r<0&&Number(t)?`−${t}`:t}var te=r=>r.charAt(0).toUpperCase()+r.slice(1);function pt(r,e,t,n=!1){let s=(e-r)/Math.max(1,t),o=10**Math.floor(Math.log10(s||1)),a=[1,2,5,10].map(c=>c*o).find(
c=>c>=s)??10*o;n&&(a=Math.max(1,Math.round(a)));let i=Math.ceil(r/a-1e-9),l=Math.floor(e/a+1e-9);return Array.from({length:Math.max(0,l-i+1)},(c,d)=>(i+d)*a)}var Qr={right:12,top:10,bottom:42},Zt={x:56,y:34,letter:8,label:30};function V(r,e,t,n){let{top:s}=Qr,o=Math.max(s+40,e-Qr.bottom),a=pt(n.low,n.high,(o-s)/Zt.y,
n.whole),i=Zt.label+Zt.letter*Math.max(2,...a.map(g=>en(g).length)),l=Math.max(i+40,r-Qr.right),c=(g,b,v)=>x=>b+(x-g.low)/(g.high-g.low||1)*(v-b),d=c(t,i,l),m=c(
n,o,s),h=w("g"),p=w("svg",{width:r,height:e,viewBox:`0 0 ${r} ${e}`,class:"plot"}),f=w("g",{class:"axes"});for(let g of a)f.append(w("line",{x1:i,x2:l,y1:m(g),y2:m(
g),class:"grid"}),w("text",{x:i-8,y:m(g),"text-anchor":"end","dominant-baseline":"middle"},en(g)));for(let g of pt(t.low,t.high,(l-i)/Zt.x,t.whole))f.append(w("\
text",{x:d(g),y:o+16,"text-anchor":"middle"},en(g)));return f.append(w("line",{x1:i,x2:l,y1:o,y2:o,class:"axis"}),w("text",{x:(i+l)/2,y:e-6,"text-anchor":"middl\
e",class:"label"},t.label),w("text",{transform:`translate(12 ${(s+o)/2}) rotate(-90)`,"text-anchor":"middle",class:"label"},n.label)),p.append(f,h),{root:p,marks:h,
left:i,right:l,top:s,bottom:o,x:d,y:m,at:g=>{let b=g-p.getBoundingClientRect().left;return t.low+(b-i)/(l-i)*(t.high-t.low)}}}var en=r=>String(Number(r.toPrecision(
6))).replace("-","−");function q(r,e,t,n){let s="",o="M";t.forEach((a,i)=>{a===null?o="M":(s+=`${o}${r.x(e[i]).toFixed(1)} ${r.y(a).toFixed(1)}`,o="L")}),r.root.
insertBefore(w("path",{d:s,class:`line ${n}`}),r.marks)}function Mo(r,e,t,n=null){let s=r.x(e);r.marks.append(w("line",{x1:s,x2:s,y1:r.top,y2:r.bottom,class:`mark ${t}`})),n!==null&&r.marks.append(w("circle",{cx:s,cy:r.
y(n),r:5,class:`dot ${t}`}))}function We(...r){return u("p",{class:"legend small"},...r.map(([e,t])=>u("span",{class:`key ${t}`},e)))}function K(r,e,t,n){let s=u(
"div",{class:"chart chooses",role:"img","aria-label":r}),o=null,a=()=>{o?.marks.replaceChildren(),o&&t(o)};s.addEventListener("click",l=>o&&n(o.at(l.clientX),o,
l));let i=()=>{let{clientWidth:l,clientHeight:c}=s;l<50||c<50||(o=e(l,c),s.replaceChildren(o.root),a())};return new ResizeObserver(i).observe(s),{element:s,update:a,
redraw:i}}var ft=[[68,1,84],[72,26,108],[71,47,125],[65,68,135],[57,86,140],[49,104,142],[42,120,142],[35,136,142],[31,152,139],[34,168,132],[53,183,121],[84,197,104],[122,
209,81],[165,219,54],[210,226,27],[253,231,37]];function Jt(r){let e=Math.min(1,Math.max(0,r))*(ft.length-1),t=Math.min(ft.length-2,Math.floor(e)),n=ft[t],s=ft[t+
1],o=a=>Math.round(n[a]+(e-t)*(s[a]-n[a]));return[o(0),o(1),o(2)]}function To(r){let[e,t,n]=Jt(r).map(s=>((s/255+.055)/1.055)**2.4);return .2126*e+.7152*t+.0722*
n>.179?"#000":"#fff"}var Eo=r=>`rgb(${Jt(r).join(" ")})`,Oo=()=>`linear-gradient(to right, ${ft.map(r=>`rgb(${r.join(" ")})`).join(", ")})`;function Ue(r,e,t){let n=devicePixelRatio||1;for(let[a,i]of Object.entries(t))r.style.setProperty(a,`${i}px`);r.width=Math.round(t.width*n),r.height=Math.round(
t.height*n);let s=r.getContext("2d"),o=kl(e);!s||!o||(s.imageSmoothingEnabled=!1,s.drawImage(o,0,0,r.width,r.height))}function kl(r){let[e,t]=r.shape,n=document.
createElement("canvas");n.width=t,n.height=e;let s=n.getContext("2d");if(!s)return null;let o=s.createImageData(t,e);return r.capture_rate.forEach((a,i)=>a.forEach(
(l,c)=>{let d=4*((e-1-i-r.first[0])*t+c+r.first[1]);o.data.set([...Jt(l),255],d)})),s.putImageData(o,0,0),n}function Xt(r,e,t,n=2){r.textContent=R(e,n),r.ariaLabel=
`${t}: ${r.textContent}`,e!==void 0&&(r.style.backgroundColor=Eo(e),r.style.color=To(e))}function re(r,e){let t=u("span",{class:"gradient"});return t.style.backgroundImage=
Oo(),u("p",{class:"scale-of-rates small muted"},r,t,e)}function be(r,e,t=r.length){let n=u("canvas",{role:"img","aria-label":e}),s=u("div",{class:"cells-of-matrix"},n),o=u("figure",{},u("figcaption",{},e),s,u("p",{class:"\
small muted"},u("span",{class:"pursuer"},"↑ pursuers")," ",u("span",{class:"evader"},"evaders →")));return o.draw=()=>{let a=s.clientWidth;a&&Ue(n,{shape:[t,
t],first:[0,0],capture_rate:r},{left:0,top:0,width:a,height:a})},new ResizeObserver(()=>o.draw?.()).observe(s),o}var Co=()=>re("0 all escape","1 all caught"),Ro=({
runs:r})=>u("div",{class:"widget"},u("div",{class:"matrices"},...r.map((e,t)=>be(e.payoff.capture_rate,`Matrix ${"ABC"[t]}`))),Co()),Qt=31,ko=.016;function $o(){
let r=t=>Array.from({length:Qt},(n,s)=>Array.from({length:Qt},(o,a)=>.5+t*(s-a))),e=[[ko,"Both get better"],[-ko,"Both get worse"],[0,"Nothing happens"]];return u(
"div",{class:"widget"},u("div",{class:"matrices"},...e.map(([t,n])=>be(r(t),n))),Co())}function Po(){let r=Array.from({length:Qt},(t,n)=>n),e=K("A capture rate \
that stays at one half from generation 0 to 30",(t,n)=>{let s=V(t,n,{low:0,high:Qt-1,label:"generation",whole:!0},{low:0,high:1,label:"capture rate"});return q(
s,r,r.map(()=>.5),"of-both"),s},()=>{},()=>{});return u("div",{class:"widget"},e.element)}var Y=32,_o=({crossings:r=[]})=>u("div",{class:"widget crossings"},...r.
map(e=>u("figure",{},u("figcaption",{},e.title),Cl(e),u("p",{class:"small muted"},e.text))));function Cl({title:r,text:e,ways:t}){let n=[0,1,2,3].map(s=>`M${s*Y}\
 0V${3*Y}M0 ${s*Y}H${3*Y}`).join("");return w("svg",{viewBox:`-1 -1 ${3*Y+2} ${3*Y+2}`,role:"img","aria-label":`${r}: ${e}`},w("path",{class:"grid",d:n}),...t.map(
([s,o,a],i)=>w("g",{transform:`translate(${1.5*Y} ${1.5*Y})`},w("g",{transform:`translate(${-Y*o} ${-Y*s})`},w("path",{class:"filled-pursuer",d:"M0 -12 12 9H-12\
z"}),w("text",{y:6.5,"text-anchor":"middle"},`P${i}`)),w("path",{class:a?"goes":"waits",d:a?"M-18 0H-5M-9 -4 -4 0 -9 4":"M-16 -13V13",transform:`rotate(${Math.atan2(
s,o)*180/Math.PI})`}))))}function we(r,e,t,n,s){let o=u("input",{type:"range",min:0,max:e.length-1,step:1,"aria-label":r,oninput:()=>s(i())}),a=u("output",{class:"numbers"}),i=()=>{let l=e[Number(
o.value)];return a.textContent=o.ariaValueText=n(l),l};return o.value=String(e.indexOf(t)),i(),u("label",{class:"slider"},u("span",{},r),o,a)}function Lo(r,e,t){
return u("label",{class:"slider"},u("span",{},r),Ns(e.map(n=>[n,n]),t))}function ue(r){let e=r>>>0;return()=>{e=e+1831565813>>>0;let t=Math.imul(e^e>>>15,e|1);return t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/2**32}}var rn=["rock",
"paper","scissors"],nn=[[.5,0,1],[1,.5,0],[0,1,.5]],Rl=1e-9,Fo=r=>nn.map(e=>e.reduce((t,n,s)=>t+n*r[s],0));function sn(r,e){let t=r.slice(-e);return rn.map((n,s)=>t.
filter(o=>o===s).length/t.length)}var on=r=>Math.max(...Fo(r));function No(r,e,t){let n=Fo(sn(r,e)),s=n.flatMap((o,a)=>o>Math.max(...n)-Rl?[a]:[]);return s[s.length>
1?Math.floor(t()*s.length):0]}function tr(r,e,t){let n={pursuers:[0],evaders:[0]};for(let s=1;s<=r;s++)n.pursuers.push(No(n.evaders,e,t)),n.evaders.push(No(n.pursuers,
e,t));return n}var gt=100,rr={scalar:{dimensions:1,greatest:!0},focusing:{dimensions:10,greatest:!0},intransitive:{dimensions:2,greatest:!1}};function tn(r,e,t){
let{greatest:n}=rr[r],s=e[0]-t[0];for(let o=1;o<e.length;o++){let a=e[o]-t[o];(n?Math.abs(a)>Math.abs(s):Math.abs(a)<Math.abs(s))&&(s=a)}return(1+Math.sign(s))/
2}var an=(r,e,t)=>e.reduce((n,s)=>n+t.reduce((o,a)=>o+tn(r,s,a),0),0)/(e.length*t.length),ze={population:25,mutation:.005,opponents:15,hall:0},He=class{game;settings;generation=0;#e;#r;#t=[
[],[]];constructor(e,t,n){this.game=e,this.settings=t,this.#e=n;let s=()=>Array.from({length:t.population},()=>new Uint8Array(gt));this.#r=[s(),s()]}ones(e){let{
dimensions:t}=rr[this.game],n=gt/t;return this.#r[e].map(s=>Array.from({length:t},(o,a)=>er(s.subarray(a*n,(a+1)*n))))}objective=e=>er(this.#r[e].map(er))/this.
settings.population;step(){let e=[this.ones(0),this.ones(1)],t=this.#n(e);for(let n of[0,1]){this.#t[n].push(e[n][t[n].indexOf(Math.max(...t[n]))]);let s=this.#s(
t[n]);this.#r[n]=s.map(o=>this.#a(this.#r[n][o]))}this.generation++}#n(e){let{population:t,opponents:n,hall:s}=this.settings,o=[new Array(t).fill(0),new Array(t).
fill(0)];for(let a=0;a<n;a++)Io(t,this.#e).forEach((i,l)=>{let c=tn(this.game,e[0][l],e[1][i]);o[0][l]+=+(c===1),o[1][i]+=+(c===0)});for(let a of[0,1]){let i=this.#t[1-
a];for(let l of Io(i.length,this.#e,s))e[a].forEach((c,d)=>o[a][d]+=+(tn(this.game,c,i[l])===1))}return o}#a(e){let t=e.slice();for(let n=0;n<t.length;n++)this.#e()<
this.settings.mutation&&(t[n]^=1);return t}#s(e){let t=er(e),n=t?e:e.map(()=>1);return e.map(()=>{let s=this.#e()*(t||e.length),o=n.findIndex(a=>(s-=a)<0);return o<
0?e.length-1:o})}};function Io(r,e,t=r){let n=Array.from({length:r},(o,a)=>a),s=Math.min(t,r);for(let o=0;o<s;o++){let a=o+Math.floor(e()*(r-o));[n[o],n[a]]=[n[a],
n[o]]}return n.slice(0,s)}function er(r){let e=0;for(let t=0;t<r.length;t++)e+=r[t];return e}var ln=1,nr=["pursuers","evaders"],Uo=[[150,42],[266,232],[34,232]],$l={pursuers:-7,evaders:7},Do=r=>[0,1].map(e=>r.reduce((t,n,s)=>t+n*Uo[s][e],0)),Wo=(r,e)=>r.
map((t,n)=>sn(r.slice(0,n+1),e));function Ho({memories:r=[1],memory:e=r[0],generations:t=30}){let n=new ce(t,{speed:t>100?16:2,still:le()}),s=e,o=tr(t,s,ue(ln)),
a={pursuers:[],evaders:[]},i={pursuers:w("polyline",{class:"way of-pursuers"}),evaders:w("polyline",{class:"way of-evaders"})},l={pursuers:w("path",{class:"fill\
ed-pursuer",d:"M0 -11 11 9H-11z"}),evaders:w("circle",{class:"filled-evader",r:9})},c=w("svg",{viewBox:"0 0 300 270",class:"hands-triangle",role:"img","aria-lab\
el":"The shares of rock, paper and scissors among the remembered hands of both teams"},w("polygon",{class:"frame",points:Uo.map(g=>g.join()).join(" ")}),w("circ\
le",{class:"middle",cx:150,cy:168.7,r:4}),w("text",{x:150,y:192,"text-anchor":"middle"},"one third each"),w("text",{class:"label",x:150,y:18,"text-anchor":"midd\
le"},"rock"),w("text",{class:"label",x:266,y:262,"text-anchor":"middle"},"paper"),w("text",{class:"label",x:34,y:262,"text-anchor":"middle"},"scissors"),...nr.map(
g=>i[g]),...nr.map(g=>l[g])),d=u("p",{class:"numbers"}),m=K("What the best answer wins against the remembered hands, by generation",(g,b)=>{let v=V(g,b,{low:0,high:t,
label:"generation",whole:!0},{low:.4,high:1,label:"best answer wins"});q(v,[0,t],[.5,.5],"half");for(let x of nr)q(v,o[x].map((M,T)=>T),a[x].map(on),`of-${x}`);
return v},g=>Mo(g,n.step,"of-both"),g=>n.jump(g)),h=()=>{let g=n.step;for(let v of nr){i[v].setAttribute("points",a[v].slice(0,g+1).map(T=>Do(T).map(_=>_.toFixed(
1)).join()).join(" "));let[x,M]=Do(a[v][g]);l[v].setAttribute("transform",`translate(${x+$l[v]} ${M})`)}let b=v=>u("span",{class:v.slice(0,-1)},`${v} show ${rn[o[v][g]]}`);
d.replaceChildren(`Generation ${g}: `,b("pursuers"),", ",b("evaders"),".",...r.length>1?[` The best answer to the remembered hands of the pursuers wins ${R(on(a.
pursuers[g]))}.`]:[]),m.update()},p=()=>{o=tr(t,s,ue(ln)),a={pursuers:Wo(o.pursuers,s),evaders:Wo(o.evaders,s)},m.redraw(),h()};n.addEventListener("step",h),p();
let f=r.at(-1),y=we("memory (hands)",r,e,g=>g===f?"all":String(g),g=>{s=g,p()});return u("div",{class:"widget"},r.length>1&&y,u("div",{class:"two"},u("div",{},c),
r.length>1&&u("div",{},We(["pursuers' hands","of-pursuers"],["evaders' hands","of-evaders"]),m.element)),d,Fe(n))}function zo({generations:r=30}){let{pursuers:e,
evaders:t}=tr(r,1,ue(ln)),n=e.map(o=>t.map(a=>nn[o][a])),s=n.at(-1);return u("div",{class:"widget"},u("div",{class:"matrices"},be(n,`The last pursuers score ${R(
s.reduce((o,a)=>o+a,0)/s.length)} against all evaders.`)),re("0 loses","1 wins"))}var yt=600,Ge=20,cn=5,vt=10,un={"Game A":"intransitive","Game B":"scalar","Game C":"focusing"},Bo={low:0,high:yt,label:"generation",whole:!0},jo={low:0,high:gt,
label:"ones of side 1"},xe=()=>{},Pl=()=>new Promise(r=>setTimeout(r));async function dn(r,e,t){for(e();r.generation<yt&&t();e()){for(let n=0;n<Ge;n++)r.step();
await Pl()}}var sr=new Map,Vo=[];async function _l(){for(let r of Object.keys(un))sr.set(r,[]);for(let r=0;r<cn;r++)for(let[e,t]of Object.entries(un)){let n={score:[],
ones:[]};sr.get(e).push(n);let s=new He(t,ze,ue(r));await dn(s,()=>{n.score.push(an(t,s.ones(0),s.ones(1))),n.ones.push(s.objective(0))},()=>!0),Vo.forEach(o=>o())}}
function qo({shows:r="score"}){sr.size||_l();let e=r==="score"?{low:0,high:1,label:"score of side 1"}:jo,t=Object.entries(un).map(([n,s])=>{let o=r==="score"?n:
`${n}: ${s}`,a=K(`${o}: ${e.label} in ${cn} races`,(i,l)=>{let c=V(i,l,Bo,e);for(let d of sr.get(n))q(c,d[r].map((m,h)=>h*Ge),d[r],"of-both dense");return c},xe,
xe);return Vo.push(a.redraw),u("figure",{},u("figcaption",{},o),a.element)});return u("div",{class:"widget"},u("div",{class:"matrices"},...t),u("p",{class:"smal\
l muted"},`Each line is a race; there are ${cn} of each game, played now, in this page.`))}var Ll=[5,10,15,25,40,60],Nl=[5e-4,.001,.002,.005,.01,.02,.05],Il=[0,
1,5,15,30],Go=15,Fl=Array.from({length:20},(r,e)=>e);function Ko({hall:r=!1}){let e="scalar",t=0,n={...ze,hall:r?Go:0},s=0,o=v=>{n={...n,...v}},a=[[],[]],i=[be(
a[0],"Score of side 1",yt/Ge+1),be(a[1],"Score of side 2",yt/Ge+1)];i.forEach(v=>v.querySelector("p").replaceChildren(`↑ generation, → opponent (${Ge} a cel\
l)`));let l=[[],[]],c=K("Ones of both sides by generation",(v,x)=>{let M=V(v,x,Bo,{...jo,label:"ones"});return l.forEach((T,_)=>q(M,T.map((J,W)=>W*Ge),T,_?"of-e\
vaders":"of-pursuers")),M},xe,xe),d=u("p",{class:"numbers",role:"status"}),m=v=>{d.textContent=v},h=async()=>{let v=++s;for(let T of[...a,...l])T.length=0;let x=[
[],[]],M=new He(e,n,ue(t));await dn(M,()=>{for(let T of[0,1])x[T].push(M.ones(T)),l[T].push(M.objective(T));for(let T of[0,1])a[T].push(x[1-T].map(_=>an(M.game,
x[T].at(-1),_)));i.forEach(T=>T.draw?.()),c.redraw()},()=>s===v),s===v&&m(`${te(M.game)} game, seed ${t}: after ${yt} generations side 1 has ${l[0].at(-1).toFixed(
0)} ones, side 2 ${l[1].at(-1).toFixed(0)}.`)},p=[],f=K("Ones of side 1 at the end of ten races, a row for each choice of settings",(v,x)=>Dl(p,v,x),xe,xe);f.element.
classList.add("dots");let y=async v=>{let x=++s,M=[],{population:T,mutation:_}=v,J=`${e}${T===ze.population?"":`, ${T} players`}${_===ze.mutation?"":`, mutation\
 ${_}`}, hall ${v.hall}`;p=[...p.filter(W=>W.ends.length===vt&&W.text!==J).slice(1-mn),{text:J,ends:M}];for(let W=0;W<vt&&s===x;W++){let ne=new He(e,v,ue(W));await dn(
ne,xe,()=>s===x),s===x&&M.push(ne.objective(0)),f.redraw()}s===x&&m(`${te(J)}: side 1 ends with ${Yo(M)} ones in the mean of ${vt} races.`)},g=(v,x,M="")=>u("bu\
tton",{type:"button",class:M,onclick:()=>{v()}},x),b=u("div",{class:"sliders"},Lo("game",Object.keys(rr),v=>e=v),we("population",Ll,n.population,String,v=>o({population:v})),
we("mutation",Nl,n.mutation,String,v=>o({mutation:v})),...r?[we("hall of fame",Il,Go,String,v=>o({hall:v}))]:[we("seed",Fl,0,String,v=>t=v)]);return r?(y(ze).then(
()=>s===1?y(n):void 0),u("div",{class:"widget"},b,u("div",{class:"buttons"},g(()=>y(n),"Play ten races","primary")),d,f.element)):u("div",{class:"widget"},b,u("\
div",{class:"buttons"},g(h,"Play a race","primary"),g(async()=>{s++},"Stop")),u("div",{class:"matrices"},...i,u("figure",{},u("figcaption",{},"The truth: ones"),
We(["side 1","of-pursuers"],["side 2","of-evaders"]),c.element)),re("0 loses","1 wins"),d)}var mn=6,Yo=r=>(r.reduce((e,t)=>e+t,0)/r.length).toFixed(1);function Dl(r,e,t){
let n=V(e,t,{low:0,high:gt,label:"ones of side 1 at the end",whole:!0},{low:0,high:mn,label:""});return n.root.querySelectorAll(".axes .grid, .axes [text-anchor\
=end]").forEach(s=>s.remove()),r.forEach(({text:s,ends:o},a)=>{let i=n.y(mn-a-.7);n.marks.before(w("text",{class:"label",x:n.left,y:i-12},`${s}: ${o.length<vt?`${o.
length} of ${vt} races`:`mean ${Yo(o)}`}`)),o.forEach(l=>n.marks.before(w("circle",{class:"dot of-both",cx:n.x(l),cy:i,r:5})))}),n}var Jo=r=>r.answer===void 0?Ul():Wl(r,r.answer);function Wl(r,e){let t=u("input",{type:"text",inputmode:"decimal",size:8,"aria-label":"Your answer, a number",autocomplete:"\
off"});return{input:t,check:()=>{let s=t.value.trim().replace(",","."),o=Number(s);if(s===""||Number.isNaN(o))return"Expected a number, such as 0.5.";let a=i=>Math.
abs(o-i)<=(r.tolerance??0)+1e-9;return a(e)?null:r.clues?.find(([i])=>a(i))?.[1]??r.otherwise??"Expected another number."},answer:()=>t.value,set:s=>t.value=s}}
var G=4,hn=[.5,.8,.2];function Ul(){let r=new Array(G*G).fill(.5),e=(l,c)=>Xt(l,r[c],`generation ${Math.floor(c/G)} of the pursuers against generation ${c%G} of\
 the evaders`,1),t=r.map((l,c)=>{let d=u("button",{type:"button",disabled:c%(G+1)===0,onclick:()=>{r[c]=hn[(hn.indexOf(r[c])+1)%hn.length],e(d,c)}});return e(d,
c),d}),n=Array.from({length:G},(l,c)=>c),s=u("div",{class:"cells numbers",role:"group","aria-label":"Capture rates: rows are pursuers, columns evaders"},u("span"),
u("span",{class:"evader all"},"generation of the evaders"),u("span",{class:"pursuer"},"generation of the pursuers"),...n.map(l=>u("span",{class:"evader"},l)),...n.
flatMap(l=>[u("span",{class:"pursuer"},l),...t.slice(l*G,(l+1)*G)])),o=l=>n.map(c=>n.reduce((d,m)=>d+r[l(c,m)],0)/G);return{input:s,check:()=>{let l=o((m,h)=>m*
G+h),c=o((m,h)=>h*G+m),d=(m,h)=>m.every((p,f)=>!f||h*(p-m[f-1])>1e-9);return d(l,1)?d(c,-1)?null:`The means of the columns are ${Zo(c)}. They say how often the \
evaders are captured, and should fall from column to column.`:`The means of the rows are ${Zo(l)}. They are the strengths of the pursuers, and should grow from \
row to row.`},answer:()=>r.join(" "),set:l=>{l.split(" ").forEach((c,d)=>r[d]=Number(c)),t.forEach(e)}}}var Zo=r=>r.map(e=>e.toFixed(2)).join(", ");var bt=r=>r.trim().split(/\n\s*\n/).map(e=>u("p",{},...pn(e))),pn=r=>r.split("**").map((e,t)=>t%2?u("strong",{},e):document.createTextNode(e));function Xo(r,e){
let{predict:t,options:n}=r,s=u("p",{class:"small muted",role:"status"}),o=u("button",{type:"submit",class:"primary"},"This is my prediction"),a=Object.keys(n).map(
c=>u("input",{type:"radio",name:`prediction-${t}`,value:c})),i=u("form",{class:"prediction",id:`prediction-${t}`},u("fieldset",{},u("legend",{},u("strong",{},"P\
redict. "),r.question),...a.map(c=>u("label",{class:"option"},c,u("span",{},n[c.value])))),u("div",{class:"buttons"},o,s)),l=()=>{let c=e.choice(t);if(c!==void 0){
for(let d of a)d.checked=d.value===c,d.disabled=!0;o.hidden=o.disabled=!0,s.replaceChildren(),i.append(r.later?u("p",{class:"reply"},r.later):Hl(r,c,r.again&&e.
choice(r.again)))}};return i.addEventListener("submit",c=>{c.preventDefault();let d=a.find(m=>m.checked);d?(e.choose(t,d.value),l()):s.textContent="Choose one f\
irst. Any prediction is a good one."}),l(),i}function Hl(r,e,t){let{options:n,outcome:s}=r,o=e===s;return u("div",{class:"reply",role:"status","data-right":String(
o)},t&&u("p",{},u("strong",{},"At the beginning you predicted: "),n[t]),u("p",{},u("strong",{},o?"✓ As you predicted: ":"You predicted: "),n[e]),o?null:u("p",
{},u("strong",{},"The outcome: "),n[s]),...bt(r.explanation??""),r.note&&u("p",{class:"small muted"},r.note))}function Qo(r,e){let{input:t,check:n,answer:s,set:o}=Jo(
r),a=u("p",{class:"reply",role:"status",hidden:!0}),i=d=>{a.hidden=!1,a.dataset.right=String(d===null),a.replaceChildren(u("strong",{},d===null?"✓ Right. ":"✗\
 Not yet. "),d??r.explanation)},l=u("form",{class:"exercise",id:`exercise-${r.exercise}`},u("div",{class:"text"},u("p",{},u("strong",{},"Exercise. "),...pn(r.question))),
r.matrix&&zl(r.matrix),u("div",{class:"buttons"},t,u("button",{type:"submit"},"Check")),a);l.addEventListener("submit",d=>{d.preventDefault();let m=n();m===null&&
e.solve(r.exercise,s()),i(m)});let c=e.solved(r.exercise);return c!==void 0&&(o(c),i(null)),l}function zl(r){let e=r.map((t,n)=>n);return u("div",{class:"wide-t\
able",tabindex:0},u("table",{class:"rates numbers"},u("thead",{},u("tr",{},u("td"),u("th",{scope:"colgroup",colspan:e.length,class:"evader"},"generation of the \
evaders")),u("tr",{},u("th",{class:"pursuer"},"generation of the pursuers"),...e.map(t=>u("th",{scope:"col"},t)))),u("tbody",{},...r.map((t,n)=>u("tr",{},u("th",
{scope:"row"},n),...t.map(s=>u("td",{},s.toFixed(1))))))))}var Gl=40;function ea({question:r="",points:e=[]},t){let n=u("textarea",{id:"exit-answer",rows:8,oninput:()=>{
t.exit={exit:n.value},s.textContent=n.value}}),s=u("p",{class:"printed"}),o=u("p",{class:"small muted",role:"status"}),a=u("button",{type:"submit",class:"primar\
y"},"I am done"),i=u("form",{class:"exercise"},u("label",{for:"exit-answer"},u("strong",{},"Exit question. "),r),n,s,u("div",{class:"buttons"},a,u("button",{type:"\
button",onclick:()=>It("exit_answer.txt",`${r}

${n.value}
`)},"Save my answer"),o)),l=()=>{s.textContent=t.exit.exit,t.exit.done&&(n.readOnly=!0,a.hidden=!0,i.append(u("div",{class:"reply"},u("p",{},u("strong",{},"A go\
od answer has:")),u("ul",{},...e.map(c=>u("li",{},...pn(c)))))))};return n.value=t.exit.exit,i.addEventListener("submit",c=>{if(c.preventDefault(),n.value.trim().
length<Gl){o.textContent="Write two explanations and an experiment first. Then the page shows what a good answer has.";return}o.textContent="",t.exit={done:!0},
l()}),l(),u("div",{class:"widget"},i)}var Bl=Array.from({length:16},(r,e)=>{let t=e%2?6.5:11,n=Math.PI*e/8;return`${12+t*Math.sin(n)} ${12-t*Math.cos(n)}`}).join(" ");function or(){let r=[["pursuer",
w("path",{d:"M12 3 22 20H2z",class:"filled-pursuer"})],["evader",w("circle",{cx:12,cy:12,r:9,class:"filled-evader"})],["capture",w("polygon",{points:Bl,class:"f\
illed-capture"})],["captured evader",w("circle",{cx:12,cy:12,r:7.5,class:"ring-evader"})],["conflict",w("rect",{x:3,y:3,width:18,height:18,class:"dashed-conflic\
t"})]];return u("ul",{class:"shapes small","aria-label":"Shapes on the board"},...r.map(([e,t])=>u("li",{},w("svg",{viewBox:"0 0 24 24","aria-hidden":"true"},t),
e)))}function jl(r,e,t){let{rows:n,cols:s,n_pursuers:o,fov:a,rules:{interaction:i}}=r;return{rows:n,cols:s,nPursuers:o,fov:a,interaction:i,obstacles:e,moments:t}}function ar(r){let e=Array.from({length:r.length+1},(t,n)=>Vl(r,n));return jl(r.config,r.map,e)}function Vl(r,e){let t=r.n_agents,n=r.config.n_evaders,s=(a,i,l)=>a.
subarray(i*l,(i+1)*l),o={positions:s(r.last_positions,e,2*t),alive:s(r.alive,e,t),captured:s(r.captured,e,n),everCaptured:s(r.ever_captured,e,n)};return e===0?o:
{...o,actions:s(r.actions,e-1,t),involved:s(r.involved,e-1,3*t),fault:s(r.fault,e-1,3*t),get contested(){return r.conflicts(e).map(a=>a.cell)}}}var ql=8,Kl=900,ta=1800,Se=class extends EventTarget{element;player=new ce(0,{speed:ql,still:le()});match=null;agent=null;#e=u("figcaption");#r=u("canvas",{onclick:({
clientX:e,clientY:t})=>this.#u(e,t)});#t;#n=u("p",{class:"small muted numbers"});#a=u("p",{class:"small",role:"status"});#s=null;#l=!1;constructor(){super(),this.#t=
new Ie(this.#r,{numbers:!1}),this.element=u("figure",{class:"chase"},this.#e,this.#r,this.#n,this.#a),this.player.addEventListener("frame",()=>this.#c()),this.player.
addEventListener("step",()=>this.#d()),this.player.addEventListener("state",()=>this.over&&this.dispatchEvent(new Event("over")))}get over(){return this.player.
length>0&&!this.player.playing&&this.player.step===this.player.length}get title(){return this.#e.textContent}get recording(){return this.#s}show(e,t){this.match=
e,this.#s=ar(e),this.#e.textContent=t,this.#r.ariaLabel=`A match. ${t}`,this.player.jump(0),this.player.length=e.length,this.player.marks=zt(this.#s),this.#d()}choose(e){
this.agent=e,this.#t.look={selected:e,viewers:e===null?[]:[e]},this.dispatchEvent(new Event("agent"))}#u(e,t){this.#l||this.choose(this.#t.agentAt(e,t))}#c(){this.#s&&
this.#t.show(this.#s,this.player.time)}#d(){let e=this.#s?.moments[this.player.step]?.everCaptured;e&&(this.#n.textContent=`${Array.from(e).filter(Boolean).length}\
 of ${e.length} caught in ${this.player.step} steps`),this.dispatchEvent(new Event("step"))}drawWalls(e){let t=!1,n=!0,s=[0,0],o=([l,c])=>!!this.#s?.obstacles[l*
this.#s.cols+c],a=(l,c)=>{this.#a.textContent=e(l,c)},i=l=>{let c=this.#t.cellAt(l.clientX,l.clientY);c&&o(c)!==n&&a(c,n)};return this.#r.addEventListener("poin\
terdown",l=>{let c=t&&this.#t.cellAt(l.clientX,l.clientY);c&&(this.#r.setPointerCapture(l.pointerId),n=!o(c),i(l))}),this.#r.addEventListener("pointermove",l=>t&&
l.buttons&&i(l)),this.#r.addEventListener("keydown",l=>{let c={ArrowUp:[-1,0],ArrowDown:[1,0],ArrowLeft:[0,-1],ArrowRight:[0,1]}[l.key];if(!t||!this.#s||!(c||l.
key===" "))return;l.preventDefault();let d=(p,f)=>Math.min(f-1,Math.max(0,p)),{rows:m,cols:h}=this.#s;c?s=[d(s[0]+c[0],m),d(s[1]+c[1],h)]:a(s,!o(s)),this.#t.look=
{cursor:s}}),l=>{t=this.#l=l,this.#r.classList.toggle("drawn-on",l),this.#r.tabIndex=l?0:-1,this.#r.setAttribute("role",l?"application":"img"),this.#t.look={cursor:null}}}showWalls(e){
this.#s&&(this.#s={...this.#s,obstacles:e},this.#c())}},Be=class{boards;#e;#r=-1/0;#t=0;#n=!le();constructor(e,...t){this.#e=e,this.boards=t;for(let n of t)n.addEventListener(
"over",()=>this.#n&&t.every(({over:s})=>s)&&this.#a(Kl))}get runs(){return this.#n}set runs(e){this.#n=e,clearTimeout(this.#t),this.#t=0;for(let{player:t}of this.
boards)e?t.play():t.pause()}renew(e=!1){e||performance.now()-this.#r>ta?this.#s():this.#t||this.#a(ta)}#a(e){clearTimeout(this.#t),this.#t=setTimeout(()=>this.#s(),
e)}#s(){if(clearTimeout(this.#t),this.#t=0,this.#r=performance.now(),this.#e(),this.#n)for(let{player:e}of this.boards)e.play()}};function fn(r,e){let t=r.runs;
new IntersectionObserver(([n])=>{n.isIntersecting?t&&!r.runs&&(r.runs=!0):(t=r.runs,r.runs=!1)}).observe(e)}var Ae=["stay","north","east","south","west","northeast","southeast","southwest","northwest"];var ra="champion",na=0,gn=64,yn=100;var Yl=(r,e)=>Object.keys(r).every(t=>r[t]===e[t]);function sa(r,e){return Object.keys(e).find(t=>Yl(e[t],r))??null}function oa(r,e,t){let n=new Set(r);return Array.
from({length:e},(s,o)=>Array.from({length:t},(a,i)=>n.has(o*t+i)?"#":".").join(""))}var ia={"specialist-specialist":"Specialists: both teams meet only the newest opponent","generalist-specialist":"Pursuers meet all earlier evaders, evaders only\
 the newest pursuers","generalist-generalist":"Generalists: both teams meet all earlier opponents","hall-of-fame":"Halls of fame: both teams learn at once, and \
meet earlier champions"};function aa({schedule:r}){if(r.kind==="hall-of-fame")return r.kind;let e={latest:"specialist","round-robin":"generalist",uniform:"unifo\
rm"};return`${e[r.pursuers_meet]}-${e[r.evaders_meet]}`}var ir=r=>ia[aa(r)]??aa(r);var Zl=15;function la(r,e=""){let t=Object.hasOwn(r.worlds,e)?e:Object.keys(r.worlds)[0],{n_pursuers:n,n_evaders:s,fov:o,max_steps:a}=r.worlds[t];return{world:t,schedule:"\
generalist-generalist",beside:"",learner:"es",policy:"rating",seed:0,generations:Zl,way:!1,population:0,pursuers:n,evaders:s,view:o,steps:a,walls:null}}function ca(r,e,t=e.
schedule){let n=r.races[e.policy][e.learner][t],s=r.worlds[e.world],o={...s,n_pursuers:e.pursuers,n_evaders:e.evaders,fov:e.view,max_steps:e.steps,obstacles:e.walls?
oa(e.walls,s.rows,s.cols):s.obstacles},a=e.way?"right-of-way":e.policy==="rating"?"obstacles":"none";return{...n,world:o,train_steps:e.steps,seed:e.seed,policy:{
...n.policy,mask:a},learner:{...n.learner,population:e.population||n.learner.population},schedule:{...n.schedule,generations:e.generations}}}var ua=0,da=1,Jl=2,Xl=176;function ha(r,e,t,n){let s=devicePixelRatio||1,o=qt(r);r.width=r.height=Xl*s;let a=r.getContext("2d");if(!a)return;let{fov:i}=e,l=r.width/
i;a.fillStyle=o.paper,a.fillRect(0,0,r.width,r.height);for(let d=0;t&&d<i*i;d++){let m=(d%i+.5)*l,h=(Math.floor(d/i)+.5)*l,p=y=>!!t[y*i*i+d];p(Jl)&&(a.fillStyle=
o.obstacle,a.fillRect(m-l/2,h-l/2,l,l));let f=p(ua)&&p(da)?l*.18:0;p(ua)&&ma(a,ve,m+f,h+f,l*.74,o.evader),p(da)&&ma(a,jt,m-f,h-f,l*.86,o.pursuer)}a.strokeStyle=
n<e.n_pursuers?o.pursuer:o.evader,a.lineWidth=2*s;let c=Math.floor(i/2)*l;a.strokeRect(c,c,l,l)}function ma(r,e,t,n,s,o){e(r,t,n,s),r.fillStyle=o,r.fill()}var Ql=["stay","↑","→","↓","←","↗","↘","↙","↖"];function pa(r,{inputs:e,ratings:t,refused:n},s,o){let a=r.kind==="rating"&&!r.hidden.length?r.genome:
null,i=f=>a?.[f]??1,l=f=>r.kind==="rating"?i(f)!==0:new RegExp(`\\b${r.inputs[f]}\\b`).test(o),c=[...r.inputs.keys()].filter(l).sort((f,y)=>Math.abs(i(y))-Math.
abs(i(f))),d=f=>`${f===s?"taken":""} ${n[f]?"refused":""}`,m=(f,y)=>u("tr",{class:y.every(g=>g===y[0])?"same":""},f,...Array.from(y,(g,b)=>u("td",{class:d(b)},De(
g)))),h=f=>{let y=r.inputs[f];return u("th",{scope:"row",title:`${a?`weight ${De(i(f))} x `:""}${de[y]}`},y.replaceAll("_"," "))},p=u("table",{class:"why number\
s"},u("thead",{},u("tr",{},u("th",{},a?"term":"input"),...Array.from(t,(f,y)=>u("th",{scope:"col",class:d(y),title:Ae[y],"aria-label":Ae[y]},Ql[y]))),m(u("th",{
scope:"row"},a?"sum":"rating"),t)),u("tbody",{},...c.map(f=>m(h(f),e[f].map(y=>i(f)*y)))));return[...o?[u("p",{class:"expression"},u("code",{},o))]:[],u("div",{
class:"wide-table",tabindex:0,role:"group","aria-label":"How the moves are rated"},p)]}var ec=(r,{pursuer:e,evader:t})=>({pursuers:ae(r,"pursuer",e),evaders:ae(r,"evader",t)}),fa="What it remembers: a number for each unit, from -1 to 1",je=class{element;#e;#r=u(
"canvas",{class:"seen",role:"img"});#t=u("h3");#n=u("p",{class:"small muted"});#a=u("div",{class:"answers"});#s=u("div",{title:fa});#l=null;#u=null;#c=null;#d=null;#f=null;#m=null;#o=null;#h=0;constructor(e){
this.#e=e,this.element=u("div",{class:"inspector","data-open":"false"},u("p",{class:"hint small muted"},"Click an agent, or press A: what it sees, and why it ta\
kes its move."),u("div",{class:"inspected"},this.#r,u("div",{class:"answer"},this.#t,this.#n,this.#s),this.#a))}get agent(){return this.#o}show(e,t,n,s,o=ec(t,s)){
this.#l?.free(),this.#l=e.world(n.config),this.#c!==t&&(this.#u=null,this.#o!==null&&this.choose(null)),this.#c=t,this.#d=n,this.#f=s,this.#m=o}set solution(e){
this.#u=e,this.at(this.#h)}choose(e){this.#o=e,this.element.dataset.open=String(e!==null),this.#e(e),this.at(this.#h)}next(e){let t=this.#d;if(!t)return;let n=this.#o??
(e>0?-1:0);for(let s=0;s<t.n_agents;s++)if(n=(n+e+t.n_agents)%t.n_agents,t.alive[this.#h*t.n_agents+n])return this.choose(n)}at(e){this.#h=e;let t=this.#d,n=this.#l,
s=this.#c,o=this.#f,a=this.#m,i=this.#o;if(!t||!n||!s||!o||!a||i===null)return;let l=i<t.config.n_pursuers?"pursuer":"evader";this.#s.replaceChildren(),this.#t.
replaceChildren(u("span",{class:l},B(i,t.config.n_pursuers))),t.seek(n,e,a);let c=t.actions.subarray(e*t.n_agents,(e+1)*t.n_agents);for(;c.length&&!n.over&&(i<n.
actors[0]||i>=n.actors[1]);)n.playTurn(c);let d=!!(t.alive[e*t.n_agents+i]&&n.read("alive")[i]);ha(this.#r,t.config,d?n.view(i):null,i),this.#r.ariaLabel=`Field\
 of view of ${B(i,t.config.n_pursuers)}: evaders, pursuers and obstacles around it`;let m=c[i]??null;if(!d)return this.#i([],"It is gone.");let h=a[`${l}s`],p=typeof h!=
"string"&&h.kind==="cells"?n.answer(h,i):null,f=p?.probabilities??null;p?.memory.length&&this.#s.replaceChildren(u("p",{class:"small muted"},"It remembers:"),sc(
p.memory));let y=typeof h!="string"&&h.kind!=="cells"?pa(h,n.rate(h,i),m,bs(s,l,o[l])):[],g=this.#u?.game(n)??null,b=[["network",f],["perfect",g?.marginal(i)??null]],
v=x=>u("p",{class:"small muted"},x);this.#i([...g?[v(`Value ${g.value.toFixed(2)} under perfect play.`)]:[],...rc(b,m),...y],m===null?"The episode is over.":tc(
h,m))}#i(e,t){this.#a.replaceChildren(...e),this.#n.textContent=t}};function tc(r,e){return typeof r=="string"?`The script "${r}" plays for it; it goes ${Ae[e]}\
.`:r.kind!=="cells"?"It takes the best move that its mask allows; of equal ones any.":r.sampled?"Its action is drawn from these probabilities.":"It takes the mo\
st probable action."}function rc(r,e){let t=r.filter(([,o])=>o);if(!t.length)return[];let n=u("div",{class:"action muted"},u("span"),...t.map(([o])=>u("span",{class:"\
head"},o))),s=Array.from(t[0][1],(o,a)=>u("div",{class:a===e?"action taken":"action"},u("span",{},Ae[a]),...t.flatMap(([,i])=>nc(i[a]))));return t.length>1||t[0][0]!==
r[0][0]?[n,...s]:s}function nc(r){let e=u("span",{class:"filled"});return e.style.width=`${100*r}%`,[u("span",{class:"track"},e),u("span",{class:"numbers"},r.toFixed(
2))]}function sc(r){let e=Array.from(r,t=>{let n=u("span",{title:t.toFixed(2)});return n.style.transform=`scaleY(${t})`,n});return u("div",{class:"units",role:"\
img","aria-label":fa},...e)}var oc=40,lr=class{element;#e;#r=u("div",{class:"episodes",role:"group","aria-label":"Episodes of this cell"});#t=u("p",{class:"check small numbers","aria-live":"\
polite"});constructor(e){this.#e=e,this.element=u("div",{class:"strip-of-episodes"},this.#r,this.#t)}show(e,t){let{pursuer:n,evader:s,episode:o,seed:a}=this.#e.
selected,i=ie(e,n,s);this.#r.replaceChildren(...(i?.rates??[]).slice(0,oc).map((h,p)=>this.#n(h,p)));let l=a===null?i?.rates[o]:void 0,c=t.statistics.capture_rate,
d=l!==void 0&&Math.abs(c-l)<1e-6&&t.length===i?.lengths[o],m=i?"Not an episode of the evaluation":"The evaluation played no episodes of this pair.";this.#t.dataset.
equal=String(d),this.#t.textContent=d?"As in the evaluation":l===void 0?m:`Episode ${o+1} differs from the evaluation.`,this.#t.title=`Played here: capture rate\
 ${R(c,3)} in ${t.length} steps.${i?` The cell says ${R(i.rate,3)}.`:""}`}#n(e,t){let{selected:n}=this.#e,s=u("span",{class:"bar"});return s.style.height=`${Math.
round(100*e)}%`,u("button",{type:"button",class:"episode",title:`Episode ${t+1}: capture rate ${R(e)}`,"aria-label":`Episode ${t+1}, capture rate ${R(e)}`,"aria\
-pressed":String(t===n.episode&&n.seed===null),onclick:()=>this.#e.select({episode:t,seed:null})},s,u("span",{class:"count"},t+1))}};var ac=200;function ga(r,e,{pursuer:t,evader:n},s){let{text:o,image:a}=e.shows[`${t} ${n}`]??{},i=ie(r,t,n)?.rates??[],l=`Scores of the ${e.teams[0]} in ${i.length}\
 episodes: ${i.map(c=>R(c)).join(", ")}`;return[o===void 0?null:u("pre",{tabindex:0,"aria-label":"What the game shows of this pair"},o),a===void 0?null:u("img",
{src:a,alt:"What the game shows of this pair",onload:({target:c})=>c.classList.toggle("pixels",c.naturalWidth<ac)}),...(o??a)===void 0?[u("p",{class:"muted"},e.
missing),ic(r,e,t,n,s)]:[],i.length>1?u("p",{class:"small numbers"},l):null].filter(c=>c!==null)}function ic(r,e,t,n,s){let o=Object.keys(e.shows).map(d=>d.split(
" ").map(Number)),a=([d,m])=>(d-t)**2+(m-n)**2,[i,l]=o.sort((d,m)=>a(d)-a(m))[0]??[];if(i===void 0||l===void 0)return null;let c=`${L(r,"pursuer",i)} against ${L(
r,"evader",l)}`;return u("p",{},u("button",{type:"button",onclick:()=>s.select({pursuer:i,evader:l})},`Nearest: ${c}`))}function ya(r){let e=JSON.stringify(r,(t,n)=>t==="genome"?Array.from(n):n);return u("script",{type:"application/json",id:"champions"},e.replaceAll("<","\\u003c")).
outerHTML}var wt="_",lc="n",Vh=2n**64n-1n;var vn={fov:11,maxSteps:500,rewards:"paper"},cc=["rules","others","rewards","size","diagonal","fov","limit","seed","ended","walls","pursuers","evaders","played",
"next"];function wa(r,e){let t=i=>i.map(l=>dc(l,e)).join(""),n=i=>`${Math.floor(i/r.cols)}.${i%r.cols}`,s=uc(r.rewards,e),o=[r.seed,r.episode,r.steps].join("."),a={rules:ba(
r.rules,e),others:r.others?ba(r.others,e):"",rewards:s===vn.rewards?"":s,size:`${r.rows}x${r.cols}`,diagonal:r.diagonal?"1":"",fov:r.fov===vn.fov?"":String(r.fov),
limit:r.maxSteps===vn.maxSteps?"":String(r.maxSteps),seed:o==="0.0.0"?"":o,ended:r.ended?"1":"",walls:r.walls.map(n).join(wt),pursuers:r.pursuers.map(va).join(wt),
evaders:r.evaders.map(va).join(wt),played:r.played.map(t).join(wt),next:r.next.every(i=>i===na)?"":t(r.next)};return cc.filter(i=>a[i]).map(i=>`${i}=${a[i]}`).join(
"&")}function va({cell:r,gone:e,captured:t,everCaptured:n}){let s=t?"c":n?"e":"";return`${r[0]}.${r[1]}${s}${e?"x":""}`}function ba(r,e){let t=e.fields.map(({name:n})=>String(
r[n]).toLowerCase());return sa(r,e.variants)??t.join(".")}function uc(r,e){let t=JSON.stringify(r);return Object.keys(e.rewards).find(s=>JSON.stringify(e.rewards[s])===
t)??Object.values(r).map(s=>String(s)).join(wt)}function dc(r,e){if(typeof r=="number")return String(r);if(r===ra)return lc;let t=e.scripts.findIndex(({name:n})=>n===
r);return String.fromCharCode(97+t)}var mc="/* the engine */";function xa(r,e){return u("button",{type:"button",class:"to-playground",title:"Open this step in the playground (G): the same agents a\
nd actions under any rules",onclick:()=>hc(r(),e)},"What if?")}function hc(r,e){let t=r!==null&&r.match.n_agents<=yn&&Math.max(r.match.config.rows,r.match.config.
cols)<=gn,n=t?u("script",{type:"text/plain",id:"scene"},wa(pc(r.match,r.step),e)).outerHTML:"",s=new TextDecoder().decode(Nr("playground")).replace(mc,()=>Q("sc\
ript-engine")).replace("</noscript>",i=>i+n+(t?ya(r.champions):"")),o=u("iframe",{title:"Playground",srcdoc:s}),a=u("dialog",{class:"what-if","aria-label":"What\
 if?",onclose:()=>a.remove()},u("button",{type:"button",class:"leave",onclick:()=>a.close()},"Back to the match"),o);document.body.append(a),a.showModal()}function pc(r,e){
let{config:t,n_agents:n}=r,s=Math.max(0,e-1),o=i=>{let l=s*n+i,c=s*t.n_evaders+i-t.n_pursuers,d=m=>i>=t.n_pursuers&&!!m[c];return{cell:[r.last_positions[2*l],r.
last_positions[2*l+1]],gone:!r.alive[l],captured:d(r.captured),everCaptured:d(r.ever_captured)}},a=Array.from({length:n},(i,l)=>o(l));return{rules:t.rules,others:null,
rewards:t.rewards,rows:t.rows,cols:t.cols,diagonal:t.diagonal,fov:t.fov,maxSteps:t.max_steps,seed:r.seed,episode:BigInt(r.episode),steps:s,ended:s===r.length,walls:Array.
from(r.map.keys()).filter(i=>r.map[i]),pursuers:a.slice(0,t.n_pursuers),evaders:a.slice(t.n_pursuers),played:[],next:Array.from(r.actions.subarray(s*n,(s+1)*n))}}var fc=.005,gc=.05,yc=4,Ve=new Map;function Aa(r,e,t="capture-rate"){let n=JSON.stringify([{...e,rewards:null},t]),s=Ve.get(n)??(os(e)?Promise.resolve(null):vc(
r,e,t));return Ve.delete(n),Ve.set(n,s),Ve.size>yc&&Ve.delete([...Ve.keys()][0]),s}var Sa=()=>new Promise(r=>setTimeout(r));async function vc(r,e,t){await Sa();let n=r.solution(e,t);for(;n.goBack();)await Sa();return n}function Ma(r,e,t){let{payoff:n}=r;
return t.flatMap((s,o)=>{let a=[0,0];for(let l=e.n_turns;l>0&&!e.over;l--)r.game(e)?.lost(s).forEach((c,d)=>a[d]+=c),e.playTurn(s);let i=n==="capture-rate"?fc:gc;
return S.map((l,c)=>({step:o+1,team:l,lost:a[c],payoff:n})).filter(l=>l.lost>=i)})}var Ta=r=>r.map(e=>({step:e.step,kind:e.team,size:e.lost/Math.max(1,...r.map(
({lost:t})=>t)),text:bn(e)})),bc=({lost:r,payoff:e})=>e==="capture-rate"?`${r.toFixed(2)} of the capture rate`:`${r.toFixed(1)} steps`,bn=r=>`The ${r.team}s los\
e ${bc(r)} against a perfect opponent`;function Ea(r,e,t){if(t===0)return[{kind:"start",text:wc(r),agents:[]}];let n=e.moments[t-1],s=e.moments[t],o=d=>B(d,r.config.n_pursuers),a=ut(e,n,s),i=r.conflicts(
t),l=new Set(i.flatMap(d=>d.doomed)),c=a.map(d=>({kind:"capture",text:`${o(d)} is captured`,agents:[d]}));for(let d of Gt(n,s))!a.includes(d)&&!l.has(d)&&c.push(
{kind:"end",text:`${o(d)} disappears`,agents:[d]});return c.push(...i.map(({kind:d,text:m,agents:h})=>({kind:d,text:m,agents:h}))),t===r.length&&c.unshift({kind:"\
end",text:xc(r),agents:[]}),c}function wc({config:r}){return`${r.n_pursuers} pursuers and ${r.n_evaders} evaders on ${r.rows} x ${r.cols} cells, at most ${r.max_steps}\
 steps`}function xc(r){let e=Math.round(r.statistics.capture_rate*r.config.n_evaders);return`The episode ends after ${r.length} steps with ${e} of ${r.config.n_evaders}\
 evaders captured`}var Sc=60,qe=class{element;player=new ce(0,{speed:Kt,still:le()});inspector;match=null;recording=null;actions;#e;#r;#t;#n;#a=u("h2",{class:"match-title"});#s=u(
"p",{class:"tally numbers"});#l=u("ol",{class:"words",tabindex:0,"aria-live":"off","aria-label":"What happened in this step"});#u=u("p",{class:"problem",role:"a\
lert"});#c=u("div",{class:"shown","aria-live":"polite"});#d=null;#f=null;#m=0;#o=!1;#h=0;#i=[];constructor(e,t,n){this.#r=e,this.#t=t;let s=u("canvas",{"aria-la\
bel":"The match",onclick:({clientX:o,clientY:a})=>this.inspector.choose(this.#e.agentAt(o,a))});this.#e=new Ie(s,{numbers:!1}),this.#n=new lr(t),this.inspector=
new je(o=>this.#O(o)),this.actions=u("div",{class:"match-actions"},u("button",{type:"button",class:"to-play",title:"Move the chosen agent, or an evader, yoursel\
f from this step on (T)",onclick:()=>this.element.dispatchEvent(new Event("takeover"))},"Take over"),n&&xa(()=>this.shown,n)),this.element=u("section",{class:"c\
ard match-card","aria-label":"Match",id:"match"},u("div",{class:"match"},u("header",{class:"match-head"},this.#a,this.#s),this.#u,this.#c,u("div",{class:"stage"},
s),u("div",{class:"aside"},this.#l,or(),this.actions,this.inspector.element),Fe(this.player),this.#n.element)),this.player.addEventListener("frame",()=>this.recording&&
this.#e.show(this.recording,this.player.time)),this.player.addEventListener("step",()=>this.#g()),t.on("match",()=>this.#y()),this.#S(),this.#A(0,0)}get#p(){return this.#r[this.#t.
selected.run]}reveal(){(this.#p.game?this.#c:this.#e.canvas).scrollIntoView({block:"nearest"})}get shown(){return this.match&&this.#f&&{match:this.match,step:this.
player.step,champions:this.#f}}start(e){this.#d=e,this.#v()}playSoon(){this.#o=!0,this.#m||this.#w()}goTo(e){this.#h=e,!this.#m&&this.match&&this.#v()}#w(){!this.#o||
!this.match||(this.#o=!1,this.player.jump(0),le()||this.player.play())}#y(){this.#S(),clearTimeout(this.#m),this.#m=setTimeout(()=>this.#v(),Sc)}#v(){clearTimeout(
this.#m),this.#m=0,this.player.pause(),this.#S();let{selected:e}=this.#t,{game:t}=this.#p;if(this.#c.replaceChildren(...t?ga(this.#p,t,e,this.#t):[]),t){this.match=
this.recording=null,this.#o=!1,this.#b(e);return}let n=S.map(a=>ys(this.#p,a,e[a])).find(Boolean)??"";if(this.#u.textContent=n,n||!this.#d)return;this.match=kt(
this.#d,this.#p,e);let[s,o]=this.names(e);this.#f={pursuer:{name:s,policy:ae(this.#p,"pursuer",e.pursuer)},evader:{name:o,policy:ae(this.#p,"evader",e.evader)}},
this.recording=ar(this.match),this.#n.show(this.#p,this.match),this.inspector.show(this.#d,this.#p,this.match,e),this.player.length=this.match.length,this.player.
marks=zt(this.recording),this.#i=this.player.ticks=[],this.player.jump(this.#h),this.#h=0,this.#g(),this.#x(this.#d,this.match),this.#b(e),this.#w()}#b({run:e,pursuer:t,
evader:n,episode:s,seed:o}){this.element.dataset.played=`${e} ${t} ${n} ${s} ${o??""}`}async#x(e,t){let n=await Aa(e,t.config);if(this.match!==t||!n)return;let s=e.
world(t.config);t.seek(s,0),this.#i=Ma(n,s,Ac(t)),s.free(),this.player.ticks=Ta(this.#i),this.inspector.solution=n,this.#g()}names({run:e,pursuer:t,evader:n}){let s=this.#r[e],
{teams:o}=s;return[o.pursuer.script??L(s,"pursuer",t),o.evader.script??L(s,"evader",n)]}#S(){let{episode:e,seed:t}=this.#t.selected,{game:n,payoff:s}=this.#p;this.
element.classList.toggle("of-own-game",!!n),this.element.classList.toggle("of-ratings",S.some(l=>vs(this.#p,l)));let[o,a]=this.names(this.#t.selected),i=t===null?
e<s.episodes?`episode ${e+1} of ${s.episodes}`:`episode ${e+1}, not part of the cell`:`seed ${t}`;this.#a.replaceChildren(u("span",{class:"pursuer"},te(o))," ag\
ainst ",u("span",{class:"evader"},a),n?"":u("span",{class:"muted small"},i))}#g(){let e=this.match;if(!e||!this.recording)return;let t=this.player.step,n=this.recording.
moments[t];this.#A(Array.from(n.everCaptured).filter(Boolean).length,t),this.#l.replaceChildren(...this.#i.filter(s=>s.step===t).map(s=>u("li",{class:`loss-${s.
team}`},bn(s))),...Ea(e,this.recording,t).map(s=>u("li",{class:s.kind,"data-agents":s.agents.join(" ")},s.text))),this.inspector.at(t),this.#M()}#A(e,t){let{world:n}=this.#p;
n&&this.#s.replaceChildren(u("strong",{},e),` of ${n.n_evaders} captured`,u("span",{class:"muted"},` · step ${t}`))}#O(e){this.#e.look={selected:e,viewers:e===
null?[]:[e]},this.#M()}#M(){let e=this.inspector.agent;for(let t of this.#l.children){let n=t.dataset.agents?.split(" ")??[];t.classList.toggle("about",e!==null&&
n.includes(String(e)))}}},Ac=({actions:r,length:e,n_agents:t})=>Array.from({length:e},(n,s)=>r.subarray(s*t,(s+1)*t));var Mc={ArrowUp:[1,0],ArrowDown:[-1,0],ArrowRight:[0,1],ArrowLeft:[0,-1]},Tc=5;function ka(r,e,t,n="pursuer"){r.tabIndex=0,r.setAttribute("role","application"),
r.addEventListener("keydown",s=>{let o=Mc[s.key];if(!o)return;let[a,i]=n==="pursuer"?o:[o[1],o[0]],[l,c]=t(),d=s.shiftKey?Tc:1,{pursuer:m,evader:h}=e.selected;e.
select({pursuer:Oa(m+d*a,l),evader:Oa(h+d*i,c)}),s.preventDefault(),s.stopPropagation()})}var Oa=(r,e)=>Math.min(e-1,Math.max(0,r));var Ec=24,cr=7,Ra=r=>r<Ec&&matchMedia("(pointer: coarse)").matches;function $a(r,e,t,n){let[s,o]=r.payoff.shape,a=Ca(e,s),i=Ca(t,o),l=Math.min(cr,s),c=Math.min(
cr,o),d=[];for(let y=a+l-1;y>=a;y--){d.push(u("span",{class:"pursuer"},y));for(let g=i;g<i+c;g++)d.push(Oc(r,y,g,n))}let m=Array.from({length:c},(y,g)=>u("span",
{class:"evader"},i+g)),h=u("button",{type:"button","aria-label":"Close: all cells",onclick:()=>n(null)},"✕"),f=u("div",{class:"loupe numbers",role:"group","ar\
ia-label":"Cells around the tap",onclick:y=>y.stopPropagation()},...d,h,...m);return f.style.gridTemplateColumns=`2.4rem repeat(${c}, minmax(0, 1fr))`,f}function Oc(r,e,t,n){
let s=u("button",{type:"button",onclick:()=>n({pursuer:e,evader:t})});return Xt(s,ie(r,e,t)?.rate,`${L(r,"pursuer",e)} against ${L(r,"evader",t)}`),s}var Ca=(r,e)=>Math.
max(0,Math.min(e-cr,r-Math.floor(cr/2)));var D={left:52,bottom:46,top:76,right:84},Z=10,kc=160,xt=D.right-Z-14,Me=D.top-Z-14,Ke=class{element;#e;#r;#t=u("canvas",{"aria-hidden":"true"});#n=w("svg",{"ar\
ia-hidden":"true"});#a=w("g");#s;#l=u("h2");#u=u("strong",{class:"rate numbers"});#c=u("span",{class:"small muted"});#d=u("p",{class:"of-both-teams small muted \
numbers"});#f;#m=null;constructor(e,t){this.#r=e,this.#e=t,this.#s=u("div",{class:"matrix",id:"matrix","aria-label":"Payoff matrix. Arrow keys choose a match, E\
nter plays it.",onpointermove:s=>this.#x(s),onpointerleave:()=>t.point({}),onclick:s=>this.#S(s),onkeydown:({key:s})=>s==="Enter"&&this.#A()},this.#t,this.#n);let n=u(
"header",{class:"readout","aria-live":"polite"},u("div",{},this.#l,this.#d),u("div",{class:"of-cell"},this.#u,this.#c));this.#f=re(...j(this.#o).ends),this.element=
u("section",{class:"card matrix-card","aria-label":"Payoff matrix"},n,this.#s,this.#f),this.#y(),new ResizeObserver(()=>this.#h()).observe(this.#s),this.#s.addEventListener(
"mousedown",s=>{s.preventDefault(),document.activeElement instanceof HTMLElement&&document.activeElement.blur()}),ka(this.#s,t,()=>this.#o.payoff.shape),t.on("r\
un",()=>{let s=re(...j(this.#o).ends);this.#f.replaceWith(s),this.#f=s,this.#h()}),t.on("match hover",()=>this.#w())}get#o(){return this.#r[this.#e.selected.run]}#h(){
let[e,t]=this.#o.payoff.shape,{clientWidth:n,clientHeight:s}=this.#s;if(n<50)return;let a=Math.max(kc,Math.min(n-D.left-D.right,s-D.top-D.bottom))/Math.max(e,t),
i=Math.max(D.left,(n-t*a-D.right+D.left)/2),l=D.top+Math.max(0,(s-D.top-D.bottom-e*a)/2),c={width:n,height:s,left:i,top:l,cell:a,rows:e,columns:t};this.#m=c,Ue(
this.#t,this.#o.payoff,{left:i,top:l,width:t*a,height:e*a});for(let[d,m,h]of[["left",i,n],["top",l,s],["width",t*a,n],["height",e*a,s]])this.#t.style.setProperty(
d,`${100*m/h}%`);this.#s.style.setProperty("--shape",`${n} / ${s}`),this.#n.setAttribute("viewBox",`0 0 ${n} ${s}`),this.#n.replaceChildren(Cc(c,j(this.#o).generation),
...Rc(c),...this.#p(c),this.#a),this.#w()}#i(e){let t=this.#o.findings?.generalization;if(!t)return[];let{selected:n,hover:s}=this.#e,o=s.pursuer??n.pursuer,a=s.
evader??n.evader,[i,l]=Pa(e,t.pursuers.mean[o]??0,o),[c,d]=_a(e,t.evaders.mean[a]??0,a);return[w("circle",{class:"dot of-pursuers",cx:i,cy:l,r:5}),w("circle",{class:"\
dot of-evaders",cx:c,cy:d,r:5})]}#p(e){let t=this.#o.findings?.generalization;if(!t)return[];let{left:n,top:s,cell:o,rows:a,columns:i}=e,{curves:l}=j(this.#o),c=n+
i*o+Z,d=s-Z,m={class:"side"};return[w("rect",{...m,x:c,y:s,width:xt,height:a*o}),w("rect",{...m,x:n,y:d-Me,width:i*o,height:Me}),...La(t.pursuers,(h,p)=>Pa(e,h,
p),"of-pursuers"),...La(t.evaders,(h,p)=>_a(e,h,p),"of-evaders"),w("text",{class:"tick",x:c,y:s+a*o+16,"text-anchor":"start"},"0"),w("text",{class:"tick",x:c+xt,
y:s+a*o+16,"text-anchor":"end"},"1"),w("text",{class:"tick",x:n-6,y:d-4,"text-anchor":"end"},"0"),w("text",{class:"tick",x:n-6,y:d-Me+8,"text-anchor":"end"},"1"),
w("text",{class:"label of-pursuers",x:c+xt,y:s+a*o+34,"text-anchor":"end"},l.pursuer),w("text",{class:"label of-evaders",x:n+i*o+Z,y:d-Me+10,"text-anchor":"star\
t"},l.evader)]}#w(){let e=this.#m;if(!e)return;let{selected:t,hover:n}=this.#e,{left:s,top:o,cell:a,rows:i,columns:l}=e,c=f=>o+(i-1-f)*a,d=[],m=(f,y)=>w("rect",
{class:y,x:s,y:c(f),width:l*a+Z+xt,height:a}),h=(f,y)=>w("rect",{class:y,x:s+f*a,y:o-Z-Me,width:a,height:Z+Me+i*a});d.push(m(t.pursuer,"strip pursuer"),h(t.evader,
"strip evader")),n.pursuer!==null&&n.pursuer<i&&d.push(m(n.pursuer,"strip hover")),n.evader!==null&&n.evader<l&&d.push(h(n.evader,"strip hover")),d.push(...this.#i(
e));let p={x:s+t.evader*a,y:c(t.pursuer),width:a,height:a};d.push(w("rect",{class:"chosen under",...p}),w("rect",{class:"chosen",...p})),this.#a.replaceChildren(
...d),this.#y()}#y(){let{selected:e,hover:t}=this.#e,n=t.pursuer??e.pursuer,s=t.evader??e.evader,o=ie(this.#o,n,s);this.#l.replaceChildren(u("span",{class:"purs\
uer"},te(L(this.#o,"pursuer",n)))," against ",u("span",{class:"evader"},L(this.#o,"evader",s))),this.#u.textContent=o?R(o.rate,3):"-";let a=o&&o.rates.length>1?
`, mean of ${o.rates.length} episodes`:"";this.#c.textContent=o?j(this.#o).score+a:"no episodes were played",this.#d.textContent=this.#v(n,s)}#v(e,t){let n=this.#o.
findings?.generalization;if(!n)return"";let s=(a,i)=>Ao(a.mean[i]??null,a.low?.[i]??null,a.high?.[i]??null),{means:o}=j(this.#o);return`Against all: ${o.pursuer}\
 ${s(n.pursuers,e)}, ${o.evader} ${s(n.evaders,t)}`}#b(e){let t=this.#m;if(!t)return null;let n=this.#s.getBoundingClientRect(),s=Math.floor((e.clientX-n.left-t.
left)/t.cell),o=t.rows-1-Math.floor((e.clientY-n.top-t.top)/t.cell),a=o>=0&&o<t.rows,i=s>=0&&s<t.columns;return a||i?{g:a?o:-1,h:i?s:-1,inside:a&&i}:null}#x(e){
let t=this.#b(e);this.#e.point(t?{pursuer:t.g<0?null:t.g,evader:t.h<0?null:t.h}:{})}#S(e){let t=this.#b(e);if(t){if(t.inside&&Ra(this.#m.cell))return this.#g(t.
g,t.h);this.#e.select({...t.g<0?{}:{pursuer:t.g},...t.h<0?{}:{evader:t.h}}),t.inside&&this.#A()}}#g(e,t){let n=$a(this.#o,e,t,s=>{n.remove(),s&&(this.#e.select(
s),this.#A())});this.#s.append(n)}#A(){this.#s.dispatchEvent(new CustomEvent("play",{bubbles:!0}))}};function Cc({left:r,top:e,cell:t,rows:n,columns:s},o){let a=w(
"g",{class:"axes"}),i=e+n*t,l=c=>pt(0,c-1,Math.min(c,c*t/44),!0);for(let c of l(s))a.append(w("text",{class:"tick",x:r+(c+.5)*t,y:i+16,"text-anchor":"middle"},c));
for(let c of l(n))a.append(w("text",{class:"tick",x:r-7,y:i-(c+.5)*t,"text-anchor":"end","dominant-baseline":"middle"},c));return a.append(w("text",{class:"labe\
l of-evaders",x:r+s*t/2,y:i+36,"text-anchor":"middle"},o.evader),w("text",{class:"label of-pursuers",transform:`translate(${r-36} ${e+n*t/2}) rotate(-90)`,"text\
-anchor":"middle"},o.pursuer)),a}function Rc({left:r,top:e,cell:t,rows:n,columns:s}){let o=w("g",{class:"diagonal"}),a=Math.min(n,s);if(a<3)return[];let i=e+n*t;
for(let d of["H","V"]){let m=`M${r} ${i}`;for(let h=1;h<=a;h++){let p=`H${r+h*t}`,f=`V${i-h*t}`;m+=d==="H"?p+f:f+p}o.append(w("path",{d:m,class:"under"}),w("pat\
h",{d:m}))}let l=r+a/2*t-.7*t-4,c=i-a/2*t-.7*t-4;return[o,w("text",{class:"on-cells",transform:`translate(${l} ${c}) rotate(-45)`,"text-anchor":"middle"},"same \
generation")]}var Pa=({left:r,top:e,cell:t,rows:n,columns:s},o,a)=>[r+s*t+Z+o*xt,e+(n-a-.5)*t],_a=({left:r,top:e,cell:t},n,s)=>[r+(s+.5)*t,e-Z-n*Me];function La(r,e,t){
let n=o=>o.map((a,i)=>e(a??0,i).map(l=>l.toFixed(1)).join(" ")),s=[];return r.low&&r.high&&s.push(w("path",{class:`band ${t}`,d:`M${[...n(r.high),...n(r.low).reverse()].
join("L")}Z`})),s.push(w("path",{class:`line ${t}`,d:`M${n(r.mean).join("L")}`})),s}var Na={pursuer:null,evader:null},Ye=class extends EventTarget{#e;#r=Na;constructor(e){super(),this.#e=e}get selected(){return this.#e}get hover(){return this.#r}select(e){
let t=this.#e,n=["run","pursuer","evader"].some(s=>s in e&&e[s]!==t[s]);this.#e={...t,...n?{episode:0,seed:null}:{},...e},this.#e.run!==t.run&&this.dispatchEvent(
new Event("run")),this.dispatchEvent(new Event("match"))}point(e){let t={...Na,...e};t.pursuer===this.#r.pursuer&&t.evader===this.#r.evader||(this.#r=t,this.dispatchEvent(
new Event("hover")))}on(e,t){for(let n of e.split(" "))this.addEventListener(n,t)}};var wn=r=>Array.from({length:r},()=>Array(r)),ur=class{learning=S;settings=[];command="";training={capture_rate:[],generation:[],learner:[],epochs:1,window:1,matches:0};limits="";name;schedule;seed;seeds=[];world;payoff;teams;findings=null;genomes={
pursuer:[],evader:[]};best=null;#e;#r;#t;constructor(e,t,n,s){this.#t=e,this.#e=t,this.#r=s,this.name=n,this.schedule=n,this.world=e.world,this.seed=String(e.seed),
this.payoff=this.#n(),this.teams=this.#a()}get newest(){return this.genomes.pursuer.length-1}#n(){let{seed:e,schedule:{generations:t}}=this.#t,n=t+1;return this.
seeds=Array.from({length:n},(s,o)=>Array.from({length:n},(a,i)=>String(Ct(e,o,i)))),{first:[0,0],shape:[n,n],episodes:this.#t.evaluation_episodes,capture_rate:wn(
n),capture_rates:wn(n),lengths:wn(n)}}#a(){let e=t=>{let n=`${this.#r} ${t}`;ws(n,Pt(this.genomes[t]));let{genome:s,...o}=lt(Lt(this.#t,this.#e,t),this.genomes[t][0]??
new Float32Array(0));return{script:null,policy:{...o,genome_size:s.length},kept:[...this.genomes[t].keys()],genomes:n}};return{pursuer:e("pursuer"),evader:e("ev\
ader")}}policy(e,t){return this.playing(e,this.genomes[e][t])}playing(e,t){return lt(Lt(this.#t,this.#e,e),t)}genomesOf({pursuer:e,evader:t}){return{pursuer:this.
genomes.pursuer[e],evader:this.genomes.evader[t]}}extend(e){let{capture_rate:t,capture_rates:n,lengths:s,shape:[o]}=this.payoff;if(this.#t={...this.#t,schedule:e.
schedule},!(o>e.schedule.generations)){this.payoff=this.#n();for(let a=0;a<o;a++)Object.assign(this.payoff.capture_rate[a],t[a]),Object.assign(this.payoff.capture_rates[a],
n[a]),Object.assign(this.payoff.lengths[a],s[a])}}add(e){for(let t of S)this.genomes[t].push(e[t]);this.teams=this.#a()}change(e,t){this.#t=e,this.world=e.world;
for(let n of S)this.genomes[n]=[...t[n]];this.best=null,this.payoff=this.#n(),this.teams=this.#a(),this.findings=null}addCell({pursuer:e,evader:t,capture_rates:n,
lengths:s}){this.payoff.capture_rate[e][t]=A(n),this.payoff.capture_rates[e][t]=[...n],this.payoff.lengths[e][t]=[...s],this.findings={generalization:this.#s()}}#s(){
let e=this.payoff.capture_rate,t=o=>({mean:o,low:null,high:null}),n=o=>{let a=o.filter(i=>i!==void 0);return a.length?A(a):null},s=[...this.genomes.pursuer.keys()];
return{pursuers:t(s.map(o=>n(e[o]))),evaders:t(s.map(o=>n(e.map(a=>a[o]===void 0?void 0:1-a[o]))))}}};var $c=1/4,Fa=1.96,Ia=.05,xn=5;function Da(r,e){let t=Array.from({length:e},(m,h)=>Array.from({length:e},(p,f)=>r.get(`${h} ${f}`)?.capture_rates));if(e<2||t.some(
m=>m.includes(void 0)))return null;let n=t.map(m=>m.map(h=>A(h))),s=t.map(m=>m.map(h=>_c(h))),o=Math.max(1,Math.round(e*$c)),a=m=>{let h=Hr(n,m),p=m==="pursuer"?
s:Pc(s),f=[h[0].slice(-o)],y=h.slice(-o).map(M=>M.slice(-o)),g=M=>A(M.map(T=>A(T.slice(-o))/o))/M.length,b={value:A(y.map(A))-A(f.map(A)),reach:Fa*Math.sqrt(g(p.
slice(-o))+g([p[0]]))},v=Lc(h,p),x=Ic(b,v);return{verdict:x==="better"&&!Nc(h.map(A),v.value)?"better by a jump":x,before:A(f[0]),after:A(y.map(A))}},i={pursuer:a(
"pursuer"),evader:a("evader")},l=m=>{let h=Hr(n,m).map(A);return h.lastIndexOf(Math.max(...h))},c={pursuer:l("pursuer"),evader:l("evader")},d=n[c.pursuer][c.evader];
return{rate:d,best:c,teams:i,sentence:Dc(d,i)}}var Pc=r=>r[0].map((e,t)=>r.map(n=>n[t])),_c=r=>r.reduce((e,t)=>e+(t-A(r))**2,0)/Math.max(1,r.length-1)/r.length;
function Lc(r,e){let t=r.length-1,n=r.map((i,l)=>l-t/2),s=n.reduce((i,l)=>i+l*l,0),o=n.map(i=>t*i/s),a=e.map(i=>A(i)/i.length);return{value:r.reduce((i,l,c)=>i+
o[c]*A(l),0),reach:Fa*Math.sqrt(a.reduce((i,l,c)=>i+o[c]**2*l,0))}}function Nc(r,e){let t=r.map(c=>c*Math.sign(e)),n=Math.floor(r.length/xn),s=r.length%xn,o=Array.
from({length:xn},(c,d)=>A(t.slice(d*n+Math.min(d,s),(d+1)*n+Math.min(d+1,s)))),a=Math.max(2,Math.floor(r.length/10)),i=Math.max(...t.slice(a).map((c,d)=>c-t[d])),
l=Math.max(...o.slice(1).map((c,d)=>o[d]-c));return i<Math.abs(e)/2&&l<Math.abs(e)/4}function Ic(...r){return r.every(({value:e,reach:t})=>e-t>Ia)?"better":r.every(
({value:e,reach:t})=>e+t<-Ia)?"weaker":"cannot tell"}var N=r=>`${Math.round(100*r)} %`,Fc={better:"better than in generation 0","better by a jump":"better than \
in generation 0, most of it in one jump",weaker:"weaker than in generation 0","cannot tell":""};function Dc(r,e){let t=`The best pursuers now catch ${N(r)} of t\
he best evaders.`,n=S.map(o=>Fc[e[o].verdict]);if(n[0]===n[1])return n[0]?`${t} Both teams are ${n[0]}.`:`${t} Whether a team has become better since generation\
 0, this race cannot tell.`;let s=S.map((o,a)=>n[a]?`the ${o}s are ${n[a]}`:`of the ${o}s this race cannot tell`);return`${t} ${s[0][0].toUpperCase()}${s[0].slice(
1)}; ${s[1]}.`}function Wa(r,{before:e,after:t}){let[n,s]=r==="pursuer"?[e,t]:[1-e,1-t];return r==="pursuer"?`Of the last ${ee(r)}s, pursuers of generation 0 ca\
tch ${N(n)}, the last pursuers ${N(s)}.`:`The last pursuers catch ${N(n)} of the evaders of generation 0, and ${N(s)} of the last evaders.`}var Ua=1/3,Wc=1/10,Uc=4,Hc=2,zc=12,Ha=r=>r.length>1?`${r.slice(0,-1).join(", ")} and ${r.at(-1)}`:r[0]??"";function za({phrases:r,words:e},t,n){let s=Object.entries(
n).map(([c,d])=>[c,Math.abs(d)]).sort(([,c],[,d])=>d-c),o=s[0]?.[1]||1/0,a=s.filter(([,c])=>c/o>=Ua).slice(0,Uc).map(([c])=>r[c][n[c]>0?1:0]),i=s.filter(([,c])=>c/
o>=Wc&&c/o<Ua).slice(0,Hc).map(([c])=>r[c][2]),l=Ha([...a,...i.length?[`minds ${Ha(i)} little`]:[]])||"takes any move that is allowed";return`${t==="pursuer"?"A":
"An"} ${t} ${l}.`.replaceAll(/\{(\w+)\}/g,(c,d)=>e[t][d])}function Ga(r,e,t,n){let s=n[t];if(s.kind!=="rating")return{};let{n_pursuers:o,n_evaders:a}=e.config,i=Array.
from({length:t==="pursuer"?o:a},(d,m)=>m+(t==="pursuer"?0:o)),l=r.world(e.config),c=s.inputs.map(()=>[]);for(let d=0;d<e.length;d+=Math.max(1,Math.floor(e.length/
zc))){e.seek(l,d,{pursuers:n.pursuer,evaders:n.evader});for(let m of i.filter(h=>e.alive[d*e.n_agents+h])){let{inputs:h,refused:p}=l.rate(s,m);h.forEach((f,y)=>{
let g=Array.from(f).filter((b,v)=>!p[v]);g.length&&c[y].push(A(g.map(b=>(b-A(g))**2)))})}}return l.free(),Object.fromEntries(s.inputs.map((d,m)=>[d,s.genome[m]*
Math.sqrt(c[m].length?A(c[m]):0)]))}var Gc=2,Bc=1.5,dr=class{element=u("section",{class:"card weights-card","aria-label":"Weights of named inputs",hidden:!0});#e;#r;#t;#n=u("div",{class:"evolved"});#a=u(
"p",{class:"numbers",role:"status"});#s=u("button",{type:"button",onclick:()=>this.#h()},"As evolved");#l={pursuer:u("p"),evader:u("p")};#u=null;#c=null;constructor(e,t,n){
this.#e=e,this.#r=t,this.#t=n,this.element.append(u("h3",{},"What they have learned"),u("p",{class:"small muted"},"An agent takes the move with the largest sum \
of weight x input. Drag a weight, and see at once what becomes of the team."),u("div",{class:"doings"},this.#s,this.#a),this.#n)}genome(e){return this.#c?.[e]??
this.#f[e]}get#d(){let{newest:e,best:t}=this.#u;return t??{pursuer:e,evader:e}}get#f(){return this.#u.genomesOf(this.#d)}show(e){e!==this.#u&&(this.#c=null),this.#u=
e;let{policy:t}=e.teams.pursuer;this.element.hidden=t?.kind!=="rating"||e.newest<1,!(t?.kind!=="rating"||this.element.hidden)&&(this.#c||this.#n.replaceChildren(
...S.map(n=>this.#m(n,t.inputs))),this.#i())}#m(e,t){let n=this.genome(e),s=Math.max(Gc,Bc*Math.max(...n.map(Math.abs)));return u("div",{class:"weights"},u("h4",
{class:e},`${e}s`),this.#l[e],...t.flatMap((o,a)=>{let i=u("span",{class:"numbers"},De(n[a])),l=u("input",{type:"range",class:e,min:-s,max:s,step:"any",value:n[a],
title:de[o],"aria-label":`${e}s: ${o}`});return l.addEventListener("input",()=>{i.textContent=De(Number(l.value)),this.#o(e,a,Number(l.value))}),[u("span",{title:de[o]},
o.replaceAll("_"," ")),l,i]}))}#o(e,t,n){this.#c??={pursuer:this.genome("pursuer").slice(),evader:this.genome("evader").slice()},this.#c[e][t]=n,this.#i(),this.#t()}#h(){
this.#c=null,this.show(this.#u),this.#t()}#i(){this.#s.disabled=!this.#c;let e=N(this.rate(this.#f));this.#a.textContent=this.#c?`Yours: ${N(this.rate(this.#c))}\
 are caught; as evolved: ${e}`:`${e} are caught`;let t=this.#u,n={pursuer:t.playing("pursuer",this.genome("pursuer")),evader:t.playing("evader",this.genome("eva\
der"))},s=this.#e.match(t.world,n.pursuer,n.evader,BigInt(t.seed));for(let o of S)this.#l[o].textContent=za(this.#r,o,Ga(this.#e,s,o,n))}rate({pursuer:e,evader:t},n=this.#d,s=this.#u){
let o=new Int32Array(1),a={pursuer:o,evader:o,seed:BigUint64Array.of(BigInt(s.seeds[n.pursuer][n.evader]))};return A(this.#e.rollouts(s.world,s.playing("pursuer",
e),s.playing("evader",t),a,s.payoff.episodes).capture_rate)}};var jc=100,Vc=.3,qc="By chance: evaders that have not learned to flee run into pursuers that have not learned to hunt.",mr={pursuer:0,evader:0},Ba=0,hr=class extends EventTarget{element;chases;boards;before=new Se;after=new Se;settings;state="\
waiting";done=0;epochs=0;changed=[];seconds=0;outcome=null;kept=null;#e;#r;#t;#n=u("h2",{class:"lane-title"});#a=u("p",{class:"facts numbers"});#s=u("div",{class:"\
lane-room"});#l=u("section",{class:"card measures"});#u=u("details",{class:"lane-more",hidden:!0},u("summary",{},"More: every generation against every other, sc\
ores and collisions"),this.#s,this.#l);#c=u("div");#d=new je(()=>{});#f=u("section",{class:"card asked","aria-label":"An agent",hidden:!0},u("button",{type:"but\
ton",class:"leave",onclick:()=>this.#C(null,null)},"Close"),this.#d.element);#m;#o;#h={pursuer:[],evader:[]};#i=new Map;#p;#w=()=>{};#y=0;#v=!0;#b=!1;#x=0;#S=null;constructor(e,t,n,s){
super(),this.#e=e,this.#r=t,this.settings=s,this.#t=new Nt(n,o=>this.#A(o)),this.chases=new Be(()=>this.#F(),this.before,this.after),this.before.element.classList.
add("before"),this.boards=u("div",{class:"pair"},this.before.element,this.after.element),this.#m=new dr(t,e,()=>this.#T(!0));for(let o of[this.before,this.after])
o.addEventListener("agent",()=>o.agent!==null&&this.#C(o,o.agent)),o.addEventListener("step",()=>!this.#f.hidden&&o.agent!==null&&this.#R(o));this.element=u("se\
ction",{class:"lane"},this.#n,this.#a,this.boards,u("p",{class:"hint small muted"},"Click an agent, or press A: what it sees, and why it moves."),this.#f,this.#m.
element,this.#u,this.#c),this.reset(s)}reset(e){this.#t.send({type:"stop"}),this.#k(e),this.state="waiting";let{archive:t}=new _e(this.#r,e,this.#e.masks);this.#o.
add({pursuer:t.pursuer[0],evader:t.evader[0]}),this.#T(!0),this.#E()}start(e,t=[],n=1/0){this.#k(e),this.state="evolving",this.settings=t.at(-1)?.settings??e,this.#g(
{type:"start",settings:e,masks:this.#e.masks,plan:t,until:n}),this.#E()}restore(e,t,n,s){this.#k(t.settings),this.settings=e,this.kept=t;for(let o=0;o<t.finished;o++)
this.#o.add({pursuer:t.archive.pursuer[o],evader:t.archive.evader[o]});for(let[o,a]of t.cells)this.#o.addCell(a),this.#i.set(o,a);this.#h={pursuer:[...t.scores.
pursuer],evader:[...t.scores.evader]},this.seconds=t.seconds,this.done=1,this.epochs=n,this.changed.push(...s),this.#M("ended"),this.#$()}stop(){this.#g({type:"\
stop"})}go(){this.state="evolving",this.#g({type:"go"}),this.#E()}change(e){if(this.state==="waiting")return this.reset(e);this.settings=e,this.#g({type:"change",
settings:e}),this.#E()}saved(){return this.kept?Promise.resolve(this.kept):new Promise(e=>{this.#S=e,this.#g({type:"save"})})}async keep(){return{...await this.
saved(),scores:this.#h,seconds:this.seconds}}get newestGeneration(){return this.#o.newest}get champions(){return{pursuer:this.#m.genome("pursuer"),evader:this.#m.
genome("evader")}}get run(){return this.#o}close(){this.#t.close(),this.chases.runs=!1}#g(e){this.#t.send(e)}#A(e){if(e.type==="began"&&(this.#b=!0),!!this.#b){
if(e.type==="generation")this.#o.add(e.genomes),this.#T(e.number===0);else if(e.type==="cell"){let{pursuer:t,evader:n}=e.cell;this.#o.addCell(e.cell),this.#v&&t===
n&&t===this.#o.newest&&this.#p.select({pursuer:t,evader:n}),this.#i.set(`${t} ${n}`,e.cell),(this.state==="stopped"||this.state==="ended")&&this.#M(this.state)}else if(e.
type==="scores")for(let t of S)this.#h[t][e.number]=e.scores[t];else e.type==="changed"?(this.#o.extend(e.settings),this.changed.push(e.at),this.epochs=e.at,e.settings.
schedule.generations>this.#o.newest&&this.state==="ended"&&this.#O()):e.type==="anew"?(this.#o.change(e.settings,e.genomes),this.#P(),this.#T(!0)):e.type==="epo\
ch"?(this.epochs+=1,this.done=e.done/e.of):e.type==="stopped"?this.#M("stopped"):e.type==="end"?(this.seconds=e.seconds,this.done=1,this.#M("ended")):e.type==="\
saved"?this.#S?.(e.race):e.type==="failed"&&(this.#a.textContent=`The race failed: ${e.message}`,this.state="stopped");this.#x||(this.#x=setTimeout(()=>requestAnimationFrame(
()=>this.#$()),jc))}}#O(){this.state="evolving",this.outcome=null,this.#o.best=null}#M(e){let t=this.outcome;this.state=e,this.outcome=Da(this.#i,this.#o.newest+
1),this.#o.best=this.outcome?.best??null,this.outcome&&!t&&this.#T(!0),this.#U()}#$(){this.#x=0,this.#p.dispatchEvent(new Event("run")),this.#w(),this.#E()}#P(){
this.#i=new Map,this.#h={pursuer:[],evader:[]},this.outcome=null,this.#l.hidden=!0}#k(e){this.settings=e,this.done=0,this.epochs=0,this.changed.splice(0),this.kept=
null;let t=ir(e);this.#o=new ur(e,this.#e.masks,t,`race ${Ba}`),Ba+=1,this.#P(),this.#C(null,null),this.#v=!0,this.#b=!1,this.#p=new Ye({run:0,pursuer:0,evader:0,
episode:0,seed:null});let n=new Ke([this.#o],this.#p);n.element.ariaLabel=`Payoff matrix. ${t}`,this.#c.replaceChildren(this.#L(n)),this.#s.replaceChildren(n.element,
this.#N())}#L(e){let t=new qe([this.#o],this.#p,null);t.actions.remove();let n=u("dialog",{class:"of-cell-match","aria-label":"Match",onclose:()=>t.player.pause()},
u("button",{type:"button",class:"leave",onclick:()=>n.close()},"Close"),t.element),s=!1;return e.element.addEventListener("play",()=>{let{pursuer:o,evader:a}=this.#p.
selected;this.#v=!1,this.#o.payoff.capture_rate[o][a]!==void 0&&(n.showModal(),s||t.start(this.#r),s=!0,t.playSoon())}),n}#N(){let e=`${_t.pursuer.join(", ")} a\
nd ${_t.evader.join(", ")}`,t=K(`Scores against scripts, by generation: ${e}`,(s,o)=>this.#I(s,o),()=>{},s=>{let o=Math.min(this.#o.newest,Math.max(0,Math.round(
s)));this.#p.select({pursuer:o,evader:o})});return this.#w=t.redraw,u("section",{class:"card scores"},u("h3",{},"Against opponents that never change"),u("p",{class:"\
small muted"},"Captures of random walkers and of clumsy fleers; escapes from random walkers and from clumsy chasers."),We(["pursuers","of-pursuers"],["evaders",
"of-evaders"]),t.element)}#I(e,t){let{generations:n}=this.settings.schedule,o=V(e,t,{low:0,high:n,label:"generation",whole:!0},{low:0,high:1,label:"score"});for(let a of S){
let i=Array.from(this.#h[a],l=>l??null);q(o,[...i.keys()],i,`of-${a}s`)}return o}#F(){if(this.#o.newest<0)return;let e=BigInt(this.#o.seeds[0][0]),t=this.#y%this.#o.
payoff.episodes;this.#y+=1;let n=s=>this.#r.match(this.#o.world,...this.#_(s),e,t);this.before.show(n(this.#o.genomesOf(mr)),"Before: generation 0"),this.after.
show(n(this.champions),this.#D());for(let s of[this.before,this.after])s.agent!==null&&this.#R(s,!0)}#D(){let{newest:e,best:t}=this.#o;if(e===0)return"Generatio\
n 0: nobody has learned anything yet";let{pursuer:n,evader:s}=t??{pursuer:e,evader:e},o=n===s?`generation ${n}`:`pursuers of generation ${n}, evaders of generat\
ion ${s}`;return t?`After: ${o}`:`Now: ${o}`}#_({pursuer:e,evader:t}){return[this.#o.playing("pursuer",e),this.#o.playing("evader",t)]}#T(e){this.#m.show(this.#o),
this.chases.renew(e)}#C(e,t){for(let n of[this.before,this.after])n!==e&&n.agent!==null&&n.choose(null);this.#f.hidden=!e,e&&(this.#R(e,!0),this.#d.choose(t))}askNext(){
let{match:e,player:t,agent:n}=this.after;if(!e)return;let s=e.n_agents,o=(n??-1)+1,i=Array.from({length:s},(l,c)=>(o+c)%s).find(l=>e.alive[t.step*s+l]);i!==void 0&&
this.after.choose(i)}#R(e,t=!1){if(t){let n=e===this.before,[s,o]=this.#_(n?this.#o.genomesOf(mr):this.champions),a=n?0:this.#o.newest;this.#d.show(this.#r,this.#o,
e.match,{run:0,pursuer:a,evader:a,episode:0,seed:null},{pursuers:s,evaders:o})}this.#d.at(e.player.step)}#E(){let{newest:e}=this.#o;this.element.dataset.state=this.
state,this.#n.textContent=ir(this.settings),this.#u.hidden=this.state==="waiting",this.#a.replaceChildren(...this.#W().map(t=>u("span",{},t))),this.element.dataset.
newest=String(e),this.dispatchEvent(new Event("state"))}#W(){let{newest:e}=this.#o;if(this.outcome)return[this.outcome.sentence];if(e<0)return[];let t=a=>{let i=this.#i.
get(`${a} ${a}`);return i?A(i.capture_rates):null};if(this.state==="waiting"||e<1){let a=t(0)??this.#m.rate(this.#o.genomesOf(mr),mr),i=`${N(a)} of the evaders \
are caught.`;return a>Vc?[i,qc]:[i]}let n=`Generation ${e} of ${this.settings.schedule.generations}`,s=t(e)??t(e-1),o=t(0);return s===null||o===null?[`${n}.`]:[
`${n}: the pursuers catch ${N(s)} of the evaders; those of generation 0 caught ${N(o)}.`]}#U(){let{outcome:e}=this;if(this.#l.hidden=!e,this.#l.ariaLabel=`What \
came out. ${ir(this.settings)}`,!e)return;let t=this.#i.get(`${this.#o.newest} ${this.#o.newest}`),n=[["Score against scripts: generation 0",s=>N(this.#h[s][0]??
0)],["Score against scripts: newest generation",s=>N(this.#h[s].at(-1)??0)],["Collisions at fault in 1000 moves of the newest generation",(s,o)=>Kc(t,o).toFixed(
1)]];this.#l.replaceChildren(u("h3",{},"In numbers"),...S.map(s=>u("p",{},Wa(s,e.teams[s]))),u("table",{class:"numbers"},u("thead",{},u("tr",{},u("td"),...S.map(
s=>u("th",{scope:"col",class:s},`${s}s`)))),u("tbody",{},...n.map(([s,o])=>u("tr",{},u("th",{scope:"row"},s),...S.map((a,i)=>u("td",{},o(a,i))))))),u("p",{class:"\
small muted"},"One race proves little: save it, and ",u("code",{},"matrixworld judge")," says what happened on its way, and how surely."))}};function Kc({means:{
faults:r,agent_steps:e}},t){let n=r.length/S.length;return 1e3*r.slice(t*n,(t+1)*n).reduce((s,o)=>s+o,0)/Math.max(1,e[t])}function Yc(r,e,...t){return u("section",{class:"card panel","aria-label":r},u("header",{},u("h2",{},r),u("p",{class:"small muted"},e)),...t)}var Zc={present:"●",
absent:"○","cannot tell":"?"};function ja(r){let{findings:e}=r;if(!e?.table.length)return null;let[,...t]=e.table,n=t.map(([o,a,i,l],c)=>{let d=Jc(e.reasons[c]??
"");return u("li",{class:`finding ${a.replace(" ","-")}`},u("span",{class:"sign","aria-hidden":"true"},Zc[a]??""),u("div",{},u("p",{},u("strong",{},o),` ${a}`,u(
"span",{class:"muted"},` · ${l}`)),d?u("p",{class:"small"},`${d}.`):null,u("p",{class:"small muted numbers"},i)))}),s=Yc("What happened","Each condition is pre\
sent, absent, or its 95 % interval cannot tell. The intervals are about this run.",u("p",{class:"headline"},e.sentence),u("ul",{class:"findings"},...n),r.limits?
u("p",{class:"small"},r.limits):null);return s.classList.add("diagnosis"),{element:s}}function Jc(r){let[,e=""]=r.split(/, because (.*)/s);return te(e.replace(/\.$/,
""))}var Xc=84;function Va(r,e){let t=r.map((o,a)=>Qc(o,a,e)),n=u("nav",{class:"races","aria-label":"Runs"},...t.map(o=>o.button)),s=()=>t.forEach((o,a)=>o.update(a===
e.selected.run));return e.on("match hover",s),s(),n.hidden=r.length<2,n}function Qc(r,e,t){let[n,s]=r.payoff.shape,o=!r.name.startsWith(r.schedule),a=Xc/Math.max(
n,s),i=u("canvas",{"aria-hidden":"true"});Ue(i,r.payoff,{left:0,top:0,width:s*a,height:n*a});let l=u("span",{class:"place"}),c=u("button",{type:"button",class:"\
race",title:`${r.name} (key ${e+1})`,onclick:()=>tu(r,e,t)},u("span",{class:"small-matrix"},i,l),u("span",{class:"race-text"},u("strong",{},o?r.name:r.schedule),
u("span",{class:"small"},r.findings?r.findings.sentence:`${r.learning.map(m=>j(r).teams[m]).join(" and ")} against ${eu(r)}`),u("span",{class:"small muted"},`${o?
`${r.schedule}, `:""}seed ${r.seed}`)));return{button:c,update:m=>{c.setAttribute("aria-current",String(m));let h=t.hover.pursuer??t.selected.pursuer,p=t.hover.
evader??t.selected.evader;l.hidden=h>=n||p>=s,l.style.left=`${(p+.5)*a}px`,l.style.top=`${(n-h-.5)*a}px`}}}var eu=r=>r.teams.pursuer.script??r.teams.evader.script??
"another run";function tu(r,e,t){let[n,s]=r.payoff.shape,{pursuer:o,evader:a}=t.selected;t.select({run:e,pursuer:Math.min(o,n-1),evader:Math.min(a,s-1)})}var qa=1,ru="meadow";function Ka({runs:r},e){let t=r[qa],{shape:[n,s],episodes:o}=t.payoff,a=new Se,i=0;return e.then(l=>{let c=new Be(()=>a.show(kt(l,t,{run:qa,
pursuer:n-1,evader:s-1,episode:i++%o,seed:null}),`Generation ${n-1} of both teams`),a);c.renew(),fn(c,a.element)}),u("div",{class:"widget"},a.element,Fe(a.player),
or())}function Ya({evolve:r},e,{grows:t=!1}){let n=u("button",{type:"button",class:"evolve",disabled:!0},"Evolve"),s=u("progress",{max:1,value:0,"aria-label":"P\
rogress of the race"}),o=u("div",{class:"lanes","data-count":1});return e.then(a=>{let i=-1,l=()=>ca(r,{...la(r,ru),policy:"cells",seed:Math.max(0,i)}),c=new hr(
r,a,"lesson",l()),d=()=>{n.textContent=c.state==="waiting"?"Evolve":c.state==="evolving"?"Stop":"Again, with other luck",s.value=c.done};n.addEventListener("cli\
ck",()=>{if(c.state==="evolving")return c.stop();i++,c.start(l())}),c.addEventListener("state",d),t&&(c.element.querySelector("details").open=!0),o.append(c.element),
fn(c.chases,c.boards),n.disabled=!1}),u("div",{class:`widget evolving ${t?"grows":"boards"}`},u("div",{class:"buttons"},n,s),o)}function Za({runs:r,playground:e},t){
let n=r[0].payoff.shape.map(c=>c-1),s=new Ye({run:0,pursuer:n[0],evader:n[1],episode:0,seed:null}),o=new qe(r,s,e),a=new Ke(r,s);o.actions.remove(),a.element.addEventListener(
"play",()=>{o.playSoon(),o.reveal()}),t.then(c=>o.start(c));let{seed:i}=r[0],l=r[0].world;return u("div",{class:"widget wide"},Va(r,s),u("div",{class:"stages"},
a.element,o.element),u("p",{class:"small muted"},"Three races of ",u("code",{},`matrixworld evolve --seed ${i}`),`: ${l.n_pursuers} pursuers and ${l.n_evaders} \
evaders on ${l.rows} x ${l.cols} cells.`))}function Ja({runs:r}){let e=r[0],t=r[0].findings,[n,...s]=t.table,o=s.findIndex(([i])=>i==="arms race"),a={sentence:e.
name,table:[n,s[o]],reasons:[t.reasons[o]]};return u("div",{class:"widget text"},ja({...e,findings:{...t,...a}}).element)}var Sn=()=>{let[r]=crypto.getRandomValues(new Uint32Array(1));return{pupil:r.toString(16).padStart(8,"0"),choices:[],solved:{},exit:"",done:!1}},pr=class extends EventTarget{#e;#r;#t;keeps=!0;constructor(e){
super(),this.#r=e,this.#t=`matrixworld lesson ${e}`,this.#e=this.#n(),this.#a({})}choice=e=>this.#e.choices.find(({prediction:t})=>t===e)?.choice;choose(e,t){let n=new Date().
toISOString().replace(/\.\d+Z$/,"+00:00");this.#a({choices:[...this.#e.choices,{prediction:e,choice:t,time:n}]}),this.dispatchEvent(new CustomEvent("choice",{detail:e}))}solved=e=>this.#e.
solved[e];solve=(e,t)=>this.#a({solved:{...this.#e.solved,[e]:t}});get exit(){return this.#e}set exit(e){this.#a(e)}get count(){return this.#e.choices.length}get file(){
let{choices:e,pupil:t}=this.#e;return e.map(n=>`${JSON.stringify({...n,edition:this.#r,pupil:t})}
`).join("")}forget=()=>this.#a(Sn());#n(){try{return{...Sn(),...JSON.parse(localStorage.getItem(this.#t)??"{}")}}catch{return Sn()}}#a(e){this.#e={...this.#e,...e};
try{localStorage.setItem(this.#t,JSON.stringify(this.#e))}catch{this.keeps=!1}}};function Xa(r,e){let t=[],n=[];for(let i of r)try{n.push({...i,...nu(i.text,e)})}catch(l){t.push({file:i.name,reason:l.message})}let s=new Map([...e.predictions].
map(([i,{options:l}])=>[i,new Map(Object.keys(l).map(c=>[c,0]))])),o=new Map,a=new Map;for(let{name:i,text:l,pupil:c,choices:d}of n.sort((m,h)=>h.choices.size-m.
choices.size)){let m=[...d].filter(([p])=>!o.has(`${c} ${p}`)),h=a.get(l)??(m.length?void 0:o.get(`${c} ${[...d.keys()][0]}`));if(h!==void 0){t.push({file:i,reason:a.
has(l)?`double: the same content as ${h}`:`double: the pupil of ${h}`});continue}a.set(l,i);for(let[p,f]of m)o.set(`${c} ${p}`,i),s.get(p).set(f,s.get(p).get(f)+
1)}return{counts:s,pupils:new Set([...o.keys()].map(i=>i.split(" ")[0])).size,left:t}}function nu(r,{edition:e,predictions:t}){if(r===null)throw new Error("expe\
cted at most 65536 bytes");let n=new Map,s="",o=r.split(/\r?\n/).filter(a=>a.trim());if(!o.length)throw new Error("expected predictions that the lesson has save\
d, got an empty file");return o.forEach((a,i)=>{let l=su(a),{prediction:c,choice:d}=l;if(typeof c!="string"||typeof d!="string")throw new Error(`line ${i+1}: ex\
pected a prediction and its choice`);if(l.edition!==e)throw new Error(`line ${i+1}: expected edition ${e} of the course, got ${An(l.edition)}`);let m=t.get(c)?.
options;if(!m)throw new Error(`line ${i+1}: expected a prediction of the lesson, got ${An(c)}`);if(!Object.hasOwn(m,d))throw new Error(`line ${i+1}: expected on\
e of ${Object.keys(m).join(", ")} for ${c}, got ${An(d)}`);if(s||=String(l.pupil??""),!/^[0-9a-f]{8}$/.test(s)||l.pupil!==s)throw new Error(`line ${i+1}: expect\
ed lines of one pupil`);n.has(c)||n.set(c,d)}),{pupil:s,choices:n}}function su(r){try{let e=JSON.parse(r);return typeof e=="object"&&e!==null?e:{}}catch{return{}}}
var An=r=>r===void 0?"none":JSON.stringify(r).slice(0,40);function Qa(r){let e={edition:r.edition,predictions:Wt(r)},t=u("p",{role:"status"}),n=u("ul",{class:"left"}),s=u("div",{class:"questions"}),o=new Set,a=[],i=()=>{
let h=Xa(a,e);t.textContent=a.length?`${a.length} ${a.length===1?"file":"files"}, ${h.pupils} ${h.pupils===1?"pupil":"pupils"}.${h.left.length?" Not counted:":""}`:
"No files yet.",n.replaceChildren(...h.left.map(({file:p,reason:f})=>u("li",{},u("strong",{},p),` ${f}`))),s.replaceChildren(...[...e.predictions.values()].map(
p=>au(p,h,o,i)))},l=async h=>{let p=[...h].map(async f=>({name:f.name,text:f.size>65536?null:await f.text()}));a=[...a,...await Promise.all(p)],i()},c=u("input",
{type:"file",multiple:!0,accept:".jsonl",id:"vote-files",onchange:()=>{l(c.files).then(()=>c.value="")}}),d=u("button",{type:"button",onclick:()=>{a=[],o.clear(),
i()}},"Remove all files"),m=u("section",{class:"card drop","aria-label":"Files"},u("p",{},u("label",{for:"vote-files"},"Drop the files that your pupils have sav\
ed anywhere on this page, or choose them: ")),c,u("div",{class:"buttons"},t,d),n,u("p",{class:"small muted"},"A pupil saves predictions.jsonl at the end of the \
lesson. Names of files do not matter. Each pupil counts once: a second file of a pupil is named as double. Nothing leaves this computer."));document.addEventListener(
"dragover",h=>h.preventDefault()),document.addEventListener("drop",h=>{h.preventDefault(),l(h.dataTransfer?.files??[])}),document.getElementById("page").replaceWith(
Ft("How the class voted",u("span",{},`${r.title} `,u("a",{href:"#"},"Back to the lesson"))),u("main",{},m,s),u("footer",{class:"small muted"},`matrixworld ${r.version}\
, edition ${r.edition} of the course`)),i()}function au(r,e,t,n){let{predict:s,options:o,outcome:a}=r,i=e.counts.get(s),l=[...i.values()].reduce((p,f)=>p+f,0),c=t.
has(s),d=r.again?e.counts.get(r.again):void 0,m=Object.entries(o).map(([p,f])=>{let y=u("span",{class:"filled"});y.style.width=`${100*i.get(p)/Math.max(1,l)}%`;
let g=c&&p===a;return u("li",{class:g?"vote right":"vote"},u("span",{},`${p}. ${f}`,g&&u("strong",{}," ✓ the outcome")),u("span",{class:"bar","aria-hidden":"t\
rue"},y),u("span",{class:"numbers"},`${i.get(p)} of ${l}`,d&&u("span",{class:"muted"},`, at first ${d.get(p)}`)))}),h=u("button",{type:"button",id:`outcome-${s}`,
onclick:()=>{t.add(s),n()}},"Show the outcome");return u("section",{class:"card question",id:`votes-${s}`},u("h2",{},r.question),u("ul",{class:"of-votes"},...m),
r.later?u("p",{class:"muted"},r.later):c?u("div",{class:"reply"},...bt(r.explanation??"")):u("div",{},h))}var ei="#votes",iu=["explorer"],lu=r=>"needs"in r?r.needs:void 0,fr=r=>"widget"in r;function cu(r){let e=[];for(let t of r){let n=e.at(-1);!n||"text"in t||fr(t)&&
n.some(fr)?e.push([t]):n.push(t)}return e}function uu(r){let e=r.find(fr);return e&&r.length>1&&!iu.includes(e.widget)&&!e.grows?"block beside":"block"}var Mn=class{#e;#r;#t=()=>{};#n=new Promise(
e=>this.#t=e);#a={chase:()=>Ka(this.#e,this.#n),evolving:e=>Ya(this.#e,this.#n,e),"right-of-way":_o,flat:Po,hands:Ho,"hands-matrix":zo,games:qo,numbers:Ko,matrices:()=>Ro(
this.#e),explorer:()=>Za(this.#e,this.#n),judgement:()=>Ja(this.#e),"same-diagonal":$o,exit:e=>ea(e,this.#r)};constructor(e){this.#e=e,this.#r=new pr(e.edition);
let t=this.#r,n=Wt(e).size,s=u("span",{class:"small muted",role:"status"}),o=()=>{let i=t.keeps?"They stay in this browser.":"This browser keeps nothing: save b\
efore you close the page.";s.textContent=`${t.count} of ${n} predictions made. ${i}`};t.addEventListener("choice",o);let a=()=>{confirm("Delete all predictions \
and answers in this browser, for another student? Save them first.")&&(t.forget(),location.reload())};document.getElementById("page").replaceWith(Ft(e.title,e.lead),
u("nav",{class:"sections","aria-label":"Sections"},...e.sections.map((i,l)=>u("a",{href:`#${i.id}`},`${l+1}. ${i.title}`))),u("main",{},...e.sections.map((i,l)=>this.#l(
i,l))),u("footer",{class:"card"},u("div",{class:"buttons"},u("button",{type:"button",class:"primary save",onclick:()=>It("predictions.jsonl",t.file)},"Save my p\
redictions"),u("button",{type:"button",onclick:()=>print()},"Print"),u("button",{type:"button",onclick:a},"Start anew"),s),u("p",{class:"small muted"},`The page\
 sends nothing anywhere. matrixworld ${e.version}, edition ${e.edition} of the course. Teachers: `,u("a",{href:ei},"count the votes of a class"),"."))),o()}async load(){
this.#t(await Ot())}#s(e){return"text"in e?u("div",{class:"text"},...bt(e.text)):fr(e)?this.#a[e.widget](e):"exercise"in e?Qo(e,this.#r):Xo(e,this.#r)}#l(e,t){let{
sections:n}=this.#e,s=u("p",{class:"waiting muted",role:"status"}),o=u("section",{class:"card",id:e.id,"aria-labelledby":`title-${e.id}`},u("h2",{id:`title-${e.
id}`},`${t+1}. ${e.title}`,u("span",{class:"muted small"},`${e.minutes} minutes`)),s),a=cu(e.parts),i=a.map(m=>u("div",{class:uu(m)})),l=a.flatMap((m,h)=>m.map(
()=>i[h])),c=0,d=()=>{for(s.textContent="";c<e.parts.length;c++){let m=e.parts[c-1],h=e.parts[c],p=[Dt(m)?m.predict:void 0,lu(h)].find(f=>f&&this.#r.choice(f)===
void 0);if(p){let f=n.findIndex(({parts:y})=>y.some(g=>Dt(g)&&g.predict===p));s.textContent=`This section goes on with your prediction${f===t?"":` in section ${f+
1}`}.`;return}s.before(l[c]),l[c].append(this.#s(h))}s.remove()};return this.#r.addEventListener("choice",d),d(),o}};function du(){let r=Ds(),e=()=>location.hash===
ei,t=e();if(window.addEventListener("hashchange",()=>e()!==t&&location.reload()),t)return void Vr(Promise.resolve(Qa(r)));let n=new Mn(r);requestAnimationFrame(
()=>setTimeout(()=>Vr(n.load())))}typeof document>"u"?jr(globalThis):du();})();
