/* built from web/ by "npm run build"; sources 3a8972c4b244ce1337c5667ecb5d45509ccc55f91a3dc234c3aba507b92595a3 */
"use strict";(()=>{var qe={SIMULTANEOUS:0,SWARM_TURNS:1,AGENT_TURNS:2},z={DISAPPEAR:0,REACH:1,BOUNCE:2},Xe={OCCUPATION:0,SURROUND:1},Ze={FAULT:0,INVOLVED:1};var Ae=["obstacle","teammate","adversary"],Ce=["vertex","edge","chain"],Qe=["turn","kind","form","first","second","row","col","at_fault","held","doomed"],Me=["p\
ursuer_{number}","evader_{number}"],et={obstacle:"{first} ran into the obstacle or border at {cell}",vertex:"{first} and {second} both headed for {cell}",edge:"\
{first} and {second} meant to swap, {first} to {cell}",chain:"{first} headed for {cell}, where {second} had to stay"},V={"both held":"both bounce","both doomed":"\
both disappear",held:"{agent} bounces",doomed:"{agent} disappears",none:"nobody is stopped"},tt="{event}: {outcome}",_e={random:"any action, all equally likely",
still:"always stays",chaser:"moves to where the nearest adversary in view is nearest",fleer:"moves to where the nearest adversary in view is farthest","clumsy-c\
haser":"a chaser that takes any action in half of the steps",hunter:"a chaser of the nearest adversary in view to which no teammate in view is nearer",surrounder:"\
a chaser of the nearest free cell beside an adversary without a teammate","clumsy-fleer":"a fleer that takes any action in half of the steps",dodger:"moves to w\
here all adversaries in view together are farthest"},rt={free:".GS",blocked:"#@OTW"};var I=1+Qe.length;function Y(t,e){return t.replace(/\{(\w+)\}/g,(r,n)=>String(e[n]))}function Te(t,e){return t<e?Y(Me[0],{number:t}):Y(Me[1],{number:t-e})}function Ir(t,e){
let[r,n,o,s,a,i,l,...u]=Array.from(t),c=a<0?[s]:[s,a],[d,h,p]=u.map(C=>c.filter((T,g)=>C>>g&1)),f=c.map(C=>Te(C,e)),y=Y(et[a<0?"obstacle":Ce[o]],{first:f[0],second:f[f.
length-1],cell:`(${i}, ${l})`}),v=Y(tt,{event:y,outcome:Lr(c.length,h,p,e)});return{kind:Ae[n],form:Ce[o],agents:c,cell:[i,l],at_fault:d,held:h,doomed:p,turn:r,
text:v}}function Lr(t,e,r,n){if(t===2&&e.length===2)return V["both held"];if(t===2&&r.length===2)return V["both doomed"];let o=s=>a=>Y(V[s],{agent:Te(a,n)});return[
...e.map(o("held")),...r.map(o("doomed"))].join(", ")||V.none}function re(t,e){let r=[];for(let n=0;n<t.length;n+=I)r.push(Ir(t.subarray(n+1,n+I),e));return r}var S=class extends Error{name="EngineError"};function w(t,e,r){let n=typeof r=="string"?`'${r}'`:typeof r=="object"?JSON.stringify(r):String(r);return new S(`${t}\
: expected ${e}, got ${n}`)}var L=class{bytes;constructor(e){this.bytes=e}},st=0,Re=[Uint8Array,Uint8Array,Int32Array,BigInt64Array,BigUint64Array,Float32Array,Float64Array],nt=4,ot=4,$r=new TextEncoder,
Ur=new TextDecoder;function Wr(t){for(let e=Re.length-1;e>st;--e)if(t instanceof Re[e])return e;throw new TypeError("array: expected a typed array of the engine\
's numbers, got another")}function Ee(t){return new Uint8Array(t.buffer,t.byteOffset,t.byteLength)}function Br(t){return $r.encode(`${t}\0`)}var Ne=class{engine;addresses=[];constructor(e){
this.engine=e}copy(e){let r=this.engine._malloc(Math.max(e.length,1));if(r===0)throw new S("memory: expected room for the arguments, got none");return this.addresses.
push(r),this.engine.HEAPU8.set(e,r),r}text(e){return this.copy(Br(e))}arrays(e){let r=Object.entries(e),n=r.flatMap(([s,a])=>{let i=a instanceof L,l=i?a.bytes:a;
return[this.text(s),i?st:Wr(l),l.length,this.copy(Ee(l))]}),o=this.copy(Ee(Int32Array.from(n)));return this.copy(Ee(Int32Array.of(r.length,o)))}free(){for(let e of this.
addresses)this.engine._free(e)}};function at(t,e){let r=t.HEAPU8;return Ur.decode(r.subarray(e,r.indexOf(0,e)))}function ne(t){let e=new Int32Array(t.HEAPU8.buffer),
r=t._last_outputs()/nt,n=e[r+1]/nt,o={};for(let s=n;s<n+e[r]*ot;s+=ot){let a=Re[e[s+1]],i=e[s+2]*a.BYTES_PER_ELEMENT,l=e[s+3];o[at(t,e[s])]=new a(t.HEAPU8.slice(
l,l+i).buffer)}return o}function K(t,e){let r=new Ne(t);try{let n=e(r);if(n===0)throw new S(at(t,t._last_error()));return n}finally{r.free()}}var Dr=2**31-1,Fr=2n**64n-1n,jr=34028234663852886e22;function E(t,e){if(typeof e!="number"||!Number.isInteger(e)||Math.abs(e)>Dr)throw w(t,"an integer",e);return Int32Array.
of(e)}function oe(t,e){if(typeof e!="boolean")throw w(t,"true or false",e);return new L(Uint8Array.of(Number(e)))}function O(t,e,r){let n=typeof e=="string"&&Object.
hasOwn(r,e)?r[e]:void 0;if(n===void 0)throw w(t,`one of ${Object.keys(r).join(", ")}`,e);return Int32Array.of(n)}function Oe(t,e){if(typeof e!="number"||!(Math.
abs(e)<=jr))throw w(t,"a finite number",e);return e}function $(t,e){let n=typeof e=="bigint"||typeof e=="number"&&Number.isSafeInteger(e)?BigInt(e):-1n;if(n<0n||
n>Fr)throw w(t,"an integer from 0 to 2^64 - 1",e);return BigUint64Array.of(n)}function Hr(t){return{"rules.interaction":O("interaction",t.interaction,qe),"rules\
.obstacle":O("obstacle",t.obstacle,z),"rules.teammate":O("teammate",t.teammate,z),"rules.evader":O("evader",t.evader,z),"rules.pursuer":O("pursuer",t.pursuer,z),
"rules.capture":O("capture",t.capture,Xe),"rules.captured_disappear":oe("captured_disappear",t.captured_disappear)}}function it(t,e){let r=typeof e=="number"?[e,
e,e]:e;if(!Array.isArray(r)||r.length!==3)throw w(t,"1 or 3 numbers",e);return Float32Array.from(r,n=>Oe(t,n))}function Gr(t){let e=(r,n)=>Float32Array.of(Oe(r,
t[r]),Oe(n,t[n]));return{"rewards.capture":e("pursuer_capture","evader_capture"),"rewards.neighbor":e("pursuer_neighbor","evader_neighbor"),"rewards.step":e("pu\
rsuer_step","evader_step"),"rewards.pursuer_collide":it("pursuer_collide",t.pursuer_collide),"rewards.evader_collide":it("evader_collide",t.evader_collide),"rew\
ards.blame":O("blame",t.blame,Ze),"rewards.capture_repeats":oe("capture_repeats",t.capture_repeats)}}function ut(t){if(t===void 0||typeof t=="number")return new Uint8Array(
0);if(t instanceof Uint8Array)return t;let{free:e,blocked:r}=rt;for(let[n,o]of t.entries()){if(o.length!==t[0]?.length)throw w(`map, row ${n}`,`${t[0]?.length} \
cells as in row 0`,o.length);let s=[...o].find(a=>!e.includes(a)&&!r.includes(a));if(s)throw w(`map, row ${n}`,`'${e}' (free) or '${r}' (obstacle)`,s)}return Uint8Array.
from([...t.join("")],n=>Number(r.includes(n)))}function ct(t,e){if(!Array.isArray(t))return;let r=[t.length,t[0]?.length??0];if(!(r[0]===e.rows&&r[1]===e.cols))
throw w("obstacle map",`shape (${e.rows}, ${e.cols}), the rows and cols`,r)}function se(t){ct(t.obstacles,t);let e=typeof t.obstacles=="number"?t.obstacles:0;return{
...Hr(t.rules),...Gr(t.rewards),rows:E("rows",t.rows),cols:E("cols",t.cols),n_pursuers:E("n_pursuers",t.n_pursuers),n_evaders:E("n_evaders",t.n_evaders),fov:E("\
fov",t.fov),diagonal:oe("diagonal",t.diagonal),max_steps:E("max_steps",t.max_steps),density:Float64Array.of(e),map:ut(t.obstacles)}}function lt(t,e){return Int32Array.
from((e??[]).flat(),r=>E(t,r)[0])}function dt(t,e){return ct(t.obstacles,e),{seed:$("seed",t.seed??0n),episode:$("episode",t.episode??0),pursuers:lt("pursuers",
t.pursuers),evaders:lt("evaders",t.evaders),map:ut(t.obstacles)}}function ae(t){return{actions:Int32Array.from(t,e=>E("actions",e)[0])}}function U(t){if(typeof t==
"string"){if(!Object.hasOwn(_e,t))throw w("policy",`one of ${Object.keys(_e).join(", ")}`,t);return{script:new TextEncoder().encode(t)}}if(t.activation!=="relu"&&
t.activation!=="tanh")throw w("activation","'relu' or 'tanh'",t.activation);return{hidden:Int32Array.from(t.hidden,e=>E("hidden",e)[0]),activation:new TextEncoder().
encode(t.activation),sampled:oe("sampled",t.sampled),genome:t.genome}}var zr=["first_turn","terminated","truncated"];function mt(t){let e={...t};for(let r of zr)
e[r]=new L(t[r]);return e}var ie=class{config;seed;episode;n_agents;statistics;positions;last_positions;alive;captured;ever_captured;actions;rewards;involved;fault;map;conflict_table;first_conflict;constructor(e,r,n,o){
this.config=e,this.seed=r,this.episode=n,this.n_agents=e.n_pursuers+e.n_evaders,this.statistics=pt(o,0),this.positions=o.positions,this.last_positions=o.last_positions,
this.alive=o.alive,this.captured=o.captured,this.ever_captured=o.ever_captured,this.actions=o.actions,this.rewards=o.rewards,this.involved=o.involved,this.fault=
o.fault,this.map=o.map,this.conflict_table=o.conflict_table,this.first_conflict=Vr(this.conflict_table,this.length)}get length(){return this.actions.length/this.
n_agents}conflicts(e){this.check(e);let[r,n]=[this.first_conflict[e],this.first_conflict[e+1]],o=this.conflict_table.subarray(r*I,n*I);return re(o,this.config.n_pursuers)}seek(e,r){
this.check(r),(!(e.seed===this.seed&&e.episode===BigInt(this.episode))||e.turn!==0||e.steps>r)&&e.reset({seed:this.seed,episode:this.episode});for(let o=e.steps;o<
r;++o)e.step(this.actions.subarray(o*this.n_agents,(o+1)*this.n_agents))}check(e){if(!(Number.isInteger(e)&&e>=0&&e<=this.length))throw w("step",`0 to ${this.length}`,
e)}};function Vr(t,e){let r=new Int32Array(e+2);for(let n=0;n<t.length;n+=I)++r[t[n]+1];for(let n=1;n<r.length;++n)r[n]+=r[n-1];return r}function pt(t,e){let r=t["\
statistics.length"].length,n=s=>{let a=t[`statistics.${s}`],i=a.length/r;return a.slice(e*i,(e+1)*i)},o=s=>Number(n(s)[0]);return{capture_rate:o("capture_rate"),
ever_capture_rate:o("ever_capture_rate"),captured_fraction:o("captured_fraction"),length:o("length"),return:n("return"),survivors:n("survivors"),overlap:n("over\
lap"),collisions:n("collisions"),faults:n("faults"),agent_steps:n("agent_steps")}}function ht(t,e,r,n){let o=[se(r.config),U(r.pursuers),U(r.evaders),n];return K(
t,s=>{let[a,i,l,u]=o.map(c=>s.arrays(c));return t[e](a,i,l,u)}),ne(t)}function ft(t,e,r,n){let o={seed:$("seed",r),episode:$("episode",n)};return new ie(e.config,
r,n,ht(t,"_play_match",e,o))}function yt(t,e,r,n){if(!Number.isInteger(n)||n<1)throw w("n_episodes","at least 1",n);let o={seed:$("seed",r),n_episodes:Int32Array.
of(n)},s=ht(t,"_play_rollout",e,o);return Array.from({length:n},(a,i)=>pt(s,i))}var bt=new FinalizationRegistry(([t,e])=>t._world_free(e)),J=class{config;n_agents;n_actions;engine;at;freed=!1;constructor(e,r){this.engine=e,this.config=r,this.
n_agents=r.n_pursuers+r.n_evaders,this.n_actions=r.diagonal?9:5,this.at=K(e,n=>e._world_new(n.arrays(se(r)))),bt.register(this,[e,this.at],this)}free(){this.freed||
(this.freed=!0,bt.unregister(this),this.engine._world_free(this.at))}reset(e={}){let r=dt(e,this.config);this.call(n=>this.engine._world_reset(this.at,n.arrays(
r)))}step(e){let r=ae(e);this.call(n=>this.engine._world_step(this.at,n.arrays(r)))}playTurn(e){let r=ae(e);this.call(n=>this.engine._world_play_turn(this.at,n.
arrays(r)))}decide(e,r,n){let{n_pursuers:o}=this.config,s={pursuer:[0,o],evader:[o,this.n_agents]},[a,i]=typeof r=="string"?s[r]:r;if(n.length!==this.n_agents)throw w(
"actions",String(this.n_agents),n.length);let l=[U(e),ae(n)],{actions:u}=this.call(c=>this.engine._world_decide(this.at,c.arrays(l[0]),a,i,c.arrays(l[1])));return Uint8Array.
from(u)}get n_turns(){return this.turnNumbers()[1]}get turn(){return this.turnNumbers()[0]}get actors(){let[,,e,r]=this.turnNumbers();return[e,r]}turnNumbers(){
return this.call(()=>this.engine._world_turn(this.at)).turn}get steps(){return this.read("steps")[0]}get seed(){return this.read("seed")[0]}get episode(){return this.
read("episode")[0]}get over(){return this.read("terminated")[0]===1||this.read("truncated")[0]===1}read(e){return this.call(r=>this.engine._world_read(this.at,r.
text(e)))[e]}view(e){let r=3*this.config.fov**2;return this.read("views").slice(e*r,(e+1)*r)}map(){return this.read("state").slice(2*this.config.rows*this.config.
cols)}conflicts(){return re(this.conflictTable(),this.config.n_pursuers)}conflictTable(){return this.call(()=>this.engine._world_conflicts(this.at)).conflict_table}answer(e,r){
let n=U(e),{logits:o}=this.call(i=>this.engine._world_logits(this.at,i.arrays(n),r)),s=o,a=this.decide(e,[r,r+1],new Uint8Array(this.n_agents))[r];return{logits:s,
probabilities:Yr(s),action:a}}snapshot(){return this.call(()=>this.engine._world_snapshot(this.at))}restore(e){let r=mt(e);this.call(n=>this.engine._world_restore(
this.at,n.arrays(r)))}call(e){if(this.freed)throw w("world","one that is in use","one that was freed");return K(this.engine,e),ne(this.engine)}};function Yr(t){
let e=Math.max(...t),r=Array.from(t,o=>Math.exp(o-e)),n=r.reduce((o,s)=>o+s,0);return Float32Array.from(r,o=>o/n)}var ke=class{compiled;constructor(e){this.compiled=e}world(e){return new J(this.compiled,e)}match(e,r,n,o,s=0){return ft(this.compiled,{config:e,pursuers:r,evaders:n},
o,s)}rollout(e,r,n,o,s){return yt(this.compiled,{config:e,pursuers:r,evaders:n},o,s)}},gt;function vt(t=globalThis.matrixworldEngine){return gt??=Kr(t),gt}async function Kr(t){
if(!t)throw new Error("matrixworldEngine: expected the script engine.js before this one, got none");let e=Uint8Array.from(atob(t.binary),r=>r.charCodeAt(0));return new ke(
await t({wasmBinary:e}))}var W=["pursuer","evader"];function wt(t){let e=atob(Pe(t)),r=new Uint8Array(e.length);for(let n=0;n<r.length;n++)r[n]=e.charCodeAt(n);return r}function Pe(t){return document.getElementById(
t)?.textContent??""}function m(t,e={},...r){return Jr(document.createElement(t),e,r)}function Jr(t,e,r){for(let[n,o]of Object.entries(e))o==null||o===!1||(typeof o=="function"?t.addEventListener(n.slice(2),o):t.setAttribute(n,o===!0?"":String(o)));
return t.append(...r.filter(qr).map(n=>typeof n=="number"?String(n):n)),t}function qr(t){return t!=null&&t!==!1}var B=(t,e)=>t<e?`pursuer_${t}`:`evader_${t-e}`,Ie=["stay","north","east","south","west","northeast","southeast","southwest","northwest"];var Xr=matchMedia("(prefers-color-scheme: dark)");function Zr(){let t=document.documentElement.dataset.theme;return t?t==="dark":Xr.matches}function Qr(){document.
documentElement.dataset.theme=Zr()?"light":"dark"}function St(){return m("button",{type:"button",title:"Light or dark (D)","aria-label":"Light or dark",onclick:Qr},"◐")}var D=[[0,0],[-1,0],[0,1],[1,0],[0,-1],[-1,1],[1,1],[1,-1],[-1,-1]];function xt(t,e,r){let[n,o]=[e[0]-t[0],e[1]-t[1]];return!r&&Math.abs(n)>Math.abs(o)?o=0:r||(n=
0),D.findIndex(([s,a])=>s===Math.sign(n)&&a===Math.sign(o))}var k=(t,e)=>e<t.nPursuers,b=(t,e)=>[t.positions[2*e],t.positions[2*e+1]],en=(t,e)=>t[0]===e[0]&&t[1]===
e[1],Le=({rows:t,cols:e},[r,n])=>r>=0&&n>=0&&r<t&&n<e,$e=(t,e,r=3)=>t!==void 0&&[0,1,2].slice(0,r).some(n=>t[3*e+n]),Ue=(t,e)=>$e(t.fault,e),At=(t,e)=>!Ue(t,e)&&
$e(t.involved,e,2);function le(t,e,r){let n=!en(b(t,r),b(e,r)),o=e.involved===void 0||$e(e.involved,r);return!!(e.alive[r]&&e.actions?.[r]&&!n&&o)}function ue(t,e,r){
let[n,o]=b(t,r),[s,a]=D[e.actions?.[r]??0];return[n+s,o+a]}function ce(t,e,r){return Array.from({length:r.everCaptured.length},(o,s)=>s).filter(o=>r.everCaptured[o]&&
!e.everCaptured[o]).map(o=>t.nPursuers+o)}function de(t,e){return Array.from({length:e.alive.length},(n,o)=>o).filter(n=>t.alive[n]&&!e.alive[n])}var rn={SIMULTANEOUS:0,SWARM_TURNS:1,AGENT_TURNS:2};function De(t,e,r){return{rows:t.rows,cols:t.cols,nPursuers:t.n_pursuers,fov:t.fov,interaction:rn[t.rules.interaction],
obstacles:e,moments:r}}function me(t,e){return{positions:t.read("last_positions"),alive:t.read("alive"),captured:t.read("captured"),everCaptured:t.read("ever_ca\
ptured"),actions:e,involved:t.read("involved"),fault:t.read("fault"),contested:t.conflicts().map(r=>r.cell)}}var q=class{config;start;recording;actions=[];#e;#o;#r=[[]];constructor(e,r,n){[this.config,this.start]=[r,n],this.#e=e.world(r),this.#e.reset(n),this.#o=[me(this.#e)],
this.recording=De(r,this.#e.map(),this.#o)}get length(){return this.actions.length}get over(){return this.#e.over}get statistics(){return{capture_rate:this.#e.read(
"capture_rate")[0]}}conflicts(e){return this.#r[e]}play(e){this.#e.step(e),this.#i(e)}step(e,r,n){let[o,s]=[this.#e,this.config.n_pursuers],a=new Uint8Array(o.n_agents);
for(let i=o.n_turns;i>0&&!o.over;--i){let[l,u]=o.actors;l<s&&(a=o.decide(e.pursuer,[l,Math.min(u,s)],a)),u>s&&(a=o.decide(e.evader,[Math.max(l,s),u],a)),typeof n==
"number"?a[r]=n:l<=r&&r<u&&(a=o.decide(n,[r,r+1],a)),o.playTurn(a)}this.#i(a)}#i(e){this.actions.push(e),this.#o.push(me(this.#e,e)),this.#r.push(this.#e.conflicts())}};
function Ct(t,e,r,n){let o=new q(t,e,r);for(let s of n)o.play(s);return o}var P=(t,e)=>W[+(e>=t.n_pursuers)];function Fe(t,e){let r=new q(t,e.config,{seed:e.seed,episode:e.episode});for(let n of e.moves)r.over||r.step(e.policies,e.seat,
n);return r}function R(t,e){let{moments:r,nPursuers:n}=t.recording,o=r.findIndex(({alive:a,captured:i})=>!a[e]||!!i[e-n]),s=o<0?t.length:o;return{lasted:s,out:o>=
0,captured:Array.from(r[s].everCaptured).filter(Boolean).length}}var pe=(t,e)=>t.over||R(t,e).out;function Mt(t,e,r){let n=Fe(t,{...e,moves:e.moves.slice(0,e.from)});
for(;!pe(n,e.seat);)n.step(e.policies,e.seat,r);return R(n,e.seat)}function he(t){let e=t.length-1;return[...new Set([0,Math.round(e/3),e])].map(r=>t[r])}function _t(t,{
seat:e,from:r,moves:n}){let o={...t,seat:e,...r?{from:r}:{},moves:n.join("")};return`${location.href.split("#")[0]}#${Object.entries(o).map(([s,a])=>`${s}=${a}`).
join("&")}`}function Tt(t,e){let[r,n,o]=[t.get("seat")??"",t.get("from")??"0",t.get("moves")??""];return/^\d{1,6}$/.test(r)&&Number(r)<e.n_pursuers+e.n_evaders&&
(e.diagonal?/^[0-8]+$/:/^[0-4]+$/).test(o)&&o.length<=e.max_steps&&/^\d{1,6}$/.test(n)&&Number(n)<=o.length?{seat:Number(r),from:Number(n),moves:[...o].map(Number)}:
null}var fe=()=>crypto.getRandomValues(new BigUint64Array(1))[0];function Et(t,e,r,n){let o=P(r.config,r.seat)==="evader",s=o?r.config.max_steps:r.config.n_evaders,a=m("table",{class:"numbers"},m("caption",{},o?"Steps in your\
 seat: same start, same others":"Captures of your team: same start, same others")),i=l=>{let[u,c]=[m("span",{class:o?"bar evader":"bar pursuer"}),m("td",{},"…")];
return a.append(m("tr",{},m("th",{scope:"row"},l),m("td",{class:"track","aria-hidden":"true"},u),c)),({lasted:d,captured:h})=>{u.style.width=`${100*(o?d:h)/s}%`,
c.textContent=String(o?d:h)}};i("You")(R(e,r.seat));for(let{name:l,policy:u}of n){let c=i(l);setTimeout(()=>c(Mt(t,r,u())))}return m("div",{},a,m("p",{class:"sm\
all muted"},"One match: luck has its part in it."))}var nn=20,je=60;function on(t){let e=t.rules.capture==="SURROUND"?8:4,r=typeof t.obstacles!="number",n=o=>r?o:Math.min(o,nn);return{...t,rows:n(t.rows),cols:n(t.
cols),max_steps:je,n_evaders:1,n_pursuers:Math.min(t.n_pursuers,e)}}function ye(t,e,r){let[n,o,s]=[on(e),he(r),[]],a=()=>`${s.reduce((l,u)=>l+u,0)} of ${je*o.length}`,
i=()=>t.play({title:`Can you escape? Round ${s.length+1} of ${o.length}: ${o[s.length].name}`,played:{config:n,seed:fe(),episode:0,seat:n.n_pursuers,from:0,moves:[],
policies:{pursuer:o[s.length].policy(),evader:"still"}},ending:l=>{s.push(R(l,n.n_pursuers).lasted);let u=o.map(({name:d},h)=>m("tr",{},m("th",{scope:"row"},d),
m("td",{},s[h]??""))),c=s.length<o.length;return[m("table",{class:"numbers"},m("caption",{},`Steps of ${je} in each round`),...u),m("p",{class:"play-score"},c?"\
Score so far: ":"Your score: ",m("strong",{},a())),c?m("button",{type:"button",class:"primary",onclick:i},"Next round"):""]},again:()=>ye(t,e,r),link:()=>null});
i()}var sn={"|b1":Uint8Array,"|u1":Uint8Array,"|i1":Int8Array,"<i4":Int32Array,"<i8":BigInt64Array,"<f4":Float32Array},He=[147,...new TextEncoder().encode("NUMPY"),
1,0],an=67324752,ln=33639248,Nt=101010256,Ot=8,Rt=2**28,j=async t=>new Uint8Array(await new Blob([...t]).arrayBuffer());async function kt(t,e){let r=new Blob([t]).
stream().pipeThrough(e).getReader(),n=[],o=0;for(let{done:s,value:a}=await r.read();!s;{done:s,value:a}=await r.read()){if((o+=a.length)>Rt)throw new RangeError(
`expected at most ${Rt} bytes`);n.push(a)}return j(n)}function F(...t){return Uint8Array.from(t.flatMap(([e,r])=>Array.from({length:r},(n,o)=>e>>>8*o&255)))}function un({
dtype:t,shape:e,data:r}){let n=typeof r=="string"?Array.from(r,l=>l.codePointAt(0)):null,o=n?`<U${n.length}`:t,s=e.map(l=>`${l}, `).join(""),a=`{'descr': '${o}'\
, 'fortran_order': False, 'shape': (${s}), }`,i=a.padEnd(Math.ceil((He.length+2+a.length+1)/64)*64-He.length-3)+`
`;return j([Uint8Array.from(He),F([i.length,2]),i,n?Int32Array.from(n):r])}var cn=Int32Array.from({length:256},(t,e)=>{let r=e;for(let n=0;n<8;++n)r=r>>>1^(r&1?
3988292384:0);return r});function dn(t){return~t.reduce((e,r)=>e>>>8^cn[(e^r)&255],-1)}async function Pt(t){let[e,r]=[[],[]],n=0;for(let[i,l]of Object.entries(t)){
let[u,c]=[new TextEncoder().encode(`${i}.npy`),await un(l)],d=await kt(c,new CompressionStream("deflate-raw")),h=F([20,2],[0,2],[Ot,2],[0,2],[33,2],[dn(c),4],[d.
length,4],[c.length,4],[u.length,2],[0,2]),p=await j([F([an,4]),h,u,d]);e.push(p),r.push(await j([F([ln,4],[20,2]),h,F([0,2],[0,2],[0,2],[0,4],[n,4]),u])),n+=p.
length}let o=await j(r),s=e.length,a=F([Nt,4],[0,2],[0,2],[s,2],[s,2],[o.length,4],[n,4],[0,2]);return j([...e,o,a])}async function It(t){let e=new DataView(t.buffer),
r=t.length-22;for(;e.getUint32(r,!0)!==Nt;)--r;let n={},o=e.getUint32(r+16,!0);for(let s=e.getUint16(r+10,!0);s>0;--s){let a=p=>e.getUint16(o+p,!0),[i,l,u]=[a(10),
e.getUint32(o+20,!0),e.getUint32(o+42,!0)],c=new TextDecoder().decode(t.subarray(o+46,o+46+a(28))),d=u+30+e.getUint16(u+26,!0)+e.getUint16(u+28,!0),h=t.slice(d,
d+l);n[c.replace(/\.npy$/,"")]=mn(i===Ot?await kt(h,new DecompressionStream("deflate-raw")):h),o+=46+a(28)+a(30)+a(32)}return n}function mn(t){let e=new DataView(
t.buffer).getUint16(8,!0),r=new TextDecoder().decode(t.subarray(10,10+e)),n=/'descr': '([^']+)', 'fortran_order': False, 'shape': \(([\d, ]*)\)/.exec(r);if(!n)throw new TypeError(
`expected an array, got ${r.slice(0,80)}`);let[o,s]=[n[1],n[2].split(",").filter(l=>l.trim()).map(Number)],a=t.slice(10+e).buffer;if(o.startsWith("<U")){let l=Array.
from(new Int32Array(a)).filter(Boolean);return{dtype:o,shape:s,data:l.map(u=>String.fromCodePoint(u)).join("")}}let i=sn[o];if(!i)throw new TypeError(`expected \
numbers, got ${o}`);return{dtype:o,shape:s,data:o==="<i8"?Int32Array.from(new BigInt64Array(a),Number):new i(a)}}var Ge="matrixworld episode 3";async function Lt(t,e,r){let{config:n,actions:o,length:s,recording:a}=e,[i,l]=[n.n_pursuers+n.n_evaders,n.n_evaders],u={positions:[
"<i4",i,2],last_positions:["<i4",i,2],alive:["|b1",i],captured:["|b1",l],ever_captured:["|b1",l]},c={rewards:["<f4",i],involved:["|b1",i,3],fault:["|b1",i,3]},d={},
h=g=>{for(let M of Object.keys(g))(d[M]??=[]).push(Array.from(p.read(M),Number))},p=t.world(n);p.reset(e.start);let f=[];h(u);for(let g of o)p.step(g),h({...u,...c}),
f.push(...p.conflictTable());p.free();let y={"<i4":Int32Array,"<f4":Float32Array,"|b1":Uint8Array},v={};for(let[g,[M,...xe]]of Object.entries({...u,...c})){let Pr=s+
+(g in u);v[g]={dtype:M,shape:[Pr,...xe],data:y[M].from((d[g]??[]).flat())}}let C=g=>({dtype:"<i4",shape:[],data:Int32Array.of(g)}),T=g=>({dtype:"<U",shape:[],data:g});
return Pt({format:T(Ge),n_pursuers:C(n.n_pursuers),config:T(JSON.stringify(n)),seat:C(r),...v,actions:{dtype:"|i1",shape:[s,i],data:Int8Array.from(o.flatMap(g=>[
...g]))},map:{dtype:"|b1",shape:[n.rows,n.cols],data:Uint8Array.from(a.obstacles,Number)},conflict_table:{dtype:"<i4",shape:[f.length/11,11],data:Int32Array.from(
f)}})}async function $t(t,e){let r=await It(e).catch(()=>({})),n=p=>Array.from(r[p]?.data??[]);if(r.format?.data!==Ge)throw new S(`expected a file marked "${Ge}\
"`);let o=JSON.parse(r.config.data),s=o.n_pursuers+o.n_evaders,a=n("positions"),i=(p,f)=>Array.from({length:f-p},(y,v)=>[a[2*(p+v)],a[2*(p+v)+1]]),l={pursuers:i(
0,o.n_pursuers),evaders:i(o.n_pursuers,s),obstacles:Uint8Array.from(n("map"))},u=Uint8Array.from(n("actions")),c=Array.from({length:u.length/s},(p,f)=>u.subarray(
f*s,(f+1)*s)),d=Ct(t,o,l,c);if(Array.from(d.recording.moments.at(-1).positions).join()!==n("last_positions").slice(-2*s).join())throw new S("expected the moves \
of this start to lead to its end");return{live:d,seat:n("seat")[0]??null}}var Ut=[-.31,0,.31],Wt=[{size:1,at:[[0,0]]},{size:.62,at:[[-.2,.2],[.2,-.2]]},{size:.54,at:[[-.23,.22],[.23,.22],[0,-.22]]},{size:.54,at:[[-.23,.23],[.23,.23],[
-.23,-.23],[.23,-.23]]},{size:.36,at:Ut.flatMap(t=>Ut.map(e=>[e,t]))}],pn=.3,hn=.35,fn=.55;function X(t,e){let r=new Map;for(let n=0;n<e.alive.length;n++){if(!e.
alive[n])continue;let[o,s]=b(e,n),a=o*t.cols+s,i=r.get(a);i?i.push(n):r.set(a,[n])}return r}function Bt(t,e){let r=Array.from(e.alive,(n,o)=>{let[s,a]=b(e,o);return{
x:a+.5,y:s+.5,size:1,alpha:0}});for(let n of X(t,e).values()){let o=Wt[Math.min(n.length,Wt.length)-1];n.forEach((s,a)=>{let[i,l]=o.at[Math.min(a,o.at.length-1)],
u=r[s];u.x+=i,u.y+=l,u.size=o.size,u.alpha=1})}return r}var Dt=t=>t*t*(3-2*t),H=(t,e,r)=>t+(e-t)*r,Ft=t=>Math.min(1,Math.max(0,t));function jt(t,e,r,n){let o={1:2,
2:r}[t.interaction]??1;if(o===1)return Dt(n);let s=o===r?e:+!k(t,e),a=Math.max(1/o,hn);return Dt(Ft((n-s/(o-1)*(1-a))/a))}function be(t,e){let r=t.moments.length-
1,n=Math.min(Math.floor(e),r),o=t.moments[n],s=Bt(t,o);if(n===r||e===n)return s;let a=t.moments[n+1],i=Bt(t,a);return s.map((l,u)=>{let c=jt(t,u,s.length,e-n);return yn(
o,a,u,l,i[u],c)})}function ze(t,e,r){let n=t.moments.length-1,o=Math.min(Math.floor(r),n),[s,a]=[t.moments[o],t.moments[Math.min(o+1,n)]],i=jt(t,e,s.alive.length,
r-o),[[l,u],[c,d]]=[b(s,e),b(a,e)];return[H(u,d,i)+.5,H(l,c,i)+.5]}function yn(t,e,r,n,o,s){let a=n.alpha>o.alpha,i={x:H(n.x,o.x,s),y:H(n.y,o.y,s),size:a?n.size:
H(n.size,o.size,s),alpha:a?Ft((1-s)/(1-fn)):H(n.alpha,o.alpha,s)};if(le(t,e,r)){let[l,u]=b(t,r),[c,d]=ue(t,e,r),h=pn*Math.sin(Math.PI*s);i.x+=(d-u)*h,i.y+=(c-l)*
h}return i}var Ht=2*Math.PI;function Z(t,e,r,n){t.beginPath(),t.arc(e,r,n/2,0,Ht)}function Gt(t,e,r,n){let o=n/2,s=[[0,-.97],[.97,.83],[-.97,.83]].map(([a,i])=>[e+a*o,r+i*
o]);t.beginPath(),t.moveTo((s[2][0]+s[0][0])/2,(s[2][1]+s[0][1])/2),s.forEach(([a,i],l)=>{let[u,c]=s[(l+1)%3];t.arcTo(a,i,u,c,n*.09)}),t.closePath()}function zt(t,e,r,n){
let o=n*.32;t.beginPath(),t.moveTo(e-o,r-o),t.lineTo(e+o,r+o),t.moveTo(e+o,r-o),t.lineTo(e-o,r+o)}function Vt(t,e,r,n){t.beginPath();for(let o=0;o<16;o++){let s=n/
2*(o%2?.6:.95),a=Ht*o/16;t.lineTo(e+s*Math.sin(a),r-s*Math.cos(a))}t.closePath()}function Yt(t,e,r,n,o,s){let a=Math.atan2(o-r,n-e);t.beginPath(),t.moveTo(e,r),
t.lineTo(n,o);for(let i of[-1,1])t.moveTo(n,o),t.lineTo(n-s*Math.cos(a+i*.6),o-s*Math.sin(a+i*.6))}var Kt=4,bn=1.6,gn=.95,vn=5,wn=.16,Sn=9,xn=.09,An=.2,Jt=.75,x=(t,e)=>t.left+e*t.cell,A=(t,e)=>t.top+e*t.cell;function G(t,e,r){return k(e,r)?t.colors.pursuer:t.
colors.evader}function qt({ctx:t,grid:e,colors:r}){let{left:n,top:o,cell:s,rows:a,cols:i}=e,[l,u]=[i*s,a*s];if(t.fillStyle=r.paper,t.fillRect(n,o,l,u),s<vn)return;
t.fillStyle=r.line;let c=Math.max(1,Math.round(s/60));for(let d=1;d<i;d++)t.fillRect(n+d*s,o,c,u);for(let d=1;d<a;d++)t.fillRect(n,o+d*s,l,c)}function Xt({ctx:t,
grid:e,colors:r},n){let{left:o,top:s,cell:a,rows:i,cols:l}=e;t.fillStyle=r.obstacle;for(let c=0;c<i*l;c++){if(!n.obstacles[c])continue;let[d,h]=[Math.floor(c/l),
c%l];t.fillRect(o+h*a,s+d*a,a,a)}let u=Math.min(5,Math.max(2,Math.round(a/18)));t.strokeStyle=r.frame,t.lineWidth=u,t.strokeRect(o-u/2,s-u/2,l*a+u,i*a+u)}function Zt({
ctx:t,grid:e,colors:r},n){let{left:o,top:s,cell:a,rows:i,cols:l}=e,u=a<24*n?5:1;t.font=`500 ${Math.round(Math.min(15*n,Math.max(9*n,a*.32)))}px system-ui, sans-\
serif`,t.fillStyle=r.muted,t.textBaseline="alphabetic",t.textAlign="center";let c=5*n+a/40;for(let d=0;d<l;d+=u)t.fillText(String(d),o+(d+.5)*a,s-c);t.textAlign=
"right",t.textBaseline="middle";for(let d=0;d<i;d+=u)t.fillText(String(d),o-c,s+(d+.5)*a)}function Qt({grid:t},e,r,n){let o=Math.floor(e.fov/2)+.5,[s,a]=[Math.max(
0,r-o),Math.min(t.cols,r+o)],[i,l]=[Math.max(0,n-o),Math.min(t.rows,n+o)];return[x(t,s),A(t,i),(a-s)*t.cell,(l-i)*t.cell]}function er(t,e,r,n){let{ctx:o,grid:s,
colors:a}=t;o.beginPath(),o.rect(0,0,o.canvas.width,o.canvas.height),o.rect(...Qt(t,e,r,n)),o.save(),o.clip("evenodd"),o.fillStyle=a.line,o.fillRect(s.left,s.top,
s.cols*s.cell,s.rows*s.cell),o.restore()}function tr({ctx:t,grid:e,colors:r},{x:n,y:o,alpha:s},a){let i=Math.max(e.cell,16*a)*1.06,[l,u]=[x(e,n),A(e,o)];t.globalAlpha=
Math.max(s,.6),t.beginPath(),t.roundRect(l-i/2,u-i/2,i,i,i*.2),t.strokeStyle=r.focus,t.lineWidth=Math.max(2,2.5*a),t.stroke();let c=Math.max(11*a,Math.min(18*a,
e.cell*.5));t.font=`700 ${Math.round(c)}px system-ui, sans-serif`,t.textAlign="center",t.textBaseline="middle";let d=u-i/2<c*1.2,h=u+(d?1:-1)*(i/2+c*.7);t.strokeStyle=
r.paper,t.lineJoin="round",t.lineWidth=c*.35,t.strokeText("You",l,h),t.fillStyle=r.ink,t.fillText("You",l,h),t.globalAlpha=1}function rr(t,e,r,n,o){let{ctx:s,grid:a}=t,
i=Qt(t,e,n,o),l=G(t,e,r);s.globalAlpha=.11,s.fillStyle=l,s.fillRect(...i),s.globalAlpha=.8,s.strokeStyle=l,s.lineWidth=Math.max(1,a.cell/24),s.strokeRect(...i),
s.globalAlpha=1}function nr(t,e,r,n,o){let{ctx:s,grid:a}=t,i=Math.min(Math.ceil(r),e.moments.length-1),l=e.moments[i];s.lineCap="round",s.lineWidth=Math.min(Sn,
Math.max(1,a.cell*wn));for(let u=Math.max(1,Math.floor(r-n)+1);u<=i;u++){let[c,d]=[e.moments[u-1],e.moments[u]],h=Math.max(0,Math.min(1,(r-u)/n));s.globalAlpha=
Jt+(An-Jt)*h;for(let p=0;p<d.alive.length;p++){let f=u===i&&r<i;if(!c.alive[p]||!(l.alive[p]||f))continue;let y=(k(e,p)?-1:1)*xn,[v,C]=b(c,p),[T,g]=b(d,p);if(v===
T&&C===g)continue;let M=f?o[p].x:g+.5,xe=f?o[p].y:T+.5;s.strokeStyle=G(t,e,p),s.beginPath(),s.moveTo(x(a,C+.5+y),A(a,v+.5+y)),s.lineTo(x(a,M+y),A(a,xe+y)),s.stroke()}}
s.globalAlpha=1}function or(t,e,r){let n=Math.min(Math.ceil(r),e.moments.length-1);for(let o=Math.max(1,n-Kt+1);o<=n;o++){let[s,a]=[e.moments[o-1],e.moments[o]],
i=o>r?Math.max(0,1-2*(o-r)):1-(r-o)/Kt,l=ce(e,s,a);for(let u of de(s,a))l.includes(u)||Mn(t,b(a,u),i);for(let u of l)Cn(t,b(a,u),i)}t.ctx.globalAlpha=1}function Cn({
ctx:t,grid:e,colors:r},[n,o],s){t.globalAlpha=s,Vt(t,x(e,o+.5),A(e,n+.5),Math.max(8,e.cell*bn)),t.fillStyle=r.capture,t.fill(),t.strokeStyle=r.ink,t.lineWidth=Math.
max(1,e.cell/36),t.lineJoin="round",t.stroke()}function Mn({ctx:t,grid:e,colors:r},[n,o],s){t.globalAlpha=s,zt(t,x(e,o+.5),A(e,n+.5),Math.max(7,e.cell*gn)),t.strokeStyle=
r.collision,t.lineWidth=Math.max(2,e.cell*.17),t.lineCap="round",t.stroke()}function sr({ctx:t,grid:e,colors:r},n,o){let s=Math.max(1,e.cell*.07);t.strokeStyle=
t.fillStyle=r.collision,t.lineWidth=Math.max(1,e.cell*.05),t.setLineDash([e.cell*.14,e.cell*.1]);for(let[a,i]of n){if(a<0||i<0||a>=e.rows||i>=e.cols)continue;let l=[
x(e,i)+s,A(e,a)+s,e.cell-2*s,e.cell-2*s];t.globalAlpha=.2*o,t.fillRect(...l),t.globalAlpha=o,t.strokeRect(...l)}t.setLineDash([]),t.globalAlpha=1}function ar({ctx:t,
grid:e,colors:r},n,o,s,a){t.globalAlpha=a,Z(t,x(e,n),A(e,o),Math.max(8,e.cell*s*1.02)),t.strokeStyle=r.collision,t.lineWidth=Math.max(1.5,e.cell*.085*Math.sqrt(
s)),t.stroke(),t.globalAlpha=1}var _n=.8,Tn=.92,En=15,Rn=7,Ve=9;function ir(t,e,r,n,o,s){n.forEach((a,i)=>{a.alpha>0&&Nn(t,e,r,i,a,o,s)}),t.ctx.globalAlpha=1;for(let a of X(e,r).values())a.length>
Ve&&On(t,n[a[Ve-1]],a.length-Ve+1)}function Nn(t,e,r,n,o,s,a){let{ctx:i,grid:l,colors:u}=t,c=k(e,n),[d,h]=[l.left+o.x*l.cell,l.top+o.y*l.cell],p=Math.max(4,l.cell*
o.size*(c?Tn:_n)),f=G(t,e,n),y=!c&&!!r.captured[n-e.nPursuers];if(i.globalAlpha=o.alpha,(c?Gt:Z)(i,d,h,p),p>Rn*a&&(i.strokeStyle=u.paper,i.lineWidth=Math.max(2,
p*.1),i.stroke()),i.fillStyle=y?u.paper:f,i.fill(),y&&(Z(i,d,h,p*.82),i.strokeStyle=f,i.lineWidth=p*.18,i.stroke()),!s||p<En*a)return;let v=String(c?n:n-e.nPursuers);
i.font=`700 ${Math.round(p*(c?.4:.5)*(v.length>1?.8:1))}px system-ui, sans-serif`,i.textAlign="center",i.textBaseline="middle",i.fillStyle=y?f:u.paper,i.fillText(
v,d,h+p*(c?.17:.03))}function On({ctx:t,grid:e,colors:r},n,o){let[s,a]=[e.left+n.x*e.cell,e.top+n.y*e.cell];t.font=`700 ${Math.round(e.cell*.3)}px system-ui, sa\
ns-serif`,t.textAlign="center",t.textBaseline="middle",t.strokeStyle=r.paper,t.lineWidth=e.cell*.1,t.strokeText(`+${o}`,s,a),t.fillStyle=r.ink,t.fillText(`+${o}`,
s,a)}var kn=.46,Pn=.86,In=.66,lr=.48,Ln=.78,$n=.58;function ur(t,e,r,n){let[o,s]=[e.moments[r-1],e.moments[r]];if(!o)return;let{ctx:a,grid:i,colors:l}=t;a.strokeStyle=
l.collision,a.lineWidth=Math.max(1.5,i.cell*.07),a.lineCap="butt",a.globalAlpha=n;for(let u=0;u<s.alive.length;u++)le(o,s,u)&&Un(t,e,b(o,u),ue(o,s,u));a.globalAlpha=
1}function Un({ctx:t,grid:e},r,n,o){let[s,a]=[o[1]-n[1],o[0]-n[0]],i=d=>x(e,n[1]+.5+s*d),l=d=>A(e,n[0]+.5+a*d),u=Le(r,o)?Ln:$n;t.setLineDash([e.cell*.09,e.cell*
.06]),t.beginPath(),t.moveTo(i(lr),l(lr)),t.lineTo(i(u),l(u)),t.stroke(),t.setLineDash([]);let c=.17*e.cell/Math.hypot(s,a);t.beginPath(),t.moveTo(i(u)-a*c,l(u)+
s*c),t.lineTo(i(u)+a*c,l(u)-s*c),t.stroke()}function cr(t,e,r,n,o,s){let a=D[s];if(!s||!a)return;let{ctx:i,grid:l,colors:u}=t,c=Le(e,[n[0]+a[0],n[1]+a[1]])?Pn:In,
d=kn*o.size,h=[x(l,o.x+a[1]*d),A(l,o.y+a[0]*d),x(l,o.x+a[1]*c),A(l,o.y+a[0]*c)],p=Math.max(1.5,l.cell*.085);i.lineCap=i.lineJoin="round";for(let[f,y]of[[u.paper,
p*2.1],[G(t,e,r),p]])i.strokeStyle=f,i.lineWidth=y,Yt(i,...h,l.cell*.2),i.stroke()}var mr={numbers:!0,axes:!1,trail:6,viewers:[],plan:null,selected:null,cursor:null,you:null,fog:!1};function pr(t,e,r,n,o){let{ctx:s,grid:a,colors:i}=t,l=Math.min(
Math.ceil(r),e.moments.length-1),u=e.moments[l],c=r===l,d=be(e,r),h=c?1:Math.max(0,1-2*(l-r));s.clearRect(0,0,s.canvas.width,s.canvas.height),qt(t);for(let y of n.
viewers)d[y]?.alpha&&rr(t,e,y,...ze(e,y,r));Xt(t,e),n.axes&&Zt(t,o),nr(t,e,r,n.trail,d),sr(t,u.contested??[],h),or(t,e,r),ur(t,e,l,h),d.forEach(({x:y,y:v,size:C},T)=>{
let g=At(u,T)?.4:0,M=Ue(u,T)?1:g;M&&ar(t,y,v,C,M*h)});let p=c?u:e.moments[Math.max(0,l-1)];if(ir(t,e,p,d,n.numbers,o),c&&n.plan)for(let[y,v]of d.entries())v.alpha&&
cr(t,e,y,b(u,y),v,n.plan[y]??0);n.you!==null&&(n.fog&&er(t,e,...ze(e,n.you,r)),tr(t,d[n.you],o)),s.lineWidth=Math.max(2,2.5*o),s.strokeStyle=i.focus;let f=n.selected===
null?void 0:d[n.selected];f?.alpha&&dr(t,f.x,f.y,f.size*.96),n.cursor&&(s.setLineDash([a.cell*.12,a.cell*.08]),dr(t,n.cursor[1]+.5,n.cursor[0]+.5,.8),s.setLineDash(
[]))}function dr({ctx:t,grid:e},r,n,o){let s=o*e.cell;t.beginPath(),t.roundRect(e.left+r*e.cell-s/2,e.top+n*e.cell-s/2,s,s,s*.1),t.stroke()}var hr=(t,e)=>(e+.24)/(t+.24);function fr(t,e,r,n,o,s){let a=r?28*s:0,i=(u,c)=>(u-a)/(c+2*.12),l=Math.max(1,Math.floor(Math.min(i(n,e),i(o,t))));return{rows:t,cols:e,
cell:l,left:Math.round((n-e*l+a)/2),top:Math.round((o-t*l+a)/2)}}function yr(t,e,r){let n=Math.floor((r-t.top)/t.cell),o=Math.floor((e-t.left)/t.cell);return n>=
0&&n<t.rows&&o>=0&&o<t.cols?[n,o]:null}var Wn={paper:"--board-paper",line:"--board-line",frame:"--board-frame",ink:"--board-ink",muted:"--board-muted",obstacle:"--board-obstacle",pursuer:"--pursuer",
evader:"--evader",capture:"--capture",collision:"--collision",focus:"--focus"};function br(t){let e=getComputedStyle(t),r=Object.entries(Wn).map(([n,o])=>[n,e.getPropertyValue(
o).trim()]);return Object.fromEntries(r)}var ve=()=>matchMedia("(prefers-reduced-motion: reduce)").matches,ge=class{canvas;#e=null;#o=0;#r;#i={rows:1,cols:1,left:0,top:0,cell:1};#t=0;#s;#n;constructor(e,r={}){
this.canvas=e,e.classList.add("board"),e.setAttribute("role","img"),this.#r={...mr,...r},this.#s=new ResizeObserver(()=>this.#d()),this.#s.observe(e),this.#n=new MutationObserver(
()=>this.redraw()),this.#n.observe(document.documentElement,{attributes:!0}),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",this.redraw)}close(){
this.#s.disconnect(),this.#n.disconnect(),matchMedia("(prefers-color-scheme: dark)").removeEventListener("change",this.redraw),cancelAnimationFrame(this.#t)}get look(){
return this.#r}set look(e){this.#r={...this.#r,...e},this.#c(),this.redraw()}get time(){return this.#o}show(e,r){this.#e=e,this.#o=Math.min(Math.max(0,r),e.moments.
length-1),this.#c(),this.redraw()}redraw=()=>{this.#t||(this.#t=requestAnimationFrame(()=>this.drawNow()))};drawNow(){cancelAnimationFrame(this.#t),this.#t=0;let e=this.
canvas.getContext("2d");if(!e||!this.#e)return;let{rows:r,cols:n}=this.#e,o=devicePixelRatio||1;this.#i=fr(r,n,this.#r.axes,this.canvas.width,this.canvas.height,
o);let s={ctx:e,grid:this.#i,colors:br(this.canvas)};pr(s,this.#e,this.#o,this.#r,o)}cellAt(e,r){let n=this.canvas.getBoundingClientRect(),o=this.canvas.width/n.
width;return yr(this.#i,(e-n.left)*o,(r-n.top)*o)}agentAt(e,r){let n=this.cellAt(e,r);if(!n||!this.#e)return null;let o=this.#e.moments[Math.round(this.#o)],s=X(
this.#e,o).get(n[0]*this.#e.cols+n[1])??[],a=be(this.#e,Math.round(this.#o)),i=l=>{let[u,c]=this.pointOf(a[l].x,a[l].y);return Math.hypot(u-e,c-r)};return s.length?
s.reduce((l,u)=>i(u)<i(l)?u:l):null}pointOf(e,r){let n=this.canvas.getBoundingClientRect(),o=n.width/this.canvas.width,{left:s,top:a,cell:i}=this.#i;return[n.left+
(s+e*i)*o,n.top+(a+r*i)*o]}#c(){if(!this.#e)return;let{rows:e,cols:r}=this.#e;this.canvas.style.setProperty("--board-aspect",String(hr(e,r)))}#d(){let e=devicePixelRatio||
1,{width:r,height:n}=this.canvas.getBoundingClientRect();this.canvas.width=Math.max(1,Math.round(r*e)),this.canvas.height=Math.max(1,Math.round(n*e)),this.drawNow()}};var Bn={now:()=>performance.now(),request:t=>requestAnimationFrame(t),cancel:t=>cancelAnimationFrame(t)},Q=[.5,1,2,4,8,16,32,64],gr=0,Ye=12,Dn=2,ee=class extends EventTarget{#e;#o;#r;#i;#t=0;#s=0;#n=!1;#c=null;#d=0;#h=[];glide=.28;constructor(e,r={}){
super(),this.#e=e,this.#o=r.speed??4,this.#i=r.still??!1,this.#r=r.clock??Bn}get step(){return this.#t}get time(){return this.#i?this.#t:this.#s}get arrived(){return this.#s===
this.#t}get playing(){return this.#n}get length(){return this.#e}set length(e){this.#e=e,this.#t>e&&this.jump(e),this.#l("state")}get marks(){return this.#h}set marks(e){
this.#h=e,this.#l("state")}get pace(){return this.#o||Math.max(Dn,this.#e/Ye)}get speed(){return this.#o}set speed(e){this.#o=e,this.#l("state")}changeSpeed(e){
let r=Q.findIndex(n=>n>=this.pace);this.speed=Q[Math.min(Q.length-1,Math.max(0,r+e))]}play(){this.#n||!this.#e||(this.#t===this.#e&&this.jump(0),this.#n=!0,this.#l(
"state"),this.#a())}pause(){this.#n&&(this.#n=!1,this.#l("state"))}toggle(){this.#n?this.pause():this.play()}move(e){this.pause();let r=Math.min(this.#e,Math.max(
0,this.#t+e));Math.abs(r-this.#s)>1?this.jump(r):this.#u(r),this.#a()}jump(e){this.#s=Math.min(this.#e,Math.max(0,Math.round(e))),this.#u(this.#s),this.#l("fram\
e")}#u(e){e!==this.#t&&(this.#t=e,this.#l("step"),this.#i&&this.#l("frame"))}#a(){this.#c===null&&(this.#d=this.#r.now(),this.#c=this.#r.request(()=>this.#p()))}#p(){
this.#c=null;let e=this.#r.now();this.#m(Math.min(.25,(e-this.#d)/1e3)),this.#d=e,(!this.#i||this.arrived)&&this.#l("frame"),(this.#n||this.#s!==this.#t)&&(this.#c=
this.#r.request(()=>this.#p()))}#m(e){let r=e;for(;r>0;){if(this.#s===this.#t){if(!this.#n)return;if(this.#t===this.#e)return this.pause();this.#u(this.#t+1)}let n=this.#n?
this.pace:1/this.glide,o=this.#t-this.#s,s=Math.min(Math.abs(o),r*n);r-=s/n,this.#s=s===Math.abs(o)?this.#t:this.#s+Math.sign(o)*s}this.#n&&this.#s===this.#e&&this.
pause()}#l(e){this.dispatchEvent(new Event(e))}};function we(t,e){if(e.ctrlKey||e.metaKey||e.altKey)return!1;let r=e.shiftKey?10:1,o={" ":()=>t.toggle(),ArrowRight:()=>t.
move(r),ArrowLeft:()=>t.move(-r),Home:()=>t.move(-t.length),End:()=>t.move(t.length),"+":()=>t.changeSpeed(1),"-":()=>t.changeSpeed(-1)}[e.key];return o?.(),o!==
void 0}var Fn={first:"M6 5v14M19 5 9 12l10 7z",back:"M17 5 7 12l10 7z",play:"M7 4.5 19 12 7 19.5z",pause:"M8 5v14M16 5v14",forward:"M7 5l10 7-10 7z",last:"M18 5v14M5 5\
l10 7-10 7z"};function vr(t){let e=document.createElementNS("http://www.w3.org/2000/svg","svg");e.setAttribute("viewBox","0 0 24 24"),e.setAttribute("aria-hidde\
n","true"),e.classList.add("icon");let r=document.createElementNS("http://www.w3.org/2000/svg","path");return r.setAttribute("d",Fn[t]),e.append(r),e}function te(t,e,r,n){
let o=document.createElement("button");return o.type="button",o.className="player-button",o.append(vr(t)),o.ariaLabel=e,o.title=`${e} (${r})`,o.addEventListener(
"click",n),o}function wr(t){let e=document.createElement("div");e.className="player",e.role="group",e.ariaLabel="Player";let r=te("play","Play","Space",()=>t.toggle()),
n=jn(t),o=m("div",{class:"captures","aria-hidden":"true",title:"Captures"}),s=Hn(t),a=document.createElement("output");a.className="player-count",e.append(te("f\
irst","First step","Home",()=>t.move(-t.length)),te("back","Step back","←",()=>t.move(-1)),r,te("forward","Step forward","→",()=>t.move(1)),te("last","Last \
step","End",()=>t.move(t.length)),m("div",{class:"scrub"},o,n),a,s);let i=()=>o.replaceChildren(...t.marks.map(u=>{let c=m("i");return c.style.left=`${100*u/Math.
max(1,t.length)}%`,c})),l=()=>{r.replaceChildren(vr(t.playing?"pause":"play")),r.ariaLabel=t.playing?"Pause":"Play",r.title=`${r.ariaLabel} (Space)`,n.max=String(
t.length),n.value=String(t.step),n.ariaValueText=`step ${t.step} of ${t.length}`,a.textContent=`${t.step} / ${t.length}`,a.style.minWidth=`${2*String(t.length).
length+3}ch`,s.value=String(t.speed)};return t.addEventListener("step",l),t.addEventListener("state",l),t.addEventListener("state",i),e.addEventListener("keydow\
n",u=>{!(u.target instanceof HTMLSelectElement||u.key===" "&&u.target!==n)&&we(t,u)&&u.preventDefault()}),l(),e}function jn(t){let e=document.createElement("inp\
ut");return e.type="range",e.className="player-scrub",e.min="0",e.step="1",e.ariaLabel="Step",e.addEventListener("input",()=>{t.pause(),t.jump(Number(e.value))}),
e}function Hn(t){let e=document.createElement("select");return e.className="player-speed",e.ariaLabel="Speed",e.title="Steps a second (+ and -)",e.append(new Option(
`all in ${Ye} s`,String(gr)),...Q.map(r=>new Option(`${r} / s`,String(r)))),e.addEventListener("change",()=>{t.speed=Number(e.value)}),e}function Sr(t,e,r){if(r===0)return[{kind:"start",text:Gn(t),agents:[]}];let[n,o]=[e.moments[r-1],e.moments[r]],s=c=>B(c,t.config.n_pursuers),a=ce(e,n,o),i=t.conflicts(
r),l=new Set(i.flatMap(c=>c.doomed)),u=a.map(c=>({kind:"capture",text:`${s(c)} is captured`,agents:[c]}));for(let c of de(n,o))!a.includes(c)&&!l.has(c)&&u.push(
{kind:"end",text:`${s(c)} disappears`,agents:[c]});return u.push(...i.map(({kind:c,text:d,agents:h})=>({kind:c,text:d,agents:h}))),r===t.length&&u.unshift({kind:"\
end",text:zn(t),agents:[]}),u}function Gn({config:t}){return`${t.n_pursuers} pursuers and ${t.n_evaders} evaders on ${t.rows} x ${t.cols} cells, at most ${t.max_steps}\
 steps`}function zn(t){let e=Math.round(t.statistics.capture_rate*t.config.n_evaders);return`The episode ends after ${t.length} steps with ${e} of ${t.config.n_evaders}\
 evaders captured`}var qs=2n**64n-1n;var Ar=()=>["file:","http:","https:"].includes(location.protocol);var Cr=["·","↑","→","↓","←","↗","↘","↙","↖"];var qn={" ":0,s:0,ArrowUp:1,w:1,ArrowRight:2,d:2,ArrowDown:3,x:3,ArrowLeft:4,a:4,e:5,c:6,y:7,z:7,q:8},Ke=[8,1,5,4,0,2,7,3,6],Xn=[7,8,9,4,5,6,1,2,3],Zn=24,Qn=Math.
tan(Math.PI/8);function _r(t,e){if(t.ctrlKey||t.metaKey||t.altKey)return;let r=Xn.findIndex(o=>t.code===`Numpad${o}`),n=Ke[r]??qn[t.key.length===1?t.key.toLowerCase():
t.key];return n!==void 0&&n>4&&!e?void 0:n}function Tr(t){let e=Ke.map(r=>m("button",{type:"button","aria-label":Ie[r],onclick:()=>t(r)},Cr[r]));return{element:m(
"div",{class:"play-pad",role:"group","aria-label":"Your move"},...e),show:r=>e.forEach((n,o)=>n.classList.toggle("absent",Ke[o]>4&&!r))}}function Mr(t,e,r){let n=Qn*
Math.max(Math.abs(t),Math.abs(e)),o=s=>Math.abs(s)<n?0:s;return xt([0,0],r?[o(t),o(e)]:[t,e],r)}function Er(t,e,r){let n=null,{canvas:o}=t;o.addEventListener("p\
ointerdown",({button:s,clientX:a,clientY:i})=>{n=s===0?[a,i]:null}),o.addEventListener("pointercancel",()=>{n=null}),o.addEventListener("pointerup",({clientX:s,
clientY:a})=>{let[i,l]=[n,e()];if(n=null,!i||!l)return;let[u,c]=[s-i[0],a-i[1]],d=t.cellAt(s,a);Math.hypot(u,c)>=Zn?r(Mr(c,u,l.diagonal)):d&&r(Mr(d[0]-l.cell[0],
d[1]-l.cell[1],l.diagonal))})}function Rr(t,e){let r=n=>{let o=e[n]-t[n],s=D.findIndex(a=>a[n]===Math.sign(o)&&a[1-n]===0);return o?`${Math.abs(o)} ${Ie[s]}`:""};
return[r(0),r(1)].filter(Boolean).join(", ")||"on your cell"}var eo=[0,1,2,4,8],Se=class{element;player=new ee(0,{speed:4,still:ve()});#e;#o;#r=m("canvas",{tabindex:0,"aria-describedby":"play-keys"});#i=m("h2");#t=m("p",{
class:"play-told",role:"status"});#s=Tr(e=>this.act(e));#n=m("select",{},...eo.map(e=>m("option",{value:e},e?`${e} steps a second`:"step by step")));#c=m("input",
{type:"checkbox"});#d=m("section",{class:"play-ending",tabindex:-1,"aria-label":"Result"});#h=wr(this.player);#u=null;#a=null;#p=[];#m=null;#l=0;#f=0;constructor(e){
this.#e=e,this.#o=new ge(this.#r,{numbers:!1}),this.#r.setAttribute("role","application"),this.#n.addEventListener("change",()=>this.#y()),this.#c.addEventListener(
"change",()=>this.#g()),Er(this.#o,()=>{let r=this.#m!==null&&this.#a&&b(this.#a.recording.moments.at(-1),this.#m);return r?{cell:r,diagonal:this.#a.config.diagonal}:
null},r=>this.act(r)),this.player.addEventListener("frame",()=>this.#a&&this.#o.show(this.#a.recording,this.player.time)),this.player.addEventListener("step",()=>this.#x()),
this.element=m("div",{class:"play"},m("header",{class:"play-head"},this.#i,this.#t),m("div",{class:"play-stage"},this.#r),m("div",{class:"play-side"},this.#d,this.#s.
element,m("label",{class:"play-choice"},"Pace ",this.#n),m("label",{class:"play-choice"},this.#c," Fog: see only what it sees"),m("p",{class:"small muted play-k\
eys",id:"play-keys"},"Arrow keys move and Space stays; Q W E A S D Z X C and the numeric keypad know diagonals, too. On the board: swipe, or tap where to go.")),
this.#h)}get played(){return this.#u&&{...this.#u.played,moves:this.#p}}get live(){return this.#a}play(e){this.#b(Fe(this.#e,e.played),e.played.seat,e.title),[this.#u,
this.#p,this.#l]=[e,[...e.played.moves],0],this.element.dataset.state="playing",this.#r.focus({preventScroll:!0}),pe(this.#a,e.played.seat)&&this.#w()}watch(e,r,n){
this.#u=null,this.#b(e,r,n),this.#S()}stop(){this.#y(),this.player.pause(),this.#u=null}act(e){let[r,n]=[this.#u,this.#a];if(!r||!n||this.element.dataset.state!==
"playing")return;this.#l=e;let o=Number(this.#n.value);this.#f||(this.#v(),o&&this.element.dataset.state==="playing"&&(this.#f=setInterval(()=>this.#v(),1e3/o)))}key(e){
let{target:r,key:n}=e;if(r instanceof HTMLSelectElement||r instanceof HTMLInputElement&&(r.type==="text"||n===" ")||r instanceof HTMLButtonElement&&(n===" "||n===
"Enter")||!this.#a)return!1;if(this.element.dataset.state!=="playing")return we(this.player,e);let s=_r(e,this.#a.config.diagonal);return s!==void 0&&this.act(s),
s!==void 0}#b(e,r,n){this.#y(),this.player.pause(),[this.#a,this.#m]=[e,r],this.#i.textContent=n,this.#r.ariaLabel=`Board, ${e.config.rows} by ${e.config.cols} \
cells`,this.#s.show(e.config.diagonal),this.#d.replaceChildren(),this.player.length=e.length,this.player.jump(e.length),this.#g(),this.#x()}#g(){this.#o.look={you:this.#m,
fog:this.#c.checked,viewers:this.#m===null?[]:[this.#m]}}#y(){clearInterval(this.#f),this.#f=0,this.#t.ariaLive=Number(this.#n.value)?"off":"polite"}#v(){let[{policies:e,
seat:r},n]=[this.#u.played,this.#a];n.step(e,r,this.#l),this.#p.push(this.#l),this.player.length=n.length,this.player.glide=Math.min(.22,.9/(Number(this.#n.value)||
4)),this.player.move(n.length-this.player.step),pe(n,r)&&this.#w()}#w(){this.#y();let[e,r,n]=[this.#u,this.#a,this.played],o=Ar()?e.link(n):null;this.#d.replaceChildren(
m("h3",{},no(r,n.seat)),...e.ending(r,n),m("div",{class:"play-buttons"},m("button",{type:"button",class:"primary",onclick:()=>e.again()},"Again"),m("button",{type:"\
button",onclick:()=>this.#S()},"Watch it"),m("button",{type:"button",onclick:()=>{this.#A(r,n.seat)}},"Save"),o&&m("button",{type:"button",onclick:({currentTarget:s})=>so(
s,o)},"Link"))),this.element.dataset.state="ended",this.#d.focus({preventScroll:!0}),this.#d.scrollIntoView({block:"nearest"})}#S(){this.element.dataset.state="\
watched",this.player.length=this.#a.length,this.player.jump(0),ve()||this.player.play()}async#A(e,r){let n=new Blob([await Lt(this.#e,e,r)],{type:"application/o\
ctet-stream"});m("a",{href:URL.createObjectURL(n),download:`${B(r,e.config.n_pursuers)}-${e.length}-steps.npz`}).click()}#x(){let[e,r,{step:n}]=[this.#a,this.#m,
this.player];if(!e||n>e.length)return;let o=Sr(e,e.recording,n).filter(({agents:a})=>r===null||a.includes(r)),s=[`Step ${n} of ${e.config.max_steps}`,...o.map(({
text:a})=>a)];this.#u&&n===0?s.push(to(e.config,r)):r!==null&&s.push(ro(e,n,r)),this.#t.textContent=s.filter(Boolean).map(a=>`${a}.`).join(" ")}};function to(t,e){
let r=t.rules.capture==="SURROUND";return P(t,e)==="evader"?`Stay free: ${r?"pursuers on all sides of you capture":"a pursuer on your cell captures"} you`:`Capt\
ure evaders: ${r?"surround them together":"reach their cell"}`}function ro({config:t,recording:e},r,n){let o=e.moments[r],a=P(t,n)==="pursuer"?"evader":"pursuer";
if(!o.alive[n])return"";let i=b(o,n),l=d=>{let[h,p]=b(o,d);return Math.max(Math.abs(h-i[0]),Math.abs(p-i[1]))},u=Array.from({length:o.alive.length},(d,h)=>h).filter(
d=>P(t,d)===a&&o.alive[d]&&!o.captured[d-t.n_pursuers]&&2*l(d)<t.fov);if(!u.length)return`No ${a} in view`;let c=u.reduce((d,h)=>l(h)<l(d)?h:d);return`Nearest ${a}\
: ${Rr(i,b(o,c))}`}function no(t,e){let[{lasted:r,out:n,captured:o},{config:s}]=[R(t,e),t];return P(s,e)==="pursuer"?`Your team captured ${o} of ${oo(s)} in ${r}\
 steps.`:n?`You lasted ${r} of ${s.max_steps} steps.`:`You escaped: ${r} steps.`}var oo=({n_evaders:t})=>`${t} evader${t===1?"":"s"}`;function so(t,e){let r=m("\
input",{type:"text",readonly:!0,value:e,"aria-label":"Link to this match"});t.replaceWith(r),r.select(),navigator.clipboard?.writeText(e).catch(()=>{})}var _=JSON.parse(Pe("data")),N={pursuer:Nr("pursuer"),evader:Nr("evader")};function Nr(t){let{names:e,scripts:r,network:n}=_.teams[t],o=new Float32Array(wt(t).buffer),
s=a=>{let i=r[a];if(i||!n)return i;let l=r.slice(0,a).filter(u=>u===null).length;return{...n,genome:o.subarray(l*n.genome_size,(l+1)*n.genome_size)}};return e.map(
(a,i)=>({name:a,policy:()=>s(i)}))}function Je(t,e,r,n){let[o,s]=[_.world,W[+(n.seat>=_.world.n_pursuers)]],a=W.map(l=>N[l][r[l]].name),i={pursuer:N.pursuer[r.pursuer].
policy(),evader:N.evader[r.evader].policy()};e.play({title:`You are ${B(n.seat,o.n_pursuers)}: pursuers ${a[0]}, evaders ${a[1]}`,played:{config:o,seed:r.seed,episode:0,
policies:i,...n},ending:(l,u)=>[Et(t,l,u,he(N[s]))],again:()=>Je(t,e,r,{...n,moves:n.moves.slice(0,n.from)}),link:l=>_t({pursuers:r.pursuer,evaders:r.evader,seed:r.
seed},l)})}function Or(t,e){let r=new URLSearchParams(location.hash.slice(1)),n=Tt(r,_.world),[o,s]=[Number(r.get("pursuers")??NaN),Number(r.get("evaders")??NaN)],
a=/^\d{1,20}$/.test(r.get("seed")??"")?BigInt.asUintN(64,BigInt(r.get("seed"))):null;return!n||a===null||!N.pursuer[o]||!N.evader[s]?!1:(Je(t,e,{pursuer:o,evader:s,
seed:a},n),!0)}var kr=(t,e)=>m("select",{},...t.map((r,n)=>m("option",{value:n,selected:n===e},r)));function ao(t,e){let[r,n,o]=[kr(["an evader","a pursuer"],0),
...W.map(l=>kr(_.teams[l].names,_.teams[l].names.length-1))],s=m("p",{class:"problem",role:"alert"}),a=()=>Je(t,e,{pursuer:Number(n.value),evader:Number(o.value),
seed:fe()},{seat:r.value==="0"?_.world.n_pursuers:0,from:0,moves:[]}),i=m("input",{type:"file",accept:".npz",class:"heard",tabindex:-1,"aria-hidden":!0});return i.
addEventListener("change",()=>{let[l]=i.files??[];s.textContent="",l?.arrayBuffer().then(u=>$t(t,new Uint8Array(u))).then(({live:u,seat:c})=>e.watch(u,c,l.name)).
catch(u=>s.textContent=`${l.name} holds no match: ${u.message}`),i.value=""}),m("details",{class:"card setup",open:matchMedia("(min-width: 761px)").matches},m("\
summary",{},"Play something else"),m("div",{},m("label",{},"You are ",r),m("label",{},"Pursuers ",n),m("label",{},"Evaders ",o),m("button",{type:"button",class:"\
primary",onclick:a},"Play"),m("button",{type:"button",onclick:()=>ye(e,_.world,N.pursuer)},"Can you escape it?"),m("button",{type:"button",onclick:()=>i.click()},
"Open a file"),i,s))}async function io(){let t=await vt(),e=new Se(t);document.getElementById("page").replaceWith(m("header",{class:"top"},m("h1",{},_.title),St()),
m("main",{},ao(t,e),m("section",{class:"card","aria-label":"Match"},e.element))),document.addEventListener("keydown",r=>e.key(r)&&r.preventDefault()),window.addEventListener(
"hashchange",()=>Or(t,e)),Or(t,e)||ye(e,_.world,N.pursuer),Object.assign(window,{matrixworldPlay:e})}io().catch(t=>{throw(document.getElementById("page")??document.
body).append(m("p",{class:"card problem",role:"alert"},`The page could not start: ${t instanceof S?t.message:String(t)}`)),t}).finally(()=>{document.body.dataset.
ready="true"});})();
