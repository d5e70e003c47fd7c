/* built from web/ by "npm run build"; sources b913cd257b1a9ce9e7cc59416cdf56784242f9935f6210119e3ef7525a9df4d8 */
"use strict";(()=>{var ar={now:()=>performance.now(),request:t=>requestAnimationFrame(t),cancel:t=>cancelAnimationFrame(t)},F=[.5,1,2,4,8,16,32,64],J=class extends EventTarget{#e;#t;#r;#o;#n=0;#s=0;#a=!1;#l=null;#d=0;glide=.28;constructor(e,r={}){
super(),this.#e=e,this.#t=r.speed??4,this.#o=r.still??!1,this.#r=r.clock??ar}get step(){return this.#n}get time(){return this.#o?this.#n:this.#s}get arrived(){return this.#s===
this.#n}get playing(){return this.#a}get length(){return this.#e}set length(e){this.#e=e,this.#n>e&&this.jump(e),this.#c("state")}get speed(){return this.#t}set speed(e){
this.#t=e,this.#c("state")}changeSpeed(e){let r=F.findIndex(n=>n>=this.#t);this.speed=F[Math.min(F.length-1,Math.max(0,r+e))]}play(){this.#a||!this.#e||(this.#n===
this.#e&&this.jump(0),this.#a=!0,this.#c("state"),this.#m())}pause(){this.#a&&(this.#a=!1,this.#c("state"))}toggle(){this.#a?this.pause():this.play()}move(e){this.
pause();let r=Math.min(this.#e,Math.max(0,this.#n+e));Math.abs(r-this.#s)>1?this.jump(r):this.#i(r),this.#m()}jump(e){this.#s=Math.min(this.#e,Math.max(0,Math.round(
e))),this.#i(this.#s),this.#c("frame")}#i(e){e!==this.#n&&(this.#n=e,this.#c("step"),this.#o&&this.#c("frame"))}#m(){this.#l===null&&(this.#d=this.#r.now(),this.#l=
this.#r.request(()=>this.#u()))}#u(){this.#l=null;let e=this.#r.now();this.#h(Math.min(.25,(e-this.#d)/1e3)),this.#d=e,(!this.#o||this.arrived)&&this.#c("frame"),
(this.#a||this.#s!==this.#n)&&(this.#l=this.#r.request(()=>this.#u()))}#h(e){let r=e;for(;r>0;){if(this.#s===this.#n){if(!this.#a)return;if(this.#n===this.#e)return this.
pause();this.#i(this.#n+1)}let n=this.#a?this.#t:1/this.glide,o=this.#n-this.#s,s=Math.min(Math.abs(o),r*n);r-=s/n,this.#s=s===Math.abs(o)?this.#n:this.#s+Math.
sign(o)*s}this.#a&&this.#s===this.#e&&this.pause()}#c(e){this.dispatchEvent(new Event(e))}};function Y(t,e){if(e.ctrlKey||e.metaKey||e.altKey)return!1;let r=e.shiftKey?
10:1,o={" ":()=>t.toggle(),ArrowRight:()=>t.move(r),ArrowLeft:()=>t.move(-r),Home:()=>t.move(-t.length),End:()=>t.move(t.length),"+":()=>t.changeSpeed(1),"-":()=>t.
changeSpeed(-1)}[e.key];return o?.(),o!==void 0}var Ue={SIMULTANEOUS:0,SWARM_TURNS:1,AGENT_TURNS:2},W={DISAPPEAR:0,REACH:1,BOUNCE:2},De={OCCUPATION:0,SURROUND:1},Fe={FAULT:0,INVOLVED:1};var We=["obstacle","teammate","adversary"],fe=["vertex","edge","chain"],Be=["turn","kind","form","first","second","row","col","at_fault","held","doomed"],ye=["p\
ursuer_{number}","evader_{number}"],He={obstacle:"{first} ran into the obstacle or border at {cell}",vertex:"{first} and {second} both headed for {cell}",edge:"\
{first} and {second} meant to swap, {first} to {cell}",chain:"{first} headed for {cell}, where {second} had to stay"},B={"both held":"both bounce","both doomed":"\
both disappear",held:"{agent} bounces",doomed:"{agent} disappears",none:"nobody is stopped"},Ge="{event}: {outcome}",be={random:"any action, all equally likely",
still:"always stays",chaser:"moves to where the nearest adversary in view is nearest",fleer:"moves to where the nearest adversary in view is farthest","clumsy-c\
haser":"a chaser that takes any action in half of the steps",hunter:"a chaser of the nearest adversary in view to which no teammate in view is nearer",surrounder:"\
a chaser of the nearest free cell beside an adversary without a teammate","clumsy-fleer":"a fleer that takes any action in half of the steps",dodger:"moves to w\
here all adversaries in view together are farthest"},ze={free:".GS",blocked:"#@OTW"};var O=1+Be.length;function H(t,e){return t.replace(/\{(\w+)\}/g,(r,n)=>String(e[n]))}function ge(t,e){return t<e?H(ye[0],{number:t}):H(ye[1],{number:t-e})}function ir(t,e){
let[r,n,o,s,a,i,l,...c]=Array.from(t),d=a<0?[s]:[s,a],[m,h,p]=c.map(_=>d.filter((R,N)=>_>>N&1)),y=d.map(_=>ge(_,e)),f=H(He[a<0?"obstacle":fe[o]],{first:y[0],second:y[y.
length-1],cell:`(${i}, ${l})`}),v=H(Ge,{event:f,outcome:lr(d.length,h,p,e)});return{kind:We[n],form:fe[o],agents:d,cell:[i,l],at_fault:m,held:h,doomed:p,turn:r,
text:v}}function lr(t,e,r,n){if(t===2&&e.length===2)return B["both held"];if(t===2&&r.length===2)return B["both doomed"];let o=s=>a=>H(B[s],{agent:ge(a,n)});return[
...e.map(o("held")),...r.map(o("doomed"))].join(", ")||B.none}function Q(t,e){let r=[];for(let n=0;n<t.length;n+=O)r.push(ir(t.subarray(n+1,n+O),e));return r}var T=class extends Error{name="EngineError"};function b(t,e,r){let n=typeof r=="string"?`'${r}'`:typeof r=="object"?JSON.stringify(r):String(r);return new T(`${t}\
: expected ${e}, got ${n}`)}var P=class{bytes;constructor(e){this.bytes=e}},Ke=0,ve=[Uint8Array,Uint8Array,Int32Array,BigInt64Array,BigUint64Array,Float32Array,Float64Array],je=4,Ve=4,cr=new TextEncoder,
dr=new TextDecoder;function ur(t){for(let e=ve.length-1;e>Ke;--e)if(t instanceof ve[e])return e;throw new TypeError("array: expected a typed array of the engine\
's numbers, got another")}function we(t){return new Uint8Array(t.buffer,t.byteOffset,t.byteLength)}function mr(t){return cr.encode(`${t}\0`)}var xe=class{engine;addresses=[];constructor(e){
this.engine=e}copy(e){let r=this.engine._malloc(Math.max(e.length,1));if(r===0)throw new T("memory: expected room for the arguments, got none");return this.addresses.
push(r),this.engine.HEAPU8.set(e,r),r}text(e){return this.copy(mr(e))}arrays(e){let r=Object.entries(e),n=r.flatMap(([s,a])=>{let i=a instanceof P,l=i?a.bytes:a;
return[this.text(s),i?Ke:ur(l),l.length,this.copy(we(l))]}),o=this.copy(we(Int32Array.from(n)));return this.copy(we(Int32Array.of(r.length,o)))}free(){for(let e of this.
addresses)this.engine._free(e)}};function qe(t,e){let r=t.HEAPU8;return dr.decode(r.subarray(e,r.indexOf(0,e)))}function Z(t){let e=new Int32Array(t.HEAPU8.buffer),
r=t._last_outputs()/je,n=e[r+1]/je,o={};for(let s=n;s<n+e[r]*Ve;s+=Ve){let a=ve[e[s+1]],i=e[s+2]*a.BYTES_PER_ELEMENT,l=e[s+3];o[qe(t,e[s])]=new a(t.HEAPU8.slice(
l,l+i).buffer)}return o}function G(t,e){let r=new xe(t);try{let n=e(r);if(n===0)throw new T(qe(t,t._last_error()));return n}finally{r.free()}}var pr=2**31-1,hr=2n**64n-1n,fr=34028234663852886e22;function M(t,e){if(typeof e!="number"||!Number.isInteger(e)||Math.abs(e)>pr)throw b(t,"an integer",e);return Int32Array.
of(e)}function ee(t,e){if(typeof e!="boolean")throw b(t,"true or false",e);return new P(Uint8Array.of(Number(e)))}function E(t,e,r){let n=typeof e=="string"&&Object.
hasOwn(r,e)?r[e]:void 0;if(n===void 0)throw b(t,`one of ${Object.keys(r).join(", ")}`,e);return Int32Array.of(n)}function Ae(t,e){if(typeof e!="number"||!(Math.
abs(e)<=fr))throw b(t,"a finite number",e);return e}function I(t,e){let n=typeof e=="bigint"||typeof e=="number"&&Number.isSafeInteger(e)?BigInt(e):-1n;if(n<0n||
n>hr)throw b(t,"an integer from 0 to 2^64 - 1",e);return BigUint64Array.of(n)}function yr(t){return{"rules.interaction":E("interaction",t.interaction,Ue),"rules\
.obstacle":E("obstacle",t.obstacle,W),"rules.teammate":E("teammate",t.teammate,W),"rules.evader":E("evader",t.evader,W),"rules.pursuer":E("pursuer",t.pursuer,W),
"rules.capture":E("capture",t.capture,De),"rules.captured_disappear":ee("captured_disappear",t.captured_disappear)}}function Xe(t,e){let r=typeof e=="number"?[e,
e,e]:e;if(!Array.isArray(r)||r.length!==3)throw b(t,"1 or 3 numbers",e);return Float32Array.from(r,n=>Ae(t,n))}function br(t){let e=(r,n)=>Float32Array.of(Ae(r,
t[r]),Ae(n,t[n]));return{"rewards.capture":e("pursuer_capture","evader_capture"),"rewards.neighbor":e("pursuer_neighbor","evader_neighbor"),"rewards.step":e("pu\
rsuer_step","evader_step"),"rewards.pursuer_collide":Xe("pursuer_collide",t.pursuer_collide),"rewards.evader_collide":Xe("evader_collide",t.evader_collide),"rew\
ards.blame":E("blame",t.blame,Fe),"rewards.capture_repeats":ee("capture_repeats",t.capture_repeats)}}function Ye(t){if(t===void 0||typeof t=="number")return new Uint8Array(
0);if(t instanceof Uint8Array)return t;let{free:e,blocked:r}=ze;for(let[n,o]of t.entries()){if(o.length!==t[0]?.length)throw b(`map, row ${n}`,`${t[0]?.length} \
cells as in row 0`,o.length);let s=[...o].find(a=>!e.includes(a)&&!r.includes(a));if(s)throw b(`map, row ${n}`,`'${e}' (free) or '${r}' (obstacle)`,s)}return Uint8Array.
from([...t.join("")],n=>Number(r.includes(n)))}function Qe(t,e){if(!Array.isArray(t))return;let r=[t.length,t[0]?.length??0];if(!(r[0]===e.rows&&r[1]===e.cols))
throw b("obstacle map",`shape (${e.rows}, ${e.cols}), the rows and cols`,r)}function te(t){Qe(t.obstacles,t);let e=typeof t.obstacles=="number"?t.obstacles:0;return{
...yr(t.rules),...br(t.rewards),rows:M("rows",t.rows),cols:M("cols",t.cols),n_pursuers:M("n_pursuers",t.n_pursuers),n_evaders:M("n_evaders",t.n_evaders),fov:M("\
fov",t.fov),diagonal:ee("diagonal",t.diagonal),max_steps:M("max_steps",t.max_steps),density:Float64Array.of(e),map:Ye(t.obstacles)}}function Je(t,e){return Int32Array.
from((e??[]).flat(),r=>M(t,r)[0])}function Ze(t,e){return Qe(t.obstacles,e),{seed:I("seed",t.seed??0n),episode:I("episode",t.episode??0),pursuers:Je("pursuers",
t.pursuers),evaders:Je("evaders",t.evaders),map:Ye(t.obstacles)}}function re(t){return{actions:Int32Array.from(t,e=>M("actions",e)[0])}}function L(t){if(typeof t==
"string"){if(!Object.hasOwn(be,t))throw b("policy",`one of ${Object.keys(be).join(", ")}`,t);return{script:new TextEncoder().encode(t)}}if(t.activation!=="relu"&&
t.activation!=="tanh")throw b("activation","'relu' or 'tanh'",t.activation);return{hidden:Int32Array.from(t.hidden,e=>M("hidden",e)[0]),activation:new TextEncoder().
encode(t.activation),sampled:ee("sampled",t.sampled),genome:t.genome}}var gr=["first_turn","terminated","truncated"];function et(t){let e={...t};for(let r of gr)
e[r]=new P(t[r]);return e}var ne=class{config;seed;episode;n_agents;statistics;positions;last_positions;alive;captured;ever_captured;actions;rewards;involved;fault;map;conflict_table;first_conflict;constructor(e,r,n,o){
this.config=e,this.seed=r,this.episode=n,this.n_agents=e.n_pursuers+e.n_evaders,this.statistics=tt(o,0),this.positions=o.positions,this.last_positions=o.last_positions,
this.alive=o.alive,this.captured=o.captured,this.ever_captured=o.ever_captured,this.actions=o.actions,this.rewards=o.rewards,this.involved=o.involved,this.fault=
o.fault,this.map=o.map,this.conflict_table=o.conflict_table,this.first_conflict=wr(this.conflict_table,this.length)}get length(){return this.actions.length/this.
n_agents}conflicts(e){this.check(e);let[r,n]=[this.first_conflict[e],this.first_conflict[e+1]],o=this.conflict_table.subarray(r*O,n*O);return Q(o,this.config.n_pursuers)}seek(e,r){
this.check(r),(!(e.seed===this.seed&&e.episode===BigInt(this.episode))||e.turn!==0||e.steps>r)&&e.reset({seed:this.seed,episode:this.episode});for(let o=e.steps;o<
r;++o)e.step(this.actions.subarray(o*this.n_agents,(o+1)*this.n_agents))}check(e){if(!(Number.isInteger(e)&&e>=0&&e<=this.length))throw b("step",`0 to ${this.length}`,
e)}};function wr(t,e){let r=new Int32Array(e+2);for(let n=0;n<t.length;n+=O)++r[t[n]+1];for(let n=1;n<r.length;++n)r[n]+=r[n-1];return r}function tt(t,e){let r=t["\
statistics.length"].length,n=s=>{let a=t[`statistics.${s}`],i=a.length/r;return a.slice(e*i,(e+1)*i)},o=s=>Number(n(s)[0]);return{capture_rate:o("capture_rate"),
ever_capture_rate:o("ever_capture_rate"),captured_fraction:o("captured_fraction"),length:o("length"),return:n("return"),survivors:n("survivors"),overlap:n("over\
lap"),collisions:n("collisions"),faults:n("faults"),agent_steps:n("agent_steps")}}function rt(t,e,r,n){let o=[te(r.config),L(r.pursuers),L(r.evaders),n];return G(
t,s=>{let[a,i,l,c]=o.map(d=>s.arrays(d));return t[e](a,i,l,c)}),Z(t)}function nt(t,e,r,n){let o={seed:I("seed",r),episode:I("episode",n)};return new ne(e.config,
r,n,rt(t,"_play_match",e,o))}function ot(t,e,r,n){if(!Number.isInteger(n)||n<1)throw b("n_episodes","at least 1",n);let o={seed:I("seed",r),n_episodes:Int32Array.
of(n)},s=rt(t,"_play_rollout",e,o);return Array.from({length:n},(a,i)=>tt(s,i))}var st=new FinalizationRegistry(([t,e])=>t._world_free(e)),z=class{config;n_agents;n_actions;engine;at;freed=!1;constructor(e,r){this.engine=e,this.config=r,this.
n_agents=r.n_pursuers+r.n_evaders,this.n_actions=r.diagonal?9:5,this.at=G(e,n=>e._world_new(n.arrays(te(r)))),st.register(this,[e,this.at],this)}free(){this.freed||
(this.freed=!0,st.unregister(this),this.engine._world_free(this.at))}reset(e={}){let r=Ze(e,this.config);this.call(n=>this.engine._world_reset(this.at,n.arrays(
r)))}step(e){let r=re(e);this.call(n=>this.engine._world_step(this.at,n.arrays(r)))}playTurn(e){let r=re(e);this.call(n=>this.engine._world_play_turn(this.at,n.
arrays(r)))}decide(e,r,n){let{n_pursuers:o}=this.config,s=r==="pursuer"?[0,o]:[o,this.n_agents];return this.choose(e,s,n)}choose(e,[r,n],o){if(o.length!==this.n_agents)
throw b("actions",String(this.n_agents),o.length);let s=[L(e),re(o)],{actions:a}=this.call(i=>this.engine._world_decide(this.at,i.arrays(s[0]),r,n,i.arrays(s[1])));
return Uint8Array.from(a)}get n_turns(){return this.turnNumbers()[1]}get turn(){return this.turnNumbers()[0]}get actors(){let[,,e,r]=this.turnNumbers();return[e,
r]}turnNumbers(){return this.call(()=>this.engine._world_turn(this.at)).turn}get steps(){return this.read("steps")[0]}get seed(){return this.read("seed")[0]}get episode(){
return this.read("episode")[0]}get over(){return this.read("terminated")[0]===1||this.read("truncated")[0]===1}read(e){return this.call(r=>this.engine._world_read(
this.at,r.text(e)))[e]}view(e){let r=3*this.config.fov**2;return this.read("views").slice(e*r,(e+1)*r)}map(){return this.read("state").slice(2*this.config.rows*
this.config.cols)}conflicts(){let{conflict_table:e}=this.call(()=>this.engine._world_conflicts(this.at));return Q(e,this.config.n_pursuers)}answer(e,r){let n=L(
e),{logits:o}=this.call(i=>this.engine._world_logits(this.at,i.arrays(n),r)),s=o,a=this.choose(e,[r,r+1],new Uint8Array(this.n_agents))[r];return{logits:s,probabilities:vr(
s),action:a}}snapshot(){return this.call(()=>this.engine._world_snapshot(this.at))}restore(e){let r=et(e);this.call(n=>this.engine._world_restore(this.at,n.arrays(
r)))}call(e){if(this.freed)throw b("world","one that is in use","one that was freed");return G(this.engine,e),Z(this.engine)}};function vr(t){let e=Math.max(...t),
r=Array.from(t,o=>Math.exp(o-e)),n=r.reduce((o,s)=>o+s,0);return Float32Array.from(r,o=>o/n)}var Me=class{compiled;constructor(e){this.compiled=e}world(e){return new z(this.compiled,e)}match(e,r,n,o,s=0){return nt(this.compiled,{config:e,pursuers:r,evaders:n},
o,s)}rollout(e,r,n,o,s){return ot(this.compiled,{config:e,pursuers:r,evaders:n},o,s)}},at;function it(t=globalThis.matrixworldEngine){return at??=xr(t),at}async function xr(t){
if(!t)throw new Error("matrixworldEngine: expected the script engine.js before this one, got none");let e=Uint8Array.from(atob(t.binary),r=>r.charCodeAt(0));return new Me(
await t({wasmBinary:e}))}var Ar="http://www.w3.org/2000/svg";function u(t,e={},...r){return lt(document.createElement(t),e,r)}function C(t,e={},...r){return lt(document.createElementNS(
Ar,t),e,r)}function lt(t,e,r){for(let[n,o]of Object.entries(e))o==null||o===!1||(typeof o=="function"?t.addEventListener(n.slice(2),o):t.setAttribute(n,o===!0?"":
String(o)));return t.append(...r.filter(Mr).map(n=>typeof n=="number"?String(n):n)),t}function Mr(t){return t!=null&&t!==!1}var Sr=matchMedia("(prefers-color-scheme: dark)");function _r(){let t=document.documentElement.dataset.theme;return t?t==="dark":Sr.matches}function Se(){document.
documentElement.dataset.theme=_r()?"light":"dark"}function ct(){return u("button",{type:"button",title:"Light or dark (D)","aria-label":"Light or dark",onclick:Se},"◐")}function dt(t){let e=atob(_e(t)),r=new Uint8Array(e.length);for(let n=0;n<r.length;n++)r[n]=e.charCodeAt(n);return r}function _e(t){return document.getElementById(
t)?.textContent??""}function ut(){return JSON.parse(_e("data"))}var Te=[[0,0],[-1,0],[0,1],[1,0],[0,-1],[-1,1],[1,1],[1,-1],[-1,-1]],k=(t,e)=>e<t.nPursuers,g=(t,e)=>[t.positions[2*e],t.positions[2*e+1]],Tr=(t,e)=>t[0]===e[0]&&
t[1]===e[1],Ee=({rows:t,cols:e},[r,n])=>r>=0&&n>=0&&r<t&&n<e,Ce=(t,e,r=3)=>t!==void 0&&[0,1,2].slice(0,r).some(n=>t[3*e+n]),ke=(t,e)=>Ce(t.fault,e),mt=(t,e)=>!ke(
t,e)&&Ce(t.involved,e,2);function oe(t,e,r){let n=!Tr(g(t,r),g(e,r)),o=e.involved===void 0||Ce(e.involved,r);return!!(e.alive[r]&&e.actions?.[r]&&!n&&o)}function se(t,e,r){
let[n,o]=g(t,r),[s,a]=Te[e.actions?.[r]??0];return[n+s,o+a]}function ae(t,e,r){return Array.from({length:r.everCaptured.length},(o,s)=>s).filter(o=>r.everCaptured[o]&&
!e.everCaptured[o]).map(o=>t.nPursuers+o)}function ie(t,e){return Array.from({length:e.alive.length},(n,o)=>o).filter(n=>t.alive[n]&&!e.alive[n])}var pt=[-.31,0,.31],ht=[{size:1,at:[[0,0]]},{size:.62,at:[[-.2,.2],[.2,-.2]]},{size:.54,at:[[-.23,.22],[.23,.22],[0,-.22]]},{size:.54,at:[[-.23,.23],[.23,.23],[
-.23,-.23],[.23,-.23]]},{size:.36,at:pt.flatMap(t=>pt.map(e=>[e,t]))}],Er=.3,Cr=.35,kr=.55;function j(t,e){let r=new Map;for(let n=0;n<e.alive.length;n++){if(!e.
alive[n])continue;let[o,s]=g(e,n),a=o*t.cols+s,i=r.get(a);i?i.push(n):r.set(a,[n])}return r}function ft(t,e){let r=Array.from(e.alive,(n,o)=>{let[s,a]=g(e,o);return{
x:a+.5,y:s+.5,size:1,alpha:0}});for(let n of j(t,e).values()){let o=ht[Math.min(n.length,ht.length)-1];n.forEach((s,a)=>{let[i,l]=o.at[Math.min(a,o.at.length-1)],
c=r[s];c.x+=i,c.y+=l,c.size=o.size,c.alpha=1})}return r}var yt=t=>t*t*(3-2*t),$=(t,e,r)=>t+(e-t)*r,bt=t=>Math.min(1,Math.max(0,t));function gt(t,e,r,n){let o={1:2,
2:r}[t.interaction]??1;if(o===1)return yt(n);let s=o===r?e:+!k(t,e),a=Math.max(1/o,Cr);return yt(bt((n-s/(o-1)*(1-a))/a))}function le(t,e){let r=t.moments.length-
1,n=Math.min(Math.floor(e),r),o=t.moments[n],s=ft(t,o);if(n===r||e===n)return s;let a=t.moments[n+1],i=ft(t,a);return s.map((l,c)=>{let d=gt(t,c,s.length,e-n);return Rr(
o,a,c,l,i[c],d)})}function wt(t,e,r){let n=t.moments.length-1,o=Math.min(Math.floor(r),n),[s,a]=[t.moments[o],t.moments[Math.min(o+1,n)]],i=gt(t,e,s.alive.length,
r-o),[[l,c],[d,m]]=[g(s,e),g(a,e)];return[$(c,m,i)+.5,$(l,d,i)+.5]}function Rr(t,e,r,n,o,s){let a=n.alpha>o.alpha,i={x:$(n.x,o.x,s),y:$(n.y,o.y,s),size:a?n.size:
$(n.size,o.size,s),alpha:a?bt((1-s)/(1-kr)):$(n.alpha,o.alpha,s)};if(oe(t,e,r)){let[l,c]=g(t,r),[d,m]=se(t,e,r),h=Er*Math.sin(Math.PI*s);i.x+=(m-c)*h,i.y+=(d-l)*
h}return i}var vt=2*Math.PI;function V(t,e,r,n){t.beginPath(),t.arc(e,r,n/2,0,vt)}function xt(t,e,r,n){let o=n/2,s=[[0,-.97],[.97,.83],[-.97,.83]].map(([a,i])=>[e+a*o,r+i*
o]);t.beginPath(),t.moveTo((s[2][0]+s[0][0])/2,(s[2][1]+s[0][1])/2),s.forEach(([a,i],l)=>{let[c,d]=s[(l+1)%3];t.arcTo(a,i,c,d,n*.09)}),t.closePath()}function At(t,e,r,n){
let o=n*.32;t.beginPath(),t.moveTo(e-o,r-o),t.lineTo(e+o,r+o),t.moveTo(e+o,r-o),t.lineTo(e-o,r+o)}function Mt(t,e,r,n){t.beginPath();for(let o=0;o<16;o++){let s=n/
2*(o%2?.6:.95),a=vt*o/16;t.lineTo(e+s*Math.sin(a),r-s*Math.cos(a))}t.closePath()}function St(t,e,r,n,o,s){let a=Math.atan2(o-r,n-e);t.beginPath(),t.moveTo(e,r),
t.lineTo(n,o);for(let i of[-1,1])t.moveTo(n,o),t.lineTo(n-s*Math.cos(a+i*.6),o-s*Math.sin(a+i*.6))}var _t=4,Nr=1.6,Or=.95,Pr=5,Ir=.16,Lr=9,$r=.09,Ur=.2,Tt=.75,x=(t,e)=>t.left+e*t.cell,A=(t,e)=>t.top+e*t.cell;function U(t,e,r){return k(e,r)?t.colors.pursuer:t.
colors.evader}function Et({ctx:t,grid:e,colors:r}){let{left:n,top:o,cell:s,rows:a,cols:i}=e,[l,c]=[i*s,a*s];if(t.fillStyle=r.paper,t.fillRect(n,o,l,c),s<Pr)return;
t.fillStyle=r.line;let d=Math.max(1,Math.round(s/60));for(let m=1;m<i;m++)t.fillRect(n+m*s,o,d,c);for(let m=1;m<a;m++)t.fillRect(n,o+m*s,l,d)}function Ct({ctx:t,
grid:e,colors:r},n){let{left:o,top:s,cell:a,rows:i,cols:l}=e;t.fillStyle=r.obstacle;for(let d=0;d<i*l;d++){if(!n.obstacles[d])continue;let[m,h]=[Math.floor(d/l),
d%l];t.fillRect(o+h*a,s+m*a,a,a)}let c=Math.min(5,Math.max(2,Math.round(a/18)));t.strokeStyle=r.frame,t.lineWidth=c,t.strokeRect(o-c/2,s-c/2,l*a+c,i*a+c)}function kt({
ctx:t,grid:e,colors:r},n){let{left:o,top:s,cell:a,rows:i,cols:l}=e,c=a<24*n?5:1;t.font=`500 ${Math.round(Math.min(15*n,Math.max(9*n,a*.32)))}px system-ui, sans-\
serif`,t.fillStyle=r.muted,t.textBaseline="alphabetic",t.textAlign="center";let d=5*n+a/40;for(let m=0;m<l;m+=c)t.fillText(String(m),o+(m+.5)*a,s-d);t.textAlign=
"right",t.textBaseline="middle";for(let m=0;m<i;m+=c)t.fillText(String(m),o-d,s+(m+.5)*a)}function Rt(t,e,r,n,o){let{ctx:s,grid:a}=t,i=Math.floor(e.fov/2)+.5,[l,
c]=[Math.max(0,n-i),Math.min(a.cols,n+i)],[d,m]=[Math.max(0,o-i),Math.min(a.rows,o+i)],h=[x(a,l),A(a,d),(c-l)*a.cell,(m-d)*a.cell],p=U(t,e,r);s.globalAlpha=.11,
s.fillStyle=p,s.fillRect(...h),s.globalAlpha=.8,s.strokeStyle=p,s.lineWidth=Math.max(1,a.cell/24),s.strokeRect(...h),s.globalAlpha=1}function Nt(t,e,r,n,o){let{
ctx:s,grid:a}=t,i=Math.min(Math.ceil(r),e.moments.length-1),l=e.moments[i];s.lineCap="round",s.lineWidth=Math.min(Lr,Math.max(1,a.cell*Ir));for(let c=Math.max(1,
Math.floor(r-n)+1);c<=i;c++){let[d,m]=[e.moments[c-1],e.moments[c]],h=Math.max(0,Math.min(1,(r-c)/n));s.globalAlpha=Tt+(Ur-Tt)*h;for(let p=0;p<m.alive.length;p++){
let y=c===i&&r<i;if(!d.alive[p]||!(l.alive[p]||y))continue;let f=(k(e,p)?-1:1)*$r,[v,_]=g(d,p),[R,N]=g(m,p);if(v===R&&_===N)continue;let X=y?o[p].x:N+.5,sr=y?o[p].
y:R+.5;s.strokeStyle=U(t,e,p),s.beginPath(),s.moveTo(x(a,_+.5+f),A(a,v+.5+f)),s.lineTo(x(a,X+f),A(a,sr+f)),s.stroke()}}s.globalAlpha=1}function Ot(t,e,r){let n=Math.
min(Math.ceil(r),e.moments.length-1);for(let o=Math.max(1,n-_t+1);o<=n;o++){let[s,a]=[e.moments[o-1],e.moments[o]],i=o>r?Math.max(0,1-2*(o-r)):1-(r-o)/_t,l=ae(e,
s,a);for(let c of ie(s,a))l.includes(c)||Fr(t,g(a,c),i);for(let c of l)Dr(t,g(a,c),i)}t.ctx.globalAlpha=1}function Dr({ctx:t,grid:e,colors:r},[n,o],s){t.globalAlpha=
s,Mt(t,x(e,o+.5),A(e,n+.5),Math.max(8,e.cell*Nr)),t.fillStyle=r.capture,t.fill(),t.strokeStyle=r.ink,t.lineWidth=Math.max(1,e.cell/36),t.lineJoin="round",t.stroke()}
function Fr({ctx:t,grid:e,colors:r},[n,o],s){t.globalAlpha=s,At(t,x(e,o+.5),A(e,n+.5),Math.max(7,e.cell*Or)),t.strokeStyle=r.collision,t.lineWidth=Math.max(2,e.
cell*.17),t.lineCap="round",t.stroke()}function Pt({ctx:t,grid:e,colors:r},n,o){let s=Math.max(1,e.cell*.07);t.strokeStyle=t.fillStyle=r.collision,t.lineWidth=Math.
max(1,e.cell*.05),t.setLineDash([e.cell*.14,e.cell*.1]);for(let[a,i]of n){if(a<0||i<0||a>=e.rows||i>=e.cols)continue;let l=[x(e,i)+s,A(e,a)+s,e.cell-2*s,e.cell-
2*s];t.globalAlpha=.2*o,t.fillRect(...l),t.globalAlpha=o,t.strokeRect(...l)}t.setLineDash([]),t.globalAlpha=1}function It({ctx:t,grid:e,colors:r},n,o,s,a){t.globalAlpha=
a,V(t,x(e,n),A(e,o),Math.max(8,e.cell*s*1.02)),t.strokeStyle=r.collision,t.lineWidth=Math.max(1.5,e.cell*.085*Math.sqrt(s)),t.stroke(),t.globalAlpha=1}var Wr=.8,Br=.92,Hr=15,Gr=7,Oe=9;function Lt(t,e,r,n,o,s){n.forEach((a,i)=>{a.alpha>0&&zr(t,e,r,i,a,o,s)}),t.ctx.globalAlpha=1;for(let a of j(e,r).values())a.length>
Oe&&jr(t,n[a[Oe-1]],a.length-Oe+1)}function zr(t,e,r,n,o,s,a){let{ctx:i,grid:l,colors:c}=t,d=k(e,n),[m,h]=[l.left+o.x*l.cell,l.top+o.y*l.cell],p=Math.max(4,l.cell*
o.size*(d?Br:Wr)),y=U(t,e,n),f=!d&&!!r.captured[n-e.nPursuers];if(i.globalAlpha=o.alpha,(d?xt:V)(i,m,h,p),p>Gr*a&&(i.strokeStyle=c.paper,i.lineWidth=Math.max(2,
p*.1),i.stroke()),i.fillStyle=f?c.paper:y,i.fill(),f&&(V(i,m,h,p*.82),i.strokeStyle=y,i.lineWidth=p*.18,i.stroke()),!s||p<Hr*a)return;let v=String(d?n:n-e.nPursuers);
i.font=`700 ${Math.round(p*(d?.4:.5)*(v.length>1?.8:1))}px system-ui, sans-serif`,i.textAlign="center",i.textBaseline="middle",i.fillStyle=f?y:c.paper,i.fillText(
v,m,h+p*(d?.17:.03))}function jr({ctx:t,grid:e,colors:r},n,o){let[s,a]=[e.left+n.x*e.cell,e.top+n.y*e.cell];t.font=`700 ${Math.round(e.cell*.3)}px system-ui, sa\
ns-serif`,t.textAlign="center",t.textBaseline="middle",t.strokeStyle=r.paper,t.lineWidth=e.cell*.1,t.strokeText(`+${o}`,s,a),t.fillStyle=r.ink,t.fillText(`+${o}`,
s,a)}var Vr=.46,Kr=.86,qr=.66,$t=.48,Xr=.78,Jr=.58;function Ut(t,e,r,n){let[o,s]=[e.moments[r-1],e.moments[r]];if(!o)return;let{ctx:a,grid:i,colors:l}=t;a.strokeStyle=
l.collision,a.lineWidth=Math.max(1.5,i.cell*.07),a.lineCap="butt",a.globalAlpha=n;for(let c=0;c<s.alive.length;c++)oe(o,s,c)&&Yr(t,e,g(o,c),se(o,s,c));a.globalAlpha=
1}function Yr({ctx:t,grid:e},r,n,o){let[s,a]=[o[1]-n[1],o[0]-n[0]],i=m=>x(e,n[1]+.5+s*m),l=m=>A(e,n[0]+.5+a*m),c=Ee(r,o)?Xr:Jr;t.setLineDash([e.cell*.09,e.cell*
.06]),t.beginPath(),t.moveTo(i($t),l($t)),t.lineTo(i(c),l(c)),t.stroke(),t.setLineDash([]);let d=.17*e.cell/Math.hypot(s,a);t.beginPath(),t.moveTo(i(c)-a*d,l(c)+
s*d),t.lineTo(i(c)+a*d,l(c)-s*d),t.stroke()}function Dt(t,e,r,n,o,s){let a=Te[s];if(!s||!a)return;let{ctx:i,grid:l,colors:c}=t,d=Ee(e,[n[0]+a[0],n[1]+a[1]])?Kr:
qr,m=Vr*o.size,h=[x(l,o.x+a[1]*m),A(l,o.y+a[0]*m),x(l,o.x+a[1]*d),A(l,o.y+a[0]*d)],p=Math.max(1.5,l.cell*.085);i.lineCap=i.lineJoin="round";for(let[y,f]of[[c.paper,
p*2.1],[U(t,e,r),p]])i.strokeStyle=y,i.lineWidth=f,St(i,...h,l.cell*.2),i.stroke()}var Wt={numbers:!0,axes:!1,trail:6,viewers:[],plan:null,selected:null,cursor:null};function Bt(t,e,r,n,o){let{ctx:s,grid:a,colors:i}=t,l=Math.min(Math.ceil(r),e.
moments.length-1),c=e.moments[l],d=r===l,m=le(e,r),h=d?1:Math.max(0,1-2*(l-r));s.clearRect(0,0,s.canvas.width,s.canvas.height),Et(t);for(let f of n.viewers)m[f]?.
alpha&&Rt(t,e,f,...wt(e,f,r));Ct(t,e),n.axes&&kt(t,o),Nt(t,e,r,n.trail,m),Pt(t,c.contested??[],h),Ot(t,e,r),Ut(t,e,l,h),m.forEach(({x:f,y:v,size:_},R)=>{let N=mt(
c,R)?.4:0,X=ke(c,R)?1:N;X&&It(t,f,v,_,X*h)});let p=d?c:e.moments[Math.max(0,l-1)];if(Lt(t,e,p,m,n.numbers,o),d&&n.plan)for(let[f,v]of m.entries())v.alpha&&Dt(t,
e,f,g(c,f),v,n.plan[f]??0);s.lineWidth=Math.max(2,2.5*o),s.strokeStyle=i.focus;let y=n.selected===null?void 0:m[n.selected];y?.alpha&&Ft(t,y.x,y.y,y.size*.96),n.
cursor&&(s.setLineDash([a.cell*.12,a.cell*.08]),Ft(t,n.cursor[1]+.5,n.cursor[0]+.5,.8),s.setLineDash([]))}function Ft({ctx:t,grid:e},r,n,o){let s=o*e.cell;t.beginPath(),
t.roundRect(e.left+r*e.cell-s/2,e.top+n*e.cell-s/2,s,s,s*.1),t.stroke()}var Ht=(t,e)=>(e+.24)/(t+.24);function Gt(t,e,r,n,o,s){let a=r?28*s:0,i=(c,d)=>(c-a)/(d+2*.12),l=Math.max(1,Math.floor(Math.min(i(n,e),i(o,t))));return{rows:t,cols:e,
cell:l,left:Math.round((n-e*l+a)/2),top:Math.round((o-t*l+a)/2)}}function zt(t,e,r){let n=Math.floor((r-t.top)/t.cell),o=Math.floor((e-t.left)/t.cell);return n>=
0&&n<t.rows&&o>=0&&o<t.cols?[n,o]:null}var Qr={paper:"--board-paper",line:"--board-line",frame:"--board-frame",ink:"--board-ink",muted:"--board-muted",obstacle:"--board-obstacle",pursuer:"--pursuer",
evader:"--evader",capture:"--capture",collision:"--collision",focus:"--focus"};function jt(t){let e=getComputedStyle(t),r=Object.entries(Qr).map(([n,o])=>[n,e.getPropertyValue(
o).trim()]);return Object.fromEntries(r)}var Pe=()=>matchMedia("(prefers-reduced-motion: reduce)").matches,ce=class{canvas;#e=null;#t=0;#r;#o={rows:1,cols:1,left:0,top:0,cell:1};#n=0;#s;#a;constructor(e,r={}){
this.canvas=e,e.classList.add("board"),e.setAttribute("role","img"),this.#r={...Wt,...r},this.#s=new ResizeObserver(()=>this.#d()),this.#s.observe(e),this.#a=new MutationObserver(
()=>this.redraw()),this.#a.observe(document.documentElement,{attributes:!0}),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",this.redraw)}close(){
this.#s.disconnect(),this.#a.disconnect(),matchMedia("(prefers-color-scheme: dark)").removeEventListener("change",this.redraw),cancelAnimationFrame(this.#n)}get look(){
return this.#r}set look(e){this.#r={...this.#r,...e},this.#l(),this.redraw()}get time(){return this.#t}show(e,r){this.#e=e,this.#t=Math.min(Math.max(0,r),e.moments.
length-1),this.#l(),this.redraw()}redraw=()=>{this.#n||(this.#n=requestAnimationFrame(()=>this.drawNow()))};drawNow(){cancelAnimationFrame(this.#n),this.#n=0;let e=this.
canvas.getContext("2d");if(!e||!this.#e)return;let{rows:r,cols:n}=this.#e,o=devicePixelRatio||1;this.#o=Gt(r,n,this.#r.axes,this.canvas.width,this.canvas.height,
o);let s={ctx:e,grid:this.#o,colors:jt(this.canvas)};Bt(s,this.#e,this.#t,this.#r,o)}cellAt(e,r){let n=this.canvas.getBoundingClientRect(),o=this.canvas.width/n.
width;return zt(this.#o,(e-n.left)*o,(r-n.top)*o)}agentAt(e,r){let n=this.cellAt(e,r);if(!n||!this.#e)return null;let o=this.#e.moments[Math.round(this.#t)],s=j(
this.#e,o).get(n[0]*this.#e.cols+n[1])??[],a=le(this.#e,Math.round(this.#t)),i=l=>{let[c,d]=this.pointOf(a[l].x,a[l].y);return Math.hypot(c-e,d-r)};return s.length?
s.reduce((l,c)=>i(c)<i(l)?c:l):null}pointOf(e,r){let n=this.canvas.getBoundingClientRect(),o=n.width/this.canvas.width,{left:s,top:a,cell:i}=this.#o;return[n.left+
(s+e*i)*o,n.top+(a+r*i)*o]}#l(){if(!this.#e)return;let{rows:e,cols:r}=this.#e;this.canvas.style.setProperty("--board-aspect",String(Ht(e,r)))}#d(){let e=devicePixelRatio||
1,{width:r,height:n}=this.canvas.getBoundingClientRect();this.canvas.width=Math.max(1,Math.round(r*e)),this.canvas.height=Math.max(1,Math.round(n*e)),this.drawNow()}};var Zr={first:"M6 5v14M19 5 9 12l10 7z",back:"M17 5 7 12l10 7z",play:"M7 4.5 19 12 7 19.5z",pause:"M8 5v14M16 5v14",forward:"M7 5l10 7-10 7z",last:"M18 5v14M5 5\
l10 7-10 7z"};function Vt(t){let e=document.createElementNS("http://www.w3.org/2000/svg","svg");e.setAttribute("viewBox","0 0 24 24"),e.setAttribute("aria-hidde\
n","true"),e.classList.add("icon");let r=document.createElementNS("http://www.w3.org/2000/svg","path");return r.setAttribute("d",Zr[t]),e.append(r),e}function K(t,e,r,n){
let o=document.createElement("button");return o.type="button",o.className="player-button",o.append(Vt(t)),o.ariaLabel=e,o.title=`${e} (${r})`,o.addEventListener(
"click",n),o}function Kt(t){let e=document.createElement("div");e.className="player",e.role="group",e.ariaLabel="Player";let r=K("play","Play","Space",()=>t.toggle()),
n=en(t),o=tn(t),s=document.createElement("output");s.className="player-count",e.append(K("first","First step","Home",()=>t.move(-t.length)),K("back","Step back",
"←",()=>t.move(-1)),r,K("forward","Step forward","→",()=>t.move(1)),K("last","Last step","End",()=>t.move(t.length)),n,s,o);let a=()=>{r.replaceChildren(Vt(
t.playing?"pause":"play")),r.ariaLabel=t.playing?"Pause":"Play",r.title=`${r.ariaLabel} (Space)`,n.max=String(t.length),n.value=String(t.step),n.ariaValueText=`\
step ${t.step} of ${t.length}`,s.textContent=`${t.step} / ${t.length}`,s.style.minWidth=`${2*String(t.length).length+3}ch`,o.value=String(t.speed)};return t.addEventListener(
"step",a),t.addEventListener("state",a),e.addEventListener("keydown",i=>{!(i.target instanceof HTMLSelectElement||i.key===" "&&i.target!==n)&&Y(t,i)&&i.preventDefault()}),
a(),e}function en(t){let e=document.createElement("input");return e.type="range",e.className="player-scrub",e.min="0",e.step="1",e.ariaLabel="Step",e.addEventListener(
"input",()=>{t.pause(),t.jump(Number(e.value))}),e}function tn(t){let e=document.createElement("select");return e.className="player-speed",e.ariaLabel="Speed",e.
title="Steps a second (+ and -)",e.append(...F.map(r=>new Option(`${r} / s`,String(r)))),e.addEventListener("change",()=>{t.speed=Number(e.value)}),e}var w=(t,e=2)=>t==null?"-":t.toFixed(e);function qt(t,e,r,n=2){return e===null||r===null?t.toFixed(n):`${t.toFixed(n)} (${e.toFixed(n)} to ${r.toFixed(n)})`}var Xt=(t,e)=>t<e?`pursuer_${t}`:`evader_${t-e}`;function Jt(t,e,r){if(r===0)return[{kind:"start",text:rn(t),agents:[]}];let[n,o]=[e.moments[r-1],e.moments[r]],s=d=>Xt(d,t.config.n_pursuers),a=ae(e,n,o),i=t.conflicts(
r),l=new Set(i.flatMap(d=>d.doomed)),c=a.map(d=>({kind:"capture",text:`${s(d)} is captured`,agents:[d]}));for(let d of ie(n,o))!a.includes(d)&&!l.has(d)&&c.push(
{kind:"end",text:`${s(d)} disappears`,agents:[d]});return c.push(...i.map(({kind:d,text:m,agents:h})=>({kind:d,text:m,agents:h}))),r===t.length&&c.unshift({kind:"\
end",text:nn(t),agents:[]}),c}function rn({config:t}){return`${t.n_pursuers} pursuers and ${t.n_evaders} evaders on ${t.rows} x ${t.cols} cells, at most ${t.max_steps}\
 steps`}function nn(t){let e=Math.round(t.statistics.capture_rate*t.config.n_evaders);return`The episode ends after ${t.length} steps with ${e} of ${t.config.n_evaders}\
 evaders captured`}var sn={SIMULTANEOUS:0,SWARM_TURNS:1,AGENT_TURNS:2};function Yt(t,e,r){return{rows:t.rows,cols:t.cols,nPursuers:t.n_pursuers,fov:t.fov,interaction:sn[t.rules.interaction],
obstacles:e,moments:r}}function Ie(t,e){return{positions:t.read("last_positions"),alive:t.read("alive"),captured:t.read("captured"),everCaptured:t.read("ever_ca\
ptured"),actions:e,involved:t.read("involved"),fault:t.read("fault"),contested:t.conflicts().map(r=>r.cell)}}var de=class{#e;#t;#r;#o=new Map;#n=null;constructor(e){this.#e=e,this.#t=e.world.n_pursuers+e.world.n_evaders,this.#r=Math.floor(Math.log(256)/Math.log(e.n_actions));
let r=0;e.steps.forEach((n,o)=>n.forEach((s,a)=>{s<0||(this.#o.set(o*n.length+a,r),r+=Math.ceil(s*this.#t/this.#r))}))}has({pursuer:e,evader:r}){return this.#e.
steps[e][r]>=0}actions({pursuer:e,evader:r}){this.#n??=dt("recordings");let n=this.#o.get(e*this.#e.names.evader.length+r),o=s=>{let a=this.#n[n+Math.floor(s/this.#r)];
return Math.floor(a/this.#e.n_actions**(s%this.#r))%this.#e.n_actions};return Array.from({length:this.#e.steps[e][r]},(s,a)=>Uint8Array.from({length:this.#t},(i,l)=>o(
a*this.#t+l)))}play(e,r){let n=e.world(this.#e.world);n.reset({seed:BigInt(this.#e.match_seed),episode:0});let o=[Ie(n)],s=[[]];for(let l of this.actions(r))n.step(
l),s.push(n.conflicts()),o.push(Ie(n,l));let a={config:this.#e.world,length:o.length-1,statistics:{capture_rate:n.read("capture_rate")[0]},conflicts:l=>s[l]},i={
recording:Yt(this.#e.world,n.map(),o),told:a};return n.free(),i}};var ue=class{element;player=new J(0,{speed:8,still:Pe()});#e;#t;#r;#o;#n=u("h2",{class:"match-title"});#s=u("p",{class:"tally numbers"});#a=u("ol",{class:"words",
"aria-live":"off","aria-label":"What happened in this step"});#l=u("p",{class:"check small","aria-live":"polite"});#d=null;#i=null;constructor(e,r){[this.#e,this.#t,
this.#r]=[e,r,new de(e)];let n=u("canvas",{"aria-label":"The match"});this.#o=new ce(n,{numbers:!1}),this.element=u("section",{class:"card match-card","aria-lab\
el":"Match",id:"match"},u("header",{class:"match-head"},this.#n,this.#s),u("div",{class:"stage"},n),Kt(this.player),this.#l,this.#a),this.player.addEventListener(
"frame",()=>this.#i&&this.#o.show(this.#i.recording,this.player.time)),this.player.addEventListener("step",()=>this.#p()),r.on("pair",()=>this.#u()),r.on("play",
()=>this.#m()),this.#c()}get replay(){return this.#i}start(e){this.#d=e,this.#u()}#m(){this.#i&&(this.player.jump(0),Pe()||this.player.play(),this.element.scrollIntoView(
{block:"nearest"}))}#u(){this.player.pause(),this.#c();let{pair:e}=this.#t;this.#d&&(this.#i=this.#r.has(e)?this.#r.play(this.#d,e):null,this.element.dataset.played=
this.#i?`${e.pursuer} ${e.evader}`:"",this.element.classList.toggle("without-recording",!this.#i),this.player.length=this.#i?.told.length??0,this.player.jump(0),
this.#h(),this.#p())}#h(){let{pursuer:e,evader:r}=this.#t.pair;if(!this.#i){this.#l.textContent="The page holds no recording of this match: it would be too larg\
e.";return}let[n,o]=[this.#i.told.statistics.capture_rate,this.#e.first[e][r]],s=Math.abs(n-o)<.001;this.#l.dataset.equal=String(s),this.#l.textContent=s?`Episo\
de 1 of ${this.#e.episodes}: capture rate ${w(n)}, as in the tournament.`:`Episode 1 of ${this.#e.episodes}: capture rate ${w(n)}; the tournament had ${w(o)}.`}#c(){
let{pursuer:e,evader:r}=this.#t.pair;this.#n.replaceChildren(u("span",{class:"pursuer"},this.#e.names.pursuer[e])," against ",u("span",{class:"evader"},this.#e.
names.evader[r]))}#p(){if(!this.#i){this.#a.replaceChildren(),this.#s.replaceChildren();return}let{told:e,recording:r}=this.#i,n=this.player.step,o=Array.from(r.
moments[n].everCaptured).filter(Boolean).length;this.#s.replaceChildren(u("strong",{},o),` of ${this.#e.world.n_evaders} captured`,u("span",{class:"muted"},` · \
step ${n}`)),this.#a.replaceChildren(...Jt(e,r,n).map(s=>u("li",{class:s.kind},s.text)))}};var q=[[68,1,84],[72,26,108],[71,47,125],[65,68,135],[57,86,140],[49,104,142],[42,120,142],[35,136,142],[31,152,139],[34,168,132],[53,183,121],[84,197,104],[122,
209,81],[165,219,54],[210,226,27],[253,231,37]];function Qt(t){let e=Math.min(1,Math.max(0,t))*(q.length-1),r=Math.min(q.length-2,Math.floor(e)),[n,o]=[q[r],q[r+
1]],s=a=>Math.round(n[a]+(e-r)*(o[a]-n[a]));return[s(0),s(1),s(2)]}function Zt(t){let[e,r,n]=Qt(t).map(o=>((o/255+.055)/1.055)**2.4);return .2126*e+.7152*r+.0722*
n>.179?"#000":"#fff"}var er=t=>`rgb(${Qt(t).join(" ")})`,tr=()=>`linear-gradient(to right, ${q.map(t=>`rgb(${t.join(" ")})`).join(", ")})`;var an=1e3,ln=14,Le=16,cn=t=>t.length>Le?`${t.slice(0,Le-1)}…`:t,me=class{element;#e;#t;#r;#o;#n=u("p",{class:"readout numbers","aria-live":"polite"});#s=C("g",
{class:"marks"});#a;constructor(e,r){[this.#e,this.#t]=[e,r],this.#r=e.standings.pursuer.map(({number:n})=>n),this.#o=e.standings.evader.map(({number:n})=>n),this.#a=
this.#l(),this.element=u("section",{class:"card matrix-card","aria-label":"All matches"},u("header",{},u("h2",{},"All matches"),u("p",{class:"small muted"},"Cap\
ture rate; pursuers in rows, evaders in columns, the best ones first. Click a cell to watch its first episode.")),this.#a,u("div",{class:"scale-of-rates small"},
"0",dn(),"1"),this.#n),r.on("pair",()=>this.#p()),r.on("hover",()=>this.#p()),this.#p()}#l(){let[e,r]=[this.#r.length,this.#o.length],n=an/Math.max(e,r),o=Math.
min(26,Math.max(11,.78*n)),s=o*.56*Math.min(Le,un(this.#e))+10,a=C("svg",{class:"matrix",tabindex:"0",role:"img","aria-label":"Matrix of capture rates; arrow ke\
ys choose a match, Enter plays it",preserveAspectRatio:"xMidYMin meet",viewBox:`${-s} ${-s} ${r*n+s} ${e*n+s}`,onpointermove:l=>this.#t.point(this.#u(l,n)),onpointerleave:()=>this.#t.
point(null),onclick:l=>{let c=this.#u(l,n);c&&this.#t.play(c)},onkeydown:l=>this.#h(l)}),i=this.#r.flatMap((l,c)=>this.#o.map((d,m)=>{let h=this.#e.capture_rate[l][d];
return C("rect",{x:m*n,y:c*n,width:n,height:n,fill:er(h),"data-pair":`${l} ${d}`})}));return a.append(...i,...this.#d(n),...this.#i("pursuer",n,o),...this.#i("e\
vader",n,o),this.#s),this.#s.dataset.size=String(n),a}#d(e){return Math.max(this.#r.length,this.#o.length)>ln?[]:this.#r.flatMap((r,n)=>this.#o.map((o,s)=>{let a=this.#e.
capture_rate[r][o];return C("text",{x:(s+.5)*e,y:(n+.5)*e,fill:Zt(a),"font-size":Math.min(30,.32*e),class:"in-cell"},w(a))}))}#i(e,r,n){return(e==="pursuer"?this.#r:
this.#o).map((s,a)=>{let i=(a+.5)*r,l=e==="pursuer"?{x:-6,y:i,"text-anchor":"end"}:{transform:`translate(${i} -6) rotate(-90)`,"text-anchor":"start"};return C("\
text",{...l,class:`name ${this.#m(e,s).kind}`,"font-size":n,"data-name":`${e} ${s}`},cn(this.#e.names[e][s]))})}#m(e,r){return this.#e.standings[e].find(n=>n.number===
r)}#u(e,r){let n=new DOMPoint(e.clientX,e.clientY).matrixTransform(this.#a.getScreenCTM().inverse()),[o,s]=[this.#r[Math.floor(n.y/r)],this.#o[Math.floor(n.x/r)]];
return o===void 0||s===void 0||n.x<0||n.y<0?null:{pursuer:o,evader:s}}#h(e){let n={ArrowUp:[-1,0],ArrowDown:[1,0],ArrowLeft:[0,-1],ArrowRight:[0,1]}[e.key];if(e.
key==="Enter")this.#t.play(this.#t.pair);else if(n)this.#c(n);else return;e.preventDefault(),e.stopPropagation()}#c([e,r]){let{pursuer:n,evader:o}=this.#t.pair,
s=this.#r[this.#r.indexOf(n)+e],a=this.#o[this.#o.indexOf(o)+r];s!==void 0&&a!==void 0&&this.#t.select({pursuer:s,evader:a})}#p(){let{pair:e,hover:r}=this.#t,n=Number(
this.#s.dataset.size),o=({pursuer:a,evader:i},l)=>C("rect",{class:l,x:this.#o.indexOf(i)*n,y:this.#r.indexOf(a)*n,width:n,height:n});this.#s.replaceChildren(o(e,
"selected-halo"),o(e,"selected"),...r?[o(r,"hovered")]:[]);let s=r??e;for(let a of this.#a.querySelectorAll("[data-name]")){let i=[`pursuer ${s.pursuer}`,`evade\
r ${s.evader}`].includes(a.dataset.name);a.classList.toggle("about",i)}this.#n.replaceChildren(...this.#f(s))}#f({pursuer:e,evader:r}){let{names:n,capture_rate:o,
lowest:s,highest:a,length:i,episodes:l}=this.#e,c=qt(o[e][r],null,null),[d,m]=[w(s[e][r]),w(a[e][r])];return[u("span",{},u("span",{class:"pursuer"},n.pursuer[e]),
" against ",u("span",{class:"evader"},n.evader[r])),u("span",{},u("strong",{},c),u("span",{class:"small muted"},` captured; ${d} to ${m} in ${l} episodes, ${i[e][r].
toFixed(0)} steps on average`))]}};function dn(){let t=u("span",{class:"gradient"});return t.style.backgroundImage=tr(),t}var un=t=>Math.max(...[...t.names.pursuer,
...t.names.evader].map(e=>e.length));var rr=(t,e)=>t?.pursuer===e?.pursuer&&t?.evader===e?.evader,pe=class extends EventTarget{#e;#t=null;constructor(e){super(),this.#e=e}get pair(){return this.#e}get hover(){
return this.#t}select(e){rr(e,this.#e)||(this.#e=e,this.dispatchEvent(new Event("pair")))}play(e){this.select(e),this.dispatchEvent(new Event("play"))}point(e){
rr(e,this.#t)||(this.#t=e,this.dispatchEvent(new Event("hover")))}on(e,r){this.addEventListener(e,r)}};var nr={pursuer:"evader",evader:"pursuer"};function $e(t,e,r){let n=t.standings[e].map(a=>mn(t,e,a,r)),o=e==="pursuer"?"Mean capture rate":"Mean escape rate",s=[
"Rank","Name","Score","Best, worst"];return u("section",{class:"card standings","aria-label":`Standings of ${e}s`},u("header",{},u("h2",{},u("span",{class:e},`${e[0].
toUpperCase()}${e.slice(1)}s`)),u("p",{class:"small muted"},`${o} against ${t.names[nr[e]].length} opponents, with 95 % interval`)),u("div",{class:"scroll",tabindex:"\
0"},u("table",{},u("thead",{},u("tr",{},...s.map(a=>u("th",{scope:"col"},a)))),u("tbody",{},...n))))}function mn(t,e,r,n){let{kind:o,name:s,file:a,rank:i,number:l}=r,
c=u("tr",{class:o,"data-number":l},u("td",{class:"rank numbers"},i||"–"),u("th",{scope:"row",title:a},u("span",{class:"who",title:s},s),u("span",{class:"kind \
small muted"},o)),u("td",{class:"numbers score"},hn(r,e),pn(r)),u("td",{class:"matches"},...["best","worst"].map(m=>fn(t,e,r,m,n)))),d=()=>{c.classList.toggle("\
about",l===(n.hover??n.pair)[e])};return n.on("pair",d),n.on("hover",d),d(),c}function pn({score:t,low:e,high:r}){let n=e===null||r===null?"":`${w(e)} – ${w(r)}`;
return u("span",{class:"score-text"},u("strong",{},w(t)),u("span",{class:"small muted"},n))}function hn({score:t,low:e,high:r},n){let[o,s]=[u("span",{class:`fil\
led of-${n}`}),u("span",{class:"whisker"})];return o.style.width=`${100*t}%`,e!==null&&r!==null&&(s.style.left=`${100*e}%`,s.style.width=`${100*(r-e)}%`),u("spa\
n",{class:"bar","aria-hidden":"true"},o,s)}function fn(t,e,r,n,o){let s=r[n],a=e==="pursuer"?{pursuer:r.number,evader:s}:{pursuer:s,evader:r.number},i=t.names[nr[e]][s],
l=t.capture_rate[a.pursuer][a.evader],c=w(e==="pursuer"?l:1-l);return u("button",{type:"button",class:"to-match",title:`Watch the ${n} match: against ${i}, ${c}`,
"aria-label":`Watch the ${n} match of ${r.name}: against ${i}, ${c}`,onclick:()=>o.play(a)},n==="best"?"▲ ":"▼ ",i)}function or(t){if(!t.length)return[];let e=t.
map(({file:r,reason:n})=>u("div",{class:"refusal"},u("dt",{},r),u("dd",{},n)));return[u("section",{class:"card refused","aria-label":"Refused"},u("header",{},u(
"h2",{},`Refused (${t.length})`),u("p",{class:"small muted"},"These did not play, or broke a rule while they played; their matches count for no one.")),u("dl",{},
...e))]}var S=ut(),[yn]=S.standings.pursuer,he=new pe({pursuer:yn.number,evader:S.standings.evader[0].number}),D=new ue(S,he);function bn({world:t,episodes:e,seed:r,matrixworld:n}){
return`${t.n_pursuers} pursuers and ${t.n_evaders} evaders on ${t.rows} x ${t.cols} cells, at most ${t.max_steps} steps · ${e} episodes a pair · seed ${r} · m\
atrixworld ${n}`}var gn=["Every pursuer played every evader from the same starts. A score is a mean over all opponents, scripts included. Scripts are the packag\
e's own policies, for comparison; they have no rank.","A rank such as 2 to 5 means that these episodes cannot tell which of these ranks is the true one: the dif\
ference to some others is within chance. Each range misses the true rank with a probability of at most 5 %.","Triangles pursue, discs evade; a ring is a capture\
d evader, a star a capture, dashed cells are conflicts. Keys: Space plays, ← and → step, D changes light and dark; in the matrix arrow keys choose a match and E\
nter plays it."];document.getElementById("page").replaceWith(u("header",{class:"top"},u("div",{},u("h1",{},S.title),u("p",{class:"muted small about"},bn(S))),u(
"div",{class:"tools"},ct())),u("main",{class:"stages"},u("div",{class:"tables"},$e(S,"pursuer",he),$e(S,"evader",he)),new me(S,he).element,D.element),...or(S.refusals),
u("section",{class:"card reading","aria-label":"How to read this page"},u("h2",{},"How to read this page"),...gn.map(t=>u("p",{},t))));document.addEventListener(
"keydown",t=>{let e=t.target instanceof HTMLSelectElement||t.target instanceof HTMLInputElement,r=t.target instanceof HTMLButtonElement&&(t.key===" "||t.key==="\
Enter");if(!(e||r||t.defaultPrevented||t.ctrlKey||t.metaKey||t.altKey)){if(t.key.toLowerCase()==="d")Se();else if(!Y(D.player,t))return;t.preventDefault()}});Object.
assign(window,{matrixworldClass:{get replay(){return D.replay},get step(){return D.player.step}}});requestAnimationFrame(()=>setTimeout(()=>{it().then(t=>{D.start(
t),document.body.dataset.ready="true"},t=>{D.element.prepend(u("p",{class:"problem",role:"alert"},`The engine does not start here: ${String(t)}`)),document.body.
dataset.ready="true"})}));})();
