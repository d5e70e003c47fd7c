/* built from web/ by "npm run build"; sources 6acc212787271a78475ae1ecadb2df620a19cbf77a624086a9e15291cc51883b */
"use strict";(()=>{var _t={SIMULTANEOUS:0,SWARM_TURNS:1,AGENT_TURNS:2},ee={DISAPPEAR:0,REACH:1,BOUNCE:2},Mt={OCCUPATION:0,SURROUND:1},At={FAULT:0,INVOLVED:1};var Et=["obstacle","teammate","adversary"],qe=["vertex","edge","chain"],Ct=["turn","kind","form","first","second","row","col","at_fault","held","doomed"],Ye=["p\
ursuer_{number}","evader_{number}"],Tt={obstacle:"{first} ran into the obstacle or border at {cell}",vertex:"{first} and {second} both headed for {cell}",edge:"\
{first} and {second} meant to swap, {first} to {cell}",chain:"{first} headed for {cell}, where {second} had to stay"},te={"both held":"both bounce","both doomed":"\
both disappear",held:"{agent} bounces",doomed:"{agent} disappears",none:"nobody is stopped"},Rt="{event}: {outcome}",Je={random:"any action, all equally likely",
still:"always stays",chaser:"moves to where the nearest adversary in view is nearest",fleer:"moves to where the nearest adversary in view is farthest","clumsy-c\
haser":"a chaser that takes any action in half of the steps","clumsy-fleer":"a fleer that takes any action in half of the steps",hunter:"a chaser of the nearest\
 adversary in view to which no teammate in view is nearer",surrounder:"a chaser of the nearest free cell beside an adversary in view without a teammate",dodger:"\
moves to where all adversaries in view together are farthest; each cell that holds some weighs 2**14 // (1 + moves)**2"},kt={free:".GS",blocked:"#@OTW"};var G=1+Ct.length;function re(t,e){return t.replace(/\{(\w+)\}/g,(r,n)=>String(e[n]))}function Ze(t,e){return t<e?re(Ye[0],{number:t}):re(Ye[1],{number:t-e})}function vn(t,e){
let[r,n,s,o,a,i,l,...c]=Array.from(t),d=a<0?[o]:[o,a],[m,p,f]=c.map(w=>d.filter((S,v)=>w>>v&1)),g=d.map(w=>Ze(w,e)),h=re(Tt[a<0?"obstacle":qe[s]],{first:g[0],second:g[g.
length-1],cell:`(${i}, ${l})`}),b=re(Rt,{event:h,outcome:wn(d.length,p,f,e)});return{kind:Et[n],form:qe[s],agents:d,cell:[i,l],at_fault:m,held:p,doomed:f,turn:r,
text:b}}function wn(t,e,r,n){if(t===2&&e.length===2)return te["both held"];if(t===2&&r.length===2)return te["both doomed"];let s=o=>a=>re(te[o],{agent:Ze(a,n)});
return[...e.map(s("held")),...r.map(s("doomed"))].join(", ")||te.none}function xe(t,e){let r=[];for(let n=0;n<t.length;n+=G)r.push(vn(t.subarray(n+1,n+G),e));return r}var D=class extends Error{name="EngineError"};function _(t,e,r){let n=typeof r=="string"?`'${r}'`:typeof r=="object"?JSON.stringify(r):String(r);return new D(`${t}\
: expected ${e}, got ${n}`)}var z=class{bytes;constructor(e){this.bytes=e}},$t=0,et=[Uint8Array,Uint8Array,Int32Array,BigInt64Array,BigUint64Array,Float32Array,Float64Array],Ot=4,Pt=4,xn=new TextEncoder,
Sn=new TextDecoder;function _n(t){for(let e=et.length-1;e>$t;--e)if(t instanceof et[e])return e;throw new TypeError("array: expected a typed array of the engine\
's numbers, got another")}function Qe(t){return new Uint8Array(t.buffer,t.byteOffset,t.byteLength)}function Mn(t){return xn.encode(`${t}\0`)}var tt=class{engine;addresses=[];constructor(e){
this.engine=e}copy(e){let r=this.engine._malloc(Math.max(e.length,1));if(r===0)throw new D("memory: expected room for the arguments, got none");return this.addresses.
push(r),this.engine.HEAPU8.set(e,r),r}text(e){return this.copy(Mn(e))}arrays(e){let r=Object.entries(e),n=r.flatMap(([o,a])=>{let i=a instanceof z,l=i?a.bytes:a;
return[this.text(o),i?$t:_n(l),l.length,this.copy(Qe(l))]}),s=this.copy(Qe(Int32Array.from(n)));return this.copy(Qe(Int32Array.of(r.length,s)))}free(){for(let e of this.
addresses)this.engine._free(e)}};function Nt(t,e){let r=t.HEAPU8;return Sn.decode(r.subarray(e,r.indexOf(0,e)))}function Se(t){let e=new Int32Array(t.HEAPU8.buffer),
r=t._last_outputs()/Ot,n=e[r+1]/Ot,s={};for(let o=n;o<n+e[r]*Pt;o+=Pt){let a=et[e[o+1]],i=e[o+2]*a.BYTES_PER_ELEMENT,l=e[o+3];s[Nt(t,e[o])]=new a(t.HEAPU8.slice(
l,l+i).buffer)}return s}function ne(t,e){let r=new tt(t);try{let n=e(r);if(n===0)throw new D(Nt(t,t._last_error()));return n}finally{r.free()}}var An=2**31-1,En=2n**64n-1n,Cn=34028234663852886e22;function N(t,e){if(typeof e!="number"||!Number.isInteger(e)||Math.abs(e)>An)throw _(t,"an integer",e);return Int32Array.
of(e)}function _e(t,e){if(typeof e!="boolean")throw _(t,"true or false",e);return new z(Uint8Array.of(Number(e)))}function H(t,e,r){let n=typeof e=="string"&&Object.
hasOwn(r,e)?r[e]:void 0;if(n===void 0)throw _(t,`one of ${Object.keys(r).join(", ")}`,e);return Int32Array.of(n)}function rt(t,e){if(typeof e!="number"||!(Math.
abs(e)<=Cn))throw _(t,"a finite number",e);return e}function V(t,e){let n=typeof e=="bigint"||typeof e=="number"&&Number.isSafeInteger(e)?BigInt(e):-1n;if(n<0n||
n>En)throw _(t,"an integer from 0 to 2^64 - 1",e);return BigUint64Array.of(n)}function Tn(t){return{"rules.interaction":H("interaction",t.interaction,_t),"rules\
.obstacle":H("obstacle",t.obstacle,ee),"rules.teammate":H("teammate",t.teammate,ee),"rules.evader":H("evader",t.evader,ee),"rules.pursuer":H("pursuer",t.pursuer,
ee),"rules.capture":H("capture",t.capture,Mt),"rules.captured_disappear":_e("captured_disappear",t.captured_disappear)}}function It(t,e){let r=typeof e=="number"?
[e,e,e]:e;if(!Array.isArray(r)||r.length!==3)throw _(t,"1 or 3 numbers",e);return Float32Array.from(r,n=>rt(t,n))}function Rn(t){let e=(r,n)=>Float32Array.of(rt(
r,t[r]),rt(n,t[n]));return{"rewards.capture":e("pursuer_capture","evader_capture"),"rewards.neighbor":e("pursuer_neighbor","evader_neighbor"),"rewards.step":e("\
pursuer_step","evader_step"),"rewards.pursuer_collide":It("pursuer_collide",t.pursuer_collide),"rewards.evader_collide":It("evader_collide",t.evader_collide),"r\
ewards.blame":H("blame",t.blame,At),"rewards.capture_repeats":_e("capture_repeats",t.capture_repeats)}}function Ut(t){if(t===void 0||typeof t=="number")return new Uint8Array(
0);if(t instanceof Uint8Array)return t;let{free:e,blocked:r}=kt;for(let[n,s]of t.entries()){if(s.length!==t[0]?.length)throw _(`map, row ${n}`,`${t[0]?.length} \
cells as in row 0`,s.length);let o=[...s].find(a=>!e.includes(a)&&!r.includes(a));if(o)throw _(`map, row ${n}`,`'${e}' (free) or '${r}' (obstacle)`,o)}return Uint8Array.
from([...t.join("")],n=>Number(r.includes(n)))}function Dt(t,e){if(!Array.isArray(t))return;let r=[t.length,t[0]?.length??0];if(!(r[0]===e.rows&&r[1]===e.cols))
throw _("obstacle map",`shape (${e.rows}, ${e.cols}), the rows and cols`,r)}function Me(t){Dt(t.obstacles,t);let e=typeof t.obstacles=="number"?t.obstacles:0;return{
...Tn(t.rules),...Rn(t.rewards),rows:N("rows",t.rows),cols:N("cols",t.cols),n_pursuers:N("n_pursuers",t.n_pursuers),n_evaders:N("n_evaders",t.n_evaders),fov:N("\
fov",t.fov),diagonal:_e("diagonal",t.diagonal),max_steps:N("max_steps",t.max_steps),density:Float64Array.of(e),map:Ut(t.obstacles)}}function Lt(t,e){return Int32Array.
from((e??[]).flat(),r=>N(t,r)[0])}function Ht(t,e){return Dt(t.obstacles,e),{seed:V("seed",t.seed??0n),episode:V("episode",t.episode??0),pursuers:Lt("pursuers",
t.pursuers),evaders:Lt("evaders",t.evaders),map:Ut(t.obstacles)}}function Ae(t){return{actions:Int32Array.from(t,e=>N("actions",e)[0])}}function K(t){if(typeof t==
"string"){if(!Object.hasOwn(Je,t))throw _("policy",`one of ${Object.keys(Je).join(", ")}`,t);return{script:new TextEncoder().encode(t)}}if(t.activation!=="relu"&&
t.activation!=="tanh")throw _("activation","'relu' or 'tanh'",t.activation);return{hidden:Int32Array.from(t.hidden,e=>N("hidden",e)[0]),activation:new TextEncoder().
encode(t.activation),sampled:_e("sampled",t.sampled),genome:t.genome}}var kn=["first_turn","terminated","truncated"];function Bt(t){let e={...t};for(let r of kn)
e[r]=new z(t[r]);return e}var Ee=class{config;seed;episode;n_agents;statistics;positions;last_positions;alive;captured;ever_captured;actions;rewards;involved;fault;map;conflict_table;first_conflict;constructor(e,r,n,s){
this.config=e,this.seed=r,this.episode=n,this.n_agents=e.n_pursuers+e.n_evaders,this.statistics=Ft(s,0),this.positions=s.positions,this.last_positions=s.last_positions,
this.alive=s.alive,this.captured=s.captured,this.ever_captured=s.ever_captured,this.actions=s.actions,this.rewards=s.rewards,this.involved=s.involved,this.fault=
s.fault,this.map=s.map,this.conflict_table=s.conflict_table,this.first_conflict=On(this.conflict_table,this.length)}get length(){return this.actions.length/this.
n_agents}conflicts(e){this.check(e);let[r,n]=[this.first_conflict[e],this.first_conflict[e+1]],s=this.conflict_table.subarray(r*G,n*G);return xe(s,this.config.n_pursuers)}seek(e,r){
this.check(r),(!(e.seed===this.seed&&e.episode===BigInt(this.episode))||e.turn!==0||e.steps>r)&&e.reset({seed:this.seed,episode:this.episode});for(let s=e.steps;s<
r;++s)e.step(this.actions.subarray(s*this.n_agents,(s+1)*this.n_agents))}check(e){if(!(Number.isInteger(e)&&e>=0&&e<=this.length))throw _("step",`0 to ${this.length}`,
e)}};function On(t,e){let r=new Int32Array(e+2);for(let n=0;n<t.length;n+=G)++r[t[n]+1];for(let n=1;n<r.length;++n)r[n]+=r[n-1];return r}function Ft(t,e){let r=t["\
statistics.length"].length,n=o=>{let a=t[`statistics.${o}`],i=a.length/r;return a.slice(e*i,(e+1)*i)},s=o=>Number(n(o)[0]);return{capture_rate:s("capture_rate"),
ever_capture_rate:s("ever_capture_rate"),captured_fraction:s("captured_fraction"),length:s("length"),return:n("return"),survivors:n("survivors"),overlap:n("over\
lap"),collisions:n("collisions"),faults:n("faults"),agent_steps:n("agent_steps")}}function Wt(t,e,r,n){let s=[Me(r.config),K(r.pursuers),K(r.evaders),n];return ne(
t,o=>{let[a,i,l,c]=s.map(d=>o.arrays(d));return t[e](a,i,l,c)}),Se(t)}function jt(t,e,r,n){let s={seed:V("seed",r),episode:V("episode",n)};return new Ee(e.config,
r,n,Wt(t,"_play_match",e,s))}function Gt(t,e,r,n){if(!Number.isInteger(n)||n<1)throw _("n_episodes","at least 1",n);let s={seed:V("seed",r),n_episodes:Int32Array.
of(n)},o=Wt(t,"_play_rollout",e,s);return Array.from({length:n},(a,i)=>Ft(o,i))}var zt=new FinalizationRegistry(([t,e])=>t._world_free(e)),se=class{config;n_agents;n_actions;engine;at;freed=!1;constructor(e,r){this.engine=e,this.config=r,this.
n_agents=r.n_pursuers+r.n_evaders,this.n_actions=r.diagonal?9:5,this.at=ne(e,n=>e._world_new(n.arrays(Me(r)))),zt.register(this,[e,this.at],this)}free(){this.freed||
(this.freed=!0,zt.unregister(this),this.engine._world_free(this.at))}reset(e={}){let r=Ht(e,this.config);this.call(n=>this.engine._world_reset(this.at,n.arrays(
r)))}step(e){let r=Ae(e);this.call(n=>this.engine._world_step(this.at,n.arrays(r)))}playTurn(e){let r=Ae(e);this.call(n=>this.engine._world_play_turn(this.at,n.
arrays(r)))}decide(e,r,n){let{n_pursuers:s}=this.config,o=r==="pursuer"?[0,s]:[s,this.n_agents];return this.choose(e,o,n)}choose(e,[r,n],s){if(s.length!==this.n_agents)
throw _("actions",String(this.n_agents),s.length);let o=[K(e),Ae(s)],{actions:a}=this.call(i=>this.engine._world_decide(this.at,i.arrays(o[0]),r,n,i.arrays(o[1])));
return Uint8Array.from(a)}get n_turns(){return this.turnNumbers()[1]}get turn(){return this.turnNumbers()[0]}get actors(){let[,,e,r]=this.turnNumbers();return[e,
r]}turnNumbers(){return this.call(()=>this.engine._world_turn(this.at)).turn}get steps(){return this.read("steps")[0]}get seed(){return this.read("seed")[0]}get episode(){
return this.read("episode")[0]}get over(){return this.read("terminated")[0]===1||this.read("truncated")[0]===1}read(e){return this.call(r=>this.engine._world_read(
this.at,r.text(e)))[e]}view(e){let r=3*this.config.fov**2;return this.read("views").slice(e*r,(e+1)*r)}map(){return this.read("state").slice(2*this.config.rows*
this.config.cols)}conflicts(){let{conflict_table:e}=this.call(()=>this.engine._world_conflicts(this.at));return xe(e,this.config.n_pursuers)}answer(e,r){let n=K(
e),{logits:s}=this.call(i=>this.engine._world_logits(this.at,i.arrays(n),r)),o=s,a=this.choose(e,[r,r+1],new Uint8Array(this.n_agents))[r];return{logits:o,probabilities:Pn(
o),action:a}}snapshot(){return this.call(()=>this.engine._world_snapshot(this.at))}restore(e){let r=Bt(e);this.call(n=>this.engine._world_restore(this.at,n.arrays(
r)))}call(e){if(this.freed)throw _("world","one that is in use","one that was freed");return ne(this.engine,e),Se(this.engine)}};function Pn(t){let e=Math.max(...t),
r=Array.from(t,s=>Math.exp(s-e)),n=r.reduce((s,o)=>s+o,0);return Float32Array.from(r,s=>s/n)}var nt=class{compiled;constructor(e){this.compiled=e}world(e){return new se(this.compiled,e)}match(e,r,n,s,o=0){return jt(this.compiled,{config:e,pursuers:r,evaders:n},
s,o)}rollout(e,r,n,s,o){return Gt(this.compiled,{config:e,pursuers:r,evaders:n},s,o)}},Vt;function Kt(t=globalThis.matrixworldEngine){return Vt??=$n(t),Vt}async function $n(t){
if(!t)throw new Error("matrixworldEngine: expected the script engine.js before this one, got none");let e=Uint8Array.from(atob(t.binary),r=>r.charCodeAt(0));return new nt(
await t({wasmBinary:e}))}var Nn="http://www.w3.org/2000/svg";function u(t,e={},...r){return Xt(document.createElement(t),e,r)}function y(t,e={},...r){return Xt(document.createElementNS(
Nn,t),e,r)}function Xt(t,e,r){for(let[n,s]of Object.entries(e))s==null||s===!1||(typeof s=="function"?t.addEventListener(n.slice(2),s):t.setAttribute(n,s===!0?"":
String(s)));return t.append(...r.filter(In).map(n=>typeof n=="number"?String(n):n)),t}function In(t){return t!=null&&t!==!1}var Ln=matchMedia("(prefers-color-scheme: dark)");function Un(){let t=document.documentElement.dataset.theme;return t?t==="dark":Ln.matches}function st(){document.
documentElement.dataset.theme=Un()?"light":"dark"}function qt(){return u("button",{type:"button",title:"Light or dark (D)","aria-label":"Light or dark",onclick:st},"◐")}var Dn=2n**64n-1n;function ot(t,e,r){let n=new URLSearchParams(t.replace(/^#/,"")),s=(c,d,m)=>{let p=n.get(c)??"";return/^\d{1,9}$/.test(p)&&Number(p)<d?Number(
p):m},o=s("run",e.length,r.run),[a,i]=e[o].payoff.shape,l=n.get("seed")??"";return{run:o,pursuer:s("pursuers",a,Math.min(r.pursuer,a-1)),evader:s("evaders",i,Math.
min(r.evader,i-1)),episode:s("episode",1/0,r.episode),seed:/^\d{1,20}$/.test(l)&&BigInt(l)<=Dn?l:null,step:s("step",1/0,0)}}function Yt(t,e,r){let n="",s=()=>{let{
run:o,pursuer:a,evader:i,episode:l,seed:c}=e.selected,d={run:o,pursuers:a,evaders:i,episode:l,...c===null?{}:{seed:c},step:r.player.step};n=`#${Object.entries(d).
map(([m,p])=>`${m}=${p}`).join("&")}`;try{history.replaceState(null,"",n)}catch{}};e.on("match",s),r.player.addEventListener("state",()=>r.player.playing||s()),
r.player.addEventListener("step",()=>r.player.playing||s()),window.addEventListener("hashchange",()=>{if(location.hash===n)return;let{step:o,...a}=ot(location.hash,
t,e.selected);e.select(a),r.goTo(o)})}function Zt(){return JSON.parse(Ce("data"))}function oe(t,e,r){let[n,s]=[e-t.payoff.first[0],r-t.payoff.first[1]],o=t.payoff.capture_rate[n]?.[s];return o===void 0?
null:{rate:o,rates:t.payoff.capture_rates[n][s],lengths:t.payoff.lengths[n][s]}}function ae(t,e,r){let n=t.teams[e];return n.script!==null||n.kept.includes(r)}function ie(t,e,r){
let{script:n,network:s,kept:o,genomes:a}=t.teams[e];if(n!==null||s===null)return n??"random";let i=o.indexOf(r);if(i<0)throw new RangeError(`${e}: expected a ge\
neration whose genome the page holds, got ${r}`);let l=s.genome_size,c=Hn(a).subarray(i*l,(i+1)*l);return{hidden:s.hidden,activation:s.activation,sampled:s.sampled,
genome:c}}var Jt=new Map;function Hn(t){let e=Jt.get(t);if(e)return e;let r=new Float32Array(at(t).buffer);return Jt.set(t,r),r}function at(t){let e=atob(Ce(t)),
r=new Uint8Array(e.length);for(let n=0;n<r.length;n++)r[n]=e.charCodeAt(n);return r}function Ce(t){return document.getElementById(t)?.textContent??""}var Bn={now:()=>performance.now(),request:t=>requestAnimationFrame(t),cancel:t=>cancelAnimationFrame(t)},le=[.5,1,2,4,8,16,32,64],X=class extends EventTarget{#e;#n;#o;#i;#r=0;#t=0;#s=!1;#c=null;#u=0;glide=.28;constructor(e,r={}){
super(),this.#e=e,this.#n=r.speed??4,this.#i=r.still??!1,this.#o=r.clock??Bn}get step(){return this.#r}get time(){return this.#i?this.#r:this.#t}get arrived(){return this.#t===
this.#r}get playing(){return this.#s}get length(){return this.#e}set length(e){this.#e=e,this.#r>e&&this.jump(e),this.#m("state")}get speed(){return this.#n}set speed(e){
this.#n=e,this.#m("state")}changeSpeed(e){let r=le.findIndex(n=>n>=this.#n);this.speed=le[Math.min(le.length-1,Math.max(0,r+e))]}play(){this.#s||!this.#e||(this.#r===
this.#e&&this.jump(0),this.#s=!0,this.#m("state"),this.#d())}pause(){this.#s&&(this.#s=!1,this.#m("state"))}toggle(){this.#s?this.pause():this.play()}move(e){this.
pause();let r=Math.min(this.#e,Math.max(0,this.#r+e));Math.abs(r-this.#t)>1?this.jump(r):this.#a(r),this.#d()}jump(e){this.#t=Math.min(this.#e,Math.max(0,Math.round(
e))),this.#a(this.#t),this.#m("frame")}#a(e){e!==this.#r&&(this.#r=e,this.#m("step"))}#d(){this.#c===null&&(this.#u=this.#o.now(),this.#c=this.#o.request(()=>this.#l()))}#l(){
this.#c=null;let e=this.#o.now();this.#h(Math.min(.25,(e-this.#u)/1e3)),this.#u=e,this.#m("frame"),(this.#s||this.#t!==this.#r)&&(this.#c=this.#o.request(()=>this.#l()))}#h(e){
let r=e;for(;r>0;){if(this.#t===this.#r){if(!this.#s)return;if(this.#r===this.#e)return this.pause();this.#a(this.#r+1)}let n=this.#s?this.#n:1/this.glide,s=this.#r-
this.#t,o=Math.min(Math.abs(s),r*n);r-=o/n,this.#t=o===Math.abs(s)?this.#r:this.#t+Math.sign(s)*o}this.#s&&this.#t===this.#e&&this.pause()}#m(e){this.dispatchEvent(
new Event(e))}};function q(t,e){if(e.ctrlKey||e.metaKey||e.altKey)return!1;let r=e.shiftKey?10:1,s={" ":()=>t.toggle(),ArrowRight:()=>t.move(r),ArrowLeft:()=>t.
move(-r),Home:()=>t.move(-t.length),End:()=>t.move(t.length),"+":()=>t.changeSpeed(1),"-":()=>t.changeSpeed(-1)}[e.key];return s?.(),s!==void 0}var ce=[[68,1,84],[72,26,108],[71,47,125],[65,68,135],[57,86,140],[49,104,142],[42,120,142],[35,136,142],[31,152,139],[34,168,132],[53,183,121],[84,197,104],[122,
209,81],[165,219,54],[210,226,27],[253,231,37]];function ue(t){let e=Math.min(1,Math.max(0,t))*(ce.length-1),r=Math.min(ce.length-2,Math.floor(e)),[n,s]=[ce[r],
ce[r+1]],o=a=>Math.round(n[a]+(e-r)*(s[a]-n[a]));return[o(0),o(1),o(2)]}var Qt=t=>`rgb(${ue(t).join(" ")})`,er=()=>`linear-gradient(to right, ${ce.map(t=>`rgb(${t.
join(" ")})`).join(", ")})`;function Te(t,e,r){let n=devicePixelRatio||1;t.style.left=`${r.left}px`,t.style.top=`${r.top}px`,t.style.width=`${r.width}px`,t.style.height=`${r.height}px`,t.width=
Math.round(r.width*n),t.height=Math.round(r.height*n);let s=t.getContext("2d"),o=Fn(e);!s||!o||(s.imageSmoothingEnabled=!1,s.drawImage(o,0,0,t.width,t.height))}
function Fn(t){let[e,r]=t.shape,n=document.createElement("canvas");[n.width,n.height]=[r,e];let s=n.getContext("2d");if(!s)return null;let o=s.createImageData(r,
e);return t.capture_rate.forEach((a,i)=>a.forEach((l,c)=>{let d=4*((e-1-i-t.first[0])*r+c+t.first[1]);o.data.set([...ue(l),255],d)})),s.putImageData(o,0,0),n}var Wn=84;function tr(t,e){let r=t.map((o,a)=>jn(o,a,e)),n=u("nav",{class:"races",role:"tablist","aria-label":"Runs"},...r.map(o=>o.button)),s=()=>r.forEach((o,a)=>o.
update(a===e.selected.run));return e.on("match",s),e.on("hover",s),s(),n.hidden=t.length<2,n}function jn(t,e,r){let[n,s]=t.payoff.shape,o=Wn/Math.max(n,s),a=u("\
canvas",{"aria-hidden":"true"});Te(a,t.payoff,{left:0,top:0,width:s*o,height:n*o});let i=u("span",{class:"place"}),l=u("button",{type:"button",role:"tab",class:"\
race",title:`Key ${e+1}`,onclick:()=>it(t,e,r)},u("span",{class:"small-matrix"},a,i),u("span",{class:"race-text"},u("strong",{},t.name),u("span",{class:"small"},
t.findings?t.findings.headline:`${t.learning.join(" and ")}s against ${Gn(t)}`),t.schedule===t.name?null:u("span",{class:"small muted"},`${t.schedule}, seed ${t.
seed}`)));return{button:l,update:d=>{l.ariaSelected=String(d);let m=r.hover.pursuer??r.selected.pursuer,p=r.hover.evader??r.selected.evader;i.hidden=m>=n||p>=s,
i.style.left=`${(p+.5)*o}px`,i.style.top=`${(n-m-.5)*o}px`}}}var Gn=t=>t.teams.pursuer.script??t.teams.evader.script??"another run";function it(t,e,r){let[n,s]=t.
payoff.shape,{pursuer:o,evader:a}=r.selected;r.select({run:e,pursuer:Math.min(o,n-1),evader:Math.min(a,s-1)})}var zn=[[["Space"],"play or pause"],[["←","→"],"step back or forward; with Shift ten steps"],[["Home","End"],"first or last step"],[["+","−"],"faster or s\
lower"],[["N"],"next episode of the same pair; with Shift the one before"],[["R"],"another seed, not one of the evaluation"],[["O"],"the cell's own seed again"],
[["P"],"next pursuer generation; with Shift the one before"],[["E"],"next evader generation; with Shift the one before"],[["M"],"to the matrix: arrow keys choos\
e a match, Enter plays it"],[["A"],"next agent: what it sees; with Shift the one before"],[["Esc"],"no agent"],[["G"],"this step in the playground: any other ru\
les, actions and places"],[["1","9"],"first to ninth run"],[["D"],"light or dark"],[["?"],"this list"]];function rr(){let t=zn.map(([r,n])=>u("div",{class:"key-\
row"},u("dt",{},...r.map(s=>u("kbd",{},s))),u("dd",{},n))),e=u("dialog",{class:"help","aria-labelledby":"help-title"},u("h2",{id:"help-title"},"Keys"),u("dl",{class:"\
keys"},...t),u("p",{class:"muted small"},"The page holds the genomes and the engine of this run. A click on a cell plays that very match: same seed, same moves.\
 Triangles pursue, discs evade; a ring is a captured evader, a star a capture, dashed cells are conflicts. The page loads nothing from elsewhere; share the file\
 as it is."),u("button",{type:"button",onclick:()=>e.close()},"Close"));return e.addEventListener("click",r=>r.target===e&&e.close()),e}function nr(t,e,r,n,s){let o=(i,l)=>()=>{
let c=t[e.selected.run].payoff.shape[i==="pursuer"?0:1];e.select({[i]:Math.min(c-1,Math.max(0,e.selected[i]+l))})},a={n:()=>e.select({episode:e.selected.episode+
1}),N:()=>e.select({episode:Math.max(0,e.selected.episode-1)}),r:()=>e.select({seed:String(crypto.getRandomValues(new BigUint64Array(1))[0]),episode:0}),o:()=>e.
select({seed:null,episode:0}),p:o("pursuer",1),P:o("pursuer",-1),e:o("evader",1),E:o("evader",-1),m:()=>document.getElementById("matrix")?.focus(),a:()=>r.inspector.
next(1),A:()=>r.inspector.next(-1),Escape:()=>r.inspector.choose(null),g:s,d:st,"?":()=>n.showModal()};document.addEventListener("keydown",i=>{let l=i.target instanceof
HTMLSelectElement||i.target instanceof HTMLInputElement,c=i.target instanceof HTMLButtonElement&&(i.key===" "||i.key==="Enter");if(document.querySelector("dialo\
g[open]")||l||c||i.defaultPrevented||i.ctrlKey||i.metaKey||i.altKey)return;let d=a[i.key]??a[i.key.toLowerCase()],m=Number(i.key)-1;if(q(r.player,i)||d)d?.();else if(t[m])
it(t[m],m,e);else return;i.preventDefault()})}var lt=[[0,0],[-1,0],[0,1],[1,0],[0,-1],[-1,1],[1,1],[1,-1],[-1,-1]],B=(t,e)=>e<t.nPursuers,M=(t,e)=>[t.positions[2*e],t.positions[2*e+1]],Vn=(t,e)=>t[0]===e[0]&&
t[1]===e[1],ct=({rows:t,cols:e},[r,n])=>r>=0&&n>=0&&r<t&&n<e,ut=(t,e,r=3)=>t!==void 0&&[0,1,2].slice(0,r).some(n=>t[3*e+n]),dt=(t,e)=>ut(t.fault,e),sr=(t,e)=>!dt(
t,e)&&ut(t.involved,e,2);function Re(t,e,r){let n=!Vn(M(t,r),M(e,r)),s=e.involved===void 0||ut(e.involved,r);return!!(e.alive[r]&&e.actions?.[r]&&!n&&s)}function ke(t,e,r){
let[n,s]=M(t,r),[o,a]=lt[e.actions?.[r]??0];return[n+o,s+a]}function Oe(t,e,r){return Array.from({length:r.everCaptured.length},(s,o)=>o).filter(s=>r.everCaptured[s]&&
!e.everCaptured[s]).map(s=>t.nPursuers+s)}function Pe(t,e){return Array.from({length:e.alive.length},(n,s)=>s).filter(n=>t.alive[n]&&!e.alive[n])}var or=[-.31,0,.31],ar=[{size:1,at:[[0,0]]},{size:.62,at:[[-.2,.2],[.2,-.2]]},{size:.54,at:[[-.23,.22],[.23,.22],[0,-.22]]},{size:.54,at:[[-.23,.23],[.23,.23],[
-.23,-.23],[.23,-.23]]},{size:.36,at:or.flatMap(t=>or.map(e=>[e,t]))}],Kn=.3,Xn=.35,qn=.55;function de(t,e){let r=new Map;for(let n=0;n<e.alive.length;n++){if(!e.
alive[n])continue;let[s,o]=M(e,n),a=s*t.cols+o,i=r.get(a);i?i.push(n):r.set(a,[n])}return r}function ir(t,e){let r=Array.from(e.alive,(n,s)=>{let[o,a]=M(e,s);return{
x:a+.5,y:o+.5,size:1,alpha:0}});for(let n of de(t,e).values()){let s=ar[Math.min(n.length,ar.length)-1];n.forEach((o,a)=>{let[i,l]=s.at[Math.min(a,s.at.length-1)],
c=r[o];c.x+=i,c.y+=l,c.size=s.size,c.alpha=1})}return r}var lr=t=>t*t*(3-2*t),Y=(t,e,r)=>t+(e-t)*r,cr=t=>Math.min(1,Math.max(0,t));function ur(t,e,r,n){let s={1:2,
2:r}[t.interaction]??1;if(s===1)return lr(n);let o=s===r?e:+!B(t,e),a=Math.max(1/s,Xn);return lr(cr((n-o/(s-1)*(1-a))/a))}function $e(t,e){let r=t.moments.length-
1,n=Math.min(Math.floor(e),r),s=t.moments[n],o=ir(t,s);if(n===r||e===n)return o;let a=t.moments[n+1],i=ir(t,a);return o.map((l,c)=>{let d=ur(t,c,o.length,e-n);return Yn(
s,a,c,l,i[c],d)})}function dr(t,e,r){let n=t.moments.length-1,s=Math.min(Math.floor(r),n),[o,a]=[t.moments[s],t.moments[Math.min(s+1,n)]],i=ur(t,e,o.alive.length,
r-s),[[l,c],[d,m]]=[M(o,e),M(a,e)];return[Y(c,m,i)+.5,Y(l,d,i)+.5]}function Yn(t,e,r,n,s,o){let a=n.alpha>s.alpha,i={x:Y(n.x,s.x,o),y:Y(n.y,s.y,o),size:a?n.size:
Y(n.size,s.size,o),alpha:a?cr((1-o)/(1-qn)):Y(n.alpha,s.alpha,o)};if(Re(t,e,r)){let[l,c]=M(t,r),[d,m]=ke(t,e,r),p=Kn*Math.sin(Math.PI*o);i.x+=(m-c)*p,i.y+=(d-l)*
p}return i}var mr=2*Math.PI;function F(t,e,r,n){t.beginPath(),t.arc(e,r,n/2,0,mr)}function Ne(t,e,r,n){let s=n/2,o=[[0,-.97],[.97,.83],[-.97,.83]].map(([a,i])=>[e+a*s,r+i*
s]);t.beginPath(),t.moveTo((o[2][0]+o[0][0])/2,(o[2][1]+o[0][1])/2),o.forEach(([a,i],l)=>{let[c,d]=o[(l+1)%3];t.arcTo(a,i,c,d,n*.09)}),t.closePath()}function pr(t,e,r,n){
let s=n*.32;t.beginPath(),t.moveTo(e-s,r-s),t.lineTo(e+s,r+s),t.moveTo(e+s,r-s),t.lineTo(e-s,r+s)}function hr(t,e,r,n){t.beginPath();for(let s=0;s<16;s++){let o=n/
2*(s%2?.6:.95),a=mr*s/16;t.lineTo(e+o*Math.sin(a),r-o*Math.cos(a))}t.closePath()}function fr(t,e,r,n,s,o){let a=Math.atan2(s-r,n-e);t.beginPath(),t.moveTo(e,r),
t.lineTo(n,s);for(let i of[-1,1])t.moveTo(n,s),t.lineTo(n-o*Math.cos(a+i*.6),s-o*Math.sin(a+i*.6))}var gr=4,Jn=1.6,Zn=.95,Qn=5,es=.16,ts=9,rs=.09,ns=.2,yr=.75,R=(t,e)=>t.left+e*t.cell,k=(t,e)=>t.top+e*t.cell;function J(t,e,r){return B(e,r)?t.colors.pursuer:t.
colors.evader}function br({ctx:t,grid:e,colors:r}){let{left:n,top:s,cell:o,rows:a,cols:i}=e,[l,c]=[i*o,a*o];if(t.fillStyle=r.paper,t.fillRect(n,s,l,c),o<Qn)return;
t.fillStyle=r.line;let d=Math.max(1,Math.round(o/60));for(let m=1;m<i;m++)t.fillRect(n+m*o,s,d,c);for(let m=1;m<a;m++)t.fillRect(n,s+m*o,l,d)}function vr({ctx:t,
grid:e,colors:r},n){let{left:s,top:o,cell:a,rows:i,cols:l}=e;t.fillStyle=r.obstacle;for(let d=0;d<i*l;d++){if(!n.obstacles[d])continue;let[m,p]=[Math.floor(d/l),
d%l];t.fillRect(s+p*a,o+m*a,a,a)}let c=Math.min(5,Math.max(2,Math.round(a/18)));t.strokeStyle=r.frame,t.lineWidth=c,t.strokeRect(s-c/2,o-c/2,l*a+c,i*a+c)}function wr({
ctx:t,grid:e,colors:r},n){let{left:s,top:o,cell:a,rows:i,cols:l}=e,c=a<24*n?5:1;t.font=`500 ${Math.round(Math.min(15*n,Math.max(9*n,a*.32)))}px system-ui, sans-\
serif`,t.fillStyle=r.muted,t.textBaseline="alphabetic",t.textAlign="center";let d=5*n+a/40;for(let m=0;m<l;m+=c)t.fillText(String(m),s+(m+.5)*a,o-d);t.textAlign=
"right",t.textBaseline="middle";for(let m=0;m<i;m+=c)t.fillText(String(m),s-d,o+(m+.5)*a)}function xr(t,e,r,n,s){let{ctx:o,grid:a}=t,i=Math.floor(e.fov/2)+.5,[l,
c]=[Math.max(0,n-i),Math.min(a.cols,n+i)],[d,m]=[Math.max(0,s-i),Math.min(a.rows,s+i)],p=[R(a,l),k(a,d),(c-l)*a.cell,(m-d)*a.cell],f=J(t,e,r);o.globalAlpha=.11,
o.fillStyle=f,o.fillRect(...p),o.globalAlpha=.8,o.strokeStyle=f,o.lineWidth=Math.max(1,a.cell/24),o.strokeRect(...p),o.globalAlpha=1}function Sr(t,e,r,n,s){let{
ctx:o,grid:a}=t,i=Math.min(Math.ceil(r),e.moments.length-1),l=e.moments[i];o.lineCap="round",o.lineWidth=Math.min(ts,Math.max(1,a.cell*es));for(let c=Math.max(1,
Math.floor(r-n)+1);c<=i;c++){let[d,m]=[e.moments[c-1],e.moments[c]],p=Math.max(0,Math.min(1,(r-c)/n));o.globalAlpha=yr+(ns-yr)*p;for(let f=0;f<m.alive.length;f++){
let g=c===i&&r<i;if(!d.alive[f]||!(l.alive[f]||g))continue;let h=(B(e,f)?-1:1)*rs,[b,w]=M(d,f),[S,v]=M(m,f);if(b===S&&w===v)continue;let x=g?s[f].x:v+.5,C=g?s[f].
y:S+.5;o.strokeStyle=J(t,e,f),o.beginPath(),o.moveTo(R(a,w+.5+h),k(a,b+.5+h)),o.lineTo(R(a,x+h),k(a,C+h)),o.stroke()}}o.globalAlpha=1}function _r(t,e,r){let n=Math.
min(Math.ceil(r),e.moments.length-1);for(let s=Math.max(1,n-gr+1);s<=n;s++){let[o,a]=[e.moments[s-1],e.moments[s]],i=s>r?Math.max(0,1-2*(s-r)):1-(r-s)/gr,l=Oe(e,
o,a);for(let c of Pe(o,a))l.includes(c)||os(t,M(a,c),i);for(let c of l)ss(t,M(a,c),i)}t.ctx.globalAlpha=1}function ss({ctx:t,grid:e,colors:r},[n,s],o){t.globalAlpha=
o,hr(t,R(e,s+.5),k(e,n+.5),Math.max(8,e.cell*Jn)),t.fillStyle=r.capture,t.fill(),t.strokeStyle=r.ink,t.lineWidth=Math.max(1,e.cell/36),t.lineJoin="round",t.stroke()}
function os({ctx:t,grid:e,colors:r},[n,s],o){t.globalAlpha=o,pr(t,R(e,s+.5),k(e,n+.5),Math.max(7,e.cell*Zn)),t.strokeStyle=r.collision,t.lineWidth=Math.max(2,e.
cell*.17),t.lineCap="round",t.stroke()}function Mr({ctx:t,grid:e,colors:r},n,s){let o=Math.max(1,e.cell*.07);t.strokeStyle=t.fillStyle=r.collision,t.lineWidth=Math.
max(1,e.cell*.05),t.setLineDash([e.cell*.14,e.cell*.1]);for(let[a,i]of n){if(a<0||i<0||a>=e.rows||i>=e.cols)continue;let l=[R(e,i)+o,k(e,a)+o,e.cell-2*o,e.cell-
2*o];t.globalAlpha=.2*s,t.fillRect(...l),t.globalAlpha=s,t.strokeRect(...l)}t.setLineDash([]),t.globalAlpha=1}function Ar({ctx:t,grid:e,colors:r},n,s,o,a){t.globalAlpha=
a,F(t,R(e,n),k(e,s),Math.max(8,e.cell*o*1.02)),t.strokeStyle=r.collision,t.lineWidth=Math.max(1.5,e.cell*.085*Math.sqrt(o)),t.stroke(),t.globalAlpha=1}var as=.8,is=.92,ls=15,cs=7,ht=9;function Er(t,e,r,n,s,o){n.forEach((a,i)=>{a.alpha>0&&us(t,e,r,i,a,s,o)}),t.ctx.globalAlpha=1;for(let a of de(e,r).values())a.length>
ht&&ds(t,n[a[ht-1]],a.length-ht+1)}function us(t,e,r,n,s,o,a){let{ctx:i,grid:l,colors:c}=t,d=B(e,n),[m,p]=[l.left+s.x*l.cell,l.top+s.y*l.cell],f=Math.max(4,l.cell*
s.size*(d?is:as)),g=J(t,e,n),h=!d&&!!r.captured[n-e.nPursuers];if(i.globalAlpha=s.alpha,(d?Ne:F)(i,m,p,f),f>cs*a&&(i.strokeStyle=c.paper,i.lineWidth=Math.max(2,
f*.1),i.stroke()),i.fillStyle=h?c.paper:g,i.fill(),h&&(F(i,m,p,f*.82),i.strokeStyle=g,i.lineWidth=f*.18,i.stroke()),!o||f<ls*a)return;let b=String(d?n:n-e.nPursuers);
i.font=`700 ${Math.round(f*(d?.4:.5)*(b.length>1?.8:1))}px system-ui, sans-serif`,i.textAlign="center",i.textBaseline="middle",i.fillStyle=h?g:c.paper,i.fillText(
b,m,p+f*(d?.17:.03))}function ds({ctx:t,grid:e,colors:r},n,s){let[o,a]=[e.left+n.x*e.cell,e.top+n.y*e.cell];t.font=`700 ${Math.round(e.cell*.3)}px system-ui, sa\
ns-serif`,t.textAlign="center",t.textBaseline="middle",t.strokeStyle=r.paper,t.lineWidth=e.cell*.1,t.strokeText(`+${s}`,o,a),t.fillStyle=r.ink,t.fillText(`+${s}`,
o,a)}var ms=.46,ps=.86,hs=.66,Cr=.48,fs=.78,gs=.58;function Tr(t,e,r,n){let[s,o]=[e.moments[r-1],e.moments[r]];if(!s)return;let{ctx:a,grid:i,colors:l}=t;a.strokeStyle=
l.collision,a.lineWidth=Math.max(1.5,i.cell*.07),a.lineCap="butt",a.globalAlpha=n;for(let c=0;c<o.alive.length;c++)Re(s,o,c)&&ys(t,e,M(s,c),ke(s,o,c));a.globalAlpha=
1}function ys({ctx:t,grid:e},r,n,s){let[o,a]=[s[1]-n[1],s[0]-n[0]],i=m=>R(e,n[1]+.5+o*m),l=m=>k(e,n[0]+.5+a*m),c=ct(r,s)?fs:gs;t.setLineDash([e.cell*.09,e.cell*
.06]),t.beginPath(),t.moveTo(i(Cr),l(Cr)),t.lineTo(i(c),l(c)),t.stroke(),t.setLineDash([]);let d=.17*e.cell/Math.hypot(o,a);t.beginPath(),t.moveTo(i(c)-a*d,l(c)+
o*d),t.lineTo(i(c)+a*d,l(c)-o*d),t.stroke()}function Rr(t,e,r,n,s,o){let a=lt[o];if(!o||!a)return;let{ctx:i,grid:l,colors:c}=t,d=ct(e,[n[0]+a[0],n[1]+a[1]])?ps:
hs,m=ms*s.size,p=[R(l,s.x+a[1]*m),k(l,s.y+a[0]*m),R(l,s.x+a[1]*d),k(l,s.y+a[0]*d)],f=Math.max(1.5,l.cell*.085);i.lineCap=i.lineJoin="round";for(let[g,h]of[[c.paper,
f*2.1],[J(t,e,r),f]])i.strokeStyle=g,i.lineWidth=h,fr(i,...p,l.cell*.2),i.stroke()}var Or={numbers:!0,axes:!1,trail:6,viewers:[],plan:null,selected:null,cursor:null};function Pr(t,e,r,n,s){let{ctx:o,grid:a,colors:i}=t,l=Math.min(Math.ceil(r),e.
moments.length-1),c=e.moments[l],d=r===l,m=$e(e,r),p=d?1:Math.max(0,1-2*(l-r));o.clearRect(0,0,o.canvas.width,o.canvas.height),br(t);for(let h of n.viewers)m[h]?.
alpha&&xr(t,e,h,...dr(e,h,r));vr(t,e),n.axes&&wr(t,s),Sr(t,e,r,n.trail,m),Mr(t,c.contested??[],p),_r(t,e,r),Tr(t,e,l,p),m.forEach(({x:h,y:b,size:w},S)=>{let v=sr(
c,S)?.4:0,x=dt(c,S)?1:v;x&&Ar(t,h,b,w,x*p)});let f=d?c:e.moments[Math.max(0,l-1)];if(Er(t,e,f,m,n.numbers,s),d&&n.plan)for(let[h,b]of m.entries())b.alpha&&Rr(t,
e,h,M(c,h),b,n.plan[h]??0);o.lineWidth=Math.max(2,2.5*s),o.strokeStyle=i.focus;let g=n.selected===null?void 0:m[n.selected];g?.alpha&&kr(t,g.x,g.y,g.size*.96),n.
cursor&&(o.setLineDash([a.cell*.12,a.cell*.08]),kr(t,n.cursor[1]+.5,n.cursor[0]+.5,.8),o.setLineDash([]))}function kr({ctx:t,grid:e},r,n,s){let o=s*e.cell;t.beginPath(),
t.roundRect(e.left+r*e.cell-o/2,e.top+n*e.cell-o/2,o,o,o*.1),t.stroke()}function $r(t,e,r){let n=.24+(r?.62:0);return(e+n)/(t+n)}function Nr(t,e,r,n,s,o){let a=r?30*o:0,i=(d,m)=>Math.max((d-a)/(m+2*.12),d/(m+2*.12+(r?.62:0))),l=Math.
max(1,Math.floor(Math.min(i(n,e),i(s,t)))),c=r?Math.min(.62*l,a):0;return{rows:t,cols:e,cell:l,left:Math.round((n-e*l+c)/2),top:Math.round((s-t*l+c)/2)}}function Ir(t,e,r){
let n=Math.floor((r-t.top)/t.cell),s=Math.floor((e-t.left)/t.cell);return n>=0&&n<t.rows&&s>=0&&s<t.cols?[n,s]:null}var bs={paper:"--board-paper",line:"--board-line",frame:"--board-frame",ink:"--board-ink",muted:"--board-muted",obstacle:"--board-obstacle",pursuer:"--pursuer",
evader:"--evader",capture:"--capture",collision:"--collision",focus:"--focus"};function Ie(t){let e=getComputedStyle(t),r=Object.entries(bs).map(([n,s])=>[n,e.getPropertyValue(
s).trim()]);return Object.fromEntries(r)}var Q=()=>matchMedia("(prefers-reduced-motion: reduce)").matches,Z=class{canvas;#e=null;#n=0;#o;#i={rows:1,cols:1,left:0,top:0,cell:1};#r=0;#t;#s;constructor(e,r={}){
this.canvas=e,e.classList.add("board"),e.setAttribute("role","img"),this.#o={...Or,...r},this.#t=new ResizeObserver(()=>this.#u()),this.#t.observe(e),this.#s=new MutationObserver(
()=>this.redraw()),this.#s.observe(document.documentElement,{attributes:!0}),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",this.redraw)}close(){
this.#t.disconnect(),this.#s.disconnect(),matchMedia("(prefers-color-scheme: dark)").removeEventListener("change",this.redraw),cancelAnimationFrame(this.#r)}get look(){
return this.#o}set look(e){this.#o={...this.#o,...e},this.#c(),this.redraw()}get time(){return this.#n}show(e,r){this.#e=e,this.#n=Math.min(Math.max(0,r),e.moments.
length-1),this.#c(),this.redraw()}redraw=()=>{this.#r||(this.#r=requestAnimationFrame(()=>this.drawNow()))};drawNow(){cancelAnimationFrame(this.#r),this.#r=0;let e=this.
canvas.getContext("2d");if(!e||!this.#e)return;let{rows:r,cols:n}=this.#e,s=devicePixelRatio||1;this.#i=Nr(r,n,this.#o.axes,this.canvas.width,this.canvas.height,
s);let o={ctx:e,grid:this.#i,colors:Ie(this.canvas)};Pr(o,this.#e,this.#n,this.#o,s)}cellAt(e,r){let n=this.canvas.getBoundingClientRect(),s=this.canvas.width/n.
width;return Ir(this.#i,(e-n.left)*s,(r-n.top)*s)}agentAt(e,r){let n=this.cellAt(e,r);if(!n||!this.#e)return null;let s=this.#e.moments[Math.round(this.#n)],o=de(
this.#e,s).get(n[0]*this.#e.cols+n[1])??[],a=$e(this.#e,Math.round(this.#n)),i=l=>{let[c,d]=this.pointOf(a[l].x,a[l].y);return Math.hypot(c-e,d-r)};return o.length?
o.reduce((l,c)=>i(c)<i(l)?c:l):null}pointOf(e,r){let n=this.canvas.getBoundingClientRect(),s=n.width/this.canvas.width,{left:o,top:a,cell:i}=this.#i;return[n.left+
(o+e*i)*s,n.top+(a+r*i)*s]}#c(){if(!this.#e)return;let{rows:e,cols:r}=this.#e;this.canvas.style.setProperty("--board-aspect",String($r(e,r,this.#o.axes)))}#u(){
let e=devicePixelRatio||1,{width:r,height:n}=this.canvas.getBoundingClientRect();this.canvas.width=Math.max(1,Math.round(r*e)),this.canvas.height=Math.max(1,Math.
round(n*e)),this.drawNow()}};var ws={SIMULTANEOUS:0,SWARM_TURNS:1,AGENT_TURNS:2};function xs(t,e,r){return{rows:t.rows,cols:t.cols,nPursuers:t.n_pursuers,fov:t.fov,interaction:ws[t.rules.interaction],
obstacles:e,moments:r}}function Le(t){let e=Array.from({length:t.length+1},(r,n)=>Ss(t,n));return xs(t.config,t.map,e)}function Ss(t,e){let r=t.n_agents,n=t.config.n_evaders,s=(a,i,l)=>a.
subarray(i*l,(i+1)*l),o={positions:s(t.last_positions,e,2*r),alive:s(t.alive,e,r),captured:s(t.captured,e,n),everCaptured:s(t.ever_captured,e,n)};return e===0?o:
{...o,actions:s(t.actions,e-1,r),involved:s(t.involved,e-1,3*r),fault:s(t.fault,e-1,3*r),get contested(){return t.conflicts(e).map(a=>a.cell)}}}var _s={first:"M6 5v14M19 5 9 12l10 7z",back:"M17 5 7 12l10 7z",play:"M7 4.5 19 12 7 19.5z",pause:"M8 5v14M16 5v14",forward:"M7 5l10 7-10 7z",last:"M18 5v14M5 5\
l10 7-10 7z"};function Lr(t){let e=document.createElementNS("http://www.w3.org/2000/svg","svg");e.setAttribute("viewBox","0 0 24 24"),e.setAttribute("aria-hidde\
n","true"),e.classList.add("icon");let r=document.createElementNS("http://www.w3.org/2000/svg","path");return r.setAttribute("d",_s[t]),e.append(r),e}function me(t,e,r,n){
let s=document.createElement("button");return s.type="button",s.className="player-button",s.append(Lr(t)),s.ariaLabel=e,s.title=`${e} (${r})`,s.addEventListener(
"click",n),s}function Ue(t){let e=document.createElement("div");e.className="player",e.role="group",e.ariaLabel="Player";let r=me("play","Play","Space",()=>t.toggle()),
n=Ms(t),s=As(t),o=document.createElement("output");o.className="player-count",e.append(me("first","First step","Home",()=>t.move(-t.length)),me("back","Step bac\
k","←",()=>t.move(-1)),r,me("forward","Step forward","→",()=>t.move(1)),me("last","Last step","End",()=>t.move(t.length)),n,o,s);let a=()=>{r.replaceChildren(
Lr(t.playing?"pause":"play")),r.ariaLabel=t.playing?"Pause":"Play",r.title=`${r.ariaLabel} (Space)`,n.max=String(t.length),n.value=String(t.step),n.ariaValueText=
`step ${t.step} of ${t.length}`,o.textContent=`${t.step} / ${t.length}`,o.style.minWidth=`${2*String(t.length).length+3}ch`,s.value=String(t.speed)};return t.addEventListener(
"step",a),t.addEventListener("state",a),e.addEventListener("keydown",i=>{!(i.target instanceof HTMLSelectElement||i.key===" "&&i.target!==n)&&q(t,i)&&i.preventDefault()}),
a(),e}function Ms(t){let e=document.createElement("input");return e.type="range",e.className="player-scrub",e.min="0",e.step="1",e.ariaLabel="Step",e.addEventListener(
"input",()=>{t.pause(),t.jump(Number(e.value))}),e}function As(t){let e=document.createElement("select");return e.className="player-speed",e.ariaLabel="Speed",e.
title="Steps a second (+ and -)",e.append(...le.map(r=>new Option(`${r} / s`,String(r)))),e.addEventListener("change",()=>{t.speed=Number(e.value)}),e}var A=(t,e=2)=>t==null?"-":t.toFixed(e),ft=(t,e=1)=>t==null?"-":`${(100*t).toFixed(e)} %`;function De(t,e,r,n=2){return e===null||r===null?t.toFixed(n):`${t.toFixed(
n)} (${e.toFixed(n)} to ${r.toFixed(n)})`}var Ur=t=>t.toLocaleString("en-GB");function pe(t,e,r,n=!1){let s=(e-t)/Math.max(1,r),o=10**Math.floor(Math.log10(s||1)),
a=[1,2,5,10].map(c=>c*o).find(c=>c>=s)??10*o;n&&(a=Math.max(1,Math.round(a)));let i=Math.ceil(t/a-1e-9),l=Math.floor(e/a+1e-9);return Array.from({length:Math.max(
0,l-i+1)},(c,d)=>(i+d)*a)}function L(t,e,{pursuer:r,evader:n,episode:s,seed:o}){let a=e.seeds[r][n];return t.match(e.world,ie(e,"pursuer",r),ie(e,"evader",n),BigInt(o??a),s)}var Dr=40,he=new Map,fe=({run:t,pursuer:e,evader:r},n)=>`${t} ${e} ${r} ${n}`,He=class{element;#e;#n;#o=u("div",{class:"episodes",role:"group","aria-label":"Epi\
sodes of this cell"});#i=u("p",{class:"check small numbers","aria-live":"polite"});#r=0;constructor(e,r){[this.#e,this.#n]=[e,r],this.element=u("div",{class:"st\
rip-of-episodes"},this.#o,this.#i)}show(e,r,n){let{selected:s}=this.#e;s.seed===null&&he.set(fe(s,s.episode),Hr(n)),this.#s(r),Cs(this.#r),this.#t(e,r)}#t(e,r){
let{selected:n}=this.#e,o=oe(r,n.pursuer,n.evader)?.rates.findIndex((a,i)=>!he.has(fe(n,i)))??-1;o<0||o>=Dr||(this.#r=Es(()=>{this.#n.playing||(he.set(fe(n,o),Hr(
L(e,r,{...n,episode:o,seed:null}))),this.#s(r)),this.#t(e,r)}))}#s(e){let{selected:r}=this.#e,n=oe(e,r.pursuer,r.evader);if(!n){this.#o.replaceChildren(),this.#i.
textContent="The evaluation played no episodes of this pair.";return}let s=Math.min(Dr,n.rates.length);this.#o.replaceChildren(...n.rates.slice(0,s).map((c,d)=>this.#c(
c,d)));let o=n.rates.slice(0,s).map((c,d)=>he.get(fe(r,d))),a=o.filter(c=>c!==void 0),i=o.flatMap((c,d)=>c&&(Math.abs(c.rate-n.rates[d])>1e-6||c.length!==n.lengths[d])?
[d+1]:[]),l=a.reduce((c,d)=>c+d.rate,0)/a.length;this.#i.dataset.equal=String(!i.length&&a.length===n.rates.length),this.#i.textContent=i.length?`Episode ${i.join(
", ")} differs from the evaluation.`:a.length<n.rates.length?`Played here: ${a.length} of ${n.rates.length} episodes, all as in the evaluation.`:`Played here: a\
ll ${a.length} episodes, mean capture rate ${A(l,3)}. The cell says ${A(n.rate,3)}.`}#c(e,r){let{selected:n}=this.#e,s=u("span",{class:"bar"});return s.style.height=
`${Math.round(100*e)}%`,u("button",{type:"button",class:"episode",title:`Episode ${r+1}: capture rate ${A(e)}`,"aria-label":`Episode ${r+1}, capture rate ${A(e)}`,
"aria-pressed":String(r===n.episode&&n.seed===null),"data-played":he.has(fe(n,r)),onclick:()=>this.#e.select({episode:r,seed:null})},s,u("span",{class:"count"},
r+1))}},Hr=t=>({rate:t.statistics.capture_rate,length:t.length}),Es=t=>"requestIdleCallback"in window?requestIdleCallback(t,{timeout:1e3}):setTimeout(t,100),Cs=t=>"\
cancelIdleCallback"in window?cancelIdleCallback(t):clearTimeout(t);var ge=(t,e)=>t<e?`pursuer_${t}`:`evader_${t-e}`,gt=["stay","north","east","south","west","northeast","southeast","southwest","northwest"];var Br=0,Fr=1,Ts=2,Rs=176;function jr(t,e,r,n){let s=devicePixelRatio||1,o=Ie(t);t.width=t.height=Rs*s;let a=t.getContext("2d");if(!a)return;let{fov:i}=e,l=t.width/
i;a.fillStyle=o.paper,a.fillRect(0,0,t.width,t.height);for(let d=0;r&&d<i*i;d++){let[m,p]=[(d%i+.5)*l,(Math.floor(d/i)+.5)*l],f=h=>!!r[h*i*i+d];f(Ts)&&(a.fillStyle=
o.obstacle,a.fillRect(m-l/2,p-l/2,l,l));let g=f(Br)&&f(Fr)?l*.18:0;f(Br)&&Wr(a,F,m+g,p+g,l*.74,o.evader),f(Fr)&&Wr(a,Ne,m-g,p-g,l*.86,o.pursuer)}a.strokeStyle=n<
e.n_pursuers?o.pursuer:o.evader,a.lineWidth=2*s;let c=Math.floor(i/2)*l;a.strokeRect(c,c,l,l)}function Wr(t,e,r,n,s,o){e(t,r,n,s),t.fillStyle=o,t.fill()}var Be=class{element;#e;#n=u("canvas",{class:"seen",role:"img"});#o=u("h3");#i=u("p",{class:"small muted"});#r=u("div",{class:"answers"});#t=null;#s=null;#c=null;#u=null;#a=null;#d=0;constructor(e){
this.#e=e,this.element=u("div",{class:"inspector","data-open":"false"},u("p",{class:"hint small muted"},"Click an agent, or press A: what it sees, and what its \
network answers."),u("div",{class:"inspected"},this.#n,u("div",{class:"answer"},this.#o,this.#i),this.#r))}get agent(){return this.#a}show(e,r,n,s){(this.#s!==r||
!this.#t)&&(this.#t?.free(),this.#t=e.world(r.world),this.#a!==null&&this.#s!==r&&this.choose(null)),[this.#s,this.#c,this.#u]=[r,n,s]}choose(e){this.#a=e,this.
element.dataset.open=String(e!==null),this.#e(e),this.at(this.#d)}next(e){let r=this.#c;if(!r)return;let n=this.#a??(e>0?-1:0);for(let s=0;s<r.n_agents;s++)if(n=
(n+e+r.n_agents)%r.n_agents,r.alive[this.#d*r.n_agents+n])return this.choose(n)}at(e){this.#d=e;let[r,n,s,o,a]=[this.#c,this.#t,this.#s,this.#u,this.#a];if(!r||
!n||!s||!o||a===null)return;let i=a<r.config.n_pursuers?"pursuer":"evader";this.#o.replaceChildren(u("span",{class:i},ge(a,r.config.n_pursuers)));let l=!!r.alive[e*
r.n_agents+a];r.seek(n,e),jr(this.#n,r.config,l?n.view(a):null,a),this.#n.ariaLabel=`Field of view of ${ge(a,r.config.n_pursuers)}: evaders, pursuers and obstac\
les around it`;let c=e<r.length?r.actions[e*r.n_agents+a]:null;if(!l)return this.#l([],"It is gone.");let d=ie(s,i,o[i]);if(typeof d=="string")return this.#l([],
`The script "${d}" plays for it${c===null?"":`; it goes ${gt[c]}`}.`);let{probabilities:m}=n.answer(d,a),p=Array.from(m,(g,h)=>ks(gt[h],g,h===c)),f=d.sampled?"I\
ts action is drawn from these probabilities.":"It takes the most probable action.";this.#l(p,c===null?"The episode is over.":f)}#l(e,r){this.#r.replaceChildren(
...e),this.#i.textContent=r}};function ks(t,e,r){let n=u("span",{class:"filled"});return n.style.width=`${100*e}%`,u("div",{class:r?"action taken":"action"},u("\
span",{},t),u("span",{class:"track"},n),u("span",{class:"numbers"},e.toFixed(2)))}var Os=(t,e)=>Object.keys(t).every(r=>t[r]===e[r]);function Gr(t,e){return Object.keys(e).find(r=>Os(e[r],t))??null}var ye="_",ni=2n**64n-1n;var yt={fov:11,maxSteps:500,rewards:"paper"},$s=["rules","others","rewards","size","diagonal","fov","limit","seed","ended","walls","pursuers","evaders","played",
"next"];function qr(t,e){let r=i=>i.map(l=>Is(l,e)).join(""),n=i=>`${Math.floor(i/t.cols)}.${i%t.cols}`,s=Ns(t.rewards,e),o=[t.seed,t.episode,t.steps].join("."),a={rules:Vr(
t.rules,e),others:t.others?Vr(t.others,e):"",rewards:s===yt.rewards?"":s,size:`${t.rows}x${t.cols}`,diagonal:t.diagonal?"1":"",fov:t.fov===yt.fov?"":String(t.fov),
limit:t.maxSteps===yt.maxSteps?"":String(t.maxSteps),seed:o==="0.0.0"?"":o,ended:t.ended?"1":"",walls:t.walls.map(n).join(ye),pursuers:t.pursuers.map(zr).join(ye),
evaders:t.evaders.map(zr).join(ye),played:t.played.map(r).join(ye),next:t.next.every(i=>i===0)?"":r(t.next)};return $s.filter(i=>a[i]).map(i=>`${i}=${a[i]}`).join(
"&")}function zr({cell:t,gone:e,captured:r,everCaptured:n}){let s=r?"c":n?"e":"";return`${t[0]}.${t[1]}${s}${e?"x":""}`}function Vr(t,e){let r=e.fields.map(({name:n})=>String(
t[n]).toLowerCase());return Gr(t,e.variants)??r.join(".")}function Ns(t,e){let r=JSON.stringify(t);return Object.keys(e.rewards).find(s=>JSON.stringify(e.rewards[s])===
r)??Object.values(t).map(s=>String(s)).join(ye)}function Is(t,e){if(typeof t=="number")return String(t);let r=e.scripts.findIndex(({name:n})=>n===t);return String.
fromCharCode(97+r)}var Ls="/* the engine */";function Yr(t,e){return u("button",{type:"button",class:"to-playground",title:"Open this step in the playground (G): the same agents a\
nd actions under any rules",onclick:()=>bt(t(),e)},"What if? Playground")}function bt(t,e){let n=t!==null&&t.match.n_agents<=100&&Math.max(t.match.config.rows,t.
match.config.cols)<=64?qr(Us(t.match,t.step),e):"",s=new TextDecoder().decode(at("playground")).replace(Ls,()=>Ce("script-engine"));window.open(`${URL.createObjectURL(
new Blob([s],{type:"text/html"}))}#${n}`)}function Us(t,e){let{config:r,n_agents:n}=t,s=Math.max(0,e-1),o=i=>{let l=s*n+i,c=s*r.n_evaders+i-r.n_pursuers,d=m=>i>=
r.n_pursuers&&!!m[c];return{cell:[t.last_positions[2*l],t.last_positions[2*l+1]],gone:!t.alive[l],captured:d(t.captured),everCaptured:d(t.ever_captured)}},a=Array.
from({length:n},(i,l)=>o(l));return{rules:r.rules,others:null,rewards:r.rewards,rows:r.rows,cols:r.cols,diagonal:r.diagonal,fov:r.fov,maxSteps:r.max_steps,seed:t.
seed,episode:BigInt(t.episode),steps:s,ended:s===t.length,walls:Array.from(t.map.keys()).filter(i=>t.map[i]),pursuers:a.slice(0,r.n_pursuers),evaders:a.slice(r.
n_pursuers),played:[],next:Array.from(t.actions.subarray(s*n,(s+1)*n))}}function Jr(t,e,r){if(r===0)return[{kind:"start",text:Ds(t),agents:[]}];let[n,s]=[e.moments[r-1],e.moments[r]],o=d=>ge(d,t.config.n_pursuers),a=Oe(e,n,s),i=t.conflicts(
r),l=new Set(i.flatMap(d=>d.doomed)),c=a.map(d=>({kind:"capture",text:`${o(d)} is captured`,agents:[d]}));for(let d of Pe(n,s))!a.includes(d)&&!l.has(d)&&c.push(
{kind:"end",text:`${o(d)} disappears`,agents:[d]});return c.push(...i.map(({kind:d,text:m,agents:p})=>({kind:d,text:m,agents:p}))),r===t.length&&c.unshift({kind:"\
end",text:Hs(t),agents:[]}),c}function Ds({config:t}){return`${t.n_pursuers} pursuers and ${t.n_evaders} evaders on ${t.rows} x ${t.cols} cells, at most ${t.max_steps}\
 steps`}function Hs(t){let e=Math.round(t.statistics.capture_rate*t.config.n_evaders);return`The episode ends after ${t.length} steps with ${e} of ${t.config.n_evaders}\
 evaders captured`}var Bs=60,Fe=class{element;player=new X(0,{speed:8,still:Q()});inspector;#e;#n;#o;#i;#r=u("h2",{class:"match-title"});#t=u("p",{class:"tally numbers"});#s=u("ol",
{class:"words","aria-live":"off","aria-label":"What happened in this step"});#c=u("p",{class:"problem",role:"alert"});#u=null;#a=null;#d=null;#l=0;#h=!1;#m=0;constructor(e,r,n){
[this.#n,this.#o]=[e,r];let s=u("canvas",{"aria-label":"The match"});this.#e=new Z(s,{numbers:!1}),this.#i=new He(r,this.player),this.inspector=new Be(o=>this.#x(
o)),s.addEventListener("click",o=>this.inspector.choose(this.#e.agentAt(o.clientX,o.clientY))),this.element=u("section",{class:"card match-card","aria-label":"M\
atch",id:"match"},u("div",{class:"match"},u("header",{class:"match-head"},this.#r,this.#t),this.#c,u("div",{class:"stage"},s),u("div",{class:"aside"},this.#s,Yr(
()=>this.shown,n),this.inspector.element),Ue(this.player),this.#i.element)),this.player.addEventListener("frame",()=>this.#d&&this.#e.show(this.#d,this.player.time)),
this.player.addEventListener("step",()=>this.#v()),r.on("match",()=>this.#b()),this.#g(),this.#w(0,0)}get#p(){return this.#n[this.#o.selected.run]}get match(){return this.#a}get shown(){
return this.#a&&{match:this.#a,step:this.player.step}}start(e){this.#u=e,this.#y()}playSoon(){this.#h=!0,this.#l||this.#f()}goTo(e){this.#m=e,!this.#l&&this.#a&&
this.#y()}#f(){!this.#h||!this.#a||(this.#h=!1,this.player.jump(0),Q()||this.player.play())}#b(){this.#g(),clearTimeout(this.#l),this.#l=setTimeout(()=>this.#y(),
Bs)}#y(){clearTimeout(this.#l),this.#l=0,this.player.pause(),this.#g();let{selected:e}=this.#o,r=["pursuer","evader"].find(n=>!ae(this.#p,n,e[n]));this.#c.textContent=
r?`The page holds no genome of ${r}s ${e[r]}: it would be too large. Choose a generation of ${this.#p.teams[r].kept.join(", ")}.`:"",!(r||!this.#u)&&(this.#a=L(
this.#u,this.#p,e),this.#d=Le(this.#a),this.#i.show(this.#u,this.#p,this.#a),this.inspector.show(this.#u,this.#p,this.#a,e),this.player.length=this.#a.length,this.
player.jump(this.#m),this.#m=0,this.#v(),this.element.dataset.played=`${e.run} ${e.pursuer} ${e.evader} ${e.episode} ${e.seed??""}`,this.#f())}#g(){let{pursuer:e,
evader:r,episode:n,seed:s}=this.#o.selected,{teams:o,payoff:a}=this.#p,i=(c,d)=>o[c].script??`${c}s ${d}`,l=s===null?n<a.episodes?`episode ${n+1} of ${a.episodes}`:
`episode ${n+1}, not part of the cell`:`seed ${s}`;this.#r.replaceChildren(u("span",{class:"pursuer"},i("pursuer",e))," against ",u("span",{class:"evader"},i("e\
vader",r)),u("span",{class:"muted small"},l))}#v(){let e=this.#a;if(!e||!this.#d)return;let r=this.player.step,n=this.#d.moments[r];this.#w(Array.from(n.everCaptured).
filter(Boolean).length,r),this.#s.replaceChildren(...Jr(e,this.#d,r).map(s=>u("li",{class:s.kind,"data-agents":s.agents.join(" ")},s.text))),this.inspector.at(r),
this.#S()}#w(e,r){this.#t.replaceChildren(u("strong",{},e),` of ${this.#p.world.n_evaders} captured`,u("span",{class:"muted"},` · step ${r}`))}#x(e){this.#e.look=
{selected:e,viewers:e===null?[]:[e]},this.#S()}#S(){let e=this.inspector.agent;for(let r of this.#s.children){let n=r.dataset.agents?.split(" ")??[];r.classList.
toggle("about",e!==null&&n.includes(String(e)))}}};var T={left:52,bottom:46,top:76,right:84},O=10,Fs=160,be=T.right-O-14,W=T.top-O-14,We=class{element;#e;#n;#o=u("canvas",{"aria-hidden":"true"});#i=y("svg",{"ari\
a-hidden":"true"});#r=y("g");#t;#s=u("h2");#c=u("strong",{class:"rate numbers"});#u=u("span",{class:"small muted"});#a=u("p",{class:"small muted numbers"});#d=null;constructor(e,r){
[this.#n,this.#e]=[e,r],this.#t=u("div",{class:"matrix",id:"matrix",tabindex:0,role:"application","aria-label":"Payoff matrix. Arrow keys choose a match, Enter \
plays it."},this.#o,this.#i);let n=u("header",{class:"readout","aria-live":"polite"},u("div",{},this.#s,this.#a),u("div",{class:"of-cell"},this.#c,this.#u));this.
element=u("section",{class:"card matrix-card","aria-label":"Payoff matrix"},n,this.#t,Ws()),this.#b(),new ResizeObserver(()=>this.#h()).observe(this.#t),this.#t.
addEventListener("pointermove",s=>this.#v(s)),this.#t.addEventListener("pointerleave",()=>r.point({})),this.#t.addEventListener("click",s=>this.#w(s)),this.#t.addEventListener(
"mousedown",s=>s.preventDefault()),this.#t.addEventListener("keydown",s=>this.#x(s)),r.on("run",()=>this.#h()),r.on("match",()=>this.#f()),r.on("hover",()=>this.#f())}get#l(){
return this.#n[this.#e.selected.run]}#h(){let[e,r]=this.#l.payoff.shape,{clientWidth:n,clientHeight:s}=this.#t;if(n<50)return;let a=Math.max(Fs,Math.min(n-T.left-
T.right,s-T.top-T.bottom))/Math.max(e,r),i=Math.max(T.left,(n-r*a-T.right+T.left)/2),l=T.top+Math.max(0,(s-T.top-T.bottom-e*a)/2),c={width:n,height:s,left:i,top:l,
cell:a,rows:e,columns:r};this.#d=c,Te(this.#o,this.#l.payoff,{left:i,top:l,width:r*a,height:e*a}),this.#i.setAttribute("viewBox",`0 0 ${n} ${s}`),this.#i.replaceChildren(
js(c),Gs(c),...this.#p(c),this.#r),this.#f()}#m(e){let r=this.#l.findings?.generalization;if(!r)return[];let{selected:n,hover:s}=this.#e,[o,a]=[s.pursuer??n.pursuer,
s.evader??n.evader],[i,l]=Qr(e,r.pursuers.mean[o]??0,o),[c,d]=en(e,r.evaders.mean[a]??0,a);return[y("circle",{class:"dot of-pursuers",cx:i,cy:l,r:5}),y("circle",
{class:"dot of-evaders",cx:c,cy:d,r:5})]}#p(e){let r=this.#l.findings?.generalization;if(!r)return[];let{left:n,top:s,cell:o,rows:a,columns:i}=e,[l,c]=[n+i*o+O,
s-O],d={class:"side"};return[y("rect",{...d,x:l,y:s,width:be,height:a*o}),y("rect",{...d,x:n,y:c-W,width:i*o,height:W}),...tn(r.pursuers,(m,p)=>Qr(e,m,p),"of-pu\
rsuers"),...tn(r.evaders,(m,p)=>en(e,m,p),"of-evaders"),y("text",{class:"tick",x:l,y:s+a*o+16,"text-anchor":"start"},"0"),y("text",{class:"tick",x:l+be,y:s+a*o+
16,"text-anchor":"end"},"1"),y("text",{class:"tick",x:n-6,y:c-4,"text-anchor":"end"},"0"),y("text",{class:"tick",x:n-6,y:c-W+8,"text-anchor":"end"},"1"),y("text",
{class:"label of-pursuers",x:l+be,y:s+a*o+34,"text-anchor":"end"},"captures"),y("text",{class:"label of-evaders",x:n+i*o+O,y:c-W+10,"text-anchor":"start"},"esca\
pes")]}#f(){let e=this.#d;if(!e)return;let{selected:r,hover:n}=this.#e,{left:s,top:o,cell:a,rows:i,columns:l}=e,c=g=>o+(i-1-g)*a,d=[],m=(g,h)=>y("rect",{class:h,
x:s,y:c(g),width:l*a+O+be,height:a}),p=(g,h)=>y("rect",{class:h,x:s+g*a,y:o-O-W,width:a,height:O+W+i*a});if(d.push(m(r.pursuer,"strip pursuer"),p(r.evader,"stri\
p evader")),n.pursuer!==null&&n.pursuer<i&&d.push(m(n.pursuer,"strip hover")),n.evader!==null&&n.evader<l&&d.push(p(n.evader,"strip hover")),n.lag!==null)for(let g=0;g<
l;g++){let h=g+n.lag;h>=0&&h<i&&d.push(y("rect",{class:"lagged",x:s+g*a,y:c(h),width:a,height:a}))}d.push(...this.#m(e));let f={x:s+r.evader*a,y:c(r.pursuer),width:a,
height:a};d.push(y("rect",{class:"chosen under",...f}),y("rect",{class:"chosen",...f})),this.#r.replaceChildren(...d),this.#b()}#b(){let{selected:e,hover:r}=this.#e,
n=r.pursuer??e.pursuer,s=r.evader??e.evader,o=oe(this.#l,n,s);this.#s.replaceChildren(u("span",{class:"pursuer"},`Pursuers ${n}`)," against ",u("span",{class:"e\
vader"},`evaders ${s}`)),this.#c.textContent=o?A(o.rate,3):"-",this.#u.textContent=o?`capture rate, mean of ${o.rates.length} episodes`:"the evaluation played n\
o episodes",this.#a.textContent=this.#y(n,s)}#y(e,r){let n=this.#l.findings?.generalization;if(!n)return"";let s=(o,a)=>De(o.mean[a]??0,o.low?.[a]??null,o.high?.[a]??
null);return`Against all: captures ${s(n.pursuers,e)}, escapes ${s(n.evaders,r)}`}#g(e){let r=this.#d;if(!r)return null;let n=this.#t.getBoundingClientRect(),s=Math.
floor((e.clientX-n.left-r.left)/r.cell),o=r.rows-1-Math.floor((e.clientY-n.top-r.top)/r.cell),[a,i]=[o>=0&&o<r.rows,s>=0&&s<r.columns];return a||i?{g:a?o:-1,h:i?
s:-1,inside:a&&i}:null}#v(e){let r=this.#g(e);this.#e.point(r?{pursuer:r.g<0?null:r.g,evader:r.h<0?null:r.h}:{})}#w(e){let r=this.#g(e);r&&(this.#e.select({...r.
g<0?{}:{pursuer:r.g},...r.h<0?{}:{evader:r.h}}),r.inside&&this.#t.dispatchEvent(new CustomEvent("play",{bubbles:!0})))}#x(e){let n={ArrowUp:[1,0],ArrowDown:[-1,
0],ArrowRight:[0,1],ArrowLeft:[0,-1]}[e.key];if(e.key==="Enter")this.#t.dispatchEvent(new CustomEvent("play",{bubbles:!0}));else if(n){let s=e.shiftKey?5:1,[o,a]=this.#l.
payoff.shape,{pursuer:i,evader:l}=this.#e.selected;this.#e.select({pursuer:Zr(i+s*n[0],o),evader:Zr(l+s*n[1],a)})}else return;e.preventDefault(),e.stopPropagation()}};
function Ws(){let t=u("span",{class:"gradient"});return t.style.backgroundImage=er(),u("p",{class:"scale-of-rates small muted"},"0 all escape",t,"1 all caught")}
var Zr=(t,e)=>Math.min(e-1,Math.max(0,t));function js({left:t,top:e,cell:r,rows:n,columns:s}){let o=y("g",{class:"axes"}),a=e+n*r,i=l=>pe(0,l-1,Math.min(l,l*r/44),
!0);for(let l of i(s))o.append(y("text",{class:"tick",x:t+(l+.5)*r,y:a+16,"text-anchor":"middle"},l));for(let l of i(n))o.append(y("text",{class:"tick",x:t-7,y:a-
(l+.5)*r,"text-anchor":"end","dominant-baseline":"middle"},l));return o.append(y("text",{class:"label of-evaders",x:t+s*r/2,y:a+36,"text-anchor":"middle"},"evad\
er generation"),y("text",{class:"label of-pursuers",transform:`translate(${t-36} ${e+n*r/2}) rotate(-90)`,"text-anchor":"middle"},"pursuer generation")),o}function Gs({
left:t,top:e,cell:r,rows:n,columns:s}){let o=y("g",{class:"diagonal"}),a=Math.min(n,s);if(a<3)return o;let i=e+n*r;for(let l of["H","V"]){let c=`M${t} ${i}`;for(let d=1;d<=
a;d++){let[m,p]=[`H${t+d*r}`,`V${i-d*r}`];c+=l==="H"?m+p:p+m}o.append(y("path",{d:c,class:"under"}),y("path",{d:c}))}return o}var Qr=({left:t,top:e,cell:r,rows:n,
columns:s},o,a)=>[t+s*r+O+o*be,e+(n-a-.5)*r],en=({left:t,top:e,cell:r},n,s)=>[t+(s+.5)*r,e-O-n*W];function tn(t,e,r){let n=o=>o.map((a,i)=>e(a??0,i).map(l=>l.toFixed(
1)).join(" ")),s=[];return t.low&&t.high&&s.push(y("path",{class:`band ${r}`,d:`M${[...n(t.high),...n(t.low).reverse()].join("L")}Z`})),s.push(y("path",{class:`\
line ${r}`,d:`M${n(t.mean).join("L")}`})),s}function rn(t,e,r){let{findings:n}=t;if(!n)return null;let s=u("dialog",{class:"four","aria-label":"Four matches"}),o=i=>{let l=r();l&&Vs(s,t,i,e,l)},a=n.checkerboards.
map(i=>zs(t,i,o));return{element:E("Checkerboards","Two generations of each team: each pursuers are better against one of the evaders. Click one: its four match\
es side by side.",a.length?u("div",{class:"boards"},...a):u("p",{},`No four cells differ by more than ${n.margin} in this way.`),a.length?u("p",{class:"small mu\
ted"},"The strongest of all pairs, so noise makes them look stronger than they are. The diagnosis says whether there are more than noise makes."):null,s)}}var nn=({
pursuers:[t,e],evaders:[r,n]})=>[[t,r],[t,n],[e,r],[e,n]];function zs(t,e,r){let[n,s]=e.pursuers,[o,a]=e.evaders,i=nn(e).map(([l,c])=>{let d=t.payoff.capture_rate[l][c],
m=u("span",{class:d>.55?"cell light":"cell"},A(d));return m.style.backgroundColor=Qt(d),m});return u("button",{type:"button",class:"miniature numbers",onclick:()=>r(
e),"aria-label":`Pursuers ${n} and ${s}, evaders ${o} and ${a}: four matches`},u("span",{}),u("span",{class:"evader"},o),u("span",{class:"evader"},a),u("span",{
class:"pursuer"},n),i[0],i[1],u("span",{class:"pursuer"},s),i[2],i[3])}function Vs(t,e,r,n,s){let o=nn(r).filter(([p,f])=>ae(e,"pursuer",p)&&ae(e,"evader",f)),a=o.
map(([p,f])=>L(s,e,{run:n.selected.run,pursuer:p,evader:f,episode:0,seed:null})),i=new X(Math.max(0,...a.map(p=>p.length)),{speed:16,still:Q()}),l=a.map((p,f)=>{
let[g,h]=o[f],b=u("canvas",{"aria-label":`Pursuers ${g} against evaders ${h}`}),w=u("span",{class:"numbers"}),S=()=>{t.close(),n.select({pursuer:g,evader:h})};return{
element:u("figure",{},u("figcaption",{},u("span",{},u("span",{class:"pursuer"},g)," against ",u("span",{class:"evader"},h),u("span",{class:"muted small"},` cell\
 ${A(e.payoff.capture_rate[g][h])}`)),w,u("button",{type:"button",class:"small",title:"Show this match alone",onclick:S},"open")),b),match:p,recording:Le(p),board:new Z(
b,{numbers:!1}),tally:w}}),c=()=>l.forEach(p=>p.board.show(p.recording,i.time)),d=()=>l.forEach(({recording:p,match:f,tally:g})=>{let h=p.moments[Math.min(i.step,
f.length)];g.textContent=`${Array.from(h.everCaptured).filter(Boolean).length} of ${f.config.n_evaders}`});i.addEventListener("frame",c),i.addEventListener("ste\
p",d),t.replaceChildren(u("header",{},u("h2",{},"Four matches of a checkerboard"),u("button",{type:"button",onclick:()=>t.close()},"Close")),u("div",{class:"gri\
d-of-four"},...l.map(p=>p.element)),Ue(i));let m=p=>{!(p.target instanceof HTMLSelectElement||p.target instanceof HTMLButtonElement&&p.key===" ")&&!p.defaultPrevented&&
q(i,p)&&p.preventDefault()};t.addEventListener("keydown",m),t.addEventListener("close",()=>{t.removeEventListener("keydown",m),i.pause(),l.forEach(p=>p.board.close()),
t.replaceChildren()},{once:!0}),t.showModal(),c(),d(),Q()||i.play()}var je={pursuer:"evader",evader:"pursuer"};function sn(t,e){let r=t.findings?.ciao;if(!r)return null;let n=["pursuer","evader"].map(s=>{let{fading:o,stripes:a,period:i}=r[`${s}\
s`],l=`fading ${A(o)}, stripes ${A(a)}${i===null?"":` every ${i} generations`}`;return Ks(t,s,l,e)});return{element:E("CIAO","Current individuals against ancest\
ral opponents, by the team's own score. Stripes that come back: cycling. Darker away from the diagonal: forgetting.",u("div",{class:"triangles"},...n.map(s=>s.element))),
update:()=>n.forEach(s=>s.update())}}function Ks(t,e,r,n){let s=e==="pursuer"?0:1,[o,a]=[t.payoff.shape[s],t.payoff.shape[1-s]],i=(v,x)=>e==="pursuer"?t.payoff.
capture_rate[v][x]:1-t.payoff.capture_rate[x][v],l=u("canvas",{width:a,height:o,role:"img","aria-label":`CIAO of the ${e}s: ${r}`}),c=l.getContext("2d"),d=c?.createImageData(
a,o);for(let v=0;d&&v<o;v++)for(let x=0;x<=Math.min(v,a-1);x++)d.data.set([...ue(i(v,x)),255],4*((o-1-v)*a+x));d&&c?.putImageData(d,0,0);let m=y("rect",{class:"\
chosen",width:1,height:1}),p=y("rect",{class:"chosen under",width:1,height:1}),f=y("svg",{viewBox:`0 0 ${a} ${o}`,preserveAspectRatio:"none","aria-hidden":"true"},
p,m),g=u("div",{class:"triangle"},l,f);g.style.aspectRatio=`${a} / ${o}`;let h=v=>{let x=g.getBoundingClientRect(),C=Math.floor((v.clientX-x.left)/x.width*a),U=o-
1-Math.floor((v.clientY-x.top)/x.height*o);return C>=0&&U<o&&C<=U?[U,C]:null},b=v=>({[e]:v[0],[je[e]]:v[1]});g.addEventListener("pointermove",v=>n.point(h(v)?b(
h(v)):{})),g.addEventListener("pointerleave",()=>n.point({})),g.addEventListener("click",v=>h(v)&&n.select(b(h(v))));let w=()=>{let v=n.hover[e]??n.selected[e],
x=n.hover[je[e]]??n.selected[je[e]];for(let C of[m,p])C.setAttribute("x",String(x)),C.setAttribute("y",String(o-1-v)),C.style.display=x<=v?"":"none"};return{element:u(
"figure",{},u("figcaption",{class:"small"},u("span",{class:e},`${e}s`)),g,u("p",{class:"small muted"},`horizontal: ${je[e]} generation; vertical: ${e} generatio\
n`),u("p",{class:"small numbers"},r)),update:w}}var Ge={left:46,right:12,top:10,bottom:42},on={x:56,y:34};function ze(t,e,r,n){let[s,o]=[Ge.left,Ge.top],a=Math.max(s+40,t-Ge.right),i=Math.max(o+40,e-Ge.bottom),
l=(h,b,w)=>S=>b+(S-h.low)/(h.high-h.low||1)*(w-b),[c,d]=[l(r,s,a),l(n,i,o)],m=y("g"),p=y("svg",{width:t,height:e,viewBox:`0 0 ${t} ${e}`,class:"plot"}),f=y("g",
{class:"axes"});for(let h of pe(n.low,n.high,(i-o)/on.y,n.whole))f.append(y("line",{x1:s,x2:a,y1:d(h),y2:d(h),class:"grid"}),y("text",{x:s-8,y:d(h),"text-anchor":"\
end","dominant-baseline":"middle"},an(h)));for(let h of pe(r.low,r.high,(a-s)/on.x,r.whole))f.append(y("text",{x:c(h),y:i+16,"text-anchor":"middle"},an(h)));return f.
append(y("line",{x1:s,x2:a,y1:i,y2:i,class:"axis"}),y("text",{x:(s+a)/2,y:e-6,"text-anchor":"middle",class:"label"},r.label),y("text",{transform:`translate(12 ${(o+
i)/2}) rotate(-90)`,"text-anchor":"middle",class:"label"},n.label)),p.append(f,m),{root:p,marks:m,left:s,right:a,top:o,bottom:i,x:c,y:d,at:h=>{let b=h-p.getBoundingClientRect().
left;return r.low+(b-s)/(a-s)*(r.high-r.low)}}}var an=t=>String(Number(t.toPrecision(6))).replace("-","−");function ve(t,e,r,n){let s="",o="M";r.forEach((i,l)=>{
i===null?o="M":(s+=`${o}${t.x(e[l]).toFixed(1)} ${t.y(i).toFixed(1)}`,o="L")});let a=y("path",{d:s,class:`line ${n}`});return t.root.insertBefore(a,t.marks),a}function we(t,e,r,n=null){let s=t.x(e);t.marks.append(y("line",{x1:s,x2:s,y1:t.top,y2:t.bottom,class:`mark ${r}`})),n!==null&&t.marks.append(y("circle",{cx:s,cy:t.
y(n),r:5,class:`dot ${r}`}))}function vt(...t){return u("p",{class:"legend small"},...t.map(([e,r])=>u("span",{class:`key ${r}`},e)))}function Ve(t,e,r={}){let n=u(
"div",{class:"chart",role:"img","aria-label":t}),s=null,o=()=>{s?.marks.replaceChildren(),s&&r.marks?.(s)},a=()=>{let{clientWidth:i,clientHeight:l}=n;i<50||l<50||
(s=e(i,l),n.replaceChildren(s.root),o())};return n.addEventListener("pointermove",i=>r.point?.(s?.at(i.clientX)??null)),n.addEventListener("pointerleave",()=>r.
point?.(null)),r.choose&&(n.classList.add("chooses"),n.addEventListener("click",i=>s&&r.choose?.(s.at(i.clientX),s,i))),new ResizeObserver(a).observe(n),{element:n,
redraw:a,remark:o}}var wt=["of-pursuers","of-evaders","of-both"],Xs=2500,ln={low:0,high:1,label:"capture rate"};function cn(t,e){let{training:r}=t,{capture_rate:n,generation:s,learner:o,
epochs:a}=r,i=n.map((g,h)=>(h+1)*a),l=qs(n,r.window),c=i.at(-1)??1,d=i.length>Xs?"dense":"",m=(g,h)=>{let b=s.flatMap((w,S)=>w===g&&(o[S]===h||o[S]===2)?[S]:[]);
return b.length?[i[b[0]],i[b.at(-1)]]:null},p=Ve(`Capture rate in ${c} epochs of training`,(g,h)=>{let b=ze(g,h,{low:0,high:c,label:"epoch",whole:!0},ln);for(let[
w,S]of[["raw",n],[d,l]])for(let[v,x]of wt.entries()){let C=S.map((U,St)=>o[St]===v||o[St+1]===v?U:null);C.some(U=>U!==null)&&ve(b,i,C,`${x} ${w}`)}return b},{marks:g=>{
let{pursuer:h,evader:b}=e.selected;for(let[w,S]of[[0,h],[1,b]]){let v=m(e.hover[w?"evader":"pursuer"]??S,w);v&&we(g,(v[0]+v[1])/2,wt[w])}},choose:g=>{let h=Math.
min(i.length-1,Math.max(0,Math.round(g/a)-1)),b=s[h];o[h]!==1&&e.select({pursuer:Math.min(b,t.payoff.shape[0]-1)}),o[h]!==0&&e.select({evader:Math.min(b,t.payoff.
shape[1]-1)})}}),f=[...new Set(o)].sort().map(g=>[["pursuers learn","evaders learn","both teams learn"][g],wt[g]]);return{element:E("Training",`${Ur(r.matches)}\
 training matches. Lines: the generations that are selected.`,vt(...f),p.element),update:p.remark}}function un(t,e){let r=t.findings?.lags;if(!r)return null;let[
n,s]=[r.lags[0],r.lags.at(-1)],o=Math.min(5,(Math.max(...r.cells)+1)/2),a=r.means.map((l,c)=>r.cells[c]>=o?l:null),i=Ve("Lag profile",(l,c)=>{let d=ze(l,c,{low:n,
high:s,label:"lag: pursuer minus evader generation",whole:!0},ln);return ve(d,r.lags,r.means,"raw ink"),ve(d,r.lags,a,"ink"),d},{marks:l=>{let{pursuer:c,evader:d}=e.
selected;we(l,0,"zero");let m=e.hover.lag??c-d;we(l,m,"ink",r.means[m-n])},point:l=>{let c=l===null?null:Math.round(l);e.point({lag:c!==null&&c>=n&&c<=s?c:null})}});
return{element:E("Lag profile","Left: evaders are later. Right: pursuers are later. It rises if both teams keep what they learn. Faint: fewer than 5 cells.",i.element),
update:i.remark}}function dn(t,e){let r=t.findings?.ratings;if(!r)return null;let n={pursuer:r.pursuers,evader:r.evaders},s=[...r.pursuers,...r.evaders].map(d=>d??
0),[o,a]=[Math.min(...s),Math.max(...s)],i=.06*(a-o||1),l=Math.max(...t.payoff.shape)-1,c=Ve("Elo ratings by generation",(d,m)=>{let p=ze(d,m,{low:0,high:l,label:"\
generation",whole:!0},{low:o-i,high:a+i,label:"Elo points"});for(let f of["pursuer","evader"])ve(p,n[f].map((g,h)=>h),n[f],`of-${f}s`);return p},{marks:d=>{for(let m of[
"pursuer","evader"]){let p=e.hover[m]??e.selected[m];we(d,p,`of-${m}s`,n[m][p]??null)}},choose:(d,m,p)=>{let f=Math.round(d),g=p.clientY-m.root.getBoundingClientRect().
top,h=w=>Math.abs(m.y(n[w][f]??1/0)-g),b=h("pursuer")<=h("evader")?"pursuer":"evader";f>=0&&f<n[b].length&&e.select({[b]:f})}});return{element:E("Ratings",`One \
number for each generation, which cycles do not fit. The game itself: ${A(r.offset,0)} points for the pursuers.`,vt(["pursuers","of-pursuers"],["evaders","of-ev\
aders"]),c.element),update:c.remark}}function qs(t,e){let r=[0];for(let n of t)r.push(r.at(-1)+n);return t.map((n,s)=>{let[o,a]=[Math.max(0,s-Math.floor((e-1)/2)),
Math.min(t.length,s+Math.floor(e/2)+1)];return(r[a]-r[o])/(a-o)})}var Ys={present:"●",absent:"○","cannot tell":"?"};function mn(t){let{findings:e}=t;if(!e)return null;let[,...r]=e.table,n=new Map(e.reasons.map(a=>{let[i,,l]=Js(
a);return[i,l]})),s=r.map(([a,i,l,c])=>{let d=c===e.window?n.get(a):void 0;return u("li",{class:`finding ${i.replace(" ","-")}`},u("span",{class:"sign","aria-hi\
dden":"true"},Ys[i]??""),u("div",{},u("p",{},u("strong",{},a),` ${i}`,u("span",{class:"muted"},` · ${c}`)),d?u("p",{class:"small"},`${d}.`):null,u("p",{class:"\
small muted numbers"},l)))}),o=E("What happened","Each condition is present, absent, or its 95 % interval cannot tell. The intervals are about this run.",u("p",
{class:"headline"},e.headline),u("ul",{class:"findings"},...s),t.limits?u("p",{class:"small"},t.limits):null,u("details",{class:"small"},u("summary",{},"Headlin\
e numbers in words"),...e.description.map(a=>u("p",{},a)),Qs(e)));return o.classList.add("diagnosis"),{element:o}}function Js(t){let[e="",r=""]=t.split(/: (.*)/s),
[n="",s=""]=r.split(/, because (.*)/s);return[e.toLowerCase(),n,Zs(s.replace(/\.$/,""))]}var Zs=t=>t.charAt(0).toUpperCase()+t.slice(1);function Qs({noise:t}){return t.
transitive_share_noise===null?null:u("p",{},`Last half: transitive share ${A(t.transitive_share)} (an order of strength with the same noise rarely falls below ${A(
t.transitive_share_noise)}), checkerboards ${ft(t.checkerboard_share)} (it rarely exceeds ${ft(t.checkerboard_share_noise)}).`)}function pn(t){let e=[t.held_out?.pursuers,t.held_out?.evaders].filter(r=>r!=null);return e.length?{element:E("Held-out opponents",`The last generations against\
 opponents that no run has met; 95 % intervals over ${e[0].episodes} episodes.`,...e.map(eo))}:null}function eo(t){let e=n=>n.at(-1),r=[["mean",e(t.mean)],...Object.
entries(t.against).map(([n,s])=>[n,e(s)])];return u("table",{class:"scores numbers"},u("caption",{},u("span",{class:t.team},`${t.team}s`),` of generation ${t.generations.
at(-1)}, ${t.score}`),...r.map(([n,s],o)=>u("tr",{class:o?"":"mean"},u("th",{scope:"row"},n),u("td",{class:"range"},to(s,t.team)),u("td",{},De(s.value,s.low,s.high)))))}
function to({value:t,low:e,high:r},n){let s=u("span",{class:`between ${n}`});s.style.left=`${100*(e??t)}%`,s.style.width=`${100*((r??t)-(e??t))}%`;let o=u("span",
{class:`value ${n}`});return o.style.left=`${100*t}%`,u("span",{class:"scale","aria-hidden":"true"},s,o)}function fn(t){let e=t.settings.filter(s=>s.changed),r=t.settings.filter(s=>!s.changed),n=E("Settings",`${t.schedule}, seed ${t.seed}. Every setting is an optio\
n of matrixworld evolve.`,e.length?hn(e,"other than the default"):u("p",{class:"small"},"All settings are the defaults."),u("details",{class:"small"},u("summary",
{},`${r.length} settings with their defaults`),hn(r,"defaults")));return n.classList.add("settings"),{element:n}}function hn(t,e){return u("div",{class:"wide-ta\
ble"},u("table",{class:"small"},u("caption",{class:"heard"},`Settings: ${e}`),...t.map(({name:r,value:n,help:s})=>u("tr",{},u("th",{scope:"row"},`--${r.replaceAll(
"_","-")}`),u("td",{class:"numbers"},n),u("td",{class:"muted"},s)))))}function E(t,e,...r){return u("section",{class:"card panel","aria-label":t},u("header",{},u("h2",{},t),u("p",{class:"small muted"},e)),...r)}function gn(t,e,r){
let n=new Map,s=u("div",{class:"panels"}),o=[],a=()=>o.forEach(l=>l.update?.()),i=()=>{let l=t[e.selected.run];o=n.get(l)??ro(l,e,r),n.set(l,o),s.replaceChildren(
...o.map(c=>c.element)),a()};return e.on("run",i),e.on("match",a),e.on("hover",a),i(),s}function ro(t,e,r){return[mn(t),cn(t,e),rn(t,e,r),un(t,e),dn(t,e),sn(t,e),
pn(t),fn(t)].filter(s=>s!==null)}var yn={pursuer:null,evader:null,lag:null},Ke=class extends EventTarget{#e;#n=yn;constructor(e){super(),this.#e=e}get selected(){return this.#e}get hover(){return this.#n}select(e){
let r=this.#e,n=["run","pursuer","evader"].some(s=>s in e&&e[s]!==r[s]);this.#e={...r,...n?{episode:0,seed:null}:{},...e},this.#e.run!==r.run&&this.dispatchEvent(
new Event("run")),this.dispatchEvent(new Event("match"))}point(e){let r={...yn,...e};r.pursuer===this.#n.pursuer&&r.evader===this.#n.evader&&r.lag===this.#n.lag||
(this.#n=r,this.dispatchEvent(new Event("hover")))}on(e,r){this.addEventListener(e,r)}};var j=Zt(),{runs:P}=j,[no,so]=P[0].payoff.shape,oo=ot(location.hash,P,{run:0,pursuer:no-1,evader:so-1,episode:0,seed:null}),{step:ao,...io}=oo,I=new Ke(io),$=new Fe(
P,I,j.playground),bn=new We(P,I),xt=rr(),Xe=null;document.getElementById("page").replaceWith(u("header",{class:"top"},u("h1",{},j.title),u("p",{class:"muted sma\
ll about"},`matrixworld ${j.version}`),u("div",{class:"tools"},qt(),u("button",{type:"button",title:"Keys (?)","aria-label":"Keys",onclick:()=>xt.showModal()},"\
?"))),...j.note?[u("p",{class:"note small muted"},j.note)]:[],tr(P,I),u("main",{class:"stages"},bn.element,$.element),gn(P,I,()=>Xe),xt);Object.assign(window,{matrixworldExplorer:{
get match(){return $.match},get step(){return $.player.step},play:t=>Xe&&L(Xe,P[I.selected.run],{...I.selected,episode:t}),get shape(){return P[I.selected.run].
payoff.shape}}});bn.element.addEventListener("play",()=>$.playSoon());$.goTo(ao);Yt(P,I,$);nr(P,I,$,xt,()=>bt($.shown,j.playground));requestAnimationFrame(()=>setTimeout(
()=>{Kt().then(t=>{Xe=t,$.start(t),document.body.dataset.ready="true"},t=>{$.element.prepend(u("p",{class:"problem",role:"alert"},`The engine does not start her\
e: ${String(t)}`)),document.body.dataset.ready="true"})}));})();
