/* built from web/ by "npm run build"; sources b162a9b667c09198dcfe1b3e178c17156e0e3e0180bb21b8e509913ec36ce266 */
"use strict";(()=>{var $r={SIMULTANEOUS:0,SWARM_TURNS:1,AGENT_TURNS:2},Re={DISAPPEAR:0,REACH:1,BOUNCE:2},_r={OCCUPATION:0,SURROUND:1},Lr={FAULT:0,INVOLVED:1};var Nr=["obstacle","teammate","adversary"],Ft=["vertex","edge","chain"],Ir=["turn","kind","form","first","second","row","col","at_fault","held","doomed"],zt=["p\
ursuer_{number}","evader_{number}"],Fr={obstacle:"{first} ran into the obstacle or border at {cell}",vertex:"{first} and {second} both headed for {cell}",edge:"\
{first} and {second} meant to swap, {first} to {cell}",chain:"{first} headed for {cell}, where {second} had to stay"},Pe={"both held":"both bounce","both doomed":"\
both disappear",held:"{agent} bounces",doomed:"{agent} disappears",none:"nobody is stopped"},zr="{event}: {outcome}",Dt={random:"any action, all equally likely",
still:"always stays",chaser:"moves to where the nearest adversary in view is nearest",fleer:"moves to where the nearest adversary in view is farthest","clumsy-c\
haser":"a chaser that takes any action in half of the steps",hunter:"a chaser of the nearest adversary in view to which no teammate in view is nearer",surrounder:"\
a chaser of the nearest free cell beside an adversary without a teammate","clumsy-fleer":"a fleer that takes any action in half of the steps",dodger:"moves to w\
here all adversaries in view together are farthest"},Dr={free:".GS",blocked:"#@OTW"};var me=1+Ir.length;function $e(e,t){return e.replace(/\{(\w+)\}/g,(r,n)=>String(t[n]))}function D(e,t){return e<t?$e(zt[0],{number:e}):$e(zt[1],{number:e-t})}function Rs(e,t){
let[r,n,o,s,a,i,l,...u]=Array.from(e),d=a<0?[s]:[s,a],[m,p,h]=u.map(A=>d.filter((y,x)=>A>>x&1)),v=d.map(A=>D(A,t)),f=$e(Fr[a<0?"obstacle":Ft[o]],{first:v[0],second:v[v.
length-1],cell:`(${i}, ${l})`}),b=$e(zr,{event:f,outcome:Ps(d.length,p,h,t)});return{kind:Nr[n],form:Ft[o],agents:d,cell:[i,l],at_fault:m,held:p,doomed:h,turn:r,
text:b}}function Ps(e,t,r,n){if(e===2&&t.length===2)return Pe["both held"];if(e===2&&r.length===2)return Pe["both doomed"];let o=s=>a=>$e(Pe[s],{agent:D(a,n)});
return[...t.map(o("held")),...r.map(o("doomed"))].join(", ")||Pe.none}function Ze(e,t){let r=[];for(let n=0;n<e.length;n+=me)r.push(Rs(e.subarray(n+1,n+me),t));
return r}var ee=class extends Error{name="EngineError"};function E(e,t,r){let n=typeof r=="string"?`'${r}'`:typeof r=="object"?JSON.stringify(r):String(r);return new ee(
`${e}: expected ${t}, got ${n}`)}var pe=class{bytes;constructor(t){this.bytes=t}},Wr=0,Ht=[Uint8Array,Uint8Array,Int32Array,BigInt64Array,BigUint64Array,Float32Array,Float64Array],Ur=4,Hr=4,$s=new TextEncoder,
_s=new TextDecoder;function Ls(e){for(let t=Ht.length-1;t>Wr;--t)if(e instanceof Ht[t])return t;throw new TypeError("array: expected a typed array of the engine\
's numbers, got another")}function Ut(e){return new Uint8Array(e.buffer,e.byteOffset,e.byteLength)}function Ns(e){return $s.encode(`${e}\0`)}var Wt=class{engine;addresses=[];constructor(t){
this.engine=t}copy(t){let r=this.engine._malloc(Math.max(t.length,1));if(r===0)throw new ee("memory: expected room for the arguments, got none");return this.addresses.
push(r),this.engine.HEAPU8.set(t,r),r}text(t){return this.copy(Ns(t))}arrays(t){let r=Object.entries(t),n=r.flatMap(([s,a])=>{let i=a instanceof pe,l=i?a.bytes:
a;return[this.text(s),i?Wr:Ls(l),l.length,this.copy(Ut(l))]}),o=this.copy(Ut(Int32Array.from(n)));return this.copy(Ut(Int32Array.of(r.length,o)))}free(){for(let t of this.
addresses)this.engine._free(t)}};function Br(e,t){let r=e.HEAPU8;return _s.decode(r.subarray(t,r.indexOf(0,t)))}function he(e){let t=new Int32Array(e.HEAPU8.buffer),
r=e._last_outputs()/Ur,n=t[r+1]/Ur,o={};for(let s=n;s<n+t[r]*Hr;s+=Hr){let a=Ht[t[s+1]],i=t[s+2]*a.BYTES_PER_ELEMENT,l=t[s+3];o[Br(e,t[s])]=new a(e.HEAPU8.slice(
l,l+i).buffer)}return o}function q(e,t){let r=new Wt(e);try{let n=t(r);if(n===0)throw new ee(Br(e,e._last_error()));return n}finally{r.free()}}var Is=2**31-1,Gr=["none","elman","gru"],Fs=2n**64n-1n,zs=34028234663852886e22;function H(e,t){if(typeof t!="number"||!Number.isInteger(t)||Math.abs(t)>Is)throw E(
e,"an integer",t);return Int32Array.of(t)}function Je(e,t){if(typeof t!="boolean")throw E(e,"true or false",t);return new pe(Uint8Array.of(Number(t)))}function te(e,t,r){
let n=typeof t=="string"&&Object.hasOwn(r,t)?r[t]:void 0;if(n===void 0)throw E(e,`one of ${Object.keys(r).join(", ")}`,t);return Int32Array.of(n)}function Bt(e,t){
if(typeof t!="number"||!(Math.abs(t)<=zs))throw E(e,"a finite number",t);return t}function fe(e,t){let n=typeof t=="bigint"||typeof t=="number"&&Number.isSafeInteger(
t)?BigInt(t):-1n;if(n<0n||n>Fs)throw E(e,"an integer from 0 to 2^64 - 1",t);return BigUint64Array.of(n)}function Ds(e){return{"rules.interaction":te("interactio\
n",e.interaction,$r),"rules.obstacle":te("obstacle",e.obstacle,Re),"rules.teammate":te("teammate",e.teammate,Re),"rules.evader":te("evader",e.evader,Re),"rules.\
pursuer":te("pursuer",e.pursuer,Re),"rules.capture":te("capture",e.capture,_r),"rules.captured_disappear":Je("captured_disappear",e.captured_disappear)}}function jr(e,t){
let r=typeof t=="number"?[t,t,t]:t;if(!Array.isArray(r)||r.length!==3)throw E(e,"1 or 3 numbers",t);return Float32Array.from(r,n=>Bt(e,n))}function Us(e){let t=(r,n)=>Float32Array.
of(Bt(r,e[r]),Bt(n,e[n]));return{"rewards.capture":t("pursuer_capture","evader_capture"),"rewards.neighbor":t("pursuer_neighbor","evader_neighbor"),"rewards.ste\
p":t("pursuer_step","evader_step"),"rewards.pursuer_collide":jr("pursuer_collide",e.pursuer_collide),"rewards.evader_collide":jr("evader_collide",e.evader_collide),
"rewards.blame":te("blame",e.blame,Lr),"rewards.capture_repeats":Je("capture_repeats",e.capture_repeats)}}function qr(e){if(e===void 0||typeof e=="number")return new Uint8Array(
0);if(e instanceof Uint8Array)return e;let{free:t,blocked:r}=Dr;for(let[n,o]of e.entries()){if(o.length!==e[0]?.length)throw E(`map, row ${n}`,`${e[0]?.length} \
cells as in row 0`,o.length);let s=[...o].find(a=>!t.includes(a)&&!r.includes(a));if(s)throw E(`map, row ${n}`,`'${t}' (free) or '${r}' (obstacle)`,s)}return Uint8Array.
from([...e.join("")],n=>Number(r.includes(n)))}function Kr(e,t){if(!Array.isArray(e))return;let r=[e.length,e[0]?.length??0];if(!(r[0]===t.rows&&r[1]===t.cols))
throw E("obstacle map",`shape (${t.rows}, ${t.cols}), the rows and cols`,r)}function ge(e){Kr(e.obstacles,e);let t=typeof e.obstacles=="number"?e.obstacles:0;return{
...Ds(e.rules),...Us(e.rewards),rows:H("rows",e.rows),cols:H("cols",e.cols),n_pursuers:H("n_pursuers",e.n_pursuers),n_evaders:H("n_evaders",e.n_evaders),fov:H("\
fov",e.fov),diagonal:Je("diagonal",e.diagonal),max_steps:H("max_steps",e.max_steps),density:Float64Array.of(t),map:qr(e.obstacles)}}function Vr(e,t){return Int32Array.
from((t??[]).flat(),r=>H(e,r)[0])}function Yr(e,t){return Kr(e.obstacles,t),{seed:fe("seed",e.seed??0n),episode:fe("episode",e.episode??0),pursuers:Vr("pursuers",
e.pursuers),evaders:Vr("evaders",e.evaders),map:qr(e.obstacles)}}function Xe(e){return{actions:Int32Array.from(e,t=>H("actions",t)[0])}}function ye(e){if(typeof e==
"string"){if(!Object.hasOwn(Dt,e))throw E("policy",`one of ${Object.keys(Dt).join(", ")}`,e);return{script:new TextEncoder().encode(e)}}if(e.activation!=="relu"&&
e.activation!=="tanh")throw E("activation","'relu' or 'tanh'",e.activation);if(!Gr.includes(e.memory))throw E("memory",`one of ${Gr.join(", ")}`,e.memory);return{
hidden:Int32Array.from(e.hidden,t=>H("hidden",t)[0]),activation:new TextEncoder().encode(e.activation),sampled:Je("sampled",e.sampled),memory:new TextEncoder().
encode(e.memory),genome:e.genome}}var Hs=["first_turn","terminated","truncated"];function Zr(e){let t={...e};for(let r of Hs)t[r]=new pe(e[r]);return t}var Qe=class{config;seed;episode;n_agents;statistics;first_conflict;constructor(t,r,n,o){this.config=t,this.seed=r,this.episode=n,this.n_agents=t.n_pursuers+t.n_evaders,
this.statistics=Jr(o,0),Object.assign(this,o),this.first_conflict=Ws(this.conflict_table,this.length)}get length(){return this.actions.length/this.n_agents}conflicts(t){
this.check(t);let[r,n]=[this.first_conflict[t],this.first_conflict[t+1]],o=this.conflict_table.subarray(r*me,n*me);return Ze(o,this.config.n_pursuers)}seek(t,r,n){
this.check(r),(!(t.seed===this.seed&&t.episode===BigInt(this.episode))||t.turn!==0||t.steps>r)&&t.reset({seed:this.seed,episode:this.episode});for(let s=t.steps;s<
r;++s){let a=this.actions.subarray(s*this.n_agents,(s+1)*this.n_agents);n?t.replay(a,{pursuer:n.pursuers,evader:n.evaders}):t.step(a)}}check(t){if(!(Number.isInteger(
t)&&t>=0&&t<=this.length))throw E("step",`0 to ${this.length}`,t)}};function Ws(e,t){let r=new Int32Array(t+2);for(let n=0;n<e.length;n+=me)++r[e[n]+1];for(let n=1;n<
r.length;++n)r[n]+=r[n-1];return r}function Jr(e,t){let r=e["statistics.length"].length,n=s=>{let a=e[`statistics.${s}`],i=a.length/r;return a.slice(t*i,(t+1)*i)},
o=s=>Number(n(s)[0]);return{capture_rate:o("capture_rate"),ever_capture_rate:o("ever_capture_rate"),captured_fraction:o("captured_fraction"),length:o("length"),
return:n("return"),survivors:n("survivors"),overlap:n("overlap"),collisions:n("collisions"),faults:n("faults"),agent_steps:n("agent_steps")}}function Xr(e,t,r,n){
let o=[ge(r.config),ye(r.pursuers),ye(r.evaders),n];return q(e,s=>{let[a,i,l,u]=o.map(d=>s.arrays(d));return e[t](a,i,l,u)}),he(e)}function Qr(e,t,r,n){let o={seed:fe(
"seed",r),episode:fe("episode",n)};return new Qe(t.config,r,n,Xr(e,"_play_match",t,o))}function en(e,t,r,n){if(!Number.isInteger(n)||n<1)throw E("n_episodes","a\
t least 1",n);let o={seed:fe("seed",r),n_episodes:Int32Array.of(n)},s=Xr(e,"_play_rollout",t,o);return Array.from({length:n},(a,i)=>Jr(s,i))}var Bs=7e6,Gs=new FinalizationRegistry(([e,t])=>e._states_free(t));function js({rules:e,rows:t,cols:r,obstacles:n,diagonal:o,n_pursuers:s,n_evaders:a}){let i=typeof n==
"number"||e.obstacle==="REACH"?0:n.join("").split("#").length-1,l=t*r-i,u=[e.obstacle,e.teammate,e.pursuer].includes("DISAPPEAR"),d=e.capture==="SURROUND"||e.evader===
"REACH",m=e.interaction==="AGENT_TURNS",p=(f,b)=>Array.from({length:b},(A,y)=>m?f:(f+y)/(y+1)).reduce((A,y)=>A*y,1),h=p(l+Number(u),s)*p(l*(1+Number(d))+2,a);return{
SIMULTANEOUS:[s+a],SWARM_TURNS:[s,a],AGENT_TURNS:Array(s+a).fill(1)}[e.interaction].reduce((f,b)=>f+h*(o?9:5)**b,0)}function et(e){return typeof e.obstacles=="n\
umber"&&e.obstacles>0?"obstacles are drawn anew in each episode":js(e)>Bs?"the world is too large to be solved on the page":""}var Gt=class{value;teams;matrix;n_actions;constructor(t,r){
let{matrix:n,rows:o,cols:s,value:a,agents:i}=r,[l,u]=t.actors,d=Array.from(i).filter(p=>l<=p&&p<u),m=p=>p<t.config.n_pursuers;[this.value,this.matrix,this.n_actions]=
[a[0],n,t.n_actions],this.teams=[{agents:d.filter(m),play:o},{agents:d.filter(p=>!m(p)),play:s}]}marginal(t){let r=this.teams.find(({agents:s})=>s.includes(t));
if(!r)return null;let n=this.n_actions**(r.agents.length-1-r.agents.indexOf(t)),o=Array(this.n_actions).fill(0);return r.play.forEach((s,a)=>o[Math.floor(a/n)%this.
n_actions]+=s),o}lost(t){let[r,n]=this.teams.map(({agents:l})=>l.reduce((u,d)=>u*this.n_actions+t[d],0)),[o,s]=this.teams.map(({play:l})=>l),a=s.reduce((l,u,d)=>l+
u*this.matrix[r*s.length+d],0),i=o.reduce((l,u,d)=>l+u*this.matrix[d*s.length+n],0);return[Math.max(0,this.value-a),Math.max(0,i-this.value)]}},tn=60,_e=class{config;payoff;engine;states;n_turns;values;constructor(t,r,n){
[this.engine,this.config,this.payoff]=[t,r,n],this.states=q(t,a=>t._states_new(a.arrays(ge(r)))),Gs.register(this,[t,this.states]);let o={SIMULTANEOUS:1,SWARM_TURNS:2,
AGENT_TURNS:r.n_pursuers+r.n_evaders};this.n_turns=o[r.rules.interaction];let s=this.call(()=>t._states_payoffs(this.states)).payoffs;this.values=[[n==="capture\
-rate"?s:s.fill(0)]]}goBack(){let t=this.values.at(-1)[0],r=[];for(let o=this.n_turns-1;o>=0;o--){let s=r[o+1]??t;r[o]=this.call(a=>this.engine._states_backup(this.
states,o,a.arrays({next:s}))).values}this.payoff==="capture-time"&&(r[0]=r[0].map((o,s)=>s===this.config.n_evaders?0:o-1)),this.values.push(r);let n=this.payoff===
"capture-rate"?this.config.max_steps:Math.min(this.config.max_steps,tn);return this.values.length<=n&&r[0].some((o,s)=>o!==t[s])}game(t){let[r,{turn:n}]=[this.config.
max_steps-t.steps,t],o=n+1===this.n_turns,s=r>0?this.values[Math.min(r-Number(o),this.values.length-1)]?.[o?0:n+1]:void 0;if(!s)return null;let a=this.call(i=>this.
engine._states_game(this.states,t.address,i.arrays({next:s})));return a.agents.length?new Gt(t,a):null}call(t){return q(this.engine,t),he(this.engine)}};var rn=new FinalizationRegistry(([e,t])=>e._world_free(t)),Le=class{config;n_agents;n_actions;engine;at;freed=!1;constructor(t,r){this.engine=t,this.config=r,this.
n_agents=r.n_pursuers+r.n_evaders,this.n_actions=r.diagonal?9:5,this.at=q(t,n=>t._world_new(n.arrays(ge(r)))),rn.register(this,[t,this.at],this)}free(){this.freed||
(this.freed=!0,rn.unregister(this),this.engine._world_free(this.at))}get address(){if(this.freed)throw E("world","one that is in use","one that was freed");return this.
at}reset(t={}){let r=Yr(t,this.config);this.call(n=>this.engine._world_reset(this.address,n.arrays(r)))}step(t){let r=Xe(t);this.call(n=>this.engine._world_step(
this.address,n.arrays(r)))}playTurn(t){let r=Xe(t);this.call(n=>this.engine._world_play_turn(this.address,n.arrays(r)))}decide(t,r,n){let{n_pursuers:o}=this.config,
s={pursuer:[0,o],evader:[o,this.n_agents]},[a,i]=typeof r=="string"?s[r]:r;if(n.length!==this.n_agents)throw E("actions",String(this.n_agents),n.length);let l=[
ye(t),Xe(n)],{actions:u}=this.call(d=>this.engine._world_decide(this.address,d.arrays(l[0]),a,i,d.arrays(l[1])));return Uint8Array.from(u)}replay(t,r){let n=s=>typeof s!=
"string"&&s.memory!=="none";if(!n(r.pursuer)&&!n(r.evader))return this.step(t);let{n_pursuers:o}=this.config;for(let s=this.n_turns;s>0;--s){let[a,i]=this.actors;
a<o&&this.decide(r.pursuer,[a,Math.min(i,o)],t),i>o&&this.decide(r.evader,[Math.max(a,o),i],t),this.playTurn(t)}}get n_turns(){return this.turnNumbers()[1]}get turn(){
return this.turnNumbers()[0]}get actors(){let[,,t,r]=this.turnNumbers();return[t,r]}turnNumbers(){return this.call(()=>this.engine._world_turn(this.address)).turn}get steps(){
return this.read("steps")[0]}get seed(){return this.read("seed")[0]}get episode(){return this.read("episode")[0]}get over(){return this.read("terminated")[0]===
1||this.read("truncated")[0]===1}read(t){return this.call(r=>this.engine._world_read(this.address,r.text(t)))[t]}view(t){let r=3*this.config.fov**2;return this.
read("views").slice(t*r,(t+1)*r)}map(){return this.read("state").slice(2*this.config.rows*this.config.cols)}conflicts(){return Ze(this.conflictTable(),this.config.
n_pursuers)}conflictTable(){return this.call(()=>this.engine._world_conflicts(this.address)).conflict_table}answer(t,r){let n=ye(t),{logits:o,memory:s}=this.call(
l=>this.engine._world_logits(this.address,l.arrays(n),r)),a=o,i=this.decide(t,[r,r+1],new Uint8Array(this.n_agents))[r];return{logits:a,probabilities:Vs(a),action:i,
memory:s}}snapshot(){return this.call(()=>this.engine._world_snapshot(this.address))}restore(t){let r=Zr(t);this.call(n=>this.engine._world_restore(this.address,
n.arrays(r)))}call(t){return q(this.engine,t),he(this.engine)}};function Vs(e){let t=Math.max(...e),r=Array.from(e,o=>Math.exp(o-t)),n=r.reduce((o,s)=>o+s,0);return Float32Array.
from(r,o=>o/n)}var jt=class{compiled;constructor(t){this.compiled=t}world(t){return new Le(this.compiled,t)}solution(t,r="capture-rate"){return new _e(this.compiled,t,r)}match(t,r,n,o,s=0){
return Qr(this.compiled,{config:t,pursuers:r,evaders:n},o,s)}rollout(t,r,n,o,s){return en(this.compiled,{config:t,pursuers:r,evaders:n},o,s)}},nn;function on(e=globalThis.
matrixworldEngine){return nn??=qs(e),nn}async function qs(e){if(!e)throw new Error("matrixworldEngine: expected the script engine.js before this one, got none");
let t=Uint8Array.from(atob(e.binary),r=>r.charCodeAt(0));return new jt(await e({wasmBinary:t}))}var Ks="http://www.w3.org/2000/svg";function c(e,t={},...r){return sn(document.createElement(e),t,r)}function g(e,t={},...r){return sn(document.createElementNS(
Ks,e),t,r)}function sn(e,t,r){for(let[n,o]of Object.entries(t))o==null||o===!1||(typeof o=="function"?e.addEventListener(n.slice(2),o):e.setAttribute(n,o===!0?"":
String(o)));return e.append(...r.filter(Ys).map(n=>typeof n=="number"?String(n):n)),e}function Ys(e){return e!=null&&e!==!1}var Zs=matchMedia("(prefers-color-scheme: dark)");function Js(){let e=document.documentElement.dataset.theme;return e?e==="dark":Zs.matches}function Xs(){document.
documentElement.dataset.theme=Js()?"light":"dark"}function an(){return c("button",{type:"button",title:"Light or dark (D)","aria-label":"Light or dark",onclick:Xs},
"◐")}var R=Uint8Array,ve=Uint16Array,Qs=Int32Array,ln=new R([0,0,0,0,0,0,0,0,1,1,1,1,2,2,2,2,3,3,3,3,4,4,4,4,5,5,5,5,0,0,0,0]),cn=new R([0,0,0,0,1,1,2,2,3,3,4,4,5,5,
6,6,7,7,8,8,9,9,10,10,11,11,12,12,13,13,0,0]),ea=new R([16,17,18,0,8,7,9,6,10,5,11,4,12,3,13,2,14,1,15]),un=function(e,t){for(var r=new ve(31),n=0;n<31;++n)r[n]=
t+=1<<e[n-1];for(var o=new Qs(r[30]),n=1;n<30;++n)for(var s=r[n];s<r[n+1];++s)o[s]=s-r[n]<<5|n;return{b:r,r:o}},dn=un(ln,2),mn=dn.b,ta=dn.r;mn[28]=258,ta[258]=28;
var pn=un(cn,0),ra=pn.b,Fl=pn.r,Kt=new ve(32768);for(w=0;w<32768;++w)W=(w&43690)>>1|(w&21845)<<1,W=(W&52428)>>2|(W&13107)<<2,W=(W&61680)>>4|(W&3855)<<4,Kt[w]=((W&
65280)>>8|(W&255)<<8)>>1;var W,w,Ne=(function(e,t,r){for(var n=e.length,o=0,s=new ve(t);o<n;++o)e[o]&&++s[e[o]-1];var a=new ve(t);for(o=1;o<t;++o)a[o]=a[o-1]+s[o-
1]<<1;var i;if(r){i=new ve(1<<t);var l=15-t;for(o=0;o<n;++o)if(e[o])for(var u=o<<4|e[o],d=t-e[o],m=a[e[o]-1]++<<d,p=m|(1<<d)-1;m<=p;++m)i[Kt[m]>>l]=u}else for(i=
new ve(n),o=0;o<n;++o)e[o]&&(i[o]=Kt[a[e[o]-1]++]>>15-e[o]);return i}),Ie=new R(288);for(w=0;w<144;++w)Ie[w]=8;var w;for(w=144;w<256;++w)Ie[w]=9;var w;for(w=256;w<
280;++w)Ie[w]=7;var w;for(w=280;w<288;++w)Ie[w]=8;var w,hn=new R(32);for(w=0;w<32;++w)hn[w]=5;var w;var na=Ne(Ie,9,1);var oa=Ne(hn,5,1),Vt=function(e){for(var t=e[0],r=1;r<e.length;++r)e[r]>t&&(t=e[r]);return t},L=function(e,t,r){var n=t/8|0;return(e[n]|e[n+1]<<8)>>(t&7)&r},qt=function(e,t){
var r=t/8|0;return(e[r]|e[r+1]<<8|e[r+2]<<16)>>(t&7)},sa=function(e){return(e+7)/8|0},aa=function(e,t,r){return(t==null||t<0)&&(t=0),(r==null||r>e.length)&&(r=e.
length),new R(e.subarray(t,r))};var ia=["unexpected EOF","invalid block type","invalid length/literal","invalid distance","stream finished","no stream handler",,"no callback","invalid UTF-8 da\
ta","extra field too long","date not in range 1980-2099","filename too long","stream finishing","invalid zip data"],N=function(e,t,r){var n=new Error(t||ia[e]);
if(n.code=e,Error.captureStackTrace&&Error.captureStackTrace(n,N),!r)throw n;return n},la=function(e,t,r,n){var o=e.length,s=n?n.length:0;if(!o||t.f&&!t.l)return r||
new R(0);var a=!r,i=a||t.i!=2,l=t.i;a&&(r=new R(o*3));var u=function(Or){var Rr=r.length;if(Or>Rr){var Pr=new R(Math.max(Rr*2,Or));Pr.set(r),r=Pr}},d=t.f||0,m=t.
p||0,p=t.b||0,h=t.l,v=t.d,f=t.m,b=t.n,A=o*8;do{if(!h){d=L(e,m,1);var y=L(e,m+1,3);if(m+=3,y)if(y==1)h=na,v=oa,f=9,b=5;else if(y==2){var k=L(e,m,31)+257,ce=L(e,m+
10,15)+4,G=k+L(e,m+5,31)+1;m+=14;for(var j=new R(G),_t=new R(19),O=0;O<ce;++O)_t[ea[O]]=L(e,m+O*3,7);m+=ce*3;for(var Mr=Vt(_t),Es=(1<<Mr)-1,Ts=Ne(_t,Mr,1),O=0;O<
G;){var Ar=Ts[L(e,m,Es)];m+=Ar&15;var x=Ar>>4;if(x<16)j[O++]=x;else{var ue=0,Ye=0;for(x==16?(Ye=3+L(e,m,3),m+=2,ue=j[O-1]):x==17?(Ye=3+L(e,m,7),m+=3):x==18&&(Ye=
11+L(e,m,127),m+=7);Ye--;)j[O++]=ue}}var Er=j.subarray(0,k),V=j.subarray(k);f=Vt(Er),b=Vt(V),h=Ne(Er,f,1),v=Ne(V,b,1)}else N(1);else{var x=sa(m)+4,S=e[x-4]|e[x-
3]<<8,M=x+S;if(M>o){l&&N(0);break}i&&u(p+S),r.set(e.subarray(x,M),p),t.b=p+=S,t.p=m=M*8,t.f=d;continue}if(m>A){l&&N(0);break}}i&&u(p+131072);for(var Cs=(1<<f)-1,
ks=(1<<b)-1,Lt=m;;Lt=m){var ue=h[qt(e,m)&Cs],de=ue>>4;if(m+=ue&15,m>A){l&&N(0);break}if(ue||N(2),de<256)r[p++]=de;else if(de==256){Lt=m,h=null;break}else{var Tr=de-
254;if(de>264){var O=de-257,Oe=ln[O];Tr=L(e,m,(1<<Oe)-1)+mn[O],m+=Oe}var Nt=v[qt(e,m)&ks],It=Nt>>4;Nt||N(3),m+=Nt&15;var V=ra[It];if(It>3){var Oe=cn[It];V+=qt(e,
m)&(1<<Oe)-1,m+=Oe}if(m>A){l&&N(0);break}i&&u(p+131072);var Cr=p+Tr;if(p<V){var kr=s-V,Os=Math.min(V,Cr);for(kr+p<0&&N(3);p<Os;++p)r[p]=n[kr+p]}for(;p<Cr;++p)r[p]=
r[p-V]}}t.l=h,t.p=Lt,t.b=p,t.f=d,h&&(d=1,t.m=f,t.d=v,t.n=b)}while(!d);return p!=r.length&&a?aa(r,0,p):r.subarray(0,p)};var ca=new R(0);var ua=function(e,t){return((e[0]&15)!=8||e[0]>>4>7||(e[0]<<8|e[1])%31)&&N(6,"invalid zlib data"),(e[1]>>5&1)==+!t&&N(6,"invalid zlib data: "+(e[1]&32?"need":"u\
nexpected")+" dictionary"),(e[1]>>3&4)+2};function fn(e,t){return la(e.subarray(ua(e,t&&t.dictionary),-4),{i:2},t&&t.out,t&&t.dictionary)}var da=typeof TextDecoder<"u"&&new TextDecoder,ma=0;try{da.decode(ca,{stream:!0}),ma=1}catch{}var yn=["pursuer","evader"];function be(e,t,r){let[n,o]=[t-e.payoff.first[0],r-e.payoff.first[1]],s=e.payoff.capture_rate[n]?.[o];return s===void 0?null:{rate:s,rates:e.payoff.capture_rates[n][o],
lengths:e.payoff.lengths[n][o]}}function vn(e,t,r){let{script:n,network:o,kept:s,genomes:a}=e.teams[t];if(n!==null||o===null)return"";if(!s.includes(r))return`T\
he page holds no genome of ${t}s ${r}: it would be too large. Choose a generation of ${s.join(", ")}.`;let i=s.length*o.genome_size;return bn(a,o.genome_size).length===
i?"":`The page is damaged: it does not hold the ${i} numbers of the ${t}s' genomes. Write it again from its run.`}function B(e,t,r){let{script:n,network:o,kept:s,
genomes:a}=e.teams[t];if(n!==null||o===null)return n??"random";let i=s.indexOf(r);if(i<0)throw new RangeError(`${t}: expected a generation whose genome the page\
 holds, got ${r}`);let l=o.genome_size,u=bn(a,l).subarray(i*l,(i+1)*l),{hidden:d,activation:m,sampled:p,memory:h}=o;return{hidden:d,activation:m,sampled:p,memory:h,
genome:u}}var Yt=4,gn=new Map;function bn(e,t){let r=gn.get(e);if(r)return r;let n=new Float32Array;try{let o=ha(Zt(e),t);o.every(Number.isFinite)&&(n=o)}catch(o){
if(!(o instanceof DOMException||o instanceof RangeError||pa(o)))throw o}return gn.set(e,n),n}var pa=e=>e instanceof Error&&"code"in e;function ha(e,t){let r=fn(
e),n=r.length/Yt,o=new Uint8Array(r.length);for(let a=0;a<o.length;a++)o[a]=r[a%Yt*n+Math.floor(a/Yt)];let s=new Uint32Array(o.buffer);for(let a=t;a<s.length;a++)
s[a]^=s[a-t];return new Float32Array(o.buffer)}function Zt(e){let t=atob(Fe(e)),r=new Uint8Array(t.length);for(let n=0;n<r.length;n++)r[n]=t.charCodeAt(n);return r}
function Fe(e){return document.getElementById(e)?.textContent??""}var xn=()=>JSON.parse(Fe("data"));var ze=[[68,1,84],[72,26,108],[71,47,125],[65,68,135],[57,86,140],[49,104,142],[42,120,142],[35,136,142],[31,152,139],[34,168,132],[53,183,121],[84,197,104],[122,
209,81],[165,219,54],[210,226,27],[253,231,37]];function tt(e){let t=Math.min(1,Math.max(0,e))*(ze.length-1),r=Math.min(ze.length-2,Math.floor(t)),[n,o]=[ze[r],
ze[r+1]],s=a=>Math.round(n[a]+(t-r)*(o[a]-n[a]));return[s(0),s(1),s(2)]}function rt(e){let[t,r,n]=tt(e).map(o=>((o/255+.055)/1.055)**2.4);return .2126*t+.7152*r+
.0722*n>.179?"#000":"#fff"}var nt=e=>`rgb(${tt(e).join(" ")})`,wn=()=>`linear-gradient(to right, ${ze.map(e=>`rgb(${e.join(" ")})`).join(", ")})`;var Mn=e=>e.answer===void 0?ga():fa(e,e.answer);function fa(e,t){let r=c("input",{type:"text",inputmode:"decimal",size:8,"aria-label":"Your answer, a number",autocomplete:"\
off"});return{input:r,check:()=>{let o=r.value.trim().replace(",","."),s=Number(o);if(o===""||Number.isNaN(s))return"Expected a number, such as 0.5.";let a=i=>Math.
abs(s-i)<=(e.tolerance??0)+1e-9;return a(t)?null:e.clues?.find(([i])=>a(i))?.[1]??e.otherwise??"Expected another number."},answer:()=>r.value,set:o=>r.value=o}}
var I=4,Jt=[.5,.8,.2];function ga(){let e=new Array(I*I).fill(.5),t=(l,u)=>{l.textContent=e[u].toFixed(1),l.ariaLabel=`pursuers ${Math.floor(u/I)} against evade\
rs ${u%I}: ${l.textContent}`,[l.style.background,l.style.color]=[nt(e[u]),rt(e[u])]},r=e.map((l,u)=>{let d=c("button",{type:"button",disabled:u%(I+1)===0,onclick:()=>{
e[u]=Jt[(Jt.indexOf(e[u])+1)%Jt.length],t(d,u)}});return t(d,u),d}),n=Array.from({length:I},(l,u)=>u),o=c("div",{class:"cells numbers",role:"group","aria-label":"\
Capture rates: rows are pursuers, columns evaders"},c("span"),...n.map(l=>c("span",{class:"evader"},`evaders ${l}`)),...n.flatMap(l=>[c("span",{class:"pursuer"},
`pursuers ${l}`),...r.slice(l*I,(l+1)*I)])),s=l=>n.map(u=>n.reduce((d,m)=>d+e[l(u,m)],0)/I);return{input:o,check:()=>{let l=s((m,p)=>m*I+p),u=s((m,p)=>p*I+m),d=(m,p)=>m.
every((h,v)=>!v||p*(h-m[v-1])>1e-9);return d(l,1)?d(u,-1)?null:`The means of the columns are ${Sn(u)}. They say how often the evaders are captured, and should f\
all from column to column.`:`The means of the rows are ${Sn(l)}. They are the strengths of the pursuers, and should grow from row to row.`},answer:()=>e.join(" "),
set:l=>{l.split(" ").forEach((u,d)=>e[d]=Number(u)),r.forEach(t)}}}var Sn=e=>e.map(t=>t.toFixed(2)).join(", ");var Xt=e=>e.trim().split(/\n\s*\n/).map(t=>c("p",{},...ot(t))),ot=e=>e.split("**").map((t,r)=>r%2?c("strong",{},t):document.createTextNode(t));function An(e,t){
let{predict:r,options:n}=e,o=c("p",{class:"small muted",role:"status"}),s=c("button",{type:"submit",class:"primary"},"This is my prediction"),a=Object.keys(n).map(
u=>c("input",{type:"radio",name:`prediction-${r}`,value:u})),i=c("form",{class:"prediction",id:`prediction-${r}`},c("fieldset",{},c("legend",{},c("strong",{},"P\
redict. "),e.question),...a.map(u=>c("label",{class:"option"},u,c("span",{},n[u.value])))),c("div",{class:"buttons"},s,o)),l=()=>{let u=t.choice(r);if(u!==void 0){
for(let d of a)[d.checked,d.disabled]=[d.value===u,!0];s.hidden=s.disabled=!0,o.replaceChildren(),i.append(e.later?c("p",{class:"reply"},e.later):Qt(e,u))}};return i.
addEventListener("submit",u=>{u.preventDefault();let d=a.find(m=>m.checked);d?(t.choose(r,d.value),l()):o.textContent="Choose one first. Any prediction is a goo\
d one."}),l(),i}function Qt(e,t){let{options:r,outcome:n}=e,o=t===n;return c("div",{class:"reply",role:"status","data-right":String(o)},c("p",{},c("strong",{},o?
"✓ As you predicted: ":"You predicted: "),r[t]),o?null:c("p",{},c("strong",{},"The outcome: "),r[n]),...Xt(e.explanation),e.note&&c("p",{class:"small muted"},
e.note))}function En(e,t){let{input:r,check:n,answer:o,set:s}=Mn(e),a=c("p",{class:"reply",role:"status",hidden:!0}),i=d=>{a.hidden=!1,a.dataset.right=String(d===
null),a.replaceChildren(c("strong",{},d===null?"✓ Right. ":"✗ Not yet. "),d??e.explanation)},l=c("form",{class:"exercise",id:`exercise-${e.exercise}`},c("di\
v",{class:"text"},c("p",{},c("strong",{},"Exercise. "),...ot(e.question))),e.matrix&&ya(e.matrix),c("div",{class:"buttons"},r,c("button",{type:"submit"},"Check")),
a);l.addEventListener("submit",d=>{d.preventDefault();let m=n();m===null&&t.solve(e.exercise,o()),i(m)});let u=t.solved(e.exercise);return u!==void 0&&(s(u),i(null)),
l}function ya(e){let t=e.map((r,n)=>n);return c("div",{class:"wide-table",tabindex:0},c("table",{class:"rates numbers"},c("thead",{},c("tr",{},c("td"),...t.map(
r=>c("th",{scope:"col"},`evaders ${r}`)))),c("tbody",{},...e.map((r,n)=>c("tr",{},c("th",{scope:"row"},`pursuers ${n}`),...r.map(o=>c("td",{},o.toFixed(1))))))))}var va=40;function er(e,t){c("a",{href:URL.createObjectURL(new Blob([t],{type:"text/plain"})),download:e}).click()}function Tn({question:e="",points:t=[]},r){let n=c(
"textarea",{id:"exit-answer",rows:8}),o=c("p",{class:"printed"}),s=c("p",{class:"small muted",role:"status"}),a=c("button",{type:"submit",class:"primary"},"I am\
 done"),i=c("form",{class:"exercise"},c("label",{for:"exit-answer"},c("strong",{},"Exit question. "),e),n,o,c("div",{class:"buttons"},a,c("button",{type:"button",
onclick:()=>er("exit_answer.txt",`${e}

${n.value}
`)},"Save my answer"),s)),l=()=>{o.textContent=r.exit.exit,r.exit.done&&([n.readOnly,a.hidden]=[!0,!0],i.append(c("div",{class:"reply"},c("p",{},c("strong",{},"\
A good answer has:")),c("ul",{},...t.map(u=>c("li",{},...ot(u)))))))};return n.value=r.exit.exit,n.addEventListener("input",()=>{r.exit={exit:n.value},o.textContent=
n.value}),i.addEventListener("submit",u=>{if(u.preventDefault(),n.value.trim().length<va){s.textContent="Write two explanations and an experiment first. Then th\
e page shows what a good answer has.";return}s.textContent="",r.exit={done:!0},l()}),l(),c("div",{class:"widget"},i)}var tr=[[0,0],[-1,0],[0,1],[1,0],[0,-1],[-1,1],[1,1],[1,-1],[-1,-1]];var re=(e,t)=>t<e.nPursuers,T=(e,t)=>[e.positions[2*t],e.positions[2*t+1]],ba=(e,t)=>e[0]===t[0]&&e[1]===t[1],rr=({rows:e,cols:t},[r,n])=>r>=0&&n>=0&&r<e&&n<t,nr=(e,t,r=3)=>e!==
void 0&&[0,1,2].slice(0,r).some(n=>e[3*t+n]),or=(e,t)=>nr(e.fault,t),Cn=(e,t)=>!or(e,t)&&nr(e.involved,t,2);function st(e,t,r){let n=!ba(T(e,r),T(t,r)),o=t.involved===
void 0||nr(t.involved,r);return!!(t.alive[r]&&t.actions?.[r]&&!n&&o)}function at(e,t,r){let[n,o]=T(e,r),[s,a]=tr[t.actions?.[r]??0];return[n+s,o+a]}function De(e,t,r){
return Array.from({length:r.everCaptured.length},(o,s)=>s).filter(o=>r.everCaptured[o]&&!t.everCaptured[o]).map(o=>e.nPursuers+o)}var it=e=>e.moments.flatMap((t,r)=>r&&
De(e,e.moments[r-1],t).length?[r]:[]);function lt(e,t){return Array.from({length:t.alive.length},(n,o)=>o).filter(n=>e.alive[n]&&!t.alive[n])}var kn=[-.31,0,.31],On=[{size:1,at:[[0,0]]},{size:.62,at:[[-.2,.2],[.2,-.2]]},{size:.54,at:[[-.23,.22],[.23,.22],[0,-.22]]},{size:.54,at:[[-.23,.23],[.23,.23],[
-.23,-.23],[.23,-.23]]},{size:.36,at:kn.flatMap(e=>kn.map(t=>[t,e]))}],xa=.3,wa=.35,Sa=.55;function Ue(e,t){let r=new Map;for(let n=0;n<t.alive.length;n++){if(!t.
alive[n])continue;let[o,s]=T(t,n),a=o*e.cols+s,i=r.get(a);i?i.push(n):r.set(a,[n])}return r}function Rn(e,t){let r=Array.from(t.alive,(n,o)=>{let[s,a]=T(t,o);return{
x:a+.5,y:s+.5,size:1,alpha:0}});for(let n of Ue(e,t).values()){let o=On[Math.min(n.length,On.length)-1];n.forEach((s,a)=>{let[i,l]=o.at[Math.min(a,o.at.length-1)],
u=r[s];u.x+=i,u.y+=l,u.size=o.size,u.alpha=1})}return r}var Pn=e=>e*e*(3-2*e),xe=(e,t,r)=>e+(t-e)*r,$n=e=>Math.min(1,Math.max(0,e));function _n(e,t,r,n){let o={
SIMULTANEOUS:1,SWARM_TURNS:2,AGENT_TURNS:r}[e.interaction];if(o===1)return Pn(n);let s=o===r?t:+!re(e,t),a=Math.max(1/o,wa);return Pn($n((n-s/(o-1)*(1-a))/a))}function ct(e,t){
let r=e.moments.length-1,n=Math.min(Math.floor(t),r),o=e.moments[n],s=Rn(e,o);if(n===r||t===n)return s;let a=e.moments[n+1],i=Rn(e,a);return s.map((l,u)=>{let d=_n(
e,u,s.length,t-n);return Ma(o,a,u,l,i[u],d)})}function sr(e,t,r){let n=e.moments.length-1,o=Math.min(Math.floor(r),n),[s,a]=[e.moments[o],e.moments[Math.min(o+1,
n)]],i=_n(e,t,s.alive.length,r-o),[[l,u],[d,m]]=[T(s,t),T(a,t)];return[xe(u,m,i)+.5,xe(l,d,i)+.5]}function Ma(e,t,r,n,o,s){let a=n.alpha>o.alpha,i={x:xe(n.x,o.x,
s),y:xe(n.y,o.y,s),size:a?n.size:xe(n.size,o.size,s),alpha:a?$n((1-s)/(1-Sa)):xe(n.alpha,o.alpha,s)};if(st(e,t,r)){let[l,u]=T(e,r),[d,m]=at(e,t,r),p=xa*Math.sin(
Math.PI*s);i.x+=(m-u)*p,i.y+=(d-l)*p}return i}var Ln=2*Math.PI;function ne(e,t,r,n){e.beginPath(),e.arc(t,r,n/2,0,Ln)}function ut(e,t,r,n){let o=n/2,s=[[0,-.97],[.97,.83],[-.97,.83]].map(([a,i])=>[t+a*o,r+i*
o]);e.beginPath(),e.moveTo((s[2][0]+s[0][0])/2,(s[2][1]+s[0][1])/2),s.forEach(([a,i],l)=>{let[u,d]=s[(l+1)%3];e.arcTo(a,i,u,d,n*.09)}),e.closePath()}function Nn(e,t,r,n){
let o=n*.32;e.beginPath(),e.moveTo(t-o,r-o),e.lineTo(t+o,r+o),e.moveTo(t+o,r-o),e.lineTo(t-o,r+o)}function In(e,t,r,n){e.beginPath();for(let o=0;o<16;o++){let s=n/
2*(o%2?.6:.95),a=Ln*o/16;e.lineTo(t+s*Math.sin(a),r-s*Math.cos(a))}e.closePath()}function Fn(e,t,r,n,o,s){let a=Math.atan2(o-r,n-t);e.beginPath(),e.moveTo(t,r),
e.lineTo(n,o);for(let i of[-1,1])e.moveTo(n,o),e.lineTo(n-s*Math.cos(a+i*.6),o-s*Math.sin(a+i*.6))}var zn=4,Aa=1.6,Ea=.95,Ta=5,Ca=.16,ka=9,Oa=.09,Ra=.2,Dn=.75,P=(e,t)=>e.left+t*e.cell,$=(e,t)=>e.top+t*e.cell;function we(e,t,r){return re(t,r)?e.colors.pursuer:
e.colors.evader}function Un({ctx:e,grid:t,colors:r}){let{left:n,top:o,cell:s,rows:a,cols:i}=t,[l,u]=[i*s,a*s];if(e.fillStyle=r.paper,e.fillRect(n,o,l,u),s<Ta)return;
e.fillStyle=r.line;let d=Math.max(1,Math.round(s/60));for(let m=1;m<i;m++)e.fillRect(n+m*s,o,d,u);for(let m=1;m<a;m++)e.fillRect(n,o+m*s,l,d)}function Hn({ctx:e,
grid:t,colors:r},n){let{left:o,top:s,cell:a,rows:i,cols:l}=t;e.fillStyle=r.obstacle;for(let u=0;u<i*l;u++){if(!n.obstacles[u])continue;let[d,m]=[Math.floor(u/l),
u%l];e.fillRect(o+m*a,s+d*a,a,a)}Wn({ctx:e,grid:t,colors:r})}function Wn({ctx:e,grid:{left:t,top:r,cell:n,rows:o,cols:s},colors:a}){let i=Math.min(5,Math.max(2,
Math.round(n/18)));e.strokeStyle=a.frame,e.lineWidth=i,e.strokeRect(t-i/2,r-i/2,s*n+i,o*n+i)}function Bn({ctx:e,grid:t,colors:r},n){let{left:o,top:s,cell:a,rows:i,
cols:l}=t,u=a<24*n?5:1;e.font=`500 ${Math.round(Math.min(15*n,Math.max(9*n,a*.32)))}px system-ui, sans-serif`,e.fillStyle=r.muted,e.textBaseline="alphabetic",e.
textAlign="center";let d=5*n+a/40;for(let m=0;m<l;m+=u)e.fillText(String(m),o+(m+.5)*a,s-d);e.textAlign="right",e.textBaseline="middle";for(let m=0;m<i;m+=u)e.fillText(
String(m),o-d,s+(m+.5)*a)}function Gn({grid:e},t,r,n){let o=Math.floor(t.fov/2)+.5,[s,a]=[Math.max(0,r-o),Math.min(e.cols,r+o)],[i,l]=[Math.max(0,n-o),Math.min(
e.rows,n+o)];return[P(e,s),$(e,i),(a-s)*e.cell,(l-i)*e.cell]}function jn(e,t,r,n){let{ctx:o,grid:s,colors:a}=e;o.save(),o.beginPath(),o.rect(0,0,o.canvas.width,
o.canvas.height),o.rect(...Gn(e,t,r,n)),o.clip("evenodd"),o.clearRect(0,0,o.canvas.width,o.canvas.height),o.fillStyle=a.line,o.fillRect(s.left,s.top,s.cols*s.cell,
s.rows*s.cell),o.restore(),Wn(e)}function Vn({ctx:e,grid:t,colors:r},{x:n,y:o,alpha:s},a){let i=Math.max(t.cell,16*a)*1.06,[l,u]=[P(t,n),$(t,o)];e.globalAlpha=Math.
max(s,.6),e.beginPath(),e.roundRect(l-i/2,u-i/2,i,i,i*.2),e.strokeStyle=r.focus,e.lineWidth=Math.max(2,2.5*a),e.stroke();let d=Math.max(11*a,Math.min(18*a,t.cell*
.5));e.font=`700 ${Math.round(d)}px system-ui, sans-serif`,e.textAlign="center",e.textBaseline="middle";let m=u-i/2<d*1.2,p=u+(m?1:-1)*(i/2+d*.7);e.strokeStyle=
r.paper,e.lineJoin="round",e.lineWidth=d*.35,e.strokeText("You",l,p),e.fillStyle=r.ink,e.fillText("You",l,p),e.globalAlpha=1}function qn(e,t,r,n,o){let{ctx:s,grid:a}=e,
i=Gn(e,t,n,o),l=we(e,t,r);s.globalAlpha=.11,s.fillStyle=l,s.fillRect(...i),s.globalAlpha=.8,s.strokeStyle=l,s.lineWidth=Math.max(1,a.cell/24),s.strokeRect(...i),
s.globalAlpha=1}function Kn(e,t,r,n,o){let{ctx:s,grid:a}=e,i=Math.min(Math.ceil(r),t.moments.length-1),l=t.moments[i];s.lineCap="round",s.lineWidth=Math.min(ka,
Math.max(1,a.cell*Ca));for(let u=Math.max(1,Math.floor(r-n)+1);u<=i;u++){let[d,m]=[t.moments[u-1],t.moments[u]],p=Math.max(0,Math.min(1,(r-u)/n));s.globalAlpha=
Dn+(Ra-Dn)*p;for(let h=0;h<m.alive.length;h++){let v=u===i&&r<i;if(!d.alive[h]||!(l.alive[h]||v))continue;let f=(re(t,h)?-1:1)*Oa,[b,A]=T(d,h),[y,x]=T(m,h);if(b===
y&&A===x)continue;let S=v?o[h].x:x+.5,M=v?o[h].y:y+.5;s.strokeStyle=we(e,t,h),s.beginPath(),s.moveTo(P(a,A+.5+f),$(a,b+.5+f)),s.lineTo(P(a,S+f),$(a,M+f)),s.stroke()}}
s.globalAlpha=1}function Yn(e,t,r){let n=Math.min(Math.ceil(r),t.moments.length-1);for(let o=Math.max(1,n-zn+1);o<=n;o++){let[s,a]=[t.moments[o-1],t.moments[o]],
i=o>r?Math.max(0,1-2*(o-r)):1-(r-o)/zn,l=De(t,s,a);for(let u of lt(s,a))l.includes(u)||$a(e,T(a,u),i);for(let u of l)Pa(e,T(a,u),i)}e.ctx.globalAlpha=1}function Pa({
ctx:e,grid:t,colors:r},[n,o],s){e.globalAlpha=s,In(e,P(t,o+.5),$(t,n+.5),Math.max(8,t.cell*Aa)),e.fillStyle=r.capture,e.fill(),e.strokeStyle=r.ink,e.lineWidth=Math.
max(1,t.cell/36),e.lineJoin="round",e.stroke()}function $a({ctx:e,grid:t,colors:r},[n,o],s){e.globalAlpha=s,Nn(e,P(t,o+.5),$(t,n+.5),Math.max(7,t.cell*Ea)),e.strokeStyle=
r.collision,e.lineWidth=Math.max(2,t.cell*.17),e.lineCap="round",e.stroke()}function Zn({ctx:e,grid:t,colors:r},n,o){let s=Math.max(1,t.cell*.07);e.strokeStyle=
e.fillStyle=r.collision,e.lineWidth=Math.max(1,t.cell*.05),e.setLineDash([t.cell*.14,t.cell*.1]);for(let[a,i]of n){if(a<0||i<0||a>=t.rows||i>=t.cols)continue;let l=[
P(t,i)+s,$(t,a)+s,t.cell-2*s,t.cell-2*s];e.globalAlpha=.2*o,e.fillRect(...l),e.globalAlpha=o,e.strokeRect(...l)}e.setLineDash([]),e.globalAlpha=1}function Jn({ctx:e,
grid:t,colors:r},n,o,s,a){e.globalAlpha=a,ne(e,P(t,n),$(t,o),Math.max(8,t.cell*s*1.02)),e.strokeStyle=r.collision,e.lineWidth=Math.max(1.5,t.cell*.085*Math.sqrt(
s)),e.stroke(),e.globalAlpha=1}var _a=.8,La=.92,Na=15,Ia=7,ar=9;function Xn(e,t,r,n,o,s){n.forEach((a,i)=>{a.alpha>0&&Fa(e,t,r,i,a,o,s)}),e.ctx.globalAlpha=1;for(let a of Ue(t,r).values())a.length>
ar&&za(e,n[a[ar-1]],a.length-ar+1)}function Fa(e,t,r,n,o,s,a){let{ctx:i,grid:l,colors:u}=e,d=re(t,n),[m,p]=[l.left+o.x*l.cell,l.top+o.y*l.cell],h=Math.max(4,l.cell*
o.size*(d?La:_a)),v=we(e,t,n),f=!d&&!!r.captured[n-t.nPursuers];if(i.globalAlpha=o.alpha,(d?ut:ne)(i,m,p,h),h>Ia*a&&(i.strokeStyle=u.paper,i.lineWidth=Math.max(
2,h*.1),i.stroke()),i.fillStyle=f?u.paper:v,i.fill(),f&&(ne(i,m,p,h*.82),i.strokeStyle=v,i.lineWidth=h*.18,i.stroke()),!s||h<Na*a)return;let b=String(d?n:n-t.nPursuers);
i.font=`700 ${Math.round(h*(d?.4:.5)*(b.length>1?.8:1))}px system-ui, sans-serif`,i.textAlign="center",i.textBaseline="middle",i.fillStyle=f?v:u.paper,i.fillText(
b,m,p+h*(d?.17:.03))}function za({ctx:e,grid:t,colors:r},n,o){let[s,a]=[t.left+n.x*t.cell,t.top+n.y*t.cell];e.font=`700 ${Math.round(t.cell*.3)}px system-ui, sa\
ns-serif`,e.textAlign="center",e.textBaseline="middle",e.strokeStyle=r.paper,e.lineWidth=t.cell*.1,e.strokeText(`+${o}`,s,a),e.fillStyle=r.ink,e.fillText(`+${o}`,
s,a)}var Da=.46,Ua=.86,Ha=.66,Qn=.48,Wa=.78,Ba=.58;function eo(e,t,r,n){let[o,s]=[t.moments[r-1],t.moments[r]];if(!o)return;let{ctx:a,grid:i,colors:l}=e;a.strokeStyle=
l.collision,a.lineWidth=Math.max(1.5,i.cell*.07),a.lineCap="butt",a.globalAlpha=n;for(let u=0;u<s.alive.length;u++)st(o,s,u)&&Ga(e,t,T(o,u),at(o,s,u));a.globalAlpha=
1}function Ga({ctx:e,grid:t},r,n,o){let[s,a]=[o[1]-n[1],o[0]-n[0]],i=m=>P(t,n[1]+.5+s*m),l=m=>$(t,n[0]+.5+a*m),u=rr(r,o)?Wa:Ba;e.setLineDash([t.cell*.09,t.cell*
.06]),e.beginPath(),e.moveTo(i(Qn),l(Qn)),e.lineTo(i(u),l(u)),e.stroke(),e.setLineDash([]);let d=.17*t.cell/Math.hypot(s,a);e.beginPath(),e.moveTo(i(u)-a*d,l(u)+
s*d),e.lineTo(i(u)+a*d,l(u)-s*d),e.stroke()}function to(e,t,r,n,o,s){let a=tr[s];if(!s||!a)return;let{ctx:i,grid:l,colors:u}=e,d=rr(t,[n[0]+a[0],n[1]+a[1]])?Ua:
Ha,m=Da*o.size,p=[P(l,o.x+a[1]*m),$(l,o.y+a[0]*m),P(l,o.x+a[1]*d),$(l,o.y+a[0]*d)],h=Math.max(1.5,l.cell*.085);i.lineCap=i.lineJoin="round";for(let[v,f]of[[u.paper,
h*2.1],[we(e,t,r),h]])i.strokeStyle=v,i.lineWidth=f,Fn(i,...p,l.cell*.2),i.stroke()}var no={numbers:!0,axes:!1,trail:6,viewers:[],plan:null,selected:null,cursor:null,you:null,fog:!1};function oo(e,t,r,n,o){let{ctx:s,grid:a,colors:i}=e,l=Math.min(
Math.ceil(r),t.moments.length-1),u=t.moments[l],d=r===l,m=ct(t,r),p=d?1:Math.max(0,1-2*(l-r));s.clearRect(0,0,s.canvas.width,s.canvas.height),Un(e);for(let f of n.
viewers)m[f]?.alpha&&qn(e,t,f,...sr(t,f,r));Hn(e,t),n.axes&&Bn(e,o),Kn(e,t,r,n.trail,m),Zn(e,u.contested??[],p),Yn(e,t,r),eo(e,t,l,p),m.forEach(({x:f,y:b,size:A},y)=>{
let x=Cn(u,y)?.4:0,S=or(u,y)?1:x;S&&Jn(e,f,b,A,S*p)});let h=d?u:t.moments[Math.max(0,l-1)];if(Xn(e,t,h,m,n.numbers,o),d&&n.plan)for(let[f,b]of m.entries())b.alpha&&
to(e,t,f,T(u,f),b,n.plan[f]??0);n.you!==null&&(n.fog&&jn(e,t,...sr(t,n.you,r)),Vn(e,m[n.you],o)),s.lineWidth=Math.max(2,2.5*o),s.strokeStyle=i.focus;let v=n.selected===
null?void 0:m[n.selected];v?.alpha&&ro(e,v.x,v.y,v.size*.96),n.cursor&&(s.setLineDash([a.cell*.12,a.cell*.08]),ro(e,n.cursor[1]+.5,n.cursor[0]+.5,.8),s.setLineDash(
[]))}function ro({ctx:e,grid:t},r,n,o){let s=o*t.cell;e.beginPath(),e.roundRect(t.left+r*t.cell-s/2,t.top+n*t.cell-s/2,s,s,s*.1),e.stroke()}var so=(e,t)=>(t+.24)/(e+.24);function ao(e,t,r,n,o,s){let a=r?28*s:0,i=(u,d)=>(u-a)/(d+2*.12),l=Math.max(1,Math.floor(Math.min(i(n,t),i(o,e))));return{rows:e,cols:t,
cell:l,left:Math.round((n-t*l+a)/2),top:Math.round((o-e*l+a)/2)}}function io(e,t,r){let n=Math.floor((r-e.top)/e.cell),o=Math.floor((t-e.left)/e.cell);return n>=
0&&n<e.rows&&o>=0&&o<e.cols?[n,o]:null}var ja={paper:"--board-paper",line:"--board-line",frame:"--board-frame",ink:"--board-ink",muted:"--board-muted",obstacle:"--board-obstacle",pursuer:"--pursuer",
evader:"--evader",capture:"--capture",collision:"--collision",focus:"--focus"};function dt(e){let t=getComputedStyle(e),r=Object.entries(ja).map(([n,o])=>[n,t.getPropertyValue(
o).trim()]);return Object.fromEntries(r)}var oe=()=>matchMedia("(prefers-reduced-motion: reduce)").matches,Se=class{canvas;#e=null;#n=0;#t;#o={rows:1,cols:1,left:0,top:0,cell:1};#s=0;#r;#l;constructor(t,r={}){
this.canvas=t,t.classList.add("board"),t.setAttribute("role","img"),this.#t={...no,...r},this.#r=new ResizeObserver(()=>this.#u()),this.#r.observe(t),this.#l=new MutationObserver(
()=>this.redraw()),this.#l.observe(document.documentElement,{attributes:!0}),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",this.redraw)}close(){
this.#r.disconnect(),this.#l.disconnect(),matchMedia("(prefers-color-scheme: dark)").removeEventListener("change",this.redraw),cancelAnimationFrame(this.#s)}get look(){
return this.#t}set look(t){this.#t={...this.#t,...t},this.#d(),this.redraw()}show(t,r){this.#e=t,this.#n=Math.min(Math.max(0,r),t.moments.length-1),this.#d(),this.
redraw()}redraw=()=>{this.#s||(this.#s=requestAnimationFrame(()=>this.drawNow()))};drawNow(){cancelAnimationFrame(this.#s),this.#s=0;let t=this.canvas.getContext(
"2d");if(!t||!this.#e)return;let{rows:r,cols:n}=this.#e,o=devicePixelRatio||1;this.#o=ao(r,n,this.#t.axes,this.canvas.width,this.canvas.height,o);let s={ctx:t,grid:this.#o,
colors:dt(this.canvas)};oo(s,this.#e,this.#n,this.#t,o)}cellAt(t,r){let n=this.canvas.getBoundingClientRect(),o=this.canvas.width/n.width;return io(this.#o,(t-n.
left)*o,(r-n.top)*o)}agentAt(t,r){let n=this.cellAt(t,r);if(!n||!this.#e)return null;let o=this.#e.moments[Math.round(this.#n)],s=Ue(this.#e,o).get(n[0]*this.#e.
cols+n[1])??[],a=ct(this.#e,Math.round(this.#n)),i=l=>{let[u,d]=this.pointOf(a[l].x,a[l].y);return Math.hypot(u-t,d-r)};return s.length?s.reduce((l,u)=>i(u)<i(l)?
u:l):null}pointOf(t,r){let n=this.canvas.getBoundingClientRect(),o=n.width/this.canvas.width,{left:s,top:a,cell:i}=this.#o;return[n.left+(s+t*i)*o,n.top+(a+r*i)*
o]}#d(){if(!this.#e)return;let{rows:t,cols:r}=this.#e;this.canvas.style.setProperty("--board-aspect",String(so(t,r)))}#u(){let t=devicePixelRatio||1,{width:r,height:n}=this.
canvas.getBoundingClientRect();this.canvas.width=Math.max(1,Math.round(r*t)),this.canvas.height=Math.max(1,Math.round(n*t)),this.drawNow()}};var He=[.5,1,2,4,8,16,32,64],mt=0,pt=12,Va=2,K=class extends EventTarget{#e;#n;#t;#o=0;#s=0;#r=!1;#l=null;#d=0;#u=[];#p=[];glide=.28;constructor(t,r={}){super(),
this.#e=t,this.#n=r.speed??4,this.#t=r.still??!1}get step(){return this.#o}get time(){return this.#t?this.#o:this.#s}get arrived(){return this.#s===this.#o}get playing(){
return this.#r}get length(){return this.#e}set length(t){this.#e=t,this.#o>t&&this.jump(t),this.#i("state")}get marks(){return this.#u}set marks(t){this.#u=t,this.#i(
"state")}get ticks(){return this.#p}set ticks(t){this.#p=t,this.#i("state")}get pace(){return this.#n||Math.max(Va,this.#e/pt)}get speed(){return this.#n}set speed(t){
this.#n=t,this.#i("state")}changeSpeed(t){let r=He.findIndex(n=>n>=this.pace);this.speed=He[Math.min(He.length-1,Math.max(0,r+t))]}play(){this.#r||!this.#e||(this.#o===
this.#e&&this.jump(0),this.#r=!0,this.#i("state"),this.#a())}pause(){this.#r&&(this.#r=!1,this.#i("state"))}toggle(){this.#r?this.pause():this.play()}move(t){this.
pause();let r=Math.min(this.#e,Math.max(0,this.#o+t));Math.abs(r-this.#s)>1?this.jump(r):this.#c(r),this.#a()}jump(t){this.#s=Math.min(this.#e,Math.max(0,Math.round(
t))),this.#c(this.#s),this.#i("frame")}#c(t){t!==this.#o&&(this.#o=t,this.#i("step"),this.#t&&this.#i("frame"))}#a(){this.#l===null&&(this.#d=performance.now(),
this.#l=requestAnimationFrame(()=>this.#m()))}#m(){this.#l=null;let t=performance.now();this.#h(Math.min(.25,(t-this.#d)/1e3)),this.#d=t,(!this.#t||this.arrived)&&
this.#i("frame"),(this.#r||this.#s!==this.#o)&&(this.#l=requestAnimationFrame(()=>this.#m()))}#h(t){let r=t;for(;r>0;){if(this.#s===this.#o){if(!this.#r)return;
if(this.#o===this.#e)return this.pause();this.#c(this.#o+1)}let n=this.#r?this.pace:1/this.glide,o=this.#o-this.#s,s=Math.min(Math.abs(o),r*n);r-=s/n,this.#s=s===
Math.abs(o)?this.#o:this.#s+Math.sign(o)*s}this.#r&&this.#s===this.#e&&this.pause()}#i(t){this.dispatchEvent(new Event(t))}};function lo(e,t){if(t.ctrlKey||t.metaKey||
t.altKey)return!1;let r=t.shiftKey?10:1,o={" ":()=>e.toggle(),ArrowRight:()=>e.move(r),ArrowLeft:()=>e.move(-r),Home:()=>e.move(-e.length),End:()=>e.move(e.length),
"+":()=>e.changeSpeed(1),"-":()=>e.changeSpeed(-1)}[t.key];return o?.(),o!==void 0}var qa={first:"M6 5v14M19 5 9 12l10 7z",back:"M17 5 7 12l10 7z",play:"M7 4.5 19 12 7 19.5z",pause:"M8 5v14M16 5v14",forward:"M7 5l10 7-10 7z",last:"M18 5v14M5 5\
l10 7-10 7z"};function co(e){return g("svg",{viewBox:"0 0 24 24","aria-hidden":"true",class:"icon"},g("path",{d:qa[e]}))}function We(e,t,r,n){return c("button",
{type:"button",class:"player-button","aria-label":t,title:`${t} (${r})`,onclick:n},co(e))}function Me(e){let t=We("play","Play","Space",()=>e.toggle()),r=Ka(e),
n=c("div",{class:"captures","aria-hidden":"true",title:"Captures"}),o=c("div",{class:"losses","aria-hidden":"true"}),s=Ya(e),a=c("output",{class:"player-count"}),
i=c("div",{class:"player",role:"group","aria-label":"Player"},We("first","First step","Home",()=>e.move(-e.length)),We("back","Step back","←",()=>e.move(-1)),
t,We("forward","Step forward","→",()=>e.move(1)),We("last","Last step","End",()=>e.move(e.length)),c("div",{class:"scrub"},n,o,r),a,s),l=(m,p={})=>{let h=c("i",
p);return h.style.left=`${100*m/Math.max(1,e.length)}%`,h},u=()=>{n.replaceChildren(...e.marks.map(m=>l(m))),o.replaceChildren(...e.ticks.map(({step:m,kind:p,size:h,
text:v})=>{let f=l(m,{class:p,title:`Step ${m}: ${v}`});return f.style.height=`${100*h}%`,f}))},d=()=>{t.replaceChildren(co(e.playing?"pause":"play")),t.ariaLabel=
e.playing?"Pause":"Play",t.title=`${t.ariaLabel} (Space)`,r.max=String(e.length),r.value=String(e.step),r.ariaValueText=`step ${e.step} of ${e.length}`,a.textContent=
`${e.step} / ${e.length}`,a.style.minWidth=`${2*String(e.length).length+3}ch`,s.value=String(e.speed)};return e.addEventListener("step",d),e.addEventListener("s\
tate",d),e.addEventListener("state",u),i.addEventListener("keydown",m=>{!(m.target instanceof HTMLSelectElement||m.key===" "&&m.target!==r)&&lo(e,m)&&m.preventDefault()}),
d(),i}function Ka(e){let t=c("input",{type:"range",class:"player-scrub",min:0,step:1,"aria-label":"Step"});return t.addEventListener("input",()=>{e.pause(),e.jump(
Number(t.value))}),t}function Ya(e){let t=`Steps a second, or the whole in ${pt} s (+ and -)`,r=c("select",{class:"player-speed","aria-label":"Speed",title:t},c(
"option",{value:mt},`in ${pt} s`),...He.map(n=>c("option",{value:n},`${n} / s`)));return r.addEventListener("change",()=>{e.speed=Number(r.value)}),r}var C=(e,t=2)=>e==null?"-":e.toFixed(t);function uo(e,t,r){return t===null||r===null?C(e):`${C(e)} (${C(t)} to ${C(r)})`}function Be(e,t,r,n=!1){let o=(t-e)/Math.max(1,r),s=10**Math.floor(Math.log10(o||1)),a=[1,2,5,10].map(u=>u*s).find(u=>u>=o)??10*s;n&&(a=Math.max(1,Math.round(a)));
let i=Math.ceil(e/a-1e-9),l=Math.floor(t/a+1e-9);return Array.from({length:Math.max(0,l-i+1)},(u,d)=>(i+d)*a)}var ht={left:46,right:12,top:10,bottom:42},mo={x:56,y:34};function Y(e,t,r,n){let[o,s]=[ht.left,ht.top],a=Math.max(o+40,e-ht.right),i=Math.max(s+40,t-ht.bottom),
l=(f,b,A)=>y=>b+(y-f.low)/(f.high-f.low||1)*(A-b),[u,d]=[l(r,o,a),l(n,i,s)],m=g("g"),p=g("svg",{width:e,height:t,viewBox:`0 0 ${e} ${t}`,class:"plot"}),h=g("g",
{class:"axes"});for(let f of Be(n.low,n.high,(i-s)/mo.y,n.whole))h.append(g("line",{x1:o,x2:a,y1:d(f),y2:d(f),class:"grid"}),g("text",{x:o-8,y:d(f),"text-anchor":"\
end","dominant-baseline":"middle"},po(f)));for(let f of Be(r.low,r.high,(a-o)/mo.x,r.whole))h.append(g("text",{x:u(f),y:i+16,"text-anchor":"middle"},po(r.mirrored?
Math.abs(f):f)));return h.append(g("line",{x1:o,x2:a,y1:i,y2:i,class:"axis"}),g("text",{x:(o+a)/2,y:t-6,"text-anchor":"middle",class:"label"},r.label),g("text",
{transform:`translate(12 ${(s+i)/2}) rotate(-90)`,"text-anchor":"middle",class:"label"},n.label)),p.append(h,m),{root:p,marks:m,left:o,right:a,top:s,bottom:i,x:u,
y:d,at:f=>{let b=f-p.getBoundingClientRect().left;return r.low+(b-o)/(a-o)*(r.high-r.low)}}}var po=e=>String(Number(e.toPrecision(6))).replace("-","−");function Z(e,t,r,n){
let o="",s="M";r.forEach((a,i)=>{a===null?s="M":(o+=`${s}${e.x(t[i]).toFixed(1)} ${e.y(a).toFixed(1)}`,s="L")}),e.root.insertBefore(g("path",{d:o,class:`line ${n}`}),
e.marks)}function ho(e,t,r,n=null){let o=e.x(t);e.marks.append(g("line",{x1:o,x2:o,y1:e.top,y2:e.bottom,class:`mark ${r}`})),n!==null&&e.marks.append(g("circle",{cx:o,cy:e.
y(n),r:5,class:`dot ${r}`}))}function ft(...e){return c("p",{class:"legend small"},...e.map(([t,r])=>c("span",{class:`key ${r}`},t)))}function J(e,t,r,n){let o=c(
"div",{class:"chart chooses",role:"img","aria-label":e}),s=null,a=()=>{s?.marks.replaceChildren(),s&&r(s)};o.addEventListener("click",l=>s&&n(s.at(l.clientX),s,
l));let i=()=>{let{clientWidth:l,clientHeight:u}=o;l<50||u<50||(s=t(l,u),o.replaceChildren(s.root),a())};return new ResizeObserver(i).observe(o),{element:o,update:a,
redraw:i}}function Ae(e,t,r){let n=devicePixelRatio||1;for(let[a,i]of Object.entries(r))e.style.setProperty(a,`${i}px`);e.width=Math.round(r.width*n),e.height=Math.round(
r.height*n);let o=e.getContext("2d"),s=Za(t);!o||!s||(o.imageSmoothingEnabled=!1,o.drawImage(s,0,0,e.width,e.height))}function Za(e){let[t,r]=e.shape,n=document.
createElement("canvas");[n.width,n.height]=[r,t];let o=n.getContext("2d");if(!o)return null;let s=o.createImageData(r,t);return e.capture_rate.forEach((a,i)=>a.
forEach((l,u)=>{let d=4*((t-1-i-e.first[0])*r+u+e.first[1]);s.data.set([...tt(l),255],d)})),o.putImageData(s,0,0),n}function X(e,t){let r=c("span",{class:"gradi\
ent"});return r.style.backgroundImage=wn(),c("p",{class:"scale-of-rates small muted"},e,r,t)}function se(e,t,r=e.length){let n=c("canvas",{role:"img","aria-label":t}),o=c("div",{class:"cells-of-matrix"},n),s=c("figure",{},c("figcaption",{},t),o,c("p",{class:"\
small muted"},c("span",{class:"pursuer"},"↑ pursuers")," ",c("span",{class:"evader"},"evaders →")));return s.draw=()=>{let a=o.clientWidth;a&&Ae(n,{shape:[r,
r],first:[0,0],capture_rate:e},{left:0,top:0,width:a,height:a})},new ResizeObserver(()=>s.draw?.()).observe(o),s}var go=()=>X("0 all escape","1 all caught"),yo=({
runs:e})=>c("div",{class:"widget"},c("div",{class:"matrices"},...e.map((t,r)=>se(t.payoff.capture_rate,`Matrix ${"ABC"[r]}`))),go()),gt=31,fo=.016;function vo(){
let e=r=>Array.from({length:gt},(n,o)=>Array.from({length:gt},(s,a)=>.5+r*(o-a))),t=[[fo,"Both get better"],[-fo,"Both get worse"],[0,"Nothing happens"]];return c(
"div",{class:"widget"},c("div",{class:"matrices"},...t.map(([r,n])=>se(e(r),n))),go())}function bo(){let e=Array.from({length:gt},(t,r)=>r);return J("A capture \
rate that stays at one half from generation 0 to 30",(t,r)=>{let n=Y(t,r,{low:0,high:gt-1,label:"generation",whole:!0},{low:0,high:1,label:"capture rate"});return Z(
n,e,e.map(()=>.5),"of-both"),n},()=>{},()=>{}).element}function ae(e,t,r,n,o){let s=c("input",{type:"range",min:0,max:t.length-1,step:1,"aria-label":e}),a=c("output",{class:"numbers"}),i=()=>{let l=t[Number(s.value)];
return a.textContent=s.ariaValueText=n(l),l};return s.value=String(t.indexOf(r)),s.addEventListener("input",()=>o(i())),i(),c("label",{class:"slider"},c("span",
{},e),s,a)}function xo(e,t,r){let n=c("select",{"aria-label":e},...t.map(o=>c("option",{value:o},o)));return n.addEventListener("change",()=>r(n.value)),c("labe\
l",{class:"slider"},c("span",{},e),n)}function Q(e){let t=e>>>0;return()=>{t=t+1831565813>>>0;let r=Math.imul(t^t>>>15,t|1);return r^=r+Math.imul(r^r>>>7,r|61),((r^r>>>14)>>>0)/2**32}}var lr=["rock",
"paper","scissors"],cr=[[.5,0,1],[1,.5,0],[0,1,.5]],Ja=1e-9,Mo=e=>cr.map(t=>t.reduce((r,n,o)=>r+n*e[o],0));function ur(e,t){let r=e.slice(-t);return lr.map((n,o)=>r.
filter(s=>s===o).length/r.length)}var dr=e=>Math.max(...Mo(e));function wo(e,t,r){let n=Mo(ur(e,t)),o=n.flatMap((s,a)=>s>Math.max(...n)-Ja?[a]:[]);return o[o.length>
1?Math.floor(r()*o.length):0]}function vt(e,t,r){let n={pursuers:[0],evaders:[0]};for(let o=1;o<=e;o++)n.pursuers.push(wo(n.evaders,t,r)),n.evaders.push(wo(n.pursuers,
t,r));return n}var Ge=100,bt={scalar:{dimensions:1,greatest:!0},focusing:{dimensions:10,greatest:!0},intransitive:{dimensions:2,greatest:!1}};function ir(e,t,r){
let{greatest:n}=bt[e],o=t[0]-r[0];for(let s=1;s<t.length;s++){let a=t[s]-r[s];(n?Math.abs(a)>Math.abs(o):Math.abs(a)<Math.abs(o))&&(o=a)}return(1+Math.sign(o))/
2}var mr=(e,t,r)=>t.reduce((n,o)=>n+r.reduce((s,a)=>s+ir(e,o,a),0),0)/(t.length*r.length),Te={population:25,mutation:.005,opponents:15,hall:0},Ee=class{game;settings;generation=0;#e;#n;#t=[
[],[]];constructor(t,r,n){[this.game,this.settings,this.#e]=[t,r,n];let o=()=>Array.from({length:r.population},()=>new Uint8Array(Ge));this.#n=[o(),o()]}ones(t){
let{dimensions:r}=bt[this.game],n=Ge/r;return this.#n[t].map(o=>Array.from({length:r},(s,a)=>yt(o.subarray(a*n,(a+1)*n))))}objective=t=>yt(this.#n[t].map(yt))/this.
settings.population;step(){let t=[this.ones(0),this.ones(1)],r=this.#o(t);for(let n of[0,1]){this.#t[n].push(t[n][r[n].indexOf(Math.max(...r[n]))]);let o=this.#r(
r[n]);this.#n[n]=o.map(s=>this.#s(this.#n[n][s]))}this.generation++}#o(t){let{population:r,opponents:n,hall:o}=this.settings,s=[new Array(r).fill(0),new Array(r).
fill(0)];for(let a=0;a<n;a++)So(r,this.#e).forEach((i,l)=>{let u=ir(this.game,t[0][l],t[1][i]);s[0][l]+=+(u===1),s[1][i]+=+(u===0)});for(let a of[0,1]){let i=this.#t[1-
a];for(let l of So(i.length,this.#e,o))t[a].forEach((u,d)=>s[a][d]+=+(ir(this.game,u,i[l])===1))}return s}#s(t){let r=t.slice();for(let n=0;n<r.length;n++)this.#e()<
this.settings.mutation&&(r[n]^=1);return r}#r(t){let r=yt(t),n=r?t:t.map(()=>1);return t.map(()=>{let o=this.#e()*(r||t.length),s=n.findIndex(a=>(o-=a)<0);return s<
0?t.length-1:s})}};function So(e,t,r=e){let n=Array.from({length:e},(s,a)=>a),o=Math.min(r,e);for(let s=0;s<o;s++){let a=s+Math.floor(t()*(e-s));[n[s],n[a]]=[n[a],
n[s]]}return n.slice(0,o)}function yt(e){let t=0;for(let r=0;r<e.length;r++)t+=e[r];return t}var pr=1,xt=["pursuers","evaders"],To=[[150,42],[266,232],[34,232]],Xa={pursuers:-7,evaders:7},Ao=e=>[0,1].map(t=>e.reduce((r,n,o)=>r+n*To[o][t],0)),Eo=(e,t)=>e.
map((r,n)=>ur(e.slice(0,n+1),t));function Co({memories:e=[1],memory:t=e[0],generations:r=30}){let n=new K(r,{speed:r>100?16:2,still:oe()}),o=t,s=vt(r,o,Q(pr)),a={
pursuers:[],evaders:[]},i={pursuers:g("polyline",{class:"way of-pursuers"}),evaders:g("polyline",{class:"way of-evaders"})},l={pursuers:g("path",{class:"filled-\
pursuer",d:"M0 -11 11 9H-11z"}),evaders:g("circle",{class:"filled-evader",r:9})},u=g("svg",{viewBox:"0 0 300 270",class:"hands-triangle",role:"img","aria-label":"\
The shares of rock, paper and scissors among the remembered hands of both teams"},g("polygon",{class:"frame",points:To.map(b=>b.join()).join(" ")}),g("circle",{
class:"middle",cx:150,cy:168.7,r:4}),g("text",{x:150,y:192,"text-anchor":"middle"},"one third each"),g("text",{class:"label",x:150,y:18,"text-anchor":"middle"},
"rock"),g("text",{class:"label",x:266,y:262,"text-anchor":"middle"},"paper"),g("text",{class:"label",x:34,y:262,"text-anchor":"middle"},"scissors"),...xt.map(b=>i[b]),
...xt.map(b=>l[b])),d=c("p",{class:"numbers"}),m=J("What the best answer wins against the remembered hands, by generation",(b,A)=>{let y=Y(b,A,{low:0,high:r,label:"\
generation",whole:!0},{low:.4,high:1,label:"best answer wins"});Z(y,[0,r],[.5,.5],"half");for(let x of xt)Z(y,s[x].map((S,M)=>M),a[x].map(dr),`of-${x}`);return y},
b=>ho(b,n.step,"of-both"),b=>n.jump(b)),p=()=>{let b=n.step;for(let y of xt){i[y].setAttribute("points",a[y].slice(0,b+1).map(M=>Ao(M).map(k=>k.toFixed(1)).join()).
join(" "));let[x,S]=Ao(a[y][b]);l[y].setAttribute("transform",`translate(${x+Xa[y]} ${S})`)}let A=y=>c("span",{class:y.slice(0,-1)},`${y} show ${lr[s[y][b]]}`);
d.replaceChildren(`Generation ${b}: `,A("pursuers"),", ",A("evaders"),".",...e.length>1?[` The best answer to the remembered hands of the pursuers wins ${C(dr(a.
pursuers[b]))}.`]:[]),m.update()},h=()=>{s=vt(r,o,Q(pr)),a={pursuers:Eo(s.pursuers,o),evaders:Eo(s.evaders,o)},m.redraw(),p()};n.addEventListener("step",p),h();
let v=e.at(-1),f=ae("memory (hands)",e,t,b=>b===v?"all":String(b),b=>{o=b,h()});return c("div",{class:"widget"},e.length>1&&f,c("div",{class:"two"},c("div",{},u),
e.length>1&&c("div",{},ft(["pursuers' hands","of-pursuers"],["evaders' hands","of-evaders"]),m.element)),d,Me(n))}function ko({generations:e=30}){let{pursuers:t,
evaders:r}=vt(e,1,Q(pr)),n=t.map(s=>r.map(a=>cr[s][a])),o=n.at(-1);return c("div",{class:"widget"},c("div",{class:"matrices"},se(n,`The last pursuers score ${C(
o.reduce((s,a)=>s+a,0)/o.length)} against all evaders.`)),X("0 loses","1 wins"))}var je=600,Ce=20,hr=5,Oo=10,fr={"Game A":"intransitive","Game B":"scalar","Game C":"focusing"},$o={low:0,high:je,label:"generation",whole:!0},_o={low:0,high:Ge,
label:"ones of side 1"},ie=()=>{},Qa=()=>new Promise(e=>setTimeout(e));async function gr(e,t,r){for(t();e.generation<je&&r();t()){for(let n=0;n<Ce;n++)e.step();
await Qa()}}var wt=new Map,Lo=[];async function ei(){for(let e of Object.keys(fr))wt.set(e,[]);for(let e=0;e<hr;e++)for(let[t,r]of Object.entries(fr)){let n={score:[],
ones:[]};wt.get(t).push(n);let o=new Ee(r,Te,Q(e));await gr(o,()=>{n.score.push(mr(r,o.ones(0),o.ones(1))),n.ones.push(o.objective(0))},()=>!0),Lo.forEach(s=>s())}}
function No({shows:e="score"}){wt.size||ei();let t=e==="score"?{low:0,high:1,label:"score of side 1"}:_o,r=Object.entries(fr).map(([n,o])=>{let s=e==="score"?n:
`${n}: ${o}`,a=J(`${s}: ${t.label} in ${hr} races`,(i,l)=>{let u=Y(i,l,$o,t);for(let d of wt.get(n))Z(u,d[e].map((m,p)=>p*Ce),d[e],"of-both dense");return u},ie,
ie);return Lo.push(a.redraw),c("figure",{},c("figcaption",{},s),a.element)});return c("div",{class:"widget"},c("div",{class:"matrices"},...r),c("p",{class:"smal\
l muted"},`Each line is a race; there are ${hr} of each game, played now, in this page.`))}var ti=[5,10,15,25,40,60],ri=[5e-4,.001,.002,.005,.01,.02,.05],ni=[0,
1,5,15,30],Ro=15,oi=Array.from({length:20},(e,t)=>t);function Io({hall:e=!1}){let[t,r,n]=["scalar",0,{...Te,hall:e?Ro:0}],o=0,s=y=>{n={...n,...y}},a=[[],[]],i=[
se(a[0],"Score of side 1",je/Ce+1),se(a[1],"Score of side 2",je/Ce+1)];i.forEach(y=>y.querySelector("p").replaceChildren(`↑ generation, → opponent (${Ce} a \
cell)`));let l=[[],[]],u=J("Ones of both sides by generation",(y,x)=>{let S=Y(y,x,$o,{..._o,label:"ones"});return l.forEach((M,k)=>Z(S,M.map((ce,G)=>G*Ce),M,k?"\
of-evaders":"of-pursuers")),S},ie,ie),d=c("p",{class:"numbers",role:"status"}),m=y=>{d.textContent=y},p=async()=>{let y=++o;for(let M of[...a,...l])M.length=0;let x=[
[],[]],S=new Ee(t,n,Q(r));await gr(S,()=>{for(let M of[0,1])x[M].push(S.ones(M)),l[M].push(S.objective(M));for(let M of[0,1])a[M].push(x[1-M].map(k=>mr(S.game,x[M].
at(-1),k)));i.forEach(M=>M.draw?.()),u.redraw()},()=>o===y),o===y&&m(`${Po(S.game)} game, seed ${r}: after ${je} generations side 1 has ${l[0].at(-1).toFixed(0)}\
 ones, side 2 ${l[1].at(-1).toFixed(0)}.`)},h=[],v=J("Ones of side 1 at the end of ten races, a row for each choice of settings",(y,x)=>si(h,y,x),ie,ie);v.element.
classList.add("dots");let f=async y=>{let x=++o,S=[],{population:M,mutation:k}=y,ce=`${t}${M===Te.population?"":`, ${M} players`}${k===Te.mutation?"":`, mutatio\
n ${k}`}, hall ${y.hall}`;h.push({text:ce,ends:S}),h.length>yr&&h.shift();for(let G=0;G<Oo&&o===x;G++){let j=new Ee(t,y,Q(G));await gr(j,ie,()=>o===x),o===x&&S.
push(j.objective(0)),v.redraw()}o===x&&m(`${Po(ce)}: side 1 ends with ${Fo(S)} ones in the mean of ${Oo} races.`)},b=(y,x,S="")=>c("button",{type:"button",class:S,
onclick:()=>{y()}},x),A=c("div",{class:"sliders"},xo("game",Object.keys(bt),y=>t=y),ae("population",ti,n.population,String,y=>s({population:y})),ae("mutation",ri,
n.mutation,String,y=>s({mutation:y})),...e?[ae("hall of fame",ni,Ro,String,y=>s({hall:y}))]:[ae("seed",oi,0,String,y=>r=y)]);return e?(f(Te).then(()=>o===1?f(n):
void 0),c("div",{class:"widget"},A,c("div",{class:"buttons"},b(()=>f(n),"Play ten races","primary")),d,v.element)):c("div",{class:"widget"},A,c("div",{class:"bu\
ttons"},b(p,"Play a race","primary"),b(async()=>{o++},"Stop")),c("div",{class:"matrices"},...i,c("figure",{},c("figcaption",{},"The truth: ones"),ft(["side 1","\
of-pursuers"],["side 2","of-evaders"]),u.element)),X("0 loses","1 wins"),d)}var yr=6,Fo=e=>(e.reduce((t,r)=>t+r,0)/e.length).toFixed(1),Po=e=>e.charAt(0).toUpperCase()+
e.slice(1);function si(e,t,r){let n=Y(t,r,{low:0,high:Ge,label:"ones of side 1 at the end",whole:!0},{low:0,high:yr,label:""});return n.root.querySelectorAll(".\
axes .grid, .axes [text-anchor=end]").forEach(o=>o.remove()),e.forEach(({text:o,ends:s},a)=>{let i=n.y(yr-a-.7);n.marks.before(g("text",{class:"label",x:n.left,
y:i-12},s.length?`${o}: mean ${Fo(s)}`:o)),s.forEach(l=>n.marks.before(g("circle",{class:"dot of-both",cx:n.x(l),cy:i,r:5})))}),n}function ai(e,t,r){return{rows:e.rows,cols:e.cols,nPursuers:e.n_pursuers,fov:e.fov,interaction:e.rules.interaction,obstacles:t,moments:r}}function St(e){let t=Array.from({length:e.length+1},(r,n)=>ii(e,n));return ai(e.config,e.map,t)}function ii(e,t){let r=e.n_agents,n=e.config.n_evaders,o=(a,i,l)=>a.
subarray(i*l,(i+1)*l),s={positions:o(e.last_positions,t,2*r),alive:o(e.alive,t,r),captured:o(e.captured,t,n),everCaptured:o(e.ever_captured,t,n)};return t===0?s:
{...s,actions:o(e.actions,t-1,r),involved:o(e.involved,t-1,3*r),fault:o(e.fault,t-1,3*r),get contested(){return e.conflicts(t).map(a=>a.cell)}}}var li=Array.from({length:16},(e,t)=>{let[r,n]=[t%2?6.5:11,Math.PI*t/8];return`${12+r*Math.sin(n)} ${12-r*Math.cos(n)}`}).join(" ");function Mt(){let e=[["pursu\
er",g("path",{d:"M12 3 22 20H2z",class:"filled-pursuer"})],["evader",g("circle",{cx:12,cy:12,r:9,class:"filled-evader"})],["capture",g("polygon",{points:li,class:"\
filled-capture"})],["captured evader",g("circle",{cx:12,cy:12,r:7.5,class:"ring-evader"})],["conflict",g("rect",{x:3,y:3,width:18,height:18,class:"dashed-confli\
ct"})]];return c("ul",{class:"shapes small","aria-label":"Shapes on the board"},...e.map(([t,r])=>c("li",{},g("svg",{viewBox:"0 0 24 24","aria-hidden":"true"},r),
t)))}function zo(e,t,...r){return c("section",{class:"card panel","aria-label":e},c("header",{},c("h2",{},e),c("p",{class:"small muted"},t)),...r)}var ci={present:"●",absent:"○","cannot tell":"?"};function Do(e){let{findings:t}=e;if(!t?.table.length)return null;let[,...r]=t.table,n=r.map(([s,a,i,l],u)=>{
let d=ui(t.reasons[u]??"");return c("li",{class:`finding ${a.replace(" ","-")}`},c("span",{class:"sign","aria-hidden":"true"},ci[a]??""),c("div",{},c("p",{},c("\
strong",{},s),` ${a}`,c("span",{class:"muted"},` · ${l}`)),d?c("p",{class:"small"},`${d}.`):null,c("p",{class:"small muted numbers"},i)))}),o=zo("What happened",
"Each condition is present, absent, or its 95 % interval cannot tell. The intervals are about this run.",c("p",{class:"headline"},t.headline),...t.numbers.map(s=>c(
"p",{class:"numbers"},`${Uo(s)}.`)),c("ul",{class:"findings"},...n),e.limits?c("p",{class:"small"},e.limits):null);return o.classList.add("diagnosis"),{element:o}}
function ui(e){let[,t=""]=e.split(/, because (.*)/s);return Uo(t.replace(/\.$/,""))}var Uo=e=>e.charAt(0).toUpperCase()+e.slice(1);var di=40,At=class{element;#e;#n=c("div",{class:"episodes",role:"group","aria-label":"Episodes of this cell"});#t=c("p",{class:"check small numbers","aria-live":"\
polite"});constructor(t){this.#e=t,this.element=c("div",{class:"strip-of-episodes"},this.#n,this.#t)}show(t,r){let{pursuer:n,evader:o,episode:s,seed:a}=this.#e.
selected,i=be(t,n,o);this.#n.replaceChildren(...(i?.rates??[]).slice(0,di).map((p,h)=>this.#o(p,h)));let l=a===null?i?.rates[s]:void 0,u=r.statistics.capture_rate,
d=l!==void 0&&Math.abs(u-l)<1e-6&&r.length===i?.lengths[s],m=i?"Not an episode of the evaluation":"The evaluation played no episodes of this pair.";this.#t.dataset.
equal=String(d),this.#t.textContent=d?"As in the evaluation":l===void 0?m:`Episode ${s+1} differs from the evaluation.`,this.#t.title=`Played here: capture rate\
 ${C(u,3)} in ${r.length} steps.${i?` The cell says ${C(i.rate,3)}.`:""}`}#o(t,r){let{selected:n}=this.#e,o=c("span",{class:"bar"});return o.style.height=`${Math.
round(100*t)}%`,c("button",{type:"button",class:"episode",title:`Episode ${r+1}: capture rate ${C(t)}`,"aria-label":`Episode ${r+1}, capture rate ${C(t)}`,"aria\
-pressed":String(r===n.episode&&n.seed===null),onclick:()=>this.#e.select({episode:r,seed:null})},o,c("span",{class:"count"},r+1))}};var Et=["stay","north","east","south","west","northeast","southeast","southwest","northwest"];var Ho=0,Wo=1,mi=2,pi=176;function Go(e,t,r,n){let o=devicePixelRatio||1,s=dt(e);e.width=e.height=pi*o;let a=e.getContext("2d");if(!a)return;let{fov:i}=t,l=e.width/
i;a.fillStyle=s.paper,a.fillRect(0,0,e.width,e.height);for(let d=0;r&&d<i*i;d++){let[m,p]=[(d%i+.5)*l,(Math.floor(d/i)+.5)*l],h=f=>!!r[f*i*i+d];h(mi)&&(a.fillStyle=
s.obstacle,a.fillRect(m-l/2,p-l/2,l,l));let v=h(Ho)&&h(Wo)?l*.18:0;h(Ho)&&Bo(a,ne,m+v,p+v,l*.74,s.evader),h(Wo)&&Bo(a,ut,m-v,p-v,l*.86,s.pursuer)}a.strokeStyle=
n<t.n_pursuers?s.pursuer:s.evader,a.lineWidth=2*o;let u=Math.floor(i/2)*l;a.strokeRect(u,u,l,l)}function Bo(e,t,r,n,o,s){t(e,r,n,o),e.fillStyle=s,e.fill()}var jo="What it remembers: a number for each unit, from -1 to 1",Tt=class{element;#e;#n=c("canvas",{class:"seen",role:"img"});#t=c("h3");#o=c("p",{class:"small \
muted"});#s=c("div",{class:"answers"});#r=c("div",{title:jo});#l=null;#d=null;#u=null;#p=null;#c=null;#a=null;#m=0;constructor(t){this.#e=t,this.element=c("div",
{class:"inspector","data-open":"false"},c("p",{class:"hint small muted"},"Click an agent, or press A: what it sees, and what its network answers."),c("div",{class:"\
inspected"},this.#n,c("div",{class:"answer"},this.#t,this.#o,this.#r),this.#s))}get agent(){return this.#a}show(t,r,n,o){this.#l?.free(),this.#l=t.world(r.world),
this.#u!==r&&(this.#d=null,this.#a!==null&&this.choose(null)),[this.#u,this.#p,this.#c]=[r,n,o]}set solution(t){this.#d=t,this.at(this.#m)}choose(t){this.#a=t,this.
element.dataset.open=String(t!==null),this.#e(t),this.at(this.#m)}next(t){let r=this.#p;if(!r)return;let n=this.#a??(t>0?-1:0);for(let o=0;o<r.n_agents;o++)if(n=
(n+t+r.n_agents)%r.n_agents,r.alive[this.#m*r.n_agents+n])return this.choose(n)}at(t){this.#m=t;let[r,n,o,s,a]=[this.#p,this.#l,this.#u,this.#c,this.#a];if(!r||
!n||!o||!s||a===null)return;let i=a<r.config.n_pursuers?"pursuer":"evader";this.#r.replaceChildren(),this.#t.replaceChildren(c("span",{class:i},D(a,r.config.n_pursuers)));
let l={pursuers:B(o,"pursuer",s.pursuer),evaders:B(o,"evader",s.evader)};r.seek(n,t,l);let u=r.actions.subarray(t*r.n_agents,(t+1)*r.n_agents);for(;u.length&&!n.
over&&(a<n.actors[0]||a>=n.actors[1]);)n.playTurn(u);let d=!!(r.alive[t*r.n_agents+a]&&n.read("alive")[a]);Go(this.#n,r.config,d?n.view(a):null,a),this.#n.ariaLabel=
`Field of view of ${D(a,r.config.n_pursuers)}: evaders, pursuers and obstacles around it`;let m=u[a]??null;if(!d)return this.#h([],"It is gone.");let p=l[`${i}s`],
h=typeof p=="string"?null:n.answer(p,a),v=h?.probabilities??null;h?.memory.length&&this.#r.replaceChildren(c("p",{class:"small muted"},"It remembers:"),gi(h.memory));
let f=this.#d?.game(n)??null,b=typeof p=="string"?`The script "${p}" plays for it${m===null?"":`; it goes ${Et[m]}`}.`:p.sampled?"Its action is drawn from these\
 probabilities.":"It takes the most probable action.",A=[["network",v],["perfect",f?.marginal(a)??null]],y=et(r.config),x=S=>c("p",{class:"small muted"},S);this.#h(
[...f?[x(`Value ${f.value.toFixed(2)} under perfect play.`)]:[],...hi(A,m),...y?[x(`Perfect play is not known: ${y}.`)]:[]],m===null?"The episode is over.":b)}#h(t,r){
this.#s.replaceChildren(...t),this.#o.textContent=r}};function hi(e,t){let r=e.filter(([,s])=>s);if(!r.length)return[];let n=c("div",{class:"action muted"},c("s\
pan"),...r.map(([s])=>c("span",{class:"head"},s))),o=Array.from(r[0][1],(s,a)=>c("div",{class:a===t?"action taken":"action"},c("span",{},Et[a]),...r.flatMap(([,
i])=>fi(i[a]))));return r.length>1||r[0][0]!==e[0][0]?[n,...o]:o}function fi(e){let t=c("span",{class:"filled"});return t.style.width=`${100*e}%`,[c("span",{class:"\
track"},t),c("span",{class:"numbers"},e.toFixed(2))]}function gi(e){let t=Array.from(e,r=>{let n=c("span",{title:r.toFixed(2)});return n.style.transform=`scaleY\
(${r})`,n});return c("div",{class:"units",role:"img","aria-label":jo},...t)}function Ct(e,t,{pursuer:r,evader:n,episode:o,seed:s}){let a=t.seeds[r][n];return e.match(t.world,B(t,"pursuer",r),B(t,"evader",n),BigInt(s??a),o)}function Vo(e){let t=JSON.stringify(e,(r,n)=>r==="genome"?Array.from(n):n);return c("script",{type:"application/json",id:"champions"},t.replaceAll("<","\\u003c")).
outerHTML}var qo="champion",Ko=0,vr=64,br=100;var yi=(e,t)=>Object.keys(e).every(r=>e[r]===t[r]);function Yo(e,t){return Object.keys(t).find(r=>yi(t[r],e))??null}var Ve="_",vi="n",Bu=2n**64n-1n;var xr={fov:11,maxSteps:500,rewards:"paper"},bi=["rules","others","rewards","size","diagonal","fov","limit","seed","ended","walls","pursuers","evaders","played",
"next"];function Xo(e,t){let r=i=>i.map(l=>wi(l,t)).join(""),n=i=>`${Math.floor(i/e.cols)}.${i%e.cols}`,o=xi(e.rewards,t),s=[e.seed,e.episode,e.steps].join("."),a={rules:Jo(
e.rules,t),others:e.others?Jo(e.others,t):"",rewards:o===xr.rewards?"":o,size:`${e.rows}x${e.cols}`,diagonal:e.diagonal?"1":"",fov:e.fov===xr.fov?"":String(e.fov),
limit:e.maxSteps===xr.maxSteps?"":String(e.maxSteps),seed:s==="0.0.0"?"":s,ended:e.ended?"1":"",walls:e.walls.map(n).join(Ve),pursuers:e.pursuers.map(Zo).join(Ve),
evaders:e.evaders.map(Zo).join(Ve),played:e.played.map(r).join(Ve),next:e.next.every(i=>i===Ko)?"":r(e.next)};return bi.filter(i=>a[i]).map(i=>`${i}=${a[i]}`).join(
"&")}function Zo({cell:e,gone:t,captured:r,everCaptured:n}){let o=r?"c":n?"e":"";return`${e[0]}.${e[1]}${o}${t?"x":""}`}function Jo(e,t){let r=t.fields.map(({name:n})=>String(
e[n]).toLowerCase());return Yo(e,t.variants)??r.join(".")}function xi(e,t){let r=JSON.stringify(e);return Object.keys(t.rewards).find(o=>JSON.stringify(t.rewards[o])===
r)??Object.values(e).map(o=>String(o)).join(Ve)}function wi(e,t){if(typeof e=="number")return String(e);if(e===qo)return vi;let r=t.scripts.findIndex(({name:n})=>n===
e);return String.fromCharCode(97+r)}var Si="/* the engine */";function Qo(e,t){return c("button",{type:"button",class:"to-playground",title:"Open this step in the playground (G): the same agents a\
nd actions under any rules",onclick:()=>Mi(e(),t)},"What if?")}function Mi(e,t){let r=e!==null&&e.match.n_agents<=br&&Math.max(e.match.config.rows,e.match.config.
cols)<=vr,n=r?Xo(Ai(e.match,e.step),t):"",o=new TextDecoder().decode(Zt("playground")).replace(Si,()=>Fe("script-engine")).replace("</noscript>",s=>r?s+Vo(e.champions):
s);window.open(`${URL.createObjectURL(new Blob([o],{type:"text/html"}))}#${n}`)}function Ai(e,t){let{config:r,n_agents:n}=e,o=Math.max(0,t-1),s=i=>{let l=o*n+i,
u=o*r.n_evaders+i-r.n_pursuers,d=m=>i>=r.n_pursuers&&!!m[u];return{cell:[e.last_positions[2*l],e.last_positions[2*l+1]],gone:!e.alive[l],captured:d(e.captured),
everCaptured:d(e.ever_captured)}},a=Array.from({length:n},(i,l)=>s(l));return{rules:r.rules,others:null,rewards:r.rewards,rows:r.rows,cols:r.cols,diagonal:r.diagonal,
fov:r.fov,maxSteps:r.max_steps,seed:e.seed,episode:BigInt(e.episode),steps:o,ended:o===e.length,walls:Array.from(e.map.keys()).filter(i=>e.map[i]),pursuers:a.slice(
0,r.n_pursuers),evaders:a.slice(r.n_pursuers),played:[],next:Array.from(e.actions.subarray(o*n,(o+1)*n))}}var Ei=.005,Ti=.05,Ci=["pursuer","evader"],ki=4,ke=new Map;function ts(e,t,r="capture-rate"){let n=JSON.stringify([{...t,rewards:null,fov:null},r]),o=ke.get(n)??
(et(t)?Promise.resolve(null):Oi(e,t,r));return ke.delete(n),ke.set(n,o),ke.size>ki&&ke.delete([...ke.keys()][0]),o}var es=()=>new Promise(e=>setTimeout(e));async function Oi(e,t,r){await es();let n=e.solution(t,r);for(;n.goBack();)await es();return n}function rs(e,t,r){let{payoff:n}=e;
return r.flatMap((o,s)=>{let a=[0,0];for(let l=t.n_turns;l>0&&!t.over;l--)e.game(t)?.lost(o).forEach((u,d)=>a[d]+=u),t.playTurn(o);let i=n==="capture-rate"?Ei:Ti;
return Ci.map((l,u)=>({step:s+1,team:l,lost:a[u],payoff:n})).filter(l=>l.lost>=i)})}var ns=e=>e.map(t=>({step:t.step,kind:t.team,size:t.lost/Math.max(1,...e.map(
({lost:r})=>r)),text:wr(t)})),Ri=({lost:e,payoff:t})=>t==="capture-rate"?`${e.toFixed(2)} of the capture rate`:`${e.toFixed(1)} steps`,wr=e=>`The ${e.team}s los\
e ${Ri(e)} against a perfect opponent`;function os(e,t,r){if(r===0)return[{kind:"start",text:Pi(e),agents:[]}];let[n,o]=[t.moments[r-1],t.moments[r]],s=d=>D(d,e.config.n_pursuers),a=De(t,n,o),i=e.conflicts(
r),l=new Set(i.flatMap(d=>d.doomed)),u=a.map(d=>({kind:"capture",text:`${s(d)} is captured`,agents:[d]}));for(let d of lt(n,o))!a.includes(d)&&!l.has(d)&&u.push(
{kind:"end",text:`${s(d)} disappears`,agents:[d]});return u.push(...i.map(({kind:d,text:m,agents:p})=>({kind:d,text:m,agents:p}))),r===e.length&&u.unshift({kind:"\
end",text:$i(e),agents:[]}),u}function Pi({config:e}){return`${e.n_pursuers} pursuers and ${e.n_evaders} evaders on ${e.rows} x ${e.cols} cells, at most ${e.max_steps}\
 steps`}function $i(e){let t=Math.round(e.statistics.capture_rate*e.config.n_evaders);return`The episode ends after ${e.length} steps with ${t} of ${e.config.n_evaders}\
 evaders captured`}var _i=60,kt=class{element;player=new K(0,{speed:mt,still:oe()});inspector;match=null;recording=null;actions;#e;#n;#t;#o;#s=c("h2",{class:"match-title"});#r=c("\
p",{class:"tally numbers"});#l=c("ol",{class:"words",tabindex:0,"aria-live":"off","aria-label":"What happened in this step"});#d=c("p",{class:"problem",role:"al\
ert"});#u=null;#p=null;#c=0;#a=!1;#m=0;#h=[];constructor(t,r,n){[this.#n,this.#t]=[t,r];let o=c("canvas",{"aria-label":"The match"});this.#e=new Se(o,{numbers:!1}),
this.#o=new At(r),this.inspector=new Tt(s=>this.#b(s)),o.addEventListener("click",s=>this.inspector.choose(this.#e.agentAt(s.clientX,s.clientY))),this.actions=c(
"div",{class:"beside"},c("button",{type:"button",class:"to-play",title:"Move the chosen agent, or an evader, yourself from this step on (T)",onclick:()=>this.element.
dispatchEvent(new Event("takeover"))},"Take over"),Qo(()=>this.shown,n)),this.element=c("section",{class:"card match-card","aria-label":"Match",id:"match"},c("d\
iv",{class:"match"},c("header",{class:"match-head"},this.#s,this.#r),this.#d,c("div",{class:"stage"},o),c("div",{class:"aside"},this.#l,Mt(),this.actions,this.inspector.
element),Me(this.player),this.#o.element)),this.player.addEventListener("frame",()=>this.recording&&this.#e.show(this.recording,this.player.time)),this.player.addEventListener(
"step",()=>this.#v()),r.on("match",()=>this.#x()),r.on("rest",()=>this.player.pause()),this.#y(),this.#S(0,0)}get#i(){return this.#n[this.#t.selected.run]}reveal(){
this.#e.canvas.scrollIntoView({block:"nearest"})}get shown(){return this.match&&this.#p&&{match:this.match,step:this.player.step,champions:this.#p}}start(t){this.#u=
t,this.#g()}playSoon(){this.#a=!0,this.#c||this.#f()}goTo(t){this.#m=t,!this.#c&&this.match&&this.#g()}#f(){!this.#a||!this.match||(this.#a=!1,this.player.jump(
0),oe()||this.player.play())}#x(){this.#y(),clearTimeout(this.#c),this.#c=setTimeout(()=>this.#g(),_i)}#g(){clearTimeout(this.#c),this.#c=0,this.player.pause(),
this.#y();let{selected:t}=this.#t,r=yn.map(s=>vn(this.#i,s,t[s])).find(Boolean)??"";if(this.#d.textContent=r,r||!this.#u)return;this.match=Ct(this.#u,this.#i,t);
let[n,o]=this.names(t);this.#p={pursuer:{name:n,policy:B(this.#i,"pursuer",t.pursuer)},evader:{name:o,policy:B(this.#i,"evader",t.evader)}},this.recording=St(this.
match),this.#o.show(this.#i,this.match),this.inspector.show(this.#u,this.#i,this.match,t),this.player.length=this.match.length,this.player.marks=it(this.recording),
this.#h=this.player.ticks=[],this.player.jump(this.#m),this.#m=0,this.#v(),this.#w(this.#u,this.match),this.element.dataset.played=`${t.run} ${t.pursuer} ${t.evader}\
 ${t.episode} ${t.seed??""}`,this.#f()}async#w(t,r){let n=await ts(t,r.config);if(this.match!==r||!n)return;let o=t.world(r.config);r.seek(o,0),this.#h=rs(n,o,Li(
r)),o.free(),this.player.ticks=ns(this.#h),this.inspector.solution=n,this.#v()}names({run:t,pursuer:r,evader:n}){let{teams:o}=this.#n[t];return[o.pursuer.script??
`pursuers ${r}`,o.evader.script??`evaders ${n}`]}#y(){let{episode:t,seed:r}=this.#t.selected,{payoff:n}=this.#i,[o,s]=this.names(this.#t.selected),a=r===null?t<
n.episodes?`episode ${t+1} of ${n.episodes}`:`episode ${t+1}, not part of the cell`:`seed ${r}`;this.#s.replaceChildren(c("span",{class:"pursuer"},o)," against ",
c("span",{class:"evader"},s),c("span",{class:"muted small"},a))}#v(){let t=this.match;if(!t||!this.recording)return;let r=this.player.step,n=this.recording.moments[r];
this.#S(Array.from(n.everCaptured).filter(Boolean).length,r),this.#l.replaceChildren(...this.#h.filter(o=>o.step===r).map(o=>c("li",{class:`loss-${o.team}`},wr(
o))),...os(t,this.recording,r).map(o=>c("li",{class:o.kind,"data-agents":o.agents.join(" ")},o.text))),this.inspector.at(r),this.#M()}#S(t,r){this.#r.replaceChildren(
c("strong",{},t),` of ${this.#i.world.n_evaders} captured`,c("span",{class:"muted"},` · step ${r}`))}#b(t){this.#e.look={selected:t,viewers:t===null?[]:[t]},this.#M()}#M(){
let t=this.inspector.agent;for(let r of this.#l.children){let n=r.dataset.agents?.split(" ")??[];r.classList.toggle("about",t!==null&&n.includes(String(t)))}}},
Li=({actions:e,length:t,n_agents:r})=>Array.from({length:t},(n,o)=>e.subarray(o*r,(o+1)*r));var Ni={ArrowUp:[1,0],ArrowDown:[-1,0],ArrowRight:[0,1],ArrowLeft:[0,-1]},Ii=5;function as(e,t,r,n="pursuer"){e.tabIndex=0,e.setAttribute("role","application"),
e.addEventListener("keydown",o=>{let s=Ni[o.key];if(!s)return;let[a,i]=n==="pursuer"?s:[s[1],s[0]],[l,u]=r(),d=o.shiftKey?Ii:1,{pursuer:m,evader:p}=t.selected;t.
select({pursuer:ss(m+d*a,l),evader:ss(p+d*i,u)}),o.preventDefault(),o.stopPropagation()})}var ss=(e,t)=>Math.min(t-1,Math.max(0,e));var Fi=24,Ot=7,ls=e=>e<Fi&&matchMedia("(pointer: coarse)").matches;function cs(e,t,r,n){let[o,s]=e.payoff.shape,[a,i]=[is(t,o),is(r,s)],[l,u]=[Math.min(Ot,o),Math.
min(Ot,s)],d=[];for(let v=a+l-1;v>=a;v--){d.push(c("span",{class:"pursuer"},v));for(let f=i;f<i+u;f++)d.push(zi(e,v,f,n))}let m=Array.from({length:u},(v,f)=>c("\
span",{class:"evader"},i+f)),p=c("button",{type:"button","aria-label":"Close: all cells",onclick:()=>n(null)},"✕"),h=c("div",{class:"loupe numbers",role:"grou\
p","aria-label":"Cells around the tap"},...d,p,...m);return h.style.gridTemplateColumns=`2.4rem repeat(${u}, minmax(0, 1fr))`,h.addEventListener("click",v=>v.stopPropagation()),
h}function zi(e,t,r,n){let o=be(e,t,r)?.rate,s=c("button",{type:"button","aria-label":`${C(o)}: pursuers ${t} against evaders ${r}`,onclick:()=>n({pursuer:t,evader:r})},
C(o));return o!==void 0&&([s.style.backgroundColor,s.style.color]=[nt(o),rt(o)]),s}var is=(e,t)=>Math.max(0,Math.min(t-Ot,e-Math.floor(Ot/2)));var _={left:52,bottom:46,top:76,right:84},U=10,Di=160,qe=_.right-U-14,le=_.top-U-14,Rt=class{element;#e;#n;#t=c("canvas",{"aria-hidden":"true"});#o=g("svg",{"ar\
ia-hidden":"true"});#s=g("g");#r;#l=c("h2");#d=c("strong",{class:"rate numbers"});#u=c("span",{class:"small muted"});#p=c("p",{class:"of-both-teams small muted \
numbers"});#c=null;constructor(t,r){[this.#n,this.#e]=[t,r],this.#r=c("div",{class:"matrix",id:"matrix","aria-label":"Payoff matrix. Arrow keys choose a match, \
Enter plays it."},this.#t,this.#o);let n=c("header",{class:"readout","aria-live":"polite"},c("div",{},this.#l,this.#p),c("div",{class:"of-cell"},this.#d,this.#u));
this.element=c("section",{class:"card matrix-card","aria-label":"Payoff matrix"},n,this.#r,X("0 all escape","1 all caught")),this.#x(),new ResizeObserver(()=>this.#m()).
observe(this.#r),this.#r.addEventListener("pointermove",o=>this.#y(o)),this.#r.addEventListener("pointerleave",()=>r.point({})),this.#r.addEventListener("click",
o=>this.#v(o)),this.#r.addEventListener("mousedown",o=>{o.preventDefault(),document.activeElement instanceof HTMLElement&&document.activeElement.blur()}),as(this.#r,
r,()=>this.#a.payoff.shape),this.#r.addEventListener("keydown",o=>{o.key==="Enter"&&this.#b()}),r.on("run",()=>this.#m()),r.on("match",()=>this.#f()),r.on("hove\
r",()=>this.#f())}get#a(){return this.#n[this.#e.selected.run]}#m(){let[t,r]=this.#a.payoff.shape,{clientWidth:n,clientHeight:o}=this.#r;if(n<50)return;let a=Math.
max(Di,Math.min(n-_.left-_.right,o-_.top-_.bottom))/Math.max(t,r),i=Math.max(_.left,(n-r*a-_.right+_.left)/2),l=_.top+Math.max(0,(o-_.top-_.bottom-t*a)/2),u={width:n,
height:o,left:i,top:l,cell:a,rows:t,columns:r};this.#c=u,Ae(this.#t,this.#a.payoff,{left:i,top:l,width:r*a,height:t*a}),this.#o.setAttribute("viewBox",`0 0 ${n}\
 ${o}`),this.#o.replaceChildren(Ui(u),...Hi(u),...this.#i(u),this.#s),this.#f()}#h(t){let r=this.#a.findings?.generalization;if(!r)return[];let{selected:n,hover:o}=this.#e,
[s,a]=[o.pursuer??n.pursuer,o.evader??n.evader],[i,l]=us(t,r.pursuers.mean[s]??0,s),[u,d]=ds(t,r.evaders.mean[a]??0,a);return[g("circle",{class:"dot of-pursuers",
cx:i,cy:l,r:5}),g("circle",{class:"dot of-evaders",cx:u,cy:d,r:5})]}#i(t){let r=this.#a.findings?.generalization;if(!r)return[];let{left:n,top:o,cell:s,rows:a,columns:i}=t,
[l,u]=[n+i*s+U,o-U],d={class:"side"};return[g("rect",{...d,x:l,y:o,width:qe,height:a*s}),g("rect",{...d,x:n,y:u-le,width:i*s,height:le}),...ms(r.pursuers,(m,p)=>us(
t,m,p),"of-pursuers"),...ms(r.evaders,(m,p)=>ds(t,m,p),"of-evaders"),g("text",{class:"tick",x:l,y:o+a*s+16,"text-anchor":"start"},"0"),g("text",{class:"tick",x:l+
qe,y:o+a*s+16,"text-anchor":"end"},"1"),g("text",{class:"tick",x:n-6,y:u-4,"text-anchor":"end"},"0"),g("text",{class:"tick",x:n-6,y:u-le+8,"text-anchor":"end"},
"1"),g("text",{class:"label of-pursuers",x:l+qe,y:o+a*s+34,"text-anchor":"end"},"captures"),g("text",{class:"label of-evaders",x:n+i*s+U,y:u-le+10,"text-anchor":"\
start"},"escapes")]}#f(){let t=this.#c;if(!t)return;let{selected:r,hover:n}=this.#e,{left:o,top:s,cell:a,rows:i,columns:l}=t,u=v=>s+(i-1-v)*a,d=[],m=(v,f)=>g("r\
ect",{class:f,x:o,y:u(v),width:l*a+U+qe,height:a}),p=(v,f)=>g("rect",{class:f,x:o+v*a,y:s-U-le,width:a,height:U+le+i*a});d.push(m(r.pursuer,"strip pursuer"),p(r.
evader,"strip evader")),n.pursuer!==null&&n.pursuer<i&&d.push(m(n.pursuer,"strip hover")),n.evader!==null&&n.evader<l&&d.push(p(n.evader,"strip hover")),d.push(
...this.#h(t));let h={x:o+r.evader*a,y:u(r.pursuer),width:a,height:a};d.push(g("rect",{class:"chosen under",...h}),g("rect",{class:"chosen",...h})),this.#s.replaceChildren(
...d),this.#x()}#x(){let{selected:t,hover:r}=this.#e,n=r.pursuer??t.pursuer,o=r.evader??t.evader,s=be(this.#a,n,o);this.#l.replaceChildren(c("span",{class:"purs\
uer"},`Pursuers ${n}`)," against ",c("span",{class:"evader"},`evaders ${o}`)),this.#d.textContent=s?C(s.rate,3):"-",this.#u.textContent=s?`capture rate, mean of\
 ${s.rates.length} episodes`:"the evaluation played no episodes",this.#p.textContent=this.#g(n,o)}#g(t,r){let n=this.#a.findings?.generalization;if(!n)return"";
let o=(s,a)=>uo(s.mean[a]??0,s.low?.[a]??null,s.high?.[a]??null);return`Against all: captures ${o(n.pursuers,t)}, escapes ${o(n.evaders,r)}`}#w(t){let r=this.#c;
if(!r)return null;let n=this.#r.getBoundingClientRect(),o=Math.floor((t.clientX-n.left-r.left)/r.cell),s=r.rows-1-Math.floor((t.clientY-n.top-r.top)/r.cell),[a,
i]=[s>=0&&s<r.rows,o>=0&&o<r.columns];return a||i?{g:a?s:-1,h:i?o:-1,inside:a&&i}:null}#y(t){let r=this.#w(t);this.#e.point(r?{pursuer:r.g<0?null:r.g,evader:r.h<
0?null:r.h}:{})}#v(t){let r=this.#w(t);if(r){if(r.inside&&ls(this.#c.cell))return this.#S(r.g,r.h);this.#e.select({...r.g<0?{}:{pursuer:r.g},...r.h<0?{}:{evader:r.
h}}),r.inside&&this.#b()}}#S(t,r){let n=cs(this.#a,t,r,o=>{n.remove(),o&&(this.#e.select(o),this.#b())});this.#r.append(n)}#b(){this.#r.dispatchEvent(new CustomEvent(
"play",{bubbles:!0}))}};function Ui({left:e,top:t,cell:r,rows:n,columns:o}){let s=g("g",{class:"axes"}),a=t+n*r,i=l=>Be(0,l-1,Math.min(l,l*r/44),!0);for(let l of i(
o))s.append(g("text",{class:"tick",x:e+(l+.5)*r,y:a+16,"text-anchor":"middle"},l));for(let l of i(n))s.append(g("text",{class:"tick",x:e-7,y:a-(l+.5)*r,"text-an\
chor":"end","dominant-baseline":"middle"},l));return s.append(g("text",{class:"label of-evaders",x:e+o*r/2,y:a+36,"text-anchor":"middle"},"evader generation"),g(
"text",{class:"label of-pursuers",transform:`translate(${e-36} ${t+n*r/2}) rotate(-90)`,"text-anchor":"middle"},"pursuer generation")),s}function Hi({left:e,top:t,
cell:r,rows:n,columns:o}){let s=g("g",{class:"diagonal"}),a=Math.min(n,o);if(a<3)return[];let i=t+n*r;for(let d of["H","V"]){let m=`M${e} ${i}`;for(let p=1;p<=a;p++){
let[h,v]=[`H${e+p*r}`,`V${i-p*r}`];m+=d==="H"?h+v:v+h}s.append(g("path",{d:m,class:"under"}),g("path",{d:m}))}let[l,u]=[e+a/2*r-.7*r-4,i-a/2*r-.7*r-4];return[s,
g("text",{class:"on-cells",transform:`translate(${l} ${u}) rotate(-45)`,"text-anchor":"middle"},"same generation")]}var us=({left:e,top:t,cell:r,rows:n,columns:o},s,a)=>[
e+o*r+U+s*qe,t+(n-a-.5)*r],ds=({left:e,top:t,cell:r},n,o)=>[e+(o+.5)*r,t-U-n*le];function ms(e,t,r){let n=s=>s.map((a,i)=>t(a??0,i).map(l=>l.toFixed(1)).join(" ")),
o=[];return e.low&&e.high&&o.push(g("path",{class:`band ${r}`,d:`M${[...n(e.high),...n(e.low).reverse()].join("L")}Z`})),o.push(g("path",{class:`line ${r}`,d:`M${n(
e.mean).join("L")}`})),o}var Wi=84;function ps(e,t){let r=e.map((s,a)=>Bi(s,a,t)),n=c("nav",{class:"races","aria-label":"Runs"},...r.map(s=>s.button)),o=()=>r.forEach((s,a)=>s.update(a===
t.selected.run));return t.on("match",o),t.on("hover",o),o(),n.hidden=e.length<2,n}function Bi(e,t,r){let[n,o]=e.payoff.shape,s=!e.name.startsWith(e.schedule),a=Wi/
Math.max(n,o),i=c("canvas",{"aria-hidden":"true"});Ae(i,e.payoff,{left:0,top:0,width:o*a,height:n*a});let l=c("span",{class:"place"}),u=c("button",{type:"button",
class:"race",title:`${e.name} (key ${t+1})`,onclick:()=>ji(e,t,r)},c("span",{class:"small-matrix"},i,l),c("span",{class:"race-text"},c("strong",{},s?e.name:e.schedule),
c("span",{class:"small"},e.findings?e.findings.headline:`${e.learning.join(" and ")}s against ${Gi(e)}`),c("span",{class:"small muted"},`${s?`${e.schedule}, `:""}\
seed ${e.seed}`)));return{button:u,update:m=>{u.setAttribute("aria-current",String(m));let p=r.hover.pursuer??r.selected.pursuer,h=r.hover.evader??r.selected.evader;
l.hidden=p>=n||h>=o,l.style.left=`${(h+.5)*a}px`,l.style.top=`${(n-p-.5)*a}px`}}}var Gi=e=>e.teams.pursuer.script??e.teams.evader.script??"another run";function ji(e,t,r){
let[n,o]=e.payoff.shape,{pursuer:s,evader:a}=r.selected;r.select({run:t,pursuer:Math.min(s,n-1),evader:Math.min(a,o-1)})}var hs={pursuer:null,evader:null},Pt=class extends EventTarget{#e;#n=hs;constructor(t){super(),this.#e=t}get selected(){return this.#e}get hover(){return this.#n}select(t){
let r=this.#e,n=["run","pursuer","evader"].some(o=>o in t&&t[o]!==r[o]);this.#e={...r,...n?{episode:0,seed:null}:{},...t},this.#e.run!==r.run&&this.dispatchEvent(
new Event("run")),this.dispatchEvent(new Event("match"))}point(t){let r={...hs,...t};r.pursuer===this.#n.pursuer&&r.evader===this.#n.evader||(this.#n=r,this.dispatchEvent(
new Event("hover")))}on(t,r){this.addEventListener(t,r)}};var fs=1,Vi=8;function gs({runs:e},t){let r=e[fs],[n,o]=r.payoff.shape,s=new K(0,{speed:Vi,still:oe()}),a=c("canvas",{"aria-label":"The chase"}),i=c("p",{class:"\
numbers"}),l=new Se(a,{numbers:!1});return t.then(u=>{let d=Ct(u,r,{run:fs,pursuer:n-1,evader:o-1,episode:0,seed:null}),m=St(d);s.addEventListener("frame",()=>l.
show(m,s.time)),s.addEventListener("step",()=>{let p=Array.from(m.moments[s.step].everCaptured).filter(Boolean).length;i.textContent=`Step ${s.step}: ${p} of ${r.
world.n_evaders} evaders captured`}),s.length=d.length,s.marks=it(m),s.jump(0)}),c("div",{class:"widget chase"},c("div",{class:"stage"},a),i,Me(s),Mt())}function ys({
runs:e,playground:t},r){let n=e[0].payoff.shape.map(u=>u-1),o=new Pt({run:0,pursuer:n[0],evader:n[1],episode:0,seed:null}),[s,a]=[new kt(e,o,t),new Rt(e,o)];s.actions.
remove(),a.element.addEventListener("play",()=>{s.playSoon(),s.reveal()}),r.then(u=>s.start(u));let{seed:i,world:l}=e[0];return c("div",{class:"widget wide"},ps(
e,o),c("div",{class:"stages"},a.element,s.element),c("p",{class:"small muted"},"Three races of ",c("code",{},`matrixworld evolve --seed ${i}`),`: ${l.n_pursuers}\
 pursuers and ${l.n_evaders} evaders on ${l.rows} x ${l.cols} cells.`))}function vs({runs:e}){let[t,r]=[e[0],e[0].findings],[n,...o]=r.table,s=o.findIndex(([i,,
,l])=>i==="arms race"&&l==="last half"),a={headline:t.name,numbers:[],table:[n,o[s]],reasons:[r.reasons[s]]};return c("div",{class:"widget text"},Do({...t,findings:{
...r,...a}}).element)}var bs="matrixworld lesson",Sr={choices:[],solved:{},exit:"",done:!1},$t=class extends EventTarget{#e;keeps=!0;constructor(){super(),this.#e=this.#n(),this.#t({})}choice=t=>this.#e.
choices.find(({prediction:r})=>r===t)?.choice;choose(t,r){let n=new Date().toISOString().replace(/\.\d+Z$/,"+00:00");this.#t({choices:[...this.#e.choices,{prediction:t,
choice:r,time:n}]}),this.dispatchEvent(new CustomEvent("choice",{detail:t}))}solved=t=>this.#e.solved[t];solve=(t,r)=>this.#t({solved:{...this.#e.solved,[t]:r}});get exit(){
return this.#e}set exit(t){this.#t(t)}get count(){return this.#e.choices.length}get file(){return this.#e.choices.map(t=>`${JSON.stringify(t)}
`).join("")}forget(){this.#t(Sr)}#n(){try{return{...Sr,...JSON.parse(localStorage.getItem(bs)??"{}")}}catch{return Sr}}#t(t){this.#e={...this.#e,...t};try{localStorage.
setItem(bs,JSON.stringify(this.#e))}catch{this.keeps=!1}}};var Ke=e=>e!==void 0&&"predict"in e,qi=e=>"outcome"in e&&!Ke(e),F=xn(),z=new $t,ws=new Map(F.sections.flatMap(({parts:e})=>e.filter(Ke).map(t=>[t.predict,t]))),
Ki={chase:()=>gs(F,xs),flat:bo,hands:Co,"hands-matrix":ko,games:No,numbers:Io,matrices:()=>yo(F),explorer:()=>ys(F,xs),judgement:()=>vs(F),"same-diagonal":vo,exit:e=>Tn(
e,z)},Yi=e=>"widget"in e?e.needs:qi(e)?e.outcome:void 0;function Zi(e){if("text"in e)return c("div",{class:"text"},...Xt(e.text));if("widget"in e)return Ki[e.widget](
e);if("exercise"in e)return En(e,z);if(Ke(e))return An(e,z);let t=ws.get(e.outcome);return c("div",{class:"prediction"},c("p",{},c("strong",{},t.question)),Qt(t,
z.choice(e.outcome)))}function Ji(e,t){let r=c("p",{class:"waiting muted",role:"status"}),n=c("section",{class:"card",id:e.id,"aria-labelledby":`title-${e.id}`},
c("h2",{id:`title-${e.id}`},`${t+1}. ${e.title}`,c("span",{class:"muted small"},`${e.minutes} minutes`)),r),o=0,s=()=>{for(r.textContent="";o<e.parts.length;o++){
let[a,i]=[e.parts[o-1],e.parts[o]],l=[Ke(a)?a.predict:void 0,Yi(i)].find(u=>u&&z.choice(u)===void 0);if(l){let u=F.sections.findIndex(({parts:d})=>d.some(m=>Ke(
m)&&m.predict===l));r.textContent=`This section goes on with your prediction${u===t?"":` in section ${u+1}`}.`;return}r.before(Zi(i))}r.remove()};return z.addEventListener(
"choice",s),s(),n}var Ss=()=>{},xs=new Promise(e=>Ss=e),Ms=c("span",{class:"small muted",role:"status"}),As=()=>{Ms.textContent=`${z.count} of ${ws.size} predic\
tions made. `+(z.keeps?"They stay in this browser.":"This browser keeps nothing: save before you close the page.")};z.addEventListener("choice",As);var Xi=()=>{
confirm("Delete all predictions and answers in this browser, for another student? Save them first.")&&(z.forget(),location.reload())};document.getElementById("p\
age").replaceWith(c("header",{class:"top"},c("div",{},c("h1",{},F.title),c("p",{class:"lead"},F.lead)),c("div",{class:"tools"},an())),c("nav",{class:"sections",
"aria-label":"Sections"},...F.sections.map((e,t)=>c("a",{href:`#${e.id}`},`${t+1}. ${e.title}`))),c("main",{},...F.sections.map(Ji)),c("footer",{class:"card"},c(
"div",{class:"buttons"},c("button",{type:"button",class:"primary save",onclick:()=>er("predictions.jsonl",z.file)},"Save my predictions"),c("button",{type:"butt\
on",onclick:()=>print()},"Print"),c("button",{type:"button",onclick:Xi},"Start anew"),Ms),c("p",{class:"small muted"},`The page sends nothing anywhere. matrixwo\
rld ${F.version}`)));As();requestAnimationFrame(()=>setTimeout(()=>{on().then(Ss,e=>{document.querySelector("main").prepend(c("p",{class:"card problem",role:"al\
ert"},`The engine does not start here: ${String(e)}`))}).finally(()=>document.body.dataset.ready="true")}));})();
