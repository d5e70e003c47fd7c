/* built from web/ by "npm run build"; sources ef4c31066ca0c5bb4398d3238ec57026485d85724e82eaefe7bc58659e26e08d */
"use strict";(()=>{var rr={SIMULTANEOUS:0,SWARM_TURNS:1,AGENT_TURNS:2},Ne={DISAPPEAR:0,REACH:1,BOUNCE:2},nr={OCCUPATION:0,SURROUND:1},or={FAULT:0,INVOLVED:1};var gt=["obstacle","teammate","adversary"],vt=["vertex","edge","chain"],sr=["turn","kind","form","first","second","row","col","at_fault","held","doomed"],bt=["p\
ursuer_{number}","evader_{number}"],ar={obstacle:"{first} ran into the obstacle or border at {cell}",vertex:"{first} and {second} both headed for {cell}",edge:"\
{first} and {second} meant to swap, {first} to {cell}",chain:"{first} headed for {cell}, where {second} had to stay"},_e={"both held":"both bounce","both doomed":"\
both disappear",held:"{agent} bounces",doomed:"{agent} disappears",none:"nobody is stopped"},ir="{event}: {outcome}",wt={random:"any action, all equally likely",
still:"always stays",chaser:"moves to where the nearest adversary in view is nearest",fleer:"moves to where the nearest adversary in view is farthest","clumsy-c\
haser":"a chaser that takes any action in half of the steps",hunter:"a chaser of the nearest adversary in view to which no teammate in view is nearer",surrounder:"\
a chaser of the nearest free cell beside an adversary without a teammate","clumsy-fleer":"a fleer that takes any action in half of the steps",dodger:"moves to w\
here all adversaries in view together are farthest"},lr={free:".GS",blocked:"#@OTW"};var ye=1+sr.length;function Oe(e,t){return e.replace(/\{(\w+)\}/g,(r,n)=>String(t[n]))}function xt(e,t){return e<t?Oe(bt[0],{number:e}):Oe(bt[1],{number:e-t})}function no(e,t){
let[r,n,o,s,a,i,u,...l]=Array.from(e),c=a<0?[s]:[s,a],[p,d,f]=l.map(S=>c.filter((M,g)=>S>>g&1)),m=c.map(S=>xt(S,t)),y=Oe(ar[a<0?"obstacle":vt[o]],{first:m[0],second:m[m.
length-1],cell:`(${i}, ${u})`}),v=Oe(ir,{event:y,outcome:oo(c.length,d,f,t)});return{kind:gt[n],form:vt[o],agents:c,cell:[i,u],at_fault:p,held:d,doomed:f,turn:r,
text:v}}function oo(e,t,r,n){if(e===2&&t.length===2)return _e["both held"];if(e===2&&r.length===2)return _e["both doomed"];let o=s=>a=>Oe(_e[s],{agent:xt(a,n)});
return[...t.map(o("held")),...r.map(o("doomed"))].join(", ")||_e.none}function Ve(e,t){let r=[];for(let n=0;n<e.length;n+=ye)r.push(no(e.subarray(n+1,n+ye),t));
return r}var B=class extends Error{name="EngineError"};function I(e,t,r){let n=typeof r=="string"?`'${r}'`:typeof r=="object"?JSON.stringify(r):String(r);return new B(`${e}\
: expected ${t}, got ${n}`)}var ge=class{bytes;constructor(t){this.bytes=t}},pr=0,At=[Uint8Array,Uint8Array,Int32Array,BigInt64Array,BigUint64Array,Float32Array,Float64Array],ur=4,cr=4,so=new TextEncoder,
ao=new TextDecoder;function io(e){for(let t=At.length-1;t>pr;--t)if(e instanceof At[t])return t;throw new TypeError("array: expected a typed array of the engine\
's numbers, got another")}function St(e){return new Uint8Array(e.buffer,e.byteOffset,e.byteLength)}function lo(e){return so.encode(`${e}\0`)}var Mt=class{engine;addresses=[];constructor(t){
this.engine=t}copy(t){let r=this.engine._malloc(Math.max(t.length,1));if(r===0)throw new B("memory: expected room for the arguments, got none");return this.addresses.
push(r),this.engine.HEAPU8.set(t,r),r}text(t){return this.copy(lo(t))}arrays(t){let r=Object.entries(t),n=r.flatMap(([s,a])=>{let i=a instanceof ge,u=i?a.bytes:
a;return[this.text(s),i?pr:io(u),u.length,this.copy(St(u))]}),o=this.copy(St(Int32Array.from(n)));return this.copy(St(Int32Array.of(r.length,o)))}free(){for(let t of this.
addresses)this.engine._free(t)}};function dr(e,t){let r=e.HEAPU8;return ao.decode(r.subarray(t,r.indexOf(0,t)))}function Ye(e){let t=new Int32Array(e.HEAPU8.buffer),
r=e._last_outputs()/ur,n=t[r+1]/ur,o={};for(let s=n;s<n+t[r]*cr;s+=cr){let a=At[t[s+1]],i=t[s+2]*a.BYTES_PER_ELEMENT,u=t[s+3];o[dr(e,t[s])]=new a(e.HEAPU8.slice(
u,u+i).buffer)}return o}function ke(e,t){let r=new Mt(e);try{let n=t(r);if(n===0)throw new B(dr(e,e._last_error()));return n}finally{r.free()}}var uo=2**31-1,co=2n**64n-1n,po=34028234663852886e22;function ne(e,t){if(typeof t!="number"||!Number.isInteger(t)||Math.abs(t)>uo)throw I(e,"an integer",t);return Int32Array.
of(t)}function Ke(e,t){if(typeof t!="boolean")throw I(e,"true or false",t);return new ge(Uint8Array.of(Number(t)))}function ce(e,t,r){let n=typeof t=="string"&&
Object.hasOwn(r,t)?r[t]:void 0;if(n===void 0)throw I(e,`one of ${Object.keys(r).join(", ")}`,t);return Int32Array.of(n)}function Ct(e,t){if(typeof t!="number"||
!(Math.abs(t)<=po))throw I(e,"a finite number",t);return t}function ve(e,t){let n=typeof t=="bigint"||typeof t=="number"&&Number.isSafeInteger(t)?BigInt(t):-1n;
if(n<0n||n>co)throw I(e,"an integer from 0 to 2^64 - 1",t);return BigUint64Array.of(n)}function fo(e){return{"rules.interaction":ce("interaction",e.interaction,
rr),"rules.obstacle":ce("obstacle",e.obstacle,Ne),"rules.teammate":ce("teammate",e.teammate,Ne),"rules.evader":ce("evader",e.evader,Ne),"rules.pursuer":ce("purs\
uer",e.pursuer,Ne),"rules.capture":ce("capture",e.capture,nr),"rules.captured_disappear":Ke("captured_disappear",e.captured_disappear)}}function fr(e,t){let r=typeof t==
"number"?[t,t,t]:t;if(!Array.isArray(r)||r.length!==3)throw I(e,"1 or 3 numbers",t);return Float32Array.from(r,n=>Ct(e,n))}function ho(e){let t=(r,n)=>Float32Array.
of(Ct(r,e[r]),Ct(n,e[n]));return{"rewards.capture":t("pursuer_capture","evader_capture"),"rewards.neighbor":t("pursuer_neighbor","evader_neighbor"),"rewards.ste\
p":t("pursuer_step","evader_step"),"rewards.pursuer_collide":fr("pursuer_collide",e.pursuer_collide),"rewards.evader_collide":fr("evader_collide",e.evader_collide),
"rewards.blame":ce("blame",e.blame,or),"rewards.capture_repeats":Ke("capture_repeats",e.capture_repeats)}}function mr(e){if(e===void 0||typeof e=="number")return new Uint8Array(
0);if(e instanceof Uint8Array)return e;let{free:t,blocked:r}=lr;for(let[n,o]of e.entries()){if(o.length!==e[0]?.length)throw I(`map, row ${n}`,`${e[0]?.length} \
cells as in row 0`,o.length);let s=[...o].find(a=>!t.includes(a)&&!r.includes(a));if(s)throw I(`map, row ${n}`,`'${t}' (free) or '${r}' (obstacle)`,s)}return Uint8Array.
from([...e.join("")],n=>Number(r.includes(n)))}function yr(e,t){if(!Array.isArray(e))return;let r=[e.length,e[0]?.length??0];if(!(r[0]===t.rows&&r[1]===t.cols))
throw I("obstacle map",`shape (${t.rows}, ${t.cols}), the rows and cols`,r)}function qe(e){yr(e.obstacles,e);let t=typeof e.obstacles=="number"?e.obstacles:0;return{
...fo(e.rules),...ho(e.rewards),rows:ne("rows",e.rows),cols:ne("cols",e.cols),n_pursuers:ne("n_pursuers",e.n_pursuers),n_evaders:ne("n_evaders",e.n_evaders),fov:ne(
"fov",e.fov),diagonal:Ke("diagonal",e.diagonal),max_steps:ne("max_steps",e.max_steps),density:Float64Array.of(t),map:mr(e.obstacles)}}function hr(e,t){return Int32Array.
from((t??[]).flat(),r=>ne(e,r)[0])}function gr(e,t){return yr(e.obstacles,t),{seed:ve("seed",e.seed??0n),episode:ve("episode",e.episode??0),pursuers:hr("pursuer\
s",e.pursuers),evaders:hr("evaders",e.evaders),map:mr(e.obstacles)}}function Ze(e){return{actions:Int32Array.from(e,t=>ne("actions",t)[0])}}function be(e){if(typeof e==
"string"){if(!Object.hasOwn(wt,e))throw I("policy",`one of ${Object.keys(wt).join(", ")}`,e);return{script:new TextEncoder().encode(e)}}if(e.activation!=="relu"&&
e.activation!=="tanh")throw I("activation","'relu' or 'tanh'",e.activation);return{hidden:Int32Array.from(e.hidden,t=>ne("hidden",t)[0]),activation:new TextEncoder().
encode(e.activation),sampled:Ke("sampled",e.sampled),genome:e.genome}}var mo=["first_turn","terminated","truncated"];function vr(e){let t={...e};for(let r of mo)
t[r]=new ge(e[r]);return t}var Je=class{config;seed;episode;n_agents;statistics;positions;last_positions;alive;captured;ever_captured;actions;rewards;involved;fault;map;conflict_table;first_conflict;constructor(t,r,n,o){
this.config=t,this.seed=r,this.episode=n,this.n_agents=t.n_pursuers+t.n_evaders,this.statistics=br(o,0),this.positions=o.positions,this.last_positions=o.last_positions,
this.alive=o.alive,this.captured=o.captured,this.ever_captured=o.ever_captured,this.actions=o.actions,this.rewards=o.rewards,this.involved=o.involved,this.fault=
o.fault,this.map=o.map,this.conflict_table=o.conflict_table,this.first_conflict=yo(this.conflict_table,this.length)}get length(){return this.actions.length/this.
n_agents}conflicts(t){this.check(t);let[r,n]=[this.first_conflict[t],this.first_conflict[t+1]],o=this.conflict_table.subarray(r*ye,n*ye);return Ve(o,this.config.
n_pursuers)}seek(t,r){this.check(r),(!(t.seed===this.seed&&t.episode===BigInt(this.episode))||t.turn!==0||t.steps>r)&&t.reset({seed:this.seed,episode:this.episode});
for(let o=t.steps;o<r;++o)t.step(this.actions.subarray(o*this.n_agents,(o+1)*this.n_agents))}check(t){if(!(Number.isInteger(t)&&t>=0&&t<=this.length))throw I("s\
tep",`0 to ${this.length}`,t)}};function yo(e,t){let r=new Int32Array(t+2);for(let n=0;n<e.length;n+=ye)++r[e[n]+1];for(let n=1;n<r.length;++n)r[n]+=r[n-1];return r}
function br(e,t){let r=e["statistics.length"].length,n=s=>{let a=e[`statistics.${s}`],i=a.length/r;return a.slice(t*i,(t+1)*i)},o=s=>Number(n(s)[0]);return{capture_rate:o(
"capture_rate"),ever_capture_rate:o("ever_capture_rate"),captured_fraction:o("captured_fraction"),length:o("length"),return:n("return"),survivors:n("survivors"),
overlap:n("overlap"),collisions:n("collisions"),faults:n("faults"),agent_steps:n("agent_steps")}}function wr(e,t,r,n){let o=[qe(r.config),be(r.pursuers),be(r.evaders),
n];return ke(e,s=>{let[a,i,u,l]=o.map(c=>s.arrays(c));return e[t](a,i,u,l)}),Ye(e)}function xr(e,t,r,n){let o={seed:ve("seed",r),episode:ve("episode",n)};return new Je(
t.config,r,n,wr(e,"_play_match",t,o))}function Sr(e,t,r,n){if(!Number.isInteger(n)||n<1)throw I("n_episodes","at least 1",n);let o={seed:ve("seed",r),n_episodes:Int32Array.
of(n)},s=wr(e,"_play_rollout",t,o);return Array.from({length:n},(a,i)=>br(s,i))}var Ar=new FinalizationRegistry(([e,t])=>e._world_free(t)),Ie=class{config;n_agents;n_actions;engine;at;freed=!1;constructor(t,r){this.engine=t,this.config=r,this.
n_agents=r.n_pursuers+r.n_evaders,this.n_actions=r.diagonal?9:5,this.at=ke(t,n=>t._world_new(n.arrays(qe(r)))),Ar.register(this,[t,this.at],this)}free(){this.freed||
(this.freed=!0,Ar.unregister(this),this.engine._world_free(this.at))}reset(t={}){let r=gr(t,this.config);this.call(n=>this.engine._world_reset(this.at,n.arrays(
r)))}step(t){let r=Ze(t);this.call(n=>this.engine._world_step(this.at,n.arrays(r)))}playTurn(t){let r=Ze(t);this.call(n=>this.engine._world_play_turn(this.at,n.
arrays(r)))}decide(t,r,n){let{n_pursuers:o}=this.config,s={pursuer:[0,o],evader:[o,this.n_agents]},[a,i]=typeof r=="string"?s[r]:r;if(n.length!==this.n_agents)throw I(
"actions",String(this.n_agents),n.length);let u=[be(t),Ze(n)],{actions:l}=this.call(c=>this.engine._world_decide(this.at,c.arrays(u[0]),a,i,c.arrays(u[1])));return Uint8Array.
from(l)}get n_turns(){return this.turnNumbers()[1]}get turn(){return this.turnNumbers()[0]}get actors(){let[,,t,r]=this.turnNumbers();return[t,r]}turnNumbers(){
return this.call(()=>this.engine._world_turn(this.at)).turn}get steps(){return this.read("steps")[0]}get seed(){return this.read("seed")[0]}get episode(){return this.
read("episode")[0]}get over(){return this.read("terminated")[0]===1||this.read("truncated")[0]===1}read(t){return this.call(r=>this.engine._world_read(this.at,r.
text(t)))[t]}view(t){let r=3*this.config.fov**2;return this.read("views").slice(t*r,(t+1)*r)}map(){return this.read("state").slice(2*this.config.rows*this.config.
cols)}conflicts(){return Ve(this.conflictTable(),this.config.n_pursuers)}conflictTable(){return this.call(()=>this.engine._world_conflicts(this.at)).conflict_table}answer(t,r){
let n=be(t),{logits:o}=this.call(i=>this.engine._world_logits(this.at,i.arrays(n),r)),s=o,a=this.decide(t,[r,r+1],new Uint8Array(this.n_agents))[r];return{logits:s,
probabilities:go(s),action:a}}snapshot(){return this.call(()=>this.engine._world_snapshot(this.at))}restore(t){let r=vr(t);this.call(n=>this.engine._world_restore(
this.at,n.arrays(r)))}call(t){if(this.freed)throw I("world","one that is in use","one that was freed");return ke(this.engine,t),Ye(this.engine)}};function go(e){
let t=Math.max(...e),r=Array.from(e,o=>Math.exp(o-t)),n=r.reduce((o,s)=>o+s,0);return Float32Array.from(r,o=>o/n)}var Tt=class{compiled;constructor(t){this.compiled=t}world(t){return new Ie(this.compiled,t)}match(t,r,n,o,s=0){return xr(this.compiled,{config:t,pursuers:r,evaders:n},
o,s)}rollout(t,r,n,o,s){return Sr(this.compiled,{config:t,pursuers:r,evaders:n},o,s)}},Mr;function Cr(e=globalThis.matrixworldEngine){return Mr??=vo(e),Mr}async function vo(e){
if(!e)throw new Error("matrixworldEngine: expected the script engine.js before this one, got none");let t=Uint8Array.from(atob(e.binary),r=>r.charCodeAt(0));return new Tt(
await e({wasmBinary:t}))}var C=Uint8Array,V=Uint16Array,Ut=Int32Array,Qe=new C([0,0,0,0,0,0,0,0,1,1,1,1,2,2,2,2,3,3,3,3,4,4,4,4,5,5,5,5,0,0,0,0]),et=new C([0,0,0,0,1,1,2,2,3,3,4,4,5,5,6,
6,7,7,8,8,9,9,10,10,11,11,12,12,13,13,0,0]),Ot=new C([16,17,18,0,8,7,9,6,10,5,11,4,12,3,13,2,14,1,15]),Or=function(e,t){for(var r=new V(31),n=0;n<31;++n)r[n]=t+=
1<<e[n-1];for(var o=new Ut(r[30]),n=1;n<30;++n)for(var s=r[n];s<r[n+1];++s)o[s]=s-r[n]<<5|n;return{b:r,r:o}},kr=Or(Qe,2),Ir=kr.b,kt=kr.r;Ir[28]=258,kt[258]=28;var Pr=Or(
et,0),bo=Pr.b,Tr=Pr.r,It=new V(32768);for(A=0;A<32768;++A)oe=(A&43690)>>1|(A&21845)<<1,oe=(oe&52428)>>2|(oe&13107)<<2,oe=(oe&61680)>>4|(oe&3855)<<4,It[A]=((oe&65280)>>
8|(oe&255)<<8)>>1;var oe,A,ee=(function(e,t,r){for(var n=e.length,o=0,s=new V(t);o<n;++o)e[o]&&++s[e[o]-1];var a=new V(t);for(o=1;o<t;++o)a[o]=a[o-1]+s[o-1]<<1;
var i;if(r){i=new V(1<<t);var u=15-t;for(o=0;o<n;++o)if(e[o])for(var l=o<<4|e[o],c=t-e[o],p=a[e[o]-1]++<<c,d=p|(1<<c)-1;p<=d;++p)i[It[p]>>u]=l}else for(i=new V(
n),o=0;o<n;++o)e[o]&&(i[o]=It[a[e[o]-1]++]>>15-e[o]);return i}),ie=new C(288);for(A=0;A<144;++A)ie[A]=8;var A;for(A=144;A<256;++A)ie[A]=9;var A;for(A=256;A<280;++A)
ie[A]=7;var A;for(A=280;A<288;++A)ie[A]=8;var A,$e=new C(32);for(A=0;A<32;++A)$e[A]=5;var A,wo=ee(ie,9,0),xo=ee(ie,9,1),So=ee($e,5,0),Ao=ee($e,5,1),Et=function(e){
for(var t=e[0],r=1;r<e.length;++r)e[r]>t&&(t=e[r]);return t},Z=function(e,t,r){var n=t/8|0;return(e[n]|e[n+1]<<8)>>(t&7)&r},Rt=function(e,t){var r=t/8|0;return(e[r]|
e[r+1]<<8|e[r+2]<<16)>>(t&7)},zt=function(e){return(e+7)/8|0},Ue=function(e,t,r){return(t==null||t<0)&&(t=0),(r==null||r>e.length)&&(r=e.length),new C(e.subarray(
t,r))};var Mo=["unexpected EOF","invalid block type","invalid length/literal","invalid distance","stream finished","no stream handler",,"no callback","invalid UTF-8 da\
ta","extra field too long","date not in range 1980-2099","filename too long","stream finishing","invalid zip data"],z=function(e,t,r){var n=new Error(t||Mo[e]);
if(n.code=e,Error.captureStackTrace&&Error.captureStackTrace(n,z),!r)throw n;return n},Lr=function(e,t,r,n){var o=e.length,s=n?n.length:0;if(!o||t.f&&!t.l)return r||
new C(0);var a=!r,i=a||t.i!=2,u=t.i;a&&(r=new C(o*3));var l=function(Ee){var Re=r.length;if(Ee>Re){var me=new C(Math.max(Re*2,Ee));me.set(r),r=me}},c=t.f||0,p=t.
p||0,d=t.b||0,f=t.l,m=t.d,y=t.m,v=t.n,S=o*8;do{if(!f){c=Z(e,p,1);var M=Z(e,p+1,3);if(p+=3,M)if(M==1)f=xo,m=Ao,y=9,v=5;else if(M==2){var O=Z(e,p,31)+257,_=Z(e,p+
10,15)+4,w=O+Z(e,p+5,31)+1;p+=14;for(var b=new C(w),P=new C(19),k=0;k<_;++k)P[Ot[k]]=Z(e,p+k*3,7);p+=_*3;for(var W=Et(P),ae=(1<<W)-1,j=ee(P,W,1),k=0;k<w;){var D=j[Z(
e,p,ae)];p+=D&15;var g=D>>4;if(g<16)b[k++]=g;else{var L=0,R=0;for(g==16?(R=3+Z(e,p,3),p+=2,L=b[k-1]):g==17?(R=3+Z(e,p,7),p+=3):g==18&&(R=11+Z(e,p,127),p+=7);R--;)
b[k++]=L}}var F=b.subarray(0,O),$=b.subarray(O);y=Et(F),v=Et($),f=ee(F,y,1),m=ee($,v,1)}else z(1);else{var g=zt(p)+4,x=e[g-4]|e[g-3]<<8,E=g+x;if(E>o){u&&z(0);break}
i&&l(d+x),r.set(e.subarray(g,E),d),t.b=d+=x,t.p=p=E*8,t.f=c;continue}if(p>S){u&&z(0);break}}i&&l(d+131072);for(var Te=(1<<y)-1,Y=(1<<v)-1,re=p;;re=p){var L=f[Rt(
e,p)&Te],G=L>>4;if(p+=L&15,p>S){u&&z(0);break}if(L||z(2),G<256)r[d++]=G;else if(G==256){re=p,f=null;break}else{var H=G-254;if(G>264){var k=G-257,N=Qe[k];H=Z(e,p,
(1<<N)-1)+Ir[k],p+=N}var X=m[Rt(e,p)&Y],fe=X>>4;X||z(3),p+=X&15;var $=bo[fe];if(fe>3){var N=et[fe];$+=Rt(e,p)&(1<<N)-1,p+=N}if(p>S){u&&z(0);break}i&&l(d+131072);
var he=d+H;if(d<$){var Ge=s-$,He=Math.min($,he);for(Ge+d<0&&z(3);d<He;++d)r[d]=n[Ge+d]}for(;d<he;++d)r[d]=r[d-$]}}t.l=f,t.p=re,t.b=d,t.f=c,f&&(c=1,t.m=y,t.d=m,t.
n=v)}while(!c);return d!=r.length&&a?Ue(r,0,d):r.subarray(0,d)},se=function(e,t,r){r<<=t&7;var n=t/8|0;e[n]|=r,e[n+1]|=r>>8},Pe=function(e,t,r){r<<=t&7;var n=t/
8|0;e[n]|=r,e[n+1]|=r>>8,e[n+2]|=r>>16},Nt=function(e,t){for(var r=[],n=0;n<e.length;++n)e[n]&&r.push({s:n,f:e[n]});var o=r.length,s=r.slice();if(!o)return{t:Ur,
l:0};if(o==1){var a=new C(r[0].s+1);return a[r[0].s]=1,{t:a,l:1}}r.sort(function(E,O){return E.f-O.f}),r.push({s:-1,f:25001});var i=r[0],u=r[1],l=0,c=1,p=2;for(r[0]=
{s:-1,f:i.f+u.f,l:i,r:u};c!=o-1;)i=r[r[l].f<r[p].f?l++:p++],u=r[l!=c&&r[l].f<r[p].f?l++:p++],r[c++]={s:-1,f:i.f+u.f,l:i,r:u};for(var d=s[0].s,n=1;n<o;++n)s[n].s>
d&&(d=s[n].s);var f=new V(d+1),m=Pt(r[c-1],f,0);if(m>t){var n=0,y=0,v=m-t,S=1<<v;for(s.sort(function(O,_){return f[_.s]-f[O.s]||O.f-_.f});n<o;++n){var M=s[n].s;
if(f[M]>t)y+=S-(1<<m-f[M]),f[M]=t;else break}for(y>>=v;y>0;){var g=s[n].s;f[g]<t?y-=1<<t-f[g]++-1:++n}for(;n>=0&&y;--n){var x=s[n].s;f[x]==t&&(--f[x],++y)}m=t}return{
t:new C(f),l:m}},Pt=function(e,t,r){return e.s==-1?Math.max(Pt(e.l,t,r+1),Pt(e.r,t,r+1)):t[e.s]=r},Er=function(e){for(var t=e.length;t&&!e[--t];);for(var r=new V(
++t),n=0,o=e[0],s=1,a=function(u){r[n++]=u},i=1;i<=t;++i)if(e[i]==o&&i!=t)++s;else{if(!o&&s>2){for(;s>138;s-=138)a(32754);s>2&&(a(s>10?s-11<<5|28690:s-3<<5|12305),
s=0)}else if(s>3){for(a(o),--s;s>6;s-=6)a(8304);s>2&&(a(s-3<<5|8208),s=0)}for(;s--;)a(o);s=1,o=e[i]}return{c:r.subarray(0,n),n:t}},Le=function(e,t){for(var r=0,
n=0;n<t.length;++n)r+=e[n]*t[n];return r},$r=function(e,t,r){var n=r.length,o=zt(t+2);e[o]=n&255,e[o+1]=n>>8,e[o+2]=e[o]^255,e[o+3]=e[o+1]^255;for(var s=0;s<n;++s)
e[o+s+4]=r[s];return(o+4+n)*8},Rr=function(e,t,r,n,o,s,a,i,u,l,c){se(t,c++,r),++o[256];for(var p=Nt(o,15),d=p.t,f=p.l,m=Nt(s,15),y=m.t,v=m.l,S=Er(d),M=S.c,g=S.n,
x=Er(y),E=x.c,O=x.n,_=new V(19),w=0;w<M.length;++w)++_[M[w]&31];for(var w=0;w<E.length;++w)++_[E[w]&31];for(var b=Nt(_,7),P=b.t,k=b.l,W=19;W>4&&!P[Ot[W-1]];--W)
;var ae=l+5<<3,j=Le(o,ie)+Le(s,$e)+a,D=Le(o,d)+Le(s,y)+a+14+3*W+Le(_,P)+2*_[16]+3*_[17]+7*_[18];if(u>=0&&ae<=j&&ae<=D)return $r(t,c,e.subarray(u,u+l));var L,R,F,
$;if(se(t,c,1+(D<j)),c+=2,D<j){L=ee(d,f,0),R=d,F=ee(y,v,0),$=y;var Te=ee(P,k,0);se(t,c,g-257),se(t,c+5,O-1),se(t,c+10,W-4),c+=14;for(var w=0;w<W;++w)se(t,c+3*w,
P[Ot[w]]);c+=3*W;for(var Y=[M,E],re=0;re<2;++re)for(var G=Y[re],w=0;w<G.length;++w){var H=G[w]&31;se(t,c,Te[H]),c+=P[H],H>15&&(se(t,c,G[w]>>5&127),c+=G[w]>>12)}}else
L=wo,R=ie,F=So,$=$e;for(var w=0;w<i;++w){var N=n[w];if(N>255){var H=N>>18&31;Pe(t,c,L[H+257]),c+=R[H+257],H>7&&(se(t,c,N>>23&31),c+=Qe[H]);var X=N&31;Pe(t,c,F[X]),
c+=$[X],X>3&&(Pe(t,c,N>>5&8191),c+=et[X])}else Pe(t,c,L[N]),c+=R[N]}return Pe(t,c,L[256]),c+R[256]},Co=new Ut([65540,131080,131088,131104,262176,1048704,1048832,
2114560,2117632]),Ur=new C(0),To=function(e,t,r,n,o,s){var a=s.z||e.length,i=new C(n+a+5*(1+Math.ceil(a/7e3))+o),u=i.subarray(n,i.length-o),l=s.l,c=(s.r||0)&7;if(t){
c&&(u[0]=s.r>>3);for(var p=Co[t-1],d=p>>13,f=p&8191,m=(1<<r)-1,y=s.p||new V(32768),v=s.h||new V(m+1),S=Math.ceil(r/3),M=2*S,g=function(yt){return(e[yt]^e[yt+1]<<
S^e[yt+2]<<M)&m},x=new Ut(25e3),E=new V(288),O=new V(32),_=0,w=0,b=s.i||0,P=0,k=s.w||0,W=0;b+2<a;++b){var ae=g(b),j=b&32767,D=v[ae];if(y[j]=D,v[ae]=j,k<=b){var L=a-
b;if((_>7e3||P>24576)&&(L>423||!l)){c=Rr(e,u,0,x,E,O,w,P,W,b-W,c),P=_=w=0,W=b;for(var R=0;R<286;++R)E[R]=0;for(var R=0;R<30;++R)O[R]=0}var F=2,$=0,Te=f,Y=j-D&32767;
if(L>2&&ae==g(b-Y))for(var re=Math.min(d,L)-1,G=Math.min(32767,b),H=Math.min(258,L);Y<=G&&--Te&&j!=D;){if(e[b+F]==e[b+F-Y]){for(var N=0;N<H&&e[b+N]==e[b+N-Y];++N)
;if(N>F){if(F=N,$=Y,N>re)break;for(var X=Math.min(Y,N-2),fe=0,R=0;R<X;++R){var he=b-Y+R&32767,Ge=y[he],He=he-Ge&32767;He>fe&&(fe=He,D=he)}}}j=D,D=y[j],Y+=j-D&32767}
if($){x[P++]=268435456|kt[F]<<18|Tr[$];var Ee=kt[F]&31,Re=Tr[$]&31;w+=Qe[Ee]+et[Re],++E[257+Ee],++O[Re],k=b+F,++_}else x[P++]=e[b],++E[e[b]]}}for(b=Math.max(b,k);b<
a;++b)x[P++]=e[b],++E[e[b]];c=Rr(e,u,l,x,E,O,w,P,W,b-W,c),l||(s.r=c&7|u[c/8|0]<<3,c-=7,s.h=v,s.p=y,s.i=b,s.w=k)}else{for(var b=s.w||0;b<a+l;b+=65535){var me=b+65535;
me>=a&&(u[c/8|0]=l,me=a),c=$r(u,c+1,e.subarray(b,me))}s.i=a}return Ue(i,0,n+zt(c)+o)},Eo=(function(){for(var e=new Int32Array(256),t=0;t<256;++t){for(var r=t,n=9;--n;)
r=(r&1&&-306674912)^r>>>1;e[t]=r}return e})(),Ro=function(){var e=-1;return{p:function(t){for(var r=e,n=0;n<t.length;++n)r=Eo[r&255^t[n]]^r>>>8;e=r},d:function(){
return~e}}};var No=function(e,t,r,n,o){if(!o&&(o={l:1},t.dictionary)){var s=t.dictionary.subarray(-32768),a=new C(s.length+e.length);a.set(s),a.set(e,s.length),e=a,o.w=s.length}
return To(e,t.level==null?6:t.level,t.mem==null?o.l?Math.ceil(Math.max(8,Math.min(13,Math.log(e.length)))*1.5):20:12+t.mem,r,n,o)},zr=function(e,t){var r={};for(var n in e)
r[n]=e[n];for(var n in t)r[n]=t[n];return r};var Q=function(e,t){return e[t]|e[t+1]<<8},J=function(e,t){return(e[t]|e[t+1]<<8|e[t+2]<<16|e[t+3]<<24)>>>0},_t=function(e,t){return J(e,t)+J(e,t+4)*4294967296},
U=function(e,t,r){for(;r;++t)e[t]=r,r>>>=8};var _o=function(e,t){return((e[0]&15)!=8||e[0]>>4>7||(e[0]<<8|e[1])%31)&&z(6,"invalid zlib data"),(e[1]>>5&1)==+!t&&z(6,"invalid zlib data: "+(e[1]&32?"need":"u\
nexpected")+" dictionary"),(e[1]>>3&4)+2};function Oo(e,t){return No(e,t||{},0,0)}function ko(e,t){return Lr(e,{i:2},t&&t.out,t&&t.dictionary)}function Wr(e,t){return Lr(e.subarray(_o(e,t&&t.dictionary),-4),{i:2},t&&t.out,t&&t.dictionary)}var Dr=function(e,t,r,n){for(var o in e){var s=e[o],a=t+o,i=n;Array.isArray(s)&&(i=zr(n,s[1]),s=s[0]),s instanceof C?r[a]=[s,i]:(r[a+="/"]=[new C(0),i],Dr(s,a,r,
n))}},Nr=typeof TextEncoder<"u"&&new TextEncoder,Lt=typeof TextDecoder<"u"&&new TextDecoder,Io=0;try{Lt.decode(Ur,{stream:!0}),Io=1}catch{}var Po=function(e){for(var t="",
r=0;;){var n=e[r++],o=(n>127)+(n>223)+(n>239);if(r+o>e.length)return{s:t,r:Ue(e,r-1)};o?o==3?(n=((n&15)<<18|(e[r++]&63)<<12|(e[r++]&63)<<6|e[r++]&63)-65536,t+=String.
fromCharCode(55296|n>>10,56320|n&1023)):o&1?t+=String.fromCharCode((n&31)<<6|e[r++]&63):t+=String.fromCharCode((n&15)<<12|(e[r++]&63)<<6|e[r++]&63):t+=String.fromCharCode(
n)}};function Xe(e,t){if(t){for(var r=new C(e.length),n=0;n<e.length;++n)r[n]=e.charCodeAt(n);return r}if(Nr)return Nr.encode(e);for(var o=e.length,s=new C(e.length+
(e.length>>1)),a=0,i=function(c){s[a++]=c},n=0;n<o;++n){if(a+5>s.length){var u=new C(a+8+(o-n<<1));u.set(s),s=u}var l=e.charCodeAt(n);l<128||t?i(l):l<2048?(i(192|
l>>6),i(128|l&63)):l>55295&&l<57344?(l=65536+(l&1047552)|e.charCodeAt(++n)&1023,i(240|l>>18),i(128|l>>12&63),i(128|l>>6&63),i(128|l&63)):(i(224|l>>12),i(128|l>>
6&63),i(128|l&63))}return Ue(s,0,a)}function Wt(e,t){if(t){for(var r="",n=0;n<e.length;n+=16384)r+=String.fromCharCode.apply(null,e.subarray(n,n+16384));return r}else{
if(Lt)return Lt.decode(e);var o=Po(e),s=o.s,r=o.r;return r.length&&z(8),s}}var Lo=function(e,t){return t+30+Q(e,t+26)+Q(e,t+28)},$o=function(e,t,r){var n=Q(e,t+28),o=Wt(e.subarray(t+46,t+46+n),!(Q(e,t+8)&2048)),s=t+46+n,a=J(e,t+20),i=r&&
a==4294967295?Uo(e,s):[a,J(e,t+24),J(e,t+42)],u=i[0],l=i[1],c=i[2];return[Q(e,t+10),u,l,o,s+Q(e,t+30)+Q(e,t+32),c]},Uo=function(e,t){for(;Q(e,t)!=1;t+=4+Q(e,t+2))
;return[_t(e,t+12),_t(e,t+4),_t(e,t+20)]},$t=function(e){var t=0;if(e)for(var r in e){var n=e[r].length;n>65535&&z(9),t+=n+4}return t},_r=function(e,t,r,n,o,s,a,i){
var u=n.length,l=r.extra,c=i&&i.length,p=$t(l);U(e,t,a!=null?33639248:67324752),t+=4,a!=null&&(e[t++]=20,e[t++]=r.os),e[t]=20,t+=2,e[t++]=r.flag<<1|(s<0&&8),e[t++]=
o&&8,e[t++]=r.compression&255,e[t++]=r.compression>>8;var d=new Date(r.mtime==null?Date.now():r.mtime),f=d.getFullYear()-1980;if((f<0||f>119)&&z(10),U(e,t,f<<25|
d.getMonth()+1<<21|d.getDate()<<16|d.getHours()<<11|d.getMinutes()<<5|d.getSeconds()>>1),t+=4,s!=-1&&(U(e,t,r.crc),U(e,t+4,s<0?-s-2:s),U(e,t+8,r.size)),U(e,t+12,
u),U(e,t+14,p),t+=16,a!=null&&(U(e,t,c),U(e,t+6,r.attrs),U(e,t+10,a),t+=14),e.set(n,t),t+=u,p)for(var m in l){var y=l[m],v=y.length;U(e,t,+m),U(e,t+2,v),e.set(y,
t+4),t+=4+v}return c&&(e.set(i,t),t+=c),t},zo=function(e,t,r,n,o){U(e,t,101010256),U(e,t+8,r),U(e,t+10,r),U(e,t+12,n),U(e,t+16,o)};function Fr(e,t){t||(t={});var r={},n=[];Dr(e,"",r,t);var o=0,s=0;for(var a in r){var i=r[a],u=i[0],l=i[1],c=l.level==0?0:8,p=Xe(a),d=p.length,f=l.comment,m=f&&
Xe(f),y=m&&m.length,v=$t(l.extra);d>65535&&z(11);var S=c?Oo(u,l):u,M=S.length,g=Ro();g.p(u),n.push(zr(l,{size:u.length,crc:g.d(),c:S,f:p,m,u:d!=a.length||m&&f.length!=
y,o,compression:c})),o+=30+d+v+M,s+=76+2*(d+v)+(y||0)+M}for(var x=new C(s+22),E=o,O=s-o,_=0;_<n.length;++_){var p=n[_];_r(x,p.o,p,p.f,p.u,p.c.length);var w=30+p.
f.length+$t(p.extra);x.set(p.c,p.o+w),_r(x,o,p,p.f,p.u,p.c.length,p.o,p.m),o+=16+w+(p.m?p.m.length:0)}return zo(x,o,n.length,O,E),x}function Br(e,t){for(var r={},n=e.length-22;J(e,n)!=101010256;--n)(!n||e.length-n>65558)&&z(13);var o=Q(e,n+8);if(!o)return{};var s=J(e,n+16),a=s==4294967295||o==
65535;if(a){var i=J(e,n-12);a=J(e,i)==101075792,a&&(o=J(e,i+32),s=J(e,i+48))}for(var u=t&&t.filter,l=0;l<o;++l){var c=$o(e,s,a),p=c[0],d=c[1],f=c[2],m=c[3],y=c[4],
v=c[5],S=Lo(e,v);s=y,(!u||u({name:m,size:d,originalSize:f,compression:p}))&&(p?p==8?r[m]=ko(e.subarray(S,S+d),{out:new C(f)}):z(14,"unknown compression type "+p):
r[m]=Ue(e,S,S+d))}return r}var we=["pursuer","evader"];var Dt=4,jr=new Map;function Gr(e,t){let r=jr.get(e);if(r)return r;let n=new Float32Array;try{let o=Do(Fo(e),t);o.every(Number.isFinite)&&(n=o)}catch(o){if(!(o instanceof
DOMException||o instanceof RangeError||Wo(o)))throw o}return jr.set(e,n),n}var Wo=e=>e instanceof Error&&"code"in e;function Do(e,t){let r=Wr(e),n=r.length/Dt,o=new Uint8Array(
r.length);for(let a=0;a<o.length;a++)o[a]=r[a%Dt*n+Math.floor(a/Dt)];let s=new Uint32Array(o.buffer);for(let a=t;a<s.length;a++)s[a]^=s[a-t];return new Float32Array(
o.buffer)}function Fo(e){let t=atob(Ft(e)),r=new Uint8Array(t.length);for(let n=0;n<r.length;n++)r[n]=t.charCodeAt(n);return r}function Ft(e){return document.getElementById(
e)?.textContent??""}function h(e,t={},...r){return Bo(document.createElement(e),t,r)}function Bo(e,t,r){for(let[n,o]of Object.entries(t))o==null||o===!1||(typeof o=="function"?e.addEventListener(n.slice(2),o):e.setAttribute(n,o===!0?"":String(o)));
return e.append(...r.filter(jo).map(n=>typeof n=="number"?String(n):n)),e}function jo(e){return e!=null&&e!==!1}var xe=(e,t)=>e<t?`pursuer_${e}`:`evader_${e-t}`,Bt=["stay","north","east","south","west","northeast","southeast","southwest","northwest"];var Go=matchMedia("(prefers-color-scheme: dark)");function Ho(){let e=document.documentElement.dataset.theme;return e?e==="dark":Go.matches}function Vo(){document.
documentElement.dataset.theme=Ho()?"light":"dark"}function Hr(){return h("button",{type:"button",title:"Light or dark (D)","aria-label":"Light or dark",onclick:Vo},"◐")}var Se=[[0,0],[-1,0],[0,1],[1,0],[0,-1],[-1,1],[1,1],[1,-1],[-1,-1]];function Vr(e,t,r){let[n,o]=[t[0]-e[0],t[1]-e[1]];return!r&&Math.abs(n)>Math.abs(o)?o=0:r||
(n=0),Se.findIndex(([s,a])=>s===Math.sign(n)&&a===Math.sign(o))}var pe=(e,t)=>t<e.nPursuers,T=(e,t)=>[e.positions[2*t],e.positions[2*t+1]],Yo=(e,t)=>e[0]===t[0]&&
e[1]===t[1],jt=({rows:e,cols:t},[r,n])=>r>=0&&n>=0&&r<e&&n<t,Gt=(e,t,r=3)=>e!==void 0&&[0,1,2].slice(0,r).some(n=>e[3*t+n]),Ht=(e,t)=>Gt(e.fault,t),Yr=(e,t)=>!Ht(
e,t)&&Gt(e.involved,t,2);function tt(e,t,r){let n=!Yo(T(e,r),T(t,r)),o=t.involved===void 0||Gt(t.involved,r);return!!(t.alive[r]&&t.actions?.[r]&&!n&&o)}function rt(e,t,r){
let[n,o]=T(e,r),[s,a]=Se[t.actions?.[r]??0];return[n+s,o+a]}function nt(e,t,r){return Array.from({length:r.everCaptured.length},(o,s)=>s).filter(o=>r.everCaptured[o]&&
!t.everCaptured[o]).map(o=>e.nPursuers+o)}function ot(e,t){return Array.from({length:t.alive.length},(n,o)=>o).filter(n=>e.alive[n]&&!t.alive[n])}var qo={SIMULTANEOUS:0,SWARM_TURNS:1,AGENT_TURNS:2};function Kt(e,t,r){return{rows:e.rows,cols:e.cols,nPursuers:e.n_pursuers,fov:e.fov,interaction:qo[e.rules.interaction],
obstacles:t,moments:r}}function st(e,t){return{positions:e.read("last_positions"),alive:e.read("alive"),captured:e.read("captured"),everCaptured:e.read("ever_ca\
ptured"),actions:t,involved:e.read("involved"),fault:e.read("fault"),contested:e.conflicts().map(r=>r.cell)}}var ze=class{config;start;recording;actions=[];#e;#o;#r=[[]];constructor(t,r,n){[this.config,this.start]=[r,n],this.#e=t.world(r),this.#e.reset(n),this.#o=[st(this.#e)],
this.recording=Kt(r,this.#e.map(),this.#o)}get length(){return this.actions.length}get over(){return this.#e.over}get statistics(){return{capture_rate:this.#e.read(
"capture_rate")[0]}}conflicts(t){return this.#r[t]}play(t){this.#e.step(t),this.#i(t)}step(t,r,n){let[o,s]=[this.#e,this.config.n_pursuers],a=new Uint8Array(o.n_agents);
for(let i=o.n_turns;i>0&&!o.over;--i){let[u,l]=o.actors;u<s&&(a=o.decide(t.pursuer,[u,Math.min(l,s)],a)),l>s&&(a=o.decide(t.evader,[Math.max(u,s),l],a)),typeof n==
"number"?a[r]=n:u<=r&&r<l&&(a=o.decide(n,[r,r+1],a)),o.playTurn(a)}this.#i(a)}#i(t){this.actions.push(t),this.#o.push(st(this.#e,t)),this.#r.push(this.#e.conflicts())}};
function Kr(e,t,r,n){let o=new ze(e,t,r);for(let s of n)o.play(s);return o}var de=(e,t)=>we[+(t>=e.n_pursuers)];function qt(e,t){let r=new ze(e,t.config,{seed:t.seed,episode:t.episode});for(let n of t.moves)r.over||r.step(t.policies,t.
seat,n);return r}function le(e,t){let{moments:r,nPursuers:n}=e.recording,o=r.findIndex(({alive:a,captured:i})=>!a[t]||!!i[t-n]),s=o<0?e.length:o;return{lasted:s,
out:o>=0,captured:Array.from(r[s].everCaptured).filter(Boolean).length}}var at=(e,t)=>e.over||le(e,t).out;function qr(e,t,r){let n=qt(e,{...t,moves:t.moves.slice(
0,t.from)});for(;!at(n,t.seat);)n.step(t.policies,t.seat,r);return le(n,t.seat)}function it(e){let t=e.length-1;return[...new Set([0,Math.round(t/3),t])].map(r=>e[r])}
function Zr(e,{seat:t,from:r,moves:n}){let o={...e,seat:t,...r?{from:r}:{},moves:n.join("")};return`${location.href.split("#")[0]}#${Object.entries(o).map(([s,a])=>`${s}\
=${a}`).join("&")}`}function Jr(e,t){let[r,n,o]=[e.get("seat")??"",e.get("from")??"0",e.get("moves")??""];return/^\d{1,6}$/.test(r)&&Number(r)<t.n_pursuers+t.n_evaders&&
(t.diagonal?/^[0-8]+$/:/^[0-4]+$/).test(o)&&o.length<=t.max_steps&&/^\d{1,6}$/.test(n)&&Number(n)<=o.length?{seat:Number(r),from:Number(n),moves:[...o].map(Number)}:
null}var lt=()=>crypto.getRandomValues(new BigUint64Array(1))[0];function Xr(e,t,r,n){let o=de(r.config,r.seat)==="evader",s=o?r.config.max_steps:r.config.n_evaders,a=h("table",{class:"numbers"},h("caption",{},o?"Steps in you\
r seat: same start, same others":"Captures of your team: same start, same others")),i=l=>{let[c,p]=[h("span",{class:o?"bar evader":"bar pursuer"}),h("td",{},"…")];
return a.append(h("tr",{},h("th",{scope:"row"},l),h("td",{class:"track","aria-hidden":"true"},c),p)),({lasted:d,captured:f})=>{c.style.width=`${100*(o?d:f)/s}%`,
p.textContent=String(o?d:f)}};i("You")(le(t,r.seat));for(let{name:l,policy:c}of n){let p=i(l);setTimeout(()=>p(qr(e,r,c())))}let u=r.from?`You took over at step\
 ${r.from}. `:"";return h("div",{},a,h("p",{class:"small muted"},`${u}One match: luck has its part in it.`))}var Zo=20,Zt=60;function Jo(e){let t=e.rules.capture==="SURROUND"?8:4,r=typeof e.obstacles!="number",n=o=>r?o:Math.min(o,Zo);return{...e,rows:n(e.rows),cols:n(e.
cols),max_steps:Zt,n_evaders:1,n_pursuers:Math.min(e.n_pursuers,t)}}function ut(e,t,r){let[n,o,s]=[Jo(t),it(r),[]],a=()=>`${s.reduce((u,l)=>u+l,0)} of ${Zt*o.length}`,
i=()=>e.play({title:`Can you escape? Round ${s.length+1} of ${o.length}: ${o[s.length].name}`,played:{config:n,seed:lt(),episode:0,seat:n.n_pursuers,from:0,moves:[],
policies:{pursuer:o[s.length].policy(),evader:"still"}},ending:u=>{s.push(le(u,n.n_pursuers).lasted);let l=o.map(({name:p},d)=>h("tr",{},h("th",{scope:"row"},p),
h("td",{},s[d]??""))),c=s.length<o.length;return[h("table",{class:"numbers"},h("caption",{},`Steps of ${Zt} in each round`),...l),h("p",{class:"play-score"},c?"\
Score so far: ":"Your score: ",h("strong",{},a())),c?h("button",{type:"button",class:"primary",onclick:i},"Next round"):""]},again:()=>ut(e,t,r),link:()=>null});
i()}var Xo={"|b1":e=>new Uint8Array(e),"|i1":e=>new Int8Array(e),"<i4":e=>new Int32Array(e),"<i8":e=>Int32Array.from(new BigInt64Array(e),Number),"<f4":e=>new Float32Array(
e)},en="NUMPY\0",Ae=en.length+2,Qr=64;function tn(e){return Fr(Object.fromEntries(Object.entries(e).map(([t,r])=>[`${t}.npy`,Qo(r)])))}function Qo({dtype:e,shape:t,
data:r}){let n=typeof r=="string"?Array.from(r,c=>c.codePointAt(0)):null,o=t.map(c=>`${c}, `).join(""),s=`{'descr': '${n?`<U${n.length}`:e}', 'fortran_order': F\
alse, 'shape': (${o}), }`,a=Math.ceil((Ae+s.length+1)/Qr)*Qr-Ae,i=en+String.fromCharCode(a&255,a>>8)+s.padEnd(a-1)+`
`,u=n?Int32Array.from(n):r,l=new Uint8Array(i.length+u.byteLength);return l.set(Xe(i,!0)),l.set(new Uint8Array(u.buffer,u.byteOffset,u.byteLength),i.length),l}function rn(e){
return Object.fromEntries(Object.entries(Br(e)).map(([t,r])=>[t.replace(/\.npy$/,""),es(r)]))}function es(e){let t=Ae+e[Ae-2]+256*e[Ae-1],r=Wt(e.subarray(Ae,t),
!0),n=/'descr': '([^']+)', 'fortran_order': False, 'shape': \(([\d, ]*)\)/.exec(r),[o,s]=[n?.[1]??"",(n?.[2]??"").split(",").filter(l=>l.trim()).map(Number)],a=e.
slice(t).buffer,i=o.startsWith("<U")&&String.fromCodePoint(...new Int32Array(a)),u=i===!1?Xo[o]?.(a):i.replace(/\0+$/,"");if(u===void 0)throw new TypeError(`exp\
ected an array of numbers or a text, got ${r.slice(0,80)}`);return{dtype:o,shape:s,data:u}}var Jt="matrixworld episode 3";function nn(e,t,r){let{config:n,actions:o,length:s,recording:a}=t,[i,u]=[n.n_pursuers+n.n_evaders,n.n_evaders],l={positions:["<i4",
i,2],last_positions:["<i4",i,2],alive:["|b1",i],captured:["|b1",u],ever_captured:["|b1",u]},c={rewards:["<f4",i],involved:["|b1",i,3],fault:["|b1",i,3]},p={},d=g=>{
for(let x of Object.keys(g))(p[x]??=[]).push(Array.from(f.read(x),Number))},f=e.world(n);f.reset(t.start);let m=[];d(l);for(let g of o)f.step(g),d({...l,...c}),
m.push(...f.conflictTable());f.free();let y={"<i4":Int32Array,"<f4":Float32Array,"|b1":Uint8Array},v={};for(let[g,[x,...E]]of Object.entries({...l,...c})){let O=s+
+(g in l);v[g]={dtype:x,shape:[O,...E],data:y[x].from((p[g]??[]).flat())}}let S=g=>({dtype:"<i8",shape:[],data:Int32Array.of(g,0)}),M=g=>({dtype:"<U",shape:[],data:g});
return tn({format:M(Jt),n_pursuers:S(n.n_pursuers),config:M(JSON.stringify(n)),seat:S(r),...v,actions:{dtype:"|i1",shape:[s,i],data:Int8Array.from(o.flatMap(g=>[
...g]))},map:{dtype:"|b1",shape:[n.rows,n.cols],data:Uint8Array.from(a.obstacles,Number)},conflict_table:{dtype:"<i4",shape:[m.length/11,11],data:Int32Array.from(
m)}})}function on(e,t){let r=rn(t),n=f=>Array.from(r[f]?.data??[]);if(r.format?.data!==Jt)throw new B(`expected a file marked "${Jt}"`);let o=JSON.parse(r.config.
data),s=o.n_pursuers+o.n_evaders,a=n("positions"),i=(f,m)=>Array.from({length:m-f},(y,v)=>[a[2*(f+v)],a[2*(f+v)+1]]),u={pursuers:i(0,o.n_pursuers),evaders:i(o.n_pursuers,
s),obstacles:Uint8Array.from(n("map"))},l=Uint8Array.from(n("actions")),c=Array.from({length:l.length/s},(f,m)=>l.subarray(m*s,(m+1)*s)),p=Kr(e,o,u,c);if(Array.
from(p.recording.moments.at(-1).positions).join()!==n("last_positions").slice(-2*s).join())throw new B("expected the moves of this start to lead to its end");return{
live:p,seat:n("seat")[0]??null}}var sn=[-.31,0,.31],an=[{size:1,at:[[0,0]]},{size:.62,at:[[-.2,.2],[.2,-.2]]},{size:.54,at:[[-.23,.22],[.23,.22],[0,-.22]]},{size:.54,at:[[-.23,.23],[.23,.23],[
-.23,-.23],[.23,-.23]]},{size:.36,at:sn.flatMap(e=>sn.map(t=>[t,e]))}],ts=.3,rs=.35,ns=.55;function We(e,t){let r=new Map;for(let n=0;n<t.alive.length;n++){if(!t.
alive[n])continue;let[o,s]=T(t,n),a=o*e.cols+s,i=r.get(a);i?i.push(n):r.set(a,[n])}return r}function ln(e,t){let r=Array.from(t.alive,(n,o)=>{let[s,a]=T(t,o);return{
x:a+.5,y:s+.5,size:1,alpha:0}});for(let n of We(e,t).values()){let o=an[Math.min(n.length,an.length)-1];n.forEach((s,a)=>{let[i,u]=o.at[Math.min(a,o.at.length-1)],
l=r[s];l.x+=i,l.y+=u,l.size=o.size,l.alpha=1})}return r}var un=e=>e*e*(3-2*e),Me=(e,t,r)=>e+(t-e)*r,cn=e=>Math.min(1,Math.max(0,e));function pn(e,t,r,n){let o={
1:2,2:r}[e.interaction]??1;if(o===1)return un(n);let s=o===r?t:+!pe(e,t),a=Math.max(1/o,rs);return un(cn((n-s/(o-1)*(1-a))/a))}function ct(e,t){let r=e.moments.
length-1,n=Math.min(Math.floor(t),r),o=e.moments[n],s=ln(e,o);if(n===r||t===n)return s;let a=e.moments[n+1],i=ln(e,a);return s.map((u,l)=>{let c=pn(e,l,s.length,
t-n);return os(o,a,l,u,i[l],c)})}function Xt(e,t,r){let n=e.moments.length-1,o=Math.min(Math.floor(r),n),[s,a]=[e.moments[o],e.moments[Math.min(o+1,n)]],i=pn(e,
t,s.alive.length,r-o),[[u,l],[c,p]]=[T(s,t),T(a,t)];return[Me(l,p,i)+.5,Me(u,c,i)+.5]}function os(e,t,r,n,o,s){let a=n.alpha>o.alpha,i={x:Me(n.x,o.x,s),y:Me(n.y,
o.y,s),size:a?n.size:Me(n.size,o.size,s),alpha:a?cn((1-s)/(1-ns)):Me(n.alpha,o.alpha,s)};if(tt(e,t,r)){let[u,l]=T(e,r),[c,p]=rt(e,t,r),d=ts*Math.sin(Math.PI*s);
i.x+=(p-l)*d,i.y+=(c-u)*d}return i}var dn=2*Math.PI;function De(e,t,r,n){e.beginPath(),e.arc(t,r,n/2,0,dn)}function fn(e,t,r,n){let o=n/2,s=[[0,-.97],[.97,.83],[-.97,.83]].map(([a,i])=>[t+a*o,r+i*
o]);e.beginPath(),e.moveTo((s[2][0]+s[0][0])/2,(s[2][1]+s[0][1])/2),s.forEach(([a,i],u)=>{let[l,c]=s[(u+1)%3];e.arcTo(a,i,l,c,n*.09)}),e.closePath()}function hn(e,t,r,n){
let o=n*.32;e.beginPath(),e.moveTo(t-o,r-o),e.lineTo(t+o,r+o),e.moveTo(t+o,r-o),e.lineTo(t-o,r+o)}function mn(e,t,r,n){e.beginPath();for(let o=0;o<16;o++){let s=n/
2*(o%2?.6:.95),a=dn*o/16;e.lineTo(t+s*Math.sin(a),r-s*Math.cos(a))}e.closePath()}function yn(e,t,r,n,o,s){let a=Math.atan2(o-r,n-t);e.beginPath(),e.moveTo(t,r),
e.lineTo(n,o);for(let i of[-1,1])e.moveTo(n,o),e.lineTo(n-s*Math.cos(a+i*.6),o-s*Math.sin(a+i*.6))}var gn=4,ss=1.6,as=.95,is=5,ls=.16,us=9,cs=.09,ps=.2,vn=.75,K=(e,t)=>e.left+t*e.cell,q=(e,t)=>e.top+t*e.cell;function Ce(e,t,r){return pe(t,r)?e.colors.pursuer:
e.colors.evader}function bn({ctx:e,grid:t,colors:r}){let{left:n,top:o,cell:s,rows:a,cols:i}=t,[u,l]=[i*s,a*s];if(e.fillStyle=r.paper,e.fillRect(n,o,u,l),s<is)return;
e.fillStyle=r.line;let c=Math.max(1,Math.round(s/60));for(let p=1;p<i;p++)e.fillRect(n+p*s,o,c,l);for(let p=1;p<a;p++)e.fillRect(n,o+p*s,u,c)}function wn({ctx:e,
grid:t,colors:r},n){let{left:o,top:s,cell:a,rows:i,cols:u}=t;e.fillStyle=r.obstacle;for(let l=0;l<i*u;l++){if(!n.obstacles[l])continue;let[c,p]=[Math.floor(l/u),
l%u];e.fillRect(o+p*a,s+c*a,a,a)}xn({ctx:e,grid:t,colors:r})}function xn({ctx:e,grid:{left:t,top:r,cell:n,rows:o,cols:s},colors:a}){let i=Math.min(5,Math.max(2,
Math.round(n/18)));e.strokeStyle=a.frame,e.lineWidth=i,e.strokeRect(t-i/2,r-i/2,s*n+i,o*n+i)}function Sn({ctx:e,grid:t,colors:r},n){let{left:o,top:s,cell:a,rows:i,
cols:u}=t,l=a<24*n?5:1;e.font=`500 ${Math.round(Math.min(15*n,Math.max(9*n,a*.32)))}px system-ui, sans-serif`,e.fillStyle=r.muted,e.textBaseline="alphabetic",e.
textAlign="center";let c=5*n+a/40;for(let p=0;p<u;p+=l)e.fillText(String(p),o+(p+.5)*a,s-c);e.textAlign="right",e.textBaseline="middle";for(let p=0;p<i;p+=l)e.fillText(
String(p),o-c,s+(p+.5)*a)}function An({grid:e},t,r,n){let o=Math.floor(t.fov/2)+.5,[s,a]=[Math.max(0,r-o),Math.min(e.cols,r+o)],[i,u]=[Math.max(0,n-o),Math.min(
e.rows,n+o)];return[K(e,s),q(e,i),(a-s)*e.cell,(u-i)*e.cell]}function Mn(e,t,r,n){let{ctx:o,grid:s,colors:a}=e;o.save(),o.beginPath(),o.rect(0,0,o.canvas.width,
o.canvas.height),o.rect(...An(e,t,r,n)),o.clip("evenodd"),o.clearRect(0,0,o.canvas.width,o.canvas.height),o.fillStyle=a.line,o.fillRect(s.left,s.top,s.cols*s.cell,
s.rows*s.cell),o.restore(),xn(e)}function Cn({ctx:e,grid:t,colors:r},{x:n,y:o,alpha:s},a){let i=Math.max(t.cell,16*a)*1.06,[u,l]=[K(t,n),q(t,o)];e.globalAlpha=Math.
max(s,.6),e.beginPath(),e.roundRect(u-i/2,l-i/2,i,i,i*.2),e.strokeStyle=r.focus,e.lineWidth=Math.max(2,2.5*a),e.stroke();let c=Math.max(11*a,Math.min(18*a,t.cell*
.5));e.font=`700 ${Math.round(c)}px system-ui, sans-serif`,e.textAlign="center",e.textBaseline="middle";let p=l-i/2<c*1.2,d=l+(p?1:-1)*(i/2+c*.7);e.strokeStyle=
r.paper,e.lineJoin="round",e.lineWidth=c*.35,e.strokeText("You",u,d),e.fillStyle=r.ink,e.fillText("You",u,d),e.globalAlpha=1}function Tn(e,t,r,n,o){let{ctx:s,grid:a}=e,
i=An(e,t,n,o),u=Ce(e,t,r);s.globalAlpha=.11,s.fillStyle=u,s.fillRect(...i),s.globalAlpha=.8,s.strokeStyle=u,s.lineWidth=Math.max(1,a.cell/24),s.strokeRect(...i),
s.globalAlpha=1}function En(e,t,r,n,o){let{ctx:s,grid:a}=e,i=Math.min(Math.ceil(r),t.moments.length-1),u=t.moments[i];s.lineCap="round",s.lineWidth=Math.min(us,
Math.max(1,a.cell*ls));for(let l=Math.max(1,Math.floor(r-n)+1);l<=i;l++){let[c,p]=[t.moments[l-1],t.moments[l]],d=Math.max(0,Math.min(1,(r-l)/n));s.globalAlpha=
vn+(ps-vn)*d;for(let f=0;f<p.alive.length;f++){let m=l===i&&r<i;if(!c.alive[f]||!(u.alive[f]||m))continue;let y=(pe(t,f)?-1:1)*cs,[v,S]=T(c,f),[M,g]=T(p,f);if(v===
M&&S===g)continue;let x=m?o[f].x:g+.5,E=m?o[f].y:M+.5;s.strokeStyle=Ce(e,t,f),s.beginPath(),s.moveTo(K(a,S+.5+y),q(a,v+.5+y)),s.lineTo(K(a,x+y),q(a,E+y)),s.stroke()}}
s.globalAlpha=1}function Rn(e,t,r){let n=Math.min(Math.ceil(r),t.moments.length-1);for(let o=Math.max(1,n-gn+1);o<=n;o++){let[s,a]=[t.moments[o-1],t.moments[o]],
i=o>r?Math.max(0,1-2*(o-r)):1-(r-o)/gn,u=nt(t,s,a);for(let l of ot(s,a))u.includes(l)||fs(e,T(a,l),i);for(let l of u)ds(e,T(a,l),i)}e.ctx.globalAlpha=1}function ds({
ctx:e,grid:t,colors:r},[n,o],s){e.globalAlpha=s,mn(e,K(t,o+.5),q(t,n+.5),Math.max(8,t.cell*ss)),e.fillStyle=r.capture,e.fill(),e.strokeStyle=r.ink,e.lineWidth=Math.
max(1,t.cell/36),e.lineJoin="round",e.stroke()}function fs({ctx:e,grid:t,colors:r},[n,o],s){e.globalAlpha=s,hn(e,K(t,o+.5),q(t,n+.5),Math.max(7,t.cell*as)),e.strokeStyle=
r.collision,e.lineWidth=Math.max(2,t.cell*.17),e.lineCap="round",e.stroke()}function Nn({ctx:e,grid:t,colors:r},n,o){let s=Math.max(1,t.cell*.07);e.strokeStyle=
e.fillStyle=r.collision,e.lineWidth=Math.max(1,t.cell*.05),e.setLineDash([t.cell*.14,t.cell*.1]);for(let[a,i]of n){if(a<0||i<0||a>=t.rows||i>=t.cols)continue;let u=[
K(t,i)+s,q(t,a)+s,t.cell-2*s,t.cell-2*s];e.globalAlpha=.2*o,e.fillRect(...u),e.globalAlpha=o,e.strokeRect(...u)}e.setLineDash([]),e.globalAlpha=1}function _n({ctx:e,
grid:t,colors:r},n,o,s,a){e.globalAlpha=a,De(e,K(t,n),q(t,o),Math.max(8,t.cell*s*1.02)),e.strokeStyle=r.collision,e.lineWidth=Math.max(1.5,t.cell*.085*Math.sqrt(
s)),e.stroke(),e.globalAlpha=1}var hs=.8,ms=.92,ys=15,gs=7,Qt=9;function On(e,t,r,n,o,s){n.forEach((a,i)=>{a.alpha>0&&vs(e,t,r,i,a,o,s)}),e.ctx.globalAlpha=1;for(let a of We(t,r).values())a.length>
Qt&&bs(e,n[a[Qt-1]],a.length-Qt+1)}function vs(e,t,r,n,o,s,a){let{ctx:i,grid:u,colors:l}=e,c=pe(t,n),[p,d]=[u.left+o.x*u.cell,u.top+o.y*u.cell],f=Math.max(4,u.cell*
o.size*(c?ms:hs)),m=Ce(e,t,n),y=!c&&!!r.captured[n-t.nPursuers];if(i.globalAlpha=o.alpha,(c?fn:De)(i,p,d,f),f>gs*a&&(i.strokeStyle=l.paper,i.lineWidth=Math.max(
2,f*.1),i.stroke()),i.fillStyle=y?l.paper:m,i.fill(),y&&(De(i,p,d,f*.82),i.strokeStyle=m,i.lineWidth=f*.18,i.stroke()),!s||f<ys*a)return;let v=String(c?n:n-t.nPursuers);
i.font=`700 ${Math.round(f*(c?.4:.5)*(v.length>1?.8:1))}px system-ui, sans-serif`,i.textAlign="center",i.textBaseline="middle",i.fillStyle=y?m:l.paper,i.fillText(
v,p,d+f*(c?.17:.03))}function bs({ctx:e,grid:t,colors:r},n,o){let[s,a]=[t.left+n.x*t.cell,t.top+n.y*t.cell];e.font=`700 ${Math.round(t.cell*.3)}px system-ui, sa\
ns-serif`,e.textAlign="center",e.textBaseline="middle",e.strokeStyle=r.paper,e.lineWidth=t.cell*.1,e.strokeText(`+${o}`,s,a),e.fillStyle=r.ink,e.fillText(`+${o}`,
s,a)}var ws=.46,xs=.86,Ss=.66,kn=.48,As=.78,Ms=.58;function In(e,t,r,n){let[o,s]=[t.moments[r-1],t.moments[r]];if(!o)return;let{ctx:a,grid:i,colors:u}=e;a.strokeStyle=
u.collision,a.lineWidth=Math.max(1.5,i.cell*.07),a.lineCap="butt",a.globalAlpha=n;for(let l=0;l<s.alive.length;l++)tt(o,s,l)&&Cs(e,t,T(o,l),rt(o,s,l));a.globalAlpha=
1}function Cs({ctx:e,grid:t},r,n,o){let[s,a]=[o[1]-n[1],o[0]-n[0]],i=p=>K(t,n[1]+.5+s*p),u=p=>q(t,n[0]+.5+a*p),l=jt(r,o)?As:Ms;e.setLineDash([t.cell*.09,t.cell*
.06]),e.beginPath(),e.moveTo(i(kn),u(kn)),e.lineTo(i(l),u(l)),e.stroke(),e.setLineDash([]);let c=.17*t.cell/Math.hypot(s,a);e.beginPath(),e.moveTo(i(l)-a*c,u(l)+
s*c),e.lineTo(i(l)+a*c,u(l)-s*c),e.stroke()}function Pn(e,t,r,n,o,s){let a=Se[s];if(!s||!a)return;let{ctx:i,grid:u,colors:l}=e,c=jt(t,[n[0]+a[0],n[1]+a[1]])?xs:
Ss,p=ws*o.size,d=[K(u,o.x+a[1]*p),q(u,o.y+a[0]*p),K(u,o.x+a[1]*c),q(u,o.y+a[0]*c)],f=Math.max(1.5,u.cell*.085);i.lineCap=i.lineJoin="round";for(let[m,y]of[[l.paper,
f*2.1],[Ce(e,t,r),f]])i.strokeStyle=m,i.lineWidth=y,yn(i,...d,u.cell*.2),i.stroke()}var $n={numbers:!0,axes:!1,trail:6,viewers:[],plan:null,selected:null,cursor:null,you:null,fog:!1};function Un(e,t,r,n,o){let{ctx:s,grid:a,colors:i}=e,u=Math.min(
Math.ceil(r),t.moments.length-1),l=t.moments[u],c=r===u,p=ct(t,r),d=c?1:Math.max(0,1-2*(u-r));s.clearRect(0,0,s.canvas.width,s.canvas.height),bn(e);for(let y of n.
viewers)p[y]?.alpha&&Tn(e,t,y,...Xt(t,y,r));wn(e,t),n.axes&&Sn(e,o),En(e,t,r,n.trail,p),Nn(e,l.contested??[],d),Rn(e,t,r),In(e,t,u,d),p.forEach(({x:y,y:v,size:S},M)=>{
let g=Yr(l,M)?.4:0,x=Ht(l,M)?1:g;x&&_n(e,y,v,S,x*d)});let f=c?l:t.moments[Math.max(0,u-1)];if(On(e,t,f,p,n.numbers,o),c&&n.plan)for(let[y,v]of p.entries())v.alpha&&
Pn(e,t,y,T(l,y),v,n.plan[y]??0);n.you!==null&&(n.fog&&Mn(e,t,...Xt(t,n.you,r)),Cn(e,p[n.you],o)),s.lineWidth=Math.max(2,2.5*o),s.strokeStyle=i.focus;let m=n.selected===
null?void 0:p[n.selected];m?.alpha&&Ln(e,m.x,m.y,m.size*.96),n.cursor&&(s.setLineDash([a.cell*.12,a.cell*.08]),Ln(e,n.cursor[1]+.5,n.cursor[0]+.5,.8),s.setLineDash(
[]))}function Ln({ctx:e,grid:t},r,n,o){let s=o*t.cell;e.beginPath(),e.roundRect(t.left+r*t.cell-s/2,t.top+n*t.cell-s/2,s,s,s*.1),e.stroke()}var zn=(e,t)=>(t+.24)/(e+.24);function Wn(e,t,r,n,o,s){let a=r?28*s:0,i=(l,c)=>(l-a)/(c+2*.12),u=Math.max(1,Math.floor(Math.min(i(n,t),i(o,e))));return{rows:e,cols:t,
cell:u,left:Math.round((n-t*u+a)/2),top:Math.round((o-e*u+a)/2)}}function Dn(e,t,r){let n=Math.floor((r-e.top)/e.cell),o=Math.floor((t-e.left)/e.cell);return n>=
0&&n<e.rows&&o>=0&&o<e.cols?[n,o]:null}var Ts={paper:"--board-paper",line:"--board-line",frame:"--board-frame",ink:"--board-ink",muted:"--board-muted",obstacle:"--board-obstacle",pursuer:"--pursuer",
evader:"--evader",capture:"--capture",collision:"--collision",focus:"--focus"};function Fn(e){let t=getComputedStyle(e),r=Object.entries(Ts).map(([n,o])=>[n,t.getPropertyValue(
o).trim()]);return Object.fromEntries(r)}var dt=()=>matchMedia("(prefers-reduced-motion: reduce)").matches,pt=class{canvas;#e=null;#o=0;#r;#i={rows:1,cols:1,left:0,top:0,cell:1};#t=0;#s;#n;constructor(t,r={}){
this.canvas=t,t.classList.add("board"),t.setAttribute("role","img"),this.#r={...$n,...r},this.#s=new ResizeObserver(()=>this.#p()),this.#s.observe(t),this.#n=new MutationObserver(
()=>this.redraw()),this.#n.observe(document.documentElement,{attributes:!0}),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",this.redraw)}close(){
this.#s.disconnect(),this.#n.disconnect(),matchMedia("(prefers-color-scheme: dark)").removeEventListener("change",this.redraw),cancelAnimationFrame(this.#t)}get look(){
return this.#r}set look(t){this.#r={...this.#r,...t},this.#c(),this.redraw()}get time(){return this.#o}show(t,r){this.#e=t,this.#o=Math.min(Math.max(0,r),t.moments.
length-1),this.#c(),this.redraw()}redraw=()=>{this.#t||(this.#t=requestAnimationFrame(()=>this.drawNow()))};drawNow(){cancelAnimationFrame(this.#t),this.#t=0;let t=this.
canvas.getContext("2d");if(!t||!this.#e)return;let{rows:r,cols:n}=this.#e,o=devicePixelRatio||1;this.#i=Wn(r,n,this.#r.axes,this.canvas.width,this.canvas.height,
o);let s={ctx:t,grid:this.#i,colors:Fn(this.canvas)};Un(s,this.#e,this.#o,this.#r,o)}cellAt(t,r){let n=this.canvas.getBoundingClientRect(),o=this.canvas.width/n.
width;return Dn(this.#i,(t-n.left)*o,(r-n.top)*o)}agentAt(t,r){let n=this.cellAt(t,r);if(!n||!this.#e)return null;let o=this.#e.moments[Math.round(this.#o)],s=We(
this.#e,o).get(n[0]*this.#e.cols+n[1])??[],a=ct(this.#e,Math.round(this.#o)),i=u=>{let[l,c]=this.pointOf(a[u].x,a[u].y);return Math.hypot(l-t,c-r)};return s.length?
s.reduce((u,l)=>i(l)<i(u)?l:u):null}pointOf(t,r){let n=this.canvas.getBoundingClientRect(),o=n.width/this.canvas.width,{left:s,top:a,cell:i}=this.#i;return[n.left+
(s+t*i)*o,n.top+(a+r*i)*o]}#c(){if(!this.#e)return;let{rows:t,cols:r}=this.#e;this.canvas.style.setProperty("--board-aspect",String(zn(t,r)))}#p(){let t=devicePixelRatio||
1,{width:r,height:n}=this.canvas.getBoundingClientRect();this.canvas.width=Math.max(1,Math.round(r*t)),this.canvas.height=Math.max(1,Math.round(n*t)),this.drawNow()}};var Es={now:()=>performance.now(),request:e=>requestAnimationFrame(e),cancel:e=>cancelAnimationFrame(e)},Fe=[.5,1,2,4,8,16,32,64],Bn=0,ft=12,Rs=2,Be=class extends EventTarget{#e;#o;#r;#i;#t=0;#s=0;#n=!1;#c=null;#p=0;#h=[];glide=.28;constructor(t,r={}){
super(),this.#e=t,this.#o=r.speed??4,this.#i=r.still??!1,this.#r=r.clock??Es}get step(){return this.#t}get time(){return this.#i?this.#t:this.#s}get arrived(){return this.#s===
this.#t}get playing(){return this.#n}get length(){return this.#e}set length(t){this.#e=t,this.#t>t&&this.jump(t),this.#l("state")}get marks(){return this.#h}set marks(t){
this.#h=t,this.#l("state")}get pace(){return this.#o||Math.max(Rs,this.#e/ft)}get speed(){return this.#o}set speed(t){this.#o=t,this.#l("state")}changeSpeed(t){
let r=Fe.findIndex(n=>n>=this.pace);this.speed=Fe[Math.min(Fe.length-1,Math.max(0,r+t))]}play(){this.#n||!this.#e||(this.#t===this.#e&&this.jump(0),this.#n=!0,this.#l(
"state"),this.#a())}pause(){this.#n&&(this.#n=!1,this.#l("state"))}toggle(){this.#n?this.pause():this.play()}move(t){this.pause();let r=Math.min(this.#e,Math.max(
0,this.#t+t));Math.abs(r-this.#s)>1?this.jump(r):this.#u(r),this.#a()}jump(t){this.#s=Math.min(this.#e,Math.max(0,Math.round(t))),this.#u(this.#s),this.#l("fram\
e")}#u(t){t!==this.#t&&(this.#t=t,this.#l("step"),this.#i&&this.#l("frame"))}#a(){this.#c===null&&(this.#p=this.#r.now(),this.#c=this.#r.request(()=>this.#f()))}#f(){
this.#c=null;let t=this.#r.now();this.#d(Math.min(.25,(t-this.#p)/1e3)),this.#p=t,(!this.#i||this.arrived)&&this.#l("frame"),(this.#n||this.#s!==this.#t)&&(this.#c=
this.#r.request(()=>this.#f()))}#d(t){let r=t;for(;r>0;){if(this.#s===this.#t){if(!this.#n)return;if(this.#t===this.#e)return this.pause();this.#u(this.#t+1)}let n=this.#n?
this.pace:1/this.glide,o=this.#t-this.#s,s=Math.min(Math.abs(o),r*n);r-=s/n,this.#s=s===Math.abs(o)?this.#t:this.#s+Math.sign(o)*s}this.#n&&this.#s===this.#e&&this.
pause()}#l(t){this.dispatchEvent(new Event(t))}};function ht(e,t){if(t.ctrlKey||t.metaKey||t.altKey)return!1;let r=t.shiftKey?10:1,o={" ":()=>e.toggle(),ArrowRight:()=>e.
move(r),ArrowLeft:()=>e.move(-r),Home:()=>e.move(-e.length),End:()=>e.move(e.length),"+":()=>e.changeSpeed(1),"-":()=>e.changeSpeed(-1)}[t.key];return o?.(),o!==
void 0}var Ns={first:"M6 5v14M19 5 9 12l10 7z",back:"M17 5 7 12l10 7z",play:"M7 4.5 19 12 7 19.5z",pause:"M8 5v14M16 5v14",forward:"M7 5l10 7-10 7z",last:"M18 5v14M5 5\
l10 7-10 7z"};function jn(e){let t=document.createElementNS("http://www.w3.org/2000/svg","svg");t.setAttribute("viewBox","0 0 24 24"),t.setAttribute("aria-hidde\
n","true"),t.classList.add("icon");let r=document.createElementNS("http://www.w3.org/2000/svg","path");return r.setAttribute("d",Ns[e]),t.append(r),t}function je(e,t,r,n){
let o=document.createElement("button");return o.type="button",o.className="player-button",o.append(jn(e)),o.ariaLabel=t,o.title=`${t} (${r})`,o.addEventListener(
"click",n),o}function Gn(e){let t=document.createElement("div");t.className="player",t.role="group",t.ariaLabel="Player";let r=je("play","Play","Space",()=>e.toggle()),
n=_s(e),o=h("div",{class:"captures","aria-hidden":"true",title:"Captures"}),s=Os(e),a=document.createElement("output");a.className="player-count",t.append(je("f\
irst","First step","Home",()=>e.move(-e.length)),je("back","Step back","←",()=>e.move(-1)),r,je("forward","Step forward","→",()=>e.move(1)),je("last","Last \
step","End",()=>e.move(e.length)),h("div",{class:"scrub"},o,n),a,s);let i=()=>o.replaceChildren(...e.marks.map(l=>{let c=h("i");return c.style.left=`${100*l/Math.
max(1,e.length)}%`,c})),u=()=>{r.replaceChildren(jn(e.playing?"pause":"play")),r.ariaLabel=e.playing?"Pause":"Play",r.title=`${r.ariaLabel} (Space)`,n.max=String(
e.length),n.value=String(e.step),n.ariaValueText=`step ${e.step} of ${e.length}`,a.textContent=`${e.step} / ${e.length}`,a.style.minWidth=`${2*String(e.length).
length+3}ch`,s.value=String(e.speed)};return e.addEventListener("step",u),e.addEventListener("state",u),e.addEventListener("state",i),t.addEventListener("keydow\
n",l=>{!(l.target instanceof HTMLSelectElement||l.key===" "&&l.target!==n)&&ht(e,l)&&l.preventDefault()}),u(),t}function _s(e){let t=document.createElement("inp\
ut");return t.type="range",t.className="player-scrub",t.min="0",t.step="1",t.ariaLabel="Step",t.addEventListener("input",()=>{e.pause(),e.jump(Number(t.value))}),
t}function Os(e){let t=document.createElement("select");return t.className="player-speed",t.ariaLabel="Speed",t.title=`Steps a second, or the whole in ${ft} s (\
+ and -)`,t.append(new Option(`in ${ft} s`,String(Bn)),...Fe.map(r=>new Option(`${r} / s`,String(r)))),t.addEventListener("change",()=>{e.speed=Number(t.value)}),
t}function Hn(e,t,r){if(r===0)return[{kind:"start",text:ks(e),agents:[]}];let[n,o]=[t.moments[r-1],t.moments[r]],s=c=>xe(c,e.config.n_pursuers),a=nt(t,n,o),i=e.conflicts(
r),u=new Set(i.flatMap(c=>c.doomed)),l=a.map(c=>({kind:"capture",text:`${s(c)} is captured`,agents:[c]}));for(let c of ot(n,o))!a.includes(c)&&!u.has(c)&&l.push(
{kind:"end",text:`${s(c)} disappears`,agents:[c]});return l.push(...i.map(({kind:c,text:p,agents:d})=>({kind:c,text:p,agents:d}))),r===e.length&&l.unshift({kind:"\
end",text:Is(e),agents:[]}),l}function ks({config:e}){return`${e.n_pursuers} pursuers and ${e.n_evaders} evaders on ${e.rows} x ${e.cols} cells, at most ${e.max_steps}\
 steps`}function Is(e){let t=Math.round(e.statistics.capture_rate*e.config.n_evaders);return`The episode ends after ${e.length} steps with ${t} of ${e.config.n_evaders}\
 evaders captured`}var Di=2n**64n-1n;var Yn=()=>["file:","http:","https:"].includes(location.protocol);var Kn=["·","↑","→","↓","←","↗","↘","↙","↖"];var zs={" ":0,s:0,ArrowUp:1,w:1,ArrowRight:2,d:2,ArrowDown:3,x:3,ArrowLeft:4,a:4,e:5,c:6,y:7,z:7,q:8},er=[8,1,5,4,0,2,7,3,6],Ws=[7,8,9,4,5,6,1,2,3],Ds=24,Fs=Math.
tan(Math.PI/8);function Zn(e,t){if(e.ctrlKey||e.metaKey||e.altKey)return;let r=Ws.findIndex(o=>e.code===`Numpad${o}`),n=er[r]??zs[e.key.length===1?e.key.toLowerCase():
e.key];return n!==void 0&&n>4&&!t?void 0:n}function Jn(e){let t=er.map(r=>h("button",{type:"button","aria-label":Bt[r],onclick:()=>e(r)},Kn[r]));return{element:h(
"div",{class:"play-pad",role:"group","aria-label":"Your move"},...t),show:r=>t.forEach((n,o)=>n.classList.toggle("absent",er[o]>4&&!r))}}function qn(e,t,r){let n=Fs*
Math.max(Math.abs(e),Math.abs(t)),o=s=>Math.abs(s)<n?0:s;return Vr([0,0],r?[o(e),o(t)]:[e,t],r)}function Xn(e,t,r){let n=null,{canvas:o}=e;o.addEventListener("p\
ointerdown",({button:s,clientX:a,clientY:i})=>{n=s===0?[a,i]:null}),o.addEventListener("pointercancel",()=>{n=null}),o.addEventListener("pointerup",({clientX:s,
clientY:a})=>{let[i,u]=[n,t()];if(n=null,!i||!u)return;let[l,c]=[s-i[0],a-i[1]],p=e.cellAt(s,a);Math.hypot(l,c)>=Ds?r(qn(c,l,u.diagonal)):p&&r(qn(p[0]-u.cell[0],
p[1]-u.cell[1],u.diagonal))})}function Qn(e,t){let r=n=>{let o=t[n]-e[n],s=Se.findIndex(a=>a[n]===Math.sign(o)&&a[1-n]===0);return o?`${Math.abs(o)} ${Bt[s]}`:""};
return[r(0),r(1)].filter(Boolean).join(", ")||"on your cell"}var Bs=[0,1,2,4,8],mt=class{element;player=new Be(0,{speed:4,still:dt()});#e;#o;#r=h("canvas",{tabindex:0,"aria-describedby":"play-keys"});#i=h("h2");#t=h("p",{
class:"play-told",role:"status"});#s=Jn(t=>this.act(t));#n=h("select",{},...Bs.map(t=>h("option",{value:t},t?`${t} / s`:"step by step")));#c=h("input",{type:"ch\
eckbox"});#p=h("section",{class:"play-ending",tabindex:-1,"aria-labelledby":"play-headline"});#h=Gn(this.player);#u=null;#a=null;#f=[];#d=null;#l=0;#m=0;constructor(t){
this.#e=t,this.#o=new pt(this.#r,{numbers:!1}),this.#r.setAttribute("role","application"),this.#n.addEventListener("change",()=>this.#y()),this.#c.addEventListener(
"change",()=>this.#v()),Xn(this.#o,()=>{let r=this.#d!==null&&this.#a&&T(this.#a.recording.moments.at(-1),this.#d);return r?{cell:r,diagonal:this.#a.config.diagonal}:
null},r=>this.act(r)),this.player.addEventListener("frame",()=>this.#a&&this.#o.show(this.#a.recording,this.player.time)),this.player.addEventListener("step",()=>this.#S()),
this.element=h("div",{class:"play"},h("header",{class:"play-head"},this.#i,this.#t),h("div",{class:"play-stage"},this.#r),h("div",{class:"play-side"},this.#p,this.#s.
element,h("label",{class:"play-choice",title:"Steps a second"},"Pace ",this.#n),h("label",{class:"play-choice"},this.#c," Fog: see only what it sees"),h("p",{class:"\
small muted play-keys",id:"play-keys"},"Arrow keys move and Space stays; Q W E A S D Z X C and the numeric keypad know diagonals, too. On the board: swipe, or t\
ap where to go.")),this.#h)}get played(){return this.#u&&{...this.#u.played,moves:this.#f}}get live(){return this.#a}play(t){this.#g(qt(this.#e,t.played),t.played.
seat,t.title),[this.#u,this.#f,this.#l]=[t,[...t.played.moves],0],this.element.dataset.state="playing",this.#r.focus({preventScroll:!0}),at(this.#a,t.played.seat)&&
this.#w()}watch(t,r,n){this.#u=null,this.#g(t,r,n),this.#x()}stop(){this.#y(),this.player.pause(),this.#u=null}act(t){let[r,n]=[this.#u,this.#a];if(!r||!n||this.
element.dataset.state!=="playing")return;this.#l=t;let o=Number(this.#n.value);this.#m||(this.#b(),o&&this.element.dataset.state==="playing"&&(this.#m=setInterval(
()=>this.#b(),1e3/o)))}key(t){let{target:r,key:n}=t;if(r instanceof HTMLSelectElement||r instanceof HTMLInputElement&&(r.type==="text"||n===" ")||r instanceof HTMLButtonElement&&
(n===" "||n==="Enter")||!this.#a)return!1;if(this.element.dataset.state!=="playing")return ht(this.player,t);let s=Zn(t,this.#a.config.diagonal);return s!==void 0&&
this.act(s),s!==void 0}#g(t,r,n){this.#y(),this.player.pause(),[this.#a,this.#d]=[t,r],this.#i.textContent=n,this.#r.ariaLabel=`Board, ${t.config.rows} by ${t.config.
cols} cells`,this.#s.show(t.config.diagonal),this.#p.replaceChildren(),this.player.length=t.length,this.player.jump(t.length),this.#v(),this.#S()}#v(){this.#o.look=
{you:this.#d,fog:this.#c.checked,viewers:this.#d===null?[]:[this.#d]}}#y(){clearInterval(this.#m),this.#m=0,this.#t.ariaLive=Number(this.#n.value)?"off":"polite"}#b(){
let[{policies:t,seat:r},n]=[this.#u.played,this.#a];n.step(t,r,this.#l),this.#f.push(this.#l),this.player.length=n.length,this.player.glide=Math.min(.22,.9/(Number(
this.#n.value)||4)),this.player.move(n.length-this.player.step),at(n,r)&&this.#w()}#w(){this.#y();let[t,r,n]=[this.#u,this.#a,this.played],o=Yn()?t.link(n):null;
this.#p.replaceChildren(h("h3",{id:"play-headline"},Hs(r,n.seat)),...t.ending(r,n),h("div",{class:"play-buttons"},h("button",{type:"button",class:"primary",onclick:()=>t.
again()},"Again"),h("button",{type:"button",onclick:()=>this.#x()},"Watch it"),h("button",{type:"button",onclick:()=>this.#A(r,n.seat)},"Save"),o&&h("button",{type:"\
button",onclick:({currentTarget:s})=>Ys(s,o)},"Link"))),this.element.dataset.state="ended",this.#p.focus({preventScroll:!0}),this.#p.scrollIntoView({block:"near\
est"})}#x(){this.element.dataset.state="watched",this.player.length=this.#a.length,this.player.jump(0),dt()||this.player.play()}#A(t,r){let n=new Blob([nn(this.#e,
t,r)],{type:"application/octet-stream"});h("a",{href:URL.createObjectURL(n),download:`${xe(r,t.config.n_pursuers)}-${t.length}-steps.npz`}).click()}#S(){let[t,r,
{step:n}]=[this.#a,this.#d,this.player];if(!t||n>t.length)return;let o=Hn(t,t.recording,n).filter(({agents:a})=>r===null||a.includes(r)),s=[`Step ${n} of ${t.config.
max_steps}`,...o.map(({text:a})=>a)];this.#u&&n===0?s.push(js(t.config,r)):r!==null&&s.push(Gs(t,n,r)),this.#t.textContent=s.filter(Boolean).map(a=>`${a}.`).join(
" ")}};function js(e,t){let r=e.rules.capture==="SURROUND";return de(e,t)==="evader"?`Stay free: ${r?"pursuers on all sides of you capture":"a pursuer on your c\
ell captures"} you`:`Capture evaders: ${r?"surround them together":"reach their cell"}`}function Gs({config:e,recording:t},r,n){let o=t.moments[r],a=de(e,n)==="\
pursuer"?"evader":"pursuer";if(!o.alive[n])return"";let i=T(o,n),u=p=>{let[d,f]=T(o,p);return Math.max(Math.abs(d-i[0]),Math.abs(f-i[1]))},l=Array.from({length:o.
alive.length},(p,d)=>d).filter(p=>de(e,p)===a&&o.alive[p]&&!o.captured[p-e.n_pursuers]&&2*u(p)<e.fov);if(!l.length)return`No ${a} in view`;let c=l.reduce((p,d)=>u(
d)<u(p)?d:p);return`Nearest ${a}: ${Qn(i,T(o,c))}`}function Hs(e,t){let[{lasted:r,out:n,captured:o},{config:s}]=[le(e,t),e];return de(s,t)==="pursuer"?`Your tea\
m captured ${o} of ${Vs(s)} in ${r} steps.`:n?`You lasted ${r} of ${s.max_steps} steps.`:`You escaped: ${r} steps.`}var Vs=({n_evaders:e})=>`${e} evader${e===1?
"":"s"}`;function Ys(e,t){let r=h("input",{type:"text",readonly:!0,value:t,"aria-label":"Link to this match"});e.replaceWith(r),r.select(),navigator.clipboard?.
writeText(t).catch(()=>{})}var te=JSON.parse(Ft("data")),ue={pursuer:eo("pursuer"),evader:eo("evader")};function eo(e){let{names:t,scripts:r,network:n}=te.teams[e],o=s=>{let a=r[s];if(a||
!n)return a;let[i,u]=[n.genome_size,r.slice(0,s).filter(l=>l===null).length];return{...n,genome:Gr(e,i).subarray(u*i,(u+1)*i)}};return t.map((s,a)=>({name:s,policy:()=>o(
a)}))}function tr(e,t,r,n){let[o,s]=[te.world,we[+(n.seat>=te.world.n_pursuers)]],a=we.map(u=>ue[u][r[u]].name),i={pursuer:ue.pursuer[r.pursuer].policy(),evader:ue.
evader[r.evader].policy()};t.play({title:`You are ${xe(n.seat,o.n_pursuers)}: pursuers ${a[0]}, evaders ${a[1]}`,played:{config:o,seed:r.seed,episode:0,policies:i,
...n},ending:(u,l)=>[Xr(e,u,l,it(ue[s]))],again:()=>tr(e,t,r,{...n,moves:n.moves.slice(0,n.from)}),link:u=>Zr({pursuers:r.pursuer,evaders:r.evader,seed:r.seed},
u)})}function to(e,t){let r=new URLSearchParams(location.hash.slice(1)),n=Jr(r,te.world),[o,s]=[Number(r.get("pursuers")??NaN),Number(r.get("evaders")??NaN)],a=/^\d{1,20}$/.
test(r.get("seed")??"")?BigInt.asUintN(64,BigInt(r.get("seed"))):null;return!n||a===null||!ue.pursuer[o]||!ue.evader[s]?!1:(tr(e,t,{pursuer:o,evader:s,seed:a},n),
!0)}var ro=(e,t)=>h("select",{},...e.map((r,n)=>h("option",{value:n,selected:n===t},r)));function Ks(e,t){let[r,n,o]=[ro(["an evader","a pursuer"],0),...we.map(
u=>ro(te.teams[u].names,te.teams[u].names.length-1))],s=h("p",{class:"problem",role:"alert"}),a=()=>tr(e,t,{pursuer:Number(n.value),evader:Number(o.value),seed:lt()},
{seat:r.value==="0"?te.world.n_pursuers:0,from:0,moves:[]}),i=h("input",{type:"file",accept:".npz",hidden:!0});return i.addEventListener("change",()=>{let[u]=i.
files??[];s.textContent="",u?.arrayBuffer().then(l=>on(e,new Uint8Array(l))).then(({live:l,seat:c})=>t.watch(l,c,u.name)).catch(l=>s.textContent=`${u.name} hold\
s no match: ${l.message}`),i.value=""}),h("details",{class:"card setup",open:matchMedia("(min-width: 761px)").matches},h("summary",{},"Play something else"),h("\
div",{},h("label",{},"You are ",r),h("label",{},"Pursuers ",n),h("label",{},"Evaders ",o),h("button",{type:"button",class:"primary",onclick:a},"Play"),h("button",
{type:"button",onclick:()=>ut(t,te.world,ue.pursuer)},"Can you escape it?"),h("button",{type:"button",onclick:()=>i.click()},"Open a file"),i,s))}async function qs(){
let e=await Cr(),t=new mt(e);document.getElementById("page").replaceWith(h("header",{class:"top"},h("h1",{},te.title),Hr()),h("main",{},Ks(e,t),h("section",{class:"\
card","aria-label":"Match"},t.element))),document.addEventListener("keydown",r=>t.key(r)&&r.preventDefault()),window.addEventListener("hashchange",()=>to(e,t)),
to(e,t)||ut(t,te.world,ue.pursuer),Object.assign(window,{matrixworldPlay:t})}qs().catch(e=>{throw(document.getElementById("page")??document.body).append(h("p",{
class:"card problem",role:"alert"},`The page could not start: ${e instanceof B?e.message:String(e)}`)),e}).finally(()=>{document.body.dataset.ready="true"});})();
