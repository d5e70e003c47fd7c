/* built from web/ by "npm run build"; sources b913cd257b1a9ce9e7cc59416cdf56784242f9935f6210119e3ef7525a9df4d8 */
"use strict";(()=>{var Et={SIMULTANEOUS:0,SWARM_TURNS:1,AGENT_TURNS:2},re={DISAPPEAR:0,REACH:1,BOUNCE:2},At={OCCUPATION:0,SURROUND:1},Tt={FAULT:0,INVOLVED:1};var Ct=["obstacle","teammate","adversary"],Xe=["vertex","edge","chain"],_t=["turn","kind","form","first","second","row","col","at_fault","held","doomed"],Je=["p\
ursuer_{number}","evader_{number}"],Rt={obstacle:"{first} ran into the obstacle or border at {cell}",vertex:"{first} and {second} both headed for {cell}",edge:"\
{first} and {second} meant to swap, {first} to {cell}",chain:"{first} headed for {cell}, where {second} had to stay"},ne={"both held":"both bounce","both doomed":"\
both disappear",held:"{agent} bounces",doomed:"{agent} disappears",none:"nobody is stopped"},kt="{event}: {outcome}",Ze={random:"any action, all equally likely",
still:"always stays",chaser:"moves to where the nearest adversary in view is nearest",fleer:"moves to where the nearest adversary in view is farthest","clumsy-c\
haser":"a chaser that takes any action in half of the steps",hunter:"a chaser of the nearest adversary in view to which no teammate in view is nearer",surrounder:"\
a chaser of the nearest free cell beside an adversary without a teammate","clumsy-fleer":"a fleer that takes any action in half of the steps",dodger:"moves to w\
here all adversaries in view together are farthest"},$t={free:".GS",blocked:"#@OTW"};var z=1+_t.length;function oe(e,t){return e.replace(/\{(\w+)\}/g,(r,n)=>String(t[n]))}function Qe(e,t){return e<t?oe(Je[0],{number:e}):oe(Je[1],{number:e-t})}function An(e,t){
let[r,n,o,s,a,i,l,...c]=Array.from(e),u=a<0?[s]:[s,a],[m,p,f]=c.map(w=>u.filter((S,v)=>w>>v&1)),g=u.map(w=>Qe(w,t)),h=oe(Rt[a<0?"obstacle":Xe[o]],{first:g[0],second:g[g.
length-1],cell:`(${i}, ${l})`}),b=oe(kt,{event:h,outcome:Tn(u.length,p,f,t)});return{kind:Ct[n],form:Xe[o],agents:u,cell:[i,l],at_fault:m,held:p,doomed:f,turn:r,
text:b}}function Tn(e,t,r,n){if(e===2&&t.length===2)return ne["both held"];if(e===2&&r.length===2)return ne["both doomed"];let o=s=>a=>oe(ne[s],{agent:Qe(a,n)});
return[...t.map(o("held")),...r.map(o("doomed"))].join(", ")||ne.none}function Se(e,t){let r=[];for(let n=0;n<e.length;n+=z)r.push(An(e.subarray(n+1,n+z),t));return r}var F=class extends Error{name="EngineError"};function M(e,t,r){let n=typeof r=="string"?`'${r}'`:typeof r=="object"?JSON.stringify(r):String(r);return new F(`${e}\
: expected ${t}, got ${n}`)}var V=class{bytes;constructor(t){this.bytes=t}},Lt=0,tt=[Uint8Array,Uint8Array,Int32Array,BigInt64Array,BigUint64Array,Float32Array,Float64Array],Pt=4,Ot=4,Cn=new TextEncoder,
_n=new TextDecoder;function Rn(e){for(let t=tt.length-1;t>Lt;--t)if(e instanceof tt[t])return t;throw new TypeError("array: expected a typed array of the engine\
's numbers, got another")}function et(e){return new Uint8Array(e.buffer,e.byteOffset,e.byteLength)}function kn(e){return Cn.encode(`${e}\0`)}var rt=class{engine;addresses=[];constructor(t){
this.engine=t}copy(t){let r=this.engine._malloc(Math.max(t.length,1));if(r===0)throw new F("memory: expected room for the arguments, got none");return this.addresses.
push(r),this.engine.HEAPU8.set(t,r),r}text(t){return this.copy(kn(t))}arrays(t){let r=Object.entries(t),n=r.flatMap(([s,a])=>{let i=a instanceof V,l=i?a.bytes:a;
return[this.text(s),i?Lt:Rn(l),l.length,this.copy(et(l))]}),o=this.copy(et(Int32Array.from(n)));return this.copy(et(Int32Array.of(r.length,o)))}free(){for(let t of this.
addresses)this.engine._free(t)}};function Nt(e,t){let r=e.HEAPU8;return _n.decode(r.subarray(t,r.indexOf(0,t)))}function Me(e){let t=new Int32Array(e.HEAPU8.buffer),
r=e._last_outputs()/Pt,n=t[r+1]/Pt,o={};for(let s=n;s<n+t[r]*Ot;s+=Ot){let a=tt[t[s+1]],i=t[s+2]*a.BYTES_PER_ELEMENT,l=t[s+3];o[Nt(e,t[s])]=new a(e.HEAPU8.slice(
l,l+i).buffer)}return o}function se(e,t){let r=new rt(e);try{let n=t(r);if(n===0)throw new F(Nt(e,e._last_error()));return n}finally{r.free()}}var $n=2**31-1,Pn=2n**64n-1n,On=34028234663852886e22;function L(e,t){if(typeof t!="number"||!Number.isInteger(t)||Math.abs(t)>$n)throw M(e,"an integer",t);return Int32Array.
of(t)}function Ee(e,t){if(typeof t!="boolean")throw M(e,"true or false",t);return new V(Uint8Array.of(Number(t)))}function D(e,t,r){let n=typeof t=="string"&&Object.
hasOwn(r,t)?r[t]:void 0;if(n===void 0)throw M(e,`one of ${Object.keys(r).join(", ")}`,t);return Int32Array.of(n)}function nt(e,t){if(typeof t!="number"||!(Math.
abs(t)<=On))throw M(e,"a finite number",t);return t}function K(e,t){let n=typeof t=="bigint"||typeof t=="number"&&Number.isSafeInteger(t)?BigInt(t):-1n;if(n<0n||
n>Pn)throw M(e,"an integer from 0 to 2^64 - 1",t);return BigUint64Array.of(n)}function Ln(e){return{"rules.interaction":D("interaction",e.interaction,Et),"rules\
.obstacle":D("obstacle",e.obstacle,re),"rules.teammate":D("teammate",e.teammate,re),"rules.evader":D("evader",e.evader,re),"rules.pursuer":D("pursuer",e.pursuer,
re),"rules.capture":D("capture",e.capture,At),"rules.captured_disappear":Ee("captured_disappear",e.captured_disappear)}}function It(e,t){let r=typeof t=="number"?
[t,t,t]:t;if(!Array.isArray(r)||r.length!==3)throw M(e,"1 or 3 numbers",t);return Float32Array.from(r,n=>nt(e,n))}function Nn(e){let t=(r,n)=>Float32Array.of(nt(
r,e[r]),nt(n,e[n]));return{"rewards.capture":t("pursuer_capture","evader_capture"),"rewards.neighbor":t("pursuer_neighbor","evader_neighbor"),"rewards.step":t("\
pursuer_step","evader_step"),"rewards.pursuer_collide":It("pursuer_collide",e.pursuer_collide),"rewards.evader_collide":It("evader_collide",e.evader_collide),"r\
ewards.blame":D("blame",e.blame,Tt),"rewards.capture_repeats":Ee("capture_repeats",e.capture_repeats)}}function Ft(e){if(e===void 0||typeof e=="number")return new Uint8Array(
0);if(e instanceof Uint8Array)return e;let{free:t,blocked:r}=$t;for(let[n,o]of e.entries()){if(o.length!==e[0]?.length)throw M(`map, row ${n}`,`${e[0]?.length} \
cells as in row 0`,o.length);let s=[...o].find(a=>!t.includes(a)&&!r.includes(a));if(s)throw M(`map, row ${n}`,`'${t}' (free) or '${r}' (obstacle)`,s)}return Uint8Array.
from([...e.join("")],n=>Number(r.includes(n)))}function Dt(e,t){if(!Array.isArray(e))return;let r=[e.length,e[0]?.length??0];if(!(r[0]===t.rows&&r[1]===t.cols))
throw M("obstacle map",`shape (${t.rows}, ${t.cols}), the rows and cols`,r)}function Ae(e){Dt(e.obstacles,e);let t=typeof e.obstacles=="number"?e.obstacles:0;return{
...Ln(e.rules),...Nn(e.rewards),rows:L("rows",e.rows),cols:L("cols",e.cols),n_pursuers:L("n_pursuers",e.n_pursuers),n_evaders:L("n_evaders",e.n_evaders),fov:L("\
fov",e.fov),diagonal:Ee("diagonal",e.diagonal),max_steps:L("max_steps",e.max_steps),density:Float64Array.of(t),map:Ft(e.obstacles)}}function Ut(e,t){return Int32Array.
from((t??[]).flat(),r=>L(e,r)[0])}function Ht(e,t){return Dt(e.obstacles,t),{seed:K("seed",e.seed??0n),episode:K("episode",e.episode??0),pursuers:Ut("pursuers",
e.pursuers),evaders:Ut("evaders",e.evaders),map:Ft(e.obstacles)}}function Te(e){return{actions:Int32Array.from(e,t=>L("actions",t)[0])}}function Y(e){if(typeof e==
"string"){if(!Object.hasOwn(Ze,e))throw M("policy",`one of ${Object.keys(Ze).join(", ")}`,e);return{script:new TextEncoder().encode(e)}}if(e.activation!=="relu"&&
e.activation!=="tanh")throw M("activation","'relu' or 'tanh'",e.activation);return{hidden:Int32Array.from(e.hidden,t=>L("hidden",t)[0]),activation:new TextEncoder().
encode(e.activation),sampled:Ee("sampled",e.sampled),genome:e.genome}}var In=["first_turn","terminated","truncated"];function Bt(e){let t={...e};for(let r of In)
t[r]=new V(e[r]);return t}var Ce=class{config;seed;episode;n_agents;statistics;positions;last_positions;alive;captured;ever_captured;actions;rewards;involved;fault;map;conflict_table;first_conflict;constructor(t,r,n,o){
this.config=t,this.seed=r,this.episode=n,this.n_agents=t.n_pursuers+t.n_evaders,this.statistics=Wt(o,0),this.positions=o.positions,this.last_positions=o.last_positions,
this.alive=o.alive,this.captured=o.captured,this.ever_captured=o.ever_captured,this.actions=o.actions,this.rewards=o.rewards,this.involved=o.involved,this.fault=
o.fault,this.map=o.map,this.conflict_table=o.conflict_table,this.first_conflict=Un(this.conflict_table,this.length)}get length(){return this.actions.length/this.
n_agents}conflicts(t){this.check(t);let[r,n]=[this.first_conflict[t],this.first_conflict[t+1]],o=this.conflict_table.subarray(r*z,n*z);return Se(o,this.config.n_pursuers)}seek(t,r){
this.check(r),(!(t.seed===this.seed&&t.episode===BigInt(this.episode))||t.turn!==0||t.steps>r)&&t.reset({seed:this.seed,episode:this.episode});for(let o=t.steps;o<
r;++o)t.step(this.actions.subarray(o*this.n_agents,(o+1)*this.n_agents))}check(t){if(!(Number.isInteger(t)&&t>=0&&t<=this.length))throw M("step",`0 to ${this.length}`,
t)}};function Un(e,t){let r=new Int32Array(t+2);for(let n=0;n<e.length;n+=z)++r[e[n]+1];for(let n=1;n<r.length;++n)r[n]+=r[n-1];return r}function Wt(e,t){let r=e["\
statistics.length"].length,n=s=>{let a=e[`statistics.${s}`],i=a.length/r;return a.slice(t*i,(t+1)*i)},o=s=>Number(n(s)[0]);return{capture_rate:o("capture_rate"),
ever_capture_rate:o("ever_capture_rate"),captured_fraction:o("captured_fraction"),length:o("length"),return:n("return"),survivors:n("survivors"),overlap:n("over\
lap"),collisions:n("collisions"),faults:n("faults"),agent_steps:n("agent_steps")}}function jt(e,t,r,n){let o=[Ae(r.config),Y(r.pursuers),Y(r.evaders),n];return se(
e,s=>{let[a,i,l,c]=o.map(u=>s.arrays(u));return e[t](a,i,l,c)}),Me(e)}function Gt(e,t,r,n){let o={seed:K("seed",r),episode:K("episode",n)};return new Ce(t.config,
r,n,jt(e,"_play_match",t,o))}function zt(e,t,r,n){if(!Number.isInteger(n)||n<1)throw M("n_episodes","at least 1",n);let o={seed:K("seed",r),n_episodes:Int32Array.
of(n)},s=jt(e,"_play_rollout",t,o);return Array.from({length:n},(a,i)=>Wt(s,i))}var Vt=new FinalizationRegistry(([e,t])=>e._world_free(t)),ae=class{config;n_agents;n_actions;engine;at;freed=!1;constructor(t,r){this.engine=t,this.config=r,this.
n_agents=r.n_pursuers+r.n_evaders,this.n_actions=r.diagonal?9:5,this.at=se(t,n=>t._world_new(n.arrays(Ae(r)))),Vt.register(this,[t,this.at],this)}free(){this.freed||
(this.freed=!0,Vt.unregister(this),this.engine._world_free(this.at))}reset(t={}){let r=Ht(t,this.config);this.call(n=>this.engine._world_reset(this.at,n.arrays(
r)))}step(t){let r=Te(t);this.call(n=>this.engine._world_step(this.at,n.arrays(r)))}playTurn(t){let r=Te(t);this.call(n=>this.engine._world_play_turn(this.at,n.
arrays(r)))}decide(t,r,n){let{n_pursuers:o}=this.config,s=r==="pursuer"?[0,o]:[o,this.n_agents];return this.choose(t,s,n)}choose(t,[r,n],o){if(o.length!==this.n_agents)
throw M("actions",String(this.n_agents),o.length);let s=[Y(t),Te(o)],{actions:a}=this.call(i=>this.engine._world_decide(this.at,i.arrays(s[0]),r,n,i.arrays(s[1])));
return Uint8Array.from(a)}get n_turns(){return this.turnNumbers()[1]}get turn(){return this.turnNumbers()[0]}get actors(){let[,,t,r]=this.turnNumbers();return[t,
r]}turnNumbers(){return this.call(()=>this.engine._world_turn(this.at)).turn}get steps(){return this.read("steps")[0]}get seed(){return this.read("seed")[0]}get episode(){
return this.read("episode")[0]}get over(){return this.read("terminated")[0]===1||this.read("truncated")[0]===1}read(t){return this.call(r=>this.engine._world_read(
this.at,r.text(t)))[t]}view(t){let r=3*this.config.fov**2;return this.read("views").slice(t*r,(t+1)*r)}map(){return this.read("state").slice(2*this.config.rows*
this.config.cols)}conflicts(){let{conflict_table:t}=this.call(()=>this.engine._world_conflicts(this.at));return Se(t,this.config.n_pursuers)}answer(t,r){let n=Y(
t),{logits:o}=this.call(i=>this.engine._world_logits(this.at,i.arrays(n),r)),s=o,a=this.choose(t,[r,r+1],new Uint8Array(this.n_agents))[r];return{logits:s,probabilities:Fn(
s),action:a}}snapshot(){return this.call(()=>this.engine._world_snapshot(this.at))}restore(t){let r=Bt(t);this.call(n=>this.engine._world_restore(this.at,n.arrays(
r)))}call(t){if(this.freed)throw M("world","one that is in use","one that was freed");return se(this.engine,t),Me(this.engine)}};function Fn(e){let t=Math.max(...e),
r=Array.from(e,o=>Math.exp(o-t)),n=r.reduce((o,s)=>o+s,0);return Float32Array.from(r,o=>o/n)}var ot=class{compiled;constructor(t){this.compiled=t}world(t){return new ae(this.compiled,t)}match(t,r,n,o,s=0){return Gt(this.compiled,{config:t,pursuers:r,evaders:n},
o,s)}rollout(t,r,n,o,s){return zt(this.compiled,{config:t,pursuers:r,evaders:n},o,s)}},Kt;function Yt(e=globalThis.matrixworldEngine){return Kt??=Dn(e),Kt}async function Dn(e){
if(!e)throw new Error("matrixworldEngine: expected the script engine.js before this one, got none");let t=Uint8Array.from(atob(e.binary),r=>r.charCodeAt(0));return new ot(
await e({wasmBinary:t}))}var Hn="http://www.w3.org/2000/svg";function d(e,t={},...r){return qt(document.createElement(e),t,r)}function y(e,t={},...r){return qt(document.createElementNS(
Hn,e),t,r)}function qt(e,t,r){for(let[n,o]of Object.entries(t))o==null||o===!1||(typeof o=="function"?e.addEventListener(n.slice(2),o):e.setAttribute(n,o===!0?"":
String(o)));return e.append(...r.filter(Bn).map(n=>typeof n=="number"?String(n):n)),e}function Bn(e){return e!=null&&e!==!1}var Wn=matchMedia("(prefers-color-scheme: dark)");function jn(){let e=document.documentElement.dataset.theme;return e?e==="dark":Wn.matches}function st(){document.
documentElement.dataset.theme=jn()?"light":"dark"}function Xt(){return d("button",{type:"button",title:"Light or dark (D)","aria-label":"Light or dark",onclick:st},"◐")}var Gn=2n**64n-1n;function at(e,t,r){let n=new URLSearchParams(e.replace(/^#/,"")),o=(c,u,m)=>{let p=n.get(c)??"";return/^\d{1,9}$/.test(p)&&Number(p)<u?Number(
p):m},s=o("run",t.length,r.run),[a,i]=t[s].payoff.shape,l=n.get("seed")??"";return{run:s,pursuer:o("pursuers",a,Math.min(r.pursuer,a-1)),evader:o("evaders",i,Math.
min(r.evader,i-1)),episode:o("episode",1/0,r.episode),seed:/^\d{1,20}$/.test(l)&&BigInt(l)<=Gn?l:null,step:o("step",1/0,0)}}function Jt(e,t,r){let n="",o=()=>{let{
run:s,pursuer:a,evader:i,episode:l,seed:c}=t.selected,u={run:s,pursuers:a,evaders:i,episode:l,...c===null?{}:{seed:c},step:r.player.step};n=`#${Object.entries(u).
map(([m,p])=>`${m}=${p}`).join("&")}`;try{history.replaceState(null,"",n)}catch{}};t.on("match",o),r.player.addEventListener("state",()=>r.player.playing||o()),
r.player.addEventListener("step",()=>r.player.playing||o()),window.addEventListener("hashchange",()=>{if(location.hash===n)return;let{step:s,...a}=at(location.hash,
e,t.selected);t.select(a),r.goTo(s)})}var Qt=["pursuer","evader"];function er(){return JSON.parse(_e("data"))}function ie(e,t,r){let[n,o]=[t-e.payoff.first[0],r-e.payoff.first[1]],s=e.payoff.capture_rate[n]?.[o];
return s===void 0?null:{rate:s,rates:e.payoff.capture_rates[n][o],lengths:e.payoff.lengths[n][o]}}function le(e,t,r){let{script:n,network:o,kept:s,genomes:a}=e.
teams[t];if(n!==null||o===null)return"";if(!s.includes(r))return`The page holds no genome of ${t}s ${r}: it would be too large. Choose a generation of ${s.join(
", ")}.`;let i=s.length*o.genome_size;return tr(a).length===i?"":`The page is damaged: it does not hold the ${i} numbers of the ${t}s' genomes. Write it again f\
rom its run.`}function ce(e,t,r){let{script:n,network:o,kept:s,genomes:a}=e.teams[t];if(n!==null||o===null)return n??"random";let i=s.indexOf(r);if(i<0)throw new RangeError(
`${t}: expected a generation whose genome the page holds, got ${r}`);let l=o.genome_size,c=tr(a).subarray(i*l,(i+1)*l);return{hidden:o.hidden,activation:o.activation,
sampled:o.sampled,genome:c}}var Zt=new Map;function tr(e){let t=Zt.get(e);if(t)return t;let r=new Float32Array;try{let n=new Float32Array(it(e).buffer);n.every(
Number.isFinite)&&(r=n)}catch(n){if(!(n instanceof DOMException||n instanceof RangeError))throw n}return Zt.set(e,r),r}function it(e){let t=atob(_e(e)),r=new Uint8Array(
t.length);for(let n=0;n<r.length;n++)r[n]=t.charCodeAt(n);return r}function _e(e){return document.getElementById(e)?.textContent??""}var zn={now:()=>performance.now(),request:e=>requestAnimationFrame(e),cancel:e=>cancelAnimationFrame(e)},de=[.5,1,2,4,8,16,32,64],q=class extends EventTarget{#e;#n;#s;#a;#r=0;#t=0;#o=!1;#c=null;#d=0;glide=.28;constructor(t,r={}){
super(),this.#e=t,this.#n=r.speed??4,this.#a=r.still??!1,this.#s=r.clock??zn}get step(){return this.#r}get time(){return this.#a?this.#r:this.#t}get arrived(){return this.#t===
this.#r}get playing(){return this.#o}get length(){return this.#e}set length(t){this.#e=t,this.#r>t&&this.jump(t),this.#m("state")}get speed(){return this.#n}set speed(t){
this.#n=t,this.#m("state")}changeSpeed(t){let r=de.findIndex(n=>n>=this.#n);this.speed=de[Math.min(de.length-1,Math.max(0,r+t))]}play(){this.#o||!this.#e||(this.#r===
this.#e&&this.jump(0),this.#o=!0,this.#m("state"),this.#u())}pause(){this.#o&&(this.#o=!1,this.#m("state"))}toggle(){this.#o?this.pause():this.play()}move(t){this.
pause();let r=Math.min(this.#e,Math.max(0,this.#r+t));Math.abs(r-this.#t)>1?this.jump(r):this.#i(r),this.#u()}jump(t){this.#t=Math.min(this.#e,Math.max(0,Math.round(
t))),this.#i(this.#t),this.#m("frame")}#i(t){t!==this.#r&&(this.#r=t,this.#m("step"),this.#a&&this.#m("frame"))}#u(){this.#c===null&&(this.#d=this.#s.now(),this.#c=
this.#s.request(()=>this.#l()))}#l(){this.#c=null;let t=this.#s.now();this.#p(Math.min(.25,(t-this.#d)/1e3)),this.#d=t,(!this.#a||this.arrived)&&this.#m("frame"),
(this.#o||this.#t!==this.#r)&&(this.#c=this.#s.request(()=>this.#l()))}#p(t){let r=t;for(;r>0;){if(this.#t===this.#r){if(!this.#o)return;if(this.#r===this.#e)return this.
pause();this.#i(this.#r+1)}let n=this.#o?this.#n:1/this.glide,o=this.#r-this.#t,s=Math.min(Math.abs(o),r*n);r-=s/n,this.#t=s===Math.abs(o)?this.#r:this.#t+Math.
sign(o)*s}this.#o&&this.#t===this.#e&&this.pause()}#m(t){this.dispatchEvent(new Event(t))}};function X(e,t){if(t.ctrlKey||t.metaKey||t.altKey)return!1;let r=t.shiftKey?
10:1,o={" ":()=>e.toggle(),ArrowRight:()=>e.move(r),ArrowLeft:()=>e.move(-r),Home:()=>e.move(-e.length),End:()=>e.move(e.length),"+":()=>e.changeSpeed(1),"-":()=>e.
changeSpeed(-1)}[t.key];return o?.(),o!==void 0}var ue=[[68,1,84],[72,26,108],[71,47,125],[65,68,135],[57,86,140],[49,104,142],[42,120,142],[35,136,142],[31,152,139],[34,168,132],[53,183,121],[84,197,104],[122,
209,81],[165,219,54],[210,226,27],[253,231,37]];function J(e){let t=Math.min(1,Math.max(0,e))*(ue.length-1),r=Math.min(ue.length-2,Math.floor(t)),[n,o]=[ue[r],ue[r+
1]],s=a=>Math.round(n[a]+(t-r)*(o[a]-n[a]));return[s(0),s(1),s(2)]}function rr(e){let[t,r,n]=J(e).map(o=>((o/255+.055)/1.055)**2.4);return .2126*t+.7152*r+.0722*
n>.179?"#000":"#fff"}var nr=e=>`rgb(${J(e).join(" ")})`,or=()=>`linear-gradient(to right, ${ue.map(e=>`rgb(${e.join(" ")})`).join(", ")})`;function Re(e,t,r){let n=devicePixelRatio||1;e.style.left=`${r.left}px`,e.style.top=`${r.top}px`,e.style.width=`${r.width}px`,e.style.height=`${r.height}px`,e.width=
Math.round(r.width*n),e.height=Math.round(r.height*n);let o=e.getContext("2d"),s=Vn(t);!o||!s||(o.imageSmoothingEnabled=!1,o.drawImage(s,0,0,e.width,e.height))}
function Vn(e){let[t,r]=e.shape,n=document.createElement("canvas");[n.width,n.height]=[r,t];let o=n.getContext("2d");if(!o)return null;let s=o.createImageData(r,
t);return e.capture_rate.forEach((a,i)=>a.forEach((l,c)=>{let u=4*((t-1-i-e.first[0])*r+c+e.first[1]);s.data.set([...J(l),255],u)})),o.putImageData(s,0,0),n}var Kn=84;function sr(e,t){let r=e.map((s,a)=>Yn(s,a,t)),n=d("nav",{class:"races","aria-label":"Runs"},...r.map(s=>s.button)),o=()=>r.forEach((s,a)=>s.update(a===
t.selected.run));return t.on("match",o),t.on("hover",o),o(),n.hidden=e.length<2,n}function Yn(e,t,r){let[n,o]=e.payoff.shape,s=Kn/Math.max(n,o),a=d("canvas",{"a\
ria-hidden":"true"});Re(a,e.payoff,{left:0,top:0,width:o*s,height:n*s});let i=d("span",{class:"place"}),l=d("button",{type:"button",class:"race",title:`Key ${t+
1}`,onclick:()=>lt(e,t,r)},d("span",{class:"small-matrix"},a,i),d("span",{class:"race-text"},d("strong",{},e.name),d("span",{class:"small"},e.findings?e.findings.
headline:`${e.learning.join(" and ")}s against ${qn(e)}`),e.schedule===e.name?null:d("span",{class:"small muted"},`${e.schedule}, seed ${e.seed}`)));return{button:l,
update:u=>{l.setAttribute("aria-current",String(u));let m=r.hover.pursuer??r.selected.pursuer,p=r.hover.evader??r.selected.evader;i.hidden=m>=n||p>=o,i.style.left=
`${(p+.5)*s}px`,i.style.top=`${(n-m-.5)*s}px`}}}var qn=e=>e.teams.pursuer.script??e.teams.evader.script??"another run";function lt(e,t,r){let[n,o]=e.payoff.shape,
{pursuer:s,evader:a}=r.selected;r.select({run:t,pursuer:Math.min(s,n-1),evader:Math.min(a,o-1)})}var Xn=[[["Space"],"play or pause"],[["←","→"],"step back or forward; with Shift ten steps"],[["Home","End"],"first or last step"],[["+","−"],"faster or s\
lower"],[["N"],"next episode of the same pair; with Shift the one before"],[["R"],"another seed, not one of the evaluation"],[["O"],"the cell's own seed again"],
[["P"],"next pursuer generation; with Shift the one before"],[["E"],"next evader generation; with Shift the one before"],[["M"],"to the matrix: arrow keys choos\
e a match, Enter plays it"],[["A"],"next agent: what it sees; with Shift the one before"],[["Esc"],"no agent"],[["G"],"this step in the playground: any other ru\
les, actions and places"],[["1","9"],"first to ninth run"],[["D"],"light or dark"],[["?"],"this list"]];function ar(){let e=Xn.map(([r,n])=>d("div",{class:"key-\
row"},d("dt",{},...r.map(o=>d("kbd",{},o))),d("dd",{},n))),t=d("dialog",{class:"help","aria-labelledby":"help-title"},d("h2",{id:"help-title"},"Keys"),d("dl",{class:"\
keys"},...e),d("p",{class:"muted small"},"The page holds the genomes and the engine of this run. A click on a cell plays that very match: same seed, same moves.\
 Triangles pursue, discs evade; a ring is a captured evader, a star a capture, dashed cells are conflicts. The page loads nothing from elsewhere; share the file\
 as it is."),d("button",{type:"button",onclick:()=>t.close()},"Close"));return t.addEventListener("click",r=>r.target===t&&t.close()),t}function ir(e,t,r,n,o){let s=(i,l)=>()=>{
let c=e[t.selected.run].payoff.shape[i==="pursuer"?0:1];t.select({[i]:Math.min(c-1,Math.max(0,t.selected[i]+l))})},a={n:()=>t.select({episode:t.selected.episode+
1}),N:()=>t.select({episode:Math.max(0,t.selected.episode-1)}),r:()=>t.select({seed:String(crypto.getRandomValues(new BigUint64Array(1))[0]),episode:0}),o:()=>t.
select({seed:null,episode:0}),p:s("pursuer",1),P:s("pursuer",-1),e:s("evader",1),E:s("evader",-1),m:()=>document.getElementById("matrix")?.focus(),a:()=>r.inspector.
next(1),A:()=>r.inspector.next(-1),Escape:()=>r.inspector.choose(null),g:o,d:st,"?":()=>n.showModal()};document.addEventListener("keydown",i=>{let l=i.target instanceof
HTMLSelectElement||i.target instanceof HTMLInputElement,c=i.target instanceof HTMLButtonElement&&(i.key===" "||i.key==="Enter");if(document.querySelector("dialo\
g[open]")||l||c||i.defaultPrevented||i.ctrlKey||i.metaKey||i.altKey)return;let u=a[i.key]??a[i.key.toLowerCase()],m=Number(i.key)-1;if(X(r.player,i)||u)u?.();else if(e[m])
lt(e[m],m,t);else return;i.preventDefault()})}var ct=[[0,0],[-1,0],[0,1],[1,0],[0,-1],[-1,1],[1,1],[1,-1],[-1,-1]],H=(e,t)=>t<e.nPursuers,E=(e,t)=>[e.positions[2*t],e.positions[2*t+1]],Jn=(e,t)=>e[0]===t[0]&&
e[1]===t[1],dt=({rows:e,cols:t},[r,n])=>r>=0&&n>=0&&r<e&&n<t,ut=(e,t,r=3)=>e!==void 0&&[0,1,2].slice(0,r).some(n=>e[3*t+n]),mt=(e,t)=>ut(e.fault,t),lr=(e,t)=>!mt(
e,t)&&ut(e.involved,t,2);function ke(e,t,r){let n=!Jn(E(e,r),E(t,r)),o=t.involved===void 0||ut(t.involved,r);return!!(t.alive[r]&&t.actions?.[r]&&!n&&o)}function $e(e,t,r){
let[n,o]=E(e,r),[s,a]=ct[t.actions?.[r]??0];return[n+s,o+a]}function Pe(e,t,r){return Array.from({length:r.everCaptured.length},(o,s)=>s).filter(o=>r.everCaptured[o]&&
!t.everCaptured[o]).map(o=>e.nPursuers+o)}function Oe(e,t){return Array.from({length:t.alive.length},(n,o)=>o).filter(n=>e.alive[n]&&!t.alive[n])}var cr=[-.31,0,.31],dr=[{size:1,at:[[0,0]]},{size:.62,at:[[-.2,.2],[.2,-.2]]},{size:.54,at:[[-.23,.22],[.23,.22],[0,-.22]]},{size:.54,at:[[-.23,.23],[.23,.23],[
-.23,-.23],[.23,-.23]]},{size:.36,at:cr.flatMap(e=>cr.map(t=>[t,e]))}],Zn=.3,Qn=.35,eo=.55;function me(e,t){let r=new Map;for(let n=0;n<t.alive.length;n++){if(!t.
alive[n])continue;let[o,s]=E(t,n),a=o*e.cols+s,i=r.get(a);i?i.push(n):r.set(a,[n])}return r}function ur(e,t){let r=Array.from(t.alive,(n,o)=>{let[s,a]=E(t,o);return{
x:a+.5,y:s+.5,size:1,alpha:0}});for(let n of me(e,t).values()){let o=dr[Math.min(n.length,dr.length)-1];n.forEach((s,a)=>{let[i,l]=o.at[Math.min(a,o.at.length-1)],
c=r[s];c.x+=i,c.y+=l,c.size=o.size,c.alpha=1})}return r}var mr=e=>e*e*(3-2*e),Z=(e,t,r)=>e+(t-e)*r,pr=e=>Math.min(1,Math.max(0,e));function hr(e,t,r,n){let o={1:2,
2:r}[e.interaction]??1;if(o===1)return mr(n);let s=o===r?t:+!H(e,t),a=Math.max(1/o,Qn);return mr(pr((n-s/(o-1)*(1-a))/a))}function Le(e,t){let r=e.moments.length-
1,n=Math.min(Math.floor(t),r),o=e.moments[n],s=ur(e,o);if(n===r||t===n)return s;let a=e.moments[n+1],i=ur(e,a);return s.map((l,c)=>{let u=hr(e,c,s.length,t-n);return to(
o,a,c,l,i[c],u)})}function fr(e,t,r){let n=e.moments.length-1,o=Math.min(Math.floor(r),n),[s,a]=[e.moments[o],e.moments[Math.min(o+1,n)]],i=hr(e,t,s.alive.length,
r-o),[[l,c],[u,m]]=[E(s,t),E(a,t)];return[Z(c,m,i)+.5,Z(l,u,i)+.5]}function to(e,t,r,n,o,s){let a=n.alpha>o.alpha,i={x:Z(n.x,o.x,s),y:Z(n.y,o.y,s),size:a?n.size:
Z(n.size,o.size,s),alpha:a?pr((1-s)/(1-eo)):Z(n.alpha,o.alpha,s)};if(ke(e,t,r)){let[l,c]=E(e,r),[u,m]=$e(e,t,r),p=Zn*Math.sin(Math.PI*s);i.x+=(m-c)*p,i.y+=(u-l)*
p}return i}var gr=2*Math.PI;function B(e,t,r,n){e.beginPath(),e.arc(t,r,n/2,0,gr)}function Ne(e,t,r,n){let o=n/2,s=[[0,-.97],[.97,.83],[-.97,.83]].map(([a,i])=>[t+a*o,r+i*
o]);e.beginPath(),e.moveTo((s[2][0]+s[0][0])/2,(s[2][1]+s[0][1])/2),s.forEach(([a,i],l)=>{let[c,u]=s[(l+1)%3];e.arcTo(a,i,c,u,n*.09)}),e.closePath()}function yr(e,t,r,n){
let o=n*.32;e.beginPath(),e.moveTo(t-o,r-o),e.lineTo(t+o,r+o),e.moveTo(t+o,r-o),e.lineTo(t-o,r+o)}function br(e,t,r,n){e.beginPath();for(let o=0;o<16;o++){let s=n/
2*(o%2?.6:.95),a=gr*o/16;e.lineTo(t+s*Math.sin(a),r-s*Math.cos(a))}e.closePath()}function vr(e,t,r,n,o,s){let a=Math.atan2(o-r,n-t);e.beginPath(),e.moveTo(t,r),
e.lineTo(n,o);for(let i of[-1,1])e.moveTo(n,o),e.lineTo(n-s*Math.cos(a+i*.6),o-s*Math.sin(a+i*.6))}var wr=4,ro=1.6,no=.95,oo=5,so=.16,ao=9,io=.09,lo=.2,xr=.75,k=(e,t)=>e.left+t*e.cell,$=(e,t)=>e.top+t*e.cell;function Q(e,t,r){return H(t,r)?e.colors.pursuer:e.
colors.evader}function Sr({ctx:e,grid:t,colors:r}){let{left:n,top:o,cell:s,rows:a,cols:i}=t,[l,c]=[i*s,a*s];if(e.fillStyle=r.paper,e.fillRect(n,o,l,c),s<oo)return;
e.fillStyle=r.line;let u=Math.max(1,Math.round(s/60));for(let m=1;m<i;m++)e.fillRect(n+m*s,o,u,c);for(let m=1;m<a;m++)e.fillRect(n,o+m*s,l,u)}function Mr({ctx:e,
grid:t,colors:r},n){let{left:o,top:s,cell:a,rows:i,cols:l}=t;e.fillStyle=r.obstacle;for(let u=0;u<i*l;u++){if(!n.obstacles[u])continue;let[m,p]=[Math.floor(u/l),
u%l];e.fillRect(o+p*a,s+m*a,a,a)}let c=Math.min(5,Math.max(2,Math.round(a/18)));e.strokeStyle=r.frame,e.lineWidth=c,e.strokeRect(o-c/2,s-c/2,l*a+c,i*a+c)}function Er({
ctx:e,grid:t,colors:r},n){let{left:o,top:s,cell:a,rows:i,cols:l}=t,c=a<24*n?5:1;e.font=`500 ${Math.round(Math.min(15*n,Math.max(9*n,a*.32)))}px system-ui, sans-\
serif`,e.fillStyle=r.muted,e.textBaseline="alphabetic",e.textAlign="center";let u=5*n+a/40;for(let m=0;m<l;m+=c)e.fillText(String(m),o+(m+.5)*a,s-u);e.textAlign=
"right",e.textBaseline="middle";for(let m=0;m<i;m+=c)e.fillText(String(m),o-u,s+(m+.5)*a)}function Ar(e,t,r,n,o){let{ctx:s,grid:a}=e,i=Math.floor(t.fov/2)+.5,[l,
c]=[Math.max(0,n-i),Math.min(a.cols,n+i)],[u,m]=[Math.max(0,o-i),Math.min(a.rows,o+i)],p=[k(a,l),$(a,u),(c-l)*a.cell,(m-u)*a.cell],f=Q(e,t,r);s.globalAlpha=.11,
s.fillStyle=f,s.fillRect(...p),s.globalAlpha=.8,s.strokeStyle=f,s.lineWidth=Math.max(1,a.cell/24),s.strokeRect(...p),s.globalAlpha=1}function Tr(e,t,r,n,o){let{
ctx:s,grid:a}=e,i=Math.min(Math.ceil(r),t.moments.length-1),l=t.moments[i];s.lineCap="round",s.lineWidth=Math.min(ao,Math.max(1,a.cell*so));for(let c=Math.max(1,
Math.floor(r-n)+1);c<=i;c++){let[u,m]=[t.moments[c-1],t.moments[c]],p=Math.max(0,Math.min(1,(r-c)/n));s.globalAlpha=xr+(lo-xr)*p;for(let f=0;f<m.alive.length;f++){
let g=c===i&&r<i;if(!u.alive[f]||!(l.alive[f]||g))continue;let h=(H(t,f)?-1:1)*io,[b,w]=E(u,f),[S,v]=E(m,f);if(b===S&&w===v)continue;let x=g?o[f].x:v+.5,C=g?o[f].
y:S+.5;s.strokeStyle=Q(e,t,f),s.beginPath(),s.moveTo(k(a,w+.5+h),$(a,b+.5+h)),s.lineTo(k(a,x+h),$(a,C+h)),s.stroke()}}s.globalAlpha=1}function Cr(e,t,r){let n=Math.
min(Math.ceil(r),t.moments.length-1);for(let o=Math.max(1,n-wr+1);o<=n;o++){let[s,a]=[t.moments[o-1],t.moments[o]],i=o>r?Math.max(0,1-2*(o-r)):1-(r-o)/wr,l=Pe(t,
s,a);for(let c of Oe(s,a))l.includes(c)||uo(e,E(a,c),i);for(let c of l)co(e,E(a,c),i)}e.ctx.globalAlpha=1}function co({ctx:e,grid:t,colors:r},[n,o],s){e.globalAlpha=
s,br(e,k(t,o+.5),$(t,n+.5),Math.max(8,t.cell*ro)),e.fillStyle=r.capture,e.fill(),e.strokeStyle=r.ink,e.lineWidth=Math.max(1,t.cell/36),e.lineJoin="round",e.stroke()}
function uo({ctx:e,grid:t,colors:r},[n,o],s){e.globalAlpha=s,yr(e,k(t,o+.5),$(t,n+.5),Math.max(7,t.cell*no)),e.strokeStyle=r.collision,e.lineWidth=Math.max(2,t.
cell*.17),e.lineCap="round",e.stroke()}function _r({ctx:e,grid:t,colors:r},n,o){let s=Math.max(1,t.cell*.07);e.strokeStyle=e.fillStyle=r.collision,e.lineWidth=Math.
max(1,t.cell*.05),e.setLineDash([t.cell*.14,t.cell*.1]);for(let[a,i]of n){if(a<0||i<0||a>=t.rows||i>=t.cols)continue;let l=[k(t,i)+s,$(t,a)+s,t.cell-2*s,t.cell-
2*s];e.globalAlpha=.2*o,e.fillRect(...l),e.globalAlpha=o,e.strokeRect(...l)}e.setLineDash([]),e.globalAlpha=1}function Rr({ctx:e,grid:t,colors:r},n,o,s,a){e.globalAlpha=
a,B(e,k(t,n),$(t,o),Math.max(8,t.cell*s*1.02)),e.strokeStyle=r.collision,e.lineWidth=Math.max(1.5,t.cell*.085*Math.sqrt(s)),e.stroke(),e.globalAlpha=1}var mo=.8,po=.92,ho=15,fo=7,ft=9;function kr(e,t,r,n,o,s){n.forEach((a,i)=>{a.alpha>0&&go(e,t,r,i,a,o,s)}),e.ctx.globalAlpha=1;for(let a of me(t,r).values())a.length>
ft&&yo(e,n[a[ft-1]],a.length-ft+1)}function go(e,t,r,n,o,s,a){let{ctx:i,grid:l,colors:c}=e,u=H(t,n),[m,p]=[l.left+o.x*l.cell,l.top+o.y*l.cell],f=Math.max(4,l.cell*
o.size*(u?po:mo)),g=Q(e,t,n),h=!u&&!!r.captured[n-t.nPursuers];if(i.globalAlpha=o.alpha,(u?Ne:B)(i,m,p,f),f>fo*a&&(i.strokeStyle=c.paper,i.lineWidth=Math.max(2,
f*.1),i.stroke()),i.fillStyle=h?c.paper:g,i.fill(),h&&(B(i,m,p,f*.82),i.strokeStyle=g,i.lineWidth=f*.18,i.stroke()),!s||f<ho*a)return;let b=String(u?n:n-t.nPursuers);
i.font=`700 ${Math.round(f*(u?.4:.5)*(b.length>1?.8:1))}px system-ui, sans-serif`,i.textAlign="center",i.textBaseline="middle",i.fillStyle=h?g:c.paper,i.fillText(
b,m,p+f*(u?.17:.03))}function yo({ctx:e,grid:t,colors:r},n,o){let[s,a]=[t.left+n.x*t.cell,t.top+n.y*t.cell];e.font=`700 ${Math.round(t.cell*.3)}px system-ui, sa\
ns-serif`,e.textAlign="center",e.textBaseline="middle",e.strokeStyle=r.paper,e.lineWidth=t.cell*.1,e.strokeText(`+${o}`,s,a),e.fillStyle=r.ink,e.fillText(`+${o}`,
s,a)}var bo=.46,vo=.86,wo=.66,$r=.48,xo=.78,So=.58;function Pr(e,t,r,n){let[o,s]=[t.moments[r-1],t.moments[r]];if(!o)return;let{ctx:a,grid:i,colors:l}=e;a.strokeStyle=
l.collision,a.lineWidth=Math.max(1.5,i.cell*.07),a.lineCap="butt",a.globalAlpha=n;for(let c=0;c<s.alive.length;c++)ke(o,s,c)&&Mo(e,t,E(o,c),$e(o,s,c));a.globalAlpha=
1}function Mo({ctx:e,grid:t},r,n,o){let[s,a]=[o[1]-n[1],o[0]-n[0]],i=m=>k(t,n[1]+.5+s*m),l=m=>$(t,n[0]+.5+a*m),c=dt(r,o)?xo:So;e.setLineDash([t.cell*.09,t.cell*
.06]),e.beginPath(),e.moveTo(i($r),l($r)),e.lineTo(i(c),l(c)),e.stroke(),e.setLineDash([]);let u=.17*t.cell/Math.hypot(s,a);e.beginPath(),e.moveTo(i(c)-a*u,l(c)+
s*u),e.lineTo(i(c)+a*u,l(c)-s*u),e.stroke()}function Or(e,t,r,n,o,s){let a=ct[s];if(!s||!a)return;let{ctx:i,grid:l,colors:c}=e,u=dt(t,[n[0]+a[0],n[1]+a[1]])?vo:
wo,m=bo*o.size,p=[k(l,o.x+a[1]*m),$(l,o.y+a[0]*m),k(l,o.x+a[1]*u),$(l,o.y+a[0]*u)],f=Math.max(1.5,l.cell*.085);i.lineCap=i.lineJoin="round";for(let[g,h]of[[c.paper,
f*2.1],[Q(e,t,r),f]])i.strokeStyle=g,i.lineWidth=h,vr(i,...p,l.cell*.2),i.stroke()}var Nr={numbers:!0,axes:!1,trail:6,viewers:[],plan:null,selected:null,cursor:null};function Ir(e,t,r,n,o){let{ctx:s,grid:a,colors:i}=e,l=Math.min(Math.ceil(r),t.
moments.length-1),c=t.moments[l],u=r===l,m=Le(t,r),p=u?1:Math.max(0,1-2*(l-r));s.clearRect(0,0,s.canvas.width,s.canvas.height),Sr(e);for(let h of n.viewers)m[h]?.
alpha&&Ar(e,t,h,...fr(t,h,r));Mr(e,t),n.axes&&Er(e,o),Tr(e,t,r,n.trail,m),_r(e,c.contested??[],p),Cr(e,t,r),Pr(e,t,l,p),m.forEach(({x:h,y:b,size:w},S)=>{let v=lr(
c,S)?.4:0,x=mt(c,S)?1:v;x&&Rr(e,h,b,w,x*p)});let f=u?c:t.moments[Math.max(0,l-1)];if(kr(e,t,f,m,n.numbers,o),u&&n.plan)for(let[h,b]of m.entries())b.alpha&&Or(e,
t,h,E(c,h),b,n.plan[h]??0);s.lineWidth=Math.max(2,2.5*o),s.strokeStyle=i.focus;let g=n.selected===null?void 0:m[n.selected];g?.alpha&&Lr(e,g.x,g.y,g.size*.96),n.
cursor&&(s.setLineDash([a.cell*.12,a.cell*.08]),Lr(e,n.cursor[1]+.5,n.cursor[0]+.5,.8),s.setLineDash([]))}function Lr({ctx:e,grid:t},r,n,o){let s=o*t.cell;e.beginPath(),
e.roundRect(t.left+r*t.cell-s/2,t.top+n*t.cell-s/2,s,s,s*.1),e.stroke()}var Ur=(e,t)=>(t+.24)/(e+.24);function Fr(e,t,r,n,o,s){let a=r?28*s:0,i=(c,u)=>(c-a)/(u+2*.12),l=Math.max(1,Math.floor(Math.min(i(n,t),i(o,e))));return{rows:e,cols:t,
cell:l,left:Math.round((n-t*l+a)/2),top:Math.round((o-e*l+a)/2)}}function Dr(e,t,r){let n=Math.floor((r-e.top)/e.cell),o=Math.floor((t-e.left)/e.cell);return n>=
0&&n<e.rows&&o>=0&&o<e.cols?[n,o]:null}var Eo={paper:"--board-paper",line:"--board-line",frame:"--board-frame",ink:"--board-ink",muted:"--board-muted",obstacle:"--board-obstacle",pursuer:"--pursuer",
evader:"--evader",capture:"--capture",collision:"--collision",focus:"--focus"};function Ie(e){let t=getComputedStyle(e),r=Object.entries(Eo).map(([n,o])=>[n,t.getPropertyValue(
o).trim()]);return Object.fromEntries(r)}var te=()=>matchMedia("(prefers-reduced-motion: reduce)").matches,ee=class{canvas;#e=null;#n=0;#s;#a={rows:1,cols:1,left:0,top:0,cell:1};#r=0;#t;#o;constructor(t,r={}){
this.canvas=t,t.classList.add("board"),t.setAttribute("role","img"),this.#s={...Nr,...r},this.#t=new ResizeObserver(()=>this.#d()),this.#t.observe(t),this.#o=new MutationObserver(
()=>this.redraw()),this.#o.observe(document.documentElement,{attributes:!0}),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",this.redraw)}close(){
this.#t.disconnect(),this.#o.disconnect(),matchMedia("(prefers-color-scheme: dark)").removeEventListener("change",this.redraw),cancelAnimationFrame(this.#r)}get look(){
return this.#s}set look(t){this.#s={...this.#s,...t},this.#c(),this.redraw()}get time(){return this.#n}show(t,r){this.#e=t,this.#n=Math.min(Math.max(0,r),t.moments.
length-1),this.#c(),this.redraw()}redraw=()=>{this.#r||(this.#r=requestAnimationFrame(()=>this.drawNow()))};drawNow(){cancelAnimationFrame(this.#r),this.#r=0;let t=this.
canvas.getContext("2d");if(!t||!this.#e)return;let{rows:r,cols:n}=this.#e,o=devicePixelRatio||1;this.#a=Fr(r,n,this.#s.axes,this.canvas.width,this.canvas.height,
o);let s={ctx:t,grid:this.#a,colors:Ie(this.canvas)};Ir(s,this.#e,this.#n,this.#s,o)}cellAt(t,r){let n=this.canvas.getBoundingClientRect(),o=this.canvas.width/n.
width;return Dr(this.#a,(t-n.left)*o,(r-n.top)*o)}agentAt(t,r){let n=this.cellAt(t,r);if(!n||!this.#e)return null;let o=this.#e.moments[Math.round(this.#n)],s=me(
this.#e,o).get(n[0]*this.#e.cols+n[1])??[],a=Le(this.#e,Math.round(this.#n)),i=l=>{let[c,u]=this.pointOf(a[l].x,a[l].y);return Math.hypot(c-t,u-r)};return s.length?
s.reduce((l,c)=>i(c)<i(l)?c:l):null}pointOf(t,r){let n=this.canvas.getBoundingClientRect(),o=n.width/this.canvas.width,{left:s,top:a,cell:i}=this.#a;return[n.left+
(s+t*i)*o,n.top+(a+r*i)*o]}#c(){if(!this.#e)return;let{rows:t,cols:r}=this.#e;this.canvas.style.setProperty("--board-aspect",String(Ur(t,r)))}#d(){let t=devicePixelRatio||
1,{width:r,height:n}=this.canvas.getBoundingClientRect();this.canvas.width=Math.max(1,Math.round(r*t)),this.canvas.height=Math.max(1,Math.round(n*t)),this.drawNow()}};var To={SIMULTANEOUS:0,SWARM_TURNS:1,AGENT_TURNS:2};function Co(e,t,r){return{rows:e.rows,cols:e.cols,nPursuers:e.n_pursuers,fov:e.fov,interaction:To[e.rules.interaction],
obstacles:t,moments:r}}function Ue(e){let t=Array.from({length:e.length+1},(r,n)=>_o(e,n));return Co(e.config,e.map,t)}function _o(e,t){let r=e.n_agents,n=e.config.n_evaders,o=(a,i,l)=>a.
subarray(i*l,(i+1)*l),s={positions:o(e.last_positions,t,2*r),alive:o(e.alive,t,r),captured:o(e.captured,t,n),everCaptured:o(e.ever_captured,t,n)};return t===0?s:
{...s,actions:o(e.actions,t-1,r),involved:o(e.involved,t-1,3*r),fault:o(e.fault,t-1,3*r),get contested(){return e.conflicts(t).map(a=>a.cell)}}}var Ro={first:"M6 5v14M19 5 9 12l10 7z",back:"M17 5 7 12l10 7z",play:"M7 4.5 19 12 7 19.5z",pause:"M8 5v14M16 5v14",forward:"M7 5l10 7-10 7z",last:"M18 5v14M5 5\
l10 7-10 7z"};function Hr(e){let t=document.createElementNS("http://www.w3.org/2000/svg","svg");t.setAttribute("viewBox","0 0 24 24"),t.setAttribute("aria-hidde\
n","true"),t.classList.add("icon");let r=document.createElementNS("http://www.w3.org/2000/svg","path");return r.setAttribute("d",Ro[e]),t.append(r),t}function pe(e,t,r,n){
let o=document.createElement("button");return o.type="button",o.className="player-button",o.append(Hr(e)),o.ariaLabel=t,o.title=`${t} (${r})`,o.addEventListener(
"click",n),o}function Fe(e){let t=document.createElement("div");t.className="player",t.role="group",t.ariaLabel="Player";let r=pe("play","Play","Space",()=>e.toggle()),
n=ko(e),o=$o(e),s=document.createElement("output");s.className="player-count",t.append(pe("first","First step","Home",()=>e.move(-e.length)),pe("back","Step bac\
k","←",()=>e.move(-1)),r,pe("forward","Step forward","→",()=>e.move(1)),pe("last","Last step","End",()=>e.move(e.length)),n,s,o);let a=()=>{r.replaceChildren(
Hr(e.playing?"pause":"play")),r.ariaLabel=e.playing?"Pause":"Play",r.title=`${r.ariaLabel} (Space)`,n.max=String(e.length),n.value=String(e.step),n.ariaValueText=
`step ${e.step} of ${e.length}`,s.textContent=`${e.step} / ${e.length}`,s.style.minWidth=`${2*String(e.length).length+3}ch`,o.value=String(e.speed)};return e.addEventListener(
"step",a),e.addEventListener("state",a),t.addEventListener("keydown",i=>{!(i.target instanceof HTMLSelectElement||i.key===" "&&i.target!==n)&&X(e,i)&&i.preventDefault()}),
a(),t}function ko(e){let t=document.createElement("input");return t.type="range",t.className="player-scrub",t.min="0",t.step="1",t.ariaLabel="Step",t.addEventListener(
"input",()=>{e.pause(),e.jump(Number(t.value))}),t}function $o(e){let t=document.createElement("select");return t.className="player-speed",t.ariaLabel="Speed",t.
title="Steps a second (+ and -)",t.append(...de.map(r=>new Option(`${r} / s`,String(r)))),t.addEventListener("change",()=>{e.speed=Number(t.value)}),t}var A=(e,t=2)=>e==null?"-":e.toFixed(t),gt=(e,t=1)=>e==null?"-":`${(100*e).toFixed(t)} %`;function De(e,t,r,n=2){return t===null||r===null?e.toFixed(n):`${e.toFixed(
n)} (${t.toFixed(n)} to ${r.toFixed(n)})`}var Br=e=>e.toLocaleString("en-GB");function he(e,t,r,n=!1){let o=(t-e)/Math.max(1,r),s=10**Math.floor(Math.log10(o||1)),
a=[1,2,5,10].map(c=>c*s).find(c=>c>=o)??10*s;n&&(a=Math.max(1,Math.round(a)));let i=Math.ceil(e/a-1e-9),l=Math.floor(t/a+1e-9);return Array.from({length:Math.max(
0,l-i+1)},(c,u)=>(i+u)*a)}function I(e,t,{pursuer:r,evader:n,episode:o,seed:s}){let a=t.seeds[r][n];return e.match(t.world,ce(t,"pursuer",r),ce(t,"evader",n),BigInt(s??a),o)}var Wr=40,fe=new Map,ge=({run:e,pursuer:t,evader:r},n)=>`${e} ${t} ${r} ${n}`,He=class{element;#e;#n;#s=d("div",{class:"episodes",role:"group","aria-label":"Epi\
sodes of this cell"});#a=d("p",{class:"check small numbers","aria-live":"polite"});#r=0;constructor(t,r){[this.#e,this.#n]=[t,r],this.element=d("div",{class:"st\
rip-of-episodes"},this.#s,this.#a)}show(t,r,n){let{selected:o}=this.#e;o.seed===null&&fe.set(ge(o,o.episode),jr(n)),this.#o(r),Oo(this.#r),this.#t(t,r)}#t(t,r){
let{selected:n}=this.#e,s=ie(r,n.pursuer,n.evader)?.rates.findIndex((a,i)=>!fe.has(ge(n,i)))??-1;s<0||s>=Wr||(this.#r=Po(()=>{this.#e.selected===n&&(this.#n.playing||
(fe.set(ge(n,s),jr(I(t,r,{...n,episode:s,seed:null}))),this.#o(r)),this.#t(t,r))}))}#o(t){let{selected:r}=this.#e,n=ie(t,r.pursuer,r.evader);if(!n){this.#s.replaceChildren(),
this.#a.textContent="The evaluation played no episodes of this pair.";return}let o=Math.min(Wr,n.rates.length);this.#s.replaceChildren(...n.rates.slice(0,o).map(
(c,u)=>this.#c(c,u)));let s=n.rates.slice(0,o).map((c,u)=>fe.get(ge(r,u))),a=s.filter(c=>c!==void 0),i=s.flatMap((c,u)=>c&&(Math.abs(c.rate-n.rates[u])>1e-6||c.
length!==n.lengths[u])?[u+1]:[]),l=a.reduce((c,u)=>c+u.rate,0)/a.length;this.#a.dataset.equal=String(!i.length&&a.length===n.rates.length),this.#a.textContent=i.
length?`Episode ${i.join(", ")} differs from the evaluation.`:a.length<n.rates.length?`Played here: ${a.length} of ${n.rates.length} episodes, all as in the eva\
luation.`:`Played here: all ${a.length} episodes, mean capture rate ${A(l,3)}. The cell says ${A(n.rate,3)}.`}#c(t,r){let{selected:n}=this.#e,o=d("span",{class:"\
bar"});return o.style.height=`${Math.round(100*t)}%`,d("button",{type:"button",class:"episode",title:`Episode ${r+1}: capture rate ${A(t)}`,"aria-label":`Episod\
e ${r+1}, capture rate ${A(t)}`,"aria-pressed":String(r===n.episode&&n.seed===null),"data-played":fe.has(ge(n,r)),onclick:()=>this.#e.select({episode:r,seed:null})},
o,d("span",{class:"count"},r+1))}},jr=e=>({rate:e.statistics.capture_rate,length:e.length}),Po=e=>"requestIdleCallback"in window?requestIdleCallback(e,{timeout:1e3}):
setTimeout(e,100),Oo=e=>"cancelIdleCallback"in window?cancelIdleCallback(e):clearTimeout(e);var ye=(e,t)=>e<t?`pursuer_${e}`:`evader_${e-t}`,yt=["stay","north","east","south","west","northeast","southeast","southwest","northwest"];var Gr=0,zr=1,Lo=2,No=176;function Kr(e,t,r,n){let o=devicePixelRatio||1,s=Ie(e);e.width=e.height=No*o;let a=e.getContext("2d");if(!a)return;let{fov:i}=t,l=e.width/
i;a.fillStyle=s.paper,a.fillRect(0,0,e.width,e.height);for(let u=0;r&&u<i*i;u++){let[m,p]=[(u%i+.5)*l,(Math.floor(u/i)+.5)*l],f=h=>!!r[h*i*i+u];f(Lo)&&(a.fillStyle=
s.obstacle,a.fillRect(m-l/2,p-l/2,l,l));let g=f(Gr)&&f(zr)?l*.18:0;f(Gr)&&Vr(a,B,m+g,p+g,l*.74,s.evader),f(zr)&&Vr(a,Ne,m-g,p-g,l*.86,s.pursuer)}a.strokeStyle=n<
t.n_pursuers?s.pursuer:s.evader,a.lineWidth=2*o;let c=Math.floor(i/2)*l;a.strokeRect(c,c,l,l)}function Vr(e,t,r,n,o,s){t(e,r,n,o),e.fillStyle=s,e.fill()}var Be=class{element;#e;#n=d("canvas",{class:"seen",role:"img"});#s=d("h3");#a=d("p",{class:"small muted"});#r=d("div",{class:"answers"});#t=null;#o=null;#c=null;#d=null;#i=null;#u=0;constructor(t){
this.#e=t,this.element=d("div",{class:"inspector","data-open":"false"},d("p",{class:"hint small muted"},"Click an agent, or press A: what it sees, and what its \
network answers."),d("div",{class:"inspected"},this.#n,d("div",{class:"answer"},this.#s,this.#a),this.#r))}get agent(){return this.#i}show(t,r,n,o){(this.#o!==r||
!this.#t)&&(this.#t?.free(),this.#t=t.world(r.world),this.#i!==null&&this.#o!==r&&this.choose(null)),[this.#o,this.#c,this.#d]=[r,n,o]}choose(t){this.#i=t,this.
element.dataset.open=String(t!==null),this.#e(t),this.at(this.#u)}next(t){let r=this.#c;if(!r)return;let n=this.#i??(t>0?-1:0);for(let o=0;o<r.n_agents;o++)if(n=
(n+t+r.n_agents)%r.n_agents,r.alive[this.#u*r.n_agents+n])return this.choose(n)}at(t){this.#u=t;let[r,n,o,s,a]=[this.#c,this.#t,this.#o,this.#d,this.#i];if(!r||
!n||!o||!s||a===null)return;let i=a<r.config.n_pursuers?"pursuer":"evader";this.#s.replaceChildren(d("span",{class:i},ye(a,r.config.n_pursuers)));let l=!!r.alive[t*
r.n_agents+a];r.seek(n,t),Kr(this.#n,r.config,l?n.view(a):null,a),this.#n.ariaLabel=`Field of view of ${ye(a,r.config.n_pursuers)}: evaders, pursuers and obstac\
les around it`;let c=t<r.length?r.actions[t*r.n_agents+a]:null;if(!l)return this.#l([],"It is gone.");let u=ce(o,i,s[i]);if(typeof u=="string")return this.#l([],
`The script "${u}" plays for it${c===null?"":`; it goes ${yt[c]}`}.`);let{probabilities:m}=n.answer(u,a),p=Array.from(m,(g,h)=>Io(yt[h],g,h===c)),f=u.sampled?"I\
ts action is drawn from these probabilities.":"It takes the most probable action.";this.#l(p,c===null?"The episode is over.":f)}#l(t,r){this.#r.replaceChildren(
...t),this.#a.textContent=r}};function Io(e,t,r){let n=d("span",{class:"filled"});return n.style.width=`${100*t}%`,d("div",{class:r?"action taken":"action"},d("\
span",{},e),d("span",{class:"track"},n),d("span",{class:"numbers"},t.toFixed(2)))}var Uo=(e,t)=>Object.keys(e).every(r=>e[r]===t[r]);function Yr(e,t){return Object.keys(t).find(r=>Uo(t[r],e))??null}var be="_",di=2n**64n-1n;var bt={fov:11,maxSteps:500,rewards:"paper"},Do=["rules","others","rewards","size","diagonal","fov","limit","seed","ended","walls","pursuers","evaders","played",
"next"];function Qr(e,t){let r=i=>i.map(l=>Bo(l,t)).join(""),n=i=>`${Math.floor(i/e.cols)}.${i%e.cols}`,o=Ho(e.rewards,t),s=[e.seed,e.episode,e.steps].join("."),a={rules:Xr(
e.rules,t),others:e.others?Xr(e.others,t):"",rewards:o===bt.rewards?"":o,size:`${e.rows}x${e.cols}`,diagonal:e.diagonal?"1":"",fov:e.fov===bt.fov?"":String(e.fov),
limit:e.maxSteps===bt.maxSteps?"":String(e.maxSteps),seed:s==="0.0.0"?"":s,ended:e.ended?"1":"",walls:e.walls.map(n).join(be),pursuers:e.pursuers.map(qr).join(be),
evaders:e.evaders.map(qr).join(be),played:e.played.map(r).join(be),next:e.next.every(i=>i===0)?"":r(e.next)};return Do.filter(i=>a[i]).map(i=>`${i}=${a[i]}`).join(
"&")}function qr({cell:e,gone:t,captured:r,everCaptured:n}){let o=r?"c":n?"e":"";return`${e[0]}.${e[1]}${o}${t?"x":""}`}function Xr(e,t){let r=t.fields.map(({name:n})=>String(
e[n]).toLowerCase());return Yr(e,t.variants)??r.join(".")}function Ho(e,t){let r=JSON.stringify(e);return Object.keys(t.rewards).find(o=>JSON.stringify(t.rewards[o])===
r)??Object.values(e).map(o=>String(o)).join(be)}function Bo(e,t){if(typeof e=="number")return String(e);let r=t.scripts.findIndex(({name:n})=>n===e);return String.
fromCharCode(97+r)}var Wo="/* the engine */";function en(e,t){return d("button",{type:"button",class:"to-playground",title:"Open this step in the playground (G): the same agents a\
nd actions under any rules",onclick:()=>vt(e(),t)},"What if? Playground")}function vt(e,t){let n=e!==null&&e.match.n_agents<=100&&Math.max(e.match.config.rows,e.
match.config.cols)<=64?Qr(jo(e.match,e.step),t):"",o=new TextDecoder().decode(it("playground")).replace(Wo,()=>_e("script-engine"));window.open(`${URL.createObjectURL(
new Blob([o],{type:"text/html"}))}#${n}`)}function jo(e,t){let{config:r,n_agents:n}=e,o=Math.max(0,t-1),s=i=>{let l=o*n+i,c=o*r.n_evaders+i-r.n_pursuers,u=m=>i>=
r.n_pursuers&&!!m[c];return{cell:[e.last_positions[2*l],e.last_positions[2*l+1]],gone:!e.alive[l],captured:u(e.captured),everCaptured:u(e.ever_captured)}},a=Array.
from({length:n},(i,l)=>s(l));return{rules:r.rules,others:null,rewards:r.rewards,rows:r.rows,cols:r.cols,diagonal:r.diagonal,fov:r.fov,maxSteps:r.max_steps,seed:e.
seed,episode:BigInt(e.episode),steps:o,ended:o===e.length,walls:Array.from(e.map.keys()).filter(i=>e.map[i]),pursuers:a.slice(0,r.n_pursuers),evaders:a.slice(r.
n_pursuers),played:[],next:Array.from(e.actions.subarray(o*n,(o+1)*n))}}function tn(e,t,r){if(r===0)return[{kind:"start",text:Go(e),agents:[]}];let[n,o]=[t.moments[r-1],t.moments[r]],s=u=>ye(u,e.config.n_pursuers),a=Pe(t,n,o),i=e.conflicts(
r),l=new Set(i.flatMap(u=>u.doomed)),c=a.map(u=>({kind:"capture",text:`${s(u)} is captured`,agents:[u]}));for(let u of Oe(n,o))!a.includes(u)&&!l.has(u)&&c.push(
{kind:"end",text:`${s(u)} disappears`,agents:[u]});return c.push(...i.map(({kind:u,text:m,agents:p})=>({kind:u,text:m,agents:p}))),r===e.length&&c.unshift({kind:"\
end",text:zo(e),agents:[]}),c}function Go({config:e}){return`${e.n_pursuers} pursuers and ${e.n_evaders} evaders on ${e.rows} x ${e.cols} cells, at most ${e.max_steps}\
 steps`}function zo(e){let t=Math.round(e.statistics.capture_rate*e.config.n_evaders);return`The episode ends after ${e.length} steps with ${t} of ${e.config.n_evaders}\
 evaders captured`}var Vo=60,We=class{element;player=new q(0,{speed:8,still:te()});inspector;#e;#n;#s;#a;#r=d("h2",{class:"match-title"});#t=d("p",{class:"tally numbers"});#o=d("o\
l",{class:"words","aria-live":"off","aria-label":"What happened in this step"});#c=d("p",{class:"problem",role:"alert"});#d=null;#i=null;#u=null;#l=0;#p=!1;#m=0;constructor(t,r,n){
[this.#n,this.#s]=[t,r];let o=d("canvas",{"aria-label":"The match"});this.#e=new ee(o,{numbers:!1}),this.#a=new He(r,this.player),this.inspector=new Be(s=>this.#x(
s)),o.addEventListener("click",s=>this.inspector.choose(this.#e.agentAt(s.clientX,s.clientY))),this.element=d("section",{class:"card match-card","aria-label":"M\
atch",id:"match"},d("div",{class:"match"},d("header",{class:"match-head"},this.#r,this.#t),this.#c,d("div",{class:"stage"},o),d("div",{class:"aside"},this.#o,en(
()=>this.shown,n),this.inspector.element),Fe(this.player),this.#a.element)),this.player.addEventListener("frame",()=>this.#u&&this.#e.show(this.#u,this.player.time)),
this.player.addEventListener("step",()=>this.#v()),r.on("match",()=>this.#b()),this.#g(),this.#w(0,0)}get#h(){return this.#n[this.#s.selected.run]}get match(){return this.#i}get shown(){
return this.#i&&{match:this.#i,step:this.player.step}}start(t){this.#d=t,this.#y()}playSoon(){this.#p=!0,this.#l||this.#f()}goTo(t){this.#m=t,!this.#l&&this.#i&&
this.#y()}#f(){!this.#p||!this.#i||(this.#p=!1,this.player.jump(0),te()||this.player.play())}#b(){this.#g(),clearTimeout(this.#l),this.#l=setTimeout(()=>this.#y(),
Vo)}#y(){clearTimeout(this.#l),this.#l=0,this.player.pause(),this.#g();let{selected:t}=this.#s,r=Qt.map(n=>le(this.#h,n,t[n])).find(Boolean)??"";this.#c.textContent=
r,!(r||!this.#d)&&(this.#i=I(this.#d,this.#h,t),this.#u=Ue(this.#i),this.#a.show(this.#d,this.#h,this.#i),this.inspector.show(this.#d,this.#h,this.#i,t),this.player.
length=this.#i.length,this.player.jump(this.#m),this.#m=0,this.#v(),this.element.dataset.played=`${t.run} ${t.pursuer} ${t.evader} ${t.episode} ${t.seed??""}`,this.#f())}#g(){
let{pursuer:t,evader:r,episode:n,seed:o}=this.#s.selected,{teams:s,payoff:a}=this.#h,i=(c,u)=>s[c].script??`${c}s ${u}`,l=o===null?n<a.episodes?`episode ${n+1} \
of ${a.episodes}`:`episode ${n+1}, not part of the cell`:`seed ${o}`;this.#r.replaceChildren(d("span",{class:"pursuer"},i("pursuer",t))," against ",d("span",{class:"\
evader"},i("evader",r)),d("span",{class:"muted small"},l))}#v(){let t=this.#i;if(!t||!this.#u)return;let r=this.player.step,n=this.#u.moments[r];this.#w(Array.from(
n.everCaptured).filter(Boolean).length,r),this.#o.replaceChildren(...tn(t,this.#u,r).map(o=>d("li",{class:o.kind,"data-agents":o.agents.join(" ")},o.text))),this.
inspector.at(r),this.#S()}#w(t,r){this.#t.replaceChildren(d("strong",{},t),` of ${this.#h.world.n_evaders} captured`,d("span",{class:"muted"},` · step ${r}`))}#x(t){
this.#e.look={selected:t,viewers:t===null?[]:[t]},this.#S()}#S(){let t=this.inspector.agent;for(let r of this.#o.children){let n=r.dataset.agents?.split(" ")??[];
r.classList.toggle("about",t!==null&&n.includes(String(t)))}}};var Ko={ArrowUp:[1,0],ArrowDown:[-1,0],ArrowRight:[0,1],ArrowLeft:[0,-1]},Yo=5;function W(e,t,r,n="pursuer"){e.tabIndex=0,e.setAttribute("role","application"),e.
addEventListener("keydown",o=>{let s=Ko[o.key];if(!s)return;let[a,i]=n==="pursuer"?s:[s[1],s[0]],[l,c]=r(),u=o.shiftKey?Yo:1,{pursuer:m,evader:p}=t.selected;t.select(
{pursuer:rn(m+u*a,l),evader:rn(p+u*i,c)}),o.preventDefault(),o.stopPropagation()})}var rn=(e,t)=>Math.min(t-1,Math.max(0,e));var _={left:52,bottom:46,top:76,right:84},P=10,qo=160,ve=_.right-P-14,j=_.top-P-14,je=class{element;#e;#n;#s=d("canvas",{"aria-hidden":"true"});#a=y("svg",{"ari\
a-hidden":"true"});#r=y("g");#t;#o=d("h2");#c=d("strong",{class:"rate numbers"});#d=d("span",{class:"small muted"});#i=d("p",{class:"small muted numbers"});#u=null;constructor(t,r){
[this.#n,this.#e]=[t,r],this.#t=d("div",{class:"matrix",id:"matrix","aria-label":"Payoff matrix. Arrow keys choose a match, Enter plays it."},this.#s,this.#a);let n=d(
"header",{class:"readout","aria-live":"polite"},d("div",{},this.#o,this.#i),d("div",{class:"of-cell"},this.#c,this.#d));this.element=d("section",{class:"card ma\
trix-card","aria-label":"Payoff matrix"},n,this.#t,Xo()),this.#b(),new ResizeObserver(()=>this.#p()).observe(this.#t),this.#t.addEventListener("pointermove",o=>this.#v(
o)),this.#t.addEventListener("pointerleave",()=>r.point({})),this.#t.addEventListener("click",o=>this.#w(o)),this.#t.addEventListener("mousedown",o=>{o.preventDefault(),
document.activeElement instanceof HTMLElement&&document.activeElement.blur()}),W(this.#t,r,()=>this.#l.payoff.shape),this.#t.addEventListener("keydown",o=>{o.key===
"Enter"&&this.#x()}),r.on("run",()=>this.#p()),r.on("match",()=>this.#f()),r.on("hover",()=>this.#f())}get#l(){return this.#n[this.#e.selected.run]}#p(){let[t,r]=this.#l.
payoff.shape,{clientWidth:n,clientHeight:o}=this.#t;if(n<50)return;let a=Math.max(qo,Math.min(n-_.left-_.right,o-_.top-_.bottom))/Math.max(t,r),i=Math.max(_.left,
(n-r*a-_.right+_.left)/2),l=_.top+Math.max(0,(o-_.top-_.bottom-t*a)/2),c={width:n,height:o,left:i,top:l,cell:a,rows:t,columns:r};this.#u=c,Re(this.#s,this.#l.payoff,
{left:i,top:l,width:r*a,height:t*a}),this.#a.setAttribute("viewBox",`0 0 ${n} ${o}`),this.#a.replaceChildren(Jo(c),Zo(c),...this.#h(c),this.#r),this.#f()}#m(t){
let r=this.#l.findings?.generalization;if(!r)return[];let{selected:n,hover:o}=this.#e,[s,a]=[o.pursuer??n.pursuer,o.evader??n.evader],[i,l]=nn(t,r.pursuers.mean[s]??
0,s),[c,u]=on(t,r.evaders.mean[a]??0,a);return[y("circle",{class:"dot of-pursuers",cx:i,cy:l,r:5}),y("circle",{class:"dot of-evaders",cx:c,cy:u,r:5})]}#h(t){let r=this.#l.
findings?.generalization;if(!r)return[];let{left:n,top:o,cell:s,rows:a,columns:i}=t,[l,c]=[n+i*s+P,o-P],u={class:"side"};return[y("rect",{...u,x:l,y:o,width:ve,
height:a*s}),y("rect",{...u,x:n,y:c-j,width:i*s,height:j}),...sn(r.pursuers,(m,p)=>nn(t,m,p),"of-pursuers"),...sn(r.evaders,(m,p)=>on(t,m,p),"of-evaders"),y("te\
xt",{class:"tick",x:l,y:o+a*s+16,"text-anchor":"start"},"0"),y("text",{class:"tick",x:l+ve,y:o+a*s+16,"text-anchor":"end"},"1"),y("text",{class:"tick",x:n-6,y:c-
4,"text-anchor":"end"},"0"),y("text",{class:"tick",x:n-6,y:c-j+8,"text-anchor":"end"},"1"),y("text",{class:"label of-pursuers",x:l+ve,y:o+a*s+34,"text-anchor":"\
end"},"captures"),y("text",{class:"label of-evaders",x:n+i*s+P,y:c-j+10,"text-anchor":"start"},"escapes")]}#f(){let t=this.#u;if(!t)return;let{selected:r,hover:n}=this.#e,
{left:o,top:s,cell:a,rows:i,columns:l}=t,c=g=>s+(i-1-g)*a,u=[],m=(g,h)=>y("rect",{class:h,x:o,y:c(g),width:l*a+P+ve,height:a}),p=(g,h)=>y("rect",{class:h,x:o+g*
a,y:s-P-j,width:a,height:P+j+i*a});if(u.push(m(r.pursuer,"strip pursuer"),p(r.evader,"strip evader")),n.pursuer!==null&&n.pursuer<i&&u.push(m(n.pursuer,"strip h\
over")),n.evader!==null&&n.evader<l&&u.push(p(n.evader,"strip hover")),n.lag!==null)for(let g=0;g<l;g++){let h=g+n.lag;h>=0&&h<i&&u.push(y("rect",{class:"lagged",
x:o+g*a,y:c(h),width:a,height:a}))}u.push(...this.#m(t));let f={x:o+r.evader*a,y:c(r.pursuer),width:a,height:a};u.push(y("rect",{class:"chosen under",...f}),y("\
rect",{class:"chosen",...f})),this.#r.replaceChildren(...u),this.#b()}#b(){let{selected:t,hover:r}=this.#e,n=r.pursuer??t.pursuer,o=r.evader??t.evader,s=ie(this.#l,
n,o);this.#o.replaceChildren(d("span",{class:"pursuer"},`Pursuers ${n}`)," against ",d("span",{class:"evader"},`evaders ${o}`)),this.#c.textContent=s?A(s.rate,3):
"-",this.#d.textContent=s?`capture rate, mean of ${s.rates.length} episodes`:"the evaluation played no episodes",this.#i.textContent=this.#y(n,o)}#y(t,r){let n=this.#l.
findings?.generalization;if(!n)return"";let o=(s,a)=>De(s.mean[a]??0,s.low?.[a]??null,s.high?.[a]??null);return`Against all: captures ${o(n.pursuers,t)}, escape\
s ${o(n.evaders,r)}`}#g(t){let r=this.#u;if(!r)return null;let n=this.#t.getBoundingClientRect(),o=Math.floor((t.clientX-n.left-r.left)/r.cell),s=r.rows-1-Math.
floor((t.clientY-n.top-r.top)/r.cell),[a,i]=[s>=0&&s<r.rows,o>=0&&o<r.columns];return a||i?{g:a?s:-1,h:i?o:-1,inside:a&&i}:null}#v(t){let r=this.#g(t);this.#e.point(
r?{pursuer:r.g<0?null:r.g,evader:r.h<0?null:r.h}:{})}#w(t){let r=this.#g(t);r&&(this.#e.select({...r.g<0?{}:{pursuer:r.g},...r.h<0?{}:{evader:r.h}}),r.inside&&this.#x())}#x(){
this.#t.dispatchEvent(new CustomEvent("play",{bubbles:!0}))}};function Xo(){let e=d("span",{class:"gradient"});return e.style.backgroundImage=or(),d("p",{class:"\
scale-of-rates small muted"},"0 all escape",e,"1 all caught")}function Jo({left:e,top:t,cell:r,rows:n,columns:o}){let s=y("g",{class:"axes"}),a=t+n*r,i=l=>he(0,
l-1,Math.min(l,l*r/44),!0);for(let l of i(o))s.append(y("text",{class:"tick",x:e+(l+.5)*r,y:a+16,"text-anchor":"middle"},l));for(let l of i(n))s.append(y("text",
{class:"tick",x:e-7,y:a-(l+.5)*r,"text-anchor":"end","dominant-baseline":"middle"},l));return s.append(y("text",{class:"label of-evaders",x:e+o*r/2,y:a+36,"text\
-anchor":"middle"},"evader generation"),y("text",{class:"label of-pursuers",transform:`translate(${e-36} ${t+n*r/2}) rotate(-90)`,"text-anchor":"middle"},"pursu\
er generation")),s}function Zo({left:e,top:t,cell:r,rows:n,columns:o}){let s=y("g",{class:"diagonal"}),a=Math.min(n,o);if(a<3)return s;let i=t+n*r;for(let l of[
"H","V"]){let c=`M${e} ${i}`;for(let u=1;u<=a;u++){let[m,p]=[`H${e+u*r}`,`V${i-u*r}`];c+=l==="H"?m+p:p+m}s.append(y("path",{d:c,class:"under"}),y("path",{d:c}))}
return s}var nn=({left:e,top:t,cell:r,rows:n,columns:o},s,a)=>[e+o*r+P+s*ve,t+(n-a-.5)*r],on=({left:e,top:t,cell:r},n,o)=>[e+(o+.5)*r,t-P-n*j];function sn(e,t,r){
let n=s=>s.map((a,i)=>t(a??0,i).map(l=>l.toFixed(1)).join(" ")),o=[];return e.low&&e.high&&o.push(y("path",{class:`band ${r}`,d:`M${[...n(e.high),...n(e.low).reverse()].
join("L")}Z`})),o.push(y("path",{class:`line ${r}`,d:`M${n(e.mean).join("L")}`})),o}function T(e,t,...r){return d("section",{class:"card panel","aria-label":e},d("header",{},d("h2",{},e),d("p",{class:"small muted"},t)),...r)}function an(e,t,r){let{findings:n}=e;if(!n)return null;let o=d("dialog",{class:"four","aria-label":"Four matches"}),s=i=>{let l=r();l&&es(o,e,i,t,l)},a=n.checkerboards.
map(i=>Qo(e,i,s));return{element:T("Checkerboards","Two generations of each team: each pursuers are better against one of the evaders. Click one: its four match\
es side by side.",a.length?d("div",{class:"boards"},...a):d("p",{},`No four cells differ by more than ${n.margin} in this way.`),a.length?d("p",{class:"small mu\
ted"},"The strongest of all pairs, so noise makes them look stronger than they are. The diagnosis says whether there are more than noise makes."):null,o)}}var ln=({
pursuers:[e,t],evaders:[r,n]})=>[[e,r],[e,n],[t,r],[t,n]];function Qo(e,t,r){let[n,o]=t.pursuers,[s,a]=t.evaders,i=ln(t).map(([l,c])=>{let u=e.payoff.capture_rate[l][c],
m=d("span",{class:"cell"},A(u));return m.style.backgroundColor=nr(u),m.style.color=rr(u),m});return d("button",{type:"button",class:"miniature numbers",onclick:()=>r(
t)},d("span",{},d("span",{class:"heard"},`Four matches of pursuers ${n} and ${o}, evaders ${s} and ${a}:`)),d("span",{class:"evader"},s),d("span",{class:"evader"},
a),d("span",{class:"pursuer"},n),i[0],i[1],d("span",{class:"pursuer"},o),i[2],i[3])}function es(e,t,r,n,o){let s=ln(r).filter(([p,f])=>!le(t,"pursuer",p)&&!le(t,
"evader",f)),a=s.map(([p,f])=>I(o,t,{run:n.selected.run,pursuer:p,evader:f,episode:0,seed:null})),i=new q(Math.max(0,...a.map(p=>p.length)),{speed:16,still:te()}),
l=a.map((p,f)=>{let[g,h]=s[f],b=d("canvas",{"aria-label":`Pursuers ${g} against evaders ${h}`}),w=d("span",{class:"numbers"}),S=()=>{e.close(),n.select({pursuer:g,
evader:h})};return{element:d("figure",{},d("figcaption",{},d("span",{},d("span",{class:"pursuer"},g)," against ",d("span",{class:"evader"},h),d("span",{class:"m\
uted small"},` cell ${A(t.payoff.capture_rate[g][h])}`)),w,d("button",{type:"button",class:"small",title:"Show this match alone",onclick:S},"open")),b),match:p,
recording:Ue(p),board:new ee(b,{numbers:!1}),tally:w}}),c=()=>l.forEach(p=>p.board.show(p.recording,i.time)),u=()=>l.forEach(({recording:p,match:f,tally:g})=>{let h=p.
moments[Math.min(i.step,f.length)];g.textContent=`${Array.from(h.everCaptured).filter(Boolean).length} of ${f.config.n_evaders}`});i.addEventListener("frame",c),
i.addEventListener("step",u),e.replaceChildren(d("header",{},d("h2",{},"Four matches of a checkerboard"),d("button",{type:"button",onclick:()=>e.close()},"Close")),
d("div",{class:"grid-of-four"},...l.map(p=>p.element)),Fe(i));let m=p=>{!(p.target instanceof HTMLSelectElement||p.target instanceof HTMLButtonElement&&p.key===
" ")&&!p.defaultPrevented&&X(i,p)&&p.preventDefault()};e.addEventListener("keydown",m),e.addEventListener("close",()=>{e.removeEventListener("keydown",m),i.pause(),
l.forEach(p=>p.board.close()),e.replaceChildren()},{once:!0}),e.showModal(),c(),u(),te()||i.play()}var Ge={pursuer:"evader",evader:"pursuer"};function cn(e,t){let r=e.findings?.ciao;if(!r)return null;let n=["pursuer","evader"].map(o=>{let{fading:s,stripes:a,period:i}=r[`${o}\
s`],l=`fading ${A(s)}, stripes ${A(a)}${i===null?"":` every ${i} generations`}`;return ts(e,o,l,t)});return{element:T("CIAO","Current individuals against ancest\
ral opponents, by the team's own score. Stripes: intransitive, since wins and losses alternate with the age of the opponent; whether a team returns to earlier s\
trategies is recurrence, under What happened. Darker away from the diagonal: forgetting.",d("div",{class:"triangles"},...n.map(o=>o.element))),update:()=>n.forEach(
o=>o.update())}}function ts(e,t,r,n){let o=t==="pursuer"?0:1,[s,a]=[e.payoff.shape[o],e.payoff.shape[1-o]],i=(v,x)=>t==="pursuer"?e.payoff.capture_rate[v][x]:1-
e.payoff.capture_rate[x][v],l=d("canvas",{width:a,height:s,"aria-hidden":"true"}),c=l.getContext("2d"),u=c?.createImageData(a,s);for(let v=0;u&&v<s;v++)for(let x=0;x<=
Math.min(v,a-1);x++)u.data.set([...J(i(v,x)),255],4*((s-1-v)*a+x));u&&c?.putImageData(u,0,0);let m=y("rect",{class:"chosen",width:1,height:1}),p=y("rect",{class:"\
chosen under",width:1,height:1}),f=y("svg",{viewBox:`0 0 ${a} ${s}`,preserveAspectRatio:"none","aria-hidden":"true"},p,m),g=d("div",{class:"triangle","aria-labe\
l":`CIAO of the ${t}s: ${r}. Arrow keys choose a match.`},l,f);W(g,n,()=>e.payoff.shape,t),g.style.aspectRatio=`${a} / ${s}`;let h=v=>{let x=g.getBoundingClientRect(),
C=Math.floor((v.clientX-x.left)/x.width*a),U=s-1-Math.floor((v.clientY-x.top)/x.height*s);return C>=0&&U<s&&C<=U?[U,C]:null},b=v=>({[t]:v[0],[Ge[t]]:v[1]});g.addEventListener(
"pointermove",v=>n.point(h(v)?b(h(v)):{})),g.addEventListener("pointerleave",()=>n.point({})),g.addEventListener("click",v=>h(v)&&n.select(b(h(v))));let w=()=>{
let v=n.hover[t]??n.selected[t],x=n.hover[Ge[t]]??n.selected[Ge[t]];for(let C of[m,p])C.setAttribute("x",String(x)),C.setAttribute("y",String(s-1-v)),C.style.display=
x<=v?"":"none"};return{element:d("figure",{},d("figcaption",{class:"small"},d("span",{class:t},`${t}s`)),g,d("p",{class:"small muted"},`horizontal: ${Ge[t]} gen\
eration; vertical: ${t} generation`),d("p",{class:"small numbers"},r)),update:w}}var ze={left:46,right:12,top:10,bottom:42},dn={x:56,y:34};function Ve(e,t,r,n){let[o,s]=[ze.left,ze.top],a=Math.max(o+40,e-ze.right),i=Math.max(s+40,t-ze.bottom),
l=(h,b,w)=>S=>b+(S-h.low)/(h.high-h.low||1)*(w-b),[c,u]=[l(r,o,a),l(n,i,s)],m=y("g"),p=y("svg",{width:e,height:t,viewBox:`0 0 ${e} ${t}`,class:"plot"}),f=y("g",
{class:"axes"});for(let h of he(n.low,n.high,(i-s)/dn.y,n.whole))f.append(y("line",{x1:o,x2:a,y1:u(h),y2:u(h),class:"grid"}),y("text",{x:o-8,y:u(h),"text-anchor":"\
end","dominant-baseline":"middle"},un(h)));for(let h of he(r.low,r.high,(a-o)/dn.x,r.whole))f.append(y("text",{x:c(h),y:i+16,"text-anchor":"middle"},un(h)));return f.
append(y("line",{x1:o,x2:a,y1:i,y2:i,class:"axis"}),y("text",{x:(o+a)/2,y:t-6,"text-anchor":"middle",class:"label"},r.label),y("text",{transform:`translate(12 ${(s+
i)/2}) rotate(-90)`,"text-anchor":"middle",class:"label"},n.label)),p.append(f,m),{root:p,marks:m,left:o,right:a,top:s,bottom:i,x:c,y:u,at:h=>{let b=h-p.getBoundingClientRect().
left;return r.low+(b-o)/(a-o)*(r.high-r.low)}}}var un=e=>String(Number(e.toPrecision(6))).replace("-","−");function we(e,t,r,n){let o="",s="M";r.forEach((i,l)=>{
i===null?s="M":(o+=`${s}${e.x(t[l]).toFixed(1)} ${e.y(i).toFixed(1)}`,s="L")});let a=y("path",{d:o,class:`line ${n}`});return e.root.insertBefore(a,e.marks),a}function xe(e,t,r,n=null){let o=e.x(t);e.marks.append(y("line",{x1:o,x2:o,y1:e.top,y2:e.bottom,class:`mark ${r}`})),n!==null&&e.marks.append(y("circle",{cx:o,cy:e.
y(n),r:5,class:`dot ${r}`}))}function wt(...e){return d("p",{class:"legend small"},...e.map(([t,r])=>d("span",{class:`key ${r}`},t)))}function Ke(e,t,r={}){let n=d(
"div",{class:"chart",role:"img","aria-label":e}),o=null,s=()=>{o?.marks.replaceChildren(),o&&r.marks?.(o)},a=()=>{let{clientWidth:i,clientHeight:l}=n;i<50||l<50||
(o=t(i,l),n.replaceChildren(o.root),s())};return n.addEventListener("pointermove",i=>r.point?.(o?.at(i.clientX)??null)),n.addEventListener("pointerleave",()=>r.
point?.(null)),r.choose&&(n.classList.add("chooses"),n.addEventListener("click",i=>o&&r.choose?.(o.at(i.clientX),o,i))),new ResizeObserver(a).observe(n),{element:n,
redraw:a,remark:s}}var xt=["of-pursuers","of-evaders","of-both"],rs=2500,mn="Arrow keys choose generations.",pn={low:0,high:1,label:"capture rate"};function hn(e,t){let{training:r}=e,
{capture_rate:n,generation:o,learner:s,epochs:a}=r,i=n.map((g,h)=>(h+1)*a),l=ns(n,r.window),c=i.at(-1)??1,u=i.length>rs?"dense":"",m=(g,h)=>{let b=o.flatMap((w,S)=>w===
g&&(s[S]===h||s[S]===2)?[S]:[]);return b.length?[i[b[0]],i[b.at(-1)]]:null},p=Ke(`Capture rate in ${c} epochs of training. ${mn}`,(g,h)=>{let b=Ve(g,h,{low:0,high:c,
label:"epoch",whole:!0},pn);for(let[w,S]of[["raw",n],[u,l]])for(let[v,x]of xt.entries()){let C=S.map((U,Mt)=>s[Mt]===v||s[Mt+1]===v?U:null);C.some(U=>U!==null)&&
we(b,i,C,`${x} ${w}`)}return b},{marks:g=>{let{pursuer:h,evader:b}=t.selected;for(let[w,S]of[[0,h],[1,b]]){let v=m(t.hover[w?"evader":"pursuer"]??S,w);v&&xe(g,(v[0]+
v[1])/2,xt[w])}},choose:g=>{let h=Math.min(i.length-1,Math.max(0,Math.round(g/a)-1)),b=o[h];s[h]!==1&&t.select({pursuer:Math.min(b,e.payoff.shape[0]-1)}),s[h]!==
0&&t.select({evader:Math.min(b,e.payoff.shape[1]-1)})}});W(p.element,t,()=>e.payoff.shape);let f=[...new Set(s)].sort().map(g=>[["pursuers learn","evaders learn",
"both teams learn"][g],xt[g]]);return{element:T("Training",`${Br(r.matches)} training matches. Lines: the generations that are selected.`,wt(...f),p.element),update:p.
remark}}function fn(e,t){let r=e.findings?.lags;if(!r)return null;let[n,o]=[r.lags[0],r.lags.at(-1)],s=Math.min(5,(Math.max(...r.cells)+1)/2),a=r.means.map((l,c)=>r.
cells[c]>=s?l:null),i=Ke("Lag profile",(l,c)=>{let u=Ve(l,c,{low:n,high:o,label:"lag: pursuer minus evader generation",whole:!0},pn);return we(u,r.lags,r.means,
"raw ink"),we(u,r.lags,a,"ink"),u},{marks:l=>{let{pursuer:c,evader:u}=t.selected;xe(l,0,"zero");let m=t.hover.lag??c-u;xe(l,m,"ink",r.means[m-n])},point:l=>{let c=l===
null?null:Math.round(l);t.point({lag:c!==null&&c>=n&&c<=o?c:null})}});return{element:T("Lag profile","Left: evaders are later. Right: pursuers are later. It ris\
es if both teams keep what they learn. Faint: fewer than 5 cells.",i.element),update:i.remark}}function gn(e,t){let r=e.findings?.ratings;if(!r)return null;let n={
pursuer:r.pursuers,evader:r.evaders},o=[...r.pursuers,...r.evaders].map(u=>u??0),[s,a]=[Math.min(...o),Math.max(...o)],i=.06*(a-s||1),l=Math.max(...e.payoff.shape)-
1,c=Ke(`Elo ratings by generation. ${mn}`,(u,m)=>{let p=Ve(u,m,{low:0,high:l,label:"generation",whole:!0},{low:s-i,high:a+i,label:"Elo points"});for(let f of["p\
ursuer","evader"])we(p,n[f].map((g,h)=>h),n[f],`of-${f}s`);return p},{marks:u=>{for(let m of["pursuer","evader"]){let p=t.hover[m]??t.selected[m];xe(u,p,`of-${m}\
s`,n[m][p]??null)}},choose:(u,m,p)=>{let f=Math.round(u),g=p.clientY-m.root.getBoundingClientRect().top,h=w=>Math.abs(m.y(n[w][f]??1/0)-g),b=h("pursuer")<=h("ev\
ader")?"pursuer":"evader";f>=0&&f<n[b].length&&t.select({[b]:f})}});return W(c.element,t,()=>e.payoff.shape),{element:T("Ratings",`One number for each generatio\
n, which cycles do not fit. The game itself: ${A(r.offset,0)} points for the pursuers.`,wt(["pursuers","of-pursuers"],["evaders","of-evaders"]),c.element),update:c.
remark}}function ns(e,t){let r=[0];for(let n of e)r.push(r.at(-1)+n);return e.map((n,o)=>{let[s,a]=[Math.max(0,o-Math.floor((t-1)/2)),Math.min(e.length,o+Math.floor(
t/2)+1)];return(r[a]-r[s])/(a-s)})}var os={present:"●",absent:"○","cannot tell":"?"};function yn(e){let{findings:t}=e;if(!t)return null;let[,...r]=t.table,n=new Map(t.reasons.map(a=>{let[i,,l]=ss(
a);return[i,l]})),o=r.map(([a,i,l,c])=>{let u=c===t.window?n.get(a):void 0;return d("li",{class:`finding ${i.replace(" ","-")}`},d("span",{class:"sign","aria-hi\
dden":"true"},os[i]??""),d("div",{},d("p",{},d("strong",{},a),` ${i}`,d("span",{class:"muted"},` · ${c}`)),u?d("p",{class:"small"},`${u}.`):null,d("p",{class:"\
small muted numbers"},l)))}),s=T("What happened","Each condition is present, absent, or its 95 % interval cannot tell. The intervals are about this run.",d("p",
{class:"headline"},t.headline),...t.numbers.map(a=>d("p",{class:"numbers"},`${bn(a)}.`)),d("ul",{class:"findings"},...o),e.limits?d("p",{class:"small"},e.limits):
null,d("details",{class:"small"},d("summary",{},"Headline numbers in words"),...t.description.map(a=>d("p",{},a)),as(t)));return s.classList.add("diagnosis"),{element:s}}
function ss(e){let[t="",r=""]=e.split(/: (.*)/s),[n="",o=""]=r.split(/, because (.*)/s);return[t.toLowerCase(),n,bn(o.replace(/\.$/,""))]}var bn=e=>e.charAt(0).
toUpperCase()+e.slice(1);function as({noise:e}){return e.transitive_share_noise===null?null:d("p",{},`Last half: transitive share ${A(e.transitive_share)} (an o\
rder of strength with the same noise rarely falls below ${A(e.transitive_share_noise)}), checkerboards ${gt(e.checkerboard_share)} (it rarely exceeds ${gt(e.checkerboard_share_noise)}\
).`)}function vn(e){let t=[e.held_out?.pursuers,e.held_out?.evaders].filter(r=>r!=null);return t.length?{element:T("Held-out opponents",`The last generations against\
 opponents that no run has met; 95 % intervals over ${t[0].episodes} episodes.`,...t.map(is))}:null}function is(e){let t=n=>n.at(-1),r=[["mean",t(e.mean)],...Object.
entries(e.against).map(([n,o])=>[n,t(o)])];return d("table",{class:"scores numbers"},d("caption",{},d("span",{class:e.team},`${e.team}s`),` of generation ${e.generations.
at(-1)}, ${e.score}`),...r.map(([n,o],s)=>d("tr",{class:s?"":"mean"},d("th",{scope:"row"},n),d("td",{class:"range"},ls(o,e.team)),d("td",{},De(o.value,o.low,o.high)))))}
function ls({value:e,low:t,high:r},n){let o=d("span",{class:`between ${n}`});o.style.left=`${100*(t??e)}%`,o.style.width=`${100*((r??e)-(t??e))}%`;let s=d("span",
{class:`value ${n}`});return s.style.left=`${100*e}%`,d("span",{class:"scale","aria-hidden":"true"},o,s)}function xn(e){let t=e.settings.filter(o=>o.changed),r=e.settings.filter(o=>!o.changed),n=T("Settings",`${e.schedule}, seed ${e.seed}. Every setting is an optio\
n of matrixworld evolve.`,t.length?wn(t,"other than the default"):d("p",{class:"small"},"All settings are the defaults."),d("details",{class:"small"},d("summary",
{},`${r.length} settings with their defaults`),wn(r,"defaults")));return n.classList.add("settings"),{element:n}}function wn(e,t){return d("div",{class:"wide-ta\
ble"},d("table",{class:"small"},d("caption",{class:"heard"},`Settings: ${t}`),...e.map(({name:r,value:n,help:o})=>d("tr",{},d("th",{scope:"row"},`--${r.replaceAll(
"_","-")}`),d("td",{class:"numbers"},n),d("td",{class:"muted"},o)))))}function Sn(e,t,r){let n=new Map,o=d("div",{class:"panels"}),s=[],a=()=>s.forEach(l=>l.update?.()),i=()=>{let l=e[t.selected.run];s=n.get(l)??cs(l,t,r),n.set(l,
s),o.replaceChildren(...s.map(c=>c.element)),a()};return t.on("run",i),t.on("match",a),t.on("hover",a),i(),o}function cs(e,t,r){return[yn(e),hn(e,t),an(e,t,r),fn(
e,t),gn(e,t),cn(e,t),vn(e),xn(e)].filter(o=>o!==null)}var Mn={pursuer:null,evader:null,lag:null},Ye=class extends EventTarget{#e;#n=Mn;constructor(t){super(),this.#e=t}get selected(){return this.#e}get hover(){return this.#n}select(t){
let r=this.#e,n=["run","pursuer","evader"].some(o=>o in t&&t[o]!==r[o]);this.#e={...r,...n?{episode:0,seed:null}:{},...t},this.#e.run!==r.run&&this.dispatchEvent(
new Event("run")),this.dispatchEvent(new Event("match"))}point(t){let r={...Mn,...t};r.pursuer===this.#n.pursuer&&r.evader===this.#n.evader&&r.lag===this.#n.lag||
(this.#n=r,this.dispatchEvent(new Event("hover")))}on(t,r){this.addEventListener(t,r)}};var G=er(),{runs:R}=G,[ds,us]=R[0].payoff.shape,ms=at(location.hash,R,{run:0,pursuer:ds-1,evader:us-1,episode:0,seed:null}),{step:ps,...hs}=ms,N=new Ye(hs),O=new We(
R,N,G.playground),En=new je(R,N),St=ar(),qe=null;function fs(){let[e]=R,t=`matrixworld ${G.version}`;return R.length>1||!e?t:e.race?`${e.schedule}, seed ${e.seed}\
 · ${t}`:`${e.learning.join(" and ")}s learn, seed ${e.seed} · ${t}`}document.getElementById("page").replaceWith(d("header",{class:"top"},d("h1",{},G.title),d(
"p",{class:"muted small about"},fs()),d("div",{class:"tools"},Xt(),d("button",{type:"button",class:"keys-button",title:"Keys (?)","aria-label":"Keys (?)",onclick:()=>St.
showModal()},"?"))),...G.note?[d("aside",{class:"note small muted"},G.note)]:[],sr(R,N),d("main",{class:"stages"},En.element,O.element),Sn(R,N,()=>qe),St);Object.
assign(window,{matrixworldExplorer:{get match(){return O.match},get step(){return O.player.step},play:e=>qe&&I(qe,R[N.selected.run],{...N.selected,episode:e}),get shape(){
return R[N.selected.run].payoff.shape}}});En.element.addEventListener("play",()=>O.playSoon());O.goTo(ps);Jt(R,N,O);ir(R,N,O,St,()=>vt(O.shown,G.playground));requestAnimationFrame(
()=>setTimeout(()=>{Yt().then(e=>{qe=e,O.start(e),document.body.dataset.ready="true"},e=>{O.element.prepend(d("p",{class:"problem",role:"alert"},`The engine doe\
s not start here: ${String(e)}`)),document.body.dataset.ready="true"})}));})();
