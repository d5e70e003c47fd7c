/* built from web/ by "npm run build"; sources ddb13f157b8ae616b14690b13a2e4818600e9bc37f049f6021d61d6474cc90dd */
"use strict";(()=>{var ir={SIMULTANEOUS:0,SWARM_TURNS:1,AGENT_TURNS:2},Ie={DISAPPEAR:0,REACH:1,BOUNCE:2},lr={OCCUPATION:0,SURROUND:1},ur={FAULT:0,INVOLVED:1};var bt=["obstacle","teammate","adversary"],wt=["vertex","edge","chain"],cr=["turn","kind","form","first","second","row","col","at_fault","held","doomed"],xt=["p\
ursuer_{number}","evader_{number}"],fr={obstacle:"{first} ran into the obstacle or border at {cell}",vertex:"{first} and {second} both headed for {cell}",edge:"\
{first} and {second} meant to swap, {first} to {cell}",chain:"{first} headed for {cell}, where {second} had to stay"},Le={"both held":"both bounce","both doomed":"\
both disappear",held:"{agent} bounces",doomed:"{agent} disappears",none:"nobody is stopped"},pr="{event}: {outcome}",At={random:"any action, all equally likely",
still:"always stays",chaser:"moves to where the nearest adversary in view is nearest",fleer:"moves to where the nearest adversary in view is farthest","clumsy-c\
haser":"a chaser that takes any action in half of the steps",hunter:"a chaser of the nearest adversary in view to which no teammate in view is nearer",surrounder:"\
a chaser of the nearest free cell beside an adversary without a teammate","clumsy-fleer":"a fleer that takes any action in half of the steps",dodger:"moves to w\
here all adversaries in view together are farthest","team-surrounder":"shares the free cells beside adversaries with its teammates, and searches","careful-rando\
m":"as random, but takes only moves that right of way allows","careful-chaser":"as chaser, but takes only moves that right of way allows","careful-fleer":"as fl\
eer, but takes only moves that right of way allows","careful-clumsy-chaser":"as clumsy-chaser, but takes only moves that right of way allows","careful-hunter":"\
as hunter, but takes only moves that right of way allows","careful-surrounder":"as surrounder, but takes only moves that right of way allows","careful-clumsy-fl\
eer":"as clumsy-fleer, but takes only moves that right of way allows","careful-dodger":"as dodger, but takes only moves that right of way allows","careful-team-\
surrounder":"as team-surrounder, but takes only moves that right of way allows"},mr={free:".GS",blocked:"#@OTW"};var be=1+cr.length;function $e(t,e){return t.replace(/\{(\w+)\}/g,(r,n)=>String(e[n]))}function q(t,e){return t<e?$e(xt[0],{number:t}):$e(xt[1],{number:t-e})}function So(t,e){
let[r,n,o,s,a,i,u,...l]=Array.from(t),c=a<0?[s]:[s,a],[f,p,m]=l.map(w=>c.filter((S,v)=>w>>v&1)),y=c.map(w=>q(w,e)),d=$e(fr[a<0?"obstacle":wt[o]],{first:y[0],second:y[y.
length-1],cell:`(${i}, ${u})`}),g=$e(pr,{event:d,outcome:Mo(c.length,p,m,e)});return{kind:bt[n],form:wt[o],agents:c,cell:[i,u],at_fault:f,held:p,doomed:m,turn:r,
text:g}}function Mo(t,e,r,n){if(t===2&&e.length===2)return Le["both held"];if(t===2&&r.length===2)return Le["both doomed"];let o=s=>a=>$e(Le[s],{agent:q(a,n)});
return[...e.map(o("held")),...r.map(o("doomed"))].join(", ")||Le.none}function qe(t,e){let r=[];for(let n=0;n<t.length;n+=be)r.push(So(t.subarray(n+1,n+be),e));
return r}var Y=class extends Error{name="EngineError"};function P(t,e,r){let n=typeof r=="string"?`'${r}'`:typeof r=="object"?JSON.stringify(r):String(r);return new Y(`${t}\
: expected ${e}, got ${n}`)}var we=class{bytes;constructor(e){this.bytes=e}},yr=0,Mt=[Uint8Array,Uint8Array,Int32Array,BigInt64Array,BigUint64Array,Float32Array,Float64Array],hr=4,dr=4,To=new TextEncoder,
Co=new TextDecoder;function Eo(t){for(let e=Mt.length-1;e>yr;--e)if(t instanceof Mt[e])return e;throw new TypeError("array: expected a typed array of the engine\
's numbers, got another")}function St(t){return new Uint8Array(t.buffer,t.byteOffset,t.byteLength)}function _o(t){return To.encode(`${t}\0`)}var Tt=class{engine;addresses=[];constructor(e){
this.engine=e}copy(e){let r=this.engine._malloc(Math.max(e.length,1));if(r===0)throw new Y("memory: expected room for the arguments, got none");return this.addresses.
push(r),this.engine.HEAPU8.set(e,r),r}text(e){return this.copy(_o(e))}arrays(e){let r=Object.entries(e),n=r.flatMap(([s,a])=>{let i=a instanceof we,u=i?a.bytes:
a;return[this.text(s),i?yr:Eo(u),u.length,this.copy(St(u))]}),o=this.copy(St(Int32Array.from(n)));return this.copy(St(Int32Array.of(r.length,o)))}free(){for(let e of this.
addresses)this.engine._free(e)}};function gr(t,e){let r=t.HEAPU8;return Co.decode(r.subarray(e,r.indexOf(0,e)))}function xe(t){let e=new Int32Array(t.HEAPU8.buffer),
r=t._last_outputs()/hr,n=e[r+1]/hr,o={};for(let s=n;s<n+e[r]*dr;s+=dr){let a=Mt[e[s+1]],i=e[s+2]*a.BYTES_PER_ELEMENT,u=e[s+3];o[gr(t,e[s])]=new a(t.HEAPU8.slice(
u,u+i).buffer)}return o}function ue(t,e){let r=new Tt(t);try{let n=e(r);if(n===0)throw new Y(gr(t,t._last_error()));return n}finally{r.free()}}var ko=2**31-1,vr=["none","elman","gru"],Ro=2n**64n-1n,No=34028234663852886e22;function se(t,e){if(typeof e!="number"||!Number.isInteger(e)||Math.abs(e)>ko)throw P(
t,"an integer",e);return Int32Array.of(e)}function Je(t,e){if(typeof e!="boolean")throw P(t,"true or false",e);return new we(Uint8Array.of(Number(e)))}function me(t,e,r){
let n=typeof e=="string"&&Object.hasOwn(r,e)?r[e]:void 0;if(n===void 0)throw P(t,`one of ${Object.keys(r).join(", ")}`,e);return Int32Array.of(n)}function Ct(t,e){
if(typeof e!="number"||!(Math.abs(e)<=No))throw P(t,"a finite number",e);return e}function Ae(t,e){let n=typeof e=="bigint"||typeof e=="number"&&Number.isSafeInteger(
e)?BigInt(e):-1n;if(n<0n||n>Ro)throw P(t,"an integer from 0 to 2^64 - 1",e);return BigUint64Array.of(n)}function Oo(t){return{"rules.interaction":me("interactio\
n",t.interaction,ir),"rules.obstacle":me("obstacle",t.obstacle,Ie),"rules.teammate":me("teammate",t.teammate,Ie),"rules.evader":me("evader",t.evader,Ie),"rules.\
pursuer":me("pursuer",t.pursuer,Ie),"rules.capture":me("capture",t.capture,lr),"rules.captured_disappear":Je("captured_disappear",t.captured_disappear)}}function br(t,e){
let r=typeof e=="number"?[e,e,e]:e;if(!Array.isArray(r)||r.length!==3)throw P(t,"1 or 3 numbers",e);return Float32Array.from(r,n=>Ct(t,n))}function Po(t){let e=(r,n)=>Float32Array.
of(Ct(r,t[r]),Ct(n,t[n]));return{"rewards.capture":e("pursuer_capture","evader_capture"),"rewards.neighbor":e("pursuer_neighbor","evader_neighbor"),"rewards.ste\
p":e("pursuer_step","evader_step"),"rewards.pursuer_collide":br("pursuer_collide",t.pursuer_collide),"rewards.evader_collide":br("evader_collide",t.evader_collide),
"rewards.blame":me("blame",t.blame,ur),"rewards.capture_repeats":Je("capture_repeats",t.capture_repeats)}}function xr(t){if(t===void 0||typeof t=="number")return new Uint8Array(
0);if(t instanceof Uint8Array)return t;let{free:e,blocked:r}=mr;for(let[n,o]of t.entries()){if(o.length!==t[0]?.length)throw P(`map, row ${n}`,`${t[0]?.length} \
cells as in row 0`,o.length);let s=[...o].find(a=>!e.includes(a)&&!r.includes(a));if(s)throw P(`map, row ${n}`,`'${e}' (free) or '${r}' (obstacle)`,s)}return Uint8Array.
from([...t.join("")],n=>Number(r.includes(n)))}function Ar(t,e){if(!Array.isArray(t))return;let r=[t.length,t[0]?.length??0];if(!(r[0]===e.rows&&r[1]===e.cols))
throw P("obstacle map",`shape (${e.rows}, ${e.cols}), the rows and cols`,r)}function Se(t){Ar(t.obstacles,t);let e=typeof t.obstacles=="number"?t.obstacles:0;return{
...Oo(t.rules),...Po(t.rewards),rows:se("rows",t.rows),cols:se("cols",t.cols),n_pursuers:se("n_pursuers",t.n_pursuers),n_evaders:se("n_evaders",t.n_evaders),fov:se(
"fov",t.fov),diagonal:Je("diagonal",t.diagonal),max_steps:se("max_steps",t.max_steps),density:Float64Array.of(e),map:xr(t.obstacles)}}function wr(t,e){return Int32Array.
from((e??[]).flat(),r=>se(t,r)[0])}function Sr(t,e){return Ar(t.obstacles,e),{seed:Ae("seed",t.seed??0n),episode:Ae("episode",t.episode??0),pursuers:wr("pursuer\
s",t.pursuers),evaders:wr("evaders",t.evaders),map:xr(t.obstacles)}}function Xe(t){return{actions:Int32Array.from(t,e=>se("actions",e)[0])}}function Me(t){if(typeof t==
"string"){if(!Object.hasOwn(At,t))throw P("policy",`one of ${Object.keys(At).join(", ")}`,t);return{script:new TextEncoder().encode(t)}}if(t.activation!=="relu"&&
t.activation!=="tanh")throw P("activation","'relu' or 'tanh'",t.activation);if(!vr.includes(t.memory))throw P("memory",`one of ${vr.join(", ")}`,t.memory);return{
hidden:Int32Array.from(t.hidden,e=>se("hidden",e)[0]),activation:new TextEncoder().encode(t.activation),sampled:Je("sampled",t.sampled),memory:new TextEncoder().
encode(t.memory),genome:t.genome}}var Io=["first_turn","terminated","truncated"];function Mr(t){let e={...t};for(let r of Io)e[r]=new we(t[r]);return e}var Tr="statistics.",Qe=class{config;seed;episode;n_agents;statistics;first_conflict;constructor(e,r,n,o){this.config=e,this.seed=r,this.episode=n,this.n_agents=
e.n_pursuers+e.n_evaders,this.statistics=Cr(Er(o),0),Object.assign(this,o),this.first_conflict=Lo(this.conflict_table,this.length)}get length(){return this.actions.
length/this.n_agents}conflicts(e){this.check(e);let[r,n]=[this.first_conflict[e],this.first_conflict[e+1]],o=this.conflict_table.subarray(r*be,n*be);return qe(o,
this.config.n_pursuers)}seek(e,r,n){this.check(r),(!(e.seed===this.seed&&e.episode===BigInt(this.episode))||e.turn!==0||e.steps>r)&&e.reset({seed:this.seed,episode:this.
episode});for(let s=e.steps;s<r;++s){let a=this.actions.subarray(s*this.n_agents,(s+1)*this.n_agents);n?e.replay(a,{pursuer:n.pursuers,evader:n.evaders}):e.step(
a)}}check(e){if(!(Number.isInteger(e)&&e>=0&&e<=this.length))throw P("step",`0 to ${this.length}`,e)}};function Lo(t,e){let r=new Int32Array(e+2);for(let n=0;n<
t.length;n+=be)++r[t[n]+1];for(let n=1;n<r.length;++n)r[n]+=r[n-1];return r}function Cr(t,e){let r=t.length.length,n=s=>{let a=t[s],i=a.length/r;return a.slice(
e*i,(e+1)*i)},o=s=>Number(n(s)[0]);return{capture_rate:o("capture_rate"),ever_capture_rate:o("ever_capture_rate"),captured_fraction:o("captured_fraction"),length:o(
"length"),return:n("return"),survivors:n("survivors"),overlap:n("overlap"),collisions:n("collisions"),faults:n("faults"),agent_steps:n("agent_steps")}}var Er=t=>Object.
fromEntries(Object.entries(t).flatMap(([e,r])=>e.startsWith(Tr)?[[e.slice(Tr.length),r]]:[]));function _r(t,e,r,n){let o=[Se(r.config),Me(r.pursuers),Me(r.evaders),
n];return ue(t,s=>{let[a,i,u,l]=o.map(c=>s.arrays(c));return t[e](a,i,u,l)}),xe(t)}function kr(t,e,r,n){let o={seed:Ae("seed",r),episode:Ae("episode",n)};return new Qe(
e.config,r,n,_r(t,"_play_match",e,o))}function Et(t,e,r,n){if(!Number.isInteger(n)||n<1)throw P("n_episodes","at least 1",n);let o=_r(t,"_play_rollout",e,{...r,
n_episodes:Int32Array.of(n)});return Er(o)}function Rr(t,e,r,n){let o={pursuer:Int32Array.of(0),evader:Int32Array.of(0),seed:Ae("seed",r)},s=Et(t,e,o,n);return Array.
from({length:n},(a,i)=>Cr(s,i))}var $o=7e6,Uo=new FinalizationRegistry(([t,e])=>t._states_free(e));function zo({rules:t,rows:e,cols:r,obstacles:n,diagonal:o,n_pursuers:s,n_evaders:a}){let i=typeof n==
"number"||t.obstacle==="REACH"?0:n.join("").split("#").length-1,u=e*r-i,l=[t.obstacle,t.teammate,t.pursuer].includes("DISAPPEAR"),c=t.capture==="SURROUND"||t.evader===
"REACH",f=t.interaction==="AGENT_TURNS",p=(d,g)=>Array.from({length:g},(w,S)=>f?d:(d+S)/(S+1)).reduce((w,S)=>w*S,1),m=p(u+Number(l),s)*p(u*(1+Number(c))+2,a);return{
SIMULTANEOUS:[s+a],SWARM_TURNS:[s,a],AGENT_TURNS:Array(s+a).fill(1)}[t.interaction].reduce((d,g)=>d+m*(o?9:5)**g,0)}function et(t){return typeof t.obstacles=="n\
umber"&&t.obstacles>0?"obstacles are drawn anew in each episode":zo(t)>$o?"the world is too large to be solved on the page":""}var _t=class{value;teams;matrix;n_actions;constructor(e,r){
let{matrix:n,rows:o,cols:s,value:a,agents:i}=r,[u,l]=e.actors,c=Array.from(i).filter(p=>u<=p&&p<l),f=p=>p<e.config.n_pursuers;[this.value,this.matrix,this.n_actions]=
[a[0],n,e.n_actions],this.teams=[{agents:c.filter(f),play:o},{agents:c.filter(p=>!f(p)),play:s}]}marginal(e){let r=this.teams.find(({agents:s})=>s.includes(e));
if(!r)return null;let n=this.n_actions**(r.agents.length-1-r.agents.indexOf(e)),o=Array(this.n_actions).fill(0);return r.play.forEach((s,a)=>o[Math.floor(a/n)%this.
n_actions]+=s),o}lost(e){let[r,n]=this.teams.map(({agents:u})=>u.reduce((l,c)=>l*this.n_actions+e[c],0)),[o,s]=this.teams.map(({play:u})=>u),a=s.reduce((u,l,c)=>u+
l*this.matrix[r*s.length+c],0),i=o.reduce((u,l,c)=>u+l*this.matrix[c*s.length+n],0);return[Math.max(0,this.value-a),Math.max(0,i-this.value)]}},kt=60,Ue=class{config;payoff;engine;states;n_turns;values;constructor(e,r,n){
[this.engine,this.config,this.payoff]=[e,r,n],this.states=ue(e,a=>e._states_new(a.arrays(Se(r)))),Uo.register(this,[e,this.states]);let o={SIMULTANEOUS:1,SWARM_TURNS:2,
AGENT_TURNS:r.n_pursuers+r.n_evaders};this.n_turns=o[r.rules.interaction];let s=this.call(()=>e._states_payoffs(this.states)).payoffs;this.values=[[n==="capture\
-rate"?s:s.fill(0)]]}goBack(){let e=this.values.at(-1)[0],r=[];for(let o=this.n_turns-1;o>=0;o--){let s=r[o+1]??e;r[o]=this.call(a=>this.engine._states_backup(this.
states,o,a.arrays({next:s}))).values}this.payoff==="capture-time"&&(r[0]=r[0].map((o,s)=>s===this.config.n_evaders?0:o-1)),this.values.push(r);let n=this.payoff===
"capture-rate"?this.config.max_steps:Math.min(this.config.max_steps,kt);return this.values.length<=n&&r[0].some((o,s)=>o!==e[s])}game(e){let[r,{turn:n}]=[this.config.
max_steps-e.steps,e],o=n+1===this.n_turns,s=r>0?this.values[Math.min(r-Number(o),this.values.length-1)]?.[o?0:n+1]:void 0;if(!s)return null;let a=this.call(i=>this.
engine._states_game(this.states,e.address,i.arrays({next:s})));return a.agents.length?new _t(e,a):null}call(e){return ue(this.engine,e),xe(this.engine)}};var Nr=new FinalizationRegistry(([t,e])=>t._world_free(e)),ze=class{config;n_agents;n_actions;engine;at;freed=!1;constructor(e,r){this.engine=e,this.config=r,this.
n_agents=r.n_pursuers+r.n_evaders,this.n_actions=r.diagonal?9:5,this.at=ue(e,n=>e._world_new(n.arrays(Se(r)))),Nr.register(this,[e,this.at],this)}free(){this.freed||
(this.freed=!0,Nr.unregister(this),this.engine._world_free(this.at))}get address(){if(this.freed)throw P("world","one that is in use","one that was freed");return this.
at}reset(e={}){let r=Sr(e,this.config);this.call(n=>this.engine._world_reset(this.address,n.arrays(r)))}step(e){let r=Xe(e);this.call(n=>this.engine._world_step(
this.address,n.arrays(r)))}playTurn(e){let r=Xe(e);this.call(n=>this.engine._world_play_turn(this.address,n.arrays(r)))}decide(e,r,n){let{n_pursuers:o}=this.config,
s={pursuer:[0,o],evader:[o,this.n_agents]},[a,i]=typeof r=="string"?s[r]:r;if(n.length!==this.n_agents)throw P("actions",String(this.n_agents),n.length);let u=[
Me(e),Xe(n)],{actions:l}=this.call(c=>this.engine._world_decide(this.address,c.arrays(u[0]),a,i,c.arrays(u[1])));return Uint8Array.from(l)}replay(e,r){let n=s=>typeof s!=
"string"&&s.memory!=="none";if(!n(r.pursuer)&&!n(r.evader))return this.step(e);let{n_pursuers:o}=this.config;for(let s=this.n_turns;s>0;--s){let[a,i]=this.actors;
a<o&&this.decide(r.pursuer,[a,Math.min(i,o)],e),i>o&&this.decide(r.evader,[Math.max(a,o),i],e),this.playTurn(e)}}get n_turns(){return this.turnNumbers()[1]}get turn(){
return this.turnNumbers()[0]}get actors(){let[,,e,r]=this.turnNumbers();return[e,r]}turnNumbers(){return this.call(()=>this.engine._world_turn(this.address)).turn}get steps(){
return this.read("steps")[0]}get seed(){return this.read("seed")[0]}get episode(){return this.read("episode")[0]}get over(){return this.read("terminated")[0]===
1||this.read("truncated")[0]===1}read(e){return this.call(r=>this.engine._world_read(this.address,r.text(e)))[e]}view(e){let r=3*this.config.fov**2;return this.
read("views").slice(e*r,(e+1)*r)}map(){return this.read("state").slice(2*this.config.rows*this.config.cols)}conflicts(){return qe(this.conflictTable(),this.config.
n_pursuers)}conflictTable(){return this.call(()=>this.engine._world_conflicts(this.address)).conflict_table}answer(e,r){let n=Me(e),{logits:o,memory:s}=this.call(
u=>this.engine._world_logits(this.address,u.arrays(n),r)),a=o,i=this.decide(e,[r,r+1],new Uint8Array(this.n_agents))[r];return{logits:a,probabilities:Wo(a),action:i,
memory:s}}snapshot(){return this.call(()=>this.engine._world_snapshot(this.address))}restore(e){let r=Mr(e);this.call(n=>this.engine._world_restore(this.address,
n.arrays(r)))}call(e){return ue(this.engine,e),xe(this.engine)}};function Wo(t){let e=Math.max(...t),r=Array.from(t,o=>Math.exp(o-e)),n=r.reduce((o,s)=>o+s,0);return Float32Array.
from(r,o=>o/n)}var Rt=class{compiled;constructor(e){this.compiled=e}world(e){return new ze(this.compiled,e)}solution(e,r="capture-rate"){return new Ue(this.compiled,e,r)}match(e,r,n,o,s=0){
return kr(this.compiled,{config:e,pursuers:r,evaders:n},o,s)}rollout(e,r,n,o,s){return Rr(this.compiled,{config:e,pursuers:r,evaders:n},o,s)}rollouts(e,r,n,o,s){
return Et(this.compiled,{config:e,pursuers:r,evaders:n},o,s)}},Or;function Pr(t=globalThis.matrixworldEngine){return Or??=Fo(t),Or}async function Fo(t){if(!t)throw new Error(
"matrixworldEngine: expected the script engine.js before this one, got none");let e=Uint8Array.from(atob(t.binary),r=>r.charCodeAt(0));return new Rt(await t({wasmBinary:e}))}var T=Uint8Array,j=Uint16Array,Dt=Int32Array,rt=new T([0,0,0,0,0,0,0,0,1,1,1,1,2,2,2,2,3,3,3,3,4,4,4,4,5,5,5,5,0,0,0,0]),nt=new T([0,0,0,0,1,1,2,2,3,3,4,4,5,5,6,
6,7,7,8,8,9,9,10,10,11,11,12,12,13,13,0,0]),Lt=new T([16,17,18,0,8,7,9,6,10,5,11,4,12,3,13,2,14,1,15]),Wr=function(t,e){for(var r=new j(31),n=0;n<31;++n)r[n]=e+=
1<<t[n-1];for(var o=new Dt(r[30]),n=1;n<30;++n)for(var s=r[n];s<r[n+1];++s)o[s]=s-r[n]<<5|n;return{b:r,r:o}},Fr=Wr(rt,2),Dr=Fr.b,$t=Fr.r;Dr[28]=258,$t[258]=28;var Br=Wr(
nt,0),Do=Br.b,Ir=Br.r,Ut=new j(32768);for(M=0;M<32768;++M)ae=(M&43690)>>1|(M&21845)<<1,ae=(ae&52428)>>2|(ae&13107)<<2,ae=(ae&61680)>>4|(ae&3855)<<4,Ut[M]=((ae&65280)>>
8|(ae&255)<<8)>>1;var ae,M,te=(function(t,e,r){for(var n=t.length,o=0,s=new j(e);o<n;++o)t[o]&&++s[t[o]-1];var a=new j(e);for(o=1;o<e;++o)a[o]=a[o-1]+s[o-1]<<1;
var i;if(r){i=new j(1<<e);var u=15-e;for(o=0;o<n;++o)if(t[o])for(var l=o<<4|t[o],c=e-t[o],f=a[t[o]-1]++<<c,p=f|(1<<c)-1;f<=p;++f)i[Ut[f]>>u]=l}else for(i=new j(
n),o=0;o<n;++o)t[o]&&(i[o]=Ut[a[t[o]-1]++]>>15-t[o]);return i}),ce=new T(288);for(M=0;M<144;++M)ce[M]=8;var M;for(M=144;M<256;++M)ce[M]=9;var M;for(M=256;M<280;++M)
ce[M]=7;var M;for(M=280;M<288;++M)ce[M]=8;var M,De=new T(32);for(M=0;M<32;++M)De[M]=5;var M,Bo=te(ce,9,0),Go=te(ce,9,1),Ho=te(De,5,0),jo=te(De,5,1),Nt=function(t){
for(var e=t[0],r=1;r<t.length;++r)t[r]>e&&(e=t[r]);return e},J=function(t,e,r){var n=e/8|0;return(t[n]|t[n+1]<<8)>>(e&7)&r},Ot=function(t,e){var r=e/8|0;return(t[r]|
t[r+1]<<8|t[r+2]<<16)>>(e&7)},Bt=function(t){return(t+7)/8|0},Be=function(t,e,r){return(e==null||e<0)&&(e=0),(r==null||r>t.length)&&(r=t.length),new T(t.subarray(
e,r))};var Vo=["unexpected EOF","invalid block type","invalid length/literal","invalid distance","stream finished","no stream handler",,"no callback","invalid UTF-8 da\
ta","extra field too long","date not in range 1980-2099","filename too long","stream finishing","invalid zip data"],z=function(t,e,r){var n=new Error(e||Vo[t]);
if(n.code=t,Error.captureStackTrace&&Error.captureStackTrace(n,z),!r)throw n;return n},Gr=function(t,e,r,n){var o=t.length,s=n?n.length:0;if(!o||e.f&&!e.l)return r||
new T(0);var a=!r,i=a||e.i!=2,u=e.i;a&&(r=new T(o*3));var l=function(Oe){var Pe=r.length;if(Oe>Pe){var ve=new T(Math.max(Pe*2,Oe));ve.set(r),r=ve}},c=e.f||0,f=e.
p||0,p=e.b||0,m=e.l,y=e.d,d=e.m,g=e.n,w=o*8;do{if(!m){c=J(t,f,1);var S=J(t,f+1,3);if(f+=3,S)if(S==1)m=Go,y=jo,d=9,g=5;else if(S==2){var N=J(t,f,31)+257,R=J(t,f+
10,15)+4,x=N+J(t,f+5,31)+1;f+=14;for(var b=new T(x),I=new T(19),O=0;O<R;++O)I[Lt[O]]=J(t,f+O*3,7);f+=R*3;for(var W=Nt(I),le=(1<<W)-1,B=te(I,W,1),O=0;O<x;){var F=B[J(
t,f,le)];f+=F&15;var v=F>>4;if(v<16)b[O++]=v;else{var L=0,_=0;for(v==16?(_=3+J(t,f,3),f+=2,L=b[O-1]):v==17?(_=3+J(t,f,7),f+=3):v==18&&(_=11+J(t,f,127),f+=7);_--;)
b[O++]=L}}var D=b.subarray(0,N),$=b.subarray(N);d=Nt(D),g=Nt($),m=te(D,d,1),y=te($,g,1)}else z(1);else{var v=Bt(f)+4,A=t[v-4]|t[v-3]<<8,E=v+A;if(E>o){u&&z(0);break}
i&&l(p+A),r.set(t.subarray(v,E),p),e.b=p+=A,e.p=f=E*8,e.f=c;continue}if(f>w){u&&z(0);break}}i&&l(p+131072);for(var Ne=(1<<d)-1,V=(1<<g)-1,oe=f;;oe=f){var L=m[Ot(
t,f)&Ne],G=L>>4;if(f+=L&15,f>w){u&&z(0);break}if(L||z(2),G<256)r[p++]=G;else if(G==256){oe=f,m=null;break}else{var H=G-254;if(G>264){var O=G-257,k=rt[O];H=J(t,f,
(1<<k)-1)+Dr[O],f+=k}var Q=y[Ot(t,f)&V],ye=Q>>4;Q||z(3),f+=Q&15;var $=Do[ye];if(ye>3){var k=nt[ye];$+=Ot(t,f)&(1<<k)-1,f+=k}if(f>w){u&&z(0);break}i&&l(p+131072);
var ge=p+H;if(p<$){var Ke=s-$,Ze=Math.min($,ge);for(Ke+p<0&&z(3);p<Ze;++p)r[p]=n[Ke+p]}for(;p<ge;++p)r[p]=r[p-$]}}e.l=m,e.p=oe,e.b=p,e.f=c,m&&(c=1,e.m=d,e.d=y,e.
n=g)}while(!c);return p!=r.length&&a?Be(r,0,p):r.subarray(0,p)},ie=function(t,e,r){r<<=e&7;var n=e/8|0;t[n]|=r,t[n+1]|=r>>8},We=function(t,e,r){r<<=e&7;var n=e/
8|0;t[n]|=r,t[n+1]|=r>>8,t[n+2]|=r>>16},Pt=function(t,e){for(var r=[],n=0;n<t.length;++n)t[n]&&r.push({s:n,f:t[n]});var o=r.length,s=r.slice();if(!o)return{t:jr,
l:0};if(o==1){var a=new T(r[0].s+1);return a[r[0].s]=1,{t:a,l:1}}r.sort(function(E,N){return E.f-N.f}),r.push({s:-1,f:25001});var i=r[0],u=r[1],l=0,c=1,f=2;for(r[0]=
{s:-1,f:i.f+u.f,l:i,r:u};c!=o-1;)i=r[r[l].f<r[f].f?l++:f++],u=r[l!=c&&r[l].f<r[f].f?l++:f++],r[c++]={s:-1,f:i.f+u.f,l:i,r:u};for(var p=s[0].s,n=1;n<o;++n)s[n].s>
p&&(p=s[n].s);var m=new j(p+1),y=zt(r[c-1],m,0);if(y>e){var n=0,d=0,g=y-e,w=1<<g;for(s.sort(function(N,R){return m[R.s]-m[N.s]||N.f-R.f});n<o;++n){var S=s[n].s;
if(m[S]>e)d+=w-(1<<y-m[S]),m[S]=e;else break}for(d>>=g;d>0;){var v=s[n].s;m[v]<e?d-=1<<e-m[v]++-1:++n}for(;n>=0&&d;--n){var A=s[n].s;m[A]==e&&(--m[A],++d)}y=e}return{
t:new T(m),l:y}},zt=function(t,e,r){return t.s==-1?Math.max(zt(t.l,e,r+1),zt(t.r,e,r+1)):e[t.s]=r},Lr=function(t){for(var e=t.length;e&&!t[--e];);for(var r=new j(
++e),n=0,o=t[0],s=1,a=function(u){r[n++]=u},i=1;i<=e;++i)if(t[i]==o&&i!=e)++s;else{if(!o&&s>2){for(;s>138;s-=138)a(32754);s>2&&(a(s>10?s-11<<5|28690:s-3<<5|12305),
s=0)}else if(s>3){for(a(o),--s;s>6;s-=6)a(8304);s>2&&(a(s-3<<5|8208),s=0)}for(;s--;)a(o);s=1,o=t[i]}return{c:r.subarray(0,n),n:e}},Fe=function(t,e){for(var r=0,
n=0;n<e.length;++n)r+=t[n]*e[n];return r},Hr=function(t,e,r){var n=r.length,o=Bt(e+2);t[o]=n&255,t[o+1]=n>>8,t[o+2]=t[o]^255,t[o+3]=t[o+1]^255;for(var s=0;s<n;++s)
t[o+s+4]=r[s];return(o+4+n)*8},$r=function(t,e,r,n,o,s,a,i,u,l,c){ie(e,c++,r),++o[256];for(var f=Pt(o,15),p=f.t,m=f.l,y=Pt(s,15),d=y.t,g=y.l,w=Lr(p),S=w.c,v=w.n,
A=Lr(d),E=A.c,N=A.n,R=new j(19),x=0;x<S.length;++x)++R[S[x]&31];for(var x=0;x<E.length;++x)++R[E[x]&31];for(var b=Pt(R,7),I=b.t,O=b.l,W=19;W>4&&!I[Lt[W-1]];--W)
;var le=l+5<<3,B=Fe(o,ce)+Fe(s,De)+a,F=Fe(o,p)+Fe(s,d)+a+14+3*W+Fe(R,I)+2*R[16]+3*R[17]+7*R[18];if(u>=0&&le<=B&&le<=F)return Hr(e,c,t.subarray(u,u+l));var L,_,D,
$;if(ie(e,c,1+(F<B)),c+=2,F<B){L=te(p,m,0),_=p,D=te(d,g,0),$=d;var Ne=te(I,O,0);ie(e,c,v-257),ie(e,c+5,N-1),ie(e,c+10,W-4),c+=14;for(var x=0;x<W;++x)ie(e,c+3*x,
I[Lt[x]]);c+=3*W;for(var V=[S,E],oe=0;oe<2;++oe)for(var G=V[oe],x=0;x<G.length;++x){var H=G[x]&31;ie(e,c,Ne[H]),c+=I[H],H>15&&(ie(e,c,G[x]>>5&127),c+=G[x]>>12)}}else
L=Bo,_=ce,D=Ho,$=De;for(var x=0;x<i;++x){var k=n[x];if(k>255){var H=k>>18&31;We(e,c,L[H+257]),c+=_[H+257],H>7&&(ie(e,c,k>>23&31),c+=rt[H]);var Q=k&31;We(e,c,D[Q]),
c+=$[Q],Q>3&&(We(e,c,k>>5&8191),c+=nt[Q])}else We(e,c,L[k]),c+=_[k]}return We(e,c,L[256]),c+_[256]},Yo=new Dt([65540,131080,131088,131104,262176,1048704,1048832,
2114560,2117632]),jr=new T(0),Ko=function(t,e,r,n,o,s){var a=s.z||t.length,i=new T(n+a+5*(1+Math.ceil(a/7e3))+o),u=i.subarray(n,i.length-o),l=s.l,c=(s.r||0)&7;if(e){
c&&(u[0]=s.r>>3);for(var f=Yo[e-1],p=f>>13,m=f&8191,y=(1<<r)-1,d=s.p||new j(32768),g=s.h||new j(y+1),w=Math.ceil(r/3),S=2*w,v=function(vt){return(t[vt]^t[vt+1]<<
w^t[vt+2]<<S)&y},A=new Dt(25e3),E=new j(288),N=new j(32),R=0,x=0,b=s.i||0,I=0,O=s.w||0,W=0;b+2<a;++b){var le=v(b),B=b&32767,F=g[le];if(d[B]=F,g[le]=B,O<=b){var L=a-
b;if((R>7e3||I>24576)&&(L>423||!l)){c=$r(t,u,0,A,E,N,x,I,W,b-W,c),I=R=x=0,W=b;for(var _=0;_<286;++_)E[_]=0;for(var _=0;_<30;++_)N[_]=0}var D=2,$=0,Ne=m,V=B-F&32767;
if(L>2&&le==v(b-V))for(var oe=Math.min(p,L)-1,G=Math.min(32767,b),H=Math.min(258,L);V<=G&&--Ne&&B!=F;){if(t[b+D]==t[b+D-V]){for(var k=0;k<H&&t[b+k]==t[b+k-V];++k)
;if(k>D){if(D=k,$=V,k>oe)break;for(var Q=Math.min(V,k-2),ye=0,_=0;_<Q;++_){var ge=b-V+_&32767,Ke=d[ge],Ze=ge-Ke&32767;Ze>ye&&(ye=Ze,F=ge)}}}B=F,F=d[B],V+=B-F&32767}
if($){A[I++]=268435456|$t[D]<<18|Ir[$];var Oe=$t[D]&31,Pe=Ir[$]&31;x+=rt[Oe]+nt[Pe],++E[257+Oe],++N[Pe],O=b+D,++R}else A[I++]=t[b],++E[t[b]]}}for(b=Math.max(b,O);b<
a;++b)A[I++]=t[b],++E[t[b]];c=$r(t,u,l,A,E,N,x,I,W,b-W,c),l||(s.r=c&7|u[c/8|0]<<3,c-=7,s.h=g,s.p=d,s.i=b,s.w=O)}else{for(var b=s.w||0;b<a+l;b+=65535){var ve=b+65535;
ve>=a&&(u[c/8|0]=l,ve=a),c=Hr(u,c+1,t.subarray(b,ve))}s.i=a}return Be(i,0,n+Bt(c)+o)},Zo=(function(){for(var t=new Int32Array(256),e=0;e<256;++e){for(var r=e,n=9;--n;)
r=(r&1&&-306674912)^r>>>1;t[e]=r}return t})(),qo=function(){var t=-1;return{p:function(e){for(var r=t,n=0;n<e.length;++n)r=Zo[r&255^e[n]]^r>>>8;t=r},d:function(){
return~t}}};var Jo=function(t,e,r,n,o){if(!o&&(o={l:1},e.dictionary)){var s=e.dictionary.subarray(-32768),a=new T(s.length+t.length);a.set(s),a.set(t,s.length),t=a,o.w=s.length}
return Ko(t,e.level==null?6:e.level,e.mem==null?o.l?Math.ceil(Math.max(8,Math.min(13,Math.log(t.length)))*1.5):20:12+e.mem,r,n,o)},Vr=function(t,e){var r={};for(var n in t)
r[n]=t[n];for(var n in e)r[n]=e[n];return r};var ee=function(t,e){return t[e]|t[e+1]<<8},X=function(t,e){return(t[e]|t[e+1]<<8|t[e+2]<<16|t[e+3]<<24)>>>0},It=function(t,e){return X(t,e)+X(t,e+4)*4294967296},
U=function(t,e,r){for(;r;++e)t[e]=r,r>>>=8};var Xo=function(t,e){return((t[0]&15)!=8||t[0]>>4>7||(t[0]<<8|t[1])%31)&&z(6,"invalid zlib data"),(t[1]>>5&1)==+!e&&z(6,"invalid zlib data: "+(t[1]&32?"need":"u\
nexpected")+" dictionary"),(t[1]>>3&4)+2};function Qo(t,e){return Jo(t,e||{},0,0)}function es(t,e){return Gr(t,{i:2},e&&e.out,e&&e.dictionary)}function Yr(t,e){return Gr(t.subarray(Xo(t,e&&e.dictionary),-4),{i:2},e&&e.out,e&&e.dictionary)}var Kr=function(t,e,r,n){for(var o in t){var s=t[o],a=e+o,i=n;Array.isArray(s)&&(i=Vr(n,s[1]),s=s[0]),s instanceof T?r[a]=[s,i]:(r[a+="/"]=[new T(0),i],Kr(s,a,r,
n))}},Ur=typeof TextEncoder<"u"&&new TextEncoder,Wt=typeof TextDecoder<"u"&&new TextDecoder,ts=0;try{Wt.decode(jr,{stream:!0}),ts=1}catch{}var rs=function(t){for(var e="",
r=0;;){var n=t[r++],o=(n>127)+(n>223)+(n>239);if(r+o>t.length)return{s:e,r:Be(t,r-1)};o?o==3?(n=((n&15)<<18|(t[r++]&63)<<12|(t[r++]&63)<<6|t[r++]&63)-65536,e+=String.
fromCharCode(55296|n>>10,56320|n&1023)):o&1?e+=String.fromCharCode((n&31)<<6|t[r++]&63):e+=String.fromCharCode((n&15)<<12|(t[r++]&63)<<6|t[r++]&63):e+=String.fromCharCode(
n)}};function tt(t,e){if(e){for(var r=new T(t.length),n=0;n<t.length;++n)r[n]=t.charCodeAt(n);return r}if(Ur)return Ur.encode(t);for(var o=t.length,s=new T(t.length+
(t.length>>1)),a=0,i=function(c){s[a++]=c},n=0;n<o;++n){if(a+5>s.length){var u=new T(a+8+(o-n<<1));u.set(s),s=u}var l=t.charCodeAt(n);l<128||e?i(l):l<2048?(i(192|
l>>6),i(128|l&63)):l>55295&&l<57344?(l=65536+(l&1047552)|t.charCodeAt(++n)&1023,i(240|l>>18),i(128|l>>12&63),i(128|l>>6&63),i(128|l&63)):(i(224|l>>12),i(128|l>>
6&63),i(128|l&63))}return Be(s,0,a)}function Gt(t,e){if(e){for(var r="",n=0;n<t.length;n+=16384)r+=String.fromCharCode.apply(null,t.subarray(n,n+16384));return r}else{
if(Wt)return Wt.decode(t);var o=rs(t),s=o.s,r=o.r;return r.length&&z(8),s}}var ns=function(t,e){return e+30+ee(t,e+26)+ee(t,e+28)},os=function(t,e,r){var n=ee(t,e+28),o=Gt(t.subarray(e+46,e+46+n),!(ee(t,e+8)&2048)),s=e+46+n,a=X(t,e+20),
i=r&&a==4294967295?ss(t,s):[a,X(t,e+24),X(t,e+42)],u=i[0],l=i[1],c=i[2];return[ee(t,e+10),u,l,o,s+ee(t,e+30)+ee(t,e+32),c]},ss=function(t,e){for(;ee(t,e)!=1;e+=
4+ee(t,e+2));return[It(t,e+12),It(t,e+4),It(t,e+20)]},Ft=function(t){var e=0;if(t)for(var r in t){var n=t[r].length;n>65535&&z(9),e+=n+4}return e},zr=function(t,e,r,n,o,s,a,i){
var u=n.length,l=r.extra,c=i&&i.length,f=Ft(l);U(t,e,a!=null?33639248:67324752),e+=4,a!=null&&(t[e++]=20,t[e++]=r.os),t[e]=20,e+=2,t[e++]=r.flag<<1|(s<0&&8),t[e++]=
o&&8,t[e++]=r.compression&255,t[e++]=r.compression>>8;var p=new Date(r.mtime==null?Date.now():r.mtime),m=p.getFullYear()-1980;if((m<0||m>119)&&z(10),U(t,e,m<<25|
p.getMonth()+1<<21|p.getDate()<<16|p.getHours()<<11|p.getMinutes()<<5|p.getSeconds()>>1),e+=4,s!=-1&&(U(t,e,r.crc),U(t,e+4,s<0?-s-2:s),U(t,e+8,r.size)),U(t,e+12,
u),U(t,e+14,f),e+=16,a!=null&&(U(t,e,c),U(t,e+6,r.attrs),U(t,e+10,a),e+=14),t.set(n,e),e+=u,f)for(var y in l){var d=l[y],g=d.length;U(t,e,+y),U(t,e+2,g),t.set(d,
e+4),e+=4+g}return c&&(t.set(i,e),e+=c),e},as=function(t,e,r,n,o){U(t,e,101010256),U(t,e+8,r),U(t,e+10,r),U(t,e+12,n),U(t,e+16,o)};function Zr(t,e){e||(e={});var r={},n=[];Kr(t,"",r,e);var o=0,s=0;for(var a in r){var i=r[a],u=i[0],l=i[1],c=l.level==0?0:8,f=tt(a),p=f.length,m=l.comment,y=m&&
tt(m),d=y&&y.length,g=Ft(l.extra);p>65535&&z(11);var w=c?Qo(u,l):u,S=w.length,v=qo();v.p(u),n.push(Vr(l,{size:u.length,crc:v.d(),c:w,f,m:y,u:p!=a.length||y&&m.length!=
d,o,compression:c})),o+=30+p+g+S,s+=76+2*(p+g)+(d||0)+S}for(var A=new T(s+22),E=o,N=s-o,R=0;R<n.length;++R){var f=n[R];zr(A,f.o,f,f.f,f.u,f.c.length);var x=30+f.
f.length+Ft(f.extra);A.set(f.c,f.o+x),zr(A,o,f,f.f,f.u,f.c.length,f.o,f.m),o+=16+x+(f.m?f.m.length:0)}return as(A,o,n.length,N,E),A}function qr(t,e){for(var r={},n=t.length-22;X(t,n)!=101010256;--n)(!n||t.length-n>65558)&&z(13);var o=ee(t,n+8);if(!o)return{};var s=X(t,n+16),a=s==4294967295||
o==65535;if(a){var i=X(t,n-12);a=X(t,i)==101075792,a&&(o=X(t,i+32),s=X(t,i+48))}for(var u=e&&e.filter,l=0;l<o;++l){var c=os(t,s,a),f=c[0],p=c[1],m=c[2],y=c[3],d=c[4],
g=c[5],w=ns(t,g);s=d,(!u||u({name:y,size:p,originalSize:m,compression:f}))&&(f?f==8?r[y]=es(t.subarray(w,w+p),{out:new T(m)}):z(14,"unknown compression type "+f):
r[y]=Be(t,w,w+p))}return r}var Te=["pursuer","evader"];var Ht=4,Jr=new Map;function Xr(t,e){let r=Jr.get(t);if(r)return r;let n=new Float32Array;try{let o=ls(us(t),e);o.every(Number.isFinite)&&(n=o)}catch(o){if(!(o instanceof DOMException||
o instanceof RangeError||is(o)))throw o}return Jr.set(t,n),n}var is=t=>t instanceof Error&&"code"in t;function ls(t,e){let r=Yr(t),n=r.length/Ht,o=new Uint8Array(
r.length);for(let a=0;a<o.length;a++)o[a]=r[a%Ht*n+Math.floor(a/Ht)];let s=new Uint32Array(o.buffer);for(let a=e;a<s.length;a++)s[a]^=s[a-e];return new Float32Array(
o.buffer)}function us(t){let e=atob(jt(t)),r=new Uint8Array(e.length);for(let n=0;n<r.length;n++)r[n]=e.charCodeAt(n);return r}function jt(t){return document.getElementById(
t)?.textContent??""}var cs="http://www.w3.org/2000/svg";function h(t,e={},...r){return Qr(document.createElement(t),e,r)}function Vt(t,e={},...r){return Qr(document.createElementNS(
cs,t),e,r)}function Qr(t,e,r){for(let[n,o]of Object.entries(e))o==null||o===!1||(typeof o=="function"?t.addEventListener(n.slice(2),o):t.setAttribute(n,o===!0?"":
String(o)));return t.append(...r.filter(fs).map(n=>typeof n=="number"?String(n):n)),t}function fs(t){return t!=null&&t!==!1}var en=()=>["file:","http:","https:"].
includes(location.protocol);var he=["stay","north","east","south","west","northeast","southeast","southwest","northwest"];function ps(){let t=document.documentElement.dataset.theme;return t?t==="dark":matchMedia("(prefers-color-scheme: dark)").matches}function ms(){document.documentElement.
dataset.theme=ps()?"light":"dark"}function tn(){return h("button",{type:"button",title:"Light or dark (D)","aria-label":"Light or dark",onclick:ms},"◐")}function rn(t,e,r){return{rows:t.rows,cols:t.cols,nPursuers:t.n_pursuers,fov:t.fov,interaction:t.rules.interaction,obstacles:e,moments:r}}function Yt(t,e){return{
positions:t.read("last_positions"),alive:t.read("alive"),captured:t.read("captured"),everCaptured:t.read("ever_captured"),actions:e,involved:t.read("involved"),
fault:t.read("fault"),contested:t.conflicts().map(r=>r.cell)}}var Ge=class{config;start;recording;actions=[];#e;#s;#o=[[]];constructor(e,r,n){[this.config,this.start]=[r,n],this.#e=e.world(r),this.#e.reset(n),this.#s=[Yt(this.#e)],
this.recording=rn(r,this.#e.map(),this.#s)}get length(){return this.actions.length}get over(){return this.#e.over}get statistics(){return{capture_rate:this.#e.read(
"capture_rate")[0]}}conflicts(e){return this.#o[e]}game(e){return e.game(this.#e)}play(e){this.#e.step(e),this.#r(e)}step(e,r,n){let[o,s]=[this.#e,this.config.n_pursuers],
a=new Uint8Array(o.n_agents);for(let i=o.n_turns;i>0&&!o.over;--i){let[u,l]=o.actors;u<s&&(a=o.decide(e.pursuer,[u,Math.min(l,s)],a)),l>s&&(a=o.decide(e.evader,
[Math.max(u,s),l],a)),typeof n=="number"?a[r]=n:u<=r&&r<l&&(a=o.decide(n,[r,r+1],a)),o.playTurn(a)}this.#r(a)}#r(e){this.actions.push(e),this.#s.push(Yt(this.#e,
e)),this.#o.push(this.#e.conflicts())}};function nn(t,e,r,n){let o=new Ge(t,e,r);for(let s of n)o.play(s);return o}var fe=(t,e)=>Te[+(e>=t.n_pursuers)];function Kt(t,e){let r=new Ge(t,e.config,{seed:e.seed,episode:e.episode});for(let n of e.moves)r.over||r.step(e.policies,e.
seat,n);return r}function pe(t,e){let{moments:r,nPursuers:n}=t.recording,o=r.findIndex(({alive:a,captured:i})=>!a[e]||!!i[e-n]),s=o<0?t.length:o;return{lasted:s,
out:o>=0,captured:Array.from(r[s].everCaptured).filter(Boolean).length}}var ot=(t,e)=>t.over||pe(t,e).out;function on(t,e,r){let n=Kt(t,{...e,moves:e.moves.slice(
0,e.from)});for(;!ot(n,e.seat);)n.step(e.policies,e.seat,r);return pe(n,e.seat)}function st(t){let e=t.length-1;return[...new Set([0,Math.round(e/3),e])].map(r=>t[r])}
function sn(t,{seat:e,from:r,moves:n}){let o={...t,seat:e,...r?{from:r}:{},moves:n.join("")};return`${location.href.split("#")[0]}#${Object.entries(o).map(([s,a])=>`${s}\
=${a}`).join("&")}`}function an(t,e){let[r,n,o]=[t.get("seat")??"",t.get("from")??"0",t.get("moves")??""];return/^\d{1,6}$/.test(r)&&Number(r)<e.n_pursuers+e.n_evaders&&
(e.diagonal?/^[0-8]+$/:/^[0-4]+$/).test(o)&&o.length<=e.max_steps&&/^\d{1,6}$/.test(n)&&Number(n)<=o.length?{seat:Number(r),from:Number(n),moves:[...o].map(Number)}:
null}var at=()=>crypto.getRandomValues(new BigUint64Array(1))[0];function Zt(t,e,r,n,o,s){e.play({title:r,played:n,ending:(a,i)=>[hs(t,a,i,st(o))],again:()=>Zt(t,e,r,{...n,moves:n.moves.slice(0,n.from)},o,s),link:a=>s&&sn(s,a)})}
function hs(t,e,r,n){let o=fe(r.config,r.seat)==="evader",s=o?r.config.max_steps:r.config.n_evaders,a=h("table",{class:"numbers"},h("caption",{},o?"Steps in you\
r seat: same start, same others":"Captures of your team: same start, same others")),i=l=>{let[c,f]=[h("span",{class:o?"bar evader":"bar pursuer"}),h("td",{},"…")];
return a.append(h("tr",{},h("th",{scope:"row"},l),h("td",{class:"track","aria-hidden":"true"},c),f)),({lasted:p,captured:m})=>{c.style.width=`${100*(o?p:m)/s}%`,
f.textContent=String(o?p:m)}};i("You")(pe(e,r.seat));for(let{name:l,policy:c}of n){let f=i(l);setTimeout(()=>f(on(t,r,c())))}let u=r.from?`You took over at step\
 ${r.from}. `:"";return h("div",{},a,h("p",{class:"small muted"},`${u}One match: luck has its part in it.`))}var ds=20,qt=60;function ys(t){let e=t.rules.capture==="SURROUND"?8:4,r=typeof t.obstacles!="number",n=o=>r?o:Math.min(o,ds);return{...t,rows:n(t.rows),cols:n(t.
cols),max_steps:qt,n_evaders:1,n_pursuers:Math.min(t.n_pursuers,e)}}function it(t,e,r){let[n,o,s]=[ys(e),st(r),[]],a=()=>`${s.reduce((u,l)=>u+l,0)} of ${qt*o.length}`,
i=()=>t.play({title:`Can you escape it? Round ${s.length+1} of ${o.length}: ${o[s.length].name}`,about:o[s.length].text&&`${o[s.length].name}: ${o[s.length].text}`,
played:{config:n,seed:at(),episode:0,seat:n.n_pursuers,from:0,moves:[],policies:{pursuer:o[s.length].policy(),evader:"still"}},ending:u=>{s.push(pe(u,n.n_pursuers).
lasted);let l=o.map(({name:f},p)=>h("tr",{},h("th",{scope:"row"},f),h("td",{},s[p]??""))),c=s.length<o.length;return[h("table",{class:"numbers"},h("caption",{},
`Steps of ${qt} in each round`),...l),h("p",{class:"play-score"},c?"Score so far: ":"Your score: ",h("strong",{},a())),c?h("button",{type:"button",class:"primar\
y",onclick:i},"Next round"):""]},again:()=>it(t,e,r),link:()=>null});i()}var gs={"|b1":t=>new Uint8Array(t),"|i1":t=>new Int8Array(t),"<i4":t=>new Int32Array(t),"<i8":t=>Int32Array.from(new BigInt64Array(t),Number),"<f4":t=>new Float32Array(
t)},un="NUMPY\0",Ce=un.length+2,ln=64;function cn(t){return Zr(Object.fromEntries(Object.entries(t).map(([e,r])=>[`${e}.npy`,vs(r)])))}function vs({dtype:t,shape:e,
data:r}){let n=typeof r=="string"?Array.from(r,c=>c.codePointAt(0)):null,o=e.map(c=>`${c}, `).join(""),s=`{'descr': '${n?`<U${n.length}`:t}', 'fortran_order': F\
alse, 'shape': (${o}), }`,a=Math.ceil((Ce+s.length+1)/ln)*ln-Ce,i=un+String.fromCharCode(a&255,a>>8)+s.padEnd(a-1)+`
`,u=n?Int32Array.from(n):r,l=new Uint8Array(i.length+u.byteLength);return l.set(tt(i,!0)),l.set(new Uint8Array(u.buffer,u.byteOffset,u.byteLength),i.length),l}function fn(t){
return Object.fromEntries(Object.entries(qr(t)).map(([e,r])=>[e.replace(/\.npy$/,""),bs(r)]))}function bs(t){let e=Ce+t[Ce-2]+256*t[Ce-1],r=Gt(t.subarray(Ce,e),
!0),n=/'descr': '([^']+)', 'fortran_order': False, 'shape': \(([\d, ]*)\)/.exec(r),[o,s]=[n?.[1]??"",(n?.[2]??"").split(",").filter(l=>l.trim()).map(Number)],a=t.
slice(e).buffer,i=o.startsWith("<U")&&String.fromCodePoint(...new Int32Array(a)),u=i===!1?gs[o]?.(a):i.replace(/\0+$/,"");if(u===void 0)throw new TypeError(`exp\
ected an array of numbers or a text, got ${r.slice(0,80)}`);return{dtype:o,shape:s,data:u}}var Jt="matrixworld episode 3";function pn(t,e,r){let{config:n,actions:o,length:s,recording:a}=e,[i,u]=[n.n_pursuers+n.n_evaders,n.n_evaders],l={positions:["<i4",
i,2],last_positions:["<i4",i,2],alive:["|b1",i],captured:["|b1",u],ever_captured:["|b1",u]},c={rewards:["<f4",i],involved:["|b1",i,3],fault:["|b1",i,3]},f={},p=v=>{
for(let A of Object.keys(v))(f[A]??=[]).push(Array.from(m.read(A),Number))},m=t.world(n);m.reset(e.start);let y=[];p(l);for(let v of o)m.step(v),p({...l,...c}),
y.push(...m.conflictTable());m.free();let d={"<i4":Int32Array,"<f4":Float32Array,"|b1":Uint8Array},g={};for(let[v,[A,...E]]of Object.entries({...l,...c})){let N=s+
+(v in l);g[v]={dtype:A,shape:[N,...E],data:d[A].from((f[v]??[]).flat())}}let w=v=>({dtype:"<i8",shape:[],data:Int32Array.of(v,0)}),S=v=>({dtype:"<U",shape:[],data:v});
return cn({format:S(Jt),n_pursuers:w(n.n_pursuers),config:S(JSON.stringify(n)),seat:w(r),...g,actions:{dtype:"|i1",shape:[s,i],data:Int8Array.from(o.flatMap(v=>[
...v]))},map:{dtype:"|b1",shape:[n.rows,n.cols],data:Uint8Array.from(a.obstacles,Number)},conflict_table:{dtype:"<i4",shape:[y.length/11,11],data:Int32Array.from(
y)}})}function mn(t,e){let r=fn(e),n=m=>Array.from(r[m]?.data??[]);if(r.format?.data!==Jt)throw new Y(`expected a file marked "${Jt}"`);let o=JSON.parse(r.config.
data),s=o.n_pursuers+o.n_evaders,a=n("positions"),i=(m,y)=>Array.from({length:y-m},(d,g)=>[a[2*(m+g)],a[2*(m+g)+1]]),u={pursuers:i(0,o.n_pursuers),evaders:i(o.n_pursuers,
s),obstacles:Uint8Array.from(n("map"))},l=Uint8Array.from(n("actions")),c=Array.from({length:l.length/s},(m,y)=>l.subarray(y*s,(y+1)*s)),f=nn(t,o,u,c);if(Array.
from(f.recording.moments.at(-1).positions).join()!==n("last_positions").slice(-2*s).join())throw new Y("expected the moves of this start to lead to its end");return{
live:f,seat:n("seat")[0]??null}}var Ee=[[0,0],[-1,0],[0,1],[1,0],[0,-1],[-1,1],[1,1],[1,-1],[-1,-1]];function hn(t,e,r){let[n,o]=[e[0]-t[0],e[1]-t[1]];return!r&&Math.abs(n)>Math.abs(o)?o=0:r||
(n=0),Ee.findIndex(([s,a])=>s===Math.sign(n)&&a===Math.sign(o))}var de=(t,e)=>e<t.nPursuers,C=(t,e)=>[t.positions[2*e],t.positions[2*e+1]],ws=(t,e)=>t[0]===e[0]&&
t[1]===e[1],Xt=({rows:t,cols:e},[r,n])=>r>=0&&n>=0&&r<t&&n<e,Qt=(t,e,r=3)=>t!==void 0&&[0,1,2].slice(0,r).some(n=>t[3*e+n]),er=(t,e)=>Qt(t.fault,e),dn=(t,e)=>!er(
t,e)&&Qt(t.involved,e,2);function lt(t,e,r){let n=!ws(C(t,r),C(e,r)),o=e.involved===void 0||Qt(e.involved,r);return!!(e.alive[r]&&e.actions?.[r]&&!n&&o)}function ut(t,e,r){
let[n,o]=C(t,r),[s,a]=Ee[e.actions?.[r]??0];return[n+s,o+a]}function ct(t,e,r){return Array.from({length:r.everCaptured.length},(o,s)=>s).filter(o=>r.everCaptured[o]&&
!e.everCaptured[o]).map(o=>t.nPursuers+o)}function ft(t,e){return Array.from({length:e.alive.length},(n,o)=>o).filter(n=>t.alive[n]&&!e.alive[n])}var yn=[-.31,0,.31],gn=[{size:1,at:[[0,0]]},{size:.62,at:[[-.2,.2],[.2,-.2]]},{size:.54,at:[[-.23,.22],[.23,.22],[0,-.22]]},{size:.54,at:[[-.23,.23],[.23,.23],[
-.23,-.23],[.23,-.23]]},{size:.36,at:yn.flatMap(t=>yn.map(e=>[e,t]))}],xs=.3,As=.35,Ss=.55;function He(t,e){let r=new Map;for(let n=0;n<e.alive.length;n++){if(!e.
alive[n])continue;let[o,s]=C(e,n),a=o*t.cols+s,i=r.get(a);i?i.push(n):r.set(a,[n])}return r}function vn(t,e){let r=Array.from(e.alive,(n,o)=>{let[s,a]=C(e,o);return{
x:a+.5,y:s+.5,size:1,alpha:0}});for(let n of He(t,e).values()){let o=gn[Math.min(n.length,gn.length)-1];n.forEach((s,a)=>{let[i,u]=o.at[Math.min(a,o.at.length-1)],
l=r[s];l.x+=i,l.y+=u,l.size=o.size,l.alpha=1})}return r}var bn=t=>t*t*(3-2*t),_e=(t,e,r)=>t+(e-t)*r,wn=t=>Math.min(1,Math.max(0,t));function xn(t,e,r,n){let o={
SIMULTANEOUS:1,SWARM_TURNS:2,AGENT_TURNS:r}[t.interaction];if(o===1)return bn(n);let s=o===r?e:+!de(t,e),a=Math.max(1/o,As);return bn(wn((n-s/(o-1)*(1-a))/a))}function pt(t,e){
let r=t.moments.length-1,n=Math.min(Math.floor(e),r),o=t.moments[n],s=vn(t,o);if(n===r||e===n)return s;let a=t.moments[n+1],i=vn(t,a);return s.map((u,l)=>{let c=xn(
t,l,s.length,e-n);return Ms(o,a,l,u,i[l],c)})}function tr(t,e,r){let n=t.moments.length-1,o=Math.min(Math.floor(r),n),[s,a]=[t.moments[o],t.moments[Math.min(o+1,
n)]],i=xn(t,e,s.alive.length,r-o),[[u,l],[c,f]]=[C(s,e),C(a,e)];return[_e(l,f,i)+.5,_e(u,c,i)+.5]}function Ms(t,e,r,n,o,s){let a=n.alpha>o.alpha,i={x:_e(n.x,o.x,
s),y:_e(n.y,o.y,s),size:a?n.size:_e(n.size,o.size,s),alpha:a?wn((1-s)/(1-Ss)):_e(n.alpha,o.alpha,s)};if(lt(t,e,r)){let[u,l]=C(t,r),[c,f]=ut(t,e,r),p=xs*Math.sin(
Math.PI*s);i.x+=(f-l)*p,i.y+=(c-u)*p}return i}var An=2*Math.PI;function je(t,e,r,n){t.beginPath(),t.arc(e,r,n/2,0,An)}function Sn(t,e,r,n){let o=n/2,s=[[0,-.97],[.97,.83],[-.97,.83]].map(([a,i])=>[e+a*o,r+i*
o]);t.beginPath(),t.moveTo((s[2][0]+s[0][0])/2,(s[2][1]+s[0][1])/2),s.forEach(([a,i],u)=>{let[l,c]=s[(u+1)%3];t.arcTo(a,i,l,c,n*.09)}),t.closePath()}function Mn(t,e,r,n){
let o=n*.32;t.beginPath(),t.moveTo(e-o,r-o),t.lineTo(e+o,r+o),t.moveTo(e+o,r-o),t.lineTo(e-o,r+o)}function Tn(t,e,r,n){t.beginPath();for(let o=0;o<16;o++){let s=n/
2*(o%2?.6:.95),a=An*o/16;t.lineTo(e+s*Math.sin(a),r-s*Math.cos(a))}t.closePath()}function Cn(t,e,r,n,o,s){let a=Math.atan2(o-r,n-e);t.beginPath(),t.moveTo(e,r),
t.lineTo(n,o);for(let i of[-1,1])t.moveTo(n,o),t.lineTo(n-s*Math.cos(a+i*.6),o-s*Math.sin(a+i*.6))}var En=4,Ts=1.6,Cs=.95,Es=5,_s=.16,ks=9,Rs=.09,Ns=.2,_n=.75,K=(t,e)=>t.left+e*t.cell,Z=(t,e)=>t.top+e*t.cell;function ke(t,e,r){return de(e,r)?t.colors.pursuer:
t.colors.evader}function kn({ctx:t,grid:e,colors:r}){let{left:n,top:o,cell:s,rows:a,cols:i}=e,[u,l]=[i*s,a*s];if(t.fillStyle=r.paper,t.fillRect(n,o,u,l),s<Es)return;
t.fillStyle=r.line;let c=Math.max(1,Math.round(s/60));for(let f=1;f<i;f++)t.fillRect(n+f*s,o,c,l);for(let f=1;f<a;f++)t.fillRect(n,o+f*s,u,c)}function Rn({ctx:t,
grid:e,colors:r},n){let{left:o,top:s,cell:a,rows:i,cols:u}=e;t.fillStyle=r.obstacle;for(let l=0;l<i*u;l++){if(!n.obstacles[l])continue;let[c,f]=[Math.floor(l/u),
l%u];t.fillRect(o+f*a,s+c*a,a,a)}Nn({ctx:t,grid:e,colors:r})}function Nn({ctx:t,grid:{left:e,top:r,cell:n,rows:o,cols:s},colors:a}){let i=Math.min(5,Math.max(2,
Math.round(n/18)));t.strokeStyle=a.frame,t.lineWidth=i,t.strokeRect(e-i/2,r-i/2,s*n+i,o*n+i)}function On({ctx:t,grid:e,colors:r},n){let{left:o,top:s,cell:a,rows:i,
cols:u}=e,l=a<24*n?5:1;t.font=`500 ${Math.round(Math.min(15*n,Math.max(9*n,a*.32)))}px system-ui, sans-serif`,t.fillStyle=r.muted,t.textBaseline="alphabetic",t.
textAlign="center";let c=5*n+a/40;for(let f=0;f<u;f+=l)t.fillText(String(f),o+(f+.5)*a,s-c);t.textAlign="right",t.textBaseline="middle";for(let f=0;f<i;f+=l)t.fillText(
String(f),o-c,s+(f+.5)*a)}function Pn({grid:t},e,r,n){let o=Math.floor(e.fov/2)+.5,[s,a]=[Math.max(0,r-o),Math.min(t.cols,r+o)],[i,u]=[Math.max(0,n-o),Math.min(
t.rows,n+o)];return[K(t,s),Z(t,i),(a-s)*t.cell,(u-i)*t.cell]}function In(t,e,r,n){let{ctx:o,grid:s,colors:a}=t;o.save(),o.beginPath(),o.rect(0,0,o.canvas.width,
o.canvas.height),o.rect(...Pn(t,e,r,n)),o.clip("evenodd"),o.clearRect(0,0,o.canvas.width,o.canvas.height),o.fillStyle=a.line,o.fillRect(s.left,s.top,s.cols*s.cell,
s.rows*s.cell),o.restore(),Nn(t)}function Ln({ctx:t,grid:e,colors:r},{x:n,y:o,alpha:s},a){let i=Math.max(e.cell,16*a)*1.06,[u,l]=[K(e,n),Z(e,o)];t.globalAlpha=Math.
max(s,.6),t.beginPath(),t.roundRect(u-i/2,l-i/2,i,i,i*.2),t.strokeStyle=r.focus,t.lineWidth=Math.max(2,2.5*a),t.stroke();let c=Math.max(11*a,Math.min(18*a,e.cell*
.5));t.font=`700 ${Math.round(c)}px system-ui, sans-serif`,t.textAlign="center",t.textBaseline="middle";let f=l-i/2<c*1.2,p=l+(f?1:-1)*(i/2+c*.7);t.strokeStyle=
r.paper,t.lineJoin="round",t.lineWidth=c*.35,t.strokeText("You",u,p),t.fillStyle=r.ink,t.fillText("You",u,p),t.globalAlpha=1}function $n(t,e,r,n,o){let{ctx:s,grid:a}=t,
i=Pn(t,e,n,o),u=ke(t,e,r);s.globalAlpha=.11,s.fillStyle=u,s.fillRect(...i),s.globalAlpha=.8,s.strokeStyle=u,s.lineWidth=Math.max(1,a.cell/24),s.strokeRect(...i),
s.globalAlpha=1}function Un(t,e,r,n,o){let{ctx:s,grid:a}=t,i=Math.min(Math.ceil(r),e.moments.length-1),u=e.moments[i];s.lineCap="round",s.lineWidth=Math.min(ks,
Math.max(1,a.cell*_s));for(let l=Math.max(1,Math.floor(r-n)+1);l<=i;l++){let[c,f]=[e.moments[l-1],e.moments[l]],p=Math.max(0,Math.min(1,(r-l)/n));s.globalAlpha=
_n+(Ns-_n)*p;for(let m=0;m<f.alive.length;m++){let y=l===i&&r<i;if(!c.alive[m]||!(u.alive[m]||y))continue;let d=(de(e,m)?-1:1)*Rs,[g,w]=C(c,m),[S,v]=C(f,m);if(g===
S&&w===v)continue;let A=y?o[m].x:v+.5,E=y?o[m].y:S+.5;s.strokeStyle=ke(t,e,m),s.beginPath(),s.moveTo(K(a,w+.5+d),Z(a,g+.5+d)),s.lineTo(K(a,A+d),Z(a,E+d)),s.stroke()}}
s.globalAlpha=1}function zn(t,e,r){let n=Math.min(Math.ceil(r),e.moments.length-1);for(let o=Math.max(1,n-En+1);o<=n;o++){let[s,a]=[e.moments[o-1],e.moments[o]],
i=o>r?Math.max(0,1-2*(o-r)):1-(r-o)/En,u=ct(e,s,a);for(let l of ft(s,a))u.includes(l)||Ps(t,C(a,l),i);for(let l of u)Os(t,C(a,l),i)}t.ctx.globalAlpha=1}function Os({
ctx:t,grid:e,colors:r},[n,o],s){t.globalAlpha=s,Tn(t,K(e,o+.5),Z(e,n+.5),Math.max(8,e.cell*Ts)),t.fillStyle=r.capture,t.fill(),t.strokeStyle=r.ink,t.lineWidth=Math.
max(1,e.cell/36),t.lineJoin="round",t.stroke()}function Ps({ctx:t,grid:e,colors:r},[n,o],s){t.globalAlpha=s,Mn(t,K(e,o+.5),Z(e,n+.5),Math.max(7,e.cell*Cs)),t.strokeStyle=
r.collision,t.lineWidth=Math.max(2,e.cell*.17),t.lineCap="round",t.stroke()}function Wn({ctx:t,grid:e,colors:r},n,o){let s=Math.max(1,e.cell*.07);t.strokeStyle=
t.fillStyle=r.collision,t.lineWidth=Math.max(1,e.cell*.05),t.setLineDash([e.cell*.14,e.cell*.1]);for(let[a,i]of n){if(a<0||i<0||a>=e.rows||i>=e.cols)continue;let u=[
K(e,i)+s,Z(e,a)+s,e.cell-2*s,e.cell-2*s];t.globalAlpha=.2*o,t.fillRect(...u),t.globalAlpha=o,t.strokeRect(...u)}t.setLineDash([]),t.globalAlpha=1}function Fn({ctx:t,
grid:e,colors:r},n,o,s,a){t.globalAlpha=a,je(t,K(e,n),Z(e,o),Math.max(8,e.cell*s*1.02)),t.strokeStyle=r.collision,t.lineWidth=Math.max(1.5,e.cell*.085*Math.sqrt(
s)),t.stroke(),t.globalAlpha=1}var Is=.8,Ls=.92,$s=15,Us=7,rr=9;function Dn(t,e,r,n,o,s){n.forEach((a,i)=>{a.alpha>0&&zs(t,e,r,i,a,o,s)}),t.ctx.globalAlpha=1;for(let a of He(e,r).values())a.length>
rr&&Ws(t,n[a[rr-1]],a.length-rr+1)}function zs(t,e,r,n,o,s,a){let{ctx:i,grid:u,colors:l}=t,c=de(e,n),[f,p]=[u.left+o.x*u.cell,u.top+o.y*u.cell],m=Math.max(4,u.cell*
o.size*(c?Ls:Is)),y=ke(t,e,n),d=!c&&!!r.captured[n-e.nPursuers];if(i.globalAlpha=o.alpha,(c?Sn:je)(i,f,p,m),m>Us*a&&(i.strokeStyle=l.paper,i.lineWidth=Math.max(
2,m*.1),i.stroke()),i.fillStyle=d?l.paper:y,i.fill(),d&&(je(i,f,p,m*.82),i.strokeStyle=y,i.lineWidth=m*.18,i.stroke()),!s||m<$s*a)return;let g=String(c?n:n-e.nPursuers);
i.font=`700 ${Math.round(m*(c?.4:.5)*(g.length>1?.8:1))}px system-ui, sans-serif`,i.textAlign="center",i.textBaseline="middle",i.fillStyle=d?y:l.paper,i.fillText(
g,f,p+m*(c?.17:.03))}function Ws({ctx:t,grid:e,colors:r},n,o){let[s,a]=[e.left+n.x*e.cell,e.top+n.y*e.cell];t.font=`700 ${Math.round(e.cell*.3)}px system-ui, sa\
ns-serif`,t.textAlign="center",t.textBaseline="middle",t.strokeStyle=r.paper,t.lineWidth=e.cell*.1,t.strokeText(`+${o}`,s,a),t.fillStyle=r.ink,t.fillText(`+${o}`,
s,a)}var Fs=.46,Ds=.86,Bs=.66,Bn=.48,Gs=.78,Hs=.58;function Gn(t,e,r,n){let[o,s]=[e.moments[r-1],e.moments[r]];if(!o)return;let{ctx:a,grid:i,colors:u}=t;a.strokeStyle=
u.collision,a.lineWidth=Math.max(1.5,i.cell*.07),a.lineCap="butt",a.globalAlpha=n;for(let l=0;l<s.alive.length;l++)lt(o,s,l)&&js(t,e,C(o,l),ut(o,s,l));a.globalAlpha=
1}function js({ctx:t,grid:e},r,n,o){let[s,a]=[o[1]-n[1],o[0]-n[0]],i=f=>K(e,n[1]+.5+s*f),u=f=>Z(e,n[0]+.5+a*f),l=Xt(r,o)?Gs:Hs;t.setLineDash([e.cell*.09,e.cell*
.06]),t.beginPath(),t.moveTo(i(Bn),u(Bn)),t.lineTo(i(l),u(l)),t.stroke(),t.setLineDash([]);let c=.17*e.cell/Math.hypot(s,a);t.beginPath(),t.moveTo(i(l)-a*c,u(l)+
s*c),t.lineTo(i(l)+a*c,u(l)-s*c),t.stroke()}function Hn(t,e,r,n,o,s){let a=Ee[s];if(!s||!a)return;let{ctx:i,grid:u,colors:l}=t,c=Xt(e,[n[0]+a[0],n[1]+a[1]])?Ds:
Bs,f=Fs*o.size,p=[K(u,o.x+a[1]*f),Z(u,o.y+a[0]*f),K(u,o.x+a[1]*c),Z(u,o.y+a[0]*c)],m=Math.max(1.5,u.cell*.085);i.lineCap=i.lineJoin="round";for(let[y,d]of[[l.paper,
m*2.1],[ke(t,e,r),m]])i.strokeStyle=y,i.lineWidth=d,Cn(i,...p,u.cell*.2),i.stroke()}var Vn={numbers:!0,axes:!1,trail:6,viewers:[],plan:null,selected:null,cursor:null,you:null,fog:!1};function Yn(t,e,r,n,o){let{ctx:s,grid:a,colors:i}=t,u=Math.min(
Math.ceil(r),e.moments.length-1),l=e.moments[u],c=r===u,f=pt(e,r),p=c?1:Math.max(0,1-2*(u-r));s.clearRect(0,0,s.canvas.width,s.canvas.height),kn(t);for(let d of n.
viewers)f[d]?.alpha&&$n(t,e,d,...tr(e,d,r));Rn(t,e),n.axes&&On(t,o),Un(t,e,r,n.trail,f),Wn(t,l.contested??[],p),zn(t,e,r),Gn(t,e,u,p),f.forEach(({x:d,y:g,size:w},S)=>{
let v=dn(l,S)?.4:0,A=er(l,S)?1:v;A&&Fn(t,d,g,w,A*p)});let m=c?l:e.moments[Math.max(0,u-1)];if(Dn(t,e,m,f,n.numbers,o),c&&n.plan)for(let[d,g]of f.entries())g.alpha&&
Hn(t,e,d,C(l,d),g,n.plan[d]??0);n.you!==null&&(n.fog&&In(t,e,...tr(e,n.you,r)),Ln(t,f[n.you],o)),s.lineWidth=Math.max(2,2.5*o),s.strokeStyle=i.focus;let y=n.selected===
null?void 0:f[n.selected];y?.alpha&&jn(t,y.x,y.y,y.size*.96),n.cursor&&(s.setLineDash([a.cell*.12,a.cell*.08]),jn(t,n.cursor[1]+.5,n.cursor[0]+.5,.8),s.setLineDash(
[]))}function jn({ctx:t,grid:e},r,n,o){let s=o*e.cell;t.beginPath(),t.roundRect(e.left+r*e.cell-s/2,e.top+n*e.cell-s/2,s,s,s*.1),t.stroke()}var Kn=(t,e)=>(e+.24)/(t+.24);function Zn(t,e,r,n,o,s){let a=r?28*s:0,i=(l,c)=>(l-a)/(c+2*.12),u=Math.max(1,Math.floor(Math.min(i(n,e),i(o,t))));return{rows:t,cols:e,
cell:u,left:Math.round((n-e*u+a)/2),top:Math.round((o-t*u+a)/2)}}function qn(t,e,r){let n=Math.floor((r-t.top)/t.cell),o=Math.floor((e-t.left)/t.cell);return n>=
0&&n<t.rows&&o>=0&&o<t.cols?[n,o]:null}var Vs={paper:"--board-paper",line:"--board-line",frame:"--board-frame",ink:"--board-ink",muted:"--board-muted",obstacle:"--board-obstacle",pursuer:"--pursuer",
evader:"--evader",capture:"--capture",collision:"--collision",focus:"--focus"};function Jn(t){let e=getComputedStyle(t),r=Object.entries(Vs).map(([n,o])=>[n,e.getPropertyValue(
o).trim()]);return Object.fromEntries(r)}var nr=()=>matchMedia("(prefers-reduced-motion: reduce)").matches,mt=class{canvas;#e=null;#s=0;#o;#r={rows:1,cols:1,left:0,top:0,cell:1};#n=0;#a;#i;constructor(e,r={}){
this.canvas=e,e.classList.add("board"),e.setAttribute("role","img"),this.#o={...Vn,...r},this.#a=new ResizeObserver(()=>this.#c()),this.#a.observe(e),this.#i=new MutationObserver(
()=>this.redraw()),this.#i.observe(document.documentElement,{attributes:!0}),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",this.redraw)}close(){
this.#a.disconnect(),this.#i.disconnect(),matchMedia("(prefers-color-scheme: dark)").removeEventListener("change",this.redraw),cancelAnimationFrame(this.#n)}get look(){
return this.#o}set look(e){this.#o={...this.#o,...e},this.#u(),this.redraw()}show(e,r){this.#e=e,this.#s=Math.min(Math.max(0,r),e.moments.length-1),this.#u(),this.
redraw()}redraw=()=>{this.#n||(this.#n=requestAnimationFrame(()=>this.drawNow()))};drawNow(){cancelAnimationFrame(this.#n),this.#n=0;let e=this.canvas.getContext(
"2d");if(!e||!this.#e)return;let{rows:r,cols:n}=this.#e,o=devicePixelRatio||1;this.#r=Zn(r,n,this.#o.axes,this.canvas.width,this.canvas.height,o);let s={ctx:e,grid:this.#r,
colors:Jn(this.canvas)};Yn(s,this.#e,this.#s,this.#o,o)}cellAt(e,r){let n=this.canvas.getBoundingClientRect(),o=this.canvas.width/n.width;return qn(this.#r,(e-n.
left)*o,(r-n.top)*o)}agentAt(e,r){let n=this.cellAt(e,r);if(!n||!this.#e)return null;let o=this.#e.moments[Math.round(this.#s)],s=He(this.#e,o).get(n[0]*this.#e.
cols+n[1])??[],a=pt(this.#e,Math.round(this.#s)),i=u=>{let[l,c]=this.pointOf(a[u].x,a[u].y);return Math.hypot(l-e,c-r)};return s.length?s.reduce((u,l)=>i(l)<i(u)?
l:u):null}pointOf(e,r){let n=this.canvas.getBoundingClientRect(),o=n.width/this.canvas.width,{left:s,top:a,cell:i}=this.#r;return[n.left+(s+e*i)*o,n.top+(a+r*i)*
o]}#u(){if(!this.#e)return;let{rows:e,cols:r}=this.#e;this.canvas.style.setProperty("--board-aspect",String(Kn(e,r)))}#c(){let e=devicePixelRatio||1,{width:r,height:n}=this.
canvas.getBoundingClientRect();this.canvas.width=Math.max(1,Math.round(r*e)),this.canvas.height=Math.max(1,Math.round(n*e)),this.drawNow()}};var Ve=[.5,1,2,4,8,16,32,64],Xn=0,dt=12,Ys=2,ht=class extends EventTarget{#e;#s;#o;#r=0;#n=0;#a=!1;#i=null;#u=0;#c=[];#m=[];glide=.28;constructor(e,r={}){super(),
this.#e=e,this.#s=r.speed??4,this.#o=r.still??!1}get step(){return this.#r}get time(){return this.#o?this.#r:this.#n}get arrived(){return this.#n===this.#r}get playing(){
return this.#a}get length(){return this.#e}set length(e){this.#e=e,this.#r>e&&this.jump(e),this.#t("state")}get marks(){return this.#c}set marks(e){this.#c=e,this.#t(
"state")}get ticks(){return this.#m}set ticks(e){this.#m=e,this.#t("state")}get pace(){return this.#s||Math.max(Ys,this.#e/dt)}get speed(){return this.#s}set speed(e){
this.#s=e,this.#t("state")}changeSpeed(e){let r=Ve.findIndex(n=>n>=this.pace);this.speed=Ve[Math.min(Ve.length-1,Math.max(0,r+e))]}play(){this.#a||!this.#e||(this.#r===
this.#e&&this.jump(0),this.#a=!0,this.#t("state"),this.#p())}pause(){this.#a&&(this.#a=!1,this.#t("state"))}toggle(){this.#a?this.pause():this.play()}move(e){this.
pause();let r=Math.min(this.#e,Math.max(0,this.#r+e));Math.abs(r-this.#n)>1?this.jump(r):this.#h(r),this.#p()}jump(e){this.#n=Math.min(this.#e,Math.max(0,Math.round(
e))),this.#h(this.#n),this.#t("frame")}#h(e){e!==this.#r&&(this.#r=e,this.#t("step"),this.#o&&this.#t("frame"))}#p(){this.#i===null&&(this.#u=performance.now(),
this.#i=requestAnimationFrame(()=>this.#g()))}#g(){this.#i=null;let e=performance.now();this.#l(Math.min(.25,(e-this.#u)/1e3)),this.#u=e,(!this.#o||this.arrived)&&
this.#t("frame"),(this.#a||this.#n!==this.#r)&&(this.#i=requestAnimationFrame(()=>this.#g()))}#l(e){let r=e;for(;r>0;){if(this.#n===this.#r){if(!this.#a)return;
if(this.#r===this.#e)return this.pause();this.#h(this.#r+1)}let n=this.#a?this.pace:1/this.glide,o=this.#r-this.#n,s=Math.min(Math.abs(o),r*n);r-=s/n,this.#n=s===
Math.abs(o)?this.#r:this.#n+Math.sign(o)*s}this.#a&&this.#n===this.#e&&this.pause()}#t(e){this.dispatchEvent(new Event(e))}};function yt(t,e){if(e.ctrlKey||e.metaKey||
e.altKey)return!1;let r=e.shiftKey?10:1,o={" ":()=>t.toggle(),ArrowRight:()=>t.move(r),ArrowLeft:()=>t.move(-r),Home:()=>t.move(-t.length),End:()=>t.move(t.length),
"+":()=>t.changeSpeed(1),"-":()=>t.changeSpeed(-1)}[e.key];return o?.(),o!==void 0}var Ks={first:"M6 5v14M19 5 9 12l10 7z",back:"M17 5 7 12l10 7z",play:"M7 4.5 19 12 7 19.5z",pause:"M8 5v14M16 5v14",forward:"M7 5l10 7-10 7z",last:"M18 5v14M5 5\
l10 7-10 7z"};function Qn(t){return Vt("svg",{viewBox:"0 0 24 24","aria-hidden":"true",class:"icon"},Vt("path",{d:Ks[t]}))}function Ye(t,e,r,n){return h("button",
{type:"button",class:"player-button","aria-label":e,title:`${e} (${r})`,onclick:n},Qn(t))}function eo(t){let e=Ye("play","Play","Space",()=>t.toggle()),r=Zs(t),
n=h("div",{class:"captures","aria-hidden":"true",title:"Captures"}),o=h("div",{class:"losses","aria-hidden":"true"}),s=qs(t),a=h("output",{class:"player-count"}),
i=h("div",{class:"player",role:"group","aria-label":"Player"},Ye("first","First step","Home",()=>t.move(-t.length)),Ye("back","Step back","←",()=>t.move(-1)),
e,Ye("forward","Step forward","→",()=>t.move(1)),Ye("last","Last step","End",()=>t.move(t.length)),h("div",{class:"scrub"},n,o,r),a,s),u=(f,p={})=>{let m=h("i",
p);return m.style.left=`${100*f/Math.max(1,t.length)}%`,m},l=()=>{n.replaceChildren(...t.marks.map(f=>u(f))),o.replaceChildren(...t.ticks.map(({step:f,kind:p,size:m,
text:y})=>{let d=u(f,{class:p,title:`Step ${f}: ${y}`});return d.style.height=`${100*m}%`,d}))},c=()=>{e.replaceChildren(Qn(t.playing?"pause":"play")),e.ariaLabel=
t.playing?"Pause":"Play",e.title=`${e.ariaLabel} (Space)`,r.max=String(t.length),r.value=String(t.step),r.ariaValueText=`step ${t.step} of ${t.length}`,a.textContent=
`${t.step} / ${t.length}`,a.style.minWidth=`${2*String(t.length).length+3}ch`,s.value=String(t.speed)};return t.addEventListener("step",c),t.addEventListener("s\
tate",c),t.addEventListener("state",l),i.addEventListener("keydown",f=>{!(f.target instanceof HTMLSelectElement||f.key===" "&&f.target!==r)&&yt(t,f)&&f.preventDefault()}),
c(),i}function Zs(t){let e=h("input",{type:"range",class:"player-scrub",min:0,step:1,"aria-label":"Step"});return e.addEventListener("input",()=>{t.pause(),t.jump(
Number(e.value))}),e}function qs(t){let e=`Steps a second, or the whole in ${dt} s (+ and -)`,r=h("select",{class:"player-speed","aria-label":"Speed",title:e},h(
"option",{value:Xn},`in ${dt} s`),...Ve.map(n=>h("option",{value:n},`${n} / s`)));return r.addEventListener("change",()=>{t.speed=Number(r.value)}),r}function to(t,e,r){if(r===0)return[{kind:"start",text:Js(t),agents:[]}];let[n,o]=[e.moments[r-1],e.moments[r]],s=c=>q(c,t.config.n_pursuers),a=ct(e,n,o),i=t.conflicts(
r),u=new Set(i.flatMap(c=>c.doomed)),l=a.map(c=>({kind:"capture",text:`${s(c)} is captured`,agents:[c]}));for(let c of ft(n,o))!a.includes(c)&&!u.has(c)&&l.push(
{kind:"end",text:`${s(c)} disappears`,agents:[c]});return l.push(...i.map(({kind:c,text:f,agents:p})=>({kind:c,text:f,agents:p}))),r===t.length&&l.unshift({kind:"\
end",text:Xs(t),agents:[]}),l}function Js({config:t}){return`${t.n_pursuers} pursuers and ${t.n_evaders} evaders on ${t.rows} x ${t.cols} cells, at most ${t.max_steps}\
 steps`}function Xs(t){let e=Math.round(t.statistics.capture_rate*t.config.n_evaders);return`The episode ends after ${t.length} steps with ${e} of ${t.config.n_evaders}\
 evaders captured`}var or=.005,no=.05,Qs=["pursuer","evader"],ea=4,Re=new Map;function oo(t,e,r="capture-rate"){let n=JSON.stringify([{...e,rewards:null,fov:null},r]),o=Re.get(n)??
(et(e)?Promise.resolve(null):ta(t,e,r));return Re.delete(n),Re.set(n,o),Re.size>ea&&Re.delete([...Re.keys()][0]),o}var so=({n_evaders:t})=>t===1?"capture-time":
"capture-rate",ro=()=>new Promise(t=>setTimeout(t));async function ta(t,e,r){await ro();let n=t.solution(e,r);for(;n.goBack();)await ro();return n}function ao(t,e,r){
let{payoff:n}=t;return r.flatMap((o,s)=>{let a=[0,0];for(let u=e.n_turns;u>0&&!e.over;u--)t.game(e)?.lost(o).forEach((l,c)=>a[c]+=l),e.playTurn(o);let i=n==="ca\
pture-rate"?or:no;return Qs.map((u,l)=>({step:s+1,team:u,lost:a[l],payoff:n})).filter(u=>u.lost>=i)})}var io=t=>t.map(e=>({step:e.step,kind:e.team,size:e.lost/Math.
max(1,...t.map(({lost:r})=>r)),text:sr(e)})),lo=({lost:t,payoff:e})=>e==="capture-rate"?`${t.toFixed(2)} of the capture rate`:`${t.toFixed(1)} steps`,sr=t=>`The\
 ${t.team}s lose ${lo(t)} against a perfect opponent`;function uo(t){let e=t.reduce((r,n)=>n.lost>r.lost?n:r);return`Your team's worst moves, in step ${e.step},\
 lost ${lo(e)} against a perfect opponent.`}function co({config:t,payoff:e},{value:r},n){if(e==="capture-rate")return`value ${r.toFixed(2)}`;let[o,s]=[1-r,Math.
min(t.max_steps-n,kt)];return o>s-no?`free for ${s} steps`:`captured after ${o.toFixed(1)} steps`}function fo(t,e){return(t.marginal(e)??[]).map((n,o)=>({share:n,
action:o})).filter(({share:n})=>n>=or).sort((n,o)=>o.share-n.share).map(({share:n,action:o})=>n>1-or?he[o]:`${he[o]} ${n.toFixed(2)}`).join(", ")}var po=["·","↑","→","↓","←","↗","↘","↙","↖"];var ra={" ":0,s:0,ArrowUp:1,w:1,ArrowRight:2,d:2,ArrowDown:3,x:3,ArrowLeft:4,a:4,e:5,c:6,y:7,z:7,q:8},ar=[8,1,5,4,0,2,7,3,6],na=[7,8,9,4,5,6,1,2,3],oa=24,sa=Math.
tan(Math.PI/8);function ho(t,e){if(t.ctrlKey||t.metaKey||t.altKey)return;let r=na.findIndex(o=>t.code===`Numpad${o}`),n=ar[r]??ra[t.key.length===1?t.key.toLowerCase():
t.key];return n!==void 0&&n>4&&!e?void 0:n}function yo(t){let e=ar.map(r=>h("button",{type:"button","aria-label":he[r],onclick:()=>t(r)},po[r]));return{element:h(
"div",{class:"play-pad",role:"group","aria-label":"Your move"},...e),show:r=>e.forEach((n,o)=>n.classList.toggle("absent",ar[o]>4&&!r))}}function mo(t,e,r){let n=sa*
Math.max(Math.abs(t),Math.abs(e)),o=s=>Math.abs(s)<n?0:s;return hn([0,0],r?[o(t),o(e)]:[t,e],r)}function go(t,e,r){let n=null,{canvas:o}=t;o.addEventListener("p\
ointerdown",({button:s,clientX:a,clientY:i})=>{n=s===0?[a,i]:null}),o.addEventListener("pointercancel",()=>{n=null}),o.addEventListener("pointerup",({clientX:s,
clientY:a})=>{let[i,u]=[n,e()];if(n=null,!i||!u)return;let[l,c]=[s-i[0],a-i[1]],f=t.cellAt(s,a);Math.hypot(l,c)>=oa?r(mo(c,l,u.diagonal)):f&&r(mo(f[0]-u.cell[0],
f[1]-u.cell[1],u.diagonal))})}function vo(t,e){let r=n=>{let o=e[n]-t[n],s=Ee.findIndex(a=>a[n]===Math.sign(o)&&a[1-n]===0);return o?`${Math.abs(o)} ${he[s]}`:""};
return[r(0),r(1)].filter(Boolean).join(", ")||"on your cell"}var aa=[0,1,2,4,8],gt=class{element;player=new ht(0,{speed:4,still:nr()});#e;#s;#o=h("canvas",{tabindex:0,"aria-describedby":"play-keys"});#r=h("h2");#n=h("p",{
class:"play-told",role:"status"});#a=yo(e=>this.act(e));#i=h("select",{},...aa.map(e=>h("option",{value:e},e?`${e} / s`:"step by step")));#u=h("input",{type:"ch\
eckbox"});#c=h("input",{type:"checkbox"});#m=h("span");#h=h("p",{class:"small muted play-keys",id:"play-keys"});#p=h("section",{class:"play-ending",tabindex:-1,
"aria-labelledby":"play-headline"});#g=eo(this.player);#l=null;#t=null;#A=[];#f=null;#d=null;#y=[];#v=0;#b=0;constructor(e){this.#e=e,this.#s=new mt(this.#o,{numbers:!1}),
this.#o.setAttribute("role","application"),this.#i.addEventListener("change",()=>this.#w()),this.#u.addEventListener("change",()=>this.#M()),this.#c.addEventListener(
"change",()=>this.#x()),go(this.#s,()=>{let r=this.#f!==null&&this.#t&&C(this.#t.recording.moments.at(-1),this.#f);return r?{cell:r,diagonal:this.#t.config.diagonal}:
null},r=>this.act(r)),this.player.addEventListener("frame",()=>this.#t&&this.#s.show(this.#t.recording,this.player.time)),this.player.addEventListener("step",()=>this.#x()),
this.element=h("div",{class:"play"},h("header",{class:"play-head"},this.#r,this.#n),h("div",{class:"play-stage"},this.#o),h("div",{class:"play-side"},this.#p,this.#a.
element,h("label",{class:"play-choice",title:"Steps a second"},"Pace ",this.#i),h("label",{class:"play-choice"},this.#u,h("span",{},"Fog",h("span",{class:"at-le\
ngth"},": see only what it sees"))),h("label",{class:"play-choice"},this.#c,this.#m),this.#h),this.#g)}get played(){return this.#l&&{...this.#l.played,moves:this.#A}}get live(){
return this.#t}play(e){this.#S(Kt(this.#e,e.played),e.played.seat,e.title),[this.#l,this.#A,this.#v]=[e,[...e.played.moves],0],this.element.dataset.state="playi\
ng",this.#o.focus({preventScroll:!0}),ot(this.#t,e.played.seat)&&this.#_()}watch(e,r,n){this.#l=null,this.#S(e,r,n),this.#k()}stop(){this.#w(),this.player.pause(),
this.#l=null}act(e){let[r,n]=[this.#l,this.#t];if(!r||!n||this.element.dataset.state!=="playing")return;this.#v=e;let o=Number(this.#i.value);this.#b||(this.#E(),
o&&this.element.dataset.state==="playing"&&(this.#b=setInterval(()=>this.#E(),1e3/o)))}key(e){let{target:r,key:n}=e;if(r instanceof HTMLSelectElement||r instanceof
HTMLInputElement&&(r.type==="text"||n===" ")||r instanceof HTMLButtonElement&&(n===" "||n==="Enter")||!this.#t)return!1;if(this.element.dataset.state!=="playing")
return yt(this.player,e);let s=ho(e,this.#t.config.diagonal);return s!==void 0&&this.act(s),s!==void 0}#S(e,r,n){this.#w(),this.player.pause(),[this.#t,this.#f]=
[e,r],this.#r.textContent=n,this.#o.ariaLabel=`Board, ${e.config.rows} by ${e.config.cols} cells`,this.#a.show(e.config.diagonal),this.#h.replaceChildren(h("spa\
n",{class:"at-length"},`Arrow keys or W A X D move, Space or S stays${e.config.diagonal?"; Q E Z C and the numeric keypad move diagonally":""}. `),"On the board\
: swipe, or tap where to go."),this.#R(e),this.#p.replaceChildren(),this.player.length=e.length,this.player.jump(e.length),this.#x()}#M(){this.#s.look={you:this.#f,
fog:this.#u.checked,viewers:this.#f===null?[]:[this.#f],plan:this.#N()}}#R(e){this.#d=null,this.#y=this.player.ticks=[];let r=et(e.config);this.#c.hidden=this.#c.
disabled=!!r,this.#m.className=r?"small muted":"",this.#m.textContent=r?`No best move: ${r}`:"Best move",oo(this.#e,e.config,so(e.config)).then(n=>{this.#t===e&&
(this.#d=n,this.#T(),this.#x())})}#T(){let[e,r]=[this.#t,this.#d];if(!r||this.element.dataset.state==="playing")return;let n=this.#e.world(e.config);n.reset(e.start),
this.#y=ao(r,n,e.actions),n.free(),this.player.ticks=io(this.#y)}get#C(){return this.#c.checked&&this.#l&&this.element.dataset.state==="playing"&&this.#d&&this.#t.
game(this.#d)||null}#N(){let[e,r]=[this.#f,this.#f!==null&&this.#C?.marginal(this.#f)];return e!==null&&r?Object.assign(Array(e).fill(0),{[e]:r.indexOf(Math.max(
...r))}):null}#w(){clearInterval(this.#b),this.#b=0,this.#n.ariaLive=Number(this.#i.value)?"off":"polite"}#E(){let[{policies:e,seat:r},n]=[this.#l.played,this.#t];
n.step(e,r,this.#v),this.#A.push(this.#v),this.player.length=n.length,this.player.glide=Math.min(.22,.9/(Number(this.#i.value)||4)),this.player.move(n.length-this.
player.step),ot(n,r)&&this.#_()}#_(){this.#w();let[e,r,n]=[this.#l,this.#t,this.played],o=en()?e.link(n):null;this.#p.replaceChildren(h("h3",{id:"play-headline"},
ua(r,n.seat)),...e.ending(r,n),h("div",{class:"play-buttons"},h("button",{type:"button",class:"primary",onclick:()=>e.again()},"Again"),h("button",{type:"button",
onclick:()=>this.#k()},"Watch it"),h("button",{type:"button",onclick:()=>this.#O(r,n.seat)},"Save"),o&&h("button",{type:"button",onclick:({currentTarget:a})=>fa(
a,o)},"Link"))),this.element.dataset.state="ended",this.#T();let s=this.#y.filter(({team:a})=>a===fe(r.config,n.seat));s.length&&this.#p.children[0].after(h("p",
{class:"small muted"},uo(s))),this.#p.focus({preventScroll:!0}),this.#p.scrollIntoView({block:"nearest"})}#k(){this.element.dataset.state="watched",this.player.
length=this.#t.length,this.player.jump(0),nr()||this.player.play()}#O(e,r){let n=new Blob([pn(this.#e,e,r)],{type:"application/octet-stream"});h("a",{href:URL.createObjectURL(
n),download:`${q(r,e.config.n_pursuers)}-${e.length}-steps.npz`}).click()}#x(){let[e,r,{step:n}]=[this.#t,this.#f,this.player];if(!e||n>e.length)return;let o=to(
e,e.recording,n).filter(({agents:i})=>r===null||i.includes(r)),s=[`Step ${n} of ${e.config.max_steps}`,...o.map(({text:i})=>i)];this.#l&&n===0?s.push(this.#l.about??
"",ia(e.config,r)):r!==null&&s.push(la(e,n,r)),s.push(...this.#y.filter(i=>i.step===n).map(sr));let a=n===e.length&&r!==null?this.#C:null;a&&s.push(`Perfect pla\
y: ${fo(a,r)||"decided in its turn"}; ${co(this.#d,a,n)}`),this.#M(),this.#n.textContent=s.filter(Boolean).map(i=>`${i}.`).join(" ")}};function ia(t,e){let r=t.
rules.capture==="SURROUND";return fe(t,e)==="evader"?`Stay free: ${r?"pursuers on all sides of you capture":"a pursuer on your cell captures"} you`:`Capture eva\
ders: ${r?"surround them together":"reach their cell"}`}function la({config:t,recording:e},r,n){let o=e.moments[r],a=fe(t,n)==="pursuer"?"evader":"pursuer";if(!o.
alive[n])return"";let i=C(o,n),u=f=>{let[p,m]=C(o,f);return Math.max(Math.abs(p-i[0]),Math.abs(m-i[1]))},l=Array.from({length:o.alive.length},(f,p)=>p).filter(f=>fe(
t,f)===a&&o.alive[f]&&!o.captured[f-t.n_pursuers]&&2*u(f)<t.fov);if(!l.length)return`No ${a} in view`;let c=l.reduce((f,p)=>u(p)<u(f)?p:f);return`Nearest ${a}: ${vo(
i,C(o,c))}`}function ua(t,e){let[{lasted:r,out:n,captured:o},{config:s}]=[pe(t,e),t];return fe(s,e)==="pursuer"?`Your team captured ${o} of ${ca(s)} in ${r} ste\
ps.`:n?`You lasted ${r} of ${s.max_steps} steps.`:`You escaped: ${r} steps.`}var ca=({n_evaders:t})=>`${t} evader${t===1?"":"s"}`;function fa(t,e){let r=h("inpu\
t",{type:"text",readonly:!0,value:e,"aria-label":"Link to this match"});t.replaceWith(r),r.select(),navigator.clipboard?.writeText(e).catch(()=>{})}var re=JSON.parse(jt("data")),ne={pursuer:bo("pursuer"),evader:bo("evader")};function bo(t){let{names:e,texts:r,scripts:n,network:o}=re.teams[t],s=a=>{let i=n[a];
if(i||!o)return i;let[u,l]=[o.genome_size,n.slice(0,a).filter(c=>c===null).length];return{...o,genome:Xr(t,u).subarray(l*u,(l+1)*u)}};return e.map((a,i)=>({name:a,
text:r[i],policy:()=>s(i)}))}function Ao(t,e,r,n){let[o,s]=[re.world,Te[+(n.seat>=re.world.n_pursuers)]],a=Te.map(l=>ne[l][r[l]].name),i={pursuer:ne.pursuer[r.pursuer].
policy(),evader:ne.evader[r.evader].policy()},u=`You are ${q(n.seat,o.n_pursuers)}: pursuers ${a[0]}, evaders ${a[1]}`;Zt(t,e,u,{config:o,seed:r.seed,episode:0,
policies:i,...n},ne[s],{pursuers:r.pursuer,evaders:r.evader,seed:r.seed})}function wo(t,e){let r=new URLSearchParams(location.hash.slice(1)),n=an(r,re.world),[o,
s]=[Number(r.get("pursuers")??NaN),Number(r.get("evaders")??NaN)],a=/^\d{1,20}$/.test(r.get("seed")??"")?BigInt.asUintN(64,BigInt(r.get("seed"))):null;return!n||
a===null||!ne.pursuer[o]||!ne.evader[s]?!1:(Ao(t,e,{pursuer:o,evader:s,seed:a},n),!0)}var xo=(t,e)=>h("select",{},...t.map((r,n)=>h("option",{value:n,selected:n===
e},r)));function pa(t,e){let[r,n,o]=[xo(["an evader","a pursuer"],0),...Te.map(c=>xo(re.teams[c].names,re.teams[c].usual))],s=h("p",{class:"small muted about"}),
a=()=>{let c=[ne.pursuer[Number(n.value)],ne.evader[Number(o.value)]];s.textContent=c.filter(f=>f.text).map(f=>`${f.name}: ${f.text}.`).join(" ")};for(let c of[
n,o])c.addEventListener("change",a);a();let i=h("p",{class:"problem",role:"alert"}),u=()=>Ao(t,e,{pursuer:Number(n.value),evader:Number(o.value),seed:at()},{seat:r.
value==="0"?re.world.n_pursuers:0,from:0,moves:[]}),l=h("input",{type:"file",accept:".npz",hidden:!0});return l.addEventListener("change",()=>{let[c]=l.files??[];
i.textContent="",c?.arrayBuffer().then(f=>mn(t,new Uint8Array(f))).then(({live:f,seat:p})=>e.watch(f,p,c.name)).catch(f=>i.textContent=`${c.name} holds no match\
: ${f.message}`),l.value=""}),h("details",{class:"card setup",open:matchMedia("(min-width: 761px)").matches},h("summary",{},"Play something else"),h("div",{},h(
"label",{},"You are ",r),h("label",{},"Pursuers ",n),h("label",{},"Evaders ",o),h("button",{type:"button",class:"primary",onclick:u},"Play"),h("button",{type:"b\
utton",onclick:()=>it(e,re.world,ne.pursuer)},"Can you escape it?"),h("button",{type:"button",onclick:()=>l.click()},"Open a file"),l,i,s))}async function ma(){
let t=await Pr(),e=new gt(t);document.getElementById("page").replaceWith(h("header",{class:"top"},h("h1",{},re.title),tn()),h("main",{},pa(t,e),h("section",{class:"\
card","aria-label":"Match"},e.element))),document.addEventListener("keydown",r=>e.key(r)&&r.preventDefault()),window.addEventListener("hashchange",()=>wo(t,e)),
wo(t,e)||it(e,re.world,ne.pursuer),Object.assign(window,{matrixworldPlay:e})}ma().catch(t=>{throw(document.getElementById("page")??document.body).append(h("p",{
class:"card problem",role:"alert"},`The page could not start: ${t instanceof Y?t.message:String(t)}`)),t}).finally(()=>{document.body.dataset.ready="true"});})();
