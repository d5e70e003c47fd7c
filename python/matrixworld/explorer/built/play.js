/* built from web/ by "npm run build"; sources c99b4cbc7e8f386e30086535a47dfe8b0750db1db9febff8e06f1c5f2b5c9625 */
"use strict";(()=>{var lr={SIMULTANEOUS:0,SWARM_TURNS:1,AGENT_TURNS:2},$e={DISAPPEAR:0,REACH:1,BOUNCE:2},ur={OCCUPATION:0,SURROUND:1},cr={FAULT:0,INVOLVED:1};var wt=["obstacle","teammate","adversary"],xt=["vertex","edge","chain"],mr=["turn","kind","form","first","second","row","col","at_fault","held","doomed"],At=["p\
ursuer_{number}","evader_{number}"],fr={obstacle:"{first} ran into the obstacle or border at {cell}",vertex:"{first} and {second} both headed for {cell}",edge:"\
{first} and {second} meant to swap, {first} to {cell}",chain:"{first} headed for {cell}, where {second} had to stay"},Ue={"both held":"both bounce","both doomed":"\
both disappear",held:"{agent} bounces",doomed:"{agent} disappears",none:"nobody is stopped"},pr="{event}: {outcome}",St={random:"any action, all equally likely",
still:"always stays",chaser:"moves to where the nearest adversary in view is nearest",fleer:"moves to where the nearest adversary in view is farthest","clumsy-c\
haser":"a chaser that takes any action in half of the steps",hunter:"a chaser of the nearest adversary in view to which no teammate in view is nearer",surrounder:"\
a chaser of the nearest free cell beside an adversary without a teammate","clumsy-fleer":"a fleer that takes any action in half of the steps",dodger:"moves to w\
here all adversaries in view together are farthest","team-surrounder":"shares the free cells beside adversaries with its teammates, and searches","careful-rando\
m":"as random, but takes only moves that right of way allows","careful-chaser":"as chaser, but takes only moves that right of way allows","careful-fleer":"as fl\
eer, but takes only moves that right of way allows","careful-clumsy-chaser":"as clumsy-chaser, but takes only moves that right of way allows","careful-hunter":"\
as hunter, but takes only moves that right of way allows","careful-surrounder":"as surrounder, but takes only moves that right of way allows","careful-clumsy-fl\
eer":"as clumsy-fleer, but takes only moves that right of way allows","careful-dodger":"as dodger, but takes only moves that right of way allows","careful-team-\
surrounder":"as team-surrounder, but takes only moves that right of way allows"},hr={free:".GS",blocked:"#@OTW"};var Ae=1+mr.length;function ze(t,e){return t.replace(/\{(\w+)\}/g,(r,n)=>String(e[n]))}function q(t,e){return t<e?ze(At[0],{number:t}):ze(At[1],{number:t-e})}function Oo(t,e){
let[r,n,o,s,a,i,l,...u]=Array.from(t),c=a<0?[s]:[s,a],[m,f,h]=u.map(w=>c.filter((S,v)=>w>>v&1)),y=c.map(w=>q(w,e)),d=ze(fr[a<0?"obstacle":xt[o]],{first:y[0],second:y[y.
length-1],cell:`(${i}, ${l})`}),g=ze(pr,{event:d,outcome:No(c.length,f,h,e)});return{kind:wt[n],form:xt[o],agents:c,cell:[i,l],at_fault:m,held:f,doomed:h,turn:r,
text:g}}function No(t,e,r,n){if(t===2&&e.length===2)return Ue["both held"];if(t===2&&r.length===2)return Ue["both doomed"];let o=s=>a=>ze(Ue[s],{agent:q(a,n)});
return[...e.map(o("held")),...r.map(o("doomed"))].join(", ")||Ue.none}function Xe(t,e){let r=[];for(let n=0;n<t.length;n+=Ae)r.push(Oo(t.subarray(n+1,n+Ae),e));
return r}var Y=class extends Error{name="EngineError"};function P(t,e,r){let n=typeof r=="string"?`'${r}'`:typeof r=="object"?JSON.stringify(r):String(r);return new Y(`${t}\
: expected ${e}, got ${n}`)}var Se=class{bytes;constructor(e){this.bytes=e}},gr=0,Tt=[Uint8Array,Uint8Array,Int32Array,BigInt64Array,BigUint64Array,Float32Array,Float64Array],dr=4,yr=4,Po=new TextEncoder,
Io=new TextDecoder;function Lo(t){for(let e=Tt.length-1;e>gr;--e)if(t instanceof Tt[e])return e;throw new TypeError("array: expected a typed array of the engine\
's numbers, got another")}function Mt(t){return new Uint8Array(t.buffer,t.byteOffset,t.byteLength)}function $o(t){return Po.encode(`${t}\0`)}var Ct=class{engine;addresses=[];constructor(e){
this.engine=e}copy(e){let r=this.engine._malloc(Math.max(e.length,1));if(r===0)throw new Y("memory: expected room for the arguments, got none");return this.addresses.
push(r),this.engine.HEAPU8.set(e,r),r}text(e){return this.copy($o(e))}arrays(e){let r=Object.entries(e),n=r.flatMap(([s,a])=>{let i=a instanceof Se,l=i?a.bytes:
a;return[this.text(s),i?gr:Lo(l),l.length,this.copy(Mt(l))]}),o=this.copy(Mt(Int32Array.from(n)));return this.copy(Mt(Int32Array.of(r.length,o)))}free(){for(let e of this.
addresses)this.engine._free(e)}};function vr(t,e){let r=t.HEAPU8;return Io.decode(r.subarray(e,r.indexOf(0,e)))}function Me(t){let e=new Int32Array(t.HEAPU8.buffer),
r=t._last_outputs()/dr,n=e[r+1]/dr,o={};for(let s=n;s<n+e[r]*yr;s+=yr){let a=Tt[e[s+1]],i=e[s+2]*a.BYTES_PER_ELEMENT,l=e[s+3];o[vr(t,e[s])]=new a(t.HEAPU8.slice(
l,l+i).buffer)}return o}function ue(t,e){let r=new Ct(t);try{let n=e(r);if(n===0)throw new Y(vr(t,t._last_error()));return n}finally{r.free()}}var Uo=2**31-1,br=["none","gru"],zo=2n**64n-1n,Fo=34028234663852886e22;function se(t,e){if(typeof e!="number"||!Number.isInteger(e)||Math.abs(e)>Uo)throw P(t,"a\
n integer",e);return Int32Array.of(e)}function Qe(t,e){if(typeof e!="boolean")throw P(t,"true or false",e);return new Se(Uint8Array.of(Number(e)))}function he(t,e,r){
let n=typeof e=="string"&&Object.hasOwn(r,e)?r[e]:void 0;if(n===void 0)throw P(t,`one of ${Object.keys(r).join(", ")}`,e);return Int32Array.of(n)}function Et(t,e){
if(typeof e!="number"||!(Math.abs(e)<=Fo))throw P(t,"a finite number",e);return e}function Te(t,e){let n=typeof e=="bigint"||typeof e=="number"&&Number.isSafeInteger(
e)?BigInt(e):-1n;if(n<0n||n>zo)throw P(t,"an integer from 0 to 2^64 - 1",e);return BigUint64Array.of(n)}function Wo(t){return{"rules.interaction":he("interactio\
n",t.interaction,lr),"rules.obstacle":he("obstacle",t.obstacle,$e),"rules.teammate":he("teammate",t.teammate,$e),"rules.evader":he("evader",t.evader,$e),"rules.\
pursuer":he("pursuer",t.pursuer,$e),"rules.capture":he("capture",t.capture,ur),"rules.captured_disappear":Qe("captured_disappear",t.captured_disappear)}}function wr(t,e){
let r=typeof e=="number"?[e,e,e]:e;if(!Array.isArray(r)||r.length!==3)throw P(t,"1 or 3 numbers",e);return Float32Array.from(r,n=>Et(t,n))}function Do(t){let e=(r,n)=>Float32Array.
of(Et(r,t[r]),Et(n,t[n]));return{"rewards.capture":e("pursuer_capture","evader_capture"),"rewards.neighbor":e("pursuer_neighbor","evader_neighbor"),"rewards.ste\
p":e("pursuer_step","evader_step"),"rewards.pursuer_collide":wr("pursuer_collide",t.pursuer_collide),"rewards.evader_collide":wr("evader_collide",t.evader_collide),
"rewards.blame":he("blame",t.blame,cr),"rewards.capture_repeats":Qe("capture_repeats",t.capture_repeats)}}function Ar(t){if(t===void 0||typeof t=="number")return new Uint8Array(
0);if(t instanceof Uint8Array)return t;let{free:e,blocked:r}=hr;for(let[n,o]of t.entries()){if(o.length!==t[0]?.length)throw P(`map, row ${n}`,`${t[0]?.length} \
cells as in row 0`,o.length);let s=[...o].find(a=>!e.includes(a)&&!r.includes(a));if(s)throw P(`map, row ${n}`,`'${e}' (free) or '${r}' (obstacle)`,s)}return Uint8Array.
from([...t.join("")],n=>Number(r.includes(n)))}function Sr(t,e){if(!Array.isArray(t))return;let r=[t.length,t[0]?.length??0];if(!(r[0]===e.rows&&r[1]===e.cols))
throw P("obstacle map",`shape (${e.rows}, ${e.cols}), the rows and cols`,r)}function Ce(t){Sr(t.obstacles,t);let e=typeof t.obstacles=="number"?t.obstacles:0;return{
...Wo(t.rules),...Do(t.rewards),rows:se("rows",t.rows),cols:se("cols",t.cols),n_pursuers:se("n_pursuers",t.n_pursuers),n_evaders:se("n_evaders",t.n_evaders),fov:se(
"fov",t.fov),diagonal:Qe("diagonal",t.diagonal),max_steps:se("max_steps",t.max_steps),density:Float64Array.of(e),map:Ar(t.obstacles)}}function xr(t,e){return Int32Array.
from((e??[]).flat(),r=>se(t,r)[0])}function Mr(t,e){return Sr(t.obstacles,e),{seed:Te("seed",t.seed??0n),episode:Te("episode",t.episode??0),pursuers:xr("pursuer\
s",t.pursuers),evaders:xr("evaders",t.evaders),map:Ar(t.obstacles)}}function et(t){return{actions:Int32Array.from(t,e=>se("actions",e)[0])}}function ce(t){if(typeof t==
"string"){if(!Object.hasOwn(St,t))throw P("policy",`one of ${Object.keys(St).join(", ")}`,t);return{script:new TextEncoder().encode(t)}}if(t.activation!=="relu"&&
t.activation!=="tanh")throw P("activation","'relu' or 'tanh'",t.activation);if(!br.includes(t.memory))throw P("memory",`one of ${br.join(", ")}`,t.memory);return{
hidden:Int32Array.from(t.hidden,e=>se("hidden",e)[0]),activation:new TextEncoder().encode(t.activation),sampled:Qe("sampled",t.sampled),memory:new TextEncoder().
encode(t.memory),genome:t.genome}}var Bo=["first_turn","terminated","truncated"];function Tr(t){let e={...t};for(let r of Bo)e[r]=new Se(t[r]);return e}var Cr="statistics.",tt=class{config;seed;episode;n_agents;statistics;first_conflict;constructor(e,r,n,o){this.config=e,this.seed=r,this.episode=n,this.n_agents=
e.n_pursuers+e.n_evaders,this.statistics=Er(_r(o),0),Object.assign(this,o),this.first_conflict=Go(this.conflict_table,this.length)}get length(){return this.actions.
length/this.n_agents}conflicts(e){this.check(e);let[r,n]=[this.first_conflict[e],this.first_conflict[e+1]],o=this.conflict_table.subarray(r*Ae,n*Ae);return Xe(o,
this.config.n_pursuers)}seek(e,r,n){this.check(r),(!(e.seed===this.seed&&e.episode===BigInt(this.episode))||e.turn!==0||e.steps>r)&&e.reset({seed:this.seed,episode:this.
episode});for(let s=e.steps;s<r;++s){let a=this.actions.subarray(s*this.n_agents,(s+1)*this.n_agents);n?e.replay(a,{pursuer:n.pursuers,evader:n.evaders}):e.step(
a)}}check(e){if(!(Number.isInteger(e)&&e>=0&&e<=this.length))throw P("step",`0 to ${this.length}`,e)}};function Go(t,e){let r=new Int32Array(e+2);for(let n=0;n<
t.length;n+=Ae)++r[t[n]+1];for(let n=1;n<r.length;++n)r[n]+=r[n-1];return r}function Er(t,e){let r=t.length.length,n=s=>{let a=t[s],i=a.length/r;return a.slice(
e*i,(e+1)*i)},o=s=>Number(n(s)[0]);return{capture_rate:o("capture_rate"),ever_capture_rate:o("ever_capture_rate"),captured_fraction:o("captured_fraction"),length:o(
"length"),return:n("return"),survivors:n("survivors"),overlap:n("overlap"),collisions:n("collisions"),faults:n("faults"),agent_steps:n("agent_steps")}}var _r=t=>Object.
fromEntries(Object.entries(t).flatMap(([e,r])=>e.startsWith(Cr)?[[e.slice(Cr.length),r]]:[]));function kr(t,e,r,n){let o=[Ce(r.config),ce(r.pursuers),ce(r.evaders),
n];return ue(t,s=>{let[a,i,l,u]=o.map(c=>s.arrays(c));return t[e](a,i,l,u)}),Me(t)}function Rr(t,e,r,n){let o={seed:Te("seed",r),episode:Te("episode",n)};return new tt(
e.config,r,n,kr(t,"_play_match",e,o))}function _t(t,e,r,n){if(!Number.isInteger(n)||n<1)throw P("n_episodes","at least 1",n);let o=kr(t,"_play_rollout",e,{...r,
n_episodes:Int32Array.of(n)});return _r(o)}function Or(t,e,r,n){let o={pursuer:Int32Array.of(0),evader:Int32Array.of(0),seed:Te("seed",r)},s=_t(t,e,o,n);return Array.
from({length:n},(a,i)=>Er(s,i))}var Ho=7e6,jo=new FinalizationRegistry(([t,e])=>t._states_free(e));function Vo({rules:t,rows:e,cols:r,obstacles:n,diagonal:o,n_pursuers:s,n_evaders:a}){let i=typeof n==
"number"||t.obstacle==="REACH"?0:n.join("").split("#").length-1,l=e*r-i,u=[t.obstacle,t.teammate,t.pursuer].includes("DISAPPEAR"),c=t.capture==="SURROUND"||t.evader===
"REACH",m=t.interaction==="AGENT_TURNS",f=(d,g)=>Array.from({length:g},(w,S)=>m?d:(d+S)/(S+1)).reduce((w,S)=>w*S,1),h=f(l+Number(u),s)*f(l*(1+Number(c))+2,a);return{
SIMULTANEOUS:[s+a],SWARM_TURNS:[s,a],AGENT_TURNS:Array(s+a).fill(1)}[t.interaction].reduce((d,g)=>d+h*(o?9:5)**g,0)}function rt(t){return typeof t.obstacles=="n\
umber"&&t.obstacles>0?"obstacles are drawn anew in each episode":Vo(t)>Ho?"the world is too large to be solved on the page":""}var kt=class{value;teams;matrix;n_actions;constructor(e,r){
let{matrix:n,rows:o,cols:s,value:a,agents:i}=r,[l,u]=e.actors,c=Array.from(i).filter(f=>l<=f&&f<u),m=f=>f<e.config.n_pursuers;[this.value,this.matrix,this.n_actions]=
[a[0],n,e.n_actions],this.teams=[{agents:c.filter(m),play:o},{agents:c.filter(f=>!m(f)),play:s}]}marginal(e){let r=this.teams.find(({agents:s})=>s.includes(e));
if(!r)return null;let n=this.n_actions**(r.agents.length-1-r.agents.indexOf(e)),o=Array(this.n_actions).fill(0);return r.play.forEach((s,a)=>o[Math.floor(a/n)%this.
n_actions]+=s),o}lost(e){let[r,n]=this.teams.map(({agents:l})=>l.reduce((u,c)=>u*this.n_actions+e[c],0)),[o,s]=this.teams.map(({play:l})=>l),a=s.reduce((l,u,c)=>l+
u*this.matrix[r*s.length+c],0),i=o.reduce((l,u,c)=>l+u*this.matrix[c*s.length+n],0);return[Math.max(0,this.value-a),Math.max(0,i-this.value)]}},Rt=60,Fe=class{config;payoff;engine;states;n_turns;values;starts;constructor(e,r,n){
[this.engine,this.config,this.payoff]=[e,r,n],this.states=ue(e,l=>e._states_new(l.arrays(Ce(r)))),jo.register(this,[e,this.states]);let o={SIMULTANEOUS:1,SWARM_TURNS:2,
AGENT_TURNS:r.n_pursuers+r.n_evaders};this.n_turns=o[r.rules.interaction];let{payoffs:s,starts:a}=this.call(()=>e._states_payoffs(this.states)),i=s;this.starts=
a,this.values=[[n==="capture-rate"?i:i.fill(0)]]}goBack(){let e=this.values.at(-1)[0],r=[];for(let o=this.n_turns-1;o>=0;o--){let s=r[o+1]??e;r[o]=this.backup(o,
{next:s})}this.payoff==="capture-time"&&(r[0]=r[0].map((o,s)=>s===this.config.n_evaders?0:o-1)),this.values.push(r);let n=this.payoff==="capture-rate"?this.config.
max_steps:Math.min(this.config.max_steps,Rt);return this.values.length<=n&&r[0].some((o,s)=>o!==e[s])}get value(){return this.mean(this.values.at(-1)[0])}guaranteed(e,r){
let n=ce(r),o=Array.from({length:this.n_turns},(a,i)=>this.call(l=>this.engine._states_weigh(this.states,i,+(e==="evader"),l.arrays(n))).play),s=this.values[0][0];
for(let a=0;a<this.config.max_steps;a++){let i=s;for(let l=this.n_turns-1;l>=0;l--)s=this.backup(l,{next:s,[`${e}s`]:o[l]});if(s.every((l,u)=>l===i[u]))break}return this.
mean(s)}mean(e){return this.starts.reduce((r,n)=>r+e[n],0)/this.starts.length}backup(e,r){return this.call(n=>this.engine._states_backup(this.states,e,n.arrays(
r))).values}game(e){let[r,{turn:n}]=[this.config.max_steps-e.steps,e],o=n+1===this.n_turns,s=r>0?this.values[Math.min(r-Number(o),this.values.length-1)]?.[o?0:n+
1]:void 0;if(!s)return null;let a=this.call(i=>this.engine._states_game(this.states,e.address,i.arrays({next:s})));return a.agents.length?new kt(e,a):null}call(e){
return ue(this.engine,e),Me(this.engine)}};var Nr=new FinalizationRegistry(([t,e])=>t._world_free(e)),We=class{config;n_agents;n_actions;engine;at;freed=!1;constructor(e,r){this.engine=e,this.config=r,this.
n_agents=r.n_pursuers+r.n_evaders,this.n_actions=r.diagonal?9:5,this.at=ue(e,n=>e._world_new(n.arrays(Ce(r)))),Nr.register(this,[e,this.at],this)}free(){this.freed||
(this.freed=!0,Nr.unregister(this),this.engine._world_free(this.at))}get address(){if(this.freed)throw P("world","one that is in use","one that was freed");return this.
at}reset(e={}){let r=Mr(e,this.config);this.call(n=>this.engine._world_reset(this.address,n.arrays(r)))}step(e){let r=et(e);this.call(n=>this.engine._world_step(
this.address,n.arrays(r)))}playTurn(e){let r=et(e);this.call(n=>this.engine._world_play_turn(this.address,n.arrays(r)))}decide(e,r,n){let{n_pursuers:o}=this.config,
s={pursuer:[0,o],evader:[o,this.n_agents]},[a,i]=typeof r=="string"?s[r]:r;if(n.length!==this.n_agents)throw P("actions",String(this.n_agents),n.length);let l=[
ce(e),et(n)],{actions:u}=this.call(c=>this.engine._world_decide(this.address,c.arrays(l[0]),a,i,c.arrays(l[1])));return Uint8Array.from(u)}replay(e,r){let n=s=>typeof s!=
"string"&&s.memory!=="none";if(!n(r.pursuer)&&!n(r.evader))return this.step(e);let{n_pursuers:o}=this.config;for(let s=this.n_turns;s>0;--s){let[a,i]=this.actors;
a<o&&this.decide(r.pursuer,[a,Math.min(i,o)],e),i>o&&this.decide(r.evader,[Math.max(a,o),i],e),this.playTurn(e)}}get n_turns(){return this.turnNumbers()[1]}get turn(){
return this.turnNumbers()[0]}get actors(){let[,,e,r]=this.turnNumbers();return[e,r]}turnNumbers(){return this.call(()=>this.engine._world_turn(this.address)).turn}get steps(){
return this.read("steps")[0]}get seed(){return this.read("seed")[0]}get episode(){return this.read("episode")[0]}get over(){return this.read("terminated")[0]===
1||this.read("truncated")[0]===1}read(e){return this.call(r=>this.engine._world_read(this.address,r.text(e)))[e]}view(e){let r=3*this.config.fov**2;return this.
read("views").slice(e*r,(e+1)*r)}map(){return this.read("state").slice(2*this.config.rows*this.config.cols)}conflicts(){return Xe(this.conflictTable(),this.config.
n_pursuers)}conflictTable(){return this.call(()=>this.engine._world_conflicts(this.address)).conflict_table}answer(e,r){let n=ce(e),{logits:o,memory:s}=this.call(
l=>this.engine._world_logits(this.address,l.arrays(n),r)),a=o,i=this.decide(e,[r,r+1],new Uint8Array(this.n_agents))[r];return{logits:a,probabilities:Yo(a),action:i,
memory:s}}snapshot(){return this.call(()=>this.engine._world_snapshot(this.address))}restore(e){let r=Tr(e);this.call(n=>this.engine._world_restore(this.address,
n.arrays(r)))}call(e){return ue(this.engine,e),Me(this.engine)}};function Yo(t){let e=Math.max(...t),r=Array.from(t,o=>Math.exp(o-e)),n=r.reduce((o,s)=>o+s,0);return Float32Array.
from(r,o=>o/n)}var Ot=class{compiled;constructor(e){this.compiled=e}world(e){return new We(this.compiled,e)}solution(e,r="capture-rate"){return new Fe(this.compiled,e,r)}match(e,r,n,o,s=0){
return Rr(this.compiled,{config:e,pursuers:r,evaders:n},o,s)}rollout(e,r,n,o,s){return Or(this.compiled,{config:e,pursuers:r,evaders:n},o,s)}rollouts(e,r,n,o,s){
return _t(this.compiled,{config:e,pursuers:r,evaders:n},o,s)}},Pr;function Ir(t=globalThis.matrixworldEngine){return Pr??=Ko(t),Pr}async function Ko(t){if(!t)throw new Error(
"matrixworldEngine: expected the script engine.js before this one, got none");let e=Uint8Array.from(atob(t.binary),r=>r.charCodeAt(0));return new Ot(await t({wasmBinary:e}))}var T=Uint8Array,j=Uint16Array,Bt=Int32Array,ot=new T([0,0,0,0,0,0,0,0,1,1,1,1,2,2,2,2,3,3,3,3,4,4,4,4,5,5,5,5,0,0,0,0]),st=new T([0,0,0,0,1,1,2,2,3,3,4,4,5,5,6,
6,7,7,8,8,9,9,10,10,11,11,12,12,13,13,0,0]),$t=new T([16,17,18,0,8,7,9,6,10,5,11,4,12,3,13,2,14,1,15]),Wr=function(t,e){for(var r=new j(31),n=0;n<31;++n)r[n]=e+=
1<<t[n-1];for(var o=new Bt(r[30]),n=1;n<30;++n)for(var s=r[n];s<r[n+1];++s)o[s]=s-r[n]<<5|n;return{b:r,r:o}},Dr=Wr(ot,2),Br=Dr.b,Ut=Dr.r;Br[28]=258,Ut[258]=28;var Gr=Wr(
st,0),Zo=Gr.b,Lr=Gr.r,zt=new j(32768);for(M=0;M<32768;++M)ae=(M&43690)>>1|(M&21845)<<1,ae=(ae&52428)>>2|(ae&13107)<<2,ae=(ae&61680)>>4|(ae&3855)<<4,zt[M]=((ae&65280)>>
8|(ae&255)<<8)>>1;var ae,M,re=(function(t,e,r){for(var n=t.length,o=0,s=new j(e);o<n;++o)t[o]&&++s[t[o]-1];var a=new j(e);for(o=1;o<e;++o)a[o]=a[o-1]+s[o-1]<<1;
var i;if(r){i=new j(1<<e);var l=15-e;for(o=0;o<n;++o)if(t[o])for(var u=o<<4|t[o],c=e-t[o],m=a[t[o]-1]++<<c,f=m|(1<<c)-1;m<=f;++m)i[zt[m]>>l]=u}else for(i=new j(
n),o=0;o<n;++o)t[o]&&(i[o]=zt[a[t[o]-1]++]>>15-t[o]);return i}),me=new T(288);for(M=0;M<144;++M)me[M]=8;var M;for(M=144;M<256;++M)me[M]=9;var M;for(M=256;M<280;++M)
me[M]=7;var M;for(M=280;M<288;++M)me[M]=8;var M,Ge=new T(32);for(M=0;M<32;++M)Ge[M]=5;var M,qo=re(me,9,0),Jo=re(me,9,1),Xo=re(Ge,5,0),Qo=re(Ge,5,1),Nt=function(t){
for(var e=t[0],r=1;r<t.length;++r)t[r]>e&&(e=t[r]);return e},J=function(t,e,r){var n=e/8|0;return(t[n]|t[n+1]<<8)>>(e&7)&r},Pt=function(t,e){var r=e/8|0;return(t[r]|
t[r+1]<<8|t[r+2]<<16)>>(e&7)},Gt=function(t){return(t+7)/8|0},He=function(t,e,r){return(e==null||e<0)&&(e=0),(r==null||r>t.length)&&(r=t.length),new T(t.subarray(
e,r))};var es=["unexpected EOF","invalid block type","invalid length/literal","invalid distance","stream finished","no stream handler",,"no callback","invalid UTF-8 da\
ta","extra field too long","date not in range 1980-2099","filename too long","stream finishing","invalid zip data"],z=function(t,e,r){var n=new Error(e||es[t]);
if(n.code=t,Error.captureStackTrace&&Error.captureStackTrace(n,z),!r)throw n;return n},Hr=function(t,e,r,n){var o=t.length,s=n?n.length:0;if(!o||e.f&&!e.l)return r||
new T(0);var a=!r,i=a||e.i!=2,l=e.i;a&&(r=new T(o*3));var u=function(Ie){var Le=r.length;if(Ie>Le){var xe=new T(Math.max(Le*2,Ie));xe.set(r),r=xe}},c=e.f||0,m=e.
p||0,f=e.b||0,h=e.l,y=e.d,d=e.m,g=e.n,w=o*8;do{if(!h){c=J(t,m,1);var S=J(t,m+1,3);if(m+=3,S)if(S==1)h=Jo,y=Qo,d=9,g=5;else if(S==2){var O=J(t,m,31)+257,R=J(t,m+
10,15)+4,x=O+J(t,m+5,31)+1;m+=14;for(var b=new T(x),I=new T(19),N=0;N<R;++N)I[$t[N]]=J(t,m+N*3,7);m+=R*3;for(var F=Nt(I),le=(1<<F)-1,B=re(I,F,1),N=0;N<x;){var W=B[J(
t,m,le)];m+=W&15;var v=W>>4;if(v<16)b[N++]=v;else{var L=0,_=0;for(v==16?(_=3+J(t,m,3),m+=2,L=b[N-1]):v==17?(_=3+J(t,m,7),m+=3):v==18&&(_=11+J(t,m,127),m+=7);_--;)
b[N++]=L}}var D=b.subarray(0,O),$=b.subarray(O);d=Nt(D),g=Nt($),h=re(D,d,1),y=re($,g,1)}else z(1);else{var v=Gt(m)+4,A=t[v-4]|t[v-3]<<8,E=v+A;if(E>o){l&&z(0);break}
i&&u(f+A),r.set(t.subarray(v,E),f),e.b=f+=A,e.p=m=E*8,e.f=c;continue}if(m>w){l&&z(0);break}}i&&u(f+131072);for(var Pe=(1<<d)-1,V=(1<<g)-1,oe=m;;oe=m){var L=h[Pt(
t,m)&Pe],G=L>>4;if(m+=L&15,m>w){l&&z(0);break}if(L||z(2),G<256)r[f++]=G;else if(G==256){oe=m,h=null;break}else{var H=G-254;if(G>264){var N=G-257,k=ot[N];H=J(t,m,
(1<<k)-1)+Br[N],m+=k}var ee=y[Pt(t,m)&V],be=ee>>4;ee||z(3),m+=ee&15;var $=Zo[be];if(be>3){var k=st[be];$+=Pt(t,m)&(1<<k)-1,m+=k}if(m>w){l&&z(0);break}i&&u(f+131072);
var we=f+H;if(f<$){var qe=s-$,Je=Math.min($,we);for(qe+f<0&&z(3);f<Je;++f)r[f]=n[qe+f]}for(;f<we;++f)r[f]=r[f-$]}}e.l=h,e.p=oe,e.b=f,e.f=c,h&&(c=1,e.m=d,e.d=y,e.
n=g)}while(!c);return f!=r.length&&a?He(r,0,f):r.subarray(0,f)},ie=function(t,e,r){r<<=e&7;var n=e/8|0;t[n]|=r,t[n+1]|=r>>8},De=function(t,e,r){r<<=e&7;var n=e/
8|0;t[n]|=r,t[n+1]|=r>>8,t[n+2]|=r>>16},It=function(t,e){for(var r=[],n=0;n<t.length;++n)t[n]&&r.push({s:n,f:t[n]});var o=r.length,s=r.slice();if(!o)return{t:Vr,
l:0};if(o==1){var a=new T(r[0].s+1);return a[r[0].s]=1,{t:a,l:1}}r.sort(function(E,O){return E.f-O.f}),r.push({s:-1,f:25001});var i=r[0],l=r[1],u=0,c=1,m=2;for(r[0]=
{s:-1,f:i.f+l.f,l:i,r:l};c!=o-1;)i=r[r[u].f<r[m].f?u++:m++],l=r[u!=c&&r[u].f<r[m].f?u++:m++],r[c++]={s:-1,f:i.f+l.f,l:i,r:l};for(var f=s[0].s,n=1;n<o;++n)s[n].s>
f&&(f=s[n].s);var h=new j(f+1),y=Ft(r[c-1],h,0);if(y>e){var n=0,d=0,g=y-e,w=1<<g;for(s.sort(function(O,R){return h[R.s]-h[O.s]||O.f-R.f});n<o;++n){var S=s[n].s;
if(h[S]>e)d+=w-(1<<y-h[S]),h[S]=e;else break}for(d>>=g;d>0;){var v=s[n].s;h[v]<e?d-=1<<e-h[v]++-1:++n}for(;n>=0&&d;--n){var A=s[n].s;h[A]==e&&(--h[A],++d)}y=e}return{
t:new T(h),l:y}},Ft=function(t,e,r){return t.s==-1?Math.max(Ft(t.l,e,r+1),Ft(t.r,e,r+1)):e[t.s]=r},$r=function(t){for(var e=t.length;e&&!t[--e];);for(var r=new j(
++e),n=0,o=t[0],s=1,a=function(l){r[n++]=l},i=1;i<=e;++i)if(t[i]==o&&i!=e)++s;else{if(!o&&s>2){for(;s>138;s-=138)a(32754);s>2&&(a(s>10?s-11<<5|28690:s-3<<5|12305),
s=0)}else if(s>3){for(a(o),--s;s>6;s-=6)a(8304);s>2&&(a(s-3<<5|8208),s=0)}for(;s--;)a(o);s=1,o=t[i]}return{c:r.subarray(0,n),n:e}},Be=function(t,e){for(var r=0,
n=0;n<e.length;++n)r+=t[n]*e[n];return r},jr=function(t,e,r){var n=r.length,o=Gt(e+2);t[o]=n&255,t[o+1]=n>>8,t[o+2]=t[o]^255,t[o+3]=t[o+1]^255;for(var s=0;s<n;++s)
t[o+s+4]=r[s];return(o+4+n)*8},Ur=function(t,e,r,n,o,s,a,i,l,u,c){ie(e,c++,r),++o[256];for(var m=It(o,15),f=m.t,h=m.l,y=It(s,15),d=y.t,g=y.l,w=$r(f),S=w.c,v=w.n,
A=$r(d),E=A.c,O=A.n,R=new j(19),x=0;x<S.length;++x)++R[S[x]&31];for(var x=0;x<E.length;++x)++R[E[x]&31];for(var b=It(R,7),I=b.t,N=b.l,F=19;F>4&&!I[$t[F-1]];--F)
;var le=u+5<<3,B=Be(o,me)+Be(s,Ge)+a,W=Be(o,f)+Be(s,d)+a+14+3*F+Be(R,I)+2*R[16]+3*R[17]+7*R[18];if(l>=0&&le<=B&&le<=W)return jr(e,c,t.subarray(l,l+u));var L,_,D,
$;if(ie(e,c,1+(W<B)),c+=2,W<B){L=re(f,h,0),_=f,D=re(d,g,0),$=d;var Pe=re(I,N,0);ie(e,c,v-257),ie(e,c+5,O-1),ie(e,c+10,F-4),c+=14;for(var x=0;x<F;++x)ie(e,c+3*x,
I[$t[x]]);c+=3*F;for(var V=[S,E],oe=0;oe<2;++oe)for(var G=V[oe],x=0;x<G.length;++x){var H=G[x]&31;ie(e,c,Pe[H]),c+=I[H],H>15&&(ie(e,c,G[x]>>5&127),c+=G[x]>>12)}}else
L=qo,_=me,D=Xo,$=Ge;for(var x=0;x<i;++x){var k=n[x];if(k>255){var H=k>>18&31;De(e,c,L[H+257]),c+=_[H+257],H>7&&(ie(e,c,k>>23&31),c+=ot[H]);var ee=k&31;De(e,c,D[ee]),
c+=$[ee],ee>3&&(De(e,c,k>>5&8191),c+=st[ee])}else De(e,c,L[k]),c+=_[k]}return De(e,c,L[256]),c+_[256]},ts=new Bt([65540,131080,131088,131104,262176,1048704,1048832,
2114560,2117632]),Vr=new T(0),rs=function(t,e,r,n,o,s){var a=s.z||t.length,i=new T(n+a+5*(1+Math.ceil(a/7e3))+o),l=i.subarray(n,i.length-o),u=s.l,c=(s.r||0)&7;if(e){
c&&(l[0]=s.r>>3);for(var m=ts[e-1],f=m>>13,h=m&8191,y=(1<<r)-1,d=s.p||new j(32768),g=s.h||new j(y+1),w=Math.ceil(r/3),S=2*w,v=function(bt){return(t[bt]^t[bt+1]<<
w^t[bt+2]<<S)&y},A=new Bt(25e3),E=new j(288),O=new j(32),R=0,x=0,b=s.i||0,I=0,N=s.w||0,F=0;b+2<a;++b){var le=v(b),B=b&32767,W=g[le];if(d[B]=W,g[le]=B,N<=b){var L=a-
b;if((R>7e3||I>24576)&&(L>423||!u)){c=Ur(t,l,0,A,E,O,x,I,F,b-F,c),I=R=x=0,F=b;for(var _=0;_<286;++_)E[_]=0;for(var _=0;_<30;++_)O[_]=0}var D=2,$=0,Pe=h,V=B-W&32767;
if(L>2&&le==v(b-V))for(var oe=Math.min(f,L)-1,G=Math.min(32767,b),H=Math.min(258,L);V<=G&&--Pe&&B!=W;){if(t[b+D]==t[b+D-V]){for(var k=0;k<H&&t[b+k]==t[b+k-V];++k)
;if(k>D){if(D=k,$=V,k>oe)break;for(var ee=Math.min(V,k-2),be=0,_=0;_<ee;++_){var we=b-V+_&32767,qe=d[we],Je=we-qe&32767;Je>be&&(be=Je,W=we)}}}B=W,W=d[B],V+=B-W&
32767}if($){A[I++]=268435456|Ut[D]<<18|Lr[$];var Ie=Ut[D]&31,Le=Lr[$]&31;x+=ot[Ie]+st[Le],++E[257+Ie],++O[Le],N=b+D,++R}else A[I++]=t[b],++E[t[b]]}}for(b=Math.max(
b,N);b<a;++b)A[I++]=t[b],++E[t[b]];c=Ur(t,l,u,A,E,O,x,I,F,b-F,c),u||(s.r=c&7|l[c/8|0]<<3,c-=7,s.h=g,s.p=d,s.i=b,s.w=N)}else{for(var b=s.w||0;b<a+u;b+=65535){var xe=b+
65535;xe>=a&&(l[c/8|0]=u,xe=a),c=jr(l,c+1,t.subarray(b,xe))}s.i=a}return He(i,0,n+Gt(c)+o)},ns=(function(){for(var t=new Int32Array(256),e=0;e<256;++e){for(var r=e,
n=9;--n;)r=(r&1&&-306674912)^r>>>1;t[e]=r}return t})(),os=function(){var t=-1;return{p:function(e){for(var r=t,n=0;n<e.length;++n)r=ns[r&255^e[n]]^r>>>8;t=r},d:function(){
return~t}}};var ss=function(t,e,r,n,o){if(!o&&(o={l:1},e.dictionary)){var s=e.dictionary.subarray(-32768),a=new T(s.length+t.length);a.set(s),a.set(t,s.length),t=a,o.w=s.length}
return rs(t,e.level==null?6:e.level,e.mem==null?o.l?Math.ceil(Math.max(8,Math.min(13,Math.log(t.length)))*1.5):20:12+e.mem,r,n,o)},Yr=function(t,e){var r={};for(var n in t)
r[n]=t[n];for(var n in e)r[n]=e[n];return r};var te=function(t,e){return t[e]|t[e+1]<<8},X=function(t,e){return(t[e]|t[e+1]<<8|t[e+2]<<16|t[e+3]<<24)>>>0},Lt=function(t,e){return X(t,e)+X(t,e+4)*4294967296},
U=function(t,e,r){for(;r;++e)t[e]=r,r>>>=8};var as=function(t,e){return((t[0]&15)!=8||t[0]>>4>7||(t[0]<<8|t[1])%31)&&z(6,"invalid zlib data"),(t[1]>>5&1)==+!e&&z(6,"invalid zlib data: "+(t[1]&32?"need":"u\
nexpected")+" dictionary"),(t[1]>>3&4)+2};function is(t,e){return ss(t,e||{},0,0)}function ls(t,e){return Hr(t,{i:2},e&&e.out,e&&e.dictionary)}function Kr(t,e){return Hr(t.subarray(as(t,e&&e.dictionary),-4),{i:2},e&&e.out,e&&e.dictionary)}var Zr=function(t,e,r,n){for(var o in t){var s=t[o],a=e+o,i=n;Array.isArray(s)&&(i=Yr(n,s[1]),s=s[0]),s instanceof T?r[a]=[s,i]:(r[a+="/"]=[new T(0),i],Zr(s,a,r,
n))}},zr=typeof TextEncoder<"u"&&new TextEncoder,Wt=typeof TextDecoder<"u"&&new TextDecoder,us=0;try{Wt.decode(Vr,{stream:!0}),us=1}catch{}var cs=function(t){for(var e="",
r=0;;){var n=t[r++],o=(n>127)+(n>223)+(n>239);if(r+o>t.length)return{s:e,r:He(t,r-1)};o?o==3?(n=((n&15)<<18|(t[r++]&63)<<12|(t[r++]&63)<<6|t[r++]&63)-65536,e+=String.
fromCharCode(55296|n>>10,56320|n&1023)):o&1?e+=String.fromCharCode((n&31)<<6|t[r++]&63):e+=String.fromCharCode((n&15)<<12|(t[r++]&63)<<6|t[r++]&63):e+=String.fromCharCode(
n)}};function nt(t,e){if(e){for(var r=new T(t.length),n=0;n<t.length;++n)r[n]=t.charCodeAt(n);return r}if(zr)return zr.encode(t);for(var o=t.length,s=new T(t.length+
(t.length>>1)),a=0,i=function(c){s[a++]=c},n=0;n<o;++n){if(a+5>s.length){var l=new T(a+8+(o-n<<1));l.set(s),s=l}var u=t.charCodeAt(n);u<128||e?i(u):u<2048?(i(192|
u>>6),i(128|u&63)):u>55295&&u<57344?(u=65536+(u&1047552)|t.charCodeAt(++n)&1023,i(240|u>>18),i(128|u>>12&63),i(128|u>>6&63),i(128|u&63)):(i(224|u>>12),i(128|u>>
6&63),i(128|u&63))}return He(s,0,a)}function Ht(t,e){if(e){for(var r="",n=0;n<t.length;n+=16384)r+=String.fromCharCode.apply(null,t.subarray(n,n+16384));return r}else{
if(Wt)return Wt.decode(t);var o=cs(t),s=o.s,r=o.r;return r.length&&z(8),s}}var ms=function(t,e){return e+30+te(t,e+26)+te(t,e+28)},fs=function(t,e,r){var n=te(t,e+28),o=Ht(t.subarray(e+46,e+46+n),!(te(t,e+8)&2048)),s=e+46+n,a=X(t,e+20),
i=r&&a==4294967295?ps(t,s):[a,X(t,e+24),X(t,e+42)],l=i[0],u=i[1],c=i[2];return[te(t,e+10),l,u,o,s+te(t,e+30)+te(t,e+32),c]},ps=function(t,e){for(;te(t,e)!=1;e+=
4+te(t,e+2));return[Lt(t,e+12),Lt(t,e+4),Lt(t,e+20)]},Dt=function(t){var e=0;if(t)for(var r in t){var n=t[r].length;n>65535&&z(9),e+=n+4}return e},Fr=function(t,e,r,n,o,s,a,i){
var l=n.length,u=r.extra,c=i&&i.length,m=Dt(u);U(t,e,a!=null?33639248:67324752),e+=4,a!=null&&(t[e++]=20,t[e++]=r.os),t[e]=20,e+=2,t[e++]=r.flag<<1|(s<0&&8),t[e++]=
o&&8,t[e++]=r.compression&255,t[e++]=r.compression>>8;var f=new Date(r.mtime==null?Date.now():r.mtime),h=f.getFullYear()-1980;if((h<0||h>119)&&z(10),U(t,e,h<<25|
f.getMonth()+1<<21|f.getDate()<<16|f.getHours()<<11|f.getMinutes()<<5|f.getSeconds()>>1),e+=4,s!=-1&&(U(t,e,r.crc),U(t,e+4,s<0?-s-2:s),U(t,e+8,r.size)),U(t,e+12,
l),U(t,e+14,m),e+=16,a!=null&&(U(t,e,c),U(t,e+6,r.attrs),U(t,e+10,a),e+=14),t.set(n,e),e+=l,m)for(var y in u){var d=u[y],g=d.length;U(t,e,+y),U(t,e+2,g),t.set(d,
e+4),e+=4+g}return c&&(t.set(i,e),e+=c),e},hs=function(t,e,r,n,o){U(t,e,101010256),U(t,e+8,r),U(t,e+10,r),U(t,e+12,n),U(t,e+16,o)};function qr(t,e){e||(e={});var r={},n=[];Zr(t,"",r,e);var o=0,s=0;for(var a in r){var i=r[a],l=i[0],u=i[1],c=u.level==0?0:8,m=nt(a),f=m.length,h=u.comment,y=h&&
nt(h),d=y&&y.length,g=Dt(u.extra);f>65535&&z(11);var w=c?is(l,u):l,S=w.length,v=os();v.p(l),n.push(Yr(u,{size:l.length,crc:v.d(),c:w,f:m,m:y,u:f!=a.length||y&&h.
length!=d,o,compression:c})),o+=30+f+g+S,s+=76+2*(f+g)+(d||0)+S}for(var A=new T(s+22),E=o,O=s-o,R=0;R<n.length;++R){var m=n[R];Fr(A,m.o,m,m.f,m.u,m.c.length);var x=30+
m.f.length+Dt(m.extra);A.set(m.c,m.o+x),Fr(A,o,m,m.f,m.u,m.c.length,m.o,m.m),o+=16+x+(m.m?m.m.length:0)}return hs(A,o,n.length,O,E),A}function Jr(t,e){for(var r={},n=t.length-22;X(t,n)!=101010256;--n)(!n||t.length-n>65558)&&z(13);var o=te(t,n+8);if(!o)return{};var s=X(t,n+16),a=s==4294967295||
o==65535;if(a){var i=X(t,n-12);a=X(t,i)==101075792,a&&(o=X(t,i+32),s=X(t,i+48))}for(var l=e&&e.filter,u=0;u<o;++u){var c=fs(t,s,a),m=c[0],f=c[1],h=c[2],y=c[3],d=c[4],
g=c[5],w=ms(t,g);s=d,(!l||l({name:y,size:f,originalSize:h,compression:m}))&&(m?m==8?r[y]=ls(t.subarray(w,w+f),{out:new T(h)}):z(14,"unknown compression type "+m):
r[y]=He(t,w,w+f))}return r}var de=["stay","north","east","south","west","northeast","southeast","southwest","northwest"];var ye=["pursuer","evader"];var jt=4,Xr=new Map;function Qr(t,e){let r=Xr.get(t);if(r)return r;let n=new Float32Array;try{let o=ys(gs(t),e);o.every(Number.isFinite)&&(n=o)}catch(o){if(!(o instanceof DOMException||
o instanceof RangeError||ds(o)))throw o}return Xr.set(t,n),n}var ds=t=>t instanceof Error&&"code"in t;function ys(t,e){let r=Kr(t),n=r.length/jt,o=new Uint8Array(
r.length);for(let a=0;a<o.length;a++)o[a]=r[a%jt*n+Math.floor(a/jt)];let s=new Uint32Array(o.buffer);for(let a=e;a<s.length;a++)s[a]^=s[a-e];return new Float32Array(
o.buffer)}function gs(t){let e=atob(Vt(t)),r=new Uint8Array(e.length);for(let n=0;n<r.length;n++)r[n]=e.charCodeAt(n);return r}function Vt(t){return document.getElementById(
t)?.textContent??""}var vs="http://www.w3.org/2000/svg";function p(t,e={},...r){return en(document.createElement(t),e,r)}function ge(t,e={},...r){return en(document.createElementNS(
vs,t),e,r)}function en(t,e,r){for(let[n,o]of Object.entries(e))o==null||o===!1||(typeof o=="function"?t.addEventListener(n.slice(2),o):t.setAttribute(n,o===!0?"":
String(o)));return t.append(...r.filter(bs).map(n=>typeof n=="number"?String(n):n)),t}function bs(t){return t!=null&&t!==!1}var tn=()=>["file:","http:","https:"].
includes(location.protocol);function ws(){let t=document.documentElement.dataset.theme;return t?t==="dark":matchMedia("(prefers-color-scheme: dark)").matches}function xs(){document.documentElement.
dataset.theme=ws()?"light":"dark"}if(typeof document<"u"){let t=document.documentElement.dataset,e=t.theme;addEventListener("beforeprint",()=>{e=t.theme,t.theme=
"light"}),addEventListener("afterprint",()=>{e?t.theme=e:delete t.theme})}function rn(){return p("button",{type:"button",title:"Light or dark (D)","aria-label":"\
Light or dark",onclick:xs},"◐")}var nn=(t,e,...r)=>p("header",{class:"top"},p("div",{},p("h1",{},t),e?p("p",{class:"lead"},e):null),p("div",{class:"tools"},...r,rn()));function on(t,e,r){return{rows:t.rows,cols:t.cols,nPursuers:t.n_pursuers,fov:t.fov,interaction:t.rules.interaction,obstacles:e,moments:r}}function Yt(t,e){return{
positions:t.read("last_positions"),alive:t.read("alive"),captured:t.read("captured"),everCaptured:t.read("ever_captured"),actions:e,involved:t.read("involved"),
fault:t.read("fault"),contested:t.conflicts().map(r=>r.cell)}}var je=class{config;start;recording;actions=[];#e;#s;#o=[[]];constructor(e,r,n){[this.config,this.start]=[r,n],this.#e=e.world(r),this.#e.reset(n),this.#s=[Yt(this.#e)],
this.recording=on(r,this.#e.map(),this.#s)}get length(){return this.actions.length}get over(){return this.#e.over}get statistics(){return{capture_rate:this.#e.read(
"capture_rate")[0]}}conflicts(e){return this.#o[e]}game(e){return e.game(this.#e)}play(e){this.#e.step(e),this.#r(e)}step(e,r,n){let[o,s]=[this.#e,this.config.n_pursuers],
a=new Uint8Array(o.n_agents);for(let i=o.n_turns;i>0&&!o.over;--i){let[l,u]=o.actors;l<s&&(a=o.decide(e.pursuer,[l,Math.min(u,s)],a)),u>s&&(a=o.decide(e.evader,
[Math.max(l,s),u],a)),typeof n=="number"?a[r]=n:l<=r&&r<u&&(a=o.decide(n,[r,r+1],a)),o.playTurn(a)}this.#r(a)}#r(e){this.actions.push(e),this.#s.push(Yt(this.#e,
e)),this.#o.push(this.#e.conflicts())}};function sn(t,e,r,n){let o=new je(t,e,r);for(let s of n)o.play(s);return o}var fe=(t,e)=>ye[+(e>=t.n_pursuers)];function Kt(t,e){let r=new je(t,e.config,{seed:e.seed,episode:e.episode});for(let n of e.moves)r.over||r.step(e.policies,e.
seat,n);return r}function pe(t,e){let{moments:r,nPursuers:n}=t.recording,o=r.findIndex(({alive:a,captured:i})=>!a[e]||!!i[e-n]),s=o<0?t.length:o;return{lasted:s,
out:o>=0,captured:Array.from(r[s].everCaptured).filter(Boolean).length}}var at=(t,e)=>t.over||pe(t,e).out;function an(t,e,r){let n=Kt(t,{...e,moves:e.moves.slice(
0,e.from)});for(;!at(n,e.seat);)n.step(e.policies,e.seat,r);return pe(n,e.seat)}function Ee(t){let e=t.length-1;return[...new Set([0,Math.round(e/3),e])].map(r=>t[r])}
function ln(t,{seat:e,from:r,moves:n}){let o={...t,seat:e,...r?{from:r}:{},moves:n.join("")};return`${location.href.split("#")[0]}#${Object.entries(o).map(([s,a])=>`${s}\
=${a}`).join("&")}`}function un(t,e){let[r,n,o]=[t.get("seat")??"",t.get("from")??"0",t.get("moves")??""];return/^\d{1,6}$/.test(r)&&Number(r)<e.n_pursuers+e.n_evaders&&
(e.diagonal?/^[0-8]+$/:/^[0-4]+$/).test(o)&&o.length<=e.max_steps&&/^\d{1,6}$/.test(n)&&Number(n)<=o.length?{seat:Number(r),from:Number(n),moves:[...o].map(Number)}:
null}var it=()=>crypto.getRandomValues(new BigUint64Array(1))[0];function Zt(t,e,r,n,o,s){e.play({title:r,played:n,ending:(a,i)=>[As(t,a,i,Ee(o))],again:()=>Zt(t,e,r,{...n,moves:n.moves.slice(0,n.from)},o,s),link:a=>s&&ln(s,a)})}
function As(t,e,r,n){let o=fe(r.config,r.seat)==="evader",s=o?r.config.max_steps:r.config.n_evaders,a=p("table",{class:"numbers"},p("caption",{},o?"Steps in you\
r seat: same start, same others":"Captures of your team: same start, same others")),i=u=>{let[c,m]=[p("span",{class:o?"bar evader":"bar pursuer"}),p("td",{},"…")];
return a.append(p("tr",{},p("th",{scope:"row"},u),p("td",{class:"track","aria-hidden":"true"},c),m)),({lasted:f,captured:h})=>{c.style.width=`${100*(o?f:h)/s}%`,
m.textContent=String(o?f:h)}};i("You")(pe(e,r.seat));for(let{name:u,policy:c}of n){let m=i(u);setTimeout(()=>m(an(t,r,c())))}let l=r.from?`You took over at step\
 ${r.from}. `:"";return p("div",{},a,p("p",{class:"small muted"},`${l}One match: luck has its part in it.`))}var Ss=20,qt=60;function Ms(t){let e=t.rules.capture==="SURROUND"?8:4,r=typeof t.obstacles!="number",n=o=>r?o:Math.min(o,Ss);return{...t,rows:n(t.rows),cols:n(t.
cols),max_steps:qt,n_evaders:1,n_pursuers:Math.min(t.n_pursuers,e)}}function Jt(t,e,r){let[n,o,s]=[Ms(e),Ee(r),[]],a=()=>`${s.reduce((l,u)=>l+u,0)} of ${qt*o.length}`,
i=()=>t.play({title:`Can you escape it? Round ${s.length+1} of ${o.length}, pursuers: ${o[s.length].name}`,about:o[s.length].text&&`${o[s.length].name}: ${o[s.length].
text}`,played:{config:n,seed:it(),episode:0,seat:n.n_pursuers,from:0,moves:[],policies:{pursuer:o[s.length].policy(),evader:"still"}},ending:l=>{s.push(pe(l,n.n_pursuers).
lasted);let u=o.map(({name:m},f)=>p("tr",{},p("th",{scope:"row"},m),p("td",{},s[f]??""))),c=s.length<o.length;return[p("table",{class:"numbers"},p("caption",{},
`Steps of ${qt} in each round`),...u),p("p",{class:"play-score"},c?"Score so far: ":"Your score: ",p("strong",{},a())),c?p("button",{type:"button",class:"primar\
y",onclick:i},"Next round"):""]},again:()=>Jt(t,e,r),link:()=>null});i()}var Ts={"|b1":t=>new Uint8Array(t),"|i1":t=>new Int8Array(t),"<i4":t=>new Int32Array(t),"<i8":t=>Int32Array.from(new BigInt64Array(t),Number),"<f4":t=>new Float32Array(
t)},mn="NUMPY\0",_e=mn.length+2,cn=64;function fn(t){return qr(Object.fromEntries(Object.entries(t).map(([e,r])=>[`${e}.npy`,Cs(r)])))}function Cs({dtype:t,shape:e,
data:r}){let n=typeof r=="string"?Array.from(r,c=>c.codePointAt(0)):null,o=e.map(c=>`${c}, `).join(""),s=`{'descr': '${n?`<U${n.length}`:t}', 'fortran_order': F\
alse, 'shape': (${o}), }`,a=Math.ceil((_e+s.length+1)/cn)*cn-_e,i=mn+String.fromCharCode(a&255,a>>8)+s.padEnd(a-1)+`
`,l=n?Int32Array.from(n):r,u=new Uint8Array(i.length+l.byteLength);return u.set(nt(i,!0)),u.set(new Uint8Array(l.buffer,l.byteOffset,l.byteLength),i.length),u}function pn(t){
return Object.fromEntries(Object.entries(Jr(t)).map(([e,r])=>[e.replace(/\.npy$/,""),Es(r)]))}function Es(t){let e=_e+t[_e-2]+256*t[_e-1],r=Ht(t.subarray(_e,e),
!0),n=/'descr': '([^']+)', 'fortran_order': False, 'shape': \(([\d, ]*)\)/.exec(r),[o,s]=[n?.[1]??"",(n?.[2]??"").split(",").filter(u=>u.trim()).map(Number)],a=t.
slice(e).buffer,i=o.startsWith("<U")&&String.fromCodePoint(...new Int32Array(a)),l=i===!1?Ts[o]?.(a):i.replace(/\0+$/,"");if(l===void 0)throw new TypeError(`exp\
ected an array of numbers or a text, got ${r.slice(0,80)}`);return{dtype:o,shape:s,data:l}}var Xt="matrixworld episode 3";function hn(t,e,r){let{config:n,actions:o,length:s,recording:a}=e,[i,l]=[n.n_pursuers+n.n_evaders,n.n_evaders],u={positions:["<i4",
i,2],last_positions:["<i4",i,2],alive:["|b1",i],captured:["|b1",l],ever_captured:["|b1",l]},c={rewards:["<f4",i],involved:["|b1",i,3],fault:["|b1",i,3]},m={},f=v=>{
for(let A of Object.keys(v))(m[A]??=[]).push(Array.from(h.read(A),Number))},h=t.world(n);h.reset(e.start);let y=[];f(u);for(let v of o)h.step(v),f({...u,...c}),
y.push(...h.conflictTable());h.free();let d={"<i4":Int32Array,"<f4":Float32Array,"|b1":Uint8Array},g={};for(let[v,[A,...E]]of Object.entries({...u,...c})){let O=s+
+(v in u);g[v]={dtype:A,shape:[O,...E],data:d[A].from((m[v]??[]).flat())}}let w=v=>({dtype:"<i8",shape:[],data:Int32Array.of(v,0)}),S=v=>({dtype:"<U",shape:[],data:v});
return fn({format:S(Xt),n_pursuers:w(n.n_pursuers),config:S(JSON.stringify(n)),seat:w(r),...g,actions:{dtype:"|i1",shape:[s,i],data:Int8Array.from(o.flatMap(v=>[
...v]))},map:{dtype:"|b1",shape:[n.rows,n.cols],data:Uint8Array.from(a.obstacles,Number)},conflict_table:{dtype:"<i4",shape:[y.length/11,11],data:Int32Array.from(
y)}})}function dn(t,e){let r=pn(e),n=h=>Array.from(r[h]?.data??[]);if(r.format?.data!==Xt)throw new Y(`expected a file marked "${Xt}"`);let o=JSON.parse(r.config.
data),s=o.n_pursuers+o.n_evaders,a=n("positions"),i=(h,y)=>Array.from({length:y-h},(d,g)=>[a[2*(h+g)],a[2*(h+g)+1]]),l={pursuers:i(0,o.n_pursuers),evaders:i(o.n_pursuers,
s),obstacles:Uint8Array.from(n("map"))},u=Uint8Array.from(n("actions")),c=Array.from({length:u.length/s},(h,y)=>u.subarray(y*s,(y+1)*s)),m=sn(t,o,l,c);if(Array.
from(m.recording.moments.at(-1).positions).join()!==n("last_positions").slice(-2*s).join())throw new Y("expected the moves of this start to lead to its end");return{
live:m,seat:n("seat")[0]??null}}var _s={random:{own:[[3.5,2.5]],others:[],ways:[[[4.3,2.5],[6,2.5]],[[2.7,2.5],[1,2.5]],[[3.5,1.7],[3.5,.4]],[[3.5,3.3],[3.5,4.6]]]},still:{own:[[3.5,2.5]],others:[],
ways:[]},chaser:{own:[[1,2.5]],others:[[6,2.5]],ways:[[[1.9,2.5],[4.9,2.5]]]},"clumsy chaser":{own:[[1,2.5]],others:[[6,2.5]],ways:[[[1.9,2.5],[2.5,1.2],[3.2,3.8],
[4,2.5],[4.9,2.5]]]},hunter:{own:[[1,1.1],[1,3.9]],others:[[6,1.1],[6,3.9]],ways:[[[1.9,1.1],[4.9,1.1]],[[1.9,3.9],[4.9,3.9]]]},surrounder:{own:[[3.5,.8],[6,4.2]],
others:[[3.5,2.5]],ways:[[[6,3.3],[6,2.5],[4.8,2.5]]]},"team surrounder":{own:[[1,.8],[6,.8],[1,4.2],[6,4.2]],others:[[3.5,2.5]],ways:[[[1.8,.8],[3.5,.8],[3.5,1.4]],
[[6,1.6],[6,2.5],[4.7,2.5]],[[1,3.4],[1,2.5],[2.3,2.5]],[[5.2,4.2],[3.5,4.2],[3.5,3.6]]]},fleer:{own:[[3,2.5]],others:[[1,2.5]],ways:[[[3.9,2.5],[6.4,2.5]]]},"c\
lumsy fleer":{own:[[3,2.5]],others:[[1,2.5]],ways:[[[3.8,2.5],[4.2,1.2],[4.9,3.8],[5.5,2.5],[6.4,2.5]]]},dodger:{own:[[3.2,2.5]],others:[[1,.9],[1,4.1]],ways:[[
[4.1,2.5],[6.4,2.5]]]}},yn={own:[[1,1],[1,4],[3.5,2.5],[6,1],[6,4]],others:[],ways:[[[1,1],[6,4]],[[1,4],[6,1]]]},ks={pursuer:(t,e)=>`M${t} ${e-.75}l0.8 1.4h-1.\
6z`,evader:(t,e)=>`M${t-.7} ${e}a0.7 0.7 0 1 0 1.4 0a0.7 0.7 0 1 0 -1.4 0z`};function gn(t,e){let r=_s[t.replace(/^careful /,"")]??yn,n=(o,s)=>ge("path",{class:`\
of-${o}s`,d:s.map(([a,i])=>ks[o](a,i)).join("")});return ge("svg",{class:"player-picture",viewBox:"0 0 7 5","aria-hidden":"true"},ge("path",{class:"ways",d:r.ways.
map(r===yn?vn:Rs).join("")}),n(e,r.own),n(e==="pursuer"?"evader":"pursuer",r.others))}var vn=t=>`M${t.map(e=>e.join(" ")).join("L")}`;function Rs(t){let[[e,r],[
n,o]]=t.slice(-2),[s,a]=[Math.sign(n-e)*.7,Math.sign(o-r)*.7];return`${vn(t)}M${n-s-a} ${o-a-s}L${n} ${o}L${n-s+a} ${o-a+s}`}var ke=[[0,0],[-1,0],[0,1],[1,0],[0,-1],[-1,1],[1,1],[1,-1],[-1,-1]];function bn(t,e,r){let[n,o]=[e[0]-t[0],e[1]-t[1]];return!r&&Math.abs(n)>Math.abs(o)?o=0:r||
(n=0),ke.findIndex(([s,a])=>s===Math.sign(n)&&a===Math.sign(o))}var ve=(t,e)=>e<t.nPursuers,C=(t,e)=>[t.positions[2*e],t.positions[2*e+1]],Os=(t,e)=>t[0]===e[0]&&
t[1]===e[1],Qt=({rows:t,cols:e},[r,n])=>r>=0&&n>=0&&r<t&&n<e,er=(t,e,r=3)=>t!==void 0&&[0,1,2].slice(0,r).some(n=>t[3*e+n]),tr=(t,e)=>er(t.fault,e),wn=(t,e)=>!tr(
t,e)&&er(t.involved,e,2);function lt(t,e,r){let n=!Os(C(t,r),C(e,r)),o=e.involved===void 0||er(e.involved,r);return!!(e.alive[r]&&e.actions?.[r]&&!n&&o)}function ut(t,e,r){
let[n,o]=C(t,r),[s,a]=ke[e.actions?.[r]??0];return[n+s,o+a]}function ct(t,e,r){return Array.from({length:r.everCaptured.length},(o,s)=>s).filter(o=>r.everCaptured[o]&&
!e.everCaptured[o]).map(o=>t.nPursuers+o)}function mt(t,e){return Array.from({length:e.alive.length},(n,o)=>o).filter(n=>t.alive[n]&&!e.alive[n])}var xn=[-.31,0,.31],An=[{size:1,at:[[0,0]]},{size:.62,at:[[-.2,.2],[.2,-.2]]},{size:.54,at:[[-.23,.22],[.23,.22],[0,-.22]]},{size:.54,at:[[-.23,.23],[.23,.23],[
-.23,-.23],[.23,-.23]]},{size:.36,at:xn.flatMap(t=>xn.map(e=>[e,t]))}],Ns=.3,Ps=.35,Is=.55;function Ve(t,e){let r=new Map;for(let n=0;n<e.alive.length;n++){if(!e.
alive[n])continue;let[o,s]=C(e,n),a=o*t.cols+s,i=r.get(a);i?i.push(n):r.set(a,[n])}return r}function Sn(t,e){let r=Array.from(e.alive,(n,o)=>{let[s,a]=C(e,o);return{
x:a+.5,y:s+.5,size:1,alpha:0}});for(let n of Ve(t,e).values()){let o=An[Math.min(n.length,An.length)-1];n.forEach((s,a)=>{let[i,l]=o.at[Math.min(a,o.at.length-1)],
u=r[s];u.x+=i,u.y+=l,u.size=o.size,u.alpha=1})}return r}var Mn=t=>t*t*(3-2*t),Re=(t,e,r)=>t+(e-t)*r,Tn=t=>Math.min(1,Math.max(0,t));function Cn(t,e,r,n){let o={
SIMULTANEOUS:1,SWARM_TURNS:2,AGENT_TURNS:r}[t.interaction];if(o===1)return Mn(n);let s=o===r?e:+!ve(t,e),a=Math.max(1/o,Ps);return Mn(Tn((n-s/(o-1)*(1-a))/a))}function ft(t,e){
let r=t.moments.length-1,n=Math.min(Math.floor(e),r),o=t.moments[n],s=Sn(t,o);if(n===r||e===n)return s;let a=t.moments[n+1],i=Sn(t,a);return s.map((l,u)=>{let c=Cn(
t,u,s.length,e-n);return Ls(o,a,u,l,i[u],c)})}function rr(t,e,r){let n=t.moments.length-1,o=Math.min(Math.floor(r),n),[s,a]=[t.moments[o],t.moments[Math.min(o+1,
n)]],i=Cn(t,e,s.alive.length,r-o),[[l,u],[c,m]]=[C(s,e),C(a,e)];return[Re(u,m,i)+.5,Re(l,c,i)+.5]}function Ls(t,e,r,n,o,s){let a=n.alpha>o.alpha,i={x:Re(n.x,o.x,
s),y:Re(n.y,o.y,s),size:a?n.size:Re(n.size,o.size,s),alpha:a?Tn((1-s)/(1-Is)):Re(n.alpha,o.alpha,s)};if(lt(t,e,r)){let[l,u]=C(t,r),[c,m]=ut(t,e,r),f=Ns*Math.sin(
Math.PI*s);i.x+=(m-u)*f,i.y+=(c-l)*f}return i}var En=2*Math.PI;function Ye(t,e,r,n){t.beginPath(),t.arc(e,r,n/2,0,En)}function _n(t,e,r,n){let o=n/2,s=[[0,-.97],[.97,.83],[-.97,.83]].map(([a,i])=>[e+a*o,r+i*
o]);t.beginPath(),t.moveTo((s[2][0]+s[0][0])/2,(s[2][1]+s[0][1])/2),s.forEach(([a,i],l)=>{let[u,c]=s[(l+1)%3];t.arcTo(a,i,u,c,n*.09)}),t.closePath()}function kn(t,e,r,n){
let o=n*.32;t.beginPath(),t.moveTo(e-o,r-o),t.lineTo(e+o,r+o),t.moveTo(e+o,r-o),t.lineTo(e-o,r+o)}function Rn(t,e,r,n){t.beginPath();for(let o=0;o<16;o++){let s=n/
2*(o%2?.6:.95),a=En*o/16;t.lineTo(e+s*Math.sin(a),r-s*Math.cos(a))}t.closePath()}function On(t,e,r,n,o,s){let a=Math.atan2(o-r,n-e);t.beginPath(),t.moveTo(e,r),
t.lineTo(n,o);for(let i of[-1,1])t.moveTo(n,o),t.lineTo(n-s*Math.cos(a+i*.6),o-s*Math.sin(a+i*.6))}var Nn=4,$s=1.6,Us=.95,zs=5,Fs=.16,Ws=9,Ds=.09,Bs=.2,Pn=.75,K=(t,e)=>t.left+e*t.cell,Z=(t,e)=>t.top+e*t.cell;function Oe(t,e,r){return ve(e,r)?t.colors.pursuer:
t.colors.evader}function In({ctx:t,grid:e,colors:r}){let{left:n,top:o,cell:s,rows:a,cols:i}=e,[l,u]=[i*s,a*s];if(t.fillStyle=r.paper,t.fillRect(n,o,l,u),s<zs)return;
t.fillStyle=r.line;let c=Math.max(1,Math.round(s/60));for(let m=1;m<i;m++)t.fillRect(n+m*s,o,c,u);for(let m=1;m<a;m++)t.fillRect(n,o+m*s,l,c)}function Ln({ctx:t,
grid:e,colors:r},n){let{left:o,top:s,cell:a,rows:i,cols:l}=e;t.fillStyle=r.obstacle;for(let u=0;u<i*l;u++){if(!n.obstacles[u])continue;let[c,m]=[Math.floor(u/l),
u%l];t.fillRect(o+m*a,s+c*a,a,a)}$n({ctx:t,grid:e,colors:r})}function $n({ctx:t,grid:{left:e,top:r,cell:n,rows:o,cols:s},colors:a}){let i=Math.min(5,Math.max(2,
Math.round(n/18)));t.strokeStyle=a.frame,t.lineWidth=i,t.strokeRect(e-i/2,r-i/2,s*n+i,o*n+i)}function Un({ctx:t,grid:e,colors:r},n){let{left:o,top:s,cell:a,rows:i,
cols:l}=e,u=a<24*n?5:1;t.font=`500 ${Math.round(Math.min(15*n,Math.max(9*n,a*.32)))}px system-ui, sans-serif`,t.fillStyle=r.muted,t.textBaseline="alphabetic",t.
textAlign="center";let c=5*n+a/40;for(let m=0;m<l;m+=u)t.fillText(String(m),o+(m+.5)*a,s-c);t.textAlign="right",t.textBaseline="middle";for(let m=0;m<i;m+=u)t.fillText(
String(m),o-c,s+(m+.5)*a)}function zn({grid:t},e,r,n){let o=Math.floor(e.fov/2)+.5,[s,a]=[Math.max(0,r-o),Math.min(t.cols,r+o)],[i,l]=[Math.max(0,n-o),Math.min(
t.rows,n+o)];return[K(t,s),Z(t,i),(a-s)*t.cell,(l-i)*t.cell]}function Fn(t,e,r,n){let{ctx:o,grid:s,colors:a}=t;o.save(),o.beginPath(),o.rect(0,0,o.canvas.width,
o.canvas.height),o.rect(...zn(t,e,r,n)),o.clip("evenodd"),o.clearRect(0,0,o.canvas.width,o.canvas.height),o.fillStyle=a.line,o.fillRect(s.left,s.top,s.cols*s.cell,
s.rows*s.cell),o.restore(),$n(t)}function Wn({ctx:t,grid:e,colors:r},{x:n,y:o,alpha:s},a){let i=Math.max(e.cell,16*a)*1.06,[l,u]=[K(e,n),Z(e,o)];t.globalAlpha=Math.
max(s,.6),t.beginPath(),t.roundRect(l-i/2,u-i/2,i,i,i*.2),t.strokeStyle=r.focus,t.lineWidth=Math.max(2,2.5*a),t.stroke();let c=Math.max(11*a,Math.min(18*a,e.cell*
.5));t.font=`700 ${Math.round(c)}px system-ui, sans-serif`,t.textAlign="center",t.textBaseline="middle";let m=u-i/2<c*1.2,f=u+(m?1:-1)*(i/2+c*.7);t.strokeStyle=
r.paper,t.lineJoin="round",t.lineWidth=c*.35,t.strokeText("You",l,f),t.fillStyle=r.ink,t.fillText("You",l,f),t.globalAlpha=1}function Dn(t,e,r,n,o){let{ctx:s,grid:a}=t,
i=zn(t,e,n,o),l=Oe(t,e,r);s.globalAlpha=.11,s.fillStyle=l,s.fillRect(...i),s.globalAlpha=.8,s.strokeStyle=l,s.lineWidth=Math.max(1,a.cell/24),s.strokeRect(...i),
s.globalAlpha=1}function Bn(t,e,r,n,o){let{ctx:s,grid:a}=t,i=Math.min(Math.ceil(r),e.moments.length-1),l=e.moments[i];s.lineCap="round",s.lineWidth=Math.min(Ws,
Math.max(1,a.cell*Fs));for(let u=Math.max(1,Math.floor(r-n)+1);u<=i;u++){let[c,m]=[e.moments[u-1],e.moments[u]],f=Math.max(0,Math.min(1,(r-u)/n));s.globalAlpha=
Pn+(Bs-Pn)*f;for(let h=0;h<m.alive.length;h++){let y=u===i&&r<i;if(!c.alive[h]||!(l.alive[h]||y))continue;let d=(ve(e,h)?-1:1)*Ds,[g,w]=C(c,h),[S,v]=C(m,h);if(g===
S&&w===v)continue;let A=y?o[h].x:v+.5,E=y?o[h].y:S+.5;s.strokeStyle=Oe(t,e,h),s.beginPath(),s.moveTo(K(a,w+.5+d),Z(a,g+.5+d)),s.lineTo(K(a,A+d),Z(a,E+d)),s.stroke()}}
s.globalAlpha=1}function Gn(t,e,r){let n=Math.min(Math.ceil(r),e.moments.length-1);for(let o=Math.max(1,n-Nn+1);o<=n;o++){let[s,a]=[e.moments[o-1],e.moments[o]],
i=o>r?Math.max(0,1-2*(o-r)):1-(r-o)/Nn,l=ct(e,s,a);for(let u of mt(s,a))l.includes(u)||Hs(t,C(a,u),i);for(let u of l)Gs(t,C(a,u),i)}t.ctx.globalAlpha=1}function Gs({
ctx:t,grid:e,colors:r},[n,o],s){t.globalAlpha=s,Rn(t,K(e,o+.5),Z(e,n+.5),Math.max(8,e.cell*$s)),t.fillStyle=r.capture,t.fill(),t.strokeStyle=r.ink,t.lineWidth=Math.
max(1,e.cell/36),t.lineJoin="round",t.stroke()}function Hs({ctx:t,grid:e,colors:r},[n,o],s){t.globalAlpha=s,kn(t,K(e,o+.5),Z(e,n+.5),Math.max(7,e.cell*Us)),t.strokeStyle=
r.collision,t.lineWidth=Math.max(2,e.cell*.17),t.lineCap="round",t.stroke()}function Hn({ctx:t,grid:e,colors:r},n,o){let s=Math.max(1,e.cell*.07);t.strokeStyle=
t.fillStyle=r.collision,t.lineWidth=Math.max(1,e.cell*.05),t.setLineDash([e.cell*.14,e.cell*.1]);for(let[a,i]of n){if(a<0||i<0||a>=e.rows||i>=e.cols)continue;let l=[
K(e,i)+s,Z(e,a)+s,e.cell-2*s,e.cell-2*s];t.globalAlpha=.2*o,t.fillRect(...l),t.globalAlpha=o,t.strokeRect(...l)}t.setLineDash([]),t.globalAlpha=1}function jn({ctx:t,
grid:e,colors:r},n,o,s,a){t.globalAlpha=a,Ye(t,K(e,n),Z(e,o),Math.max(8,e.cell*s*1.02)),t.strokeStyle=r.collision,t.lineWidth=Math.max(1.5,e.cell*.085*Math.sqrt(
s)),t.stroke(),t.globalAlpha=1}var js=.8,Vs=.92,Ys=15,Ks=7,nr=9;function Vn(t,e,r,n,o,s){n.forEach((a,i)=>{a.alpha>0&&Zs(t,e,r,i,a,o,s)}),t.ctx.globalAlpha=1;for(let a of Ve(e,r).values())a.length>
nr&&qs(t,n[a[nr-1]],a.length-nr+1)}function Zs(t,e,r,n,o,s,a){let{ctx:i,grid:l,colors:u}=t,c=ve(e,n),[m,f]=[l.left+o.x*l.cell,l.top+o.y*l.cell],h=Math.max(4,l.cell*
o.size*(c?Vs:js)),y=Oe(t,e,n),d=!c&&!!r.captured[n-e.nPursuers];if(i.globalAlpha=o.alpha,(c?_n:Ye)(i,m,f,h),h>Ks*a&&(i.strokeStyle=u.paper,i.lineWidth=Math.max(
2,h*.1),i.stroke()),i.fillStyle=d?u.paper:y,i.fill(),d&&(Ye(i,m,f,h*.82),i.strokeStyle=y,i.lineWidth=h*.18,i.stroke()),!s||h<Ys*a)return;let g=String(c?n:n-e.nPursuers);
i.font=`700 ${Math.round(h*(c?.4:.5)*(g.length>1?.8:1))}px system-ui, sans-serif`,i.textAlign="center",i.textBaseline="middle",i.fillStyle=d?y:u.paper,i.fillText(
g,m,f+h*(c?.17:.03))}function qs({ctx:t,grid:e,colors:r},n,o){let[s,a]=[e.left+n.x*e.cell,e.top+n.y*e.cell];t.font=`700 ${Math.round(e.cell*.3)}px system-ui, sa\
ns-serif`,t.textAlign="center",t.textBaseline="middle",t.strokeStyle=r.paper,t.lineWidth=e.cell*.1,t.strokeText(`+${o}`,s,a),t.fillStyle=r.ink,t.fillText(`+${o}`,
s,a)}var Js=.46,Xs=.86,Qs=.66,Yn=.48,ea=.78,ta=.58;function Kn(t,e,r,n){let[o,s]=[e.moments[r-1],e.moments[r]];if(!o)return;let{ctx:a,grid:i,colors:l}=t;a.strokeStyle=
l.collision,a.lineWidth=Math.max(1.5,i.cell*.07),a.lineCap="butt",a.globalAlpha=n;for(let u=0;u<s.alive.length;u++)lt(o,s,u)&&ra(t,e,C(o,u),ut(o,s,u));a.globalAlpha=
1}function ra({ctx:t,grid:e},r,n,o){let[s,a]=[o[1]-n[1],o[0]-n[0]],i=m=>K(e,n[1]+.5+s*m),l=m=>Z(e,n[0]+.5+a*m),u=Qt(r,o)?ea:ta;t.setLineDash([e.cell*.09,e.cell*
.06]),t.beginPath(),t.moveTo(i(Yn),l(Yn)),t.lineTo(i(u),l(u)),t.stroke(),t.setLineDash([]);let c=.17*e.cell/Math.hypot(s,a);t.beginPath(),t.moveTo(i(u)-a*c,l(u)+
s*c),t.lineTo(i(u)+a*c,l(u)-s*c),t.stroke()}function Zn(t,e,r,n,o,s){let a=ke[s];if(!s||!a)return;let{ctx:i,grid:l,colors:u}=t,c=Qt(e,[n[0]+a[0],n[1]+a[1]])?Xs:
Qs,m=Js*o.size,f=[K(l,o.x+a[1]*m),Z(l,o.y+a[0]*m),K(l,o.x+a[1]*c),Z(l,o.y+a[0]*c)],h=Math.max(1.5,l.cell*.085);i.lineCap=i.lineJoin="round";for(let[y,d]of[[u.paper,
h*2.1],[Oe(t,e,r),h]])i.strokeStyle=y,i.lineWidth=d,On(i,...f,l.cell*.2),i.stroke()}var Jn={numbers:!0,axes:!1,trail:6,viewers:[],plan:null,selected:null,cursor:null,you:null,fog:!1};function Xn(t,e,r,n,o){let{ctx:s,grid:a,colors:i}=t,l=Math.min(
Math.ceil(r),e.moments.length-1),u=e.moments[l],c=r===l,m=ft(e,r),f=c?1:Math.max(0,1-2*(l-r));s.clearRect(0,0,s.canvas.width,s.canvas.height),In(t);for(let d of n.
viewers)m[d]?.alpha&&Dn(t,e,d,...rr(e,d,r));Ln(t,e),n.axes&&Un(t,o),Bn(t,e,r,n.trail,m),Hn(t,u.contested??[],f),Gn(t,e,r),Kn(t,e,l,f),m.forEach(({x:d,y:g,size:w},S)=>{
let v=wn(u,S)?.4:0,A=tr(u,S)?1:v;A&&jn(t,d,g,w,A*f)});let h=c?u:e.moments[Math.max(0,l-1)];if(Vn(t,e,h,m,n.numbers,o),c&&n.plan)for(let[d,g]of m.entries())g.alpha&&
Zn(t,e,d,C(u,d),g,n.plan[d]??0);n.you!==null&&(n.fog&&Fn(t,e,...rr(e,n.you,r)),Wn(t,m[n.you],o)),s.lineWidth=Math.max(2,2.5*o),s.strokeStyle=i.focus;let y=n.selected===
null?void 0:m[n.selected];y?.alpha&&qn(t,y.x,y.y,y.size*.96),n.cursor&&(s.setLineDash([a.cell*.12,a.cell*.08]),qn(t,n.cursor[1]+.5,n.cursor[0]+.5,.8),s.setLineDash(
[]))}function qn({ctx:t,grid:e},r,n,o){let s=o*e.cell;t.beginPath(),t.roundRect(e.left+r*e.cell-s/2,e.top+n*e.cell-s/2,s,s,s*.1),t.stroke()}var Qn=(t,e)=>(e+.24)/(t+.24);function eo(t,e,r,n,o,s){let a=r?28*s:0,i=(u,c)=>(u-a)/(c+2*.12),l=Math.max(1,Math.floor(Math.min(i(n,e),i(o,t))));return{rows:t,cols:e,
cell:l,left:Math.round((n-e*l+a)/2),top:Math.round((o-t*l+a)/2)}}function to(t,e,r){let n=Math.floor((r-t.top)/t.cell),o=Math.floor((e-t.left)/t.cell);return n>=
0&&n<t.rows&&o>=0&&o<t.cols?[n,o]:null}var na={paper:"--board-paper",line:"--board-line",frame:"--board-frame",ink:"--board-ink",muted:"--board-muted",obstacle:"--board-obstacle",pursuer:"--pursuer",
evader:"--evader",capture:"--capture",collision:"--collision",focus:"--focus"};function ro(t){let e=getComputedStyle(t),r=Object.entries(na).map(([n,o])=>[n,e.getPropertyValue(
o).trim()]);return Object.fromEntries(r)}var or=()=>matchMedia("(prefers-reduced-motion: reduce)").matches,pt=class{canvas;#e=null;#s=0;#o;#r={rows:1,cols:1,left:0,top:0,cell:1};#n=0;#a;#i;constructor(e,r={}){
this.canvas=e,e.classList.add("board"),e.setAttribute("role","img"),this.#o={...Jn,...r},this.#a=new ResizeObserver(()=>this.#p()),this.#a.observe(e),this.#i=new MutationObserver(
()=>this.redraw()),this.#i.observe(document.documentElement,{attributes:!0}),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",this.redraw),addEventListener(
"beforeprint",this.#u)}close(){this.#a.disconnect(),this.#i.disconnect(),matchMedia("(prefers-color-scheme: dark)").removeEventListener("change",this.redraw),removeEventListener(
"beforeprint",this.#u),cancelAnimationFrame(this.#n)}get look(){return this.#o}set look(e){this.#o={...this.#o,...e},this.#c(),this.redraw()}show(e,r){this.#e=e,
this.#s=Math.min(Math.max(0,r),e.moments.length-1),this.#c(),this.redraw()}redraw=()=>{this.#n||(this.#n=requestAnimationFrame(()=>this.drawNow()))};#u=()=>this.
drawNow();drawNow(){cancelAnimationFrame(this.#n),this.#n=0;let e=this.canvas.getContext("2d");if(!e||!this.#e)return;let{rows:r,cols:n}=this.#e,o=devicePixelRatio||
1;this.#r=eo(r,n,this.#o.axes,this.canvas.width,this.canvas.height,o);let s={ctx:e,grid:this.#r,colors:ro(this.canvas)};Xn(s,this.#e,this.#s,this.#o,o)}cellAt(e,r){
let n=this.canvas.getBoundingClientRect(),o=this.canvas.width/n.width;return to(this.#r,(e-n.left)*o,(r-n.top)*o)}agentAt(e,r){let n=this.cellAt(e,r);if(!n||!this.#e)
return null;let o=this.#e.moments[Math.round(this.#s)],s=Ve(this.#e,o).get(n[0]*this.#e.cols+n[1])??[],a=ft(this.#e,Math.round(this.#s)),i=l=>{let[u,c]=this.pointOf(
a[l].x,a[l].y);return Math.hypot(u-e,c-r)};return s.length?s.reduce((l,u)=>i(u)<i(l)?u:l):null}pointOf(e,r){let n=this.canvas.getBoundingClientRect(),o=n.width/
this.canvas.width,{left:s,top:a,cell:i}=this.#r;return[n.left+(s+e*i)*o,n.top+(a+r*i)*o]}#c(){if(!this.#e)return;let{rows:e,cols:r}=this.#e;this.canvas.style.setProperty(
"--board-aspect",String(Qn(e,r)))}#p(){let e=devicePixelRatio||1,{width:r,height:n}=this.canvas.getBoundingClientRect();this.canvas.width=Math.max(1,Math.round(
r*e)),this.canvas.height=Math.max(1,Math.round(n*e)),this.drawNow()}};var Ke=[.5,1,2,4,8,16,32,64],no=0,dt=12,oa=2,ht=class extends EventTarget{#e;#s;#o;#r=0;#n=0;#a=!1;#i=null;#u=0;#c=[];#p=[];glide=.28;constructor(e,r={}){super(),
this.#e=e,this.#s=r.speed??4,this.#o=r.still??!1}get step(){return this.#r}get time(){return this.#o?this.#r:this.#n}get arrived(){return this.#n===this.#r}get playing(){
return this.#a}get length(){return this.#e}set length(e){this.#e=e,this.#r>e&&this.jump(e),this.#t("state")}get marks(){return this.#c}set marks(e){this.#c=e,this.#t(
"state")}get ticks(){return this.#p}set ticks(e){this.#p=e,this.#t("state")}get pace(){return this.#s||Math.max(oa,this.#e/dt)}get speed(){return this.#s}set speed(e){
this.#s=e,this.#t("state")}changeSpeed(e){let r=Ke.findIndex(n=>n>=this.pace);this.speed=Ke[Math.min(Ke.length-1,Math.max(0,r+e))]}play(){this.#a||!this.#e||(this.#r===
this.#e&&this.jump(0),this.#a=!0,this.#t("state"),this.#f())}pause(){this.#a&&(this.#a=!1,this.#t("state"))}toggle(){this.#a?this.pause():this.play()}move(e){this.
pause();let r=Math.min(this.#e,Math.max(0,this.#r+e));Math.abs(r-this.#n)>1?this.jump(r):this.#h(r),this.#f()}jump(e){this.#n=Math.min(this.#e,Math.max(0,Math.round(
e))),this.#h(this.#n),this.#t("frame")}#h(e){e!==this.#r&&(this.#r=e,this.#t("step"),this.#o&&this.#t("frame"))}#f(){this.#i===null&&(this.#u=performance.now(),
this.#i=requestAnimationFrame(()=>this.#g()))}#g(){this.#i=null;let e=performance.now();this.#l(Math.min(.25,(e-this.#u)/1e3)),this.#u=e,(!this.#o||this.arrived)&&
this.#t("frame"),(this.#a||this.#n!==this.#r)&&(this.#i=requestAnimationFrame(()=>this.#g()))}#l(e){let r=e;for(;r>0;){if(this.#n===this.#r){if(!this.#a)return;
if(this.#r===this.#e)return this.pause();this.#h(this.#r+1)}let n=this.#a?this.pace:1/this.glide,o=this.#r-this.#n,s=Math.min(Math.abs(o),r*n);r-=s/n,this.#n=s===
Math.abs(o)?this.#r:this.#n+Math.sign(o)*s}this.#a&&this.#n===this.#e&&this.pause()}#t(e){this.dispatchEvent(new Event(e))}};function yt(t,e){if(e.ctrlKey||e.metaKey||
e.altKey)return!1;let r=e.shiftKey?10:1,o={" ":()=>t.toggle(),ArrowRight:()=>t.move(r),ArrowLeft:()=>t.move(-r),Home:()=>t.move(-t.length),End:()=>t.move(t.length),
"+":()=>t.changeSpeed(1),"-":()=>t.changeSpeed(-1)}[e.key];return o?.(),o!==void 0}var sa={first:"M6 5v14M19 5 9 12l10 7z",back:"M17 5 7 12l10 7z",play:"M7 4.5 19 12 7 19.5z",pause:"M8 5v14M16 5v14",forward:"M7 5l10 7-10 7z",last:"M18 5v14M5 5\
l10 7-10 7z"};function oo(t){return ge("svg",{viewBox:"0 0 24 24","aria-hidden":"true",class:"icon"},ge("path",{d:sa[t]}))}function Ze(t,e,r,n){return p("button",
{type:"button",class:"player-button","aria-label":e,title:`${e} (${r})`,onclick:n},oo(t))}function so(t){let e=Ze("play","Play","Space",()=>t.toggle()),r=aa(t),
n=p("div",{class:"captures","aria-hidden":"true",title:"Captures"}),o=p("div",{class:"losses","aria-hidden":"true"}),s=ia(t),a=p("output",{class:"player-count"}),
i=p("div",{class:"player",role:"group","aria-label":"Player"},Ze("first","First step","Home",()=>t.move(-t.length)),Ze("back","Step back","←",()=>t.move(-1)),
e,Ze("forward","Step forward","→",()=>t.move(1)),Ze("last","Last step","End",()=>t.move(t.length)),p("div",{class:"scrub"},n,o,r),a,s),l=(m,f={})=>{let h=p("i",
f);return h.style.left=`${100*m/Math.max(1,t.length)}%`,h},u=()=>{n.replaceChildren(...t.marks.map(m=>l(m))),o.replaceChildren(...t.ticks.map(({step:m,kind:f,size:h,
text:y})=>{let d=l(m,{class:f,title:`Step ${m}: ${y}`});return d.style.height=`${100*h}%`,d}))},c=()=>{e.replaceChildren(oo(t.playing?"pause":"play")),e.ariaLabel=
t.playing?"Pause":"Play",e.title=`${e.ariaLabel} (Space)`,r.max=String(t.length),r.value=String(t.step),r.ariaValueText=`step ${t.step} of ${t.length}`,a.textContent=
`${t.step} / ${t.length}`,a.style.minWidth=`${2*String(t.length).length+3}ch`,s.value=String(t.speed)};return t.addEventListener("step",c),t.addEventListener("s\
tate",c),t.addEventListener("state",u),i.addEventListener("keydown",m=>{!(m.target instanceof HTMLSelectElement||m.key===" "&&m.target!==r)&&yt(t,m)&&m.preventDefault()}),
c(),i}function aa(t){let e=p("input",{type:"range",class:"player-scrub",min:0,step:1,"aria-label":"Step"});return e.addEventListener("input",()=>{t.pause(),t.jump(
Number(e.value))}),e}function ia(t){let e=`Steps a second, or the whole in ${dt} s (+ and -)`,r=p("select",{class:"player-speed","aria-label":"Speed",title:e},p(
"option",{value:no},`in ${dt} s`),...Ke.map(n=>p("option",{value:n},`${n} / s`)));return r.addEventListener("change",()=>{t.speed=Number(r.value)}),r}function ao(t,e,r){if(r===0)return[{kind:"start",text:la(t),agents:[]}];let[n,o]=[e.moments[r-1],e.moments[r]],s=c=>q(c,t.config.n_pursuers),a=ct(e,n,o),i=t.conflicts(
r),l=new Set(i.flatMap(c=>c.doomed)),u=a.map(c=>({kind:"capture",text:`${s(c)} is captured`,agents:[c]}));for(let c of mt(n,o))!a.includes(c)&&!l.has(c)&&u.push(
{kind:"end",text:`${s(c)} disappears`,agents:[c]});return u.push(...i.map(({kind:c,text:m,agents:f})=>({kind:c,text:m,agents:f}))),r===t.length&&u.unshift({kind:"\
end",text:ua(t),agents:[]}),u}function la({config:t}){return`${t.n_pursuers} pursuers and ${t.n_evaders} evaders on ${t.rows} x ${t.cols} cells, at most ${t.max_steps}\
 steps`}function ua(t){let e=Math.round(t.statistics.capture_rate*t.config.n_evaders);return`The episode ends after ${t.length} steps with ${e} of ${t.config.n_evaders}\
 evaders captured`}var sr=.005,lo=.05,ca=["pursuer","evader"],ma=4,Ne=new Map;function uo(t,e,r="capture-rate"){let n=JSON.stringify([{...e,rewards:null},r]),o=Ne.get(n)??(rt(e)?Promise.
resolve(null):fa(t,e,r));return Ne.delete(n),Ne.set(n,o),Ne.size>ma&&Ne.delete([...Ne.keys()][0]),o}var co=({n_evaders:t})=>t===1?"capture-time":"capture-rate",
io=()=>new Promise(t=>setTimeout(t));async function fa(t,e,r){await io();let n=t.solution(e,r);for(;n.goBack();)await io();return n}function mo(t,e,r){let{payoff:n}=t;
return r.flatMap((o,s)=>{let a=[0,0];for(let l=e.n_turns;l>0&&!e.over;l--)t.game(e)?.lost(o).forEach((u,c)=>a[c]+=u),e.playTurn(o);let i=n==="capture-rate"?sr:lo;
return ca.map((l,u)=>({step:s+1,team:l,lost:a[u],payoff:n})).filter(l=>l.lost>=i)})}var fo=t=>t.map(e=>({step:e.step,kind:e.team,size:e.lost/Math.max(1,...t.map(
({lost:r})=>r)),text:ar(e)})),po=({lost:t,payoff:e})=>e==="capture-rate"?`${t.toFixed(2)} of the capture rate`:`${t.toFixed(1)} steps`,ar=t=>`The ${t.team}s los\
e ${po(t)} against a perfect opponent`;function ho(t){let e=t.reduce((r,n)=>n.lost>r.lost?n:r);return`Your team's worst moves, in step ${e.step}, lost ${po(e)} \
against a perfect opponent.`}function yo({config:t,payoff:e},{value:r},n){if(e==="capture-rate")return`value ${r.toFixed(2)}`;let[o,s]=[1-r,Math.min(t.max_steps-
n,Rt)];return o>s-lo?`free for ${s} steps`:`captured after ${o.toFixed(1)} steps`}function go(t,e){return(t.marginal(e)??[]).map((n,o)=>({share:n,action:o})).filter(
({share:n})=>n>=sr).sort((n,o)=>o.share-n.share).map(({share:n,action:o})=>n>1-sr?de[o]:`${de[o]} ${n.toFixed(2)}`).join(", ")}var vo=["·","↑","→","↓","←","↗","↘","↙","↖"];var pa={" ":0,ArrowUp:1,w:1,ArrowRight:2,d:2,ArrowDown:3,s:3,ArrowLeft:4,a:4,e:5,c:6,y:7,z:7,q:8},ir=[8,1,5,4,0,2,7,3,6],ha=[7,8,9,4,5,6,1,2,3],da=24,ya=Math.tan(
Math.PI/8);function wo(t,e){if(t.ctrlKey||t.metaKey||t.altKey)return;let r=ha.findIndex(o=>t.code===`Numpad${o}`),n=ir[r]??pa[t.key.length===1?t.key.toLowerCase():
t.key];return n!==void 0&&n>4&&!e?void 0:n}function xo(t){let e=ir.map(r=>p("button",{type:"button","aria-label":de[r],onclick:()=>t(r)},vo[r]));return{element:p(
"div",{class:"play-pad",role:"group","aria-label":"Your move"},...e),show:r=>e.forEach((n,o)=>n.classList.toggle("absent",ir[o]>4&&!r))}}function bo(t,e,r){let n=ya*
Math.max(Math.abs(t),Math.abs(e)),o=s=>Math.abs(s)<n?0:s;return bn([0,0],r?[o(t),o(e)]:[t,e],r)}function Ao(t,e,r){let n=null,{canvas:o}=t;o.addEventListener("p\
ointerdown",({button:s,clientX:a,clientY:i})=>{n=s===0?[a,i]:null}),o.addEventListener("pointercancel",()=>{n=null}),o.addEventListener("pointerup",({clientX:s,
clientY:a})=>{let[i,l]=[n,e()];if(n=null,!i||!l)return;let[u,c]=[s-i[0],a-i[1]],m=t.cellAt(s,a);Math.hypot(u,c)>=da?r(bo(c,u,l.diagonal)):m&&r(bo(m[0]-l.cell[0],
m[1]-l.cell[1],l.diagonal))})}function So(t,e){let r=n=>{let o=e[n]-t[n],s=ke.findIndex(a=>a[n]===Math.sign(o)&&a[1-n]===0);return o?`${Math.abs(o)} ${de[s]}`:""};
return[r(0),r(1)].filter(Boolean).join(", ")||"on your cell"}var ga=[0,1,2,4,8],gt=class{element;player=new ht(0,{speed:4,still:or()});#e;#s;#o=p("canvas",{tabindex:0,"aria-describedby":"play-keys"});#r=p("h2");#n=p("p",{
class:"play-told",role:"status"});#a=xo(e=>this.act(e));#i=p("select",{},...ga.map(e=>p("option",{value:e},e?`${e} / s`:"step by step")));#u=p("input",{type:"ch\
eckbox"});#c=p("input",{type:"checkbox"});#p=p("label",{class:"play-choice"},this.#c,"Best move");#h=p("p",{class:"small muted play-keys",id:"play-keys"});#f=p(
"section",{class:"play-ending",tabindex:-1,"aria-labelledby":"play-headline"});#g=so(this.player);#l=null;#t=null;#A=[];#m=null;#d=null;#y=[];#v=0;#b=0;constructor(e){
this.#e=e,this.#s=new pt(this.#o,{numbers:!1}),this.#o.setAttribute("role","application"),this.#i.addEventListener("change",()=>this.#w()),this.#u.addEventListener(
"change",()=>this.#M()),this.#c.addEventListener("change",()=>this.#x()),Ao(this.#s,()=>{let r=this.#m!==null&&this.#t&&C(this.#t.recording.moments.at(-1),this.#m);
return r?{cell:r,diagonal:this.#t.config.diagonal}:null},r=>this.act(r)),this.player.addEventListener("frame",()=>this.#t&&this.#s.show(this.#t.recording,this.player.
time)),this.player.addEventListener("step",()=>this.#x()),this.element=p("div",{class:"play"},p("header",{class:"play-head"},this.#r,this.#n),p("div",{class:"pl\
ay-stage"},this.#o),p("div",{class:"play-side"},this.#f,this.#a.element,p("label",{class:"play-choice",title:"Steps a second"},"Pace ",this.#i),p("label",{class:"\
play-choice"},this.#u,p("span",{},"Fog",p("span",{class:"at-length"},": see only what it sees"))),this.#p,this.#h),this.#g)}get played(){return this.#l&&{...this.#l.
played,moves:this.#A}}get live(){return this.#t}play(e){this.#S(Kt(this.#e,e.played),e.played.seat,e.title),[this.#l,this.#A,this.#v]=[e,[...e.played.moves],0],
this.element.dataset.state="playing",this.#o.focus({preventScroll:!0}),at(this.#t,e.played.seat)&&this.#_()}watch(e,r,n){this.#l=null,this.#S(e,r,n),this.#k()}stop(){
this.#w(),this.player.pause(),this.#l=null}act(e){let[r,n]=[this.#l,this.#t];if(!r||!n||this.element.dataset.state!=="playing")return;this.#v=e;let o=Number(this.#i.
value);this.#b||(this.#E(),o&&this.element.dataset.state==="playing"&&(this.#b=setInterval(()=>this.#E(),1e3/o)))}key(e){let{target:r,key:n}=e;if(r instanceof HTMLSelectElement||
r instanceof HTMLInputElement&&(r.type==="text"||n===" ")||r instanceof HTMLButtonElement&&(n===" "||n==="Enter")||!this.#t)return!1;if(this.element.dataset.state!==
"playing")return yt(this.player,e);let s=wo(e,this.#t.config.diagonal);return s!==void 0&&this.act(s),s!==void 0}#S(e,r,n){this.#w(),this.player.pause(),[this.#t,
this.#m]=[e,r],this.#r.textContent=n,this.#o.ariaLabel=`Board, ${e.config.rows} by ${e.config.cols} cells`,this.#a.show(e.config.diagonal),this.#h.replaceChildren(
p("span",{class:"at-length"},`W A S D or the arrow keys move, Space stays${e.config.diagonal?"; Q E Z C and the numeric keypad move diagonally":""}. `),"On the \
board: swipe, or tap where to go."),this.#R(e),this.#f.replaceChildren(),this.player.length=e.length,this.player.jump(e.length),this.#x()}#M(){this.#s.look={you:this.#m,
fog:this.#u.checked,viewers:this.#m===null?[]:[this.#m],plan:this.#O()}}#R(e){this.#d=null,this.#y=this.player.ticks=[],this.#p.hidden=this.#c.disabled=!!rt(e.config),
uo(this.#e,e.config,co(e.config)).then(r=>{this.#t===e&&(this.#d=r,this.#T(),this.#x())})}#T(){let[e,r]=[this.#t,this.#d];if(!r||this.element.dataset.state==="p\
laying")return;let n=this.#e.world(e.config);n.reset(e.start),this.#y=mo(r,n,e.actions),n.free(),this.player.ticks=fo(this.#y)}get#C(){return this.#c.checked&&this.#l&&
this.element.dataset.state==="playing"&&this.#d&&this.#t.game(this.#d)||null}#O(){let[e,r]=[this.#m,this.#m!==null&&this.#C?.marginal(this.#m)];return e!==null&&
r?Object.assign(Array(e).fill(0),{[e]:r.indexOf(Math.max(...r))}):null}#w(){clearInterval(this.#b),this.#b=0,this.#n.ariaLive=Number(this.#i.value)?"off":"polit\
e"}#E(){let[{policies:e,seat:r},n]=[this.#l.played,this.#t];n.step(e,r,this.#v),this.#A.push(this.#v),this.player.length=n.length,this.player.glide=Math.min(.22,
.9/(Number(this.#i.value)||4)),this.player.move(n.length-this.player.step),at(n,r)&&this.#_()}#_(){this.#w();let[e,r,n]=[this.#l,this.#t,this.played],o=tn()?e.link(
n):null;this.#f.replaceChildren(p("h3",{id:"play-headline"},wa(r,n.seat)),...e.ending(r,n),p("div",{class:"play-buttons"},p("button",{type:"button",class:"prima\
ry",onclick:()=>e.again()},"Again"),p("button",{type:"button",onclick:()=>this.#k()},"Watch it"),p("button",{type:"button",onclick:()=>this.#N(r,n.seat)},"Save"),
o&&p("button",{type:"button",onclick:({currentTarget:a})=>Aa(a,o)},"Link"))),this.element.dataset.state="ended",this.#T();let s=this.#y.filter(({team:a})=>a===fe(
r.config,n.seat));s.length&&this.#f.children[0].after(p("p",{class:"small muted"},ho(s))),this.#f.focus({preventScroll:!0}),this.#f.scrollIntoView({block:"neare\
st"})}#k(){this.element.dataset.state="watched",this.player.length=this.#t.length,this.player.jump(0),or()||this.player.play()}#N(e,r){let n=new Blob([hn(this.#e,
e,r)],{type:"application/octet-stream"});p("a",{href:URL.createObjectURL(n),download:`${q(r,e.config.n_pursuers)}-${e.length}-steps.npz`}).click()}#x(){let[e,r,
{step:n}]=[this.#t,this.#m,this.player];if(!e||n>e.length)return;let o=ao(e,e.recording,n).filter(({agents:l})=>r===null||l.includes(r)),s=this.#l&&n===0,a=s?[va(
e.config,r),this.#l.about??""]:[`Step ${n} of ${e.config.max_steps}`,...o.map(({text:l})=>l)];!s&&r!==null&&a.push(ba(e,n,r)),a.push(...this.#y.filter(l=>l.step===
n).map(ar));let i=n===e.length&&r!==null?this.#C:null;i&&a.push(`Perfect play: ${go(i,r)||"decided in its turn"}; ${yo(this.#d,i,n)}`),this.#M(),this.#n.textContent=
a.filter(Boolean).map(l=>`${l}.`).join(" ")}};function va(t,e){let r=t.rules.capture==="SURROUND";return fe(t,e)==="evader"?`Run away: you win if ${r?"the pursu\
ers do not surround you":"no pursuer reaches your cell"} in ${t.max_steps} steps`:`Capture evaders: ${r?"surround them with your team":"move onto their cells"}`}
function ba({config:t,recording:e},r,n){let o=e.moments[r],a=fe(t,n)==="pursuer"?"evader":"pursuer";if(!o.alive[n])return"";let i=C(o,n),l=m=>{let[f,h]=C(o,m);return Math.
max(Math.abs(f-i[0]),Math.abs(h-i[1]))},u=Array.from({length:o.alive.length},(m,f)=>f).filter(m=>fe(t,m)===a&&o.alive[m]&&!o.captured[m-t.n_pursuers]&&2*l(m)<t.
fov);if(!u.length)return`No ${a} in view`;let c=u.reduce((m,f)=>l(f)<l(m)?f:m);return`Nearest ${a}: ${So(i,C(o,c))}`}function wa(t,e){let[{lasted:r,out:n,captured:o},
{config:s}]=[pe(t,e),t];return fe(s,e)==="pursuer"?`Your team captured ${o} of ${xa(s)} in ${r} steps.`:n?`You lasted ${r} of ${s.max_steps} steps.`:`You escape\
d: ${r} steps.`}var xa=({n_evaders:t})=>`${t} evader${t===1?"":"s"}`;function Aa(t,e){let r=p("input",{type:"text",readonly:!0,value:e,"aria-label":"Link to thi\
s match"});t.replaceWith(r),r.select(),navigator.clipboard?.writeText(e).catch(()=>{})}var Mo={escape:"Can you escape it?",match:"One match",file:"A match from a file"},Sa="You move one agent. Scripts, or networks that evolved, move all others.",Q=JSON.
parse(Vt("data")),ne={pursuer:To("pursuer"),evader:To("evader")};function To(t){let{names:e,texts:r,scripts:n,network:o}=Q.teams[t],s=a=>{let i=n[a];if(i||!o)return i;
let[l,u]=[o.genome_size,n.slice(0,a).filter(c=>c===null).length];return{...o,genome:Qr(t,l).subarray(u*l,(u+1)*l)}};return e.map((a,i)=>({name:a.replaceAll("-",
" "),text:r[i],policy:()=>s(i)}))}function ko(t,e,r,n,o){r.show("match",{...n,seat:o.seat});let[s,a]=[Q.world,ye[+(o.seat>=Q.world.n_pursuers)]],i=ye.map(c=>ne[c][n[c]].
name),l={pursuer:ne.pursuer[n.pursuer].policy(),evader:ne.evader[n.evader].policy()},u=`You are ${q(o.seat,s.n_pursuers)}. Pursuers: ${i[0]}; evaders: ${i[1]}`;
Zt(t,e,u,{config:s,seed:n.seed,episode:0,policies:l,...o},ne[a],{pursuers:n.pursuer,evaders:n.evader,seed:n.seed})}function Co(t,e,r){let n=new URLSearchParams(
location.hash.slice(1)),o=un(n,Q.world),[s,a]=[Number(n.get("pursuers")??NaN),Number(n.get("evaders")??NaN)],i=/^\d{1,20}$/.test(n.get("seed")??"")?BigInt.asUintN(
64,BigInt(n.get("seed"))):null;return!o||i===null||!ne.pursuer[s]||!ne.evader[a]?!1:(ko(t,e,r,{pursuer:s,evader:a,seed:i},o),!0)}var vt=(t,e)=>p("select",{},...t.
map((r,n)=>p("option",{value:n,selected:n===e},r)));function Ma(t,e){let r=Object.keys(Mo),n=vt(Object.values(Mo),0),o=vt(["an evader","a pursuer"],0),s={pursuer:vt(
Eo("pursuer"),Q.teams.pursuer.usual),evader:vt(Eo("evader"),Q.teams.evader.usual)},a=p("div",{class:"of-match"},p("label",{},"You are ",o),p("label",{},"Pursuer\
s ",s.pursuer),p("label",{},"Evaders ",s.evader)),i=y=>ne[y][s[y].selectedIndex],l=p("ul",{class:"small muted about"}),u=()=>{let y=r[n.selectedIndex];a.hidden=
y!=="match",l.replaceChildren(...y==="escape"?Ee(ne.pursuer).map(({name:d})=>_o(d,"pursuer")):y==="match"?ye.map(d=>_o(i(d).name,d,i(d).text)):[])};for(let y of[
n,...Object.values(s)])y.addEventListener("change",u);let c=p("p",{class:"problem",role:"alert"}),m=p("input",{type:"file",accept:".npz",hidden:!0}),f={element:p(
"details",{class:"card setup",open:matchMedia("(min-width: 761px)").matches},p("summary",{},"Play something else"),p("div",{},p("label",{},"Game ",n),a,p("butto\
n",{type:"button",class:"primary",onclick:()=>h[r[n.selectedIndex]]()},"Play"),m,c,l)),show:(y,d)=>{if(n.selectedIndex=r.indexOf(y),d){o.selectedIndex=+(d.seat<
Q.world.n_pursuers);for(let g of ye)s[g].selectedIndex=d[g]}u()}},h={escape:()=>Ro(e,f),match:()=>ko(t,e,f,{pursuer:s.pursuer.selectedIndex,evader:s.evader.selectedIndex,
seed:it()},{seat:o.selectedIndex?0:Q.world.n_pursuers,from:0,moves:[]}),file:()=>m.click()};return m.addEventListener("change",()=>{let[y]=m.files??[];c.textContent=
"",y?.arrayBuffer().then(d=>dn(t,new Uint8Array(d))).then(({live:d,seat:g})=>{f.show("file"),e.watch(d,g,y.name)}).catch(d=>c.textContent=`${y.name} holds no ma\
tch: ${d.message}`),m.value=""}),f}var Eo=t=>ne[t].map(({name:e})=>e),_o=(t,e,r="")=>p("li",{},gn(t,e),p("span",{},p("span",{class:e},t),r&&`: ${r}`));function Ro(t,e){
e.show("escape"),Jt(t,Q.world,ne.pursuer)}async function Ta(){let t=await Ir(),e=new gt(t),r=Ma(t,e);document.getElementById("page").replaceWith(nn("Play a chas\
e",Sa),p("main",{},r.element,p("section",{class:"card","aria-label":"Match"},e.element)),p("footer",{class:"muted small"},`${Q.title} · matrixworld ${Q.version}`)),
document.addEventListener("keydown",n=>e.key(n)&&n.preventDefault()),window.addEventListener("hashchange",()=>Co(t,e,r)),Co(t,e,r)||Ro(e,r),Object.assign(window,
{matrixworldPlay:e})}Ta().catch(t=>{throw(document.getElementById("page")??document.body).append(p("p",{class:"card problem",role:"alert"},`The page could not s\
tart: ${t instanceof Y?t.message:String(t)}`)),t}).finally(()=>{document.body.dataset.ready="true"});})();
