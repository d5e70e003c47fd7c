/* built from web/ by "npm run build"; sources 84cb6e11e426d716282999a8ba3d0dcad160afa33a35e53207c09ef1257b6fc8 */
"use strict";(()=>{var gt={SIMULTANEOUS:0,SWARM_TURNS:1,AGENT_TURNS:2},Q={DISAPPEAR:0,REACH:1,BOUNCE:2},bt={OCCUPATION:0,SURROUND:1},yt={FAULT:0,INVOLVED:1};var vt=["obstacle","teammate","adversary"],Ve=["vertex","edge","chain"],wt=["turn","kind","form","first","second","row","col","at_fault","held","doomed"],Ke=["p\
ursuer_{number}","evader_{number}"],xt={obstacle:"{first} ran into the obstacle or border at {cell}",vertex:"{first} and {second} both headed for {cell}",edge:"\
{first} and {second} meant to swap, {first} to {cell}",chain:"{first} headed for {cell}, where {second} had to stay"},ee={"both held":"both bounce","both doomed":"\
both disappear",held:"{agent} bounces",doomed:"{agent} disappears",none:"nobody is stopped"},_t="{event}: {outcome}",Xe={random:"any action, all equally likely",
still:"always stays",chaser:"moves to where the nearest adversary in view is nearest",fleer:"moves to where the nearest adversary in view is farthest","clumsy-c\
haser":"a chaser that takes any action in half of the steps","clumsy-fleer":"a fleer that takes any action in half of the steps",hunter:"a chaser of the nearest\
 adversary in view to which no teammate in view is nearer",surrounder:"a chaser of the nearest free cell beside an adversary in view without a teammate",dodger:"\
moves to where all adversaries in view together are farthest; each cell that holds some weighs 2**14 // (1 + moves)**2"},Mt={free:".GS",blocked:"#@OTW"};var D=1+wt.length;function te(t,e){return t.replace(/\{(\w+)\}/g,(r,n)=>String(e[n]))}function qe(t,e){return t<e?te(Ke[0],{number:t}):te(Ke[1],{number:t-e})}function sn(t,e){
let[r,n,o,s,a,i,l,...c]=Array.from(t),d=a<0?[s]:[s,a],[m,p,f]=c.map(w=>d.filter((_,v)=>w>>v&1)),g=d.map(w=>qe(w,e)),h=te(xt[a<0?"obstacle":Ve[o]],{first:g[0],second:g[g.
length-1],cell:`(${i}, ${l})`}),y=te(_t,{event:h,outcome:an(d.length,p,f,e)});return{kind:vt[n],form:Ve[o],agents:d,cell:[i,l],at_fault:m,held:p,doomed:f,turn:r,
text:y}}function an(t,e,r,n){if(t===2&&e.length===2)return ee["both held"];if(t===2&&r.length===2)return ee["both doomed"];let o=s=>a=>te(ee[s],{agent:qe(a,n)});
return[...e.map(o("held")),...r.map(o("doomed"))].join(", ")||ee.none}function we(t,e){let r=[];for(let n=0;n<t.length;n+=D)r.push(sn(t.subarray(n+1,n+D),e));return r}var L=class extends Error{name="EngineError"};function M(t,e,r){let n=typeof r=="string"?`'${r}'`:typeof r=="object"?JSON.stringify(r):String(r);return new L(`${t}\
: expected ${e}, got ${n}`)}var W=class{bytes;constructor(e){this.bytes=e}},At=0,Je=[Uint8Array,Uint8Array,Int32Array,BigInt64Array,BigUint64Array,Float32Array,Float64Array],Et=4,St=4,ln=new TextEncoder,
cn=new TextDecoder;function un(t){for(let e=Je.length-1;e>At;--e)if(t instanceof Je[e])return e;throw new TypeError("array: expected a typed array of the engine\
's numbers, got another")}function Ye(t){return new Uint8Array(t.buffer,t.byteOffset,t.byteLength)}function dn(t){return ln.encode(`${t}\0`)}var Ze=class{engine;addresses=[];constructor(e){
this.engine=e}copy(e){let r=this.engine._malloc(Math.max(e.length,1));if(r===0)throw new L("memory: expected room for the arguments, got none");return this.addresses.
push(r),this.engine.HEAPU8.set(e,r),r}text(e){return this.copy(dn(e))}arrays(e){let r=Object.entries(e),n=r.flatMap(([s,a])=>{let i=a instanceof W,l=i?a.bytes:a;
return[this.text(s),i?At:un(l),l.length,this.copy(Ye(l))]}),o=this.copy(Ye(Int32Array.from(n)));return this.copy(Ye(Int32Array.of(r.length,o)))}free(){for(let e of this.
addresses)this.engine._free(e)}};function Ct(t,e){let r=t.HEAPU8;return cn.decode(r.subarray(e,r.indexOf(0,e)))}function xe(t){let e=new Int32Array(t.HEAPU8.buffer),
r=t._last_outputs()/Et,n=e[r+1]/Et,o={};for(let s=n;s<n+e[r]*St;s+=St){let a=Je[e[s+1]],i=e[s+2]*a.BYTES_PER_ELEMENT,l=e[s+3];o[Ct(t,e[s])]=new a(t.HEAPU8.slice(
l,l+i).buffer)}return o}function re(t,e){let r=new Ze(t);try{let n=e(r);if(n===0)throw new L(Ct(t,t._last_error()));return n}finally{r.free()}}var mn=2**31-1,pn=2n**64n-1n,hn=34028234663852886e22;function O(t,e){if(typeof e!="number"||!Number.isInteger(e)||Math.abs(e)>mn)throw M(t,"an integer",e);return Int32Array.
of(e)}function _e(t,e){if(typeof e!="boolean")throw M(t,"true or false",e);return new W(Uint8Array.of(Number(e)))}function N(t,e,r){let n=typeof e=="string"&&Object.
hasOwn(r,e)?r[e]:void 0;if(n===void 0)throw M(t,`one of ${Object.keys(r).join(", ")}`,e);return Int32Array.of(n)}function Qe(t,e){if(typeof e!="number"||!(Math.
abs(e)<=hn))throw M(t,"a finite number",e);return e}function G(t,e){let n=typeof e=="bigint"||typeof e=="number"&&Number.isSafeInteger(e)?BigInt(e):-1n;if(n<0n||
n>pn)throw M(t,"an integer from 0 to 2^64 - 1",e);return BigUint64Array.of(n)}function fn(t){return{"rules.interaction":N("interaction",t.interaction,gt),"rules\
.obstacle":N("obstacle",t.obstacle,Q),"rules.teammate":N("teammate",t.teammate,Q),"rules.evader":N("evader",t.evader,Q),"rules.pursuer":N("pursuer",t.pursuer,Q),
"rules.capture":N("capture",t.capture,bt),"rules.captured_disappear":_e("captured_disappear",t.captured_disappear)}}function Tt(t,e){let r=typeof e=="number"?[e,
e,e]:e;if(!Array.isArray(r)||r.length!==3)throw M(t,"1 or 3 numbers",e);return Float32Array.from(r,n=>Qe(t,n))}function gn(t){let e=(r,n)=>Float32Array.of(Qe(r,
t[r]),Qe(n,t[n]));return{"rewards.capture":e("pursuer_capture","evader_capture"),"rewards.neighbor":e("pursuer_neighbor","evader_neighbor"),"rewards.step":e("pu\
rsuer_step","evader_step"),"rewards.pursuer_collide":Tt("pursuer_collide",t.pursuer_collide),"rewards.evader_collide":Tt("evader_collide",t.evader_collide),"rew\
ards.blame":N("blame",t.blame,yt),"rewards.capture_repeats":_e("capture_repeats",t.capture_repeats)}}function kt(t){if(t===void 0||typeof t=="number")return new Uint8Array(
0);if(t instanceof Uint8Array)return t;let{free:e,blocked:r}=Mt;for(let[n,o]of t.entries()){if(o.length!==t[0]?.length)throw M(`map, row ${n}`,`${t[0]?.length} \
cells as in row 0`,o.length);let s=[...o].find(a=>!e.includes(a)&&!r.includes(a));if(s)throw M(`map, row ${n}`,`'${e}' (free) or '${r}' (obstacle)`,s)}return Uint8Array.
from([...t.join("")],n=>Number(r.includes(n)))}function Pt(t,e){if(!Array.isArray(t))return;let r=[t.length,t[0]?.length??0];if(!(r[0]===e.rows&&r[1]===e.cols))
throw M("obstacle map",`shape (${e.rows}, ${e.cols}), the rows and cols`,r)}function Me(t){Pt(t.obstacles,t);let e=typeof t.obstacles=="number"?t.obstacles:0;return{
...fn(t.rules),...gn(t.rewards),rows:O("rows",t.rows),cols:O("cols",t.cols),n_pursuers:O("n_pursuers",t.n_pursuers),n_evaders:O("n_evaders",t.n_evaders),fov:O("\
fov",t.fov),diagonal:_e("diagonal",t.diagonal),max_steps:O("max_steps",t.max_steps),density:Float64Array.of(e),map:kt(t.obstacles)}}function Rt(t,e){return Int32Array.
from((e??[]).flat(),r=>O(t,r)[0])}function Ot(t,e){return Pt(t.obstacles,e),{seed:G("seed",t.seed??0n),episode:G("episode",t.episode??0),pursuers:Rt("pursuers",
t.pursuers),evaders:Rt("evaders",t.evaders),map:kt(t.obstacles)}}function Ee(t){return{actions:Int32Array.from(t,e=>O("actions",e)[0])}}function j(t){if(typeof t==
"string"){if(!Object.hasOwn(Xe,t))throw M("policy",`one of ${Object.keys(Xe).join(", ")}`,t);return{script:new TextEncoder().encode(t)}}if(t.activation!=="relu"&&
t.activation!=="tanh")throw M("activation","'relu' or 'tanh'",t.activation);return{hidden:Int32Array.from(t.hidden,e=>O("hidden",e)[0]),activation:new TextEncoder().
encode(t.activation),sampled:_e("sampled",t.sampled),genome:t.genome}}var bn=["first_turn","terminated","truncated"];function It(t){let e={...t};for(let r of bn)
e[r]=new W(t[r]);return e}var Se=class{config;seed;episode;n_agents;statistics;positions;last_positions;alive;captured;ever_captured;actions;rewards;involved;fault;map;conflict_table;first_conflict;constructor(e,r,n,o){
this.config=e,this.seed=r,this.episode=n,this.n_agents=e.n_pursuers+e.n_evaders,this.statistics=Lt(o,0),this.positions=o.positions,this.last_positions=o.last_positions,
this.alive=o.alive,this.captured=o.captured,this.ever_captured=o.ever_captured,this.actions=o.actions,this.rewards=o.rewards,this.involved=o.involved,this.fault=
o.fault,this.map=o.map,this.conflict_table=o.conflict_table,this.first_conflict=yn(this.conflict_table,this.length)}get length(){return this.actions.length/this.
n_agents}conflicts(e){this.check(e);let[r,n]=[this.first_conflict[e],this.first_conflict[e+1]],o=this.conflict_table.subarray(r*D,n*D);return we(o,this.config.n_pursuers)}seek(e,r){
this.check(r),(!(e.seed===this.seed&&e.episode===BigInt(this.episode))||e.turn!==0||e.steps>r)&&e.reset({seed:this.seed,episode:this.episode});for(let o=e.steps;o<
r;++o)e.step(this.actions.subarray(o*this.n_agents,(o+1)*this.n_agents))}check(e){if(!(Number.isInteger(e)&&e>=0&&e<=this.length))throw M("step",`0 to ${this.length}`,
e)}};function yn(t,e){let r=new Int32Array(e+2);for(let n=0;n<t.length;n+=D)++r[t[n]+1];for(let n=1;n<r.length;++n)r[n]+=r[n-1];return r}function Lt(t,e){let r=t["\
statistics.length"].length,n=s=>{let a=t[`statistics.${s}`],i=a.length/r;return a.slice(e*i,(e+1)*i)},o=s=>Number(n(s)[0]);return{capture_rate:o("capture_rate"),
ever_capture_rate:o("ever_capture_rate"),captured_fraction:o("captured_fraction"),length:o("length"),return:n("return"),survivors:n("survivors"),overlap:n("over\
lap"),collisions:n("collisions"),faults:n("faults"),agent_steps:n("agent_steps")}}function Nt(t,e,r,n){let o=[Me(r.config),j(r.pursuers),j(r.evaders),n];return re(
t,s=>{let[a,i,l,c]=o.map(d=>s.arrays(d));return t[e](a,i,l,c)}),xe(t)}function $t(t,e,r,n){let o={seed:G("seed",r),episode:G("episode",n)};return new Se(e.config,
r,n,Nt(t,"_play_match",e,o))}function Ut(t,e,r,n){if(!Number.isInteger(n)||n<1)throw M("n_episodes","at least 1",n);let o={seed:G("seed",r),n_episodes:Int32Array.
of(n)},s=Nt(t,"_play_rollout",e,o);return Array.from({length:n},(a,i)=>Lt(s,i))}var Ht=new FinalizationRegistry(([t,e])=>t._world_free(e)),ne=class{config;n_agents;n_actions;engine;at;freed=!1;constructor(e,r){this.engine=e,this.config=r,this.
n_agents=r.n_pursuers+r.n_evaders,this.n_actions=r.diagonal?9:5,this.at=re(e,n=>e._world_new(n.arrays(Me(r)))),Ht.register(this,[e,this.at],this)}free(){this.freed||
(this.freed=!0,Ht.unregister(this),this.engine._world_free(this.at))}reset(e={}){let r=Ot(e,this.config);this.call(n=>this.engine._world_reset(this.at,n.arrays(
r)))}step(e){let r=Ee(e);this.call(n=>this.engine._world_step(this.at,n.arrays(r)))}playTurn(e){let r=Ee(e);this.call(n=>this.engine._world_play_turn(this.at,n.
arrays(r)))}decide(e,r,n){let{n_pursuers:o}=this.config,s=r==="pursuer"?[0,o]:[o,this.n_agents];return this.choose(e,s,n)}choose(e,[r,n],o){if(o.length!==this.n_agents)
throw M("actions",String(this.n_agents),o.length);let s=[j(e),Ee(o)],{actions:a}=this.call(i=>this.engine._world_decide(this.at,i.arrays(s[0]),r,n,i.arrays(s[1])));
return Uint8Array.from(a)}get n_turns(){return this.turnNumbers()[1]}get turn(){return this.turnNumbers()[0]}get actors(){let[,,e,r]=this.turnNumbers();return[e,
r]}turnNumbers(){return this.call(()=>this.engine._world_turn(this.at)).turn}get steps(){return this.read("steps")[0]}get seed(){return this.read("seed")[0]}get episode(){
return this.read("episode")[0]}get over(){return this.read("terminated")[0]===1||this.read("truncated")[0]===1}read(e){return this.call(r=>this.engine._world_read(
this.at,r.text(e)))[e]}view(e){let r=3*this.config.fov**2;return this.read("views").slice(e*r,(e+1)*r)}map(){return this.read("state").slice(2*this.config.rows*
this.config.cols)}conflicts(){let{conflict_table:e}=this.call(()=>this.engine._world_conflicts(this.at));return we(e,this.config.n_pursuers)}answer(e,r){let n=j(
e),{logits:o}=this.call(i=>this.engine._world_logits(this.at,i.arrays(n),r)),s=o,a=this.choose(e,[r,r+1],new Uint8Array(this.n_agents))[r];return{logits:s,probabilities:vn(
s),action:a}}snapshot(){return this.call(()=>this.engine._world_snapshot(this.at))}restore(e){let r=It(e);this.call(n=>this.engine._world_restore(this.at,n.arrays(
r)))}call(e){if(this.freed)throw M("world","one that is in use","one that was freed");return re(this.engine,e),xe(this.engine)}};function vn(t){let e=Math.max(...t),
r=Array.from(t,o=>Math.exp(o-e)),n=r.reduce((o,s)=>o+s,0);return Float32Array.from(r,o=>o/n)}var et=class{compiled;constructor(e){this.compiled=e}world(e){return new ne(this.compiled,e)}match(e,r,n,o,s=0){return $t(this.compiled,{config:e,pursuers:r,evaders:n},
o,s)}rollout(e,r,n,o,s){return Ut(this.compiled,{config:e,pursuers:r,evaders:n},o,s)}},Ft;function Bt(t=globalThis.matrixworldEngine){return Ft??=wn(t),Ft}async function wn(t){
if(!t)throw new Error("matrixworldEngine: expected the script engine.js before this one, got none");let e=Uint8Array.from(atob(t.binary),r=>r.charCodeAt(0));return new et(
await t({wasmBinary:e}))}var xn="http://www.w3.org/2000/svg";function u(t,e={},...r){return Dt(document.createElement(t),e,r)}function b(t,e={},...r){return Dt(document.createElementNS(
xn,t),e,r)}function Dt(t,e,r){for(let[n,o]of Object.entries(e))o==null||o===!1||(typeof o=="function"?t.addEventListener(n.slice(2),o):t.setAttribute(n,o===!0?"":
String(o)));return t.append(...r.filter(_n).map(n=>typeof n=="number"?String(n):n)),t}function _n(t){return t!=null&&t!==!1}var Mn=matchMedia("(prefers-color-scheme: dark)");function En(){let t=document.documentElement.dataset.theme;return t?t==="dark":Mn.matches}function tt(){document.
documentElement.dataset.theme=En()?"light":"dark"}function Wt(){return u("button",{type:"button",title:"Light or dark (D)","aria-label":"Light or dark",onclick:tt},"◐")}function jt(){return JSON.parse(zt("data"))}function oe(t,e,r){let[n,o]=[e-t.payoff.first[0],r-t.payoff.first[1]],s=t.payoff.capture_rate[n]?.[o];return s===void 0?
null:{rate:s,rates:t.payoff.capture_rates[n][o],lengths:t.payoff.lengths[n][o]}}function se(t,e,r){let n=t.teams[e];return n.script!==null||n.kept.includes(r)}function ae(t,e,r){
let{script:n,network:o,kept:s,genomes:a}=t.teams[e];if(n!==null||o===null)return n??"random";let i=s.indexOf(r);if(i<0)throw new RangeError(`${e}: expected a ge\
neration whose genome the page holds, got ${r}`);let l=o.genome_size,c=Sn(a).subarray(i*l,(i+1)*l);return{hidden:o.hidden,activation:o.activation,sampled:o.sampled,
genome:c}}var Gt=new Map;function Sn(t){let e=Gt.get(t);if(e)return e;let r=atob(zt(t)),n=new Uint8Array(r.length);for(let s=0;s<n.length;s++)n[s]=r.charCodeAt(
s);let o=new Float32Array(n.buffer);return Gt.set(t,o),o}function zt(t){return document.getElementById(t)?.textContent??""}var An={now:()=>performance.now(),request:t=>requestAnimationFrame(t),cancel:t=>cancelAnimationFrame(t)},ie=[.5,1,2,4,8,16,32,64],z=class extends EventTarget{#e;#n;#s;#a;#r=0;#t=0;#o=!1;#c=null;#u=0;glide=.28;constructor(e,r={}){
super(),this.#e=e,this.#n=r.speed??4,this.#a=r.still??!1,this.#s=r.clock??An}get step(){return this.#r}get time(){return this.#a?this.#r:this.#t}get arrived(){return this.#t===
this.#r}get playing(){return this.#o}get length(){return this.#e}set length(e){this.#e=e,this.#r>e&&this.jump(e),this.#m("state")}get speed(){return this.#n}set speed(e){
this.#n=e,this.#m("state")}changeSpeed(e){let r=ie.findIndex(n=>n>=this.#n);this.speed=ie[Math.min(ie.length-1,Math.max(0,r+e))]}play(){this.#o||!this.#e||(this.#r===
this.#e&&this.jump(0),this.#o=!0,this.#m("state"),this.#d())}pause(){this.#o&&(this.#o=!1,this.#m("state"))}toggle(){this.#o?this.pause():this.play()}move(e){this.
pause();let r=Math.min(this.#e,Math.max(0,this.#r+e));Math.abs(r-this.#t)>1?this.jump(r):this.#i(r),this.#d()}jump(e){this.#t=Math.min(this.#e,Math.max(0,Math.round(
e))),this.#i(this.#t),this.#m("frame")}#i(e){e!==this.#r&&(this.#r=e,this.#m("step"))}#d(){this.#c===null&&(this.#u=this.#s.now(),this.#c=this.#s.request(()=>this.#l()))}#l(){
this.#c=null;let e=this.#s.now();this.#p(Math.min(.25,(e-this.#u)/1e3)),this.#u=e,this.#m("frame"),(this.#o||this.#t!==this.#r)&&(this.#c=this.#s.request(()=>this.#l()))}#p(e){
let r=e;for(;r>0;){if(this.#t===this.#r){if(!this.#o)return;if(this.#r===this.#e)return this.pause();this.#i(this.#r+1)}let n=this.#o?this.#n:1/this.glide,o=this.#r-
this.#t,s=Math.min(Math.abs(o),r*n);r-=s/n,this.#t=s===Math.abs(o)?this.#r:this.#t+Math.sign(o)*s}this.#o&&this.#t===this.#e&&this.pause()}#m(e){this.dispatchEvent(
new Event(e))}};function V(t,e){if(e.ctrlKey||e.metaKey||e.altKey)return!1;let r=e.shiftKey?10:1,o={" ":()=>t.toggle(),ArrowRight:()=>t.move(r),ArrowLeft:()=>t.
move(-r),Home:()=>t.move(-t.length),End:()=>t.move(t.length),"+":()=>t.changeSpeed(1),"-":()=>t.changeSpeed(-1)}[e.key];return o?.(),o!==void 0}var le=[[68,1,84],[72,26,108],[71,47,125],[65,68,135],[57,86,140],[49,104,142],[42,120,142],[35,136,142],[31,152,139],[34,168,132],[53,183,121],[84,197,104],[122,
209,81],[165,219,54],[210,226,27],[253,231,37]];function ce(t){let e=Math.min(1,Math.max(0,t))*(le.length-1),r=Math.min(le.length-2,Math.floor(e)),[n,o]=[le[r],
le[r+1]],s=a=>Math.round(n[a]+(e-r)*(o[a]-n[a]));return[s(0),s(1),s(2)]}var Vt=t=>`rgb(${ce(t).join(" ")})`,Kt=()=>`linear-gradient(to right, ${le.map(t=>`rgb(${t.
join(" ")})`).join(", ")})`;function Ae(t,e,r){let n=devicePixelRatio||1;t.style.left=`${r.left}px`,t.style.top=`${r.top}px`,t.style.width=`${r.width}px`,t.style.height=`${r.height}px`,t.width=
Math.round(r.width*n),t.height=Math.round(r.height*n);let o=t.getContext("2d"),s=Cn(e);!o||!s||(o.imageSmoothingEnabled=!1,o.drawImage(s,0,0,t.width,t.height))}
function Cn(t){let[e,r]=t.shape,n=document.createElement("canvas");[n.width,n.height]=[r,e];let o=n.getContext("2d");if(!o)return null;let s=o.createImageData(r,
e);return t.capture_rate.forEach((a,i)=>a.forEach((l,c)=>{let d=4*((e-1-i-t.first[0])*r+c+t.first[1]);s.data.set([...ce(l),255],d)})),o.putImageData(s,0,0),n}var Tn=84;function Xt(t,e){let r=t.map((s,a)=>Rn(s,a,e)),n=u("nav",{class:"races",role:"tablist","aria-label":"Runs"},...r.map(s=>s.button)),o=()=>r.forEach((s,a)=>s.
update(a===e.selected.run));return e.on("match",o),e.on("hover",o),o(),n.hidden=t.length<2,n}function Rn(t,e,r){let[n,o]=t.payoff.shape,s=Tn/Math.max(n,o),a=u("\
canvas",{"aria-hidden":"true"});Ae(a,t.payoff,{left:0,top:0,width:o*s,height:n*s});let i=u("span",{class:"place"}),l=u("button",{type:"button",role:"tab",class:"\
race",title:`Key ${e+1}`,onclick:()=>rt(t,e,r)},u("span",{class:"small-matrix"},a,i),u("span",{class:"race-text"},u("strong",{},t.name),u("span",{class:"small"},
t.findings?t.findings.headline:`${t.learning.join(" and ")}s against ${kn(t)}`),t.schedule===t.name?null:u("span",{class:"small muted"},`${t.schedule}, seed ${t.
seed}`)));return{button:l,update:d=>{l.ariaSelected=String(d);let m=r.hover.pursuer??r.selected.pursuer,p=r.hover.evader??r.selected.evader;i.hidden=m>=n||p>=o,
i.style.left=`${(p+.5)*s}px`,i.style.top=`${(n-m-.5)*s}px`}}}var kn=t=>t.teams.pursuer.script??t.teams.evader.script??"another run";function rt(t,e,r){let[n,o]=t.
payoff.shape,{pursuer:s,evader:a}=r.selected;r.select({run:e,pursuer:Math.min(s,n-1),evader:Math.min(a,o-1)})}var Pn=[[["Space"],"play or pause"],[["←","→"],"step back or forward; with Shift ten steps"],[["Home","End"],"first or last step"],[["+","−"],"faster or s\
lower"],[["N"],"next episode of the same pair; with Shift the one before"],[["R"],"another seed, not one of the evaluation"],[["O"],"the cell's own seed again"],
[["P"],"next pursuer generation; with Shift the one before"],[["E"],"next evader generation; with Shift the one before"],[["M"],"to the matrix: arrow keys choos\
e a match, Enter plays it"],[["A"],"next agent: what it sees; with Shift the one before"],[["Esc"],"no agent"],[["1","9"],"first to ninth run"],[["D"],"light or\
 dark"],[["?"],"this list"]];function qt(){let t=Pn.map(([r,n])=>u("div",{class:"key-row"},u("dt",{},...r.map(o=>u("kbd",{},o))),u("dd",{},n))),e=u("dialog",{class:"\
help","aria-labelledby":"help-title"},u("h2",{id:"help-title"},"Keys"),u("dl",{class:"keys"},...t),u("p",{class:"muted small"},"The page holds the genomes and t\
he engine of this run. A click on a cell plays that very match: same seed, same moves. Triangles pursue, discs evade; a ring is a captured evader, a star a capt\
ure, dashed cells are conflicts. The page loads nothing from elsewhere; share the file as it is."),u("button",{type:"button",onclick:()=>e.close()},"Close"));return e.
addEventListener("click",r=>r.target===e&&e.close()),e}function Yt(t,e,r,n){let o=(a,i)=>()=>{let l=t[e.selected.run].payoff.shape[a==="pursuer"?0:1];e.select({
[a]:Math.min(l-1,Math.max(0,e.selected[a]+i))})},s={n:()=>e.select({episode:e.selected.episode+1}),N:()=>e.select({episode:Math.max(0,e.selected.episode-1)}),r:()=>e.
select({seed:String(crypto.getRandomValues(new BigUint64Array(1))[0]),episode:0}),o:()=>e.select({seed:null,episode:0}),p:o("pursuer",1),P:o("pursuer",-1),e:o("\
evader",1),E:o("evader",-1),m:()=>document.getElementById("matrix")?.focus(),a:()=>r.inspector.next(1),A:()=>r.inspector.next(-1),Escape:()=>r.inspector.choose(
null),d:tt,"?":()=>n.showModal()};document.addEventListener("keydown",a=>{let i=a.target instanceof HTMLSelectElement||a.target instanceof HTMLInputElement,l=a.
target instanceof HTMLButtonElement&&(a.key===" "||a.key==="Enter");if(document.querySelector("dialog[open]")||i||l||a.defaultPrevented||a.ctrlKey||a.metaKey||a.
altKey)return;let c=s[a.key]??s[a.key.toLowerCase()],d=Number(a.key)-1;if(V(r.player,a)||c)c?.();else if(t[d])rt(t[d],d,e);else return;a.preventDefault()})}var nt=[[0,0],[-1,0],[0,1],[1,0],[0,-1],[-1,1],[1,1],[1,-1],[-1,-1]],$=(t,e)=>e<t.nPursuers,E=(t,e)=>[t.positions[2*e],t.positions[2*e+1]],On=(t,e)=>t[0]===e[0]&&
t[1]===e[1],ot=({rows:t,cols:e},[r,n])=>r>=0&&n>=0&&r<t&&n<e,st=(t,e,r=3)=>t!==void 0&&[0,1,2].slice(0,r).some(n=>t[3*e+n]),at=(t,e)=>st(t.fault,e),Jt=(t,e)=>!at(
t,e)&&st(t.involved,e,2);function Ce(t,e,r){let n=!On(E(t,r),E(e,r)),o=e.involved===void 0||st(e.involved,r);return!!(e.alive[r]&&e.actions?.[r]&&!n&&o)}function Te(t,e,r){
let[n,o]=E(t,r),[s,a]=nt[e.actions?.[r]??0];return[n+s,o+a]}function Re(t,e,r){return Array.from({length:r.everCaptured.length},(o,s)=>s).filter(o=>r.everCaptured[o]&&
!e.everCaptured[o]).map(o=>t.nPursuers+o)}function ke(t,e){return Array.from({length:e.alive.length},(n,o)=>o).filter(n=>t.alive[n]&&!e.alive[n])}var Zt=[-.31,0,.31],Qt=[{size:1,at:[[0,0]]},{size:.62,at:[[-.2,.2],[.2,-.2]]},{size:.54,at:[[-.23,.22],[.23,.22],[0,-.22]]},{size:.54,at:[[-.23,.23],[.23,.23],[
-.23,-.23],[.23,-.23]]},{size:.36,at:Zt.flatMap(t=>Zt.map(e=>[e,t]))}],In=.3,Ln=.35,Nn=.55;function ue(t,e){let r=new Map;for(let n=0;n<e.alive.length;n++){if(!e.
alive[n])continue;let[o,s]=E(e,n),a=o*t.cols+s,i=r.get(a);i?i.push(n):r.set(a,[n])}return r}function er(t,e){let r=Array.from(e.alive,(n,o)=>{let[s,a]=E(e,o);return{
x:a+.5,y:s+.5,size:1,alpha:0}});for(let n of ue(t,e).values()){let o=Qt[Math.min(n.length,Qt.length)-1];n.forEach((s,a)=>{let[i,l]=o.at[Math.min(a,o.at.length-1)],
c=r[s];c.x+=i,c.y+=l,c.size=o.size,c.alpha=1})}return r}var tr=t=>t*t*(3-2*t),K=(t,e,r)=>t+(e-t)*r,rr=t=>Math.min(1,Math.max(0,t));function nr(t,e,r,n){let o={1:2,
2:r}[t.interaction]??1;if(o===1)return tr(n);let s=o===r?e:+!$(t,e),a=Math.max(1/o,Ln);return tr(rr((n-s/(o-1)*(1-a))/a))}function Pe(t,e){let r=t.moments.length-
1,n=Math.min(Math.floor(e),r),o=t.moments[n],s=er(t,o);if(n===r||e===n)return s;let a=t.moments[n+1],i=er(t,a);return s.map((l,c)=>{let d=nr(t,c,s.length,e-n);return $n(
o,a,c,l,i[c],d)})}function or(t,e,r){let n=t.moments.length-1,o=Math.min(Math.floor(r),n),[s,a]=[t.moments[o],t.moments[Math.min(o+1,n)]],i=nr(t,e,s.alive.length,
r-o),[[l,c],[d,m]]=[E(s,e),E(a,e)];return[K(c,m,i)+.5,K(l,d,i)+.5]}function $n(t,e,r,n,o,s){let a=n.alpha>o.alpha,i={x:K(n.x,o.x,s),y:K(n.y,o.y,s),size:a?n.size:
K(n.size,o.size,s),alpha:a?rr((1-s)/(1-Nn)):K(n.alpha,o.alpha,s)};if(Ce(t,e,r)){let[l,c]=E(t,r),[d,m]=Te(t,e,r),p=In*Math.sin(Math.PI*s);i.x+=(m-c)*p,i.y+=(d-l)*
p}return i}var sr=2*Math.PI;function U(t,e,r,n){t.beginPath(),t.arc(e,r,n/2,0,sr)}function Oe(t,e,r,n){let o=n/2,s=[[0,-.97],[.97,.83],[-.97,.83]].map(([a,i])=>[e+a*o,r+i*
o]);t.beginPath(),t.moveTo((s[2][0]+s[0][0])/2,(s[2][1]+s[0][1])/2),s.forEach(([a,i],l)=>{let[c,d]=s[(l+1)%3];t.arcTo(a,i,c,d,n*.09)}),t.closePath()}function ar(t,e,r,n){
let o=n*.32;t.beginPath(),t.moveTo(e-o,r-o),t.lineTo(e+o,r+o),t.moveTo(e+o,r-o),t.lineTo(e-o,r+o)}function ir(t,e,r,n){t.beginPath();for(let o=0;o<16;o++){let s=n/
2*(o%2?.6:.95),a=sr*o/16;t.lineTo(e+s*Math.sin(a),r-s*Math.cos(a))}t.closePath()}function lr(t,e,r,n,o,s){let a=Math.atan2(o-r,n-e);t.beginPath(),t.moveTo(e,r),
t.lineTo(n,o);for(let i of[-1,1])t.moveTo(n,o),t.lineTo(n-s*Math.cos(a+i*.6),o-s*Math.sin(a+i*.6))}var cr=4,Un=1.6,Hn=.95,Fn=5,Bn=.16,Dn=9,Wn=.09,Gn=.2,ur=.75,R=(t,e)=>t.left+e*t.cell,k=(t,e)=>t.top+e*t.cell;function X(t,e,r){return $(e,r)?t.colors.pursuer:t.
colors.evader}function dr({ctx:t,grid:e,colors:r}){let{left:n,top:o,cell:s,rows:a,cols:i}=e,[l,c]=[i*s,a*s];if(t.fillStyle=r.paper,t.fillRect(n,o,l,c),s<Fn)return;
t.fillStyle=r.line;let d=Math.max(1,Math.round(s/60));for(let m=1;m<i;m++)t.fillRect(n+m*s,o,d,c);for(let m=1;m<a;m++)t.fillRect(n,o+m*s,l,d)}function mr({ctx:t,
grid:e,colors:r},n){let{left:o,top:s,cell:a,rows:i,cols:l}=e;t.fillStyle=r.obstacle;for(let d=0;d<i*l;d++){if(!n.obstacles[d])continue;let[m,p]=[Math.floor(d/l),
d%l];t.fillRect(o+p*a,s+m*a,a,a)}let c=Math.min(5,Math.max(2,Math.round(a/18)));t.strokeStyle=r.frame,t.lineWidth=c,t.strokeRect(o-c/2,s-c/2,l*a+c,i*a+c)}function pr({
ctx:t,grid:e,colors:r},n){let{left:o,top:s,cell:a,rows:i,cols:l}=e,c=a<24*n?5:1;t.font=`500 ${Math.round(Math.min(15*n,Math.max(9*n,a*.32)))}px system-ui, sans-\
serif`,t.fillStyle=r.muted,t.textBaseline="alphabetic",t.textAlign="center";let d=5*n+a/40;for(let m=0;m<l;m+=c)t.fillText(String(m),o+(m+.5)*a,s-d);t.textAlign=
"right",t.textBaseline="middle";for(let m=0;m<i;m+=c)t.fillText(String(m),o-d,s+(m+.5)*a)}function hr(t,e,r,n,o){let{ctx:s,grid:a}=t,i=Math.floor(e.fov/2)+.5,[l,
c]=[Math.max(0,n-i),Math.min(a.cols,n+i)],[d,m]=[Math.max(0,o-i),Math.min(a.rows,o+i)],p=[R(a,l),k(a,d),(c-l)*a.cell,(m-d)*a.cell],f=X(t,e,r);s.globalAlpha=.11,
s.fillStyle=f,s.fillRect(...p),s.globalAlpha=.8,s.strokeStyle=f,s.lineWidth=Math.max(1,a.cell/24),s.strokeRect(...p),s.globalAlpha=1}function fr(t,e,r,n,o){let{
ctx:s,grid:a}=t,i=Math.min(Math.ceil(r),e.moments.length-1),l=e.moments[i];s.lineCap="round",s.lineWidth=Math.min(Dn,Math.max(1,a.cell*Bn));for(let c=Math.max(1,
Math.floor(r-n)+1);c<=i;c++){let[d,m]=[e.moments[c-1],e.moments[c]],p=Math.max(0,Math.min(1,(r-c)/n));s.globalAlpha=ur+(Gn-ur)*p;for(let f=0;f<m.alive.length;f++){
let g=c===i&&r<i;if(!d.alive[f]||!(l.alive[f]||g))continue;let h=($(e,f)?-1:1)*Wn,[y,w]=E(d,f),[_,v]=E(m,f);if(y===_&&w===v)continue;let x=g?o[f].x:v+.5,C=g?o[f].
y:_+.5;s.strokeStyle=X(t,e,f),s.beginPath(),s.moveTo(R(a,w+.5+h),k(a,y+.5+h)),s.lineTo(R(a,x+h),k(a,C+h)),s.stroke()}}s.globalAlpha=1}function gr(t,e,r){let n=Math.
min(Math.ceil(r),e.moments.length-1);for(let o=Math.max(1,n-cr+1);o<=n;o++){let[s,a]=[e.moments[o-1],e.moments[o]],i=o>r?Math.max(0,1-2*(o-r)):1-(r-o)/cr,l=Re(e,
s,a);for(let c of ke(s,a))l.includes(c)||zn(t,E(a,c),i);for(let c of l)jn(t,E(a,c),i)}t.ctx.globalAlpha=1}function jn({ctx:t,grid:e,colors:r},[n,o],s){t.globalAlpha=
s,ir(t,R(e,o+.5),k(e,n+.5),Math.max(8,e.cell*Un)),t.fillStyle=r.capture,t.fill(),t.strokeStyle=r.ink,t.lineWidth=Math.max(1,e.cell/36),t.lineJoin="round",t.stroke()}
function zn({ctx:t,grid:e,colors:r},[n,o],s){t.globalAlpha=s,ar(t,R(e,o+.5),k(e,n+.5),Math.max(7,e.cell*Hn)),t.strokeStyle=r.collision,t.lineWidth=Math.max(2,e.
cell*.17),t.lineCap="round",t.stroke()}function br({ctx:t,grid:e,colors:r},n,o){let s=Math.max(1,e.cell*.07);t.strokeStyle=t.fillStyle=r.collision,t.lineWidth=Math.
max(1,e.cell*.05),t.setLineDash([e.cell*.14,e.cell*.1]);for(let[a,i]of n){if(a<0||i<0||a>=e.rows||i>=e.cols)continue;let l=[R(e,i)+s,k(e,a)+s,e.cell-2*s,e.cell-
2*s];t.globalAlpha=.2*o,t.fillRect(...l),t.globalAlpha=o,t.strokeRect(...l)}t.setLineDash([]),t.globalAlpha=1}function yr({ctx:t,grid:e,colors:r},n,o,s,a){t.globalAlpha=
a,U(t,R(e,n),k(e,o),Math.max(8,e.cell*s*1.02)),t.strokeStyle=r.collision,t.lineWidth=Math.max(1.5,e.cell*.085*Math.sqrt(s)),t.stroke(),t.globalAlpha=1}var Vn=.8,Kn=.92,Xn=15,qn=7,ct=9;function vr(t,e,r,n,o,s){n.forEach((a,i)=>{a.alpha>0&&Yn(t,e,r,i,a,o,s)}),t.ctx.globalAlpha=1;for(let a of ue(e,r).values())a.length>
ct&&Jn(t,n[a[ct-1]],a.length-ct+1)}function Yn(t,e,r,n,o,s,a){let{ctx:i,grid:l,colors:c}=t,d=$(e,n),[m,p]=[l.left+o.x*l.cell,l.top+o.y*l.cell],f=Math.max(4,l.cell*
o.size*(d?Kn:Vn)),g=X(t,e,n),h=!d&&!!r.captured[n-e.nPursuers];if(i.globalAlpha=o.alpha,(d?Oe:U)(i,m,p,f),f>qn*a&&(i.strokeStyle=c.paper,i.lineWidth=Math.max(2,
f*.1),i.stroke()),i.fillStyle=h?c.paper:g,i.fill(),h&&(U(i,m,p,f*.82),i.strokeStyle=g,i.lineWidth=f*.18,i.stroke()),!s||f<Xn*a)return;let y=String(d?n:n-e.nPursuers);
i.font=`700 ${Math.round(f*(d?.4:.5)*(y.length>1?.8:1))}px system-ui, sans-serif`,i.textAlign="center",i.textBaseline="middle",i.fillStyle=h?g:c.paper,i.fillText(
y,m,p+f*(d?.17:.03))}function Jn({ctx:t,grid:e,colors:r},n,o){let[s,a]=[e.left+n.x*e.cell,e.top+n.y*e.cell];t.font=`700 ${Math.round(e.cell*.3)}px system-ui, sa\
ns-serif`,t.textAlign="center",t.textBaseline="middle",t.strokeStyle=r.paper,t.lineWidth=e.cell*.1,t.strokeText(`+${o}`,s,a),t.fillStyle=r.ink,t.fillText(`+${o}`,
s,a)}var Zn=.46,Qn=.86,eo=.66,wr=.48,to=.78,ro=.58;function xr(t,e,r,n){let[o,s]=[e.moments[r-1],e.moments[r]];if(!o)return;let{ctx:a,grid:i,colors:l}=t;a.strokeStyle=
l.collision,a.lineWidth=Math.max(1.5,i.cell*.07),a.lineCap="butt",a.globalAlpha=n;for(let c=0;c<s.alive.length;c++)Ce(o,s,c)&&no(t,e,E(o,c),Te(o,s,c));a.globalAlpha=
1}function no({ctx:t,grid:e},r,n,o){let[s,a]=[o[1]-n[1],o[0]-n[0]],i=m=>R(e,n[1]+.5+s*m),l=m=>k(e,n[0]+.5+a*m),c=ot(r,o)?to:ro;t.setLineDash([e.cell*.09,e.cell*
.06]),t.beginPath(),t.moveTo(i(wr),l(wr)),t.lineTo(i(c),l(c)),t.stroke(),t.setLineDash([]);let d=.17*e.cell/Math.hypot(s,a);t.beginPath(),t.moveTo(i(c)-a*d,l(c)+
s*d),t.lineTo(i(c)+a*d,l(c)-s*d),t.stroke()}function _r(t,e,r,n,o,s){let a=nt[s];if(!s||!a)return;let{ctx:i,grid:l,colors:c}=t,d=ot(e,[n[0]+a[0],n[1]+a[1]])?Qn:
eo,m=Zn*o.size,p=[R(l,o.x+a[1]*m),k(l,o.y+a[0]*m),R(l,o.x+a[1]*d),k(l,o.y+a[0]*d)],f=Math.max(1.5,l.cell*.085);i.lineCap=i.lineJoin="round";for(let[g,h]of[[c.paper,
f*2.1],[X(t,e,r),f]])i.strokeStyle=g,i.lineWidth=h,lr(i,...p,l.cell*.2),i.stroke()}var Er={numbers:!0,axes:!1,trail:6,viewers:[],plan:null,selected:null,cursor:null};function Sr(t,e,r,n,o){let{ctx:s,grid:a,colors:i}=t,l=Math.min(Math.ceil(r),e.
moments.length-1),c=e.moments[l],d=r===l,m=Pe(e,r),p=d?1:Math.max(0,1-2*(l-r));s.clearRect(0,0,s.canvas.width,s.canvas.height),dr(t);for(let h of n.viewers)m[h]?.
alpha&&hr(t,e,h,...or(e,h,r));mr(t,e),n.axes&&pr(t,o),fr(t,e,r,n.trail,m),br(t,c.contested??[],p),gr(t,e,r),xr(t,e,l,p),m.forEach(({x:h,y,size:w},_)=>{let v=Jt(
c,_)?.4:0,x=at(c,_)?1:v;x&&yr(t,h,y,w,x*p)});let f=d?c:e.moments[Math.max(0,l-1)];if(vr(t,e,f,m,n.numbers,o),d&&n.plan)for(let[h,y]of m.entries())y.alpha&&_r(t,
e,h,E(c,h),y,n.plan[h]??0);s.lineWidth=Math.max(2,2.5*o),s.strokeStyle=i.focus;let g=n.selected===null?void 0:m[n.selected];g?.alpha&&Mr(t,g.x,g.y,g.size*.96),n.
cursor&&(s.setLineDash([a.cell*.12,a.cell*.08]),Mr(t,n.cursor[1]+.5,n.cursor[0]+.5,.8),s.setLineDash([]))}function Mr({ctx:t,grid:e},r,n,o){let s=o*e.cell;t.beginPath(),
t.roundRect(e.left+r*e.cell-s/2,e.top+n*e.cell-s/2,s,s,s*.1),t.stroke()}function Ar(t,e,r){let n=.24+(r?.62:0);return(e+n)/(t+n)}function Cr(t,e,r,n,o,s){let a=r?30*s:0,i=(d,m)=>Math.max((d-a)/(m+2*.12),d/(m+2*.12+(r?.62:0))),l=Math.
max(1,Math.floor(Math.min(i(n,e),i(o,t)))),c=r?Math.min(.62*l,a):0;return{rows:t,cols:e,cell:l,left:Math.round((n-e*l+c)/2),top:Math.round((o-t*l+c)/2)}}function Tr(t,e,r){
let n=Math.floor((r-t.top)/t.cell),o=Math.floor((e-t.left)/t.cell);return n>=0&&n<t.rows&&o>=0&&o<t.cols?[n,o]:null}var oo={paper:"--board-paper",line:"--board-line",frame:"--board-frame",ink:"--board-ink",muted:"--board-muted",obstacle:"--board-obstacle",pursuer:"--pursuer",
evader:"--evader",capture:"--capture",collision:"--collision",focus:"--focus"};function Ie(t){let e=getComputedStyle(t),r=Object.entries(oo).map(([n,o])=>[n,e.getPropertyValue(
o).trim()]);return Object.fromEntries(r)}var Y=()=>matchMedia("(prefers-reduced-motion: reduce)").matches,q=class{canvas;#e=null;#n=0;#s;#a={rows:1,cols:1,left:0,top:0,cell:1};#r=0;#t;#o;constructor(e,r={}){
this.canvas=e,e.classList.add("board"),e.setAttribute("role","img"),this.#s={...Er,...r},this.#t=new ResizeObserver(()=>this.#u()),this.#t.observe(e),this.#o=new MutationObserver(
()=>this.redraw()),this.#o.observe(document.documentElement,{attributes:!0}),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",this.redraw)}close(){
this.#t.disconnect(),this.#o.disconnect(),matchMedia("(prefers-color-scheme: dark)").removeEventListener("change",this.redraw),cancelAnimationFrame(this.#r)}get look(){
return this.#s}set look(e){this.#s={...this.#s,...e},this.#c(),this.redraw()}get time(){return this.#n}show(e,r){this.#e=e,this.#n=Math.min(Math.max(0,r),e.moments.
length-1),this.#c(),this.redraw()}redraw=()=>{this.#r||(this.#r=requestAnimationFrame(()=>this.drawNow()))};drawNow(){cancelAnimationFrame(this.#r),this.#r=0;let e=this.
canvas.getContext("2d");if(!e||!this.#e)return;let{rows:r,cols:n}=this.#e,o=devicePixelRatio||1;this.#a=Cr(r,n,this.#s.axes,this.canvas.width,this.canvas.height,
o);let s={ctx:e,grid:this.#a,colors:Ie(this.canvas)};Sr(s,this.#e,this.#n,this.#s,o)}cellAt(e,r){let n=this.canvas.getBoundingClientRect(),o=this.canvas.width/n.
width;return Tr(this.#a,(e-n.left)*o,(r-n.top)*o)}agentAt(e,r){let n=this.cellAt(e,r);if(!n||!this.#e)return null;let o=this.#e.moments[Math.round(this.#n)],s=ue(
this.#e,o).get(n[0]*this.#e.cols+n[1])??[],a=Pe(this.#e,Math.round(this.#n)),i=l=>{let[c,d]=this.pointOf(a[l].x,a[l].y);return Math.hypot(c-e,d-r)};return s.length?
s.reduce((l,c)=>i(c)<i(l)?c:l):null}pointOf(e,r){let n=this.canvas.getBoundingClientRect(),o=n.width/this.canvas.width,{left:s,top:a,cell:i}=this.#a;return[n.left+
(s+e*i)*o,n.top+(a+r*i)*o]}#c(){if(!this.#e)return;let{rows:e,cols:r}=this.#e;this.canvas.style.setProperty("--board-aspect",String(Ar(e,r,this.#s.axes)))}#u(){
let e=devicePixelRatio||1,{width:r,height:n}=this.canvas.getBoundingClientRect();this.canvas.width=Math.max(1,Math.round(r*e)),this.canvas.height=Math.max(1,Math.
round(n*e)),this.drawNow()}};var ao={SIMULTANEOUS:0,SWARM_TURNS:1,AGENT_TURNS:2};function io(t,e,r){return{rows:t.rows,cols:t.cols,nPursuers:t.n_pursuers,fov:t.fov,interaction:ao[t.rules.interaction],
obstacles:e,moments:r}}function Le(t){let e=Array.from({length:t.length+1},(r,n)=>lo(t,n));return io(t.config,t.map,e)}function lo(t,e){let r=t.n_agents,n=t.config.n_evaders,o=(a,i,l)=>a.
subarray(i*l,(i+1)*l),s={positions:o(t.last_positions,e,2*r),alive:o(t.alive,e,r),captured:o(t.captured,e,n),everCaptured:o(t.ever_captured,e,n)};return e===0?s:
{...s,actions:o(t.actions,e-1,r),involved:o(t.involved,e-1,3*r),fault:o(t.fault,e-1,3*r),get contested(){return t.conflicts(e).map(a=>a.cell)}}}var co={first:"M6 5v14M19 5 9 12l10 7z",back:"M17 5 7 12l10 7z",play:"M7 4.5 19 12 7 19.5z",pause:"M8 5v14M16 5v14",forward:"M7 5l10 7-10 7z",last:"M18 5v14M5 5\
l10 7-10 7z"};function Rr(t){let e=document.createElementNS("http://www.w3.org/2000/svg","svg");e.setAttribute("viewBox","0 0 24 24"),e.setAttribute("aria-hidde\
n","true"),e.classList.add("icon");let r=document.createElementNS("http://www.w3.org/2000/svg","path");return r.setAttribute("d",co[t]),e.append(r),e}function de(t,e,r,n){
let o=document.createElement("button");return o.type="button",o.className="player-button",o.append(Rr(t)),o.ariaLabel=e,o.title=`${e} (${r})`,o.addEventListener(
"click",n),o}function Ne(t){let e=document.createElement("div");e.className="player",e.role="group",e.ariaLabel="Player";let r=de("play","Play","Space",()=>t.toggle()),
n=uo(t),o=mo(t),s=document.createElement("output");s.className="player-count",e.append(de("first","First step","Home",()=>t.move(-t.length)),de("back","Step bac\
k","←",()=>t.move(-1)),r,de("forward","Step forward","→",()=>t.move(1)),de("last","Last step","End",()=>t.move(t.length)),n,s,o);let a=()=>{r.replaceChildren(
Rr(t.playing?"pause":"play")),r.ariaLabel=t.playing?"Pause":"Play",r.title=`${r.ariaLabel} (Space)`,n.max=String(t.length),n.value=String(t.step),n.ariaValueText=
`step ${t.step} of ${t.length}`,s.textContent=`${t.step} / ${t.length}`,s.style.minWidth=`${2*String(t.length).length+3}ch`,o.value=String(t.speed)};return t.addEventListener(
"step",a),t.addEventListener("state",a),e.addEventListener("keydown",i=>{!(i.target instanceof HTMLSelectElement||i.key===" "&&i.target!==n)&&V(t,i)&&i.preventDefault()}),
a(),e}function uo(t){let e=document.createElement("input");return e.type="range",e.className="player-scrub",e.min="0",e.step="1",e.ariaLabel="Step",e.addEventListener(
"input",()=>{t.pause(),t.jump(Number(e.value))}),e}function mo(t){let e=document.createElement("select");return e.className="player-speed",e.ariaLabel="Speed",e.
title="Steps a second (+ and -)",e.append(...ie.map(r=>new Option(`${r} / s`,String(r)))),e.addEventListener("change",()=>{t.speed=Number(e.value)}),e}var S=(t,e=2)=>t==null?"-":t.toFixed(e),ut=(t,e=1)=>t==null?"-":`${(100*t).toFixed(e)} %`;function $e(t,e,r,n=2){return e===null||r===null?t.toFixed(n):`${t.toFixed(
n)} (${e.toFixed(n)} to ${r.toFixed(n)})`}var kr=t=>t.toLocaleString("en-GB");function me(t,e,r,n=!1){let o=(e-t)/Math.max(1,r),s=10**Math.floor(Math.log10(o||1)),
a=[1,2,5,10].map(c=>c*s).find(c=>c>=o)??10*s;n&&(a=Math.max(1,Math.round(a)));let i=Math.ceil(t/a-1e-9),l=Math.floor(e/a+1e-9);return Array.from({length:Math.max(
0,l-i+1)},(c,d)=>(i+d)*a)}function J(t,e,{pursuer:r,evader:n,episode:o,seed:s}){let a=e.seeds[r][n];return t.match(e.world,ae(e,"pursuer",r),ae(e,"evader",n),BigInt(s??a),o)}var Pr=40,pe=new Map,he=({run:t,pursuer:e,evader:r},n)=>`${t} ${e} ${r} ${n}`,Ue=class{element;#e;#n;#s=u("div",{class:"episodes",role:"group","aria-label":"Epi\
sodes of this cell"});#a=u("p",{class:"check small numbers","aria-live":"polite"});#r=0;constructor(e,r){[this.#e,this.#n]=[e,r],this.element=u("div",{class:"st\
rip-of-episodes"},this.#s,this.#a)}show(e,r,n){let{selected:o}=this.#e;o.seed===null&&pe.set(he(o,o.episode),Or(n)),this.#o(r),ho(this.#r),this.#t(e,r)}#t(e,r){
let{selected:n}=this.#e,s=oe(r,n.pursuer,n.evader)?.rates.findIndex((a,i)=>!pe.has(he(n,i)))??-1;s<0||s>=Pr||(this.#r=po(()=>{this.#n.playing||(pe.set(he(n,s),Or(
J(e,r,{...n,episode:s,seed:null}))),this.#o(r)),this.#t(e,r)}))}#o(e){let{selected:r}=this.#e,n=oe(e,r.pursuer,r.evader);if(!n){this.#s.replaceChildren(),this.#a.
textContent="The evaluation played no episodes of this pair.";return}let o=Math.min(Pr,n.rates.length);this.#s.replaceChildren(...n.rates.slice(0,o).map((c,d)=>this.#c(
c,d)));let s=n.rates.slice(0,o).map((c,d)=>pe.get(he(r,d))),a=s.filter(c=>c!==void 0),i=s.flatMap((c,d)=>c&&(Math.abs(c.rate-n.rates[d])>1e-6||c.length!==n.lengths[d])?
[d+1]:[]),l=a.reduce((c,d)=>c+d.rate,0)/a.length;this.#a.dataset.equal=String(!i.length&&a.length===n.rates.length),this.#a.textContent=i.length?`Episode ${i.join(
", ")} differs from the evaluation.`:a.length<n.rates.length?`Played here: ${a.length} of ${n.rates.length} episodes, all as in the evaluation.`:`Played here: a\
ll ${a.length} episodes, mean capture rate ${S(l,3)}. The cell says ${S(n.rate,3)}.`}#c(e,r){let{selected:n}=this.#e,o=u("span",{class:"bar"});return o.style.height=
`${Math.round(100*e)}%`,u("button",{type:"button",class:"episode",title:`Episode ${r+1}: capture rate ${S(e)}`,"aria-label":`Episode ${r+1}, capture rate ${S(e)}`,
"aria-pressed":String(r===n.episode&&n.seed===null),"data-played":pe.has(he(n,r)),onclick:()=>this.#e.select({episode:r,seed:null})},o,u("span",{class:"count"},
r+1))}},Or=t=>({rate:t.statistics.capture_rate,length:t.length}),po=t=>"requestIdleCallback"in window?requestIdleCallback(t,{timeout:1e3}):setTimeout(t,100),ho=t=>"\
cancelIdleCallback"in window?cancelIdleCallback(t):clearTimeout(t);var fe=(t,e)=>t<e?`pursuer_${t}`:`evader_${t-e}`,dt=["stay","north","east","south","west","northeast","southeast","southwest","northwest"];var Ir=0,Lr=1,fo=2,go=176;function $r(t,e,r,n){let o=devicePixelRatio||1,s=Ie(t);t.width=t.height=go*o;let a=t.getContext("2d");if(!a)return;let{fov:i}=e,l=t.width/
i;a.fillStyle=s.paper,a.fillRect(0,0,t.width,t.height);for(let d=0;r&&d<i*i;d++){let[m,p]=[(d%i+.5)*l,(Math.floor(d/i)+.5)*l],f=h=>!!r[h*i*i+d];f(fo)&&(a.fillStyle=
s.obstacle,a.fillRect(m-l/2,p-l/2,l,l));let g=f(Ir)&&f(Lr)?l*.18:0;f(Ir)&&Nr(a,U,m+g,p+g,l*.74,s.evader),f(Lr)&&Nr(a,Oe,m-g,p-g,l*.86,s.pursuer)}a.strokeStyle=n<
e.n_pursuers?s.pursuer:s.evader,a.lineWidth=2*o;let c=Math.floor(i/2)*l;a.strokeRect(c,c,l,l)}function Nr(t,e,r,n,o,s){e(t,r,n,o),t.fillStyle=s,t.fill()}var He=class{element;#e;#n=u("canvas",{class:"seen",role:"img"});#s=u("h3");#a=u("p",{class:"small muted"});#r=u("div",{class:"answers"});#t=null;#o=null;#c=null;#u=null;#i=null;#d=0;constructor(e){
this.#e=e,this.element=u("div",{class:"inspector","data-open":"false"},u("p",{class:"hint small muted"},"Click an agent, or press A: what it sees, and what its \
network answers."),u("div",{class:"inspected"},this.#n,u("div",{class:"answer"},this.#s,this.#a),this.#r))}get agent(){return this.#i}show(e,r,n,o){(this.#o!==r||
!this.#t)&&(this.#t?.free(),this.#t=e.world(r.world),this.#i!==null&&this.#o!==r&&this.choose(null)),[this.#o,this.#c,this.#u]=[r,n,o]}choose(e){this.#i=e,this.
element.dataset.open=String(e!==null),this.#e(e),this.at(this.#d)}next(e){let r=this.#c;if(!r)return;let n=this.#i??(e>0?-1:0);for(let o=0;o<r.n_agents;o++)if(n=
(n+e+r.n_agents)%r.n_agents,r.alive[this.#d*r.n_agents+n])return this.choose(n)}at(e){this.#d=e;let[r,n,o,s,a]=[this.#c,this.#t,this.#o,this.#u,this.#i];if(!r||
!n||!o||!s||a===null)return;let i=a<r.config.n_pursuers?"pursuer":"evader";this.#s.replaceChildren(u("span",{class:i},fe(a,r.config.n_pursuers)));let l=!!r.alive[e*
r.n_agents+a];r.seek(n,e),$r(this.#n,r.config,l?n.view(a):null,a),this.#n.ariaLabel=`Field of view of ${fe(a,r.config.n_pursuers)}: evaders, pursuers and obstac\
les around it`;let c=e<r.length?r.actions[e*r.n_agents+a]:null;if(!l)return this.#l([],"It is gone.");let d=ae(o,i,s[i]);if(typeof d=="string")return this.#l([],
`The script "${d}" plays for it${c===null?"":`; it goes ${dt[c]}`}.`);let{probabilities:m}=n.answer(d,a),p=Array.from(m,(g,h)=>bo(dt[h],g,h===c)),f=d.sampled?"I\
ts action is drawn from these probabilities.":"It takes the most probable action.";this.#l(p,c===null?"The episode is over.":f)}#l(e,r){this.#r.replaceChildren(
...e),this.#a.textContent=r}};function bo(t,e,r){let n=u("span",{class:"filled"});return n.style.width=`${100*e}%`,u("div",{class:r?"action taken":"action"},u("\
span",{},t),u("span",{class:"track"},n),u("span",{class:"numbers"},e.toFixed(2)))}function Ur(t,e,r){if(r===0)return[{kind:"start",text:yo(t),agents:[]}];let[n,o]=[e.moments[r-1],e.moments[r]],s=d=>fe(d,t.config.n_pursuers),a=Re(e,n,o),i=t.conflicts(
r),l=new Set(i.flatMap(d=>d.doomed)),c=a.map(d=>({kind:"capture",text:`${s(d)} is captured`,agents:[d]}));for(let d of ke(n,o))!a.includes(d)&&!l.has(d)&&c.push(
{kind:"end",text:`${s(d)} disappears`,agents:[d]});return c.push(...i.map(({kind:d,text:m,agents:p})=>({kind:d,text:m,agents:p}))),r===t.length&&c.unshift({kind:"\
end",text:vo(t),agents:[]}),c}function yo({config:t}){return`${t.n_pursuers} pursuers and ${t.n_evaders} evaders on ${t.rows} x ${t.cols} cells, at most ${t.max_steps}\
 steps`}function vo(t){let e=Math.round(t.statistics.capture_rate*t.config.n_evaders);return`The episode ends after ${t.length} steps with ${e} of ${t.config.n_evaders}\
 evaders captured`}var wo=60,Fe=class{element;player=new z(0,{speed:8,still:Y()});inspector;#e;#n;#s;#a;#r=u("h2",{class:"match-title"});#t=u("p",{class:"tally numbers"});#o=u("ol",
{class:"words","aria-live":"off","aria-label":"What happened in this step"});#c=u("p",{class:"problem",role:"alert"});#u=null;#i=null;#d=null;#l=0;#p=!1;constructor(e,r){
[this.#n,this.#s]=[e,r];let n=u("canvas",{"aria-label":"The match"});this.#e=new q(n,{numbers:!1}),this.#a=new Ue(r,this.player),this.inspector=new He(o=>this.#x(
o)),n.addEventListener("click",o=>this.inspector.choose(this.#e.agentAt(o.clientX,o.clientY))),this.element=u("section",{class:"card match-card","aria-label":"M\
atch",id:"match"},u("div",{class:"match"},u("header",{class:"match-head"},this.#r,this.#t),this.#c,u("div",{class:"stage"},n),u("div",{class:"aside"},this.#o,this.
inspector.element),Ne(this.player),this.#a.element)),this.player.addEventListener("frame",()=>this.#d&&this.#e.show(this.#d,this.player.time)),this.player.addEventListener(
"step",()=>this.#b()),r.on("match",()=>this.#h()),this.#g(),this.#v(0,0)}get#m(){return this.#n[this.#s.selected.run]}get match(){return this.#i}start(e){this.#u=
e,this.#f()}playSoon(){this.#p=!0,this.#l||this.#y()}#y(){!this.#p||!this.#i||(this.#p=!1,this.player.jump(0),Y()||this.player.play())}#h(){this.#g(),clearTimeout(
this.#l),this.#l=setTimeout(()=>this.#f(),wo)}#f(){clearTimeout(this.#l),this.#l=0,this.player.pause(),this.#g();let{selected:e}=this.#s,r=["pursuer","evader"].
find(n=>!se(this.#m,n,e[n]));this.#c.textContent=r?`The page holds no genome of ${r}s ${e[r]}: it would be too large. Choose a generation of ${this.#m.teams[r].
kept.join(", ")}.`:"",!(r||!this.#u)&&(this.#i=J(this.#u,this.#m,e),this.#d=Le(this.#i),this.#a.show(this.#u,this.#m,this.#i),this.inspector.show(this.#u,this.#m,
this.#i,e),this.player.length=this.#i.length,this.player.jump(0),this.#b(),this.element.dataset.played=`${e.run} ${e.pursuer} ${e.evader} ${e.episode} ${e.seed??
""}`,this.#y())}#g(){let{pursuer:e,evader:r,episode:n,seed:o}=this.#s.selected,{teams:s,payoff:a}=this.#m,i=(c,d)=>s[c].script??`${c}s ${d}`,l=o===null?n<a.episodes?
`episode ${n+1} of ${a.episodes}`:`episode ${n+1}, not part of the cell`:`seed ${o}`;this.#r.replaceChildren(u("span",{class:"pursuer"},i("pursuer",e))," agains\
t ",u("span",{class:"evader"},i("evader",r)),u("span",{class:"muted small"},l))}#b(){let e=this.#i;if(!e||!this.#d)return;let r=this.player.step,n=this.#d.moments[r];
this.#v(Array.from(n.everCaptured).filter(Boolean).length,r),this.#o.replaceChildren(...Ur(e,this.#d,r).map(o=>u("li",{class:o.kind,"data-agents":o.agents.join(
" ")},o.text))),this.inspector.at(r),this.#w()}#v(e,r){this.#t.replaceChildren(u("strong",{},e),` of ${this.#m.world.n_evaders} captured`,u("span",{class:"muted"},
` · step ${r}`))}#x(e){this.#e.look={selected:e,viewers:e===null?[]:[e]},this.#w()}#w(){let e=this.inspector.agent;for(let r of this.#o.children){let n=r.dataset.
agents?.split(" ")??[];r.classList.toggle("about",e!==null&&n.includes(String(e)))}}};var T={left:52,bottom:46,top:76,right:84},P=10,xo=160,ge=T.right-P-14,H=T.top-P-14,Be=class{element;#e;#n;#s=u("canvas",{"aria-hidden":"true"});#a=b("svg",{"ari\
a-hidden":"true"});#r=b("g");#t;#o=u("h2");#c=u("strong",{class:"rate numbers"});#u=u("span",{class:"small muted"});#i=u("p",{class:"small muted numbers"});#d=null;constructor(e,r){
[this.#n,this.#e]=[e,r],this.#t=u("div",{class:"matrix",id:"matrix",tabindex:0,role:"application","aria-label":"Payoff matrix. Arrow keys choose a match, Enter \
plays it."},this.#s,this.#a);let n=u("header",{class:"readout","aria-live":"polite"},u("div",{},this.#o,this.#i),u("div",{class:"of-cell"},this.#c,this.#u));this.
element=u("section",{class:"card matrix-card","aria-label":"Payoff matrix"},n,this.#t,_o()),this.#f(),new ResizeObserver(()=>this.#p()).observe(this.#t),this.#t.
addEventListener("pointermove",o=>this.#v(o)),this.#t.addEventListener("pointerleave",()=>r.point({})),this.#t.addEventListener("click",o=>this.#x(o)),this.#t.addEventListener(
"mousedown",o=>o.preventDefault()),this.#t.addEventListener("keydown",o=>this.#w(o)),r.on("run",()=>this.#p()),r.on("match",()=>this.#h()),r.on("hover",()=>this.#h())}get#l(){
return this.#n[this.#e.selected.run]}#p(){let[e,r]=this.#l.payoff.shape,{clientWidth:n,clientHeight:o}=this.#t;if(n<50)return;let a=Math.max(xo,Math.min(n-T.left-
T.right,o-T.top-T.bottom))/Math.max(e,r),i=Math.max(T.left,(n-r*a-T.right+T.left)/2),l=T.top+Math.max(0,(o-T.top-T.bottom-e*a)/2),c={width:n,height:o,left:i,top:l,
cell:a,rows:e,columns:r};this.#d=c,Ae(this.#s,this.#l.payoff,{left:i,top:l,width:r*a,height:e*a}),this.#a.setAttribute("viewBox",`0 0 ${n} ${o}`),this.#a.replaceChildren(
Mo(c),Eo(c),...this.#y(c),this.#r),this.#h()}#m(e){let r=this.#l.findings?.generalization;if(!r)return[];let{selected:n,hover:o}=this.#e,[s,a]=[o.pursuer??n.pursuer,
o.evader??n.evader],[i,l]=Fr(e,r.pursuers.mean[s]??0,s),[c,d]=Br(e,r.evaders.mean[a]??0,a);return[b("circle",{class:"dot of-pursuers",cx:i,cy:l,r:5}),b("circle",
{class:"dot of-evaders",cx:c,cy:d,r:5})]}#y(e){let r=this.#l.findings?.generalization;if(!r)return[];let{left:n,top:o,cell:s,rows:a,columns:i}=e,[l,c]=[n+i*s+P,
o-P],d={class:"side"};return[b("rect",{...d,x:l,y:o,width:ge,height:a*s}),b("rect",{...d,x:n,y:c-H,width:i*s,height:H}),...Dr(r.pursuers,(m,p)=>Fr(e,m,p),"of-pu\
rsuers"),...Dr(r.evaders,(m,p)=>Br(e,m,p),"of-evaders"),b("text",{class:"tick",x:l,y:o+a*s+16,"text-anchor":"start"},"0"),b("text",{class:"tick",x:l+ge,y:o+a*s+
16,"text-anchor":"end"},"1"),b("text",{class:"tick",x:n-6,y:c-4,"text-anchor":"end"},"0"),b("text",{class:"tick",x:n-6,y:c-H+8,"text-anchor":"end"},"1"),b("text",
{class:"label of-pursuers",x:l+ge,y:o+a*s+34,"text-anchor":"end"},"captures"),b("text",{class:"label of-evaders",x:n+i*s+P,y:c-H+10,"text-anchor":"start"},"esca\
pes")]}#h(){let e=this.#d;if(!e)return;let{selected:r,hover:n}=this.#e,{left:o,top:s,cell:a,rows:i,columns:l}=e,c=g=>s+(i-1-g)*a,d=[],m=(g,h)=>b("rect",{class:h,
x:o,y:c(g),width:l*a+P+ge,height:a}),p=(g,h)=>b("rect",{class:h,x:o+g*a,y:s-P-H,width:a,height:P+H+i*a});if(d.push(m(r.pursuer,"strip pursuer"),p(r.evader,"stri\
p evader")),n.pursuer!==null&&n.pursuer<i&&d.push(m(n.pursuer,"strip hover")),n.evader!==null&&n.evader<l&&d.push(p(n.evader,"strip hover")),n.lag!==null)for(let g=0;g<
l;g++){let h=g+n.lag;h>=0&&h<i&&d.push(b("rect",{class:"lagged",x:o+g*a,y:c(h),width:a,height:a}))}d.push(...this.#m(e));let f={x:o+r.evader*a,y:c(r.pursuer),width:a,
height:a};d.push(b("rect",{class:"chosen under",...f}),b("rect",{class:"chosen",...f})),this.#r.replaceChildren(...d),this.#f()}#f(){let{selected:e,hover:r}=this.#e,
n=r.pursuer??e.pursuer,o=r.evader??e.evader,s=oe(this.#l,n,o);this.#o.replaceChildren(u("span",{class:"pursuer"},`Pursuers ${n}`)," against ",u("span",{class:"e\
vader"},`evaders ${o}`)),this.#c.textContent=s?S(s.rate,3):"-",this.#u.textContent=s?`capture rate, mean of ${s.rates.length} episodes`:"the evaluation played n\
o episodes",this.#i.textContent=this.#g(n,o)}#g(e,r){let n=this.#l.findings?.generalization;if(!n)return"";let o=(s,a)=>$e(s.mean[a]??0,s.low?.[a]??null,s.high?.[a]??
null);return`Against all: captures ${o(n.pursuers,e)}, escapes ${o(n.evaders,r)}`}#b(e){let r=this.#d;if(!r)return null;let n=this.#t.getBoundingClientRect(),o=Math.
floor((e.clientX-n.left-r.left)/r.cell),s=r.rows-1-Math.floor((e.clientY-n.top-r.top)/r.cell),[a,i]=[s>=0&&s<r.rows,o>=0&&o<r.columns];return a||i?{g:a?s:-1,h:i?
o:-1,inside:a&&i}:null}#v(e){let r=this.#b(e);this.#e.point(r?{pursuer:r.g<0?null:r.g,evader:r.h<0?null:r.h}:{})}#x(e){let r=this.#b(e);r&&(this.#e.select({...r.
g<0?{}:{pursuer:r.g},...r.h<0?{}:{evader:r.h}}),r.inside&&this.#t.dispatchEvent(new CustomEvent("play",{bubbles:!0})))}#w(e){let n={ArrowUp:[1,0],ArrowDown:[-1,
0],ArrowRight:[0,1],ArrowLeft:[0,-1]}[e.key];if(e.key==="Enter")this.#t.dispatchEvent(new CustomEvent("play",{bubbles:!0}));else if(n){let o=e.shiftKey?5:1,[s,a]=this.#l.
payoff.shape,{pursuer:i,evader:l}=this.#e.selected;this.#e.select({pursuer:Hr(i+o*n[0],s),evader:Hr(l+o*n[1],a)})}else return;e.preventDefault(),e.stopPropagation()}};
function _o(){let t=u("span",{class:"gradient"});return t.style.backgroundImage=Kt(),u("p",{class:"scale-of-rates small muted"},"0 all escape",t,"1 all caught")}
var Hr=(t,e)=>Math.min(e-1,Math.max(0,t));function Mo({left:t,top:e,cell:r,rows:n,columns:o}){let s=b("g",{class:"axes"}),a=e+n*r,i=l=>me(0,l-1,Math.min(l,l*r/44),
!0);for(let l of i(o))s.append(b("text",{class:"tick",x:t+(l+.5)*r,y:a+16,"text-anchor":"middle"},l));for(let l of i(n))s.append(b("text",{class:"tick",x:t-7,y:a-
(l+.5)*r,"text-anchor":"end","dominant-baseline":"middle"},l));return s.append(b("text",{class:"label of-evaders",x:t+o*r/2,y:a+36,"text-anchor":"middle"},"evad\
er generation"),b("text",{class:"label of-pursuers",transform:`translate(${t-36} ${e+n*r/2}) rotate(-90)`,"text-anchor":"middle"},"pursuer generation")),s}function Eo({
left:t,top:e,cell:r,rows:n,columns:o}){let s=b("g",{class:"diagonal"}),a=Math.min(n,o);if(a<3)return s;let i=e+n*r;for(let l of["H","V"]){let c=`M${t} ${i}`;for(let d=1;d<=
a;d++){let[m,p]=[`H${t+d*r}`,`V${i-d*r}`];c+=l==="H"?m+p:p+m}s.append(b("path",{d:c,class:"under"}),b("path",{d:c}))}return s}var Fr=({left:t,top:e,cell:r,rows:n,
columns:o},s,a)=>[t+o*r+P+s*ge,e+(n-a-.5)*r],Br=({left:t,top:e,cell:r},n,o)=>[t+(o+.5)*r,e-P-n*H];function Dr(t,e,r){let n=s=>s.map((a,i)=>e(a??0,i).map(l=>l.toFixed(
1)).join(" ")),o=[];return t.low&&t.high&&o.push(b("path",{class:`band ${r}`,d:`M${[...n(t.high),...n(t.low).reverse()].join("L")}Z`})),o.push(b("path",{class:`\
line ${r}`,d:`M${n(t.mean).join("L")}`})),o}function Wr(t,e,r){let{findings:n}=t;if(!n)return null;let o=u("dialog",{class:"four","aria-label":"Four matches"}),s=i=>{let l=r();l&&Ao(o,t,i,e,l)},a=n.checkerboards.
map(i=>So(t,i,s));return{element:A("Checkerboards","Two generations of each team: each pursuers are better against one of the evaders. Click one: its four match\
es side by side.",a.length?u("div",{class:"boards"},...a):u("p",{},`No four cells differ by more than ${n.margin} in this way.`),a.length?u("p",{class:"small mu\
ted"},"The strongest of all pairs, so noise makes them look stronger than they are. The diagnosis says whether there are more than noise makes."):null,o)}}var Gr=({
pursuers:[t,e],evaders:[r,n]})=>[[t,r],[t,n],[e,r],[e,n]];function So(t,e,r){let[n,o]=e.pursuers,[s,a]=e.evaders,i=Gr(e).map(([l,c])=>{let d=t.payoff.capture_rate[l][c],
m=u("span",{class:d>.55?"cell light":"cell"},S(d));return m.style.backgroundColor=Vt(d),m});return u("button",{type:"button",class:"miniature numbers",onclick:()=>r(
e),"aria-label":`Pursuers ${n} and ${o}, evaders ${s} and ${a}: four matches`},u("span",{}),u("span",{class:"evader"},s),u("span",{class:"evader"},a),u("span",{
class:"pursuer"},n),i[0],i[1],u("span",{class:"pursuer"},o),i[2],i[3])}function Ao(t,e,r,n,o){let s=Gr(r).filter(([p,f])=>se(e,"pursuer",p)&&se(e,"evader",f)),a=s.
map(([p,f])=>J(o,e,{run:n.selected.run,pursuer:p,evader:f,episode:0,seed:null})),i=new z(Math.max(0,...a.map(p=>p.length)),{speed:16,still:Y()}),l=a.map((p,f)=>{
let[g,h]=s[f],y=u("canvas",{"aria-label":`Pursuers ${g} against evaders ${h}`}),w=u("span",{class:"numbers"}),_=()=>{t.close(),n.select({pursuer:g,evader:h})};return{
element:u("figure",{},u("figcaption",{},u("span",{},u("span",{class:"pursuer"},g)," against ",u("span",{class:"evader"},h),u("span",{class:"muted small"},` cell\
 ${S(e.payoff.capture_rate[g][h])}`)),w,u("button",{type:"button",class:"small",title:"Show this match alone",onclick:_},"open")),y),match:p,recording:Le(p),board:new q(
y,{numbers:!1}),tally:w}}),c=()=>l.forEach(p=>p.board.show(p.recording,i.time)),d=()=>l.forEach(({recording:p,match:f,tally:g})=>{let h=p.moments[Math.min(i.step,
f.length)];g.textContent=`${Array.from(h.everCaptured).filter(Boolean).length} of ${f.config.n_evaders}`});i.addEventListener("frame",c),i.addEventListener("ste\
p",d),t.replaceChildren(u("header",{},u("h2",{},"Four matches of a checkerboard"),u("button",{type:"button",onclick:()=>t.close()},"Close")),u("div",{class:"gri\
d-of-four"},...l.map(p=>p.element)),Ne(i));let m=p=>{!(p.target instanceof HTMLSelectElement||p.target instanceof HTMLButtonElement&&p.key===" ")&&!p.defaultPrevented&&
V(i,p)&&p.preventDefault()};t.addEventListener("keydown",m),t.addEventListener("close",()=>{t.removeEventListener("keydown",m),i.pause(),l.forEach(p=>p.board.close()),
t.replaceChildren()},{once:!0}),t.showModal(),c(),d(),Y()||i.play()}var De={pursuer:"evader",evader:"pursuer"};function jr(t,e){let r=t.findings?.ciao;if(!r)return null;let n=["pursuer","evader"].map(o=>{let{fading:s,stripes:a,period:i}=r[`${o}\
s`],l=`fading ${S(s)}, stripes ${S(a)}${i===null?"":` every ${i} generations`}`;return Co(t,o,l,e)});return{element:A("CIAO","Current individuals against ancest\
ral opponents, by the team's own score. Stripes that come back: cycling. Darker away from the diagonal: forgetting.",u("div",{class:"triangles"},...n.map(o=>o.element))),
update:()=>n.forEach(o=>o.update())}}function Co(t,e,r,n){let o=e==="pursuer"?0:1,[s,a]=[t.payoff.shape[o],t.payoff.shape[1-o]],i=(v,x)=>e==="pursuer"?t.payoff.
capture_rate[v][x]:1-t.payoff.capture_rate[x][v],l=u("canvas",{width:a,height:s,role:"img","aria-label":`CIAO of the ${e}s: ${r}`}),c=l.getContext("2d"),d=c?.createImageData(
a,s);for(let v=0;d&&v<s;v++)for(let x=0;x<=Math.min(v,a-1);x++)d.data.set([...ce(i(v,x)),255],4*((s-1-v)*a+x));d&&c?.putImageData(d,0,0);let m=b("rect",{class:"\
chosen",width:1,height:1}),p=b("rect",{class:"chosen under",width:1,height:1}),f=b("svg",{viewBox:`0 0 ${a} ${s}`,preserveAspectRatio:"none","aria-hidden":"true"},
p,m),g=u("div",{class:"triangle"},l,f);g.style.aspectRatio=`${a} / ${s}`;let h=v=>{let x=g.getBoundingClientRect(),C=Math.floor((v.clientX-x.left)/x.width*a),I=s-
1-Math.floor((v.clientY-x.top)/x.height*s);return C>=0&&I<s&&C<=I?[I,C]:null},y=v=>({[e]:v[0],[De[e]]:v[1]});g.addEventListener("pointermove",v=>n.point(h(v)?y(
h(v)):{})),g.addEventListener("pointerleave",()=>n.point({})),g.addEventListener("click",v=>h(v)&&n.select(y(h(v))));let w=()=>{let v=n.hover[e]??n.selected[e],
x=n.hover[De[e]]??n.selected[De[e]];for(let C of[m,p])C.setAttribute("x",String(x)),C.setAttribute("y",String(s-1-v)),C.style.display=x<=v?"":"none"};return{element:u(
"figure",{},u("figcaption",{class:"small"},u("span",{class:e},`${e}s`)),g,u("p",{class:"small muted"},`horizontal: ${De[e]} generation; vertical: ${e} generatio\
n`),u("p",{class:"small numbers"},r)),update:w}}var We={left:46,right:12,top:10,bottom:42},zr={x:56,y:34};function Ge(t,e,r,n){let[o,s]=[We.left,We.top],a=Math.max(o+40,t-We.right),i=Math.max(s+40,e-We.bottom),
l=(h,y,w)=>_=>y+(_-h.low)/(h.high-h.low||1)*(w-y),[c,d]=[l(r,o,a),l(n,i,s)],m=b("g"),p=b("svg",{width:t,height:e,viewBox:`0 0 ${t} ${e}`,class:"plot"}),f=b("g",
{class:"axes"});for(let h of me(n.low,n.high,(i-s)/zr.y,n.whole))f.append(b("line",{x1:o,x2:a,y1:d(h),y2:d(h),class:"grid"}),b("text",{x:o-8,y:d(h),"text-anchor":"\
end","dominant-baseline":"middle"},Vr(h)));for(let h of me(r.low,r.high,(a-o)/zr.x,r.whole))f.append(b("text",{x:c(h),y:i+16,"text-anchor":"middle"},Vr(h)));return f.
append(b("line",{x1:o,x2:a,y1:i,y2:i,class:"axis"}),b("text",{x:(o+a)/2,y:e-6,"text-anchor":"middle",class:"label"},r.label),b("text",{transform:`translate(12 ${(s+
i)/2}) rotate(-90)`,"text-anchor":"middle",class:"label"},n.label)),p.append(f,m),{root:p,marks:m,left:o,right:a,top:s,bottom:i,x:c,y:d,at:h=>{let y=h-p.getBoundingClientRect().
left;return r.low+(y-o)/(a-o)*(r.high-r.low)}}}var Vr=t=>String(Number(t.toPrecision(6))).replace("-","−");function be(t,e,r,n){let o="",s="M";r.forEach((i,l)=>{
i===null?s="M":(o+=`${s}${t.x(e[l]).toFixed(1)} ${t.y(i).toFixed(1)}`,s="L")});let a=b("path",{d:o,class:`line ${n}`});return t.root.insertBefore(a,t.marks),a}function ye(t,e,r,n=null){let o=t.x(e);t.marks.append(b("line",{x1:o,x2:o,y1:t.top,y2:t.bottom,class:`mark ${r}`})),n!==null&&t.marks.append(b("circle",{cx:o,cy:t.
y(n),r:5,class:`dot ${r}`}))}function mt(...t){return u("p",{class:"legend small"},...t.map(([e,r])=>u("span",{class:`key ${r}`},e)))}function je(t,e,r={}){let n=u(
"div",{class:"chart",role:"img","aria-label":t}),o=null,s=()=>{o?.marks.replaceChildren(),o&&r.marks?.(o)},a=()=>{let{clientWidth:i,clientHeight:l}=n;i<50||l<50||
(o=e(i,l),n.replaceChildren(o.root),s())};return n.addEventListener("pointermove",i=>r.point?.(o?.at(i.clientX)??null)),n.addEventListener("pointerleave",()=>r.
point?.(null)),r.choose&&(n.classList.add("chooses"),n.addEventListener("click",i=>o&&r.choose?.(o.at(i.clientX),o,i))),new ResizeObserver(a).observe(n),{element:n,
redraw:a,remark:s}}var pt=["of-pursuers","of-evaders","of-both"],To=2500,Kr={low:0,high:1,label:"capture rate"};function Xr(t,e){let{training:r}=t,{capture_rate:n,generation:o,learner:s,
epochs:a}=r,i=n.map((g,h)=>(h+1)*a),l=Ro(n,r.window),c=i.at(-1)??1,d=i.length>To?"dense":"",m=(g,h)=>{let y=o.flatMap((w,_)=>w===g&&(s[_]===h||s[_]===2)?[_]:[]);
return y.length?[i[y[0]],i[y.at(-1)]]:null},p=je(`Capture rate in ${c} epochs of training`,(g,h)=>{let y=Ge(g,h,{low:0,high:c,label:"epoch",whole:!0},Kr);for(let[
w,_]of[["raw",n],[d,l]])for(let[v,x]of pt.entries()){let C=_.map((I,ft)=>s[ft]===v||s[ft+1]===v?I:null);C.some(I=>I!==null)&&be(y,i,C,`${x} ${w}`)}return y},{marks:g=>{
let{pursuer:h,evader:y}=e.selected;for(let[w,_]of[[0,h],[1,y]]){let v=m(e.hover[w?"evader":"pursuer"]??_,w);v&&ye(g,(v[0]+v[1])/2,pt[w])}},choose:g=>{let h=Math.
min(i.length-1,Math.max(0,Math.round(g/a)-1)),y=o[h];s[h]!==1&&e.select({pursuer:Math.min(y,t.payoff.shape[0]-1)}),s[h]!==0&&e.select({evader:Math.min(y,t.payoff.
shape[1]-1)})}}),f=[...new Set(s)].sort().map(g=>[["pursuers learn","evaders learn","both teams learn"][g],pt[g]]);return{element:A("Training",`${kr(r.matches)}\
 training matches. Lines: the generations that are selected.`,mt(...f),p.element),update:p.remark}}function qr(t,e){let r=t.findings?.lags;if(!r)return null;let[
n,o]=[r.lags[0],r.lags.at(-1)],s=Math.min(5,(Math.max(...r.cells)+1)/2),a=r.means.map((l,c)=>r.cells[c]>=s?l:null),i=je("Lag profile",(l,c)=>{let d=Ge(l,c,{low:n,
high:o,label:"lag: pursuer minus evader generation",whole:!0},Kr);return be(d,r.lags,r.means,"raw ink"),be(d,r.lags,a,"ink"),d},{marks:l=>{let{pursuer:c,evader:d}=e.
selected;ye(l,0,"zero");let m=e.hover.lag??c-d;ye(l,m,"ink",r.means[m-n])},point:l=>{let c=l===null?null:Math.round(l);e.point({lag:c!==null&&c>=n&&c<=o?c:null})}});
return{element:A("Lag profile","Left: evaders are later. Right: pursuers are later. It rises if both teams keep what they learn. Faint: fewer than 5 cells.",i.element),
update:i.remark}}function Yr(t,e){let r=t.findings?.ratings;if(!r)return null;let n={pursuer:r.pursuers,evader:r.evaders},o=[...r.pursuers,...r.evaders].map(d=>d??
0),[s,a]=[Math.min(...o),Math.max(...o)],i=.06*(a-s||1),l=Math.max(...t.payoff.shape)-1,c=je("Elo ratings by generation",(d,m)=>{let p=Ge(d,m,{low:0,high:l,label:"\
generation",whole:!0},{low:s-i,high:a+i,label:"Elo points"});for(let f of["pursuer","evader"])be(p,n[f].map((g,h)=>h),n[f],`of-${f}s`);return p},{marks:d=>{for(let m of[
"pursuer","evader"]){let p=e.hover[m]??e.selected[m];ye(d,p,`of-${m}s`,n[m][p]??null)}},choose:(d,m,p)=>{let f=Math.round(d),g=p.clientY-m.root.getBoundingClientRect().
top,h=w=>Math.abs(m.y(n[w][f]??1/0)-g),y=h("pursuer")<=h("evader")?"pursuer":"evader";f>=0&&f<n[y].length&&e.select({[y]:f})}});return{element:A("Ratings",`One \
number for each generation, which cycles do not fit. The game itself: ${S(r.offset,0)} points for the pursuers.`,mt(["pursuers","of-pursuers"],["evaders","of-ev\
aders"]),c.element),update:c.remark}}function Ro(t,e){let r=[0];for(let n of t)r.push(r.at(-1)+n);return t.map((n,o)=>{let[s,a]=[Math.max(0,o-Math.floor((e-1)/2)),
Math.min(t.length,o+Math.floor(e/2)+1)];return(r[a]-r[s])/(a-s)})}var ko={present:"●",absent:"○","cannot tell":"?"};function Jr(t){let{findings:e}=t;if(!e)return null;let[,...r]=e.table,n=new Map(e.reasons.map(a=>{let[i,,l]=Po(
a);return[i,l]})),o=r.map(([a,i,l,c])=>{let d=c===e.window?n.get(a):void 0;return u("li",{class:`finding ${i.replace(" ","-")}`},u("span",{class:"sign","aria-hi\
dden":"true"},ko[i]??""),u("div",{},u("p",{},u("strong",{},a),` ${i}`,u("span",{class:"muted"},` · ${c}`)),d?u("p",{class:"small"},`${d}.`):null,u("p",{class:"\
small muted numbers"},l)))}),s=A("What happened","Each condition is present, absent, or its 95 % interval cannot tell. The intervals are about this run.",u("p",
{class:"headline"},e.headline),u("ul",{class:"findings"},...o),t.limits?u("p",{class:"small"},t.limits):null,u("details",{class:"small"},u("summary",{},"Headlin\
e numbers in words"),...e.description.map(a=>u("p",{},a)),Io(e)));return s.classList.add("diagnosis"),{element:s}}function Po(t){let[e="",r=""]=t.split(/: (.*)/s),
[n="",o=""]=r.split(/, because (.*)/s);return[e.toLowerCase(),n,Oo(o.replace(/\.$/,""))]}var Oo=t=>t.charAt(0).toUpperCase()+t.slice(1);function Io({noise:t}){return t.
transitive_share_noise===null?null:u("p",{},`Last half: transitive share ${S(t.transitive_share)} (an order of strength with the same noise rarely falls below ${S(
t.transitive_share_noise)}), checkerboards ${ut(t.checkerboard_share)} (it rarely exceeds ${ut(t.checkerboard_share_noise)}).`)}function Zr(t){let e=[t.held_out?.pursuers,t.held_out?.evaders].filter(r=>r!=null);return e.length?{element:A("Held-out opponents",`The last generations against\
 opponents that no run has met; 95 % intervals over ${e[0].episodes} episodes.`,...e.map(Lo))}:null}function Lo(t){let e=n=>n.at(-1),r=[["mean",e(t.mean)],...Object.
entries(t.against).map(([n,o])=>[n,e(o)])];return u("table",{class:"scores numbers"},u("caption",{},u("span",{class:t.team},`${t.team}s`),` of generation ${t.generations.
at(-1)}, ${t.score}`),...r.map(([n,o],s)=>u("tr",{class:s?"":"mean"},u("th",{scope:"row"},n),u("td",{class:"range"},No(o,t.team)),u("td",{},$e(o.value,o.low,o.high)))))}
function No({value:t,low:e,high:r},n){let o=u("span",{class:`between ${n}`});o.style.left=`${100*(e??t)}%`,o.style.width=`${100*((r??t)-(e??t))}%`;let s=u("span",
{class:`value ${n}`});return s.style.left=`${100*t}%`,u("span",{class:"scale","aria-hidden":"true"},o,s)}function en(t){let e=t.settings.filter(o=>o.changed),r=t.settings.filter(o=>!o.changed),n=A("Settings",`${t.schedule}, seed ${t.seed}. Every setting is an optio\
n of matrixworld evolve.`,e.length?Qr(e,"other than the default"):u("p",{class:"small"},"All settings are the defaults."),u("details",{class:"small"},u("summary",
{},`${r.length} settings with their defaults`),Qr(r,"defaults")));return n.classList.add("settings"),{element:n}}function Qr(t,e){return u("div",{class:"wide-ta\
ble"},u("table",{class:"small"},u("caption",{class:"heard"},`Settings: ${e}`),...t.map(({name:r,value:n,help:o})=>u("tr",{},u("th",{scope:"row"},`--${r.replaceAll(
"_","-")}`),u("td",{class:"numbers"},n),u("td",{class:"muted"},o)))))}function A(t,e,...r){return u("section",{class:"card panel","aria-label":t},u("header",{},u("h2",{},t),u("p",{class:"small muted"},e)),...r)}function tn(t,e,r){
let n=new Map,o=u("div",{class:"panels"}),s=[],a=()=>s.forEach(l=>l.update?.()),i=()=>{let l=t[e.selected.run];s=n.get(l)??$o(l,e,r),n.set(l,s),o.replaceChildren(
...s.map(c=>c.element)),a()};return e.on("run",i),e.on("match",a),e.on("hover",a),i(),o}function $o(t,e,r){return[Jr(t),Xr(t,e),Wr(t,e,r),qr(t,e),Yr(t,e),jr(t,e),
Zr(t),en(t)].filter(o=>o!==null)}var rn={pursuer:null,evader:null,lag:null},ze=class extends EventTarget{#e;#n=rn;constructor(e){super(),this.#e=e}get selected(){return this.#e}get hover(){return this.#n}select(e){
let r=this.#e,n=["run","pursuer","evader"].some(o=>o in e&&e[o]!==r[o]);this.#e={...r,...n?{episode:0,seed:null}:{},...e},this.#e.run!==r.run&&this.dispatchEvent(
new Event("run")),this.dispatchEvent(new Event("match"))}point(e){let r={...rn,...e};r.pursuer===this.#n.pursuer&&r.evader===this.#n.evader&&r.lag===this.#n.lag||
(this.#n=r,this.dispatchEvent(new Event("hover")))}on(e,r){this.addEventListener(e,r)}};var ve=jt(),{runs:F}=ve,[Uo,Ho]=F[0].payoff.shape,Z=new ze({run:0,pursuer:Uo-1,evader:Ho-1,episode:0,seed:null}),B=new Fe(F,Z),nn=new Be(F,Z),ht=qt(),on=null;document.
getElementById("page").replaceWith(u("header",{class:"top"},u("h1",{},ve.title),u("p",{class:"muted small about"},`matrixworld ${ve.version}`),u("div",{class:"t\
ools"},Wt(),u("button",{type:"button",title:"Keys (?)","aria-label":"Keys",onclick:()=>ht.showModal()},"?"))),...ve.note?[u("p",{class:"note small muted"},ve.note)]:
[],Xt(F,Z),u("main",{class:"stages"},nn.element,B.element),tn(F,Z,()=>on),ht);Object.assign(window,{matrixworldExplorer:{get match(){return B.match},get step(){
return B.player.step},get shape(){return F[Z.selected.run].payoff.shape}}});nn.element.addEventListener("play",()=>B.playSoon());Yt(F,Z,B,ht);requestAnimationFrame(
()=>setTimeout(()=>{Bt().then(t=>{on=t,B.start(t),document.body.dataset.ready="true"},t=>{B.element.prepend(u("p",{class:"problem",role:"alert"},`The engine doe\
s not start here: ${String(t)}`)),document.body.dataset.ready="true"})}));})();
