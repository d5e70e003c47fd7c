/* built from web/ by "npm run build"; sources 27a2d2756e30ba3fddef1b2015502ec619798da757d967374b7e6c2add76e1a2 */
"use strict";(()=>{var Tt={SIMULTANEOUS:0,SWARM_TURNS:1,AGENT_TURNS:2},ne={DISAPPEAR:0,REACH:1,BOUNCE:2},Ct={OCCUPATION:0,SURROUND:1},_t={FAULT:0,INVOLVED:1};var kt=["obstacle","teammate","adversary"],Je=["vertex","edge","chain"],Rt=["turn","kind","form","first","second","row","col","at_fault","held","doomed"],Ze=["p\
ursuer_{number}","evader_{number}"],$t={obstacle:"{first} ran into the obstacle or border at {cell}",vertex:"{first} and {second} both headed for {cell}",edge:"\
{first} and {second} meant to swap, {first} to {cell}",chain:"{first} headed for {cell}, where {second} had to stay"},oe={"both held":"both bounce","both doomed":"\
both disappear",held:"{agent} bounces",doomed:"{agent} disappears",none:"nobody is stopped"},Pt="{event}: {outcome}",Qe={random:"any action, all equally likely",
still:"always stays",chaser:"moves to where the nearest adversary in view is nearest",fleer:"moves to where the nearest adversary in view is farthest","clumsy-c\
haser":"a chaser that takes any action in half of the steps",hunter:"a chaser of the nearest adversary in view to which no teammate in view is nearer",surrounder:"\
a chaser of the nearest free cell beside an adversary without a teammate","clumsy-fleer":"a fleer that takes any action in half of the steps",dodger:"moves to w\
here all adversaries in view together are farthest"},Ot={free:".GS",blocked:"#@OTW"};var z=1+Rt.length;function se(e,t){return e.replace(/\{(\w+)\}/g,(r,n)=>String(t[n]))}function et(e,t){return e<t?se(Ze[0],{number:e}):se(Ze[1],{number:e-t})}function Rn(e,t){
let[r,n,o,s,a,i,l,...c]=Array.from(e),u=a<0?[s]:[s,a],[m,p,f]=c.map(w=>u.filter((S,b)=>w>>b&1)),g=u.map(w=>et(w,t)),h=se($t[a<0?"obstacle":Je[o]],{first:g[0],second:g[g.
length-1],cell:`(${i}, ${l})`}),v=se(Pt,{event:h,outcome:$n(u.length,p,f,t)});return{kind:kt[n],form:Je[o],agents:u,cell:[i,l],at_fault:m,held:p,doomed:f,turn:r,
text:v}}function $n(e,t,r,n){if(e===2&&t.length===2)return oe["both held"];if(e===2&&r.length===2)return oe["both doomed"];let o=s=>a=>se(oe[s],{agent:et(a,n)});
return[...t.map(o("held")),...r.map(o("doomed"))].join(", ")||oe.none}function Ee(e,t){let r=[];for(let n=0;n<e.length;n+=z)r.push(Rn(e.subarray(n+1,n+z),t));return r}var H=class extends Error{name="EngineError"};function M(e,t,r){let n=typeof r=="string"?`'${r}'`:typeof r=="object"?JSON.stringify(r):String(r);return new H(`${e}\
: expected ${t}, got ${n}`)}var V=class{bytes;constructor(t){this.bytes=t}},Nt=0,rt=[Uint8Array,Uint8Array,Int32Array,BigInt64Array,BigUint64Array,Float32Array,Float64Array],Lt=4,It=4,Pn=new TextEncoder,
On=new TextDecoder;function Ln(e){for(let t=rt.length-1;t>Nt;--t)if(e instanceof rt[t])return t;throw new TypeError("array: expected a typed array of the engine\
's numbers, got another")}function tt(e){return new Uint8Array(e.buffer,e.byteOffset,e.byteLength)}function In(e){return Pn.encode(`${e}\0`)}var nt=class{engine;addresses=[];constructor(t){
this.engine=t}copy(t){let r=this.engine._malloc(Math.max(t.length,1));if(r===0)throw new H("memory: expected room for the arguments, got none");return this.addresses.
push(r),this.engine.HEAPU8.set(t,r),r}text(t){return this.copy(In(t))}arrays(t){let r=Object.entries(t),n=r.flatMap(([s,a])=>{let i=a instanceof V,l=i?a.bytes:a;
return[this.text(s),i?Nt:Ln(l),l.length,this.copy(tt(l))]}),o=this.copy(tt(Int32Array.from(n)));return this.copy(tt(Int32Array.of(r.length,o)))}free(){for(let t of this.
addresses)this.engine._free(t)}};function Ut(e,t){let r=e.HEAPU8;return On.decode(r.subarray(t,r.indexOf(0,t)))}function Ae(e){let t=new Int32Array(e.HEAPU8.buffer),
r=e._last_outputs()/Lt,n=t[r+1]/Lt,o={};for(let s=n;s<n+t[r]*It;s+=It){let a=rt[t[s+1]],i=t[s+2]*a.BYTES_PER_ELEMENT,l=t[s+3];o[Ut(e,t[s])]=new a(e.HEAPU8.slice(
l,l+i).buffer)}return o}function ae(e,t){let r=new nt(e);try{let n=t(r);if(n===0)throw new H(Ut(e,e._last_error()));return n}finally{r.free()}}var Nn=2**31-1,Un=2n**64n-1n,Fn=34028234663852886e22;function L(e,t){if(typeof t!="number"||!Number.isInteger(t)||Math.abs(t)>Nn)throw M(e,"an integer",t);return Int32Array.
of(t)}function Te(e,t){if(typeof t!="boolean")throw M(e,"true or false",t);return new V(Uint8Array.of(Number(t)))}function D(e,t,r){let n=typeof t=="string"&&Object.
hasOwn(r,t)?r[t]:void 0;if(n===void 0)throw M(e,`one of ${Object.keys(r).join(", ")}`,t);return Int32Array.of(n)}function ot(e,t){if(typeof t!="number"||!(Math.
abs(t)<=Fn))throw M(e,"a finite number",t);return t}function K(e,t){let n=typeof t=="bigint"||typeof t=="number"&&Number.isSafeInteger(t)?BigInt(t):-1n;if(n<0n||
n>Un)throw M(e,"an integer from 0 to 2^64 - 1",t);return BigUint64Array.of(n)}function Hn(e){return{"rules.interaction":D("interaction",e.interaction,Tt),"rules\
.obstacle":D("obstacle",e.obstacle,ne),"rules.teammate":D("teammate",e.teammate,ne),"rules.evader":D("evader",e.evader,ne),"rules.pursuer":D("pursuer",e.pursuer,
ne),"rules.capture":D("capture",e.capture,Ct),"rules.captured_disappear":Te("captured_disappear",e.captured_disappear)}}function Ft(e,t){let r=typeof t=="number"?
[t,t,t]:t;if(!Array.isArray(r)||r.length!==3)throw M(e,"1 or 3 numbers",t);return Float32Array.from(r,n=>ot(e,n))}function Dn(e){let t=(r,n)=>Float32Array.of(ot(
r,e[r]),ot(n,e[n]));return{"rewards.capture":t("pursuer_capture","evader_capture"),"rewards.neighbor":t("pursuer_neighbor","evader_neighbor"),"rewards.step":t("\
pursuer_step","evader_step"),"rewards.pursuer_collide":Ft("pursuer_collide",e.pursuer_collide),"rewards.evader_collide":Ft("evader_collide",e.evader_collide),"r\
ewards.blame":D("blame",e.blame,_t),"rewards.capture_repeats":Te("capture_repeats",e.capture_repeats)}}function Dt(e){if(e===void 0||typeof e=="number")return new Uint8Array(
0);if(e instanceof Uint8Array)return e;let{free:t,blocked:r}=Ot;for(let[n,o]of e.entries()){if(o.length!==e[0]?.length)throw M(`map, row ${n}`,`${e[0]?.length} \
cells as in row 0`,o.length);let s=[...o].find(a=>!t.includes(a)&&!r.includes(a));if(s)throw M(`map, row ${n}`,`'${t}' (free) or '${r}' (obstacle)`,s)}return Uint8Array.
from([...e.join("")],n=>Number(r.includes(n)))}function Bt(e,t){if(!Array.isArray(e))return;let r=[e.length,e[0]?.length??0];if(!(r[0]===t.rows&&r[1]===t.cols))
throw M("obstacle map",`shape (${t.rows}, ${t.cols}), the rows and cols`,r)}function Ce(e){Bt(e.obstacles,e);let t=typeof e.obstacles=="number"?e.obstacles:0;return{
...Hn(e.rules),...Dn(e.rewards),rows:L("rows",e.rows),cols:L("cols",e.cols),n_pursuers:L("n_pursuers",e.n_pursuers),n_evaders:L("n_evaders",e.n_evaders),fov:L("\
fov",e.fov),diagonal:Te("diagonal",e.diagonal),max_steps:L("max_steps",e.max_steps),density:Float64Array.of(t),map:Dt(e.obstacles)}}function Ht(e,t){return Int32Array.
from((t??[]).flat(),r=>L(e,r)[0])}function Wt(e,t){return Bt(e.obstacles,t),{seed:K("seed",e.seed??0n),episode:K("episode",e.episode??0),pursuers:Ht("pursuers",
e.pursuers),evaders:Ht("evaders",e.evaders),map:Dt(e.obstacles)}}function _e(e){return{actions:Int32Array.from(e,t=>L("actions",t)[0])}}function Y(e){if(typeof e==
"string"){if(!Object.hasOwn(Qe,e))throw M("policy",`one of ${Object.keys(Qe).join(", ")}`,e);return{script:new TextEncoder().encode(e)}}if(e.activation!=="relu"&&
e.activation!=="tanh")throw M("activation","'relu' or 'tanh'",e.activation);return{hidden:Int32Array.from(e.hidden,t=>L("hidden",t)[0]),activation:new TextEncoder().
encode(e.activation),sampled:Te("sampled",e.sampled),genome:e.genome}}var Bn=["first_turn","terminated","truncated"];function jt(e){let t={...e};for(let r of Bn)
t[r]=new V(e[r]);return t}var ke=class{config;seed;episode;n_agents;statistics;positions;last_positions;alive;captured;ever_captured;actions;rewards;involved;fault;map;conflict_table;first_conflict;constructor(t,r,n,o){
this.config=t,this.seed=r,this.episode=n,this.n_agents=t.n_pursuers+t.n_evaders,this.statistics=Gt(o,0),this.positions=o.positions,this.last_positions=o.last_positions,
this.alive=o.alive,this.captured=o.captured,this.ever_captured=o.ever_captured,this.actions=o.actions,this.rewards=o.rewards,this.involved=o.involved,this.fault=
o.fault,this.map=o.map,this.conflict_table=o.conflict_table,this.first_conflict=Wn(this.conflict_table,this.length)}get length(){return this.actions.length/this.
n_agents}conflicts(t){this.check(t);let[r,n]=[this.first_conflict[t],this.first_conflict[t+1]],o=this.conflict_table.subarray(r*z,n*z);return Ee(o,this.config.n_pursuers)}seek(t,r){
this.check(r),(!(t.seed===this.seed&&t.episode===BigInt(this.episode))||t.turn!==0||t.steps>r)&&t.reset({seed:this.seed,episode:this.episode});for(let o=t.steps;o<
r;++o)t.step(this.actions.subarray(o*this.n_agents,(o+1)*this.n_agents))}check(t){if(!(Number.isInteger(t)&&t>=0&&t<=this.length))throw M("step",`0 to ${this.length}`,
t)}};function Wn(e,t){let r=new Int32Array(t+2);for(let n=0;n<e.length;n+=z)++r[e[n]+1];for(let n=1;n<r.length;++n)r[n]+=r[n-1];return r}function Gt(e,t){let r=e["\
statistics.length"].length,n=s=>{let a=e[`statistics.${s}`],i=a.length/r;return a.slice(t*i,(t+1)*i)},o=s=>Number(n(s)[0]);return{capture_rate:o("capture_rate"),
ever_capture_rate:o("ever_capture_rate"),captured_fraction:o("captured_fraction"),length:o("length"),return:n("return"),survivors:n("survivors"),overlap:n("over\
lap"),collisions:n("collisions"),faults:n("faults"),agent_steps:n("agent_steps")}}function zt(e,t,r,n){let o=[Ce(r.config),Y(r.pursuers),Y(r.evaders),n];return ae(
e,s=>{let[a,i,l,c]=o.map(u=>s.arrays(u));return e[t](a,i,l,c)}),Ae(e)}function Vt(e,t,r,n){let o={seed:K("seed",r),episode:K("episode",n)};return new ke(t.config,
r,n,zt(e,"_play_match",t,o))}function Kt(e,t,r,n){if(!Number.isInteger(n)||n<1)throw M("n_episodes","at least 1",n);let o={seed:K("seed",r),n_episodes:Int32Array.
of(n)},s=zt(e,"_play_rollout",t,o);return Array.from({length:n},(a,i)=>Gt(s,i))}var Yt=new FinalizationRegistry(([e,t])=>e._world_free(t)),ie=class{config;n_agents;n_actions;engine;at;freed=!1;constructor(t,r){this.engine=t,this.config=r,this.
n_agents=r.n_pursuers+r.n_evaders,this.n_actions=r.diagonal?9:5,this.at=ae(t,n=>t._world_new(n.arrays(Ce(r)))),Yt.register(this,[t,this.at],this)}free(){this.freed||
(this.freed=!0,Yt.unregister(this),this.engine._world_free(this.at))}reset(t={}){let r=Wt(t,this.config);this.call(n=>this.engine._world_reset(this.at,n.arrays(
r)))}step(t){let r=_e(t);this.call(n=>this.engine._world_step(this.at,n.arrays(r)))}playTurn(t){let r=_e(t);this.call(n=>this.engine._world_play_turn(this.at,n.
arrays(r)))}decide(t,r,n){let{n_pursuers:o}=this.config,s=r==="pursuer"?[0,o]:[o,this.n_agents];return this.choose(t,s,n)}choose(t,[r,n],o){if(o.length!==this.n_agents)
throw M("actions",String(this.n_agents),o.length);let s=[Y(t),_e(o)],{actions:a}=this.call(i=>this.engine._world_decide(this.at,i.arrays(s[0]),r,n,i.arrays(s[1])));
return Uint8Array.from(a)}get n_turns(){return this.turnNumbers()[1]}get turn(){return this.turnNumbers()[0]}get actors(){let[,,t,r]=this.turnNumbers();return[t,
r]}turnNumbers(){return this.call(()=>this.engine._world_turn(this.at)).turn}get steps(){return this.read("steps")[0]}get seed(){return this.read("seed")[0]}get episode(){
return this.read("episode")[0]}get over(){return this.read("terminated")[0]===1||this.read("truncated")[0]===1}read(t){return this.call(r=>this.engine._world_read(
this.at,r.text(t)))[t]}view(t){let r=3*this.config.fov**2;return this.read("views").slice(t*r,(t+1)*r)}map(){return this.read("state").slice(2*this.config.rows*
this.config.cols)}conflicts(){let{conflict_table:t}=this.call(()=>this.engine._world_conflicts(this.at));return Ee(t,this.config.n_pursuers)}answer(t,r){let n=Y(
t),{logits:o}=this.call(i=>this.engine._world_logits(this.at,i.arrays(n),r)),s=o,a=this.choose(t,[r,r+1],new Uint8Array(this.n_agents))[r];return{logits:s,probabilities:jn(
s),action:a}}snapshot(){return this.call(()=>this.engine._world_snapshot(this.at))}restore(t){let r=jt(t);this.call(n=>this.engine._world_restore(this.at,n.arrays(
r)))}call(t){if(this.freed)throw M("world","one that is in use","one that was freed");return ae(this.engine,t),Ae(this.engine)}};function jn(e){let t=Math.max(...e),
r=Array.from(e,o=>Math.exp(o-t)),n=r.reduce((o,s)=>o+s,0);return Float32Array.from(r,o=>o/n)}var st=class{compiled;constructor(t){this.compiled=t}world(t){return new ie(this.compiled,t)}match(t,r,n,o,s=0){return Vt(this.compiled,{config:t,pursuers:r,evaders:n},
o,s)}rollout(t,r,n,o,s){return Kt(this.compiled,{config:t,pursuers:r,evaders:n},o,s)}},qt;function Xt(e=globalThis.matrixworldEngine){return qt??=Gn(e),qt}async function Gn(e){
if(!e)throw new Error("matrixworldEngine: expected the script engine.js before this one, got none");let t=Uint8Array.from(atob(e.binary),r=>r.charCodeAt(0));return new st(
await e({wasmBinary:t}))}var zn="http://www.w3.org/2000/svg";function d(e,t={},...r){return Jt(document.createElement(e),t,r)}function y(e,t={},...r){return Jt(document.createElementNS(
zn,e),t,r)}function Jt(e,t,r){for(let[n,o]of Object.entries(t))o==null||o===!1||(typeof o=="function"?e.addEventListener(n.slice(2),o):e.setAttribute(n,o===!0?"":
String(o)));return e.append(...r.filter(Vn).map(n=>typeof n=="number"?String(n):n)),e}function Vn(e){return e!=null&&e!==!1}var Kn=matchMedia("(prefers-color-scheme: dark)");function Yn(){let e=document.documentElement.dataset.theme;return e?e==="dark":Kn.matches}function at(){document.
documentElement.dataset.theme=Yn()?"light":"dark"}function Zt(){return d("button",{type:"button",title:"Light or dark (D)","aria-label":"Light or dark",onclick:at},"◐")}var qn=2n**64n-1n;function it(e,t,r){let n=new URLSearchParams(e.replace(/^#/,"")),o=(c,u,m)=>{let p=n.get(c)??"";return/^\d{1,9}$/.test(p)&&Number(p)<u?Number(
p):m},s=o("run",t.length,r.run),[a,i]=t[s].payoff.shape,l=n.get("seed")??"";return{run:s,pursuer:o("pursuers",a,Math.min(r.pursuer,a-1)),evader:o("evaders",i,Math.
min(r.evader,i-1)),episode:o("episode",1/0,r.episode),seed:/^\d{1,20}$/.test(l)&&BigInt(l)<=qn?l:null,step:o("step",1/0,0)}}function Qt(e,t,r){let n="",o=()=>{let{
run:s,pursuer:a,evader:i,episode:l,seed:c}=t.selected,u={run:s,pursuers:a,evaders:i,episode:l,...c===null?{}:{seed:c},step:r.player.step};n=`#${Object.entries(u).
map(([m,p])=>`${m}=${p}`).join("&")}`;try{history.replaceState(null,"",n)}catch{}};t.on("match",o),r.player.addEventListener("state",()=>r.player.playing||o()),
r.player.addEventListener("step",()=>r.player.playing||o()),window.addEventListener("hashchange",()=>{if(location.hash===n)return;let{step:s,...a}=it(location.hash,
e,t.selected);t.select(a),r.goTo(s)})}var tr=["pursuer","evader"];function rr(){return JSON.parse(Re("data"))}function le(e,t,r){let[n,o]=[t-e.payoff.first[0],r-e.payoff.first[1]],s=e.payoff.capture_rate[n]?.[o];
return s===void 0?null:{rate:s,rates:e.payoff.capture_rates[n][o],lengths:e.payoff.lengths[n][o]}}function ce(e,t,r){let{script:n,network:o,kept:s,genomes:a}=e.
teams[t];if(n!==null||o===null)return"";if(!s.includes(r))return`The page holds no genome of ${t}s ${r}: it would be too large. Choose a generation of ${s.join(
", ")}.`;let i=s.length*o.genome_size;return nr(a).length===i?"":`The page is damaged: it does not hold the ${i} numbers of the ${t}s' genomes. Write it again f\
rom its run.`}function de(e,t,r){let{script:n,network:o,kept:s,genomes:a}=e.teams[t];if(n!==null||o===null)return n??"random";let i=s.indexOf(r);if(i<0)throw new RangeError(
`${t}: expected a generation whose genome the page holds, got ${r}`);let l=o.genome_size,c=nr(a).subarray(i*l,(i+1)*l);return{hidden:o.hidden,activation:o.activation,
sampled:o.sampled,genome:c}}var er=new Map;function nr(e){let t=er.get(e);if(t)return t;let r=new Float32Array;try{let n=new Float32Array(lt(e).buffer);n.every(
Number.isFinite)&&(r=n)}catch(n){if(!(n instanceof DOMException||n instanceof RangeError))throw n}return er.set(e,r),r}function lt(e){let t=atob(Re(e)),r=new Uint8Array(
t.length);for(let n=0;n<r.length;n++)r[n]=t.charCodeAt(n);return r}function Re(e){return document.getElementById(e)?.textContent??""}var Xn={now:()=>performance.now(),request:e=>requestAnimationFrame(e),cancel:e=>cancelAnimationFrame(e)},ue=[.5,1,2,4,8,16,32,64],X=0,ct=12,Jn=2,q=class extends EventTarget{#e;#n;#s;#a;#r=0;#t=0;#o=!1;#c=null;#m=0;#i=[];glide=.28;constructor(t,r={}){
super(),this.#e=t,this.#n=r.speed??4,this.#a=r.still??!1,this.#s=r.clock??Xn}get step(){return this.#r}get time(){return this.#a?this.#r:this.#t}get arrived(){return this.#t===
this.#r}get playing(){return this.#o}get length(){return this.#e}set length(t){this.#e=t,this.#r>t&&this.jump(t),this.#u("state")}get marks(){return this.#i}set marks(t){
this.#i=t,this.#u("state")}get pace(){return this.#n||Math.max(Jn,this.#e/ct)}get speed(){return this.#n}set speed(t){this.#n=t,this.#u("state")}changeSpeed(t){
let r=ue.findIndex(n=>n>=this.pace);this.speed=ue[Math.min(ue.length-1,Math.max(0,r+t))]}play(){this.#o||!this.#e||(this.#r===this.#e&&this.jump(0),this.#o=!0,this.#u(
"state"),this.#l())}pause(){this.#o&&(this.#o=!1,this.#u("state"))}toggle(){this.#o?this.pause():this.play()}move(t){this.pause();let r=Math.min(this.#e,Math.max(
0,this.#r+t));Math.abs(r-this.#t)>1?this.jump(r):this.#d(r),this.#l()}jump(t){this.#t=Math.min(this.#e,Math.max(0,Math.round(t))),this.#d(this.#t),this.#u("fram\
e")}#d(t){t!==this.#r&&(this.#r=t,this.#u("step"),this.#a&&this.#u("frame"))}#l(){this.#c===null&&(this.#m=this.#s.now(),this.#c=this.#s.request(()=>this.#p()))}#p(){
this.#c=null;let t=this.#s.now();this.#h(Math.min(.25,(t-this.#m)/1e3)),this.#m=t,(!this.#a||this.arrived)&&this.#u("frame"),(this.#o||this.#t!==this.#r)&&(this.#c=
this.#s.request(()=>this.#p()))}#h(t){let r=t;for(;r>0;){if(this.#t===this.#r){if(!this.#o)return;if(this.#r===this.#e)return this.pause();this.#d(this.#r+1)}let n=this.#o?
this.pace:1/this.glide,o=this.#r-this.#t,s=Math.min(Math.abs(o),r*n);r-=s/n,this.#t=s===Math.abs(o)?this.#r:this.#t+Math.sign(o)*s}this.#o&&this.#t===this.#e&&this.
pause()}#u(t){this.dispatchEvent(new Event(t))}};function J(e,t){if(t.ctrlKey||t.metaKey||t.altKey)return!1;let r=t.shiftKey?10:1,o={" ":()=>e.toggle(),ArrowRight:()=>e.
move(r),ArrowLeft:()=>e.move(-r),Home:()=>e.move(-e.length),End:()=>e.move(e.length),"+":()=>e.changeSpeed(1),"-":()=>e.changeSpeed(-1)}[t.key];return o?.(),o!==
void 0}var me=[[68,1,84],[72,26,108],[71,47,125],[65,68,135],[57,86,140],[49,104,142],[42,120,142],[35,136,142],[31,152,139],[34,168,132],[53,183,121],[84,197,104],[122,
209,81],[165,219,54],[210,226,27],[253,231,37]];function Z(e){let t=Math.min(1,Math.max(0,e))*(me.length-1),r=Math.min(me.length-2,Math.floor(t)),[n,o]=[me[r],me[r+
1]],s=a=>Math.round(n[a]+(t-r)*(o[a]-n[a]));return[s(0),s(1),s(2)]}function or(e){let[t,r,n]=Z(e).map(o=>((o/255+.055)/1.055)**2.4);return .2126*t+.7152*r+.0722*
n>.179?"#000":"#fff"}var sr=e=>`rgb(${Z(e).join(" ")})`,ar=()=>`linear-gradient(to right, ${me.map(e=>`rgb(${e.join(" ")})`).join(", ")})`;function $e(e,t,r){let n=devicePixelRatio||1;e.style.left=`${r.left}px`,e.style.top=`${r.top}px`,e.style.width=`${r.width}px`,e.style.height=`${r.height}px`,e.width=
Math.round(r.width*n),e.height=Math.round(r.height*n);let o=e.getContext("2d"),s=Zn(t);!o||!s||(o.imageSmoothingEnabled=!1,o.drawImage(s,0,0,e.width,e.height))}
function Zn(e){let[t,r]=e.shape,n=document.createElement("canvas");[n.width,n.height]=[r,t];let o=n.getContext("2d");if(!o)return null;let s=o.createImageData(r,
t);return e.capture_rate.forEach((a,i)=>a.forEach((l,c)=>{let u=4*((t-1-i-e.first[0])*r+c+e.first[1]);s.data.set([...Z(l),255],u)})),o.putImageData(s,0,0),n}var Qn=84;function ir(e,t){let r=e.map((s,a)=>eo(s,a,t)),n=d("nav",{class:"races","aria-label":"Runs"},...r.map(s=>s.button)),o=()=>r.forEach((s,a)=>s.update(a===
t.selected.run));return t.on("match",o),t.on("hover",o),o(),n.hidden=e.length<2,n}function eo(e,t,r){let[n,o]=e.payoff.shape,s=!e.name.startsWith(e.schedule),a=Qn/
Math.max(n,o),i=d("canvas",{"aria-hidden":"true"});$e(i,e.payoff,{left:0,top:0,width:o*a,height:n*a});let l=d("span",{class:"place"}),c=d("button",{type:"button",
class:"race",title:`${e.name} (key ${t+1})`,onclick:()=>dt(e,t,r)},d("span",{class:"small-matrix"},i,l),d("span",{class:"race-text"},d("strong",{},s?e.name:e.schedule),
d("span",{class:"small"},e.findings?e.findings.headline:`${e.learning.join(" and ")}s against ${to(e)}`),d("span",{class:"small muted"},`${s?`${e.schedule}, `:""}\
seed ${e.seed}`)));return{button:c,update:m=>{c.setAttribute("aria-current",String(m));let p=r.hover.pursuer??r.selected.pursuer,f=r.hover.evader??r.selected.evader;
l.hidden=p>=n||f>=o,l.style.left=`${(f+.5)*a}px`,l.style.top=`${(n-p-.5)*a}px`}}}var to=e=>e.teams.pursuer.script??e.teams.evader.script??"another run";function dt(e,t,r){
let[n,o]=e.payoff.shape,{pursuer:s,evader:a}=r.selected;r.select({run:t,pursuer:Math.min(s,n-1),evader:Math.min(a,o-1)})}var ro=[[["Space"],"play or pause"],[["←","→"],"step back or forward; with Shift ten steps"],[["Home","End"],"first or last step"],[["+","−"],"faster or s\
lower"],[["N"],"next episode of the same pair; with Shift the one before"],[["R"],"another seed, not one of the evaluation"],[["O"],"the cell's own seed again"],
[["P"],"next pursuer generation; with Shift the one before"],[["E"],"next evader generation; with Shift the one before"],[["M"],"to the matrix: arrow keys choos\
e a match, Enter plays it"],[["A"],"next agent: what it sees; with Shift the one before"],[["Esc"],"no agent"],[["G"],"this step in the playground: any other ru\
les, actions and places"],[["1","9"],"first to ninth run"],[["D"],"light or dark"],[["?"],"this list"]];function lr(){let e=ro.map(([r,n])=>d("div",{class:"key-\
row"},d("dt",{},...r.map(o=>d("kbd",{},o))),d("dd",{},n))),t=d("dialog",{class:"help","aria-labelledby":"help-title"},d("h2",{id:"help-title"},"Keys"),d("dl",{class:"\
keys"},...e),d("p",{class:"muted small"},"The page holds the genomes and the engine of this run. A click on a cell plays that very match: same seed, same moves.\
 The page loads nothing from elsewhere; share the file as it is."),d("button",{type:"button",onclick:()=>t.close()},"Close"));return t.addEventListener("click",
r=>r.target===t&&t.close()),t}function cr(e,t,r,n,o){let s=(i,l)=>()=>{let c=e[t.selected.run].payoff.shape[i==="pursuer"?0:1];t.select({[i]:Math.min(c-1,Math.max(
0,t.selected[i]+l))})},a={n:()=>t.select({episode:t.selected.episode+1}),N:()=>t.select({episode:Math.max(0,t.selected.episode-1)}),r:()=>t.select({seed:String(
crypto.getRandomValues(new BigUint64Array(1))[0]),episode:0}),o:()=>t.select({seed:null,episode:0}),p:s("pursuer",1),P:s("pursuer",-1),e:s("evader",1),E:s("evad\
er",-1),m:()=>document.getElementById("matrix")?.focus(),a:()=>r.inspector.next(1),A:()=>r.inspector.next(-1),Escape:()=>r.inspector.choose(null),g:o,d:at,"?":()=>n.
showModal()};document.addEventListener("keydown",i=>{let l=i.target instanceof HTMLSelectElement||i.target instanceof HTMLInputElement,c=i.target instanceof HTMLButtonElement&&
(i.key===" "||i.key==="Enter");if(document.querySelector("dialog[open]")||l||c||i.defaultPrevented||i.ctrlKey||i.metaKey||i.altKey)return;let u=a[i.key]??a[i.key.
toLowerCase()],m=Number(i.key)-1;if(J(r.player,i)||u)u?.();else if(e[m])dt(e[m],m,t);else return;i.preventDefault()})}var ut=[[0,0],[-1,0],[0,1],[1,0],[0,-1],[-1,1],[1,1],[1,-1],[-1,-1]],B=(e,t)=>t<e.nPursuers,E=(e,t)=>[e.positions[2*t],e.positions[2*t+1]],no=(e,t)=>e[0]===t[0]&&
e[1]===t[1],mt=({rows:e,cols:t},[r,n])=>r>=0&&n>=0&&r<e&&n<t,pt=(e,t,r=3)=>e!==void 0&&[0,1,2].slice(0,r).some(n=>e[3*t+n]),ht=(e,t)=>pt(e.fault,t),dr=(e,t)=>!ht(
e,t)&&pt(e.involved,t,2);function Pe(e,t,r){let n=!no(E(e,r),E(t,r)),o=t.involved===void 0||pt(t.involved,r);return!!(t.alive[r]&&t.actions?.[r]&&!n&&o)}function Oe(e,t,r){
let[n,o]=E(e,r),[s,a]=ut[t.actions?.[r]??0];return[n+s,o+a]}function pe(e,t,r){return Array.from({length:r.everCaptured.length},(o,s)=>s).filter(o=>r.everCaptured[o]&&
!t.everCaptured[o]).map(o=>e.nPursuers+o)}var ur=e=>e.moments.flatMap((t,r)=>r&&pe(e,e.moments[r-1],t).length?[r]:[]);function Le(e,t){return Array.from({length:t.
alive.length},(n,o)=>o).filter(n=>e.alive[n]&&!t.alive[n])}var mr=[-.31,0,.31],pr=[{size:1,at:[[0,0]]},{size:.62,at:[[-.2,.2],[.2,-.2]]},{size:.54,at:[[-.23,.22],[.23,.22],[0,-.22]]},{size:.54,at:[[-.23,.23],[.23,.23],[
-.23,-.23],[.23,-.23]]},{size:.36,at:mr.flatMap(e=>mr.map(t=>[t,e]))}],oo=.3,so=.35,ao=.55;function he(e,t){let r=new Map;for(let n=0;n<t.alive.length;n++){if(!t.
alive[n])continue;let[o,s]=E(t,n),a=o*e.cols+s,i=r.get(a);i?i.push(n):r.set(a,[n])}return r}function hr(e,t){let r=Array.from(t.alive,(n,o)=>{let[s,a]=E(t,o);return{
x:a+.5,y:s+.5,size:1,alpha:0}});for(let n of he(e,t).values()){let o=pr[Math.min(n.length,pr.length)-1];n.forEach((s,a)=>{let[i,l]=o.at[Math.min(a,o.at.length-1)],
c=r[s];c.x+=i,c.y+=l,c.size=o.size,c.alpha=1})}return r}var fr=e=>e*e*(3-2*e),Q=(e,t,r)=>e+(t-e)*r,gr=e=>Math.min(1,Math.max(0,e));function yr(e,t,r,n){let o={1:2,
2:r}[e.interaction]??1;if(o===1)return fr(n);let s=o===r?t:+!B(e,t),a=Math.max(1/o,so);return fr(gr((n-s/(o-1)*(1-a))/a))}function Ie(e,t){let r=e.moments.length-
1,n=Math.min(Math.floor(t),r),o=e.moments[n],s=hr(e,o);if(n===r||t===n)return s;let a=e.moments[n+1],i=hr(e,a);return s.map((l,c)=>{let u=yr(e,c,s.length,t-n);return io(
o,a,c,l,i[c],u)})}function br(e,t,r){let n=e.moments.length-1,o=Math.min(Math.floor(r),n),[s,a]=[e.moments[o],e.moments[Math.min(o+1,n)]],i=yr(e,t,s.alive.length,
r-o),[[l,c],[u,m]]=[E(s,t),E(a,t)];return[Q(c,m,i)+.5,Q(l,u,i)+.5]}function io(e,t,r,n,o,s){let a=n.alpha>o.alpha,i={x:Q(n.x,o.x,s),y:Q(n.y,o.y,s),size:a?n.size:
Q(n.size,o.size,s),alpha:a?gr((1-s)/(1-ao)):Q(n.alpha,o.alpha,s)};if(Pe(e,t,r)){let[l,c]=E(e,r),[u,m]=Oe(e,t,r),p=oo*Math.sin(Math.PI*s);i.x+=(m-c)*p,i.y+=(u-l)*
p}return i}var vr=2*Math.PI;function W(e,t,r,n){e.beginPath(),e.arc(t,r,n/2,0,vr)}function Ne(e,t,r,n){let o=n/2,s=[[0,-.97],[.97,.83],[-.97,.83]].map(([a,i])=>[t+a*o,r+i*
o]);e.beginPath(),e.moveTo((s[2][0]+s[0][0])/2,(s[2][1]+s[0][1])/2),s.forEach(([a,i],l)=>{let[c,u]=s[(l+1)%3];e.arcTo(a,i,c,u,n*.09)}),e.closePath()}function wr(e,t,r,n){
let o=n*.32;e.beginPath(),e.moveTo(t-o,r-o),e.lineTo(t+o,r+o),e.moveTo(t+o,r-o),e.lineTo(t-o,r+o)}function xr(e,t,r,n){e.beginPath();for(let o=0;o<16;o++){let s=n/
2*(o%2?.6:.95),a=vr*o/16;e.lineTo(t+s*Math.sin(a),r-s*Math.cos(a))}e.closePath()}function Sr(e,t,r,n,o,s){let a=Math.atan2(o-r,n-t);e.beginPath(),e.moveTo(t,r),
e.lineTo(n,o);for(let i of[-1,1])e.moveTo(n,o),e.lineTo(n-s*Math.cos(a+i*.6),o-s*Math.sin(a+i*.6))}var Mr=4,lo=1.6,co=.95,uo=5,mo=.16,po=9,ho=.09,fo=.2,Er=.75,R=(e,t)=>e.left+t*e.cell,$=(e,t)=>e.top+t*e.cell;function ee(e,t,r){return B(t,r)?e.colors.pursuer:e.
colors.evader}function Ar({ctx:e,grid:t,colors:r}){let{left:n,top:o,cell:s,rows:a,cols:i}=t,[l,c]=[i*s,a*s];if(e.fillStyle=r.paper,e.fillRect(n,o,l,c),s<uo)return;
e.fillStyle=r.line;let u=Math.max(1,Math.round(s/60));for(let m=1;m<i;m++)e.fillRect(n+m*s,o,u,c);for(let m=1;m<a;m++)e.fillRect(n,o+m*s,l,u)}function Tr({ctx:e,
grid:t,colors:r},n){let{left:o,top:s,cell:a,rows:i,cols:l}=t;e.fillStyle=r.obstacle;for(let u=0;u<i*l;u++){if(!n.obstacles[u])continue;let[m,p]=[Math.floor(u/l),
u%l];e.fillRect(o+p*a,s+m*a,a,a)}let c=Math.min(5,Math.max(2,Math.round(a/18)));e.strokeStyle=r.frame,e.lineWidth=c,e.strokeRect(o-c/2,s-c/2,l*a+c,i*a+c)}function Cr({
ctx:e,grid:t,colors:r},n){let{left:o,top:s,cell:a,rows:i,cols:l}=t,c=a<24*n?5:1;e.font=`500 ${Math.round(Math.min(15*n,Math.max(9*n,a*.32)))}px system-ui, sans-\
serif`,e.fillStyle=r.muted,e.textBaseline="alphabetic",e.textAlign="center";let u=5*n+a/40;for(let m=0;m<l;m+=c)e.fillText(String(m),o+(m+.5)*a,s-u);e.textAlign=
"right",e.textBaseline="middle";for(let m=0;m<i;m+=c)e.fillText(String(m),o-u,s+(m+.5)*a)}function _r(e,t,r,n,o){let{ctx:s,grid:a}=e,i=Math.floor(t.fov/2)+.5,[l,
c]=[Math.max(0,n-i),Math.min(a.cols,n+i)],[u,m]=[Math.max(0,o-i),Math.min(a.rows,o+i)],p=[R(a,l),$(a,u),(c-l)*a.cell,(m-u)*a.cell],f=ee(e,t,r);s.globalAlpha=.11,
s.fillStyle=f,s.fillRect(...p),s.globalAlpha=.8,s.strokeStyle=f,s.lineWidth=Math.max(1,a.cell/24),s.strokeRect(...p),s.globalAlpha=1}function kr(e,t,r,n,o){let{
ctx:s,grid:a}=e,i=Math.min(Math.ceil(r),t.moments.length-1),l=t.moments[i];s.lineCap="round",s.lineWidth=Math.min(po,Math.max(1,a.cell*mo));for(let c=Math.max(1,
Math.floor(r-n)+1);c<=i;c++){let[u,m]=[t.moments[c-1],t.moments[c]],p=Math.max(0,Math.min(1,(r-c)/n));s.globalAlpha=Er+(fo-Er)*p;for(let f=0;f<m.alive.length;f++){
let g=c===i&&r<i;if(!u.alive[f]||!(l.alive[f]||g))continue;let h=(B(t,f)?-1:1)*ho,[v,w]=E(u,f),[S,b]=E(m,f);if(v===S&&w===b)continue;let x=g?o[f].x:b+.5,C=g?o[f].
y:S+.5;s.strokeStyle=ee(e,t,f),s.beginPath(),s.moveTo(R(a,w+.5+h),$(a,v+.5+h)),s.lineTo(R(a,x+h),$(a,C+h)),s.stroke()}}s.globalAlpha=1}function Rr(e,t,r){let n=Math.
min(Math.ceil(r),t.moments.length-1);for(let o=Math.max(1,n-Mr+1);o<=n;o++){let[s,a]=[t.moments[o-1],t.moments[o]],i=o>r?Math.max(0,1-2*(o-r)):1-(r-o)/Mr,l=pe(t,
s,a);for(let c of Le(s,a))l.includes(c)||yo(e,E(a,c),i);for(let c of l)go(e,E(a,c),i)}e.ctx.globalAlpha=1}function go({ctx:e,grid:t,colors:r},[n,o],s){e.globalAlpha=
s,xr(e,R(t,o+.5),$(t,n+.5),Math.max(8,t.cell*lo)),e.fillStyle=r.capture,e.fill(),e.strokeStyle=r.ink,e.lineWidth=Math.max(1,t.cell/36),e.lineJoin="round",e.stroke()}
function yo({ctx:e,grid:t,colors:r},[n,o],s){e.globalAlpha=s,wr(e,R(t,o+.5),$(t,n+.5),Math.max(7,t.cell*co)),e.strokeStyle=r.collision,e.lineWidth=Math.max(2,t.
cell*.17),e.lineCap="round",e.stroke()}function $r({ctx:e,grid:t,colors:r},n,o){let s=Math.max(1,t.cell*.07);e.strokeStyle=e.fillStyle=r.collision,e.lineWidth=Math.
max(1,t.cell*.05),e.setLineDash([t.cell*.14,t.cell*.1]);for(let[a,i]of n){if(a<0||i<0||a>=t.rows||i>=t.cols)continue;let l=[R(t,i)+s,$(t,a)+s,t.cell-2*s,t.cell-
2*s];e.globalAlpha=.2*o,e.fillRect(...l),e.globalAlpha=o,e.strokeRect(...l)}e.setLineDash([]),e.globalAlpha=1}function Pr({ctx:e,grid:t,colors:r},n,o,s,a){e.globalAlpha=
a,W(e,R(t,n),$(t,o),Math.max(8,t.cell*s*1.02)),e.strokeStyle=r.collision,e.lineWidth=Math.max(1.5,t.cell*.085*Math.sqrt(s)),e.stroke(),e.globalAlpha=1}var bo=.8,vo=.92,wo=15,xo=7,yt=9;function Or(e,t,r,n,o,s){n.forEach((a,i)=>{a.alpha>0&&So(e,t,r,i,a,o,s)}),e.ctx.globalAlpha=1;for(let a of he(t,r).values())a.length>
yt&&Mo(e,n[a[yt-1]],a.length-yt+1)}function So(e,t,r,n,o,s,a){let{ctx:i,grid:l,colors:c}=e,u=B(t,n),[m,p]=[l.left+o.x*l.cell,l.top+o.y*l.cell],f=Math.max(4,l.cell*
o.size*(u?vo:bo)),g=ee(e,t,n),h=!u&&!!r.captured[n-t.nPursuers];if(i.globalAlpha=o.alpha,(u?Ne:W)(i,m,p,f),f>xo*a&&(i.strokeStyle=c.paper,i.lineWidth=Math.max(2,
f*.1),i.stroke()),i.fillStyle=h?c.paper:g,i.fill(),h&&(W(i,m,p,f*.82),i.strokeStyle=g,i.lineWidth=f*.18,i.stroke()),!s||f<wo*a)return;let v=String(u?n:n-t.nPursuers);
i.font=`700 ${Math.round(f*(u?.4:.5)*(v.length>1?.8:1))}px system-ui, sans-serif`,i.textAlign="center",i.textBaseline="middle",i.fillStyle=h?g:c.paper,i.fillText(
v,m,p+f*(u?.17:.03))}function Mo({ctx:e,grid:t,colors:r},n,o){let[s,a]=[t.left+n.x*t.cell,t.top+n.y*t.cell];e.font=`700 ${Math.round(t.cell*.3)}px system-ui, sa\
ns-serif`,e.textAlign="center",e.textBaseline="middle",e.strokeStyle=r.paper,e.lineWidth=t.cell*.1,e.strokeText(`+${o}`,s,a),e.fillStyle=r.ink,e.fillText(`+${o}`,
s,a)}var Eo=.46,Ao=.86,To=.66,Lr=.48,Co=.78,_o=.58;function Ir(e,t,r,n){let[o,s]=[t.moments[r-1],t.moments[r]];if(!o)return;let{ctx:a,grid:i,colors:l}=e;a.strokeStyle=
l.collision,a.lineWidth=Math.max(1.5,i.cell*.07),a.lineCap="butt",a.globalAlpha=n;for(let c=0;c<s.alive.length;c++)Pe(o,s,c)&&ko(e,t,E(o,c),Oe(o,s,c));a.globalAlpha=
1}function ko({ctx:e,grid:t},r,n,o){let[s,a]=[o[1]-n[1],o[0]-n[0]],i=m=>R(t,n[1]+.5+s*m),l=m=>$(t,n[0]+.5+a*m),c=mt(r,o)?Co:_o;e.setLineDash([t.cell*.09,t.cell*
.06]),e.beginPath(),e.moveTo(i(Lr),l(Lr)),e.lineTo(i(c),l(c)),e.stroke(),e.setLineDash([]);let u=.17*t.cell/Math.hypot(s,a);e.beginPath(),e.moveTo(i(c)-a*u,l(c)+
s*u),e.lineTo(i(c)+a*u,l(c)-s*u),e.stroke()}function Nr(e,t,r,n,o,s){let a=ut[s];if(!s||!a)return;let{ctx:i,grid:l,colors:c}=e,u=mt(t,[n[0]+a[0],n[1]+a[1]])?Ao:
To,m=Eo*o.size,p=[R(l,o.x+a[1]*m),$(l,o.y+a[0]*m),R(l,o.x+a[1]*u),$(l,o.y+a[0]*u)],f=Math.max(1.5,l.cell*.085);i.lineCap=i.lineJoin="round";for(let[g,h]of[[c.paper,
f*2.1],[ee(e,t,r),f]])i.strokeStyle=g,i.lineWidth=h,Sr(i,...p,l.cell*.2),i.stroke()}var Fr={numbers:!0,axes:!1,trail:6,viewers:[],plan:null,selected:null,cursor:null};function Hr(e,t,r,n,o){let{ctx:s,grid:a,colors:i}=e,l=Math.min(Math.ceil(r),t.
moments.length-1),c=t.moments[l],u=r===l,m=Ie(t,r),p=u?1:Math.max(0,1-2*(l-r));s.clearRect(0,0,s.canvas.width,s.canvas.height),Ar(e);for(let h of n.viewers)m[h]?.
alpha&&_r(e,t,h,...br(t,h,r));Tr(e,t),n.axes&&Cr(e,o),kr(e,t,r,n.trail,m),$r(e,c.contested??[],p),Rr(e,t,r),Ir(e,t,l,p),m.forEach(({x:h,y:v,size:w},S)=>{let b=dr(
c,S)?.4:0,x=ht(c,S)?1:b;x&&Pr(e,h,v,w,x*p)});let f=u?c:t.moments[Math.max(0,l-1)];if(Or(e,t,f,m,n.numbers,o),u&&n.plan)for(let[h,v]of m.entries())v.alpha&&Nr(e,
t,h,E(c,h),v,n.plan[h]??0);s.lineWidth=Math.max(2,2.5*o),s.strokeStyle=i.focus;let g=n.selected===null?void 0:m[n.selected];g?.alpha&&Ur(e,g.x,g.y,g.size*.96),n.
cursor&&(s.setLineDash([a.cell*.12,a.cell*.08]),Ur(e,n.cursor[1]+.5,n.cursor[0]+.5,.8),s.setLineDash([]))}function Ur({ctx:e,grid:t},r,n,o){let s=o*t.cell;e.beginPath(),
e.roundRect(t.left+r*t.cell-s/2,t.top+n*t.cell-s/2,s,s,s*.1),e.stroke()}var Dr=(e,t)=>(t+.24)/(e+.24);function Br(e,t,r,n,o,s){let a=r?28*s:0,i=(c,u)=>(c-a)/(u+2*.12),l=Math.max(1,Math.floor(Math.min(i(n,t),i(o,e))));return{rows:e,cols:t,
cell:l,left:Math.round((n-t*l+a)/2),top:Math.round((o-e*l+a)/2)}}function Wr(e,t,r){let n=Math.floor((r-e.top)/e.cell),o=Math.floor((t-e.left)/e.cell);return n>=
0&&n<e.rows&&o>=0&&o<e.cols?[n,o]:null}var Ro={paper:"--board-paper",line:"--board-line",frame:"--board-frame",ink:"--board-ink",muted:"--board-muted",obstacle:"--board-obstacle",pursuer:"--pursuer",
evader:"--evader",capture:"--capture",collision:"--collision",focus:"--focus"};function Ue(e){let t=getComputedStyle(e),r=Object.entries(Ro).map(([n,o])=>[n,t.getPropertyValue(
o).trim()]);return Object.fromEntries(r)}var re=()=>matchMedia("(prefers-reduced-motion: reduce)").matches,te=class{canvas;#e=null;#n=0;#s;#a={rows:1,cols:1,left:0,top:0,cell:1};#r=0;#t;#o;constructor(t,r={}){
this.canvas=t,t.classList.add("board"),t.setAttribute("role","img"),this.#s={...Fr,...r},this.#t=new ResizeObserver(()=>this.#m()),this.#t.observe(t),this.#o=new MutationObserver(
()=>this.redraw()),this.#o.observe(document.documentElement,{attributes:!0}),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",this.redraw)}close(){
this.#t.disconnect(),this.#o.disconnect(),matchMedia("(prefers-color-scheme: dark)").removeEventListener("change",this.redraw),cancelAnimationFrame(this.#r)}get look(){
return this.#s}set look(t){this.#s={...this.#s,...t},this.#c(),this.redraw()}get time(){return this.#n}show(t,r){this.#e=t,this.#n=Math.min(Math.max(0,r),t.moments.
length-1),this.#c(),this.redraw()}redraw=()=>{this.#r||(this.#r=requestAnimationFrame(()=>this.drawNow()))};drawNow(){cancelAnimationFrame(this.#r),this.#r=0;let t=this.
canvas.getContext("2d");if(!t||!this.#e)return;let{rows:r,cols:n}=this.#e,o=devicePixelRatio||1;this.#a=Br(r,n,this.#s.axes,this.canvas.width,this.canvas.height,
o);let s={ctx:t,grid:this.#a,colors:Ue(this.canvas)};Hr(s,this.#e,this.#n,this.#s,o)}cellAt(t,r){let n=this.canvas.getBoundingClientRect(),o=this.canvas.width/n.
width;return Wr(this.#a,(t-n.left)*o,(r-n.top)*o)}agentAt(t,r){let n=this.cellAt(t,r);if(!n||!this.#e)return null;let o=this.#e.moments[Math.round(this.#n)],s=he(
this.#e,o).get(n[0]*this.#e.cols+n[1])??[],a=Ie(this.#e,Math.round(this.#n)),i=l=>{let[c,u]=this.pointOf(a[l].x,a[l].y);return Math.hypot(c-t,u-r)};return s.length?
s.reduce((l,c)=>i(c)<i(l)?c:l):null}pointOf(t,r){let n=this.canvas.getBoundingClientRect(),o=n.width/this.canvas.width,{left:s,top:a,cell:i}=this.#a;return[n.left+
(s+t*i)*o,n.top+(a+r*i)*o]}#c(){if(!this.#e)return;let{rows:t,cols:r}=this.#e;this.canvas.style.setProperty("--board-aspect",String(Dr(t,r)))}#m(){let t=devicePixelRatio||
1,{width:r,height:n}=this.canvas.getBoundingClientRect();this.canvas.width=Math.max(1,Math.round(r*t)),this.canvas.height=Math.max(1,Math.round(n*t)),this.drawNow()}};var Po={SIMULTANEOUS:0,SWARM_TURNS:1,AGENT_TURNS:2};function Oo(e,t,r){return{rows:e.rows,cols:e.cols,nPursuers:e.n_pursuers,fov:e.fov,interaction:Po[e.rules.interaction],
obstacles:t,moments:r}}function Fe(e){let t=Array.from({length:e.length+1},(r,n)=>Lo(e,n));return Oo(e.config,e.map,t)}function Lo(e,t){let r=e.n_agents,n=e.config.n_evaders,o=(a,i,l)=>a.
subarray(i*l,(i+1)*l),s={positions:o(e.last_positions,t,2*r),alive:o(e.alive,t,r),captured:o(e.captured,t,n),everCaptured:o(e.ever_captured,t,n)};return t===0?s:
{...s,actions:o(e.actions,t-1,r),involved:o(e.involved,t-1,3*r),fault:o(e.fault,t-1,3*r),get contested(){return e.conflicts(t).map(a=>a.cell)}}}var Io=Array.from({length:16},(e,t)=>{let[r,n]=[t%2?6.5:11,Math.PI*t/8];return`${12+r*Math.sin(n)} ${12-r*Math.cos(n)}`}).join(" ");function jr(){let e=[["pursu\
er",y("path",{d:"M12 3 22 20H2z",class:"filled-pursuer"})],["evader",y("circle",{cx:12,cy:12,r:9,class:"filled-evader"})],["capture",y("polygon",{points:Io,class:"\
filled-capture"})],["captured evader",y("circle",{cx:12,cy:12,r:7.5,class:"ring-evader"})],["conflict",y("rect",{x:3,y:3,width:18,height:18,class:"dashed-confli\
ct"})]];return d("ul",{class:"shapes small","aria-label":"Shapes on the board"},...e.map(([t,r])=>d("li",{},y("svg",{viewBox:"0 0 24 24","aria-hidden":"true"},r),
t)))}var No={first:"M6 5v14M19 5 9 12l10 7z",back:"M17 5 7 12l10 7z",play:"M7 4.5 19 12 7 19.5z",pause:"M8 5v14M16 5v14",forward:"M7 5l10 7-10 7z",last:"M18 5v14M5 5\
l10 7-10 7z"};function Gr(e){let t=document.createElementNS("http://www.w3.org/2000/svg","svg");t.setAttribute("viewBox","0 0 24 24"),t.setAttribute("aria-hidde\
n","true"),t.classList.add("icon");let r=document.createElementNS("http://www.w3.org/2000/svg","path");return r.setAttribute("d",No[e]),t.append(r),t}function fe(e,t,r,n){
let o=document.createElement("button");return o.type="button",o.className="player-button",o.append(Gr(e)),o.ariaLabel=t,o.title=`${t} (${r})`,o.addEventListener(
"click",n),o}function He(e){let t=document.createElement("div");t.className="player",t.role="group",t.ariaLabel="Player";let r=fe("play","Play","Space",()=>e.toggle()),
n=Uo(e),o=d("div",{class:"captures","aria-hidden":"true",title:"Captures"}),s=Fo(e),a=document.createElement("output");a.className="player-count",t.append(fe("f\
irst","First step","Home",()=>e.move(-e.length)),fe("back","Step back","←",()=>e.move(-1)),r,fe("forward","Step forward","→",()=>e.move(1)),fe("last","Last \
step","End",()=>e.move(e.length)),d("div",{class:"scrub"},o,n),a,s);let i=()=>o.replaceChildren(...e.marks.map(c=>{let u=d("i");return u.style.left=`${100*c/Math.
max(1,e.length)}%`,u})),l=()=>{r.replaceChildren(Gr(e.playing?"pause":"play")),r.ariaLabel=e.playing?"Pause":"Play",r.title=`${r.ariaLabel} (Space)`,n.max=String(
e.length),n.value=String(e.step),n.ariaValueText=`step ${e.step} of ${e.length}`,a.textContent=`${e.step} / ${e.length}`,a.style.minWidth=`${2*String(e.length).
length+3}ch`,s.value=String(e.speed)};return e.addEventListener("step",l),e.addEventListener("state",l),e.addEventListener("state",i),t.addEventListener("keydow\
n",c=>{!(c.target instanceof HTMLSelectElement||c.key===" "&&c.target!==n)&&J(e,c)&&c.preventDefault()}),l(),t}function Uo(e){let t=document.createElement("inpu\
t");return t.type="range",t.className="player-scrub",t.min="0",t.step="1",t.ariaLabel="Step",t.addEventListener("input",()=>{e.pause(),e.jump(Number(t.value))}),
t}function Fo(e){let t=document.createElement("select");return t.className="player-speed",t.ariaLabel="Speed",t.title="Steps a second (+ and -)",t.append(new Option(
`all in ${ct} s`,String(X)),...ue.map(r=>new Option(`${r} / s`,String(r)))),t.addEventListener("change",()=>{e.speed=Number(t.value)}),t}var A=(e,t=2)=>e==null?"-":e.toFixed(t),bt=(e,t=1)=>e==null?"-":`${(100*e).toFixed(t)} %`;function De(e,t,r,n=2){return t===null||r===null?e.toFixed(n):`${e.toFixed(
n)} (${t.toFixed(n)} to ${r.toFixed(n)})`}var zr=e=>e.toLocaleString("en-GB");function ge(e,t,r,n=!1){let o=(t-e)/Math.max(1,r),s=10**Math.floor(Math.log10(o||1)),
a=[1,2,5,10].map(c=>c*s).find(c=>c>=o)??10*s;n&&(a=Math.max(1,Math.round(a)));let i=Math.ceil(e/a-1e-9),l=Math.floor(t/a+1e-9);return Array.from({length:Math.max(
0,l-i+1)},(c,u)=>(i+u)*a)}function N(e,t,{pursuer:r,evader:n,episode:o,seed:s}){let a=t.seeds[r][n];return e.match(t.world,de(t,"pursuer",r),de(t,"evader",n),BigInt(s??a),o)}var Vr=40,ye=new Map,be=({run:e,pursuer:t,evader:r},n)=>`${e} ${t} ${r} ${n}`,Be=class{element;#e;#n;#s=d("div",{class:"episodes",role:"group","aria-label":"Epi\
sodes of this cell"});#a=d("p",{class:"check small numbers","aria-live":"polite"});#r=0;constructor(t,r){[this.#e,this.#n]=[t,r],this.element=d("div",{class:"st\
rip-of-episodes"},this.#s,this.#a)}show(t,r,n){let{selected:o}=this.#e;o.seed===null&&ye.set(be(o,o.episode),Kr(n)),this.#o(r),Do(this.#r),this.#t(t,r)}#t(t,r){
let{selected:n}=this.#e,s=le(r,n.pursuer,n.evader)?.rates.findIndex((a,i)=>!ye.has(be(n,i)))??-1;s<0||s>=Vr||(this.#r=Ho(()=>{this.#e.selected===n&&(this.#n.playing||
(ye.set(be(n,s),Kr(N(t,r,{...n,episode:s,seed:null}))),this.#o(r)),this.#t(t,r))}))}#o(t){let{selected:r}=this.#e,n=le(t,r.pursuer,r.evader);if(!n){this.#s.replaceChildren(),
this.#a.textContent="The evaluation played no episodes of this pair.";return}let o=Math.min(Vr,n.rates.length);this.#s.replaceChildren(...n.rates.slice(0,o).map(
(c,u)=>this.#c(c,u)));let s=n.rates.slice(0,o).map((c,u)=>ye.get(be(r,u))),a=s.filter(c=>c!==void 0),i=s.flatMap((c,u)=>c&&(Math.abs(c.rate-n.rates[u])>1e-6||c.
length!==n.lengths[u])?[u+1]:[]),l=a.reduce((c,u)=>c+u.rate,0)/a.length;this.#a.dataset.equal=String(!i.length&&a.length===n.rates.length),this.#a.textContent=i.
length?`Episode ${i.join(", ")} differs from the evaluation.`:"As in the evaluation",this.#a.title=a.length<n.rates.length?`Played here: ${a.length} of ${n.rates.
length} episodes.`:`Played here: all ${a.length} episodes, mean capture rate ${A(l,3)}. The cell says ${A(n.rate,3)}.`}#c(t,r){let{selected:n}=this.#e,o=d("span",
{class:"bar"});return o.style.height=`${Math.round(100*t)}%`,d("button",{type:"button",class:"episode",title:`Episode ${r+1}: capture rate ${A(t)}`,"aria-label":`\
Episode ${r+1}, capture rate ${A(t)}`,"aria-pressed":String(r===n.episode&&n.seed===null),"data-played":ye.has(be(n,r)),onclick:()=>this.#e.select({episode:r,seed:null})},
o,d("span",{class:"count"},r+1))}},Kr=e=>({rate:e.statistics.capture_rate,length:e.length}),Ho=e=>"requestIdleCallback"in window?requestIdleCallback(e,{timeout:1e3}):
setTimeout(e,100),Do=e=>"cancelIdleCallback"in window?cancelIdleCallback(e):clearTimeout(e);var ve=(e,t)=>e<t?`pursuer_${e}`:`evader_${e-t}`,vt=["stay","north","east","south","west","northeast","southeast","southwest","northwest"];var Yr=0,qr=1,Bo=2,Wo=176;function Jr(e,t,r,n){let o=devicePixelRatio||1,s=Ue(e);e.width=e.height=Wo*o;let a=e.getContext("2d");if(!a)return;let{fov:i}=t,l=e.width/
i;a.fillStyle=s.paper,a.fillRect(0,0,e.width,e.height);for(let u=0;r&&u<i*i;u++){let[m,p]=[(u%i+.5)*l,(Math.floor(u/i)+.5)*l],f=h=>!!r[h*i*i+u];f(Bo)&&(a.fillStyle=
s.obstacle,a.fillRect(m-l/2,p-l/2,l,l));let g=f(Yr)&&f(qr)?l*.18:0;f(Yr)&&Xr(a,W,m+g,p+g,l*.74,s.evader),f(qr)&&Xr(a,Ne,m-g,p-g,l*.86,s.pursuer)}a.strokeStyle=n<
t.n_pursuers?s.pursuer:s.evader,a.lineWidth=2*o;let c=Math.floor(i/2)*l;a.strokeRect(c,c,l,l)}function Xr(e,t,r,n,o,s){t(e,r,n,o),e.fillStyle=s,e.fill()}var We=class{element;#e;#n=d("canvas",{class:"seen",role:"img"});#s=d("h3");#a=d("p",{class:"small muted"});#r=d("div",{class:"answers"});#t=null;#o=null;#c=null;#m=null;#i=null;#d=0;constructor(t){
this.#e=t,this.element=d("div",{class:"inspector","data-open":"false"},d("p",{class:"hint small muted"},"Click an agent, or press A: what it sees, and what its \
network answers."),d("div",{class:"inspected"},this.#n,d("div",{class:"answer"},this.#s,this.#a),this.#r))}get agent(){return this.#i}show(t,r,n,o){(this.#o!==r||
!this.#t)&&(this.#t?.free(),this.#t=t.world(r.world),this.#i!==null&&this.#o!==r&&this.choose(null)),[this.#o,this.#c,this.#m]=[r,n,o]}choose(t){this.#i=t,this.
element.dataset.open=String(t!==null),this.#e(t),this.at(this.#d)}next(t){let r=this.#c;if(!r)return;let n=this.#i??(t>0?-1:0);for(let o=0;o<r.n_agents;o++)if(n=
(n+t+r.n_agents)%r.n_agents,r.alive[this.#d*r.n_agents+n])return this.choose(n)}at(t){this.#d=t;let[r,n,o,s,a]=[this.#c,this.#t,this.#o,this.#m,this.#i];if(!r||
!n||!o||!s||a===null)return;let i=a<r.config.n_pursuers?"pursuer":"evader";this.#s.replaceChildren(d("span",{class:i},ve(a,r.config.n_pursuers)));let l=!!r.alive[t*
r.n_agents+a];r.seek(n,t),Jr(this.#n,r.config,l?n.view(a):null,a),this.#n.ariaLabel=`Field of view of ${ve(a,r.config.n_pursuers)}: evaders, pursuers and obstac\
les around it`;let c=t<r.length?r.actions[t*r.n_agents+a]:null;if(!l)return this.#l([],"It is gone.");let u=de(o,i,s[i]);if(typeof u=="string")return this.#l([],
`The script "${u}" plays for it${c===null?"":`; it goes ${vt[c]}`}.`);let{probabilities:m}=n.answer(u,a),p=Array.from(m,(g,h)=>jo(vt[h],g,h===c)),f=u.sampled?"I\
ts action is drawn from these probabilities.":"It takes the most probable action.";this.#l(p,c===null?"The episode is over.":f)}#l(t,r){this.#r.replaceChildren(
...t),this.#a.textContent=r}};function jo(e,t,r){let n=d("span",{class:"filled"});return n.style.width=`${100*t}%`,d("div",{class:r?"action taken":"action"},d("\
span",{},e),d("span",{class:"track"},n),d("span",{class:"numbers"},t.toFixed(2)))}var Go=(e,t)=>Object.keys(e).every(r=>e[r]===t[r]);function Zr(e,t){return Object.keys(t).find(r=>Go(t[r],e))??null}var we="_",vi=2n**64n-1n;var wt={fov:11,maxSteps:500,rewards:"paper"},Vo=["rules","others","rewards","size","diagonal","fov","limit","seed","ended","walls","pursuers","evaders","played",
"next"];function nn(e,t){let r=i=>i.map(l=>Yo(l,t)).join(""),n=i=>`${Math.floor(i/e.cols)}.${i%e.cols}`,o=Ko(e.rewards,t),s=[e.seed,e.episode,e.steps].join("."),a={rules:en(
e.rules,t),others:e.others?en(e.others,t):"",rewards:o===wt.rewards?"":o,size:`${e.rows}x${e.cols}`,diagonal:e.diagonal?"1":"",fov:e.fov===wt.fov?"":String(e.fov),
limit:e.maxSteps===wt.maxSteps?"":String(e.maxSteps),seed:s==="0.0.0"?"":s,ended:e.ended?"1":"",walls:e.walls.map(n).join(we),pursuers:e.pursuers.map(Qr).join(we),
evaders:e.evaders.map(Qr).join(we),played:e.played.map(r).join(we),next:e.next.every(i=>i===0)?"":r(e.next)};return Vo.filter(i=>a[i]).map(i=>`${i}=${a[i]}`).join(
"&")}function Qr({cell:e,gone:t,captured:r,everCaptured:n}){let o=r?"c":n?"e":"";return`${e[0]}.${e[1]}${o}${t?"x":""}`}function en(e,t){let r=t.fields.map(({name:n})=>String(
e[n]).toLowerCase());return Zr(e,t.variants)??r.join(".")}function Ko(e,t){let r=JSON.stringify(e);return Object.keys(t.rewards).find(o=>JSON.stringify(t.rewards[o])===
r)??Object.values(e).map(o=>String(o)).join(we)}function Yo(e,t){if(typeof e=="number")return String(e);let r=t.scripts.findIndex(({name:n})=>n===e);return String.
fromCharCode(97+r)}var qo="/* the engine */";function on(e,t){return d("button",{type:"button",class:"to-playground",title:"Open this step in the playground (G): the same agents a\
nd actions under any rules",onclick:()=>xt(e(),t)},"What if? Playground")}function xt(e,t){let n=e!==null&&e.match.n_agents<=100&&Math.max(e.match.config.rows,e.
match.config.cols)<=64?nn(Xo(e.match,e.step),t):"",o=new TextDecoder().decode(lt("playground")).replace(qo,()=>Re("script-engine"));window.open(`${URL.createObjectURL(
new Blob([o],{type:"text/html"}))}#${n}`)}function Xo(e,t){let{config:r,n_agents:n}=e,o=Math.max(0,t-1),s=i=>{let l=o*n+i,c=o*r.n_evaders+i-r.n_pursuers,u=m=>i>=
r.n_pursuers&&!!m[c];return{cell:[e.last_positions[2*l],e.last_positions[2*l+1]],gone:!e.alive[l],captured:u(e.captured),everCaptured:u(e.ever_captured)}},a=Array.
from({length:n},(i,l)=>s(l));return{rules:r.rules,others:null,rewards:r.rewards,rows:r.rows,cols:r.cols,diagonal:r.diagonal,fov:r.fov,maxSteps:r.max_steps,seed:e.
seed,episode:BigInt(e.episode),steps:o,ended:o===e.length,walls:Array.from(e.map.keys()).filter(i=>e.map[i]),pursuers:a.slice(0,r.n_pursuers),evaders:a.slice(r.
n_pursuers),played:[],next:Array.from(e.actions.subarray(o*n,(o+1)*n))}}function sn(e,t,r){if(r===0)return[{kind:"start",text:Jo(e),agents:[]}];let[n,o]=[t.moments[r-1],t.moments[r]],s=u=>ve(u,e.config.n_pursuers),a=pe(t,n,o),i=e.conflicts(
r),l=new Set(i.flatMap(u=>u.doomed)),c=a.map(u=>({kind:"capture",text:`${s(u)} is captured`,agents:[u]}));for(let u of Le(n,o))!a.includes(u)&&!l.has(u)&&c.push(
{kind:"end",text:`${s(u)} disappears`,agents:[u]});return c.push(...i.map(({kind:u,text:m,agents:p})=>({kind:u,text:m,agents:p}))),r===e.length&&c.unshift({kind:"\
end",text:Zo(e),agents:[]}),c}function Jo({config:e}){return`${e.n_pursuers} pursuers and ${e.n_evaders} evaders on ${e.rows} x ${e.cols} cells, at most ${e.max_steps}\
 steps`}function Zo(e){let t=Math.round(e.statistics.capture_rate*e.config.n_evaders);return`The episode ends after ${e.length} steps with ${t} of ${e.config.n_evaders}\
 evaders captured`}var Qo=60,je=class{element;player=new q(0,{speed:X,still:re()});inspector;#e;#n;#s;#a;#r=d("h2",{class:"match-title"});#t=d("p",{class:"tally numbers"});#o=d("o\
l",{class:"words","aria-live":"off","aria-label":"What happened in this step"});#c=d("p",{class:"problem",role:"alert"});#m=null;#i=null;#d=null;#l=0;#p=!1;#h=0;constructor(t,r,n){
[this.#n,this.#s]=[t,r];let o=d("canvas",{"aria-label":"The match"});this.#e=new te(o,{numbers:!1}),this.#a=new Be(r,this.player),this.inspector=new We(s=>this.#x(
s)),o.addEventListener("click",s=>this.inspector.choose(this.#e.agentAt(s.clientX,s.clientY))),this.element=d("section",{class:"card match-card","aria-label":"M\
atch",id:"match"},d("div",{class:"match"},d("header",{class:"match-head"},this.#r,this.#t),this.#c,d("div",{class:"stage"},o),d("div",{class:"aside"},this.#o,jr(),
on(()=>this.shown,n),this.inspector.element),He(this.player),this.#a.element)),this.player.addEventListener("frame",()=>this.#d&&this.#e.show(this.#d,this.player.
time)),this.player.addEventListener("step",()=>this.#v()),r.on("match",()=>this.#b()),r.on("rest",()=>this.player.pause()),this.#g(),this.#w(0,0)}get#u(){return this.#n[this.#s.
selected.run]}get match(){return this.#i}get shown(){return this.#i&&{match:this.#i,step:this.player.step}}start(t){this.#m=t,this.#y()}playSoon(){this.#p=!0,this.#l||
this.#f()}goTo(t){this.#h=t,!this.#l&&this.#i&&this.#y()}#f(){!this.#p||!this.#i||(this.#p=!1,this.player.jump(0),re()||this.player.play())}#b(){this.#g(),clearTimeout(
this.#l),this.#l=setTimeout(()=>this.#y(),Qo)}#y(){clearTimeout(this.#l),this.#l=0,this.player.pause(),this.#g();let{selected:t}=this.#s,r=tr.map(n=>ce(this.#u,
n,t[n])).find(Boolean)??"";this.#c.textContent=r,!(r||!this.#m)&&(this.#i=N(this.#m,this.#u,t),this.#d=Fe(this.#i),this.#a.show(this.#m,this.#u,this.#i),this.inspector.
show(this.#m,this.#u,this.#i,t),this.player.length=this.#i.length,this.player.marks=ur(this.#d),this.player.jump(this.#h),this.#h=0,this.#v(),this.element.dataset.
played=`${t.run} ${t.pursuer} ${t.evader} ${t.episode} ${t.seed??""}`,this.#f())}#g(){let{pursuer:t,evader:r,episode:n,seed:o}=this.#s.selected,{teams:s,payoff:a}=this.#u,
i=(c,u)=>s[c].script??`${c}s ${u}`,l=o===null?n<a.episodes?`episode ${n+1} of ${a.episodes}`:`episode ${n+1}, not part of the cell`:`seed ${o}`;this.#r.replaceChildren(
d("span",{class:"pursuer"},i("pursuer",t))," against ",d("span",{class:"evader"},i("evader",r)),d("span",{class:"muted small"},l))}#v(){let t=this.#i;if(!t||!this.#d)
return;let r=this.player.step,n=this.#d.moments[r];this.#w(Array.from(n.everCaptured).filter(Boolean).length,r),this.#o.replaceChildren(...sn(t,this.#d,r).map(o=>d(
"li",{class:o.kind,"data-agents":o.agents.join(" ")},o.text))),this.inspector.at(r),this.#S()}#w(t,r){this.#t.replaceChildren(d("strong",{},t),` of ${this.#u.world.
n_evaders} captured`,d("span",{class:"muted"},` · step ${r}`))}#x(t){this.#e.look={selected:t,viewers:t===null?[]:[t]},this.#S()}#S(){let t=this.inspector.agent;
for(let r of this.#o.children){let n=r.dataset.agents?.split(" ")??[];r.classList.toggle("about",t!==null&&n.includes(String(t)))}}};var es={ArrowUp:[1,0],ArrowDown:[-1,0],ArrowRight:[0,1],ArrowLeft:[0,-1]},ts=5;function j(e,t,r,n="pursuer"){e.tabIndex=0,e.setAttribute("role","application"),e.
addEventListener("keydown",o=>{let s=es[o.key];if(!s)return;let[a,i]=n==="pursuer"?s:[s[1],s[0]],[l,c]=r(),u=o.shiftKey?ts:1,{pursuer:m,evader:p}=t.selected;t.select(
{pursuer:an(m+u*a,l),evader:an(p+u*i,c)}),o.preventDefault(),o.stopPropagation()})}var an=(e,t)=>Math.min(t-1,Math.max(0,e));var _={left:52,bottom:46,top:76,right:84},P=10,rs=160,xe=_.right-P-14,G=_.top-P-14,Ge=class{element;#e;#n;#s=d("canvas",{"aria-hidden":"true"});#a=y("svg",{"ari\
a-hidden":"true"});#r=y("g");#t;#o=d("h2");#c=d("strong",{class:"rate numbers"});#m=d("span",{class:"small muted"});#i=d("p",{class:"of-both-teams small muted n\
umbers"});#d=null;constructor(t,r){[this.#n,this.#e]=[t,r],this.#t=d("div",{class:"matrix",id:"matrix","aria-label":"Payoff matrix. Arrow keys choose a match, E\
nter plays it."},this.#s,this.#a);let n=d("header",{class:"readout","aria-live":"polite"},d("div",{},this.#o,this.#i),d("div",{class:"of-cell"},this.#c,this.#m));
this.element=d("section",{class:"card matrix-card","aria-label":"Payoff matrix"},n,this.#t,ns()),this.#b(),new ResizeObserver(()=>this.#p()).observe(this.#t),this.#t.
addEventListener("pointermove",o=>this.#v(o)),this.#t.addEventListener("pointerleave",()=>r.point({})),this.#t.addEventListener("click",o=>this.#w(o)),this.#t.addEventListener(
"mousedown",o=>{o.preventDefault(),document.activeElement instanceof HTMLElement&&document.activeElement.blur()}),j(this.#t,r,()=>this.#l.payoff.shape),this.#t.
addEventListener("keydown",o=>{o.key==="Enter"&&this.#x()}),r.on("run",()=>this.#p()),r.on("match",()=>this.#f()),r.on("hover",()=>this.#f())}get#l(){return this.#n[this.#e.
selected.run]}#p(){let[t,r]=this.#l.payoff.shape,{clientWidth:n,clientHeight:o}=this.#t;if(n<50)return;let a=Math.max(rs,Math.min(n-_.left-_.right,o-_.top-_.bottom))/
Math.max(t,r),i=Math.max(_.left,(n-r*a-_.right+_.left)/2),l=_.top+Math.max(0,(o-_.top-_.bottom-t*a)/2),c={width:n,height:o,left:i,top:l,cell:a,rows:t,columns:r};
this.#d=c,$e(this.#s,this.#l.payoff,{left:i,top:l,width:r*a,height:t*a}),this.#a.setAttribute("viewBox",`0 0 ${n} ${o}`),this.#a.replaceChildren(os(c),...ss(c),
...this.#u(c),this.#r),this.#f()}#h(t){let r=this.#l.findings?.generalization;if(!r)return[];let{selected:n,hover:o}=this.#e,[s,a]=[o.pursuer??n.pursuer,o.evader??
n.evader],[i,l]=ln(t,r.pursuers.mean[s]??0,s),[c,u]=cn(t,r.evaders.mean[a]??0,a);return[y("circle",{class:"dot of-pursuers",cx:i,cy:l,r:5}),y("circle",{class:"d\
ot of-evaders",cx:c,cy:u,r:5})]}#u(t){let r=this.#l.findings?.generalization;if(!r)return[];let{left:n,top:o,cell:s,rows:a,columns:i}=t,[l,c]=[n+i*s+P,o-P],u={class:"\
side"};return[y("rect",{...u,x:l,y:o,width:xe,height:a*s}),y("rect",{...u,x:n,y:c-G,width:i*s,height:G}),...dn(r.pursuers,(m,p)=>ln(t,m,p),"of-pursuers"),...dn(
r.evaders,(m,p)=>cn(t,m,p),"of-evaders"),y("text",{class:"tick",x:l,y:o+a*s+16,"text-anchor":"start"},"0"),y("text",{class:"tick",x:l+xe,y:o+a*s+16,"text-anchor":"\
end"},"1"),y("text",{class:"tick",x:n-6,y:c-4,"text-anchor":"end"},"0"),y("text",{class:"tick",x:n-6,y:c-G+8,"text-anchor":"end"},"1"),y("text",{class:"label of\
-pursuers",x:l+xe,y:o+a*s+34,"text-anchor":"end"},"captures"),y("text",{class:"label of-evaders",x:n+i*s+P,y:c-G+10,"text-anchor":"start"},"escapes")]}#f(){let t=this.#d;
if(!t)return;let{selected:r,hover:n}=this.#e,{left:o,top:s,cell:a,rows:i,columns:l}=t,c=g=>s+(i-1-g)*a,u=[],m=(g,h)=>y("rect",{class:h,x:o,y:c(g),width:l*a+P+xe,
height:a}),p=(g,h)=>y("rect",{class:h,x:o+g*a,y:s-P-G,width:a,height:P+G+i*a});if(u.push(m(r.pursuer,"strip pursuer"),p(r.evader,"strip evader")),n.pursuer!==null&&
n.pursuer<i&&u.push(m(n.pursuer,"strip hover")),n.evader!==null&&n.evader<l&&u.push(p(n.evader,"strip hover")),n.lag!==null)for(let g=0;g<l;g++){let h=g+n.lag;h>=
0&&h<i&&u.push(y("rect",{class:"lagged",x:o+g*a,y:c(h),width:a,height:a}))}u.push(...this.#h(t));let f={x:o+r.evader*a,y:c(r.pursuer),width:a,height:a};u.push(y(
"rect",{class:"chosen under",...f}),y("rect",{class:"chosen",...f})),this.#r.replaceChildren(...u),this.#b()}#b(){let{selected:t,hover:r}=this.#e,n=r.pursuer??t.
pursuer,o=r.evader??t.evader,s=le(this.#l,n,o);this.#o.replaceChildren(d("span",{class:"pursuer"},`Pursuers ${n}`)," against ",d("span",{class:"evader"},`evader\
s ${o}`)),this.#c.textContent=s?A(s.rate,3):"-",this.#m.textContent=s?`capture rate, mean of ${s.rates.length} episodes`:"the evaluation played no episodes",this.#i.
textContent=this.#y(n,o)}#y(t,r){let n=this.#l.findings?.generalization;if(!n)return"";let o=(s,a)=>De(s.mean[a]??0,s.low?.[a]??null,s.high?.[a]??null);return`A\
gainst all: captures ${o(n.pursuers,t)}, escapes ${o(n.evaders,r)}`}#g(t){let r=this.#d;if(!r)return null;let n=this.#t.getBoundingClientRect(),o=Math.floor((t.
clientX-n.left-r.left)/r.cell),s=r.rows-1-Math.floor((t.clientY-n.top-r.top)/r.cell),[a,i]=[s>=0&&s<r.rows,o>=0&&o<r.columns];return a||i?{g:a?s:-1,h:i?o:-1,inside:a&&
i}:null}#v(t){let r=this.#g(t);this.#e.point(r?{pursuer:r.g<0?null:r.g,evader:r.h<0?null:r.h}:{})}#w(t){let r=this.#g(t);r&&(this.#e.select({...r.g<0?{}:{pursuer:r.
g},...r.h<0?{}:{evader:r.h}}),r.inside&&this.#x())}#x(){this.#t.dispatchEvent(new CustomEvent("play",{bubbles:!0}))}};function ns(){let e=d("span",{class:"gradi\
ent"});return e.style.backgroundImage=ar(),d("p",{class:"scale-of-rates small muted"},"0 all escape",e,"1 all caught")}function os({left:e,top:t,cell:r,rows:n,columns:o}){
let s=y("g",{class:"axes"}),a=t+n*r,i=l=>ge(0,l-1,Math.min(l,l*r/44),!0);for(let l of i(o))s.append(y("text",{class:"tick",x:e+(l+.5)*r,y:a+16,"text-anchor":"mi\
ddle"},l));for(let l of i(n))s.append(y("text",{class:"tick",x:e-7,y:a-(l+.5)*r,"text-anchor":"end","dominant-baseline":"middle"},l));return s.append(y("text",{
class:"label of-evaders",x:e+o*r/2,y:a+36,"text-anchor":"middle"},"evader generation"),y("text",{class:"label of-pursuers",transform:`translate(${e-36} ${t+n*r/
2}) rotate(-90)`,"text-anchor":"middle"},"pursuer generation")),s}function ss({left:e,top:t,cell:r,rows:n,columns:o}){let s=y("g",{class:"diagonal"}),a=Math.min(
n,o);if(a<3)return[];let i=t+n*r;for(let u of["H","V"]){let m=`M${e} ${i}`;for(let p=1;p<=a;p++){let[f,g]=[`H${e+p*r}`,`V${i-p*r}`];m+=u==="H"?f+g:g+f}s.append(
y("path",{d:m,class:"under"}),y("path",{d:m}))}let[l,c]=[e+a/2*r-.7*r-4,i-a/2*r-.7*r-4];return[s,y("text",{class:"on-cells",transform:`translate(${l} ${c}) rota\
te(-45)`,"text-anchor":"middle"},"same generation")]}var ln=({left:e,top:t,cell:r,rows:n,columns:o},s,a)=>[e+o*r+P+s*xe,t+(n-a-.5)*r],cn=({left:e,top:t,cell:r},n,o)=>[
e+(o+.5)*r,t-P-n*G];function dn(e,t,r){let n=s=>s.map((a,i)=>t(a??0,i).map(l=>l.toFixed(1)).join(" ")),o=[];return e.low&&e.high&&o.push(y("path",{class:`band ${r}`,
d:`M${[...n(e.high),...n(e.low).reverse()].join("L")}Z`})),o.push(y("path",{class:`line ${r}`,d:`M${n(e.mean).join("L")}`})),o}function T(e,t,...r){return d("section",{class:"card panel","aria-label":e},d("header",{},d("h2",{},e),d("p",{class:"small muted"},t)),...r)}function un(e,t,r){let{findings:n}=e;if(!n)return null;let o=d("dialog",{class:"four","aria-label":"Four matches"}),s=i=>{let l=r();l&&is(o,e,i,t,l)},a=n.checkerboards.
map(i=>as(e,i,s));return{element:T("Checkerboards","Two generations of each team: each pursuers are better against one of the evaders. Click one: its four match\
es side by side.",a.length?d("div",{class:"boards"},...a):d("p",{},`No four cells differ by more than ${n.margin} in this way.`),a.length?d("p",{class:"small mu\
ted"},"The strongest of all pairs, so noise makes them look stronger than they are. The diagnosis says whether there are more than noise makes."):null,o)}}var mn=({
pursuers:[e,t],evaders:[r,n]})=>[[e,r],[e,n],[t,r],[t,n]];function as(e,t,r){let[n,o]=t.pursuers,[s,a]=t.evaders,i=mn(t).map(([l,c])=>{let u=e.payoff.capture_rate[l][c],
m=d("span",{class:"cell"},A(u));return m.style.backgroundColor=sr(u),m.style.color=or(u),m});return d("button",{type:"button",class:"miniature numbers",onclick:()=>r(
t)},d("span",{},d("span",{class:"heard"},`Four matches of pursuers ${n} and ${o}, evaders ${s} and ${a}:`)),d("span",{class:"evader"},s),d("span",{class:"evader"},
a),d("span",{class:"pursuer"},n),i[0],i[1],d("span",{class:"pursuer"},o),i[2],i[3])}function is(e,t,r,n,o){let s=mn(r).filter(([p,f])=>!ce(t,"pursuer",p)&&!ce(t,
"evader",f)),a=s.map(([p,f])=>N(o,t,{run:n.selected.run,pursuer:p,evader:f,episode:0,seed:null})),i=new q(Math.max(0,...a.map(p=>p.length)),{speed:X,still:re()}),
l=a.map((p,f)=>{let[g,h]=s[f],v=d("canvas",{"aria-label":`Pursuers ${g} against evaders ${h}`}),w=d("span",{class:"numbers"}),S=()=>{e.close(),n.select({pursuer:g,
evader:h})},b=d("figure",{},v,d("figcaption",{class:"small"},w,d("span",{class:"muted"},`cell ${A(t.payoff.capture_rate[g][h])}`),d("button",{type:"button",title:"\
Show this match alone",onclick:S},"open")));return b.style.gridArea=`${r.pursuers.indexOf(g)+2} / ${r.evaders.indexOf(h)+2}`,{element:b,match:p,recording:Fe(p),
board:new te(v,{numbers:!1}),tally:w}}),c=()=>l.forEach(p=>p.board.show(p.recording,i.time)),u=()=>l.forEach(({recording:p,match:f,tally:g})=>{let h=p.moments[Math.
min(i.step,f.length)];g.textContent=`${Array.from(h.everCaptured).filter(Boolean).length} of ${f.config.n_evaders} captured`});i.addEventListener("frame",c),i.addEventListener(
"step",u),e.replaceChildren(d("header",{},d("h2",{},"Four matches of a checkerboard"),d("button",{type:"button",onclick:()=>e.close()},"Close")),d("div",{class:"\
grid-of-four"},d("span"),...r.evaders.map(p=>d("h3",{class:"evader"},`evaders ${p}`)),...r.pursuers.map((p,f)=>{let g=d("h3",{class:"pursuer"},`pursuers ${p}`);
return g.style.gridArea=`${f+2} / 1`,g}),...l.map(p=>p.element)),He(i));let m=p=>{!(p.target instanceof HTMLSelectElement||p.target instanceof HTMLButtonElement&&
p.key===" ")&&!p.defaultPrevented&&J(i,p)&&p.preventDefault()};e.addEventListener("keydown",m),e.addEventListener("close",()=>{e.removeEventListener("keydown",m),
i.pause(),l.forEach(p=>p.board.close()),e.replaceChildren()},{once:!0}),n.dispatchEvent(new Event("rest")),e.showModal(),c(),u(),re()||i.play()}var ze={pursuer:"evader",evader:"pursuer"};function pn(e,t){let r=e.findings?.ciao;if(!r)return null;let n=["pursuer","evader"].map(o=>{let{fading:s,stripes:a,period:i}=r[`${o}\
s`],l=`fading ${A(s)}, stripes ${A(a)}${i===null?"":` every ${i} generations`}`;return ls(e,o,l,t)});return{element:T("CIAO","Current individuals against ancest\
ral opponents, by the team's own score. Stripes: intransitive, since wins and losses alternate with the age of the opponent; whether a team returns to earlier s\
trategies is recurrence, under What happened. Darker away from the diagonal: forgetting.",d("div",{class:"triangles"},...n.map(o=>o.element))),update:()=>n.forEach(
o=>o.update())}}function ls(e,t,r,n){let o=t==="pursuer"?0:1,[s,a]=[e.payoff.shape[o],e.payoff.shape[1-o]],i=(b,x)=>t==="pursuer"?e.payoff.capture_rate[b][x]:1-
e.payoff.capture_rate[x][b],l=d("canvas",{width:a,height:s,"aria-hidden":"true"}),c=l.getContext("2d"),u=c?.createImageData(a,s);for(let b=0;u&&b<s;b++)for(let x=0;x<=
Math.min(b,a-1);x++)u.data.set([...Z(i(b,x)),255],4*((s-1-b)*a+x));u&&c?.putImageData(u,0,0);let m=y("rect",{class:"chosen",width:1,height:1}),p=y("rect",{class:"\
chosen under",width:1,height:1}),f=y("svg",{viewBox:`0 0 ${a} ${s}`,preserveAspectRatio:"none","aria-hidden":"true"},p,m),g=d("div",{class:"triangle","aria-labe\
l":`CIAO of the ${t}s: ${r}. Arrow keys choose a match.`},l,f);j(g,n,()=>e.payoff.shape,t),g.style.aspectRatio=`${a} / ${s}`;let h=b=>{let x=g.getBoundingClientRect(),
C=Math.floor((b.clientX-x.left)/x.width*a),F=s-1-Math.floor((b.clientY-x.top)/x.height*s);return C>=0&&F<s&&C<=F?[F,C]:null},v=b=>({[t]:b[0],[ze[t]]:b[1]});g.addEventListener(
"pointermove",b=>n.point(h(b)?v(h(b)):{})),g.addEventListener("pointerleave",()=>n.point({})),g.addEventListener("click",b=>h(b)&&n.select(v(h(b))));let w=()=>{
let b=n.hover[t]??n.selected[t],x=n.hover[ze[t]]??n.selected[ze[t]];for(let C of[m,p])C.setAttribute("x",String(x)),C.setAttribute("y",String(s-1-b)),C.style.display=
x<=b?"":"none"};return{element:d("figure",{},d("figcaption",{class:"small"},d("span",{class:t},`${t}s`)),g,d("p",{class:"small muted"},`horizontal: ${ze[t]} gen\
eration; vertical: ${t} generation`),d("p",{class:"small numbers"},r)),update:w}}var Ve={left:46,right:12,top:10,bottom:42},hn={x:56,y:34};function Ke(e,t,r,n){let[o,s]=[Ve.left,Ve.top],a=Math.max(o+40,e-Ve.right),i=Math.max(s+40,t-Ve.bottom),
l=(h,v,w)=>S=>v+(S-h.low)/(h.high-h.low||1)*(w-v),[c,u]=[l(r,o,a),l(n,i,s)],m=y("g"),p=y("svg",{width:e,height:t,viewBox:`0 0 ${e} ${t}`,class:"plot"}),f=y("g",
{class:"axes"});for(let h of ge(n.low,n.high,(i-s)/hn.y,n.whole))f.append(y("line",{x1:o,x2:a,y1:u(h),y2:u(h),class:"grid"}),y("text",{x:o-8,y:u(h),"text-anchor":"\
end","dominant-baseline":"middle"},fn(h)));for(let h of ge(r.low,r.high,(a-o)/hn.x,r.whole))f.append(y("text",{x:c(h),y:i+16,"text-anchor":"middle"},fn(h)));return f.
append(y("line",{x1:o,x2:a,y1:i,y2:i,class:"axis"}),y("text",{x:(o+a)/2,y:t-6,"text-anchor":"middle",class:"label"},r.label),y("text",{transform:`translate(12 ${(s+
i)/2}) rotate(-90)`,"text-anchor":"middle",class:"label"},n.label)),p.append(f,m),{root:p,marks:m,left:o,right:a,top:s,bottom:i,x:c,y:u,at:h=>{let v=h-p.getBoundingClientRect().
left;return r.low+(v-o)/(a-o)*(r.high-r.low)}}}var fn=e=>String(Number(e.toPrecision(6))).replace("-","−");function Se(e,t,r,n){let o="",s="M";r.forEach((i,l)=>{
i===null?s="M":(o+=`${s}${e.x(t[l]).toFixed(1)} ${e.y(i).toFixed(1)}`,s="L")});let a=y("path",{d:o,class:`line ${n}`});return e.root.insertBefore(a,e.marks),a}function Me(e,t,r,n=null){let o=e.x(t);e.marks.append(y("line",{x1:o,x2:o,y1:e.top,y2:e.bottom,class:`mark ${r}`})),n!==null&&e.marks.append(y("circle",{cx:o,cy:e.
y(n),r:5,class:`dot ${r}`}))}function St(...e){return d("p",{class:"legend small"},...e.map(([t,r])=>d("span",{class:`key ${r}`},t)))}function Ye(e,t,r={}){let n=d(
"div",{class:"chart",role:"img","aria-label":e}),o=null,s=()=>{o?.marks.replaceChildren(),o&&r.marks?.(o)},a=()=>{let{clientWidth:i,clientHeight:l}=n;i<50||l<50||
(o=t(i,l),n.replaceChildren(o.root),s())};return n.addEventListener("pointermove",i=>r.point?.(o?.at(i.clientX)??null)),n.addEventListener("pointerleave",()=>r.
point?.(null)),r.choose&&(n.classList.add("chooses"),n.addEventListener("click",i=>o&&r.choose?.(o.at(i.clientX),o,i))),new ResizeObserver(a).observe(n),{element:n,
redraw:a,remark:s}}var Mt=["of-pursuers","of-evaders","of-both"],cs=2500,gn="Arrow keys choose generations.",yn={low:0,high:1,label:"capture rate"};function bn(e,t){let{training:r}=e,
{capture_rate:n,generation:o,learner:s,epochs:a}=r,i=n.map((g,h)=>(h+1)*a),l=ds(n,r.window),c=i.at(-1)??1,u=i.length>cs?"dense":"",m=(g,h)=>{let v=o.flatMap((w,S)=>w===
g&&(s[S]===h||s[S]===2)?[S]:[]);return v.length?[i[v[0]],i[v.at(-1)]]:null},p=Ye(`Capture rate in ${c} epochs of training. ${gn}`,(g,h)=>{let v=Ke(g,h,{low:0,high:c,
label:"epoch",whole:!0},yn);for(let[w,S]of[["raw",n],[u,l]])for(let[b,x]of Mt.entries()){let C=S.map((F,At)=>s[At]===b||s[At+1]===b?F:null);C.some(F=>F!==null)&&
Se(v,i,C,`${x} ${w}`)}return v},{marks:g=>{let{pursuer:h,evader:v}=t.selected;for(let[w,S]of[[0,h],[1,v]]){let b=m(t.hover[w?"evader":"pursuer"]??S,w);b&&Me(g,(b[0]+
b[1])/2,Mt[w])}},choose:g=>{let h=Math.min(i.length-1,Math.max(0,Math.round(g/a)-1)),v=o[h];s[h]!==1&&t.select({pursuer:Math.min(v,e.payoff.shape[0]-1)}),s[h]!==
0&&t.select({evader:Math.min(v,e.payoff.shape[1]-1)})}});j(p.element,t,()=>e.payoff.shape);let f=[...new Set(s)].sort().map(g=>[["pursuers learn","evaders learn",
"both teams learn"][g],Mt[g]]);return{element:T("Training",`${zr(r.matches)} training matches. Lines: the generations that are selected.`,St(...f),p.element),update:p.
remark}}function vn(e,t){let r=e.findings?.lags;if(!r)return null;let[n,o]=[r.lags[0],r.lags.at(-1)],s=Math.min(5,(Math.max(...r.cells)+1)/2),a=r.means.map((l,c)=>r.
cells[c]>=s?l:null),i=Ye("Lag profile",(l,c)=>{let u=Ke(l,c,{low:n,high:o,label:"lag: pursuer minus evader generation",whole:!0},yn);return Se(u,r.lags,r.means,
"raw ink"),Se(u,r.lags,a,"ink"),u},{marks:l=>{let{pursuer:c,evader:u}=t.selected;Me(l,0,"zero");let m=t.hover.lag??c-u;Me(l,m,"ink",r.means[m-n])},point:l=>{let c=l===
null?null:Math.round(l);t.point({lag:c!==null&&c>=n&&c<=o?c:null})}});return{element:T("Lag profile","Left: evaders are later. Right: pursuers are later. It ris\
es if both teams keep what they learn. Faint: fewer than 5 cells.",i.element),update:i.remark}}function wn(e,t){let r=e.findings?.ratings;if(!r)return null;let n={
pursuer:r.pursuers,evader:r.evaders},o=[...r.pursuers,...r.evaders].map(u=>u??0),[s,a]=[Math.min(...o),Math.max(...o)],i=.06*(a-s||1),l=Math.max(...e.payoff.shape)-
1,c=Ye(`Elo ratings by generation. ${gn}`,(u,m)=>{let p=Ke(u,m,{low:0,high:l,label:"generation",whole:!0},{low:s-i,high:a+i,label:"Elo points"});for(let f of["p\
ursuer","evader"])Se(p,n[f].map((g,h)=>h),n[f],`of-${f}s`);return p},{marks:u=>{for(let m of["pursuer","evader"]){let p=t.hover[m]??t.selected[m];Me(u,p,`of-${m}\
s`,n[m][p]??null)}},choose:(u,m,p)=>{let f=Math.round(u),g=p.clientY-m.root.getBoundingClientRect().top,h=w=>Math.abs(m.y(n[w][f]??1/0)-g),v=h("pursuer")<=h("ev\
ader")?"pursuer":"evader";f>=0&&f<n[v].length&&t.select({[v]:f})}});return j(c.element,t,()=>e.payoff.shape),{element:T("Ratings",`One number for each generatio\
n, which cycles do not fit. The game itself: ${A(r.offset,0)} points for the pursuers.`,St(["pursuers","of-pursuers"],["evaders","of-evaders"]),c.element),update:c.
remark}}function ds(e,t){let r=[0];for(let n of e)r.push(r.at(-1)+n);return e.map((n,o)=>{let[s,a]=[Math.max(0,o-Math.floor((t-1)/2)),Math.min(e.length,o+Math.floor(
t/2)+1)];return(r[a]-r[s])/(a-s)})}var us={present:"●",absent:"○","cannot tell":"?"};function xn(e){let{findings:t}=e;if(!t)return null;let[,...r]=t.table,n=new Map(t.reasons.map(a=>{let[i,,l]=ms(
a);return[i,l]})),o=r.map(([a,i,l,c])=>{let u=c===t.window?n.get(a):void 0;return d("li",{class:`finding ${i.replace(" ","-")}`},d("span",{class:"sign","aria-hi\
dden":"true"},us[i]??""),d("div",{},d("p",{},d("strong",{},a),` ${i}`,d("span",{class:"muted"},` · ${c}`)),u?d("p",{class:"small"},`${u}.`):null,d("p",{class:"\
small muted numbers"},l)))}),s=T("What happened","Each condition is present, absent, or its 95 % interval cannot tell. The intervals are about this run.",d("p",
{class:"headline"},t.headline),...t.numbers.map(a=>d("p",{class:"numbers"},`${Sn(a)}.`)),d("ul",{class:"findings"},...o),e.limits?d("p",{class:"small"},e.limits):
null,d("details",{class:"small"},d("summary",{},"Headline numbers in words"),...t.description.map(a=>d("p",{},a)),ps(t)));return s.classList.add("diagnosis"),{element:s}}
function ms(e){let[t="",r=""]=e.split(/: (.*)/s),[n="",o=""]=r.split(/, because (.*)/s);return[t.toLowerCase(),n,Sn(o.replace(/\.$/,""))]}var Sn=e=>e.charAt(0).
toUpperCase()+e.slice(1);function ps({noise:e}){return e.transitive_share_noise===null?null:d("p",{},`Last half: transitive share ${A(e.transitive_share)} (an o\
rder of strength with the same noise rarely falls below ${A(e.transitive_share_noise)}), checkerboards ${bt(e.checkerboard_share)} (it rarely exceeds ${bt(e.checkerboard_share_noise)}\
).`)}function Mn(e){let t=[e.held_out?.pursuers,e.held_out?.evaders].filter(r=>r!=null);return t.length?{element:T("Held-out opponents",`The last generations against\
 opponents that no run has met; 95 % intervals over ${t[0].episodes} episodes.`,...t.map(hs))}:null}function hs(e){let t=n=>n.at(-1),r=[["mean",t(e.mean)],...Object.
entries(e.against).map(([n,o])=>[n,t(o)])];return d("table",{class:"scores numbers"},d("caption",{},d("span",{class:e.team},`${e.team}s`),` of generation ${e.generations.
at(-1)}, ${e.score}`),...r.map(([n,o],s)=>d("tr",{class:s?"":"mean"},d("th",{scope:"row"},n),d("td",{class:"range"},fs(o,e.team)),d("td",{},De(o.value,o.low,o.high)))))}
function fs({value:e,low:t,high:r},n){let o=d("span",{class:`between ${n}`});o.style.left=`${100*(t??e)}%`,o.style.width=`${100*((r??e)-(t??e))}%`;let s=d("span",
{class:`value ${n}`});return s.style.left=`${100*e}%`,d("span",{class:"scale","aria-hidden":"true"},o,s)}function An(e){let t=e.settings.filter(o=>o.changed),r=e.settings.filter(o=>!o.changed),n=T("Settings",`${e.schedule}, seed ${e.seed}. Every setting is an optio\
n of matrixworld evolve.`,t.length?En(t,"other than the default"):d("p",{class:"small"},"All settings are the defaults."),d("details",{class:"small"},d("summary",
{},`${r.length} settings with their defaults`),En(r,"defaults")));return n.classList.add("settings"),{element:n}}function En(e,t){return d("div",{class:"wide-ta\
ble"},d("table",{class:"small"},d("caption",{class:"heard"},`Settings: ${t}`),...e.map(({name:r,value:n,help:o})=>d("tr",{},d("th",{scope:"row"},`--${r.replaceAll(
"_","-")}`),d("td",{class:"numbers"},n),d("td",{class:"muted"},o)))))}function Tn(e,t,r){let n=new Map,o=d("div",{class:"panels"}),s=[],a=()=>s.forEach(l=>l.update?.()),i=()=>{let l=e[t.selected.run];s=n.get(l)??gs(l,t,r),n.set(l,
s),o.replaceChildren(...s.map(c=>c.element)),a()};return t.on("run",i),t.on("match",a),t.on("hover",a),i(),o}function gs(e,t,r){return[xn(e),bn(e,t),un(e,t,r),vn(
e,t),wn(e,t),pn(e,t),Mn(e),An(e)].filter(o=>o!==null)}var Cn={pursuer:null,evader:null,lag:null},qe=class extends EventTarget{#e;#n=Cn;constructor(t){super(),this.#e=t}get selected(){return this.#e}get hover(){return this.#n}select(t){
let r=this.#e,n=["run","pursuer","evader"].some(o=>o in t&&t[o]!==r[o]);this.#e={...r,...n?{episode:0,seed:null}:{},...t},this.#e.run!==r.run&&this.dispatchEvent(
new Event("run")),this.dispatchEvent(new Event("match"))}point(t){let r={...Cn,...t};r.pursuer===this.#n.pursuer&&r.evader===this.#n.evader&&r.lag===this.#n.lag||
(this.#n=r,this.dispatchEvent(new Event("hover")))}on(t,r){this.addEventListener(t,r)}};var U=rr(),{runs:O}=U,[ys,bs]=O[0].payoff.shape,vs=it(location.hash,O,{run:0,pursuer:ys-1,evader:bs-1,episode:0,seed:null}),{step:_n,...ws}=vs,I=new qe(ws),k=new je(
O,I,U.playground),kn=new Ge(O,I),Et=lr(),Xe=null,xs="Each cell is a match: pursuers of one generation against evaders of another. Bright: many are captured. Cli\
ck a cell to watch it.";document.getElementById("page").replaceWith(d("header",{class:"top"},d("div",{},d("h1",{},U.heading),d("p",{class:"lead"},xs)),d("div",{
class:"tools"},Zt(),d("button",{type:"button",class:"keys-button",title:"Keys (?)","aria-label":"Keys (?)",onclick:()=>Et.showModal()},"?"))),...U.note?[d("asid\
e",{class:"note small muted"},U.note)]:[],ir(O,I),d("main",{class:"stages"},kn.element,k.element),Tn(O,I,()=>Xe),d("footer",{class:"muted small"},`${U.title} · \
matrixworld ${U.version}`),Et);Object.assign(window,{matrixworldExplorer:{get match(){return k.match},get step(){return k.player.step},get pace(){return k.player.
pace},play:e=>Xe&&N(Xe,O[I.selected.run],{...I.selected,episode:e}),get shape(){return O[I.selected.run].payoff.shape}}});kn.element.addEventListener("play",()=>k.
playSoon());k.goTo(_n);_n||k.playSoon();Qt(O,I,k);cr(O,I,k,Et,()=>xt(k.shown,U.playground));requestAnimationFrame(()=>setTimeout(()=>{Xt().then(e=>{Xe=e,k.start(
e),document.body.dataset.ready="true"},e=>{k.element.prepend(d("p",{class:"problem",role:"alert"},`The engine does not start here: ${String(e)}`)),document.body.
dataset.ready="true"})}));})();
