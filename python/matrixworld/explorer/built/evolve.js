/* built from web/ by "npm run build"; sources bd4a93ceb1aee10cff0299ec78a63fb00f6f429754408371650a49a997e8f2d0 */
"use strict";(()=>{var zr={SIMULTANEOUS:0,SWARM_TURNS:1,AGENT_TURNS:2},nt={DISAPPEAR:0,REACH:1,BOUNCE:2},Br={OCCUPATION:0,SURROUND:1},Gr={FAULT:0,INVOLVED:1};var Dn=["obstacle","teammate","adversary"],Wn=["vertex","edge","chain"],Hr=["turn","kind","form","first","second","row","col","at_fault","held","doomed"],zn=["p\
ursuer_{number}","evader_{number}"],jr={obstacle:"{first} ran into the obstacle or border at {cell}",vertex:"{first} and {second} both headed for {cell}",edge:"\
{first} and {second} meant to swap, {first} to {cell}",chain:"{first} headed for {cell}, where {second} had to stay"},rt={"both held":"both bounce","both doomed":"\
both disappear",held:"{agent} bounces",doomed:"{agent} disappears",none:"nobody is stopped"},Vr="{event}: {outcome}",Bn={random:"any action, all equally likely",
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
o 2, in half views)",teammate:"distance to the nearest teammate (0 to 2, in half views)",exits:"share of the cells around that are no obstacle (0 to 1)",room:"d\
istance to the nearest obstacle to the north, east, south or west (0 to 1, in half views)",must_yield:"1 if right of way forbids the move (0 to 1)",ahead:"1 if \
it is the direction that the agent draws for each 12 steps (0 to 1)"},Yr={free:".GS",blocked:"#@OTW"};var ze=1+Hr.length;function st(n,e){return n.replace(/\{(\w+)\}/g,(t,r)=>String(e[r]))}function K(n,e){return n<e?st(zn[0],{number:n}):st(zn[1],{number:n-e})}function Qa(n,e){
let[t,r,s,o,a,i,l,...c]=Array.from(n),h=a<0?[o]:[o,a],[u,m,p]=c.map(v=>h.filter((S,w)=>v>>w&1)),g=h.map(v=>K(v,e)),f=st(jr[a<0?"obstacle":Wn[s]],{first:g[0],second:g[g.
length-1],cell:`(${i}, ${l})`}),y=st(Vr,{event:f,outcome:ei(h.length,m,p,e)});return{kind:Dn[r],form:Wn[s],agents:h,cell:[i,l],at_fault:u,held:m,doomed:p,turn:t,
text:y}}function ei(n,e,t,r){if(n===2&&e.length===2)return rt["both held"];if(n===2&&t.length===2)return rt["both doomed"];let s=o=>a=>st(rt[o],{agent:K(a,r)});
return[...e.map(s("held")),...t.map(s("doomed"))].join(", ")||rt.none}function _t(n,e){let t=[];for(let r=0;r<n.length;r+=ze)t.push(Qa(n.subarray(r+1,r+ze),e));
return t}var ve=class extends Error{name="EngineError"};function L(n,e,t){let r=typeof t=="string"?`'${t}'`:typeof t=="object"?JSON.stringify(t):String(t);return new ve(
`${n}: expected ${e}, got ${r}`)}var Be=class{bytes;constructor(e){this.bytes=e}},Zr=0,Hn=[Uint8Array,Uint8Array,Int32Array,BigInt64Array,BigUint64Array,Float32Array,Float64Array],Kr=4,qr=4,ti=new TextEncoder,
ni=new TextDecoder;function ri(n){for(let e=Hn.length-1;e>Zr;--e)if(n instanceof Hn[e])return e;throw new TypeError("array: expected a typed array of the engine\
's numbers, got another")}function Gn(n){return new Uint8Array(n.buffer,n.byteOffset,n.byteLength)}function si(n){return ti.encode(`${n}\0`)}var jn=class{engine;addresses=[];constructor(e){
this.engine=e}copy(e){let t=this.engine._malloc(Math.max(e.length,1));if(t===0)throw new ve("memory: expected room for the arguments, got none");return this.addresses.
push(t),this.engine.HEAPU8.set(e,t),t}text(e){return this.copy(si(e))}arrays(e){let t=Object.entries(e),r=t.flatMap(([o,a])=>{let i=a instanceof Be,l=i?a.bytes:
a;return[this.text(o),i?Zr:ri(l),l.length,this.copy(Gn(l))]}),s=this.copy(Gn(Int32Array.from(r)));return this.copy(Gn(Int32Array.of(t.length,s)))}free(){for(let e of this.
addresses)this.engine._free(e)}};function Jr(n,e){let t=n.HEAPU8;return ni.decode(t.subarray(e,t.indexOf(0,e)))}function Ge(n){let e=new Int32Array(n.HEAPU8.buffer),
t=n._last_outputs()/Kr,r=e[t+1]/Kr,s={};for(let o=r;o<r+e[t]*qr;o+=qr){let a=Hn[e[o+1]],i=e[o+2]*a.BYTES_PER_ELEMENT,l=e[o+3];s[Jr(n,e[o])]=new a(n.HEAPU8.slice(
l,l+i).buffer)}return s}function be(n,e){let t=new jn(n);try{let r=e(t);if(r===0)throw new ve(Jr(n,n._last_error()));return r}finally{t.free()}}var oi=2**31-1,Xr=["none","gru"],ai=2n**64n-1n,ii=34028234663852886e22;function ae(n,e){if(typeof e!="number"||!Number.isInteger(e)||Math.abs(e)>oi)throw L(n,"a\
n integer",e);return Int32Array.of(e)}function Pt(n,e){if(typeof e!="boolean")throw L(n,"true or false",e);return new Be(Uint8Array.of(Number(e)))}function Ce(n,e,t){
let r=typeof e=="string"&&Object.hasOwn(t,e)?t[e]:void 0;if(r===void 0)throw L(n,`one of ${Object.keys(t).join(", ")}`,e);return Int32Array.of(r)}function Vn(n,e){
if(typeof e!="number"||!(Math.abs(e)<=ii))throw L(n,"a finite number",e);return e}function ot(n,e){let r=typeof e=="bigint"||typeof e=="number"&&Number.isSafeInteger(
e)?BigInt(e):-1n;if(r<0n||r>ai)throw L(n,"an integer from 0 to 2^64 - 1",e);return BigUint64Array.of(r)}function li(n){return{"rules.interaction":Ce("interactio\
n",n.interaction,zr),"rules.obstacle":Ce("obstacle",n.obstacle,nt),"rules.teammate":Ce("teammate",n.teammate,nt),"rules.evader":Ce("evader",n.evader,nt),"rules.\
pursuer":Ce("pursuer",n.pursuer,nt),"rules.capture":Ce("capture",n.capture,Br),"rules.captured_disappear":Pt("captured_disappear",n.captured_disappear)}}function Qr(n,e){
let t=typeof e=="number"?[e,e,e]:e;if(!Array.isArray(t)||t.length!==3)throw L(n,"1 or 3 numbers",e);return Float32Array.from(t,r=>Vn(n,r))}function ci(n){let e=(t,r)=>Float32Array.
of(Vn(t,n[t]),Vn(r,n[r]));return{"rewards.capture":e("pursuer_capture","evader_capture"),"rewards.neighbor":e("pursuer_neighbor","evader_neighbor"),"rewards.ste\
p":e("pursuer_step","evader_step"),"rewards.pursuer_collide":Qr("pursuer_collide",n.pursuer_collide),"rewards.evader_collide":Qr("evader_collide",n.evader_collide),
"rewards.blame":Ce("blame",n.blame,Gr),"rewards.capture_repeats":Pt("capture_repeats",n.capture_repeats)}}function ns(n){if(n===void 0||typeof n=="number")return new Uint8Array(
0);if(n instanceof Uint8Array)return n;let{free:e,blocked:t}=Yr;for(let[r,s]of n.entries()){if(s.length!==n[0]?.length)throw L(`map, row ${r}`,`${n[0]?.length} \
cells as in row 0`,s.length);let o=[...s].find(a=>!e.includes(a)&&!t.includes(a));if(o)throw L(`map, row ${r}`,`'${e}' (free) or '${t}' (obstacle)`,o)}return Uint8Array.
from([...n.join("")],r=>Number(t.includes(r)))}function rs(n,e){if(!Array.isArray(n))return;let t=[n.length,n[0]?.length??0];if(!(t[0]===e.rows&&t[1]===e.cols))
throw L("obstacle map",`shape (${e.rows}, ${e.cols}), the rows and cols`,t)}function He(n){rs(n.obstacles,n);let e=typeof n.obstacles=="number"?n.obstacles:0;return{
...li(n.rules),...ci(n.rewards),rows:ae("rows",n.rows),cols:ae("cols",n.cols),n_pursuers:ae("n_pursuers",n.n_pursuers),n_evaders:ae("n_evaders",n.n_evaders),fov:ae(
"fov",n.fov),diagonal:Pt("diagonal",n.diagonal),max_steps:ae("max_steps",n.max_steps),density:Float64Array.of(e),map:ns(n.obstacles)}}function es(n,e){return Int32Array.
from((e??[]).flat(),t=>ae(n,t)[0])}function ss(n,e){return rs(n.obstacles,e),{seed:ot("seed",n.seed??0n),episode:ot("episode",n.episode??0),pursuers:es("pursuer\
s",n.pursuers),evaders:es("evaders",n.evaders),map:ns(n.obstacles)}}function $t(n){return{actions:Int32Array.from(n,e=>ae("actions",e)[0])}}var ts=Object.keys(Ee);
function Yn(n){let e=ts.indexOf(n);if(e<0)throw L("inputs",`names of ${ts.join(", ")}`,n);return e}function ke(n){if(typeof n=="string"){if(!Object.hasOwn(Bn,n))
throw L("policy",`one of ${Object.keys(Bn).join(", ")}`,n);return{script:new TextEncoder().encode(n)}}if(n.kind!=="cells")return{inputs:Int32Array.from(n.inputs,
e=>Yn(e)),hidden:Int32Array.from(n.kind==="rating"?n.hidden:[],e=>ae("hidden",e)[0]),length:ae("length",n.kind==="program"?n.length:0),mask:new TextEncoder().encode(
n.mask),genome:n.genome};if(n.activation!=="relu"&&n.activation!=="tanh")throw L("activation","'relu' or 'tanh'",n.activation);if(!Xr.includes(n.memory))throw L(
"memory",`one of ${Xr.join(", ")}`,n.memory);return{hidden:Int32Array.from(n.hidden,e=>ae("hidden",e)[0]),activation:new TextEncoder().encode(n.activation),sampled:Pt(
"sampled",n.sampled),memory:new TextEncoder().encode(n.memory),genome:n.genome}}var ui=["first_turn","terminated","truncated"];function os(n){let e={...n};for(let t of ui)
e[t]=new Be(n[t]);return e}var as="statistics.",Nt=class{config;seed;episode;n_agents;statistics;first_conflict;constructor(e,t,r,s){this.config=e,this.seed=t,this.episode=r,this.n_agents=
e.n_pursuers+e.n_evaders,this.statistics=di(is(s)),Object.assign(this,s),this.first_conflict=hi(this.conflict_table,this.length)}get length(){return this.actions.
length/this.n_agents}conflicts(e){this.check(e);let[t,r]=[this.first_conflict[e],this.first_conflict[e+1]],s=this.conflict_table.subarray(t*ze,r*ze);return _t(s,
this.config.n_pursuers)}seek(e,t,r){this.check(t),(!(e.seed===this.seed&&e.episode===BigInt(this.episode))||e.turn!==0||e.steps>t)&&e.reset({seed:this.seed,episode:this.
episode});for(let o=e.steps;o<t;++o){let a=this.actions.subarray(o*this.n_agents,(o+1)*this.n_agents);r?e.replay(a,{pursuer:r.pursuers,evader:r.evaders}):e.step(
a)}}check(e){if(!(Number.isInteger(e)&&e>=0&&e<=this.length))throw L("step",`0 to ${this.length}`,e)}};function hi(n,e){let t=new Int32Array(e+2);for(let r=0;r<
n.length;r+=ze)++t[n[r]+1];for(let r=1;r<t.length;++r)t[r]+=t[r-1];return t}function di(n){let e=["capture_rate","ever_capture_rate","captured_fraction","length"];
return Object.fromEntries(Object.entries(n).map(([t,r])=>[t,e.includes(t)?Number(r[0]):r]))}var is=n=>Object.fromEntries(Object.entries(n).flatMap(([e,t])=>e.startsWith(
as)?[[e.slice(as.length),t]]:[]));function ls(n,e,t,r){let s=[He(t.config),ke(t.pursuers),ke(t.evaders),r];return be(n,o=>{let[a,i,l,c]=s.map(h=>o.arrays(h));return n[e](
a,i,l,c)}),Ge(n)}function cs(n,e,t,r){let s={seed:ot("seed",t),episode:ot("episode",r)};return new Nt(e.config,t,r,ls(n,"_play_match",e,s))}function us(n,e,t,r){
if(!Number.isInteger(r)||r<1)throw L("n_episodes","at least 1",r);let s=ls(n,"_play_rollout",e,{...t,n_episodes:Int32Array.of(r)});return is(s)}var mi=7e6,pi=new FinalizationRegistry(([n,e])=>n._states_free(e));function fi({rules:n,rows:e,cols:t,obstacles:r,diagonal:s,n_pursuers:o,n_evaders:a}){let i=typeof r==
"number"||n.obstacle==="REACH"?0:r.join("").split("#").length-1,l=e*t-i,c=[n.obstacle,n.teammate,n.pursuer].includes("DISAPPEAR"),h=n.capture==="SURROUND"||n.evader===
"REACH",u=n.interaction==="AGENT_TURNS",m=(f,y)=>Array.from({length:y},(v,S)=>u?f:(f+S)/(S+1)).reduce((v,S)=>v*S,1),p=m(l+Number(c),o)*m(l*(1+Number(h))+2,a);return{
SIMULTANEOUS:[o+a],SWARM_TURNS:[o,a],AGENT_TURNS:Array(o+a).fill(1)}[n.interaction].reduce((f,y)=>f+p*(s?9:5)**y,0)}function Lt(n){return typeof n.obstacles=="n\
umber"&&n.obstacles>0?"obstacles are drawn anew in each episode":fi(n)>mi?"the world is too large to be solved on the page":""}var Kn=class{value;teams;matrix;n_actions;constructor(e,t){
let{matrix:r,rows:s,cols:o,value:a,agents:i}=t,[l,c]=e.actors,h=Array.from(i).filter(m=>l<=m&&m<c),u=m=>m<e.config.n_pursuers;[this.value,this.matrix,this.n_actions]=
[a[0],r,e.n_actions],this.teams=[{agents:h.filter(u),play:s},{agents:h.filter(m=>!u(m)),play:o}]}marginal(e){let t=this.teams.find(({agents:o})=>o.includes(e));
if(!t)return null;let r=this.n_actions**(t.agents.length-1-t.agents.indexOf(e)),s=Array(this.n_actions).fill(0);return t.play.forEach((o,a)=>s[Math.floor(a/r)%this.
n_actions]+=o),s}lost(e){let[t,r]=this.teams.map(({agents:l})=>l.reduce((c,h)=>c*this.n_actions+e[h],0)),[s,o]=this.teams.map(({play:l})=>l),a=o.reduce((l,c,h)=>l+
c*this.matrix[t*o.length+h],0),i=s.reduce((l,c,h)=>l+c*this.matrix[h*o.length+r],0);return[Math.max(0,this.value-a),Math.max(0,i-this.value)]}},qn=60,at=class{config;payoff;engine;states;n_turns;values;constructor(e,t,r){
[this.engine,this.config,this.payoff]=[e,t,r],this.states=be(e,i=>e._states_new(i.arrays(He(t)))),pi.register(this,[e,this.states]);let s={SIMULTANEOUS:1,SWARM_TURNS:2,
AGENT_TURNS:t.n_pursuers+t.n_evaders};this.n_turns=s[t.rules.interaction];let{payoffs:o}=this.call(()=>e._states_payoffs(this.states)),a=o;this.values=[[r==="ca\
pture-rate"?a:a.fill(0)]]}goBack(){let e=this.values.at(-1)[0],t=[];for(let s=this.n_turns-1;s>=0;s--){let o=t[s+1]??e;t[s]=this.backup(s,{next:o})}this.payoff===
"capture-time"&&(t[0]=t[0].map((s,o)=>o===this.config.n_evaders?0:s-1)),this.values.push(t);let r=this.payoff==="capture-rate"?this.config.max_steps:Math.min(this.
config.max_steps,qn);return this.values.length<=r&&t[0].some((s,o)=>s!==e[o])}backup(e,t){return this.call(r=>this.engine._states_backup(this.states,e,r.arrays(
t))).values}game(e){let[t,{turn:r}]=[this.config.max_steps-e.steps,e],s=r+1===this.n_turns,o=t>0?this.values[Math.min(t-Number(s),this.values.length-1)]?.[s?0:r+
1]:void 0;if(!o)return null;let a=this.call(i=>this.engine._states_game(this.states,e.address,i.arrays({next:o})));return a.agents.length?new Kn(e,a):null}call(e){
return be(this.engine,e),Ge(this.engine)}};var hs=new FinalizationRegistry(([n,e])=>n._world_free(e)),it=class{config;n_agents;n_actions;engine;at;freed=!1;constructor(e,t){this.engine=e,this.config=t,this.
n_agents=t.n_pursuers+t.n_evaders,this.n_actions=t.diagonal?9:5,this.at=be(e,r=>e._world_new(r.arrays(He(t)))),hs.register(this,[e,this.at],this)}free(){this.freed||
(this.freed=!0,hs.unregister(this),this.engine._world_free(this.at))}get address(){if(this.freed)throw L("world","one that is in use","one that was freed");return this.
at}reset(e={}){let t=ss(e,this.config);this.call(r=>this.engine._world_reset(this.address,r.arrays(t)))}step(e){let t=$t(e);this.call(r=>this.engine._world_step(
this.address,r.arrays(t)))}playTurn(e){let t=$t(e);this.call(r=>this.engine._world_play_turn(this.address,r.arrays(t)))}decide(e,t,r){let{n_pursuers:s}=this.config,
o={pursuer:[0,s],evader:[s,this.n_agents]},[a,i]=typeof t=="string"?o[t]:t;if(r.length!==this.n_agents)throw L("actions",String(this.n_agents),r.length);let l=[
ke(e),$t(r)],{actions:c}=this.call(h=>this.engine._world_decide(this.address,h.arrays(l[0]),a,i,h.arrays(l[1])));return Uint8Array.from(c)}replay(e,t){let r=o=>typeof o!=
"string"&&o.kind==="cells"&&o.memory!=="none";if(!r(t.pursuer)&&!r(t.evader))return this.step(e);let{n_pursuers:s}=this.config;for(let o=this.n_turns;o>0;--o){let[
a,i]=this.actors;a<s&&this.decide(t.pursuer,[a,Math.min(i,s)],e),i>s&&this.decide(t.evader,[Math.max(a,s),i],e),this.playTurn(e)}}get n_turns(){return this.turnNumbers()[1]}get turn(){
return this.turnNumbers()[0]}get actors(){let[,,e,t]=this.turnNumbers();return[e,t]}turnNumbers(){return this.call(()=>this.engine._world_turn(this.address)).turn}get steps(){
return this.read("steps")[0]}get seed(){return this.read("seed")[0]}get episode(){return this.read("episode")[0]}get over(){return this.read("terminated")[0]===
1||this.read("truncated")[0]===1}read(e){return this.call(t=>this.engine._world_read(this.address,t.text(e)))[e]}view(e){let t=3*this.config.fov**2;return this.
read("views").slice(e*t,(e+1)*t)}map(){return this.read("state").slice(2*this.config.rows*this.config.cols)}conflicts(){return _t(this.conflictTable(),this.config.
n_pursuers)}conflictTable(){return this.call(()=>this.engine._world_conflicts(this.address)).conflict_table}answer(e,t){let r=ke(e),{logits:s,memory:o}=this.call(
l=>this.engine._world_logits(this.address,l.arrays(r),t)),a=s,i=this.decide(e,[t,t+1],new Uint8Array(this.n_agents))[t];return{logits:a,probabilities:yi(a),action:i,
memory:o}}rate(e,t){let r=ke(e),{ratings:s,refused:o}=this.call(c=>this.engine._world_rate(this.address,c.arrays(r),t)),a=this.read("inputs"),i=a.length/this.n_agents/
this.n_actions,l=c=>Float32Array.from({length:this.n_actions},(h,u)=>a[(t*this.n_actions+u)*i+c]);return{inputs:e.inputs.map(c=>l(Yn(c))),ratings:s,refused:o}}snapshot(){
return this.call(()=>this.engine._world_snapshot(this.address))}restore(e){let t=os(e);this.call(r=>this.engine._world_restore(this.address,r.arrays(t)))}call(e){
return be(this.engine,e),Ge(this.engine)}};function yi(n){let e=Math.max(...n),t=Array.from(n,s=>Math.exp(s-e)),r=t.reduce((s,o)=>s+o,0);return Float32Array.from(
t,s=>s/r)}var Zn=class{compiled;constructor(e){this.compiled=e}world(e){return new it(this.compiled,e)}solution(e,t="capture-rate"){return new at(this.compiled,e,t)}match(e,t,r,s,o=0){
return cs(this.compiled,{config:e,pursuers:t,evaders:r},s,o)}rollouts(e,t,r,s,o){return us(this.compiled,{config:e,pursuers:t,evaders:r},s,o)}},ds;function It(n=globalThis.
matrixworldEngine){return ds??=gi(n),ds}async function gi(n){if(!n)throw new Error("matrixworldEngine: expected the script engine.js before this one, got none");
let e=Uint8Array.from(atob(n.binary),t=>t.charCodeAt(0));return new Zn(await n({wasmBinary:e}))}var vi="http://www.w3.org/2000/svg";function d(n,e={},...t){return ms(document.createElement(n),e,t)}function b(n,e={},...t){return ms(document.createElementNS(
vi,n),e,t)}function ms(n,e,t){for(let[s,o]of Object.entries(e))o==null||o===!1||(typeof o=="function"?n.addEventListener(s.slice(2),o):n.setAttribute(s,o===!0?"":
String(o)));let r=t.filter(s=>s!=null&&s!==!1);return n.append(...r.map(s=>typeof s=="number"?String(s):s)),n}function re(n,e){let t=d("select",{onchange:()=>e(
t.value)},...n.map(([r,s])=>d("option",{value:r},s)));return t}async function ps(n){try{await n}catch(e){throw(document.querySelector("#page, main")??document.body).
prepend(d("p",{class:"card problem",role:"alert"},`The page could not start: ${String(e)}`)),e}finally{document.body.dataset.ready="true"}}var Ft=()=>["file:","\
http:","https:"].includes(location.protocol);var fs=n=>d("input",{type:"text",readonly:!0,"aria-label":n});function Ut(n,e){let t=URL.createObjectURL(new Blob([e],{type:"application/octet-stream"}));d("a",
{href:t,download:n}).click(),setTimeout(()=>URL.revokeObjectURL(t),6e4)}var ys=()=>document.documentElement.dataset.theme==="dark",lt=n=>{document.documentElement.dataset.theme=n?"dark":"light"},Jn=()=>lt(!ys());if(typeof document<"\
u"){let n=matchMedia("(prefers-color-scheme: dark)");n.addEventListener("change",()=>lt(n.matches)),lt(n.matches);let e=!1;addEventListener("beforeprint",()=>{e=
ys(),lt(!1)}),addEventListener("afterprint",()=>lt(e))}function gs(){return d("button",{type:"button",title:"Light or dark (D)","aria-label":"Light or dark",onclick:Jn},
"◐")}var vs=(n,e,...t)=>d("header",{class:"top"},d("div",{},d("h1",{},n),e?d("p",{class:"lead"},e):null),d("div",{class:"tools"},...t,gs()));var bi=Array.from({length:16},(n,e)=>{let[t,r]=[e%2?6.5:11,Math.PI*e/8];return`${12+t*Math.sin(r)} ${12-t*Math.cos(r)}`}).join(" ");function Dt(){let n=[["pursu\
er",b("path",{d:"M12 3 22 20H2z",class:"filled-pursuer"})],["evader",b("circle",{cx:12,cy:12,r:9,class:"filled-evader"})],["capture",b("polygon",{points:bi,class:"\
filled-capture"})],["captured evader",b("circle",{cx:12,cy:12,r:7.5,class:"ring-evader"})],["conflict",b("rect",{x:3,y:3,width:18,height:18,class:"dashed-confli\
ct"})]];return d("ul",{class:"shapes small","aria-label":"Shapes on the board"},...n.map(([e,t])=>d("li",{},b("svg",{viewBox:"0 0 24 24","aria-hidden":"true"},t),
e)))}var Q=["stay","north","east","south","west","northeast","southeast","southwest","northwest"];var bs="champion",ws=0,Xn=64,Qn=100;var wi=(n,e)=>Object.keys(n).every(t=>n[t]===e[t]);function xs(n,e){return Object.keys(e).find(t=>wi(e[t],n))??null}function Ss(n,e,t){let r=new Set(n);return Array.
from({length:e},(s,o)=>Array.from({length:t},(a,i)=>r.has(o*t+i)?"#":".").join(""))}function Wt(n,e,t){let r=n.filter(s=>s!==e);return t?[...r,e].sort((s,o)=>s-
o):r}var $=Uint8Array,ee=Uint16Array,lr=Int32Array,zt=new $([0,0,0,0,0,0,0,0,1,1,1,1,2,2,2,2,3,3,3,3,4,4,4,4,5,5,5,5,0,0,0,0]),Bt=new $([0,0,0,0,1,1,2,2,3,3,4,4,5,5,
6,6,7,7,8,8,9,9,10,10,11,11,12,12,13,13,0,0]),rr=new $([16,17,18,0,8,7,9,6,10,5,11,4,12,3,13,2,14,1,15]),ks=function(n,e){for(var t=new ee(31),r=0;r<31;++r)t[r]=
e+=1<<n[r-1];for(var s=new lr(t[30]),r=1;r<30;++r)for(var o=t[r];o<t[r+1];++o)s[o]=o-t[r]<<5|r;return{b:t,r:s}},Rs=ks(zt,2),Os=Rs.b,sr=Rs.r;Os[28]=258,sr[258]=28;
var _s=ks(Bt,0),xi=_s.b,As=_s.r,or=new ee(32768);for(E=0;E<32768;++E)pe=(E&43690)>>1|(E&21845)<<1,pe=(pe&52428)>>2|(pe&13107)<<2,pe=(pe&61680)>>4|(pe&3855)<<4,or[E]=
((pe&65280)>>8|(pe&255)<<8)>>1;var pe,E,ue=(function(n,e,t){for(var r=n.length,s=0,o=new ee(e);s<r;++s)n[s]&&++o[n[s]-1];var a=new ee(e);for(s=1;s<e;++s)a[s]=a[s-
1]+o[s-1]<<1;var i;if(t){i=new ee(1<<e);var l=15-e;for(s=0;s<r;++s)if(n[s])for(var c=s<<4|n[s],h=e-n[s],u=a[n[s]-1]++<<h,m=u|(1<<h)-1;u<=m;++u)i[or[u]>>l]=c}else
for(i=new ee(r),s=0;s<r;++s)n[s]&&(i[s]=or[a[n[s]-1]++]>>15-n[s]);return i}),we=new $(288);for(E=0;E<144;++E)we[E]=8;var E;for(E=144;E<256;++E)we[E]=9;var E;for(E=
256;E<280;++E)we[E]=7;var E;for(E=280;E<288;++E)we[E]=8;var E,ht=new $(32);for(E=0;E<32;++E)ht[E]=5;var E,Si=ue(we,9,0),Ai=ue(we,9,1),Mi=ue(ht,5,0),Ti=ue(ht,5,1),
er=function(n){for(var e=n[0],t=1;t<n.length;++t)n[t]>e&&(e=n[t]);return e},ie=function(n,e,t){var r=e/8|0;return(n[r]|n[r+1]<<8)>>(e&7)&t},tr=function(n,e){var t=e/
8|0;return(n[t]|n[t+1]<<8|n[t+2]<<16)>>(e&7)},cr=function(n){return(n+7)/8|0},ur=function(n,e,t){return(e==null||e<0)&&(e=0),(t==null||t>n.length)&&(t=n.length),
new $(n.subarray(e,t))};var Ei=["unexpected EOF","invalid block type","invalid length/literal","invalid distance","stream finished","no stream handler",,"no callback","invalid UTF-8 da\
ta","extra field too long","date not in range 1980-2099","filename too long","stream finishing","invalid zip data"],q=function(n,e,t){var r=new Error(e||Ei[n]);
if(r.code=n,Error.captureStackTrace&&Error.captureStackTrace(r,q),!t)throw r;return r},Ci=function(n,e,t,r){var s=n.length,o=r?r.length:0;if(!s||e.f&&!e.l)return t||
new $(0);var a=!t,i=a||e.i!=2,l=e.i;a&&(t=new $(s*3));var c=function(et){var tt=t.length;if(et>tt){var We=new $(Math.max(tt*2,et));We.set(t),t=We}},h=e.f||0,u=e.
p||0,m=e.b||0,p=e.l,g=e.d,f=e.m,y=e.n,v=s*8;do{if(!p){h=ie(n,u,1);var S=ie(n,u+1,3);if(u+=3,S)if(S==1)p=Ai,g=Ti,f=9,y=5;else if(S==2){var I=ie(n,u,31)+257,N=ie(
n,u+10,15)+4,M=I+ie(n,u+5,31)+1;u+=14;for(var x=new $(M),U=new $(19),F=0;F<N;++F)U[rr[F]]=ie(n,u+F*3,7);u+=N*3;for(var B=er(U),ge=(1<<B)-1,Z=ue(U,B,1),F=0;F<M;){
var V=Z[ie(n,u,ge)];u+=V&15;var w=V>>4;if(w<16)x[F++]=w;else{var D=0,_=0;for(w==16?(_=3+ie(n,u,3),u+=2,D=x[F-1]):w==17?(_=3+ie(n,u,7),u+=3):w==18&&(_=11+ie(n,u,
127),u+=7);_--;)x[F++]=D}}var Y=x.subarray(0,I),W=x.subarray(I);f=er(Y),y=er(W),p=ue(Y,f,1),g=ue(W,y,1)}else q(1);else{var w=cr(u)+4,A=n[w-4]|n[w-3]<<8,O=w+A;if(O>
s){l&&q(0);break}i&&c(m+A),t.set(n.subarray(w,O),m),e.b=m+=A,e.p=u=O*8,e.f=h;continue}if(u>v){l&&q(0);break}}i&&c(m+131072);for(var Qe=(1<<f)-1,ne=(1<<y)-1,me=u;;me=
u){var D=p[tr(n,u)&Qe],J=D>>4;if(u+=D&15,u>v){l&&q(0);break}if(D||q(2),J<256)t[m++]=J;else if(J==256){me=u,p=null;break}else{var X=J-254;if(J>264){var F=J-257,P=zt[F];
X=ie(n,u,(1<<P)-1)+Os[F],u+=P}var ce=g[tr(n,u)&ne],Ue=ce>>4;ce||q(3),u+=ce&15;var W=xi[Ue];if(Ue>3){var P=Bt[Ue];W+=tr(n,u)&(1<<P)-1,u+=P}if(u>v){l&&q(0);break}
i&&c(m+131072);var De=m+X;if(m<W){var Rt=o-W,Ot=Math.min(W,De);for(Rt+m<0&&q(3);m<Ot;++m)t[m]=r[Rt+m]}for(;m<De;++m)t[m]=t[m-W]}}e.l=p,e.p=me,e.b=m,e.f=h,p&&(h=
1,e.m=f,e.d=g,e.n=y)}while(!h);return m!=t.length&&a?ur(t,0,m):t.subarray(0,m)},fe=function(n,e,t){t<<=e&7;var r=e/8|0;n[r]|=t,n[r+1]|=t>>8},ct=function(n,e,t){
t<<=e&7;var r=e/8|0;n[r]|=t,n[r+1]|=t>>8,n[r+2]|=t>>16},nr=function(n,e){for(var t=[],r=0;r<n.length;++r)n[r]&&t.push({s:r,f:n[r]});var s=t.length,o=t.slice();if(!s)
return{t:$s,l:0};if(s==1){var a=new $(t[0].s+1);return a[t[0].s]=1,{t:a,l:1}}t.sort(function(O,I){return O.f-I.f}),t.push({s:-1,f:25001});var i=t[0],l=t[1],c=0,
h=1,u=2;for(t[0]={s:-1,f:i.f+l.f,l:i,r:l};h!=s-1;)i=t[t[c].f<t[u].f?c++:u++],l=t[c!=h&&t[c].f<t[u].f?c++:u++],t[h++]={s:-1,f:i.f+l.f,l:i,r:l};for(var m=o[0].s,r=1;r<
s;++r)o[r].s>m&&(m=o[r].s);var p=new ee(m+1),g=ar(t[h-1],p,0);if(g>e){var r=0,f=0,y=g-e,v=1<<y;for(o.sort(function(I,N){return p[N.s]-p[I.s]||I.f-N.f});r<s;++r){
var S=o[r].s;if(p[S]>e)f+=v-(1<<g-p[S]),p[S]=e;else break}for(f>>=y;f>0;){var w=o[r].s;p[w]<e?f-=1<<e-p[w]++-1:++r}for(;r>=0&&f;--r){var A=o[r].s;p[A]==e&&(--p[A],
++f)}g=e}return{t:new $(p),l:g}},ar=function(n,e,t){return n.s==-1?Math.max(ar(n.l,e,t+1),ar(n.r,e,t+1)):e[n.s]=t},Ms=function(n){for(var e=n.length;e&&!n[--e];)
;for(var t=new ee(++e),r=0,s=n[0],o=1,a=function(l){t[r++]=l},i=1;i<=e;++i)if(n[i]==s&&i!=e)++o;else{if(!s&&o>2){for(;o>138;o-=138)a(32754);o>2&&(a(o>10?o-11<<5|
28690:o-3<<5|12305),o=0)}else if(o>3){for(a(s),--o;o>6;o-=6)a(8304);o>2&&(a(o-3<<5|8208),o=0)}for(;o--;)a(s);o=1,s=n[i]}return{c:t.subarray(0,r),n:e}},ut=function(n,e){
for(var t=0,r=0;r<e.length;++r)t+=n[r]*e[r];return t},Ps=function(n,e,t){var r=t.length,s=cr(e+2);n[s]=r&255,n[s+1]=r>>8,n[s+2]=n[s]^255,n[s+3]=n[s+1]^255;for(var o=0;o<
r;++o)n[s+o+4]=t[o];return(s+4+r)*8},Ts=function(n,e,t,r,s,o,a,i,l,c,h){fe(e,h++,t),++s[256];for(var u=nr(s,15),m=u.t,p=u.l,g=nr(o,15),f=g.t,y=g.l,v=Ms(m),S=v.c,
w=v.n,A=Ms(f),O=A.c,I=A.n,N=new ee(19),M=0;M<S.length;++M)++N[S[M]&31];for(var M=0;M<O.length;++M)++N[O[M]&31];for(var x=nr(N,7),U=x.t,F=x.l,B=19;B>4&&!U[rr[B-1]];--B)
;var ge=c+5<<3,Z=ut(s,we)+ut(o,ht)+a,V=ut(s,m)+ut(o,f)+a+14+3*B+ut(N,U)+2*N[16]+3*N[17]+7*N[18];if(l>=0&&ge<=Z&&ge<=V)return Ps(e,h,n.subarray(l,l+c));var D,_,Y,
W;if(fe(e,h,1+(V<Z)),h+=2,V<Z){D=ue(m,p,0),_=m,Y=ue(f,y,0),W=f;var Qe=ue(U,F,0);fe(e,h,w-257),fe(e,h+5,I-1),fe(e,h+10,B-4),h+=14;for(var M=0;M<B;++M)fe(e,h+3*M,
U[rr[M]]);h+=3*B;for(var ne=[S,O],me=0;me<2;++me)for(var J=ne[me],M=0;M<J.length;++M){var X=J[M]&31;fe(e,h,Qe[X]),h+=U[X],X>15&&(fe(e,h,J[M]>>5&127),h+=J[M]>>12)}}else
D=Si,_=we,Y=Mi,W=ht;for(var M=0;M<i;++M){var P=r[M];if(P>255){var X=P>>18&31;ct(e,h,D[X+257]),h+=_[X+257],X>7&&(fe(e,h,P>>23&31),h+=zt[X]);var ce=P&31;ct(e,h,Y[ce]),
h+=W[ce],ce>3&&(ct(e,h,P>>5&8191),h+=Bt[ce])}else ct(e,h,D[P]),h+=_[P]}return ct(e,h,D[256]),h+_[256]},ki=new lr([65540,131080,131088,131104,262176,1048704,1048832,
2114560,2117632]),$s=new $(0),Ri=function(n,e,t,r,s,o){var a=o.z||n.length,i=new $(r+a+5*(1+Math.ceil(a/7e3))+s),l=i.subarray(r,i.length-s),c=o.l,h=(o.r||0)&7;if(e){
h&&(l[0]=o.r>>3);for(var u=ki[e-1],m=u>>13,p=u&8191,g=(1<<t)-1,f=o.p||new ee(32768),y=o.h||new ee(g+1),v=Math.ceil(t/3),S=2*v,w=function(Un){return(n[Un]^n[Un+1]<<
v^n[Un+2]<<S)&g},A=new lr(25e3),O=new ee(288),I=new ee(32),N=0,M=0,x=o.i||0,U=0,F=o.w||0,B=0;x+2<a;++x){var ge=w(x),Z=x&32767,V=y[ge];if(f[Z]=V,y[ge]=Z,F<=x){var D=a-
x;if((N>7e3||U>24576)&&(D>423||!c)){h=Ts(n,l,0,A,O,I,M,U,B,x-B,h),U=N=M=0,B=x;for(var _=0;_<286;++_)O[_]=0;for(var _=0;_<30;++_)I[_]=0}var Y=2,W=0,Qe=p,ne=Z-V&32767;
if(D>2&&ge==w(x-ne))for(var me=Math.min(m,D)-1,J=Math.min(32767,x),X=Math.min(258,D);ne<=J&&--Qe&&Z!=V;){if(n[x+Y]==n[x+Y-ne]){for(var P=0;P<X&&n[x+P]==n[x+P-ne];++P)
;if(P>Y){if(Y=P,W=ne,P>me)break;for(var ce=Math.min(ne,P-2),Ue=0,_=0;_<ce;++_){var De=x-ne+_&32767,Rt=f[De],Ot=De-Rt&32767;Ot>Ue&&(Ue=Ot,V=De)}}}Z=V,V=f[Z],ne+=
Z-V&32767}if(W){A[U++]=268435456|sr[Y]<<18|As[W];var et=sr[Y]&31,tt=As[W]&31;M+=zt[et]+Bt[tt],++O[257+et],++I[tt],F=x+Y,++N}else A[U++]=n[x],++O[n[x]]}}for(x=Math.
max(x,F);x<a;++x)A[U++]=n[x],++O[n[x]];h=Ts(n,l,c,A,O,I,M,U,B,x-B,h),c||(o.r=h&7|l[h/8|0]<<3,h-=7,o.h=y,o.p=f,o.i=x,o.w=F)}else{for(var x=o.w||0;x<a+c;x+=65535){
var We=x+65535;We>=a&&(l[h/8|0]=c,We=a),h=Ps(l,h+1,n.subarray(x,We))}o.i=a}return ur(i,0,r+cr(h)+s)},Oi=(function(){for(var n=new Int32Array(256),e=0;e<256;++e){
for(var t=e,r=9;--r;)t=(t&1&&-306674912)^t>>>1;n[e]=t}return n})(),_i=function(){var n=-1;return{p:function(e){for(var t=n,r=0;r<e.length;++r)t=Oi[t&255^e[r]]^t>>>
8;n=t},d:function(){return~n}}};var Pi=function(n,e,t,r,s){if(!s&&(s={l:1},e.dictionary)){var o=e.dictionary.subarray(-32768),a=new $(o.length+n.length);a.set(o),a.set(n,o.length),n=a,s.w=o.length}
return Ri(n,e.level==null?6:e.level,e.mem==null?s.l?Math.ceil(Math.max(8,Math.min(13,Math.log(n.length)))*1.5):20:12+e.mem,t,r,s)},Ns=function(n,e){var t={};for(var r in n)
t[r]=n[r];for(var r in e)t[r]=e[r];return t};var z=function(n,e,t){for(;t;++e)n[e]=t,t>>>=8};var $i=function(n,e){return((n[0]&15)!=8||n[0]>>4>7||(n[0]<<8|n[1])%31)&&q(6,"invalid zlib data"),(n[1]>>5&1)==+!e&&q(6,"invalid zlib data: "+(n[1]&32?"need":"u\
nexpected")+" dictionary"),(n[1]>>3&4)+2};function Ni(n,e){return Pi(n,e||{},0,0)}function Ls(n,e){return Ci(n.subarray($i(n,e&&e.dictionary),-4),{i:2},e&&e.out,e&&e.dictionary)}var Is=function(n,e,t,r){for(var s in n){var o=n[s],a=e+s,i=r;Array.isArray(o)&&(i=Ns(r,o[1]),o=o[0]),o instanceof $?t[a]=[o,i]:(t[a+="/"]=[new $(0),i],Is(o,a,t,
r))}},Es=typeof TextEncoder<"u"&&new TextEncoder,Li=typeof TextDecoder<"u"&&new TextDecoder,Ii=0;try{Li.decode($s,{stream:!0}),Ii=1}catch{}function Re(n,e){if(e){for(var t=new $(n.length),r=0;r<n.length;++r)t[r]=n.charCodeAt(r);return t}if(Es)return Es.encode(n);for(var s=n.length,o=new $(n.length+
(n.length>>1)),a=0,i=function(h){o[a++]=h},r=0;r<s;++r){if(a+5>o.length){var l=new $(a+8+(s-r<<1));l.set(o),o=l}var c=n.charCodeAt(r);c<128||e?i(c):c<2048?(i(192|
c>>6),i(128|c&63)):c>55295&&c<57344?(c=65536+(c&1047552)|n.charCodeAt(++r)&1023,i(240|c>>18),i(128|c>>12&63),i(128|c>>6&63),i(128|c&63)):(i(224|c>>12),i(128|c>>
6&63),i(128|c&63))}return ur(o,0,a)}var ir=function(n){var e=0;if(n)for(var t in n){var r=n[t].length;r>65535&&q(9),e+=r+4}return e},Cs=function(n,e,t,r,s,o,a,i){var l=r.length,c=t.extra,h=i&&i.length,
u=ir(c);z(n,e,a!=null?33639248:67324752),e+=4,a!=null&&(n[e++]=20,n[e++]=t.os),n[e]=20,e+=2,n[e++]=t.flag<<1|(o<0&&8),n[e++]=s&&8,n[e++]=t.compression&255,n[e++]=
t.compression>>8;var m=new Date(t.mtime==null?Date.now():t.mtime),p=m.getFullYear()-1980;if((p<0||p>119)&&q(10),z(n,e,p<<25|m.getMonth()+1<<21|m.getDate()<<16|m.
getHours()<<11|m.getMinutes()<<5|m.getSeconds()>>1),e+=4,o!=-1&&(z(n,e,t.crc),z(n,e+4,o<0?-o-2:o),z(n,e+8,t.size)),z(n,e+12,l),z(n,e+14,u),e+=16,a!=null&&(z(n,e,
h),z(n,e+6,t.attrs),z(n,e+10,a),e+=14),n.set(r,e),e+=l,u)for(var g in c){var f=c[g],y=f.length;z(n,e,+g),z(n,e+2,y),n.set(f,e+4),e+=4+y}return h&&(n.set(i,e),e+=
h),e},Fi=function(n,e,t,r,s){z(n,e,101010256),z(n,e+8,t),z(n,e+10,t),z(n,e+12,r),z(n,e+16,s)};function Gt(n,e){e||(e={});var t={},r=[];Is(n,"",t,e);var s=0,o=0;for(var a in t){var i=t[a],l=i[0],c=i[1],h=c.level==0?0:8,u=Re(a),m=u.length,p=c.comment,g=p&&
Re(p),f=g&&g.length,y=ir(c.extra);m>65535&&q(11);var v=h?Ni(l,c):l,S=v.length,w=_i();w.p(l),r.push(Ns(c,{size:l.length,crc:w.d(),c:v,f:u,m:g,u:m!=a.length||g&&p.
length!=f,o:s,compression:h})),s+=30+m+y+S,o+=76+2*(m+y)+(f||0)+S}for(var A=new $(o+22),O=s,I=o-s,N=0;N<r.length;++N){var u=r[N];Cs(A,u.o,u,u.f,u.u,u.c.length);
var M=30+u.f.length+ir(u.extra);A.set(u.c,u.o+M),Cs(A,s,u,u.f,u.u,u.c.length,u.o,u.m),s+=16+M+(u.m?u.m.length:0)}return Fi(A,s,r.length,I,O),A}var G=(n,e=2)=>n==null?"-":n.toFixed(e);function Fs(n,e,t){return e===null||t===null?G(n):`${G(n)} (${G(e)} to ${G(t)})`}function je(n){let e=Math.abs(n),t=e>=1e4?
e.toExponential(0):e.toFixed(e<100?2:0);return n<0&&Number(t)?`−${t}`:t}var Ht=n=>n.charAt(0).toUpperCase()+n.slice(1);function dt(n,e,t,r=!1){let s=(e-n)/Math.max(1,t),o=10**Math.floor(Math.log10(s||1)),a=[1,2,5,10].map(c=>c*o).find(
c=>c>=s)??10*o;r&&(a=Math.max(1,Math.round(a)));let i=Math.ceil(n/a-1e-9),l=Math.floor(e/a+1e-9);return Array.from({length:Math.max(0,l-i+1)},(c,h)=>(i+h)*a)}var Ui={teams:{pursuer:"pursuers",evader:"evaders"},generation:{pursuer:"pursuer generation",evader:"evader generation"},score:"capture rate",means:{pursuer:"ca\
ptures",evader:"escapes"},curves:{pursuer:"captures",evader:"escapes"},ends:["0 all escape","1 all caught"],lead:"Each cell is a match between two generations: \
the brighter, the more evaders are captured. Click one to watch it.",click:"watch its match"},Di=([n,e])=>({teams:{pursuer:n,evader:e},generation:{pursuer:`gene\
ration of ${n}`,evader:`generation of ${e}`},score:`score of the ${n}`,means:{pursuer:n,evader:e},curves:{pursuer:"scores",evader:"scores"},ends:[`0 the ${e} wi\
n`,`1 the ${n} win`],lead:`Each cell is a pair of generations: the brighter, the higher the score of the ${n}. Click one to see more of it.`,click:"see more of \
it"}),xe=({game:n})=>n?Di(n.teams):Ui,te=(n,e,t)=>`${xe(n).teams[e]} of generation ${t}`,Wi=200;function Us(n,e,{pursuer:t,evader:r},s){let{text:o,image:a}=e.shows[`${t}\
 ${r}`]??{},i=Se(n,t,r)?.rates??[],l=`Scores of the ${e.teams[0]} in ${i.length} episodes: ${i.map(c=>G(c)).join(", ")}`;return[o===void 0?null:d("pre",{tabindex:0,
"aria-label":"What the game shows of this pair"},o),a===void 0?null:d("img",{src:a,alt:"What the game shows of this pair",onload:({target:c})=>c.classList.toggle(
"pixels",c.naturalWidth<Wi)}),...(o??a)===void 0?[d("p",{class:"muted"},e.missing),zi(n,e,t,r,s)]:[],i.length>1?d("p",{class:"small numbers"},l):null].filter(c=>c!==
null)}function zi(n,e,t,r,s){let o=Object.keys(e.shows).map(h=>h.split(" ").map(Number)),a=([h,u])=>(h-t)**2+(u-r)**2,[i,l]=o.sort((h,u)=>a(h)-a(u))[0]??[];if(i===
void 0||l===void 0)return null;let c=`${te(n,"pursuer",i)} against ${te(n,"evader",l)}`;return d("p",{},d("button",{type:"button",onclick:()=>s.select({pursuer:i,
evader:l})},`Nearest: ${c}`))}var Oe=["pursuer","evader"];function Se(n,e,t){let[r,s]=[e-n.payoff.first[0],t-n.payoff.first[1]],o=n.payoff.capture_rate[r]?.[s];return o===void 0?null:{rate:o,rates:n.payoff.capture_rates[r][s],
lengths:n.payoff.lengths[r]?.[s]??[]}}function jt(n,e,t){let{script:r,policy:s,kept:o,genomes:a}=n.teams[e];if(r!==null||s===null)return"";if(!o.includes(t))return`\
The page holds no genome of ${te(n,e,t)}: it would be too large. Choose a generation of ${o.join(", ")}.`;let i=o.length*s.genome_size;return Gs(a,s.genome_size).
length===i?"":`The page is damaged: it does not hold the ${i} numbers of the ${e}s' genomes. Write it again from its run.`}function se(n,e,t){let{script:r,policy:s,
kept:o,genomes:a}=n.teams[e];if(r!==null||s===null)return r??"random";let i=o.indexOf(t);if(i<0)throw new RangeError(`${e}: expected a generation whose genome t\
he page holds, got ${t}`);let l=s.genome_size,c=Gs(a,l).subarray(i*l,(i+1)*l);return{...s,genome:c}}var Ds=({teams:n},e)=>(n[e].policy??{kind:"cells"}).kind!=="\
cells",Ws=({teams:n},e,t)=>n[e].expressions?.[n[e].kept.indexOf(t)]??"";function zs(n,e,{pursuer:t,evader:r,episode:s,seed:o}){let a=e.seeds[t][r];return n.match(
e.world,se(e,"pursuer",t),se(e,"evader",r),BigInt(o??a),s)}var hr=4,dr=new Map,Bs=(n,e)=>{dr.set(n,e)};function Gs(n,e){let t=dr.get(n);if(t)return t;let r=new Float32Array;
try{let s=Gi(mr(n),e);s.every(Number.isFinite)&&(r=s)}catch(s){if(!(s instanceof DOMException||s instanceof RangeError||Bi(s)))throw s}return dr.set(n,r),r}var Bi=n=>n instanceof
Error&&"code"in n;function Gi(n,e){let t=Ls(n),r=t.length/hr,s=new Uint8Array(t.length);for(let a=0;a<s.length;a++)s[a]=t[a%hr*r+Math.floor(a/hr)];let o=new Uint32Array(
s.buffer);for(let a=e;a<o.length;a++)o[a]^=o[a-e];return new Float32Array(s.buffer)}function mr(n){let e=atob(Ae(n)),t=new Uint8Array(e.length);for(let r=0;r<t.
length;r++)t[r]=e.charCodeAt(r);return t}var Ae=n=>document.getElementById(n)?.textContent??"";var Hs=()=>JSON.parse(Ae("data")),mt={"specialist-specialist":"Specialists: both teams meet only the newest opponent","generalist-specialist":"Pursuers meet all\
 earlier evaders, evaders only the newest pursuers","generalist-generalist":"Generalists: both teams meet all earlier opponents","hall-of-fame":"Halls of fame: \
both teams learn at once, and meet earlier champions"};function _e({schedule:n}){if(n.kind==="hall-of-fame")return n.kind;let e={latest:"specialist","round-robi\
n":"generalist",uniform:"uniform"};return`${e[n.pursuers_meet]}-${e[n.evaders_meet]}`}var Vt=n=>mt[_e(n)]??_e(n);var Yt=10,Kt=999999,pr=[3,5,7,9,11],qt=5,fr=[8,16,32,64],yr=[6,10,30,60,90,120];function Hi(n){let e=Object.values(n.races.es).find(a=>_e(a)==="generalist-gener\
alist"),{n_pursuers:t,n_evaders:r,fov:s,max_steps:o}=e.world;return{schedule:_e(e),beside:null,learner:"es",ratings:!1,seed:e.seed,way:!1,population:0,pursuers:t,
evaders:r,view:s,steps:o,walls:[]}}var Zt=n=>Object.values(n.races.es)[0].world;function Jt(n,e,t=e.schedule){let r=n.races[e.learner][t],s=Zt(n),o={...s,n_pursuers:e.
pursuers,n_evaders:e.evaders,fov:e.view,max_steps:e.steps,obstacles:e.walls.length?Ss(e.walls,s.rows,s.cols):s.obstacles};return{...r,world:o,train_steps:e.steps,
seed:e.seed,policy:e.ratings?{...n.ratings,mask:e.way?"right-of-way":"obstacles"}:{...r.policy,mask:e.way?"right-of-way":"none"},learner:{...r.learner,population:e.
population||r.learner.population}}}function Xt({walls:n,pursuers:e,evaders:t},{rows:r,cols:s}){let o=new Set(Array.from({length:r*s},(i,l)=>l).filter(i=>!n.includes(
i)));if(o.size<e+t)return`There is no room: ${e+t} agents need a free cell each.`;let a=[Math.min(...o)];o.delete(a[0]);for(let i of a){let l=i%s,c=[i-s,i+s,...l>
0?[i-1]:[],...l<s-1?[i+1]:[]];a.push(...c.filter(h=>o.delete(h)))}return o.size?"Nobody may be walled in: all free cells have to be connected, side by side.":""}
function js(n){let{walls:e,way:t,ratings:r,beside:s,...o}=n,a={...o,...s?{beside:s}:{},...t?{way:1}:{},...r?{ratings:1}:{},...e.length?{walls:e.join(".")}:{}};return Object.
entries(a).map(([i,l])=>`${i}=${l}`).join("&")}function Vs(n,e){let t=new URLSearchParams(e.replace(/^#/,"")),r=Hi(n),s=(u,m)=>{let p=t.get(u)??"";return/^\d{1,6}$/.
test(p)&&m(Number(p))?Number(p):r[u]},o=u=>Object.hasOwn(mt,t.get(u)??"")?t.get(u):null,a=Zt(n),i=(t.get("walls")??"").split(".").filter(u=>/^\d{1,4}$/.test(u)).
map(Number),l=s("view",u=>pr.includes(u)),c=t.get("way")==="1",h={schedule:o("schedule")??r.schedule,beside:o("beside"),learner:t.get("learner")==="ga"?"ga":r.learner,
ratings:t.get("ratings")==="1",seed:s("seed",u=>u<=Kt),pursuers:s("pursuers",u=>u>=1&&u<=Yt),evaders:s("evaders",u=>u>=1&&u<=Yt),view:c?Math.max(qt,l):l,way:c,population:s(
"population",u=>fr.includes(u)),steps:s("steps",u=>yr.includes(u)),walls:i.filter(u=>u<a.rows*a.cols).reduce((u,m)=>Wt(u,m,!0),[])};return Xt(h,a)?{...h,walls:[]}:
h}function le(n,e,t,r=""){return d("label",{class:`field ${r}`,title:e},d("span",{class:"field-name"},n),t,d("span",{class:"about small muted"},e))}function Ys(n){
let e=Object.entries(mt),t=re(e,y=>n({schedule:y})),r=re([["","Nothing"],...e],y=>n({beside:y||null},!0)),s=Array.from({length:Yt},(y,v)=>[v+1,String(v+1)]),o=re(
s,y=>n({pursuers:Number(y)})),a=re(s,y=>n({evaders:Number(y)})),i=re(pr.map(y=>[y,`${y} x ${y}`]),y=>n({view:Number(y),...Number(y)<qt?{way:!1}:{}})),l=d("input",
{type:"checkbox",onchange:()=>n({way:l.checked,...l.checked?{view:Math.max(qt,Number(i.value))}:{}})}),c=re([[0,"usual"],...fr.map(y=>[y,String(y)])],y=>n({population:Number(
y)})),h=re(yr.map(y=>[y,String(y)]),y=>n({steps:Number(y)})),u=re([["es","evolution strategy"],["ga","genetic algorithm"]],y=>n({learner:y},!0)),m=re([["","a ne\
twork over the cells of its view"],["1","weights of named inputs"]],y=>n({ratings:y==="1"},!0)),p=d("input",{type:"number",min:0,max:Kt,step:1,inputmode:"numeri\
c"});p.addEventListener("change",()=>n({seed:Math.min(Kt,Math.max(0,Math.round(Number(p.value))||0))},!0));let g=d("button",{type:"button",onclick:()=>n({seed:Math.
floor(Math.random()*1e3)},!0)},"Another seed"),f=(y,...v)=>d("section",{class:"card controls","aria-label":y},d("fieldset",{},d("legend",{},y),...v));return{now:f(
"Change it while it evolves",le("Opponents","whom the teams meet while they learn",t,"wide"),le("Pursuers","triangles",o),le("Evaders","discs",a),le("View","cel\
ls that an agent sees around itself",i),le("Right of way","agents never take a move that could put them at fault",d("span",{},l)),le("Population","candidates th\
at are compared at a time",c),le("Steps","of a match",h)),anew:f("Begin anew",le("Side by side with","a second race of the same seed",r,"wide"),le("Learner","ho\
w a team learns",u,"half"),le("What evolves","what an agent decides by",m,"half"),le("Seed","the luck of the race",d("span",{class:"seed"},p,g),"half")),show:y=>{
[t.value,r.value,i.value,u.value]=[y.schedule,y.beside??"",String(y.view),y.learner],[c.value,h.value,p.value,l.checked]=[String(y.population),String(y.steps),String(
y.seed),y.way],m.value=y.ratings?"1":"",[o.value,a.value]=[String(y.pursuers),String(y.evaders)]}}}var Qt={left:46,right:12,top:10,bottom:42},Ks={x:56,y:34};function Zs(n,e,t,r){let[s,o]=[Qt.left,Qt.top],a=Math.max(s+40,n-Qt.right),i=Math.max(o+40,e-Qt.bottom),
l=(f,y,v)=>S=>y+(S-f.low)/(f.high-f.low||1)*(v-y),[c,h]=[l(t,s,a),l(r,i,o)],u=b("g"),m=b("svg",{width:n,height:e,viewBox:`0 0 ${n} ${e}`,class:"plot"}),p=b("g",
{class:"axes"});for(let f of dt(r.low,r.high,(i-o)/Ks.y,r.whole))p.append(b("line",{x1:s,x2:a,y1:h(f),y2:h(f),class:"grid"}),b("text",{x:s-8,y:h(f),"text-anchor":"\
end","dominant-baseline":"middle"},qs(f)));for(let f of dt(t.low,t.high,(a-s)/Ks.x,t.whole))p.append(b("text",{x:c(f),y:i+16,"text-anchor":"middle"},qs(f)));return p.
append(b("line",{x1:s,x2:a,y1:i,y2:i,class:"axis"}),b("text",{x:(s+a)/2,y:e-6,"text-anchor":"middle",class:"label"},t.label),b("text",{transform:`translate(12 ${(o+
i)/2}) rotate(-90)`,"text-anchor":"middle",class:"label"},r.label)),m.append(p,u),{root:m,marks:u,left:s,right:a,top:o,bottom:i,x:c,y:h,at:f=>{let y=f-m.getBoundingClientRect().
left;return t.low+(y-s)/(a-s)*(t.high-t.low)}}}var qs=n=>String(Number(n.toPrecision(6))).replace("-","−");function Js(n,e,t,r){let s="",o="M";t.forEach((a,i)=>{
a===null?o="M":(s+=`${o}${n.x(e[i]).toFixed(1)} ${n.y(a).toFixed(1)}`,o="L")}),n.root.insertBefore(b("path",{d:s,class:`line ${r}`}),n.marks)}function Xs(...n){return d("p",{class:"legend small"},...n.map(([e,t])=>d("span",{class:`key ${t}`},e)))}function Qs(n,e,t,r){let s=d("div",{class:"chart choose\
s",role:"img","aria-label":n}),o=null,a=()=>{o?.marks.replaceChildren(),o&&t(o)};s.addEventListener("click",l=>o&&r(o.at(l.clientX),o,l));let i=()=>{let{clientWidth:l,
clientHeight:c}=s;l<50||c<50||(o=e(l,c),s.replaceChildren(o.root),a())};return new ResizeObserver(i).observe(s),{element:s,update:a,redraw:i}}var Ve=[[0,0],[-1,0],[0,1],[1,0],[0,-1],[-1,1],[1,1],[1,-1],[-1,-1]];function eo(n,e,t){let[r,s]=[e[0]-n[0],e[1]-n[1]];return!t&&Math.abs(r)>Math.abs(s)?s=0:t||
(r=0),Ve.findIndex(([o,a])=>o===Math.sign(r)&&a===Math.sign(s))}var Pe=(n,e)=>e<n.nPursuers,k=(n,e)=>[n.positions[2*e],n.positions[2*e+1]],gr=({rows:n,cols:e},[
t,r])=>t>=0&&r>=0&&t<n&&r<e,vr=(n,e,t=3)=>n!==void 0&&[0,1,2].slice(0,t).some(r=>n[3*e+r]),br=(n,e)=>vr(n.fault,e),to=(n,e)=>!br(n,e)&&vr(n.involved,e,2);function en(n,e,t){
let[r,s]=[k(n,t),k(e,t)],o=r[0]!==s[0]||r[1]!==s[1],a=e.involved===void 0||vr(e.involved,t);return!!(e.alive[t]&&e.actions?.[t]&&!o&&a)}function tn(n,e,t){let[r,
s]=k(n,t),[o,a]=Ve[e.actions?.[t]??0];return[r+o,s+a]}function pt(n,e,t){return Array.from({length:t.everCaptured.length},(s,o)=>o).filter(s=>t.everCaptured[s]&&
!e.everCaptured[s]).map(s=>n.nPursuers+s)}var nn=n=>n.moments.flatMap((e,t)=>t&&pt(n,n.moments[t-1],e).length?[t]:[]);function rn(n,e){return Array.from({length:e.
alive.length},(r,s)=>s).filter(r=>n.alive[r]&&!e.alive[r])}var no=[-.31,0,.31],ro=[{size:1,at:[[0,0]]},{size:.62,at:[[-.2,.2],[.2,-.2]]},{size:.54,at:[[-.23,.22],[.23,.22],[0,-.22]]},{size:.54,at:[[-.23,.23],[.23,.23],[
-.23,-.23],[.23,-.23]]},{size:.36,at:no.flatMap(n=>no.map(e=>[e,n]))}],ji=.3,Vi=.35,Yi=.55;function ft(n,e){let t=new Map;for(let r=0;r<e.alive.length;r++){if(!e.
alive[r])continue;let[s,o]=k(e,r),a=s*n.cols+o,i=t.get(a);i?i.push(r):t.set(a,[r])}return t}function so(n,e){let t=Array.from(e.alive,(r,s)=>{let[o,a]=k(e,s);return{
x:a+.5,y:o+.5,size:1,alpha:0}});for(let r of ft(n,e).values()){let s=ro[Math.min(r.length,ro.length)-1];r.forEach((o,a)=>{let[i,l]=s.at[Math.min(a,s.at.length-1)],
c=t[o];c.x+=i,c.y+=l,c.size=s.size,c.alpha=1})}return t}var oo=n=>n*n*(3-2*n),Ye=(n,e,t)=>n+(e-n)*t,ao=n=>Math.min(1,Math.max(0,n));function io(n,e,t,r){let s={
SIMULTANEOUS:1,SWARM_TURNS:2,AGENT_TURNS:t}[n.interaction];if(s===1)return oo(r);let o=s===t?e:+!Pe(n,e),a=Math.max(1/s,Vi);return oo(ao((r-o/(s-1)*(1-a))/a))}function sn(n,e){
let t=n.moments.length-1,r=Math.min(Math.floor(e),t),s=n.moments[r],o=so(n,s);if(r===t||e===r)return o;let a=n.moments[r+1],i=so(n,a);return o.map((l,c)=>{let h=io(
n,c,o.length,e-r);return Ki(s,a,c,l,i[c],h)})}function wr(n,e,t){let r=n.moments.length-1,s=Math.min(Math.floor(t),r),[o,a]=[n.moments[s],n.moments[Math.min(s+1,
r)]],i=io(n,e,o.alive.length,t-s),[[l,c],[h,u]]=[k(o,e),k(a,e)];return[Ye(c,u,i)+.5,Ye(l,h,i)+.5]}function Ki(n,e,t,r,s,o){let a=r.alpha>s.alpha,i={x:Ye(r.x,s.x,
o),y:Ye(r.y,s.y,o),size:a?r.size:Ye(r.size,s.size,o),alpha:a?ao((1-o)/(1-Yi)):Ye(r.alpha,s.alpha,o)};if(en(n,e,t)){let[l,c]=k(n,t),[h,u]=tn(n,e,t),m=ji*Math.sin(
Math.PI*o);i.x+=(u-c)*m,i.y+=(h-l)*m}return i}var lo=2*Math.PI;function $e(n,e,t,r){n.beginPath(),n.arc(e,t,r/2,0,lo)}function on(n,e,t,r){let s=r/2,o=[[0,-.97],[.97,.83],[-.97,.83]].map(([a,i])=>[e+a*s,t+i*
s]);n.beginPath(),n.moveTo((o[2][0]+o[0][0])/2,(o[2][1]+o[0][1])/2),o.forEach(([a,i],l)=>{let[c,h]=o[(l+1)%3];n.arcTo(a,i,c,h,r*.09)}),n.closePath()}function co(n,e,t,r){
let s=r*.32;n.beginPath(),n.moveTo(e-s,t-s),n.lineTo(e+s,t+s),n.moveTo(e+s,t-s),n.lineTo(e-s,t+s)}function uo(n,e,t,r){n.beginPath();for(let s=0;s<16;s++){let o=r/
2*(s%2?.6:.95),a=lo*s/16;n.lineTo(e+o*Math.sin(a),t-o*Math.cos(a))}n.closePath()}function ho(n,e,t,r,s,o){let a=Math.atan2(s-t,r-e);n.beginPath(),n.moveTo(e,t),
n.lineTo(r,s);for(let i of[-1,1])n.moveTo(r,s),n.lineTo(r-o*Math.cos(a+i*.6),s-o*Math.sin(a+i*.6))}var mo=4,qi=1.6,Zi=.95,Ji=5,Xi=.16,Qi=9,el=.09,tl=.2,po=.75,H=(n,e)=>n.left+e*n.cell,j=(n,e)=>n.top+e*n.cell;function Ke(n,e,t){return Pe(e,t)?n.colors.pursuer:
n.colors.evader}function an({ctx:n,colors:e},t,r,s,o,a,i=0){n.font=`700 ${Math.round(o)}px system-ui, sans-serif`,n.textAlign="center",n.textBaseline="middle",n.
strokeStyle=e.paper,n.lineWidth=i,i&&n.strokeText(t,r,s),n.fillStyle=a,n.fillText(t,r,s)}function fo({ctx:n,grid:e,colors:t}){let{left:r,top:s,cell:o,rows:a,cols:i}=e,
[l,c]=[i*o,a*o];if(n.fillStyle=t.paper,n.fillRect(r,s,l,c),o<Ji)return;n.fillStyle=t.line;let h=Math.max(1,Math.round(o/60));for(let u=1;u<i;u++)n.fillRect(r+u*
o,s,h,c);for(let u=1;u<a;u++)n.fillRect(r,s+u*o,l,h)}function yo({ctx:n,grid:e,colors:t},r){let{left:s,top:o,cell:a,rows:i,cols:l}=e;n.fillStyle=t.obstacle;for(let c=0;c<
i*l;c++){if(!r.obstacles[c])continue;let[h,u]=[Math.floor(c/l),c%l];n.fillRect(s+u*a,o+h*a,a,a)}go({ctx:n,grid:e,colors:t})}function go({ctx:n,grid:{left:e,top:t,
cell:r,rows:s,cols:o},colors:a}){let i=Math.min(5,Math.max(2,Math.round(r/18)));n.strokeStyle=a.frame,n.lineWidth=i,n.strokeRect(e-i/2,t-i/2,o*r+i,s*r+i)}function vo({
ctx:n,grid:e,colors:t},r){let{left:s,top:o,cell:a,rows:i,cols:l}=e,c=a<24*r?5:1;n.font=`500 ${Math.round(Math.min(15*r,Math.max(9*r,a*.32)))}px system-ui, sans-\
serif`,n.fillStyle=t.muted,n.textBaseline="alphabetic",n.textAlign="center";let h=5*r+a/40;for(let u=0;u<l;u+=c)n.fillText(String(u),s+(u+.5)*a,o-h);n.textAlign=
"right",n.textBaseline="middle";for(let u=0;u<i;u+=c)n.fillText(String(u),s-h,o+(u+.5)*a)}function bo({grid:n},e,t,r){let s=Math.floor(e.fov/2)+.5,[o,a]=[Math.max(
0,t-s),Math.min(n.cols,t+s)],[i,l]=[Math.max(0,r-s),Math.min(n.rows,r+s)];return[H(n,o),j(n,i),(a-o)*n.cell,(l-i)*n.cell]}function wo(n,e,t,r){let{ctx:s,grid:o,
colors:a}=n;s.save(),s.beginPath(),s.rect(0,0,s.canvas.width,s.canvas.height),s.rect(...bo(n,e,t,r)),s.clip("evenodd"),s.clearRect(0,0,s.canvas.width,s.canvas.height),
s.fillStyle=a.line,s.fillRect(o.left,o.top,o.cols*o.cell,o.rows*o.cell),s.restore(),go(n)}function xo(n,{x:e,y:t,alpha:r},s){let{ctx:o,grid:a,colors:i}=n,l=Math.
max(a.cell,16*s)*1.06,[c,h]=[H(a,e),j(a,t)];o.globalAlpha=Math.max(r,.6),o.beginPath(),o.roundRect(c-l/2,h-l/2,l,l,l*.2),o.strokeStyle=i.focus,o.lineWidth=Math.
max(2,2.5*s),o.stroke();let u=Math.max(11*s,Math.min(18*s,a.cell*.5)),m=h-l/2<u*1.2,p=h+(m?1:-1)*(l/2+u*.7);o.lineJoin="round",an(n,"You",c,p,u,i.ink,u*.35),o.globalAlpha=
1}function So(n,e,t,r,s){let{ctx:o,grid:a}=n,i=bo(n,e,r,s),l=Ke(n,e,t);o.globalAlpha=.11,o.fillStyle=l,o.fillRect(...i),o.globalAlpha=.8,o.strokeStyle=l,o.lineWidth=
Math.max(1,a.cell/24),o.strokeRect(...i),o.globalAlpha=1}function Ao(n,e,t,r,s){let{ctx:o,grid:a}=n,i=Math.min(Math.ceil(t),e.moments.length-1),l=e.moments[i];o.
lineCap="round",o.lineWidth=Math.min(Qi,Math.max(1,a.cell*Xi));for(let c=Math.max(1,Math.floor(t-r)+1);c<=i;c++){let[h,u]=[e.moments[c-1],e.moments[c]],m=Math.max(
0,Math.min(1,(t-c)/r));o.globalAlpha=po+(tl-po)*m;for(let p=0;p<u.alive.length;p++){let g=c===i&&t<i;if(!h.alive[p]||!(l.alive[p]||g))continue;let f=(Pe(e,p)?-1:
1)*el,[y,v]=k(h,p),[S,w]=k(u,p);if(y===S&&v===w)continue;let A=g?s[p].x:w+.5,O=g?s[p].y:S+.5;o.strokeStyle=Ke(n,e,p),o.beginPath(),o.moveTo(H(a,v+.5+f),j(a,y+.5+
f)),o.lineTo(H(a,A+f),j(a,O+f)),o.stroke()}}o.globalAlpha=1}function Mo(n,e,t){let r=Math.min(Math.ceil(t),e.moments.length-1);for(let s=Math.max(1,r-mo+1);s<=r;s++){
let[o,a]=[e.moments[s-1],e.moments[s]],i=s>t?Math.max(0,1-2*(s-t)):1-(t-s)/mo,l=pt(e,o,a);for(let c of rn(o,a))l.includes(c)||rl(n,k(a,c),i);for(let c of l)nl(n,
k(a,c),i)}n.ctx.globalAlpha=1}function nl({ctx:n,grid:e,colors:t},[r,s],o){n.globalAlpha=o,uo(n,H(e,s+.5),j(e,r+.5),Math.max(8,e.cell*qi)),n.fillStyle=t.capture,
n.fill(),n.strokeStyle=t.ink,n.lineWidth=Math.max(1,e.cell/36),n.lineJoin="round",n.stroke()}function rl({ctx:n,grid:e,colors:t},[r,s],o){n.globalAlpha=o,co(n,H(
e,s+.5),j(e,r+.5),Math.max(7,e.cell*Zi)),n.strokeStyle=t.collision,n.lineWidth=Math.max(2,e.cell*.17),n.lineCap="round",n.stroke()}function To({ctx:n,grid:e,colors:t},r,s){
let o=Math.max(1,e.cell*.07);n.strokeStyle=n.fillStyle=t.collision,n.lineWidth=Math.max(1,e.cell*.05),n.setLineDash([e.cell*.14,e.cell*.1]);for(let[a,i]of r){if(a<
0||i<0||a>=e.rows||i>=e.cols)continue;let l=[H(e,i)+o,j(e,a)+o,e.cell-2*o,e.cell-2*o];n.globalAlpha=.2*s,n.fillRect(...l),n.globalAlpha=s,n.strokeRect(...l)}n.setLineDash(
[]),n.globalAlpha=1}function Eo({ctx:n,grid:e,colors:t},r,s,o,a){n.globalAlpha=a,$e(n,H(e,r),j(e,s),Math.max(8,e.cell*o*1.02)),n.strokeStyle=t.collision,n.lineWidth=
Math.max(1.5,e.cell*.085*Math.sqrt(o)),n.stroke(),n.globalAlpha=1}var sl=.8,ol=.92,al=15,il=7,xr=9;function Co(n,e,t,r,s,o){r.forEach((a,i)=>{a.alpha>0&&ll(n,e,t,i,a,s,o)}),n.ctx.globalAlpha=1;for(let a of ft(e,t).values())a.length>
xr&&cl(n,r[a[xr-1]],a.length-xr+1)}function ll(n,e,t,r,s,o,a){let{ctx:i,grid:l,colors:c}=n,h=Pe(e,r),[u,m]=[H(l,s.x),j(l,s.y)],p=Math.max(4,l.cell*s.size*(h?ol:
sl)),g=Ke(n,e,r),f=!h&&!!t.captured[r-e.nPursuers];if(i.globalAlpha=s.alpha,(h?on:$e)(i,u,m,p),p>il*a&&(i.strokeStyle=c.paper,i.lineWidth=Math.max(2,p*.1),i.stroke()),
i.fillStyle=f?c.paper:g,i.fill(),f&&($e(i,u,m,p*.82),i.strokeStyle=g,i.lineWidth=p*.18,i.stroke()),!o||p<al*a)return;let y=String(h?r:r-e.nPursuers),v=p*(h?.4:.5)*
(y.length>1?.8:1);an(n,y,u,m+p*(h?.17:.03),v,f?g:c.paper)}function cl(n,e,t){let{cell:r}=n.grid;an(n,`+${t}`,H(n.grid,e.x),j(n.grid,e.y),r*.3,n.colors.ink,r*.1)}var ul=.46,hl=.86,dl=.66,ko=.48,ml=.78,pl=.58;function Ro(n,e,t,r){let[s,o]=[e.moments[t-1],e.moments[t]];if(!s)return;let{ctx:a,grid:i,colors:l}=n;a.strokeStyle=
l.collision,a.lineWidth=Math.max(1.5,i.cell*.07),a.lineCap="butt",a.globalAlpha=r;for(let c=0;c<o.alive.length;c++)en(s,o,c)&&fl(n,e,k(s,c),tn(s,o,c));a.globalAlpha=
1}function fl({ctx:n,grid:e},t,r,s){let[o,a]=[s[1]-r[1],s[0]-r[0]],i=u=>H(e,r[1]+.5+o*u),l=u=>j(e,r[0]+.5+a*u),c=gr(t,s)?ml:pl;n.setLineDash([e.cell*.09,e.cell*
.06]),n.beginPath(),n.moveTo(i(ko),l(ko)),n.lineTo(i(c),l(c)),n.stroke(),n.setLineDash([]);let h=.17*e.cell/Math.hypot(o,a);n.beginPath(),n.moveTo(i(c)-a*h,l(c)+
o*h),n.lineTo(i(c)+a*h,l(c)-o*h),n.stroke()}function Oo(n,e,t,r,s,o){let a=Ve[o];if(!o||!a)return;let{ctx:i,grid:l,colors:c}=n,h=gr(e,[r[0]+a[0],r[1]+a[1]])?hl:
dl,u=ul*s.size,m=[H(l,s.x+a[1]*u),j(l,s.y+a[0]*u),H(l,s.x+a[1]*h),j(l,s.y+a[0]*h)],p=Math.max(1.5,l.cell*.085);i.lineCap=i.lineJoin="round";for(let[g,f]of[[c.paper,
p*2.1],[Ke(n,e,t),p]])i.strokeStyle=g,i.lineWidth=f,ho(i,...m,l.cell*.2),i.stroke()}var Po={numbers:!0,axes:!1,trail:6,viewers:[],plan:null,selected:null,cursor:null,you:null,fog:!1};function $o(n,e,t,r,s){let{ctx:o,grid:a,colors:i}=n,l=Math.min(
Math.ceil(t),e.moments.length-1),c=e.moments[l],h=t===l,u=sn(e,t),m=h?1:Math.max(0,1-2*(l-t));o.clearRect(0,0,o.canvas.width,o.canvas.height),fo(n);for(let f of r.
viewers)u[f]?.alpha&&So(n,e,f,...wr(e,f,t));yo(n,e),r.axes&&vo(n,s),Ao(n,e,t,r.trail,u),To(n,c.contested??[],m),Mo(n,e,t),Ro(n,e,l,m),u.forEach(({x:f,y,size:v},S)=>{
let w=to(c,S)?.4:0,A=br(c,S)?1:w;A&&Eo(n,f,y,v,A*m)});let p=h?c:e.moments[Math.max(0,l-1)];if(Co(n,e,p,u,r.numbers,s),h&&r.plan)for(let[f,y]of u.entries())y.alpha&&
Oo(n,e,f,k(c,f),y,r.plan[f]??0);r.you!==null&&(r.fog&&wo(n,e,...wr(e,r.you,t)),xo(n,u[r.you],s)),o.lineWidth=Math.max(2,2.5*s),o.strokeStyle=i.focus;let g=r.selected===
null?void 0:u[r.selected];g?.alpha&&_o(n,g.x,g.y,g.size*.96),r.cursor&&(o.setLineDash([a.cell*.12,a.cell*.08]),_o(n,r.cursor[1]+.5,r.cursor[0]+.5,.8),o.setLineDash(
[]))}function _o({ctx:n,grid:e},t,r,s){let o=s*e.cell;n.beginPath(),n.roundRect(e.left+t*e.cell-o/2,e.top+r*e.cell-o/2,o,o,o*.1),n.stroke()}var No=(n,e)=>(e+.24)/(n+.24);function Lo(n,e,t,r,s,o){let a=t?28*o:0,i=(c,h)=>(c-a)/(h+2*.12),l=Math.max(1,Math.floor(Math.min(i(r,e),i(s,n))));return{rows:n,cols:e,
cell:l,left:Math.round((r-e*l+a)/2),top:Math.round((s-n*l+a)/2)}}function Io(n,e,t){let r=Math.floor((t-n.top)/n.cell),s=Math.floor((e-n.left)/n.cell);return r>=
0&&r<n.rows&&s>=0&&s<n.cols?[r,s]:null}var yl=["paper","line","frame","ink","muted","obstacle"],gl=["pursuer","evader","capture","collision","focus"];function ln(n){let e=getComputedStyle(n),t=(r,s)=>[
r,e.getPropertyValue(s+r).trim()];return Object.fromEntries([...yl.map(r=>t(r,"--board-")),...gl.map(r=>t(r,"--"))])}var ye=()=>matchMedia("(prefers-reduced-motion: reduce)").matches,Me=class{canvas;#e=null;#n=0;#t;#s={rows:1,cols:1,left:0,top:0,cell:1};#a=0;constructor(e,t={}){
this.canvas=e,e.classList.add("board"),e.setAttribute("role","img"),this.#t={...Po,...t},new ResizeObserver(()=>this.#l()).observe(e),new MutationObserver(()=>this.
redraw()).observe(document.documentElement,{attributes:!0}),addEventListener("beforeprint",()=>this.drawNow())}set look(e){this.#t={...this.#t,...e},this.#r(),this.
redraw()}show(e,t){this.#e=e,this.#n=Math.min(Math.max(0,t),e.moments.length-1),this.#r(),this.redraw()}redraw(){this.#a||(this.#a=requestAnimationFrame(()=>this.
drawNow()))}drawNow(){cancelAnimationFrame(this.#a),this.#a=0;let e=this.canvas.getContext("2d");if(!e||!this.#e)return;let{rows:t,cols:r}=this.#e,s=devicePixelRatio||
1;this.#s=Lo(t,r,this.#t.axes,this.canvas.width,this.canvas.height,s);let o={ctx:e,grid:this.#s,colors:ln(this.canvas)};$o(o,this.#e,this.#n,this.#t,s)}cellAt(e,t){
let r=this.canvas.getBoundingClientRect(),s=this.canvas.width/r.width;return Io(this.#s,(e-r.left)*s,(t-r.top)*s)}agentAt(e,t){let r=this.cellAt(e,t);if(!r||!this.#e)
return null;let s=this.#e.moments[Math.round(this.#n)],o=ft(this.#e,s).get(r[0]*this.#e.cols+r[1])??[],a=sn(this.#e,Math.round(this.#n)),i=l=>{let[c,h]=this.pointOf(
a[l].x,a[l].y);return Math.hypot(c-e,h-t)};return o.length?o.reduce((l,c)=>i(c)<i(l)?c:l):null}pointOf(e,t){let r=this.canvas.getBoundingClientRect(),s=r.width/
this.canvas.width,{left:o,top:a,cell:i}=this.#s;return[r.left+(o+e*i)*s,r.top+(a+t*i)*s]}#r(){if(!this.#e)return;let{rows:e,cols:t}=this.#e;this.canvas.style.setProperty(
"--board-aspect",String(No(e,t)))}#l(){let e=devicePixelRatio||1,{width:t,height:r}=this.canvas.getBoundingClientRect();this.canvas.width=Math.max(1,Math.round(
t*e)),this.canvas.height=Math.max(1,Math.round(r*e)),this.drawNow()}};function Sr(n,e,t){let{rows:r,cols:s,n_pursuers:o,fov:a,rules:{interaction:i}}=n;return{rows:r,cols:s,nPursuers:o,fov:a,interaction:i,obstacles:e,moments:t}}function Ar(n,e){
return{positions:n.read("last_positions"),alive:n.read("alive"),captured:n.read("captured"),everCaptured:n.read("ever_captured"),actions:e,involved:n.read("invo\
lved"),fault:n.read("fault"),contested:n.conflicts().map(t=>t.cell)}}function cn(n){let e=Array.from({length:n.length+1},(t,r)=>vl(n,r));return Sr(n.config,n.map,
e)}function vl(n,e){let t=n.n_agents,r=n.config.n_evaders,s=(a,i,l)=>a.subarray(i*l,(i+1)*l),o={positions:s(n.last_positions,e,2*t),alive:s(n.alive,e,t),captured:s(
n.captured,e,r),everCaptured:s(n.ever_captured,e,r)};return e===0?o:{...o,actions:s(n.actions,e-1,t),involved:s(n.involved,e-1,3*t),fault:s(n.fault,e-1,3*t),get contested(){
return n.conflicts(e).map(a=>a.cell)}}}var yt=[.5,1,2,4,8,16,32,64],un=0,hn=12,bl=2,Te=class extends EventTarget{#e;#n;#t;#s=0;#a=0;#r=!1;#l=null;#d=0;#m=[];#i=[];glide=.28;constructor(e,{speed:t=4,still:r=!1}={}){
super(),[this.#e,this.#n,this.#t]=[e,t,r]}get step(){return this.#s}get time(){return this.#t?this.#s:this.#a}get arrived(){return this.#a===this.#s}get playing(){
return this.#r}get length(){return this.#e}set length(e){this.#e=e,this.#s>e&&this.jump(e),this.#o("state")}get marks(){return this.#m}set marks(e){this.#m=e,this.#o(
"state")}get ticks(){return this.#i}set ticks(e){this.#i=e,this.#o("state")}get pace(){return this.#n||Math.max(bl,this.#e/hn)}get speed(){return this.#n}set speed(e){
this.#n=e,this.#o("state")}changeSpeed(e){let t=yt.findIndex(r=>r>=this.pace);this.speed=yt[Math.min(yt.length-1,Math.max(0,t+e))]}play(){this.#r||!this.#e||(this.#s===
this.#e&&this.jump(0),this.#r=!0,this.#o("state"),this.#u())}pause(){this.#r&&(this.#r=!1,this.#o("state"))}toggle(){this.#r?this.pause():this.play()}move(e){this.
pause();let t=Math.min(this.#e,Math.max(0,this.#s+e));Math.abs(t-this.#a)>1?this.jump(t):this.#h(t),this.#u()}jump(e){this.#a=Math.min(this.#e,Math.max(0,Math.round(
e))),this.#h(this.#a),this.#o("frame")}#h(e){e!==this.#s&&(this.#s=e,this.#o("step"),this.#t&&this.#o("frame"))}#u(){this.#l===null&&(this.#d=performance.now(),
this.#l=requestAnimationFrame(()=>this.#c()))}#c(){this.#l=null;let e=performance.now();this.#p(Math.min(.25,(e-this.#d)/1e3)),this.#d=e,(!this.#t||this.arrived)&&
this.#o("frame"),(this.#r||this.#a!==this.#s)&&(this.#l=requestAnimationFrame(()=>this.#c()))}#p(e){let t=e;for(;t>0;){if(this.#a===this.#s){if(!this.#r)return;
if(this.#s===this.#e)return this.pause();this.#h(this.#s+1)}let r=this.#r?this.pace:1/this.glide,s=this.#s-this.#a,o=Math.min(Math.abs(s),t*r);t-=o/r,this.#a=o===
Math.abs(s)?this.#s:this.#a+Math.sign(s)*o}this.#r&&this.#a===this.#e&&this.pause()}#o(e){this.dispatchEvent(new Event(e))}};function dn(n,e){if(e.ctrlKey||e.metaKey||
e.altKey)return!1;let t=e.shiftKey?10:1,s={" ":()=>n.toggle(),ArrowRight:()=>n.move(t),ArrowLeft:()=>n.move(-t),Home:()=>n.move(-n.length),End:()=>n.move(n.length),
"+":()=>n.changeSpeed(1),"-":()=>n.changeSpeed(-1)}[e.key];return s?.(),s!==void 0}var wl={first:"M6 5v14M19 5 9 12l10 7z",back:"M17 5 7 12l10 7z",play:"M7 4.5 19 12 7 19.5z",pause:"M8 5v14M16 5v14",forward:"M7 5l10 7-10 7z",last:"M18 5v14M5 5\
l10 7-10 7z"};function Fo(n){return b("svg",{viewBox:"0 0 24 24","aria-hidden":"true",class:"icon"},b("path",{d:wl[n]}))}function gt(n,e,t,r){return d("button",
{type:"button",class:"player-button","aria-label":e,title:`${e} (${t})`,onclick:r},Fo(n))}function mn(n){let e=gt("play","Play","Space",()=>n.toggle()),t=d("inp\
ut",{type:"range",class:"player-scrub",min:0,step:1,"aria-label":"Step",oninput:()=>{n.pause(),n.jump(Number(t.value))}}),r=d("div",{class:"captures","aria-hidd\
en":"true",title:"Captures"}),s=d("div",{class:"losses","aria-hidden":"true"}),o=d("select",{class:"player-speed","aria-label":"Speed",title:`Steps a second, or\
 the whole in ${hn} s (+ and -)`,onchange:()=>n.speed=Number(o.value)},d("option",{value:un},`in ${hn} s`),...yt.map(u=>d("option",{value:u},`${u} / s`))),a=d("\
output",{class:"player-count"}),i=d("div",{class:"player",role:"group","aria-label":"Player"},gt("first","First step","Home",()=>n.move(-n.length)),gt("back","S\
tep back","←",()=>n.move(-1)),e,gt("forward","Step forward","→",()=>n.move(1)),gt("last","Last step","End",()=>n.move(n.length)),d("div",{class:"scrub"},r,s,
t),a,o),l=(u,m={})=>{let p=d("i",m);return p.style.left=`${100*u/Math.max(1,n.length)}%`,p},c=()=>{r.replaceChildren(...n.marks.map(u=>l(u))),s.replaceChildren(
...n.ticks.map(({step:u,kind:m,size:p,text:g})=>{let f=l(u,{class:m,title:`Step ${u}: ${g}`});return f.style.height=`${100*p}%`,f}))},h=()=>{e.replaceChildren(Fo(
n.playing?"pause":"play")),e.ariaLabel=n.playing?"Pause":"Play",e.title=`${e.ariaLabel} (Space)`,t.max=String(n.length),t.value=String(n.step),t.ariaValueText=`\
step ${n.step} of ${n.length}`,a.textContent=`${n.step} / ${n.length}`,a.style.minWidth=`${2*String(n.length).length+3}ch`,o.value=String(n.speed)};return n.addEventListener(
"step",h),n.addEventListener("state",h),n.addEventListener("state",c),i.addEventListener("keydown",u=>{!(u.target instanceof HTMLSelectElement||u.key===" "&&u.target!==
t)&&dn(n,u)&&u.preventDefault()}),h(),i}var xl=40,pn=class{element;#e;#n=d("div",{class:"episodes",role:"group","aria-label":"Episodes of this cell"});#t=d("p",{class:"check small numbers","aria-live":"\
polite"});constructor(e){this.#e=e,this.element=d("div",{class:"strip-of-episodes"},this.#n,this.#t)}show(e,t){let{pursuer:r,evader:s,episode:o,seed:a}=this.#e.
selected,i=Se(e,r,s);this.#n.replaceChildren(...(i?.rates??[]).slice(0,xl).map((m,p)=>this.#s(m,p)));let l=a===null?i?.rates[o]:void 0,c=t.statistics.capture_rate,
h=l!==void 0&&Math.abs(c-l)<1e-6&&t.length===i?.lengths[o],u=i?"Not an episode of the evaluation":"The evaluation played no episodes of this pair.";this.#t.dataset.
equal=String(h),this.#t.textContent=h?"As in the evaluation":l===void 0?u:`Episode ${o+1} differs from the evaluation.`,this.#t.title=`Played here: capture rate\
 ${G(c,3)} in ${t.length} steps.${i?` The cell says ${G(i.rate,3)}.`:""}`}#s(e,t){let{selected:r}=this.#e,s=d("span",{class:"bar"});return s.style.height=`${Math.
round(100*e)}%`,d("button",{type:"button",class:"episode",title:`Episode ${t+1}: capture rate ${G(e)}`,"aria-label":`Episode ${t+1}, capture rate ${G(e)}`,"aria\
-pressed":String(t===r.episode&&r.seed===null),onclick:()=>this.#e.select({episode:t,seed:null})},s,d("span",{class:"count"},t+1))}};var Uo=0,Do=1,Sl=2,Al=176;function zo(n,e,t,r){let s=devicePixelRatio||1,o=ln(n);n.width=n.height=Al*s;let a=n.getContext("2d");if(!a)return;let{fov:i}=e,l=n.width/
i;a.fillStyle=o.paper,a.fillRect(0,0,n.width,n.height);for(let h=0;t&&h<i*i;h++){let[u,m]=[(h%i+.5)*l,(Math.floor(h/i)+.5)*l],p=f=>!!t[f*i*i+h];p(Sl)&&(a.fillStyle=
o.obstacle,a.fillRect(u-l/2,m-l/2,l,l));let g=p(Uo)&&p(Do)?l*.18:0;p(Uo)&&Wo(a,$e,u+g,m+g,l*.74,o.evader),p(Do)&&Wo(a,on,u-g,m-g,l*.86,o.pursuer)}a.strokeStyle=
r<e.n_pursuers?o.pursuer:o.evader,a.lineWidth=2*s;let c=Math.floor(i/2)*l;a.strokeRect(c,c,l,l)}function Wo(n,e,t,r,s,o){e(n,t,r,s),n.fillStyle=o,n.fill()}var Ml=["stay","↑","→","↓","←","↗","↘","↙","↖"];function Bo(n,{inputs:e,ratings:t,refused:r},s,o){let a=n.kind==="rating"&&!n.hidden.length?n.genome:
null,i=g=>a?.[g]??1,l=g=>n.kind==="rating"?i(g)!==0:new RegExp(`\\b${n.inputs[g]}\\b`).test(o),c=[...n.inputs.keys()].filter(l).sort((g,f)=>Math.abs(i(f))-Math.
abs(i(g))),h=g=>`${g===s?"taken":""} ${r[g]?"refused":""}`,u=(g,f)=>d("tr",{class:f.every(y=>y===f[0])?"same":""},g,...Array.from(f,(y,v)=>d("td",{class:h(v)},je(
y)))),m=g=>{let f=n.inputs[g];return d("th",{scope:"row",title:`${a?`weight ${je(i(g))} x `:""}${Ee[f]}`},f.replaceAll("_"," "))},p=d("table",{class:"why number\
s"},d("thead",{},d("tr",{},d("th",{},a?"term":"input"),...Array.from(t,(g,f)=>d("th",{scope:"col",class:h(f),title:Q[f],"aria-label":Q[f]},Ml[f]))),u(d("th",{scope:"\
row"},a?"sum":"rating"),t)),d("tbody",{},...c.map(g=>u(m(g),e[g].map(f=>i(g)*f)))));return[...o?[d("p",{class:"expression"},d("code",{},o))]:[],d("div",{class:"\
wide-table",tabindex:0,role:"group","aria-label":"How the moves are rated"},p)]}var Go="What it remembers: a number for each unit, from -1 to 1",fn=class{element;#e;#n=d("canvas",{class:"seen",role:"img"});#t=d("h3");#s=d("p",{class:"small \
muted"});#a=d("div",{class:"answers"});#r=d("div",{title:Go});#l=null;#d=null;#m=null;#i=null;#h=null;#u=null;#c=0;constructor(e){this.#e=e,this.element=d("div",
{class:"inspector","data-open":"false"},d("p",{class:"hint small muted"},"Click an agent, or press A: what it sees, and why it takes its move."),d("div",{class:"\
inspected"},this.#n,d("div",{class:"answer"},this.#t,this.#s,this.#r),this.#a))}get agent(){return this.#u}show(e,t,r,s){this.#l?.free(),this.#l=e.world(r.config),
this.#m!==t&&(this.#d=null,this.#u!==null&&this.choose(null)),[this.#m,this.#i,this.#h]=[t,r,s]}set solution(e){this.#d=e,this.at(this.#c)}choose(e){this.#u=e,this.
element.dataset.open=String(e!==null),this.#e(e),this.at(this.#c)}next(e){let t=this.#i;if(!t)return;let r=this.#u??(e>0?-1:0);for(let s=0;s<t.n_agents;s++)if(r=
(r+e+t.n_agents)%t.n_agents,t.alive[this.#c*t.n_agents+r])return this.choose(r)}at(e){this.#c=e;let[t,r,s,o,a]=[this.#i,this.#l,this.#m,this.#h,this.#u];if(!t||
!r||!s||!o||a===null)return;let i=a<t.config.n_pursuers?"pursuer":"evader";this.#r.replaceChildren(),this.#t.replaceChildren(d("span",{class:i},K(a,t.config.n_pursuers)));
let l={pursuers:se(s,"pursuer",o.pursuer),evaders:se(s,"evader",o.evader)};t.seek(r,e,l);let c=t.actions.subarray(e*t.n_agents,(e+1)*t.n_agents);for(;c.length&&
!r.over&&(a<r.actors[0]||a>=r.actors[1]);)r.playTurn(c);let h=!!(t.alive[e*t.n_agents+a]&&r.read("alive")[a]);zo(this.#n,t.config,h?r.view(a):null,a),this.#n.ariaLabel=
`Field of view of ${K(a,t.config.n_pursuers)}: evaders, pursuers and obstacles around it`;let u=c[a]??null;if(!h)return this.#p([],"It is gone.");let m=l[`${i}s`],
p=typeof m!="string"&&m.kind==="cells"?r.answer(m,a):null,g=p?.probabilities??null;p?.memory.length&&this.#r.replaceChildren(d("p",{class:"small muted"},"It rem\
embers:"),Cl(p.memory));let f=typeof m!="string"&&m.kind!=="cells"?Bo(m,r.rate(m,a),u,Ws(s,i,o[i])):[],y=this.#d?.game(r)??null,v=typeof m=="string"?`The script\
 "${m}" plays for it${u===null?"":`; it goes ${Q[u]}`}.`:m.kind!=="cells"?"It takes the best move that its mask allows; of equal ones any.":m.sampled?"Its actio\
n is drawn from these probabilities.":"It takes the most probable action.",S=[["network",g],["perfect",y?.marginal(a)??null]],w=A=>d("p",{class:"small muted"},A);
this.#p([...y?[w(`Value ${y.value.toFixed(2)} under perfect play.`)]:[],...Tl(S,u),...f],u===null?"The episode is over.":v)}#p(e,t){this.#a.replaceChildren(...e),
this.#s.textContent=t}};function Tl(n,e){let t=n.filter(([,o])=>o);if(!t.length)return[];let r=d("div",{class:"action muted"},d("span"),...t.map(([o])=>d("span",
{class:"head"},o))),s=Array.from(t[0][1],(o,a)=>d("div",{class:a===e?"action taken":"action"},d("span",{},Q[a]),...t.flatMap(([,i])=>El(i[a]))));return t.length>
1||t[0][0]!==n[0][0]?[r,...s]:s}function El(n){let e=d("span",{class:"filled"});return e.style.width=`${100*n}%`,[d("span",{class:"track"},e),d("span",{class:"n\
umbers"},n.toFixed(2))]}function Cl(n){let e=Array.from(n,t=>{let r=d("span",{title:t.toFixed(2)});return r.style.transform=`scaleY(${t})`,r});return d("div",{class:"\
units",role:"img","aria-label":Go},...e)}function Ho(n){let e=JSON.stringify(n,(t,r)=>t==="genome"?Array.from(r):r);return d("script",{type:"application/json",id:"champions"},e.replaceAll("<","\\u003c")).
outerHTML}var vt="_",kl="n",Qh=2n**64n-1n;var Mr={fov:11,maxSteps:500,rewards:"paper"},Rl=["rules","others","rewards","size","diagonal","fov","limit","seed","ended","walls","pursuers","evaders","played",
"next"];function Yo(n,e){let t=i=>i.map(l=>_l(l,e)).join(""),r=i=>`${Math.floor(i/n.cols)}.${i%n.cols}`,s=Ol(n.rewards,e),o=[n.seed,n.episode,n.steps].join("."),a={rules:Vo(
n.rules,e),others:n.others?Vo(n.others,e):"",rewards:s===Mr.rewards?"":s,size:`${n.rows}x${n.cols}`,diagonal:n.diagonal?"1":"",fov:n.fov===Mr.fov?"":String(n.fov),
limit:n.maxSteps===Mr.maxSteps?"":String(n.maxSteps),seed:o==="0.0.0"?"":o,ended:n.ended?"1":"",walls:n.walls.map(r).join(vt),pursuers:n.pursuers.map(jo).join(vt),
evaders:n.evaders.map(jo).join(vt),played:n.played.map(t).join(vt),next:n.next.every(i=>i===ws)?"":t(n.next)};return Rl.filter(i=>a[i]).map(i=>`${i}=${a[i]}`).join(
"&")}function jo({cell:n,gone:e,captured:t,everCaptured:r}){let s=t?"c":r?"e":"";return`${n[0]}.${n[1]}${s}${e?"x":""}`}function Vo(n,e){let t=e.fields.map(({name:r})=>String(
n[r]).toLowerCase());return xs(n,e.variants)??t.join(".")}function Ol(n,e){let t=JSON.stringify(n);return Object.keys(e.rewards).find(s=>JSON.stringify(e.rewards[s])===
t)??Object.values(n).map(s=>String(s)).join(vt)}function _l(n,e){if(typeof n=="number")return String(n);if(n===bs)return kl;let t=e.scripts.findIndex(({name:r})=>r===
n);return String.fromCharCode(97+t)}var Pl="/* the engine */";function Ko(n,e){return d("button",{type:"button",class:"to-playground",title:"Open this step in the playground (G): the same agents a\
nd actions under any rules",onclick:()=>$l(n(),e)},"What if?")}function $l(n,e){let t=n!==null&&n.match.n_agents<=Qn&&Math.max(n.match.config.rows,n.match.config.
cols)<=Xn,r=t?Yo(Nl(n.match,n.step),e):"",s=new TextDecoder().decode(mr("playground")).replace(Pl,()=>Ae("script-engine")).replace("</noscript>",o=>t?o+Ho(n.champions):
o);window.open(`${URL.createObjectURL(new Blob([s],{type:"text/html"}))}#${r}`)}function Nl(n,e){let{config:t,n_agents:r}=n,s=Math.max(0,e-1),o=i=>{let l=s*r+i,
c=s*t.n_evaders+i-t.n_pursuers,h=u=>i>=t.n_pursuers&&!!u[c];return{cell:[n.last_positions[2*l],n.last_positions[2*l+1]],gone:!n.alive[l],captured:h(n.captured),
everCaptured:h(n.ever_captured)}},a=Array.from({length:r},(i,l)=>o(l));return{rules:t.rules,others:null,rewards:t.rewards,rows:t.rows,cols:t.cols,diagonal:t.diagonal,
fov:t.fov,maxSteps:t.max_steps,seed:n.seed,episode:BigInt(n.episode),steps:s,ended:s===n.length,walls:Array.from(n.map.keys()).filter(i=>n.map[i]),pursuers:a.slice(
0,t.n_pursuers),evaders:a.slice(t.n_pursuers),played:[],next:Array.from(n.actions.subarray(s*r,(s+1)*r))}}var Tr=.005,Zo=.05,Ll=["pursuer","evader"],Il=4,qe=new Map;function yn(n,e,t="capture-rate"){let r=JSON.stringify([{...e,rewards:null},t]),s=qe.get(r)??(Lt(e)?Promise.
resolve(null):Fl(n,e,t));return qe.delete(r),qe.set(r,s),qe.size>Il&&qe.delete([...qe.keys()][0]),s}var Jo=({n_evaders:n})=>n===1?"capture-time":"capture-rate",
qo=()=>new Promise(n=>setTimeout(n));async function Fl(n,e,t){await qo();let r=n.solution(e,t);for(;r.goBack();)await qo();return r}function gn(n,e,t){let{payoff:r}=n;
return t.flatMap((s,o)=>{let a=[0,0];for(let l=e.n_turns;l>0&&!e.over;l--)n.game(e)?.lost(s).forEach((c,h)=>a[h]+=c),e.playTurn(s);let i=r==="capture-rate"?Tr:Zo;
return Ll.map((l,c)=>({step:o+1,team:l,lost:a[c],payoff:r})).filter(l=>l.lost>=i)})}var vn=n=>n.map(e=>({step:e.step,kind:e.team,size:e.lost/Math.max(1,...n.map(
({lost:t})=>t)),text:bt(e)})),Xo=({lost:n,payoff:e})=>e==="capture-rate"?`${n.toFixed(2)} of the capture rate`:`${n.toFixed(1)} steps`,bt=n=>`The ${n.team}s los\
e ${Xo(n)} against a perfect opponent`;function Qo(n){let e=n.reduce((t,r)=>r.lost>t.lost?r:t);return`Your team's worst moves, in step ${e.step}, lost ${Xo(e)} \
against a perfect opponent.`}function ea({config:n,payoff:e},{value:t},r){if(e==="capture-rate")return`value ${t.toFixed(2)}`;let[s,o]=[1-t,Math.min(n.max_steps-
r,qn)];return s>o-Zo?`free for ${o} steps`:`captured after ${s.toFixed(1)} steps`}function ta(n,e){return(n.marginal(e)??[]).map((r,s)=>({share:r,action:s})).filter(
({share:r})=>r>=Tr).sort((r,s)=>s.share-r.share).map(({share:r,action:s})=>r>1-Tr?Q[s]:`${Q[s]} ${r.toFixed(2)}`).join(", ")}function bn(n,e,t){if(t===0)return[{kind:"start",text:Ul(n),agents:[]}];let[r,s]=[e.moments[t-1],e.moments[t]],o=h=>K(h,n.config.n_pursuers),a=pt(e,r,s),i=n.conflicts(
t),l=new Set(i.flatMap(h=>h.doomed)),c=a.map(h=>({kind:"capture",text:`${o(h)} is captured`,agents:[h]}));for(let h of rn(r,s))!a.includes(h)&&!l.has(h)&&c.push(
{kind:"end",text:`${o(h)} disappears`,agents:[h]});return c.push(...i.map(({kind:h,text:u,agents:m})=>({kind:h,text:u,agents:m}))),t===n.length&&c.unshift({kind:"\
end",text:Dl(n),agents:[]}),c}function Ul({config:n}){return`${n.n_pursuers} pursuers and ${n.n_evaders} evaders on ${n.rows} x ${n.cols} cells, at most ${n.max_steps}\
 steps`}function Dl(n){let e=Math.round(n.statistics.capture_rate*n.config.n_evaders);return`The episode ends after ${n.length} steps with ${e} of ${n.config.n_evaders}\
 evaders captured`}var Wl=60,wn=class{element;player=new Te(0,{speed:un,still:ye()});inspector;match=null;recording=null;actions;#e;#n;#t;#s;#a=d("h2",{class:"match-title"});#r=d(
"p",{class:"tally numbers"});#l=d("ol",{class:"words",tabindex:0,"aria-live":"off","aria-label":"What happened in this step"});#d=d("p",{class:"problem",role:"a\
lert"});#m=d("div",{class:"shown","aria-live":"polite"});#i=null;#h=null;#u=0;#c=!1;#p=0;#o=[];constructor(e,t,r){[this.#n,this.#t]=[e,t];let s=d("canvas",{"ari\
a-label":"The match",onclick:({clientX:o,clientY:a})=>this.inspector.choose(this.#e.agentAt(o,a))});this.#e=new Me(s,{numbers:!1}),this.#s=new pn(t),this.inspector=
new fn(o=>this.#E(o)),this.actions=d("div",{class:"beside"},d("button",{type:"button",class:"to-play",title:"Move the chosen agent, or an evader, yourself from \
this step on (T)",onclick:()=>this.element.dispatchEvent(new Event("takeover"))},"Take over"),r&&Ko(()=>this.shown,r)),this.element=d("section",{class:"card mat\
ch-card","aria-label":"Match",id:"match"},d("div",{class:"match"},d("header",{class:"match-head"},this.#a,this.#r),this.#d,this.#m,d("div",{class:"stage"},s),d(
"div",{class:"aside"},this.#l,Dt(),this.actions,this.inspector.element),mn(this.player),this.#s.element)),this.player.addEventListener("frame",()=>this.recording&&
this.#e.show(this.recording,this.player.time)),this.player.addEventListener("step",()=>this.#A()),t.on("match",()=>this.#g()),this.#w(),this.#S(0,0)}get#y(){return this.#n[this.#t.
selected.run]}reveal(){(this.#y.game?this.#m:this.#e.canvas).scrollIntoView({block:"nearest"})}get shown(){return this.match&&this.#h&&{match:this.match,step:this.
player.step,champions:this.#h}}start(e){this.#i=e,this.#b()}playSoon(){this.#c=!0,this.#u||this.#f()}goTo(e){this.#p=e,!this.#u&&this.match&&this.#b()}#f(){!this.#c||
!this.match||(this.#c=!1,this.player.jump(0),ye()||this.player.play())}#g(){this.#w(),clearTimeout(this.#u),this.#u=setTimeout(()=>this.#b(),Wl)}#b(){clearTimeout(
this.#u),this.#u=0,this.player.pause(),this.#w();let{selected:e}=this.#t,{game:t}=this.#y;if(this.#m.replaceChildren(...t?Us(this.#y,t,e,this.#t):[]),t){this.match=
this.recording=null,this.#c=!1,this.#v(e);return}let r=Oe.map(a=>jt(this.#y,a,e[a])).find(Boolean)??"";if(this.#d.textContent=r,r||!this.#i)return;this.match=zs(
this.#i,this.#y,e);let[s,o]=this.names(e);this.#h={pursuer:{name:s,policy:se(this.#y,"pursuer",e.pursuer)},evader:{name:o,policy:se(this.#y,"evader",e.evader)}},
this.recording=cn(this.match),this.#s.show(this.#y,this.match),this.inspector.show(this.#i,this.#y,this.match,e),this.player.length=this.match.length,this.player.
marks=nn(this.recording),this.#o=this.player.ticks=[],this.player.jump(this.#p),this.#p=0,this.#A(),this.#x(this.#i,this.match),this.#v(e),this.#f()}#v({run:e,pursuer:t,
evader:r,episode:s,seed:o}){this.element.dataset.played=`${e} ${t} ${r} ${s} ${o??""}`}async#x(e,t){let r=await yn(e,t.config);if(this.match!==t||!r)return;let s=e.
world(t.config);t.seek(s,0),this.#o=gn(r,s,zl(t)),s.free(),this.player.ticks=vn(this.#o),this.inspector.solution=r,this.#A()}names({run:e,pursuer:t,evader:r}){let s=this.#n[e],
{teams:o}=s;return[o.pursuer.script??te(s,"pursuer",t),o.evader.script??te(s,"evader",r)]}#w(){let{episode:e,seed:t}=this.#t.selected,{game:r,payoff:s}=this.#y;
this.element.classList.toggle("of-own-game",!!r),this.element.classList.toggle("of-ratings",Oe.some(l=>Ds(this.#y,l)));let[o,a]=this.names(this.#t.selected),i=t===
null?e<s.episodes?`episode ${e+1} of ${s.episodes}`:`episode ${e+1}, not part of the cell`:`seed ${t}`;this.#a.replaceChildren(d("span",{class:"pursuer"},Ht(o)),
" against ",d("span",{class:"evader"},a),r?"":d("span",{class:"muted small"},i))}#A(){let e=this.match;if(!e||!this.recording)return;let t=this.player.step,r=this.
recording.moments[t];this.#S(Array.from(r.everCaptured).filter(Boolean).length,t),this.#l.replaceChildren(...this.#o.filter(s=>s.step===t).map(s=>d("li",{class:`\
loss-${s.team}`},bt(s))),...bn(e,this.recording,t).map(s=>d("li",{class:s.kind,"data-agents":s.agents.join(" ")},s.text))),this.inspector.at(t),this.#M()}#S(e,t){
let{world:r}=this.#y;r&&this.#r.replaceChildren(d("strong",{},e),` of ${r.n_evaders} captured`,d("span",{class:"muted"},` · step ${t}`))}#E(e){this.#e.look={selected:e,
viewers:e===null?[]:[e]},this.#M()}#M(){let e=this.inspector.agent;for(let t of this.#l.children){let r=t.dataset.agents?.split(" ")??[];t.classList.toggle("abo\
ut",e!==null&&r.includes(String(e)))}}},zl=({actions:n,length:e,n_agents:t})=>Array.from({length:e},(r,s)=>n.subarray(s*t,(s+1)*t));var Bl={ArrowUp:[1,0],ArrowDown:[-1,0],ArrowRight:[0,1],ArrowLeft:[0,-1]},Gl=5;function ra(n,e,t,r="pursuer"){n.tabIndex=0,n.setAttribute("role","application"),
n.addEventListener("keydown",s=>{let o=Bl[s.key];if(!o)return;let[a,i]=r==="pursuer"?o:[o[1],o[0]],[l,c]=t(),h=s.shiftKey?Gl:1,{pursuer:u,evader:m}=e.selected;e.
select({pursuer:na(u+h*a,l),evader:na(m+h*i,c)}),s.preventDefault(),s.stopPropagation()})}var na=(n,e)=>Math.min(e-1,Math.max(0,n));var wt=[[68,1,84],[72,26,108],[71,47,125],[65,68,135],[57,86,140],[49,104,142],[42,120,142],[35,136,142],[31,152,139],[34,168,132],[53,183,121],[84,197,104],[122,
209,81],[165,219,54],[210,226,27],[253,231,37]];function xn(n){let e=Math.min(1,Math.max(0,n))*(wt.length-1),t=Math.min(wt.length-2,Math.floor(e)),[r,s]=[wt[t],
wt[t+1]],o=a=>Math.round(r[a]+(e-t)*(s[a]-r[a]));return[o(0),o(1),o(2)]}function sa(n){let[e,t,r]=xn(n).map(s=>((s/255+.055)/1.055)**2.4);return .2126*e+.7152*t+
.0722*r>.179?"#000":"#fff"}var oa=n=>`rgb(${xn(n).join(" ")})`,aa=()=>`linear-gradient(to right, ${wt.map(n=>`rgb(${n.join(" ")})`).join(", ")})`;function ia(n,e,t){let r=devicePixelRatio||1;for(let[a,i]of Object.entries(t))n.style.setProperty(a,`${i}px`);n.width=Math.round(t.width*r),n.height=Math.round(
t.height*r);let s=n.getContext("2d"),o=Hl(e);!s||!o||(s.imageSmoothingEnabled=!1,s.drawImage(o,0,0,n.width,n.height))}function Hl(n){let[e,t]=n.shape,r=document.
createElement("canvas");[r.width,r.height]=[t,e];let s=r.getContext("2d");if(!s)return null;let o=s.createImageData(t,e);return n.capture_rate.forEach((a,i)=>a.
forEach((l,c)=>{let h=4*((e-1-i-n.first[0])*t+c+n.first[1]);o.data.set([...xn(l),255],h)})),s.putImageData(o,0,0),r}function la(n,e,t,r=2){n.textContent=G(e,r),
n.ariaLabel=`${t}: ${n.textContent}`,e!==void 0&&([n.style.backgroundColor,n.style.color]=[oa(e),sa(e)])}function Er(n,e){let t=d("span",{class:"gradient"});return t.
style.backgroundImage=aa(),d("p",{class:"scale-of-rates small muted"},n,t,e)}var jl=24,Sn=7,ua=n=>n<jl&&matchMedia("(pointer: coarse)").matches;function ha(n,e,t,r){let[s,o]=n.payoff.shape,[a,i]=[ca(e,s),ca(t,o)],[l,c]=[Math.min(Sn,s),Math.
min(Sn,o)],h=[];for(let f=a+l-1;f>=a;f--){h.push(d("span",{class:"pursuer"},f));for(let y=i;y<i+c;y++)h.push(Vl(n,f,y,r))}let u=Array.from({length:c},(f,y)=>d("\
span",{class:"evader"},i+y)),m=d("button",{type:"button","aria-label":"Close: all cells",onclick:()=>r(null)},"✕"),g=d("div",{class:"loupe numbers",role:"grou\
p","aria-label":"Cells around the tap",onclick:f=>f.stopPropagation()},...h,m,...u);return g.style.gridTemplateColumns=`2.4rem repeat(${c}, minmax(0, 1fr))`,g}function Vl(n,e,t,r){
let s=d("button",{type:"button",onclick:()=>r({pursuer:e,evader:t})});return la(s,Se(n,e,t)?.rate,`${te(n,"pursuer",e)} against ${te(n,"evader",t)}`),s}var ca=(n,e)=>Math.
max(0,Math.min(e-Sn,n-Math.floor(Sn/2)));var oe={left:52,bottom:46,top:76,right:84},he=10,Yl=160,xt=oe.right-he-14,Ne=oe.top-he-14,An=class{element;#e;#n;#t=d("canvas",{"aria-hidden":"true"});#s=b("svg",
{"aria-hidden":"true"});#a=b("g");#r;#l=d("h2");#d=d("strong",{class:"rate numbers"});#m=d("span",{class:"small muted"});#i=d("p",{class:"of-both-teams small mu\
ted numbers"});#h;#u=null;constructor(e,t){[this.#n,this.#e]=[e,t],this.#r=d("div",{class:"matrix",id:"matrix","aria-label":"Payoff matrix. Arrow keys choose a \
match, Enter plays it.",onpointermove:s=>this.#x(s),onpointerleave:()=>t.point({}),onclick:s=>this.#w(s),onkeydown:({key:s})=>s==="Enter"&&this.#S()},this.#t,this.#s);
let r=d("header",{class:"readout","aria-live":"polite"},d("div",{},this.#l,this.#i),d("div",{class:"of-cell"},this.#d,this.#m));this.#h=Er(...xe(this.#c).ends),
this.element=d("section",{class:"card matrix-card","aria-label":"Payoff matrix"},r,this.#r,this.#h),this.#g(),new ResizeObserver(()=>this.#p()).observe(this.#r),
this.#r.addEventListener("mousedown",s=>{s.preventDefault(),document.activeElement instanceof HTMLElement&&document.activeElement.blur()}),ra(this.#r,t,()=>this.#c.
payoff.shape),t.on("run",()=>{let s=Er(...xe(this.#c).ends);this.#h.replaceWith(s),this.#h=s,this.#p()}),t.on("match hover",()=>this.#f())}get#c(){return this.#n[this.#e.
selected.run]}#p(){let[e,t]=this.#c.payoff.shape,{clientWidth:r,clientHeight:s}=this.#r;if(r<50)return;let a=Math.max(Yl,Math.min(r-oe.left-oe.right,s-oe.top-oe.
bottom))/Math.max(e,t),i=Math.max(oe.left,(r-t*a-oe.right+oe.left)/2),l=oe.top+Math.max(0,(s-oe.top-oe.bottom-e*a)/2),c={width:r,height:s,left:i,top:l,cell:a,rows:e,
columns:t};this.#u=c,ia(this.#t,this.#c.payoff,{left:i,top:l,width:t*a,height:e*a});for(let[h,u,m]of[["left",i,r],["top",l,s],["width",t*a,r],["height",e*a,s]])
this.#t.style.setProperty(h,`${100*u/m}%`);this.#r.style.setProperty("--shape",`${r} / ${s}`),this.#s.setAttribute("viewBox",`0 0 ${r} ${s}`),this.#s.replaceChildren(
Kl(c,xe(this.#c).generation),...ql(c),...this.#y(c),this.#a),this.#f()}#o(e){let t=this.#c.findings?.generalization;if(!t)return[];let{selected:r,hover:s}=this.#e,
[o,a]=[s.pursuer??r.pursuer,s.evader??r.evader],[i,l]=da(e,t.pursuers.mean[o]??0,o),[c,h]=ma(e,t.evaders.mean[a]??0,a);return[b("circle",{class:"dot of-pursuers",
cx:i,cy:l,r:5}),b("circle",{class:"dot of-evaders",cx:c,cy:h,r:5})]}#y(e){let t=this.#c.findings?.generalization;if(!t)return[];let{left:r,top:s,cell:o,rows:a,columns:i}=e,
{curves:l}=xe(this.#c),[c,h]=[r+i*o+he,s-he],u={class:"side"};return[b("rect",{...u,x:c,y:s,width:xt,height:a*o}),b("rect",{...u,x:r,y:h-Ne,width:i*o,height:Ne}),
...pa(t.pursuers,(m,p)=>da(e,m,p),"of-pursuers"),...pa(t.evaders,(m,p)=>ma(e,m,p),"of-evaders"),b("text",{class:"tick",x:c,y:s+a*o+16,"text-anchor":"start"},"0"),
b("text",{class:"tick",x:c+xt,y:s+a*o+16,"text-anchor":"end"},"1"),b("text",{class:"tick",x:r-6,y:h-4,"text-anchor":"end"},"0"),b("text",{class:"tick",x:r-6,y:h-
Ne+8,"text-anchor":"end"},"1"),b("text",{class:"label of-pursuers",x:c+xt,y:s+a*o+34,"text-anchor":"end"},l.pursuer),b("text",{class:"label of-evaders",x:r+i*o+
he,y:h-Ne+10,"text-anchor":"start"},l.evader)]}#f(){let e=this.#u;if(!e)return;let{selected:t,hover:r}=this.#e,{left:s,top:o,cell:a,rows:i,columns:l}=e,c=g=>o+(i-
1-g)*a,h=[],u=(g,f)=>b("rect",{class:f,x:s,y:c(g),width:l*a+he+xt,height:a}),m=(g,f)=>b("rect",{class:f,x:s+g*a,y:o-he-Ne,width:a,height:he+Ne+i*a});h.push(u(t.
pursuer,"strip pursuer"),m(t.evader,"strip evader")),r.pursuer!==null&&r.pursuer<i&&h.push(u(r.pursuer,"strip hover")),r.evader!==null&&r.evader<l&&h.push(m(r.evader,
"strip hover")),h.push(...this.#o(e));let p={x:s+t.evader*a,y:c(t.pursuer),width:a,height:a};h.push(b("rect",{class:"chosen under",...p}),b("rect",{class:"chose\
n",...p})),this.#a.replaceChildren(...h),this.#g()}#g(){let{selected:e,hover:t}=this.#e,r=t.pursuer??e.pursuer,s=t.evader??e.evader,o=Se(this.#c,r,s);this.#l.replaceChildren(
d("span",{class:"pursuer"},Ht(te(this.#c,"pursuer",r)))," against ",d("span",{class:"evader"},te(this.#c,"evader",s))),this.#d.textContent=o?G(o.rate,3):"-";let a=o&&
o.rates.length>1?`, mean of ${o.rates.length} episodes`:"";this.#m.textContent=o?xe(this.#c).score+a:"no episodes were played",this.#i.textContent=this.#b(r,s)}#b(e,t){
let r=this.#c.findings?.generalization;if(!r)return"";let s=(a,i)=>Fs(a.mean[i]??null,a.low?.[i]??null,a.high?.[i]??null),{means:o}=xe(this.#c);return`Against a\
ll: ${o.pursuer} ${s(r.pursuers,e)}, ${o.evader} ${s(r.evaders,t)}`}#v(e){let t=this.#u;if(!t)return null;let r=this.#r.getBoundingClientRect(),s=Math.floor((e.
clientX-r.left-t.left)/t.cell),o=t.rows-1-Math.floor((e.clientY-r.top-t.top)/t.cell),[a,i]=[o>=0&&o<t.rows,s>=0&&s<t.columns];return a||i?{g:a?o:-1,h:i?s:-1,inside:a&&
i}:null}#x(e){let t=this.#v(e);this.#e.point(t?{pursuer:t.g<0?null:t.g,evader:t.h<0?null:t.h}:{})}#w(e){let t=this.#v(e);if(t){if(t.inside&&ua(this.#u.cell))return this.#A(
t.g,t.h);this.#e.select({...t.g<0?{}:{pursuer:t.g},...t.h<0?{}:{evader:t.h}}),t.inside&&this.#S()}}#A(e,t){let r=ha(this.#c,e,t,s=>{r.remove(),s&&(this.#e.select(
s),this.#S())});this.#r.append(r)}#S(){this.#r.dispatchEvent(new CustomEvent("play",{bubbles:!0}))}};function Kl({left:n,top:e,cell:t,rows:r,columns:s},o){let a=b(
"g",{class:"axes"}),i=e+r*t,l=c=>dt(0,c-1,Math.min(c,c*t/44),!0);for(let c of l(s))a.append(b("text",{class:"tick",x:n+(c+.5)*t,y:i+16,"text-anchor":"middle"},c));
for(let c of l(r))a.append(b("text",{class:"tick",x:n-7,y:i-(c+.5)*t,"text-anchor":"end","dominant-baseline":"middle"},c));return a.append(b("text",{class:"labe\
l of-evaders",x:n+s*t/2,y:i+36,"text-anchor":"middle"},o.evader),b("text",{class:"label of-pursuers",transform:`translate(${n-36} ${e+r*t/2}) rotate(-90)`,"text\
-anchor":"middle"},o.pursuer)),a}function ql({left:n,top:e,cell:t,rows:r,columns:s}){let o=b("g",{class:"diagonal"}),a=Math.min(r,s);if(a<3)return[];let i=e+r*t;
for(let h of["H","V"]){let u=`M${n} ${i}`;for(let m=1;m<=a;m++){let[p,g]=[`H${n+m*t}`,`V${i-m*t}`];u+=h==="H"?p+g:g+p}o.append(b("path",{d:u,class:"under"}),b("\
path",{d:u}))}let[l,c]=[n+a/2*t-.7*t-4,i-a/2*t-.7*t-4];return[o,b("text",{class:"on-cells",transform:`translate(${l} ${c}) rotate(-45)`,"text-anchor":"middle"},
"same generation")]}var da=({left:n,top:e,cell:t,rows:r,columns:s},o,a)=>[n+s*t+he+o*xt,e+(r-a-.5)*t],ma=({left:n,top:e,cell:t},r,s)=>[n+(s+.5)*t,e-he-r*Ne];function pa(n,e,t){
let r=o=>o.map((a,i)=>e(a??0,i).map(l=>l.toFixed(1)).join(" ")),s=[];return n.low&&n.high&&s.push(b("path",{class:`band ${t}`,d:`M${[...r(n.high),...r(n.low).reverse()].
join("L")}Z`})),s.push(b("path",{class:`line ${t}`,d:`M${r(n.mean).join("L")}`})),s}var fa={pursuer:null,evader:null},Mn=class extends EventTarget{#e;#n=fa;constructor(e){super(),this.#e=e}get selected(){return this.#e}get hover(){return this.#n}select(e){
let t=this.#e,r=["run","pursuer","evader"].some(s=>s in e&&e[s]!==t[s]);this.#e={...t,...r?{episode:0,seed:null}:{},...e},this.#e.run!==t.run&&this.dispatchEvent(
new Event("run")),this.dispatchEvent(new Event("match"))}point(e){let t={...fa,...e};t.pursuer===this.#n.pursuer&&t.evader===this.#n.evader||(this.#n=t,this.dispatchEvent(
new Event("hover")))}on(e,t){for(let r of e.split(" "))this.addEventListener(r,t)}};var Tn=class{config;start;recording;actions=[];#e;#n;#t=[[]];constructor(e,t,r){[this.config,this.start]=[t,r],this.#e=e.world(t),this.#e.reset(r),this.#n=[Ar(this.#e)],
this.recording=Sr(t,this.#e.map(),this.#n)}get length(){return this.actions.length}get over(){return this.#e.over}get statistics(){return{capture_rate:this.#e.read(
"capture_rate")[0]}}conflicts(e){return this.#t[e]}game(e){return e.game(this.#e)}play(e){this.#e.step(e),this.#s(e)}step(e,t,r){let[s,o]=[this.#e,this.config.n_pursuers],
a=new Uint8Array(s.n_agents);for(let i=s.n_turns;i>0&&!s.over;--i){let[l,c]=s.actors;l<o&&(a=s.decide(e.pursuer,[l,Math.min(c,o)],a)),c>o&&(a=s.decide(e.evader,
[Math.max(l,o),c],a)),typeof r=="number"?a[t]=r:l<=t&&t<c&&(a=s.decide(r,[t,t+1],a)),s.playTurn(a)}this.#s(a)}#s(e){this.actions.push(e),this.#n.push(Ar(this.#e,
e)),this.#t.push(this.#e.conflicts())}};var de=(n,e)=>Oe[+(e>=n.n_pursuers)];function Cr(n,e){let t=new Tn(n,e.config,{seed:e.seed,episode:e.episode});for(let r of e.moves)t.over||t.step(e.policies,e.
seat,r);return t}function Ze(n,e){let{moments:t,nPursuers:r}=n.recording,s=t.findIndex(({alive:a,captured:i})=>!a[e]||!!i[e-r]),o=s<0?n.length:s;return{lasted:o,
out:s>=0,captured:Array.from(t[o].everCaptured).filter(Boolean).length}}var En=(n,e)=>n.over||Ze(n,e).out;function ya(n,e,t){let r=Cr(n,{...e,moves:e.moves.slice(
0,e.from)});for(;!En(r,e.seat);)r.step(e.policies,e.seat,t);return Ze(r,e.seat)}function ga(n){let e=n.length-1;return[...new Set([0,Math.round(e/3),e])].map(t=>n[t])}
function va(n,{seat:e,from:t,moves:r}){let s={...n,seat:e,...t?{from:t}:{},moves:r.join("")};return`${location.href.split("#")[0]}#${Object.entries(s).map(([o,a])=>`${o}\
=${a}`).join("&")}`}function ba(n,e){let[t,r,s]=[n.get("seat")??"",n.get("from")??"0",n.get("moves")??""];return/^\d{1,6}$/.test(t)&&Number(t)<e.n_pursuers+e.n_evaders&&
(e.diagonal?/^[0-8]+$/:/^[0-4]+$/).test(s)&&s.length<=e.max_steps&&/^\d{1,6}$/.test(r)&&Number(r)<=s.length?{seat:Number(t),from:Number(r),moves:[...s].map(Number)}:
null}function kr(n,e,t,r,s,o){e.play({title:t,played:r,ending:(a,i)=>[Zl(n,a,i,ga(s))],again:()=>kr(n,e,t,{...r,moves:r.moves.slice(0,r.from)},s,o),link:a=>o&&va(o,a)})}
function Zl(n,e,t,r){let s=de(t.config,t.seat)==="evader",o=s?t.config.max_steps:t.config.n_evaders,a=d("table",{class:"numbers"},d("caption",{},s?"Steps in you\
r seat: same start, same others":"Captures of your team: same start, same others")),i=c=>{let[h,u]=[d("span",{class:s?"bar evader":"bar pursuer"}),d("td",{},"…")];
return a.append(d("tr",{},d("th",{scope:"row"},c),d("td",{class:"track","aria-hidden":"true"},h),u)),({lasted:m,captured:p})=>{h.style.width=`${100*(s?m:p)/o}%`,
u.textContent=String(s?m:p)}};i("You")(Ze(e,t.seat));for(let{name:c,policy:h}of r){let u=i(c);setTimeout(()=>u(ya(n,t,h())))}let l=t.from?`You took over at step\
 ${t.from}. `:"";return d("div",{},a,d("p",{class:"small muted"},`${l}One match: luck has its part in it.`))}var wa=["·","↑","→","↓","←","↗","↘","↙","↖"];var Jl={" ":0,ArrowUp:1,w:1,ArrowRight:2,d:2,ArrowDown:3,s:3,ArrowLeft:4,a:4,e:5,c:6,y:7,z:7,q:8},Rr=[8,1,5,4,0,2,7,3,6],Xl=[7,8,9,4,5,6,1,2,3],Ql=24,ec=Math.tan(
Math.PI/8);function Sa(n,e){if(n.ctrlKey||n.metaKey||n.altKey)return;let t=Xl.findIndex(s=>n.code===`Numpad${s}`),r=Rr[t]??Jl[n.key.length===1?n.key.toLowerCase():
n.key];return r!==void 0&&r>4&&!e?void 0:r}function Aa(n){let e=Rr.map(t=>d("button",{type:"button","aria-label":Q[t],onclick:()=>n(t)},wa[t]));return{element:d(
"div",{class:"play-pad",role:"group","aria-label":"Your move"},...e),show:t=>e.forEach((r,s)=>r.classList.toggle("absent",Rr[s]>4&&!t))}}function xa(n,e,t){let r=ec*
Math.max(Math.abs(n),Math.abs(e)),s=o=>Math.abs(o)<r?0:o;return eo([0,0],t?[s(n),s(e)]:[n,e],t)}function Ma(n,e,t){let r=null,{canvas:s}=n;s.addEventListener("p\
ointerdown",({button:o,clientX:a,clientY:i})=>r=o===0?[a,i]:null),s.addEventListener("pointercancel",()=>r=null),s.addEventListener("pointerup",({clientX:o,clientY:a})=>{
let[i,l]=[r,e()];if(r=null,!i||!l)return;let[c,h]=[o-i[0],a-i[1]],u=n.cellAt(o,a);Math.hypot(c,h)>=Ql?t(xa(h,c,l.diagonal)):u&&t(xa(u[0]-l.cell[0],u[1]-l.cell[1],
l.diagonal))})}function Ta(n,e){let t=r=>{let s=e[r]-n[r],o=Ve.findIndex(a=>a[r]===Math.sign(s)&&a[1-r]===0);return s?`${Math.abs(s)} ${Q[o]}`:""};return[t(0),t(
1)].filter(Boolean).join(", ")||"on your cell"}var ka="NUMPY\0",Ea=ka.length+2,Ca=64;function St(n){return Gt(Object.fromEntries(Object.entries(n).map(([e,t])=>[`${e}.npy`,tc(t)])))}function tc({dtype:n,shape:e,
data:t}){let r=typeof t=="string"?Array.from(t,h=>h.codePointAt(0)):null,s=e.map(h=>`${h}, `).join(""),o=`{'descr': '${r?`<U${r.length}`:n}', 'fortran_order': F\
alse, 'shape': (${s}), }`,a=Math.ceil((Ea+o.length+1)/Ca)*Ca-Ea,i=ka+String.fromCharCode(a&255,a>>8)+o.padEnd(a-1)+`
`,l=r?Int32Array.from(r):t,c=new Uint8Array(i.length+l.byteLength);return c.set(Re(i,!0)),c.set(new Uint8Array(l.buffer,l.byteOffset,l.byteLength),i.length),c}var nc="matrixworld episode 3";function Ra(n,e,t){let{config:r,actions:s,length:o,recording:a}=e,[i,l]=[r.n_pursuers+r.n_evaders,r.n_evaders],c={positions:["<i4",
i,2],last_positions:["<i4",i,2],alive:["|b1",i],captured:["|b1",l],ever_captured:["|b1",l]},h={rewards:["<f4",i],involved:["|b1",i,3],fault:["|b1",i,3]},u={},m=w=>{
for(let A of Object.keys(w))(u[A]??=[]).push(Array.from(p.read(A),Number))},p=n.world(r);p.reset(e.start);let g=[];m(c);for(let w of s)p.step(w),m({...c,...h}),
g.push(...p.conflictTable());p.free();let f={"<i4":Int32Array,"<f4":Float32Array,"|b1":Uint8Array},y={};for(let[w,[A,...O]]of Object.entries({...c,...h})){let I=o+
+(w in c);y[w]={dtype:A,shape:[I,...O],data:f[A].from((u[w]??[]).flat())}}let v=w=>({dtype:"<i8",shape:[],data:Int32Array.of(w,0)}),S=w=>({dtype:"<U",shape:[],data:w});
return St({format:S(nc),n_pursuers:v(r.n_pursuers),config:S(JSON.stringify(r)),seat:v(t),...y,actions:{dtype:"|i1",shape:[o,i],data:Int8Array.from(s.flatMap(w=>[
...w]))},map:{dtype:"|b1",shape:[r.rows,r.cols],data:Uint8Array.from(a.obstacles,Number)},conflict_table:{dtype:"<i4",shape:[g.length/11,11],data:Int32Array.from(
g)}})}var rc=[0,1,2,4,8],Cn=class{element;player=new Te(0,{speed:4,still:ye()});#e;#n;#t=d("canvas",{tabindex:0,"aria-describedby":"play-keys"});#s=d("h2");#a=d("p",{
class:"play-told",role:"status"});#r=Aa(e=>this.act(e));#l=re(rc.map(e=>[e,e?`${e} / s`:"step by step"]),()=>this.#C());#d=d("input",{type:"checkbox",onchange:()=>this.#A()});#m=d(
"input",{type:"checkbox",onchange:()=>this.#k()});#i=d("label",{class:"play-choice"},this.#m,"Best move");#h=d("p",{class:"small muted play-keys",id:"play-keys"});#u=d(
"section",{class:"play-ending",tabindex:-1,"aria-labelledby":"play-headline"});#c=mn(this.player);#p=null;#o=null;#y=[];#f=null;#g=null;#b=[];#v=0;#x=0;constructor(e){
this.#e=e,this.#n=new Me(this.#t,{numbers:!1}),this.#t.setAttribute("role","application"),Ma(this.#n,()=>{let t=this.#f!==null&&this.#o&&k(this.#o.recording.moments.
at(-1),this.#f);return t?{cell:t,diagonal:this.#o.config.diagonal}:null},t=>this.act(t)),this.player.addEventListener("frame",()=>this.#o&&this.#n.show(this.#o.
recording,this.player.time)),this.player.addEventListener("step",()=>this.#k()),this.element=d("div",{class:"play"},d("header",{class:"play-head"},this.#s,this.#a),
d("div",{class:"play-stage"},this.#t),d("div",{class:"play-side"},this.#u,this.#r.element,d("label",{class:"play-choice",title:"Steps a second"},"Pace ",this.#l),
d("label",{class:"play-choice"},this.#d,d("span",{},"Fog",d("span",{class:"at-length"},": see only what it sees"))),this.#i,this.#h),this.#c)}get played(){return this.#p&&
{...this.#p.played,moves:this.#y}}get live(){return this.#o}play(e){this.#w(Cr(this.#e,e.played),e.played.seat,e.title),[this.#p,this.#y,this.#v]=[e,[...e.played.
moves],0],this.element.dataset.state="playing",this.#t.focus({preventScroll:!0}),En(this.#o,e.played.seat)&&this.#O()}watch(e,t,r){this.#p=null,this.#w(e,t,r),this.#_()}stop(){
this.#C(),this.player.pause(),this.#p=null}act(e){let[t,r]=[this.#p,this.#o];if(!t||!r||this.element.dataset.state!=="playing")return;this.#v=e;let s=Number(this.#l.
value);this.#x||(this.#R(),s&&this.element.dataset.state==="playing"&&(this.#x=setInterval(()=>this.#R(),1e3/s)))}key(e){let{target:t,key:r}=e;if(t instanceof HTMLSelectElement||
t instanceof HTMLInputElement&&(t.type==="text"||r===" ")||t instanceof HTMLButtonElement&&(r===" "||r==="Enter")||!this.#o)return!1;if(this.element.dataset.state!==
"playing")return dn(this.player,e);let o=Sa(e,this.#o.config.diagonal);return o!==void 0&&this.act(o),o!==void 0}#w(e,t,r){this.#C(),this.player.pause(),[this.#o,
this.#f]=[e,t],this.#s.textContent=r,this.#t.ariaLabel=`Board, ${e.config.rows} by ${e.config.cols} cells`,this.#r.show(e.config.diagonal),this.#h.replaceChildren(
d("span",{class:"at-length"},`W A S D or the arrow keys move, Space stays${e.config.diagonal?"; Q E Z C and the numeric keypad move diagonally":""}. `),"On the \
board: swipe, or tap where to go."),this.#S(e),this.#u.replaceChildren(),this.player.length=e.length,this.player.jump(e.length),this.#k()}#A(){this.#n.look={you:this.#f,
fog:this.#d.checked,viewers:this.#f===null?[]:[this.#f],plan:this.#T()}}#S(e){this.#g=null,this.#b=this.player.ticks=[],this.#i.hidden=this.#m.disabled=!!Lt(e.config),
yn(this.#e,e.config,Jo(e.config)).then(t=>{this.#o===e&&(this.#g=t,this.#E(),this.#k())})}#E(){let[e,t]=[this.#o,this.#g];if(!t||this.element.dataset.state==="p\
laying")return;let r=this.#e.world(e.config);r.reset(e.start),this.#b=gn(t,r,e.actions),r.free(),this.player.ticks=vn(this.#b)}get#M(){return this.#m.checked&&this.#p&&
this.element.dataset.state==="playing"&&this.#g&&this.#o.game(this.#g)||null}#T(){let[e,t]=[this.#f,this.#f!==null&&this.#M?.marginal(this.#f)];return e!==null&&
t?Object.assign(Array(e).fill(0),{[e]:t.indexOf(Math.max(...t))}):null}#C(){clearInterval(this.#x),this.#x=0,this.#a.ariaLive=Number(this.#l.value)?"off":"polit\
e"}#R(){let[{policies:e,seat:t},r]=[this.#p.played,this.#o];r.step(e,t,this.#v),this.#y.push(this.#v),this.player.length=r.length,this.player.glide=Math.min(.22,
.9/(Number(this.#l.value)||4)),this.player.move(r.length-this.player.step),En(r,t)&&this.#O()}#O(){this.#C();let[e,t,r]=[this.#p,this.#o,this.played],s=Ft()?e.link(
r):null,o=`${K(r.seat,t.config.n_pursuers)}-${t.length}-steps.npz`,a=()=>Ut(o,Ra(this.#e,t,r.seat));this.#u.replaceChildren(d("h3",{id:"play-headline"},ac(t,r.seat)),
...e.ending(t,r),d("div",{class:"play-buttons"},d("button",{type:"button",class:"primary",onclick:()=>e.again()},"Again"),d("button",{type:"button",onclick:()=>this.#_()},
"Watch it"),d("button",{type:"button",onclick:a},"Save"),s&&d("button",{type:"button",onclick:({currentTarget:l})=>lc(l,s)},"Link"))),this.element.dataset.state=
"ended",this.#E();let i=this.#b.filter(({team:l})=>l===de(t.config,r.seat));i.length&&this.#u.children[0].after(d("p",{class:"small muted"},Qo(i))),this.#u.focus(
{preventScroll:!0}),this.#u.scrollIntoView({block:"nearest"})}#_(){this.element.dataset.state="watched",this.player.length=this.#o.length,this.player.jump(0),ye()||
this.player.play()}#k(){let[e,t,{step:r}]=[this.#o,this.#f,this.player];if(!e||r>e.length)return;let s=bn(e,e.recording,r).filter(({agents:l})=>t===null||l.includes(
t)),o=this.#p&&r===0,a=o?[sc(e.config,t),this.#p.about??""]:[`Step ${r} of ${e.config.max_steps}`,...s.map(({text:l})=>l)];!o&&t!==null&&a.push(oc(e,r,t)),a.push(
...this.#b.filter(l=>l.step===r).map(bt));let i=r===e.length&&t!==null?this.#M:null;i&&a.push(`Perfect play: ${ta(i,t)||"decided in its turn"}; ${ea(this.#g,i,r)}`),
this.#A(),this.#a.textContent=a.filter(Boolean).map(l=>`${l}.`).join(" ")}};function sc(n,e){let t=n.rules.capture==="SURROUND";return de(n,e)==="evader"?`Run a\
way: you win if ${t?"the pursuers do not surround you":"no pursuer reaches your cell"} in ${n.max_steps} steps`:`Capture evaders: ${t?"surround them with your t\
eam":"move onto their cells"}`}function oc({config:n,recording:e},t,r){let s=e.moments[t],a=de(n,r)==="pursuer"?"evader":"pursuer";if(!s.alive[r])return"";let i=k(
s,r),l=u=>{let[m,p]=k(s,u);return Math.max(Math.abs(m-i[0]),Math.abs(p-i[1]))},c=Array.from({length:s.alive.length},(u,m)=>m).filter(u=>de(n,u)===a&&s.alive[u]&&
!s.captured[u-n.n_pursuers]&&2*l(u)<n.fov);if(!c.length)return`No ${a} in view`;let h=c.reduce((u,m)=>l(m)<l(u)?m:u);return`Nearest ${a}: ${Ta(i,k(s,h))}`}function ac(n,e){
let[{lasted:t,out:r,captured:s},{config:o}]=[Ze(n,e),n];return de(o,e)==="pursuer"?`Your team captured ${s} of ${ic(o)} in ${t} steps.`:r?`You lasted ${t} of ${o.
max_steps} steps.`:`You escaped: ${t} steps.`}var ic=({n_evaders:n})=>`${n} evader${n===1?"":"s"}`;function lc(n,e){let t=fs("Link to this match");t.value=e,n.replaceWith(
t),t.select(),navigator.clipboard?.writeText(e).catch(()=>{})}var cc=2n**64n-1n;function Oa(n,e,t){let r=new URLSearchParams(n.replace(/^#/,"")),s=(c,h,u)=>{let m=r.get(c)??"";return/^\d{1,9}$/.test(m)&&Number(m)<h?Number(
m):u},o=s("run",e.length,t.run),[a,i]=e[o].payoff.shape,l=r.get("seed")??"";return{run:o,pursuer:s("pursuers",a,Math.min(t.pursuer,a-1)),evader:s("evaders",i,Math.
min(t.evader,i-1)),episode:s("episode",1/0,t.episode),seed:/^\d{1,20}$/.test(l)&&BigInt(l)<=cc?l:null,step:s("step",1/0,0)}}var kn=class{dialog=d("dialog",{class:"take-over","aria-label":"Play an agent",onclose:()=>this.view?.stop(),onkeydown:e=>this.view?.key(e)&&e.preventDefault()});view=null;#e;#n;#t;#s;#a=null;constructor(e,t,r,s=!0){
[this.#e,this.#n,this.#t,this.#s]=[e,t,r,s],r.element.addEventListener("takeover",()=>this.open())}start(e,t=""){this.#a=e;let r=Oa(t,this.#e,this.#n.selected),
{world:s}=this.#e[r.run],o=s&&ba(new URLSearchParams(t.replace(/^#/,"")),s);o&&this.play(r,o)}open(){let e=this.#t.shown;if(!e)return;let{match:t,step:r}=e;this.#t.
player.pause();let s=this.#t.inspector.agent,o=r<t.length?r:0,a=(u,m)=>!!t.alive[m*t.n_agents+u],i=Array.from({length:t.n_agents},(u,m)=>(m+t.config.n_pursuers)%
t.n_agents),l=s??i.find(u=>a(u,o)),c=a(l,o)?o:0,h=Array.from({length:c},(u,m)=>t.actions[m*t.n_agents+l]);this.play(this.#n.selected,{seat:l,from:c,moves:h})}play(e,t){
let[r,s]=[this.#a,this.#e[e.run]],{world:o}=s;if(!r||!o||Oe.some(v=>jt(s,v,e[v])))return;let{run:a,pursuer:i,evader:l,episode:c,seed:h}=e,u=de(o,t.seat),m=s.teams[u].
kept.map(v=>({name:s.teams[u].script??`generation ${v}`,text:"",policy:()=>se(s,u,v)}));this.view||(this.view=new Cn(r),this.dialog.append(d("button",{type:"but\
ton",class:"leave",onclick:()=>this.dialog.close()},"Close"),this.view.element)),this.dialog.open||this.dialog.showModal();let p=`You are ${K(t.seat,o.n_pursuers)}\
: ${this.#t.names(e).join(" against ")}`,g={pursuer:se(s,"pursuer",i),evader:se(s,"evader",l)},f={config:o,seed:BigInt(h??s.seeds[i][l]),episode:c,policies:g,...t},
y={run:a,pursuers:i,evaders:l,episode:c,...h===null?{}:{seed:h}};kr(r,this.view,p,f,m,this.#s?y:null)}};var uc=8,hc=700,_a=1400,At=class{element;player=new Te(0,{speed:uc,still:ye()});title=d("figcaption");generation=0;#e=d("canvas");#n;#t=d("p",{class:"small mute\
d numbers"});#s=d("p",{class:"small",role:"status"});#a;#r=null;#l=0;#d=0;#m=!ye();constructor(e){this.#a=e,this.#n=new Me(this.#e,{numbers:!1}),this.element=d(
"figure",{class:"chase"},this.title,this.#e,this.#t,this.#s),this.player.addEventListener("frame",()=>this.#u()),this.player.addEventListener("step",()=>this.#c()),
this.player.addEventListener("state",()=>{this.#m&&!this.player.playing&&this.player.length&&this.player.step===this.player.length&&this.#i()})}set label(e){this.#e.
ariaLabel=e}get runs(){return this.#m}set runs(e){this.#m=e,clearTimeout(this.#d),e?this.player.play():this.player.pause()}renew(e=!1){e||!this.#r||performance.
now()-this.#l>_a?this.#h():this.#i(_a)}#i(e=hc){clearTimeout(this.#d),this.#d=setTimeout(()=>this.#h(),e)}#h(){clearTimeout(this.#d);let e=this.#a();e&&(this.#r=
cn(e),this.#l=performance.now(),this.player.jump(0),this.player.length=e.length,this.player.marks=nn(this.#r),this.#c(),this.#m&&this.player.play())}#u(){this.#r&&
this.#n.show(this.#r,this.player.time)}#c(){let e=this.#r?.moments[this.player.step]?.everCaptured;e&&(this.#t.textContent=`generation ${this.generation} · ${Array.
from(e).filter(Boolean).length} of ${e.length} caught · step ${this.player.step}`)}drawWalls(e){let t=!1,r=!0,s=[0,0],o=([l,c])=>!!this.#r?.obstacles[l*this.#r.
cols+c],a=(l,c)=>{this.#s.textContent=e(l,c)},i=l=>{let c=this.#n.cellAt(l.clientX,l.clientY);c&&o(c)!==r&&a(c,r)};return this.#e.addEventListener("pointerdown",
l=>{let c=t&&this.#n.cellAt(l.clientX,l.clientY);c&&(this.#e.setPointerCapture(l.pointerId),r=!o(c),i(l))}),this.#e.addEventListener("pointermove",l=>t&&l.buttons&&
i(l)),this.#e.addEventListener("keydown",l=>{let c={ArrowUp:[-1,0],ArrowDown:[1,0],ArrowLeft:[0,-1],ArrowRight:[0,1]}[l.key];if(!t||!this.#r||!(c||l.key===" "))
return;l.preventDefault();let h=(p,g)=>Math.min(g-1,Math.max(0,p)),{rows:u,cols:m}=this.#r;c?s=[h(s[0]+c[0],u),h(s[1]+c[1],m)]:a(s,!o(s)),this.#n.look={cursor:s}}),
l=>{t=l,this.#e.classList.toggle("drawn-on",l),this.#e.tabIndex=l?0:-1,this.#e.setAttribute("role",l?"application":"img"),this.#n.look={cursor:null}}}show(e){this.#r&&
(this.#r={...this.#r,obstacles:e},this.#u())}};var R=n=>Array.from(n).reduce((e,t)=>e+t,0)/n.length,Pa=(n,e)=>e==="pursuer"?n:n[0].map((t,r)=>n.map(s=>1-s[r])),$a=(n,e)=>R(Pa(n,e).at(-1));function Na(n,e){let t=[],
r=Pa(n,e).map(s=>R(s.map((o,a)=>(t[a]=Math.max(t[a]??0,o),t[a]-o))));return R(r.slice(Math.floor(r.length/2)))}var La=-12676506002282294e14,Ia=({hidden:n,mask:e})=>n.map(t=>t+(e?4:0));function Mt(n){let e=[3*n.fov**2,...Ia(n),5],t=0;return e.slice(1).map((r,s)=>{let o={at:t,
inputs:e[s],outputs:r};return t+=(o.inputs+1)*r,o})}function Le(n){if(n.kind==="rating")return n.inputs.length;let{at:e,inputs:t,outputs:r}=Mt(n).at(-1);return e+
(t+1)*r}var Tt=(n,e)=>n.kind==="rating"?{...n,genome:e}:{kind:"cells",hidden:Ia(n),activation:"relu",sampled:!0,memory:"none",genome:e};function Fa(n,e,t){let r=t.
initial_weight;if(n.kind==="rating"||t.kind==="rating")return e.normals(Le(n)).map(i=>Math.fround(r)*i);let s=t.initial_head,o=new Float32Array(Le(n)),a=Mt(n);return a.
forEach(({at:i,inputs:l,outputs:c},h)=>{let u=Math.fround(h===a.length-1?s:r);e.normals(l*c).forEach((m,p)=>o[i+p]=u*m)}),o}function Or(n){if(n.kind==="rating")
return null;let{fov:e,mask:t}=n;if(!t)return null;let[r,s]=[new Uint8Array(Le(n)),new Float32Array(Le(n))],o=Mt(n),a=o.length-1,i=Math.floor(e/2);return o.forEach(
({at:l,inputs:c,outputs:h},u)=>{let m=(p,g)=>l+p*h+g;for(let p=0;p<4;p++)if(u>0&&r.fill(1,m(c-4+p,0),m(c-4+p+1,0)),u<a)for(let g=0;g<=c;g++)r[m(g,h-4+p)]=1;t.forEach(
(p,g)=>{let f=u===a?1+g:h-4+g,y=u===0?p.map(([v,S,w])=>(v*e+i+S)*e+i+w):[c-4+g];for(let v of y)r[m(v,f)]=1,s[m(v,f)]=u===a?La:1})}),{fixed:r,values:s}}function _r(n,e){
return e?n.map((t,r)=>e.fixed[r]?e.values[r]:t):n}function Ua(n,e,t){if(e.kind==="rating"||t.kind==="rating")return n;let r=new Float32Array(Le(t)),[s,o]=[Mt(e),
Mt(t)],a=Math.floor(t.fov/2)-Math.floor(e.fov/2),i=c=>c>=0&&c<t.fov,l=c=>{let[h,u,m]=[Math.floor(c/e.fov**2),Math.floor(c/e.fov)%e.fov+a,c%e.fov+a];return i(u)&&
i(m)?(h*t.fov+u)*t.fov+m:-1};return s.forEach((c,h)=>{let u=o[h],m=e.hidden[h]??5;for(let p=0;p<(h?e.hidden[h-1]:c.inputs);p++){let g=h?p:l(p);if(!(g<0))for(let f=0;f<
m;f++)r[u.at+g*u.outputs+f]=n[c.at+p*c.outputs+f]}for(let p=0;p<m;p++)r[u.at+u.inputs*u.outputs+p]=n[c.at+c.inputs*c.outputs+p]}),_r(r.map(c=>c<=La/2?0:c),Or(t))}var Ba={initial:1,noise:2,learn:3,opponents:4},$r={pursuer:1,evader:2,both:3},Ie=4,Pr=2n**32n;function Da(n){let e=[],t=BigInt(n);do e.push(Number(t%Pr)),t/=Pr;while(t>
0n);return e}function Wa(n,e){let t=n;return r=>{let s=r^t;return t=Math.imul(t,e),s=Math.imul(s,t),s^s>>>16}}function za(n,e){let t=Math.imul(3389127133,n)-Math.
imul(1232336661,e)|0;return t^t>>>16}function Nr(n,e,t){let r=n.flatMap(Da);if(e.length){for(;r.length<Ie;)r.push(0);r.push(...e.flatMap(Da))}let s=Wa(1135663077,
2468251765),o=Array.from({length:Ie},(i,l)=>s(r[l]??0));for(let i=0;i<Ie;i++)for(let l=0;l<Ie;l++)i!==l&&(o[l]=za(o[l],s(o[i])));for(let i of r.slice(Ie))for(let l=0;l<
Ie;l++)o[l]=za(o[l],s(i));let a=Wa(2337405405,1492356589);return Uint32Array.from({length:t},(i,l)=>a(o[l%Ie]))}function Et(n,e){let t=Nr(n,[],2*e);return BigUint64Array.
from({length:e},(r,s)=>BigInt(t[2*s])+Pr*BigInt(t[2*s+1]))}var Rn=(n,e,t)=>Et([n,e,t],1)[0];var Ga=n=>(e,...t)=>new Lr(Nr([n],[Ba[e],...t],3)),Lr=class{#e;#n;#t;#s=1;constructor(e){[this.#e,this.#n,this.#t]=[e[0],e[1],e[2]];for(let t=0;t<12;t++)this.#a()}#a(){
let e=this.#e+this.#n+this.#s++|0;return this.#e=this.#n^this.#n>>>9,this.#n=this.#t+(this.#t<<3)|0,this.#t=(this.#t<<21|this.#t>>>11)+e|0,e>>>0}#r(){return(this.#a()+
.5)/2**32}normals(e){let t=new Float32Array(e);for(let r=0;r<e;r+=2){let[s,o]=[Math.sqrt(-2*Math.log(this.#r())),2*Math.PI*this.#r()];t[r]=s*Math.cos(o),r+1<e&&
(t[r+1]=s*Math.sin(o))}return t}integers(e,t){return Int32Array.from({length:t},()=>Math.floor(this.#r()*e))}permutation(e){return this.choice(e,e)}choice(e,t){
let r=Int32Array.from({length:e},(s,o)=>o);for(let s=0;s<t;s++){let o=s+Math.floor(this.#r()*(e-s));[r[s],r[o]]=[r[o],r[s]]}return r.slice(0,t)}};var C=Math.fround,dc=5,mc=256,On=class{size;sigma;fixed;#e;constructor(e,t,r,s){[this.size,this.sigma,this.fixed]=[e,r,s],this.#e=t.normals((1+mc)*e);for(let o=0;o<
this.#e.length;o++)this.#e[o]*=C(r)}draw(e,t){let r=t.integers(this.#e.length-this.size+1,e);return Array.from(r,s=>{let o=this.#e.subarray(s,s+this.size);return this.
fixed?o.map((a,i)=>this.fixed[i]?0:a):o})}},Ir=class{#e;#n;#t=0;constructor(e){[this.#e,this.#n]=[new Float32Array(e),new Float32Array(e)]}moved(e,t,r){let[s,o,
a]=[.9,.999,C(1e-8)];this.#t+=1;let[i,l]=[C(1-s),C(1-o)],[c,h]=[C(1-s**this.#t),C(1-o**this.#t)];return e.map((u,m)=>{let p=t[m],g=this.#e[m]+=C(i*C(p-this.#e[m])),
f=this.#n[m]+=C(l*C(C(p*p)-this.#n[m])),y=C(C(Math.sqrt(C(C(f)/h)))+a);return C(u+C(C(C(r)*C(C(g)/c))/y))})}};function pc(n){let e=Array.from(n).sort((t,r)=>t-r);
return n.map(t=>(e.indexOf(t)+e.lastIndexOf(t))/(2*(n.length-1))-.5)}var _n=class{genome;groups;#e;#n;#t;#s=[];constructor(e,t,r){[this.genome,this.#n,this.#e,this.#t]=
[e,t,r,new Ir(e.length)],this.groups=Int32Array.from({length:r.population},(s,o)=>o%(r.population/2))}get#a(){let{sigma:e,fixed:t}=this.#n,[r,s]=[0,0];return this.
genome.forEach((o,a)=>{t?.[a]||(r+=o*o,s+=1)}),Math.max(e,this.#e.relative_sigma*Math.sqrt(r/s))}ask(e){let[t,r]=[this.#e.population/2,this.genome.length];this.#s=
this.#n.draw(t,e);let s=C(this.#a/this.#n.sigma),o=new Float32Array(2*t*r);return this.#s.forEach((a,i)=>{for(let l=0;l<r;l++){let c=C(s*a[l]);o[i*r+l]=this.genome[l]+
c,o[(t+i)*r+l]=this.genome[l]-c}}),o}tell(e){let[t,r]=[pc(e),this.#s.length],s=new Float32Array(this.genome.length);this.#s.forEach((o,a)=>{let i=C((t[a]-t[r+a])/
(2*r*this.#n.sigma**2));for(let l=0;l<s.length;l++)s[l]+=C(i*o[l])}),this.genome=this.#t.moved(this.genome,s,this.#e.learning_rate)}},Ct=class{population;groups;#e;#n;#t=new Float64Array(
0);#s=0;constructor(e,t,r){[this.population,this.#n,this.#e]=[e,t,r],this.groups=new Int32Array(r.population)}get genome(){return this.#a(this.#s).slice()}#a(e){
let{size:t}=this.#n;return this.population.subarray(e*t,(e+1)*t)}#r(e,t){let r=this.#e.tournament??dc,s=t.integers(this.#t.length,e*r);return Array.from({length:e},
(o,a)=>s.subarray(a*r,(a+1)*r).reduce((i,l)=>this.#t[l]>this.#t[i]?l:i))}ask(e){if(!this.#t.length)return this.population;let{size:t}=this.#n,{population:r,elites:s}=this.#e,
o=r-s,a=this.#r(o,e);this.#r(o,e);let i=Array.from(this.#t.keys()).sort((c,h)=>this.#t[h]-this.#t[c]).slice(0,s),l=new Float32Array(this.population.length);return[
...i,...a].forEach((c,h)=>l.set(this.#a(c),h*t)),this.#n.draw(o,e).forEach((c,h)=>{let u=(s+h)*t;for(let m=0;m<t;m++)l[u+m]+=c[m]}),this.population=l,l}tell(e){
this.#t=e,this.#s=e.indexOf(Math.max(...e))}};function Ha(n,e,t,r){let[s,o]=[n.length,Math.max(...n)+1],a=o>1?s/o:1,i=Array.from(n.keys()).sort((u,m)=>n[u]-n[m]),l=[],c=[];for(let u=0;u<e;u++){let m=u%a;m===
0&&(c=Array.from(r.permutation(s/a)).flatMap(p=>i.slice(p*a,(p+1)*a))),l.push([i,c.map((p,g)=>c[g-g%a+(g%a-m+a)%a])])}let h=u=>i.map(()=>s+u);for(let u=0;u<t[1];u++)
l.push([i,h(u)]);for(let u=0;u<t[0];u++)l.push([h(u),i]);return{pursuer:Int32Array.from(l.flatMap(([u])=>u)),evader:Int32Array.from(l.flatMap(([,u])=>u)),group:Int32Array.
from(l.flatMap((u,m)=>i.map(p=>m*o+n[p])))}}function ja(n,e,t,r){let s=Math.max(...e)+1,[o,a]=[new Float64Array(t*s),new Float64Array(t*s)];r.forEach((l,c)=>{if(n[c]>=
t)return;let h=n[c]*s+e[c];o[h]+=l,a[h]+=1});let i=o.map((l,c)=>a[c]?l/a[c]:0);return Float64Array.from({length:t},(l,c)=>{let h=i.subarray(c*s,(c+1)*s);return Fr(
h)/a.subarray(c*s,(c+1)*s).filter(Boolean).length})}var fc=128,Je=8;function Fr(n){let{length:e}=n;if(e>fc){let m=Math.floor(e/2)-Math.floor(e/2)%Je;return Fr(n.
subarray(0,m))+Fr(n.subarray(m))}if(e<Je)return n.reduce((m,p)=>m+p,0);let t=n.slice(0,Je),r=e-e%Je;for(let m=Je;m<r;m++)t[m%Je]+=n[m];let[s,o,a,i,l,c,h,u]=t;return n.
subarray(r).reduce((m,p)=>m+p,s+o+(a+i)+(l+c+(h+u)))}var T=["pursuer","evader"],Fe=n=>n==="pursuer"?"evader":"pursuer";var Va=({world:n})=>n.rules.teammate==="REACH"?.2:0;var Ya=["generation","team","epoch","opponent","fitness_mean","fitness_std","fitness_best","capture_rate","length","pursuer_faults","evader_faults","matches","s\
teps"],$n={pursuer:["random","clumsy-fleer"],evader:["random","clumsy-chaser"]},yc=20,gc=8,vc=-1,Nn=({world:n,policy:e},t,r)=>e.kind==="rating"?e:{kind:"cells",
fov:n.fov,hidden:e.hidden,mask:e.mask==="none"?null:t[r]},Xe=class{settings;archive={pursuer:[],evader:[]};rows=[];cells=new Map;counters={pursuer:[],evader:[]};#e;#n;#t;#s={};#a=new Set;#r=0;#l=0;#d=0;constructor(e,t,r,s=Ga(
t.seed)){[this.#e,this.settings,this.#n,this.#t]=[e,t,r,s];for(let o of T){let a=s("initial",T.indexOf(o)),i=t.learner.kind==="ga"?t.learner.population:1,l=Array.
from({length:i},()=>Fa(this.shape(o),a,t.policy));this.#i(o,l),this.archive[o].push(this.#s[o].genome)}this.#x(...T)}shape(e){return Nn(this.settings,this.#n,e)}get finished(){
return Math.min(this.archive.pursuer.length,this.archive.evader.length)}*run(){yield*this.#w(0);for(let e=1;e<=this.settings.schedule.generations;e++){if(this.settings.
schedule.kind==="alternating")for(let t of T)yield*this.#h(t,e),this.#x(t);else yield*this.#u(e),this.#x(...T);yield*this.#w(e)}}change(e){let t=this.settings,r={
pursuer:this.shape("pursuer"),evader:this.shape("evader")},s=l=>JSON.stringify(l(t))===JSON.stringify(l(e));this.settings=e;let o=s(l=>[l.world.fov,l.policy]);if(!o||
!s(l=>l.learner))for(let l of T){let c=h=>Ua(h,r[l],this.shape(l));this.archive[l]=this.archive[l].map(c),this.#i(l,this.#m(l).map(c))}if(o&&s(l=>l.world))return null;
this.cells.clear(),this.#a.clear();let{pursuer:a,evader:i}=this.archive;return{type:"anew",settings:e,genomes:{pursuer:a.slice(0,this.finished),evader:i.slice(0,
this.finished)}}}#m(e){let t=this.#s[e];if(!(t instanceof Ct))return[t.genome];let r=t.genome.length,s=Array.from({length:t.population.length/r},(o,a)=>t.population.
slice(a*r,(a+1)*r));return Array.from({length:this.settings.learner.population},(o,a)=>a===0?t.genome:s[a%s.length])}#i(e,t){let{learner:r}=this.settings,[s,o]=[
this.shape(e),r.kind==="ga"?r.mutation:r.sigma],a=Or(s),i=new On(Le(s),this.#t("noise",T.indexOf(e)),o,a?.fixed??null),l=t.map(c=>_r(c,a));this.#s[e]=r.kind==="\
ga"?new Ct(Pn(l),i,r):new _n(l[0],i,r)}*#h(e,t){for(let r=0;r<this.#o(e);r++){let s=this.archive[Fe(e)].length,o=this.settings.schedule[`${e}s_meet`],a=o==="lat\
est"?s-1:o==="round-robin"?r%s:this.#t("opponents",T.indexOf(e),t,r).choice(s,1)[0],i=e==="pursuer"?[t,a]:[a,t],l=this.#s[e],{groups:c}=l,h=Et([this.settings.seed,
...i,$r[e],r],Math.max(...c)+1),u=l.ask(this.#t("learn",T.indexOf(e),t,r)),[m,p]=[Int32Array.from(c.keys()),new Int32Array(c.length)],g={[e]:u,[Fe(e)]:this.archive[Fe(
e)][a]},f={[e]:m,[Fe(e)]:p},y=this.#f(g,f,BigUint64Array.from(c,S=>h[S])),v=this.#b(y,e);this.#v(y,v,{generation:t,team:e,epoch:r,opponent:a}),l.tell(v),yield*this.#y(
t,r,e)}this.archive[e].push(this.#s[e].genome)}*#u(e){for(let t=0;t<this.#o("pursuer");t++){let{schedule:r,learner:{population:s}}=this.settings,[o,a]=r.kind===
"hall-of-fame"?[r.hall_sample,r.contemporaries]:[0,1],i={pursuer:this.#c("pursuer",e,t),evader:this.#c("evader",e,t)},l=this.#t("opponents",0,e,t),c={pursuer:this.#p(
o,l),evader:this.#p(o,l)},h=y=>Pn([i[y],...Array.from(c[Fe(y)],v=>this.archive[y][v])]),u=[c.evader.length,c.pursuer.length],m=Ha(this.#s.pursuer.groups,a,u,l),
p=Et([this.settings.seed,e,e,$r.both,t],Math.max(...m.group)+1),g={pursuer:h("pursuer"),evader:h("evader")},f=this.#f(g,m,BigUint64Array.from(m.group,y=>p[y]));
for(let y of T){let v=ja(m[y],m[Fe(y)],s,this.#b(f,y));this.#v(f,v,{generation:e,team:y,epoch:t,opponent:vc}),this.#s[y].tell(v)}yield*this.#y(e,t,"both")}for(let t of T)
this.archive[t].push(this.#s[t].genome)}#c(e,t,r){return this.#s[e].ask(this.#t("learn",T.indexOf(e),t,r))}#p(e,t){let r=this.archive.pursuer.length;return e?t.
choice(r,Math.min(e,r)):new Int32Array(0)}#o(e){let{schedule:t}=this.settings;return t.kind==="hall-of-fame"?t.joint_epochs:t[`${e}_epochs`]}*#y(e,t,r){let[s,o]=this.
settings.schedule.kind==="hall-of-fame"?[this.#o("pursuer"),0]:[this.#o("pursuer"),this.#o("evader")],a=t+1+(r==="evader"?s:0),i=s+o;yield{type:"epoch",done:(e-
1)*i+a,of:this.settings.schedule.generations*i},yield*this.catchUp()}#f(e,t,r){let s={...this.settings.world,max_steps:this.settings.train_steps},o=this.#e.rollouts(
s,this.#g("pursuer",e.pursuer),this.#g("evader",e.evader),{...t,seed:r},1);this.#r+=o.length.length;for(let a of o.length)this.#l+=Number(a);for(let a of o.agent_steps)
this.#d+=Number(a);return o}#g(e,t){return Tt(this.shape(e),t)}#b({captured_fraction:e,overlap:t},r){let s=Va(this.settings);return Float64Array.from(e,(o,a)=>r===
"pursuer"?o:1-o-s*Number(t[2*a+1]))}#v(e,t,r){let s=R(t),o=[0,0];e.faults.forEach((a,i)=>o[Math.floor(i/3)%2]+=Number(a)),this.rows.push({...r,fitness_mean:s,fitness_std:Math.
sqrt(R(t.map(a=>(a-s)**2))),fitness_best:Math.max(...t),capture_rate:R(e.capture_rate),length:R(e.length),pursuer_faults:o[0]/e.length.length,evader_faults:o[1]/
e.length.length,matches:this.#r,steps:this.#l})}#x(...e){for(let t of e)this.counters[t].push({matches:this.#r,steps:this.#l,agent_steps:this.#d})}*#w(e){yield{
type:"generation",number:e,genomes:{pursuer:this.archive.pursuer[e],evader:this.archive.evader[e]}},yield*this.catchUp()}*catchUp(){for(let e=this.finished-1;e>=
0;e--){for(let t=e;t>=0;t--)for(let[r,s]of t===e?[[e,e]]:[[e,t],[t,e]]){if(this.cells.has(`${r} ${s}`))continue;let o=this.#A(r,s);this.cells.set(`${r} ${s}`,o),
yield{type:"cell",cell:o}}this.#a.has(e)||(this.#a.add(e),yield{type:"scores",number:e,scores:{pursuer:this.#S("pursuer",e),evader:this.#S("evader",e)}})}}#A(e,t){
let{world:r,evaluation_episodes:s,seed:o}=this.settings,a={pursuer:new Int32Array(1),evader:new Int32Array(1),seed:BigUint64Array.of(Rn(o,e,t))},i=T.map(h=>this.#g(
h,this.archive[h][h==="pursuer"?e:t])),l=this.#e.rollouts(r,...i,a,s),c=h=>{let u=Array.from(l[h],Number),m=u.length/s;return Array.from({length:m},(p,g)=>R(u.filter(
(f,y)=>y%m===g)))};return{pursuer:e,evader:t,capture_rates:Array.from(l.capture_rate),lengths:Array.from(l.length),means:{collisions:c("collisions"),faults:c("f\
aults"),agent_steps:c("agent_steps"),survivors:c("survivors")}}}#S(e,t){let{world:r,seed:s}=this.settings,[o,a]=[this.#g(e,this.archive[e][t]),new Int32Array(1)];
return R($n[e].map((i,l)=>{let c=Et([s,T.indexOf(e),l,gc],1),h=e==="pursuer"?[o,i]:[i,o],u=R(this.#e.rollouts(r,...h,{pursuer:a,evader:a,seed:c},yc).capture_rate);
return e==="pursuer"?u:1-u}))}};function Pn(n){let e=new Float32Array(n.reduce((r,{length:s})=>r+s,0)),t=0;for(let r of n)e.set(r,t),t+=r.length;return e}var Ur=n=>Array.from({length:n},()=>Array(n)),Ln=class{learning=T;settings=[];training={capture_rate:[],generation:[],learner:[],epochs:1,window:1,matches:0};limits="";name;schedule;seed;seeds;world;payoff;teams;findings=null;genomes={
pursuer:[],evader:[]};#e;#n;#t;constructor(e,t,r,s){[this.#t,this.#e,this.#n,this.name,this.schedule]=[e,t,s,r,r],[this.world,this.seed]=[e.world,String(e.seed)];
let o=e.schedule.generations+1;this.seeds=Array.from({length:o},(a,i)=>Array.from({length:o},(l,c)=>String(Rn(e.seed,i,c)))),this.payoff=this.#s(),this.teams=this.#a()}get newest(){
return this.genomes.pursuer.length-1}#s(){let e=this.#t.schedule.generations+1;return{first:[0,0],shape:[e,e],episodes:this.#t.evaluation_episodes,capture_rate:Ur(
e),capture_rates:Ur(e),lengths:Ur(e)}}#a(){let e=t=>{let r=`${this.#n} ${t}`;Bs(r,Pn(this.genomes[t]));let{genome:s,...o}=Tt(Nn(this.#t,this.#e,t),this.genomes[t][0]??
new Float32Array(0));return{script:null,policy:{...o,genome_size:s.length},kept:[...this.genomes[t].keys()],genomes:r}};return{pursuer:e("pursuer"),evader:e("ev\
ader")}}policy(e,t){return this.playing(e,this.genomes[e][t])}playing(e,t){return Tt(Nn(this.#t,this.#e,e),t)}add(e){for(let t of T)this.genomes[t].push(e[t]);this.
teams=this.#a()}change(e,t){this.#t=e,this.world=e.world;for(let r of T)this.genomes[r]=[...t[r]];[this.payoff,this.teams,this.findings]=[this.#s(),this.#a(),null]}addCell({
pursuer:e,evader:t,capture_rates:r,lengths:s}){this.payoff.capture_rate[e][t]=R(r),this.payoff.capture_rates[e][t]=[...r],this.payoff.lengths[e][t]=[...s],this.
findings={generalization:this.#r()}}#r(){let e=this.payoff.capture_rate,t=o=>({mean:o,low:null,high:null}),r=o=>{let a=o.filter(i=>i!==void 0);return a.length?R(
a):null},s=[...this.genomes.pursuer.keys()];return{pursuers:t(s.map(o=>r(e[o]))),evaders:t(s.map(o=>r(e.map(a=>a[o]===void 0?void 0:1-a[o]))))}}};var bc=2,wc=1.5,xc=20,In=class{element=d("section",{class:"card weights-card","aria-label":"Weights of named inputs",hidden:!0});#e;#n;#t=d("div",{class:"evolve\
d"});#s=d("p",{class:"numbers",role:"status"});#a=d("button",{type:"button",onclick:()=>this.#i()},"As evolved");#r=null;#l=null;constructor(e,t){[this.#e,this.#n]=
[e,t],this.element.append(d("h3",{},"What they have learned"),d("p",{class:"small muted"},"An agent takes the move with the largest sum of weight x input. Drag \
a weight, and see at once what becomes of the team."),d("div",{class:"doings"},this.#a,this.#s),this.#t)}genome(e){return this.#l?.[e]??this.#r.genomes[e].at(-1)}show(e){
e!==this.#r&&(this.#l=null),this.#r=e;let{policy:t}=e.teams.pursuer;this.element.hidden=t?.kind!=="rating"||e.newest<0,!(t?.kind!=="rating"||this.element.hidden)&&
(this.#l||this.#t.replaceChildren(...T.map(r=>this.#d(r,t.inputs))),this.#h())}#d(e,t){let r=this.genome(e),s=Math.max(bc,wc*Math.max(...r.map(Math.abs)));return d(
"div",{class:"weights"},d("h4",{class:e},`${e}s`),...t.flatMap((o,a)=>{let i=d("span",{class:"numbers"},je(r[a])),l=d("input",{type:"range",class:e,min:-s,max:s,
step:"any",value:r[a],title:Ee[o],"aria-label":`${e}s: ${o}`});return l.addEventListener("input",()=>{i.textContent=je(Number(l.value)),this.#m(e,a,Number(l.value))}),
[d("span",{title:Ee[o]},o.replaceAll("_"," ")),l,i]}))}#m(e,t,r){this.#l??={pursuer:this.genome("pursuer").slice(),evader:this.genome("evader").slice()},this.#l[e][t]=
r,this.#h(),this.#n()}#i(){this.#l=null,this.show(this.#r),this.#n()}#h(){this.#a.disabled=!this.#l;let e=this.#r.newest,t=s=>`${Math.round(100*this.#u(s))} %`,
r=t({pursuer:this.#r.genomes.pursuer[e],evader:this.#r.genomes.evader[e]});this.#s.textContent=this.#l?`Yours: ${t(this.#l)} are caught; as evolved: ${r}`:`${r}\
 are caught`}#u({pursuer:e,evader:t}){let r=this.#r,s=new Int32Array(1),o={pursuer:s,evader:s,seed:BigUint64Array.of(BigInt(r.seed))};return R(this.#e.rollouts(
r.world,r.playing("pursuer",e),r.playing("evader",t),o,xc).capture_rate)}};var kt=n=>`${Math.round(100*n)} %`,Sc=100,Ac=0,Fn=class extends EventTarget{element;newest;beginning;settings;state="waiting";done=0;seconds=0;#e;#n;#t;#s=d("h2",
{class:"lane-title"});#a=d("p",{class:"facts numbers"});#r=d("div",{class:"lane-room",hidden:!0});#l=d("section",{class:"card measures",hidden:!0});#d=d("div");#m;#i;#h={
pursuer:[],evader:[]};#u=new Map;#c;#p;#o=()=>{};#y=0;#f=!0;#g=0;#b=null;constructor(e,t,r,s){super(),[this.#e,this.#n,this.#t,this.settings]=[e,t,r,s],this.newest=
new At(()=>this.#E(this.#i.newest)),this.beginning=new At(()=>this.#E(0)),this.beginning.element.classList.add("beginning"),this.#m=new In(t,()=>this.#M(!0));let o=d(
"div",{class:"boards"},this.newest.element,this.beginning.element);this.element=d("section",{class:"lane"},this.#s,this.#a,o,this.#r,this.#m.element,this.#l,this.#d),
r.onmessage=({data:a})=>this.#x(a),this.reset(s)}reset(e){this.#v({type:"stop"}),[this.settings,this.state,this.done]=[e,"waiting",0],this.#S();let{archive:t}=new Xe(
this.#n,e,this.#e.masks);this.#i.add({pursuer:t.pursuer[0],evader:t.evader[0]}),this.#r.hidden=this.#l.hidden=!0,this.#M(!0),this.#T()}start(){this.#S(),[this.state,
this.done]=["evolving",0],this.#r.hidden=!1,this.#l.hidden=!0,this.#v({type:"start",settings:this.settings,masks:this.#e.masks}),this.#T()}stop(){this.#v({type:"\
stop"}),this.state==="evolving"&&(this.state="stopped"),this.#T()}change(e){if(this.state==="waiting")return this.reset(e);this.settings=e,this.#v({type:"change",
settings:e}),this.#T()}takeOver(){let e=this.#i.newest;this.#p.play({run:0,pursuer:e,evader:e,episode:0,seed:null},{seat:this.#i.world.n_pursuers,from:0,moves:[]})}saved(){
return new Promise(e=>{this.#b=e,this.#v({type:"save"})})}get newestGeneration(){return this.#i.newest}close(){this.#t.terminate(),this.newest.runs=this.beginning.
runs=!1}#v(e){this.#t.postMessage(e)}#x(e){if(e.type==="generation"){if(this.state!=="evolving")return;this.#i.add(e.genomes),this.#M(e.number===0)}else if(e.type===
"cell"){let{pursuer:t,evader:r}=e.cell;this.#i.addCell(e.cell),this.#f&&t===r&&t===this.#i.newest&&this.#c.select({pursuer:t,evader:r}),this.#u.set(`${t} ${r}`,
e.cell)}else if(e.type==="scores")for(let t of T)this.#h[t][e.number]=e.scores[t];else e.type==="anew"?(this.#i.change(e.settings,e.genomes),this.#A(),this.#M(!0)):
e.type==="epoch"?this.done=e.done/e.of:e.type==="end"?(this.state==="evolving"&&([this.state,this.seconds,this.done]=["ended",e.seconds,1]),this.#C()):e.type===
"saved"?this.#b?.(e.race):(this.#a.textContent=`The race failed: ${e.message}`,this.state="stopped");this.#g||(this.#g=setTimeout(()=>requestAnimationFrame(()=>this.#w()),
Sc))}#w(){this.#g=0,this.#c.dispatchEvent(new Event("run")),this.#o(),this.#T()}#A(){this.#u=new Map,this.#h={pursuer:[],evader:[]},this.#l.hidden=!0}#S(){let e=`\
race ${Ac++}`,t=Vt(this.settings);this.#i=new Ln(this.settings,this.#e.masks,t,e),this.#A(),this.#f=!0,this.#c=new Mn({run:0,pursuer:0,evader:0,episode:0,seed:null});
let[r,s]=[new An([this.#i],this.#c),new wn([this.#i],this.#c,null)];r.element.ariaLabel=`Payoff matrix. ${t}`,this.#p=new kn([this.#i],this.#c,s,!1),this.#p.start(
this.#n);let o=d("dialog",{class:"of-cell-match","aria-label":"Match",onclose:()=>s.player.pause()},d("button",{type:"button",class:"leave",onclick:()=>o.close()},
"Close"),s.element),a=!1;r.element.addEventListener("play",()=>{let{pursuer:l,evader:c}=this.#c.selected;this.#f=!1,this.#i.payoff.capture_rate[l][c]!==void 0&&
(o.showModal(),a||s.start(this.#n),a=!0,s.playSoon())});let i=Qs(`Scores against scripts, by generation: ${$n.pursuer.join(", ")} and ${$n.evader.join(", ")}`,(l,c)=>{
let h=this.settings.schedule.generations,u=Zs(l,c,{low:0,high:h,label:"generation",whole:!0},{low:0,high:1,label:"score"});for(let m of T){let p=Array.from(this.#h[m],
g=>g??null);Js(u,[...p.keys()],p,`of-${m}s`)}return u},()=>{},l=>{let c=Math.min(this.#i.newest,Math.max(0,Math.round(l)));this.#c.select({pursuer:c,evader:c})});
this.#o=i.redraw,this.#r.replaceChildren(r.element,d("section",{class:"card scores"},d("h3",{},"Against opponents that never change"),d("p",{class:"small muted"},
"Captures of random walkers and of clumsy fleers; escapes from random walkers and from clumsy chasers."),Xs(["pursuers","of-pursuers"],["evaders","of-evaders"]),
i.element)),this.#d.replaceChildren(o,this.#p.dialog)}#E(e){let t=this.#i.newest;if(t<0||e<0)return null;let{world:r,payoff:s,seeds:o}=this.#i,a=this.#y++%s.episodes;
this.newest.title.textContent=t?"Newest against newest":"Generation 0: nobody has learned anything yet",this.beginning.title.textContent="Pursuers of generation\
 0, newest evaders";for(let c of[this.newest,this.beginning])c.generation=t;for(let c of[this.newest,this.beginning])c.label=`A match. ${c.title.textContent}`;let[
i,l]=T.map(c=>this.#i.playing(c,c==="pursuer"&&e<t?this.#i.genomes.pursuer[e]:this.#m.genome(c)));return this.#n.match(r,i,l,BigInt(o[e][t]),a)}#M(e){this.#m.show(
this.#i),this.newest.renew(e),(this.#i.newest>0||this.state!=="waiting")&&this.beginning.renew(e)}#T(){this.element.dataset.state=this.state,this.#s.textContent=
Vt(this.settings);let e=this.#u.get(`${this.#i.newest} ${this.#i.newest}`)??this.#u.get(`${this.#i.newest-1} ${this.#i.newest-1}`),t=e?[`Generation ${this.#i.newest}\
 of ${this.settings.schedule.generations}`,`the newest pursuers catch ${kt(R(e.capture_rates))} of the newest evaders`,`${Mc(e).toFixed(0)} collisions in 1000 m\
oves`]:[];this.#a.replaceChildren(...t.map(r=>d("span",{},r))),this.dispatchEvent(new Event("state"))}#C(){this.#l.ariaLabel=`What came out. ${Vt(this.settings)}`;
let e=this.#i.payoff.capture_rate.slice(0,this.#i.newest+1).map(r=>r.slice(0,this.#i.newest+1));if(e.length<2||e.some(r=>Array.from(r).includes(void 0)))return;
let t=[["Score against scripts: generation 0",r=>kt(this.#h[r][0]??0)],["Score against scripts: newest generation",r=>kt(this.#h[r].at(-1)??0)],["Newest generat\
ion against all generations of the other team",r=>kt($a(e,r))],["Below its own best so far, in the later half (forgetting)",r=>kt(Na(e,r))]];this.#l.replaceChildren(
d("h3",{},"What came out"),d("table",{class:"numbers"},d("thead",{},d("tr",{},d("td"),...T.map(r=>d("th",{scope:"col",class:r},`${r}s`)))),d("tbody",{},...t.map(
([r,s])=>d("tr",{},d("th",{scope:"row"},r),...T.map(o=>d("td",{},s(o))))))),d("p",{class:"small muted"},"These are measures without a verdict: one race proves l\
ittle. Save it, and ",d("code",{},"matrixworld judge")," weighs luck and says what happened.")),this.#l.hidden=!1}};function Mc({means:{faults:n,agent_steps:e}}){
let t=r=>r.reduce((s,o)=>s+o,0);return 1e3*t(n)/Math.max(1,t(e))}var Ka=n=>Re(JSON.stringify(n,null,2)),Dr=(n,...e)=>({dtype:"<f8",shape:e,data:Float64Array.from(n)}),Tc=n=>Math.sqrt(R(n.map(e=>(e-R(n))**2)));function Ec({settings:n,
finished:e}){let t=n.schedule.kind==="alternating"?T.map(r=>[r]):[T];return Array.from({length:e},(r,s)=>(s?t:[T]).map(o=>[s,o])).flat()}function Cc({archive:n,
rows:e,counters:t},r,[s,o]){let a=e.filter(c=>c.generation===s&&o.includes(c.team)),i=Re(a.map(c=>`${[r,...Ya.map(h=>c[h])].join(",")}
`).join("")),l=c=>({dtype:"<f4",shape:[1,n[c][s].length],data:n[c][s]});return{...Object.fromEntries(o.map(c=>[`${c}s`,l(c)])),log:{dtype:`|S${Math.max(1,i.length)}`,
shape:[],data:i.length?i:new Uint8Array(1)},...Object.fromEntries(Object.entries(t[o.at(-1)][s]).map(([c,h])=>[c,Dr([h])])),...r?{score:Dr([R(a.slice(Math.floor(
a.length/2)).map(c=>c.capture_rate))])}:{}}}function kc(n){let e=n.finished,t=Array.from({length:e*e},(o,a)=>n.cells.get(`${Math.floor(a/e)} ${a%e}`)),r=t[0].lengths.
length,s=(o,...a)=>Dr(t.flatMap(o),e,e,...a);return{scores:{dtype:"<f4",shape:[e,e,r],data:Float32Array.from(t.flatMap(({capture_rates:o})=>o))},mean:s(({capture_rates:o})=>R(
o)),std:s(({capture_rates:o})=>Tc(o)),lengths:{dtype:"<i4",shape:[e,e,r],data:Int32Array.from(t.flatMap(({lengths:o})=>o))},collisions:s(({means:o})=>o.collisions,
2,3),faults:s(({means:o})=>o.faults,2,3),agent_steps:s(({means:o})=>o.agent_steps,2),pursuer_survivors:s(({means:o})=>o.survivors[0]),evader_survivors:s(({means:o})=>o.
survivors[1])}}function Rc(n,{format:e,version:t}){let r=n.finished-1,s={...n.settings,schedule:{...n.settings.schedule,generations:r}},o={format:e,matrixworld:t,
settings:s,drawn_by:"page"},a=Ec(n),{matches:i,steps:l,agent_steps:c}=n.counters.evader[r],h={training_matches:i,training_steps:l,training_agent_steps:c},u={stages:a.
length-1,...h,disengagement:[],evaluation_matches:n.finished**2*n.settings.evaluation_episodes};return{"config.json":Ka(o),...Object.fromEntries(a.map((m,p)=>[`\
stage-${String(p).padStart(4,"0")}.npz`,St(Cc(n,p,m))])),"payoff.npz":St(kc(n)),"summary.json":Ka(u)}}function qa(n,e){let t=n.flatMap(({name:r,race:s})=>Object.
entries(Rc(s,e)).map(([o,a])=>[n.length>1?`${r}/${o}`:o,a]));return Gt(Object.fromEntries(t))}var Za=n=>n.finished>1&&n.cells.size>=n.finished**2&&T.every(e=>n.
archive[e].length);var Oc=12;function Ja(n){let e=new Blob([Ae("script-engine"),`
`,Ae(`script-${n}`)],{type:"text/javascript"});return new Worker(URL.createObjectURL(e))}function Xa(){let n=h=>postMessage(h),e=It(),t=null,r=null,s=0,o=!1,a=new MessageChannel,
i=()=>{let h=performance.now()+Oc;for(;r&&performance.now()<h;){let{value:u,done:m}=r.next();m?(r=null,n({type:"end",seconds:(performance.now()-s)/1e3})):n(u)}!r||
o||(o=!0,a.port2.postMessage(null))},l=async h=>{if(h.type==="start")t=new Xe(await e,h.settings,h.masks),[r,s]=[t.run(),performance.now()],i();else if(h.type===
"stop")r=null;else if(h.type==="change"){let u=t?.change(h.settings);if(u&&n(u),!t||!u||r)return;r=t.catchUp(),i()}else if(t){let{settings:u,archive:m,rows:p,cells:g,
counters:f,finished:y}=t;n({type:"saved",race:{settings:u,archive:m,rows:p,cells:g,counters:f,finished:y}})}},c=h=>{Promise.resolve().then(h).catch(u=>{r=null,n(
{type:"failed",message:String(u)})})};a.port1.onmessage=()=>{o=!1,c(i)},globalThis.onmessage=({data:h})=>c(()=>l(h))}var _c=250,Wr=class{#e;#n;lanes=[];#t=d("div",{class:"lanes"});#s=d("button",{type:"button",class:"evolve",onclick:()=>this.#b()});#a=d("progress",{max:1,value:0,
"aria-label":"Progress of the race"});#r=d("p",{class:"small muted numbers",role:"status"});#l=d("button",{type:"button",class:"side",title:"A second race of th\
e same seed with another schedule",onclick:()=>this.#x()},"Side by side");#d=d("button",{type:"button","aria-pressed":"false",title:"Drag over the board to draw\
 walls, and over walls to remove them",onclick:()=>this.#S()},"Draw walls");#m=d("button",{type:"button",onclick:()=>this.#w({walls:[]})},"No walls");#i=d("butt\
on",{type:"button",onclick:()=>this.#E()});#h=d("span",{class:"small muted",role:"status"});#u=Ys((e,t)=>this.#w(e,t));#c=d("button",{type:"button",onclick:()=>{
this.#C()},title:"An archive that matrixworld judge, explore and replay read"},"Save");#p=[];#o;#y=0;constructor(e,t){[this.#e,this.#n,this.#o]=[e,t,Vs(e,location.
hash)];let r=d("div",{class:"doings",role:"group","aria-label":"What can be done"},this.#l,d("button",{type:"button",class:"to-play",title:"Play an evader again\
st the newest pursuers",onclick:()=>this.lanes[0].takeOver()},"Take over"),this.#d,this.#m,this.#i,this.#c,this.#h);document.getElementById("page").replaceWith(
vs("Evolve a chase","Triangles chase discs. Nobody has told either team how. Press Evolve, and both learn by trial and error, against each other."),d("main",{},
d("div",{class:"start"},this.#s,r,d("div",{class:"progress"},this.#a,this.#r)),this.#u.now,this.#t,this.#u.anew,d("div",{class:"card below"},Dt(),d("p",{class:"\
small muted"},"The page plays and learns with the engine of matrixworld, in this browser; nothing is sent."),d("p",{class:"small muted of-saving"},"A saved race\
 is an archive: ",d("code",{},"matrixworld judge"),", ",d("code",{},"explore")," and ",d("code",{},"replay")," read it. Python plays its matches again, and does\
 not continue it."))),d("footer",{class:"muted small"},`matrixworld ${e.version}`)),this.#g(),this.#M()}#f(){return[this.#o.schedule,...this.#o.beside?[this.#o.
beside]:[]]}#g(){for(let e of this.lanes.splice(0))e.close();for(let e of this.#f()){let t=new Fn(this.#e,this.#n,Ja("evolve"),Jt(this.#e,this.#o,e));t.addEventListener(
"state",()=>this.#T()),this.lanes.push(t)}this.#p=this.lanes.map(e=>e.newest.drawWalls(([t,r],s)=>this.#A(t,r,s))),this.#d.ariaPressed="false",this.#t.dataset.count=
String(this.lanes.length),this.#t.replaceChildren(...this.lanes.map(({element:e})=>e)),this.#u.show(this.#o),this.#T()}#b(){this.lanes.some(({state:e})=>e==="ev\
olving")?this.lanes.forEach(e=>e.stop()):this.#v()}#v(){this.#h.textContent="";for(let[e,t]of this.#f().entries()){let r=this.lanes[e];r.settings=Jt(this.#e,this.#o,
t),r.start()}}#x(){let e=this.#o.schedule==="specialist-specialist"?"generalist-generalist":"specialist-specialist";this.#w({beside:this.#o.beside?null:e},!0)}#w=(e,t=!1)=>{
let r=this.#f().length,s=this.lanes.every(({state:i})=>i==="waiting"),o={...this.#o,...e},a=Xt(o,Zt(this.#e));a||(this.#o=o),this.#u.show(this.#o),this.#h.textContent=
a,!a&&(Ft()&&history.replaceState(null,"",`#${js(this.#o)}`),this.#f().length!==r&&this.#g(),t&&!s?this.#v():this.#f().forEach((i,l)=>this.lanes[l].change(Jt(this.#e,
this.#o,i))))};#A(e,t,r){let{rows:s,cols:o}=this.lanes[0].settings.world,a={...this.#o,walls:Wt(this.#o.walls,e*o+t,r)},i=Xt(a,this.lanes[0].settings.world);if(i)
return i;let{walls:l}=this.#o=a,c=Uint8Array.from({length:s*o},(h,u)=>Number(l.includes(u)));for(let h of this.lanes)h.newest.show(c);return clearTimeout(this.#y),
this.#y=setTimeout(()=>this.#w({walls:l}),_c),""}#S(){let e=this.#d.ariaPressed!=="true";this.#d.ariaPressed=String(e);for(let t of this.#p)t(e)}#E(){let e=!this.
lanes[0].newest.runs;for(let{newest:t,beginning:r}of this.lanes)t.runs=r.runs=e;this.#M()}#M(){this.#i.textContent=this.lanes[0].newest.runs?"Pause boards":"Pla\
y boards"}#T(){if(!this.lanes.length)return;let e=this.lanes.map(({state:a})=>a),t=e.includes("evolving");document.body.dataset.state=e.every(a=>a==="waiting")?
"waiting":t?"evolving":"ended",this.#s.textContent=t?"Stop":e[0]==="waiting"?"Evolve":"Again",this.#l.ariaPressed=String(this.lanes.length>1),this.#m.hidden=!this.#o.
walls.length,this.#a.value=Math.min(...this.lanes.map(({done:a})=>a));let r=Math.max(...this.lanes.map(a=>a.seconds)),s=e.every(a=>a==="ended"),{seed:o}=this.#o;
this.#r.textContent=t?`Seed ${o}: generation ${this.lanes.map(a=>a.newestGeneration).join(" and ")}`:s?`Seed ${o}: the race took ${r.toFixed(1)} seconds.`:e.includes(
"stopped")?"Stopped.":""}async#C(){let e=await Promise.all(this.lanes.map(async r=>({name:_e(r.settings),race:await r.saved()})));if(!e.every(({race:r})=>Za(r))){
this.#h.textContent="Wait for the next generation, and save then.";return}let t=`${e.map(r=>r.name).join("-and-")}-seed-${this.#o.seed}.zip`;Ut(t,qa(e,this.#e)),
this.#h.textContent=`Saved as ${t}.`}};async function Pc(){let n=new Wr(Hs(),await It());document.addEventListener("keydown",({key:e,target:t,ctrlKey:r,metaKey:s,
altKey:o})=>{let a=t instanceof HTMLInputElement||t instanceof HTMLSelectElement||document.querySelector("dialog[open]");e.toLowerCase()==="d"&&!a&&!r&&!s&&!o&&
Jn()}),window.addEventListener("hashchange",()=>location.reload()),Object.assign(window,{matrixworldEvolve:n})}typeof document>"u"?Xa():ps(Pc());})();
