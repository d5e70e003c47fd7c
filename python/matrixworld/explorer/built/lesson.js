/* built from web/ by "npm run build"; sources 3711280ab2b0f4245f4ed3c261f1d58edc6debabaf122c4b6951510ac39d2996 */
"use strict";(()=>{var _r={SIMULTANEOUS:0,SWARM_TURNS:1,AGENT_TURNS:2},$e={DISAPPEAR:0,REACH:1,BOUNCE:2},Lr={OCCUPATION:0,SURROUND:1},Nr={FAULT:0,INVOLVED:1};var Ir=["obstacle","teammate","adversary"],zt=["vertex","edge","chain"],Fr=["turn","kind","form","first","second","row","col","at_fault","held","doomed"],Ht=["p\
ursuer_{number}","evader_{number}"],zr={obstacle:"{first} ran into the obstacle or border at {cell}",vertex:"{first} and {second} both headed for {cell}",edge:"\
{first} and {second} meant to swap, {first} to {cell}",chain:"{first} headed for {cell}, where {second} had to stay"},Pe={"both held":"both bounce","both doomed":"\
both disappear",held:"{agent} bounces",doomed:"{agent} disappears",none:"nobody is stopped"},Hr="{event}: {outcome}",Dt={random:"any action, all equally likely",
still:"always stays",chaser:"moves to where the nearest adversary in view is nearest",fleer:"moves to where the nearest adversary in view is farthest","clumsy-c\
haser":"a chaser that takes any action in half of the steps",hunter:"a chaser of the nearest adversary in view to which no teammate in view is nearer",surrounder:"\
a chaser of the nearest free cell beside an adversary without a teammate","clumsy-fleer":"a fleer that takes any action in half of the steps",dodger:"moves to w\
here all adversaries in view together are farthest"},Dr={free:".GS",blocked:"#@OTW"};var pe=1+Fr.length;function _e(e,t){return e.replace(/\{(\w+)\}/g,(r,n)=>String(t[n]))}function H(e,t){return e<t?_e(Ht[0],{number:e}):_e(Ht[1],{number:e-t})}function Ps(e,t){
let[r,n,o,s,a,i,c,...u]=Array.from(e),d=a<0?[s]:[s,a],[m,p,h]=u.map(A=>d.filter((y,x)=>A>>x&1)),v=d.map(A=>H(A,t)),g=_e(zr[a<0?"obstacle":zt[o]],{first:v[0],second:v[v.
length-1],cell:`(${i}, ${c})`}),b=_e(Hr,{event:g,outcome:_s(d.length,p,h,t)});return{kind:Ir[n],form:zt[o],agents:d,cell:[i,c],at_fault:m,held:p,doomed:h,turn:r,
text:b}}function _s(e,t,r,n){if(e===2&&t.length===2)return Pe["both held"];if(e===2&&r.length===2)return Pe["both doomed"];let o=s=>a=>_e(Pe[s],{agent:H(a,n)});
return[...t.map(o("held")),...r.map(o("doomed"))].join(", ")||Pe.none}function Je(e,t){let r=[];for(let n=0;n<e.length;n+=pe)r.push(Ps(e.subarray(n+1,n+pe),t));
return r}var te=class extends Error{name="EngineError"};function E(e,t,r){let n=typeof r=="string"?`'${r}'`:typeof r=="object"?JSON.stringify(r):String(r);return new te(
`${e}: expected ${t}, got ${n}`)}var he=class{bytes;constructor(t){this.bytes=t}},Br=0,Ut=[Uint8Array,Uint8Array,Int32Array,BigInt64Array,BigUint64Array,Float32Array,Float64Array],Wr=4,Ur=4,Ls=new TextEncoder,
Ns=new TextDecoder;function Is(e){for(let t=Ut.length-1;t>Br;--t)if(e instanceof Ut[t])return t;throw new TypeError("array: expected a typed array of the engine\
's numbers, got another")}function Wt(e){return new Uint8Array(e.buffer,e.byteOffset,e.byteLength)}function Fs(e){return Ls.encode(`${e}\0`)}var Bt=class{engine;addresses=[];constructor(t){
this.engine=t}copy(t){let r=this.engine._malloc(Math.max(t.length,1));if(r===0)throw new te("memory: expected room for the arguments, got none");return this.addresses.
push(r),this.engine.HEAPU8.set(t,r),r}text(t){return this.copy(Fs(t))}arrays(t){let r=Object.entries(t),n=r.flatMap(([s,a])=>{let i=a instanceof he,c=i?a.bytes:
a;return[this.text(s),i?Br:Is(c),c.length,this.copy(Wt(c))]}),o=this.copy(Wt(Int32Array.from(n)));return this.copy(Wt(Int32Array.of(r.length,o)))}free(){for(let t of this.
addresses)this.engine._free(t)}};function Gr(e,t){let r=e.HEAPU8;return Ns.decode(r.subarray(t,r.indexOf(0,t)))}function fe(e){let t=new Int32Array(e.HEAPU8.buffer),
r=e._last_outputs()/Wr,n=t[r+1]/Wr,o={};for(let s=n;s<n+t[r]*Ur;s+=Ur){let a=Ut[t[s+1]],i=t[s+2]*a.BYTES_PER_ELEMENT,c=t[s+3];o[Gr(e,t[s])]=new a(e.HEAPU8.slice(
c,c+i).buffer)}return o}function K(e,t){let r=new Bt(e);try{let n=t(r);if(n===0)throw new te(Gr(e,e._last_error()));return n}finally{r.free()}}var zs=2**31-1,jr=["none","elman","gru"],Hs=2n**64n-1n,Ds=34028234663852886e22;function U(e,t){if(typeof t!="number"||!Number.isInteger(t)||Math.abs(t)>zs)throw E(
e,"an integer",t);return Int32Array.of(t)}function Xe(e,t){if(typeof t!="boolean")throw E(e,"true or false",t);return new he(Uint8Array.of(Number(t)))}function re(e,t,r){
let n=typeof t=="string"&&Object.hasOwn(r,t)?r[t]:void 0;if(n===void 0)throw E(e,`one of ${Object.keys(r).join(", ")}`,t);return Int32Array.of(n)}function Gt(e,t){
if(typeof t!="number"||!(Math.abs(t)<=Ds))throw E(e,"a finite number",t);return t}function ge(e,t){let n=typeof t=="bigint"||typeof t=="number"&&Number.isSafeInteger(
t)?BigInt(t):-1n;if(n<0n||n>Hs)throw E(e,"an integer from 0 to 2^64 - 1",t);return BigUint64Array.of(n)}function Ws(e){return{"rules.interaction":re("interactio\
n",e.interaction,_r),"rules.obstacle":re("obstacle",e.obstacle,$e),"rules.teammate":re("teammate",e.teammate,$e),"rules.evader":re("evader",e.evader,$e),"rules.\
pursuer":re("pursuer",e.pursuer,$e),"rules.capture":re("capture",e.capture,Lr),"rules.captured_disappear":Xe("captured_disappear",e.captured_disappear)}}function Vr(e,t){
let r=typeof t=="number"?[t,t,t]:t;if(!Array.isArray(r)||r.length!==3)throw E(e,"1 or 3 numbers",t);return Float32Array.from(r,n=>Gt(e,n))}function Us(e){let t=(r,n)=>Float32Array.
of(Gt(r,e[r]),Gt(n,e[n]));return{"rewards.capture":t("pursuer_capture","evader_capture"),"rewards.neighbor":t("pursuer_neighbor","evader_neighbor"),"rewards.ste\
p":t("pursuer_step","evader_step"),"rewards.pursuer_collide":Vr("pursuer_collide",e.pursuer_collide),"rewards.evader_collide":Vr("evader_collide",e.evader_collide),
"rewards.blame":re("blame",e.blame,Nr),"rewards.capture_repeats":Xe("capture_repeats",e.capture_repeats)}}function Kr(e){if(e===void 0||typeof e=="number")return new Uint8Array(
0);if(e instanceof Uint8Array)return e;let{free:t,blocked:r}=Dr;for(let[n,o]of e.entries()){if(o.length!==e[0]?.length)throw E(`map, row ${n}`,`${e[0]?.length} \
cells as in row 0`,o.length);let s=[...o].find(a=>!t.includes(a)&&!r.includes(a));if(s)throw E(`map, row ${n}`,`'${t}' (free) or '${r}' (obstacle)`,s)}return Uint8Array.
from([...e.join("")],n=>Number(r.includes(n)))}function Yr(e,t){if(!Array.isArray(e))return;let r=[e.length,e[0]?.length??0];if(!(r[0]===t.rows&&r[1]===t.cols))
throw E("obstacle map",`shape (${t.rows}, ${t.cols}), the rows and cols`,r)}function ye(e){Yr(e.obstacles,e);let t=typeof e.obstacles=="number"?e.obstacles:0;return{
...Ws(e.rules),...Us(e.rewards),rows:U("rows",e.rows),cols:U("cols",e.cols),n_pursuers:U("n_pursuers",e.n_pursuers),n_evaders:U("n_evaders",e.n_evaders),fov:U("\
fov",e.fov),diagonal:Xe("diagonal",e.diagonal),max_steps:U("max_steps",e.max_steps),density:Float64Array.of(t),map:Kr(e.obstacles)}}function qr(e,t){return Int32Array.
from((t??[]).flat(),r=>U(e,r)[0])}function Zr(e,t){return Yr(e.obstacles,t),{seed:ge("seed",e.seed??0n),episode:ge("episode",e.episode??0),pursuers:qr("pursuers",
e.pursuers),evaders:qr("evaders",e.evaders),map:Kr(e.obstacles)}}function Qe(e){return{actions:Int32Array.from(e,t=>U("actions",t)[0])}}function ve(e){if(typeof e==
"string"){if(!Object.hasOwn(Dt,e))throw E("policy",`one of ${Object.keys(Dt).join(", ")}`,e);return{script:new TextEncoder().encode(e)}}if(e.activation!=="relu"&&
e.activation!=="tanh")throw E("activation","'relu' or 'tanh'",e.activation);if(!jr.includes(e.memory))throw E("memory",`one of ${jr.join(", ")}`,e.memory);return{
hidden:Int32Array.from(e.hidden,t=>U("hidden",t)[0]),activation:new TextEncoder().encode(e.activation),sampled:Xe("sampled",e.sampled),memory:new TextEncoder().
encode(e.memory),genome:e.genome}}var Bs=["first_turn","terminated","truncated"];function Jr(e){let t={...e};for(let r of Bs)t[r]=new he(e[r]);return t}var et=class{config;seed;episode;n_agents;statistics;first_conflict;constructor(t,r,n,o){this.config=t,this.seed=r,this.episode=n,this.n_agents=t.n_pursuers+t.n_evaders,
this.statistics=Xr(o,0),Object.assign(this,o),this.first_conflict=Gs(this.conflict_table,this.length)}get length(){return this.actions.length/this.n_agents}conflicts(t){
this.check(t);let[r,n]=[this.first_conflict[t],this.first_conflict[t+1]],o=this.conflict_table.subarray(r*pe,n*pe);return Je(o,this.config.n_pursuers)}seek(t,r,n){
this.check(r),(!(t.seed===this.seed&&t.episode===BigInt(this.episode))||t.turn!==0||t.steps>r)&&t.reset({seed:this.seed,episode:this.episode});for(let s=t.steps;s<
r;++s){let a=this.actions.subarray(s*this.n_agents,(s+1)*this.n_agents);n?t.replay(a,{pursuer:n.pursuers,evader:n.evaders}):t.step(a)}}check(t){if(!(Number.isInteger(
t)&&t>=0&&t<=this.length))throw E("step",`0 to ${this.length}`,t)}};function Gs(e,t){let r=new Int32Array(t+2);for(let n=0;n<e.length;n+=pe)++r[e[n]+1];for(let n=1;n<
r.length;++n)r[n]+=r[n-1];return r}function Xr(e,t){let r=e["statistics.length"].length,n=s=>{let a=e[`statistics.${s}`],i=a.length/r;return a.slice(t*i,(t+1)*i)},
o=s=>Number(n(s)[0]);return{capture_rate:o("capture_rate"),ever_capture_rate:o("ever_capture_rate"),captured_fraction:o("captured_fraction"),length:o("length"),
return:n("return"),survivors:n("survivors"),overlap:n("overlap"),collisions:n("collisions"),faults:n("faults"),agent_steps:n("agent_steps")}}function Qr(e,t,r,n){
let o=[ye(r.config),ve(r.pursuers),ve(r.evaders),n];return K(e,s=>{let[a,i,c,u]=o.map(d=>s.arrays(d));return e[t](a,i,c,u)}),fe(e)}function en(e,t,r,n){let o={seed:ge(
"seed",r),episode:ge("episode",n)};return new et(t.config,r,n,Qr(e,"_play_match",t,o))}function tn(e,t,r,n){if(!Number.isInteger(n)||n<1)throw E("n_episodes","a\
t least 1",n);let o={seed:ge("seed",r),n_episodes:Int32Array.of(n)},s=Qr(e,"_play_rollout",t,o);return Array.from({length:n},(a,i)=>Xr(s,i))}var js=7e6,Vs=new FinalizationRegistry(([e,t])=>e._states_free(t));function qs({rules:e,rows:t,cols:r,obstacles:n,diagonal:o,n_pursuers:s,n_evaders:a}){let i=typeof n==
"number"||e.obstacle==="REACH"?0:n.join("").split("#").length-1,c=t*r-i,u=[e.obstacle,e.teammate,e.pursuer].includes("DISAPPEAR"),d=e.capture==="SURROUND"||e.evader===
"REACH",m=e.interaction==="AGENT_TURNS",p=(g,b)=>Array.from({length:b},(A,y)=>m?g:(g+y)/(y+1)).reduce((A,y)=>A*y,1),h=p(c+Number(u),s)*p(c*(1+Number(d))+2,a);return{
SIMULTANEOUS:[s+a],SWARM_TURNS:[s,a],AGENT_TURNS:Array(s+a).fill(1)}[e.interaction].reduce((g,b)=>g+h*(o?9:5)**b,0)}function tt(e){return typeof e.obstacles=="n\
umber"&&e.obstacles>0?"obstacles are drawn anew in each episode":qs(e)>js?"the world is too large to be solved on the page":""}var jt=class{value;teams;matrix;n_actions;constructor(t,r){
let{matrix:n,rows:o,cols:s,value:a,agents:i}=r,[c,u]=t.actors,d=Array.from(i).filter(p=>c<=p&&p<u),m=p=>p<t.config.n_pursuers;[this.value,this.matrix,this.n_actions]=
[a[0],n,t.n_actions],this.teams=[{agents:d.filter(m),play:o},{agents:d.filter(p=>!m(p)),play:s}]}marginal(t){let r=this.teams.find(({agents:s})=>s.includes(t));
if(!r)return null;let n=this.n_actions**(r.agents.length-1-r.agents.indexOf(t)),o=Array(this.n_actions).fill(0);return r.play.forEach((s,a)=>o[Math.floor(a/n)%this.
n_actions]+=s),o}lost(t){let[r,n]=this.teams.map(({agents:c})=>c.reduce((u,d)=>u*this.n_actions+t[d],0)),[o,s]=this.teams.map(({play:c})=>c),a=s.reduce((c,u,d)=>c+
u*this.matrix[r*s.length+d],0),i=o.reduce((c,u,d)=>c+u*this.matrix[d*s.length+n],0);return[Math.max(0,this.value-a),Math.max(0,i-this.value)]}},rn=60,Le=class{config;payoff;engine;states;n_turns;values;constructor(t,r,n){
[this.engine,this.config,this.payoff]=[t,r,n],this.states=K(t,a=>t._states_new(a.arrays(ye(r)))),Vs.register(this,[t,this.states]);let o={SIMULTANEOUS:1,SWARM_TURNS:2,
AGENT_TURNS:r.n_pursuers+r.n_evaders};this.n_turns=o[r.rules.interaction];let s=this.call(()=>t._states_payoffs(this.states)).payoffs;this.values=[[n==="capture\
-rate"?s:s.fill(0)]]}goBack(){let t=this.values.at(-1)[0],r=[];for(let o=this.n_turns-1;o>=0;o--){let s=r[o+1]??t;r[o]=this.call(a=>this.engine._states_backup(this.
states,o,a.arrays({next:s}))).values}this.payoff==="capture-time"&&(r[0]=r[0].map((o,s)=>s===this.config.n_evaders?0:o-1)),this.values.push(r);let n=this.payoff===
"capture-rate"?this.config.max_steps:Math.min(this.config.max_steps,rn);return this.values.length<=n&&r[0].some((o,s)=>o!==t[s])}game(t){let[r,{turn:n}]=[this.config.
max_steps-t.steps,t],o=n+1===this.n_turns,s=r>0?this.values[Math.min(r-Number(o),this.values.length-1)]?.[o?0:n+1]:void 0;if(!s)return null;let a=this.call(i=>this.
engine._states_game(this.states,t.address,i.arrays({next:s})));return a.agents.length?new jt(t,a):null}call(t){return K(this.engine,t),fe(this.engine)}};var nn=new FinalizationRegistry(([e,t])=>e._world_free(t)),Ne=class{config;n_agents;n_actions;engine;at;freed=!1;constructor(t,r){this.engine=t,this.config=r,this.
n_agents=r.n_pursuers+r.n_evaders,this.n_actions=r.diagonal?9:5,this.at=K(t,n=>t._world_new(n.arrays(ye(r)))),nn.register(this,[t,this.at],this)}free(){this.freed||
(this.freed=!0,nn.unregister(this),this.engine._world_free(this.at))}get address(){if(this.freed)throw E("world","one that is in use","one that was freed");return this.
at}reset(t={}){let r=Zr(t,this.config);this.call(n=>this.engine._world_reset(this.address,n.arrays(r)))}step(t){let r=Qe(t);this.call(n=>this.engine._world_step(
this.address,n.arrays(r)))}playTurn(t){let r=Qe(t);this.call(n=>this.engine._world_play_turn(this.address,n.arrays(r)))}decide(t,r,n){let{n_pursuers:o}=this.config,
s={pursuer:[0,o],evader:[o,this.n_agents]},[a,i]=typeof r=="string"?s[r]:r;if(n.length!==this.n_agents)throw E("actions",String(this.n_agents),n.length);let c=[
ve(t),Qe(n)],{actions:u}=this.call(d=>this.engine._world_decide(this.address,d.arrays(c[0]),a,i,d.arrays(c[1])));return Uint8Array.from(u)}replay(t,r){let n=s=>typeof s!=
"string"&&s.memory!=="none";if(!n(r.pursuer)&&!n(r.evader))return this.step(t);let{n_pursuers:o}=this.config;for(let s=this.n_turns;s>0;--s){let[a,i]=this.actors;
a<o&&this.decide(r.pursuer,[a,Math.min(i,o)],t),i>o&&this.decide(r.evader,[Math.max(a,o),i],t),this.playTurn(t)}}get n_turns(){return this.turnNumbers()[1]}get turn(){
return this.turnNumbers()[0]}get actors(){let[,,t,r]=this.turnNumbers();return[t,r]}turnNumbers(){return this.call(()=>this.engine._world_turn(this.address)).turn}get steps(){
return this.read("steps")[0]}get seed(){return this.read("seed")[0]}get episode(){return this.read("episode")[0]}get over(){return this.read("terminated")[0]===
1||this.read("truncated")[0]===1}read(t){return this.call(r=>this.engine._world_read(this.address,r.text(t)))[t]}view(t){let r=3*this.config.fov**2;return this.
read("views").slice(t*r,(t+1)*r)}map(){return this.read("state").slice(2*this.config.rows*this.config.cols)}conflicts(){return Je(this.conflictTable(),this.config.
n_pursuers)}conflictTable(){return this.call(()=>this.engine._world_conflicts(this.address)).conflict_table}answer(t,r){let n=ve(t),{logits:o,memory:s}=this.call(
c=>this.engine._world_logits(this.address,c.arrays(n),r)),a=o,i=this.decide(t,[r,r+1],new Uint8Array(this.n_agents))[r];return{logits:a,probabilities:Ks(a),action:i,
memory:s}}snapshot(){return this.call(()=>this.engine._world_snapshot(this.address))}restore(t){let r=Jr(t);this.call(n=>this.engine._world_restore(this.address,
n.arrays(r)))}call(t){return K(this.engine,t),fe(this.engine)}};function Ks(e){let t=Math.max(...e),r=Array.from(e,o=>Math.exp(o-t)),n=r.reduce((o,s)=>o+s,0);return Float32Array.
from(r,o=>o/n)}var Vt=class{compiled;constructor(t){this.compiled=t}world(t){return new Ne(this.compiled,t)}solution(t,r="capture-rate"){return new Le(this.compiled,t,r)}match(t,r,n,o,s=0){
return en(this.compiled,{config:t,pursuers:r,evaders:n},o,s)}rollout(t,r,n,o,s){return tn(this.compiled,{config:t,pursuers:r,evaders:n},o,s)}},on;function sn(e=globalThis.
matrixworldEngine){return on??=Ys(e),on}async function Ys(e){if(!e)throw new Error("matrixworldEngine: expected the script engine.js before this one, got none");
let t=Uint8Array.from(atob(e.binary),r=>r.charCodeAt(0));return new Vt(await e({wasmBinary:t}))}var Zs="http://www.w3.org/2000/svg";function l(e,t={},...r){return an(document.createElement(e),t,r)}function f(e,t={},...r){return an(document.createElementNS(
Zs,e),t,r)}function an(e,t,r){for(let[n,o]of Object.entries(t))o==null||o===!1||(typeof o=="function"?e.addEventListener(n.slice(2),o):e.setAttribute(n,o===!0?"":
String(o)));return e.append(...r.filter(Js).map(n=>typeof n=="number"?String(n):n)),e}function Js(e){return e!=null&&e!==!1}var Xs=matchMedia("(prefers-color-scheme: dark)");function Qs(){let e=document.documentElement.dataset.theme;return e?e==="dark":Xs.matches}function ea(){document.
documentElement.dataset.theme=Qs()?"light":"dark"}function ln(){return l("button",{type:"button",title:"Light or dark (D)","aria-label":"Light or dark",onclick:ea},
"◐")}var R=Uint8Array,be=Uint16Array,ta=Int32Array,cn=new R([0,0,0,0,0,0,0,0,1,1,1,1,2,2,2,2,3,3,3,3,4,4,4,4,5,5,5,5,0,0,0,0]),un=new R([0,0,0,0,1,1,2,2,3,3,4,4,5,5,
6,6,7,7,8,8,9,9,10,10,11,11,12,12,13,13,0,0]),ra=new R([16,17,18,0,8,7,9,6,10,5,11,4,12,3,13,2,14,1,15]),dn=function(e,t){for(var r=new be(31),n=0;n<31;++n)r[n]=
t+=1<<e[n-1];for(var o=new ta(r[30]),n=1;n<30;++n)for(var s=r[n];s<r[n+1];++s)o[s]=s-r[n]<<5|n;return{b:r,r:o}},mn=dn(cn,2),pn=mn.b,na=mn.r;pn[28]=258,na[258]=28;
var hn=dn(un,0),oa=hn.b,Dl=hn.r,Yt=new be(32768);for(w=0;w<32768;++w)B=(w&43690)>>1|(w&21845)<<1,B=(B&52428)>>2|(B&13107)<<2,B=(B&61680)>>4|(B&3855)<<4,Yt[w]=((B&
65280)>>8|(B&255)<<8)>>1;var B,w,Ie=(function(e,t,r){for(var n=e.length,o=0,s=new be(t);o<n;++o)e[o]&&++s[e[o]-1];var a=new be(t);for(o=1;o<t;++o)a[o]=a[o-1]+s[o-
1]<<1;var i;if(r){i=new be(1<<t);var c=15-t;for(o=0;o<n;++o)if(e[o])for(var u=o<<4|e[o],d=t-e[o],m=a[e[o]-1]++<<d,p=m|(1<<d)-1;m<=p;++m)i[Yt[m]>>c]=u}else for(i=
new be(n),o=0;o<n;++o)e[o]&&(i[o]=Yt[a[e[o]-1]++]>>15-e[o]);return i}),Fe=new R(288);for(w=0;w<144;++w)Fe[w]=8;var w;for(w=144;w<256;++w)Fe[w]=9;var w;for(w=256;w<
280;++w)Fe[w]=7;var w;for(w=280;w<288;++w)Fe[w]=8;var w,fn=new R(32);for(w=0;w<32;++w)fn[w]=5;var w;var sa=Ie(Fe,9,1);var aa=Ie(fn,5,1),qt=function(e){for(var t=e[0],r=1;r<e.length;++r)e[r]>t&&(t=e[r]);return t},L=function(e,t,r){var n=t/8|0;return(e[n]|e[n+1]<<8)>>(t&7)&r},Kt=function(e,t){
var r=t/8|0;return(e[r]|e[r+1]<<8|e[r+2]<<16)>>(t&7)},ia=function(e){return(e+7)/8|0},la=function(e,t,r){return(t==null||t<0)&&(t=0),(r==null||r>e.length)&&(r=e.
length),new R(e.subarray(t,r))};var ca=["unexpected EOF","invalid block type","invalid length/literal","invalid distance","stream finished","no stream handler",,"no callback","invalid UTF-8 da\
ta","extra field too long","date not in range 1980-2099","filename too long","stream finishing","invalid zip data"],N=function(e,t,r){var n=new Error(t||ca[e]);
if(n.code=e,Error.captureStackTrace&&Error.captureStackTrace(n,N),!r)throw n;return n},ua=function(e,t,r,n){var o=e.length,s=n?n.length:0;if(!o||t.f&&!t.l)return r||
new R(0);var a=!r,i=a||t.i!=2,c=t.i;a&&(r=new R(o*3));var u=function(Rr){var $r=r.length;if(Rr>$r){var Pr=new R(Math.max($r*2,Rr));Pr.set(r),r=Pr}},d=t.f||0,m=t.
p||0,p=t.b||0,h=t.l,v=t.d,g=t.m,b=t.n,A=o*8;do{if(!h){d=L(e,m,1);var y=L(e,m+1,3);if(m+=3,y)if(y==1)h=sa,v=aa,g=9,b=5;else if(y==2){var k=L(e,m,31)+257,ue=L(e,m+
10,15)+4,j=k+L(e,m+5,31)+1;m+=14;for(var V=new R(j),Lt=new R(19),O=0;O<ue;++O)Lt[ra[O]]=L(e,m+O*3,7);m+=ue*3;for(var Ar=qt(Lt),Cs=(1<<Ar)-1,ks=Ie(Lt,Ar,1),O=0;O<
j;){var Er=ks[L(e,m,Cs)];m+=Er&15;var x=Er>>4;if(x<16)V[O++]=x;else{var de=0,Ze=0;for(x==16?(Ze=3+L(e,m,3),m+=2,de=V[O-1]):x==17?(Ze=3+L(e,m,7),m+=3):x==18&&(Ze=
11+L(e,m,127),m+=7);Ze--;)V[O++]=de}}var Tr=V.subarray(0,k),q=V.subarray(k);g=qt(Tr),b=qt(q),h=Ie(Tr,g,1),v=Ie(q,b,1)}else N(1);else{var x=ia(m)+4,S=e[x-4]|e[x-
3]<<8,M=x+S;if(M>o){c&&N(0);break}i&&u(p+S),r.set(e.subarray(x,M),p),t.b=p+=S,t.p=m=M*8,t.f=d;continue}if(m>A){c&&N(0);break}}i&&u(p+131072);for(var Os=(1<<g)-1,
Rs=(1<<b)-1,Nt=m;;Nt=m){var de=h[Kt(e,m)&Os],me=de>>4;if(m+=de&15,m>A){c&&N(0);break}if(de||N(2),me<256)r[p++]=me;else if(me==256){Nt=m,h=null;break}else{var Cr=me-
254;if(me>264){var O=me-257,Re=cn[O];Cr=L(e,m,(1<<Re)-1)+pn[O],m+=Re}var It=v[Kt(e,m)&Rs],Ft=It>>4;It||N(3),m+=It&15;var q=oa[Ft];if(Ft>3){var Re=un[Ft];q+=Kt(e,
m)&(1<<Re)-1,m+=Re}if(m>A){c&&N(0);break}i&&u(p+131072);var kr=p+Cr;if(p<q){var Or=s-q,$s=Math.min(q,kr);for(Or+p<0&&N(3);p<$s;++p)r[p]=n[Or+p]}for(;p<kr;++p)r[p]=
r[p-q]}}t.l=h,t.p=Nt,t.b=p,t.f=d,h&&(d=1,t.m=g,t.d=v,t.n=b)}while(!d);return p!=r.length&&a?la(r,0,p):r.subarray(0,p)};var da=new R(0);var ma=function(e,t){return((e[0]&15)!=8||e[0]>>4>7||(e[0]<<8|e[1])%31)&&N(6,"invalid zlib data"),(e[1]>>5&1)==+!t&&N(6,"invalid zlib data: "+(e[1]&32?"need":"u\
nexpected")+" dictionary"),(e[1]>>3&4)+2};function gn(e,t){return ua(e.subarray(ma(e,t&&t.dictionary),-4),{i:2},t&&t.out,t&&t.dictionary)}var pa=typeof TextDecoder<"u"&&new TextDecoder,ha=0;try{pa.decode(da,{stream:!0}),ha=1}catch{}var vn=["pursuer","evader"];function xe(e,t,r){let[n,o]=[t-e.payoff.first[0],r-e.payoff.first[1]],s=e.payoff.capture_rate[n]?.[o];return s===void 0?null:{rate:s,rates:e.payoff.capture_rates[n][o],
lengths:e.payoff.lengths[n][o]}}function bn(e,t,r){let{script:n,network:o,kept:s,genomes:a}=e.teams[t];if(n!==null||o===null)return"";if(!s.includes(r))return`T\
he page holds no genome of ${t}s ${r}: it would be too large. Choose a generation of ${s.join(", ")}.`;let i=s.length*o.genome_size;return xn(a,o.genome_size).length===
i?"":`The page is damaged: it does not hold the ${i} numbers of the ${t}s' genomes. Write it again from its run.`}function G(e,t,r){let{script:n,network:o,kept:s,
genomes:a}=e.teams[t];if(n!==null||o===null)return n??"random";let i=s.indexOf(r);if(i<0)throw new RangeError(`${t}: expected a generation whose genome the page\
 holds, got ${r}`);let c=o.genome_size,u=xn(a,c).subarray(i*c,(i+1)*c),{hidden:d,activation:m,sampled:p,memory:h}=o;return{hidden:d,activation:m,sampled:p,memory:h,
genome:u}}var Zt=4,yn=new Map;function xn(e,t){let r=yn.get(e);if(r)return r;let n=new Float32Array;try{let o=ga(Jt(e),t);o.every(Number.isFinite)&&(n=o)}catch(o){
if(!(o instanceof DOMException||o instanceof RangeError||fa(o)))throw o}return yn.set(e,n),n}var fa=e=>e instanceof Error&&"code"in e;function ga(e,t){let r=gn(
e),n=r.length/Zt,o=new Uint8Array(r.length);for(let a=0;a<o.length;a++)o[a]=r[a%Zt*n+Math.floor(a/Zt)];let s=new Uint32Array(o.buffer);for(let a=t;a<s.length;a++)
s[a]^=s[a-t];return new Float32Array(o.buffer)}function Jt(e){let t=atob(ze(e)),r=new Uint8Array(t.length);for(let n=0;n<r.length;n++)r[n]=t.charCodeAt(n);return r}
function ze(e){return document.getElementById(e)?.textContent??""}var wn=()=>JSON.parse(ze("data"));var He=[[68,1,84],[72,26,108],[71,47,125],[65,68,135],[57,86,140],[49,104,142],[42,120,142],[35,136,142],[31,152,139],[34,168,132],[53,183,121],[84,197,104],[122,
209,81],[165,219,54],[210,226,27],[253,231,37]];function rt(e){let t=Math.min(1,Math.max(0,e))*(He.length-1),r=Math.min(He.length-2,Math.floor(t)),[n,o]=[He[r],
He[r+1]],s=a=>Math.round(n[a]+(t-r)*(o[a]-n[a]));return[s(0),s(1),s(2)]}function nt(e){let[t,r,n]=rt(e).map(o=>((o/255+.055)/1.055)**2.4);return .2126*t+.7152*r+
.0722*n>.179?"#000":"#fff"}var ot=e=>`rgb(${rt(e).join(" ")})`,Sn=()=>`linear-gradient(to right, ${He.map(e=>`rgb(${e.join(" ")})`).join(", ")})`;var An=e=>e.answer===void 0?va():ya(e,e.answer);function ya(e,t){let r=l("input",{type:"text",inputmode:"decimal",size:8,"aria-label":"Your answer, a number",autocomplete:"\
off"});return{input:r,check:()=>{let o=r.value.trim().replace(",","."),s=Number(o);if(o===""||Number.isNaN(s))return"Expected a number, such as 0.5.";let a=i=>Math.
abs(s-i)<=(e.tolerance??0)+1e-9;return a(t)?null:e.clues?.find(([i])=>a(i))?.[1]??e.otherwise??"Expected another number."},answer:()=>r.value,set:o=>r.value=o}}
var I=4,Xt=[.5,.8,.2];function va(){let e=new Array(I*I).fill(.5),t=(c,u)=>{c.textContent=e[u].toFixed(1),c.ariaLabel=`pursuers ${Math.floor(u/I)} against evade\
rs ${u%I}: ${c.textContent}`,[c.style.background,c.style.color]=[ot(e[u]),nt(e[u])]},r=e.map((c,u)=>{let d=l("button",{type:"button",disabled:u%(I+1)===0,onclick:()=>{
e[u]=Xt[(Xt.indexOf(e[u])+1)%Xt.length],t(d,u)}});return t(d,u),d}),n=Array.from({length:I},(c,u)=>u),o=l("div",{class:"cells numbers",role:"group","aria-label":"\
Capture rates: rows are pursuers, columns evaders"},l("span"),...n.map(c=>l("span",{class:"evader"},`evaders ${c}`)),...n.flatMap(c=>[l("span",{class:"pursuer"},
`pursuers ${c}`),...r.slice(c*I,(c+1)*I)])),s=c=>n.map(u=>n.reduce((d,m)=>d+e[c(u,m)],0)/I);return{input:o,check:()=>{let c=s((m,p)=>m*I+p),u=s((m,p)=>p*I+m),d=(m,p)=>m.
every((h,v)=>!v||p*(h-m[v-1])>1e-9);return d(c,1)?d(u,-1)?null:`The means of the columns are ${Mn(u)}. They say how often the evaders are captured, and should f\
all from column to column.`:`The means of the rows are ${Mn(c)}. They are the strengths of the pursuers, and should grow from row to row.`},answer:()=>e.join(" "),
set:c=>{c.split(" ").forEach((u,d)=>e[d]=Number(u)),r.forEach(t)}}}var Mn=e=>e.map(t=>t.toFixed(2)).join(", ");var Qt=e=>e.trim().split(/\n\s*\n/).map(t=>l("p",{},...st(t))),st=e=>e.split("**").map((t,r)=>r%2?l("strong",{},t):document.createTextNode(t));function En(e,t){
let{predict:r,options:n}=e,o=l("p",{class:"small muted",role:"status"}),s=l("button",{type:"submit",class:"primary"},"This is my prediction"),a=Object.keys(n).map(
u=>l("input",{type:"radio",name:`prediction-${r}`,value:u})),i=l("form",{class:"prediction",id:`prediction-${r}`},l("fieldset",{},l("legend",{},l("strong",{},"P\
redict. "),e.question),...a.map(u=>l("label",{class:"option"},u,l("span",{},n[u.value])))),l("div",{class:"buttons"},s,o)),c=()=>{let u=t.choice(r);if(u!==void 0){
for(let d of a)[d.checked,d.disabled]=[d.value===u,!0];s.hidden=s.disabled=!0,o.replaceChildren(),i.append(e.later?l("p",{class:"reply"},e.later):er(e,u))}};return i.
addEventListener("submit",u=>{u.preventDefault();let d=a.find(m=>m.checked);d?(t.choose(r,d.value),c()):o.textContent="Choose one first. Any prediction is a goo\
d one."}),c(),i}function er(e,t){let{options:r,outcome:n}=e,o=t===n;return l("div",{class:"reply",role:"status","data-right":String(o)},l("p",{},l("strong",{},o?
"✓ As you predicted: ":"You predicted: "),r[t]),o?null:l("p",{},l("strong",{},"The outcome: "),r[n]),...Qt(e.explanation),e.note&&l("p",{class:"small muted"},
e.note))}function Tn(e,t){let{input:r,check:n,answer:o,set:s}=An(e),a=l("p",{class:"reply",role:"status",hidden:!0}),i=d=>{a.hidden=!1,a.dataset.right=String(d===
null),a.replaceChildren(l("strong",{},d===null?"✓ Right. ":"✗ Not yet. "),d??e.explanation)},c=l("form",{class:"exercise",id:`exercise-${e.exercise}`},l("di\
v",{class:"text"},l("p",{},l("strong",{},"Exercise. "),...st(e.question))),e.matrix&&ba(e.matrix),l("div",{class:"buttons"},r,l("button",{type:"submit"},"Check")),
a);c.addEventListener("submit",d=>{d.preventDefault();let m=n();m===null&&t.solve(e.exercise,o()),i(m)});let u=t.solved(e.exercise);return u!==void 0&&(s(u),i(null)),
c}function ba(e){let t=e.map((r,n)=>n);return l("div",{class:"wide-table",tabindex:0},l("table",{class:"rates numbers"},l("thead",{},l("tr",{},l("td"),...t.map(
r=>l("th",{scope:"col"},`evaders ${r}`)))),l("tbody",{},...e.map((r,n)=>l("tr",{},l("th",{scope:"row"},`pursuers ${n}`),...r.map(o=>l("td",{},o.toFixed(1))))))))}var xa=40;function tr(e,t){l("a",{href:URL.createObjectURL(new Blob([t],{type:"text/plain"})),download:e}).click()}function Cn({question:e="",points:t=[]},r){let n=l(
"textarea",{id:"exit-answer",rows:8}),o=l("p",{class:"printed"}),s=l("p",{class:"small muted",role:"status"}),a=l("button",{type:"submit",class:"primary"},"I am\
 done"),i=l("form",{class:"exercise"},l("label",{for:"exit-answer"},l("strong",{},"Exit question. "),e),n,o,l("div",{class:"buttons"},a,l("button",{type:"button",
onclick:()=>tr("exit_answer.txt",`${e}

${n.value}
`)},"Save my answer"),s)),c=()=>{o.textContent=r.exit.exit,r.exit.done&&([n.readOnly,a.hidden]=[!0,!0],i.append(l("div",{class:"reply"},l("p",{},l("strong",{},"\
A good answer has:")),l("ul",{},...t.map(u=>l("li",{},...st(u)))))))};return n.value=r.exit.exit,n.addEventListener("input",()=>{r.exit={exit:n.value},o.textContent=
n.value}),i.addEventListener("submit",u=>{if(u.preventDefault(),n.value.trim().length<xa){s.textContent="Write two explanations and an experiment first. Then th\
e page shows what a good answer has.";return}s.textContent="",r.exit={done:!0},c()}),c(),l("div",{class:"widget"},i)}var rr=[[0,0],[-1,0],[0,1],[1,0],[0,-1],[-1,1],[1,1],[1,-1],[-1,-1]];var ne=(e,t)=>t<e.nPursuers,T=(e,t)=>[e.positions[2*t],e.positions[2*t+1]],wa=(e,t)=>e[0]===t[0]&&e[1]===t[1],nr=({rows:e,cols:t},[r,n])=>r>=0&&n>=0&&r<e&&n<t,or=(e,t,r=3)=>e!==
void 0&&[0,1,2].slice(0,r).some(n=>e[3*t+n]),sr=(e,t)=>or(e.fault,t),kn=(e,t)=>!sr(e,t)&&or(e.involved,t,2);function at(e,t,r){let n=!wa(T(e,r),T(t,r)),o=t.involved===
void 0||or(t.involved,r);return!!(t.alive[r]&&t.actions?.[r]&&!n&&o)}function it(e,t,r){let[n,o]=T(e,r),[s,a]=rr[t.actions?.[r]??0];return[n+s,o+a]}function De(e,t,r){
return Array.from({length:r.everCaptured.length},(o,s)=>s).filter(o=>r.everCaptured[o]&&!t.everCaptured[o]).map(o=>e.nPursuers+o)}var lt=e=>e.moments.flatMap((t,r)=>r&&
De(e,e.moments[r-1],t).length?[r]:[]);function ct(e,t){return Array.from({length:t.alive.length},(n,o)=>o).filter(n=>e.alive[n]&&!t.alive[n])}var On=[-.31,0,.31],Rn=[{size:1,at:[[0,0]]},{size:.62,at:[[-.2,.2],[.2,-.2]]},{size:.54,at:[[-.23,.22],[.23,.22],[0,-.22]]},{size:.54,at:[[-.23,.23],[.23,.23],[
-.23,-.23],[.23,-.23]]},{size:.36,at:On.flatMap(e=>On.map(t=>[t,e]))}],Sa=.3,Ma=.35,Aa=.55;function We(e,t){let r=new Map;for(let n=0;n<t.alive.length;n++){if(!t.
alive[n])continue;let[o,s]=T(t,n),a=o*e.cols+s,i=r.get(a);i?i.push(n):r.set(a,[n])}return r}function $n(e,t){let r=Array.from(t.alive,(n,o)=>{let[s,a]=T(t,o);return{
x:a+.5,y:s+.5,size:1,alpha:0}});for(let n of We(e,t).values()){let o=Rn[Math.min(n.length,Rn.length)-1];n.forEach((s,a)=>{let[i,c]=o.at[Math.min(a,o.at.length-1)],
u=r[s];u.x+=i,u.y+=c,u.size=o.size,u.alpha=1})}return r}var Pn=e=>e*e*(3-2*e),we=(e,t,r)=>e+(t-e)*r,_n=e=>Math.min(1,Math.max(0,e));function Ln(e,t,r,n){let o={
SIMULTANEOUS:1,SWARM_TURNS:2,AGENT_TURNS:r}[e.interaction];if(o===1)return Pn(n);let s=o===r?t:+!ne(e,t),a=Math.max(1/o,Ma);return Pn(_n((n-s/(o-1)*(1-a))/a))}function ut(e,t){
let r=e.moments.length-1,n=Math.min(Math.floor(t),r),o=e.moments[n],s=$n(e,o);if(n===r||t===n)return s;let a=e.moments[n+1],i=$n(e,a);return s.map((c,u)=>{let d=Ln(
e,u,s.length,t-n);return Ea(o,a,u,c,i[u],d)})}function ar(e,t,r){let n=e.moments.length-1,o=Math.min(Math.floor(r),n),[s,a]=[e.moments[o],e.moments[Math.min(o+1,
n)]],i=Ln(e,t,s.alive.length,r-o),[[c,u],[d,m]]=[T(s,t),T(a,t)];return[we(u,m,i)+.5,we(c,d,i)+.5]}function Ea(e,t,r,n,o,s){let a=n.alpha>o.alpha,i={x:we(n.x,o.x,
s),y:we(n.y,o.y,s),size:a?n.size:we(n.size,o.size,s),alpha:a?_n((1-s)/(1-Aa)):we(n.alpha,o.alpha,s)};if(at(e,t,r)){let[c,u]=T(e,r),[d,m]=it(e,t,r),p=Sa*Math.sin(
Math.PI*s);i.x+=(m-u)*p,i.y+=(d-c)*p}return i}var Nn=2*Math.PI;function oe(e,t,r,n){e.beginPath(),e.arc(t,r,n/2,0,Nn)}function dt(e,t,r,n){let o=n/2,s=[[0,-.97],[.97,.83],[-.97,.83]].map(([a,i])=>[t+a*o,r+i*
o]);e.beginPath(),e.moveTo((s[2][0]+s[0][0])/2,(s[2][1]+s[0][1])/2),s.forEach(([a,i],c)=>{let[u,d]=s[(c+1)%3];e.arcTo(a,i,u,d,n*.09)}),e.closePath()}function In(e,t,r,n){
let o=n*.32;e.beginPath(),e.moveTo(t-o,r-o),e.lineTo(t+o,r+o),e.moveTo(t+o,r-o),e.lineTo(t-o,r+o)}function Fn(e,t,r,n){e.beginPath();for(let o=0;o<16;o++){let s=n/
2*(o%2?.6:.95),a=Nn*o/16;e.lineTo(t+s*Math.sin(a),r-s*Math.cos(a))}e.closePath()}function zn(e,t,r,n,o,s){let a=Math.atan2(o-r,n-t);e.beginPath(),e.moveTo(t,r),
e.lineTo(n,o);for(let i of[-1,1])e.moveTo(n,o),e.lineTo(n-s*Math.cos(a+i*.6),o-s*Math.sin(a+i*.6))}var Hn=4,Ta=1.6,Ca=.95,ka=5,Oa=.16,Ra=9,$a=.09,Pa=.2,Dn=.75,$=(e,t)=>e.left+t*e.cell,P=(e,t)=>e.top+t*e.cell;function Se(e,t,r){return ne(t,r)?e.colors.pursuer:
e.colors.evader}function Wn({ctx:e,grid:t,colors:r}){let{left:n,top:o,cell:s,rows:a,cols:i}=t,[c,u]=[i*s,a*s];if(e.fillStyle=r.paper,e.fillRect(n,o,c,u),s<ka)return;
e.fillStyle=r.line;let d=Math.max(1,Math.round(s/60));for(let m=1;m<i;m++)e.fillRect(n+m*s,o,d,u);for(let m=1;m<a;m++)e.fillRect(n,o+m*s,c,d)}function Un({ctx:e,
grid:t,colors:r},n){let{left:o,top:s,cell:a,rows:i,cols:c}=t;e.fillStyle=r.obstacle;for(let u=0;u<i*c;u++){if(!n.obstacles[u])continue;let[d,m]=[Math.floor(u/c),
u%c];e.fillRect(o+m*a,s+d*a,a,a)}Bn({ctx:e,grid:t,colors:r})}function Bn({ctx:e,grid:{left:t,top:r,cell:n,rows:o,cols:s},colors:a}){let i=Math.min(5,Math.max(2,
Math.round(n/18)));e.strokeStyle=a.frame,e.lineWidth=i,e.strokeRect(t-i/2,r-i/2,s*n+i,o*n+i)}function Gn({ctx:e,grid:t,colors:r},n){let{left:o,top:s,cell:a,rows:i,
cols:c}=t,u=a<24*n?5:1;e.font=`500 ${Math.round(Math.min(15*n,Math.max(9*n,a*.32)))}px system-ui, sans-serif`,e.fillStyle=r.muted,e.textBaseline="alphabetic",e.
textAlign="center";let d=5*n+a/40;for(let m=0;m<c;m+=u)e.fillText(String(m),o+(m+.5)*a,s-d);e.textAlign="right",e.textBaseline="middle";for(let m=0;m<i;m+=u)e.fillText(
String(m),o-d,s+(m+.5)*a)}function jn({grid:e},t,r,n){let o=Math.floor(t.fov/2)+.5,[s,a]=[Math.max(0,r-o),Math.min(e.cols,r+o)],[i,c]=[Math.max(0,n-o),Math.min(
e.rows,n+o)];return[$(e,s),P(e,i),(a-s)*e.cell,(c-i)*e.cell]}function Vn(e,t,r,n){let{ctx:o,grid:s,colors:a}=e;o.save(),o.beginPath(),o.rect(0,0,o.canvas.width,
o.canvas.height),o.rect(...jn(e,t,r,n)),o.clip("evenodd"),o.clearRect(0,0,o.canvas.width,o.canvas.height),o.fillStyle=a.line,o.fillRect(s.left,s.top,s.cols*s.cell,
s.rows*s.cell),o.restore(),Bn(e)}function qn({ctx:e,grid:t,colors:r},{x:n,y:o,alpha:s},a){let i=Math.max(t.cell,16*a)*1.06,[c,u]=[$(t,n),P(t,o)];e.globalAlpha=Math.
max(s,.6),e.beginPath(),e.roundRect(c-i/2,u-i/2,i,i,i*.2),e.strokeStyle=r.focus,e.lineWidth=Math.max(2,2.5*a),e.stroke();let d=Math.max(11*a,Math.min(18*a,t.cell*
.5));e.font=`700 ${Math.round(d)}px system-ui, sans-serif`,e.textAlign="center",e.textBaseline="middle";let m=u-i/2<d*1.2,p=u+(m?1:-1)*(i/2+d*.7);e.strokeStyle=
r.paper,e.lineJoin="round",e.lineWidth=d*.35,e.strokeText("You",c,p),e.fillStyle=r.ink,e.fillText("You",c,p),e.globalAlpha=1}function Kn(e,t,r,n,o){let{ctx:s,grid:a}=e,
i=jn(e,t,n,o),c=Se(e,t,r);s.globalAlpha=.11,s.fillStyle=c,s.fillRect(...i),s.globalAlpha=.8,s.strokeStyle=c,s.lineWidth=Math.max(1,a.cell/24),s.strokeRect(...i),
s.globalAlpha=1}function Yn(e,t,r,n,o){let{ctx:s,grid:a}=e,i=Math.min(Math.ceil(r),t.moments.length-1),c=t.moments[i];s.lineCap="round",s.lineWidth=Math.min(Ra,
Math.max(1,a.cell*Oa));for(let u=Math.max(1,Math.floor(r-n)+1);u<=i;u++){let[d,m]=[t.moments[u-1],t.moments[u]],p=Math.max(0,Math.min(1,(r-u)/n));s.globalAlpha=
Dn+(Pa-Dn)*p;for(let h=0;h<m.alive.length;h++){let v=u===i&&r<i;if(!d.alive[h]||!(c.alive[h]||v))continue;let g=(ne(t,h)?-1:1)*$a,[b,A]=T(d,h),[y,x]=T(m,h);if(b===
y&&A===x)continue;let S=v?o[h].x:x+.5,M=v?o[h].y:y+.5;s.strokeStyle=Se(e,t,h),s.beginPath(),s.moveTo($(a,A+.5+g),P(a,b+.5+g)),s.lineTo($(a,S+g),P(a,M+g)),s.stroke()}}
s.globalAlpha=1}function Zn(e,t,r){let n=Math.min(Math.ceil(r),t.moments.length-1);for(let o=Math.max(1,n-Hn+1);o<=n;o++){let[s,a]=[t.moments[o-1],t.moments[o]],
i=o>r?Math.max(0,1-2*(o-r)):1-(r-o)/Hn,c=De(t,s,a);for(let u of ct(s,a))c.includes(u)||La(e,T(a,u),i);for(let u of c)_a(e,T(a,u),i)}e.ctx.globalAlpha=1}function _a({
ctx:e,grid:t,colors:r},[n,o],s){e.globalAlpha=s,Fn(e,$(t,o+.5),P(t,n+.5),Math.max(8,t.cell*Ta)),e.fillStyle=r.capture,e.fill(),e.strokeStyle=r.ink,e.lineWidth=Math.
max(1,t.cell/36),e.lineJoin="round",e.stroke()}function La({ctx:e,grid:t,colors:r},[n,o],s){e.globalAlpha=s,In(e,$(t,o+.5),P(t,n+.5),Math.max(7,t.cell*Ca)),e.strokeStyle=
r.collision,e.lineWidth=Math.max(2,t.cell*.17),e.lineCap="round",e.stroke()}function Jn({ctx:e,grid:t,colors:r},n,o){let s=Math.max(1,t.cell*.07);e.strokeStyle=
e.fillStyle=r.collision,e.lineWidth=Math.max(1,t.cell*.05),e.setLineDash([t.cell*.14,t.cell*.1]);for(let[a,i]of n){if(a<0||i<0||a>=t.rows||i>=t.cols)continue;let c=[
$(t,i)+s,P(t,a)+s,t.cell-2*s,t.cell-2*s];e.globalAlpha=.2*o,e.fillRect(...c),e.globalAlpha=o,e.strokeRect(...c)}e.setLineDash([]),e.globalAlpha=1}function Xn({ctx:e,
grid:t,colors:r},n,o,s,a){e.globalAlpha=a,oe(e,$(t,n),P(t,o),Math.max(8,t.cell*s*1.02)),e.strokeStyle=r.collision,e.lineWidth=Math.max(1.5,t.cell*.085*Math.sqrt(
s)),e.stroke(),e.globalAlpha=1}var Na=.8,Ia=.92,Fa=15,za=7,ir=9;function Qn(e,t,r,n,o,s){n.forEach((a,i)=>{a.alpha>0&&Ha(e,t,r,i,a,o,s)}),e.ctx.globalAlpha=1;for(let a of We(t,r).values())a.length>
ir&&Da(e,n[a[ir-1]],a.length-ir+1)}function Ha(e,t,r,n,o,s,a){let{ctx:i,grid:c,colors:u}=e,d=ne(t,n),[m,p]=[c.left+o.x*c.cell,c.top+o.y*c.cell],h=Math.max(4,c.cell*
o.size*(d?Ia:Na)),v=Se(e,t,n),g=!d&&!!r.captured[n-t.nPursuers];if(i.globalAlpha=o.alpha,(d?dt:oe)(i,m,p,h),h>za*a&&(i.strokeStyle=u.paper,i.lineWidth=Math.max(
2,h*.1),i.stroke()),i.fillStyle=g?u.paper:v,i.fill(),g&&(oe(i,m,p,h*.82),i.strokeStyle=v,i.lineWidth=h*.18,i.stroke()),!s||h<Fa*a)return;let b=String(d?n:n-t.nPursuers);
i.font=`700 ${Math.round(h*(d?.4:.5)*(b.length>1?.8:1))}px system-ui, sans-serif`,i.textAlign="center",i.textBaseline="middle",i.fillStyle=g?v:u.paper,i.fillText(
b,m,p+h*(d?.17:.03))}function Da({ctx:e,grid:t,colors:r},n,o){let[s,a]=[t.left+n.x*t.cell,t.top+n.y*t.cell];e.font=`700 ${Math.round(t.cell*.3)}px system-ui, sa\
ns-serif`,e.textAlign="center",e.textBaseline="middle",e.strokeStyle=r.paper,e.lineWidth=t.cell*.1,e.strokeText(`+${o}`,s,a),e.fillStyle=r.ink,e.fillText(`+${o}`,
s,a)}var Wa=.46,Ua=.86,Ba=.66,eo=.48,Ga=.78,ja=.58;function to(e,t,r,n){let[o,s]=[t.moments[r-1],t.moments[r]];if(!o)return;let{ctx:a,grid:i,colors:c}=e;a.strokeStyle=
c.collision,a.lineWidth=Math.max(1.5,i.cell*.07),a.lineCap="butt",a.globalAlpha=n;for(let u=0;u<s.alive.length;u++)at(o,s,u)&&Va(e,t,T(o,u),it(o,s,u));a.globalAlpha=
1}function Va({ctx:e,grid:t},r,n,o){let[s,a]=[o[1]-n[1],o[0]-n[0]],i=m=>$(t,n[1]+.5+s*m),c=m=>P(t,n[0]+.5+a*m),u=nr(r,o)?Ga:ja;e.setLineDash([t.cell*.09,t.cell*
.06]),e.beginPath(),e.moveTo(i(eo),c(eo)),e.lineTo(i(u),c(u)),e.stroke(),e.setLineDash([]);let d=.17*t.cell/Math.hypot(s,a);e.beginPath(),e.moveTo(i(u)-a*d,c(u)+
s*d),e.lineTo(i(u)+a*d,c(u)-s*d),e.stroke()}function ro(e,t,r,n,o,s){let a=rr[s];if(!s||!a)return;let{ctx:i,grid:c,colors:u}=e,d=nr(t,[n[0]+a[0],n[1]+a[1]])?Ua:
Ba,m=Wa*o.size,p=[$(c,o.x+a[1]*m),P(c,o.y+a[0]*m),$(c,o.x+a[1]*d),P(c,o.y+a[0]*d)],h=Math.max(1.5,c.cell*.085);i.lineCap=i.lineJoin="round";for(let[v,g]of[[u.paper,
h*2.1],[Se(e,t,r),h]])i.strokeStyle=v,i.lineWidth=g,zn(i,...p,c.cell*.2),i.stroke()}var oo={numbers:!0,axes:!1,trail:6,viewers:[],plan:null,selected:null,cursor:null,you:null,fog:!1};function so(e,t,r,n,o){let{ctx:s,grid:a,colors:i}=e,c=Math.min(
Math.ceil(r),t.moments.length-1),u=t.moments[c],d=r===c,m=ut(t,r),p=d?1:Math.max(0,1-2*(c-r));s.clearRect(0,0,s.canvas.width,s.canvas.height),Wn(e);for(let g of n.
viewers)m[g]?.alpha&&Kn(e,t,g,...ar(t,g,r));Un(e,t),n.axes&&Gn(e,o),Yn(e,t,r,n.trail,m),Jn(e,u.contested??[],p),Zn(e,t,r),to(e,t,c,p),m.forEach(({x:g,y:b,size:A},y)=>{
let x=kn(u,y)?.4:0,S=sr(u,y)?1:x;S&&Xn(e,g,b,A,S*p)});let h=d?u:t.moments[Math.max(0,c-1)];if(Qn(e,t,h,m,n.numbers,o),d&&n.plan)for(let[g,b]of m.entries())b.alpha&&
ro(e,t,g,T(u,g),b,n.plan[g]??0);n.you!==null&&(n.fog&&Vn(e,t,...ar(t,n.you,r)),qn(e,m[n.you],o)),s.lineWidth=Math.max(2,2.5*o),s.strokeStyle=i.focus;let v=n.selected===
null?void 0:m[n.selected];v?.alpha&&no(e,v.x,v.y,v.size*.96),n.cursor&&(s.setLineDash([a.cell*.12,a.cell*.08]),no(e,n.cursor[1]+.5,n.cursor[0]+.5,.8),s.setLineDash(
[]))}function no({ctx:e,grid:t},r,n,o){let s=o*t.cell;e.beginPath(),e.roundRect(t.left+r*t.cell-s/2,t.top+n*t.cell-s/2,s,s,s*.1),e.stroke()}var ao=(e,t)=>(t+.24)/(e+.24);function io(e,t,r,n,o,s){let a=r?28*s:0,i=(u,d)=>(u-a)/(d+2*.12),c=Math.max(1,Math.floor(Math.min(i(n,t),i(o,e))));return{rows:e,cols:t,
cell:c,left:Math.round((n-t*c+a)/2),top:Math.round((o-e*c+a)/2)}}function lo(e,t,r){let n=Math.floor((r-e.top)/e.cell),o=Math.floor((t-e.left)/e.cell);return n>=
0&&n<e.rows&&o>=0&&o<e.cols?[n,o]:null}var qa={paper:"--board-paper",line:"--board-line",frame:"--board-frame",ink:"--board-ink",muted:"--board-muted",obstacle:"--board-obstacle",pursuer:"--pursuer",
evader:"--evader",capture:"--capture",collision:"--collision",focus:"--focus"};function mt(e){let t=getComputedStyle(e),r=Object.entries(qa).map(([n,o])=>[n,t.getPropertyValue(
o).trim()]);return Object.fromEntries(r)}var se=()=>matchMedia("(prefers-reduced-motion: reduce)").matches,Me=class{canvas;#e=null;#n=0;#t;#o={rows:1,cols:1,left:0,top:0,cell:1};#s=0;#r;#l;constructor(t,r={}){
this.canvas=t,t.classList.add("board"),t.setAttribute("role","img"),this.#t={...oo,...r},this.#r=new ResizeObserver(()=>this.#u()),this.#r.observe(t),this.#l=new MutationObserver(
()=>this.redraw()),this.#l.observe(document.documentElement,{attributes:!0}),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",this.redraw)}close(){
this.#r.disconnect(),this.#l.disconnect(),matchMedia("(prefers-color-scheme: dark)").removeEventListener("change",this.redraw),cancelAnimationFrame(this.#s)}get look(){
return this.#t}set look(t){this.#t={...this.#t,...t},this.#d(),this.redraw()}show(t,r){this.#e=t,this.#n=Math.min(Math.max(0,r),t.moments.length-1),this.#d(),this.
redraw()}redraw=()=>{this.#s||(this.#s=requestAnimationFrame(()=>this.drawNow()))};drawNow(){cancelAnimationFrame(this.#s),this.#s=0;let t=this.canvas.getContext(
"2d");if(!t||!this.#e)return;let{rows:r,cols:n}=this.#e,o=devicePixelRatio||1;this.#o=io(r,n,this.#t.axes,this.canvas.width,this.canvas.height,o);let s={ctx:t,grid:this.#o,
colors:mt(this.canvas)};so(s,this.#e,this.#n,this.#t,o)}cellAt(t,r){let n=this.canvas.getBoundingClientRect(),o=this.canvas.width/n.width;return lo(this.#o,(t-n.
left)*o,(r-n.top)*o)}agentAt(t,r){let n=this.cellAt(t,r);if(!n||!this.#e)return null;let o=this.#e.moments[Math.round(this.#n)],s=We(this.#e,o).get(n[0]*this.#e.
cols+n[1])??[],a=ut(this.#e,Math.round(this.#n)),i=c=>{let[u,d]=this.pointOf(a[c].x,a[c].y);return Math.hypot(u-t,d-r)};return s.length?s.reduce((c,u)=>i(u)<i(c)?
u:c):null}pointOf(t,r){let n=this.canvas.getBoundingClientRect(),o=n.width/this.canvas.width,{left:s,top:a,cell:i}=this.#o;return[n.left+(s+t*i)*o,n.top+(a+r*i)*
o]}#d(){if(!this.#e)return;let{rows:t,cols:r}=this.#e;this.canvas.style.setProperty("--board-aspect",String(ao(t,r)))}#u(){let t=devicePixelRatio||1,{width:r,height:n}=this.
canvas.getBoundingClientRect();this.canvas.width=Math.max(1,Math.round(r*t)),this.canvas.height=Math.max(1,Math.round(n*t)),this.drawNow()}};var Ue=[.5,1,2,4,8,16,32,64],pt=0,ht=12,Ka=2,Y=class extends EventTarget{#e;#n;#t;#o=0;#s=0;#r=!1;#l=null;#d=0;#u=[];#p=[];glide=.28;constructor(t,r={}){super(),
this.#e=t,this.#n=r.speed??4,this.#t=r.still??!1}get step(){return this.#o}get time(){return this.#t?this.#o:this.#s}get arrived(){return this.#s===this.#o}get playing(){
return this.#r}get length(){return this.#e}set length(t){this.#e=t,this.#o>t&&this.jump(t),this.#i("state")}get marks(){return this.#u}set marks(t){this.#u=t,this.#i(
"state")}get ticks(){return this.#p}set ticks(t){this.#p=t,this.#i("state")}get pace(){return this.#n||Math.max(Ka,this.#e/ht)}get speed(){return this.#n}set speed(t){
this.#n=t,this.#i("state")}changeSpeed(t){let r=Ue.findIndex(n=>n>=this.pace);this.speed=Ue[Math.min(Ue.length-1,Math.max(0,r+t))]}play(){this.#r||!this.#e||(this.#o===
this.#e&&this.jump(0),this.#r=!0,this.#i("state"),this.#a())}pause(){this.#r&&(this.#r=!1,this.#i("state"))}toggle(){this.#r?this.pause():this.play()}move(t){this.
pause();let r=Math.min(this.#e,Math.max(0,this.#o+t));Math.abs(r-this.#s)>1?this.jump(r):this.#c(r),this.#a()}jump(t){this.#s=Math.min(this.#e,Math.max(0,Math.round(
t))),this.#c(this.#s),this.#i("frame")}#c(t){t!==this.#o&&(this.#o=t,this.#i("step"),this.#t&&this.#i("frame"))}#a(){this.#l===null&&(this.#d=performance.now(),
this.#l=requestAnimationFrame(()=>this.#m()))}#m(){this.#l=null;let t=performance.now();this.#h(Math.min(.25,(t-this.#d)/1e3)),this.#d=t,(!this.#t||this.arrived)&&
this.#i("frame"),(this.#r||this.#s!==this.#o)&&(this.#l=requestAnimationFrame(()=>this.#m()))}#h(t){let r=t;for(;r>0;){if(this.#s===this.#o){if(!this.#r)return;
if(this.#o===this.#e)return this.pause();this.#c(this.#o+1)}let n=this.#r?this.pace:1/this.glide,o=this.#o-this.#s,s=Math.min(Math.abs(o),r*n);r-=s/n,this.#s=s===
Math.abs(o)?this.#o:this.#s+Math.sign(o)*s}this.#r&&this.#s===this.#e&&this.pause()}#i(t){this.dispatchEvent(new Event(t))}};function co(e,t){if(t.ctrlKey||t.metaKey||
t.altKey)return!1;let r=t.shiftKey?10:1,o={" ":()=>e.toggle(),ArrowRight:()=>e.move(r),ArrowLeft:()=>e.move(-r),Home:()=>e.move(-e.length),End:()=>e.move(e.length),
"+":()=>e.changeSpeed(1),"-":()=>e.changeSpeed(-1)}[t.key];return o?.(),o!==void 0}var Ya={first:"M6 5v14M19 5 9 12l10 7z",back:"M17 5 7 12l10 7z",play:"M7 4.5 19 12 7 19.5z",pause:"M8 5v14M16 5v14",forward:"M7 5l10 7-10 7z",last:"M18 5v14M5 5\
l10 7-10 7z"};function uo(e){return f("svg",{viewBox:"0 0 24 24","aria-hidden":"true",class:"icon"},f("path",{d:Ya[e]}))}function Be(e,t,r,n){return l("button",
{type:"button",class:"player-button","aria-label":t,title:`${t} (${r})`,onclick:n},uo(e))}function Ae(e){let t=Be("play","Play","Space",()=>e.toggle()),r=Za(e),
n=l("div",{class:"captures","aria-hidden":"true",title:"Captures"}),o=l("div",{class:"losses","aria-hidden":"true"}),s=Ja(e),a=l("output",{class:"player-count"}),
i=l("div",{class:"player",role:"group","aria-label":"Player"},Be("first","First step","Home",()=>e.move(-e.length)),Be("back","Step back","←",()=>e.move(-1)),
t,Be("forward","Step forward","→",()=>e.move(1)),Be("last","Last step","End",()=>e.move(e.length)),l("div",{class:"scrub"},n,o,r),a,s),c=(m,p={})=>{let h=l("i",
p);return h.style.left=`${100*m/Math.max(1,e.length)}%`,h},u=()=>{n.replaceChildren(...e.marks.map(m=>c(m))),o.replaceChildren(...e.ticks.map(({step:m,kind:p,size:h,
text:v})=>{let g=c(m,{class:p,title:`Step ${m}: ${v}`});return g.style.height=`${100*h}%`,g}))},d=()=>{t.replaceChildren(uo(e.playing?"pause":"play")),t.ariaLabel=
e.playing?"Pause":"Play",t.title=`${t.ariaLabel} (Space)`,r.max=String(e.length),r.value=String(e.step),r.ariaValueText=`step ${e.step} of ${e.length}`,a.textContent=
`${e.step} / ${e.length}`,a.style.minWidth=`${2*String(e.length).length+3}ch`,s.value=String(e.speed)};return e.addEventListener("step",d),e.addEventListener("s\
tate",d),e.addEventListener("state",u),i.addEventListener("keydown",m=>{!(m.target instanceof HTMLSelectElement||m.key===" "&&m.target!==r)&&co(e,m)&&m.preventDefault()}),
d(),i}function Za(e){let t=l("input",{type:"range",class:"player-scrub",min:0,step:1,"aria-label":"Step"});return t.addEventListener("input",()=>{e.pause(),e.jump(
Number(t.value))}),t}function Ja(e){let t=`Steps a second, or the whole in ${ht} s (+ and -)`,r=l("select",{class:"player-speed","aria-label":"Speed",title:t},l(
"option",{value:pt},`in ${ht} s`),...Ue.map(n=>l("option",{value:n},`${n} / s`)));return r.addEventListener("change",()=>{e.speed=Number(r.value)}),r}var C=(e,t=2)=>e==null?"-":e.toFixed(t);function mo(e,t,r){return t===null||r===null?C(e):`${C(e)} (${C(t)} to ${C(r)})`}function Ge(e,t,r,n=!1){let o=(t-e)/Math.max(1,r),s=10**Math.floor(Math.log10(o||1)),a=[1,2,5,10].map(u=>u*s).find(u=>u>=o)??10*s;n&&(a=Math.max(1,Math.round(a)));
let i=Math.ceil(e/a-1e-9),c=Math.floor(t/a+1e-9);return Array.from({length:Math.max(0,c-i+1)},(u,d)=>(i+d)*a)}var ft={left:46,right:12,top:10,bottom:42},po={x:56,y:34};function Z(e,t,r,n){let[o,s]=[ft.left,ft.top],a=Math.max(o+40,e-ft.right),i=Math.max(s+40,t-ft.bottom),
c=(g,b,A)=>y=>b+(y-g.low)/(g.high-g.low||1)*(A-b),[u,d]=[c(r,o,a),c(n,i,s)],m=f("g"),p=f("svg",{width:e,height:t,viewBox:`0 0 ${e} ${t}`,class:"plot"}),h=f("g",
{class:"axes"});for(let g of Ge(n.low,n.high,(i-s)/po.y,n.whole))h.append(f("line",{x1:o,x2:a,y1:d(g),y2:d(g),class:"grid"}),f("text",{x:o-8,y:d(g),"text-anchor":"\
end","dominant-baseline":"middle"},ho(g)));for(let g of Ge(r.low,r.high,(a-o)/po.x,r.whole))h.append(f("text",{x:u(g),y:i+16,"text-anchor":"middle"},ho(r.mirrored?
Math.abs(g):g)));return h.append(f("line",{x1:o,x2:a,y1:i,y2:i,class:"axis"}),f("text",{x:(o+a)/2,y:t-6,"text-anchor":"middle",class:"label"},r.label),f("text",
{transform:`translate(12 ${(s+i)/2}) rotate(-90)`,"text-anchor":"middle",class:"label"},n.label)),p.append(h,m),{root:p,marks:m,left:o,right:a,top:s,bottom:i,x:u,
y:d,at:g=>{let b=g-p.getBoundingClientRect().left;return r.low+(b-o)/(a-o)*(r.high-r.low)}}}var ho=e=>String(Number(e.toPrecision(6))).replace("-","−");function J(e,t,r,n){
let o="",s="M";r.forEach((a,i)=>{a===null?s="M":(o+=`${s}${e.x(t[i]).toFixed(1)} ${e.y(a).toFixed(1)}`,s="L")}),e.root.insertBefore(f("path",{d:o,class:`line ${n}`}),
e.marks)}function fo(e,t,r,n=null){let o=e.x(t);e.marks.append(f("line",{x1:o,x2:o,y1:e.top,y2:e.bottom,class:`mark ${r}`})),n!==null&&e.marks.append(f("circle",{cx:o,cy:e.
y(n),r:5,class:`dot ${r}`}))}function gt(...e){return l("p",{class:"legend small"},...e.map(([t,r])=>l("span",{class:`key ${r}`},t)))}function X(e,t,r,n){let o=l(
"div",{class:"chart chooses",role:"img","aria-label":e}),s=null,a=()=>{s?.marks.replaceChildren(),s&&r(s)};o.addEventListener("click",c=>s&&n(s.at(c.clientX),s,
c));let i=()=>{let{clientWidth:c,clientHeight:u}=o;c<50||u<50||(s=t(c,u),o.replaceChildren(s.root),a())};return new ResizeObserver(i).observe(o),{element:o,update:a,
redraw:i}}function Ee(e,t,r){let n=devicePixelRatio||1;for(let[a,i]of Object.entries(r))e.style.setProperty(a,`${i}px`);e.width=Math.round(r.width*n),e.height=Math.round(
r.height*n);let o=e.getContext("2d"),s=Xa(t);!o||!s||(o.imageSmoothingEnabled=!1,o.drawImage(s,0,0,e.width,e.height))}function Xa(e){let[t,r]=e.shape,n=document.
createElement("canvas");[n.width,n.height]=[r,t];let o=n.getContext("2d");if(!o)return null;let s=o.createImageData(r,t);return e.capture_rate.forEach((a,i)=>a.
forEach((c,u)=>{let d=4*((t-1-i-e.first[0])*r+u+e.first[1]);s.data.set([...rt(c),255],d)})),o.putImageData(s,0,0),n}function Q(e,t){let r=l("span",{class:"gradi\
ent"});return r.style.backgroundImage=Sn(),l("p",{class:"scale-of-rates small muted"},e,r,t)}function ae(e,t,r=e.length){let n=l("canvas",{role:"img","aria-label":t}),o=l("div",{class:"cells-of-matrix"},n),s=l("figure",{},l("figcaption",{},t),o,l("p",{class:"\
small muted"},l("span",{class:"pursuer"},"↑ pursuers")," ",l("span",{class:"evader"},"evaders →")));return s.draw=()=>{let a=o.clientWidth;a&&Ee(n,{shape:[r,
r],first:[0,0],capture_rate:e},{left:0,top:0,width:a,height:a})},new ResizeObserver(()=>s.draw?.()).observe(o),s}var yo=()=>Q("0 all escape","1 all caught"),vo=({
runs:e})=>l("div",{class:"widget"},l("div",{class:"matrices"},...e.map((t,r)=>ae(t.payoff.capture_rate,`Matrix ${"ABC"[r]}`))),yo()),yt=31,go=.016;function bo(){
let e=r=>Array.from({length:yt},(n,o)=>Array.from({length:yt},(s,a)=>.5+r*(o-a))),t=[[go,"Both get better"],[-go,"Both get worse"],[0,"Nothing happens"]];return l(
"div",{class:"widget"},l("div",{class:"matrices"},...t.map(([r,n])=>ae(e(r),n))),yo())}function xo(){let e=Array.from({length:yt},(t,r)=>r);return X("A capture \
rate that stays at one half from generation 0 to 30",(t,r)=>{let n=Z(t,r,{low:0,high:yt-1,label:"generation",whole:!0},{low:0,high:1,label:"capture rate"});return J(
n,e,e.map(()=>.5),"of-both"),n},()=>{},()=>{}).element}function ie(e,t,r,n,o){let s=l("input",{type:"range",min:0,max:t.length-1,step:1,"aria-label":e}),a=l("output",{class:"numbers"}),i=()=>{let c=t[Number(s.value)];
return a.textContent=s.ariaValueText=n(c),c};return s.value=String(t.indexOf(r)),s.addEventListener("input",()=>o(i())),i(),l("label",{class:"slider"},l("span",
{},e),s,a)}function wo(e,t,r){let n=l("select",{"aria-label":e},...t.map(o=>l("option",{value:o},o)));return n.addEventListener("change",()=>r(n.value)),l("labe\
l",{class:"slider"},l("span",{},e),n)}function ee(e){let t=e>>>0;return()=>{t=t+1831565813>>>0;let r=Math.imul(t^t>>>15,t|1);return r^=r+Math.imul(r^r>>>7,r|61),((r^r>>>14)>>>0)/2**32}}var cr=["rock",
"paper","scissors"],ur=[[.5,0,1],[1,.5,0],[0,1,.5]],Qa=1e-9,Ao=e=>ur.map(t=>t.reduce((r,n,o)=>r+n*e[o],0));function dr(e,t){let r=e.slice(-t);return cr.map((n,o)=>r.
filter(s=>s===o).length/r.length)}var mr=e=>Math.max(...Ao(e));function So(e,t,r){let n=Ao(dr(e,t)),o=n.flatMap((s,a)=>s>Math.max(...n)-Qa?[a]:[]);return o[o.length>
1?Math.floor(r()*o.length):0]}function bt(e,t,r){let n={pursuers:[0],evaders:[0]};for(let o=1;o<=e;o++)n.pursuers.push(So(n.evaders,t,r)),n.evaders.push(So(n.pursuers,
t,r));return n}var je=100,xt={scalar:{dimensions:1,greatest:!0},focusing:{dimensions:10,greatest:!0},intransitive:{dimensions:2,greatest:!1}};function lr(e,t,r){
let{greatest:n}=xt[e],o=t[0]-r[0];for(let s=1;s<t.length;s++){let a=t[s]-r[s];(n?Math.abs(a)>Math.abs(o):Math.abs(a)<Math.abs(o))&&(o=a)}return(1+Math.sign(o))/
2}var pr=(e,t,r)=>t.reduce((n,o)=>n+r.reduce((s,a)=>s+lr(e,o,a),0),0)/(t.length*r.length),Ce={population:25,mutation:.005,opponents:15,hall:0},Te=class{game;settings;generation=0;#e;#n;#t=[
[],[]];constructor(t,r,n){[this.game,this.settings,this.#e]=[t,r,n];let o=()=>Array.from({length:r.population},()=>new Uint8Array(je));this.#n=[o(),o()]}ones(t){
let{dimensions:r}=xt[this.game],n=je/r;return this.#n[t].map(o=>Array.from({length:r},(s,a)=>vt(o.subarray(a*n,(a+1)*n))))}objective=t=>vt(this.#n[t].map(vt))/this.
settings.population;step(){let t=[this.ones(0),this.ones(1)],r=this.#o(t);for(let n of[0,1]){this.#t[n].push(t[n][r[n].indexOf(Math.max(...r[n]))]);let o=this.#r(
r[n]);this.#n[n]=o.map(s=>this.#s(this.#n[n][s]))}this.generation++}#o(t){let{population:r,opponents:n,hall:o}=this.settings,s=[new Array(r).fill(0),new Array(r).
fill(0)];for(let a=0;a<n;a++)Mo(r,this.#e).forEach((i,c)=>{let u=lr(this.game,t[0][c],t[1][i]);s[0][c]+=+(u===1),s[1][i]+=+(u===0)});for(let a of[0,1]){let i=this.#t[1-
a];for(let c of Mo(i.length,this.#e,o))t[a].forEach((u,d)=>s[a][d]+=+(lr(this.game,u,i[c])===1))}return s}#s(t){let r=t.slice();for(let n=0;n<r.length;n++)this.#e()<
this.settings.mutation&&(r[n]^=1);return r}#r(t){let r=vt(t),n=r?t:t.map(()=>1);return t.map(()=>{let o=this.#e()*(r||t.length),s=n.findIndex(a=>(o-=a)<0);return s<
0?t.length-1:s})}};function Mo(e,t,r=e){let n=Array.from({length:e},(s,a)=>a),o=Math.min(r,e);for(let s=0;s<o;s++){let a=s+Math.floor(t()*(e-s));[n[s],n[a]]=[n[a],
n[s]]}return n.slice(0,o)}function vt(e){let t=0;for(let r=0;r<e.length;r++)t+=e[r];return t}var hr=1,wt=["pursuers","evaders"],Co=[[150,42],[266,232],[34,232]],ei={pursuers:-7,evaders:7},Eo=e=>[0,1].map(t=>e.reduce((r,n,o)=>r+n*Co[o][t],0)),To=(e,t)=>e.
map((r,n)=>dr(e.slice(0,n+1),t));function ko({memories:e=[1],memory:t=e[0],generations:r=30}){let n=new Y(r,{speed:r>100?16:2,still:se()}),o=t,s=bt(r,o,ee(hr)),
a={pursuers:[],evaders:[]},i={pursuers:f("polyline",{class:"way of-pursuers"}),evaders:f("polyline",{class:"way of-evaders"})},c={pursuers:f("path",{class:"fill\
ed-pursuer",d:"M0 -11 11 9H-11z"}),evaders:f("circle",{class:"filled-evader",r:9})},u=f("svg",{viewBox:"0 0 300 270",class:"hands-triangle",role:"img","aria-lab\
el":"The shares of rock, paper and scissors among the remembered hands of both teams"},f("polygon",{class:"frame",points:Co.map(b=>b.join()).join(" ")}),f("circ\
le",{class:"middle",cx:150,cy:168.7,r:4}),f("text",{x:150,y:192,"text-anchor":"middle"},"one third each"),f("text",{class:"label",x:150,y:18,"text-anchor":"midd\
le"},"rock"),f("text",{class:"label",x:266,y:262,"text-anchor":"middle"},"paper"),f("text",{class:"label",x:34,y:262,"text-anchor":"middle"},"scissors"),...wt.map(
b=>i[b]),...wt.map(b=>c[b])),d=l("p",{class:"numbers"}),m=X("What the best answer wins against the remembered hands, by generation",(b,A)=>{let y=Z(b,A,{low:0,high:r,
label:"generation",whole:!0},{low:.4,high:1,label:"best answer wins"});J(y,[0,r],[.5,.5],"half");for(let x of wt)J(y,s[x].map((S,M)=>M),a[x].map(mr),`of-${x}`);
return y},b=>fo(b,n.step,"of-both"),b=>n.jump(b)),p=()=>{let b=n.step;for(let y of wt){i[y].setAttribute("points",a[y].slice(0,b+1).map(M=>Eo(M).map(k=>k.toFixed(
1)).join()).join(" "));let[x,S]=Eo(a[y][b]);c[y].setAttribute("transform",`translate(${x+ei[y]} ${S})`)}let A=y=>l("span",{class:y.slice(0,-1)},`${y} show ${cr[s[y][b]]}`);
d.replaceChildren(`Generation ${b}: `,A("pursuers"),", ",A("evaders"),".",...e.length>1?[` The best answer to the remembered hands of the pursuers wins ${C(mr(a.
pursuers[b]))}.`]:[]),m.update()},h=()=>{s=bt(r,o,ee(hr)),a={pursuers:To(s.pursuers,o),evaders:To(s.evaders,o)},m.redraw(),p()};n.addEventListener("step",p),h();
let v=e.at(-1),g=ie("memory (hands)",e,t,b=>b===v?"all":String(b),b=>{o=b,h()});return l("div",{class:"widget"},e.length>1&&g,l("div",{class:"two"},l("div",{},u),
e.length>1&&l("div",{},gt(["pursuers' hands","of-pursuers"],["evaders' hands","of-evaders"]),m.element)),d,Ae(n))}function Oo({generations:e=30}){let{pursuers:t,
evaders:r}=bt(e,1,ee(hr)),n=t.map(s=>r.map(a=>ur[s][a])),o=n.at(-1);return l("div",{class:"widget"},l("div",{class:"matrices"},ae(n,`The last pursuers score ${C(
o.reduce((s,a)=>s+a,0)/o.length)} against all evaders.`)),Q("0 loses","1 wins"))}var Ve=600,ke=20,fr=5,Ro=10,gr={"Game A":"intransitive","Game B":"scalar","Game C":"focusing"},_o={low:0,high:Ve,label:"generation",whole:!0},Lo={low:0,high:je,
label:"ones of side 1"},le=()=>{},ti=()=>new Promise(e=>setTimeout(e));async function yr(e,t,r){for(t();e.generation<Ve&&r();t()){for(let n=0;n<ke;n++)e.step();
await ti()}}var St=new Map,No=[];async function ri(){for(let e of Object.keys(gr))St.set(e,[]);for(let e=0;e<fr;e++)for(let[t,r]of Object.entries(gr)){let n={score:[],
ones:[]};St.get(t).push(n);let o=new Te(r,Ce,ee(e));await yr(o,()=>{n.score.push(pr(r,o.ones(0),o.ones(1))),n.ones.push(o.objective(0))},()=>!0),No.forEach(s=>s())}}
function Io({shows:e="score"}){St.size||ri();let t=e==="score"?{low:0,high:1,label:"score of side 1"}:Lo,r=Object.entries(gr).map(([n,o])=>{let s=e==="score"?n:
`${n}: ${o}`,a=X(`${s}: ${t.label} in ${fr} races`,(i,c)=>{let u=Z(i,c,_o,t);for(let d of St.get(n))J(u,d[e].map((m,p)=>p*ke),d[e],"of-both dense");return u},le,
le);return No.push(a.redraw),l("figure",{},l("figcaption",{},s),a.element)});return l("div",{class:"widget"},l("div",{class:"matrices"},...r),l("p",{class:"smal\
l muted"},`Each line is a race; there are ${fr} of each game, played now, in this page.`))}var ni=[5,10,15,25,40,60],oi=[5e-4,.001,.002,.005,.01,.02,.05],si=[0,
1,5,15,30],$o=15,ai=Array.from({length:20},(e,t)=>t);function Fo({hall:e=!1}){let[t,r,n]=["scalar",0,{...Ce,hall:e?$o:0}],o=0,s=y=>{n={...n,...y}},a=[[],[]],i=[
ae(a[0],"Score of side 1",Ve/ke+1),ae(a[1],"Score of side 2",Ve/ke+1)];i.forEach(y=>y.querySelector("p").replaceChildren(`↑ generation, → opponent (${ke} a \
cell)`));let c=[[],[]],u=X("Ones of both sides by generation",(y,x)=>{let S=Z(y,x,_o,{...Lo,label:"ones"});return c.forEach((M,k)=>J(S,M.map((ue,j)=>j*ke),M,k?"\
of-evaders":"of-pursuers")),S},le,le),d=l("p",{class:"numbers",role:"status"}),m=y=>{d.textContent=y},p=async()=>{let y=++o;for(let M of[...a,...c])M.length=0;let x=[
[],[]],S=new Te(t,n,ee(r));await yr(S,()=>{for(let M of[0,1])x[M].push(S.ones(M)),c[M].push(S.objective(M));for(let M of[0,1])a[M].push(x[1-M].map(k=>pr(S.game,
x[M].at(-1),k)));i.forEach(M=>M.draw?.()),u.redraw()},()=>o===y),o===y&&m(`${Po(S.game)} game, seed ${r}: after ${Ve} generations side 1 has ${c[0].at(-1).toFixed(
0)} ones, side 2 ${c[1].at(-1).toFixed(0)}.`)},h=[],v=X("Ones of side 1 at the end of ten races, a row for each choice of settings",(y,x)=>ii(h,y,x),le,le);v.element.
classList.add("dots");let g=async y=>{let x=++o,S=[],{population:M,mutation:k}=y,ue=`${t}${M===Ce.population?"":`, ${M} players`}${k===Ce.mutation?"":`, mutatio\
n ${k}`}, hall ${y.hall}`;h.push({text:ue,ends:S}),h.length>vr&&h.shift();for(let j=0;j<Ro&&o===x;j++){let V=new Te(t,y,ee(j));await yr(V,le,()=>o===x),o===x&&S.
push(V.objective(0)),v.redraw()}o===x&&m(`${Po(ue)}: side 1 ends with ${zo(S)} ones in the mean of ${Ro} races.`)},b=(y,x,S="")=>l("button",{type:"button",class:S,
onclick:()=>{y()}},x),A=l("div",{class:"sliders"},wo("game",Object.keys(xt),y=>t=y),ie("population",ni,n.population,String,y=>s({population:y})),ie("mutation",oi,
n.mutation,String,y=>s({mutation:y})),...e?[ie("hall of fame",si,$o,String,y=>s({hall:y}))]:[ie("seed",ai,0,String,y=>r=y)]);return e?(g(Ce).then(()=>o===1?g(n):
void 0),l("div",{class:"widget"},A,l("div",{class:"buttons"},b(()=>g(n),"Play ten races","primary")),d,v.element)):l("div",{class:"widget"},A,l("div",{class:"bu\
ttons"},b(p,"Play a race","primary"),b(async()=>{o++},"Stop")),l("div",{class:"matrices"},...i,l("figure",{},l("figcaption",{},"The truth: ones"),gt(["side 1","\
of-pursuers"],["side 2","of-evaders"]),u.element)),Q("0 loses","1 wins"),d)}var vr=6,zo=e=>(e.reduce((t,r)=>t+r,0)/e.length).toFixed(1),Po=e=>e.charAt(0).toUpperCase()+
e.slice(1);function ii(e,t,r){let n=Z(t,r,{low:0,high:je,label:"ones of side 1 at the end",whole:!0},{low:0,high:vr,label:""});return n.root.querySelectorAll(".\
axes .grid, .axes [text-anchor=end]").forEach(o=>o.remove()),e.forEach(({text:o,ends:s},a)=>{let i=n.y(vr-a-.7);n.marks.before(f("text",{class:"label",x:n.left,
y:i-12},s.length?`${o}: mean ${zo(s)}`:o)),s.forEach(c=>n.marks.before(f("circle",{class:"dot of-both",cx:n.x(c),cy:i,r:5})))}),n}function li(e,t,r){return{rows:e.rows,cols:e.cols,nPursuers:e.n_pursuers,fov:e.fov,interaction:e.rules.interaction,obstacles:t,moments:r}}function Mt(e){let t=Array.from({length:e.length+1},(r,n)=>ci(e,n));return li(e.config,e.map,t)}function ci(e,t){let r=e.n_agents,n=e.config.n_evaders,o=(a,i,c)=>a.
subarray(i*c,(i+1)*c),s={positions:o(e.last_positions,t,2*r),alive:o(e.alive,t,r),captured:o(e.captured,t,n),everCaptured:o(e.ever_captured,t,n)};return t===0?s:
{...s,actions:o(e.actions,t-1,r),involved:o(e.involved,t-1,3*r),fault:o(e.fault,t-1,3*r),get contested(){return e.conflicts(t).map(a=>a.cell)}}}var ui=Array.from({length:16},(e,t)=>{let[r,n]=[t%2?6.5:11,Math.PI*t/8];return`${12+r*Math.sin(n)} ${12-r*Math.cos(n)}`}).join(" ");function At(){let e=[["pursu\
er",f("path",{d:"M12 3 22 20H2z",class:"filled-pursuer"})],["evader",f("circle",{cx:12,cy:12,r:9,class:"filled-evader"})],["capture",f("polygon",{points:ui,class:"\
filled-capture"})],["captured evader",f("circle",{cx:12,cy:12,r:7.5,class:"ring-evader"})],["conflict",f("rect",{x:3,y:3,width:18,height:18,class:"dashed-confli\
ct"})]];return l("ul",{class:"shapes small","aria-label":"Shapes on the board"},...e.map(([t,r])=>l("li",{},f("svg",{viewBox:"0 0 24 24","aria-hidden":"true"},r),
t)))}function Ho(e,t,...r){return l("section",{class:"card panel","aria-label":e},l("header",{},l("h2",{},e),l("p",{class:"small muted"},t)),...r)}var di={present:"●",absent:"○","cannot tell":"?"};function Do(e){let{findings:t}=e;if(!t?.table.length)return null;let[,...r]=t.table,n=r.map(([s,a,i,c],u)=>{
let d=mi(t.reasons[u]??"");return l("li",{class:`finding ${a.replace(" ","-")}`},l("span",{class:"sign","aria-hidden":"true"},di[a]??""),l("div",{},l("p",{},l("\
strong",{},s),` ${a}`,l("span",{class:"muted"},` · ${c}`)),d?l("p",{class:"small"},`${d}.`):null,l("p",{class:"small muted numbers"},i)))}),o=Ho("What happened",
"Each condition is present, absent, or its 95 % interval cannot tell. The intervals are about this run.",l("p",{class:"headline"},t.headline),...t.numbers.map(s=>l(
"p",{class:"numbers"},`${Wo(s)}.`)),l("ul",{class:"findings"},...n),e.limits?l("p",{class:"small"},e.limits):null);return o.classList.add("diagnosis"),{element:o}}
function mi(e){let[,t=""]=e.split(/, because (.*)/s);return Wo(t.replace(/\.$/,""))}var Wo=e=>e.charAt(0).toUpperCase()+e.slice(1);var pi=40,Et=class{element;#e;#n=l("div",{class:"episodes",role:"group","aria-label":"Episodes of this cell"});#t=l("p",{class:"check small numbers","aria-live":"\
polite"});constructor(t){this.#e=t,this.element=l("div",{class:"strip-of-episodes"},this.#n,this.#t)}show(t,r){let{pursuer:n,evader:o,episode:s,seed:a}=this.#e.
selected,i=xe(t,n,o);this.#n.replaceChildren(...(i?.rates??[]).slice(0,pi).map((p,h)=>this.#o(p,h)));let c=a===null?i?.rates[s]:void 0,u=r.statistics.capture_rate,
d=c!==void 0&&Math.abs(u-c)<1e-6&&r.length===i?.lengths[s],m=i?"Not an episode of the evaluation":"The evaluation played no episodes of this pair.";this.#t.dataset.
equal=String(d),this.#t.textContent=d?"As in the evaluation":c===void 0?m:`Episode ${s+1} differs from the evaluation.`,this.#t.title=`Played here: capture rate\
 ${C(u,3)} in ${r.length} steps.${i?` The cell says ${C(i.rate,3)}.`:""}`}#o(t,r){let{selected:n}=this.#e,o=l("span",{class:"bar"});return o.style.height=`${Math.
round(100*t)}%`,l("button",{type:"button",class:"episode",title:`Episode ${r+1}: capture rate ${C(t)}`,"aria-label":`Episode ${r+1}, capture rate ${C(t)}`,"aria\
-pressed":String(r===n.episode&&n.seed===null),onclick:()=>this.#e.select({episode:r,seed:null})},o,l("span",{class:"count"},r+1))}};var Tt=["stay","north","east","south","west","northeast","southeast","southwest","northwest"];var Uo=0,Bo=1,hi=2,fi=176;function jo(e,t,r,n){let o=devicePixelRatio||1,s=mt(e);e.width=e.height=fi*o;let a=e.getContext("2d");if(!a)return;let{fov:i}=t,c=e.width/
i;a.fillStyle=s.paper,a.fillRect(0,0,e.width,e.height);for(let d=0;r&&d<i*i;d++){let[m,p]=[(d%i+.5)*c,(Math.floor(d/i)+.5)*c],h=g=>!!r[g*i*i+d];h(hi)&&(a.fillStyle=
s.obstacle,a.fillRect(m-c/2,p-c/2,c,c));let v=h(Uo)&&h(Bo)?c*.18:0;h(Uo)&&Go(a,oe,m+v,p+v,c*.74,s.evader),h(Bo)&&Go(a,dt,m-v,p-v,c*.86,s.pursuer)}a.strokeStyle=
n<t.n_pursuers?s.pursuer:s.evader,a.lineWidth=2*o;let u=Math.floor(i/2)*c;a.strokeRect(u,u,c,c)}function Go(e,t,r,n,o,s){t(e,r,n,o),e.fillStyle=s,e.fill()}var Vo="What it remembers: a number for each unit, from -1 to 1",Ct=class{element;#e;#n=l("canvas",{class:"seen",role:"img"});#t=l("h3");#o=l("p",{class:"small \
muted"});#s=l("div",{class:"answers"});#r=l("div",{title:Vo});#l=null;#d=null;#u=null;#p=null;#c=null;#a=null;#m=0;constructor(t){this.#e=t,this.element=l("div",
{class:"inspector","data-open":"false"},l("p",{class:"hint small muted"},"Click an agent, or press A: what it sees, and what its network answers."),l("div",{class:"\
inspected"},this.#n,l("div",{class:"answer"},this.#t,this.#o,this.#r),this.#s))}get agent(){return this.#a}show(t,r,n,o){this.#l?.free(),this.#l=t.world(r.world),
this.#u!==r&&(this.#d=null,this.#a!==null&&this.choose(null)),[this.#u,this.#p,this.#c]=[r,n,o]}set solution(t){this.#d=t,this.at(this.#m)}choose(t){this.#a=t,this.
element.dataset.open=String(t!==null),this.#e(t),this.at(this.#m)}next(t){let r=this.#p;if(!r)return;let n=this.#a??(t>0?-1:0);for(let o=0;o<r.n_agents;o++)if(n=
(n+t+r.n_agents)%r.n_agents,r.alive[this.#m*r.n_agents+n])return this.choose(n)}at(t){this.#m=t;let[r,n,o,s,a]=[this.#p,this.#l,this.#u,this.#c,this.#a];if(!r||
!n||!o||!s||a===null)return;let i=a<r.config.n_pursuers?"pursuer":"evader";this.#r.replaceChildren(),this.#t.replaceChildren(l("span",{class:i},H(a,r.config.n_pursuers)));
let c={pursuers:G(o,"pursuer",s.pursuer),evaders:G(o,"evader",s.evader)};r.seek(n,t,c);let u=r.actions.subarray(t*r.n_agents,(t+1)*r.n_agents);for(;u.length&&!n.
over&&(a<n.actors[0]||a>=n.actors[1]);)n.playTurn(u);let d=!!(r.alive[t*r.n_agents+a]&&n.read("alive")[a]);jo(this.#n,r.config,d?n.view(a):null,a),this.#n.ariaLabel=
`Field of view of ${H(a,r.config.n_pursuers)}: evaders, pursuers and obstacles around it`;let m=u[a]??null;if(!d)return this.#h([],"It is gone.");let p=c[`${i}s`],
h=typeof p=="string"?null:n.answer(p,a),v=h?.probabilities??null;h?.memory.length&&this.#r.replaceChildren(l("p",{class:"small muted"},"It remembers:"),vi(h.memory));
let g=this.#d?.game(n)??null,b=typeof p=="string"?`The script "${p}" plays for it${m===null?"":`; it goes ${Tt[m]}`}.`:p.sampled?"Its action is drawn from these\
 probabilities.":"It takes the most probable action.",A=[["network",v],["perfect",g?.marginal(a)??null]],y=tt(r.config),x=S=>l("p",{class:"small muted"},S);this.#h(
[...g?[x(`Value ${g.value.toFixed(2)} under perfect play.`)]:[],...gi(A,m),...y?[x(`Perfect play is not known: ${y}.`)]:[]],m===null?"The episode is over.":b)}#h(t,r){
this.#s.replaceChildren(...t),this.#o.textContent=r}};function gi(e,t){let r=e.filter(([,s])=>s);if(!r.length)return[];let n=l("div",{class:"action muted"},l("s\
pan"),...r.map(([s])=>l("span",{class:"head"},s))),o=Array.from(r[0][1],(s,a)=>l("div",{class:a===t?"action taken":"action"},l("span",{},Tt[a]),...r.flatMap(([,
i])=>yi(i[a]))));return r.length>1||r[0][0]!==e[0][0]?[n,...o]:o}function yi(e){let t=l("span",{class:"filled"});return t.style.width=`${100*e}%`,[l("span",{class:"\
track"},t),l("span",{class:"numbers"},e.toFixed(2))]}function vi(e){let t=Array.from(e,r=>{let n=l("span",{title:r.toFixed(2)});return n.style.transform=`scaleY\
(${r})`,n});return l("div",{class:"units",role:"img","aria-label":Vo},...t)}function kt(e,t,{pursuer:r,evader:n,episode:o,seed:s}){let a=t.seeds[r][n];return e.match(t.world,G(t,"pursuer",r),G(t,"evader",n),BigInt(s??a),o)}function qo(e){let t=JSON.stringify(e,(r,n)=>r==="genome"?Array.from(n):n);return l("script",{type:"application/json",id:"champions"},t.replaceAll("<","\\u003c")).
outerHTML}var Ko="champion",Yo=0,br=64,xr=100;var bi=(e,t)=>Object.keys(e).every(r=>e[r]===t[r]);function Zo(e,t){return Object.keys(t).find(r=>bi(t[r],e))??null}var qe="_",xi="n",Vu=2n**64n-1n;var wr={fov:11,maxSteps:500,rewards:"paper"},wi=["rules","others","rewards","size","diagonal","fov","limit","seed","ended","walls","pursuers","evaders","played",
"next"];function Qo(e,t){let r=i=>i.map(c=>Mi(c,t)).join(""),n=i=>`${Math.floor(i/e.cols)}.${i%e.cols}`,o=Si(e.rewards,t),s=[e.seed,e.episode,e.steps].join("."),a={rules:Xo(
e.rules,t),others:e.others?Xo(e.others,t):"",rewards:o===wr.rewards?"":o,size:`${e.rows}x${e.cols}`,diagonal:e.diagonal?"1":"",fov:e.fov===wr.fov?"":String(e.fov),
limit:e.maxSteps===wr.maxSteps?"":String(e.maxSteps),seed:s==="0.0.0"?"":s,ended:e.ended?"1":"",walls:e.walls.map(n).join(qe),pursuers:e.pursuers.map(Jo).join(qe),
evaders:e.evaders.map(Jo).join(qe),played:e.played.map(r).join(qe),next:e.next.every(i=>i===Yo)?"":r(e.next)};return wi.filter(i=>a[i]).map(i=>`${i}=${a[i]}`).join(
"&")}function Jo({cell:e,gone:t,captured:r,everCaptured:n}){let o=r?"c":n?"e":"";return`${e[0]}.${e[1]}${o}${t?"x":""}`}function Xo(e,t){let r=t.fields.map(({name:n})=>String(
e[n]).toLowerCase());return Zo(e,t.variants)??r.join(".")}function Si(e,t){let r=JSON.stringify(e);return Object.keys(t.rewards).find(o=>JSON.stringify(t.rewards[o])===
r)??Object.values(e).map(o=>String(o)).join(qe)}function Mi(e,t){if(typeof e=="number")return String(e);if(e===Ko)return xi;let r=t.scripts.findIndex(({name:n})=>n===
e);return String.fromCharCode(97+r)}var Ai="/* the engine */";function es(e,t){return l("button",{type:"button",class:"to-playground",title:"Open this step in the playground (G): the same agents a\
nd actions under any rules",onclick:()=>Ei(e(),t)},"What if?")}function Ei(e,t){let r=e!==null&&e.match.n_agents<=xr&&Math.max(e.match.config.rows,e.match.config.
cols)<=br,n=r?Qo(Ti(e.match,e.step),t):"",o=new TextDecoder().decode(Jt("playground")).replace(Ai,()=>ze("script-engine")).replace("</noscript>",s=>r?s+qo(e.champions):
s);window.open(`${URL.createObjectURL(new Blob([o],{type:"text/html"}))}#${n}`)}function Ti(e,t){let{config:r,n_agents:n}=e,o=Math.max(0,t-1),s=i=>{let c=o*n+i,
u=o*r.n_evaders+i-r.n_pursuers,d=m=>i>=r.n_pursuers&&!!m[u];return{cell:[e.last_positions[2*c],e.last_positions[2*c+1]],gone:!e.alive[c],captured:d(e.captured),
everCaptured:d(e.ever_captured)}},a=Array.from({length:n},(i,c)=>s(c));return{rules:r.rules,others:null,rewards:r.rewards,rows:r.rows,cols:r.cols,diagonal:r.diagonal,
fov:r.fov,maxSteps:r.max_steps,seed:e.seed,episode:BigInt(e.episode),steps:o,ended:o===e.length,walls:Array.from(e.map.keys()).filter(i=>e.map[i]),pursuers:a.slice(
0,r.n_pursuers),evaders:a.slice(r.n_pursuers),played:[],next:Array.from(e.actions.subarray(o*n,(o+1)*n))}}var Ci=.005,ki=.05,Oi=["pursuer","evader"],Ri=4,Oe=new Map;function rs(e,t,r="capture-rate"){let n=JSON.stringify([{...t,rewards:null,fov:null},r]),o=Oe.get(n)??
(tt(t)?Promise.resolve(null):$i(e,t,r));return Oe.delete(n),Oe.set(n,o),Oe.size>Ri&&Oe.delete([...Oe.keys()][0]),o}var ts=()=>new Promise(e=>setTimeout(e));async function $i(e,t,r){await ts();let n=e.solution(t,r);for(;n.goBack();)await ts();return n}function ns(e,t,r){let{payoff:n}=e;
return r.flatMap((o,s)=>{let a=[0,0];for(let c=t.n_turns;c>0&&!t.over;c--)e.game(t)?.lost(o).forEach((u,d)=>a[d]+=u),t.playTurn(o);let i=n==="capture-rate"?Ci:ki;
return Oi.map((c,u)=>({step:s+1,team:c,lost:a[u],payoff:n})).filter(c=>c.lost>=i)})}var os=e=>e.map(t=>({step:t.step,kind:t.team,size:t.lost/Math.max(1,...e.map(
({lost:r})=>r)),text:Sr(t)})),Pi=({lost:e,payoff:t})=>t==="capture-rate"?`${e.toFixed(2)} of the capture rate`:`${e.toFixed(1)} steps`,Sr=e=>`The ${e.team}s los\
e ${Pi(e)} against a perfect opponent`;function ss(e,t,r){if(r===0)return[{kind:"start",text:_i(e),agents:[]}];let[n,o]=[t.moments[r-1],t.moments[r]],s=d=>H(d,e.config.n_pursuers),a=De(t,n,o),i=e.conflicts(
r),c=new Set(i.flatMap(d=>d.doomed)),u=a.map(d=>({kind:"capture",text:`${s(d)} is captured`,agents:[d]}));for(let d of ct(n,o))!a.includes(d)&&!c.has(d)&&u.push(
{kind:"end",text:`${s(d)} disappears`,agents:[d]});return u.push(...i.map(({kind:d,text:m,agents:p})=>({kind:d,text:m,agents:p}))),r===e.length&&u.unshift({kind:"\
end",text:Li(e),agents:[]}),u}function _i({config:e}){return`${e.n_pursuers} pursuers and ${e.n_evaders} evaders on ${e.rows} x ${e.cols} cells, at most ${e.max_steps}\
 steps`}function Li(e){let t=Math.round(e.statistics.capture_rate*e.config.n_evaders);return`The episode ends after ${e.length} steps with ${t} of ${e.config.n_evaders}\
 evaders captured`}var Ni=60,Ot=class{element;player=new Y(0,{speed:pt,still:se()});inspector;match=null;recording=null;actions;#e;#n;#t;#o;#s=l("h2",{class:"match-title"});#r=l("\
p",{class:"tally numbers"});#l=l("ol",{class:"words",tabindex:0,"aria-live":"off","aria-label":"What happened in this step"});#d=l("p",{class:"problem",role:"al\
ert"});#u=null;#p=null;#c=0;#a=!1;#m=0;#h=[];constructor(t,r,n){[this.#n,this.#t]=[t,r];let o=l("canvas",{"aria-label":"The match"});this.#e=new Me(o,{numbers:!1}),
this.#o=new Et(r),this.inspector=new Ct(s=>this.#b(s)),o.addEventListener("click",s=>this.inspector.choose(this.#e.agentAt(s.clientX,s.clientY))),this.actions=l(
"div",{class:"beside"},l("button",{type:"button",class:"to-play",title:"Move the chosen agent, or an evader, yourself from this step on (T)",onclick:()=>this.element.
dispatchEvent(new Event("takeover"))},"Take over"),es(()=>this.shown,n)),this.element=l("section",{class:"card match-card","aria-label":"Match",id:"match"},l("d\
iv",{class:"match"},l("header",{class:"match-head"},this.#s,this.#r),this.#d,l("div",{class:"stage"},o),l("div",{class:"aside"},this.#l,At(),this.actions,this.inspector.
element),Ae(this.player),this.#o.element)),this.player.addEventListener("frame",()=>this.recording&&this.#e.show(this.recording,this.player.time)),this.player.addEventListener(
"step",()=>this.#v()),r.on("match",()=>this.#x()),r.on("rest",()=>this.player.pause()),this.#y(),this.#S(0,0)}get#i(){return this.#n[this.#t.selected.run]}reveal(){
this.#e.canvas.scrollIntoView({block:"nearest"})}get shown(){return this.match&&this.#p&&{match:this.match,step:this.player.step,champions:this.#p}}start(t){this.#u=
t,this.#g()}playSoon(){this.#a=!0,this.#c||this.#f()}goTo(t){this.#m=t,!this.#c&&this.match&&this.#g()}#f(){!this.#a||!this.match||(this.#a=!1,this.player.jump(
0),se()||this.player.play())}#x(){this.#y(),clearTimeout(this.#c),this.#c=setTimeout(()=>this.#g(),Ni)}#g(){clearTimeout(this.#c),this.#c=0,this.player.pause(),
this.#y();let{selected:t}=this.#t,r=vn.map(s=>bn(this.#i,s,t[s])).find(Boolean)??"";if(this.#d.textContent=r,r||!this.#u)return;this.match=kt(this.#u,this.#i,t);
let[n,o]=this.names(t);this.#p={pursuer:{name:n,policy:G(this.#i,"pursuer",t.pursuer)},evader:{name:o,policy:G(this.#i,"evader",t.evader)}},this.recording=Mt(this.
match),this.#o.show(this.#i,this.match),this.inspector.show(this.#u,this.#i,this.match,t),this.player.length=this.match.length,this.player.marks=lt(this.recording),
this.#h=this.player.ticks=[],this.player.jump(this.#m),this.#m=0,this.#v(),this.#w(this.#u,this.match),this.element.dataset.played=`${t.run} ${t.pursuer} ${t.evader}\
 ${t.episode} ${t.seed??""}`,this.#f()}async#w(t,r){let n=await rs(t,r.config);if(this.match!==r||!n)return;let o=t.world(r.config);r.seek(o,0),this.#h=ns(n,o,Ii(
r)),o.free(),this.player.ticks=os(this.#h),this.inspector.solution=n,this.#v()}names({run:t,pursuer:r,evader:n}){let{teams:o}=this.#n[t];return[o.pursuer.script??
`pursuers ${r}`,o.evader.script??`evaders ${n}`]}#y(){let{episode:t,seed:r}=this.#t.selected,{payoff:n}=this.#i,[o,s]=this.names(this.#t.selected),a=r===null?t<
n.episodes?`episode ${t+1} of ${n.episodes}`:`episode ${t+1}, not part of the cell`:`seed ${r}`;this.#s.replaceChildren(l("span",{class:"pursuer"},o)," against ",
l("span",{class:"evader"},s),l("span",{class:"muted small"},a))}#v(){let t=this.match;if(!t||!this.recording)return;let r=this.player.step,n=this.recording.moments[r];
this.#S(Array.from(n.everCaptured).filter(Boolean).length,r),this.#l.replaceChildren(...this.#h.filter(o=>o.step===r).map(o=>l("li",{class:`loss-${o.team}`},Sr(
o))),...ss(t,this.recording,r).map(o=>l("li",{class:o.kind,"data-agents":o.agents.join(" ")},o.text))),this.inspector.at(r),this.#M()}#S(t,r){this.#r.replaceChildren(
l("strong",{},t),` of ${this.#i.world.n_evaders} captured`,l("span",{class:"muted"},` · step ${r}`))}#b(t){this.#e.look={selected:t,viewers:t===null?[]:[t]},this.#M()}#M(){
let t=this.inspector.agent;for(let r of this.#l.children){let n=r.dataset.agents?.split(" ")??[];r.classList.toggle("about",t!==null&&n.includes(String(t)))}}},
Ii=({actions:e,length:t,n_agents:r})=>Array.from({length:t},(n,o)=>e.subarray(o*r,(o+1)*r));var Fi={ArrowUp:[1,0],ArrowDown:[-1,0],ArrowRight:[0,1],ArrowLeft:[0,-1]},zi=5;function is(e,t,r,n="pursuer"){e.tabIndex=0,e.setAttribute("role","application"),
e.addEventListener("keydown",o=>{let s=Fi[o.key];if(!s)return;let[a,i]=n==="pursuer"?s:[s[1],s[0]],[c,u]=r(),d=o.shiftKey?zi:1,{pursuer:m,evader:p}=t.selected;t.
select({pursuer:as(m+d*a,c),evader:as(p+d*i,u)}),o.preventDefault(),o.stopPropagation()})}var as=(e,t)=>Math.min(t-1,Math.max(0,e));var Hi=24,Rt=7,cs=e=>e<Hi&&matchMedia("(pointer: coarse)").matches;function us(e,t,r,n){let[o,s]=e.payoff.shape,[a,i]=[ls(t,o),ls(r,s)],[c,u]=[Math.min(Rt,o),Math.
min(Rt,s)],d=[];for(let v=a+c-1;v>=a;v--){d.push(l("span",{class:"pursuer"},v));for(let g=i;g<i+u;g++)d.push(Di(e,v,g,n))}let m=Array.from({length:u},(v,g)=>l("\
span",{class:"evader"},i+g)),p=l("button",{type:"button","aria-label":"Close: all cells",onclick:()=>n(null)},"✕"),h=l("div",{class:"loupe numbers",role:"grou\
p","aria-label":"Cells around the tap"},...d,p,...m);return h.style.gridTemplateColumns=`2.4rem repeat(${u}, minmax(0, 1fr))`,h.addEventListener("click",v=>v.stopPropagation()),
h}function Di(e,t,r,n){let o=xe(e,t,r)?.rate,s=l("button",{type:"button","aria-label":`${C(o)}: pursuers ${t} against evaders ${r}`,onclick:()=>n({pursuer:t,evader:r})},
C(o));return o!==void 0&&([s.style.backgroundColor,s.style.color]=[ot(o),nt(o)]),s}var ls=(e,t)=>Math.max(0,Math.min(t-Rt,e-Math.floor(Rt/2)));var _={left:52,bottom:46,top:76,right:84},D=10,Wi=160,Ke=_.right-D-14,ce=_.top-D-14,$t=class{element;#e;#n;#t=l("canvas",{"aria-hidden":"true"});#o=f("svg",{"ar\
ia-hidden":"true"});#s=f("g");#r;#l=l("h2");#d=l("strong",{class:"rate numbers"});#u=l("span",{class:"small muted"});#p=l("p",{class:"of-both-teams small muted \
numbers"});#c=null;constructor(t,r){[this.#n,this.#e]=[t,r],this.#r=l("div",{class:"matrix",id:"matrix","aria-label":"Payoff matrix. Arrow keys choose a match, \
Enter plays it."},this.#t,this.#o);let n=l("header",{class:"readout","aria-live":"polite"},l("div",{},this.#l,this.#p),l("div",{class:"of-cell"},this.#d,this.#u));
this.element=l("section",{class:"card matrix-card","aria-label":"Payoff matrix"},n,this.#r,Q("0 all escape","1 all caught")),this.#x(),new ResizeObserver(()=>this.#m()).
observe(this.#r),this.#r.addEventListener("pointermove",o=>this.#y(o)),this.#r.addEventListener("pointerleave",()=>r.point({})),this.#r.addEventListener("click",
o=>this.#v(o)),this.#r.addEventListener("mousedown",o=>{o.preventDefault(),document.activeElement instanceof HTMLElement&&document.activeElement.blur()}),is(this.#r,
r,()=>this.#a.payoff.shape),this.#r.addEventListener("keydown",o=>{o.key==="Enter"&&this.#b()}),r.on("run",()=>this.#m()),r.on("match",()=>this.#f()),r.on("hove\
r",()=>this.#f())}get#a(){return this.#n[this.#e.selected.run]}#m(){let[t,r]=this.#a.payoff.shape,{clientWidth:n,clientHeight:o}=this.#r;if(n<50)return;let a=Math.
max(Wi,Math.min(n-_.left-_.right,o-_.top-_.bottom))/Math.max(t,r),i=Math.max(_.left,(n-r*a-_.right+_.left)/2),c=_.top+Math.max(0,(o-_.top-_.bottom-t*a)/2),u={width:n,
height:o,left:i,top:c,cell:a,rows:t,columns:r};this.#c=u,Ee(this.#t,this.#a.payoff,{left:i,top:c,width:r*a,height:t*a}),this.#o.setAttribute("viewBox",`0 0 ${n}\
 ${o}`),this.#o.replaceChildren(Ui(u),...Bi(u),...this.#i(u),this.#s),this.#f()}#h(t){let r=this.#a.findings?.generalization;if(!r)return[];let{selected:n,hover:o}=this.#e,
[s,a]=[o.pursuer??n.pursuer,o.evader??n.evader],[i,c]=ds(t,r.pursuers.mean[s]??0,s),[u,d]=ms(t,r.evaders.mean[a]??0,a);return[f("circle",{class:"dot of-pursuers",
cx:i,cy:c,r:5}),f("circle",{class:"dot of-evaders",cx:u,cy:d,r:5})]}#i(t){let r=this.#a.findings?.generalization;if(!r)return[];let{left:n,top:o,cell:s,rows:a,columns:i}=t,
[c,u]=[n+i*s+D,o-D],d={class:"side"};return[f("rect",{...d,x:c,y:o,width:Ke,height:a*s}),f("rect",{...d,x:n,y:u-ce,width:i*s,height:ce}),...ps(r.pursuers,(m,p)=>ds(
t,m,p),"of-pursuers"),...ps(r.evaders,(m,p)=>ms(t,m,p),"of-evaders"),f("text",{class:"tick",x:c,y:o+a*s+16,"text-anchor":"start"},"0"),f("text",{class:"tick",x:c+
Ke,y:o+a*s+16,"text-anchor":"end"},"1"),f("text",{class:"tick",x:n-6,y:u-4,"text-anchor":"end"},"0"),f("text",{class:"tick",x:n-6,y:u-ce+8,"text-anchor":"end"},
"1"),f("text",{class:"label of-pursuers",x:c+Ke,y:o+a*s+34,"text-anchor":"end"},"captures"),f("text",{class:"label of-evaders",x:n+i*s+D,y:u-ce+10,"text-anchor":"\
start"},"escapes")]}#f(){let t=this.#c;if(!t)return;let{selected:r,hover:n}=this.#e,{left:o,top:s,cell:a,rows:i,columns:c}=t,u=v=>s+(i-1-v)*a,d=[],m=(v,g)=>f("r\
ect",{class:g,x:o,y:u(v),width:c*a+D+Ke,height:a}),p=(v,g)=>f("rect",{class:g,x:o+v*a,y:s-D-ce,width:a,height:D+ce+i*a});d.push(m(r.pursuer,"strip pursuer"),p(r.
evader,"strip evader")),n.pursuer!==null&&n.pursuer<i&&d.push(m(n.pursuer,"strip hover")),n.evader!==null&&n.evader<c&&d.push(p(n.evader,"strip hover")),d.push(
...this.#h(t));let h={x:o+r.evader*a,y:u(r.pursuer),width:a,height:a};d.push(f("rect",{class:"chosen under",...h}),f("rect",{class:"chosen",...h})),this.#s.replaceChildren(
...d),this.#x()}#x(){let{selected:t,hover:r}=this.#e,n=r.pursuer??t.pursuer,o=r.evader??t.evader,s=xe(this.#a,n,o);this.#l.replaceChildren(l("span",{class:"purs\
uer"},`Pursuers ${n}`)," against ",l("span",{class:"evader"},`evaders ${o}`)),this.#d.textContent=s?C(s.rate,3):"-",this.#u.textContent=s?`capture rate, mean of\
 ${s.rates.length} episodes`:"the evaluation played no episodes",this.#p.textContent=this.#g(n,o)}#g(t,r){let n=this.#a.findings?.generalization;if(!n)return"";
let o=(s,a)=>mo(s.mean[a]??0,s.low?.[a]??null,s.high?.[a]??null);return`Against all: captures ${o(n.pursuers,t)}, escapes ${o(n.evaders,r)}`}#w(t){let r=this.#c;
if(!r)return null;let n=this.#r.getBoundingClientRect(),o=Math.floor((t.clientX-n.left-r.left)/r.cell),s=r.rows-1-Math.floor((t.clientY-n.top-r.top)/r.cell),[a,
i]=[s>=0&&s<r.rows,o>=0&&o<r.columns];return a||i?{g:a?s:-1,h:i?o:-1,inside:a&&i}:null}#y(t){let r=this.#w(t);this.#e.point(r?{pursuer:r.g<0?null:r.g,evader:r.h<
0?null:r.h}:{})}#v(t){let r=this.#w(t);if(r){if(r.inside&&cs(this.#c.cell))return this.#S(r.g,r.h);this.#e.select({...r.g<0?{}:{pursuer:r.g},...r.h<0?{}:{evader:r.
h}}),r.inside&&this.#b()}}#S(t,r){let n=us(this.#a,t,r,o=>{n.remove(),o&&(this.#e.select(o),this.#b())});this.#r.append(n)}#b(){this.#r.dispatchEvent(new CustomEvent(
"play",{bubbles:!0}))}};function Ui({left:e,top:t,cell:r,rows:n,columns:o}){let s=f("g",{class:"axes"}),a=t+n*r,i=c=>Ge(0,c-1,Math.min(c,c*r/44),!0);for(let c of i(
o))s.append(f("text",{class:"tick",x:e+(c+.5)*r,y:a+16,"text-anchor":"middle"},c));for(let c of i(n))s.append(f("text",{class:"tick",x:e-7,y:a-(c+.5)*r,"text-an\
chor":"end","dominant-baseline":"middle"},c));return s.append(f("text",{class:"label of-evaders",x:e+o*r/2,y:a+36,"text-anchor":"middle"},"evader generation"),f(
"text",{class:"label of-pursuers",transform:`translate(${e-36} ${t+n*r/2}) rotate(-90)`,"text-anchor":"middle"},"pursuer generation")),s}function Bi({left:e,top:t,
cell:r,rows:n,columns:o}){let s=f("g",{class:"diagonal"}),a=Math.min(n,o);if(a<3)return[];let i=t+n*r;for(let d of["H","V"]){let m=`M${e} ${i}`;for(let p=1;p<=a;p++){
let[h,v]=[`H${e+p*r}`,`V${i-p*r}`];m+=d==="H"?h+v:v+h}s.append(f("path",{d:m,class:"under"}),f("path",{d:m}))}let[c,u]=[e+a/2*r-.7*r-4,i-a/2*r-.7*r-4];return[s,
f("text",{class:"on-cells",transform:`translate(${c} ${u}) rotate(-45)`,"text-anchor":"middle"},"same generation")]}var ds=({left:e,top:t,cell:r,rows:n,columns:o},s,a)=>[
e+o*r+D+s*Ke,t+(n-a-.5)*r],ms=({left:e,top:t,cell:r},n,o)=>[e+(o+.5)*r,t-D-n*ce];function ps(e,t,r){let n=s=>s.map((a,i)=>t(a??0,i).map(c=>c.toFixed(1)).join(" ")),
o=[];return e.low&&e.high&&o.push(f("path",{class:`band ${r}`,d:`M${[...n(e.high),...n(e.low).reverse()].join("L")}Z`})),o.push(f("path",{class:`line ${r}`,d:`M${n(
e.mean).join("L")}`})),o}var Gi=84;function hs(e,t){let r=e.map((s,a)=>ji(s,a,t)),n=l("nav",{class:"races","aria-label":"Runs"},...r.map(s=>s.button)),o=()=>r.forEach((s,a)=>s.update(a===
t.selected.run));return t.on("match",o),t.on("hover",o),o(),n.hidden=e.length<2,n}function ji(e,t,r){let[n,o]=e.payoff.shape,s=!e.name.startsWith(e.schedule),a=Gi/
Math.max(n,o),i=l("canvas",{"aria-hidden":"true"});Ee(i,e.payoff,{left:0,top:0,width:o*a,height:n*a});let c=l("span",{class:"place"}),u=l("button",{type:"button",
class:"race",title:`${e.name} (key ${t+1})`,onclick:()=>qi(e,t,r)},l("span",{class:"small-matrix"},i,c),l("span",{class:"race-text"},l("strong",{},s?e.name:e.schedule),
l("span",{class:"small"},e.findings?e.findings.headline:`${e.learning.join(" and ")}s against ${Vi(e)}`),l("span",{class:"small muted"},`${s?`${e.schedule}, `:""}\
seed ${e.seed}`)));return{button:u,update:m=>{u.setAttribute("aria-current",String(m));let p=r.hover.pursuer??r.selected.pursuer,h=r.hover.evader??r.selected.evader;
c.hidden=p>=n||h>=o,c.style.left=`${(h+.5)*a}px`,c.style.top=`${(n-p-.5)*a}px`}}}var Vi=e=>e.teams.pursuer.script??e.teams.evader.script??"another run";function qi(e,t,r){
let[n,o]=e.payoff.shape,{pursuer:s,evader:a}=r.selected;r.select({run:t,pursuer:Math.min(s,n-1),evader:Math.min(a,o-1)})}var fs={pursuer:null,evader:null},Pt=class extends EventTarget{#e;#n=fs;constructor(t){super(),this.#e=t}get selected(){return this.#e}get hover(){return this.#n}select(t){
let r=this.#e,n=["run","pursuer","evader"].some(o=>o in t&&t[o]!==r[o]);this.#e={...r,...n?{episode:0,seed:null}:{},...t},this.#e.run!==r.run&&this.dispatchEvent(
new Event("run")),this.dispatchEvent(new Event("match"))}point(t){let r={...fs,...t};r.pursuer===this.#n.pursuer&&r.evader===this.#n.evader||(this.#n=r,this.dispatchEvent(
new Event("hover")))}on(t,r){this.addEventListener(t,r)}};var gs=1,Ki=8;function ys({runs:e},t){let r=e[gs],[n,o]=r.payoff.shape,s=new Y(0,{speed:Ki,still:se()}),a=l("canvas",{"aria-label":"The chase"}),i=l("p",{class:"\
numbers"}),c=new Me(a,{numbers:!1});return t.then(u=>{let d=kt(u,r,{run:gs,pursuer:n-1,evader:o-1,episode:0,seed:null}),m=Mt(d);s.addEventListener("frame",()=>c.
show(m,s.time)),s.addEventListener("step",()=>{let p=Array.from(m.moments[s.step].everCaptured).filter(Boolean).length;i.textContent=`Step ${s.step}: ${p} of ${r.
world.n_evaders} evaders captured`}),s.length=d.length,s.marks=lt(m),s.jump(0)}),l("div",{class:"widget chase"},l("div",{class:"stage"},a),i,Ae(s),At())}function vs({
runs:e,playground:t},r){let n=e[0].payoff.shape.map(u=>u-1),o=new Pt({run:0,pursuer:n[0],evader:n[1],episode:0,seed:null}),[s,a]=[new Ot(e,o,t),new $t(e,o)];s.actions.
remove(),a.element.addEventListener("play",()=>{s.playSoon(),s.reveal()}),r.then(u=>s.start(u));let{seed:i,world:c}=e[0];return l("div",{class:"widget wide"},hs(
e,o),l("div",{class:"stages"},a.element,s.element),l("p",{class:"small muted"},"Three races of ",l("code",{},`matrixworld evolve --seed ${i}`),`: ${c.n_pursuers}\
 pursuers and ${c.n_evaders} evaders on ${c.rows} x ${c.cols} cells.`))}function bs({runs:e}){let[t,r]=[e[0],e[0].findings],[n,...o]=r.table,s=o.findIndex(([i,,
,c])=>i==="arms race"&&c==="last half"),a={headline:t.name,numbers:[],table:[n,o[s]],reasons:[r.reasons[s]]};return l("div",{class:"widget text"},Do({...t,findings:{
...r,...a}}).element)}var W=32,xs=({crossings:e=[]})=>l("div",{class:"widget crossings"},...e.map(t=>l("figure",{},l("figcaption",{},t.title),Yi(t),l("p",{class:"small muted"},t.text))));
function Yi({title:e,text:t,ways:r}){let n=[0,1,2,3].map(o=>`M${o*W} 0V${3*W}M0 ${o*W}H${3*W}`).join("");return f("svg",{viewBox:`-1 -1 ${3*W+2} ${3*W+2}`,role:"\
img","aria-label":`${e}: ${t}`},f("path",{class:"grid",d:n}),...r.map(([o,s,a],i)=>f("g",{transform:`translate(${1.5*W} ${1.5*W})`},f("g",{transform:`translate(${-W*
s} ${-W*o})`},f("path",{class:"filled-pursuer",d:"M0 -12 12 9H-12z"}),f("text",{y:6.5,"text-anchor":"middle"},`P${i}`)),f("path",{class:a?"goes":"waits",d:a?"M-\
18 0H-5M-9 -4 -4 0 -9 4":"M-16 -13V13",transform:`rotate(${Math.atan2(o,s)*180/Math.PI})`}))))}var ws="matrixworld lesson",Mr={choices:[],solved:{},exit:"",done:!1},_t=class extends EventTarget{#e;keeps=!0;constructor(){super(),this.#e=this.#n(),this.#t({})}choice=t=>this.#e.
choices.find(({prediction:r})=>r===t)?.choice;choose(t,r){let n=new Date().toISOString().replace(/\.\d+Z$/,"+00:00");this.#t({choices:[...this.#e.choices,{prediction:t,
choice:r,time:n}]}),this.dispatchEvent(new CustomEvent("choice",{detail:t}))}solved=t=>this.#e.solved[t];solve=(t,r)=>this.#t({solved:{...this.#e.solved,[t]:r}});get exit(){
return this.#e}set exit(t){this.#t(t)}get count(){return this.#e.choices.length}get file(){return this.#e.choices.map(t=>`${JSON.stringify(t)}
`).join("")}forget(){this.#t(Mr)}#n(){try{return{...Mr,...JSON.parse(localStorage.getItem(ws)??"{}")}}catch{return Mr}}#t(t){this.#e={...this.#e,...t};try{localStorage.
setItem(ws,JSON.stringify(this.#e))}catch{this.keeps=!1}}};var Ye=e=>e!==void 0&&"predict"in e,Zi=e=>"outcome"in e&&!Ye(e),F=wn(),z=new _t,Ms=new Map(F.sections.flatMap(({parts:e})=>e.filter(Ye).map(t=>[t.predict,t]))),
Ji={chase:()=>ys(F,Ss),"right-of-way":xs,flat:xo,hands:ko,"hands-matrix":Oo,games:Io,numbers:Fo,matrices:()=>vo(F),explorer:()=>vs(F,Ss),judgement:()=>bs(F),"sa\
me-diagonal":bo,exit:e=>Cn(e,z)},Xi=e=>"widget"in e?e.needs:Zi(e)?e.outcome:void 0;function Qi(e){if("text"in e)return l("div",{class:"text"},...Qt(e.text));if("\
widget"in e)return Ji[e.widget](e);if("exercise"in e)return Tn(e,z);if(Ye(e))return En(e,z);let t=Ms.get(e.outcome);return l("div",{class:"prediction"},l("p",{},
l("strong",{},t.question)),er(t,z.choice(e.outcome)))}function el(e,t){let r=l("p",{class:"waiting muted",role:"status"}),n=l("section",{class:"card",id:e.id,"a\
ria-labelledby":`title-${e.id}`},l("h2",{id:`title-${e.id}`},`${t+1}. ${e.title}`,l("span",{class:"muted small"},`${e.minutes} minutes`)),r),o=0,s=()=>{for(r.textContent=
"";o<e.parts.length;o++){let[a,i]=[e.parts[o-1],e.parts[o]],c=[Ye(a)?a.predict:void 0,Xi(i)].find(u=>u&&z.choice(u)===void 0);if(c){let u=F.sections.findIndex(({
parts:d})=>d.some(m=>Ye(m)&&m.predict===c));r.textContent=`This section goes on with your prediction${u===t?"":` in section ${u+1}`}.`;return}r.before(Qi(i))}r.
remove()};return z.addEventListener("choice",s),s(),n}var As=()=>{},Ss=new Promise(e=>As=e),Es=l("span",{class:"small muted",role:"status"}),Ts=()=>{Es.textContent=
`${z.count} of ${Ms.size} predictions made. `+(z.keeps?"They stay in this browser.":"This browser keeps nothing: save before you close the page.")};z.addEventListener(
"choice",Ts);var tl=()=>{confirm("Delete all predictions and answers in this browser, for another student? Save them first.")&&(z.forget(),location.reload())};document.
getElementById("page").replaceWith(l("header",{class:"top"},l("div",{},l("h1",{},F.title),l("p",{class:"lead"},F.lead)),l("div",{class:"tools"},ln())),l("nav",{
class:"sections","aria-label":"Sections"},...F.sections.map((e,t)=>l("a",{href:`#${e.id}`},`${t+1}. ${e.title}`))),l("main",{},...F.sections.map(el)),l("footer",
{class:"card"},l("div",{class:"buttons"},l("button",{type:"button",class:"primary save",onclick:()=>tr("predictions.jsonl",z.file)},"Save my predictions"),l("bu\
tton",{type:"button",onclick:()=>print()},"Print"),l("button",{type:"button",onclick:tl},"Start anew"),Es),l("p",{class:"small muted"},`The page sends nothing a\
nywhere. matrixworld ${F.version}`)));Ts();requestAnimationFrame(()=>setTimeout(()=>{sn().then(As,e=>{document.querySelector("main").prepend(l("p",{class:"card \
problem",role:"alert"},`The engine does not start here: ${String(e)}`))}).finally(()=>document.body.dataset.ready="true")}));})();
