/* built from web/ by "npm run build"; sources 148b5d616ccd87a97efaf555180ae3c9582d0a3c85029da27a42905bda8ddcba */
"use strict";(()=>{var Qt={SIMULTANEOUS:0,SWARM_TURNS:1,AGENT_TURNS:2},Re={DISAPPEAR:0,REACH:1,BOUNCE:2},er={OCCUPATION:0,SURROUND:1},tr={FAULT:0,INVOLVED:1};var yt=["obstacle","teammate","adversary"],gt=["vertex","edge","chain"],rr=["turn","kind","form","first","second","row","col","at_fault","held","doomed"],vt=["p\
ursuer_{number}","evader_{number}"],nr={obstacle:"{first} ran into the obstacle or border at {cell}",vertex:"{first} and {second} both headed for {cell}",edge:"\
{first} and {second} meant to swap, {first} to {cell}",chain:"{first} headed for {cell}, where {second} had to stay"},Ne={"both held":"both bounce","both doomed":"\
both disappear",held:"{agent} bounces",doomed:"{agent} disappears",none:"nobody is stopped"},or="{event}: {outcome}",bt={random:"any action, all equally likely",
still:"always stays",chaser:"moves to where the nearest adversary in view is nearest",fleer:"moves to where the nearest adversary in view is farthest","clumsy-c\
haser":"a chaser that takes any action in half of the steps",hunter:"a chaser of the nearest adversary in view to which no teammate in view is nearer",surrounder:"\
a chaser of the nearest free cell beside an adversary without a teammate","clumsy-fleer":"a fleer that takes any action in half of the steps",dodger:"moves to w\
here all adversaries in view together are farthest"},sr={free:".GS",blocked:"#@OTW"};var ge=1+rr.length;function Oe(e,t){return e.replace(/\{(\w+)\}/g,(r,n)=>String(t[n]))}function q(e,t){return e<t?Oe(vt[0],{number:e}):Oe(vt[1],{number:e-t})}function to(e,t){
let[r,n,o,s,a,i,u,...l]=Array.from(e),c=a<0?[s]:[s,a],[f,p,m]=l.map(A=>c.filter((M,g)=>A>>g&1)),d=c.map(A=>q(A,t)),y=Oe(nr[a<0?"obstacle":gt[o]],{first:d[0],second:d[d.
length-1],cell:`(${i}, ${u})`}),v=Oe(or,{event:y,outcome:ro(c.length,p,m,t)});return{kind:yt[n],form:gt[o],agents:c,cell:[i,u],at_fault:f,held:p,doomed:m,turn:r,
text:v}}function ro(e,t,r,n){if(e===2&&t.length===2)return Ne["both held"];if(e===2&&r.length===2)return Ne["both doomed"];let o=s=>a=>Oe(Ne[s],{agent:q(a,n)});
return[...t.map(o("held")),...r.map(o("doomed"))].join(", ")||Ne.none}function je(e,t){let r=[];for(let n=0;n<e.length;n+=ge)r.push(to(e.subarray(n+1,n+ge),t));
return r}var Y=class extends Error{name="EngineError"};function I(e,t,r){let n=typeof r=="string"?`'${r}'`:typeof r=="object"?JSON.stringify(r):String(r);return new Y(`${e}\
: expected ${t}, got ${n}`)}var ve=class{bytes;constructor(t){this.bytes=t}},lr=0,xt=[Uint8Array,Uint8Array,Int32Array,BigInt64Array,BigUint64Array,Float32Array,Float64Array],ar=4,ir=4,no=new TextEncoder,
oo=new TextDecoder;function so(e){for(let t=xt.length-1;t>lr;--t)if(e instanceof xt[t])return t;throw new TypeError("array: expected a typed array of the engine\
's numbers, got another")}function wt(e){return new Uint8Array(e.buffer,e.byteOffset,e.byteLength)}function ao(e){return no.encode(`${e}\0`)}var At=class{engine;addresses=[];constructor(t){
this.engine=t}copy(t){let r=this.engine._malloc(Math.max(t.length,1));if(r===0)throw new Y("memory: expected room for the arguments, got none");return this.addresses.
push(r),this.engine.HEAPU8.set(t,r),r}text(t){return this.copy(ao(t))}arrays(t){let r=Object.entries(t),n=r.flatMap(([s,a])=>{let i=a instanceof ve,u=i?a.bytes:
a;return[this.text(s),i?lr:so(u),u.length,this.copy(wt(u))]}),o=this.copy(wt(Int32Array.from(n)));return this.copy(wt(Int32Array.of(r.length,o)))}free(){for(let t of this.
addresses)this.engine._free(t)}};function ur(e,t){let r=e.HEAPU8;return oo.decode(r.subarray(t,r.indexOf(0,t)))}function Ve(e){let t=new Int32Array(e.HEAPU8.buffer),
r=e._last_outputs()/ar,n=t[r+1]/ar,o={};for(let s=n;s<n+t[r]*ir;s+=ir){let a=xt[t[s+1]],i=t[s+2]*a.BYTES_PER_ELEMENT,u=t[s+3];o[ur(e,t[s])]=new a(e.HEAPU8.slice(
u,u+i).buffer)}return o}function ke(e,t){let r=new At(e);try{let n=t(r);if(n===0)throw new Y(ur(e,e._last_error()));return n}finally{r.free()}}var io=2**31-1,lo=2n**64n-1n,uo=34028234663852886e22;function oe(e,t){if(typeof t!="number"||!Number.isInteger(t)||Math.abs(t)>io)throw I(e,"an integer",t);return Int32Array.
of(t)}function Ye(e,t){if(typeof t!="boolean")throw I(e,"true or false",t);return new ve(Uint8Array.of(Number(t)))}function fe(e,t,r){let n=typeof t=="string"&&
Object.hasOwn(r,t)?r[t]:void 0;if(n===void 0)throw I(e,`one of ${Object.keys(r).join(", ")}`,t);return Int32Array.of(n)}function St(e,t){if(typeof t!="number"||
!(Math.abs(t)<=uo))throw I(e,"a finite number",t);return t}function be(e,t){let n=typeof t=="bigint"||typeof t=="number"&&Number.isSafeInteger(t)?BigInt(t):-1n;
if(n<0n||n>lo)throw I(e,"an integer from 0 to 2^64 - 1",t);return BigUint64Array.of(n)}function co(e){return{"rules.interaction":fe("interaction",e.interaction,
Qt),"rules.obstacle":fe("obstacle",e.obstacle,Re),"rules.teammate":fe("teammate",e.teammate,Re),"rules.evader":fe("evader",e.evader,Re),"rules.pursuer":fe("purs\
uer",e.pursuer,Re),"rules.capture":fe("capture",e.capture,er),"rules.captured_disappear":Ye("captured_disappear",e.captured_disappear)}}function cr(e,t){let r=typeof t==
"number"?[t,t,t]:t;if(!Array.isArray(r)||r.length!==3)throw I(e,"1 or 3 numbers",t);return Float32Array.from(r,n=>St(e,n))}function fo(e){let t=(r,n)=>Float32Array.
of(St(r,e[r]),St(n,e[n]));return{"rewards.capture":t("pursuer_capture","evader_capture"),"rewards.neighbor":t("pursuer_neighbor","evader_neighbor"),"rewards.ste\
p":t("pursuer_step","evader_step"),"rewards.pursuer_collide":cr("pursuer_collide",e.pursuer_collide),"rewards.evader_collide":cr("evader_collide",e.evader_collide),
"rewards.blame":fe("blame",e.blame,tr),"rewards.capture_repeats":Ye("capture_repeats",e.capture_repeats)}}function pr(e){if(e===void 0||typeof e=="number")return new Uint8Array(
0);if(e instanceof Uint8Array)return e;let{free:t,blocked:r}=sr;for(let[n,o]of e.entries()){if(o.length!==e[0]?.length)throw I(`map, row ${n}`,`${e[0]?.length} \
cells as in row 0`,o.length);let s=[...o].find(a=>!t.includes(a)&&!r.includes(a));if(s)throw I(`map, row ${n}`,`'${t}' (free) or '${r}' (obstacle)`,s)}return Uint8Array.
from([...e.join("")],n=>Number(r.includes(n)))}function mr(e,t){if(!Array.isArray(e))return;let r=[e.length,e[0]?.length??0];if(!(r[0]===t.rows&&r[1]===t.cols))
throw I("obstacle map",`shape (${t.rows}, ${t.cols}), the rows and cols`,r)}function Ke(e){mr(e.obstacles,e);let t=typeof e.obstacles=="number"?e.obstacles:0;return{
...co(e.rules),...fo(e.rewards),rows:oe("rows",e.rows),cols:oe("cols",e.cols),n_pursuers:oe("n_pursuers",e.n_pursuers),n_evaders:oe("n_evaders",e.n_evaders),fov:oe(
"fov",e.fov),diagonal:Ye("diagonal",e.diagonal),max_steps:oe("max_steps",e.max_steps),density:Float64Array.of(t),map:pr(e.obstacles)}}function fr(e,t){return Int32Array.
from((t??[]).flat(),r=>oe(e,r)[0])}function hr(e,t){return mr(e.obstacles,t),{seed:be("seed",e.seed??0n),episode:be("episode",e.episode??0),pursuers:fr("pursuer\
s",e.pursuers),evaders:fr("evaders",e.evaders),map:pr(e.obstacles)}}function Ze(e){return{actions:Int32Array.from(e,t=>oe("actions",t)[0])}}function we(e){if(typeof e==
"string"){if(!Object.hasOwn(bt,e))throw I("policy",`one of ${Object.keys(bt).join(", ")}`,e);return{script:new TextEncoder().encode(e)}}if(e.activation!=="relu"&&
e.activation!=="tanh")throw I("activation","'relu' or 'tanh'",e.activation);return{hidden:Int32Array.from(e.hidden,t=>oe("hidden",t)[0]),activation:new TextEncoder().
encode(e.activation),sampled:Ye("sampled",e.sampled),genome:e.genome}}var po=["first_turn","terminated","truncated"];function dr(e){let t={...e};for(let r of po)
t[r]=new ve(e[r]);return t}var qe=class{config;seed;episode;n_agents;statistics;first_conflict;constructor(t,r,n,o){this.config=t,this.seed=r,this.episode=n,this.n_agents=t.n_pursuers+t.n_evaders,
this.statistics=yr(o,0),Object.assign(this,o),this.first_conflict=mo(this.conflict_table,this.length)}get length(){return this.actions.length/this.n_agents}conflicts(t){
this.check(t);let[r,n]=[this.first_conflict[t],this.first_conflict[t+1]],o=this.conflict_table.subarray(r*ge,n*ge);return je(o,this.config.n_pursuers)}seek(t,r){
this.check(r),(!(t.seed===this.seed&&t.episode===BigInt(this.episode))||t.turn!==0||t.steps>r)&&t.reset({seed:this.seed,episode:this.episode});for(let o=t.steps;o<
r;++o)t.step(this.actions.subarray(o*this.n_agents,(o+1)*this.n_agents))}check(t){if(!(Number.isInteger(t)&&t>=0&&t<=this.length))throw I("step",`0 to ${this.length}`,
t)}};function mo(e,t){let r=new Int32Array(t+2);for(let n=0;n<e.length;n+=ge)++r[e[n]+1];for(let n=1;n<r.length;++n)r[n]+=r[n-1];return r}function yr(e,t){let r=e["\
statistics.length"].length,n=s=>{let a=e[`statistics.${s}`],i=a.length/r;return a.slice(t*i,(t+1)*i)},o=s=>Number(n(s)[0]);return{capture_rate:o("capture_rate"),
ever_capture_rate:o("ever_capture_rate"),captured_fraction:o("captured_fraction"),length:o("length"),return:n("return"),survivors:n("survivors"),overlap:n("over\
lap"),collisions:n("collisions"),faults:n("faults"),agent_steps:n("agent_steps")}}function gr(e,t,r,n){let o=[Ke(r.config),we(r.pursuers),we(r.evaders),n];return ke(
e,s=>{let[a,i,u,l]=o.map(c=>s.arrays(c));return e[t](a,i,u,l)}),Ve(e)}function vr(e,t,r,n){let o={seed:be("seed",r),episode:be("episode",n)};return new qe(t.config,
r,n,gr(e,"_play_match",t,o))}function br(e,t,r,n){if(!Number.isInteger(n)||n<1)throw I("n_episodes","at least 1",n);let o={seed:be("seed",r),n_episodes:Int32Array.
of(n)},s=gr(e,"_play_rollout",t,o);return Array.from({length:n},(a,i)=>yr(s,i))}var wr=new FinalizationRegistry(([e,t])=>e._world_free(t)),Ie=class{config;n_agents;n_actions;engine;at;freed=!1;constructor(t,r){this.engine=t,this.config=r,this.
n_agents=r.n_pursuers+r.n_evaders,this.n_actions=r.diagonal?9:5,this.at=ke(t,n=>t._world_new(n.arrays(Ke(r)))),wr.register(this,[t,this.at],this)}free(){this.freed||
(this.freed=!0,wr.unregister(this),this.engine._world_free(this.at))}reset(t={}){let r=hr(t,this.config);this.call(n=>this.engine._world_reset(this.at,n.arrays(
r)))}step(t){let r=Ze(t);this.call(n=>this.engine._world_step(this.at,n.arrays(r)))}playTurn(t){let r=Ze(t);this.call(n=>this.engine._world_play_turn(this.at,n.
arrays(r)))}decide(t,r,n){let{n_pursuers:o}=this.config,s={pursuer:[0,o],evader:[o,this.n_agents]},[a,i]=typeof r=="string"?s[r]:r;if(n.length!==this.n_agents)throw I(
"actions",String(this.n_agents),n.length);let u=[we(t),Ze(n)],{actions:l}=this.call(c=>this.engine._world_decide(this.at,c.arrays(u[0]),a,i,c.arrays(u[1])));return Uint8Array.
from(l)}get n_turns(){return this.turnNumbers()[1]}get turn(){return this.turnNumbers()[0]}get actors(){let[,,t,r]=this.turnNumbers();return[t,r]}turnNumbers(){
return this.call(()=>this.engine._world_turn(this.at)).turn}get steps(){return this.read("steps")[0]}get seed(){return this.read("seed")[0]}get episode(){return this.
read("episode")[0]}get over(){return this.read("terminated")[0]===1||this.read("truncated")[0]===1}read(t){return this.call(r=>this.engine._world_read(this.at,r.
text(t)))[t]}view(t){let r=3*this.config.fov**2;return this.read("views").slice(t*r,(t+1)*r)}map(){return this.read("state").slice(2*this.config.rows*this.config.
cols)}conflicts(){return je(this.conflictTable(),this.config.n_pursuers)}conflictTable(){return this.call(()=>this.engine._world_conflicts(this.at)).conflict_table}answer(t,r){
let n=we(t),{logits:o}=this.call(i=>this.engine._world_logits(this.at,i.arrays(n),r)),s=o,a=this.decide(t,[r,r+1],new Uint8Array(this.n_agents))[r];return{logits:s,
probabilities:ho(s),action:a}}snapshot(){return this.call(()=>this.engine._world_snapshot(this.at))}restore(t){let r=dr(t);this.call(n=>this.engine._world_restore(
this.at,n.arrays(r)))}call(t){if(this.freed)throw I("world","one that is in use","one that was freed");return ke(this.engine,t),Ve(this.engine)}};function ho(e){
let t=Math.max(...e),r=Array.from(e,o=>Math.exp(o-t)),n=r.reduce((o,s)=>o+s,0);return Float32Array.from(r,o=>o/n)}var Mt=class{compiled;constructor(t){this.compiled=t}world(t){return new Ie(this.compiled,t)}match(t,r,n,o,s=0){return vr(this.compiled,{config:t,pursuers:r,evaders:n},
o,s)}rollout(t,r,n,o,s){return br(this.compiled,{config:t,pursuers:r,evaders:n},o,s)}},xr;function Ar(e=globalThis.matrixworldEngine){return xr??=yo(e),xr}async function yo(e){
if(!e)throw new Error("matrixworldEngine: expected the script engine.js before this one, got none");let t=Uint8Array.from(atob(e.binary),r=>r.charCodeAt(0));return new Mt(
await e({wasmBinary:t}))}var C=Uint8Array,j=Uint16Array,Lt=Int32Array,Xe=new C([0,0,0,0,0,0,0,0,1,1,1,1,2,2,2,2,3,3,3,3,4,4,4,4,5,5,5,5,0,0,0,0]),Qe=new C([0,0,0,0,1,1,2,2,3,3,4,4,5,5,6,
6,7,7,8,8,9,9,10,10,11,11,12,12,13,13,0,0]),Rt=new C([16,17,18,0,8,7,9,6,10,5,11,4,12,3,13,2,14,1,15]),_r=function(e,t){for(var r=new j(31),n=0;n<31;++n)r[n]=t+=
1<<e[n-1];for(var o=new Lt(r[30]),n=1;n<30;++n)for(var s=r[n];s<r[n+1];++s)o[s]=s-r[n]<<5|n;return{b:r,r:o}},Rr=_r(Xe,2),Nr=Rr.b,Nt=Rr.r;Nr[28]=258,Nt[258]=28;var Or=_r(
Qe,0),go=Or.b,Sr=Or.r,Ot=new j(32768);for(S=0;S<32768;++S)se=(S&43690)>>1|(S&21845)<<1,se=(se&52428)>>2|(se&13107)<<2,se=(se&61680)>>4|(se&3855)<<4,Ot[S]=((se&65280)>>
8|(se&255)<<8)>>1;var se,S,te=(function(e,t,r){for(var n=e.length,o=0,s=new j(t);o<n;++o)e[o]&&++s[e[o]-1];var a=new j(t);for(o=1;o<t;++o)a[o]=a[o-1]+s[o-1]<<1;
var i;if(r){i=new j(1<<t);var u=15-t;for(o=0;o<n;++o)if(e[o])for(var l=o<<4|e[o],c=t-e[o],f=a[e[o]-1]++<<c,p=f|(1<<c)-1;f<=p;++f)i[Ot[f]>>u]=l}else for(i=new j(
n),o=0;o<n;++o)e[o]&&(i[o]=Ot[a[e[o]-1]++]>>15-e[o]);return i}),le=new C(288);for(S=0;S<144;++S)le[S]=8;var S;for(S=144;S<256;++S)le[S]=9;var S;for(S=256;S<280;++S)
le[S]=7;var S;for(S=280;S<288;++S)le[S]=8;var S,Ue=new C(32);for(S=0;S<32;++S)Ue[S]=5;var S,vo=te(le,9,0),bo=te(le,9,1),wo=te(Ue,5,0),xo=te(Ue,5,1),Ct=function(e){
for(var t=e[0],r=1;r<e.length;++r)e[r]>t&&(t=e[r]);return t},J=function(e,t,r){var n=t/8|0;return(e[n]|e[n+1]<<8)>>(t&7)&r},Tt=function(e,t){var r=t/8|0;return(e[r]|
e[r+1]<<8|e[r+2]<<16)>>(t&7)},Ut=function(e){return(e+7)/8|0},$e=function(e,t,r){return(t==null||t<0)&&(t=0),(r==null||r>e.length)&&(r=e.length),new C(e.subarray(
t,r))};var Ao=["unexpected EOF","invalid block type","invalid length/literal","invalid distance","stream finished","no stream handler",,"no callback","invalid UTF-8 da\
ta","extra field too long","date not in range 1980-2099","filename too long","stream finishing","invalid zip data"],z=function(e,t,r){var n=new Error(t||Ao[e]);
if(n.code=e,Error.captureStackTrace&&Error.captureStackTrace(n,z),!r)throw n;return n},kr=function(e,t,r,n){var o=e.length,s=n?n.length:0;if(!o||t.f&&!t.l)return r||
new C(0);var a=!r,i=a||t.i!=2,u=t.i;a&&(r=new C(o*3));var l=function(Ee){var _e=r.length;if(Ee>_e){var ye=new C(Math.max(_e*2,Ee));ye.set(r),r=ye}},c=t.f||0,f=t.
p||0,p=t.b||0,m=t.l,d=t.d,y=t.m,v=t.n,A=o*8;do{if(!m){c=J(e,f,1);var M=J(e,f+1,3);if(f+=3,M)if(M==1)m=bo,d=xo,y=9,v=5;else if(M==2){var O=J(e,f,31)+257,N=J(e,f+
10,15)+4,w=O+J(e,f+5,31)+1;f+=14;for(var b=new C(w),P=new C(19),k=0;k<N;++k)P[Rt[k]]=J(e,f+k*3,7);f+=N*3;for(var W=Ct(P),ie=(1<<W)-1,B=te(P,W,1),k=0;k<w;){var F=B[J(
e,f,ie)];f+=F&15;var g=F>>4;if(g<16)b[k++]=g;else{var L=0,_=0;for(g==16?(_=3+J(e,f,3),f+=2,L=b[k-1]):g==17?(_=3+J(e,f,7),f+=3):g==18&&(_=11+J(e,f,127),f+=7);_--;)
b[k++]=L}}var D=b.subarray(0,O),U=b.subarray(O);y=Ct(D),v=Ct(U),m=te(D,y,1),d=te(U,v,1)}else z(1);else{var g=Ut(f)+4,x=e[g-4]|e[g-3]<<8,E=g+x;if(E>o){u&&z(0);break}
i&&l(p+x),r.set(e.subarray(g,E),p),t.b=p+=x,t.p=f=E*8,t.f=c;continue}if(f>A){u&&z(0);break}}i&&l(p+131072);for(var Te=(1<<y)-1,V=(1<<v)-1,ne=f;;ne=f){var L=m[Tt(
e,f)&Te],H=L>>4;if(f+=L&15,f>A){u&&z(0);break}if(L||z(2),H<256)r[p++]=H;else if(H==256){ne=f,m=null;break}else{var G=H-254;if(H>264){var k=H-257,R=Xe[k];G=J(e,f,
(1<<R)-1)+Nr[k],f+=R}var Q=d[Tt(e,f)&V],he=Q>>4;Q||z(3),f+=Q&15;var U=go[he];if(he>3){var R=Qe[he];U+=Tt(e,f)&(1<<R)-1,f+=R}if(f>A){u&&z(0);break}i&&l(p+131072);
var de=p+G;if(p<U){var He=s-U,Ge=Math.min(U,de);for(He+p<0&&z(3);p<Ge;++p)r[p]=n[He+p]}for(;p<de;++p)r[p]=r[p-U]}}t.l=m,t.p=ne,t.b=p,t.f=c,m&&(c=1,t.m=y,t.d=d,t.
n=v)}while(!c);return p!=r.length&&a?$e(r,0,p):r.subarray(0,p)},ae=function(e,t,r){r<<=t&7;var n=t/8|0;e[n]|=r,e[n+1]|=r>>8},Pe=function(e,t,r){r<<=t&7;var n=t/
8|0;e[n]|=r,e[n+1]|=r>>8,e[n+2]|=r>>16},Et=function(e,t){for(var r=[],n=0;n<e.length;++n)e[n]&&r.push({s:n,f:e[n]});var o=r.length,s=r.slice();if(!o)return{t:Pr,
l:0};if(o==1){var a=new C(r[0].s+1);return a[r[0].s]=1,{t:a,l:1}}r.sort(function(E,O){return E.f-O.f}),r.push({s:-1,f:25001});var i=r[0],u=r[1],l=0,c=1,f=2;for(r[0]=
{s:-1,f:i.f+u.f,l:i,r:u};c!=o-1;)i=r[r[l].f<r[f].f?l++:f++],u=r[l!=c&&r[l].f<r[f].f?l++:f++],r[c++]={s:-1,f:i.f+u.f,l:i,r:u};for(var p=s[0].s,n=1;n<o;++n)s[n].s>
p&&(p=s[n].s);var m=new j(p+1),d=kt(r[c-1],m,0);if(d>t){var n=0,y=0,v=d-t,A=1<<v;for(s.sort(function(O,N){return m[N.s]-m[O.s]||O.f-N.f});n<o;++n){var M=s[n].s;
if(m[M]>t)y+=A-(1<<d-m[M]),m[M]=t;else break}for(y>>=v;y>0;){var g=s[n].s;m[g]<t?y-=1<<t-m[g]++-1:++n}for(;n>=0&&y;--n){var x=s[n].s;m[x]==t&&(--m[x],++y)}d=t}return{
t:new C(m),l:d}},kt=function(e,t,r){return e.s==-1?Math.max(kt(e.l,t,r+1),kt(e.r,t,r+1)):t[e.s]=r},Mr=function(e){for(var t=e.length;t&&!e[--t];);for(var r=new j(
++t),n=0,o=e[0],s=1,a=function(u){r[n++]=u},i=1;i<=t;++i)if(e[i]==o&&i!=t)++s;else{if(!o&&s>2){for(;s>138;s-=138)a(32754);s>2&&(a(s>10?s-11<<5|28690:s-3<<5|12305),
s=0)}else if(s>3){for(a(o),--s;s>6;s-=6)a(8304);s>2&&(a(s-3<<5|8208),s=0)}for(;s--;)a(o);s=1,o=e[i]}return{c:r.subarray(0,n),n:t}},Le=function(e,t){for(var r=0,
n=0;n<t.length;++n)r+=e[n]*t[n];return r},Ir=function(e,t,r){var n=r.length,o=Ut(t+2);e[o]=n&255,e[o+1]=n>>8,e[o+2]=e[o]^255,e[o+3]=e[o+1]^255;for(var s=0;s<n;++s)
e[o+s+4]=r[s];return(o+4+n)*8},Cr=function(e,t,r,n,o,s,a,i,u,l,c){ae(t,c++,r),++o[256];for(var f=Et(o,15),p=f.t,m=f.l,d=Et(s,15),y=d.t,v=d.l,A=Mr(p),M=A.c,g=A.n,
x=Mr(y),E=x.c,O=x.n,N=new j(19),w=0;w<M.length;++w)++N[M[w]&31];for(var w=0;w<E.length;++w)++N[E[w]&31];for(var b=Et(N,7),P=b.t,k=b.l,W=19;W>4&&!P[Rt[W-1]];--W)
;var ie=l+5<<3,B=Le(o,le)+Le(s,Ue)+a,F=Le(o,p)+Le(s,y)+a+14+3*W+Le(N,P)+2*N[16]+3*N[17]+7*N[18];if(u>=0&&ie<=B&&ie<=F)return Ir(t,c,e.subarray(u,u+l));var L,_,D,
U;if(ae(t,c,1+(F<B)),c+=2,F<B){L=te(p,m,0),_=p,D=te(y,v,0),U=y;var Te=te(P,k,0);ae(t,c,g-257),ae(t,c+5,O-1),ae(t,c+10,W-4),c+=14;for(var w=0;w<W;++w)ae(t,c+3*w,
P[Rt[w]]);c+=3*W;for(var V=[M,E],ne=0;ne<2;++ne)for(var H=V[ne],w=0;w<H.length;++w){var G=H[w]&31;ae(t,c,Te[G]),c+=P[G],G>15&&(ae(t,c,H[w]>>5&127),c+=H[w]>>12)}}else
L=vo,_=le,D=wo,U=Ue;for(var w=0;w<i;++w){var R=n[w];if(R>255){var G=R>>18&31;Pe(t,c,L[G+257]),c+=_[G+257],G>7&&(ae(t,c,R>>23&31),c+=Xe[G]);var Q=R&31;Pe(t,c,D[Q]),
c+=U[Q],Q>3&&(Pe(t,c,R>>5&8191),c+=Qe[Q])}else Pe(t,c,L[R]),c+=_[R]}return Pe(t,c,L[256]),c+_[256]},So=new Lt([65540,131080,131088,131104,262176,1048704,1048832,
2114560,2117632]),Pr=new C(0),Mo=function(e,t,r,n,o,s){var a=s.z||e.length,i=new C(n+a+5*(1+Math.ceil(a/7e3))+o),u=i.subarray(n,i.length-o),l=s.l,c=(s.r||0)&7;if(t){
c&&(u[0]=s.r>>3);for(var f=So[t-1],p=f>>13,m=f&8191,d=(1<<r)-1,y=s.p||new j(32768),v=s.h||new j(d+1),A=Math.ceil(r/3),M=2*A,g=function(dt){return(e[dt]^e[dt+1]<<
A^e[dt+2]<<M)&d},x=new Lt(25e3),E=new j(288),O=new j(32),N=0,w=0,b=s.i||0,P=0,k=s.w||0,W=0;b+2<a;++b){var ie=g(b),B=b&32767,F=v[ie];if(y[B]=F,v[ie]=B,k<=b){var L=a-
b;if((N>7e3||P>24576)&&(L>423||!l)){c=Cr(e,u,0,x,E,O,w,P,W,b-W,c),P=N=w=0,W=b;for(var _=0;_<286;++_)E[_]=0;for(var _=0;_<30;++_)O[_]=0}var D=2,U=0,Te=m,V=B-F&32767;
if(L>2&&ie==g(b-V))for(var ne=Math.min(p,L)-1,H=Math.min(32767,b),G=Math.min(258,L);V<=H&&--Te&&B!=F;){if(e[b+D]==e[b+D-V]){for(var R=0;R<G&&e[b+R]==e[b+R-V];++R)
;if(R>D){if(D=R,U=V,R>ne)break;for(var Q=Math.min(V,R-2),he=0,_=0;_<Q;++_){var de=b-V+_&32767,He=y[de],Ge=de-He&32767;Ge>he&&(he=Ge,F=de)}}}B=F,F=y[B],V+=B-F&32767}
if(U){x[P++]=268435456|Nt[D]<<18|Sr[U];var Ee=Nt[D]&31,_e=Sr[U]&31;w+=Xe[Ee]+Qe[_e],++E[257+Ee],++O[_e],k=b+D,++N}else x[P++]=e[b],++E[e[b]]}}for(b=Math.max(b,k);b<
a;++b)x[P++]=e[b],++E[e[b]];c=Cr(e,u,l,x,E,O,w,P,W,b-W,c),l||(s.r=c&7|u[c/8|0]<<3,c-=7,s.h=v,s.p=y,s.i=b,s.w=k)}else{for(var b=s.w||0;b<a+l;b+=65535){var ye=b+65535;
ye>=a&&(u[c/8|0]=l,ye=a),c=Ir(u,c+1,e.subarray(b,ye))}s.i=a}return $e(i,0,n+Ut(c)+o)},Co=(function(){for(var e=new Int32Array(256),t=0;t<256;++t){for(var r=t,n=9;--n;)
r=(r&1&&-306674912)^r>>>1;e[t]=r}return e})(),To=function(){var e=-1;return{p:function(t){for(var r=e,n=0;n<t.length;++n)r=Co[r&255^t[n]]^r>>>8;e=r},d:function(){
return~e}}};var Eo=function(e,t,r,n,o){if(!o&&(o={l:1},t.dictionary)){var s=t.dictionary.subarray(-32768),a=new C(s.length+e.length);a.set(s),a.set(e,s.length),e=a,o.w=s.length}
return Mo(e,t.level==null?6:t.level,t.mem==null?o.l?Math.ceil(Math.max(8,Math.min(13,Math.log(e.length)))*1.5):20:12+t.mem,r,n,o)},Lr=function(e,t){var r={};for(var n in e)
r[n]=e[n];for(var n in t)r[n]=t[n];return r};var ee=function(e,t){return e[t]|e[t+1]<<8},X=function(e,t){return(e[t]|e[t+1]<<8|e[t+2]<<16|e[t+3]<<24)>>>0},_t=function(e,t){return X(e,t)+X(e,t+4)*4294967296},
$=function(e,t,r){for(;r;++t)e[t]=r,r>>>=8};var _o=function(e,t){return((e[0]&15)!=8||e[0]>>4>7||(e[0]<<8|e[1])%31)&&z(6,"invalid zlib data"),(e[1]>>5&1)==+!t&&z(6,"invalid zlib data: "+(e[1]&32?"need":"u\
nexpected")+" dictionary"),(e[1]>>3&4)+2};function Ro(e,t){return Eo(e,t||{},0,0)}function No(e,t){return kr(e,{i:2},t&&t.out,t&&t.dictionary)}function Ur(e,t){return kr(e.subarray(_o(e,t&&t.dictionary),-4),{i:2},t&&t.out,t&&t.dictionary)}var $r=function(e,t,r,n){for(var o in e){var s=e[o],a=t+o,i=n;Array.isArray(s)&&(i=Lr(n,s[1]),s=s[0]),s instanceof C?r[a]=[s,i]:(r[a+="/"]=[new C(0),i],$r(s,a,r,
n))}},Tr=typeof TextEncoder<"u"&&new TextEncoder,It=typeof TextDecoder<"u"&&new TextDecoder,Oo=0;try{It.decode(Pr,{stream:!0}),Oo=1}catch{}var ko=function(e){for(var t="",
r=0;;){var n=e[r++],o=(n>127)+(n>223)+(n>239);if(r+o>e.length)return{s:t,r:$e(e,r-1)};o?o==3?(n=((n&15)<<18|(e[r++]&63)<<12|(e[r++]&63)<<6|e[r++]&63)-65536,t+=String.
fromCharCode(55296|n>>10,56320|n&1023)):o&1?t+=String.fromCharCode((n&31)<<6|e[r++]&63):t+=String.fromCharCode((n&15)<<12|(e[r++]&63)<<6|e[r++]&63):t+=String.fromCharCode(
n)}};function Je(e,t){if(t){for(var r=new C(e.length),n=0;n<e.length;++n)r[n]=e.charCodeAt(n);return r}if(Tr)return Tr.encode(e);for(var o=e.length,s=new C(e.length+
(e.length>>1)),a=0,i=function(c){s[a++]=c},n=0;n<o;++n){if(a+5>s.length){var u=new C(a+8+(o-n<<1));u.set(s),s=u}var l=e.charCodeAt(n);l<128||t?i(l):l<2048?(i(192|
l>>6),i(128|l&63)):l>55295&&l<57344?(l=65536+(l&1047552)|e.charCodeAt(++n)&1023,i(240|l>>18),i(128|l>>12&63),i(128|l>>6&63),i(128|l&63)):(i(224|l>>12),i(128|l>>
6&63),i(128|l&63))}return $e(s,0,a)}function $t(e,t){if(t){for(var r="",n=0;n<e.length;n+=16384)r+=String.fromCharCode.apply(null,e.subarray(n,n+16384));return r}else{
if(It)return It.decode(e);var o=ko(e),s=o.s,r=o.r;return r.length&&z(8),s}}var Io=function(e,t){return t+30+ee(e,t+26)+ee(e,t+28)},Po=function(e,t,r){var n=ee(e,t+28),o=$t(e.subarray(t+46,t+46+n),!(ee(e,t+8)&2048)),s=t+46+n,a=X(e,t+20),
i=r&&a==4294967295?Lo(e,s):[a,X(e,t+24),X(e,t+42)],u=i[0],l=i[1],c=i[2];return[ee(e,t+10),u,l,o,s+ee(e,t+30)+ee(e,t+32),c]},Lo=function(e,t){for(;ee(e,t)!=1;t+=
4+ee(e,t+2));return[_t(e,t+12),_t(e,t+4),_t(e,t+20)]},Pt=function(e){var t=0;if(e)for(var r in e){var n=e[r].length;n>65535&&z(9),t+=n+4}return t},Er=function(e,t,r,n,o,s,a,i){
var u=n.length,l=r.extra,c=i&&i.length,f=Pt(l);$(e,t,a!=null?33639248:67324752),t+=4,a!=null&&(e[t++]=20,e[t++]=r.os),e[t]=20,t+=2,e[t++]=r.flag<<1|(s<0&&8),e[t++]=
o&&8,e[t++]=r.compression&255,e[t++]=r.compression>>8;var p=new Date(r.mtime==null?Date.now():r.mtime),m=p.getFullYear()-1980;if((m<0||m>119)&&z(10),$(e,t,m<<25|
p.getMonth()+1<<21|p.getDate()<<16|p.getHours()<<11|p.getMinutes()<<5|p.getSeconds()>>1),t+=4,s!=-1&&($(e,t,r.crc),$(e,t+4,s<0?-s-2:s),$(e,t+8,r.size)),$(e,t+12,
u),$(e,t+14,f),t+=16,a!=null&&($(e,t,c),$(e,t+6,r.attrs),$(e,t+10,a),t+=14),e.set(n,t),t+=u,f)for(var d in l){var y=l[d],v=y.length;$(e,t,+d),$(e,t+2,v),e.set(y,
t+4),t+=4+v}return c&&(e.set(i,t),t+=c),t},Uo=function(e,t,r,n,o){$(e,t,101010256),$(e,t+8,r),$(e,t+10,r),$(e,t+12,n),$(e,t+16,o)};function zr(e,t){t||(t={});var r={},n=[];$r(e,"",r,t);var o=0,s=0;for(var a in r){var i=r[a],u=i[0],l=i[1],c=l.level==0?0:8,f=Je(a),p=f.length,m=l.comment,d=m&&
Je(m),y=d&&d.length,v=Pt(l.extra);p>65535&&z(11);var A=c?Ro(u,l):u,M=A.length,g=To();g.p(u),n.push(Lr(l,{size:u.length,crc:g.d(),c:A,f,m:d,u:p!=a.length||d&&m.length!=
y,o,compression:c})),o+=30+p+v+M,s+=76+2*(p+v)+(y||0)+M}for(var x=new C(s+22),E=o,O=s-o,N=0;N<n.length;++N){var f=n[N];Er(x,f.o,f,f.f,f.u,f.c.length);var w=30+f.
f.length+Pt(f.extra);x.set(f.c,f.o+w),Er(x,o,f,f.f,f.u,f.c.length,f.o,f.m),o+=16+w+(f.m?f.m.length:0)}return Uo(x,o,n.length,O,E),x}function Wr(e,t){for(var r={},n=e.length-22;X(e,n)!=101010256;--n)(!n||e.length-n>65558)&&z(13);var o=ee(e,n+8);if(!o)return{};var s=X(e,n+16),a=s==4294967295||
o==65535;if(a){var i=X(e,n-12);a=X(e,i)==101075792,a&&(o=X(e,i+32),s=X(e,i+48))}for(var u=t&&t.filter,l=0;l<o;++l){var c=Po(e,s,a),f=c[0],p=c[1],m=c[2],d=c[3],y=c[4],
v=c[5],A=Io(e,v);s=y,(!u||u({name:d,size:p,originalSize:m,compression:f}))&&(f?f==8?r[d]=No(e.subarray(A,A+p),{out:new C(m)}):z(14,"unknown compression type "+f):
r[d]=$e(e,A,A+p))}return r}var xe=["pursuer","evader"];var zt=4,Fr=new Map;function Dr(e,t){let r=Fr.get(e);if(r)return r;let n=new Float32Array;try{let o=zo(Wo(e),t);o.every(Number.isFinite)&&(n=o)}catch(o){if(!(o instanceof
DOMException||o instanceof RangeError||$o(o)))throw o}return Fr.set(e,n),n}var $o=e=>e instanceof Error&&"code"in e;function zo(e,t){let r=Ur(e),n=r.length/zt,o=new Uint8Array(
r.length);for(let a=0;a<o.length;a++)o[a]=r[a%zt*n+Math.floor(a/zt)];let s=new Uint32Array(o.buffer);for(let a=t;a<s.length;a++)s[a]^=s[a-t];return new Float32Array(
o.buffer)}function Wo(e){let t=atob(Wt(e)),r=new Uint8Array(t.length);for(let n=0;n<r.length;n++)r[n]=t.charCodeAt(n);return r}function Wt(e){return document.getElementById(
e)?.textContent??""}var Fo="http://www.w3.org/2000/svg";function h(e,t={},...r){return Br(document.createElement(e),t,r)}function Ft(e,t={},...r){return Br(document.createElementNS(
Fo,e),t,r)}function Br(e,t,r){for(let[n,o]of Object.entries(t))o==null||o===!1||(typeof o=="function"?e.addEventListener(n.slice(2),o):e.setAttribute(n,o===!0?"":
String(o)));return e.append(...r.filter(Do).map(n=>typeof n=="number"?String(n):n)),e}function Do(e){return e!=null&&e!==!1}var Hr=()=>["file:","http:","https:"].
includes(location.protocol);var et=["stay","north","east","south","west","northeast","southeast","southwest","northwest"];var Bo=matchMedia("(prefers-color-scheme: dark)");function Ho(){let e=document.documentElement.dataset.theme;return e?e==="dark":Bo.matches}function Go(){document.
documentElement.dataset.theme=Ho()?"light":"dark"}function Gr(){return h("button",{type:"button",title:"Light or dark (D)","aria-label":"Light or dark",onclick:Go},
"◐")}function jr(e,t,r){return{rows:e.rows,cols:e.cols,nPursuers:e.n_pursuers,fov:e.fov,interaction:e.rules.interaction,obstacles:t,moments:r}}function Dt(e,t){return{
positions:e.read("last_positions"),alive:e.read("alive"),captured:e.read("captured"),everCaptured:e.read("ever_captured"),actions:t,involved:e.read("involved"),
fault:e.read("fault"),contested:e.conflicts().map(r=>r.cell)}}var ze=class{config;start;recording;actions=[];#e;#o;#n=[[]];constructor(t,r,n){[this.config,this.start]=[r,n],this.#e=t.world(r),this.#e.reset(n),this.#o=[Dt(this.#e)],
this.recording=jr(r,this.#e.map(),this.#o)}get length(){return this.actions.length}get over(){return this.#e.over}get statistics(){return{capture_rate:this.#e.read(
"capture_rate")[0]}}conflicts(t){return this.#n[t]}play(t){this.#e.step(t),this.#t(t)}step(t,r,n){let[o,s]=[this.#e,this.config.n_pursuers],a=new Uint8Array(o.n_agents);
for(let i=o.n_turns;i>0&&!o.over;--i){let[u,l]=o.actors;u<s&&(a=o.decide(t.pursuer,[u,Math.min(l,s)],a)),l>s&&(a=o.decide(t.evader,[Math.max(u,s),l],a)),typeof n==
"number"?a[r]=n:u<=r&&r<l&&(a=o.decide(n,[r,r+1],a)),o.playTurn(a)}this.#t(a)}#t(t){this.actions.push(t),this.#o.push(Dt(this.#e,t)),this.#n.push(this.#e.conflicts())}};
function Vr(e,t,r,n){let o=new ze(e,t,r);for(let s of n)o.play(s);return o}var pe=(e,t)=>xe[+(t>=e.n_pursuers)];function Bt(e,t){let r=new ze(e,t.config,{seed:t.seed,episode:t.episode});for(let n of t.moves)r.over||r.step(t.policies,t.
seat,n);return r}function ue(e,t){let{moments:r,nPursuers:n}=e.recording,o=r.findIndex(({alive:a,captured:i})=>!a[t]||!!i[t-n]),s=o<0?e.length:o;return{lasted:s,
out:o>=0,captured:Array.from(r[s].everCaptured).filter(Boolean).length}}var tt=(e,t)=>e.over||ue(e,t).out;function Yr(e,t,r){let n=Bt(e,{...t,moves:t.moves.slice(
0,t.from)});for(;!tt(n,t.seat);)n.step(t.policies,t.seat,r);return ue(n,t.seat)}function rt(e){let t=e.length-1;return[...new Set([0,Math.round(t/3),t])].map(r=>e[r])}
function Kr(e,{seat:t,from:r,moves:n}){let o={...e,seat:t,...r?{from:r}:{},moves:n.join("")};return`${location.href.split("#")[0]}#${Object.entries(o).map(([s,a])=>`${s}\
=${a}`).join("&")}`}function Zr(e,t){let[r,n,o]=[e.get("seat")??"",e.get("from")??"0",e.get("moves")??""];return/^\d{1,6}$/.test(r)&&Number(r)<t.n_pursuers+t.n_evaders&&
(t.diagonal?/^[0-8]+$/:/^[0-4]+$/).test(o)&&o.length<=t.max_steps&&/^\d{1,6}$/.test(n)&&Number(n)<=o.length?{seat:Number(r),from:Number(n),moves:[...o].map(Number)}:
null}var nt=()=>crypto.getRandomValues(new BigUint64Array(1))[0];function Ht(e,t,r,n,o,s){t.play({title:r,played:n,ending:(a,i)=>[jo(e,a,i,rt(o))],again:()=>Ht(e,t,r,{...n,moves:n.moves.slice(0,n.from)},o,s),link:a=>Kr(s,a)})}
function jo(e,t,r,n){let o=pe(r.config,r.seat)==="evader",s=o?r.config.max_steps:r.config.n_evaders,a=h("table",{class:"numbers"},h("caption",{},o?"Steps in you\
r seat: same start, same others":"Captures of your team: same start, same others")),i=l=>{let[c,f]=[h("span",{class:o?"bar evader":"bar pursuer"}),h("td",{},"…")];
return a.append(h("tr",{},h("th",{scope:"row"},l),h("td",{class:"track","aria-hidden":"true"},c),f)),({lasted:p,captured:m})=>{c.style.width=`${100*(o?p:m)/s}%`,
f.textContent=String(o?p:m)}};i("You")(ue(t,r.seat));for(let{name:l,policy:c}of n){let f=i(l);setTimeout(()=>f(Yr(e,r,c())))}let u=r.from?`You took over at step\
 ${r.from}. `:"";return h("div",{},a,h("p",{class:"small muted"},`${u}One match: luck has its part in it.`))}var Vo=20,Gt=60;function Yo(e){let t=e.rules.capture==="SURROUND"?8:4,r=typeof e.obstacles!="number",n=o=>r?o:Math.min(o,Vo);return{...e,rows:n(e.rows),cols:n(e.
cols),max_steps:Gt,n_evaders:1,n_pursuers:Math.min(e.n_pursuers,t)}}function ot(e,t,r){let[n,o,s]=[Yo(t),rt(r),[]],a=()=>`${s.reduce((u,l)=>u+l,0)} of ${Gt*o.length}`,
i=()=>e.play({title:`Can you escape it? Round ${s.length+1} of ${o.length}: ${o[s.length].name}`,played:{config:n,seed:nt(),episode:0,seat:n.n_pursuers,from:0,moves:[],
policies:{pursuer:o[s.length].policy(),evader:"still"}},ending:u=>{s.push(ue(u,n.n_pursuers).lasted);let l=o.map(({name:f},p)=>h("tr",{},h("th",{scope:"row"},f),
h("td",{},s[p]??""))),c=s.length<o.length;return[h("table",{class:"numbers"},h("caption",{},`Steps of ${Gt} in each round`),...l),h("p",{class:"play-score"},c?"\
Score so far: ":"Your score: ",h("strong",{},a())),c?h("button",{type:"button",class:"primary",onclick:i},"Next round"):""]},again:()=>ot(e,t,r),link:()=>null});
i()}var Ko={"|b1":e=>new Uint8Array(e),"|i1":e=>new Int8Array(e),"<i4":e=>new Int32Array(e),"<i8":e=>Int32Array.from(new BigInt64Array(e),Number),"<f4":e=>new Float32Array(
e)},Jr="NUMPY\0",Ae=Jr.length+2,qr=64;function Xr(e){return zr(Object.fromEntries(Object.entries(e).map(([t,r])=>[`${t}.npy`,Zo(r)])))}function Zo({dtype:e,shape:t,
data:r}){let n=typeof r=="string"?Array.from(r,c=>c.codePointAt(0)):null,o=t.map(c=>`${c}, `).join(""),s=`{'descr': '${n?`<U${n.length}`:e}', 'fortran_order': F\
alse, 'shape': (${o}), }`,a=Math.ceil((Ae+s.length+1)/qr)*qr-Ae,i=Jr+String.fromCharCode(a&255,a>>8)+s.padEnd(a-1)+`
`,u=n?Int32Array.from(n):r,l=new Uint8Array(i.length+u.byteLength);return l.set(Je(i,!0)),l.set(new Uint8Array(u.buffer,u.byteOffset,u.byteLength),i.length),l}function Qr(e){
return Object.fromEntries(Object.entries(Wr(e)).map(([t,r])=>[t.replace(/\.npy$/,""),qo(r)]))}function qo(e){let t=Ae+e[Ae-2]+256*e[Ae-1],r=$t(e.subarray(Ae,t),
!0),n=/'descr': '([^']+)', 'fortran_order': False, 'shape': \(([\d, ]*)\)/.exec(r),[o,s]=[n?.[1]??"",(n?.[2]??"").split(",").filter(l=>l.trim()).map(Number)],a=e.
slice(t).buffer,i=o.startsWith("<U")&&String.fromCodePoint(...new Int32Array(a)),u=i===!1?Ko[o]?.(a):i.replace(/\0+$/,"");if(u===void 0)throw new TypeError(`exp\
ected an array of numbers or a text, got ${r.slice(0,80)}`);return{dtype:o,shape:s,data:u}}var jt="matrixworld episode 3";function en(e,t,r){let{config:n,actions:o,length:s,recording:a}=t,[i,u]=[n.n_pursuers+n.n_evaders,n.n_evaders],l={positions:["<i4",
i,2],last_positions:["<i4",i,2],alive:["|b1",i],captured:["|b1",u],ever_captured:["|b1",u]},c={rewards:["<f4",i],involved:["|b1",i,3],fault:["|b1",i,3]},f={},p=g=>{
for(let x of Object.keys(g))(f[x]??=[]).push(Array.from(m.read(x),Number))},m=e.world(n);m.reset(t.start);let d=[];p(l);for(let g of o)m.step(g),p({...l,...c}),
d.push(...m.conflictTable());m.free();let y={"<i4":Int32Array,"<f4":Float32Array,"|b1":Uint8Array},v={};for(let[g,[x,...E]]of Object.entries({...l,...c})){let O=s+
+(g in l);v[g]={dtype:x,shape:[O,...E],data:y[x].from((f[g]??[]).flat())}}let A=g=>({dtype:"<i8",shape:[],data:Int32Array.of(g,0)}),M=g=>({dtype:"<U",shape:[],data:g});
return Xr({format:M(jt),n_pursuers:A(n.n_pursuers),config:M(JSON.stringify(n)),seat:A(r),...v,actions:{dtype:"|i1",shape:[s,i],data:Int8Array.from(o.flatMap(g=>[
...g]))},map:{dtype:"|b1",shape:[n.rows,n.cols],data:Uint8Array.from(a.obstacles,Number)},conflict_table:{dtype:"<i4",shape:[d.length/11,11],data:Int32Array.from(
d)}})}function tn(e,t){let r=Qr(t),n=m=>Array.from(r[m]?.data??[]);if(r.format?.data!==jt)throw new Y(`expected a file marked "${jt}"`);let o=JSON.parse(r.config.
data),s=o.n_pursuers+o.n_evaders,a=n("positions"),i=(m,d)=>Array.from({length:d-m},(y,v)=>[a[2*(m+v)],a[2*(m+v)+1]]),u={pursuers:i(0,o.n_pursuers),evaders:i(o.n_pursuers,
s),obstacles:Uint8Array.from(n("map"))},l=Uint8Array.from(n("actions")),c=Array.from({length:l.length/s},(m,d)=>l.subarray(d*s,(d+1)*s)),f=Vr(e,o,u,c);if(Array.
from(f.recording.moments.at(-1).positions).join()!==n("last_positions").slice(-2*s).join())throw new Y("expected the moves of this start to lead to its end");return{
live:f,seat:n("seat")[0]??null}}var Se=[[0,0],[-1,0],[0,1],[1,0],[0,-1],[-1,1],[1,1],[1,-1],[-1,-1]];function rn(e,t,r){let[n,o]=[t[0]-e[0],t[1]-e[1]];return!r&&Math.abs(n)>Math.abs(o)?o=0:r||
(n=0),Se.findIndex(([s,a])=>s===Math.sign(n)&&a===Math.sign(o))}var me=(e,t)=>t<e.nPursuers,T=(e,t)=>[e.positions[2*t],e.positions[2*t+1]],Jo=(e,t)=>e[0]===t[0]&&
e[1]===t[1],Vt=({rows:e,cols:t},[r,n])=>r>=0&&n>=0&&r<e&&n<t,Yt=(e,t,r=3)=>e!==void 0&&[0,1,2].slice(0,r).some(n=>e[3*t+n]),Kt=(e,t)=>Yt(e.fault,t),nn=(e,t)=>!Kt(
e,t)&&Yt(e.involved,t,2);function st(e,t,r){let n=!Jo(T(e,r),T(t,r)),o=t.involved===void 0||Yt(t.involved,r);return!!(t.alive[r]&&t.actions?.[r]&&!n&&o)}function at(e,t,r){
let[n,o]=T(e,r),[s,a]=Se[t.actions?.[r]??0];return[n+s,o+a]}function it(e,t,r){return Array.from({length:r.everCaptured.length},(o,s)=>s).filter(o=>r.everCaptured[o]&&
!t.everCaptured[o]).map(o=>e.nPursuers+o)}function lt(e,t){return Array.from({length:t.alive.length},(n,o)=>o).filter(n=>e.alive[n]&&!t.alive[n])}var on=[-.31,0,.31],sn=[{size:1,at:[[0,0]]},{size:.62,at:[[-.2,.2],[.2,-.2]]},{size:.54,at:[[-.23,.22],[.23,.22],[0,-.22]]},{size:.54,at:[[-.23,.23],[.23,.23],[
-.23,-.23],[.23,-.23]]},{size:.36,at:on.flatMap(e=>on.map(t=>[t,e]))}],Xo=.3,Qo=.35,es=.55;function We(e,t){let r=new Map;for(let n=0;n<t.alive.length;n++){if(!t.
alive[n])continue;let[o,s]=T(t,n),a=o*e.cols+s,i=r.get(a);i?i.push(n):r.set(a,[n])}return r}function an(e,t){let r=Array.from(t.alive,(n,o)=>{let[s,a]=T(t,o);return{
x:a+.5,y:s+.5,size:1,alpha:0}});for(let n of We(e,t).values()){let o=sn[Math.min(n.length,sn.length)-1];n.forEach((s,a)=>{let[i,u]=o.at[Math.min(a,o.at.length-1)],
l=r[s];l.x+=i,l.y+=u,l.size=o.size,l.alpha=1})}return r}var ln=e=>e*e*(3-2*e),Me=(e,t,r)=>e+(t-e)*r,un=e=>Math.min(1,Math.max(0,e));function cn(e,t,r,n){let o={
SIMULTANEOUS:1,SWARM_TURNS:2,AGENT_TURNS:r}[e.interaction];if(o===1)return ln(n);let s=o===r?t:+!me(e,t),a=Math.max(1/o,Qo);return ln(un((n-s/(o-1)*(1-a))/a))}function ut(e,t){
let r=e.moments.length-1,n=Math.min(Math.floor(t),r),o=e.moments[n],s=an(e,o);if(n===r||t===n)return s;let a=e.moments[n+1],i=an(e,a);return s.map((u,l)=>{let c=cn(
e,l,s.length,t-n);return ts(o,a,l,u,i[l],c)})}function Zt(e,t,r){let n=e.moments.length-1,o=Math.min(Math.floor(r),n),[s,a]=[e.moments[o],e.moments[Math.min(o+1,
n)]],i=cn(e,t,s.alive.length,r-o),[[u,l],[c,f]]=[T(s,t),T(a,t)];return[Me(l,f,i)+.5,Me(u,c,i)+.5]}function ts(e,t,r,n,o,s){let a=n.alpha>o.alpha,i={x:Me(n.x,o.x,
s),y:Me(n.y,o.y,s),size:a?n.size:Me(n.size,o.size,s),alpha:a?un((1-s)/(1-es)):Me(n.alpha,o.alpha,s)};if(st(e,t,r)){let[u,l]=T(e,r),[c,f]=at(e,t,r),p=Xo*Math.sin(
Math.PI*s);i.x+=(f-l)*p,i.y+=(c-u)*p}return i}var fn=2*Math.PI;function Fe(e,t,r,n){e.beginPath(),e.arc(t,r,n/2,0,fn)}function pn(e,t,r,n){let o=n/2,s=[[0,-.97],[.97,.83],[-.97,.83]].map(([a,i])=>[t+a*o,r+i*
o]);e.beginPath(),e.moveTo((s[2][0]+s[0][0])/2,(s[2][1]+s[0][1])/2),s.forEach(([a,i],u)=>{let[l,c]=s[(u+1)%3];e.arcTo(a,i,l,c,n*.09)}),e.closePath()}function mn(e,t,r,n){
let o=n*.32;e.beginPath(),e.moveTo(t-o,r-o),e.lineTo(t+o,r+o),e.moveTo(t+o,r-o),e.lineTo(t-o,r+o)}function hn(e,t,r,n){e.beginPath();for(let o=0;o<16;o++){let s=n/
2*(o%2?.6:.95),a=fn*o/16;e.lineTo(t+s*Math.sin(a),r-s*Math.cos(a))}e.closePath()}function dn(e,t,r,n,o,s){let a=Math.atan2(o-r,n-t);e.beginPath(),e.moveTo(t,r),
e.lineTo(n,o);for(let i of[-1,1])e.moveTo(n,o),e.lineTo(n-s*Math.cos(a+i*.6),o-s*Math.sin(a+i*.6))}var yn=4,rs=1.6,ns=.95,os=5,ss=.16,as=9,is=.09,ls=.2,gn=.75,K=(e,t)=>e.left+t*e.cell,Z=(e,t)=>e.top+t*e.cell;function Ce(e,t,r){return me(t,r)?e.colors.pursuer:
e.colors.evader}function vn({ctx:e,grid:t,colors:r}){let{left:n,top:o,cell:s,rows:a,cols:i}=t,[u,l]=[i*s,a*s];if(e.fillStyle=r.paper,e.fillRect(n,o,u,l),s<os)return;
e.fillStyle=r.line;let c=Math.max(1,Math.round(s/60));for(let f=1;f<i;f++)e.fillRect(n+f*s,o,c,l);for(let f=1;f<a;f++)e.fillRect(n,o+f*s,u,c)}function bn({ctx:e,
grid:t,colors:r},n){let{left:o,top:s,cell:a,rows:i,cols:u}=t;e.fillStyle=r.obstacle;for(let l=0;l<i*u;l++){if(!n.obstacles[l])continue;let[c,f]=[Math.floor(l/u),
l%u];e.fillRect(o+f*a,s+c*a,a,a)}wn({ctx:e,grid:t,colors:r})}function wn({ctx:e,grid:{left:t,top:r,cell:n,rows:o,cols:s},colors:a}){let i=Math.min(5,Math.max(2,
Math.round(n/18)));e.strokeStyle=a.frame,e.lineWidth=i,e.strokeRect(t-i/2,r-i/2,s*n+i,o*n+i)}function xn({ctx:e,grid:t,colors:r},n){let{left:o,top:s,cell:a,rows:i,
cols:u}=t,l=a<24*n?5:1;e.font=`500 ${Math.round(Math.min(15*n,Math.max(9*n,a*.32)))}px system-ui, sans-serif`,e.fillStyle=r.muted,e.textBaseline="alphabetic",e.
textAlign="center";let c=5*n+a/40;for(let f=0;f<u;f+=l)e.fillText(String(f),o+(f+.5)*a,s-c);e.textAlign="right",e.textBaseline="middle";for(let f=0;f<i;f+=l)e.fillText(
String(f),o-c,s+(f+.5)*a)}function An({grid:e},t,r,n){let o=Math.floor(t.fov/2)+.5,[s,a]=[Math.max(0,r-o),Math.min(e.cols,r+o)],[i,u]=[Math.max(0,n-o),Math.min(
e.rows,n+o)];return[K(e,s),Z(e,i),(a-s)*e.cell,(u-i)*e.cell]}function Sn(e,t,r,n){let{ctx:o,grid:s,colors:a}=e;o.save(),o.beginPath(),o.rect(0,0,o.canvas.width,
o.canvas.height),o.rect(...An(e,t,r,n)),o.clip("evenodd"),o.clearRect(0,0,o.canvas.width,o.canvas.height),o.fillStyle=a.line,o.fillRect(s.left,s.top,s.cols*s.cell,
s.rows*s.cell),o.restore(),wn(e)}function Mn({ctx:e,grid:t,colors:r},{x:n,y:o,alpha:s},a){let i=Math.max(t.cell,16*a)*1.06,[u,l]=[K(t,n),Z(t,o)];e.globalAlpha=Math.
max(s,.6),e.beginPath(),e.roundRect(u-i/2,l-i/2,i,i,i*.2),e.strokeStyle=r.focus,e.lineWidth=Math.max(2,2.5*a),e.stroke();let c=Math.max(11*a,Math.min(18*a,t.cell*
.5));e.font=`700 ${Math.round(c)}px system-ui, sans-serif`,e.textAlign="center",e.textBaseline="middle";let f=l-i/2<c*1.2,p=l+(f?1:-1)*(i/2+c*.7);e.strokeStyle=
r.paper,e.lineJoin="round",e.lineWidth=c*.35,e.strokeText("You",u,p),e.fillStyle=r.ink,e.fillText("You",u,p),e.globalAlpha=1}function Cn(e,t,r,n,o){let{ctx:s,grid:a}=e,
i=An(e,t,n,o),u=Ce(e,t,r);s.globalAlpha=.11,s.fillStyle=u,s.fillRect(...i),s.globalAlpha=.8,s.strokeStyle=u,s.lineWidth=Math.max(1,a.cell/24),s.strokeRect(...i),
s.globalAlpha=1}function Tn(e,t,r,n,o){let{ctx:s,grid:a}=e,i=Math.min(Math.ceil(r),t.moments.length-1),u=t.moments[i];s.lineCap="round",s.lineWidth=Math.min(as,
Math.max(1,a.cell*ss));for(let l=Math.max(1,Math.floor(r-n)+1);l<=i;l++){let[c,f]=[t.moments[l-1],t.moments[l]],p=Math.max(0,Math.min(1,(r-l)/n));s.globalAlpha=
gn+(ls-gn)*p;for(let m=0;m<f.alive.length;m++){let d=l===i&&r<i;if(!c.alive[m]||!(u.alive[m]||d))continue;let y=(me(t,m)?-1:1)*is,[v,A]=T(c,m),[M,g]=T(f,m);if(v===
M&&A===g)continue;let x=d?o[m].x:g+.5,E=d?o[m].y:M+.5;s.strokeStyle=Ce(e,t,m),s.beginPath(),s.moveTo(K(a,A+.5+y),Z(a,v+.5+y)),s.lineTo(K(a,x+y),Z(a,E+y)),s.stroke()}}
s.globalAlpha=1}function En(e,t,r){let n=Math.min(Math.ceil(r),t.moments.length-1);for(let o=Math.max(1,n-yn+1);o<=n;o++){let[s,a]=[t.moments[o-1],t.moments[o]],
i=o>r?Math.max(0,1-2*(o-r)):1-(r-o)/yn,u=it(t,s,a);for(let l of lt(s,a))u.includes(l)||cs(e,T(a,l),i);for(let l of u)us(e,T(a,l),i)}e.ctx.globalAlpha=1}function us({
ctx:e,grid:t,colors:r},[n,o],s){e.globalAlpha=s,hn(e,K(t,o+.5),Z(t,n+.5),Math.max(8,t.cell*rs)),e.fillStyle=r.capture,e.fill(),e.strokeStyle=r.ink,e.lineWidth=Math.
max(1,t.cell/36),e.lineJoin="round",e.stroke()}function cs({ctx:e,grid:t,colors:r},[n,o],s){e.globalAlpha=s,mn(e,K(t,o+.5),Z(t,n+.5),Math.max(7,t.cell*ns)),e.strokeStyle=
r.collision,e.lineWidth=Math.max(2,t.cell*.17),e.lineCap="round",e.stroke()}function _n({ctx:e,grid:t,colors:r},n,o){let s=Math.max(1,t.cell*.07);e.strokeStyle=
e.fillStyle=r.collision,e.lineWidth=Math.max(1,t.cell*.05),e.setLineDash([t.cell*.14,t.cell*.1]);for(let[a,i]of n){if(a<0||i<0||a>=t.rows||i>=t.cols)continue;let u=[
K(t,i)+s,Z(t,a)+s,t.cell-2*s,t.cell-2*s];e.globalAlpha=.2*o,e.fillRect(...u),e.globalAlpha=o,e.strokeRect(...u)}e.setLineDash([]),e.globalAlpha=1}function Rn({ctx:e,
grid:t,colors:r},n,o,s,a){e.globalAlpha=a,Fe(e,K(t,n),Z(t,o),Math.max(8,t.cell*s*1.02)),e.strokeStyle=r.collision,e.lineWidth=Math.max(1.5,t.cell*.085*Math.sqrt(
s)),e.stroke(),e.globalAlpha=1}var fs=.8,ps=.92,ms=15,hs=7,qt=9;function Nn(e,t,r,n,o,s){n.forEach((a,i)=>{a.alpha>0&&ds(e,t,r,i,a,o,s)}),e.ctx.globalAlpha=1;for(let a of We(t,r).values())a.length>
qt&&ys(e,n[a[qt-1]],a.length-qt+1)}function ds(e,t,r,n,o,s,a){let{ctx:i,grid:u,colors:l}=e,c=me(t,n),[f,p]=[u.left+o.x*u.cell,u.top+o.y*u.cell],m=Math.max(4,u.cell*
o.size*(c?ps:fs)),d=Ce(e,t,n),y=!c&&!!r.captured[n-t.nPursuers];if(i.globalAlpha=o.alpha,(c?pn:Fe)(i,f,p,m),m>hs*a&&(i.strokeStyle=l.paper,i.lineWidth=Math.max(
2,m*.1),i.stroke()),i.fillStyle=y?l.paper:d,i.fill(),y&&(Fe(i,f,p,m*.82),i.strokeStyle=d,i.lineWidth=m*.18,i.stroke()),!s||m<ms*a)return;let v=String(c?n:n-t.nPursuers);
i.font=`700 ${Math.round(m*(c?.4:.5)*(v.length>1?.8:1))}px system-ui, sans-serif`,i.textAlign="center",i.textBaseline="middle",i.fillStyle=y?d:l.paper,i.fillText(
v,f,p+m*(c?.17:.03))}function ys({ctx:e,grid:t,colors:r},n,o){let[s,a]=[t.left+n.x*t.cell,t.top+n.y*t.cell];e.font=`700 ${Math.round(t.cell*.3)}px system-ui, sa\
ns-serif`,e.textAlign="center",e.textBaseline="middle",e.strokeStyle=r.paper,e.lineWidth=t.cell*.1,e.strokeText(`+${o}`,s,a),e.fillStyle=r.ink,e.fillText(`+${o}`,
s,a)}var gs=.46,vs=.86,bs=.66,On=.48,ws=.78,xs=.58;function kn(e,t,r,n){let[o,s]=[t.moments[r-1],t.moments[r]];if(!o)return;let{ctx:a,grid:i,colors:u}=e;a.strokeStyle=
u.collision,a.lineWidth=Math.max(1.5,i.cell*.07),a.lineCap="butt",a.globalAlpha=n;for(let l=0;l<s.alive.length;l++)st(o,s,l)&&As(e,t,T(o,l),at(o,s,l));a.globalAlpha=
1}function As({ctx:e,grid:t},r,n,o){let[s,a]=[o[1]-n[1],o[0]-n[0]],i=f=>K(t,n[1]+.5+s*f),u=f=>Z(t,n[0]+.5+a*f),l=Vt(r,o)?ws:xs;e.setLineDash([t.cell*.09,t.cell*
.06]),e.beginPath(),e.moveTo(i(On),u(On)),e.lineTo(i(l),u(l)),e.stroke(),e.setLineDash([]);let c=.17*t.cell/Math.hypot(s,a);e.beginPath(),e.moveTo(i(l)-a*c,u(l)+
s*c),e.lineTo(i(l)+a*c,u(l)-s*c),e.stroke()}function In(e,t,r,n,o,s){let a=Se[s];if(!s||!a)return;let{ctx:i,grid:u,colors:l}=e,c=Vt(t,[n[0]+a[0],n[1]+a[1]])?vs:
bs,f=gs*o.size,p=[K(u,o.x+a[1]*f),Z(u,o.y+a[0]*f),K(u,o.x+a[1]*c),Z(u,o.y+a[0]*c)],m=Math.max(1.5,u.cell*.085);i.lineCap=i.lineJoin="round";for(let[d,y]of[[l.paper,
m*2.1],[Ce(e,t,r),m]])i.strokeStyle=d,i.lineWidth=y,dn(i,...p,u.cell*.2),i.stroke()}var Ln={numbers:!0,axes:!1,trail:6,viewers:[],plan:null,selected:null,cursor:null,you:null,fog:!1};function Un(e,t,r,n,o){let{ctx:s,grid:a,colors:i}=e,u=Math.min(
Math.ceil(r),t.moments.length-1),l=t.moments[u],c=r===u,f=ut(t,r),p=c?1:Math.max(0,1-2*(u-r));s.clearRect(0,0,s.canvas.width,s.canvas.height),vn(e);for(let y of n.
viewers)f[y]?.alpha&&Cn(e,t,y,...Zt(t,y,r));bn(e,t),n.axes&&xn(e,o),Tn(e,t,r,n.trail,f),_n(e,l.contested??[],p),En(e,t,r),kn(e,t,u,p),f.forEach(({x:y,y:v,size:A},M)=>{
let g=nn(l,M)?.4:0,x=Kt(l,M)?1:g;x&&Rn(e,y,v,A,x*p)});let m=c?l:t.moments[Math.max(0,u-1)];if(Nn(e,t,m,f,n.numbers,o),c&&n.plan)for(let[y,v]of f.entries())v.alpha&&
In(e,t,y,T(l,y),v,n.plan[y]??0);n.you!==null&&(n.fog&&Sn(e,t,...Zt(t,n.you,r)),Mn(e,f[n.you],o)),s.lineWidth=Math.max(2,2.5*o),s.strokeStyle=i.focus;let d=n.selected===
null?void 0:f[n.selected];d?.alpha&&Pn(e,d.x,d.y,d.size*.96),n.cursor&&(s.setLineDash([a.cell*.12,a.cell*.08]),Pn(e,n.cursor[1]+.5,n.cursor[0]+.5,.8),s.setLineDash(
[]))}function Pn({ctx:e,grid:t},r,n,o){let s=o*t.cell;e.beginPath(),e.roundRect(t.left+r*t.cell-s/2,t.top+n*t.cell-s/2,s,s,s*.1),e.stroke()}var $n=(e,t)=>(t+.24)/(e+.24);function zn(e,t,r,n,o,s){let a=r?28*s:0,i=(l,c)=>(l-a)/(c+2*.12),u=Math.max(1,Math.floor(Math.min(i(n,t),i(o,e))));return{rows:e,cols:t,
cell:u,left:Math.round((n-t*u+a)/2),top:Math.round((o-e*u+a)/2)}}function Wn(e,t,r){let n=Math.floor((r-e.top)/e.cell),o=Math.floor((t-e.left)/e.cell);return n>=
0&&n<e.rows&&o>=0&&o<e.cols?[n,o]:null}var Ss={paper:"--board-paper",line:"--board-line",frame:"--board-frame",ink:"--board-ink",muted:"--board-muted",obstacle:"--board-obstacle",pursuer:"--pursuer",
evader:"--evader",capture:"--capture",collision:"--collision",focus:"--focus"};function Fn(e){let t=getComputedStyle(e),r=Object.entries(Ss).map(([n,o])=>[n,t.getPropertyValue(
o).trim()]);return Object.fromEntries(r)}var Jt=()=>matchMedia("(prefers-reduced-motion: reduce)").matches,ct=class{canvas;#e=null;#o=0;#n;#t={rows:1,cols:1,left:0,top:0,cell:1};#r=0;#a;#l;constructor(t,r={}){
this.canvas=t,t.classList.add("board"),t.setAttribute("role","img"),this.#n={...Ln,...r},this.#a=new ResizeObserver(()=>this.#f()),this.#a.observe(t),this.#l=new MutationObserver(
()=>this.redraw()),this.#l.observe(document.documentElement,{attributes:!0}),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",this.redraw)}close(){
this.#a.disconnect(),this.#l.disconnect(),matchMedia("(prefers-color-scheme: dark)").removeEventListener("change",this.redraw),cancelAnimationFrame(this.#r)}get look(){
return this.#n}set look(t){this.#n={...this.#n,...t},this.#c(),this.redraw()}show(t,r){this.#e=t,this.#o=Math.min(Math.max(0,r),t.moments.length-1),this.#c(),this.
redraw()}redraw=()=>{this.#r||(this.#r=requestAnimationFrame(()=>this.drawNow()))};drawNow(){cancelAnimationFrame(this.#r),this.#r=0;let t=this.canvas.getContext(
"2d");if(!t||!this.#e)return;let{rows:r,cols:n}=this.#e,o=devicePixelRatio||1;this.#t=zn(r,n,this.#n.axes,this.canvas.width,this.canvas.height,o);let s={ctx:t,grid:this.#t,
colors:Fn(this.canvas)};Un(s,this.#e,this.#o,this.#n,o)}cellAt(t,r){let n=this.canvas.getBoundingClientRect(),o=this.canvas.width/n.width;return Wn(this.#t,(t-n.
left)*o,(r-n.top)*o)}agentAt(t,r){let n=this.cellAt(t,r);if(!n||!this.#e)return null;let o=this.#e.moments[Math.round(this.#o)],s=We(this.#e,o).get(n[0]*this.#e.
cols+n[1])??[],a=ut(this.#e,Math.round(this.#o)),i=u=>{let[l,c]=this.pointOf(a[u].x,a[u].y);return Math.hypot(l-t,c-r)};return s.length?s.reduce((u,l)=>i(l)<i(u)?
l:u):null}pointOf(t,r){let n=this.canvas.getBoundingClientRect(),o=n.width/this.canvas.width,{left:s,top:a,cell:i}=this.#t;return[n.left+(s+t*i)*o,n.top+(a+r*i)*
o]}#c(){if(!this.#e)return;let{rows:t,cols:r}=this.#e;this.canvas.style.setProperty("--board-aspect",String($n(t,r)))}#f(){let t=devicePixelRatio||1,{width:r,height:n}=this.
canvas.getBoundingClientRect();this.canvas.width=Math.max(1,Math.round(r*t)),this.canvas.height=Math.max(1,Math.round(n*t)),this.drawNow()}};var De=[.5,1,2,4,8,16,32,64],Dn=0,pt=12,Ms=2,ft=class extends EventTarget{#e;#o;#n;#t=0;#r=0;#a=!1;#l=null;#c=0;#f=[];glide=.28;constructor(t,r={}){super(),this.#e=
t,this.#o=r.speed??4,this.#n=r.still??!1}get step(){return this.#t}get time(){return this.#n?this.#t:this.#r}get arrived(){return this.#r===this.#t}get playing(){
return this.#a}get length(){return this.#e}set length(t){this.#e=t,this.#t>t&&this.jump(t),this.#i("state")}get marks(){return this.#f}set marks(t){this.#f=t,this.#i(
"state")}get pace(){return this.#o||Math.max(Ms,this.#e/pt)}get speed(){return this.#o}set speed(t){this.#o=t,this.#i("state")}changeSpeed(t){let r=De.findIndex(
n=>n>=this.pace);this.speed=De[Math.min(De.length-1,Math.max(0,r+t))]}play(){this.#a||!this.#e||(this.#t===this.#e&&this.jump(0),this.#a=!0,this.#i("state"),this.#u())}pause(){
this.#a&&(this.#a=!1,this.#i("state"))}toggle(){this.#a?this.pause():this.play()}move(t){this.pause();let r=Math.min(this.#e,Math.max(0,this.#t+t));Math.abs(r-this.#r)>
1?this.jump(r):this.#p(r),this.#u()}jump(t){this.#r=Math.min(this.#e,Math.max(0,Math.round(t))),this.#p(this.#r),this.#i("frame")}#p(t){t!==this.#t&&(this.#t=t,
this.#i("step"),this.#n&&this.#i("frame"))}#u(){this.#l===null&&(this.#c=performance.now(),this.#l=requestAnimationFrame(()=>this.#s()))}#s(){this.#l=null;let t=performance.
now();this.#m(Math.min(.25,(t-this.#c)/1e3)),this.#c=t,(!this.#n||this.arrived)&&this.#i("frame"),(this.#a||this.#r!==this.#t)&&(this.#l=requestAnimationFrame(()=>this.#s()))}#m(t){
let r=t;for(;r>0;){if(this.#r===this.#t){if(!this.#a)return;if(this.#t===this.#e)return this.pause();this.#p(this.#t+1)}let n=this.#a?this.pace:1/this.glide,o=this.#t-
this.#r,s=Math.min(Math.abs(o),r*n);r-=s/n,this.#r=s===Math.abs(o)?this.#t:this.#r+Math.sign(o)*s}this.#a&&this.#r===this.#e&&this.pause()}#i(t){this.dispatchEvent(
new Event(t))}};function mt(e,t){if(t.ctrlKey||t.metaKey||t.altKey)return!1;let r=t.shiftKey?10:1,o={" ":()=>e.toggle(),ArrowRight:()=>e.move(r),ArrowLeft:()=>e.
move(-r),Home:()=>e.move(-e.length),End:()=>e.move(e.length),"+":()=>e.changeSpeed(1),"-":()=>e.changeSpeed(-1)}[t.key];return o?.(),o!==void 0}var Cs={first:"M6 5v14M19 5 9 12l10 7z",back:"M17 5 7 12l10 7z",play:"M7 4.5 19 12 7 19.5z",pause:"M8 5v14M16 5v14",forward:"M7 5l10 7-10 7z",last:"M18 5v14M5 5\
l10 7-10 7z"};function Bn(e){return Ft("svg",{viewBox:"0 0 24 24","aria-hidden":"true",class:"icon"},Ft("path",{d:Cs[e]}))}function Be(e,t,r,n){return h("button",
{type:"button",class:"player-button","aria-label":t,title:`${t} (${r})`,onclick:n},Bn(e))}function Hn(e){let t=Be("play","Play","Space",()=>e.toggle()),r=Ts(e),
n=h("div",{class:"captures","aria-hidden":"true",title:"Captures"}),o=Es(e),s=h("output",{class:"player-count"}),a=h("div",{class:"player",role:"group","aria-la\
bel":"Player"},Be("first","First step","Home",()=>e.move(-e.length)),Be("back","Step back","←",()=>e.move(-1)),t,Be("forward","Step forward","→",()=>e.move(
1)),Be("last","Last step","End",()=>e.move(e.length)),h("div",{class:"scrub"},n,r),s,o),i=()=>n.replaceChildren(...e.marks.map(l=>{let c=h("i");return c.style.left=
`${100*l/Math.max(1,e.length)}%`,c})),u=()=>{t.replaceChildren(Bn(e.playing?"pause":"play")),t.ariaLabel=e.playing?"Pause":"Play",t.title=`${t.ariaLabel} (Space\
)`,r.max=String(e.length),r.value=String(e.step),r.ariaValueText=`step ${e.step} of ${e.length}`,s.textContent=`${e.step} / ${e.length}`,s.style.minWidth=`${2*String(
e.length).length+3}ch`,o.value=String(e.speed)};return e.addEventListener("step",u),e.addEventListener("state",u),e.addEventListener("state",i),a.addEventListener(
"keydown",l=>{!(l.target instanceof HTMLSelectElement||l.key===" "&&l.target!==r)&&mt(e,l)&&l.preventDefault()}),u(),a}function Ts(e){let t=h("input",{type:"ran\
ge",class:"player-scrub",min:0,step:1,"aria-label":"Step"});return t.addEventListener("input",()=>{e.pause(),e.jump(Number(t.value))}),t}function Es(e){let t=`S\
teps a second, or the whole in ${pt} s (+ and -)`,r=h("select",{class:"player-speed","aria-label":"Speed",title:t},h("option",{value:Dn},`in ${pt} s`),...De.map(
n=>h("option",{value:n},`${n} / s`)));return r.addEventListener("change",()=>{e.speed=Number(r.value)}),r}function Gn(e,t,r){if(r===0)return[{kind:"start",text:_s(e),agents:[]}];let[n,o]=[t.moments[r-1],t.moments[r]],s=c=>q(c,e.config.n_pursuers),a=it(t,n,o),i=e.conflicts(
r),u=new Set(i.flatMap(c=>c.doomed)),l=a.map(c=>({kind:"capture",text:`${s(c)} is captured`,agents:[c]}));for(let c of lt(n,o))!a.includes(c)&&!u.has(c)&&l.push(
{kind:"end",text:`${s(c)} disappears`,agents:[c]});return l.push(...i.map(({kind:c,text:f,agents:p})=>({kind:c,text:f,agents:p}))),r===e.length&&l.unshift({kind:"\
end",text:Rs(e),agents:[]}),l}function _s({config:e}){return`${e.n_pursuers} pursuers and ${e.n_evaders} evaders on ${e.rows} x ${e.cols} cells, at most ${e.max_steps}\
 steps`}function Rs(e){let t=Math.round(e.statistics.capture_rate*e.config.n_evaders);return`The episode ends after ${e.length} steps with ${t} of ${e.config.n_evaders}\
 evaders captured`}var jn=["·","↑","→","↓","←","↗","↘","↙","↖"];var Ns={" ":0,s:0,ArrowUp:1,w:1,ArrowRight:2,d:2,ArrowDown:3,x:3,ArrowLeft:4,a:4,e:5,c:6,y:7,z:7,q:8},Xt=[8,1,5,4,0,2,7,3,6],Os=[7,8,9,4,5,6,1,2,3],ks=24,Is=Math.
tan(Math.PI/8);function Yn(e,t){if(e.ctrlKey||e.metaKey||e.altKey)return;let r=Os.findIndex(o=>e.code===`Numpad${o}`),n=Xt[r]??Ns[e.key.length===1?e.key.toLowerCase():
e.key];return n!==void 0&&n>4&&!t?void 0:n}function Kn(e){let t=Xt.map(r=>h("button",{type:"button","aria-label":et[r],onclick:()=>e(r)},jn[r]));return{element:h(
"div",{class:"play-pad",role:"group","aria-label":"Your move"},...t),show:r=>t.forEach((n,o)=>n.classList.toggle("absent",Xt[o]>4&&!r))}}function Vn(e,t,r){let n=Is*
Math.max(Math.abs(e),Math.abs(t)),o=s=>Math.abs(s)<n?0:s;return rn([0,0],r?[o(e),o(t)]:[e,t],r)}function Zn(e,t,r){let n=null,{canvas:o}=e;o.addEventListener("p\
ointerdown",({button:s,clientX:a,clientY:i})=>{n=s===0?[a,i]:null}),o.addEventListener("pointercancel",()=>{n=null}),o.addEventListener("pointerup",({clientX:s,
clientY:a})=>{let[i,u]=[n,t()];if(n=null,!i||!u)return;let[l,c]=[s-i[0],a-i[1]],f=e.cellAt(s,a);Math.hypot(l,c)>=ks?r(Vn(c,l,u.diagonal)):f&&r(Vn(f[0]-u.cell[0],
f[1]-u.cell[1],u.diagonal))})}function qn(e,t){let r=n=>{let o=t[n]-e[n],s=Se.findIndex(a=>a[n]===Math.sign(o)&&a[1-n]===0);return o?`${Math.abs(o)} ${et[s]}`:""};
return[r(0),r(1)].filter(Boolean).join(", ")||"on your cell"}var Ps=[0,1,2,4,8],ht=class{element;player=new ft(0,{speed:4,still:Jt()});#e;#o;#n=h("canvas",{tabindex:0,"aria-describedby":"play-keys"});#t=h("h2");#r=h("p",{
class:"play-told",role:"status"});#a=Kn(t=>this.act(t));#l=h("select",{},...Ps.map(t=>h("option",{value:t},t?`${t} / s`:"step by step")));#c=h("input",{type:"ch\
eckbox"});#f=h("section",{class:"play-ending",tabindex:-1,"aria-labelledby":"play-headline"});#p=Hn(this.player);#u=null;#s=null;#m=[];#i=null;#h=0;#d=0;constructor(t){
this.#e=t,this.#o=new ct(this.#n,{numbers:!1}),this.#n.setAttribute("role","application"),this.#l.addEventListener("change",()=>this.#y()),this.#c.addEventListener(
"change",()=>this.#v()),Zn(this.#o,()=>{let r=this.#i!==null&&this.#s&&T(this.#s.recording.moments.at(-1),this.#i);return r?{cell:r,diagonal:this.#s.config.diagonal}:
null},r=>this.act(r)),this.player.addEventListener("frame",()=>this.#s&&this.#o.show(this.#s.recording,this.player.time)),this.player.addEventListener("step",()=>this.#A()),
this.element=h("div",{class:"play"},h("header",{class:"play-head"},this.#t,this.#r),h("div",{class:"play-stage"},this.#n),h("div",{class:"play-side"},this.#f,this.#a.
element,h("label",{class:"play-choice",title:"Steps a second"},"Pace ",this.#l),h("label",{class:"play-choice"},this.#c," Fog: see only what it sees"),h("p",{class:"\
small muted play-keys",id:"play-keys"},"Arrow keys move and Space stays; Q W E A S D Z X C and the numeric keypad know diagonals, too. On the board: swipe, or t\
ap where to go.")),this.#p)}get played(){return this.#u&&{...this.#u.played,moves:this.#m}}get live(){return this.#s}play(t){this.#g(Bt(this.#e,t.played),t.played.
seat,t.title),[this.#u,this.#m,this.#h]=[t,[...t.played.moves],0],this.element.dataset.state="playing",this.#n.focus({preventScroll:!0}),tt(this.#s,t.played.seat)&&
this.#w()}watch(t,r,n){this.#u=null,this.#g(t,r,n),this.#x()}stop(){this.#y(),this.player.pause(),this.#u=null}act(t){let[r,n]=[this.#u,this.#s];if(!r||!n||this.
element.dataset.state!=="playing")return;this.#h=t;let o=Number(this.#l.value);this.#d||(this.#b(),o&&this.element.dataset.state==="playing"&&(this.#d=setInterval(
()=>this.#b(),1e3/o)))}key(t){let{target:r,key:n}=t;if(r instanceof HTMLSelectElement||r instanceof HTMLInputElement&&(r.type==="text"||n===" ")||r instanceof HTMLButtonElement&&
(n===" "||n==="Enter")||!this.#s)return!1;if(this.element.dataset.state!=="playing")return mt(this.player,t);let s=Yn(t,this.#s.config.diagonal);return s!==void 0&&
this.act(s),s!==void 0}#g(t,r,n){this.#y(),this.player.pause(),[this.#s,this.#i]=[t,r],this.#t.textContent=n,this.#n.ariaLabel=`Board, ${t.config.rows} by ${t.config.
cols} cells`,this.#a.show(t.config.diagonal),this.#f.replaceChildren(),this.player.length=t.length,this.player.jump(t.length),this.#v(),this.#A()}#v(){this.#o.look=
{you:this.#i,fog:this.#c.checked,viewers:this.#i===null?[]:[this.#i]}}#y(){clearInterval(this.#d),this.#d=0,this.#r.ariaLive=Number(this.#l.value)?"off":"polite"}#b(){
let[{policies:t,seat:r},n]=[this.#u.played,this.#s];n.step(t,r,this.#h),this.#m.push(this.#h),this.player.length=n.length,this.player.glide=Math.min(.22,.9/(Number(
this.#l.value)||4)),this.player.move(n.length-this.player.step),tt(n,r)&&this.#w()}#w(){this.#y();let[t,r,n]=[this.#u,this.#s,this.played],o=Hr()?t.link(n):null;
this.#f.replaceChildren(h("h3",{id:"play-headline"},$s(r,n.seat)),...t.ending(r,n),h("div",{class:"play-buttons"},h("button",{type:"button",class:"primary",onclick:()=>t.
again()},"Again"),h("button",{type:"button",onclick:()=>this.#x()},"Watch it"),h("button",{type:"button",onclick:()=>this.#S(r,n.seat)},"Save"),o&&h("button",{type:"\
button",onclick:({currentTarget:s})=>Ws(s,o)},"Link"))),this.element.dataset.state="ended",this.#f.focus({preventScroll:!0}),this.#f.scrollIntoView({block:"near\
est"})}#x(){this.element.dataset.state="watched",this.player.length=this.#s.length,this.player.jump(0),Jt()||this.player.play()}#S(t,r){let n=new Blob([en(this.#e,
t,r)],{type:"application/octet-stream"});h("a",{href:URL.createObjectURL(n),download:`${q(r,t.config.n_pursuers)}-${t.length}-steps.npz`}).click()}#A(){let[t,r,
{step:n}]=[this.#s,this.#i,this.player];if(!t||n>t.length)return;let o=Gn(t,t.recording,n).filter(({agents:a})=>r===null||a.includes(r)),s=[`Step ${n} of ${t.config.
max_steps}`,...o.map(({text:a})=>a)];this.#u&&n===0?s.push(Ls(t.config,r)):r!==null&&s.push(Us(t,n,r)),this.#r.textContent=s.filter(Boolean).map(a=>`${a}.`).join(
" ")}};function Ls(e,t){let r=e.rules.capture==="SURROUND";return pe(e,t)==="evader"?`Stay free: ${r?"pursuers on all sides of you capture":"a pursuer on your c\
ell captures"} you`:`Capture evaders: ${r?"surround them together":"reach their cell"}`}function Us({config:e,recording:t},r,n){let o=t.moments[r],a=pe(e,n)==="\
pursuer"?"evader":"pursuer";if(!o.alive[n])return"";let i=T(o,n),u=f=>{let[p,m]=T(o,f);return Math.max(Math.abs(p-i[0]),Math.abs(m-i[1]))},l=Array.from({length:o.
alive.length},(f,p)=>p).filter(f=>pe(e,f)===a&&o.alive[f]&&!o.captured[f-e.n_pursuers]&&2*u(f)<e.fov);if(!l.length)return`No ${a} in view`;let c=l.reduce((f,p)=>u(
p)<u(f)?p:f);return`Nearest ${a}: ${qn(i,T(o,c))}`}function $s(e,t){let[{lasted:r,out:n,captured:o},{config:s}]=[ue(e,t),e];return pe(s,t)==="pursuer"?`Your tea\
m captured ${o} of ${zs(s)} in ${r} steps.`:n?`You lasted ${r} of ${s.max_steps} steps.`:`You escaped: ${r} steps.`}var zs=({n_evaders:e})=>`${e} evader${e===1?
"":"s"}`;function Ws(e,t){let r=h("input",{type:"text",readonly:!0,value:t,"aria-label":"Link to this match"});e.replaceWith(r),r.select(),navigator.clipboard?.
writeText(t).catch(()=>{})}var re=JSON.parse(Wt("data")),ce={pursuer:Jn("pursuer"),evader:Jn("evader")};function Jn(e){let{names:t,scripts:r,network:n}=re.teams[e],o=s=>{let a=r[s];if(a||
!n)return a;let[i,u]=[n.genome_size,r.slice(0,s).filter(l=>l===null).length];return{...n,genome:Dr(e,i).subarray(u*i,(u+1)*i)}};return t.map((s,a)=>({name:s,policy:()=>o(
a)}))}function eo(e,t,r,n){let[o,s]=[re.world,xe[+(n.seat>=re.world.n_pursuers)]],a=xe.map(l=>ce[l][r[l]].name),i={pursuer:ce.pursuer[r.pursuer].policy(),evader:ce.
evader[r.evader].policy()},u=`You are ${q(n.seat,o.n_pursuers)}: pursuers ${a[0]}, evaders ${a[1]}`;Ht(e,t,u,{config:o,seed:r.seed,episode:0,policies:i,...n},ce[s],
{pursuers:r.pursuer,evaders:r.evader,seed:r.seed})}function Xn(e,t){let r=new URLSearchParams(location.hash.slice(1)),n=Zr(r,re.world),[o,s]=[Number(r.get("purs\
uers")??NaN),Number(r.get("evaders")??NaN)],a=/^\d{1,20}$/.test(r.get("seed")??"")?BigInt.asUintN(64,BigInt(r.get("seed"))):null;return!n||a===null||!ce.pursuer[o]||
!ce.evader[s]?!1:(eo(e,t,{pursuer:o,evader:s,seed:a},n),!0)}var Qn=(e,t)=>h("select",{},...e.map((r,n)=>h("option",{value:n,selected:n===t},r)));function Fs(e,t){
let[r,n,o]=[Qn(["an evader","a pursuer"],0),...xe.map(u=>Qn(re.teams[u].names,re.teams[u].names.length-1))],s=h("p",{class:"problem",role:"alert"}),a=()=>eo(e,t,
{pursuer:Number(n.value),evader:Number(o.value),seed:nt()},{seat:r.value==="0"?re.world.n_pursuers:0,from:0,moves:[]}),i=h("input",{type:"file",accept:".npz",hidden:!0});
return i.addEventListener("change",()=>{let[u]=i.files??[];s.textContent="",u?.arrayBuffer().then(l=>tn(e,new Uint8Array(l))).then(({live:l,seat:c})=>t.watch(l,
c,u.name)).catch(l=>s.textContent=`${u.name} holds no match: ${l.message}`),i.value=""}),h("details",{class:"card setup",open:matchMedia("(min-width: 761px)").matches},
h("summary",{},"Play something else"),h("div",{},h("label",{},"You are ",r),h("label",{},"Pursuers ",n),h("label",{},"Evaders ",o),h("button",{type:"button",class:"\
primary",onclick:a},"Play"),h("button",{type:"button",onclick:()=>ot(t,re.world,ce.pursuer)},"Can you escape it?"),h("button",{type:"button",onclick:()=>i.click()},
"Open a file"),i,s))}async function Ds(){let e=await Ar(),t=new ht(e);document.getElementById("page").replaceWith(h("header",{class:"top"},h("h1",{},re.title),Gr()),
h("main",{},Fs(e,t),h("section",{class:"card","aria-label":"Match"},t.element))),document.addEventListener("keydown",r=>t.key(r)&&r.preventDefault()),window.addEventListener(
"hashchange",()=>Xn(e,t)),Xn(e,t)||ot(t,re.world,ce.pursuer),Object.assign(window,{matrixworldPlay:t})}Ds().catch(e=>{throw(document.getElementById("page")??document.
body).append(h("p",{class:"card problem",role:"alert"},`The page could not start: ${e instanceof Y?e.message:String(e)}`)),e}).finally(()=>{document.body.dataset.
ready="true"});})();
