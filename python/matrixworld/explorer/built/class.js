/* built from web/ by "npm run build"; sources 4cc5c38583d400ea1ee95effd07cffa02a1e77ffeb84596e61ef09204fe6d66d */
"use strict";(()=>{var G=[.5,1,2,4,8,16,32,64],re=0,ne=12,gr=2,te=class extends EventTarget{#e;#r;#n;#t=0;#o=0;#s=!1;#a=null;#l=0;#c=[];#d=[];glide=.28;constructor(e,r={}){super(),
this.#e=e,this.#r=r.speed??4,this.#n=r.still??!1}get step(){return this.#t}get time(){return this.#n?this.#t:this.#o}get arrived(){return this.#o===this.#t}get playing(){
return this.#s}get length(){return this.#e}set length(e){this.#e=e,this.#t>e&&this.jump(e),this.#i("state")}get marks(){return this.#c}set marks(e){this.#c=e,this.#i(
"state")}get ticks(){return this.#d}set ticks(e){this.#d=e,this.#i("state")}get pace(){return this.#r||Math.max(gr,this.#e/ne)}get speed(){return this.#r}set speed(e){
this.#r=e,this.#i("state")}changeSpeed(e){let r=G.findIndex(n=>n>=this.pace);this.speed=G[Math.min(G.length-1,Math.max(0,r+e))]}play(){this.#s||!this.#e||(this.#t===
this.#e&&this.jump(0),this.#s=!0,this.#i("state"),this.#m())}pause(){this.#s&&(this.#s=!1,this.#i("state"))}toggle(){this.#s?this.pause():this.play()}move(e){this.
pause();let r=Math.min(this.#e,Math.max(0,this.#t+e));Math.abs(r-this.#o)>1?this.jump(r):this.#u(r),this.#m()}jump(e){this.#o=Math.min(this.#e,Math.max(0,Math.round(
e))),this.#u(this.#o),this.#i("frame")}#u(e){e!==this.#t&&(this.#t=e,this.#i("step"),this.#n&&this.#i("frame"))}#m(){this.#a===null&&(this.#l=performance.now(),
this.#a=requestAnimationFrame(()=>this.#h()))}#h(){this.#a=null;let e=performance.now();this.#p(Math.min(.25,(e-this.#l)/1e3)),this.#l=e,(!this.#n||this.arrived)&&
this.#i("frame"),(this.#s||this.#o!==this.#t)&&(this.#a=requestAnimationFrame(()=>this.#h()))}#p(e){let r=e;for(;r>0;){if(this.#o===this.#t){if(!this.#s)return;
if(this.#t===this.#e)return this.pause();this.#u(this.#t+1)}let n=this.#s?this.pace:1/this.glide,o=this.#t-this.#o,s=Math.min(Math.abs(o),r*n);r-=s/n,this.#o=s===
Math.abs(o)?this.#t:this.#o+Math.sign(o)*s}this.#s&&this.#o===this.#e&&this.pause()}#i(e){this.dispatchEvent(new Event(e))}};function oe(t,e){if(e.ctrlKey||e.metaKey||
e.altKey)return!1;let r=e.shiftKey?10:1,o={" ":()=>t.toggle(),ArrowRight:()=>t.move(r),ArrowLeft:()=>t.move(-r),Home:()=>t.move(-t.length),End:()=>t.move(t.length),
"+":()=>t.changeSpeed(1),"-":()=>t.changeSpeed(-1)}[e.key];return o?.(),o!==void 0}var He={SIMULTANEOUS:0,SWARM_TURNS:1,AGENT_TURNS:2},z={DISAPPEAR:0,REACH:1,BOUNCE:2},Be={OCCUPATION:0,SURROUND:1},Ge={FAULT:0,INVOLVED:1};var ze=["obstacle","teammate","adversary"],we=["vertex","edge","chain"],je=["turn","kind","form","first","second","row","col","at_fault","held","doomed"],ve=["p\
ursuer_{number}","evader_{number}"],Ve={obstacle:"{first} ran into the obstacle or border at {cell}",vertex:"{first} and {second} both headed for {cell}",edge:"\
{first} and {second} meant to swap, {first} to {cell}",chain:"{first} headed for {cell}, where {second} had to stay"},j={"both held":"both bounce","both doomed":"\
both disappear",held:"{agent} bounces",doomed:"{agent} disappears",none:"nobody is stopped"},Ke="{event}: {outcome}",xe={random:"any action, all equally likely",
still:"always stays",chaser:"moves to where the nearest adversary in view is nearest",fleer:"moves to where the nearest adversary in view is farthest","clumsy-c\
haser":"a chaser that takes any action in half of the steps",hunter:"a chaser of the nearest adversary in view to which no teammate in view is nearer",surrounder:"\
a chaser of the nearest free cell beside an adversary without a teammate","clumsy-fleer":"a fleer that takes any action in half of the steps",dodger:"moves to w\
here all adversaries in view together are farthest","team-surrounder":"shares the free cells beside adversaries with its teammates, and searches","careful-rando\
m":"as random, but takes only moves that right of way allows","careful-chaser":"as chaser, but takes only moves that right of way allows","careful-fleer":"as fl\
eer, but takes only moves that right of way allows","careful-clumsy-chaser":"as clumsy-chaser, but takes only moves that right of way allows","careful-hunter":"\
as hunter, but takes only moves that right of way allows","careful-surrounder":"as surrounder, but takes only moves that right of way allows","careful-clumsy-fl\
eer":"as clumsy-fleer, but takes only moves that right of way allows","careful-dodger":"as dodger, but takes only moves that right of way allows","careful-team-\
surrounder":"as team-surrounder, but takes only moves that right of way allows"},qe={free:".GS",blocked:"#@OTW"};var I=1+je.length;function V(t,e){return t.replace(/\{(\w+)\}/g,(r,n)=>String(e[n]))}function N(t,e){return t<e?V(ve[0],{number:t}):V(ve[1],{number:t-e})}function wr(t,e){
let[r,n,o,s,a,i,l,...c]=Array.from(t),d=a<0?[s]:[s,a],[m,h,p]=c.map(T=>d.filter((P,O)=>T>>O&1)),y=d.map(T=>N(T,e)),f=V(Ve[a<0?"obstacle":we[o]],{first:y[0],second:y[y.
length-1],cell:`(${i}, ${l})`}),x=V(Ke,{event:f,outcome:vr(d.length,h,p,e)});return{kind:ze[n],form:we[o],agents:d,cell:[i,l],at_fault:m,held:h,doomed:p,turn:r,
text:x}}function vr(t,e,r,n){if(t===2&&e.length===2)return j["both held"];if(t===2&&r.length===2)return j["both doomed"];let o=s=>a=>V(j[s],{agent:N(a,n)});return[
...e.map(o("held")),...r.map(o("doomed"))].join(", ")||j.none}function se(t,e){let r=[];for(let n=0;n<t.length;n+=I)r.push(wr(t.subarray(n+1,n+I),e));return r}var E=class extends Error{name="EngineError"};function b(t,e,r){let n=typeof r=="string"?`'${r}'`:typeof r=="object"?JSON.stringify(r):String(r);return new E(`${t}\
: expected ${e}, got ${n}`)}var L=class{bytes;constructor(e){this.bytes=e}},Je=0,Ae=[Uint8Array,Uint8Array,Int32Array,BigInt64Array,BigUint64Array,Float32Array,Float64Array],Ye=4,Xe=4,xr=new TextEncoder,
Mr=new TextDecoder;function Ar(t){for(let e=Ae.length-1;e>Je;--e)if(t instanceof Ae[e])return e;throw new TypeError("array: expected a typed array of the engine\
's numbers, got another")}function Me(t){return new Uint8Array(t.buffer,t.byteOffset,t.byteLength)}function Sr(t){return xr.encode(`${t}\0`)}var Se=class{engine;addresses=[];constructor(e){
this.engine=e}copy(e){let r=this.engine._malloc(Math.max(e.length,1));if(r===0)throw new E("memory: expected room for the arguments, got none");return this.addresses.
push(r),this.engine.HEAPU8.set(e,r),r}text(e){return this.copy(Sr(e))}arrays(e){let r=Object.entries(e),n=r.flatMap(([s,a])=>{let i=a instanceof L,l=i?a.bytes:a;
return[this.text(s),i?Je:Ar(l),l.length,this.copy(Me(l))]}),o=this.copy(Me(Int32Array.from(n)));return this.copy(Me(Int32Array.of(r.length,o)))}free(){for(let e of this.
addresses)this.engine._free(e)}};function Ze(t,e){let r=t.HEAPU8;return Mr.decode(r.subarray(e,r.indexOf(0,e)))}function $(t){let e=new Int32Array(t.HEAPU8.buffer),
r=t._last_outputs()/Ye,n=e[r+1]/Ye,o={};for(let s=n;s<n+e[r]*Xe;s+=Xe){let a=Ae[e[s+1]],i=e[s+2]*a.BYTES_PER_ELEMENT,l=e[s+3];o[Ze(t,e[s])]=new a(t.HEAPU8.slice(
l,l+i).buffer)}return o}function C(t,e){let r=new Se(t);try{let n=e(r);if(n===0)throw new E(Ze(t,t._last_error()));return n}finally{r.free()}}var _r=2**31-1,Qe=["none","elman","gru"],Tr=2n**64n-1n,Cr=34028234663852886e22;function _(t,e){if(typeof e!="number"||!Number.isInteger(e)||Math.abs(e)>_r)throw b(
t,"an integer",e);return Int32Array.of(e)}function ae(t,e){if(typeof e!="boolean")throw b(t,"true or false",e);return new L(Uint8Array.of(Number(e)))}function k(t,e,r){
let n=typeof e=="string"&&Object.hasOwn(r,e)?r[e]:void 0;if(n===void 0)throw b(t,`one of ${Object.keys(r).join(", ")}`,e);return Int32Array.of(n)}function _e(t,e){
if(typeof e!="number"||!(Math.abs(e)<=Cr))throw b(t,"a finite number",e);return e}function U(t,e){let n=typeof e=="bigint"||typeof e=="number"&&Number.isSafeInteger(
e)?BigInt(e):-1n;if(n<0n||n>Tr)throw b(t,"an integer from 0 to 2^64 - 1",e);return BigUint64Array.of(n)}function Er(t){return{"rules.interaction":k("interaction",
t.interaction,He),"rules.obstacle":k("obstacle",t.obstacle,z),"rules.teammate":k("teammate",t.teammate,z),"rules.evader":k("evader",t.evader,z),"rules.pursuer":k(
"pursuer",t.pursuer,z),"rules.capture":k("capture",t.capture,Be),"rules.captured_disappear":ae("captured_disappear",t.captured_disappear)}}function et(t,e){let r=typeof e==
"number"?[e,e,e]:e;if(!Array.isArray(r)||r.length!==3)throw b(t,"1 or 3 numbers",e);return Float32Array.from(r,n=>_e(t,n))}function kr(t){let e=(r,n)=>Float32Array.
of(_e(r,t[r]),_e(n,t[n]));return{"rewards.capture":e("pursuer_capture","evader_capture"),"rewards.neighbor":e("pursuer_neighbor","evader_neighbor"),"rewards.ste\
p":e("pursuer_step","evader_step"),"rewards.pursuer_collide":et("pursuer_collide",t.pursuer_collide),"rewards.evader_collide":et("evader_collide",t.evader_collide),
"rewards.blame":k("blame",t.blame,Ge),"rewards.capture_repeats":ae("capture_repeats",t.capture_repeats)}}function rt(t){if(t===void 0||typeof t=="number")return new Uint8Array(
0);if(t instanceof Uint8Array)return t;let{free:e,blocked:r}=qe;for(let[n,o]of t.entries()){if(o.length!==t[0]?.length)throw b(`map, row ${n}`,`${t[0]?.length} \
cells as in row 0`,o.length);let s=[...o].find(a=>!e.includes(a)&&!r.includes(a));if(s)throw b(`map, row ${n}`,`'${e}' (free) or '${r}' (obstacle)`,s)}return Uint8Array.
from([...t.join("")],n=>Number(r.includes(n)))}function nt(t,e){if(!Array.isArray(t))return;let r=[t.length,t[0]?.length??0];if(!(r[0]===e.rows&&r[1]===e.cols))
throw b("obstacle map",`shape (${e.rows}, ${e.cols}), the rows and cols`,r)}function W(t){nt(t.obstacles,t);let e=typeof t.obstacles=="number"?t.obstacles:0;return{
...Er(t.rules),...kr(t.rewards),rows:_("rows",t.rows),cols:_("cols",t.cols),n_pursuers:_("n_pursuers",t.n_pursuers),n_evaders:_("n_evaders",t.n_evaders),fov:_("\
fov",t.fov),diagonal:ae("diagonal",t.diagonal),max_steps:_("max_steps",t.max_steps),density:Float64Array.of(e),map:rt(t.obstacles)}}function tt(t,e){return Int32Array.
from((e??[]).flat(),r=>_(t,r)[0])}function ot(t,e){return nt(t.obstacles,e),{seed:U("seed",t.seed??0n),episode:U("episode",t.episode??0),pursuers:tt("pursuers",
t.pursuers),evaders:tt("evaders",t.evaders),map:rt(t.obstacles)}}function ie(t){return{actions:Int32Array.from(t,e=>_("actions",e)[0])}}function F(t){if(typeof t==
"string"){if(!Object.hasOwn(xe,t))throw b("policy",`one of ${Object.keys(xe).join(", ")}`,t);return{script:new TextEncoder().encode(t)}}if(t.activation!=="relu"&&
t.activation!=="tanh")throw b("activation","'relu' or 'tanh'",t.activation);if(!Qe.includes(t.memory))throw b("memory",`one of ${Qe.join(", ")}`,t.memory);return{
hidden:Int32Array.from(t.hidden,e=>_("hidden",e)[0]),activation:new TextEncoder().encode(t.activation),sampled:ae("sampled",t.sampled),memory:new TextEncoder().
encode(t.memory),genome:t.genome}}var Rr=["first_turn","terminated","truncated"];function st(t){let e={...t};for(let r of Rr)e[r]=new L(t[r]);return e}var le=class{config;seed;episode;n_agents;statistics;first_conflict;constructor(e,r,n,o){this.config=e,this.seed=r,this.episode=n,this.n_agents=e.n_pursuers+e.n_evaders,
this.statistics=at(o,0),Object.assign(this,o),this.first_conflict=Pr(this.conflict_table,this.length)}get length(){return this.actions.length/this.n_agents}conflicts(e){
this.check(e);let[r,n]=[this.first_conflict[e],this.first_conflict[e+1]],o=this.conflict_table.subarray(r*I,n*I);return se(o,this.config.n_pursuers)}seek(e,r,n){
this.check(r),(!(e.seed===this.seed&&e.episode===BigInt(this.episode))||e.turn!==0||e.steps>r)&&e.reset({seed:this.seed,episode:this.episode});for(let s=e.steps;s<
r;++s){let a=this.actions.subarray(s*this.n_agents,(s+1)*this.n_agents);n?e.replay(a,{pursuer:n.pursuers,evader:n.evaders}):e.step(a)}}check(e){if(!(Number.isInteger(
e)&&e>=0&&e<=this.length))throw b("step",`0 to ${this.length}`,e)}};function Pr(t,e){let r=new Int32Array(e+2);for(let n=0;n<t.length;n+=I)++r[t[n]+1];for(let n=1;n<
r.length;++n)r[n]+=r[n-1];return r}function at(t,e){let r=t["statistics.length"].length,n=s=>{let a=t[`statistics.${s}`],i=a.length/r;return a.slice(e*i,(e+1)*i)},
o=s=>Number(n(s)[0]);return{capture_rate:o("capture_rate"),ever_capture_rate:o("ever_capture_rate"),captured_fraction:o("captured_fraction"),length:o("length"),
return:n("return"),survivors:n("survivors"),overlap:n("overlap"),collisions:n("collisions"),faults:n("faults"),agent_steps:n("agent_steps")}}function it(t,e,r,n){
let o=[W(r.config),F(r.pursuers),F(r.evaders),n];return C(t,s=>{let[a,i,l,c]=o.map(d=>s.arrays(d));return t[e](a,i,l,c)}),$(t)}function lt(t,e,r,n){let o={seed:U(
"seed",r),episode:U("episode",n)};return new le(e.config,r,n,it(t,"_play_match",e,o))}function ct(t,e,r,n){if(!Number.isInteger(n)||n<1)throw b("n_episodes","at\
 least 1",n);let o={seed:U("seed",r),n_episodes:Int32Array.of(n)},s=it(t,"_play_rollout",e,o);return Array.from({length:n},(a,i)=>at(s,i))}var Or=new FinalizationRegistry(([t,e])=>t._states_free(e));var Te=class{value;teams;matrix;n_actions;constructor(e,r){let{matrix:n,rows:o,cols:s,value:a,agents:i}=r,[l,c]=e.actors,d=Array.from(i).filter(h=>l<=h&&h<c),m=h=>h<
e.config.n_pursuers;[this.value,this.matrix,this.n_actions]=[a[0],n,e.n_actions],this.teams=[{agents:d.filter(m),play:o},{agents:d.filter(h=>!m(h)),play:s}]}marginal(e){
let r=this.teams.find(({agents:s})=>s.includes(e));if(!r)return null;let n=this.n_actions**(r.agents.length-1-r.agents.indexOf(e)),o=Array(this.n_actions).fill(
0);return r.play.forEach((s,a)=>o[Math.floor(a/n)%this.n_actions]+=s),o}lost(e){let[r,n]=this.teams.map(({agents:l})=>l.reduce((c,d)=>c*this.n_actions+e[d],0)),
[o,s]=this.teams.map(({play:l})=>l),a=s.reduce((l,c,d)=>l+c*this.matrix[r*s.length+d],0),i=o.reduce((l,c,d)=>l+c*this.matrix[d*s.length+n],0);return[Math.max(0,
this.value-a),Math.max(0,i-this.value)]}},Ir=60,K=class{config;payoff;engine;states;n_turns;values;constructor(e,r,n){[this.engine,this.config,this.payoff]=[e,r,
n],this.states=C(e,a=>e._states_new(a.arrays(W(r)))),Or.register(this,[e,this.states]);let o={SIMULTANEOUS:1,SWARM_TURNS:2,AGENT_TURNS:r.n_pursuers+r.n_evaders};
this.n_turns=o[r.rules.interaction];let s=this.call(()=>e._states_payoffs(this.states)).payoffs;this.values=[[n==="capture-rate"?s:s.fill(0)]]}goBack(){let e=this.
values.at(-1)[0],r=[];for(let o=this.n_turns-1;o>=0;o--){let s=r[o+1]??e;r[o]=this.call(a=>this.engine._states_backup(this.states,o,a.arrays({next:s}))).values}
this.payoff==="capture-time"&&(r[0]=r[0].map((o,s)=>s===this.config.n_evaders?0:o-1)),this.values.push(r);let n=this.payoff==="capture-rate"?this.config.max_steps:
Math.min(this.config.max_steps,Ir);return this.values.length<=n&&r[0].some((o,s)=>o!==e[s])}game(e){let[r,{turn:n}]=[this.config.max_steps-e.steps,e],o=n+1===this.
n_turns,s=r>0?this.values[Math.min(r-Number(o),this.values.length-1)]?.[o?0:n+1]:void 0;if(!s)return null;let a=this.call(i=>this.engine._states_game(this.states,
e.address,i.arrays({next:s})));return a.agents.length?new Te(e,a):null}call(e){return C(this.engine,e),$(this.engine)}};var ut=new FinalizationRegistry(([t,e])=>t._world_free(e)),q=class{config;n_agents;n_actions;engine;at;freed=!1;constructor(e,r){this.engine=e,this.config=r,this.
n_agents=r.n_pursuers+r.n_evaders,this.n_actions=r.diagonal?9:5,this.at=C(e,n=>e._world_new(n.arrays(W(r)))),ut.register(this,[e,this.at],this)}free(){this.freed||
(this.freed=!0,ut.unregister(this),this.engine._world_free(this.at))}get address(){if(this.freed)throw b("world","one that is in use","one that was freed");return this.
at}reset(e={}){let r=ot(e,this.config);this.call(n=>this.engine._world_reset(this.address,n.arrays(r)))}step(e){let r=ie(e);this.call(n=>this.engine._world_step(
this.address,n.arrays(r)))}playTurn(e){let r=ie(e);this.call(n=>this.engine._world_play_turn(this.address,n.arrays(r)))}decide(e,r,n){let{n_pursuers:o}=this.config,
s={pursuer:[0,o],evader:[o,this.n_agents]},[a,i]=typeof r=="string"?s[r]:r;if(n.length!==this.n_agents)throw b("actions",String(this.n_agents),n.length);let l=[
F(e),ie(n)],{actions:c}=this.call(d=>this.engine._world_decide(this.address,d.arrays(l[0]),a,i,d.arrays(l[1])));return Uint8Array.from(c)}replay(e,r){let n=s=>typeof s!=
"string"&&s.memory!=="none";if(!n(r.pursuer)&&!n(r.evader))return this.step(e);let{n_pursuers:o}=this.config;for(let s=this.n_turns;s>0;--s){let[a,i]=this.actors;
a<o&&this.decide(r.pursuer,[a,Math.min(i,o)],e),i>o&&this.decide(r.evader,[Math.max(a,o),i],e),this.playTurn(e)}}get n_turns(){return this.turnNumbers()[1]}get turn(){
return this.turnNumbers()[0]}get actors(){let[,,e,r]=this.turnNumbers();return[e,r]}turnNumbers(){return this.call(()=>this.engine._world_turn(this.address)).turn}get steps(){
return this.read("steps")[0]}get seed(){return this.read("seed")[0]}get episode(){return this.read("episode")[0]}get over(){return this.read("terminated")[0]===
1||this.read("truncated")[0]===1}read(e){return this.call(r=>this.engine._world_read(this.address,r.text(e)))[e]}view(e){let r=3*this.config.fov**2;return this.
read("views").slice(e*r,(e+1)*r)}map(){return this.read("state").slice(2*this.config.rows*this.config.cols)}conflicts(){return se(this.conflictTable(),this.config.
n_pursuers)}conflictTable(){return this.call(()=>this.engine._world_conflicts(this.address)).conflict_table}answer(e,r){let n=F(e),{logits:o,memory:s}=this.call(
l=>this.engine._world_logits(this.address,l.arrays(n),r)),a=o,i=this.decide(e,[r,r+1],new Uint8Array(this.n_agents))[r];return{logits:a,probabilities:Nr(a),action:i,
memory:s}}snapshot(){return this.call(()=>this.engine._world_snapshot(this.address))}restore(e){let r=st(e);this.call(n=>this.engine._world_restore(this.address,
n.arrays(r)))}call(e){return C(this.engine,e),$(this.engine)}};function Nr(t){let e=Math.max(...t),r=Array.from(t,o=>Math.exp(o-e)),n=r.reduce((o,s)=>o+s,0);return Float32Array.
from(r,o=>o/n)}var Ce=class{compiled;constructor(e){this.compiled=e}world(e){return new q(this.compiled,e)}solution(e,r="capture-rate"){return new K(this.compiled,e,r)}match(e,r,n,o,s=0){
return lt(this.compiled,{config:e,pursuers:r,evaders:n},o,s)}rollout(e,r,n,o,s){return ct(this.compiled,{config:e,pursuers:r,evaders:n},o,s)}},dt;function mt(t=globalThis.
matrixworldEngine){return dt??=Lr(t),dt}async function Lr(t){if(!t)throw new Error("matrixworldEngine: expected the script engine.js before this one, got none");
let e=Uint8Array.from(atob(t.binary),r=>r.charCodeAt(0));return new Ce(await t({wasmBinary:e}))}var $r="http://www.w3.org/2000/svg";function u(t,e={},...r){return ht(document.createElement(t),e,r)}function w(t,e={},...r){return ht(document.createElementNS(
$r,t),e,r)}function ht(t,e,r){for(let[n,o]of Object.entries(e))o==null||o===!1||(typeof o=="function"?t.addEventListener(n.slice(2),o):t.setAttribute(n,o===!0?"":
String(o)));return t.append(...r.filter(Ur).map(n=>typeof n=="number"?String(n):n)),t}function Ur(t){return t!=null&&t!==!1}var Wr=matchMedia("(prefers-color-scheme: dark)");function Fr(){let t=document.documentElement.dataset.theme;return t?t==="dark":Wr.matches}function Ee(){document.
documentElement.dataset.theme=Fr()?"light":"dark"}function pt(){return u("button",{type:"button",title:"Light or dark (D)","aria-label":"Light or dark",onclick:Ee},
"◐")}function ft(t){let e=atob(ke(t)),r=new Uint8Array(e.length);for(let n=0;n<r.length;n++)r[n]=e.charCodeAt(n);return r}function ke(t){return document.getElementById(
t)?.textContent??""}function yt(){return JSON.parse(ke("data"))}var Re=[[0,0],[-1,0],[0,1],[1,0],[0,-1],[-1,1],[1,1],[1,-1],[-1,-1]];var R=(t,e)=>e<t.nPursuers,g=(t,e)=>[t.positions[2*e],t.positions[2*e+1]],Dr=(t,e)=>t[0]===e[0]&&t[1]===e[1],Pe=({rows:t,cols:e},[r,n])=>r>=0&&n>=0&&r<t&&n<e,Oe=(t,e,r=3)=>t!==
void 0&&[0,1,2].slice(0,r).some(n=>t[3*e+n]),Ie=(t,e)=>Oe(t.fault,e),bt=(t,e)=>!Ie(t,e)&&Oe(t.involved,e,2);function ce(t,e,r){let n=!Dr(g(t,r),g(e,r)),o=e.involved===
void 0||Oe(e.involved,r);return!!(e.alive[r]&&e.actions?.[r]&&!n&&o)}function ue(t,e,r){let[n,o]=g(t,r),[s,a]=Re[e.actions?.[r]??0];return[n+s,o+a]}function Y(t,e,r){
return Array.from({length:r.everCaptured.length},(o,s)=>s).filter(o=>r.everCaptured[o]&&!e.everCaptured[o]).map(o=>t.nPursuers+o)}var gt=t=>t.moments.flatMap((e,r)=>r&&
Y(t,t.moments[r-1],e).length?[r]:[]);function de(t,e){return Array.from({length:e.alive.length},(n,o)=>o).filter(n=>t.alive[n]&&!e.alive[n])}var wt=[-.31,0,.31],vt=[{size:1,at:[[0,0]]},{size:.62,at:[[-.2,.2],[.2,-.2]]},{size:.54,at:[[-.23,.22],[.23,.22],[0,-.22]]},{size:.54,at:[[-.23,.23],[.23,.23],[
-.23,-.23],[.23,-.23]]},{size:.36,at:wt.flatMap(t=>wt.map(e=>[e,t]))}],Hr=.3,Br=.35,Gr=.55;function X(t,e){let r=new Map;for(let n=0;n<e.alive.length;n++){if(!e.
alive[n])continue;let[o,s]=g(e,n),a=o*t.cols+s,i=r.get(a);i?i.push(n):r.set(a,[n])}return r}function xt(t,e){let r=Array.from(e.alive,(n,o)=>{let[s,a]=g(e,o);return{
x:a+.5,y:s+.5,size:1,alpha:0}});for(let n of X(t,e).values()){let o=vt[Math.min(n.length,vt.length)-1];n.forEach((s,a)=>{let[i,l]=o.at[Math.min(a,o.at.length-1)],
c=r[s];c.x+=i,c.y+=l,c.size=o.size,c.alpha=1})}return r}var Mt=t=>t*t*(3-2*t),D=(t,e,r)=>t+(e-t)*r,At=t=>Math.min(1,Math.max(0,t));function St(t,e,r,n){let o={SIMULTANEOUS:1,
SWARM_TURNS:2,AGENT_TURNS:r}[t.interaction];if(o===1)return Mt(n);let s=o===r?e:+!R(t,e),a=Math.max(1/o,Br);return Mt(At((n-s/(o-1)*(1-a))/a))}function me(t,e){
let r=t.moments.length-1,n=Math.min(Math.floor(e),r),o=t.moments[n],s=xt(t,o);if(n===r||e===n)return s;let a=t.moments[n+1],i=xt(t,a);return s.map((l,c)=>{let d=St(
t,c,s.length,e-n);return zr(o,a,c,l,i[c],d)})}function Ne(t,e,r){let n=t.moments.length-1,o=Math.min(Math.floor(r),n),[s,a]=[t.moments[o],t.moments[Math.min(o+1,
n)]],i=St(t,e,s.alive.length,r-o),[[l,c],[d,m]]=[g(s,e),g(a,e)];return[D(c,m,i)+.5,D(l,d,i)+.5]}function zr(t,e,r,n,o,s){let a=n.alpha>o.alpha,i={x:D(n.x,o.x,s),
y:D(n.y,o.y,s),size:a?n.size:D(n.size,o.size,s),alpha:a?At((1-s)/(1-Gr)):D(n.alpha,o.alpha,s)};if(ce(t,e,r)){let[l,c]=g(t,r),[d,m]=ue(t,e,r),h=Hr*Math.sin(Math.
PI*s);i.x+=(m-c)*h,i.y+=(d-l)*h}return i}var _t=2*Math.PI;function J(t,e,r,n){t.beginPath(),t.arc(e,r,n/2,0,_t)}function Tt(t,e,r,n){let o=n/2,s=[[0,-.97],[.97,.83],[-.97,.83]].map(([a,i])=>[e+a*o,r+i*
o]);t.beginPath(),t.moveTo((s[2][0]+s[0][0])/2,(s[2][1]+s[0][1])/2),s.forEach(([a,i],l)=>{let[c,d]=s[(l+1)%3];t.arcTo(a,i,c,d,n*.09)}),t.closePath()}function Ct(t,e,r,n){
let o=n*.32;t.beginPath(),t.moveTo(e-o,r-o),t.lineTo(e+o,r+o),t.moveTo(e+o,r-o),t.lineTo(e-o,r+o)}function Et(t,e,r,n){t.beginPath();for(let o=0;o<16;o++){let s=n/
2*(o%2?.6:.95),a=_t*o/16;t.lineTo(e+s*Math.sin(a),r-s*Math.cos(a))}t.closePath()}function kt(t,e,r,n,o,s){let a=Math.atan2(o-r,n-e);t.beginPath(),t.moveTo(e,r),
t.lineTo(n,o);for(let i of[-1,1])t.moveTo(n,o),t.lineTo(n-s*Math.cos(a+i*.6),o-s*Math.sin(a+i*.6))}var Rt=4,jr=1.6,Vr=.95,Kr=5,qr=.16,Yr=9,Xr=.09,Jr=.2,Pt=.75,M=(t,e)=>t.left+e*t.cell,A=(t,e)=>t.top+e*t.cell;function H(t,e,r){return R(e,r)?t.colors.pursuer:t.
colors.evader}function Ot({ctx:t,grid:e,colors:r}){let{left:n,top:o,cell:s,rows:a,cols:i}=e,[l,c]=[i*s,a*s];if(t.fillStyle=r.paper,t.fillRect(n,o,l,c),s<Kr)return;
t.fillStyle=r.line;let d=Math.max(1,Math.round(s/60));for(let m=1;m<i;m++)t.fillRect(n+m*s,o,d,c);for(let m=1;m<a;m++)t.fillRect(n,o+m*s,l,d)}function It({ctx:t,
grid:e,colors:r},n){let{left:o,top:s,cell:a,rows:i,cols:l}=e;t.fillStyle=r.obstacle;for(let c=0;c<i*l;c++){if(!n.obstacles[c])continue;let[d,m]=[Math.floor(c/l),
c%l];t.fillRect(o+m*a,s+d*a,a,a)}Nt({ctx:t,grid:e,colors:r})}function Nt({ctx:t,grid:{left:e,top:r,cell:n,rows:o,cols:s},colors:a}){let i=Math.min(5,Math.max(2,
Math.round(n/18)));t.strokeStyle=a.frame,t.lineWidth=i,t.strokeRect(e-i/2,r-i/2,s*n+i,o*n+i)}function Lt({ctx:t,grid:e,colors:r},n){let{left:o,top:s,cell:a,rows:i,
cols:l}=e,c=a<24*n?5:1;t.font=`500 ${Math.round(Math.min(15*n,Math.max(9*n,a*.32)))}px system-ui, sans-serif`,t.fillStyle=r.muted,t.textBaseline="alphabetic",t.
textAlign="center";let d=5*n+a/40;for(let m=0;m<l;m+=c)t.fillText(String(m),o+(m+.5)*a,s-d);t.textAlign="right",t.textBaseline="middle";for(let m=0;m<i;m+=c)t.fillText(
String(m),o-d,s+(m+.5)*a)}function $t({grid:t},e,r,n){let o=Math.floor(e.fov/2)+.5,[s,a]=[Math.max(0,r-o),Math.min(t.cols,r+o)],[i,l]=[Math.max(0,n-o),Math.min(
t.rows,n+o)];return[M(t,s),A(t,i),(a-s)*t.cell,(l-i)*t.cell]}function Ut(t,e,r,n){let{ctx:o,grid:s,colors:a}=t;o.save(),o.beginPath(),o.rect(0,0,o.canvas.width,
o.canvas.height),o.rect(...$t(t,e,r,n)),o.clip("evenodd"),o.clearRect(0,0,o.canvas.width,o.canvas.height),o.fillStyle=a.line,o.fillRect(s.left,s.top,s.cols*s.cell,
s.rows*s.cell),o.restore(),Nt(t)}function Wt({ctx:t,grid:e,colors:r},{x:n,y:o,alpha:s},a){let i=Math.max(e.cell,16*a)*1.06,[l,c]=[M(e,n),A(e,o)];t.globalAlpha=Math.
max(s,.6),t.beginPath(),t.roundRect(l-i/2,c-i/2,i,i,i*.2),t.strokeStyle=r.focus,t.lineWidth=Math.max(2,2.5*a),t.stroke();let d=Math.max(11*a,Math.min(18*a,e.cell*
.5));t.font=`700 ${Math.round(d)}px system-ui, sans-serif`,t.textAlign="center",t.textBaseline="middle";let m=c-i/2<d*1.2,h=c+(m?1:-1)*(i/2+d*.7);t.strokeStyle=
r.paper,t.lineJoin="round",t.lineWidth=d*.35,t.strokeText("You",l,h),t.fillStyle=r.ink,t.fillText("You",l,h),t.globalAlpha=1}function Ft(t,e,r,n,o){let{ctx:s,grid:a}=t,
i=$t(t,e,n,o),l=H(t,e,r);s.globalAlpha=.11,s.fillStyle=l,s.fillRect(...i),s.globalAlpha=.8,s.strokeStyle=l,s.lineWidth=Math.max(1,a.cell/24),s.strokeRect(...i),
s.globalAlpha=1}function Dt(t,e,r,n,o){let{ctx:s,grid:a}=t,i=Math.min(Math.ceil(r),e.moments.length-1),l=e.moments[i];s.lineCap="round",s.lineWidth=Math.min(Yr,
Math.max(1,a.cell*qr));for(let c=Math.max(1,Math.floor(r-n)+1);c<=i;c++){let[d,m]=[e.moments[c-1],e.moments[c]],h=Math.max(0,Math.min(1,(r-c)/n));s.globalAlpha=
Pt+(Jr-Pt)*h;for(let p=0;p<m.alive.length;p++){let y=c===i&&r<i;if(!d.alive[p]||!(l.alive[p]||y))continue;let f=(R(e,p)?-1:1)*Xr,[x,T]=g(d,p),[P,O]=g(m,p);if(x===
P&&T===O)continue;let ee=y?o[p].x:O+.5,br=y?o[p].y:P+.5;s.strokeStyle=H(t,e,p),s.beginPath(),s.moveTo(M(a,T+.5+f),A(a,x+.5+f)),s.lineTo(M(a,ee+f),A(a,br+f)),s.stroke()}}
s.globalAlpha=1}function Ht(t,e,r){let n=Math.min(Math.ceil(r),e.moments.length-1);for(let o=Math.max(1,n-Rt+1);o<=n;o++){let[s,a]=[e.moments[o-1],e.moments[o]],
i=o>r?Math.max(0,1-2*(o-r)):1-(r-o)/Rt,l=Y(e,s,a);for(let c of de(s,a))l.includes(c)||Qr(t,g(a,c),i);for(let c of l)Zr(t,g(a,c),i)}t.ctx.globalAlpha=1}function Zr({
ctx:t,grid:e,colors:r},[n,o],s){t.globalAlpha=s,Et(t,M(e,o+.5),A(e,n+.5),Math.max(8,e.cell*jr)),t.fillStyle=r.capture,t.fill(),t.strokeStyle=r.ink,t.lineWidth=Math.
max(1,e.cell/36),t.lineJoin="round",t.stroke()}function Qr({ctx:t,grid:e,colors:r},[n,o],s){t.globalAlpha=s,Ct(t,M(e,o+.5),A(e,n+.5),Math.max(7,e.cell*Vr)),t.strokeStyle=
r.collision,t.lineWidth=Math.max(2,e.cell*.17),t.lineCap="round",t.stroke()}function Bt({ctx:t,grid:e,colors:r},n,o){let s=Math.max(1,e.cell*.07);t.strokeStyle=
t.fillStyle=r.collision,t.lineWidth=Math.max(1,e.cell*.05),t.setLineDash([e.cell*.14,e.cell*.1]);for(let[a,i]of n){if(a<0||i<0||a>=e.rows||i>=e.cols)continue;let l=[
M(e,i)+s,A(e,a)+s,e.cell-2*s,e.cell-2*s];t.globalAlpha=.2*o,t.fillRect(...l),t.globalAlpha=o,t.strokeRect(...l)}t.setLineDash([]),t.globalAlpha=1}function Gt({ctx:t,
grid:e,colors:r},n,o,s,a){t.globalAlpha=a,J(t,M(e,n),A(e,o),Math.max(8,e.cell*s*1.02)),t.strokeStyle=r.collision,t.lineWidth=Math.max(1.5,e.cell*.085*Math.sqrt(
s)),t.stroke(),t.globalAlpha=1}var en=.8,tn=.92,rn=15,nn=7,Le=9;function zt(t,e,r,n,o,s){n.forEach((a,i)=>{a.alpha>0&&on(t,e,r,i,a,o,s)}),t.ctx.globalAlpha=1;for(let a of X(e,r).values())a.length>
Le&&sn(t,n[a[Le-1]],a.length-Le+1)}function on(t,e,r,n,o,s,a){let{ctx:i,grid:l,colors:c}=t,d=R(e,n),[m,h]=[l.left+o.x*l.cell,l.top+o.y*l.cell],p=Math.max(4,l.cell*
o.size*(d?tn:en)),y=H(t,e,n),f=!d&&!!r.captured[n-e.nPursuers];if(i.globalAlpha=o.alpha,(d?Tt:J)(i,m,h,p),p>nn*a&&(i.strokeStyle=c.paper,i.lineWidth=Math.max(2,
p*.1),i.stroke()),i.fillStyle=f?c.paper:y,i.fill(),f&&(J(i,m,h,p*.82),i.strokeStyle=y,i.lineWidth=p*.18,i.stroke()),!s||p<rn*a)return;let x=String(d?n:n-e.nPursuers);
i.font=`700 ${Math.round(p*(d?.4:.5)*(x.length>1?.8:1))}px system-ui, sans-serif`,i.textAlign="center",i.textBaseline="middle",i.fillStyle=f?y:c.paper,i.fillText(
x,m,h+p*(d?.17:.03))}function sn({ctx:t,grid:e,colors:r},n,o){let[s,a]=[e.left+n.x*e.cell,e.top+n.y*e.cell];t.font=`700 ${Math.round(e.cell*.3)}px system-ui, sa\
ns-serif`,t.textAlign="center",t.textBaseline="middle",t.strokeStyle=r.paper,t.lineWidth=e.cell*.1,t.strokeText(`+${o}`,s,a),t.fillStyle=r.ink,t.fillText(`+${o}`,
s,a)}var an=.46,ln=.86,cn=.66,jt=.48,un=.78,dn=.58;function Vt(t,e,r,n){let[o,s]=[e.moments[r-1],e.moments[r]];if(!o)return;let{ctx:a,grid:i,colors:l}=t;a.strokeStyle=
l.collision,a.lineWidth=Math.max(1.5,i.cell*.07),a.lineCap="butt",a.globalAlpha=n;for(let c=0;c<s.alive.length;c++)ce(o,s,c)&&mn(t,e,g(o,c),ue(o,s,c));a.globalAlpha=
1}function mn({ctx:t,grid:e},r,n,o){let[s,a]=[o[1]-n[1],o[0]-n[0]],i=m=>M(e,n[1]+.5+s*m),l=m=>A(e,n[0]+.5+a*m),c=Pe(r,o)?un:dn;t.setLineDash([e.cell*.09,e.cell*
.06]),t.beginPath(),t.moveTo(i(jt),l(jt)),t.lineTo(i(c),l(c)),t.stroke(),t.setLineDash([]);let d=.17*e.cell/Math.hypot(s,a);t.beginPath(),t.moveTo(i(c)-a*d,l(c)+
s*d),t.lineTo(i(c)+a*d,l(c)-s*d),t.stroke()}function Kt(t,e,r,n,o,s){let a=Re[s];if(!s||!a)return;let{ctx:i,grid:l,colors:c}=t,d=Pe(e,[n[0]+a[0],n[1]+a[1]])?ln:
cn,m=an*o.size,h=[M(l,o.x+a[1]*m),A(l,o.y+a[0]*m),M(l,o.x+a[1]*d),A(l,o.y+a[0]*d)],p=Math.max(1.5,l.cell*.085);i.lineCap=i.lineJoin="round";for(let[y,f]of[[c.paper,
p*2.1],[H(t,e,r),p]])i.strokeStyle=y,i.lineWidth=f,kt(i,...h,l.cell*.2),i.stroke()}var Yt={numbers:!0,axes:!1,trail:6,viewers:[],plan:null,selected:null,cursor:null,you:null,fog:!1};function Xt(t,e,r,n,o){let{ctx:s,grid:a,colors:i}=t,l=Math.min(
Math.ceil(r),e.moments.length-1),c=e.moments[l],d=r===l,m=me(e,r),h=d?1:Math.max(0,1-2*(l-r));s.clearRect(0,0,s.canvas.width,s.canvas.height),Ot(t);for(let f of n.
viewers)m[f]?.alpha&&Ft(t,e,f,...Ne(e,f,r));It(t,e),n.axes&&Lt(t,o),Dt(t,e,r,n.trail,m),Bt(t,c.contested??[],h),Ht(t,e,r),Vt(t,e,l,h),m.forEach(({x:f,y:x,size:T},P)=>{
let O=bt(c,P)?.4:0,ee=Ie(c,P)?1:O;ee&&Gt(t,f,x,T,ee*h)});let p=d?c:e.moments[Math.max(0,l-1)];if(zt(t,e,p,m,n.numbers,o),d&&n.plan)for(let[f,x]of m.entries())x.
alpha&&Kt(t,e,f,g(c,f),x,n.plan[f]??0);n.you!==null&&(n.fog&&Ut(t,e,...Ne(e,n.you,r)),Wt(t,m[n.you],o)),s.lineWidth=Math.max(2,2.5*o),s.strokeStyle=i.focus;let y=n.
selected===null?void 0:m[n.selected];y?.alpha&&qt(t,y.x,y.y,y.size*.96),n.cursor&&(s.setLineDash([a.cell*.12,a.cell*.08]),qt(t,n.cursor[1]+.5,n.cursor[0]+.5,.8),
s.setLineDash([]))}function qt({ctx:t,grid:e},r,n,o){let s=o*e.cell;t.beginPath(),t.roundRect(e.left+r*e.cell-s/2,e.top+n*e.cell-s/2,s,s,s*.1),t.stroke()}var Jt=(t,e)=>(e+.24)/(t+.24);function Zt(t,e,r,n,o,s){let a=r?28*s:0,i=(c,d)=>(c-a)/(d+2*.12),l=Math.max(1,Math.floor(Math.min(i(n,e),i(o,t))));return{rows:t,cols:e,
cell:l,left:Math.round((n-e*l+a)/2),top:Math.round((o-t*l+a)/2)}}function Qt(t,e,r){let n=Math.floor((r-t.top)/t.cell),o=Math.floor((e-t.left)/t.cell);return n>=
0&&n<t.rows&&o>=0&&o<t.cols?[n,o]:null}var hn={paper:"--board-paper",line:"--board-line",frame:"--board-frame",ink:"--board-ink",muted:"--board-muted",obstacle:"--board-obstacle",pursuer:"--pursuer",
evader:"--evader",capture:"--capture",collision:"--collision",focus:"--focus"};function er(t){let e=getComputedStyle(t),r=Object.entries(hn).map(([n,o])=>[n,e.getPropertyValue(
o).trim()]);return Object.fromEntries(r)}var $e=()=>matchMedia("(prefers-reduced-motion: reduce)").matches,he=class{canvas;#e=null;#r=0;#n;#t={rows:1,cols:1,left:0,top:0,cell:1};#o=0;#s;#a;constructor(e,r={}){
this.canvas=e,e.classList.add("board"),e.setAttribute("role","img"),this.#n={...Yt,...r},this.#s=new ResizeObserver(()=>this.#c()),this.#s.observe(e),this.#a=new MutationObserver(
()=>this.redraw()),this.#a.observe(document.documentElement,{attributes:!0}),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",this.redraw)}close(){
this.#s.disconnect(),this.#a.disconnect(),matchMedia("(prefers-color-scheme: dark)").removeEventListener("change",this.redraw),cancelAnimationFrame(this.#o)}get look(){
return this.#n}set look(e){this.#n={...this.#n,...e},this.#l(),this.redraw()}show(e,r){this.#e=e,this.#r=Math.min(Math.max(0,r),e.moments.length-1),this.#l(),this.
redraw()}redraw=()=>{this.#o||(this.#o=requestAnimationFrame(()=>this.drawNow()))};drawNow(){cancelAnimationFrame(this.#o),this.#o=0;let e=this.canvas.getContext(
"2d");if(!e||!this.#e)return;let{rows:r,cols:n}=this.#e,o=devicePixelRatio||1;this.#t=Zt(r,n,this.#n.axes,this.canvas.width,this.canvas.height,o);let s={ctx:e,grid:this.#t,
colors:er(this.canvas)};Xt(s,this.#e,this.#r,this.#n,o)}cellAt(e,r){let n=this.canvas.getBoundingClientRect(),o=this.canvas.width/n.width;return Qt(this.#t,(e-n.
left)*o,(r-n.top)*o)}agentAt(e,r){let n=this.cellAt(e,r);if(!n||!this.#e)return null;let o=this.#e.moments[Math.round(this.#r)],s=X(this.#e,o).get(n[0]*this.#e.
cols+n[1])??[],a=me(this.#e,Math.round(this.#r)),i=l=>{let[c,d]=this.pointOf(a[l].x,a[l].y);return Math.hypot(c-e,d-r)};return s.length?s.reduce((l,c)=>i(c)<i(l)?
c:l):null}pointOf(e,r){let n=this.canvas.getBoundingClientRect(),o=n.width/this.canvas.width,{left:s,top:a,cell:i}=this.#t;return[n.left+(s+e*i)*o,n.top+(a+r*i)*
o]}#l(){if(!this.#e)return;let{rows:e,cols:r}=this.#e;this.canvas.style.setProperty("--board-aspect",String(Jt(e,r)))}#c(){let e=devicePixelRatio||1,{width:r,height:n}=this.
canvas.getBoundingClientRect();this.canvas.width=Math.max(1,Math.round(r*e)),this.canvas.height=Math.max(1,Math.round(n*e)),this.drawNow()}};var pn=Array.from({length:16},(t,e)=>{let[r,n]=[e%2?6.5:11,Math.PI*e/8];return`${12+r*Math.sin(n)} ${12-r*Math.cos(n)}`}).join(" ");function tr(){let t=[["pursu\
er",w("path",{d:"M12 3 22 20H2z",class:"filled-pursuer"})],["evader",w("circle",{cx:12,cy:12,r:9,class:"filled-evader"})],["capture",w("polygon",{points:pn,class:"\
filled-capture"})],["captured evader",w("circle",{cx:12,cy:12,r:7.5,class:"ring-evader"})],["conflict",w("rect",{x:3,y:3,width:18,height:18,class:"dashed-confli\
ct"})]];return u("ul",{class:"shapes small","aria-label":"Shapes on the board"},...t.map(([e,r])=>u("li",{},w("svg",{viewBox:"0 0 24 24","aria-hidden":"true"},r),
e)))}var fn={first:"M6 5v14M19 5 9 12l10 7z",back:"M17 5 7 12l10 7z",play:"M7 4.5 19 12 7 19.5z",pause:"M8 5v14M16 5v14",forward:"M7 5l10 7-10 7z",last:"M18 5v14M5 5\
l10 7-10 7z"};function rr(t){return w("svg",{viewBox:"0 0 24 24","aria-hidden":"true",class:"icon"},w("path",{d:fn[t]}))}function Z(t,e,r,n){return u("button",{
type:"button",class:"player-button","aria-label":e,title:`${e} (${r})`,onclick:n},rr(t))}function nr(t){let e=Z("play","Play","Space",()=>t.toggle()),r=yn(t),n=u(
"div",{class:"captures","aria-hidden":"true",title:"Captures"}),o=u("div",{class:"losses","aria-hidden":"true"}),s=bn(t),a=u("output",{class:"player-count"}),i=u(
"div",{class:"player",role:"group","aria-label":"Player"},Z("first","First step","Home",()=>t.move(-t.length)),Z("back","Step back","←",()=>t.move(-1)),e,Z("f\
orward","Step forward","→",()=>t.move(1)),Z("last","Last step","End",()=>t.move(t.length)),u("div",{class:"scrub"},n,o,r),a,s),l=(m,h={})=>{let p=u("i",h);return p.
style.left=`${100*m/Math.max(1,t.length)}%`,p},c=()=>{n.replaceChildren(...t.marks.map(m=>l(m))),o.replaceChildren(...t.ticks.map(({step:m,kind:h,size:p,text:y})=>{
let f=l(m,{class:h,title:`Step ${m}: ${y}`});return f.style.height=`${100*p}%`,f}))},d=()=>{e.replaceChildren(rr(t.playing?"pause":"play")),e.ariaLabel=t.playing?
"Pause":"Play",e.title=`${e.ariaLabel} (Space)`,r.max=String(t.length),r.value=String(t.step),r.ariaValueText=`step ${t.step} of ${t.length}`,a.textContent=`${t.
step} / ${t.length}`,a.style.minWidth=`${2*String(t.length).length+3}ch`,s.value=String(t.speed)};return t.addEventListener("step",d),t.addEventListener("state",
d),t.addEventListener("state",c),i.addEventListener("keydown",m=>{!(m.target instanceof HTMLSelectElement||m.key===" "&&m.target!==r)&&oe(t,m)&&m.preventDefault()}),
d(),i}function yn(t){let e=u("input",{type:"range",class:"player-scrub",min:0,step:1,"aria-label":"Step"});return e.addEventListener("input",()=>{t.pause(),t.jump(
Number(e.value))}),e}function bn(t){let e=`Steps a second, or the whole in ${ne} s (+ and -)`,r=u("select",{class:"player-speed","aria-label":"Speed",title:e},u(
"option",{value:re},`in ${ne} s`),...G.map(n=>u("option",{value:n},`${n} / s`)));return r.addEventListener("change",()=>{t.speed=Number(r.value)}),r}var v=(t,e=2)=>t==null?"-":t.toFixed(e);function or(t,e,r){if(r===0)return[{kind:"start",text:gn(t),agents:[]}];let[n,o]=[e.moments[r-1],e.moments[r]],s=d=>N(d,t.config.n_pursuers),a=Y(e,n,o),i=t.conflicts(
r),l=new Set(i.flatMap(d=>d.doomed)),c=a.map(d=>({kind:"capture",text:`${s(d)} is captured`,agents:[d]}));for(let d of de(n,o))!a.includes(d)&&!l.has(d)&&c.push(
{kind:"end",text:`${s(d)} disappears`,agents:[d]});return c.push(...i.map(({kind:d,text:m,agents:h})=>({kind:d,text:m,agents:h}))),r===t.length&&c.unshift({kind:"\
end",text:wn(t),agents:[]}),c}function gn({config:t}){return`${t.n_pursuers} pursuers and ${t.n_evaders} evaders on ${t.rows} x ${t.cols} cells, at most ${t.max_steps}\
 steps`}function wn(t){let e=Math.round(t.statistics.capture_rate*t.config.n_evaders);return`The episode ends after ${t.length} steps with ${e} of ${t.config.n_evaders}\
 evaders captured`}function sr(t,e,r){return{rows:t.rows,cols:t.cols,nPursuers:t.n_pursuers,fov:t.fov,interaction:t.rules.interaction,obstacles:e,moments:r}}function Ue(t,e){return{
positions:t.read("last_positions"),alive:t.read("alive"),captured:t.read("captured"),everCaptured:t.read("ever_captured"),actions:e,involved:t.read("involved"),
fault:t.read("fault"),contested:t.conflicts().map(r=>r.cell)}}var We=class{config;start;recording;actions=[];#e;#r;#n=[[]];constructor(e,r,n){[this.config,this.start]=[r,n],this.#e=e.world(r),this.#e.reset(n),this.#r=[Ue(this.#e)],
this.recording=sr(r,this.#e.map(),this.#r)}get length(){return this.actions.length}get over(){return this.#e.over}get statistics(){return{capture_rate:this.#e.read(
"capture_rate")[0]}}conflicts(e){return this.#n[e]}game(e){return e.game(this.#e)}play(e){this.#e.step(e),this.#t(e)}step(e,r,n){let[o,s]=[this.#e,this.config.n_pursuers],
a=new Uint8Array(o.n_agents);for(let i=o.n_turns;i>0&&!o.over;--i){let[l,c]=o.actors;l<s&&(a=o.decide(e.pursuer,[l,Math.min(c,s)],a)),c>s&&(a=o.decide(e.evader,
[Math.max(l,s),c],a)),typeof n=="number"?a[r]=n:l<=r&&r<c&&(a=o.decide(n,[r,r+1],a)),o.playTurn(a)}this.#t(a)}#t(e){this.actions.push(e),this.#r.push(Ue(this.#e,
e)),this.#n.push(this.#e.conflicts())}};function ar(t,e,r,n){let o=new We(t,e,r);for(let s of n)o.play(s);return o}var pe=class{#e;#r;#n;#t=new Map;#o=null;constructor(e){this.#e=e,this.#r=e.world.n_pursuers+e.world.n_evaders,this.#n=Math.floor(Math.log(256)/Math.log(e.n_actions));
let r=0;e.steps.forEach((n,o)=>n.forEach((s,a)=>{s<0||(this.#t.set(o*n.length+a,r),r+=Math.ceil(s*this.#r/this.#n))}))}has({pursuer:e,evader:r}){return this.#e.
steps[e][r]>=0}actions({pursuer:e,evader:r}){this.#o??=ft("recordings");let n=this.#t.get(e*this.#e.names.evader.length+r),o=s=>{let a=this.#o[n+Math.floor(s/this.#n)];
return Math.floor(a/this.#e.n_actions**(s%this.#n))%this.#e.n_actions};return Array.from({length:this.#e.steps[e][r]},(s,a)=>Uint8Array.from({length:this.#r},(i,l)=>o(
a*this.#r+l)))}play(e,r){return ar(e,this.#e.world,{seed:BigInt(this.#e.match_seed)},this.actions(r))}};var fe=class{element;player=new te(0,{speed:re,still:$e()});replay=null;#e;#r;#n;#t;#o=u("h2",{class:"match-title"});#s=u("p",{class:"tally numbers"});#a=u("ol",
{class:"words","aria-live":"off","aria-label":"What happened in this step"});#l=u("p",{class:"check small","aria-live":"polite"});#c=null;constructor(e,r){[this.#e,
this.#r,this.#n]=[e,r,new pe(e)];let n=u("canvas",{"aria-label":"The match"});this.#t=new he(n,{numbers:!1}),this.element=u("section",{class:"card match-card","\
aria-label":"Match",id:"match"},u("header",{class:"match-head"},this.#o,this.#s),u("div",{class:"stage"},n),nr(this.player),this.#l,tr(),this.#a),this.player.addEventListener(
"frame",()=>this.replay&&this.#t.show(this.replay.recording,this.player.time)),this.player.addEventListener("step",()=>this.#p()),r.on("pair",()=>this.#u()),r.on(
"play",()=>this.#d()),this.#h()}start(e){this.#c=e,this.#u()}#d(){this.replay&&(this.player.jump(0),$e()||this.player.play(),this.element.scrollIntoView({block:"\
nearest"}))}#u(){this.player.pause(),this.#h();let{pair:e}=this.#r;this.#c&&(this.replay=this.#n.has(e)?this.#n.play(this.#c,e):null,this.element.dataset.played=
this.replay?`${e.pursuer} ${e.evader}`:"",this.element.classList.toggle("without-recording",!this.replay),this.player.length=this.replay?.length??0,this.player.
marks=this.replay?gt(this.replay.recording):[],this.player.jump(0),this.#m(),this.#p())}#m(){let{pursuer:e,evader:r}=this.#r.pair;if(!this.replay){this.#l.textContent=
"The page holds no recording of this match: it would be too large.";return}let[n,o]=[this.replay.statistics.capture_rate,this.#e.first[e][r]],s=Math.abs(n-o)<.001;
this.#l.dataset.equal=String(s),this.#l.textContent=s?`Episode 1 of ${this.#e.episodes}: capture rate ${v(n)}, as in the tournament.`:`Episode 1 of ${this.#e.episodes}\
: capture rate ${v(n)}; the tournament had ${v(o)}.`}#h(){let{pursuer:e,evader:r}=this.#r.pair;this.#o.replaceChildren(u("span",{class:"pursuer"},this.#e.names.
pursuer[e])," against ",u("span",{class:"evader"},this.#e.names.evader[r]))}#p(){if(!this.replay){this.#a.replaceChildren(),this.#s.replaceChildren();return}let{
recording:e}=this.replay,r=this.player.step,n=Array.from(e.moments[r].everCaptured).filter(Boolean).length;this.#s.replaceChildren(u("strong",{},n),` of ${this.#e.
world.n_evaders} captured`,u("span",{class:"muted"},` · step ${r}`)),this.#a.replaceChildren(...or(this.replay,e,r).map(o=>u("li",{class:o.kind},o.text)))}};var Q=[[68,1,84],[72,26,108],[71,47,125],[65,68,135],[57,86,140],[49,104,142],[42,120,142],[35,136,142],[31,152,139],[34,168,132],[53,183,121],[84,197,104],[122,
209,81],[165,219,54],[210,226,27],[253,231,37]];function Fe(t){let e=Math.min(1,Math.max(0,t))*(Q.length-1),r=Math.min(Q.length-2,Math.floor(e)),[n,o]=[Q[r],Q[r+
1]],s=a=>Math.round(n[a]+(e-r)*(o[a]-n[a]));return[s(0),s(1),s(2)]}function ir(t){let[e,r,n]=Fe(t).map(o=>((o/255+.055)/1.055)**2.4);return .2126*e+.7152*r+.0722*
n>.179?"#000":"#fff"}var lr=t=>`rgb(${Fe(t).join(" ")})`,cr=()=>`linear-gradient(to right, ${Q.map(t=>`rgb(${t.join(" ")})`).join(", ")})`;function ur(t,e){let r=u("span",{class:"gradient"});return r.style.backgroundImage=cr(),u("p",{class:"scale-of-rates small muted"},t,r,e)}var vn=1e3,xn=14,dr=16,mr=t=>t.length>dr?`${t.slice(0,dr-1)}…`:t,ye=class{element;#e;#r;#n;#t;#o=u("p",{class:"readout numbers","aria-live":"polite"});#s=w("g",
{class:"marks"});#a;constructor(e,r){[this.#e,this.#r]=[e,r],this.#n=e.standings.pursuer.map(({number:n})=>n),this.#t=e.standings.evader.map(({number:n})=>n),this.#a=
this.#l(),this.element=u("section",{class:"card matrix-card","aria-label":"All matches"},u("header",{},u("h2",{},"All matches"),u("p",{class:"small muted"},"Cap\
ture rate; pursuers in rows, evaders in columns, the best ones first. Click a cell to watch its first episode.")),this.#a,ur("0","1"),this.#o),r.on("pair",()=>this.#i()),
r.on("hover",()=>this.#i()),this.#i()}#l(){let[e,r]=[this.#n.length,this.#t.length],n=vn/Math.max(e,r),o=Math.min(26,Math.max(11,.78*n)),s=Mn([...this.#e.names.
pursuer,...this.#e.names.evader].map(mr),o)+12,a=w("svg",{class:"matrix",tabindex:"0",role:"img","aria-label":"Matrix of capture rates; arrow keys choose a matc\
h, Enter plays it",preserveAspectRatio:"xMidYMin meet",viewBox:`${-s} ${-s} ${r*n+s} ${e*n+s}`,onpointermove:l=>this.#r.point(this.#m(l,n)),onpointerleave:()=>this.#r.
point(null),onclick:l=>{let c=this.#m(l,n);c&&this.#r.play(c)},onkeydown:l=>this.#h(l)}),i=this.#n.flatMap((l,c)=>this.#t.map((d,m)=>{let h=this.#e.capture_rate[l][d];
return w("rect",{x:m*n,y:c*n,width:n,height:n,fill:lr(h),"data-pair":`${l} ${d}`})}));return a.append(...i,...this.#c(n),...this.#d("pursuer",n,o),...this.#d("e\
vader",n,o),this.#s),this.#s.dataset.size=String(n),a}#c(e){return Math.max(this.#n.length,this.#t.length)>xn?[]:this.#n.flatMap((r,n)=>this.#t.map((o,s)=>{let a=this.#e.
capture_rate[r][o];return w("text",{x:(s+.5)*e,y:(n+.5)*e,fill:ir(a),"font-size":Math.min(30,.32*e),class:"in-cell"},v(a))}))}#d(e,r,n){return(e==="pursuer"?this.#n:
this.#t).map((s,a)=>{let i=(a+.5)*r,l=e==="pursuer"?{x:-6,y:i,"text-anchor":"end"}:{transform:`translate(${i} -6) rotate(-90)`,"text-anchor":"start"};return w("\
text",{...l,class:`name ${this.#u(e,s).kind}`,"font-size":n,"data-name":`${e} ${s}`},mr(this.#e.names[e][s]))})}#u(e,r){return this.#e.standings[e].find(n=>n.number===
r)}#m(e,r){let n=new DOMPoint(e.clientX,e.clientY).matrixTransform(this.#a.getScreenCTM().inverse()),[o,s]=[this.#n[Math.floor(n.y/r)],this.#t[Math.floor(n.x/r)]];
return o===void 0||s===void 0||n.x<0||n.y<0?null:{pursuer:o,evader:s}}#h(e){let n={ArrowUp:[-1,0],ArrowDown:[1,0],ArrowLeft:[0,-1],ArrowRight:[0,1]}[e.key];if(e.
key==="Enter")this.#r.play(this.#r.pair);else if(n)this.#p(n);else return;e.preventDefault(),e.stopPropagation()}#p([e,r]){let{pursuer:n,evader:o}=this.#r.pair,
s=this.#n[this.#n.indexOf(n)+e],a=this.#t[this.#t.indexOf(o)+r];s!==void 0&&a!==void 0&&this.#r.select({pursuer:s,evader:a})}#i(){let{pair:e,hover:r}=this.#r,n=Number(
this.#s.dataset.size),o=({pursuer:a,evader:i},l)=>w("rect",{class:l,x:this.#t.indexOf(i)*n,y:this.#n.indexOf(a)*n,width:n,height:n});this.#s.replaceChildren(o(e,
"selected-halo"),o(e,"selected"),...r?[o(r,"hovered")]:[]);let s=r??e;for(let a of this.#a.querySelectorAll("[data-name]")){let i=[`pursuer ${s.pursuer}`,`evade\
r ${s.evader}`].includes(a.dataset.name);a.classList.toggle("about",i)}this.#o.replaceChildren(...this.#f(s))}#f({pursuer:e,evader:r}){let{names:n,capture_rate:o,
lowest:s,highest:a,length:i,episodes:l}=this.#e,c=v(o[e][r]),[d,m]=[v(s[e][r]),v(a[e][r])];return[u("span",{},u("span",{class:"pursuer"},n.pursuer[e])," against\
 ",u("span",{class:"evader"},n.evader[r])),u("span",{},u("strong",{},c),u("span",{class:"small muted"},` captured; ${d} to ${m} in ${l} episodes, ${i[e][r].toFixed(
0)} steps on average`))]}};function Mn(t,e){let r=document.createElement("canvas").getContext("2d");return r.font=`700 ${e}px ${getComputedStyle(document.body).
fontFamily}`,Math.max(...t.map(n=>r.measureText(n).width))}var hr=(t,e)=>t?.pursuer===e?.pursuer&&t?.evader===e?.evader,be=class extends EventTarget{#e;#r=null;constructor(e){super(),this.#e=e}get pair(){return this.#e}get hover(){
return this.#r}select(e){hr(e,this.#e)||(this.#e=e,this.dispatchEvent(new Event("pair")))}play(e){this.select(e),this.dispatchEvent(new Event("play"))}point(e){
hr(e,this.#r)||(this.#r=e,this.dispatchEvent(new Event("hover")))}on(e,r){this.addEventListener(e,r)}};var pr={pursuer:"evader",evader:"pursuer"};function De(t,e,r){let n=t.standings[e].map(a=>An(t,e,a,r)),o=e==="pursuer"?"Mean capture rate":"Mean escape rate",s=[
"Rank","Name","Score","Best, worst"];return u("section",{class:"card standings","aria-label":`Standings of ${e}s`},u("header",{},u("h2",{},u("span",{class:e},`${e[0].
toUpperCase()}${e.slice(1)}s`)),u("p",{class:"small muted"},`${o} against ${t.names[pr[e]].length} opponents, with 95 % interval`)),u("div",{class:"scroll",tabindex:"\
0"},u("table",{},u("thead",{},u("tr",{},...s.map(a=>u("th",{scope:"col"},a)))),u("tbody",{},...n))))}function An(t,e,r,n){let{kind:o,name:s,file:a,rank:i,number:l}=r,
c=u("tr",{class:o,"data-number":l},u("td",{class:"rank numbers"},i||"–"),u("th",{scope:"row",title:a},u("span",{class:"who",title:s},s),u("span",{class:"kind \
small muted"},o)),u("td",{class:"numbers score"},_n(r,e),Sn(r)),u("td",{class:"matches"},...["best","worst"].map(m=>Tn(t,e,r,m,n)))),d=()=>{c.classList.toggle("\
about",l===(n.hover??n.pair)[e])};return n.on("pair",d),n.on("hover",d),d(),c}function Sn({score:t,low:e,high:r}){let n=e===null||r===null?"":`${v(e)} – ${v(r)}`;
return u("span",{class:"score-text"},u("strong",{},v(t)),u("span",{class:"small muted"},n))}function _n({score:t,low:e,high:r},n){let[o,s]=[u("span",{class:`fil\
led of-${n}`}),u("span",{class:"whisker"})];return o.style.width=`${100*t}%`,e!==null&&r!==null&&(s.style.left=`${100*e}%`,s.style.width=`${100*(r-e)}%`),u("spa\
n",{class:"bar","aria-hidden":"true"},o,s)}function Tn(t,e,r,n,o){let s=r[n],a=e==="pursuer"?{pursuer:r.number,evader:s}:{pursuer:s,evader:r.number},i=t.names[pr[e]][s],
l=t.capture_rate[a.pursuer][a.evader],c=v(e==="pursuer"?l:1-l);return u("button",{type:"button",class:"to-match",title:`Watch the ${n} match: against ${i}, ${c}`,
"aria-label":`Watch the ${n} match of ${r.name}: against ${i}, ${c}`,onclick:()=>o.play(a)},n==="best"?"▲ ":"▼ ",i)}function fr({votes:t}){let e=Object.keys(
t);if(!e.length)return[];let r=e.map(n=>{let o=Object.entries(t[n]),s=o.reduce((i,[,l])=>i+l,0),a=o.map(([i,l])=>{let c=u("span",{class:"filled"});return c.style.
width=`${100*l/s}%`,u("div",{class:"vote"},u("span",{},i),u("span",{class:"bar","aria-hidden":"true"},c),u("span",{class:"numbers"},`${l} of ${s}`))});return u(
"tr",{},u("th",{scope:"row"},n),u("td",{},...a))});return[u("section",{class:"card votes","aria-label":"Predictions"},u("header",{},u("h2",{},"How the class vot\
ed"),u("p",{class:"small muted"},"Predictions of the course: the first choice of each student, before the experiment.")),u("table",{},u("tbody",{},...r)))]}function yr(t){
if(!t.length)return[];let e=t.map(({file:r,reason:n})=>u("div",{class:"refusal"},u("dt",{},r),u("dd",{},n)));return[u("section",{class:"card refused","aria-labe\
l":"Refused"},u("header",{},u("h2",{},`Refused (${t.length})`),u("p",{class:"small muted"},"These did not play, or broke a rule while they played; their matches\
 count for no one.")),u("dl",{},...e))]}var S=yt(),[Cn]=S.standings.pursuer,ge=new be({pursuer:Cn.number,evader:S.standings.evader[0].number}),B=new fe(S,ge);function En({world:t,episodes:e,seed:r,matrixworld:n}){
return`${t.n_pursuers} pursuers and ${t.n_evaders} evaders on ${t.rows} x ${t.cols} cells, at most ${t.max_steps} steps · ${e} episodes a pair · seed ${r} · m\
atrixworld ${n}`}var kn=["Every pursuer played every evader from the same starts. A score is a mean over all opponents, scripts included. Scripts are the packag\
e's own policies, for comparison; they have no rank.","A rank such as 2 to 5 means that these episodes cannot tell which of these ranks is the true one: the dif\
ference to some others is within chance. Each range misses the true rank with a probability of at most 5 %.","Keys: Space plays, ← and → step, D changes light a\
nd dark; in the matrix arrow keys choose a match and Enter plays it."];document.getElementById("page").replaceWith(u("header",{class:"top"},u("div",{},u("h1",{},
S.title),u("p",{class:"muted small about"},En(S))),u("div",{class:"tools"},pt())),u("main",{class:"stages"},u("div",{class:"tables"},De(S,"pursuer",ge),De(S,"ev\
ader",ge)),new ye(S,ge).element,B.element),...fr(S),...yr(S.refusals),u("section",{class:"card reading","aria-label":"How to read this page"},u("h2",{},"How to \
read this page"),...kn.map(t=>u("p",{},t))));document.addEventListener("keydown",t=>{let e=t.target instanceof HTMLSelectElement||t.target instanceof HTMLInputElement,
r=t.target instanceof HTMLButtonElement&&(t.key===" "||t.key==="Enter");if(!(e||r||t.defaultPrevented||t.ctrlKey||t.metaKey||t.altKey)){if(t.key.toLowerCase()===
"d")Ee();else if(!oe(B.player,t))return;t.preventDefault()}});Object.assign(window,{matrixworldClass:{get replay(){return B.replay},get step(){return B.player.step}}});
requestAnimationFrame(()=>setTimeout(()=>{mt().then(t=>{B.start(t),document.body.dataset.ready="true"},t=>{B.element.prepend(u("p",{class:"problem",role:"alert"},
`The engine does not start here: ${String(t)}`)),document.body.dataset.ready="true"})}));})();
