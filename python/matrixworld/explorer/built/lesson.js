/* built from web/ by "npm run build"; sources da027045bad70d587dc1e27d3622aafe70454b913d4aaf34a3a651bd06adcc92 */
"use strict";(()=>{var ms={SIMULTANEOUS:0,SWARM_TURNS:1,AGENT_TURNS:2},yt={DISAPPEAR:0,REACH:1,BOUNCE:2},ps={OCCUPATION:0,SURROUND:1},hs={FAULT:0,INVOLVED:1};var en=["obstacle","teammate","adversary"],tn=["vertex","edge","chain"],fs=["turn","kind","form","first","second","row","col","at_fault","held","doomed"],rn=["p\
ursuer_{number}","evader_{number}"],gs={obstacle:"{first} ran into the obstacle or border at {cell}",vertex:"{first} and {second} both headed for {cell}",edge:"\
{first} and {second} meant to swap, {first} to {cell}",chain:"{first} headed for {cell}, where {second} had to stay"},vt={"both held":"both bounce","both doomed":"\
both disappear",held:"{agent} bounces",doomed:"{agent} disappears",none:"nobody is stopped"},ys="{event}: {outcome}",nn={random:"any action, all equally likely",
still:"always stays",chaser:"moves to where the nearest adversary in view is nearest",fleer:"moves to where the nearest adversary in view is farthest","clumsy-c\
haser":"a chaser that takes any action in half of the steps",hunter:"a chaser of the nearest adversary in view to which no teammate in view is nearer",surrounder:"\
a chaser of the nearest free cell beside an adversary without a teammate","clumsy-fleer":"a fleer that takes any action in half of the steps",dodger:"moves to w\
here all adversaries in view together are farthest","team-surrounder":"shares the free cells beside adversaries with its teammates, and searches","careful-rando\
m":"as random, but takes only moves that right of way allows","careful-chaser":"as chaser, but takes only moves that right of way allows","careful-fleer":"as fl\
eer, but takes only moves that right of way allows","careful-clumsy-chaser":"as clumsy-chaser, but takes only moves that right of way allows","careful-hunter":"\
as hunter, but takes only moves that right of way allows","careful-surrounder":"as surrounder, but takes only moves that right of way allows","careful-clumsy-fl\
eer":"as clumsy-fleer, but takes only moves that right of way allows","careful-dodger":"as dodger, but takes only moves that right of way allows","careful-team-\
surrounder":"as team-surrounder, but takes only moves that right of way allows"},vs={free:".GS",blocked:"#@OTW"};var je=1+fs.length;function bt(t,e){return t.replace(/\{(\w+)\}/g,(r,n)=>String(e[n]))}function Y(t,e){return t<e?bt(rn[0],{number:t}):bt(rn[1],{number:t-e})}function Yi(t,e){
let[r,n,s,o,a,i,l,...c]=Array.from(t),d=a<0?[o]:[o,a],[m,p,h]=c.map(x=>d.filter((v,w)=>x>>w&1)),f=d.map(x=>Y(x,e)),g=bt(gs[a<0?"obstacle":tn[s]],{first:f[0],second:f[f.
length-1],cell:`(${i}, ${l})`}),y=bt(ys,{event:g,outcome:Ki(d.length,p,h,e)});return{kind:en[n],form:tn[s],agents:d,cell:[i,l],at_fault:m,held:p,doomed:h,turn:r,
text:y}}function Ki(t,e,r,n){if(t===2&&e.length===2)return vt["both held"];if(t===2&&r.length===2)return vt["both doomed"];let s=o=>a=>bt(vt[o],{agent:Y(a,n)});
return[...e.map(s("held")),...r.map(s("doomed"))].join(", ")||vt.none}function Yt(t,e){let r=[];for(let n=0;n<t.length;n+=je)r.push(Yi(t.subarray(n+1,n+je),e));
return r}var Me=class extends Error{name="EngineError"};function I(t,e,r){let n=typeof r=="string"?`'${r}'`:typeof r=="object"?JSON.stringify(r):String(r);return new Me(
`${t}: expected ${e}, got ${n}`)}var Ge=class{bytes;constructor(e){this.bytes=e}},xs=0,on=[Uint8Array,Uint8Array,Int32Array,BigInt64Array,BigUint64Array,Float32Array,Float64Array],bs=4,ws=4,Ji=new TextEncoder,
Zi=new TextDecoder;function Xi(t){for(let e=on.length-1;e>xs;--e)if(t instanceof on[e])return e;throw new TypeError("array: expected a typed array of the engine\
's numbers, got another")}function sn(t){return new Uint8Array(t.buffer,t.byteOffset,t.byteLength)}function Qi(t){return Ji.encode(`${t}\0`)}var an=class{engine;addresses=[];constructor(e){
this.engine=e}copy(e){let r=this.engine._malloc(Math.max(e.length,1));if(r===0)throw new Me("memory: expected room for the arguments, got none");return this.addresses.
push(r),this.engine.HEAPU8.set(e,r),r}text(e){return this.copy(Qi(e))}arrays(e){let r=Object.entries(e),n=r.flatMap(([o,a])=>{let i=a instanceof Ge,l=i?a.bytes:
a;return[this.text(o),i?xs:Xi(l),l.length,this.copy(sn(l))]}),s=this.copy(sn(Int32Array.from(n)));return this.copy(sn(Int32Array.of(r.length,s)))}free(){for(let e of this.
addresses)this.engine._free(e)}};function Ss(t,e){let r=t.HEAPU8;return Zi.decode(r.subarray(e,r.indexOf(0,e)))}function Ve(t){let e=new Int32Array(t.HEAPU8.buffer),
r=t._last_outputs()/bs,n=e[r+1]/bs,s={};for(let o=n;o<n+e[r]*ws;o+=ws){let a=on[e[o+1]],i=e[o+2]*a.BYTES_PER_ELEMENT,l=e[o+3];s[Ss(t,e[o])]=new a(t.HEAPU8.slice(
l,l+i).buffer)}return s}function Ee(t,e){let r=new an(t);try{let n=e(r);if(n===0)throw new Me(Ss(t,t._last_error()));return n}finally{r.free()}}var el=2**31-1,As=["none","gru"],tl=2n**64n-1n,rl=34028234663852886e22;function be(t,e){if(typeof e!="number"||!Number.isInteger(e)||Math.abs(e)>el)throw I(t,"a\
n integer",e);return Int32Array.of(e)}function Kt(t,e){if(typeof e!="boolean")throw I(t,"true or false",e);return new Ge(Uint8Array.of(Number(e)))}function $e(t,e,r){
let n=typeof e=="string"&&Object.hasOwn(r,e)?r[e]:void 0;if(n===void 0)throw I(t,`one of ${Object.keys(r).join(", ")}`,e);return Int32Array.of(n)}function ln(t,e){
if(typeof e!="number"||!(Math.abs(e)<=rl))throw I(t,"a finite number",e);return e}function wt(t,e){let n=typeof e=="bigint"||typeof e=="number"&&Number.isSafeInteger(
e)?BigInt(e):-1n;if(n<0n||n>tl)throw I(t,"an integer from 0 to 2^64 - 1",e);return BigUint64Array.of(n)}function nl(t){return{"rules.interaction":$e("interactio\
n",t.interaction,ms),"rules.obstacle":$e("obstacle",t.obstacle,yt),"rules.teammate":$e("teammate",t.teammate,yt),"rules.evader":$e("evader",t.evader,yt),"rules.\
pursuer":$e("pursuer",t.pursuer,yt),"rules.capture":$e("capture",t.capture,ps),"rules.captured_disappear":Kt("captured_disappear",t.captured_disappear)}}function Ms(t,e){
let r=typeof e=="number"?[e,e,e]:e;if(!Array.isArray(r)||r.length!==3)throw I(t,"1 or 3 numbers",e);return Float32Array.from(r,n=>ln(t,n))}function sl(t){let e=(r,n)=>Float32Array.
of(ln(r,t[r]),ln(n,t[n]));return{"rewards.capture":e("pursuer_capture","evader_capture"),"rewards.neighbor":e("pursuer_neighbor","evader_neighbor"),"rewards.ste\
p":e("pursuer_step","evader_step"),"rewards.pursuer_collide":Ms("pursuer_collide",t.pursuer_collide),"rewards.evader_collide":Ms("evader_collide",t.evader_collide),
"rewards.blame":$e("blame",t.blame,hs),"rewards.capture_repeats":Kt("capture_repeats",t.capture_repeats)}}function Ts(t){if(t===void 0||typeof t=="number")return new Uint8Array(
0);if(t instanceof Uint8Array)return t;let{free:e,blocked:r}=vs;for(let[n,s]of t.entries()){if(s.length!==t[0]?.length)throw I(`map, row ${n}`,`${t[0]?.length} \
cells as in row 0`,s.length);let o=[...s].find(a=>!e.includes(a)&&!r.includes(a));if(o)throw I(`map, row ${n}`,`'${e}' (free) or '${r}' (obstacle)`,o)}return Uint8Array.
from([...t.join("")],n=>Number(r.includes(n)))}function ks(t,e){if(!Array.isArray(t))return;let r=[t.length,t[0]?.length??0];if(!(r[0]===e.rows&&r[1]===e.cols))
throw I("obstacle map",`shape (${e.rows}, ${e.cols}), the rows and cols`,r)}function qe(t){ks(t.obstacles,t);let e=typeof t.obstacles=="number"?t.obstacles:0;return{
...nl(t.rules),...sl(t.rewards),rows:be("rows",t.rows),cols:be("cols",t.cols),n_pursuers:be("n_pursuers",t.n_pursuers),n_evaders:be("n_evaders",t.n_evaders),fov:be(
"fov",t.fov),diagonal:Kt("diagonal",t.diagonal),max_steps:be("max_steps",t.max_steps),density:Float64Array.of(e),map:Ts(t.obstacles)}}function Es(t,e){return Int32Array.
from((e??[]).flat(),r=>be(t,r)[0])}function Cs(t,e){return ks(t.obstacles,e),{seed:wt("seed",t.seed??0n),episode:wt("episode",t.episode??0),pursuers:Es("pursuer\
s",t.pursuers),evaders:Es("evaders",t.evaders),map:Ts(t.obstacles)}}function Jt(t){return{actions:Int32Array.from(t,e=>be("actions",e)[0])}}function Ye(t){if(typeof t==
"string"){if(!Object.hasOwn(nn,t))throw I("policy",`one of ${Object.keys(nn).join(", ")}`,t);return{script:new TextEncoder().encode(t)}}if(t.activation!=="relu"&&
t.activation!=="tanh")throw I("activation","'relu' or 'tanh'",t.activation);if(!As.includes(t.memory))throw I("memory",`one of ${As.join(", ")}`,t.memory);return{
hidden:Int32Array.from(t.hidden,e=>be("hidden",e)[0]),activation:new TextEncoder().encode(t.activation),sampled:Kt("sampled",t.sampled),memory:new TextEncoder().
encode(t.memory),genome:t.genome}}var ol=["first_turn","terminated","truncated"];function Os(t){let e={...t};for(let r of ol)e[r]=new Ge(t[r]);return e}var Rs="statistics.",Zt=class{config;seed;episode;n_agents;statistics;first_conflict;constructor(e,r,n,s){this.config=e,this.seed=r,this.episode=n,this.n_agents=
e.n_pursuers+e.n_evaders,this.statistics=il($s(s)),Object.assign(this,s),this.first_conflict=al(this.conflict_table,this.length)}get length(){return this.actions.
length/this.n_agents}conflicts(e){this.check(e);let[r,n]=[this.first_conflict[e],this.first_conflict[e+1]],s=this.conflict_table.subarray(r*je,n*je);return Yt(s,
this.config.n_pursuers)}seek(e,r,n){this.check(r),(!(e.seed===this.seed&&e.episode===BigInt(this.episode))||e.turn!==0||e.steps>r)&&e.reset({seed:this.seed,episode:this.
episode});for(let o=e.steps;o<r;++o){let a=this.actions.subarray(o*this.n_agents,(o+1)*this.n_agents);n?e.replay(a,{pursuer:n.pursuers,evader:n.evaders}):e.step(
a)}}check(e){if(!(Number.isInteger(e)&&e>=0&&e<=this.length))throw I("step",`0 to ${this.length}`,e)}};function al(t,e){let r=new Int32Array(e+2);for(let n=0;n<
t.length;n+=je)++r[t[n]+1];for(let n=1;n<r.length;++n)r[n]+=r[n-1];return r}function il(t){let e=["capture_rate","ever_capture_rate","captured_fraction","length"];
return Object.fromEntries(Object.entries(t).map(([r,n])=>[r,e.includes(r)?Number(n[0]):n]))}var $s=t=>Object.fromEntries(Object.entries(t).flatMap(([e,r])=>e.startsWith(
Rs)?[[e.slice(Rs.length),r]]:[]));function _s(t,e,r,n){let s=[qe(r.config),Ye(r.pursuers),Ye(r.evaders),n];return Ee(t,o=>{let[a,i,l,c]=s.map(d=>o.arrays(d));return t[e](
a,i,l,c)}),Ve(t)}function Ps(t,e,r,n){let s={seed:wt("seed",r),episode:wt("episode",n)};return new Zt(e.config,r,n,_s(t,"_play_match",e,s))}function Ls(t,e,r,n){
if(!Number.isInteger(n)||n<1)throw I("n_episodes","at least 1",n);let s=_s(t,"_play_rollout",e,{...r,n_episodes:Int32Array.of(n)});return $s(s)}var ll=7e6,cl=new FinalizationRegistry(([t,e])=>t._states_free(e));function ul({rules:t,rows:e,cols:r,obstacles:n,diagonal:s,n_pursuers:o,n_evaders:a}){let i=typeof n==
"number"||t.obstacle==="REACH"?0:n.join("").split("#").length-1,l=e*r-i,c=[t.obstacle,t.teammate,t.pursuer].includes("DISAPPEAR"),d=t.capture==="SURROUND"||t.evader===
"REACH",m=t.interaction==="AGENT_TURNS",p=(g,y)=>Array.from({length:y},(x,v)=>m?g:(g+v)/(v+1)).reduce((x,v)=>x*v,1),h=p(l+Number(c),o)*p(l*(1+Number(d))+2,a);return{
SIMULTANEOUS:[o+a],SWARM_TURNS:[o,a],AGENT_TURNS:Array(o+a).fill(1)}[t.interaction].reduce((g,y)=>g+h*(s?9:5)**y,0)}function Xt(t){return typeof t.obstacles=="n\
umber"&&t.obstacles>0?"obstacles are drawn anew in each episode":ul(t)>ll?"the world is too large to be solved on the page":""}var cn=class{value;teams;matrix;n_actions;constructor(e,r){
let{matrix:n,rows:s,cols:o,value:a,agents:i}=r,[l,c]=e.actors,d=Array.from(i).filter(p=>l<=p&&p<c),m=p=>p<e.config.n_pursuers;[this.value,this.matrix,this.n_actions]=
[a[0],n,e.n_actions],this.teams=[{agents:d.filter(m),play:s},{agents:d.filter(p=>!m(p)),play:o}]}marginal(e){let r=this.teams.find(({agents:o})=>o.includes(e));
if(!r)return null;let n=this.n_actions**(r.agents.length-1-r.agents.indexOf(e)),s=Array(this.n_actions).fill(0);return r.play.forEach((o,a)=>s[Math.floor(a/n)%this.
n_actions]+=o),s}lost(e){let[r,n]=this.teams.map(({agents:l})=>l.reduce((c,d)=>c*this.n_actions+e[d],0)),[s,o]=this.teams.map(({play:l})=>l),a=o.reduce((l,c,d)=>l+
c*this.matrix[r*o.length+d],0),i=s.reduce((l,c,d)=>l+c*this.matrix[d*o.length+n],0);return[Math.max(0,this.value-a),Math.max(0,i-this.value)]}},un=60,xt=class{config;payoff;engine;states;n_turns;values;constructor(e,r,n){
[this.engine,this.config,this.payoff]=[e,r,n],this.states=Ee(e,i=>e._states_new(i.arrays(qe(r)))),cl.register(this,[e,this.states]);let s={SIMULTANEOUS:1,SWARM_TURNS:2,
AGENT_TURNS:r.n_pursuers+r.n_evaders};this.n_turns=s[r.rules.interaction];let{payoffs:o}=this.call(()=>e._states_payoffs(this.states)),a=o;this.values=[[n==="ca\
pture-rate"?a:a.fill(0)]]}goBack(){let e=this.values.at(-1)[0],r=[];for(let s=this.n_turns-1;s>=0;s--){let o=r[s+1]??e;r[s]=this.backup(s,{next:o})}this.payoff===
"capture-time"&&(r[0]=r[0].map((s,o)=>o===this.config.n_evaders?0:s-1)),this.values.push(r);let n=this.payoff==="capture-rate"?this.config.max_steps:Math.min(this.
config.max_steps,un);return this.values.length<=n&&r[0].some((s,o)=>s!==e[o])}backup(e,r){return this.call(n=>this.engine._states_backup(this.states,e,n.arrays(
r))).values}game(e){let[r,{turn:n}]=[this.config.max_steps-e.steps,e],s=n+1===this.n_turns,o=r>0?this.values[Math.min(r-Number(s),this.values.length-1)]?.[s?0:n+
1]:void 0;if(!o)return null;let a=this.call(i=>this.engine._states_game(this.states,e.address,i.arrays({next:o})));return a.agents.length?new cn(e,a):null}call(e){
return Ee(this.engine,e),Ve(this.engine)}};var Ns=new FinalizationRegistry(([t,e])=>t._world_free(e)),St=class{config;n_agents;n_actions;engine;at;freed=!1;constructor(e,r){this.engine=e,this.config=r,this.
n_agents=r.n_pursuers+r.n_evaders,this.n_actions=r.diagonal?9:5,this.at=Ee(e,n=>e._world_new(n.arrays(qe(r)))),Ns.register(this,[e,this.at],this)}free(){this.freed||
(this.freed=!0,Ns.unregister(this),this.engine._world_free(this.at))}get address(){if(this.freed)throw I("world","one that is in use","one that was freed");return this.
at}reset(e={}){let r=Cs(e,this.config);this.call(n=>this.engine._world_reset(this.address,n.arrays(r)))}step(e){let r=Jt(e);this.call(n=>this.engine._world_step(
this.address,n.arrays(r)))}playTurn(e){let r=Jt(e);this.call(n=>this.engine._world_play_turn(this.address,n.arrays(r)))}decide(e,r,n){let{n_pursuers:s}=this.config,
o={pursuer:[0,s],evader:[s,this.n_agents]},[a,i]=typeof r=="string"?o[r]:r;if(n.length!==this.n_agents)throw I("actions",String(this.n_agents),n.length);let l=[
Ye(e),Jt(n)],{actions:c}=this.call(d=>this.engine._world_decide(this.address,d.arrays(l[0]),a,i,d.arrays(l[1])));return Uint8Array.from(c)}replay(e,r){let n=o=>typeof o!=
"string"&&o.memory!=="none";if(!n(r.pursuer)&&!n(r.evader))return this.step(e);let{n_pursuers:s}=this.config;for(let o=this.n_turns;o>0;--o){let[a,i]=this.actors;
a<s&&this.decide(r.pursuer,[a,Math.min(i,s)],e),i>s&&this.decide(r.evader,[Math.max(a,s),i],e),this.playTurn(e)}}get n_turns(){return this.turnNumbers()[1]}get turn(){
return this.turnNumbers()[0]}get actors(){let[,,e,r]=this.turnNumbers();return[e,r]}turnNumbers(){return this.call(()=>this.engine._world_turn(this.address)).turn}get steps(){
return this.read("steps")[0]}get seed(){return this.read("seed")[0]}get episode(){return this.read("episode")[0]}get over(){return this.read("terminated")[0]===
1||this.read("truncated")[0]===1}read(e){return this.call(r=>this.engine._world_read(this.address,r.text(e)))[e]}view(e){let r=3*this.config.fov**2;return this.
read("views").slice(e*r,(e+1)*r)}map(){return this.read("state").slice(2*this.config.rows*this.config.cols)}conflicts(){return Yt(this.conflictTable(),this.config.
n_pursuers)}conflictTable(){return this.call(()=>this.engine._world_conflicts(this.address)).conflict_table}answer(e,r){let n=Ye(e),{logits:s,memory:o}=this.call(
l=>this.engine._world_logits(this.address,l.arrays(n),r)),a=s,i=this.decide(e,[r,r+1],new Uint8Array(this.n_agents))[r];return{logits:a,probabilities:dl(a),action:i,
memory:o}}snapshot(){return this.call(()=>this.engine._world_snapshot(this.address))}restore(e){let r=Os(e);this.call(n=>this.engine._world_restore(this.address,
n.arrays(r)))}call(e){return Ee(this.engine,e),Ve(this.engine)}};function dl(t){let e=Math.max(...t),r=Array.from(t,s=>Math.exp(s-e)),n=r.reduce((s,o)=>s+o,0);return Float32Array.
from(r,s=>s/n)}var dn=class{compiled;constructor(e){this.compiled=e}world(e){return new St(this.compiled,e)}solution(e,r="capture-rate"){return new xt(this.compiled,e,r)}match(e,r,n,s,o=0){
return Ps(this.compiled,{config:e,pursuers:r,evaders:n},s,o)}rollouts(e,r,n,s,o){return Ls(this.compiled,{config:e,pursuers:r,evaders:n},s,o)}},Is;function Qt(t=globalThis.
matrixworldEngine){return Is??=ml(t),Is}async function ml(t){if(!t)throw new Error("matrixworldEngine: expected the script engine.js before this one, got none");
let e=Uint8Array.from(atob(t.binary),r=>r.charCodeAt(0));return new dn(await t({wasmBinary:e}))}var P=Uint8Array,Q=Uint16Array,wn=Int32Array,tr=new P([0,0,0,0,0,0,0,0,1,1,1,1,2,2,2,2,3,3,3,3,4,4,4,4,5,5,5,5,0,0,0,0]),rr=new P([0,0,0,0,1,1,2,2,3,3,4,4,5,5,6,
6,7,7,8,8,9,9,10,10,11,11,12,12,13,13,0,0]),fn=new P([16,17,18,0,8,7,9,6,10,5,11,4,12,3,13,2,14,1,15]),Bs=function(t,e){for(var r=new Q(31),n=0;n<31;++n)r[n]=e+=
1<<t[n-1];for(var s=new wn(r[30]),n=1;n<30;++n)for(var o=r[n];o<r[n+1];++o)s[o]=o-r[n]<<5|n;return{b:r,r:s}},Hs=Bs(tr,2),js=Hs.b,gn=Hs.r;js[28]=258,gn[258]=28;var Gs=Bs(
rr,0),pl=Gs.b,Fs=Gs.r,yn=new Q(32768);for(T=0;T<32768;++T)we=(T&43690)>>1|(T&21845)<<1,we=(we&52428)>>2|(we&13107)<<2,we=(we&61680)>>4|(we&3855)<<4,yn[T]=((we&65280)>>
8|(we&255)<<8)>>1;var we,T,le=(function(t,e,r){for(var n=t.length,s=0,o=new Q(e);s<n;++s)t[s]&&++o[t[s]-1];var a=new Q(e);for(s=1;s<e;++s)a[s]=a[s-1]+o[s-1]<<1;
var i;if(r){i=new Q(1<<e);var l=15-e;for(s=0;s<n;++s)if(t[s])for(var c=s<<4|t[s],d=e-t[s],m=a[t[s]-1]++<<d,p=m|(1<<d)-1;m<=p;++m)i[yn[m]>>l]=c}else for(i=new Q(
n),s=0;s<n;++s)t[s]&&(i[s]=yn[a[t[s]-1]++]>>15-t[s]);return i}),Te=new P(288);for(T=0;T<144;++T)Te[T]=8;var T;for(T=144;T<256;++T)Te[T]=9;var T;for(T=256;T<280;++T)
Te[T]=7;var T;for(T=280;T<288;++T)Te[T]=8;var T,Et=new P(32);for(T=0;T<32;++T)Et[T]=5;var T,hl=le(Te,9,0),fl=le(Te,9,1),gl=le(Et,5,0),yl=le(Et,5,1),mn=function(t){
for(var e=t[0],r=1;r<t.length;++r)t[r]>e&&(e=t[r]);return e},ne=function(t,e,r){var n=e/8|0;return(t[n]|t[n+1]<<8)>>(e&7)&r},pn=function(t,e){var r=e/8|0;return(t[r]|
t[r+1]<<8|t[r+2]<<16)>>(e&7)},xn=function(t){return(t+7)/8|0},Sn=function(t,e,r){return(e==null||e<0)&&(e=0),(r==null||r>t.length)&&(r=t.length),new P(t.subarray(
e,r))};var vl=["unexpected EOF","invalid block type","invalid length/literal","invalid distance","stream finished","no stream handler",,"no callback","invalid UTF-8 da\
ta","extra field too long","date not in range 1980-2099","filename too long","stream finishing","invalid zip data"],K=function(t,e,r){var n=new Error(e||vl[t]);
if(n.code=t,Error.captureStackTrace&&Error.captureStackTrace(n,K),!r)throw n;return n},bl=function(t,e,r,n){var s=t.length,o=n?n.length:0;if(!s||e.f&&!e.l)return r||
new P(0);var a=!r,i=a||e.i!=2,l=e.i;a&&(r=new P(s*3));var c=function(ft){var gt=r.length;if(ft>gt){var He=new P(Math.max(gt*2,ft));He.set(r),r=He}},d=e.f||0,m=e.
p||0,p=e.b||0,h=e.l,f=e.d,g=e.m,y=e.n,x=s*8;do{if(!h){d=ne(t,m,1);var v=ne(t,m+1,3);if(m+=3,v)if(v==1)h=fl,f=yl,g=9,y=5;else if(v==2){var k=ne(t,m,31)+257,C=ne(
t,m+10,15)+4,E=k+ne(t,m+5,31)+1;m+=14;for(var M=new P(E),F=new P(19),N=0;N<C;++N)F[fn[N]]=ne(t,m+N*3,7);m+=C*3;for(var z=mn(F),Ae=(1<<z)-1,J=le(F,z,1),N=0;N<E;){
var V=J[ne(t,m,Ae)];m+=V&15;var w=V>>4;if(w<16)M[N++]=w;else{var D=0,$=0;for(w==16?($=3+ne(t,m,3),m+=2,D=M[N-1]):w==17?($=3+ne(t,m,7),m+=3):w==18&&($=11+ne(t,m,
127),m+=7);$--;)M[N++]=D}}var q=M.subarray(0,k),U=M.subarray(k);g=mn(q),y=mn(U),h=le(q,g,1),f=le(U,y,1)}else K(1);else{var w=xn(m)+4,S=t[w-4]|t[w-3]<<8,A=w+S;if(A>
s){l&&K(0);break}i&&c(p+S),r.set(t.subarray(w,A),p),e.b=p+=S,e.p=m=A*8,e.f=d;continue}if(m>x){l&&K(0);break}}i&&c(p+131072);for(var ht=(1<<g)-1,ee=(1<<y)-1,ve=m;;ve=
m){var D=h[pn(t,m)&ht],Z=D>>4;if(m+=D&15,m>x){l&&K(0);break}if(D||K(2),Z<256)r[p++]=Z;else if(Z==256){ve=m,h=null;break}else{var X=Z-254;if(Z>264){var N=Z-257,_=tr[N];
X=ne(t,m,(1<<_)-1)+js[N],m+=_}var ie=f[pn(t,m)&ee],ze=ie>>4;ie||K(3),m+=ie&15;var U=pl[ze];if(ze>3){var _=rr[ze];U+=pn(t,m)&(1<<_)-1,m+=_}if(m>x){l&&K(0);break}
i&&c(p+131072);var Be=p+X;if(p<U){var Vt=o-U,qt=Math.min(U,Be);for(Vt+p<0&&K(3);p<qt;++p)r[p]=n[Vt+p]}for(;p<Be;++p)r[p]=r[p-U]}}e.l=h,e.p=ve,e.b=p,e.f=d,h&&(d=
1,e.m=g,e.d=f,e.n=y)}while(!d);return p!=r.length&&a?Sn(r,0,p):r.subarray(0,p)},xe=function(t,e,r){r<<=e&7;var n=e/8|0;t[n]|=r,t[n+1]|=r>>8},At=function(t,e,r){
r<<=e&7;var n=e/8|0;t[n]|=r,t[n+1]|=r>>8,t[n+2]|=r>>16},hn=function(t,e){for(var r=[],n=0;n<t.length;++n)t[n]&&r.push({s:n,f:t[n]});var s=r.length,o=r.slice();if(!s)
return{t:qs,l:0};if(s==1){var a=new P(r[0].s+1);return a[r[0].s]=1,{t:a,l:1}}r.sort(function(A,k){return A.f-k.f}),r.push({s:-1,f:25001});var i=r[0],l=r[1],c=0,
d=1,m=2;for(r[0]={s:-1,f:i.f+l.f,l:i,r:l};d!=s-1;)i=r[r[c].f<r[m].f?c++:m++],l=r[c!=d&&r[c].f<r[m].f?c++:m++],r[d++]={s:-1,f:i.f+l.f,l:i,r:l};for(var p=o[0].s,n=1;n<
s;++n)o[n].s>p&&(p=o[n].s);var h=new Q(p+1),f=vn(r[d-1],h,0);if(f>e){var n=0,g=0,y=f-e,x=1<<y;for(o.sort(function(k,C){return h[C.s]-h[k.s]||k.f-C.f});n<s;++n){
var v=o[n].s;if(h[v]>e)g+=x-(1<<f-h[v]),h[v]=e;else break}for(g>>=y;g>0;){var w=o[n].s;h[w]<e?g-=1<<e-h[w]++-1:++n}for(;n>=0&&g;--n){var S=o[n].s;h[S]==e&&(--h[S],
++g)}f=e}return{t:new P(h),l:f}},vn=function(t,e,r){return t.s==-1?Math.max(vn(t.l,e,r+1),vn(t.r,e,r+1)):e[t.s]=r},Ds=function(t){for(var e=t.length;e&&!t[--e];)
;for(var r=new Q(++e),n=0,s=t[0],o=1,a=function(l){r[n++]=l},i=1;i<=e;++i)if(t[i]==s&&i!=e)++o;else{if(!s&&o>2){for(;o>138;o-=138)a(32754);o>2&&(a(o>10?o-11<<5|
28690:o-3<<5|12305),o=0)}else if(o>3){for(a(s),--o;o>6;o-=6)a(8304);o>2&&(a(o-3<<5|8208),o=0)}for(;o--;)a(s);o=1,s=t[i]}return{c:r.subarray(0,n),n:e}},Mt=function(t,e){
for(var r=0,n=0;n<e.length;++n)r+=t[n]*e[n];return r},Vs=function(t,e,r){var n=r.length,s=xn(e+2);t[s]=n&255,t[s+1]=n>>8,t[s+2]=t[s]^255,t[s+3]=t[s+1]^255;for(var o=0;o<
n;++o)t[s+o+4]=r[o];return(s+4+n)*8},Us=function(t,e,r,n,s,o,a,i,l,c,d){xe(e,d++,r),++s[256];for(var m=hn(s,15),p=m.t,h=m.l,f=hn(o,15),g=f.t,y=f.l,x=Ds(p),v=x.c,
w=x.n,S=Ds(g),A=S.c,k=S.n,C=new Q(19),E=0;E<v.length;++E)++C[v[E]&31];for(var E=0;E<A.length;++E)++C[A[E]&31];for(var M=hn(C,7),F=M.t,N=M.l,z=19;z>4&&!F[fn[z-1]];--z)
;var Ae=c+5<<3,J=Mt(s,Te)+Mt(o,Et)+a,V=Mt(s,p)+Mt(o,g)+a+14+3*z+Mt(C,F)+2*C[16]+3*C[17]+7*C[18];if(l>=0&&Ae<=J&&Ae<=V)return Vs(e,d,t.subarray(l,l+c));var D,$,q,
U;if(xe(e,d,1+(V<J)),d+=2,V<J){D=le(p,h,0),$=p,q=le(g,y,0),U=g;var ht=le(F,N,0);xe(e,d,w-257),xe(e,d+5,k-1),xe(e,d+10,z-4),d+=14;for(var E=0;E<z;++E)xe(e,d+3*E,
F[fn[E]]);d+=3*z;for(var ee=[v,A],ve=0;ve<2;++ve)for(var Z=ee[ve],E=0;E<Z.length;++E){var X=Z[E]&31;xe(e,d,ht[X]),d+=F[X],X>15&&(xe(e,d,Z[E]>>5&127),d+=Z[E]>>12)}}else
D=hl,$=Te,q=gl,U=Et;for(var E=0;E<i;++E){var _=n[E];if(_>255){var X=_>>18&31;At(e,d,D[X+257]),d+=$[X+257],X>7&&(xe(e,d,_>>23&31),d+=tr[X]);var ie=_&31;At(e,d,q[ie]),
d+=U[ie],ie>3&&(At(e,d,_>>5&8191),d+=rr[ie])}else At(e,d,D[_]),d+=$[_]}return At(e,d,D[256]),d+$[256]},wl=new wn([65540,131080,131088,131104,262176,1048704,1048832,
2114560,2117632]),qs=new P(0),xl=function(t,e,r,n,s,o){var a=o.z||t.length,i=new P(n+a+5*(1+Math.ceil(a/7e3))+s),l=i.subarray(n,i.length-s),c=o.l,d=(o.r||0)&7;if(e){
d&&(l[0]=o.r>>3);for(var m=wl[e-1],p=m>>13,h=m&8191,f=(1<<r)-1,g=o.p||new Q(32768),y=o.h||new Q(f+1),x=Math.ceil(r/3),v=2*x,w=function(Qr){return(t[Qr]^t[Qr+1]<<
x^t[Qr+2]<<v)&f},S=new wn(25e3),A=new Q(288),k=new Q(32),C=0,E=0,M=o.i||0,F=0,N=o.w||0,z=0;M+2<a;++M){var Ae=w(M),J=M&32767,V=y[Ae];if(g[J]=V,y[Ae]=J,N<=M){var D=a-
M;if((C>7e3||F>24576)&&(D>423||!c)){d=Us(t,l,0,S,A,k,E,F,z,M-z,d),F=C=E=0,z=M;for(var $=0;$<286;++$)A[$]=0;for(var $=0;$<30;++$)k[$]=0}var q=2,U=0,ht=h,ee=J-V&32767;
if(D>2&&Ae==w(M-ee))for(var ve=Math.min(p,D)-1,Z=Math.min(32767,M),X=Math.min(258,D);ee<=Z&&--ht&&J!=V;){if(t[M+q]==t[M+q-ee]){for(var _=0;_<X&&t[M+_]==t[M+_-ee];++_)
;if(_>q){if(q=_,U=ee,_>ve)break;for(var ie=Math.min(ee,_-2),ze=0,$=0;$<ie;++$){var Be=M-ee+$&32767,Vt=g[Be],qt=Be-Vt&32767;qt>ze&&(ze=qt,V=Be)}}}J=V,V=g[J],ee+=
J-V&32767}if(U){S[F++]=268435456|gn[q]<<18|Fs[U];var ft=gn[q]&31,gt=Fs[U]&31;E+=tr[ft]+rr[gt],++A[257+ft],++k[gt],N=M+q,++C}else S[F++]=t[M],++A[t[M]]}}for(M=Math.
max(M,N);M<a;++M)S[F++]=t[M],++A[t[M]];d=Us(t,l,c,S,A,k,E,F,z,M-z,d),c||(o.r=d&7|l[d/8|0]<<3,d-=7,o.h=y,o.p=g,o.i=M,o.w=N)}else{for(var M=o.w||0;M<a+c;M+=65535){
var He=M+65535;He>=a&&(l[d/8|0]=c,He=a),d=Vs(l,d+1,t.subarray(M,He))}o.i=a}return Sn(i,0,n+xn(d)+s)},Sl=(function(){for(var t=new Int32Array(256),e=0;e<256;++e){
for(var r=e,n=9;--n;)r=(r&1&&-306674912)^r>>>1;t[e]=r}return t})(),Al=function(){var t=-1;return{p:function(e){for(var r=t,n=0;n<e.length;++n)r=Sl[r&255^e[n]]^r>>>
8;t=r},d:function(){return~t}}};var Ml=function(t,e,r,n,s){if(!s&&(s={l:1},e.dictionary)){var o=e.dictionary.subarray(-32768),a=new P(o.length+t.length);a.set(o),a.set(t,o.length),t=a,s.w=o.length}
return xl(t,e.level==null?6:e.level,e.mem==null?s.l?Math.ceil(Math.max(8,Math.min(13,Math.log(t.length)))*1.5):20:12+e.mem,r,n,s)},Ys=function(t,e){var r={};for(var n in t)
r[n]=t[n];for(var n in e)r[n]=e[n];return r};var W=function(t,e,r){for(;r;++e)t[e]=r,r>>>=8};var El=function(t,e){return((t[0]&15)!=8||t[0]>>4>7||(t[0]<<8|t[1])%31)&&K(6,"invalid zlib data"),(t[1]>>5&1)==+!e&&K(6,"invalid zlib data: "+(t[1]&32?"need":"u\
nexpected")+" dictionary"),(t[1]>>3&4)+2};function Tl(t,e){return Ml(t,e||{},0,0)}function Ks(t,e){return bl(t.subarray(El(t,e&&e.dictionary),-4),{i:2},e&&e.out,e&&e.dictionary)}var Js=function(t,e,r,n){for(var s in t){var o=t[s],a=e+s,i=n;Array.isArray(o)&&(i=Ys(n,o[1]),o=o[0]),o instanceof P?r[a]=[o,i]:(r[a+="/"]=[new P(0),i],Js(o,a,r,
n))}},Ws=typeof TextEncoder<"u"&&new TextEncoder,kl=typeof TextDecoder<"u"&&new TextDecoder,Cl=0;try{kl.decode(qs,{stream:!0}),Cl=1}catch{}function er(t,e){if(e){for(var r=new P(t.length),n=0;n<t.length;++n)r[n]=t.charCodeAt(n);return r}if(Ws)return Ws.encode(t);for(var s=t.length,o=new P(t.length+
(t.length>>1)),a=0,i=function(d){o[a++]=d},n=0;n<s;++n){if(a+5>o.length){var l=new P(a+8+(s-n<<1));l.set(o),o=l}var c=t.charCodeAt(n);c<128||e?i(c):c<2048?(i(192|
c>>6),i(128|c&63)):c>55295&&c<57344?(c=65536+(c&1047552)|t.charCodeAt(++n)&1023,i(240|c>>18),i(128|c>>12&63),i(128|c>>6&63),i(128|c&63)):(i(224|c>>12),i(128|c>>
6&63),i(128|c&63))}return Sn(o,0,a)}var bn=function(t){var e=0;if(t)for(var r in t){var n=t[r].length;n>65535&&K(9),e+=n+4}return e},zs=function(t,e,r,n,s,o,a,i){var l=n.length,c=r.extra,d=i&&i.length,
m=bn(c);W(t,e,a!=null?33639248:67324752),e+=4,a!=null&&(t[e++]=20,t[e++]=r.os),t[e]=20,e+=2,t[e++]=r.flag<<1|(o<0&&8),t[e++]=s&&8,t[e++]=r.compression&255,t[e++]=
r.compression>>8;var p=new Date(r.mtime==null?Date.now():r.mtime),h=p.getFullYear()-1980;if((h<0||h>119)&&K(10),W(t,e,h<<25|p.getMonth()+1<<21|p.getDate()<<16|p.
getHours()<<11|p.getMinutes()<<5|p.getSeconds()>>1),e+=4,o!=-1&&(W(t,e,r.crc),W(t,e+4,o<0?-o-2:o),W(t,e+8,r.size)),W(t,e+12,l),W(t,e+14,m),e+=16,a!=null&&(W(t,e,
d),W(t,e+6,r.attrs),W(t,e+10,a),e+=14),t.set(n,e),e+=l,m)for(var f in c){var g=c[f],y=g.length;W(t,e,+f),W(t,e+2,y),t.set(g,e+4),e+=4+y}return d&&(t.set(i,e),e+=
d),e},Ol=function(t,e,r,n,s){W(t,e,101010256),W(t,e+8,r),W(t,e+10,r),W(t,e+12,n),W(t,e+16,s)};function Zs(t,e){e||(e={});var r={},n=[];Js(t,"",r,e);var s=0,o=0;for(var a in r){var i=r[a],l=i[0],c=i[1],d=c.level==0?0:8,m=er(a),p=m.length,h=c.comment,f=h&&
er(h),g=f&&f.length,y=bn(c.extra);p>65535&&K(11);var x=d?Tl(l,c):l,v=x.length,w=Al();w.p(l),n.push(Ys(c,{size:l.length,crc:w.d(),c:x,f:m,m:f,u:p!=a.length||f&&h.
length!=g,o:s,compression:d})),s+=30+p+y+v,o+=76+2*(p+y)+(g||0)+v}for(var S=new P(o+22),A=s,k=o-s,C=0;C<n.length;++C){var m=n[C];zs(S,m.o,m,m.f,m.u,m.c.length);
var E=30+m.f.length+bn(m.extra);S.set(m.c,m.o+E),zs(S,s,m,m.f,m.u,m.c.length,m.o,m.m),s+=16+E+(m.m?m.m.length:0)}return Ol(S,s,n.length,k,A),S}var se=(t,e)=>`${t}s of generation ${e}`,ce=["stay","north","east","south","west","northeast","southeast","southwest","northwest"];var Ke=["pursuer","evader"];function Je(t,e,r){let[n,s]=[e-t.payoff.first[0],r-t.payoff.first[1]],o=t.payoff.capture_rate[n]?.[s];return o===void 0?null:{rate:o,rates:t.payoff.capture_rates[n][s],
lengths:t.payoff.lengths[n][s]}}function nr(t,e,r){let{script:n,network:s,kept:o,genomes:a}=t.teams[e];if(n!==null||s===null)return"";if(!o.includes(r))return`T\
he page holds no genome of ${se(e,r)}: it would be too large. Choose a generation of ${o.join(", ")}.`;let i=o.length*s.genome_size;return Qs(a,s.genome_size).length===
i?"":`The page is damaged: it does not hold the ${i} numbers of the ${e}s' genomes. Write it again from its run.`}function te(t,e,r){let{script:n,network:s,kept:o,
genomes:a}=t.teams[e];if(n!==null||s===null)return n??"random";let i=o.indexOf(r);if(i<0)throw new RangeError(`${e}: expected a generation whose genome the page\
 holds, got ${r}`);let l=s.genome_size,c=Qs(a,l).subarray(i*l,(i+1)*l),{hidden:d,activation:m,sampled:p,memory:h}=s;return{hidden:d,activation:m,sampled:p,memory:h,
genome:c}}function sr(t,e,{pursuer:r,evader:n,episode:s,seed:o}){let a=e.seeds[r][n];return t.match(e.world,te(e,"pursuer",r),te(e,"evader",n),BigInt(o??a),s)}var An=4,
Mn=new Map,Xs=(t,e)=>{Mn.set(t,e)};function Qs(t,e){let r=Mn.get(t);if(r)return r;let n=new Float32Array;try{let s=$l(En(t),e);s.every(Number.isFinite)&&(n=s)}catch(s){
if(!(s instanceof DOMException||s instanceof RangeError||Rl(s)))throw s}return Mn.set(t,n),n}var Rl=t=>t instanceof Error&&"code"in t;function $l(t,e){let r=Ks(
t),n=r.length/An,s=new Uint8Array(r.length);for(let a=0;a<s.length;a++)s[a]=r[a%An*n+Math.floor(a/An)];let o=new Uint32Array(s.buffer);for(let a=e;a<o.length;a++)
o[a]^=o[a-e];return new Float32Array(s.buffer)}function En(t){let e=atob(Se(t)),r=new Uint8Array(e.length);for(let n=0;n<r.length;n++)r[n]=e.charCodeAt(n);return r}
var Se=t=>document.getElementById(t)?.textContent??"";var no={initial:1,noise:2,learn:3,opponents:4},kn={pursuer:1,evader:2,both:3},_e=4,Tn=2n**32n;function eo(t){let e=[],r=BigInt(t);do e.push(Number(r%Tn)),r/=Tn;while(r>
0n);return e}function to(t,e){let r=t;return n=>{let s=n^r;return r=Math.imul(r,e),s=Math.imul(s,r),s^s>>>16}}function ro(t,e){let r=Math.imul(3389127133,t)-Math.
imul(1232336661,e)|0;return r^r>>>16}function Cn(t,e,r){let n=t.flatMap(eo);if(e.length){for(;n.length<_e;)n.push(0);n.push(...e.flatMap(eo))}let s=to(1135663077,
2468251765),o=Array.from({length:_e},(i,l)=>s(n[l]??0));for(let i=0;i<_e;i++)for(let l=0;l<_e;l++)i!==l&&(o[l]=ro(o[l],s(o[i])));for(let i of n.slice(_e))for(let l=0;l<
_e;l++)o[l]=ro(o[l],s(i));let a=to(2337405405,1492356589);return Uint32Array.from({length:r},(i,l)=>a(o[l%_e]))}function Tt(t,e){let r=Cn(t,[],2*e);return BigUint64Array.
from({length:e},(n,s)=>BigInt(r[2*s])+Tn*BigInt(r[2*s+1]))}var or=(t,e,r)=>Tt([t,e,r],1)[0];var so=t=>(e,...r)=>new On(Cn([t],[no[e],...r],3)),On=class{#e;#t;#r;#n=1;constructor(e){[this.#e,this.#t,this.#r]=[e[0],e[1],e[2]];for(let r=0;r<12;r++)this.#o()}#o(){
let e=this.#e+this.#t+this.#n++|0;return this.#e=this.#t^this.#t>>>9,this.#t=this.#r+(this.#r<<3)|0,this.#r=(this.#r<<21|this.#r>>>11)+e|0,e>>>0}#s(){return(this.#o()+
.5)/2**32}normals(e){let r=new Float32Array(e);for(let n=0;n<e;n+=2){let[s,o]=[Math.sqrt(-2*Math.log(this.#s())),2*Math.PI*this.#s()];r[n]=s*Math.cos(o),n+1<e&&
(r[n+1]=s*Math.sin(o))}return r}integers(e,r){return Int32Array.from({length:r},()=>Math.floor(this.#s()*e))}permutation(e){return this.choice(e,e)}choice(e,r){
let n=Int32Array.from({length:e},(s,o)=>o);for(let s=0;s<r;s++){let o=s+Math.floor(this.#s()*(e-s));[n[s],n[o]]=[n[o],n[s]]}return n.slice(0,r)}};var O=Math.fround,_l=5,Pl=256,ar=class{size;sigma;fixed;#e;constructor(e,r,n,s){[this.size,this.sigma,this.fixed]=[e,n,s],this.#e=r.normals((1+Pl)*e);for(let o=0;o<
this.#e.length;o++)this.#e[o]*=O(n)}draw(e,r){let n=r.integers(this.#e.length-this.size+1,e);return Array.from(n,s=>{let o=this.#e.subarray(s,s+this.size);return this.
fixed?o.map((a,i)=>this.fixed[i]?0:a):o})}},Rn=class{#e;#t;#r=0;constructor(e){[this.#e,this.#t]=[new Float32Array(e),new Float32Array(e)]}moved(e,r,n){let[s,o,
a]=[.9,.999,O(1e-8)];this.#r+=1;let[i,l]=[O(1-s),O(1-o)],[c,d]=[O(1-s**this.#r),O(1-o**this.#r)];return e.map((m,p)=>{let h=r[p],f=this.#e[p]+=O(i*O(h-this.#e[p])),
g=this.#t[p]+=O(l*O(O(h*h)-this.#t[p])),y=O(O(Math.sqrt(O(O(g)/d)))+a);return O(m+O(O(O(n)*O(O(f)/c))/y))})}};function Ll(t){let e=Array.from(t).sort((r,n)=>r-n);
return t.map(r=>(e.indexOf(r)+e.lastIndexOf(r))/(2*(t.length-1))-.5)}var ir=class{genome;groups;#e;#t;#r;#n=[];constructor(e,r,n){[this.genome,this.#t,this.#e,this.#r]=
[e,r,n,new Rn(e.length)],this.groups=Int32Array.from({length:n.population},(s,o)=>o%(n.population/2))}get#o(){let{sigma:e,fixed:r}=this.#t,[n,s]=[0,0];return this.
genome.forEach((o,a)=>{r?.[a]||(n+=o*o,s+=1)}),Math.max(e,this.#e.relative_sigma*Math.sqrt(n/s))}ask(e){let[r,n]=[this.#e.population/2,this.genome.length];this.#n=
this.#t.draw(r,e);let s=O(this.#o/this.#t.sigma),o=new Float32Array(2*r*n);return this.#n.forEach((a,i)=>{for(let l=0;l<n;l++){let c=O(s*a[l]);o[i*n+l]=this.genome[l]+
c,o[(r+i)*n+l]=this.genome[l]-c}}),o}tell(e){let[r,n]=[Ll(e),this.#n.length],s=new Float32Array(this.genome.length);this.#n.forEach((o,a)=>{let i=O((r[a]-r[n+a])/
(2*n*this.#t.sigma**2));for(let l=0;l<s.length;l++)s[l]+=O(i*o[l])}),this.genome=this.#r.moved(this.genome,s,this.#e.learning_rate)}},kt=class{population;groups;#e;#t;#r=new Float64Array(
0);#n=0;constructor(e,r,n){[this.population,this.#t,this.#e]=[e,r,n],this.groups=new Int32Array(n.population)}get genome(){return this.#o(this.#n).slice()}#o(e){
let{size:r}=this.#t;return this.population.subarray(e*r,(e+1)*r)}#s(e,r){let n=this.#e.tournament??_l,s=r.integers(this.#r.length,e*n);return Array.from({length:e},
(o,a)=>s.subarray(a*n,(a+1)*n).reduce((i,l)=>this.#r[l]>this.#r[i]?l:i))}ask(e){if(!this.#r.length)return this.population;let{size:r}=this.#t,{population:n,elites:s}=this.#e,
o=n-s,a=this.#s(o,e);this.#s(o,e);let i=Array.from(this.#r.keys()).sort((c,d)=>this.#r[d]-this.#r[c]).slice(0,s),l=new Float32Array(this.population.length);return[
...i,...a].forEach((c,d)=>l.set(this.#o(c),d*r)),this.#t.draw(o,e).forEach((c,d)=>{let m=(s+d)*r;for(let p=0;p<r;p++)l[m+p]+=c[p]}),this.population=l,l}tell(e){
this.#r=e,this.#n=e.indexOf(Math.max(...e))}};var B=t=>Array.from(t).reduce((e,r)=>e+r,0)/t.length,oo=(t,e)=>e==="pursuer"?t:t[0].map((r,n)=>t.map(s=>1-s[n])),ao=(t,e)=>B(oo(t,e).at(-1));function io(t,e){let r=[],
n=oo(t,e).map(s=>B(s.map((o,a)=>(r[a]=Math.max(r[a]??0,o),r[a]-o))));return B(n.slice(Math.floor(n.length/2)))}var lo=-12676506002282294e14,co=({hidden:t,mask:e})=>t.map(r=>r+(e?4:0));function Ct(t){let e=[3*t.fov**2,...co(t),5],r=0;return e.slice(1).map((n,s)=>{let o={at:r,
inputs:e[s],outputs:n};return r+=(o.inputs+1)*n,o})}function Ze(t){let{at:e,inputs:r,outputs:n}=Ct(t).at(-1);return e+(r+1)*n}var Ot=(t,e)=>({hidden:co(t),activation:"\
relu",sampled:!0,memory:"none",genome:e});function uo(t,e,r,n){let s=new Float32Array(Ze(t)),o=Ct(t);return o.forEach(({at:a,inputs:i,outputs:l},c)=>{let d=Math.
fround(c===o.length-1?n:r);e.normals(i*l).forEach((m,p)=>s[a+p]=d*m)}),s}function $n(t){let{fov:e,mask:r}=t;if(!r)return null;let[n,s]=[new Uint8Array(Ze(t)),new Float32Array(
Ze(t))],o=Ct(t),a=o.length-1,i=Math.floor(e/2);return o.forEach(({at:l,inputs:c,outputs:d},m)=>{let p=(h,f)=>l+h*d+f;for(let h=0;h<4;h++)if(m>0&&n.fill(1,p(c-4+
h,0),p(c-4+h+1,0)),m<a)for(let f=0;f<=c;f++)n[p(f,d-4+h)]=1;r.forEach((h,f)=>{let g=m===a?1+f:d-4+f,y=m===0?h.map(([x,v,w])=>(x*e+i+v)*e+i+w):[c-4+f];for(let x of y)
n[p(x,g)]=1,s[p(x,g)]=m===a?lo:1})}),{fixed:n,values:s}}function _n(t,e){return e?t.map((r,n)=>e.fixed[n]?e.values[n]:r):t}function mo(t,e,r){let n=new Float32Array(
Ze(r)),[s,o]=[Ct(e),Ct(r)],a=Math.floor(r.fov/2)-Math.floor(e.fov/2),i=c=>c>=0&&c<r.fov,l=c=>{let[d,m,p]=[Math.floor(c/e.fov**2),Math.floor(c/e.fov)%e.fov+a,c%e.
fov+a];return i(m)&&i(p)?(d*r.fov+m)*r.fov+p:-1};return s.forEach((c,d)=>{let m=o[d],p=e.hidden[d]??5;for(let h=0;h<(d?e.hidden[d-1]:c.inputs);h++){let f=d?h:l(
h);if(!(f<0))for(let g=0;g<p;g++)n[m.at+f*m.outputs+g]=t[c.at+h*c.outputs+g]}for(let h=0;h<p;h++)n[m.at+m.inputs*m.outputs+h]=t[c.at+c.inputs*c.outputs+h]}),_n(
n.map(c=>c<=lo/2?0:c),$n(r))}function po(t,e,r,n){let[s,o]=[t.length,Math.max(...t)+1],a=o>1?s/o:1,i=Array.from(t.keys()).sort((m,p)=>t[m]-t[p]),l=[],c=[];for(let m=0;m<e;m++){let p=m%a;p===
0&&(c=Array.from(n.permutation(s/a)).flatMap(h=>i.slice(h*a,(h+1)*a))),l.push([i,c.map((h,f)=>c[f-f%a+(f%a-p+a)%a])])}let d=m=>i.map(()=>s+m);for(let m=0;m<r[1];m++)
l.push([i,d(m)]);for(let m=0;m<r[0];m++)l.push([d(m),i]);return{pursuer:Int32Array.from(l.flatMap(([m])=>m)),evader:Int32Array.from(l.flatMap(([,m])=>m)),group:Int32Array.
from(l.flatMap((m,p)=>i.map(h=>p*o+t[h])))}}function ho(t,e,r,n){let s=Math.max(...e)+1,[o,a]=[new Float64Array(r*s),new Float64Array(r*s)];n.forEach((l,c)=>{if(t[c]>=
r)return;let d=t[c]*s+e[c];o[d]+=l,a[d]+=1});let i=o.map((l,c)=>a[c]?l/a[c]:0);return Float64Array.from({length:r},(l,c)=>{let d=i.subarray(c*s,(c+1)*s);return Pn(
d)/a.subarray(c*s,(c+1)*s).filter(Boolean).length})}var Nl=128,Xe=8;function Pn(t){let{length:e}=t;if(e>Nl){let p=Math.floor(e/2)-Math.floor(e/2)%Xe;return Pn(t.
subarray(0,p))+Pn(t.subarray(p))}if(e<Xe)return t.reduce((p,h)=>p+h,0);let r=t.slice(0,Xe),n=e-e%Xe;for(let p=Xe;p<n;p++)r[p%Xe]+=t[p];let[s,o,a,i,l,c,d,m]=r;return t.
subarray(n).reduce((p,h)=>p+h,s+o+(a+i)+(l+c+(d+m)))}var L=["pursuer","evader"],Pe=t=>t==="pursuer"?"evader":"pursuer";var fo=({world:t})=>t.rules.teammate==="REACH"?.2:0;var cr={pursuer:["random","clumsy-fleer"],evader:["random","clumsy-chaser"]},Il=20,Fl=8,Dl=-1,ur=({world:t,policy:e},r,n)=>({fov:t.fov,hidden:e.hidden,mask:e.mask===
"none"?null:r[n]}),Qe=class{settings;archive={pursuer:[],evader:[]};rows=[];cells=new Map;counters=[];#e;#t;#r;#n={};#o=new Set;#s=0;#c=0;#p=0;constructor(e,r,n,s=so(
r.seed)){[this.#e,this.settings,this.#t,this.#r]=[e,r,n,s];for(let o of L){let{initial_weight:a,initial_head:i}=r.policy,l=s("initial",L.indexOf(o)),c=r.learner.
kind==="ga"?r.learner.population:1,d=Array.from({length:c},()=>uo(this.shape(o),l,a,i));this.#m(o,d),this.archive[o].push(this.#n[o].genome)}this.#w()}shape(e){
return ur(this.settings,this.#t,e)}get finished(){return Math.min(this.archive.pursuer.length,this.archive.evader.length)}*run(){yield*this.#x(0);for(let e=1;e<=
this.settings.schedule.generations;e++){if(this.settings.schedule.kind==="alternating")for(let r of L)yield*this.#u(r,e);else yield*this.#l(e);this.#w(),yield*this.#x(
e)}}change(e){let r=this.settings,n={pursuer:this.shape("pursuer"),evader:this.shape("evader")},s=l=>JSON.stringify(l(r))===JSON.stringify(l(e));this.settings=e;
let o=s(l=>[l.world.fov,l.policy]);if(!o||!s(l=>l.learner))for(let l of L){let c=d=>mo(d,n[l],this.shape(l));this.archive[l]=this.archive[l].map(c),this.#m(l,this.#a(
l).map(c))}if(o&&s(l=>l.world))return null;this.cells.clear(),this.#o.clear();let{pursuer:a,evader:i}=this.archive;return{type:"anew",settings:e,genomes:{pursuer:a.
slice(0,this.finished),evader:i.slice(0,this.finished)}}}#a(e){let r=this.#n[e];if(!(r instanceof kt))return[r.genome];let n=r.genome.length,s=Array.from({length:r.
population.length/n},(o,a)=>r.population.slice(a*n,(a+1)*n));return Array.from({length:this.settings.learner.population},(o,a)=>a===0?r.genome:s[a%s.length])}#m(e,r){
let{learner:n}=this.settings,[s,o]=[this.shape(e),n.kind==="ga"?n.mutation:n.sigma],a=$n(s),i=new ar(Ze(s),this.#r("noise",L.indexOf(e)),o,a?.fixed??null),l=r.map(
c=>_n(c,a));this.#n[e]=n.kind==="ga"?new kt(lr(l),i,n):new ir(l[0],i,n)}*#u(e,r){for(let n=0;n<this.#i(e);n++){let s=this.archive[Pe(e)].length,o=this.settings.
schedule[`${e}s_meet`],a=o==="latest"?s-1:o==="round-robin"?n%s:this.#r("opponents",L.indexOf(e),r,n).choice(s,1)[0],i=e==="pursuer"?[r,a]:[a,r],l=this.#n[e],{groups:c}=l,
d=Tt([this.settings.seed,...i,kn[e],n],Math.max(...c)+1),m=l.ask(this.#r("learn",L.indexOf(e),r,n)),[p,h]=[Int32Array.from(c.keys()),new Int32Array(c.length)],f={
[e]:m,[Pe(e)]:this.archive[Pe(e)][a]},g={[e]:p,[Pe(e)]:h},y=this.#f(f,g,BigUint64Array.from(c,v=>d[v])),x=this.#y(y,e);this.#b(y,x,{generation:r,team:e,epoch:n,
opponent:a}),l.tell(x),yield*this.#v(r,n,e)}this.archive[e].push(this.#n[e].genome)}*#l(e){for(let r=0;r<this.#i("pursuer");r++){let{schedule:n,learner:{population:s}}=this.
settings,[o,a]=n.kind==="hall-of-fame"?[n.hall_sample,n.contemporaries]:[0,1],i={pursuer:this.#h("pursuer",e,r),evader:this.#h("evader",e,r)},l=this.#r("opponen\
ts",0,e,r),c={pursuer:this.#d(o,l),evader:this.#d(o,l)},d=y=>lr([i[y],...Array.from(c[Pe(y)],x=>this.archive[y][x])]),m=[c.evader.length,c.pursuer.length],p=po(
this.#n.pursuer.groups,a,m,l),h=Tt([this.settings.seed,e,e,kn.both,r],Math.max(...p.group)+1),f={pursuer:d("pursuer"),evader:d("evader")},g=this.#f(f,p,BigUint64Array.
from(p.group,y=>h[y]));for(let y of L){let x=ho(p[y],p[Pe(y)],s,this.#y(g,y));this.#b(g,x,{generation:e,team:y,epoch:r,opponent:Dl}),this.#n[y].tell(x)}yield*this.#v(
e,r,"both")}for(let r of L)this.archive[r].push(this.#n[r].genome)}#h(e,r,n){return this.#n[e].ask(this.#r("learn",L.indexOf(e),r,n))}#d(e,r){let n=this.archive.
pursuer.length;return e?r.choice(n,Math.min(e,n)):new Int32Array(0)}#i(e){let{schedule:r}=this.settings;return r.kind==="hall-of-fame"?r.joint_epochs:r[`${e}_ep\
ochs`]}*#v(e,r,n){let[s,o]=this.settings.schedule.kind==="hall-of-fame"?[this.#i("pursuer"),0]:[this.#i("pursuer"),this.#i("evader")],a=r+1+(n==="evader"?s:0),i=s+
o;yield{type:"epoch",done:(e-1)*i+a,of:this.settings.schedule.generations*i},yield*this.catchUp()}#f(e,r,n){let s={...this.settings.world,max_steps:this.settings.
train_steps},o=this.#e.rollouts(s,this.#g("pursuer",e.pursuer),this.#g("evader",e.evader),{...r,seed:n},1);this.#s+=o.length.length;for(let a of o.length)this.#c+=
Number(a);for(let a of o.agent_steps)this.#p+=Number(a);return o}#g(e,r){return Ot(this.shape(e),r)}#y({captured_fraction:e,overlap:r},n){let s=fo(this.settings);
return Float64Array.from(e,(o,a)=>n==="pursuer"?o:1-o-s*Number(r[2*a+1]))}#b(e,r,n){let s=B(r),o=[0,0];e.faults.forEach((a,i)=>o[Math.floor(i/3)%2]+=Number(a)),
this.rows.push({...n,fitness_mean:s,fitness_std:Math.sqrt(B(r.map(a=>(a-s)**2))),fitness_best:Math.max(...r),capture_rate:B(e.capture_rate),length:B(e.length),pursuer_faults:o[0]/
e.length.length,evader_faults:o[1]/e.length.length,matches:this.#s,steps:this.#c})}#w(){this.counters.push({matches:this.#s,steps:this.#c,agent_steps:this.#p})}*#x(e){
yield{type:"generation",number:e,genomes:{pursuer:this.archive.pursuer[e],evader:this.archive.evader[e]}},yield*this.catchUp()}*catchUp(){for(let e=this.finished-
1;e>=0;e--){for(let r=e;r>=0;r--)for(let[n,s]of r===e?[[e,e]]:[[e,r],[r,e]]){if(this.cells.has(`${n} ${s}`))continue;let o=this.#S(n,s);this.cells.set(`${n} ${s}`,
o),yield{type:"cell",cell:o}}this.#o.has(e)||(this.#o.add(e),yield{type:"scores",number:e,scores:{pursuer:this.#A("pursuer",e),evader:this.#A("evader",e)}})}}#S(e,r){
let{world:n,evaluation_episodes:s,seed:o}=this.settings,a={pursuer:new Int32Array(1),evader:new Int32Array(1),seed:BigUint64Array.of(or(o,e,r))},i=L.map(d=>this.#g(
d,this.archive[d][d==="pursuer"?e:r])),l=this.#e.rollouts(n,...i,a,s),c=d=>{let m=Array.from(l[d],Number),p=m.length/s;return Array.from({length:p},(h,f)=>B(m.filter(
(g,y)=>y%p===f)))};return{pursuer:e,evader:r,capture_rates:Array.from(l.capture_rate),lengths:Array.from(l.length),means:{collisions:c("collisions"),faults:c("f\
aults"),agent_steps:c("agent_steps"),survivors:c("survivors")}}}#A(e,r){let{world:n,seed:s}=this.settings,[o,a]=[this.#g(e,this.archive[e][r]),new Int32Array(1)];
return B(cr[e].map((i,l)=>{let c=Tt([s,L.indexOf(e),l,Fl],1),d=e==="pursuer"?[o,i]:[i,o],m=B(this.#e.rollouts(n,...d,{pursuer:a,evader:a,seed:c},Il).capture_rate);
return e==="pursuer"?m:1-m}))}};function lr(t){let e=new Float32Array(t.reduce((n,{length:s})=>n+s,0)),r=0;for(let n of t)e.set(n,r),r+=n.length;return e}var Ul=12;function go(t){let e=new Blob([Se("script-engine"),`
`,Se(`script-${t}`)],{type:"text/javascript"});return new Worker(URL.createObjectURL(e))}function yo(){let t=d=>postMessage(d),e=Qt(),r=null,n=null,s=0,o=!1,a=new MessageChannel,
i=()=>{let d=performance.now()+Ul;for(;n&&performance.now()<d;){let{value:m,done:p}=n.next();p?(n=null,t({type:"end",seconds:(performance.now()-s)/1e3})):t(m)}!n||
o||(o=!0,a.port2.postMessage(null))},l=async d=>{if(d.type==="start")r=new Qe(await e,d.settings,d.masks),[n,s]=[r.run(),performance.now()],i();else if(d.type===
"stop")n=null;else if(d.type==="change"){let m=r?.change(d.settings);if(m&&t(m),!r||!m||n)return;n=r.catchUp(),i()}else if(r){let{settings:m,archive:p,rows:h,cells:f,
counters:g,finished:y}=r;t({type:"saved",race:{settings:m,archive:p,rows:h,cells:f,counters:g,finished:y}})}},c=d=>{Promise.resolve().then(d).catch(m=>{n=null,t(
{type:"failed",message:String(m)})})};a.port1.onmessage=()=>{o=!1,c(i)},globalThis.onmessage=({data:d})=>c(()=>l(d))}var Wl="http://www.w3.org/2000/svg";function u(t,e={},...r){return vo(document.createElement(t),e,r)}function b(t,e={},...r){return vo(document.createElementNS(
Wl,t),e,r)}function vo(t,e,r){for(let[s,o]of Object.entries(e))o==null||o===!1||(typeof o=="function"?t.addEventListener(s.slice(2),o):t.setAttribute(s,o===!0?"":
String(o)));let n=r.filter(s=>s!=null&&s!==!1);return t.append(...n.map(s=>typeof s=="number"?String(s):s)),t}function dr(t,e){let r=u("select",{onchange:()=>e(
r.value)},...t.map(([n,s])=>u("option",{value:n},s)));return r}async function Ln(t){try{await t}catch(e){throw(document.querySelector("#page, main")??document.body).
prepend(u("p",{class:"card problem",role:"alert"},`The page could not start: ${String(e)}`)),e}finally{document.body.dataset.ready="true"}}var bo=()=>["file:","\
http:","https:"].includes(location.protocol);var wo=t=>u("input",{type:"text",readonly:!0,"aria-label":t});function et(t,e){let r=URL.createObjectURL(new Blob([e],{type:"application/octet-stream"}));u("a",
{href:r,download:t}).click(),setTimeout(()=>URL.revokeObjectURL(r),6e4)}var xo=()=>document.documentElement.dataset.theme==="dark",Rt=t=>{document.documentElement.dataset.theme=t?"dark":"light"},zl=()=>Rt(!xo());if(typeof document<"\
u"){let t=matchMedia("(prefers-color-scheme: dark)");t.addEventListener("change",()=>Rt(t.matches)),Rt(t.matches);let e=!1;addEventListener("beforeprint",()=>{e=
xo(),Rt(!1)}),addEventListener("afterprint",()=>Rt(e))}function So(){return u("button",{type:"button",title:"Light or dark (D)","aria-label":"Light or dark",onclick:zl},
"◐")}var mr=(t,e,...r)=>u("header",{class:"top"},u("div",{},u("h1",{},t),e?u("p",{class:"lead"},e):null),u("div",{class:"tools"},...r,So()));var pr=t=>t!==void 0&&"predict"in t,hr=({sections:t})=>new Map(t.flatMap(({parts:e})=>e.filter(pr).map(r=>[r.predict,r]))),Ao=()=>JSON.parse(Se("data"));var tt=[[0,0],[-1,0],[0,1],[1,0],[0,-1],[-1,1],[1,1],[1,-1],[-1,-1]];function Mo(t,e,r){let[n,s]=[e[0]-t[0],e[1]-t[1]];return!r&&Math.abs(n)>Math.abs(s)?s=0:r||
(n=0),tt.findIndex(([o,a])=>o===Math.sign(n)&&a===Math.sign(s))}var Le=(t,e)=>e<t.nPursuers,R=(t,e)=>[t.positions[2*e],t.positions[2*e+1]],Nn=({rows:t,cols:e},[
r,n])=>r>=0&&n>=0&&r<t&&n<e,In=(t,e,r=3)=>t!==void 0&&[0,1,2].slice(0,r).some(n=>t[3*e+n]),Fn=(t,e)=>In(t.fault,e),Eo=(t,e)=>!Fn(t,e)&&In(t.involved,e,2);function fr(t,e,r){
let[n,s]=[R(t,r),R(e,r)],o=n[0]!==s[0]||n[1]!==s[1],a=e.involved===void 0||In(e.involved,r);return!!(e.alive[r]&&e.actions?.[r]&&!o&&a)}function gr(t,e,r){let[n,
s]=R(t,r),[o,a]=tt[e.actions?.[r]??0];return[n+o,s+a]}function $t(t,e,r){return Array.from({length:r.everCaptured.length},(s,o)=>o).filter(s=>r.everCaptured[s]&&
!e.everCaptured[s]).map(s=>t.nPursuers+s)}var yr=t=>t.moments.flatMap((e,r)=>r&&$t(t,t.moments[r-1],e).length?[r]:[]);function vr(t,e){return Array.from({length:e.
alive.length},(n,s)=>s).filter(n=>t.alive[n]&&!e.alive[n])}var To=[-.31,0,.31],ko=[{size:1,at:[[0,0]]},{size:.62,at:[[-.2,.2],[.2,-.2]]},{size:.54,at:[[-.23,.22],[.23,.22],[0,-.22]]},{size:.54,at:[[-.23,.23],[.23,.23],[
-.23,-.23],[.23,-.23]]},{size:.36,at:To.flatMap(t=>To.map(e=>[e,t]))}],Bl=.3,Hl=.35,jl=.55;function _t(t,e){let r=new Map;for(let n=0;n<e.alive.length;n++){if(!e.
alive[n])continue;let[s,o]=R(e,n),a=s*t.cols+o,i=r.get(a);i?i.push(n):r.set(a,[n])}return r}function Co(t,e){let r=Array.from(e.alive,(n,s)=>{let[o,a]=R(e,s);return{
x:a+.5,y:o+.5,size:1,alpha:0}});for(let n of _t(t,e).values()){let s=ko[Math.min(n.length,ko.length)-1];n.forEach((o,a)=>{let[i,l]=s.at[Math.min(a,s.at.length-1)],
c=r[o];c.x+=i,c.y+=l,c.size=s.size,c.alpha=1})}return r}var Oo=t=>t*t*(3-2*t),rt=(t,e,r)=>t+(e-t)*r,Ro=t=>Math.min(1,Math.max(0,t));function $o(t,e,r,n){let s={
SIMULTANEOUS:1,SWARM_TURNS:2,AGENT_TURNS:r}[t.interaction];if(s===1)return Oo(n);let o=s===r?e:+!Le(t,e),a=Math.max(1/s,Hl);return Oo(Ro((n-o/(s-1)*(1-a))/a))}function br(t,e){
let r=t.moments.length-1,n=Math.min(Math.floor(e),r),s=t.moments[n],o=Co(t,s);if(n===r||e===n)return o;let a=t.moments[n+1],i=Co(t,a);return o.map((l,c)=>{let d=$o(
t,c,o.length,e-n);return Gl(s,a,c,l,i[c],d)})}function Dn(t,e,r){let n=t.moments.length-1,s=Math.min(Math.floor(r),n),[o,a]=[t.moments[s],t.moments[Math.min(s+1,
n)]],i=$o(t,e,o.alive.length,r-s),[[l,c],[d,m]]=[R(o,e),R(a,e)];return[rt(c,m,i)+.5,rt(l,d,i)+.5]}function Gl(t,e,r,n,s,o){let a=n.alpha>s.alpha,i={x:rt(n.x,s.x,
o),y:rt(n.y,s.y,o),size:a?n.size:rt(n.size,s.size,o),alpha:a?Ro((1-o)/(1-jl)):rt(n.alpha,s.alpha,o)};if(fr(t,e,r)){let[l,c]=R(t,r),[d,m]=gr(t,e,r),p=Bl*Math.sin(
Math.PI*o);i.x+=(m-c)*p,i.y+=(d-l)*p}return i}var _o=2*Math.PI;function Ne(t,e,r,n){t.beginPath(),t.arc(e,r,n/2,0,_o)}function wr(t,e,r,n){let s=n/2,o=[[0,-.97],[.97,.83],[-.97,.83]].map(([a,i])=>[e+a*s,r+i*
s]);t.beginPath(),t.moveTo((o[2][0]+o[0][0])/2,(o[2][1]+o[0][1])/2),o.forEach(([a,i],l)=>{let[c,d]=o[(l+1)%3];t.arcTo(a,i,c,d,n*.09)}),t.closePath()}function Po(t,e,r,n){
let s=n*.32;t.beginPath(),t.moveTo(e-s,r-s),t.lineTo(e+s,r+s),t.moveTo(e+s,r-s),t.lineTo(e-s,r+s)}function Lo(t,e,r,n){t.beginPath();for(let s=0;s<16;s++){let o=n/
2*(s%2?.6:.95),a=_o*s/16;t.lineTo(e+o*Math.sin(a),r-o*Math.cos(a))}t.closePath()}function No(t,e,r,n,s,o){let a=Math.atan2(s-r,n-e);t.beginPath(),t.moveTo(e,r),
t.lineTo(n,s);for(let i of[-1,1])t.moveTo(n,s),t.lineTo(n-o*Math.cos(a+i*.6),s-o*Math.sin(a+i*.6))}var Io=4,Vl=1.6,ql=.95,Yl=5,Kl=.16,Jl=9,Zl=.09,Xl=.2,Fo=.75,j=(t,e)=>t.left+e*t.cell,G=(t,e)=>t.top+e*t.cell;function nt(t,e,r){return Le(e,r)?t.colors.pursuer:
t.colors.evader}function xr({ctx:t,colors:e},r,n,s,o,a,i=0){t.font=`700 ${Math.round(o)}px system-ui, sans-serif`,t.textAlign="center",t.textBaseline="middle",t.
strokeStyle=e.paper,t.lineWidth=i,i&&t.strokeText(r,n,s),t.fillStyle=a,t.fillText(r,n,s)}function Do({ctx:t,grid:e,colors:r}){let{left:n,top:s,cell:o,rows:a,cols:i}=e,
[l,c]=[i*o,a*o];if(t.fillStyle=r.paper,t.fillRect(n,s,l,c),o<Yl)return;t.fillStyle=r.line;let d=Math.max(1,Math.round(o/60));for(let m=1;m<i;m++)t.fillRect(n+m*
o,s,d,c);for(let m=1;m<a;m++)t.fillRect(n,s+m*o,l,d)}function Uo({ctx:t,grid:e,colors:r},n){let{left:s,top:o,cell:a,rows:i,cols:l}=e;t.fillStyle=r.obstacle;for(let c=0;c<
i*l;c++){if(!n.obstacles[c])continue;let[d,m]=[Math.floor(c/l),c%l];t.fillRect(s+m*a,o+d*a,a,a)}Wo({ctx:t,grid:e,colors:r})}function Wo({ctx:t,grid:{left:e,top:r,
cell:n,rows:s,cols:o},colors:a}){let i=Math.min(5,Math.max(2,Math.round(n/18)));t.strokeStyle=a.frame,t.lineWidth=i,t.strokeRect(e-i/2,r-i/2,o*n+i,s*n+i)}function zo({
ctx:t,grid:e,colors:r},n){let{left:s,top:o,cell:a,rows:i,cols:l}=e,c=a<24*n?5:1;t.font=`500 ${Math.round(Math.min(15*n,Math.max(9*n,a*.32)))}px system-ui, sans-\
serif`,t.fillStyle=r.muted,t.textBaseline="alphabetic",t.textAlign="center";let d=5*n+a/40;for(let m=0;m<l;m+=c)t.fillText(String(m),s+(m+.5)*a,o-d);t.textAlign=
"right",t.textBaseline="middle";for(let m=0;m<i;m+=c)t.fillText(String(m),s-d,o+(m+.5)*a)}function Bo({grid:t},e,r,n){let s=Math.floor(e.fov/2)+.5,[o,a]=[Math.max(
0,r-s),Math.min(t.cols,r+s)],[i,l]=[Math.max(0,n-s),Math.min(t.rows,n+s)];return[j(t,o),G(t,i),(a-o)*t.cell,(l-i)*t.cell]}function Ho(t,e,r,n){let{ctx:s,grid:o,
colors:a}=t;s.save(),s.beginPath(),s.rect(0,0,s.canvas.width,s.canvas.height),s.rect(...Bo(t,e,r,n)),s.clip("evenodd"),s.clearRect(0,0,s.canvas.width,s.canvas.height),
s.fillStyle=a.line,s.fillRect(o.left,o.top,o.cols*o.cell,o.rows*o.cell),s.restore(),Wo(t)}function jo(t,{x:e,y:r,alpha:n},s){let{ctx:o,grid:a,colors:i}=t,l=Math.
max(a.cell,16*s)*1.06,[c,d]=[j(a,e),G(a,r)];o.globalAlpha=Math.max(n,.6),o.beginPath(),o.roundRect(c-l/2,d-l/2,l,l,l*.2),o.strokeStyle=i.focus,o.lineWidth=Math.
max(2,2.5*s),o.stroke();let m=Math.max(11*s,Math.min(18*s,a.cell*.5)),p=d-l/2<m*1.2,h=d+(p?1:-1)*(l/2+m*.7);o.lineJoin="round",xr(t,"You",c,h,m,i.ink,m*.35),o.globalAlpha=
1}function Go(t,e,r,n,s){let{ctx:o,grid:a}=t,i=Bo(t,e,n,s),l=nt(t,e,r);o.globalAlpha=.11,o.fillStyle=l,o.fillRect(...i),o.globalAlpha=.8,o.strokeStyle=l,o.lineWidth=
Math.max(1,a.cell/24),o.strokeRect(...i),o.globalAlpha=1}function Vo(t,e,r,n,s){let{ctx:o,grid:a}=t,i=Math.min(Math.ceil(r),e.moments.length-1),l=e.moments[i];o.
lineCap="round",o.lineWidth=Math.min(Jl,Math.max(1,a.cell*Kl));for(let c=Math.max(1,Math.floor(r-n)+1);c<=i;c++){let[d,m]=[e.moments[c-1],e.moments[c]],p=Math.max(
0,Math.min(1,(r-c)/n));o.globalAlpha=Fo+(Xl-Fo)*p;for(let h=0;h<m.alive.length;h++){let f=c===i&&r<i;if(!d.alive[h]||!(l.alive[h]||f))continue;let g=(Le(e,h)?-1:
1)*Zl,[y,x]=R(d,h),[v,w]=R(m,h);if(y===v&&x===w)continue;let S=f?s[h].x:w+.5,A=f?s[h].y:v+.5;o.strokeStyle=nt(t,e,h),o.beginPath(),o.moveTo(j(a,x+.5+g),G(a,y+.5+
g)),o.lineTo(j(a,S+g),G(a,A+g)),o.stroke()}}o.globalAlpha=1}function qo(t,e,r){let n=Math.min(Math.ceil(r),e.moments.length-1);for(let s=Math.max(1,n-Io+1);s<=n;s++){
let[o,a]=[e.moments[s-1],e.moments[s]],i=s>r?Math.max(0,1-2*(s-r)):1-(r-s)/Io,l=$t(e,o,a);for(let c of vr(o,a))l.includes(c)||ec(t,R(a,c),i);for(let c of l)Ql(t,
R(a,c),i)}t.ctx.globalAlpha=1}function Ql({ctx:t,grid:e,colors:r},[n,s],o){t.globalAlpha=o,Lo(t,j(e,s+.5),G(e,n+.5),Math.max(8,e.cell*Vl)),t.fillStyle=r.capture,
t.fill(),t.strokeStyle=r.ink,t.lineWidth=Math.max(1,e.cell/36),t.lineJoin="round",t.stroke()}function ec({ctx:t,grid:e,colors:r},[n,s],o){t.globalAlpha=o,Po(t,j(
e,s+.5),G(e,n+.5),Math.max(7,e.cell*ql)),t.strokeStyle=r.collision,t.lineWidth=Math.max(2,e.cell*.17),t.lineCap="round",t.stroke()}function Yo({ctx:t,grid:e,colors:r},n,s){
let o=Math.max(1,e.cell*.07);t.strokeStyle=t.fillStyle=r.collision,t.lineWidth=Math.max(1,e.cell*.05),t.setLineDash([e.cell*.14,e.cell*.1]);for(let[a,i]of n){if(a<
0||i<0||a>=e.rows||i>=e.cols)continue;let l=[j(e,i)+o,G(e,a)+o,e.cell-2*o,e.cell-2*o];t.globalAlpha=.2*s,t.fillRect(...l),t.globalAlpha=s,t.strokeRect(...l)}t.setLineDash(
[]),t.globalAlpha=1}function Ko({ctx:t,grid:e,colors:r},n,s,o,a){t.globalAlpha=a,Ne(t,j(e,n),G(e,s),Math.max(8,e.cell*o*1.02)),t.strokeStyle=r.collision,t.lineWidth=
Math.max(1.5,e.cell*.085*Math.sqrt(o)),t.stroke(),t.globalAlpha=1}var tc=.8,rc=.92,nc=15,sc=7,Un=9;function Jo(t,e,r,n,s,o){n.forEach((a,i)=>{a.alpha>0&&oc(t,e,r,i,a,s,o)}),t.ctx.globalAlpha=1;for(let a of _t(e,r).values())a.length>
Un&&ac(t,n[a[Un-1]],a.length-Un+1)}function oc(t,e,r,n,s,o,a){let{ctx:i,grid:l,colors:c}=t,d=Le(e,n),[m,p]=[j(l,s.x),G(l,s.y)],h=Math.max(4,l.cell*s.size*(d?rc:
tc)),f=nt(t,e,n),g=!d&&!!r.captured[n-e.nPursuers];if(i.globalAlpha=s.alpha,(d?wr:Ne)(i,m,p,h),h>sc*a&&(i.strokeStyle=c.paper,i.lineWidth=Math.max(2,h*.1),i.stroke()),
i.fillStyle=g?c.paper:f,i.fill(),g&&(Ne(i,m,p,h*.82),i.strokeStyle=f,i.lineWidth=h*.18,i.stroke()),!o||h<nc*a)return;let y=String(d?n:n-e.nPursuers),x=h*(d?.4:.5)*
(y.length>1?.8:1);xr(t,y,m,p+h*(d?.17:.03),x,g?f:c.paper)}function ac(t,e,r){let{cell:n}=t.grid;xr(t,`+${r}`,j(t.grid,e.x),G(t.grid,e.y),n*.3,t.colors.ink,n*.1)}var ic=.46,lc=.86,cc=.66,Zo=.48,uc=.78,dc=.58;function Xo(t,e,r,n){let[s,o]=[e.moments[r-1],e.moments[r]];if(!s)return;let{ctx:a,grid:i,colors:l}=t;a.strokeStyle=
l.collision,a.lineWidth=Math.max(1.5,i.cell*.07),a.lineCap="butt",a.globalAlpha=n;for(let c=0;c<o.alive.length;c++)fr(s,o,c)&&mc(t,e,R(s,c),gr(s,o,c));a.globalAlpha=
1}function mc({ctx:t,grid:e},r,n,s){let[o,a]=[s[1]-n[1],s[0]-n[0]],i=m=>j(e,n[1]+.5+o*m),l=m=>G(e,n[0]+.5+a*m),c=Nn(r,s)?uc:dc;t.setLineDash([e.cell*.09,e.cell*
.06]),t.beginPath(),t.moveTo(i(Zo),l(Zo)),t.lineTo(i(c),l(c)),t.stroke(),t.setLineDash([]);let d=.17*e.cell/Math.hypot(o,a);t.beginPath(),t.moveTo(i(c)-a*d,l(c)+
o*d),t.lineTo(i(c)+a*d,l(c)-o*d),t.stroke()}function Qo(t,e,r,n,s,o){let a=tt[o];if(!o||!a)return;let{ctx:i,grid:l,colors:c}=t,d=Nn(e,[n[0]+a[0],n[1]+a[1]])?lc:
cc,m=ic*s.size,p=[j(l,s.x+a[1]*m),G(l,s.y+a[0]*m),j(l,s.x+a[1]*d),G(l,s.y+a[0]*d)],h=Math.max(1.5,l.cell*.085);i.lineCap=i.lineJoin="round";for(let[f,g]of[[c.paper,
h*2.1],[nt(t,e,r),h]])i.strokeStyle=f,i.lineWidth=g,No(i,...p,l.cell*.2),i.stroke()}var ta={numbers:!0,axes:!1,trail:6,viewers:[],plan:null,selected:null,cursor:null,you:null,fog:!1};function ra(t,e,r,n,s){let{ctx:o,grid:a,colors:i}=t,l=Math.min(
Math.ceil(r),e.moments.length-1),c=e.moments[l],d=r===l,m=br(e,r),p=d?1:Math.max(0,1-2*(l-r));o.clearRect(0,0,o.canvas.width,o.canvas.height),Do(t);for(let g of n.
viewers)m[g]?.alpha&&Go(t,e,g,...Dn(e,g,r));Uo(t,e),n.axes&&zo(t,s),Vo(t,e,r,n.trail,m),Yo(t,c.contested??[],p),qo(t,e,r),Xo(t,e,l,p),m.forEach(({x:g,y,size:x},v)=>{
let w=Eo(c,v)?.4:0,S=Fn(c,v)?1:w;S&&Ko(t,g,y,x,S*p)});let h=d?c:e.moments[Math.max(0,l-1)];if(Jo(t,e,h,m,n.numbers,s),d&&n.plan)for(let[g,y]of m.entries())y.alpha&&
Qo(t,e,g,R(c,g),y,n.plan[g]??0);n.you!==null&&(n.fog&&Ho(t,e,...Dn(e,n.you,r)),jo(t,m[n.you],s)),o.lineWidth=Math.max(2,2.5*s),o.strokeStyle=i.focus;let f=n.selected===
null?void 0:m[n.selected];f?.alpha&&ea(t,f.x,f.y,f.size*.96),n.cursor&&(o.setLineDash([a.cell*.12,a.cell*.08]),ea(t,n.cursor[1]+.5,n.cursor[0]+.5,.8),o.setLineDash(
[]))}function ea({ctx:t,grid:e},r,n,s){let o=s*e.cell;t.beginPath(),t.roundRect(e.left+r*e.cell-o/2,e.top+n*e.cell-o/2,o,o,o*.1),t.stroke()}var na=(t,e)=>(e+.24)/(t+.24);function sa(t,e,r,n,s,o){let a=r?28*o:0,i=(c,d)=>(c-a)/(d+2*.12),l=Math.max(1,Math.floor(Math.min(i(n,e),i(s,t))));return{rows:t,cols:e,
cell:l,left:Math.round((n-e*l+a)/2),top:Math.round((s-t*l+a)/2)}}function oa(t,e,r){let n=Math.floor((r-t.top)/t.cell),s=Math.floor((e-t.left)/t.cell);return n>=
0&&n<t.rows&&s>=0&&s<t.cols?[n,s]:null}var pc=["paper","line","frame","ink","muted","obstacle"],hc=["pursuer","evader","capture","collision","focus"];function Sr(t){let e=getComputedStyle(t),r=(n,s)=>[
n,e.getPropertyValue(s+n).trim()];return Object.fromEntries([...pc.map(n=>r(n,"--board-")),...hc.map(n=>r(n,"--"))])}var oe=()=>matchMedia("(prefers-reduced-motion: reduce)").matches,ke=class{canvas;#e=null;#t=0;#r;#n={rows:1,cols:1,left:0,top:0,cell:1};#o=0;constructor(e,r={}){
this.canvas=e,e.classList.add("board"),e.setAttribute("role","img"),this.#r={...ta,...r},new ResizeObserver(()=>this.#c()).observe(e),new MutationObserver(()=>this.
redraw()).observe(document.documentElement,{attributes:!0}),addEventListener("beforeprint",()=>this.drawNow())}set look(e){this.#r={...this.#r,...e},this.#s(),this.
redraw()}show(e,r){this.#e=e,this.#t=Math.min(Math.max(0,r),e.moments.length-1),this.#s(),this.redraw()}redraw(){this.#o||(this.#o=requestAnimationFrame(()=>this.
drawNow()))}drawNow(){cancelAnimationFrame(this.#o),this.#o=0;let e=this.canvas.getContext("2d");if(!e||!this.#e)return;let{rows:r,cols:n}=this.#e,s=devicePixelRatio||
1;this.#n=sa(r,n,this.#r.axes,this.canvas.width,this.canvas.height,s);let o={ctx:e,grid:this.#n,colors:Sr(this.canvas)};ra(o,this.#e,this.#t,this.#r,s)}cellAt(e,r){
let n=this.canvas.getBoundingClientRect(),s=this.canvas.width/n.width;return oa(this.#n,(e-n.left)*s,(r-n.top)*s)}agentAt(e,r){let n=this.cellAt(e,r);if(!n||!this.#e)
return null;let s=this.#e.moments[Math.round(this.#t)],o=_t(this.#e,s).get(n[0]*this.#e.cols+n[1])??[],a=br(this.#e,Math.round(this.#t)),i=l=>{let[c,d]=this.pointOf(
a[l].x,a[l].y);return Math.hypot(c-e,d-r)};return o.length?o.reduce((l,c)=>i(c)<i(l)?c:l):null}pointOf(e,r){let n=this.canvas.getBoundingClientRect(),s=n.width/
this.canvas.width,{left:o,top:a,cell:i}=this.#n;return[n.left+(o+e*i)*s,n.top+(a+r*i)*s]}#s(){if(!this.#e)return;let{rows:e,cols:r}=this.#e;this.canvas.style.setProperty(
"--board-aspect",String(na(e,r)))}#c(){let e=devicePixelRatio||1,{width:r,height:n}=this.canvas.getBoundingClientRect();this.canvas.width=Math.max(1,Math.round(
r*e)),this.canvas.height=Math.max(1,Math.round(n*e)),this.drawNow()}};var Pt=[.5,1,2,4,8,16,32,64],Ar=0,Mr=12,fc=2,ue=class extends EventTarget{#e;#t;#r;#n=0;#o=0;#s=!1;#c=null;#p=0;#a=[];#m=[];glide=.28;constructor(e,{speed:r=4,still:n=!1}={}){
super(),[this.#e,this.#t,this.#r]=[e,r,n]}get step(){return this.#n}get time(){return this.#r?this.#n:this.#o}get arrived(){return this.#o===this.#n}get playing(){
return this.#s}get length(){return this.#e}set length(e){this.#e=e,this.#n>e&&this.jump(e),this.#i("state")}get marks(){return this.#a}set marks(e){this.#a=e,this.#i(
"state")}get ticks(){return this.#m}set ticks(e){this.#m=e,this.#i("state")}get pace(){return this.#t||Math.max(fc,this.#e/Mr)}get speed(){return this.#t}set speed(e){
this.#t=e,this.#i("state")}changeSpeed(e){let r=Pt.findIndex(n=>n>=this.pace);this.speed=Pt[Math.min(Pt.length-1,Math.max(0,r+e))]}play(){this.#s||!this.#e||(this.#n===
this.#e&&this.jump(0),this.#s=!0,this.#i("state"),this.#l())}pause(){this.#s&&(this.#s=!1,this.#i("state"))}toggle(){this.#s?this.pause():this.play()}move(e){this.
pause();let r=Math.min(this.#e,Math.max(0,this.#n+e));Math.abs(r-this.#o)>1?this.jump(r):this.#u(r),this.#l()}jump(e){this.#o=Math.min(this.#e,Math.max(0,Math.round(
e))),this.#u(this.#o),this.#i("frame")}#u(e){e!==this.#n&&(this.#n=e,this.#i("step"),this.#r&&this.#i("frame"))}#l(){this.#c===null&&(this.#p=performance.now(),
this.#c=requestAnimationFrame(()=>this.#h()))}#h(){this.#c=null;let e=performance.now();this.#d(Math.min(.25,(e-this.#p)/1e3)),this.#p=e,(!this.#r||this.arrived)&&
this.#i("frame"),(this.#s||this.#o!==this.#n)&&(this.#c=requestAnimationFrame(()=>this.#h()))}#d(e){let r=e;for(;r>0;){if(this.#o===this.#n){if(!this.#s)return;
if(this.#n===this.#e)return this.pause();this.#u(this.#n+1)}let n=this.#s?this.pace:1/this.glide,s=this.#n-this.#o,o=Math.min(Math.abs(s),r*n);r-=o/n,this.#o=o===
Math.abs(s)?this.#n:this.#o+Math.sign(s)*o}this.#s&&this.#o===this.#e&&this.pause()}#i(e){this.dispatchEvent(new Event(e))}};function Er(t,e){if(e.ctrlKey||e.metaKey||
e.altKey)return!1;let r=e.shiftKey?10:1,s={" ":()=>t.toggle(),ArrowRight:()=>t.move(r),ArrowLeft:()=>t.move(-r),Home:()=>t.move(-t.length),End:()=>t.move(t.length),
"+":()=>t.changeSpeed(1),"-":()=>t.changeSpeed(-1)}[e.key];return s?.(),s!==void 0}var gc={first:"M6 5v14M19 5 9 12l10 7z",back:"M17 5 7 12l10 7z",play:"M7 4.5 19 12 7 19.5z",pause:"M8 5v14M16 5v14",forward:"M7 5l10 7-10 7z",last:"M18 5v14M5 5\
l10 7-10 7z"};function aa(t){return b("svg",{viewBox:"0 0 24 24","aria-hidden":"true",class:"icon"},b("path",{d:gc[t]}))}function Lt(t,e,r,n){return u("button",
{type:"button",class:"player-button","aria-label":e,title:`${e} (${r})`,onclick:n},aa(t))}function Ce(t){let e=Lt("play","Play","Space",()=>t.toggle()),r=u("inp\
ut",{type:"range",class:"player-scrub",min:0,step:1,"aria-label":"Step",oninput:()=>{t.pause(),t.jump(Number(r.value))}}),n=u("div",{class:"captures","aria-hidd\
en":"true",title:"Captures"}),s=u("div",{class:"losses","aria-hidden":"true"}),o=u("select",{class:"player-speed","aria-label":"Speed",title:`Steps a second, or\
 the whole in ${Mr} s (+ and -)`,onchange:()=>t.speed=Number(o.value)},u("option",{value:Ar},`in ${Mr} s`),...Pt.map(m=>u("option",{value:m},`${m} / s`))),a=u("\
output",{class:"player-count"}),i=u("div",{class:"player",role:"group","aria-label":"Player"},Lt("first","First step","Home",()=>t.move(-t.length)),Lt("back","S\
tep back","←",()=>t.move(-1)),e,Lt("forward","Step forward","→",()=>t.move(1)),Lt("last","Last step","End",()=>t.move(t.length)),u("div",{class:"scrub"},n,s,
r),a,o),l=(m,p={})=>{let h=u("i",p);return h.style.left=`${100*m/Math.max(1,t.length)}%`,h},c=()=>{n.replaceChildren(...t.marks.map(m=>l(m))),s.replaceChildren(
...t.ticks.map(({step:m,kind:p,size:h,text:f})=>{let g=l(m,{class:p,title:`Step ${m}: ${f}`});return g.style.height=`${100*h}%`,g}))},d=()=>{e.replaceChildren(aa(
t.playing?"pause":"play")),e.ariaLabel=t.playing?"Pause":"Play",e.title=`${e.ariaLabel} (Space)`,r.max=String(t.length),r.value=String(t.step),r.ariaValueText=`\
step ${t.step} of ${t.length}`,a.textContent=`${t.step} / ${t.length}`,a.style.minWidth=`${2*String(t.length).length+3}ch`,o.value=String(t.speed)};return t.addEventListener(
"step",d),t.addEventListener("state",d),t.addEventListener("state",c),i.addEventListener("keydown",m=>{!(m.target instanceof HTMLSelectElement||m.key===" "&&m.target!==
r)&&Er(t,m)&&m.preventDefault()}),d(),i}var H=(t,e=2)=>t==null?"-":t.toFixed(e);function ia(t,e,r){return e===null||r===null?H(t):`${H(t)} (${H(e)} to ${H(r)})`}var de=t=>t.charAt(0).toUpperCase()+t.slice(1);function Nt(t,e,r,n=!1){let s=(e-t)/Math.max(1,r),o=10**Math.floor(Math.log10(s||1)),a=[1,2,5,10].map(c=>c*o).find(
c=>c>=s)??10*o;n&&(a=Math.max(1,Math.round(a)));let i=Math.ceil(t/a-1e-9),l=Math.floor(e/a+1e-9);return Array.from({length:Math.max(0,l-i+1)},(c,d)=>(i+d)*a)}var Tr={left:46,right:12,top:10,bottom:42},la={x:56,y:34};function me(t,e,r,n){let[s,o]=[Tr.left,Tr.top],a=Math.max(s+40,t-Tr.right),i=Math.max(o+40,e-Tr.bottom),
l=(g,y,x)=>v=>y+(v-g.low)/(g.high-g.low||1)*(x-y),[c,d]=[l(r,s,a),l(n,i,o)],m=b("g"),p=b("svg",{width:t,height:e,viewBox:`0 0 ${t} ${e}`,class:"plot"}),h=b("g",
{class:"axes"});for(let g of Nt(n.low,n.high,(i-o)/la.y,n.whole))h.append(b("line",{x1:s,x2:a,y1:d(g),y2:d(g),class:"grid"}),b("text",{x:s-8,y:d(g),"text-anchor":"\
end","dominant-baseline":"middle"},ca(g)));for(let g of Nt(r.low,r.high,(a-s)/la.x,r.whole))h.append(b("text",{x:c(g),y:i+16,"text-anchor":"middle"},ca(g)));return h.
append(b("line",{x1:s,x2:a,y1:i,y2:i,class:"axis"}),b("text",{x:(s+a)/2,y:e-6,"text-anchor":"middle",class:"label"},r.label),b("text",{transform:`translate(12 ${(o+
i)/2}) rotate(-90)`,"text-anchor":"middle",class:"label"},n.label)),p.append(h,m),{root:p,marks:m,left:s,right:a,top:o,bottom:i,x:c,y:d,at:g=>{let y=g-p.getBoundingClientRect().
left;return r.low+(y-s)/(a-s)*(r.high-r.low)}}}var ca=t=>String(Number(t.toPrecision(6))).replace("-","−");function pe(t,e,r,n){let s="",o="M";r.forEach((a,i)=>{
a===null?o="M":(s+=`${o}${t.x(e[i]).toFixed(1)} ${t.y(a).toFixed(1)}`,o="L")}),t.root.insertBefore(b("path",{d:s,class:`line ${n}`}),t.marks)}function ua(t,e,r,n=null){let s=t.x(e);t.marks.append(b("line",{x1:s,x2:s,y1:t.top,y2:t.bottom,class:`mark ${r}`})),n!==null&&t.marks.append(b("circle",{cx:s,cy:t.
y(n),r:5,class:`dot ${r}`}))}function st(...t){return u("p",{class:"legend small"},...t.map(([e,r])=>u("span",{class:`key ${r}`},e)))}function he(t,e,r,n){let s=u(
"div",{class:"chart chooses",role:"img","aria-label":t}),o=null,a=()=>{o?.marks.replaceChildren(),o&&r(o)};s.addEventListener("click",l=>o&&n(o.at(l.clientX),o,
l));let i=()=>{let{clientWidth:l,clientHeight:c}=s;l<50||c<50||(o=e(l,c),s.replaceChildren(o.root),a())};return new ResizeObserver(i).observe(s),{element:s,update:a,
redraw:i}}var It=[[68,1,84],[72,26,108],[71,47,125],[65,68,135],[57,86,140],[49,104,142],[42,120,142],[35,136,142],[31,152,139],[34,168,132],[53,183,121],[84,197,104],[122,
209,81],[165,219,54],[210,226,27],[253,231,37]];function kr(t){let e=Math.min(1,Math.max(0,t))*(It.length-1),r=Math.min(It.length-2,Math.floor(e)),[n,s]=[It[r],
It[r+1]],o=a=>Math.round(n[a]+(e-r)*(s[a]-n[a]));return[o(0),o(1),o(2)]}function da(t){let[e,r,n]=kr(t).map(s=>((s/255+.055)/1.055)**2.4);return .2126*e+.7152*r+
.0722*n>.179?"#000":"#fff"}var ma=t=>`rgb(${kr(t).join(" ")})`,pa=()=>`linear-gradient(to right, ${It.map(t=>`rgb(${t.join(" ")})`).join(", ")})`;function ot(t,e,r){let n=devicePixelRatio||1;for(let[a,i]of Object.entries(r))t.style.setProperty(a,`${i}px`);t.width=Math.round(r.width*n),t.height=Math.round(
r.height*n);let s=t.getContext("2d"),o=yc(e);!s||!o||(s.imageSmoothingEnabled=!1,s.drawImage(o,0,0,t.width,t.height))}function yc(t){let[e,r]=t.shape,n=document.
createElement("canvas");[n.width,n.height]=[r,e];let s=n.getContext("2d");if(!s)return null;let o=s.createImageData(r,e);return t.capture_rate.forEach((a,i)=>a.
forEach((l,c)=>{let d=4*((e-1-i-t.first[0])*r+c+t.first[1]);o.data.set([...kr(l),255],d)})),s.putImageData(o,0,0),n}function Cr(t,e,r,n=2){t.textContent=H(e,n),
t.ariaLabel=`${r}: ${t.textContent}`,e!==void 0&&([t.style.backgroundColor,t.style.color]=[ma(e),da(e)])}function Oe(t,e){let r=u("span",{class:"gradient"});return r.
style.backgroundImage=pa(),u("p",{class:"scale-of-rates small muted"},t,r,e)}function Ie(t,e,r=t.length){let n=u("canvas",{role:"img","aria-label":e}),s=u("div",{class:"cells-of-matrix"},n),o=u("figure",{},u("figcaption",{},e),s,u("p",{class:"\
small muted"},u("span",{class:"pursuer"},"↑ pursuers")," ",u("span",{class:"evader"},"evaders →")));return o.draw=()=>{let a=s.clientWidth;a&&ot(n,{shape:[r,
r],first:[0,0],capture_rate:t},{left:0,top:0,width:a,height:a})},new ResizeObserver(()=>o.draw?.()).observe(s),o}var fa=()=>Oe("0 all escape","1 all caught"),ga=({
runs:t})=>u("div",{class:"widget"},u("div",{class:"matrices"},...t.map((e,r)=>Ie(e.payoff.capture_rate,`Matrix ${"ABC"[r]}`))),fa()),Or=31,ha=.016;function ya(){
let t=r=>Array.from({length:Or},(n,s)=>Array.from({length:Or},(o,a)=>.5+r*(s-a))),e=[[ha,"Both get better"],[-ha,"Both get worse"],[0,"Nothing happens"]];return u(
"div",{class:"widget"},u("div",{class:"matrices"},...e.map(([r,n])=>Ie(t(r),n))),fa())}function va(){let t=Array.from({length:Or},(r,n)=>n),e=he("A capture rate\
 that stays at one half from generation 0 to 30",(r,n)=>{let s=me(r,n,{low:0,high:Or-1,label:"generation",whole:!0},{low:0,high:1,label:"capture rate"});return pe(
s,t,t.map(()=>.5),"of-both"),s},()=>{},()=>{});return u("div",{class:"widget"},e.element)}var fe=32,ba=({crossings:t=[]})=>u("div",{class:"widget crossings"},...t.
map(e=>u("figure",{},u("figcaption",{},e.title),vc(e),u("p",{class:"small muted"},e.text))));function vc({title:t,text:e,ways:r}){let n=[0,1,2,3].map(s=>`M${s*fe}\
 0V${3*fe}M0 ${s*fe}H${3*fe}`).join("");return b("svg",{viewBox:`-1 -1 ${3*fe+2} ${3*fe+2}`,role:"img","aria-label":`${t}: ${e}`},b("path",{class:"grid",d:n}),...r.
map(([s,o,a],i)=>b("g",{transform:`translate(${1.5*fe} ${1.5*fe})`},b("g",{transform:`translate(${-fe*o} ${-fe*s})`},b("path",{class:"filled-pursuer",d:"M0 -12 \
12 9H-12z"}),b("text",{y:6.5,"text-anchor":"middle"},`P${i}`)),b("path",{class:a?"goes":"waits",d:a?"M-18 0H-5M-9 -4 -4 0 -9 4":"M-16 -13V13",transform:`rotate(${Math.
atan2(s,o)*180/Math.PI})`}))))}function Fe(t,e,r,n,s){let o=u("input",{type:"range",min:0,max:e.length-1,step:1,"aria-label":t,oninput:()=>s(i())}),a=u("output",{class:"numbers"}),i=()=>{let l=e[Number(
o.value)];return a.textContent=o.ariaValueText=n(l),l};return o.value=String(e.indexOf(r)),i(),u("label",{class:"slider"},u("span",{},t),o,a)}function wa(t,e,r){
return u("label",{class:"slider"},u("span",{},t),dr(e.map(n=>[n,n]),r))}function Re(t){let e=t>>>0;return()=>{e=e+1831565813>>>0;let r=Math.imul(e^e>>>15,e|1);return r^=r+Math.imul(r^r>>>7,r|61),((r^r>>>14)>>>0)/2**32}}var zn=["rock",
"paper","scissors"],Bn=[[.5,0,1],[1,.5,0],[0,1,.5]],bc=1e-9,Aa=t=>Bn.map(e=>e.reduce((r,n,s)=>r+n*t[s],0));function Hn(t,e){let r=t.slice(-e);return zn.map((n,s)=>r.
filter(o=>o===s).length/r.length)}var jn=t=>Math.max(...Aa(t));function xa(t,e,r){let n=Aa(Hn(t,e)),s=n.flatMap((o,a)=>o>Math.max(...n)-bc?[a]:[]);return s[s.length>
1?Math.floor(r()*s.length):0]}function $r(t,e,r){let n={pursuers:[0],evaders:[0]};for(let s=1;s<=t;s++)n.pursuers.push(xa(n.evaders,e,r)),n.evaders.push(xa(n.pursuers,
e,r));return n}var Ft=100,_r={scalar:{dimensions:1,greatest:!0},focusing:{dimensions:10,greatest:!0},intransitive:{dimensions:2,greatest:!1}};function Wn(t,e,r){
let{greatest:n}=_r[t],s=e[0]-r[0];for(let o=1;o<e.length;o++){let a=e[o]-r[o];(n?Math.abs(a)>Math.abs(s):Math.abs(a)<Math.abs(s))&&(s=a)}return(1+Math.sign(s))/
2}var Gn=(t,e,r)=>e.reduce((n,s)=>n+r.reduce((o,a)=>o+Wn(t,s,a),0),0)/(e.length*r.length),it={population:25,mutation:.005,opponents:15,hall:0},at=class{game;settings;generation=0;#e;#t;#r=[
[],[]];constructor(e,r,n){[this.game,this.settings,this.#e]=[e,r,n];let s=()=>Array.from({length:r.population},()=>new Uint8Array(Ft));this.#t=[s(),s()]}ones(e){
let{dimensions:r}=_r[this.game],n=Ft/r;return this.#t[e].map(s=>Array.from({length:r},(o,a)=>Rr(s.subarray(a*n,(a+1)*n))))}objective=e=>Rr(this.#t[e].map(Rr))/this.
settings.population;step(){let e=[this.ones(0),this.ones(1)],r=this.#n(e);for(let n of[0,1]){this.#r[n].push(e[n][r[n].indexOf(Math.max(...r[n]))]);let s=this.#s(
r[n]);this.#t[n]=s.map(o=>this.#o(this.#t[n][o]))}this.generation++}#n(e){let{population:r,opponents:n,hall:s}=this.settings,o=[new Array(r).fill(0),new Array(r).
fill(0)];for(let a=0;a<n;a++)Sa(r,this.#e).forEach((i,l)=>{let c=Wn(this.game,e[0][l],e[1][i]);o[0][l]+=+(c===1),o[1][i]+=+(c===0)});for(let a of[0,1]){let i=this.#r[1-
a];for(let l of Sa(i.length,this.#e,s))e[a].forEach((c,d)=>o[a][d]+=+(Wn(this.game,c,i[l])===1))}return o}#o(e){let r=e.slice();for(let n=0;n<r.length;n++)this.#e()<
this.settings.mutation&&(r[n]^=1);return r}#s(e){let r=Rr(e),n=r?e:e.map(()=>1);return e.map(()=>{let s=this.#e()*(r||e.length),o=n.findIndex(a=>(s-=a)<0);return o<
0?e.length-1:o})}};function Sa(t,e,r=t){let n=Array.from({length:t},(o,a)=>a),s=Math.min(r,t);for(let o=0;o<s;o++){let a=o+Math.floor(e()*(t-o));[n[o],n[a]]=[n[a],
n[o]]}return n.slice(0,s)}function Rr(t){let e=0;for(let r=0;r<t.length;r++)e+=t[r];return e}var Vn=1,Pr=["pursuers","evaders"],Ta=[[150,42],[266,232],[34,232]],wc={pursuers:-7,evaders:7},Ma=t=>[0,1].map(e=>t.reduce((r,n,s)=>r+n*Ta[s][e],0)),Ea=(t,e)=>t.
map((r,n)=>Hn(t.slice(0,n+1),e));function ka({memories:t=[1],memory:e=t[0],generations:r=30}){let n=new ue(r,{speed:r>100?16:2,still:oe()}),s=e,o=$r(r,s,Re(Vn)),
a={pursuers:[],evaders:[]},i={pursuers:b("polyline",{class:"way of-pursuers"}),evaders:b("polyline",{class:"way of-evaders"})},l={pursuers:b("path",{class:"fill\
ed-pursuer",d:"M0 -11 11 9H-11z"}),evaders:b("circle",{class:"filled-evader",r:9})},c=b("svg",{viewBox:"0 0 300 270",class:"hands-triangle",role:"img","aria-lab\
el":"The shares of rock, paper and scissors among the remembered hands of both teams"},b("polygon",{class:"frame",points:Ta.map(y=>y.join()).join(" ")}),b("circ\
le",{class:"middle",cx:150,cy:168.7,r:4}),b("text",{x:150,y:192,"text-anchor":"middle"},"one third each"),b("text",{class:"label",x:150,y:18,"text-anchor":"midd\
le"},"rock"),b("text",{class:"label",x:266,y:262,"text-anchor":"middle"},"paper"),b("text",{class:"label",x:34,y:262,"text-anchor":"middle"},"scissors"),...Pr.map(
y=>i[y]),...Pr.map(y=>l[y])),d=u("p",{class:"numbers"}),m=he("What the best answer wins against the remembered hands, by generation",(y,x)=>{let v=me(y,x,{low:0,
high:r,label:"generation",whole:!0},{low:.4,high:1,label:"best answer wins"});pe(v,[0,r],[.5,.5],"half");for(let w of Pr)pe(v,o[w].map((S,A)=>A),a[w].map(jn),`o\
f-${w}`);return v},y=>ua(y,n.step,"of-both"),y=>n.jump(y)),p=()=>{let y=n.step;for(let v of Pr){i[v].setAttribute("points",a[v].slice(0,y+1).map(A=>Ma(A).map(k=>k.
toFixed(1)).join()).join(" "));let[w,S]=Ma(a[v][y]);l[v].setAttribute("transform",`translate(${w+wc[v]} ${S})`)}let x=v=>u("span",{class:v.slice(0,-1)},`${v} sh\
ow ${zn[o[v][y]]}`);d.replaceChildren(`Generation ${y}: `,x("pursuers"),", ",x("evaders"),".",...t.length>1?[` The best answer to the remembered hands of the pu\
rsuers wins ${H(jn(a.pursuers[y]))}.`]:[]),m.update()},h=()=>{o=$r(r,s,Re(Vn)),a={pursuers:Ea(o.pursuers,s),evaders:Ea(o.evaders,s)},m.redraw(),p()};n.addEventListener(
"step",p),h();let f=t.at(-1),g=Fe("memory (hands)",t,e,y=>y===f?"all":String(y),y=>{s=y,h()});return u("div",{class:"widget"},t.length>1&&g,u("div",{class:"two"},
u("div",{},c),t.length>1&&u("div",{},st(["pursuers' hands","of-pursuers"],["evaders' hands","of-evaders"]),m.element)),d,Ce(n))}function Ca({generations:t=30}){
let{pursuers:e,evaders:r}=$r(t,1,Re(Vn)),n=e.map(o=>r.map(a=>Bn[o][a])),s=n.at(-1);return u("div",{class:"widget"},u("div",{class:"matrices"},Ie(n,`The last pur\
suers score ${H(s.reduce((o,a)=>o+a,0)/s.length)} against all evaders.`)),Oe("0 loses","1 wins"))}var Dt=600,lt=20,qn=5,Ut=10,Yn={"Game A":"intransitive","Game B":"scalar","Game C":"focusing"},Ra={low:0,high:Dt,label:"generation",whole:!0},$a={low:0,high:Ft,
label:"ones of side 1"},De=()=>{},xc=()=>new Promise(t=>setTimeout(t));async function Kn(t,e,r){for(e();t.generation<Dt&&r();e()){for(let n=0;n<lt;n++)t.step();
await xc()}}var Lr=new Map,_a=[];async function Sc(){for(let t of Object.keys(Yn))Lr.set(t,[]);for(let t=0;t<qn;t++)for(let[e,r]of Object.entries(Yn)){let n={score:[],
ones:[]};Lr.get(e).push(n);let s=new at(r,it,Re(t));await Kn(s,()=>{n.score.push(Gn(r,s.ones(0),s.ones(1))),n.ones.push(s.objective(0))},()=>!0),_a.forEach(o=>o())}}
function Pa({shows:t="score"}){Lr.size||Sc();let e=t==="score"?{low:0,high:1,label:"score of side 1"}:$a,r=Object.entries(Yn).map(([n,s])=>{let o=t==="score"?n:
`${n}: ${s}`,a=he(`${o}: ${e.label} in ${qn} races`,(i,l)=>{let c=me(i,l,Ra,e);for(let d of Lr.get(n))pe(c,d[t].map((m,p)=>p*lt),d[t],"of-both dense");return c},
De,De);return _a.push(a.redraw),u("figure",{},u("figcaption",{},o),a.element)});return u("div",{class:"widget"},u("div",{class:"matrices"},...r),u("p",{class:"s\
mall muted"},`Each line is a race; there are ${qn} of each game, played now, in this page.`))}var Ac=[5,10,15,25,40,60],Mc=[5e-4,.001,.002,.005,.01,.02,.05],Ec=[
0,1,5,15,30],Oa=15,Tc=Array.from({length:20},(t,e)=>e);function La({hall:t=!1}){let[e,r,n]=["scalar",0,{...it,hall:t?Oa:0}],s=0,o=v=>{n={...n,...v}},a=[[],[]],i=[
Ie(a[0],"Score of side 1",Dt/lt+1),Ie(a[1],"Score of side 2",Dt/lt+1)];i.forEach(v=>v.querySelector("p").replaceChildren(`↑ generation, → opponent (${lt} a \
cell)`));let l=[[],[]],c=he("Ones of both sides by generation",(v,w)=>{let S=me(v,w,Ra,{...$a,label:"ones"});return l.forEach((A,k)=>pe(S,A.map((C,E)=>E*lt),A,k?
"of-evaders":"of-pursuers")),S},De,De),d=u("p",{class:"numbers",role:"status"}),m=v=>{d.textContent=v},p=async()=>{let v=++s;for(let A of[...a,...l])A.length=0;
let w=[[],[]],S=new at(e,n,Re(r));await Kn(S,()=>{for(let A of[0,1])w[A].push(S.ones(A)),l[A].push(S.objective(A));for(let A of[0,1])a[A].push(w[1-A].map(k=>Gn(
S.game,w[A].at(-1),k)));i.forEach(A=>A.draw?.()),c.redraw()},()=>s===v),s===v&&m(`${de(S.game)} game, seed ${r}: after ${Dt} generations side 1 has ${l[0].at(-1).
toFixed(0)} ones, side 2 ${l[1].at(-1).toFixed(0)}.`)},h=[],f=he("Ones of side 1 at the end of ten races, a row for each choice of settings",(v,w)=>kc(h,v,w),De,
De);f.element.classList.add("dots");let g=async v=>{let w=++s,S=[],{population:A,mutation:k}=v,C=`${e}${A===it.population?"":`, ${A} players`}${k===it.mutation?
"":`, mutation ${k}`}, hall ${v.hall}`;h=[...h.filter(E=>E.ends.length===Ut&&E.text!==C).slice(1-Jn),{text:C,ends:S}];for(let E=0;E<Ut&&s===w;E++){let M=new at(
e,v,Re(E));await Kn(M,De,()=>s===w),s===w&&S.push(M.objective(0)),f.redraw()}s===w&&m(`${de(C)}: side 1 ends with ${Na(S)} ones in the mean of ${Ut} races.`)},y=(v,w,S="")=>u(
"button",{type:"button",class:S,onclick:()=>{v()}},w),x=u("div",{class:"sliders"},wa("game",Object.keys(_r),v=>e=v),Fe("population",Ac,n.population,String,v=>o(
{population:v})),Fe("mutation",Mc,n.mutation,String,v=>o({mutation:v})),...t?[Fe("hall of fame",Ec,Oa,String,v=>o({hall:v}))]:[Fe("seed",Tc,0,String,v=>r=v)]);return t?
(g(it).then(()=>s===1?g(n):void 0),u("div",{class:"widget"},x,u("div",{class:"buttons"},y(()=>g(n),"Play ten races","primary")),d,f.element)):u("div",{class:"wi\
dget"},x,u("div",{class:"buttons"},y(p,"Play a race","primary"),y(async()=>{s++},"Stop")),u("div",{class:"matrices"},...i,u("figure",{},u("figcaption",{},"The t\
ruth: ones"),st(["side 1","of-pursuers"],["side 2","of-evaders"]),c.element)),Oe("0 loses","1 wins"),d)}var Jn=6,Na=t=>(t.reduce((e,r)=>e+r,0)/t.length).toFixed(
1);function kc(t,e,r){let n=me(e,r,{low:0,high:Ft,label:"ones of side 1 at the end",whole:!0},{low:0,high:Jn,label:""});return n.root.querySelectorAll(".axes .g\
rid, .axes [text-anchor=end]").forEach(s=>s.remove()),t.forEach(({text:s,ends:o},a)=>{let i=n.y(Jn-a-.7);n.marks.before(b("text",{class:"label",x:n.left,y:i-12},
`${s}: ${o.length<Ut?`${o.length} of ${Ut} races`:`mean ${Na(o)}`}`)),o.forEach(l=>n.marks.before(b("circle",{class:"dot of-both",cx:n.x(l),cy:i,r:5})))}),n}var Fa=t=>t.answer===void 0?Oc():Cc(t,t.answer);function Cc(t,e){let r=u("input",{type:"text",inputmode:"decimal",size:8,"aria-label":"Your answer, a number",autocomplete:"\
off"});return{input:r,check:()=>{let s=r.value.trim().replace(",","."),o=Number(s);if(s===""||Number.isNaN(o))return"Expected a number, such as 0.5.";let a=i=>Math.
abs(o-i)<=(t.tolerance??0)+1e-9;return a(e)?null:t.clues?.find(([i])=>a(i))?.[1]??t.otherwise??"Expected another number."},answer:()=>r.value,set:s=>r.value=s}}
var ae=4,Zn=[.5,.8,.2];function Oc(){let t=new Array(ae*ae).fill(.5),e=(l,c)=>Cr(l,t[c],`generation ${Math.floor(c/ae)} of the pursuers against generation ${c%ae}\
 of the evaders`,1),r=t.map((l,c)=>{let d=u("button",{type:"button",disabled:c%(ae+1)===0,onclick:()=>{t[c]=Zn[(Zn.indexOf(t[c])+1)%Zn.length],e(d,c)}});return e(
d,c),d}),n=Array.from({length:ae},(l,c)=>c),s=u("div",{class:"cells numbers",role:"group","aria-label":"Capture rates: rows are pursuers, columns evaders"},u("s\
pan"),u("span",{class:"evader all"},"generation of the evaders"),u("span",{class:"pursuer"},"generation of the pursuers"),...n.map(l=>u("span",{class:"evader"},
l)),...n.flatMap(l=>[u("span",{class:"pursuer"},l),...r.slice(l*ae,(l+1)*ae)])),o=l=>n.map(c=>n.reduce((d,m)=>d+t[l(c,m)],0)/ae);return{input:s,check:()=>{let l=o(
(m,p)=>m*ae+p),c=o((m,p)=>p*ae+m),d=(m,p)=>m.every((h,f)=>!f||p*(h-m[f-1])>1e-9);return d(l,1)?d(c,-1)?null:`The means of the columns are ${Ia(c)}. They say how\
 often the evaders are captured, and should fall from column to column.`:`The means of the rows are ${Ia(l)}. They are the strengths of the pursuers, and should\
 grow from row to row.`},answer:()=>t.join(" "),set:l=>{l.split(" ").forEach((c,d)=>t[d]=Number(c)),r.forEach(e)}}}var Ia=t=>t.map(e=>e.toFixed(2)).join(", ");var Wt=t=>t.trim().split(/\n\s*\n/).map(e=>u("p",{},...Xn(e))),Xn=t=>t.split("**").map((e,r)=>r%2?u("strong",{},e):document.createTextNode(e));function Da(t,e){
let{predict:r,options:n}=t,s=u("p",{class:"small muted",role:"status"}),o=u("button",{type:"submit",class:"primary"},"This is my prediction"),a=Object.keys(n).map(
c=>u("input",{type:"radio",name:`prediction-${r}`,value:c})),i=u("form",{class:"prediction",id:`prediction-${r}`},u("fieldset",{},u("legend",{},u("strong",{},"P\
redict. "),t.question),...a.map(c=>u("label",{class:"option"},c,u("span",{},n[c.value])))),u("div",{class:"buttons"},o,s)),l=()=>{let c=e.choice(r);if(c!==void 0){
for(let d of a)[d.checked,d.disabled]=[d.value===c,!0];o.hidden=o.disabled=!0,s.replaceChildren(),i.append(t.later?u("p",{class:"reply"},t.later):Rc(t,c,t.again&&
e.choice(t.again)))}};return i.addEventListener("submit",c=>{c.preventDefault();let d=a.find(m=>m.checked);d?(e.choose(r,d.value),l()):s.textContent="Choose one\
 first. Any prediction is a good one."}),l(),i}function Rc(t,e,r){let{options:n,outcome:s}=t,o=e===s;return u("div",{class:"reply",role:"status","data-right":String(
o)},r&&u("p",{},u("strong",{},"At the beginning you predicted: "),n[r]),u("p",{},u("strong",{},o?"✓ As you predicted: ":"You predicted: "),n[e]),o?null:u("p",
{},u("strong",{},"The outcome: "),n[s]),...Wt(t.explanation??""),t.note&&u("p",{class:"small muted"},t.note))}function Ua(t,e){let{input:r,check:n,answer:s,set:o}=Fa(
t),a=u("p",{class:"reply",role:"status",hidden:!0}),i=d=>{a.hidden=!1,a.dataset.right=String(d===null),a.replaceChildren(u("strong",{},d===null?"✓ Right. ":"✗\
 Not yet. "),d??t.explanation)},l=u("form",{class:"exercise",id:`exercise-${t.exercise}`},u("div",{class:"text"},u("p",{},u("strong",{},"Exercise. "),...Xn(t.question))),
t.matrix&&$c(t.matrix),u("div",{class:"buttons"},r,u("button",{type:"submit"},"Check")),a);l.addEventListener("submit",d=>{d.preventDefault();let m=n();m===null&&
e.solve(t.exercise,s()),i(m)});let c=e.solved(t.exercise);return c!==void 0&&(o(c),i(null)),l}function $c(t){let e=t.map((r,n)=>n);return u("div",{class:"wide-t\
able",tabindex:0},u("table",{class:"rates numbers"},u("thead",{},u("tr",{},u("td"),u("th",{scope:"colgroup",colspan:e.length,class:"evader"},"generation of the \
evaders")),u("tr",{},u("th",{class:"pursuer"},"generation of the pursuers"),...e.map(r=>u("th",{scope:"col"},r)))),u("tbody",{},...t.map((r,n)=>u("tr",{},u("th",
{scope:"row"},n),...r.map(s=>u("td",{},s.toFixed(1))))))))}var _c=40;function Wa({question:t="",points:e=[]},r){let n=u("textarea",{id:"exit-answer",rows:8,oninput:()=>{
r.exit={exit:n.value},s.textContent=n.value}}),s=u("p",{class:"printed"}),o=u("p",{class:"small muted",role:"status"}),a=u("button",{type:"submit",class:"primar\
y"},"I am done"),i=u("form",{class:"exercise"},u("label",{for:"exit-answer"},u("strong",{},"Exit question. "),t),n,s,u("div",{class:"buttons"},a,u("button",{type:"\
button",onclick:()=>et("exit_answer.txt",`${t}

${n.value}
`)},"Save my answer"),o)),l=()=>{s.textContent=r.exit.exit,r.exit.done&&([n.readOnly,a.hidden]=[!0,!0],i.append(u("div",{class:"reply"},u("p",{},u("strong",{},"\
A good answer has:")),u("ul",{},...e.map(c=>u("li",{},...Xn(c)))))))};return n.value=r.exit.exit,i.addEventListener("submit",c=>{if(c.preventDefault(),n.value.trim().
length<_c){o.textContent="Write two explanations and an experiment first. Then the page shows what a good answer has.";return}o.textContent="",r.exit={done:!0},
l()}),l(),u("div",{class:"widget"},i)}var Pc=Array.from({length:16},(t,e)=>{let[r,n]=[e%2?6.5:11,Math.PI*e/8];return`${12+r*Math.sin(n)} ${12-r*Math.cos(n)}`}).join(" ");function Nr(){let t=[["pursu\
er",b("path",{d:"M12 3 22 20H2z",class:"filled-pursuer"})],["evader",b("circle",{cx:12,cy:12,r:9,class:"filled-evader"})],["capture",b("polygon",{points:Pc,class:"\
filled-capture"})],["captured evader",b("circle",{cx:12,cy:12,r:7.5,class:"ring-evader"})],["conflict",b("rect",{x:3,y:3,width:18,height:18,class:"dashed-confli\
ct"})]];return u("ul",{class:"shapes small","aria-label":"Shapes on the board"},...t.map(([e,r])=>u("li",{},b("svg",{viewBox:"0 0 24 24","aria-hidden":"true"},r),
e)))}function Qn(t,e,r){let{rows:n,cols:s,n_pursuers:o,fov:a,rules:{interaction:i}}=t;return{rows:n,cols:s,nPursuers:o,fov:a,interaction:i,obstacles:e,moments:r}}function es(t,e){
return{positions:t.read("last_positions"),alive:t.read("alive"),captured:t.read("captured"),everCaptured:t.read("ever_captured"),actions:e,involved:t.read("invo\
lved"),fault:t.read("fault"),contested:t.conflicts().map(r=>r.cell)}}function Ir(t){let e=Array.from({length:t.length+1},(r,n)=>Lc(t,n));return Qn(t.config,t.map,
e)}function Lc(t,e){let r=t.n_agents,n=t.config.n_evaders,s=(a,i,l)=>a.subarray(i*l,(i+1)*l),o={positions:s(t.last_positions,e,2*r),alive:s(t.alive,e,r),captured:s(
t.captured,e,n),everCaptured:s(t.ever_captured,e,n)};return e===0?o:{...o,actions:s(t.actions,e-1,r),involved:s(t.involved,e-1,3*r),fault:s(t.fault,e-1,3*r),get contested(){
return t.conflicts(e).map(a=>a.cell)}}}var Nc=8,Ic=700,za=1400,Ue=class{element;player=new ue(0,{speed:Nc,still:oe()});title=u("figcaption");generation=0;#e=u("canvas");#t;#r=u("p",{class:"small mute\
d numbers"});#n=u("p",{class:"small",role:"status"});#o;#s=null;#c=0;#p=0;#a=!oe();constructor(e){this.#o=e,this.#t=new ke(this.#e,{numbers:!1}),this.element=u(
"figure",{class:"chase"},this.title,this.#e,this.#r,this.#n),this.player.addEventListener("frame",()=>this.#l()),this.player.addEventListener("step",()=>this.#h()),
this.player.addEventListener("state",()=>{this.#a&&!this.player.playing&&this.player.length&&this.player.step===this.player.length&&this.#m()})}set label(e){this.#e.
ariaLabel=e}get runs(){return this.#a}set runs(e){this.#a=e,clearTimeout(this.#p),e?this.player.play():this.player.pause()}renew(e=!1){e||!this.#s||performance.
now()-this.#c>za?this.#u():this.#m(za)}#m(e=Ic){clearTimeout(this.#p),this.#p=setTimeout(()=>this.#u(),e)}#u(){clearTimeout(this.#p);let e=this.#o();e&&(this.#s=
Ir(e),this.#c=performance.now(),this.player.jump(0),this.player.length=e.length,this.player.marks=yr(this.#s),this.#h(),this.#a&&this.player.play())}#l(){this.#s&&
this.#t.show(this.#s,this.player.time)}#h(){let e=this.#s?.moments[this.player.step]?.everCaptured;e&&(this.#r.textContent=`generation ${this.generation} · ${Array.
from(e).filter(Boolean).length} of ${e.length} caught · step ${this.player.step}`)}drawWalls(e){let r=!1,n=!0,s=[0,0],o=([l,c])=>!!this.#s?.obstacles[l*this.#s.
cols+c],a=(l,c)=>{this.#n.textContent=e(l,c)},i=l=>{let c=this.#t.cellAt(l.clientX,l.clientY);c&&o(c)!==n&&a(c,n)};return this.#e.addEventListener("pointerdown",
l=>{let c=r&&this.#t.cellAt(l.clientX,l.clientY);c&&(this.#e.setPointerCapture(l.pointerId),n=!o(c),i(l))}),this.#e.addEventListener("pointermove",l=>r&&l.buttons&&
i(l)),this.#e.addEventListener("keydown",l=>{let c={ArrowUp:[-1,0],ArrowDown:[1,0],ArrowLeft:[0,-1],ArrowRight:[0,1]}[l.key];if(!r||!this.#s||!(c||l.key===" "))
return;l.preventDefault();let d=(h,f)=>Math.min(f-1,Math.max(0,h)),{rows:m,cols:p}=this.#s;c?s=[d(s[0]+c[0],m),d(s[1]+c[1],p)]:a(s,!o(s)),this.#t.look={cursor:s}}),
l=>{r=l,this.#e.classList.toggle("drawn-on",l),this.#e.tabIndex=l?0:-1,this.#e.setAttribute("role",l?"application":"img"),this.#t.look={cursor:null}}}show(e){this.#s&&
(this.#s={...this.#s,obstacles:e},this.#l())}};var Ba="champion",Ha=0,ts=64,rs=100;var Fc=(t,e)=>Object.keys(t).every(r=>t[r]===e[r]);function ja(t,e){return Object.keys(e).find(r=>Fc(e[r],t))??null}function Ga(t,e,r){let n=new Set(t);return Array.
from({length:e},(s,o)=>Array.from({length:r},(a,i)=>n.has(o*r+i)?"#":".").join(""))}var Va={"specialist-specialist":"Specialists: both teams meet only the newest opponent","generalist-specialist":"Pursuers meet all earlier evaders, evaders only\
 the newest pursuers","generalist-generalist":"Generalists: both teams meet all earlier opponents","hall-of-fame":"Halls of fame: both teams learn at once, and \
meet earlier champions"};function zt({schedule:t}){if(t.kind==="hall-of-fame")return t.kind;let e={latest:"specialist","round-robin":"generalist",uniform:"unifo\
rm"};return`${e[t.pursuers_meet]}-${e[t.evaders_meet]}`}var Fr=t=>Va[zt(t)]??zt(t);function qa(t){let e=Object.values(t.races.es).find(a=>zt(a)==="generalist-generalist"),{n_pursuers:r,n_evaders:n,fov:s,max_steps:o}=e.world;return{schedule:zt(
e),beside:null,learner:"es",seed:e.seed,way:!1,population:0,pursuers:r,evaders:n,view:s,steps:o,walls:[]}}var Dc=t=>Object.values(t.races.es)[0].world;function Ya(t,e,r=e.
schedule){let n=t.races[e.learner][r],s=Dc(t),o={...s,n_pursuers:e.pursuers,n_evaders:e.evaders,fov:e.view,max_steps:e.steps,obstacles:e.walls.length?Ga(e.walls,
s.rows,s.cols):s.obstacles};return{...n,world:o,train_steps:e.steps,seed:e.seed,policy:{...n.policy,mask:e.way?"right-of-way":"none"},learner:{...n.learner,population:e.
population||n.learner.population}}}var Uc=40,Dr=class{element;#e;#t=u("div",{class:"episodes",role:"group","aria-label":"Episodes of this cell"});#r=u("p",{class:"check small numbers","aria-live":"\
polite"});constructor(e){this.#e=e,this.element=u("div",{class:"strip-of-episodes"},this.#t,this.#r)}show(e,r){let{pursuer:n,evader:s,episode:o,seed:a}=this.#e.
selected,i=Je(e,n,s);this.#t.replaceChildren(...(i?.rates??[]).slice(0,Uc).map((p,h)=>this.#n(p,h)));let l=a===null?i?.rates[o]:void 0,c=r.statistics.capture_rate,
d=l!==void 0&&Math.abs(c-l)<1e-6&&r.length===i?.lengths[o],m=i?"Not an episode of the evaluation":"The evaluation played no episodes of this pair.";this.#r.dataset.
equal=String(d),this.#r.textContent=d?"As in the evaluation":l===void 0?m:`Episode ${o+1} differs from the evaluation.`,this.#r.title=`Played here: capture rate\
 ${H(c,3)} in ${r.length} steps.${i?` The cell says ${H(i.rate,3)}.`:""}`}#n(e,r){let{selected:n}=this.#e,s=u("span",{class:"bar"});return s.style.height=`${Math.
round(100*e)}%`,u("button",{type:"button",class:"episode",title:`Episode ${r+1}: capture rate ${H(e)}`,"aria-label":`Episode ${r+1}, capture rate ${H(e)}`,"aria\
-pressed":String(r===n.episode&&n.seed===null),onclick:()=>this.#e.select({episode:r,seed:null})},s,u("span",{class:"count"},r+1))}};var Ka=0,Ja=1,Wc=2,zc=176;function Xa(t,e,r,n){let s=devicePixelRatio||1,o=Sr(t);t.width=t.height=zc*s;let a=t.getContext("2d");if(!a)return;let{fov:i}=e,l=t.width/
i;a.fillStyle=o.paper,a.fillRect(0,0,t.width,t.height);for(let d=0;r&&d<i*i;d++){let[m,p]=[(d%i+.5)*l,(Math.floor(d/i)+.5)*l],h=g=>!!r[g*i*i+d];h(Wc)&&(a.fillStyle=
o.obstacle,a.fillRect(m-l/2,p-l/2,l,l));let f=h(Ka)&&h(Ja)?l*.18:0;h(Ka)&&Za(a,Ne,m+f,p+f,l*.74,o.evader),h(Ja)&&Za(a,wr,m-f,p-f,l*.86,o.pursuer)}a.strokeStyle=
n<e.n_pursuers?o.pursuer:o.evader,a.lineWidth=2*s;let c=Math.floor(i/2)*l;a.strokeRect(c,c,l,l)}function Za(t,e,r,n,s,o){e(t,r,n,s),t.fillStyle=o,t.fill()}var Qa="What it remembers: a number for each unit, from -1 to 1",Ur=class{element;#e;#t=u("canvas",{class:"seen",role:"img"});#r=u("h3");#n=u("p",{class:"small \
muted"});#o=u("div",{class:"answers"});#s=u("div",{title:Qa});#c=null;#p=null;#a=null;#m=null;#u=null;#l=null;#h=0;constructor(e){this.#e=e,this.element=u("div",
{class:"inspector","data-open":"false"},u("p",{class:"hint small muted"},"Click an agent, or press A: what it sees, and what its network answers."),u("div",{class:"\
inspected"},this.#t,u("div",{class:"answer"},this.#r,this.#n,this.#s),this.#o))}get agent(){return this.#l}show(e,r,n,s){this.#c?.free(),this.#c=e.world(n.config),
this.#a!==r&&(this.#p=null,this.#l!==null&&this.choose(null)),[this.#a,this.#m,this.#u]=[r,n,s]}set solution(e){this.#p=e,this.at(this.#h)}choose(e){this.#l=e,this.
element.dataset.open=String(e!==null),this.#e(e),this.at(this.#h)}next(e){let r=this.#m;if(!r)return;let n=this.#l??(e>0?-1:0);for(let s=0;s<r.n_agents;s++)if(n=
(n+e+r.n_agents)%r.n_agents,r.alive[this.#h*r.n_agents+n])return this.choose(n)}at(e){this.#h=e;let[r,n,s,o,a]=[this.#m,this.#c,this.#a,this.#u,this.#l];if(!r||
!n||!s||!o||a===null)return;let i=a<r.config.n_pursuers?"pursuer":"evader";this.#s.replaceChildren(),this.#r.replaceChildren(u("span",{class:i},Y(a,r.config.n_pursuers)));
let l={pursuers:te(s,"pursuer",o.pursuer),evaders:te(s,"evader",o.evader)};r.seek(n,e,l);let c=r.actions.subarray(e*r.n_agents,(e+1)*r.n_agents);for(;c.length&&
!n.over&&(a<n.actors[0]||a>=n.actors[1]);)n.playTurn(c);let d=!!(r.alive[e*r.n_agents+a]&&n.read("alive")[a]);Xa(this.#t,r.config,d?n.view(a):null,a),this.#t.ariaLabel=
`Field of view of ${Y(a,r.config.n_pursuers)}: evaders, pursuers and obstacles around it`;let m=c[a]??null;if(!d)return this.#d([],"It is gone.");let p=l[`${i}s`],
h=typeof p=="string"?null:n.answer(p,a),f=h?.probabilities??null;h?.memory.length&&this.#s.replaceChildren(u("p",{class:"small muted"},"It remembers:"),jc(h.memory));
let g=this.#p?.game(n)??null,y=typeof p=="string"?`The script "${p}" plays for it${m===null?"":`; it goes ${ce[m]}`}.`:p.sampled?"Its action is drawn from these\
 probabilities.":"It takes the most probable action.",x=[["network",f],["perfect",g?.marginal(a)??null]],v=w=>u("p",{class:"small muted"},w);this.#d([...g?[v(`V\
alue ${g.value.toFixed(2)} under perfect play.`)]:[],...Bc(x,m)],m===null?"The episode is over.":y)}#d(e,r){this.#o.replaceChildren(...e),this.#n.textContent=r}};
function Bc(t,e){let r=t.filter(([,o])=>o);if(!r.length)return[];let n=u("div",{class:"action muted"},u("span"),...r.map(([o])=>u("span",{class:"head"},o))),s=Array.
from(r[0][1],(o,a)=>u("div",{class:a===e?"action taken":"action"},u("span",{},ce[a]),...r.flatMap(([,i])=>Hc(i[a]))));return r.length>1||r[0][0]!==t[0][0]?[n,...s]:
s}function Hc(t){let e=u("span",{class:"filled"});return e.style.width=`${100*t}%`,[u("span",{class:"track"},e),u("span",{class:"numbers"},t.toFixed(2))]}function jc(t){
let e=Array.from(t,r=>{let n=u("span",{title:r.toFixed(2)});return n.style.transform=`scaleY(${r})`,n});return u("div",{class:"units",role:"img","aria-label":Qa},
...e)}function ei(t){let e=JSON.stringify(t,(r,n)=>r==="genome"?Array.from(n):n);return u("script",{type:"application/json",id:"champions"},e.replaceAll("<","\\u003c")).
outerHTML}var Bt="_",Gc="n",uh=2n**64n-1n;var ns={fov:11,maxSteps:500,rewards:"paper"},Vc=["rules","others","rewards","size","diagonal","fov","limit","seed","ended","walls","pursuers","evaders","played",
"next"];function ni(t,e){let r=i=>i.map(l=>Yc(l,e)).join(""),n=i=>`${Math.floor(i/t.cols)}.${i%t.cols}`,s=qc(t.rewards,e),o=[t.seed,t.episode,t.steps].join("."),a={rules:ri(
t.rules,e),others:t.others?ri(t.others,e):"",rewards:s===ns.rewards?"":s,size:`${t.rows}x${t.cols}`,diagonal:t.diagonal?"1":"",fov:t.fov===ns.fov?"":String(t.fov),
limit:t.maxSteps===ns.maxSteps?"":String(t.maxSteps),seed:o==="0.0.0"?"":o,ended:t.ended?"1":"",walls:t.walls.map(n).join(Bt),pursuers:t.pursuers.map(ti).join(Bt),
evaders:t.evaders.map(ti).join(Bt),played:t.played.map(r).join(Bt),next:t.next.every(i=>i===Ha)?"":r(t.next)};return Vc.filter(i=>a[i]).map(i=>`${i}=${a[i]}`).join(
"&")}function ti({cell:t,gone:e,captured:r,everCaptured:n}){let s=r?"c":n?"e":"";return`${t[0]}.${t[1]}${s}${e?"x":""}`}function ri(t,e){let r=e.fields.map(({name:n})=>String(
t[n]).toLowerCase());return ja(t,e.variants)??r.join(".")}function qc(t,e){let r=JSON.stringify(t);return Object.keys(e.rewards).find(s=>JSON.stringify(e.rewards[s])===
r)??Object.values(t).map(s=>String(s)).join(Bt)}function Yc(t,e){if(typeof t=="number")return String(t);if(t===Ba)return Gc;let r=e.scripts.findIndex(({name:n})=>n===
t);return String.fromCharCode(97+r)}var Kc="/* the engine */";function si(t,e){return u("button",{type:"button",class:"to-playground",title:"Open this step in the playground (G): the same agents a\
nd actions under any rules",onclick:()=>Jc(t(),e)},"What if?")}function Jc(t,e){let r=t!==null&&t.match.n_agents<=rs&&Math.max(t.match.config.rows,t.match.config.
cols)<=ts,n=r?ni(Zc(t.match,t.step),e):"",s=new TextDecoder().decode(En("playground")).replace(Kc,()=>Se("script-engine")).replace("</noscript>",o=>r?o+ei(t.champions):
o);window.open(`${URL.createObjectURL(new Blob([s],{type:"text/html"}))}#${n}`)}function Zc(t,e){let{config:r,n_agents:n}=t,s=Math.max(0,e-1),o=i=>{let l=s*n+i,
c=s*r.n_evaders+i-r.n_pursuers,d=m=>i>=r.n_pursuers&&!!m[c];return{cell:[t.last_positions[2*l],t.last_positions[2*l+1]],gone:!t.alive[l],captured:d(t.captured),
everCaptured:d(t.ever_captured)}},a=Array.from({length:n},(i,l)=>o(l));return{rules:r.rules,others:null,rewards:r.rewards,rows:r.rows,cols:r.cols,diagonal:r.diagonal,
fov:r.fov,maxSteps:r.max_steps,seed:t.seed,episode:BigInt(t.episode),steps:s,ended:s===t.length,walls:Array.from(t.map.keys()).filter(i=>t.map[i]),pursuers:a.slice(
0,r.n_pursuers),evaders:a.slice(r.n_pursuers),played:[],next:Array.from(t.actions.subarray(s*n,(s+1)*n))}}var ss=.005,ai=.05,Xc=["pursuer","evader"],Qc=4,ct=new Map;function Wr(t,e,r="capture-rate"){let n=JSON.stringify([{...e,rewards:null},r]),s=ct.get(n)??(Xt(e)?Promise.
resolve(null):eu(t,e,r));return ct.delete(n),ct.set(n,s),ct.size>Qc&&ct.delete([...ct.keys()][0]),s}var ii=({n_evaders:t})=>t===1?"capture-time":"capture-rate",
oi=()=>new Promise(t=>setTimeout(t));async function eu(t,e,r){await oi();let n=t.solution(e,r);for(;n.goBack();)await oi();return n}function zr(t,e,r){let{payoff:n}=t;
return r.flatMap((s,o)=>{let a=[0,0];for(let l=e.n_turns;l>0&&!e.over;l--)t.game(e)?.lost(s).forEach((c,d)=>a[d]+=c),e.playTurn(s);let i=n==="capture-rate"?ss:ai;
return Xc.map((l,c)=>({step:o+1,team:l,lost:a[c],payoff:n})).filter(l=>l.lost>=i)})}var Br=t=>t.map(e=>({step:e.step,kind:e.team,size:e.lost/Math.max(1,...t.map(
({lost:r})=>r)),text:Ht(e)})),li=({lost:t,payoff:e})=>e==="capture-rate"?`${t.toFixed(2)} of the capture rate`:`${t.toFixed(1)} steps`,Ht=t=>`The ${t.team}s los\
e ${li(t)} against a perfect opponent`;function ci(t){let e=t.reduce((r,n)=>n.lost>r.lost?n:r);return`Your team's worst moves, in step ${e.step}, lost ${li(e)} \
against a perfect opponent.`}function ui({config:t,payoff:e},{value:r},n){if(e==="capture-rate")return`value ${r.toFixed(2)}`;let[s,o]=[1-r,Math.min(t.max_steps-
n,un)];return s>o-ai?`free for ${o} steps`:`captured after ${s.toFixed(1)} steps`}function di(t,e){return(t.marginal(e)??[]).map((n,s)=>({share:n,action:s})).filter(
({share:n})=>n>=ss).sort((n,s)=>s.share-n.share).map(({share:n,action:s})=>n>1-ss?ce[s]:`${ce[s]} ${n.toFixed(2)}`).join(", ")}function Hr(t,e,r){if(r===0)return[{kind:"start",text:tu(t),agents:[]}];let[n,s]=[e.moments[r-1],e.moments[r]],o=d=>Y(d,t.config.n_pursuers),a=$t(e,n,s),i=t.conflicts(
r),l=new Set(i.flatMap(d=>d.doomed)),c=a.map(d=>({kind:"capture",text:`${o(d)} is captured`,agents:[d]}));for(let d of vr(n,s))!a.includes(d)&&!l.has(d)&&c.push(
{kind:"end",text:`${o(d)} disappears`,agents:[d]});return c.push(...i.map(({kind:d,text:m,agents:p})=>({kind:d,text:m,agents:p}))),r===t.length&&c.unshift({kind:"\
end",text:ru(t),agents:[]}),c}function tu({config:t}){return`${t.n_pursuers} pursuers and ${t.n_evaders} evaders on ${t.rows} x ${t.cols} cells, at most ${t.max_steps}\
 steps`}function ru(t){let e=Math.round(t.statistics.capture_rate*t.config.n_evaders);return`The episode ends after ${t.length} steps with ${e} of ${t.config.n_evaders}\
 evaders captured`}var nu=60,ut=class{element;player=new ue(0,{speed:Ar,still:oe()});inspector;match=null;recording=null;actions;#e;#t;#r;#n;#o=u("h2",{class:"match-title"});#s=u(
"p",{class:"tally numbers"});#c=u("ol",{class:"words",tabindex:0,"aria-live":"off","aria-label":"What happened in this step"});#p=u("p",{class:"problem",role:"a\
lert"});#a=null;#m=null;#u=0;#l=!1;#h=0;#d=[];constructor(e,r,n){[this.#t,this.#r]=[e,r];let s=u("canvas",{"aria-label":"The match",onclick:({clientX:o,clientY:a})=>this.
inspector.choose(this.#e.agentAt(o,a))});this.#e=new ke(s,{numbers:!1}),this.#n=new Dr(r),this.inspector=new Ur(o=>this.#S(o)),this.actions=u("div",{class:"besi\
de"},u("button",{type:"button",class:"to-play",title:"Move the chosen agent, or an evader, yourself from this step on (T)",onclick:()=>this.element.dispatchEvent(
new Event("takeover"))},"Take over"),n&&si(()=>this.shown,n)),this.element=u("section",{class:"card match-card","aria-label":"Match",id:"match"},u("div",{class:"\
match"},u("header",{class:"match-head"},this.#o,this.#s),this.#p,u("div",{class:"stage"},s),u("div",{class:"aside"},this.#c,Nr(),this.actions,this.inspector.element),
Ce(this.player),this.#n.element)),this.player.addEventListener("frame",()=>this.recording&&this.#e.show(this.recording,this.player.time)),this.player.addEventListener(
"step",()=>this.#w()),r.on("match",()=>this.#f()),this.#b(),this.#x(0,0)}get#i(){return this.#t[this.#r.selected.run]}reveal(){this.#e.canvas.scrollIntoView({block:"\
nearest"})}get shown(){return this.match&&this.#m&&{match:this.match,step:this.player.step,champions:this.#m}}start(e){this.#a=e,this.#g()}playSoon(){this.#l=!0,
this.#u||this.#v()}goTo(e){this.#h=e,!this.#u&&this.match&&this.#g()}#v(){!this.#l||!this.match||(this.#l=!1,this.player.jump(0),oe()||this.player.play())}#f(){
this.#b(),clearTimeout(this.#u),this.#u=setTimeout(()=>this.#g(),nu)}#g(){clearTimeout(this.#u),this.#u=0,this.player.pause(),this.#b();let{selected:e}=this.#r,
r=Ke.map(o=>nr(this.#i,o,e[o])).find(Boolean)??"";if(this.#p.textContent=r,r||!this.#a)return;this.match=sr(this.#a,this.#i,e);let[n,s]=this.names(e);this.#m={pursuer:{
name:n,policy:te(this.#i,"pursuer",e.pursuer)},evader:{name:s,policy:te(this.#i,"evader",e.evader)}},this.recording=Ir(this.match),this.#n.show(this.#i,this.match),
this.inspector.show(this.#a,this.#i,this.match,e),this.player.length=this.match.length,this.player.marks=yr(this.recording),this.#d=this.player.ticks=[],this.player.
jump(this.#h),this.#h=0,this.#w(),this.#y(this.#a,this.match),this.element.dataset.played=`${e.run} ${e.pursuer} ${e.evader} ${e.episode} ${e.seed??""}`,this.#v()}async#y(e,r){
let n=await Wr(e,r.config);if(this.match!==r||!n)return;let s=e.world(r.config);r.seek(s,0),this.#d=zr(n,s,su(r)),s.free(),this.player.ticks=Br(this.#d),this.inspector.
solution=n,this.#w()}names({run:e,pursuer:r,evader:n}){let{teams:s}=this.#t[e];return[s.pursuer.script??se("pursuer",r),s.evader.script??se("evader",n)]}#b(){let{
episode:e,seed:r}=this.#r.selected,{payoff:n}=this.#i,[s,o]=this.names(this.#r.selected),a=r===null?e<n.episodes?`episode ${e+1} of ${n.episodes}`:`episode ${e+
1}, not part of the cell`:`seed ${r}`;this.#o.replaceChildren(u("span",{class:"pursuer"},de(s))," against ",u("span",{class:"evader"},o),u("span",{class:"muted \
small"},a))}#w(){let e=this.match;if(!e||!this.recording)return;let r=this.player.step,n=this.recording.moments[r];this.#x(Array.from(n.everCaptured).filter(Boolean).
length,r),this.#c.replaceChildren(...this.#d.filter(s=>s.step===r).map(s=>u("li",{class:`loss-${s.team}`},Ht(s))),...Hr(e,this.recording,r).map(s=>u("li",{class:s.
kind,"data-agents":s.agents.join(" ")},s.text))),this.inspector.at(r),this.#A()}#x(e,r){this.#s.replaceChildren(u("strong",{},e),` of ${this.#i.world.n_evaders}\
 captured`,u("span",{class:"muted"},` · step ${r}`))}#S(e){this.#e.look={selected:e,viewers:e===null?[]:[e]},this.#A()}#A(){let e=this.inspector.agent;for(let r of this.#c.
children){let n=r.dataset.agents?.split(" ")??[];r.classList.toggle("about",e!==null&&n.includes(String(e)))}}},su=({actions:t,length:e,n_agents:r})=>Array.from(
{length:e},(n,s)=>t.subarray(s*r,(s+1)*r));var ou={ArrowUp:[1,0],ArrowDown:[-1,0],ArrowRight:[0,1],ArrowLeft:[0,-1]},au=5;function pi(t,e,r,n="pursuer"){t.tabIndex=0,t.setAttribute("role","application"),
t.addEventListener("keydown",s=>{let o=ou[s.key];if(!o)return;let[a,i]=n==="pursuer"?o:[o[1],o[0]],[l,c]=r(),d=s.shiftKey?au:1,{pursuer:m,evader:p}=e.selected;e.
select({pursuer:mi(m+d*a,l),evader:mi(p+d*i,c)}),s.preventDefault(),s.stopPropagation()})}var mi=(t,e)=>Math.min(e-1,Math.max(0,t));var iu=24,jr=7,fi=t=>t<iu&&matchMedia("(pointer: coarse)").matches;function gi(t,e,r,n){let[s,o]=t.payoff.shape,[a,i]=[hi(e,s),hi(r,o)],[l,c]=[Math.min(jr,s),Math.
min(jr,o)],d=[];for(let g=a+l-1;g>=a;g--){d.push(u("span",{class:"pursuer"},g));for(let y=i;y<i+c;y++)d.push(lu(t,g,y,n))}let m=Array.from({length:c},(g,y)=>u("\
span",{class:"evader"},i+y)),p=u("button",{type:"button","aria-label":"Close: all cells",onclick:()=>n(null)},"✕"),f=u("div",{class:"loupe numbers",role:"grou\
p","aria-label":"Cells around the tap",onclick:g=>g.stopPropagation()},...d,p,...m);return f.style.gridTemplateColumns=`2.4rem repeat(${c}, minmax(0, 1fr))`,f}function lu(t,e,r,n){
let s=u("button",{type:"button",onclick:()=>n({pursuer:e,evader:r})});return Cr(s,Je(t,e,r)?.rate,`${se("pursuer",e)} against ${se("evader",r)}`),s}var hi=(t,e)=>Math.
max(0,Math.min(e-jr,t-Math.floor(jr/2)));var re={left:52,bottom:46,top:76,right:84},ge=10,cu=160,jt=re.right-ge-14,We=re.top-ge-14,dt=class{element;#e;#t;#r=u("canvas",{"aria-hidden":"true"});#n=b("svg",
{"aria-hidden":"true"});#o=b("g");#s;#c=u("h2");#p=u("strong",{class:"rate numbers"});#a=u("span",{class:"small muted"});#m=u("p",{class:"of-both-teams small mu\
ted numbers"});#u=null;constructor(e,r){[this.#t,this.#e]=[e,r],this.#s=u("div",{class:"matrix",id:"matrix","aria-label":"Payoff matrix. Arrow keys choose a mat\
ch, Enter plays it.",onpointermove:s=>this.#b(s),onpointerleave:()=>r.point({}),onclick:s=>this.#w(s),onkeydown:({key:s})=>s==="Enter"&&this.#S()},this.#r,this.#n);
let n=u("header",{class:"readout","aria-live":"polite"},u("div",{},this.#c,this.#m),u("div",{class:"of-cell"},this.#p,this.#a));this.element=u("section",{class:"\
card matrix-card","aria-label":"Payoff matrix"},n,this.#s,Oe("0 all escape","1 all caught")),this.#f(),new ResizeObserver(()=>this.#h()).observe(this.#s),this.#s.
addEventListener("mousedown",s=>{s.preventDefault(),document.activeElement instanceof HTMLElement&&document.activeElement.blur()}),pi(this.#s,r,()=>this.#l.payoff.
shape),r.on("run",()=>this.#h()),r.on("match hover",()=>this.#v())}get#l(){return this.#t[this.#e.selected.run]}#h(){let[e,r]=this.#l.payoff.shape,{clientWidth:n,
clientHeight:s}=this.#s;if(n<50)return;let a=Math.max(cu,Math.min(n-re.left-re.right,s-re.top-re.bottom))/Math.max(e,r),i=Math.max(re.left,(n-r*a-re.right+re.left)/
2),l=re.top+Math.max(0,(s-re.top-re.bottom-e*a)/2),c={width:n,height:s,left:i,top:l,cell:a,rows:e,columns:r};this.#u=c,ot(this.#r,this.#l.payoff,{left:i,top:l,width:r*
a,height:e*a});for(let[d,m,p]of[["left",i,n],["top",l,s],["width",r*a,n],["height",e*a,s]])this.#r.style.setProperty(d,`${100*m/p}%`);this.#s.style.setProperty(
"--shape",`${n} / ${s}`),this.#n.setAttribute("viewBox",`0 0 ${n} ${s}`),this.#n.replaceChildren(uu(c),...du(c),...this.#i(c),this.#o),this.#v()}#d(e){let r=this.#l.
findings?.generalization;if(!r)return[];let{selected:n,hover:s}=this.#e,[o,a]=[s.pursuer??n.pursuer,s.evader??n.evader],[i,l]=yi(e,r.pursuers.mean[o]??0,o),[c,d]=vi(
e,r.evaders.mean[a]??0,a);return[b("circle",{class:"dot of-pursuers",cx:i,cy:l,r:5}),b("circle",{class:"dot of-evaders",cx:c,cy:d,r:5})]}#i(e){let r=this.#l.findings?.
generalization;if(!r)return[];let{left:n,top:s,cell:o,rows:a,columns:i}=e,[l,c]=[n+i*o+ge,s-ge],d={class:"side"};return[b("rect",{...d,x:l,y:s,width:jt,height:a*
o}),b("rect",{...d,x:n,y:c-We,width:i*o,height:We}),...bi(r.pursuers,(m,p)=>yi(e,m,p),"of-pursuers"),...bi(r.evaders,(m,p)=>vi(e,m,p),"of-evaders"),b("text",{class:"\
tick",x:l,y:s+a*o+16,"text-anchor":"start"},"0"),b("text",{class:"tick",x:l+jt,y:s+a*o+16,"text-anchor":"end"},"1"),b("text",{class:"tick",x:n-6,y:c-4,"text-anc\
hor":"end"},"0"),b("text",{class:"tick",x:n-6,y:c-We+8,"text-anchor":"end"},"1"),b("text",{class:"label of-pursuers",x:l+jt,y:s+a*o+34,"text-anchor":"end"},"cap\
tures"),b("text",{class:"label of-evaders",x:n+i*o+ge,y:c-We+10,"text-anchor":"start"},"escapes")]}#v(){let e=this.#u;if(!e)return;let{selected:r,hover:n}=this.#e,
{left:s,top:o,cell:a,rows:i,columns:l}=e,c=f=>o+(i-1-f)*a,d=[],m=(f,g)=>b("rect",{class:g,x:s,y:c(f),width:l*a+ge+jt,height:a}),p=(f,g)=>b("rect",{class:g,x:s+f*
a,y:o-ge-We,width:a,height:ge+We+i*a});d.push(m(r.pursuer,"strip pursuer"),p(r.evader,"strip evader")),n.pursuer!==null&&n.pursuer<i&&d.push(m(n.pursuer,"strip \
hover")),n.evader!==null&&n.evader<l&&d.push(p(n.evader,"strip hover")),d.push(...this.#d(e));let h={x:s+r.evader*a,y:c(r.pursuer),width:a,height:a};d.push(b("r\
ect",{class:"chosen under",...h}),b("rect",{class:"chosen",...h})),this.#o.replaceChildren(...d),this.#f()}#f(){let{selected:e,hover:r}=this.#e,n=r.pursuer??e.pursuer,
s=r.evader??e.evader,o=Je(this.#l,n,s);this.#c.replaceChildren(u("span",{class:"pursuer"},de(se("pursuer",n)))," against ",u("span",{class:"evader"},se("evader",
s))),this.#p.textContent=o?H(o.rate,3):"-",this.#a.textContent=o?`capture rate, mean of ${o.rates.length} episodes`:"no episodes were played",this.#m.textContent=
this.#g(n,s)}#g(e,r){let n=this.#l.findings?.generalization;if(!n)return"";let s=(o,a)=>ia(o.mean[a]??null,o.low?.[a]??null,o.high?.[a]??null);return`Against al\
l: captures ${s(n.pursuers,e)}, escapes ${s(n.evaders,r)}`}#y(e){let r=this.#u;if(!r)return null;let n=this.#s.getBoundingClientRect(),s=Math.floor((e.clientX-n.
left-r.left)/r.cell),o=r.rows-1-Math.floor((e.clientY-n.top-r.top)/r.cell),[a,i]=[o>=0&&o<r.rows,s>=0&&s<r.columns];return a||i?{g:a?o:-1,h:i?s:-1,inside:a&&i}:
null}#b(e){let r=this.#y(e);this.#e.point(r?{pursuer:r.g<0?null:r.g,evader:r.h<0?null:r.h}:{})}#w(e){let r=this.#y(e);if(r){if(r.inside&&fi(this.#u.cell))return this.#x(
r.g,r.h);this.#e.select({...r.g<0?{}:{pursuer:r.g},...r.h<0?{}:{evader:r.h}}),r.inside&&this.#S()}}#x(e,r){let n=gi(this.#l,e,r,s=>{n.remove(),s&&(this.#e.select(
s),this.#S())});this.#s.append(n)}#S(){this.#s.dispatchEvent(new CustomEvent("play",{bubbles:!0}))}};function uu({left:t,top:e,cell:r,rows:n,columns:s}){let o=b(
"g",{class:"axes"}),a=e+n*r,i=l=>Nt(0,l-1,Math.min(l,l*r/44),!0);for(let l of i(s))o.append(b("text",{class:"tick",x:t+(l+.5)*r,y:a+16,"text-anchor":"middle"},l));
for(let l of i(n))o.append(b("text",{class:"tick",x:t-7,y:a-(l+.5)*r,"text-anchor":"end","dominant-baseline":"middle"},l));return o.append(b("text",{class:"labe\
l of-evaders",x:t+s*r/2,y:a+36,"text-anchor":"middle"},"evader generation"),b("text",{class:"label of-pursuers",transform:`translate(${t-36} ${e+n*r/2}) rotate(\
-90)`,"text-anchor":"middle"},"pursuer generation")),o}function du({left:t,top:e,cell:r,rows:n,columns:s}){let o=b("g",{class:"diagonal"}),a=Math.min(n,s);if(a<
3)return[];let i=e+n*r;for(let d of["H","V"]){let m=`M${t} ${i}`;for(let p=1;p<=a;p++){let[h,f]=[`H${t+p*r}`,`V${i-p*r}`];m+=d==="H"?h+f:f+h}o.append(b("path",{
d:m,class:"under"}),b("path",{d:m}))}let[l,c]=[t+a/2*r-.7*r-4,i-a/2*r-.7*r-4];return[o,b("text",{class:"on-cells",transform:`translate(${l} ${c}) rotate(-45)`,"\
text-anchor":"middle"},"same generation")]}var yi=({left:t,top:e,cell:r,rows:n,columns:s},o,a)=>[t+s*r+ge+o*jt,e+(n-a-.5)*r],vi=({left:t,top:e,cell:r},n,s)=>[t+
(s+.5)*r,e-ge-n*We];function bi(t,e,r){let n=o=>o.map((a,i)=>e(a??0,i).map(l=>l.toFixed(1)).join(" ")),s=[];return t.low&&t.high&&s.push(b("path",{class:`band ${r}`,
d:`M${[...n(t.high),...n(t.low).reverse()].join("L")}Z`})),s.push(b("path",{class:`line ${r}`,d:`M${n(t.mean).join("L")}`})),s}var wi={pursuer:null,evader:null},mt=class extends EventTarget{#e;#t=wi;constructor(e){super(),this.#e=e}get selected(){return this.#e}get hover(){return this.#t}select(e){
let r=this.#e,n=["run","pursuer","evader"].some(s=>s in e&&e[s]!==r[s]);this.#e={...r,...n?{episode:0,seed:null}:{},...e},this.#e.run!==r.run&&this.dispatchEvent(
new Event("run")),this.dispatchEvent(new Event("match"))}point(e){let r={...wi,...e};r.pursuer===this.#t.pursuer&&r.evader===this.#t.evader||(this.#t=r,this.dispatchEvent(
new Event("hover")))}on(e,r){for(let n of e.split(" "))this.addEventListener(n,r)}};var Gr=class{config;start;recording;actions=[];#e;#t;#r=[[]];constructor(e,r,n){[this.config,this.start]=[r,n],this.#e=e.world(r),this.#e.reset(n),this.#t=[es(this.#e)],
this.recording=Qn(r,this.#e.map(),this.#t)}get length(){return this.actions.length}get over(){return this.#e.over}get statistics(){return{capture_rate:this.#e.read(
"capture_rate")[0]}}conflicts(e){return this.#r[e]}game(e){return e.game(this.#e)}play(e){this.#e.step(e),this.#n(e)}step(e,r,n){let[s,o]=[this.#e,this.config.n_pursuers],
a=new Uint8Array(s.n_agents);for(let i=s.n_turns;i>0&&!s.over;--i){let[l,c]=s.actors;l<o&&(a=s.decide(e.pursuer,[l,Math.min(c,o)],a)),c>o&&(a=s.decide(e.evader,
[Math.max(l,o),c],a)),typeof n=="number"?a[r]=n:l<=r&&r<c&&(a=s.decide(n,[r,r+1],a)),s.playTurn(a)}this.#n(a)}#n(e){this.actions.push(e),this.#t.push(es(this.#e,
e)),this.#r.push(this.#e.conflicts())}};var ye=(t,e)=>Ke[+(e>=t.n_pursuers)];function os(t,e){let r=new Gr(t,e.config,{seed:e.seed,episode:e.episode});for(let n of e.moves)r.over||r.step(e.policies,e.
seat,n);return r}function pt(t,e){let{moments:r,nPursuers:n}=t.recording,s=r.findIndex(({alive:a,captured:i})=>!a[e]||!!i[e-n]),o=s<0?t.length:s;return{lasted:o,
out:s>=0,captured:Array.from(r[o].everCaptured).filter(Boolean).length}}var Vr=(t,e)=>t.over||pt(t,e).out;function xi(t,e,r){let n=os(t,{...e,moves:e.moves.slice(
0,e.from)});for(;!Vr(n,e.seat);)n.step(e.policies,e.seat,r);return pt(n,e.seat)}function Si(t){let e=t.length-1;return[...new Set([0,Math.round(e/3),e])].map(r=>t[r])}
function Ai(t,{seat:e,from:r,moves:n}){let s={...t,seat:e,...r?{from:r}:{},moves:n.join("")};return`${location.href.split("#")[0]}#${Object.entries(s).map(([o,a])=>`${o}\
=${a}`).join("&")}`}function Mi(t,e){let[r,n,s]=[t.get("seat")??"",t.get("from")??"0",t.get("moves")??""];return/^\d{1,6}$/.test(r)&&Number(r)<e.n_pursuers+e.n_evaders&&
(e.diagonal?/^[0-8]+$/:/^[0-4]+$/).test(s)&&s.length<=e.max_steps&&/^\d{1,6}$/.test(n)&&Number(n)<=s.length?{seat:Number(r),from:Number(n),moves:[...s].map(Number)}:
null}function as(t,e,r,n,s,o){e.play({title:r,played:n,ending:(a,i)=>[mu(t,a,i,Si(s))],again:()=>as(t,e,r,{...n,moves:n.moves.slice(0,n.from)},s,o),link:a=>o&&Ai(o,a)})}
function mu(t,e,r,n){let s=ye(r.config,r.seat)==="evader",o=s?r.config.max_steps:r.config.n_evaders,a=u("table",{class:"numbers"},u("caption",{},s?"Steps in you\
r seat: same start, same others":"Captures of your team: same start, same others")),i=c=>{let[d,m]=[u("span",{class:s?"bar evader":"bar pursuer"}),u("td",{},"…")];
return a.append(u("tr",{},u("th",{scope:"row"},c),u("td",{class:"track","aria-hidden":"true"},d),m)),({lasted:p,captured:h})=>{d.style.width=`${100*(s?p:h)/o}%`,
m.textContent=String(s?p:h)}};i("You")(pt(e,r.seat));for(let{name:c,policy:d}of n){let m=i(c);setTimeout(()=>m(xi(t,r,d())))}let l=r.from?`You took over at step\
 ${r.from}. `:"";return u("div",{},a,u("p",{class:"small muted"},`${l}One match: luck has its part in it.`))}var Ei=["·","↑","→","↓","←","↗","↘","↙","↖"];var pu={" ":0,ArrowUp:1,w:1,ArrowRight:2,d:2,ArrowDown:3,s:3,ArrowLeft:4,a:4,e:5,c:6,y:7,z:7,q:8},is=[8,1,5,4,0,2,7,3,6],hu=[7,8,9,4,5,6,1,2,3],fu=24,gu=Math.tan(
Math.PI/8);function ki(t,e){if(t.ctrlKey||t.metaKey||t.altKey)return;let r=hu.findIndex(s=>t.code===`Numpad${s}`),n=is[r]??pu[t.key.length===1?t.key.toLowerCase():
t.key];return n!==void 0&&n>4&&!e?void 0:n}function Ci(t){let e=is.map(r=>u("button",{type:"button","aria-label":ce[r],onclick:()=>t(r)},Ei[r]));return{element:u(
"div",{class:"play-pad",role:"group","aria-label":"Your move"},...e),show:r=>e.forEach((n,s)=>n.classList.toggle("absent",is[s]>4&&!r))}}function Ti(t,e,r){let n=gu*
Math.max(Math.abs(t),Math.abs(e)),s=o=>Math.abs(o)<n?0:o;return Mo([0,0],r?[s(t),s(e)]:[t,e],r)}function Oi(t,e,r){let n=null,{canvas:s}=t;s.addEventListener("p\
ointerdown",({button:o,clientX:a,clientY:i})=>n=o===0?[a,i]:null),s.addEventListener("pointercancel",()=>n=null),s.addEventListener("pointerup",({clientX:o,clientY:a})=>{
let[i,l]=[n,e()];if(n=null,!i||!l)return;let[c,d]=[o-i[0],a-i[1]],m=t.cellAt(o,a);Math.hypot(c,d)>=fu?r(Ti(d,c,l.diagonal)):m&&r(Ti(m[0]-l.cell[0],m[1]-l.cell[1],
l.diagonal))})}function Ri(t,e){let r=n=>{let s=e[n]-t[n],o=tt.findIndex(a=>a[n]===Math.sign(s)&&a[1-n]===0);return s?`${Math.abs(s)} ${ce[o]}`:""};return[r(0),
r(1)].filter(Boolean).join(", ")||"on your cell"}var Pi="NUMPY\0",$i=Pi.length+2,_i=64;function Li(t){return Zs(Object.fromEntries(Object.entries(t).map(([e,r])=>[`${e}.npy`,yu(r)])))}function yu({dtype:t,shape:e,
data:r}){let n=typeof r=="string"?Array.from(r,d=>d.codePointAt(0)):null,s=e.map(d=>`${d}, `).join(""),o=`{'descr': '${n?`<U${n.length}`:t}', 'fortran_order': F\
alse, 'shape': (${s}), }`,a=Math.ceil(($i+o.length+1)/_i)*_i-$i,i=Pi+String.fromCharCode(a&255,a>>8)+o.padEnd(a-1)+`
`,l=n?Int32Array.from(n):r,c=new Uint8Array(i.length+l.byteLength);return c.set(er(i,!0)),c.set(new Uint8Array(l.buffer,l.byteOffset,l.byteLength),i.length),c}var vu="matrixworld episode 3";function Ni(t,e,r){let{config:n,actions:s,length:o,recording:a}=e,[i,l]=[n.n_pursuers+n.n_evaders,n.n_evaders],c={positions:["<i4",
i,2],last_positions:["<i4",i,2],alive:["|b1",i],captured:["|b1",l],ever_captured:["|b1",l]},d={rewards:["<f4",i],involved:["|b1",i,3],fault:["|b1",i,3]},m={},p=w=>{
for(let S of Object.keys(w))(m[S]??=[]).push(Array.from(h.read(S),Number))},h=t.world(n);h.reset(e.start);let f=[];p(c);for(let w of s)h.step(w),p({...c,...d}),
f.push(...h.conflictTable());h.free();let g={"<i4":Int32Array,"<f4":Float32Array,"|b1":Uint8Array},y={};for(let[w,[S,...A]]of Object.entries({...c,...d})){let k=o+
+(w in c);y[w]={dtype:S,shape:[k,...A],data:g[S].from((m[w]??[]).flat())}}let x=w=>({dtype:"<i8",shape:[],data:Int32Array.of(w,0)}),v=w=>({dtype:"<U",shape:[],data:w});
return Li({format:v(vu),n_pursuers:x(n.n_pursuers),config:v(JSON.stringify(n)),seat:x(r),...y,actions:{dtype:"|i1",shape:[o,i],data:Int8Array.from(s.flatMap(w=>[
...w]))},map:{dtype:"|b1",shape:[n.rows,n.cols],data:Uint8Array.from(a.obstacles,Number)},conflict_table:{dtype:"<i4",shape:[f.length/11,11],data:Int32Array.from(
f)}})}var bu=[0,1,2,4,8],qr=class{element;player=new ue(0,{speed:4,still:oe()});#e;#t;#r=u("canvas",{tabindex:0,"aria-describedby":"play-keys"});#n=u("h2");#o=u("p",{
class:"play-told",role:"status"});#s=Ci(e=>this.act(e));#c=dr(bu.map(e=>[e,e?`${e} / s`:"step by step"]),()=>this.#T());#p=u("input",{type:"checkbox",onchange:()=>this.#S()});#a=u(
"input",{type:"checkbox",onchange:()=>this.#k()});#m=u("label",{class:"play-choice"},this.#a,"Best move");#u=u("p",{class:"small muted play-keys",id:"play-keys"});#l=u(
"section",{class:"play-ending",tabindex:-1,"aria-labelledby":"play-headline"});#h=Ce(this.player);#d=null;#i=null;#v=[];#f=null;#g=null;#y=[];#b=0;#w=0;constructor(e){
this.#e=e,this.#t=new ke(this.#r,{numbers:!1}),this.#r.setAttribute("role","application"),Oi(this.#t,()=>{let r=this.#f!==null&&this.#i&&R(this.#i.recording.moments.
at(-1),this.#f);return r?{cell:r,diagonal:this.#i.config.diagonal}:null},r=>this.act(r)),this.player.addEventListener("frame",()=>this.#i&&this.#t.show(this.#i.
recording,this.player.time)),this.player.addEventListener("step",()=>this.#k()),this.element=u("div",{class:"play"},u("header",{class:"play-head"},this.#n,this.#o),
u("div",{class:"play-stage"},this.#r),u("div",{class:"play-side"},this.#l,this.#s.element,u("label",{class:"play-choice",title:"Steps a second"},"Pace ",this.#c),
u("label",{class:"play-choice"},this.#p,u("span",{},"Fog",u("span",{class:"at-length"},": see only what it sees"))),this.#m,this.#u),this.#h)}get played(){return this.#d&&
{...this.#d.played,moves:this.#v}}get live(){return this.#i}play(e){this.#x(os(this.#e,e.played),e.played.seat,e.title),[this.#d,this.#v,this.#b]=[e,[...e.played.
moves],0],this.element.dataset.state="playing",this.#r.focus({preventScroll:!0}),Vr(this.#i,e.played.seat)&&this.#R()}watch(e,r,n){this.#d=null,this.#x(e,r,n),this.#$()}stop(){
this.#T(),this.player.pause(),this.#d=null}act(e){let[r,n]=[this.#d,this.#i];if(!r||!n||this.element.dataset.state!=="playing")return;this.#b=e;let s=Number(this.#c.
value);this.#w||(this.#O(),s&&this.element.dataset.state==="playing"&&(this.#w=setInterval(()=>this.#O(),1e3/s)))}key(e){let{target:r,key:n}=e;if(r instanceof HTMLSelectElement||
r instanceof HTMLInputElement&&(r.type==="text"||n===" ")||r instanceof HTMLButtonElement&&(n===" "||n==="Enter")||!this.#i)return!1;if(this.element.dataset.state!==
"playing")return Er(this.player,e);let o=ki(e,this.#i.config.diagonal);return o!==void 0&&this.act(o),o!==void 0}#x(e,r,n){this.#T(),this.player.pause(),[this.#i,
this.#f]=[e,r],this.#n.textContent=n,this.#r.ariaLabel=`Board, ${e.config.rows} by ${e.config.cols} cells`,this.#s.show(e.config.diagonal),this.#u.replaceChildren(
u("span",{class:"at-length"},`W A S D or the arrow keys move, Space stays${e.config.diagonal?"; Q E Z C and the numeric keypad move diagonally":""}. `),"On the \
board: swipe, or tap where to go."),this.#A(e),this.#l.replaceChildren(),this.player.length=e.length,this.player.jump(e.length),this.#k()}#S(){this.#t.look={you:this.#f,
fog:this.#p.checked,viewers:this.#f===null?[]:[this.#f],plan:this.#C()}}#A(e){this.#g=null,this.#y=this.player.ticks=[],this.#m.hidden=this.#a.disabled=!!Xt(e.config),
Wr(this.#e,e.config,ii(e.config)).then(r=>{this.#i===e&&(this.#g=r,this.#E(),this.#k())})}#E(){let[e,r]=[this.#i,this.#g];if(!r||this.element.dataset.state==="p\
laying")return;let n=this.#e.world(e.config);n.reset(e.start),this.#y=zr(r,n,e.actions),n.free(),this.player.ticks=Br(this.#y)}get#M(){return this.#a.checked&&this.#d&&
this.element.dataset.state==="playing"&&this.#g&&this.#i.game(this.#g)||null}#C(){let[e,r]=[this.#f,this.#f!==null&&this.#M?.marginal(this.#f)];return e!==null&&
r?Object.assign(Array(e).fill(0),{[e]:r.indexOf(Math.max(...r))}):null}#T(){clearInterval(this.#w),this.#w=0,this.#o.ariaLive=Number(this.#c.value)?"off":"polit\
e"}#O(){let[{policies:e,seat:r},n]=[this.#d.played,this.#i];n.step(e,r,this.#b),this.#v.push(this.#b),this.player.length=n.length,this.player.glide=Math.min(.22,
.9/(Number(this.#c.value)||4)),this.player.move(n.length-this.player.step),Vr(n,r)&&this.#R()}#R(){this.#T();let[e,r,n]=[this.#d,this.#i,this.played],s=bo()?e.link(
n):null,o=`${Y(n.seat,r.config.n_pursuers)}-${r.length}-steps.npz`,a=()=>et(o,Ni(this.#e,r,n.seat));this.#l.replaceChildren(u("h3",{id:"play-headline"},Su(r,n.seat)),
...e.ending(r,n),u("div",{class:"play-buttons"},u("button",{type:"button",class:"primary",onclick:()=>e.again()},"Again"),u("button",{type:"button",onclick:()=>this.#$()},
"Watch it"),u("button",{type:"button",onclick:a},"Save"),s&&u("button",{type:"button",onclick:({currentTarget:l})=>Mu(l,s)},"Link"))),this.element.dataset.state=
"ended",this.#E();let i=this.#y.filter(({team:l})=>l===ye(r.config,n.seat));i.length&&this.#l.children[0].after(u("p",{class:"small muted"},ci(i))),this.#l.focus(
{preventScroll:!0}),this.#l.scrollIntoView({block:"nearest"})}#$(){this.element.dataset.state="watched",this.player.length=this.#i.length,this.player.jump(0),oe()||
this.player.play()}#k(){let[e,r,{step:n}]=[this.#i,this.#f,this.player];if(!e||n>e.length)return;let s=Hr(e,e.recording,n).filter(({agents:l})=>r===null||l.includes(
r)),o=this.#d&&n===0,a=o?[wu(e.config,r),this.#d.about??""]:[`Step ${n} of ${e.config.max_steps}`,...s.map(({text:l})=>l)];!o&&r!==null&&a.push(xu(e,n,r)),a.push(
...this.#y.filter(l=>l.step===n).map(Ht));let i=n===e.length&&r!==null?this.#M:null;i&&a.push(`Perfect play: ${di(i,r)||"decided in its turn"}; ${ui(this.#g,i,n)}`),
this.#S(),this.#o.textContent=a.filter(Boolean).map(l=>`${l}.`).join(" ")}};function wu(t,e){let r=t.rules.capture==="SURROUND";return ye(t,e)==="evader"?`Run a\
way: you win if ${r?"the pursuers do not surround you":"no pursuer reaches your cell"} in ${t.max_steps} steps`:`Capture evaders: ${r?"surround them with your t\
eam":"move onto their cells"}`}function xu({config:t,recording:e},r,n){let s=e.moments[r],a=ye(t,n)==="pursuer"?"evader":"pursuer";if(!s.alive[n])return"";let i=R(
s,n),l=m=>{let[p,h]=R(s,m);return Math.max(Math.abs(p-i[0]),Math.abs(h-i[1]))},c=Array.from({length:s.alive.length},(m,p)=>p).filter(m=>ye(t,m)===a&&s.alive[m]&&
!s.captured[m-t.n_pursuers]&&2*l(m)<t.fov);if(!c.length)return`No ${a} in view`;let d=c.reduce((m,p)=>l(p)<l(m)?p:m);return`Nearest ${a}: ${Ri(i,R(s,d))}`}function Su(t,e){
let[{lasted:r,out:n,captured:s},{config:o}]=[pt(t,e),t];return ye(o,e)==="pursuer"?`Your team captured ${s} of ${Au(o)} in ${r} steps.`:n?`You lasted ${r} of ${o.
max_steps} steps.`:`You escaped: ${r} steps.`}var Au=({n_evaders:t})=>`${t} evader${t===1?"":"s"}`;function Mu(t,e){let r=wo("Link to this match");r.value=e,t.replaceWith(
r),r.select(),navigator.clipboard?.writeText(e).catch(()=>{})}var Eu=2n**64n-1n;function Ii(t,e,r){let n=new URLSearchParams(t.replace(/^#/,"")),s=(c,d,m)=>{let p=n.get(c)??"";return/^\d{1,9}$/.test(p)&&Number(p)<d?Number(
p):m},o=s("run",e.length,r.run),[a,i]=e[o].payoff.shape,l=n.get("seed")??"";return{run:o,pursuer:s("pursuers",a,Math.min(r.pursuer,a-1)),evader:s("evaders",i,Math.
min(r.evader,i-1)),episode:s("episode",1/0,r.episode),seed:/^\d{1,20}$/.test(l)&&BigInt(l)<=Eu?l:null,step:s("step",1/0,0)}}var Yr=class{dialog=u("dialog",{class:"take-over","aria-label":"Play an agent",onclose:()=>this.view?.stop(),onkeydown:e=>this.view?.key(e)&&e.preventDefault()});view=null;#e;#t;#r;#n;#o=null;constructor(e,r,n,s=!0){
[this.#e,this.#t,this.#r,this.#n]=[e,r,n,s],n.element.addEventListener("takeover",()=>this.open())}start(e,r=""){this.#o=e;let n=Ii(r,this.#e,this.#t.selected),
s=Mi(new URLSearchParams(r.replace(/^#/,"")),this.#e[n.run].world);s&&this.play(n,s)}open(){let e=this.#r.shown;if(!e)return;let{match:r,step:n}=e;this.#r.player.
pause();let s=this.#r.inspector.agent,o=n<r.length?n:0,a=(m,p)=>!!r.alive[p*r.n_agents+m],i=Array.from({length:r.n_agents},(m,p)=>(p+r.config.n_pursuers)%r.n_agents),
l=s??i.find(m=>a(m,o)),c=a(l,o)?o:0,d=Array.from({length:c},(m,p)=>r.actions[p*r.n_agents+l]);this.play(this.#t.selected,{seat:l,from:c,moves:d})}play(e,r){let[
n,s]=[this.#o,this.#e[e.run]];if(!n||Ke.some(y=>nr(s,y,e[y])))return;let{run:o,pursuer:a,evader:i,episode:l,seed:c}=e,d=ye(s.world,r.seat),m=s.teams[d].kept.map(
y=>({name:s.teams[d].script??`generation ${y}`,text:"",policy:()=>te(s,d,y)}));this.view||(this.view=new qr(n),this.dialog.append(u("button",{type:"button",class:"\
leave",onclick:()=>this.dialog.close()},"Close"),this.view.element)),this.dialog.open||this.dialog.showModal();let p=`You are ${Y(r.seat,s.world.n_pursuers)}: ${this.#r.
names(e).join(" against ")}`,h={pursuer:te(s,"pursuer",a),evader:te(s,"evader",i)},f={config:s.world,seed:BigInt(c??s.seeds[a][i]),episode:l,policies:h,...r},g={
run:o,pursuers:a,evaders:i,episode:l,...c===null?{}:{seed:c}};as(n,this.view,p,f,m,this.#n?g:null)}};var ls=t=>Array.from({length:t},()=>Array(t)),Kr=class{learning=L;settings=[];training={capture_rate:[],generation:[],learner:[],epochs:1,window:1,matches:0};limits="";name;schedule;seed;seeds;world;payoff;teams;findings=null;genomes={
pursuer:[],evader:[]};#e;#t;#r;constructor(e,r,n,s){[this.#r,this.#e,this.#t,this.name,this.schedule]=[e,r,s,n,n],[this.world,this.seed]=[e.world,String(e.seed)];
let o=e.schedule.generations+1;this.seeds=Array.from({length:o},(a,i)=>Array.from({length:o},(l,c)=>String(or(e.seed,i,c)))),this.payoff=this.#n(),this.teams=this.#o()}get newest(){
return this.genomes.pursuer.length-1}#n(){let e=this.#r.schedule.generations+1;return{first:[0,0],shape:[e,e],episodes:this.#r.evaluation_episodes,capture_rate:ls(
e),capture_rates:ls(e),lengths:ls(e)}}#o(){let e=r=>{let n=`${this.#t} ${r}`;Xs(n,lr(this.genomes[r]));let{genome:s,...o}=Ot(ur(this.#r,this.#e,r),this.genomes[r][0]??
new Float32Array(0));return{script:null,network:{...o,genome_size:s.length},kept:[...this.genomes[r].keys()],genomes:n}};return{pursuer:e("pursuer"),evader:e("e\
vader")}}policy(e,r){return Ot(ur(this.#r,this.#e,e),this.genomes[e][r])}add(e){for(let r of L)this.genomes[r].push(e[r]);this.teams=this.#o()}change(e,r){this.#r=
e,this.world=e.world;for(let n of L)this.genomes[n]=[...r[n]];[this.payoff,this.teams,this.findings]=[this.#n(),this.#o(),null]}addCell({pursuer:e,evader:r,capture_rates:n,
lengths:s}){this.payoff.capture_rate[e][r]=B(n),this.payoff.capture_rates[e][r]=[...n],this.payoff.lengths[e][r]=[...s],this.findings={generalization:this.#s()}}#s(){
let e=this.payoff.capture_rate,r=o=>({mean:o,low:null,high:null}),n=o=>{let a=o.filter(i=>i!==void 0);return a.length?B(a):null},s=[...this.genomes.pursuer.keys()];
return{pursuers:r(s.map(o=>n(e[o]))),evaders:r(s.map(o=>n(e.map(a=>a[o]===void 0?void 0:1-a[o]))))}}};var Gt=t=>`${Math.round(100*t)} %`,Tu=100,ku=0,Jr=class extends EventTarget{element;newest;beginning;settings;state="waiting";done=0;seconds=0;#e;#t;#r;#n=u("h2",
{class:"lane-title"});#o=u("p",{class:"facts numbers"});#s=u("div",{class:"lane-room",hidden:!0});#c=u("section",{class:"card measures",hidden:!0});#p=u("div");#a;#m={
pursuer:[],evader:[]};#u=new Map;#l;#h;#d=()=>{};#i=0;#v=!0;#f=0;#g=null;constructor(e,r,n,s){super(),[this.#e,this.#t,this.#r,this.settings]=[e,r,n,s],this.newest=
new Ue(()=>this.#A(this.#a.newest)),this.beginning=new Ue(()=>this.#A(0)),this.beginning.element.classList.add("beginning");let o=u("div",{class:"boards"},this.
newest.element,this.beginning.element);this.element=u("section",{class:"lane"},this.#n,this.#o,o,this.#s,this.#c,this.#p),n.onmessage=({data:a})=>this.#b(a),this.
reset(s)}reset(e){this.#y({type:"stop"}),[this.settings,this.state,this.done]=[e,"waiting",0],this.#S();let{archive:r}=new Qe(this.#t,e,this.#e.masks);this.#a.add(
{pursuer:r.pursuer[0],evader:r.evader[0]}),this.#s.hidden=this.#c.hidden=!0,this.#E(!0),this.#M()}start(){this.#S(),[this.state,this.done]=["evolving",0],this.#s.
hidden=!1,this.#c.hidden=!0,this.#y({type:"start",settings:this.settings,masks:this.#e.masks}),this.#M()}stop(){this.#y({type:"stop"}),this.state==="evolving"&&
(this.state="stopped"),this.#M()}change(e){if(this.state==="waiting")return this.reset(e);this.settings=e,this.#y({type:"change",settings:e}),this.#M()}takeOver(){
let e=this.#a.newest;this.#h.play({run:0,pursuer:e,evader:e,episode:0,seed:null},{seat:this.#a.world.n_pursuers,from:0,moves:[]})}saved(){return new Promise(e=>{
this.#g=e,this.#y({type:"save"})})}get newestGeneration(){return this.#a.newest}close(){this.#r.terminate(),this.newest.runs=this.beginning.runs=!1}#y(e){this.#r.
postMessage(e)}#b(e){if(e.type==="generation"){if(this.state!=="evolving")return;this.#a.add(e.genomes),this.#E(e.number===0)}else if(e.type==="cell"){let{pursuer:r,
evader:n}=e.cell;this.#a.addCell(e.cell),this.#v&&r===n&&r===this.#a.newest&&this.#l.select({pursuer:r,evader:n}),this.#u.set(`${r} ${n}`,e.cell)}else if(e.type===
"scores")for(let r of L)this.#m[r][e.number]=e.scores[r];else e.type==="anew"?(this.#a.change(e.settings,e.genomes),this.#x(),this.#E(!0)):e.type==="epoch"?this.
done=e.done/e.of:e.type==="end"?(this.state==="evolving"&&([this.state,this.seconds,this.done]=["ended",e.seconds,1]),this.#C()):e.type==="saved"?this.#g?.(e.race):
(this.#o.textContent=`The race failed: ${e.message}`,this.state="stopped");this.#f||(this.#f=setTimeout(()=>requestAnimationFrame(()=>this.#w()),Tu))}#w(){this.#f=
0,this.#l.dispatchEvent(new Event("run")),this.#d(),this.#M()}#x(){this.#u=new Map,this.#m={pursuer:[],evader:[]},this.#c.hidden=!0}#S(){let e=`race ${ku++}`,r=Fr(
this.settings);this.#a=new Kr(this.settings,this.#e.masks,r,e),this.#x(),this.#v=!0,this.#l=new mt({run:0,pursuer:0,evader:0,episode:0,seed:null});let[n,s]=[new dt(
[this.#a],this.#l),new ut([this.#a],this.#l,null)];n.element.ariaLabel=`Payoff matrix. ${r}`,this.#h=new Yr([this.#a],this.#l,s,!1),this.#h.start(this.#t);let o=u(
"dialog",{class:"of-cell-match","aria-label":"Match",onclose:()=>s.player.pause()},u("button",{type:"button",class:"leave",onclick:()=>o.close()},"Close"),s.element),
a=!1;n.element.addEventListener("play",()=>{let{pursuer:l,evader:c}=this.#l.selected;this.#v=!1,this.#a.payoff.capture_rate[l][c]!==void 0&&(o.showModal(),a||s.
start(this.#t),a=!0,s.playSoon())});let i=he(`Scores against scripts, by generation: ${cr.pursuer.join(", ")} and ${cr.evader.join(", ")}`,(l,c)=>{let d=this.settings.
schedule.generations,m=me(l,c,{low:0,high:d,label:"generation",whole:!0},{low:0,high:1,label:"score"});for(let p of L){let h=Array.from(this.#m[p],f=>f??null);pe(
m,[...h.keys()],h,`of-${p}s`)}return m},()=>{},l=>{let c=Math.min(this.#a.newest,Math.max(0,Math.round(l)));this.#l.select({pursuer:c,evader:c})});this.#d=i.redraw,
this.#s.replaceChildren(n.element,u("section",{class:"card scores"},u("h3",{},"Against opponents that never change"),u("p",{class:"small muted"},"Captures of ra\
ndom walkers and of clumsy fleers; escapes from random walkers and from clumsy chasers."),st(["pursuers","of-pursuers"],["evaders","of-evaders"]),i.element)),this.#p.
replaceChildren(o,this.#h.dialog)}#A(e){let r=this.#a.newest;if(r<0||e<0)return null;let{world:n,payoff:s,seeds:o}=this.#a,a=this.#i++%s.episodes;this.newest.title.
textContent=r?"Newest against newest":"Generation 0: nobody has learned anything yet",this.beginning.title.textContent="Pursuers of generation 0, newest evaders";
for(let c of[this.newest,this.beginning])c.generation=r;for(let c of[this.newest,this.beginning])c.label=`A match. ${c.title.textContent}`;let[i,l]=[this.#a.policy(
"pursuer",e),this.#a.policy("evader",r)];return this.#t.match(n,i,l,BigInt(o[e][r]),a)}#E(e){this.newest.renew(e),(this.#a.newest>0||this.state!=="waiting")&&this.
beginning.renew(e)}#M(){this.element.dataset.state=this.state,this.#n.textContent=Fr(this.settings);let e=this.#u.get(`${this.#a.newest} ${this.#a.newest}`)??this.#u.
get(`${this.#a.newest-1} ${this.#a.newest-1}`),r=e?[`Generation ${this.#a.newest} of ${this.settings.schedule.generations}`,`the newest pursuers catch ${Gt(B(e.
capture_rates))} of the newest evaders`,`${Cu(e).toFixed(0)} collisions in 1000 moves`]:[];this.#o.replaceChildren(...r.map(n=>u("span",{},n))),this.dispatchEvent(
new Event("state"))}#C(){this.#c.ariaLabel=`What came out. ${Fr(this.settings)}`;let e=this.#a.payoff.capture_rate.slice(0,this.#a.newest+1).map(n=>n.slice(0,this.#a.
newest+1));if(e.length<2||e.some(n=>Array.from(n).includes(void 0)))return;let r=[["Score against scripts: generation 0",n=>Gt(this.#m[n][0]??0)],["Score agains\
t scripts: newest generation",n=>Gt(this.#m[n].at(-1)??0)],["Newest generation against all generations of the other team",n=>Gt(ao(e,n))],["Below its own best s\
o far, in the later half (forgetting)",n=>Gt(io(e,n))]];this.#c.replaceChildren(u("h3",{},"What came out"),u("table",{class:"numbers"},u("thead",{},u("tr",{},u(
"td"),...L.map(n=>u("th",{scope:"col",class:n},`${n}s`)))),u("tbody",{},...r.map(([n,s])=>u("tr",{},u("th",{scope:"row"},n),...L.map(o=>u("td",{},s(o))))))),u("\
p",{class:"small muted"},"These are measures without a verdict: one race proves little. Save it, and ",u("code",{},"matrixworld judge")," weighs luck and says w\
hat happened.")),this.#c.hidden=!1}};function Cu({means:{faults:t,agent_steps:e}}){let r=n=>n.reduce((s,o)=>s+o,0);return 1e3*r(t)/Math.max(1,r(e))}function Ou(t,e,...r){return u("section",{class:"card panel","aria-label":t},u("header",{},u("h2",{},t),u("p",{class:"small muted"},e)),...r)}var Ru={present:"●",
absent:"○","cannot tell":"?"};function Fi(t){let{findings:e}=t;if(!e?.table.length)return null;let[,...r]=e.table,n=r.map(([o,a,i,l],c)=>{let d=$u(e.reasons[c]??
"");return u("li",{class:`finding ${a.replace(" ","-")}`},u("span",{class:"sign","aria-hidden":"true"},Ru[a]??""),u("div",{},u("p",{},u("strong",{},o),` ${a}`,u(
"span",{class:"muted"},` · ${l}`)),d?u("p",{class:"small"},`${d}.`):null,u("p",{class:"small muted numbers"},i)))}),s=Ou("What happened","Each condition is pre\
sent, absent, or its 95 % interval cannot tell. The intervals are about this run.",u("p",{class:"headline"},e.sentence),u("p",{},e.headline),...e.numbers.map(o=>u(
"p",{class:"numbers"},`${de(o)}.`)),u("ul",{class:"findings"},...n),t.limits?u("p",{class:"small"},t.limits):null);return s.classList.add("diagnosis"),{element:s}}
function $u(t){let[,e=""]=t.split(/, because (.*)/s);return de(e.replace(/\.$/,""))}var _u=84;function Di(t,e){let r=t.map((o,a)=>Pu(o,a,e)),n=u("nav",{class:"races","aria-label":"Runs"},...r.map(o=>o.button)),s=()=>r.forEach((o,a)=>o.update(a===
e.selected.run));return e.on("match hover",s),s(),n.hidden=t.length<2,n}function Pu(t,e,r){let[n,s]=t.payoff.shape,o=!t.name.startsWith(t.schedule),a=_u/Math.max(
n,s),i=u("canvas",{"aria-hidden":"true"});ot(i,t.payoff,{left:0,top:0,width:s*a,height:n*a});let l=u("span",{class:"place"}),c=u("button",{type:"button",class:"\
race",title:`${t.name} (key ${e+1})`,onclick:()=>Nu(t,e,r)},u("span",{class:"small-matrix"},i,l),u("span",{class:"race-text"},u("strong",{},o?t.name:t.schedule),
u("span",{class:"small"},t.findings?t.findings.headline:`${t.learning.join(" and ")}s against ${Lu(t)}`),u("span",{class:"small muted"},`${o?`${t.schedule}, `:""}\
seed ${t.seed}`)));return{button:c,update:m=>{c.setAttribute("aria-current",String(m));let p=r.hover.pursuer??r.selected.pursuer,h=r.hover.evader??r.selected.evader;
l.hidden=p>=n||h>=s,l.style.left=`${(h+.5)*a}px`,l.style.top=`${(n-p-.5)*a}px`}}}var Lu=t=>t.teams.pursuer.script??t.teams.evader.script??"another run";function Nu(t,e,r){
let[n,s]=t.payoff.shape,{pursuer:o,evader:a}=r.selected;r.select({run:e,pursuer:Math.min(o,n-1),evader:Math.min(a,s-1)})}var Ui=1;function Wi({runs:t},e){let r=t[Ui],{shape:[n,s],episodes:o}=r.payoff,a=null,i=0,l=()=>a&&sr(a,r,{run:Ui,pursuer:n-1,evader:s-1,episode:i++%o,seed:null}),
c=new Ue(l);return c.title.textContent=`Generation ${n-1} of both teams`,c.label=`A match. ${c.title.textContent}`,c.generation=n-1,e.then(d=>{a=d,c.renew(),Bi(
c)}),u("div",{class:"widget"},c.element,Ce(c.player),Nr())}function zi({evolve:t},e,{grows:r=!1}){let n=u("button",{type:"button",class:"evolve",disabled:!0},"E\
volve"),s=u("progress",{max:1,value:0,"aria-label":"Progress of the race"}),o=u("div",{class:"lanes","data-count":1});return e.then(a=>{let i=-1,l=()=>Ya(t,{...qa(
t),seed:Math.max(0,i)}),c=new Jr(t,a,go("lesson"),l()),d=()=>{n.textContent=c.state==="waiting"?"Evolve":c.state==="evolving"?"Stop":"Again, with other luck",s.
value=c.done};n.addEventListener("click",()=>{if(c.state==="evolving")return c.stop();i++,c.settings=l(),c.start()}),c.addEventListener("state",d),o.append(c.element),
[c.newest,c.beginning].forEach(Bi),n.disabled=!1}),u("div",{class:`widget evolving ${r?"grows":"boards"}`},u("div",{class:"buttons"},n,s),o)}function Bi(t){let e=t.
runs;new IntersectionObserver(([r])=>{r.isIntersecting?e&&(t.runs=!0):(e=t.runs&&(t.player.playing||t.player.step===t.player.length),t.runs=!1)}).observe(t.element)}
function Hi({runs:t,playground:e},r){let n=t[0].payoff.shape.map(c=>c-1),s=new mt({run:0,pursuer:n[0],evader:n[1],episode:0,seed:null}),[o,a]=[new ut(t,s,e),new dt(
t,s)];o.actions.remove(),a.element.addEventListener("play",()=>{o.playSoon(),o.reveal()}),r.then(c=>o.start(c));let{seed:i,world:l}=t[0];return u("div",{class:"\
widget wide"},Di(t,s),u("div",{class:"stages"},a.element,o.element),u("p",{class:"small muted"},"Three races of ",u("code",{},`matrixworld evolve --seed ${i}`),
`: ${l.n_pursuers} pursuers and ${l.n_evaders} evaders on ${l.rows} x ${l.cols} cells.`))}function ji({runs:t}){let[e,r]=[t[0],t[0].findings],[n,...s]=r.table,o=s.
findIndex(([i,,,l])=>i==="arms race"&&l==="last half"),a={headline:e.name,numbers:[],table:[n,s[o]],reasons:[r.reasons[o]]};return u("div",{class:"widget text"},
Fi({...e,findings:{...r,...a}}).element)}var cs=()=>{let[t]=crypto.getRandomValues(new Uint32Array(1));return{pupil:t.toString(16).padStart(8,"0"),choices:[],solved:{},exit:"",done:!1}},Zr=class extends EventTarget{#e;#t;#r;keeps=!0;constructor(e){
super(),[this.#t,this.#r]=[e,`matrixworld lesson ${e}`],this.#e=this.#n(),this.#o({})}choice=e=>this.#e.choices.find(({prediction:r})=>r===e)?.choice;choose(e,r){
let n=new Date().toISOString().replace(/\.\d+Z$/,"+00:00");this.#o({choices:[...this.#e.choices,{prediction:e,choice:r,time:n}]}),this.dispatchEvent(new CustomEvent(
"choice",{detail:e}))}solved=e=>this.#e.solved[e];solve=(e,r)=>this.#o({solved:{...this.#e.solved,[e]:r}});get exit(){return this.#e}set exit(e){this.#o(e)}get count(){
return this.#e.choices.length}get file(){let{choices:e,pupil:r}=this.#e;return e.map(n=>`${JSON.stringify({...n,edition:this.#t,pupil:r})}
`).join("")}forget=()=>this.#o(cs());#n(){try{return{...cs(),...JSON.parse(localStorage.getItem(this.#r)??"{}")}}catch{return cs()}}#o(e){this.#e={...this.#e,...e};
try{localStorage.setItem(this.#r,JSON.stringify(this.#e))}catch{this.keeps=!1}}};function Gi(t,e){let r=[],n=[];for(let i of t)try{n.push({...i,...Iu(i.text,e)})}catch(l){r.push({file:i.name,reason:l.message})}let s=new Map([...e.predictions].
map(([i,{options:l}])=>[i,new Map(Object.keys(l).map(c=>[c,0]))])),o=new Map,a=new Map;for(let{name:i,text:l,pupil:c,choices:d}of n.sort((m,p)=>p.choices.size-m.
choices.size)){let m=[...d].filter(([h])=>!o.has(`${c} ${h}`)),p=a.get(l)??(m.length?void 0:o.get(`${c} ${[...d.keys()][0]}`));if(p!==void 0){r.push({file:i,reason:a.
has(l)?`double: the same content as ${p}`:`double: the pupil of ${p}`});continue}a.set(l,i);for(let[h,f]of m)o.set(`${c} ${h}`,i),s.get(h).set(f,s.get(h).get(f)+
1)}return{counts:s,pupils:new Set([...o.keys()].map(i=>i.split(" ")[0])).size,left:r}}function Iu(t,{edition:e,predictions:r}){if(t===null)throw new Error("expe\
cted at most 65536 bytes");let n=new Map,s="",o=t.split(/\r?\n/).filter(a=>a.trim());if(!o.length)throw new Error("expected predictions that the lesson has save\
d, got an empty file");return o.forEach((a,i)=>{let l=Fu(a),{prediction:c,choice:d}=l;if(typeof c!="string"||typeof d!="string")throw new Error(`line ${i+1}: ex\
pected a prediction and its choice`);if(l.edition!==e)throw new Error(`line ${i+1}: expected edition ${e} of the course, got ${us(l.edition)}`);let m=r.get(c)?.
options;if(!m)throw new Error(`line ${i+1}: expected a prediction of the lesson, got ${us(c)}`);if(!Object.hasOwn(m,d))throw new Error(`line ${i+1}: expected on\
e of ${Object.keys(m).join(", ")} for ${c}, got ${us(d)}`);if(s||=String(l.pupil??""),!/^[0-9a-f]{8}$/.test(s)||l.pupil!==s)throw new Error(`line ${i+1}: expect\
ed lines of one pupil`);n.has(c)||n.set(c,d)}),{pupil:s,choices:n}}function Fu(t){try{let e=JSON.parse(t);return typeof e=="object"&&e!==null?e:{}}catch{return{}}}
var us=t=>t===void 0?"none":JSON.stringify(t).slice(0,40);function Vi(t){let e={edition:t.edition,predictions:hr(t)},r=u("p",{role:"status"}),n=u("ul",{class:"left"}),s=u("div",{class:"questions"}),o=new Set,a=[],i=()=>{
let p=Gi(a,e);r.textContent=a.length?`${a.length} ${a.length===1?"file":"files"}, ${p.pupils} ${p.pupils===1?"pupil":"pupils"}.${p.left.length?" Not counted:":""}`:
"No files yet.",n.replaceChildren(...p.left.map(({file:h,reason:f})=>u("li",{},u("strong",{},h),` ${f}`))),s.replaceChildren(...[...e.predictions.values()].map(
h=>Uu(h,p,o,i)))},l=async p=>{let h=[...p].map(async f=>({name:f.name,text:f.size>65536?null:await f.text()}));a=[...a,...await Promise.all(h)],i()},c=u("input",
{type:"file",multiple:!0,accept:".jsonl",id:"vote-files",onchange:()=>{l(c.files).then(()=>c.value="")}}),d=u("button",{type:"button",onclick:()=>{a=[],o.clear(),
i()}},"Remove all files"),m=u("section",{class:"card drop","aria-label":"Files"},u("p",{},u("label",{for:"vote-files"},"Drop the files that your pupils have sav\
ed anywhere on this page, or choose them: ")),c,u("div",{class:"buttons"},r,d),n,u("p",{class:"small muted"},"A pupil saves predictions.jsonl at the end of the \
lesson. Names of files do not matter. Each pupil counts once: a second file of a pupil is named as double. Nothing leaves this computer."));document.addEventListener(
"dragover",p=>p.preventDefault()),document.addEventListener("drop",p=>{p.preventDefault(),l(p.dataTransfer?.files??[])}),document.getElementById("page").replaceWith(
mr("How the class voted",u("span",{},`${t.title} `,u("a",{href:"#"},"Back to the lesson"))),u("main",{},m,s),u("footer",{class:"small muted"},`matrixworld ${t.version}\
, edition ${t.edition} of the course`)),i()}function Uu(t,e,r,n){let{predict:s,options:o,outcome:a}=t,i=e.counts.get(s),l=[...i.values()].reduce((h,f)=>h+f,0),c=r.
has(s),d=t.again?e.counts.get(t.again):void 0,m=Object.entries(o).map(([h,f])=>{let g=u("span",{class:"filled"});g.style.width=`${100*i.get(h)/Math.max(1,l)}%`;
let y=c&&h===a;return u("li",{class:y?"vote right":"vote"},u("span",{},`${h}. ${f}`,y&&u("strong",{}," ✓ the outcome")),u("span",{class:"bar","aria-hidden":"t\
rue"},g),u("span",{class:"numbers"},`${i.get(h)} of ${l}`,d&&u("span",{class:"muted"},`, at first ${d.get(h)}`)))}),p=u("button",{type:"button",id:`outcome-${s}`,
onclick:()=>{r.add(s),n()}},"Show the outcome");return u("section",{class:"card question",id:`votes-${s}`},u("h2",{},t.question),u("ul",{class:"of-votes"},...m),
t.later?u("p",{class:"muted"},t.later):c?u("div",{class:"reply"},...Wt(t.explanation??"")):u("div",{},p))}var qi="#votes",Wu=["explorer"],zu=t=>"needs"in t?t.needs:void 0,Xr=t=>"widget"in t;function Bu(t){let e=[];for(let r of t){let n=e.at(-1);!n||"text"in r||Xr(r)&&
n.some(Xr)?e.push([r]):n.push(r)}return e}function Hu(t){let e=t.find(Xr);return e&&t.length>1&&!Wu.includes(e.widget)&&!e.grows?"block beside":"block"}var ds=class{#e;#t;#r=()=>{};#n=new Promise(
e=>this.#r=e);#o={chase:()=>Wi(this.#e,this.#n),evolving:e=>zi(this.#e,this.#n,e),"right-of-way":ba,flat:va,hands:ka,"hands-matrix":Ca,games:Pa,numbers:La,matrices:()=>ga(
this.#e),explorer:()=>Hi(this.#e,this.#n),judgement:()=>ji(this.#e),"same-diagonal":ya,exit:e=>Wa(e,this.#t)};constructor(e){[this.#e,this.#t]=[e,new Zr(e.edition)];
let r=this.#t,n=hr(e).size,s=u("span",{class:"small muted",role:"status"}),o=()=>{s.textContent=`${r.count} of ${n} predictions made. `+(r.keeps?"They stay in t\
his browser.":"This browser keeps nothing: save before you close the page.")};r.addEventListener("choice",o);let a=()=>{confirm("Delete all predictions and answ\
ers in this browser, for another student? Save them first.")&&(r.forget(),location.reload())};document.getElementById("page").replaceWith(mr(e.title,e.lead),u("\
nav",{class:"sections","aria-label":"Sections"},...e.sections.map((i,l)=>u("a",{href:`#${i.id}`},`${l+1}. ${i.title}`))),u("main",{},...e.sections.map((i,l)=>this.#c(
i,l))),u("footer",{class:"card"},u("div",{class:"buttons"},u("button",{type:"button",class:"primary save",onclick:()=>et("predictions.jsonl",r.file)},"Save my p\
redictions"),u("button",{type:"button",onclick:()=>print()},"Print"),u("button",{type:"button",onclick:a},"Start anew"),s),u("p",{class:"small muted"},`The page\
 sends nothing anywhere. matrixworld ${e.version}, edition ${e.edition} of the course. Teachers: `,u("a",{href:qi},"count the votes of a class"),"."))),o()}async load(){
this.#r(await Qt())}#s(e){return"text"in e?u("div",{class:"text"},...Wt(e.text)):Xr(e)?this.#o[e.widget](e):"exercise"in e?Ua(e,this.#t):Da(e,this.#t)}#c(e,r){let{
sections:n}=this.#e,s=u("p",{class:"waiting muted",role:"status"}),o=u("section",{class:"card",id:e.id,"aria-labelledby":`title-${e.id}`},u("h2",{id:`title-${e.
id}`},`${r+1}. ${e.title}`,u("span",{class:"muted small"},`${e.minutes} minutes`)),s),a=Bu(e.parts),i=a.map(m=>u("div",{class:Hu(m)})),l=a.flatMap((m,p)=>m.map(
()=>i[p])),c=0,d=()=>{for(s.textContent="";c<e.parts.length;c++){let[m,p]=[e.parts[c-1],e.parts[c]],h=[pr(m)?m.predict:void 0,zu(p)].find(f=>f&&this.#t.choice(f)===
void 0);if(h){let f=n.findIndex(({parts:g})=>g.some(y=>pr(y)&&y.predict===h));s.textContent=`This section goes on with your prediction${f===r?"":` in section ${f+
1}`}.`;return}s.before(l[c]),l[c].append(this.#s(p))}s.remove()};return this.#t.addEventListener("choice",d),d(),o}};function ju(){let t=Ao(),e=()=>location.hash===
qi,r=e();if(window.addEventListener("hashchange",()=>e()!==r&&location.reload()),r)return void Ln(Promise.resolve(Vi(t)));let n=new ds(t);requestAnimationFrame(
()=>setTimeout(()=>Ln(n.load())))}typeof document>"u"?yo():ju();})();
