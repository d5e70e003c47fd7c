/* built from web/ by "npm run build"; sources eac5a9158e3f35629a29ba6baf0cb4b87f5142f0044d82fd29a31d25a8218b56 */
"use strict";(()=>{var Lr={SIMULTANEOUS:0,SWARM_TURNS:1,AGENT_TURNS:2},$e={DISAPPEAR:0,REACH:1,BOUNCE:2},Nr={OCCUPATION:0,SURROUND:1},Ir={FAULT:0,INVOLVED:1};var Fr=["obstacle","teammate","adversary"],zt=["vertex","edge","chain"],zr=["turn","kind","form","first","second","row","col","at_fault","held","doomed"],Ht=["p\
ursuer_{number}","evader_{number}"],Hr={obstacle:"{first} ran into the obstacle or border at {cell}",vertex:"{first} and {second} both headed for {cell}",edge:"\
{first} and {second} meant to swap, {first} to {cell}",chain:"{first} headed for {cell}, where {second} had to stay"},Pe={"both held":"both bounce","both doomed":"\
both disappear",held:"{agent} bounces",doomed:"{agent} disappears",none:"nobody is stopped"},Wr="{event}: {outcome}",Wt={random:"any action, all equally likely",
still:"always stays",chaser:"moves to where the nearest adversary in view is nearest",fleer:"moves to where the nearest adversary in view is farthest","clumsy-c\
haser":"a chaser that takes any action in half of the steps",hunter:"a chaser of the nearest adversary in view to which no teammate in view is nearer",surrounder:"\
a chaser of the nearest free cell beside an adversary without a teammate","clumsy-fleer":"a fleer that takes any action in half of the steps",dodger:"moves to w\
here all adversaries in view together are farthest","team-surrounder":"shares the free cells beside adversaries with its teammates, and searches","careful-rando\
m":"as random, but takes only moves that right of way allows","careful-chaser":"as chaser, but takes only moves that right of way allows","careful-fleer":"as fl\
eer, but takes only moves that right of way allows","careful-clumsy-chaser":"as clumsy-chaser, but takes only moves that right of way allows","careful-hunter":"\
as hunter, but takes only moves that right of way allows","careful-surrounder":"as surrounder, but takes only moves that right of way allows","careful-clumsy-fl\
eer":"as clumsy-fleer, but takes only moves that right of way allows","careful-dodger":"as dodger, but takes only moves that right of way allows","careful-team-\
surrounder":"as team-surrounder, but takes only moves that right of way allows"},Dr={free:".GS",blocked:"#@OTW"};var pe=1+zr.length;function _e(e,t){return e.replace(/\{(\w+)\}/g,(r,n)=>String(t[n]))}function H(e,t){return e<t?_e(Ht[0],{number:e}):_e(Ht[1],{number:e-t})}function No(e,t){
let[r,n,s,o,a,i,c,...u]=Array.from(e),d=a<0?[o]:[o,a],[m,p,h]=u.map(A=>d.filter((y,x)=>A>>x&1)),v=d.map(A=>H(A,t)),g=_e(Hr[a<0?"obstacle":zt[s]],{first:v[0],second:v[v.
length-1],cell:`(${i}, ${c})`}),b=_e(Wr,{event:g,outcome:Io(d.length,p,h,t)});return{kind:Fr[n],form:zt[s],agents:d,cell:[i,c],at_fault:m,held:p,doomed:h,turn:r,
text:b}}function Io(e,t,r,n){if(e===2&&t.length===2)return Pe["both held"];if(e===2&&r.length===2)return Pe["both doomed"];let s=o=>a=>_e(Pe[o],{agent:H(a,n)});
return[...t.map(s("held")),...r.map(s("doomed"))].join(", ")||Pe.none}function Je(e,t){let r=[];for(let n=0;n<e.length;n+=pe)r.push(No(e.subarray(n+1,n+pe),t));
return r}var te=class extends Error{name="EngineError"};function E(e,t,r){let n=typeof r=="string"?`'${r}'`:typeof r=="object"?JSON.stringify(r):String(r);return new te(
`${e}: expected ${t}, got ${n}`)}var he=class{bytes;constructor(t){this.bytes=t}},Gr=0,Ut=[Uint8Array,Uint8Array,Int32Array,BigInt64Array,BigUint64Array,Float32Array,Float64Array],Ur=4,Br=4,Fo=new TextEncoder,
zo=new TextDecoder;function Ho(e){for(let t=Ut.length-1;t>Gr;--t)if(e instanceof Ut[t])return t;throw new TypeError("array: expected a typed array of the engine\
's numbers, got another")}function Dt(e){return new Uint8Array(e.buffer,e.byteOffset,e.byteLength)}function Wo(e){return Fo.encode(`${e}\0`)}var Bt=class{engine;addresses=[];constructor(t){
this.engine=t}copy(t){let r=this.engine._malloc(Math.max(t.length,1));if(r===0)throw new te("memory: expected room for the arguments, got none");return this.addresses.
push(r),this.engine.HEAPU8.set(t,r),r}text(t){return this.copy(Wo(t))}arrays(t){let r=Object.entries(t),n=r.flatMap(([o,a])=>{let i=a instanceof he,c=i?a.bytes:
a;return[this.text(o),i?Gr:Ho(c),c.length,this.copy(Dt(c))]}),s=this.copy(Dt(Int32Array.from(n)));return this.copy(Dt(Int32Array.of(r.length,s)))}free(){for(let t of this.
addresses)this.engine._free(t)}};function jr(e,t){let r=e.HEAPU8;return zo.decode(r.subarray(t,r.indexOf(0,t)))}function fe(e){let t=new Int32Array(e.HEAPU8.buffer),
r=e._last_outputs()/Ur,n=t[r+1]/Ur,s={};for(let o=n;o<n+t[r]*Br;o+=Br){let a=Ut[t[o+1]],i=t[o+2]*a.BYTES_PER_ELEMENT,c=t[o+3];s[jr(e,t[o])]=new a(e.HEAPU8.slice(
c,c+i).buffer)}return s}function K(e,t){let r=new Bt(e);try{let n=t(r);if(n===0)throw new te(jr(e,e._last_error()));return n}finally{r.free()}}var Do=2**31-1,Vr=["none","elman","gru"],Uo=2n**64n-1n,Bo=34028234663852886e22;function U(e,t){if(typeof t!="number"||!Number.isInteger(t)||Math.abs(t)>Do)throw E(
e,"an integer",t);return Int32Array.of(t)}function Xe(e,t){if(typeof t!="boolean")throw E(e,"true or false",t);return new he(Uint8Array.of(Number(t)))}function re(e,t,r){
let n=typeof t=="string"&&Object.hasOwn(r,t)?r[t]:void 0;if(n===void 0)throw E(e,`one of ${Object.keys(r).join(", ")}`,t);return Int32Array.of(n)}function Gt(e,t){
if(typeof t!="number"||!(Math.abs(t)<=Bo))throw E(e,"a finite number",t);return t}function ge(e,t){let n=typeof t=="bigint"||typeof t=="number"&&Number.isSafeInteger(
t)?BigInt(t):-1n;if(n<0n||n>Uo)throw E(e,"an integer from 0 to 2^64 - 1",t);return BigUint64Array.of(n)}function Go(e){return{"rules.interaction":re("interactio\
n",e.interaction,Lr),"rules.obstacle":re("obstacle",e.obstacle,$e),"rules.teammate":re("teammate",e.teammate,$e),"rules.evader":re("evader",e.evader,$e),"rules.\
pursuer":re("pursuer",e.pursuer,$e),"rules.capture":re("capture",e.capture,Nr),"rules.captured_disappear":Xe("captured_disappear",e.captured_disappear)}}function qr(e,t){
let r=typeof t=="number"?[t,t,t]:t;if(!Array.isArray(r)||r.length!==3)throw E(e,"1 or 3 numbers",t);return Float32Array.from(r,n=>Gt(e,n))}function jo(e){let t=(r,n)=>Float32Array.
of(Gt(r,e[r]),Gt(n,e[n]));return{"rewards.capture":t("pursuer_capture","evader_capture"),"rewards.neighbor":t("pursuer_neighbor","evader_neighbor"),"rewards.ste\
p":t("pursuer_step","evader_step"),"rewards.pursuer_collide":qr("pursuer_collide",e.pursuer_collide),"rewards.evader_collide":qr("evader_collide",e.evader_collide),
"rewards.blame":re("blame",e.blame,Ir),"rewards.capture_repeats":Xe("capture_repeats",e.capture_repeats)}}function Yr(e){if(e===void 0||typeof e=="number")return new Uint8Array(
0);if(e instanceof Uint8Array)return e;let{free:t,blocked:r}=Dr;for(let[n,s]of e.entries()){if(s.length!==e[0]?.length)throw E(`map, row ${n}`,`${e[0]?.length} \
cells as in row 0`,s.length);let o=[...s].find(a=>!t.includes(a)&&!r.includes(a));if(o)throw E(`map, row ${n}`,`'${t}' (free) or '${r}' (obstacle)`,o)}return Uint8Array.
from([...e.join("")],n=>Number(r.includes(n)))}function Zr(e,t){if(!Array.isArray(e))return;let r=[e.length,e[0]?.length??0];if(!(r[0]===t.rows&&r[1]===t.cols))
throw E("obstacle map",`shape (${t.rows}, ${t.cols}), the rows and cols`,r)}function ye(e){Zr(e.obstacles,e);let t=typeof e.obstacles=="number"?e.obstacles:0;return{
...Go(e.rules),...jo(e.rewards),rows:U("rows",e.rows),cols:U("cols",e.cols),n_pursuers:U("n_pursuers",e.n_pursuers),n_evaders:U("n_evaders",e.n_evaders),fov:U("\
fov",e.fov),diagonal:Xe("diagonal",e.diagonal),max_steps:U("max_steps",e.max_steps),density:Float64Array.of(t),map:Yr(e.obstacles)}}function Kr(e,t){return Int32Array.
from((t??[]).flat(),r=>U(e,r)[0])}function Jr(e,t){return Zr(e.obstacles,t),{seed:ge("seed",e.seed??0n),episode:ge("episode",e.episode??0),pursuers:Kr("pursuers",
e.pursuers),evaders:Kr("evaders",e.evaders),map:Yr(e.obstacles)}}function Qe(e){return{actions:Int32Array.from(e,t=>U("actions",t)[0])}}function ve(e){if(typeof e==
"string"){if(!Object.hasOwn(Wt,e))throw E("policy",`one of ${Object.keys(Wt).join(", ")}`,e);return{script:new TextEncoder().encode(e)}}if(e.activation!=="relu"&&
e.activation!=="tanh")throw E("activation","'relu' or 'tanh'",e.activation);if(!Vr.includes(e.memory))throw E("memory",`one of ${Vr.join(", ")}`,e.memory);return{
hidden:Int32Array.from(e.hidden,t=>U("hidden",t)[0]),activation:new TextEncoder().encode(e.activation),sampled:Xe("sampled",e.sampled),memory:new TextEncoder().
encode(e.memory),genome:e.genome}}var Vo=["first_turn","terminated","truncated"];function Xr(e){let t={...e};for(let r of Vo)t[r]=new he(e[r]);return t}var Qr="statistics.",et=class{config;seed;episode;n_agents;statistics;first_conflict;constructor(t,r,n,s){this.config=t,this.seed=r,this.episode=n,this.n_agents=
t.n_pursuers+t.n_evaders,this.statistics=en(tn(s),0),Object.assign(this,s),this.first_conflict=qo(this.conflict_table,this.length)}get length(){return this.actions.
length/this.n_agents}conflicts(t){this.check(t);let[r,n]=[this.first_conflict[t],this.first_conflict[t+1]],s=this.conflict_table.subarray(r*pe,n*pe);return Je(s,
this.config.n_pursuers)}seek(t,r,n){this.check(r),(!(t.seed===this.seed&&t.episode===BigInt(this.episode))||t.turn!==0||t.steps>r)&&t.reset({seed:this.seed,episode:this.
episode});for(let o=t.steps;o<r;++o){let a=this.actions.subarray(o*this.n_agents,(o+1)*this.n_agents);n?t.replay(a,{pursuer:n.pursuers,evader:n.evaders}):t.step(
a)}}check(t){if(!(Number.isInteger(t)&&t>=0&&t<=this.length))throw E("step",`0 to ${this.length}`,t)}};function qo(e,t){let r=new Int32Array(t+2);for(let n=0;n<
e.length;n+=pe)++r[e[n]+1];for(let n=1;n<r.length;++n)r[n]+=r[n-1];return r}function en(e,t){let r=e.length.length,n=o=>{let a=e[o],i=a.length/r;return a.slice(
t*i,(t+1)*i)},s=o=>Number(n(o)[0]);return{capture_rate:s("capture_rate"),ever_capture_rate:s("ever_capture_rate"),captured_fraction:s("captured_fraction"),length:s(
"length"),return:n("return"),survivors:n("survivors"),overlap:n("overlap"),collisions:n("collisions"),faults:n("faults"),agent_steps:n("agent_steps")}}var tn=e=>Object.
fromEntries(Object.entries(e).flatMap(([t,r])=>t.startsWith(Qr)?[[t.slice(Qr.length),r]]:[]));function rn(e,t,r,n){let s=[ye(r.config),ve(r.pursuers),ve(r.evaders),
n];return K(e,o=>{let[a,i,c,u]=s.map(d=>o.arrays(d));return e[t](a,i,c,u)}),fe(e)}function nn(e,t,r,n){let s={seed:ge("seed",r),episode:ge("episode",n)};return new et(
t.config,r,n,rn(e,"_play_match",t,s))}function jt(e,t,r,n){if(!Number.isInteger(n)||n<1)throw E("n_episodes","at least 1",n);let s=rn(e,"_play_rollout",t,{...r,
n_episodes:Int32Array.of(n)});return tn(s)}function sn(e,t,r,n){let s={pursuer:Int32Array.of(0),evader:Int32Array.of(0),seed:ge("seed",r)},o=jt(e,t,s,n);return Array.
from({length:n},(a,i)=>en(o,i))}var Ko=7e6,Yo=new FinalizationRegistry(([e,t])=>e._states_free(t));function Zo({rules:e,rows:t,cols:r,obstacles:n,diagonal:s,n_pursuers:o,n_evaders:a}){let i=typeof n==
"number"||e.obstacle==="REACH"?0:n.join("").split("#").length-1,c=t*r-i,u=[e.obstacle,e.teammate,e.pursuer].includes("DISAPPEAR"),d=e.capture==="SURROUND"||e.evader===
"REACH",m=e.interaction==="AGENT_TURNS",p=(g,b)=>Array.from({length:b},(A,y)=>m?g:(g+y)/(y+1)).reduce((A,y)=>A*y,1),h=p(c+Number(u),o)*p(c*(1+Number(d))+2,a);return{
SIMULTANEOUS:[o+a],SWARM_TURNS:[o,a],AGENT_TURNS:Array(o+a).fill(1)}[e.interaction].reduce((g,b)=>g+h*(s?9:5)**b,0)}function tt(e){return typeof e.obstacles=="n\
umber"&&e.obstacles>0?"obstacles are drawn anew in each episode":Zo(e)>Ko?"the world is too large to be solved on the page":""}var Vt=class{value;teams;matrix;n_actions;constructor(t,r){
let{matrix:n,rows:s,cols:o,value:a,agents:i}=r,[c,u]=t.actors,d=Array.from(i).filter(p=>c<=p&&p<u),m=p=>p<t.config.n_pursuers;[this.value,this.matrix,this.n_actions]=
[a[0],n,t.n_actions],this.teams=[{agents:d.filter(m),play:s},{agents:d.filter(p=>!m(p)),play:o}]}marginal(t){let r=this.teams.find(({agents:o})=>o.includes(t));
if(!r)return null;let n=this.n_actions**(r.agents.length-1-r.agents.indexOf(t)),s=Array(this.n_actions).fill(0);return r.play.forEach((o,a)=>s[Math.floor(a/n)%this.
n_actions]+=o),s}lost(t){let[r,n]=this.teams.map(({agents:c})=>c.reduce((u,d)=>u*this.n_actions+t[d],0)),[s,o]=this.teams.map(({play:c})=>c),a=o.reduce((c,u,d)=>c+
u*this.matrix[r*o.length+d],0),i=s.reduce((c,u,d)=>c+u*this.matrix[d*o.length+n],0);return[Math.max(0,this.value-a),Math.max(0,i-this.value)]}},on=60,Le=class{config;payoff;engine;states;n_turns;values;constructor(t,r,n){
[this.engine,this.config,this.payoff]=[t,r,n],this.states=K(t,a=>t._states_new(a.arrays(ye(r)))),Yo.register(this,[t,this.states]);let s={SIMULTANEOUS:1,SWARM_TURNS:2,
AGENT_TURNS:r.n_pursuers+r.n_evaders};this.n_turns=s[r.rules.interaction];let o=this.call(()=>t._states_payoffs(this.states)).payoffs;this.values=[[n==="capture\
-rate"?o:o.fill(0)]]}goBack(){let t=this.values.at(-1)[0],r=[];for(let s=this.n_turns-1;s>=0;s--){let o=r[s+1]??t;r[s]=this.call(a=>this.engine._states_backup(this.
states,s,a.arrays({next:o}))).values}this.payoff==="capture-time"&&(r[0]=r[0].map((s,o)=>o===this.config.n_evaders?0:s-1)),this.values.push(r);let n=this.payoff===
"capture-rate"?this.config.max_steps:Math.min(this.config.max_steps,on);return this.values.length<=n&&r[0].some((s,o)=>s!==t[o])}game(t){let[r,{turn:n}]=[this.config.
max_steps-t.steps,t],s=n+1===this.n_turns,o=r>0?this.values[Math.min(r-Number(s),this.values.length-1)]?.[s?0:n+1]:void 0;if(!o)return null;let a=this.call(i=>this.
engine._states_game(this.states,t.address,i.arrays({next:o})));return a.agents.length?new Vt(t,a):null}call(t){return K(this.engine,t),fe(this.engine)}};var an=new FinalizationRegistry(([e,t])=>e._world_free(t)),Ne=class{config;n_agents;n_actions;engine;at;freed=!1;constructor(t,r){this.engine=t,this.config=r,this.
n_agents=r.n_pursuers+r.n_evaders,this.n_actions=r.diagonal?9:5,this.at=K(t,n=>t._world_new(n.arrays(ye(r)))),an.register(this,[t,this.at],this)}free(){this.freed||
(this.freed=!0,an.unregister(this),this.engine._world_free(this.at))}get address(){if(this.freed)throw E("world","one that is in use","one that was freed");return this.
at}reset(t={}){let r=Jr(t,this.config);this.call(n=>this.engine._world_reset(this.address,n.arrays(r)))}step(t){let r=Qe(t);this.call(n=>this.engine._world_step(
this.address,n.arrays(r)))}playTurn(t){let r=Qe(t);this.call(n=>this.engine._world_play_turn(this.address,n.arrays(r)))}decide(t,r,n){let{n_pursuers:s}=this.config,
o={pursuer:[0,s],evader:[s,this.n_agents]},[a,i]=typeof r=="string"?o[r]:r;if(n.length!==this.n_agents)throw E("actions",String(this.n_agents),n.length);let c=[
ve(t),Qe(n)],{actions:u}=this.call(d=>this.engine._world_decide(this.address,d.arrays(c[0]),a,i,d.arrays(c[1])));return Uint8Array.from(u)}replay(t,r){let n=o=>typeof o!=
"string"&&o.memory!=="none";if(!n(r.pursuer)&&!n(r.evader))return this.step(t);let{n_pursuers:s}=this.config;for(let o=this.n_turns;o>0;--o){let[a,i]=this.actors;
a<s&&this.decide(r.pursuer,[a,Math.min(i,s)],t),i>s&&this.decide(r.evader,[Math.max(a,s),i],t),this.playTurn(t)}}get n_turns(){return this.turnNumbers()[1]}get turn(){
return this.turnNumbers()[0]}get actors(){let[,,t,r]=this.turnNumbers();return[t,r]}turnNumbers(){return this.call(()=>this.engine._world_turn(this.address)).turn}get steps(){
return this.read("steps")[0]}get seed(){return this.read("seed")[0]}get episode(){return this.read("episode")[0]}get over(){return this.read("terminated")[0]===
1||this.read("truncated")[0]===1}read(t){return this.call(r=>this.engine._world_read(this.address,r.text(t)))[t]}view(t){let r=3*this.config.fov**2;return this.
read("views").slice(t*r,(t+1)*r)}map(){return this.read("state").slice(2*this.config.rows*this.config.cols)}conflicts(){return Je(this.conflictTable(),this.config.
n_pursuers)}conflictTable(){return this.call(()=>this.engine._world_conflicts(this.address)).conflict_table}answer(t,r){let n=ve(t),{logits:s,memory:o}=this.call(
c=>this.engine._world_logits(this.address,c.arrays(n),r)),a=s,i=this.decide(t,[r,r+1],new Uint8Array(this.n_agents))[r];return{logits:a,probabilities:Jo(a),action:i,
memory:o}}snapshot(){return this.call(()=>this.engine._world_snapshot(this.address))}restore(t){let r=Xr(t);this.call(n=>this.engine._world_restore(this.address,
n.arrays(r)))}call(t){return K(this.engine,t),fe(this.engine)}};function Jo(e){let t=Math.max(...e),r=Array.from(e,s=>Math.exp(s-t)),n=r.reduce((s,o)=>s+o,0);return Float32Array.
from(r,s=>s/n)}var qt=class{compiled;constructor(t){this.compiled=t}world(t){return new Ne(this.compiled,t)}solution(t,r="capture-rate"){return new Le(this.compiled,t,r)}match(t,r,n,s,o=0){
return nn(this.compiled,{config:t,pursuers:r,evaders:n},s,o)}rollout(t,r,n,s,o){return sn(this.compiled,{config:t,pursuers:r,evaders:n},s,o)}rollouts(t,r,n,s,o){
return jt(this.compiled,{config:t,pursuers:r,evaders:n},s,o)}},ln;function cn(e=globalThis.matrixworldEngine){return ln??=Xo(e),ln}async function Xo(e){if(!e)throw new Error(
"matrixworldEngine: expected the script engine.js before this one, got none");let t=Uint8Array.from(atob(e.binary),r=>r.charCodeAt(0));return new qt(await e({wasmBinary:t}))}var Qo="http://www.w3.org/2000/svg";function l(e,t={},...r){return un(document.createElement(e),t,r)}function f(e,t={},...r){return un(document.createElementNS(
Qo,e),t,r)}function un(e,t,r){for(let[n,s]of Object.entries(t))s==null||s===!1||(typeof s=="function"?e.addEventListener(n.slice(2),s):e.setAttribute(n,s===!0?"":
String(s)));return e.append(...r.filter(ea).map(n=>typeof n=="number"?String(n):n)),e}function ea(e){return e!=null&&e!==!1}function ta(){let e=document.documentElement.dataset.theme;return e?e==="dark":matchMedia("(prefers-color-scheme: dark)").matches}function ra(){document.documentElement.
dataset.theme=ta()?"light":"dark"}function dn(){return l("button",{type:"button",title:"Light or dark (D)","aria-label":"Light or dark",onclick:ra},"◐")}var R=Uint8Array,be=Uint16Array,na=Int32Array,mn=new R([0,0,0,0,0,0,0,0,1,1,1,1,2,2,2,2,3,3,3,3,4,4,4,4,5,5,5,5,0,0,0,0]),pn=new R([0,0,0,0,1,1,2,2,3,3,4,4,5,5,
6,6,7,7,8,8,9,9,10,10,11,11,12,12,13,13,0,0]),sa=new R([16,17,18,0,8,7,9,6,10,5,11,4,12,3,13,2,14,1,15]),hn=function(e,t){for(var r=new be(31),n=0;n<31;++n)r[n]=
t+=1<<e[n-1];for(var s=new na(r[30]),n=1;n<30;++n)for(var o=r[n];o<r[n+1];++o)s[o]=o-r[n]<<5|n;return{b:r,r:s}},fn=hn(mn,2),gn=fn.b,oa=fn.r;gn[28]=258,oa[258]=28;
var yn=hn(pn,0),aa=yn.b,Ul=yn.r,Zt=new be(32768);for(w=0;w<32768;++w)B=(w&43690)>>1|(w&21845)<<1,B=(B&52428)>>2|(B&13107)<<2,B=(B&61680)>>4|(B&3855)<<4,Zt[w]=((B&
65280)>>8|(B&255)<<8)>>1;var B,w,Ie=(function(e,t,r){for(var n=e.length,s=0,o=new be(t);s<n;++s)e[s]&&++o[e[s]-1];var a=new be(t);for(s=1;s<t;++s)a[s]=a[s-1]+o[s-
1]<<1;var i;if(r){i=new be(1<<t);var c=15-t;for(s=0;s<n;++s)if(e[s])for(var u=s<<4|e[s],d=t-e[s],m=a[e[s]-1]++<<d,p=m|(1<<d)-1;m<=p;++m)i[Zt[m]>>c]=u}else for(i=
new be(n),s=0;s<n;++s)e[s]&&(i[s]=Zt[a[e[s]-1]++]>>15-e[s]);return i}),Fe=new R(288);for(w=0;w<144;++w)Fe[w]=8;var w;for(w=144;w<256;++w)Fe[w]=9;var w;for(w=256;w<
280;++w)Fe[w]=7;var w;for(w=280;w<288;++w)Fe[w]=8;var w,vn=new R(32);for(w=0;w<32;++w)vn[w]=5;var w;var ia=Ie(Fe,9,1);var la=Ie(vn,5,1),Kt=function(e){for(var t=e[0],r=1;r<e.length;++r)e[r]>t&&(t=e[r]);return t},L=function(e,t,r){var n=t/8|0;return(e[n]|e[n+1]<<8)>>(t&7)&r},Yt=function(e,t){
var r=t/8|0;return(e[r]|e[r+1]<<8|e[r+2]<<16)>>(t&7)},ca=function(e){return(e+7)/8|0},ua=function(e,t,r){return(t==null||t<0)&&(t=0),(r==null||r>e.length)&&(r=e.
length),new R(e.subarray(t,r))};var da=["unexpected EOF","invalid block type","invalid length/literal","invalid distance","stream finished","no stream handler",,"no callback","invalid UTF-8 da\
ta","extra field too long","date not in range 1980-2099","filename too long","stream finishing","invalid zip data"],N=function(e,t,r){var n=new Error(t||da[e]);
if(n.code=e,Error.captureStackTrace&&Error.captureStackTrace(n,N),!r)throw n;return n},ma=function(e,t,r,n){var s=e.length,o=n?n.length:0;if(!s||t.f&&!t.l)return r||
new R(0);var a=!r,i=a||t.i!=2,c=t.i;a&&(r=new R(s*3));var u=function($r){var Pr=r.length;if($r>Pr){var _r=new R(Math.max(Pr*2,$r));_r.set(r),r=_r}},d=t.f||0,m=t.
p||0,p=t.b||0,h=t.l,v=t.d,g=t.m,b=t.n,A=s*8;do{if(!h){d=L(e,m,1);var y=L(e,m+1,3);if(m+=3,y)if(y==1)h=ia,v=la,g=9,b=5;else if(y==2){var k=L(e,m,31)+257,ue=L(e,m+
10,15)+4,j=k+L(e,m+5,31)+1;m+=14;for(var V=new R(j),Lt=new R(19),O=0;O<ue;++O)Lt[sa[O]]=L(e,m+O*3,7);m+=ue*3;for(var Er=Kt(Lt),Ro=(1<<Er)-1,$o=Ie(Lt,Er,1),O=0;O<
j;){var Tr=$o[L(e,m,Ro)];m+=Tr&15;var x=Tr>>4;if(x<16)V[O++]=x;else{var de=0,Ze=0;for(x==16?(Ze=3+L(e,m,3),m+=2,de=V[O-1]):x==17?(Ze=3+L(e,m,7),m+=3):x==18&&(Ze=
11+L(e,m,127),m+=7);Ze--;)V[O++]=de}}var Cr=V.subarray(0,k),q=V.subarray(k);g=Kt(Cr),b=Kt(q),h=Ie(Cr,g,1),v=Ie(q,b,1)}else N(1);else{var x=ca(m)+4,S=e[x-4]|e[x-
3]<<8,M=x+S;if(M>s){c&&N(0);break}i&&u(p+S),r.set(e.subarray(x,M),p),t.b=p+=S,t.p=m=M*8,t.f=d;continue}if(m>A){c&&N(0);break}}i&&u(p+131072);for(var Po=(1<<g)-1,
_o=(1<<b)-1,Nt=m;;Nt=m){var de=h[Yt(e,m)&Po],me=de>>4;if(m+=de&15,m>A){c&&N(0);break}if(de||N(2),me<256)r[p++]=me;else if(me==256){Nt=m,h=null;break}else{var kr=me-
254;if(me>264){var O=me-257,Re=mn[O];kr=L(e,m,(1<<Re)-1)+gn[O],m+=Re}var It=v[Yt(e,m)&_o],Ft=It>>4;It||N(3),m+=It&15;var q=aa[Ft];if(Ft>3){var Re=pn[Ft];q+=Yt(e,
m)&(1<<Re)-1,m+=Re}if(m>A){c&&N(0);break}i&&u(p+131072);var Or=p+kr;if(p<q){var Rr=o-q,Lo=Math.min(q,Or);for(Rr+p<0&&N(3);p<Lo;++p)r[p]=n[Rr+p]}for(;p<Or;++p)r[p]=
r[p-q]}}t.l=h,t.p=Nt,t.b=p,t.f=d,h&&(d=1,t.m=g,t.d=v,t.n=b)}while(!d);return p!=r.length&&a?ua(r,0,p):r.subarray(0,p)};var pa=new R(0);var ha=function(e,t){return((e[0]&15)!=8||e[0]>>4>7||(e[0]<<8|e[1])%31)&&N(6,"invalid zlib data"),(e[1]>>5&1)==+!t&&N(6,"invalid zlib data: "+(e[1]&32?"need":"u\
nexpected")+" dictionary"),(e[1]>>3&4)+2};function bn(e,t){return ma(e.subarray(ha(e,t&&t.dictionary),-4),{i:2},t&&t.out,t&&t.dictionary)}var fa=typeof TextDecoder<"u"&&new TextDecoder,ga=0;try{fa.decode(pa,{stream:!0}),ga=1}catch{}var wn=["pursuer","evader"];function xe(e,t,r){let[n,s]=[t-e.payoff.first[0],r-e.payoff.first[1]],o=e.payoff.capture_rate[n]?.[s];return o===void 0?null:{rate:o,rates:e.payoff.capture_rates[n][s],
lengths:e.payoff.lengths[n][s]}}function Sn(e,t,r){let{script:n,network:s,kept:o,genomes:a}=e.teams[t];if(n!==null||s===null)return"";if(!o.includes(r))return`T\
he page holds no genome of ${t}s ${r}: it would be too large. Choose a generation of ${o.join(", ")}.`;let i=o.length*s.genome_size;return Mn(a,s.genome_size).length===
i?"":`The page is damaged: it does not hold the ${i} numbers of the ${t}s' genomes. Write it again from its run.`}function G(e,t,r){let{script:n,network:s,kept:o,
genomes:a}=e.teams[t];if(n!==null||s===null)return n??"random";let i=o.indexOf(r);if(i<0)throw new RangeError(`${t}: expected a generation whose genome the page\
 holds, got ${r}`);let c=s.genome_size,u=Mn(a,c).subarray(i*c,(i+1)*c),{hidden:d,activation:m,sampled:p,memory:h}=s;return{hidden:d,activation:m,sampled:p,memory:h,
genome:u}}var Jt=4,xn=new Map;function Mn(e,t){let r=xn.get(e);if(r)return r;let n=new Float32Array;try{let s=va(Xt(e),t);s.every(Number.isFinite)&&(n=s)}catch(s){if(!(s instanceof DOMException||
s instanceof RangeError||ya(s)))throw s}return xn.set(e,n),n}var ya=e=>e instanceof Error&&"code"in e;function va(e,t){let r=bn(e),n=r.length/Jt,s=new Uint8Array(
r.length);for(let a=0;a<s.length;a++)s[a]=r[a%Jt*n+Math.floor(a/Jt)];let o=new Uint32Array(s.buffer);for(let a=t;a<o.length;a++)o[a]^=o[a-t];return new Float32Array(
s.buffer)}function Xt(e){let t=atob(ze(e)),r=new Uint8Array(t.length);for(let n=0;n<r.length;n++)r[n]=t.charCodeAt(n);return r}function ze(e){return document.getElementById(
e)?.textContent??""}var An=()=>JSON.parse(ze("data"));var He=[[68,1,84],[72,26,108],[71,47,125],[65,68,135],[57,86,140],[49,104,142],[42,120,142],[35,136,142],[31,152,139],[34,168,132],[53,183,121],[84,197,104],[122,
209,81],[165,219,54],[210,226,27],[253,231,37]];function rt(e){let t=Math.min(1,Math.max(0,e))*(He.length-1),r=Math.min(He.length-2,Math.floor(t)),[n,s]=[He[r],
He[r+1]],o=a=>Math.round(n[a]+(t-r)*(s[a]-n[a]));return[o(0),o(1),o(2)]}function nt(e){let[t,r,n]=rt(e).map(s=>((s/255+.055)/1.055)**2.4);return .2126*t+.7152*r+
.0722*n>.179?"#000":"#fff"}var st=e=>`rgb(${rt(e).join(" ")})`,En=()=>`linear-gradient(to right, ${He.map(e=>`rgb(${e.join(" ")})`).join(", ")})`;var Cn=e=>e.answer===void 0?xa():ba(e,e.answer);function ba(e,t){let r=l("input",{type:"text",inputmode:"decimal",size:8,"aria-label":"Your answer, a number",autocomplete:"\
off"});return{input:r,check:()=>{let s=r.value.trim().replace(",","."),o=Number(s);if(s===""||Number.isNaN(o))return"Expected a number, such as 0.5.";let a=i=>Math.
abs(o-i)<=(e.tolerance??0)+1e-9;return a(t)?null:e.clues?.find(([i])=>a(i))?.[1]??e.otherwise??"Expected another number."},answer:()=>r.value,set:s=>r.value=s}}
var I=4,Qt=[.5,.8,.2];function xa(){let e=new Array(I*I).fill(.5),t=(c,u)=>{c.textContent=e[u].toFixed(1),c.ariaLabel=`pursuers ${Math.floor(u/I)} against evade\
rs ${u%I}: ${c.textContent}`,[c.style.background,c.style.color]=[st(e[u]),nt(e[u])]},r=e.map((c,u)=>{let d=l("button",{type:"button",disabled:u%(I+1)===0,onclick:()=>{
e[u]=Qt[(Qt.indexOf(e[u])+1)%Qt.length],t(d,u)}});return t(d,u),d}),n=Array.from({length:I},(c,u)=>u),s=l("div",{class:"cells numbers",role:"group","aria-label":"\
Capture rates: rows are pursuers, columns evaders"},l("span"),...n.map(c=>l("span",{class:"evader"},`evaders ${c}`)),...n.flatMap(c=>[l("span",{class:"pursuer"},
`pursuers ${c}`),...r.slice(c*I,(c+1)*I)])),o=c=>n.map(u=>n.reduce((d,m)=>d+e[c(u,m)],0)/I);return{input:s,check:()=>{let c=o((m,p)=>m*I+p),u=o((m,p)=>p*I+m),d=(m,p)=>m.
every((h,v)=>!v||p*(h-m[v-1])>1e-9);return d(c,1)?d(u,-1)?null:`The means of the columns are ${Tn(u)}. They say how often the evaders are captured, and should f\
all from column to column.`:`The means of the rows are ${Tn(c)}. They are the strengths of the pursuers, and should grow from row to row.`},answer:()=>e.join(" "),
set:c=>{c.split(" ").forEach((u,d)=>e[d]=Number(u)),r.forEach(t)}}}var Tn=e=>e.map(t=>t.toFixed(2)).join(", ");var er=e=>e.trim().split(/\n\s*\n/).map(t=>l("p",{},...ot(t))),ot=e=>e.split("**").map((t,r)=>r%2?l("strong",{},t):document.createTextNode(t));function kn(e,t){
let{predict:r,options:n}=e,s=l("p",{class:"small muted",role:"status"}),o=l("button",{type:"submit",class:"primary"},"This is my prediction"),a=Object.keys(n).map(
u=>l("input",{type:"radio",name:`prediction-${r}`,value:u})),i=l("form",{class:"prediction",id:`prediction-${r}`},l("fieldset",{},l("legend",{},l("strong",{},"P\
redict. "),e.question),...a.map(u=>l("label",{class:"option"},u,l("span",{},n[u.value])))),l("div",{class:"buttons"},o,s)),c=()=>{let u=t.choice(r);if(u!==void 0){
for(let d of a)[d.checked,d.disabled]=[d.value===u,!0];o.hidden=o.disabled=!0,s.replaceChildren(),i.append(e.later?l("p",{class:"reply"},e.later):tr(e,u))}};return i.
addEventListener("submit",u=>{u.preventDefault();let d=a.find(m=>m.checked);d?(t.choose(r,d.value),c()):s.textContent="Choose one first. Any prediction is a goo\
d one."}),c(),i}function tr(e,t){let{options:r,outcome:n}=e,s=t===n;return l("div",{class:"reply",role:"status","data-right":String(s)},l("p",{},l("strong",{},s?
"✓ As you predicted: ":"You predicted: "),r[t]),s?null:l("p",{},l("strong",{},"The outcome: "),r[n]),...er(e.explanation),e.note&&l("p",{class:"small muted"},
e.note))}function On(e,t){let{input:r,check:n,answer:s,set:o}=Cn(e),a=l("p",{class:"reply",role:"status",hidden:!0}),i=d=>{a.hidden=!1,a.dataset.right=String(d===
null),a.replaceChildren(l("strong",{},d===null?"✓ Right. ":"✗ Not yet. "),d??e.explanation)},c=l("form",{class:"exercise",id:`exercise-${e.exercise}`},l("di\
v",{class:"text"},l("p",{},l("strong",{},"Exercise. "),...ot(e.question))),e.matrix&&wa(e.matrix),l("div",{class:"buttons"},r,l("button",{type:"submit"},"Check")),
a);c.addEventListener("submit",d=>{d.preventDefault();let m=n();m===null&&t.solve(e.exercise,s()),i(m)});let u=t.solved(e.exercise);return u!==void 0&&(o(u),i(null)),
c}function wa(e){let t=e.map((r,n)=>n);return l("div",{class:"wide-table",tabindex:0},l("table",{class:"rates numbers"},l("thead",{},l("tr",{},l("td"),...t.map(
r=>l("th",{scope:"col"},`evaders ${r}`)))),l("tbody",{},...e.map((r,n)=>l("tr",{},l("th",{scope:"row"},`pursuers ${n}`),...r.map(s=>l("td",{},s.toFixed(1))))))))}var Sa=40;function rr(e,t){l("a",{href:URL.createObjectURL(new Blob([t],{type:"text/plain"})),download:e}).click()}function Rn({question:e="",points:t=[]},r){let n=l(
"textarea",{id:"exit-answer",rows:8}),s=l("p",{class:"printed"}),o=l("p",{class:"small muted",role:"status"}),a=l("button",{type:"submit",class:"primary"},"I am\
 done"),i=l("form",{class:"exercise"},l("label",{for:"exit-answer"},l("strong",{},"Exit question. "),e),n,s,l("div",{class:"buttons"},a,l("button",{type:"button",
onclick:()=>rr("exit_answer.txt",`${e}

${n.value}
`)},"Save my answer"),o)),c=()=>{s.textContent=r.exit.exit,r.exit.done&&([n.readOnly,a.hidden]=[!0,!0],i.append(l("div",{class:"reply"},l("p",{},l("strong",{},"\
A good answer has:")),l("ul",{},...t.map(u=>l("li",{},...ot(u)))))))};return n.value=r.exit.exit,n.addEventListener("input",()=>{r.exit={exit:n.value},s.textContent=
n.value}),i.addEventListener("submit",u=>{if(u.preventDefault(),n.value.trim().length<Sa){o.textContent="Write two explanations and an experiment first. Then th\
e page shows what a good answer has.";return}o.textContent="",r.exit={done:!0},c()}),c(),l("div",{class:"widget"},i)}var nr=[[0,0],[-1,0],[0,1],[1,0],[0,-1],[-1,1],[1,1],[1,-1],[-1,-1]];var ne=(e,t)=>t<e.nPursuers,T=(e,t)=>[e.positions[2*t],e.positions[2*t+1]],Ma=(e,t)=>e[0]===t[0]&&e[1]===t[1],sr=({rows:e,cols:t},[r,n])=>r>=0&&n>=0&&r<e&&n<t,or=(e,t,r=3)=>e!==
void 0&&[0,1,2].slice(0,r).some(n=>e[3*t+n]),ar=(e,t)=>or(e.fault,t),$n=(e,t)=>!ar(e,t)&&or(e.involved,t,2);function at(e,t,r){let n=!Ma(T(e,r),T(t,r)),s=t.involved===
void 0||or(t.involved,r);return!!(t.alive[r]&&t.actions?.[r]&&!n&&s)}function it(e,t,r){let[n,s]=T(e,r),[o,a]=nr[t.actions?.[r]??0];return[n+o,s+a]}function We(e,t,r){
return Array.from({length:r.everCaptured.length},(s,o)=>o).filter(s=>r.everCaptured[s]&&!t.everCaptured[s]).map(s=>e.nPursuers+s)}var lt=e=>e.moments.flatMap((t,r)=>r&&
We(e,e.moments[r-1],t).length?[r]:[]);function ct(e,t){return Array.from({length:t.alive.length},(n,s)=>s).filter(n=>e.alive[n]&&!t.alive[n])}var Pn=[-.31,0,.31],_n=[{size:1,at:[[0,0]]},{size:.62,at:[[-.2,.2],[.2,-.2]]},{size:.54,at:[[-.23,.22],[.23,.22],[0,-.22]]},{size:.54,at:[[-.23,.23],[.23,.23],[
-.23,-.23],[.23,-.23]]},{size:.36,at:Pn.flatMap(e=>Pn.map(t=>[t,e]))}],Aa=.3,Ea=.35,Ta=.55;function De(e,t){let r=new Map;for(let n=0;n<t.alive.length;n++){if(!t.
alive[n])continue;let[s,o]=T(t,n),a=s*e.cols+o,i=r.get(a);i?i.push(n):r.set(a,[n])}return r}function Ln(e,t){let r=Array.from(t.alive,(n,s)=>{let[o,a]=T(t,s);return{
x:a+.5,y:o+.5,size:1,alpha:0}});for(let n of De(e,t).values()){let s=_n[Math.min(n.length,_n.length)-1];n.forEach((o,a)=>{let[i,c]=s.at[Math.min(a,s.at.length-1)],
u=r[o];u.x+=i,u.y+=c,u.size=s.size,u.alpha=1})}return r}var Nn=e=>e*e*(3-2*e),we=(e,t,r)=>e+(t-e)*r,In=e=>Math.min(1,Math.max(0,e));function Fn(e,t,r,n){let s={
SIMULTANEOUS:1,SWARM_TURNS:2,AGENT_TURNS:r}[e.interaction];if(s===1)return Nn(n);let o=s===r?t:+!ne(e,t),a=Math.max(1/s,Ea);return Nn(In((n-o/(s-1)*(1-a))/a))}function ut(e,t){
let r=e.moments.length-1,n=Math.min(Math.floor(t),r),s=e.moments[n],o=Ln(e,s);if(n===r||t===n)return o;let a=e.moments[n+1],i=Ln(e,a);return o.map((c,u)=>{let d=Fn(
e,u,o.length,t-n);return Ca(s,a,u,c,i[u],d)})}function ir(e,t,r){let n=e.moments.length-1,s=Math.min(Math.floor(r),n),[o,a]=[e.moments[s],e.moments[Math.min(s+1,
n)]],i=Fn(e,t,o.alive.length,r-s),[[c,u],[d,m]]=[T(o,t),T(a,t)];return[we(u,m,i)+.5,we(c,d,i)+.5]}function Ca(e,t,r,n,s,o){let a=n.alpha>s.alpha,i={x:we(n.x,s.x,
o),y:we(n.y,s.y,o),size:a?n.size:we(n.size,s.size,o),alpha:a?In((1-o)/(1-Ta)):we(n.alpha,s.alpha,o)};if(at(e,t,r)){let[c,u]=T(e,r),[d,m]=it(e,t,r),p=Aa*Math.sin(
Math.PI*o);i.x+=(m-u)*p,i.y+=(d-c)*p}return i}var zn=2*Math.PI;function se(e,t,r,n){e.beginPath(),e.arc(t,r,n/2,0,zn)}function dt(e,t,r,n){let s=n/2,o=[[0,-.97],[.97,.83],[-.97,.83]].map(([a,i])=>[t+a*s,r+i*
s]);e.beginPath(),e.moveTo((o[2][0]+o[0][0])/2,(o[2][1]+o[0][1])/2),o.forEach(([a,i],c)=>{let[u,d]=o[(c+1)%3];e.arcTo(a,i,u,d,n*.09)}),e.closePath()}function Hn(e,t,r,n){
let s=n*.32;e.beginPath(),e.moveTo(t-s,r-s),e.lineTo(t+s,r+s),e.moveTo(t+s,r-s),e.lineTo(t-s,r+s)}function Wn(e,t,r,n){e.beginPath();for(let s=0;s<16;s++){let o=n/
2*(s%2?.6:.95),a=zn*s/16;e.lineTo(t+o*Math.sin(a),r-o*Math.cos(a))}e.closePath()}function Dn(e,t,r,n,s,o){let a=Math.atan2(s-r,n-t);e.beginPath(),e.moveTo(t,r),
e.lineTo(n,s);for(let i of[-1,1])e.moveTo(n,s),e.lineTo(n-o*Math.cos(a+i*.6),s-o*Math.sin(a+i*.6))}var Un=4,ka=1.6,Oa=.95,Ra=5,$a=.16,Pa=9,_a=.09,La=.2,Bn=.75,$=(e,t)=>e.left+t*e.cell,P=(e,t)=>e.top+t*e.cell;function Se(e,t,r){return ne(t,r)?e.colors.pursuer:
e.colors.evader}function Gn({ctx:e,grid:t,colors:r}){let{left:n,top:s,cell:o,rows:a,cols:i}=t,[c,u]=[i*o,a*o];if(e.fillStyle=r.paper,e.fillRect(n,s,c,u),o<Ra)return;
e.fillStyle=r.line;let d=Math.max(1,Math.round(o/60));for(let m=1;m<i;m++)e.fillRect(n+m*o,s,d,u);for(let m=1;m<a;m++)e.fillRect(n,s+m*o,c,d)}function jn({ctx:e,
grid:t,colors:r},n){let{left:s,top:o,cell:a,rows:i,cols:c}=t;e.fillStyle=r.obstacle;for(let u=0;u<i*c;u++){if(!n.obstacles[u])continue;let[d,m]=[Math.floor(u/c),
u%c];e.fillRect(s+m*a,o+d*a,a,a)}Vn({ctx:e,grid:t,colors:r})}function Vn({ctx:e,grid:{left:t,top:r,cell:n,rows:s,cols:o},colors:a}){let i=Math.min(5,Math.max(2,
Math.round(n/18)));e.strokeStyle=a.frame,e.lineWidth=i,e.strokeRect(t-i/2,r-i/2,o*n+i,s*n+i)}function qn({ctx:e,grid:t,colors:r},n){let{left:s,top:o,cell:a,rows:i,
cols:c}=t,u=a<24*n?5:1;e.font=`500 ${Math.round(Math.min(15*n,Math.max(9*n,a*.32)))}px system-ui, sans-serif`,e.fillStyle=r.muted,e.textBaseline="alphabetic",e.
textAlign="center";let d=5*n+a/40;for(let m=0;m<c;m+=u)e.fillText(String(m),s+(m+.5)*a,o-d);e.textAlign="right",e.textBaseline="middle";for(let m=0;m<i;m+=u)e.fillText(
String(m),s-d,o+(m+.5)*a)}function Kn({grid:e},t,r,n){let s=Math.floor(t.fov/2)+.5,[o,a]=[Math.max(0,r-s),Math.min(e.cols,r+s)],[i,c]=[Math.max(0,n-s),Math.min(
e.rows,n+s)];return[$(e,o),P(e,i),(a-o)*e.cell,(c-i)*e.cell]}function Yn(e,t,r,n){let{ctx:s,grid:o,colors:a}=e;s.save(),s.beginPath(),s.rect(0,0,s.canvas.width,
s.canvas.height),s.rect(...Kn(e,t,r,n)),s.clip("evenodd"),s.clearRect(0,0,s.canvas.width,s.canvas.height),s.fillStyle=a.line,s.fillRect(o.left,o.top,o.cols*o.cell,
o.rows*o.cell),s.restore(),Vn(e)}function Zn({ctx:e,grid:t,colors:r},{x:n,y:s,alpha:o},a){let i=Math.max(t.cell,16*a)*1.06,[c,u]=[$(t,n),P(t,s)];e.globalAlpha=Math.
max(o,.6),e.beginPath(),e.roundRect(c-i/2,u-i/2,i,i,i*.2),e.strokeStyle=r.focus,e.lineWidth=Math.max(2,2.5*a),e.stroke();let d=Math.max(11*a,Math.min(18*a,t.cell*
.5));e.font=`700 ${Math.round(d)}px system-ui, sans-serif`,e.textAlign="center",e.textBaseline="middle";let m=u-i/2<d*1.2,p=u+(m?1:-1)*(i/2+d*.7);e.strokeStyle=
r.paper,e.lineJoin="round",e.lineWidth=d*.35,e.strokeText("You",c,p),e.fillStyle=r.ink,e.fillText("You",c,p),e.globalAlpha=1}function Jn(e,t,r,n,s){let{ctx:o,grid:a}=e,
i=Kn(e,t,n,s),c=Se(e,t,r);o.globalAlpha=.11,o.fillStyle=c,o.fillRect(...i),o.globalAlpha=.8,o.strokeStyle=c,o.lineWidth=Math.max(1,a.cell/24),o.strokeRect(...i),
o.globalAlpha=1}function Xn(e,t,r,n,s){let{ctx:o,grid:a}=e,i=Math.min(Math.ceil(r),t.moments.length-1),c=t.moments[i];o.lineCap="round",o.lineWidth=Math.min(Pa,
Math.max(1,a.cell*$a));for(let u=Math.max(1,Math.floor(r-n)+1);u<=i;u++){let[d,m]=[t.moments[u-1],t.moments[u]],p=Math.max(0,Math.min(1,(r-u)/n));o.globalAlpha=
Bn+(La-Bn)*p;for(let h=0;h<m.alive.length;h++){let v=u===i&&r<i;if(!d.alive[h]||!(c.alive[h]||v))continue;let g=(ne(t,h)?-1:1)*_a,[b,A]=T(d,h),[y,x]=T(m,h);if(b===
y&&A===x)continue;let S=v?s[h].x:x+.5,M=v?s[h].y:y+.5;o.strokeStyle=Se(e,t,h),o.beginPath(),o.moveTo($(a,A+.5+g),P(a,b+.5+g)),o.lineTo($(a,S+g),P(a,M+g)),o.stroke()}}
o.globalAlpha=1}function Qn(e,t,r){let n=Math.min(Math.ceil(r),t.moments.length-1);for(let s=Math.max(1,n-Un+1);s<=n;s++){let[o,a]=[t.moments[s-1],t.moments[s]],
i=s>r?Math.max(0,1-2*(s-r)):1-(r-s)/Un,c=We(t,o,a);for(let u of ct(o,a))c.includes(u)||Ia(e,T(a,u),i);for(let u of c)Na(e,T(a,u),i)}e.ctx.globalAlpha=1}function Na({
ctx:e,grid:t,colors:r},[n,s],o){e.globalAlpha=o,Wn(e,$(t,s+.5),P(t,n+.5),Math.max(8,t.cell*ka)),e.fillStyle=r.capture,e.fill(),e.strokeStyle=r.ink,e.lineWidth=Math.
max(1,t.cell/36),e.lineJoin="round",e.stroke()}function Ia({ctx:e,grid:t,colors:r},[n,s],o){e.globalAlpha=o,Hn(e,$(t,s+.5),P(t,n+.5),Math.max(7,t.cell*Oa)),e.strokeStyle=
r.collision,e.lineWidth=Math.max(2,t.cell*.17),e.lineCap="round",e.stroke()}function es({ctx:e,grid:t,colors:r},n,s){let o=Math.max(1,t.cell*.07);e.strokeStyle=
e.fillStyle=r.collision,e.lineWidth=Math.max(1,t.cell*.05),e.setLineDash([t.cell*.14,t.cell*.1]);for(let[a,i]of n){if(a<0||i<0||a>=t.rows||i>=t.cols)continue;let c=[
$(t,i)+o,P(t,a)+o,t.cell-2*o,t.cell-2*o];e.globalAlpha=.2*s,e.fillRect(...c),e.globalAlpha=s,e.strokeRect(...c)}e.setLineDash([]),e.globalAlpha=1}function ts({ctx:e,
grid:t,colors:r},n,s,o,a){e.globalAlpha=a,se(e,$(t,n),P(t,s),Math.max(8,t.cell*o*1.02)),e.strokeStyle=r.collision,e.lineWidth=Math.max(1.5,t.cell*.085*Math.sqrt(
o)),e.stroke(),e.globalAlpha=1}var Fa=.8,za=.92,Ha=15,Wa=7,lr=9;function rs(e,t,r,n,s,o){n.forEach((a,i)=>{a.alpha>0&&Da(e,t,r,i,a,s,o)}),e.ctx.globalAlpha=1;for(let a of De(t,r).values())a.length>
lr&&Ua(e,n[a[lr-1]],a.length-lr+1)}function Da(e,t,r,n,s,o,a){let{ctx:i,grid:c,colors:u}=e,d=ne(t,n),[m,p]=[c.left+s.x*c.cell,c.top+s.y*c.cell],h=Math.max(4,c.cell*
s.size*(d?za:Fa)),v=Se(e,t,n),g=!d&&!!r.captured[n-t.nPursuers];if(i.globalAlpha=s.alpha,(d?dt:se)(i,m,p,h),h>Wa*a&&(i.strokeStyle=u.paper,i.lineWidth=Math.max(
2,h*.1),i.stroke()),i.fillStyle=g?u.paper:v,i.fill(),g&&(se(i,m,p,h*.82),i.strokeStyle=v,i.lineWidth=h*.18,i.stroke()),!o||h<Ha*a)return;let b=String(d?n:n-t.nPursuers);
i.font=`700 ${Math.round(h*(d?.4:.5)*(b.length>1?.8:1))}px system-ui, sans-serif`,i.textAlign="center",i.textBaseline="middle",i.fillStyle=g?v:u.paper,i.fillText(
b,m,p+h*(d?.17:.03))}function Ua({ctx:e,grid:t,colors:r},n,s){let[o,a]=[t.left+n.x*t.cell,t.top+n.y*t.cell];e.font=`700 ${Math.round(t.cell*.3)}px system-ui, sa\
ns-serif`,e.textAlign="center",e.textBaseline="middle",e.strokeStyle=r.paper,e.lineWidth=t.cell*.1,e.strokeText(`+${s}`,o,a),e.fillStyle=r.ink,e.fillText(`+${s}`,
o,a)}var Ba=.46,Ga=.86,ja=.66,ns=.48,Va=.78,qa=.58;function ss(e,t,r,n){let[s,o]=[t.moments[r-1],t.moments[r]];if(!s)return;let{ctx:a,grid:i,colors:c}=e;a.strokeStyle=
c.collision,a.lineWidth=Math.max(1.5,i.cell*.07),a.lineCap="butt",a.globalAlpha=n;for(let u=0;u<o.alive.length;u++)at(s,o,u)&&Ka(e,t,T(s,u),it(s,o,u));a.globalAlpha=
1}function Ka({ctx:e,grid:t},r,n,s){let[o,a]=[s[1]-n[1],s[0]-n[0]],i=m=>$(t,n[1]+.5+o*m),c=m=>P(t,n[0]+.5+a*m),u=sr(r,s)?Va:qa;e.setLineDash([t.cell*.09,t.cell*
.06]),e.beginPath(),e.moveTo(i(ns),c(ns)),e.lineTo(i(u),c(u)),e.stroke(),e.setLineDash([]);let d=.17*t.cell/Math.hypot(o,a);e.beginPath(),e.moveTo(i(u)-a*d,c(u)+
o*d),e.lineTo(i(u)+a*d,c(u)-o*d),e.stroke()}function os(e,t,r,n,s,o){let a=nr[o];if(!o||!a)return;let{ctx:i,grid:c,colors:u}=e,d=sr(t,[n[0]+a[0],n[1]+a[1]])?Ga:
ja,m=Ba*s.size,p=[$(c,s.x+a[1]*m),P(c,s.y+a[0]*m),$(c,s.x+a[1]*d),P(c,s.y+a[0]*d)],h=Math.max(1.5,c.cell*.085);i.lineCap=i.lineJoin="round";for(let[v,g]of[[u.paper,
h*2.1],[Se(e,t,r),h]])i.strokeStyle=v,i.lineWidth=g,Dn(i,...p,c.cell*.2),i.stroke()}var is={numbers:!0,axes:!1,trail:6,viewers:[],plan:null,selected:null,cursor:null,you:null,fog:!1};function ls(e,t,r,n,s){let{ctx:o,grid:a,colors:i}=e,c=Math.min(
Math.ceil(r),t.moments.length-1),u=t.moments[c],d=r===c,m=ut(t,r),p=d?1:Math.max(0,1-2*(c-r));o.clearRect(0,0,o.canvas.width,o.canvas.height),Gn(e);for(let g of n.
viewers)m[g]?.alpha&&Jn(e,t,g,...ir(t,g,r));jn(e,t),n.axes&&qn(e,s),Xn(e,t,r,n.trail,m),es(e,u.contested??[],p),Qn(e,t,r),ss(e,t,c,p),m.forEach(({x:g,y:b,size:A},y)=>{
let x=$n(u,y)?.4:0,S=ar(u,y)?1:x;S&&ts(e,g,b,A,S*p)});let h=d?u:t.moments[Math.max(0,c-1)];if(rs(e,t,h,m,n.numbers,s),d&&n.plan)for(let[g,b]of m.entries())b.alpha&&
os(e,t,g,T(u,g),b,n.plan[g]??0);n.you!==null&&(n.fog&&Yn(e,t,...ir(t,n.you,r)),Zn(e,m[n.you],s)),o.lineWidth=Math.max(2,2.5*s),o.strokeStyle=i.focus;let v=n.selected===
null?void 0:m[n.selected];v?.alpha&&as(e,v.x,v.y,v.size*.96),n.cursor&&(o.setLineDash([a.cell*.12,a.cell*.08]),as(e,n.cursor[1]+.5,n.cursor[0]+.5,.8),o.setLineDash(
[]))}function as({ctx:e,grid:t},r,n,s){let o=s*t.cell;e.beginPath(),e.roundRect(t.left+r*t.cell-o/2,t.top+n*t.cell-o/2,o,o,o*.1),e.stroke()}var cs=(e,t)=>(t+.24)/(e+.24);function us(e,t,r,n,s,o){let a=r?28*o:0,i=(u,d)=>(u-a)/(d+2*.12),c=Math.max(1,Math.floor(Math.min(i(n,t),i(s,e))));return{rows:e,cols:t,
cell:c,left:Math.round((n-t*c+a)/2),top:Math.round((s-e*c+a)/2)}}function ds(e,t,r){let n=Math.floor((r-e.top)/e.cell),s=Math.floor((t-e.left)/e.cell);return n>=
0&&n<e.rows&&s>=0&&s<e.cols?[n,s]:null}var Ya={paper:"--board-paper",line:"--board-line",frame:"--board-frame",ink:"--board-ink",muted:"--board-muted",obstacle:"--board-obstacle",pursuer:"--pursuer",
evader:"--evader",capture:"--capture",collision:"--collision",focus:"--focus"};function mt(e){let t=getComputedStyle(e),r=Object.entries(Ya).map(([n,s])=>[n,t.getPropertyValue(
s).trim()]);return Object.fromEntries(r)}var oe=()=>matchMedia("(prefers-reduced-motion: reduce)").matches,Me=class{canvas;#e=null;#n=0;#t;#s={rows:1,cols:1,left:0,top:0,cell:1};#o=0;#r;#l;constructor(t,r={}){
this.canvas=t,t.classList.add("board"),t.setAttribute("role","img"),this.#t={...is,...r},this.#r=new ResizeObserver(()=>this.#u()),this.#r.observe(t),this.#l=new MutationObserver(
()=>this.redraw()),this.#l.observe(document.documentElement,{attributes:!0}),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",this.redraw)}close(){
this.#r.disconnect(),this.#l.disconnect(),matchMedia("(prefers-color-scheme: dark)").removeEventListener("change",this.redraw),cancelAnimationFrame(this.#o)}get look(){
return this.#t}set look(t){this.#t={...this.#t,...t},this.#d(),this.redraw()}show(t,r){this.#e=t,this.#n=Math.min(Math.max(0,r),t.moments.length-1),this.#d(),this.
redraw()}redraw=()=>{this.#o||(this.#o=requestAnimationFrame(()=>this.drawNow()))};drawNow(){cancelAnimationFrame(this.#o),this.#o=0;let t=this.canvas.getContext(
"2d");if(!t||!this.#e)return;let{rows:r,cols:n}=this.#e,s=devicePixelRatio||1;this.#s=us(r,n,this.#t.axes,this.canvas.width,this.canvas.height,s);let o={ctx:t,grid:this.#s,
colors:mt(this.canvas)};ls(o,this.#e,this.#n,this.#t,s)}cellAt(t,r){let n=this.canvas.getBoundingClientRect(),s=this.canvas.width/n.width;return ds(this.#s,(t-n.
left)*s,(r-n.top)*s)}agentAt(t,r){let n=this.cellAt(t,r);if(!n||!this.#e)return null;let s=this.#e.moments[Math.round(this.#n)],o=De(this.#e,s).get(n[0]*this.#e.
cols+n[1])??[],a=ut(this.#e,Math.round(this.#n)),i=c=>{let[u,d]=this.pointOf(a[c].x,a[c].y);return Math.hypot(u-t,d-r)};return o.length?o.reduce((c,u)=>i(u)<i(c)?
u:c):null}pointOf(t,r){let n=this.canvas.getBoundingClientRect(),s=n.width/this.canvas.width,{left:o,top:a,cell:i}=this.#s;return[n.left+(o+t*i)*s,n.top+(a+r*i)*
s]}#d(){if(!this.#e)return;let{rows:t,cols:r}=this.#e;this.canvas.style.setProperty("--board-aspect",String(cs(t,r)))}#u(){let t=devicePixelRatio||1,{width:r,height:n}=this.
canvas.getBoundingClientRect();this.canvas.width=Math.max(1,Math.round(r*t)),this.canvas.height=Math.max(1,Math.round(n*t)),this.drawNow()}};var Ue=[.5,1,2,4,8,16,32,64],pt=0,ht=12,Za=2,Y=class extends EventTarget{#e;#n;#t;#s=0;#o=0;#r=!1;#l=null;#d=0;#u=[];#p=[];glide=.28;constructor(t,r={}){super(),
this.#e=t,this.#n=r.speed??4,this.#t=r.still??!1}get step(){return this.#s}get time(){return this.#t?this.#s:this.#o}get arrived(){return this.#o===this.#s}get playing(){
return this.#r}get length(){return this.#e}set length(t){this.#e=t,this.#s>t&&this.jump(t),this.#i("state")}get marks(){return this.#u}set marks(t){this.#u=t,this.#i(
"state")}get ticks(){return this.#p}set ticks(t){this.#p=t,this.#i("state")}get pace(){return this.#n||Math.max(Za,this.#e/ht)}get speed(){return this.#n}set speed(t){
this.#n=t,this.#i("state")}changeSpeed(t){let r=Ue.findIndex(n=>n>=this.pace);this.speed=Ue[Math.min(Ue.length-1,Math.max(0,r+t))]}play(){this.#r||!this.#e||(this.#s===
this.#e&&this.jump(0),this.#r=!0,this.#i("state"),this.#a())}pause(){this.#r&&(this.#r=!1,this.#i("state"))}toggle(){this.#r?this.pause():this.play()}move(t){this.
pause();let r=Math.min(this.#e,Math.max(0,this.#s+t));Math.abs(r-this.#o)>1?this.jump(r):this.#c(r),this.#a()}jump(t){this.#o=Math.min(this.#e,Math.max(0,Math.round(
t))),this.#c(this.#o),this.#i("frame")}#c(t){t!==this.#s&&(this.#s=t,this.#i("step"),this.#t&&this.#i("frame"))}#a(){this.#l===null&&(this.#d=performance.now(),
this.#l=requestAnimationFrame(()=>this.#m()))}#m(){this.#l=null;let t=performance.now();this.#h(Math.min(.25,(t-this.#d)/1e3)),this.#d=t,(!this.#t||this.arrived)&&
this.#i("frame"),(this.#r||this.#o!==this.#s)&&(this.#l=requestAnimationFrame(()=>this.#m()))}#h(t){let r=t;for(;r>0;){if(this.#o===this.#s){if(!this.#r)return;
if(this.#s===this.#e)return this.pause();this.#c(this.#s+1)}let n=this.#r?this.pace:1/this.glide,s=this.#s-this.#o,o=Math.min(Math.abs(s),r*n);r-=o/n,this.#o=o===
Math.abs(s)?this.#s:this.#o+Math.sign(s)*o}this.#r&&this.#o===this.#e&&this.pause()}#i(t){this.dispatchEvent(new Event(t))}};function ms(e,t){if(t.ctrlKey||t.metaKey||
t.altKey)return!1;let r=t.shiftKey?10:1,s={" ":()=>e.toggle(),ArrowRight:()=>e.move(r),ArrowLeft:()=>e.move(-r),Home:()=>e.move(-e.length),End:()=>e.move(e.length),
"+":()=>e.changeSpeed(1),"-":()=>e.changeSpeed(-1)}[t.key];return s?.(),s!==void 0}var Ja={first:"M6 5v14M19 5 9 12l10 7z",back:"M17 5 7 12l10 7z",play:"M7 4.5 19 12 7 19.5z",pause:"M8 5v14M16 5v14",forward:"M7 5l10 7-10 7z",last:"M18 5v14M5 5\
l10 7-10 7z"};function ps(e){return f("svg",{viewBox:"0 0 24 24","aria-hidden":"true",class:"icon"},f("path",{d:Ja[e]}))}function Be(e,t,r,n){return l("button",
{type:"button",class:"player-button","aria-label":t,title:`${t} (${r})`,onclick:n},ps(e))}function Ae(e){let t=Be("play","Play","Space",()=>e.toggle()),r=Xa(e),
n=l("div",{class:"captures","aria-hidden":"true",title:"Captures"}),s=l("div",{class:"losses","aria-hidden":"true"}),o=Qa(e),a=l("output",{class:"player-count"}),
i=l("div",{class:"player",role:"group","aria-label":"Player"},Be("first","First step","Home",()=>e.move(-e.length)),Be("back","Step back","←",()=>e.move(-1)),
t,Be("forward","Step forward","→",()=>e.move(1)),Be("last","Last step","End",()=>e.move(e.length)),l("div",{class:"scrub"},n,s,r),a,o),c=(m,p={})=>{let h=l("i",
p);return h.style.left=`${100*m/Math.max(1,e.length)}%`,h},u=()=>{n.replaceChildren(...e.marks.map(m=>c(m))),s.replaceChildren(...e.ticks.map(({step:m,kind:p,size:h,
text:v})=>{let g=c(m,{class:p,title:`Step ${m}: ${v}`});return g.style.height=`${100*h}%`,g}))},d=()=>{t.replaceChildren(ps(e.playing?"pause":"play")),t.ariaLabel=
e.playing?"Pause":"Play",t.title=`${t.ariaLabel} (Space)`,r.max=String(e.length),r.value=String(e.step),r.ariaValueText=`step ${e.step} of ${e.length}`,a.textContent=
`${e.step} / ${e.length}`,a.style.minWidth=`${2*String(e.length).length+3}ch`,o.value=String(e.speed)};return e.addEventListener("step",d),e.addEventListener("s\
tate",d),e.addEventListener("state",u),i.addEventListener("keydown",m=>{!(m.target instanceof HTMLSelectElement||m.key===" "&&m.target!==r)&&ms(e,m)&&m.preventDefault()}),
d(),i}function Xa(e){let t=l("input",{type:"range",class:"player-scrub",min:0,step:1,"aria-label":"Step"});return t.addEventListener("input",()=>{e.pause(),e.jump(
Number(t.value))}),t}function Qa(e){let t=`Steps a second, or the whole in ${ht} s (+ and -)`,r=l("select",{class:"player-speed","aria-label":"Speed",title:t},l(
"option",{value:pt},`in ${ht} s`),...Ue.map(n=>l("option",{value:n},`${n} / s`)));return r.addEventListener("change",()=>{e.speed=Number(r.value)}),r}var C=(e,t=2)=>e==null?"-":e.toFixed(t);function hs(e,t,r){return t===null||r===null?C(e):`${C(e)} (${C(t)} to ${C(r)})`}function Ge(e,t,r,n=!1){let s=(t-e)/Math.max(1,r),o=10**Math.floor(Math.log10(s||1)),a=[1,2,5,10].map(u=>u*o).find(u=>u>=s)??10*o;n&&(a=Math.max(1,Math.round(a)));
let i=Math.ceil(e/a-1e-9),c=Math.floor(t/a+1e-9);return Array.from({length:Math.max(0,c-i+1)},(u,d)=>(i+d)*a)}var ft={left:46,right:12,top:10,bottom:42},fs={x:56,y:34};function Z(e,t,r,n){let[s,o]=[ft.left,ft.top],a=Math.max(s+40,e-ft.right),i=Math.max(o+40,t-ft.bottom),
c=(g,b,A)=>y=>b+(y-g.low)/(g.high-g.low||1)*(A-b),[u,d]=[c(r,s,a),c(n,i,o)],m=f("g"),p=f("svg",{width:e,height:t,viewBox:`0 0 ${e} ${t}`,class:"plot"}),h=f("g",
{class:"axes"});for(let g of Ge(n.low,n.high,(i-o)/fs.y,n.whole))h.append(f("line",{x1:s,x2:a,y1:d(g),y2:d(g),class:"grid"}),f("text",{x:s-8,y:d(g),"text-anchor":"\
end","dominant-baseline":"middle"},gs(g)));for(let g of Ge(r.low,r.high,(a-s)/fs.x,r.whole))h.append(f("text",{x:u(g),y:i+16,"text-anchor":"middle"},gs(r.mirrored?
Math.abs(g):g)));return h.append(f("line",{x1:s,x2:a,y1:i,y2:i,class:"axis"}),f("text",{x:(s+a)/2,y:t-6,"text-anchor":"middle",class:"label"},r.label),f("text",
{transform:`translate(12 ${(o+i)/2}) rotate(-90)`,"text-anchor":"middle",class:"label"},n.label)),p.append(h,m),{root:p,marks:m,left:s,right:a,top:o,bottom:i,x:u,
y:d,at:g=>{let b=g-p.getBoundingClientRect().left;return r.low+(b-s)/(a-s)*(r.high-r.low)}}}var gs=e=>String(Number(e.toPrecision(6))).replace("-","−");function J(e,t,r,n){
let s="",o="M";r.forEach((a,i)=>{a===null?o="M":(s+=`${o}${e.x(t[i]).toFixed(1)} ${e.y(a).toFixed(1)}`,o="L")}),e.root.insertBefore(f("path",{d:s,class:`line ${n}`}),
e.marks)}function ys(e,t,r,n=null){let s=e.x(t);e.marks.append(f("line",{x1:s,x2:s,y1:e.top,y2:e.bottom,class:`mark ${r}`})),n!==null&&e.marks.append(f("circle",{cx:s,cy:e.
y(n),r:5,class:`dot ${r}`}))}function gt(...e){return l("p",{class:"legend small"},...e.map(([t,r])=>l("span",{class:`key ${r}`},t)))}function X(e,t,r,n){let s=l(
"div",{class:"chart chooses",role:"img","aria-label":e}),o=null,a=()=>{o?.marks.replaceChildren(),o&&r(o)};s.addEventListener("click",c=>o&&n(o.at(c.clientX),o,
c));let i=()=>{let{clientWidth:c,clientHeight:u}=s;c<50||u<50||(o=t(c,u),s.replaceChildren(o.root),a())};return new ResizeObserver(i).observe(s),{element:s,update:a,
redraw:i}}function Ee(e,t,r){let n=devicePixelRatio||1;for(let[a,i]of Object.entries(r))e.style.setProperty(a,`${i}px`);e.width=Math.round(r.width*n),e.height=Math.round(
r.height*n);let s=e.getContext("2d"),o=ei(t);!s||!o||(s.imageSmoothingEnabled=!1,s.drawImage(o,0,0,e.width,e.height))}function ei(e){let[t,r]=e.shape,n=document.
createElement("canvas");[n.width,n.height]=[r,t];let s=n.getContext("2d");if(!s)return null;let o=s.createImageData(r,t);return e.capture_rate.forEach((a,i)=>a.
forEach((c,u)=>{let d=4*((t-1-i-e.first[0])*r+u+e.first[1]);o.data.set([...rt(c),255],d)})),s.putImageData(o,0,0),n}function Q(e,t){let r=l("span",{class:"gradi\
ent"});return r.style.backgroundImage=En(),l("p",{class:"scale-of-rates small muted"},e,r,t)}function ae(e,t,r=e.length){let n=l("canvas",{role:"img","aria-label":t}),s=l("div",{class:"cells-of-matrix"},n),o=l("figure",{},l("figcaption",{},t),s,l("p",{class:"\
small muted"},l("span",{class:"pursuer"},"↑ pursuers")," ",l("span",{class:"evader"},"evaders →")));return o.draw=()=>{let a=s.clientWidth;a&&Ee(n,{shape:[r,
r],first:[0,0],capture_rate:e},{left:0,top:0,width:a,height:a})},new ResizeObserver(()=>o.draw?.()).observe(s),o}var bs=()=>Q("0 all escape","1 all caught"),xs=({
runs:e})=>l("div",{class:"widget"},l("div",{class:"matrices"},...e.map((t,r)=>ae(t.payoff.capture_rate,`Matrix ${"ABC"[r]}`))),bs()),yt=31,vs=.016;function ws(){
let e=r=>Array.from({length:yt},(n,s)=>Array.from({length:yt},(o,a)=>.5+r*(s-a))),t=[[vs,"Both get better"],[-vs,"Both get worse"],[0,"Nothing happens"]];return l(
"div",{class:"widget"},l("div",{class:"matrices"},...t.map(([r,n])=>ae(e(r),n))),bs())}function Ss(){let e=Array.from({length:yt},(t,r)=>r);return X("A capture \
rate that stays at one half from generation 0 to 30",(t,r)=>{let n=Z(t,r,{low:0,high:yt-1,label:"generation",whole:!0},{low:0,high:1,label:"capture rate"});return J(
n,e,e.map(()=>.5),"of-both"),n},()=>{},()=>{}).element}function ie(e,t,r,n,s){let o=l("input",{type:"range",min:0,max:t.length-1,step:1,"aria-label":e}),a=l("output",{class:"numbers"}),i=()=>{let c=t[Number(o.value)];
return a.textContent=o.ariaValueText=n(c),c};return o.value=String(t.indexOf(r)),o.addEventListener("input",()=>s(i())),i(),l("label",{class:"slider"},l("span",
{},e),o,a)}function Ms(e,t,r){let n=l("select",{"aria-label":e},...t.map(s=>l("option",{value:s},s)));return n.addEventListener("change",()=>r(n.value)),l("labe\
l",{class:"slider"},l("span",{},e),n)}function ee(e){let t=e>>>0;return()=>{t=t+1831565813>>>0;let r=Math.imul(t^t>>>15,t|1);return r^=r+Math.imul(r^r>>>7,r|61),((r^r>>>14)>>>0)/2**32}}var ur=["rock",
"paper","scissors"],dr=[[.5,0,1],[1,.5,0],[0,1,.5]],ti=1e-9,Ts=e=>dr.map(t=>t.reduce((r,n,s)=>r+n*e[s],0));function mr(e,t){let r=e.slice(-t);return ur.map((n,s)=>r.
filter(o=>o===s).length/r.length)}var pr=e=>Math.max(...Ts(e));function As(e,t,r){let n=Ts(mr(e,t)),s=n.flatMap((o,a)=>o>Math.max(...n)-ti?[a]:[]);return s[s.length>
1?Math.floor(r()*s.length):0]}function bt(e,t,r){let n={pursuers:[0],evaders:[0]};for(let s=1;s<=e;s++)n.pursuers.push(As(n.evaders,t,r)),n.evaders.push(As(n.pursuers,
t,r));return n}var je=100,xt={scalar:{dimensions:1,greatest:!0},focusing:{dimensions:10,greatest:!0},intransitive:{dimensions:2,greatest:!1}};function cr(e,t,r){
let{greatest:n}=xt[e],s=t[0]-r[0];for(let o=1;o<t.length;o++){let a=t[o]-r[o];(n?Math.abs(a)>Math.abs(s):Math.abs(a)<Math.abs(s))&&(s=a)}return(1+Math.sign(s))/
2}var hr=(e,t,r)=>t.reduce((n,s)=>n+r.reduce((o,a)=>o+cr(e,s,a),0),0)/(t.length*r.length),Ce={population:25,mutation:.005,opponents:15,hall:0},Te=class{game;settings;generation=0;#e;#n;#t=[
[],[]];constructor(t,r,n){[this.game,this.settings,this.#e]=[t,r,n];let s=()=>Array.from({length:r.population},()=>new Uint8Array(je));this.#n=[s(),s()]}ones(t){
let{dimensions:r}=xt[this.game],n=je/r;return this.#n[t].map(s=>Array.from({length:r},(o,a)=>vt(s.subarray(a*n,(a+1)*n))))}objective=t=>vt(this.#n[t].map(vt))/this.
settings.population;step(){let t=[this.ones(0),this.ones(1)],r=this.#s(t);for(let n of[0,1]){this.#t[n].push(t[n][r[n].indexOf(Math.max(...r[n]))]);let s=this.#r(
r[n]);this.#n[n]=s.map(o=>this.#o(this.#n[n][o]))}this.generation++}#s(t){let{population:r,opponents:n,hall:s}=this.settings,o=[new Array(r).fill(0),new Array(r).
fill(0)];for(let a=0;a<n;a++)Es(r,this.#e).forEach((i,c)=>{let u=cr(this.game,t[0][c],t[1][i]);o[0][c]+=+(u===1),o[1][i]+=+(u===0)});for(let a of[0,1]){let i=this.#t[1-
a];for(let c of Es(i.length,this.#e,s))t[a].forEach((u,d)=>o[a][d]+=+(cr(this.game,u,i[c])===1))}return o}#o(t){let r=t.slice();for(let n=0;n<r.length;n++)this.#e()<
this.settings.mutation&&(r[n]^=1);return r}#r(t){let r=vt(t),n=r?t:t.map(()=>1);return t.map(()=>{let s=this.#e()*(r||t.length),o=n.findIndex(a=>(s-=a)<0);return o<
0?t.length-1:o})}};function Es(e,t,r=e){let n=Array.from({length:e},(o,a)=>a),s=Math.min(r,e);for(let o=0;o<s;o++){let a=o+Math.floor(t()*(e-o));[n[o],n[a]]=[n[a],
n[o]]}return n.slice(0,s)}function vt(e){let t=0;for(let r=0;r<e.length;r++)t+=e[r];return t}var fr=1,wt=["pursuers","evaders"],Os=[[150,42],[266,232],[34,232]],ri={pursuers:-7,evaders:7},Cs=e=>[0,1].map(t=>e.reduce((r,n,s)=>r+n*Os[s][t],0)),ks=(e,t)=>e.
map((r,n)=>mr(e.slice(0,n+1),t));function Rs({memories:e=[1],memory:t=e[0],generations:r=30}){let n=new Y(r,{speed:r>100?16:2,still:oe()}),s=t,o=bt(r,s,ee(fr)),
a={pursuers:[],evaders:[]},i={pursuers:f("polyline",{class:"way of-pursuers"}),evaders:f("polyline",{class:"way of-evaders"})},c={pursuers:f("path",{class:"fill\
ed-pursuer",d:"M0 -11 11 9H-11z"}),evaders:f("circle",{class:"filled-evader",r:9})},u=f("svg",{viewBox:"0 0 300 270",class:"hands-triangle",role:"img","aria-lab\
el":"The shares of rock, paper and scissors among the remembered hands of both teams"},f("polygon",{class:"frame",points:Os.map(b=>b.join()).join(" ")}),f("circ\
le",{class:"middle",cx:150,cy:168.7,r:4}),f("text",{x:150,y:192,"text-anchor":"middle"},"one third each"),f("text",{class:"label",x:150,y:18,"text-anchor":"midd\
le"},"rock"),f("text",{class:"label",x:266,y:262,"text-anchor":"middle"},"paper"),f("text",{class:"label",x:34,y:262,"text-anchor":"middle"},"scissors"),...wt.map(
b=>i[b]),...wt.map(b=>c[b])),d=l("p",{class:"numbers"}),m=X("What the best answer wins against the remembered hands, by generation",(b,A)=>{let y=Z(b,A,{low:0,high:r,
label:"generation",whole:!0},{low:.4,high:1,label:"best answer wins"});J(y,[0,r],[.5,.5],"half");for(let x of wt)J(y,o[x].map((S,M)=>M),a[x].map(pr),`of-${x}`);
return y},b=>ys(b,n.step,"of-both"),b=>n.jump(b)),p=()=>{let b=n.step;for(let y of wt){i[y].setAttribute("points",a[y].slice(0,b+1).map(M=>Cs(M).map(k=>k.toFixed(
1)).join()).join(" "));let[x,S]=Cs(a[y][b]);c[y].setAttribute("transform",`translate(${x+ri[y]} ${S})`)}let A=y=>l("span",{class:y.slice(0,-1)},`${y} show ${ur[o[y][b]]}`);
d.replaceChildren(`Generation ${b}: `,A("pursuers"),", ",A("evaders"),".",...e.length>1?[` The best answer to the remembered hands of the pursuers wins ${C(pr(a.
pursuers[b]))}.`]:[]),m.update()},h=()=>{o=bt(r,s,ee(fr)),a={pursuers:ks(o.pursuers,s),evaders:ks(o.evaders,s)},m.redraw(),p()};n.addEventListener("step",p),h();
let v=e.at(-1),g=ie("memory (hands)",e,t,b=>b===v?"all":String(b),b=>{s=b,h()});return l("div",{class:"widget"},e.length>1&&g,l("div",{class:"two"},l("div",{},u),
e.length>1&&l("div",{},gt(["pursuers' hands","of-pursuers"],["evaders' hands","of-evaders"]),m.element)),d,Ae(n))}function $s({generations:e=30}){let{pursuers:t,
evaders:r}=bt(e,1,ee(fr)),n=t.map(o=>r.map(a=>dr[o][a])),s=n.at(-1);return l("div",{class:"widget"},l("div",{class:"matrices"},ae(n,`The last pursuers score ${C(
s.reduce((o,a)=>o+a,0)/s.length)} against all evaders.`)),Q("0 loses","1 wins"))}var Ve=600,ke=20,gr=5,Ps=10,yr={"Game A":"intransitive","Game B":"scalar","Game C":"focusing"},Ns={low:0,high:Ve,label:"generation",whole:!0},Is={low:0,high:je,
label:"ones of side 1"},le=()=>{},ni=()=>new Promise(e=>setTimeout(e));async function vr(e,t,r){for(t();e.generation<Ve&&r();t()){for(let n=0;n<ke;n++)e.step();
await ni()}}var St=new Map,Fs=[];async function si(){for(let e of Object.keys(yr))St.set(e,[]);for(let e=0;e<gr;e++)for(let[t,r]of Object.entries(yr)){let n={score:[],
ones:[]};St.get(t).push(n);let s=new Te(r,Ce,ee(e));await vr(s,()=>{n.score.push(hr(r,s.ones(0),s.ones(1))),n.ones.push(s.objective(0))},()=>!0),Fs.forEach(o=>o())}}
function zs({shows:e="score"}){St.size||si();let t=e==="score"?{low:0,high:1,label:"score of side 1"}:Is,r=Object.entries(yr).map(([n,s])=>{let o=e==="score"?n:
`${n}: ${s}`,a=X(`${o}: ${t.label} in ${gr} races`,(i,c)=>{let u=Z(i,c,Ns,t);for(let d of St.get(n))J(u,d[e].map((m,p)=>p*ke),d[e],"of-both dense");return u},le,
le);return Fs.push(a.redraw),l("figure",{},l("figcaption",{},o),a.element)});return l("div",{class:"widget"},l("div",{class:"matrices"},...r),l("p",{class:"smal\
l muted"},`Each line is a race; there are ${gr} of each game, played now, in this page.`))}var oi=[5,10,15,25,40,60],ai=[5e-4,.001,.002,.005,.01,.02,.05],ii=[0,
1,5,15,30],_s=15,li=Array.from({length:20},(e,t)=>t);function Hs({hall:e=!1}){let[t,r,n]=["scalar",0,{...Ce,hall:e?_s:0}],s=0,o=y=>{n={...n,...y}},a=[[],[]],i=[
ae(a[0],"Score of side 1",Ve/ke+1),ae(a[1],"Score of side 2",Ve/ke+1)];i.forEach(y=>y.querySelector("p").replaceChildren(`↑ generation, → opponent (${ke} a \
cell)`));let c=[[],[]],u=X("Ones of both sides by generation",(y,x)=>{let S=Z(y,x,Ns,{...Is,label:"ones"});return c.forEach((M,k)=>J(S,M.map((ue,j)=>j*ke),M,k?"\
of-evaders":"of-pursuers")),S},le,le),d=l("p",{class:"numbers",role:"status"}),m=y=>{d.textContent=y},p=async()=>{let y=++s;for(let M of[...a,...c])M.length=0;let x=[
[],[]],S=new Te(t,n,ee(r));await vr(S,()=>{for(let M of[0,1])x[M].push(S.ones(M)),c[M].push(S.objective(M));for(let M of[0,1])a[M].push(x[1-M].map(k=>hr(S.game,
x[M].at(-1),k)));i.forEach(M=>M.draw?.()),u.redraw()},()=>s===y),s===y&&m(`${Ls(S.game)} game, seed ${r}: after ${Ve} generations side 1 has ${c[0].at(-1).toFixed(
0)} ones, side 2 ${c[1].at(-1).toFixed(0)}.`)},h=[],v=X("Ones of side 1 at the end of ten races, a row for each choice of settings",(y,x)=>ci(h,y,x),le,le);v.element.
classList.add("dots");let g=async y=>{let x=++s,S=[],{population:M,mutation:k}=y,ue=`${t}${M===Ce.population?"":`, ${M} players`}${k===Ce.mutation?"":`, mutatio\
n ${k}`}, hall ${y.hall}`;h.push({text:ue,ends:S}),h.length>br&&h.shift();for(let j=0;j<Ps&&s===x;j++){let V=new Te(t,y,ee(j));await vr(V,le,()=>s===x),s===x&&S.
push(V.objective(0)),v.redraw()}s===x&&m(`${Ls(ue)}: side 1 ends with ${Ws(S)} ones in the mean of ${Ps} races.`)},b=(y,x,S="")=>l("button",{type:"button",class:S,
onclick:()=>{y()}},x),A=l("div",{class:"sliders"},Ms("game",Object.keys(xt),y=>t=y),ie("population",oi,n.population,String,y=>o({population:y})),ie("mutation",ai,
n.mutation,String,y=>o({mutation:y})),...e?[ie("hall of fame",ii,_s,String,y=>o({hall:y}))]:[ie("seed",li,0,String,y=>r=y)]);return e?(g(Ce).then(()=>s===1?g(n):
void 0),l("div",{class:"widget"},A,l("div",{class:"buttons"},b(()=>g(n),"Play ten races","primary")),d,v.element)):l("div",{class:"widget"},A,l("div",{class:"bu\
ttons"},b(p,"Play a race","primary"),b(async()=>{s++},"Stop")),l("div",{class:"matrices"},...i,l("figure",{},l("figcaption",{},"The truth: ones"),gt(["side 1","\
of-pursuers"],["side 2","of-evaders"]),u.element)),Q("0 loses","1 wins"),d)}var br=6,Ws=e=>(e.reduce((t,r)=>t+r,0)/e.length).toFixed(1),Ls=e=>e.charAt(0).toUpperCase()+
e.slice(1);function ci(e,t,r){let n=Z(t,r,{low:0,high:je,label:"ones of side 1 at the end",whole:!0},{low:0,high:br,label:""});return n.root.querySelectorAll(".\
axes .grid, .axes [text-anchor=end]").forEach(s=>s.remove()),e.forEach(({text:s,ends:o},a)=>{let i=n.y(br-a-.7);n.marks.before(f("text",{class:"label",x:n.left,
y:i-12},o.length?`${s}: mean ${Ws(o)}`:s)),o.forEach(c=>n.marks.before(f("circle",{class:"dot of-both",cx:n.x(c),cy:i,r:5})))}),n}function ui(e,t,r){return{rows:e.rows,cols:e.cols,nPursuers:e.n_pursuers,fov:e.fov,interaction:e.rules.interaction,obstacles:t,moments:r}}function Mt(e){let t=Array.from({length:e.length+1},(r,n)=>di(e,n));return ui(e.config,e.map,t)}function di(e,t){let r=e.n_agents,n=e.config.n_evaders,s=(a,i,c)=>a.
subarray(i*c,(i+1)*c),o={positions:s(e.last_positions,t,2*r),alive:s(e.alive,t,r),captured:s(e.captured,t,n),everCaptured:s(e.ever_captured,t,n)};return t===0?o:
{...o,actions:s(e.actions,t-1,r),involved:s(e.involved,t-1,3*r),fault:s(e.fault,t-1,3*r),get contested(){return e.conflicts(t).map(a=>a.cell)}}}var mi=Array.from({length:16},(e,t)=>{let[r,n]=[t%2?6.5:11,Math.PI*t/8];return`${12+r*Math.sin(n)} ${12-r*Math.cos(n)}`}).join(" ");function At(){let e=[["pursu\
er",f("path",{d:"M12 3 22 20H2z",class:"filled-pursuer"})],["evader",f("circle",{cx:12,cy:12,r:9,class:"filled-evader"})],["capture",f("polygon",{points:mi,class:"\
filled-capture"})],["captured evader",f("circle",{cx:12,cy:12,r:7.5,class:"ring-evader"})],["conflict",f("rect",{x:3,y:3,width:18,height:18,class:"dashed-confli\
ct"})]];return l("ul",{class:"shapes small","aria-label":"Shapes on the board"},...e.map(([t,r])=>l("li",{},f("svg",{viewBox:"0 0 24 24","aria-hidden":"true"},r),
t)))}function Ds(e,t,...r){return l("section",{class:"card panel","aria-label":e},l("header",{},l("h2",{},e),l("p",{class:"small muted"},t)),...r)}var pi={present:"●",absent:"○","cannot tell":"?"};function Us(e){let{findings:t}=e;if(!t?.table.length)return null;let[,...r]=t.table,n=r.map(([o,a,i,c],u)=>{
let d=hi(t.reasons[u]??"");return l("li",{class:`finding ${a.replace(" ","-")}`},l("span",{class:"sign","aria-hidden":"true"},pi[a]??""),l("div",{},l("p",{},l("\
strong",{},o),` ${a}`,l("span",{class:"muted"},` · ${c}`)),d?l("p",{class:"small"},`${d}.`):null,l("p",{class:"small muted numbers"},i)))}),s=Ds("What happened",
"Each condition is present, absent, or its 95 % interval cannot tell. The intervals are about this run.",l("p",{class:"headline"},t.headline),...t.numbers.map(o=>l(
"p",{class:"numbers"},`${Bs(o)}.`)),l("ul",{class:"findings"},...n),e.limits?l("p",{class:"small"},e.limits):null);return s.classList.add("diagnosis"),{element:s}}
function hi(e){let[,t=""]=e.split(/, because (.*)/s);return Bs(t.replace(/\.$/,""))}var Bs=e=>e.charAt(0).toUpperCase()+e.slice(1);var fi=40,Et=class{element;#e;#n=l("div",{class:"episodes",role:"group","aria-label":"Episodes of this cell"});#t=l("p",{class:"check small numbers","aria-live":"\
polite"});constructor(t){this.#e=t,this.element=l("div",{class:"strip-of-episodes"},this.#n,this.#t)}show(t,r){let{pursuer:n,evader:s,episode:o,seed:a}=this.#e.
selected,i=xe(t,n,s);this.#n.replaceChildren(...(i?.rates??[]).slice(0,fi).map((p,h)=>this.#s(p,h)));let c=a===null?i?.rates[o]:void 0,u=r.statistics.capture_rate,
d=c!==void 0&&Math.abs(u-c)<1e-6&&r.length===i?.lengths[o],m=i?"Not an episode of the evaluation":"The evaluation played no episodes of this pair.";this.#t.dataset.
equal=String(d),this.#t.textContent=d?"As in the evaluation":c===void 0?m:`Episode ${o+1} differs from the evaluation.`,this.#t.title=`Played here: capture rate\
 ${C(u,3)} in ${r.length} steps.${i?` The cell says ${C(i.rate,3)}.`:""}`}#s(t,r){let{selected:n}=this.#e,s=l("span",{class:"bar"});return s.style.height=`${Math.
round(100*t)}%`,l("button",{type:"button",class:"episode",title:`Episode ${r+1}: capture rate ${C(t)}`,"aria-label":`Episode ${r+1}, capture rate ${C(t)}`,"aria\
-pressed":String(r===n.episode&&n.seed===null),onclick:()=>this.#e.select({episode:r,seed:null})},s,l("span",{class:"count"},r+1))}};var Tt=["stay","north","east","south","west","northeast","southeast","southwest","northwest"];var Gs=0,js=1,gi=2,yi=176;function qs(e,t,r,n){let s=devicePixelRatio||1,o=mt(e);e.width=e.height=yi*s;let a=e.getContext("2d");if(!a)return;let{fov:i}=t,c=e.width/
i;a.fillStyle=o.paper,a.fillRect(0,0,e.width,e.height);for(let d=0;r&&d<i*i;d++){let[m,p]=[(d%i+.5)*c,(Math.floor(d/i)+.5)*c],h=g=>!!r[g*i*i+d];h(gi)&&(a.fillStyle=
o.obstacle,a.fillRect(m-c/2,p-c/2,c,c));let v=h(Gs)&&h(js)?c*.18:0;h(Gs)&&Vs(a,se,m+v,p+v,c*.74,o.evader),h(js)&&Vs(a,dt,m-v,p-v,c*.86,o.pursuer)}a.strokeStyle=
n<t.n_pursuers?o.pursuer:o.evader,a.lineWidth=2*s;let u=Math.floor(i/2)*c;a.strokeRect(u,u,c,c)}function Vs(e,t,r,n,s,o){t(e,r,n,s),e.fillStyle=o,e.fill()}var Ks="What it remembers: a number for each unit, from -1 to 1",Ct=class{element;#e;#n=l("canvas",{class:"seen",role:"img"});#t=l("h3");#s=l("p",{class:"small \
muted"});#o=l("div",{class:"answers"});#r=l("div",{title:Ks});#l=null;#d=null;#u=null;#p=null;#c=null;#a=null;#m=0;constructor(t){this.#e=t,this.element=l("div",
{class:"inspector","data-open":"false"},l("p",{class:"hint small muted"},"Click an agent, or press A: what it sees, and what its network answers."),l("div",{class:"\
inspected"},this.#n,l("div",{class:"answer"},this.#t,this.#s,this.#r),this.#o))}get agent(){return this.#a}show(t,r,n,s){this.#l?.free(),this.#l=t.world(r.world),
this.#u!==r&&(this.#d=null,this.#a!==null&&this.choose(null)),[this.#u,this.#p,this.#c]=[r,n,s]}set solution(t){this.#d=t,this.at(this.#m)}choose(t){this.#a=t,this.
element.dataset.open=String(t!==null),this.#e(t),this.at(this.#m)}next(t){let r=this.#p;if(!r)return;let n=this.#a??(t>0?-1:0);for(let s=0;s<r.n_agents;s++)if(n=
(n+t+r.n_agents)%r.n_agents,r.alive[this.#m*r.n_agents+n])return this.choose(n)}at(t){this.#m=t;let[r,n,s,o,a]=[this.#p,this.#l,this.#u,this.#c,this.#a];if(!r||
!n||!s||!o||a===null)return;let i=a<r.config.n_pursuers?"pursuer":"evader";this.#r.replaceChildren(),this.#t.replaceChildren(l("span",{class:i},H(a,r.config.n_pursuers)));
let c={pursuers:G(s,"pursuer",o.pursuer),evaders:G(s,"evader",o.evader)};r.seek(n,t,c);let u=r.actions.subarray(t*r.n_agents,(t+1)*r.n_agents);for(;u.length&&!n.
over&&(a<n.actors[0]||a>=n.actors[1]);)n.playTurn(u);let d=!!(r.alive[t*r.n_agents+a]&&n.read("alive")[a]);qs(this.#n,r.config,d?n.view(a):null,a),this.#n.ariaLabel=
`Field of view of ${H(a,r.config.n_pursuers)}: evaders, pursuers and obstacles around it`;let m=u[a]??null;if(!d)return this.#h([],"It is gone.");let p=c[`${i}s`],
h=typeof p=="string"?null:n.answer(p,a),v=h?.probabilities??null;h?.memory.length&&this.#r.replaceChildren(l("p",{class:"small muted"},"It remembers:"),xi(h.memory));
let g=this.#d?.game(n)??null,b=typeof p=="string"?`The script "${p}" plays for it${m===null?"":`; it goes ${Tt[m]}`}.`:p.sampled?"Its action is drawn from these\
 probabilities.":"It takes the most probable action.",A=[["network",v],["perfect",g?.marginal(a)??null]],y=tt(r.config),x=S=>l("p",{class:"small muted"},S);this.#h(
[...g?[x(`Value ${g.value.toFixed(2)} under perfect play.`)]:[],...vi(A,m),...y?[x(`Perfect play is not known: ${y}.`)]:[]],m===null?"The episode is over.":b)}#h(t,r){
this.#o.replaceChildren(...t),this.#s.textContent=r}};function vi(e,t){let r=e.filter(([,o])=>o);if(!r.length)return[];let n=l("div",{class:"action muted"},l("s\
pan"),...r.map(([o])=>l("span",{class:"head"},o))),s=Array.from(r[0][1],(o,a)=>l("div",{class:a===t?"action taken":"action"},l("span",{},Tt[a]),...r.flatMap(([,
i])=>bi(i[a]))));return r.length>1||r[0][0]!==e[0][0]?[n,...s]:s}function bi(e){let t=l("span",{class:"filled"});return t.style.width=`${100*e}%`,[l("span",{class:"\
track"},t),l("span",{class:"numbers"},e.toFixed(2))]}function xi(e){let t=Array.from(e,r=>{let n=l("span",{title:r.toFixed(2)});return n.style.transform=`scaleY\
(${r})`,n});return l("div",{class:"units",role:"img","aria-label":Ks},...t)}function kt(e,t,{pursuer:r,evader:n,episode:s,seed:o}){let a=t.seeds[r][n];return e.match(t.world,G(t,"pursuer",r),G(t,"evader",n),BigInt(o??a),s)}function Ys(e){let t=JSON.stringify(e,(r,n)=>r==="genome"?Array.from(n):n);return l("script",{type:"application/json",id:"champions"},t.replaceAll("<","\\u003c")).
outerHTML}var Zs="champion",Js=0,xr=64,wr=100;var wi=(e,t)=>Object.keys(e).every(r=>e[r]===t[r]);function Xs(e,t){return Object.keys(t).find(r=>wi(t[r],e))??null}var qe="_",Si="n",Ku=2n**64n-1n;var Sr={fov:11,maxSteps:500,rewards:"paper"},Mi=["rules","others","rewards","size","diagonal","fov","limit","seed","ended","walls","pursuers","evaders","played",
"next"];function to(e,t){let r=i=>i.map(c=>Ei(c,t)).join(""),n=i=>`${Math.floor(i/e.cols)}.${i%e.cols}`,s=Ai(e.rewards,t),o=[e.seed,e.episode,e.steps].join("."),a={rules:eo(
e.rules,t),others:e.others?eo(e.others,t):"",rewards:s===Sr.rewards?"":s,size:`${e.rows}x${e.cols}`,diagonal:e.diagonal?"1":"",fov:e.fov===Sr.fov?"":String(e.fov),
limit:e.maxSteps===Sr.maxSteps?"":String(e.maxSteps),seed:o==="0.0.0"?"":o,ended:e.ended?"1":"",walls:e.walls.map(n).join(qe),pursuers:e.pursuers.map(Qs).join(qe),
evaders:e.evaders.map(Qs).join(qe),played:e.played.map(r).join(qe),next:e.next.every(i=>i===Js)?"":r(e.next)};return Mi.filter(i=>a[i]).map(i=>`${i}=${a[i]}`).join(
"&")}function Qs({cell:e,gone:t,captured:r,everCaptured:n}){let s=r?"c":n?"e":"";return`${e[0]}.${e[1]}${s}${t?"x":""}`}function eo(e,t){let r=t.fields.map(({name:n})=>String(
e[n]).toLowerCase());return Xs(e,t.variants)??r.join(".")}function Ai(e,t){let r=JSON.stringify(e);return Object.keys(t.rewards).find(s=>JSON.stringify(t.rewards[s])===
r)??Object.values(e).map(s=>String(s)).join(qe)}function Ei(e,t){if(typeof e=="number")return String(e);if(e===Zs)return Si;let r=t.scripts.findIndex(({name:n})=>n===
e);return String.fromCharCode(97+r)}var Ti="/* the engine */";function ro(e,t){return l("button",{type:"button",class:"to-playground",title:"Open this step in the playground (G): the same agents a\
nd actions under any rules",onclick:()=>Ci(e(),t)},"What if?")}function Ci(e,t){let r=e!==null&&e.match.n_agents<=wr&&Math.max(e.match.config.rows,e.match.config.
cols)<=xr,n=r?to(ki(e.match,e.step),t):"",s=new TextDecoder().decode(Xt("playground")).replace(Ti,()=>ze("script-engine")).replace("</noscript>",o=>r?o+Ys(e.champions):
o);window.open(`${URL.createObjectURL(new Blob([s],{type:"text/html"}))}#${n}`)}function ki(e,t){let{config:r,n_agents:n}=e,s=Math.max(0,t-1),o=i=>{let c=s*n+i,
u=s*r.n_evaders+i-r.n_pursuers,d=m=>i>=r.n_pursuers&&!!m[u];return{cell:[e.last_positions[2*c],e.last_positions[2*c+1]],gone:!e.alive[c],captured:d(e.captured),
everCaptured:d(e.ever_captured)}},a=Array.from({length:n},(i,c)=>o(c));return{rules:r.rules,others:null,rewards:r.rewards,rows:r.rows,cols:r.cols,diagonal:r.diagonal,
fov:r.fov,maxSteps:r.max_steps,seed:e.seed,episode:BigInt(e.episode),steps:s,ended:s===e.length,walls:Array.from(e.map.keys()).filter(i=>e.map[i]),pursuers:a.slice(
0,r.n_pursuers),evaders:a.slice(r.n_pursuers),played:[],next:Array.from(e.actions.subarray(s*n,(s+1)*n))}}var Oi=.005,Ri=.05,$i=["pursuer","evader"],Pi=4,Oe=new Map;function so(e,t,r="capture-rate"){let n=JSON.stringify([{...t,rewards:null,fov:null},r]),s=Oe.get(n)??
(tt(t)?Promise.resolve(null):_i(e,t,r));return Oe.delete(n),Oe.set(n,s),Oe.size>Pi&&Oe.delete([...Oe.keys()][0]),s}var no=()=>new Promise(e=>setTimeout(e));async function _i(e,t,r){await no();let n=e.solution(t,r);for(;n.goBack();)await no();return n}function oo(e,t,r){let{payoff:n}=e;
return r.flatMap((s,o)=>{let a=[0,0];for(let c=t.n_turns;c>0&&!t.over;c--)e.game(t)?.lost(s).forEach((u,d)=>a[d]+=u),t.playTurn(s);let i=n==="capture-rate"?Oi:Ri;
return $i.map((c,u)=>({step:o+1,team:c,lost:a[u],payoff:n})).filter(c=>c.lost>=i)})}var ao=e=>e.map(t=>({step:t.step,kind:t.team,size:t.lost/Math.max(1,...e.map(
({lost:r})=>r)),text:Mr(t)})),Li=({lost:e,payoff:t})=>t==="capture-rate"?`${e.toFixed(2)} of the capture rate`:`${e.toFixed(1)} steps`,Mr=e=>`The ${e.team}s los\
e ${Li(e)} against a perfect opponent`;function io(e,t,r){if(r===0)return[{kind:"start",text:Ni(e),agents:[]}];let[n,s]=[t.moments[r-1],t.moments[r]],o=d=>H(d,e.config.n_pursuers),a=We(t,n,s),i=e.conflicts(
r),c=new Set(i.flatMap(d=>d.doomed)),u=a.map(d=>({kind:"capture",text:`${o(d)} is captured`,agents:[d]}));for(let d of ct(n,s))!a.includes(d)&&!c.has(d)&&u.push(
{kind:"end",text:`${o(d)} disappears`,agents:[d]});return u.push(...i.map(({kind:d,text:m,agents:p})=>({kind:d,text:m,agents:p}))),r===e.length&&u.unshift({kind:"\
end",text:Ii(e),agents:[]}),u}function Ni({config:e}){return`${e.n_pursuers} pursuers and ${e.n_evaders} evaders on ${e.rows} x ${e.cols} cells, at most ${e.max_steps}\
 steps`}function Ii(e){let t=Math.round(e.statistics.capture_rate*e.config.n_evaders);return`The episode ends after ${e.length} steps with ${t} of ${e.config.n_evaders}\
 evaders captured`}var Fi=60,Ot=class{element;player=new Y(0,{speed:pt,still:oe()});inspector;match=null;recording=null;actions;#e;#n;#t;#s;#o=l("h2",{class:"match-title"});#r=l("\
p",{class:"tally numbers"});#l=l("ol",{class:"words",tabindex:0,"aria-live":"off","aria-label":"What happened in this step"});#d=l("p",{class:"problem",role:"al\
ert"});#u=null;#p=null;#c=0;#a=!1;#m=0;#h=[];constructor(t,r,n){[this.#n,this.#t]=[t,r];let s=l("canvas",{"aria-label":"The match"});this.#e=new Me(s,{numbers:!1}),
this.#s=new Et(r),this.inspector=new Ct(o=>this.#b(o)),s.addEventListener("click",o=>this.inspector.choose(this.#e.agentAt(o.clientX,o.clientY))),this.actions=l(
"div",{class:"beside"},l("button",{type:"button",class:"to-play",title:"Move the chosen agent, or an evader, yourself from this step on (T)",onclick:()=>this.element.
dispatchEvent(new Event("takeover"))},"Take over"),n&&ro(()=>this.shown,n)),this.element=l("section",{class:"card match-card","aria-label":"Match",id:"match"},l(
"div",{class:"match"},l("header",{class:"match-head"},this.#o,this.#r),this.#d,l("div",{class:"stage"},s),l("div",{class:"aside"},this.#l,At(),this.actions,this.
inspector.element),Ae(this.player),this.#s.element)),this.player.addEventListener("frame",()=>this.recording&&this.#e.show(this.recording,this.player.time)),this.
player.addEventListener("step",()=>this.#v()),r.on("match",()=>this.#x()),r.on("rest",()=>this.player.pause()),this.#y(),this.#S(0,0)}get#i(){return this.#n[this.#t.
selected.run]}reveal(){this.#e.canvas.scrollIntoView({block:"nearest"})}get shown(){return this.match&&this.#p&&{match:this.match,step:this.player.step,champions:this.#p}}start(t){
this.#u=t,this.#g()}playSoon(){this.#a=!0,this.#c||this.#f()}goTo(t){this.#m=t,!this.#c&&this.match&&this.#g()}#f(){!this.#a||!this.match||(this.#a=!1,this.player.
jump(0),oe()||this.player.play())}#x(){this.#y(),clearTimeout(this.#c),this.#c=setTimeout(()=>this.#g(),Fi)}#g(){clearTimeout(this.#c),this.#c=0,this.player.pause(),
this.#y();let{selected:t}=this.#t,r=wn.map(o=>Sn(this.#i,o,t[o])).find(Boolean)??"";if(this.#d.textContent=r,r||!this.#u)return;this.match=kt(this.#u,this.#i,t);
let[n,s]=this.names(t);this.#p={pursuer:{name:n,policy:G(this.#i,"pursuer",t.pursuer)},evader:{name:s,policy:G(this.#i,"evader",t.evader)}},this.recording=Mt(this.
match),this.#s.show(this.#i,this.match),this.inspector.show(this.#u,this.#i,this.match,t),this.player.length=this.match.length,this.player.marks=lt(this.recording),
this.#h=this.player.ticks=[],this.player.jump(this.#m),this.#m=0,this.#v(),this.#w(this.#u,this.match),this.element.dataset.played=`${t.run} ${t.pursuer} ${t.evader}\
 ${t.episode} ${t.seed??""}`,this.#f()}async#w(t,r){let n=await so(t,r.config);if(this.match!==r||!n)return;let s=t.world(r.config);r.seek(s,0),this.#h=oo(n,s,zi(
r)),s.free(),this.player.ticks=ao(this.#h),this.inspector.solution=n,this.#v()}names({run:t,pursuer:r,evader:n}){let{teams:s}=this.#n[t];return[s.pursuer.script??
`pursuers ${r}`,s.evader.script??`evaders ${n}`]}#y(){let{episode:t,seed:r}=this.#t.selected,{payoff:n}=this.#i,[s,o]=this.names(this.#t.selected),a=r===null?t<
n.episodes?`episode ${t+1} of ${n.episodes}`:`episode ${t+1}, not part of the cell`:`seed ${r}`;this.#o.replaceChildren(l("span",{class:"pursuer"},s)," against ",
l("span",{class:"evader"},o),l("span",{class:"muted small"},a))}#v(){let t=this.match;if(!t||!this.recording)return;let r=this.player.step,n=this.recording.moments[r];
this.#S(Array.from(n.everCaptured).filter(Boolean).length,r),this.#l.replaceChildren(...this.#h.filter(s=>s.step===r).map(s=>l("li",{class:`loss-${s.team}`},Mr(
s))),...io(t,this.recording,r).map(s=>l("li",{class:s.kind,"data-agents":s.agents.join(" ")},s.text))),this.inspector.at(r),this.#M()}#S(t,r){this.#r.replaceChildren(
l("strong",{},t),` of ${this.#i.world.n_evaders} captured`,l("span",{class:"muted"},` · step ${r}`))}#b(t){this.#e.look={selected:t,viewers:t===null?[]:[t]},this.#M()}#M(){
let t=this.inspector.agent;for(let r of this.#l.children){let n=r.dataset.agents?.split(" ")??[];r.classList.toggle("about",t!==null&&n.includes(String(t)))}}},
zi=({actions:e,length:t,n_agents:r})=>Array.from({length:t},(n,s)=>e.subarray(s*r,(s+1)*r));var Hi={ArrowUp:[1,0],ArrowDown:[-1,0],ArrowRight:[0,1],ArrowLeft:[0,-1]},Wi=5;function co(e,t,r,n="pursuer"){e.tabIndex=0,e.setAttribute("role","application"),
e.addEventListener("keydown",s=>{let o=Hi[s.key];if(!o)return;let[a,i]=n==="pursuer"?o:[o[1],o[0]],[c,u]=r(),d=s.shiftKey?Wi:1,{pursuer:m,evader:p}=t.selected;t.
select({pursuer:lo(m+d*a,c),evader:lo(p+d*i,u)}),s.preventDefault(),s.stopPropagation()})}var lo=(e,t)=>Math.min(t-1,Math.max(0,e));var Di=24,Rt=7,mo=e=>e<Di&&matchMedia("(pointer: coarse)").matches;function po(e,t,r,n){let[s,o]=e.payoff.shape,[a,i]=[uo(t,s),uo(r,o)],[c,u]=[Math.min(Rt,s),Math.
min(Rt,o)],d=[];for(let v=a+c-1;v>=a;v--){d.push(l("span",{class:"pursuer"},v));for(let g=i;g<i+u;g++)d.push(Ui(e,v,g,n))}let m=Array.from({length:u},(v,g)=>l("\
span",{class:"evader"},i+g)),p=l("button",{type:"button","aria-label":"Close: all cells",onclick:()=>n(null)},"✕"),h=l("div",{class:"loupe numbers",role:"grou\
p","aria-label":"Cells around the tap"},...d,p,...m);return h.style.gridTemplateColumns=`2.4rem repeat(${u}, minmax(0, 1fr))`,h.addEventListener("click",v=>v.stopPropagation()),
h}function Ui(e,t,r,n){let s=xe(e,t,r)?.rate,o=l("button",{type:"button","aria-label":`${C(s)}: pursuers ${t} against evaders ${r}`,onclick:()=>n({pursuer:t,evader:r})},
C(s));return s!==void 0&&([o.style.backgroundColor,o.style.color]=[st(s),nt(s)]),o}var uo=(e,t)=>Math.max(0,Math.min(t-Rt,e-Math.floor(Rt/2)));var _={left:52,bottom:46,top:76,right:84},W=10,Bi=160,Ke=_.right-W-14,ce=_.top-W-14,$t=class{element;#e;#n;#t=l("canvas",{"aria-hidden":"true"});#s=f("svg",{"ar\
ia-hidden":"true"});#o=f("g");#r;#l=l("h2");#d=l("strong",{class:"rate numbers"});#u=l("span",{class:"small muted"});#p=l("p",{class:"of-both-teams small muted \
numbers"});#c=null;constructor(t,r){[this.#n,this.#e]=[t,r],this.#r=l("div",{class:"matrix",id:"matrix","aria-label":"Payoff matrix. Arrow keys choose a match, \
Enter plays it."},this.#t,this.#s);let n=l("header",{class:"readout","aria-live":"polite"},l("div",{},this.#l,this.#p),l("div",{class:"of-cell"},this.#d,this.#u));
this.element=l("section",{class:"card matrix-card","aria-label":"Payoff matrix"},n,this.#r,Q("0 all escape","1 all caught")),this.#x(),new ResizeObserver(()=>this.#m()).
observe(this.#r),this.#r.addEventListener("pointermove",s=>this.#y(s)),this.#r.addEventListener("pointerleave",()=>r.point({})),this.#r.addEventListener("click",
s=>this.#v(s)),this.#r.addEventListener("mousedown",s=>{s.preventDefault(),document.activeElement instanceof HTMLElement&&document.activeElement.blur()}),co(this.#r,
r,()=>this.#a.payoff.shape),this.#r.addEventListener("keydown",s=>{s.key==="Enter"&&this.#b()}),r.on("run",()=>this.#m()),r.on("match",()=>this.#f()),r.on("hove\
r",()=>this.#f())}get#a(){return this.#n[this.#e.selected.run]}#m(){let[t,r]=this.#a.payoff.shape,{clientWidth:n,clientHeight:s}=this.#r;if(n<50)return;let a=Math.
max(Bi,Math.min(n-_.left-_.right,s-_.top-_.bottom))/Math.max(t,r),i=Math.max(_.left,(n-r*a-_.right+_.left)/2),c=_.top+Math.max(0,(s-_.top-_.bottom-t*a)/2),u={width:n,
height:s,left:i,top:c,cell:a,rows:t,columns:r};this.#c=u,Ee(this.#t,this.#a.payoff,{left:i,top:c,width:r*a,height:t*a}),this.#s.setAttribute("viewBox",`0 0 ${n}\
 ${s}`),this.#s.replaceChildren(Gi(u),...ji(u),...this.#i(u),this.#o),this.#f()}#h(t){let r=this.#a.findings?.generalization;if(!r)return[];let{selected:n,hover:s}=this.#e,
[o,a]=[s.pursuer??n.pursuer,s.evader??n.evader],[i,c]=ho(t,r.pursuers.mean[o]??0,o),[u,d]=fo(t,r.evaders.mean[a]??0,a);return[f("circle",{class:"dot of-pursuers",
cx:i,cy:c,r:5}),f("circle",{class:"dot of-evaders",cx:u,cy:d,r:5})]}#i(t){let r=this.#a.findings?.generalization;if(!r)return[];let{left:n,top:s,cell:o,rows:a,columns:i}=t,
[c,u]=[n+i*o+W,s-W],d={class:"side"};return[f("rect",{...d,x:c,y:s,width:Ke,height:a*o}),f("rect",{...d,x:n,y:u-ce,width:i*o,height:ce}),...go(r.pursuers,(m,p)=>ho(
t,m,p),"of-pursuers"),...go(r.evaders,(m,p)=>fo(t,m,p),"of-evaders"),f("text",{class:"tick",x:c,y:s+a*o+16,"text-anchor":"start"},"0"),f("text",{class:"tick",x:c+
Ke,y:s+a*o+16,"text-anchor":"end"},"1"),f("text",{class:"tick",x:n-6,y:u-4,"text-anchor":"end"},"0"),f("text",{class:"tick",x:n-6,y:u-ce+8,"text-anchor":"end"},
"1"),f("text",{class:"label of-pursuers",x:c+Ke,y:s+a*o+34,"text-anchor":"end"},"captures"),f("text",{class:"label of-evaders",x:n+i*o+W,y:u-ce+10,"text-anchor":"\
start"},"escapes")]}#f(){let t=this.#c;if(!t)return;let{selected:r,hover:n}=this.#e,{left:s,top:o,cell:a,rows:i,columns:c}=t,u=v=>o+(i-1-v)*a,d=[],m=(v,g)=>f("r\
ect",{class:g,x:s,y:u(v),width:c*a+W+Ke,height:a}),p=(v,g)=>f("rect",{class:g,x:s+v*a,y:o-W-ce,width:a,height:W+ce+i*a});d.push(m(r.pursuer,"strip pursuer"),p(r.
evader,"strip evader")),n.pursuer!==null&&n.pursuer<i&&d.push(m(n.pursuer,"strip hover")),n.evader!==null&&n.evader<c&&d.push(p(n.evader,"strip hover")),d.push(
...this.#h(t));let h={x:s+r.evader*a,y:u(r.pursuer),width:a,height:a};d.push(f("rect",{class:"chosen under",...h}),f("rect",{class:"chosen",...h})),this.#o.replaceChildren(
...d),this.#x()}#x(){let{selected:t,hover:r}=this.#e,n=r.pursuer??t.pursuer,s=r.evader??t.evader,o=xe(this.#a,n,s);this.#l.replaceChildren(l("span",{class:"purs\
uer"},`Pursuers ${n}`)," against ",l("span",{class:"evader"},`evaders ${s}`)),this.#d.textContent=o?C(o.rate,3):"-",this.#u.textContent=o?`capture rate, mean of\
 ${o.rates.length} episodes`:"no episodes were played",this.#p.textContent=this.#g(n,s)}#g(t,r){let n=this.#a.findings?.generalization;if(!n)return"";let s=(o,a)=>hs(
o.mean[a]??null,o.low?.[a]??null,o.high?.[a]??null);return`Against all: captures ${s(n.pursuers,t)}, escapes ${s(n.evaders,r)}`}#w(t){let r=this.#c;if(!r)return null;
let n=this.#r.getBoundingClientRect(),s=Math.floor((t.clientX-n.left-r.left)/r.cell),o=r.rows-1-Math.floor((t.clientY-n.top-r.top)/r.cell),[a,i]=[o>=0&&o<r.rows,
s>=0&&s<r.columns];return a||i?{g:a?o:-1,h:i?s:-1,inside:a&&i}:null}#y(t){let r=this.#w(t);this.#e.point(r?{pursuer:r.g<0?null:r.g,evader:r.h<0?null:r.h}:{})}#v(t){
let r=this.#w(t);if(r){if(r.inside&&mo(this.#c.cell))return this.#S(r.g,r.h);this.#e.select({...r.g<0?{}:{pursuer:r.g},...r.h<0?{}:{evader:r.h}}),r.inside&&this.#b()}}#S(t,r){
let n=po(this.#a,t,r,s=>{n.remove(),s&&(this.#e.select(s),this.#b())});this.#r.append(n)}#b(){this.#r.dispatchEvent(new CustomEvent("play",{bubbles:!0}))}};function Gi({
left:e,top:t,cell:r,rows:n,columns:s}){let o=f("g",{class:"axes"}),a=t+n*r,i=c=>Ge(0,c-1,Math.min(c,c*r/44),!0);for(let c of i(s))o.append(f("text",{class:"tick",
x:e+(c+.5)*r,y:a+16,"text-anchor":"middle"},c));for(let c of i(n))o.append(f("text",{class:"tick",x:e-7,y:a-(c+.5)*r,"text-anchor":"end","dominant-baseline":"mi\
ddle"},c));return o.append(f("text",{class:"label of-evaders",x:e+s*r/2,y:a+36,"text-anchor":"middle"},"evader generation"),f("text",{class:"label of-pursuers",
transform:`translate(${e-36} ${t+n*r/2}) rotate(-90)`,"text-anchor":"middle"},"pursuer generation")),o}function ji({left:e,top:t,cell:r,rows:n,columns:s}){let o=f(
"g",{class:"diagonal"}),a=Math.min(n,s);if(a<3)return[];let i=t+n*r;for(let d of["H","V"]){let m=`M${e} ${i}`;for(let p=1;p<=a;p++){let[h,v]=[`H${e+p*r}`,`V${i-
p*r}`];m+=d==="H"?h+v:v+h}o.append(f("path",{d:m,class:"under"}),f("path",{d:m}))}let[c,u]=[e+a/2*r-.7*r-4,i-a/2*r-.7*r-4];return[o,f("text",{class:"on-cells",transform:`\
translate(${c} ${u}) rotate(-45)`,"text-anchor":"middle"},"same generation")]}var ho=({left:e,top:t,cell:r,rows:n,columns:s},o,a)=>[e+s*r+W+o*Ke,t+(n-a-.5)*r],fo=({
left:e,top:t,cell:r},n,s)=>[e+(s+.5)*r,t-W-n*ce];function go(e,t,r){let n=o=>o.map((a,i)=>t(a??0,i).map(c=>c.toFixed(1)).join(" ")),s=[];return e.low&&e.high&&s.
push(f("path",{class:`band ${r}`,d:`M${[...n(e.high),...n(e.low).reverse()].join("L")}Z`})),s.push(f("path",{class:`line ${r}`,d:`M${n(e.mean).join("L")}`})),s}var Vi=84;function yo(e,t){let r=e.map((o,a)=>qi(o,a,t)),n=l("nav",{class:"races","aria-label":"Runs"},...r.map(o=>o.button)),s=()=>r.forEach((o,a)=>o.update(a===
t.selected.run));return t.on("match",s),t.on("hover",s),s(),n.hidden=e.length<2,n}function qi(e,t,r){let[n,s]=e.payoff.shape,o=!e.name.startsWith(e.schedule),a=Vi/
Math.max(n,s),i=l("canvas",{"aria-hidden":"true"});Ee(i,e.payoff,{left:0,top:0,width:s*a,height:n*a});let c=l("span",{class:"place"}),u=l("button",{type:"button",
class:"race",title:`${e.name} (key ${t+1})`,onclick:()=>Yi(e,t,r)},l("span",{class:"small-matrix"},i,c),l("span",{class:"race-text"},l("strong",{},o?e.name:e.schedule),
l("span",{class:"small"},e.findings?e.findings.headline:`${e.learning.join(" and ")}s against ${Ki(e)}`),l("span",{class:"small muted"},`${o?`${e.schedule}, `:""}\
seed ${e.seed}`)));return{button:u,update:m=>{u.setAttribute("aria-current",String(m));let p=r.hover.pursuer??r.selected.pursuer,h=r.hover.evader??r.selected.evader;
c.hidden=p>=n||h>=s,c.style.left=`${(h+.5)*a}px`,c.style.top=`${(n-p-.5)*a}px`}}}var Ki=e=>e.teams.pursuer.script??e.teams.evader.script??"another run";function Yi(e,t,r){
let[n,s]=e.payoff.shape,{pursuer:o,evader:a}=r.selected;r.select({run:t,pursuer:Math.min(o,n-1),evader:Math.min(a,s-1)})}var vo={pursuer:null,evader:null},Pt=class extends EventTarget{#e;#n=vo;constructor(t){super(),this.#e=t}get selected(){return this.#e}get hover(){return this.#n}select(t){
let r=this.#e,n=["run","pursuer","evader"].some(s=>s in t&&t[s]!==r[s]);this.#e={...r,...n?{episode:0,seed:null}:{},...t},this.#e.run!==r.run&&this.dispatchEvent(
new Event("run")),this.dispatchEvent(new Event("match"))}point(t){let r={...vo,...t};r.pursuer===this.#n.pursuer&&r.evader===this.#n.evader||(this.#n=r,this.dispatchEvent(
new Event("hover")))}on(t,r){this.addEventListener(t,r)}};var bo=1,Zi=8;function xo({runs:e},t){let r=e[bo],[n,s]=r.payoff.shape,o=new Y(0,{speed:Zi,still:oe()}),a=l("canvas",{"aria-label":"The chase"}),i=l("p",{class:"\
numbers"}),c=new Me(a,{numbers:!1});return t.then(u=>{let d=kt(u,r,{run:bo,pursuer:n-1,evader:s-1,episode:0,seed:null}),m=Mt(d);o.addEventListener("frame",()=>c.
show(m,o.time)),o.addEventListener("step",()=>{let p=Array.from(m.moments[o.step].everCaptured).filter(Boolean).length;i.textContent=`Step ${o.step}: ${p} of ${r.
world.n_evaders} evaders captured`}),o.length=d.length,o.marks=lt(m),o.jump(0)}),l("div",{class:"widget chase"},l("div",{class:"stage"},a),i,Ae(o),At())}function wo({
runs:e,playground:t},r){let n=e[0].payoff.shape.map(u=>u-1),s=new Pt({run:0,pursuer:n[0],evader:n[1],episode:0,seed:null}),[o,a]=[new Ot(e,s,t),new $t(e,s)];o.actions.
remove(),a.element.addEventListener("play",()=>{o.playSoon(),o.reveal()}),r.then(u=>o.start(u));let{seed:i,world:c}=e[0];return l("div",{class:"widget wide"},yo(
e,s),l("div",{class:"stages"},a.element,o.element),l("p",{class:"small muted"},"Three races of ",l("code",{},`matrixworld evolve --seed ${i}`),`: ${c.n_pursuers}\
 pursuers and ${c.n_evaders} evaders on ${c.rows} x ${c.cols} cells.`))}function So({runs:e}){let[t,r]=[e[0],e[0].findings],[n,...s]=r.table,o=s.findIndex(([i,,
,c])=>i==="arms race"&&c==="last half"),a={headline:t.name,numbers:[],table:[n,s[o]],reasons:[r.reasons[o]]};return l("div",{class:"widget text"},Us({...t,findings:{
...r,...a}}).element)}var D=32,Mo=({crossings:e=[]})=>l("div",{class:"widget crossings"},...e.map(t=>l("figure",{},l("figcaption",{},t.title),Ji(t),l("p",{class:"small muted"},t.text))));
function Ji({title:e,text:t,ways:r}){let n=[0,1,2,3].map(s=>`M${s*D} 0V${3*D}M0 ${s*D}H${3*D}`).join("");return f("svg",{viewBox:`-1 -1 ${3*D+2} ${3*D+2}`,role:"\
img","aria-label":`${e}: ${t}`},f("path",{class:"grid",d:n}),...r.map(([s,o,a],i)=>f("g",{transform:`translate(${1.5*D} ${1.5*D})`},f("g",{transform:`translate(${-D*
o} ${-D*s})`},f("path",{class:"filled-pursuer",d:"M0 -12 12 9H-12z"}),f("text",{y:6.5,"text-anchor":"middle"},`P${i}`)),f("path",{class:a?"goes":"waits",d:a?"M-\
18 0H-5M-9 -4 -4 0 -9 4":"M-16 -13V13",transform:`rotate(${Math.atan2(s,o)*180/Math.PI})`}))))}var Ao="matrixworld lesson",Ar={choices:[],solved:{},exit:"",done:!1},_t=class extends EventTarget{#e;keeps=!0;constructor(){super(),this.#e=this.#n(),this.#t({})}choice=t=>this.#e.
choices.find(({prediction:r})=>r===t)?.choice;choose(t,r){let n=new Date().toISOString().replace(/\.\d+Z$/,"+00:00");this.#t({choices:[...this.#e.choices,{prediction:t,
choice:r,time:n}]}),this.dispatchEvent(new CustomEvent("choice",{detail:t}))}solved=t=>this.#e.solved[t];solve=(t,r)=>this.#t({solved:{...this.#e.solved,[t]:r}});get exit(){
return this.#e}set exit(t){this.#t(t)}get count(){return this.#e.choices.length}get file(){return this.#e.choices.map(t=>`${JSON.stringify(t)}
`).join("")}forget(){this.#t(Ar)}#n(){try{return{...Ar,...JSON.parse(localStorage.getItem(Ao)??"{}")}}catch{return Ar}}#t(t){this.#e={...this.#e,...t};try{localStorage.
setItem(Ao,JSON.stringify(this.#e))}catch{this.keeps=!1}}};var Ye=e=>e!==void 0&&"predict"in e,Xi=e=>"outcome"in e&&!Ye(e),F=An(),z=new _t,To=new Map(F.sections.flatMap(({parts:e})=>e.filter(Ye).map(t=>[t.predict,t]))),
Qi={chase:()=>xo(F,Eo),"right-of-way":Mo,flat:Ss,hands:Rs,"hands-matrix":$s,games:zs,numbers:Hs,matrices:()=>xs(F),explorer:()=>wo(F,Eo),judgement:()=>So(F),"sa\
me-diagonal":ws,exit:e=>Rn(e,z)},el=e=>"widget"in e?e.needs:Xi(e)?e.outcome:void 0;function tl(e){if("text"in e)return l("div",{class:"text"},...er(e.text));if("\
widget"in e)return Qi[e.widget](e);if("exercise"in e)return On(e,z);if(Ye(e))return kn(e,z);let t=To.get(e.outcome);return l("div",{class:"prediction"},l("p",{},
l("strong",{},t.question)),tr(t,z.choice(e.outcome)))}function rl(e,t){let r=l("p",{class:"waiting muted",role:"status"}),n=l("section",{class:"card",id:e.id,"a\
ria-labelledby":`title-${e.id}`},l("h2",{id:`title-${e.id}`},`${t+1}. ${e.title}`,l("span",{class:"muted small"},`${e.minutes} minutes`)),r),s=0,o=()=>{for(r.textContent=
"";s<e.parts.length;s++){let[a,i]=[e.parts[s-1],e.parts[s]],c=[Ye(a)?a.predict:void 0,el(i)].find(u=>u&&z.choice(u)===void 0);if(c){let u=F.sections.findIndex(({
parts:d})=>d.some(m=>Ye(m)&&m.predict===c));r.textContent=`This section goes on with your prediction${u===t?"":` in section ${u+1}`}.`;return}r.before(tl(i))}r.
remove()};return z.addEventListener("choice",o),o(),n}var Co=()=>{},Eo=new Promise(e=>Co=e),ko=l("span",{class:"small muted",role:"status"}),Oo=()=>{ko.textContent=
`${z.count} of ${To.size} predictions made. `+(z.keeps?"They stay in this browser.":"This browser keeps nothing: save before you close the page.")};z.addEventListener(
"choice",Oo);var nl=()=>{confirm("Delete all predictions and answers in this browser, for another student? Save them first.")&&(z.forget(),location.reload())};document.
getElementById("page").replaceWith(l("header",{class:"top"},l("div",{},l("h1",{},F.title),l("p",{class:"lead"},F.lead)),l("div",{class:"tools"},dn())),l("nav",{
class:"sections","aria-label":"Sections"},...F.sections.map((e,t)=>l("a",{href:`#${e.id}`},`${t+1}. ${e.title}`))),l("main",{},...F.sections.map(rl)),l("footer",
{class:"card"},l("div",{class:"buttons"},l("button",{type:"button",class:"primary save",onclick:()=>rr("predictions.jsonl",z.file)},"Save my predictions"),l("bu\
tton",{type:"button",onclick:()=>print()},"Print"),l("button",{type:"button",onclick:nl},"Start anew"),ko),l("p",{class:"small muted"},`The page sends nothing a\
nywhere. matrixworld ${F.version}`)));Oo();requestAnimationFrame(()=>setTimeout(()=>{cn().then(Co,e=>{document.querySelector("main").prepend(l("p",{class:"card \
problem",role:"alert"},`The engine does not start here: ${String(e)}`))}).finally(()=>document.body.dataset.ready="true")}));})();
