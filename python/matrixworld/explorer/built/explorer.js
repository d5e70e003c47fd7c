/* built from web/ by "npm run build"; sources 637dcc609ddcbfe705272d79515cbc7778461d40c614fda4d0efe9b586fdd0d8 */
"use strict";(()=>{var _t={SIMULTANEOUS:0,SWARM_TURNS:1,AGENT_TURNS:2},ee={DISAPPEAR:0,REACH:1,BOUNCE:2},Mt={OCCUPATION:0,SURROUND:1},At={FAULT:0,INVOLVED:1};var Et=["obstacle","teammate","adversary"],Ye=["vertex","edge","chain"],Ct=["turn","kind","form","first","second","row","col","at_fault","held","doomed"],Xe=["p\
ursuer_{number}","evader_{number}"],Tt={obstacle:"{first} ran into the obstacle or border at {cell}",vertex:"{first} and {second} both headed for {cell}",edge:"\
{first} and {second} meant to swap, {first} to {cell}",chain:"{first} headed for {cell}, where {second} had to stay"},te={"both held":"both bounce","both doomed":"\
both disappear",held:"{agent} bounces",doomed:"{agent} disappears",none:"nobody is stopped"},Rt="{event}: {outcome}",Je={random:"any action, all equally likely",
still:"always stays",chaser:"moves to where the nearest adversary in view is nearest",fleer:"moves to where the nearest adversary in view is farthest","clumsy-c\
haser":"a chaser that takes any action in half of the steps","clumsy-fleer":"a fleer that takes any action in half of the steps",hunter:"a chaser of the nearest\
 adversary in view to which no teammate in view is nearer",surrounder:"a chaser of the nearest free cell beside an adversary in view without a teammate",dodger:"\
moves to where all adversaries in view together are farthest; each cell that holds some weighs 2**14 // (1 + moves)**2"},kt={free:".GS",blocked:"#@OTW"};var G=1+Ct.length;function re(e,t){return e.replace(/\{(\w+)\}/g,(r,n)=>String(t[n]))}function Ze(e,t){return e<t?re(Xe[0],{number:e}):re(Xe[1],{number:e-t})}function vn(e,t){
let[r,n,s,o,a,i,l,...c]=Array.from(e),d=a<0?[o]:[o,a],[m,p,f]=c.map(w=>d.filter((S,v)=>w>>v&1)),g=d.map(w=>Ze(w,t)),h=re(Tt[a<0?"obstacle":Ye[s]],{first:g[0],second:g[g.
length-1],cell:`(${i}, ${l})`}),b=re(Rt,{event:h,outcome:wn(d.length,p,f,t)});return{kind:Et[n],form:Ye[s],agents:d,cell:[i,l],at_fault:m,held:p,doomed:f,turn:r,
text:b}}function wn(e,t,r,n){if(e===2&&t.length===2)return te["both held"];if(e===2&&r.length===2)return te["both doomed"];let s=o=>a=>re(te[o],{agent:Ze(a,n)});
return[...t.map(s("held")),...r.map(s("doomed"))].join(", ")||te.none}function xe(e,t){let r=[];for(let n=0;n<e.length;n+=G)r.push(vn(e.subarray(n+1,n+G),t));return r}var D=class extends Error{name="EngineError"};function _(e,t,r){let n=typeof r=="string"?`'${r}'`:typeof r=="object"?JSON.stringify(r):String(r);return new D(`${e}\
: expected ${t}, got ${n}`)}var z=class{bytes;constructor(t){this.bytes=t}},Pt=0,et=[Uint8Array,Uint8Array,Int32Array,BigInt64Array,BigUint64Array,Float32Array,Float64Array],Ot=4,$t=4,xn=new TextEncoder,
Sn=new TextDecoder;function _n(e){for(let t=et.length-1;t>Pt;--t)if(e instanceof et[t])return t;throw new TypeError("array: expected a typed array of the engine\
's numbers, got another")}function Qe(e){return new Uint8Array(e.buffer,e.byteOffset,e.byteLength)}function Mn(e){return xn.encode(`${e}\0`)}var tt=class{engine;addresses=[];constructor(t){
this.engine=t}copy(t){let r=this.engine._malloc(Math.max(t.length,1));if(r===0)throw new D("memory: expected room for the arguments, got none");return this.addresses.
push(r),this.engine.HEAPU8.set(t,r),r}text(t){return this.copy(Mn(t))}arrays(t){let r=Object.entries(t),n=r.flatMap(([o,a])=>{let i=a instanceof z,l=i?a.bytes:a;
return[this.text(o),i?Pt:_n(l),l.length,this.copy(Qe(l))]}),s=this.copy(Qe(Int32Array.from(n)));return this.copy(Qe(Int32Array.of(r.length,s)))}free(){for(let t of this.
addresses)this.engine._free(t)}};function Nt(e,t){let r=e.HEAPU8;return Sn.decode(r.subarray(t,r.indexOf(0,t)))}function Se(e){let t=new Int32Array(e.HEAPU8.buffer),
r=e._last_outputs()/Ot,n=t[r+1]/Ot,s={};for(let o=n;o<n+t[r]*$t;o+=$t){let a=et[t[o+1]],i=t[o+2]*a.BYTES_PER_ELEMENT,l=t[o+3];s[Nt(e,t[o])]=new a(e.HEAPU8.slice(
l,l+i).buffer)}return s}function ne(e,t){let r=new tt(e);try{let n=t(r);if(n===0)throw new D(Nt(e,e._last_error()));return n}finally{r.free()}}var An=2**31-1,En=2n**64n-1n,Cn=34028234663852886e22;function N(e,t){if(typeof t!="number"||!Number.isInteger(t)||Math.abs(t)>An)throw _(e,"an integer",t);return Int32Array.
of(t)}function _e(e,t){if(typeof t!="boolean")throw _(e,"true or false",t);return new z(Uint8Array.of(Number(t)))}function H(e,t,r){let n=typeof t=="string"&&Object.
hasOwn(r,t)?r[t]:void 0;if(n===void 0)throw _(e,`one of ${Object.keys(r).join(", ")}`,t);return Int32Array.of(n)}function rt(e,t){if(typeof t!="number"||!(Math.
abs(t)<=Cn))throw _(e,"a finite number",t);return t}function V(e,t){let n=typeof t=="bigint"||typeof t=="number"&&Number.isSafeInteger(t)?BigInt(t):-1n;if(n<0n||
n>En)throw _(e,"an integer from 0 to 2^64 - 1",t);return BigUint64Array.of(n)}function Tn(e){return{"rules.interaction":H("interaction",e.interaction,_t),"rules\
.obstacle":H("obstacle",e.obstacle,ee),"rules.teammate":H("teammate",e.teammate,ee),"rules.evader":H("evader",e.evader,ee),"rules.pursuer":H("pursuer",e.pursuer,
ee),"rules.capture":H("capture",e.capture,Mt),"rules.captured_disappear":_e("captured_disappear",e.captured_disappear)}}function Lt(e,t){let r=typeof t=="number"?
[t,t,t]:t;if(!Array.isArray(r)||r.length!==3)throw _(e,"1 or 3 numbers",t);return Float32Array.from(r,n=>rt(e,n))}function Rn(e){let t=(r,n)=>Float32Array.of(rt(
r,e[r]),rt(n,e[n]));return{"rewards.capture":t("pursuer_capture","evader_capture"),"rewards.neighbor":t("pursuer_neighbor","evader_neighbor"),"rewards.step":t("\
pursuer_step","evader_step"),"rewards.pursuer_collide":Lt("pursuer_collide",e.pursuer_collide),"rewards.evader_collide":Lt("evader_collide",e.evader_collide),"r\
ewards.blame":H("blame",e.blame,At),"rewards.capture_repeats":_e("capture_repeats",e.capture_repeats)}}function Ut(e){if(e===void 0||typeof e=="number")return new Uint8Array(
0);if(e instanceof Uint8Array)return e;let{free:t,blocked:r}=kt;for(let[n,s]of e.entries()){if(s.length!==e[0]?.length)throw _(`map, row ${n}`,`${e[0]?.length} \
cells as in row 0`,s.length);let o=[...s].find(a=>!t.includes(a)&&!r.includes(a));if(o)throw _(`map, row ${n}`,`'${t}' (free) or '${r}' (obstacle)`,o)}return Uint8Array.
from([...e.join("")],n=>Number(r.includes(n)))}function Dt(e,t){if(!Array.isArray(e))return;let r=[e.length,e[0]?.length??0];if(!(r[0]===t.rows&&r[1]===t.cols))
throw _("obstacle map",`shape (${t.rows}, ${t.cols}), the rows and cols`,r)}function Me(e){Dt(e.obstacles,e);let t=typeof e.obstacles=="number"?e.obstacles:0;return{
...Tn(e.rules),...Rn(e.rewards),rows:N("rows",e.rows),cols:N("cols",e.cols),n_pursuers:N("n_pursuers",e.n_pursuers),n_evaders:N("n_evaders",e.n_evaders),fov:N("\
fov",e.fov),diagonal:_e("diagonal",e.diagonal),max_steps:N("max_steps",e.max_steps),density:Float64Array.of(t),map:Ut(e.obstacles)}}function It(e,t){return Int32Array.
from((t??[]).flat(),r=>N(e,r)[0])}function Ht(e,t){return Dt(e.obstacles,t),{seed:V("seed",e.seed??0n),episode:V("episode",e.episode??0),pursuers:It("pursuers",
e.pursuers),evaders:It("evaders",e.evaders),map:Ut(e.obstacles)}}function Ae(e){return{actions:Int32Array.from(e,t=>N("actions",t)[0])}}function K(e){if(typeof e==
"string"){if(!Object.hasOwn(Je,e))throw _("policy",`one of ${Object.keys(Je).join(", ")}`,e);return{script:new TextEncoder().encode(e)}}if(e.activation!=="relu"&&
e.activation!=="tanh")throw _("activation","'relu' or 'tanh'",e.activation);return{hidden:Int32Array.from(e.hidden,t=>N("hidden",t)[0]),activation:new TextEncoder().
encode(e.activation),sampled:_e("sampled",e.sampled),genome:e.genome}}var kn=["first_turn","terminated","truncated"];function Bt(e){let t={...e};for(let r of kn)
t[r]=new z(e[r]);return t}var Ee=class{config;seed;episode;n_agents;statistics;positions;last_positions;alive;captured;ever_captured;actions;rewards;involved;fault;map;conflict_table;first_conflict;constructor(t,r,n,s){
this.config=t,this.seed=r,this.episode=n,this.n_agents=t.n_pursuers+t.n_evaders,this.statistics=Ft(s,0),this.positions=s.positions,this.last_positions=s.last_positions,
this.alive=s.alive,this.captured=s.captured,this.ever_captured=s.ever_captured,this.actions=s.actions,this.rewards=s.rewards,this.involved=s.involved,this.fault=
s.fault,this.map=s.map,this.conflict_table=s.conflict_table,this.first_conflict=On(this.conflict_table,this.length)}get length(){return this.actions.length/this.
n_agents}conflicts(t){this.check(t);let[r,n]=[this.first_conflict[t],this.first_conflict[t+1]],s=this.conflict_table.subarray(r*G,n*G);return xe(s,this.config.n_pursuers)}seek(t,r){
this.check(r),(!(t.seed===this.seed&&t.episode===BigInt(this.episode))||t.turn!==0||t.steps>r)&&t.reset({seed:this.seed,episode:this.episode});for(let s=t.steps;s<
r;++s)t.step(this.actions.subarray(s*this.n_agents,(s+1)*this.n_agents))}check(t){if(!(Number.isInteger(t)&&t>=0&&t<=this.length))throw _("step",`0 to ${this.length}`,
t)}};function On(e,t){let r=new Int32Array(t+2);for(let n=0;n<e.length;n+=G)++r[e[n]+1];for(let n=1;n<r.length;++n)r[n]+=r[n-1];return r}function Ft(e,t){let r=e["\
statistics.length"].length,n=o=>{let a=e[`statistics.${o}`],i=a.length/r;return a.slice(t*i,(t+1)*i)},s=o=>Number(n(o)[0]);return{capture_rate:s("capture_rate"),
ever_capture_rate:s("ever_capture_rate"),captured_fraction:s("captured_fraction"),length:s("length"),return:n("return"),survivors:n("survivors"),overlap:n("over\
lap"),collisions:n("collisions"),faults:n("faults"),agent_steps:n("agent_steps")}}function Wt(e,t,r,n){let s=[Me(r.config),K(r.pursuers),K(r.evaders),n];return ne(
e,o=>{let[a,i,l,c]=s.map(d=>o.arrays(d));return e[t](a,i,l,c)}),Se(e)}function jt(e,t,r,n){let s={seed:V("seed",r),episode:V("episode",n)};return new Ee(t.config,
r,n,Wt(e,"_play_match",t,s))}function Gt(e,t,r,n){if(!Number.isInteger(n)||n<1)throw _("n_episodes","at least 1",n);let s={seed:V("seed",r),n_episodes:Int32Array.
of(n)},o=Wt(e,"_play_rollout",t,s);return Array.from({length:n},(a,i)=>Ft(o,i))}var zt=new FinalizationRegistry(([e,t])=>e._world_free(t)),se=class{config;n_agents;n_actions;engine;at;freed=!1;constructor(t,r){this.engine=t,this.config=r,this.
n_agents=r.n_pursuers+r.n_evaders,this.n_actions=r.diagonal?9:5,this.at=ne(t,n=>t._world_new(n.arrays(Me(r)))),zt.register(this,[t,this.at],this)}free(){this.freed||
(this.freed=!0,zt.unregister(this),this.engine._world_free(this.at))}reset(t={}){let r=Ht(t,this.config);this.call(n=>this.engine._world_reset(this.at,n.arrays(
r)))}step(t){let r=Ae(t);this.call(n=>this.engine._world_step(this.at,n.arrays(r)))}playTurn(t){let r=Ae(t);this.call(n=>this.engine._world_play_turn(this.at,n.
arrays(r)))}decide(t,r,n){let{n_pursuers:s}=this.config,o=r==="pursuer"?[0,s]:[s,this.n_agents];return this.choose(t,o,n)}choose(t,[r,n],s){if(s.length!==this.n_agents)
throw _("actions",String(this.n_agents),s.length);let o=[K(t),Ae(s)],{actions:a}=this.call(i=>this.engine._world_decide(this.at,i.arrays(o[0]),r,n,i.arrays(o[1])));
return Uint8Array.from(a)}get n_turns(){return this.turnNumbers()[1]}get turn(){return this.turnNumbers()[0]}get actors(){let[,,t,r]=this.turnNumbers();return[t,
r]}turnNumbers(){return this.call(()=>this.engine._world_turn(this.at)).turn}get steps(){return this.read("steps")[0]}get seed(){return this.read("seed")[0]}get episode(){
return this.read("episode")[0]}get over(){return this.read("terminated")[0]===1||this.read("truncated")[0]===1}read(t){return this.call(r=>this.engine._world_read(
this.at,r.text(t)))[t]}view(t){let r=3*this.config.fov**2;return this.read("views").slice(t*r,(t+1)*r)}map(){return this.read("state").slice(2*this.config.rows*
this.config.cols)}conflicts(){let{conflict_table:t}=this.call(()=>this.engine._world_conflicts(this.at));return xe(t,this.config.n_pursuers)}answer(t,r){let n=K(
t),{logits:s}=this.call(i=>this.engine._world_logits(this.at,i.arrays(n),r)),o=s,a=this.choose(t,[r,r+1],new Uint8Array(this.n_agents))[r];return{logits:o,probabilities:$n(
o),action:a}}snapshot(){return this.call(()=>this.engine._world_snapshot(this.at))}restore(t){let r=Bt(t);this.call(n=>this.engine._world_restore(this.at,n.arrays(
r)))}call(t){if(this.freed)throw _("world","one that is in use","one that was freed");return ne(this.engine,t),Se(this.engine)}};function $n(e){let t=Math.max(...e),
r=Array.from(e,s=>Math.exp(s-t)),n=r.reduce((s,o)=>s+o,0);return Float32Array.from(r,s=>s/n)}var nt=class{compiled;constructor(t){this.compiled=t}world(t){return new se(this.compiled,t)}match(t,r,n,s,o=0){return jt(this.compiled,{config:t,pursuers:r,evaders:n},
s,o)}rollout(t,r,n,s,o){return Gt(this.compiled,{config:t,pursuers:r,evaders:n},s,o)}},Vt;function Kt(e=globalThis.matrixworldEngine){return Vt??=Pn(e),Vt}async function Pn(e){
if(!e)throw new Error("matrixworldEngine: expected the script engine.js before this one, got none");let t=Uint8Array.from(atob(e.binary),r=>r.charCodeAt(0));return new nt(
await e({wasmBinary:t}))}var Nn="http://www.w3.org/2000/svg";function u(e,t={},...r){return qt(document.createElement(e),t,r)}function y(e,t={},...r){return qt(document.createElementNS(
Nn,e),t,r)}function qt(e,t,r){for(let[n,s]of Object.entries(t))s==null||s===!1||(typeof s=="function"?e.addEventListener(n.slice(2),s):e.setAttribute(n,s===!0?"":
String(s)));return e.append(...r.filter(Ln).map(n=>typeof n=="number"?String(n):n)),e}function Ln(e){return e!=null&&e!==!1}var In=matchMedia("(prefers-color-scheme: dark)");function Un(){let e=document.documentElement.dataset.theme;return e?e==="dark":In.matches}function st(){document.
documentElement.dataset.theme=Un()?"light":"dark"}function Yt(){return u("button",{type:"button",title:"Light or dark (D)","aria-label":"Light or dark",onclick:st},"◐")}var Dn=2n**64n-1n;function ot(e,t,r){let n=new URLSearchParams(e.replace(/^#/,"")),s=(c,d,m)=>{let p=n.get(c)??"";return/^\d{1,9}$/.test(p)&&Number(p)<d?Number(
p):m},o=s("run",t.length,r.run),[a,i]=t[o].payoff.shape,l=n.get("seed")??"";return{run:o,pursuer:s("pursuers",a,Math.min(r.pursuer,a-1)),evader:s("evaders",i,Math.
min(r.evader,i-1)),episode:s("episode",1/0,r.episode),seed:/^\d{1,20}$/.test(l)&&BigInt(l)<=Dn?l:null,step:s("step",1/0,0)}}function Xt(e,t,r){let n="",s=()=>{let{
run:o,pursuer:a,evader:i,episode:l,seed:c}=t.selected,d={run:o,pursuers:a,evaders:i,episode:l,...c===null?{}:{seed:c},step:r.player.step};n=`#${Object.entries(d).
map(([m,p])=>`${m}=${p}`).join("&")}`;try{history.replaceState(null,"",n)}catch{}};t.on("match",s),r.player.addEventListener("state",()=>r.player.playing||s()),
r.player.addEventListener("step",()=>r.player.playing||s()),window.addEventListener("hashchange",()=>{if(location.hash===n)return;let{step:o,...a}=ot(location.hash,
e,t.selected);t.select(a),r.goTo(o)})}function Zt(){return JSON.parse(Ce("data"))}function oe(e,t,r){let[n,s]=[t-e.payoff.first[0],r-e.payoff.first[1]],o=e.payoff.capture_rate[n]?.[s];return o===void 0?
null:{rate:o,rates:e.payoff.capture_rates[n][s],lengths:e.payoff.lengths[n][s]}}function ae(e,t,r){let n=e.teams[t];return n.script!==null||n.kept.includes(r)}function ie(e,t,r){
let{script:n,network:s,kept:o,genomes:a}=e.teams[t];if(n!==null||s===null)return n??"random";let i=o.indexOf(r);if(i<0)throw new RangeError(`${t}: expected a ge\
neration whose genome the page holds, got ${r}`);let l=s.genome_size,c=Hn(a).subarray(i*l,(i+1)*l);return{hidden:s.hidden,activation:s.activation,sampled:s.sampled,
genome:c}}var Jt=new Map;function Hn(e){let t=Jt.get(e);if(t)return t;let r=new Float32Array(at(e).buffer);return Jt.set(e,r),r}function at(e){let t=atob(Ce(e)),
r=new Uint8Array(t.length);for(let n=0;n<r.length;n++)r[n]=t.charCodeAt(n);return r}function Ce(e){return document.getElementById(e)?.textContent??""}var Bn={now:()=>performance.now(),request:e=>requestAnimationFrame(e),cancel:e=>cancelAnimationFrame(e)},le=[.5,1,2,4,8,16,32,64],q=class extends EventTarget{#e;#n;#o;#a;#r=0;#t=0;#s=!1;#c=null;#u=0;glide=.28;constructor(t,r={}){
super(),this.#e=t,this.#n=r.speed??4,this.#a=r.still??!1,this.#o=r.clock??Bn}get step(){return this.#r}get time(){return this.#a?this.#r:this.#t}get arrived(){return this.#t===
this.#r}get playing(){return this.#s}get length(){return this.#e}set length(t){this.#e=t,this.#r>t&&this.jump(t),this.#m("state")}get speed(){return this.#n}set speed(t){
this.#n=t,this.#m("state")}changeSpeed(t){let r=le.findIndex(n=>n>=this.#n);this.speed=le[Math.min(le.length-1,Math.max(0,r+t))]}play(){this.#s||!this.#e||(this.#r===
this.#e&&this.jump(0),this.#s=!0,this.#m("state"),this.#d())}pause(){this.#s&&(this.#s=!1,this.#m("state"))}toggle(){this.#s?this.pause():this.play()}move(t){this.
pause();let r=Math.min(this.#e,Math.max(0,this.#r+t));Math.abs(r-this.#t)>1?this.jump(r):this.#i(r),this.#d()}jump(t){this.#t=Math.min(this.#e,Math.max(0,Math.round(
t))),this.#i(this.#t),this.#m("frame")}#i(t){t!==this.#r&&(this.#r=t,this.#m("step"),this.#a&&this.#m("frame"))}#d(){this.#c===null&&(this.#u=this.#o.now(),this.#c=
this.#o.request(()=>this.#l()))}#l(){this.#c=null;let t=this.#o.now();this.#h(Math.min(.25,(t-this.#u)/1e3)),this.#u=t,(!this.#a||this.arrived)&&this.#m("frame"),
(this.#s||this.#t!==this.#r)&&(this.#c=this.#o.request(()=>this.#l()))}#h(t){let r=t;for(;r>0;){if(this.#t===this.#r){if(!this.#s)return;if(this.#r===this.#e)return this.
pause();this.#i(this.#r+1)}let n=this.#s?this.#n:1/this.glide,s=this.#r-this.#t,o=Math.min(Math.abs(s),r*n);r-=o/n,this.#t=o===Math.abs(s)?this.#r:this.#t+Math.
sign(s)*o}this.#s&&this.#t===this.#e&&this.pause()}#m(t){this.dispatchEvent(new Event(t))}};function Y(e,t){if(t.ctrlKey||t.metaKey||t.altKey)return!1;let r=t.shiftKey?
10:1,s={" ":()=>e.toggle(),ArrowRight:()=>e.move(r),ArrowLeft:()=>e.move(-r),Home:()=>e.move(-e.length),End:()=>e.move(e.length),"+":()=>e.changeSpeed(1),"-":()=>e.
changeSpeed(-1)}[t.key];return s?.(),s!==void 0}var ce=[[68,1,84],[72,26,108],[71,47,125],[65,68,135],[57,86,140],[49,104,142],[42,120,142],[35,136,142],[31,152,139],[34,168,132],[53,183,121],[84,197,104],[122,
209,81],[165,219,54],[210,226,27],[253,231,37]];function ue(e){let t=Math.min(1,Math.max(0,e))*(ce.length-1),r=Math.min(ce.length-2,Math.floor(t)),[n,s]=[ce[r],
ce[r+1]],o=a=>Math.round(n[a]+(t-r)*(s[a]-n[a]));return[o(0),o(1),o(2)]}var Qt=e=>`rgb(${ue(e).join(" ")})`,er=()=>`linear-gradient(to right, ${ce.map(e=>`rgb(${e.
join(" ")})`).join(", ")})`;function Te(e,t,r){let n=devicePixelRatio||1;e.style.left=`${r.left}px`,e.style.top=`${r.top}px`,e.style.width=`${r.width}px`,e.style.height=`${r.height}px`,e.width=
Math.round(r.width*n),e.height=Math.round(r.height*n);let s=e.getContext("2d"),o=Fn(t);!s||!o||(s.imageSmoothingEnabled=!1,s.drawImage(o,0,0,e.width,e.height))}
function Fn(e){let[t,r]=e.shape,n=document.createElement("canvas");[n.width,n.height]=[r,t];let s=n.getContext("2d");if(!s)return null;let o=s.createImageData(r,
t);return e.capture_rate.forEach((a,i)=>a.forEach((l,c)=>{let d=4*((t-1-i-e.first[0])*r+c+e.first[1]);o.data.set([...ue(l),255],d)})),s.putImageData(o,0,0),n}var Wn=84;function tr(e,t){let r=e.map((o,a)=>jn(o,a,t)),n=u("nav",{class:"races",role:"tablist","aria-label":"Runs"},...r.map(o=>o.button)),s=()=>r.forEach((o,a)=>o.
update(a===t.selected.run));return t.on("match",s),t.on("hover",s),s(),n.hidden=e.length<2,n}function jn(e,t,r){let[n,s]=e.payoff.shape,o=Wn/Math.max(n,s),a=u("\
canvas",{"aria-hidden":"true"});Te(a,e.payoff,{left:0,top:0,width:s*o,height:n*o});let i=u("span",{class:"place"}),l=u("button",{type:"button",role:"tab",class:"\
race",title:`Key ${t+1}`,onclick:()=>it(e,t,r)},u("span",{class:"small-matrix"},a,i),u("span",{class:"race-text"},u("strong",{},e.name),u("span",{class:"small"},
e.findings?e.findings.headline:`${e.learning.join(" and ")}s against ${Gn(e)}`),e.schedule===e.name?null:u("span",{class:"small muted"},`${e.schedule}, seed ${e.
seed}`)));return{button:l,update:d=>{l.ariaSelected=String(d);let m=r.hover.pursuer??r.selected.pursuer,p=r.hover.evader??r.selected.evader;i.hidden=m>=n||p>=s,
i.style.left=`${(p+.5)*o}px`,i.style.top=`${(n-m-.5)*o}px`}}}var Gn=e=>e.teams.pursuer.script??e.teams.evader.script??"another run";function it(e,t,r){let[n,s]=e.
payoff.shape,{pursuer:o,evader:a}=r.selected;r.select({run:t,pursuer:Math.min(o,n-1),evader:Math.min(a,s-1)})}var zn=[[["Space"],"play or pause"],[["←","→"],"step back or forward; with Shift ten steps"],[["Home","End"],"first or last step"],[["+","−"],"faster or s\
lower"],[["N"],"next episode of the same pair; with Shift the one before"],[["R"],"another seed, not one of the evaluation"],[["O"],"the cell's own seed again"],
[["P"],"next pursuer generation; with Shift the one before"],[["E"],"next evader generation; with Shift the one before"],[["M"],"to the matrix: arrow keys choos\
e a match, Enter plays it"],[["A"],"next agent: what it sees; with Shift the one before"],[["Esc"],"no agent"],[["G"],"this step in the playground: any other ru\
les, actions and places"],[["1","9"],"first to ninth run"],[["D"],"light or dark"],[["?"],"this list"]];function rr(){let e=zn.map(([r,n])=>u("div",{class:"key-\
row"},u("dt",{},...r.map(s=>u("kbd",{},s))),u("dd",{},n))),t=u("dialog",{class:"help","aria-labelledby":"help-title"},u("h2",{id:"help-title"},"Keys"),u("dl",{class:"\
keys"},...e),u("p",{class:"muted small"},"The page holds the genomes and the engine of this run. A click on a cell plays that very match: same seed, same moves.\
 Triangles pursue, discs evade; a ring is a captured evader, a star a capture, dashed cells are conflicts. The page loads nothing from elsewhere; share the file\
 as it is."),u("button",{type:"button",onclick:()=>t.close()},"Close"));return t.addEventListener("click",r=>r.target===t&&t.close()),t}function nr(e,t,r,n,s){let o=(i,l)=>()=>{
let c=e[t.selected.run].payoff.shape[i==="pursuer"?0:1];t.select({[i]:Math.min(c-1,Math.max(0,t.selected[i]+l))})},a={n:()=>t.select({episode:t.selected.episode+
1}),N:()=>t.select({episode:Math.max(0,t.selected.episode-1)}),r:()=>t.select({seed:String(crypto.getRandomValues(new BigUint64Array(1))[0]),episode:0}),o:()=>t.
select({seed:null,episode:0}),p:o("pursuer",1),P:o("pursuer",-1),e:o("evader",1),E:o("evader",-1),m:()=>document.getElementById("matrix")?.focus(),a:()=>r.inspector.
next(1),A:()=>r.inspector.next(-1),Escape:()=>r.inspector.choose(null),g:s,d:st,"?":()=>n.showModal()};document.addEventListener("keydown",i=>{let l=i.target instanceof
HTMLSelectElement||i.target instanceof HTMLInputElement,c=i.target instanceof HTMLButtonElement&&(i.key===" "||i.key==="Enter");if(document.querySelector("dialo\
g[open]")||l||c||i.defaultPrevented||i.ctrlKey||i.metaKey||i.altKey)return;let d=a[i.key]??a[i.key.toLowerCase()],m=Number(i.key)-1;if(Y(r.player,i)||d)d?.();else if(e[m])
it(e[m],m,t);else return;i.preventDefault()})}var lt=[[0,0],[-1,0],[0,1],[1,0],[0,-1],[-1,1],[1,1],[1,-1],[-1,-1]],B=(e,t)=>t<e.nPursuers,M=(e,t)=>[e.positions[2*t],e.positions[2*t+1]],Vn=(e,t)=>e[0]===t[0]&&
e[1]===t[1],ct=({rows:e,cols:t},[r,n])=>r>=0&&n>=0&&r<e&&n<t,ut=(e,t,r=3)=>e!==void 0&&[0,1,2].slice(0,r).some(n=>e[3*t+n]),dt=(e,t)=>ut(e.fault,t),sr=(e,t)=>!dt(
e,t)&&ut(e.involved,t,2);function Re(e,t,r){let n=!Vn(M(e,r),M(t,r)),s=t.involved===void 0||ut(t.involved,r);return!!(t.alive[r]&&t.actions?.[r]&&!n&&s)}function ke(e,t,r){
let[n,s]=M(e,r),[o,a]=lt[t.actions?.[r]??0];return[n+o,s+a]}function Oe(e,t,r){return Array.from({length:r.everCaptured.length},(s,o)=>o).filter(s=>r.everCaptured[s]&&
!t.everCaptured[s]).map(s=>e.nPursuers+s)}function $e(e,t){return Array.from({length:t.alive.length},(n,s)=>s).filter(n=>e.alive[n]&&!t.alive[n])}var or=[-.31,0,.31],ar=[{size:1,at:[[0,0]]},{size:.62,at:[[-.2,.2],[.2,-.2]]},{size:.54,at:[[-.23,.22],[.23,.22],[0,-.22]]},{size:.54,at:[[-.23,.23],[.23,.23],[
-.23,-.23],[.23,-.23]]},{size:.36,at:or.flatMap(e=>or.map(t=>[t,e]))}],Kn=.3,qn=.35,Yn=.55;function de(e,t){let r=new Map;for(let n=0;n<t.alive.length;n++){if(!t.
alive[n])continue;let[s,o]=M(t,n),a=s*e.cols+o,i=r.get(a);i?i.push(n):r.set(a,[n])}return r}function ir(e,t){let r=Array.from(t.alive,(n,s)=>{let[o,a]=M(t,s);return{
x:a+.5,y:o+.5,size:1,alpha:0}});for(let n of de(e,t).values()){let s=ar[Math.min(n.length,ar.length)-1];n.forEach((o,a)=>{let[i,l]=s.at[Math.min(a,s.at.length-1)],
c=r[o];c.x+=i,c.y+=l,c.size=s.size,c.alpha=1})}return r}var lr=e=>e*e*(3-2*e),X=(e,t,r)=>e+(t-e)*r,cr=e=>Math.min(1,Math.max(0,e));function ur(e,t,r,n){let s={1:2,
2:r}[e.interaction]??1;if(s===1)return lr(n);let o=s===r?t:+!B(e,t),a=Math.max(1/s,qn);return lr(cr((n-o/(s-1)*(1-a))/a))}function Pe(e,t){let r=e.moments.length-
1,n=Math.min(Math.floor(t),r),s=e.moments[n],o=ir(e,s);if(n===r||t===n)return o;let a=e.moments[n+1],i=ir(e,a);return o.map((l,c)=>{let d=ur(e,c,o.length,t-n);return Xn(
s,a,c,l,i[c],d)})}function dr(e,t,r){let n=e.moments.length-1,s=Math.min(Math.floor(r),n),[o,a]=[e.moments[s],e.moments[Math.min(s+1,n)]],i=ur(e,t,o.alive.length,
r-s),[[l,c],[d,m]]=[M(o,t),M(a,t)];return[X(c,m,i)+.5,X(l,d,i)+.5]}function Xn(e,t,r,n,s,o){let a=n.alpha>s.alpha,i={x:X(n.x,s.x,o),y:X(n.y,s.y,o),size:a?n.size:
X(n.size,s.size,o),alpha:a?cr((1-o)/(1-Yn)):X(n.alpha,s.alpha,o)};if(Re(e,t,r)){let[l,c]=M(e,r),[d,m]=ke(e,t,r),p=Kn*Math.sin(Math.PI*o);i.x+=(m-c)*p,i.y+=(d-l)*
p}return i}var mr=2*Math.PI;function F(e,t,r,n){e.beginPath(),e.arc(t,r,n/2,0,mr)}function Ne(e,t,r,n){let s=n/2,o=[[0,-.97],[.97,.83],[-.97,.83]].map(([a,i])=>[t+a*s,r+i*
s]);e.beginPath(),e.moveTo((o[2][0]+o[0][0])/2,(o[2][1]+o[0][1])/2),o.forEach(([a,i],l)=>{let[c,d]=o[(l+1)%3];e.arcTo(a,i,c,d,n*.09)}),e.closePath()}function pr(e,t,r,n){
let s=n*.32;e.beginPath(),e.moveTo(t-s,r-s),e.lineTo(t+s,r+s),e.moveTo(t+s,r-s),e.lineTo(t-s,r+s)}function hr(e,t,r,n){e.beginPath();for(let s=0;s<16;s++){let o=n/
2*(s%2?.6:.95),a=mr*s/16;e.lineTo(t+o*Math.sin(a),r-o*Math.cos(a))}e.closePath()}function fr(e,t,r,n,s,o){let a=Math.atan2(s-r,n-t);e.beginPath(),e.moveTo(t,r),
e.lineTo(n,s);for(let i of[-1,1])e.moveTo(n,s),e.lineTo(n-o*Math.cos(a+i*.6),s-o*Math.sin(a+i*.6))}var gr=4,Jn=1.6,Zn=.95,Qn=5,es=.16,ts=9,rs=.09,ns=.2,yr=.75,k=(e,t)=>e.left+t*e.cell,O=(e,t)=>e.top+t*e.cell;function J(e,t,r){return B(t,r)?e.colors.pursuer:e.
colors.evader}function br({ctx:e,grid:t,colors:r}){let{left:n,top:s,cell:o,rows:a,cols:i}=t,[l,c]=[i*o,a*o];if(e.fillStyle=r.paper,e.fillRect(n,s,l,c),o<Qn)return;
e.fillStyle=r.line;let d=Math.max(1,Math.round(o/60));for(let m=1;m<i;m++)e.fillRect(n+m*o,s,d,c);for(let m=1;m<a;m++)e.fillRect(n,s+m*o,l,d)}function vr({ctx:e,
grid:t,colors:r},n){let{left:s,top:o,cell:a,rows:i,cols:l}=t;e.fillStyle=r.obstacle;for(let d=0;d<i*l;d++){if(!n.obstacles[d])continue;let[m,p]=[Math.floor(d/l),
d%l];e.fillRect(s+p*a,o+m*a,a,a)}let c=Math.min(5,Math.max(2,Math.round(a/18)));e.strokeStyle=r.frame,e.lineWidth=c,e.strokeRect(s-c/2,o-c/2,l*a+c,i*a+c)}function wr({
ctx:e,grid:t,colors:r},n){let{left:s,top:o,cell:a,rows:i,cols:l}=t,c=a<24*n?5:1;e.font=`500 ${Math.round(Math.min(15*n,Math.max(9*n,a*.32)))}px system-ui, sans-\
serif`,e.fillStyle=r.muted,e.textBaseline="alphabetic",e.textAlign="center";let d=5*n+a/40;for(let m=0;m<l;m+=c)e.fillText(String(m),s+(m+.5)*a,o-d);e.textAlign=
"right",e.textBaseline="middle";for(let m=0;m<i;m+=c)e.fillText(String(m),s-d,o+(m+.5)*a)}function xr(e,t,r,n,s){let{ctx:o,grid:a}=e,i=Math.floor(t.fov/2)+.5,[l,
c]=[Math.max(0,n-i),Math.min(a.cols,n+i)],[d,m]=[Math.max(0,s-i),Math.min(a.rows,s+i)],p=[k(a,l),O(a,d),(c-l)*a.cell,(m-d)*a.cell],f=J(e,t,r);o.globalAlpha=.11,
o.fillStyle=f,o.fillRect(...p),o.globalAlpha=.8,o.strokeStyle=f,o.lineWidth=Math.max(1,a.cell/24),o.strokeRect(...p),o.globalAlpha=1}function Sr(e,t,r,n,s){let{
ctx:o,grid:a}=e,i=Math.min(Math.ceil(r),t.moments.length-1),l=t.moments[i];o.lineCap="round",o.lineWidth=Math.min(ts,Math.max(1,a.cell*es));for(let c=Math.max(1,
Math.floor(r-n)+1);c<=i;c++){let[d,m]=[t.moments[c-1],t.moments[c]],p=Math.max(0,Math.min(1,(r-c)/n));o.globalAlpha=yr+(ns-yr)*p;for(let f=0;f<m.alive.length;f++){
let g=c===i&&r<i;if(!d.alive[f]||!(l.alive[f]||g))continue;let h=(B(t,f)?-1:1)*rs,[b,w]=M(d,f),[S,v]=M(m,f);if(b===S&&w===v)continue;let x=g?s[f].x:v+.5,C=g?s[f].
y:S+.5;o.strokeStyle=J(e,t,f),o.beginPath(),o.moveTo(k(a,w+.5+h),O(a,b+.5+h)),o.lineTo(k(a,x+h),O(a,C+h)),o.stroke()}}o.globalAlpha=1}function _r(e,t,r){let n=Math.
min(Math.ceil(r),t.moments.length-1);for(let s=Math.max(1,n-gr+1);s<=n;s++){let[o,a]=[t.moments[s-1],t.moments[s]],i=s>r?Math.max(0,1-2*(s-r)):1-(r-s)/gr,l=Oe(t,
o,a);for(let c of $e(o,a))l.includes(c)||os(e,M(a,c),i);for(let c of l)ss(e,M(a,c),i)}e.ctx.globalAlpha=1}function ss({ctx:e,grid:t,colors:r},[n,s],o){e.globalAlpha=
o,hr(e,k(t,s+.5),O(t,n+.5),Math.max(8,t.cell*Jn)),e.fillStyle=r.capture,e.fill(),e.strokeStyle=r.ink,e.lineWidth=Math.max(1,t.cell/36),e.lineJoin="round",e.stroke()}
function os({ctx:e,grid:t,colors:r},[n,s],o){e.globalAlpha=o,pr(e,k(t,s+.5),O(t,n+.5),Math.max(7,t.cell*Zn)),e.strokeStyle=r.collision,e.lineWidth=Math.max(2,t.
cell*.17),e.lineCap="round",e.stroke()}function Mr({ctx:e,grid:t,colors:r},n,s){let o=Math.max(1,t.cell*.07);e.strokeStyle=e.fillStyle=r.collision,e.lineWidth=Math.
max(1,t.cell*.05),e.setLineDash([t.cell*.14,t.cell*.1]);for(let[a,i]of n){if(a<0||i<0||a>=t.rows||i>=t.cols)continue;let l=[k(t,i)+o,O(t,a)+o,t.cell-2*o,t.cell-
2*o];e.globalAlpha=.2*s,e.fillRect(...l),e.globalAlpha=s,e.strokeRect(...l)}e.setLineDash([]),e.globalAlpha=1}function Ar({ctx:e,grid:t,colors:r},n,s,o,a){e.globalAlpha=
a,F(e,k(t,n),O(t,s),Math.max(8,t.cell*o*1.02)),e.strokeStyle=r.collision,e.lineWidth=Math.max(1.5,t.cell*.085*Math.sqrt(o)),e.stroke(),e.globalAlpha=1}var as=.8,is=.92,ls=15,cs=7,ht=9;function Er(e,t,r,n,s,o){n.forEach((a,i)=>{a.alpha>0&&us(e,t,r,i,a,s,o)}),e.ctx.globalAlpha=1;for(let a of de(t,r).values())a.length>
ht&&ds(e,n[a[ht-1]],a.length-ht+1)}function us(e,t,r,n,s,o,a){let{ctx:i,grid:l,colors:c}=e,d=B(t,n),[m,p]=[l.left+s.x*l.cell,l.top+s.y*l.cell],f=Math.max(4,l.cell*
s.size*(d?is:as)),g=J(e,t,n),h=!d&&!!r.captured[n-t.nPursuers];if(i.globalAlpha=s.alpha,(d?Ne:F)(i,m,p,f),f>cs*a&&(i.strokeStyle=c.paper,i.lineWidth=Math.max(2,
f*.1),i.stroke()),i.fillStyle=h?c.paper:g,i.fill(),h&&(F(i,m,p,f*.82),i.strokeStyle=g,i.lineWidth=f*.18,i.stroke()),!o||f<ls*a)return;let b=String(d?n:n-t.nPursuers);
i.font=`700 ${Math.round(f*(d?.4:.5)*(b.length>1?.8:1))}px system-ui, sans-serif`,i.textAlign="center",i.textBaseline="middle",i.fillStyle=h?g:c.paper,i.fillText(
b,m,p+f*(d?.17:.03))}function ds({ctx:e,grid:t,colors:r},n,s){let[o,a]=[t.left+n.x*t.cell,t.top+n.y*t.cell];e.font=`700 ${Math.round(t.cell*.3)}px system-ui, sa\
ns-serif`,e.textAlign="center",e.textBaseline="middle",e.strokeStyle=r.paper,e.lineWidth=t.cell*.1,e.strokeText(`+${s}`,o,a),e.fillStyle=r.ink,e.fillText(`+${s}`,
o,a)}var ms=.46,ps=.86,hs=.66,Cr=.48,fs=.78,gs=.58;function Tr(e,t,r,n){let[s,o]=[t.moments[r-1],t.moments[r]];if(!s)return;let{ctx:a,grid:i,colors:l}=e;a.strokeStyle=
l.collision,a.lineWidth=Math.max(1.5,i.cell*.07),a.lineCap="butt",a.globalAlpha=n;for(let c=0;c<o.alive.length;c++)Re(s,o,c)&&ys(e,t,M(s,c),ke(s,o,c));a.globalAlpha=
1}function ys({ctx:e,grid:t},r,n,s){let[o,a]=[s[1]-n[1],s[0]-n[0]],i=m=>k(t,n[1]+.5+o*m),l=m=>O(t,n[0]+.5+a*m),c=ct(r,s)?fs:gs;e.setLineDash([t.cell*.09,t.cell*
.06]),e.beginPath(),e.moveTo(i(Cr),l(Cr)),e.lineTo(i(c),l(c)),e.stroke(),e.setLineDash([]);let d=.17*t.cell/Math.hypot(o,a);e.beginPath(),e.moveTo(i(c)-a*d,l(c)+
o*d),e.lineTo(i(c)+a*d,l(c)-o*d),e.stroke()}function Rr(e,t,r,n,s,o){let a=lt[o];if(!o||!a)return;let{ctx:i,grid:l,colors:c}=e,d=ct(t,[n[0]+a[0],n[1]+a[1]])?ps:
hs,m=ms*s.size,p=[k(l,s.x+a[1]*m),O(l,s.y+a[0]*m),k(l,s.x+a[1]*d),O(l,s.y+a[0]*d)],f=Math.max(1.5,l.cell*.085);i.lineCap=i.lineJoin="round";for(let[g,h]of[[c.paper,
f*2.1],[J(e,t,r),f]])i.strokeStyle=g,i.lineWidth=h,fr(i,...p,l.cell*.2),i.stroke()}var Or={numbers:!0,axes:!1,trail:6,viewers:[],plan:null,selected:null,cursor:null};function $r(e,t,r,n,s){let{ctx:o,grid:a,colors:i}=e,l=Math.min(Math.ceil(r),t.
moments.length-1),c=t.moments[l],d=r===l,m=Pe(t,r),p=d?1:Math.max(0,1-2*(l-r));o.clearRect(0,0,o.canvas.width,o.canvas.height),br(e);for(let h of n.viewers)m[h]?.
alpha&&xr(e,t,h,...dr(t,h,r));vr(e,t),n.axes&&wr(e,s),Sr(e,t,r,n.trail,m),Mr(e,c.contested??[],p),_r(e,t,r),Tr(e,t,l,p),m.forEach(({x:h,y:b,size:w},S)=>{let v=sr(
c,S)?.4:0,x=dt(c,S)?1:v;x&&Ar(e,h,b,w,x*p)});let f=d?c:t.moments[Math.max(0,l-1)];if(Er(e,t,f,m,n.numbers,s),d&&n.plan)for(let[h,b]of m.entries())b.alpha&&Rr(e,
t,h,M(c,h),b,n.plan[h]??0);o.lineWidth=Math.max(2,2.5*s),o.strokeStyle=i.focus;let g=n.selected===null?void 0:m[n.selected];g?.alpha&&kr(e,g.x,g.y,g.size*.96),n.
cursor&&(o.setLineDash([a.cell*.12,a.cell*.08]),kr(e,n.cursor[1]+.5,n.cursor[0]+.5,.8),o.setLineDash([]))}function kr({ctx:e,grid:t},r,n,s){let o=s*t.cell;e.beginPath(),
e.roundRect(t.left+r*t.cell-o/2,t.top+n*t.cell-o/2,o,o,o*.1),e.stroke()}var Pr=(e,t)=>(t+.24)/(e+.24);function Nr(e,t,r,n,s,o){let a=r?28*o:0,i=(c,d)=>(c-a)/(d+2*.12),l=Math.max(1,Math.floor(Math.min(i(n,t),i(s,e))));return{rows:e,cols:t,
cell:l,left:Math.round((n-t*l+a)/2),top:Math.round((s-e*l+a)/2)}}function Lr(e,t,r){let n=Math.floor((r-e.top)/e.cell),s=Math.floor((t-e.left)/e.cell);return n>=
0&&n<e.rows&&s>=0&&s<e.cols?[n,s]:null}var bs={paper:"--board-paper",line:"--board-line",frame:"--board-frame",ink:"--board-ink",muted:"--board-muted",obstacle:"--board-obstacle",pursuer:"--pursuer",
evader:"--evader",capture:"--capture",collision:"--collision",focus:"--focus"};function Le(e){let t=getComputedStyle(e),r=Object.entries(bs).map(([n,s])=>[n,t.getPropertyValue(
s).trim()]);return Object.fromEntries(r)}var Q=()=>matchMedia("(prefers-reduced-motion: reduce)").matches,Z=class{canvas;#e=null;#n=0;#o;#a={rows:1,cols:1,left:0,top:0,cell:1};#r=0;#t;#s;constructor(t,r={}){
this.canvas=t,t.classList.add("board"),t.setAttribute("role","img"),this.#o={...Or,...r},this.#t=new ResizeObserver(()=>this.#u()),this.#t.observe(t),this.#s=new MutationObserver(
()=>this.redraw()),this.#s.observe(document.documentElement,{attributes:!0}),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",this.redraw)}close(){
this.#t.disconnect(),this.#s.disconnect(),matchMedia("(prefers-color-scheme: dark)").removeEventListener("change",this.redraw),cancelAnimationFrame(this.#r)}get look(){
return this.#o}set look(t){this.#o={...this.#o,...t},this.#c(),this.redraw()}get time(){return this.#n}show(t,r){this.#e=t,this.#n=Math.min(Math.max(0,r),t.moments.
length-1),this.#c(),this.redraw()}redraw=()=>{this.#r||(this.#r=requestAnimationFrame(()=>this.drawNow()))};drawNow(){cancelAnimationFrame(this.#r),this.#r=0;let t=this.
canvas.getContext("2d");if(!t||!this.#e)return;let{rows:r,cols:n}=this.#e,s=devicePixelRatio||1;this.#a=Nr(r,n,this.#o.axes,this.canvas.width,this.canvas.height,
s);let o={ctx:t,grid:this.#a,colors:Le(this.canvas)};$r(o,this.#e,this.#n,this.#o,s)}cellAt(t,r){let n=this.canvas.getBoundingClientRect(),s=this.canvas.width/n.
width;return Lr(this.#a,(t-n.left)*s,(r-n.top)*s)}agentAt(t,r){let n=this.cellAt(t,r);if(!n||!this.#e)return null;let s=this.#e.moments[Math.round(this.#n)],o=de(
this.#e,s).get(n[0]*this.#e.cols+n[1])??[],a=Pe(this.#e,Math.round(this.#n)),i=l=>{let[c,d]=this.pointOf(a[l].x,a[l].y);return Math.hypot(c-t,d-r)};return o.length?
o.reduce((l,c)=>i(c)<i(l)?c:l):null}pointOf(t,r){let n=this.canvas.getBoundingClientRect(),s=n.width/this.canvas.width,{left:o,top:a,cell:i}=this.#a;return[n.left+
(o+t*i)*s,n.top+(a+r*i)*s]}#c(){if(!this.#e)return;let{rows:t,cols:r}=this.#e;this.canvas.style.setProperty("--board-aspect",String(Pr(t,r)))}#u(){let t=devicePixelRatio||
1,{width:r,height:n}=this.canvas.getBoundingClientRect();this.canvas.width=Math.max(1,Math.round(r*t)),this.canvas.height=Math.max(1,Math.round(n*t)),this.drawNow()}};var ws={SIMULTANEOUS:0,SWARM_TURNS:1,AGENT_TURNS:2};function xs(e,t,r){return{rows:e.rows,cols:e.cols,nPursuers:e.n_pursuers,fov:e.fov,interaction:ws[e.rules.interaction],
obstacles:t,moments:r}}function Ie(e){let t=Array.from({length:e.length+1},(r,n)=>Ss(e,n));return xs(e.config,e.map,t)}function Ss(e,t){let r=e.n_agents,n=e.config.n_evaders,s=(a,i,l)=>a.
subarray(i*l,(i+1)*l),o={positions:s(e.last_positions,t,2*r),alive:s(e.alive,t,r),captured:s(e.captured,t,n),everCaptured:s(e.ever_captured,t,n)};return t===0?o:
{...o,actions:s(e.actions,t-1,r),involved:s(e.involved,t-1,3*r),fault:s(e.fault,t-1,3*r),get contested(){return e.conflicts(t).map(a=>a.cell)}}}var _s={first:"M6 5v14M19 5 9 12l10 7z",back:"M17 5 7 12l10 7z",play:"M7 4.5 19 12 7 19.5z",pause:"M8 5v14M16 5v14",forward:"M7 5l10 7-10 7z",last:"M18 5v14M5 5\
l10 7-10 7z"};function Ir(e){let t=document.createElementNS("http://www.w3.org/2000/svg","svg");t.setAttribute("viewBox","0 0 24 24"),t.setAttribute("aria-hidde\
n","true"),t.classList.add("icon");let r=document.createElementNS("http://www.w3.org/2000/svg","path");return r.setAttribute("d",_s[e]),t.append(r),t}function me(e,t,r,n){
let s=document.createElement("button");return s.type="button",s.className="player-button",s.append(Ir(e)),s.ariaLabel=t,s.title=`${t} (${r})`,s.addEventListener(
"click",n),s}function Ue(e){let t=document.createElement("div");t.className="player",t.role="group",t.ariaLabel="Player";let r=me("play","Play","Space",()=>e.toggle()),
n=Ms(e),s=As(e),o=document.createElement("output");o.className="player-count",t.append(me("first","First step","Home",()=>e.move(-e.length)),me("back","Step bac\
k","←",()=>e.move(-1)),r,me("forward","Step forward","→",()=>e.move(1)),me("last","Last step","End",()=>e.move(e.length)),n,o,s);let a=()=>{r.replaceChildren(
Ir(e.playing?"pause":"play")),r.ariaLabel=e.playing?"Pause":"Play",r.title=`${r.ariaLabel} (Space)`,n.max=String(e.length),n.value=String(e.step),n.ariaValueText=
`step ${e.step} of ${e.length}`,o.textContent=`${e.step} / ${e.length}`,o.style.minWidth=`${2*String(e.length).length+3}ch`,s.value=String(e.speed)};return e.addEventListener(
"step",a),e.addEventListener("state",a),t.addEventListener("keydown",i=>{!(i.target instanceof HTMLSelectElement||i.key===" "&&i.target!==n)&&Y(e,i)&&i.preventDefault()}),
a(),t}function Ms(e){let t=document.createElement("input");return t.type="range",t.className="player-scrub",t.min="0",t.step="1",t.ariaLabel="Step",t.addEventListener(
"input",()=>{e.pause(),e.jump(Number(t.value))}),t}function As(e){let t=document.createElement("select");return t.className="player-speed",t.ariaLabel="Speed",t.
title="Steps a second (+ and -)",t.append(...le.map(r=>new Option(`${r} / s`,String(r)))),t.addEventListener("change",()=>{e.speed=Number(t.value)}),t}var A=(e,t=2)=>e==null?"-":e.toFixed(t),ft=(e,t=1)=>e==null?"-":`${(100*e).toFixed(t)} %`;function De(e,t,r,n=2){return t===null||r===null?e.toFixed(n):`${e.toFixed(
n)} (${t.toFixed(n)} to ${r.toFixed(n)})`}var Ur=e=>e.toLocaleString("en-GB");function pe(e,t,r,n=!1){let s=(t-e)/Math.max(1,r),o=10**Math.floor(Math.log10(s||1)),
a=[1,2,5,10].map(c=>c*o).find(c=>c>=s)??10*o;n&&(a=Math.max(1,Math.round(a)));let i=Math.ceil(e/a-1e-9),l=Math.floor(t/a+1e-9);return Array.from({length:Math.max(
0,l-i+1)},(c,d)=>(i+d)*a)}function I(e,t,{pursuer:r,evader:n,episode:s,seed:o}){let a=t.seeds[r][n];return e.match(t.world,ie(t,"pursuer",r),ie(t,"evader",n),BigInt(o??a),s)}var Dr=40,he=new Map,fe=({run:e,pursuer:t,evader:r},n)=>`${e} ${t} ${r} ${n}`,He=class{element;#e;#n;#o=u("div",{class:"episodes",role:"group","aria-label":"Epi\
sodes of this cell"});#a=u("p",{class:"check small numbers","aria-live":"polite"});#r=0;constructor(t,r){[this.#e,this.#n]=[t,r],this.element=u("div",{class:"st\
rip-of-episodes"},this.#o,this.#a)}show(t,r,n){let{selected:s}=this.#e;s.seed===null&&he.set(fe(s,s.episode),Hr(n)),this.#s(r),Cs(this.#r),this.#t(t,r)}#t(t,r){
let{selected:n}=this.#e,o=oe(r,n.pursuer,n.evader)?.rates.findIndex((a,i)=>!he.has(fe(n,i)))??-1;o<0||o>=Dr||(this.#r=Es(()=>{this.#n.playing||(he.set(fe(n,o),Hr(
I(t,r,{...n,episode:o,seed:null}))),this.#s(r)),this.#t(t,r)}))}#s(t){let{selected:r}=this.#e,n=oe(t,r.pursuer,r.evader);if(!n){this.#o.replaceChildren(),this.#a.
textContent="The evaluation played no episodes of this pair.";return}let s=Math.min(Dr,n.rates.length);this.#o.replaceChildren(...n.rates.slice(0,s).map((c,d)=>this.#c(
c,d)));let o=n.rates.slice(0,s).map((c,d)=>he.get(fe(r,d))),a=o.filter(c=>c!==void 0),i=o.flatMap((c,d)=>c&&(Math.abs(c.rate-n.rates[d])>1e-6||c.length!==n.lengths[d])?
[d+1]:[]),l=a.reduce((c,d)=>c+d.rate,0)/a.length;this.#a.dataset.equal=String(!i.length&&a.length===n.rates.length),this.#a.textContent=i.length?`Episode ${i.join(
", ")} differs from the evaluation.`:a.length<n.rates.length?`Played here: ${a.length} of ${n.rates.length} episodes, all as in the evaluation.`:`Played here: a\
ll ${a.length} episodes, mean capture rate ${A(l,3)}. The cell says ${A(n.rate,3)}.`}#c(t,r){let{selected:n}=this.#e,s=u("span",{class:"bar"});return s.style.height=
`${Math.round(100*t)}%`,u("button",{type:"button",class:"episode",title:`Episode ${r+1}: capture rate ${A(t)}`,"aria-label":`Episode ${r+1}, capture rate ${A(t)}`,
"aria-pressed":String(r===n.episode&&n.seed===null),"data-played":he.has(fe(n,r)),onclick:()=>this.#e.select({episode:r,seed:null})},s,u("span",{class:"count"},
r+1))}},Hr=e=>({rate:e.statistics.capture_rate,length:e.length}),Es=e=>"requestIdleCallback"in window?requestIdleCallback(e,{timeout:1e3}):setTimeout(e,100),Cs=e=>"\
cancelIdleCallback"in window?cancelIdleCallback(e):clearTimeout(e);var ge=(e,t)=>e<t?`pursuer_${e}`:`evader_${e-t}`,gt=["stay","north","east","south","west","northeast","southeast","southwest","northwest"];var Br=0,Fr=1,Ts=2,Rs=176;function jr(e,t,r,n){let s=devicePixelRatio||1,o=Le(e);e.width=e.height=Rs*s;let a=e.getContext("2d");if(!a)return;let{fov:i}=t,l=e.width/
i;a.fillStyle=o.paper,a.fillRect(0,0,e.width,e.height);for(let d=0;r&&d<i*i;d++){let[m,p]=[(d%i+.5)*l,(Math.floor(d/i)+.5)*l],f=h=>!!r[h*i*i+d];f(Ts)&&(a.fillStyle=
o.obstacle,a.fillRect(m-l/2,p-l/2,l,l));let g=f(Br)&&f(Fr)?l*.18:0;f(Br)&&Wr(a,F,m+g,p+g,l*.74,o.evader),f(Fr)&&Wr(a,Ne,m-g,p-g,l*.86,o.pursuer)}a.strokeStyle=n<
t.n_pursuers?o.pursuer:o.evader,a.lineWidth=2*s;let c=Math.floor(i/2)*l;a.strokeRect(c,c,l,l)}function Wr(e,t,r,n,s,o){t(e,r,n,s),e.fillStyle=o,e.fill()}var Be=class{element;#e;#n=u("canvas",{class:"seen",role:"img"});#o=u("h3");#a=u("p",{class:"small muted"});#r=u("div",{class:"answers"});#t=null;#s=null;#c=null;#u=null;#i=null;#d=0;constructor(t){
this.#e=t,this.element=u("div",{class:"inspector","data-open":"false"},u("p",{class:"hint small muted"},"Click an agent, or press A: what it sees, and what its \
network answers."),u("div",{class:"inspected"},this.#n,u("div",{class:"answer"},this.#o,this.#a),this.#r))}get agent(){return this.#i}show(t,r,n,s){(this.#s!==r||
!this.#t)&&(this.#t?.free(),this.#t=t.world(r.world),this.#i!==null&&this.#s!==r&&this.choose(null)),[this.#s,this.#c,this.#u]=[r,n,s]}choose(t){this.#i=t,this.
element.dataset.open=String(t!==null),this.#e(t),this.at(this.#d)}next(t){let r=this.#c;if(!r)return;let n=this.#i??(t>0?-1:0);for(let s=0;s<r.n_agents;s++)if(n=
(n+t+r.n_agents)%r.n_agents,r.alive[this.#d*r.n_agents+n])return this.choose(n)}at(t){this.#d=t;let[r,n,s,o,a]=[this.#c,this.#t,this.#s,this.#u,this.#i];if(!r||
!n||!s||!o||a===null)return;let i=a<r.config.n_pursuers?"pursuer":"evader";this.#o.replaceChildren(u("span",{class:i},ge(a,r.config.n_pursuers)));let l=!!r.alive[t*
r.n_agents+a];r.seek(n,t),jr(this.#n,r.config,l?n.view(a):null,a),this.#n.ariaLabel=`Field of view of ${ge(a,r.config.n_pursuers)}: evaders, pursuers and obstac\
les around it`;let c=t<r.length?r.actions[t*r.n_agents+a]:null;if(!l)return this.#l([],"It is gone.");let d=ie(s,i,o[i]);if(typeof d=="string")return this.#l([],
`The script "${d}" plays for it${c===null?"":`; it goes ${gt[c]}`}.`);let{probabilities:m}=n.answer(d,a),p=Array.from(m,(g,h)=>ks(gt[h],g,h===c)),f=d.sampled?"I\
ts action is drawn from these probabilities.":"It takes the most probable action.";this.#l(p,c===null?"The episode is over.":f)}#l(t,r){this.#r.replaceChildren(
...t),this.#a.textContent=r}};function ks(e,t,r){let n=u("span",{class:"filled"});return n.style.width=`${100*t}%`,u("div",{class:r?"action taken":"action"},u("\
span",{},e),u("span",{class:"track"},n),u("span",{class:"numbers"},t.toFixed(2)))}var Os=(e,t)=>Object.keys(e).every(r=>e[r]===t[r]);function Gr(e,t){return Object.keys(t).find(r=>Os(t[r],e))??null}var ye="_",si=2n**64n-1n;var yt={fov:11,maxSteps:500,rewards:"paper"},Ps=["rules","others","rewards","size","diagonal","fov","limit","seed","ended","walls","pursuers","evaders","played",
"next"];function Yr(e,t){let r=i=>i.map(l=>Ls(l,t)).join(""),n=i=>`${Math.floor(i/e.cols)}.${i%e.cols}`,s=Ns(e.rewards,t),o=[e.seed,e.episode,e.steps].join("."),a={rules:Vr(
e.rules,t),others:e.others?Vr(e.others,t):"",rewards:s===yt.rewards?"":s,size:`${e.rows}x${e.cols}`,diagonal:e.diagonal?"1":"",fov:e.fov===yt.fov?"":String(e.fov),
limit:e.maxSteps===yt.maxSteps?"":String(e.maxSteps),seed:o==="0.0.0"?"":o,ended:e.ended?"1":"",walls:e.walls.map(n).join(ye),pursuers:e.pursuers.map(zr).join(ye),
evaders:e.evaders.map(zr).join(ye),played:e.played.map(r).join(ye),next:e.next.every(i=>i===0)?"":r(e.next)};return Ps.filter(i=>a[i]).map(i=>`${i}=${a[i]}`).join(
"&")}function zr({cell:e,gone:t,captured:r,everCaptured:n}){let s=r?"c":n?"e":"";return`${e[0]}.${e[1]}${s}${t?"x":""}`}function Vr(e,t){let r=t.fields.map(({name:n})=>String(
e[n]).toLowerCase());return Gr(e,t.variants)??r.join(".")}function Ns(e,t){let r=JSON.stringify(e);return Object.keys(t.rewards).find(s=>JSON.stringify(t.rewards[s])===
r)??Object.values(e).map(s=>String(s)).join(ye)}function Ls(e,t){if(typeof e=="number")return String(e);let r=t.scripts.findIndex(({name:n})=>n===e);return String.
fromCharCode(97+r)}var Is="/* the engine */";function Xr(e,t){return u("button",{type:"button",class:"to-playground",title:"Open this step in the playground (G): the same agents a\
nd actions under any rules",onclick:()=>bt(e(),t)},"What if? Playground")}function bt(e,t){let n=e!==null&&e.match.n_agents<=100&&Math.max(e.match.config.rows,e.
match.config.cols)<=64?Yr(Us(e.match,e.step),t):"",s=new TextDecoder().decode(at("playground")).replace(Is,()=>Ce("script-engine"));window.open(`${URL.createObjectURL(
new Blob([s],{type:"text/html"}))}#${n}`)}function Us(e,t){let{config:r,n_agents:n}=e,s=Math.max(0,t-1),o=i=>{let l=s*n+i,c=s*r.n_evaders+i-r.n_pursuers,d=m=>i>=
r.n_pursuers&&!!m[c];return{cell:[e.last_positions[2*l],e.last_positions[2*l+1]],gone:!e.alive[l],captured:d(e.captured),everCaptured:d(e.ever_captured)}},a=Array.
from({length:n},(i,l)=>o(l));return{rules:r.rules,others:null,rewards:r.rewards,rows:r.rows,cols:r.cols,diagonal:r.diagonal,fov:r.fov,maxSteps:r.max_steps,seed:e.
seed,episode:BigInt(e.episode),steps:s,ended:s===e.length,walls:Array.from(e.map.keys()).filter(i=>e.map[i]),pursuers:a.slice(0,r.n_pursuers),evaders:a.slice(r.
n_pursuers),played:[],next:Array.from(e.actions.subarray(s*n,(s+1)*n))}}function Jr(e,t,r){if(r===0)return[{kind:"start",text:Ds(e),agents:[]}];let[n,s]=[t.moments[r-1],t.moments[r]],o=d=>ge(d,e.config.n_pursuers),a=Oe(t,n,s),i=e.conflicts(
r),l=new Set(i.flatMap(d=>d.doomed)),c=a.map(d=>({kind:"capture",text:`${o(d)} is captured`,agents:[d]}));for(let d of $e(n,s))!a.includes(d)&&!l.has(d)&&c.push(
{kind:"end",text:`${o(d)} disappears`,agents:[d]});return c.push(...i.map(({kind:d,text:m,agents:p})=>({kind:d,text:m,agents:p}))),r===e.length&&c.unshift({kind:"\
end",text:Hs(e),agents:[]}),c}function Ds({config:e}){return`${e.n_pursuers} pursuers and ${e.n_evaders} evaders on ${e.rows} x ${e.cols} cells, at most ${e.max_steps}\
 steps`}function Hs(e){let t=Math.round(e.statistics.capture_rate*e.config.n_evaders);return`The episode ends after ${e.length} steps with ${t} of ${e.config.n_evaders}\
 evaders captured`}var Bs=60,Fe=class{element;player=new q(0,{speed:8,still:Q()});inspector;#e;#n;#o;#a;#r=u("h2",{class:"match-title"});#t=u("p",{class:"tally numbers"});#s=u("ol",
{class:"words","aria-live":"off","aria-label":"What happened in this step"});#c=u("p",{class:"problem",role:"alert"});#u=null;#i=null;#d=null;#l=0;#h=!1;#m=0;constructor(t,r,n){
[this.#n,this.#o]=[t,r];let s=u("canvas",{"aria-label":"The match"});this.#e=new Z(s,{numbers:!1}),this.#a=new He(r,this.player),this.inspector=new Be(o=>this.#x(
o)),s.addEventListener("click",o=>this.inspector.choose(this.#e.agentAt(o.clientX,o.clientY))),this.element=u("section",{class:"card match-card","aria-label":"M\
atch",id:"match"},u("div",{class:"match"},u("header",{class:"match-head"},this.#r,this.#t),this.#c,u("div",{class:"stage"},s),u("div",{class:"aside"},this.#s,Xr(
()=>this.shown,n),this.inspector.element),Ue(this.player),this.#a.element)),this.player.addEventListener("frame",()=>this.#d&&this.#e.show(this.#d,this.player.time)),
this.player.addEventListener("step",()=>this.#v()),r.on("match",()=>this.#b()),this.#g(),this.#w(0,0)}get#p(){return this.#n[this.#o.selected.run]}get match(){return this.#i}get shown(){
return this.#i&&{match:this.#i,step:this.player.step}}start(t){this.#u=t,this.#y()}playSoon(){this.#h=!0,this.#l||this.#f()}goTo(t){this.#m=t,!this.#l&&this.#i&&
this.#y()}#f(){!this.#h||!this.#i||(this.#h=!1,this.player.jump(0),Q()||this.player.play())}#b(){this.#g(),clearTimeout(this.#l),this.#l=setTimeout(()=>this.#y(),
Bs)}#y(){clearTimeout(this.#l),this.#l=0,this.player.pause(),this.#g();let{selected:t}=this.#o,r=["pursuer","evader"].find(n=>!ae(this.#p,n,t[n]));this.#c.textContent=
r?`The page holds no genome of ${r}s ${t[r]}: it would be too large. Choose a generation of ${this.#p.teams[r].kept.join(", ")}.`:"",!(r||!this.#u)&&(this.#i=I(
this.#u,this.#p,t),this.#d=Ie(this.#i),this.#a.show(this.#u,this.#p,this.#i),this.inspector.show(this.#u,this.#p,this.#i,t),this.player.length=this.#i.length,this.
player.jump(this.#m),this.#m=0,this.#v(),this.element.dataset.played=`${t.run} ${t.pursuer} ${t.evader} ${t.episode} ${t.seed??""}`,this.#f())}#g(){let{pursuer:t,
evader:r,episode:n,seed:s}=this.#o.selected,{teams:o,payoff:a}=this.#p,i=(c,d)=>o[c].script??`${c}s ${d}`,l=s===null?n<a.episodes?`episode ${n+1} of ${a.episodes}`:
`episode ${n+1}, not part of the cell`:`seed ${s}`;this.#r.replaceChildren(u("span",{class:"pursuer"},i("pursuer",t))," against ",u("span",{class:"evader"},i("e\
vader",r)),u("span",{class:"muted small"},l))}#v(){let t=this.#i;if(!t||!this.#d)return;let r=this.player.step,n=this.#d.moments[r];this.#w(Array.from(n.everCaptured).
filter(Boolean).length,r),this.#s.replaceChildren(...Jr(t,this.#d,r).map(s=>u("li",{class:s.kind,"data-agents":s.agents.join(" ")},s.text))),this.inspector.at(r),
this.#S()}#w(t,r){this.#t.replaceChildren(u("strong",{},t),` of ${this.#p.world.n_evaders} captured`,u("span",{class:"muted"},` · step ${r}`))}#x(t){this.#e.look=
{selected:t,viewers:t===null?[]:[t]},this.#S()}#S(){let t=this.inspector.agent;for(let r of this.#s.children){let n=r.dataset.agents?.split(" ")??[];r.classList.
toggle("about",t!==null&&n.includes(String(t)))}}};var T={left:52,bottom:46,top:76,right:84},$=10,Fs=160,be=T.right-$-14,W=T.top-$-14,We=class{element;#e;#n;#o=u("canvas",{"aria-hidden":"true"});#a=y("svg",{"ari\
a-hidden":"true"});#r=y("g");#t;#s=u("h2");#c=u("strong",{class:"rate numbers"});#u=u("span",{class:"small muted"});#i=u("p",{class:"small muted numbers"});#d=null;constructor(t,r){
[this.#n,this.#e]=[t,r],this.#t=u("div",{class:"matrix",id:"matrix",tabindex:0,role:"application","aria-label":"Payoff matrix. Arrow keys choose a match, Enter \
plays it."},this.#o,this.#a);let n=u("header",{class:"readout","aria-live":"polite"},u("div",{},this.#s,this.#i),u("div",{class:"of-cell"},this.#c,this.#u));this.
element=u("section",{class:"card matrix-card","aria-label":"Payoff matrix"},n,this.#t,Ws()),this.#b(),new ResizeObserver(()=>this.#h()).observe(this.#t),this.#t.
addEventListener("pointermove",s=>this.#v(s)),this.#t.addEventListener("pointerleave",()=>r.point({})),this.#t.addEventListener("click",s=>this.#w(s)),this.#t.addEventListener(
"mousedown",s=>s.preventDefault()),this.#t.addEventListener("keydown",s=>this.#x(s)),r.on("run",()=>this.#h()),r.on("match",()=>this.#f()),r.on("hover",()=>this.#f())}get#l(){
return this.#n[this.#e.selected.run]}#h(){let[t,r]=this.#l.payoff.shape,{clientWidth:n,clientHeight:s}=this.#t;if(n<50)return;let a=Math.max(Fs,Math.min(n-T.left-
T.right,s-T.top-T.bottom))/Math.max(t,r),i=Math.max(T.left,(n-r*a-T.right+T.left)/2),l=T.top+Math.max(0,(s-T.top-T.bottom-t*a)/2),c={width:n,height:s,left:i,top:l,
cell:a,rows:t,columns:r};this.#d=c,Te(this.#o,this.#l.payoff,{left:i,top:l,width:r*a,height:t*a}),this.#a.setAttribute("viewBox",`0 0 ${n} ${s}`),this.#a.replaceChildren(
js(c),Gs(c),...this.#p(c),this.#r),this.#f()}#m(t){let r=this.#l.findings?.generalization;if(!r)return[];let{selected:n,hover:s}=this.#e,[o,a]=[s.pursuer??n.pursuer,
s.evader??n.evader],[i,l]=Qr(t,r.pursuers.mean[o]??0,o),[c,d]=en(t,r.evaders.mean[a]??0,a);return[y("circle",{class:"dot of-pursuers",cx:i,cy:l,r:5}),y("circle",
{class:"dot of-evaders",cx:c,cy:d,r:5})]}#p(t){let r=this.#l.findings?.generalization;if(!r)return[];let{left:n,top:s,cell:o,rows:a,columns:i}=t,[l,c]=[n+i*o+$,
s-$],d={class:"side"};return[y("rect",{...d,x:l,y:s,width:be,height:a*o}),y("rect",{...d,x:n,y:c-W,width:i*o,height:W}),...tn(r.pursuers,(m,p)=>Qr(t,m,p),"of-pu\
rsuers"),...tn(r.evaders,(m,p)=>en(t,m,p),"of-evaders"),y("text",{class:"tick",x:l,y:s+a*o+16,"text-anchor":"start"},"0"),y("text",{class:"tick",x:l+be,y:s+a*o+
16,"text-anchor":"end"},"1"),y("text",{class:"tick",x:n-6,y:c-4,"text-anchor":"end"},"0"),y("text",{class:"tick",x:n-6,y:c-W+8,"text-anchor":"end"},"1"),y("text",
{class:"label of-pursuers",x:l+be,y:s+a*o+34,"text-anchor":"end"},"captures"),y("text",{class:"label of-evaders",x:n+i*o+$,y:c-W+10,"text-anchor":"start"},"esca\
pes")]}#f(){let t=this.#d;if(!t)return;let{selected:r,hover:n}=this.#e,{left:s,top:o,cell:a,rows:i,columns:l}=t,c=g=>o+(i-1-g)*a,d=[],m=(g,h)=>y("rect",{class:h,
x:s,y:c(g),width:l*a+$+be,height:a}),p=(g,h)=>y("rect",{class:h,x:s+g*a,y:o-$-W,width:a,height:$+W+i*a});if(d.push(m(r.pursuer,"strip pursuer"),p(r.evader,"stri\
p evader")),n.pursuer!==null&&n.pursuer<i&&d.push(m(n.pursuer,"strip hover")),n.evader!==null&&n.evader<l&&d.push(p(n.evader,"strip hover")),n.lag!==null)for(let g=0;g<
l;g++){let h=g+n.lag;h>=0&&h<i&&d.push(y("rect",{class:"lagged",x:s+g*a,y:c(h),width:a,height:a}))}d.push(...this.#m(t));let f={x:s+r.evader*a,y:c(r.pursuer),width:a,
height:a};d.push(y("rect",{class:"chosen under",...f}),y("rect",{class:"chosen",...f})),this.#r.replaceChildren(...d),this.#b()}#b(){let{selected:t,hover:r}=this.#e,
n=r.pursuer??t.pursuer,s=r.evader??t.evader,o=oe(this.#l,n,s);this.#s.replaceChildren(u("span",{class:"pursuer"},`Pursuers ${n}`)," against ",u("span",{class:"e\
vader"},`evaders ${s}`)),this.#c.textContent=o?A(o.rate,3):"-",this.#u.textContent=o?`capture rate, mean of ${o.rates.length} episodes`:"the evaluation played n\
o episodes",this.#i.textContent=this.#y(n,s)}#y(t,r){let n=this.#l.findings?.generalization;if(!n)return"";let s=(o,a)=>De(o.mean[a]??0,o.low?.[a]??null,o.high?.[a]??
null);return`Against all: captures ${s(n.pursuers,t)}, escapes ${s(n.evaders,r)}`}#g(t){let r=this.#d;if(!r)return null;let n=this.#t.getBoundingClientRect(),s=Math.
floor((t.clientX-n.left-r.left)/r.cell),o=r.rows-1-Math.floor((t.clientY-n.top-r.top)/r.cell),[a,i]=[o>=0&&o<r.rows,s>=0&&s<r.columns];return a||i?{g:a?o:-1,h:i?
s:-1,inside:a&&i}:null}#v(t){let r=this.#g(t);this.#e.point(r?{pursuer:r.g<0?null:r.g,evader:r.h<0?null:r.h}:{})}#w(t){let r=this.#g(t);r&&(this.#e.select({...r.
g<0?{}:{pursuer:r.g},...r.h<0?{}:{evader:r.h}}),r.inside&&this.#t.dispatchEvent(new CustomEvent("play",{bubbles:!0})))}#x(t){let n={ArrowUp:[1,0],ArrowDown:[-1,
0],ArrowRight:[0,1],ArrowLeft:[0,-1]}[t.key];if(t.key==="Enter")this.#t.dispatchEvent(new CustomEvent("play",{bubbles:!0}));else if(n){let s=t.shiftKey?5:1,[o,a]=this.#l.
payoff.shape,{pursuer:i,evader:l}=this.#e.selected;this.#e.select({pursuer:Zr(i+s*n[0],o),evader:Zr(l+s*n[1],a)})}else return;t.preventDefault(),t.stopPropagation()}};
function Ws(){let e=u("span",{class:"gradient"});return e.style.backgroundImage=er(),u("p",{class:"scale-of-rates small muted"},"0 all escape",e,"1 all caught")}
var Zr=(e,t)=>Math.min(t-1,Math.max(0,e));function js({left:e,top:t,cell:r,rows:n,columns:s}){let o=y("g",{class:"axes"}),a=t+n*r,i=l=>pe(0,l-1,Math.min(l,l*r/44),
!0);for(let l of i(s))o.append(y("text",{class:"tick",x:e+(l+.5)*r,y:a+16,"text-anchor":"middle"},l));for(let l of i(n))o.append(y("text",{class:"tick",x:e-7,y:a-
(l+.5)*r,"text-anchor":"end","dominant-baseline":"middle"},l));return o.append(y("text",{class:"label of-evaders",x:e+s*r/2,y:a+36,"text-anchor":"middle"},"evad\
er generation"),y("text",{class:"label of-pursuers",transform:`translate(${e-36} ${t+n*r/2}) rotate(-90)`,"text-anchor":"middle"},"pursuer generation")),o}function Gs({
left:e,top:t,cell:r,rows:n,columns:s}){let o=y("g",{class:"diagonal"}),a=Math.min(n,s);if(a<3)return o;let i=t+n*r;for(let l of["H","V"]){let c=`M${e} ${i}`;for(let d=1;d<=
a;d++){let[m,p]=[`H${e+d*r}`,`V${i-d*r}`];c+=l==="H"?m+p:p+m}o.append(y("path",{d:c,class:"under"}),y("path",{d:c}))}return o}var Qr=({left:e,top:t,cell:r,rows:n,
columns:s},o,a)=>[e+s*r+$+o*be,t+(n-a-.5)*r],en=({left:e,top:t,cell:r},n,s)=>[e+(s+.5)*r,t-$-n*W];function tn(e,t,r){let n=o=>o.map((a,i)=>t(a??0,i).map(l=>l.toFixed(
1)).join(" ")),s=[];return e.low&&e.high&&s.push(y("path",{class:`band ${r}`,d:`M${[...n(e.high),...n(e.low).reverse()].join("L")}Z`})),s.push(y("path",{class:`\
line ${r}`,d:`M${n(e.mean).join("L")}`})),s}function rn(e,t,r){let{findings:n}=e;if(!n)return null;let s=u("dialog",{class:"four","aria-label":"Four matches"}),o=i=>{let l=r();l&&Vs(s,e,i,t,l)},a=n.checkerboards.
map(i=>zs(e,i,o));return{element:E("Checkerboards","Two generations of each team: each pursuers are better against one of the evaders. Click one: its four match\
es side by side.",a.length?u("div",{class:"boards"},...a):u("p",{},`No four cells differ by more than ${n.margin} in this way.`),a.length?u("p",{class:"small mu\
ted"},"The strongest of all pairs, so noise makes them look stronger than they are. The diagnosis says whether there are more than noise makes."):null,s)}}var nn=({
pursuers:[e,t],evaders:[r,n]})=>[[e,r],[e,n],[t,r],[t,n]];function zs(e,t,r){let[n,s]=t.pursuers,[o,a]=t.evaders,i=nn(t).map(([l,c])=>{let d=e.payoff.capture_rate[l][c],
m=u("span",{class:d>.55?"cell light":"cell"},A(d));return m.style.backgroundColor=Qt(d),m});return u("button",{type:"button",class:"miniature numbers",onclick:()=>r(
t),"aria-label":`Pursuers ${n} and ${s}, evaders ${o} and ${a}: four matches`},u("span",{}),u("span",{class:"evader"},o),u("span",{class:"evader"},a),u("span",{
class:"pursuer"},n),i[0],i[1],u("span",{class:"pursuer"},s),i[2],i[3])}function Vs(e,t,r,n,s){let o=nn(r).filter(([p,f])=>ae(t,"pursuer",p)&&ae(t,"evader",f)),a=o.
map(([p,f])=>I(s,t,{run:n.selected.run,pursuer:p,evader:f,episode:0,seed:null})),i=new q(Math.max(0,...a.map(p=>p.length)),{speed:16,still:Q()}),l=a.map((p,f)=>{
let[g,h]=o[f],b=u("canvas",{"aria-label":`Pursuers ${g} against evaders ${h}`}),w=u("span",{class:"numbers"}),S=()=>{e.close(),n.select({pursuer:g,evader:h})};return{
element:u("figure",{},u("figcaption",{},u("span",{},u("span",{class:"pursuer"},g)," against ",u("span",{class:"evader"},h),u("span",{class:"muted small"},` cell\
 ${A(t.payoff.capture_rate[g][h])}`)),w,u("button",{type:"button",class:"small",title:"Show this match alone",onclick:S},"open")),b),match:p,recording:Ie(p),board:new Z(
b,{numbers:!1}),tally:w}}),c=()=>l.forEach(p=>p.board.show(p.recording,i.time)),d=()=>l.forEach(({recording:p,match:f,tally:g})=>{let h=p.moments[Math.min(i.step,
f.length)];g.textContent=`${Array.from(h.everCaptured).filter(Boolean).length} of ${f.config.n_evaders}`});i.addEventListener("frame",c),i.addEventListener("ste\
p",d),e.replaceChildren(u("header",{},u("h2",{},"Four matches of a checkerboard"),u("button",{type:"button",onclick:()=>e.close()},"Close")),u("div",{class:"gri\
d-of-four"},...l.map(p=>p.element)),Ue(i));let m=p=>{!(p.target instanceof HTMLSelectElement||p.target instanceof HTMLButtonElement&&p.key===" ")&&!p.defaultPrevented&&
Y(i,p)&&p.preventDefault()};e.addEventListener("keydown",m),e.addEventListener("close",()=>{e.removeEventListener("keydown",m),i.pause(),l.forEach(p=>p.board.close()),
e.replaceChildren()},{once:!0}),e.showModal(),c(),d(),Q()||i.play()}var je={pursuer:"evader",evader:"pursuer"};function sn(e,t){let r=e.findings?.ciao;if(!r)return null;let n=["pursuer","evader"].map(s=>{let{fading:o,stripes:a,period:i}=r[`${s}\
s`],l=`fading ${A(o)}, stripes ${A(a)}${i===null?"":` every ${i} generations`}`;return Ks(e,s,l,t)});return{element:E("CIAO","Current individuals against ancest\
ral opponents, by the team's own score. Stripes that come back: cycling. Darker away from the diagonal: forgetting.",u("div",{class:"triangles"},...n.map(s=>s.element))),
update:()=>n.forEach(s=>s.update())}}function Ks(e,t,r,n){let s=t==="pursuer"?0:1,[o,a]=[e.payoff.shape[s],e.payoff.shape[1-s]],i=(v,x)=>t==="pursuer"?e.payoff.
capture_rate[v][x]:1-e.payoff.capture_rate[x][v],l=u("canvas",{width:a,height:o,role:"img","aria-label":`CIAO of the ${t}s: ${r}`}),c=l.getContext("2d"),d=c?.createImageData(
a,o);for(let v=0;d&&v<o;v++)for(let x=0;x<=Math.min(v,a-1);x++)d.data.set([...ue(i(v,x)),255],4*((o-1-v)*a+x));d&&c?.putImageData(d,0,0);let m=y("rect",{class:"\
chosen",width:1,height:1}),p=y("rect",{class:"chosen under",width:1,height:1}),f=y("svg",{viewBox:`0 0 ${a} ${o}`,preserveAspectRatio:"none","aria-hidden":"true"},
p,m),g=u("div",{class:"triangle"},l,f);g.style.aspectRatio=`${a} / ${o}`;let h=v=>{let x=g.getBoundingClientRect(),C=Math.floor((v.clientX-x.left)/x.width*a),U=o-
1-Math.floor((v.clientY-x.top)/x.height*o);return C>=0&&U<o&&C<=U?[U,C]:null},b=v=>({[t]:v[0],[je[t]]:v[1]});g.addEventListener("pointermove",v=>n.point(h(v)?b(
h(v)):{})),g.addEventListener("pointerleave",()=>n.point({})),g.addEventListener("click",v=>h(v)&&n.select(b(h(v))));let w=()=>{let v=n.hover[t]??n.selected[t],
x=n.hover[je[t]]??n.selected[je[t]];for(let C of[m,p])C.setAttribute("x",String(x)),C.setAttribute("y",String(o-1-v)),C.style.display=x<=v?"":"none"};return{element:u(
"figure",{},u("figcaption",{class:"small"},u("span",{class:t},`${t}s`)),g,u("p",{class:"small muted"},`horizontal: ${je[t]} generation; vertical: ${t} generatio\
n`),u("p",{class:"small numbers"},r)),update:w}}var Ge={left:46,right:12,top:10,bottom:42},on={x:56,y:34};function ze(e,t,r,n){let[s,o]=[Ge.left,Ge.top],a=Math.max(s+40,e-Ge.right),i=Math.max(o+40,t-Ge.bottom),
l=(h,b,w)=>S=>b+(S-h.low)/(h.high-h.low||1)*(w-b),[c,d]=[l(r,s,a),l(n,i,o)],m=y("g"),p=y("svg",{width:e,height:t,viewBox:`0 0 ${e} ${t}`,class:"plot"}),f=y("g",
{class:"axes"});for(let h of pe(n.low,n.high,(i-o)/on.y,n.whole))f.append(y("line",{x1:s,x2:a,y1:d(h),y2:d(h),class:"grid"}),y("text",{x:s-8,y:d(h),"text-anchor":"\
end","dominant-baseline":"middle"},an(h)));for(let h of pe(r.low,r.high,(a-s)/on.x,r.whole))f.append(y("text",{x:c(h),y:i+16,"text-anchor":"middle"},an(h)));return f.
append(y("line",{x1:s,x2:a,y1:i,y2:i,class:"axis"}),y("text",{x:(s+a)/2,y:t-6,"text-anchor":"middle",class:"label"},r.label),y("text",{transform:`translate(12 ${(o+
i)/2}) rotate(-90)`,"text-anchor":"middle",class:"label"},n.label)),p.append(f,m),{root:p,marks:m,left:s,right:a,top:o,bottom:i,x:c,y:d,at:h=>{let b=h-p.getBoundingClientRect().
left;return r.low+(b-s)/(a-s)*(r.high-r.low)}}}var an=e=>String(Number(e.toPrecision(6))).replace("-","−");function ve(e,t,r,n){let s="",o="M";r.forEach((i,l)=>{
i===null?o="M":(s+=`${o}${e.x(t[l]).toFixed(1)} ${e.y(i).toFixed(1)}`,o="L")});let a=y("path",{d:s,class:`line ${n}`});return e.root.insertBefore(a,e.marks),a}function we(e,t,r,n=null){let s=e.x(t);e.marks.append(y("line",{x1:s,x2:s,y1:e.top,y2:e.bottom,class:`mark ${r}`})),n!==null&&e.marks.append(y("circle",{cx:s,cy:e.
y(n),r:5,class:`dot ${r}`}))}function vt(...e){return u("p",{class:"legend small"},...e.map(([t,r])=>u("span",{class:`key ${r}`},t)))}function Ve(e,t,r={}){let n=u(
"div",{class:"chart",role:"img","aria-label":e}),s=null,o=()=>{s?.marks.replaceChildren(),s&&r.marks?.(s)},a=()=>{let{clientWidth:i,clientHeight:l}=n;i<50||l<50||
(s=t(i,l),n.replaceChildren(s.root),o())};return n.addEventListener("pointermove",i=>r.point?.(s?.at(i.clientX)??null)),n.addEventListener("pointerleave",()=>r.
point?.(null)),r.choose&&(n.classList.add("chooses"),n.addEventListener("click",i=>s&&r.choose?.(s.at(i.clientX),s,i))),new ResizeObserver(a).observe(n),{element:n,
redraw:a,remark:o}}var wt=["of-pursuers","of-evaders","of-both"],qs=2500,ln={low:0,high:1,label:"capture rate"};function cn(e,t){let{training:r}=e,{capture_rate:n,generation:s,learner:o,
epochs:a}=r,i=n.map((g,h)=>(h+1)*a),l=Ys(n,r.window),c=i.at(-1)??1,d=i.length>qs?"dense":"",m=(g,h)=>{let b=s.flatMap((w,S)=>w===g&&(o[S]===h||o[S]===2)?[S]:[]);
return b.length?[i[b[0]],i[b.at(-1)]]:null},p=Ve(`Capture rate in ${c} epochs of training`,(g,h)=>{let b=ze(g,h,{low:0,high:c,label:"epoch",whole:!0},ln);for(let[
w,S]of[["raw",n],[d,l]])for(let[v,x]of wt.entries()){let C=S.map((U,St)=>o[St]===v||o[St+1]===v?U:null);C.some(U=>U!==null)&&ve(b,i,C,`${x} ${w}`)}return b},{marks:g=>{
let{pursuer:h,evader:b}=t.selected;for(let[w,S]of[[0,h],[1,b]]){let v=m(t.hover[w?"evader":"pursuer"]??S,w);v&&we(g,(v[0]+v[1])/2,wt[w])}},choose:g=>{let h=Math.
min(i.length-1,Math.max(0,Math.round(g/a)-1)),b=s[h];o[h]!==1&&t.select({pursuer:Math.min(b,e.payoff.shape[0]-1)}),o[h]!==0&&t.select({evader:Math.min(b,e.payoff.
shape[1]-1)})}}),f=[...new Set(o)].sort().map(g=>[["pursuers learn","evaders learn","both teams learn"][g],wt[g]]);return{element:E("Training",`${Ur(r.matches)}\
 training matches. Lines: the generations that are selected.`,vt(...f),p.element),update:p.remark}}function un(e,t){let r=e.findings?.lags;if(!r)return null;let[
n,s]=[r.lags[0],r.lags.at(-1)],o=Math.min(5,(Math.max(...r.cells)+1)/2),a=r.means.map((l,c)=>r.cells[c]>=o?l:null),i=Ve("Lag profile",(l,c)=>{let d=ze(l,c,{low:n,
high:s,label:"lag: pursuer minus evader generation",whole:!0},ln);return ve(d,r.lags,r.means,"raw ink"),ve(d,r.lags,a,"ink"),d},{marks:l=>{let{pursuer:c,evader:d}=t.
selected;we(l,0,"zero");let m=t.hover.lag??c-d;we(l,m,"ink",r.means[m-n])},point:l=>{let c=l===null?null:Math.round(l);t.point({lag:c!==null&&c>=n&&c<=s?c:null})}});
return{element:E("Lag profile","Left: evaders are later. Right: pursuers are later. It rises if both teams keep what they learn. Faint: fewer than 5 cells.",i.element),
update:i.remark}}function dn(e,t){let r=e.findings?.ratings;if(!r)return null;let n={pursuer:r.pursuers,evader:r.evaders},s=[...r.pursuers,...r.evaders].map(d=>d??
0),[o,a]=[Math.min(...s),Math.max(...s)],i=.06*(a-o||1),l=Math.max(...e.payoff.shape)-1,c=Ve("Elo ratings by generation",(d,m)=>{let p=ze(d,m,{low:0,high:l,label:"\
generation",whole:!0},{low:o-i,high:a+i,label:"Elo points"});for(let f of["pursuer","evader"])ve(p,n[f].map((g,h)=>h),n[f],`of-${f}s`);return p},{marks:d=>{for(let m of[
"pursuer","evader"]){let p=t.hover[m]??t.selected[m];we(d,p,`of-${m}s`,n[m][p]??null)}},choose:(d,m,p)=>{let f=Math.round(d),g=p.clientY-m.root.getBoundingClientRect().
top,h=w=>Math.abs(m.y(n[w][f]??1/0)-g),b=h("pursuer")<=h("evader")?"pursuer":"evader";f>=0&&f<n[b].length&&t.select({[b]:f})}});return{element:E("Ratings",`One \
number for each generation, which cycles do not fit. The game itself: ${A(r.offset,0)} points for the pursuers.`,vt(["pursuers","of-pursuers"],["evaders","of-ev\
aders"]),c.element),update:c.remark}}function Ys(e,t){let r=[0];for(let n of e)r.push(r.at(-1)+n);return e.map((n,s)=>{let[o,a]=[Math.max(0,s-Math.floor((t-1)/2)),
Math.min(e.length,s+Math.floor(t/2)+1)];return(r[a]-r[o])/(a-o)})}var Xs={present:"●",absent:"○","cannot tell":"?"};function mn(e){let{findings:t}=e;if(!t)return null;let[,...r]=t.table,n=new Map(t.reasons.map(a=>{let[i,,l]=Js(
a);return[i,l]})),s=r.map(([a,i,l,c])=>{let d=c===t.window?n.get(a):void 0;return u("li",{class:`finding ${i.replace(" ","-")}`},u("span",{class:"sign","aria-hi\
dden":"true"},Xs[i]??""),u("div",{},u("p",{},u("strong",{},a),` ${i}`,u("span",{class:"muted"},` · ${c}`)),d?u("p",{class:"small"},`${d}.`):null,u("p",{class:"\
small muted numbers"},l)))}),o=E("What happened","Each condition is present, absent, or its 95 % interval cannot tell. The intervals are about this run.",u("p",
{class:"headline"},t.headline),u("ul",{class:"findings"},...s),e.limits?u("p",{class:"small"},e.limits):null,u("details",{class:"small"},u("summary",{},"Headlin\
e numbers in words"),...t.description.map(a=>u("p",{},a)),Qs(t)));return o.classList.add("diagnosis"),{element:o}}function Js(e){let[t="",r=""]=e.split(/: (.*)/s),
[n="",s=""]=r.split(/, because (.*)/s);return[t.toLowerCase(),n,Zs(s.replace(/\.$/,""))]}var Zs=e=>e.charAt(0).toUpperCase()+e.slice(1);function Qs({noise:e}){return e.
transitive_share_noise===null?null:u("p",{},`Last half: transitive share ${A(e.transitive_share)} (an order of strength with the same noise rarely falls below ${A(
e.transitive_share_noise)}), checkerboards ${ft(e.checkerboard_share)} (it rarely exceeds ${ft(e.checkerboard_share_noise)}).`)}function pn(e){let t=[e.held_out?.pursuers,e.held_out?.evaders].filter(r=>r!=null);return t.length?{element:E("Held-out opponents",`The last generations against\
 opponents that no run has met; 95 % intervals over ${t[0].episodes} episodes.`,...t.map(eo))}:null}function eo(e){let t=n=>n.at(-1),r=[["mean",t(e.mean)],...Object.
entries(e.against).map(([n,s])=>[n,t(s)])];return u("table",{class:"scores numbers"},u("caption",{},u("span",{class:e.team},`${e.team}s`),` of generation ${e.generations.
at(-1)}, ${e.score}`),...r.map(([n,s],o)=>u("tr",{class:o?"":"mean"},u("th",{scope:"row"},n),u("td",{class:"range"},to(s,e.team)),u("td",{},De(s.value,s.low,s.high)))))}
function to({value:e,low:t,high:r},n){let s=u("span",{class:`between ${n}`});s.style.left=`${100*(t??e)}%`,s.style.width=`${100*((r??e)-(t??e))}%`;let o=u("span",
{class:`value ${n}`});return o.style.left=`${100*e}%`,u("span",{class:"scale","aria-hidden":"true"},s,o)}function fn(e){let t=e.settings.filter(s=>s.changed),r=e.settings.filter(s=>!s.changed),n=E("Settings",`${e.schedule}, seed ${e.seed}. Every setting is an optio\
n of matrixworld evolve.`,t.length?hn(t,"other than the default"):u("p",{class:"small"},"All settings are the defaults."),u("details",{class:"small"},u("summary",
{},`${r.length} settings with their defaults`),hn(r,"defaults")));return n.classList.add("settings"),{element:n}}function hn(e,t){return u("div",{class:"wide-ta\
ble"},u("table",{class:"small"},u("caption",{class:"heard"},`Settings: ${t}`),...e.map(({name:r,value:n,help:s})=>u("tr",{},u("th",{scope:"row"},`--${r.replaceAll(
"_","-")}`),u("td",{class:"numbers"},n),u("td",{class:"muted"},s)))))}function E(e,t,...r){return u("section",{class:"card panel","aria-label":e},u("header",{},u("h2",{},e),u("p",{class:"small muted"},t)),...r)}function gn(e,t,r){
let n=new Map,s=u("div",{class:"panels"}),o=[],a=()=>o.forEach(l=>l.update?.()),i=()=>{let l=e[t.selected.run];o=n.get(l)??ro(l,t,r),n.set(l,o),s.replaceChildren(
...o.map(c=>c.element)),a()};return t.on("run",i),t.on("match",a),t.on("hover",a),i(),s}function ro(e,t,r){return[mn(e),cn(e,t),rn(e,t,r),un(e,t),dn(e,t),sn(e,t),
pn(e),fn(e)].filter(s=>s!==null)}var yn={pursuer:null,evader:null,lag:null},Ke=class extends EventTarget{#e;#n=yn;constructor(t){super(),this.#e=t}get selected(){return this.#e}get hover(){return this.#n}select(t){
let r=this.#e,n=["run","pursuer","evader"].some(s=>s in t&&t[s]!==r[s]);this.#e={...r,...n?{episode:0,seed:null}:{},...t},this.#e.run!==r.run&&this.dispatchEvent(
new Event("run")),this.dispatchEvent(new Event("match"))}point(t){let r={...yn,...t};r.pursuer===this.#n.pursuer&&r.evader===this.#n.evader&&r.lag===this.#n.lag||
(this.#n=r,this.dispatchEvent(new Event("hover")))}on(t,r){this.addEventListener(t,r)}};var j=Zt(),{runs:R}=j,[no,so]=R[0].payoff.shape,oo=ot(location.hash,R,{run:0,pursuer:no-1,evader:so-1,episode:0,seed:null}),{step:ao,...io}=oo,L=new Ke(io),P=new Fe(
R,L,j.playground),bn=new We(R,L),xt=rr(),qe=null;function lo(){let[e]=R,t=`matrixworld ${j.version}`;return R.length>1||!e?t:e.race?`${e.schedule}, seed ${e.seed}\
 · ${t}`:`${e.learning.join(" and ")}s learn, seed ${e.seed} · ${t}`}document.getElementById("page").replaceWith(u("header",{class:"top"},u("h1",{},j.title),u(
"p",{class:"muted small about"},lo()),u("div",{class:"tools"},Yt(),u("button",{type:"button",title:"Keys (?)","aria-label":"Keys",onclick:()=>xt.showModal()},"?"))),
...j.note?[u("p",{class:"note small muted"},j.note)]:[],tr(R,L),u("main",{class:"stages"},bn.element,P.element),gn(R,L,()=>qe),xt);Object.assign(window,{matrixworldExplorer:{
get match(){return P.match},get step(){return P.player.step},play:e=>qe&&I(qe,R[L.selected.run],{...L.selected,episode:e}),get shape(){return R[L.selected.run].
payoff.shape}}});bn.element.addEventListener("play",()=>P.playSoon());P.goTo(ao);Xt(R,L,P);nr(R,L,P,xt,()=>bt(P.shown,j.playground));requestAnimationFrame(()=>setTimeout(
()=>{Kt().then(e=>{qe=e,P.start(e),document.body.dataset.ready="true"},e=>{P.element.prepend(u("p",{class:"problem",role:"alert"},`The engine does not start her\
e: ${String(e)}`)),document.body.dataset.ready="true"})}));})();
