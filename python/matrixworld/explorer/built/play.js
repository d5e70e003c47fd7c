/* built from web/ by "npm run build"; sources 50e0eaa366f40bf7d169e040a6c6810f69489aa7ccbd35037d6fdccec45f99b3 */
"use strict";(()=>{var sr={SIMULTANEOUS:0,SWARM_TURNS:1,AGENT_TURNS:2},Pe={DISAPPEAR:0,REACH:1,BOUNCE:2},ar={OCCUPATION:0,SURROUND:1},ir={FAULT:0,INVOLVED:1};var vt=["obstacle","teammate","adversary"],bt=["vertex","edge","chain"],lr=["turn","kind","form","first","second","row","col","at_fault","held","doomed"],wt=["p\
ursuer_{number}","evader_{number}"],ur={obstacle:"{first} ran into the obstacle or border at {cell}",vertex:"{first} and {second} both headed for {cell}",edge:"\
{first} and {second} meant to swap, {first} to {cell}",chain:"{first} headed for {cell}, where {second} had to stay"},Ie={"both held":"both bounce","both doomed":"\
both disappear",held:"{agent} bounces",doomed:"{agent} disappears",none:"nobody is stopped"},cr="{event}: {outcome}",xt={random:"any action, all equally likely",
still:"always stays",chaser:"moves to where the nearest adversary in view is nearest",fleer:"moves to where the nearest adversary in view is farthest","clumsy-c\
haser":"a chaser that takes any action in half of the steps",hunter:"a chaser of the nearest adversary in view to which no teammate in view is nearer",surrounder:"\
a chaser of the nearest free cell beside an adversary without a teammate","clumsy-fleer":"a fleer that takes any action in half of the steps",dodger:"moves to w\
here all adversaries in view together are farthest"},fr={free:".GS",blocked:"#@OTW"};var be=1+lr.length;function Le(t,e){return t.replace(/\{(\w+)\}/g,(r,n)=>String(e[n]))}function q(t,e){return t<e?Le(wt[0],{number:t}):Le(wt[1],{number:t-e})}function mo(t,e){
let[r,n,o,s,a,i,l,...u]=Array.from(t),c=a<0?[s]:[s,a],[f,p,m]=u.map(w=>c.filter((S,v)=>w>>v&1)),y=c.map(w=>q(w,e)),d=Le(ur[a<0?"obstacle":bt[o]],{first:y[0],second:y[y.
length-1],cell:`(${i}, ${l})`}),g=Le(cr,{event:d,outcome:ho(c.length,p,m,e)});return{kind:vt[n],form:bt[o],agents:c,cell:[i,l],at_fault:f,held:p,doomed:m,turn:r,
text:g}}function ho(t,e,r,n){if(t===2&&e.length===2)return Ie["both held"];if(t===2&&r.length===2)return Ie["both doomed"];let o=s=>a=>Le(Ie[s],{agent:q(a,n)});
return[...e.map(o("held")),...r.map(o("doomed"))].join(", ")||Ie.none}function Ze(t,e){let r=[];for(let n=0;n<t.length;n+=be)r.push(mo(t.subarray(n+1,n+be),e));
return r}var Y=class extends Error{name="EngineError"};function P(t,e,r){let n=typeof r=="string"?`'${r}'`:typeof r=="object"?JSON.stringify(r):String(r);return new Y(`${t}\
: expected ${e}, got ${n}`)}var we=class{bytes;constructor(e){this.bytes=e}},hr=0,St=[Uint8Array,Uint8Array,Int32Array,BigInt64Array,BigUint64Array,Float32Array,Float64Array],pr=4,mr=4,yo=new TextEncoder,
go=new TextDecoder;function vo(t){for(let e=St.length-1;e>hr;--e)if(t instanceof St[e])return e;throw new TypeError("array: expected a typed array of the engine\
's numbers, got another")}function At(t){return new Uint8Array(t.buffer,t.byteOffset,t.byteLength)}function bo(t){return yo.encode(`${t}\0`)}var Mt=class{engine;addresses=[];constructor(e){
this.engine=e}copy(e){let r=this.engine._malloc(Math.max(e.length,1));if(r===0)throw new Y("memory: expected room for the arguments, got none");return this.addresses.
push(r),this.engine.HEAPU8.set(e,r),r}text(e){return this.copy(bo(e))}arrays(e){let r=Object.entries(e),n=r.flatMap(([s,a])=>{let i=a instanceof we,l=i?a.bytes:
a;return[this.text(s),i?hr:vo(l),l.length,this.copy(At(l))]}),o=this.copy(At(Int32Array.from(n)));return this.copy(At(Int32Array.of(r.length,o)))}free(){for(let e of this.
addresses)this.engine._free(e)}};function dr(t,e){let r=t.HEAPU8;return go.decode(r.subarray(e,r.indexOf(0,e)))}function xe(t){let e=new Int32Array(t.HEAPU8.buffer),
r=t._last_outputs()/pr,n=e[r+1]/pr,o={};for(let s=n;s<n+e[r]*mr;s+=mr){let a=St[e[s+1]],i=e[s+2]*a.BYTES_PER_ELEMENT,l=e[s+3];o[dr(t,e[s])]=new a(t.HEAPU8.slice(
l,l+i).buffer)}return o}function le(t,e){let r=new Mt(t);try{let n=e(r);if(n===0)throw new Y(dr(t,t._last_error()));return n}finally{r.free()}}var wo=2**31-1,yr=["none","elman","gru"],xo=2n**64n-1n,Ao=34028234663852886e22;function oe(t,e){if(typeof e!="number"||!Number.isInteger(e)||Math.abs(e)>wo)throw P(
t,"an integer",e);return Int32Array.of(e)}function qe(t,e){if(typeof e!="boolean")throw P(t,"true or false",e);return new we(Uint8Array.of(Number(e)))}function me(t,e,r){
let n=typeof e=="string"&&Object.hasOwn(r,e)?r[e]:void 0;if(n===void 0)throw P(t,`one of ${Object.keys(r).join(", ")}`,e);return Int32Array.of(n)}function Tt(t,e){
if(typeof e!="number"||!(Math.abs(e)<=Ao))throw P(t,"a finite number",e);return e}function Ae(t,e){let n=typeof e=="bigint"||typeof e=="number"&&Number.isSafeInteger(
e)?BigInt(e):-1n;if(n<0n||n>xo)throw P(t,"an integer from 0 to 2^64 - 1",e);return BigUint64Array.of(n)}function So(t){return{"rules.interaction":me("interactio\
n",t.interaction,sr),"rules.obstacle":me("obstacle",t.obstacle,Pe),"rules.teammate":me("teammate",t.teammate,Pe),"rules.evader":me("evader",t.evader,Pe),"rules.\
pursuer":me("pursuer",t.pursuer,Pe),"rules.capture":me("capture",t.capture,ar),"rules.captured_disappear":qe("captured_disappear",t.captured_disappear)}}function gr(t,e){
let r=typeof e=="number"?[e,e,e]:e;if(!Array.isArray(r)||r.length!==3)throw P(t,"1 or 3 numbers",e);return Float32Array.from(r,n=>Tt(t,n))}function Mo(t){let e=(r,n)=>Float32Array.
of(Tt(r,t[r]),Tt(n,t[n]));return{"rewards.capture":e("pursuer_capture","evader_capture"),"rewards.neighbor":e("pursuer_neighbor","evader_neighbor"),"rewards.ste\
p":e("pursuer_step","evader_step"),"rewards.pursuer_collide":gr("pursuer_collide",t.pursuer_collide),"rewards.evader_collide":gr("evader_collide",t.evader_collide),
"rewards.blame":me("blame",t.blame,ir),"rewards.capture_repeats":qe("capture_repeats",t.capture_repeats)}}function br(t){if(t===void 0||typeof t=="number")return new Uint8Array(
0);if(t instanceof Uint8Array)return t;let{free:e,blocked:r}=fr;for(let[n,o]of t.entries()){if(o.length!==t[0]?.length)throw P(`map, row ${n}`,`${t[0]?.length} \
cells as in row 0`,o.length);let s=[...o].find(a=>!e.includes(a)&&!r.includes(a));if(s)throw P(`map, row ${n}`,`'${e}' (free) or '${r}' (obstacle)`,s)}return Uint8Array.
from([...t.join("")],n=>Number(r.includes(n)))}function wr(t,e){if(!Array.isArray(t))return;let r=[t.length,t[0]?.length??0];if(!(r[0]===e.rows&&r[1]===e.cols))
throw P("obstacle map",`shape (${e.rows}, ${e.cols}), the rows and cols`,r)}function Se(t){wr(t.obstacles,t);let e=typeof t.obstacles=="number"?t.obstacles:0;return{
...So(t.rules),...Mo(t.rewards),rows:oe("rows",t.rows),cols:oe("cols",t.cols),n_pursuers:oe("n_pursuers",t.n_pursuers),n_evaders:oe("n_evaders",t.n_evaders),fov:oe(
"fov",t.fov),diagonal:qe("diagonal",t.diagonal),max_steps:oe("max_steps",t.max_steps),density:Float64Array.of(e),map:br(t.obstacles)}}function vr(t,e){return Int32Array.
from((e??[]).flat(),r=>oe(t,r)[0])}function xr(t,e){return wr(t.obstacles,e),{seed:Ae("seed",t.seed??0n),episode:Ae("episode",t.episode??0),pursuers:vr("pursuer\
s",t.pursuers),evaders:vr("evaders",t.evaders),map:br(t.obstacles)}}function Je(t){return{actions:Int32Array.from(t,e=>oe("actions",e)[0])}}function Me(t){if(typeof t==
"string"){if(!Object.hasOwn(xt,t))throw P("policy",`one of ${Object.keys(xt).join(", ")}`,t);return{script:new TextEncoder().encode(t)}}if(t.activation!=="relu"&&
t.activation!=="tanh")throw P("activation","'relu' or 'tanh'",t.activation);if(!yr.includes(t.memory))throw P("memory",`one of ${yr.join(", ")}`,t.memory);return{
hidden:Int32Array.from(t.hidden,e=>oe("hidden",e)[0]),activation:new TextEncoder().encode(t.activation),sampled:qe("sampled",t.sampled),memory:new TextEncoder().
encode(t.memory),genome:t.genome}}var To=["first_turn","terminated","truncated"];function Ar(t){let e={...t};for(let r of To)e[r]=new we(t[r]);return e}var Xe=class{config;seed;episode;n_agents;statistics;first_conflict;constructor(e,r,n,o){this.config=e,this.seed=r,this.episode=n,this.n_agents=e.n_pursuers+e.n_evaders,
this.statistics=Sr(o,0),Object.assign(this,o),this.first_conflict=Co(this.conflict_table,this.length)}get length(){return this.actions.length/this.n_agents}conflicts(e){
this.check(e);let[r,n]=[this.first_conflict[e],this.first_conflict[e+1]],o=this.conflict_table.subarray(r*be,n*be);return Ze(o,this.config.n_pursuers)}seek(e,r,n){
this.check(r),(!(e.seed===this.seed&&e.episode===BigInt(this.episode))||e.turn!==0||e.steps>r)&&e.reset({seed:this.seed,episode:this.episode});for(let s=e.steps;s<
r;++s){let a=this.actions.subarray(s*this.n_agents,(s+1)*this.n_agents);n?e.replay(a,{pursuer:n.pursuers,evader:n.evaders}):e.step(a)}}check(e){if(!(Number.isInteger(
e)&&e>=0&&e<=this.length))throw P("step",`0 to ${this.length}`,e)}};function Co(t,e){let r=new Int32Array(e+2);for(let n=0;n<t.length;n+=be)++r[t[n]+1];for(let n=1;n<
r.length;++n)r[n]+=r[n-1];return r}function Sr(t,e){let r=t["statistics.length"].length,n=s=>{let a=t[`statistics.${s}`],i=a.length/r;return a.slice(e*i,(e+1)*i)},
o=s=>Number(n(s)[0]);return{capture_rate:o("capture_rate"),ever_capture_rate:o("ever_capture_rate"),captured_fraction:o("captured_fraction"),length:o("length"),
return:n("return"),survivors:n("survivors"),overlap:n("overlap"),collisions:n("collisions"),faults:n("faults"),agent_steps:n("agent_steps")}}function Mr(t,e,r,n){
let o=[Se(r.config),Me(r.pursuers),Me(r.evaders),n];return le(t,s=>{let[a,i,l,u]=o.map(c=>s.arrays(c));return t[e](a,i,l,u)}),xe(t)}function Tr(t,e,r,n){let o={
seed:Ae("seed",r),episode:Ae("episode",n)};return new Xe(e.config,r,n,Mr(t,"_play_match",e,o))}function Cr(t,e,r,n){if(!Number.isInteger(n)||n<1)throw P("n_epis\
odes","at least 1",n);let o={seed:Ae("seed",r),n_episodes:Int32Array.of(n)},s=Mr(t,"_play_rollout",e,o);return Array.from({length:n},(a,i)=>Sr(s,i))}var Eo=7e6,_o=new FinalizationRegistry(([t,e])=>t._states_free(e));function Ro({rules:t,rows:e,cols:r,obstacles:n,diagonal:o,n_pursuers:s,n_evaders:a}){let i=typeof n==
"number"||t.obstacle==="REACH"?0:n.join("").split("#").length-1,l=e*r-i,u=[t.obstacle,t.teammate,t.pursuer].includes("DISAPPEAR"),c=t.capture==="SURROUND"||t.evader===
"REACH",f=t.interaction==="AGENT_TURNS",p=(d,g)=>Array.from({length:g},(w,S)=>f?d:(d+S)/(S+1)).reduce((w,S)=>w*S,1),m=p(l+Number(u),s)*p(l*(1+Number(c))+2,a);return{
SIMULTANEOUS:[s+a],SWARM_TURNS:[s,a],AGENT_TURNS:Array(s+a).fill(1)}[t.interaction].reduce((d,g)=>d+m*(o?9:5)**g,0)}function Qe(t){return typeof t.obstacles=="n\
umber"&&t.obstacles>0?"obstacles are drawn anew in each episode":Ro(t)>Eo?"the world is too large to be solved on the page":""}var Ct=class{value;teams;matrix;n_actions;constructor(e,r){
let{matrix:n,rows:o,cols:s,value:a,agents:i}=r,[l,u]=e.actors,c=Array.from(i).filter(p=>l<=p&&p<u),f=p=>p<e.config.n_pursuers;[this.value,this.matrix,this.n_actions]=
[a[0],n,e.n_actions],this.teams=[{agents:c.filter(f),play:o},{agents:c.filter(p=>!f(p)),play:s}]}marginal(e){let r=this.teams.find(({agents:s})=>s.includes(e));
if(!r)return null;let n=this.n_actions**(r.agents.length-1-r.agents.indexOf(e)),o=Array(this.n_actions).fill(0);return r.play.forEach((s,a)=>o[Math.floor(a/n)%this.
n_actions]+=s),o}lost(e){let[r,n]=this.teams.map(({agents:l})=>l.reduce((u,c)=>u*this.n_actions+e[c],0)),[o,s]=this.teams.map(({play:l})=>l),a=s.reduce((l,u,c)=>l+
u*this.matrix[r*s.length+c],0),i=o.reduce((l,u,c)=>l+u*this.matrix[c*s.length+n],0);return[Math.max(0,this.value-a),Math.max(0,i-this.value)]}},$e=class{config;engine;states;n_turns;values;constructor(e,r){
[this.engine,this.config]=[e,r],this.states=le(e,o=>e._states_new(o.arrays(Se(r)))),_o.register(this,[e,this.states]);let n={SIMULTANEOUS:1,SWARM_TURNS:2,AGENT_TURNS:r.
n_pursuers+r.n_evaders};this.n_turns=n[r.rules.interaction],this.values=[[this.call(()=>e._states_payoffs(this.states)).payoffs]]}goBack(){let e=this.values.at(
-1)[0],r=[];for(let n=this.n_turns-1;n>=0;n--){let o=r[n+1]??e;r[n]=this.call(s=>this.engine._states_backup(this.states,n,s.arrays({next:o}))).values}return this.
values.push(r),this.values.length<=this.config.max_steps&&r[0].some((n,o)=>n!==e[o])}game(e){let[r,{turn:n}]=[this.config.max_steps-e.steps,e],o=n+1===this.n_turns,
s=r>0?this.values[Math.min(r-Number(o),this.values.length-1)]?.[o?0:n+1]:void 0;if(!s)return null;let a=this.call(i=>this.engine._states_game(this.states,e.address,
i.arrays({next:s})));return a.agents.length?new Ct(e,a):null}call(e){return le(this.engine,e),xe(this.engine)}};var Er=new FinalizationRegistry(([t,e])=>t._world_free(e)),Ue=class{config;n_agents;n_actions;engine;at;freed=!1;constructor(e,r){this.engine=e,this.config=r,this.
n_agents=r.n_pursuers+r.n_evaders,this.n_actions=r.diagonal?9:5,this.at=le(e,n=>e._world_new(n.arrays(Se(r)))),Er.register(this,[e,this.at],this)}free(){this.freed||
(this.freed=!0,Er.unregister(this),this.engine._world_free(this.at))}get address(){return this.at}reset(e={}){let r=xr(e,this.config);this.call(n=>this.engine._world_reset(
this.at,n.arrays(r)))}step(e){let r=Je(e);this.call(n=>this.engine._world_step(this.at,n.arrays(r)))}playTurn(e){let r=Je(e);this.call(n=>this.engine._world_play_turn(
this.at,n.arrays(r)))}decide(e,r,n){let{n_pursuers:o}=this.config,s={pursuer:[0,o],evader:[o,this.n_agents]},[a,i]=typeof r=="string"?s[r]:r;if(n.length!==this.
n_agents)throw P("actions",String(this.n_agents),n.length);let l=[Me(e),Je(n)],{actions:u}=this.call(c=>this.engine._world_decide(this.at,c.arrays(l[0]),a,i,c.arrays(
l[1])));return Uint8Array.from(u)}replay(e,r){let n=s=>typeof s!="string"&&s.memory!=="none";if(!n(r.pursuer)&&!n(r.evader))return this.step(e);let{n_pursuers:o}=this.
config;for(let s=this.n_turns;s>0;--s){let[a,i]=this.actors;a<o&&this.decide(r.pursuer,[a,Math.min(i,o)],e),i>o&&this.decide(r.evader,[Math.max(a,o),i],e),this.
playTurn(e)}}get n_turns(){return this.turnNumbers()[1]}get turn(){return this.turnNumbers()[0]}get actors(){let[,,e,r]=this.turnNumbers();return[e,r]}turnNumbers(){
return this.call(()=>this.engine._world_turn(this.at)).turn}get steps(){return this.read("steps")[0]}get seed(){return this.read("seed")[0]}get episode(){return this.
read("episode")[0]}get over(){return this.read("terminated")[0]===1||this.read("truncated")[0]===1}read(e){return this.call(r=>this.engine._world_read(this.at,r.
text(e)))[e]}view(e){let r=3*this.config.fov**2;return this.read("views").slice(e*r,(e+1)*r)}map(){return this.read("state").slice(2*this.config.rows*this.config.
cols)}conflicts(){return Ze(this.conflictTable(),this.config.n_pursuers)}conflictTable(){return this.call(()=>this.engine._world_conflicts(this.at)).conflict_table}answer(e,r){
let n=Me(e),{logits:o,memory:s}=this.call(l=>this.engine._world_logits(this.at,l.arrays(n),r)),a=o,i=this.decide(e,[r,r+1],new Uint8Array(this.n_agents))[r];return{
logits:a,probabilities:ko(a),action:i,memory:s}}snapshot(){return this.call(()=>this.engine._world_snapshot(this.at))}restore(e){let r=Ar(e);this.call(n=>this.engine.
_world_restore(this.at,n.arrays(r)))}call(e){if(this.freed)throw P("world","one that is in use","one that was freed");return le(this.engine,e),xe(this.engine)}};
function ko(t){let e=Math.max(...t),r=Array.from(t,o=>Math.exp(o-e)),n=r.reduce((o,s)=>o+s,0);return Float32Array.from(r,o=>o/n)}var Et=class{compiled;constructor(e){this.compiled=e}world(e){return new Ue(this.compiled,e)}solution(e){return new $e(this.compiled,e)}match(e,r,n,o,s=0){return Tr(
this.compiled,{config:e,pursuers:r,evaders:n},o,s)}rollout(e,r,n,o,s){return Cr(this.compiled,{config:e,pursuers:r,evaders:n},o,s)}},_r;function Rr(t=globalThis.
matrixworldEngine){return _r??=No(t),_r}async function No(t){if(!t)throw new Error("matrixworldEngine: expected the script engine.js before this one, got none");
let e=Uint8Array.from(atob(t.binary),r=>r.charCodeAt(0));return new Et(await t({wasmBinary:e}))}var T=Uint8Array,j=Uint16Array,zt=Int32Array,tt=new T([0,0,0,0,0,0,0,0,1,1,1,1,2,2,2,2,3,3,3,3,4,4,4,4,5,5,5,5,0,0,0,0]),rt=new T([0,0,0,0,1,1,2,2,3,3,4,4,5,5,6,
6,7,7,8,8,9,9,10,10,11,11,12,12,13,13,0,0]),Ot=new T([16,17,18,0,8,7,9,6,10,5,11,4,12,3,13,2,14,1,15]),Lr=function(t,e){for(var r=new j(31),n=0;n<31;++n)r[n]=e+=
1<<t[n-1];for(var o=new zt(r[30]),n=1;n<30;++n)for(var s=r[n];s<r[n+1];++s)o[s]=s-r[n]<<5|n;return{b:r,r:o}},$r=Lr(tt,2),Ur=$r.b,Pt=$r.r;Ur[28]=258,Pt[258]=28;var zr=Lr(
rt,0),Oo=zr.b,kr=zr.r,It=new j(32768);for(M=0;M<32768;++M)se=(M&43690)>>1|(M&21845)<<1,se=(se&52428)>>2|(se&13107)<<2,se=(se&61680)>>4|(se&3855)<<4,It[M]=((se&65280)>>
8|(se&255)<<8)>>1;var se,M,te=(function(t,e,r){for(var n=t.length,o=0,s=new j(e);o<n;++o)t[o]&&++s[t[o]-1];var a=new j(e);for(o=1;o<e;++o)a[o]=a[o-1]+s[o-1]<<1;
var i;if(r){i=new j(1<<e);var l=15-e;for(o=0;o<n;++o)if(t[o])for(var u=o<<4|t[o],c=e-t[o],f=a[t[o]-1]++<<c,p=f|(1<<c)-1;f<=p;++f)i[It[f]>>l]=u}else for(i=new j(
n),o=0;o<n;++o)t[o]&&(i[o]=It[a[t[o]-1]++]>>15-t[o]);return i}),ue=new T(288);for(M=0;M<144;++M)ue[M]=8;var M;for(M=144;M<256;++M)ue[M]=9;var M;for(M=256;M<280;++M)
ue[M]=7;var M;for(M=280;M<288;++M)ue[M]=8;var M,Fe=new T(32);for(M=0;M<32;++M)Fe[M]=5;var M,Po=te(ue,9,0),Io=te(ue,9,1),Lo=te(Fe,5,0),$o=te(Fe,5,1),_t=function(t){
for(var e=t[0],r=1;r<t.length;++r)t[r]>e&&(e=t[r]);return e},J=function(t,e,r){var n=e/8|0;return(t[n]|t[n+1]<<8)>>(e&7)&r},Rt=function(t,e){var r=e/8|0;return(t[r]|
t[r+1]<<8|t[r+2]<<16)>>(e&7)},Wt=function(t){return(t+7)/8|0},De=function(t,e,r){return(e==null||e<0)&&(e=0),(r==null||r>t.length)&&(r=t.length),new T(t.subarray(
e,r))};var Uo=["unexpected EOF","invalid block type","invalid length/literal","invalid distance","stream finished","no stream handler",,"no callback","invalid UTF-8 da\
ta","extra field too long","date not in range 1980-2099","filename too long","stream finishing","invalid zip data"],z=function(t,e,r){var n=new Error(e||Uo[t]);
if(n.code=t,Error.captureStackTrace&&Error.captureStackTrace(n,z),!r)throw n;return n},Wr=function(t,e,r,n){var o=t.length,s=n?n.length:0;if(!o||e.f&&!e.l)return r||
new T(0);var a=!r,i=a||e.i!=2,l=e.i;a&&(r=new T(o*3));var u=function(Ne){var Oe=r.length;if(Ne>Oe){var ve=new T(Math.max(Oe*2,Ne));ve.set(r),r=ve}},c=e.f||0,f=e.
p||0,p=e.b||0,m=e.l,y=e.d,d=e.m,g=e.n,w=o*8;do{if(!m){c=J(t,f,1);var S=J(t,f+1,3);if(f+=3,S)if(S==1)m=Io,y=$o,d=9,g=5;else if(S==2){var N=J(t,f,31)+257,k=J(t,f+
10,15)+4,x=N+J(t,f+5,31)+1;f+=14;for(var b=new T(x),I=new T(19),O=0;O<k;++O)I[Ot[O]]=J(t,f+O*3,7);f+=k*3;for(var W=_t(I),ie=(1<<W)-1,B=te(I,W,1),O=0;O<x;){var F=B[J(
t,f,ie)];f+=F&15;var v=F>>4;if(v<16)b[O++]=v;else{var L=0,_=0;for(v==16?(_=3+J(t,f,3),f+=2,L=b[O-1]):v==17?(_=3+J(t,f,7),f+=3):v==18&&(_=11+J(t,f,127),f+=7);_--;)
b[O++]=L}}var D=b.subarray(0,N),$=b.subarray(N);d=_t(D),g=_t($),m=te(D,d,1),y=te($,g,1)}else z(1);else{var v=Wt(f)+4,A=t[v-4]|t[v-3]<<8,E=v+A;if(E>o){l&&z(0);break}
i&&u(p+A),r.set(t.subarray(v,E),p),e.b=p+=A,e.p=f=E*8,e.f=c;continue}if(f>w){l&&z(0);break}}i&&u(p+131072);for(var ke=(1<<d)-1,V=(1<<g)-1,ne=f;;ne=f){var L=m[Rt(
t,f)&ke],G=L>>4;if(f+=L&15,f>w){l&&z(0);break}if(L||z(2),G<256)r[p++]=G;else if(G==256){ne=f,m=null;break}else{var H=G-254;if(G>264){var O=G-257,R=tt[O];H=J(t,f,
(1<<R)-1)+Ur[O],f+=R}var Q=y[Rt(t,f)&V],ye=Q>>4;Q||z(3),f+=Q&15;var $=Oo[ye];if(ye>3){var R=rt[ye];$+=Rt(t,f)&(1<<R)-1,f+=R}if(f>w){l&&z(0);break}i&&u(p+131072);
var ge=p+H;if(p<$){var Ye=s-$,Ke=Math.min($,ge);for(Ye+p<0&&z(3);p<Ke;++p)r[p]=n[Ye+p]}for(;p<ge;++p)r[p]=r[p-$]}}e.l=m,e.p=ne,e.b=p,e.f=c,m&&(c=1,e.m=d,e.d=y,e.
n=g)}while(!c);return p!=r.length&&a?De(r,0,p):r.subarray(0,p)},ae=function(t,e,r){r<<=e&7;var n=e/8|0;t[n]|=r,t[n+1]|=r>>8},ze=function(t,e,r){r<<=e&7;var n=e/
8|0;t[n]|=r,t[n+1]|=r>>8,t[n+2]|=r>>16},kt=function(t,e){for(var r=[],n=0;n<t.length;++n)t[n]&&r.push({s:n,f:t[n]});var o=r.length,s=r.slice();if(!o)return{t:Dr,
l:0};if(o==1){var a=new T(r[0].s+1);return a[r[0].s]=1,{t:a,l:1}}r.sort(function(E,N){return E.f-N.f}),r.push({s:-1,f:25001});var i=r[0],l=r[1],u=0,c=1,f=2;for(r[0]=
{s:-1,f:i.f+l.f,l:i,r:l};c!=o-1;)i=r[r[u].f<r[f].f?u++:f++],l=r[u!=c&&r[u].f<r[f].f?u++:f++],r[c++]={s:-1,f:i.f+l.f,l:i,r:l};for(var p=s[0].s,n=1;n<o;++n)s[n].s>
p&&(p=s[n].s);var m=new j(p+1),y=Lt(r[c-1],m,0);if(y>e){var n=0,d=0,g=y-e,w=1<<g;for(s.sort(function(N,k){return m[k.s]-m[N.s]||N.f-k.f});n<o;++n){var S=s[n].s;
if(m[S]>e)d+=w-(1<<y-m[S]),m[S]=e;else break}for(d>>=g;d>0;){var v=s[n].s;m[v]<e?d-=1<<e-m[v]++-1:++n}for(;n>=0&&d;--n){var A=s[n].s;m[A]==e&&(--m[A],++d)}y=e}return{
t:new T(m),l:y}},Lt=function(t,e,r){return t.s==-1?Math.max(Lt(t.l,e,r+1),Lt(t.r,e,r+1)):e[t.s]=r},Nr=function(t){for(var e=t.length;e&&!t[--e];);for(var r=new j(
++e),n=0,o=t[0],s=1,a=function(l){r[n++]=l},i=1;i<=e;++i)if(t[i]==o&&i!=e)++s;else{if(!o&&s>2){for(;s>138;s-=138)a(32754);s>2&&(a(s>10?s-11<<5|28690:s-3<<5|12305),
s=0)}else if(s>3){for(a(o),--s;s>6;s-=6)a(8304);s>2&&(a(s-3<<5|8208),s=0)}for(;s--;)a(o);s=1,o=t[i]}return{c:r.subarray(0,n),n:e}},We=function(t,e){for(var r=0,
n=0;n<e.length;++n)r+=t[n]*e[n];return r},Fr=function(t,e,r){var n=r.length,o=Wt(e+2);t[o]=n&255,t[o+1]=n>>8,t[o+2]=t[o]^255,t[o+3]=t[o+1]^255;for(var s=0;s<n;++s)
t[o+s+4]=r[s];return(o+4+n)*8},Or=function(t,e,r,n,o,s,a,i,l,u,c){ae(e,c++,r),++o[256];for(var f=kt(o,15),p=f.t,m=f.l,y=kt(s,15),d=y.t,g=y.l,w=Nr(p),S=w.c,v=w.n,
A=Nr(d),E=A.c,N=A.n,k=new j(19),x=0;x<S.length;++x)++k[S[x]&31];for(var x=0;x<E.length;++x)++k[E[x]&31];for(var b=kt(k,7),I=b.t,O=b.l,W=19;W>4&&!I[Ot[W-1]];--W)
;var ie=u+5<<3,B=We(o,ue)+We(s,Fe)+a,F=We(o,p)+We(s,d)+a+14+3*W+We(k,I)+2*k[16]+3*k[17]+7*k[18];if(l>=0&&ie<=B&&ie<=F)return Fr(e,c,t.subarray(l,l+u));var L,_,D,
$;if(ae(e,c,1+(F<B)),c+=2,F<B){L=te(p,m,0),_=p,D=te(d,g,0),$=d;var ke=te(I,O,0);ae(e,c,v-257),ae(e,c+5,N-1),ae(e,c+10,W-4),c+=14;for(var x=0;x<W;++x)ae(e,c+3*x,
I[Ot[x]]);c+=3*W;for(var V=[S,E],ne=0;ne<2;++ne)for(var G=V[ne],x=0;x<G.length;++x){var H=G[x]&31;ae(e,c,ke[H]),c+=I[H],H>15&&(ae(e,c,G[x]>>5&127),c+=G[x]>>12)}}else
L=Po,_=ue,D=Lo,$=Fe;for(var x=0;x<i;++x){var R=n[x];if(R>255){var H=R>>18&31;ze(e,c,L[H+257]),c+=_[H+257],H>7&&(ae(e,c,R>>23&31),c+=tt[H]);var Q=R&31;ze(e,c,D[Q]),
c+=$[Q],Q>3&&(ze(e,c,R>>5&8191),c+=rt[Q])}else ze(e,c,L[R]),c+=_[R]}return ze(e,c,L[256]),c+_[256]},zo=new zt([65540,131080,131088,131104,262176,1048704,1048832,
2114560,2117632]),Dr=new T(0),Wo=function(t,e,r,n,o,s){var a=s.z||t.length,i=new T(n+a+5*(1+Math.ceil(a/7e3))+o),l=i.subarray(n,i.length-o),u=s.l,c=(s.r||0)&7;if(e){
c&&(l[0]=s.r>>3);for(var f=zo[e-1],p=f>>13,m=f&8191,y=(1<<r)-1,d=s.p||new j(32768),g=s.h||new j(y+1),w=Math.ceil(r/3),S=2*w,v=function(gt){return(t[gt]^t[gt+1]<<
w^t[gt+2]<<S)&y},A=new zt(25e3),E=new j(288),N=new j(32),k=0,x=0,b=s.i||0,I=0,O=s.w||0,W=0;b+2<a;++b){var ie=v(b),B=b&32767,F=g[ie];if(d[B]=F,g[ie]=B,O<=b){var L=a-
b;if((k>7e3||I>24576)&&(L>423||!u)){c=Or(t,l,0,A,E,N,x,I,W,b-W,c),I=k=x=0,W=b;for(var _=0;_<286;++_)E[_]=0;for(var _=0;_<30;++_)N[_]=0}var D=2,$=0,ke=m,V=B-F&32767;
if(L>2&&ie==v(b-V))for(var ne=Math.min(p,L)-1,G=Math.min(32767,b),H=Math.min(258,L);V<=G&&--ke&&B!=F;){if(t[b+D]==t[b+D-V]){for(var R=0;R<H&&t[b+R]==t[b+R-V];++R)
;if(R>D){if(D=R,$=V,R>ne)break;for(var Q=Math.min(V,R-2),ye=0,_=0;_<Q;++_){var ge=b-V+_&32767,Ye=d[ge],Ke=ge-Ye&32767;Ke>ye&&(ye=Ke,F=ge)}}}B=F,F=d[B],V+=B-F&32767}
if($){A[I++]=268435456|Pt[D]<<18|kr[$];var Ne=Pt[D]&31,Oe=kr[$]&31;x+=tt[Ne]+rt[Oe],++E[257+Ne],++N[Oe],O=b+D,++k}else A[I++]=t[b],++E[t[b]]}}for(b=Math.max(b,O);b<
a;++b)A[I++]=t[b],++E[t[b]];c=Or(t,l,u,A,E,N,x,I,W,b-W,c),u||(s.r=c&7|l[c/8|0]<<3,c-=7,s.h=g,s.p=d,s.i=b,s.w=O)}else{for(var b=s.w||0;b<a+u;b+=65535){var ve=b+65535;
ve>=a&&(l[c/8|0]=u,ve=a),c=Fr(l,c+1,t.subarray(b,ve))}s.i=a}return De(i,0,n+Wt(c)+o)},Fo=(function(){for(var t=new Int32Array(256),e=0;e<256;++e){for(var r=e,n=9;--n;)
r=(r&1&&-306674912)^r>>>1;t[e]=r}return t})(),Do=function(){var t=-1;return{p:function(e){for(var r=t,n=0;n<e.length;++n)r=Fo[r&255^e[n]]^r>>>8;t=r},d:function(){
return~t}}};var Bo=function(t,e,r,n,o){if(!o&&(o={l:1},e.dictionary)){var s=e.dictionary.subarray(-32768),a=new T(s.length+t.length);a.set(s),a.set(t,s.length),t=a,o.w=s.length}
return Wo(t,e.level==null?6:e.level,e.mem==null?o.l?Math.ceil(Math.max(8,Math.min(13,Math.log(t.length)))*1.5):20:12+e.mem,r,n,o)},Br=function(t,e){var r={};for(var n in t)
r[n]=t[n];for(var n in e)r[n]=e[n];return r};var ee=function(t,e){return t[e]|t[e+1]<<8},X=function(t,e){return(t[e]|t[e+1]<<8|t[e+2]<<16|t[e+3]<<24)>>>0},Nt=function(t,e){return X(t,e)+X(t,e+4)*4294967296},
U=function(t,e,r){for(;r;++e)t[e]=r,r>>>=8};var Go=function(t,e){return((t[0]&15)!=8||t[0]>>4>7||(t[0]<<8|t[1])%31)&&z(6,"invalid zlib data"),(t[1]>>5&1)==+!e&&z(6,"invalid zlib data: "+(t[1]&32?"need":"u\
nexpected")+" dictionary"),(t[1]>>3&4)+2};function Ho(t,e){return Bo(t,e||{},0,0)}function jo(t,e){return Wr(t,{i:2},e&&e.out,e&&e.dictionary)}function Gr(t,e){return Wr(t.subarray(Go(t,e&&e.dictionary),-4),{i:2},e&&e.out,e&&e.dictionary)}var Hr=function(t,e,r,n){for(var o in t){var s=t[o],a=e+o,i=n;Array.isArray(s)&&(i=Br(n,s[1]),s=s[0]),s instanceof T?r[a]=[s,i]:(r[a+="/"]=[new T(0),i],Hr(s,a,r,
n))}},Pr=typeof TextEncoder<"u"&&new TextEncoder,$t=typeof TextDecoder<"u"&&new TextDecoder,Vo=0;try{$t.decode(Dr,{stream:!0}),Vo=1}catch{}var Yo=function(t){for(var e="",
r=0;;){var n=t[r++],o=(n>127)+(n>223)+(n>239);if(r+o>t.length)return{s:e,r:De(t,r-1)};o?o==3?(n=((n&15)<<18|(t[r++]&63)<<12|(t[r++]&63)<<6|t[r++]&63)-65536,e+=String.
fromCharCode(55296|n>>10,56320|n&1023)):o&1?e+=String.fromCharCode((n&31)<<6|t[r++]&63):e+=String.fromCharCode((n&15)<<12|(t[r++]&63)<<6|t[r++]&63):e+=String.fromCharCode(
n)}};function et(t,e){if(e){for(var r=new T(t.length),n=0;n<t.length;++n)r[n]=t.charCodeAt(n);return r}if(Pr)return Pr.encode(t);for(var o=t.length,s=new T(t.length+
(t.length>>1)),a=0,i=function(c){s[a++]=c},n=0;n<o;++n){if(a+5>s.length){var l=new T(a+8+(o-n<<1));l.set(s),s=l}var u=t.charCodeAt(n);u<128||e?i(u):u<2048?(i(192|
u>>6),i(128|u&63)):u>55295&&u<57344?(u=65536+(u&1047552)|t.charCodeAt(++n)&1023,i(240|u>>18),i(128|u>>12&63),i(128|u>>6&63),i(128|u&63)):(i(224|u>>12),i(128|u>>
6&63),i(128|u&63))}return De(s,0,a)}function Ft(t,e){if(e){for(var r="",n=0;n<t.length;n+=16384)r+=String.fromCharCode.apply(null,t.subarray(n,n+16384));return r}else{
if($t)return $t.decode(t);var o=Yo(t),s=o.s,r=o.r;return r.length&&z(8),s}}var Ko=function(t,e){return e+30+ee(t,e+26)+ee(t,e+28)},Zo=function(t,e,r){var n=ee(t,e+28),o=Ft(t.subarray(e+46,e+46+n),!(ee(t,e+8)&2048)),s=e+46+n,a=X(t,e+20),
i=r&&a==4294967295?qo(t,s):[a,X(t,e+24),X(t,e+42)],l=i[0],u=i[1],c=i[2];return[ee(t,e+10),l,u,o,s+ee(t,e+30)+ee(t,e+32),c]},qo=function(t,e){for(;ee(t,e)!=1;e+=
4+ee(t,e+2));return[Nt(t,e+12),Nt(t,e+4),Nt(t,e+20)]},Ut=function(t){var e=0;if(t)for(var r in t){var n=t[r].length;n>65535&&z(9),e+=n+4}return e},Ir=function(t,e,r,n,o,s,a,i){
var l=n.length,u=r.extra,c=i&&i.length,f=Ut(u);U(t,e,a!=null?33639248:67324752),e+=4,a!=null&&(t[e++]=20,t[e++]=r.os),t[e]=20,e+=2,t[e++]=r.flag<<1|(s<0&&8),t[e++]=
o&&8,t[e++]=r.compression&255,t[e++]=r.compression>>8;var p=new Date(r.mtime==null?Date.now():r.mtime),m=p.getFullYear()-1980;if((m<0||m>119)&&z(10),U(t,e,m<<25|
p.getMonth()+1<<21|p.getDate()<<16|p.getHours()<<11|p.getMinutes()<<5|p.getSeconds()>>1),e+=4,s!=-1&&(U(t,e,r.crc),U(t,e+4,s<0?-s-2:s),U(t,e+8,r.size)),U(t,e+12,
l),U(t,e+14,f),e+=16,a!=null&&(U(t,e,c),U(t,e+6,r.attrs),U(t,e+10,a),e+=14),t.set(n,e),e+=l,f)for(var y in u){var d=u[y],g=d.length;U(t,e,+y),U(t,e+2,g),t.set(d,
e+4),e+=4+g}return c&&(t.set(i,e),e+=c),e},Jo=function(t,e,r,n,o){U(t,e,101010256),U(t,e+8,r),U(t,e+10,r),U(t,e+12,n),U(t,e+16,o)};function jr(t,e){e||(e={});var r={},n=[];Hr(t,"",r,e);var o=0,s=0;for(var a in r){var i=r[a],l=i[0],u=i[1],c=u.level==0?0:8,f=et(a),p=f.length,m=u.comment,y=m&&
et(m),d=y&&y.length,g=Ut(u.extra);p>65535&&z(11);var w=c?Ho(l,u):l,S=w.length,v=Do();v.p(l),n.push(Br(u,{size:l.length,crc:v.d(),c:w,f,m:y,u:p!=a.length||y&&m.length!=
d,o,compression:c})),o+=30+p+g+S,s+=76+2*(p+g)+(d||0)+S}for(var A=new T(s+22),E=o,N=s-o,k=0;k<n.length;++k){var f=n[k];Ir(A,f.o,f,f.f,f.u,f.c.length);var x=30+f.
f.length+Ut(f.extra);A.set(f.c,f.o+x),Ir(A,o,f,f.f,f.u,f.c.length,f.o,f.m),o+=16+x+(f.m?f.m.length:0)}return Jo(A,o,n.length,N,E),A}function Vr(t,e){for(var r={},n=t.length-22;X(t,n)!=101010256;--n)(!n||t.length-n>65558)&&z(13);var o=ee(t,n+8);if(!o)return{};var s=X(t,n+16),a=s==4294967295||
o==65535;if(a){var i=X(t,n-12);a=X(t,i)==101075792,a&&(o=X(t,i+32),s=X(t,i+48))}for(var l=e&&e.filter,u=0;u<o;++u){var c=Zo(t,s,a),f=c[0],p=c[1],m=c[2],y=c[3],d=c[4],
g=c[5],w=Ko(t,g);s=d,(!l||l({name:y,size:p,originalSize:m,compression:f}))&&(f?f==8?r[y]=jo(t.subarray(w,w+p),{out:new T(m)}):z(14,"unknown compression type "+f):
r[y]=De(t,w,w+p))}return r}var Te=["pursuer","evader"];var Dt=4,Yr=new Map;function Kr(t,e){let r=Yr.get(t);if(r)return r;let n=new Float32Array;try{let o=Qo(es(t),e);o.every(Number.isFinite)&&(n=o)}catch(o){if(!(o instanceof
DOMException||o instanceof RangeError||Xo(o)))throw o}return Yr.set(t,n),n}var Xo=t=>t instanceof Error&&"code"in t;function Qo(t,e){let r=Gr(t),n=r.length/Dt,o=new Uint8Array(
r.length);for(let a=0;a<o.length;a++)o[a]=r[a%Dt*n+Math.floor(a/Dt)];let s=new Uint32Array(o.buffer);for(let a=e;a<s.length;a++)s[a]^=s[a-e];return new Float32Array(
o.buffer)}function es(t){let e=atob(Bt(t)),r=new Uint8Array(e.length);for(let n=0;n<r.length;n++)r[n]=e.charCodeAt(n);return r}function Bt(t){return document.getElementById(
t)?.textContent??""}var ts="http://www.w3.org/2000/svg";function h(t,e={},...r){return Zr(document.createElement(t),e,r)}function Gt(t,e={},...r){return Zr(document.createElementNS(
ts,t),e,r)}function Zr(t,e,r){for(let[n,o]of Object.entries(e))o==null||o===!1||(typeof o=="function"?t.addEventListener(n.slice(2),o):t.setAttribute(n,o===!0?"":
String(o)));return t.append(...r.filter(rs).map(n=>typeof n=="number"?String(n):n)),t}function rs(t){return t!=null&&t!==!1}var qr=()=>["file:","http:","https:"].
includes(location.protocol);var he=["stay","north","east","south","west","northeast","southeast","southwest","northwest"];var ns=matchMedia("(prefers-color-scheme: dark)");function os(){let t=document.documentElement.dataset.theme;return t?t==="dark":ns.matches}function ss(){document.
documentElement.dataset.theme=os()?"light":"dark"}function Jr(){return h("button",{type:"button",title:"Light or dark (D)","aria-label":"Light or dark",onclick:ss},
"◐")}function Xr(t,e,r){return{rows:t.rows,cols:t.cols,nPursuers:t.n_pursuers,fov:t.fov,interaction:t.rules.interaction,obstacles:e,moments:r}}function Ht(t,e){return{
positions:t.read("last_positions"),alive:t.read("alive"),captured:t.read("captured"),everCaptured:t.read("ever_captured"),actions:e,involved:t.read("involved"),
fault:t.read("fault"),contested:t.conflicts().map(r=>r.cell)}}var Be=class{config;start;recording;actions=[];#e;#s;#o=[[]];constructor(e,r,n){[this.config,this.start]=[r,n],this.#e=e.world(r),this.#e.reset(n),this.#s=[Ht(this.#e)],
this.recording=Xr(r,this.#e.map(),this.#s)}get length(){return this.actions.length}get over(){return this.#e.over}get statistics(){return{capture_rate:this.#e.read(
"capture_rate")[0]}}conflicts(e){return this.#o[e]}game(e){return e.game(this.#e)}play(e){this.#e.step(e),this.#r(e)}step(e,r,n){let[o,s]=[this.#e,this.config.n_pursuers],
a=new Uint8Array(o.n_agents);for(let i=o.n_turns;i>0&&!o.over;--i){let[l,u]=o.actors;l<s&&(a=o.decide(e.pursuer,[l,Math.min(u,s)],a)),u>s&&(a=o.decide(e.evader,
[Math.max(l,s),u],a)),typeof n=="number"?a[r]=n:l<=r&&r<u&&(a=o.decide(n,[r,r+1],a)),o.playTurn(a)}this.#r(a)}#r(e){this.actions.push(e),this.#s.push(Ht(this.#e,
e)),this.#o.push(this.#e.conflicts())}};function Qr(t,e,r,n){let o=new Be(t,e,r);for(let s of n)o.play(s);return o}var ce=(t,e)=>Te[+(e>=t.n_pursuers)];function jt(t,e){let r=new Be(t,e.config,{seed:e.seed,episode:e.episode});for(let n of e.moves)r.over||r.step(e.policies,e.
seat,n);return r}function fe(t,e){let{moments:r,nPursuers:n}=t.recording,o=r.findIndex(({alive:a,captured:i})=>!a[e]||!!i[e-n]),s=o<0?t.length:o;return{lasted:s,
out:o>=0,captured:Array.from(r[s].everCaptured).filter(Boolean).length}}var nt=(t,e)=>t.over||fe(t,e).out;function en(t,e,r){let n=jt(t,{...e,moves:e.moves.slice(
0,e.from)});for(;!nt(n,e.seat);)n.step(e.policies,e.seat,r);return fe(n,e.seat)}function ot(t){let e=t.length-1;return[...new Set([0,Math.round(e/3),e])].map(r=>t[r])}
function tn(t,{seat:e,from:r,moves:n}){let o={...t,seat:e,...r?{from:r}:{},moves:n.join("")};return`${location.href.split("#")[0]}#${Object.entries(o).map(([s,a])=>`${s}\
=${a}`).join("&")}`}function rn(t,e){let[r,n,o]=[t.get("seat")??"",t.get("from")??"0",t.get("moves")??""];return/^\d{1,6}$/.test(r)&&Number(r)<e.n_pursuers+e.n_evaders&&
(e.diagonal?/^[0-8]+$/:/^[0-4]+$/).test(o)&&o.length<=e.max_steps&&/^\d{1,6}$/.test(n)&&Number(n)<=o.length?{seat:Number(r),from:Number(n),moves:[...o].map(Number)}:
null}var st=()=>crypto.getRandomValues(new BigUint64Array(1))[0];function Vt(t,e,r,n,o,s){e.play({title:r,played:n,ending:(a,i)=>[as(t,a,i,ot(o))],again:()=>Vt(t,e,r,{...n,moves:n.moves.slice(0,n.from)},o,s),link:a=>tn(s,a)})}
function as(t,e,r,n){let o=ce(r.config,r.seat)==="evader",s=o?r.config.max_steps:r.config.n_evaders,a=h("table",{class:"numbers"},h("caption",{},o?"Steps in you\
r seat: same start, same others":"Captures of your team: same start, same others")),i=u=>{let[c,f]=[h("span",{class:o?"bar evader":"bar pursuer"}),h("td",{},"…")];
return a.append(h("tr",{},h("th",{scope:"row"},u),h("td",{class:"track","aria-hidden":"true"},c),f)),({lasted:p,captured:m})=>{c.style.width=`${100*(o?p:m)/s}%`,
f.textContent=String(o?p:m)}};i("You")(fe(e,r.seat));for(let{name:u,policy:c}of n){let f=i(u);setTimeout(()=>f(en(t,r,c())))}let l=r.from?`You took over at step\
 ${r.from}. `:"";return h("div",{},a,h("p",{class:"small muted"},`${l}One match: luck has its part in it.`))}var is=20,Yt=60;function ls(t){let e=t.rules.capture==="SURROUND"?8:4,r=typeof t.obstacles!="number",n=o=>r?o:Math.min(o,is);return{...t,rows:n(t.rows),cols:n(t.
cols),max_steps:Yt,n_evaders:1,n_pursuers:Math.min(t.n_pursuers,e)}}function at(t,e,r){let[n,o,s]=[ls(e),ot(r),[]],a=()=>`${s.reduce((l,u)=>l+u,0)} of ${Yt*o.length}`,
i=()=>t.play({title:`Can you escape it? Round ${s.length+1} of ${o.length}: ${o[s.length].name}`,played:{config:n,seed:st(),episode:0,seat:n.n_pursuers,from:0,moves:[],
policies:{pursuer:o[s.length].policy(),evader:"still"}},ending:l=>{s.push(fe(l,n.n_pursuers).lasted);let u=o.map(({name:f},p)=>h("tr",{},h("th",{scope:"row"},f),
h("td",{},s[p]??""))),c=s.length<o.length;return[h("table",{class:"numbers"},h("caption",{},`Steps of ${Yt} in each round`),...u),h("p",{class:"play-score"},c?"\
Score so far: ":"Your score: ",h("strong",{},a())),c?h("button",{type:"button",class:"primary",onclick:i},"Next round"):""]},again:()=>at(t,e,r),link:()=>null});
i()}var us={"|b1":t=>new Uint8Array(t),"|i1":t=>new Int8Array(t),"<i4":t=>new Int32Array(t),"<i8":t=>Int32Array.from(new BigInt64Array(t),Number),"<f4":t=>new Float32Array(
t)},on="NUMPY\0",Ce=on.length+2,nn=64;function sn(t){return jr(Object.fromEntries(Object.entries(t).map(([e,r])=>[`${e}.npy`,cs(r)])))}function cs({dtype:t,shape:e,
data:r}){let n=typeof r=="string"?Array.from(r,c=>c.codePointAt(0)):null,o=e.map(c=>`${c}, `).join(""),s=`{'descr': '${n?`<U${n.length}`:t}', 'fortran_order': F\
alse, 'shape': (${o}), }`,a=Math.ceil((Ce+s.length+1)/nn)*nn-Ce,i=on+String.fromCharCode(a&255,a>>8)+s.padEnd(a-1)+`
`,l=n?Int32Array.from(n):r,u=new Uint8Array(i.length+l.byteLength);return u.set(et(i,!0)),u.set(new Uint8Array(l.buffer,l.byteOffset,l.byteLength),i.length),u}function an(t){
return Object.fromEntries(Object.entries(Vr(t)).map(([e,r])=>[e.replace(/\.npy$/,""),fs(r)]))}function fs(t){let e=Ce+t[Ce-2]+256*t[Ce-1],r=Ft(t.subarray(Ce,e),
!0),n=/'descr': '([^']+)', 'fortran_order': False, 'shape': \(([\d, ]*)\)/.exec(r),[o,s]=[n?.[1]??"",(n?.[2]??"").split(",").filter(u=>u.trim()).map(Number)],a=t.
slice(e).buffer,i=o.startsWith("<U")&&String.fromCodePoint(...new Int32Array(a)),l=i===!1?us[o]?.(a):i.replace(/\0+$/,"");if(l===void 0)throw new TypeError(`exp\
ected an array of numbers or a text, got ${r.slice(0,80)}`);return{dtype:o,shape:s,data:l}}var Kt="matrixworld episode 3";function ln(t,e,r){let{config:n,actions:o,length:s,recording:a}=e,[i,l]=[n.n_pursuers+n.n_evaders,n.n_evaders],u={positions:["<i4",
i,2],last_positions:["<i4",i,2],alive:["|b1",i],captured:["|b1",l],ever_captured:["|b1",l]},c={rewards:["<f4",i],involved:["|b1",i,3],fault:["|b1",i,3]},f={},p=v=>{
for(let A of Object.keys(v))(f[A]??=[]).push(Array.from(m.read(A),Number))},m=t.world(n);m.reset(e.start);let y=[];p(u);for(let v of o)m.step(v),p({...u,...c}),
y.push(...m.conflictTable());m.free();let d={"<i4":Int32Array,"<f4":Float32Array,"|b1":Uint8Array},g={};for(let[v,[A,...E]]of Object.entries({...u,...c})){let N=s+
+(v in u);g[v]={dtype:A,shape:[N,...E],data:d[A].from((f[v]??[]).flat())}}let w=v=>({dtype:"<i8",shape:[],data:Int32Array.of(v,0)}),S=v=>({dtype:"<U",shape:[],data:v});
return sn({format:S(Kt),n_pursuers:w(n.n_pursuers),config:S(JSON.stringify(n)),seat:w(r),...g,actions:{dtype:"|i1",shape:[s,i],data:Int8Array.from(o.flatMap(v=>[
...v]))},map:{dtype:"|b1",shape:[n.rows,n.cols],data:Uint8Array.from(a.obstacles,Number)},conflict_table:{dtype:"<i4",shape:[y.length/11,11],data:Int32Array.from(
y)}})}function un(t,e){let r=an(e),n=m=>Array.from(r[m]?.data??[]);if(r.format?.data!==Kt)throw new Y(`expected a file marked "${Kt}"`);let o=JSON.parse(r.config.
data),s=o.n_pursuers+o.n_evaders,a=n("positions"),i=(m,y)=>Array.from({length:y-m},(d,g)=>[a[2*(m+g)],a[2*(m+g)+1]]),l={pursuers:i(0,o.n_pursuers),evaders:i(o.n_pursuers,
s),obstacles:Uint8Array.from(n("map"))},u=Uint8Array.from(n("actions")),c=Array.from({length:u.length/s},(m,y)=>u.subarray(y*s,(y+1)*s)),f=Qr(t,o,l,c);if(Array.
from(f.recording.moments.at(-1).positions).join()!==n("last_positions").slice(-2*s).join())throw new Y("expected the moves of this start to lead to its end");return{
live:f,seat:n("seat")[0]??null}}var Ee=[[0,0],[-1,0],[0,1],[1,0],[0,-1],[-1,1],[1,1],[1,-1],[-1,-1]];function cn(t,e,r){let[n,o]=[e[0]-t[0],e[1]-t[1]];return!r&&Math.abs(n)>Math.abs(o)?o=0:r||
(n=0),Ee.findIndex(([s,a])=>s===Math.sign(n)&&a===Math.sign(o))}var de=(t,e)=>e<t.nPursuers,C=(t,e)=>[t.positions[2*e],t.positions[2*e+1]],ps=(t,e)=>t[0]===e[0]&&
t[1]===e[1],Zt=({rows:t,cols:e},[r,n])=>r>=0&&n>=0&&r<t&&n<e,qt=(t,e,r=3)=>t!==void 0&&[0,1,2].slice(0,r).some(n=>t[3*e+n]),Jt=(t,e)=>qt(t.fault,e),fn=(t,e)=>!Jt(
t,e)&&qt(t.involved,e,2);function it(t,e,r){let n=!ps(C(t,r),C(e,r)),o=e.involved===void 0||qt(e.involved,r);return!!(e.alive[r]&&e.actions?.[r]&&!n&&o)}function lt(t,e,r){
let[n,o]=C(t,r),[s,a]=Ee[e.actions?.[r]??0];return[n+s,o+a]}function ut(t,e,r){return Array.from({length:r.everCaptured.length},(o,s)=>s).filter(o=>r.everCaptured[o]&&
!e.everCaptured[o]).map(o=>t.nPursuers+o)}function ct(t,e){return Array.from({length:e.alive.length},(n,o)=>o).filter(n=>t.alive[n]&&!e.alive[n])}var pn=[-.31,0,.31],mn=[{size:1,at:[[0,0]]},{size:.62,at:[[-.2,.2],[.2,-.2]]},{size:.54,at:[[-.23,.22],[.23,.22],[0,-.22]]},{size:.54,at:[[-.23,.23],[.23,.23],[
-.23,-.23],[.23,-.23]]},{size:.36,at:pn.flatMap(t=>pn.map(e=>[e,t]))}],ms=.3,hs=.35,ds=.55;function Ge(t,e){let r=new Map;for(let n=0;n<e.alive.length;n++){if(!e.
alive[n])continue;let[o,s]=C(e,n),a=o*t.cols+s,i=r.get(a);i?i.push(n):r.set(a,[n])}return r}function hn(t,e){let r=Array.from(e.alive,(n,o)=>{let[s,a]=C(e,o);return{
x:a+.5,y:s+.5,size:1,alpha:0}});for(let n of Ge(t,e).values()){let o=mn[Math.min(n.length,mn.length)-1];n.forEach((s,a)=>{let[i,l]=o.at[Math.min(a,o.at.length-1)],
u=r[s];u.x+=i,u.y+=l,u.size=o.size,u.alpha=1})}return r}var dn=t=>t*t*(3-2*t),_e=(t,e,r)=>t+(e-t)*r,yn=t=>Math.min(1,Math.max(0,t));function gn(t,e,r,n){let o={
SIMULTANEOUS:1,SWARM_TURNS:2,AGENT_TURNS:r}[t.interaction];if(o===1)return dn(n);let s=o===r?e:+!de(t,e),a=Math.max(1/o,hs);return dn(yn((n-s/(o-1)*(1-a))/a))}function ft(t,e){
let r=t.moments.length-1,n=Math.min(Math.floor(e),r),o=t.moments[n],s=hn(t,o);if(n===r||e===n)return s;let a=t.moments[n+1],i=hn(t,a);return s.map((l,u)=>{let c=gn(
t,u,s.length,e-n);return ys(o,a,u,l,i[u],c)})}function Xt(t,e,r){let n=t.moments.length-1,o=Math.min(Math.floor(r),n),[s,a]=[t.moments[o],t.moments[Math.min(o+1,
n)]],i=gn(t,e,s.alive.length,r-o),[[l,u],[c,f]]=[C(s,e),C(a,e)];return[_e(u,f,i)+.5,_e(l,c,i)+.5]}function ys(t,e,r,n,o,s){let a=n.alpha>o.alpha,i={x:_e(n.x,o.x,
s),y:_e(n.y,o.y,s),size:a?n.size:_e(n.size,o.size,s),alpha:a?yn((1-s)/(1-ds)):_e(n.alpha,o.alpha,s)};if(it(t,e,r)){let[l,u]=C(t,r),[c,f]=lt(t,e,r),p=ms*Math.sin(
Math.PI*s);i.x+=(f-u)*p,i.y+=(c-l)*p}return i}var vn=2*Math.PI;function He(t,e,r,n){t.beginPath(),t.arc(e,r,n/2,0,vn)}function bn(t,e,r,n){let o=n/2,s=[[0,-.97],[.97,.83],[-.97,.83]].map(([a,i])=>[e+a*o,r+i*
o]);t.beginPath(),t.moveTo((s[2][0]+s[0][0])/2,(s[2][1]+s[0][1])/2),s.forEach(([a,i],l)=>{let[u,c]=s[(l+1)%3];t.arcTo(a,i,u,c,n*.09)}),t.closePath()}function wn(t,e,r,n){
let o=n*.32;t.beginPath(),t.moveTo(e-o,r-o),t.lineTo(e+o,r+o),t.moveTo(e+o,r-o),t.lineTo(e-o,r+o)}function xn(t,e,r,n){t.beginPath();for(let o=0;o<16;o++){let s=n/
2*(o%2?.6:.95),a=vn*o/16;t.lineTo(e+s*Math.sin(a),r-s*Math.cos(a))}t.closePath()}function An(t,e,r,n,o,s){let a=Math.atan2(o-r,n-e);t.beginPath(),t.moveTo(e,r),
t.lineTo(n,o);for(let i of[-1,1])t.moveTo(n,o),t.lineTo(n-s*Math.cos(a+i*.6),o-s*Math.sin(a+i*.6))}var Sn=4,gs=1.6,vs=.95,bs=5,ws=.16,xs=9,As=.09,Ss=.2,Mn=.75,K=(t,e)=>t.left+e*t.cell,Z=(t,e)=>t.top+e*t.cell;function Re(t,e,r){return de(e,r)?t.colors.pursuer:
t.colors.evader}function Tn({ctx:t,grid:e,colors:r}){let{left:n,top:o,cell:s,rows:a,cols:i}=e,[l,u]=[i*s,a*s];if(t.fillStyle=r.paper,t.fillRect(n,o,l,u),s<bs)return;
t.fillStyle=r.line;let c=Math.max(1,Math.round(s/60));for(let f=1;f<i;f++)t.fillRect(n+f*s,o,c,u);for(let f=1;f<a;f++)t.fillRect(n,o+f*s,l,c)}function Cn({ctx:t,
grid:e,colors:r},n){let{left:o,top:s,cell:a,rows:i,cols:l}=e;t.fillStyle=r.obstacle;for(let u=0;u<i*l;u++){if(!n.obstacles[u])continue;let[c,f]=[Math.floor(u/l),
u%l];t.fillRect(o+f*a,s+c*a,a,a)}En({ctx:t,grid:e,colors:r})}function En({ctx:t,grid:{left:e,top:r,cell:n,rows:o,cols:s},colors:a}){let i=Math.min(5,Math.max(2,
Math.round(n/18)));t.strokeStyle=a.frame,t.lineWidth=i,t.strokeRect(e-i/2,r-i/2,s*n+i,o*n+i)}function _n({ctx:t,grid:e,colors:r},n){let{left:o,top:s,cell:a,rows:i,
cols:l}=e,u=a<24*n?5:1;t.font=`500 ${Math.round(Math.min(15*n,Math.max(9*n,a*.32)))}px system-ui, sans-serif`,t.fillStyle=r.muted,t.textBaseline="alphabetic",t.
textAlign="center";let c=5*n+a/40;for(let f=0;f<l;f+=u)t.fillText(String(f),o+(f+.5)*a,s-c);t.textAlign="right",t.textBaseline="middle";for(let f=0;f<i;f+=u)t.fillText(
String(f),o-c,s+(f+.5)*a)}function Rn({grid:t},e,r,n){let o=Math.floor(e.fov/2)+.5,[s,a]=[Math.max(0,r-o),Math.min(t.cols,r+o)],[i,l]=[Math.max(0,n-o),Math.min(
t.rows,n+o)];return[K(t,s),Z(t,i),(a-s)*t.cell,(l-i)*t.cell]}function kn(t,e,r,n){let{ctx:o,grid:s,colors:a}=t;o.save(),o.beginPath(),o.rect(0,0,o.canvas.width,
o.canvas.height),o.rect(...Rn(t,e,r,n)),o.clip("evenodd"),o.clearRect(0,0,o.canvas.width,o.canvas.height),o.fillStyle=a.line,o.fillRect(s.left,s.top,s.cols*s.cell,
s.rows*s.cell),o.restore(),En(t)}function Nn({ctx:t,grid:e,colors:r},{x:n,y:o,alpha:s},a){let i=Math.max(e.cell,16*a)*1.06,[l,u]=[K(e,n),Z(e,o)];t.globalAlpha=Math.
max(s,.6),t.beginPath(),t.roundRect(l-i/2,u-i/2,i,i,i*.2),t.strokeStyle=r.focus,t.lineWidth=Math.max(2,2.5*a),t.stroke();let c=Math.max(11*a,Math.min(18*a,e.cell*
.5));t.font=`700 ${Math.round(c)}px system-ui, sans-serif`,t.textAlign="center",t.textBaseline="middle";let f=u-i/2<c*1.2,p=u+(f?1:-1)*(i/2+c*.7);t.strokeStyle=
r.paper,t.lineJoin="round",t.lineWidth=c*.35,t.strokeText("You",l,p),t.fillStyle=r.ink,t.fillText("You",l,p),t.globalAlpha=1}function On(t,e,r,n,o){let{ctx:s,grid:a}=t,
i=Rn(t,e,n,o),l=Re(t,e,r);s.globalAlpha=.11,s.fillStyle=l,s.fillRect(...i),s.globalAlpha=.8,s.strokeStyle=l,s.lineWidth=Math.max(1,a.cell/24),s.strokeRect(...i),
s.globalAlpha=1}function Pn(t,e,r,n,o){let{ctx:s,grid:a}=t,i=Math.min(Math.ceil(r),e.moments.length-1),l=e.moments[i];s.lineCap="round",s.lineWidth=Math.min(xs,
Math.max(1,a.cell*ws));for(let u=Math.max(1,Math.floor(r-n)+1);u<=i;u++){let[c,f]=[e.moments[u-1],e.moments[u]],p=Math.max(0,Math.min(1,(r-u)/n));s.globalAlpha=
Mn+(Ss-Mn)*p;for(let m=0;m<f.alive.length;m++){let y=u===i&&r<i;if(!c.alive[m]||!(l.alive[m]||y))continue;let d=(de(e,m)?-1:1)*As,[g,w]=C(c,m),[S,v]=C(f,m);if(g===
S&&w===v)continue;let A=y?o[m].x:v+.5,E=y?o[m].y:S+.5;s.strokeStyle=Re(t,e,m),s.beginPath(),s.moveTo(K(a,w+.5+d),Z(a,g+.5+d)),s.lineTo(K(a,A+d),Z(a,E+d)),s.stroke()}}
s.globalAlpha=1}function In(t,e,r){let n=Math.min(Math.ceil(r),e.moments.length-1);for(let o=Math.max(1,n-Sn+1);o<=n;o++){let[s,a]=[e.moments[o-1],e.moments[o]],
i=o>r?Math.max(0,1-2*(o-r)):1-(r-o)/Sn,l=ut(e,s,a);for(let u of ct(s,a))l.includes(u)||Ts(t,C(a,u),i);for(let u of l)Ms(t,C(a,u),i)}t.ctx.globalAlpha=1}function Ms({
ctx:t,grid:e,colors:r},[n,o],s){t.globalAlpha=s,xn(t,K(e,o+.5),Z(e,n+.5),Math.max(8,e.cell*gs)),t.fillStyle=r.capture,t.fill(),t.strokeStyle=r.ink,t.lineWidth=Math.
max(1,e.cell/36),t.lineJoin="round",t.stroke()}function Ts({ctx:t,grid:e,colors:r},[n,o],s){t.globalAlpha=s,wn(t,K(e,o+.5),Z(e,n+.5),Math.max(7,e.cell*vs)),t.strokeStyle=
r.collision,t.lineWidth=Math.max(2,e.cell*.17),t.lineCap="round",t.stroke()}function Ln({ctx:t,grid:e,colors:r},n,o){let s=Math.max(1,e.cell*.07);t.strokeStyle=
t.fillStyle=r.collision,t.lineWidth=Math.max(1,e.cell*.05),t.setLineDash([e.cell*.14,e.cell*.1]);for(let[a,i]of n){if(a<0||i<0||a>=e.rows||i>=e.cols)continue;let l=[
K(e,i)+s,Z(e,a)+s,e.cell-2*s,e.cell-2*s];t.globalAlpha=.2*o,t.fillRect(...l),t.globalAlpha=o,t.strokeRect(...l)}t.setLineDash([]),t.globalAlpha=1}function $n({ctx:t,
grid:e,colors:r},n,o,s,a){t.globalAlpha=a,He(t,K(e,n),Z(e,o),Math.max(8,e.cell*s*1.02)),t.strokeStyle=r.collision,t.lineWidth=Math.max(1.5,e.cell*.085*Math.sqrt(
s)),t.stroke(),t.globalAlpha=1}var Cs=.8,Es=.92,_s=15,Rs=7,Qt=9;function Un(t,e,r,n,o,s){n.forEach((a,i)=>{a.alpha>0&&ks(t,e,r,i,a,o,s)}),t.ctx.globalAlpha=1;for(let a of Ge(e,r).values())a.length>
Qt&&Ns(t,n[a[Qt-1]],a.length-Qt+1)}function ks(t,e,r,n,o,s,a){let{ctx:i,grid:l,colors:u}=t,c=de(e,n),[f,p]=[l.left+o.x*l.cell,l.top+o.y*l.cell],m=Math.max(4,l.cell*
o.size*(c?Es:Cs)),y=Re(t,e,n),d=!c&&!!r.captured[n-e.nPursuers];if(i.globalAlpha=o.alpha,(c?bn:He)(i,f,p,m),m>Rs*a&&(i.strokeStyle=u.paper,i.lineWidth=Math.max(
2,m*.1),i.stroke()),i.fillStyle=d?u.paper:y,i.fill(),d&&(He(i,f,p,m*.82),i.strokeStyle=y,i.lineWidth=m*.18,i.stroke()),!s||m<_s*a)return;let g=String(c?n:n-e.nPursuers);
i.font=`700 ${Math.round(m*(c?.4:.5)*(g.length>1?.8:1))}px system-ui, sans-serif`,i.textAlign="center",i.textBaseline="middle",i.fillStyle=d?y:u.paper,i.fillText(
g,f,p+m*(c?.17:.03))}function Ns({ctx:t,grid:e,colors:r},n,o){let[s,a]=[e.left+n.x*e.cell,e.top+n.y*e.cell];t.font=`700 ${Math.round(e.cell*.3)}px system-ui, sa\
ns-serif`,t.textAlign="center",t.textBaseline="middle",t.strokeStyle=r.paper,t.lineWidth=e.cell*.1,t.strokeText(`+${o}`,s,a),t.fillStyle=r.ink,t.fillText(`+${o}`,
s,a)}var Os=.46,Ps=.86,Is=.66,zn=.48,Ls=.78,$s=.58;function Wn(t,e,r,n){let[o,s]=[e.moments[r-1],e.moments[r]];if(!o)return;let{ctx:a,grid:i,colors:l}=t;a.strokeStyle=
l.collision,a.lineWidth=Math.max(1.5,i.cell*.07),a.lineCap="butt",a.globalAlpha=n;for(let u=0;u<s.alive.length;u++)it(o,s,u)&&Us(t,e,C(o,u),lt(o,s,u));a.globalAlpha=
1}function Us({ctx:t,grid:e},r,n,o){let[s,a]=[o[1]-n[1],o[0]-n[0]],i=f=>K(e,n[1]+.5+s*f),l=f=>Z(e,n[0]+.5+a*f),u=Zt(r,o)?Ls:$s;t.setLineDash([e.cell*.09,e.cell*
.06]),t.beginPath(),t.moveTo(i(zn),l(zn)),t.lineTo(i(u),l(u)),t.stroke(),t.setLineDash([]);let c=.17*e.cell/Math.hypot(s,a);t.beginPath(),t.moveTo(i(u)-a*c,l(u)+
s*c),t.lineTo(i(u)+a*c,l(u)-s*c),t.stroke()}function Fn(t,e,r,n,o,s){let a=Ee[s];if(!s||!a)return;let{ctx:i,grid:l,colors:u}=t,c=Zt(e,[n[0]+a[0],n[1]+a[1]])?Ps:
Is,f=Os*o.size,p=[K(l,o.x+a[1]*f),Z(l,o.y+a[0]*f),K(l,o.x+a[1]*c),Z(l,o.y+a[0]*c)],m=Math.max(1.5,l.cell*.085);i.lineCap=i.lineJoin="round";for(let[y,d]of[[u.paper,
m*2.1],[Re(t,e,r),m]])i.strokeStyle=y,i.lineWidth=d,An(i,...p,l.cell*.2),i.stroke()}var Bn={numbers:!0,axes:!1,trail:6,viewers:[],plan:null,selected:null,cursor:null,you:null,fog:!1};function Gn(t,e,r,n,o){let{ctx:s,grid:a,colors:i}=t,l=Math.min(
Math.ceil(r),e.moments.length-1),u=e.moments[l],c=r===l,f=ft(e,r),p=c?1:Math.max(0,1-2*(l-r));s.clearRect(0,0,s.canvas.width,s.canvas.height),Tn(t);for(let d of n.
viewers)f[d]?.alpha&&On(t,e,d,...Xt(e,d,r));Cn(t,e),n.axes&&_n(t,o),Pn(t,e,r,n.trail,f),Ln(t,u.contested??[],p),In(t,e,r),Wn(t,e,l,p),f.forEach(({x:d,y:g,size:w},S)=>{
let v=fn(u,S)?.4:0,A=Jt(u,S)?1:v;A&&$n(t,d,g,w,A*p)});let m=c?u:e.moments[Math.max(0,l-1)];if(Un(t,e,m,f,n.numbers,o),c&&n.plan)for(let[d,g]of f.entries())g.alpha&&
Fn(t,e,d,C(u,d),g,n.plan[d]??0);n.you!==null&&(n.fog&&kn(t,e,...Xt(e,n.you,r)),Nn(t,f[n.you],o)),s.lineWidth=Math.max(2,2.5*o),s.strokeStyle=i.focus;let y=n.selected===
null?void 0:f[n.selected];y?.alpha&&Dn(t,y.x,y.y,y.size*.96),n.cursor&&(s.setLineDash([a.cell*.12,a.cell*.08]),Dn(t,n.cursor[1]+.5,n.cursor[0]+.5,.8),s.setLineDash(
[]))}function Dn({ctx:t,grid:e},r,n,o){let s=o*e.cell;t.beginPath(),t.roundRect(e.left+r*e.cell-s/2,e.top+n*e.cell-s/2,s,s,s*.1),t.stroke()}var Hn=(t,e)=>(e+.24)/(t+.24);function jn(t,e,r,n,o,s){let a=r?28*s:0,i=(u,c)=>(u-a)/(c+2*.12),l=Math.max(1,Math.floor(Math.min(i(n,e),i(o,t))));return{rows:t,cols:e,
cell:l,left:Math.round((n-e*l+a)/2),top:Math.round((o-t*l+a)/2)}}function Vn(t,e,r){let n=Math.floor((r-t.top)/t.cell),o=Math.floor((e-t.left)/t.cell);return n>=
0&&n<t.rows&&o>=0&&o<t.cols?[n,o]:null}var zs={paper:"--board-paper",line:"--board-line",frame:"--board-frame",ink:"--board-ink",muted:"--board-muted",obstacle:"--board-obstacle",pursuer:"--pursuer",
evader:"--evader",capture:"--capture",collision:"--collision",focus:"--focus"};function Yn(t){let e=getComputedStyle(t),r=Object.entries(zs).map(([n,o])=>[n,e.getPropertyValue(
o).trim()]);return Object.fromEntries(r)}var er=()=>matchMedia("(prefers-reduced-motion: reduce)").matches,pt=class{canvas;#e=null;#s=0;#o;#r={rows:1,cols:1,left:0,top:0,cell:1};#n=0;#a;#i;constructor(e,r={}){
this.canvas=e,e.classList.add("board"),e.setAttribute("role","img"),this.#o={...Bn,...r},this.#a=new ResizeObserver(()=>this.#f()),this.#a.observe(e),this.#i=new MutationObserver(
()=>this.redraw()),this.#i.observe(document.documentElement,{attributes:!0}),matchMedia("(prefers-color-scheme: dark)").addEventListener("change",this.redraw)}close(){
this.#a.disconnect(),this.#i.disconnect(),matchMedia("(prefers-color-scheme: dark)").removeEventListener("change",this.redraw),cancelAnimationFrame(this.#n)}get look(){
return this.#o}set look(e){this.#o={...this.#o,...e},this.#u(),this.redraw()}show(e,r){this.#e=e,this.#s=Math.min(Math.max(0,r),e.moments.length-1),this.#u(),this.
redraw()}redraw=()=>{this.#n||(this.#n=requestAnimationFrame(()=>this.drawNow()))};drawNow(){cancelAnimationFrame(this.#n),this.#n=0;let e=this.canvas.getContext(
"2d");if(!e||!this.#e)return;let{rows:r,cols:n}=this.#e,o=devicePixelRatio||1;this.#r=jn(r,n,this.#o.axes,this.canvas.width,this.canvas.height,o);let s={ctx:e,grid:this.#r,
colors:Yn(this.canvas)};Gn(s,this.#e,this.#s,this.#o,o)}cellAt(e,r){let n=this.canvas.getBoundingClientRect(),o=this.canvas.width/n.width;return Vn(this.#r,(e-n.
left)*o,(r-n.top)*o)}agentAt(e,r){let n=this.cellAt(e,r);if(!n||!this.#e)return null;let o=this.#e.moments[Math.round(this.#s)],s=Ge(this.#e,o).get(n[0]*this.#e.
cols+n[1])??[],a=ft(this.#e,Math.round(this.#s)),i=l=>{let[u,c]=this.pointOf(a[l].x,a[l].y);return Math.hypot(u-e,c-r)};return s.length?s.reduce((l,u)=>i(u)<i(l)?
u:l):null}pointOf(e,r){let n=this.canvas.getBoundingClientRect(),o=n.width/this.canvas.width,{left:s,top:a,cell:i}=this.#r;return[n.left+(s+e*i)*o,n.top+(a+r*i)*
o]}#u(){if(!this.#e)return;let{rows:e,cols:r}=this.#e;this.canvas.style.setProperty("--board-aspect",String(Hn(e,r)))}#f(){let e=devicePixelRatio||1,{width:r,height:n}=this.
canvas.getBoundingClientRect();this.canvas.width=Math.max(1,Math.round(r*e)),this.canvas.height=Math.max(1,Math.round(n*e)),this.drawNow()}};var je=[.5,1,2,4,8,16,32,64],Kn=0,ht=12,Ws=2,mt=class extends EventTarget{#e;#s;#o;#r=0;#n=0;#a=!1;#i=null;#u=0;#f=[];#h=[];glide=.28;constructor(e,r={}){super(),
this.#e=e,this.#s=r.speed??4,this.#o=r.still??!1}get step(){return this.#r}get time(){return this.#o?this.#r:this.#n}get arrived(){return this.#n===this.#r}get playing(){
return this.#a}get length(){return this.#e}set length(e){this.#e=e,this.#r>e&&this.jump(e),this.#t("state")}get marks(){return this.#f}set marks(e){this.#f=e,this.#t(
"state")}get ticks(){return this.#h}set ticks(e){this.#h=e,this.#t("state")}get pace(){return this.#s||Math.max(Ws,this.#e/ht)}get speed(){return this.#s}set speed(e){
this.#s=e,this.#t("state")}changeSpeed(e){let r=je.findIndex(n=>n>=this.pace);this.speed=je[Math.min(je.length-1,Math.max(0,r+e))]}play(){this.#a||!this.#e||(this.#r===
this.#e&&this.jump(0),this.#a=!0,this.#t("state"),this.#p())}pause(){this.#a&&(this.#a=!1,this.#t("state"))}toggle(){this.#a?this.pause():this.play()}move(e){this.
pause();let r=Math.min(this.#e,Math.max(0,this.#r+e));Math.abs(r-this.#n)>1?this.jump(r):this.#m(r),this.#p()}jump(e){this.#n=Math.min(this.#e,Math.max(0,Math.round(
e))),this.#m(this.#n),this.#t("frame")}#m(e){e!==this.#r&&(this.#r=e,this.#t("step"),this.#o&&this.#t("frame"))}#p(){this.#i===null&&(this.#u=performance.now(),
this.#i=requestAnimationFrame(()=>this.#g()))}#g(){this.#i=null;let e=performance.now();this.#l(Math.min(.25,(e-this.#u)/1e3)),this.#u=e,(!this.#o||this.arrived)&&
this.#t("frame"),(this.#a||this.#n!==this.#r)&&(this.#i=requestAnimationFrame(()=>this.#g()))}#l(e){let r=e;for(;r>0;){if(this.#n===this.#r){if(!this.#a)return;
if(this.#r===this.#e)return this.pause();this.#m(this.#r+1)}let n=this.#a?this.pace:1/this.glide,o=this.#r-this.#n,s=Math.min(Math.abs(o),r*n);r-=s/n,this.#n=s===
Math.abs(o)?this.#r:this.#n+Math.sign(o)*s}this.#a&&this.#n===this.#e&&this.pause()}#t(e){this.dispatchEvent(new Event(e))}};function dt(t,e){if(e.ctrlKey||e.metaKey||
e.altKey)return!1;let r=e.shiftKey?10:1,o={" ":()=>t.toggle(),ArrowRight:()=>t.move(r),ArrowLeft:()=>t.move(-r),Home:()=>t.move(-t.length),End:()=>t.move(t.length),
"+":()=>t.changeSpeed(1),"-":()=>t.changeSpeed(-1)}[e.key];return o?.(),o!==void 0}var Fs={first:"M6 5v14M19 5 9 12l10 7z",back:"M17 5 7 12l10 7z",play:"M7 4.5 19 12 7 19.5z",pause:"M8 5v14M16 5v14",forward:"M7 5l10 7-10 7z",last:"M18 5v14M5 5\
l10 7-10 7z"};function Zn(t){return Gt("svg",{viewBox:"0 0 24 24","aria-hidden":"true",class:"icon"},Gt("path",{d:Fs[t]}))}function Ve(t,e,r,n){return h("button",
{type:"button",class:"player-button","aria-label":e,title:`${e} (${r})`,onclick:n},Zn(t))}function qn(t){let e=Ve("play","Play","Space",()=>t.toggle()),r=Ds(t),
n=h("div",{class:"captures","aria-hidden":"true",title:"Captures"}),o=h("div",{class:"losses","aria-hidden":"true"}),s=Bs(t),a=h("output",{class:"player-count"}),
i=h("div",{class:"player",role:"group","aria-label":"Player"},Ve("first","First step","Home",()=>t.move(-t.length)),Ve("back","Step back","←",()=>t.move(-1)),
e,Ve("forward","Step forward","→",()=>t.move(1)),Ve("last","Last step","End",()=>t.move(t.length)),h("div",{class:"scrub"},n,o,r),a,s),l=(f,p={})=>{let m=h("i",
p);return m.style.left=`${100*f/Math.max(1,t.length)}%`,m},u=()=>{n.replaceChildren(...t.marks.map(f=>l(f))),o.replaceChildren(...t.ticks.map(({step:f,kind:p,size:m,
text:y})=>{let d=l(f,{class:p,title:`Step ${f}: ${y}`});return d.style.height=`${100*m}%`,d}))},c=()=>{e.replaceChildren(Zn(t.playing?"pause":"play")),e.ariaLabel=
t.playing?"Pause":"Play",e.title=`${e.ariaLabel} (Space)`,r.max=String(t.length),r.value=String(t.step),r.ariaValueText=`step ${t.step} of ${t.length}`,a.textContent=
`${t.step} / ${t.length}`,a.style.minWidth=`${2*String(t.length).length+3}ch`,s.value=String(t.speed)};return t.addEventListener("step",c),t.addEventListener("s\
tate",c),t.addEventListener("state",u),i.addEventListener("keydown",f=>{!(f.target instanceof HTMLSelectElement||f.key===" "&&f.target!==r)&&dt(t,f)&&f.preventDefault()}),
c(),i}function Ds(t){let e=h("input",{type:"range",class:"player-scrub",min:0,step:1,"aria-label":"Step"});return e.addEventListener("input",()=>{t.pause(),t.jump(
Number(e.value))}),e}function Bs(t){let e=`Steps a second, or the whole in ${ht} s (+ and -)`,r=h("select",{class:"player-speed","aria-label":"Speed",title:e},h(
"option",{value:Kn},`in ${ht} s`),...je.map(n=>h("option",{value:n},`${n} / s`)));return r.addEventListener("change",()=>{t.speed=Number(r.value)}),r}function Jn(t,e,r){if(r===0)return[{kind:"start",text:Gs(t),agents:[]}];let[n,o]=[e.moments[r-1],e.moments[r]],s=c=>q(c,t.config.n_pursuers),a=ut(e,n,o),i=t.conflicts(
r),l=new Set(i.flatMap(c=>c.doomed)),u=a.map(c=>({kind:"capture",text:`${s(c)} is captured`,agents:[c]}));for(let c of ct(n,o))!a.includes(c)&&!l.has(c)&&u.push(
{kind:"end",text:`${s(c)} disappears`,agents:[c]});return u.push(...i.map(({kind:c,text:f,agents:p})=>({kind:c,text:f,agents:p}))),r===t.length&&u.unshift({kind:"\
end",text:Hs(t),agents:[]}),u}function Gs({config:t}){return`${t.n_pursuers} pursuers and ${t.n_evaders} evaders on ${t.rows} x ${t.cols} cells, at most ${t.max_steps}\
 steps`}function Hs(t){let e=Math.round(t.statistics.capture_rate*t.config.n_evaders);return`The episode ends after ${t.length} steps with ${e} of ${t.config.n_evaders}\
 evaders captured`}var rr=.005,js=["pursuer","evader"],tr=new Map;function Qn(t,e){let r=JSON.stringify({...e,rewards:null,fov:null});return tr.has(r)||tr.set(r,Qe(e)?Promise.resolve(
null):Vs(t,e)),tr.get(r)}var Xn=()=>new Promise(t=>setTimeout(t));async function Vs(t,e){await Xn();let r=t.solution(e);for(;r.goBack();)await Xn();return r}function eo(t,e,r){
return r.flatMap((n,o)=>{let s=[0,0];for(let a=e.n_turns;a>0&&!e.over;a--)t.game(e)?.lost(n).forEach((i,l)=>s[l]+=i),e.playTurn(n);return js.map((a,i)=>({step:o+
1,team:a,lost:s[i]})).filter(a=>a.lost>=rr)})}var to=t=>t.map(e=>({step:e.step,kind:e.team,size:e.lost,text:nr(e)})),nr=({team:t,lost:e})=>`The ${t}s lose ${e.toFixed(
2)} against a perfect opponent`;function ro(t,e){return(t.marginal(e)??[]).map((n,o)=>({share:n,action:o})).filter(({share:n})=>n>=rr).sort((n,o)=>o.share-n.share).
map(({share:n,action:o})=>n>1-rr?he[o]:`${he[o]} ${n.toFixed(2)}`).join(", ")}var no=["·","↑","→","↓","←","↗","↘","↙","↖"];var Ys={" ":0,s:0,ArrowUp:1,w:1,ArrowRight:2,d:2,ArrowDown:3,x:3,ArrowLeft:4,a:4,e:5,c:6,y:7,z:7,q:8},or=[8,1,5,4,0,2,7,3,6],Ks=[7,8,9,4,5,6,1,2,3],Zs=24,qs=Math.
tan(Math.PI/8);function so(t,e){if(t.ctrlKey||t.metaKey||t.altKey)return;let r=Ks.findIndex(o=>t.code===`Numpad${o}`),n=or[r]??Ys[t.key.length===1?t.key.toLowerCase():
t.key];return n!==void 0&&n>4&&!e?void 0:n}function ao(t){let e=or.map(r=>h("button",{type:"button","aria-label":he[r],onclick:()=>t(r)},no[r]));return{element:h(
"div",{class:"play-pad",role:"group","aria-label":"Your move"},...e),show:r=>e.forEach((n,o)=>n.classList.toggle("absent",or[o]>4&&!r))}}function oo(t,e,r){let n=qs*
Math.max(Math.abs(t),Math.abs(e)),o=s=>Math.abs(s)<n?0:s;return cn([0,0],r?[o(t),o(e)]:[t,e],r)}function io(t,e,r){let n=null,{canvas:o}=t;o.addEventListener("p\
ointerdown",({button:s,clientX:a,clientY:i})=>{n=s===0?[a,i]:null}),o.addEventListener("pointercancel",()=>{n=null}),o.addEventListener("pointerup",({clientX:s,
clientY:a})=>{let[i,l]=[n,e()];if(n=null,!i||!l)return;let[u,c]=[s-i[0],a-i[1]],f=t.cellAt(s,a);Math.hypot(u,c)>=Zs?r(oo(c,u,l.diagonal)):f&&r(oo(f[0]-l.cell[0],
f[1]-l.cell[1],l.diagonal))})}function lo(t,e){let r=n=>{let o=e[n]-t[n],s=Ee.findIndex(a=>a[n]===Math.sign(o)&&a[1-n]===0);return o?`${Math.abs(o)} ${he[s]}`:""};
return[r(0),r(1)].filter(Boolean).join(", ")||"on your cell"}var Js=[0,1,2,4,8],yt=class{element;player=new mt(0,{speed:4,still:er()});#e;#s;#o=h("canvas",{tabindex:0,"aria-describedby":"play-keys"});#r=h("h2");#n=h("p",{
class:"play-told",role:"status"});#a=ao(e=>this.act(e));#i=h("select",{},...Js.map(e=>h("option",{value:e},e?`${e} / s`:"step by step")));#u=h("input",{type:"ch\
eckbox"});#f=h("input",{type:"checkbox"});#h=h("span");#m=h("p",{class:"small muted play-keys",id:"play-keys"});#p=h("section",{class:"play-ending",tabindex:-1,
"aria-labelledby":"play-headline"});#g=qn(this.player);#l=null;#t=null;#A=[];#c=null;#d=null;#y=[];#v=0;#b=0;constructor(e){this.#e=e,this.#s=new pt(this.#o,{numbers:!1}),
this.#o.setAttribute("role","application"),this.#i.addEventListener("change",()=>this.#w()),this.#u.addEventListener("change",()=>this.#M()),this.#f.addEventListener(
"change",()=>this.#x()),io(this.#s,()=>{let r=this.#c!==null&&this.#t&&C(this.#t.recording.moments.at(-1),this.#c);return r?{cell:r,diagonal:this.#t.config.diagonal}:
null},r=>this.act(r)),this.player.addEventListener("frame",()=>this.#t&&this.#s.show(this.#t.recording,this.player.time)),this.player.addEventListener("step",()=>this.#x()),
this.element=h("div",{class:"play"},h("header",{class:"play-head"},this.#r,this.#n),h("div",{class:"play-stage"},this.#o),h("div",{class:"play-side"},this.#p,this.#a.
element,h("label",{class:"play-choice",title:"Steps a second"},"Pace ",this.#i),h("label",{class:"play-choice"},this.#u,h("span",{},"Fog",h("span",{class:"at-le\
ngth"},": see only what it sees"))),h("label",{class:"play-choice"},this.#f,this.#h),this.#m),this.#g)}get played(){return this.#l&&{...this.#l.played,moves:this.#A}}get live(){
return this.#t}play(e){this.#S(jt(this.#e,e.played),e.played.seat,e.title),[this.#l,this.#A,this.#v]=[e,[...e.played.moves],0],this.element.dataset.state="playi\
ng",this.#o.focus({preventScroll:!0}),nt(this.#t,e.played.seat)&&this.#_()}watch(e,r,n){this.#l=null,this.#S(e,r,n),this.#R()}stop(){this.#w(),this.player.pause(),
this.#l=null}act(e){let[r,n]=[this.#l,this.#t];if(!r||!n||this.element.dataset.state!=="playing")return;this.#v=e;let o=Number(this.#i.value);this.#b||(this.#E(),
o&&this.element.dataset.state==="playing"&&(this.#b=setInterval(()=>this.#E(),1e3/o)))}key(e){let{target:r,key:n}=e;if(r instanceof HTMLSelectElement||r instanceof
HTMLInputElement&&(r.type==="text"||n===" ")||r instanceof HTMLButtonElement&&(n===" "||n==="Enter")||!this.#t)return!1;if(this.element.dataset.state!=="playing")
return dt(this.player,e);let s=so(e,this.#t.config.diagonal);return s!==void 0&&this.act(s),s!==void 0}#S(e,r,n){this.#w(),this.player.pause(),[this.#t,this.#c]=
[e,r],this.#r.textContent=n,this.#o.ariaLabel=`Board, ${e.config.rows} by ${e.config.cols} cells`,this.#a.show(e.config.diagonal),this.#m.replaceChildren(h("spa\
n",{class:"at-length"},`Arrow keys or W A X D move, Space or S stays${e.config.diagonal?"; Q E Z C and the numeric keypad move diagonally":""}. `),"On the board\
: swipe, or tap where to go."),this.#k(e),this.#p.replaceChildren(),this.player.length=e.length,this.player.jump(e.length),this.#x()}#M(){this.#s.look={you:this.#c,
fog:this.#u.checked,viewers:this.#c===null?[]:[this.#c],plan:this.#N()}}#k(e){this.#d=null,this.#y=this.player.ticks=[];let r=Qe(e.config);this.#f.disabled=!!r,
this.#h.textContent=r?`No best move: ${r}`:"Best move",Qn(this.#e,e.config).then(n=>{this.#t===e&&(this.#d=n,this.#T(),this.#x())})}#T(){let[e,r]=[this.#t,this.#d];
if(!r||this.element.dataset.state==="playing")return;let n=this.#e.world(e.config);n.reset(e.start),this.#y=eo(r,n,e.actions),n.free(),this.player.ticks=to(this.#y)}get#C(){
return this.#f.checked&&this.#l&&this.element.dataset.state==="playing"&&this.#d&&this.#t.game(this.#d)||null}#N(){let[e,r]=[this.#c,this.#c!==null&&this.#C?.marginal(
this.#c)];return e!==null&&r?Object.assign(Array(e).fill(0),{[e]:r.indexOf(Math.max(...r))}):null}#w(){clearInterval(this.#b),this.#b=0,this.#n.ariaLive=Number(
this.#i.value)?"off":"polite"}#E(){let[{policies:e,seat:r},n]=[this.#l.played,this.#t];n.step(e,r,this.#v),this.#A.push(this.#v),this.player.length=n.length,this.
player.glide=Math.min(.22,.9/(Number(this.#i.value)||4)),this.player.move(n.length-this.player.step),nt(n,r)&&this.#_()}#_(){this.#w();let[e,r,n]=[this.#l,this.#t,
this.played],o=qr()?e.link(n):null;this.#p.replaceChildren(h("h3",{id:"play-headline"},ea(r,n.seat)),...e.ending(r,n),h("div",{class:"play-buttons"},h("button",
{type:"button",class:"primary",onclick:()=>e.again()},"Again"),h("button",{type:"button",onclick:()=>this.#R()},"Watch it"),h("button",{type:"button",onclick:()=>this.#O(
r,n.seat)},"Save"),o&&h("button",{type:"button",onclick:({currentTarget:a})=>na(a,o)},"Link"))),this.element.dataset.state="ended",this.#T();let s=this.#y.filter(
({team:a})=>a===ce(r.config,n.seat));s.length&&this.#p.children[0].after(h("p",{class:"small muted"},ta(s))),this.#p.focus({preventScroll:!0}),this.#p.scrollIntoView(
{block:"nearest"})}#R(){this.element.dataset.state="watched",this.player.length=this.#t.length,this.player.jump(0),er()||this.player.play()}#O(e,r){let n=new Blob(
[ln(this.#e,e,r)],{type:"application/octet-stream"});h("a",{href:URL.createObjectURL(n),download:`${q(r,e.config.n_pursuers)}-${e.length}-steps.npz`}).click()}#x(){
let[e,r,{step:n}]=[this.#t,this.#c,this.player];if(!e||n>e.length)return;let o=Jn(e,e.recording,n).filter(({agents:i})=>r===null||i.includes(r)),s=[`Step ${n} o\
f ${e.config.max_steps}`,...o.map(({text:i})=>i)];this.#l&&n===0?s.push(Xs(e.config,r)):r!==null&&s.push(Qs(e,n,r)),s.push(...this.#y.filter(i=>i.step===n).map(
nr));let a=n===e.length&&r!==null?this.#C:null;a&&s.push(`Perfect play: ${ro(a,r)||"decided in its turn"}; value ${a.value.toFixed(2)}`),this.#M(),this.#n.textContent=
s.filter(Boolean).map(i=>`${i}.`).join(" ")}};function Xs(t,e){let r=t.rules.capture==="SURROUND";return ce(t,e)==="evader"?`Stay free: ${r?"pursuers on all sid\
es of you capture":"a pursuer on your cell captures"} you`:`Capture evaders: ${r?"surround them together":"reach their cell"}`}function Qs({config:t,recording:e},r,n){
let o=e.moments[r],a=ce(t,n)==="pursuer"?"evader":"pursuer";if(!o.alive[n])return"";let i=C(o,n),l=f=>{let[p,m]=C(o,f);return Math.max(Math.abs(p-i[0]),Math.abs(
m-i[1]))},u=Array.from({length:o.alive.length},(f,p)=>p).filter(f=>ce(t,f)===a&&o.alive[f]&&!o.captured[f-t.n_pursuers]&&2*l(f)<t.fov);if(!u.length)return`No ${a}\
 in view`;let c=u.reduce((f,p)=>l(p)<l(f)?p:f);return`Nearest ${a}: ${lo(i,C(o,c))}`}function ea(t,e){let[{lasted:r,out:n,captured:o},{config:s}]=[fe(t,e),t];return ce(
s,e)==="pursuer"?`Your team captured ${o} of ${ra(s)} in ${r} steps.`:n?`You lasted ${r} of ${s.max_steps} steps.`:`You escaped: ${r} steps.`}function ta(t){let e=t.
reduce((n,o)=>o.lost>n.lost?o:n);return`Your team's moves lost ${t.reduce((n,{lost:o})=>n+o,0).toFixed(2)} of the capture rate against a perfect opponent, most \
in step ${e.step}: ${e.lost.toFixed(2)}.`}var ra=({n_evaders:t})=>`${t} evader${t===1?"":"s"}`;function na(t,e){let r=h("input",{type:"text",readonly:!0,value:e,
"aria-label":"Link to this match"});t.replaceWith(r),r.select(),navigator.clipboard?.writeText(e).catch(()=>{})}var re=JSON.parse(Bt("data")),pe={pursuer:uo("pursuer"),evader:uo("evader")};function uo(t){let{names:e,scripts:r,network:n}=re.teams[t],o=s=>{let a=r[s];if(a||
!n)return a;let[i,l]=[n.genome_size,r.slice(0,s).filter(u=>u===null).length];return{...n,genome:Kr(t,i).subarray(l*i,(l+1)*i)}};return e.map((s,a)=>({name:s,policy:()=>o(
a)}))}function po(t,e,r,n){let[o,s]=[re.world,Te[+(n.seat>=re.world.n_pursuers)]],a=Te.map(u=>pe[u][r[u]].name),i={pursuer:pe.pursuer[r.pursuer].policy(),evader:pe.
evader[r.evader].policy()},l=`You are ${q(n.seat,o.n_pursuers)}: pursuers ${a[0]}, evaders ${a[1]}`;Vt(t,e,l,{config:o,seed:r.seed,episode:0,policies:i,...n},pe[s],
{pursuers:r.pursuer,evaders:r.evader,seed:r.seed})}function co(t,e){let r=new URLSearchParams(location.hash.slice(1)),n=rn(r,re.world),[o,s]=[Number(r.get("purs\
uers")??NaN),Number(r.get("evaders")??NaN)],a=/^\d{1,20}$/.test(r.get("seed")??"")?BigInt.asUintN(64,BigInt(r.get("seed"))):null;return!n||a===null||!pe.pursuer[o]||
!pe.evader[s]?!1:(po(t,e,{pursuer:o,evader:s,seed:a},n),!0)}var fo=(t,e)=>h("select",{},...t.map((r,n)=>h("option",{value:n,selected:n===e},r)));function oa(t,e){
let[r,n,o]=[fo(["an evader","a pursuer"],0),...Te.map(l=>fo(re.teams[l].names,re.teams[l].names.length-1))],s=h("p",{class:"problem",role:"alert"}),a=()=>po(t,e,
{pursuer:Number(n.value),evader:Number(o.value),seed:st()},{seat:r.value==="0"?re.world.n_pursuers:0,from:0,moves:[]}),i=h("input",{type:"file",accept:".npz",hidden:!0});
return i.addEventListener("change",()=>{let[l]=i.files??[];s.textContent="",l?.arrayBuffer().then(u=>un(t,new Uint8Array(u))).then(({live:u,seat:c})=>e.watch(u,
c,l.name)).catch(u=>s.textContent=`${l.name} holds no match: ${u.message}`),i.value=""}),h("details",{class:"card setup",open:matchMedia("(min-width: 761px)").matches},
h("summary",{},"Play something else"),h("div",{},h("label",{},"You are ",r),h("label",{},"Pursuers ",n),h("label",{},"Evaders ",o),h("button",{type:"button",class:"\
primary",onclick:a},"Play"),h("button",{type:"button",onclick:()=>at(e,re.world,pe.pursuer)},"Can you escape it?"),h("button",{type:"button",onclick:()=>i.click()},
"Open a file"),i,s))}async function sa(){let t=await Rr(),e=new yt(t);document.getElementById("page").replaceWith(h("header",{class:"top"},h("h1",{},re.title),Jr()),
h("main",{},oa(t,e),h("section",{class:"card","aria-label":"Match"},e.element))),document.addEventListener("keydown",r=>e.key(r)&&r.preventDefault()),window.addEventListener(
"hashchange",()=>co(t,e)),co(t,e)||at(e,re.world,pe.pursuer),Object.assign(window,{matrixworldPlay:e})}sa().catch(t=>{throw(document.getElementById("page")??document.
body).append(h("p",{class:"card problem",role:"alert"},`The page could not start: ${t instanceof Y?t.message:String(t)}`)),t}).finally(()=>{document.body.dataset.
ready="true"});})();
