/* built from web/ by "npm run build"; sources 148b5d616ccd87a97efaf555180ae3c9582d0a3c85029da27a42905bda8ddcba */
"use strict";(()=>{var ht={SIMULTANEOUS:0,SWARM_TURNS:1,AGENT_TURNS:2},ne={DISAPPEAR:0,REACH:1,BOUNCE:2},ft={OCCUPATION:0,SURROUND:1},gt={FAULT:0,INVOLVED:1};var re=["obstacle","teammate","adversary"],Be=["vertex","edge","chain"],bt=["turn","kind","form","first","second","row","col","at_fault","held","doomed"],He=["p\
ursuer_{number}","evader_{number}"],yt={obstacle:"{first} ran into the obstacle or border at {cell}",vertex:"{first} and {second} both headed for {cell}",edge:"\
{first} and {second} meant to swap, {first} to {cell}",chain:"{first} headed for {cell}, where {second} had to stay"},oe={"both held":"both bounce","both doomed":"\
both disappear",held:"{agent} bounces",doomed:"{agent} disappears",none:"nobody is stopped"},vt="{event}: {outcome}",je={random:"any action, all equally likely",
still:"always stays",chaser:"moves to where the nearest adversary in view is nearest",fleer:"moves to where the nearest adversary in view is farthest","clumsy-c\
haser":"a chaser that takes any action in half of the steps",hunter:"a chaser of the nearest adversary in view to which no teammate in view is nearer",surrounder:"\
a chaser of the nearest free cell beside an adversary without a teammate","clumsy-fleer":"a fleer that takes any action in half of the steps",dodger:"moves to w\
here all adversaries in view together are farthest"},wt={free:".GS",blocked:"#@OTW"};var z=1+bt.length;function se(e,t){return e.replace(/\{(\w+)\}/g,(n,r)=>String(t[r]))}function G(e,t){return e<t?se(He[0],{number:e}):se(He[1],{number:e-t})}function yr(e,t){
let[n,r,o,s,a,i,l,...d]=Array.from(e),u=a<0?[s]:[s,a],[m,h,p]=d.map(S=>u.filter((T,F)=>S>>F&1)),g=u.map(S=>G(S,t)),f=se(yt[a<0?"obstacle":Be[o]],{first:g[0],second:g[g.
length-1],cell:`(${i}, ${l})`}),b=se(vt,{event:f,outcome:vr(u.length,h,p,t)});return{kind:re[r],form:Be[o],agents:u,cell:[i,l],at_fault:m,held:h,doomed:p,turn:n,
text:b}}function vr(e,t,n,r){if(e===2&&t.length===2)return oe["both held"];if(e===2&&n.length===2)return oe["both doomed"];let o=s=>a=>se(oe[s],{agent:G(a,r)});
return[...t.map(o("held")),...n.map(o("doomed"))].join(", ")||oe.none}function ge(e,t){let n=[];for(let r=0;r<e.length;r+=z)n.push(yr(e.subarray(r+1,r+z),t));return n}var M=class extends Error{name="EngineError"};function v(e,t,n){let r=typeof n=="string"?`'${n}'`:typeof n=="object"?JSON.stringify(n):String(n);return new M(`${e}\
: expected ${t}, got ${r}`)}var K=class{bytes;constructor(t){this.bytes=t}},At=0,Fe=[Uint8Array,Uint8Array,Int32Array,BigInt64Array,BigUint64Array,Float32Array,Float64Array],St=4,xt=4,wr=new TextEncoder,
Sr=new TextDecoder;function xr(e){for(let t=Fe.length-1;t>At;--t)if(e instanceof Fe[t])return t;throw new TypeError("array: expected a typed array of the engine\
's numbers, got another")}function We(e){return new Uint8Array(e.buffer,e.byteOffset,e.byteLength)}function Ar(e){return wr.encode(`${e}\0`)}var ze=class{engine;addresses=[];constructor(t){
this.engine=t}copy(t){let n=this.engine._malloc(Math.max(t.length,1));if(n===0)throw new M("memory: expected room for the arguments, got none");return this.addresses.
push(n),this.engine.HEAPU8.set(t,n),n}text(t){return this.copy(Ar(t))}arrays(t){let n=Object.entries(t),r=n.flatMap(([s,a])=>{let i=a instanceof K,l=i?a.bytes:a;
return[this.text(s),i?At:xr(l),l.length,this.copy(We(l))]}),o=this.copy(We(Int32Array.from(r)));return this.copy(We(Int32Array.of(n.length,o)))}free(){for(let t of this.
addresses)this.engine._free(t)}};function Ct(e,t){let n=e.HEAPU8;return Sr.decode(n.subarray(t,n.indexOf(0,t)))}function be(e){let t=new Int32Array(e.HEAPU8.buffer),
n=e._last_outputs()/St,r=t[n+1]/St,o={};for(let s=r;s<r+t[n]*xt;s+=xt){let a=Fe[t[s+1]],i=t[s+2]*a.BYTES_PER_ELEMENT,l=t[s+3];o[Ct(e,t[s])]=new a(e.HEAPU8.slice(
l,l+i).buffer)}return o}function ae(e,t){let n=new ze(e);try{let r=t(n);if(r===0)throw new M(Ct(e,e._last_error()));return r}finally{n.free()}}var Cr=2**31-1,Mr=2n**64n-1n,Er=34028234663852886e22;function k(e,t){if(typeof t!="number"||!Number.isInteger(t)||Math.abs(t)>Cr)throw v(e,"an integer",t);return Int32Array.
of(t)}function ye(e,t){if(typeof t!="boolean")throw v(e,"true or false",t);return new K(Uint8Array.of(Number(t)))}function P(e,t,n){let r=typeof t=="string"&&Object.
hasOwn(n,t)?n[t]:void 0;if(r===void 0)throw v(e,`one of ${Object.keys(n).join(", ")}`,t);return Int32Array.of(r)}function Ge(e,t){if(typeof t!="number"||!(Math.
abs(t)<=Er))throw v(e,"a finite number",t);return t}function V(e,t){let r=typeof t=="bigint"||typeof t=="number"&&Number.isSafeInteger(t)?BigInt(t):-1n;if(r<0n||
r>Mr)throw v(e,"an integer from 0 to 2^64 - 1",t);return BigUint64Array.of(r)}function Tr(e){return{"rules.interaction":P("interaction",e.interaction,ht),"rules\
.obstacle":P("obstacle",e.obstacle,ne),"rules.teammate":P("teammate",e.teammate,ne),"rules.evader":P("evader",e.evader,ne),"rules.pursuer":P("pursuer",e.pursuer,
ne),"rules.capture":P("capture",e.capture,ft),"rules.captured_disappear":ye("captured_disappear",e.captured_disappear)}}function Mt(e,t){let n=typeof t=="number"?
[t,t,t]:t;if(!Array.isArray(n)||n.length!==3)throw v(e,"1 or 3 numbers",t);return Float32Array.from(n,r=>Ge(e,r))}function kr(e){let t=(n,r)=>Float32Array.of(Ge(
n,e[n]),Ge(r,e[r]));return{"rewards.capture":t("pursuer_capture","evader_capture"),"rewards.neighbor":t("pursuer_neighbor","evader_neighbor"),"rewards.step":t("\
pursuer_step","evader_step"),"rewards.pursuer_collide":Mt("pursuer_collide",e.pursuer_collide),"rewards.evader_collide":Mt("evader_collide",e.evader_collide),"r\
ewards.blame":P("blame",e.blame,gt),"rewards.capture_repeats":ye("capture_repeats",e.capture_repeats)}}function Tt(e){if(e===void 0||typeof e=="number")return new Uint8Array(
0);if(e instanceof Uint8Array)return e;let{free:t,blocked:n}=wt;for(let[r,o]of e.entries()){if(o.length!==e[0]?.length)throw v(`map, row ${r}`,`${e[0]?.length} \
cells as in row 0`,o.length);let s=[...o].find(a=>!t.includes(a)&&!n.includes(a));if(s)throw v(`map, row ${r}`,`'${t}' (free) or '${n}' (obstacle)`,s)}return Uint8Array.
from([...e.join("")],r=>Number(n.includes(r)))}function kt(e,t){if(!Array.isArray(e))return;let n=[e.length,e[0]?.length??0];if(!(n[0]===t.rows&&n[1]===t.cols))
throw v("obstacle map",`shape (${t.rows}, ${t.cols}), the rows and cols`,n)}function ve(e){kt(e.obstacles,e);let t=typeof e.obstacles=="number"?e.obstacles:0;return{
...Tr(e.rules),...kr(e.rewards),rows:k("rows",e.rows),cols:k("cols",e.cols),n_pursuers:k("n_pursuers",e.n_pursuers),n_evaders:k("n_evaders",e.n_evaders),fov:k("\
fov",e.fov),diagonal:ye("diagonal",e.diagonal),max_steps:k("max_steps",e.max_steps),density:Float64Array.of(t),map:Tt(e.obstacles)}}function Et(e,t){return Int32Array.
from((t??[]).flat(),n=>k(e,n)[0])}function _t(e,t){return kt(e.obstacles,t),{seed:V("seed",e.seed??0n),episode:V("episode",e.episode??0),pursuers:Et("pursuers",
e.pursuers),evaders:Et("evaders",e.evaders),map:Tt(e.obstacles)}}function we(e){return{actions:Int32Array.from(e,t=>k("actions",t)[0])}}function Y(e){if(typeof e==
"string"){if(!Object.hasOwn(je,e))throw v("policy",`one of ${Object.keys(je).join(", ")}`,e);return{script:new TextEncoder().encode(e)}}if(e.activation!=="relu"&&
e.activation!=="tanh")throw v("activation","'relu' or 'tanh'",e.activation);return{hidden:Int32Array.from(e.hidden,t=>k("hidden",t)[0]),activation:new TextEncoder().
encode(e.activation),sampled:ye("sampled",e.sampled),genome:e.genome}}var _r=["first_turn","terminated","truncated"];function Rt(e){let t={...e};for(let n of _r)
t[n]=new K(e[n]);return t}var Se=class{config;seed;episode;n_agents;statistics;first_conflict;constructor(t,n,r,o){this.config=t,this.seed=n,this.episode=r,this.n_agents=t.n_pursuers+t.n_evaders,
this.statistics=Ot(o,0),Object.assign(this,o),this.first_conflict=Rr(this.conflict_table,this.length)}get length(){return this.actions.length/this.n_agents}conflicts(t){
this.check(t);let[n,r]=[this.first_conflict[t],this.first_conflict[t+1]],o=this.conflict_table.subarray(n*z,r*z);return ge(o,this.config.n_pursuers)}seek(t,n){this.
check(n),(!(t.seed===this.seed&&t.episode===BigInt(this.episode))||t.turn!==0||t.steps>n)&&t.reset({seed:this.seed,episode:this.episode});for(let o=t.steps;o<n;++o)
t.step(this.actions.subarray(o*this.n_agents,(o+1)*this.n_agents))}check(t){if(!(Number.isInteger(t)&&t>=0&&t<=this.length))throw v("step",`0 to ${this.length}`,
t)}};function Rr(e,t){let n=new Int32Array(t+2);for(let r=0;r<e.length;r+=z)++n[e[r]+1];for(let r=1;r<n.length;++r)n[r]+=n[r-1];return n}function Ot(e,t){let n=e["\
statistics.length"].length,r=s=>{let a=e[`statistics.${s}`],i=a.length/n;return a.slice(t*i,(t+1)*i)},o=s=>Number(r(s)[0]);return{capture_rate:o("capture_rate"),
ever_capture_rate:o("ever_capture_rate"),captured_fraction:o("captured_fraction"),length:o("length"),return:r("return"),survivors:r("survivors"),overlap:r("over\
lap"),collisions:r("collisions"),faults:r("faults"),agent_steps:r("agent_steps")}}function Lt(e,t,n,r){let o=[ve(n.config),Y(n.pursuers),Y(n.evaders),r];return ae(
e,s=>{let[a,i,l,d]=o.map(u=>s.arrays(u));return e[t](a,i,l,d)}),be(e)}function Nt(e,t,n,r){let o={seed:V("seed",n),episode:V("episode",r)};return new Se(t.config,
n,r,Lt(e,"_play_match",t,o))}function It(e,t,n,r){if(!Number.isInteger(r)||r<1)throw v("n_episodes","at least 1",r);let o={seed:V("seed",n),n_episodes:Int32Array.
of(r)},s=Lt(e,"_play_rollout",t,o);return Array.from({length:r},(a,i)=>Ot(s,i))}var Pt=new FinalizationRegistry(([e,t])=>e._world_free(t)),ie=class{config;n_agents;n_actions;engine;at;freed=!1;constructor(t,n){this.engine=t,this.config=n,this.
n_agents=n.n_pursuers+n.n_evaders,this.n_actions=n.diagonal?9:5,this.at=ae(t,r=>t._world_new(r.arrays(ve(n)))),Pt.register(this,[t,this.at],this)}free(){this.freed||
(this.freed=!0,Pt.unregister(this),this.engine._world_free(this.at))}reset(t={}){let n=_t(t,this.config);this.call(r=>this.engine._world_reset(this.at,r.arrays(
n)))}step(t){let n=we(t);this.call(r=>this.engine._world_step(this.at,r.arrays(n)))}playTurn(t){let n=we(t);this.call(r=>this.engine._world_play_turn(this.at,r.
arrays(n)))}decide(t,n,r){let{n_pursuers:o}=this.config,s={pursuer:[0,o],evader:[o,this.n_agents]},[a,i]=typeof n=="string"?s[n]:n;if(r.length!==this.n_agents)throw v(
"actions",String(this.n_agents),r.length);let l=[Y(t),we(r)],{actions:d}=this.call(u=>this.engine._world_decide(this.at,u.arrays(l[0]),a,i,u.arrays(l[1])));return Uint8Array.
from(d)}get n_turns(){return this.turnNumbers()[1]}get turn(){return this.turnNumbers()[0]}get actors(){let[,,t,n]=this.turnNumbers();return[t,n]}turnNumbers(){
return this.call(()=>this.engine._world_turn(this.at)).turn}get steps(){return this.read("steps")[0]}get seed(){return this.read("seed")[0]}get episode(){return this.
read("episode")[0]}get over(){return this.read("terminated")[0]===1||this.read("truncated")[0]===1}read(t){return this.call(n=>this.engine._world_read(this.at,n.
text(t)))[t]}view(t){let n=3*this.config.fov**2;return this.read("views").slice(t*n,(t+1)*n)}map(){return this.read("state").slice(2*this.config.rows*this.config.
cols)}conflicts(){return ge(this.conflictTable(),this.config.n_pursuers)}conflictTable(){return this.call(()=>this.engine._world_conflicts(this.at)).conflict_table}answer(t,n){
let r=Y(t),{logits:o}=this.call(i=>this.engine._world_logits(this.at,i.arrays(r),n)),s=o,a=this.decide(t,[n,n+1],new Uint8Array(this.n_agents))[n];return{logits:s,
probabilities:Or(s),action:a}}snapshot(){return this.call(()=>this.engine._world_snapshot(this.at))}restore(t){let n=Rt(t);this.call(r=>this.engine._world_restore(
this.at,r.arrays(n)))}call(t){if(this.freed)throw v("world","one that is in use","one that was freed");return ae(this.engine,t),be(this.engine)}};function Or(e){
let t=Math.max(...e),n=Array.from(e,o=>Math.exp(o-t)),r=n.reduce((o,s)=>o+s,0);return Float32Array.from(n,o=>o/r)}var Ke=class{compiled;constructor(t){this.compiled=t}world(t){return new ie(this.compiled,t)}match(t,n,r,o,s=0){return Nt(this.compiled,{config:t,pursuers:n,evaders:r},
o,s)}rollout(t,n,r,o,s){return It(this.compiled,{config:t,pursuers:n,evaders:r},o,s)}},$t;function Ut(e=globalThis.matrixworldEngine){return $t??=Lr(e),$t}async function Lr(e){
if(!e)throw new Error("matrixworldEngine: expected the script engine.js before this one, got none");let t=Uint8Array.from(atob(e.binary),n=>n.charCodeAt(0));return new Ke(
await e({wasmBinary:t}))}var Nr="http://www.w3.org/2000/svg";function c(e,t={},...n){return Dt(document.createElement(e),t,n)}function $(e,t={},...n){return Dt(document.createElementNS(
Nr,e),t,n)}function Dt(e,t,n){for(let[r,o]of Object.entries(t))o==null||o===!1||(typeof o=="function"?e.addEventListener(r.slice(2),o):e.setAttribute(r,o===!0?"":
String(o)));return e.append(...n.filter(Ir).map(r=>typeof r=="number"?String(r):r)),e}function Ir(e){return e!=null&&e!==!1}var xe=()=>["file:","http:","https:"].
includes(location.protocol);async function Ve(e,t){e.select();try{await navigator.clipboard.writeText(e.value),t.textContent="Copied."}catch{t.textContent="Sele\
cted: copy it with Ctrl+C."}}var _=["stay","north","east","south","west","northeast","southeast","southwest","northwest"];var O="champion",U=0,D=64,J=100,X=300,Ye=e=>({cell:e,gone:!1,captured:!1,everCaptured:!1}),E=e=>[...e.pursuers,...e.evaders],x=e=>e.pursuers.length+e.evaders.length,
Je=(e,t)=>t<e.pursuers.length?"pursuers":"evaders",R=(e,t)=>G(t,e.pursuers.length),Xe=(e,t)=>Object.keys(e).every(n=>e[n]===t[n]);function q(e,t){return Object.
keys(t).find(n=>Xe(t[n],e))??null}function Bt(e,t){let n=new Set(e.walls),r=Array.from({length:e.rows},(o,s)=>Array.from({length:e.cols},(a,i)=>n.has(s*e.cols+i)?
"#":".").join(""));return{rules:t,rows:e.rows,cols:e.cols,n_pursuers:e.pursuers.length,n_evaders:e.evaders.length,fov:e.fov,diagonal:e.diagonal,max_steps:e.maxSteps,
obstacles:r,rewards:e.rewards}}var Ae=(e,t,n)=>({...e,next:e.next.map((r,o)=>o===t?n:r)}),Ht=e=>({...e,played:[...e.played,e.next],next:e.next.map(t=>typeof t==
"number"?U:t)}),jt=e=>({...e,played:e.played.slice(0,-1),next:e.played.at(-1)??e.next});function qe(e,t,n){let r=(o,s)=>o.map((a,i)=>i===s?{...a,cell:n}:a);return{
...e,pursuers:r(e.pursuers,t),evaders:r(e.evaders,t-e.pursuers.length)}}function Wt(e,t,n){let r=t==="pursuers"?e.pursuers.length:x(e);return{...e,[t]:[...e[t],
Ye(n)],next:[...e.next.slice(0,r),U,...e.next.slice(r)],ended:!1}}function Ce(e,t){let n=Je(e,t),r=n==="pursuers"?t:t-e.pursuers.length;return{...e,[n]:e[n].filter(
(o,s)=>s!==r),next:e.next.filter((o,s)=>s!==t)}}function Ze(e,t,n){let r=t[0]*e.cols+t[1],o=e.walls.filter(s=>s!==r);return{...e,walls:n?[...o,r].sort((s,a)=>s-
a):o}}function Ft(e,t,n){let r=([s,a])=>s<t&&a<n,o=E(e).map(({cell:s})=>r(s));return{...e,rows:t,cols:n,walls:e.walls.map(s=>[Math.floor(s/e.cols),s%e.cols]).filter(
r).map(([s,a])=>s*n+a),pursuers:e.pursuers.filter((s,a)=>o[a]),evaders:e.evaders.filter((s,a)=>o[e.pursuers.length+a]),next:e.next.filter((s,a)=>o[a])}}function L(e,[
t,n]){let r=E(e).findIndex(({cell:o,gone:s})=>!s&&o[0]===t&&o[1]===n);return r<0?null:r}var N=(e,[t,n])=>e.walls.includes(t*e.cols+n);function zt(e){let t=Array.
from({length:e.rows*e.cols},(o,s)=>[Math.floor(s/e.cols),s%e.cols]),n=([o,s])=>Math.abs(o-(e.rows-1)/2)+Math.abs(s-(e.cols-1)/2),r=t.filter(o=>L(e,o)===null&&!N(
e,o));return r.length?r.reduce((o,s)=>n(s)<n(o)?s:o):null}var le=class extends Error{},B="_",Zt="n",Gt=2n**64n-1n,Kt=2e4,Vt=40,H={fov:11,maxSteps:500,rewards:"paper"},Qe=["rules","others","rewards","size","diagonal","f\
ov","limit","seed","ended","walls","pursuers","evaders","played","next"];function y(e,t,n){let r=n.length>Vt?`${n.slice(0,Vt)}…`:n;throw new le(`${e}: expecte\
d ${t}, got "${r}"`)}function ce(e,t){let n=i=>i.map(l=>$r(l,t)).join(""),r=i=>`${Math.floor(i/e.cols)}.${i%e.cols}`,o=Pr(e.rewards,t),s=[e.seed,e.episode,e.steps].
join("."),a={rules:Jt(e.rules,t),others:e.others?Jt(e.others,t):"",rewards:o===H.rewards?"":o,size:`${e.rows}x${e.cols}`,diagonal:e.diagonal?"1":"",fov:e.fov===
H.fov?"":String(e.fov),limit:e.maxSteps===H.maxSteps?"":String(e.maxSteps),seed:s==="0.0.0"?"":s,ended:e.ended?"1":"",walls:e.walls.map(r).join(B),pursuers:e.pursuers.
map(Yt).join(B),evaders:e.evaders.map(Yt).join(B),played:e.played.map(n).join(B),next:e.next.every(i=>i===U)?"":n(e.next)};return Qe.filter(i=>a[i]).map(i=>`${i}\
=${a[i]}`).join("&")}function Yt({cell:e,gone:t,captured:n,everCaptured:r}){let o=n?"c":r?"e":"";return`${e[0]}.${e[1]}${o}${t?"x":""}`}function Jt(e,t){let n=t.
fields.map(({name:r})=>String(e[r]).toLowerCase());return q(e,t.variants)??n.join(".")}function Pr(e,t){let n=JSON.stringify(e);return Object.keys(t.rewards).find(
o=>JSON.stringify(t.rewards[o])===n)??Object.values(e).map(o=>String(o)).join(B)}function $r(e,t){if(typeof e=="number")return String(e);if(e===O)return Zt;let n=t.
scripts.findIndex(({name:r})=>r===e);return String.fromCharCode(97+n)}function de(e,t){e.length>Kt&&y("link",`at most ${Kt} characters`,`${e.length} characters`);
let n=Ur(e),r=(h,p="")=>n.get(h)??p,o=qt("rules",r("rules"),t),[s,a]=Dr(r("size")),i=h=>et(r(h)).map(p=>Br(h,p,s,a)),[l,d,u]=Fr(r("seed","0.0.0")),m={rules:o,others:n.
has("others")?qt("others",r("others"),t):null,rewards:jr(r("rewards",H.rewards),t),rows:s,cols:a,seed:l,episode:d,steps:u,diagonal:Xt("diagonal",r("diagonal","0")),
fov:Me("fov",r("fov",String(H.fov)),1,255),maxSteps:Me("limit",r("limit",String(H.maxSteps)),1,2**31-1),ended:Xt("ended",r("ended","0")),walls:Hr(r("walls"),s,a),
pursuers:i("pursuers"),evaders:i("evaders"),played:[],next:[]};return zr(m),Gr(m,et(r("played")),r("next"),t)}function Ur(e){let t=new Map;for(let n of e.replace(
/^#/,"").split("&").filter(Boolean)){let[r,o]=n.includes("=")?[n.slice(0,n.indexOf("=")),n.slice(n.indexOf("=")+1)]:[n,""];Qe.includes(r)||y("link",`parts ${Qe.
join(", ")}`,r),t.has(r)&&y(r,"it once","it twice"),t.set(r,o)}return t}var et=e=>e?e.split(B):[];function Me(e,t,n,r){let o=/^\d{1,10}$/.test(t)?Number(t):NaN;
return o>=n&&o<=r||y(e,`a number from ${n} to ${r}`,t),o}function Xt(e,t){return t!=="0"&&t!=="1"&&y(e,"0 or 1",t),t==="1"}function Dr(e){let[t,n,...r]=e.split(
"x");return(t===void 0||n===void 0||r.length)&&y("size","rows and columns, such as 4x6",e),[Me("size",t,1,D),Me("size",n,1,D)]}function Qt(e,t,n,r){let o=/^(\d{1,4})\.(\d{1,4})$/.
exec(t),s=[Number(o?.[1]),Number(o?.[2])];return(!o||s[0]>=n||s[1]>=r)&&y(e,`cells of a ${n} x ${r} grid, such as 0.2`,t),s}function Br(e,t,n,r){let o=/^(.*?)([ce]?)(x?)$/.
exec(t),s=Qt(e,o[1],n,r);return e==="pursuers"&&o[2]&&y(e,"no captured pursuer",t),{cell:s,gone:o[3]==="x",captured:o[2]==="c",everCaptured:o[2]!==""}}function Hr(e,t,n){
let r=et(e).map(o=>{let[s,a]=Qt("walls",o,t,n);return s*n+a});return[...new Set(r)].sort((o,s)=>o-s)}function qt(e,t,n){let r=Object.hasOwn(n.variants,t)?n.variants[t]:
void 0;if(r)return r;let o=t.split("."),s=`${Object.keys(n.variants).join(", ")} or ${n.fields.length} values joined by "."`;o.length!==n.fields.length&&y(e,s,t);
let a=n.fields.map(({name:i,values:l},d)=>{let u=l.find(m=>m.name.toLowerCase()===o[d])?.name;return u===void 0&&y(`${e}, ${i}`,l.map(m=>m.name.toLowerCase()).join(
" or "),o[d]),[i,u==="true"?!0:u==="false"?!1:u]});return Object.fromEntries(a)}function jr(e,t){if(Object.hasOwn(t.rewards,e))return t.rewards[e];let n=Object.
entries(t.rewards[H.rewards]),r=e.split(B);return r.length!==n.length&&y("rewards",`${Object.keys(t.rewards).join(", ")} or ${n.length} values`,e),Object.fromEntries(
n.map(([o,s],a)=>[o,Wr(o,r[a],s)]))}function Wr(e,t,n){if(e==="blame"&&(t==="FAULT"||t==="INVOLVED"))return t;if(typeof n=="boolean"&&(t==="true"||t==="false"))
return t==="true";let r=t.split(",").map(a=>/^-?[\d.]+(e[+-]?\d+)?$/i.test(a)?Number(a):NaN),o=e.endsWith("_collide")?[1,3]:[1];return(typeof n!="number"||!o.includes(
r.length)||!r.every(a=>Math.abs(a)<34e37))&&y(`rewards, ${e}`,`a value like ${n}`,t),r.length===1?r[0]:r}function Fr(e){let t=/^(\d{1,20})\.(\d{1,20})\.(\d{1,9})$/.
exec(e);if(!t)return y("seed","seed.episode.steps, such as 0.0.0",e);let[n,r]=[BigInt(t[1]),BigInt(t[2])];return(n>Gt||r>Gt)&&y("seed","numbers below 2^64",e),[
n,r,Number(t[3])]}function zr(e){for(let t of["pursuers","evaders"]){let n=e[t].length;(n<1||n>J)&&y(t,`1 to ${J} agents`,`${n}`)}e.fov%2===0&&y("fov","an odd n\
umber",String(e.fov)),e.steps>e.maxSteps&&y("seed",`at most ${e.maxSteps} steps`,String(e.steps))}function Gr(e,t,n,r){let o=E(e).length;t.length>X&&y("played",
`at most ${X} steps`,`${t.length} steps`);let s=a=>i=>(i.length!==o&&y(a,`${o} characters, one for each agent`,i),[...i].map(l=>Kr(a,l,e.diagonal?9:5,r)));return{
...e,played:t.map(s("played")),next:n?s("next")(n):Array(o).fill(U)}}function Kr(e,t,n,r){let o=/^\d$/.test(t)?Number(t):NaN;if(o<n)return o;if(t===Zt&&r.champions)
return O;let s=r.scripts[t.charCodeAt(0)-97],a=String.fromCharCode(97+r.scripts.length-1);return s?.name??y(e,`actions 0 to ${n-1} or scripts a to ${a}`,t)}var Ee=[.5,1,2,4,8,16,32,64];var en=12,Vr=2,Te=class extends EventTarget{#e;#r;#n;#t=0;#s=0;#o=!1;#a=null;#c=0;#l=[];glide=.28;constructor(t,n={}){super(),this.#e=t,this.#r=n.speed??4,this.#n=
n.still??!1}get step(){return this.#t}get time(){return this.#n?this.#t:this.#s}get arrived(){return this.#s===this.#t}get playing(){return this.#o}get length(){
return this.#e}set length(t){this.#e=t,this.#t>t&&this.jump(t),this.#i("state")}get marks(){return this.#l}set marks(t){this.#l=t,this.#i("state")}get pace(){return this.#r||
Math.max(Vr,this.#e/en)}get speed(){return this.#r}set speed(t){this.#r=t,this.#i("state")}changeSpeed(t){let n=Ee.findIndex(r=>r>=this.pace);this.speed=Ee[Math.
min(Ee.length-1,Math.max(0,n+t))]}play(){this.#o||!this.#e||(this.#t===this.#e&&this.jump(0),this.#o=!0,this.#i("state"),this.#u())}pause(){this.#o&&(this.#o=!1,
this.#i("state"))}toggle(){this.#o?this.pause():this.play()}move(t){this.pause();let n=Math.min(this.#e,Math.max(0,this.#t+t));Math.abs(n-this.#s)>1?this.jump(n):
this.#d(n),this.#u()}jump(t){this.#s=Math.min(this.#e,Math.max(0,Math.round(t))),this.#d(this.#s),this.#i("frame")}#d(t){t!==this.#t&&(this.#t=t,this.#i("step"),
this.#n&&this.#i("frame"))}#u(){this.#a===null&&(this.#c=performance.now(),this.#a=requestAnimationFrame(()=>this.#m()))}#m(){this.#a=null;let t=performance.now();
this.#p(Math.min(.25,(t-this.#c)/1e3)),this.#c=t,(!this.#n||this.arrived)&&this.#i("frame"),(this.#o||this.#s!==this.#t)&&(this.#a=requestAnimationFrame(()=>this.#m()))}#p(t){
let n=t;for(;n>0;){if(this.#s===this.#t){if(!this.#o)return;if(this.#t===this.#e)return this.pause();this.#d(this.#t+1)}let r=this.#o?this.pace:1/this.glide,o=this.#t-
this.#s,s=Math.min(Math.abs(o),n*r);n-=s/r,this.#s=s===Math.abs(o)?this.#t:this.#s+Math.sign(o)*s}this.#o&&this.#s===this.#e&&this.pause()}#i(t){this.dispatchEvent(
new Event(t))}};var j=[[0,0],[-1,0],[0,1],[1,0],[0,-1],[-1,1],[1,1],[1,-1],[-1,-1]];function tt(e,t,n){let[r,o]=[t[0]-e[0],t[1]-e[1]];return!n&&Math.abs(r)>Math.abs(o)?o=0:n||(r=
0),j.findIndex(([s,a])=>s===Math.sign(r)&&a===Math.sign(o))}var W=(e,t)=>t<e.nPursuers,w=(e,t)=>[e.positions[2*t],e.positions[2*t+1]],Yr=(e,t)=>e[0]===t[0]&&e[1]===
t[1],ue=({rows:e,cols:t},[n,r])=>n>=0&&r>=0&&n<e&&r<t,nt=(e,t,n=3)=>e!==void 0&&[0,1,2].slice(0,n).some(r=>e[3*t+r]),rt=(e,t)=>nt(e.fault,t),tn=(e,t)=>!rt(e,t)&&
nt(e.involved,t,2);function ke(e,t,n){let r=!Yr(w(e,n),w(t,n)),o=t.involved===void 0||nt(t.involved,n);return!!(t.alive[n]&&t.actions?.[n]&&!r&&o)}function _e(e,t,n){
let[r,o]=w(e,n),[s,a]=j[t.actions?.[n]??0];return[r+s,o+a]}function nn(e,t,n){return Array.from({length:n.everCaptured.length},(o,s)=>s).filter(o=>n.everCaptured[o]&&
!t.everCaptured[o]).map(o=>e.nPursuers+o)}function rn(e,t){return Array.from({length:t.alive.length},(r,o)=>o).filter(r=>e.alive[r]&&!t.alive[r])}var on=[-.31,0,.31],sn=[{size:1,at:[[0,0]]},{size:.62,at:[[-.2,.2],[.2,-.2]]},{size:.54,at:[[-.23,.22],[.23,.22],[0,-.22]]},{size:.54,at:[[-.23,.23],[.23,.23],[
-.23,-.23],[.23,-.23]]},{size:.36,at:on.flatMap(e=>on.map(t=>[t,e]))}],Jr=.3,Xr=.35,qr=.55;function me(e,t){let n=new Map;for(let r=0;r<t.alive.length;r++){if(!t.
alive[r])continue;let[o,s]=w(t,r),a=o*e.cols+s,i=n.get(a);i?i.push(r):n.set(a,[r])}return n}function an(e,t){let n=Array.from(t.alive,(r,o)=>{let[s,a]=w(t,o);return{
x:a+.5,y:s+.5,size:1,alpha:0}});for(let r of me(e,t).values()){let o=sn[Math.min(r.length,sn.length)-1];r.forEach((s,a)=>{let[i,l]=o.at[Math.min(a,o.at.length-1)],
d=n[s];d.x+=i,d.y+=l,d.size=o.size,d.alpha=1})}return n}var ln=e=>e*e*(3-2*e),Z=(e,t,n)=>e+(t-e)*n,cn=e=>Math.min(1,Math.max(0,e));function dn(e,t,n,r){let o={SIMULTANEOUS:1,
SWARM_TURNS:2,AGENT_TURNS:n}[e.interaction];if(o===1)return ln(r);let s=o===n?t:+!W(e,t),a=Math.max(1/o,Xr);return ln(cn((r-s/(o-1)*(1-a))/a))}function Re(e,t){
let n=e.moments.length-1,r=Math.min(Math.floor(t),n),o=e.moments[r],s=an(e,o);if(r===n||t===r)return s;let a=e.moments[r+1],i=an(e,a);return s.map((l,d)=>{let u=dn(
e,d,s.length,t-r);return Zr(o,a,d,l,i[d],u)})}function ot(e,t,n){let r=e.moments.length-1,o=Math.min(Math.floor(n),r),[s,a]=[e.moments[o],e.moments[Math.min(o+1,
r)]],i=dn(e,t,s.alive.length,n-o),[[l,d],[u,m]]=[w(s,t),w(a,t)];return[Z(d,m,i)+.5,Z(l,u,i)+.5]}function Zr(e,t,n,r,o,s){let a=r.alpha>o.alpha,i={x:Z(r.x,o.x,s),
y:Z(r.y,o.y,s),size:a?r.size:Z(r.size,o.size,s),alpha:a?cn((1-s)/(1-qr)):Z(r.alpha,o.alpha,s)};if(ke(e,t,n)){let[l,d]=w(e,n),[u,m]=_e(e,t,n),h=Jr*Math.sin(Math.
PI*s);i.x+=(m-d)*h,i.y+=(u-l)*h}return i}var un=2*Math.PI;function pe(e,t,n,r){e.beginPath(),e.arc(t,n,r/2,0,un)}function mn(e,t,n,r){let o=r/2,s=[[0,-.97],[.97,.83],[-.97,.83]].map(([a,i])=>[t+a*o,n+i*
o]);e.beginPath(),e.moveTo((s[2][0]+s[0][0])/2,(s[2][1]+s[0][1])/2),s.forEach(([a,i],l)=>{let[d,u]=s[(l+1)%3];e.arcTo(a,i,d,u,r*.09)}),e.closePath()}function pn(e,t,n,r){
let o=r*.32;e.beginPath(),e.moveTo(t-o,n-o),e.lineTo(t+o,n+o),e.moveTo(t+o,n-o),e.lineTo(t-o,n+o)}function hn(e,t,n,r){e.beginPath();for(let o=0;o<16;o++){let s=r/
2*(o%2?.6:.95),a=un*o/16;e.lineTo(t+s*Math.sin(a),n-s*Math.cos(a))}e.closePath()}function fn(e,t,n,r,o,s){let a=Math.atan2(o-n,r-t);e.beginPath(),e.moveTo(t,n),
e.lineTo(r,o);for(let i of[-1,1])e.moveTo(r,o),e.lineTo(r-s*Math.cos(a+i*.6),o-s*Math.sin(a+i*.6))}var gn=4,Qr=1.6,eo=.95,to=5,no=.16,ro=9,oo=.09,so=.2,bn=.75,A=(e,t)=>e.left+t*e.cell,C=(e,t)=>e.top+t*e.cell;function Q(e,t,n){return W(t,n)?e.colors.pursuer:e.
colors.evader}function yn({ctx:e,grid:t,colors:n}){let{left:r,top:o,cell:s,rows:a,cols:i}=t,[l,d]=[i*s,a*s];if(e.fillStyle=n.paper,e.fillRect(r,o,l,d),s<to)return;
e.fillStyle=n.line;let u=Math.max(1,Math.round(s/60));for(let m=1;m<i;m++)e.fillRect(r+m*s,o,u,d);for(let m=1;m<a;m++)e.fillRect(r,o+m*s,l,u)}function vn({ctx:e,
grid:t,colors:n},r){let{left:o,top:s,cell:a,rows:i,cols:l}=t;e.fillStyle=n.obstacle;for(let d=0;d<i*l;d++){if(!r.obstacles[d])continue;let[u,m]=[Math.floor(d/l),
d%l];e.fillRect(o+m*a,s+u*a,a,a)}wn({ctx:e,grid:t,colors:n})}function wn({ctx:e,grid:{left:t,top:n,cell:r,rows:o,cols:s},colors:a}){let i=Math.min(5,Math.max(2,
Math.round(r/18)));e.strokeStyle=a.frame,e.lineWidth=i,e.strokeRect(t-i/2,n-i/2,s*r+i,o*r+i)}function Sn({ctx:e,grid:t,colors:n},r){let{left:o,top:s,cell:a,rows:i,
cols:l}=t,d=a<24*r?5:1;e.font=`500 ${Math.round(Math.min(15*r,Math.max(9*r,a*.32)))}px system-ui, sans-serif`,e.fillStyle=n.muted,e.textBaseline="alphabetic",e.
textAlign="center";let u=5*r+a/40;for(let m=0;m<l;m+=d)e.fillText(String(m),o+(m+.5)*a,s-u);e.textAlign="right",e.textBaseline="middle";for(let m=0;m<i;m+=d)e.fillText(
String(m),o-u,s+(m+.5)*a)}function xn({grid:e},t,n,r){let o=Math.floor(t.fov/2)+.5,[s,a]=[Math.max(0,n-o),Math.min(e.cols,n+o)],[i,l]=[Math.max(0,r-o),Math.min(
e.rows,r+o)];return[A(e,s),C(e,i),(a-s)*e.cell,(l-i)*e.cell]}function An(e,t,n,r){let{ctx:o,grid:s,colors:a}=e;o.save(),o.beginPath(),o.rect(0,0,o.canvas.width,
o.canvas.height),o.rect(...xn(e,t,n,r)),o.clip("evenodd"),o.clearRect(0,0,o.canvas.width,o.canvas.height),o.fillStyle=a.line,o.fillRect(s.left,s.top,s.cols*s.cell,
s.rows*s.cell),o.restore(),wn(e)}function Cn({ctx:e,grid:t,colors:n},{x:r,y:o,alpha:s},a){let i=Math.max(t.cell,16*a)*1.06,[l,d]=[A(t,r),C(t,o)];e.globalAlpha=Math.
max(s,.6),e.beginPath(),e.roundRect(l-i/2,d-i/2,i,i,i*.2),e.strokeStyle=n.focus,e.lineWidth=Math.max(2,2.5*a),e.stroke();let u=Math.max(11*a,Math.min(18*a,t.cell*
.5));e.font=`700 ${Math.round(u)}px system-ui, sans-serif`,e.textAlign="center",e.textBaseline="middle";let m=d-i/2<u*1.2,h=d+(m?1:-1)*(i/2+u*.7);e.strokeStyle=
n.paper,e.lineJoin="round",e.lineWidth=u*.35,e.strokeText("You",l,h),e.fillStyle=n.ink,e.fillText("You",l,h),e.globalAlpha=1}function Mn(e,t,n,r,o){let{ctx:s,grid:a}=e,
i=xn(e,t,r,o),l=Q(e,t,n);s.globalAlpha=.11,s.fillStyle=l,s.fillRect(...i),s.globalAlpha=.8,s.strokeStyle=l,s.lineWidth=Math.max(1,a.cell/24),s.strokeRect(...i),
s.globalAlpha=1}function En(e,t,n,r,o){let{ctx:s,grid:a}=e,i=Math.min(Math.ceil(n),t.moments.length-1),l=t.moments[i];s.lineCap="round",s.lineWidth=Math.min(ro,
Math.max(1,a.cell*no));for(let d=Math.max(1,Math.floor(n-r)+1);d<=i;d++){let[u,m]=[t.moments[d-1],t.moments[d]],h=Math.max(0,Math.min(1,(n-d)/r));s.globalAlpha=
bn+(so-bn)*h;for(let p=0;p<m.alive.length;p++){let g=d===i&&n<i;if(!u.alive[p]||!(l.alive[p]||g))continue;let f=(W(t,p)?-1:1)*oo,[b,S]=w(u,p),[T,F]=w(m,p);if(b===
T&&S===F)continue;let fe=g?o[p].x:F+.5,br=g?o[p].y:T+.5;s.strokeStyle=Q(e,t,p),s.beginPath(),s.moveTo(A(a,S+.5+f),C(a,b+.5+f)),s.lineTo(A(a,fe+f),C(a,br+f)),s.stroke()}}
s.globalAlpha=1}function Tn(e,t,n){let r=Math.min(Math.ceil(n),t.moments.length-1);for(let o=Math.max(1,r-gn+1);o<=r;o++){let[s,a]=[t.moments[o-1],t.moments[o]],
i=o>n?Math.max(0,1-2*(o-n)):1-(n-o)/gn,l=nn(t,s,a);for(let d of rn(s,a))l.includes(d)||io(e,w(a,d),i);for(let d of l)ao(e,w(a,d),i)}e.ctx.globalAlpha=1}function ao({
ctx:e,grid:t,colors:n},[r,o],s){e.globalAlpha=s,hn(e,A(t,o+.5),C(t,r+.5),Math.max(8,t.cell*Qr)),e.fillStyle=n.capture,e.fill(),e.strokeStyle=n.ink,e.lineWidth=Math.
max(1,t.cell/36),e.lineJoin="round",e.stroke()}function io({ctx:e,grid:t,colors:n},[r,o],s){e.globalAlpha=s,pn(e,A(t,o+.5),C(t,r+.5),Math.max(7,t.cell*eo)),e.strokeStyle=
n.collision,e.lineWidth=Math.max(2,t.cell*.17),e.lineCap="round",e.stroke()}function kn({ctx:e,grid:t,colors:n},r,o){let s=Math.max(1,t.cell*.07);e.strokeStyle=
e.fillStyle=n.collision,e.lineWidth=Math.max(1,t.cell*.05),e.setLineDash([t.cell*.14,t.cell*.1]);for(let[a,i]of r){if(a<0||i<0||a>=t.rows||i>=t.cols)continue;let l=[
A(t,i)+s,C(t,a)+s,t.cell-2*s,t.cell-2*s];e.globalAlpha=.2*o,e.fillRect(...l),e.globalAlpha=o,e.strokeRect(...l)}e.setLineDash([]),e.globalAlpha=1}function _n({ctx:e,
grid:t,colors:n},r,o,s,a){e.globalAlpha=a,pe(e,A(t,r),C(t,o),Math.max(8,t.cell*s*1.02)),e.strokeStyle=n.collision,e.lineWidth=Math.max(1.5,t.cell*.085*Math.sqrt(
s)),e.stroke(),e.globalAlpha=1}var lo=.8,co=.92,uo=15,mo=7,st=9;function Rn(e,t,n,r,o,s){r.forEach((a,i)=>{a.alpha>0&&po(e,t,n,i,a,o,s)}),e.ctx.globalAlpha=1;for(let a of me(t,n).values())a.length>
st&&ho(e,r[a[st-1]],a.length-st+1)}function po(e,t,n,r,o,s,a){let{ctx:i,grid:l,colors:d}=e,u=W(t,r),[m,h]=[l.left+o.x*l.cell,l.top+o.y*l.cell],p=Math.max(4,l.cell*
o.size*(u?co:lo)),g=Q(e,t,r),f=!u&&!!n.captured[r-t.nPursuers];if(i.globalAlpha=o.alpha,(u?mn:pe)(i,m,h,p),p>mo*a&&(i.strokeStyle=d.paper,i.lineWidth=Math.max(2,
p*.1),i.stroke()),i.fillStyle=f?d.paper:g,i.fill(),f&&(pe(i,m,h,p*.82),i.strokeStyle=g,i.lineWidth=p*.18,i.stroke()),!s||p<uo*a)return;let b=String(u?r:r-t.nPursuers);
i.font=`700 ${Math.round(p*(u?.4:.5)*(b.length>1?.8:1))}px system-ui, sans-serif`,i.textAlign="center",i.textBaseline="middle",i.fillStyle=f?g:d.paper,i.fillText(
b,m,h+p*(u?.17:.03))}function ho({ctx:e,grid:t,colors:n},r,o){let[s,a]=[t.left+r.x*t.cell,t.top+r.y*t.cell];e.font=`700 ${Math.round(t.cell*.3)}px system-ui, sa\
ns-serif`,e.textAlign="center",e.textBaseline="middle",e.strokeStyle=n.paper,e.lineWidth=t.cell*.1,e.strokeText(`+${o}`,s,a),e.fillStyle=n.ink,e.fillText(`+${o}`,
s,a)}var fo=.46,go=.86,bo=.66,On=.48,yo=.78,vo=.58;function Ln(e,t,n,r){let[o,s]=[t.moments[n-1],t.moments[n]];if(!o)return;let{ctx:a,grid:i,colors:l}=e;a.strokeStyle=
l.collision,a.lineWidth=Math.max(1.5,i.cell*.07),a.lineCap="butt",a.globalAlpha=r;for(let d=0;d<s.alive.length;d++)ke(o,s,d)&&wo(e,t,w(o,d),_e(o,s,d));a.globalAlpha=
1}function wo({ctx:e,grid:t},n,r,o){let[s,a]=[o[1]-r[1],o[0]-r[0]],i=m=>A(t,r[1]+.5+s*m),l=m=>C(t,r[0]+.5+a*m),d=ue(n,o)?yo:vo;e.setLineDash([t.cell*.09,t.cell*
.06]),e.beginPath(),e.moveTo(i(On),l(On)),e.lineTo(i(d),l(d)),e.stroke(),e.setLineDash([]);let u=.17*t.cell/Math.hypot(s,a);e.beginPath(),e.moveTo(i(d)-a*u,l(d)+
s*u),e.lineTo(i(d)+a*u,l(d)-s*u),e.stroke()}function Nn(e,t,n,r,o,s){let a=j[s];if(!s||!a)return;let{ctx:i,grid:l,colors:d}=e,u=ue(t,[r[0]+a[0],r[1]+a[1]])?go:bo,
m=fo*o.size,h=[A(l,o.x+a[1]*m),C(l,o.y+a[0]*m),A(l,o.x+a[1]*u),C(l,o.y+a[0]*u)],p=Math.max(1.5,l.cell*.085);i.lineCap=i.lineJoin="round";for(let[g,f]of[[d.paper,
p*2.1],[Q(e,t,n),p]])i.strokeStyle=g,i.lineWidth=f,fn(i,...h,l.cell*.2),i.stroke()}var Pn={numbers:!0,axes:!1,trail:6,viewers:[],plan:null,selected:null,cursor:null,you:null,fog:!1};function $n(e,t,n,r,o){let{ctx:s,grid:a,colors:i}=e,l=Math.min(
Math.ceil(n),t.moments.length-1),d=t.moments[l],u=n===l,m=Re(t,n),h=u?1:Math.max(0,1-2*(l-n));s.clearRect(0,0,s.canvas.width,s.canvas.height),yn(e);for(let f of r.
viewers)m[f]?.alpha&&Mn(e,t,f,...ot(t,f,n));vn(e,t),r.axes&&Sn(e,o),En(e,t,n,r.trail,m),kn(e,d.contested??[],h),Tn(e,t,n),Ln(e,t,l,h),m.forEach(({x:f,y:b,size:S},T)=>{
let F=tn(d,T)?.4:0,fe=rt(d,T)?1:F;fe&&_n(e,f,b,S,fe*h)});let p=u?d:t.moments[Math.max(0,l-1)];if(Rn(e,t,p,m,r.numbers,o),u&&r.plan)for(let[f,b]of m.entries())b.
alpha&&Nn(e,t,f,w(d,f),b,r.plan[f]??0);r.you!==null&&(r.fog&&An(e,t,...ot(t,r.you,n)),Cn(e,m[r.you],o)),s.lineWidth=Math.max(2,2.5*o),s.strokeStyle=i.focus;let g=r.
selected===null?void 0:m[r.selected];g?.alpha&&In(e,g.x,g.y,g.size*.96),r.cursor&&(s.setLineDash([a.cell*.12,a.cell*.08]),In(e,r.cursor[1]+.5,r.cursor[0]+.5,.8),
s.setLineDash([]))}function In({ctx:e,grid:t},n,r,o){let s=o*t.cell;e.beginPath(),e.roundRect(t.left+n*t.cell-s/2,t.top+r*t.cell-s/2,s,s,s*.1),e.stroke()}var Un=(e,t)=>(t+.24)/(e+.24);function Dn(e,t,n,r,o,s){let a=n?28*s:0,i=(d,u)=>(d-a)/(u+2*.12),l=Math.max(1,Math.floor(Math.min(i(r,t),i(o,e))));return{rows:e,cols:t,
cell:l,left:Math.round((r-t*l+a)/2),top:Math.round((o-e*l+a)/2)}}function Bn(e,t,n){let r=Math.floor((n-e.top)/e.cell),o=Math.floor((t-e.left)/e.cell);return r>=
0&&r<e.rows&&o>=0&&o<e.cols?[r,o]:null}var So={paper:"--board-paper",line:"--board-line",frame:"--board-frame",ink:"--board-ink",muted:"--board-muted",obstacle:"--board-obstacle",pursuer:"--pursuer",
evader:"--evader",capture:"--capture",collision:"--collision",focus:"--focus"};function Hn(e){let t=getComputedStyle(e),n=Object.entries(So).map(([r,o])=>[r,t.getPropertyValue(
o).trim()]);return Object.fromEntries(n)}var jn=()=>matchMedia("(prefers-reduced-motion: reduce)").matches,Oe=class{canvas;#e=null;#r=0;#n;#t={rows:1,cols:1,left:0,top:0,cell:1};#s=0;#o;#a;constructor(t,n={}){
this.canvas=t,t.classList.add("board"),t.setAttribute("role","img"),this.#n={...Pn,...n},this.#o=new ResizeObserver(()=>this.#l()),this.#o.observe(t),this.#a=new MutationObserver(
()=>this.redraw()),this.#a.observe(document.documentElement,{attributes:!0}),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",this.redraw)}close(){
this.#o.disconnect(),this.#a.disconnect(),matchMedia("(prefers-color-scheme: dark)").removeEventListener("change",this.redraw),cancelAnimationFrame(this.#s)}get look(){
return this.#n}set look(t){this.#n={...this.#n,...t},this.#c(),this.redraw()}show(t,n){this.#e=t,this.#r=Math.min(Math.max(0,n),t.moments.length-1),this.#c(),this.
redraw()}redraw=()=>{this.#s||(this.#s=requestAnimationFrame(()=>this.drawNow()))};drawNow(){cancelAnimationFrame(this.#s),this.#s=0;let t=this.canvas.getContext(
"2d");if(!t||!this.#e)return;let{rows:n,cols:r}=this.#e,o=devicePixelRatio||1;this.#t=Dn(n,r,this.#n.axes,this.canvas.width,this.canvas.height,o);let s={ctx:t,grid:this.#t,
colors:Hn(this.canvas)};$n(s,this.#e,this.#r,this.#n,o)}cellAt(t,n){let r=this.canvas.getBoundingClientRect(),o=this.canvas.width/r.width;return Bn(this.#t,(t-r.
left)*o,(n-r.top)*o)}agentAt(t,n){let r=this.cellAt(t,n);if(!r||!this.#e)return null;let o=this.#e.moments[Math.round(this.#r)],s=me(this.#e,o).get(r[0]*this.#e.
cols+r[1])??[],a=Re(this.#e,Math.round(this.#r)),i=l=>{let[d,u]=this.pointOf(a[l].x,a[l].y);return Math.hypot(d-t,u-n)};return s.length?s.reduce((l,d)=>i(d)<i(l)?
d:l):null}pointOf(t,n){let r=this.canvas.getBoundingClientRect(),o=r.width/this.canvas.width,{left:s,top:a,cell:i}=this.#t;return[r.left+(s+t*i)*o,r.top+(a+n*i)*
o]}#c(){if(!this.#e)return;let{rows:t,cols:n}=this.#e;this.canvas.style.setProperty("--board-aspect",String(Un(t,n)))}#l(){let t=devicePixelRatio||1,{width:n,height:r}=this.
canvas.getBoundingClientRect();this.canvas.width=Math.max(1,Math.round(n*t)),this.canvas.height=Math.max(1,Math.round(r*t)),this.drawNow()}};function Wn(e,t,n){return{rows:e.rows,cols:e.cols,nPursuers:e.n_pursuers,fov:e.fov,interaction:e.rules.interaction,obstacles:t,moments:n}}function Fn(e,t){return{
positions:e.read("last_positions"),alive:e.read("alive"),captured:e.read("captured"),everCaptured:e.read("ever_captured"),actions:t,involved:e.read("involved"),
fault:e.read("fault"),contested:e.conflicts().map(n=>n.cell)}}var Le=class{recording;rules;outcomes=[];#e;#r;#n;#t=[];#s=[];constructor(t,n,r,o){this.#e=n,this.#r=o,this.rules=r;let s=Bt(n,r);this.#n=t.world(s),this.#n.restore(
xo(this.#n,n)),this.recording=Wn(s,this.#n.map(),this.#t),this.#a(void 0);for(let a of n.played)this.#o(a)}follow(t){if(!at(this.#e,t))return!1;let n=this.#e.played,
r=t.played.findIndex((a,i)=>a!==n[i]),o=r<0?t.played.length:r,s=Math.min(o+1,this.#t.length);this.#t.length=this.outcomes.length=this.#s.length=s,this.#n.restore(
this.#s.at(-1));for(let a of t.played.slice(s-1))this.#o(a);return this.#e=t,!0}get length(){return this.#t.length-1}get over(){let{terminated:t,truncated:n}=this.
outcomes.at(-1);return t||n}actions(t){let n=Uint8Array.from(t,o=>typeof o=="number"?o:U),r=new Set(t.filter(o=>typeof o=="string"));for(let o of this.over?[]:r)
for(let s of["pursuer","evader"]){let a=this.#n.decide(o===O?this.#r[s].policy:o,s,n);t.forEach((i,l)=>{i===o&&l<this.#e.pursuers.length==(s==="pursuer")&&(n[l]=
a[l])})}return n}scene(){let t=this.#n,[n,r]=[t.read("last_positions"),t.read("alive")],[o,s]=[t.read("captured"),t.read("ever_captured")],a=this.#e.pursuers.length,
i=E(this.#e).map((l,d)=>({...Ye([n[2*d],n[2*d+1]]),gone:!r[d],captured:d>=a&&!!o[d-a],everCaptured:d>=a&&!!s[d-a]}));return{...this.#e,played:[],steps:t.steps,ended:this.
outcomes.at(-1).terminated,pursuers:i.slice(0,a),evaders:i.slice(a)}}free(){this.#n.free()}#o(t){if(this.over)return;let n=this.actions(t);this.#n.step(n),this.#a(
n)}#a(t){let n=this.#n;this.#t.push(Fn(n,t)),this.#s.push(n.snapshot()),this.outcomes.push({conflicts:t?n.conflicts():[],rewards:n.read("rewards"),captors:n.read(
"captors"),terminated:!!n.read("terminated")[0],truncated:!!n.read("truncated")[0]})}};function xo(e,t){let n=E(t),r=n.map(({cell:s})=>s[0]*t.cols+s[1]),o=s=>Uint8Array.
from(t.evaders,a=>Number(a[s]));return{...e.snapshot(),seed:BigUint64Array.of(t.seed),episode:BigUint64Array.of(t.episode),cells:Int32Array.from(r,(s,a)=>n[a].gone?
-1:s),last_cells:Int32Array.from(r,(s,a)=>n[a].gone?s:-1),captured:o("captured"),ever_captured:o("everCaptured"),capture_paid:o("everCaptured"),captors:new Int32Array(
t.evaders.length),rewards:new Float32Array(x(t)),report:new Int32Array(x(t)),participants:new Int32Array(0),steps:Int32Array.of(t.steps),terminated:Uint8Array.of(
Number(t.ended)),truncated:Uint8Array.of(+(t.steps>=t.maxSteps))}}function at(e,t){return Object.keys(e).every(r=>["played","next","rules","others"].includes(r)||
e[r]===t[r])}var Ao={SIMULTANEOUS:.45,SWARM_TURNS:.9,AGENT_TURNS:1.4},Co=200,Ne=class extends EventTarget{data;player;#e;#r;#n;#t=[];#s=[];#o=[];#a=!1;#c="act";#l=0;#d=null;#u;constructor(t,n,r,o=null){
super(),[this.#d,this.#u]=[o,r],this.#e=t,this.data=n,this.#r=r,this.#n=this.#p(r),this.player=new Te(this.game.length,{still:jn()}),this.player.jump(this.game.
length),this.player.addEventListener("frame",()=>this.#g()),this.#f()}get scene(){return this.#r}get game(){return this.#n[0]}get games(){return this.#n}get mode(){
return this.#c}set mode(t){this.stop(),this.#c=t,this.#h()}get selected(){return this.#l}set selected(t){this.#l=t,this.#h()}get running(){return this.#a}get example(){
return at(this.#u,this.#r)?this.#d:null}get canStep(){return!this.game.over&&this.#r.played.length<X}change(t,n={}){let r;try{r=this.#p(t)}catch(o){if(!(o instanceof
M))throw o;return this.say(o.message,!0),!1}return n.part||(this.#t=[...this.#t,this.#r].slice(-Co)),this.#s=[],n.example!==void 0&&([this.#d,this.#u]=[n.example,
t]),this.#o=[],this.#i(t,r),!0}step(){if(!this.canStep){this.stop(),this.say(this.game.over?"The episode has ended. Go back, or restart.":`The playground plays ${X}\
 steps.`,!0);return}let n=this.#o.at(-1)===this.#r.next?this.#o.slice(0,-1):[],r=Ht(this.#r);this.change({...r,next:n.at(-1)??r.next}),this.#o=n}back(){this.stop();
let{played:t}=this.#r;if(!this.game.length)return;let n=this.#r,r=this.#o.at(-1)===n.next?[...this.#o]:[];for(let o=t.length;o>=this.game.length;o--)n=jt(n),r.push(
n.next);this.change(n),this.#o=r}restart(){this.stop();let{played:t}=this.#r;if(!t.length)return;let n=[...this.#o.at(-1)===this.#r.next?this.#o:[],...[...t].reverse()];
this.change({...this.#r,played:[],next:t[0]}),this.#o=n}run(){if(this.#a)return this.stop();this.#a=this.canStep,this.step()}stop(){this.#a&&(this.#a=!1,this.#h())}undo(){
this.#m(this.#t,this.#s)}redo(){this.#m(this.#s,this.#t)}get canUndo(){return this.#t.length>0}say(t,n=!1){this.dispatchEvent(new CustomEvent("message",{detail:{
text:t,problem:n}}))}#m(t,n){let r=t.pop();r&&(this.stop(),n.push(this.#r),this.#o=[],this.#i(r,this.#p(r)))}#p(t){let n=t.others?[t.rules,t.others]:[t.rules],r=this.#n??
[];return n.map(o=>{let s=r.find(i=>i.rules===o),a=s?.follow(t)?s:new Le(this.#e,t,o,this.data.champions);return a.actions(t.next),a})}#i(t,n){let[r,o]=[this.#r,
this.#n.length];for(let l of this.#n)n.includes(l)||l.free();this.#r=t,this.#n=n,this.#l!==null&&this.#l>=E(t).length&&(this.#l=null);let s=this.game.length,[a,
i]=[this.player.step,r.rules!==t.rules||t.others!==null&&o<2];this.player.length=s,this.#f(),i&&s&&this.player.jump(s-1),i&&s||Math.abs(s-a)===1?this.player.move(
s-this.player.step):this.player.jump(s),this.#h()}#f(){this.player.glide=Ao[this.#r.rules.interaction]}#g(){this.#a&&this.player.arrived&&this.step()}#h(){this.
dispatchEvent(new Event("change"))}};function zn(e,t,n){let r=s=>new Ne(e,t,de(s,t),Kn(t,s)),o=t.gallery[0].scene;try{return{store:r(n||o),problem:""}}catch(s){return{store:r(o),problem:Gn(s)}}}function Gn(e){
if(e instanceof le||e instanceof M)return`This link holds no scene. ${e.message}`;throw e}function Kn(e,t){return e.gallery.find(n=>n.scene===t)??null}function he(){
try{return decodeURIComponent(location.hash.slice(1))}catch{return location.hash.slice(1)}}var Mo=100;function Vn(e){let[t,n,r]=[ce(e.scene,e.data),he(),0],o=()=>{
r=0,he()===n&&(n=t,history.replaceState(null,"",`#${t}`))};e.addEventListener("change",()=>{t=ce(e.scene,e.data),t!==n&&!r&&(r=setTimeout(o,Mo))}),window.addEventListener(
"hashchange",()=>{if(n=he(),n!==t)try{e.change(de(n,e.data),{example:Kn(e.data,n)})}catch(s){e.say(Gn(s),!0)}})}function Yn(){let e=JSON.parse(document.getElementById("data").textContent),t=document.getElementById("champions")?.textContent;return t?{...e,champions:JSON.parse(
t,Eo)}:e}var Eo=(e,t)=>e==="genome"?Float32Array.from(t):t;var To=matchMedia("(prefers-color-scheme: dark)");function ko(){let e=document.documentElement.dataset.theme;return e?e==="dark":To.matches}function it(){document.
documentElement.dataset.theme=ko()?"light":"dark"}function Jn(){return c("button",{type:"button",title:"Light or dark (D)","aria-label":"Light or dark",onclick:it},
"◐")}var Zn={ArrowUp:1,ArrowRight:2,ArrowDown:3,ArrowLeft:4},_o={e:5,c:6,y:7,z:7,q:8};function Qn(e){let t=c("div",{class:"arena"}),n=[Xn(e,0),Xn(e,1)];t.append(...n.
map(o=>o.element));let r=()=>n.forEach(o=>o.update());return e.addEventListener("change",r),e.player.addEventListener("frame",r),r(),t}function Xn(e,t){let n=c(
"canvas",{tabindex:0,"aria-describedby":"board-keys"}),r=c("h2",{class:"arm-name"}),o=c("figure",{class:"arm"},r,n),s=new Oe(n,{axes:!0,trail:1}),a={cell:[0,0]};
Ro(e,s);let i=()=>{let l=e.games[t];if(o.hidden=!l,!l)return;let{mode:d,scene:u}=e;n.setAttribute("role","application"),n.ariaLabel=`Board, ${u.rows} by ${u.cols}\
 cells`,n.dataset.mode=d,r.textContent=I(e,t),r.hidden=e.games.length<2;let m=e.player.arrived&&e.player.step===e.game.length;s.look={plan:d==="act"&&m&&!l.over?
l.actions(u.next):null,selected:d==="act"?e.selected:null,cursor:d==="build"&&document.activeElement===n?a.cell:null},s.show(l.recording,e.player.time)};return n.
addEventListener("focus",i),n.addEventListener("blur",i),No(e,n,a,i),{element:o,update:i}}function I(e,t){let n=t?e.scene.others:e.scene.rules,r=n&&q(n,e.data.variants);
return r?`-${r}`:"own rules"}function lt(e,t){let n=E(e.game.scene())[t];return n&&!n.gone?n.cell:null}function Ro(e,t){let n=null;t.canvas.addEventListener("po\
interdown",r=>{let o=t.cellAt(r.clientX,r.clientY);if(!o||r.button!==0||e.running)return;t.canvas.setPointerCapture(r.pointerId);let s=t.agentAt(r.clientX,r.clientY);
n=e.mode==="build"?Lo(e,o,s):Oo(e,o,s)}),t.canvas.addEventListener("pointermove",r=>{let o=t.cellAt(r.clientX,r.clientY);o&&n?.(o)});for(let r of["pointerup","p\
ointercancel"])t.canvas.addEventListener(r,()=>{n=null})}function Oo(e,t,n){if(n===null){let s=e.selected===null?null:lt(e,e.selected);return s&&Math.max(Math.abs(
s[0]-t[0]),Math.abs(s[1]-t[1]))===1&&ee(e,tt(s,t,e.scene.diagonal)),null}let r=e.selected===n;e.selected=n;let o=lt(e,n);return o?(r&&ee(e,0),s=>ee(e,tt(o,s,e.scene.
diagonal))):null}function Lo(e,t,n){let r=!1,o=i=>{e.change(i,{part:r}),r=!0};if(n!==null)return e.selected=n,i=>{let l=e.game.scene();L(l,i)===null&&!N(l,i)&&o(
qe(l,n,i))};let s=!N(e.game.scene(),t),a=i=>{let l=e.game.scene();L(l,i)===null&&N(l,i)!==s&&o(Ze(l,i,s))};return a(t),a}function ee(e,t){let{selected:n,scene:r}=e;
n===null||e.running||e.game.over||(r.next[n]!==t&&e.change(Ae(r,n,t)),e.say(`${R(r,n)}: ${_[t]}.`))}function No(e,t,n,r){t.addEventListener("keydown",o=>{if(o.ctrlKey||
o.metaKey||o.altKey)return;let s=e.mode==="act"?ct(e,o):Io(e,o,n);r(),s&&o.preventDefault()})}function ct(e,t){let n=t.key.length===1?t.key.toLowerCase():t.key,
r=Zn[n]??(e.scene.diagonal?_o[n]:void 0)??{s:0,Delete:0}[n];return r!==void 0?(e.selected===null&&qn(e,1),ee(e,r),!0):n!=="n"&&n!=="p"?!1:(qn(e,n==="n"?1:-1),!0)}
function qn(e,t){let n=x(e.scene),r=e.game.recording.moments.at(-1).alive,o=e.selected??(t>0?-1:n);for(let s=0;s<n;s++){if(o=(o+t+n)%n,!r[o])continue;e.selected=
o;let[a,i]=lt(e,o);return e.say(`${R(e.scene,o)} at (${a}, ${i}).`)}}function Io(e,t,n){let r=e.game.scene(),o=Zn[t.key];if(o!==void 0){let a=t.shiftKey?L(r,n.cell):
null,i=[n.cell[0]+j[o][0],n.cell[1]+j[o][1]];ue(r,i)&&(n.cell=i);let l=L(r,n.cell)===null&&!N(r,n.cell);a!==null&&l&&e.change(qe(r,a,n.cell));let[d,u]=n.cell;return e.
say(`(${d}, ${u}): ${Po(e,n.cell)}.`),!0}let s=L(r,n.cell);return t.key===" "||t.key==="Enter"?(s===null?e.change(Ze(r,n.cell,!N(r,n.cell))):e.selected=s,!0):t.
key==="Delete"&&s!==null?(e.change(Ce(r,s)),!0):!1}function Po(e,t){let n=e.game.scene(),r=L(n,t);return r!==null?R(n,r):N(n,t)?"obstacle":"free"}var dt=["·","↑","→","↓","←","↗","↘","↙","↖"],er=e=>typeof e=="number"?`${dt[e]} ${_[e]}`:e,$o={obstacle:["obstacle"],teammate:["teammate"],adversary:[
"evader","pursuer"]},Uo=e=>e.length<2?e.join(""):`${e.slice(0,-1).join(", ")} and ${e.at(-1)}`;function Ie(e,t,n){let[r,o,s]=[t.recording.moments[n-1],t.recording.
moments[n],t.outcomes[n]];if(!r||!o||!s)return[];let a=[...s.conflicts.map(l=>Do(e,t.rules,l)),...Bo(e,r,o,s.captors)],i={kind:"calm",text:"No conflict, no capt\
ure.",turn:0,blame:"",cost:"",used:[]};return[...a.length?a:[i],...Ho(e,t,n)]}function Do(e,t,n){let r=n.at_fault.map(d=>R(e,d)),o=t.interaction==="SIMULTANEOUS"?
0:n.turn+1,s=r.length?`At fault: ${Uo(r)}.`:"Nobody is at fault.",a=n.held.length+n.doomed.length>0,i=new Set(n.at_fault.map(d=>tr(e,d,re.indexOf(n.kind))));i.delete(
0);let l=a||!i.size?"":`Allowed, but it costs: ${[...i].map(Pe).join(" and ")}.`;return{kind:n.kind,text:`${n.text}.`,turn:o,blame:s,cost:l,used:$o[n.kind]}}function tr({
pursuers:e,rewards:t},n,r){let o=n<e.length?t.pursuer_collide:t.evader_collide;return typeof o=="number"?o:o[r]}function Pe(e){let t=String(Number(Math.abs(e).toPrecision(
5)));return e<0?`−${t}`:e>0?`+${t}`:"0"}function nr(e,t,n,r){let[o,s,a]=[t.recording.moments[n-1],t.recording.moments[n],t.outcomes[n]];if(!o?.alive[r]||!s||!a)
return"";let{rewards:i}=e,l=r<e.pursuers.length?"pursuer":"evader",d=i.blame==="FAULT"?s.fault:s.involved,u=re.reduce((p,g,f)=>p+(d?.[3*r+f]?tr(e,r,f):0),0),m=a.
rewards[r]-u-i[`${l}_step`],h=Array.from({length:e.evaders.length+1},(p,g)=>g*i[`${l}_capture`]);for(let p of[0,i[`${l}_neighbor`]]){let g=h.find(S=>Math.abs(S+
p-m)<1e-4);if(g===void 0)continue;let f={collision:u,capture:g,neighbour:p,step:i[`${l}_step`]},b=Object.entries(f).filter(([,S])=>S).map(([S,T])=>`${Pe(T)} ${S}`);
return b.length>1?b.join(", "):""}return""}function Bo(e,t,n,r){let o=[];for(let s=0;s<e.evaders.length;s++){let a=e.pursuers.length+s,i=R(e,a),l=t.alive[a]&&!n.
alive[a],d=r[s]?` by ${r[s]} ${r[s]===1?"pursuer":"pursuers"}`:"",u=["capture",...l?["captured_disappear"]:[]];n.captured[s]&&!t.captured[s]?o.push({kind:"captu\
re",text:`${i} is captured${d}${l?" and disappears":""}.`,turn:0,blame:"",cost:"",used:u}):t.captured[s]&&!n.captured[s]&&n.alive[a]&&o.push({kind:"capture",text:`${i}\
 is free again.`,turn:0,blame:"",cost:"",used:["capture"]})}return o}function Ho(e,t,n){let{terminated:r,truncated:o}=t.outcomes[n];if(!r&&!o)return[];let s=t.recording.
moments[n].alive,a=(d,u)=>Array.from(s).slice(d,u).some(Boolean),i=e.pursuers.length,l=`after ${e.maxSteps} steps`;return r&&(l=a(0,i)?"every evader is captured\
 or gone":"no pursuer is left"),r&&!a(i,x(e))&&(l="no evader is left"),[{kind:"end",text:`The episode has ended: ${l}.`,turn:0,blame:"",cost:"",used:[]}]}function $e(e){
return e.split(/(\(-?\d+, -?\d+\)|-[A-Z]{1,3}\b)/).map((t,n)=>n%2?c("span",{class:"whole"},t):t)}function ut(e){let t=e==="pursuers"?$("path",{d:"M12 3 22 20H2z"}):$("circle",{cx:12,cy:12,r:9.5});return $("svg",{viewBox:"0 0 24 24",class:`glyph ${e}`,"aria-\
hidden":!0},t)}function rr(e){let t=[0,1].map(()=>c("th",{class:"reward",scope:"col"})),n=c("tbody"),r=c("table",{class:"agents"},c("thead",{},c("tr",{},c("th",
{scope:"col"},"agent"),c("th",{scope:"col"},"next"),...t)),n),o=c("section",{class:"card agents-card"},c("h2",{},"Agents"),e.data.champions?c("button",{type:"bu\
tton",title:"The networks of the match move all agents but the chosen one",onclick:()=>jo(e)},"Networks move all others"):"",c("div",{class:"agents-scroll"},r)),
s=[],a="",i=()=>{let{scene:l}=e,d=`${l.pursuers.length} ${l.evaders.length} ${l.diagonal}`;d!==a&&(a=d,s=Array.from({length:x(l)},(u,m)=>Wo(e,m)),n.replaceChildren(
...s.map(u=>u.element))),t.forEach((u,m)=>{u.hidden=m>=e.games.length,u.textContent=e.games.length>1&&e.games[m]?I(e,m):"reward",u.title="Reward of the step"}),
s.forEach((u,m)=>zo(e,u,m))};return e.addEventListener("change",i),e.player.addEventListener("step",i),i(),o}function jo(e){e.stop(),e.change({...e.scene,next:e.
scene.next.map((t,n)=>n===e.selected?t:O)})}function Wo(e,t){let{scene:n}=e,r=R(n,t),o=c("select",{"aria-label":`${r} does next`},...Fo(e,n,t));o.addEventListener(
"change",()=>{let u=o.value;e.stop(),e.change(Ae(e.scene,t,/^\d$/.test(u)?Number(u):u))});let s=c("span",{class:"state muted"}),a=c("span",{class:"heard"}),i=c(
"button",{type:"button",class:"agent-name",onclick:()=>e.selected=t},ut(Je(n,t)),r,a),l=[0,1].map(()=>c("td",{class:"reward numbers"}));return{element:c("tr",{},
c("th",{scope:"row"},i),c("td",{},o,s),...l),choice:o,state:s,heard:a,rewards:l}}function Fo(e,t,n){let r=_.slice(0,t.diagonal?9:5).map((i,l)=>c("option",{value:l},
er(l))),o=e.data.scripts.map(({name:i,text:l})=>c("option",{value:i,title:l},i)),s=[c("optgroup",{label:"move"},...r),c("optgroup",{label:"script"},...o)],a=e.data.
champions?.[n<t.pursuers.length?"pursuer":"evader"];return a?[c("option",{value:O},a.name),...s]:s}function zo(e,{element:t,choice:n,state:r,heard:o,rewards:s},a){
let{scene:i,game:l,player:d}=e,u=l.recording.moments[Math.min(d.step,l.length)],m=a-i.pursuers.length,h=m>=0&&!!u.captured[m];t.classList.toggle("chosen",e.selected===
a),t.classList.toggle("gone",!u.alive[a]),n.value=String(i.next[a]),n.disabled=!u.alive[a]||l.over,n.hidden=!u.alive[a],r.hidden=!!u.alive[a],r.textContent=h?"c\
aptured":"gone",t.classList.toggle("captured",h),o.textContent=h?" captured":"",s.forEach((p,g)=>{let f=e.games[g];p.hidden=!f;let b=f?.outcomes[d.step]?.rewards[a],
S=f?nr(i,f,d.step,a):"";p.replaceChildren(d.step&&b!==void 0?Pe(b):"",e.games.length>1?"":c("span",{class:"sum small muted"},S)),p.title=S;let T=l.outcomes[d.step]?.
rewards[a];p.classList.toggle("differs",g>0&&b!==void 0&&T!==b)})}function or(e,...t){let n=c("button",{type:"button",class:"close","aria-label":"Close"},"✕"),r=c("dialog",{"aria-label":e},c("div",{class:"dialog-head"},c("h2",
{},e),n),...t);return n.addEventListener("click",()=>r.close()),r.addEventListener("click",o=>o.target===r&&r.close()),r}function sr(e){let t=c("input",{type:"t\
ext",readonly:!0,"aria-label":"Link"}),n=c("input",{type:"text",readonly:!0,"aria-label":"Scene"}),r=c("p",{class:"muted small",role:"status"}),o=or("Share this\
 scene",c("p",{},"The link holds the whole scene: board, agents, rules and moves. Nothing is sent anywhere."),c("label",{class:"copy",hidden:!xe()},c("span",{},
"Link to this page"),t,c("button",{type:"button",onclick:()=>Ve(t,r)},"Copy")),c("label",{class:"copy"},c("span",{},"Scene, for any copy of the playground"),n,c(
"button",{type:"button",onclick:()=>Ve(n,r)},"Copy")),r);return{element:o,open:()=>{n.value=`#${ce(e.scene,e.data)}`,t.value=location.href.split("#")[0]+n.value,
r.textContent="",o.showModal()}}}var Go=[[["Enter"],"play a step"],[["Backspace"],"take the last step back"],[["Home"],"back to the start"],[["Space"],"run, or \
stop"],[["N","P"],"choose the next agent, or the one before"],[["↑","→","↓","←"],"the chosen agent moves there next"],[["Q","E","C","Y"],"the same on a \
diagonal, where the board allows it"],[["S"],"the chosen agent stays"],[["1","… 9"],"choose a variant"],[["M"],"change between Move and Build"],[["Ctrl Z","Ct\
rl Y"],"undo, redo"],[["L"],"link to this scene"],[["D"],"light or dark"],[["?"],"these keys"]],Ko=[[["↑","→","↓","←"],"move the cursor on the board"],[
["Space"],"draw or erase an obstacle, or choose the agent there"],[["Shift ↑"],"carry the agent under the cursor"],[["+","-"],"add a pursuer, an evader"],[["D\
elete"],"remove the agent under the cursor"]];function ar(){let e=n=>c("dl",{class:"keys"},...n.flatMap(([r,o])=>[c("dt",{},...r.map(s=>c("kbd",{},s))),c("dd",{},
o)])),t=c("div",{class:"keys-columns"},c("div",{},c("h3",{},"Anywhere"),e(Go)),c("div",{},c("h3",{},"On the board, in Build"),e(Ko),c("h3",{},"With mouse or fin\
ger"),c("p",{},"Move: press an agent and drag it towards a cell beside it, or choose it and press that cell."),c("p",{},"Build: drag agents; draw on free cells \
to make obstacles, on obstacles to erase them.")));return or("Keys",t)}function ir(e){let t=e.data.gallery.map(s=>c("button",{type:"button",class:"chip",onclick:()=>{e.stop(),e.mode="act",e.change(de(s.scene,e.data),{example:s}),e.
selected=0}},s.title)),n=c("p",{class:"example-text"}),r=c("nav",{class:"gallery","aria-label":"Examples"},c("div",{class:"chips"},...t),n),o=()=>{e.data.gallery.
forEach((s,a)=>t[a].setAttribute("aria-pressed",String(s===e.example))),n.replaceChildren(...$e(e.example?.text??"A scene of your own. Choose an example, or cha\
nge this one."))};return e.addEventListener("change",o),o(),r}var Vo={first:"M6 5v14M19 5 9 12l10 7z",back:"M17 5 7 12l10 7z",play:"M7 4.5 19 12 7 19.5z",pause:"M8 5v14M16 5v14",forward:"M7 5l10 7-10 7z",last:"M18 5v14M5 5\
l10 7-10 7z"};function mt(e){return $("svg",{viewBox:"0 0 24 24","aria-hidden":"true",class:"icon"},$("path",{d:Vo[e]}))}function lr(e){let t=Yo(e),n=Jo(e),r=qo(e),o=Xo(e),s=c("p",{class:"message",role:"status"});e.addEventListener("message",l=>{let{text:d,problem:u}=l.detail;s.textContent=
d,s.classList.toggle("problem",u)});let a=[t,n,r,o],i=()=>a.forEach(l=>l.update());return e.addEventListener("change",i),e.addEventListener("change",()=>{s.textContent=
"",s.classList.remove("problem")}),e.player.addEventListener("step",i),i(),c("div",{class:"toolbar"},...a.map(l=>l.element),s)}function Ue(e,t,n,r){return c("bu\
tton",{type:"button",title:`${t} (${n})`,onclick:r},mt(e),c("span",{},t))}function Yo(e){let t=Ue("first","Restart","Home",()=>e.restart()),n=Ue("back","Back","\
Backspace",()=>e.back()),r=Ue("forward","Step","Enter",()=>e.step()),o=Ue("play","Run","Space",()=>e.run());return r.classList.add("primary"),r.id="step",{element:c(
"div",{class:"buttons",role:"group","aria-label":"Steps"},t,n,r,o),update:()=>{for(let s of[t,n])s.setAttribute("aria-disabled",String(!e.game.length));r.setAttribute(
"aria-disabled",String(!e.canStep)),o.setAttribute("aria-disabled",String(!e.canStep&&!e.running)),o.replaceChildren(mt(e.running?"pause":"play"),c("span",{},e.
running?"Stop":"Run"))}}}function Jo(e){let t={act:"Move",build:"Build"},n={act:"Choose agents and their moves (M)",build:"Place agents and draw obstacles (M)"},
r=Object.keys(t),o=r.map(s=>c("button",{type:"button",title:n[s],onclick:()=>e.mode=s},t[s]));return{element:c("div",{class:"buttons joined",role:"group","aria-\
label":"What the board does"},...o),update:()=>r.forEach((s,a)=>o[a].setAttribute("aria-pressed",String(e.mode===s)))}}function Xo(e){let t=(s,a,i)=>c("button",
{type:"button",title:`Add ${a} (${i})`,"aria-label":`Add ${a}`,onclick:()=>De(e,s)},"+",ut(s)),n=c("button",{type:"button",title:"Remove the chosen agent (Delet\
e)",onclick:()=>pt(e)},"Remove"),r=[t("pursuers","a pursuer","+"),t("evaders","an evader","-"),n],o=c("div",{class:"buttons",role:"group","aria-label":"Agents"},
...r);return{element:o,update:()=>{o.hidden=e.mode!=="build",n.setAttribute("aria-disabled",String(e.selected===null))}}}function qo(e){let t=[8,7,4,1,0,3,2,5,6],
n=t.map(o=>c("button",{type:"button","aria-label":_[o],title:`The chosen agent: ${_[o]}`,onclick:()=>ee(e,o)},dt[o])),r=c("div",{class:"buttons pad",role:"group",
"aria-label":"Move of the chosen agent"},...n);return{element:r,update:()=>{r.hidden=e.mode==="build";let o=e.selected===null?void 0:e.scene.next[e.selected];t.
forEach((s,a)=>{let i=n[a];i.hidden=s>4&&!e.scene.diagonal,i.setAttribute("aria-disabled",String(e.selected===null||e.game.over)),i.setAttribute("aria-pressed",
String(o===s))})}}}function cr(e){let t=c("button",{type:"button",title:"Undo the last change (Ctrl+Z)",onclick:()=>e.undo()},"Undo"),n=()=>t.setAttribute("aria\
-disabled",String(!e.canUndo));return e.addEventListener("change",n),n(),t}function De(e,t){let n=e.game.scene(),r=zt(n);if(!r)return e.say("Every cell is taken\
.",!0);if(n[t].length>=J)return e.say(`${t}: expected at most ${J}`,!0);let o=t==="pursuers"?n.pursuers.length:x(n);e.change(Wt(n,t,r))&&(e.selected=o)}function pt(e){
let{selected:t}=e;if(t===null)return e.say("Choose an agent to remove.",!0);let n=Ce(e.game.scene(),t);n.pursuers.length&&n.evaders.length?e.change(n):e.say("A \
team needs at least one agent.",!0)}function dr(e,t){let n=Object.keys(e.data.variants),r={Enter:()=>e.step(),Backspace:()=>e.back(),Home:()=>e.restart()," ":()=>e.run(),m:()=>e.mode=e.mode==="act"?
"build":"act",l:t.share,d:it,"?":t.keys},o={"+":()=>De(e,"pursuers"),"-":()=>De(e,"evaders"),Delete:()=>pt(e)};document.addEventListener("keydown",s=>{if(s.defaultPrevented||
document.querySelector("dialog[open]"))return;let a=s.key.length===1?s.key.toLowerCase():s.key;if((s.ctrlKey||s.metaKey)&&!s.altKey){let d={z:()=>s.shiftKey?e.redo():
e.undo(),y:()=>e.redo()}[a];d&&!ur(s.target)&&(s.preventDefault(),d());return}if(s.altKey||Zo(s.target,a))return;let i=n[Number(a)-1],l=r[a]??(e.mode==="build"?
o[a]:void 0);if(l)l();else if(i)e.change({...e.scene,rules:e.data.variants[i]});else if(e.mode!=="act"||!ct(e,s))return;s.preventDefault()})}var ur=e=>e instanceof
HTMLInputElement&&!["radio","checkbox"].includes(e.type);function Zo(e,t){return ur(e)||e instanceof HTMLSelectElement?!0:e instanceof HTMLInputElement?t===" "||
t.startsWith("Arrow"):e instanceof HTMLButtonElement?t===" "||t==="Enter":e instanceof HTMLElement&&e.classList.contains("story-body")&&t.startsWith("Arrow")}function mr(e){let t=[Qo(e),...e.data.fields.map(r=>es(e,r)),ns(e),rs(e)],n=()=>t.forEach(r=>r.update());return e.addEventListener("change",n),e.player.addEventListener(
"step",n),n(),c("section",{class:"card rules"},...t.map(r=>r.element))}var te=(e,t)=>{e.stop(),e.change(t)};function Qo(e){let t=Object.keys(e.data.variants),n=t.
map(o=>c("button",{type:"button",class:"chip",title:e.data.titles[o],onclick:()=>te(e,{...e.scene,rules:e.data.variants[o]})},`-${o}`)),r=c("p",{class:"muted sm\
all variant-title"});return{element:c("div",{class:"variants"},c("h2",{},"Rules"),c("div",{class:"chips",role:"group","aria-label":"Variant"},...n),r),update:()=>{
let o=q(e.scene.rules,e.data.variants);t.forEach((s,a)=>n[a].setAttribute("aria-pressed",String(s===o))),r.textContent=o?e.data.titles[o]:"Rules of your own"}}}
function es(e,t){let n=t.values.map(({name:a})=>{let i=c("input",{type:"radio",name:t.name,value:a});return i.addEventListener("change",()=>te(e,{...e.scene,rules:ts(
e.scene.rules,t,a)})),i}),r=t.values.map(({label:a},i)=>c("label",{},n[i],c("span",{},a))),o=c("span",{class:"used-mark",title:"This rule decided what happened \
in the step that is shown"},c("span",{},"decided")),s=c("fieldset",{class:"field",title:t.text},c("legend",{},t.label,o),c("div",{class:"segments"},...r));return{
element:s,update:()=>{let{rules:a}=e.scene;n.forEach(l=>l.checked=l.value===String(a[t.name])),s.disabled=t.name==="captured_disappear"&&a.capture==="OCCUPATION";
let i=Math.min(e.player.step,e.game.length);o.hidden=!Ie(e.scene,e.game,i).some(l=>l.used.includes(t.name))||s.disabled}}}function ts(e,t,n){return{...e,[t.name]:n===
"true"?!0:n==="false"?!1:n}}function ns(e){let t=Object.keys(e.data.variants),n=c("select",{id:"compare"},c("option",{value:""},"nothing"),c("option",{value:"pr\
esent"},"the present rules"),c("option",{value:"own",hidden:!0},"own rules"),...t.map(r=>c("option",{value:r},`-${r}: ${e.data.titles[r]}`)));return n.addEventListener(
"change",()=>{let r={"":null,present:e.scene.rules}[n.value];te(e,{...e.scene,others:r===void 0?e.data.variants[n.value]:r})}),{element:c("div",{class:"pair"},c(
"label",{for:"compare"},"Compare with"),n),update:()=>{let{others:r}=e.scene,o=r&&t.find(s=>Xe(r,e.data.variants[s]));n.value=r?o??"own":"",n.title=r?`Both boar\
ds play the same moves: ${I(e,0)} and ${I(e,1)}`:""}}}function rs(e){let t=(a,i)=>{let l=c("input",{type:"number",min:1,max:D,"aria-label":i});return l.addEventListener(
"change",()=>{let d={rows:e.scene.rows,cols:e.scene.cols,[a]:Math.round(Number(l.value))};d[a]>=1&&d[a]<=D?os(e,d.rows,d.cols):e.say(`${a}: expected 1 to ${D}, \
got ${l.value||"nothing"}`,!0),l.value=String(e.scene[a])}),l},[n,r]=[t("rows","Rows"),t("cols","Columns")],o=c("input",{type:"checkbox",id:"diagonal"});o.addEventListener(
"change",()=>te(e,{...e.game.scene(),diagonal:o.checked,next:e.scene.next.map(a=>typeof a=="number"&&a>4?0:a)}));let s=c("select",{id:"rewards"},...Object.keys(
e.data.rewards).map(a=>c("option",{value:a},a)),c("option",{value:"own",hidden:!0},"those of the link"));return s.addEventListener("change",()=>te(e,{...e.scene,
rewards:e.data.rewards[s.value]})),{element:c("div",{class:"board-settings"},c("div",{class:"pair"},c("span",{},"Board"),c("span",{class:"sides"},n,"×",r),c("l\
abel",{class:"sides"},o,"diagonal")),c("div",{class:"pair"},c("label",{for:"rewards"},"Rewards"),s)),update:()=>{let{scene:a}=e;document.activeElement!==n&&(n.value=
String(a.rows)),document.activeElement!==r&&(r.value=String(a.cols)),o.checked=a.diagonal;let i=JSON.stringify(a.rewards);s.value=Object.keys(e.data.rewards).find(
l=>JSON.stringify(e.data.rewards[l])===i)??"own"}}}function os(e,t,n){let r=Ft(e.game.scene(),t,n);r.pursuers.length&&r.evaders.length?te(e,r):e.say(`No ${r.pursuers.
length?"evader":"pursuer"} would be left on a ${t} × ${n} board.`,!0)}var pr={obstacle:"obstacle",teammate:"teammates",adversary:"adversaries",capture:"capture",end:"end",calm:""};function hr(e){let t=c("h2"),n=c("div",{class:"sto\
ry-body",tabindex:0,role:"region","aria-label":"What happened"}),r=c("div",{class:"heard",role:"status"}),o=c("section",{class:"card story"},t,n,r),s="",a=()=>{
let i=Math.min(e.player.step,e.game.length),l=e.games.map((u,m)=>{let h=Ie(e.scene,u,i);return{name:e.games.length>1?I(e,m):"",lines:h,ended:i>u.length}}),d=JSON.
stringify([i,l]);d!==s&&(s=d,t.textContent=i?`Step ${i}`:"Start",n.replaceChildren(...l.map(u=>ss(u,i))),r.textContent=i?`Step ${i}. ${l.map(is).join(" ")}`:"")};
return e.addEventListener("change",a),e.player.addEventListener("step",a),a(),o}function ss({name:e,lines:t,ended:n},r){let s=n||!r?c("p",{class:"muted"},n?"The\
 episode had ended.":"Give agents their moves, then play a step."):c("ul",{class:"lines"},...t.map(as));return c("div",{class:"story-part"},e&&c("h3",{},e),s)}function as({
kind:e,text:t,turn:n,blame:r,cost:o}){let s=n?`${pr[e]}, turn ${n}`:pr[e];return c("li",{class:`line line-${e}`},s&&c("span",{class:"tag"},s),c("span",{class:"l\
ine-text"},...$e(t)),r&&c("span",{class:"line-blame muted"},r),o&&c("strong",{},o))}var is=({name:e,lines:t,ended:n})=>[e,...n?["The episode had ended."]:t.map(
({text:r,blame:o,cost:s})=>[r,o,s].filter(Boolean).join(" "))].filter(Boolean).join(" ");function fr(e,t){let n=sr(t),r=ar(),o=()=>r.showModal(),s=c("header",{class:"top"},c("h1",{},c("span",{class:"muted"},"matrixworld "),"playground"),c("div",{class:"\
buttons"},cr(t),c("button",{type:"button",title:"Link to this scene (L)",onclick:n.open},"Share"),c("button",{type:"button",title:"Keys (?)",onclick:o},"Keys"),
Jn())),a=c("main",{class:"layout"},mr(t),c("section",{class:"card stage","aria-label":"Board"},Qn(t),lr(t)),c("div",{class:"side"},hr(t),rr(t)));e.classList.add(
"playground"),e.replaceChildren(s,ir(t),a,n.element,r),dr(t,{share:n.open,keys:o})}async function ls(e){let t=Yn(),{store:n,problem:r}=zn(await Ut(),t,he()||t.scene);fr(e,n),xe()&&Vn(n),r&&n.say(r,!0),Object.assign(window,{playground:n})}var gr=document.
getElementById("page");ls(gr).catch(e=>{throw gr.append(c("p",{class:"card problem",role:"alert"},`The playground could not start: ${e.message}`)),e}).finally(()=>{
document.body.dataset.ready="true"});})();
