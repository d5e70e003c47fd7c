/* built from web/ by "npm run build"; sources f53b286b83d8089a95541ed96e1d57e3387cb0890f57982973e8c1a6f1ec0274 */
"use strict";(()=>{var Mt={SIMULTANEOUS:0,SWARM_TURNS:1,AGENT_TURNS:2},ee={DISAPPEAR:0,REACH:1,BOUNCE:2},Et={OCCUPATION:0,SURROUND:1},At={FAULT:0,INVOLVED:1};var Ct=["obstacle","teammate","adversary"],Ye=["vertex","edge","chain"],Tt=["turn","kind","form","first","second","row","col","at_fault","held","doomed"],Xe=["p\
ursuer_{number}","evader_{number}"],_t={obstacle:"{first} ran into the obstacle or border at {cell}",vertex:"{first} and {second} both headed for {cell}",edge:"\
{first} and {second} meant to swap, {first} to {cell}",chain:"{first} headed for {cell}, where {second} had to stay"},te={"both held":"both bounce","both doomed":"\
both disappear",held:"{agent} bounces",doomed:"{agent} disappears",none:"nobody is stopped"},Rt="{event}: {outcome}",Je={random:"any action, all equally likely",
still:"always stays",chaser:"moves to where the nearest adversary in view is nearest",fleer:"moves to where the nearest adversary in view is farthest","clumsy-c\
haser":"a chaser that takes any action in half of the steps",hunter:"a chaser of the nearest adversary in view to which no teammate in view is nearer",surrounder:"\
a chaser of the nearest free cell beside an adversary without a teammate","clumsy-fleer":"a fleer that takes any action in half of the steps",dodger:"moves to w\
here all adversaries in view together are farthest"},kt={free:".GS",blocked:"#@OTW"};var G=1+Tt.length;function ne(e,t){return e.replace(/\{(\w+)\}/g,(n,r)=>String(t[r]))}function Ze(e,t){return e<t?ne(Xe[0],{number:e}):ne(Xe[1],{number:e-t})}function xr(e,t){
let[n,r,o,s,a,i,l,...c]=Array.from(e),u=a<0?[s]:[s,a],[m,p,f]=c.map(w=>u.filter((S,v)=>w>>v&1)),g=u.map(w=>Ze(w,t)),h=ne(_t[a<0?"obstacle":Ye[o]],{first:g[0],second:g[g.
length-1],cell:`(${i}, ${l})`}),b=ne(Rt,{event:h,outcome:Sr(u.length,p,f,t)});return{kind:Ct[r],form:Ye[o],agents:u,cell:[i,l],at_fault:m,held:p,doomed:f,turn:n,
text:b}}function Sr(e,t,n,r){if(e===2&&t.length===2)return te["both held"];if(e===2&&n.length===2)return te["both doomed"];let o=s=>a=>ne(te[s],{agent:Ze(a,r)});
return[...t.map(o("held")),...n.map(o("doomed"))].join(", ")||te.none}function xe(e,t){let n=[];for(let r=0;r<e.length;r+=G)n.push(xr(e.subarray(r+1,r+G),t));return n}var D=class extends Error{name="EngineError"};function M(e,t,n){let r=typeof n=="string"?`'${n}'`:typeof n=="object"?JSON.stringify(n):String(n);return new D(`${e}\
: expected ${t}, got ${r}`)}var z=class{bytes;constructor(t){this.bytes=t}},Ot=0,et=[Uint8Array,Uint8Array,Int32Array,BigInt64Array,BigUint64Array,Float32Array,Float64Array],$t=4,Pt=4,Mr=new TextEncoder,
Er=new TextDecoder;function Ar(e){for(let t=et.length-1;t>Ot;--t)if(e instanceof et[t])return t;throw new TypeError("array: expected a typed array of the engine\
's numbers, got another")}function Qe(e){return new Uint8Array(e.buffer,e.byteOffset,e.byteLength)}function Cr(e){return Mr.encode(`${e}\0`)}var tt=class{engine;addresses=[];constructor(t){
this.engine=t}copy(t){let n=this.engine._malloc(Math.max(t.length,1));if(n===0)throw new D("memory: expected room for the arguments, got none");return this.addresses.
push(n),this.engine.HEAPU8.set(t,n),n}text(t){return this.copy(Cr(t))}arrays(t){let n=Object.entries(t),r=n.flatMap(([s,a])=>{let i=a instanceof z,l=i?a.bytes:a;
return[this.text(s),i?Ot:Ar(l),l.length,this.copy(Qe(l))]}),o=this.copy(Qe(Int32Array.from(r)));return this.copy(Qe(Int32Array.of(n.length,o)))}free(){for(let t of this.
addresses)this.engine._free(t)}};function Lt(e,t){let n=e.HEAPU8;return Er.decode(n.subarray(t,n.indexOf(0,t)))}function Se(e){let t=new Int32Array(e.HEAPU8.buffer),
n=e._last_outputs()/$t,r=t[n+1]/$t,o={};for(let s=r;s<r+t[n]*Pt;s+=Pt){let a=et[t[s+1]],i=t[s+2]*a.BYTES_PER_ELEMENT,l=t[s+3];o[Lt(e,t[s])]=new a(e.HEAPU8.slice(
l,l+i).buffer)}return o}function re(e,t){let n=new tt(e);try{let r=t(n);if(r===0)throw new D(Lt(e,e._last_error()));return r}finally{n.free()}}var Tr=2**31-1,_r=2n**64n-1n,Rr=34028234663852886e22;function L(e,t){if(typeof t!="number"||!Number.isInteger(t)||Math.abs(t)>Tr)throw M(e,"an integer",t);return Int32Array.
of(t)}function Me(e,t){if(typeof t!="boolean")throw M(e,"true or false",t);return new z(Uint8Array.of(Number(t)))}function F(e,t,n){let r=typeof t=="string"&&Object.
hasOwn(n,t)?n[t]:void 0;if(r===void 0)throw M(e,`one of ${Object.keys(n).join(", ")}`,t);return Int32Array.of(r)}function nt(e,t){if(typeof t!="number"||!(Math.
abs(t)<=Rr))throw M(e,"a finite number",t);return t}function V(e,t){let r=typeof t=="bigint"||typeof t=="number"&&Number.isSafeInteger(t)?BigInt(t):-1n;if(r<0n||
r>_r)throw M(e,"an integer from 0 to 2^64 - 1",t);return BigUint64Array.of(r)}function kr(e){return{"rules.interaction":F("interaction",e.interaction,Mt),"rules\
.obstacle":F("obstacle",e.obstacle,ee),"rules.teammate":F("teammate",e.teammate,ee),"rules.evader":F("evader",e.evader,ee),"rules.pursuer":F("pursuer",e.pursuer,
ee),"rules.capture":F("capture",e.capture,Et),"rules.captured_disappear":Me("captured_disappear",e.captured_disappear)}}function Nt(e,t){let n=typeof t=="number"?
[t,t,t]:t;if(!Array.isArray(n)||n.length!==3)throw M(e,"1 or 3 numbers",t);return Float32Array.from(n,r=>nt(e,r))}function $r(e){let t=(n,r)=>Float32Array.of(nt(
n,e[n]),nt(r,e[r]));return{"rewards.capture":t("pursuer_capture","evader_capture"),"rewards.neighbor":t("pursuer_neighbor","evader_neighbor"),"rewards.step":t("\
pursuer_step","evader_step"),"rewards.pursuer_collide":Nt("pursuer_collide",e.pursuer_collide),"rewards.evader_collide":Nt("evader_collide",e.evader_collide),"r\
ewards.blame":F("blame",e.blame,At),"rewards.capture_repeats":Me("capture_repeats",e.capture_repeats)}}function Ut(e){if(e===void 0||typeof e=="number")return new Uint8Array(
0);if(e instanceof Uint8Array)return e;let{free:t,blocked:n}=kt;for(let[r,o]of e.entries()){if(o.length!==e[0]?.length)throw M(`map, row ${r}`,`${e[0]?.length} \
cells as in row 0`,o.length);let s=[...o].find(a=>!t.includes(a)&&!n.includes(a));if(s)throw M(`map, row ${r}`,`'${t}' (free) or '${n}' (obstacle)`,s)}return Uint8Array.
from([...e.join("")],r=>Number(n.includes(r)))}function Dt(e,t){if(!Array.isArray(e))return;let n=[e.length,e[0]?.length??0];if(!(n[0]===t.rows&&n[1]===t.cols))
throw M("obstacle map",`shape (${t.rows}, ${t.cols}), the rows and cols`,n)}function Ee(e){Dt(e.obstacles,e);let t=typeof e.obstacles=="number"?e.obstacles:0;return{
...kr(e.rules),...$r(e.rewards),rows:L("rows",e.rows),cols:L("cols",e.cols),n_pursuers:L("n_pursuers",e.n_pursuers),n_evaders:L("n_evaders",e.n_evaders),fov:L("\
fov",e.fov),diagonal:Me("diagonal",e.diagonal),max_steps:L("max_steps",e.max_steps),density:Float64Array.of(t),map:Ut(e.obstacles)}}function It(e,t){return Int32Array.
from((t??[]).flat(),n=>L(e,n)[0])}function Ft(e,t){return Dt(e.obstacles,t),{seed:V("seed",e.seed??0n),episode:V("episode",e.episode??0),pursuers:It("pursuers",
e.pursuers),evaders:It("evaders",e.evaders),map:Ut(e.obstacles)}}function Ae(e){return{actions:Int32Array.from(e,t=>L("actions",t)[0])}}function K(e){if(typeof e==
"string"){if(!Object.hasOwn(Je,e))throw M("policy",`one of ${Object.keys(Je).join(", ")}`,e);return{script:new TextEncoder().encode(e)}}if(e.activation!=="relu"&&
e.activation!=="tanh")throw M("activation","'relu' or 'tanh'",e.activation);return{hidden:Int32Array.from(e.hidden,t=>L("hidden",t)[0]),activation:new TextEncoder().
encode(e.activation),sampled:Me("sampled",e.sampled),genome:e.genome}}var Pr=["first_turn","terminated","truncated"];function Ht(e){let t={...e};for(let n of Pr)
t[n]=new z(e[n]);return t}var Ce=class{config;seed;episode;n_agents;statistics;positions;last_positions;alive;captured;ever_captured;actions;rewards;involved;fault;map;conflict_table;first_conflict;constructor(t,n,r,o){
this.config=t,this.seed=n,this.episode=r,this.n_agents=t.n_pursuers+t.n_evaders,this.statistics=Bt(o,0),this.positions=o.positions,this.last_positions=o.last_positions,
this.alive=o.alive,this.captured=o.captured,this.ever_captured=o.ever_captured,this.actions=o.actions,this.rewards=o.rewards,this.involved=o.involved,this.fault=
o.fault,this.map=o.map,this.conflict_table=o.conflict_table,this.first_conflict=Or(this.conflict_table,this.length)}get length(){return this.actions.length/this.
n_agents}conflicts(t){this.check(t);let[n,r]=[this.first_conflict[t],this.first_conflict[t+1]],o=this.conflict_table.subarray(n*G,r*G);return xe(o,this.config.n_pursuers)}seek(t,n){
this.check(n),(!(t.seed===this.seed&&t.episode===BigInt(this.episode))||t.turn!==0||t.steps>n)&&t.reset({seed:this.seed,episode:this.episode});for(let o=t.steps;o<
n;++o)t.step(this.actions.subarray(o*this.n_agents,(o+1)*this.n_agents))}check(t){if(!(Number.isInteger(t)&&t>=0&&t<=this.length))throw M("step",`0 to ${this.length}`,
t)}};function Or(e,t){let n=new Int32Array(t+2);for(let r=0;r<e.length;r+=G)++n[e[r]+1];for(let r=1;r<n.length;++r)n[r]+=n[r-1];return n}function Bt(e,t){let n=e["\
statistics.length"].length,r=s=>{let a=e[`statistics.${s}`],i=a.length/n;return a.slice(t*i,(t+1)*i)},o=s=>Number(r(s)[0]);return{capture_rate:o("capture_rate"),
ever_capture_rate:o("ever_capture_rate"),captured_fraction:o("captured_fraction"),length:o("length"),return:r("return"),survivors:r("survivors"),overlap:r("over\
lap"),collisions:r("collisions"),faults:r("faults"),agent_steps:r("agent_steps")}}function Wt(e,t,n,r){let o=[Ee(n.config),K(n.pursuers),K(n.evaders),r];return re(
e,s=>{let[a,i,l,c]=o.map(u=>s.arrays(u));return e[t](a,i,l,c)}),Se(e)}function jt(e,t,n,r){let o={seed:V("seed",n),episode:V("episode",r)};return new Ce(t.config,
n,r,Wt(e,"_play_match",t,o))}function Gt(e,t,n,r){if(!Number.isInteger(r)||r<1)throw M("n_episodes","at least 1",r);let o={seed:V("seed",n),n_episodes:Int32Array.
of(r)},s=Wt(e,"_play_rollout",t,o);return Array.from({length:r},(a,i)=>Bt(s,i))}var zt=new FinalizationRegistry(([e,t])=>e._world_free(t)),oe=class{config;n_agents;n_actions;engine;at;freed=!1;constructor(t,n){this.engine=t,this.config=n,this.
n_agents=n.n_pursuers+n.n_evaders,this.n_actions=n.diagonal?9:5,this.at=re(t,r=>t._world_new(r.arrays(Ee(n)))),zt.register(this,[t,this.at],this)}free(){this.freed||
(this.freed=!0,zt.unregister(this),this.engine._world_free(this.at))}reset(t={}){let n=Ft(t,this.config);this.call(r=>this.engine._world_reset(this.at,r.arrays(
n)))}step(t){let n=Ae(t);this.call(r=>this.engine._world_step(this.at,r.arrays(n)))}playTurn(t){let n=Ae(t);this.call(r=>this.engine._world_play_turn(this.at,r.
arrays(n)))}decide(t,n,r){let{n_pursuers:o}=this.config,s=n==="pursuer"?[0,o]:[o,this.n_agents];return this.choose(t,s,r)}choose(t,[n,r],o){if(o.length!==this.n_agents)
throw M("actions",String(this.n_agents),o.length);let s=[K(t),Ae(o)],{actions:a}=this.call(i=>this.engine._world_decide(this.at,i.arrays(s[0]),n,r,i.arrays(s[1])));
return Uint8Array.from(a)}get n_turns(){return this.turnNumbers()[1]}get turn(){return this.turnNumbers()[0]}get actors(){let[,,t,n]=this.turnNumbers();return[t,
n]}turnNumbers(){return this.call(()=>this.engine._world_turn(this.at)).turn}get steps(){return this.read("steps")[0]}get seed(){return this.read("seed")[0]}get episode(){
return this.read("episode")[0]}get over(){return this.read("terminated")[0]===1||this.read("truncated")[0]===1}read(t){return this.call(n=>this.engine._world_read(
this.at,n.text(t)))[t]}view(t){let n=3*this.config.fov**2;return this.read("views").slice(t*n,(t+1)*n)}map(){return this.read("state").slice(2*this.config.rows*
this.config.cols)}conflicts(){let{conflict_table:t}=this.call(()=>this.engine._world_conflicts(this.at));return xe(t,this.config.n_pursuers)}answer(t,n){let r=K(
t),{logits:o}=this.call(i=>this.engine._world_logits(this.at,i.arrays(r),n)),s=o,a=this.choose(t,[n,n+1],new Uint8Array(this.n_agents))[n];return{logits:s,probabilities:Lr(
s),action:a}}snapshot(){return this.call(()=>this.engine._world_snapshot(this.at))}restore(t){let n=Ht(t);this.call(r=>this.engine._world_restore(this.at,r.arrays(
n)))}call(t){if(this.freed)throw M("world","one that is in use","one that was freed");return re(this.engine,t),Se(this.engine)}};function Lr(e){let t=Math.max(...e),
n=Array.from(e,o=>Math.exp(o-t)),r=n.reduce((o,s)=>o+s,0);return Float32Array.from(n,o=>o/r)}var rt=class{compiled;constructor(t){this.compiled=t}world(t){return new oe(this.compiled,t)}match(t,n,r,o,s=0){return jt(this.compiled,{config:t,pursuers:n,evaders:r},
o,s)}rollout(t,n,r,o,s){return Gt(this.compiled,{config:t,pursuers:n,evaders:r},o,s)}},Vt;function Kt(e=globalThis.matrixworldEngine){return Vt??=Nr(e),Vt}async function Nr(e){
if(!e)throw new Error("matrixworldEngine: expected the script engine.js before this one, got none");let t=Uint8Array.from(atob(e.binary),n=>n.charCodeAt(0));return new rt(
await e({wasmBinary:t}))}var Ir="http://www.w3.org/2000/svg";function d(e,t={},...n){return qt(document.createElement(e),t,n)}function y(e,t={},...n){return qt(document.createElementNS(
Ir,e),t,n)}function qt(e,t,n){for(let[r,o]of Object.entries(t))o==null||o===!1||(typeof o=="function"?e.addEventListener(r.slice(2),o):e.setAttribute(r,o===!0?"":
String(o)));return e.append(...n.filter(Ur).map(r=>typeof r=="number"?String(r):r)),e}function Ur(e){return e!=null&&e!==!1}var Dr=matchMedia("(prefers-color-scheme: dark)");function Fr(){let e=document.documentElement.dataset.theme;return e?e==="dark":Dr.matches}function ot(){document.
documentElement.dataset.theme=Fr()?"light":"dark"}function Yt(){return d("button",{type:"button",title:"Light or dark (D)","aria-label":"Light or dark",onclick:ot},"◐")}var Hr=2n**64n-1n;function st(e,t,n){let r=new URLSearchParams(e.replace(/^#/,"")),o=(c,u,m)=>{let p=r.get(c)??"";return/^\d{1,9}$/.test(p)&&Number(p)<u?Number(
p):m},s=o("run",t.length,n.run),[a,i]=t[s].payoff.shape,l=r.get("seed")??"";return{run:s,pursuer:o("pursuers",a,Math.min(n.pursuer,a-1)),evader:o("evaders",i,Math.
min(n.evader,i-1)),episode:o("episode",1/0,n.episode),seed:/^\d{1,20}$/.test(l)&&BigInt(l)<=Hr?l:null,step:o("step",1/0,0)}}function Xt(e,t,n){let r="",o=()=>{let{
run:s,pursuer:a,evader:i,episode:l,seed:c}=t.selected,u={run:s,pursuers:a,evaders:i,episode:l,...c===null?{}:{seed:c},step:n.player.step};r=`#${Object.entries(u).
map(([m,p])=>`${m}=${p}`).join("&")}`;try{history.replaceState(null,"",r)}catch{}};t.on("match",o),n.player.addEventListener("state",()=>n.player.playing||o()),
n.player.addEventListener("step",()=>n.player.playing||o()),window.addEventListener("hashchange",()=>{if(location.hash===r)return;let{step:s,...a}=st(location.hash,
e,t.selected);t.select(a),n.goTo(s)})}var Zt=["pursuer","evader"];function Qt(){return JSON.parse(Te("data"))}function se(e,t,n){let[r,o]=[t-e.payoff.first[0],n-e.payoff.first[1]],s=e.payoff.capture_rate[r]?.[o];
return s===void 0?null:{rate:s,rates:e.payoff.capture_rates[r][o],lengths:e.payoff.lengths[r][o]}}function ae(e,t,n){let{script:r,network:o,kept:s,genomes:a}=e.
teams[t];if(r!==null||o===null)return"";if(!s.includes(n))return`The page holds no genome of ${t}s ${n}: it would be too large. Choose a generation of ${s.join(
", ")}.`;let i=s.length*o.genome_size;return en(a).length===i?"":`The page is damaged: it does not hold the ${i} numbers of the ${t}s' genomes. Write it again f\
rom its run.`}function ie(e,t,n){let{script:r,network:o,kept:s,genomes:a}=e.teams[t];if(r!==null||o===null)return r??"random";let i=s.indexOf(n);if(i<0)throw new RangeError(
`${t}: expected a generation whose genome the page holds, got ${n}`);let l=o.genome_size,c=en(a).subarray(i*l,(i+1)*l);return{hidden:o.hidden,activation:o.activation,
sampled:o.sampled,genome:c}}var Jt=new Map;function en(e){let t=Jt.get(e);if(t)return t;let n=new Float32Array;try{let r=new Float32Array(at(e).buffer);r.every(
Number.isFinite)&&(n=r)}catch(r){if(!(r instanceof DOMException||r instanceof RangeError))throw r}return Jt.set(e,n),n}function at(e){let t=atob(Te(e)),n=new Uint8Array(
t.length);for(let r=0;r<n.length;r++)n[r]=t.charCodeAt(r);return n}function Te(e){return document.getElementById(e)?.textContent??""}var Br={now:()=>performance.now(),request:e=>requestAnimationFrame(e),cancel:e=>cancelAnimationFrame(e)},le=[.5,1,2,4,8,16,32,64],q=class extends EventTarget{#e;#r;#s;#a;#n=0;#t=0;#o=!1;#c=null;#d=0;glide=.28;constructor(t,n={}){
super(),this.#e=t,this.#r=n.speed??4,this.#a=n.still??!1,this.#s=n.clock??Br}get step(){return this.#n}get time(){return this.#a?this.#n:this.#t}get arrived(){return this.#t===
this.#n}get playing(){return this.#o}get length(){return this.#e}set length(t){this.#e=t,this.#n>t&&this.jump(t),this.#m("state")}get speed(){return this.#r}set speed(t){
this.#r=t,this.#m("state")}changeSpeed(t){let n=le.findIndex(r=>r>=this.#r);this.speed=le[Math.min(le.length-1,Math.max(0,n+t))]}play(){this.#o||!this.#e||(this.#n===
this.#e&&this.jump(0),this.#o=!0,this.#m("state"),this.#u())}pause(){this.#o&&(this.#o=!1,this.#m("state"))}toggle(){this.#o?this.pause():this.play()}move(t){this.
pause();let n=Math.min(this.#e,Math.max(0,this.#n+t));Math.abs(n-this.#t)>1?this.jump(n):this.#i(n),this.#u()}jump(t){this.#t=Math.min(this.#e,Math.max(0,Math.round(
t))),this.#i(this.#t),this.#m("frame")}#i(t){t!==this.#n&&(this.#n=t,this.#m("step"),this.#a&&this.#m("frame"))}#u(){this.#c===null&&(this.#d=this.#s.now(),this.#c=
this.#s.request(()=>this.#l()))}#l(){this.#c=null;let t=this.#s.now();this.#p(Math.min(.25,(t-this.#d)/1e3)),this.#d=t,(!this.#a||this.arrived)&&this.#m("frame"),
(this.#o||this.#t!==this.#n)&&(this.#c=this.#s.request(()=>this.#l()))}#p(t){let n=t;for(;n>0;){if(this.#t===this.#n){if(!this.#o)return;if(this.#n===this.#e)return this.
pause();this.#i(this.#n+1)}let r=this.#o?this.#r:1/this.glide,o=this.#n-this.#t,s=Math.min(Math.abs(o),n*r);n-=s/r,this.#t=s===Math.abs(o)?this.#n:this.#t+Math.
sign(o)*s}this.#o&&this.#t===this.#e&&this.pause()}#m(t){this.dispatchEvent(new Event(t))}};function Y(e,t){if(t.ctrlKey||t.metaKey||t.altKey)return!1;let n=t.shiftKey?
10:1,o={" ":()=>e.toggle(),ArrowRight:()=>e.move(n),ArrowLeft:()=>e.move(-n),Home:()=>e.move(-e.length),End:()=>e.move(e.length),"+":()=>e.changeSpeed(1),"-":()=>e.
changeSpeed(-1)}[t.key];return o?.(),o!==void 0}var ce=[[68,1,84],[72,26,108],[71,47,125],[65,68,135],[57,86,140],[49,104,142],[42,120,142],[35,136,142],[31,152,139],[34,168,132],[53,183,121],[84,197,104],[122,
209,81],[165,219,54],[210,226,27],[253,231,37]];function de(e){let t=Math.min(1,Math.max(0,e))*(ce.length-1),n=Math.min(ce.length-2,Math.floor(t)),[r,o]=[ce[n],
ce[n+1]],s=a=>Math.round(r[a]+(t-n)*(o[a]-r[a]));return[s(0),s(1),s(2)]}var tn=e=>`rgb(${de(e).join(" ")})`,nn=()=>`linear-gradient(to right, ${ce.map(e=>`rgb(${e.
join(" ")})`).join(", ")})`;function _e(e,t,n){let r=devicePixelRatio||1;e.style.left=`${n.left}px`,e.style.top=`${n.top}px`,e.style.width=`${n.width}px`,e.style.height=`${n.height}px`,e.width=
Math.round(n.width*r),e.height=Math.round(n.height*r);let o=e.getContext("2d"),s=Wr(t);!o||!s||(o.imageSmoothingEnabled=!1,o.drawImage(s,0,0,e.width,e.height))}
function Wr(e){let[t,n]=e.shape,r=document.createElement("canvas");[r.width,r.height]=[n,t];let o=r.getContext("2d");if(!o)return null;let s=o.createImageData(n,
t);return e.capture_rate.forEach((a,i)=>a.forEach((l,c)=>{let u=4*((t-1-i-e.first[0])*n+c+e.first[1]);s.data.set([...de(l),255],u)})),o.putImageData(s,0,0),r}var jr=84;function rn(e,t){let n=e.map((s,a)=>Gr(s,a,t)),r=d("nav",{class:"races",role:"tablist","aria-label":"Runs"},...n.map(s=>s.button)),o=()=>n.forEach((s,a)=>s.
update(a===t.selected.run));return t.on("match",o),t.on("hover",o),o(),r.hidden=e.length<2,r}function Gr(e,t,n){let[r,o]=e.payoff.shape,s=jr/Math.max(r,o),a=d("\
canvas",{"aria-hidden":"true"});_e(a,e.payoff,{left:0,top:0,width:o*s,height:r*s});let i=d("span",{class:"place"}),l=d("button",{type:"button",role:"tab",class:"\
race",title:`Key ${t+1}`,onclick:()=>it(e,t,n)},d("span",{class:"small-matrix"},a,i),d("span",{class:"race-text"},d("strong",{},e.name),d("span",{class:"small"},
e.findings?e.findings.headline:`${e.learning.join(" and ")}s against ${zr(e)}`),e.schedule===e.name?null:d("span",{class:"small muted"},`${e.schedule}, seed ${e.
seed}`)));return{button:l,update:u=>{l.ariaSelected=String(u);let m=n.hover.pursuer??n.selected.pursuer,p=n.hover.evader??n.selected.evader;i.hidden=m>=r||p>=o,
i.style.left=`${(p+.5)*s}px`,i.style.top=`${(r-m-.5)*s}px`}}}var zr=e=>e.teams.pursuer.script??e.teams.evader.script??"another run";function it(e,t,n){let[r,o]=e.
payoff.shape,{pursuer:s,evader:a}=n.selected;n.select({run:t,pursuer:Math.min(s,r-1),evader:Math.min(a,o-1)})}var Vr=[[["Space"],"play or pause"],[["←","→"],"step back or forward; with Shift ten steps"],[["Home","End"],"first or last step"],[["+","−"],"faster or s\
lower"],[["N"],"next episode of the same pair; with Shift the one before"],[["R"],"another seed, not one of the evaluation"],[["O"],"the cell's own seed again"],
[["P"],"next pursuer generation; with Shift the one before"],[["E"],"next evader generation; with Shift the one before"],[["M"],"to the matrix: arrow keys choos\
e a match, Enter plays it"],[["A"],"next agent: what it sees; with Shift the one before"],[["Esc"],"no agent"],[["G"],"this step in the playground: any other ru\
les, actions and places"],[["1","9"],"first to ninth run"],[["D"],"light or dark"],[["?"],"this list"]];function on(){let e=Vr.map(([n,r])=>d("div",{class:"key-\
row"},d("dt",{},...n.map(o=>d("kbd",{},o))),d("dd",{},r))),t=d("dialog",{class:"help","aria-labelledby":"help-title"},d("h2",{id:"help-title"},"Keys"),d("dl",{class:"\
keys"},...e),d("p",{class:"muted small"},"The page holds the genomes and the engine of this run. A click on a cell plays that very match: same seed, same moves.\
 Triangles pursue, discs evade; a ring is a captured evader, a star a capture, dashed cells are conflicts. The page loads nothing from elsewhere; share the file\
 as it is."),d("button",{type:"button",onclick:()=>t.close()},"Close"));return t.addEventListener("click",n=>n.target===t&&t.close()),t}function sn(e,t,n,r,o){let s=(i,l)=>()=>{
let c=e[t.selected.run].payoff.shape[i==="pursuer"?0:1];t.select({[i]:Math.min(c-1,Math.max(0,t.selected[i]+l))})},a={n:()=>t.select({episode:t.selected.episode+
1}),N:()=>t.select({episode:Math.max(0,t.selected.episode-1)}),r:()=>t.select({seed:String(crypto.getRandomValues(new BigUint64Array(1))[0]),episode:0}),o:()=>t.
select({seed:null,episode:0}),p:s("pursuer",1),P:s("pursuer",-1),e:s("evader",1),E:s("evader",-1),m:()=>document.getElementById("matrix")?.focus(),a:()=>n.inspector.
next(1),A:()=>n.inspector.next(-1),Escape:()=>n.inspector.choose(null),g:o,d:ot,"?":()=>r.showModal()};document.addEventListener("keydown",i=>{let l=i.target instanceof
HTMLSelectElement||i.target instanceof HTMLInputElement,c=i.target instanceof HTMLButtonElement&&(i.key===" "||i.key==="Enter");if(document.querySelector("dialo\
g[open]")||l||c||i.defaultPrevented||i.ctrlKey||i.metaKey||i.altKey)return;let u=a[i.key]??a[i.key.toLowerCase()],m=Number(i.key)-1;if(Y(n.player,i)||u)u?.();else if(e[m])
it(e[m],m,t);else return;i.preventDefault()})}var lt=[[0,0],[-1,0],[0,1],[1,0],[0,-1],[-1,1],[1,1],[1,-1],[-1,-1]],H=(e,t)=>t<e.nPursuers,E=(e,t)=>[e.positions[2*t],e.positions[2*t+1]],Kr=(e,t)=>e[0]===t[0]&&
e[1]===t[1],ct=({rows:e,cols:t},[n,r])=>n>=0&&r>=0&&n<e&&r<t,dt=(e,t,n=3)=>e!==void 0&&[0,1,2].slice(0,n).some(r=>e[3*t+r]),ut=(e,t)=>dt(e.fault,t),an=(e,t)=>!ut(
e,t)&&dt(e.involved,t,2);function Re(e,t,n){let r=!Kr(E(e,n),E(t,n)),o=t.involved===void 0||dt(t.involved,n);return!!(t.alive[n]&&t.actions?.[n]&&!r&&o)}function ke(e,t,n){
let[r,o]=E(e,n),[s,a]=lt[t.actions?.[n]??0];return[r+s,o+a]}function $e(e,t,n){return Array.from({length:n.everCaptured.length},(o,s)=>s).filter(o=>n.everCaptured[o]&&
!t.everCaptured[o]).map(o=>e.nPursuers+o)}function Pe(e,t){return Array.from({length:t.alive.length},(r,o)=>o).filter(r=>e.alive[r]&&!t.alive[r])}var ln=[-.31,0,.31],cn=[{size:1,at:[[0,0]]},{size:.62,at:[[-.2,.2],[.2,-.2]]},{size:.54,at:[[-.23,.22],[.23,.22],[0,-.22]]},{size:.54,at:[[-.23,.23],[.23,.23],[
-.23,-.23],[.23,-.23]]},{size:.36,at:ln.flatMap(e=>ln.map(t=>[t,e]))}],qr=.3,Yr=.35,Xr=.55;function ue(e,t){let n=new Map;for(let r=0;r<t.alive.length;r++){if(!t.
alive[r])continue;let[o,s]=E(t,r),a=o*e.cols+s,i=n.get(a);i?i.push(r):n.set(a,[r])}return n}function dn(e,t){let n=Array.from(t.alive,(r,o)=>{let[s,a]=E(t,o);return{
x:a+.5,y:s+.5,size:1,alpha:0}});for(let r of ue(e,t).values()){let o=cn[Math.min(r.length,cn.length)-1];r.forEach((s,a)=>{let[i,l]=o.at[Math.min(a,o.at.length-1)],
c=n[s];c.x+=i,c.y+=l,c.size=o.size,c.alpha=1})}return n}var un=e=>e*e*(3-2*e),X=(e,t,n)=>e+(t-e)*n,mn=e=>Math.min(1,Math.max(0,e));function pn(e,t,n,r){let o={1:2,
2:n}[e.interaction]??1;if(o===1)return un(r);let s=o===n?t:+!H(e,t),a=Math.max(1/o,Yr);return un(mn((r-s/(o-1)*(1-a))/a))}function Oe(e,t){let n=e.moments.length-
1,r=Math.min(Math.floor(t),n),o=e.moments[r],s=dn(e,o);if(r===n||t===r)return s;let a=e.moments[r+1],i=dn(e,a);return s.map((l,c)=>{let u=pn(e,c,s.length,t-r);return Jr(
o,a,c,l,i[c],u)})}function hn(e,t,n){let r=e.moments.length-1,o=Math.min(Math.floor(n),r),[s,a]=[e.moments[o],e.moments[Math.min(o+1,r)]],i=pn(e,t,s.alive.length,
n-o),[[l,c],[u,m]]=[E(s,t),E(a,t)];return[X(c,m,i)+.5,X(l,u,i)+.5]}function Jr(e,t,n,r,o,s){let a=r.alpha>o.alpha,i={x:X(r.x,o.x,s),y:X(r.y,o.y,s),size:a?r.size:
X(r.size,o.size,s),alpha:a?mn((1-s)/(1-Xr)):X(r.alpha,o.alpha,s)};if(Re(e,t,n)){let[l,c]=E(e,n),[u,m]=ke(e,t,n),p=qr*Math.sin(Math.PI*s);i.x+=(m-c)*p,i.y+=(u-l)*
p}return i}var fn=2*Math.PI;function B(e,t,n,r){e.beginPath(),e.arc(t,n,r/2,0,fn)}function Le(e,t,n,r){let o=r/2,s=[[0,-.97],[.97,.83],[-.97,.83]].map(([a,i])=>[t+a*o,n+i*
o]);e.beginPath(),e.moveTo((s[2][0]+s[0][0])/2,(s[2][1]+s[0][1])/2),s.forEach(([a,i],l)=>{let[c,u]=s[(l+1)%3];e.arcTo(a,i,c,u,r*.09)}),e.closePath()}function gn(e,t,n,r){
let o=r*.32;e.beginPath(),e.moveTo(t-o,n-o),e.lineTo(t+o,n+o),e.moveTo(t+o,n-o),e.lineTo(t-o,n+o)}function yn(e,t,n,r){e.beginPath();for(let o=0;o<16;o++){let s=r/
2*(o%2?.6:.95),a=fn*o/16;e.lineTo(t+s*Math.sin(a),n-s*Math.cos(a))}e.closePath()}function bn(e,t,n,r,o,s){let a=Math.atan2(o-n,r-t);e.beginPath(),e.moveTo(t,n),
e.lineTo(r,o);for(let i of[-1,1])e.moveTo(r,o),e.lineTo(r-s*Math.cos(a+i*.6),o-s*Math.sin(a+i*.6))}var vn=4,Zr=1.6,Qr=.95,eo=5,to=.16,no=9,ro=.09,oo=.2,wn=.75,k=(e,t)=>e.left+t*e.cell,$=(e,t)=>e.top+t*e.cell;function J(e,t,n){return H(t,n)?e.colors.pursuer:e.
colors.evader}function xn({ctx:e,grid:t,colors:n}){let{left:r,top:o,cell:s,rows:a,cols:i}=t,[l,c]=[i*s,a*s];if(e.fillStyle=n.paper,e.fillRect(r,o,l,c),s<eo)return;
e.fillStyle=n.line;let u=Math.max(1,Math.round(s/60));for(let m=1;m<i;m++)e.fillRect(r+m*s,o,u,c);for(let m=1;m<a;m++)e.fillRect(r,o+m*s,l,u)}function Sn({ctx:e,
grid:t,colors:n},r){let{left:o,top:s,cell:a,rows:i,cols:l}=t;e.fillStyle=n.obstacle;for(let u=0;u<i*l;u++){if(!r.obstacles[u])continue;let[m,p]=[Math.floor(u/l),
u%l];e.fillRect(o+p*a,s+m*a,a,a)}let c=Math.min(5,Math.max(2,Math.round(a/18)));e.strokeStyle=n.frame,e.lineWidth=c,e.strokeRect(o-c/2,s-c/2,l*a+c,i*a+c)}function Mn({
ctx:e,grid:t,colors:n},r){let{left:o,top:s,cell:a,rows:i,cols:l}=t,c=a<24*r?5:1;e.font=`500 ${Math.round(Math.min(15*r,Math.max(9*r,a*.32)))}px system-ui, sans-\
serif`,e.fillStyle=n.muted,e.textBaseline="alphabetic",e.textAlign="center";let u=5*r+a/40;for(let m=0;m<l;m+=c)e.fillText(String(m),o+(m+.5)*a,s-u);e.textAlign=
"right",e.textBaseline="middle";for(let m=0;m<i;m+=c)e.fillText(String(m),o-u,s+(m+.5)*a)}function En(e,t,n,r,o){let{ctx:s,grid:a}=e,i=Math.floor(t.fov/2)+.5,[l,
c]=[Math.max(0,r-i),Math.min(a.cols,r+i)],[u,m]=[Math.max(0,o-i),Math.min(a.rows,o+i)],p=[k(a,l),$(a,u),(c-l)*a.cell,(m-u)*a.cell],f=J(e,t,n);s.globalAlpha=.11,
s.fillStyle=f,s.fillRect(...p),s.globalAlpha=.8,s.strokeStyle=f,s.lineWidth=Math.max(1,a.cell/24),s.strokeRect(...p),s.globalAlpha=1}function An(e,t,n,r,o){let{
ctx:s,grid:a}=e,i=Math.min(Math.ceil(n),t.moments.length-1),l=t.moments[i];s.lineCap="round",s.lineWidth=Math.min(no,Math.max(1,a.cell*to));for(let c=Math.max(1,
Math.floor(n-r)+1);c<=i;c++){let[u,m]=[t.moments[c-1],t.moments[c]],p=Math.max(0,Math.min(1,(n-c)/r));s.globalAlpha=wn+(oo-wn)*p;for(let f=0;f<m.alive.length;f++){
let g=c===i&&n<i;if(!u.alive[f]||!(l.alive[f]||g))continue;let h=(H(t,f)?-1:1)*ro,[b,w]=E(u,f),[S,v]=E(m,f);if(b===S&&w===v)continue;let x=g?o[f].x:v+.5,T=g?o[f].
y:S+.5;s.strokeStyle=J(e,t,f),s.beginPath(),s.moveTo(k(a,w+.5+h),$(a,b+.5+h)),s.lineTo(k(a,x+h),$(a,T+h)),s.stroke()}}s.globalAlpha=1}function Cn(e,t,n){let r=Math.
min(Math.ceil(n),t.moments.length-1);for(let o=Math.max(1,r-vn+1);o<=r;o++){let[s,a]=[t.moments[o-1],t.moments[o]],i=o>n?Math.max(0,1-2*(o-n)):1-(n-o)/vn,l=$e(t,
s,a);for(let c of Pe(s,a))l.includes(c)||ao(e,E(a,c),i);for(let c of l)so(e,E(a,c),i)}e.ctx.globalAlpha=1}function so({ctx:e,grid:t,colors:n},[r,o],s){e.globalAlpha=
s,yn(e,k(t,o+.5),$(t,r+.5),Math.max(8,t.cell*Zr)),e.fillStyle=n.capture,e.fill(),e.strokeStyle=n.ink,e.lineWidth=Math.max(1,t.cell/36),e.lineJoin="round",e.stroke()}
function ao({ctx:e,grid:t,colors:n},[r,o],s){e.globalAlpha=s,gn(e,k(t,o+.5),$(t,r+.5),Math.max(7,t.cell*Qr)),e.strokeStyle=n.collision,e.lineWidth=Math.max(2,t.
cell*.17),e.lineCap="round",e.stroke()}function Tn({ctx:e,grid:t,colors:n},r,o){let s=Math.max(1,t.cell*.07);e.strokeStyle=e.fillStyle=n.collision,e.lineWidth=Math.
max(1,t.cell*.05),e.setLineDash([t.cell*.14,t.cell*.1]);for(let[a,i]of r){if(a<0||i<0||a>=t.rows||i>=t.cols)continue;let l=[k(t,i)+s,$(t,a)+s,t.cell-2*s,t.cell-
2*s];e.globalAlpha=.2*o,e.fillRect(...l),e.globalAlpha=o,e.strokeRect(...l)}e.setLineDash([]),e.globalAlpha=1}function _n({ctx:e,grid:t,colors:n},r,o,s,a){e.globalAlpha=
a,B(e,k(t,r),$(t,o),Math.max(8,t.cell*s*1.02)),e.strokeStyle=n.collision,e.lineWidth=Math.max(1.5,t.cell*.085*Math.sqrt(s)),e.stroke(),e.globalAlpha=1}var io=.8,lo=.92,co=15,uo=7,ht=9;function Rn(e,t,n,r,o,s){r.forEach((a,i)=>{a.alpha>0&&mo(e,t,n,i,a,o,s)}),e.ctx.globalAlpha=1;for(let a of ue(t,n).values())a.length>
ht&&po(e,r[a[ht-1]],a.length-ht+1)}function mo(e,t,n,r,o,s,a){let{ctx:i,grid:l,colors:c}=e,u=H(t,r),[m,p]=[l.left+o.x*l.cell,l.top+o.y*l.cell],f=Math.max(4,l.cell*
o.size*(u?lo:io)),g=J(e,t,r),h=!u&&!!n.captured[r-t.nPursuers];if(i.globalAlpha=o.alpha,(u?Le:B)(i,m,p,f),f>uo*a&&(i.strokeStyle=c.paper,i.lineWidth=Math.max(2,
f*.1),i.stroke()),i.fillStyle=h?c.paper:g,i.fill(),h&&(B(i,m,p,f*.82),i.strokeStyle=g,i.lineWidth=f*.18,i.stroke()),!s||f<co*a)return;let b=String(u?r:r-t.nPursuers);
i.font=`700 ${Math.round(f*(u?.4:.5)*(b.length>1?.8:1))}px system-ui, sans-serif`,i.textAlign="center",i.textBaseline="middle",i.fillStyle=h?g:c.paper,i.fillText(
b,m,p+f*(u?.17:.03))}function po({ctx:e,grid:t,colors:n},r,o){let[s,a]=[t.left+r.x*t.cell,t.top+r.y*t.cell];e.font=`700 ${Math.round(t.cell*.3)}px system-ui, sa\
ns-serif`,e.textAlign="center",e.textBaseline="middle",e.strokeStyle=n.paper,e.lineWidth=t.cell*.1,e.strokeText(`+${o}`,s,a),e.fillStyle=n.ink,e.fillText(`+${o}`,
s,a)}var ho=.46,fo=.86,go=.66,kn=.48,yo=.78,bo=.58;function $n(e,t,n,r){let[o,s]=[t.moments[n-1],t.moments[n]];if(!o)return;let{ctx:a,grid:i,colors:l}=e;a.strokeStyle=
l.collision,a.lineWidth=Math.max(1.5,i.cell*.07),a.lineCap="butt",a.globalAlpha=r;for(let c=0;c<s.alive.length;c++)Re(o,s,c)&&vo(e,t,E(o,c),ke(o,s,c));a.globalAlpha=
1}function vo({ctx:e,grid:t},n,r,o){let[s,a]=[o[1]-r[1],o[0]-r[0]],i=m=>k(t,r[1]+.5+s*m),l=m=>$(t,r[0]+.5+a*m),c=ct(n,o)?yo:bo;e.setLineDash([t.cell*.09,t.cell*
.06]),e.beginPath(),e.moveTo(i(kn),l(kn)),e.lineTo(i(c),l(c)),e.stroke(),e.setLineDash([]);let u=.17*t.cell/Math.hypot(s,a);e.beginPath(),e.moveTo(i(c)-a*u,l(c)+
s*u),e.lineTo(i(c)+a*u,l(c)-s*u),e.stroke()}function Pn(e,t,n,r,o,s){let a=lt[s];if(!s||!a)return;let{ctx:i,grid:l,colors:c}=e,u=ct(t,[r[0]+a[0],r[1]+a[1]])?fo:
go,m=ho*o.size,p=[k(l,o.x+a[1]*m),$(l,o.y+a[0]*m),k(l,o.x+a[1]*u),$(l,o.y+a[0]*u)],f=Math.max(1.5,l.cell*.085);i.lineCap=i.lineJoin="round";for(let[g,h]of[[c.paper,
f*2.1],[J(e,t,n),f]])i.strokeStyle=g,i.lineWidth=h,bn(i,...p,l.cell*.2),i.stroke()}var Ln={numbers:!0,axes:!1,trail:6,viewers:[],plan:null,selected:null,cursor:null};function Nn(e,t,n,r,o){let{ctx:s,grid:a,colors:i}=e,l=Math.min(Math.ceil(n),t.
moments.length-1),c=t.moments[l],u=n===l,m=Oe(t,n),p=u?1:Math.max(0,1-2*(l-n));s.clearRect(0,0,s.canvas.width,s.canvas.height),xn(e);for(let h of r.viewers)m[h]?.
alpha&&En(e,t,h,...hn(t,h,n));Sn(e,t),r.axes&&Mn(e,o),An(e,t,n,r.trail,m),Tn(e,c.contested??[],p),Cn(e,t,n),$n(e,t,l,p),m.forEach(({x:h,y:b,size:w},S)=>{let v=an(
c,S)?.4:0,x=ut(c,S)?1:v;x&&_n(e,h,b,w,x*p)});let f=u?c:t.moments[Math.max(0,l-1)];if(Rn(e,t,f,m,r.numbers,o),u&&r.plan)for(let[h,b]of m.entries())b.alpha&&Pn(e,
t,h,E(c,h),b,r.plan[h]??0);s.lineWidth=Math.max(2,2.5*o),s.strokeStyle=i.focus;let g=r.selected===null?void 0:m[r.selected];g?.alpha&&On(e,g.x,g.y,g.size*.96),r.
cursor&&(s.setLineDash([a.cell*.12,a.cell*.08]),On(e,r.cursor[1]+.5,r.cursor[0]+.5,.8),s.setLineDash([]))}function On({ctx:e,grid:t},n,r,o){let s=o*t.cell;e.beginPath(),
e.roundRect(t.left+n*t.cell-s/2,t.top+r*t.cell-s/2,s,s,s*.1),e.stroke()}var In=(e,t)=>(t+.24)/(e+.24);function Un(e,t,n,r,o,s){let a=n?28*s:0,i=(c,u)=>(c-a)/(u+2*.12),l=Math.max(1,Math.floor(Math.min(i(r,t),i(o,e))));return{rows:e,cols:t,
cell:l,left:Math.round((r-t*l+a)/2),top:Math.round((o-e*l+a)/2)}}function Dn(e,t,n){let r=Math.floor((n-e.top)/e.cell),o=Math.floor((t-e.left)/e.cell);return r>=
0&&r<e.rows&&o>=0&&o<e.cols?[r,o]:null}var wo={paper:"--board-paper",line:"--board-line",frame:"--board-frame",ink:"--board-ink",muted:"--board-muted",obstacle:"--board-obstacle",pursuer:"--pursuer",
evader:"--evader",capture:"--capture",collision:"--collision",focus:"--focus"};function Ne(e){let t=getComputedStyle(e),n=Object.entries(wo).map(([r,o])=>[r,t.getPropertyValue(
o).trim()]);return Object.fromEntries(n)}var Q=()=>matchMedia("(prefers-reduced-motion: reduce)").matches,Z=class{canvas;#e=null;#r=0;#s;#a={rows:1,cols:1,left:0,top:0,cell:1};#n=0;#t;#o;constructor(t,n={}){
this.canvas=t,t.classList.add("board"),t.setAttribute("role","img"),this.#s={...Ln,...n},this.#t=new ResizeObserver(()=>this.#d()),this.#t.observe(t),this.#o=new MutationObserver(
()=>this.redraw()),this.#o.observe(document.documentElement,{attributes:!0}),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",this.redraw)}close(){
this.#t.disconnect(),this.#o.disconnect(),matchMedia("(prefers-color-scheme: dark)").removeEventListener("change",this.redraw),cancelAnimationFrame(this.#n)}get look(){
return this.#s}set look(t){this.#s={...this.#s,...t},this.#c(),this.redraw()}get time(){return this.#r}show(t,n){this.#e=t,this.#r=Math.min(Math.max(0,n),t.moments.
length-1),this.#c(),this.redraw()}redraw=()=>{this.#n||(this.#n=requestAnimationFrame(()=>this.drawNow()))};drawNow(){cancelAnimationFrame(this.#n),this.#n=0;let t=this.
canvas.getContext("2d");if(!t||!this.#e)return;let{rows:n,cols:r}=this.#e,o=devicePixelRatio||1;this.#a=Un(n,r,this.#s.axes,this.canvas.width,this.canvas.height,
o);let s={ctx:t,grid:this.#a,colors:Ne(this.canvas)};Nn(s,this.#e,this.#r,this.#s,o)}cellAt(t,n){let r=this.canvas.getBoundingClientRect(),o=this.canvas.width/r.
width;return Dn(this.#a,(t-r.left)*o,(n-r.top)*o)}agentAt(t,n){let r=this.cellAt(t,n);if(!r||!this.#e)return null;let o=this.#e.moments[Math.round(this.#r)],s=ue(
this.#e,o).get(r[0]*this.#e.cols+r[1])??[],a=Oe(this.#e,Math.round(this.#r)),i=l=>{let[c,u]=this.pointOf(a[l].x,a[l].y);return Math.hypot(c-t,u-n)};return s.length?
s.reduce((l,c)=>i(c)<i(l)?c:l):null}pointOf(t,n){let r=this.canvas.getBoundingClientRect(),o=r.width/this.canvas.width,{left:s,top:a,cell:i}=this.#a;return[r.left+
(s+t*i)*o,r.top+(a+n*i)*o]}#c(){if(!this.#e)return;let{rows:t,cols:n}=this.#e;this.canvas.style.setProperty("--board-aspect",String(In(t,n)))}#d(){let t=devicePixelRatio||
1,{width:n,height:r}=this.canvas.getBoundingClientRect();this.canvas.width=Math.max(1,Math.round(n*t)),this.canvas.height=Math.max(1,Math.round(r*t)),this.drawNow()}};var So={SIMULTANEOUS:0,SWARM_TURNS:1,AGENT_TURNS:2};function Mo(e,t,n){return{rows:e.rows,cols:e.cols,nPursuers:e.n_pursuers,fov:e.fov,interaction:So[e.rules.interaction],
obstacles:t,moments:n}}function Ie(e){let t=Array.from({length:e.length+1},(n,r)=>Eo(e,r));return Mo(e.config,e.map,t)}function Eo(e,t){let n=e.n_agents,r=e.config.n_evaders,o=(a,i,l)=>a.
subarray(i*l,(i+1)*l),s={positions:o(e.last_positions,t,2*n),alive:o(e.alive,t,n),captured:o(e.captured,t,r),everCaptured:o(e.ever_captured,t,r)};return t===0?s:
{...s,actions:o(e.actions,t-1,n),involved:o(e.involved,t-1,3*n),fault:o(e.fault,t-1,3*n),get contested(){return e.conflicts(t).map(a=>a.cell)}}}var Ao={first:"M6 5v14M19 5 9 12l10 7z",back:"M17 5 7 12l10 7z",play:"M7 4.5 19 12 7 19.5z",pause:"M8 5v14M16 5v14",forward:"M7 5l10 7-10 7z",last:"M18 5v14M5 5\
l10 7-10 7z"};function Fn(e){let t=document.createElementNS("http://www.w3.org/2000/svg","svg");t.setAttribute("viewBox","0 0 24 24"),t.setAttribute("aria-hidde\
n","true"),t.classList.add("icon");let n=document.createElementNS("http://www.w3.org/2000/svg","path");return n.setAttribute("d",Ao[e]),t.append(n),t}function me(e,t,n,r){
let o=document.createElement("button");return o.type="button",o.className="player-button",o.append(Fn(e)),o.ariaLabel=t,o.title=`${t} (${n})`,o.addEventListener(
"click",r),o}function Ue(e){let t=document.createElement("div");t.className="player",t.role="group",t.ariaLabel="Player";let n=me("play","Play","Space",()=>e.toggle()),
r=Co(e),o=To(e),s=document.createElement("output");s.className="player-count",t.append(me("first","First step","Home",()=>e.move(-e.length)),me("back","Step bac\
k","←",()=>e.move(-1)),n,me("forward","Step forward","→",()=>e.move(1)),me("last","Last step","End",()=>e.move(e.length)),r,s,o);let a=()=>{n.replaceChildren(
Fn(e.playing?"pause":"play")),n.ariaLabel=e.playing?"Pause":"Play",n.title=`${n.ariaLabel} (Space)`,r.max=String(e.length),r.value=String(e.step),r.ariaValueText=
`step ${e.step} of ${e.length}`,s.textContent=`${e.step} / ${e.length}`,s.style.minWidth=`${2*String(e.length).length+3}ch`,o.value=String(e.speed)};return e.addEventListener(
"step",a),e.addEventListener("state",a),t.addEventListener("keydown",i=>{!(i.target instanceof HTMLSelectElement||i.key===" "&&i.target!==r)&&Y(e,i)&&i.preventDefault()}),
a(),t}function Co(e){let t=document.createElement("input");return t.type="range",t.className="player-scrub",t.min="0",t.step="1",t.ariaLabel="Step",t.addEventListener(
"input",()=>{e.pause(),e.jump(Number(t.value))}),t}function To(e){let t=document.createElement("select");return t.className="player-speed",t.ariaLabel="Speed",t.
title="Steps a second (+ and -)",t.append(...le.map(n=>new Option(`${n} / s`,String(n)))),t.addEventListener("change",()=>{e.speed=Number(t.value)}),t}var A=(e,t=2)=>e==null?"-":e.toFixed(t),ft=(e,t=1)=>e==null?"-":`${(100*e).toFixed(t)} %`;function De(e,t,n,r=2){return t===null||n===null?e.toFixed(r):`${e.toFixed(
r)} (${t.toFixed(r)} to ${n.toFixed(r)})`}var Hn=e=>e.toLocaleString("en-GB");function pe(e,t,n,r=!1){let o=(t-e)/Math.max(1,n),s=10**Math.floor(Math.log10(o||1)),
a=[1,2,5,10].map(c=>c*s).find(c=>c>=o)??10*s;r&&(a=Math.max(1,Math.round(a)));let i=Math.ceil(e/a-1e-9),l=Math.floor(t/a+1e-9);return Array.from({length:Math.max(
0,l-i+1)},(c,u)=>(i+u)*a)}function I(e,t,{pursuer:n,evader:r,episode:o,seed:s}){let a=t.seeds[n][r];return e.match(t.world,ie(t,"pursuer",n),ie(t,"evader",r),BigInt(s??a),o)}var Bn=40,he=new Map,fe=({run:e,pursuer:t,evader:n},r)=>`${e} ${t} ${n} ${r}`,Fe=class{element;#e;#r;#s=d("div",{class:"episodes",role:"group","aria-label":"Epi\
sodes of this cell"});#a=d("p",{class:"check small numbers","aria-live":"polite"});#n=0;constructor(t,n){[this.#e,this.#r]=[t,n],this.element=d("div",{class:"st\
rip-of-episodes"},this.#s,this.#a)}show(t,n,r){let{selected:o}=this.#e;o.seed===null&&he.set(fe(o,o.episode),Wn(r)),this.#o(n),Ro(this.#n),this.#t(t,n)}#t(t,n){
let{selected:r}=this.#e,s=se(n,r.pursuer,r.evader)?.rates.findIndex((a,i)=>!he.has(fe(r,i)))??-1;s<0||s>=Bn||(this.#n=_o(()=>{this.#e.selected===r&&(this.#r.playing||
(he.set(fe(r,s),Wn(I(t,n,{...r,episode:s,seed:null}))),this.#o(n)),this.#t(t,n))}))}#o(t){let{selected:n}=this.#e,r=se(t,n.pursuer,n.evader);if(!r){this.#s.replaceChildren(),
this.#a.textContent="The evaluation played no episodes of this pair.";return}let o=Math.min(Bn,r.rates.length);this.#s.replaceChildren(...r.rates.slice(0,o).map(
(c,u)=>this.#c(c,u)));let s=r.rates.slice(0,o).map((c,u)=>he.get(fe(n,u))),a=s.filter(c=>c!==void 0),i=s.flatMap((c,u)=>c&&(Math.abs(c.rate-r.rates[u])>1e-6||c.
length!==r.lengths[u])?[u+1]:[]),l=a.reduce((c,u)=>c+u.rate,0)/a.length;this.#a.dataset.equal=String(!i.length&&a.length===r.rates.length),this.#a.textContent=i.
length?`Episode ${i.join(", ")} differs from the evaluation.`:a.length<r.rates.length?`Played here: ${a.length} of ${r.rates.length} episodes, all as in the eva\
luation.`:`Played here: all ${a.length} episodes, mean capture rate ${A(l,3)}. The cell says ${A(r.rate,3)}.`}#c(t,n){let{selected:r}=this.#e,o=d("span",{class:"\
bar"});return o.style.height=`${Math.round(100*t)}%`,d("button",{type:"button",class:"episode",title:`Episode ${n+1}: capture rate ${A(t)}`,"aria-label":`Episod\
e ${n+1}, capture rate ${A(t)}`,"aria-pressed":String(n===r.episode&&r.seed===null),"data-played":he.has(fe(r,n)),onclick:()=>this.#e.select({episode:n,seed:null})},
o,d("span",{class:"count"},n+1))}},Wn=e=>({rate:e.statistics.capture_rate,length:e.length}),_o=e=>"requestIdleCallback"in window?requestIdleCallback(e,{timeout:1e3}):
setTimeout(e,100),Ro=e=>"cancelIdleCallback"in window?cancelIdleCallback(e):clearTimeout(e);var ge=(e,t)=>e<t?`pursuer_${e}`:`evader_${e-t}`,gt=["stay","north","east","south","west","northeast","southeast","southwest","northwest"];var jn=0,Gn=1,ko=2,$o=176;function Vn(e,t,n,r){let o=devicePixelRatio||1,s=Ne(e);e.width=e.height=$o*o;let a=e.getContext("2d");if(!a)return;let{fov:i}=t,l=e.width/
i;a.fillStyle=s.paper,a.fillRect(0,0,e.width,e.height);for(let u=0;n&&u<i*i;u++){let[m,p]=[(u%i+.5)*l,(Math.floor(u/i)+.5)*l],f=h=>!!n[h*i*i+u];f(ko)&&(a.fillStyle=
s.obstacle,a.fillRect(m-l/2,p-l/2,l,l));let g=f(jn)&&f(Gn)?l*.18:0;f(jn)&&zn(a,B,m+g,p+g,l*.74,s.evader),f(Gn)&&zn(a,Le,m-g,p-g,l*.86,s.pursuer)}a.strokeStyle=r<
t.n_pursuers?s.pursuer:s.evader,a.lineWidth=2*o;let c=Math.floor(i/2)*l;a.strokeRect(c,c,l,l)}function zn(e,t,n,r,o,s){t(e,n,r,o),e.fillStyle=s,e.fill()}var He=class{element;#e;#r=d("canvas",{class:"seen",role:"img"});#s=d("h3");#a=d("p",{class:"small muted"});#n=d("div",{class:"answers"});#t=null;#o=null;#c=null;#d=null;#i=null;#u=0;constructor(t){
this.#e=t,this.element=d("div",{class:"inspector","data-open":"false"},d("p",{class:"hint small muted"},"Click an agent, or press A: what it sees, and what its \
network answers."),d("div",{class:"inspected"},this.#r,d("div",{class:"answer"},this.#s,this.#a),this.#n))}get agent(){return this.#i}show(t,n,r,o){(this.#o!==n||
!this.#t)&&(this.#t?.free(),this.#t=t.world(n.world),this.#i!==null&&this.#o!==n&&this.choose(null)),[this.#o,this.#c,this.#d]=[n,r,o]}choose(t){this.#i=t,this.
element.dataset.open=String(t!==null),this.#e(t),this.at(this.#u)}next(t){let n=this.#c;if(!n)return;let r=this.#i??(t>0?-1:0);for(let o=0;o<n.n_agents;o++)if(r=
(r+t+n.n_agents)%n.n_agents,n.alive[this.#u*n.n_agents+r])return this.choose(r)}at(t){this.#u=t;let[n,r,o,s,a]=[this.#c,this.#t,this.#o,this.#d,this.#i];if(!n||
!r||!o||!s||a===null)return;let i=a<n.config.n_pursuers?"pursuer":"evader";this.#s.replaceChildren(d("span",{class:i},ge(a,n.config.n_pursuers)));let l=!!n.alive[t*
n.n_agents+a];n.seek(r,t),Vn(this.#r,n.config,l?r.view(a):null,a),this.#r.ariaLabel=`Field of view of ${ge(a,n.config.n_pursuers)}: evaders, pursuers and obstac\
les around it`;let c=t<n.length?n.actions[t*n.n_agents+a]:null;if(!l)return this.#l([],"It is gone.");let u=ie(o,i,s[i]);if(typeof u=="string")return this.#l([],
`The script "${u}" plays for it${c===null?"":`; it goes ${gt[c]}`}.`);let{probabilities:m}=r.answer(u,a),p=Array.from(m,(g,h)=>Po(gt[h],g,h===c)),f=u.sampled?"I\
ts action is drawn from these probabilities.":"It takes the most probable action.";this.#l(p,c===null?"The episode is over.":f)}#l(t,n){this.#n.replaceChildren(
...t),this.#a.textContent=n}};function Po(e,t,n){let r=d("span",{class:"filled"});return r.style.width=`${100*t}%`,d("div",{class:n?"action taken":"action"},d("\
span",{},e),d("span",{class:"track"},r),d("span",{class:"numbers"},t.toFixed(2)))}var Oo=(e,t)=>Object.keys(e).every(n=>e[n]===t[n]);function Kn(e,t){return Object.keys(t).find(n=>Oo(t[n],e))??null}var ye="_",si=2n**64n-1n;var yt={fov:11,maxSteps:500,rewards:"paper"},No=["rules","others","rewards","size","diagonal","fov","limit","seed","ended","walls","pursuers","evaders","played",
"next"];function Zn(e,t){let n=i=>i.map(l=>Uo(l,t)).join(""),r=i=>`${Math.floor(i/e.cols)}.${i%e.cols}`,o=Io(e.rewards,t),s=[e.seed,e.episode,e.steps].join("."),a={rules:Yn(
e.rules,t),others:e.others?Yn(e.others,t):"",rewards:o===yt.rewards?"":o,size:`${e.rows}x${e.cols}`,diagonal:e.diagonal?"1":"",fov:e.fov===yt.fov?"":String(e.fov),
limit:e.maxSteps===yt.maxSteps?"":String(e.maxSteps),seed:s==="0.0.0"?"":s,ended:e.ended?"1":"",walls:e.walls.map(r).join(ye),pursuers:e.pursuers.map(qn).join(ye),
evaders:e.evaders.map(qn).join(ye),played:e.played.map(n).join(ye),next:e.next.every(i=>i===0)?"":n(e.next)};return No.filter(i=>a[i]).map(i=>`${i}=${a[i]}`).join(
"&")}function qn({cell:e,gone:t,captured:n,everCaptured:r}){let o=n?"c":r?"e":"";return`${e[0]}.${e[1]}${o}${t?"x":""}`}function Yn(e,t){let n=t.fields.map(({name:r})=>String(
e[r]).toLowerCase());return Kn(e,t.variants)??n.join(".")}function Io(e,t){let n=JSON.stringify(e);return Object.keys(t.rewards).find(o=>JSON.stringify(t.rewards[o])===
n)??Object.values(e).map(o=>String(o)).join(ye)}function Uo(e,t){if(typeof e=="number")return String(e);let n=t.scripts.findIndex(({name:r})=>r===e);return String.
fromCharCode(97+n)}var Do="/* the engine */";function Qn(e,t){return d("button",{type:"button",class:"to-playground",title:"Open this step in the playground (G): the same agents a\
nd actions under any rules",onclick:()=>bt(e(),t)},"What if? Playground")}function bt(e,t){let r=e!==null&&e.match.n_agents<=100&&Math.max(e.match.config.rows,e.
match.config.cols)<=64?Zn(Fo(e.match,e.step),t):"",o=new TextDecoder().decode(at("playground")).replace(Do,()=>Te("script-engine"));window.open(`${URL.createObjectURL(
new Blob([o],{type:"text/html"}))}#${r}`)}function Fo(e,t){let{config:n,n_agents:r}=e,o=Math.max(0,t-1),s=i=>{let l=o*r+i,c=o*n.n_evaders+i-n.n_pursuers,u=m=>i>=
n.n_pursuers&&!!m[c];return{cell:[e.last_positions[2*l],e.last_positions[2*l+1]],gone:!e.alive[l],captured:u(e.captured),everCaptured:u(e.ever_captured)}},a=Array.
from({length:r},(i,l)=>s(l));return{rules:n.rules,others:null,rewards:n.rewards,rows:n.rows,cols:n.cols,diagonal:n.diagonal,fov:n.fov,maxSteps:n.max_steps,seed:e.
seed,episode:BigInt(e.episode),steps:o,ended:o===e.length,walls:Array.from(e.map.keys()).filter(i=>e.map[i]),pursuers:a.slice(0,n.n_pursuers),evaders:a.slice(n.
n_pursuers),played:[],next:Array.from(e.actions.subarray(o*r,(o+1)*r))}}function er(e,t,n){if(n===0)return[{kind:"start",text:Ho(e),agents:[]}];let[r,o]=[t.moments[n-1],t.moments[n]],s=u=>ge(u,e.config.n_pursuers),a=$e(t,r,o),i=e.conflicts(
n),l=new Set(i.flatMap(u=>u.doomed)),c=a.map(u=>({kind:"capture",text:`${s(u)} is captured`,agents:[u]}));for(let u of Pe(r,o))!a.includes(u)&&!l.has(u)&&c.push(
{kind:"end",text:`${s(u)} disappears`,agents:[u]});return c.push(...i.map(({kind:u,text:m,agents:p})=>({kind:u,text:m,agents:p}))),n===e.length&&c.unshift({kind:"\
end",text:Bo(e),agents:[]}),c}function Ho({config:e}){return`${e.n_pursuers} pursuers and ${e.n_evaders} evaders on ${e.rows} x ${e.cols} cells, at most ${e.max_steps}\
 steps`}function Bo(e){let t=Math.round(e.statistics.capture_rate*e.config.n_evaders);return`The episode ends after ${e.length} steps with ${t} of ${e.config.n_evaders}\
 evaders captured`}var Wo=60,Be=class{element;player=new q(0,{speed:8,still:Q()});inspector;#e;#r;#s;#a;#n=d("h2",{class:"match-title"});#t=d("p",{class:"tally numbers"});#o=d("ol",
{class:"words","aria-live":"off","aria-label":"What happened in this step"});#c=d("p",{class:"problem",role:"alert"});#d=null;#i=null;#u=null;#l=0;#p=!1;#m=0;constructor(t,n,r){
[this.#r,this.#s]=[t,n];let o=d("canvas",{"aria-label":"The match"});this.#e=new Z(o,{numbers:!1}),this.#a=new Fe(n,this.player),this.inspector=new He(s=>this.#x(
s)),o.addEventListener("click",s=>this.inspector.choose(this.#e.agentAt(s.clientX,s.clientY))),this.element=d("section",{class:"card match-card","aria-label":"M\
atch",id:"match"},d("div",{class:"match"},d("header",{class:"match-head"},this.#n,this.#t),this.#c,d("div",{class:"stage"},o),d("div",{class:"aside"},this.#o,Qn(
()=>this.shown,r),this.inspector.element),Ue(this.player),this.#a.element)),this.player.addEventListener("frame",()=>this.#u&&this.#e.show(this.#u,this.player.time)),
this.player.addEventListener("step",()=>this.#v()),n.on("match",()=>this.#b()),this.#g(),this.#w(0,0)}get#h(){return this.#r[this.#s.selected.run]}get match(){return this.#i}get shown(){
return this.#i&&{match:this.#i,step:this.player.step}}start(t){this.#d=t,this.#y()}playSoon(){this.#p=!0,this.#l||this.#f()}goTo(t){this.#m=t,!this.#l&&this.#i&&
this.#y()}#f(){!this.#p||!this.#i||(this.#p=!1,this.player.jump(0),Q()||this.player.play())}#b(){this.#g(),clearTimeout(this.#l),this.#l=setTimeout(()=>this.#y(),
Wo)}#y(){clearTimeout(this.#l),this.#l=0,this.player.pause(),this.#g();let{selected:t}=this.#s,n=Zt.map(r=>ae(this.#h,r,t[r])).find(Boolean)??"";this.#c.textContent=
n,!(n||!this.#d)&&(this.#i=I(this.#d,this.#h,t),this.#u=Ie(this.#i),this.#a.show(this.#d,this.#h,this.#i),this.inspector.show(this.#d,this.#h,this.#i,t),this.player.
length=this.#i.length,this.player.jump(this.#m),this.#m=0,this.#v(),this.element.dataset.played=`${t.run} ${t.pursuer} ${t.evader} ${t.episode} ${t.seed??""}`,this.#f())}#g(){
let{pursuer:t,evader:n,episode:r,seed:o}=this.#s.selected,{teams:s,payoff:a}=this.#h,i=(c,u)=>s[c].script??`${c}s ${u}`,l=o===null?r<a.episodes?`episode ${r+1} \
of ${a.episodes}`:`episode ${r+1}, not part of the cell`:`seed ${o}`;this.#n.replaceChildren(d("span",{class:"pursuer"},i("pursuer",t))," against ",d("span",{class:"\
evader"},i("evader",n)),d("span",{class:"muted small"},l))}#v(){let t=this.#i;if(!t||!this.#u)return;let n=this.player.step,r=this.#u.moments[n];this.#w(Array.from(
r.everCaptured).filter(Boolean).length,n),this.#o.replaceChildren(...er(t,this.#u,n).map(o=>d("li",{class:o.kind,"data-agents":o.agents.join(" ")},o.text))),this.
inspector.at(n),this.#S()}#w(t,n){this.#t.replaceChildren(d("strong",{},t),` of ${this.#h.world.n_evaders} captured`,d("span",{class:"muted"},` · step ${n}`))}#x(t){
this.#e.look={selected:t,viewers:t===null?[]:[t]},this.#S()}#S(){let t=this.inspector.agent;for(let n of this.#o.children){let r=n.dataset.agents?.split(" ")??[];
n.classList.toggle("about",t!==null&&r.includes(String(t)))}}};var _={left:52,bottom:46,top:76,right:84},P=10,jo=160,be=_.right-P-14,W=_.top-P-14,We=class{element;#e;#r;#s=d("canvas",{"aria-hidden":"true"});#a=y("svg",{"ari\
a-hidden":"true"});#n=y("g");#t;#o=d("h2");#c=d("strong",{class:"rate numbers"});#d=d("span",{class:"small muted"});#i=d("p",{class:"small muted numbers"});#u=null;constructor(t,n){
[this.#r,this.#e]=[t,n],this.#t=d("div",{class:"matrix",id:"matrix",tabindex:0,role:"application","aria-label":"Payoff matrix. Arrow keys choose a match, Enter \
plays it."},this.#s,this.#a);let r=d("header",{class:"readout","aria-live":"polite"},d("div",{},this.#o,this.#i),d("div",{class:"of-cell"},this.#c,this.#d));this.
element=d("section",{class:"card matrix-card","aria-label":"Payoff matrix"},r,this.#t,Go()),this.#b(),new ResizeObserver(()=>this.#p()).observe(this.#t),this.#t.
addEventListener("pointermove",o=>this.#v(o)),this.#t.addEventListener("pointerleave",()=>n.point({})),this.#t.addEventListener("click",o=>this.#w(o)),this.#t.addEventListener(
"mousedown",o=>{o.preventDefault(),document.activeElement instanceof HTMLElement&&document.activeElement.blur()}),this.#t.addEventListener("keydown",o=>this.#x(
o)),n.on("run",()=>this.#p()),n.on("match",()=>this.#f()),n.on("hover",()=>this.#f())}get#l(){return this.#r[this.#e.selected.run]}#p(){let[t,n]=this.#l.payoff.
shape,{clientWidth:r,clientHeight:o}=this.#t;if(r<50)return;let a=Math.max(jo,Math.min(r-_.left-_.right,o-_.top-_.bottom))/Math.max(t,n),i=Math.max(_.left,(r-n*
a-_.right+_.left)/2),l=_.top+Math.max(0,(o-_.top-_.bottom-t*a)/2),c={width:r,height:o,left:i,top:l,cell:a,rows:t,columns:n};this.#u=c,_e(this.#s,this.#l.payoff,
{left:i,top:l,width:n*a,height:t*a}),this.#a.setAttribute("viewBox",`0 0 ${r} ${o}`),this.#a.replaceChildren(zo(c),Vo(c),...this.#h(c),this.#n),this.#f()}#m(t){
let n=this.#l.findings?.generalization;if(!n)return[];let{selected:r,hover:o}=this.#e,[s,a]=[o.pursuer??r.pursuer,o.evader??r.evader],[i,l]=nr(t,n.pursuers.mean[s]??
0,s),[c,u]=rr(t,n.evaders.mean[a]??0,a);return[y("circle",{class:"dot of-pursuers",cx:i,cy:l,r:5}),y("circle",{class:"dot of-evaders",cx:c,cy:u,r:5})]}#h(t){let n=this.#l.
findings?.generalization;if(!n)return[];let{left:r,top:o,cell:s,rows:a,columns:i}=t,[l,c]=[r+i*s+P,o-P],u={class:"side"};return[y("rect",{...u,x:l,y:o,width:be,
height:a*s}),y("rect",{...u,x:r,y:c-W,width:i*s,height:W}),...or(n.pursuers,(m,p)=>nr(t,m,p),"of-pursuers"),...or(n.evaders,(m,p)=>rr(t,m,p),"of-evaders"),y("te\
xt",{class:"tick",x:l,y:o+a*s+16,"text-anchor":"start"},"0"),y("text",{class:"tick",x:l+be,y:o+a*s+16,"text-anchor":"end"},"1"),y("text",{class:"tick",x:r-6,y:c-
4,"text-anchor":"end"},"0"),y("text",{class:"tick",x:r-6,y:c-W+8,"text-anchor":"end"},"1"),y("text",{class:"label of-pursuers",x:l+be,y:o+a*s+34,"text-anchor":"\
end"},"captures"),y("text",{class:"label of-evaders",x:r+i*s+P,y:c-W+10,"text-anchor":"start"},"escapes")]}#f(){let t=this.#u;if(!t)return;let{selected:n,hover:r}=this.#e,
{left:o,top:s,cell:a,rows:i,columns:l}=t,c=g=>s+(i-1-g)*a,u=[],m=(g,h)=>y("rect",{class:h,x:o,y:c(g),width:l*a+P+be,height:a}),p=(g,h)=>y("rect",{class:h,x:o+g*
a,y:s-P-W,width:a,height:P+W+i*a});if(u.push(m(n.pursuer,"strip pursuer"),p(n.evader,"strip evader")),r.pursuer!==null&&r.pursuer<i&&u.push(m(r.pursuer,"strip h\
over")),r.evader!==null&&r.evader<l&&u.push(p(r.evader,"strip hover")),r.lag!==null)for(let g=0;g<l;g++){let h=g+r.lag;h>=0&&h<i&&u.push(y("rect",{class:"lagged",
x:o+g*a,y:c(h),width:a,height:a}))}u.push(...this.#m(t));let f={x:o+n.evader*a,y:c(n.pursuer),width:a,height:a};u.push(y("rect",{class:"chosen under",...f}),y("\
rect",{class:"chosen",...f})),this.#n.replaceChildren(...u),this.#b()}#b(){let{selected:t,hover:n}=this.#e,r=n.pursuer??t.pursuer,o=n.evader??t.evader,s=se(this.#l,
r,o);this.#o.replaceChildren(d("span",{class:"pursuer"},`Pursuers ${r}`)," against ",d("span",{class:"evader"},`evaders ${o}`)),this.#c.textContent=s?A(s.rate,3):
"-",this.#d.textContent=s?`capture rate, mean of ${s.rates.length} episodes`:"the evaluation played no episodes",this.#i.textContent=this.#y(r,o)}#y(t,n){let r=this.#l.
findings?.generalization;if(!r)return"";let o=(s,a)=>De(s.mean[a]??0,s.low?.[a]??null,s.high?.[a]??null);return`Against all: captures ${o(r.pursuers,t)}, escape\
s ${o(r.evaders,n)}`}#g(t){let n=this.#u;if(!n)return null;let r=this.#t.getBoundingClientRect(),o=Math.floor((t.clientX-r.left-n.left)/n.cell),s=n.rows-1-Math.
floor((t.clientY-r.top-n.top)/n.cell),[a,i]=[s>=0&&s<n.rows,o>=0&&o<n.columns];return a||i?{g:a?s:-1,h:i?o:-1,inside:a&&i}:null}#v(t){let n=this.#g(t);this.#e.point(
n?{pursuer:n.g<0?null:n.g,evader:n.h<0?null:n.h}:{})}#w(t){let n=this.#g(t);n&&(this.#e.select({...n.g<0?{}:{pursuer:n.g},...n.h<0?{}:{evader:n.h}}),n.inside&&this.#t.
dispatchEvent(new CustomEvent("play",{bubbles:!0})))}#x(t){let r={ArrowUp:[1,0],ArrowDown:[-1,0],ArrowRight:[0,1],ArrowLeft:[0,-1]}[t.key];if(t.key==="Enter")this.#t.
dispatchEvent(new CustomEvent("play",{bubbles:!0}));else if(r){let o=t.shiftKey?5:1,[s,a]=this.#l.payoff.shape,{pursuer:i,evader:l}=this.#e.selected;this.#e.select(
{pursuer:tr(i+o*r[0],s),evader:tr(l+o*r[1],a)})}else return;t.preventDefault(),t.stopPropagation()}};function Go(){let e=d("span",{class:"gradient"});return e.style.
backgroundImage=nn(),d("p",{class:"scale-of-rates small muted"},"0 all escape",e,"1 all caught")}var tr=(e,t)=>Math.min(t-1,Math.max(0,e));function zo({left:e,top:t,
cell:n,rows:r,columns:o}){let s=y("g",{class:"axes"}),a=t+r*n,i=l=>pe(0,l-1,Math.min(l,l*n/44),!0);for(let l of i(o))s.append(y("text",{class:"tick",x:e+(l+.5)*
n,y:a+16,"text-anchor":"middle"},l));for(let l of i(r))s.append(y("text",{class:"tick",x:e-7,y:a-(l+.5)*n,"text-anchor":"end","dominant-baseline":"middle"},l));
return s.append(y("text",{class:"label of-evaders",x:e+o*n/2,y:a+36,"text-anchor":"middle"},"evader generation"),y("text",{class:"label of-pursuers",transform:`\
translate(${e-36} ${t+r*n/2}) rotate(-90)`,"text-anchor":"middle"},"pursuer generation")),s}function Vo({left:e,top:t,cell:n,rows:r,columns:o}){let s=y("g",{class:"\
diagonal"}),a=Math.min(r,o);if(a<3)return s;let i=t+r*n;for(let l of["H","V"]){let c=`M${e} ${i}`;for(let u=1;u<=a;u++){let[m,p]=[`H${e+u*n}`,`V${i-u*n}`];c+=l===
"H"?m+p:p+m}s.append(y("path",{d:c,class:"under"}),y("path",{d:c}))}return s}var nr=({left:e,top:t,cell:n,rows:r,columns:o},s,a)=>[e+o*n+P+s*be,t+(r-a-.5)*n],rr=({
left:e,top:t,cell:n},r,o)=>[e+(o+.5)*n,t-P-r*W];function or(e,t,n){let r=s=>s.map((a,i)=>t(a??0,i).map(l=>l.toFixed(1)).join(" ")),o=[];return e.low&&e.high&&o.
push(y("path",{class:`band ${n}`,d:`M${[...r(e.high),...r(e.low).reverse()].join("L")}Z`})),o.push(y("path",{class:`line ${n}`,d:`M${r(e.mean).join("L")}`})),o}function C(e,t,...n){return d("section",{class:"card panel","aria-label":e},d("header",{},d("h2",{},e),d("p",{class:"small muted"},t)),...n)}function sr(e,t,n){let{findings:r}=e;if(!r)return null;let o=d("dialog",{class:"four","aria-label":"Four matches"}),s=i=>{let l=n();l&&qo(o,e,i,t,l)},a=r.checkerboards.
map(i=>Ko(e,i,s));return{element:C("Checkerboards","Two generations of each team: each pursuers are better against one of the evaders. Click one: its four match\
es side by side.",a.length?d("div",{class:"boards"},...a):d("p",{},`No four cells differ by more than ${r.margin} in this way.`),a.length?d("p",{class:"small mu\
ted"},"The strongest of all pairs, so noise makes them look stronger than they are. The diagnosis says whether there are more than noise makes."):null,o)}}var ar=({
pursuers:[e,t],evaders:[n,r]})=>[[e,n],[e,r],[t,n],[t,r]];function Ko(e,t,n){let[r,o]=t.pursuers,[s,a]=t.evaders,i=ar(t).map(([l,c])=>{let u=e.payoff.capture_rate[l][c],
m=d("span",{class:u>.55?"cell light":"cell"},A(u));return m.style.backgroundColor=tn(u),m});return d("button",{type:"button",class:"miniature numbers",onclick:()=>n(
t),"aria-label":`Pursuers ${r} and ${o}, evaders ${s} and ${a}: four matches`},d("span",{}),d("span",{class:"evader"},s),d("span",{class:"evader"},a),d("span",{
class:"pursuer"},r),i[0],i[1],d("span",{class:"pursuer"},o),i[2],i[3])}function qo(e,t,n,r,o){let s=ar(n).filter(([p,f])=>!ae(t,"pursuer",p)&&!ae(t,"evader",f)),
a=s.map(([p,f])=>I(o,t,{run:r.selected.run,pursuer:p,evader:f,episode:0,seed:null})),i=new q(Math.max(0,...a.map(p=>p.length)),{speed:16,still:Q()}),l=a.map((p,f)=>{
let[g,h]=s[f],b=d("canvas",{"aria-label":`Pursuers ${g} against evaders ${h}`}),w=d("span",{class:"numbers"}),S=()=>{e.close(),r.select({pursuer:g,evader:h})};return{
element:d("figure",{},d("figcaption",{},d("span",{},d("span",{class:"pursuer"},g)," against ",d("span",{class:"evader"},h),d("span",{class:"muted small"},` cell\
 ${A(t.payoff.capture_rate[g][h])}`)),w,d("button",{type:"button",class:"small",title:"Show this match alone",onclick:S},"open")),b),match:p,recording:Ie(p),board:new Z(
b,{numbers:!1}),tally:w}}),c=()=>l.forEach(p=>p.board.show(p.recording,i.time)),u=()=>l.forEach(({recording:p,match:f,tally:g})=>{let h=p.moments[Math.min(i.step,
f.length)];g.textContent=`${Array.from(h.everCaptured).filter(Boolean).length} of ${f.config.n_evaders}`});i.addEventListener("frame",c),i.addEventListener("ste\
p",u),e.replaceChildren(d("header",{},d("h2",{},"Four matches of a checkerboard"),d("button",{type:"button",onclick:()=>e.close()},"Close")),d("div",{class:"gri\
d-of-four"},...l.map(p=>p.element)),Ue(i));let m=p=>{!(p.target instanceof HTMLSelectElement||p.target instanceof HTMLButtonElement&&p.key===" ")&&!p.defaultPrevented&&
Y(i,p)&&p.preventDefault()};e.addEventListener("keydown",m),e.addEventListener("close",()=>{e.removeEventListener("keydown",m),i.pause(),l.forEach(p=>p.board.close()),
e.replaceChildren()},{once:!0}),e.showModal(),c(),u(),Q()||i.play()}var je={pursuer:"evader",evader:"pursuer"};function ir(e,t){let n=e.findings?.ciao;if(!n)return null;let r=["pursuer","evader"].map(o=>{let{fading:s,stripes:a,period:i}=n[`${o}\
s`],l=`fading ${A(s)}, stripes ${A(a)}${i===null?"":` every ${i} generations`}`;return Yo(e,o,l,t)});return{element:C("CIAO","Current individuals against ancest\
ral opponents, by the team's own score. Stripes that come back: cycling. Darker away from the diagonal: forgetting.",d("div",{class:"triangles"},...r.map(o=>o.element))),
update:()=>r.forEach(o=>o.update())}}function Yo(e,t,n,r){let o=t==="pursuer"?0:1,[s,a]=[e.payoff.shape[o],e.payoff.shape[1-o]],i=(v,x)=>t==="pursuer"?e.payoff.
capture_rate[v][x]:1-e.payoff.capture_rate[x][v],l=d("canvas",{width:a,height:s,role:"img","aria-label":`CIAO of the ${t}s: ${n}`}),c=l.getContext("2d"),u=c?.createImageData(
a,s);for(let v=0;u&&v<s;v++)for(let x=0;x<=Math.min(v,a-1);x++)u.data.set([...de(i(v,x)),255],4*((s-1-v)*a+x));u&&c?.putImageData(u,0,0);let m=y("rect",{class:"\
chosen",width:1,height:1}),p=y("rect",{class:"chosen under",width:1,height:1}),f=y("svg",{viewBox:`0 0 ${a} ${s}`,preserveAspectRatio:"none","aria-hidden":"true"},
p,m),g=d("div",{class:"triangle"},l,f);g.style.aspectRatio=`${a} / ${s}`;let h=v=>{let x=g.getBoundingClientRect(),T=Math.floor((v.clientX-x.left)/x.width*a),U=s-
1-Math.floor((v.clientY-x.top)/x.height*s);return T>=0&&U<s&&T<=U?[U,T]:null},b=v=>({[t]:v[0],[je[t]]:v[1]});g.addEventListener("pointermove",v=>r.point(h(v)?b(
h(v)):{})),g.addEventListener("pointerleave",()=>r.point({})),g.addEventListener("click",v=>h(v)&&r.select(b(h(v))));let w=()=>{let v=r.hover[t]??r.selected[t],
x=r.hover[je[t]]??r.selected[je[t]];for(let T of[m,p])T.setAttribute("x",String(x)),T.setAttribute("y",String(s-1-v)),T.style.display=x<=v?"":"none"};return{element:d(
"figure",{},d("figcaption",{class:"small"},d("span",{class:t},`${t}s`)),g,d("p",{class:"small muted"},`horizontal: ${je[t]} generation; vertical: ${t} generatio\
n`),d("p",{class:"small numbers"},n)),update:w}}var Ge={left:46,right:12,top:10,bottom:42},lr={x:56,y:34};function ze(e,t,n,r){let[o,s]=[Ge.left,Ge.top],a=Math.max(o+40,e-Ge.right),i=Math.max(s+40,t-Ge.bottom),
l=(h,b,w)=>S=>b+(S-h.low)/(h.high-h.low||1)*(w-b),[c,u]=[l(n,o,a),l(r,i,s)],m=y("g"),p=y("svg",{width:e,height:t,viewBox:`0 0 ${e} ${t}`,class:"plot"}),f=y("g",
{class:"axes"});for(let h of pe(r.low,r.high,(i-s)/lr.y,r.whole))f.append(y("line",{x1:o,x2:a,y1:u(h),y2:u(h),class:"grid"}),y("text",{x:o-8,y:u(h),"text-anchor":"\
end","dominant-baseline":"middle"},cr(h)));for(let h of pe(n.low,n.high,(a-o)/lr.x,n.whole))f.append(y("text",{x:c(h),y:i+16,"text-anchor":"middle"},cr(h)));return f.
append(y("line",{x1:o,x2:a,y1:i,y2:i,class:"axis"}),y("text",{x:(o+a)/2,y:t-6,"text-anchor":"middle",class:"label"},n.label),y("text",{transform:`translate(12 ${(s+
i)/2}) rotate(-90)`,"text-anchor":"middle",class:"label"},r.label)),p.append(f,m),{root:p,marks:m,left:o,right:a,top:s,bottom:i,x:c,y:u,at:h=>{let b=h-p.getBoundingClientRect().
left;return n.low+(b-o)/(a-o)*(n.high-n.low)}}}var cr=e=>String(Number(e.toPrecision(6))).replace("-","−");function ve(e,t,n,r){let o="",s="M";n.forEach((i,l)=>{
i===null?s="M":(o+=`${s}${e.x(t[l]).toFixed(1)} ${e.y(i).toFixed(1)}`,s="L")});let a=y("path",{d:o,class:`line ${r}`});return e.root.insertBefore(a,e.marks),a}function we(e,t,n,r=null){let o=e.x(t);e.marks.append(y("line",{x1:o,x2:o,y1:e.top,y2:e.bottom,class:`mark ${n}`})),r!==null&&e.marks.append(y("circle",{cx:o,cy:e.
y(r),r:5,class:`dot ${n}`}))}function vt(...e){return d("p",{class:"legend small"},...e.map(([t,n])=>d("span",{class:`key ${n}`},t)))}function Ve(e,t,n={}){let r=d(
"div",{class:"chart",role:"img","aria-label":e}),o=null,s=()=>{o?.marks.replaceChildren(),o&&n.marks?.(o)},a=()=>{let{clientWidth:i,clientHeight:l}=r;i<50||l<50||
(o=t(i,l),r.replaceChildren(o.root),s())};return r.addEventListener("pointermove",i=>n.point?.(o?.at(i.clientX)??null)),r.addEventListener("pointerleave",()=>n.
point?.(null)),n.choose&&(r.classList.add("chooses"),r.addEventListener("click",i=>o&&n.choose?.(o.at(i.clientX),o,i))),new ResizeObserver(a).observe(r),{element:r,
redraw:a,remark:s}}var wt=["of-pursuers","of-evaders","of-both"],Xo=2500,dr={low:0,high:1,label:"capture rate"};function ur(e,t){let{training:n}=e,{capture_rate:r,generation:o,learner:s,
epochs:a}=n,i=r.map((g,h)=>(h+1)*a),l=Jo(r,n.window),c=i.at(-1)??1,u=i.length>Xo?"dense":"",m=(g,h)=>{let b=o.flatMap((w,S)=>w===g&&(s[S]===h||s[S]===2)?[S]:[]);
return b.length?[i[b[0]],i[b.at(-1)]]:null},p=Ve(`Capture rate in ${c} epochs of training`,(g,h)=>{let b=ze(g,h,{low:0,high:c,label:"epoch",whole:!0},dr);for(let[
w,S]of[["raw",r],[u,l]])for(let[v,x]of wt.entries()){let T=S.map((U,St)=>s[St]===v||s[St+1]===v?U:null);T.some(U=>U!==null)&&ve(b,i,T,`${x} ${w}`)}return b},{marks:g=>{
let{pursuer:h,evader:b}=t.selected;for(let[w,S]of[[0,h],[1,b]]){let v=m(t.hover[w?"evader":"pursuer"]??S,w);v&&we(g,(v[0]+v[1])/2,wt[w])}},choose:g=>{let h=Math.
min(i.length-1,Math.max(0,Math.round(g/a)-1)),b=o[h];s[h]!==1&&t.select({pursuer:Math.min(b,e.payoff.shape[0]-1)}),s[h]!==0&&t.select({evader:Math.min(b,e.payoff.
shape[1]-1)})}}),f=[...new Set(s)].sort().map(g=>[["pursuers learn","evaders learn","both teams learn"][g],wt[g]]);return{element:C("Training",`${Hn(n.matches)}\
 training matches. Lines: the generations that are selected.`,vt(...f),p.element),update:p.remark}}function mr(e,t){let n=e.findings?.lags;if(!n)return null;let[
r,o]=[n.lags[0],n.lags.at(-1)],s=Math.min(5,(Math.max(...n.cells)+1)/2),a=n.means.map((l,c)=>n.cells[c]>=s?l:null),i=Ve("Lag profile",(l,c)=>{let u=ze(l,c,{low:r,
high:o,label:"lag: pursuer minus evader generation",whole:!0},dr);return ve(u,n.lags,n.means,"raw ink"),ve(u,n.lags,a,"ink"),u},{marks:l=>{let{pursuer:c,evader:u}=t.
selected;we(l,0,"zero");let m=t.hover.lag??c-u;we(l,m,"ink",n.means[m-r])},point:l=>{let c=l===null?null:Math.round(l);t.point({lag:c!==null&&c>=r&&c<=o?c:null})}});
return{element:C("Lag profile","Left: evaders are later. Right: pursuers are later. It rises if both teams keep what they learn. Faint: fewer than 5 cells.",i.element),
update:i.remark}}function pr(e,t){let n=e.findings?.ratings;if(!n)return null;let r={pursuer:n.pursuers,evader:n.evaders},o=[...n.pursuers,...n.evaders].map(u=>u??
0),[s,a]=[Math.min(...o),Math.max(...o)],i=.06*(a-s||1),l=Math.max(...e.payoff.shape)-1,c=Ve("Elo ratings by generation",(u,m)=>{let p=ze(u,m,{low:0,high:l,label:"\
generation",whole:!0},{low:s-i,high:a+i,label:"Elo points"});for(let f of["pursuer","evader"])ve(p,r[f].map((g,h)=>h),r[f],`of-${f}s`);return p},{marks:u=>{for(let m of[
"pursuer","evader"]){let p=t.hover[m]??t.selected[m];we(u,p,`of-${m}s`,r[m][p]??null)}},choose:(u,m,p)=>{let f=Math.round(u),g=p.clientY-m.root.getBoundingClientRect().
top,h=w=>Math.abs(m.y(r[w][f]??1/0)-g),b=h("pursuer")<=h("evader")?"pursuer":"evader";f>=0&&f<r[b].length&&t.select({[b]:f})}});return{element:C("Ratings",`One \
number for each generation, which cycles do not fit. The game itself: ${A(n.offset,0)} points for the pursuers.`,vt(["pursuers","of-pursuers"],["evaders","of-ev\
aders"]),c.element),update:c.remark}}function Jo(e,t){let n=[0];for(let r of e)n.push(n.at(-1)+r);return e.map((r,o)=>{let[s,a]=[Math.max(0,o-Math.floor((t-1)/2)),
Math.min(e.length,o+Math.floor(t/2)+1)];return(n[a]-n[s])/(a-s)})}var Zo={present:"●",absent:"○","cannot tell":"?"};function hr(e){let{findings:t}=e;if(!t)return null;let[,...n]=t.table,r=new Map(t.reasons.map(a=>{let[i,,l]=Qo(
a);return[i,l]})),o=n.map(([a,i,l,c])=>{let u=c===t.window?r.get(a):void 0;return d("li",{class:`finding ${i.replace(" ","-")}`},d("span",{class:"sign","aria-hi\
dden":"true"},Zo[i]??""),d("div",{},d("p",{},d("strong",{},a),` ${i}`,d("span",{class:"muted"},` · ${c}`)),u?d("p",{class:"small"},`${u}.`):null,d("p",{class:"\
small muted numbers"},l)))}),s=C("What happened","Each condition is present, absent, or its 95 % interval cannot tell. The intervals are about this run.",d("p",
{class:"headline"},t.headline),d("ul",{class:"findings"},...o),e.limits?d("p",{class:"small"},e.limits):null,d("details",{class:"small"},d("summary",{},"Headlin\
e numbers in words"),...t.description.map(a=>d("p",{},a)),ts(t)));return s.classList.add("diagnosis"),{element:s}}function Qo(e){let[t="",n=""]=e.split(/: (.*)/s),
[r="",o=""]=n.split(/, because (.*)/s);return[t.toLowerCase(),r,es(o.replace(/\.$/,""))]}var es=e=>e.charAt(0).toUpperCase()+e.slice(1);function ts({noise:e}){return e.
transitive_share_noise===null?null:d("p",{},`Last half: transitive share ${A(e.transitive_share)} (an order of strength with the same noise rarely falls below ${A(
e.transitive_share_noise)}), checkerboards ${ft(e.checkerboard_share)} (it rarely exceeds ${ft(e.checkerboard_share_noise)}).`)}function fr(e){let t=[e.held_out?.pursuers,e.held_out?.evaders].filter(n=>n!=null);return t.length?{element:C("Held-out opponents",`The last generations against\
 opponents that no run has met; 95 % intervals over ${t[0].episodes} episodes.`,...t.map(ns))}:null}function ns(e){let t=r=>r.at(-1),n=[["mean",t(e.mean)],...Object.
entries(e.against).map(([r,o])=>[r,t(o)])];return d("table",{class:"scores numbers"},d("caption",{},d("span",{class:e.team},`${e.team}s`),` of generation ${e.generations.
at(-1)}, ${e.score}`),...n.map(([r,o],s)=>d("tr",{class:s?"":"mean"},d("th",{scope:"row"},r),d("td",{class:"range"},rs(o,e.team)),d("td",{},De(o.value,o.low,o.high)))))}
function rs({value:e,low:t,high:n},r){let o=d("span",{class:`between ${r}`});o.style.left=`${100*(t??e)}%`,o.style.width=`${100*((n??e)-(t??e))}%`;let s=d("span",
{class:`value ${r}`});return s.style.left=`${100*e}%`,d("span",{class:"scale","aria-hidden":"true"},o,s)}function yr(e){let t=e.settings.filter(o=>o.changed),n=e.settings.filter(o=>!o.changed),r=C("Settings",`${e.schedule}, seed ${e.seed}. Every setting is an optio\
n of matrixworld evolve.`,t.length?gr(t,"other than the default"):d("p",{class:"small"},"All settings are the defaults."),d("details",{class:"small"},d("summary",
{},`${n.length} settings with their defaults`),gr(n,"defaults")));return r.classList.add("settings"),{element:r}}function gr(e,t){return d("div",{class:"wide-ta\
ble"},d("table",{class:"small"},d("caption",{class:"heard"},`Settings: ${t}`),...e.map(({name:n,value:r,help:o})=>d("tr",{},d("th",{scope:"row"},`--${n.replaceAll(
"_","-")}`),d("td",{class:"numbers"},r),d("td",{class:"muted"},o)))))}function br(e,t,n){let r=new Map,o=d("div",{class:"panels"}),s=[],a=()=>s.forEach(l=>l.update?.()),i=()=>{let l=e[t.selected.run];s=r.get(l)??os(l,t,n),r.set(l,
s),o.replaceChildren(...s.map(c=>c.element)),a()};return t.on("run",i),t.on("match",a),t.on("hover",a),i(),o}function os(e,t,n){return[hr(e),ur(e,t),sr(e,t,n),mr(
e,t),pr(e,t),ir(e,t),fr(e),yr(e)].filter(o=>o!==null)}var vr={pursuer:null,evader:null,lag:null},Ke=class extends EventTarget{#e;#r=vr;constructor(t){super(),this.#e=t}get selected(){return this.#e}get hover(){return this.#r}select(t){
let n=this.#e,r=["run","pursuer","evader"].some(o=>o in t&&t[o]!==n[o]);this.#e={...n,...r?{episode:0,seed:null}:{},...t},this.#e.run!==n.run&&this.dispatchEvent(
new Event("run")),this.dispatchEvent(new Event("match"))}point(t){let n={...vr,...t};n.pursuer===this.#r.pursuer&&n.evader===this.#r.evader&&n.lag===this.#r.lag||
(this.#r=n,this.dispatchEvent(new Event("hover")))}on(t,n){this.addEventListener(t,n)}};var j=Qt(),{runs:R}=j,[ss,as]=R[0].payoff.shape,is=st(location.hash,R,{run:0,pursuer:ss-1,evader:as-1,episode:0,seed:null}),{step:ls,...cs}=is,N=new Ke(cs),O=new Be(
R,N,j.playground),wr=new We(R,N),xt=on(),qe=null;function ds(){let[e]=R,t=`matrixworld ${j.version}`;return R.length>1||!e?t:e.race?`${e.schedule}, seed ${e.seed}\
 · ${t}`:`${e.learning.join(" and ")}s learn, seed ${e.seed} · ${t}`}document.getElementById("page").replaceWith(d("header",{class:"top"},d("h1",{},j.title),d(
"p",{class:"muted small about"},ds()),d("div",{class:"tools"},Yt(),d("button",{type:"button",title:"Keys (?)","aria-label":"Keys",onclick:()=>xt.showModal()},"?"))),
...j.note?[d("p",{class:"note small muted"},j.note)]:[],rn(R,N),d("main",{class:"stages"},wr.element,O.element),br(R,N,()=>qe),xt);Object.assign(window,{matrixworldExplorer:{
get match(){return O.match},get step(){return O.player.step},play:e=>qe&&I(qe,R[N.selected.run],{...N.selected,episode:e}),get shape(){return R[N.selected.run].
payoff.shape}}});wr.element.addEventListener("play",()=>O.playSoon());O.goTo(ls);Xt(R,N,O);sn(R,N,O,xt,()=>bt(O.shown,j.playground));requestAnimationFrame(()=>setTimeout(
()=>{Kt().then(e=>{qe=e,O.start(e),document.body.dataset.ready="true"},e=>{O.element.prepend(d("p",{class:"problem",role:"alert"},`The engine does not start her\
e: ${String(e)}`)),document.body.dataset.ready="true"})}));})();
