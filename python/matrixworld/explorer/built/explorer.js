/* built from web/ by "npm run build"; sources 3a8972c4b244ce1337c5667ecb5d45509ccc55f91a3dc234c3aba507b92595a3 */
"use strict";(()=>{var Vt={SIMULTANEOUS:0,SWARM_TURNS:1,AGENT_TURNS:2},fe={DISAPPEAR:0,REACH:1,BOUNCE:2},Kt={OCCUPATION:0,SURROUND:1},Yt={FAULT:0,INVOLVED:1};var pt=["obstacle","teammate","adversary"],ht=["vertex","edge","chain"],qt=["turn","kind","form","first","second","row","col","at_fault","held","doomed"],ft=["p\
ursuer_{number}","evader_{number}"],Jt={obstacle:"{first} ran into the obstacle or border at {cell}",vertex:"{first} and {second} both headed for {cell}",edge:"\
{first} and {second} meant to swap, {first} to {cell}",chain:"{first} headed for {cell}, where {second} had to stay"},ye={"both held":"both bounce","both doomed":"\
both disappear",held:"{agent} bounces",doomed:"{agent} disappears",none:"nobody is stopped"},Xt="{event}: {outcome}",yt={random:"any action, all equally likely",
still:"always stays",chaser:"moves to where the nearest adversary in view is nearest",fleer:"moves to where the nearest adversary in view is farthest","clumsy-c\
haser":"a chaser that takes any action in half of the steps",hunter:"a chaser of the nearest adversary in view to which no teammate in view is nearer",surrounder:"\
a chaser of the nearest free cell beside an adversary without a teammate","clumsy-fleer":"a fleer that takes any action in half of the steps",dodger:"moves to w\
here all adversaries in view together are farthest"},Zt={free:".GS",blocked:"#@OTW"};var Q=1+qt.length;function ge(t,e){return t.replace(/\{(\w+)\}/g,(r,n)=>String(e[n]))}function gt(t,e){return t<e?ge(ft[0],{number:t}):ge(ft[1],{number:t-e})}function ho(t,e){
let[r,n,o,s,a,i,l,...d]=Array.from(t),u=a<0?[s]:[s,a],[m,p,h]=d.map(w=>u.filter((A,g)=>w>>g&1)),y=u.map(w=>gt(w,e)),f=ge(Jt[a<0?"obstacle":ht[o]],{first:y[0],second:y[y.
length-1],cell:`(${i}, ${l})`}),v=ge(Xt,{event:f,outcome:fo(u.length,p,h,e)});return{kind:pt[n],form:ht[o],agents:u,cell:[i,l],at_fault:m,held:p,doomed:h,turn:r,
text:v}}function fo(t,e,r,n){if(t===2&&e.length===2)return ye["both held"];if(t===2&&r.length===2)return ye["both doomed"];let o=s=>a=>ge(ye[s],{agent:gt(a,n)});
return[...e.map(o("held")),...r.map(o("doomed"))].join(", ")||ye.none}function Ne(t,e){let r=[];for(let n=0;n<t.length;n+=Q)r.push(ho(t.subarray(n+1,n+Q),e));return r}var L=class extends Error{name="EngineError"};function M(t,e,r){let n=typeof r=="string"?`'${r}'`:typeof r=="object"?JSON.stringify(r):String(r);return new L(`${t}\
: expected ${e}, got ${n}`)}var ee=class{bytes;constructor(e){this.bytes=e}},tr=0,vt=[Uint8Array,Uint8Array,Int32Array,BigInt64Array,BigUint64Array,Float32Array,Float64Array],Qt=4,er=4,yo=new TextEncoder,
go=new TextDecoder;function bo(t){for(let e=vt.length-1;e>tr;--e)if(t instanceof vt[e])return e;throw new TypeError("array: expected a typed array of the engine\
's numbers, got another")}function bt(t){return new Uint8Array(t.buffer,t.byteOffset,t.byteLength)}function vo(t){return yo.encode(`${t}\0`)}var wt=class{engine;addresses=[];constructor(e){
this.engine=e}copy(e){let r=this.engine._malloc(Math.max(e.length,1));if(r===0)throw new L("memory: expected room for the arguments, got none");return this.addresses.
push(r),this.engine.HEAPU8.set(e,r),r}text(e){return this.copy(vo(e))}arrays(e){let r=Object.entries(e),n=r.flatMap(([s,a])=>{let i=a instanceof ee,l=i?a.bytes:
a;return[this.text(s),i?tr:bo(l),l.length,this.copy(bt(l))]}),o=this.copy(bt(Int32Array.from(n)));return this.copy(bt(Int32Array.of(r.length,o)))}free(){for(let e of this.
addresses)this.engine._free(e)}};function rr(t,e){let r=t.HEAPU8;return go.decode(r.subarray(e,r.indexOf(0,e)))}function Ie(t){let e=new Int32Array(t.HEAPU8.buffer),
r=t._last_outputs()/Qt,n=e[r+1]/Qt,o={};for(let s=n;s<n+e[r]*er;s+=er){let a=vt[e[s+1]],i=e[s+2]*a.BYTES_PER_ELEMENT,l=e[s+3];o[rr(t,e[s])]=new a(t.HEAPU8.slice(
l,l+i).buffer)}return o}function be(t,e){let r=new wt(t);try{let n=e(r);if(n===0)throw new L(rr(t,t._last_error()));return n}finally{r.free()}}var wo=2**31-1,xo=2n**64n-1n,So=34028234663852886e22;function D(t,e){if(typeof e!="number"||!Number.isInteger(e)||Math.abs(e)>wo)throw M(t,"an integer",e);return Int32Array.
of(e)}function Ue(t,e){if(typeof e!="boolean")throw M(t,"true or false",e);return new ee(Uint8Array.of(Number(e)))}function K(t,e,r){let n=typeof e=="string"&&Object.
hasOwn(r,e)?r[e]:void 0;if(n===void 0)throw M(t,`one of ${Object.keys(r).join(", ")}`,e);return Int32Array.of(n)}function xt(t,e){if(typeof e!="number"||!(Math.
abs(e)<=So))throw M(t,"a finite number",e);return e}function te(t,e){let n=typeof e=="bigint"||typeof e=="number"&&Number.isSafeInteger(e)?BigInt(e):-1n;if(n<0n||
n>xo)throw M(t,"an integer from 0 to 2^64 - 1",e);return BigUint64Array.of(n)}function Ao(t){return{"rules.interaction":K("interaction",t.interaction,Vt),"rules\
.obstacle":K("obstacle",t.obstacle,fe),"rules.teammate":K("teammate",t.teammate,fe),"rules.evader":K("evader",t.evader,fe),"rules.pursuer":K("pursuer",t.pursuer,
fe),"rules.capture":K("capture",t.capture,Kt),"rules.captured_disappear":Ue("captured_disappear",t.captured_disappear)}}function nr(t,e){let r=typeof e=="number"?
[e,e,e]:e;if(!Array.isArray(r)||r.length!==3)throw M(t,"1 or 3 numbers",e);return Float32Array.from(r,n=>xt(t,n))}function Mo(t){let e=(r,n)=>Float32Array.of(xt(
r,t[r]),xt(n,t[n]));return{"rewards.capture":e("pursuer_capture","evader_capture"),"rewards.neighbor":e("pursuer_neighbor","evader_neighbor"),"rewards.step":e("\
pursuer_step","evader_step"),"rewards.pursuer_collide":nr("pursuer_collide",t.pursuer_collide),"rewards.evader_collide":nr("evader_collide",t.evader_collide),"r\
ewards.blame":K("blame",t.blame,Yt),"rewards.capture_repeats":Ue("capture_repeats",t.capture_repeats)}}function sr(t){if(t===void 0||typeof t=="number")return new Uint8Array(
0);if(t instanceof Uint8Array)return t;let{free:e,blocked:r}=Zt;for(let[n,o]of t.entries()){if(o.length!==t[0]?.length)throw M(`map, row ${n}`,`${t[0]?.length} \
cells as in row 0`,o.length);let s=[...o].find(a=>!e.includes(a)&&!r.includes(a));if(s)throw M(`map, row ${n}`,`'${e}' (free) or '${r}' (obstacle)`,s)}return Uint8Array.
from([...t.join("")],n=>Number(r.includes(n)))}function ar(t,e){if(!Array.isArray(t))return;let r=[t.length,t[0]?.length??0];if(!(r[0]===e.rows&&r[1]===e.cols))
throw M("obstacle map",`shape (${e.rows}, ${e.cols}), the rows and cols`,r)}function Be(t){ar(t.obstacles,t);let e=typeof t.obstacles=="number"?t.obstacles:0;return{
...Ao(t.rules),...Mo(t.rewards),rows:D("rows",t.rows),cols:D("cols",t.cols),n_pursuers:D("n_pursuers",t.n_pursuers),n_evaders:D("n_evaders",t.n_evaders),fov:D("\
fov",t.fov),diagonal:Ue("diagonal",t.diagonal),max_steps:D("max_steps",t.max_steps),density:Float64Array.of(e),map:sr(t.obstacles)}}function or(t,e){return Int32Array.
from((e??[]).flat(),r=>D(t,r)[0])}function ir(t,e){return ar(t.obstacles,e),{seed:te("seed",t.seed??0n),episode:te("episode",t.episode??0),pursuers:or("pursuers",
t.pursuers),evaders:or("evaders",t.evaders),map:sr(t.obstacles)}}function De(t){return{actions:Int32Array.from(t,e=>D("actions",e)[0])}}function re(t){if(typeof t==
"string"){if(!Object.hasOwn(yt,t))throw M("policy",`one of ${Object.keys(yt).join(", ")}`,t);return{script:new TextEncoder().encode(t)}}if(t.activation!=="relu"&&
t.activation!=="tanh")throw M("activation","'relu' or 'tanh'",t.activation);return{hidden:Int32Array.from(t.hidden,e=>D("hidden",e)[0]),activation:new TextEncoder().
encode(t.activation),sampled:Ue("sampled",t.sampled),genome:t.genome}}var Eo=["first_turn","terminated","truncated"];function lr(t){let e={...t};for(let r of Eo)
e[r]=new ee(t[r]);return e}var We=class{config;seed;episode;n_agents;statistics;positions;last_positions;alive;captured;ever_captured;actions;rewards;involved;fault;map;conflict_table;first_conflict;constructor(e,r,n,o){
this.config=e,this.seed=r,this.episode=n,this.n_agents=e.n_pursuers+e.n_evaders,this.statistics=cr(o,0),this.positions=o.positions,this.last_positions=o.last_positions,
this.alive=o.alive,this.captured=o.captured,this.ever_captured=o.ever_captured,this.actions=o.actions,this.rewards=o.rewards,this.involved=o.involved,this.fault=
o.fault,this.map=o.map,this.conflict_table=o.conflict_table,this.first_conflict=Co(this.conflict_table,this.length)}get length(){return this.actions.length/this.
n_agents}conflicts(e){this.check(e);let[r,n]=[this.first_conflict[e],this.first_conflict[e+1]],o=this.conflict_table.subarray(r*Q,n*Q);return Ne(o,this.config.n_pursuers)}seek(e,r){
this.check(r),(!(e.seed===this.seed&&e.episode===BigInt(this.episode))||e.turn!==0||e.steps>r)&&e.reset({seed:this.seed,episode:this.episode});for(let o=e.steps;o<
r;++o)e.step(this.actions.subarray(o*this.n_agents,(o+1)*this.n_agents))}check(e){if(!(Number.isInteger(e)&&e>=0&&e<=this.length))throw M("step",`0 to ${this.length}`,
e)}};function Co(t,e){let r=new Int32Array(e+2);for(let n=0;n<t.length;n+=Q)++r[t[n]+1];for(let n=1;n<r.length;++n)r[n]+=r[n-1];return r}function cr(t,e){let r=t["\
statistics.length"].length,n=s=>{let a=t[`statistics.${s}`],i=a.length/r;return a.slice(e*i,(e+1)*i)},o=s=>Number(n(s)[0]);return{capture_rate:o("capture_rate"),
ever_capture_rate:o("ever_capture_rate"),captured_fraction:o("captured_fraction"),length:o("length"),return:n("return"),survivors:n("survivors"),overlap:n("over\
lap"),collisions:n("collisions"),faults:n("faults"),agent_steps:n("agent_steps")}}function dr(t,e,r,n){let o=[Be(r.config),re(r.pursuers),re(r.evaders),n];return be(
t,s=>{let[a,i,l,d]=o.map(u=>s.arrays(u));return t[e](a,i,l,d)}),Ie(t)}function ur(t,e,r,n){let o={seed:te("seed",r),episode:te("episode",n)};return new We(e.config,
r,n,dr(t,"_play_match",e,o))}function mr(t,e,r,n){if(!Number.isInteger(n)||n<1)throw M("n_episodes","at least 1",n);let o={seed:te("seed",r),n_episodes:Int32Array.
of(n)},s=dr(t,"_play_rollout",e,o);return Array.from({length:n},(a,i)=>cr(s,i))}var pr=new FinalizationRegistry(([t,e])=>t._world_free(e)),ve=class{config;n_agents;n_actions;engine;at;freed=!1;constructor(e,r){this.engine=e,this.config=r,this.
n_agents=r.n_pursuers+r.n_evaders,this.n_actions=r.diagonal?9:5,this.at=be(e,n=>e._world_new(n.arrays(Be(r)))),pr.register(this,[e,this.at],this)}free(){this.freed||
(this.freed=!0,pr.unregister(this),this.engine._world_free(this.at))}reset(e={}){let r=ir(e,this.config);this.call(n=>this.engine._world_reset(this.at,n.arrays(
r)))}step(e){let r=De(e);this.call(n=>this.engine._world_step(this.at,n.arrays(r)))}playTurn(e){let r=De(e);this.call(n=>this.engine._world_play_turn(this.at,n.
arrays(r)))}decide(e,r,n){let{n_pursuers:o}=this.config,s={pursuer:[0,o],evader:[o,this.n_agents]},[a,i]=typeof r=="string"?s[r]:r;if(n.length!==this.n_agents)throw M(
"actions",String(this.n_agents),n.length);let l=[re(e),De(n)],{actions:d}=this.call(u=>this.engine._world_decide(this.at,u.arrays(l[0]),a,i,u.arrays(l[1])));return Uint8Array.
from(d)}get n_turns(){return this.turnNumbers()[1]}get turn(){return this.turnNumbers()[0]}get actors(){let[,,e,r]=this.turnNumbers();return[e,r]}turnNumbers(){
return this.call(()=>this.engine._world_turn(this.at)).turn}get steps(){return this.read("steps")[0]}get seed(){return this.read("seed")[0]}get episode(){return this.
read("episode")[0]}get over(){return this.read("terminated")[0]===1||this.read("truncated")[0]===1}read(e){return this.call(r=>this.engine._world_read(this.at,r.
text(e)))[e]}view(e){let r=3*this.config.fov**2;return this.read("views").slice(e*r,(e+1)*r)}map(){return this.read("state").slice(2*this.config.rows*this.config.
cols)}conflicts(){return Ne(this.conflictTable(),this.config.n_pursuers)}conflictTable(){return this.call(()=>this.engine._world_conflicts(this.at)).conflict_table}answer(e,r){
let n=re(e),{logits:o}=this.call(i=>this.engine._world_logits(this.at,i.arrays(n),r)),s=o,a=this.decide(e,[r,r+1],new Uint8Array(this.n_agents))[r];return{logits:s,
probabilities:To(s),action:a}}snapshot(){return this.call(()=>this.engine._world_snapshot(this.at))}restore(e){let r=lr(e);this.call(n=>this.engine._world_restore(
this.at,n.arrays(r)))}call(e){if(this.freed)throw M("world","one that is in use","one that was freed");return be(this.engine,e),Ie(this.engine)}};function To(t){
let e=Math.max(...t),r=Array.from(t,o=>Math.exp(o-e)),n=r.reduce((o,s)=>o+s,0);return Float32Array.from(r,o=>o/n)}var St=class{compiled;constructor(e){this.compiled=e}world(e){return new ve(this.compiled,e)}match(e,r,n,o,s=0){return ur(this.compiled,{config:e,pursuers:r,evaders:n},
o,s)}rollout(e,r,n,o,s){return mr(this.compiled,{config:e,pursuers:r,evaders:n},o,s)}},hr;function fr(t=globalThis.matrixworldEngine){return hr??=_o(t),hr}async function _o(t){
if(!t)throw new Error("matrixworldEngine: expected the script engine.js before this one, got none");let e=Uint8Array.from(atob(t.binary),r=>r.charCodeAt(0));return new St(
await t({wasmBinary:e}))}var ko="http://www.w3.org/2000/svg";function c(t,e={},...r){return yr(document.createElement(t),e,r)}function b(t,e={},...r){return yr(document.createElementNS(
ko,t),e,r)}function yr(t,e,r){for(let[n,o]of Object.entries(e))o==null||o===!1||(typeof o=="function"?t.addEventListener(n.slice(2),o):t.setAttribute(n,o===!0?"":
String(o)));return t.append(...r.filter(Ro).map(n=>typeof n=="number"?String(n):n)),t}function Ro(t){return t!=null&&t!==!1}var $o=matchMedia("(prefers-color-scheme: dark)");function Po(){let t=document.documentElement.dataset.theme;return t?t==="dark":$o.matches}function At(){document.
documentElement.dataset.theme=Po()?"light":"dark"}function gr(){return c("button",{type:"button",title:"Light or dark (D)","aria-label":"Light or dark",onclick:At},"◐")}var Oo=2n**64n-1n;function we(t,e,r){let n=new URLSearchParams(t.replace(/^#/,"")),o=(d,u,m)=>{let p=n.get(d)??"";return/^\d{1,9}$/.test(p)&&Number(p)<u?Number(
p):m},s=o("run",e.length,r.run),[a,i]=e[s].payoff.shape,l=n.get("seed")??"";return{run:s,pursuer:o("pursuers",a,Math.min(r.pursuer,a-1)),evader:o("evaders",i,Math.
min(r.evader,i-1)),episode:o("episode",1/0,r.episode),seed:/^\d{1,20}$/.test(l)&&BigInt(l)<=Oo?l:null,step:o("step",1/0,0)}}function br(t,e,r){let n="",o=()=>{let{
run:s,pursuer:a,evader:i,episode:l,seed:d}=e.selected,u={run:s,pursuers:a,evaders:i,episode:l,...d===null?{}:{seed:d},step:r.player.step};n=`#${Object.entries(u).
map(([m,p])=>`${m}=${p}`).join("&")}`;try{history.replaceState(null,"",n)}catch{}};e.on("match",o),r.player.addEventListener("state",()=>r.player.playing||o()),
r.player.addEventListener("step",()=>r.player.playing||o()),window.addEventListener("hashchange",()=>{if(location.hash===n)return;let{step:s,...a}=we(location.hash,
t,e.selected);e.select(a),r.goTo(s)})}var ne=["pursuer","evader"];function wr(){return JSON.parse(Fe("data"))}function xe(t,e,r){let[n,o]=[e-t.payoff.first[0],r-t.payoff.first[1]],s=t.payoff.capture_rate[n]?.[o];
return s===void 0?null:{rate:s,rates:t.payoff.capture_rates[n][o],lengths:t.payoff.lengths[n][o]}}function Y(t,e,r){let{script:n,network:o,kept:s,genomes:a}=t.teams[e];
if(n!==null||o===null)return"";if(!s.includes(r))return`The page holds no genome of ${e}s ${r}: it would be too large. Choose a generation of ${s.join(", ")}.`;
let i=s.length*o.genome_size;return xr(a).length===i?"":`The page is damaged: it does not hold the ${i} numbers of the ${e}s' genomes. Write it again from its r\
un.`}function k(t,e,r){let{script:n,network:o,kept:s,genomes:a}=t.teams[e];if(n!==null||o===null)return n??"random";let i=s.indexOf(r);if(i<0)throw new RangeError(
`${e}: expected a generation whose genome the page holds, got ${r}`);let l=o.genome_size,d=xr(a).subarray(i*l,(i+1)*l);return{hidden:o.hidden,activation:o.activation,
sampled:o.sampled,genome:d}}var vr=new Map;function xr(t){let e=vr.get(t);if(e)return e;let r=new Float32Array;try{let n=new Float32Array(Mt(t).buffer);n.every(
Number.isFinite)&&(r=n)}catch(n){if(!(n instanceof DOMException||n instanceof RangeError))throw n}return vr.set(t,r),r}function Mt(t){let e=atob(Fe(t)),r=new Uint8Array(
e.length);for(let n=0;n<r.length;n++)r[n]=e.charCodeAt(n);return r}function Fe(t){return document.getElementById(t)?.textContent??""}var Lo={now:()=>performance.now(),request:t=>requestAnimationFrame(t),cancel:t=>cancelAnimationFrame(t)},Se=[.5,1,2,4,8,16,32,64],oe=0,Et=12,No=2,W=class extends EventTarget{#e;#n;#o;#a;#r=0;#t=0;#i=!1;#d=null;#u=0;#l=[];glide=.28;constructor(e,r={}){
super(),this.#e=e,this.#n=r.speed??4,this.#a=r.still??!1,this.#o=r.clock??Lo}get step(){return this.#r}get time(){return this.#a?this.#r:this.#t}get arrived(){return this.#t===
this.#r}get playing(){return this.#i}get length(){return this.#e}set length(e){this.#e=e,this.#r>e&&this.jump(e),this.#m("state")}get marks(){return this.#l}set marks(e){
this.#l=e,this.#m("state")}get pace(){return this.#n||Math.max(No,this.#e/Et)}get speed(){return this.#n}set speed(e){this.#n=e,this.#m("state")}changeSpeed(e){
let r=Se.findIndex(n=>n>=this.pace);this.speed=Se[Math.min(Se.length-1,Math.max(0,r+e))]}play(){this.#i||!this.#e||(this.#r===this.#e&&this.jump(0),this.#i=!0,this.#m(
"state"),this.#s())}pause(){this.#i&&(this.#i=!1,this.#m("state"))}toggle(){this.#i?this.pause():this.play()}move(e){this.pause();let r=Math.min(this.#e,Math.max(
0,this.#r+e));Math.abs(r-this.#t)>1?this.jump(r):this.#c(r),this.#s()}jump(e){this.#t=Math.min(this.#e,Math.max(0,Math.round(e))),this.#c(this.#t),this.#m("fram\
e")}#c(e){e!==this.#r&&(this.#r=e,this.#m("step"),this.#a&&this.#m("frame"))}#s(){this.#d===null&&(this.#u=this.#o.now(),this.#d=this.#o.request(()=>this.#h()))}#h(){
this.#d=null;let e=this.#o.now();this.#f(Math.min(.25,(e-this.#u)/1e3)),this.#u=e,(!this.#a||this.arrived)&&this.#m("frame"),(this.#i||this.#t!==this.#r)&&(this.#d=
this.#o.request(()=>this.#h()))}#f(e){let r=e;for(;r>0;){if(this.#t===this.#r){if(!this.#i)return;if(this.#r===this.#e)return this.pause();this.#c(this.#r+1)}let n=this.#i?
this.pace:1/this.glide,o=this.#r-this.#t,s=Math.min(Math.abs(o),r*n);r-=s/n,this.#t=s===Math.abs(o)?this.#r:this.#t+Math.sign(o)*s}this.#i&&this.#t===this.#e&&this.
pause()}#m(e){this.dispatchEvent(new Event(e))}};function j(t,e){if(e.ctrlKey||e.metaKey||e.altKey)return!1;let r=e.shiftKey?10:1,o={" ":()=>t.toggle(),ArrowRight:()=>t.
move(r),ArrowLeft:()=>t.move(-r),Home:()=>t.move(-t.length),End:()=>t.move(t.length),"+":()=>t.changeSpeed(1),"-":()=>t.changeSpeed(-1)}[e.key];return o?.(),o!==
void 0}var Ae=[[68,1,84],[72,26,108],[71,47,125],[65,68,135],[57,86,140],[49,104,142],[42,120,142],[35,136,142],[31,152,139],[34,168,132],[53,183,121],[84,197,104],[122,
209,81],[165,219,54],[210,226,27],[253,231,37]];function se(t){let e=Math.min(1,Math.max(0,t))*(Ae.length-1),r=Math.min(Ae.length-2,Math.floor(e)),[n,o]=[Ae[r],
Ae[r+1]],s=a=>Math.round(n[a]+(e-r)*(o[a]-n[a]));return[s(0),s(1),s(2)]}function Sr(t){let[e,r,n]=se(t).map(o=>((o/255+.055)/1.055)**2.4);return .2126*e+.7152*r+
.0722*n>.179?"#000":"#fff"}var Ar=t=>`rgb(${se(t).join(" ")})`,Mr=()=>`linear-gradient(to right, ${Ae.map(t=>`rgb(${t.join(" ")})`).join(", ")})`;function He(t,e,r){let n=devicePixelRatio||1;t.style.left=`${r.left}px`,t.style.top=`${r.top}px`,t.style.width=`${r.width}px`,t.style.height=`${r.height}px`,t.width=
Math.round(r.width*n),t.height=Math.round(r.height*n);let o=t.getContext("2d"),s=Io(e);!o||!s||(o.imageSmoothingEnabled=!1,o.drawImage(s,0,0,t.width,t.height))}
function Io(t){let[e,r]=t.shape,n=document.createElement("canvas");[n.width,n.height]=[r,e];let o=n.getContext("2d");if(!o)return null;let s=o.createImageData(r,
e);return t.capture_rate.forEach((a,i)=>a.forEach((l,d)=>{let u=4*((e-1-i-t.first[0])*r+d+t.first[1]);s.data.set([...se(l),255],u)})),o.putImageData(s,0,0),n}var Uo=84;function Er(t,e){let r=t.map((s,a)=>Bo(s,a,e)),n=c("nav",{class:"races","aria-label":"Runs"},...r.map(s=>s.button)),o=()=>r.forEach((s,a)=>s.update(a===
e.selected.run));return e.on("match",o),e.on("hover",o),o(),n.hidden=t.length<2,n}function Bo(t,e,r){let[n,o]=t.payoff.shape,s=!t.name.startsWith(t.schedule),a=Uo/
Math.max(n,o),i=c("canvas",{"aria-hidden":"true"});He(i,t.payoff,{left:0,top:0,width:o*a,height:n*a});let l=c("span",{class:"place"}),d=c("button",{type:"button",
class:"race",title:`${t.name} (key ${e+1})`,onclick:()=>Ct(t,e,r)},c("span",{class:"small-matrix"},i,l),c("span",{class:"race-text"},c("strong",{},s?t.name:t.schedule),
c("span",{class:"small"},t.findings?t.findings.headline:`${t.learning.join(" and ")}s against ${Do(t)}`),c("span",{class:"small muted"},`${s?`${t.schedule}, `:""}\
seed ${t.seed}`)));return{button:d,update:m=>{d.setAttribute("aria-current",String(m));let p=r.hover.pursuer??r.selected.pursuer,h=r.hover.evader??r.selected.evader;
l.hidden=p>=n||h>=o,l.style.left=`${(h+.5)*a}px`,l.style.top=`${(n-p-.5)*a}px`}}}var Do=t=>t.teams.pursuer.script??t.teams.evader.script??"another run";function Ct(t,e,r){
let[n,o]=t.payoff.shape,{pursuer:s,evader:a}=r.selected;r.select({run:e,pursuer:Math.min(s,n-1),evader:Math.min(a,o-1)})}var Wo=[[["Space"],"play or pause"],[["←","→"],"step back or forward; with Shift ten steps"],[["Home","End"],"first or last step"],[["+","−"],"faster or s\
lower"],[["N"],"next episode of the same pair; with Shift the one before"],[["R"],"another seed, not one of the evaluation"],[["O"],"the cell's own seed again"],
[["P"],"next pursuer generation; with Shift the one before"],[["E"],"next evader generation; with Shift the one before"],[["M"],"to the matrix: arrow keys choos\
e a match, Enter plays it"],[["A"],"next agent: what it sees; with Shift the one before"],[["Esc"],"no agent"],[["T"],"take over the chosen agent, or an evader,\
 from this step on"],[["G"],"this step in the playground: any other rules, actions and places"],[["1","9"],"first to ninth run"],[["D"],"light or dark"],[["?"],
"this list"]];function Cr(){let t=Wo.map(([r,n])=>c("div",{class:"key-row"},c("dt",{},...r.map(o=>c("kbd",{},o))),c("dd",{},n))),e=c("dialog",{class:"help","ari\
a-labelledby":"help-title"},c("h2",{id:"help-title"},"Keys"),c("dl",{class:"keys"},...t),c("p",{class:"muted small"},"The page holds the genomes and the engine \
of this run. A click on a cell plays that very match: same seed, same moves. The page loads nothing from elsewhere; share the file as it is."),c("button",{type:"\
button",onclick:()=>e.close()},"Close"));return e.addEventListener("click",r=>r.target===e&&e.close()),e}function Tr(t,e,r,n,o,s){let a=(l,d)=>()=>{let u=t[e.selected.
run].payoff.shape[l==="pursuer"?0:1];e.select({[l]:Math.min(u-1,Math.max(0,e.selected[l]+d))})},i={n:()=>e.select({episode:e.selected.episode+1}),N:()=>e.select(
{episode:Math.max(0,e.selected.episode-1)}),r:()=>e.select({seed:String(crypto.getRandomValues(new BigUint64Array(1))[0]),episode:0}),o:()=>e.select({seed:null,
episode:0}),p:a("pursuer",1),P:a("pursuer",-1),e:a("evader",1),E:a("evader",-1),m:()=>document.getElementById("matrix")?.focus(),a:()=>r.inspector.next(1),A:()=>r.
inspector.next(-1),Escape:()=>r.inspector.choose(null),t:o,g:s,d:At,"?":()=>n.showModal()};document.addEventListener("keydown",l=>{let d=l.target instanceof HTMLSelectElement||
l.target instanceof HTMLInputElement,u=l.target instanceof HTMLButtonElement&&(l.key===" "||l.key==="Enter");if(document.querySelector("dialog[open]")||d||u||l.
defaultPrevented||l.ctrlKey||l.metaKey||l.altKey)return;let m=i[l.key]??i[l.key.toLowerCase()],p=Number(l.key)-1;if(j(r.player,l)||m)m?.();else if(t[p])Ct(t[p],
p,e);else return;l.preventDefault()})}var ae=[[0,0],[-1,0],[0,1],[1,0],[0,-1],[-1,1],[1,1],[1,-1],[-1,-1]];function _r(t,e,r){let[n,o]=[e[0]-t[0],e[1]-t[1]];return!r&&Math.abs(n)>Math.abs(o)?o=0:r||
(n=0),ae.findIndex(([s,a])=>s===Math.sign(n)&&a===Math.sign(o))}var q=(t,e)=>e<t.nPursuers,S=(t,e)=>[t.positions[2*e],t.positions[2*e+1]],Fo=(t,e)=>t[0]===e[0]&&
t[1]===e[1],Tt=({rows:t,cols:e},[r,n])=>r>=0&&n>=0&&r<t&&n<e,_t=(t,e,r=3)=>t!==void 0&&[0,1,2].slice(0,r).some(n=>t[3*e+n]),kt=(t,e)=>_t(t.fault,e),kr=(t,e)=>!kt(
t,e)&&_t(t.involved,e,2);function je(t,e,r){let n=!Fo(S(t,r),S(e,r)),o=e.involved===void 0||_t(e.involved,r);return!!(e.alive[r]&&e.actions?.[r]&&!n&&o)}function Ge(t,e,r){
let[n,o]=S(t,r),[s,a]=ae[e.actions?.[r]??0];return[n+s,o+a]}function Me(t,e,r){return Array.from({length:r.everCaptured.length},(o,s)=>s).filter(o=>r.everCaptured[o]&&
!e.everCaptured[o]).map(o=>t.nPursuers+o)}var Rr=t=>t.moments.flatMap((e,r)=>r&&Me(t,t.moments[r-1],e).length?[r]:[]);function ze(t,e){return Array.from({length:e.
alive.length},(n,o)=>o).filter(n=>t.alive[n]&&!e.alive[n])}var $r=[-.31,0,.31],Pr=[{size:1,at:[[0,0]]},{size:.62,at:[[-.2,.2],[.2,-.2]]},{size:.54,at:[[-.23,.22],[.23,.22],[0,-.22]]},{size:.54,at:[[-.23,.23],[.23,.23],[
-.23,-.23],[.23,-.23]]},{size:.36,at:$r.flatMap(t=>$r.map(e=>[e,t]))}],Ho=.3,jo=.35,Go=.55;function Ee(t,e){let r=new Map;for(let n=0;n<e.alive.length;n++){if(!e.
alive[n])continue;let[o,s]=S(e,n),a=o*t.cols+s,i=r.get(a);i?i.push(n):r.set(a,[n])}return r}function Or(t,e){let r=Array.from(e.alive,(n,o)=>{let[s,a]=S(e,o);return{
x:a+.5,y:s+.5,size:1,alpha:0}});for(let n of Ee(t,e).values()){let o=Pr[Math.min(n.length,Pr.length)-1];n.forEach((s,a)=>{let[i,l]=o.at[Math.min(a,o.at.length-1)],
d=r[s];d.x+=i,d.y+=l,d.size=o.size,d.alpha=1})}return r}var Lr=t=>t*t*(3-2*t),ie=(t,e,r)=>t+(e-t)*r,Nr=t=>Math.min(1,Math.max(0,t));function Ir(t,e,r,n){let o={
1:2,2:r}[t.interaction]??1;if(o===1)return Lr(n);let s=o===r?e:+!q(t,e),a=Math.max(1/o,jo);return Lr(Nr((n-s/(o-1)*(1-a))/a))}function Ve(t,e){let r=t.moments.length-
1,n=Math.min(Math.floor(e),r),o=t.moments[n],s=Or(t,o);if(n===r||e===n)return s;let a=t.moments[n+1],i=Or(t,a);return s.map((l,d)=>{let u=Ir(t,d,s.length,e-n);return zo(
o,a,d,l,i[d],u)})}function Pt(t,e,r){let n=t.moments.length-1,o=Math.min(Math.floor(r),n),[s,a]=[t.moments[o],t.moments[Math.min(o+1,n)]],i=Ir(t,e,s.alive.length,
r-o),[[l,d],[u,m]]=[S(s,e),S(a,e)];return[ie(d,m,i)+.5,ie(l,u,i)+.5]}function zo(t,e,r,n,o,s){let a=n.alpha>o.alpha,i={x:ie(n.x,o.x,s),y:ie(n.y,o.y,s),size:a?n.
size:ie(n.size,o.size,s),alpha:a?Nr((1-s)/(1-Go)):ie(n.alpha,o.alpha,s)};if(je(t,e,r)){let[l,d]=S(t,r),[u,m]=Ge(t,e,r),p=Ho*Math.sin(Math.PI*s);i.x+=(m-d)*p,i.y+=
(u-l)*p}return i}var Ur=2*Math.PI;function J(t,e,r,n){t.beginPath(),t.arc(e,r,n/2,0,Ur)}function Ke(t,e,r,n){let o=n/2,s=[[0,-.97],[.97,.83],[-.97,.83]].map(([a,i])=>[e+a*o,r+i*
o]);t.beginPath(),t.moveTo((s[2][0]+s[0][0])/2,(s[2][1]+s[0][1])/2),s.forEach(([a,i],l)=>{let[d,u]=s[(l+1)%3];t.arcTo(a,i,d,u,n*.09)}),t.closePath()}function Br(t,e,r,n){
let o=n*.32;t.beginPath(),t.moveTo(e-o,r-o),t.lineTo(e+o,r+o),t.moveTo(e+o,r-o),t.lineTo(e-o,r+o)}function Dr(t,e,r,n){t.beginPath();for(let o=0;o<16;o++){let s=n/
2*(o%2?.6:.95),a=Ur*o/16;t.lineTo(e+s*Math.sin(a),r-s*Math.cos(a))}t.closePath()}function Wr(t,e,r,n,o,s){let a=Math.atan2(o-r,n-e);t.beginPath(),t.moveTo(e,r),
t.lineTo(n,o);for(let i of[-1,1])t.moveTo(n,o),t.lineTo(n-s*Math.cos(a+i*.6),o-s*Math.sin(a+i*.6))}var Fr=4,Vo=1.6,Ko=.95,Yo=5,qo=.16,Jo=9,Xo=.09,Zo=.2,Hr=.75,R=(t,e)=>t.left+e*t.cell,$=(t,e)=>t.top+e*t.cell;function le(t,e,r){return q(e,r)?t.colors.pursuer:t.
colors.evader}function jr({ctx:t,grid:e,colors:r}){let{left:n,top:o,cell:s,rows:a,cols:i}=e,[l,d]=[i*s,a*s];if(t.fillStyle=r.paper,t.fillRect(n,o,l,d),s<Yo)return;
t.fillStyle=r.line;let u=Math.max(1,Math.round(s/60));for(let m=1;m<i;m++)t.fillRect(n+m*s,o,u,d);for(let m=1;m<a;m++)t.fillRect(n,o+m*s,l,u)}function Gr({ctx:t,
grid:e,colors:r},n){let{left:o,top:s,cell:a,rows:i,cols:l}=e;t.fillStyle=r.obstacle;for(let u=0;u<i*l;u++){if(!n.obstacles[u])continue;let[m,p]=[Math.floor(u/l),
u%l];t.fillRect(o+p*a,s+m*a,a,a)}let d=Math.min(5,Math.max(2,Math.round(a/18)));t.strokeStyle=r.frame,t.lineWidth=d,t.strokeRect(o-d/2,s-d/2,l*a+d,i*a+d)}function zr({
ctx:t,grid:e,colors:r},n){let{left:o,top:s,cell:a,rows:i,cols:l}=e,d=a<24*n?5:1;t.font=`500 ${Math.round(Math.min(15*n,Math.max(9*n,a*.32)))}px system-ui, sans-\
serif`,t.fillStyle=r.muted,t.textBaseline="alphabetic",t.textAlign="center";let u=5*n+a/40;for(let m=0;m<l;m+=d)t.fillText(String(m),o+(m+.5)*a,s-u);t.textAlign=
"right",t.textBaseline="middle";for(let m=0;m<i;m+=d)t.fillText(String(m),o-u,s+(m+.5)*a)}function Vr({grid:t},e,r,n){let o=Math.floor(e.fov/2)+.5,[s,a]=[Math.max(
0,r-o),Math.min(t.cols,r+o)],[i,l]=[Math.max(0,n-o),Math.min(t.rows,n+o)];return[R(t,s),$(t,i),(a-s)*t.cell,(l-i)*t.cell]}function Kr(t,e,r,n){let{ctx:o,grid:s,
colors:a}=t;o.beginPath(),o.rect(0,0,o.canvas.width,o.canvas.height),o.rect(...Vr(t,e,r,n)),o.save(),o.clip("evenodd"),o.fillStyle=a.line,o.fillRect(s.left,s.top,
s.cols*s.cell,s.rows*s.cell),o.restore()}function Yr({ctx:t,grid:e,colors:r},{x:n,y:o,alpha:s},a){let i=Math.max(e.cell,16*a)*1.06,[l,d]=[R(e,n),$(e,o)];t.globalAlpha=
Math.max(s,.6),t.beginPath(),t.roundRect(l-i/2,d-i/2,i,i,i*.2),t.strokeStyle=r.focus,t.lineWidth=Math.max(2,2.5*a),t.stroke();let u=Math.max(11*a,Math.min(18*a,
e.cell*.5));t.font=`700 ${Math.round(u)}px system-ui, sans-serif`,t.textAlign="center",t.textBaseline="middle";let m=d-i/2<u*1.2,p=d+(m?1:-1)*(i/2+u*.7);t.strokeStyle=
r.paper,t.lineJoin="round",t.lineWidth=u*.35,t.strokeText("You",l,p),t.fillStyle=r.ink,t.fillText("You",l,p),t.globalAlpha=1}function qr(t,e,r,n,o){let{ctx:s,grid:a}=t,
i=Vr(t,e,n,o),l=le(t,e,r);s.globalAlpha=.11,s.fillStyle=l,s.fillRect(...i),s.globalAlpha=.8,s.strokeStyle=l,s.lineWidth=Math.max(1,a.cell/24),s.strokeRect(...i),
s.globalAlpha=1}function Jr(t,e,r,n,o){let{ctx:s,grid:a}=t,i=Math.min(Math.ceil(r),e.moments.length-1),l=e.moments[i];s.lineCap="round",s.lineWidth=Math.min(Jo,
Math.max(1,a.cell*qo));for(let d=Math.max(1,Math.floor(r-n)+1);d<=i;d++){let[u,m]=[e.moments[d-1],e.moments[d]],p=Math.max(0,Math.min(1,(r-d)/n));s.globalAlpha=
Hr+(Zo-Hr)*p;for(let h=0;h<m.alive.length;h++){let y=d===i&&r<i;if(!u.alive[h]||!(l.alive[h]||y))continue;let f=(q(e,h)?-1:1)*Xo,[v,w]=S(u,h),[A,g]=S(m,h);if(v===
A&&w===g)continue;let x=y?o[h].x:g+.5,C=y?o[h].y:A+.5;s.strokeStyle=le(t,e,h),s.beginPath(),s.moveTo(R(a,w+.5+f),$(a,v+.5+f)),s.lineTo(R(a,x+f),$(a,C+f)),s.stroke()}}
s.globalAlpha=1}function Xr(t,e,r){let n=Math.min(Math.ceil(r),e.moments.length-1);for(let o=Math.max(1,n-Fr+1);o<=n;o++){let[s,a]=[e.moments[o-1],e.moments[o]],
i=o>r?Math.max(0,1-2*(o-r)):1-(r-o)/Fr,l=Me(e,s,a);for(let d of ze(s,a))l.includes(d)||es(t,S(a,d),i);for(let d of l)Qo(t,S(a,d),i)}t.ctx.globalAlpha=1}function Qo({
ctx:t,grid:e,colors:r},[n,o],s){t.globalAlpha=s,Dr(t,R(e,o+.5),$(e,n+.5),Math.max(8,e.cell*Vo)),t.fillStyle=r.capture,t.fill(),t.strokeStyle=r.ink,t.lineWidth=Math.
max(1,e.cell/36),t.lineJoin="round",t.stroke()}function es({ctx:t,grid:e,colors:r},[n,o],s){t.globalAlpha=s,Br(t,R(e,o+.5),$(e,n+.5),Math.max(7,e.cell*Ko)),t.strokeStyle=
r.collision,t.lineWidth=Math.max(2,e.cell*.17),t.lineCap="round",t.stroke()}function Zr({ctx:t,grid:e,colors:r},n,o){let s=Math.max(1,e.cell*.07);t.strokeStyle=
t.fillStyle=r.collision,t.lineWidth=Math.max(1,e.cell*.05),t.setLineDash([e.cell*.14,e.cell*.1]);for(let[a,i]of n){if(a<0||i<0||a>=e.rows||i>=e.cols)continue;let l=[
R(e,i)+s,$(e,a)+s,e.cell-2*s,e.cell-2*s];t.globalAlpha=.2*o,t.fillRect(...l),t.globalAlpha=o,t.strokeRect(...l)}t.setLineDash([]),t.globalAlpha=1}function Qr({ctx:t,
grid:e,colors:r},n,o,s,a){t.globalAlpha=a,J(t,R(e,n),$(e,o),Math.max(8,e.cell*s*1.02)),t.strokeStyle=r.collision,t.lineWidth=Math.max(1.5,e.cell*.085*Math.sqrt(
s)),t.stroke(),t.globalAlpha=1}var ts=.8,rs=.92,ns=15,os=7,Ot=9;function en(t,e,r,n,o,s){n.forEach((a,i)=>{a.alpha>0&&ss(t,e,r,i,a,o,s)}),t.ctx.globalAlpha=1;for(let a of Ee(e,r).values())a.length>
Ot&&as(t,n[a[Ot-1]],a.length-Ot+1)}function ss(t,e,r,n,o,s,a){let{ctx:i,grid:l,colors:d}=t,u=q(e,n),[m,p]=[l.left+o.x*l.cell,l.top+o.y*l.cell],h=Math.max(4,l.cell*
o.size*(u?rs:ts)),y=le(t,e,n),f=!u&&!!r.captured[n-e.nPursuers];if(i.globalAlpha=o.alpha,(u?Ke:J)(i,m,p,h),h>os*a&&(i.strokeStyle=d.paper,i.lineWidth=Math.max(2,
h*.1),i.stroke()),i.fillStyle=f?d.paper:y,i.fill(),f&&(J(i,m,p,h*.82),i.strokeStyle=y,i.lineWidth=h*.18,i.stroke()),!s||h<ns*a)return;let v=String(u?n:n-e.nPursuers);
i.font=`700 ${Math.round(h*(u?.4:.5)*(v.length>1?.8:1))}px system-ui, sans-serif`,i.textAlign="center",i.textBaseline="middle",i.fillStyle=f?y:d.paper,i.fillText(
v,m,p+h*(u?.17:.03))}function as({ctx:t,grid:e,colors:r},n,o){let[s,a]=[e.left+n.x*e.cell,e.top+n.y*e.cell];t.font=`700 ${Math.round(e.cell*.3)}px system-ui, sa\
ns-serif`,t.textAlign="center",t.textBaseline="middle",t.strokeStyle=r.paper,t.lineWidth=e.cell*.1,t.strokeText(`+${o}`,s,a),t.fillStyle=r.ink,t.fillText(`+${o}`,
s,a)}var is=.46,ls=.86,cs=.66,tn=.48,ds=.78,us=.58;function rn(t,e,r,n){let[o,s]=[e.moments[r-1],e.moments[r]];if(!o)return;let{ctx:a,grid:i,colors:l}=t;a.strokeStyle=
l.collision,a.lineWidth=Math.max(1.5,i.cell*.07),a.lineCap="butt",a.globalAlpha=n;for(let d=0;d<s.alive.length;d++)je(o,s,d)&&ms(t,e,S(o,d),Ge(o,s,d));a.globalAlpha=
1}function ms({ctx:t,grid:e},r,n,o){let[s,a]=[o[1]-n[1],o[0]-n[0]],i=m=>R(e,n[1]+.5+s*m),l=m=>$(e,n[0]+.5+a*m),d=Tt(r,o)?ds:us;t.setLineDash([e.cell*.09,e.cell*
.06]),t.beginPath(),t.moveTo(i(tn),l(tn)),t.lineTo(i(d),l(d)),t.stroke(),t.setLineDash([]);let u=.17*e.cell/Math.hypot(s,a);t.beginPath(),t.moveTo(i(d)-a*u,l(d)+
s*u),t.lineTo(i(d)+a*u,l(d)-s*u),t.stroke()}function nn(t,e,r,n,o,s){let a=ae[s];if(!s||!a)return;let{ctx:i,grid:l,colors:d}=t,u=Tt(e,[n[0]+a[0],n[1]+a[1]])?ls:
cs,m=is*o.size,p=[R(l,o.x+a[1]*m),$(l,o.y+a[0]*m),R(l,o.x+a[1]*u),$(l,o.y+a[0]*u)],h=Math.max(1.5,l.cell*.085);i.lineCap=i.lineJoin="round";for(let[y,f]of[[d.paper,
h*2.1],[le(t,e,r),h]])i.strokeStyle=y,i.lineWidth=f,Wr(i,...p,l.cell*.2),i.stroke()}var sn={numbers:!0,axes:!1,trail:6,viewers:[],plan:null,selected:null,cursor:null,you:null,fog:!1};function an(t,e,r,n,o){let{ctx:s,grid:a,colors:i}=t,l=Math.min(
Math.ceil(r),e.moments.length-1),d=e.moments[l],u=r===l,m=Ve(e,r),p=u?1:Math.max(0,1-2*(l-r));s.clearRect(0,0,s.canvas.width,s.canvas.height),jr(t);for(let f of n.
viewers)m[f]?.alpha&&qr(t,e,f,...Pt(e,f,r));Gr(t,e),n.axes&&zr(t,o),Jr(t,e,r,n.trail,m),Zr(t,d.contested??[],p),Xr(t,e,r),rn(t,e,l,p),m.forEach(({x:f,y:v,size:w},A)=>{
let g=kr(d,A)?.4:0,x=kt(d,A)?1:g;x&&Qr(t,f,v,w,x*p)});let h=u?d:e.moments[Math.max(0,l-1)];if(en(t,e,h,m,n.numbers,o),u&&n.plan)for(let[f,v]of m.entries())v.alpha&&
nn(t,e,f,S(d,f),v,n.plan[f]??0);n.you!==null&&(n.fog&&Kr(t,e,...Pt(e,n.you,r)),Yr(t,m[n.you],o)),s.lineWidth=Math.max(2,2.5*o),s.strokeStyle=i.focus;let y=n.selected===
null?void 0:m[n.selected];y?.alpha&&on(t,y.x,y.y,y.size*.96),n.cursor&&(s.setLineDash([a.cell*.12,a.cell*.08]),on(t,n.cursor[1]+.5,n.cursor[0]+.5,.8),s.setLineDash(
[]))}function on({ctx:t,grid:e},r,n,o){let s=o*e.cell;t.beginPath(),t.roundRect(e.left+r*e.cell-s/2,e.top+n*e.cell-s/2,s,s,s*.1),t.stroke()}var ln=(t,e)=>(e+.24)/(t+.24);function cn(t,e,r,n,o,s){let a=r?28*s:0,i=(d,u)=>(d-a)/(u+2*.12),l=Math.max(1,Math.floor(Math.min(i(n,e),i(o,t))));return{rows:t,cols:e,
cell:l,left:Math.round((n-e*l+a)/2),top:Math.round((o-t*l+a)/2)}}function dn(t,e,r){let n=Math.floor((r-t.top)/t.cell),o=Math.floor((e-t.left)/t.cell);return n>=
0&&n<t.rows&&o>=0&&o<t.cols?[n,o]:null}var ps={paper:"--board-paper",line:"--board-line",frame:"--board-frame",ink:"--board-ink",muted:"--board-muted",obstacle:"--board-obstacle",pursuer:"--pursuer",
evader:"--evader",capture:"--capture",collision:"--collision",focus:"--focus"};function Ye(t){let e=getComputedStyle(t),r=Object.entries(ps).map(([n,o])=>[n,e.getPropertyValue(
o).trim()]);return Object.fromEntries(r)}var N=()=>matchMedia("(prefers-reduced-motion: reduce)").matches,G=class{canvas;#e=null;#n=0;#o;#a={rows:1,cols:1,left:0,top:0,cell:1};#r=0;#t;#i;constructor(e,r={}){
this.canvas=e,e.classList.add("board"),e.setAttribute("role","img"),this.#o={...sn,...r},this.#t=new ResizeObserver(()=>this.#u()),this.#t.observe(e),this.#i=new MutationObserver(
()=>this.redraw()),this.#i.observe(document.documentElement,{attributes:!0}),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",this.redraw)}close(){
this.#t.disconnect(),this.#i.disconnect(),matchMedia("(prefers-color-scheme: dark)").removeEventListener("change",this.redraw),cancelAnimationFrame(this.#r)}get look(){
return this.#o}set look(e){this.#o={...this.#o,...e},this.#d(),this.redraw()}get time(){return this.#n}show(e,r){this.#e=e,this.#n=Math.min(Math.max(0,r),e.moments.
length-1),this.#d(),this.redraw()}redraw=()=>{this.#r||(this.#r=requestAnimationFrame(()=>this.drawNow()))};drawNow(){cancelAnimationFrame(this.#r),this.#r=0;let e=this.
canvas.getContext("2d");if(!e||!this.#e)return;let{rows:r,cols:n}=this.#e,o=devicePixelRatio||1;this.#a=cn(r,n,this.#o.axes,this.canvas.width,this.canvas.height,
o);let s={ctx:e,grid:this.#a,colors:Ye(this.canvas)};an(s,this.#e,this.#n,this.#o,o)}cellAt(e,r){let n=this.canvas.getBoundingClientRect(),o=this.canvas.width/n.
width;return dn(this.#a,(e-n.left)*o,(r-n.top)*o)}agentAt(e,r){let n=this.cellAt(e,r);if(!n||!this.#e)return null;let o=this.#e.moments[Math.round(this.#n)],s=Ee(
this.#e,o).get(n[0]*this.#e.cols+n[1])??[],a=Ve(this.#e,Math.round(this.#n)),i=l=>{let[d,u]=this.pointOf(a[l].x,a[l].y);return Math.hypot(d-e,u-r)};return s.length?
s.reduce((l,d)=>i(d)<i(l)?d:l):null}pointOf(e,r){let n=this.canvas.getBoundingClientRect(),o=n.width/this.canvas.width,{left:s,top:a,cell:i}=this.#a;return[n.left+
(s+e*i)*o,n.top+(a+r*i)*o]}#d(){if(!this.#e)return;let{rows:e,cols:r}=this.#e;this.canvas.style.setProperty("--board-aspect",String(ln(e,r)))}#u(){let e=devicePixelRatio||
1,{width:r,height:n}=this.canvas.getBoundingClientRect();this.canvas.width=Math.max(1,Math.round(r*e)),this.canvas.height=Math.max(1,Math.round(n*e)),this.drawNow()}};var fs={SIMULTANEOUS:0,SWARM_TURNS:1,AGENT_TURNS:2};function qe(t,e,r){return{rows:t.rows,cols:t.cols,nPursuers:t.n_pursuers,fov:t.fov,interaction:fs[t.rules.interaction],
obstacles:e,moments:r}}function Je(t,e){return{positions:t.read("last_positions"),alive:t.read("alive"),captured:t.read("captured"),everCaptured:t.read("ever_ca\
ptured"),actions:e,involved:t.read("involved"),fault:t.read("fault"),contested:t.conflicts().map(r=>r.cell)}}function Xe(t){let e=Array.from({length:t.length+1},
(r,n)=>ys(t,n));return qe(t.config,t.map,e)}function ys(t,e){let r=t.n_agents,n=t.config.n_evaders,o=(a,i,l)=>a.subarray(i*l,(i+1)*l),s={positions:o(t.last_positions,
e,2*r),alive:o(t.alive,e,r),captured:o(t.captured,e,n),everCaptured:o(t.ever_captured,e,n)};return e===0?s:{...s,actions:o(t.actions,e-1,r),involved:o(t.involved,
e-1,3*r),fault:o(t.fault,e-1,3*r),get contested(){return t.conflicts(e).map(a=>a.cell)}}}var gs=Array.from({length:16},(t,e)=>{let[r,n]=[e%2?6.5:11,Math.PI*e/8];return`${12+r*Math.sin(n)} ${12-r*Math.cos(n)}`}).join(" ");function un(){let t=[["pursu\
er",b("path",{d:"M12 3 22 20H2z",class:"filled-pursuer"})],["evader",b("circle",{cx:12,cy:12,r:9,class:"filled-evader"})],["capture",b("polygon",{points:gs,class:"\
filled-capture"})],["captured evader",b("circle",{cx:12,cy:12,r:7.5,class:"ring-evader"})],["conflict",b("rect",{x:3,y:3,width:18,height:18,class:"dashed-confli\
ct"})]];return c("ul",{class:"shapes small","aria-label":"Shapes on the board"},...t.map(([e,r])=>c("li",{},b("svg",{viewBox:"0 0 24 24","aria-hidden":"true"},r),
e)))}var bs={first:"M6 5v14M19 5 9 12l10 7z",back:"M17 5 7 12l10 7z",play:"M7 4.5 19 12 7 19.5z",pause:"M8 5v14M16 5v14",forward:"M7 5l10 7-10 7z",last:"M18 5v14M5 5\
l10 7-10 7z"};function mn(t){let e=document.createElementNS("http://www.w3.org/2000/svg","svg");e.setAttribute("viewBox","0 0 24 24"),e.setAttribute("aria-hidde\
n","true"),e.classList.add("icon");let r=document.createElementNS("http://www.w3.org/2000/svg","path");return r.setAttribute("d",bs[t]),e.append(r),e}function Ce(t,e,r,n){
let o=document.createElement("button");return o.type="button",o.className="player-button",o.append(mn(t)),o.ariaLabel=e,o.title=`${e} (${r})`,o.addEventListener(
"click",n),o}function ce(t){let e=document.createElement("div");e.className="player",e.role="group",e.ariaLabel="Player";let r=Ce("play","Play","Space",()=>t.toggle()),
n=vs(t),o=c("div",{class:"captures","aria-hidden":"true",title:"Captures"}),s=ws(t),a=document.createElement("output");a.className="player-count",e.append(Ce("f\
irst","First step","Home",()=>t.move(-t.length)),Ce("back","Step back","←",()=>t.move(-1)),r,Ce("forward","Step forward","→",()=>t.move(1)),Ce("last","Last \
step","End",()=>t.move(t.length)),c("div",{class:"scrub"},o,n),a,s);let i=()=>o.replaceChildren(...t.marks.map(d=>{let u=c("i");return u.style.left=`${100*d/Math.
max(1,t.length)}%`,u})),l=()=>{r.replaceChildren(mn(t.playing?"pause":"play")),r.ariaLabel=t.playing?"Pause":"Play",r.title=`${r.ariaLabel} (Space)`,n.max=String(
t.length),n.value=String(t.step),n.ariaValueText=`step ${t.step} of ${t.length}`,a.textContent=`${t.step} / ${t.length}`,a.style.minWidth=`${2*String(t.length).
length+3}ch`,s.value=String(t.speed)};return t.addEventListener("step",l),t.addEventListener("state",l),t.addEventListener("state",i),e.addEventListener("keydow\
n",d=>{!(d.target instanceof HTMLSelectElement||d.key===" "&&d.target!==n)&&j(t,d)&&d.preventDefault()}),l(),e}function vs(t){let e=document.createElement("inpu\
t");return e.type="range",e.className="player-scrub",e.min="0",e.step="1",e.ariaLabel="Step",e.addEventListener("input",()=>{t.pause(),t.jump(Number(e.value))}),
e}function ws(t){let e=document.createElement("select");return e.className="player-speed",e.ariaLabel="Speed",e.title="Steps a second (+ and -)",e.append(new Option(
`all in ${Et} s`,String(oe)),...Se.map(r=>new Option(`${r} / s`,String(r)))),e.addEventListener("change",()=>{t.speed=Number(e.value)}),e}var E=(t,e=2)=>t==null?"-":t.toFixed(e),Lt=(t,e=1)=>t==null?"-":`${(100*t).toFixed(e)} %`;function Ze(t,e,r,n=2){return e===null||r===null?t.toFixed(n):`${t.toFixed(
n)} (${e.toFixed(n)} to ${r.toFixed(n)})`}var pn=t=>t.toLocaleString("en-GB");function Te(t,e,r,n=!1){let o=(e-t)/Math.max(1,r),s=10**Math.floor(Math.log10(o||1)),
a=[1,2,5,10].map(d=>d*s).find(d=>d>=o)??10*s;n&&(a=Math.max(1,Math.round(a)));let i=Math.ceil(t/a-1e-9),l=Math.floor(e/a+1e-9);return Array.from({length:Math.max(
0,l-i+1)},(d,u)=>(i+u)*a)}function z(t,e,{pursuer:r,evader:n,episode:o,seed:s}){let a=e.seeds[r][n];return t.match(e.world,k(e,"pursuer",r),k(e,"evader",n),BigInt(s??a),o)}var hn=40,_e=new Map,ke=({run:t,pursuer:e,evader:r},n)=>`${t} ${e} ${r} ${n}`,Qe=class{element;#e;#n;#o=c("div",{class:"episodes",role:"group","aria-label":"Epi\
sodes of this cell"});#a=c("p",{class:"check small numbers","aria-live":"polite"});#r=0;constructor(e,r){[this.#e,this.#n]=[e,r],this.element=c("div",{class:"st\
rip-of-episodes"},this.#o,this.#a)}show(e,r,n){let{selected:o}=this.#e;o.seed===null&&_e.set(ke(o,o.episode),fn(n)),this.#i(r),Ss(this.#r),this.#t(e,r)}#t(e,r){
let{selected:n}=this.#e,s=xe(r,n.pursuer,n.evader)?.rates.findIndex((a,i)=>!_e.has(ke(n,i)))??-1;s<0||s>=hn||(this.#r=xs(()=>{this.#e.selected===n&&(this.#n.playing||
(_e.set(ke(n,s),fn(z(e,r,{...n,episode:s,seed:null}))),this.#i(r)),this.#t(e,r))}))}#i(e){let{selected:r}=this.#e,n=xe(e,r.pursuer,r.evader);if(!n){this.#o.replaceChildren(),
this.#a.textContent="The evaluation played no episodes of this pair.";return}let o=Math.min(hn,n.rates.length);this.#o.replaceChildren(...n.rates.slice(0,o).map(
(d,u)=>this.#d(d,u)));let s=n.rates.slice(0,o).map((d,u)=>_e.get(ke(r,u))),a=s.filter(d=>d!==void 0),i=s.flatMap((d,u)=>d&&(Math.abs(d.rate-n.rates[u])>1e-6||d.
length!==n.lengths[u])?[u+1]:[]),l=a.reduce((d,u)=>d+u.rate,0)/a.length;this.#a.dataset.equal=String(!i.length&&a.length===n.rates.length),this.#a.textContent=i.
length?`Episode ${i.join(", ")} differs from the evaluation.`:"As in the evaluation",this.#a.title=a.length<n.rates.length?`Played here: ${a.length} of ${n.rates.
length} episodes.`:`Played here: all ${a.length} episodes, mean capture rate ${E(l,3)}. The cell says ${E(n.rate,3)}.`}#d(e,r){let{selected:n}=this.#e,o=c("span",
{class:"bar"});return o.style.height=`${Math.round(100*e)}%`,c("button",{type:"button",class:"episode",title:`Episode ${r+1}: capture rate ${E(e)}`,"aria-label":`\
Episode ${r+1}, capture rate ${E(e)}`,"aria-pressed":String(r===n.episode&&n.seed===null),"data-played":_e.has(ke(n,r)),onclick:()=>this.#e.select({episode:r,seed:null})},
o,c("span",{class:"count"},r+1))}},fn=t=>({rate:t.statistics.capture_rate,length:t.length}),xs=t=>"requestIdleCallback"in window?requestIdleCallback(t,{timeout:1e3}):
setTimeout(t,100),Ss=t=>"cancelIdleCallback"in window?cancelIdleCallback(t):clearTimeout(t);var F=(t,e)=>t<e?`pursuer_${t}`:`evader_${t-e}`,de=["stay","north","east","south","west","northeast","southeast","southwest","northwest"];var yn=0,gn=1,As=2,Ms=176;function vn(t,e,r,n){let o=devicePixelRatio||1,s=Ye(t);t.width=t.height=Ms*o;let a=t.getContext("2d");if(!a)return;let{fov:i}=e,l=t.width/
i;a.fillStyle=s.paper,a.fillRect(0,0,t.width,t.height);for(let u=0;r&&u<i*i;u++){let[m,p]=[(u%i+.5)*l,(Math.floor(u/i)+.5)*l],h=f=>!!r[f*i*i+u];h(As)&&(a.fillStyle=
s.obstacle,a.fillRect(m-l/2,p-l/2,l,l));let y=h(yn)&&h(gn)?l*.18:0;h(yn)&&bn(a,J,m+y,p+y,l*.74,s.evader),h(gn)&&bn(a,Ke,m-y,p-y,l*.86,s.pursuer)}a.strokeStyle=n<
e.n_pursuers?s.pursuer:s.evader,a.lineWidth=2*o;let d=Math.floor(i/2)*l;a.strokeRect(d,d,l,l)}function bn(t,e,r,n,o,s){e(t,r,n,o),t.fillStyle=s,t.fill()}var et=class{element;#e;#n=c("canvas",{class:"seen",role:"img"});#o=c("h3");#a=c("p",{class:"small muted"});#r=c("div",{class:"answers"});#t=null;#i=null;#d=null;#u=null;#l=null;#c=0;constructor(e){
this.#e=e,this.element=c("div",{class:"inspector","data-open":"false"},c("p",{class:"hint small muted"},"Click an agent, or press A: what it sees, and what its \
network answers."),c("div",{class:"inspected"},this.#n,c("div",{class:"answer"},this.#o,this.#a),this.#r))}get agent(){return this.#l}show(e,r,n,o){(this.#i!==r||
!this.#t)&&(this.#t?.free(),this.#t=e.world(r.world),this.#l!==null&&this.#i!==r&&this.choose(null)),[this.#i,this.#d,this.#u]=[r,n,o]}choose(e){this.#l=e,this.
element.dataset.open=String(e!==null),this.#e(e),this.at(this.#c)}next(e){let r=this.#d;if(!r)return;let n=this.#l??(e>0?-1:0);for(let o=0;o<r.n_agents;o++)if(n=
(n+e+r.n_agents)%r.n_agents,r.alive[this.#c*r.n_agents+n])return this.choose(n)}at(e){this.#c=e;let[r,n,o,s,a]=[this.#d,this.#t,this.#i,this.#u,this.#l];if(!r||
!n||!o||!s||a===null)return;let i=a<r.config.n_pursuers?"pursuer":"evader";this.#o.replaceChildren(c("span",{class:i},F(a,r.config.n_pursuers)));let l=!!r.alive[e*
r.n_agents+a];r.seek(n,e),vn(this.#n,r.config,l?n.view(a):null,a),this.#n.ariaLabel=`Field of view of ${F(a,r.config.n_pursuers)}: evaders, pursuers and obstacl\
es around it`;let d=e<r.length?r.actions[e*r.n_agents+a]:null;if(!l)return this.#s([],"It is gone.");let u=k(o,i,s[i]);if(typeof u=="string")return this.#s([],`\
The script "${u}" plays for it${d===null?"":`; it goes ${de[d]}`}.`);let{probabilities:m}=n.answer(u,a),p=Array.from(m,(y,f)=>Es(de[f],y,f===d)),h=u.sampled?"It\
s action is drawn from these probabilities.":"It takes the most probable action.";this.#s(p,d===null?"The episode is over.":h)}#s(e,r){this.#r.replaceChildren(...e),
this.#a.textContent=r}};function Es(t,e,r){let n=c("span",{class:"filled"});return n.style.width=`${100*e}%`,c("div",{class:r?"action taken":"action"},c("span",
{},t),c("span",{class:"track"},n),c("span",{class:"numbers"},e.toFixed(2)))}function wn(t){let e=JSON.stringify(t,(r,n)=>r==="genome"?Array.from(n):n);return c("script",{type:"application/json",id:"champions"},e.replaceAll("<","\\u003c")).
outerHTML}var Nt="champion";var Cs=(t,e)=>Object.keys(t).every(r=>t[r]===e[r]);function xn(t,e){return Object.keys(e).find(r=>Cs(e[r],t))??null}var Re="_",_s="n",Al=2n**64n-1n;var It={fov:11,maxSteps:500,rewards:"paper"},ks=["rules","others","rewards","size","diagonal","fov","limit","seed","ended","walls","pursuers","evaders","played",
"next"];function Ut(t,e){let r=i=>i.map(l=>$s(l,e)).join(""),n=i=>`${Math.floor(i/t.cols)}.${i%t.cols}`,o=Rs(t.rewards,e),s=[t.seed,t.episode,t.steps].join("."),a={rules:An(
t.rules,e),others:t.others?An(t.others,e):"",rewards:o===It.rewards?"":o,size:`${t.rows}x${t.cols}`,diagonal:t.diagonal?"1":"",fov:t.fov===It.fov?"":String(t.fov),
limit:t.maxSteps===It.maxSteps?"":String(t.maxSteps),seed:s==="0.0.0"?"":s,ended:t.ended?"1":"",walls:t.walls.map(n).join(Re),pursuers:t.pursuers.map(Sn).join(Re),
evaders:t.evaders.map(Sn).join(Re),played:t.played.map(r).join(Re),next:t.next.every(i=>i===0)?"":r(t.next)};return ks.filter(i=>a[i]).map(i=>`${i}=${a[i]}`).join(
"&")}function Sn({cell:t,gone:e,captured:r,everCaptured:n}){let o=r?"c":n?"e":"";return`${t[0]}.${t[1]}${o}${e?"x":""}`}function An(t,e){let r=e.fields.map(({name:n})=>String(
t[n]).toLowerCase());return xn(t,e.variants)??r.join(".")}function Rs(t,e){let r=JSON.stringify(t);return Object.keys(e.rewards).find(o=>JSON.stringify(e.rewards[o])===
r)??Object.values(t).map(o=>String(o)).join(Re)}function $s(t,e){if(typeof t=="number")return String(t);if(t===Nt)return _s;let r=e.scripts.findIndex(({name:n})=>n===
t);return String.fromCharCode(97+r)}var Ps="/* the engine */";function _n(t,e){return c("button",{type:"button",class:"to-playground",title:"Open this step in the playground (G): the same agents a\
nd actions under any rules",onclick:()=>Bt(t(),e)},"What if? Playground")}function Bt(t,e){let r=t!==null&&t.match.n_agents<=100&&Math.max(t.match.config.rows,t.
match.config.cols)<=64,n=r?Ut(Os(t.match,t.step),e):"",o=new TextDecoder().decode(Mt("playground")).replace(Ps,()=>Fe("script-engine")).replace("</noscript>",s=>r?
s+wn(t.champions):s);window.open(`${URL.createObjectURL(new Blob([o],{type:"text/html"}))}#${n}`)}function Os(t,e){let{config:r,n_agents:n}=t,o=Math.max(0,e-1),
s=i=>{let l=o*n+i,d=o*r.n_evaders+i-r.n_pursuers,u=m=>i>=r.n_pursuers&&!!m[d];return{cell:[t.last_positions[2*l],t.last_positions[2*l+1]],gone:!t.alive[l],captured:u(
t.captured),everCaptured:u(t.ever_captured)}},a=Array.from({length:n},(i,l)=>s(l));return{rules:r.rules,others:null,rewards:r.rewards,rows:r.rows,cols:r.cols,diagonal:r.
diagonal,fov:r.fov,maxSteps:r.max_steps,seed:t.seed,episode:BigInt(t.episode),steps:o,ended:o===t.length,walls:Array.from(t.map.keys()).filter(i=>t.map[i]),pursuers:a.
slice(0,r.n_pursuers),evaders:a.slice(r.n_pursuers),played:[],next:Array.from(t.actions.subarray(o*n,(o+1)*n))}}function tt(t,e,r){if(r===0)return[{kind:"start",text:Ls(t),agents:[]}];let[n,o]=[e.moments[r-1],e.moments[r]],s=u=>F(u,t.config.n_pursuers),a=Me(e,n,o),i=t.conflicts(
r),l=new Set(i.flatMap(u=>u.doomed)),d=a.map(u=>({kind:"capture",text:`${s(u)} is captured`,agents:[u]}));for(let u of ze(n,o))!a.includes(u)&&!l.has(u)&&d.push(
{kind:"end",text:`${s(u)} disappears`,agents:[u]});return d.push(...i.map(({kind:u,text:m,agents:p})=>({kind:u,text:m,agents:p}))),r===t.length&&d.unshift({kind:"\
end",text:Ns(t),agents:[]}),d}function Ls({config:t}){return`${t.n_pursuers} pursuers and ${t.n_evaders} evaders on ${t.rows} x ${t.cols} cells, at most ${t.max_steps}\
 steps`}function Ns(t){let e=Math.round(t.statistics.capture_rate*t.config.n_evaders);return`The episode ends after ${t.length} steps with ${e} of ${t.config.n_evaders}\
 evaders captured`}var Is=60,rt=class{element;player=new W(0,{speed:oe,still:N()});inspector;#e;#n;#o;#a;#r=c("h2",{class:"match-title"});#t=c("p",{class:"tally numbers"});#i=c("o\
l",{class:"words","aria-live":"off","aria-label":"What happened in this step"});#d=c("p",{class:"problem",role:"alert"});#u=null;#l=null;#c=null;#s=null;#h=0;#f=!1;#m=0;constructor(e,r,n){
[this.#n,this.#o]=[e,r];let o=c("canvas",{"aria-label":"The match"});this.#e=new G(o,{numbers:!1}),this.#a=new Qe(r,this.player),this.inspector=new et(s=>this.#A(
s)),o.addEventListener("click",s=>this.inspector.choose(this.#e.agentAt(s.clientX,s.clientY))),this.element=c("section",{class:"card match-card","aria-label":"M\
atch",id:"match"},c("div",{class:"match"},c("header",{class:"match-head"},this.#r,this.#t),this.#d,c("div",{class:"stage"},o),c("div",{class:"aside"},this.#i,un(),
c("div",{class:"beside"},c("button",{type:"button",class:"to-play",title:"Move the chosen agent, or an evader, yourself from this step on (T)",onclick:()=>this.
element.dispatchEvent(new Event("takeover"))},"Take over an agent"),_n(()=>this.shown,n)),this.inspector.element),ce(this.player),this.#a.element)),this.player.
addEventListener("frame",()=>this.#s&&this.#e.show(this.#s,this.player.time)),this.player.addEventListener("step",()=>this.#w()),r.on("match",()=>this.#x()),r.on(
"rest",()=>this.player.pause()),this.#b(),this.#v(0,0)}get#p(){return this.#n[this.#o.selected.run]}get match(){return this.#l}get shown(){return this.#l&&this.#c&&
{match:this.#l,step:this.player.step,champions:this.#c}}start(e){this.#u=e,this.#y()}playSoon(){this.#f=!0,this.#h||this.#g()}goTo(e){this.#m=e,!this.#h&&this.#l&&
this.#y()}#g(){!this.#f||!this.#l||(this.#f=!1,this.player.jump(0),N()||this.player.play())}#x(){this.#b(),clearTimeout(this.#h),this.#h=setTimeout(()=>this.#y(),
Is)}#y(){clearTimeout(this.#h),this.#h=0,this.player.pause(),this.#b();let{selected:e}=this.#o,r=ne.map(s=>Y(this.#p,s,e[s])).find(Boolean)??"";if(this.#d.textContent=
r,r||!this.#u)return;this.#l=z(this.#u,this.#p,e);let[n,o]=this.names(e);this.#c={pursuer:{name:n,policy:k(this.#p,"pursuer",e.pursuer)},evader:{name:o,policy:k(
this.#p,"evader",e.evader)}},this.#s=Xe(this.#l),this.#a.show(this.#u,this.#p,this.#l),this.inspector.show(this.#u,this.#p,this.#l,e),this.player.length=this.#l.
length,this.player.marks=Rr(this.#s),this.player.jump(this.#m),this.#m=0,this.#w(),this.element.dataset.played=`${e.run} ${e.pursuer} ${e.evader} ${e.episode} ${e.
seed??""}`,this.#g()}names({run:e,pursuer:r,evader:n}){let{teams:o}=this.#n[e];return[o.pursuer.script??`pursuers ${r}`,o.evader.script??`evaders ${n}`]}#b(){let{
episode:e,seed:r}=this.#o.selected,{payoff:n}=this.#p,[o,s]=this.names(this.#o.selected),a=r===null?e<n.episodes?`episode ${e+1} of ${n.episodes}`:`episode ${e+
1}, not part of the cell`:`seed ${r}`;this.#r.replaceChildren(c("span",{class:"pursuer"},o)," against ",c("span",{class:"evader"},s),c("span",{class:"muted smal\
l"},a))}#w(){let e=this.#l;if(!e||!this.#s)return;let r=this.player.step,n=this.#s.moments[r];this.#v(Array.from(n.everCaptured).filter(Boolean).length,r),this.#i.
replaceChildren(...tt(e,this.#s,r).map(o=>c("li",{class:o.kind,"data-agents":o.agents.join(" ")},o.text))),this.inspector.at(r),this.#S()}#v(e,r){this.#t.replaceChildren(
c("strong",{},e),` of ${this.#p.world.n_evaders} captured`,c("span",{class:"muted"},` · step ${r}`))}#A(e){this.#e.look={selected:e,viewers:e===null?[]:[e]},this.#S()}#S(){
let e=this.inspector.agent;for(let r of this.#i.children){let n=r.dataset.agents?.split(" ")??[];r.classList.toggle("about",e!==null&&n.includes(String(e)))}}};var Us={ArrowUp:[1,0],ArrowDown:[-1,0],ArrowRight:[0,1],ArrowLeft:[0,-1]},Bs=5;function X(t,e,r,n="pursuer"){t.tabIndex=0,t.setAttribute("role","application"),t.
addEventListener("keydown",o=>{let s=Us[o.key];if(!s)return;let[a,i]=n==="pursuer"?s:[s[1],s[0]],[l,d]=r(),u=o.shiftKey?Bs:1,{pursuer:m,evader:p}=e.selected;e.select(
{pursuer:kn(m+u*a,l),evader:kn(p+u*i,d)}),o.preventDefault(),o.stopPropagation()})}var kn=(t,e)=>Math.min(e-1,Math.max(0,t));var P={left:52,bottom:46,top:76,right:84},I=10,Ds=160,$e=P.right-I-14,Z=P.top-I-14,nt=class{element;#e;#n;#o=c("canvas",{"aria-hidden":"true"});#a=b("svg",{"ari\
a-hidden":"true"});#r=b("g");#t;#i=c("h2");#d=c("strong",{class:"rate numbers"});#u=c("span",{class:"small muted"});#l=c("p",{class:"of-both-teams small muted n\
umbers"});#c=null;constructor(e,r){[this.#n,this.#e]=[e,r],this.#t=c("div",{class:"matrix",id:"matrix","aria-label":"Payoff matrix. Arrow keys choose a match, E\
nter plays it."},this.#o,this.#a);let n=c("header",{class:"readout","aria-live":"polite"},c("div",{},this.#i,this.#l),c("div",{class:"of-cell"},this.#d,this.#u));
this.element=c("section",{class:"card matrix-card","aria-label":"Payoff matrix"},n,this.#t,Ws()),this.#g(),new ResizeObserver(()=>this.#h()).observe(this.#t),this.#t.
addEventListener("pointermove",o=>this.#b(o)),this.#t.addEventListener("pointerleave",()=>r.point({})),this.#t.addEventListener("click",o=>this.#w(o)),this.#t.addEventListener(
"mousedown",o=>{o.preventDefault(),document.activeElement instanceof HTMLElement&&document.activeElement.blur()}),X(this.#t,r,()=>this.#s.payoff.shape),this.#t.
addEventListener("keydown",o=>{o.key==="Enter"&&this.#v()}),r.on("run",()=>this.#h()),r.on("match",()=>this.#p()),r.on("hover",()=>this.#p())}get#s(){return this.#n[this.#e.
selected.run]}#h(){let[e,r]=this.#s.payoff.shape,{clientWidth:n,clientHeight:o}=this.#t;if(n<50)return;let a=Math.max(Ds,Math.min(n-P.left-P.right,o-P.top-P.bottom))/
Math.max(e,r),i=Math.max(P.left,(n-r*a-P.right+P.left)/2),l=P.top+Math.max(0,(o-P.top-P.bottom-e*a)/2),d={width:n,height:o,left:i,top:l,cell:a,rows:e,columns:r};
this.#c=d,He(this.#o,this.#s.payoff,{left:i,top:l,width:r*a,height:e*a}),this.#a.setAttribute("viewBox",`0 0 ${n} ${o}`),this.#a.replaceChildren(Fs(d),...Hs(d),
...this.#m(d),this.#r),this.#p()}#f(e){let r=this.#s.findings?.generalization;if(!r)return[];let{selected:n,hover:o}=this.#e,[s,a]=[o.pursuer??n.pursuer,o.evader??
n.evader],[i,l]=Rn(e,r.pursuers.mean[s]??0,s),[d,u]=$n(e,r.evaders.mean[a]??0,a);return[b("circle",{class:"dot of-pursuers",cx:i,cy:l,r:5}),b("circle",{class:"d\
ot of-evaders",cx:d,cy:u,r:5})]}#m(e){let r=this.#s.findings?.generalization;if(!r)return[];let{left:n,top:o,cell:s,rows:a,columns:i}=e,[l,d]=[n+i*s+I,o-I],u={class:"\
side"};return[b("rect",{...u,x:l,y:o,width:$e,height:a*s}),b("rect",{...u,x:n,y:d-Z,width:i*s,height:Z}),...Pn(r.pursuers,(m,p)=>Rn(e,m,p),"of-pursuers"),...Pn(
r.evaders,(m,p)=>$n(e,m,p),"of-evaders"),b("text",{class:"tick",x:l,y:o+a*s+16,"text-anchor":"start"},"0"),b("text",{class:"tick",x:l+$e,y:o+a*s+16,"text-anchor":"\
end"},"1"),b("text",{class:"tick",x:n-6,y:d-4,"text-anchor":"end"},"0"),b("text",{class:"tick",x:n-6,y:d-Z+8,"text-anchor":"end"},"1"),b("text",{class:"label of\
-pursuers",x:l+$e,y:o+a*s+34,"text-anchor":"end"},"captures"),b("text",{class:"label of-evaders",x:n+i*s+I,y:d-Z+10,"text-anchor":"start"},"escapes")]}#p(){let e=this.#c;
if(!e)return;let{selected:r,hover:n}=this.#e,{left:o,top:s,cell:a,rows:i,columns:l}=e,d=y=>s+(i-1-y)*a,u=[],m=(y,f)=>b("rect",{class:f,x:o,y:d(y),width:l*a+I+$e,
height:a}),p=(y,f)=>b("rect",{class:f,x:o+y*a,y:s-I-Z,width:a,height:I+Z+i*a});if(u.push(m(r.pursuer,"strip pursuer"),p(r.evader,"strip evader")),n.pursuer!==null&&
n.pursuer<i&&u.push(m(n.pursuer,"strip hover")),n.evader!==null&&n.evader<l&&u.push(p(n.evader,"strip hover")),n.lag!==null)for(let y=0;y<l;y++){let f=y+n.lag;f>=
0&&f<i&&u.push(b("rect",{class:"lagged",x:o+y*a,y:d(f),width:a,height:a}))}u.push(...this.#f(e));let h={x:o+r.evader*a,y:d(r.pursuer),width:a,height:a};u.push(b(
"rect",{class:"chosen under",...h}),b("rect",{class:"chosen",...h})),this.#r.replaceChildren(...u),this.#g()}#g(){let{selected:e,hover:r}=this.#e,n=r.pursuer??e.
pursuer,o=r.evader??e.evader,s=xe(this.#s,n,o);this.#i.replaceChildren(c("span",{class:"pursuer"},`Pursuers ${n}`)," against ",c("span",{class:"evader"},`evader\
s ${o}`)),this.#d.textContent=s?E(s.rate,3):"-",this.#u.textContent=s?`capture rate, mean of ${s.rates.length} episodes`:"the evaluation played no episodes",this.#l.
textContent=this.#x(n,o)}#x(e,r){let n=this.#s.findings?.generalization;if(!n)return"";let o=(s,a)=>Ze(s.mean[a]??0,s.low?.[a]??null,s.high?.[a]??null);return`A\
gainst all: captures ${o(n.pursuers,e)}, escapes ${o(n.evaders,r)}`}#y(e){let r=this.#c;if(!r)return null;let n=this.#t.getBoundingClientRect(),o=Math.floor((e.
clientX-n.left-r.left)/r.cell),s=r.rows-1-Math.floor((e.clientY-n.top-r.top)/r.cell),[a,i]=[s>=0&&s<r.rows,o>=0&&o<r.columns];return a||i?{g:a?s:-1,h:i?o:-1,inside:a&&
i}:null}#b(e){let r=this.#y(e);this.#e.point(r?{pursuer:r.g<0?null:r.g,evader:r.h<0?null:r.h}:{})}#w(e){let r=this.#y(e);r&&(this.#e.select({...r.g<0?{}:{pursuer:r.
g},...r.h<0?{}:{evader:r.h}}),r.inside&&this.#v())}#v(){this.#t.dispatchEvent(new CustomEvent("play",{bubbles:!0}))}};function Ws(){let t=c("span",{class:"gradi\
ent"});return t.style.backgroundImage=Mr(),c("p",{class:"scale-of-rates small muted"},"0 all escape",t,"1 all caught")}function Fs({left:t,top:e,cell:r,rows:n,columns:o}){
let s=b("g",{class:"axes"}),a=e+n*r,i=l=>Te(0,l-1,Math.min(l,l*r/44),!0);for(let l of i(o))s.append(b("text",{class:"tick",x:t+(l+.5)*r,y:a+16,"text-anchor":"mi\
ddle"},l));for(let l of i(n))s.append(b("text",{class:"tick",x:t-7,y:a-(l+.5)*r,"text-anchor":"end","dominant-baseline":"middle"},l));return s.append(b("text",{
class:"label of-evaders",x:t+o*r/2,y:a+36,"text-anchor":"middle"},"evader generation"),b("text",{class:"label of-pursuers",transform:`translate(${t-36} ${e+n*r/
2}) rotate(-90)`,"text-anchor":"middle"},"pursuer generation")),s}function Hs({left:t,top:e,cell:r,rows:n,columns:o}){let s=b("g",{class:"diagonal"}),a=Math.min(
n,o);if(a<3)return[];let i=e+n*r;for(let u of["H","V"]){let m=`M${t} ${i}`;for(let p=1;p<=a;p++){let[h,y]=[`H${t+p*r}`,`V${i-p*r}`];m+=u==="H"?h+y:y+h}s.append(
b("path",{d:m,class:"under"}),b("path",{d:m}))}let[l,d]=[t+a/2*r-.7*r-4,i-a/2*r-.7*r-4];return[s,b("text",{class:"on-cells",transform:`translate(${l} ${d}) rota\
te(-45)`,"text-anchor":"middle"},"same generation")]}var Rn=({left:t,top:e,cell:r,rows:n,columns:o},s,a)=>[t+o*r+I+s*$e,e+(n-a-.5)*r],$n=({left:t,top:e,cell:r},n,o)=>[
t+(o+.5)*r,e-I-n*Z];function Pn(t,e,r){let n=s=>s.map((a,i)=>e(a??0,i).map(l=>l.toFixed(1)).join(" ")),o=[];return t.low&&t.high&&o.push(b("path",{class:`band ${r}`,
d:`M${[...n(t.high),...n(t.low).reverse()].join("L")}Z`})),o.push(b("path",{class:`line ${r}`,d:`M${n(t.mean).join("L")}`})),o}function T(t,e,...r){return c("section",{class:"card panel","aria-label":t},c("header",{},c("h2",{},t),c("p",{class:"small muted"},e)),...r)}function On(t,e,r){let{findings:n}=t;if(!n)return null;let o=c("dialog",{class:"four","aria-label":"Four matches"}),s=i=>{let l=r();l&&Gs(o,t,i,e,l)},a=n.checkerboards.
map(i=>js(t,i,s));return{element:T("Checkerboards","Two generations of each team: each pursuers are better against one of the evaders. Click one: its four match\
es side by side.",a.length?c("div",{class:"boards"},...a):c("p",{},`No four cells differ by more than ${n.margin} in this way.`),a.length?c("p",{class:"small mu\
ted"},"The strongest of all pairs, so noise makes them look stronger than they are. The diagnosis says whether there are more than noise makes."):null,o)}}var Ln=({
pursuers:[t,e],evaders:[r,n]})=>[[t,r],[t,n],[e,r],[e,n]];function js(t,e,r){let[n,o]=e.pursuers,[s,a]=e.evaders,i=Ln(e).map(([l,d])=>{let u=t.payoff.capture_rate[l][d],
m=c("span",{class:"cell"},E(u));return m.style.backgroundColor=Ar(u),m.style.color=Sr(u),m});return c("button",{type:"button",class:"miniature numbers",onclick:()=>r(
e)},c("span",{},c("span",{class:"heard"},`Four matches of pursuers ${n} and ${o}, evaders ${s} and ${a}:`)),c("span",{class:"evader"},s),c("span",{class:"evader"},
a),c("span",{class:"pursuer"},n),i[0],i[1],c("span",{class:"pursuer"},o),i[2],i[3])}function Gs(t,e,r,n,o){let s=Ln(r).filter(([p,h])=>!Y(e,"pursuer",p)&&!Y(e,"\
evader",h)),a=s.map(([p,h])=>z(o,e,{run:n.selected.run,pursuer:p,evader:h,episode:0,seed:null})),i=new W(Math.max(0,...a.map(p=>p.length)),{speed:oe,still:N()}),
l=a.map((p,h)=>{let[y,f]=s[h],v=c("canvas",{"aria-label":`Pursuers ${y} against evaders ${f}`}),w=c("span",{class:"numbers"}),A=()=>{t.close(),n.select({pursuer:y,
evader:f})},g=c("figure",{},v,c("figcaption",{class:"small"},w,c("span",{class:"muted"},`cell ${E(e.payoff.capture_rate[y][f])}`),c("button",{type:"button",title:"\
Show this match alone",onclick:A},"open")));return g.style.gridArea=`${r.pursuers.indexOf(y)+2} / ${r.evaders.indexOf(f)+2}`,{element:g,match:p,recording:Xe(p),
board:new G(v,{numbers:!1}),tally:w}}),d=()=>l.forEach(p=>p.board.show(p.recording,i.time)),u=()=>l.forEach(({recording:p,match:h,tally:y})=>{let f=p.moments[Math.
min(i.step,h.length)];y.textContent=`${Array.from(f.everCaptured).filter(Boolean).length} of ${h.config.n_evaders} captured`});i.addEventListener("frame",d),i.addEventListener(
"step",u),t.replaceChildren(c("header",{},c("h2",{},"Four matches of a checkerboard"),c("button",{type:"button",onclick:()=>t.close()},"Close")),c("div",{class:"\
grid-of-four"},c("span"),...r.evaders.map(p=>c("h3",{class:"evader"},`evaders ${p}`)),...r.pursuers.map((p,h)=>{let y=c("h3",{class:"pursuer"},`pursuers ${p}`);
return y.style.gridArea=`${h+2} / 1`,y}),...l.map(p=>p.element)),ce(i));let m=p=>{!(p.target instanceof HTMLSelectElement||p.target instanceof HTMLButtonElement&&
p.key===" ")&&!p.defaultPrevented&&j(i,p)&&p.preventDefault()};t.addEventListener("keydown",m),t.addEventListener("close",()=>{t.removeEventListener("keydown",m),
i.pause(),l.forEach(p=>p.board.close()),t.replaceChildren()},{once:!0}),n.dispatchEvent(new Event("rest")),t.showModal(),d(),u(),N()||i.play()}var ot={pursuer:"evader",evader:"pursuer"};function Nn(t,e){let r=t.findings?.ciao;if(!r)return null;let n=["pursuer","evader"].map(o=>{let{fading:s,stripes:a,period:i}=r[`${o}\
s`],l=`fading ${E(s)}, stripes ${E(a)}${i===null?"":` every ${i} generations`}`;return zs(t,o,l,e)});return{element:T("CIAO","Current individuals against ancest\
ral opponents, by the team's own score. Stripes: intransitive, since wins and losses alternate with the age of the opponent; whether a team returns to earlier s\
trategies is recurrence, under What happened. Darker away from the diagonal: forgetting.",c("div",{class:"triangles"},...n.map(o=>o.element))),update:()=>n.forEach(
o=>o.update())}}function zs(t,e,r,n){let o=e==="pursuer"?0:1,[s,a]=[t.payoff.shape[o],t.payoff.shape[1-o]],i=(g,x)=>e==="pursuer"?t.payoff.capture_rate[g][x]:1-
t.payoff.capture_rate[x][g],l=c("canvas",{width:a,height:s,"aria-hidden":"true"}),d=l.getContext("2d"),u=d?.createImageData(a,s);for(let g=0;u&&g<s;g++)for(let x=0;x<=
Math.min(g,a-1);x++)u.data.set([...se(i(g,x)),255],4*((s-1-g)*a+x));u&&d?.putImageData(u,0,0);let m=b("rect",{class:"chosen",width:1,height:1}),p=b("rect",{class:"\
chosen under",width:1,height:1}),h=b("svg",{viewBox:`0 0 ${a} ${s}`,preserveAspectRatio:"none","aria-hidden":"true"},p,m),y=c("div",{class:"triangle","aria-labe\
l":`CIAO of the ${e}s: ${r}. Arrow keys choose a match.`},l,h);X(y,n,()=>t.payoff.shape,e),y.style.aspectRatio=`${a} / ${s}`;let f=g=>{let x=y.getBoundingClientRect(),
C=Math.floor((g.clientX-x.left)/x.width*a),B=s-1-Math.floor((g.clientY-x.top)/x.height*s);return C>=0&&B<s&&C<=B?[B,C]:null},v=g=>({[e]:g[0],[ot[e]]:g[1]});y.addEventListener(
"pointermove",g=>n.point(f(g)?v(f(g)):{})),y.addEventListener("pointerleave",()=>n.point({})),y.addEventListener("click",g=>f(g)&&n.select(v(f(g))));let w=()=>{
let g=n.hover[e]??n.selected[e],x=n.hover[ot[e]]??n.selected[ot[e]];for(let C of[m,p])C.setAttribute("x",String(x)),C.setAttribute("y",String(s-1-g)),C.style.display=
x<=g?"":"none"};return{element:c("figure",{},c("figcaption",{class:"small"},c("span",{class:e},`${e}s`)),y,c("p",{class:"small muted"},`horizontal: ${ot[e]} gen\
eration; vertical: ${e} generation`),c("p",{class:"small numbers"},r)),update:w}}var st={left:46,right:12,top:10,bottom:42},In={x:56,y:34};function at(t,e,r,n){let[o,s]=[st.left,st.top],a=Math.max(o+40,t-st.right),i=Math.max(s+40,e-st.bottom),
l=(f,v,w)=>A=>v+(A-f.low)/(f.high-f.low||1)*(w-v),[d,u]=[l(r,o,a),l(n,i,s)],m=b("g"),p=b("svg",{width:t,height:e,viewBox:`0 0 ${t} ${e}`,class:"plot"}),h=b("g",
{class:"axes"});for(let f of Te(n.low,n.high,(i-s)/In.y,n.whole))h.append(b("line",{x1:o,x2:a,y1:u(f),y2:u(f),class:"grid"}),b("text",{x:o-8,y:u(f),"text-anchor":"\
end","dominant-baseline":"middle"},Un(f)));for(let f of Te(r.low,r.high,(a-o)/In.x,r.whole))h.append(b("text",{x:d(f),y:i+16,"text-anchor":"middle"},Un(f)));return h.
append(b("line",{x1:o,x2:a,y1:i,y2:i,class:"axis"}),b("text",{x:(o+a)/2,y:e-6,"text-anchor":"middle",class:"label"},r.label),b("text",{transform:`translate(12 ${(s+
i)/2}) rotate(-90)`,"text-anchor":"middle",class:"label"},n.label)),p.append(h,m),{root:p,marks:m,left:o,right:a,top:s,bottom:i,x:d,y:u,at:f=>{let v=f-p.getBoundingClientRect().
left;return r.low+(v-o)/(a-o)*(r.high-r.low)}}}var Un=t=>String(Number(t.toPrecision(6))).replace("-","−");function Pe(t,e,r,n){let o="",s="M";r.forEach((i,l)=>{
i===null?s="M":(o+=`${s}${t.x(e[l]).toFixed(1)} ${t.y(i).toFixed(1)}`,s="L")});let a=b("path",{d:o,class:`line ${n}`});return t.root.insertBefore(a,t.marks),a}function Oe(t,e,r,n=null){let o=t.x(e);t.marks.append(b("line",{x1:o,x2:o,y1:t.top,y2:t.bottom,class:`mark ${r}`})),n!==null&&t.marks.append(b("circle",{cx:o,cy:t.
y(n),r:5,class:`dot ${r}`}))}function Dt(...t){return c("p",{class:"legend small"},...t.map(([e,r])=>c("span",{class:`key ${r}`},e)))}function it(t,e,r={}){let n=c(
"div",{class:"chart",role:"img","aria-label":t}),o=null,s=()=>{o?.marks.replaceChildren(),o&&r.marks?.(o)},a=()=>{let{clientWidth:i,clientHeight:l}=n;i<50||l<50||
(o=e(i,l),n.replaceChildren(o.root),s())};return n.addEventListener("pointermove",i=>r.point?.(o?.at(i.clientX)??null)),n.addEventListener("pointerleave",()=>r.
point?.(null)),r.choose&&(n.classList.add("chooses"),n.addEventListener("click",i=>o&&r.choose?.(o.at(i.clientX),o,i))),new ResizeObserver(a).observe(n),{element:n,
redraw:a,remark:s}}var Wt=["of-pursuers","of-evaders","of-both"],Vs=2500,Bn="Arrow keys choose generations.",Dn={low:0,high:1,label:"capture rate"};function Wn(t,e){let{training:r}=t,
{capture_rate:n,generation:o,learner:s,epochs:a}=r,i=n.map((y,f)=>(f+1)*a),l=Ks(n,r.window),d=i.at(-1)??1,u=i.length>Vs?"dense":"",m=(y,f)=>{let v=o.flatMap((w,A)=>w===
y&&(s[A]===f||s[A]===2)?[A]:[]);return v.length?[i[v[0]],i[v.at(-1)]]:null},p=it(`Capture rate in ${d} epochs of training. ${Bn}`,(y,f)=>{let v=at(y,f,{low:0,high:d,
label:"epoch",whole:!0},Dn);for(let[w,A]of[["raw",n],[u,l]])for(let[g,x]of Wt.entries()){let C=A.map((B,zt)=>s[zt]===g||s[zt+1]===g?B:null);C.some(B=>B!==null)&&
Pe(v,i,C,`${x} ${w}`)}return v},{marks:y=>{let{pursuer:f,evader:v}=e.selected;for(let[w,A]of[[0,f],[1,v]]){let g=m(e.hover[w?"evader":"pursuer"]??A,w);g&&Oe(y,(g[0]+
g[1])/2,Wt[w])}},choose:y=>{let f=Math.min(i.length-1,Math.max(0,Math.round(y/a)-1)),v=o[f];s[f]!==1&&e.select({pursuer:Math.min(v,t.payoff.shape[0]-1)}),s[f]!==
0&&e.select({evader:Math.min(v,t.payoff.shape[1]-1)})}});X(p.element,e,()=>t.payoff.shape);let h=[...new Set(s)].sort().map(y=>[["pursuers learn","evaders learn",
"both teams learn"][y],Wt[y]]);return{element:T("Training",`${pn(r.matches)} training matches. Lines: the generations that are selected.`,Dt(...h),p.element),update:p.
remark}}function Fn(t,e){let r=t.findings?.lags;if(!r)return null;let[n,o]=[r.lags[0],r.lags.at(-1)],s=Math.min(5,(Math.max(...r.cells)+1)/2),a=r.means.map((l,d)=>r.
cells[d]>=s?l:null),i=it("Lag profile",(l,d)=>{let u=at(l,d,{low:n,high:o,label:"lag: pursuer minus evader generation",whole:!0},Dn);return Pe(u,r.lags,r.means,
"raw ink"),Pe(u,r.lags,a,"ink"),u},{marks:l=>{let{pursuer:d,evader:u}=e.selected;Oe(l,0,"zero");let m=e.hover.lag??d-u;Oe(l,m,"ink",r.means[m-n])},point:l=>{let d=l===
null?null:Math.round(l);e.point({lag:d!==null&&d>=n&&d<=o?d:null})}});return{element:T("Lag profile","Left: evaders are later. Right: pursuers are later. It ris\
es if both teams keep what they learn. Faint: fewer than 5 cells.",i.element),update:i.remark}}function Hn(t,e){let r=t.findings?.ratings;if(!r)return null;let n={
pursuer:r.pursuers,evader:r.evaders},o=[...r.pursuers,...r.evaders].map(u=>u??0),[s,a]=[Math.min(...o),Math.max(...o)],i=.06*(a-s||1),l=Math.max(...t.payoff.shape)-
1,d=it(`Elo ratings by generation. ${Bn}`,(u,m)=>{let p=at(u,m,{low:0,high:l,label:"generation",whole:!0},{low:s-i,high:a+i,label:"Elo points"});for(let h of["p\
ursuer","evader"])Pe(p,n[h].map((y,f)=>f),n[h],`of-${h}s`);return p},{marks:u=>{for(let m of["pursuer","evader"]){let p=e.hover[m]??e.selected[m];Oe(u,p,`of-${m}\
s`,n[m][p]??null)}},choose:(u,m,p)=>{let h=Math.round(u),y=p.clientY-m.root.getBoundingClientRect().top,f=w=>Math.abs(m.y(n[w][h]??1/0)-y),v=f("pursuer")<=f("ev\
ader")?"pursuer":"evader";h>=0&&h<n[v].length&&e.select({[v]:h})}});return X(d.element,e,()=>t.payoff.shape),{element:T("Ratings",`One number for each generatio\
n, which cycles do not fit. The game itself: ${E(r.offset,0)} points for the pursuers.`,Dt(["pursuers","of-pursuers"],["evaders","of-evaders"]),d.element),update:d.
remark}}function Ks(t,e){let r=[0];for(let n of t)r.push(r.at(-1)+n);return t.map((n,o)=>{let[s,a]=[Math.max(0,o-Math.floor((e-1)/2)),Math.min(t.length,o+Math.floor(
e/2)+1)];return(r[a]-r[s])/(a-s)})}var Ys={present:"●",absent:"○","cannot tell":"?"};function jn(t){let{findings:e}=t;if(!e)return null;let[,...r]=e.table,n=new Map(e.reasons.map(a=>{let[i,,l]=qs(
a);return[i,l]})),o=r.map(([a,i,l,d])=>{let u=d===e.window?n.get(a):void 0;return c("li",{class:`finding ${i.replace(" ","-")}`},c("span",{class:"sign","aria-hi\
dden":"true"},Ys[i]??""),c("div",{},c("p",{},c("strong",{},a),` ${i}`,c("span",{class:"muted"},` · ${d}`)),u?c("p",{class:"small"},`${u}.`):null,c("p",{class:"\
small muted numbers"},l)))}),s=T("What happened","Each condition is present, absent, or its 95 % interval cannot tell. The intervals are about this run.",c("p",
{class:"headline"},e.headline),...e.numbers.map(a=>c("p",{class:"numbers"},`${Gn(a)}.`)),c("ul",{class:"findings"},...o),t.limits?c("p",{class:"small"},t.limits):
null,c("details",{class:"small"},c("summary",{},"Headline numbers in words"),...e.description.map(a=>c("p",{},a)),Js(e)));return s.classList.add("diagnosis"),{element:s}}
function qs(t){let[e="",r=""]=t.split(/: (.*)/s),[n="",o=""]=r.split(/, because (.*)/s);return[e.toLowerCase(),n,Gn(o.replace(/\.$/,""))]}var Gn=t=>t.charAt(0).
toUpperCase()+t.slice(1);function Js({noise:t}){return t.transitive_share_noise===null?null:c("p",{},`Last half: transitive share ${E(t.transitive_share)} (an o\
rder of strength with the same noise rarely falls below ${E(t.transitive_share_noise)}), checkerboards ${Lt(t.checkerboard_share)} (it rarely exceeds ${Lt(t.checkerboard_share_noise)}\
).`)}function zn(t){let e=[t.held_out?.pursuers,t.held_out?.evaders].filter(r=>r!=null);return e.length?{element:T("Held-out opponents",`The last generations against\
 opponents that no run has met; 95 % intervals over ${e[0].episodes} episodes.`,...e.map(Xs))}:null}function Xs(t){let e=n=>n.at(-1),r=[["mean",e(t.mean)],...Object.
entries(t.against).map(([n,o])=>[n,e(o)])];return c("table",{class:"scores numbers"},c("caption",{},c("span",{class:t.team},`${t.team}s`),` of generation ${t.generations.
at(-1)}, ${t.score}`),...r.map(([n,o],s)=>c("tr",{class:s?"":"mean"},c("th",{scope:"row"},n),c("td",{class:"range"},Zs(o,t.team)),c("td",{},Ze(o.value,o.low,o.high)))))}
function Zs({value:t,low:e,high:r},n){let o=c("span",{class:`between ${n}`});o.style.left=`${100*(e??t)}%`,o.style.width=`${100*((r??t)-(e??t))}%`;let s=c("span",
{class:`value ${n}`});return s.style.left=`${100*t}%`,c("span",{class:"scale","aria-hidden":"true"},o,s)}function Kn(t){let e=t.settings.filter(o=>o.changed),r=t.settings.filter(o=>!o.changed),n=T("Settings",`${t.schedule}, seed ${t.seed}. Every setting is an optio\
n of matrixworld evolve.`,e.length?Vn(e,"other than the default"):c("p",{class:"small"},"All settings are the defaults."),c("details",{class:"small"},c("summary",
{},`${r.length} settings with their defaults`),Vn(r,"defaults")));return n.classList.add("settings"),{element:n}}function Vn(t,e){return c("div",{class:"wide-ta\
ble"},c("table",{class:"small"},c("caption",{class:"heard"},`Settings: ${e}`),...t.map(({name:r,value:n,help:o})=>c("tr",{},c("th",{scope:"row"},`--${r.replaceAll(
"_","-")}`),c("td",{class:"numbers"},n),c("td",{class:"muted"},o)))))}function Yn(t,e,r){let n=new Map,o=c("div",{class:"panels"}),s=[],a=()=>s.forEach(l=>l.update?.()),i=()=>{let l=t[e.selected.run];s=n.get(l)??Qs(l,e,r),n.set(l,
s),o.replaceChildren(...s.map(d=>d.element)),a()};return e.on("run",i),e.on("match",a),e.on("hover",a),i(),o}function Qs(t,e,r){return[jn(t),Wn(t,e),On(t,e,r),Fn(
t,e),Hn(t,e),Nn(t,e),zn(t),Kn(t)].filter(o=>o!==null)}var qn={pursuer:null,evader:null,lag:null},lt=class extends EventTarget{#e;#n=qn;constructor(e){super(),this.#e=e}get selected(){return this.#e}get hover(){return this.#n}select(e){
let r=this.#e,n=["run","pursuer","evader"].some(o=>o in e&&e[o]!==r[o]);this.#e={...r,...n?{episode:0,seed:null}:{},...e},this.#e.run!==r.run&&this.dispatchEvent(
new Event("run")),this.dispatchEvent(new Event("match"))}point(e){let r={...qn,...e};r.pursuer===this.#n.pursuer&&r.evader===this.#n.evader&&r.lag===this.#n.lag||
(this.#n=r,this.dispatchEvent(new Event("hover")))}on(e,r){this.addEventListener(e,r)}};var ct=class{config;start;recording;actions=[];#e;#n;#o=[[]];constructor(e,r,n){[this.config,this.start]=[r,n],this.#e=e.world(r),this.#e.reset(n),this.#n=[Je(this.#e)],
this.recording=qe(r,this.#e.map(),this.#n)}get length(){return this.actions.length}get over(){return this.#e.over}get statistics(){return{capture_rate:this.#e.read(
"capture_rate")[0]}}conflicts(e){return this.#o[e]}play(e){this.#e.step(e),this.#a(e)}step(e,r,n){let[o,s]=[this.#e,this.config.n_pursuers],a=new Uint8Array(o.n_agents);
for(let i=o.n_turns;i>0&&!o.over;--i){let[l,d]=o.actors;l<s&&(a=o.decide(e.pursuer,[l,Math.min(d,s)],a)),d>s&&(a=o.decide(e.evader,[Math.max(l,s),d],a)),typeof n==
"number"?a[r]=n:l<=r&&r<d&&(a=o.decide(n,[r,r+1],a)),o.playTurn(a)}this.#a(a)}#a(e){this.actions.push(e),this.#n.push(Je(this.#e,e)),this.#o.push(this.#e.conflicts())}};var H=(t,e)=>ne[+(e>=t.n_pursuers)];function Ft(t,e){let r=new ct(t,e.config,{seed:e.seed,episode:e.episode});for(let n of e.moves)r.over||r.step(e.policies,e.seat,
n);return r}function ue(t,e){let{moments:r,nPursuers:n}=t.recording,o=r.findIndex(({alive:a,captured:i})=>!a[e]||!!i[e-n]),s=o<0?t.length:o;return{lasted:s,out:o>=
0,captured:Array.from(r[s].everCaptured).filter(Boolean).length}}var dt=(t,e)=>t.over||ue(t,e).out;function Jn(t,e,r){let n=Ft(t,{...e,moves:e.moves.slice(0,e.from)});
for(;!dt(n,e.seat);)n.step(e.policies,e.seat,r);return ue(n,e.seat)}function Xn(t){let e=t.length-1;return[...new Set([0,Math.round(e/3),e])].map(r=>t[r])}function Zn(t,{
seat:e,from:r,moves:n}){let o={...t,seat:e,...r?{from:r}:{},moves:n.join("")};return`${location.href.split("#")[0]}#${Object.entries(o).map(([s,a])=>`${s}=${a}`).
join("&")}`}function Qn(t,e){let[r,n,o]=[t.get("seat")??"",t.get("from")??"0",t.get("moves")??""];return/^\d{1,6}$/.test(r)&&Number(r)<e.n_pursuers+e.n_evaders&&
(e.diagonal?/^[0-8]+$/:/^[0-4]+$/).test(o)&&o.length<=e.max_steps&&/^\d{1,6}$/.test(n)&&Number(n)<=o.length?{seat:Number(r),from:Number(n),moves:[...o].map(Number)}:
null}function eo(t,e,r,n){let o=H(r.config,r.seat)==="evader",s=o?r.config.max_steps:r.config.n_evaders,a=c("table",{class:"numbers"},c("caption",{},o?"Steps in your\
 seat: same start, same others":"Captures of your team: same start, same others")),i=l=>{let[d,u]=[c("span",{class:o?"bar evader":"bar pursuer"}),c("td",{},"…")];
return a.append(c("tr",{},c("th",{scope:"row"},l),c("td",{class:"track","aria-hidden":"true"},d),u)),({lasted:m,captured:p})=>{d.style.width=`${100*(o?m:p)/s}%`,
u.textContent=String(o?m:p)}};i("You")(ue(e,r.seat));for(let{name:l,policy:d}of n){let u=i(l);setTimeout(()=>u(Jn(t,r,d())))}return c("div",{},a,c("p",{class:"s\
mall muted"},"One match: luck has its part in it."))}var to=()=>["file:","http:","https:"].includes(location.protocol);var ro=["·","↑","→","↓","←","↗","↘","↙","↖"];var ta={" ":0,s:0,ArrowUp:1,w:1,ArrowRight:2,d:2,ArrowDown:3,x:3,ArrowLeft:4,a:4,e:5,c:6,y:7,z:7,q:8},Ht=[8,1,5,4,0,2,7,3,6],ra=[7,8,9,4,5,6,1,2,3],na=24,oa=Math.
tan(Math.PI/8);function oo(t,e){if(t.ctrlKey||t.metaKey||t.altKey)return;let r=ra.findIndex(o=>t.code===`Numpad${o}`),n=Ht[r]??ta[t.key.length===1?t.key.toLowerCase():
t.key];return n!==void 0&&n>4&&!e?void 0:n}function so(t){let e=Ht.map(r=>c("button",{type:"button","aria-label":de[r],onclick:()=>t(r)},ro[r]));return{element:c(
"div",{class:"play-pad",role:"group","aria-label":"Your move"},...e),show:r=>e.forEach((n,o)=>n.classList.toggle("absent",Ht[o]>4&&!r))}}function no(t,e,r){let n=oa*
Math.max(Math.abs(t),Math.abs(e)),o=s=>Math.abs(s)<n?0:s;return _r([0,0],r?[o(t),o(e)]:[t,e],r)}function ao(t,e,r){let n=null,{canvas:o}=t;o.addEventListener("p\
ointerdown",({button:s,clientX:a,clientY:i})=>{n=s===0?[a,i]:null}),o.addEventListener("pointercancel",()=>{n=null}),o.addEventListener("pointerup",({clientX:s,
clientY:a})=>{let[i,l]=[n,e()];if(n=null,!i||!l)return;let[d,u]=[s-i[0],a-i[1]],m=t.cellAt(s,a);Math.hypot(d,u)>=na?r(no(u,d,l.diagonal)):m&&r(no(m[0]-l.cell[0],
m[1]-l.cell[1],l.diagonal))})}function io(t,e){let r=n=>{let o=e[n]-t[n],s=ae.findIndex(a=>a[n]===Math.sign(o)&&a[1-n]===0);return o?`${Math.abs(o)} ${de[s]}`:""};
return[r(0),r(1)].filter(Boolean).join(", ")||"on your cell"}var jt=[147,...new TextEncoder().encode("NUMPY"),1,0],sa=67324752,aa=33639248,ia=101010256,la=8,lo=2**28,pe=async t=>new Uint8Array(await new Blob([...t]).arrayBuffer());
async function ca(t,e){let r=new Blob([t]).stream().pipeThrough(e).getReader(),n=[],o=0;for(let{done:s,value:a}=await r.read();!s;{done:s,value:a}=await r.read()){
if((o+=a.length)>lo)throw new RangeError(`expected at most ${lo} bytes`);n.push(a)}return pe(n)}function me(...t){return Uint8Array.from(t.flatMap(([e,r])=>Array.
from({length:r},(n,o)=>e>>>8*o&255)))}function da({dtype:t,shape:e,data:r}){let n=typeof r=="string"?Array.from(r,l=>l.codePointAt(0)):null,o=n?`<U${n.length}`:
t,s=e.map(l=>`${l}, `).join(""),a=`{'descr': '${o}', 'fortran_order': False, 'shape': (${s}), }`,i=a.padEnd(Math.ceil((jt.length+2+a.length+1)/64)*64-jt.length-
3)+`
`;return pe([Uint8Array.from(jt),me([i.length,2]),i,n?Int32Array.from(n):r])}var ua=Int32Array.from({length:256},(t,e)=>{let r=e;for(let n=0;n<8;++n)r=r>>>1^(r&
1?3988292384:0);return r});function ma(t){return~t.reduce((e,r)=>e>>>8^ua[(e^r)&255],-1)}async function co(t){let[e,r]=[[],[]],n=0;for(let[i,l]of Object.entries(
t)){let[d,u]=[new TextEncoder().encode(`${i}.npy`),await da(l)],m=await ca(u,new CompressionStream("deflate-raw")),p=me([20,2],[0,2],[la,2],[0,2],[33,2],[ma(u),
4],[m.length,4],[u.length,4],[d.length,2],[0,2]),h=await pe([me([sa,4]),p,d,m]);e.push(h),r.push(await pe([me([aa,4],[20,2]),p,me([0,2],[0,2],[0,2],[0,4],[n,4]),
d])),n+=h.length}let o=await pe(r),s=e.length,a=me([ia,4],[0,2],[0,2],[s,2],[s,2],[o.length,4],[n,4],[0,2]);return pe([...e,o,a])}var pa="matrixworld episode 3";async function uo(t,e,r){let{config:n,actions:o,length:s,recording:a}=e,[i,l]=[n.n_pursuers+n.n_evaders,n.n_evaders],d={positions:[
"<i4",i,2],last_positions:["<i4",i,2],alive:["|b1",i],captured:["|b1",l],ever_captured:["|b1",l]},u={rewards:["<f4",i],involved:["|b1",i,3],fault:["|b1",i,3]},m={},
p=g=>{for(let x of Object.keys(g))(m[x]??=[]).push(Array.from(h.read(x),Number))},h=t.world(n);h.reset(e.start);let y=[];p(d);for(let g of o)h.step(g),p({...d,...u}),
y.push(...h.conflictTable());h.free();let f={"<i4":Int32Array,"<f4":Float32Array,"|b1":Uint8Array},v={};for(let[g,[x,...C]]of Object.entries({...d,...u})){let B=s+
+(g in d);v[g]={dtype:x,shape:[B,...C],data:f[x].from((m[g]??[]).flat())}}let w=g=>({dtype:"<i4",shape:[],data:Int32Array.of(g)}),A=g=>({dtype:"<U",shape:[],data:g});
return co({format:A(pa),n_pursuers:w(n.n_pursuers),config:A(JSON.stringify(n)),seat:w(r),...v,actions:{dtype:"|i1",shape:[s,i],data:Int8Array.from(o.flatMap(g=>[
...g]))},map:{dtype:"|b1",shape:[n.rows,n.cols],data:Uint8Array.from(a.obstacles,Number)},conflict_table:{dtype:"<i4",shape:[y.length/11,11],data:Int32Array.from(
y)}})}var ha=[0,1,2,4,8],ut=class{element;player=new W(0,{speed:4,still:N()});#e;#n;#o=c("canvas",{tabindex:0,"aria-describedby":"play-keys"});#a=c("h2");#r=c("p",{class:"\
play-told",role:"status"});#t=so(e=>this.act(e));#i=c("select",{},...ha.map(e=>c("option",{value:e},e?`${e} steps a second`:"step by step")));#d=c("input",{type:"\
checkbox"});#u=c("section",{class:"play-ending",tabindex:-1,"aria-label":"Result"});#l=ce(this.player);#c=null;#s=null;#h=[];#f=null;#m=0;#p=0;constructor(e){this.#e=
e,this.#n=new G(this.#o,{numbers:!1}),this.#o.setAttribute("role","application"),this.#i.addEventListener("change",()=>this.#y()),this.#d.addEventListener("chan\
ge",()=>this.#x()),ao(this.#n,()=>{let r=this.#f!==null&&this.#s&&S(this.#s.recording.moments.at(-1),this.#f);return r?{cell:r,diagonal:this.#s.config.diagonal}:
null},r=>this.act(r)),this.player.addEventListener("frame",()=>this.#s&&this.#n.show(this.#s.recording,this.player.time)),this.player.addEventListener("step",()=>this.#S()),
this.element=c("div",{class:"play"},c("header",{class:"play-head"},this.#a,this.#r),c("div",{class:"play-stage"},this.#o),c("div",{class:"play-side"},this.#u,this.#t.
element,c("label",{class:"play-choice"},"Pace ",this.#i),c("label",{class:"play-choice"},this.#d," Fog: see only what it sees"),c("p",{class:"small muted play-k\
eys",id:"play-keys"},"Arrow keys move and Space stays; Q W E A S D Z X C and the numeric keypad know diagonals, too. On the board: swipe, or tap where to go.")),
this.#l)}get played(){return this.#c&&{...this.#c.played,moves:this.#h}}get live(){return this.#s}play(e){this.#g(Ft(this.#e,e.played),e.played.seat,e.title),[this.#c,
this.#h,this.#m]=[e,[...e.played.moves],0],this.element.dataset.state="playing",this.#o.focus({preventScroll:!0}),dt(this.#s,e.played.seat)&&this.#w()}watch(e,r,n){
this.#c=null,this.#g(e,r,n),this.#v()}stop(){this.#y(),this.player.pause(),this.#c=null}act(e){let[r,n]=[this.#c,this.#s];if(!r||!n||this.element.dataset.state!==
"playing")return;this.#m=e;let o=Number(this.#i.value);this.#p||(this.#b(),o&&this.element.dataset.state==="playing"&&(this.#p=setInterval(()=>this.#b(),1e3/o)))}key(e){
let{target:r,key:n}=e;if(r instanceof HTMLSelectElement||r instanceof HTMLInputElement&&(r.type==="text"||n===" ")||r instanceof HTMLButtonElement&&(n===" "||n===
"Enter")||!this.#s)return!1;if(this.element.dataset.state!=="playing")return j(this.player,e);let s=oo(e,this.#s.config.diagonal);return s!==void 0&&this.act(s),
s!==void 0}#g(e,r,n){this.#y(),this.player.pause(),[this.#s,this.#f]=[e,r],this.#a.textContent=n,this.#o.ariaLabel=`Board, ${e.config.rows} by ${e.config.cols} \
cells`,this.#t.show(e.config.diagonal),this.#u.replaceChildren(),this.player.length=e.length,this.player.jump(e.length),this.#x(),this.#S()}#x(){this.#n.look={you:this.#f,
fog:this.#d.checked,viewers:this.#f===null?[]:[this.#f]}}#y(){clearInterval(this.#p),this.#p=0,this.#r.ariaLive=Number(this.#i.value)?"off":"polite"}#b(){let[{policies:e,
seat:r},n]=[this.#c.played,this.#s];n.step(e,r,this.#m),this.#h.push(this.#m),this.player.length=n.length,this.player.glide=Math.min(.22,.9/(Number(this.#i.value)||
4)),this.player.move(n.length-this.player.step),dt(n,r)&&this.#w()}#w(){this.#y();let[e,r,n]=[this.#c,this.#s,this.played],o=to()?e.link(n):null;this.#u.replaceChildren(
c("h3",{},ga(r,n.seat)),...e.ending(r,n),c("div",{class:"play-buttons"},c("button",{type:"button",class:"primary",onclick:()=>e.again()},"Again"),c("button",{type:"\
button",onclick:()=>this.#v()},"Watch it"),c("button",{type:"button",onclick:()=>{this.#A(r,n.seat)}},"Save"),o&&c("button",{type:"button",onclick:({currentTarget:s})=>va(
s,o)},"Link"))),this.element.dataset.state="ended",this.#u.focus({preventScroll:!0}),this.#u.scrollIntoView({block:"nearest"})}#v(){this.element.dataset.state="\
watched",this.player.length=this.#s.length,this.player.jump(0),N()||this.player.play()}async#A(e,r){let n=new Blob([await uo(this.#e,e,r)],{type:"application/oc\
tet-stream"});c("a",{href:URL.createObjectURL(n),download:`${F(r,e.config.n_pursuers)}-${e.length}-steps.npz`}).click()}#S(){let[e,r,{step:n}]=[this.#s,this.#f,
this.player];if(!e||n>e.length)return;let o=tt(e,e.recording,n).filter(({agents:a})=>r===null||a.includes(r)),s=[`Step ${n} of ${e.config.max_steps}`,...o.map(({
text:a})=>a)];this.#c&&n===0?s.push(fa(e.config,r)):r!==null&&s.push(ya(e,n,r)),this.#r.textContent=s.filter(Boolean).map(a=>`${a}.`).join(" ")}};function fa(t,e){
let r=t.rules.capture==="SURROUND";return H(t,e)==="evader"?`Stay free: ${r?"pursuers on all sides of you capture":"a pursuer on your cell captures"} you`:`Capt\
ure evaders: ${r?"surround them together":"reach their cell"}`}function ya({config:t,recording:e},r,n){let o=e.moments[r],a=H(t,n)==="pursuer"?"evader":"pursuer";
if(!o.alive[n])return"";let i=S(o,n),l=m=>{let[p,h]=S(o,m);return Math.max(Math.abs(p-i[0]),Math.abs(h-i[1]))},d=Array.from({length:o.alive.length},(m,p)=>p).filter(
m=>H(t,m)===a&&o.alive[m]&&!o.captured[m-t.n_pursuers]&&2*l(m)<t.fov);if(!d.length)return`No ${a} in view`;let u=d.reduce((m,p)=>l(p)<l(m)?p:m);return`Nearest ${a}\
: ${io(i,S(o,u))}`}function ga(t,e){let[{lasted:r,out:n,captured:o},{config:s}]=[ue(t,e),t];return H(s,e)==="pursuer"?`Your team captured ${o} of ${ba(s)} in ${r}\
 steps.`:n?`You lasted ${r} of ${s.max_steps} steps.`:`You escaped: ${r} steps.`}var ba=({n_evaders:t})=>`${t} evader${t===1?"":"s"}`;function va(t,e){let r=c("\
input",{type:"text",readonly:!0,value:e,"aria-label":"Link to this match"});t.replaceWith(r),r.select(),navigator.clipboard?.writeText(e).catch(()=>{})}var mt=class{dialog=c("dialog",{class:"take-over","aria-label":"Play an agent"});#e;#n;#o;#a=null;#r=null;constructor(e,r,n){[this.#e,this.#n,this.#o]=[e,r,n],n.
element.addEventListener("takeover",()=>this.open()),this.dialog.addEventListener("keydown",o=>this.#r?.key(o)&&o.preventDefault()),this.dialog.addEventListener(
"close",()=>this.#r?.stop())}get view(){return this.#r}start(e,r){this.#a=e;let n=we(r,this.#e,this.#n.selected),o=Qn(new URLSearchParams(r.replace(/^#/,"")),this.#e[n.
run].world);o&&this.#t(n,o)}open(){let e=this.#o.shown;if(!e)return;let{match:r,step:n}=e;this.#o.player.pause();let o=this.#o.inspector.agent,s=n<r.length?n:0,
a=(m,p)=>!!r.alive[p*r.n_agents+m],i=Array.from({length:r.n_agents},(m,p)=>(p+r.config.n_pursuers)%r.n_agents),l=o??i.find(m=>a(m,s)),d=a(l,s)?s:0,u=Array.from(
{length:d},(m,p)=>r.actions[p*r.n_agents+l]);this.#t(this.#n.selected,{seat:l,from:d,moves:u})}#t(e,r){let[n,o]=[this.#a,this.#e[e.run]];if(!n||ne.some(p=>Y(o,p,
e[p])))return;let{run:s,pursuer:a,evader:i,episode:l,seed:d}=e,u=H(o.world,r.seat),m=o.teams[u].kept.map(p=>({name:o.teams[u].script??`generation ${p}`,policy:()=>k(
o,u,p)}));this.#r||(this.#r=new ut(n),this.dialog.append(c("button",{type:"button",class:"leave",onclick:()=>this.dialog.close()},"Close"),this.#r.element)),this.
dialog.open||this.dialog.showModal(),this.#r.play({title:`You are ${F(r.seat,o.world.n_pursuers)}: ${this.#o.names(e).join(" against ")}`,played:{config:o.world,
seed:BigInt(d??o.seeds[a][i]),episode:l,...r,policies:{pursuer:k(o,"pursuer",a),evader:k(o,"evader",i)}},ending:(p,h)=>[eo(n,p,h,Xn(m))],again:()=>this.#t(e,{...r,
moves:r.moves.slice(0,r.from)}),link:p=>Zn({run:s,pursuers:a,evaders:i,episode:l,...d===null?{}:{seed:d}},p)})}};var V=wr(),{runs:O}=V,[wa,xa]=O[0].payoff.shape,Sa=we(location.hash,O,{run:0,pursuer:wa-1,evader:xa-1,episode:0,seed:null}),{step:mo,...Aa}=Sa,U=new lt(Aa),_=new rt(
O,U,V.playground),po=new nt(O,U),Le=new mt(O,U,_),Gt=Cr(),Ma=location.hash,he=null,Ea="Each cell is a match: pursuers of one generation against evaders of anoth\
er. Bright: many are captured. Click a cell to watch it.";document.getElementById("page").replaceWith(c("header",{class:"top"},c("div",{},c("h1",{},V.heading),c(
"p",{class:"lead"},Ea)),c("div",{class:"tools"},gr(),c("button",{type:"button",class:"keys-button",title:"Keys (?)","aria-label":"Keys (?)",onclick:()=>Gt.showModal()},
"?"))),...V.note?[c("aside",{class:"note small muted"},V.note)]:[],Er(O,U),c("main",{class:"stages"},po.element,_.element),Yn(O,U,()=>he),c("footer",{class:"mut\
ed small"},`${V.title} · matrixworld ${V.version}`),Le.dialog,Gt);Object.assign(window,{matrixworldExplorer:{get match(){return _.match},get step(){return _.player.
step},get pace(){return _.player.pace},get playing(){return Le.view},play:t=>he&&z(he,O[U.selected.run],{...U.selected,episode:t}),get shape(){return O[U.selected.
run].payoff.shape}}});po.element.addEventListener("play",()=>_.playSoon());_.goTo(mo);mo||_.playSoon();br(O,U,_);Tr(O,U,_,Gt,()=>Le.open(),()=>Bt(_.shown,V.playground));
window.addEventListener("hashchange",({newURL:t})=>he&&Le.start(he,new URL(t).hash));requestAnimationFrame(()=>setTimeout(()=>{fr().then(t=>{he=t,_.start(t),Le.
start(t,Ma),document.body.dataset.ready="true"},t=>{_.element.prepend(c("p",{class:"problem",role:"alert"},`The engine does not start here: ${String(t)}`)),document.
body.dataset.ready="true"})}));})();
