/* built from web/ by "npm run build"; sources ff261dc2356e852a4c6ab51388e6b3a710d99ab4c9b3337c8644317b55a57450 */
"use strict";(()=>{var zn={SIMULTANEOUS:0,SWARM_TURNS:1,AGENT_TURNS:2},rt={DISAPPEAR:0,REACH:1,BOUNCE:2},Bn={OCCUPATION:0,SURROUND:1},Gn={FAULT:0,INVOLVED:1};var Ur=["obstacle","teammate","adversary"],Dr=["vertex","edge","chain"],Hn=["turn","kind","form","first","second","row","col","at_fault","held","doomed"],Wr=["p\
ursuer_{number}","evader_{number}"],jn={obstacle:"{first} ran into the obstacle or border at {cell}",vertex:"{first} and {second} both headed for {cell}",edge:"\
{first} and {second} meant to swap, {first} to {cell}",chain:"{first} headed for {cell}, where {second} had to stay"},nt={"both held":"both bounce","both doomed":"\
both disappear",held:"{agent} bounces",doomed:"{agent} disappears",none:"nobody is stopped"},Vn="{event}: {outcome}",zr={random:"any action, all equally likely",
still:"always stays",chaser:"moves to where the nearest adversary in view is nearest",fleer:"moves to where the nearest adversary in view is farthest","clumsy-c\
haser":"a chaser that takes any action in half of the steps",hunter:"a chaser of the nearest adversary in view to which no teammate in view is nearer",surrounder:"\
a chaser of the nearest free cell beside an adversary without a teammate","clumsy-fleer":"a fleer that takes any action in half of the steps",dodger:"moves to w\
here all adversaries in view together are farthest","team-surrounder":"shares the free cells beside adversaries with its teammates, and searches","careful-rando\
m":"as random, but takes only moves that right of way allows","careful-chaser":"as chaser, but takes only moves that right of way allows","careful-fleer":"as fl\
eer, but takes only moves that right of way allows","careful-clumsy-chaser":"as clumsy-chaser, but takes only moves that right of way allows","careful-hunter":"\
as hunter, but takes only moves that right of way allows","careful-surrounder":"as surrounder, but takes only moves that right of way allows","careful-clumsy-fl\
eer":"as clumsy-fleer, but takes only moves that right of way allows","careful-dodger":"as dodger, but takes only moves that right of way allows","careful-team-\
surrounder":"as team-surrounder, but takes only moves that right of way allows"},Ee={adversary:"distance to the nearest adversary (0 to 2, in half views)",pressure:"\
sum over adversaries of 1 / (1 + moves)^2 (0 or more)",unclaimed:"distance to the nearest adversary to which no teammate is nearer than the agent is now; withou\
t one, to the nearest adversary (0 to 2, in half views)",open_side:"distance to the nearest cell beside an adversary that holds no obstacle and no teammate (0 t\
o 2, in half views)",teammate:"distance to the nearest teammate (0 to 2, in half views)",crowd:"sum over teammates of 1 / (1 + moves)^2 (0 or more)",exits:"shar\
e of the cells around that are no obstacle (0 to 1)",room:"distance to the nearest obstacle to the north, east, south or west (0 to 1, in half views)",must_yield:"\
1 if right of way forbids the move (0 to 1)",stay:"1 if it is no move (0 to 1)",ahead:"1 if it is the direction that the agent draws for each 12 steps (0 to 1)"},
Yn={free:".GS",blocked:"#@OTW"};var ze=1+Hn.length;function st(r,e){return r.replace(/\{(\w+)\}/g,(t,n)=>String(e[n]))}function K(r,e){return r<e?st(Wr[0],{number:r}):st(Wr[1],{number:r-e})}function Qa(r,e){
let[t,n,s,o,a,i,l,...c]=Array.from(r),h=a<0?[o]:[o,a],[u,m,p]=c.map(v=>h.filter((S,w)=>v>>w&1)),g=h.map(v=>K(v,e)),f=st(jn[a<0?"obstacle":Dr[s]],{first:g[0],second:g[g.
length-1],cell:`(${i}, ${l})`}),y=st(Vn,{event:f,outcome:ei(h.length,m,p,e)});return{kind:Ur[n],form:Dr[s],agents:h,cell:[i,l],at_fault:u,held:m,doomed:p,turn:t,
text:y}}function ei(r,e,t,n){if(r===2&&e.length===2)return nt["both held"];if(r===2&&t.length===2)return nt["both doomed"];let s=o=>a=>st(nt[o],{agent:K(a,n)});
return[...e.map(s("held")),...t.map(s("doomed"))].join(", ")||nt.none}function _t(r,e){let t=[];for(let n=0;n<r.length;n+=ze)t.push(Qa(r.subarray(n+1,n+ze),e));
return t}var ve=class extends Error{name="EngineError"};function L(r,e,t){let n=typeof t=="string"?`'${t}'`:typeof t=="object"?JSON.stringify(t):String(t);return new ve(
`${r}: expected ${e}, got ${n}`)}var Be=class{bytes;constructor(e){this.bytes=e}},Zn=0,Gr=[Uint8Array,Uint8Array,Int32Array,BigInt64Array,BigUint64Array,Float32Array,Float64Array],Kn=4,qn=4,ti=new TextEncoder,
ri=new TextDecoder;function ni(r){for(let e=Gr.length-1;e>Zn;--e)if(r instanceof Gr[e])return e;throw new TypeError("array: expected a typed array of the engine\
's numbers, got another")}function Br(r){return new Uint8Array(r.buffer,r.byteOffset,r.byteLength)}function si(r){return ti.encode(`${r}\0`)}var Hr=class{engine;addresses=[];constructor(e){
this.engine=e}copy(e){let t=this.engine._malloc(Math.max(e.length,1));if(t===0)throw new ve("memory: expected room for the arguments, got none");return this.addresses.
push(t),this.engine.HEAPU8.set(e,t),t}text(e){return this.copy(si(e))}arrays(e){let t=Object.entries(e),n=t.flatMap(([o,a])=>{let i=a instanceof Be,l=i?a.bytes:
a;return[this.text(o),i?Zn:ni(l),l.length,this.copy(Br(l))]}),s=this.copy(Br(Int32Array.from(n)));return this.copy(Br(Int32Array.of(t.length,s)))}free(){for(let e of this.
addresses)this.engine._free(e)}};function Jn(r,e){let t=r.HEAPU8;return ri.decode(t.subarray(e,t.indexOf(0,e)))}function Ge(r){let e=new Int32Array(r.HEAPU8.buffer),
t=r._last_outputs()/Kn,n=e[t+1]/Kn,s={};for(let o=n;o<n+e[t]*qn;o+=qn){let a=Gr[e[o+1]],i=e[o+2]*a.BYTES_PER_ELEMENT,l=e[o+3];s[Jn(r,e[o])]=new a(r.HEAPU8.slice(
l,l+i).buffer)}return s}function be(r,e){let t=new Hr(r);try{let n=e(t);if(n===0)throw new ve(Jn(r,r._last_error()));return n}finally{t.free()}}var oi=2**31-1,Xn=["none","gru"],ai=2n**64n-1n,ii=34028234663852886e22;function ae(r,e){if(typeof e!="number"||!Number.isInteger(e)||Math.abs(e)>oi)throw L(r,"a\
n integer",e);return Int32Array.of(e)}function Pt(r,e){if(typeof e!="boolean")throw L(r,"true or false",e);return new Be(Uint8Array.of(Number(e)))}function Ce(r,e,t){
let n=typeof e=="string"&&Object.hasOwn(t,e)?t[e]:void 0;if(n===void 0)throw L(r,`one of ${Object.keys(t).join(", ")}`,e);return Int32Array.of(n)}function jr(r,e){
if(typeof e!="number"||!(Math.abs(e)<=ii))throw L(r,"a finite number",e);return e}function ot(r,e){let n=typeof e=="bigint"||typeof e=="number"&&Number.isSafeInteger(
e)?BigInt(e):-1n;if(n<0n||n>ai)throw L(r,"an integer from 0 to 2^64 - 1",e);return BigUint64Array.of(n)}function li(r){return{"rules.interaction":Ce("interactio\
n",r.interaction,zn),"rules.obstacle":Ce("obstacle",r.obstacle,rt),"rules.teammate":Ce("teammate",r.teammate,rt),"rules.evader":Ce("evader",r.evader,rt),"rules.\
pursuer":Ce("pursuer",r.pursuer,rt),"rules.capture":Ce("capture",r.capture,Bn),"rules.captured_disappear":Pt("captured_disappear",r.captured_disappear)}}function Qn(r,e){
let t=typeof e=="number"?[e,e,e]:e;if(!Array.isArray(t)||t.length!==3)throw L(r,"1 or 3 numbers",e);return Float32Array.from(t,n=>jr(r,n))}function ci(r){let e=(t,n)=>Float32Array.
of(jr(t,r[t]),jr(n,r[n]));return{"rewards.capture":e("pursuer_capture","evader_capture"),"rewards.neighbor":e("pursuer_neighbor","evader_neighbor"),"rewards.ste\
p":e("pursuer_step","evader_step"),"rewards.pursuer_collide":Qn("pursuer_collide",r.pursuer_collide),"rewards.evader_collide":Qn("evader_collide",r.evader_collide),
"rewards.blame":Ce("blame",r.blame,Gn),"rewards.capture_repeats":Pt("capture_repeats",r.capture_repeats)}}function rs(r){if(r===void 0||typeof r=="number")return new Uint8Array(
0);if(r instanceof Uint8Array)return r;let{free:e,blocked:t}=Yn;for(let[n,s]of r.entries()){if(s.length!==r[0]?.length)throw L(`map, row ${n}`,`${r[0]?.length} \
cells as in row 0`,s.length);let o=[...s].find(a=>!e.includes(a)&&!t.includes(a));if(o)throw L(`map, row ${n}`,`'${e}' (free) or '${t}' (obstacle)`,o)}return Uint8Array.
from([...r.join("")],n=>Number(t.includes(n)))}function ns(r,e){if(!Array.isArray(r))return;let t=[r.length,r[0]?.length??0];if(!(t[0]===e.rows&&t[1]===e.cols))
throw L("obstacle map",`shape (${e.rows}, ${e.cols}), the rows and cols`,t)}function He(r){ns(r.obstacles,r);let e=typeof r.obstacles=="number"?r.obstacles:0;return{
...li(r.rules),...ci(r.rewards),rows:ae("rows",r.rows),cols:ae("cols",r.cols),n_pursuers:ae("n_pursuers",r.n_pursuers),n_evaders:ae("n_evaders",r.n_evaders),fov:ae(
"fov",r.fov),diagonal:Pt("diagonal",r.diagonal),max_steps:ae("max_steps",r.max_steps),density:Float64Array.of(e),map:rs(r.obstacles)}}function es(r,e){return Int32Array.
from((e??[]).flat(),t=>ae(r,t)[0])}function ss(r,e){return ns(r.obstacles,e),{seed:ot("seed",r.seed??0n),episode:ot("episode",r.episode??0),pursuers:es("pursuer\
s",r.pursuers),evaders:es("evaders",r.evaders),map:rs(r.obstacles)}}function $t(r){return{actions:Int32Array.from(r,e=>ae("actions",e)[0])}}var ts=Object.keys(Ee);
function Vr(r){let e=ts.indexOf(r);if(e<0)throw L("inputs",`names of ${ts.join(", ")}`,r);return e}function ke(r){if(typeof r=="string"){if(!Object.hasOwn(zr,r))
throw L("policy",`one of ${Object.keys(zr).join(", ")}`,r);return{script:new TextEncoder().encode(r)}}if(r.kind!=="cells")return{inputs:Int32Array.from(r.inputs,
e=>Vr(e)),hidden:Int32Array.from(r.kind==="rating"?r.hidden:[],e=>ae("hidden",e)[0]),length:ae("length",r.kind==="program"?r.length:0),mask:new TextEncoder().encode(
r.mask),genome:r.genome};if(r.activation!=="relu"&&r.activation!=="tanh")throw L("activation","'relu' or 'tanh'",r.activation);if(!Xn.includes(r.memory))throw L(
"memory",`one of ${Xn.join(", ")}`,r.memory);return{hidden:Int32Array.from(r.hidden,e=>ae("hidden",e)[0]),activation:new TextEncoder().encode(r.activation),sampled:Pt(
"sampled",r.sampled),memory:new TextEncoder().encode(r.memory),genome:r.genome}}var ui=["first_turn","terminated","truncated"];function os(r){let e={...r};for(let t of ui)
e[t]=new Be(r[t]);return e}var as="statistics.",Nt=class{config;seed;episode;n_agents;statistics;first_conflict;constructor(e,t,n,s){this.config=e,this.seed=t,this.episode=n,this.n_agents=
e.n_pursuers+e.n_evaders,this.statistics=di(is(s)),Object.assign(this,s),this.first_conflict=hi(this.conflict_table,this.length)}get length(){return this.actions.
length/this.n_agents}conflicts(e){this.check(e);let[t,n]=[this.first_conflict[e],this.first_conflict[e+1]],s=this.conflict_table.subarray(t*ze,n*ze);return _t(s,
this.config.n_pursuers)}seek(e,t,n){this.check(t),(!(e.seed===this.seed&&e.episode===BigInt(this.episode))||e.turn!==0||e.steps>t)&&e.reset({seed:this.seed,episode:this.
episode});for(let o=e.steps;o<t;++o){let a=this.actions.subarray(o*this.n_agents,(o+1)*this.n_agents);n?e.replay(a,{pursuer:n.pursuers,evader:n.evaders}):e.step(
a)}}check(e){if(!(Number.isInteger(e)&&e>=0&&e<=this.length))throw L("step",`0 to ${this.length}`,e)}};function hi(r,e){let t=new Int32Array(e+2);for(let n=0;n<
r.length;n+=ze)++t[r[n]+1];for(let n=1;n<t.length;++n)t[n]+=t[n-1];return t}function di(r){let e=["capture_rate","ever_capture_rate","captured_fraction","length"];
return Object.fromEntries(Object.entries(r).map(([t,n])=>[t,e.includes(t)?Number(n[0]):n]))}var is=r=>Object.fromEntries(Object.entries(r).flatMap(([e,t])=>e.startsWith(
as)?[[e.slice(as.length),t]]:[]));function ls(r,e,t,n){let s=[He(t.config),ke(t.pursuers),ke(t.evaders),n];return be(r,o=>{let[a,i,l,c]=s.map(h=>o.arrays(h));return r[e](
a,i,l,c)}),Ge(r)}function cs(r,e,t,n){let s={seed:ot("seed",t),episode:ot("episode",n)};return new Nt(e.config,t,n,ls(r,"_play_match",e,s))}function us(r,e,t,n){
if(!Number.isInteger(n)||n<1)throw L("n_episodes","at least 1",n);let s=ls(r,"_play_rollout",e,{...t,n_episodes:Int32Array.of(n)});return is(s)}var mi=7e6,pi=new FinalizationRegistry(([r,e])=>r._states_free(e));function fi({rules:r,rows:e,cols:t,obstacles:n,diagonal:s,n_pursuers:o,n_evaders:a}){let i=typeof n==
"number"||r.obstacle==="REACH"?0:n.join("").split("#").length-1,l=e*t-i,c=[r.obstacle,r.teammate,r.pursuer].includes("DISAPPEAR"),h=r.capture==="SURROUND"||r.evader===
"REACH",u=r.interaction==="AGENT_TURNS",m=(f,y)=>Array.from({length:y},(v,S)=>u?f:(f+S)/(S+1)).reduce((v,S)=>v*S,1),p=m(l+Number(c),o)*m(l*(1+Number(h))+2,a);return{
SIMULTANEOUS:[o+a],SWARM_TURNS:[o,a],AGENT_TURNS:Array(o+a).fill(1)}[r.interaction].reduce((f,y)=>f+p*(s?9:5)**y,0)}function Lt(r){return typeof r.obstacles=="n\
umber"&&r.obstacles>0?"obstacles are drawn anew in each episode":fi(r)>mi?"the world is too large to be solved on the page":""}var Yr=class{value;teams;matrix;n_actions;constructor(e,t){
let{matrix:n,rows:s,cols:o,value:a,agents:i}=t,[l,c]=e.actors,h=Array.from(i).filter(m=>l<=m&&m<c),u=m=>m<e.config.n_pursuers;[this.value,this.matrix,this.n_actions]=
[a[0],n,e.n_actions],this.teams=[{agents:h.filter(u),play:s},{agents:h.filter(m=>!u(m)),play:o}]}marginal(e){let t=this.teams.find(({agents:o})=>o.includes(e));
if(!t)return null;let n=this.n_actions**(t.agents.length-1-t.agents.indexOf(e)),s=Array(this.n_actions).fill(0);return t.play.forEach((o,a)=>s[Math.floor(a/n)%this.
n_actions]+=o),s}lost(e){let[t,n]=this.teams.map(({agents:l})=>l.reduce((c,h)=>c*this.n_actions+e[h],0)),[s,o]=this.teams.map(({play:l})=>l),a=o.reduce((l,c,h)=>l+
c*this.matrix[t*o.length+h],0),i=s.reduce((l,c,h)=>l+c*this.matrix[h*o.length+n],0);return[Math.max(0,this.value-a),Math.max(0,i-this.value)]}},Kr=60,at=class{config;payoff;engine;states;n_turns;values;constructor(e,t,n){
[this.engine,this.config,this.payoff]=[e,t,n],this.states=be(e,i=>e._states_new(i.arrays(He(t)))),pi.register(this,[e,this.states]);let s={SIMULTANEOUS:1,SWARM_TURNS:2,
AGENT_TURNS:t.n_pursuers+t.n_evaders};this.n_turns=s[t.rules.interaction];let{payoffs:o}=this.call(()=>e._states_payoffs(this.states)),a=o;this.values=[[n==="ca\
pture-rate"?a:a.fill(0)]]}goBack(){let e=this.values.at(-1)[0],t=[];for(let s=this.n_turns-1;s>=0;s--){let o=t[s+1]??e;t[s]=this.backup(s,{next:o})}this.payoff===
"capture-time"&&(t[0]=t[0].map((s,o)=>o===this.config.n_evaders?0:s-1)),this.values.push(t);let n=this.payoff==="capture-rate"?this.config.max_steps:Math.min(this.
config.max_steps,Kr);return this.values.length<=n&&t[0].some((s,o)=>s!==e[o])}backup(e,t){return this.call(n=>this.engine._states_backup(this.states,e,n.arrays(
t))).values}game(e){let[t,{turn:n}]=[this.config.max_steps-e.steps,e],s=n+1===this.n_turns,o=t>0?this.values[Math.min(t-Number(s),this.values.length-1)]?.[s?0:n+
1]:void 0;if(!o)return null;let a=this.call(i=>this.engine._states_game(this.states,e.address,i.arrays({next:o})));return a.agents.length?new Yr(e,a):null}call(e){
return be(this.engine,e),Ge(this.engine)}};var hs=new FinalizationRegistry(([r,e])=>r._world_free(e)),it=class{config;n_agents;n_actions;engine;at;freed=!1;constructor(e,t){this.engine=e,this.config=t,this.
n_agents=t.n_pursuers+t.n_evaders,this.n_actions=t.diagonal?9:5,this.at=be(e,n=>e._world_new(n.arrays(He(t)))),hs.register(this,[e,this.at],this)}free(){this.freed||
(this.freed=!0,hs.unregister(this),this.engine._world_free(this.at))}get address(){if(this.freed)throw L("world","one that is in use","one that was freed");return this.
at}reset(e={}){let t=ss(e,this.config);this.call(n=>this.engine._world_reset(this.address,n.arrays(t)))}step(e){let t=$t(e);this.call(n=>this.engine._world_step(
this.address,n.arrays(t)))}playTurn(e){let t=$t(e);this.call(n=>this.engine._world_play_turn(this.address,n.arrays(t)))}decide(e,t,n){let{n_pursuers:s}=this.config,
o={pursuer:[0,s],evader:[s,this.n_agents]},[a,i]=typeof t=="string"?o[t]:t;if(n.length!==this.n_agents)throw L("actions",String(this.n_agents),n.length);let l=[
ke(e),$t(n)],{actions:c}=this.call(h=>this.engine._world_decide(this.address,h.arrays(l[0]),a,i,h.arrays(l[1])));return Uint8Array.from(c)}replay(e,t){let n=o=>typeof o!=
"string"&&o.kind==="cells"&&o.memory!=="none";if(!n(t.pursuer)&&!n(t.evader))return this.step(e);let{n_pursuers:s}=this.config;for(let o=this.n_turns;o>0;--o){let[
a,i]=this.actors;a<s&&this.decide(t.pursuer,[a,Math.min(i,s)],e),i>s&&this.decide(t.evader,[Math.max(a,s),i],e),this.playTurn(e)}}get n_turns(){return this.turnNumbers()[1]}get turn(){
return this.turnNumbers()[0]}get actors(){let[,,e,t]=this.turnNumbers();return[e,t]}turnNumbers(){return this.call(()=>this.engine._world_turn(this.address)).turn}get steps(){
return this.read("steps")[0]}get seed(){return this.read("seed")[0]}get episode(){return this.read("episode")[0]}get over(){return this.read("terminated")[0]===
1||this.read("truncated")[0]===1}read(e){return this.call(t=>this.engine._world_read(this.address,t.text(e)))[e]}view(e){let t=3*this.config.fov**2;return this.
read("views").slice(e*t,(e+1)*t)}map(){return this.read("state").slice(2*this.config.rows*this.config.cols)}conflicts(){return _t(this.conflictTable(),this.config.
n_pursuers)}conflictTable(){return this.call(()=>this.engine._world_conflicts(this.address)).conflict_table}answer(e,t){let n=ke(e),{logits:s,memory:o}=this.call(
l=>this.engine._world_logits(this.address,l.arrays(n),t)),a=s,i=this.decide(e,[t,t+1],new Uint8Array(this.n_agents))[t];return{logits:a,probabilities:yi(a),action:i,
memory:o}}rate(e,t){let n=ke(e),{ratings:s,refused:o}=this.call(c=>this.engine._world_rate(this.address,c.arrays(n),t)),a=this.read("inputs"),i=a.length/this.n_agents/
this.n_actions,l=c=>Float32Array.from({length:this.n_actions},(h,u)=>a[(t*this.n_actions+u)*i+c]);return{inputs:e.inputs.map(c=>l(Vr(c))),ratings:s,refused:o}}snapshot(){
return this.call(()=>this.engine._world_snapshot(this.address))}restore(e){let t=os(e);this.call(n=>this.engine._world_restore(this.address,n.arrays(t)))}call(e){
return be(this.engine,e),Ge(this.engine)}};function yi(r){let e=Math.max(...r),t=Array.from(r,s=>Math.exp(s-e)),n=t.reduce((s,o)=>s+o,0);return Float32Array.from(
t,s=>s/n)}var qr=class{compiled;constructor(e){this.compiled=e}world(e){return new it(this.compiled,e)}solution(e,t="capture-rate"){return new at(this.compiled,e,t)}match(e,t,n,s,o=0){
return cs(this.compiled,{config:e,pursuers:t,evaders:n},s,o)}rollouts(e,t,n,s,o){return us(this.compiled,{config:e,pursuers:t,evaders:n},s,o)}},ds;function It(r=globalThis.
matrixworldEngine){return ds??=gi(r),ds}async function gi(r){if(!r)throw new Error("matrixworldEngine: expected the script engine.js before this one, got none");
let e=Uint8Array.from(atob(r.binary),t=>t.charCodeAt(0));return new qr(await r({wasmBinary:e}))}var vi="http://www.w3.org/2000/svg";function d(r,e={},...t){return ms(document.createElement(r),e,t)}function b(r,e={},...t){return ms(document.createElementNS(
vi,r),e,t)}function ms(r,e,t){for(let[s,o]of Object.entries(e))o==null||o===!1||(typeof o=="function"?r.addEventListener(s.slice(2),o):r.setAttribute(s,o===!0?"":
String(o)));let n=t.filter(s=>s!=null&&s!==!1);return r.append(...n.map(s=>typeof s=="number"?String(s):s)),r}function ne(r,e){let t=d("select",{onchange:()=>e(
t.value)},...r.map(([n,s])=>d("option",{value:n},s)));return t}async function ps(r){try{await r}catch(e){throw(document.querySelector("#page, main")??document.body).
prepend(d("p",{class:"card problem",role:"alert"},`The page could not start: ${String(e)}`)),e}finally{document.body.dataset.ready="true"}}var Ft=()=>["file:","\
http:","https:"].includes(location.protocol);var fs=r=>d("input",{type:"text",readonly:!0,"aria-label":r});function Ut(r,e){let t=URL.createObjectURL(new Blob([e],{type:"application/octet-stream"}));d("a",
{href:t,download:r}).click(),setTimeout(()=>URL.revokeObjectURL(t),6e4)}var ys=()=>document.documentElement.dataset.theme==="dark",lt=r=>{document.documentElement.dataset.theme=r?"dark":"light"},Zr=()=>lt(!ys());if(typeof document<"\
u"){let r=matchMedia("(prefers-color-scheme: dark)");r.addEventListener("change",()=>lt(r.matches)),lt(r.matches);let e=!1;addEventListener("beforeprint",()=>{e=
ys(),lt(!1)}),addEventListener("afterprint",()=>lt(e))}function gs(){return d("button",{type:"button",title:"Light or dark (D)","aria-label":"Light or dark",onclick:Zr},
"◐")}var vs=(r,e,...t)=>d("header",{class:"top"},d("div",{},d("h1",{},r),e?d("p",{class:"lead"},e):null),d("div",{class:"tools"},...t,gs()));var bi=Array.from({length:16},(r,e)=>{let[t,n]=[e%2?6.5:11,Math.PI*e/8];return`${12+t*Math.sin(n)} ${12-t*Math.cos(n)}`}).join(" ");function Dt(){let r=[["pursu\
er",b("path",{d:"M12 3 22 20H2z",class:"filled-pursuer"})],["evader",b("circle",{cx:12,cy:12,r:9,class:"filled-evader"})],["capture",b("polygon",{points:bi,class:"\
filled-capture"})],["captured evader",b("circle",{cx:12,cy:12,r:7.5,class:"ring-evader"})],["conflict",b("rect",{x:3,y:3,width:18,height:18,class:"dashed-confli\
ct"})]];return d("ul",{class:"shapes small","aria-label":"Shapes on the board"},...r.map(([e,t])=>d("li",{},b("svg",{viewBox:"0 0 24 24","aria-hidden":"true"},t),
e)))}var Q=["stay","north","east","south","west","northeast","southeast","southwest","northwest"];var bs="champion",ws=0,Jr=64,Xr=100;var wi=(r,e)=>Object.keys(r).every(t=>r[t]===e[t]);function xs(r,e){return Object.keys(e).find(t=>wi(e[t],r))??null}function Ss(r,e,t){let n=new Set(r);return Array.
from({length:e},(s,o)=>Array.from({length:t},(a,i)=>n.has(o*t+i)?"#":".").join(""))}function Wt(r,e,t){let n=r.filter(s=>s!==e);return t?[...n,e].sort((s,o)=>s-
o):n}var $=Uint8Array,ee=Uint16Array,ln=Int32Array,zt=new $([0,0,0,0,0,0,0,0,1,1,1,1,2,2,2,2,3,3,3,3,4,4,4,4,5,5,5,5,0,0,0,0]),Bt=new $([0,0,0,0,1,1,2,2,3,3,4,4,5,5,
6,6,7,7,8,8,9,9,10,10,11,11,12,12,13,13,0,0]),rn=new $([16,17,18,0,8,7,9,6,10,5,11,4,12,3,13,2,14,1,15]),ks=function(r,e){for(var t=new ee(31),n=0;n<31;++n)t[n]=
e+=1<<r[n-1];for(var s=new ln(t[30]),n=1;n<30;++n)for(var o=t[n];o<t[n+1];++o)s[o]=o-t[n]<<5|n;return{b:t,r:s}},Rs=ks(zt,2),Os=Rs.b,nn=Rs.r;Os[28]=258,nn[258]=28;
var _s=ks(Bt,0),xi=_s.b,As=_s.r,sn=new ee(32768);for(E=0;E<32768;++E)pe=(E&43690)>>1|(E&21845)<<1,pe=(pe&52428)>>2|(pe&13107)<<2,pe=(pe&61680)>>4|(pe&3855)<<4,sn[E]=
((pe&65280)>>8|(pe&255)<<8)>>1;var pe,E,ue=(function(r,e,t){for(var n=r.length,s=0,o=new ee(e);s<n;++s)r[s]&&++o[r[s]-1];var a=new ee(e);for(s=1;s<e;++s)a[s]=a[s-
1]+o[s-1]<<1;var i;if(t){i=new ee(1<<e);var l=15-e;for(s=0;s<n;++s)if(r[s])for(var c=s<<4|r[s],h=e-r[s],u=a[r[s]-1]++<<h,m=u|(1<<h)-1;u<=m;++u)i[sn[u]>>l]=c}else
for(i=new ee(n),s=0;s<n;++s)r[s]&&(i[s]=sn[a[r[s]-1]++]>>15-r[s]);return i}),we=new $(288);for(E=0;E<144;++E)we[E]=8;var E;for(E=144;E<256;++E)we[E]=9;var E;for(E=
256;E<280;++E)we[E]=7;var E;for(E=280;E<288;++E)we[E]=8;var E,ht=new $(32);for(E=0;E<32;++E)ht[E]=5;var E,Si=ue(we,9,0),Ai=ue(we,9,1),Mi=ue(ht,5,0),Ti=ue(ht,5,1),
Qr=function(r){for(var e=r[0],t=1;t<r.length;++t)r[t]>e&&(e=r[t]);return e},ie=function(r,e,t){var n=e/8|0;return(r[n]|r[n+1]<<8)>>(e&7)&t},en=function(r,e){var t=e/
8|0;return(r[t]|r[t+1]<<8|r[t+2]<<16)>>(e&7)},cn=function(r){return(r+7)/8|0},un=function(r,e,t){return(e==null||e<0)&&(e=0),(t==null||t>r.length)&&(t=r.length),
new $(r.subarray(e,t))};var Ei=["unexpected EOF","invalid block type","invalid length/literal","invalid distance","stream finished","no stream handler",,"no callback","invalid UTF-8 da\
ta","extra field too long","date not in range 1980-2099","filename too long","stream finishing","invalid zip data"],q=function(r,e,t){var n=new Error(e||Ei[r]);
if(n.code=r,Error.captureStackTrace&&Error.captureStackTrace(n,q),!t)throw n;return n},Ci=function(r,e,t,n){var s=r.length,o=n?n.length:0;if(!s||e.f&&!e.l)return t||
new $(0);var a=!t,i=a||e.i!=2,l=e.i;a&&(t=new $(s*3));var c=function(et){var tt=t.length;if(et>tt){var We=new $(Math.max(tt*2,et));We.set(t),t=We}},h=e.f||0,u=e.
p||0,m=e.b||0,p=e.l,g=e.d,f=e.m,y=e.n,v=s*8;do{if(!p){h=ie(r,u,1);var S=ie(r,u+1,3);if(u+=3,S)if(S==1)p=Ai,g=Ti,f=9,y=5;else if(S==2){var I=ie(r,u,31)+257,N=ie(
r,u+10,15)+4,M=I+ie(r,u+5,31)+1;u+=14;for(var x=new $(M),U=new $(19),F=0;F<N;++F)U[rn[F]]=ie(r,u+F*3,7);u+=N*3;for(var B=Qr(U),ge=(1<<B)-1,Z=ue(U,B,1),F=0;F<M;){
var V=Z[ie(r,u,ge)];u+=V&15;var w=V>>4;if(w<16)x[F++]=w;else{var D=0,_=0;for(w==16?(_=3+ie(r,u,3),u+=2,D=x[F-1]):w==17?(_=3+ie(r,u,7),u+=3):w==18&&(_=11+ie(r,u,
127),u+=7);_--;)x[F++]=D}}var Y=x.subarray(0,I),W=x.subarray(I);f=Qr(Y),y=Qr(W),p=ue(Y,f,1),g=ue(W,y,1)}else q(1);else{var w=cn(u)+4,A=r[w-4]|r[w-3]<<8,O=w+A;if(O>
s){l&&q(0);break}i&&c(m+A),t.set(r.subarray(w,O),m),e.b=m+=A,e.p=u=O*8,e.f=h;continue}if(u>v){l&&q(0);break}}i&&c(m+131072);for(var Qe=(1<<f)-1,re=(1<<y)-1,me=u;;me=
u){var D=p[en(r,u)&Qe],J=D>>4;if(u+=D&15,u>v){l&&q(0);break}if(D||q(2),J<256)t[m++]=J;else if(J==256){me=u,p=null;break}else{var X=J-254;if(J>264){var F=J-257,P=zt[F];
X=ie(r,u,(1<<P)-1)+Os[F],u+=P}var ce=g[en(r,u)&re],Ue=ce>>4;ce||q(3),u+=ce&15;var W=xi[Ue];if(Ue>3){var P=Bt[Ue];W+=en(r,u)&(1<<P)-1,u+=P}if(u>v){l&&q(0);break}
i&&c(m+131072);var De=m+X;if(m<W){var Rt=o-W,Ot=Math.min(W,De);for(Rt+m<0&&q(3);m<Ot;++m)t[m]=n[Rt+m]}for(;m<De;++m)t[m]=t[m-W]}}e.l=p,e.p=me,e.b=m,e.f=h,p&&(h=
1,e.m=f,e.d=g,e.n=y)}while(!h);return m!=t.length&&a?un(t,0,m):t.subarray(0,m)},fe=function(r,e,t){t<<=e&7;var n=e/8|0;r[n]|=t,r[n+1]|=t>>8},ct=function(r,e,t){
t<<=e&7;var n=e/8|0;r[n]|=t,r[n+1]|=t>>8,r[n+2]|=t>>16},tn=function(r,e){for(var t=[],n=0;n<r.length;++n)r[n]&&t.push({s:n,f:r[n]});var s=t.length,o=t.slice();if(!s)
return{t:$s,l:0};if(s==1){var a=new $(t[0].s+1);return a[t[0].s]=1,{t:a,l:1}}t.sort(function(O,I){return O.f-I.f}),t.push({s:-1,f:25001});var i=t[0],l=t[1],c=0,
h=1,u=2;for(t[0]={s:-1,f:i.f+l.f,l:i,r:l};h!=s-1;)i=t[t[c].f<t[u].f?c++:u++],l=t[c!=h&&t[c].f<t[u].f?c++:u++],t[h++]={s:-1,f:i.f+l.f,l:i,r:l};for(var m=o[0].s,n=1;n<
s;++n)o[n].s>m&&(m=o[n].s);var p=new ee(m+1),g=on(t[h-1],p,0);if(g>e){var n=0,f=0,y=g-e,v=1<<y;for(o.sort(function(I,N){return p[N.s]-p[I.s]||I.f-N.f});n<s;++n){
var S=o[n].s;if(p[S]>e)f+=v-(1<<g-p[S]),p[S]=e;else break}for(f>>=y;f>0;){var w=o[n].s;p[w]<e?f-=1<<e-p[w]++-1:++n}for(;n>=0&&f;--n){var A=o[n].s;p[A]==e&&(--p[A],
++f)}g=e}return{t:new $(p),l:g}},on=function(r,e,t){return r.s==-1?Math.max(on(r.l,e,t+1),on(r.r,e,t+1)):e[r.s]=t},Ms=function(r){for(var e=r.length;e&&!r[--e];)
;for(var t=new ee(++e),n=0,s=r[0],o=1,a=function(l){t[n++]=l},i=1;i<=e;++i)if(r[i]==s&&i!=e)++o;else{if(!s&&o>2){for(;o>138;o-=138)a(32754);o>2&&(a(o>10?o-11<<5|
28690:o-3<<5|12305),o=0)}else if(o>3){for(a(s),--o;o>6;o-=6)a(8304);o>2&&(a(o-3<<5|8208),o=0)}for(;o--;)a(s);o=1,s=r[i]}return{c:t.subarray(0,n),n:e}},ut=function(r,e){
for(var t=0,n=0;n<e.length;++n)t+=r[n]*e[n];return t},Ps=function(r,e,t){var n=t.length,s=cn(e+2);r[s]=n&255,r[s+1]=n>>8,r[s+2]=r[s]^255,r[s+3]=r[s+1]^255;for(var o=0;o<
n;++o)r[s+o+4]=t[o];return(s+4+n)*8},Ts=function(r,e,t,n,s,o,a,i,l,c,h){fe(e,h++,t),++s[256];for(var u=tn(s,15),m=u.t,p=u.l,g=tn(o,15),f=g.t,y=g.l,v=Ms(m),S=v.c,
w=v.n,A=Ms(f),O=A.c,I=A.n,N=new ee(19),M=0;M<S.length;++M)++N[S[M]&31];for(var M=0;M<O.length;++M)++N[O[M]&31];for(var x=tn(N,7),U=x.t,F=x.l,B=19;B>4&&!U[rn[B-1]];--B)
;var ge=c+5<<3,Z=ut(s,we)+ut(o,ht)+a,V=ut(s,m)+ut(o,f)+a+14+3*B+ut(N,U)+2*N[16]+3*N[17]+7*N[18];if(l>=0&&ge<=Z&&ge<=V)return Ps(e,h,r.subarray(l,l+c));var D,_,Y,
W;if(fe(e,h,1+(V<Z)),h+=2,V<Z){D=ue(m,p,0),_=m,Y=ue(f,y,0),W=f;var Qe=ue(U,F,0);fe(e,h,w-257),fe(e,h+5,I-1),fe(e,h+10,B-4),h+=14;for(var M=0;M<B;++M)fe(e,h+3*M,
U[rn[M]]);h+=3*B;for(var re=[S,O],me=0;me<2;++me)for(var J=re[me],M=0;M<J.length;++M){var X=J[M]&31;fe(e,h,Qe[X]),h+=U[X],X>15&&(fe(e,h,J[M]>>5&127),h+=J[M]>>12)}}else
D=Si,_=we,Y=Mi,W=ht;for(var M=0;M<i;++M){var P=n[M];if(P>255){var X=P>>18&31;ct(e,h,D[X+257]),h+=_[X+257],X>7&&(fe(e,h,P>>23&31),h+=zt[X]);var ce=P&31;ct(e,h,Y[ce]),
h+=W[ce],ce>3&&(ct(e,h,P>>5&8191),h+=Bt[ce])}else ct(e,h,D[P]),h+=_[P]}return ct(e,h,D[256]),h+_[256]},ki=new ln([65540,131080,131088,131104,262176,1048704,1048832,
2114560,2117632]),$s=new $(0),Ri=function(r,e,t,n,s,o){var a=o.z||r.length,i=new $(n+a+5*(1+Math.ceil(a/7e3))+s),l=i.subarray(n,i.length-s),c=o.l,h=(o.r||0)&7;if(e){
h&&(l[0]=o.r>>3);for(var u=ki[e-1],m=u>>13,p=u&8191,g=(1<<t)-1,f=o.p||new ee(32768),y=o.h||new ee(g+1),v=Math.ceil(t/3),S=2*v,w=function(Fr){return(r[Fr]^r[Fr+1]<<
v^r[Fr+2]<<S)&g},A=new ln(25e3),O=new ee(288),I=new ee(32),N=0,M=0,x=o.i||0,U=0,F=o.w||0,B=0;x+2<a;++x){var ge=w(x),Z=x&32767,V=y[ge];if(f[Z]=V,y[ge]=Z,F<=x){var D=a-
x;if((N>7e3||U>24576)&&(D>423||!c)){h=Ts(r,l,0,A,O,I,M,U,B,x-B,h),U=N=M=0,B=x;for(var _=0;_<286;++_)O[_]=0;for(var _=0;_<30;++_)I[_]=0}var Y=2,W=0,Qe=p,re=Z-V&32767;
if(D>2&&ge==w(x-re))for(var me=Math.min(m,D)-1,J=Math.min(32767,x),X=Math.min(258,D);re<=J&&--Qe&&Z!=V;){if(r[x+Y]==r[x+Y-re]){for(var P=0;P<X&&r[x+P]==r[x+P-re];++P)
;if(P>Y){if(Y=P,W=re,P>me)break;for(var ce=Math.min(re,P-2),Ue=0,_=0;_<ce;++_){var De=x-re+_&32767,Rt=f[De],Ot=De-Rt&32767;Ot>Ue&&(Ue=Ot,V=De)}}}Z=V,V=f[Z],re+=
Z-V&32767}if(W){A[U++]=268435456|nn[Y]<<18|As[W];var et=nn[Y]&31,tt=As[W]&31;M+=zt[et]+Bt[tt],++O[257+et],++I[tt],F=x+Y,++N}else A[U++]=r[x],++O[r[x]]}}for(x=Math.
max(x,F);x<a;++x)A[U++]=r[x],++O[r[x]];h=Ts(r,l,c,A,O,I,M,U,B,x-B,h),c||(o.r=h&7|l[h/8|0]<<3,h-=7,o.h=y,o.p=f,o.i=x,o.w=F)}else{for(var x=o.w||0;x<a+c;x+=65535){
var We=x+65535;We>=a&&(l[h/8|0]=c,We=a),h=Ps(l,h+1,r.subarray(x,We))}o.i=a}return un(i,0,n+cn(h)+s)},Oi=(function(){for(var r=new Int32Array(256),e=0;e<256;++e){
for(var t=e,n=9;--n;)t=(t&1&&-306674912)^t>>>1;r[e]=t}return r})(),_i=function(){var r=-1;return{p:function(e){for(var t=r,n=0;n<e.length;++n)t=Oi[t&255^e[n]]^t>>>
8;r=t},d:function(){return~r}}};var Pi=function(r,e,t,n,s){if(!s&&(s={l:1},e.dictionary)){var o=e.dictionary.subarray(-32768),a=new $(o.length+r.length);a.set(o),a.set(r,o.length),r=a,s.w=o.length}
return Ri(r,e.level==null?6:e.level,e.mem==null?s.l?Math.ceil(Math.max(8,Math.min(13,Math.log(r.length)))*1.5):20:12+e.mem,t,n,s)},Ns=function(r,e){var t={};for(var n in r)
t[n]=r[n];for(var n in e)t[n]=e[n];return t};var z=function(r,e,t){for(;t;++e)r[e]=t,t>>>=8};var $i=function(r,e){return((r[0]&15)!=8||r[0]>>4>7||(r[0]<<8|r[1])%31)&&q(6,"invalid zlib data"),(r[1]>>5&1)==+!e&&q(6,"invalid zlib data: "+(r[1]&32?"need":"u\
nexpected")+" dictionary"),(r[1]>>3&4)+2};function Ni(r,e){return Pi(r,e||{},0,0)}function Ls(r,e){return Ci(r.subarray($i(r,e&&e.dictionary),-4),{i:2},e&&e.out,e&&e.dictionary)}var Is=function(r,e,t,n){for(var s in r){var o=r[s],a=e+s,i=n;Array.isArray(o)&&(i=Ns(n,o[1]),o=o[0]),o instanceof $?t[a]=[o,i]:(t[a+="/"]=[new $(0),i],Is(o,a,t,
n))}},Es=typeof TextEncoder<"u"&&new TextEncoder,Li=typeof TextDecoder<"u"&&new TextDecoder,Ii=0;try{Li.decode($s,{stream:!0}),Ii=1}catch{}function Re(r,e){if(e){for(var t=new $(r.length),n=0;n<r.length;++n)t[n]=r.charCodeAt(n);return t}if(Es)return Es.encode(r);for(var s=r.length,o=new $(r.length+
(r.length>>1)),a=0,i=function(h){o[a++]=h},n=0;n<s;++n){if(a+5>o.length){var l=new $(a+8+(s-n<<1));l.set(o),o=l}var c=r.charCodeAt(n);c<128||e?i(c):c<2048?(i(192|
c>>6),i(128|c&63)):c>55295&&c<57344?(c=65536+(c&1047552)|r.charCodeAt(++n)&1023,i(240|c>>18),i(128|c>>12&63),i(128|c>>6&63),i(128|c&63)):(i(224|c>>12),i(128|c>>
6&63),i(128|c&63))}return un(o,0,a)}var an=function(r){var e=0;if(r)for(var t in r){var n=r[t].length;n>65535&&q(9),e+=n+4}return e},Cs=function(r,e,t,n,s,o,a,i){var l=n.length,c=t.extra,h=i&&i.length,
u=an(c);z(r,e,a!=null?33639248:67324752),e+=4,a!=null&&(r[e++]=20,r[e++]=t.os),r[e]=20,e+=2,r[e++]=t.flag<<1|(o<0&&8),r[e++]=s&&8,r[e++]=t.compression&255,r[e++]=
t.compression>>8;var m=new Date(t.mtime==null?Date.now():t.mtime),p=m.getFullYear()-1980;if((p<0||p>119)&&q(10),z(r,e,p<<25|m.getMonth()+1<<21|m.getDate()<<16|m.
getHours()<<11|m.getMinutes()<<5|m.getSeconds()>>1),e+=4,o!=-1&&(z(r,e,t.crc),z(r,e+4,o<0?-o-2:o),z(r,e+8,t.size)),z(r,e+12,l),z(r,e+14,u),e+=16,a!=null&&(z(r,e,
h),z(r,e+6,t.attrs),z(r,e+10,a),e+=14),r.set(n,e),e+=l,u)for(var g in c){var f=c[g],y=f.length;z(r,e,+g),z(r,e+2,y),r.set(f,e+4),e+=4+y}return h&&(r.set(i,e),e+=
h),e},Fi=function(r,e,t,n,s){z(r,e,101010256),z(r,e+8,t),z(r,e+10,t),z(r,e+12,n),z(r,e+16,s)};function Gt(r,e){e||(e={});var t={},n=[];Is(r,"",t,e);var s=0,o=0;for(var a in t){var i=t[a],l=i[0],c=i[1],h=c.level==0?0:8,u=Re(a),m=u.length,p=c.comment,g=p&&
Re(p),f=g&&g.length,y=an(c.extra);m>65535&&q(11);var v=h?Ni(l,c):l,S=v.length,w=_i();w.p(l),n.push(Ns(c,{size:l.length,crc:w.d(),c:v,f:u,m:g,u:m!=a.length||g&&p.
length!=f,o:s,compression:h})),s+=30+m+y+S,o+=76+2*(m+y)+(f||0)+S}for(var A=new $(o+22),O=s,I=o-s,N=0;N<n.length;++N){var u=n[N];Cs(A,u.o,u,u.f,u.u,u.c.length);
var M=30+u.f.length+an(u.extra);A.set(u.c,u.o+M),Cs(A,s,u,u.f,u.u,u.c.length,u.o,u.m),s+=16+M+(u.m?u.m.length:0)}return Fi(A,s,n.length,I,O),A}var G=(r,e=2)=>r==null?"-":r.toFixed(e);function Fs(r,e,t){return e===null||t===null?G(r):`${G(r)} (${G(e)} to ${G(t)})`}function je(r){let e=Math.abs(r),t=e>=1e4?
e.toExponential(0):e.toFixed(e<100?2:0);return r<0&&Number(t)?`−${t}`:t}var Ht=r=>r.charAt(0).toUpperCase()+r.slice(1);function dt(r,e,t,n=!1){let s=(e-r)/Math.max(1,t),o=10**Math.floor(Math.log10(s||1)),a=[1,2,5,10].map(c=>c*o).find(
c=>c>=s)??10*o;n&&(a=Math.max(1,Math.round(a)));let i=Math.ceil(r/a-1e-9),l=Math.floor(e/a+1e-9);return Array.from({length:Math.max(0,l-i+1)},(c,h)=>(i+h)*a)}var Ui={teams:{pursuer:"pursuers",evader:"evaders"},generation:{pursuer:"pursuer generation",evader:"evader generation"},score:"capture rate",means:{pursuer:"ca\
ptures",evader:"escapes"},curves:{pursuer:"captures",evader:"escapes"},ends:["0 all escape","1 all caught"],lead:"Each cell is a match between two generations: \
the brighter, the more evaders are captured. Click one to watch it.",click:"watch its match"},Di=([r,e])=>({teams:{pursuer:r,evader:e},generation:{pursuer:`gene\
ration of ${r}`,evader:`generation of ${e}`},score:`score of the ${r}`,means:{pursuer:r,evader:e},curves:{pursuer:"scores",evader:"scores"},ends:[`0 the ${e} wi\
n`,`1 the ${r} win`],lead:`Each cell is a pair of generations: the brighter, the higher the score of the ${r}. Click one to see more of it.`,click:"see more of \
it"}),xe=({game:r})=>r?Di(r.teams):Ui,te=(r,e,t)=>`${xe(r).teams[e]} of generation ${t}`,Wi=200;function Us(r,e,{pursuer:t,evader:n},s){let{text:o,image:a}=e.shows[`${t}\
 ${n}`]??{},i=Se(r,t,n)?.rates??[],l=`Scores of the ${e.teams[0]} in ${i.length} episodes: ${i.map(c=>G(c)).join(", ")}`;return[o===void 0?null:d("pre",{tabindex:0,
"aria-label":"What the game shows of this pair"},o),a===void 0?null:d("img",{src:a,alt:"What the game shows of this pair",onload:({target:c})=>c.classList.toggle(
"pixels",c.naturalWidth<Wi)}),...(o??a)===void 0?[d("p",{class:"muted"},e.missing),zi(r,e,t,n,s)]:[],i.length>1?d("p",{class:"small numbers"},l):null].filter(c=>c!==
null)}function zi(r,e,t,n,s){let o=Object.keys(e.shows).map(h=>h.split(" ").map(Number)),a=([h,u])=>(h-t)**2+(u-n)**2,[i,l]=o.sort((h,u)=>a(h)-a(u))[0]??[];if(i===
void 0||l===void 0)return null;let c=`${te(r,"pursuer",i)} against ${te(r,"evader",l)}`;return d("p",{},d("button",{type:"button",onclick:()=>s.select({pursuer:i,
evader:l})},`Nearest: ${c}`))}var Oe=["pursuer","evader"];function Se(r,e,t){let[n,s]=[e-r.payoff.first[0],t-r.payoff.first[1]],o=r.payoff.capture_rate[n]?.[s];return o===void 0?null:{rate:o,rates:r.payoff.capture_rates[n][s],
lengths:r.payoff.lengths[n]?.[s]??[]}}function jt(r,e,t){let{script:n,policy:s,kept:o,genomes:a}=r.teams[e];if(n!==null||s===null)return"";if(!o.includes(t))return`\
The page holds no genome of ${te(r,e,t)}: it would be too large. Choose a generation of ${o.join(", ")}.`;let i=o.length*s.genome_size;return Gs(a,s.genome_size).
length===i?"":`The page is damaged: it does not hold the ${i} numbers of the ${e}s' genomes. Write it again from its run.`}function se(r,e,t){let{script:n,policy:s,
kept:o,genomes:a}=r.teams[e];if(n!==null||s===null)return n??"random";let i=o.indexOf(t);if(i<0)throw new RangeError(`${e}: expected a generation whose genome t\
he page holds, got ${t}`);let l=s.genome_size,c=Gs(a,l).subarray(i*l,(i+1)*l);return{...s,genome:c}}var Ds=({teams:r},e)=>(r[e].policy??{kind:"cells"}).kind!=="\
cells",Ws=({teams:r},e,t)=>r[e].expressions?.[r[e].kept.indexOf(t)]??"";function zs(r,e,{pursuer:t,evader:n,episode:s,seed:o}){let a=e.seeds[t][n];return r.match(
e.world,se(e,"pursuer",t),se(e,"evader",n),BigInt(o??a),s)}var hn=4,dn=new Map,Bs=(r,e)=>{dn.set(r,e)};function Gs(r,e){let t=dn.get(r);if(t)return t;let n=new Float32Array;
try{let s=Gi(mn(r),e);s.every(Number.isFinite)&&(n=s)}catch(s){if(!(s instanceof DOMException||s instanceof RangeError||Bi(s)))throw s}return dn.set(r,n),n}var Bi=r=>r instanceof
Error&&"code"in r;function Gi(r,e){let t=Ls(r),n=t.length/hn,s=new Uint8Array(t.length);for(let a=0;a<s.length;a++)s[a]=t[a%hn*n+Math.floor(a/hn)];let o=new Uint32Array(
s.buffer);for(let a=e;a<o.length;a++)o[a]^=o[a-e];return new Float32Array(s.buffer)}function mn(r){let e=atob(Ae(r)),t=new Uint8Array(e.length);for(let n=0;n<t.
length;n++)t[n]=e.charCodeAt(n);return t}var Ae=r=>document.getElementById(r)?.textContent??"";var Hs=()=>JSON.parse(Ae("data")),mt={"specialist-specialist":"Specialists: both teams meet only the newest opponent","generalist-specialist":"Pursuers meet all\
 earlier evaders, evaders only the newest pursuers","generalist-generalist":"Generalists: both teams meet all earlier opponents","hall-of-fame":"Halls of fame: \
both teams learn at once, and meet earlier champions"};function _e({schedule:r}){if(r.kind==="hall-of-fame")return r.kind;let e={latest:"specialist","round-robi\
n":"generalist",uniform:"uniform"};return`${e[r.pursuers_meet]}-${e[r.evaders_meet]}`}var Vt=r=>mt[_e(r)]??_e(r);var Yt=10,Kt=999999,pn=[3,5,7,9,11],qt=5,fn=[8,16,32,64],yn=[6,10,30,60,90,120];function Hi(r){let e=Object.values(r.races.es).find(a=>_e(a)==="generalist-gener\
alist"),{n_pursuers:t,n_evaders:n,fov:s,max_steps:o}=e.world;return{schedule:_e(e),beside:null,learner:"es",ratings:!1,seed:e.seed,way:!1,population:0,pursuers:t,
evaders:n,view:s,steps:o,walls:[]}}var Zt=r=>Object.values(r.races.es)[0].world;function Jt(r,e,t=e.schedule){let n=r.races[e.learner][t],s=Zt(r),o={...s,n_pursuers:e.
pursuers,n_evaders:e.evaders,fov:e.view,max_steps:e.steps,obstacles:e.walls.length?Ss(e.walls,s.rows,s.cols):s.obstacles};return{...n,world:o,train_steps:e.steps,
seed:e.seed,policy:e.ratings?{...r.ratings,mask:e.way?"right-of-way":"obstacles"}:{...n.policy,mask:e.way?"right-of-way":"none"},learner:{...n.learner,population:e.
population||n.learner.population}}}function Xt({walls:r,pursuers:e,evaders:t},{rows:n,cols:s}){let o=new Set(Array.from({length:n*s},(i,l)=>l).filter(i=>!r.includes(
i)));if(o.size<e+t)return`There is no room: ${e+t} agents need a free cell each.`;let a=[Math.min(...o)];o.delete(a[0]);for(let i of a){let l=i%s,c=[i-s,i+s,...l>
0?[i-1]:[],...l<s-1?[i+1]:[]];a.push(...c.filter(h=>o.delete(h)))}return o.size?"Nobody may be walled in: all free cells have to be connected, side by side.":""}
function js(r){let{walls:e,way:t,ratings:n,beside:s,...o}=r,a={...o,...s?{beside:s}:{},...t?{way:1}:{},...n?{ratings:1}:{},...e.length?{walls:e.join(".")}:{}};return Object.
entries(a).map(([i,l])=>`${i}=${l}`).join("&")}function Vs(r,e){let t=new URLSearchParams(e.replace(/^#/,"")),n=Hi(r),s=(u,m)=>{let p=t.get(u)??"";return/^\d{1,6}$/.
test(p)&&m(Number(p))?Number(p):n[u]},o=u=>Object.hasOwn(mt,t.get(u)??"")?t.get(u):null,a=Zt(r),i=(t.get("walls")??"").split(".").filter(u=>/^\d{1,4}$/.test(u)).
map(Number),l=s("view",u=>pn.includes(u)),c=t.get("way")==="1",h={schedule:o("schedule")??n.schedule,beside:o("beside"),learner:t.get("learner")==="ga"?"ga":n.learner,
ratings:t.get("ratings")==="1",seed:s("seed",u=>u<=Kt),pursuers:s("pursuers",u=>u>=1&&u<=Yt),evaders:s("evaders",u=>u>=1&&u<=Yt),view:c?Math.max(qt,l):l,way:c,population:s(
"population",u=>fn.includes(u)),steps:s("steps",u=>yn.includes(u)),walls:i.filter(u=>u<a.rows*a.cols).reduce((u,m)=>Wt(u,m,!0),[])};return Xt(h,a)?{...h,walls:[]}:
h}function le(r,e,t,n=""){return d("label",{class:`field ${n}`,title:e},d("span",{class:"field-name"},r),t,d("span",{class:"about small muted"},e))}function Ys(r){
let e=Object.entries(mt),t=ne(e,y=>r({schedule:y})),n=ne([["","Nothing"],...e],y=>r({beside:y||null},!0)),s=Array.from({length:Yt},(y,v)=>[v+1,String(v+1)]),o=ne(
s,y=>r({pursuers:Number(y)})),a=ne(s,y=>r({evaders:Number(y)})),i=ne(pn.map(y=>[y,`${y} x ${y}`]),y=>r({view:Number(y),...Number(y)<qt?{way:!1}:{}})),l=d("input",
{type:"checkbox",onchange:()=>r({way:l.checked,...l.checked?{view:Math.max(qt,Number(i.value))}:{}})}),c=ne([[0,"usual"],...fn.map(y=>[y,String(y)])],y=>r({population:Number(
y)})),h=ne(yn.map(y=>[y,String(y)]),y=>r({steps:Number(y)})),u=ne([["es","evolution strategy"],["ga","genetic algorithm"]],y=>r({learner:y},!0)),m=ne([["","a ne\
twork over the cells of its view"],["1","weights of named inputs"]],y=>r({ratings:y==="1"},!0)),p=d("input",{type:"number",min:0,max:Kt,step:1,inputmode:"numeri\
c"});p.addEventListener("change",()=>r({seed:Math.min(Kt,Math.max(0,Math.round(Number(p.value))||0))},!0));let g=d("button",{type:"button",onclick:()=>r({seed:Math.
floor(Math.random()*1e3)},!0)},"Another seed"),f=(y,...v)=>d("section",{class:"card controls","aria-label":y},d("fieldset",{},d("legend",{},y),...v));return{now:f(
"Change it while it evolves",le("Opponents","whom the teams meet while they learn",t,"wide"),le("Pursuers","triangles",o),le("Evaders","discs",a),le("View","cel\
ls that an agent sees around itself",i),le("Right of way","agents never take a move that could put them at fault",d("span",{},l)),le("Population","candidates th\
at are compared at a time",c),le("Steps","of a match",h)),anew:f("Begin anew",le("Side by side with","a second race of the same seed",n,"wide"),le("Learner","ho\
w a team learns",u,"half"),le("What evolves","what an agent decides by",m,"half"),le("Seed","the luck of the race",d("span",{class:"seed"},p,g),"half")),show:y=>{
[t.value,n.value,i.value,u.value]=[y.schedule,y.beside??"",String(y.view),y.learner],[c.value,h.value,p.value,l.checked]=[String(y.population),String(y.steps),String(
y.seed),y.way],m.value=y.ratings?"1":"",[o.value,a.value]=[String(y.pursuers),String(y.evaders)]}}}var Qt={left:46,right:12,top:10,bottom:42},Ks={x:56,y:34};function Zs(r,e,t,n){let[s,o]=[Qt.left,Qt.top],a=Math.max(s+40,r-Qt.right),i=Math.max(o+40,e-Qt.bottom),
l=(f,y,v)=>S=>y+(S-f.low)/(f.high-f.low||1)*(v-y),[c,h]=[l(t,s,a),l(n,i,o)],u=b("g"),m=b("svg",{width:r,height:e,viewBox:`0 0 ${r} ${e}`,class:"plot"}),p=b("g",
{class:"axes"});for(let f of dt(n.low,n.high,(i-o)/Ks.y,n.whole))p.append(b("line",{x1:s,x2:a,y1:h(f),y2:h(f),class:"grid"}),b("text",{x:s-8,y:h(f),"text-anchor":"\
end","dominant-baseline":"middle"},qs(f)));for(let f of dt(t.low,t.high,(a-s)/Ks.x,t.whole))p.append(b("text",{x:c(f),y:i+16,"text-anchor":"middle"},qs(f)));return p.
append(b("line",{x1:s,x2:a,y1:i,y2:i,class:"axis"}),b("text",{x:(s+a)/2,y:e-6,"text-anchor":"middle",class:"label"},t.label),b("text",{transform:`translate(12 ${(o+
i)/2}) rotate(-90)`,"text-anchor":"middle",class:"label"},n.label)),m.append(p,u),{root:m,marks:u,left:s,right:a,top:o,bottom:i,x:c,y:h,at:f=>{let y=f-m.getBoundingClientRect().
left;return t.low+(y-s)/(a-s)*(t.high-t.low)}}}var qs=r=>String(Number(r.toPrecision(6))).replace("-","−");function Js(r,e,t,n){let s="",o="M";t.forEach((a,i)=>{
a===null?o="M":(s+=`${o}${r.x(e[i]).toFixed(1)} ${r.y(a).toFixed(1)}`,o="L")}),r.root.insertBefore(b("path",{d:s,class:`line ${n}`}),r.marks)}function Xs(...r){return d("p",{class:"legend small"},...r.map(([e,t])=>d("span",{class:`key ${t}`},e)))}function Qs(r,e,t,n){let s=d("div",{class:"chart choose\
s",role:"img","aria-label":r}),o=null,a=()=>{o?.marks.replaceChildren(),o&&t(o)};s.addEventListener("click",l=>o&&n(o.at(l.clientX),o,l));let i=()=>{let{clientWidth:l,
clientHeight:c}=s;l<50||c<50||(o=e(l,c),s.replaceChildren(o.root),a())};return new ResizeObserver(i).observe(s),{element:s,update:a,redraw:i}}var Ve=[[0,0],[-1,0],[0,1],[1,0],[0,-1],[-1,1],[1,1],[1,-1],[-1,-1]];function eo(r,e,t){let[n,s]=[e[0]-r[0],e[1]-r[1]];return!t&&Math.abs(n)>Math.abs(s)?s=0:t||
(n=0),Ve.findIndex(([o,a])=>o===Math.sign(n)&&a===Math.sign(s))}var Pe=(r,e)=>e<r.nPursuers,k=(r,e)=>[r.positions[2*e],r.positions[2*e+1]],gn=({rows:r,cols:e},[
t,n])=>t>=0&&n>=0&&t<r&&n<e,vn=(r,e,t=3)=>r!==void 0&&[0,1,2].slice(0,t).some(n=>r[3*e+n]),bn=(r,e)=>vn(r.fault,e),to=(r,e)=>!bn(r,e)&&vn(r.involved,e,2);function er(r,e,t){
let[n,s]=[k(r,t),k(e,t)],o=n[0]!==s[0]||n[1]!==s[1],a=e.involved===void 0||vn(e.involved,t);return!!(e.alive[t]&&e.actions?.[t]&&!o&&a)}function tr(r,e,t){let[n,
s]=k(r,t),[o,a]=Ve[e.actions?.[t]??0];return[n+o,s+a]}function pt(r,e,t){return Array.from({length:t.everCaptured.length},(s,o)=>o).filter(s=>t.everCaptured[s]&&
!e.everCaptured[s]).map(s=>r.nPursuers+s)}var rr=r=>r.moments.flatMap((e,t)=>t&&pt(r,r.moments[t-1],e).length?[t]:[]);function nr(r,e){return Array.from({length:e.
alive.length},(n,s)=>s).filter(n=>r.alive[n]&&!e.alive[n])}var ro=[-.31,0,.31],no=[{size:1,at:[[0,0]]},{size:.62,at:[[-.2,.2],[.2,-.2]]},{size:.54,at:[[-.23,.22],[.23,.22],[0,-.22]]},{size:.54,at:[[-.23,.23],[.23,.23],[
-.23,-.23],[.23,-.23]]},{size:.36,at:ro.flatMap(r=>ro.map(e=>[e,r]))}],ji=.3,Vi=.35,Yi=.55;function ft(r,e){let t=new Map;for(let n=0;n<e.alive.length;n++){if(!e.
alive[n])continue;let[s,o]=k(e,n),a=s*r.cols+o,i=t.get(a);i?i.push(n):t.set(a,[n])}return t}function so(r,e){let t=Array.from(e.alive,(n,s)=>{let[o,a]=k(e,s);return{
x:a+.5,y:o+.5,size:1,alpha:0}});for(let n of ft(r,e).values()){let s=no[Math.min(n.length,no.length)-1];n.forEach((o,a)=>{let[i,l]=s.at[Math.min(a,s.at.length-1)],
c=t[o];c.x+=i,c.y+=l,c.size=s.size,c.alpha=1})}return t}var oo=r=>r*r*(3-2*r),Ye=(r,e,t)=>r+(e-r)*t,ao=r=>Math.min(1,Math.max(0,r));function io(r,e,t,n){let s={
SIMULTANEOUS:1,SWARM_TURNS:2,AGENT_TURNS:t}[r.interaction];if(s===1)return oo(n);let o=s===t?e:+!Pe(r,e),a=Math.max(1/s,Vi);return oo(ao((n-o/(s-1)*(1-a))/a))}function sr(r,e){
let t=r.moments.length-1,n=Math.min(Math.floor(e),t),s=r.moments[n],o=so(r,s);if(n===t||e===n)return o;let a=r.moments[n+1],i=so(r,a);return o.map((l,c)=>{let h=io(
r,c,o.length,e-n);return Ki(s,a,c,l,i[c],h)})}function wn(r,e,t){let n=r.moments.length-1,s=Math.min(Math.floor(t),n),[o,a]=[r.moments[s],r.moments[Math.min(s+1,
n)]],i=io(r,e,o.alive.length,t-s),[[l,c],[h,u]]=[k(o,e),k(a,e)];return[Ye(c,u,i)+.5,Ye(l,h,i)+.5]}function Ki(r,e,t,n,s,o){let a=n.alpha>s.alpha,i={x:Ye(n.x,s.x,
o),y:Ye(n.y,s.y,o),size:a?n.size:Ye(n.size,s.size,o),alpha:a?ao((1-o)/(1-Yi)):Ye(n.alpha,s.alpha,o)};if(er(r,e,t)){let[l,c]=k(r,t),[h,u]=tr(r,e,t),m=ji*Math.sin(
Math.PI*o);i.x+=(u-c)*m,i.y+=(h-l)*m}return i}var lo=2*Math.PI;function $e(r,e,t,n){r.beginPath(),r.arc(e,t,n/2,0,lo)}function or(r,e,t,n){let s=n/2,o=[[0,-.97],[.97,.83],[-.97,.83]].map(([a,i])=>[e+a*s,t+i*
s]);r.beginPath(),r.moveTo((o[2][0]+o[0][0])/2,(o[2][1]+o[0][1])/2),o.forEach(([a,i],l)=>{let[c,h]=o[(l+1)%3];r.arcTo(a,i,c,h,n*.09)}),r.closePath()}function co(r,e,t,n){
let s=n*.32;r.beginPath(),r.moveTo(e-s,t-s),r.lineTo(e+s,t+s),r.moveTo(e+s,t-s),r.lineTo(e-s,t+s)}function uo(r,e,t,n){r.beginPath();for(let s=0;s<16;s++){let o=n/
2*(s%2?.6:.95),a=lo*s/16;r.lineTo(e+o*Math.sin(a),t-o*Math.cos(a))}r.closePath()}function ho(r,e,t,n,s,o){let a=Math.atan2(s-t,n-e);r.beginPath(),r.moveTo(e,t),
r.lineTo(n,s);for(let i of[-1,1])r.moveTo(n,s),r.lineTo(n-o*Math.cos(a+i*.6),s-o*Math.sin(a+i*.6))}var mo=4,qi=1.6,Zi=.95,Ji=5,Xi=.16,Qi=9,el=.09,tl=.2,po=.75,H=(r,e)=>r.left+e*r.cell,j=(r,e)=>r.top+e*r.cell;function Ke(r,e,t){return Pe(e,t)?r.colors.pursuer:
r.colors.evader}function ar({ctx:r,colors:e},t,n,s,o,a,i=0){r.font=`700 ${Math.round(o)}px system-ui, sans-serif`,r.textAlign="center",r.textBaseline="middle",r.
strokeStyle=e.paper,r.lineWidth=i,i&&r.strokeText(t,n,s),r.fillStyle=a,r.fillText(t,n,s)}function fo({ctx:r,grid:e,colors:t}){let{left:n,top:s,cell:o,rows:a,cols:i}=e,
[l,c]=[i*o,a*o];if(r.fillStyle=t.paper,r.fillRect(n,s,l,c),o<Ji)return;r.fillStyle=t.line;let h=Math.max(1,Math.round(o/60));for(let u=1;u<i;u++)r.fillRect(n+u*
o,s,h,c);for(let u=1;u<a;u++)r.fillRect(n,s+u*o,l,h)}function yo({ctx:r,grid:e,colors:t},n){let{left:s,top:o,cell:a,rows:i,cols:l}=e;r.fillStyle=t.obstacle;for(let c=0;c<
i*l;c++){if(!n.obstacles[c])continue;let[h,u]=[Math.floor(c/l),c%l];r.fillRect(s+u*a,o+h*a,a,a)}go({ctx:r,grid:e,colors:t})}function go({ctx:r,grid:{left:e,top:t,
cell:n,rows:s,cols:o},colors:a}){let i=Math.min(5,Math.max(2,Math.round(n/18)));r.strokeStyle=a.frame,r.lineWidth=i,r.strokeRect(e-i/2,t-i/2,o*n+i,s*n+i)}function vo({
ctx:r,grid:e,colors:t},n){let{left:s,top:o,cell:a,rows:i,cols:l}=e,c=a<24*n?5:1;r.font=`500 ${Math.round(Math.min(15*n,Math.max(9*n,a*.32)))}px system-ui, sans-\
serif`,r.fillStyle=t.muted,r.textBaseline="alphabetic",r.textAlign="center";let h=5*n+a/40;for(let u=0;u<l;u+=c)r.fillText(String(u),s+(u+.5)*a,o-h);r.textAlign=
"right",r.textBaseline="middle";for(let u=0;u<i;u+=c)r.fillText(String(u),s-h,o+(u+.5)*a)}function bo({grid:r},e,t,n){let s=Math.floor(e.fov/2)+.5,[o,a]=[Math.max(
0,t-s),Math.min(r.cols,t+s)],[i,l]=[Math.max(0,n-s),Math.min(r.rows,n+s)];return[H(r,o),j(r,i),(a-o)*r.cell,(l-i)*r.cell]}function wo(r,e,t,n){let{ctx:s,grid:o,
colors:a}=r;s.save(),s.beginPath(),s.rect(0,0,s.canvas.width,s.canvas.height),s.rect(...bo(r,e,t,n)),s.clip("evenodd"),s.clearRect(0,0,s.canvas.width,s.canvas.height),
s.fillStyle=a.line,s.fillRect(o.left,o.top,o.cols*o.cell,o.rows*o.cell),s.restore(),go(r)}function xo(r,{x:e,y:t,alpha:n},s){let{ctx:o,grid:a,colors:i}=r,l=Math.
max(a.cell,16*s)*1.06,[c,h]=[H(a,e),j(a,t)];o.globalAlpha=Math.max(n,.6),o.beginPath(),o.roundRect(c-l/2,h-l/2,l,l,l*.2),o.strokeStyle=i.focus,o.lineWidth=Math.
max(2,2.5*s),o.stroke();let u=Math.max(11*s,Math.min(18*s,a.cell*.5)),m=h-l/2<u*1.2,p=h+(m?1:-1)*(l/2+u*.7);o.lineJoin="round",ar(r,"You",c,p,u,i.ink,u*.35),o.globalAlpha=
1}function So(r,e,t,n,s){let{ctx:o,grid:a}=r,i=bo(r,e,n,s),l=Ke(r,e,t);o.globalAlpha=.11,o.fillStyle=l,o.fillRect(...i),o.globalAlpha=.8,o.strokeStyle=l,o.lineWidth=
Math.max(1,a.cell/24),o.strokeRect(...i),o.globalAlpha=1}function Ao(r,e,t,n,s){let{ctx:o,grid:a}=r,i=Math.min(Math.ceil(t),e.moments.length-1),l=e.moments[i];o.
lineCap="round",o.lineWidth=Math.min(Qi,Math.max(1,a.cell*Xi));for(let c=Math.max(1,Math.floor(t-n)+1);c<=i;c++){let[h,u]=[e.moments[c-1],e.moments[c]],m=Math.max(
0,Math.min(1,(t-c)/n));o.globalAlpha=po+(tl-po)*m;for(let p=0;p<u.alive.length;p++){let g=c===i&&t<i;if(!h.alive[p]||!(l.alive[p]||g))continue;let f=(Pe(e,p)?-1:
1)*el,[y,v]=k(h,p),[S,w]=k(u,p);if(y===S&&v===w)continue;let A=g?s[p].x:w+.5,O=g?s[p].y:S+.5;o.strokeStyle=Ke(r,e,p),o.beginPath(),o.moveTo(H(a,v+.5+f),j(a,y+.5+
f)),o.lineTo(H(a,A+f),j(a,O+f)),o.stroke()}}o.globalAlpha=1}function Mo(r,e,t){let n=Math.min(Math.ceil(t),e.moments.length-1);for(let s=Math.max(1,n-mo+1);s<=n;s++){
let[o,a]=[e.moments[s-1],e.moments[s]],i=s>t?Math.max(0,1-2*(s-t)):1-(t-s)/mo,l=pt(e,o,a);for(let c of nr(o,a))l.includes(c)||nl(r,k(a,c),i);for(let c of l)rl(r,
k(a,c),i)}r.ctx.globalAlpha=1}function rl({ctx:r,grid:e,colors:t},[n,s],o){r.globalAlpha=o,uo(r,H(e,s+.5),j(e,n+.5),Math.max(8,e.cell*qi)),r.fillStyle=t.capture,
r.fill(),r.strokeStyle=t.ink,r.lineWidth=Math.max(1,e.cell/36),r.lineJoin="round",r.stroke()}function nl({ctx:r,grid:e,colors:t},[n,s],o){r.globalAlpha=o,co(r,H(
e,s+.5),j(e,n+.5),Math.max(7,e.cell*Zi)),r.strokeStyle=t.collision,r.lineWidth=Math.max(2,e.cell*.17),r.lineCap="round",r.stroke()}function To({ctx:r,grid:e,colors:t},n,s){
let o=Math.max(1,e.cell*.07);r.strokeStyle=r.fillStyle=t.collision,r.lineWidth=Math.max(1,e.cell*.05),r.setLineDash([e.cell*.14,e.cell*.1]);for(let[a,i]of n){if(a<
0||i<0||a>=e.rows||i>=e.cols)continue;let l=[H(e,i)+o,j(e,a)+o,e.cell-2*o,e.cell-2*o];r.globalAlpha=.2*s,r.fillRect(...l),r.globalAlpha=s,r.strokeRect(...l)}r.setLineDash(
[]),r.globalAlpha=1}function Eo({ctx:r,grid:e,colors:t},n,s,o,a){r.globalAlpha=a,$e(r,H(e,n),j(e,s),Math.max(8,e.cell*o*1.02)),r.strokeStyle=t.collision,r.lineWidth=
Math.max(1.5,e.cell*.085*Math.sqrt(o)),r.stroke(),r.globalAlpha=1}var sl=.8,ol=.92,al=15,il=7,xn=9;function Co(r,e,t,n,s,o){n.forEach((a,i)=>{a.alpha>0&&ll(r,e,t,i,a,s,o)}),r.ctx.globalAlpha=1;for(let a of ft(e,t).values())a.length>
xn&&cl(r,n[a[xn-1]],a.length-xn+1)}function ll(r,e,t,n,s,o,a){let{ctx:i,grid:l,colors:c}=r,h=Pe(e,n),[u,m]=[H(l,s.x),j(l,s.y)],p=Math.max(4,l.cell*s.size*(h?ol:
sl)),g=Ke(r,e,n),f=!h&&!!t.captured[n-e.nPursuers];if(i.globalAlpha=s.alpha,(h?or:$e)(i,u,m,p),p>il*a&&(i.strokeStyle=c.paper,i.lineWidth=Math.max(2,p*.1),i.stroke()),
i.fillStyle=f?c.paper:g,i.fill(),f&&($e(i,u,m,p*.82),i.strokeStyle=g,i.lineWidth=p*.18,i.stroke()),!o||p<al*a)return;let y=String(h?n:n-e.nPursuers),v=p*(h?.4:.5)*
(y.length>1?.8:1);ar(r,y,u,m+p*(h?.17:.03),v,f?g:c.paper)}function cl(r,e,t){let{cell:n}=r.grid;ar(r,`+${t}`,H(r.grid,e.x),j(r.grid,e.y),n*.3,r.colors.ink,n*.1)}var ul=.46,hl=.86,dl=.66,ko=.48,ml=.78,pl=.58;function Ro(r,e,t,n){let[s,o]=[e.moments[t-1],e.moments[t]];if(!s)return;let{ctx:a,grid:i,colors:l}=r;a.strokeStyle=
l.collision,a.lineWidth=Math.max(1.5,i.cell*.07),a.lineCap="butt",a.globalAlpha=n;for(let c=0;c<o.alive.length;c++)er(s,o,c)&&fl(r,e,k(s,c),tr(s,o,c));a.globalAlpha=
1}function fl({ctx:r,grid:e},t,n,s){let[o,a]=[s[1]-n[1],s[0]-n[0]],i=u=>H(e,n[1]+.5+o*u),l=u=>j(e,n[0]+.5+a*u),c=gn(t,s)?ml:pl;r.setLineDash([e.cell*.09,e.cell*
.06]),r.beginPath(),r.moveTo(i(ko),l(ko)),r.lineTo(i(c),l(c)),r.stroke(),r.setLineDash([]);let h=.17*e.cell/Math.hypot(o,a);r.beginPath(),r.moveTo(i(c)-a*h,l(c)+
o*h),r.lineTo(i(c)+a*h,l(c)-o*h),r.stroke()}function Oo(r,e,t,n,s,o){let a=Ve[o];if(!o||!a)return;let{ctx:i,grid:l,colors:c}=r,h=gn(e,[n[0]+a[0],n[1]+a[1]])?hl:
dl,u=ul*s.size,m=[H(l,s.x+a[1]*u),j(l,s.y+a[0]*u),H(l,s.x+a[1]*h),j(l,s.y+a[0]*h)],p=Math.max(1.5,l.cell*.085);i.lineCap=i.lineJoin="round";for(let[g,f]of[[c.paper,
p*2.1],[Ke(r,e,t),p]])i.strokeStyle=g,i.lineWidth=f,ho(i,...m,l.cell*.2),i.stroke()}var Po={numbers:!0,axes:!1,trail:6,viewers:[],plan:null,selected:null,cursor:null,you:null,fog:!1};function $o(r,e,t,n,s){let{ctx:o,grid:a,colors:i}=r,l=Math.min(
Math.ceil(t),e.moments.length-1),c=e.moments[l],h=t===l,u=sr(e,t),m=h?1:Math.max(0,1-2*(l-t));o.clearRect(0,0,o.canvas.width,o.canvas.height),fo(r);for(let f of n.
viewers)u[f]?.alpha&&So(r,e,f,...wn(e,f,t));yo(r,e),n.axes&&vo(r,s),Ao(r,e,t,n.trail,u),To(r,c.contested??[],m),Mo(r,e,t),Ro(r,e,l,m),u.forEach(({x:f,y,size:v},S)=>{
let w=to(c,S)?.4:0,A=bn(c,S)?1:w;A&&Eo(r,f,y,v,A*m)});let p=h?c:e.moments[Math.max(0,l-1)];if(Co(r,e,p,u,n.numbers,s),h&&n.plan)for(let[f,y]of u.entries())y.alpha&&
Oo(r,e,f,k(c,f),y,n.plan[f]??0);n.you!==null&&(n.fog&&wo(r,e,...wn(e,n.you,t)),xo(r,u[n.you],s)),o.lineWidth=Math.max(2,2.5*s),o.strokeStyle=i.focus;let g=n.selected===
null?void 0:u[n.selected];g?.alpha&&_o(r,g.x,g.y,g.size*.96),n.cursor&&(o.setLineDash([a.cell*.12,a.cell*.08]),_o(r,n.cursor[1]+.5,n.cursor[0]+.5,.8),o.setLineDash(
[]))}function _o({ctx:r,grid:e},t,n,s){let o=s*e.cell;r.beginPath(),r.roundRect(e.left+t*e.cell-o/2,e.top+n*e.cell-o/2,o,o,o*.1),r.stroke()}var No=(r,e)=>(e+.24)/(r+.24);function Lo(r,e,t,n,s,o){let a=t?28*o:0,i=(c,h)=>(c-a)/(h+2*.12),l=Math.max(1,Math.floor(Math.min(i(n,e),i(s,r))));return{rows:r,cols:e,
cell:l,left:Math.round((n-e*l+a)/2),top:Math.round((s-r*l+a)/2)}}function Io(r,e,t){let n=Math.floor((t-r.top)/r.cell),s=Math.floor((e-r.left)/r.cell);return n>=
0&&n<r.rows&&s>=0&&s<r.cols?[n,s]:null}var yl=["paper","line","frame","ink","muted","obstacle"],gl=["pursuer","evader","capture","collision","focus"];function ir(r){let e=getComputedStyle(r),t=(n,s)=>[
n,e.getPropertyValue(s+n).trim()];return Object.fromEntries([...yl.map(n=>t(n,"--board-")),...gl.map(n=>t(n,"--"))])}var ye=()=>matchMedia("(prefers-reduced-motion: reduce)").matches,Me=class{canvas;#e=null;#r=0;#t;#s={rows:1,cols:1,left:0,top:0,cell:1};#a=0;constructor(e,t={}){
this.canvas=e,e.classList.add("board"),e.setAttribute("role","img"),this.#t={...Po,...t},new ResizeObserver(()=>this.#l()).observe(e),new MutationObserver(()=>this.
redraw()).observe(document.documentElement,{attributes:!0}),addEventListener("beforeprint",()=>this.drawNow())}set look(e){this.#t={...this.#t,...e},this.#n(),this.
redraw()}show(e,t){this.#e=e,this.#r=Math.min(Math.max(0,t),e.moments.length-1),this.#n(),this.redraw()}redraw(){this.#a||(this.#a=requestAnimationFrame(()=>this.
drawNow()))}drawNow(){cancelAnimationFrame(this.#a),this.#a=0;let e=this.canvas.getContext("2d");if(!e||!this.#e)return;let{rows:t,cols:n}=this.#e,s=devicePixelRatio||
1;this.#s=Lo(t,n,this.#t.axes,this.canvas.width,this.canvas.height,s);let o={ctx:e,grid:this.#s,colors:ir(this.canvas)};$o(o,this.#e,this.#r,this.#t,s)}cellAt(e,t){
let n=this.canvas.getBoundingClientRect(),s=this.canvas.width/n.width;return Io(this.#s,(e-n.left)*s,(t-n.top)*s)}agentAt(e,t){let n=this.cellAt(e,t);if(!n||!this.#e)
return null;let s=this.#e.moments[Math.round(this.#r)],o=ft(this.#e,s).get(n[0]*this.#e.cols+n[1])??[],a=sr(this.#e,Math.round(this.#r)),i=l=>{let[c,h]=this.pointOf(
a[l].x,a[l].y);return Math.hypot(c-e,h-t)};return o.length?o.reduce((l,c)=>i(c)<i(l)?c:l):null}pointOf(e,t){let n=this.canvas.getBoundingClientRect(),s=n.width/
this.canvas.width,{left:o,top:a,cell:i}=this.#s;return[n.left+(o+e*i)*s,n.top+(a+t*i)*s]}#n(){if(!this.#e)return;let{rows:e,cols:t}=this.#e;this.canvas.style.setProperty(
"--board-aspect",String(No(e,t)))}#l(){let e=devicePixelRatio||1,{width:t,height:n}=this.canvas.getBoundingClientRect();this.canvas.width=Math.max(1,Math.round(
t*e)),this.canvas.height=Math.max(1,Math.round(n*e)),this.drawNow()}};function Sn(r,e,t){let{rows:n,cols:s,n_pursuers:o,fov:a,rules:{interaction:i}}=r;return{rows:n,cols:s,nPursuers:o,fov:a,interaction:i,obstacles:e,moments:t}}function An(r,e){
return{positions:r.read("last_positions"),alive:r.read("alive"),captured:r.read("captured"),everCaptured:r.read("ever_captured"),actions:e,involved:r.read("invo\
lved"),fault:r.read("fault"),contested:r.conflicts().map(t=>t.cell)}}function lr(r){let e=Array.from({length:r.length+1},(t,n)=>vl(r,n));return Sn(r.config,r.map,
e)}function vl(r,e){let t=r.n_agents,n=r.config.n_evaders,s=(a,i,l)=>a.subarray(i*l,(i+1)*l),o={positions:s(r.last_positions,e,2*t),alive:s(r.alive,e,t),captured:s(
r.captured,e,n),everCaptured:s(r.ever_captured,e,n)};return e===0?o:{...o,actions:s(r.actions,e-1,t),involved:s(r.involved,e-1,3*t),fault:s(r.fault,e-1,3*t),get contested(){
return r.conflicts(e).map(a=>a.cell)}}}var yt=[.5,1,2,4,8,16,32,64],cr=0,ur=12,bl=2,Te=class extends EventTarget{#e;#r;#t;#s=0;#a=0;#n=!1;#l=null;#d=0;#m=[];#i=[];glide=.28;constructor(e,{speed:t=4,still:n=!1}={}){
super(),[this.#e,this.#r,this.#t]=[e,t,n]}get step(){return this.#s}get time(){return this.#t?this.#s:this.#a}get arrived(){return this.#a===this.#s}get playing(){
return this.#n}get length(){return this.#e}set length(e){this.#e=e,this.#s>e&&this.jump(e),this.#o("state")}get marks(){return this.#m}set marks(e){this.#m=e,this.#o(
"state")}get ticks(){return this.#i}set ticks(e){this.#i=e,this.#o("state")}get pace(){return this.#r||Math.max(bl,this.#e/ur)}get speed(){return this.#r}set speed(e){
this.#r=e,this.#o("state")}changeSpeed(e){let t=yt.findIndex(n=>n>=this.pace);this.speed=yt[Math.min(yt.length-1,Math.max(0,t+e))]}play(){this.#n||!this.#e||(this.#s===
this.#e&&this.jump(0),this.#n=!0,this.#o("state"),this.#u())}pause(){this.#n&&(this.#n=!1,this.#o("state"))}toggle(){this.#n?this.pause():this.play()}move(e){this.
pause();let t=Math.min(this.#e,Math.max(0,this.#s+e));Math.abs(t-this.#a)>1?this.jump(t):this.#h(t),this.#u()}jump(e){this.#a=Math.min(this.#e,Math.max(0,Math.round(
e))),this.#h(this.#a),this.#o("frame")}#h(e){e!==this.#s&&(this.#s=e,this.#o("step"),this.#t&&this.#o("frame"))}#u(){this.#l===null&&(this.#d=performance.now(),
this.#l=requestAnimationFrame(()=>this.#c()))}#c(){this.#l=null;let e=performance.now();this.#p(Math.min(.25,(e-this.#d)/1e3)),this.#d=e,(!this.#t||this.arrived)&&
this.#o("frame"),(this.#n||this.#a!==this.#s)&&(this.#l=requestAnimationFrame(()=>this.#c()))}#p(e){let t=e;for(;t>0;){if(this.#a===this.#s){if(!this.#n)return;
if(this.#s===this.#e)return this.pause();this.#h(this.#s+1)}let n=this.#n?this.pace:1/this.glide,s=this.#s-this.#a,o=Math.min(Math.abs(s),t*n);t-=o/n,this.#a=o===
Math.abs(s)?this.#s:this.#a+Math.sign(s)*o}this.#n&&this.#a===this.#e&&this.pause()}#o(e){this.dispatchEvent(new Event(e))}};function hr(r,e){if(e.ctrlKey||e.metaKey||
e.altKey)return!1;let t=e.shiftKey?10:1,s={" ":()=>r.toggle(),ArrowRight:()=>r.move(t),ArrowLeft:()=>r.move(-t),Home:()=>r.move(-r.length),End:()=>r.move(r.length),
"+":()=>r.changeSpeed(1),"-":()=>r.changeSpeed(-1)}[e.key];return s?.(),s!==void 0}var wl={first:"M6 5v14M19 5 9 12l10 7z",back:"M17 5 7 12l10 7z",play:"M7 4.5 19 12 7 19.5z",pause:"M8 5v14M16 5v14",forward:"M7 5l10 7-10 7z",last:"M18 5v14M5 5\
l10 7-10 7z"};function Fo(r){return b("svg",{viewBox:"0 0 24 24","aria-hidden":"true",class:"icon"},b("path",{d:wl[r]}))}function gt(r,e,t,n){return d("button",
{type:"button",class:"player-button","aria-label":e,title:`${e} (${t})`,onclick:n},Fo(r))}function dr(r){let e=gt("play","Play","Space",()=>r.toggle()),t=d("inp\
ut",{type:"range",class:"player-scrub",min:0,step:1,"aria-label":"Step",oninput:()=>{r.pause(),r.jump(Number(t.value))}}),n=d("div",{class:"captures","aria-hidd\
en":"true",title:"Captures"}),s=d("div",{class:"losses","aria-hidden":"true"}),o=d("select",{class:"player-speed","aria-label":"Speed",title:`Steps a second, or\
 the whole in ${ur} s (+ and -)`,onchange:()=>r.speed=Number(o.value)},d("option",{value:cr},`in ${ur} s`),...yt.map(u=>d("option",{value:u},`${u} / s`))),a=d("\
output",{class:"player-count"}),i=d("div",{class:"player",role:"group","aria-label":"Player"},gt("first","First step","Home",()=>r.move(-r.length)),gt("back","S\
tep back","←",()=>r.move(-1)),e,gt("forward","Step forward","→",()=>r.move(1)),gt("last","Last step","End",()=>r.move(r.length)),d("div",{class:"scrub"},n,s,
t),a,o),l=(u,m={})=>{let p=d("i",m);return p.style.left=`${100*u/Math.max(1,r.length)}%`,p},c=()=>{n.replaceChildren(...r.marks.map(u=>l(u))),s.replaceChildren(
...r.ticks.map(({step:u,kind:m,size:p,text:g})=>{let f=l(u,{class:m,title:`Step ${u}: ${g}`});return f.style.height=`${100*p}%`,f}))},h=()=>{e.replaceChildren(Fo(
r.playing?"pause":"play")),e.ariaLabel=r.playing?"Pause":"Play",e.title=`${e.ariaLabel} (Space)`,t.max=String(r.length),t.value=String(r.step),t.ariaValueText=`\
step ${r.step} of ${r.length}`,a.textContent=`${r.step} / ${r.length}`,a.style.minWidth=`${2*String(r.length).length+3}ch`,o.value=String(r.speed)};return r.addEventListener(
"step",h),r.addEventListener("state",h),r.addEventListener("state",c),i.addEventListener("keydown",u=>{!(u.target instanceof HTMLSelectElement||u.key===" "&&u.target!==
t)&&hr(r,u)&&u.preventDefault()}),h(),i}var xl=40,mr=class{element;#e;#r=d("div",{class:"episodes",role:"group","aria-label":"Episodes of this cell"});#t=d("p",{class:"check small numbers","aria-live":"\
polite"});constructor(e){this.#e=e,this.element=d("div",{class:"strip-of-episodes"},this.#r,this.#t)}show(e,t){let{pursuer:n,evader:s,episode:o,seed:a}=this.#e.
selected,i=Se(e,n,s);this.#r.replaceChildren(...(i?.rates??[]).slice(0,xl).map((m,p)=>this.#s(m,p)));let l=a===null?i?.rates[o]:void 0,c=t.statistics.capture_rate,
h=l!==void 0&&Math.abs(c-l)<1e-6&&t.length===i?.lengths[o],u=i?"Not an episode of the evaluation":"The evaluation played no episodes of this pair.";this.#t.dataset.
equal=String(h),this.#t.textContent=h?"As in the evaluation":l===void 0?u:`Episode ${o+1} differs from the evaluation.`,this.#t.title=`Played here: capture rate\
 ${G(c,3)} in ${t.length} steps.${i?` The cell says ${G(i.rate,3)}.`:""}`}#s(e,t){let{selected:n}=this.#e,s=d("span",{class:"bar"});return s.style.height=`${Math.
round(100*e)}%`,d("button",{type:"button",class:"episode",title:`Episode ${t+1}: capture rate ${G(e)}`,"aria-label":`Episode ${t+1}, capture rate ${G(e)}`,"aria\
-pressed":String(t===n.episode&&n.seed===null),onclick:()=>this.#e.select({episode:t,seed:null})},s,d("span",{class:"count"},t+1))}};var Uo=0,Do=1,Sl=2,Al=176;function zo(r,e,t,n){let s=devicePixelRatio||1,o=ir(r);r.width=r.height=Al*s;let a=r.getContext("2d");if(!a)return;let{fov:i}=e,l=r.width/
i;a.fillStyle=o.paper,a.fillRect(0,0,r.width,r.height);for(let h=0;t&&h<i*i;h++){let[u,m]=[(h%i+.5)*l,(Math.floor(h/i)+.5)*l],p=f=>!!t[f*i*i+h];p(Sl)&&(a.fillStyle=
o.obstacle,a.fillRect(u-l/2,m-l/2,l,l));let g=p(Uo)&&p(Do)?l*.18:0;p(Uo)&&Wo(a,$e,u+g,m+g,l*.74,o.evader),p(Do)&&Wo(a,or,u-g,m-g,l*.86,o.pursuer)}a.strokeStyle=
n<e.n_pursuers?o.pursuer:o.evader,a.lineWidth=2*s;let c=Math.floor(i/2)*l;a.strokeRect(c,c,l,l)}function Wo(r,e,t,n,s,o){e(r,t,n,s),r.fillStyle=o,r.fill()}var Ml=["stay","↑","→","↓","←","↗","↘","↙","↖"];function Bo(r,{inputs:e,ratings:t,refused:n},s,o){let a=r.kind==="rating"&&!r.hidden.length?r.genome:
null,i=g=>a?.[g]??1,l=g=>r.kind==="rating"?i(g)!==0:new RegExp(`\\b${r.inputs[g]}\\b`).test(o),c=[...r.inputs.keys()].filter(l).sort((g,f)=>Math.abs(i(f))-Math.
abs(i(g))),h=g=>`${g===s?"taken":""} ${n[g]?"refused":""}`,u=(g,f)=>d("tr",{class:f.every(y=>y===f[0])?"same":""},g,...Array.from(f,(y,v)=>d("td",{class:h(v)},je(
y)))),m=g=>{let f=r.inputs[g];return d("th",{scope:"row",title:`${a?`weight ${je(i(g))} x `:""}${Ee[f]}`},f.replaceAll("_"," "))},p=d("table",{class:"why number\
s"},d("thead",{},d("tr",{},d("th",{},a?"term":"input"),...Array.from(t,(g,f)=>d("th",{scope:"col",class:h(f),title:Q[f],"aria-label":Q[f]},Ml[f]))),u(d("th",{scope:"\
row"},a?"sum":"rating"),t)),d("tbody",{},...c.map(g=>u(m(g),e[g].map(f=>i(g)*f)))));return[...o?[d("p",{class:"expression"},d("code",{},o))]:[],d("div",{class:"\
wide-table",tabindex:0,role:"group","aria-label":"How the moves are rated"},p)]}var Go="What it remembers: a number for each unit, from -1 to 1",pr=class{element;#e;#r=d("canvas",{class:"seen",role:"img"});#t=d("h3");#s=d("p",{class:"small \
muted"});#a=d("div",{class:"answers"});#n=d("div",{title:Go});#l=null;#d=null;#m=null;#i=null;#h=null;#u=null;#c=0;constructor(e){this.#e=e,this.element=d("div",
{class:"inspector","data-open":"false"},d("p",{class:"hint small muted"},"Click an agent, or press A: what it sees, and why it takes its move."),d("div",{class:"\
inspected"},this.#r,d("div",{class:"answer"},this.#t,this.#s,this.#n),this.#a))}get agent(){return this.#u}show(e,t,n,s){this.#l?.free(),this.#l=e.world(n.config),
this.#m!==t&&(this.#d=null,this.#u!==null&&this.choose(null)),[this.#m,this.#i,this.#h]=[t,n,s]}set solution(e){this.#d=e,this.at(this.#c)}choose(e){this.#u=e,this.
element.dataset.open=String(e!==null),this.#e(e),this.at(this.#c)}next(e){let t=this.#i;if(!t)return;let n=this.#u??(e>0?-1:0);for(let s=0;s<t.n_agents;s++)if(n=
(n+e+t.n_agents)%t.n_agents,t.alive[this.#c*t.n_agents+n])return this.choose(n)}at(e){this.#c=e;let[t,n,s,o,a]=[this.#i,this.#l,this.#m,this.#h,this.#u];if(!t||
!n||!s||!o||a===null)return;let i=a<t.config.n_pursuers?"pursuer":"evader";this.#n.replaceChildren(),this.#t.replaceChildren(d("span",{class:i},K(a,t.config.n_pursuers)));
let l={pursuers:se(s,"pursuer",o.pursuer),evaders:se(s,"evader",o.evader)};t.seek(n,e,l);let c=t.actions.subarray(e*t.n_agents,(e+1)*t.n_agents);for(;c.length&&
!n.over&&(a<n.actors[0]||a>=n.actors[1]);)n.playTurn(c);let h=!!(t.alive[e*t.n_agents+a]&&n.read("alive")[a]);zo(this.#r,t.config,h?n.view(a):null,a),this.#r.ariaLabel=
`Field of view of ${K(a,t.config.n_pursuers)}: evaders, pursuers and obstacles around it`;let u=c[a]??null;if(!h)return this.#p([],"It is gone.");let m=l[`${i}s`],
p=typeof m!="string"&&m.kind==="cells"?n.answer(m,a):null,g=p?.probabilities??null;p?.memory.length&&this.#n.replaceChildren(d("p",{class:"small muted"},"It rem\
embers:"),Cl(p.memory));let f=typeof m!="string"&&m.kind!=="cells"?Bo(m,n.rate(m,a),u,Ws(s,i,o[i])):[],y=this.#d?.game(n)??null,v=typeof m=="string"?`The script\
 "${m}" plays for it${u===null?"":`; it goes ${Q[u]}`}.`:m.kind!=="cells"?"It takes the best move that its mask allows; of equal ones any.":m.sampled?"Its actio\
n is drawn from these probabilities.":"It takes the most probable action.",S=[["network",g],["perfect",y?.marginal(a)??null]],w=A=>d("p",{class:"small muted"},A);
this.#p([...y?[w(`Value ${y.value.toFixed(2)} under perfect play.`)]:[],...Tl(S,u),...f],u===null?"The episode is over.":v)}#p(e,t){this.#a.replaceChildren(...e),
this.#s.textContent=t}};function Tl(r,e){let t=r.filter(([,o])=>o);if(!t.length)return[];let n=d("div",{class:"action muted"},d("span"),...t.map(([o])=>d("span",
{class:"head"},o))),s=Array.from(t[0][1],(o,a)=>d("div",{class:a===e?"action taken":"action"},d("span",{},Q[a]),...t.flatMap(([,i])=>El(i[a]))));return t.length>
1||t[0][0]!==r[0][0]?[n,...s]:s}function El(r){let e=d("span",{class:"filled"});return e.style.width=`${100*r}%`,[d("span",{class:"track"},e),d("span",{class:"n\
umbers"},r.toFixed(2))]}function Cl(r){let e=Array.from(r,t=>{let n=d("span",{title:t.toFixed(2)});return n.style.transform=`scaleY(${t})`,n});return d("div",{class:"\
units",role:"img","aria-label":Go},...e)}function Ho(r){let e=JSON.stringify(r,(t,n)=>t==="genome"?Array.from(n):n);return d("script",{type:"application/json",id:"champions"},e.replaceAll("<","\\u003c")).
outerHTML}var vt="_",kl="n",Qh=2n**64n-1n;var Mn={fov:11,maxSteps:500,rewards:"paper"},Rl=["rules","others","rewards","size","diagonal","fov","limit","seed","ended","walls","pursuers","evaders","played",
"next"];function Yo(r,e){let t=i=>i.map(l=>_l(l,e)).join(""),n=i=>`${Math.floor(i/r.cols)}.${i%r.cols}`,s=Ol(r.rewards,e),o=[r.seed,r.episode,r.steps].join("."),a={rules:Vo(
r.rules,e),others:r.others?Vo(r.others,e):"",rewards:s===Mn.rewards?"":s,size:`${r.rows}x${r.cols}`,diagonal:r.diagonal?"1":"",fov:r.fov===Mn.fov?"":String(r.fov),
limit:r.maxSteps===Mn.maxSteps?"":String(r.maxSteps),seed:o==="0.0.0"?"":o,ended:r.ended?"1":"",walls:r.walls.map(n).join(vt),pursuers:r.pursuers.map(jo).join(vt),
evaders:r.evaders.map(jo).join(vt),played:r.played.map(t).join(vt),next:r.next.every(i=>i===ws)?"":t(r.next)};return Rl.filter(i=>a[i]).map(i=>`${i}=${a[i]}`).join(
"&")}function jo({cell:r,gone:e,captured:t,everCaptured:n}){let s=t?"c":n?"e":"";return`${r[0]}.${r[1]}${s}${e?"x":""}`}function Vo(r,e){let t=e.fields.map(({name:n})=>String(
r[n]).toLowerCase());return xs(r,e.variants)??t.join(".")}function Ol(r,e){let t=JSON.stringify(r);return Object.keys(e.rewards).find(s=>JSON.stringify(e.rewards[s])===
t)??Object.values(r).map(s=>String(s)).join(vt)}function _l(r,e){if(typeof r=="number")return String(r);if(r===bs)return kl;let t=e.scripts.findIndex(({name:n})=>n===
r);return String.fromCharCode(97+t)}var Pl="/* the engine */";function Ko(r,e){return d("button",{type:"button",class:"to-playground",title:"Open this step in the playground (G): the same agents a\
nd actions under any rules",onclick:()=>$l(r(),e)},"What if?")}function $l(r,e){let t=r!==null&&r.match.n_agents<=Xr&&Math.max(r.match.config.rows,r.match.config.
cols)<=Jr,n=t?Yo(Nl(r.match,r.step),e):"",s=new TextDecoder().decode(mn("playground")).replace(Pl,()=>Ae("script-engine")).replace("</noscript>",o=>t?o+Ho(r.champions):
o);window.open(`${URL.createObjectURL(new Blob([s],{type:"text/html"}))}#${n}`)}function Nl(r,e){let{config:t,n_agents:n}=r,s=Math.max(0,e-1),o=i=>{let l=s*n+i,
c=s*t.n_evaders+i-t.n_pursuers,h=u=>i>=t.n_pursuers&&!!u[c];return{cell:[r.last_positions[2*l],r.last_positions[2*l+1]],gone:!r.alive[l],captured:h(r.captured),
everCaptured:h(r.ever_captured)}},a=Array.from({length:n},(i,l)=>o(l));return{rules:t.rules,others:null,rewards:t.rewards,rows:t.rows,cols:t.cols,diagonal:t.diagonal,
fov:t.fov,maxSteps:t.max_steps,seed:r.seed,episode:BigInt(r.episode),steps:s,ended:s===r.length,walls:Array.from(r.map.keys()).filter(i=>r.map[i]),pursuers:a.slice(
0,t.n_pursuers),evaders:a.slice(t.n_pursuers),played:[],next:Array.from(r.actions.subarray(s*n,(s+1)*n))}}var Tn=.005,Zo=.05,Ll=["pursuer","evader"],Il=4,qe=new Map;function fr(r,e,t="capture-rate"){let n=JSON.stringify([{...e,rewards:null},t]),s=qe.get(n)??(Lt(e)?Promise.
resolve(null):Fl(r,e,t));return qe.delete(n),qe.set(n,s),qe.size>Il&&qe.delete([...qe.keys()][0]),s}var Jo=({n_evaders:r})=>r===1?"capture-time":"capture-rate",
qo=()=>new Promise(r=>setTimeout(r));async function Fl(r,e,t){await qo();let n=r.solution(e,t);for(;n.goBack();)await qo();return n}function yr(r,e,t){let{payoff:n}=r;
return t.flatMap((s,o)=>{let a=[0,0];for(let l=e.n_turns;l>0&&!e.over;l--)r.game(e)?.lost(s).forEach((c,h)=>a[h]+=c),e.playTurn(s);let i=n==="capture-rate"?Tn:Zo;
return Ll.map((l,c)=>({step:o+1,team:l,lost:a[c],payoff:n})).filter(l=>l.lost>=i)})}var gr=r=>r.map(e=>({step:e.step,kind:e.team,size:e.lost/Math.max(1,...r.map(
({lost:t})=>t)),text:bt(e)})),Xo=({lost:r,payoff:e})=>e==="capture-rate"?`${r.toFixed(2)} of the capture rate`:`${r.toFixed(1)} steps`,bt=r=>`The ${r.team}s los\
e ${Xo(r)} against a perfect opponent`;function Qo(r){let e=r.reduce((t,n)=>n.lost>t.lost?n:t);return`Your team's worst moves, in step ${e.step}, lost ${Xo(e)} \
against a perfect opponent.`}function ea({config:r,payoff:e},{value:t},n){if(e==="capture-rate")return`value ${t.toFixed(2)}`;let[s,o]=[1-t,Math.min(r.max_steps-
n,Kr)];return s>o-Zo?`free for ${o} steps`:`captured after ${s.toFixed(1)} steps`}function ta(r,e){return(r.marginal(e)??[]).map((n,s)=>({share:n,action:s})).filter(
({share:n})=>n>=Tn).sort((n,s)=>s.share-n.share).map(({share:n,action:s})=>n>1-Tn?Q[s]:`${Q[s]} ${n.toFixed(2)}`).join(", ")}function vr(r,e,t){if(t===0)return[{kind:"start",text:Ul(r),agents:[]}];let[n,s]=[e.moments[t-1],e.moments[t]],o=h=>K(h,r.config.n_pursuers),a=pt(e,n,s),i=r.conflicts(
t),l=new Set(i.flatMap(h=>h.doomed)),c=a.map(h=>({kind:"capture",text:`${o(h)} is captured`,agents:[h]}));for(let h of nr(n,s))!a.includes(h)&&!l.has(h)&&c.push(
{kind:"end",text:`${o(h)} disappears`,agents:[h]});return c.push(...i.map(({kind:h,text:u,agents:m})=>({kind:h,text:u,agents:m}))),t===r.length&&c.unshift({kind:"\
end",text:Dl(r),agents:[]}),c}function Ul({config:r}){return`${r.n_pursuers} pursuers and ${r.n_evaders} evaders on ${r.rows} x ${r.cols} cells, at most ${r.max_steps}\
 steps`}function Dl(r){let e=Math.round(r.statistics.capture_rate*r.config.n_evaders);return`The episode ends after ${r.length} steps with ${e} of ${r.config.n_evaders}\
 evaders captured`}var Wl=60,br=class{element;player=new Te(0,{speed:cr,still:ye()});inspector;match=null;recording=null;actions;#e;#r;#t;#s;#a=d("h2",{class:"match-title"});#n=d(
"p",{class:"tally numbers"});#l=d("ol",{class:"words",tabindex:0,"aria-live":"off","aria-label":"What happened in this step"});#d=d("p",{class:"problem",role:"a\
lert"});#m=d("div",{class:"shown","aria-live":"polite"});#i=null;#h=null;#u=0;#c=!1;#p=0;#o=[];constructor(e,t,n){[this.#r,this.#t]=[e,t];let s=d("canvas",{"ari\
a-label":"The match",onclick:({clientX:o,clientY:a})=>this.inspector.choose(this.#e.agentAt(o,a))});this.#e=new Me(s,{numbers:!1}),this.#s=new mr(t),this.inspector=
new pr(o=>this.#E(o)),this.actions=d("div",{class:"beside"},d("button",{type:"button",class:"to-play",title:"Move the chosen agent, or an evader, yourself from \
this step on (T)",onclick:()=>this.element.dispatchEvent(new Event("takeover"))},"Take over"),n&&Ko(()=>this.shown,n)),this.element=d("section",{class:"card mat\
ch-card","aria-label":"Match",id:"match"},d("div",{class:"match"},d("header",{class:"match-head"},this.#a,this.#n),this.#d,this.#m,d("div",{class:"stage"},s),d(
"div",{class:"aside"},this.#l,Dt(),this.actions,this.inspector.element),dr(this.player),this.#s.element)),this.player.addEventListener("frame",()=>this.recording&&
this.#e.show(this.recording,this.player.time)),this.player.addEventListener("step",()=>this.#A()),t.on("match",()=>this.#g()),this.#w(),this.#S(0,0)}get#y(){return this.#r[this.#t.
selected.run]}reveal(){(this.#y.game?this.#m:this.#e.canvas).scrollIntoView({block:"nearest"})}get shown(){return this.match&&this.#h&&{match:this.match,step:this.
player.step,champions:this.#h}}start(e){this.#i=e,this.#b()}playSoon(){this.#c=!0,this.#u||this.#f()}goTo(e){this.#p=e,!this.#u&&this.match&&this.#b()}#f(){!this.#c||
!this.match||(this.#c=!1,this.player.jump(0),ye()||this.player.play())}#g(){this.#w(),clearTimeout(this.#u),this.#u=setTimeout(()=>this.#b(),Wl)}#b(){clearTimeout(
this.#u),this.#u=0,this.player.pause(),this.#w();let{selected:e}=this.#t,{game:t}=this.#y;if(this.#m.replaceChildren(...t?Us(this.#y,t,e,this.#t):[]),t){this.match=
this.recording=null,this.#c=!1,this.#v(e);return}let n=Oe.map(a=>jt(this.#y,a,e[a])).find(Boolean)??"";if(this.#d.textContent=n,n||!this.#i)return;this.match=zs(
this.#i,this.#y,e);let[s,o]=this.names(e);this.#h={pursuer:{name:s,policy:se(this.#y,"pursuer",e.pursuer)},evader:{name:o,policy:se(this.#y,"evader",e.evader)}},
this.recording=lr(this.match),this.#s.show(this.#y,this.match),this.inspector.show(this.#i,this.#y,this.match,e),this.player.length=this.match.length,this.player.
marks=rr(this.recording),this.#o=this.player.ticks=[],this.player.jump(this.#p),this.#p=0,this.#A(),this.#x(this.#i,this.match),this.#v(e),this.#f()}#v({run:e,pursuer:t,
evader:n,episode:s,seed:o}){this.element.dataset.played=`${e} ${t} ${n} ${s} ${o??""}`}async#x(e,t){let n=await fr(e,t.config);if(this.match!==t||!n)return;let s=e.
world(t.config);t.seek(s,0),this.#o=yr(n,s,zl(t)),s.free(),this.player.ticks=gr(this.#o),this.inspector.solution=n,this.#A()}names({run:e,pursuer:t,evader:n}){let s=this.#r[e],
{teams:o}=s;return[o.pursuer.script??te(s,"pursuer",t),o.evader.script??te(s,"evader",n)]}#w(){let{episode:e,seed:t}=this.#t.selected,{game:n,payoff:s}=this.#y;
this.element.classList.toggle("of-own-game",!!n),this.element.classList.toggle("of-ratings",Oe.some(l=>Ds(this.#y,l)));let[o,a]=this.names(this.#t.selected),i=t===
null?e<s.episodes?`episode ${e+1} of ${s.episodes}`:`episode ${e+1}, not part of the cell`:`seed ${t}`;this.#a.replaceChildren(d("span",{class:"pursuer"},Ht(o)),
" against ",d("span",{class:"evader"},a),n?"":d("span",{class:"muted small"},i))}#A(){let e=this.match;if(!e||!this.recording)return;let t=this.player.step,n=this.
recording.moments[t];this.#S(Array.from(n.everCaptured).filter(Boolean).length,t),this.#l.replaceChildren(...this.#o.filter(s=>s.step===t).map(s=>d("li",{class:`\
loss-${s.team}`},bt(s))),...vr(e,this.recording,t).map(s=>d("li",{class:s.kind,"data-agents":s.agents.join(" ")},s.text))),this.inspector.at(t),this.#M()}#S(e,t){
let{world:n}=this.#y;n&&this.#n.replaceChildren(d("strong",{},e),` of ${n.n_evaders} captured`,d("span",{class:"muted"},` · step ${t}`))}#E(e){this.#e.look={selected:e,
viewers:e===null?[]:[e]},this.#M()}#M(){let e=this.inspector.agent;for(let t of this.#l.children){let n=t.dataset.agents?.split(" ")??[];t.classList.toggle("abo\
ut",e!==null&&n.includes(String(e)))}}},zl=({actions:r,length:e,n_agents:t})=>Array.from({length:e},(n,s)=>r.subarray(s*t,(s+1)*t));var Bl={ArrowUp:[1,0],ArrowDown:[-1,0],ArrowRight:[0,1],ArrowLeft:[0,-1]},Gl=5;function na(r,e,t,n="pursuer"){r.tabIndex=0,r.setAttribute("role","application"),
r.addEventListener("keydown",s=>{let o=Bl[s.key];if(!o)return;let[a,i]=n==="pursuer"?o:[o[1],o[0]],[l,c]=t(),h=s.shiftKey?Gl:1,{pursuer:u,evader:m}=e.selected;e.
select({pursuer:ra(u+h*a,l),evader:ra(m+h*i,c)}),s.preventDefault(),s.stopPropagation()})}var ra=(r,e)=>Math.min(e-1,Math.max(0,r));var wt=[[68,1,84],[72,26,108],[71,47,125],[65,68,135],[57,86,140],[49,104,142],[42,120,142],[35,136,142],[31,152,139],[34,168,132],[53,183,121],[84,197,104],[122,
209,81],[165,219,54],[210,226,27],[253,231,37]];function wr(r){let e=Math.min(1,Math.max(0,r))*(wt.length-1),t=Math.min(wt.length-2,Math.floor(e)),[n,s]=[wt[t],
wt[t+1]],o=a=>Math.round(n[a]+(e-t)*(s[a]-n[a]));return[o(0),o(1),o(2)]}function sa(r){let[e,t,n]=wr(r).map(s=>((s/255+.055)/1.055)**2.4);return .2126*e+.7152*t+
.0722*n>.179?"#000":"#fff"}var oa=r=>`rgb(${wr(r).join(" ")})`,aa=()=>`linear-gradient(to right, ${wt.map(r=>`rgb(${r.join(" ")})`).join(", ")})`;function ia(r,e,t){let n=devicePixelRatio||1;for(let[a,i]of Object.entries(t))r.style.setProperty(a,`${i}px`);r.width=Math.round(t.width*n),r.height=Math.round(
t.height*n);let s=r.getContext("2d"),o=Hl(e);!s||!o||(s.imageSmoothingEnabled=!1,s.drawImage(o,0,0,r.width,r.height))}function Hl(r){let[e,t]=r.shape,n=document.
createElement("canvas");[n.width,n.height]=[t,e];let s=n.getContext("2d");if(!s)return null;let o=s.createImageData(t,e);return r.capture_rate.forEach((a,i)=>a.
forEach((l,c)=>{let h=4*((e-1-i-r.first[0])*t+c+r.first[1]);o.data.set([...wr(l),255],h)})),s.putImageData(o,0,0),n}function la(r,e,t,n=2){r.textContent=G(e,n),
r.ariaLabel=`${t}: ${r.textContent}`,e!==void 0&&([r.style.backgroundColor,r.style.color]=[oa(e),sa(e)])}function En(r,e){let t=d("span",{class:"gradient"});return t.
style.backgroundImage=aa(),d("p",{class:"scale-of-rates small muted"},r,t,e)}var jl=24,xr=7,ua=r=>r<jl&&matchMedia("(pointer: coarse)").matches;function ha(r,e,t,n){let[s,o]=r.payoff.shape,[a,i]=[ca(e,s),ca(t,o)],[l,c]=[Math.min(xr,s),Math.
min(xr,o)],h=[];for(let f=a+l-1;f>=a;f--){h.push(d("span",{class:"pursuer"},f));for(let y=i;y<i+c;y++)h.push(Vl(r,f,y,n))}let u=Array.from({length:c},(f,y)=>d("\
span",{class:"evader"},i+y)),m=d("button",{type:"button","aria-label":"Close: all cells",onclick:()=>n(null)},"✕"),g=d("div",{class:"loupe numbers",role:"grou\
p","aria-label":"Cells around the tap",onclick:f=>f.stopPropagation()},...h,m,...u);return g.style.gridTemplateColumns=`2.4rem repeat(${c}, minmax(0, 1fr))`,g}function Vl(r,e,t,n){
let s=d("button",{type:"button",onclick:()=>n({pursuer:e,evader:t})});return la(s,Se(r,e,t)?.rate,`${te(r,"pursuer",e)} against ${te(r,"evader",t)}`),s}var ca=(r,e)=>Math.
max(0,Math.min(e-xr,r-Math.floor(xr/2)));var oe={left:52,bottom:46,top:76,right:84},he=10,Yl=160,xt=oe.right-he-14,Ne=oe.top-he-14,Sr=class{element;#e;#r;#t=d("canvas",{"aria-hidden":"true"});#s=b("svg",
{"aria-hidden":"true"});#a=b("g");#n;#l=d("h2");#d=d("strong",{class:"rate numbers"});#m=d("span",{class:"small muted"});#i=d("p",{class:"of-both-teams small mu\
ted numbers"});#h;#u=null;constructor(e,t){[this.#r,this.#e]=[e,t],this.#n=d("div",{class:"matrix",id:"matrix","aria-label":"Payoff matrix. Arrow keys choose a \
match, Enter plays it.",onpointermove:s=>this.#x(s),onpointerleave:()=>t.point({}),onclick:s=>this.#w(s),onkeydown:({key:s})=>s==="Enter"&&this.#S()},this.#t,this.#s);
let n=d("header",{class:"readout","aria-live":"polite"},d("div",{},this.#l,this.#i),d("div",{class:"of-cell"},this.#d,this.#m));this.#h=En(...xe(this.#c).ends),
this.element=d("section",{class:"card matrix-card","aria-label":"Payoff matrix"},n,this.#n,this.#h),this.#g(),new ResizeObserver(()=>this.#p()).observe(this.#n),
this.#n.addEventListener("mousedown",s=>{s.preventDefault(),document.activeElement instanceof HTMLElement&&document.activeElement.blur()}),na(this.#n,t,()=>this.#c.
payoff.shape),t.on("run",()=>{let s=En(...xe(this.#c).ends);this.#h.replaceWith(s),this.#h=s,this.#p()}),t.on("match hover",()=>this.#f())}get#c(){return this.#r[this.#e.
selected.run]}#p(){let[e,t]=this.#c.payoff.shape,{clientWidth:n,clientHeight:s}=this.#n;if(n<50)return;let a=Math.max(Yl,Math.min(n-oe.left-oe.right,s-oe.top-oe.
bottom))/Math.max(e,t),i=Math.max(oe.left,(n-t*a-oe.right+oe.left)/2),l=oe.top+Math.max(0,(s-oe.top-oe.bottom-e*a)/2),c={width:n,height:s,left:i,top:l,cell:a,rows:e,
columns:t};this.#u=c,ia(this.#t,this.#c.payoff,{left:i,top:l,width:t*a,height:e*a});for(let[h,u,m]of[["left",i,n],["top",l,s],["width",t*a,n],["height",e*a,s]])
this.#t.style.setProperty(h,`${100*u/m}%`);this.#n.style.setProperty("--shape",`${n} / ${s}`),this.#s.setAttribute("viewBox",`0 0 ${n} ${s}`),this.#s.replaceChildren(
Kl(c,xe(this.#c).generation),...ql(c),...this.#y(c),this.#a),this.#f()}#o(e){let t=this.#c.findings?.generalization;if(!t)return[];let{selected:n,hover:s}=this.#e,
[o,a]=[s.pursuer??n.pursuer,s.evader??n.evader],[i,l]=da(e,t.pursuers.mean[o]??0,o),[c,h]=ma(e,t.evaders.mean[a]??0,a);return[b("circle",{class:"dot of-pursuers",
cx:i,cy:l,r:5}),b("circle",{class:"dot of-evaders",cx:c,cy:h,r:5})]}#y(e){let t=this.#c.findings?.generalization;if(!t)return[];let{left:n,top:s,cell:o,rows:a,columns:i}=e,
{curves:l}=xe(this.#c),[c,h]=[n+i*o+he,s-he],u={class:"side"};return[b("rect",{...u,x:c,y:s,width:xt,height:a*o}),b("rect",{...u,x:n,y:h-Ne,width:i*o,height:Ne}),
...pa(t.pursuers,(m,p)=>da(e,m,p),"of-pursuers"),...pa(t.evaders,(m,p)=>ma(e,m,p),"of-evaders"),b("text",{class:"tick",x:c,y:s+a*o+16,"text-anchor":"start"},"0"),
b("text",{class:"tick",x:c+xt,y:s+a*o+16,"text-anchor":"end"},"1"),b("text",{class:"tick",x:n-6,y:h-4,"text-anchor":"end"},"0"),b("text",{class:"tick",x:n-6,y:h-
Ne+8,"text-anchor":"end"},"1"),b("text",{class:"label of-pursuers",x:c+xt,y:s+a*o+34,"text-anchor":"end"},l.pursuer),b("text",{class:"label of-evaders",x:n+i*o+
he,y:h-Ne+10,"text-anchor":"start"},l.evader)]}#f(){let e=this.#u;if(!e)return;let{selected:t,hover:n}=this.#e,{left:s,top:o,cell:a,rows:i,columns:l}=e,c=g=>o+(i-
1-g)*a,h=[],u=(g,f)=>b("rect",{class:f,x:s,y:c(g),width:l*a+he+xt,height:a}),m=(g,f)=>b("rect",{class:f,x:s+g*a,y:o-he-Ne,width:a,height:he+Ne+i*a});h.push(u(t.
pursuer,"strip pursuer"),m(t.evader,"strip evader")),n.pursuer!==null&&n.pursuer<i&&h.push(u(n.pursuer,"strip hover")),n.evader!==null&&n.evader<l&&h.push(m(n.evader,
"strip hover")),h.push(...this.#o(e));let p={x:s+t.evader*a,y:c(t.pursuer),width:a,height:a};h.push(b("rect",{class:"chosen under",...p}),b("rect",{class:"chose\
n",...p})),this.#a.replaceChildren(...h),this.#g()}#g(){let{selected:e,hover:t}=this.#e,n=t.pursuer??e.pursuer,s=t.evader??e.evader,o=Se(this.#c,n,s);this.#l.replaceChildren(
d("span",{class:"pursuer"},Ht(te(this.#c,"pursuer",n)))," against ",d("span",{class:"evader"},te(this.#c,"evader",s))),this.#d.textContent=o?G(o.rate,3):"-";let a=o&&
o.rates.length>1?`, mean of ${o.rates.length} episodes`:"";this.#m.textContent=o?xe(this.#c).score+a:"no episodes were played",this.#i.textContent=this.#b(n,s)}#b(e,t){
let n=this.#c.findings?.generalization;if(!n)return"";let s=(a,i)=>Fs(a.mean[i]??null,a.low?.[i]??null,a.high?.[i]??null),{means:o}=xe(this.#c);return`Against a\
ll: ${o.pursuer} ${s(n.pursuers,e)}, ${o.evader} ${s(n.evaders,t)}`}#v(e){let t=this.#u;if(!t)return null;let n=this.#n.getBoundingClientRect(),s=Math.floor((e.
clientX-n.left-t.left)/t.cell),o=t.rows-1-Math.floor((e.clientY-n.top-t.top)/t.cell),[a,i]=[o>=0&&o<t.rows,s>=0&&s<t.columns];return a||i?{g:a?o:-1,h:i?s:-1,inside:a&&
i}:null}#x(e){let t=this.#v(e);this.#e.point(t?{pursuer:t.g<0?null:t.g,evader:t.h<0?null:t.h}:{})}#w(e){let t=this.#v(e);if(t){if(t.inside&&ua(this.#u.cell))return this.#A(
t.g,t.h);this.#e.select({...t.g<0?{}:{pursuer:t.g},...t.h<0?{}:{evader:t.h}}),t.inside&&this.#S()}}#A(e,t){let n=ha(this.#c,e,t,s=>{n.remove(),s&&(this.#e.select(
s),this.#S())});this.#n.append(n)}#S(){this.#n.dispatchEvent(new CustomEvent("play",{bubbles:!0}))}};function Kl({left:r,top:e,cell:t,rows:n,columns:s},o){let a=b(
"g",{class:"axes"}),i=e+n*t,l=c=>dt(0,c-1,Math.min(c,c*t/44),!0);for(let c of l(s))a.append(b("text",{class:"tick",x:r+(c+.5)*t,y:i+16,"text-anchor":"middle"},c));
for(let c of l(n))a.append(b("text",{class:"tick",x:r-7,y:i-(c+.5)*t,"text-anchor":"end","dominant-baseline":"middle"},c));return a.append(b("text",{class:"labe\
l of-evaders",x:r+s*t/2,y:i+36,"text-anchor":"middle"},o.evader),b("text",{class:"label of-pursuers",transform:`translate(${r-36} ${e+n*t/2}) rotate(-90)`,"text\
-anchor":"middle"},o.pursuer)),a}function ql({left:r,top:e,cell:t,rows:n,columns:s}){let o=b("g",{class:"diagonal"}),a=Math.min(n,s);if(a<3)return[];let i=e+n*t;
for(let h of["H","V"]){let u=`M${r} ${i}`;for(let m=1;m<=a;m++){let[p,g]=[`H${r+m*t}`,`V${i-m*t}`];u+=h==="H"?p+g:g+p}o.append(b("path",{d:u,class:"under"}),b("\
path",{d:u}))}let[l,c]=[r+a/2*t-.7*t-4,i-a/2*t-.7*t-4];return[o,b("text",{class:"on-cells",transform:`translate(${l} ${c}) rotate(-45)`,"text-anchor":"middle"},
"same generation")]}var da=({left:r,top:e,cell:t,rows:n,columns:s},o,a)=>[r+s*t+he+o*xt,e+(n-a-.5)*t],ma=({left:r,top:e,cell:t},n,s)=>[r+(s+.5)*t,e-he-n*Ne];function pa(r,e,t){
let n=o=>o.map((a,i)=>e(a??0,i).map(l=>l.toFixed(1)).join(" ")),s=[];return r.low&&r.high&&s.push(b("path",{class:`band ${t}`,d:`M${[...n(r.high),...n(r.low).reverse()].
join("L")}Z`})),s.push(b("path",{class:`line ${t}`,d:`M${n(r.mean).join("L")}`})),s}var fa={pursuer:null,evader:null},Ar=class extends EventTarget{#e;#r=fa;constructor(e){super(),this.#e=e}get selected(){return this.#e}get hover(){return this.#r}select(e){
let t=this.#e,n=["run","pursuer","evader"].some(s=>s in e&&e[s]!==t[s]);this.#e={...t,...n?{episode:0,seed:null}:{},...e},this.#e.run!==t.run&&this.dispatchEvent(
new Event("run")),this.dispatchEvent(new Event("match"))}point(e){let t={...fa,...e};t.pursuer===this.#r.pursuer&&t.evader===this.#r.evader||(this.#r=t,this.dispatchEvent(
new Event("hover")))}on(e,t){for(let n of e.split(" "))this.addEventListener(n,t)}};var Mr=class{config;start;recording;actions=[];#e;#r;#t=[[]];constructor(e,t,n){[this.config,this.start]=[t,n],this.#e=e.world(t),this.#e.reset(n),this.#r=[An(this.#e)],
this.recording=Sn(t,this.#e.map(),this.#r)}get length(){return this.actions.length}get over(){return this.#e.over}get statistics(){return{capture_rate:this.#e.read(
"capture_rate")[0]}}conflicts(e){return this.#t[e]}game(e){return e.game(this.#e)}play(e){this.#e.step(e),this.#s(e)}step(e,t,n){let[s,o]=[this.#e,this.config.n_pursuers],
a=new Uint8Array(s.n_agents);for(let i=s.n_turns;i>0&&!s.over;--i){let[l,c]=s.actors;l<o&&(a=s.decide(e.pursuer,[l,Math.min(c,o)],a)),c>o&&(a=s.decide(e.evader,
[Math.max(l,o),c],a)),typeof n=="number"?a[t]=n:l<=t&&t<c&&(a=s.decide(n,[t,t+1],a)),s.playTurn(a)}this.#s(a)}#s(e){this.actions.push(e),this.#r.push(An(this.#e,
e)),this.#t.push(this.#e.conflicts())}};var de=(r,e)=>Oe[+(e>=r.n_pursuers)];function Cn(r,e){let t=new Mr(r,e.config,{seed:e.seed,episode:e.episode});for(let n of e.moves)t.over||t.step(e.policies,e.
seat,n);return t}function Ze(r,e){let{moments:t,nPursuers:n}=r.recording,s=t.findIndex(({alive:a,captured:i})=>!a[e]||!!i[e-n]),o=s<0?r.length:s;return{lasted:o,
out:s>=0,captured:Array.from(t[o].everCaptured).filter(Boolean).length}}var Tr=(r,e)=>r.over||Ze(r,e).out;function ya(r,e,t){let n=Cn(r,{...e,moves:e.moves.slice(
0,e.from)});for(;!Tr(n,e.seat);)n.step(e.policies,e.seat,t);return Ze(n,e.seat)}function ga(r){let e=r.length-1;return[...new Set([0,Math.round(e/3),e])].map(t=>r[t])}
function va(r,{seat:e,from:t,moves:n}){let s={...r,seat:e,...t?{from:t}:{},moves:n.join("")};return`${location.href.split("#")[0]}#${Object.entries(s).map(([o,a])=>`${o}\
=${a}`).join("&")}`}function ba(r,e){let[t,n,s]=[r.get("seat")??"",r.get("from")??"0",r.get("moves")??""];return/^\d{1,6}$/.test(t)&&Number(t)<e.n_pursuers+e.n_evaders&&
(e.diagonal?/^[0-8]+$/:/^[0-4]+$/).test(s)&&s.length<=e.max_steps&&/^\d{1,6}$/.test(n)&&Number(n)<=s.length?{seat:Number(t),from:Number(n),moves:[...s].map(Number)}:
null}function kn(r,e,t,n,s,o){e.play({title:t,played:n,ending:(a,i)=>[Zl(r,a,i,ga(s))],again:()=>kn(r,e,t,{...n,moves:n.moves.slice(0,n.from)},s,o),link:a=>o&&va(o,a)})}
function Zl(r,e,t,n){let s=de(t.config,t.seat)==="evader",o=s?t.config.max_steps:t.config.n_evaders,a=d("table",{class:"numbers"},d("caption",{},s?"Steps in you\
r seat: same start, same others":"Captures of your team: same start, same others")),i=c=>{let[h,u]=[d("span",{class:s?"bar evader":"bar pursuer"}),d("td",{},"…")];
return a.append(d("tr",{},d("th",{scope:"row"},c),d("td",{class:"track","aria-hidden":"true"},h),u)),({lasted:m,captured:p})=>{h.style.width=`${100*(s?m:p)/o}%`,
u.textContent=String(s?m:p)}};i("You")(Ze(e,t.seat));for(let{name:c,policy:h}of n){let u=i(c);setTimeout(()=>u(ya(r,t,h())))}let l=t.from?`You took over at step\
 ${t.from}. `:"";return d("div",{},a,d("p",{class:"small muted"},`${l}One match: luck has its part in it.`))}var wa=["·","↑","→","↓","←","↗","↘","↙","↖"];var Jl={" ":0,ArrowUp:1,w:1,ArrowRight:2,d:2,ArrowDown:3,s:3,ArrowLeft:4,a:4,e:5,c:6,y:7,z:7,q:8},Rn=[8,1,5,4,0,2,7,3,6],Xl=[7,8,9,4,5,6,1,2,3],Ql=24,ec=Math.tan(
Math.PI/8);function Sa(r,e){if(r.ctrlKey||r.metaKey||r.altKey)return;let t=Xl.findIndex(s=>r.code===`Numpad${s}`),n=Rn[t]??Jl[r.key.length===1?r.key.toLowerCase():
r.key];return n!==void 0&&n>4&&!e?void 0:n}function Aa(r){let e=Rn.map(t=>d("button",{type:"button","aria-label":Q[t],onclick:()=>r(t)},wa[t]));return{element:d(
"div",{class:"play-pad",role:"group","aria-label":"Your move"},...e),show:t=>e.forEach((n,s)=>n.classList.toggle("absent",Rn[s]>4&&!t))}}function xa(r,e,t){let n=ec*
Math.max(Math.abs(r),Math.abs(e)),s=o=>Math.abs(o)<n?0:o;return eo([0,0],t?[s(r),s(e)]:[r,e],t)}function Ma(r,e,t){let n=null,{canvas:s}=r;s.addEventListener("p\
ointerdown",({button:o,clientX:a,clientY:i})=>n=o===0?[a,i]:null),s.addEventListener("pointercancel",()=>n=null),s.addEventListener("pointerup",({clientX:o,clientY:a})=>{
let[i,l]=[n,e()];if(n=null,!i||!l)return;let[c,h]=[o-i[0],a-i[1]],u=r.cellAt(o,a);Math.hypot(c,h)>=Ql?t(xa(h,c,l.diagonal)):u&&t(xa(u[0]-l.cell[0],u[1]-l.cell[1],
l.diagonal))})}function Ta(r,e){let t=n=>{let s=e[n]-r[n],o=Ve.findIndex(a=>a[n]===Math.sign(s)&&a[1-n]===0);return s?`${Math.abs(s)} ${Q[o]}`:""};return[t(0),t(
1)].filter(Boolean).join(", ")||"on your cell"}var ka="NUMPY\0",Ea=ka.length+2,Ca=64;function St(r){return Gt(Object.fromEntries(Object.entries(r).map(([e,t])=>[`${e}.npy`,tc(t)])))}function tc({dtype:r,shape:e,
data:t}){let n=typeof t=="string"?Array.from(t,h=>h.codePointAt(0)):null,s=e.map(h=>`${h}, `).join(""),o=`{'descr': '${n?`<U${n.length}`:r}', 'fortran_order': F\
alse, 'shape': (${s}), }`,a=Math.ceil((Ea+o.length+1)/Ca)*Ca-Ea,i=ka+String.fromCharCode(a&255,a>>8)+o.padEnd(a-1)+`
`,l=n?Int32Array.from(n):t,c=new Uint8Array(i.length+l.byteLength);return c.set(Re(i,!0)),c.set(new Uint8Array(l.buffer,l.byteOffset,l.byteLength),i.length),c}var rc="matrixworld episode 3";function Ra(r,e,t){let{config:n,actions:s,length:o,recording:a}=e,[i,l]=[n.n_pursuers+n.n_evaders,n.n_evaders],c={positions:["<i4",
i,2],last_positions:["<i4",i,2],alive:["|b1",i],captured:["|b1",l],ever_captured:["|b1",l]},h={rewards:["<f4",i],involved:["|b1",i,3],fault:["|b1",i,3]},u={},m=w=>{
for(let A of Object.keys(w))(u[A]??=[]).push(Array.from(p.read(A),Number))},p=r.world(n);p.reset(e.start);let g=[];m(c);for(let w of s)p.step(w),m({...c,...h}),
g.push(...p.conflictTable());p.free();let f={"<i4":Int32Array,"<f4":Float32Array,"|b1":Uint8Array},y={};for(let[w,[A,...O]]of Object.entries({...c,...h})){let I=o+
+(w in c);y[w]={dtype:A,shape:[I,...O],data:f[A].from((u[w]??[]).flat())}}let v=w=>({dtype:"<i8",shape:[],data:Int32Array.of(w,0)}),S=w=>({dtype:"<U",shape:[],data:w});
return St({format:S(rc),n_pursuers:v(n.n_pursuers),config:S(JSON.stringify(n)),seat:v(t),...y,actions:{dtype:"|i1",shape:[o,i],data:Int8Array.from(s.flatMap(w=>[
...w]))},map:{dtype:"|b1",shape:[n.rows,n.cols],data:Uint8Array.from(a.obstacles,Number)},conflict_table:{dtype:"<i4",shape:[g.length/11,11],data:Int32Array.from(
g)}})}var nc=[0,1,2,4,8],Er=class{element;player=new Te(0,{speed:4,still:ye()});#e;#r;#t=d("canvas",{tabindex:0,"aria-describedby":"play-keys"});#s=d("h2");#a=d("p",{
class:"play-told",role:"status"});#n=Aa(e=>this.act(e));#l=ne(nc.map(e=>[e,e?`${e} / s`:"step by step"]),()=>this.#C());#d=d("input",{type:"checkbox",onchange:()=>this.#A()});#m=d(
"input",{type:"checkbox",onchange:()=>this.#k()});#i=d("label",{class:"play-choice"},this.#m,"Best move");#h=d("p",{class:"small muted play-keys",id:"play-keys"});#u=d(
"section",{class:"play-ending",tabindex:-1,"aria-labelledby":"play-headline"});#c=dr(this.player);#p=null;#o=null;#y=[];#f=null;#g=null;#b=[];#v=0;#x=0;constructor(e){
this.#e=e,this.#r=new Me(this.#t,{numbers:!1}),this.#t.setAttribute("role","application"),Ma(this.#r,()=>{let t=this.#f!==null&&this.#o&&k(this.#o.recording.moments.
at(-1),this.#f);return t?{cell:t,diagonal:this.#o.config.diagonal}:null},t=>this.act(t)),this.player.addEventListener("frame",()=>this.#o&&this.#r.show(this.#o.
recording,this.player.time)),this.player.addEventListener("step",()=>this.#k()),this.element=d("div",{class:"play"},d("header",{class:"play-head"},this.#s,this.#a),
d("div",{class:"play-stage"},this.#t),d("div",{class:"play-side"},this.#u,this.#n.element,d("label",{class:"play-choice",title:"Steps a second"},"Pace ",this.#l),
d("label",{class:"play-choice"},this.#d,d("span",{},"Fog",d("span",{class:"at-length"},": see only what it sees"))),this.#i,this.#h),this.#c)}get played(){return this.#p&&
{...this.#p.played,moves:this.#y}}get live(){return this.#o}play(e){this.#w(Cn(this.#e,e.played),e.played.seat,e.title),[this.#p,this.#y,this.#v]=[e,[...e.played.
moves],0],this.element.dataset.state="playing",this.#t.focus({preventScroll:!0}),Tr(this.#o,e.played.seat)&&this.#O()}watch(e,t,n){this.#p=null,this.#w(e,t,n),this.#_()}stop(){
this.#C(),this.player.pause(),this.#p=null}act(e){let[t,n]=[this.#p,this.#o];if(!t||!n||this.element.dataset.state!=="playing")return;this.#v=e;let s=Number(this.#l.
value);this.#x||(this.#R(),s&&this.element.dataset.state==="playing"&&(this.#x=setInterval(()=>this.#R(),1e3/s)))}key(e){let{target:t,key:n}=e;if(t instanceof HTMLSelectElement||
t instanceof HTMLInputElement&&(t.type==="text"||n===" ")||t instanceof HTMLButtonElement&&(n===" "||n==="Enter")||!this.#o)return!1;if(this.element.dataset.state!==
"playing")return hr(this.player,e);let o=Sa(e,this.#o.config.diagonal);return o!==void 0&&this.act(o),o!==void 0}#w(e,t,n){this.#C(),this.player.pause(),[this.#o,
this.#f]=[e,t],this.#s.textContent=n,this.#t.ariaLabel=`Board, ${e.config.rows} by ${e.config.cols} cells`,this.#n.show(e.config.diagonal),this.#h.replaceChildren(
d("span",{class:"at-length"},`W A S D or the arrow keys move, Space stays${e.config.diagonal?"; Q E Z C and the numeric keypad move diagonally":""}. `),"On the \
board: swipe, or tap where to go."),this.#S(e),this.#u.replaceChildren(),this.player.length=e.length,this.player.jump(e.length),this.#k()}#A(){this.#r.look={you:this.#f,
fog:this.#d.checked,viewers:this.#f===null?[]:[this.#f],plan:this.#T()}}#S(e){this.#g=null,this.#b=this.player.ticks=[],this.#i.hidden=this.#m.disabled=!!Lt(e.config),
fr(this.#e,e.config,Jo(e.config)).then(t=>{this.#o===e&&(this.#g=t,this.#E(),this.#k())})}#E(){let[e,t]=[this.#o,this.#g];if(!t||this.element.dataset.state==="p\
laying")return;let n=this.#e.world(e.config);n.reset(e.start),this.#b=yr(t,n,e.actions),n.free(),this.player.ticks=gr(this.#b)}get#M(){return this.#m.checked&&this.#p&&
this.element.dataset.state==="playing"&&this.#g&&this.#o.game(this.#g)||null}#T(){let[e,t]=[this.#f,this.#f!==null&&this.#M?.marginal(this.#f)];return e!==null&&
t?Object.assign(Array(e).fill(0),{[e]:t.indexOf(Math.max(...t))}):null}#C(){clearInterval(this.#x),this.#x=0,this.#a.ariaLive=Number(this.#l.value)?"off":"polit\
e"}#R(){let[{policies:e,seat:t},n]=[this.#p.played,this.#o];n.step(e,t,this.#v),this.#y.push(this.#v),this.player.length=n.length,this.player.glide=Math.min(.22,
.9/(Number(this.#l.value)||4)),this.player.move(n.length-this.player.step),Tr(n,t)&&this.#O()}#O(){this.#C();let[e,t,n]=[this.#p,this.#o,this.played],s=Ft()?e.link(
n):null,o=`${K(n.seat,t.config.n_pursuers)}-${t.length}-steps.npz`,a=()=>Ut(o,Ra(this.#e,t,n.seat));this.#u.replaceChildren(d("h3",{id:"play-headline"},ac(t,n.seat)),
...e.ending(t,n),d("div",{class:"play-buttons"},d("button",{type:"button",class:"primary",onclick:()=>e.again()},"Again"),d("button",{type:"button",onclick:()=>this.#_()},
"Watch it"),d("button",{type:"button",onclick:a},"Save"),s&&d("button",{type:"button",onclick:({currentTarget:l})=>lc(l,s)},"Link"))),this.element.dataset.state=
"ended",this.#E();let i=this.#b.filter(({team:l})=>l===de(t.config,n.seat));i.length&&this.#u.children[0].after(d("p",{class:"small muted"},Qo(i))),this.#u.focus(
{preventScroll:!0}),this.#u.scrollIntoView({block:"nearest"})}#_(){this.element.dataset.state="watched",this.player.length=this.#o.length,this.player.jump(0),ye()||
this.player.play()}#k(){let[e,t,{step:n}]=[this.#o,this.#f,this.player];if(!e||n>e.length)return;let s=vr(e,e.recording,n).filter(({agents:l})=>t===null||l.includes(
t)),o=this.#p&&n===0,a=o?[sc(e.config,t),this.#p.about??""]:[`Step ${n} of ${e.config.max_steps}`,...s.map(({text:l})=>l)];!o&&t!==null&&a.push(oc(e,n,t)),a.push(
...this.#b.filter(l=>l.step===n).map(bt));let i=n===e.length&&t!==null?this.#M:null;i&&a.push(`Perfect play: ${ta(i,t)||"decided in its turn"}; ${ea(this.#g,i,n)}`),
this.#A(),this.#a.textContent=a.filter(Boolean).map(l=>`${l}.`).join(" ")}};function sc(r,e){let t=r.rules.capture==="SURROUND";return de(r,e)==="evader"?`Run a\
way: you win if ${t?"the pursuers do not surround you":"no pursuer reaches your cell"} in ${r.max_steps} steps`:`Capture evaders: ${t?"surround them with your t\
eam":"move onto their cells"}`}function oc({config:r,recording:e},t,n){let s=e.moments[t],a=de(r,n)==="pursuer"?"evader":"pursuer";if(!s.alive[n])return"";let i=k(
s,n),l=u=>{let[m,p]=k(s,u);return Math.max(Math.abs(m-i[0]),Math.abs(p-i[1]))},c=Array.from({length:s.alive.length},(u,m)=>m).filter(u=>de(r,u)===a&&s.alive[u]&&
!s.captured[u-r.n_pursuers]&&2*l(u)<r.fov);if(!c.length)return`No ${a} in view`;let h=c.reduce((u,m)=>l(m)<l(u)?m:u);return`Nearest ${a}: ${Ta(i,k(s,h))}`}function ac(r,e){
let[{lasted:t,out:n,captured:s},{config:o}]=[Ze(r,e),r];return de(o,e)==="pursuer"?`Your team captured ${s} of ${ic(o)} in ${t} steps.`:n?`You lasted ${t} of ${o.
max_steps} steps.`:`You escaped: ${t} steps.`}var ic=({n_evaders:r})=>`${r} evader${r===1?"":"s"}`;function lc(r,e){let t=fs("Link to this match");t.value=e,r.replaceWith(
t),t.select(),navigator.clipboard?.writeText(e).catch(()=>{})}var cc=2n**64n-1n;function Oa(r,e,t){let n=new URLSearchParams(r.replace(/^#/,"")),s=(c,h,u)=>{let m=n.get(c)??"";return/^\d{1,9}$/.test(m)&&Number(m)<h?Number(
m):u},o=s("run",e.length,t.run),[a,i]=e[o].payoff.shape,l=n.get("seed")??"";return{run:o,pursuer:s("pursuers",a,Math.min(t.pursuer,a-1)),evader:s("evaders",i,Math.
min(t.evader,i-1)),episode:s("episode",1/0,t.episode),seed:/^\d{1,20}$/.test(l)&&BigInt(l)<=cc?l:null,step:s("step",1/0,0)}}var Cr=class{dialog=d("dialog",{class:"take-over","aria-label":"Play an agent",onclose:()=>this.view?.stop(),onkeydown:e=>this.view?.key(e)&&e.preventDefault()});view=null;#e;#r;#t;#s;#a=null;constructor(e,t,n,s=!0){
[this.#e,this.#r,this.#t,this.#s]=[e,t,n,s],n.element.addEventListener("takeover",()=>this.open())}start(e,t=""){this.#a=e;let n=Oa(t,this.#e,this.#r.selected),
{world:s}=this.#e[n.run],o=s&&ba(new URLSearchParams(t.replace(/^#/,"")),s);o&&this.play(n,o)}open(){let e=this.#t.shown;if(!e)return;let{match:t,step:n}=e;this.#t.
player.pause();let s=this.#t.inspector.agent,o=n<t.length?n:0,a=(u,m)=>!!t.alive[m*t.n_agents+u],i=Array.from({length:t.n_agents},(u,m)=>(m+t.config.n_pursuers)%
t.n_agents),l=s??i.find(u=>a(u,o)),c=a(l,o)?o:0,h=Array.from({length:c},(u,m)=>t.actions[m*t.n_agents+l]);this.play(this.#r.selected,{seat:l,from:c,moves:h})}play(e,t){
let[n,s]=[this.#a,this.#e[e.run]],{world:o}=s;if(!n||!o||Oe.some(v=>jt(s,v,e[v])))return;let{run:a,pursuer:i,evader:l,episode:c,seed:h}=e,u=de(o,t.seat),m=s.teams[u].
kept.map(v=>({name:s.teams[u].script??`generation ${v}`,text:"",policy:()=>se(s,u,v)}));this.view||(this.view=new Er(n),this.dialog.append(d("button",{type:"but\
ton",class:"leave",onclick:()=>this.dialog.close()},"Close"),this.view.element)),this.dialog.open||this.dialog.showModal();let p=`You are ${K(t.seat,o.n_pursuers)}\
: ${this.#t.names(e).join(" against ")}`,g={pursuer:se(s,"pursuer",i),evader:se(s,"evader",l)},f={config:o,seed:BigInt(h??s.seeds[i][l]),episode:c,policies:g,...t},
y={run:a,pursuers:i,evaders:l,episode:c,...h===null?{}:{seed:h}};kn(n,this.view,p,f,m,this.#s?y:null)}};var uc=8,hc=700,_a=1400,At=class{element;player=new Te(0,{speed:uc,still:ye()});title=d("figcaption");generation=0;#e=d("canvas");#r;#t=d("p",{class:"small mute\
d numbers"});#s=d("p",{class:"small",role:"status"});#a;#n=null;#l=0;#d=0;#m=!ye();constructor(e){this.#a=e,this.#r=new Me(this.#e,{numbers:!1}),this.element=d(
"figure",{class:"chase"},this.title,this.#e,this.#t,this.#s),this.player.addEventListener("frame",()=>this.#u()),this.player.addEventListener("step",()=>this.#c()),
this.player.addEventListener("state",()=>{this.#m&&!this.player.playing&&this.player.length&&this.player.step===this.player.length&&this.#i()})}set label(e){this.#e.
ariaLabel=e}get runs(){return this.#m}set runs(e){this.#m=e,clearTimeout(this.#d),e?this.player.play():this.player.pause()}renew(e=!1){e||!this.#n||performance.
now()-this.#l>_a?this.#h():this.#i(_a)}#i(e=hc){clearTimeout(this.#d),this.#d=setTimeout(()=>this.#h(),e)}#h(){clearTimeout(this.#d);let e=this.#a();e&&(this.#n=
lr(e),this.#l=performance.now(),this.player.jump(0),this.player.length=e.length,this.player.marks=rr(this.#n),this.#c(),this.#m&&this.player.play())}#u(){this.#n&&
this.#r.show(this.#n,this.player.time)}#c(){let e=this.#n?.moments[this.player.step]?.everCaptured;e&&(this.#t.textContent=`generation ${this.generation} · ${Array.
from(e).filter(Boolean).length} of ${e.length} caught · step ${this.player.step}`)}drawWalls(e){let t=!1,n=!0,s=[0,0],o=([l,c])=>!!this.#n?.obstacles[l*this.#n.
cols+c],a=(l,c)=>{this.#s.textContent=e(l,c)},i=l=>{let c=this.#r.cellAt(l.clientX,l.clientY);c&&o(c)!==n&&a(c,n)};return this.#e.addEventListener("pointerdown",
l=>{let c=t&&this.#r.cellAt(l.clientX,l.clientY);c&&(this.#e.setPointerCapture(l.pointerId),n=!o(c),i(l))}),this.#e.addEventListener("pointermove",l=>t&&l.buttons&&
i(l)),this.#e.addEventListener("keydown",l=>{let c={ArrowUp:[-1,0],ArrowDown:[1,0],ArrowLeft:[0,-1],ArrowRight:[0,1]}[l.key];if(!t||!this.#n||!(c||l.key===" "))
return;l.preventDefault();let h=(p,g)=>Math.min(g-1,Math.max(0,p)),{rows:u,cols:m}=this.#n;c?s=[h(s[0]+c[0],u),h(s[1]+c[1],m)]:a(s,!o(s)),this.#r.look={cursor:s}}),
l=>{t=l,this.#e.classList.toggle("drawn-on",l),this.#e.tabIndex=l?0:-1,this.#e.setAttribute("role",l?"application":"img"),this.#r.look={cursor:null}}}show(e){this.#n&&
(this.#n={...this.#n,obstacles:e},this.#u())}};var R=r=>Array.from(r).reduce((e,t)=>e+t,0)/r.length,Pa=(r,e)=>e==="pursuer"?r:r[0].map((t,n)=>r.map(s=>1-s[n])),$a=(r,e)=>R(Pa(r,e).at(-1));function Na(r,e){let t=[],
n=Pa(r,e).map(s=>R(s.map((o,a)=>(t[a]=Math.max(t[a]??0,o),t[a]-o))));return R(n.slice(Math.floor(n.length/2)))}var La=-12676506002282294e14,Ia=({hidden:r,mask:e})=>r.map(t=>t+(e?4:0));function Mt(r){let e=[3*r.fov**2,...Ia(r),5],t=0;return e.slice(1).map((n,s)=>{let o={at:t,
inputs:e[s],outputs:n};return t+=(o.inputs+1)*n,o})}function Le(r){if(r.kind==="rating")return r.inputs.length;let{at:e,inputs:t,outputs:n}=Mt(r).at(-1);return e+
(t+1)*n}var Tt=(r,e)=>r.kind==="rating"?{...r,genome:e}:{kind:"cells",hidden:Ia(r),activation:"relu",sampled:!0,memory:"none",genome:e};function Fa(r,e,t){let n=t.
initial_weight;if(r.kind==="rating"||t.kind==="rating")return e.normals(Le(r)).map(i=>Math.fround(n)*i);let s=t.initial_head,o=new Float32Array(Le(r)),a=Mt(r);return a.
forEach(({at:i,inputs:l,outputs:c},h)=>{let u=Math.fround(h===a.length-1?s:n);e.normals(l*c).forEach((m,p)=>o[i+p]=u*m)}),o}function On(r){if(r.kind==="rating")
return null;let{fov:e,mask:t}=r;if(!t)return null;let[n,s]=[new Uint8Array(Le(r)),new Float32Array(Le(r))],o=Mt(r),a=o.length-1,i=Math.floor(e/2);return o.forEach(
({at:l,inputs:c,outputs:h},u)=>{let m=(p,g)=>l+p*h+g;for(let p=0;p<4;p++)if(u>0&&n.fill(1,m(c-4+p,0),m(c-4+p+1,0)),u<a)for(let g=0;g<=c;g++)n[m(g,h-4+p)]=1;t.forEach(
(p,g)=>{let f=u===a?1+g:h-4+g,y=u===0?p.map(([v,S,w])=>(v*e+i+S)*e+i+w):[c-4+g];for(let v of y)n[m(v,f)]=1,s[m(v,f)]=u===a?La:1})}),{fixed:n,values:s}}function _n(r,e){
return e?r.map((t,n)=>e.fixed[n]?e.values[n]:t):r}function Ua(r,e,t){if(e.kind==="rating"||t.kind==="rating")return r;let n=new Float32Array(Le(t)),[s,o]=[Mt(e),
Mt(t)],a=Math.floor(t.fov/2)-Math.floor(e.fov/2),i=c=>c>=0&&c<t.fov,l=c=>{let[h,u,m]=[Math.floor(c/e.fov**2),Math.floor(c/e.fov)%e.fov+a,c%e.fov+a];return i(u)&&
i(m)?(h*t.fov+u)*t.fov+m:-1};return s.forEach((c,h)=>{let u=o[h],m=e.hidden[h]??5;for(let p=0;p<(h?e.hidden[h-1]:c.inputs);p++){let g=h?p:l(p);if(!(g<0))for(let f=0;f<
m;f++)n[u.at+g*u.outputs+f]=r[c.at+p*c.outputs+f]}for(let p=0;p<m;p++)n[u.at+u.inputs*u.outputs+p]=r[c.at+c.inputs*c.outputs+p]}),_n(n.map(c=>c<=La/2?0:c),On(t))}var Ba={initial:1,noise:2,learn:3,opponents:4},$n={pursuer:1,evader:2,both:3},Ie=4,Pn=2n**32n;function Da(r){let e=[],t=BigInt(r);do e.push(Number(t%Pn)),t/=Pn;while(t>
0n);return e}function Wa(r,e){let t=r;return n=>{let s=n^t;return t=Math.imul(t,e),s=Math.imul(s,t),s^s>>>16}}function za(r,e){let t=Math.imul(3389127133,r)-Math.
imul(1232336661,e)|0;return t^t>>>16}function Nn(r,e,t){let n=r.flatMap(Da);if(e.length){for(;n.length<Ie;)n.push(0);n.push(...e.flatMap(Da))}let s=Wa(1135663077,
2468251765),o=Array.from({length:Ie},(i,l)=>s(n[l]??0));for(let i=0;i<Ie;i++)for(let l=0;l<Ie;l++)i!==l&&(o[l]=za(o[l],s(o[i])));for(let i of n.slice(Ie))for(let l=0;l<
Ie;l++)o[l]=za(o[l],s(i));let a=Wa(2337405405,1492356589);return Uint32Array.from({length:t},(i,l)=>a(o[l%Ie]))}function Et(r,e){let t=Nn(r,[],2*e);return BigUint64Array.
from({length:e},(n,s)=>BigInt(t[2*s])+Pn*BigInt(t[2*s+1]))}var kr=(r,e,t)=>Et([r,e,t],1)[0];var Ga=r=>(e,...t)=>new Ln(Nn([r],[Ba[e],...t],3)),Ln=class{#e;#r;#t;#s=1;constructor(e){[this.#e,this.#r,this.#t]=[e[0],e[1],e[2]];for(let t=0;t<12;t++)this.#a()}#a(){
let e=this.#e+this.#r+this.#s++|0;return this.#e=this.#r^this.#r>>>9,this.#r=this.#t+(this.#t<<3)|0,this.#t=(this.#t<<21|this.#t>>>11)+e|0,e>>>0}#n(){return(this.#a()+
.5)/2**32}normals(e){let t=new Float32Array(e);for(let n=0;n<e;n+=2){let[s,o]=[Math.sqrt(-2*Math.log(this.#n())),2*Math.PI*this.#n()];t[n]=s*Math.cos(o),n+1<e&&
(t[n+1]=s*Math.sin(o))}return t}integers(e,t){return Int32Array.from({length:t},()=>Math.floor(this.#n()*e))}permutation(e){return this.choice(e,e)}choice(e,t){
let n=Int32Array.from({length:e},(s,o)=>o);for(let s=0;s<t;s++){let o=s+Math.floor(this.#n()*(e-s));[n[s],n[o]]=[n[o],n[s]]}return n.slice(0,t)}};var C=Math.fround,dc=5,mc=256,Rr=class{size;sigma;fixed;#e;constructor(e,t,n,s){[this.size,this.sigma,this.fixed]=[e,n,s],this.#e=t.normals((1+mc)*e);for(let o=0;o<
this.#e.length;o++)this.#e[o]*=C(n)}draw(e,t){let n=t.integers(this.#e.length-this.size+1,e);return Array.from(n,s=>{let o=this.#e.subarray(s,s+this.size);return this.
fixed?o.map((a,i)=>this.fixed[i]?0:a):o})}},In=class{#e;#r;#t=0;constructor(e){[this.#e,this.#r]=[new Float32Array(e),new Float32Array(e)]}moved(e,t,n){let[s,o,
a]=[.9,.999,C(1e-8)];this.#t+=1;let[i,l]=[C(1-s),C(1-o)],[c,h]=[C(1-s**this.#t),C(1-o**this.#t)];return e.map((u,m)=>{let p=t[m],g=this.#e[m]+=C(i*C(p-this.#e[m])),
f=this.#r[m]+=C(l*C(C(p*p)-this.#r[m])),y=C(C(Math.sqrt(C(C(f)/h)))+a);return C(u+C(C(C(n)*C(C(g)/c))/y))})}};function pc(r){let e=Array.from(r).sort((t,n)=>t-n);
return r.map(t=>(e.indexOf(t)+e.lastIndexOf(t))/(2*(r.length-1))-.5)}var Or=class{genome;groups;#e;#r;#t;#s=[];constructor(e,t,n){[this.genome,this.#r,this.#e,this.#t]=
[e,t,n,new In(e.length)],this.groups=Int32Array.from({length:n.population},(s,o)=>o%(n.population/2))}get#a(){let{sigma:e,fixed:t}=this.#r,[n,s]=[0,0];return this.
genome.forEach((o,a)=>{t?.[a]||(n+=o*o,s+=1)}),Math.max(e,this.#e.relative_sigma*Math.sqrt(n/s))}ask(e){let[t,n]=[this.#e.population/2,this.genome.length];this.#s=
this.#r.draw(t,e);let s=C(this.#a/this.#r.sigma),o=new Float32Array(2*t*n);return this.#s.forEach((a,i)=>{for(let l=0;l<n;l++){let c=C(s*a[l]);o[i*n+l]=this.genome[l]+
c,o[(t+i)*n+l]=this.genome[l]-c}}),o}tell(e){let[t,n]=[pc(e),this.#s.length],s=new Float32Array(this.genome.length);this.#s.forEach((o,a)=>{let i=C((t[a]-t[n+a])/
(2*n*this.#r.sigma**2));for(let l=0;l<s.length;l++)s[l]+=C(i*o[l])}),this.genome=this.#t.moved(this.genome,s,this.#e.learning_rate)}},Ct=class{population;groups;#e;#r;#t=new Float64Array(
0);#s=0;constructor(e,t,n){[this.population,this.#r,this.#e]=[e,t,n],this.groups=new Int32Array(n.population)}get genome(){return this.#a(this.#s).slice()}#a(e){
let{size:t}=this.#r;return this.population.subarray(e*t,(e+1)*t)}#n(e,t){let n=this.#e.tournament??dc,s=t.integers(this.#t.length,e*n);return Array.from({length:e},
(o,a)=>s.subarray(a*n,(a+1)*n).reduce((i,l)=>this.#t[l]>this.#t[i]?l:i))}ask(e){if(!this.#t.length)return this.population;let{size:t}=this.#r,{population:n,elites:s}=this.#e,
o=n-s,a=this.#n(o,e);this.#n(o,e);let i=Array.from(this.#t.keys()).sort((c,h)=>this.#t[h]-this.#t[c]).slice(0,s),l=new Float32Array(this.population.length);return[
...i,...a].forEach((c,h)=>l.set(this.#a(c),h*t)),this.#r.draw(o,e).forEach((c,h)=>{let u=(s+h)*t;for(let m=0;m<t;m++)l[u+m]+=c[m]}),this.population=l,l}tell(e){
this.#t=e,this.#s=e.indexOf(Math.max(...e))}};function Ha(r,e,t,n){let[s,o]=[r.length,Math.max(...r)+1],a=o>1?s/o:1,i=Array.from(r.keys()).sort((u,m)=>r[u]-r[m]),l=[],c=[];for(let u=0;u<e;u++){let m=u%a;m===
0&&(c=Array.from(n.permutation(s/a)).flatMap(p=>i.slice(p*a,(p+1)*a))),l.push([i,c.map((p,g)=>c[g-g%a+(g%a-m+a)%a])])}let h=u=>i.map(()=>s+u);for(let u=0;u<t[1];u++)
l.push([i,h(u)]);for(let u=0;u<t[0];u++)l.push([h(u),i]);return{pursuer:Int32Array.from(l.flatMap(([u])=>u)),evader:Int32Array.from(l.flatMap(([,u])=>u)),group:Int32Array.
from(l.flatMap((u,m)=>i.map(p=>m*o+r[p])))}}function ja(r,e,t,n){let s=Math.max(...e)+1,[o,a]=[new Float64Array(t*s),new Float64Array(t*s)];n.forEach((l,c)=>{if(r[c]>=
t)return;let h=r[c]*s+e[c];o[h]+=l,a[h]+=1});let i=o.map((l,c)=>a[c]?l/a[c]:0);return Float64Array.from({length:t},(l,c)=>{let h=i.subarray(c*s,(c+1)*s);return Fn(
h)/a.subarray(c*s,(c+1)*s).filter(Boolean).length})}var fc=128,Je=8;function Fn(r){let{length:e}=r;if(e>fc){let m=Math.floor(e/2)-Math.floor(e/2)%Je;return Fn(r.
subarray(0,m))+Fn(r.subarray(m))}if(e<Je)return r.reduce((m,p)=>m+p,0);let t=r.slice(0,Je),n=e-e%Je;for(let m=Je;m<n;m++)t[m%Je]+=r[m];let[s,o,a,i,l,c,h,u]=t;return r.
subarray(n).reduce((m,p)=>m+p,s+o+(a+i)+(l+c+(h+u)))}var T=["pursuer","evader"],Fe=r=>r==="pursuer"?"evader":"pursuer";var Va=({world:r})=>r.rules.teammate==="REACH"?.2:0;var Ya=["generation","team","epoch","opponent","fitness_mean","fitness_std","fitness_best","capture_rate","length","pursuer_faults","evader_faults","matches","s\
teps"],Pr={pursuer:["random","clumsy-fleer"],evader:["random","clumsy-chaser"]},yc=20,gc=8,vc=-1,$r=({world:r,policy:e},t,n)=>e.kind==="rating"?e:{kind:"cells",
fov:r.fov,hidden:e.hidden,mask:e.mask==="none"?null:t[n]},Xe=class{settings;archive={pursuer:[],evader:[]};rows=[];cells=new Map;counters={pursuer:[],evader:[]};#e;#r;#t;#s={};#a=new Set;#n=0;#l=0;#d=0;constructor(e,t,n,s=Ga(
t.seed)){[this.#e,this.settings,this.#r,this.#t]=[e,t,n,s];for(let o of T){let a=s("initial",T.indexOf(o)),i=t.learner.kind==="ga"?t.learner.population:1,l=Array.
from({length:i},()=>Fa(this.shape(o),a,t.policy));this.#i(o,l),this.archive[o].push(this.#s[o].genome)}this.#x(...T)}shape(e){return $r(this.settings,this.#r,e)}get finished(){
return Math.min(this.archive.pursuer.length,this.archive.evader.length)}*run(){yield*this.#w(0);for(let e=1;e<=this.settings.schedule.generations;e++){if(this.settings.
schedule.kind==="alternating")for(let t of T)yield*this.#h(t,e),this.#x(t);else yield*this.#u(e),this.#x(...T);yield*this.#w(e)}}change(e){let t=this.settings,n={
pursuer:this.shape("pursuer"),evader:this.shape("evader")},s=l=>JSON.stringify(l(t))===JSON.stringify(l(e));this.settings=e;let o=s(l=>[l.world.fov,l.policy]);if(!o||
!s(l=>l.learner))for(let l of T){let c=h=>Ua(h,n[l],this.shape(l));this.archive[l]=this.archive[l].map(c),this.#i(l,this.#m(l).map(c))}if(o&&s(l=>l.world))return null;
this.cells.clear(),this.#a.clear();let{pursuer:a,evader:i}=this.archive;return{type:"anew",settings:e,genomes:{pursuer:a.slice(0,this.finished),evader:i.slice(0,
this.finished)}}}#m(e){let t=this.#s[e];if(!(t instanceof Ct))return[t.genome];let n=t.genome.length,s=Array.from({length:t.population.length/n},(o,a)=>t.population.
slice(a*n,(a+1)*n));return Array.from({length:this.settings.learner.population},(o,a)=>a===0?t.genome:s[a%s.length])}#i(e,t){let{learner:n}=this.settings,[s,o]=[
this.shape(e),n.kind==="ga"?n.mutation:n.sigma],a=On(s),i=new Rr(Le(s),this.#t("noise",T.indexOf(e)),o,a?.fixed??null),l=t.map(c=>_n(c,a));this.#s[e]=n.kind==="\
ga"?new Ct(_r(l),i,n):new Or(l[0],i,n)}*#h(e,t){for(let n=0;n<this.#o(e);n++){let s=this.archive[Fe(e)].length,o=this.settings.schedule[`${e}s_meet`],a=o==="lat\
est"?s-1:o==="round-robin"?n%s:this.#t("opponents",T.indexOf(e),t,n).choice(s,1)[0],i=e==="pursuer"?[t,a]:[a,t],l=this.#s[e],{groups:c}=l,h=Et([this.settings.seed,
...i,$n[e],n],Math.max(...c)+1),u=l.ask(this.#t("learn",T.indexOf(e),t,n)),[m,p]=[Int32Array.from(c.keys()),new Int32Array(c.length)],g={[e]:u,[Fe(e)]:this.archive[Fe(
e)][a]},f={[e]:m,[Fe(e)]:p},y=this.#f(g,f,BigUint64Array.from(c,S=>h[S])),v=this.#b(y,e);this.#v(y,v,{generation:t,team:e,epoch:n,opponent:a}),l.tell(v),yield*this.#y(
t,n,e)}this.archive[e].push(this.#s[e].genome)}*#u(e){for(let t=0;t<this.#o("pursuer");t++){let{schedule:n,learner:{population:s}}=this.settings,[o,a]=n.kind===
"hall-of-fame"?[n.hall_sample,n.contemporaries]:[0,1],i={pursuer:this.#c("pursuer",e,t),evader:this.#c("evader",e,t)},l=this.#t("opponents",0,e,t),c={pursuer:this.#p(
o,l),evader:this.#p(o,l)},h=y=>_r([i[y],...Array.from(c[Fe(y)],v=>this.archive[y][v])]),u=[c.evader.length,c.pursuer.length],m=Ha(this.#s.pursuer.groups,a,u,l),
p=Et([this.settings.seed,e,e,$n.both,t],Math.max(...m.group)+1),g={pursuer:h("pursuer"),evader:h("evader")},f=this.#f(g,m,BigUint64Array.from(m.group,y=>p[y]));
for(let y of T){let v=ja(m[y],m[Fe(y)],s,this.#b(f,y));this.#v(f,v,{generation:e,team:y,epoch:t,opponent:vc}),this.#s[y].tell(v)}yield*this.#y(e,t,"both")}for(let t of T)
this.archive[t].push(this.#s[t].genome)}#c(e,t,n){return this.#s[e].ask(this.#t("learn",T.indexOf(e),t,n))}#p(e,t){let n=this.archive.pursuer.length;return e?t.
choice(n,Math.min(e,n)):new Int32Array(0)}#o(e){let{schedule:t}=this.settings;return t.kind==="hall-of-fame"?t.joint_epochs:t[`${e}_epochs`]}*#y(e,t,n){let[s,o]=this.
settings.schedule.kind==="hall-of-fame"?[this.#o("pursuer"),0]:[this.#o("pursuer"),this.#o("evader")],a=t+1+(n==="evader"?s:0),i=s+o;yield{type:"epoch",done:(e-
1)*i+a,of:this.settings.schedule.generations*i},yield*this.catchUp()}#f(e,t,n){let s={...this.settings.world,max_steps:this.settings.train_steps},o=this.#e.rollouts(
s,this.#g("pursuer",e.pursuer),this.#g("evader",e.evader),{...t,seed:n},1);this.#n+=o.length.length;for(let a of o.length)this.#l+=Number(a);for(let a of o.agent_steps)
this.#d+=Number(a);return o}#g(e,t){return Tt(this.shape(e),t)}#b({captured_fraction:e,overlap:t},n){let s=Va(this.settings);return Float64Array.from(e,(o,a)=>n===
"pursuer"?o:1-o-s*Number(t[2*a+1]))}#v(e,t,n){let s=R(t),o=[0,0];e.faults.forEach((a,i)=>o[Math.floor(i/3)%2]+=Number(a)),this.rows.push({...n,fitness_mean:s,fitness_std:Math.
sqrt(R(t.map(a=>(a-s)**2))),fitness_best:Math.max(...t),capture_rate:R(e.capture_rate),length:R(e.length),pursuer_faults:o[0]/e.length.length,evader_faults:o[1]/
e.length.length,matches:this.#n,steps:this.#l})}#x(...e){for(let t of e)this.counters[t].push({matches:this.#n,steps:this.#l,agent_steps:this.#d})}*#w(e){yield{
type:"generation",number:e,genomes:{pursuer:this.archive.pursuer[e],evader:this.archive.evader[e]}},yield*this.catchUp()}*catchUp(){for(let e=this.finished-1;e>=
0;e--){for(let t=e;t>=0;t--)for(let[n,s]of t===e?[[e,e]]:[[e,t],[t,e]]){if(this.cells.has(`${n} ${s}`))continue;let o=this.#A(n,s);this.cells.set(`${n} ${s}`,o),
yield{type:"cell",cell:o}}this.#a.has(e)||(this.#a.add(e),yield{type:"scores",number:e,scores:{pursuer:this.#S("pursuer",e),evader:this.#S("evader",e)}})}}#A(e,t){
let{world:n,evaluation_episodes:s,seed:o}=this.settings,a={pursuer:new Int32Array(1),evader:new Int32Array(1),seed:BigUint64Array.of(kr(o,e,t))},i=T.map(h=>this.#g(
h,this.archive[h][h==="pursuer"?e:t])),l=this.#e.rollouts(n,...i,a,s),c=h=>{let u=Array.from(l[h],Number),m=u.length/s;return Array.from({length:m},(p,g)=>R(u.filter(
(f,y)=>y%m===g)))};return{pursuer:e,evader:t,capture_rates:Array.from(l.capture_rate),lengths:Array.from(l.length),means:{collisions:c("collisions"),faults:c("f\
aults"),agent_steps:c("agent_steps"),survivors:c("survivors")}}}#S(e,t){let{world:n,seed:s}=this.settings,[o,a]=[this.#g(e,this.archive[e][t]),new Int32Array(1)];
return R(Pr[e].map((i,l)=>{let c=Et([s,T.indexOf(e),l,gc],1),h=e==="pursuer"?[o,i]:[i,o],u=R(this.#e.rollouts(n,...h,{pursuer:a,evader:a,seed:c},yc).capture_rate);
return e==="pursuer"?u:1-u}))}};function _r(r){let e=new Float32Array(r.reduce((n,{length:s})=>n+s,0)),t=0;for(let n of r)e.set(n,t),t+=n.length;return e}var Un=r=>Array.from({length:r},()=>Array(r)),Nr=class{learning=T;settings=[];training={capture_rate:[],generation:[],learner:[],epochs:1,window:1,matches:0};limits="";name;schedule;seed;seeds;world;payoff;teams;findings=null;genomes={
pursuer:[],evader:[]};#e;#r;#t;constructor(e,t,n,s){[this.#t,this.#e,this.#r,this.name,this.schedule]=[e,t,s,n,n],[this.world,this.seed]=[e.world,String(e.seed)];
let o=e.schedule.generations+1;this.seeds=Array.from({length:o},(a,i)=>Array.from({length:o},(l,c)=>String(kr(e.seed,i,c)))),this.payoff=this.#s(),this.teams=this.#a()}get newest(){
return this.genomes.pursuer.length-1}#s(){let e=this.#t.schedule.generations+1;return{first:[0,0],shape:[e,e],episodes:this.#t.evaluation_episodes,capture_rate:Un(
e),capture_rates:Un(e),lengths:Un(e)}}#a(){let e=t=>{let n=`${this.#r} ${t}`;Bs(n,_r(this.genomes[t]));let{genome:s,...o}=Tt($r(this.#t,this.#e,t),this.genomes[t][0]??
new Float32Array(0));return{script:null,policy:{...o,genome_size:s.length},kept:[...this.genomes[t].keys()],genomes:n}};return{pursuer:e("pursuer"),evader:e("ev\
ader")}}policy(e,t){return this.playing(e,this.genomes[e][t])}playing(e,t){return Tt($r(this.#t,this.#e,e),t)}add(e){for(let t of T)this.genomes[t].push(e[t]);this.
teams=this.#a()}change(e,t){this.#t=e,this.world=e.world;for(let n of T)this.genomes[n]=[...t[n]];[this.payoff,this.teams,this.findings]=[this.#s(),this.#a(),null]}addCell({
pursuer:e,evader:t,capture_rates:n,lengths:s}){this.payoff.capture_rate[e][t]=R(n),this.payoff.capture_rates[e][t]=[...n],this.payoff.lengths[e][t]=[...s],this.
findings={generalization:this.#n()}}#n(){let e=this.payoff.capture_rate,t=o=>({mean:o,low:null,high:null}),n=o=>{let a=o.filter(i=>i!==void 0);return a.length?R(
a):null},s=[...this.genomes.pursuer.keys()];return{pursuers:t(s.map(o=>n(e[o]))),evaders:t(s.map(o=>n(e.map(a=>a[o]===void 0?void 0:1-a[o]))))}}};var bc=2,wc=1.5,xc=20,Lr=class{element=d("section",{class:"card weights-card","aria-label":"Weights of named inputs",hidden:!0});#e;#r;#t=d("div",{class:"evolve\
d"});#s=d("p",{class:"numbers",role:"status"});#a=d("button",{type:"button",onclick:()=>this.#i()},"As evolved");#n=null;#l=null;constructor(e,t){[this.#e,this.#r]=
[e,t],this.element.append(d("h3",{},"What they have learned"),d("p",{class:"small muted"},"An agent takes the move with the largest sum of weight x input. Drag \
a weight, and see at once what becomes of the team."),d("div",{class:"doings"},this.#a,this.#s),this.#t)}genome(e){return this.#l?.[e]??this.#n.genomes[e].at(-1)}show(e){
e!==this.#n&&(this.#l=null),this.#n=e;let{policy:t}=e.teams.pursuer;this.element.hidden=t?.kind!=="rating"||e.newest<0,!(t?.kind!=="rating"||this.element.hidden)&&
(this.#l||this.#t.replaceChildren(...T.map(n=>this.#d(n,t.inputs))),this.#h())}#d(e,t){let n=this.genome(e),s=Math.max(bc,wc*Math.max(...n.map(Math.abs)));return d(
"div",{class:"weights"},d("h4",{class:e},`${e}s`),...t.flatMap((o,a)=>{let i=d("span",{class:"numbers"},je(n[a])),l=d("input",{type:"range",class:e,min:-s,max:s,
step:"any",value:n[a],title:Ee[o],"aria-label":`${e}s: ${o}`});return l.addEventListener("input",()=>{i.textContent=je(Number(l.value)),this.#m(e,a,Number(l.value))}),
[d("span",{title:Ee[o]},o.replaceAll("_"," ")),l,i]}))}#m(e,t,n){this.#l??={pursuer:this.genome("pursuer").slice(),evader:this.genome("evader").slice()},this.#l[e][t]=
n,this.#h(),this.#r()}#i(){this.#l=null,this.show(this.#n),this.#r()}#h(){this.#a.disabled=!this.#l;let e=this.#n.newest,t=s=>`${Math.round(100*this.#u(s))} %`,
n=t({pursuer:this.#n.genomes.pursuer[e],evader:this.#n.genomes.evader[e]});this.#s.textContent=this.#l?`Yours: ${t(this.#l)} are caught; as evolved: ${n}`:`${n}\
 are caught`}#u({pursuer:e,evader:t}){let n=this.#n,s=new Int32Array(1),o={pursuer:s,evader:s,seed:BigUint64Array.of(BigInt(n.seed))};return R(this.#e.rollouts(
n.world,n.playing("pursuer",e),n.playing("evader",t),o,xc).capture_rate)}};var kt=r=>`${Math.round(100*r)} %`,Sc=100,Ac=0,Ir=class extends EventTarget{element;newest;beginning;settings;state="waiting";done=0;seconds=0;#e;#r;#t;#s=d("h2",
{class:"lane-title"});#a=d("p",{class:"facts numbers"});#n=d("div",{class:"lane-room",hidden:!0});#l=d("section",{class:"card measures",hidden:!0});#d=d("div");#m;#i;#h={
pursuer:[],evader:[]};#u=new Map;#c;#p;#o=()=>{};#y=0;#f=!0;#g=0;#b=null;constructor(e,t,n,s){super(),[this.#e,this.#r,this.#t,this.settings]=[e,t,n,s],this.newest=
new At(()=>this.#E(this.#i.newest)),this.beginning=new At(()=>this.#E(0)),this.beginning.element.classList.add("beginning"),this.#m=new Lr(t,()=>this.#M(!0));let o=d(
"div",{class:"boards"},this.newest.element,this.beginning.element);this.element=d("section",{class:"lane"},this.#s,this.#a,o,this.#n,this.#m.element,this.#l,this.#d),
n.onmessage=({data:a})=>this.#x(a),this.reset(s)}reset(e){this.#v({type:"stop"}),[this.settings,this.state,this.done]=[e,"waiting",0],this.#S();let{archive:t}=new Xe(
this.#r,e,this.#e.masks);this.#i.add({pursuer:t.pursuer[0],evader:t.evader[0]}),this.#n.hidden=this.#l.hidden=!0,this.#M(!0),this.#T()}start(){this.#S(),[this.state,
this.done]=["evolving",0],this.#n.hidden=!1,this.#l.hidden=!0,this.#v({type:"start",settings:this.settings,masks:this.#e.masks}),this.#T()}stop(){this.#v({type:"\
stop"}),this.state==="evolving"&&(this.state="stopped"),this.#T()}change(e){if(this.state==="waiting")return this.reset(e);this.settings=e,this.#v({type:"change",
settings:e}),this.#T()}takeOver(){let e=this.#i.newest;this.#p.play({run:0,pursuer:e,evader:e,episode:0,seed:null},{seat:this.#i.world.n_pursuers,from:0,moves:[]})}saved(){
return new Promise(e=>{this.#b=e,this.#v({type:"save"})})}get newestGeneration(){return this.#i.newest}close(){this.#t.terminate(),this.newest.runs=this.beginning.
runs=!1}#v(e){this.#t.postMessage(e)}#x(e){if(e.type==="generation"){if(this.state!=="evolving")return;this.#i.add(e.genomes),this.#M(e.number===0)}else if(e.type===
"cell"){let{pursuer:t,evader:n}=e.cell;this.#i.addCell(e.cell),this.#f&&t===n&&t===this.#i.newest&&this.#c.select({pursuer:t,evader:n}),this.#u.set(`${t} ${n}`,
e.cell)}else if(e.type==="scores")for(let t of T)this.#h[t][e.number]=e.scores[t];else e.type==="anew"?(this.#i.change(e.settings,e.genomes),this.#A(),this.#M(!0)):
e.type==="epoch"?this.done=e.done/e.of:e.type==="end"?(this.state==="evolving"&&([this.state,this.seconds,this.done]=["ended",e.seconds,1]),this.#C()):e.type===
"saved"?this.#b?.(e.race):(this.#a.textContent=`The race failed: ${e.message}`,this.state="stopped");this.#g||(this.#g=setTimeout(()=>requestAnimationFrame(()=>this.#w()),
Sc))}#w(){this.#g=0,this.#c.dispatchEvent(new Event("run")),this.#o(),this.#T()}#A(){this.#u=new Map,this.#h={pursuer:[],evader:[]},this.#l.hidden=!0}#S(){let e=`\
race ${Ac++}`,t=Vt(this.settings);this.#i=new Nr(this.settings,this.#e.masks,t,e),this.#A(),this.#f=!0,this.#c=new Ar({run:0,pursuer:0,evader:0,episode:0,seed:null});
let[n,s]=[new Sr([this.#i],this.#c),new br([this.#i],this.#c,null)];n.element.ariaLabel=`Payoff matrix. ${t}`,this.#p=new Cr([this.#i],this.#c,s,!1),this.#p.start(
this.#r);let o=d("dialog",{class:"of-cell-match","aria-label":"Match",onclose:()=>s.player.pause()},d("button",{type:"button",class:"leave",onclick:()=>o.close()},
"Close"),s.element),a=!1;n.element.addEventListener("play",()=>{let{pursuer:l,evader:c}=this.#c.selected;this.#f=!1,this.#i.payoff.capture_rate[l][c]!==void 0&&
(o.showModal(),a||s.start(this.#r),a=!0,s.playSoon())});let i=Qs(`Scores against scripts, by generation: ${Pr.pursuer.join(", ")} and ${Pr.evader.join(", ")}`,(l,c)=>{
let h=this.settings.schedule.generations,u=Zs(l,c,{low:0,high:h,label:"generation",whole:!0},{low:0,high:1,label:"score"});for(let m of T){let p=Array.from(this.#h[m],
g=>g??null);Js(u,[...p.keys()],p,`of-${m}s`)}return u},()=>{},l=>{let c=Math.min(this.#i.newest,Math.max(0,Math.round(l)));this.#c.select({pursuer:c,evader:c})});
this.#o=i.redraw,this.#n.replaceChildren(n.element,d("section",{class:"card scores"},d("h3",{},"Against opponents that never change"),d("p",{class:"small muted"},
"Captures of random walkers and of clumsy fleers; escapes from random walkers and from clumsy chasers."),Xs(["pursuers","of-pursuers"],["evaders","of-evaders"]),
i.element)),this.#d.replaceChildren(o,this.#p.dialog)}#E(e){let t=this.#i.newest;if(t<0||e<0)return null;let{world:n,payoff:s,seeds:o}=this.#i,a=this.#y++%s.episodes;
this.newest.title.textContent=t?"Newest against newest":"Generation 0: nobody has learned anything yet",this.beginning.title.textContent="Pursuers of generation\
 0, newest evaders";for(let c of[this.newest,this.beginning])c.generation=t;for(let c of[this.newest,this.beginning])c.label=`A match. ${c.title.textContent}`;let[
i,l]=T.map(c=>this.#i.playing(c,c==="pursuer"&&e<t?this.#i.genomes.pursuer[e]:this.#m.genome(c)));return this.#r.match(n,i,l,BigInt(o[e][t]),a)}#M(e){this.#m.show(
this.#i),this.newest.renew(e),(this.#i.newest>0||this.state!=="waiting")&&this.beginning.renew(e)}#T(){this.element.dataset.state=this.state,this.#s.textContent=
Vt(this.settings);let e=this.#u.get(`${this.#i.newest} ${this.#i.newest}`)??this.#u.get(`${this.#i.newest-1} ${this.#i.newest-1}`),t=e?[`Generation ${this.#i.newest}\
 of ${this.settings.schedule.generations}`,`the newest pursuers catch ${kt(R(e.capture_rates))} of the newest evaders`,`${Mc(e).toFixed(0)} collisions in 1000 m\
oves`]:[];this.#a.replaceChildren(...t.map(n=>d("span",{},n))),this.dispatchEvent(new Event("state"))}#C(){this.#l.ariaLabel=`What came out. ${Vt(this.settings)}`;
let e=this.#i.payoff.capture_rate.slice(0,this.#i.newest+1).map(n=>n.slice(0,this.#i.newest+1));if(e.length<2||e.some(n=>Array.from(n).includes(void 0)))return;
let t=[["Score against scripts: generation 0",n=>kt(this.#h[n][0]??0)],["Score against scripts: newest generation",n=>kt(this.#h[n].at(-1)??0)],["Newest generat\
ion against all generations of the other team",n=>kt($a(e,n))],["Below its own best so far, in the later half (forgetting)",n=>kt(Na(e,n))]];this.#l.replaceChildren(
d("h3",{},"What came out"),d("table",{class:"numbers"},d("thead",{},d("tr",{},d("td"),...T.map(n=>d("th",{scope:"col",class:n},`${n}s`)))),d("tbody",{},...t.map(
([n,s])=>d("tr",{},d("th",{scope:"row"},n),...T.map(o=>d("td",{},s(o))))))),d("p",{class:"small muted"},"These are measures without a verdict: one race proves l\
ittle. Save it, and ",d("code",{},"matrixworld judge")," weighs luck and says what happened.")),this.#l.hidden=!1}};function Mc({means:{faults:r,agent_steps:e}}){
let t=n=>n.reduce((s,o)=>s+o,0);return 1e3*t(r)/Math.max(1,t(e))}var Ka=r=>Re(JSON.stringify(r,null,2)),Dn=(r,...e)=>({dtype:"<f8",shape:e,data:Float64Array.from(r)}),Tc=r=>Math.sqrt(R(r.map(e=>(e-R(r))**2)));function Ec({settings:r,
finished:e}){let t=r.schedule.kind==="alternating"?T.map(n=>[n]):[T];return Array.from({length:e},(n,s)=>(s?t:[T]).map(o=>[s,o])).flat()}function Cc({archive:r,
rows:e,counters:t},n,[s,o]){let a=e.filter(c=>c.generation===s&&o.includes(c.team)),i=Re(a.map(c=>`${[n,...Ya.map(h=>c[h])].join(",")}
`).join("")),l=c=>({dtype:"<f4",shape:[1,r[c][s].length],data:r[c][s]});return{...Object.fromEntries(o.map(c=>[`${c}s`,l(c)])),log:{dtype:`|S${Math.max(1,i.length)}`,
shape:[],data:i.length?i:new Uint8Array(1)},...Object.fromEntries(Object.entries(t[o.at(-1)][s]).map(([c,h])=>[c,Dn([h])])),...n?{score:Dn([R(a.slice(Math.floor(
a.length/2)).map(c=>c.capture_rate))])}:{}}}function kc(r){let e=r.finished,t=Array.from({length:e*e},(o,a)=>r.cells.get(`${Math.floor(a/e)} ${a%e}`)),n=t[0].lengths.
length,s=(o,...a)=>Dn(t.flatMap(o),e,e,...a);return{scores:{dtype:"<f4",shape:[e,e,n],data:Float32Array.from(t.flatMap(({capture_rates:o})=>o))},mean:s(({capture_rates:o})=>R(
o)),std:s(({capture_rates:o})=>Tc(o)),lengths:{dtype:"<i4",shape:[e,e,n],data:Int32Array.from(t.flatMap(({lengths:o})=>o))},collisions:s(({means:o})=>o.collisions,
2,3),faults:s(({means:o})=>o.faults,2,3),agent_steps:s(({means:o})=>o.agent_steps,2),pursuer_survivors:s(({means:o})=>o.survivors[0]),evader_survivors:s(({means:o})=>o.
survivors[1])}}function Rc(r,{format:e,version:t}){let n=r.finished-1,s={...r.settings,schedule:{...r.settings.schedule,generations:n}},o={format:e,matrixworld:t,
settings:s,drawn_by:"page"},a=Ec(r),{matches:i,steps:l,agent_steps:c}=r.counters.evader[n],h={training_matches:i,training_steps:l,training_agent_steps:c},u={stages:a.
length-1,...h,disengagement:[],evaluation_matches:r.finished**2*r.settings.evaluation_episodes};return{"config.json":Ka(o),...Object.fromEntries(a.map((m,p)=>[`\
stage-${String(p).padStart(4,"0")}.npz`,St(Cc(r,p,m))])),"payoff.npz":St(kc(r)),"summary.json":Ka(u)}}function qa(r,e){let t=r.flatMap(({name:n,race:s})=>Object.
entries(Rc(s,e)).map(([o,a])=>[r.length>1?`${n}/${o}`:o,a]));return Gt(Object.fromEntries(t))}var Za=r=>r.finished>1&&r.cells.size>=r.finished**2&&T.every(e=>r.
archive[e].length);var Oc=12;function Ja(r){let e=new Blob([Ae("script-engine"),`
`,Ae(`script-${r}`)],{type:"text/javascript"});return new Worker(URL.createObjectURL(e))}function Xa(){let r=h=>postMessage(h),e=It(),t=null,n=null,s=0,o=!1,a=new MessageChannel,
i=()=>{let h=performance.now()+Oc;for(;n&&performance.now()<h;){let{value:u,done:m}=n.next();m?(n=null,r({type:"end",seconds:(performance.now()-s)/1e3})):r(u)}!n||
o||(o=!0,a.port2.postMessage(null))},l=async h=>{if(h.type==="start")t=new Xe(await e,h.settings,h.masks),[n,s]=[t.run(),performance.now()],i();else if(h.type===
"stop")n=null;else if(h.type==="change"){let u=t?.change(h.settings);if(u&&r(u),!t||!u||n)return;n=t.catchUp(),i()}else if(t){let{settings:u,archive:m,rows:p,cells:g,
counters:f,finished:y}=t;r({type:"saved",race:{settings:u,archive:m,rows:p,cells:g,counters:f,finished:y}})}},c=h=>{Promise.resolve().then(h).catch(u=>{n=null,r(
{type:"failed",message:String(u)})})};a.port1.onmessage=()=>{o=!1,c(i)},globalThis.onmessage=({data:h})=>c(()=>l(h))}var _c=250,Wn=class{#e;#r;lanes=[];#t=d("div",{class:"lanes"});#s=d("button",{type:"button",class:"evolve",onclick:()=>this.#b()});#a=d("progress",{max:1,value:0,
"aria-label":"Progress of the race"});#n=d("p",{class:"small muted numbers",role:"status"});#l=d("button",{type:"button",class:"side",title:"A second race of th\
e same seed with another schedule",onclick:()=>this.#x()},"Side by side");#d=d("button",{type:"button","aria-pressed":"false",title:"Drag over the board to draw\
 walls, and over walls to remove them",onclick:()=>this.#S()},"Draw walls");#m=d("button",{type:"button",onclick:()=>this.#w({walls:[]})},"No walls");#i=d("butt\
on",{type:"button",onclick:()=>this.#E()});#h=d("span",{class:"small muted",role:"status"});#u=Ys((e,t)=>this.#w(e,t));#c=d("button",{type:"button",onclick:()=>{
this.#C()},title:"An archive that matrixworld judge, explore and replay read"},"Save");#p=[];#o;#y=0;constructor(e,t){[this.#e,this.#r,this.#o]=[e,t,Vs(e,location.
hash)];let n=d("div",{class:"doings",role:"group","aria-label":"What can be done"},this.#l,d("button",{type:"button",class:"to-play",title:"Play an evader again\
st the newest pursuers",onclick:()=>this.lanes[0].takeOver()},"Take over"),this.#d,this.#m,this.#i,this.#c,this.#h);document.getElementById("page").replaceWith(
vs("Evolve a chase","Triangles chase discs. Nobody has told either team how. Press Evolve, and both learn by trial and error, against each other."),d("main",{},
d("div",{class:"start"},this.#s,n,d("div",{class:"progress"},this.#a,this.#n)),this.#u.now,this.#t,this.#u.anew,d("div",{class:"card below"},Dt(),d("p",{class:"\
small muted"},"The page plays and learns with the engine of matrixworld, in this browser; nothing is sent."),d("p",{class:"small muted of-saving"},"A saved race\
 is an archive: ",d("code",{},"matrixworld judge"),", ",d("code",{},"explore")," and ",d("code",{},"replay")," read it. Python plays its matches again, and does\
 not continue it."))),d("footer",{class:"muted small"},`matrixworld ${e.version}`)),this.#g(),this.#M()}#f(){return[this.#o.schedule,...this.#o.beside?[this.#o.
beside]:[]]}#g(){for(let e of this.lanes.splice(0))e.close();for(let e of this.#f()){let t=new Ir(this.#e,this.#r,Ja("evolve"),Jt(this.#e,this.#o,e));t.addEventListener(
"state",()=>this.#T()),this.lanes.push(t)}this.#p=this.lanes.map(e=>e.newest.drawWalls(([t,n],s)=>this.#A(t,n,s))),this.#d.ariaPressed="false",this.#t.dataset.count=
String(this.lanes.length),this.#t.replaceChildren(...this.lanes.map(({element:e})=>e)),this.#u.show(this.#o),this.#T()}#b(){this.lanes.some(({state:e})=>e==="ev\
olving")?this.lanes.forEach(e=>e.stop()):this.#v()}#v(){this.#h.textContent="";for(let[e,t]of this.#f().entries()){let n=this.lanes[e];n.settings=Jt(this.#e,this.#o,
t),n.start()}}#x(){let e=this.#o.schedule==="specialist-specialist"?"generalist-generalist":"specialist-specialist";this.#w({beside:this.#o.beside?null:e},!0)}#w=(e,t=!1)=>{
let n=this.#f().length,s=this.lanes.every(({state:i})=>i==="waiting"),o={...this.#o,...e},a=Xt(o,Zt(this.#e));a||(this.#o=o),this.#u.show(this.#o),this.#h.textContent=
a,!a&&(Ft()&&history.replaceState(null,"",`#${js(this.#o)}`),this.#f().length!==n&&this.#g(),t&&!s?this.#v():this.#f().forEach((i,l)=>this.lanes[l].change(Jt(this.#e,
this.#o,i))))};#A(e,t,n){let{rows:s,cols:o}=this.lanes[0].settings.world,a={...this.#o,walls:Wt(this.#o.walls,e*o+t,n)},i=Xt(a,this.lanes[0].settings.world);if(i)
return i;let{walls:l}=this.#o=a,c=Uint8Array.from({length:s*o},(h,u)=>Number(l.includes(u)));for(let h of this.lanes)h.newest.show(c);return clearTimeout(this.#y),
this.#y=setTimeout(()=>this.#w({walls:l}),_c),""}#S(){let e=this.#d.ariaPressed!=="true";this.#d.ariaPressed=String(e);for(let t of this.#p)t(e)}#E(){let e=!this.
lanes[0].newest.runs;for(let{newest:t,beginning:n}of this.lanes)t.runs=n.runs=e;this.#M()}#M(){this.#i.textContent=this.lanes[0].newest.runs?"Pause boards":"Pla\
y boards"}#T(){if(!this.lanes.length)return;let e=this.lanes.map(({state:a})=>a),t=e.includes("evolving");document.body.dataset.state=e.every(a=>a==="waiting")?
"waiting":t?"evolving":"ended",this.#s.textContent=t?"Stop":e[0]==="waiting"?"Evolve":"Again",this.#l.ariaPressed=String(this.lanes.length>1),this.#m.hidden=!this.#o.
walls.length,this.#a.value=Math.min(...this.lanes.map(({done:a})=>a));let n=Math.max(...this.lanes.map(a=>a.seconds)),s=e.every(a=>a==="ended"),{seed:o}=this.#o;
this.#n.textContent=t?`Seed ${o}: generation ${this.lanes.map(a=>a.newestGeneration).join(" and ")}`:s?`Seed ${o}: the race took ${n.toFixed(1)} seconds.`:e.includes(
"stopped")?"Stopped.":""}async#C(){let e=await Promise.all(this.lanes.map(async n=>({name:_e(n.settings),race:await n.saved()})));if(!e.every(({race:n})=>Za(n))){
this.#h.textContent="Wait for the next generation, and save then.";return}let t=`${e.map(n=>n.name).join("-and-")}-seed-${this.#o.seed}.zip`;Ut(t,qa(e,this.#e)),
this.#h.textContent=`Saved as ${t}.`}};async function Pc(){let r=new Wn(Hs(),await It());document.addEventListener("keydown",({key:e,target:t,ctrlKey:n,metaKey:s,
altKey:o})=>{let a=t instanceof HTMLInputElement||t instanceof HTMLSelectElement||document.querySelector("dialog[open]");e.toLowerCase()==="d"&&!a&&!n&&!s&&!o&&
Zr()}),window.addEventListener("hashchange",()=>location.reload()),Object.assign(window,{matrixworldEvolve:r})}typeof document>"u"?Xa():ps(Pc());})();
