/* built from web/ by "npm run build"; sources ddb13f157b8ae616b14690b13a2e4818600e9bc37f049f6021d61d6474cc90dd */
"use strict";(()=>{var Nn={SIMULTANEOUS:0,SWARM_TURNS:1,AGENT_TURNS:2},tt={DISAPPEAR:0,REACH:1,BOUNCE:2},In={OCCUPATION:0,SURROUND:1},Fn={FAULT:0,INVOLVED:1};var Or=["obstacle","teammate","adversary"],Rr=["vertex","edge","chain"],Un=["turn","kind","form","first","second","row","col","at_fault","held","doomed"],Pr=["p\
ursuer_{number}","evader_{number}"],Dn={obstacle:"{first} ran into the obstacle or border at {cell}",vertex:"{first} and {second} both headed for {cell}",edge:"\
{first} and {second} meant to swap, {first} to {cell}",chain:"{first} headed for {cell}, where {second} had to stay"},rt={"both held":"both bounce","both doomed":"\
both disappear",held:"{agent} bounces",doomed:"{agent} disappears",none:"nobody is stopped"},zn="{event}: {outcome}",Lr={random:"any action, all equally likely",
still:"always stays",chaser:"moves to where the nearest adversary in view is nearest",fleer:"moves to where the nearest adversary in view is farthest","clumsy-c\
haser":"a chaser that takes any action in half of the steps",hunter:"a chaser of the nearest adversary in view to which no teammate in view is nearer",surrounder:"\
a chaser of the nearest free cell beside an adversary without a teammate","clumsy-fleer":"a fleer that takes any action in half of the steps",dodger:"moves to w\
here all adversaries in view together are farthest","team-surrounder":"shares the free cells beside adversaries with its teammates, and searches","careful-rando\
m":"as random, but takes only moves that right of way allows","careful-chaser":"as chaser, but takes only moves that right of way allows","careful-fleer":"as fl\
eer, but takes only moves that right of way allows","careful-clumsy-chaser":"as clumsy-chaser, but takes only moves that right of way allows","careful-hunter":"\
as hunter, but takes only moves that right of way allows","careful-surrounder":"as surrounder, but takes only moves that right of way allows","careful-clumsy-fl\
eer":"as clumsy-fleer, but takes only moves that right of way allows","careful-dodger":"as dodger, but takes only moves that right of way allows","careful-team-\
surrounder":"as team-surrounder, but takes only moves that right of way allows"},Wn={free:".GS",blocked:"#@OTW"};var Ne=1+Un.length;function nt(r,e){return r.replace(/\{(\w+)\}/g,(t,n)=>String(e[n]))}function H(r,e){return r<e?nt(Pr[0],{number:r}):nt(Pr[1],{number:r-e})}function Ba(r,e){
let[t,n,s,o,a,i,l,...u]=Array.from(r),h=a<0?[o]:[o,a],[c,d,f]=u.map(v=>h.filter((x,b)=>v>>b&1)),y=h.map(v=>H(v,e)),p=nt(Dn[a<0?"obstacle":Rr[s]],{first:y[0],second:y[y.
length-1],cell:`(${i}, ${l})`}),g=nt(zn,{event:p,outcome:ja(h.length,d,f,e)});return{kind:Or[n],form:Rr[s],agents:h,cell:[i,l],at_fault:c,held:d,doomed:f,turn:t,
text:g}}function ja(r,e,t,n){if(r===2&&e.length===2)return rt["both held"];if(r===2&&t.length===2)return rt["both doomed"];let s=o=>a=>nt(rt[o],{agent:H(a,n)});
return[...e.map(s("held")),...t.map(s("doomed"))].join(", ")||rt.none}function kt(r,e){let t=[];for(let n=0;n<r.length;n+=Ne)t.push(Ba(r.subarray(n+1,n+Ne),e));
return t}var ge=class extends Error{name="EngineError"};function I(r,e,t){let n=typeof t=="string"?`'${t}'`:typeof t=="object"?JSON.stringify(t):String(t);return new ge(
`${r}: expected ${e}, got ${n}`)}var Ie=class{bytes;constructor(e){this.bytes=e}},Hn=0,Nr=[Uint8Array,Uint8Array,Int32Array,BigInt64Array,BigUint64Array,Float32Array,Float64Array],Bn=4,jn=4,Ha=new TextEncoder,
Ga=new TextDecoder;function Va(r){for(let e=Nr.length-1;e>Hn;--e)if(r instanceof Nr[e])return e;throw new TypeError("array: expected a typed array of the engine\
's numbers, got another")}function $r(r){return new Uint8Array(r.buffer,r.byteOffset,r.byteLength)}function Ya(r){return Ha.encode(`${r}\0`)}var Ir=class{engine;addresses=[];constructor(e){
this.engine=e}copy(e){let t=this.engine._malloc(Math.max(e.length,1));if(t===0)throw new ge("memory: expected room for the arguments, got none");return this.addresses.
push(t),this.engine.HEAPU8.set(e,t),t}text(e){return this.copy(Ya(e))}arrays(e){let t=Object.entries(e),n=t.flatMap(([o,a])=>{let i=a instanceof Ie,l=i?a.bytes:
a;return[this.text(o),i?Hn:Va(l),l.length,this.copy($r(l))]}),s=this.copy($r(Int32Array.from(n)));return this.copy($r(Int32Array.of(t.length,s)))}free(){for(let e of this.
addresses)this.engine._free(e)}};function Gn(r,e){let t=r.HEAPU8;return Ga.decode(t.subarray(e,t.indexOf(0,e)))}function Fe(r){let e=new Int32Array(r.HEAPU8.buffer),
t=r._last_outputs()/Bn,n=e[t+1]/Bn,s={};for(let o=n;o<n+e[t]*jn;o+=jn){let a=Nr[e[o+1]],i=e[o+2]*a.BYTES_PER_ELEMENT,l=e[o+3];s[Gn(r,e[o])]=new a(r.HEAPU8.slice(
l,l+i).buffer)}return s}function ve(r,e){let t=new Ir(r);try{let n=e(t);if(n===0)throw new ge(Gn(r,r._last_error()));return n}finally{t.free()}}var qa=2**31-1,Vn=["none","elman","gru"],Ka=2n**64n-1n,Za=34028234663852886e22;function de(r,e){if(typeof e!="number"||!Number.isInteger(e)||Math.abs(e)>qa)throw I(
r,"an integer",e);return Int32Array.of(e)}function _t(r,e){if(typeof e!="boolean")throw I(r,"true or false",e);return new Ie(Uint8Array.of(Number(e)))}function Me(r,e,t){
let n=typeof e=="string"&&Object.hasOwn(t,e)?t[e]:void 0;if(n===void 0)throw I(r,`one of ${Object.keys(t).join(", ")}`,e);return Int32Array.of(n)}function Fr(r,e){
if(typeof e!="number"||!(Math.abs(e)<=Za))throw I(r,"a finite number",e);return e}function Ue(r,e){let n=typeof e=="bigint"||typeof e=="number"&&Number.isSafeInteger(
e)?BigInt(e):-1n;if(n<0n||n>Ka)throw I(r,"an integer from 0 to 2^64 - 1",e);return BigUint64Array.of(n)}function Ja(r){return{"rules.interaction":Me("interactio\
n",r.interaction,Nn),"rules.obstacle":Me("obstacle",r.obstacle,tt),"rules.teammate":Me("teammate",r.teammate,tt),"rules.evader":Me("evader",r.evader,tt),"rules.\
pursuer":Me("pursuer",r.pursuer,tt),"rules.capture":Me("capture",r.capture,In),"rules.captured_disappear":_t("captured_disappear",r.captured_disappear)}}function Yn(r,e){
let t=typeof e=="number"?[e,e,e]:e;if(!Array.isArray(t)||t.length!==3)throw I(r,"1 or 3 numbers",e);return Float32Array.from(t,n=>Fr(r,n))}function Xa(r){let e=(t,n)=>Float32Array.
of(Fr(t,r[t]),Fr(n,r[n]));return{"rewards.capture":e("pursuer_capture","evader_capture"),"rewards.neighbor":e("pursuer_neighbor","evader_neighbor"),"rewards.ste\
p":e("pursuer_step","evader_step"),"rewards.pursuer_collide":Yn("pursuer_collide",r.pursuer_collide),"rewards.evader_collide":Yn("evader_collide",r.evader_collide),
"rewards.blame":Me("blame",r.blame,Fn),"rewards.capture_repeats":_t("capture_repeats",r.capture_repeats)}}function Kn(r){if(r===void 0||typeof r=="number")return new Uint8Array(
0);if(r instanceof Uint8Array)return r;let{free:e,blocked:t}=Wn;for(let[n,s]of r.entries()){if(s.length!==r[0]?.length)throw I(`map, row ${n}`,`${r[0]?.length} \
cells as in row 0`,s.length);let o=[...s].find(a=>!e.includes(a)&&!t.includes(a));if(o)throw I(`map, row ${n}`,`'${e}' (free) or '${t}' (obstacle)`,o)}return Uint8Array.
from([...r.join("")],n=>Number(t.includes(n)))}function Zn(r,e){if(!Array.isArray(r))return;let t=[r.length,r[0]?.length??0];if(!(t[0]===e.rows&&t[1]===e.cols))
throw I("obstacle map",`shape (${e.rows}, ${e.cols}), the rows and cols`,t)}function De(r){Zn(r.obstacles,r);let e=typeof r.obstacles=="number"?r.obstacles:0;return{
...Ja(r.rules),...Xa(r.rewards),rows:de("rows",r.rows),cols:de("cols",r.cols),n_pursuers:de("n_pursuers",r.n_pursuers),n_evaders:de("n_evaders",r.n_evaders),fov:de(
"fov",r.fov),diagonal:_t("diagonal",r.diagonal),max_steps:de("max_steps",r.max_steps),density:Float64Array.of(e),map:Kn(r.obstacles)}}function qn(r,e){return Int32Array.
from((e??[]).flat(),t=>de(r,t)[0])}function Jn(r,e){return Zn(r.obstacles,e),{seed:Ue("seed",r.seed??0n),episode:Ue("episode",r.episode??0),pursuers:qn("pursuer\
s",r.pursuers),evaders:qn("evaders",r.evaders),map:Kn(r.obstacles)}}function Ot(r){return{actions:Int32Array.from(r,e=>de("actions",e)[0])}}function ze(r){if(typeof r==
"string"){if(!Object.hasOwn(Lr,r))throw I("policy",`one of ${Object.keys(Lr).join(", ")}`,r);return{script:new TextEncoder().encode(r)}}if(r.activation!=="relu"&&
r.activation!=="tanh")throw I("activation","'relu' or 'tanh'",r.activation);if(!Vn.includes(r.memory))throw I("memory",`one of ${Vn.join(", ")}`,r.memory);return{
hidden:Int32Array.from(r.hidden,e=>de("hidden",e)[0]),activation:new TextEncoder().encode(r.activation),sampled:_t("sampled",r.sampled),memory:new TextEncoder().
encode(r.memory),genome:r.genome}}var Qa=["first_turn","terminated","truncated"];function Xn(r){let e={...r};for(let t of Qa)e[t]=new Ie(r[t]);return e}var Qn="statistics.",Rt=class{config;seed;episode;n_agents;statistics;first_conflict;constructor(e,t,n,s){this.config=e,this.seed=t,this.episode=n,this.n_agents=
e.n_pursuers+e.n_evaders,this.statistics=es(ts(s),0),Object.assign(this,s),this.first_conflict=ei(this.conflict_table,this.length)}get length(){return this.actions.
length/this.n_agents}conflicts(e){this.check(e);let[t,n]=[this.first_conflict[e],this.first_conflict[e+1]],s=this.conflict_table.subarray(t*Ne,n*Ne);return kt(s,
this.config.n_pursuers)}seek(e,t,n){this.check(t),(!(e.seed===this.seed&&e.episode===BigInt(this.episode))||e.turn!==0||e.steps>t)&&e.reset({seed:this.seed,episode:this.
episode});for(let o=e.steps;o<t;++o){let a=this.actions.subarray(o*this.n_agents,(o+1)*this.n_agents);n?e.replay(a,{pursuer:n.pursuers,evader:n.evaders}):e.step(
a)}}check(e){if(!(Number.isInteger(e)&&e>=0&&e<=this.length))throw I("step",`0 to ${this.length}`,e)}};function ei(r,e){let t=new Int32Array(e+2);for(let n=0;n<
r.length;n+=Ne)++t[r[n]+1];for(let n=1;n<t.length;++n)t[n]+=t[n-1];return t}function es(r,e){let t=r.length.length,n=o=>{let a=r[o],i=a.length/t;return a.slice(
e*i,(e+1)*i)},s=o=>Number(n(o)[0]);return{capture_rate:s("capture_rate"),ever_capture_rate:s("ever_capture_rate"),captured_fraction:s("captured_fraction"),length:s(
"length"),return:n("return"),survivors:n("survivors"),overlap:n("overlap"),collisions:n("collisions"),faults:n("faults"),agent_steps:n("agent_steps")}}var ts=r=>Object.
fromEntries(Object.entries(r).flatMap(([e,t])=>e.startsWith(Qn)?[[e.slice(Qn.length),t]]:[]));function rs(r,e,t,n){let s=[De(t.config),ze(t.pursuers),ze(t.evaders),
n];return ve(r,o=>{let[a,i,l,u]=s.map(h=>o.arrays(h));return r[e](a,i,l,u)}),Fe(r)}function ns(r,e,t,n){let s={seed:Ue("seed",t),episode:Ue("episode",n)};return new Rt(
e.config,t,n,rs(r,"_play_match",e,s))}function Ur(r,e,t,n){if(!Number.isInteger(n)||n<1)throw I("n_episodes","at least 1",n);let s=rs(r,"_play_rollout",e,{...t,
n_episodes:Int32Array.of(n)});return ts(s)}function ss(r,e,t,n){let s={pursuer:Int32Array.of(0),evader:Int32Array.of(0),seed:Ue("seed",t)},o=Ur(r,e,s,n);return Array.
from({length:n},(a,i)=>es(o,i))}var ti=7e6,ri=new FinalizationRegistry(([r,e])=>r._states_free(e));function ni({rules:r,rows:e,cols:t,obstacles:n,diagonal:s,n_pursuers:o,n_evaders:a}){let i=typeof n==
"number"||r.obstacle==="REACH"?0:n.join("").split("#").length-1,l=e*t-i,u=[r.obstacle,r.teammate,r.pursuer].includes("DISAPPEAR"),h=r.capture==="SURROUND"||r.evader===
"REACH",c=r.interaction==="AGENT_TURNS",d=(p,g)=>Array.from({length:g},(v,x)=>c?p:(p+x)/(x+1)).reduce((v,x)=>v*x,1),f=d(l+Number(u),o)*d(l*(1+Number(h))+2,a);return{
SIMULTANEOUS:[o+a],SWARM_TURNS:[o,a],AGENT_TURNS:Array(o+a).fill(1)}[r.interaction].reduce((p,g)=>p+f*(s?9:5)**g,0)}function We(r){return typeof r.obstacles=="n\
umber"&&r.obstacles>0?"obstacles are drawn anew in each episode":ni(r)>ti?"the world is too large to be solved on the page":""}var Dr=class{value;teams;matrix;n_actions;constructor(e,t){
let{matrix:n,rows:s,cols:o,value:a,agents:i}=t,[l,u]=e.actors,h=Array.from(i).filter(d=>l<=d&&d<u),c=d=>d<e.config.n_pursuers;[this.value,this.matrix,this.n_actions]=
[a[0],n,e.n_actions],this.teams=[{agents:h.filter(c),play:s},{agents:h.filter(d=>!c(d)),play:o}]}marginal(e){let t=this.teams.find(({agents:o})=>o.includes(e));
if(!t)return null;let n=this.n_actions**(t.agents.length-1-t.agents.indexOf(e)),s=Array(this.n_actions).fill(0);return t.play.forEach((o,a)=>s[Math.floor(a/n)%this.
n_actions]+=o),s}lost(e){let[t,n]=this.teams.map(({agents:l})=>l.reduce((u,h)=>u*this.n_actions+e[h],0)),[s,o]=this.teams.map(({play:l})=>l),a=o.reduce((l,u,h)=>l+
u*this.matrix[t*o.length+h],0),i=s.reduce((l,u,h)=>l+u*this.matrix[h*o.length+n],0);return[Math.max(0,this.value-a),Math.max(0,i-this.value)]}},zr=60,st=class{config;payoff;engine;states;n_turns;values;constructor(e,t,n){
[this.engine,this.config,this.payoff]=[e,t,n],this.states=ve(e,a=>e._states_new(a.arrays(De(t)))),ri.register(this,[e,this.states]);let s={SIMULTANEOUS:1,SWARM_TURNS:2,
AGENT_TURNS:t.n_pursuers+t.n_evaders};this.n_turns=s[t.rules.interaction];let o=this.call(()=>e._states_payoffs(this.states)).payoffs;this.values=[[n==="capture\
-rate"?o:o.fill(0)]]}goBack(){let e=this.values.at(-1)[0],t=[];for(let s=this.n_turns-1;s>=0;s--){let o=t[s+1]??e;t[s]=this.call(a=>this.engine._states_backup(this.
states,s,a.arrays({next:o}))).values}this.payoff==="capture-time"&&(t[0]=t[0].map((s,o)=>o===this.config.n_evaders?0:s-1)),this.values.push(t);let n=this.payoff===
"capture-rate"?this.config.max_steps:Math.min(this.config.max_steps,zr);return this.values.length<=n&&t[0].some((s,o)=>s!==e[o])}game(e){let[t,{turn:n}]=[this.config.
max_steps-e.steps,e],s=n+1===this.n_turns,o=t>0?this.values[Math.min(t-Number(s),this.values.length-1)]?.[s?0:n+1]:void 0;if(!o)return null;let a=this.call(i=>this.
engine._states_game(this.states,e.address,i.arrays({next:o})));return a.agents.length?new Dr(e,a):null}call(e){return ve(this.engine,e),Fe(this.engine)}};var os=new FinalizationRegistry(([r,e])=>r._world_free(e)),ot=class{config;n_agents;n_actions;engine;at;freed=!1;constructor(e,t){this.engine=e,this.config=t,this.
n_agents=t.n_pursuers+t.n_evaders,this.n_actions=t.diagonal?9:5,this.at=ve(e,n=>e._world_new(n.arrays(De(t)))),os.register(this,[e,this.at],this)}free(){this.freed||
(this.freed=!0,os.unregister(this),this.engine._world_free(this.at))}get address(){if(this.freed)throw I("world","one that is in use","one that was freed");return this.
at}reset(e={}){let t=Jn(e,this.config);this.call(n=>this.engine._world_reset(this.address,n.arrays(t)))}step(e){let t=Ot(e);this.call(n=>this.engine._world_step(
this.address,n.arrays(t)))}playTurn(e){let t=Ot(e);this.call(n=>this.engine._world_play_turn(this.address,n.arrays(t)))}decide(e,t,n){let{n_pursuers:s}=this.config,
o={pursuer:[0,s],evader:[s,this.n_agents]},[a,i]=typeof t=="string"?o[t]:t;if(n.length!==this.n_agents)throw I("actions",String(this.n_agents),n.length);let l=[
ze(e),Ot(n)],{actions:u}=this.call(h=>this.engine._world_decide(this.address,h.arrays(l[0]),a,i,h.arrays(l[1])));return Uint8Array.from(u)}replay(e,t){let n=o=>typeof o!=
"string"&&o.memory!=="none";if(!n(t.pursuer)&&!n(t.evader))return this.step(e);let{n_pursuers:s}=this.config;for(let o=this.n_turns;o>0;--o){let[a,i]=this.actors;
a<s&&this.decide(t.pursuer,[a,Math.min(i,s)],e),i>s&&this.decide(t.evader,[Math.max(a,s),i],e),this.playTurn(e)}}get n_turns(){return this.turnNumbers()[1]}get turn(){
return this.turnNumbers()[0]}get actors(){let[,,e,t]=this.turnNumbers();return[e,t]}turnNumbers(){return this.call(()=>this.engine._world_turn(this.address)).turn}get steps(){
return this.read("steps")[0]}get seed(){return this.read("seed")[0]}get episode(){return this.read("episode")[0]}get over(){return this.read("terminated")[0]===
1||this.read("truncated")[0]===1}read(e){return this.call(t=>this.engine._world_read(this.address,t.text(e)))[e]}view(e){let t=3*this.config.fov**2;return this.
read("views").slice(e*t,(e+1)*t)}map(){return this.read("state").slice(2*this.config.rows*this.config.cols)}conflicts(){return kt(this.conflictTable(),this.config.
n_pursuers)}conflictTable(){return this.call(()=>this.engine._world_conflicts(this.address)).conflict_table}answer(e,t){let n=ze(e),{logits:s,memory:o}=this.call(
l=>this.engine._world_logits(this.address,l.arrays(n),t)),a=s,i=this.decide(e,[t,t+1],new Uint8Array(this.n_agents))[t];return{logits:a,probabilities:si(a),action:i,
memory:o}}snapshot(){return this.call(()=>this.engine._world_snapshot(this.address))}restore(e){let t=Xn(e);this.call(n=>this.engine._world_restore(this.address,
n.arrays(t)))}call(e){return ve(this.engine,e),Fe(this.engine)}};function si(r){let e=Math.max(...r),t=Array.from(r,s=>Math.exp(s-e)),n=t.reduce((s,o)=>s+o,0);return Float32Array.
from(t,s=>s/n)}var Wr=class{compiled;constructor(e){this.compiled=e}world(e){return new ot(this.compiled,e)}solution(e,t="capture-rate"){return new st(this.compiled,e,t)}match(e,t,n,s,o=0){
return ns(this.compiled,{config:e,pursuers:t,evaders:n},s,o)}rollout(e,t,n,s,o){return ss(this.compiled,{config:e,pursuers:t,evaders:n},s,o)}rollouts(e,t,n,s,o){
return Ur(this.compiled,{config:e,pursuers:t,evaders:n},s,o)}},as;function Pt(r=globalThis.matrixworldEngine){return as??=oi(r),as}async function oi(r){if(!r)throw new Error(
"matrixworldEngine: expected the script engine.js before this one, got none");let e=Uint8Array.from(atob(r.binary),t=>t.charCodeAt(0));return new Wr(await r({wasmBinary:e}))}var ai="http://www.w3.org/2000/svg";function m(r,e={},...t){return is(document.createElement(r),e,t)}function w(r,e={},...t){return is(document.createElementNS(
ai,r),e,t)}function is(r,e,t){for(let[n,s]of Object.entries(e))s==null||s===!1||(typeof s=="function"?r.addEventListener(n.slice(2),s):r.setAttribute(n,s===!0?"":
String(s)));return r.append(...t.filter(ii).map(n=>typeof n=="number"?String(n):n)),r}function ii(r){return r!=null&&r!==!1}var Lt=()=>["file:","http:","https:"].
includes(location.protocol);async function ls(r,e){r.select();try{await navigator.clipboard.writeText(r.value),e.textContent="Copied."}catch{e.textContent="Sele\
cted: copy it with Ctrl+C."}}function li(){let r=document.documentElement.dataset.theme;return r?r==="dark":matchMedia("(prefers-color-scheme: dark)").matches}function Br(){document.documentElement.
dataset.theme=li()?"light":"dark"}function us(){return m("button",{type:"button",title:"Light or dark (D)","aria-label":"Light or dark",onclick:Br},"◐")}var ui=Array.from({length:16},(r,e)=>{let[t,n]=[e%2?6.5:11,Math.PI*e/8];return`${12+t*Math.sin(n)} ${12-t*Math.cos(n)}`}).join(" ");function $t(){let r=[["pursu\
er",w("path",{d:"M12 3 22 20H2z",class:"filled-pursuer"})],["evader",w("circle",{cx:12,cy:12,r:9,class:"filled-evader"})],["capture",w("polygon",{points:ui,class:"\
filled-capture"})],["captured evader",w("circle",{cx:12,cy:12,r:7.5,class:"ring-evader"})],["conflict",w("rect",{x:3,y:3,width:18,height:18,class:"dashed-confli\
ct"})]];return m("ul",{class:"shapes small","aria-label":"Shapes on the board"},...r.map(([e,t])=>m("li",{},w("svg",{viewBox:"0 0 24 24","aria-hidden":"true"},t),
e)))}var P=Uint8Array,Z=Uint16Array,Jr=Int32Array,Nt=new P([0,0,0,0,0,0,0,0,1,1,1,1,2,2,2,2,3,3,3,3,4,4,4,4,5,5,5,5,0,0,0,0]),It=new P([0,0,0,0,1,1,2,2,3,3,4,4,5,5,6,
6,7,7,8,8,9,9,10,10,11,11,12,12,13,13,0,0]),Vr=new P([16,17,18,0,8,7,9,6,10,5,11,4,12,3,13,2,14,1,15]),fs=function(r,e){for(var t=new Z(31),n=0;n<31;++n)t[n]=e+=
1<<r[n-1];for(var s=new Jr(t[30]),n=1;n<30;++n)for(var o=t[n];o<t[n+1];++o)s[o]=o-t[n]<<5|n;return{b:t,r:s}},ys=fs(Nt,2),gs=ys.b,Yr=ys.r;gs[28]=258,Yr[258]=28;var vs=fs(
It,0),ci=vs.b,cs=vs.r,qr=new Z(32768);for(E=0;E<32768;++E)me=(E&43690)>>1|(E&21845)<<1,me=(me&52428)>>2|(me&13107)<<2,me=(me&61680)>>4|(me&3855)<<4,qr[E]=((me&65280)>>
8|(me&255)<<8)>>1;var me,E,oe=(function(r,e,t){for(var n=r.length,s=0,o=new Z(e);s<n;++s)r[s]&&++o[r[s]-1];var a=new Z(e);for(s=1;s<e;++s)a[s]=a[s-1]+o[s-1]<<1;
var i;if(t){i=new Z(1<<e);var l=15-e;for(s=0;s<n;++s)if(r[s])for(var u=s<<4|r[s],h=e-r[s],c=a[r[s]-1]++<<h,d=c|(1<<h)-1;c<=d;++c)i[qr[c]>>l]=u}else for(i=new Z(
n),s=0;s<n;++s)r[s]&&(i[s]=qr[a[r[s]-1]++]>>15-r[s]);return i}),be=new P(288);for(E=0;E<144;++E)be[E]=8;var E;for(E=144;E<256;++E)be[E]=9;var E;for(E=256;E<280;++E)
be[E]=7;var E;for(E=280;E<288;++E)be[E]=8;var E,lt=new P(32);for(E=0;E<32;++E)lt[E]=5;var E,hi=oe(be,9,0),di=oe(be,9,1),mi=oe(lt,5,0),pi=oe(lt,5,1),jr=function(r){
for(var e=r[0],t=1;t<r.length;++t)r[t]>e&&(e=r[t]);return e},re=function(r,e,t){var n=e/8|0;return(r[n]|r[n+1]<<8)>>(e&7)&t},Hr=function(r,e){var t=e/8|0;return(r[t]|
r[t+1]<<8|r[t+2]<<16)>>(e&7)},Xr=function(r){return(r+7)/8|0},Qr=function(r,e,t){return(e==null||e<0)&&(e=0),(t==null||t>r.length)&&(t=r.length),new P(r.subarray(
e,t))};var fi=["unexpected EOF","invalid block type","invalid length/literal","invalid distance","stream finished","no stream handler",,"no callback","invalid UTF-8 da\
ta","extra field too long","date not in range 1980-2099","filename too long","stream finishing","invalid zip data"],G=function(r,e,t){var n=new Error(e||fi[r]);
if(n.code=r,Error.captureStackTrace&&Error.captureStackTrace(n,G),!t)throw n;return n},yi=function(r,e,t,n){var s=r.length,o=n?n.length:0;if(!s||e.f&&!e.l)return t||
new P(0);var a=!t,i=a||e.i!=2,l=e.i;a&&(t=new P(s*3));var u=function(Qe){var et=t.length;if(Qe>et){var $e=new P(Math.max(et*2,Qe));$e.set(t),t=$e}},h=e.f||0,c=e.
p||0,d=e.b||0,f=e.l,y=e.d,p=e.m,g=e.n,v=s*8;do{if(!f){h=re(r,c,1);var x=re(r,c+1,3);if(c+=3,x)if(x==1)f=di,y=pi,p=9,g=5;else if(x==2){var $=re(r,c,31)+257,L=re(
r,c+10,15)+4,M=$+re(r,c+5,31)+1;c+=14;for(var S=new P(M),F=new P(19),N=0;N<L;++N)F[Vr[N]]=re(r,c+N*3,7);c+=L*3;for(var W=jr(F),ye=(1<<W)-1,Y=oe(F,W,1),N=0;N<M;){
var B=Y[re(r,c,ye)];c+=B&15;var b=B>>4;if(b<16)S[N++]=b;else{var U=0,O=0;for(b==16?(O=3+re(r,c,3),c+=2,U=S[N-1]):b==17?(O=3+re(r,c,7),c+=3):b==18&&(O=11+re(r,c,
127),c+=7);O--;)S[N++]=U}}var j=S.subarray(0,$),D=S.subarray($);p=jr(j),g=jr(D),f=oe(j,p,1),y=oe(D,g,1)}else G(1);else{var b=Xr(c)+4,A=r[b-4]|r[b-3]<<8,_=b+A;if(_>
s){l&&G(0);break}i&&u(d+A),t.set(r.subarray(b,_),d),e.b=d+=A,e.p=c=_*8,e.f=h;continue}if(c>v){l&&G(0);break}}i&&u(d+131072);for(var Xe=(1<<p)-1,X=(1<<g)-1,he=c;;he=
c){var U=f[Hr(r,c)&Xe],q=U>>4;if(c+=U&15,c>v){l&&G(0);break}if(U||G(2),q<256)t[d++]=q;else if(q==256){he=c,f=null;break}else{var K=q-254;if(q>264){var N=q-257,R=Nt[N];
K=re(r,c,(1<<R)-1)+gs[N],c+=R}var se=y[Hr(r,c)&X],Pe=se>>4;se||G(3),c+=se&15;var D=ci[Pe];if(Pe>3){var R=It[Pe];D+=Hr(r,c)&(1<<R)-1,c+=R}if(c>v){l&&G(0);break}i&&
u(d+131072);var Le=d+K;if(d<D){var Tt=o-D,Ct=Math.min(D,Le);for(Tt+d<0&&G(3);d<Ct;++d)t[d]=n[Tt+d]}for(;d<Le;++d)t[d]=t[d-D]}}e.l=f,e.p=he,e.b=d,e.f=h,f&&(h=1,e.
m=p,e.d=y,e.n=g)}while(!h);return d!=t.length&&a?Qr(t,0,d):t.subarray(0,d)},pe=function(r,e,t){t<<=e&7;var n=e/8|0;r[n]|=t,r[n+1]|=t>>8},at=function(r,e,t){t<<=
e&7;var n=e/8|0;r[n]|=t,r[n+1]|=t>>8,r[n+2]|=t>>16},Gr=function(r,e){for(var t=[],n=0;n<r.length;++n)r[n]&&t.push({s:n,f:r[n]});var s=t.length,o=t.slice();if(!s)
return{t:ws,l:0};if(s==1){var a=new P(t[0].s+1);return a[t[0].s]=1,{t:a,l:1}}t.sort(function(_,$){return _.f-$.f}),t.push({s:-1,f:25001});var i=t[0],l=t[1],u=0,
h=1,c=2;for(t[0]={s:-1,f:i.f+l.f,l:i,r:l};h!=s-1;)i=t[t[u].f<t[c].f?u++:c++],l=t[u!=h&&t[u].f<t[c].f?u++:c++],t[h++]={s:-1,f:i.f+l.f,l:i,r:l};for(var d=o[0].s,n=1;n<
s;++n)o[n].s>d&&(d=o[n].s);var f=new Z(d+1),y=Kr(t[h-1],f,0);if(y>e){var n=0,p=0,g=y-e,v=1<<g;for(o.sort(function($,L){return f[L.s]-f[$.s]||$.f-L.f});n<s;++n){
var x=o[n].s;if(f[x]>e)p+=v-(1<<y-f[x]),f[x]=e;else break}for(p>>=g;p>0;){var b=o[n].s;f[b]<e?p-=1<<e-f[b]++-1:++n}for(;n>=0&&p;--n){var A=o[n].s;f[A]==e&&(--f[A],
++p)}y=e}return{t:new P(f),l:y}},Kr=function(r,e,t){return r.s==-1?Math.max(Kr(r.l,e,t+1),Kr(r.r,e,t+1)):e[r.s]=t},hs=function(r){for(var e=r.length;e&&!r[--e];)
;for(var t=new Z(++e),n=0,s=r[0],o=1,a=function(l){t[n++]=l},i=1;i<=e;++i)if(r[i]==s&&i!=e)++o;else{if(!s&&o>2){for(;o>138;o-=138)a(32754);o>2&&(a(o>10?o-11<<5|
28690:o-3<<5|12305),o=0)}else if(o>3){for(a(s),--o;o>6;o-=6)a(8304);o>2&&(a(o-3<<5|8208),o=0)}for(;o--;)a(s);o=1,s=r[i]}return{c:t.subarray(0,n),n:e}},it=function(r,e){
for(var t=0,n=0;n<e.length;++n)t+=r[n]*e[n];return t},bs=function(r,e,t){var n=t.length,s=Xr(e+2);r[s]=n&255,r[s+1]=n>>8,r[s+2]=r[s]^255,r[s+3]=r[s+1]^255;for(var o=0;o<
n;++o)r[s+o+4]=t[o];return(s+4+n)*8},ds=function(r,e,t,n,s,o,a,i,l,u,h){pe(e,h++,t),++s[256];for(var c=Gr(s,15),d=c.t,f=c.l,y=Gr(o,15),p=y.t,g=y.l,v=hs(d),x=v.c,
b=v.n,A=hs(p),_=A.c,$=A.n,L=new Z(19),M=0;M<x.length;++M)++L[x[M]&31];for(var M=0;M<_.length;++M)++L[_[M]&31];for(var S=Gr(L,7),F=S.t,N=S.l,W=19;W>4&&!F[Vr[W-1]];--W)
;var ye=u+5<<3,Y=it(s,be)+it(o,lt)+a,B=it(s,d)+it(o,p)+a+14+3*W+it(L,F)+2*L[16]+3*L[17]+7*L[18];if(l>=0&&ye<=Y&&ye<=B)return bs(e,h,r.subarray(l,l+u));var U,O,j,
D;if(pe(e,h,1+(B<Y)),h+=2,B<Y){U=oe(d,f,0),O=d,j=oe(p,g,0),D=p;var Xe=oe(F,N,0);pe(e,h,b-257),pe(e,h+5,$-1),pe(e,h+10,W-4),h+=14;for(var M=0;M<W;++M)pe(e,h+3*M,
F[Vr[M]]);h+=3*W;for(var X=[x,_],he=0;he<2;++he)for(var q=X[he],M=0;M<q.length;++M){var K=q[M]&31;pe(e,h,Xe[K]),h+=F[K],K>15&&(pe(e,h,q[M]>>5&127),h+=q[M]>>12)}}else
U=hi,O=be,j=mi,D=lt;for(var M=0;M<i;++M){var R=n[M];if(R>255){var K=R>>18&31;at(e,h,U[K+257]),h+=O[K+257],K>7&&(pe(e,h,R>>23&31),h+=Nt[K]);var se=R&31;at(e,h,j[se]),
h+=D[se],se>3&&(at(e,h,R>>5&8191),h+=It[se])}else at(e,h,U[R]),h+=O[R]}return at(e,h,U[256]),h+O[256]},gi=new Jr([65540,131080,131088,131104,262176,1048704,1048832,
2114560,2117632]),ws=new P(0),vi=function(r,e,t,n,s,o){var a=o.z||r.length,i=new P(n+a+5*(1+Math.ceil(a/7e3))+s),l=i.subarray(n,i.length-s),u=o.l,h=(o.r||0)&7;if(e){
h&&(l[0]=o.r>>3);for(var c=gi[e-1],d=c>>13,f=c&8191,y=(1<<t)-1,p=o.p||new Z(32768),g=o.h||new Z(y+1),v=Math.ceil(t/3),x=2*v,b=function(_r){return(r[_r]^r[_r+1]<<
v^r[_r+2]<<x)&y},A=new Jr(25e3),_=new Z(288),$=new Z(32),L=0,M=0,S=o.i||0,F=0,N=o.w||0,W=0;S+2<a;++S){var ye=b(S),Y=S&32767,B=g[ye];if(p[Y]=B,g[ye]=Y,N<=S){var U=a-
S;if((L>7e3||F>24576)&&(U>423||!u)){h=ds(r,l,0,A,_,$,M,F,W,S-W,h),F=L=M=0,W=S;for(var O=0;O<286;++O)_[O]=0;for(var O=0;O<30;++O)$[O]=0}var j=2,D=0,Xe=f,X=Y-B&32767;
if(U>2&&ye==b(S-X))for(var he=Math.min(d,U)-1,q=Math.min(32767,S),K=Math.min(258,U);X<=q&&--Xe&&Y!=B;){if(r[S+j]==r[S+j-X]){for(var R=0;R<K&&r[S+R]==r[S+R-X];++R)
;if(R>j){if(j=R,D=X,R>he)break;for(var se=Math.min(X,R-2),Pe=0,O=0;O<se;++O){var Le=S-X+O&32767,Tt=p[Le],Ct=Le-Tt&32767;Ct>Pe&&(Pe=Ct,B=Le)}}}Y=B,B=p[Y],X+=Y-B&
32767}if(D){A[F++]=268435456|Yr[j]<<18|cs[D];var Qe=Yr[j]&31,et=cs[D]&31;M+=Nt[Qe]+It[et],++_[257+Qe],++$[et],N=S+j,++L}else A[F++]=r[S],++_[r[S]]}}for(S=Math.max(
S,N);S<a;++S)A[F++]=r[S],++_[r[S]];h=ds(r,l,u,A,_,$,M,F,W,S-W,h),u||(o.r=h&7|l[h/8|0]<<3,h-=7,o.h=g,o.p=p,o.i=S,o.w=N)}else{for(var S=o.w||0;S<a+u;S+=65535){var $e=S+
65535;$e>=a&&(l[h/8|0]=u,$e=a),h=bs(l,h+1,r.subarray(S,$e))}o.i=a}return Qr(i,0,n+Xr(h)+s)},bi=(function(){for(var r=new Int32Array(256),e=0;e<256;++e){for(var t=e,
n=9;--n;)t=(t&1&&-306674912)^t>>>1;r[e]=t}return r})(),wi=function(){var r=-1;return{p:function(e){for(var t=r,n=0;n<e.length;++n)t=bi[t&255^e[n]]^t>>>8;r=t},d:function(){
return~r}}};var xi=function(r,e,t,n,s){if(!s&&(s={l:1},e.dictionary)){var o=e.dictionary.subarray(-32768),a=new P(o.length+r.length);a.set(o),a.set(r,o.length),r=a,s.w=o.length}
return vi(r,e.level==null?6:e.level,e.mem==null?s.l?Math.ceil(Math.max(8,Math.min(13,Math.log(r.length)))*1.5):20:12+e.mem,t,n,s)},xs=function(r,e){var t={};for(var n in r)
t[n]=r[n];for(var n in e)t[n]=e[n];return t};var z=function(r,e,t){for(;t;++e)r[e]=t,t>>>=8};var Si=function(r,e){return((r[0]&15)!=8||r[0]>>4>7||(r[0]<<8|r[1])%31)&&G(6,"invalid zlib data"),(r[1]>>5&1)==+!e&&G(6,"invalid zlib data: "+(r[1]&32?"need":"u\
nexpected")+" dictionary"),(r[1]>>3&4)+2};function Ai(r,e){return xi(r,e||{},0,0)}function Ss(r,e){return yi(r.subarray(Si(r,e&&e.dictionary),-4),{i:2},e&&e.out,e&&e.dictionary)}var As=function(r,e,t,n){for(var s in r){var o=r[s],a=e+s,i=n;Array.isArray(o)&&(i=xs(n,o[1]),o=o[0]),o instanceof P?t[a]=[o,i]:(t[a+="/"]=[new P(0),i],As(o,a,t,
n))}},ms=typeof TextEncoder<"u"&&new TextEncoder,Mi=typeof TextDecoder<"u"&&new TextDecoder,Ei=0;try{Mi.decode(ws,{stream:!0}),Ei=1}catch{}function ne(r,e){if(e){for(var t=new P(r.length),n=0;n<r.length;++n)t[n]=r.charCodeAt(n);return t}if(ms)return ms.encode(r);for(var s=r.length,o=new P(r.length+
(r.length>>1)),a=0,i=function(h){o[a++]=h},n=0;n<s;++n){if(a+5>o.length){var l=new P(a+8+(s-n<<1));l.set(o),o=l}var u=r.charCodeAt(n);u<128||e?i(u):u<2048?(i(192|
u>>6),i(128|u&63)):u>55295&&u<57344?(u=65536+(u&1047552)|r.charCodeAt(++n)&1023,i(240|u>>18),i(128|u>>12&63),i(128|u>>6&63),i(128|u&63)):(i(224|u>>12),i(128|u>>
6&63),i(128|u&63))}return Qr(o,0,a)}var Zr=function(r){var e=0;if(r)for(var t in r){var n=r[t].length;n>65535&&G(9),e+=n+4}return e},ps=function(r,e,t,n,s,o,a,i){var l=n.length,u=t.extra,h=i&&i.length,
c=Zr(u);z(r,e,a!=null?33639248:67324752),e+=4,a!=null&&(r[e++]=20,r[e++]=t.os),r[e]=20,e+=2,r[e++]=t.flag<<1|(o<0&&8),r[e++]=s&&8,r[e++]=t.compression&255,r[e++]=
t.compression>>8;var d=new Date(t.mtime==null?Date.now():t.mtime),f=d.getFullYear()-1980;if((f<0||f>119)&&G(10),z(r,e,f<<25|d.getMonth()+1<<21|d.getDate()<<16|d.
getHours()<<11|d.getMinutes()<<5|d.getSeconds()>>1),e+=4,o!=-1&&(z(r,e,t.crc),z(r,e+4,o<0?-o-2:o),z(r,e+8,t.size)),z(r,e+12,l),z(r,e+14,c),e+=16,a!=null&&(z(r,e,
h),z(r,e+6,t.attrs),z(r,e+10,a),e+=14),r.set(n,e),e+=l,c)for(var y in u){var p=u[y],g=p.length;z(r,e,+y),z(r,e+2,g),r.set(p,e+4),e+=4+g}return h&&(r.set(i,e),e+=
h),e},Ti=function(r,e,t,n,s){z(r,e,101010256),z(r,e+8,t),z(r,e+10,t),z(r,e+12,n),z(r,e+16,s)};function Ft(r,e){e||(e={});var t={},n=[];As(r,"",t,e);var s=0,o=0;for(var a in t){var i=t[a],l=i[0],u=i[1],h=u.level==0?0:8,c=ne(a),d=c.length,f=u.comment,y=f&&
ne(f),p=y&&y.length,g=Zr(u.extra);d>65535&&G(11);var v=h?Ai(l,u):l,x=v.length,b=wi();b.p(l),n.push(xs(u,{size:l.length,crc:b.d(),c:v,f:c,m:y,u:d!=a.length||y&&f.
length!=p,o:s,compression:h})),s+=30+d+g+x,o+=76+2*(d+g)+(p||0)+x}for(var A=new P(o+22),_=s,$=o-s,L=0;L<n.length;++L){var c=n[L];ps(A,c.o,c,c.f,c.u,c.c.length);
var M=30+c.f.length+Zr(c.extra);A.set(c.c,c.o+M),ps(A,s,c,c.f,c.u,c.c.length,c.o,c.m),s+=16+M+(c.m?c.m.length:0)}return Ti(A,s,n.length,$,_),A}var Be=["pursuer","evader"];function je(r,e,t){let[n,s]=[e-r.payoff.first[0],t-r.payoff.first[1]],o=r.payoff.capture_rate[n]?.[s];return o===void 0?null:{rate:o,rates:r.payoff.capture_rates[n][s],
lengths:r.payoff.lengths[n][s]}}function Ut(r,e,t){let{script:n,network:s,kept:o,genomes:a}=r.teams[e];if(n!==null||s===null)return"";if(!o.includes(t))return`T\
he page holds no genome of ${e}s ${t}: it would be too large. Choose a generation of ${o.join(", ")}.`;let i=o.length*s.genome_size;return Es(a,s.genome_size).length===
i?"":`The page is damaged: it does not hold the ${i} numbers of the ${e}s' genomes. Write it again from its run.`}function J(r,e,t){let{script:n,network:s,kept:o,
genomes:a}=r.teams[e];if(n!==null||s===null)return n??"random";let i=o.indexOf(t);if(i<0)throw new RangeError(`${e}: expected a generation whose genome the page\
 holds, got ${t}`);let l=s.genome_size,u=Es(a,l).subarray(i*l,(i+1)*l),{hidden:h,activation:c,sampled:d,memory:f}=s;return{hidden:h,activation:c,sampled:d,memory:f,
genome:u}}var en=4,tn=new Map,Ms=(r,e)=>{tn.set(r,e)};function Es(r,e){let t=tn.get(r);if(t)return t;let n=new Float32Array;try{let s=ki(rn(r),e);s.every(Number.
isFinite)&&(n=s)}catch(s){if(!(s instanceof DOMException||s instanceof RangeError||Ci(s)))throw s}return tn.set(r,n),n}var Ci=r=>r instanceof Error&&"code"in r;
function ki(r,e){let t=Ss(r),n=t.length/en,s=new Uint8Array(t.length);for(let a=0;a<s.length;a++)s[a]=t[a%en*n+Math.floor(a/en)];let o=new Uint32Array(s.buffer);
for(let a=e;a<o.length;a++)o[a]^=o[a-e];return new Float32Array(s.buffer)}function rn(r){let e=atob(we(r)),t=new Uint8Array(e.length);for(let n=0;n<t.length;n++)
t[n]=e.charCodeAt(n);return t}function we(r){return document.getElementById(r)?.textContent??""}var Ts=()=>JSON.parse(we("data")),ut={"specialist-specialist":"Specialists: both teams meet only the newest opponent","generalist-specialist":"Pursuers meet all\
 earlier evaders, evaders only the newest pursuers","generalist-generalist":"Generalists: both teams meet all earlier opponents","hall-of-fame":"Halls of fame: \
both teams learn at once, and meet earlier champions"};function Ee({schedule:r}){if(r.kind==="hall-of-fame")return r.kind;let e={latest:"specialist","round-robi\
n":"generalist",uniform:"uniform"};return`${e[r.pursuers_meet.rule]}-${e[r.evaders_meet.rule]}`}var Dt=r=>ut[Ee(r)]??Ee(r);var zt=10,Wt=999999,nn=[3,5,7,9],Bt=5,sn=[8,16,32,64],on=[30,60,90,120],_i=.5;function Oi(r){let e=Object.values(r.races.es).find(s=>Ee(s)==="generalist-general\
ist"),{world:t,seed:n}=e;return{schedule:Ee(e),beside:null,learner:"es",seed:n,pursuers:t.n_pursuers,evaders:t.n_evaders,view:t.fov,way:!1,population:0,steps:t.
max_steps,walls:[]}}function jt(r,e,t=e.schedule){let n=r.races[e.learner][t],{rows:s,cols:o}=n.world,a=new Set(e.walls),i=Array.from({length:s},(u,h)=>Array.from(
{length:o},(c,d)=>a.has(h*o+d)?"#":".").join("")),l={...n.world,n_pursuers:e.pursuers,n_evaders:e.evaders,fov:e.view,max_steps:e.steps,obstacles:a.size?i:n.world.
obstacles};return{...n,world:l,train_steps:e.steps,seed:e.seed,policy:{...n.policy,mask:e.way?"right-of-way":"none"},learner:{...n.learner,population:e.population||
n.learner.population}}}function an(r,e,t,n){let s=r.filter(o=>o!==e);return t?s.length<_i*n?[...s,e].sort((o,a)=>o-a):r:s}function Cs(r){let{walls:e,way:t,beside:n,
...s}=r,o={...s,...n?{beside:n}:{},...t?{way:1}:{},...e.length?{walls:e.join(".")}:{}};return Object.entries(o).map(([a,i])=>`${a}=${i}`).join("&")}function ks(r,e){
let t=Oi(r),n=new URLSearchParams(e.replace(/^#/,"")),s=(c,d)=>{let f=n.get(c)??"";return/^\d{1,6}$/.test(f)&&d(Number(f))?Number(f):t[c]},o=c=>Object.hasOwn(ut,
n.get(c)??"")?n.get(c):null,{rows:a,cols:i}=r.races.es[t.schedule].world,l=(n.get("walls")??"").split(".").filter(c=>/^\d{1,4}$/.test(c)).map(Number),u=s("view",
c=>nn.includes(c)),h=n.get("way")==="1";return{schedule:o("schedule")??t.schedule,beside:o("beside"),learner:n.get("learner")==="ga"?"ga":t.learner,seed:s("seed",
c=>c<=Wt),pursuers:s("pursuers",c=>c>=1&&c<=zt),evaders:s("evaders",c=>c>=1&&c<=zt),view:h?Math.max(Bt,u):u,way:h,population:s("population",c=>sn.includes(c)),steps:s(
"steps",c=>on.includes(c)),walls:l.filter(c=>c<a*i).reduce((c,d)=>an(c,d,!0,a*i),[])}}function xe(r,e){let t=m("select",{},...r.map(([n,s])=>m("option",{value:n},s)));return t.addEventListener("change",()=>e(t.value)),t}function ae(r,e,t,n=""){return m(
"label",{class:`field ${n}`,title:e},m("span",{class:"field-name"},r),t,m("span",{class:"about small muted"},e))}function _s(r){let e=Object.entries(ut),t=xe(e,
p=>r({schedule:p})),n=xe([["","Nothing"],...e],p=>r({beside:p||null},!0)),s=Array.from({length:zt},(p,g)=>[g+1,String(g+1)]),o=xe(s,p=>r({pursuers:Number(p)})),
a=xe(s,p=>r({evaders:Number(p)})),i=xe(nn.map(p=>[p,`${p} x ${p}`]),p=>r({view:Number(p),...Number(p)<Bt?{way:!1}:{}})),l=m("input",{type:"checkbox"});l.addEventListener(
"change",()=>r({way:l.checked,...l.checked?{view:Math.max(Bt,Number(i.value))}:{}}));let u=xe([[0,"usual"],...sn.map(p=>[p,String(p)])],p=>r({population:Number(
p)})),h=xe(on.map(p=>[p,String(p)]),p=>r({steps:Number(p)})),c=xe([["es","evolution strategy"],["ga","genetic algorithm"]],p=>r({learner:p},!0)),d=m("input",{type:"\
number",min:0,max:Wt,step:1,inputmode:"numeric"});d.addEventListener("change",()=>r({seed:Math.min(Wt,Math.max(0,Math.round(Number(d.value))||0))},!0));let f=m(
"button",{type:"button",onclick:()=>r({seed:Math.floor(Math.random()*1e3)},!0)},"Another seed"),y=(p,...g)=>m("section",{class:"card controls","aria-label":p},m(
"fieldset",{},m("legend",{},p),...g));return{now:y("Change it while it evolves",ae("Opponents","whom the teams meet while they learn",t,"wide"),ae("Pursuers","t\
riangles",o),ae("Evaders","discs",a),ae("View","cells that an agent sees around itself",i),ae("Right of way","agents never take a move that could put them at fa\
ult",m("span",{},l)),ae("Population","candidates that are compared at a time",u),ae("Steps","of a match",h)),anew:y("Begin anew",ae("Side by side with","a secon\
d race of the same seed",n,"wide"),ae("Learner","how a team learns",c,"wide"),ae("Seed","the luck of the race",m("span",{class:"seed"},d,f),"wide")),show:p=>{[t.
value,n.value,i.value,c.value]=[p.schedule,p.beside??"",String(p.view),p.learner],[u.value,h.value,d.value,l.checked]=[String(p.population),String(p.steps),String(
p.seed),p.way],[o.value,a.value]=[String(p.pursuers),String(p.evaders)]}}}var V=(r,e=2)=>r==null?"-":r.toFixed(e);function Os(r,e,t){return e===null||t===null?V(r):`${V(r)} (${V(e)} to ${V(t)})`}function ct(r,e,t,n=!1){let s=(e-r)/Math.max(1,t),o=10**Math.floor(Math.log10(s||1)),a=[1,2,5,10].map(u=>u*o).find(u=>u>=s)??10*o;n&&(a=Math.max(1,Math.round(a)));
let i=Math.ceil(r/a-1e-9),l=Math.floor(e/a+1e-9);return Array.from({length:Math.max(0,l-i+1)},(u,h)=>(i+h)*a)}var Ht={left:46,right:12,top:10,bottom:42},Rs={x:56,y:34};function Ls(r,e,t,n){let[s,o]=[Ht.left,Ht.top],a=Math.max(s+40,r-Ht.right),i=Math.max(o+40,e-Ht.bottom),
l=(p,g,v)=>x=>g+(x-p.low)/(p.high-p.low||1)*(v-g),[u,h]=[l(t,s,a),l(n,i,o)],c=w("g"),d=w("svg",{width:r,height:e,viewBox:`0 0 ${r} ${e}`,class:"plot"}),f=w("g",
{class:"axes"});for(let p of ct(n.low,n.high,(i-o)/Rs.y,n.whole))f.append(w("line",{x1:s,x2:a,y1:h(p),y2:h(p),class:"grid"}),w("text",{x:s-8,y:h(p),"text-anchor":"\
end","dominant-baseline":"middle"},Ps(p)));for(let p of ct(t.low,t.high,(a-s)/Rs.x,t.whole))f.append(w("text",{x:u(p),y:i+16,"text-anchor":"middle"},Ps(t.mirrored?
Math.abs(p):p)));return f.append(w("line",{x1:s,x2:a,y1:i,y2:i,class:"axis"}),w("text",{x:(s+a)/2,y:e-6,"text-anchor":"middle",class:"label"},t.label),w("text",
{transform:`translate(12 ${(o+i)/2}) rotate(-90)`,"text-anchor":"middle",class:"label"},n.label)),d.append(f,c),{root:d,marks:c,left:s,right:a,top:o,bottom:i,x:u,
y:h,at:p=>{let g=p-d.getBoundingClientRect().left;return t.low+(g-s)/(a-s)*(t.high-t.low)}}}var Ps=r=>String(Number(r.toPrecision(6))).replace("-","−");function $s(r,e,t,n){
let s="",o="M";t.forEach((a,i)=>{a===null?o="M":(s+=`${o}${r.x(e[i]).toFixed(1)} ${r.y(a).toFixed(1)}`,o="L")}),r.root.insertBefore(w("path",{d:s,class:`line ${n}`}),
r.marks)}function Ns(...r){return m("p",{class:"legend small"},...r.map(([e,t])=>m("span",{class:`key ${t}`},e)))}function Is(r,e,t,n){let s=m("div",{class:"chart choose\
s",role:"img","aria-label":r}),o=null,a=()=>{o?.marks.replaceChildren(),o&&t(o)};s.addEventListener("click",l=>o&&n(o.at(l.clientX),o,l));let i=()=>{let{clientWidth:l,
clientHeight:u}=s;l<50||u<50||(o=e(l,u),s.replaceChildren(o.root),a())};return new ResizeObserver(i).observe(s),{element:s,update:a,redraw:i}}var He=[[0,0],[-1,0],[0,1],[1,0],[0,-1],[-1,1],[1,1],[1,-1],[-1,-1]];function Fs(r,e,t){let[n,s]=[e[0]-r[0],e[1]-r[1]];return!t&&Math.abs(n)>Math.abs(s)?s=0:t||
(n=0),He.findIndex(([o,a])=>o===Math.sign(n)&&a===Math.sign(s))}var Te=(r,e)=>e<r.nPursuers,k=(r,e)=>[r.positions[2*e],r.positions[2*e+1]],Ri=(r,e)=>r[0]===e[0]&&
r[1]===e[1],ln=({rows:r,cols:e},[t,n])=>t>=0&&n>=0&&t<r&&n<e,un=(r,e,t=3)=>r!==void 0&&[0,1,2].slice(0,t).some(n=>r[3*e+n]),cn=(r,e)=>un(r.fault,e),Us=(r,e)=>!cn(
r,e)&&un(r.involved,e,2);function Gt(r,e,t){let n=!Ri(k(r,t),k(e,t)),s=e.involved===void 0||un(e.involved,t);return!!(e.alive[t]&&e.actions?.[t]&&!n&&s)}function Vt(r,e,t){
let[n,s]=k(r,t),[o,a]=He[e.actions?.[t]??0];return[n+o,s+a]}function ht(r,e,t){return Array.from({length:t.everCaptured.length},(s,o)=>o).filter(s=>t.everCaptured[s]&&
!e.everCaptured[s]).map(s=>r.nPursuers+s)}var Yt=r=>r.moments.flatMap((e,t)=>t&&ht(r,r.moments[t-1],e).length?[t]:[]);function qt(r,e){return Array.from({length:e.
alive.length},(n,s)=>s).filter(n=>r.alive[n]&&!e.alive[n])}var Ds=[-.31,0,.31],zs=[{size:1,at:[[0,0]]},{size:.62,at:[[-.2,.2],[.2,-.2]]},{size:.54,at:[[-.23,.22],[.23,.22],[0,-.22]]},{size:.54,at:[[-.23,.23],[.23,.23],[
-.23,-.23],[.23,-.23]]},{size:.36,at:Ds.flatMap(r=>Ds.map(e=>[e,r]))}],Pi=.3,Li=.35,$i=.55;function dt(r,e){let t=new Map;for(let n=0;n<e.alive.length;n++){if(!e.
alive[n])continue;let[s,o]=k(e,n),a=s*r.cols+o,i=t.get(a);i?i.push(n):t.set(a,[n])}return t}function Ws(r,e){let t=Array.from(e.alive,(n,s)=>{let[o,a]=k(e,s);return{
x:a+.5,y:o+.5,size:1,alpha:0}});for(let n of dt(r,e).values()){let s=zs[Math.min(n.length,zs.length)-1];n.forEach((o,a)=>{let[i,l]=s.at[Math.min(a,s.at.length-1)],
u=t[o];u.x+=i,u.y+=l,u.size=s.size,u.alpha=1})}return t}var Bs=r=>r*r*(3-2*r),Ge=(r,e,t)=>r+(e-r)*t,js=r=>Math.min(1,Math.max(0,r));function Hs(r,e,t,n){let s={
SIMULTANEOUS:1,SWARM_TURNS:2,AGENT_TURNS:t}[r.interaction];if(s===1)return Bs(n);let o=s===t?e:+!Te(r,e),a=Math.max(1/s,Li);return Bs(js((n-o/(s-1)*(1-a))/a))}function Kt(r,e){
let t=r.moments.length-1,n=Math.min(Math.floor(e),t),s=r.moments[n],o=Ws(r,s);if(n===t||e===n)return o;let a=r.moments[n+1],i=Ws(r,a);return o.map((l,u)=>{let h=Hs(
r,u,o.length,e-n);return Ni(s,a,u,l,i[u],h)})}function hn(r,e,t){let n=r.moments.length-1,s=Math.min(Math.floor(t),n),[o,a]=[r.moments[s],r.moments[Math.min(s+1,
n)]],i=Hs(r,e,o.alive.length,t-s),[[l,u],[h,c]]=[k(o,e),k(a,e)];return[Ge(u,c,i)+.5,Ge(l,h,i)+.5]}function Ni(r,e,t,n,s,o){let a=n.alpha>s.alpha,i={x:Ge(n.x,s.x,
o),y:Ge(n.y,s.y,o),size:a?n.size:Ge(n.size,s.size,o),alpha:a?js((1-o)/(1-$i)):Ge(n.alpha,s.alpha,o)};if(Gt(r,e,t)){let[l,u]=k(r,t),[h,c]=Vt(r,e,t),d=Pi*Math.sin(
Math.PI*o);i.x+=(c-u)*d,i.y+=(h-l)*d}return i}var Gs=2*Math.PI;function Ce(r,e,t,n){r.beginPath(),r.arc(e,t,n/2,0,Gs)}function Zt(r,e,t,n){let s=n/2,o=[[0,-.97],[.97,.83],[-.97,.83]].map(([a,i])=>[e+a*s,t+i*
s]);r.beginPath(),r.moveTo((o[2][0]+o[0][0])/2,(o[2][1]+o[0][1])/2),o.forEach(([a,i],l)=>{let[u,h]=o[(l+1)%3];r.arcTo(a,i,u,h,n*.09)}),r.closePath()}function Vs(r,e,t,n){
let s=n*.32;r.beginPath(),r.moveTo(e-s,t-s),r.lineTo(e+s,t+s),r.moveTo(e+s,t-s),r.lineTo(e-s,t+s)}function Ys(r,e,t,n){r.beginPath();for(let s=0;s<16;s++){let o=n/
2*(s%2?.6:.95),a=Gs*s/16;r.lineTo(e+o*Math.sin(a),t-o*Math.cos(a))}r.closePath()}function qs(r,e,t,n,s,o){let a=Math.atan2(s-t,n-e);r.beginPath(),r.moveTo(e,t),
r.lineTo(n,s);for(let i of[-1,1])r.moveTo(n,s),r.lineTo(n-o*Math.cos(a+i*.6),s-o*Math.sin(a+i*.6))}var Ks=4,Ii=1.6,Fi=.95,Ui=5,Di=.16,zi=9,Wi=.09,Bi=.2,Zs=.75,Q=(r,e)=>r.left+e*r.cell,ee=(r,e)=>r.top+e*r.cell;function Ve(r,e,t){return Te(e,t)?r.colors.pursuer:
r.colors.evader}function Js({ctx:r,grid:e,colors:t}){let{left:n,top:s,cell:o,rows:a,cols:i}=e,[l,u]=[i*o,a*o];if(r.fillStyle=t.paper,r.fillRect(n,s,l,u),o<Ui)return;
r.fillStyle=t.line;let h=Math.max(1,Math.round(o/60));for(let c=1;c<i;c++)r.fillRect(n+c*o,s,h,u);for(let c=1;c<a;c++)r.fillRect(n,s+c*o,l,h)}function Xs({ctx:r,
grid:e,colors:t},n){let{left:s,top:o,cell:a,rows:i,cols:l}=e;r.fillStyle=t.obstacle;for(let u=0;u<i*l;u++){if(!n.obstacles[u])continue;let[h,c]=[Math.floor(u/l),
u%l];r.fillRect(s+c*a,o+h*a,a,a)}Qs({ctx:r,grid:e,colors:t})}function Qs({ctx:r,grid:{left:e,top:t,cell:n,rows:s,cols:o},colors:a}){let i=Math.min(5,Math.max(2,
Math.round(n/18)));r.strokeStyle=a.frame,r.lineWidth=i,r.strokeRect(e-i/2,t-i/2,o*n+i,s*n+i)}function eo({ctx:r,grid:e,colors:t},n){let{left:s,top:o,cell:a,rows:i,
cols:l}=e,u=a<24*n?5:1;r.font=`500 ${Math.round(Math.min(15*n,Math.max(9*n,a*.32)))}px system-ui, sans-serif`,r.fillStyle=t.muted,r.textBaseline="alphabetic",r.
textAlign="center";let h=5*n+a/40;for(let c=0;c<l;c+=u)r.fillText(String(c),s+(c+.5)*a,o-h);r.textAlign="right",r.textBaseline="middle";for(let c=0;c<i;c+=u)r.fillText(
String(c),s-h,o+(c+.5)*a)}function to({grid:r},e,t,n){let s=Math.floor(e.fov/2)+.5,[o,a]=[Math.max(0,t-s),Math.min(r.cols,t+s)],[i,l]=[Math.max(0,n-s),Math.min(
r.rows,n+s)];return[Q(r,o),ee(r,i),(a-o)*r.cell,(l-i)*r.cell]}function ro(r,e,t,n){let{ctx:s,grid:o,colors:a}=r;s.save(),s.beginPath(),s.rect(0,0,s.canvas.width,
s.canvas.height),s.rect(...to(r,e,t,n)),s.clip("evenodd"),s.clearRect(0,0,s.canvas.width,s.canvas.height),s.fillStyle=a.line,s.fillRect(o.left,o.top,o.cols*o.cell,
o.rows*o.cell),s.restore(),Qs(r)}function no({ctx:r,grid:e,colors:t},{x:n,y:s,alpha:o},a){let i=Math.max(e.cell,16*a)*1.06,[l,u]=[Q(e,n),ee(e,s)];r.globalAlpha=
Math.max(o,.6),r.beginPath(),r.roundRect(l-i/2,u-i/2,i,i,i*.2),r.strokeStyle=t.focus,r.lineWidth=Math.max(2,2.5*a),r.stroke();let h=Math.max(11*a,Math.min(18*a,
e.cell*.5));r.font=`700 ${Math.round(h)}px system-ui, sans-serif`,r.textAlign="center",r.textBaseline="middle";let c=u-i/2<h*1.2,d=u+(c?1:-1)*(i/2+h*.7);r.strokeStyle=
t.paper,r.lineJoin="round",r.lineWidth=h*.35,r.strokeText("You",l,d),r.fillStyle=t.ink,r.fillText("You",l,d),r.globalAlpha=1}function so(r,e,t,n,s){let{ctx:o,grid:a}=r,
i=to(r,e,n,s),l=Ve(r,e,t);o.globalAlpha=.11,o.fillStyle=l,o.fillRect(...i),o.globalAlpha=.8,o.strokeStyle=l,o.lineWidth=Math.max(1,a.cell/24),o.strokeRect(...i),
o.globalAlpha=1}function oo(r,e,t,n,s){let{ctx:o,grid:a}=r,i=Math.min(Math.ceil(t),e.moments.length-1),l=e.moments[i];o.lineCap="round",o.lineWidth=Math.min(zi,
Math.max(1,a.cell*Di));for(let u=Math.max(1,Math.floor(t-n)+1);u<=i;u++){let[h,c]=[e.moments[u-1],e.moments[u]],d=Math.max(0,Math.min(1,(t-u)/n));o.globalAlpha=
Zs+(Bi-Zs)*d;for(let f=0;f<c.alive.length;f++){let y=u===i&&t<i;if(!h.alive[f]||!(l.alive[f]||y))continue;let p=(Te(e,f)?-1:1)*Wi,[g,v]=k(h,f),[x,b]=k(c,f);if(g===
x&&v===b)continue;let A=y?s[f].x:b+.5,_=y?s[f].y:x+.5;o.strokeStyle=Ve(r,e,f),o.beginPath(),o.moveTo(Q(a,v+.5+p),ee(a,g+.5+p)),o.lineTo(Q(a,A+p),ee(a,_+p)),o.stroke()}}
o.globalAlpha=1}function ao(r,e,t){let n=Math.min(Math.ceil(t),e.moments.length-1);for(let s=Math.max(1,n-Ks+1);s<=n;s++){let[o,a]=[e.moments[s-1],e.moments[s]],
i=s>t?Math.max(0,1-2*(s-t)):1-(t-s)/Ks,l=ht(e,o,a);for(let u of qt(o,a))l.includes(u)||Hi(r,k(a,u),i);for(let u of l)ji(r,k(a,u),i)}r.ctx.globalAlpha=1}function ji({
ctx:r,grid:e,colors:t},[n,s],o){r.globalAlpha=o,Ys(r,Q(e,s+.5),ee(e,n+.5),Math.max(8,e.cell*Ii)),r.fillStyle=t.capture,r.fill(),r.strokeStyle=t.ink,r.lineWidth=
Math.max(1,e.cell/36),r.lineJoin="round",r.stroke()}function Hi({ctx:r,grid:e,colors:t},[n,s],o){r.globalAlpha=o,Vs(r,Q(e,s+.5),ee(e,n+.5),Math.max(7,e.cell*Fi)),
r.strokeStyle=t.collision,r.lineWidth=Math.max(2,e.cell*.17),r.lineCap="round",r.stroke()}function io({ctx:r,grid:e,colors:t},n,s){let o=Math.max(1,e.cell*.07);
r.strokeStyle=r.fillStyle=t.collision,r.lineWidth=Math.max(1,e.cell*.05),r.setLineDash([e.cell*.14,e.cell*.1]);for(let[a,i]of n){if(a<0||i<0||a>=e.rows||i>=e.cols)
continue;let l=[Q(e,i)+o,ee(e,a)+o,e.cell-2*o,e.cell-2*o];r.globalAlpha=.2*s,r.fillRect(...l),r.globalAlpha=s,r.strokeRect(...l)}r.setLineDash([]),r.globalAlpha=
1}function lo({ctx:r,grid:e,colors:t},n,s,o,a){r.globalAlpha=a,Ce(r,Q(e,n),ee(e,s),Math.max(8,e.cell*o*1.02)),r.strokeStyle=t.collision,r.lineWidth=Math.max(1.5,
e.cell*.085*Math.sqrt(o)),r.stroke(),r.globalAlpha=1}var Gi=.8,Vi=.92,Yi=15,qi=7,dn=9;function uo(r,e,t,n,s,o){n.forEach((a,i)=>{a.alpha>0&&Ki(r,e,t,i,a,s,o)}),r.ctx.globalAlpha=1;for(let a of dt(e,t).values())a.length>
dn&&Zi(r,n[a[dn-1]],a.length-dn+1)}function Ki(r,e,t,n,s,o,a){let{ctx:i,grid:l,colors:u}=r,h=Te(e,n),[c,d]=[l.left+s.x*l.cell,l.top+s.y*l.cell],f=Math.max(4,l.cell*
s.size*(h?Vi:Gi)),y=Ve(r,e,n),p=!h&&!!t.captured[n-e.nPursuers];if(i.globalAlpha=s.alpha,(h?Zt:Ce)(i,c,d,f),f>qi*a&&(i.strokeStyle=u.paper,i.lineWidth=Math.max(
2,f*.1),i.stroke()),i.fillStyle=p?u.paper:y,i.fill(),p&&(Ce(i,c,d,f*.82),i.strokeStyle=y,i.lineWidth=f*.18,i.stroke()),!o||f<Yi*a)return;let g=String(h?n:n-e.nPursuers);
i.font=`700 ${Math.round(f*(h?.4:.5)*(g.length>1?.8:1))}px system-ui, sans-serif`,i.textAlign="center",i.textBaseline="middle",i.fillStyle=p?y:u.paper,i.fillText(
g,c,d+f*(h?.17:.03))}function Zi({ctx:r,grid:e,colors:t},n,s){let[o,a]=[e.left+n.x*e.cell,e.top+n.y*e.cell];r.font=`700 ${Math.round(e.cell*.3)}px system-ui, sa\
ns-serif`,r.textAlign="center",r.textBaseline="middle",r.strokeStyle=t.paper,r.lineWidth=e.cell*.1,r.strokeText(`+${s}`,o,a),r.fillStyle=t.ink,r.fillText(`+${s}`,
o,a)}var Ji=.46,Xi=.86,Qi=.66,co=.48,el=.78,tl=.58;function ho(r,e,t,n){let[s,o]=[e.moments[t-1],e.moments[t]];if(!s)return;let{ctx:a,grid:i,colors:l}=r;a.strokeStyle=
l.collision,a.lineWidth=Math.max(1.5,i.cell*.07),a.lineCap="butt",a.globalAlpha=n;for(let u=0;u<o.alive.length;u++)Gt(s,o,u)&&rl(r,e,k(s,u),Vt(s,o,u));a.globalAlpha=
1}function rl({ctx:r,grid:e},t,n,s){let[o,a]=[s[1]-n[1],s[0]-n[0]],i=c=>Q(e,n[1]+.5+o*c),l=c=>ee(e,n[0]+.5+a*c),u=ln(t,s)?el:tl;r.setLineDash([e.cell*.09,e.cell*
.06]),r.beginPath(),r.moveTo(i(co),l(co)),r.lineTo(i(u),l(u)),r.stroke(),r.setLineDash([]);let h=.17*e.cell/Math.hypot(o,a);r.beginPath(),r.moveTo(i(u)-a*h,l(u)+
o*h),r.lineTo(i(u)+a*h,l(u)-o*h),r.stroke()}function mo(r,e,t,n,s,o){let a=He[o];if(!o||!a)return;let{ctx:i,grid:l,colors:u}=r,h=ln(e,[n[0]+a[0],n[1]+a[1]])?Xi:
Qi,c=Ji*s.size,d=[Q(l,s.x+a[1]*c),ee(l,s.y+a[0]*c),Q(l,s.x+a[1]*h),ee(l,s.y+a[0]*h)],f=Math.max(1.5,l.cell*.085);i.lineCap=i.lineJoin="round";for(let[y,p]of[[u.
paper,f*2.1],[Ve(r,e,t),f]])i.strokeStyle=y,i.lineWidth=p,qs(i,...d,l.cell*.2),i.stroke()}var fo={numbers:!0,axes:!1,trail:6,viewers:[],plan:null,selected:null,cursor:null,you:null,fog:!1};function yo(r,e,t,n,s){let{ctx:o,grid:a,colors:i}=r,l=Math.min(
Math.ceil(t),e.moments.length-1),u=e.moments[l],h=t===l,c=Kt(e,t),d=h?1:Math.max(0,1-2*(l-t));o.clearRect(0,0,o.canvas.width,o.canvas.height),Js(r);for(let p of n.
viewers)c[p]?.alpha&&so(r,e,p,...hn(e,p,t));Xs(r,e),n.axes&&eo(r,s),oo(r,e,t,n.trail,c),io(r,u.contested??[],d),ao(r,e,t),ho(r,e,l,d),c.forEach(({x:p,y:g,size:v},x)=>{
let b=Us(u,x)?.4:0,A=cn(u,x)?1:b;A&&lo(r,p,g,v,A*d)});let f=h?u:e.moments[Math.max(0,l-1)];if(uo(r,e,f,c,n.numbers,s),h&&n.plan)for(let[p,g]of c.entries())g.alpha&&
mo(r,e,p,k(u,p),g,n.plan[p]??0);n.you!==null&&(n.fog&&ro(r,e,...hn(e,n.you,t)),no(r,c[n.you],s)),o.lineWidth=Math.max(2,2.5*s),o.strokeStyle=i.focus;let y=n.selected===
null?void 0:c[n.selected];y?.alpha&&po(r,y.x,y.y,y.size*.96),n.cursor&&(o.setLineDash([a.cell*.12,a.cell*.08]),po(r,n.cursor[1]+.5,n.cursor[0]+.5,.8),o.setLineDash(
[]))}function po({ctx:r,grid:e},t,n,s){let o=s*e.cell;r.beginPath(),r.roundRect(e.left+t*e.cell-o/2,e.top+n*e.cell-o/2,o,o,o*.1),r.stroke()}var go=(r,e)=>(e+.24)/(r+.24);function vo(r,e,t,n,s,o){let a=t?28*o:0,i=(u,h)=>(u-a)/(h+2*.12),l=Math.max(1,Math.floor(Math.min(i(n,e),i(s,r))));return{rows:r,cols:e,
cell:l,left:Math.round((n-e*l+a)/2),top:Math.round((s-r*l+a)/2)}}function bo(r,e,t){let n=Math.floor((t-r.top)/r.cell),s=Math.floor((e-r.left)/r.cell);return n>=
0&&n<r.rows&&s>=0&&s<r.cols?[n,s]:null}var nl={paper:"--board-paper",line:"--board-line",frame:"--board-frame",ink:"--board-ink",muted:"--board-muted",obstacle:"--board-obstacle",pursuer:"--pursuer",
evader:"--evader",capture:"--capture",collision:"--collision",focus:"--focus"};function Jt(r){let e=getComputedStyle(r),t=Object.entries(nl).map(([n,s])=>[n,e.getPropertyValue(
s).trim()]);return Object.fromEntries(t)}var fe=()=>matchMedia("(prefers-reduced-motion: reduce)").matches,Se=class{canvas;#e=null;#r=0;#t;#n={rows:1,cols:1,left:0,top:0,cell:1};#s=0;#o;#u;constructor(e,t={}){
this.canvas=e,e.classList.add("board"),e.setAttribute("role","img"),this.#t={...fo,...t},this.#o=new ResizeObserver(()=>this.#a()),this.#o.observe(e),this.#u=new MutationObserver(
()=>this.redraw()),this.#u.observe(document.documentElement,{attributes:!0}),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",this.redraw)}close(){
this.#o.disconnect(),this.#u.disconnect(),matchMedia("(prefers-color-scheme: dark)").removeEventListener("change",this.redraw),cancelAnimationFrame(this.#s)}get look(){
return this.#t}set look(e){this.#t={...this.#t,...e},this.#d(),this.redraw()}show(e,t){this.#e=e,this.#r=Math.min(Math.max(0,t),e.moments.length-1),this.#d(),this.
redraw()}redraw=()=>{this.#s||(this.#s=requestAnimationFrame(()=>this.drawNow()))};drawNow(){cancelAnimationFrame(this.#s),this.#s=0;let e=this.canvas.getContext(
"2d");if(!e||!this.#e)return;let{rows:t,cols:n}=this.#e,s=devicePixelRatio||1;this.#n=vo(t,n,this.#t.axes,this.canvas.width,this.canvas.height,s);let o={ctx:e,grid:this.#n,
colors:Jt(this.canvas)};yo(o,this.#e,this.#r,this.#t,s)}cellAt(e,t){let n=this.canvas.getBoundingClientRect(),s=this.canvas.width/n.width;return bo(this.#n,(e-n.
left)*s,(t-n.top)*s)}agentAt(e,t){let n=this.cellAt(e,t);if(!n||!this.#e)return null;let s=this.#e.moments[Math.round(this.#r)],o=dt(this.#e,s).get(n[0]*this.#e.
cols+n[1])??[],a=Kt(this.#e,Math.round(this.#r)),i=l=>{let[u,h]=this.pointOf(a[l].x,a[l].y);return Math.hypot(u-e,h-t)};return o.length?o.reduce((l,u)=>i(u)<i(l)?
u:l):null}pointOf(e,t){let n=this.canvas.getBoundingClientRect(),s=n.width/this.canvas.width,{left:o,top:a,cell:i}=this.#n;return[n.left+(o+e*i)*s,n.top+(a+t*i)*
s]}#d(){if(!this.#e)return;let{rows:e,cols:t}=this.#e;this.canvas.style.setProperty("--board-aspect",String(go(e,t)))}#a(){let e=devicePixelRatio||1,{width:t,height:n}=this.
canvas.getBoundingClientRect();this.canvas.width=Math.max(1,Math.round(t*e)),this.canvas.height=Math.max(1,Math.round(n*e)),this.drawNow()}};function mn(r,e,t){return{rows:r.rows,cols:r.cols,nPursuers:r.n_pursuers,fov:r.fov,interaction:r.rules.interaction,obstacles:e,moments:t}}function pn(r,e){return{
positions:r.read("last_positions"),alive:r.read("alive"),captured:r.read("captured"),everCaptured:r.read("ever_captured"),actions:e,involved:r.read("involved"),
fault:r.read("fault"),contested:r.conflicts().map(t=>t.cell)}}function Xt(r){let e=Array.from({length:r.length+1},(t,n)=>sl(r,n));return mn(r.config,r.map,e)}function sl(r,e){
let t=r.n_agents,n=r.config.n_evaders,s=(a,i,l)=>a.subarray(i*l,(i+1)*l),o={positions:s(r.last_positions,e,2*t),alive:s(r.alive,e,t),captured:s(r.captured,e,n),
everCaptured:s(r.ever_captured,e,n)};return e===0?o:{...o,actions:s(r.actions,e-1,t),involved:s(r.involved,e-1,3*t),fault:s(r.fault,e-1,3*t),get contested(){return r.
conflicts(e).map(a=>a.cell)}}}var mt=[.5,1,2,4,8,16,32,64],Qt=0,er=12,ol=2,Ae=class extends EventTarget{#e;#r;#t;#n=0;#s=0;#o=!1;#u=null;#d=0;#a=[];#m=[];glide=.28;constructor(e,t={}){super(),
this.#e=e,this.#r=t.speed??4,this.#t=t.still??!1}get step(){return this.#n}get time(){return this.#t?this.#n:this.#s}get arrived(){return this.#s===this.#n}get playing(){
return this.#o}get length(){return this.#e}set length(e){this.#e=e,this.#n>e&&this.jump(e),this.#i("state")}get marks(){return this.#a}set marks(e){this.#a=e,this.#i(
"state")}get ticks(){return this.#m}set ticks(e){this.#m=e,this.#i("state")}get pace(){return this.#r||Math.max(ol,this.#e/er)}get speed(){return this.#r}set speed(e){
this.#r=e,this.#i("state")}changeSpeed(e){let t=mt.findIndex(n=>n>=this.pace);this.speed=mt[Math.min(mt.length-1,Math.max(0,t+e))]}play(){this.#o||!this.#e||(this.#n===
this.#e&&this.jump(0),this.#o=!0,this.#i("state"),this.#l())}pause(){this.#o&&(this.#o=!1,this.#i("state"))}toggle(){this.#o?this.pause():this.play()}move(e){this.
pause();let t=Math.min(this.#e,Math.max(0,this.#n+e));Math.abs(t-this.#s)>1?this.jump(t):this.#h(t),this.#l()}jump(e){this.#s=Math.min(this.#e,Math.max(0,Math.round(
e))),this.#h(this.#s),this.#i("frame")}#h(e){e!==this.#n&&(this.#n=e,this.#i("step"),this.#t&&this.#i("frame"))}#l(){this.#u===null&&(this.#d=performance.now(),
this.#u=requestAnimationFrame(()=>this.#f()))}#f(){this.#u=null;let e=performance.now();this.#p(Math.min(.25,(e-this.#d)/1e3)),this.#d=e,(!this.#t||this.arrived)&&
this.#i("frame"),(this.#o||this.#s!==this.#n)&&(this.#u=requestAnimationFrame(()=>this.#f()))}#p(e){let t=e;for(;t>0;){if(this.#s===this.#n){if(!this.#o)return;
if(this.#n===this.#e)return this.pause();this.#h(this.#n+1)}let n=this.#o?this.pace:1/this.glide,s=this.#n-this.#s,o=Math.min(Math.abs(s),t*n);t-=o/n,this.#s=o===
Math.abs(s)?this.#n:this.#s+Math.sign(s)*o}this.#o&&this.#s===this.#e&&this.pause()}#i(e){this.dispatchEvent(new Event(e))}};function tr(r,e){if(e.ctrlKey||e.metaKey||
e.altKey)return!1;let t=e.shiftKey?10:1,s={" ":()=>r.toggle(),ArrowRight:()=>r.move(t),ArrowLeft:()=>r.move(-t),Home:()=>r.move(-r.length),End:()=>r.move(r.length),
"+":()=>r.changeSpeed(1),"-":()=>r.changeSpeed(-1)}[e.key];return s?.(),s!==void 0}var al={first:"M6 5v14M19 5 9 12l10 7z",back:"M17 5 7 12l10 7z",play:"M7 4.5 19 12 7 19.5z",pause:"M8 5v14M16 5v14",forward:"M7 5l10 7-10 7z",last:"M18 5v14M5 5\
l10 7-10 7z"};function wo(r){return w("svg",{viewBox:"0 0 24 24","aria-hidden":"true",class:"icon"},w("path",{d:al[r]}))}function pt(r,e,t,n){return m("button",
{type:"button",class:"player-button","aria-label":e,title:`${e} (${t})`,onclick:n},wo(r))}function rr(r){let e=pt("play","Play","Space",()=>r.toggle()),t=il(r),
n=m("div",{class:"captures","aria-hidden":"true",title:"Captures"}),s=m("div",{class:"losses","aria-hidden":"true"}),o=ll(r),a=m("output",{class:"player-count"}),
i=m("div",{class:"player",role:"group","aria-label":"Player"},pt("first","First step","Home",()=>r.move(-r.length)),pt("back","Step back","←",()=>r.move(-1)),
e,pt("forward","Step forward","→",()=>r.move(1)),pt("last","Last step","End",()=>r.move(r.length)),m("div",{class:"scrub"},n,s,t),a,o),l=(c,d={})=>{let f=m("i",
d);return f.style.left=`${100*c/Math.max(1,r.length)}%`,f},u=()=>{n.replaceChildren(...r.marks.map(c=>l(c))),s.replaceChildren(...r.ticks.map(({step:c,kind:d,size:f,
text:y})=>{let p=l(c,{class:d,title:`Step ${c}: ${y}`});return p.style.height=`${100*f}%`,p}))},h=()=>{e.replaceChildren(wo(r.playing?"pause":"play")),e.ariaLabel=
r.playing?"Pause":"Play",e.title=`${e.ariaLabel} (Space)`,t.max=String(r.length),t.value=String(r.step),t.ariaValueText=`step ${r.step} of ${r.length}`,a.textContent=
`${r.step} / ${r.length}`,a.style.minWidth=`${2*String(r.length).length+3}ch`,o.value=String(r.speed)};return r.addEventListener("step",h),r.addEventListener("s\
tate",h),r.addEventListener("state",u),i.addEventListener("keydown",c=>{!(c.target instanceof HTMLSelectElement||c.key===" "&&c.target!==t)&&tr(r,c)&&c.preventDefault()}),
h(),i}function il(r){let e=m("input",{type:"range",class:"player-scrub",min:0,step:1,"aria-label":"Step"});return e.addEventListener("input",()=>{r.pause(),r.jump(
Number(e.value))}),e}function ll(r){let e=`Steps a second, or the whole in ${er} s (+ and -)`,t=m("select",{class:"player-speed","aria-label":"Speed",title:e},m(
"option",{value:Qt},`in ${er} s`),...mt.map(n=>m("option",{value:n},`${n} / s`)));return t.addEventListener("change",()=>{r.speed=Number(t.value)}),t}var ul=40,nr=class{element;#e;#r=m("div",{class:"episodes",role:"group","aria-label":"Episodes of this cell"});#t=m("p",{class:"check small numbers","aria-live":"\
polite"});constructor(e){this.#e=e,this.element=m("div",{class:"strip-of-episodes"},this.#r,this.#t)}show(e,t){let{pursuer:n,evader:s,episode:o,seed:a}=this.#e.
selected,i=je(e,n,s);this.#r.replaceChildren(...(i?.rates??[]).slice(0,ul).map((d,f)=>this.#n(d,f)));let l=a===null?i?.rates[o]:void 0,u=t.statistics.capture_rate,
h=l!==void 0&&Math.abs(u-l)<1e-6&&t.length===i?.lengths[o],c=i?"Not an episode of the evaluation":"The evaluation played no episodes of this pair.";this.#t.dataset.
equal=String(h),this.#t.textContent=h?"As in the evaluation":l===void 0?c:`Episode ${o+1} differs from the evaluation.`,this.#t.title=`Played here: capture rate\
 ${V(u,3)} in ${t.length} steps.${i?` The cell says ${V(i.rate,3)}.`:""}`}#n(e,t){let{selected:n}=this.#e,s=m("span",{class:"bar"});return s.style.height=`${Math.
round(100*e)}%`,m("button",{type:"button",class:"episode",title:`Episode ${t+1}: capture rate ${V(e)}`,"aria-label":`Episode ${t+1}, capture rate ${V(e)}`,"aria\
-pressed":String(t===n.episode&&n.seed===null),onclick:()=>this.#e.select({episode:t,seed:null})},s,m("span",{class:"count"},t+1))}};var ie=["stay","north","east","south","west","northeast","southeast","southwest","northwest"];var xo=0,So=1,cl=2,hl=176;function Mo(r,e,t,n){let s=devicePixelRatio||1,o=Jt(r);r.width=r.height=hl*s;let a=r.getContext("2d");if(!a)return;let{fov:i}=e,l=r.width/
i;a.fillStyle=o.paper,a.fillRect(0,0,r.width,r.height);for(let h=0;t&&h<i*i;h++){let[c,d]=[(h%i+.5)*l,(Math.floor(h/i)+.5)*l],f=p=>!!t[p*i*i+h];f(cl)&&(a.fillStyle=
o.obstacle,a.fillRect(c-l/2,d-l/2,l,l));let y=f(xo)&&f(So)?l*.18:0;f(xo)&&Ao(a,Ce,c+y,d+y,l*.74,o.evader),f(So)&&Ao(a,Zt,c-y,d-y,l*.86,o.pursuer)}a.strokeStyle=
n<e.n_pursuers?o.pursuer:o.evader,a.lineWidth=2*s;let u=Math.floor(i/2)*l;a.strokeRect(u,u,l,l)}function Ao(r,e,t,n,s,o){e(r,t,n,s),r.fillStyle=o,r.fill()}var Eo="What it remembers: a number for each unit, from -1 to 1",sr=class{element;#e;#r=m("canvas",{class:"seen",role:"img"});#t=m("h3");#n=m("p",{class:"small \
muted"});#s=m("div",{class:"answers"});#o=m("div",{title:Eo});#u=null;#d=null;#a=null;#m=null;#h=null;#l=null;#f=0;constructor(e){this.#e=e,this.element=m("div",
{class:"inspector","data-open":"false"},m("p",{class:"hint small muted"},"Click an agent, or press A: what it sees, and what its network answers."),m("div",{class:"\
inspected"},this.#r,m("div",{class:"answer"},this.#t,this.#n,this.#o),this.#s))}get agent(){return this.#l}show(e,t,n,s){this.#u?.free(),this.#u=e.world(t.world),
this.#a!==t&&(this.#d=null,this.#l!==null&&this.choose(null)),[this.#a,this.#m,this.#h]=[t,n,s]}set solution(e){this.#d=e,this.at(this.#f)}choose(e){this.#l=e,this.
element.dataset.open=String(e!==null),this.#e(e),this.at(this.#f)}next(e){let t=this.#m;if(!t)return;let n=this.#l??(e>0?-1:0);for(let s=0;s<t.n_agents;s++)if(n=
(n+e+t.n_agents)%t.n_agents,t.alive[this.#f*t.n_agents+n])return this.choose(n)}at(e){this.#f=e;let[t,n,s,o,a]=[this.#m,this.#u,this.#a,this.#h,this.#l];if(!t||
!n||!s||!o||a===null)return;let i=a<t.config.n_pursuers?"pursuer":"evader";this.#o.replaceChildren(),this.#t.replaceChildren(m("span",{class:i},H(a,t.config.n_pursuers)));
let l={pursuers:J(s,"pursuer",o.pursuer),evaders:J(s,"evader",o.evader)};t.seek(n,e,l);let u=t.actions.subarray(e*t.n_agents,(e+1)*t.n_agents);for(;u.length&&!n.
over&&(a<n.actors[0]||a>=n.actors[1]);)n.playTurn(u);let h=!!(t.alive[e*t.n_agents+a]&&n.read("alive")[a]);Mo(this.#r,t.config,h?n.view(a):null,a),this.#r.ariaLabel=
`Field of view of ${H(a,t.config.n_pursuers)}: evaders, pursuers and obstacles around it`;let c=u[a]??null;if(!h)return this.#p([],"It is gone.");let d=l[`${i}s`],
f=typeof d=="string"?null:n.answer(d,a),y=f?.probabilities??null;f?.memory.length&&this.#o.replaceChildren(m("p",{class:"small muted"},"It remembers:"),pl(f.memory));
let p=this.#d?.game(n)??null,g=typeof d=="string"?`The script "${d}" plays for it${c===null?"":`; it goes ${ie[c]}`}.`:d.sampled?"Its action is drawn from these\
 probabilities.":"It takes the most probable action.",v=[["network",y],["perfect",p?.marginal(a)??null]],x=We(t.config),b=A=>m("p",{class:"small muted"},A);this.#p(
[...p?[b(`Value ${p.value.toFixed(2)} under perfect play.`)]:[],...dl(v,c),...x?[b(`Perfect play is not known: ${x}.`)]:[]],c===null?"The episode is over.":g)}#p(e,t){
this.#s.replaceChildren(...e),this.#n.textContent=t}};function dl(r,e){let t=r.filter(([,o])=>o);if(!t.length)return[];let n=m("div",{class:"action muted"},m("s\
pan"),...t.map(([o])=>m("span",{class:"head"},o))),s=Array.from(t[0][1],(o,a)=>m("div",{class:a===e?"action taken":"action"},m("span",{},ie[a]),...t.flatMap(([,
i])=>ml(i[a]))));return t.length>1||t[0][0]!==r[0][0]?[n,...s]:s}function ml(r){let e=m("span",{class:"filled"});return e.style.width=`${100*r}%`,[m("span",{class:"\
track"},e),m("span",{class:"numbers"},r.toFixed(2))]}function pl(r){let e=Array.from(r,t=>{let n=m("span",{title:t.toFixed(2)});return n.style.transform=`scaleY\
(${t})`,n});return m("div",{class:"units",role:"img","aria-label":Eo},...e)}function To(r,e,{pursuer:t,evader:n,episode:s,seed:o}){let a=e.seeds[t][n];return r.match(e.world,J(e,"pursuer",t),J(e,"evader",n),BigInt(o??a),s)}function Co(r){let e=JSON.stringify(r,(t,n)=>t==="genome"?Array.from(n):n);return m("script",{type:"application/json",id:"champions"},e.replaceAll("<","\\u003c")).
outerHTML}var ko="champion",_o=0,fn=64,yn=100;var fl=(r,e)=>Object.keys(r).every(t=>r[t]===e[t]);function Oo(r,e){return Object.keys(e).find(t=>fl(e[t],r))??null}var ft="_",yl="n",Mh=2n**64n-1n;var gn={fov:11,maxSteps:500,rewards:"paper"},gl=["rules","others","rewards","size","diagonal","fov","limit","seed","ended","walls","pursuers","evaders","played",
"next"];function Lo(r,e){let t=i=>i.map(l=>bl(l,e)).join(""),n=i=>`${Math.floor(i/r.cols)}.${i%r.cols}`,s=vl(r.rewards,e),o=[r.seed,r.episode,r.steps].join("."),a={rules:Po(
r.rules,e),others:r.others?Po(r.others,e):"",rewards:s===gn.rewards?"":s,size:`${r.rows}x${r.cols}`,diagonal:r.diagonal?"1":"",fov:r.fov===gn.fov?"":String(r.fov),
limit:r.maxSteps===gn.maxSteps?"":String(r.maxSteps),seed:o==="0.0.0"?"":o,ended:r.ended?"1":"",walls:r.walls.map(n).join(ft),pursuers:r.pursuers.map(Ro).join(ft),
evaders:r.evaders.map(Ro).join(ft),played:r.played.map(t).join(ft),next:r.next.every(i=>i===_o)?"":t(r.next)};return gl.filter(i=>a[i]).map(i=>`${i}=${a[i]}`).join(
"&")}function Ro({cell:r,gone:e,captured:t,everCaptured:n}){let s=t?"c":n?"e":"";return`${r[0]}.${r[1]}${s}${e?"x":""}`}function Po(r,e){let t=e.fields.map(({name:n})=>String(
r[n]).toLowerCase());return Oo(r,e.variants)??t.join(".")}function vl(r,e){let t=JSON.stringify(r);return Object.keys(e.rewards).find(s=>JSON.stringify(e.rewards[s])===
t)??Object.values(r).map(s=>String(s)).join(ft)}function bl(r,e){if(typeof r=="number")return String(r);if(r===ko)return yl;let t=e.scripts.findIndex(({name:n})=>n===
r);return String.fromCharCode(97+t)}var wl="/* the engine */";function $o(r,e){return m("button",{type:"button",class:"to-playground",title:"Open this step in the playground (G): the same agents a\
nd actions under any rules",onclick:()=>xl(r(),e)},"What if?")}function xl(r,e){let t=r!==null&&r.match.n_agents<=yn&&Math.max(r.match.config.rows,r.match.config.
cols)<=fn,n=t?Lo(Sl(r.match,r.step),e):"",s=new TextDecoder().decode(rn("playground")).replace(wl,()=>we("script-engine")).replace("</noscript>",o=>t?o+Co(r.champions):
o);window.open(`${URL.createObjectURL(new Blob([s],{type:"text/html"}))}#${n}`)}function Sl(r,e){let{config:t,n_agents:n}=r,s=Math.max(0,e-1),o=i=>{let l=s*n+i,
u=s*t.n_evaders+i-t.n_pursuers,h=c=>i>=t.n_pursuers&&!!c[u];return{cell:[r.last_positions[2*l],r.last_positions[2*l+1]],gone:!r.alive[l],captured:h(r.captured),
everCaptured:h(r.ever_captured)}},a=Array.from({length:n},(i,l)=>o(l));return{rules:t.rules,others:null,rewards:t.rewards,rows:t.rows,cols:t.cols,diagonal:t.diagonal,
fov:t.fov,maxSteps:t.max_steps,seed:r.seed,episode:BigInt(r.episode),steps:s,ended:s===r.length,walls:Array.from(r.map.keys()).filter(i=>r.map[i]),pursuers:a.slice(
0,t.n_pursuers),evaders:a.slice(t.n_pursuers),played:[],next:Array.from(r.actions.subarray(s*n,(s+1)*n))}}var vn=.005,Io=.05,Al=["pursuer","evader"],Ml=4,Ye=new Map;function or(r,e,t="capture-rate"){let n=JSON.stringify([{...e,rewards:null,fov:null},t]),s=Ye.get(n)??
(We(e)?Promise.resolve(null):El(r,e,t));return Ye.delete(n),Ye.set(n,s),Ye.size>Ml&&Ye.delete([...Ye.keys()][0]),s}var Fo=({n_evaders:r})=>r===1?"capture-time":
"capture-rate",No=()=>new Promise(r=>setTimeout(r));async function El(r,e,t){await No();let n=r.solution(e,t);for(;n.goBack();)await No();return n}function ar(r,e,t){
let{payoff:n}=r;return t.flatMap((s,o)=>{let a=[0,0];for(let l=e.n_turns;l>0&&!e.over;l--)r.game(e)?.lost(s).forEach((u,h)=>a[h]+=u),e.playTurn(s);let i=n==="ca\
pture-rate"?vn:Io;return Al.map((l,u)=>({step:o+1,team:l,lost:a[u],payoff:n})).filter(l=>l.lost>=i)})}var ir=r=>r.map(e=>({step:e.step,kind:e.team,size:e.lost/Math.
max(1,...r.map(({lost:t})=>t)),text:yt(e)})),Uo=({lost:r,payoff:e})=>e==="capture-rate"?`${r.toFixed(2)} of the capture rate`:`${r.toFixed(1)} steps`,yt=r=>`The\
 ${r.team}s lose ${Uo(r)} against a perfect opponent`;function Do(r){let e=r.reduce((t,n)=>n.lost>t.lost?n:t);return`Your team's worst moves, in step ${e.step},\
 lost ${Uo(e)} against a perfect opponent.`}function zo({config:r,payoff:e},{value:t},n){if(e==="capture-rate")return`value ${t.toFixed(2)}`;let[s,o]=[1-t,Math.
min(r.max_steps-n,zr)];return s>o-Io?`free for ${o} steps`:`captured after ${s.toFixed(1)} steps`}function Wo(r,e){return(r.marginal(e)??[]).map((n,s)=>({share:n,
action:s})).filter(({share:n})=>n>=vn).sort((n,s)=>s.share-n.share).map(({share:n,action:s})=>n>1-vn?ie[s]:`${ie[s]} ${n.toFixed(2)}`).join(", ")}function lr(r,e,t){if(t===0)return[{kind:"start",text:Tl(r),agents:[]}];let[n,s]=[e.moments[t-1],e.moments[t]],o=h=>H(h,r.config.n_pursuers),a=ht(e,n,s),i=r.conflicts(
t),l=new Set(i.flatMap(h=>h.doomed)),u=a.map(h=>({kind:"capture",text:`${o(h)} is captured`,agents:[h]}));for(let h of qt(n,s))!a.includes(h)&&!l.has(h)&&u.push(
{kind:"end",text:`${o(h)} disappears`,agents:[h]});return u.push(...i.map(({kind:h,text:c,agents:d})=>({kind:h,text:c,agents:d}))),t===r.length&&u.unshift({kind:"\
end",text:Cl(r),agents:[]}),u}function Tl({config:r}){return`${r.n_pursuers} pursuers and ${r.n_evaders} evaders on ${r.rows} x ${r.cols} cells, at most ${r.max_steps}\
 steps`}function Cl(r){let e=Math.round(r.statistics.capture_rate*r.config.n_evaders);return`The episode ends after ${r.length} steps with ${e} of ${r.config.n_evaders}\
 evaders captured`}var kl=60,ur=class{element;player=new Ae(0,{speed:Qt,still:fe()});inspector;match=null;recording=null;actions;#e;#r;#t;#n;#s=m("h2",{class:"match-title"});#o=m(
"p",{class:"tally numbers"});#u=m("ol",{class:"words",tabindex:0,"aria-live":"off","aria-label":"What happened in this step"});#d=m("p",{class:"problem",role:"a\
lert"});#a=null;#m=null;#h=0;#l=!1;#f=0;#p=[];constructor(e,t,n){[this.#r,this.#t]=[e,t];let s=m("canvas",{"aria-label":"The match"});this.#e=new Se(s,{numbers:!1}),
this.#n=new nr(t),this.inspector=new sr(o=>this.#w(o)),s.addEventListener("click",o=>this.inspector.choose(this.#e.agentAt(o.clientX,o.clientY))),this.actions=m(
"div",{class:"beside"},m("button",{type:"button",class:"to-play",title:"Move the chosen agent, or an evader, yourself from this step on (T)",onclick:()=>this.element.
dispatchEvent(new Event("takeover"))},"Take over"),n&&$o(()=>this.shown,n)),this.element=m("section",{class:"card match-card","aria-label":"Match",id:"match"},m(
"div",{class:"match"},m("header",{class:"match-head"},this.#s,this.#o),this.#d,m("div",{class:"stage"},s),m("div",{class:"aside"},this.#u,$t(),this.actions,this.
inspector.element),rr(this.player),this.#n.element)),this.player.addEventListener("frame",()=>this.recording&&this.#e.show(this.recording,this.player.time)),this.
player.addEventListener("step",()=>this.#b()),t.on("match",()=>this.#g()),t.on("rest",()=>this.player.pause()),this.#x(),this.#S(0,0)}get#i(){return this.#r[this.#t.
selected.run]}reveal(){this.#e.canvas.scrollIntoView({block:"nearest"})}get shown(){return this.match&&this.#m&&{match:this.match,step:this.player.step,champions:this.#m}}start(e){
this.#a=e,this.#y()}playSoon(){this.#l=!0,this.#h||this.#c()}goTo(e){this.#f=e,!this.#h&&this.match&&this.#y()}#c(){!this.#l||!this.match||(this.#l=!1,this.player.
jump(0),fe()||this.player.play())}#g(){this.#x(),clearTimeout(this.#h),this.#h=setTimeout(()=>this.#y(),kl)}#y(){clearTimeout(this.#h),this.#h=0,this.player.pause(),
this.#x();let{selected:e}=this.#t,t=Be.map(o=>Ut(this.#i,o,e[o])).find(Boolean)??"";if(this.#d.textContent=t,t||!this.#a)return;this.match=To(this.#a,this.#i,e);
let[n,s]=this.names(e);this.#m={pursuer:{name:n,policy:J(this.#i,"pursuer",e.pursuer)},evader:{name:s,policy:J(this.#i,"evader",e.evader)}},this.recording=Xt(this.
match),this.#n.show(this.#i,this.match),this.inspector.show(this.#a,this.#i,this.match,e),this.player.length=this.match.length,this.player.marks=Yt(this.recording),
this.#p=this.player.ticks=[],this.player.jump(this.#f),this.#f=0,this.#b(),this.#v(this.#a,this.match),this.element.dataset.played=`${e.run} ${e.pursuer} ${e.evader}\
 ${e.episode} ${e.seed??""}`,this.#c()}async#v(e,t){let n=await or(e,t.config);if(this.match!==t||!n)return;let s=e.world(t.config);t.seek(s,0),this.#p=ar(n,s,_l(
t)),s.free(),this.player.ticks=ir(this.#p),this.inspector.solution=n,this.#b()}names({run:e,pursuer:t,evader:n}){let{teams:s}=this.#r[e];return[s.pursuer.script??
`pursuers ${t}`,s.evader.script??`evaders ${n}`]}#x(){let{episode:e,seed:t}=this.#t.selected,{payoff:n}=this.#i,[s,o]=this.names(this.#t.selected),a=t===null?e<
n.episodes?`episode ${e+1} of ${n.episodes}`:`episode ${e+1}, not part of the cell`:`seed ${t}`;this.#s.replaceChildren(m("span",{class:"pursuer"},s)," against ",
m("span",{class:"evader"},o),m("span",{class:"muted small"},a))}#b(){let e=this.match;if(!e||!this.recording)return;let t=this.player.step,n=this.recording.moments[t];
this.#S(Array.from(n.everCaptured).filter(Boolean).length,t),this.#u.replaceChildren(...this.#p.filter(s=>s.step===t).map(s=>m("li",{class:`loss-${s.team}`},yt(
s))),...lr(e,this.recording,t).map(s=>m("li",{class:s.kind,"data-agents":s.agents.join(" ")},s.text))),this.inspector.at(t),this.#A()}#S(e,t){this.#o.replaceChildren(
m("strong",{},e),` of ${this.#i.world.n_evaders} captured`,m("span",{class:"muted"},` · step ${t}`))}#w(e){this.#e.look={selected:e,viewers:e===null?[]:[e]},this.#A()}#A(){
let e=this.inspector.agent;for(let t of this.#u.children){let n=t.dataset.agents?.split(" ")??[];t.classList.toggle("about",e!==null&&n.includes(String(e)))}}},
_l=({actions:r,length:e,n_agents:t})=>Array.from({length:e},(n,s)=>r.subarray(s*t,(s+1)*t));var Ol={ArrowUp:[1,0],ArrowDown:[-1,0],ArrowRight:[0,1],ArrowLeft:[0,-1]},Rl=5;function jo(r,e,t,n="pursuer"){r.tabIndex=0,r.setAttribute("role","application"),
r.addEventListener("keydown",s=>{let o=Ol[s.key];if(!o)return;let[a,i]=n==="pursuer"?o:[o[1],o[0]],[l,u]=t(),h=s.shiftKey?Rl:1,{pursuer:c,evader:d}=e.selected;e.
select({pursuer:Bo(c+h*a,l),evader:Bo(d+h*i,u)}),s.preventDefault(),s.stopPropagation()})}var Bo=(r,e)=>Math.min(e-1,Math.max(0,r));var gt=[[68,1,84],[72,26,108],[71,47,125],[65,68,135],[57,86,140],[49,104,142],[42,120,142],[35,136,142],[31,152,139],[34,168,132],[53,183,121],[84,197,104],[122,
209,81],[165,219,54],[210,226,27],[253,231,37]];function cr(r){let e=Math.min(1,Math.max(0,r))*(gt.length-1),t=Math.min(gt.length-2,Math.floor(e)),[n,s]=[gt[t],
gt[t+1]],o=a=>Math.round(n[a]+(e-t)*(s[a]-n[a]));return[o(0),o(1),o(2)]}function Ho(r){let[e,t,n]=cr(r).map(s=>((s/255+.055)/1.055)**2.4);return .2126*e+.7152*t+
.0722*n>.179?"#000":"#fff"}var Go=r=>`rgb(${cr(r).join(" ")})`,Vo=()=>`linear-gradient(to right, ${gt.map(r=>`rgb(${r.join(" ")})`).join(", ")})`;function Yo(r,e,t){let n=devicePixelRatio||1;for(let[a,i]of Object.entries(t))r.style.setProperty(a,`${i}px`);r.width=Math.round(t.width*n),r.height=Math.round(
t.height*n);let s=r.getContext("2d"),o=Pl(e);!s||!o||(s.imageSmoothingEnabled=!1,s.drawImage(o,0,0,r.width,r.height))}function Pl(r){let[e,t]=r.shape,n=document.
createElement("canvas");[n.width,n.height]=[t,e];let s=n.getContext("2d");if(!s)return null;let o=s.createImageData(t,e);return r.capture_rate.forEach((a,i)=>a.
forEach((l,u)=>{let h=4*((e-1-i-r.first[0])*t+u+r.first[1]);o.data.set([...cr(l),255],h)})),s.putImageData(o,0,0),n}function qo(r,e){let t=m("span",{class:"grad\
ient"});return t.style.backgroundImage=Vo(),m("p",{class:"scale-of-rates small muted"},r,t,e)}var Ll=24,hr=7,Zo=r=>r<Ll&&matchMedia("(pointer: coarse)").matches;function Jo(r,e,t,n){let[s,o]=r.payoff.shape,[a,i]=[Ko(e,s),Ko(t,o)],[l,u]=[Math.min(hr,s),Math.
min(hr,o)],h=[];for(let y=a+l-1;y>=a;y--){h.push(m("span",{class:"pursuer"},y));for(let p=i;p<i+u;p++)h.push($l(r,y,p,n))}let c=Array.from({length:u},(y,p)=>m("\
span",{class:"evader"},i+p)),d=m("button",{type:"button","aria-label":"Close: all cells",onclick:()=>n(null)},"✕"),f=m("div",{class:"loupe numbers",role:"grou\
p","aria-label":"Cells around the tap"},...h,d,...c);return f.style.gridTemplateColumns=`2.4rem repeat(${u}, minmax(0, 1fr))`,f.addEventListener("click",y=>y.stopPropagation()),
f}function $l(r,e,t,n){let s=je(r,e,t)?.rate,o=m("button",{type:"button","aria-label":`${V(s)}: pursuers ${e} against evaders ${t}`,onclick:()=>n({pursuer:e,evader:t})},
V(s));return s!==void 0&&([o.style.backgroundColor,o.style.color]=[Go(s),Ho(s)]),o}var Ko=(r,e)=>Math.max(0,Math.min(e-hr,r-Math.floor(hr/2)));var te={left:52,bottom:46,top:76,right:84},le=10,Nl=160,vt=te.right-le-14,ke=te.top-le-14,dr=class{element;#e;#r;#t=m("canvas",{"aria-hidden":"true"});#n=w("svg",
{"aria-hidden":"true"});#s=w("g");#o;#u=m("h2");#d=m("strong",{class:"rate numbers"});#a=m("span",{class:"small muted"});#m=m("p",{class:"of-both-teams small mu\
ted numbers"});#h=null;constructor(e,t){[this.#r,this.#e]=[e,t],this.#o=m("div",{class:"matrix",id:"matrix","aria-label":"Payoff matrix. Arrow keys choose a mat\
ch, Enter plays it."},this.#t,this.#n);let n=m("header",{class:"readout","aria-live":"polite"},m("div",{},this.#u,this.#m),m("div",{class:"of-cell"},this.#d,this.#a));
this.element=m("section",{class:"card matrix-card","aria-label":"Payoff matrix"},n,this.#o,qo("0 all escape","1 all caught")),this.#g(),new ResizeObserver(()=>this.#f()).
observe(this.#o),this.#o.addEventListener("pointermove",s=>this.#x(s)),this.#o.addEventListener("pointerleave",()=>t.point({})),this.#o.addEventListener("click",
s=>this.#b(s)),this.#o.addEventListener("mousedown",s=>{s.preventDefault(),document.activeElement instanceof HTMLElement&&document.activeElement.blur()}),jo(this.#o,
t,()=>this.#l.payoff.shape),this.#o.addEventListener("keydown",s=>{s.key==="Enter"&&this.#w()}),t.on("run",()=>this.#f()),t.on("match",()=>this.#c()),t.on("hove\
r",()=>this.#c())}get#l(){return this.#r[this.#e.selected.run]}#f(){let[e,t]=this.#l.payoff.shape,{clientWidth:n,clientHeight:s}=this.#o;if(n<50)return;let a=Math.
max(Nl,Math.min(n-te.left-te.right,s-te.top-te.bottom))/Math.max(e,t),i=Math.max(te.left,(n-t*a-te.right+te.left)/2),l=te.top+Math.max(0,(s-te.top-te.bottom-e*a)/
2),u={width:n,height:s,left:i,top:l,cell:a,rows:e,columns:t};this.#h=u,Yo(this.#t,this.#l.payoff,{left:i,top:l,width:t*a,height:e*a}),this.#n.setAttribute("view\
Box",`0 0 ${n} ${s}`),this.#n.replaceChildren(Il(u),...Fl(u),...this.#i(u),this.#s),this.#c()}#p(e){let t=this.#l.findings?.generalization;if(!t)return[];let{selected:n,
hover:s}=this.#e,[o,a]=[s.pursuer??n.pursuer,s.evader??n.evader],[i,l]=Xo(e,t.pursuers.mean[o]??0,o),[u,h]=Qo(e,t.evaders.mean[a]??0,a);return[w("circle",{class:"\
dot of-pursuers",cx:i,cy:l,r:5}),w("circle",{class:"dot of-evaders",cx:u,cy:h,r:5})]}#i(e){let t=this.#l.findings?.generalization;if(!t)return[];let{left:n,top:s,
cell:o,rows:a,columns:i}=e,[l,u]=[n+i*o+le,s-le],h={class:"side"};return[w("rect",{...h,x:l,y:s,width:vt,height:a*o}),w("rect",{...h,x:n,y:u-ke,width:i*o,height:ke}),
...ea(t.pursuers,(c,d)=>Xo(e,c,d),"of-pursuers"),...ea(t.evaders,(c,d)=>Qo(e,c,d),"of-evaders"),w("text",{class:"tick",x:l,y:s+a*o+16,"text-anchor":"start"},"0"),
w("text",{class:"tick",x:l+vt,y:s+a*o+16,"text-anchor":"end"},"1"),w("text",{class:"tick",x:n-6,y:u-4,"text-anchor":"end"},"0"),w("text",{class:"tick",x:n-6,y:u-
ke+8,"text-anchor":"end"},"1"),w("text",{class:"label of-pursuers",x:l+vt,y:s+a*o+34,"text-anchor":"end"},"captures"),w("text",{class:"label of-evaders",x:n+i*o+
le,y:u-ke+10,"text-anchor":"start"},"escapes")]}#c(){let e=this.#h;if(!e)return;let{selected:t,hover:n}=this.#e,{left:s,top:o,cell:a,rows:i,columns:l}=e,u=y=>o+
(i-1-y)*a,h=[],c=(y,p)=>w("rect",{class:p,x:s,y:u(y),width:l*a+le+vt,height:a}),d=(y,p)=>w("rect",{class:p,x:s+y*a,y:o-le-ke,width:a,height:le+ke+i*a});h.push(c(
t.pursuer,"strip pursuer"),d(t.evader,"strip evader")),n.pursuer!==null&&n.pursuer<i&&h.push(c(n.pursuer,"strip hover")),n.evader!==null&&n.evader<l&&h.push(d(n.
evader,"strip hover")),h.push(...this.#p(e));let f={x:s+t.evader*a,y:u(t.pursuer),width:a,height:a};h.push(w("rect",{class:"chosen under",...f}),w("rect",{class:"\
chosen",...f})),this.#s.replaceChildren(...h),this.#g()}#g(){let{selected:e,hover:t}=this.#e,n=t.pursuer??e.pursuer,s=t.evader??e.evader,o=je(this.#l,n,s);this.#u.
replaceChildren(m("span",{class:"pursuer"},`Pursuers ${n}`)," against ",m("span",{class:"evader"},`evaders ${s}`)),this.#d.textContent=o?V(o.rate,3):"-",this.#a.
textContent=o?`capture rate, mean of ${o.rates.length} episodes`:"no episodes were played",this.#m.textContent=this.#y(n,s)}#y(e,t){let n=this.#l.findings?.generalization;
if(!n)return"";let s=(o,a)=>Os(o.mean[a]??null,o.low?.[a]??null,o.high?.[a]??null);return`Against all: captures ${s(n.pursuers,e)}, escapes ${s(n.evaders,t)}`}#v(e){
let t=this.#h;if(!t)return null;let n=this.#o.getBoundingClientRect(),s=Math.floor((e.clientX-n.left-t.left)/t.cell),o=t.rows-1-Math.floor((e.clientY-n.top-t.top)/
t.cell),[a,i]=[o>=0&&o<t.rows,s>=0&&s<t.columns];return a||i?{g:a?o:-1,h:i?s:-1,inside:a&&i}:null}#x(e){let t=this.#v(e);this.#e.point(t?{pursuer:t.g<0?null:t.g,
evader:t.h<0?null:t.h}:{})}#b(e){let t=this.#v(e);if(t){if(t.inside&&Zo(this.#h.cell))return this.#S(t.g,t.h);this.#e.select({...t.g<0?{}:{pursuer:t.g},...t.h<0?
{}:{evader:t.h}}),t.inside&&this.#w()}}#S(e,t){let n=Jo(this.#l,e,t,s=>{n.remove(),s&&(this.#e.select(s),this.#w())});this.#o.append(n)}#w(){this.#o.dispatchEvent(
new CustomEvent("play",{bubbles:!0}))}};function Il({left:r,top:e,cell:t,rows:n,columns:s}){let o=w("g",{class:"axes"}),a=e+n*t,i=l=>ct(0,l-1,Math.min(l,l*t/44),
!0);for(let l of i(s))o.append(w("text",{class:"tick",x:r+(l+.5)*t,y:a+16,"text-anchor":"middle"},l));for(let l of i(n))o.append(w("text",{class:"tick",x:r-7,y:a-
(l+.5)*t,"text-anchor":"end","dominant-baseline":"middle"},l));return o.append(w("text",{class:"label of-evaders",x:r+s*t/2,y:a+36,"text-anchor":"middle"},"evad\
er generation"),w("text",{class:"label of-pursuers",transform:`translate(${r-36} ${e+n*t/2}) rotate(-90)`,"text-anchor":"middle"},"pursuer generation")),o}function Fl({
left:r,top:e,cell:t,rows:n,columns:s}){let o=w("g",{class:"diagonal"}),a=Math.min(n,s);if(a<3)return[];let i=e+n*t;for(let h of["H","V"]){let c=`M${r} ${i}`;for(let d=1;d<=
a;d++){let[f,y]=[`H${r+d*t}`,`V${i-d*t}`];c+=h==="H"?f+y:y+f}o.append(w("path",{d:c,class:"under"}),w("path",{d:c}))}let[l,u]=[r+a/2*t-.7*t-4,i-a/2*t-.7*t-4];return[
o,w("text",{class:"on-cells",transform:`translate(${l} ${u}) rotate(-45)`,"text-anchor":"middle"},"same generation")]}var Xo=({left:r,top:e,cell:t,rows:n,columns:s},o,a)=>[
r+s*t+le+o*vt,e+(n-a-.5)*t],Qo=({left:r,top:e,cell:t},n,s)=>[r+(s+.5)*t,e-le-n*ke];function ea(r,e,t){let n=o=>o.map((a,i)=>e(a??0,i).map(l=>l.toFixed(1)).join(
" ")),s=[];return r.low&&r.high&&s.push(w("path",{class:`band ${t}`,d:`M${[...n(r.high),...n(r.low).reverse()].join("L")}Z`})),s.push(w("path",{class:`line ${t}`,
d:`M${n(r.mean).join("L")}`})),s}var ta={pursuer:null,evader:null},mr=class extends EventTarget{#e;#r=ta;constructor(e){super(),this.#e=e}get selected(){return this.#e}get hover(){return this.#r}select(e){
let t=this.#e,n=["run","pursuer","evader"].some(s=>s in e&&e[s]!==t[s]);this.#e={...t,...n?{episode:0,seed:null}:{},...e},this.#e.run!==t.run&&this.dispatchEvent(
new Event("run")),this.dispatchEvent(new Event("match"))}point(e){let t={...ta,...e};t.pursuer===this.#r.pursuer&&t.evader===this.#r.evader||(this.#r=t,this.dispatchEvent(
new Event("hover")))}on(e,t){this.addEventListener(e,t)}};var pr=class{config;start;recording;actions=[];#e;#r;#t=[[]];constructor(e,t,n){[this.config,this.start]=[t,n],this.#e=e.world(t),this.#e.reset(n),this.#r=[pn(this.#e)],
this.recording=mn(t,this.#e.map(),this.#r)}get length(){return this.actions.length}get over(){return this.#e.over}get statistics(){return{capture_rate:this.#e.read(
"capture_rate")[0]}}conflicts(e){return this.#t[e]}game(e){return e.game(this.#e)}play(e){this.#e.step(e),this.#n(e)}step(e,t,n){let[s,o]=[this.#e,this.config.n_pursuers],
a=new Uint8Array(s.n_agents);for(let i=s.n_turns;i>0&&!s.over;--i){let[l,u]=s.actors;l<o&&(a=s.decide(e.pursuer,[l,Math.min(u,o)],a)),u>o&&(a=s.decide(e.evader,
[Math.max(l,o),u],a)),typeof n=="number"?a[t]=n:l<=t&&t<u&&(a=s.decide(n,[t,t+1],a)),s.playTurn(a)}this.#n(a)}#n(e){this.actions.push(e),this.#r.push(pn(this.#e,
e)),this.#t.push(this.#e.conflicts())}};var ue=(r,e)=>Be[+(e>=r.n_pursuers)];function bn(r,e){let t=new pr(r,e.config,{seed:e.seed,episode:e.episode});for(let n of e.moves)t.over||t.step(e.policies,e.
seat,n);return t}function qe(r,e){let{moments:t,nPursuers:n}=r.recording,s=t.findIndex(({alive:a,captured:i})=>!a[e]||!!i[e-n]),o=s<0?r.length:s;return{lasted:o,
out:s>=0,captured:Array.from(t[o].everCaptured).filter(Boolean).length}}var fr=(r,e)=>r.over||qe(r,e).out;function ra(r,e,t){let n=bn(r,{...e,moves:e.moves.slice(
0,e.from)});for(;!fr(n,e.seat);)n.step(e.policies,e.seat,t);return qe(n,e.seat)}function na(r){let e=r.length-1;return[...new Set([0,Math.round(e/3),e])].map(t=>r[t])}
function sa(r,{seat:e,from:t,moves:n}){let s={...r,seat:e,...t?{from:t}:{},moves:n.join("")};return`${location.href.split("#")[0]}#${Object.entries(s).map(([o,a])=>`${o}\
=${a}`).join("&")}`}function oa(r,e){let[t,n,s]=[r.get("seat")??"",r.get("from")??"0",r.get("moves")??""];return/^\d{1,6}$/.test(t)&&Number(t)<e.n_pursuers+e.n_evaders&&
(e.diagonal?/^[0-8]+$/:/^[0-4]+$/).test(s)&&s.length<=e.max_steps&&/^\d{1,6}$/.test(n)&&Number(n)<=s.length?{seat:Number(t),from:Number(n),moves:[...s].map(Number)}:
null}function wn(r,e,t,n,s,o){e.play({title:t,played:n,ending:(a,i)=>[Ul(r,a,i,na(s))],again:()=>wn(r,e,t,{...n,moves:n.moves.slice(0,n.from)},s,o),link:a=>o&&sa(o,a)})}
function Ul(r,e,t,n){let s=ue(t.config,t.seat)==="evader",o=s?t.config.max_steps:t.config.n_evaders,a=m("table",{class:"numbers"},m("caption",{},s?"Steps in you\
r seat: same start, same others":"Captures of your team: same start, same others")),i=u=>{let[h,c]=[m("span",{class:s?"bar evader":"bar pursuer"}),m("td",{},"…")];
return a.append(m("tr",{},m("th",{scope:"row"},u),m("td",{class:"track","aria-hidden":"true"},h),c)),({lasted:d,captured:f})=>{h.style.width=`${100*(s?d:f)/o}%`,
c.textContent=String(s?d:f)}};i("You")(qe(e,t.seat));for(let{name:u,policy:h}of n){let c=i(u);setTimeout(()=>c(ra(r,t,h())))}let l=t.from?`You took over at step\
 ${t.from}. `:"";return m("div",{},a,m("p",{class:"small muted"},`${l}One match: luck has its part in it.`))}var aa=["·","↑","→","↓","←","↗","↘","↙","↖"];var Dl={" ":0,s:0,ArrowUp:1,w:1,ArrowRight:2,d:2,ArrowDown:3,x:3,ArrowLeft:4,a:4,e:5,c:6,y:7,z:7,q:8},xn=[8,1,5,4,0,2,7,3,6],zl=[7,8,9,4,5,6,1,2,3],Wl=24,Bl=Math.
tan(Math.PI/8);function la(r,e){if(r.ctrlKey||r.metaKey||r.altKey)return;let t=zl.findIndex(s=>r.code===`Numpad${s}`),n=xn[t]??Dl[r.key.length===1?r.key.toLowerCase():
r.key];return n!==void 0&&n>4&&!e?void 0:n}function ua(r){let e=xn.map(t=>m("button",{type:"button","aria-label":ie[t],onclick:()=>r(t)},aa[t]));return{element:m(
"div",{class:"play-pad",role:"group","aria-label":"Your move"},...e),show:t=>e.forEach((n,s)=>n.classList.toggle("absent",xn[s]>4&&!t))}}function ia(r,e,t){let n=Bl*
Math.max(Math.abs(r),Math.abs(e)),s=o=>Math.abs(o)<n?0:o;return Fs([0,0],t?[s(r),s(e)]:[r,e],t)}function ca(r,e,t){let n=null,{canvas:s}=r;s.addEventListener("p\
ointerdown",({button:o,clientX:a,clientY:i})=>{n=o===0?[a,i]:null}),s.addEventListener("pointercancel",()=>{n=null}),s.addEventListener("pointerup",({clientX:o,
clientY:a})=>{let[i,l]=[n,e()];if(n=null,!i||!l)return;let[u,h]=[o-i[0],a-i[1]],c=r.cellAt(o,a);Math.hypot(u,h)>=Wl?t(ia(h,u,l.diagonal)):c&&t(ia(c[0]-l.cell[0],
c[1]-l.cell[1],l.diagonal))})}function ha(r,e){let t=n=>{let s=e[n]-r[n],o=He.findIndex(a=>a[n]===Math.sign(s)&&a[1-n]===0);return s?`${Math.abs(s)} ${ie[o]}`:""};
return[t(0),t(1)].filter(Boolean).join(", ")||"on your cell"}var pa="NUMPY\0",da=pa.length+2,ma=64;function yr(r){return Ft(Object.fromEntries(Object.entries(r).map(([e,t])=>[`${e}.npy`,jl(t)])))}function jl({dtype:r,shape:e,
data:t}){let n=typeof t=="string"?Array.from(t,h=>h.codePointAt(0)):null,s=e.map(h=>`${h}, `).join(""),o=`{'descr': '${n?`<U${n.length}`:r}', 'fortran_order': F\
alse, 'shape': (${s}), }`,a=Math.ceil((da+o.length+1)/ma)*ma-da,i=pa+String.fromCharCode(a&255,a>>8)+o.padEnd(a-1)+`
`,l=n?Int32Array.from(n):t,u=new Uint8Array(i.length+l.byteLength);return u.set(ne(i,!0)),u.set(new Uint8Array(l.buffer,l.byteOffset,l.byteLength),i.length),u}var Hl="matrixworld episode 3";function fa(r,e,t){let{config:n,actions:s,length:o,recording:a}=e,[i,l]=[n.n_pursuers+n.n_evaders,n.n_evaders],u={positions:["<i4",
i,2],last_positions:["<i4",i,2],alive:["|b1",i],captured:["|b1",l],ever_captured:["|b1",l]},h={rewards:["<f4",i],involved:["|b1",i,3],fault:["|b1",i,3]},c={},d=b=>{
for(let A of Object.keys(b))(c[A]??=[]).push(Array.from(f.read(A),Number))},f=r.world(n);f.reset(e.start);let y=[];d(u);for(let b of s)f.step(b),d({...u,...h}),
y.push(...f.conflictTable());f.free();let p={"<i4":Int32Array,"<f4":Float32Array,"|b1":Uint8Array},g={};for(let[b,[A,..._]]of Object.entries({...u,...h})){let $=o+
+(b in u);g[b]={dtype:A,shape:[$,..._],data:p[A].from((c[b]??[]).flat())}}let v=b=>({dtype:"<i8",shape:[],data:Int32Array.of(b,0)}),x=b=>({dtype:"<U",shape:[],data:b});
return yr({format:x(Hl),n_pursuers:v(n.n_pursuers),config:x(JSON.stringify(n)),seat:v(t),...g,actions:{dtype:"|i1",shape:[o,i],data:Int8Array.from(s.flatMap(b=>[
...b]))},map:{dtype:"|b1",shape:[n.rows,n.cols],data:Uint8Array.from(a.obstacles,Number)},conflict_table:{dtype:"<i4",shape:[y.length/11,11],data:Int32Array.from(
y)}})}var Gl=[0,1,2,4,8],gr=class{element;player=new Ae(0,{speed:4,still:fe()});#e;#r;#t=m("canvas",{tabindex:0,"aria-describedby":"play-keys"});#n=m("h2");#s=m("p",{
class:"play-told",role:"status"});#o=ua(e=>this.act(e));#u=m("select",{},...Gl.map(e=>m("option",{value:e},e?`${e} / s`:"step by step")));#d=m("input",{type:"ch\
eckbox"});#a=m("input",{type:"checkbox"});#m=m("span");#h=m("p",{class:"small muted play-keys",id:"play-keys"});#l=m("section",{class:"play-ending",tabindex:-1,
"aria-labelledby":"play-headline"});#f=rr(this.player);#p=null;#i=null;#c=[];#g=null;#y=null;#v=[];#x=0;#b=0;constructor(e){this.#e=e,this.#r=new Se(this.#t,{numbers:!1}),
this.#t.setAttribute("role","application"),this.#u.addEventListener("change",()=>this.#T()),this.#d.addEventListener("change",()=>this.#w()),this.#a.addEventListener(
"change",()=>this.#O()),ca(this.#r,()=>{let t=this.#g!==null&&this.#i&&k(this.#i.recording.moments.at(-1),this.#g);return t?{cell:t,diagonal:this.#i.config.diagonal}:
null},t=>this.act(t)),this.player.addEventListener("frame",()=>this.#i&&this.#r.show(this.#i.recording,this.player.time)),this.player.addEventListener("step",()=>this.#O()),
this.element=m("div",{class:"play"},m("header",{class:"play-head"},this.#n,this.#s),m("div",{class:"play-stage"},this.#t),m("div",{class:"play-side"},this.#l,this.#o.
element,m("label",{class:"play-choice",title:"Steps a second"},"Pace ",this.#u),m("label",{class:"play-choice"},this.#d,m("span",{},"Fog",m("span",{class:"at-le\
ngth"},": see only what it sees"))),m("label",{class:"play-choice"},this.#a,this.#m),this.#h),this.#f)}get played(){return this.#p&&{...this.#p.played,moves:this.#c}}get live(){
return this.#i}play(e){this.#S(bn(this.#e,e.played),e.played.seat,e.title),[this.#p,this.#c,this.#x]=[e,[...e.played.moves],0],this.element.dataset.state="playi\
ng",this.#t.focus({preventScroll:!0}),fr(this.#i,e.played.seat)&&this.#_()}watch(e,t,n){this.#p=null,this.#S(e,t,n),this.#R()}stop(){this.#T(),this.player.pause(),
this.#p=null}act(e){let[t,n]=[this.#p,this.#i];if(!t||!n||this.element.dataset.state!=="playing")return;this.#x=e;let s=Number(this.#u.value);this.#b||(this.#k(),
s&&this.element.dataset.state==="playing"&&(this.#b=setInterval(()=>this.#k(),1e3/s)))}key(e){let{target:t,key:n}=e;if(t instanceof HTMLSelectElement||t instanceof
HTMLInputElement&&(t.type==="text"||n===" ")||t instanceof HTMLButtonElement&&(n===" "||n==="Enter")||!this.#i)return!1;if(this.element.dataset.state!=="playing")
return tr(this.player,e);let o=la(e,this.#i.config.diagonal);return o!==void 0&&this.act(o),o!==void 0}#S(e,t,n){this.#T(),this.player.pause(),[this.#i,this.#g]=
[e,t],this.#n.textContent=n,this.#t.ariaLabel=`Board, ${e.config.rows} by ${e.config.cols} cells`,this.#o.show(e.config.diagonal),this.#h.replaceChildren(m("spa\
n",{class:"at-length"},`Arrow keys or W A X D move, Space or S stays${e.config.diagonal?"; Q E Z C and the numeric keypad move diagonally":""}. `),"On the board\
: swipe, or tap where to go."),this.#A(e),this.#l.replaceChildren(),this.player.length=e.length,this.player.jump(e.length),this.#O()}#w(){this.#r.look={you:this.#g,
fog:this.#d.checked,viewers:this.#g===null?[]:[this.#g],plan:this.#C()}}#A(e){this.#y=null,this.#v=this.player.ticks=[];let t=We(e.config);this.#a.hidden=this.#a.
disabled=!!t,this.#m.className=t?"small muted":"",this.#m.textContent=t?`No best move: ${t}`:"Best move",or(this.#e,e.config,Fo(e.config)).then(n=>{this.#i===e&&
(this.#y=n,this.#E(),this.#O())})}#E(){let[e,t]=[this.#i,this.#y];if(!t||this.element.dataset.state==="playing")return;let n=this.#e.world(e.config);n.reset(e.start),
this.#v=ar(t,n,e.actions),n.free(),this.player.ticks=ir(this.#v)}get#M(){return this.#a.checked&&this.#p&&this.element.dataset.state==="playing"&&this.#y&&this.#i.
game(this.#y)||null}#C(){let[e,t]=[this.#g,this.#g!==null&&this.#M?.marginal(this.#g)];return e!==null&&t?Object.assign(Array(e).fill(0),{[e]:t.indexOf(Math.max(
...t))}):null}#T(){clearInterval(this.#b),this.#b=0,this.#s.ariaLive=Number(this.#u.value)?"off":"polite"}#k(){let[{policies:e,seat:t},n]=[this.#p.played,this.#i];
n.step(e,t,this.#x),this.#c.push(this.#x),this.player.length=n.length,this.player.glide=Math.min(.22,.9/(Number(this.#u.value)||4)),this.player.move(n.length-this.
player.step),fr(n,t)&&this.#_()}#_(){this.#T();let[e,t,n]=[this.#p,this.#i,this.played],s=Lt()?e.link(n):null;this.#l.replaceChildren(m("h3",{id:"play-headline"},
ql(t,n.seat)),...e.ending(t,n),m("div",{class:"play-buttons"},m("button",{type:"button",class:"primary",onclick:()=>e.again()},"Again"),m("button",{type:"button",
onclick:()=>this.#R()},"Watch it"),m("button",{type:"button",onclick:()=>this.#P(t,n.seat)},"Save"),s&&m("button",{type:"button",onclick:({currentTarget:a})=>Zl(
a,s)},"Link"))),this.element.dataset.state="ended",this.#E();let o=this.#v.filter(({team:a})=>a===ue(t.config,n.seat));o.length&&this.#l.children[0].after(m("p",
{class:"small muted"},Do(o))),this.#l.focus({preventScroll:!0}),this.#l.scrollIntoView({block:"nearest"})}#R(){this.element.dataset.state="watched",this.player.
length=this.#i.length,this.player.jump(0),fe()||this.player.play()}#P(e,t){let n=new Blob([fa(this.#e,e,t)],{type:"application/octet-stream"});m("a",{href:URL.createObjectURL(
n),download:`${H(t,e.config.n_pursuers)}-${e.length}-steps.npz`}).click()}#O(){let[e,t,{step:n}]=[this.#i,this.#g,this.player];if(!e||n>e.length)return;let s=lr(
e,e.recording,n).filter(({agents:i})=>t===null||i.includes(t)),o=[`Step ${n} of ${e.config.max_steps}`,...s.map(({text:i})=>i)];this.#p&&n===0?o.push(this.#p.about??
"",Vl(e.config,t)):t!==null&&o.push(Yl(e,n,t)),o.push(...this.#v.filter(i=>i.step===n).map(yt));let a=n===e.length&&t!==null?this.#M:null;a&&o.push(`Perfect pla\
y: ${Wo(a,t)||"decided in its turn"}; ${zo(this.#y,a,n)}`),this.#w(),this.#s.textContent=o.filter(Boolean).map(i=>`${i}.`).join(" ")}};function Vl(r,e){let t=r.
rules.capture==="SURROUND";return ue(r,e)==="evader"?`Stay free: ${t?"pursuers on all sides of you capture":"a pursuer on your cell captures"} you`:`Capture eva\
ders: ${t?"surround them together":"reach their cell"}`}function Yl({config:r,recording:e},t,n){let s=e.moments[t],a=ue(r,n)==="pursuer"?"evader":"pursuer";if(!s.
alive[n])return"";let i=k(s,n),l=c=>{let[d,f]=k(s,c);return Math.max(Math.abs(d-i[0]),Math.abs(f-i[1]))},u=Array.from({length:s.alive.length},(c,d)=>d).filter(c=>ue(
r,c)===a&&s.alive[c]&&!s.captured[c-r.n_pursuers]&&2*l(c)<r.fov);if(!u.length)return`No ${a} in view`;let h=u.reduce((c,d)=>l(d)<l(c)?d:c);return`Nearest ${a}: ${ha(
i,k(s,h))}`}function ql(r,e){let[{lasted:t,out:n,captured:s},{config:o}]=[qe(r,e),r];return ue(o,e)==="pursuer"?`Your team captured ${s} of ${Kl(o)} in ${t} ste\
ps.`:n?`You lasted ${t} of ${o.max_steps} steps.`:`You escaped: ${t} steps.`}var Kl=({n_evaders:r})=>`${r} evader${r===1?"":"s"}`;function Zl(r,e){let t=m("inpu\
t",{type:"text",readonly:!0,value:e,"aria-label":"Link to this match"});r.replaceWith(t),t.select(),navigator.clipboard?.writeText(e).catch(()=>{})}var Jl=2n**64n-1n;function ya(r,e,t){let n=new URLSearchParams(r.replace(/^#/,"")),s=(u,h,c)=>{let d=n.get(u)??"";return/^\d{1,9}$/.test(d)&&Number(d)<h?Number(
d):c},o=s("run",e.length,t.run),[a,i]=e[o].payoff.shape,l=n.get("seed")??"";return{run:o,pursuer:s("pursuers",a,Math.min(t.pursuer,a-1)),evader:s("evaders",i,Math.
min(t.evader,i-1)),episode:s("episode",1/0,t.episode),seed:/^\d{1,20}$/.test(l)&&BigInt(l)<=Jl?l:null,step:s("step",1/0,0)}}var vr=class{dialog=m("dialog",{class:"take-over","aria-label":"Play an agent"});view=null;#e;#r;#t;#n;#s=null;constructor(e,t,n,s=!0){[this.#e,this.#r,this.#t,
this.#n]=[e,t,n,s],n.element.addEventListener("takeover",()=>this.open()),this.dialog.addEventListener("keydown",o=>this.view?.key(o)&&o.preventDefault()),this.
dialog.addEventListener("close",()=>this.view?.stop())}start(e,t=""){this.#s=e;let n=ya(t,this.#e,this.#r.selected),s=oa(new URLSearchParams(t.replace(/^#/,"")),
this.#e[n.run].world);s&&this.play(n,s)}open(){let e=this.#t.shown;if(!e)return;let{match:t,step:n}=e;this.#t.player.pause();let s=this.#t.inspector.agent,o=n<t.
length?n:0,a=(c,d)=>!!t.alive[d*t.n_agents+c],i=Array.from({length:t.n_agents},(c,d)=>(d+t.config.n_pursuers)%t.n_agents),l=s??i.find(c=>a(c,o)),u=a(l,o)?o:0,h=Array.
from({length:u},(c,d)=>t.actions[d*t.n_agents+l]);this.play(this.#r.selected,{seat:l,from:u,moves:h})}play(e,t){let[n,s]=[this.#s,this.#e[e.run]];if(!n||Be.some(
g=>Ut(s,g,e[g])))return;let{run:o,pursuer:a,evader:i,episode:l,seed:u}=e,h=ue(s.world,t.seat),c=s.teams[h].kept.map(g=>({name:s.teams[h].script??`generation ${g}`,
text:"",policy:()=>J(s,h,g)}));this.view||(this.view=new gr(n),this.dialog.append(m("button",{type:"button",class:"leave",onclick:()=>this.dialog.close()},"Clos\
e"),this.view.element)),this.dialog.open||this.dialog.showModal();let d=`You are ${H(t.seat,s.world.n_pursuers)}: ${this.#t.names(e).join(" against ")}`,f={pursuer:J(
s,"pursuer",a),evader:J(s,"evader",i)},y={config:s.world,seed:BigInt(u??s.seeds[a][i]),episode:l,policies:f,...t},p={run:o,pursuers:a,evaders:i,episode:l,...u===
null?{}:{seed:u}};wn(n,this.view,d,y,c,this.#n?p:null)}};var Xl=8,Ql=700,ga=1400,bt=class{element;player=new Ae(0,{speed:Xl,still:fe()});title=m("figcaption");generation=0;#e=m("canvas");#r;#t=m("p",{class:"small mute\
d numbers"});#n;#s=null;#o=0;#u=0;#d=!fe();constructor(e){this.#n=e,this.#r=new Se(this.#e,{numbers:!1}),this.element=m("figure",{class:"chase"},this.title,this.#e,
this.#t),this.player.addEventListener("frame",()=>this.#h()),this.player.addEventListener("step",()=>this.#l()),this.player.addEventListener("state",()=>{this.#d&&
!this.player.playing&&this.player.length&&this.player.step===this.player.length&&this.#a()})}set label(e){this.#e.ariaLabel=e}get runs(){return this.#d}set runs(e){
this.#d=e,clearTimeout(this.#u),e?this.player.play():this.player.pause()}renew(e=!1){e||!this.#s||performance.now()-this.#o>ga?this.#m():this.#a(ga)}#a(e=Ql){clearTimeout(
this.#u),this.#u=setTimeout(()=>this.#m(),e)}#m(){clearTimeout(this.#u);let e=this.#n();e&&(this.#s=Xt(e),this.#o=performance.now(),this.player.jump(0),this.player.
length=e.length,this.player.marks=Yt(this.#s),this.#l(),this.#d&&this.player.play())}#h(){this.#s&&this.#r.show(this.#s,this.player.time)}#l(){let e=this.#s?.moments[this.
player.step]?.everCaptured;e&&(this.#t.textContent=`generation ${this.generation} · ${Array.from(e).filter(Boolean).length} of ${e.length} caught · step ${this.
player.step}`)}drawWalls(e){let t=!1,n=!0,s=[0,0],o=([i,l])=>!!this.#s?.obstacles[i*this.#s.cols+l],a=i=>{let l=this.#r.cellAt(i.clientX,i.clientY);l&&o(l)!==n&&
e(l,n)};return this.#e.addEventListener("pointerdown",i=>{let l=t&&this.#r.cellAt(i.clientX,i.clientY);l&&(this.#e.setPointerCapture(i.pointerId),n=!o(l),a(i))}),
this.#e.addEventListener("pointermove",i=>t&&i.buttons&&a(i)),this.#e.addEventListener("keydown",i=>{let l={ArrowUp:[-1,0],ArrowDown:[1,0],ArrowLeft:[0,-1],ArrowRight:[
0,1]}[i.key];if(!t||!this.#s||!(l||i.key===" "))return;i.preventDefault();let u=(d,f)=>Math.min(f-1,Math.max(0,d)),{rows:h,cols:c}=this.#s;l?s=[u(s[0]+l[0],h),u(
s[1]+l[1],c)]:e(s,!o(s)),this.#r.look={cursor:s}}),{active:i=>{t=i,this.#e.classList.toggle("drawn-on",i),this.#e.tabIndex=i?0:-1,this.#e.setAttribute("role",i?
"application":"img"),this.#r.look={cursor:null}}}}show(e){this.#s&&(this.#s={...this.#s,obstacles:e},this.#h())}};var va=-12676506002282294e14,ba=({hidden:r,mask:e})=>r.map(t=>t+(e?4:0));function wt(r){let e=[3*r.fov**2,...ba(r),5],t=0;return e.slice(1).map((n,s)=>{let o={at:t,
inputs:e[s],outputs:n};return t+=(o.inputs+1)*n,o})}function Ke(r){let{at:e,inputs:t,outputs:n}=wt(r).at(-1);return e+(t+1)*n}var xt=(r,e)=>({hidden:ba(r),activation:"\
relu",sampled:!0,memory:"none",genome:e});function wa(r,e,t,n){let s=new Float32Array(Ke(r)),o=wt(r);return o.forEach(({at:a,inputs:i,outputs:l},u)=>{let h=Math.
fround(u===o.length-1?n:t);e.normals(i*l).forEach((c,d)=>s[a+d]=h*c)}),s}function Sn(r){let{fov:e,mask:t}=r;if(!t)return null;let[n,s]=[new Uint8Array(Ke(r)),new Float32Array(
Ke(r))],o=wt(r),a=o.length-1,i=Math.floor(e/2);return o.forEach(({at:l,inputs:u,outputs:h},c)=>{let d=(f,y)=>l+f*h+y;for(let f=0;f<4;f++)if(c>0&&n.fill(1,d(u-4+
f,0),d(u-4+f+1,0)),c<a)for(let y=0;y<=u;y++)n[d(y,h-4+f)]=1;t.forEach((f,y)=>{let p=c===a?1+y:h-4+y,g=c===0?f.map(([v,x,b])=>(v*e+i+x)*e+i+b):[u-4+y];for(let v of g)
n[d(v,p)]=1,s[d(v,p)]=c===a?va:1})}),{fixed:n,values:s}}function An(r,e){return e?r.map((t,n)=>e.fixed[n]?e.values[n]:t):r}function xa(r,e,t){let n=new Float32Array(
Ke(t)),[s,o]=[wt(e),wt(t)],a=Math.floor(t.fov/2)-Math.floor(e.fov/2),i=u=>u>=0&&u<t.fov,l=u=>{let[h,c,d]=[Math.floor(u/e.fov**2),Math.floor(u/e.fov)%e.fov+a,u%e.
fov+a];return i(c)&&i(d)?(h*t.fov+c)*t.fov+d:-1};return s.forEach((u,h)=>{let c=o[h],d=e.hidden[h]??5;for(let f=0;f<(h?e.hidden[h-1]:u.inputs);f++){let y=h?f:l(
f);if(!(y<0))for(let p=0;p<d;p++)n[c.at+y*c.outputs+p]=r[u.at+f*u.outputs+p]}for(let f=0;f<d;f++)n[c.at+c.inputs*c.outputs+f]=r[u.at+u.inputs*u.outputs+f]}),An(
n.map(u=>u<=va/2?0:u),Sn(t))}var Ea={initial:1,noise:2,learn:3,opponents:4},En={pursuer:1,evader:2,both:3},_e=4,Mn=2n**32n;function Sa(r){let e=[],t=BigInt(r);do e.push(Number(t%Mn)),t/=Mn;while(t>
0n);return e}function Aa(r,e){let t=r;return n=>{let s=n^t;return t=Math.imul(t,e),s=Math.imul(s,t),s^s>>>16}}function Ma(r,e){let t=Math.imul(3389127133,r)-Math.
imul(1232336661,e)|0;return t^t>>>16}function Tn(r,e,t){let n=r.flatMap(Sa);if(e.length){for(;n.length<_e;)n.push(0);n.push(...e.flatMap(Sa))}let s=Aa(1135663077,
2468251765),o=Array.from({length:_e},(i,l)=>s(n[l]??0));for(let i=0;i<_e;i++)for(let l=0;l<_e;l++)i!==l&&(o[l]=Ma(o[l],s(o[i])));for(let i of n.slice(_e))for(let l=0;l<
_e;l++)o[l]=Ma(o[l],s(i));let a=Aa(2337405405,1492356589);return Uint32Array.from({length:t},(i,l)=>a(o[l%_e]))}function St(r,e){let t=Tn(r,[],2*e);return BigUint64Array.
from({length:e},(n,s)=>BigInt(t[2*s])+Mn*BigInt(t[2*s+1]))}var br=(r,e,t)=>St([r,e,t],1)[0];var Ta=r=>(e,...t)=>new Cn(Tn([r],[Ea[e],...t],3)),Cn=class{#e;#r;#t;#n=1;constructor(e){[this.#e,this.#r,this.#t]=[e[0],e[1],e[2]];for(let t=0;t<12;t++)this.#s()}#s(){
let e=this.#e+this.#r+this.#n++|0;return this.#e=this.#r^this.#r>>>9,this.#r=this.#t+(this.#t<<3)|0,this.#t=(this.#t<<21|this.#t>>>11)+e|0,e>>>0}#o(){return(this.#s()+
.5)/2**32}normals(e){let t=new Float32Array(e);for(let n=0;n<e;n+=2){let[s,o]=[Math.sqrt(-2*Math.log(this.#o())),2*Math.PI*this.#o()];t[n]=s*Math.cos(o),n+1<e&&
(t[n+1]=s*Math.sin(o))}return t}integers(e,t){return Int32Array.from({length:t},()=>Math.floor(this.#o()*e))}permutation(e){return this.choice(e,e)}choice(e,t){
let n=Int32Array.from({length:e},(s,o)=>o);for(let s=0;s<t;s++){let o=s+Math.floor(this.#o()*(e-s));[n[s],n[o]]=[n[o],n[s]]}return n.slice(0,t)}};var T=Math.fround,eu=5,tu=256,wr=class{size;sigma;fixed;#e;constructor(e,t,n,s){[this.size,this.sigma,this.fixed]=[e,n,s],this.#e=t.normals((1+tu)*e);for(let o=0;o<
this.#e.length;o++)this.#e[o]*=T(n)}draw(e,t){let n=t.integers(this.#e.length-this.size+1,e);return Array.from(n,s=>{let o=this.#e.subarray(s,s+this.size);return this.
fixed?o.map((a,i)=>this.fixed[i]?0:a):o})}},kn=class{#e;#r;#t=0;constructor(e){[this.#e,this.#r]=[new Float32Array(e),new Float32Array(e)]}moved(e,t,n){let[s,o,
a]=[.9,.999,T(1e-8)];this.#t+=1;let[i,l]=[T(1-s),T(1-o)],[u,h]=[T(1-s**this.#t),T(1-o**this.#t)];return e.map((c,d)=>{let f=t[d],y=this.#e[d]+=T(i*T(f-this.#e[d])),
p=this.#r[d]+=T(l*T(T(f*f)-this.#r[d])),g=T(T(Math.sqrt(T(T(p)/h)))+a);return T(c+T(T(T(n)*T(T(y)/u))/g))})}};function ru(r){let e=Array.from(r).sort((t,n)=>t-n);
return r.map(t=>(e.indexOf(t)+e.lastIndexOf(t))/(2*(r.length-1))-.5)}var xr=class{genome;groups;#e;#r;#t;#n=[];constructor(e,t,n){[this.genome,this.#r,this.#e,this.#t]=
[e,t,n,new kn(e.length)],this.groups=Int32Array.from({length:n.population},(s,o)=>o%(n.population/2))}get#s(){let{sigma:e,fixed:t}=this.#r,[n,s]=[0,0];return this.
genome.forEach((o,a)=>{t?.[a]||(n+=o*o,s+=1)}),Math.max(e,this.#e.relative_sigma*Math.sqrt(n/s))}ask(e){let[t,n]=[this.#e.population/2,this.genome.length];this.#n=
this.#r.draw(t,e);let s=T(this.#s/this.#r.sigma),o=new Float32Array(2*t*n);return this.#n.forEach((a,i)=>{for(let l=0;l<n;l++){let u=T(s*a[l]);o[i*n+l]=this.genome[l]+
u,o[(t+i)*n+l]=this.genome[l]-u}}),o}tell(e){let[t,n]=[ru(e),this.#n.length],s=new Float32Array(this.genome.length);this.#n.forEach((o,a)=>{let i=T((t[a]-t[n+a])/
(2*n*this.#r.sigma**2));for(let l=0;l<s.length;l++)s[l]+=T(i*o[l])}),this.genome=this.#t.moved(this.genome,s,this.#e.learning_rate)}},At=class{population;groups;#e;#r;#t=new Float64Array(
0);#n=0;constructor(e,t,n){[this.population,this.#r,this.#e]=[e,t,n],this.groups=new Int32Array(n.population)}get genome(){return this.#s(this.#n).slice()}#s(e){
let{size:t}=this.#r;return this.population.subarray(e*t,(e+1)*t)}#o(e,t){let n=this.#e.tournament??eu,s=t.integers(this.#t.length,e*n);return Array.from({length:e},
(o,a)=>s.subarray(a*n,(a+1)*n).reduce((i,l)=>this.#t[l]>this.#t[i]?l:i))}ask(e){if(!this.#t.length)return this.population;let{size:t}=this.#r,{population:n,elites:s}=this.#e,
o=n-s,a=this.#o(o,e);this.#o(o,e);let i=Array.from(this.#t.keys()).sort((u,h)=>this.#t[h]-this.#t[u]).slice(0,s),l=new Float32Array(this.population.length);return[
...i,...a].forEach((u,h)=>l.set(this.#s(u),h*t)),this.#r.draw(o,e).forEach((u,h)=>{let c=(s+h)*t;for(let d=0;d<t;d++)l[c+d]+=u[d]}),this.population=l,l}tell(e){
this.#t=e,this.#n=e.indexOf(Math.max(...e))}};function Ca(r,e,t,n){let[s,o]=[r.length,Math.max(...r)+1],a=o>1?s/o:1,i=Array.from(r.keys()).sort((c,d)=>r[c]-r[d]),l=[],u=[];for(let c=0;c<e;c++){let d=c%a;d===
0&&(u=Array.from(n.permutation(s/a)).flatMap(f=>i.slice(f*a,(f+1)*a))),l.push([i,u.map((f,y)=>u[y-y%a+(y%a-d+a)%a])])}let h=c=>i.map(()=>s+c);for(let c=0;c<t[1];c++)
l.push([i,h(c)]);for(let c=0;c<t[0];c++)l.push([h(c),i]);return{pursuer:Int32Array.from(l.flatMap(([c])=>c)),evader:Int32Array.from(l.flatMap(([,c])=>c)),group:Int32Array.
from(l.flatMap((c,d)=>i.map(f=>d*o+r[f])))}}function ka(r,e,t,n){let s=Math.max(...e)+1,[o,a]=[new Float64Array(t*s),new Float64Array(t*s)];n.forEach((l,u)=>{if(r[u]>=
t)return;let h=r[u]*s+e[u];o[h]+=l,a[h]+=1});let i=o.map((l,u)=>a[u]?l/a[u]:0);return Float64Array.from({length:t},(l,u)=>{let h=i.subarray(u*s,(u+1)*s);return _n(
h)/a.subarray(u*s,(u+1)*s).filter(Boolean).length})}var nu=128,Ze=8;function _n(r){let{length:e}=r;if(e>nu){let d=Math.floor(e/2)-Math.floor(e/2)%Ze;return _n(r.
subarray(0,d))+_n(r.subarray(d))}if(e<Ze)return r.reduce((d,f)=>d+f,0);let t=r.slice(0,Ze),n=e-e%Ze;for(let d=Ze;d<n;d++)t[d%Ze]+=r[d];let[s,o,a,i,l,u,h,c]=t;return r.
subarray(n).reduce((d,f)=>d+f,s+o+(a+i)+(l+u+(h+c)))}var C=["pursuer","evader"],Oe=r=>r==="pursuer"?"evader":"pursuer";var _a=({world:r,fitness:e})=>e.overlap_penalty??(r.rules.teammate==="REACH"?.2:0);var Ar={pursuer:["random","clumsy-fleer"],evader:["random","clumsy-chaser"]},su=20,ou=8,au=-1,Re=r=>Array.from(r).reduce((e,t)=>e+t,0)/r.length,Mr=({world:r,policy:e},t,n)=>({
fov:r.fov,hidden:e.hidden,mask:e.mask==="none"?null:t[n]}),Je=class{settings;archive={pursuer:[],evader:[]};rows=[];cells=new Map;counters=[];#e;#r;#t;#n={};#s=new Set;#o=0;#u=0;#d=0;constructor(e,t,n,s=Ta(
t.seed)){[this.#e,this.settings,this.#r,this.#t]=[e,t,n,s];for(let o of C){let{initial_weight:a,initial_head:i}=t.policy,l=s("initial",C.indexOf(o)),u=t.learner.
kind==="ga"?t.learner.population:1,h=Array.from({length:u},()=>wa(this.shape(o),l,a,i));this.#m(o,h),this.archive[o].push(this.#n[o].genome)}this.#b()}shape(e){
return Mr(this.settings,this.#r,e)}get finished(){return Math.min(this.archive.pursuer.length,this.archive.evader.length)}*run(){yield*this.#S(0);for(let e=1;e<=
this.settings.schedule.generations;e++){if(this.settings.schedule.kind==="alternating")for(let t of C)yield*this.#h(t,e);else yield*this.#l(e);this.#b(),yield*this.#S(
e)}}change(e){let t=this.settings,n={pursuer:this.shape("pursuer"),evader:this.shape("evader")},s=l=>JSON.stringify(l(t))===JSON.stringify(l(e));this.settings=e;
let o=s(l=>[l.world.fov,l.policy]);if(!o||!s(l=>l.learner))for(let l of C){let u=h=>xa(h,n[l],this.shape(l));this.archive[l]=this.archive[l].map(u),this.#m(l,this.#a(
l).map(u))}if(o&&s(l=>l.world))return null;this.cells.clear(),this.#s.clear();let{pursuer:a,evader:i}=this.archive;return{type:"anew",settings:e,genomes:{pursuer:a.
slice(0,this.finished),evader:i.slice(0,this.finished)}}}#a(e){let t=this.#n[e];if(!(t instanceof At))return[t.genome];let n=t.genome.length,s=Array.from({length:t.
population.length/n},(o,a)=>t.population.slice(a*n,(a+1)*n));return Array.from({length:this.settings.learner.population},(o,a)=>a===0?t.genome:s[a%s.length])}#m(e,t){
let{learner:n}=this.settings,[s,o]=[this.shape(e),n.kind==="ga"?n.mutation:n.sigma],a=Sn(s),i=new wr(Ke(s),this.#t("noise",C.indexOf(e)),o,a?.fixed??null),l=t.map(
u=>An(u,a));this.#n[e]=n.kind==="ga"?new At(Sr(l),i,n):new xr(l[0],i,n)}*#h(e,t){for(let n=0;n<this.#i(e);n++){let s=this.archive[Oe(e)].length,o=this.settings.
schedule[`${e}s_meet`].rule,a=o==="latest"?s-1:o==="round-robin"?n%s:this.#t("opponents",C.indexOf(e),t,n).choice(s,1)[0],i=e==="pursuer"?[t,a]:[a,t],l=this.#n[e],
{groups:u}=l,h=St([this.settings.seed,...i,En[e],n],Math.max(...u)+1),c=l.ask(this.#t("learn",C.indexOf(e),t,n)),[d,f]=[Int32Array.from(u.keys()),new Int32Array(
u.length)],y={[e]:c,[Oe(e)]:this.archive[Oe(e)][a]},p={[e]:d,[Oe(e)]:f},g=this.#g(y,p,BigUint64Array.from(u,x=>h[x])),v=this.#v(g,e);this.#x(g,v,{generation:t,team:e,
epoch:n,opponent:a}),l.tell(v),yield*this.#c(t,n,e)}this.archive[e].push(this.#n[e].genome)}*#l(e){for(let t=0;t<this.#i("pursuer");t++){let{schedule:n,learner:{
population:s}}=this.settings,[o,a]=n.kind==="hall-of-fame"?[n.hall_sample,n.contemporaries]:[0,1],i={pursuer:this.#f("pursuer",e,t),evader:this.#f("evader",e,t)},
l=this.#t("opponents",0,e,t),u={pursuer:this.#p(o,l),evader:this.#p(o,l)},h=g=>Sr([i[g],...Array.from(u[Oe(g)],v=>this.archive[g][v])]),c=[u.evader.length,u.pursuer.
length],d=Ca(this.#n.pursuer.groups,a,c,l),f=St([this.settings.seed,e,e,En.both,t],Math.max(...d.group)+1),y={pursuer:h("pursuer"),evader:h("evader")},p=this.#g(
y,d,BigUint64Array.from(d.group,g=>f[g]));for(let g of C){let v=ka(d[g],d[Oe(g)],s,this.#v(p,g));this.#x(p,v,{generation:e,team:g,epoch:t,opponent:au}),this.#n[g].
tell(v)}yield*this.#c(e,t,"both")}for(let t of C)this.archive[t].push(this.#n[t].genome)}#f(e,t,n){return this.#n[e].ask(this.#t("learn",C.indexOf(e),t,n))}#p(e,t){
let n=this.archive.pursuer.length;return e?t.choice(n,Math.min(e,n)):new Int32Array(0)}#i(e){let{schedule:t}=this.settings;return t.kind==="hall-of-fame"?t.joint_epochs:
t[`${e}_epochs`]}*#c(e,t,n){let[s,o]=this.settings.schedule.kind==="hall-of-fame"?[this.#i("pursuer"),0]:[this.#i("pursuer"),this.#i("evader")],a=t+1+(n==="evad\
er"?s:0),i=s+o;yield{type:"epoch",done:(e-1)*i+a,of:this.settings.schedule.generations*i},yield*this.catchUp()}#g(e,t,n){let s={...this.settings.world,max_steps:this.
settings.train_steps},o=this.#e.rollouts(s,this.#y("pursuer",e.pursuer),this.#y("evader",e.evader),{...t,seed:n},1);this.#o+=o.length.length;for(let a of o.length)
this.#u+=Number(a);for(let a of o.agent_steps)this.#d+=Number(a);return o}#y(e,t){return xt(this.shape(e),t)}#v({captured_fraction:e,overlap:t},n){let s=_a(this.
settings);return Float64Array.from(e,(o,a)=>n==="pursuer"?o:1-o-s*Number(t[2*a+1]))}#x(e,t,n){let s=Re(t),o=[0,0];e.faults.forEach((a,i)=>o[Math.floor(i/3)%2]+=
Number(a)),this.rows.push({...n,fitness_mean:s,fitness_std:Math.sqrt(Re(t.map(a=>(a-s)**2))),fitness_best:Math.max(...t),capture_rate:Re(e.capture_rate),length:Re(
e.length),pursuer_faults:o[0]/e.length.length,evader_faults:o[1]/e.length.length,matches:this.#o,steps:this.#u})}#b(){this.counters.push({matches:this.#o,steps:this.#u,
agent_steps:this.#d})}*#S(e){yield{type:"generation",number:e,genomes:{pursuer:this.archive.pursuer[e],evader:this.archive.evader[e]}},yield*this.catchUp()}*catchUp(){
for(let e=this.finished-1;e>=0;e--){for(let t=e;t>=0;t--)for(let[n,s]of t===e?[[e,e]]:[[e,t],[t,e]]){if(this.cells.has(`${n} ${s}`))continue;let o=this.#w(n,s);
this.cells.set(`${n} ${s}`,o),yield{type:"cell",cell:o}}this.#s.has(e)||(this.#s.add(e),yield{type:"scores",number:e,scores:{pursuer:this.#A("pursuer",e),evader:this.#A(
"evader",e)}})}}#w(e,t){let{world:n,evaluation_episodes:s,seed:o}=this.settings,a={pursuer:new Int32Array(1),evader:new Int32Array(1),seed:BigUint64Array.of(br(
o,e,t))},i=C.map(h=>this.#y(h,this.archive[h][h==="pursuer"?e:t])),l=this.#e.rollouts(n,...i,a,s),u=h=>{let c=Array.from(l[h],Number),d=c.length/s;return Array.
from({length:d},(f,y)=>Re(c.filter((p,g)=>g%d===y)))};return{pursuer:e,evader:t,capture_rates:Array.from(l.capture_rate),lengths:Array.from(l.length),means:{collisions:u(
"collisions"),faults:u("faults"),agent_steps:u("agent_steps"),survivors:u("survivors")}}}#A(e,t){let{world:n,seed:s}=this.settings,[o,a]=[this.#y(e,this.archive[e][t]),
new Int32Array(1)];return Re(Ar[e].map((i,l)=>{let u=St([s,C.indexOf(e),l,ou],1),h=e==="pursuer"?[o,i]:[i,o],c=Re(this.#e.rollouts(n,...h,{pursuer:a,evader:a,seed:u},
su).capture_rate);return e==="pursuer"?c:1-c}))}};function Sr(r){let e=new Float32Array(r.reduce((n,{length:s})=>n+s,0)),t=0;for(let n of r)e.set(n,t),t+=n.length;
return e}var On=r=>Array.from({length:r},()=>Array(r)),Rn=r=>r.length?r.reduce((e,t)=>e+t,0)/r.length:null,Er=class{learning=C;settings=[];training={capture_rate:[],generation:[],
learner:[],epochs:1,window:1,matches:0};limits="";name;schedule;seed;seeds;world;payoff;teams;findings=null;genomes={pursuer:[],evader:[]};#e;#r;#t;constructor(e,t,n,s){
[this.#t,this.#e,this.#r,this.name,this.schedule]=[e,t,s,n,n],[this.world,this.seed]=[e.world,String(e.seed)];let o=e.schedule.generations+1;this.seeds=Array.from(
{length:o},(a,i)=>Array.from({length:o},(l,u)=>String(br(e.seed,i,u)))),this.payoff=this.#n(),this.teams=this.#s()}get newest(){return this.genomes.pursuer.length-
1}#n(){let e=this.#t.schedule.generations+1;return{first:[0,0],shape:[e,e],episodes:this.#t.evaluation_episodes,capture_rate:On(e),capture_rates:On(e),lengths:On(
e)}}#s(){let e=t=>{let n=`${this.#r} ${t}`;Ms(n,Sr(this.genomes[t]));let{genome:s,...o}=xt(Mr(this.#t,this.#e,t),this.genomes[t][0]??new Float32Array(0));return{
script:null,network:{...o,genome_size:s.length},kept:[...this.genomes[t].keys()],genomes:n}};return{pursuer:e("pursuer"),evader:e("evader")}}policy(e,t){return xt(
Mr(this.#t,this.#e,e),this.genomes[e][t])}add(e){for(let t of C)this.genomes[t].push(e[t]);this.teams=this.#s()}change(e,t){this.#t=e,this.world=e.world;for(let n of C)
this.genomes[n]=[...t[n]];[this.payoff,this.teams,this.findings]=[this.#n(),this.#s(),null]}addCell({pursuer:e,evader:t,capture_rates:n,lengths:s}){this.payoff.
capture_rate[e][t]=Rn(n),this.payoff.capture_rates[e][t]=[...n],this.payoff.lengths[e][t]=[...s],this.findings={generalization:this.#o()}}#o(){let e=this.payoff.
capture_rate,t=o=>({mean:o,low:null,high:null}),n=o=>o.filter(a=>a!==void 0),s=[...this.genomes.pursuer.keys()];return{pursuers:t(s.map(o=>Rn(n(e[o])))),evaders:t(
s.map(o=>Rn(n(e.map(a=>a[o])).map(a=>1-a))))}}};var Pn=r=>r.reduce((e,t)=>e+t,0)/r.length,Oa=(r,e)=>e==="pursuer"?r:r[0].map((t,n)=>r.map(s=>1-s[n])),Ra=(r,e)=>Pn(Oa(r,e).at(-1));function Pa(r,e){let t=[],n=Oa(
r,e).map(s=>Pn(s.map((o,a)=>(t[a]=Math.max(t[a]??0,o),t[a]-o))));return Pn(n.slice(Math.floor(n.length/2)))}var Mt=r=>`${Math.round(100*r)} %`,iu=100,lu=0,Tr=class extends EventTarget{element;newest;beginning;settings;state="waiting";done=0;seconds=0;#e;#r;#t;#n=m("h2",
{class:"lane-title"});#s=m("p",{class:"facts numbers"});#o=m("div",{class:"lane-room",hidden:!0});#u=m("section",{class:"card measures",hidden:!0});#d=m("div");#a;#m={
pursuer:[],evader:[]};#h=new Map;#l;#f;#p=()=>{};#i=0;#c=!0;#g=0;#y=null;constructor(e,t,n,s){super(),[this.#e,this.#r,this.#t,this.settings]=[e,t,n,s],this.newest=
new bt(()=>this.#A(this.#a.newest)),this.beginning=new bt(()=>this.#A(0)),this.beginning.element.classList.add("beginning");let o=m("div",{class:"boards"},this.
newest.element,this.beginning.element);this.element=m("section",{class:"lane"},this.#n,this.#s,o,this.#o,this.#u,this.#d),n.onmessage=({data:a})=>this.#x(a),this.
reset(s)}reset(e){this.#v({type:"stop"}),[this.settings,this.state,this.done]=[e,"waiting",0],this.#w();let{archive:t}=new Je(this.#r,e,this.#e.masks);this.#a.add(
{pursuer:t.pursuer[0],evader:t.evader[0]}),this.#o.hidden=this.#u.hidden=!0,this.#E(!0),this.#M()}start(){this.#w(),[this.state,this.done]=["evolving",0],this.#o.
hidden=!1,this.#u.hidden=!0,this.#v({type:"start",settings:this.settings,masks:this.#e.masks}),this.#M()}stop(){this.#v({type:"stop"}),this.state==="evolving"&&
(this.state="stopped"),this.#M()}change(e){if(this.state==="waiting")return this.reset(e);this.settings=e,this.#v({type:"change",settings:e}),this.#M()}takeOver(){
let e=this.#a.newest;this.#f.play({run:0,pursuer:e,evader:e,episode:0,seed:null},{seat:this.#a.world.n_pursuers,from:0,moves:[]})}saved(){return new Promise(e=>{
this.#y=e,this.#v({type:"save"})})}get newestGeneration(){return this.#a.newest}close(){this.#t.terminate(),this.newest.runs=this.beginning.runs=!1}#v(e){this.#t.
postMessage(e)}#x(e){if(e.type==="generation"){if(this.state!=="evolving")return;this.#a.add(e.genomes),this.#E(e.number===0)}else if(e.type==="cell"){let{pursuer:t,
evader:n}=e.cell;this.#a.addCell(e.cell),this.#c&&t===n&&t===this.#a.newest&&this.#l.select({pursuer:t,evader:n}),this.#h.set(`${t} ${n}`,e.cell)}else if(e.type===
"scores")for(let t of C)this.#m[t][e.number]=e.scores[t];else e.type==="anew"?(this.#a.change(e.settings,e.genomes),this.#S(),this.#E(!0)):e.type==="epoch"?this.
done=e.done/e.of:e.type==="end"?(this.state==="evolving"&&([this.state,this.seconds,this.done]=["ended",e.seconds,1]),this.#C()):e.type==="saved"?this.#y?.(e.race):
(this.#s.textContent=`The race failed: ${e.message}`,this.state="stopped");this.#g||(this.#g=setTimeout(()=>requestAnimationFrame(()=>this.#b()),iu))}#b(){this.#g=
0,this.#l.dispatchEvent(new Event("run")),this.#p(),this.#M()}#S(){this.#h=new Map,this.#m={pursuer:[],evader:[]},this.#u.hidden=!0}#w(){let e=`race ${lu++}`,t=Dt(
this.settings);this.#a=new Er(this.settings,this.#e.masks,t,e),this.#S(),this.#c=!0,this.#l=new mr({run:0,pursuer:0,evader:0,episode:0,seed:null});let[n,s]=[new dr(
[this.#a],this.#l),new ur([this.#a],this.#l,null)];n.element.ariaLabel=`Payoff matrix. ${t}`,this.#f=new vr([this.#a],this.#l,s,!1),this.#f.start(this.#r);let o=m(
"dialog",{class:"of-cell-match","aria-label":"Match"},m("button",{type:"button",class:"leave",onclick:()=>o.close()},"Close"),s.element);o.addEventListener("clo\
se",()=>s.player.pause());let a=!1;n.element.addEventListener("play",()=>{let{pursuer:l,evader:u}=this.#l.selected;this.#c=!1,this.#a.payoff.capture_rate[l][u]!==
void 0&&(o.showModal(),a||s.start(this.#r),a=!0,s.playSoon())});let i=Is(`Scores against scripts, by generation: ${Ar.pursuer.join(", ")} and ${Ar.evader.join("\
, ")}`,(l,u)=>{let h=this.settings.schedule.generations,c=Ls(l,u,{low:0,high:h,label:"generation",whole:!0},{low:0,high:1,label:"score"});for(let d of C){let f=Array.
from(this.#m[d],y=>y??null);$s(c,[...f.keys()],f,`of-${d}s`)}return c},()=>{},l=>{let u=Math.min(this.#a.newest,Math.max(0,Math.round(l)));this.#l.select({pursuer:u,
evader:u})});this.#p=i.redraw,this.#o.replaceChildren(n.element,m("section",{class:"card scores"},m("h3",{},"Against opponents that never change"),m("p",{class:"\
small muted"},"Captures of random walkers and of clumsy fleers; escapes from random walkers and from clumsy chasers."),Ns(["pursuers","of-pursuers"],["evaders",
"of-evaders"]),i.element)),this.#d.replaceChildren(o,this.#f.dialog)}#A(e){let t=this.#a.newest;if(t<0||e<0)return null;let{world:n,payoff:s,seeds:o}=this.#a,a=this.#i++%
s.episodes;this.newest.title.textContent=t?"Newest against newest":"Generation 0: nobody has learned anything yet",this.beginning.title.textContent="Generation \
0 pursuers, newest evaders";for(let u of[this.newest,this.beginning])u.generation=t;for(let u of[this.newest,this.beginning])u.label=`A match. ${u.title.textContent}`;
let[i,l]=[this.#a.policy("pursuer",e),this.#a.policy("evader",t)];return this.#r.match(n,i,l,BigInt(o[e][t]),a)}#E(e){this.newest.renew(e),(this.#a.newest>0||this.
state!=="waiting")&&this.beginning.renew(e)}#M(){this.element.dataset.state=this.state,this.#n.textContent=Dt(this.settings);let e=this.#h.get(`${this.#a.newest}\
 ${this.#a.newest}`)??this.#h.get(`${this.#a.newest-1} ${this.#a.newest-1}`),t=e?[`Generation ${this.#a.newest} of ${this.settings.schedule.generations}`,`the n\
ewest pursuers catch ${Mt(e.capture_rates.reduce((n,s)=>n+s,0)/e.capture_rates.length)} of the newest evaders`,`${uu(e).toFixed(0)} collisions in 1000 moves`]:[];
this.#s.replaceChildren(...t.map(n=>m("span",{},n))),this.dispatchEvent(new Event("state"))}#C(){this.#u.ariaLabel=`What came out. ${Dt(this.settings)}`;let e=this.#a.
payoff.capture_rate.slice(0,this.#a.newest+1).map(n=>n.slice(0,this.#a.newest+1));if(e.length<2||e.some(n=>Array.from(n).includes(void 0)))return;let t=[["Score\
 against scripts: generation 0",n=>Mt(this.#m[n][0]??0)],["Score against scripts: newest generation",n=>Mt(this.#m[n].at(-1)??0)],["Newest generation against al\
l generations of the other team",n=>Mt(Ra(e,n))],["Below its own best so far, in the later half (forgetting)",n=>Mt(Pa(e,n))]];this.#u.replaceChildren(m("h3",{},
"What came out"),m("table",{class:"numbers"},m("thead",{},m("tr",{},m("td"),...C.map(n=>m("th",{scope:"col",class:n},`${n}s`)))),m("tbody",{},...t.map(([n,s])=>m(
"tr",{},m("th",{scope:"row"},n),...C.map(o=>m("td",{},s(o))))))),m("p",{class:"small muted"},"These are measures without a verdict: one race proves little. Save\
 it, and ",m("code",{},"matrixworld judge")," weighs luck and says what happened.")),this.#u.hidden=!1}};function uu({means:{faults:r,agent_steps:e}}){let t=n=>n.
reduce((s,o)=>s+o,0);return 1e3*t(r)/Math.max(1,t(e))}function La(r,e){let t=[];for(let n=2;t.length<r;n++)t.every(s=>n%s)&&t.push(n);return Int32Array.from(t,n=>e(n)%1*2**32)}var ce=(r,e)=>r>>>e|r<<32-e;function Cr(r){
let e=La(64,Math.cbrt),t=La(8,Math.sqrt),n=new Uint8Array(Math.ceil((r.length+9)/64)*64);n.set(r),n[r.length]=128;let s=new DataView(n.buffer);s.setBigUint64(n.
length-8,BigInt(r.length)*8n);let o=new Int32Array(64);for(let a=0;a<n.length;a+=64){for(let p=0;p<16;p++)o[p]=s.getInt32(a+4*p);for(let p=16;p<64;p++){let[g,v]=[
o[p-15],o[p-2]],x=ce(g,7)^ce(g,18)^g>>>3,b=ce(v,17)^ce(v,19)^v>>>10;o[p]=o[p-16]+x+o[p-7]+b}let[i,l,u,h,c,d,f,y]=t;for(let p=0;p<64;p++){let g=y+(ce(c,6)^ce(c,11)^
ce(c,25))+(c&d^~c&f)+e[p]+o[p]|0,v=(ce(i,2)^ce(i,13)^ce(i,22))+(i&l^i&u^l&u)|0;[y,f,d,c,h,u,l,i]=[f,d,c,h+g|0,u,l,i,g+v|0]}[i,l,u,h,c,d,f,y].forEach((p,g)=>t[g]+=
p)}return Array.from(t,a=>(a>>>0).toString(16).padStart(8,"0")).join("")}function kr(r){return Array.isArray(r)?`[${r.map(kr).join(", ")}]`:typeof r!="object"||r===null?JSON.stringify(r):`{${Object.entries(r).sort(([t],[n])=>t<n?-1:1).
map(([t,n])=>`${JSON.stringify(t)}: ${kr(n)}`).join(", ")}}`}var $a="sha256:",cu=64;function Na(r,e){let t=yr(r),[n,s]=[ne(e),$a.length+cu],o=new Uint8Array(n.length+
t.length);o.set(n),o.set(t,n.length),o.set([s&255,s>>8],o.length-2);let a=ne($a+Cr(o)),i=new Uint8Array(t.length+a.length);return i.set(o.subarray(n.length)),i.
set(a,t.length),i}function Ia(r,e=""){return ne(JSON.stringify({...r,sha256:Cr(ne(e+kr(r)))},null,2))}var Ln=(r,...e)=>({dtype:"<f8",shape:e,data:Float64Array.from(
r)}),Et=r=>r.reduce((e,t)=>e+t,0)/r.length,Fa=r=>Math.sqrt(Et(r.map(e=>(e-Et(r))**2))),hu=["generation","team","epoch","opponent","fitness_mean","fitness_std","\
fitness_best","capture_rate","length","pursuer_faults","evader_faults","matches","steps"];function du({archive:r,rows:e,counters:t},n){let s=e.filter(({generation:i})=>i===
n),o=ne(s.map(i=>`${[n,...hu.map(l=>i[l])].join(",")}
`).join("")),a=i=>({dtype:"<f4",shape:[1,r[i][n].length],data:r[i][n]});return{pursuers:a("pursuer"),evaders:a("evader"),log:{dtype:`|S${Math.max(1,o.length)}`,
shape:[],data:o.length?o:new Uint8Array(1)},...Object.fromEntries(Object.entries(t[n]).map(([i,l])=>[i,Ln([l])])),...n?{capture_rate:Ln([Et(s.slice(Math.floor(s.
length/2)).map(i=>i.capture_rate))])}:{}}}function mu(r){let e=r.finished,t=Array.from({length:e*e},(o,a)=>r.cells.get(`${Math.floor(a/e)} ${a%e}`)),n=t[0].lengths.
length,s=(o,...a)=>Ln(t.flatMap(o),e,e,...a);return{capture_rates:{dtype:"<f4",shape:[e,e,n],data:Float32Array.from(t.flatMap(({capture_rates:o})=>o))},lengths:{
dtype:"<i4",shape:[e,e,n],data:Int32Array.from(t.flatMap(({lengths:o})=>o))},collisions:s(({means:o})=>o.collisions,2,3),faults:s(({means:o})=>o.faults,2,3),agent_steps:s(
({means:o})=>o.agent_steps,2),pursuer_survivors:s(({means:o})=>o.survivors[0]),evader_survivors:s(({means:o})=>o.survivors[1]),capture_rate:s(({capture_rates:o})=>Et(
o)),capture_rate_std:s(({capture_rates:o})=>Fa(o)),length:s(({lengths:o})=>Et(o)),length_std:s(({lengths:o})=>Fa(o))}}function pu(r,{format:e,version:t}){let n=r.
finished-1,s={...r.settings,schedule:{...r.settings.schedule,generations:n}},o={format:e,matrixworld:t,settings:s,drawn_by:"page"},a=f=>`${Cr(ne(kr(o)))}/${f}`,
i=Array.from({length:r.finished},(f,y)=>`stage-${String(y).padStart(4,"0")}.npz`),{matches:l,steps:u,agent_steps:h}=r.counters[n],d={stages:n,...{training_matches:l,
training_steps:u,training_agent_steps:h},disengagement:[],evaluation_matches:r.finished**2*r.settings.evaluation_episodes};return{"config.json":Ia(o),...Object.
fromEntries(i.map((f,y)=>[f,Na(du(r,y),a(f))])),"payoff.npz":Na(mu(r),a("payoff.npz")),"summary.json":Ia(d,a("summary.json"))}}function Ua(r,e){let t=r.flatMap(
({name:n,race:s})=>Object.entries(pu(s,e)).map(([o,a])=>[r.length>1?`${n}/${o}`:o,a]));return Ft(Object.fromEntries(t))}var Da=r=>r.finished>1&&r.cells.size>=r.
finished**2&&C.every(e=>r.archive[e].length);var fu=12;function za(r){let e=new Blob([we("script-engine"),`
`,we(`script-${r}`)],{type:"text/javascript"});return new Worker(URL.createObjectURL(e))}function Wa(){let r=h=>postMessage(h),e=Pt(),t=null,n=null,s=0,o=!1,a=new MessageChannel,
i=()=>{let h=performance.now()+fu;for(;n&&performance.now()<h;){let{value:c,done:d}=n.next();d?(n=null,r({type:"end",seconds:(performance.now()-s)/1e3})):r(c)}!n||
o||(o=!0,a.port2.postMessage(null))},l=async h=>{if(h.type==="start")t=new Je(await e,h.settings,h.masks),[n,s]=[t.run(),performance.now()],i();else if(h.type===
"stop")n=null;else if(h.type==="change"){let c=t?.change(h.settings);if(c&&r(c),!t||!c||n)return;n=t.catchUp(),i()}else if(t){let{settings:c,archive:d,rows:f,cells:y,
counters:p,finished:g}=t;r({type:"saved",race:{settings:c,archive:d,rows:f,cells:y,counters:p,finished:g}})}},u=h=>{Promise.resolve().then(h).catch(c=>{n=null,r(
{type:"failed",message:String(c)})})};a.port1.onmessage=()=>{o=!1,u(i)},globalThis.onmessage=({data:h})=>u(()=>l(h))}var yu=250,$n=class{#e;#r;lanes=[];#t=m("div",{class:"lanes"});#n=m("button",{type:"button",class:"evolve",onclick:()=>this.#x()});#s=m("progress",{max:1,value:0,
"aria-label":"Progress of the race"});#o=m("p",{class:"small muted numbers",role:"status"});#u=m("button",{type:"button",class:"side",title:"A second race of th\
e same seed with another schedule",onclick:()=>this.#S()},"Side by side");#d=m("button",{type:"button","aria-pressed":"false",title:"Drag over the board to draw\
 walls, and over walls to remove them",onclick:()=>this.#E()},"Draw walls");#a=m("button",{type:"button",onclick:()=>this.#w({walls:[]})},"No walls");#m=m("butt\
on",{type:"button",onclick:()=>this.#M()});#h=m("input",{type:"text",readonly:!0,hidden:!0,"aria-label":"Link to this race"});#l=m("span",{class:"small muted",role:"\
status"});#f=_s((e,t)=>this.#w(e,t));#p=m("button",{type:"button",onclick:()=>{this.#_()},title:"An archive that matrixworld judge, explore and replay read"},"S\
ave");#i=[];#c;#g=0;constructor(e,t){[this.#e,this.#r,this.#c]=[e,t,ks(e,location.hash)];let n=m("div",{class:"tools",role:"group","aria-label":"What can be don\
e"},this.#u,m("button",{type:"button",class:"to-play",title:"Play an evader against the newest pursuers",onclick:()=>this.lanes[0].takeOver()},"Take over"),this.#d,
this.#a,this.#m,this.#p,m("button",{type:"button",class:"to-link",onclick:()=>this.#k()},"Link"),this.#h,this.#l);document.getElementById("page").replaceWith(m(
"header",{class:"top"},m("div",{},m("h1",{},"Evolve a chase"),m("p",{class:"lead"},"Triangles chase discs. Nobody has told either team how. Press Evolve, and bo\
th learn by trial and error, against each other.")),us()),m("main",{},m("div",{class:"start"},this.#n,n,m("div",{class:"progress"},this.#s,this.#o)),this.#f.now,
this.#t,this.#f.anew,m("div",{class:"card below"},$t(),m("p",{class:"small muted"},"The page plays and learns with the engine of matrixworld, in this browser; n\
othing is sent."),m("p",{class:"small muted of-saving"},"A saved race is an archive: ",m("code",{},"matrixworld judge"),", ",m("code",{},"explore")," and ",m("c\
ode",{},"replay")," read it. Python plays its matches again, and does not continue it."))),m("footer",{class:"muted small"},`matrixworld ${e.version}`)),this.#v(),
this.#C()}#y(){return[this.#c.schedule,...this.#c.beside?[this.#c.beside]:[]]}#v(){for(let e of this.lanes.splice(0))e.close();for(let e of this.#y()){let t=new Tr(
this.#e,this.#r,za("evolve"),jt(this.#e,this.#c,e));t.addEventListener("state",()=>this.#T()),this.lanes.push(t)}this.#i=this.lanes.map(e=>e.newest.drawWalls(([
t,n],s)=>this.#A(t,n,s))),this.#d.ariaPressed="false",this.#t.dataset.count=String(this.lanes.length),this.#t.replaceChildren(...this.lanes.map(({element:e})=>e)),
this.#f.show(this.#c),this.#T()}#x(){this.lanes.some(({state:e})=>e==="evolving")?this.lanes.forEach(e=>e.stop()):this.#b()}#b(){this.#l.textContent="";for(let[
e,t]of this.#y().entries()){let n=this.lanes[e];n.settings=jt(this.#e,this.#c,t),n.start()}}#S(){let e=this.#c.schedule==="specialist-specialist"?"generalist-ge\
neralist":"specialist-specialist";this.#w({beside:this.#c.beside?null:e},!0)}#w=(e,t=!1)=>{let n=this.#y().length,s=this.lanes.every(({state:o})=>o==="waiting");
this.#c={...this.#c,...e},this.#f.show(this.#c),this.#h.hidden=!0,this.#l.textContent="",this.#y().length!==n&&this.#v(),t&&!s?this.#b():this.#y().forEach((o,a)=>this.
lanes[a].change(jt(this.#e,this.#c,o)))};#A(e,t,n){let{rows:s,cols:o}=this.lanes[0].settings.world,a=an(this.#c.walls,e*o+t,n,s*o);this.#c={...this.#c,walls:a};
let i=Uint8Array.from({length:s*o},(l,u)=>Number(a.includes(u)));for(let l of this.lanes)l.newest.show(i);clearTimeout(this.#g),this.#g=setTimeout(()=>this.#w({
walls:a}),yu)}#E(){let e=this.#d.ariaPressed!=="true";this.#d.ariaPressed=String(e);for(let t of this.#i)t.active(e)}#M(){let e=!this.lanes[0].newest.runs;for(let{
newest:t,beginning:n}of this.lanes)t.runs=n.runs=e;this.#C()}#C(){this.#m.textContent=this.lanes[0].newest.runs?"Pause boards":"Play boards"}#T(){if(!this.lanes.
length)return;let e=this.lanes.map(({state:a})=>a),t=e.includes("evolving");document.body.dataset.state=e.every(a=>a==="waiting")?"waiting":t?"evolving":"ended",
this.#n.textContent=t?"Stop":e[0]==="waiting"?"Evolve":"Again",this.#u.ariaPressed=String(this.lanes.length>1),this.#a.hidden=!this.#c.walls.length,this.#s.value=
Math.min(...this.lanes.map(({done:a})=>a));let n=Math.max(...this.lanes.map(a=>a.seconds)),s=e.every(a=>a==="ended"),{seed:o}=this.#c;this.#o.textContent=t?`See\
d ${o}: generation ${this.lanes.map(a=>a.newestGeneration).join(" and ")}`:s?`Seed ${o}: the race took ${n.toFixed(1)} seconds.`:e.includes("stopped")?"Stopped.":
""}#k(){Lt()&&(this.#h.hidden=!1,this.#h.value=`${location.href.split("#")[0]}#${Cs(this.#c)}`,ls(this.#h,this.#l))}async#_(){let e=await Promise.all(this.lanes.
map(async o=>({name:Ee(o.settings),race:await o.saved()})));if(!e.every(({race:o})=>Da(o))){this.#l.textContent="Wait for the next generation, and save then.";return}
let t=Ua(e,{format:this.#e.format,version:this.#e.version}),n=new Blob([t],{type:"application/zip"}),s=`${e.map(o=>o.name).join("-and-")}-seed-${this.#c.seed}.z\
ip`;m("a",{href:URL.createObjectURL(n),download:s}).click(),this.#l.textContent=`Saved as ${s}.`}};async function gu(){let r=new $n(Ts(),await Pt());document.addEventListener(
"keydown",({key:e,target:t,ctrlKey:n,metaKey:s,altKey:o})=>{let a=t instanceof HTMLInputElement||t instanceof HTMLSelectElement||document.querySelector("dialog[\
open]");e.toLowerCase()==="d"&&!a&&!n&&!s&&!o&&Br()}),window.addEventListener("hashchange",()=>location.reload()),Object.assign(window,{matrixworldEvolve:r})}typeof document>
"u"?Wa():gu().catch(r=>{throw(document.getElementById("page")??document.body).append(m("p",{class:"card problem",role:"alert"},`The page could not start: ${String(
r)}`)),r}).finally(()=>{document.body.dataset.ready="true"});})();
