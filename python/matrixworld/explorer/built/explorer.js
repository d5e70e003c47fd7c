/* built from web/ by "npm run build"; sources 112fe53582bdace9bddce67fa5fef0eb66bf04423f3c989220bfcf1929b40f86 */
"use strict";(()=>{var jr={SIMULTANEOUS:0,SWARM_TURNS:1,AGENT_TURNS:2},Ye={DISAPPEAR:0,REACH:1,BOUNCE:2},Gr={OCCUPATION:0,SURROUND:1},Vr={FAULT:0,INVOLVED:1};var tr=["obstacle","teammate","adversary"],rr=["vertex","edge","chain"],Kr=["turn","kind","form","first","second","row","col","at_fault","held","doomed"],nr=["p\
ursuer_{number}","evader_{number}"],Yr={obstacle:"{first} ran into the obstacle or border at {cell}",vertex:"{first} and {second} both headed for {cell}",edge:"\
{first} and {second} meant to swap, {first} to {cell}",chain:"{first} headed for {cell}, where {second} had to stay"},qe={"both held":"both bounce","both doomed":"\
both disappear",held:"{agent} bounces",doomed:"{agent} disappears",none:"nobody is stopped"},qr="{event}: {outcome}",or={random:"any action, all equally likely",
still:"always stays",chaser:"moves to where the nearest adversary in view is nearest",fleer:"moves to where the nearest adversary in view is farthest","clumsy-c\
haser":"a chaser that takes any action in half of the steps",hunter:"a chaser of the nearest adversary in view to which no teammate in view is nearer",surrounder:"\
a chaser of the nearest free cell beside an adversary without a teammate","clumsy-fleer":"a fleer that takes any action in half of the steps",dodger:"moves to w\
here all adversaries in view together are farthest"},Zr={free:".GS",blocked:"#@OTW"};var _e=1+Kr.length;function Ze(t,e){return t.replace(/\{(\w+)\}/g,(r,n)=>String(e[n]))}function sr(t,e){return t<e?Ze(nr[0],{number:t}):Ze(nr[1],{number:t-e})}function Rs(t,e){
let[r,n,o,s,a,i,l,...c]=Array.from(t),u=a<0?[s]:[s,a],[p,m,h]=c.map(x=>u.filter((A,y)=>x>>y&1)),g=u.map(x=>sr(x,e)),f=Ze(Yr[a<0?"obstacle":rr[o]],{first:g[0],second:g[g.
length-1],cell:`(${i}, ${l})`}),v=Ze(qr,{event:f,outcome:$s(u.length,m,h,e)});return{kind:tr[n],form:rr[o],agents:u,cell:[i,l],at_fault:p,held:m,doomed:h,turn:r,
text:v}}function $s(t,e,r,n){if(t===2&&e.length===2)return qe["both held"];if(t===2&&r.length===2)return qe["both doomed"];let o=s=>a=>Ze(qe[s],{agent:sr(a,n)});
return[...e.map(o("held")),...r.map(o("doomed"))].join(", ")||qe.none}function bt(t,e){let r=[];for(let n=0;n<t.length;n+=_e)r.push(Rs(t.subarray(n+1,n+_e),e));
return r}var oe=class extends Error{name="EngineError"};function L(t,e,r){let n=typeof r=="string"?`'${r}'`:typeof r=="object"?JSON.stringify(r):String(r);return new oe(
`${t}: expected ${e}, got ${n}`)}var Oe=class{bytes;constructor(e){this.bytes=e}},Qr=0,ir=[Uint8Array,Uint8Array,Int32Array,BigInt64Array,BigUint64Array,Float32Array,Float64Array],Jr=4,Xr=4,_s=new TextEncoder,
Os=new TextDecoder;function Ps(t){for(let e=ir.length-1;e>Qr;--e)if(t instanceof ir[e])return e;throw new TypeError("array: expected a typed array of the engine\
's numbers, got another")}function ar(t){return new Uint8Array(t.buffer,t.byteOffset,t.byteLength)}function Ls(t){return _s.encode(`${t}\0`)}var lr=class{engine;addresses=[];constructor(e){
this.engine=e}copy(e){let r=this.engine._malloc(Math.max(e.length,1));if(r===0)throw new oe("memory: expected room for the arguments, got none");return this.addresses.
push(r),this.engine.HEAPU8.set(e,r),r}text(e){return this.copy(Ls(e))}arrays(e){let r=Object.entries(e),n=r.flatMap(([s,a])=>{let i=a instanceof Oe,l=i?a.bytes:
a;return[this.text(s),i?Qr:Ps(l),l.length,this.copy(ar(l))]}),o=this.copy(ar(Int32Array.from(n)));return this.copy(ar(Int32Array.of(r.length,o)))}free(){for(let e of this.
addresses)this.engine._free(e)}};function en(t,e){let r=t.HEAPU8;return Os.decode(r.subarray(e,r.indexOf(0,e)))}function wt(t){let e=new Int32Array(t.HEAPU8.buffer),
r=t._last_outputs()/Jr,n=e[r+1]/Jr,o={};for(let s=n;s<n+e[r]*Xr;s+=Xr){let a=ir[e[s+1]],i=e[s+2]*a.BYTES_PER_ELEMENT,l=e[s+3];o[en(t,e[s])]=new a(t.HEAPU8.slice(
l,l+i).buffer)}return o}function Je(t,e){let r=new lr(t);try{let n=e(r);if(n===0)throw new oe(en(t,t._last_error()));return n}finally{r.free()}}var Is=2**31-1,Ns=2n**64n-1n,Us=34028234663852886e22;function ue(t,e){if(typeof e!="number"||!Number.isInteger(e)||Math.abs(e)>Is)throw L(t,"an integer",e);return Int32Array.
of(e)}function xt(t,e){if(typeof e!="boolean")throw L(t,"true or false",e);return new Oe(Uint8Array.of(Number(e)))}function Se(t,e,r){let n=typeof e=="string"&&
Object.hasOwn(r,e)?r[e]:void 0;if(n===void 0)throw L(t,`one of ${Object.keys(r).join(", ")}`,e);return Int32Array.of(n)}function cr(t,e){if(typeof e!="number"||
!(Math.abs(e)<=Us))throw L(t,"a finite number",e);return e}function Pe(t,e){let n=typeof e=="bigint"||typeof e=="number"&&Number.isSafeInteger(e)?BigInt(e):-1n;
if(n<0n||n>Ns)throw L(t,"an integer from 0 to 2^64 - 1",e);return BigUint64Array.of(n)}function Fs(t){return{"rules.interaction":Se("interaction",t.interaction,
jr),"rules.obstacle":Se("obstacle",t.obstacle,Ye),"rules.teammate":Se("teammate",t.teammate,Ye),"rules.evader":Se("evader",t.evader,Ye),"rules.pursuer":Se("purs\
uer",t.pursuer,Ye),"rules.capture":Se("capture",t.capture,Gr),"rules.captured_disappear":xt("captured_disappear",t.captured_disappear)}}function tn(t,e){let r=typeof e==
"number"?[e,e,e]:e;if(!Array.isArray(r)||r.length!==3)throw L(t,"1 or 3 numbers",e);return Float32Array.from(r,n=>cr(t,n))}function Ds(t){let e=(r,n)=>Float32Array.
of(cr(r,t[r]),cr(n,t[n]));return{"rewards.capture":e("pursuer_capture","evader_capture"),"rewards.neighbor":e("pursuer_neighbor","evader_neighbor"),"rewards.ste\
p":e("pursuer_step","evader_step"),"rewards.pursuer_collide":tn("pursuer_collide",t.pursuer_collide),"rewards.evader_collide":tn("evader_collide",t.evader_collide),
"rewards.blame":Se("blame",t.blame,Vr),"rewards.capture_repeats":xt("capture_repeats",t.capture_repeats)}}function nn(t){if(t===void 0||typeof t=="number")return new Uint8Array(
0);if(t instanceof Uint8Array)return t;let{free:e,blocked:r}=Zr;for(let[n,o]of t.entries()){if(o.length!==t[0]?.length)throw L(`map, row ${n}`,`${t[0]?.length} \
cells as in row 0`,o.length);let s=[...o].find(a=>!e.includes(a)&&!r.includes(a));if(s)throw L(`map, row ${n}`,`'${e}' (free) or '${r}' (obstacle)`,s)}return Uint8Array.
from([...t.join("")],n=>Number(r.includes(n)))}function on(t,e){if(!Array.isArray(t))return;let r=[t.length,t[0]?.length??0];if(!(r[0]===e.rows&&r[1]===e.cols))
throw L("obstacle map",`shape (${e.rows}, ${e.cols}), the rows and cols`,r)}function St(t){on(t.obstacles,t);let e=typeof t.obstacles=="number"?t.obstacles:0;return{
...Fs(t.rules),...Ds(t.rewards),rows:ue("rows",t.rows),cols:ue("cols",t.cols),n_pursuers:ue("n_pursuers",t.n_pursuers),n_evaders:ue("n_evaders",t.n_evaders),fov:ue(
"fov",t.fov),diagonal:xt("diagonal",t.diagonal),max_steps:ue("max_steps",t.max_steps),density:Float64Array.of(e),map:nn(t.obstacles)}}function rn(t,e){return Int32Array.
from((e??[]).flat(),r=>ue(t,r)[0])}function sn(t,e){return on(t.obstacles,e),{seed:Pe("seed",t.seed??0n),episode:Pe("episode",t.episode??0),pursuers:rn("pursuer\
s",t.pursuers),evaders:rn("evaders",t.evaders),map:nn(t.obstacles)}}function At(t){return{actions:Int32Array.from(t,e=>ue("actions",e)[0])}}function Le(t){if(typeof t==
"string"){if(!Object.hasOwn(or,t))throw L("policy",`one of ${Object.keys(or).join(", ")}`,t);return{script:new TextEncoder().encode(t)}}if(t.activation!=="relu"&&
t.activation!=="tanh")throw L("activation","'relu' or 'tanh'",t.activation);return{hidden:Int32Array.from(t.hidden,e=>ue("hidden",e)[0]),activation:new TextEncoder().
encode(t.activation),sampled:xt("sampled",t.sampled),genome:t.genome}}var zs=["first_turn","terminated","truncated"];function an(t){let e={...t};for(let r of zs)
e[r]=new Oe(t[r]);return e}var Mt=class{config;seed;episode;n_agents;statistics;positions;last_positions;alive;captured;ever_captured;actions;rewards;involved;fault;map;conflict_table;first_conflict;constructor(e,r,n,o){
this.config=e,this.seed=r,this.episode=n,this.n_agents=e.n_pursuers+e.n_evaders,this.statistics=ln(o,0),this.positions=o.positions,this.last_positions=o.last_positions,
this.alive=o.alive,this.captured=o.captured,this.ever_captured=o.ever_captured,this.actions=o.actions,this.rewards=o.rewards,this.involved=o.involved,this.fault=
o.fault,this.map=o.map,this.conflict_table=o.conflict_table,this.first_conflict=Bs(this.conflict_table,this.length)}get length(){return this.actions.length/this.
n_agents}conflicts(e){this.check(e);let[r,n]=[this.first_conflict[e],this.first_conflict[e+1]],o=this.conflict_table.subarray(r*_e,n*_e);return bt(o,this.config.
n_pursuers)}seek(e,r){this.check(r),(!(e.seed===this.seed&&e.episode===BigInt(this.episode))||e.turn!==0||e.steps>r)&&e.reset({seed:this.seed,episode:this.episode});
for(let o=e.steps;o<r;++o)e.step(this.actions.subarray(o*this.n_agents,(o+1)*this.n_agents))}check(e){if(!(Number.isInteger(e)&&e>=0&&e<=this.length))throw L("s\
tep",`0 to ${this.length}`,e)}};function Bs(t,e){let r=new Int32Array(e+2);for(let n=0;n<t.length;n+=_e)++r[t[n]+1];for(let n=1;n<r.length;++n)r[n]+=r[n-1];return r}
function ln(t,e){let r=t["statistics.length"].length,n=s=>{let a=t[`statistics.${s}`],i=a.length/r;return a.slice(e*i,(e+1)*i)},o=s=>Number(n(s)[0]);return{capture_rate:o(
"capture_rate"),ever_capture_rate:o("ever_capture_rate"),captured_fraction:o("captured_fraction"),length:o("length"),return:n("return"),survivors:n("survivors"),
overlap:n("overlap"),collisions:n("collisions"),faults:n("faults"),agent_steps:n("agent_steps")}}function cn(t,e,r,n){let o=[St(r.config),Le(r.pursuers),Le(r.evaders),
n];return Je(t,s=>{let[a,i,l,c]=o.map(u=>s.arrays(u));return t[e](a,i,l,c)}),wt(t)}function un(t,e,r,n){let o={seed:Pe("seed",r),episode:Pe("episode",n)};return new Mt(
e.config,r,n,cn(t,"_play_match",e,o))}function dn(t,e,r,n){if(!Number.isInteger(n)||n<1)throw L("n_episodes","at least 1",n);let o={seed:Pe("seed",r),n_episodes:Int32Array.
of(n)},s=cn(t,"_play_rollout",e,o);return Array.from({length:n},(a,i)=>ln(s,i))}var pn=new FinalizationRegistry(([t,e])=>t._world_free(e)),Xe=class{config;n_agents;n_actions;engine;at;freed=!1;constructor(e,r){this.engine=e,this.config=r,this.
n_agents=r.n_pursuers+r.n_evaders,this.n_actions=r.diagonal?9:5,this.at=Je(e,n=>e._world_new(n.arrays(St(r)))),pn.register(this,[e,this.at],this)}free(){this.freed||
(this.freed=!0,pn.unregister(this),this.engine._world_free(this.at))}reset(e={}){let r=sn(e,this.config);this.call(n=>this.engine._world_reset(this.at,n.arrays(
r)))}step(e){let r=At(e);this.call(n=>this.engine._world_step(this.at,n.arrays(r)))}playTurn(e){let r=At(e);this.call(n=>this.engine._world_play_turn(this.at,n.
arrays(r)))}decide(e,r,n){let{n_pursuers:o}=this.config,s={pursuer:[0,o],evader:[o,this.n_agents]},[a,i]=typeof r=="string"?s[r]:r;if(n.length!==this.n_agents)throw L(
"actions",String(this.n_agents),n.length);let l=[Le(e),At(n)],{actions:c}=this.call(u=>this.engine._world_decide(this.at,u.arrays(l[0]),a,i,u.arrays(l[1])));return Uint8Array.
from(c)}get n_turns(){return this.turnNumbers()[1]}get turn(){return this.turnNumbers()[0]}get actors(){let[,,e,r]=this.turnNumbers();return[e,r]}turnNumbers(){
return this.call(()=>this.engine._world_turn(this.at)).turn}get steps(){return this.read("steps")[0]}get seed(){return this.read("seed")[0]}get episode(){return this.
read("episode")[0]}get over(){return this.read("terminated")[0]===1||this.read("truncated")[0]===1}read(e){return this.call(r=>this.engine._world_read(this.at,r.
text(e)))[e]}view(e){let r=3*this.config.fov**2;return this.read("views").slice(e*r,(e+1)*r)}map(){return this.read("state").slice(2*this.config.rows*this.config.
cols)}conflicts(){return bt(this.conflictTable(),this.config.n_pursuers)}conflictTable(){return this.call(()=>this.engine._world_conflicts(this.at)).conflict_table}answer(e,r){
let n=Le(e),{logits:o}=this.call(i=>this.engine._world_logits(this.at,i.arrays(n),r)),s=o,a=this.decide(e,[r,r+1],new Uint8Array(this.n_agents))[r];return{logits:s,
probabilities:Ws(s),action:a}}snapshot(){return this.call(()=>this.engine._world_snapshot(this.at))}restore(e){let r=an(e);this.call(n=>this.engine._world_restore(
this.at,n.arrays(r)))}call(e){if(this.freed)throw L("world","one that is in use","one that was freed");return Je(this.engine,e),wt(this.engine)}};function Ws(t){
let e=Math.max(...t),r=Array.from(t,o=>Math.exp(o-e)),n=r.reduce((o,s)=>o+s,0);return Float32Array.from(r,o=>o/n)}var ur=class{compiled;constructor(e){this.compiled=e}world(e){return new Xe(this.compiled,e)}match(e,r,n,o,s=0){return un(this.compiled,{config:e,pursuers:r,evaders:n},
o,s)}rollout(e,r,n,o,s){return dn(this.compiled,{config:e,pursuers:r,evaders:n},o,s)}},mn;function hn(t=globalThis.matrixworldEngine){return mn??=Hs(t),mn}async function Hs(t){
if(!t)throw new Error("matrixworldEngine: expected the script engine.js before this one, got none");let e=Uint8Array.from(atob(t.binary),r=>r.charCodeAt(0));return new ur(
await t({wasmBinary:e}))}var js="http://www.w3.org/2000/svg";function d(t,e={},...r){return fn(document.createElement(t),e,r)}function b(t,e={},...r){return fn(document.createElementNS(
js,t),e,r)}function fn(t,e,r){for(let[n,o]of Object.entries(e))o==null||o===!1||(typeof o=="function"?t.addEventListener(n.slice(2),o):t.setAttribute(n,o===!0?"":
String(o)));return t.append(...r.filter(Gs).map(n=>typeof n=="number"?String(n):n)),t}function Gs(t){return t!=null&&t!==!1}var Vs=matchMedia("(prefers-color-scheme: dark)");function Ks(){let t=document.documentElement.dataset.theme;return t?t==="dark":Vs.matches}function dr(){document.
documentElement.dataset.theme=Ks()?"light":"dark"}function gn(){return d("button",{type:"button",title:"Light or dark (D)","aria-label":"Light or dark",onclick:dr},"◐")}var Ys=2n**64n-1n;function Qe(t,e,r){let n=new URLSearchParams(t.replace(/^#/,"")),o=(c,u,p)=>{let m=n.get(c)??"";return/^\d{1,9}$/.test(m)&&Number(m)<u?Number(
m):p},s=o("run",e.length,r.run),[a,i]=e[s].payoff.shape,l=n.get("seed")??"";return{run:s,pursuer:o("pursuers",a,Math.min(r.pursuer,a-1)),evader:o("evaders",i,Math.
min(r.evader,i-1)),episode:o("episode",1/0,r.episode),seed:/^\d{1,20}$/.test(l)&&BigInt(l)<=Ys?l:null,step:o("step",1/0,0)}}function yn(t,e,r){let n="",o=()=>{let{
run:s,pursuer:a,evader:i,episode:l,seed:c}=e.selected,u={run:s,pursuers:a,evaders:i,episode:l,...c===null?{}:{seed:c},step:r.player.step};n=`#${Object.entries(u).
map(([p,m])=>`${p}=${m}`).join("&")}`;try{history.replaceState(null,"",n)}catch{}};e.on("match",o),r.player.addEventListener("state",()=>r.player.playing||o()),
r.player.addEventListener("step",()=>r.player.playing||o()),window.addEventListener("hashchange",()=>{if(location.hash===n)return;let{step:s,...a}=Qe(location.hash,
t,e.selected);e.select(a),r.goTo(s)})}var O=Uint8Array,Y=Uint16Array,wr=Int32Array,Ct=new O([0,0,0,0,0,0,0,0,1,1,1,1,2,2,2,2,3,3,3,3,4,4,4,4,5,5,5,5,0,0,0,0]),Tt=new O([0,0,0,0,1,1,2,2,3,3,4,4,5,5,6,
6,7,7,8,8,9,9,10,10,11,11,12,12,13,13,0,0]),fr=new O([16,17,18,0,8,7,9,6,10,5,11,4,12,3,13,2,14,1,15]),An=function(t,e){for(var r=new Y(31),n=0;n<31;++n)r[n]=e+=
1<<t[n-1];for(var o=new wr(r[30]),n=1;n<30;++n)for(var s=r[n];s<r[n+1];++s)o[s]=s-r[n]<<5|n;return{b:r,r:o}},Mn=An(Ct,2),En=Mn.b,gr=Mn.r;En[28]=258,gr[258]=28;var Cn=An(
Tt,0),qs=Cn.b,vn=Cn.r,yr=new Y(32768);for(C=0;C<32768;++C)de=(C&43690)>>1|(C&21845)<<1,de=(de&52428)>>2|(de&13107)<<2,de=(de&61680)>>4|(de&3855)<<4,yr[C]=((de&65280)>>
8|(de&255)<<8)>>1;var de,C,se=(function(t,e,r){for(var n=t.length,o=0,s=new Y(e);o<n;++o)t[o]&&++s[t[o]-1];var a=new Y(e);for(o=1;o<e;++o)a[o]=a[o-1]+s[o-1]<<1;
var i;if(r){i=new Y(1<<e);var l=15-e;for(o=0;o<n;++o)if(t[o])for(var c=o<<4|t[o],u=e-t[o],p=a[t[o]-1]++<<u,m=p|(1<<u)-1;p<=m;++p)i[yr[p]>>l]=c}else for(i=new Y(
n),o=0;o<n;++o)t[o]&&(i[o]=yr[a[t[o]-1]++]>>15-t[o]);return i}),ye=new O(288);for(C=0;C<144;++C)ye[C]=8;var C;for(C=144;C<256;++C)ye[C]=9;var C;for(C=256;C<280;++C)
ye[C]=7;var C;for(C=280;C<288;++C)ye[C]=8;var C,rt=new O(32);for(C=0;C<32;++C)rt[C]=5;var C,Zs=se(ye,9,0),Js=se(ye,9,1),Xs=se(rt,5,0),Qs=se(rt,5,1),pr=function(t){
for(var e=t[0],r=1;r<t.length;++r)t[r]>e&&(e=t[r]);return e},te=function(t,e,r){var n=e/8|0;return(t[n]|t[n+1]<<8)>>(e&7)&r},mr=function(t,e){var r=e/8|0;return(t[r]|
t[r+1]<<8|t[r+2]<<16)>>(e&7)},xr=function(t){return(t+7)/8|0},Sr=function(t,e,r){return(e==null||e<0)&&(e=0),(r==null||r>t.length)&&(r=t.length),new O(t.subarray(
e,r))};var ea=["unexpected EOF","invalid block type","invalid length/literal","invalid distance","stream finished","no stream handler",,"no callback","invalid UTF-8 da\
ta","extra field too long","date not in range 1980-2099","filename too long","stream finishing","invalid zip data"],H=function(t,e,r){var n=new Error(e||ea[t]);
if(n.code=t,Error.captureStackTrace&&Error.captureStackTrace(n,H),!r)throw n;return n},ta=function(t,e,r,n){var o=t.length,s=n?n.length:0;if(!o||e.f&&!e.l)return r||
new O(0);var a=!r,i=a||e.i!=2,l=e.i;a&&(r=new O(o*3));var c=function(Ve){var Ke=r.length;if(Ve>Ke){var $e=new O(Math.max(Ke*2,Ve));$e.set(r),r=$e}},u=e.f||0,p=e.
p||0,m=e.b||0,h=e.l,g=e.d,f=e.m,v=e.n,x=o*8;do{if(!h){u=te(t,p,1);var A=te(t,p+1,3);if(p+=3,A)if(A==1)h=Js,g=Qs,f=9,v=5;else if(A==2){var T=te(t,p,31)+257,k=te(
t,p+10,15)+4,E=T+te(t,p+5,31)+1;p+=14;for(var S=new O(E),N=new O(19),P=0;P<k;++P)N[fr[P]]=te(t,p+P*3,7);p+=k*3;for(var z=pr(N),ge=(1<<z)-1,G=se(N,z,1),P=0;P<E;){
var B=G[te(t,p,ge)];p+=B&15;var y=B>>4;if(y<16)S[P++]=y;else{var U=0,$=0;for(y==16?($=3+te(t,p,3),p+=2,U=S[P-1]):y==17?($=3+te(t,p,7),p+=3):y==18&&($=11+te(t,p,
127),p+=7);$--;)S[P++]=U}}var W=S.subarray(0,T),F=S.subarray(T);f=pr(W),v=pr(F),h=se(W,f,1),g=se(F,v,1)}else H(1);else{var y=xr(p)+4,w=t[y-4]|t[y-3]<<8,M=y+w;if(M>
o){l&&H(0);break}i&&c(m+w),r.set(t.subarray(y,M),m),e.b=m+=w,e.p=p=M*8,e.f=u;continue}if(p>x){l&&H(0);break}}i&&c(m+131072);for(var Ge=(1<<f)-1,Z=(1<<v)-1,ce=p;;ce=
p){var U=h[mr(t,p)&Ge],V=U>>4;if(p+=U&15,p>x){l&&H(0);break}if(U||H(2),V<256)r[m++]=V;else if(V==256){ce=p,h=null;break}else{var K=V-254;if(V>264){var P=V-257,_=Ct[P];
K=te(t,p,(1<<_)-1)+En[P],p+=_}var ne=g[mr(t,p)&Z],ke=ne>>4;ne||H(3),p+=ne&15;var F=qs[ke];if(ke>3){var _=Tt[ke];F+=mr(t,p)&(1<<_)-1,p+=_}if(p>x){l&&H(0);break}i&&
c(m+131072);var Re=m+K;if(m<F){var yt=s-F,vt=Math.min(F,Re);for(yt+m<0&&H(3);m<vt;++m)r[m]=n[yt+m]}for(;m<Re;++m)r[m]=r[m-F]}}e.l=h,e.p=ce,e.b=m,e.f=u,h&&(u=1,e.
m=f,e.d=g,e.n=v)}while(!u);return m!=r.length&&a?Sr(r,0,m):r.subarray(0,m)},pe=function(t,e,r){r<<=e&7;var n=e/8|0;t[n]|=r,t[n+1]|=r>>8},et=function(t,e,r){r<<=
e&7;var n=e/8|0;t[n]|=r,t[n+1]|=r>>8,t[n+2]|=r>>16},hr=function(t,e){for(var r=[],n=0;n<t.length;++n)t[n]&&r.push({s:n,f:t[n]});var o=r.length,s=r.slice();if(!o)
return{t:kn,l:0};if(o==1){var a=new O(r[0].s+1);return a[r[0].s]=1,{t:a,l:1}}r.sort(function(M,T){return M.f-T.f}),r.push({s:-1,f:25001});var i=r[0],l=r[1],c=0,
u=1,p=2;for(r[0]={s:-1,f:i.f+l.f,l:i,r:l};u!=o-1;)i=r[r[c].f<r[p].f?c++:p++],l=r[c!=u&&r[c].f<r[p].f?c++:p++],r[u++]={s:-1,f:i.f+l.f,l:i,r:l};for(var m=s[0].s,n=1;n<
o;++n)s[n].s>m&&(m=s[n].s);var h=new Y(m+1),g=vr(r[u-1],h,0);if(g>e){var n=0,f=0,v=g-e,x=1<<v;for(s.sort(function(T,k){return h[k.s]-h[T.s]||T.f-k.f});n<o;++n){
var A=s[n].s;if(h[A]>e)f+=x-(1<<g-h[A]),h[A]=e;else break}for(f>>=v;f>0;){var y=s[n].s;h[y]<e?f-=1<<e-h[y]++-1:++n}for(;n>=0&&f;--n){var w=s[n].s;h[w]==e&&(--h[w],
++f)}g=e}return{t:new O(h),l:g}},vr=function(t,e,r){return t.s==-1?Math.max(vr(t.l,e,r+1),vr(t.r,e,r+1)):e[t.s]=r},bn=function(t){for(var e=t.length;e&&!t[--e];)
;for(var r=new Y(++e),n=0,o=t[0],s=1,a=function(l){r[n++]=l},i=1;i<=e;++i)if(t[i]==o&&i!=e)++s;else{if(!o&&s>2){for(;s>138;s-=138)a(32754);s>2&&(a(s>10?s-11<<5|
28690:s-3<<5|12305),s=0)}else if(s>3){for(a(o),--s;s>6;s-=6)a(8304);s>2&&(a(s-3<<5|8208),s=0)}for(;s--;)a(o);s=1,o=t[i]}return{c:r.subarray(0,n),n:e}},tt=function(t,e){
for(var r=0,n=0;n<e.length;++n)r+=t[n]*e[n];return r},Tn=function(t,e,r){var n=r.length,o=xr(e+2);t[o]=n&255,t[o+1]=n>>8,t[o+2]=t[o]^255,t[o+3]=t[o+1]^255;for(var s=0;s<
n;++s)t[o+s+4]=r[s];return(o+4+n)*8},wn=function(t,e,r,n,o,s,a,i,l,c,u){pe(e,u++,r),++o[256];for(var p=hr(o,15),m=p.t,h=p.l,g=hr(s,15),f=g.t,v=g.l,x=bn(m),A=x.c,
y=x.n,w=bn(f),M=w.c,T=w.n,k=new Y(19),E=0;E<A.length;++E)++k[A[E]&31];for(var E=0;E<M.length;++E)++k[M[E]&31];for(var S=hr(k,7),N=S.t,P=S.l,z=19;z>4&&!N[fr[z-1]];--z)
;var ge=c+5<<3,G=tt(o,ye)+tt(s,rt)+a,B=tt(o,m)+tt(s,f)+a+14+3*z+tt(k,N)+2*k[16]+3*k[17]+7*k[18];if(l>=0&&ge<=G&&ge<=B)return Tn(e,u,t.subarray(l,l+c));var U,$,W,
F;if(pe(e,u,1+(B<G)),u+=2,B<G){U=se(m,h,0),$=m,W=se(f,v,0),F=f;var Ge=se(N,P,0);pe(e,u,y-257),pe(e,u+5,T-1),pe(e,u+10,z-4),u+=14;for(var E=0;E<z;++E)pe(e,u+3*E,
N[fr[E]]);u+=3*z;for(var Z=[A,M],ce=0;ce<2;++ce)for(var V=Z[ce],E=0;E<V.length;++E){var K=V[E]&31;pe(e,u,Ge[K]),u+=N[K],K>15&&(pe(e,u,V[E]>>5&127),u+=V[E]>>12)}}else
U=Zs,$=ye,W=Xs,F=rt;for(var E=0;E<i;++E){var _=n[E];if(_>255){var K=_>>18&31;et(e,u,U[K+257]),u+=$[K+257],K>7&&(pe(e,u,_>>23&31),u+=Ct[K]);var ne=_&31;et(e,u,W[ne]),
u+=F[ne],ne>3&&(et(e,u,_>>5&8191),u+=Tt[ne])}else et(e,u,U[_]),u+=$[_]}return et(e,u,U[256]),u+$[256]},ra=new wr([65540,131080,131088,131104,262176,1048704,1048832,
2114560,2117632]),kn=new O(0),na=function(t,e,r,n,o,s){var a=s.z||t.length,i=new O(n+a+5*(1+Math.ceil(a/7e3))+o),l=i.subarray(n,i.length-o),c=s.l,u=(s.r||0)&7;if(e){
u&&(l[0]=s.r>>3);for(var p=ra[e-1],m=p>>13,h=p&8191,g=(1<<r)-1,f=s.p||new Y(32768),v=s.h||new Y(g+1),x=Math.ceil(r/3),A=2*x,y=function(er){return(t[er]^t[er+1]<<
x^t[er+2]<<A)&g},w=new wr(25e3),M=new Y(288),T=new Y(32),k=0,E=0,S=s.i||0,N=0,P=s.w||0,z=0;S+2<a;++S){var ge=y(S),G=S&32767,B=v[ge];if(f[G]=B,v[ge]=G,P<=S){var U=a-
S;if((k>7e3||N>24576)&&(U>423||!c)){u=wn(t,l,0,w,M,T,E,N,z,S-z,u),N=k=E=0,z=S;for(var $=0;$<286;++$)M[$]=0;for(var $=0;$<30;++$)T[$]=0}var W=2,F=0,Ge=h,Z=G-B&32767;
if(U>2&&ge==y(S-Z))for(var ce=Math.min(m,U)-1,V=Math.min(32767,S),K=Math.min(258,U);Z<=V&&--Ge&&G!=B;){if(t[S+W]==t[S+W-Z]){for(var _=0;_<K&&t[S+_]==t[S+_-Z];++_)
;if(_>W){if(W=_,F=Z,_>ce)break;for(var ne=Math.min(Z,_-2),ke=0,$=0;$<ne;++$){var Re=S-Z+$&32767,yt=f[Re],vt=Re-yt&32767;vt>ke&&(ke=vt,B=Re)}}}G=B,B=f[G],Z+=G-B&
32767}if(F){w[N++]=268435456|gr[W]<<18|vn[F];var Ve=gr[W]&31,Ke=vn[F]&31;E+=Ct[Ve]+Tt[Ke],++M[257+Ve],++T[Ke],P=S+W,++k}else w[N++]=t[S],++M[t[S]]}}for(S=Math.max(
S,P);S<a;++S)w[N++]=t[S],++M[t[S]];u=wn(t,l,c,w,M,T,E,N,z,S-z,u),c||(s.r=u&7|l[u/8|0]<<3,u-=7,s.h=v,s.p=f,s.i=S,s.w=P)}else{for(var S=s.w||0;S<a+c;S+=65535){var $e=S+
65535;$e>=a&&(l[u/8|0]=c,$e=a),u=Tn(l,u+1,t.subarray(S,$e))}s.i=a}return Sr(i,0,n+xr(u)+o)},oa=(function(){for(var t=new Int32Array(256),e=0;e<256;++e){for(var r=e,
n=9;--n;)r=(r&1&&-306674912)^r>>>1;t[e]=r}return t})(),sa=function(){var t=-1;return{p:function(e){for(var r=t,n=0;n<e.length;++n)r=oa[r&255^e[n]]^r>>>8;t=r},d:function(){
return~t}}};var aa=function(t,e,r,n,o){if(!o&&(o={l:1},e.dictionary)){var s=e.dictionary.subarray(-32768),a=new O(s.length+t.length);a.set(s),a.set(t,s.length),t=a,o.w=s.length}
return na(t,e.level==null?6:e.level,e.mem==null?o.l?Math.ceil(Math.max(8,Math.min(13,Math.log(t.length)))*1.5):20:12+e.mem,r,n,o)},Rn=function(t,e){var r={};for(var n in t)
r[n]=t[n];for(var n in e)r[n]=e[n];return r};var D=function(t,e,r){for(;r;++e)t[e]=r,r>>>=8};var ia=function(t,e){return((t[0]&15)!=8||t[0]>>4>7||(t[0]<<8|t[1])%31)&&H(6,"invalid zlib data"),(t[1]>>5&1)==+!e&&H(6,"invalid zlib data: "+(t[1]&32?"need":"u\
nexpected")+" dictionary"),(t[1]>>3&4)+2};function la(t,e){return aa(t,e||{},0,0)}function $n(t,e){return ta(t.subarray(ia(t,e&&e.dictionary),-4),{i:2},e&&e.out,e&&e.dictionary)}var _n=function(t,e,r,n){for(var o in t){var s=t[o],a=e+o,i=n;Array.isArray(s)&&(i=Rn(n,s[1]),s=s[0]),s instanceof O?r[a]=[s,i]:(r[a+="/"]=[new O(0),i],_n(s,a,r,
n))}},xn=typeof TextEncoder<"u"&&new TextEncoder,ca=typeof TextDecoder<"u"&&new TextDecoder,ua=0;try{ca.decode(kn,{stream:!0}),ua=1}catch{}function Et(t,e){if(e){for(var r=new O(t.length),n=0;n<t.length;++n)r[n]=t.charCodeAt(n);return r}if(xn)return xn.encode(t);for(var o=t.length,s=new O(t.length+
(t.length>>1)),a=0,i=function(u){s[a++]=u},n=0;n<o;++n){if(a+5>s.length){var l=new O(a+8+(o-n<<1));l.set(s),s=l}var c=t.charCodeAt(n);c<128||e?i(c):c<2048?(i(192|
c>>6),i(128|c&63)):c>55295&&c<57344?(c=65536+(c&1047552)|t.charCodeAt(++n)&1023,i(240|c>>18),i(128|c>>12&63),i(128|c>>6&63),i(128|c&63)):(i(224|c>>12),i(128|c>>
6&63),i(128|c&63))}return Sr(s,0,a)}var br=function(t){var e=0;if(t)for(var r in t){var n=t[r].length;n>65535&&H(9),e+=n+4}return e},Sn=function(t,e,r,n,o,s,a,i){var l=n.length,c=r.extra,u=i&&i.length,
p=br(c);D(t,e,a!=null?33639248:67324752),e+=4,a!=null&&(t[e++]=20,t[e++]=r.os),t[e]=20,e+=2,t[e++]=r.flag<<1|(s<0&&8),t[e++]=o&&8,t[e++]=r.compression&255,t[e++]=
r.compression>>8;var m=new Date(r.mtime==null?Date.now():r.mtime),h=m.getFullYear()-1980;if((h<0||h>119)&&H(10),D(t,e,h<<25|m.getMonth()+1<<21|m.getDate()<<16|m.
getHours()<<11|m.getMinutes()<<5|m.getSeconds()>>1),e+=4,s!=-1&&(D(t,e,r.crc),D(t,e+4,s<0?-s-2:s),D(t,e+8,r.size)),D(t,e+12,l),D(t,e+14,p),e+=16,a!=null&&(D(t,e,
u),D(t,e+6,r.attrs),D(t,e+10,a),e+=14),t.set(n,e),e+=l,p)for(var g in c){var f=c[g],v=f.length;D(t,e,+g),D(t,e+2,v),t.set(f,e+4),e+=4+v}return u&&(t.set(i,e),e+=
u),e},da=function(t,e,r,n,o){D(t,e,101010256),D(t,e+8,r),D(t,e+10,r),D(t,e+12,n),D(t,e+16,o)};function On(t,e){e||(e={});var r={},n=[];_n(t,"",r,e);var o=0,s=0;for(var a in r){var i=r[a],l=i[0],c=i[1],u=c.level==0?0:8,p=Et(a),m=p.length,h=c.comment,g=h&&
Et(h),f=g&&g.length,v=br(c.extra);m>65535&&H(11);var x=u?la(l,c):l,A=x.length,y=sa();y.p(l),n.push(Rn(c,{size:l.length,crc:y.d(),c:x,f:p,m:g,u:m!=a.length||g&&h.
length!=f,o,compression:u})),o+=30+m+v+A,s+=76+2*(m+v)+(f||0)+A}for(var w=new O(s+22),M=o,T=s-o,k=0;k<n.length;++k){var p=n[k];Sn(w,p.o,p,p.f,p.u,p.c.length);var E=30+
p.f.length+br(p.extra);w.set(p.c,p.o+E),Sn(w,o,p,p.f,p.u,p.c.length,p.o,p.m),o+=16+E+(p.m?p.m.length:0)}return da(w,o,n.length,T,M),w}var Ie=["pursuer","evader"];function Ln(){return JSON.parse(kt("data"))}function nt(t,e,r){let[n,o]=[e-t.payoff.first[0],r-t.payoff.first[1]],s=t.payoff.capture_rate[n]?.[o];
return s===void 0?null:{rate:s,rates:t.payoff.capture_rates[n][o],lengths:t.payoff.lengths[n][o]}}function Ae(t,e,r){let{script:n,network:o,kept:s,genomes:a}=t.
teams[e];if(n!==null||o===null)return"";if(!s.includes(r))return`The page holds no genome of ${e}s ${r}: it would be too large. Choose a generation of ${s.join(
", ")}.`;let i=s.length*o.genome_size;return In(a,o.genome_size).length===i?"":`The page is damaged: it does not hold the ${i} numbers of the ${e}s' genomes. Wr\
ite it again from its run.`}function J(t,e,r){let{script:n,network:o,kept:s,genomes:a}=t.teams[e];if(n!==null||o===null)return n??"random";let i=s.indexOf(r);if(i<
0)throw new RangeError(`${e}: expected a generation whose genome the page holds, got ${r}`);let l=o.genome_size,c=In(a,l).subarray(i*l,(i+1)*l);return{hidden:o.
hidden,activation:o.activation,sampled:o.sampled,genome:c}}var Ar=4,Pn=new Map;function In(t,e){let r=Pn.get(t);if(r)return r;let n=new Float32Array;try{let o=ma(
Mr(t),e);o.every(Number.isFinite)&&(n=o)}catch(o){if(!(o instanceof DOMException||o instanceof RangeError||pa(o)))throw o}return Pn.set(t,n),n}var pa=t=>t instanceof
Error&&"code"in t;function ma(t,e){let r=$n(t),n=r.length/Ar,o=new Uint8Array(r.length);for(let a=0;a<o.length;a++)o[a]=r[a%Ar*n+Math.floor(a/Ar)];let s=new Uint32Array(
o.buffer);for(let a=e;a<s.length;a++)s[a]^=s[a-e];return new Float32Array(o.buffer)}function Mr(t){let e=atob(kt(t)),r=new Uint8Array(e.length);for(let n=0;n<r.
length;n++)r[n]=e.charCodeAt(n);return r}function kt(t){return document.getElementById(t)?.textContent??""}var ha={now:()=>performance.now(),request:t=>requestAnimationFrame(t),cancel:t=>cancelAnimationFrame(t)},ot=[.5,1,2,4,8,16,32,64],Ne=0,Er=12,fa=2,me=class extends EventTarget{#e;#n;#o;#a;#r=0;#t=0;#i=!1;#u=null;#d=0;#l=[];glide=.28;constructor(e,r={}){
super(),this.#e=e,this.#n=r.speed??4,this.#a=r.still??!1,this.#o=r.clock??ha}get step(){return this.#r}get time(){return this.#a?this.#r:this.#t}get arrived(){return this.#t===
this.#r}get playing(){return this.#i}get length(){return this.#e}set length(e){this.#e=e,this.#r>e&&this.jump(e),this.#p("state")}get marks(){return this.#l}set marks(e){
this.#l=e,this.#p("state")}get pace(){return this.#n||Math.max(fa,this.#e/Er)}get speed(){return this.#n}set speed(e){this.#n=e,this.#p("state")}changeSpeed(e){
let r=ot.findIndex(n=>n>=this.pace);this.speed=ot[Math.min(ot.length-1,Math.max(0,r+e))]}play(){this.#i||!this.#e||(this.#r===this.#e&&this.jump(0),this.#i=!0,this.#p(
"state"),this.#s())}pause(){this.#i&&(this.#i=!1,this.#p("state"))}toggle(){this.#i?this.pause():this.play()}move(e){this.pause();let r=Math.min(this.#e,Math.max(
0,this.#r+e));Math.abs(r-this.#t)>1?this.jump(r):this.#c(r),this.#s()}jump(e){this.#t=Math.min(this.#e,Math.max(0,Math.round(e))),this.#c(this.#t),this.#p("fram\
e")}#c(e){e!==this.#r&&(this.#r=e,this.#p("step"),this.#a&&this.#p("frame"))}#s(){this.#u===null&&(this.#d=this.#o.now(),this.#u=this.#o.request(()=>this.#h()))}#h(){
this.#u=null;let e=this.#o.now();this.#f(Math.min(.25,(e-this.#d)/1e3)),this.#d=e,(!this.#a||this.arrived)&&this.#p("frame"),(this.#i||this.#t!==this.#r)&&(this.#u=
this.#o.request(()=>this.#h()))}#f(e){let r=e;for(;r>0;){if(this.#t===this.#r){if(!this.#i)return;if(this.#r===this.#e)return this.pause();this.#c(this.#r+1)}let n=this.#i?
this.pace:1/this.glide,o=this.#r-this.#t,s=Math.min(Math.abs(o),r*n);r-=s/n,this.#t=s===Math.abs(o)?this.#r:this.#t+Math.sign(o)*s}this.#i&&this.#t===this.#e&&this.
pause()}#p(e){this.dispatchEvent(new Event(e))}};function ve(t,e){if(e.ctrlKey||e.metaKey||e.altKey)return!1;let r=e.shiftKey?10:1,o={" ":()=>t.toggle(),ArrowRight:()=>t.
move(r),ArrowLeft:()=>t.move(-r),Home:()=>t.move(-t.length),End:()=>t.move(t.length),"+":()=>t.changeSpeed(1),"-":()=>t.changeSpeed(-1)}[e.key];return o?.(),o!==
void 0}var st=[[68,1,84],[72,26,108],[71,47,125],[65,68,135],[57,86,140],[49,104,142],[42,120,142],[35,136,142],[31,152,139],[34,168,132],[53,183,121],[84,197,104],[122,
209,81],[165,219,54],[210,226,27],[253,231,37]];function Ue(t){let e=Math.min(1,Math.max(0,t))*(st.length-1),r=Math.min(st.length-2,Math.floor(e)),[n,o]=[st[r],
st[r+1]],s=a=>Math.round(n[a]+(e-r)*(o[a]-n[a]));return[s(0),s(1),s(2)]}function Nn(t){let[e,r,n]=Ue(t).map(o=>((o/255+.055)/1.055)**2.4);return .2126*e+.7152*r+
.0722*n>.179?"#000":"#fff"}var Un=t=>`rgb(${Ue(t).join(" ")})`,Fn=()=>`linear-gradient(to right, ${st.map(t=>`rgb(${t.join(" ")})`).join(", ")})`;function Rt(t,e,r){let n=devicePixelRatio||1;t.style.left=`${r.left}px`,t.style.top=`${r.top}px`,t.style.width=`${r.width}px`,t.style.height=`${r.height}px`,t.width=
Math.round(r.width*n),t.height=Math.round(r.height*n);let o=t.getContext("2d"),s=ga(e);!o||!s||(o.imageSmoothingEnabled=!1,o.drawImage(s,0,0,t.width,t.height))}
function ga(t){let[e,r]=t.shape,n=document.createElement("canvas");[n.width,n.height]=[r,e];let o=n.getContext("2d");if(!o)return null;let s=o.createImageData(r,
e);return t.capture_rate.forEach((a,i)=>a.forEach((l,c)=>{let u=4*((e-1-i-t.first[0])*r+c+t.first[1]);s.data.set([...Ue(l),255],u)})),o.putImageData(s,0,0),n}var ya=84;function Dn(t,e){let r=t.map((s,a)=>va(s,a,e)),n=d("nav",{class:"races","aria-label":"Runs"},...r.map(s=>s.button)),o=()=>r.forEach((s,a)=>s.update(a===
e.selected.run));return e.on("match",o),e.on("hover",o),o(),n.hidden=t.length<2,n}function va(t,e,r){let[n,o]=t.payoff.shape,s=!t.name.startsWith(t.schedule),a=ya/
Math.max(n,o),i=d("canvas",{"aria-hidden":"true"});Rt(i,t.payoff,{left:0,top:0,width:o*a,height:n*a});let l=d("span",{class:"place"}),c=d("button",{type:"button",
class:"race",title:`${t.name} (key ${e+1})`,onclick:()=>Cr(t,e,r)},d("span",{class:"small-matrix"},i,l),d("span",{class:"race-text"},d("strong",{},s?t.name:t.schedule),
d("span",{class:"small"},t.findings?t.findings.headline:`${t.learning.join(" and ")}s against ${ba(t)}`),d("span",{class:"small muted"},`${s?`${t.schedule}, `:""}\
seed ${t.seed}`)));return{button:c,update:p=>{c.setAttribute("aria-current",String(p));let m=r.hover.pursuer??r.selected.pursuer,h=r.hover.evader??r.selected.evader;
l.hidden=m>=n||h>=o,l.style.left=`${(h+.5)*a}px`,l.style.top=`${(n-m-.5)*a}px`}}}var ba=t=>t.teams.pursuer.script??t.teams.evader.script??"another run";function Cr(t,e,r){
let[n,o]=t.payoff.shape,{pursuer:s,evader:a}=r.selected;r.select({run:e,pursuer:Math.min(s,n-1),evader:Math.min(a,o-1)})}var wa=[[["Space"],"play or pause"],[["←","→"],"step back or forward; with Shift ten steps"],[["Home","End"],"first or last step"],[["+","−"],"faster or s\
lower"],[["N"],"next episode of the same pair; with Shift the one before"],[["R"],"another seed, not one of the evaluation"],[["O"],"the cell's own seed again"],
[["P"],"next pursuer generation; with Shift the one before"],[["E"],"next evader generation; with Shift the one before"],[["M"],"to the matrix: arrow keys choos\
e a match, Enter plays it"],[["A"],"next agent: what it sees; with Shift the one before"],[["Esc"],"no agent"],[["T"],"take over the chosen agent, or an evader,\
 from this step on"],[["G"],"this step in the playground: any other rules, actions and places"],[["1","9"],"first to ninth run"],[["D"],"light or dark"],[["?"],
"this list"]];function zn(){let t=wa.map(([r,n])=>d("div",{class:"key-row"},d("dt",{},...r.map(o=>d("kbd",{},o))),d("dd",{},n))),e=d("dialog",{class:"help","ari\
a-labelledby":"help-title"},d("h2",{id:"help-title"},"Keys"),d("dl",{class:"keys"},...t),d("p",{class:"muted small"},"The page holds the genomes and the engine \
of this run. A click on a cell plays that very match: same seed, same moves. The page loads nothing from elsewhere; share the file as it is."),d("button",{type:"\
button",onclick:()=>e.close()},"Close"));return e.addEventListener("click",r=>r.target===e&&e.close()),e}function Bn(t,e,r,n,o,s){let a=(l,c)=>()=>{let u=t[e.selected.
run].payoff.shape[l==="pursuer"?0:1];e.select({[l]:Math.min(u-1,Math.max(0,e.selected[l]+c))})},i={n:()=>e.select({episode:e.selected.episode+1}),N:()=>e.select(
{episode:Math.max(0,e.selected.episode-1)}),r:()=>e.select({seed:String(crypto.getRandomValues(new BigUint64Array(1))[0]),episode:0}),o:()=>e.select({seed:null,
episode:0}),p:a("pursuer",1),P:a("pursuer",-1),e:a("evader",1),E:a("evader",-1),m:()=>document.getElementById("matrix")?.focus(),a:()=>r.inspector.next(1),A:()=>r.
inspector.next(-1),Escape:()=>r.inspector.choose(null),t:o,g:s,d:dr,"?":()=>n.showModal()};document.addEventListener("keydown",l=>{let c=l.target instanceof HTMLSelectElement||
l.target instanceof HTMLInputElement,u=l.target instanceof HTMLButtonElement&&(l.key===" "||l.key==="Enter");if(document.querySelector("dialog[open]")||c||u||l.
defaultPrevented||l.ctrlKey||l.metaKey||l.altKey)return;let p=i[l.key]??i[l.key.toLowerCase()],m=Number(l.key)-1;if(ve(r.player,l)||p)p?.();else if(t[m])Cr(t[m],
m,e);else return;l.preventDefault()})}var Fe=[[0,0],[-1,0],[0,1],[1,0],[0,-1],[-1,1],[1,1],[1,-1],[-1,-1]];function Wn(t,e,r){let[n,o]=[e[0]-t[0],e[1]-t[1]];return!r&&Math.abs(n)>Math.abs(o)?o=0:r||
(n=0),Fe.findIndex(([s,a])=>s===Math.sign(n)&&a===Math.sign(o))}var Me=(t,e)=>e<t.nPursuers,R=(t,e)=>[t.positions[2*e],t.positions[2*e+1]],xa=(t,e)=>t[0]===e[0]&&
t[1]===e[1],Tr=({rows:t,cols:e},[r,n])=>r>=0&&n>=0&&r<t&&n<e,kr=(t,e,r=3)=>t!==void 0&&[0,1,2].slice(0,r).some(n=>t[3*e+n]),Rr=(t,e)=>kr(t.fault,e),Hn=(t,e)=>!Rr(
t,e)&&kr(t.involved,e,2);function $t(t,e,r){let n=!xa(R(t,r),R(e,r)),o=e.involved===void 0||kr(e.involved,r);return!!(e.alive[r]&&e.actions?.[r]&&!n&&o)}function _t(t,e,r){
let[n,o]=R(t,r),[s,a]=Fe[e.actions?.[r]??0];return[n+s,o+a]}function at(t,e,r){return Array.from({length:r.everCaptured.length},(o,s)=>s).filter(o=>r.everCaptured[o]&&
!e.everCaptured[o]).map(o=>t.nPursuers+o)}var jn=t=>t.moments.flatMap((e,r)=>r&&at(t,t.moments[r-1],e).length?[r]:[]);function Ot(t,e){return Array.from({length:e.
alive.length},(n,o)=>o).filter(n=>t.alive[n]&&!e.alive[n])}var Gn=[-.31,0,.31],Vn=[{size:1,at:[[0,0]]},{size:.62,at:[[-.2,.2],[.2,-.2]]},{size:.54,at:[[-.23,.22],[.23,.22],[0,-.22]]},{size:.54,at:[[-.23,.23],[.23,.23],[
-.23,-.23],[.23,-.23]]},{size:.36,at:Gn.flatMap(t=>Gn.map(e=>[e,t]))}],Sa=.3,Aa=.35,Ma=.55;function it(t,e){let r=new Map;for(let n=0;n<e.alive.length;n++){if(!e.
alive[n])continue;let[o,s]=R(e,n),a=o*t.cols+s,i=r.get(a);i?i.push(n):r.set(a,[n])}return r}function Kn(t,e){let r=Array.from(e.alive,(n,o)=>{let[s,a]=R(e,o);return{
x:a+.5,y:s+.5,size:1,alpha:0}});for(let n of it(t,e).values()){let o=Vn[Math.min(n.length,Vn.length)-1];n.forEach((s,a)=>{let[i,l]=o.at[Math.min(a,o.at.length-1)],
c=r[s];c.x+=i,c.y+=l,c.size=o.size,c.alpha=1})}return r}var Yn=t=>t*t*(3-2*t),De=(t,e,r)=>t+(e-t)*r,qn=t=>Math.min(1,Math.max(0,t));function Zn(t,e,r,n){let o={
1:2,2:r}[t.interaction]??1;if(o===1)return Yn(n);let s=o===r?e:+!Me(t,e),a=Math.max(1/o,Aa);return Yn(qn((n-s/(o-1)*(1-a))/a))}function Pt(t,e){let r=t.moments.
length-1,n=Math.min(Math.floor(e),r),o=t.moments[n],s=Kn(t,o);if(n===r||e===n)return s;let a=t.moments[n+1],i=Kn(t,a);return s.map((l,c)=>{let u=Zn(t,c,s.length,
e-n);return Ea(o,a,c,l,i[c],u)})}function Or(t,e,r){let n=t.moments.length-1,o=Math.min(Math.floor(r),n),[s,a]=[t.moments[o],t.moments[Math.min(o+1,n)]],i=Zn(t,
e,s.alive.length,r-o),[[l,c],[u,p]]=[R(s,e),R(a,e)];return[De(c,p,i)+.5,De(l,u,i)+.5]}function Ea(t,e,r,n,o,s){let a=n.alpha>o.alpha,i={x:De(n.x,o.x,s),y:De(n.y,
o.y,s),size:a?n.size:De(n.size,o.size,s),alpha:a?qn((1-s)/(1-Ma)):De(n.alpha,o.alpha,s)};if($t(t,e,r)){let[l,c]=R(t,r),[u,p]=_t(t,e,r),m=Sa*Math.sin(Math.PI*s);
i.x+=(p-c)*m,i.y+=(u-l)*m}return i}var Jn=2*Math.PI;function Ee(t,e,r,n){t.beginPath(),t.arc(e,r,n/2,0,Jn)}function Lt(t,e,r,n){let o=n/2,s=[[0,-.97],[.97,.83],[-.97,.83]].map(([a,i])=>[e+a*o,r+i*
o]);t.beginPath(),t.moveTo((s[2][0]+s[0][0])/2,(s[2][1]+s[0][1])/2),s.forEach(([a,i],l)=>{let[c,u]=s[(l+1)%3];t.arcTo(a,i,c,u,n*.09)}),t.closePath()}function Xn(t,e,r,n){
let o=n*.32;t.beginPath(),t.moveTo(e-o,r-o),t.lineTo(e+o,r+o),t.moveTo(e+o,r-o),t.lineTo(e-o,r+o)}function Qn(t,e,r,n){t.beginPath();for(let o=0;o<16;o++){let s=n/
2*(o%2?.6:.95),a=Jn*o/16;t.lineTo(e+s*Math.sin(a),r-s*Math.cos(a))}t.closePath()}function eo(t,e,r,n,o,s){let a=Math.atan2(o-r,n-e);t.beginPath(),t.moveTo(e,r),
t.lineTo(n,o);for(let i of[-1,1])t.moveTo(n,o),t.lineTo(n-s*Math.cos(a+i*.6),o-s*Math.sin(a+i*.6))}var to=4,Ca=1.6,Ta=.95,ka=5,Ra=.16,$a=9,_a=.09,Oa=.2,ro=.75,X=(t,e)=>t.left+e*t.cell,Q=(t,e)=>t.top+e*t.cell;function ze(t,e,r){return Me(e,r)?t.colors.pursuer:
t.colors.evader}function no({ctx:t,grid:e,colors:r}){let{left:n,top:o,cell:s,rows:a,cols:i}=e,[l,c]=[i*s,a*s];if(t.fillStyle=r.paper,t.fillRect(n,o,l,c),s<ka)return;
t.fillStyle=r.line;let u=Math.max(1,Math.round(s/60));for(let p=1;p<i;p++)t.fillRect(n+p*s,o,u,c);for(let p=1;p<a;p++)t.fillRect(n,o+p*s,l,u)}function oo({ctx:t,
grid:e,colors:r},n){let{left:o,top:s,cell:a,rows:i,cols:l}=e;t.fillStyle=r.obstacle;for(let u=0;u<i*l;u++){if(!n.obstacles[u])continue;let[p,m]=[Math.floor(u/l),
u%l];t.fillRect(o+m*a,s+p*a,a,a)}let c=Math.min(5,Math.max(2,Math.round(a/18)));t.strokeStyle=r.frame,t.lineWidth=c,t.strokeRect(o-c/2,s-c/2,l*a+c,i*a+c)}function so({
ctx:t,grid:e,colors:r},n){let{left:o,top:s,cell:a,rows:i,cols:l}=e,c=a<24*n?5:1;t.font=`500 ${Math.round(Math.min(15*n,Math.max(9*n,a*.32)))}px system-ui, sans-\
serif`,t.fillStyle=r.muted,t.textBaseline="alphabetic",t.textAlign="center";let u=5*n+a/40;for(let p=0;p<l;p+=c)t.fillText(String(p),o+(p+.5)*a,s-u);t.textAlign=
"right",t.textBaseline="middle";for(let p=0;p<i;p+=c)t.fillText(String(p),o-u,s+(p+.5)*a)}function ao({grid:t},e,r,n){let o=Math.floor(e.fov/2)+.5,[s,a]=[Math.max(
0,r-o),Math.min(t.cols,r+o)],[i,l]=[Math.max(0,n-o),Math.min(t.rows,n+o)];return[X(t,s),Q(t,i),(a-s)*t.cell,(l-i)*t.cell]}function io(t,e,r,n){let{ctx:o,grid:s,
colors:a}=t;o.beginPath(),o.rect(0,0,o.canvas.width,o.canvas.height),o.rect(...ao(t,e,r,n)),o.save(),o.clip("evenodd"),o.fillStyle=a.line,o.fillRect(s.left,s.top,
s.cols*s.cell,s.rows*s.cell),o.restore()}function lo({ctx:t,grid:e,colors:r},{x:n,y:o,alpha:s},a){let i=Math.max(e.cell,16*a)*1.06,[l,c]=[X(e,n),Q(e,o)];t.globalAlpha=
Math.max(s,.6),t.beginPath(),t.roundRect(l-i/2,c-i/2,i,i,i*.2),t.strokeStyle=r.focus,t.lineWidth=Math.max(2,2.5*a),t.stroke();let u=Math.max(11*a,Math.min(18*a,
e.cell*.5));t.font=`700 ${Math.round(u)}px system-ui, sans-serif`,t.textAlign="center",t.textBaseline="middle";let p=c-i/2<u*1.2,m=c+(p?1:-1)*(i/2+u*.7);t.strokeStyle=
r.paper,t.lineJoin="round",t.lineWidth=u*.35,t.strokeText("You",l,m),t.fillStyle=r.ink,t.fillText("You",l,m),t.globalAlpha=1}function co(t,e,r,n,o){let{ctx:s,grid:a}=t,
i=ao(t,e,n,o),l=ze(t,e,r);s.globalAlpha=.11,s.fillStyle=l,s.fillRect(...i),s.globalAlpha=.8,s.strokeStyle=l,s.lineWidth=Math.max(1,a.cell/24),s.strokeRect(...i),
s.globalAlpha=1}function uo(t,e,r,n,o){let{ctx:s,grid:a}=t,i=Math.min(Math.ceil(r),e.moments.length-1),l=e.moments[i];s.lineCap="round",s.lineWidth=Math.min($a,
Math.max(1,a.cell*Ra));for(let c=Math.max(1,Math.floor(r-n)+1);c<=i;c++){let[u,p]=[e.moments[c-1],e.moments[c]],m=Math.max(0,Math.min(1,(r-c)/n));s.globalAlpha=
ro+(Oa-ro)*m;for(let h=0;h<p.alive.length;h++){let g=c===i&&r<i;if(!u.alive[h]||!(l.alive[h]||g))continue;let f=(Me(e,h)?-1:1)*_a,[v,x]=R(u,h),[A,y]=R(p,h);if(v===
A&&x===y)continue;let w=g?o[h].x:y+.5,M=g?o[h].y:A+.5;s.strokeStyle=ze(t,e,h),s.beginPath(),s.moveTo(X(a,x+.5+f),Q(a,v+.5+f)),s.lineTo(X(a,w+f),Q(a,M+f)),s.stroke()}}
s.globalAlpha=1}function po(t,e,r){let n=Math.min(Math.ceil(r),e.moments.length-1);for(let o=Math.max(1,n-to+1);o<=n;o++){let[s,a]=[e.moments[o-1],e.moments[o]],
i=o>r?Math.max(0,1-2*(o-r)):1-(r-o)/to,l=at(e,s,a);for(let c of Ot(s,a))l.includes(c)||La(t,R(a,c),i);for(let c of l)Pa(t,R(a,c),i)}t.ctx.globalAlpha=1}function Pa({
ctx:t,grid:e,colors:r},[n,o],s){t.globalAlpha=s,Qn(t,X(e,o+.5),Q(e,n+.5),Math.max(8,e.cell*Ca)),t.fillStyle=r.capture,t.fill(),t.strokeStyle=r.ink,t.lineWidth=Math.
max(1,e.cell/36),t.lineJoin="round",t.stroke()}function La({ctx:t,grid:e,colors:r},[n,o],s){t.globalAlpha=s,Xn(t,X(e,o+.5),Q(e,n+.5),Math.max(7,e.cell*Ta)),t.strokeStyle=
r.collision,t.lineWidth=Math.max(2,e.cell*.17),t.lineCap="round",t.stroke()}function mo({ctx:t,grid:e,colors:r},n,o){let s=Math.max(1,e.cell*.07);t.strokeStyle=
t.fillStyle=r.collision,t.lineWidth=Math.max(1,e.cell*.05),t.setLineDash([e.cell*.14,e.cell*.1]);for(let[a,i]of n){if(a<0||i<0||a>=e.rows||i>=e.cols)continue;let l=[
X(e,i)+s,Q(e,a)+s,e.cell-2*s,e.cell-2*s];t.globalAlpha=.2*o,t.fillRect(...l),t.globalAlpha=o,t.strokeRect(...l)}t.setLineDash([]),t.globalAlpha=1}function ho({ctx:t,
grid:e,colors:r},n,o,s,a){t.globalAlpha=a,Ee(t,X(e,n),Q(e,o),Math.max(8,e.cell*s*1.02)),t.strokeStyle=r.collision,t.lineWidth=Math.max(1.5,e.cell*.085*Math.sqrt(
s)),t.stroke(),t.globalAlpha=1}var Ia=.8,Na=.92,Ua=15,Fa=7,Pr=9;function fo(t,e,r,n,o,s){n.forEach((a,i)=>{a.alpha>0&&Da(t,e,r,i,a,o,s)}),t.ctx.globalAlpha=1;for(let a of it(e,r).values())a.length>
Pr&&za(t,n[a[Pr-1]],a.length-Pr+1)}function Da(t,e,r,n,o,s,a){let{ctx:i,grid:l,colors:c}=t,u=Me(e,n),[p,m]=[l.left+o.x*l.cell,l.top+o.y*l.cell],h=Math.max(4,l.cell*
o.size*(u?Na:Ia)),g=ze(t,e,n),f=!u&&!!r.captured[n-e.nPursuers];if(i.globalAlpha=o.alpha,(u?Lt:Ee)(i,p,m,h),h>Fa*a&&(i.strokeStyle=c.paper,i.lineWidth=Math.max(
2,h*.1),i.stroke()),i.fillStyle=f?c.paper:g,i.fill(),f&&(Ee(i,p,m,h*.82),i.strokeStyle=g,i.lineWidth=h*.18,i.stroke()),!s||h<Ua*a)return;let v=String(u?n:n-e.nPursuers);
i.font=`700 ${Math.round(h*(u?.4:.5)*(v.length>1?.8:1))}px system-ui, sans-serif`,i.textAlign="center",i.textBaseline="middle",i.fillStyle=f?g:c.paper,i.fillText(
v,p,m+h*(u?.17:.03))}function za({ctx:t,grid:e,colors:r},n,o){let[s,a]=[e.left+n.x*e.cell,e.top+n.y*e.cell];t.font=`700 ${Math.round(e.cell*.3)}px system-ui, sa\
ns-serif`,t.textAlign="center",t.textBaseline="middle",t.strokeStyle=r.paper,t.lineWidth=e.cell*.1,t.strokeText(`+${o}`,s,a),t.fillStyle=r.ink,t.fillText(`+${o}`,
s,a)}var Ba=.46,Wa=.86,Ha=.66,go=.48,ja=.78,Ga=.58;function yo(t,e,r,n){let[o,s]=[e.moments[r-1],e.moments[r]];if(!o)return;let{ctx:a,grid:i,colors:l}=t;a.strokeStyle=
l.collision,a.lineWidth=Math.max(1.5,i.cell*.07),a.lineCap="butt",a.globalAlpha=n;for(let c=0;c<s.alive.length;c++)$t(o,s,c)&&Va(t,e,R(o,c),_t(o,s,c));a.globalAlpha=
1}function Va({ctx:t,grid:e},r,n,o){let[s,a]=[o[1]-n[1],o[0]-n[0]],i=p=>X(e,n[1]+.5+s*p),l=p=>Q(e,n[0]+.5+a*p),c=Tr(r,o)?ja:Ga;t.setLineDash([e.cell*.09,e.cell*
.06]),t.beginPath(),t.moveTo(i(go),l(go)),t.lineTo(i(c),l(c)),t.stroke(),t.setLineDash([]);let u=.17*e.cell/Math.hypot(s,a);t.beginPath(),t.moveTo(i(c)-a*u,l(c)+
s*u),t.lineTo(i(c)+a*u,l(c)-s*u),t.stroke()}function vo(t,e,r,n,o,s){let a=Fe[s];if(!s||!a)return;let{ctx:i,grid:l,colors:c}=t,u=Tr(e,[n[0]+a[0],n[1]+a[1]])?Wa:
Ha,p=Ba*o.size,m=[X(l,o.x+a[1]*p),Q(l,o.y+a[0]*p),X(l,o.x+a[1]*u),Q(l,o.y+a[0]*u)],h=Math.max(1.5,l.cell*.085);i.lineCap=i.lineJoin="round";for(let[g,f]of[[c.paper,
h*2.1],[ze(t,e,r),h]])i.strokeStyle=g,i.lineWidth=f,eo(i,...m,l.cell*.2),i.stroke()}var wo={numbers:!0,axes:!1,trail:6,viewers:[],plan:null,selected:null,cursor:null,you:null,fog:!1};function xo(t,e,r,n,o){let{ctx:s,grid:a,colors:i}=t,l=Math.min(
Math.ceil(r),e.moments.length-1),c=e.moments[l],u=r===l,p=Pt(e,r),m=u?1:Math.max(0,1-2*(l-r));s.clearRect(0,0,s.canvas.width,s.canvas.height),no(t);for(let f of n.
viewers)p[f]?.alpha&&co(t,e,f,...Or(e,f,r));oo(t,e),n.axes&&so(t,o),uo(t,e,r,n.trail,p),mo(t,c.contested??[],m),po(t,e,r),yo(t,e,l,m),p.forEach(({x:f,y:v,size:x},A)=>{
let y=Hn(c,A)?.4:0,w=Rr(c,A)?1:y;w&&ho(t,f,v,x,w*m)});let h=u?c:e.moments[Math.max(0,l-1)];if(fo(t,e,h,p,n.numbers,o),u&&n.plan)for(let[f,v]of p.entries())v.alpha&&
vo(t,e,f,R(c,f),v,n.plan[f]??0);n.you!==null&&(n.fog&&io(t,e,...Or(e,n.you,r)),lo(t,p[n.you],o)),s.lineWidth=Math.max(2,2.5*o),s.strokeStyle=i.focus;let g=n.selected===
null?void 0:p[n.selected];g?.alpha&&bo(t,g.x,g.y,g.size*.96),n.cursor&&(s.setLineDash([a.cell*.12,a.cell*.08]),bo(t,n.cursor[1]+.5,n.cursor[0]+.5,.8),s.setLineDash(
[]))}function bo({ctx:t,grid:e},r,n,o){let s=o*e.cell;t.beginPath(),t.roundRect(e.left+r*e.cell-s/2,e.top+n*e.cell-s/2,s,s,s*.1),t.stroke()}var So=(t,e)=>(e+.24)/(t+.24);function Ao(t,e,r,n,o,s){let a=r?28*s:0,i=(c,u)=>(c-a)/(u+2*.12),l=Math.max(1,Math.floor(Math.min(i(n,e),i(o,t))));return{rows:t,cols:e,
cell:l,left:Math.round((n-e*l+a)/2),top:Math.round((o-t*l+a)/2)}}function Mo(t,e,r){let n=Math.floor((r-t.top)/t.cell),o=Math.floor((e-t.left)/t.cell);return n>=
0&&n<t.rows&&o>=0&&o<t.cols?[n,o]:null}var Ka={paper:"--board-paper",line:"--board-line",frame:"--board-frame",ink:"--board-ink",muted:"--board-muted",obstacle:"--board-obstacle",pursuer:"--pursuer",
evader:"--evader",capture:"--capture",collision:"--collision",focus:"--focus"};function It(t){let e=getComputedStyle(t),r=Object.entries(Ka).map(([n,o])=>[n,e.getPropertyValue(
o).trim()]);return Object.fromEntries(r)}var ae=()=>matchMedia("(prefers-reduced-motion: reduce)").matches,be=class{canvas;#e=null;#n=0;#o;#a={rows:1,cols:1,left:0,top:0,cell:1};#r=0;#t;#i;constructor(e,r={}){
this.canvas=e,e.classList.add("board"),e.setAttribute("role","img"),this.#o={...wo,...r},this.#t=new ResizeObserver(()=>this.#d()),this.#t.observe(e),this.#i=new MutationObserver(
()=>this.redraw()),this.#i.observe(document.documentElement,{attributes:!0}),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",this.redraw)}close(){
this.#t.disconnect(),this.#i.disconnect(),matchMedia("(prefers-color-scheme: dark)").removeEventListener("change",this.redraw),cancelAnimationFrame(this.#r)}get look(){
return this.#o}set look(e){this.#o={...this.#o,...e},this.#u(),this.redraw()}get time(){return this.#n}show(e,r){this.#e=e,this.#n=Math.min(Math.max(0,r),e.moments.
length-1),this.#u(),this.redraw()}redraw=()=>{this.#r||(this.#r=requestAnimationFrame(()=>this.drawNow()))};drawNow(){cancelAnimationFrame(this.#r),this.#r=0;let e=this.
canvas.getContext("2d");if(!e||!this.#e)return;let{rows:r,cols:n}=this.#e,o=devicePixelRatio||1;this.#a=Ao(r,n,this.#o.axes,this.canvas.width,this.canvas.height,
o);let s={ctx:e,grid:this.#a,colors:It(this.canvas)};xo(s,this.#e,this.#n,this.#o,o)}cellAt(e,r){let n=this.canvas.getBoundingClientRect(),o=this.canvas.width/n.
width;return Mo(this.#a,(e-n.left)*o,(r-n.top)*o)}agentAt(e,r){let n=this.cellAt(e,r);if(!n||!this.#e)return null;let o=this.#e.moments[Math.round(this.#n)],s=it(
this.#e,o).get(n[0]*this.#e.cols+n[1])??[],a=Pt(this.#e,Math.round(this.#n)),i=l=>{let[c,u]=this.pointOf(a[l].x,a[l].y);return Math.hypot(c-e,u-r)};return s.length?
s.reduce((l,c)=>i(c)<i(l)?c:l):null}pointOf(e,r){let n=this.canvas.getBoundingClientRect(),o=n.width/this.canvas.width,{left:s,top:a,cell:i}=this.#a;return[n.left+
(s+e*i)*o,n.top+(a+r*i)*o]}#u(){if(!this.#e)return;let{rows:e,cols:r}=this.#e;this.canvas.style.setProperty("--board-aspect",String(So(e,r)))}#d(){let e=devicePixelRatio||
1,{width:r,height:n}=this.canvas.getBoundingClientRect();this.canvas.width=Math.max(1,Math.round(r*e)),this.canvas.height=Math.max(1,Math.round(n*e)),this.drawNow()}};var qa={SIMULTANEOUS:0,SWARM_TURNS:1,AGENT_TURNS:2};function Nt(t,e,r){return{rows:t.rows,cols:t.cols,nPursuers:t.n_pursuers,fov:t.fov,interaction:qa[t.rules.interaction],
obstacles:e,moments:r}}function Ut(t,e){return{positions:t.read("last_positions"),alive:t.read("alive"),captured:t.read("captured"),everCaptured:t.read("ever_ca\
ptured"),actions:e,involved:t.read("involved"),fault:t.read("fault"),contested:t.conflicts().map(r=>r.cell)}}function Ft(t){let e=Array.from({length:t.length+1},
(r,n)=>Za(t,n));return Nt(t.config,t.map,e)}function Za(t,e){let r=t.n_agents,n=t.config.n_evaders,o=(a,i,l)=>a.subarray(i*l,(i+1)*l),s={positions:o(t.last_positions,
e,2*r),alive:o(t.alive,e,r),captured:o(t.captured,e,n),everCaptured:o(t.ever_captured,e,n)};return e===0?s:{...s,actions:o(t.actions,e-1,r),involved:o(t.involved,
e-1,3*r),fault:o(t.fault,e-1,3*r),get contested(){return t.conflicts(e).map(a=>a.cell)}}}var Ja=Array.from({length:16},(t,e)=>{let[r,n]=[e%2?6.5:11,Math.PI*e/8];return`${12+r*Math.sin(n)} ${12-r*Math.cos(n)}`}).join(" ");function Eo(){let t=[["pursu\
er",b("path",{d:"M12 3 22 20H2z",class:"filled-pursuer"})],["evader",b("circle",{cx:12,cy:12,r:9,class:"filled-evader"})],["capture",b("polygon",{points:Ja,class:"\
filled-capture"})],["captured evader",b("circle",{cx:12,cy:12,r:7.5,class:"ring-evader"})],["conflict",b("rect",{x:3,y:3,width:18,height:18,class:"dashed-confli\
ct"})]];return d("ul",{class:"shapes small","aria-label":"Shapes on the board"},...t.map(([e,r])=>d("li",{},b("svg",{viewBox:"0 0 24 24","aria-hidden":"true"},r),
e)))}var Xa={first:"M6 5v14M19 5 9 12l10 7z",back:"M17 5 7 12l10 7z",play:"M7 4.5 19 12 7 19.5z",pause:"M8 5v14M16 5v14",forward:"M7 5l10 7-10 7z",last:"M18 5v14M5 5\
l10 7-10 7z"};function Co(t){let e=document.createElementNS("http://www.w3.org/2000/svg","svg");e.setAttribute("viewBox","0 0 24 24"),e.setAttribute("aria-hidde\
n","true"),e.classList.add("icon");let r=document.createElementNS("http://www.w3.org/2000/svg","path");return r.setAttribute("d",Xa[t]),e.append(r),e}function lt(t,e,r,n){
let o=document.createElement("button");return o.type="button",o.className="player-button",o.append(Co(t)),o.ariaLabel=e,o.title=`${e} (${r})`,o.addEventListener(
"click",n),o}function Be(t){let e=document.createElement("div");e.className="player",e.role="group",e.ariaLabel="Player";let r=lt("play","Play","Space",()=>t.toggle()),
n=Qa(t),o=d("div",{class:"captures","aria-hidden":"true",title:"Captures"}),s=ei(t),a=document.createElement("output");a.className="player-count",e.append(lt("f\
irst","First step","Home",()=>t.move(-t.length)),lt("back","Step back","←",()=>t.move(-1)),r,lt("forward","Step forward","→",()=>t.move(1)),lt("last","Last \
step","End",()=>t.move(t.length)),d("div",{class:"scrub"},o,n),a,s);let i=()=>o.replaceChildren(...t.marks.map(c=>{let u=d("i");return u.style.left=`${100*c/Math.
max(1,t.length)}%`,u})),l=()=>{r.replaceChildren(Co(t.playing?"pause":"play")),r.ariaLabel=t.playing?"Pause":"Play",r.title=`${r.ariaLabel} (Space)`,n.max=String(
t.length),n.value=String(t.step),n.ariaValueText=`step ${t.step} of ${t.length}`,a.textContent=`${t.step} / ${t.length}`,a.style.minWidth=`${2*String(t.length).
length+3}ch`,s.value=String(t.speed)};return t.addEventListener("step",l),t.addEventListener("state",l),t.addEventListener("state",i),e.addEventListener("keydow\
n",c=>{!(c.target instanceof HTMLSelectElement||c.key===" "&&c.target!==n)&&ve(t,c)&&c.preventDefault()}),l(),e}function Qa(t){let e=document.createElement("inp\
ut");return e.type="range",e.className="player-scrub",e.min="0",e.step="1",e.ariaLabel="Step",e.addEventListener("input",()=>{t.pause(),t.jump(Number(e.value))}),
e}function ei(t){let e=document.createElement("select");return e.className="player-speed",e.ariaLabel="Speed",e.title="Steps a second (+ and -)",e.append(new Option(
`all in ${Er} s`,String(Ne)),...ot.map(r=>new Option(`${r} / s`,String(r)))),e.addEventListener("change",()=>{t.speed=Number(e.value)}),e}var I=(t,e=2)=>t==null?"-":t.toFixed(e),Lr=(t,e=1)=>t==null?"-":`${(100*t).toFixed(e)} %`;function Dt(t,e,r,n=2){return e===null||r===null?t.toFixed(n):`${t.toFixed(
n)} (${e.toFixed(n)} to ${r.toFixed(n)})`}var To=t=>t.toLocaleString("en-GB");function ct(t,e,r,n=!1){let o=(e-t)/Math.max(1,r),s=10**Math.floor(Math.log10(o||1)),
a=[1,2,5,10].map(c=>c*s).find(c=>c>=o)??10*s;n&&(a=Math.max(1,Math.round(a)));let i=Math.ceil(t/a-1e-9),l=Math.floor(e/a+1e-9);return Array.from({length:Math.max(
0,l-i+1)},(c,u)=>(i+u)*a)}function we(t,e,{pursuer:r,evader:n,episode:o,seed:s}){let a=e.seeds[r][n];return t.match(e.world,J(e,"pursuer",r),J(e,"evader",n),BigInt(s??a),o)}var ko=40,ut=new Map,dt=({run:t,pursuer:e,evader:r},n)=>`${t} ${e} ${r} ${n}`,zt=class{element;#e;#n;#o=d("div",{class:"episodes",role:"group","aria-label":"Epi\
sodes of this cell"});#a=d("p",{class:"check small numbers","aria-live":"polite"});#r=0;constructor(e,r){[this.#e,this.#n]=[e,r],this.element=d("div",{class:"st\
rip-of-episodes"},this.#o,this.#a)}show(e,r,n){let{selected:o}=this.#e;o.seed===null&&ut.set(dt(o,o.episode),Ro(n)),this.#i(r),ri(this.#r),this.#t(e,r)}#t(e,r){
let{selected:n}=this.#e,s=nt(r,n.pursuer,n.evader)?.rates.findIndex((a,i)=>!ut.has(dt(n,i)))??-1;s<0||s>=ko||(this.#r=ti(()=>{this.#e.selected===n&&(this.#n.playing||
(ut.set(dt(n,s),Ro(we(e,r,{...n,episode:s,seed:null}))),this.#i(r)),this.#t(e,r))}))}#i(e){let{selected:r}=this.#e,n=nt(e,r.pursuer,r.evader);if(!n){this.#o.replaceChildren(),
this.#a.textContent="The evaluation played no episodes of this pair.";return}let o=Math.min(ko,n.rates.length);this.#o.replaceChildren(...n.rates.slice(0,o).map(
(c,u)=>this.#u(c,u)));let s=n.rates.slice(0,o).map((c,u)=>ut.get(dt(r,u))),a=s.filter(c=>c!==void 0),i=s.flatMap((c,u)=>c&&(Math.abs(c.rate-n.rates[u])>1e-6||c.
length!==n.lengths[u])?[u+1]:[]),l=a.reduce((c,u)=>c+u.rate,0)/a.length;this.#a.dataset.equal=String(!i.length&&a.length===n.rates.length),this.#a.textContent=i.
length?`Episode ${i.join(", ")} differs from the evaluation.`:"As in the evaluation",this.#a.title=a.length<n.rates.length?`Played here: ${a.length} of ${n.rates.
length} episodes.`:`Played here: all ${a.length} episodes, mean capture rate ${I(l,3)}. The cell says ${I(n.rate,3)}.`}#u(e,r){let{selected:n}=this.#e,o=d("span",
{class:"bar"});return o.style.height=`${Math.round(100*e)}%`,d("button",{type:"button",class:"episode",title:`Episode ${r+1}: capture rate ${I(e)}`,"aria-label":`\
Episode ${r+1}, capture rate ${I(e)}`,"aria-pressed":String(r===n.episode&&n.seed===null),"data-played":ut.has(dt(n,r)),onclick:()=>this.#e.select({episode:r,seed:null})},
o,d("span",{class:"count"},r+1))}},Ro=t=>({rate:t.statistics.capture_rate,length:t.length}),ti=t=>"requestIdleCallback"in window?requestIdleCallback(t,{timeout:1e3}):
setTimeout(t,100),ri=t=>"cancelIdleCallback"in window?cancelIdleCallback(t):clearTimeout(t);var he=(t,e)=>t<e?`pursuer_${t}`:`evader_${t-e}`,We=["stay","north","east","south","west","northeast","southeast","southwest","northwest"];var $o=0,_o=1,ni=2,oi=176;function Po(t,e,r,n){let o=devicePixelRatio||1,s=It(t);t.width=t.height=oi*o;let a=t.getContext("2d");if(!a)return;let{fov:i}=e,l=t.width/
i;a.fillStyle=s.paper,a.fillRect(0,0,t.width,t.height);for(let u=0;r&&u<i*i;u++){let[p,m]=[(u%i+.5)*l,(Math.floor(u/i)+.5)*l],h=f=>!!r[f*i*i+u];h(ni)&&(a.fillStyle=
s.obstacle,a.fillRect(p-l/2,m-l/2,l,l));let g=h($o)&&h(_o)?l*.18:0;h($o)&&Oo(a,Ee,p+g,m+g,l*.74,s.evader),h(_o)&&Oo(a,Lt,p-g,m-g,l*.86,s.pursuer)}a.strokeStyle=
n<e.n_pursuers?s.pursuer:s.evader,a.lineWidth=2*o;let c=Math.floor(i/2)*l;a.strokeRect(c,c,l,l)}function Oo(t,e,r,n,o,s){e(t,r,n,o),t.fillStyle=s,t.fill()}var Bt=class{element;#e;#n=d("canvas",{class:"seen",role:"img"});#o=d("h3");#a=d("p",{class:"small muted"});#r=d("div",{class:"answers"});#t=null;#i=null;#u=null;#d=null;#l=null;#c=0;constructor(e){
this.#e=e,this.element=d("div",{class:"inspector","data-open":"false"},d("p",{class:"hint small muted"},"Click an agent, or press A: what it sees, and what its \
network answers."),d("div",{class:"inspected"},this.#n,d("div",{class:"answer"},this.#o,this.#a),this.#r))}get agent(){return this.#l}show(e,r,n,o){(this.#i!==r||
!this.#t)&&(this.#t?.free(),this.#t=e.world(r.world),this.#l!==null&&this.#i!==r&&this.choose(null)),[this.#i,this.#u,this.#d]=[r,n,o]}choose(e){this.#l=e,this.
element.dataset.open=String(e!==null),this.#e(e),this.at(this.#c)}next(e){let r=this.#u;if(!r)return;let n=this.#l??(e>0?-1:0);for(let o=0;o<r.n_agents;o++)if(n=
(n+e+r.n_agents)%r.n_agents,r.alive[this.#c*r.n_agents+n])return this.choose(n)}at(e){this.#c=e;let[r,n,o,s,a]=[this.#u,this.#t,this.#i,this.#d,this.#l];if(!r||
!n||!o||!s||a===null)return;let i=a<r.config.n_pursuers?"pursuer":"evader";this.#o.replaceChildren(d("span",{class:i},he(a,r.config.n_pursuers)));let l=!!r.alive[e*
r.n_agents+a];r.seek(n,e),Po(this.#n,r.config,l?n.view(a):null,a),this.#n.ariaLabel=`Field of view of ${he(a,r.config.n_pursuers)}: evaders, pursuers and obstac\
les around it`;let c=e<r.length?r.actions[e*r.n_agents+a]:null;if(!l)return this.#s([],"It is gone.");let u=J(o,i,s[i]);if(typeof u=="string")return this.#s([],
`The script "${u}" plays for it${c===null?"":`; it goes ${We[c]}`}.`);let{probabilities:p}=n.answer(u,a),m=Array.from(p,(g,f)=>si(We[f],g,f===c)),h=u.sampled?"I\
ts action is drawn from these probabilities.":"It takes the most probable action.";this.#s(m,c===null?"The episode is over.":h)}#s(e,r){this.#r.replaceChildren(
...e),this.#a.textContent=r}};function si(t,e,r){let n=d("span",{class:"filled"});return n.style.width=`${100*e}%`,d("div",{class:r?"action taken":"action"},d("\
span",{},t),d("span",{class:"track"},n),d("span",{class:"numbers"},e.toFixed(2)))}function Lo(t){let e=JSON.stringify(t,(r,n)=>r==="genome"?Array.from(n):n);return d("script",{type:"application/json",id:"champions"},e.replaceAll("<","\\u003c")).
outerHTML}var Ir="champion";var ai=(t,e)=>Object.keys(t).every(r=>t[r]===e[r]);function Io(t,e){return Object.keys(e).find(r=>ai(e[r],t))??null}var pt="_",li="n",Xc=2n**64n-1n;var Nr={fov:11,maxSteps:500,rewards:"paper"},ci=["rules","others","rewards","size","diagonal","fov","limit","seed","ended","walls","pursuers","evaders","played",
"next"];function Ur(t,e){let r=i=>i.map(l=>di(l,e)).join(""),n=i=>`${Math.floor(i/t.cols)}.${i%t.cols}`,o=ui(t.rewards,e),s=[t.seed,t.episode,t.steps].join("."),a={rules:Uo(
t.rules,e),others:t.others?Uo(t.others,e):"",rewards:o===Nr.rewards?"":o,size:`${t.rows}x${t.cols}`,diagonal:t.diagonal?"1":"",fov:t.fov===Nr.fov?"":String(t.fov),
limit:t.maxSteps===Nr.maxSteps?"":String(t.maxSteps),seed:s==="0.0.0"?"":s,ended:t.ended?"1":"",walls:t.walls.map(n).join(pt),pursuers:t.pursuers.map(No).join(pt),
evaders:t.evaders.map(No).join(pt),played:t.played.map(r).join(pt),next:t.next.every(i=>i===0)?"":r(t.next)};return ci.filter(i=>a[i]).map(i=>`${i}=${a[i]}`).join(
"&")}function No({cell:t,gone:e,captured:r,everCaptured:n}){let o=r?"c":n?"e":"";return`${t[0]}.${t[1]}${o}${e?"x":""}`}function Uo(t,e){let r=e.fields.map(({name:n})=>String(
t[n]).toLowerCase());return Io(t,e.variants)??r.join(".")}function ui(t,e){let r=JSON.stringify(t);return Object.keys(e.rewards).find(o=>JSON.stringify(e.rewards[o])===
r)??Object.values(t).map(o=>String(o)).join(pt)}function di(t,e){if(typeof t=="number")return String(t);if(t===Ir)return li;let r=e.scripts.findIndex(({name:n})=>n===
t);return String.fromCharCode(97+r)}var pi="/* the engine */";function Wo(t,e){return d("button",{type:"button",class:"to-playground",title:"Open this step in the playground (G): the same agents a\
nd actions under any rules",onclick:()=>Fr(t(),e)},"What if? Playground")}function Fr(t,e){let r=t!==null&&t.match.n_agents<=100&&Math.max(t.match.config.rows,t.
match.config.cols)<=64,n=r?Ur(mi(t.match,t.step),e):"",o=new TextDecoder().decode(Mr("playground")).replace(pi,()=>kt("script-engine")).replace("</noscript>",s=>r?
s+Lo(t.champions):s);window.open(`${URL.createObjectURL(new Blob([o],{type:"text/html"}))}#${n}`)}function mi(t,e){let{config:r,n_agents:n}=t,o=Math.max(0,e-1),
s=i=>{let l=o*n+i,c=o*r.n_evaders+i-r.n_pursuers,u=p=>i>=r.n_pursuers&&!!p[c];return{cell:[t.last_positions[2*l],t.last_positions[2*l+1]],gone:!t.alive[l],captured:u(
t.captured),everCaptured:u(t.ever_captured)}},a=Array.from({length:n},(i,l)=>s(l));return{rules:r.rules,others:null,rewards:r.rewards,rows:r.rows,cols:r.cols,diagonal:r.
diagonal,fov:r.fov,maxSteps:r.max_steps,seed:t.seed,episode:BigInt(t.episode),steps:o,ended:o===t.length,walls:Array.from(t.map.keys()).filter(i=>t.map[i]),pursuers:a.
slice(0,r.n_pursuers),evaders:a.slice(r.n_pursuers),played:[],next:Array.from(t.actions.subarray(o*n,(o+1)*n))}}function Wt(t,e,r){if(r===0)return[{kind:"start",text:hi(t),agents:[]}];let[n,o]=[e.moments[r-1],e.moments[r]],s=u=>he(u,t.config.n_pursuers),a=at(e,n,o),i=t.conflicts(
r),l=new Set(i.flatMap(u=>u.doomed)),c=a.map(u=>({kind:"capture",text:`${s(u)} is captured`,agents:[u]}));for(let u of Ot(n,o))!a.includes(u)&&!l.has(u)&&c.push(
{kind:"end",text:`${s(u)} disappears`,agents:[u]});return c.push(...i.map(({kind:u,text:p,agents:m})=>({kind:u,text:p,agents:m}))),r===t.length&&c.unshift({kind:"\
end",text:fi(t),agents:[]}),c}function hi({config:t}){return`${t.n_pursuers} pursuers and ${t.n_evaders} evaders on ${t.rows} x ${t.cols} cells, at most ${t.max_steps}\
 steps`}function fi(t){let e=Math.round(t.statistics.capture_rate*t.config.n_evaders);return`The episode ends after ${t.length} steps with ${e} of ${t.config.n_evaders}\
 evaders captured`}var gi=60,Ht=class{element;player=new me(0,{speed:Ne,still:ae()});inspector;#e;#n;#o;#a;#r=d("h2",{class:"match-title"});#t=d("p",{class:"tally numbers"});#i=d(
"ol",{class:"words","aria-live":"off","aria-label":"What happened in this step"});#u=d("p",{class:"problem",role:"alert"});#d=null;#l=null;#c=null;#s=null;#h=0;#f=!1;#p=0;constructor(e,r,n){
[this.#n,this.#o]=[e,r];let o=d("canvas",{"aria-label":"The match"});this.#e=new be(o,{numbers:!1}),this.#a=new zt(r,this.player),this.inspector=new Bt(s=>this.#A(
s)),o.addEventListener("click",s=>this.inspector.choose(this.#e.agentAt(s.clientX,s.clientY))),this.element=d("section",{class:"card match-card","aria-label":"M\
atch",id:"match"},d("div",{class:"match"},d("header",{class:"match-head"},this.#r,this.#t),this.#u,d("div",{class:"stage"},o),d("div",{class:"aside"},this.#i,Eo(),
d("div",{class:"beside"},d("button",{type:"button",class:"to-play",title:"Move the chosen agent, or an evader, yourself from this step on (T)",onclick:()=>this.
element.dispatchEvent(new Event("takeover"))},"Take over an agent"),Wo(()=>this.shown,n)),this.inspector.element),Be(this.player),this.#a.element)),this.player.
addEventListener("frame",()=>this.#s&&this.#e.show(this.#s,this.player.time)),this.player.addEventListener("step",()=>this.#w()),r.on("match",()=>this.#x()),r.on(
"rest",()=>this.player.pause()),this.#v(),this.#b(0,0)}get#m(){return this.#n[this.#o.selected.run]}get match(){return this.#l}get shown(){return this.#l&&this.#c&&
{match:this.#l,step:this.player.step,champions:this.#c}}start(e){this.#d=e,this.#g()}playSoon(){this.#f=!0,this.#h||this.#y()}goTo(e){this.#p=e,!this.#h&&this.#l&&
this.#g()}#y(){!this.#f||!this.#l||(this.#f=!1,this.player.jump(0),ae()||this.player.play())}#x(){this.#v(),clearTimeout(this.#h),this.#h=setTimeout(()=>this.#g(),
gi)}#g(){clearTimeout(this.#h),this.#h=0,this.player.pause(),this.#v();let{selected:e}=this.#o,r=Ie.map(s=>Ae(this.#m,s,e[s])).find(Boolean)??"";if(this.#u.textContent=
r,r||!this.#d)return;this.#l=we(this.#d,this.#m,e);let[n,o]=this.names(e);this.#c={pursuer:{name:n,policy:J(this.#m,"pursuer",e.pursuer)},evader:{name:o,policy:J(
this.#m,"evader",e.evader)}},this.#s=Ft(this.#l),this.#a.show(this.#d,this.#m,this.#l),this.inspector.show(this.#d,this.#m,this.#l,e),this.player.length=this.#l.
length,this.player.marks=jn(this.#s),this.player.jump(this.#p),this.#p=0,this.#w(),this.element.dataset.played=`${e.run} ${e.pursuer} ${e.evader} ${e.episode} ${e.
seed??""}`,this.#y()}names({run:e,pursuer:r,evader:n}){let{teams:o}=this.#n[e];return[o.pursuer.script??`pursuers ${r}`,o.evader.script??`evaders ${n}`]}#v(){let{
episode:e,seed:r}=this.#o.selected,{payoff:n}=this.#m,[o,s]=this.names(this.#o.selected),a=r===null?e<n.episodes?`episode ${e+1} of ${n.episodes}`:`episode ${e+
1}, not part of the cell`:`seed ${r}`;this.#r.replaceChildren(d("span",{class:"pursuer"},o)," against ",d("span",{class:"evader"},s),d("span",{class:"muted smal\
l"},a))}#w(){let e=this.#l;if(!e||!this.#s)return;let r=this.player.step,n=this.#s.moments[r];this.#b(Array.from(n.everCaptured).filter(Boolean).length,r),this.#i.
replaceChildren(...Wt(e,this.#s,r).map(o=>d("li",{class:o.kind,"data-agents":o.agents.join(" ")},o.text))),this.inspector.at(r),this.#S()}#b(e,r){this.#t.replaceChildren(
d("strong",{},e),` of ${this.#m.world.n_evaders} captured`,d("span",{class:"muted"},` · step ${r}`))}#A(e){this.#e.look={selected:e,viewers:e===null?[]:[e]},this.#S()}#S(){
let e=this.inspector.agent;for(let r of this.#i.children){let n=r.dataset.agents?.split(" ")??[];r.classList.toggle("about",e!==null&&n.includes(String(e)))}}};var yi={ArrowUp:[1,0],ArrowDown:[-1,0],ArrowRight:[0,1],ArrowLeft:[0,-1]},vi=5;function Ce(t,e,r,n="pursuer"){t.tabIndex=0,t.setAttribute("role","application"),
t.addEventListener("keydown",o=>{let s=yi[o.key];if(!s)return;let[a,i]=n==="pursuer"?s:[s[1],s[0]],[l,c]=r(),u=o.shiftKey?vi:1,{pursuer:p,evader:m}=e.selected;e.
select({pursuer:Ho(p+u*a,l),evader:Ho(m+u*i,c)}),o.preventDefault(),o.stopPropagation()})}var Ho=(t,e)=>Math.min(e-1,Math.max(0,t));var ee={left:52,bottom:46,top:76,right:84},ie=10,bi=160,mt=ee.right-ie-14,Te=ee.top-ie-14,jt=class{element;#e;#n;#o=d("canvas",{"aria-hidden":"true"});#a=b("svg",
{"aria-hidden":"true"});#r=b("g");#t;#i=d("h2");#u=d("strong",{class:"rate numbers"});#d=d("span",{class:"small muted"});#l=d("p",{class:"of-both-teams small mu\
ted numbers"});#c=null;constructor(e,r){[this.#n,this.#e]=[e,r],this.#t=d("div",{class:"matrix",id:"matrix","aria-label":"Payoff matrix. Arrow keys choose a mat\
ch, Enter plays it."},this.#o,this.#a);let n=d("header",{class:"readout","aria-live":"polite"},d("div",{},this.#i,this.#l),d("div",{class:"of-cell"},this.#u,this.#d));
this.element=d("section",{class:"card matrix-card","aria-label":"Payoff matrix"},n,this.#t,wi()),this.#y(),new ResizeObserver(()=>this.#h()).observe(this.#t),this.#t.
addEventListener("pointermove",o=>this.#v(o)),this.#t.addEventListener("pointerleave",()=>r.point({})),this.#t.addEventListener("click",o=>this.#w(o)),this.#t.addEventListener(
"mousedown",o=>{o.preventDefault(),document.activeElement instanceof HTMLElement&&document.activeElement.blur()}),Ce(this.#t,r,()=>this.#s.payoff.shape),this.#t.
addEventListener("keydown",o=>{o.key==="Enter"&&this.#b()}),r.on("run",()=>this.#h()),r.on("match",()=>this.#m()),r.on("hover",()=>this.#m())}get#s(){return this.#n[this.#e.
selected.run]}#h(){let[e,r]=this.#s.payoff.shape,{clientWidth:n,clientHeight:o}=this.#t;if(n<50)return;let a=Math.max(bi,Math.min(n-ee.left-ee.right,o-ee.top-ee.
bottom))/Math.max(e,r),i=Math.max(ee.left,(n-r*a-ee.right+ee.left)/2),l=ee.top+Math.max(0,(o-ee.top-ee.bottom-e*a)/2),c={width:n,height:o,left:i,top:l,cell:a,rows:e,
columns:r};this.#c=c,Rt(this.#o,this.#s.payoff,{left:i,top:l,width:r*a,height:e*a}),this.#a.setAttribute("viewBox",`0 0 ${n} ${o}`),this.#a.replaceChildren(xi(c),
...Si(c),...this.#p(c),this.#r),this.#m()}#f(e){let r=this.#s.findings?.generalization;if(!r)return[];let{selected:n,hover:o}=this.#e,[s,a]=[o.pursuer??n.pursuer,
o.evader??n.evader],[i,l]=jo(e,r.pursuers.mean[s]??0,s),[c,u]=Go(e,r.evaders.mean[a]??0,a);return[b("circle",{class:"dot of-pursuers",cx:i,cy:l,r:5}),b("circle",
{class:"dot of-evaders",cx:c,cy:u,r:5})]}#p(e){let r=this.#s.findings?.generalization;if(!r)return[];let{left:n,top:o,cell:s,rows:a,columns:i}=e,[l,c]=[n+i*s+ie,
o-ie],u={class:"side"};return[b("rect",{...u,x:l,y:o,width:mt,height:a*s}),b("rect",{...u,x:n,y:c-Te,width:i*s,height:Te}),...Vo(r.pursuers,(p,m)=>jo(e,p,m),"of\
-pursuers"),...Vo(r.evaders,(p,m)=>Go(e,p,m),"of-evaders"),b("text",{class:"tick",x:l,y:o+a*s+16,"text-anchor":"start"},"0"),b("text",{class:"tick",x:l+mt,y:o+a*
s+16,"text-anchor":"end"},"1"),b("text",{class:"tick",x:n-6,y:c-4,"text-anchor":"end"},"0"),b("text",{class:"tick",x:n-6,y:c-Te+8,"text-anchor":"end"},"1"),b("t\
ext",{class:"label of-pursuers",x:l+mt,y:o+a*s+34,"text-anchor":"end"},"captures"),b("text",{class:"label of-evaders",x:n+i*s+ie,y:c-Te+10,"text-anchor":"start"},
"escapes")]}#m(){let e=this.#c;if(!e)return;let{selected:r,hover:n}=this.#e,{left:o,top:s,cell:a,rows:i,columns:l}=e,c=g=>s+(i-1-g)*a,u=[],p=(g,f)=>b("rect",{class:f,
x:o,y:c(g),width:l*a+ie+mt,height:a}),m=(g,f)=>b("rect",{class:f,x:o+g*a,y:s-ie-Te,width:a,height:ie+Te+i*a});if(u.push(p(r.pursuer,"strip pursuer"),m(r.evader,
"strip evader")),n.pursuer!==null&&n.pursuer<i&&u.push(p(n.pursuer,"strip hover")),n.evader!==null&&n.evader<l&&u.push(m(n.evader,"strip hover")),n.lag!==null)for(let g=0;g<
l;g++){let f=g+n.lag;f>=0&&f<i&&u.push(b("rect",{class:"lagged",x:o+g*a,y:c(f),width:a,height:a}))}u.push(...this.#f(e));let h={x:o+r.evader*a,y:c(r.pursuer),width:a,
height:a};u.push(b("rect",{class:"chosen under",...h}),b("rect",{class:"chosen",...h})),this.#r.replaceChildren(...u),this.#y()}#y(){let{selected:e,hover:r}=this.#e,
n=r.pursuer??e.pursuer,o=r.evader??e.evader,s=nt(this.#s,n,o);this.#i.replaceChildren(d("span",{class:"pursuer"},`Pursuers ${n}`)," against ",d("span",{class:"e\
vader"},`evaders ${o}`)),this.#u.textContent=s?I(s.rate,3):"-",this.#d.textContent=s?`capture rate, mean of ${s.rates.length} episodes`:"the evaluation played n\
o episodes",this.#l.textContent=this.#x(n,o)}#x(e,r){let n=this.#s.findings?.generalization;if(!n)return"";let o=(s,a)=>Dt(s.mean[a]??0,s.low?.[a]??null,s.high?.[a]??
null);return`Against all: captures ${o(n.pursuers,e)}, escapes ${o(n.evaders,r)}`}#g(e){let r=this.#c;if(!r)return null;let n=this.#t.getBoundingClientRect(),o=Math.
floor((e.clientX-n.left-r.left)/r.cell),s=r.rows-1-Math.floor((e.clientY-n.top-r.top)/r.cell),[a,i]=[s>=0&&s<r.rows,o>=0&&o<r.columns];return a||i?{g:a?s:-1,h:i?
o:-1,inside:a&&i}:null}#v(e){let r=this.#g(e);this.#e.point(r?{pursuer:r.g<0?null:r.g,evader:r.h<0?null:r.h}:{})}#w(e){let r=this.#g(e);r&&(this.#e.select({...r.
g<0?{}:{pursuer:r.g},...r.h<0?{}:{evader:r.h}}),r.inside&&this.#b())}#b(){this.#t.dispatchEvent(new CustomEvent("play",{bubbles:!0}))}};function wi(){let t=d("s\
pan",{class:"gradient"});return t.style.backgroundImage=Fn(),d("p",{class:"scale-of-rates small muted"},"0 all escape",t,"1 all caught")}function xi({left:t,top:e,
cell:r,rows:n,columns:o}){let s=b("g",{class:"axes"}),a=e+n*r,i=l=>ct(0,l-1,Math.min(l,l*r/44),!0);for(let l of i(o))s.append(b("text",{class:"tick",x:t+(l+.5)*
r,y:a+16,"text-anchor":"middle"},l));for(let l of i(n))s.append(b("text",{class:"tick",x:t-7,y:a-(l+.5)*r,"text-anchor":"end","dominant-baseline":"middle"},l));
return s.append(b("text",{class:"label of-evaders",x:t+o*r/2,y:a+36,"text-anchor":"middle"},"evader generation"),b("text",{class:"label of-pursuers",transform:`\
translate(${t-36} ${e+n*r/2}) rotate(-90)`,"text-anchor":"middle"},"pursuer generation")),s}function Si({left:t,top:e,cell:r,rows:n,columns:o}){let s=b("g",{class:"\
diagonal"}),a=Math.min(n,o);if(a<3)return[];let i=e+n*r;for(let u of["H","V"]){let p=`M${t} ${i}`;for(let m=1;m<=a;m++){let[h,g]=[`H${t+m*r}`,`V${i-m*r}`];p+=u===
"H"?h+g:g+h}s.append(b("path",{d:p,class:"under"}),b("path",{d:p}))}let[l,c]=[t+a/2*r-.7*r-4,i-a/2*r-.7*r-4];return[s,b("text",{class:"on-cells",transform:`tran\
slate(${l} ${c}) rotate(-45)`,"text-anchor":"middle"},"same generation")]}var jo=({left:t,top:e,cell:r,rows:n,columns:o},s,a)=>[t+o*r+ie+s*mt,e+(n-a-.5)*r],Go=({
left:t,top:e,cell:r},n,o)=>[t+(o+.5)*r,e-ie-n*Te];function Vo(t,e,r){let n=s=>s.map((a,i)=>e(a??0,i).map(l=>l.toFixed(1)).join(" ")),o=[];return t.low&&t.high&&
o.push(b("path",{class:`band ${r}`,d:`M${[...n(t.high),...n(t.low).reverse()].join("L")}Z`})),o.push(b("path",{class:`line ${r}`,d:`M${n(t.mean).join("L")}`})),
o}function j(t,e,...r){return d("section",{class:"card panel","aria-label":t},d("header",{},d("h2",{},t),d("p",{class:"small muted"},e)),...r)}function Ko(t,e,r){let{findings:n}=t;if(!n)return null;let o=d("dialog",{class:"four","aria-label":"Four matches"}),s=i=>{let l=r();l&&Mi(o,t,i,e,l)},a=n.checkerboards.
map(i=>Ai(t,i,s));return{element:j("Checkerboards","Two generations of each team: each pursuers are better against one of the evaders. Click one: its four match\
es side by side.",a.length?d("div",{class:"boards"},...a):d("p",{},`No four cells differ by more than ${n.margin} in this way.`),a.length?d("p",{class:"small mu\
ted"},"The strongest of all pairs, so noise makes them look stronger than they are. The diagnosis says whether there are more than noise makes."):null,o)}}var Yo=({
pursuers:[t,e],evaders:[r,n]})=>[[t,r],[t,n],[e,r],[e,n]];function Ai(t,e,r){let[n,o]=e.pursuers,[s,a]=e.evaders,i=Yo(e).map(([l,c])=>{let u=t.payoff.capture_rate[l][c],
p=d("span",{class:"cell"},I(u));return p.style.backgroundColor=Un(u),p.style.color=Nn(u),p});return d("button",{type:"button",class:"miniature numbers",onclick:()=>r(
e)},d("span",{},d("span",{class:"heard"},`Four matches of pursuers ${n} and ${o}, evaders ${s} and ${a}:`)),d("span",{class:"evader"},s),d("span",{class:"evader"},
a),d("span",{class:"pursuer"},n),i[0],i[1],d("span",{class:"pursuer"},o),i[2],i[3])}function Mi(t,e,r,n,o){let s=Yo(r).filter(([m,h])=>!Ae(e,"pursuer",m)&&!Ae(e,
"evader",h)),a=s.map(([m,h])=>we(o,e,{run:n.selected.run,pursuer:m,evader:h,episode:0,seed:null})),i=new me(Math.max(0,...a.map(m=>m.length)),{speed:Ne,still:ae()}),
l=a.map((m,h)=>{let[g,f]=s[h],v=d("canvas",{"aria-label":`Pursuers ${g} against evaders ${f}`}),x=d("span",{class:"numbers"}),A=()=>{t.close(),n.select({pursuer:g,
evader:f})},y=d("figure",{},v,d("figcaption",{class:"small"},x,d("span",{class:"muted"},`cell ${I(e.payoff.capture_rate[g][f])}`),d("button",{type:"button",title:"\
Show this match alone",onclick:A},"open")));return y.style.gridArea=`${r.pursuers.indexOf(g)+2} / ${r.evaders.indexOf(f)+2}`,{element:y,match:m,recording:Ft(m),
board:new be(v,{numbers:!1}),tally:x}}),c=()=>l.forEach(m=>m.board.show(m.recording,i.time)),u=()=>l.forEach(({recording:m,match:h,tally:g})=>{let f=m.moments[Math.
min(i.step,h.length)];g.textContent=`${Array.from(f.everCaptured).filter(Boolean).length} of ${h.config.n_evaders} captured`});i.addEventListener("frame",c),i.addEventListener(
"step",u),t.replaceChildren(d("header",{},d("h2",{},"Four matches of a checkerboard"),d("button",{type:"button",onclick:()=>t.close()},"Close")),d("div",{class:"\
grid-of-four"},d("span"),...r.evaders.map(m=>d("h3",{class:"evader"},`evaders ${m}`)),...r.pursuers.map((m,h)=>{let g=d("h3",{class:"pursuer"},`pursuers ${m}`);
return g.style.gridArea=`${h+2} / 1`,g}),...l.map(m=>m.element)),Be(i));let p=m=>{!(m.target instanceof HTMLSelectElement||m.target instanceof HTMLButtonElement&&
m.key===" ")&&!m.defaultPrevented&&ve(i,m)&&m.preventDefault()};t.addEventListener("keydown",p),t.addEventListener("close",()=>{t.removeEventListener("keydown",
p),i.pause(),l.forEach(m=>m.board.close()),t.replaceChildren()},{once:!0}),n.dispatchEvent(new Event("rest")),t.showModal(),c(),u(),ae()||i.play()}var Gt={pursuer:"evader",evader:"pursuer"};function qo(t,e){let r=t.findings?.ciao;if(!r)return null;let n=["pursuer","evader"].map(o=>{let{fading:s,stripes:a,period:i}=r[`${o}\
s`],l=`fading ${I(s)}, stripes ${I(a)}${i===null?"":` every ${i} generations`}`;return Ei(t,o,l,e)});return{element:j("CIAO","Current individuals against ancest\
ral opponents, by the team's own score. Stripes: intransitive, since wins and losses alternate with the age of the opponent; whether a team returns to earlier s\
trategies is recurrence, under What happened. Darker away from the diagonal: forgetting.",d("div",{class:"triangles"},...n.map(o=>o.element))),update:()=>n.forEach(
o=>o.update())}}function Ei(t,e,r,n){let o=e==="pursuer"?0:1,[s,a]=[t.payoff.shape[o],t.payoff.shape[1-o]],i=(y,w)=>e==="pursuer"?t.payoff.capture_rate[y][w]:1-
t.payoff.capture_rate[w][y],l=d("canvas",{width:a,height:s,"aria-hidden":"true"}),c=l.getContext("2d"),u=c?.createImageData(a,s);for(let y=0;u&&y<s;y++)for(let w=0;w<=
Math.min(y,a-1);w++)u.data.set([...Ue(i(y,w)),255],4*((s-1-y)*a+w));u&&c?.putImageData(u,0,0);let p=b("rect",{class:"chosen",width:1,height:1}),m=b("rect",{class:"\
chosen under",width:1,height:1}),h=b("svg",{viewBox:`0 0 ${a} ${s}`,preserveAspectRatio:"none","aria-hidden":"true"},m,p),g=d("div",{class:"triangle","aria-labe\
l":`CIAO of the ${e}s: ${r}. Arrow keys choose a match.`},l,h);Ce(g,n,()=>t.payoff.shape,e),g.style.aspectRatio=`${a} / ${s}`;let f=y=>{let w=g.getBoundingClientRect(),
M=Math.floor((y.clientX-w.left)/w.width*a),T=s-1-Math.floor((y.clientY-w.top)/w.height*s);return M>=0&&T<s&&M<=T?[T,M]:null},v=y=>({[e]:y[0],[Gt[e]]:y[1]});g.addEventListener(
"pointermove",y=>n.point(f(y)?v(f(y)):{})),g.addEventListener("pointerleave",()=>n.point({})),g.addEventListener("click",y=>f(y)&&n.select(v(f(y))));let x=()=>{
let y=n.hover[e]??n.selected[e],w=n.hover[Gt[e]]??n.selected[Gt[e]];for(let M of[p,m])M.setAttribute("x",String(w)),M.setAttribute("y",String(s-1-y)),M.style.display=
w<=y?"":"none"};return{element:d("figure",{},d("figcaption",{class:"small"},d("span",{class:e},`${e}s`)),g,d("p",{class:"small muted"},`horizontal: ${Gt[e]} gen\
eration; vertical: ${e} generation`),d("p",{class:"small numbers"},r)),update:x}}var Vt={left:46,right:12,top:10,bottom:42},Zo={x:56,y:34};function Kt(t,e,r,n){let[o,s]=[Vt.left,Vt.top],a=Math.max(o+40,t-Vt.right),i=Math.max(s+40,e-Vt.bottom),
l=(f,v,x)=>A=>v+(A-f.low)/(f.high-f.low||1)*(x-v),[c,u]=[l(r,o,a),l(n,i,s)],p=b("g"),m=b("svg",{width:t,height:e,viewBox:`0 0 ${t} ${e}`,class:"plot"}),h=b("g",
{class:"axes"});for(let f of ct(n.low,n.high,(i-s)/Zo.y,n.whole))h.append(b("line",{x1:o,x2:a,y1:u(f),y2:u(f),class:"grid"}),b("text",{x:o-8,y:u(f),"text-anchor":"\
end","dominant-baseline":"middle"},Jo(f)));for(let f of ct(r.low,r.high,(a-o)/Zo.x,r.whole))h.append(b("text",{x:c(f),y:i+16,"text-anchor":"middle"},Jo(f)));return h.
append(b("line",{x1:o,x2:a,y1:i,y2:i,class:"axis"}),b("text",{x:(o+a)/2,y:e-6,"text-anchor":"middle",class:"label"},r.label),b("text",{transform:`translate(12 ${(s+
i)/2}) rotate(-90)`,"text-anchor":"middle",class:"label"},n.label)),m.append(h,p),{root:m,marks:p,left:o,right:a,top:s,bottom:i,x:c,y:u,at:f=>{let v=f-m.getBoundingClientRect().
left;return r.low+(v-o)/(a-o)*(r.high-r.low)}}}var Jo=t=>String(Number(t.toPrecision(6))).replace("-","−");function ht(t,e,r,n){let o="",s="M";r.forEach((i,l)=>{
i===null?s="M":(o+=`${s}${t.x(e[l]).toFixed(1)} ${t.y(i).toFixed(1)}`,s="L")});let a=b("path",{d:o,class:`line ${n}`});return t.root.insertBefore(a,t.marks),a}function ft(t,e,r,n=null){let o=t.x(e);t.marks.append(b("line",{x1:o,x2:o,y1:t.top,y2:t.bottom,class:`mark ${r}`})),n!==null&&t.marks.append(b("circle",{cx:o,cy:t.
y(n),r:5,class:`dot ${r}`}))}function Dr(...t){return d("p",{class:"legend small"},...t.map(([e,r])=>d("span",{class:`key ${r}`},e)))}function Yt(t,e,r={}){let n=d(
"div",{class:"chart",role:"img","aria-label":t}),o=null,s=()=>{o?.marks.replaceChildren(),o&&r.marks?.(o)},a=()=>{let{clientWidth:i,clientHeight:l}=n;i<50||l<50||
(o=e(i,l),n.replaceChildren(o.root),s())};return n.addEventListener("pointermove",i=>r.point?.(o?.at(i.clientX)??null)),n.addEventListener("pointerleave",()=>r.
point?.(null)),r.choose&&(n.classList.add("chooses"),n.addEventListener("click",i=>o&&r.choose?.(o.at(i.clientX),o,i))),new ResizeObserver(a).observe(n),{element:n,
redraw:a,remark:s}}var zr=["of-pursuers","of-evaders","of-both"],Ci=2500,Xo="Arrow keys choose generations.",Qo={low:0,high:1,label:"capture rate"};function es(t,e){let{training:r}=t,
{capture_rate:n,generation:o,learner:s,epochs:a}=r,i=n.map((g,f)=>(f+1)*a),l=Ti(n,r.window),c=i.at(-1)??1,u=i.length>Ci?"dense":"",p=(g,f)=>{let v=o.flatMap((x,A)=>x===
g&&(s[A]===f||s[A]===2)?[A]:[]);return v.length?[i[v[0]],i[v.at(-1)]]:null},m=Yt(`Capture rate in ${c} epochs of training. ${Xo}`,(g,f)=>{let v=Kt(g,f,{low:0,high:c,
label:"epoch",whole:!0},Qo);for(let[x,A]of[["raw",n],[u,l]])for(let[y,w]of zr.entries()){let M=A.map((T,k)=>s[k]===y||s[k+1]===y?T:null);M.some(T=>T!==null)&&ht(
v,i,M,`${w} ${x}`)}return v},{marks:g=>{let{pursuer:f,evader:v}=e.selected;for(let[x,A]of[[0,f],[1,v]]){let y=p(e.hover[x?"evader":"pursuer"]??A,x);y&&ft(g,(y[0]+
y[1])/2,zr[x])}},choose:g=>{let f=Math.min(i.length-1,Math.max(0,Math.round(g/a)-1)),v=o[f];s[f]!==1&&e.select({pursuer:Math.min(v,t.payoff.shape[0]-1)}),s[f]!==
0&&e.select({evader:Math.min(v,t.payoff.shape[1]-1)})}});Ce(m.element,e,()=>t.payoff.shape);let h=[...new Set(s)].sort().map(g=>[["pursuers learn","evaders lear\
n","both teams learn"][g],zr[g]]);return{element:j("Training",`${To(r.matches)} training matches. Lines: the generations that are selected.`,Dr(...h),m.element),
update:m.remark}}function ts(t,e){let r=t.findings?.lags;if(!r)return null;let[n,o]=[r.lags[0],r.lags.at(-1)],s=Math.min(5,(Math.max(...r.cells)+1)/2),a=r.means.
map((l,c)=>r.cells[c]>=s?l:null),i=Yt("Lag profile",(l,c)=>{let u=Kt(l,c,{low:n,high:o,label:"lag: pursuer minus evader generation",whole:!0},Qo);return ht(u,r.
lags,r.means,"raw ink"),ht(u,r.lags,a,"ink"),u},{marks:l=>{let{pursuer:c,evader:u}=e.selected;ft(l,0,"zero");let p=e.hover.lag??c-u;ft(l,p,"ink",r.means[p-n])},
point:l=>{let c=l===null?null:Math.round(l);e.point({lag:c!==null&&c>=n&&c<=o?c:null})}});return{element:j("Lag profile","Left: evaders are later. Right: pursue\
rs are later. It rises if both teams keep what they learn. Faint: fewer than 5 cells.",i.element),update:i.remark}}function rs(t,e){let r=t.findings?.ratings;if(!r)
return null;let n={pursuer:r.pursuers,evader:r.evaders},o=[...r.pursuers,...r.evaders].map(u=>u??0),[s,a]=[Math.min(...o),Math.max(...o)],i=.06*(a-s||1),l=Math.
max(...t.payoff.shape)-1,c=Yt(`Elo ratings by generation. ${Xo}`,(u,p)=>{let m=Kt(u,p,{low:0,high:l,label:"generation",whole:!0},{low:s-i,high:a+i,label:"Elo po\
ints"});for(let h of["pursuer","evader"])ht(m,n[h].map((g,f)=>f),n[h],`of-${h}s`);return m},{marks:u=>{for(let p of["pursuer","evader"]){let m=e.hover[p]??e.selected[p];
ft(u,m,`of-${p}s`,n[p][m]??null)}},choose:(u,p,m)=>{let h=Math.round(u),g=m.clientY-p.root.getBoundingClientRect().top,f=x=>Math.abs(p.y(n[x][h]??1/0)-g),v=f("p\
ursuer")<=f("evader")?"pursuer":"evader";h>=0&&h<n[v].length&&e.select({[v]:h})}});return Ce(c.element,e,()=>t.payoff.shape),{element:j("Ratings",`One number fo\
r each generation, which cycles do not fit. The game itself: ${I(r.offset,0)} points for the pursuers.`,Dr(["pursuers","of-pursuers"],["evaders","of-evaders"]),
c.element),update:c.remark}}function Ti(t,e){let r=[0];for(let n of t)r.push(r.at(-1)+n);return t.map((n,o)=>{let[s,a]=[Math.max(0,o-Math.floor((e-1)/2)),Math.min(
t.length,o+Math.floor(e/2)+1)];return(r[a]-r[s])/(a-s)})}var ki={present:"●",absent:"○","cannot tell":"?"};function ns(t){let{findings:e}=t;if(!e)return null;let[,...r]=e.table,n=new Map(e.reasons.map(a=>{let[i,,l]=Ri(
a);return[i,l]})),o=r.map(([a,i,l,c])=>{let u=c===e.window?n.get(a):void 0;return d("li",{class:`finding ${i.replace(" ","-")}`},d("span",{class:"sign","aria-hi\
dden":"true"},ki[i]??""),d("div",{},d("p",{},d("strong",{},a),` ${i}`,d("span",{class:"muted"},` · ${c}`)),u?d("p",{class:"small"},`${u}.`):null,d("p",{class:"\
small muted numbers"},l)))}),s=j("What happened","Each condition is present, absent, or its 95 % interval cannot tell. The intervals are about this run.",d("p",
{class:"headline"},e.headline),...e.numbers.map(a=>d("p",{class:"numbers"},`${os(a)}.`)),d("ul",{class:"findings"},...o),t.limits?d("p",{class:"small"},t.limits):
null,d("details",{class:"small"},d("summary",{},"Headline numbers in words"),...e.description.map(a=>d("p",{},a)),$i(e)));return s.classList.add("diagnosis"),{element:s}}
function Ri(t){let[e="",r=""]=t.split(/: (.*)/s),[n="",o=""]=r.split(/, because (.*)/s);return[e.toLowerCase(),n,os(o.replace(/\.$/,""))]}var os=t=>t.charAt(0).
toUpperCase()+t.slice(1);function $i({noise:t}){return t.transitive_share_noise===null?null:d("p",{},`Last half: transitive share ${I(t.transitive_share)} (an o\
rder of strength with the same noise rarely falls below ${I(t.transitive_share_noise)}), checkerboards ${Lr(t.checkerboard_share)} (it rarely exceeds ${Lr(t.checkerboard_share_noise)}\
).`)}function ss(t){let e=[t.held_out?.pursuers,t.held_out?.evaders].filter(r=>r!=null);return e.length?{element:j("Held-out opponents",`The last generations against\
 opponents that no run has met; 95 % intervals over ${e[0].episodes} episodes.`,...e.map(_i))}:null}function _i(t){let e=n=>n.at(-1),r=[["mean",e(t.mean)],...Object.
entries(t.against).map(([n,o])=>[n,e(o)])];return d("table",{class:"scores numbers"},d("caption",{},d("span",{class:t.team},`${t.team}s`),` of generation ${t.generations.
at(-1)}, ${t.score}`),...r.map(([n,o],s)=>d("tr",{class:s?"":"mean"},d("th",{scope:"row"},n),d("td",{class:"range"},Oi(o,t.team)),d("td",{},Dt(o.value,o.low,o.high)))))}
function Oi({value:t,low:e,high:r},n){let o=d("span",{class:`between ${n}`});o.style.left=`${100*(e??t)}%`,o.style.width=`${100*((r??t)-(e??t))}%`;let s=d("span",
{class:`value ${n}`});return s.style.left=`${100*t}%`,d("span",{class:"scale","aria-hidden":"true"},o,s)}function is(t){let e=t.settings.filter(o=>o.changed),r=t.settings.filter(o=>!o.changed),n=j("Settings",`${t.schedule}, seed ${t.seed}. Every setting is an optio\
n of matrixworld evolve.`,e.length?as(e,"other than the default"):d("p",{class:"small"},"All settings are the defaults."),d("details",{class:"small"},d("summary",
{},`${r.length} settings with their defaults`),as(r,"defaults")));return n.classList.add("settings"),{element:n}}function as(t,e){return d("div",{class:"wide-ta\
ble"},d("table",{class:"small"},d("caption",{class:"heard"},`Settings: ${e}`),...t.map(({name:r,value:n,help:o})=>d("tr",{},d("th",{scope:"row"},`--${r.replaceAll(
"_","-")}`),d("td",{class:"numbers"},n),d("td",{class:"muted"},o)))))}function ls(t,e,r){let n=new Map,o=d("div",{class:"panels"}),s=[],a=()=>s.forEach(l=>l.update?.()),i=()=>{let l=t[e.selected.run];s=n.get(l)??Pi(l,e,r),n.set(l,
s),o.replaceChildren(...s.map(c=>c.element)),a()};return e.on("run",i),e.on("match",a),e.on("hover",a),i(),o}function Pi(t,e,r){return[ns(t),es(t,e),Ko(t,e,r),ts(
t,e),rs(t,e),qo(t,e),ss(t),is(t)].filter(o=>o!==null)}var cs={pursuer:null,evader:null,lag:null},qt=class extends EventTarget{#e;#n=cs;constructor(e){super(),this.#e=e}get selected(){return this.#e}get hover(){return this.#n}select(e){
let r=this.#e,n=["run","pursuer","evader"].some(o=>o in e&&e[o]!==r[o]);this.#e={...r,...n?{episode:0,seed:null}:{},...e},this.#e.run!==r.run&&this.dispatchEvent(
new Event("run")),this.dispatchEvent(new Event("match"))}point(e){let r={...cs,...e};r.pursuer===this.#n.pursuer&&r.evader===this.#n.evader&&r.lag===this.#n.lag||
(this.#n=r,this.dispatchEvent(new Event("hover")))}on(e,r){this.addEventListener(e,r)}};var Zt=class{config;start;recording;actions=[];#e;#n;#o=[[]];constructor(e,r,n){[this.config,this.start]=[r,n],this.#e=e.world(r),this.#e.reset(n),this.#n=[Ut(this.#e)],
this.recording=Nt(r,this.#e.map(),this.#n)}get length(){return this.actions.length}get over(){return this.#e.over}get statistics(){return{capture_rate:this.#e.read(
"capture_rate")[0]}}conflicts(e){return this.#o[e]}play(e){this.#e.step(e),this.#a(e)}step(e,r,n){let[o,s]=[this.#e,this.config.n_pursuers],a=new Uint8Array(o.n_agents);
for(let i=o.n_turns;i>0&&!o.over;--i){let[l,c]=o.actors;l<s&&(a=o.decide(e.pursuer,[l,Math.min(c,s)],a)),c>s&&(a=o.decide(e.evader,[Math.max(l,s),c],a)),typeof n==
"number"?a[r]=n:l<=r&&r<c&&(a=o.decide(n,[r,r+1],a)),o.playTurn(a)}this.#a(a)}#a(e){this.actions.push(e),this.#n.push(Ut(this.#e,e)),this.#o.push(this.#e.conflicts())}};var fe=(t,e)=>Ie[+(e>=t.n_pursuers)];function Br(t,e){let r=new Zt(t,e.config,{seed:e.seed,episode:e.episode});for(let n of e.moves)r.over||r.step(e.policies,e.
seat,n);return r}function He(t,e){let{moments:r,nPursuers:n}=t.recording,o=r.findIndex(({alive:a,captured:i})=>!a[e]||!!i[e-n]),s=o<0?t.length:o;return{lasted:s,
out:o>=0,captured:Array.from(r[s].everCaptured).filter(Boolean).length}}var Jt=(t,e)=>t.over||He(t,e).out;function us(t,e,r){let n=Br(t,{...e,moves:e.moves.slice(
0,e.from)});for(;!Jt(n,e.seat);)n.step(e.policies,e.seat,r);return He(n,e.seat)}function ds(t){let e=t.length-1;return[...new Set([0,Math.round(e/3),e])].map(r=>t[r])}
function ps(t,{seat:e,from:r,moves:n}){let o={...t,seat:e,...r?{from:r}:{},moves:n.join("")};return`${location.href.split("#")[0]}#${Object.entries(o).map(([s,a])=>`${s}\
=${a}`).join("&")}`}function ms(t,e){let[r,n,o]=[t.get("seat")??"",t.get("from")??"0",t.get("moves")??""];return/^\d{1,6}$/.test(r)&&Number(r)<e.n_pursuers+e.n_evaders&&
(e.diagonal?/^[0-8]+$/:/^[0-4]+$/).test(o)&&o.length<=e.max_steps&&/^\d{1,6}$/.test(n)&&Number(n)<=o.length?{seat:Number(r),from:Number(n),moves:[...o].map(Number)}:
null}function hs(t,e,r,n){let o=fe(r.config,r.seat)==="evader",s=o?r.config.max_steps:r.config.n_evaders,a=d("table",{class:"numbers"},d("caption",{},o?"Steps in you\
r seat: same start, same others":"Captures of your team: same start, same others")),i=l=>{let[c,u]=[d("span",{class:o?"bar evader":"bar pursuer"}),d("td",{},"…")];
return a.append(d("tr",{},d("th",{scope:"row"},l),d("td",{class:"track","aria-hidden":"true"},c),u)),({lasted:p,captured:m})=>{c.style.width=`${100*(o?p:m)/s}%`,
u.textContent=String(o?p:m)}};i("You")(He(e,r.seat));for(let{name:l,policy:c}of n){let u=i(l);setTimeout(()=>u(us(t,r,c())))}return d("div",{},a,d("p",{class:"s\
mall muted"},"One match: luck has its part in it."))}var fs=()=>["file:","http:","https:"].includes(location.protocol);var gs=["·","↑","→","↓","←","↗","↘","↙","↖"];var Ii={" ":0,s:0,ArrowUp:1,w:1,ArrowRight:2,d:2,ArrowDown:3,x:3,ArrowLeft:4,a:4,e:5,c:6,y:7,z:7,q:8},Wr=[8,1,5,4,0,2,7,3,6],Ni=[7,8,9,4,5,6,1,2,3],Ui=24,Fi=Math.
tan(Math.PI/8);function vs(t,e){if(t.ctrlKey||t.metaKey||t.altKey)return;let r=Ni.findIndex(o=>t.code===`Numpad${o}`),n=Wr[r]??Ii[t.key.length===1?t.key.toLowerCase():
t.key];return n!==void 0&&n>4&&!e?void 0:n}function bs(t){let e=Wr.map(r=>d("button",{type:"button","aria-label":We[r],onclick:()=>t(r)},gs[r]));return{element:d(
"div",{class:"play-pad",role:"group","aria-label":"Your move"},...e),show:r=>e.forEach((n,o)=>n.classList.toggle("absent",Wr[o]>4&&!r))}}function ys(t,e,r){let n=Fi*
Math.max(Math.abs(t),Math.abs(e)),o=s=>Math.abs(s)<n?0:s;return Wn([0,0],r?[o(t),o(e)]:[t,e],r)}function ws(t,e,r){let n=null,{canvas:o}=t;o.addEventListener("p\
ointerdown",({button:s,clientX:a,clientY:i})=>{n=s===0?[a,i]:null}),o.addEventListener("pointercancel",()=>{n=null}),o.addEventListener("pointerup",({clientX:s,
clientY:a})=>{let[i,l]=[n,e()];if(n=null,!i||!l)return;let[c,u]=[s-i[0],a-i[1]],p=t.cellAt(s,a);Math.hypot(c,u)>=Ui?r(ys(u,c,l.diagonal)):p&&r(ys(p[0]-l.cell[0],
p[1]-l.cell[1],l.diagonal))})}function xs(t,e){let r=n=>{let o=e[n]-t[n],s=Fe.findIndex(a=>a[n]===Math.sign(o)&&a[1-n]===0);return o?`${Math.abs(o)} ${We[s]}`:""};
return[r(0),r(1)].filter(Boolean).join(", ")||"on your cell"}var Ms="NUMPY\0",Ss=Ms.length+2,As=64;function Es(t){return On(Object.fromEntries(Object.entries(t).map(([e,r])=>[`${e}.npy`,Di(r)])))}function Di({dtype:t,shape:e,
data:r}){let n=typeof r=="string"?Array.from(r,u=>u.codePointAt(0)):null,o=e.map(u=>`${u}, `).join(""),s=`{'descr': '${n?`<U${n.length}`:t}', 'fortran_order': F\
alse, 'shape': (${o}), }`,a=Math.ceil((Ss+s.length+1)/As)*As-Ss,i=Ms+String.fromCharCode(a&255,a>>8)+s.padEnd(a-1)+`
`,l=n?Int32Array.from(n):r,c=new Uint8Array(i.length+l.byteLength);return c.set(Et(i,!0)),c.set(new Uint8Array(l.buffer,l.byteOffset,l.byteLength),i.length),c}var zi="matrixworld episode 3";function Cs(t,e,r){let{config:n,actions:o,length:s,recording:a}=e,[i,l]=[n.n_pursuers+n.n_evaders,n.n_evaders],c={positions:["<i4",
i,2],last_positions:["<i4",i,2],alive:["|b1",i],captured:["|b1",l],ever_captured:["|b1",l]},u={rewards:["<f4",i],involved:["|b1",i,3],fault:["|b1",i,3]},p={},m=y=>{
for(let w of Object.keys(y))(p[w]??=[]).push(Array.from(h.read(w),Number))},h=t.world(n);h.reset(e.start);let g=[];m(c);for(let y of o)h.step(y),m({...c,...u}),
g.push(...h.conflictTable());h.free();let f={"<i4":Int32Array,"<f4":Float32Array,"|b1":Uint8Array},v={};for(let[y,[w,...M]]of Object.entries({...c,...u})){let T=s+
+(y in c);v[y]={dtype:w,shape:[T,...M],data:f[w].from((p[y]??[]).flat())}}let x=y=>({dtype:"<i4",shape:[],data:Int32Array.of(y)}),A=y=>({dtype:"<U",shape:[],data:y});
return Es({format:A(zi),n_pursuers:x(n.n_pursuers),config:A(JSON.stringify(n)),seat:x(r),...v,actions:{dtype:"|i1",shape:[s,i],data:Int8Array.from(o.flatMap(y=>[
...y]))},map:{dtype:"|b1",shape:[n.rows,n.cols],data:Uint8Array.from(a.obstacles,Number)},conflict_table:{dtype:"<i4",shape:[g.length/11,11],data:Int32Array.from(
g)}})}var Bi=[0,1,2,4,8],Xt=class{element;player=new me(0,{speed:4,still:ae()});#e;#n;#o=d("canvas",{tabindex:0,"aria-describedby":"play-keys"});#a=d("h2");#r=d("p",{
class:"play-told",role:"status"});#t=bs(e=>this.act(e));#i=d("select",{},...Bi.map(e=>d("option",{value:e},e?`${e} steps a second`:"step by step")));#u=d("input",
{type:"checkbox"});#d=d("section",{class:"play-ending",tabindex:-1,"aria-label":"Result"});#l=Be(this.player);#c=null;#s=null;#h=[];#f=null;#p=0;#m=0;constructor(e){
this.#e=e,this.#n=new be(this.#o,{numbers:!1}),this.#o.setAttribute("role","application"),this.#i.addEventListener("change",()=>this.#g()),this.#u.addEventListener(
"change",()=>this.#x()),ws(this.#n,()=>{let r=this.#f!==null&&this.#s&&R(this.#s.recording.moments.at(-1),this.#f);return r?{cell:r,diagonal:this.#s.config.diagonal}:
null},r=>this.act(r)),this.player.addEventListener("frame",()=>this.#s&&this.#n.show(this.#s.recording,this.player.time)),this.player.addEventListener("step",()=>this.#S()),
this.element=d("div",{class:"play"},d("header",{class:"play-head"},this.#a,this.#r),d("div",{class:"play-stage"},this.#o),d("div",{class:"play-side"},this.#d,this.#t.
element,d("label",{class:"play-choice"},"Pace ",this.#i),d("label",{class:"play-choice"},this.#u," Fog: see only what it sees"),d("p",{class:"small muted play-k\
eys",id:"play-keys"},"Arrow keys move and Space stays; Q W E A S D Z X C and the numeric keypad know diagonals, too. On the board: swipe, or tap where to go.")),
this.#l)}get played(){return this.#c&&{...this.#c.played,moves:this.#h}}get live(){return this.#s}play(e){this.#y(Br(this.#e,e.played),e.played.seat,e.title),[this.#c,
this.#h,this.#p]=[e,[...e.played.moves],0],this.element.dataset.state="playing",this.#o.focus({preventScroll:!0}),Jt(this.#s,e.played.seat)&&this.#w()}watch(e,r,n){
this.#c=null,this.#y(e,r,n),this.#b()}stop(){this.#g(),this.player.pause(),this.#c=null}act(e){let[r,n]=[this.#c,this.#s];if(!r||!n||this.element.dataset.state!==
"playing")return;this.#p=e;let o=Number(this.#i.value);this.#m||(this.#v(),o&&this.element.dataset.state==="playing"&&(this.#m=setInterval(()=>this.#v(),1e3/o)))}key(e){
let{target:r,key:n}=e;if(r instanceof HTMLSelectElement||r instanceof HTMLInputElement&&(r.type==="text"||n===" ")||r instanceof HTMLButtonElement&&(n===" "||n===
"Enter")||!this.#s)return!1;if(this.element.dataset.state!=="playing")return ve(this.player,e);let s=vs(e,this.#s.config.diagonal);return s!==void 0&&this.act(s),
s!==void 0}#y(e,r,n){this.#g(),this.player.pause(),[this.#s,this.#f]=[e,r],this.#a.textContent=n,this.#o.ariaLabel=`Board, ${e.config.rows} by ${e.config.cols} \
cells`,this.#t.show(e.config.diagonal),this.#d.replaceChildren(),this.player.length=e.length,this.player.jump(e.length),this.#x(),this.#S()}#x(){this.#n.look={you:this.#f,
fog:this.#u.checked,viewers:this.#f===null?[]:[this.#f]}}#g(){clearInterval(this.#m),this.#m=0,this.#r.ariaLive=Number(this.#i.value)?"off":"polite"}#v(){let[{policies:e,
seat:r},n]=[this.#c.played,this.#s];n.step(e,r,this.#p),this.#h.push(this.#p),this.player.length=n.length,this.player.glide=Math.min(.22,.9/(Number(this.#i.value)||
4)),this.player.move(n.length-this.player.step),Jt(n,r)&&this.#w()}#w(){this.#g();let[e,r,n]=[this.#c,this.#s,this.played],o=fs()?e.link(n):null;this.#d.replaceChildren(
d("h3",{},ji(r,n.seat)),...e.ending(r,n),d("div",{class:"play-buttons"},d("button",{type:"button",class:"primary",onclick:()=>e.again()},"Again"),d("button",{type:"\
button",onclick:()=>this.#b()},"Watch it"),d("button",{type:"button",onclick:()=>this.#A(r,n.seat)},"Save"),o&&d("button",{type:"button",onclick:({currentTarget:s})=>Vi(
s,o)},"Link"))),this.element.dataset.state="ended",this.#d.focus({preventScroll:!0}),this.#d.scrollIntoView({block:"nearest"})}#b(){this.element.dataset.state="\
watched",this.player.length=this.#s.length,this.player.jump(0),ae()||this.player.play()}#A(e,r){let n=new Blob([Cs(this.#e,e,r)],{type:"application/octet-stream"});
d("a",{href:URL.createObjectURL(n),download:`${he(r,e.config.n_pursuers)}-${e.length}-steps.npz`}).click()}#S(){let[e,r,{step:n}]=[this.#s,this.#f,this.player];
if(!e||n>e.length)return;let o=Wt(e,e.recording,n).filter(({agents:a})=>r===null||a.includes(r)),s=[`Step ${n} of ${e.config.max_steps}`,...o.map(({text:a})=>a)];
this.#c&&n===0?s.push(Wi(e.config,r)):r!==null&&s.push(Hi(e,n,r)),this.#r.textContent=s.filter(Boolean).map(a=>`${a}.`).join(" ")}};function Wi(t,e){let r=t.rules.
capture==="SURROUND";return fe(t,e)==="evader"?`Stay free: ${r?"pursuers on all sides of you capture":"a pursuer on your cell captures"} you`:`Capture evaders: ${r?
"surround them together":"reach their cell"}`}function Hi({config:t,recording:e},r,n){let o=e.moments[r],a=fe(t,n)==="pursuer"?"evader":"pursuer";if(!o.alive[n])
return"";let i=R(o,n),l=p=>{let[m,h]=R(o,p);return Math.max(Math.abs(m-i[0]),Math.abs(h-i[1]))},c=Array.from({length:o.alive.length},(p,m)=>m).filter(p=>fe(t,p)===
a&&o.alive[p]&&!o.captured[p-t.n_pursuers]&&2*l(p)<t.fov);if(!c.length)return`No ${a} in view`;let u=c.reduce((p,m)=>l(m)<l(p)?m:p);return`Nearest ${a}: ${xs(i,
R(o,u))}`}function ji(t,e){let[{lasted:r,out:n,captured:o},{config:s}]=[He(t,e),t];return fe(s,e)==="pursuer"?`Your team captured ${o} of ${Gi(s)} in ${r} steps\
.`:n?`You lasted ${r} of ${s.max_steps} steps.`:`You escaped: ${r} steps.`}var Gi=({n_evaders:t})=>`${t} evader${t===1?"":"s"}`;function Vi(t,e){let r=d("input",
{type:"text",readonly:!0,value:e,"aria-label":"Link to this match"});t.replaceWith(r),r.select(),navigator.clipboard?.writeText(e).catch(()=>{})}var Qt=class{dialog=d("dialog",{class:"take-over","aria-label":"Play an agent"});#e;#n;#o;#a=null;#r=null;constructor(e,r,n){[this.#e,this.#n,this.#o]=[e,r,n],n.
element.addEventListener("takeover",()=>this.open()),this.dialog.addEventListener("keydown",o=>this.#r?.key(o)&&o.preventDefault()),this.dialog.addEventListener(
"close",()=>this.#r?.stop())}get view(){return this.#r}start(e,r){this.#a=e;let n=Qe(r,this.#e,this.#n.selected),o=ms(new URLSearchParams(r.replace(/^#/,"")),this.#e[n.
run].world);o&&this.#t(n,o)}open(){let e=this.#o.shown;if(!e)return;let{match:r,step:n}=e;this.#o.player.pause();let o=this.#o.inspector.agent,s=n<r.length?n:0,
a=(p,m)=>!!r.alive[m*r.n_agents+p],i=Array.from({length:r.n_agents},(p,m)=>(m+r.config.n_pursuers)%r.n_agents),l=o??i.find(p=>a(p,s)),c=a(l,s)?s:0,u=Array.from(
{length:c},(p,m)=>r.actions[m*r.n_agents+l]);this.#t(this.#n.selected,{seat:l,from:c,moves:u})}#t(e,r){let[n,o]=[this.#a,this.#e[e.run]];if(!n||Ie.some(m=>Ae(o,
m,e[m])))return;let{run:s,pursuer:a,evader:i,episode:l,seed:c}=e,u=fe(o.world,r.seat),p=o.teams[u].kept.map(m=>({name:o.teams[u].script??`generation ${m}`,policy:()=>J(
o,u,m)}));this.#r||(this.#r=new Xt(n),this.dialog.append(d("button",{type:"button",class:"leave",onclick:()=>this.dialog.close()},"Close"),this.#r.element)),this.
dialog.open||this.dialog.showModal(),this.#r.play({title:`You are ${he(r.seat,o.world.n_pursuers)}: ${this.#o.names(e).join(" against ")}`,played:{config:o.world,
seed:BigInt(c??o.seeds[a][i]),episode:l,...r,policies:{pursuer:J(o,"pursuer",a),evader:J(o,"evader",i)}},ending:(m,h)=>[hs(n,m,h,ds(p))],again:()=>this.#t(e,{...r,
moves:r.moves.slice(0,r.from)}),link:m=>ps({run:s,pursuers:a,evaders:i,episode:l,...c===null?{}:{seed:c}},m)})}};var xe=Ln(),{runs:re}=xe,[Ki,Yi]=re[0].payoff.shape,qi=Qe(location.hash,re,{run:0,pursuer:Ki-1,evader:Yi-1,episode:0,seed:null}),{step:Ts,...Zi}=qi,le=new qt(Zi),
q=new Ht(re,le,xe.playground),ks=new jt(re,le),gt=new Qt(re,le,q),Hr=zn(),Ji=location.hash,je=null,Xi="Each cell is a match: pursuers of one generation against \
evaders of another. Bright: many are captured. Click a cell to watch it.";document.getElementById("page").replaceWith(d("header",{class:"top"},d("div",{},d("h1",
{},xe.heading),d("p",{class:"lead"},Xi)),d("div",{class:"tools"},gn(),d("button",{type:"button",class:"keys-button",title:"Keys (?)","aria-label":"Keys (?)",onclick:()=>Hr.
showModal()},"?"))),...xe.note?[d("aside",{class:"note small muted"},xe.note)]:[],Dn(re,le),d("main",{class:"stages"},ks.element,q.element),ls(re,le,()=>je),d("\
footer",{class:"muted small"},`${xe.title} · matrixworld ${xe.version}`),gt.dialog,Hr);Object.assign(window,{matrixworldExplorer:{get match(){return q.match},get step(){
return q.player.step},get pace(){return q.player.pace},get playing(){return gt.view},play:t=>je&&we(je,re[le.selected.run],{...le.selected,episode:t}),get shape(){
return re[le.selected.run].payoff.shape}}});ks.element.addEventListener("play",()=>q.playSoon());q.goTo(Ts);Ts||q.playSoon();yn(re,le,q);Bn(re,le,q,Hr,()=>gt.open(),
()=>Fr(q.shown,xe.playground));window.addEventListener("hashchange",({newURL:t})=>je&&gt.start(je,new URL(t).hash));requestAnimationFrame(()=>setTimeout(()=>{hn().
then(t=>{je=t,q.start(t),gt.start(t,Ji),document.body.dataset.ready="true"},t=>{q.element.prepend(d("p",{class:"problem",role:"alert"},`The engine does not star\
t here: ${String(t)}`)),document.body.dataset.ready="true"})}));})();
