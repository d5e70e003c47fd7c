/* built from web/ by "npm run build"; sources 678b25de6adcd939ec24bf55c8ef0bb6c8f80625c51dfdee68d2c743b444eb81 */
"use strict";(()=>{var Mr={SIMULTANEOUS:0,SWARM_TURNS:1,AGENT_TURNS:2},ke={DISAPPEAR:0,REACH:1,BOUNCE:2},Er={OCCUPATION:0,SURROUND:1},Tr={FAULT:0,INVOLVED:1};var Ot=["obstacle","teammate","adversary"],Lt=["vertex","edge","chain"],Cr=["turn","kind","form","first","second","row","col","at_fault","held","doomed"],It=["p\
ursuer_{number}","evader_{number}"],kr={obstacle:"{first} ran into the obstacle or border at {cell}",vertex:"{first} and {second} both headed for {cell}",edge:"\
{first} and {second} meant to swap, {first} to {cell}",chain:"{first} headed for {cell}, where {second} had to stay"},Re={"both held":"both bounce","both doomed":"\
both disappear",held:"{agent} bounces",doomed:"{agent} disappears",none:"nobody is stopped"},Rr="{event}: {outcome}",Nt={random:"any action, all equally likely",
still:"always stays",chaser:"moves to where the nearest adversary in view is nearest",fleer:"moves to where the nearest adversary in view is farthest","clumsy-c\
haser":"a chaser that takes any action in half of the steps",hunter:"a chaser of the nearest adversary in view to which no teammate in view is nearer",surrounder:"\
a chaser of the nearest free cell beside an adversary without a teammate","clumsy-fleer":"a fleer that takes any action in half of the steps",dodger:"moves to w\
here all adversaries in view together are farthest"},$r={free:".GS",blocked:"#@OTW"};var le=1+Cr.length;function $e(t,e){return t.replace(/\{(\w+)\}/g,(r,n)=>String(e[n]))}function Ut(t,e){return t<e?$e(It[0],{number:t}):$e(It[1],{number:t-e})}function os(t,e){
let[r,n,o,s,a,i,l,...c]=Array.from(t),d=a<0?[s]:[s,a],[p,h,m]=c.map(w=>d.filter((A,y)=>w>>y&1)),g=d.map(w=>Ut(w,e)),f=$e(kr[a<0?"obstacle":Lt[o]],{first:g[0],second:g[g.
length-1],cell:`(${i}, ${l})`}),b=$e(Rr,{event:f,outcome:ss(d.length,h,m,e)});return{kind:Ot[n],form:Lt[o],agents:d,cell:[i,l],at_fault:p,held:h,doomed:m,turn:r,
text:b}}function ss(t,e,r,n){if(t===2&&e.length===2)return Re["both held"];if(t===2&&r.length===2)return Re["both doomed"];let o=s=>a=>$e(Re[s],{agent:Ut(a,n)});
return[...e.map(o("held")),...r.map(o("doomed"))].join(", ")||Re.none}function Xe(t,e){let r=[];for(let n=0;n<t.length;n+=le)r.push(os(t.subarray(n+1,n+le),e));
return r}var D=class extends Error{name="EngineError"};function T(t,e,r){let n=typeof r=="string"?`'${r}'`:typeof r=="object"?JSON.stringify(r):String(r);return new D(`${t}\
: expected ${e}, got ${n}`)}var ce=class{bytes;constructor(e){this.bytes=e}},Or=0,Dt=[Uint8Array,Uint8Array,Int32Array,BigInt64Array,BigUint64Array,Float32Array,Float64Array],_r=4,Pr=4,as=new TextEncoder,
is=new TextDecoder;function ls(t){for(let e=Dt.length-1;e>Or;--e)if(t instanceof Dt[e])return e;throw new TypeError("array: expected a typed array of the engine\
's numbers, got another")}function Bt(t){return new Uint8Array(t.buffer,t.byteOffset,t.byteLength)}function cs(t){return as.encode(`${t}\0`)}var Ft=class{engine;addresses=[];constructor(e){
this.engine=e}copy(e){let r=this.engine._malloc(Math.max(e.length,1));if(r===0)throw new D("memory: expected room for the arguments, got none");return this.addresses.
push(r),this.engine.HEAPU8.set(e,r),r}text(e){return this.copy(cs(e))}arrays(e){let r=Object.entries(e),n=r.flatMap(([s,a])=>{let i=a instanceof ce,l=i?a.bytes:
a;return[this.text(s),i?Or:ls(l),l.length,this.copy(Bt(l))]}),o=this.copy(Bt(Int32Array.from(n)));return this.copy(Bt(Int32Array.of(r.length,o)))}free(){for(let e of this.
addresses)this.engine._free(e)}};function Lr(t,e){let r=t.HEAPU8;return is.decode(r.subarray(e,r.indexOf(0,e)))}function Je(t){let e=new Int32Array(t.HEAPU8.buffer),
r=t._last_outputs()/_r,n=e[r+1]/_r,o={};for(let s=n;s<n+e[r]*Pr;s+=Pr){let a=Dt[e[s+1]],i=e[s+2]*a.BYTES_PER_ELEMENT,l=e[s+3];o[Lr(t,e[s])]=new a(t.HEAPU8.slice(
l,l+i).buffer)}return o}function _e(t,e){let r=new Ft(t);try{let n=e(r);if(n===0)throw new D(Lr(t,t._last_error()));return n}finally{r.free()}}var us=2**31-1,ds=2n**64n-1n,ps=34028234663852886e22;function H(t,e){if(typeof e!="number"||!Number.isInteger(e)||Math.abs(e)>us)throw T(t,"an integer",e);return Int32Array.
of(e)}function Qe(t,e){if(typeof e!="boolean")throw T(t,"true or false",e);return new ce(Uint8Array.of(Number(e)))}function ee(t,e,r){let n=typeof e=="string"&&
Object.hasOwn(r,e)?r[e]:void 0;if(n===void 0)throw T(t,`one of ${Object.keys(r).join(", ")}`,e);return Int32Array.of(n)}function zt(t,e){if(typeof e!="number"||
!(Math.abs(e)<=ps))throw T(t,"a finite number",e);return e}function ue(t,e){let n=typeof e=="bigint"||typeof e=="number"&&Number.isSafeInteger(e)?BigInt(e):-1n;
if(n<0n||n>ds)throw T(t,"an integer from 0 to 2^64 - 1",e);return BigUint64Array.of(n)}function hs(t){return{"rules.interaction":ee("interaction",t.interaction,
Mr),"rules.obstacle":ee("obstacle",t.obstacle,ke),"rules.teammate":ee("teammate",t.teammate,ke),"rules.evader":ee("evader",t.evader,ke),"rules.pursuer":ee("purs\
uer",t.pursuer,ke),"rules.capture":ee("capture",t.capture,Er),"rules.captured_disappear":Qe("captured_disappear",t.captured_disappear)}}function Ir(t,e){let r=typeof e==
"number"?[e,e,e]:e;if(!Array.isArray(r)||r.length!==3)throw T(t,"1 or 3 numbers",e);return Float32Array.from(r,n=>zt(t,n))}function ms(t){let e=(r,n)=>Float32Array.
of(zt(r,t[r]),zt(n,t[n]));return{"rewards.capture":e("pursuer_capture","evader_capture"),"rewards.neighbor":e("pursuer_neighbor","evader_neighbor"),"rewards.ste\
p":e("pursuer_step","evader_step"),"rewards.pursuer_collide":Ir("pursuer_collide",t.pursuer_collide),"rewards.evader_collide":Ir("evader_collide",t.evader_collide),
"rewards.blame":ee("blame",t.blame,Tr),"rewards.capture_repeats":Qe("capture_repeats",t.capture_repeats)}}function Ur(t){if(t===void 0||typeof t=="number")return new Uint8Array(
0);if(t instanceof Uint8Array)return t;let{free:e,blocked:r}=$r;for(let[n,o]of t.entries()){if(o.length!==t[0]?.length)throw T(`map, row ${n}`,`${t[0]?.length} \
cells as in row 0`,o.length);let s=[...o].find(a=>!e.includes(a)&&!r.includes(a));if(s)throw T(`map, row ${n}`,`'${e}' (free) or '${r}' (obstacle)`,s)}return Uint8Array.
from([...t.join("")],n=>Number(r.includes(n)))}function Br(t,e){if(!Array.isArray(t))return;let r=[t.length,t[0]?.length??0];if(!(r[0]===e.rows&&r[1]===e.cols))
throw T("obstacle map",`shape (${e.rows}, ${e.cols}), the rows and cols`,r)}function et(t){Br(t.obstacles,t);let e=typeof t.obstacles=="number"?t.obstacles:0;return{
...hs(t.rules),...ms(t.rewards),rows:H("rows",t.rows),cols:H("cols",t.cols),n_pursuers:H("n_pursuers",t.n_pursuers),n_evaders:H("n_evaders",t.n_evaders),fov:H("\
fov",t.fov),diagonal:Qe("diagonal",t.diagonal),max_steps:H("max_steps",t.max_steps),density:Float64Array.of(e),map:Ur(t.obstacles)}}function Nr(t,e){return Int32Array.
from((e??[]).flat(),r=>H(t,r)[0])}function Dr(t,e){return Br(t.obstacles,e),{seed:ue("seed",t.seed??0n),episode:ue("episode",t.episode??0),pursuers:Nr("pursuers",
t.pursuers),evaders:Nr("evaders",t.evaders),map:Ur(t.obstacles)}}function tt(t){return{actions:Int32Array.from(t,e=>H("actions",e)[0])}}function de(t){if(typeof t==
"string"){if(!Object.hasOwn(Nt,t))throw T("policy",`one of ${Object.keys(Nt).join(", ")}`,t);return{script:new TextEncoder().encode(t)}}if(t.activation!=="relu"&&
t.activation!=="tanh")throw T("activation","'relu' or 'tanh'",t.activation);return{hidden:Int32Array.from(t.hidden,e=>H("hidden",e)[0]),activation:new TextEncoder().
encode(t.activation),sampled:Qe("sampled",t.sampled),genome:t.genome}}var fs=["first_turn","terminated","truncated"];function Fr(t){let e={...t};for(let r of fs)
e[r]=new ce(t[r]);return e}var rt=class{config;seed;episode;n_agents;statistics;positions;last_positions;alive;captured;ever_captured;actions;rewards;involved;fault;map;conflict_table;first_conflict;constructor(e,r,n,o){
this.config=e,this.seed=r,this.episode=n,this.n_agents=e.n_pursuers+e.n_evaders,this.statistics=zr(o,0),this.positions=o.positions,this.last_positions=o.last_positions,
this.alive=o.alive,this.captured=o.captured,this.ever_captured=o.ever_captured,this.actions=o.actions,this.rewards=o.rewards,this.involved=o.involved,this.fault=
o.fault,this.map=o.map,this.conflict_table=o.conflict_table,this.first_conflict=gs(this.conflict_table,this.length)}get length(){return this.actions.length/this.
n_agents}conflicts(e){this.check(e);let[r,n]=[this.first_conflict[e],this.first_conflict[e+1]],o=this.conflict_table.subarray(r*le,n*le);return Xe(o,this.config.
n_pursuers)}seek(e,r){this.check(r),(!(e.seed===this.seed&&e.episode===BigInt(this.episode))||e.turn!==0||e.steps>r)&&e.reset({seed:this.seed,episode:this.episode});
for(let o=e.steps;o<r;++o)e.step(this.actions.subarray(o*this.n_agents,(o+1)*this.n_agents))}check(e){if(!(Number.isInteger(e)&&e>=0&&e<=this.length))throw T("s\
tep",`0 to ${this.length}`,e)}};function gs(t,e){let r=new Int32Array(e+2);for(let n=0;n<t.length;n+=le)++r[t[n]+1];for(let n=1;n<r.length;++n)r[n]+=r[n-1];return r}
function zr(t,e){let r=t["statistics.length"].length,n=s=>{let a=t[`statistics.${s}`],i=a.length/r;return a.slice(e*i,(e+1)*i)},o=s=>Number(n(s)[0]);return{capture_rate:o(
"capture_rate"),ever_capture_rate:o("ever_capture_rate"),captured_fraction:o("captured_fraction"),length:o("length"),return:n("return"),survivors:n("survivors"),
overlap:n("overlap"),collisions:n("collisions"),faults:n("faults"),agent_steps:n("agent_steps")}}function Wr(t,e,r,n){let o=[et(r.config),de(r.pursuers),de(r.evaders),
n];return _e(t,s=>{let[a,i,l,c]=o.map(d=>s.arrays(d));return t[e](a,i,l,c)}),Je(t)}function Hr(t,e,r,n){let o={seed:ue("seed",r),episode:ue("episode",n)};return new rt(
e.config,r,n,Wr(t,"_play_match",e,o))}function jr(t,e,r,n){if(!Number.isInteger(n)||n<1)throw T("n_episodes","at least 1",n);let o={seed:ue("seed",r),n_episodes:Int32Array.
of(n)},s=Wr(t,"_play_rollout",e,o);return Array.from({length:n},(a,i)=>zr(s,i))}var Gr=new FinalizationRegistry(([t,e])=>t._world_free(e)),Pe=class{config;n_agents;n_actions;engine;at;freed=!1;constructor(e,r){this.engine=e,this.config=r,this.
n_agents=r.n_pursuers+r.n_evaders,this.n_actions=r.diagonal?9:5,this.at=_e(e,n=>e._world_new(n.arrays(et(r)))),Gr.register(this,[e,this.at],this)}free(){this.freed||
(this.freed=!0,Gr.unregister(this),this.engine._world_free(this.at))}reset(e={}){let r=Dr(e,this.config);this.call(n=>this.engine._world_reset(this.at,n.arrays(
r)))}step(e){let r=tt(e);this.call(n=>this.engine._world_step(this.at,n.arrays(r)))}playTurn(e){let r=tt(e);this.call(n=>this.engine._world_play_turn(this.at,n.
arrays(r)))}decide(e,r,n){let{n_pursuers:o}=this.config,s={pursuer:[0,o],evader:[o,this.n_agents]},[a,i]=typeof r=="string"?s[r]:r;if(n.length!==this.n_agents)throw T(
"actions",String(this.n_agents),n.length);let l=[de(e),tt(n)],{actions:c}=this.call(d=>this.engine._world_decide(this.at,d.arrays(l[0]),a,i,d.arrays(l[1])));return Uint8Array.
from(c)}get n_turns(){return this.turnNumbers()[1]}get turn(){return this.turnNumbers()[0]}get actors(){let[,,e,r]=this.turnNumbers();return[e,r]}turnNumbers(){
return this.call(()=>this.engine._world_turn(this.at)).turn}get steps(){return this.read("steps")[0]}get seed(){return this.read("seed")[0]}get episode(){return this.
read("episode")[0]}get over(){return this.read("terminated")[0]===1||this.read("truncated")[0]===1}read(e){return this.call(r=>this.engine._world_read(this.at,r.
text(e)))[e]}view(e){let r=3*this.config.fov**2;return this.read("views").slice(e*r,(e+1)*r)}map(){return this.read("state").slice(2*this.config.rows*this.config.
cols)}conflicts(){return Xe(this.conflictTable(),this.config.n_pursuers)}conflictTable(){return this.call(()=>this.engine._world_conflicts(this.at)).conflict_table}answer(e,r){
let n=de(e),{logits:o}=this.call(i=>this.engine._world_logits(this.at,i.arrays(n),r)),s=o,a=this.decide(e,[r,r+1],new Uint8Array(this.n_agents))[r];return{logits:s,
probabilities:ys(s),action:a}}snapshot(){return this.call(()=>this.engine._world_snapshot(this.at))}restore(e){let r=Fr(e);this.call(n=>this.engine._world_restore(
this.at,n.arrays(r)))}call(e){if(this.freed)throw T("world","one that is in use","one that was freed");return _e(this.engine,e),Je(this.engine)}};function ys(t){
let e=Math.max(...t),r=Array.from(t,o=>Math.exp(o-e)),n=r.reduce((o,s)=>o+s,0);return Float32Array.from(r,o=>o/n)}var Wt=class{compiled;constructor(e){this.compiled=e}world(e){return new Pe(this.compiled,e)}match(e,r,n,o,s=0){return Hr(this.compiled,{config:e,pursuers:r,evaders:n},
o,s)}rollout(e,r,n,o,s){return jr(this.compiled,{config:e,pursuers:r,evaders:n},o,s)}},Vr;function Kr(t=globalThis.matrixworldEngine){return Vr??=vs(t),Vr}async function vs(t){
if(!t)throw new Error("matrixworldEngine: expected the script engine.js before this one, got none");let e=Uint8Array.from(atob(t.binary),r=>r.charCodeAt(0));return new Wt(
await t({wasmBinary:e}))}var bs="http://www.w3.org/2000/svg";function u(t,e={},...r){return Yr(document.createElement(t),e,r)}function v(t,e={},...r){return Yr(document.createElementNS(
bs,t),e,r)}function Yr(t,e,r){for(let[n,o]of Object.entries(e))o==null||o===!1||(typeof o=="function"?t.addEventListener(n.slice(2),o):t.setAttribute(n,o===!0?"":
String(o)));return t.append(...r.filter(ws).map(n=>typeof n=="number"?String(n):n)),t}function ws(t){return t!=null&&t!==!1}var xs=matchMedia("(prefers-color-scheme: dark)");function Ss(){let t=document.documentElement.dataset.theme;return t?t==="dark":xs.matches}function Ht(){document.
documentElement.dataset.theme=Ss()?"light":"dark"}function qr(){return u("button",{type:"button",title:"Light or dark (D)","aria-label":"Light or dark",onclick:Ht},"◐")}var As=2n**64n-1n;function Oe(t,e,r){let n=new URLSearchParams(t.replace(/^#/,"")),o=(c,d,p)=>{let h=n.get(c)??"";return/^\d{1,9}$/.test(h)&&Number(h)<d?Number(
h):p},s=o("run",e.length,r.run),[a,i]=e[s].payoff.shape,l=n.get("seed")??"";return{run:s,pursuer:o("pursuers",a,Math.min(r.pursuer,a-1)),evader:o("evaders",i,Math.
min(r.evader,i-1)),episode:o("episode",1/0,r.episode),seed:/^\d{1,20}$/.test(l)&&BigInt(l)<=As?l:null,step:o("step",1/0,0)}}function Zr(t,e,r){let n="",o=()=>{let{
run:s,pursuer:a,evader:i,episode:l,seed:c}=e.selected,d={run:s,pursuers:a,evaders:i,episode:l,...c===null?{}:{seed:c},step:r.player.step};n=`#${Object.entries(d).
map(([p,h])=>`${p}=${h}`).join("&")}`;try{history.replaceState(null,"",n)}catch{}};e.on("match",o),r.player.addEventListener("state",()=>r.player.playing||o()),
r.player.addEventListener("step",()=>r.player.playing||o()),window.addEventListener("hashchange",()=>{if(location.hash===n)return;let{step:s,...a}=Oe(location.hash,
t,e.selected);e.select(a),r.goTo(s)})}var P=Uint8Array,pe=Uint16Array,Ms=Int32Array,Xr=new P([0,0,0,0,0,0,0,0,1,1,1,1,2,2,2,2,3,3,3,3,4,4,4,4,5,5,5,5,0,0,0,0]),Jr=new P([0,0,0,0,1,1,2,2,3,3,4,4,5,5,
6,6,7,7,8,8,9,9,10,10,11,11,12,12,13,13,0,0]),Es=new P([16,17,18,0,8,7,9,6,10,5,11,4,12,3,13,2,14,1,15]),Qr=function(t,e){for(var r=new pe(31),n=0;n<31;++n)r[n]=
e+=1<<t[n-1];for(var o=new Ms(r[30]),n=1;n<30;++n)for(var s=r[n];s<r[n+1];++s)o[s]=s-r[n]<<5|n;return{b:r,r:o}},en=Qr(Xr,2),tn=en.b,Ts=en.r;tn[28]=258,Ts[258]=28;
var rn=Qr(Jr,0),Cs=rn.b,dl=rn.r,Vt=new pe(32768);for(S=0;S<32768;++S)j=(S&43690)>>1|(S&21845)<<1,j=(j&52428)>>2|(j&13107)<<2,j=(j&61680)>>4|(j&3855)<<4,Vt[S]=((j&
65280)>>8|(j&255)<<8)>>1;var j,S,Le=(function(t,e,r){for(var n=t.length,o=0,s=new pe(e);o<n;++o)t[o]&&++s[t[o]-1];var a=new pe(e);for(o=1;o<e;++o)a[o]=a[o-1]+s[o-
1]<<1;var i;if(r){i=new pe(1<<e);var l=15-e;for(o=0;o<n;++o)if(t[o])for(var c=o<<4|t[o],d=e-t[o],p=a[t[o]-1]++<<d,h=p|(1<<d)-1;p<=h;++p)i[Vt[p]>>l]=c}else for(i=
new pe(n),o=0;o<n;++o)t[o]&&(i[o]=Vt[a[t[o]-1]++]>>15-t[o]);return i}),Ie=new P(288);for(S=0;S<144;++S)Ie[S]=8;var S;for(S=144;S<256;++S)Ie[S]=9;var S;for(S=256;S<
280;++S)Ie[S]=7;var S;for(S=280;S<288;++S)Ie[S]=8;var S,nn=new P(32);for(S=0;S<32;++S)nn[S]=5;var S;var ks=Le(Ie,9,1);var Rs=Le(nn,5,1),jt=function(t){for(var e=t[0],r=1;r<t.length;++r)t[r]>e&&(e=t[r]);return e},N=function(t,e,r){var n=e/8|0;return(t[n]|t[n+1]<<8)>>(e&7)&r},Gt=function(t,e){
var r=e/8|0;return(t[r]|t[r+1]<<8|t[r+2]<<16)>>(e&7)},$s=function(t){return(t+7)/8|0},_s=function(t,e,r){return(e==null||e<0)&&(e=0),(r==null||r>t.length)&&(r=t.
length),new P(t.subarray(e,r))};var Ps=["unexpected EOF","invalid block type","invalid length/literal","invalid distance","stream finished","no stream handler",,"no callback","invalid UTF-8 da\
ta","extra field too long","date not in range 1980-2099","filename too long","stream finishing","invalid zip data"],U=function(t,e,r){var n=new Error(e||Ps[t]);
if(n.code=t,Error.captureStackTrace&&Error.captureStackTrace(n,U),!r)throw n;return n},Os=function(t,e,r,n){var o=t.length,s=n?n.length:0;if(!o||e.f&&!e.l)return r||
new P(0);var a=!r,i=a||e.i!=2,l=e.i;a&&(r=new P(o*3));var c=function(xr){var Sr=r.length;if(xr>Sr){var Ar=new P(Math.max(Sr*2,xr));Ar.set(r),r=Ar}},d=e.f||0,p=e.
p||0,h=e.b||0,m=e.l,g=e.d,f=e.m,b=e.n,w=o*8;do{if(!m){d=N(t,p,1);var A=N(t,p+1,3);if(p+=3,A)if(A==1)m=ks,g=Rs,f=9,b=5;else if(A==2){var R=N(t,p,31)+257,Ee=N(t,p+
10,15)+4,mr=R+N(t,p+5,31)+1;p+=14;for(var Te=new P(mr),Rt=new P(19),_=0;_<Ee;++_)Rt[Es[_]]=N(t,p+_*3,7);p+=Ee*3;for(var fr=jt(Rt),Qo=(1<<fr)-1,es=Le(Rt,fr,1),_=0;_<
mr;){var gr=es[N(t,p,Qo)];p+=gr&15;var y=gr>>4;if(y<16)Te[_++]=y;else{var ae=0,Ze=0;for(y==16?(Ze=3+N(t,p,3),p+=2,ae=Te[_-1]):y==17?(Ze=3+N(t,p,7),p+=3):y==18&&
(Ze=11+N(t,p,127),p+=7);Ze--;)Te[_++]=ae}}var yr=Te.subarray(0,R),q=Te.subarray(R);f=jt(yr),b=jt(q),m=Le(yr,f,1),g=Le(q,b,1)}else U(1);else{var y=$s(p)+4,x=t[y-
4]|t[y-3]<<8,E=y+x;if(E>o){l&&U(0);break}i&&c(h+x),r.set(t.subarray(y,E),h),e.b=h+=x,e.p=p=E*8,e.f=d;continue}if(p>w){l&&U(0);break}}i&&c(h+131072);for(var ts=(1<<
f)-1,rs=(1<<b)-1,$t=p;;$t=p){var ae=m[Gt(t,p)&ts],ie=ae>>4;if(p+=ae&15,p>w){l&&U(0);break}if(ae||U(2),ie<256)r[h++]=ie;else if(ie==256){$t=p,m=null;break}else{var vr=ie-
254;if(ie>264){var _=ie-257,Ce=Xr[_];vr=N(t,p,(1<<Ce)-1)+tn[_],p+=Ce}var _t=g[Gt(t,p)&rs],Pt=_t>>4;_t||U(3),p+=_t&15;var q=Cs[Pt];if(Pt>3){var Ce=Jr[Pt];q+=Gt(t,
p)&(1<<Ce)-1,p+=Ce}if(p>w){l&&U(0);break}i&&c(h+131072);var br=h+vr;if(h<q){var wr=s-q,ns=Math.min(q,br);for(wr+h<0&&U(3);h<ns;++h)r[h]=n[wr+h]}for(;h<br;++h)r[h]=
r[h-q]}}e.l=m,e.p=$t,e.b=h,e.f=d,m&&(d=1,e.m=f,e.d=g,e.n=b)}while(!d);return h!=r.length&&a?_s(r,0,h):r.subarray(0,h)};var Ls=new P(0);var Is=function(t,e){return((t[0]&15)!=8||t[0]>>4>7||(t[0]<<8|t[1])%31)&&U(6,"invalid zlib data"),(t[1]>>5&1)==+!e&&U(6,"invalid zlib data: "+(t[1]&32?"need":"u\
nexpected")+" dictionary"),(t[1]>>3&4)+2};function on(t,e){return Os(t.subarray(Is(t,e&&e.dictionary),-4),{i:2},e&&e.out,e&&e.dictionary)}var Ns=typeof TextDecoder<"u"&&new TextDecoder,Us=0;try{Ns.decode(Ls,{stream:!0}),Us=1}catch{}var he=["pursuer","evader"];function an(){return JSON.parse(nt("data"))}function Ne(t,e,r){let[n,o]=[e-t.payoff.first[0],r-t.payoff.first[1]],s=t.payoff.capture_rate[n]?.[o];
return s===void 0?null:{rate:s,rates:t.payoff.capture_rates[n][o],lengths:t.payoff.lengths[n][o]}}function te(t,e,r){let{script:n,network:o,kept:s,genomes:a}=t.
teams[e];if(n!==null||o===null)return"";if(!s.includes(r))return`The page holds no genome of ${e}s ${r}: it would be too large. Choose a generation of ${s.join(
", ")}.`;let i=s.length*o.genome_size;return ln(a,o.genome_size).length===i?"":`The page is damaged: it does not hold the ${i} numbers of the ${e}s' genomes. Wr\
ite it again from its run.`}function G(t,e,r){let{script:n,network:o,kept:s,genomes:a}=t.teams[e];if(n!==null||o===null)return n??"random";let i=s.indexOf(r);if(i<
0)throw new RangeError(`${e}: expected a generation whose genome the page holds, got ${r}`);let l=o.genome_size,c=ln(a,l).subarray(i*l,(i+1)*l);return{hidden:o.
hidden,activation:o.activation,sampled:o.sampled,genome:c}}var Kt=4,sn=new Map;function ln(t,e){let r=sn.get(t);if(r)return r;let n=new Float32Array;try{let o=Ds(
Yt(t),e);o.every(Number.isFinite)&&(n=o)}catch(o){if(!(o instanceof DOMException||o instanceof RangeError||Bs(o)))throw o}return sn.set(t,n),n}var Bs=t=>t instanceof
Error&&"code"in t;function Ds(t,e){let r=on(t),n=r.length/Kt,o=new Uint8Array(r.length);for(let a=0;a<o.length;a++)o[a]=r[a%Kt*n+Math.floor(a/Kt)];let s=new Uint32Array(
o.buffer);for(let a=e;a<s.length;a++)s[a]^=s[a-e];return new Float32Array(o.buffer)}function Yt(t){let e=atob(nt(t)),r=new Uint8Array(e.length);for(let n=0;n<r.
length;n++)r[n]=e.charCodeAt(n);return r}function nt(t){return document.getElementById(t)?.textContent??""}var Fs={now:()=>performance.now(),request:t=>requestAnimationFrame(t),cancel:t=>cancelAnimationFrame(t)},Ue=[.5,1,2,4,8,16,32,64],me=0,qt=12,zs=2,V=class extends EventTarget{#e;#n;#o;#a;#r=0;#t=0;#i=!1;#u=null;#d=0;#c=[];glide=.28;constructor(e,r={}){
super(),this.#e=e,this.#n=r.speed??4,this.#a=r.still??!1,this.#o=r.clock??Fs}get step(){return this.#r}get time(){return this.#a?this.#r:this.#t}get arrived(){return this.#t===
this.#r}get playing(){return this.#i}get length(){return this.#e}set length(e){this.#e=e,this.#r>e&&this.jump(e),this.#p("state")}get marks(){return this.#c}set marks(e){
this.#c=e,this.#p("state")}get pace(){return this.#n||Math.max(zs,this.#e/qt)}get speed(){return this.#n}set speed(e){this.#n=e,this.#p("state")}changeSpeed(e){
let r=Ue.findIndex(n=>n>=this.pace);this.speed=Ue[Math.min(Ue.length-1,Math.max(0,r+e))]}play(){this.#i||!this.#e||(this.#r===this.#e&&this.jump(0),this.#i=!0,this.#p(
"state"),this.#s())}pause(){this.#i&&(this.#i=!1,this.#p("state"))}toggle(){this.#i?this.pause():this.play()}move(e){this.pause();let r=Math.min(this.#e,Math.max(
0,this.#r+e));Math.abs(r-this.#t)>1?this.jump(r):this.#l(r),this.#s()}jump(e){this.#t=Math.min(this.#e,Math.max(0,Math.round(e))),this.#l(this.#t),this.#p("fram\
e")}#l(e){e!==this.#r&&(this.#r=e,this.#p("step"),this.#a&&this.#p("frame"))}#s(){this.#u===null&&(this.#d=this.#o.now(),this.#u=this.#o.request(()=>this.#m()))}#m(){
this.#u=null;let e=this.#o.now();this.#h(Math.min(.25,(e-this.#d)/1e3)),this.#d=e,(!this.#a||this.arrived)&&this.#p("frame"),(this.#i||this.#t!==this.#r)&&(this.#u=
this.#o.request(()=>this.#m()))}#h(e){let r=e;for(;r>0;){if(this.#t===this.#r){if(!this.#i)return;if(this.#r===this.#e)return this.pause();this.#l(this.#r+1)}let n=this.#i?
this.pace:1/this.glide,o=this.#r-this.#t,s=Math.min(Math.abs(o),r*n);r-=s/n,this.#t=s===Math.abs(o)?this.#r:this.#t+Math.sign(o)*s}this.#i&&this.#t===this.#e&&this.
pause()}#p(e){this.dispatchEvent(new Event(e))}};function Z(t,e){if(e.ctrlKey||e.metaKey||e.altKey)return!1;let r=e.shiftKey?10:1,o={" ":()=>t.toggle(),ArrowRight:()=>t.
move(r),ArrowLeft:()=>t.move(-r),Home:()=>t.move(-t.length),End:()=>t.move(t.length),"+":()=>t.changeSpeed(1),"-":()=>t.changeSpeed(-1)}[e.key];return o?.(),o!==
void 0}var Be=[[68,1,84],[72,26,108],[71,47,125],[65,68,135],[57,86,140],[49,104,142],[42,120,142],[35,136,142],[31,152,139],[34,168,132],[53,183,121],[84,197,104],[122,
209,81],[165,219,54],[210,226,27],[253,231,37]];function fe(t){let e=Math.min(1,Math.max(0,t))*(Be.length-1),r=Math.min(Be.length-2,Math.floor(e)),[n,o]=[Be[r],
Be[r+1]],s=a=>Math.round(n[a]+(e-r)*(o[a]-n[a]));return[s(0),s(1),s(2)]}function cn(t){let[e,r,n]=fe(t).map(o=>((o/255+.055)/1.055)**2.4);return .2126*e+.7152*r+
.0722*n>.179?"#000":"#fff"}var un=t=>`rgb(${fe(t).join(" ")})`,dn=()=>`linear-gradient(to right, ${Be.map(t=>`rgb(${t.join(" ")})`).join(", ")})`;function ot(t,e,r){let n=devicePixelRatio||1;t.style.left=`${r.left}px`,t.style.top=`${r.top}px`,t.style.width=`${r.width}px`,t.style.height=`${r.height}px`,t.width=
Math.round(r.width*n),t.height=Math.round(r.height*n);let o=t.getContext("2d"),s=Ws(e);!o||!s||(o.imageSmoothingEnabled=!1,o.drawImage(s,0,0,t.width,t.height))}
function Ws(t){let[e,r]=t.shape,n=document.createElement("canvas");[n.width,n.height]=[r,e];let o=n.getContext("2d");if(!o)return null;let s=o.createImageData(r,
e);return t.capture_rate.forEach((a,i)=>a.forEach((l,c)=>{let d=4*((e-1-i-t.first[0])*r+c+t.first[1]);s.data.set([...fe(l),255],d)})),o.putImageData(s,0,0),n}var Hs=84;function pn(t,e){let r=t.map((s,a)=>js(s,a,e)),n=u("nav",{class:"races","aria-label":"Runs"},...r.map(s=>s.button)),o=()=>r.forEach((s,a)=>s.update(a===
e.selected.run));return e.on("match",o),e.on("hover",o),o(),n.hidden=t.length<2,n}function js(t,e,r){let[n,o]=t.payoff.shape,s=!t.name.startsWith(t.schedule),a=Hs/
Math.max(n,o),i=u("canvas",{"aria-hidden":"true"});ot(i,t.payoff,{left:0,top:0,width:o*a,height:n*a});let l=u("span",{class:"place"}),c=u("button",{type:"button",
class:"race",title:`${t.name} (key ${e+1})`,onclick:()=>Zt(t,e,r)},u("span",{class:"small-matrix"},i,l),u("span",{class:"race-text"},u("strong",{},s?t.name:t.schedule),
u("span",{class:"small"},t.findings?t.findings.headline:`${t.learning.join(" and ")}s against ${Gs(t)}`),u("span",{class:"small muted"},`${s?`${t.schedule}, `:""}\
seed ${t.seed}`)));return{button:c,update:p=>{c.setAttribute("aria-current",String(p));let h=r.hover.pursuer??r.selected.pursuer,m=r.hover.evader??r.selected.evader;
l.hidden=h>=n||m>=o,l.style.left=`${(m+.5)*a}px`,l.style.top=`${(n-h-.5)*a}px`}}}var Gs=t=>t.teams.pursuer.script??t.teams.evader.script??"another run";function Zt(t,e,r){
let[n,o]=t.payoff.shape,{pursuer:s,evader:a}=r.selected;r.select({run:e,pursuer:Math.min(s,n-1),evader:Math.min(a,o-1)})}var Vs=[[["Space"],"play or pause"],[["←","→"],"step back or forward; with Shift ten steps"],[["Home","End"],"first or last step"],[["+","−"],"faster or s\
lower"],[["N"],"next episode of the same pair; with Shift the one before"],[["R"],"another seed, not one of the evaluation"],[["O"],"the cell's own seed again"],
[["P"],"next pursuer generation; with Shift the one before"],[["E"],"next evader generation; with Shift the one before"],[["M"],"to the matrix: arrow keys choos\
e a match, Enter plays it"],[["A"],"next agent: what it sees; with Shift the one before"],[["Esc"],"no agent"],[["T"],"take over the chosen agent, or an evader,\
 from this step on"],[["G"],"this step in the playground: any other rules, actions and places"],[["1","9"],"first to ninth run"],[["D"],"light or dark"],[["?"],
"this list"]];function hn(){let t=Vs.map(([r,n])=>u("div",{class:"key-row"},u("dt",{},...r.map(o=>u("kbd",{},o))),u("dd",{},n))),e=u("dialog",{class:"help","ari\
a-labelledby":"help-title"},u("h2",{id:"help-title"},"Keys"),u("dl",{class:"keys"},...t),u("p",{class:"muted small"},"The page holds the genomes and the engine \
of this run. A click on a cell plays that very match: same seed, same moves. The page loads nothing from elsewhere; share the file as it is."),u("button",{type:"\
button",onclick:()=>e.close()},"Close"));return e.addEventListener("click",r=>r.target===e&&e.close()),e}function mn(t,e,r,n,o,s){let a=(l,c)=>()=>{let d=t[e.selected.
run].payoff.shape[l==="pursuer"?0:1];e.select({[l]:Math.min(d-1,Math.max(0,e.selected[l]+c))})},i={n:()=>e.select({episode:e.selected.episode+1}),N:()=>e.select(
{episode:Math.max(0,e.selected.episode-1)}),r:()=>e.select({seed:String(crypto.getRandomValues(new BigUint64Array(1))[0]),episode:0}),o:()=>e.select({seed:null,
episode:0}),p:a("pursuer",1),P:a("pursuer",-1),e:a("evader",1),E:a("evader",-1),m:()=>document.getElementById("matrix")?.focus(),a:()=>r.inspector.next(1),A:()=>r.
inspector.next(-1),Escape:()=>r.inspector.choose(null),t:o,g:s,d:Ht,"?":()=>n.showModal()};document.addEventListener("keydown",l=>{let c=l.target instanceof HTMLSelectElement||
l.target instanceof HTMLInputElement,d=l.target instanceof HTMLButtonElement&&(l.key===" "||l.key==="Enter");if(document.querySelector("dialog[open]")||c||d||l.
defaultPrevented||l.ctrlKey||l.metaKey||l.altKey)return;let p=i[l.key]??i[l.key.toLowerCase()],h=Number(l.key)-1;if(Z(r.player,l)||p)p?.();else if(t[h])Zt(t[h],
h,e);else return;l.preventDefault()})}var ge=[[0,0],[-1,0],[0,1],[1,0],[0,-1],[-1,1],[1,1],[1,-1],[-1,-1]];function fn(t,e,r){let[n,o]=[e[0]-t[0],e[1]-t[1]];return!r&&Math.abs(n)>Math.abs(o)?o=0:r||
(n=0),ge.findIndex(([s,a])=>s===Math.sign(n)&&a===Math.sign(o))}var re=(t,e)=>e<t.nPursuers,M=(t,e)=>[t.positions[2*e],t.positions[2*e+1]],Ks=(t,e)=>t[0]===e[0]&&
t[1]===e[1],Xt=({rows:t,cols:e},[r,n])=>r>=0&&n>=0&&r<t&&n<e,Jt=(t,e,r=3)=>t!==void 0&&[0,1,2].slice(0,r).some(n=>t[3*e+n]),Qt=(t,e)=>Jt(t.fault,e),gn=(t,e)=>!Qt(
t,e)&&Jt(t.involved,e,2);function st(t,e,r){let n=!Ks(M(t,r),M(e,r)),o=e.involved===void 0||Jt(e.involved,r);return!!(e.alive[r]&&e.actions?.[r]&&!n&&o)}function at(t,e,r){
let[n,o]=M(t,r),[s,a]=ge[e.actions?.[r]??0];return[n+s,o+a]}function De(t,e,r){return Array.from({length:r.everCaptured.length},(o,s)=>s).filter(o=>r.everCaptured[o]&&
!e.everCaptured[o]).map(o=>t.nPursuers+o)}var yn=t=>t.moments.flatMap((e,r)=>r&&De(t,t.moments[r-1],e).length?[r]:[]);function it(t,e){return Array.from({length:e.
alive.length},(n,o)=>o).filter(n=>t.alive[n]&&!e.alive[n])}var vn=[-.31,0,.31],bn=[{size:1,at:[[0,0]]},{size:.62,at:[[-.2,.2],[.2,-.2]]},{size:.54,at:[[-.23,.22],[.23,.22],[0,-.22]]},{size:.54,at:[[-.23,.23],[.23,.23],[
-.23,-.23],[.23,-.23]]},{size:.36,at:vn.flatMap(t=>vn.map(e=>[e,t]))}],Ys=.3,qs=.35,Zs=.55;function Fe(t,e){let r=new Map;for(let n=0;n<e.alive.length;n++){if(!e.
alive[n])continue;let[o,s]=M(e,n),a=o*t.cols+s,i=r.get(a);i?i.push(n):r.set(a,[n])}return r}function wn(t,e){let r=Array.from(e.alive,(n,o)=>{let[s,a]=M(e,o);return{
x:a+.5,y:s+.5,size:1,alpha:0}});for(let n of Fe(t,e).values()){let o=bn[Math.min(n.length,bn.length)-1];n.forEach((s,a)=>{let[i,l]=o.at[Math.min(a,o.at.length-1)],
c=r[s];c.x+=i,c.y+=l,c.size=o.size,c.alpha=1})}return r}var xn=t=>t*t*(3-2*t),ye=(t,e,r)=>t+(e-t)*r,Sn=t=>Math.min(1,Math.max(0,t));function An(t,e,r,n){let o={
1:2,2:r}[t.interaction]??1;if(o===1)return xn(n);let s=o===r?e:+!re(t,e),a=Math.max(1/o,qs);return xn(Sn((n-s/(o-1)*(1-a))/a))}function lt(t,e){let r=t.moments.
length-1,n=Math.min(Math.floor(e),r),o=t.moments[n],s=wn(t,o);if(n===r||e===n)return s;let a=t.moments[n+1],i=wn(t,a);return s.map((l,c)=>{let d=An(t,c,s.length,
e-n);return Xs(o,a,c,l,i[c],d)})}function rr(t,e,r){let n=t.moments.length-1,o=Math.min(Math.floor(r),n),[s,a]=[t.moments[o],t.moments[Math.min(o+1,n)]],i=An(t,
e,s.alive.length,r-o),[[l,c],[d,p]]=[M(s,e),M(a,e)];return[ye(c,p,i)+.5,ye(l,d,i)+.5]}function Xs(t,e,r,n,o,s){let a=n.alpha>o.alpha,i={x:ye(n.x,o.x,s),y:ye(n.y,
o.y,s),size:a?n.size:ye(n.size,o.size,s),alpha:a?Sn((1-s)/(1-Zs)):ye(n.alpha,o.alpha,s)};if(st(t,e,r)){let[l,c]=M(t,r),[d,p]=at(t,e,r),h=Ys*Math.sin(Math.PI*s);
i.x+=(p-c)*h,i.y+=(d-l)*h}return i}var Mn=2*Math.PI;function ne(t,e,r,n){t.beginPath(),t.arc(e,r,n/2,0,Mn)}function ct(t,e,r,n){let o=n/2,s=[[0,-.97],[.97,.83],[-.97,.83]].map(([a,i])=>[e+a*o,r+i*
o]);t.beginPath(),t.moveTo((s[2][0]+s[0][0])/2,(s[2][1]+s[0][1])/2),s.forEach(([a,i],l)=>{let[c,d]=s[(l+1)%3];t.arcTo(a,i,c,d,n*.09)}),t.closePath()}function En(t,e,r,n){
let o=n*.32;t.beginPath(),t.moveTo(e-o,r-o),t.lineTo(e+o,r+o),t.moveTo(e+o,r-o),t.lineTo(e-o,r+o)}function Tn(t,e,r,n){t.beginPath();for(let o=0;o<16;o++){let s=n/
2*(o%2?.6:.95),a=Mn*o/16;t.lineTo(e+s*Math.sin(a),r-s*Math.cos(a))}t.closePath()}function Cn(t,e,r,n,o,s){let a=Math.atan2(o-r,n-e);t.beginPath(),t.moveTo(e,r),
t.lineTo(n,o);for(let i of[-1,1])t.moveTo(n,o),t.lineTo(n-s*Math.cos(a+i*.6),o-s*Math.sin(a+i*.6))}var kn=4,Js=1.6,Qs=.95,ea=5,ta=.16,ra=9,na=.09,oa=.2,Rn=.75,O=(t,e)=>t.left+e*t.cell,L=(t,e)=>t.top+e*t.cell;function ve(t,e,r){return re(e,r)?t.colors.pursuer:
t.colors.evader}function $n({ctx:t,grid:e,colors:r}){let{left:n,top:o,cell:s,rows:a,cols:i}=e,[l,c]=[i*s,a*s];if(t.fillStyle=r.paper,t.fillRect(n,o,l,c),s<ea)return;
t.fillStyle=r.line;let d=Math.max(1,Math.round(s/60));for(let p=1;p<i;p++)t.fillRect(n+p*s,o,d,c);for(let p=1;p<a;p++)t.fillRect(n,o+p*s,l,d)}function _n({ctx:t,
grid:e,colors:r},n){let{left:o,top:s,cell:a,rows:i,cols:l}=e;t.fillStyle=r.obstacle;for(let d=0;d<i*l;d++){if(!n.obstacles[d])continue;let[p,h]=[Math.floor(d/l),
d%l];t.fillRect(o+h*a,s+p*a,a,a)}let c=Math.min(5,Math.max(2,Math.round(a/18)));t.strokeStyle=r.frame,t.lineWidth=c,t.strokeRect(o-c/2,s-c/2,l*a+c,i*a+c)}function Pn({
ctx:t,grid:e,colors:r},n){let{left:o,top:s,cell:a,rows:i,cols:l}=e,c=a<24*n?5:1;t.font=`500 ${Math.round(Math.min(15*n,Math.max(9*n,a*.32)))}px system-ui, sans-\
serif`,t.fillStyle=r.muted,t.textBaseline="alphabetic",t.textAlign="center";let d=5*n+a/40;for(let p=0;p<l;p+=c)t.fillText(String(p),o+(p+.5)*a,s-d);t.textAlign=
"right",t.textBaseline="middle";for(let p=0;p<i;p+=c)t.fillText(String(p),o-d,s+(p+.5)*a)}function On({grid:t},e,r,n){let o=Math.floor(e.fov/2)+.5,[s,a]=[Math.max(
0,r-o),Math.min(t.cols,r+o)],[i,l]=[Math.max(0,n-o),Math.min(t.rows,n+o)];return[O(t,s),L(t,i),(a-s)*t.cell,(l-i)*t.cell]}function Ln(t,e,r,n){let{ctx:o,grid:s,
colors:a}=t;o.beginPath(),o.rect(0,0,o.canvas.width,o.canvas.height),o.rect(...On(t,e,r,n)),o.save(),o.clip("evenodd"),o.fillStyle=a.line,o.fillRect(s.left,s.top,
s.cols*s.cell,s.rows*s.cell),o.restore()}function In({ctx:t,grid:e,colors:r},{x:n,y:o,alpha:s},a){let i=Math.max(e.cell,16*a)*1.06,[l,c]=[O(e,n),L(e,o)];t.globalAlpha=
Math.max(s,.6),t.beginPath(),t.roundRect(l-i/2,c-i/2,i,i,i*.2),t.strokeStyle=r.focus,t.lineWidth=Math.max(2,2.5*a),t.stroke();let d=Math.max(11*a,Math.min(18*a,
e.cell*.5));t.font=`700 ${Math.round(d)}px system-ui, sans-serif`,t.textAlign="center",t.textBaseline="middle";let p=c-i/2<d*1.2,h=c+(p?1:-1)*(i/2+d*.7);t.strokeStyle=
r.paper,t.lineJoin="round",t.lineWidth=d*.35,t.strokeText("You",l,h),t.fillStyle=r.ink,t.fillText("You",l,h),t.globalAlpha=1}function Nn(t,e,r,n,o){let{ctx:s,grid:a}=t,
i=On(t,e,n,o),l=ve(t,e,r);s.globalAlpha=.11,s.fillStyle=l,s.fillRect(...i),s.globalAlpha=.8,s.strokeStyle=l,s.lineWidth=Math.max(1,a.cell/24),s.strokeRect(...i),
s.globalAlpha=1}function Un(t,e,r,n,o){let{ctx:s,grid:a}=t,i=Math.min(Math.ceil(r),e.moments.length-1),l=e.moments[i];s.lineCap="round",s.lineWidth=Math.min(ra,
Math.max(1,a.cell*ta));for(let c=Math.max(1,Math.floor(r-n)+1);c<=i;c++){let[d,p]=[e.moments[c-1],e.moments[c]],h=Math.max(0,Math.min(1,(r-c)/n));s.globalAlpha=
Rn+(oa-Rn)*h;for(let m=0;m<p.alive.length;m++){let g=c===i&&r<i;if(!d.alive[m]||!(l.alive[m]||g))continue;let f=(re(e,m)?-1:1)*na,[b,w]=M(d,m),[A,y]=M(p,m);if(b===
A&&w===y)continue;let x=g?o[m].x:y+.5,E=g?o[m].y:A+.5;s.strokeStyle=ve(t,e,m),s.beginPath(),s.moveTo(O(a,w+.5+f),L(a,b+.5+f)),s.lineTo(O(a,x+f),L(a,E+f)),s.stroke()}}
s.globalAlpha=1}function Bn(t,e,r){let n=Math.min(Math.ceil(r),e.moments.length-1);for(let o=Math.max(1,n-kn+1);o<=n;o++){let[s,a]=[e.moments[o-1],e.moments[o]],
i=o>r?Math.max(0,1-2*(o-r)):1-(r-o)/kn,l=De(e,s,a);for(let c of it(s,a))l.includes(c)||aa(t,M(a,c),i);for(let c of l)sa(t,M(a,c),i)}t.ctx.globalAlpha=1}function sa({
ctx:t,grid:e,colors:r},[n,o],s){t.globalAlpha=s,Tn(t,O(e,o+.5),L(e,n+.5),Math.max(8,e.cell*Js)),t.fillStyle=r.capture,t.fill(),t.strokeStyle=r.ink,t.lineWidth=Math.
max(1,e.cell/36),t.lineJoin="round",t.stroke()}function aa({ctx:t,grid:e,colors:r},[n,o],s){t.globalAlpha=s,En(t,O(e,o+.5),L(e,n+.5),Math.max(7,e.cell*Qs)),t.strokeStyle=
r.collision,t.lineWidth=Math.max(2,e.cell*.17),t.lineCap="round",t.stroke()}function Dn({ctx:t,grid:e,colors:r},n,o){let s=Math.max(1,e.cell*.07);t.strokeStyle=
t.fillStyle=r.collision,t.lineWidth=Math.max(1,e.cell*.05),t.setLineDash([e.cell*.14,e.cell*.1]);for(let[a,i]of n){if(a<0||i<0||a>=e.rows||i>=e.cols)continue;let l=[
O(e,i)+s,L(e,a)+s,e.cell-2*s,e.cell-2*s];t.globalAlpha=.2*o,t.fillRect(...l),t.globalAlpha=o,t.strokeRect(...l)}t.setLineDash([]),t.globalAlpha=1}function Fn({ctx:t,
grid:e,colors:r},n,o,s,a){t.globalAlpha=a,ne(t,O(e,n),L(e,o),Math.max(8,e.cell*s*1.02)),t.strokeStyle=r.collision,t.lineWidth=Math.max(1.5,e.cell*.085*Math.sqrt(
s)),t.stroke(),t.globalAlpha=1}var ia=.8,la=.92,ca=15,ua=7,nr=9;function zn(t,e,r,n,o,s){n.forEach((a,i)=>{a.alpha>0&&da(t,e,r,i,a,o,s)}),t.ctx.globalAlpha=1;for(let a of Fe(e,r).values())a.length>
nr&&pa(t,n[a[nr-1]],a.length-nr+1)}function da(t,e,r,n,o,s,a){let{ctx:i,grid:l,colors:c}=t,d=re(e,n),[p,h]=[l.left+o.x*l.cell,l.top+o.y*l.cell],m=Math.max(4,l.cell*
o.size*(d?la:ia)),g=ve(t,e,n),f=!d&&!!r.captured[n-e.nPursuers];if(i.globalAlpha=o.alpha,(d?ct:ne)(i,p,h,m),m>ua*a&&(i.strokeStyle=c.paper,i.lineWidth=Math.max(
2,m*.1),i.stroke()),i.fillStyle=f?c.paper:g,i.fill(),f&&(ne(i,p,h,m*.82),i.strokeStyle=g,i.lineWidth=m*.18,i.stroke()),!s||m<ca*a)return;let b=String(d?n:n-e.nPursuers);
i.font=`700 ${Math.round(m*(d?.4:.5)*(b.length>1?.8:1))}px system-ui, sans-serif`,i.textAlign="center",i.textBaseline="middle",i.fillStyle=f?g:c.paper,i.fillText(
b,p,h+m*(d?.17:.03))}function pa({ctx:t,grid:e,colors:r},n,o){let[s,a]=[e.left+n.x*e.cell,e.top+n.y*e.cell];t.font=`700 ${Math.round(e.cell*.3)}px system-ui, sa\
ns-serif`,t.textAlign="center",t.textBaseline="middle",t.strokeStyle=r.paper,t.lineWidth=e.cell*.1,t.strokeText(`+${o}`,s,a),t.fillStyle=r.ink,t.fillText(`+${o}`,
s,a)}var ha=.46,ma=.86,fa=.66,Wn=.48,ga=.78,ya=.58;function Hn(t,e,r,n){let[o,s]=[e.moments[r-1],e.moments[r]];if(!o)return;let{ctx:a,grid:i,colors:l}=t;a.strokeStyle=
l.collision,a.lineWidth=Math.max(1.5,i.cell*.07),a.lineCap="butt",a.globalAlpha=n;for(let c=0;c<s.alive.length;c++)st(o,s,c)&&va(t,e,M(o,c),at(o,s,c));a.globalAlpha=
1}function va({ctx:t,grid:e},r,n,o){let[s,a]=[o[1]-n[1],o[0]-n[0]],i=p=>O(e,n[1]+.5+s*p),l=p=>L(e,n[0]+.5+a*p),c=Xt(r,o)?ga:ya;t.setLineDash([e.cell*.09,e.cell*
.06]),t.beginPath(),t.moveTo(i(Wn),l(Wn)),t.lineTo(i(c),l(c)),t.stroke(),t.setLineDash([]);let d=.17*e.cell/Math.hypot(s,a);t.beginPath(),t.moveTo(i(c)-a*d,l(c)+
s*d),t.lineTo(i(c)+a*d,l(c)-s*d),t.stroke()}function jn(t,e,r,n,o,s){let a=ge[s];if(!s||!a)return;let{ctx:i,grid:l,colors:c}=t,d=Xt(e,[n[0]+a[0],n[1]+a[1]])?ma:
fa,p=ha*o.size,h=[O(l,o.x+a[1]*p),L(l,o.y+a[0]*p),O(l,o.x+a[1]*d),L(l,o.y+a[0]*d)],m=Math.max(1.5,l.cell*.085);i.lineCap=i.lineJoin="round";for(let[g,f]of[[c.paper,
m*2.1],[ve(t,e,r),m]])i.strokeStyle=g,i.lineWidth=f,Cn(i,...h,l.cell*.2),i.stroke()}var Vn={numbers:!0,axes:!1,trail:6,viewers:[],plan:null,selected:null,cursor:null,you:null,fog:!1};function Kn(t,e,r,n,o){let{ctx:s,grid:a,colors:i}=t,l=Math.min(
Math.ceil(r),e.moments.length-1),c=e.moments[l],d=r===l,p=lt(e,r),h=d?1:Math.max(0,1-2*(l-r));s.clearRect(0,0,s.canvas.width,s.canvas.height),$n(t);for(let f of n.
viewers)p[f]?.alpha&&Nn(t,e,f,...rr(e,f,r));_n(t,e),n.axes&&Pn(t,o),Un(t,e,r,n.trail,p),Dn(t,c.contested??[],h),Bn(t,e,r),Hn(t,e,l,h),p.forEach(({x:f,y:b,size:w},A)=>{
let y=gn(c,A)?.4:0,x=Qt(c,A)?1:y;x&&Fn(t,f,b,w,x*h)});let m=d?c:e.moments[Math.max(0,l-1)];if(zn(t,e,m,p,n.numbers,o),d&&n.plan)for(let[f,b]of p.entries())b.alpha&&
jn(t,e,f,M(c,f),b,n.plan[f]??0);n.you!==null&&(n.fog&&Ln(t,e,...rr(e,n.you,r)),In(t,p[n.you],o)),s.lineWidth=Math.max(2,2.5*o),s.strokeStyle=i.focus;let g=n.selected===
null?void 0:p[n.selected];g?.alpha&&Gn(t,g.x,g.y,g.size*.96),n.cursor&&(s.setLineDash([a.cell*.12,a.cell*.08]),Gn(t,n.cursor[1]+.5,n.cursor[0]+.5,.8),s.setLineDash(
[]))}function Gn({ctx:t,grid:e},r,n,o){let s=o*e.cell;t.beginPath(),t.roundRect(e.left+r*e.cell-s/2,e.top+n*e.cell-s/2,s,s,s*.1),t.stroke()}var Yn=(t,e)=>(e+.24)/(t+.24);function qn(t,e,r,n,o,s){let a=r?28*s:0,i=(c,d)=>(c-a)/(d+2*.12),l=Math.max(1,Math.floor(Math.min(i(n,e),i(o,t))));return{rows:t,cols:e,
cell:l,left:Math.round((n-e*l+a)/2),top:Math.round((o-t*l+a)/2)}}function Zn(t,e,r){let n=Math.floor((r-t.top)/t.cell),o=Math.floor((e-t.left)/t.cell);return n>=
0&&n<t.rows&&o>=0&&o<t.cols?[n,o]:null}var ba={paper:"--board-paper",line:"--board-line",frame:"--board-frame",ink:"--board-ink",muted:"--board-muted",obstacle:"--board-obstacle",pursuer:"--pursuer",
evader:"--evader",capture:"--capture",collision:"--collision",focus:"--focus"};function ut(t){let e=getComputedStyle(t),r=Object.entries(ba).map(([n,o])=>[n,e.getPropertyValue(
o).trim()]);return Object.fromEntries(r)}var F=()=>matchMedia("(prefers-reduced-motion: reduce)").matches,X=class{canvas;#e=null;#n=0;#o;#a={rows:1,cols:1,left:0,top:0,cell:1};#r=0;#t;#i;constructor(e,r={}){
this.canvas=e,e.classList.add("board"),e.setAttribute("role","img"),this.#o={...Vn,...r},this.#t=new ResizeObserver(()=>this.#d()),this.#t.observe(e),this.#i=new MutationObserver(
()=>this.redraw()),this.#i.observe(document.documentElement,{attributes:!0}),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",this.redraw)}close(){
this.#t.disconnect(),this.#i.disconnect(),matchMedia("(prefers-color-scheme: dark)").removeEventListener("change",this.redraw),cancelAnimationFrame(this.#r)}get look(){
return this.#o}set look(e){this.#o={...this.#o,...e},this.#u(),this.redraw()}get time(){return this.#n}show(e,r){this.#e=e,this.#n=Math.min(Math.max(0,r),e.moments.
length-1),this.#u(),this.redraw()}redraw=()=>{this.#r||(this.#r=requestAnimationFrame(()=>this.drawNow()))};drawNow(){cancelAnimationFrame(this.#r),this.#r=0;let e=this.
canvas.getContext("2d");if(!e||!this.#e)return;let{rows:r,cols:n}=this.#e,o=devicePixelRatio||1;this.#a=qn(r,n,this.#o.axes,this.canvas.width,this.canvas.height,
o);let s={ctx:e,grid:this.#a,colors:ut(this.canvas)};Kn(s,this.#e,this.#n,this.#o,o)}cellAt(e,r){let n=this.canvas.getBoundingClientRect(),o=this.canvas.width/n.
width;return Zn(this.#a,(e-n.left)*o,(r-n.top)*o)}agentAt(e,r){let n=this.cellAt(e,r);if(!n||!this.#e)return null;let o=this.#e.moments[Math.round(this.#n)],s=Fe(
this.#e,o).get(n[0]*this.#e.cols+n[1])??[],a=lt(this.#e,Math.round(this.#n)),i=l=>{let[c,d]=this.pointOf(a[l].x,a[l].y);return Math.hypot(c-e,d-r)};return s.length?
s.reduce((l,c)=>i(c)<i(l)?c:l):null}pointOf(e,r){let n=this.canvas.getBoundingClientRect(),o=n.width/this.canvas.width,{left:s,top:a,cell:i}=this.#a;return[n.left+
(s+e*i)*o,n.top+(a+r*i)*o]}#u(){if(!this.#e)return;let{rows:e,cols:r}=this.#e;this.canvas.style.setProperty("--board-aspect",String(Yn(e,r)))}#d(){let e=devicePixelRatio||
1,{width:r,height:n}=this.canvas.getBoundingClientRect();this.canvas.width=Math.max(1,Math.round(r*e)),this.canvas.height=Math.max(1,Math.round(n*e)),this.drawNow()}};var xa={SIMULTANEOUS:0,SWARM_TURNS:1,AGENT_TURNS:2};function dt(t,e,r){return{rows:t.rows,cols:t.cols,nPursuers:t.n_pursuers,fov:t.fov,interaction:xa[t.rules.interaction],
obstacles:e,moments:r}}function pt(t,e){return{positions:t.read("last_positions"),alive:t.read("alive"),captured:t.read("captured"),everCaptured:t.read("ever_ca\
ptured"),actions:e,involved:t.read("involved"),fault:t.read("fault"),contested:t.conflicts().map(r=>r.cell)}}function ht(t){let e=Array.from({length:t.length+1},
(r,n)=>Sa(t,n));return dt(t.config,t.map,e)}function Sa(t,e){let r=t.n_agents,n=t.config.n_evaders,o=(a,i,l)=>a.subarray(i*l,(i+1)*l),s={positions:o(t.last_positions,
e,2*r),alive:o(t.alive,e,r),captured:o(t.captured,e,n),everCaptured:o(t.ever_captured,e,n)};return e===0?s:{...s,actions:o(t.actions,e-1,r),involved:o(t.involved,
e-1,3*r),fault:o(t.fault,e-1,3*r),get contested(){return t.conflicts(e).map(a=>a.cell)}}}var Aa=Array.from({length:16},(t,e)=>{let[r,n]=[e%2?6.5:11,Math.PI*e/8];return`${12+r*Math.sin(n)} ${12-r*Math.cos(n)}`}).join(" ");function Xn(){let t=[["pursu\
er",v("path",{d:"M12 3 22 20H2z",class:"filled-pursuer"})],["evader",v("circle",{cx:12,cy:12,r:9,class:"filled-evader"})],["capture",v("polygon",{points:Aa,class:"\
filled-capture"})],["captured evader",v("circle",{cx:12,cy:12,r:7.5,class:"ring-evader"})],["conflict",v("rect",{x:3,y:3,width:18,height:18,class:"dashed-confli\
ct"})]];return u("ul",{class:"shapes small","aria-label":"Shapes on the board"},...t.map(([e,r])=>u("li",{},v("svg",{viewBox:"0 0 24 24","aria-hidden":"true"},r),
e)))}var Ma={first:"M6 5v14M19 5 9 12l10 7z",back:"M17 5 7 12l10 7z",play:"M7 4.5 19 12 7 19.5z",pause:"M8 5v14M16 5v14",forward:"M7 5l10 7-10 7z",last:"M18 5v14M5 5\
l10 7-10 7z"};function Jn(t){let e=document.createElementNS("http://www.w3.org/2000/svg","svg");e.setAttribute("viewBox","0 0 24 24"),e.setAttribute("aria-hidde\
n","true"),e.classList.add("icon");let r=document.createElementNS("http://www.w3.org/2000/svg","path");return r.setAttribute("d",Ma[t]),e.append(r),e}function ze(t,e,r,n){
let o=document.createElement("button");return o.type="button",o.className="player-button",o.append(Jn(t)),o.ariaLabel=e,o.title=`${e} (${r})`,o.addEventListener(
"click",n),o}function be(t){let e=document.createElement("div");e.className="player",e.role="group",e.ariaLabel="Player";let r=ze("play","Play","Space",()=>t.toggle()),
n=Ea(t),o=u("div",{class:"captures","aria-hidden":"true",title:"Captures"}),s=Ta(t),a=document.createElement("output");a.className="player-count",e.append(ze("f\
irst","First step","Home",()=>t.move(-t.length)),ze("back","Step back","←",()=>t.move(-1)),r,ze("forward","Step forward","→",()=>t.move(1)),ze("last","Last \
step","End",()=>t.move(t.length)),u("div",{class:"scrub"},o,n),a,s);let i=()=>o.replaceChildren(...t.marks.map(c=>{let d=u("i");return d.style.left=`${100*c/Math.
max(1,t.length)}%`,d})),l=()=>{r.replaceChildren(Jn(t.playing?"pause":"play")),r.ariaLabel=t.playing?"Pause":"Play",r.title=`${r.ariaLabel} (Space)`,n.max=String(
t.length),n.value=String(t.step),n.ariaValueText=`step ${t.step} of ${t.length}`,a.textContent=`${t.step} / ${t.length}`,a.style.minWidth=`${2*String(t.length).
length+3}ch`,s.value=String(t.speed)};return t.addEventListener("step",l),t.addEventListener("state",l),t.addEventListener("state",i),e.addEventListener("keydow\
n",c=>{!(c.target instanceof HTMLSelectElement||c.key===" "&&c.target!==n)&&Z(t,c)&&c.preventDefault()}),l(),e}function Ea(t){let e=document.createElement("inpu\
t");return e.type="range",e.className="player-scrub",e.min="0",e.step="1",e.ariaLabel="Step",e.addEventListener("input",()=>{t.pause(),t.jump(Number(e.value))}),
e}function Ta(t){let e=document.createElement("select");return e.className="player-speed",e.ariaLabel="Speed",e.title="Steps a second (+ and -)",e.append(new Option(
`all in ${qt} s`,String(me)),...Ue.map(r=>new Option(`${r} / s`,String(r)))),e.addEventListener("change",()=>{t.speed=Number(e.value)}),e}var C=(t,e=2)=>t==null?"-":t.toFixed(e),or=(t,e=1)=>t==null?"-":`${(100*t).toFixed(e)} %`;function mt(t,e,r,n=2){return e===null||r===null?t.toFixed(n):`${t.toFixed(
n)} (${e.toFixed(n)} to ${r.toFixed(n)})`}var Qn=t=>t.toLocaleString("en-GB");function We(t,e,r,n=!1){let o=(e-t)/Math.max(1,r),s=10**Math.floor(Math.log10(o||1)),
a=[1,2,5,10].map(c=>c*s).find(c=>c>=o)??10*s;n&&(a=Math.max(1,Math.round(a)));let i=Math.ceil(t/a-1e-9),l=Math.floor(e/a+1e-9);return Array.from({length:Math.max(
0,l-i+1)},(c,d)=>(i+d)*a)}function J(t,e,{pursuer:r,evader:n,episode:o,seed:s}){let a=e.seeds[r][n];return t.match(e.world,G(e,"pursuer",r),G(e,"evader",n),BigInt(s??a),o)}var eo=40,He=new Map,je=({run:t,pursuer:e,evader:r},n)=>`${t} ${e} ${r} ${n}`,ft=class{element;#e;#n;#o=u("div",{class:"episodes",role:"group","aria-label":"Epi\
sodes of this cell"});#a=u("p",{class:"check small numbers","aria-live":"polite"});#r=0;constructor(e,r){[this.#e,this.#n]=[e,r],this.element=u("div",{class:"st\
rip-of-episodes"},this.#o,this.#a)}show(e,r,n){let{selected:o}=this.#e;o.seed===null&&He.set(je(o,o.episode),to(n)),this.#i(r),ka(this.#r),this.#t(e,r)}#t(e,r){
let{selected:n}=this.#e,s=Ne(r,n.pursuer,n.evader)?.rates.findIndex((a,i)=>!He.has(je(n,i)))??-1;s<0||s>=eo||(this.#r=Ca(()=>{this.#e.selected===n&&(this.#n.playing||
(He.set(je(n,s),to(J(e,r,{...n,episode:s,seed:null}))),this.#i(r)),this.#t(e,r))}))}#i(e){let{selected:r}=this.#e,n=Ne(e,r.pursuer,r.evader);if(!n){this.#o.replaceChildren(),
this.#a.textContent="The evaluation played no episodes of this pair.";return}let o=Math.min(eo,n.rates.length);this.#o.replaceChildren(...n.rates.slice(0,o).map(
(c,d)=>this.#u(c,d)));let s=n.rates.slice(0,o).map((c,d)=>He.get(je(r,d))),a=s.filter(c=>c!==void 0),i=s.flatMap((c,d)=>c&&(Math.abs(c.rate-n.rates[d])>1e-6||c.
length!==n.lengths[d])?[d+1]:[]),l=a.reduce((c,d)=>c+d.rate,0)/a.length;this.#a.dataset.equal=String(!i.length&&a.length===n.rates.length),this.#a.textContent=i.
length?`Episode ${i.join(", ")} differs from the evaluation.`:"As in the evaluation",this.#a.title=a.length<n.rates.length?`Played here: ${a.length} of ${n.rates.
length} episodes.`:`Played here: all ${a.length} episodes, mean capture rate ${C(l,3)}. The cell says ${C(n.rate,3)}.`}#u(e,r){let{selected:n}=this.#e,o=u("span",
{class:"bar"});return o.style.height=`${Math.round(100*e)}%`,u("button",{type:"button",class:"episode",title:`Episode ${r+1}: capture rate ${C(e)}`,"aria-label":`\
Episode ${r+1}, capture rate ${C(e)}`,"aria-pressed":String(r===n.episode&&n.seed===null),"data-played":He.has(je(n,r)),onclick:()=>this.#e.select({episode:r,seed:null})},
o,u("span",{class:"count"},r+1))}},to=t=>({rate:t.statistics.capture_rate,length:t.length}),Ca=t=>"requestIdleCallback"in window?requestIdleCallback(t,{timeout:1e3}):
setTimeout(t,100),ka=t=>"cancelIdleCallback"in window?cancelIdleCallback(t):clearTimeout(t);var K=(t,e)=>t<e?`pursuer_${t}`:`evader_${t-e}`,we=["stay","north","east","south","west","northeast","southeast","southwest","northwest"];var ro=0,no=1,Ra=2,$a=176;function so(t,e,r,n){let o=devicePixelRatio||1,s=ut(t);t.width=t.height=$a*o;let a=t.getContext("2d");if(!a)return;let{fov:i}=e,l=t.width/
i;a.fillStyle=s.paper,a.fillRect(0,0,t.width,t.height);for(let d=0;r&&d<i*i;d++){let[p,h]=[(d%i+.5)*l,(Math.floor(d/i)+.5)*l],m=f=>!!r[f*i*i+d];m(Ra)&&(a.fillStyle=
s.obstacle,a.fillRect(p-l/2,h-l/2,l,l));let g=m(ro)&&m(no)?l*.18:0;m(ro)&&oo(a,ne,p+g,h+g,l*.74,s.evader),m(no)&&oo(a,ct,p-g,h-g,l*.86,s.pursuer)}a.strokeStyle=
n<e.n_pursuers?s.pursuer:s.evader,a.lineWidth=2*o;let c=Math.floor(i/2)*l;a.strokeRect(c,c,l,l)}function oo(t,e,r,n,o,s){e(t,r,n,o),t.fillStyle=s,t.fill()}var gt=class{element;#e;#n=u("canvas",{class:"seen",role:"img"});#o=u("h3");#a=u("p",{class:"small muted"});#r=u("div",{class:"answers"});#t=null;#i=null;#u=null;#d=null;#c=null;#l=0;constructor(e){
this.#e=e,this.element=u("div",{class:"inspector","data-open":"false"},u("p",{class:"hint small muted"},"Click an agent, or press A: what it sees, and what its \
network answers."),u("div",{class:"inspected"},this.#n,u("div",{class:"answer"},this.#o,this.#a),this.#r))}get agent(){return this.#c}show(e,r,n,o){(this.#i!==r||
!this.#t)&&(this.#t?.free(),this.#t=e.world(r.world),this.#c!==null&&this.#i!==r&&this.choose(null)),[this.#i,this.#u,this.#d]=[r,n,o]}choose(e){this.#c=e,this.
element.dataset.open=String(e!==null),this.#e(e),this.at(this.#l)}next(e){let r=this.#u;if(!r)return;let n=this.#c??(e>0?-1:0);for(let o=0;o<r.n_agents;o++)if(n=
(n+e+r.n_agents)%r.n_agents,r.alive[this.#l*r.n_agents+n])return this.choose(n)}at(e){this.#l=e;let[r,n,o,s,a]=[this.#u,this.#t,this.#i,this.#d,this.#c];if(!r||
!n||!o||!s||a===null)return;let i=a<r.config.n_pursuers?"pursuer":"evader";this.#o.replaceChildren(u("span",{class:i},K(a,r.config.n_pursuers)));let l=!!r.alive[e*
r.n_agents+a];r.seek(n,e),so(this.#n,r.config,l?n.view(a):null,a),this.#n.ariaLabel=`Field of view of ${K(a,r.config.n_pursuers)}: evaders, pursuers and obstacl\
es around it`;let c=e<r.length?r.actions[e*r.n_agents+a]:null;if(!l)return this.#s([],"It is gone.");let d=G(o,i,s[i]);if(typeof d=="string")return this.#s([],`\
The script "${d}" plays for it${c===null?"":`; it goes ${we[c]}`}.`);let{probabilities:p}=n.answer(d,a),h=Array.from(p,(g,f)=>_a(we[f],g,f===c)),m=d.sampled?"It\
s action is drawn from these probabilities.":"It takes the most probable action.";this.#s(h,c===null?"The episode is over.":m)}#s(e,r){this.#r.replaceChildren(...e),
this.#a.textContent=r}};function _a(t,e,r){let n=u("span",{class:"filled"});return n.style.width=`${100*e}%`,u("div",{class:r?"action taken":"action"},u("span",
{},t),u("span",{class:"track"},n),u("span",{class:"numbers"},e.toFixed(2)))}var Pa=(t,e)=>Object.keys(t).every(r=>t[r]===e[r]);function ao(t,e){return Object.keys(e).find(r=>Pa(e[r],t))??null}var Ge="_",Rc=2n**64n-1n;var sr={fov:11,maxSteps:500,rewards:"paper"},La=["rules","others","rewards","size","diagonal","fov","limit","seed","ended","walls","pursuers","evaders","played",
"next"];function ar(t,e){let r=i=>i.map(l=>Na(l,e)).join(""),n=i=>`${Math.floor(i/t.cols)}.${i%t.cols}`,o=Ia(t.rewards,e),s=[t.seed,t.episode,t.steps].join("."),a={rules:lo(
t.rules,e),others:t.others?lo(t.others,e):"",rewards:o===sr.rewards?"":o,size:`${t.rows}x${t.cols}`,diagonal:t.diagonal?"1":"",fov:t.fov===sr.fov?"":String(t.fov),
limit:t.maxSteps===sr.maxSteps?"":String(t.maxSteps),seed:s==="0.0.0"?"":s,ended:t.ended?"1":"",walls:t.walls.map(n).join(Ge),pursuers:t.pursuers.map(io).join(Ge),
evaders:t.evaders.map(io).join(Ge),played:t.played.map(r).join(Ge),next:t.next.every(i=>i===0)?"":r(t.next)};return La.filter(i=>a[i]).map(i=>`${i}=${a[i]}`).join(
"&")}function io({cell:t,gone:e,captured:r,everCaptured:n}){let o=r?"c":n?"e":"";return`${t[0]}.${t[1]}${o}${e?"x":""}`}function lo(t,e){let r=e.fields.map(({name:n})=>String(
t[n]).toLowerCase());return ao(t,e.variants)??r.join(".")}function Ia(t,e){let r=JSON.stringify(t);return Object.keys(e.rewards).find(o=>JSON.stringify(e.rewards[o])===
r)??Object.values(t).map(o=>String(o)).join(Ge)}function Na(t,e){if(typeof t=="number")return String(t);let r=e.scripts.findIndex(({name:n})=>n===t);return String.
fromCharCode(97+r)}var Ua="/* the engine */";function mo(t,e){return u("button",{type:"button",class:"to-playground",title:"Open this step in the playground (G): the same agents a\
nd actions under any rules",onclick:()=>ir(t(),e)},"What if? Playground")}function ir(t,e){let n=t!==null&&t.match.n_agents<=100&&Math.max(t.match.config.rows,t.
match.config.cols)<=64?ar(Ba(t.match,t.step),e):"",o=new TextDecoder().decode(Yt("playground")).replace(Ua,()=>nt("script-engine"));window.open(`${URL.createObjectURL(
new Blob([o],{type:"text/html"}))}#${n}`)}function Ba(t,e){let{config:r,n_agents:n}=t,o=Math.max(0,e-1),s=i=>{let l=o*n+i,c=o*r.n_evaders+i-r.n_pursuers,d=p=>i>=
r.n_pursuers&&!!p[c];return{cell:[t.last_positions[2*l],t.last_positions[2*l+1]],gone:!t.alive[l],captured:d(t.captured),everCaptured:d(t.ever_captured)}},a=Array.
from({length:n},(i,l)=>s(l));return{rules:r.rules,others:null,rewards:r.rewards,rows:r.rows,cols:r.cols,diagonal:r.diagonal,fov:r.fov,maxSteps:r.max_steps,seed:t.
seed,episode:BigInt(t.episode),steps:o,ended:o===t.length,walls:Array.from(t.map.keys()).filter(i=>t.map[i]),pursuers:a.slice(0,r.n_pursuers),evaders:a.slice(r.
n_pursuers),played:[],next:Array.from(t.actions.subarray(o*n,(o+1)*n))}}function yt(t,e,r){if(r===0)return[{kind:"start",text:Da(t),agents:[]}];let[n,o]=[e.moments[r-1],e.moments[r]],s=d=>K(d,t.config.n_pursuers),a=De(e,n,o),i=t.conflicts(
r),l=new Set(i.flatMap(d=>d.doomed)),c=a.map(d=>({kind:"capture",text:`${s(d)} is captured`,agents:[d]}));for(let d of it(n,o))!a.includes(d)&&!l.has(d)&&c.push(
{kind:"end",text:`${s(d)} disappears`,agents:[d]});return c.push(...i.map(({kind:d,text:p,agents:h})=>({kind:d,text:p,agents:h}))),r===t.length&&c.unshift({kind:"\
end",text:Fa(t),agents:[]}),c}function Da({config:t}){return`${t.n_pursuers} pursuers and ${t.n_evaders} evaders on ${t.rows} x ${t.cols} cells, at most ${t.max_steps}\
 steps`}function Fa(t){let e=Math.round(t.statistics.capture_rate*t.config.n_evaders);return`The episode ends after ${t.length} steps with ${e} of ${t.config.n_evaders}\
 evaders captured`}var za=60,vt=class{element;player=new V(0,{speed:me,still:F()});inspector;#e;#n;#o;#a;#r=u("h2",{class:"match-title"});#t=u("p",{class:"tally numbers"});#i=u("o\
l",{class:"words","aria-live":"off","aria-label":"What happened in this step"});#u=u("p",{class:"problem",role:"alert"});#d=null;#c=null;#l=null;#s=0;#m=!1;#h=0;constructor(e,r,n){
[this.#n,this.#o]=[e,r];let o=u("canvas",{"aria-label":"The match"});this.#e=new X(o,{numbers:!1}),this.#a=new ft(r,this.player),this.inspector=new gt(s=>this.#x(
s)),o.addEventListener("click",s=>this.inspector.choose(this.#e.agentAt(s.clientX,s.clientY))),this.element=u("section",{class:"card match-card","aria-label":"M\
atch",id:"match"},u("div",{class:"match"},u("header",{class:"match-head"},this.#r,this.#t),this.#u,u("div",{class:"stage"},o),u("div",{class:"aside"},this.#i,Xn(),
u("div",{class:"beside"},u("button",{type:"button",class:"to-play",title:"Move the chosen agent, or an evader, yourself from this step on (T)",onclick:()=>this.
element.dispatchEvent(new Event("takeover"))},"Take over an agent"),mo(()=>this.shown,n)),this.inspector.element),be(this.player),this.#a.element)),this.player.
addEventListener("frame",()=>this.#l&&this.#e.show(this.#l,this.player.time)),this.player.addEventListener("step",()=>this.#b()),r.on("match",()=>this.#v()),r.on(
"rest",()=>this.player.pause()),this.#g(),this.#w(0,0)}get#p(){return this.#n[this.#o.selected.run]}get match(){return this.#c}get shown(){return this.#c&&{match:this.#c,
step:this.player.step}}start(e){this.#d=e,this.#y()}playSoon(){this.#m=!0,this.#s||this.#f()}goTo(e){this.#h=e,!this.#s&&this.#c&&this.#y()}#f(){!this.#m||!this.#c||
(this.#m=!1,this.player.jump(0),F()||this.player.play())}#v(){this.#g(),clearTimeout(this.#s),this.#s=setTimeout(()=>this.#y(),za)}#y(){clearTimeout(this.#s),this.#s=
0,this.player.pause(),this.#g();let{selected:e}=this.#o,r=he.map(n=>te(this.#p,n,e[n])).find(Boolean)??"";this.#u.textContent=r,!(r||!this.#d)&&(this.#c=J(this.#d,
this.#p,e),this.#l=ht(this.#c),this.#a.show(this.#d,this.#p,this.#c),this.inspector.show(this.#d,this.#p,this.#c,e),this.player.length=this.#c.length,this.player.
marks=yn(this.#l),this.player.jump(this.#h),this.#h=0,this.#b(),this.element.dataset.played=`${e.run} ${e.pursuer} ${e.evader} ${e.episode} ${e.seed??""}`,this.#f())}names({
run:e,pursuer:r,evader:n}){let{teams:o}=this.#n[e];return[o.pursuer.script??`pursuers ${r}`,o.evader.script??`evaders ${n}`]}#g(){let{episode:e,seed:r}=this.#o.
selected,{payoff:n}=this.#p,[o,s]=this.names(this.#o.selected),a=r===null?e<n.episodes?`episode ${e+1} of ${n.episodes}`:`episode ${e+1}, not part of the cell`:
`seed ${r}`;this.#r.replaceChildren(u("span",{class:"pursuer"},o)," against ",u("span",{class:"evader"},s),u("span",{class:"muted small"},a))}#b(){let e=this.#c;
if(!e||!this.#l)return;let r=this.player.step,n=this.#l.moments[r];this.#w(Array.from(n.everCaptured).filter(Boolean).length,r),this.#i.replaceChildren(...yt(e,
this.#l,r).map(o=>u("li",{class:o.kind,"data-agents":o.agents.join(" ")},o.text))),this.inspector.at(r),this.#S()}#w(e,r){this.#t.replaceChildren(u("strong",{},
e),` of ${this.#p.world.n_evaders} captured`,u("span",{class:"muted"},` · step ${r}`))}#x(e){this.#e.look={selected:e,viewers:e===null?[]:[e]},this.#S()}#S(){let e=this.
inspector.agent;for(let r of this.#i.children){let n=r.dataset.agents?.split(" ")??[];r.classList.toggle("about",e!==null&&n.includes(String(e)))}}};var Wa={ArrowUp:[1,0],ArrowDown:[-1,0],ArrowRight:[0,1],ArrowLeft:[0,-1]},Ha=5;function oe(t,e,r,n="pursuer"){t.tabIndex=0,t.setAttribute("role","application"),
t.addEventListener("keydown",o=>{let s=Wa[o.key];if(!s)return;let[a,i]=n==="pursuer"?s:[s[1],s[0]],[l,c]=r(),d=o.shiftKey?Ha:1,{pursuer:p,evader:h}=e.selected;e.
select({pursuer:fo(p+d*a,l),evader:fo(h+d*i,c)}),o.preventDefault(),o.stopPropagation()})}var fo=(t,e)=>Math.min(e-1,Math.max(0,t));var I={left:52,bottom:46,top:76,right:84},z=10,ja=160,Ve=I.right-z-14,se=I.top-z-14,bt=class{element;#e;#n;#o=u("canvas",{"aria-hidden":"true"});#a=v("svg",{"ar\
ia-hidden":"true"});#r=v("g");#t;#i=u("h2");#u=u("strong",{class:"rate numbers"});#d=u("span",{class:"small muted"});#c=u("p",{class:"of-both-teams small muted \
numbers"});#l=null;constructor(e,r){[this.#n,this.#e]=[e,r],this.#t=u("div",{class:"matrix",id:"matrix","aria-label":"Payoff matrix. Arrow keys choose a match, \
Enter plays it."},this.#o,this.#a);let n=u("header",{class:"readout","aria-live":"polite"},u("div",{},this.#i,this.#c),u("div",{class:"of-cell"},this.#u,this.#d));
this.element=u("section",{class:"card matrix-card","aria-label":"Payoff matrix"},n,this.#t,Ga()),this.#v(),new ResizeObserver(()=>this.#m()).observe(this.#t),this.#t.
addEventListener("pointermove",o=>this.#b(o)),this.#t.addEventListener("pointerleave",()=>r.point({})),this.#t.addEventListener("click",o=>this.#w(o)),this.#t.addEventListener(
"mousedown",o=>{o.preventDefault(),document.activeElement instanceof HTMLElement&&document.activeElement.blur()}),oe(this.#t,r,()=>this.#s.payoff.shape),this.#t.
addEventListener("keydown",o=>{o.key==="Enter"&&this.#x()}),r.on("run",()=>this.#m()),r.on("match",()=>this.#f()),r.on("hover",()=>this.#f())}get#s(){return this.#n[this.#e.
selected.run]}#m(){let[e,r]=this.#s.payoff.shape,{clientWidth:n,clientHeight:o}=this.#t;if(n<50)return;let a=Math.max(ja,Math.min(n-I.left-I.right,o-I.top-I.bottom))/
Math.max(e,r),i=Math.max(I.left,(n-r*a-I.right+I.left)/2),l=I.top+Math.max(0,(o-I.top-I.bottom-e*a)/2),c={width:n,height:o,left:i,top:l,cell:a,rows:e,columns:r};
this.#l=c,ot(this.#o,this.#s.payoff,{left:i,top:l,width:r*a,height:e*a}),this.#a.setAttribute("viewBox",`0 0 ${n} ${o}`),this.#a.replaceChildren(Va(c),...Ka(c),
...this.#p(c),this.#r),this.#f()}#h(e){let r=this.#s.findings?.generalization;if(!r)return[];let{selected:n,hover:o}=this.#e,[s,a]=[o.pursuer??n.pursuer,o.evader??
n.evader],[i,l]=go(e,r.pursuers.mean[s]??0,s),[c,d]=yo(e,r.evaders.mean[a]??0,a);return[v("circle",{class:"dot of-pursuers",cx:i,cy:l,r:5}),v("circle",{class:"d\
ot of-evaders",cx:c,cy:d,r:5})]}#p(e){let r=this.#s.findings?.generalization;if(!r)return[];let{left:n,top:o,cell:s,rows:a,columns:i}=e,[l,c]=[n+i*s+z,o-z],d={class:"\
side"};return[v("rect",{...d,x:l,y:o,width:Ve,height:a*s}),v("rect",{...d,x:n,y:c-se,width:i*s,height:se}),...vo(r.pursuers,(p,h)=>go(e,p,h),"of-pursuers"),...vo(
r.evaders,(p,h)=>yo(e,p,h),"of-evaders"),v("text",{class:"tick",x:l,y:o+a*s+16,"text-anchor":"start"},"0"),v("text",{class:"tick",x:l+Ve,y:o+a*s+16,"text-anchor":"\
end"},"1"),v("text",{class:"tick",x:n-6,y:c-4,"text-anchor":"end"},"0"),v("text",{class:"tick",x:n-6,y:c-se+8,"text-anchor":"end"},"1"),v("text",{class:"label o\
f-pursuers",x:l+Ve,y:o+a*s+34,"text-anchor":"end"},"captures"),v("text",{class:"label of-evaders",x:n+i*s+z,y:c-se+10,"text-anchor":"start"},"escapes")]}#f(){let e=this.#l;
if(!e)return;let{selected:r,hover:n}=this.#e,{left:o,top:s,cell:a,rows:i,columns:l}=e,c=g=>s+(i-1-g)*a,d=[],p=(g,f)=>v("rect",{class:f,x:o,y:c(g),width:l*a+z+Ve,
height:a}),h=(g,f)=>v("rect",{class:f,x:o+g*a,y:s-z-se,width:a,height:z+se+i*a});if(d.push(p(r.pursuer,"strip pursuer"),h(r.evader,"strip evader")),n.pursuer!==
null&&n.pursuer<i&&d.push(p(n.pursuer,"strip hover")),n.evader!==null&&n.evader<l&&d.push(h(n.evader,"strip hover")),n.lag!==null)for(let g=0;g<l;g++){let f=g+n.
lag;f>=0&&f<i&&d.push(v("rect",{class:"lagged",x:o+g*a,y:c(f),width:a,height:a}))}d.push(...this.#h(e));let m={x:o+r.evader*a,y:c(r.pursuer),width:a,height:a};d.
push(v("rect",{class:"chosen under",...m}),v("rect",{class:"chosen",...m})),this.#r.replaceChildren(...d),this.#v()}#v(){let{selected:e,hover:r}=this.#e,n=r.pursuer??
e.pursuer,o=r.evader??e.evader,s=Ne(this.#s,n,o);this.#i.replaceChildren(u("span",{class:"pursuer"},`Pursuers ${n}`)," against ",u("span",{class:"evader"},`evad\
ers ${o}`)),this.#u.textContent=s?C(s.rate,3):"-",this.#d.textContent=s?`capture rate, mean of ${s.rates.length} episodes`:"the evaluation played no episodes",this.#c.
textContent=this.#y(n,o)}#y(e,r){let n=this.#s.findings?.generalization;if(!n)return"";let o=(s,a)=>mt(s.mean[a]??0,s.low?.[a]??null,s.high?.[a]??null);return`A\
gainst all: captures ${o(n.pursuers,e)}, escapes ${o(n.evaders,r)}`}#g(e){let r=this.#l;if(!r)return null;let n=this.#t.getBoundingClientRect(),o=Math.floor((e.
clientX-n.left-r.left)/r.cell),s=r.rows-1-Math.floor((e.clientY-n.top-r.top)/r.cell),[a,i]=[s>=0&&s<r.rows,o>=0&&o<r.columns];return a||i?{g:a?s:-1,h:i?o:-1,inside:a&&
i}:null}#b(e){let r=this.#g(e);this.#e.point(r?{pursuer:r.g<0?null:r.g,evader:r.h<0?null:r.h}:{})}#w(e){let r=this.#g(e);r&&(this.#e.select({...r.g<0?{}:{pursuer:r.
g},...r.h<0?{}:{evader:r.h}}),r.inside&&this.#x())}#x(){this.#t.dispatchEvent(new CustomEvent("play",{bubbles:!0}))}};function Ga(){let t=u("span",{class:"gradi\
ent"});return t.style.backgroundImage=dn(),u("p",{class:"scale-of-rates small muted"},"0 all escape",t,"1 all caught")}function Va({left:t,top:e,cell:r,rows:n,columns:o}){
let s=v("g",{class:"axes"}),a=e+n*r,i=l=>We(0,l-1,Math.min(l,l*r/44),!0);for(let l of i(o))s.append(v("text",{class:"tick",x:t+(l+.5)*r,y:a+16,"text-anchor":"mi\
ddle"},l));for(let l of i(n))s.append(v("text",{class:"tick",x:t-7,y:a-(l+.5)*r,"text-anchor":"end","dominant-baseline":"middle"},l));return s.append(v("text",{
class:"label of-evaders",x:t+o*r/2,y:a+36,"text-anchor":"middle"},"evader generation"),v("text",{class:"label of-pursuers",transform:`translate(${t-36} ${e+n*r/
2}) rotate(-90)`,"text-anchor":"middle"},"pursuer generation")),s}function Ka({left:t,top:e,cell:r,rows:n,columns:o}){let s=v("g",{class:"diagonal"}),a=Math.min(
n,o);if(a<3)return[];let i=e+n*r;for(let d of["H","V"]){let p=`M${t} ${i}`;for(let h=1;h<=a;h++){let[m,g]=[`H${t+h*r}`,`V${i-h*r}`];p+=d==="H"?m+g:g+m}s.append(
v("path",{d:p,class:"under"}),v("path",{d:p}))}let[l,c]=[t+a/2*r-.7*r-4,i-a/2*r-.7*r-4];return[s,v("text",{class:"on-cells",transform:`translate(${l} ${c}) rota\
te(-45)`,"text-anchor":"middle"},"same generation")]}var go=({left:t,top:e,cell:r,rows:n,columns:o},s,a)=>[t+o*r+z+s*Ve,e+(n-a-.5)*r],yo=({left:t,top:e,cell:r},n,o)=>[
t+(o+.5)*r,e-z-n*se];function vo(t,e,r){let n=s=>s.map((a,i)=>e(a??0,i).map(l=>l.toFixed(1)).join(" ")),o=[];return t.low&&t.high&&o.push(v("path",{class:`band ${r}`,
d:`M${[...n(t.high),...n(t.low).reverse()].join("L")}Z`})),o.push(v("path",{class:`line ${r}`,d:`M${n(t.mean).join("L")}`})),o}function k(t,e,...r){return u("section",{class:"card panel","aria-label":t},u("header",{},u("h2",{},t),u("p",{class:"small muted"},e)),...r)}function bo(t,e,r){let{findings:n}=t;if(!n)return null;let o=u("dialog",{class:"four","aria-label":"Four matches"}),s=i=>{let l=r();l&&qa(o,t,i,e,l)},a=n.checkerboards.
map(i=>Ya(t,i,s));return{element:k("Checkerboards","Two generations of each team: each pursuers are better against one of the evaders. Click one: its four match\
es side by side.",a.length?u("div",{class:"boards"},...a):u("p",{},`No four cells differ by more than ${n.margin} in this way.`),a.length?u("p",{class:"small mu\
ted"},"The strongest of all pairs, so noise makes them look stronger than they are. The diagnosis says whether there are more than noise makes."):null,o)}}var wo=({
pursuers:[t,e],evaders:[r,n]})=>[[t,r],[t,n],[e,r],[e,n]];function Ya(t,e,r){let[n,o]=e.pursuers,[s,a]=e.evaders,i=wo(e).map(([l,c])=>{let d=t.payoff.capture_rate[l][c],
p=u("span",{class:"cell"},C(d));return p.style.backgroundColor=un(d),p.style.color=cn(d),p});return u("button",{type:"button",class:"miniature numbers",onclick:()=>r(
e)},u("span",{},u("span",{class:"heard"},`Four matches of pursuers ${n} and ${o}, evaders ${s} and ${a}:`)),u("span",{class:"evader"},s),u("span",{class:"evader"},
a),u("span",{class:"pursuer"},n),i[0],i[1],u("span",{class:"pursuer"},o),i[2],i[3])}function qa(t,e,r,n,o){let s=wo(r).filter(([h,m])=>!te(e,"pursuer",h)&&!te(e,
"evader",m)),a=s.map(([h,m])=>J(o,e,{run:n.selected.run,pursuer:h,evader:m,episode:0,seed:null})),i=new V(Math.max(0,...a.map(h=>h.length)),{speed:me,still:F()}),
l=a.map((h,m)=>{let[g,f]=s[m],b=u("canvas",{"aria-label":`Pursuers ${g} against evaders ${f}`}),w=u("span",{class:"numbers"}),A=()=>{t.close(),n.select({pursuer:g,
evader:f})},y=u("figure",{},b,u("figcaption",{class:"small"},w,u("span",{class:"muted"},`cell ${C(e.payoff.capture_rate[g][f])}`),u("button",{type:"button",title:"\
Show this match alone",onclick:A},"open")));return y.style.gridArea=`${r.pursuers.indexOf(g)+2} / ${r.evaders.indexOf(f)+2}`,{element:y,match:h,recording:ht(h),
board:new X(b,{numbers:!1}),tally:w}}),c=()=>l.forEach(h=>h.board.show(h.recording,i.time)),d=()=>l.forEach(({recording:h,match:m,tally:g})=>{let f=h.moments[Math.
min(i.step,m.length)];g.textContent=`${Array.from(f.everCaptured).filter(Boolean).length} of ${m.config.n_evaders} captured`});i.addEventListener("frame",c),i.addEventListener(
"step",d),t.replaceChildren(u("header",{},u("h2",{},"Four matches of a checkerboard"),u("button",{type:"button",onclick:()=>t.close()},"Close")),u("div",{class:"\
grid-of-four"},u("span"),...r.evaders.map(h=>u("h3",{class:"evader"},`evaders ${h}`)),...r.pursuers.map((h,m)=>{let g=u("h3",{class:"pursuer"},`pursuers ${h}`);
return g.style.gridArea=`${m+2} / 1`,g}),...l.map(h=>h.element)),be(i));let p=h=>{!(h.target instanceof HTMLSelectElement||h.target instanceof HTMLButtonElement&&
h.key===" ")&&!h.defaultPrevented&&Z(i,h)&&h.preventDefault()};t.addEventListener("keydown",p),t.addEventListener("close",()=>{t.removeEventListener("keydown",p),
i.pause(),l.forEach(h=>h.board.close()),t.replaceChildren()},{once:!0}),n.dispatchEvent(new Event("rest")),t.showModal(),c(),d(),F()||i.play()}var wt={pursuer:"evader",evader:"pursuer"};function xo(t,e){let r=t.findings?.ciao;if(!r)return null;let n=["pursuer","evader"].map(o=>{let{fading:s,stripes:a,period:i}=r[`${o}\
s`],l=`fading ${C(s)}, stripes ${C(a)}${i===null?"":` every ${i} generations`}`;return Za(t,o,l,e)});return{element:k("CIAO","Current individuals against ancest\
ral opponents, by the team's own score. Stripes: intransitive, since wins and losses alternate with the age of the opponent; whether a team returns to earlier s\
trategies is recurrence, under What happened. Darker away from the diagonal: forgetting.",u("div",{class:"triangles"},...n.map(o=>o.element))),update:()=>n.forEach(
o=>o.update())}}function Za(t,e,r,n){let o=e==="pursuer"?0:1,[s,a]=[t.payoff.shape[o],t.payoff.shape[1-o]],i=(y,x)=>e==="pursuer"?t.payoff.capture_rate[y][x]:1-
t.payoff.capture_rate[x][y],l=u("canvas",{width:a,height:s,"aria-hidden":"true"}),c=l.getContext("2d"),d=c?.createImageData(a,s);for(let y=0;d&&y<s;y++)for(let x=0;x<=
Math.min(y,a-1);x++)d.data.set([...fe(i(y,x)),255],4*((s-1-y)*a+x));d&&c?.putImageData(d,0,0);let p=v("rect",{class:"chosen",width:1,height:1}),h=v("rect",{class:"\
chosen under",width:1,height:1}),m=v("svg",{viewBox:`0 0 ${a} ${s}`,preserveAspectRatio:"none","aria-hidden":"true"},h,p),g=u("div",{class:"triangle","aria-labe\
l":`CIAO of the ${e}s: ${r}. Arrow keys choose a match.`},l,m);oe(g,n,()=>t.payoff.shape,e),g.style.aspectRatio=`${a} / ${s}`;let f=y=>{let x=g.getBoundingClientRect(),
E=Math.floor((y.clientX-x.left)/x.width*a),R=s-1-Math.floor((y.clientY-x.top)/x.height*s);return E>=0&&R<s&&E<=R?[R,E]:null},b=y=>({[e]:y[0],[wt[e]]:y[1]});g.addEventListener(
"pointermove",y=>n.point(f(y)?b(f(y)):{})),g.addEventListener("pointerleave",()=>n.point({})),g.addEventListener("click",y=>f(y)&&n.select(b(f(y))));let w=()=>{
let y=n.hover[e]??n.selected[e],x=n.hover[wt[e]]??n.selected[wt[e]];for(let E of[p,h])E.setAttribute("x",String(x)),E.setAttribute("y",String(s-1-y)),E.style.display=
x<=y?"":"none"};return{element:u("figure",{},u("figcaption",{class:"small"},u("span",{class:e},`${e}s`)),g,u("p",{class:"small muted"},`horizontal: ${wt[e]} gen\
eration; vertical: ${e} generation`),u("p",{class:"small numbers"},r)),update:w}}var xt={left:46,right:12,top:10,bottom:42},So={x:56,y:34};function St(t,e,r,n){let[o,s]=[xt.left,xt.top],a=Math.max(o+40,t-xt.right),i=Math.max(s+40,e-xt.bottom),
l=(f,b,w)=>A=>b+(A-f.low)/(f.high-f.low||1)*(w-b),[c,d]=[l(r,o,a),l(n,i,s)],p=v("g"),h=v("svg",{width:t,height:e,viewBox:`0 0 ${t} ${e}`,class:"plot"}),m=v("g",
{class:"axes"});for(let f of We(n.low,n.high,(i-s)/So.y,n.whole))m.append(v("line",{x1:o,x2:a,y1:d(f),y2:d(f),class:"grid"}),v("text",{x:o-8,y:d(f),"text-anchor":"\
end","dominant-baseline":"middle"},Ao(f)));for(let f of We(r.low,r.high,(a-o)/So.x,r.whole))m.append(v("text",{x:c(f),y:i+16,"text-anchor":"middle"},Ao(f)));return m.
append(v("line",{x1:o,x2:a,y1:i,y2:i,class:"axis"}),v("text",{x:(o+a)/2,y:e-6,"text-anchor":"middle",class:"label"},r.label),v("text",{transform:`translate(12 ${(s+
i)/2}) rotate(-90)`,"text-anchor":"middle",class:"label"},n.label)),h.append(m,p),{root:h,marks:p,left:o,right:a,top:s,bottom:i,x:c,y:d,at:f=>{let b=f-h.getBoundingClientRect().
left;return r.low+(b-o)/(a-o)*(r.high-r.low)}}}var Ao=t=>String(Number(t.toPrecision(6))).replace("-","−");function Ke(t,e,r,n){let o="",s="M";r.forEach((i,l)=>{
i===null?s="M":(o+=`${s}${t.x(e[l]).toFixed(1)} ${t.y(i).toFixed(1)}`,s="L")});let a=v("path",{d:o,class:`line ${n}`});return t.root.insertBefore(a,t.marks),a}function Ye(t,e,r,n=null){let o=t.x(e);t.marks.append(v("line",{x1:o,x2:o,y1:t.top,y2:t.bottom,class:`mark ${r}`})),n!==null&&t.marks.append(v("circle",{cx:o,cy:t.
y(n),r:5,class:`dot ${r}`}))}function lr(...t){return u("p",{class:"legend small"},...t.map(([e,r])=>u("span",{class:`key ${r}`},e)))}function At(t,e,r={}){let n=u(
"div",{class:"chart",role:"img","aria-label":t}),o=null,s=()=>{o?.marks.replaceChildren(),o&&r.marks?.(o)},a=()=>{let{clientWidth:i,clientHeight:l}=n;i<50||l<50||
(o=e(i,l),n.replaceChildren(o.root),s())};return n.addEventListener("pointermove",i=>r.point?.(o?.at(i.clientX)??null)),n.addEventListener("pointerleave",()=>r.
point?.(null)),r.choose&&(n.classList.add("chooses"),n.addEventListener("click",i=>o&&r.choose?.(o.at(i.clientX),o,i))),new ResizeObserver(a).observe(n),{element:n,
redraw:a,remark:s}}var cr=["of-pursuers","of-evaders","of-both"],Xa=2500,Mo="Arrow keys choose generations.",Eo={low:0,high:1,label:"capture rate"};function To(t,e){let{training:r}=t,
{capture_rate:n,generation:o,learner:s,epochs:a}=r,i=n.map((g,f)=>(f+1)*a),l=Ja(n,r.window),c=i.at(-1)??1,d=i.length>Xa?"dense":"",p=(g,f)=>{let b=o.flatMap((w,A)=>w===
g&&(s[A]===f||s[A]===2)?[A]:[]);return b.length?[i[b[0]],i[b.at(-1)]]:null},h=At(`Capture rate in ${c} epochs of training. ${Mo}`,(g,f)=>{let b=St(g,f,{low:0,high:c,
label:"epoch",whole:!0},Eo);for(let[w,A]of[["raw",n],[d,l]])for(let[y,x]of cr.entries()){let E=A.map((R,Ee)=>s[Ee]===y||s[Ee+1]===y?R:null);E.some(R=>R!==null)&&
Ke(b,i,E,`${x} ${w}`)}return b},{marks:g=>{let{pursuer:f,evader:b}=e.selected;for(let[w,A]of[[0,f],[1,b]]){let y=p(e.hover[w?"evader":"pursuer"]??A,w);y&&Ye(g,(y[0]+
y[1])/2,cr[w])}},choose:g=>{let f=Math.min(i.length-1,Math.max(0,Math.round(g/a)-1)),b=o[f];s[f]!==1&&e.select({pursuer:Math.min(b,t.payoff.shape[0]-1)}),s[f]!==
0&&e.select({evader:Math.min(b,t.payoff.shape[1]-1)})}});oe(h.element,e,()=>t.payoff.shape);let m=[...new Set(s)].sort().map(g=>[["pursuers learn","evaders lear\
n","both teams learn"][g],cr[g]]);return{element:k("Training",`${Qn(r.matches)} training matches. Lines: the generations that are selected.`,lr(...m),h.element),
update:h.remark}}function Co(t,e){let r=t.findings?.lags;if(!r)return null;let[n,o]=[r.lags[0],r.lags.at(-1)],s=Math.min(5,(Math.max(...r.cells)+1)/2),a=r.means.
map((l,c)=>r.cells[c]>=s?l:null),i=At("Lag profile",(l,c)=>{let d=St(l,c,{low:n,high:o,label:"lag: pursuer minus evader generation",whole:!0},Eo);return Ke(d,r.
lags,r.means,"raw ink"),Ke(d,r.lags,a,"ink"),d},{marks:l=>{let{pursuer:c,evader:d}=e.selected;Ye(l,0,"zero");let p=e.hover.lag??c-d;Ye(l,p,"ink",r.means[p-n])},
point:l=>{let c=l===null?null:Math.round(l);e.point({lag:c!==null&&c>=n&&c<=o?c:null})}});return{element:k("Lag profile","Left: evaders are later. Right: pursue\
rs are later. It rises if both teams keep what they learn. Faint: fewer than 5 cells.",i.element),update:i.remark}}function ko(t,e){let r=t.findings?.ratings;if(!r)
return null;let n={pursuer:r.pursuers,evader:r.evaders},o=[...r.pursuers,...r.evaders].map(d=>d??0),[s,a]=[Math.min(...o),Math.max(...o)],i=.06*(a-s||1),l=Math.
max(...t.payoff.shape)-1,c=At(`Elo ratings by generation. ${Mo}`,(d,p)=>{let h=St(d,p,{low:0,high:l,label:"generation",whole:!0},{low:s-i,high:a+i,label:"Elo po\
ints"});for(let m of["pursuer","evader"])Ke(h,n[m].map((g,f)=>f),n[m],`of-${m}s`);return h},{marks:d=>{for(let p of["pursuer","evader"]){let h=e.hover[p]??e.selected[p];
Ye(d,h,`of-${p}s`,n[p][h]??null)}},choose:(d,p,h)=>{let m=Math.round(d),g=h.clientY-p.root.getBoundingClientRect().top,f=w=>Math.abs(p.y(n[w][m]??1/0)-g),b=f("p\
ursuer")<=f("evader")?"pursuer":"evader";m>=0&&m<n[b].length&&e.select({[b]:m})}});return oe(c.element,e,()=>t.payoff.shape),{element:k("Ratings",`One number fo\
r each generation, which cycles do not fit. The game itself: ${C(r.offset,0)} points for the pursuers.`,lr(["pursuers","of-pursuers"],["evaders","of-evaders"]),
c.element),update:c.remark}}function Ja(t,e){let r=[0];for(let n of t)r.push(r.at(-1)+n);return t.map((n,o)=>{let[s,a]=[Math.max(0,o-Math.floor((e-1)/2)),Math.min(
t.length,o+Math.floor(e/2)+1)];return(r[a]-r[s])/(a-s)})}var Qa={present:"●",absent:"○","cannot tell":"?"};function Ro(t){let{findings:e}=t;if(!e)return null;let[,...r]=e.table,n=new Map(e.reasons.map(a=>{let[i,,l]=ei(
a);return[i,l]})),o=r.map(([a,i,l,c])=>{let d=c===e.window?n.get(a):void 0;return u("li",{class:`finding ${i.replace(" ","-")}`},u("span",{class:"sign","aria-hi\
dden":"true"},Qa[i]??""),u("div",{},u("p",{},u("strong",{},a),` ${i}`,u("span",{class:"muted"},` · ${c}`)),d?u("p",{class:"small"},`${d}.`):null,u("p",{class:"\
small muted numbers"},l)))}),s=k("What happened","Each condition is present, absent, or its 95 % interval cannot tell. The intervals are about this run.",u("p",
{class:"headline"},e.headline),...e.numbers.map(a=>u("p",{class:"numbers"},`${$o(a)}.`)),u("ul",{class:"findings"},...o),t.limits?u("p",{class:"small"},t.limits):
null,u("details",{class:"small"},u("summary",{},"Headline numbers in words"),...e.description.map(a=>u("p",{},a)),ti(e)));return s.classList.add("diagnosis"),{element:s}}
function ei(t){let[e="",r=""]=t.split(/: (.*)/s),[n="",o=""]=r.split(/, because (.*)/s);return[e.toLowerCase(),n,$o(o.replace(/\.$/,""))]}var $o=t=>t.charAt(0).
toUpperCase()+t.slice(1);function ti({noise:t}){return t.transitive_share_noise===null?null:u("p",{},`Last half: transitive share ${C(t.transitive_share)} (an o\
rder of strength with the same noise rarely falls below ${C(t.transitive_share_noise)}), checkerboards ${or(t.checkerboard_share)} (it rarely exceeds ${or(t.checkerboard_share_noise)}\
).`)}function _o(t){let e=[t.held_out?.pursuers,t.held_out?.evaders].filter(r=>r!=null);return e.length?{element:k("Held-out opponents",`The last generations against\
 opponents that no run has met; 95 % intervals over ${e[0].episodes} episodes.`,...e.map(ri))}:null}function ri(t){let e=n=>n.at(-1),r=[["mean",e(t.mean)],...Object.
entries(t.against).map(([n,o])=>[n,e(o)])];return u("table",{class:"scores numbers"},u("caption",{},u("span",{class:t.team},`${t.team}s`),` of generation ${t.generations.
at(-1)}, ${t.score}`),...r.map(([n,o],s)=>u("tr",{class:s?"":"mean"},u("th",{scope:"row"},n),u("td",{class:"range"},ni(o,t.team)),u("td",{},mt(o.value,o.low,o.high)))))}
function ni({value:t,low:e,high:r},n){let o=u("span",{class:`between ${n}`});o.style.left=`${100*(e??t)}%`,o.style.width=`${100*((r??t)-(e??t))}%`;let s=u("span",
{class:`value ${n}`});return s.style.left=`${100*t}%`,u("span",{class:"scale","aria-hidden":"true"},o,s)}function Oo(t){let e=t.settings.filter(o=>o.changed),r=t.settings.filter(o=>!o.changed),n=k("Settings",`${t.schedule}, seed ${t.seed}. Every setting is an optio\
n of matrixworld evolve.`,e.length?Po(e,"other than the default"):u("p",{class:"small"},"All settings are the defaults."),u("details",{class:"small"},u("summary",
{},`${r.length} settings with their defaults`),Po(r,"defaults")));return n.classList.add("settings"),{element:n}}function Po(t,e){return u("div",{class:"wide-ta\
ble"},u("table",{class:"small"},u("caption",{class:"heard"},`Settings: ${e}`),...t.map(({name:r,value:n,help:o})=>u("tr",{},u("th",{scope:"row"},`--${r.replaceAll(
"_","-")}`),u("td",{class:"numbers"},n),u("td",{class:"muted"},o)))))}function Lo(t,e,r){let n=new Map,o=u("div",{class:"panels"}),s=[],a=()=>s.forEach(l=>l.update?.()),i=()=>{let l=t[e.selected.run];s=n.get(l)??oi(l,e,r),n.set(l,
s),o.replaceChildren(...s.map(c=>c.element)),a()};return e.on("run",i),e.on("match",a),e.on("hover",a),i(),o}function oi(t,e,r){return[Ro(t),To(t,e),bo(t,e,r),Co(
t,e),ko(t,e),xo(t,e),_o(t),Oo(t)].filter(o=>o!==null)}var Io={pursuer:null,evader:null,lag:null},Mt=class extends EventTarget{#e;#n=Io;constructor(e){super(),this.#e=e}get selected(){return this.#e}get hover(){return this.#n}select(e){
let r=this.#e,n=["run","pursuer","evader"].some(o=>o in e&&e[o]!==r[o]);this.#e={...r,...n?{episode:0,seed:null}:{},...e},this.#e.run!==r.run&&this.dispatchEvent(
new Event("run")),this.dispatchEvent(new Event("match"))}point(e){let r={...Io,...e};r.pursuer===this.#n.pursuer&&r.evader===this.#n.evader&&r.lag===this.#n.lag||
(this.#n=r,this.dispatchEvent(new Event("hover")))}on(e,r){this.addEventListener(e,r)}};var Et=class{config;start;recording;actions=[];#e;#n;#o=[[]];constructor(e,r,n){[this.config,this.start]=[r,n],this.#e=e.world(r),this.#e.reset(n),this.#n=[pt(this.#e)],
this.recording=dt(r,this.#e.map(),this.#n)}get length(){return this.actions.length}get over(){return this.#e.over}get statistics(){return{capture_rate:this.#e.read(
"capture_rate")[0]}}conflicts(e){return this.#o[e]}play(e){this.#e.step(e),this.#a(e)}step(e,r,n){let[o,s]=[this.#e,this.config.n_pursuers],a=new Uint8Array(o.n_agents);
for(let i=o.n_turns;i>0&&!o.over;--i){let[l,c]=o.actors;l<s&&(a=o.decide(e.pursuer,[l,Math.min(c,s)],a)),c>s&&(a=o.decide(e.evader,[Math.max(l,s),c],a)),typeof n==
"number"?a[r]=n:l<=r&&r<c&&(a=o.decide(n,[r,r+1],a)),o.playTurn(a)}this.#a(a)}#a(e){this.actions.push(e),this.#n.push(pt(this.#e,e)),this.#o.push(this.#e.conflicts())}};var Y=(t,e)=>he[+(e>=t.n_pursuers)];function ur(t,e){let r=new Et(t,e.config,{seed:e.seed,episode:e.episode});for(let n of e.moves)r.over||r.step(e.policies,e.seat,
n);return r}function xe(t,e){let{moments:r,nPursuers:n}=t.recording,o=r.findIndex(({alive:a,captured:i})=>!a[e]||!!i[e-n]),s=o<0?t.length:o;return{lasted:s,out:o>=
0,captured:Array.from(r[s].everCaptured).filter(Boolean).length}}var Tt=(t,e)=>t.over||xe(t,e).out;function No(t,e,r){let n=ur(t,{...e,moves:e.moves.slice(0,e.from)});
for(;!Tt(n,e.seat);)n.step(e.policies,e.seat,r);return xe(n,e.seat)}function Uo(t){let e=t.length-1;return[...new Set([0,Math.round(e/3),e])].map(r=>t[r])}function Bo(t,{
seat:e,from:r,moves:n}){let o={...t,seat:e,...r?{from:r}:{},moves:n.join("")};return`${location.href.split("#")[0]}#${Object.entries(o).map(([s,a])=>`${s}=${a}`).
join("&")}`}function Do(t,e){let[r,n,o]=[t.get("seat")??"",t.get("from")??"0",t.get("moves")??""];return/^\d{1,6}$/.test(r)&&Number(r)<e.n_pursuers+e.n_evaders&&
(e.diagonal?/^[0-8]+$/:/^[0-4]+$/).test(o)&&o.length<=e.max_steps&&/^\d{1,6}$/.test(n)&&Number(n)<=o.length?{seat:Number(r),from:Number(n),moves:[...o].map(Number)}:
null}function Fo(t,e,r,n){let o=Y(r.config,r.seat)==="evader",s=o?r.config.max_steps:r.config.n_evaders,a=u("table",{class:"numbers"},u("caption",{},o?"Steps in your\
 seat: same start, same others":"Captures of your team: same start, same others")),i=l=>{let[c,d]=[u("span",{class:o?"bar evader":"bar pursuer"}),u("td",{},"…")];
return a.append(u("tr",{},u("th",{scope:"row"},l),u("td",{class:"track","aria-hidden":"true"},c),d)),({lasted:p,captured:h})=>{c.style.width=`${100*(o?p:h)/s}%`,
d.textContent=String(o?p:h)}};i("You")(xe(e,r.seat));for(let{name:l,policy:c}of n){let d=i(l);setTimeout(()=>d(No(t,r,c())))}return u("div",{},a,u("p",{class:"s\
mall muted"},"One match: luck has its part in it."))}var zo=()=>["file:","http:","https:"].includes(location.protocol);var Wo=["·","↑","→","↓","←","↗","↘","↙","↖"];var ai={" ":0,s:0,ArrowUp:1,w:1,ArrowRight:2,d:2,ArrowDown:3,x:3,ArrowLeft:4,a:4,e:5,c:6,y:7,z:7,q:8},dr=[8,1,5,4,0,2,7,3,6],ii=[7,8,9,4,5,6,1,2,3],li=24,ci=Math.
tan(Math.PI/8);function jo(t,e){if(t.ctrlKey||t.metaKey||t.altKey)return;let r=ii.findIndex(o=>t.code===`Numpad${o}`),n=dr[r]??ai[t.key.length===1?t.key.toLowerCase():
t.key];return n!==void 0&&n>4&&!e?void 0:n}function Go(t){let e=dr.map(r=>u("button",{type:"button","aria-label":we[r],onclick:()=>t(r)},Wo[r]));return{element:u(
"div",{class:"play-pad",role:"group","aria-label":"Your move"},...e),show:r=>e.forEach((n,o)=>n.classList.toggle("absent",dr[o]>4&&!r))}}function Ho(t,e,r){let n=ci*
Math.max(Math.abs(t),Math.abs(e)),o=s=>Math.abs(s)<n?0:s;return fn([0,0],r?[o(t),o(e)]:[t,e],r)}function Vo(t,e,r){let n=null,{canvas:o}=t;o.addEventListener("p\
ointerdown",({button:s,clientX:a,clientY:i})=>{n=s===0?[a,i]:null}),o.addEventListener("pointercancel",()=>{n=null}),o.addEventListener("pointerup",({clientX:s,
clientY:a})=>{let[i,l]=[n,e()];if(n=null,!i||!l)return;let[c,d]=[s-i[0],a-i[1]],p=t.cellAt(s,a);Math.hypot(c,d)>=li?r(Ho(d,c,l.diagonal)):p&&r(Ho(p[0]-l.cell[0],
p[1]-l.cell[1],l.diagonal))})}function Ko(t,e){let r=n=>{let o=e[n]-t[n],s=ge.findIndex(a=>a[n]===Math.sign(o)&&a[1-n]===0);return o?`${Math.abs(o)} ${we[s]}`:""};
return[r(0),r(1)].filter(Boolean).join(", ")||"on your cell"}var pr=[147,...new TextEncoder().encode("NUMPY"),1,0],ui=67324752,di=33639248,pi=101010256,hi=8,Yo=2**28,Ae=async t=>new Uint8Array(await new Blob([...t]).arrayBuffer());
async function mi(t,e){let r=new Blob([t]).stream().pipeThrough(e).getReader(),n=[],o=0;for(let{done:s,value:a}=await r.read();!s;{done:s,value:a}=await r.read()){
if((o+=a.length)>Yo)throw new RangeError(`expected at most ${Yo} bytes`);n.push(a)}return Ae(n)}function Se(...t){return Uint8Array.from(t.flatMap(([e,r])=>Array.
from({length:r},(n,o)=>e>>>8*o&255)))}function fi({dtype:t,shape:e,data:r}){let n=typeof r=="string"?Array.from(r,l=>l.codePointAt(0)):null,o=n?`<U${n.length}`:
t,s=e.map(l=>`${l}, `).join(""),a=`{'descr': '${o}', 'fortran_order': False, 'shape': (${s}), }`,i=a.padEnd(Math.ceil((pr.length+2+a.length+1)/64)*64-pr.length-
3)+`
`;return Ae([Uint8Array.from(pr),Se([i.length,2]),i,n?Int32Array.from(n):r])}var gi=Int32Array.from({length:256},(t,e)=>{let r=e;for(let n=0;n<8;++n)r=r>>>1^(r&
1?3988292384:0);return r});function yi(t){return~t.reduce((e,r)=>e>>>8^gi[(e^r)&255],-1)}async function qo(t){let[e,r]=[[],[]],n=0;for(let[i,l]of Object.entries(
t)){let[c,d]=[new TextEncoder().encode(`${i}.npy`),await fi(l)],p=await mi(d,new CompressionStream("deflate-raw")),h=Se([20,2],[0,2],[hi,2],[0,2],[33,2],[yi(d),
4],[p.length,4],[d.length,4],[c.length,2],[0,2]),m=await Ae([Se([ui,4]),h,c,p]);e.push(m),r.push(await Ae([Se([di,4],[20,2]),h,Se([0,2],[0,2],[0,2],[0,4],[n,4]),
c])),n+=m.length}let o=await Ae(r),s=e.length,a=Se([pi,4],[0,2],[0,2],[s,2],[s,2],[o.length,4],[n,4],[0,2]);return Ae([...e,o,a])}var vi="matrixworld episode 3";async function Zo(t,e,r){let{config:n,actions:o,length:s,recording:a}=e,[i,l]=[n.n_pursuers+n.n_evaders,n.n_evaders],c={positions:[
"<i4",i,2],last_positions:["<i4",i,2],alive:["|b1",i],captured:["|b1",l],ever_captured:["|b1",l]},d={rewards:["<f4",i],involved:["|b1",i,3],fault:["|b1",i,3]},p={},
h=y=>{for(let x of Object.keys(y))(p[x]??=[]).push(Array.from(m.read(x),Number))},m=t.world(n);m.reset(e.start);let g=[];h(c);for(let y of o)m.step(y),h({...c,...d}),
g.push(...m.conflictTable());m.free();let f={"<i4":Int32Array,"<f4":Float32Array,"|b1":Uint8Array},b={};for(let[y,[x,...E]]of Object.entries({...c,...d})){let R=s+
+(y in c);b[y]={dtype:x,shape:[R,...E],data:f[x].from((p[y]??[]).flat())}}let w=y=>({dtype:"<i4",shape:[],data:Int32Array.of(y)}),A=y=>({dtype:"<U",shape:[],data:y});
return qo({format:A(vi),n_pursuers:w(n.n_pursuers),config:A(JSON.stringify(n)),seat:w(r),...b,actions:{dtype:"|i1",shape:[s,i],data:Int8Array.from(o.flatMap(y=>[
...y]))},map:{dtype:"|b1",shape:[n.rows,n.cols],data:Uint8Array.from(a.obstacles,Number)},conflict_table:{dtype:"<i4",shape:[g.length/11,11],data:Int32Array.from(
g)}})}var bi=[0,1,2,4,8],Ct=class{element;player=new V(0,{speed:4,still:F()});#e;#n;#o=u("canvas",{tabindex:0,"aria-describedby":"play-keys"});#a=u("h2");#r=u("p",{class:"\
play-told",role:"status"});#t=Go(e=>this.act(e));#i=u("select",{},...bi.map(e=>u("option",{value:e},e?`${e} steps a second`:"step by step")));#u=u("input",{type:"\
checkbox"});#d=u("section",{class:"play-ending",tabindex:-1,"aria-label":"Result"});#c=be(this.player);#l=null;#s=null;#m=[];#h=null;#p=0;#f=0;constructor(e){this.#e=
e,this.#n=new X(this.#o,{numbers:!1}),this.#o.setAttribute("role","application"),this.#i.addEventListener("change",()=>this.#g()),this.#u.addEventListener("chan\
ge",()=>this.#y()),Vo(this.#n,()=>{let r=this.#h!==null&&this.#s&&M(this.#s.recording.moments.at(-1),this.#h);return r?{cell:r,diagonal:this.#s.config.diagonal}:
null},r=>this.act(r)),this.player.addEventListener("frame",()=>this.#s&&this.#n.show(this.#s.recording,this.player.time)),this.player.addEventListener("step",()=>this.#A()),
this.element=u("div",{class:"play"},u("header",{class:"play-head"},this.#a,this.#r),u("div",{class:"play-stage"},this.#o),u("div",{class:"play-side"},this.#d,this.#t.
element,u("label",{class:"play-choice"},"Pace ",this.#i),u("label",{class:"play-choice"},this.#u," Fog: see only what it sees"),u("p",{class:"small muted play-k\
eys",id:"play-keys"},"Arrow keys move and Space stays; Q W E A S D Z X C and the numeric keypad know diagonals, too. On the board: swipe, or tap where to go.")),
this.#c)}get played(){return this.#l&&{...this.#l.played,moves:this.#m}}get live(){return this.#s}play(e){this.#v(ur(this.#e,e.played),e.played.seat,e.title),[this.#l,
this.#m,this.#p]=[e,[...e.played.moves],0],this.element.dataset.state="playing",this.#o.focus({preventScroll:!0}),Tt(this.#s,e.played.seat)&&this.#w()}watch(e,r,n){
this.#l=null,this.#v(e,r,n),this.#x()}stop(){this.#g(),this.player.pause(),this.#l=null}act(e){let[r,n]=[this.#l,this.#s];if(!r||!n||this.element.dataset.state!==
"playing")return;this.#p=e;let o=Number(this.#i.value);this.#f||(this.#b(),o&&this.element.dataset.state==="playing"&&(this.#f=setInterval(()=>this.#b(),1e3/o)))}key(e){
let{target:r,key:n}=e;if(r instanceof HTMLSelectElement||r instanceof HTMLInputElement&&(r.type==="text"||n===" ")||r instanceof HTMLButtonElement&&(n===" "||n===
"Enter")||!this.#s)return!1;if(this.element.dataset.state!=="playing")return Z(this.player,e);let s=jo(e,this.#s.config.diagonal);return s!==void 0&&this.act(s),
s!==void 0}#v(e,r,n){this.#g(),this.player.pause(),[this.#s,this.#h]=[e,r],this.#a.textContent=n,this.#o.ariaLabel=`Board, ${e.config.rows} by ${e.config.cols} \
cells`,this.#t.show(e.config.diagonal),this.#d.replaceChildren(),this.player.length=e.length,this.player.jump(e.length),this.#y(),this.#A()}#y(){this.#n.look={you:this.#h,
fog:this.#u.checked,viewers:this.#h===null?[]:[this.#h]}}#g(){clearInterval(this.#f),this.#f=0,this.#r.ariaLive=Number(this.#i.value)?"off":"polite"}#b(){let[{policies:e,
seat:r},n]=[this.#l.played,this.#s];n.step(e,r,this.#p),this.#m.push(this.#p),this.player.length=n.length,this.player.glide=Math.min(.22,.9/(Number(this.#i.value)||
4)),this.player.move(n.length-this.player.step),Tt(n,r)&&this.#w()}#w(){this.#g();let[e,r,n]=[this.#l,this.#s,this.played],o=zo()?e.link(n):null;this.#d.replaceChildren(
u("h3",{},Si(r,n.seat)),...e.ending(r,n),u("div",{class:"play-buttons"},u("button",{type:"button",class:"primary",onclick:()=>e.again()},"Again"),u("button",{type:"\
button",onclick:()=>this.#x()},"Watch it"),u("button",{type:"button",onclick:()=>{this.#S(r,n.seat)}},"Save"),o&&u("button",{type:"button",onclick:({currentTarget:s})=>Mi(
s,o)},"Link"))),this.element.dataset.state="ended",this.#d.focus({preventScroll:!0}),this.#d.scrollIntoView({block:"nearest"})}#x(){this.element.dataset.state="\
watched",this.player.length=this.#s.length,this.player.jump(0),F()||this.player.play()}async#S(e,r){let n=new Blob([await Zo(this.#e,e,r)],{type:"application/oc\
tet-stream"});u("a",{href:URL.createObjectURL(n),download:`${K(r,e.config.n_pursuers)}-${e.length}-steps.npz`}).click()}#A(){let[e,r,{step:n}]=[this.#s,this.#h,
this.player];if(!e||n>e.length)return;let o=yt(e,e.recording,n).filter(({agents:a})=>r===null||a.includes(r)),s=[`Step ${n} of ${e.config.max_steps}`,...o.map(({
text:a})=>a)];this.#l&&n===0?s.push(wi(e.config,r)):r!==null&&s.push(xi(e,n,r)),this.#r.textContent=s.filter(Boolean).map(a=>`${a}.`).join(" ")}};function wi(t,e){
let r=t.rules.capture==="SURROUND";return Y(t,e)==="evader"?`Stay free: ${r?"pursuers on all sides of you capture":"a pursuer on your cell captures"} you`:`Capt\
ure evaders: ${r?"surround them together":"reach their cell"}`}function xi({config:t,recording:e},r,n){let o=e.moments[r],a=Y(t,n)==="pursuer"?"evader":"pursuer";
if(!o.alive[n])return"";let i=M(o,n),l=p=>{let[h,m]=M(o,p);return Math.max(Math.abs(h-i[0]),Math.abs(m-i[1]))},c=Array.from({length:o.alive.length},(p,h)=>h).filter(
p=>Y(t,p)===a&&o.alive[p]&&!o.captured[p-t.n_pursuers]&&2*l(p)<t.fov);if(!c.length)return`No ${a} in view`;let d=c.reduce((p,h)=>l(h)<l(p)?h:p);return`Nearest ${a}\
: ${Ko(i,M(o,d))}`}function Si(t,e){let[{lasted:r,out:n,captured:o},{config:s}]=[xe(t,e),t];return Y(s,e)==="pursuer"?`Your team captured ${o} of ${Ai(s)} in ${r}\
 steps.`:n?`You lasted ${r} of ${s.max_steps} steps.`:`You escaped: ${r} steps.`}var Ai=({n_evaders:t})=>`${t} evader${t===1?"":"s"}`;function Mi(t,e){let r=u("\
input",{type:"text",readonly:!0,value:e,"aria-label":"Link to this match"});t.replaceWith(r),r.select(),navigator.clipboard?.writeText(e).catch(()=>{})}var kt=class{dialog=u("dialog",{class:"take-over","aria-label":"Play an agent"});#e;#n;#o;#a=null;#r=null;constructor(e,r,n){[this.#e,this.#n,this.#o]=[e,r,n],n.
element.addEventListener("takeover",()=>this.open()),this.dialog.addEventListener("keydown",o=>this.#r?.key(o)&&o.preventDefault()),this.dialog.addEventListener(
"close",()=>this.#r?.stop())}get view(){return this.#r}start(e,r){this.#a=e;let n=Oe(r,this.#e,this.#n.selected),o=Do(new URLSearchParams(r.replace(/^#/,"")),this.#e[n.
run].world);o&&this.#t(n,o)}open(){let e=this.#o.shown;if(!e)return;let{match:r,step:n}=e;this.#o.player.pause();let o=this.#o.inspector.agent,s=n<r.length?n:0,
a=(p,h)=>!!r.alive[h*r.n_agents+p],i=Array.from({length:r.n_agents},(p,h)=>(h+r.config.n_pursuers)%r.n_agents),l=o??i.find(p=>a(p,s)),c=a(l,s)?s:0,d=Array.from(
{length:c},(p,h)=>r.actions[h*r.n_agents+l]);this.#t(this.#n.selected,{seat:l,from:c,moves:d})}#t(e,r){let[n,o]=[this.#a,this.#e[e.run]];if(!n||he.some(h=>te(o,
h,e[h])))return;let{run:s,pursuer:a,evader:i,episode:l,seed:c}=e,d=Y(o.world,r.seat),p=o.teams[d].kept.map(h=>({name:o.teams[d].script??`generation ${h}`,policy:()=>G(
o,d,h)}));this.#r||(this.#r=new Ct(n),this.dialog.append(u("button",{type:"button",class:"leave",onclick:()=>this.dialog.close()},"Close"),this.#r.element)),this.
dialog.open||this.dialog.showModal(),this.#r.play({title:`You are ${K(r.seat,o.world.n_pursuers)}: ${this.#o.names(e).join(" against ")}`,played:{config:o.world,
seed:BigInt(c??o.seeds[a][i]),episode:l,...r,policies:{pursuer:G(o,"pursuer",a),evader:G(o,"evader",i)}},ending:(h,m)=>[Fo(n,h,m,Uo(p))],again:()=>this.#t(e,{...r,
moves:r.moves.slice(0,r.from)}),link:h=>Bo({run:s,pursuers:a,evaders:i,episode:l,...c===null?{}:{seed:c}},h)})}};var Q=an(),{runs:B}=Q,[Ei,Ti]=B[0].payoff.shape,Ci=Oe(location.hash,B,{run:0,pursuer:Ei-1,evader:Ti-1,episode:0,seed:null}),{step:Xo,...ki}=Ci,W=new Mt(ki),$=new vt(
B,W,Q.playground),Jo=new bt(B,W),qe=new kt(B,W,$),hr=hn(),Ri=location.hash,Me=null,$i="Each cell is a match: pursuers of one generation against evaders of anoth\
er. Bright: many are captured. Click a cell to watch it.";document.getElementById("page").replaceWith(u("header",{class:"top"},u("div",{},u("h1",{},Q.heading),u(
"p",{class:"lead"},$i)),u("div",{class:"tools"},qr(),u("button",{type:"button",class:"keys-button",title:"Keys (?)","aria-label":"Keys (?)",onclick:()=>hr.showModal()},
"?"))),...Q.note?[u("aside",{class:"note small muted"},Q.note)]:[],pn(B,W),u("main",{class:"stages"},Jo.element,$.element),Lo(B,W,()=>Me),u("footer",{class:"mut\
ed small"},`${Q.title} · matrixworld ${Q.version}`),qe.dialog,hr);Object.assign(window,{matrixworldExplorer:{get match(){return $.match},get step(){return $.player.
step},get pace(){return $.player.pace},get playing(){return qe.view},play:t=>Me&&J(Me,B[W.selected.run],{...W.selected,episode:t}),get shape(){return B[W.selected.
run].payoff.shape}}});Jo.element.addEventListener("play",()=>$.playSoon());$.goTo(Xo);Xo||$.playSoon();Zr(B,W,$);mn(B,W,$,hr,()=>qe.open(),()=>ir($.shown,Q.playground));
window.addEventListener("hashchange",({newURL:t})=>Me&&qe.start(Me,new URL(t).hash));requestAnimationFrame(()=>setTimeout(()=>{Kr().then(t=>{Me=t,$.start(t),qe.
start(t,Ri),document.body.dataset.ready="true"},t=>{$.element.prepend(u("p",{class:"problem",role:"alert"},`The engine does not start here: ${String(t)}`)),document.
body.dataset.ready="true"})}));})();
