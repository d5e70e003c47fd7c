/* built from web/ by "npm run build"; sources ef9619ecdb2c8c227dc301925cacc1b107a1e4e4cd6712e163198135d50d9312 */
"use strict";(()=>{var ur={SIMULTANEOUS:0,SWARM_TURNS:1,AGENT_TURNS:2},et={DISAPPEAR:0,REACH:1,BOUNCE:2},dr={OCCUPATION:0,SURROUND:1},pr={FAULT:0,INVOLVED:1};var tt=["obstacle","teammate","adversary"],mn=["vertex","edge","chain"],mr=["turn","kind","form","first","second","row","col","at_fault","held","doomed"],hn=["p\
ursuer_{number}","evader_{number}"],hr={obstacle:"{first} ran into the obstacle or border at {cell}",vertex:"{first} and {second} both headed for {cell}",edge:"\
{first} and {second} meant to swap, {first} to {cell}",chain:"{first} headed for {cell}, where {second} had to stay"},nt={"both held":"both bounce","both doomed":"\
both disappear",held:"{agent} bounces",doomed:"{agent} disappears",none:"nobody is stopped"},fr="{event}: {outcome}",fn={random:"any action, all equally likely",
still:"always stays",chaser:"moves to where the nearest adversary in view is nearest",fleer:"moves to where the nearest adversary in view is farthest","clumsy-c\
haser":"a chaser that takes any action in half of the steps",hunter:"a chaser of the nearest adversary in view to which no teammate in view is nearer",surrounder:"\
a chaser of the nearest free cell beside an adversary without a teammate","clumsy-fleer":"a fleer that takes any action in half of the steps",dodger:"moves to w\
here all adversaries in view together are farthest","team-surrounder":"shares the free cells beside adversaries with its teammates, and searches","careful-rando\
m":"as random, but takes only moves that right of way allows","careful-chaser":"as chaser, but takes only moves that right of way allows","careful-fleer":"as fl\
eer, but takes only moves that right of way allows","careful-clumsy-chaser":"as clumsy-chaser, but takes only moves that right of way allows","careful-hunter":"\
as hunter, but takes only moves that right of way allows","careful-surrounder":"as surrounder, but takes only moves that right of way allows","careful-clumsy-fl\
eer":"as clumsy-fleer, but takes only moves that right of way allows","careful-dodger":"as dodger, but takes only moves that right of way allows","careful-team-\
surrounder":"as team-surrounder, but takes only moves that right of way allows"},yr={free:".GS",blocked:"#@OTW"};var _e=1+mr.length;function rt(e,t){return e.replace(/\{(\w+)\}/g,(n,r)=>String(t[r]))}function J(e,t){return e<t?rt(hn[0],{number:e}):rt(hn[1],{number:e-t})}function oa(e,t){
let[n,r,o,s,a,i,l,...c]=Array.from(e),u=a<0?[s]:[s,a],[p,m,h]=c.map(v=>u.filter((x,b)=>v>>b&1)),f=u.map(v=>J(v,t)),y=rt(hr[a<0?"obstacle":mn[o]],{first:f[0],second:f[f.
length-1],cell:`(${i}, ${l})`}),g=rt(fr,{event:y,outcome:sa(u.length,m,h,t)});return{kind:tt[r],form:mn[o],agents:u,cell:[i,l],at_fault:p,held:m,doomed:h,turn:n,
text:g}}function sa(e,t,n,r){if(e===2&&t.length===2)return nt["both held"];if(e===2&&n.length===2)return nt["both doomed"];let o=s=>a=>rt(nt[s],{agent:J(a,r)});
return[...t.map(o("held")),...n.map(o("doomed"))].join(", ")||nt.none}function _t(e,t){let n=[];for(let r=0;r<e.length;r+=_e)n.push(oa(e.subarray(r+1,r+_e),t));
return n}var H=class extends Error{name="EngineError"};function P(e,t,n){let r=typeof n=="string"?`'${n}'`:typeof n=="object"?JSON.stringify(n):String(n);return new H(`${e}\
: expected ${t}, got ${r}`)}var Le=class{bytes;constructor(t){this.bytes=t}},br=0,gn=[Uint8Array,Uint8Array,Int32Array,BigInt64Array,BigUint64Array,Float32Array,Float64Array],gr=4,vr=4,aa=new TextEncoder,
ia=new TextDecoder;function la(e){for(let t=gn.length-1;t>br;--t)if(e instanceof gn[t])return t;throw new TypeError("array: expected a typed array of the engine\
's numbers, got another")}function yn(e){return new Uint8Array(e.buffer,e.byteOffset,e.byteLength)}function ca(e){return aa.encode(`${e}\0`)}var vn=class{engine;addresses=[];constructor(t){
this.engine=t}copy(t){let n=this.engine._malloc(Math.max(t.length,1));if(n===0)throw new H("memory: expected room for the arguments, got none");return this.addresses.
push(n),this.engine.HEAPU8.set(t,n),n}text(t){return this.copy(ca(t))}arrays(t){let n=Object.entries(t),r=n.flatMap(([s,a])=>{let i=a instanceof Le,l=i?a.bytes:
a;return[this.text(s),i?br:la(l),l.length,this.copy(yn(l))]}),o=this.copy(yn(Int32Array.from(r)));return this.copy(yn(Int32Array.of(n.length,o)))}free(){for(let t of this.
addresses)this.engine._free(t)}};function wr(e,t){let n=e.HEAPU8;return ia.decode(n.subarray(t,n.indexOf(0,t)))}function Pe(e){let t=new Int32Array(e.HEAPU8.buffer),
n=e._last_outputs()/gr,r=t[n+1]/gr,o={};for(let s=r;s<r+t[n]*vr;s+=vr){let a=gn[t[s+1]],i=t[s+2]*a.BYTES_PER_ELEMENT,l=t[s+3];o[wr(e,t[s])]=new a(e.HEAPU8.slice(
l,l+i).buffer)}return o}function me(e,t){let n=new vn(e);try{let r=t(n);if(r===0)throw new H(wr(e,e._last_error()));return r}finally{n.free()}}var ua=2**31-1,xr=["none","gru"],da=2n**64n-1n,pa=34028234663852886e22;function le(e,t){if(typeof t!="number"||!Number.isInteger(t)||Math.abs(t)>ua)throw P(e,"a\
n integer",t);return Int32Array.of(t)}function Lt(e,t){if(typeof t!="boolean")throw P(e,"true or false",t);return new Le(Uint8Array.of(Number(t)))}function we(e,t,n){
let r=typeof t=="string"&&Object.hasOwn(n,t)?n[t]:void 0;if(r===void 0)throw P(e,`one of ${Object.keys(n).join(", ")}`,t);return Int32Array.of(r)}function bn(e,t){
if(typeof t!="number"||!(Math.abs(t)<=pa))throw P(e,"a finite number",t);return t}function ot(e,t){let r=typeof t=="bigint"||typeof t=="number"&&Number.isSafeInteger(
t)?BigInt(t):-1n;if(r<0n||r>da)throw P(e,"an integer from 0 to 2^64 - 1",t);return BigUint64Array.of(r)}function ma(e){return{"rules.interaction":we("interactio\
n",e.interaction,ur),"rules.obstacle":we("obstacle",e.obstacle,et),"rules.teammate":we("teammate",e.teammate,et),"rules.evader":we("evader",e.evader,et),"rules.\
pursuer":we("pursuer",e.pursuer,et),"rules.capture":we("capture",e.capture,dr),"rules.captured_disappear":Lt("captured_disappear",e.captured_disappear)}}function Sr(e,t){
let n=typeof t=="number"?[t,t,t]:t;if(!Array.isArray(n)||n.length!==3)throw P(e,"1 or 3 numbers",t);return Float32Array.from(n,r=>bn(e,r))}function ha(e){let t=(n,r)=>Float32Array.
of(bn(n,e[n]),bn(r,e[r]));return{"rewards.capture":t("pursuer_capture","evader_capture"),"rewards.neighbor":t("pursuer_neighbor","evader_neighbor"),"rewards.ste\
p":t("pursuer_step","evader_step"),"rewards.pursuer_collide":Sr("pursuer_collide",e.pursuer_collide),"rewards.evader_collide":Sr("evader_collide",e.evader_collide),
"rewards.blame":we("blame",e.blame,pr),"rewards.capture_repeats":Lt("capture_repeats",e.capture_repeats)}}function Tr(e){if(e===void 0||typeof e=="number")return new Uint8Array(
0);if(e instanceof Uint8Array)return e;let{free:t,blocked:n}=yr;for(let[r,o]of e.entries()){if(o.length!==e[0]?.length)throw P(`map, row ${r}`,`${e[0]?.length} \
cells as in row 0`,o.length);let s=[...o].find(a=>!t.includes(a)&&!n.includes(a));if(s)throw P(`map, row ${r}`,`'${t}' (free) or '${n}' (obstacle)`,s)}return Uint8Array.
from([...e.join("")],r=>Number(n.includes(r)))}function Cr(e,t){if(!Array.isArray(e))return;let n=[e.length,e[0]?.length??0];if(!(n[0]===t.rows&&n[1]===t.cols))
throw P("obstacle map",`shape (${t.rows}, ${t.cols}), the rows and cols`,n)}function $e(e){Cr(e.obstacles,e);let t=typeof e.obstacles=="number"?e.obstacles:0;return{
...ma(e.rules),...ha(e.rewards),rows:le("rows",e.rows),cols:le("cols",e.cols),n_pursuers:le("n_pursuers",e.n_pursuers),n_evaders:le("n_evaders",e.n_evaders),fov:le(
"fov",e.fov),diagonal:Lt("diagonal",e.diagonal),max_steps:le("max_steps",e.max_steps),density:Float64Array.of(t),map:Tr(e.obstacles)}}function Ar(e,t){return Int32Array.
from((t??[]).flat(),n=>le(e,n)[0])}function Mr(e,t){return Cr(e.obstacles,t),{seed:ot("seed",e.seed??0n),episode:ot("episode",e.episode??0),pursuers:Ar("pursuer\
s",e.pursuers),evaders:Ar("evaders",e.evaders),map:Tr(e.obstacles)}}function Pt(e){return{actions:Int32Array.from(e,t=>le("actions",t)[0])}}function Ie(e){if(typeof e==
"string"){if(!Object.hasOwn(fn,e))throw P("policy",`one of ${Object.keys(fn).join(", ")}`,e);return{script:new TextEncoder().encode(e)}}if(e.activation!=="relu"&&
e.activation!=="tanh")throw P("activation","'relu' or 'tanh'",e.activation);if(!xr.includes(e.memory))throw P("memory",`one of ${xr.join(", ")}`,e.memory);return{
hidden:Int32Array.from(e.hidden,t=>le("hidden",t)[0]),activation:new TextEncoder().encode(e.activation),sampled:Lt("sampled",e.sampled),memory:new TextEncoder().
encode(e.memory),genome:e.genome}}var fa=["first_turn","terminated","truncated"];function Er(e){let t={...e};for(let n of fa)t[n]=new Le(e[n]);return t}var kr="statistics.",$t=class{config;seed;episode;n_agents;statistics;first_conflict;constructor(t,n,r,o){this.config=t,this.seed=n,this.episode=r,this.n_agents=
t.n_pursuers+t.n_evaders,this.statistics=ga(Or(o)),Object.assign(this,o),this.first_conflict=ya(this.conflict_table,this.length)}get length(){return this.actions.
length/this.n_agents}conflicts(t){this.check(t);let[n,r]=[this.first_conflict[t],this.first_conflict[t+1]],o=this.conflict_table.subarray(n*_e,r*_e);return _t(o,
this.config.n_pursuers)}seek(t,n,r){this.check(n),(!(t.seed===this.seed&&t.episode===BigInt(this.episode))||t.turn!==0||t.steps>n)&&t.reset({seed:this.seed,episode:this.
episode});for(let s=t.steps;s<n;++s){let a=this.actions.subarray(s*this.n_agents,(s+1)*this.n_agents);r?t.replay(a,{pursuer:r.pursuers,evader:r.evaders}):t.step(
a)}}check(t){if(!(Number.isInteger(t)&&t>=0&&t<=this.length))throw P("step",`0 to ${this.length}`,t)}};function ya(e,t){let n=new Int32Array(t+2);for(let r=0;r<
e.length;r+=_e)++n[e[r]+1];for(let r=1;r<n.length;++r)n[r]+=n[r-1];return n}function ga(e){let t=["capture_rate","ever_capture_rate","captured_fraction","length"];
return Object.fromEntries(Object.entries(e).map(([n,r])=>[n,t.includes(n)?Number(r[0]):r]))}var Or=e=>Object.fromEntries(Object.entries(e).flatMap(([t,n])=>t.startsWith(
kr)?[[t.slice(kr.length),n]]:[]));function Rr(e,t,n,r){let o=[$e(n.config),Ie(n.pursuers),Ie(n.evaders),r];return me(e,s=>{let[a,i,l,c]=o.map(u=>s.arrays(u));return e[t](
a,i,l,c)}),Pe(e)}function Nr(e,t,n,r){let o={seed:ot("seed",n),episode:ot("episode",r)};return new $t(t.config,n,r,Rr(e,"_play_match",t,o))}function _r(e,t,n,r){
if(!Number.isInteger(r)||r<1)throw P("n_episodes","at least 1",r);let o=Rr(e,"_play_rollout",t,{...n,n_episodes:Int32Array.of(r)});return Or(o)}var va=7e6,ba=new FinalizationRegistry(([e,t])=>e._states_free(t));function wa({rules:e,rows:t,cols:n,obstacles:r,diagonal:o,n_pursuers:s,n_evaders:a}){let i=typeof r==
"number"||e.obstacle==="REACH"?0:r.join("").split("#").length-1,l=t*n-i,c=[e.obstacle,e.teammate,e.pursuer].includes("DISAPPEAR"),u=e.capture==="SURROUND"||e.evader===
"REACH",p=e.interaction==="AGENT_TURNS",m=(y,g)=>Array.from({length:g},(v,x)=>p?y:(y+x)/(x+1)).reduce((v,x)=>v*x,1),h=m(l+Number(c),s)*m(l*(1+Number(u))+2,a);return{
SIMULTANEOUS:[s+a],SWARM_TURNS:[s,a],AGENT_TURNS:Array(s+a).fill(1)}[e.interaction].reduce((y,g)=>y+h*(o?9:5)**g,0)}function Ue(e){return typeof e.obstacles=="n\
umber"&&e.obstacles>0?"obstacles are drawn anew in each episode":wa(e)>va?"the world is too large to be solved on the page":""}var wn=class{value;teams;matrix;n_actions;constructor(t,n){
let{matrix:r,rows:o,cols:s,value:a,agents:i}=n,[l,c]=t.actors,u=Array.from(i).filter(m=>l<=m&&m<c),p=m=>m<t.config.n_pursuers;[this.value,this.matrix,this.n_actions]=
[a[0],r,t.n_actions],this.teams=[{agents:u.filter(p),play:o},{agents:u.filter(m=>!p(m)),play:s}]}marginal(t){let n=this.teams.find(({agents:s})=>s.includes(t));
if(!n)return null;let r=this.n_actions**(n.agents.length-1-n.agents.indexOf(t)),o=Array(this.n_actions).fill(0);return n.play.forEach((s,a)=>o[Math.floor(a/r)%this.
n_actions]+=s),o}lost(t){let[n,r]=this.teams.map(({agents:l})=>l.reduce((c,u)=>c*this.n_actions+t[u],0)),[o,s]=this.teams.map(({play:l})=>l),a=s.reduce((l,c,u)=>l+
c*this.matrix[n*s.length+u],0),i=o.reduce((l,c,u)=>l+c*this.matrix[u*s.length+r],0);return[Math.max(0,this.value-a),Math.max(0,i-this.value)]}},xn=60,st=class{config;payoff;engine;states;n_turns;values;constructor(t,n,r){
[this.engine,this.config,this.payoff]=[t,n,r],this.states=me(t,i=>t._states_new(i.arrays($e(n)))),ba.register(this,[t,this.states]);let o={SIMULTANEOUS:1,SWARM_TURNS:2,
AGENT_TURNS:n.n_pursuers+n.n_evaders};this.n_turns=o[n.rules.interaction];let{payoffs:s}=this.call(()=>t._states_payoffs(this.states)),a=s;this.values=[[r==="ca\
pture-rate"?a:a.fill(0)]]}goBack(){let t=this.values.at(-1)[0],n=[];for(let o=this.n_turns-1;o>=0;o--){let s=n[o+1]??t;n[o]=this.backup(o,{next:s})}this.payoff===
"capture-time"&&(n[0]=n[0].map((o,s)=>s===this.config.n_evaders?0:o-1)),this.values.push(n);let r=this.payoff==="capture-rate"?this.config.max_steps:Math.min(this.
config.max_steps,xn);return this.values.length<=r&&n[0].some((o,s)=>o!==t[s])}backup(t,n){return this.call(r=>this.engine._states_backup(this.states,t,r.arrays(
n))).values}game(t){let[n,{turn:r}]=[this.config.max_steps-t.steps,t],o=r+1===this.n_turns,s=n>0?this.values[Math.min(n-Number(o),this.values.length-1)]?.[o?0:r+
1]:void 0;if(!s)return null;let a=this.call(i=>this.engine._states_game(this.states,t.address,i.arrays({next:s})));return a.agents.length?new wn(t,a):null}call(t){
return me(this.engine,t),Pe(this.engine)}};var Lr=new FinalizationRegistry(([e,t])=>e._world_free(t)),at=class{config;n_agents;n_actions;engine;at;freed=!1;constructor(t,n){this.engine=t,this.config=n,this.
n_agents=n.n_pursuers+n.n_evaders,this.n_actions=n.diagonal?9:5,this.at=me(t,r=>t._world_new(r.arrays($e(n)))),Lr.register(this,[t,this.at],this)}free(){this.freed||
(this.freed=!0,Lr.unregister(this),this.engine._world_free(this.at))}get address(){if(this.freed)throw P("world","one that is in use","one that was freed");return this.
at}reset(t={}){let n=Mr(t,this.config);this.call(r=>this.engine._world_reset(this.address,r.arrays(n)))}step(t){let n=Pt(t);this.call(r=>this.engine._world_step(
this.address,r.arrays(n)))}playTurn(t){let n=Pt(t);this.call(r=>this.engine._world_play_turn(this.address,r.arrays(n)))}decide(t,n,r){let{n_pursuers:o}=this.config,
s={pursuer:[0,o],evader:[o,this.n_agents]},[a,i]=typeof n=="string"?s[n]:n;if(r.length!==this.n_agents)throw P("actions",String(this.n_agents),r.length);let l=[
Ie(t),Pt(r)],{actions:c}=this.call(u=>this.engine._world_decide(this.address,u.arrays(l[0]),a,i,u.arrays(l[1])));return Uint8Array.from(c)}replay(t,n){let r=s=>typeof s!=
"string"&&s.memory!=="none";if(!r(n.pursuer)&&!r(n.evader))return this.step(t);let{n_pursuers:o}=this.config;for(let s=this.n_turns;s>0;--s){let[a,i]=this.actors;
a<o&&this.decide(n.pursuer,[a,Math.min(i,o)],t),i>o&&this.decide(n.evader,[Math.max(a,o),i],t),this.playTurn(t)}}get n_turns(){return this.turnNumbers()[1]}get turn(){
return this.turnNumbers()[0]}get actors(){let[,,t,n]=this.turnNumbers();return[t,n]}turnNumbers(){return this.call(()=>this.engine._world_turn(this.address)).turn}get steps(){
return this.read("steps")[0]}get seed(){return this.read("seed")[0]}get episode(){return this.read("episode")[0]}get over(){return this.read("terminated")[0]===
1||this.read("truncated")[0]===1}read(t){return this.call(n=>this.engine._world_read(this.address,n.text(t)))[t]}view(t){let n=3*this.config.fov**2;return this.
read("views").slice(t*n,(t+1)*n)}map(){return this.read("state").slice(2*this.config.rows*this.config.cols)}conflicts(){return _t(this.conflictTable(),this.config.
n_pursuers)}conflictTable(){return this.call(()=>this.engine._world_conflicts(this.address)).conflict_table}answer(t,n){let r=Ie(t),{logits:o,memory:s}=this.call(
l=>this.engine._world_logits(this.address,l.arrays(r),n)),a=o,i=this.decide(t,[n,n+1],new Uint8Array(this.n_agents))[n];return{logits:a,probabilities:xa(a),action:i,
memory:s}}snapshot(){return this.call(()=>this.engine._world_snapshot(this.address))}restore(t){let n=Er(t);this.call(r=>this.engine._world_restore(this.address,
r.arrays(n)))}call(t){return me(this.engine,t),Pe(this.engine)}};function xa(e){let t=Math.max(...e),n=Array.from(e,o=>Math.exp(o-t)),r=n.reduce((o,s)=>o+s,0);return Float32Array.
from(n,o=>o/r)}var Sn=class{compiled;constructor(t){this.compiled=t}world(t){return new at(this.compiled,t)}solution(t,n="capture-rate"){return new st(this.compiled,t,n)}match(t,n,r,o,s=0){
return Nr(this.compiled,{config:t,pursuers:n,evaders:r},o,s)}rollouts(t,n,r,o,s){return _r(this.compiled,{config:t,pursuers:n,evaders:r},o,s)}},Pr;function $r(e=globalThis.
matrixworldEngine){return Pr??=Sa(e),Pr}async function Sa(e){if(!e)throw new Error("matrixworldEngine: expected the script engine.js before this one, got none");
let t=Uint8Array.from(atob(e.binary),n=>n.charCodeAt(0));return new Sn(await e({wasmBinary:t}))}var Aa="http://www.w3.org/2000/svg";function d(e,t={},...n){return Ir(document.createElement(e),t,n)}function xe(e,t={},...n){return Ir(document.createElementNS(
Aa,e),t,n)}function Ir(e,t,n){for(let[o,s]of Object.entries(t))s==null||s===!1||(typeof s=="function"?e.addEventListener(o.slice(2),s):e.setAttribute(o,s===!0?"":
String(s)));let r=n.filter(o=>o!=null&&o!==!1);return e.append(...r.map(o=>typeof o=="number"?String(o):o)),e}function it(e,t){let n=d("select",{onchange:()=>t(
n.value)},...e.map(([r,o])=>d("option",{value:r},o)));return n}async function Ur(e){try{await e}catch(t){throw(document.querySelector("#page, main")??document.body).
prepend(d("p",{class:"card problem",role:"alert"},`The page could not start: ${String(t)}`)),t}finally{document.body.dataset.ready="true"}}var lt=()=>["file:","\
http:","https:"].includes(location.protocol);var zr=()=>document.documentElement.dataset.theme==="dark",ct=e=>{document.documentElement.dataset.theme=e?"dark":"light"},An=()=>ct(!zr());if(typeof document<"\
u"){let e=matchMedia("(prefers-color-scheme: dark)");e.addEventListener("change",()=>ct(e.matches)),ct(e.matches);let t=!1;addEventListener("beforeprint",()=>{t=
zr(),ct(!1)}),addEventListener("afterprint",()=>ct(t))}function Br(){return d("button",{type:"button",title:"Light or dark (D)","aria-label":"Light or dark",onclick:An},
"◐")}var Dr=(e,t,...n)=>d("header",{class:"top"},d("div",{},d("h1",{},e),t?d("p",{class:"lead"},t):null),d("div",{class:"tools"},...n,Br()));var W=["stay","north","east","south","west","northeast","southeast","southwest","northwest"];var he="champion",Se=0,Ae=64,ze=100,Be=300,Tn=e=>({cell:e,gone:!1,captured:!1,everCaptured:!1}),ee=e=>[...e.pursuers,...e.evaders],G=e=>e.pursuers.length+e.evaders.
length,Cn=(e,t)=>t<e.pursuers.length?"pursuers":"evaders",te=(e,t)=>J(t,e.pursuers.length),Mn=(e,t)=>Object.keys(e).every(n=>e[n]===t[n]);function De(e,t){return Object.
keys(t).find(n=>Mn(t[n],e))??null}function We(e,t){let n=new Set(e.walls),r=Array.from({length:e.rows},(o,s)=>Array.from({length:e.cols},(a,i)=>n.has(s*e.cols+i)?
"#":".").join(""));return{rules:t,rows:e.rows,cols:e.cols,n_pursuers:e.pursuers.length,n_evaders:e.evaders.length,fov:e.fov,diagonal:e.diagonal,max_steps:e.maxSteps,
obstacles:r,rewards:e.rewards}}var It=(e,t,n)=>({...e,next:e.next.map((r,o)=>o===t?n:r)}),Wr=e=>({...e,played:[...e.played,e.next],next:e.next.map(t=>typeof t==
"number"?Se:t)}),Fr=e=>({...e,played:e.played.slice(0,-1),next:e.played.at(-1)??e.next});function En(e,t,n){let r=(o,s)=>o.map((a,i)=>i===s?{...a,cell:n}:a);return{
...e,pursuers:r(e.pursuers,t),evaders:r(e.evaders,t-e.pursuers.length)}}function jr(e,t,n){let r=t==="pursuers"?e.pursuers.length:G(e);return{...e,[t]:[...e[t],
Tn(n)],next:[...e.next.slice(0,r),Se,...e.next.slice(r)],ended:!1}}function Ut(e,t){let n=Cn(e,t),r=n==="pursuers"?t:t-e.pursuers.length;return{...e,[n]:e[n].filter(
(o,s)=>s!==r),next:e.next.filter((o,s)=>s!==t)}}function kn(e,t,n){let r=t[0]*e.cols+t[1],o=e.walls.filter(s=>s!==r);return{...e,walls:n?[...o,r].sort((s,a)=>s-
a):o}}function Hr(e,t,n){let r=([s,a])=>s<t&&a<n,o=ee(e).map(({cell:s})=>r(s));return{...e,rows:t,cols:n,walls:e.walls.map(s=>[Math.floor(s/e.cols),s%e.cols]).filter(
r).map(([s,a])=>s*n+a),pursuers:e.pursuers.filter((s,a)=>o[a]),evaders:e.evaders.filter((s,a)=>o[e.pursuers.length+a]),next:e.next.filter((s,a)=>o[a])}}function fe(e,[
t,n]){let r=ee(e).findIndex(({cell:o,gone:s})=>!s&&o[0]===t&&o[1]===n);return r<0?null:r}var ye=(e,[t,n])=>e.walls.includes(t*e.cols+n);function Gr(e){let t=Array.
from({length:e.rows*e.cols},(o,s)=>[Math.floor(s/e.cols),s%e.cols]),n=([o,s])=>Math.abs(o-(e.rows-1)/2)+Math.abs(s-(e.cols-1)/2),r=t.filter(o=>fe(e,o)===null&&!ye(
e,o));return r.length?r.reduce((o,s)=>n(s)<n(o)?s:o):null}var ut=class extends Error{},Te="_",Qr="n",Kr=2n**64n-1n,Vr=2e4,Yr=40,Ce={fov:11,maxSteps:500,rewards:"paper"},On=["rules","others","rewards","size","diagonal",
"fov","limit","seed","ended","walls","pursuers","evaders","played","next"];function N(e,t,n){let r=n.length>Yr?`${n.slice(0,Yr)}…`:n;throw new ut(`${e}: expec\
ted ${t}, got "${r}"`)}function Nn(e,t){let n=i=>i.map(l=>Ca(l,t)).join(""),r=i=>`${Math.floor(i/e.cols)}.${i%e.cols}`,o=Ta(e.rewards,t),s=[e.seed,e.episode,e.steps].
join("."),a={rules:qr(e.rules,t),others:e.others?qr(e.others,t):"",rewards:o===Ce.rewards?"":o,size:`${e.rows}x${e.cols}`,diagonal:e.diagonal?"1":"",fov:e.fov===
Ce.fov?"":String(e.fov),limit:e.maxSteps===Ce.maxSteps?"":String(e.maxSteps),seed:s==="0.0.0"?"":s,ended:e.ended?"1":"",walls:e.walls.map(r).join(Te),pursuers:e.
pursuers.map(Zr).join(Te),evaders:e.evaders.map(Zr).join(Te),played:e.played.map(n).join(Te),next:e.next.every(i=>i===Se)?"":n(e.next)};return On.filter(i=>a[i]).
map(i=>`${i}=${a[i]}`).join("&")}function Zr({cell:e,gone:t,captured:n,everCaptured:r}){let o=n?"c":r?"e":"";return`${e[0]}.${e[1]}${o}${t?"x":""}`}function qr(e,t){
let n=t.fields.map(({name:r})=>String(e[r]).toLowerCase());return De(e,t.variants)??n.join(".")}function Ta(e,t){let n=JSON.stringify(e);return Object.keys(t.rewards).
find(o=>JSON.stringify(t.rewards[o])===n)??Object.values(e).map(o=>String(o)).join(Te)}function Ca(e,t){if(typeof e=="number")return String(e);if(e===he)return Qr;
let n=t.scripts.findIndex(({name:r})=>r===e);return String.fromCharCode(97+n)}function dt(e,t){e.length>Vr&&N("link",`at most ${Vr} characters`,`${e.length} cha\
racters`);let n=Ma(e),r=(m,h="")=>n.get(m)??h,o=Xr("rules",r("rules"),t),[s,a]=Ea(r("size")),i=m=>Rn(r(m)).map(h=>ka(m,h,s,a)),[l,c,u]=_a(r("seed","0.0.0")),p={
rules:o,others:n.has("others")?Xr("others",r("others"),t):null,rewards:Ra(r("rewards",Ce.rewards),t),rows:s,cols:a,seed:l,episode:c,steps:u,diagonal:Jr("diagona\
l",r("diagonal","0")),fov:zt("fov",r("fov",String(Ce.fov)),1,255),maxSteps:zt("limit",r("limit",String(Ce.maxSteps)),1,2**31-1),ended:Jr("ended",r("ended","0")),
walls:Oa(r("walls"),s,a),pursuers:i("pursuers"),evaders:i("evaders"),played:[],next:[]};return La(p),Pa(p,Rn(r("played")),r("next"),t)}function Ma(e){let t=new Map;
for(let n of e.replace(/^#/,"").split("&").filter(Boolean)){let[r,o]=n.includes("=")?[n.slice(0,n.indexOf("=")),n.slice(n.indexOf("=")+1)]:[n,""];On.includes(r)||
N("link",`parts ${On.join(", ")}`,r),t.has(r)&&N(r,"it once","it twice"),t.set(r,o)}return t}var Rn=e=>e?e.split(Te):[];function zt(e,t,n,r){let o=/^\d{1,10}$/.
test(t)?Number(t):NaN;return o>=n&&o<=r||N(e,`a number from ${n} to ${r}`,t),o}function Jr(e,t){return t!=="0"&&t!=="1"&&N(e,"0 or 1",t),t==="1"}function Ea(e){
let[t,n,...r]=e.split("x");return(t===void 0||n===void 0||r.length)&&N("size","rows and columns, such as 4x6",e),[zt("size",t,1,Ae),zt("size",n,1,Ae)]}function eo(e,t,n,r){
let o=/^(\d{1,4})\.(\d{1,4})$/.exec(t),s=[Number(o?.[1]),Number(o?.[2])];return(!o||s[0]>=n||s[1]>=r)&&N(e,`cells of a ${n} x ${r} grid, such as 0.2`,t),s}function ka(e,t,n,r){
let o=/^(.*?)([ce]?)(x?)$/.exec(t),s=eo(e,o[1],n,r);return e==="pursuers"&&o[2]&&N(e,"no captured pursuer",t),{cell:s,gone:o[3]==="x",captured:o[2]==="c",everCaptured:o[2]!==
""}}function Oa(e,t,n){let r=Rn(e).map(o=>{let[s,a]=eo("walls",o,t,n);return s*n+a});return[...new Set(r)].sort((o,s)=>o-s)}function Xr(e,t,n){let r=Object.hasOwn(
n.variants,t)?n.variants[t]:void 0;if(r)return r;let o=t.split("."),s=`${Object.keys(n.variants).join(", ")} or ${n.fields.length} values joined by "."`;o.length!==
n.fields.length&&N(e,s,t);let a=n.fields.map(({name:i,values:l},c)=>{let u=l.find(p=>p.name.toLowerCase()===o[c])?.name;return u===void 0&&N(`${e}, ${i}`,l.map(
p=>p.name.toLowerCase()).join(" or "),o[c]),[i,u==="true"?!0:u==="false"?!1:u]});return Object.fromEntries(a)}function Ra(e,t){if(Object.hasOwn(t.rewards,e))return t.
rewards[e];let n=Object.entries(t.rewards[Ce.rewards]),r=e.split(Te);return r.length!==n.length&&N("rewards",`${Object.keys(t.rewards).join(", ")} or ${n.length}\
 values`,e),Object.fromEntries(n.map(([o,s],a)=>[o,Na(o,r[a],s)]))}function Na(e,t,n){if(e==="blame"&&(t==="FAULT"||t==="INVOLVED"))return t;if(typeof n=="boole\
an"&&(t==="true"||t==="false"))return t==="true";let r=t.split(",").map(a=>/^-?[\d.]+(e[+-]?\d+)?$/i.test(a)?Number(a):NaN),o=e.endsWith("_collide")?[1,3]:[1];return(typeof n!=
"number"||!o.includes(r.length)||!r.every(a=>Math.abs(a)<34e37))&&N(`rewards, ${e}`,`a value like ${n}`,t),r.length===1?r[0]:r}function _a(e){let t=/^(\d{1,20})\.(\d{1,20})\.(\d{1,9})$/.
exec(e);if(!t)return N("seed","seed.episode.steps, such as 0.0.0",e);let[n,r]=[BigInt(t[1]),BigInt(t[2])];return(n>Kr||r>Kr)&&N("seed","numbers below 2^64",e),[
n,r,Number(t[3])]}function La(e){for(let t of["pursuers","evaders"]){let n=e[t].length;(n<1||n>ze)&&N(t,`1 to ${ze} agents`,`${n}`)}e.fov%2===0&&N("fov","an odd\
 number",String(e.fov)),e.steps>e.maxSteps&&N("seed",`at most ${e.maxSteps} steps`,String(e.steps))}function Pa(e,t,n,r){let o=ee(e).length;t.length>Be&&N("play\
ed",`at most ${Be} steps`,`${t.length} steps`);let s=a=>i=>(i.length!==o&&N(a,`${o} characters, one for each agent`,i),[...i].map(l=>$a(a,l,e.diagonal?9:5,r)));
return{...e,played:t.map(s("played")),next:n?s("next")(n):Array(o).fill(Se)}}function $a(e,t,n,r){let o=/^\d$/.test(t)?Number(t):NaN;if(o<n)return o;if(t===Qr&&
r.champions)return he;let s=r.scripts[t.charCodeAt(0)-97],a=String.fromCharCode(97+r.scripts.length-1);return s?.name??N(e,`actions 0 to ${n-1} or scripts a to ${a}`,
t)}var pt=[.5,1,2,4,8,16,32,64],to=0,Bt=12,Ia=2,Fe=class extends EventTarget{#e;#n;#t;#r=0;#o=0;#s=!1;#i=null;#h=0;#c=[];#m=[];glide=.28;constructor(t,n={}){super(),
this.#e=t,this.#n=n.speed??4,this.#t=n.still??!1}get step(){return this.#r}get time(){return this.#t?this.#r:this.#o}get arrived(){return this.#o===this.#r}get playing(){
return this.#s}get length(){return this.#e}set length(t){this.#e=t,this.#r>t&&this.jump(t),this.#a("state")}get marks(){return this.#c}set marks(t){this.#c=t,this.#a(
"state")}get ticks(){return this.#m}set ticks(t){this.#m=t,this.#a("state")}get pace(){return this.#n||Math.max(Ia,this.#e/Bt)}get speed(){return this.#n}set speed(t){
this.#n=t,this.#a("state")}changeSpeed(t){let n=pt.findIndex(r=>r>=this.pace);this.speed=pt[Math.min(pt.length-1,Math.max(0,n+t))]}play(){this.#s||!this.#e||(this.#r===
this.#e&&this.jump(0),this.#s=!0,this.#a("state"),this.#u())}pause(){this.#s&&(this.#s=!1,this.#a("state"))}toggle(){this.#s?this.pause():this.play()}move(t){this.
pause();let n=Math.min(this.#e,Math.max(0,this.#r+t));Math.abs(n-this.#o)>1?this.jump(n):this.#d(n),this.#u()}jump(t){this.#o=Math.min(this.#e,Math.max(0,Math.round(
t))),this.#d(this.#o),this.#a("frame")}#d(t){t!==this.#r&&(this.#r=t,this.#a("step"),this.#t&&this.#a("frame"))}#u(){this.#i===null&&(this.#h=performance.now(),
this.#i=requestAnimationFrame(()=>this.#f()))}#f(){this.#i=null;let t=performance.now();this.#l(Math.min(.25,(t-this.#h)/1e3)),this.#h=t,(!this.#t||this.arrived)&&
this.#a("frame"),(this.#s||this.#o!==this.#r)&&(this.#i=requestAnimationFrame(()=>this.#f()))}#l(t){let n=t;for(;n>0;){if(this.#o===this.#r){if(!this.#s)return;
if(this.#r===this.#e)return this.pause();this.#d(this.#r+1)}let r=this.#s?this.pace:1/this.glide,o=this.#r-this.#o,s=Math.min(Math.abs(o),n*r);n-=s/r,this.#o=s===
Math.abs(o)?this.#r:this.#o+Math.sign(o)*s}this.#s&&this.#o===this.#e&&this.pause()}#a(t){this.dispatchEvent(new Event(t))}};function Dt(e,t){if(t.ctrlKey||t.metaKey||
t.altKey)return!1;let n=t.shiftKey?10:1,o={" ":()=>e.toggle(),ArrowRight:()=>e.move(n),ArrowLeft:()=>e.move(-n),Home:()=>e.move(-e.length),End:()=>e.move(e.length),
"+":()=>e.changeSpeed(1),"-":()=>e.changeSpeed(-1)}[t.key];return o?.(),o!==void 0}var ce=[[0,0],[-1,0],[0,1],[1,0],[0,-1],[-1,1],[1,1],[1,-1],[-1,-1]];function mt(e,t,n){let[r,o]=[t[0]-e[0],t[1]-e[1]];return!n&&Math.abs(r)>Math.abs(o)?o=0:n||
(r=0),ce.findIndex(([s,a])=>s===Math.sign(r)&&a===Math.sign(o))}var Me=(e,t)=>t<e.nPursuers,C=(e,t)=>[e.positions[2*t],e.positions[2*t+1]],Ua=(e,t)=>e[0]===t[0]&&
e[1]===t[1],ht=({rows:e,cols:t},[n,r])=>n>=0&&r>=0&&n<e&&r<t,_n=(e,t,n=3)=>e!==void 0&&[0,1,2].slice(0,n).some(r=>e[3*t+r]),Ln=(e,t)=>_n(e.fault,t),no=(e,t)=>!Ln(
e,t)&&_n(e.involved,t,2);function Wt(e,t,n){let r=!Ua(C(e,n),C(t,n)),o=t.involved===void 0||_n(t.involved,n);return!!(t.alive[n]&&t.actions?.[n]&&!r&&o)}function Ft(e,t,n){
let[r,o]=C(e,n),[s,a]=ce[t.actions?.[n]??0];return[r+s,o+a]}function jt(e,t,n){return Array.from({length:n.everCaptured.length},(o,s)=>s).filter(o=>n.everCaptured[o]&&
!t.everCaptured[o]).map(o=>e.nPursuers+o)}function Ht(e,t){return Array.from({length:t.alive.length},(r,o)=>o).filter(r=>e.alive[r]&&!t.alive[r])}var ro=[-.31,0,.31],oo=[{size:1,at:[[0,0]]},{size:.62,at:[[-.2,.2],[.2,-.2]]},{size:.54,at:[[-.23,.22],[.23,.22],[0,-.22]]},{size:.54,at:[[-.23,.23],[.23,.23],[
-.23,-.23],[.23,-.23]]},{size:.36,at:ro.flatMap(e=>ro.map(t=>[t,e]))}],za=.3,Ba=.35,Da=.55;function ft(e,t){let n=new Map;for(let r=0;r<t.alive.length;r++){if(!t.
alive[r])continue;let[o,s]=C(t,r),a=o*e.cols+s,i=n.get(a);i?i.push(r):n.set(a,[r])}return n}function so(e,t){let n=Array.from(t.alive,(r,o)=>{let[s,a]=C(t,o);return{
x:a+.5,y:s+.5,size:1,alpha:0}});for(let r of ft(e,t).values()){let o=oo[Math.min(r.length,oo.length)-1];r.forEach((s,a)=>{let[i,l]=o.at[Math.min(a,o.at.length-1)],
c=n[s];c.x+=i,c.y+=l,c.size=o.size,c.alpha=1})}return n}var ao=e=>e*e*(3-2*e),je=(e,t,n)=>e+(t-e)*n,io=e=>Math.min(1,Math.max(0,e));function lo(e,t,n,r){let o={
SIMULTANEOUS:1,SWARM_TURNS:2,AGENT_TURNS:n}[e.interaction];if(o===1)return ao(r);let s=o===n?t:+!Me(e,t),a=Math.max(1/o,Ba);return ao(io((r-s/(o-1)*(1-a))/a))}function Gt(e,t){
let n=e.moments.length-1,r=Math.min(Math.floor(t),n),o=e.moments[r],s=so(e,o);if(r===n||t===r)return s;let a=e.moments[r+1],i=so(e,a);return s.map((l,c)=>{let u=lo(
e,c,s.length,t-r);return Wa(o,a,c,l,i[c],u)})}function Pn(e,t,n){let r=e.moments.length-1,o=Math.min(Math.floor(n),r),[s,a]=[e.moments[o],e.moments[Math.min(o+1,
r)]],i=lo(e,t,s.alive.length,n-o),[[l,c],[u,p]]=[C(s,t),C(a,t)];return[je(c,p,i)+.5,je(l,u,i)+.5]}function Wa(e,t,n,r,o,s){let a=r.alpha>o.alpha,i={x:je(r.x,o.x,
s),y:je(r.y,o.y,s),size:a?r.size:je(r.size,o.size,s),alpha:a?io((1-s)/(1-Da)):je(r.alpha,o.alpha,s)};if(Wt(e,t,n)){let[l,c]=C(e,n),[u,p]=Ft(e,t,n),m=za*Math.sin(
Math.PI*s);i.x+=(p-c)*m,i.y+=(u-l)*m}return i}var co=2*Math.PI;function yt(e,t,n,r){e.beginPath(),e.arc(t,n,r/2,0,co)}function uo(e,t,n,r){let o=r/2,s=[[0,-.97],[.97,.83],[-.97,.83]].map(([a,i])=>[t+a*o,n+i*
o]);e.beginPath(),e.moveTo((s[2][0]+s[0][0])/2,(s[2][1]+s[0][1])/2),s.forEach(([a,i],l)=>{let[c,u]=s[(l+1)%3];e.arcTo(a,i,c,u,r*.09)}),e.closePath()}function po(e,t,n,r){
let o=r*.32;e.beginPath(),e.moveTo(t-o,n-o),e.lineTo(t+o,n+o),e.moveTo(t+o,n-o),e.lineTo(t-o,n+o)}function mo(e,t,n,r){e.beginPath();for(let o=0;o<16;o++){let s=r/
2*(o%2?.6:.95),a=co*o/16;e.lineTo(t+s*Math.sin(a),n-s*Math.cos(a))}e.closePath()}function ho(e,t,n,r,o,s){let a=Math.atan2(o-n,r-t);e.beginPath(),e.moveTo(t,n),
e.lineTo(r,o);for(let i of[-1,1])e.moveTo(r,o),e.lineTo(r-s*Math.cos(a+i*.6),o-s*Math.sin(a+i*.6))}var fo=4,Fa=1.6,ja=.95,Ha=5,Ga=.16,Ka=9,Va=.09,Ya=.2,yo=.75,X=(e,t)=>e.left+t*e.cell,Q=(e,t)=>e.top+t*e.cell;function He(e,t,n){return Me(t,n)?e.colors.pursuer:
e.colors.evader}function go({ctx:e,grid:t,colors:n}){let{left:r,top:o,cell:s,rows:a,cols:i}=t,[l,c]=[i*s,a*s];if(e.fillStyle=n.paper,e.fillRect(r,o,l,c),s<Ha)return;
e.fillStyle=n.line;let u=Math.max(1,Math.round(s/60));for(let p=1;p<i;p++)e.fillRect(r+p*s,o,u,c);for(let p=1;p<a;p++)e.fillRect(r,o+p*s,l,u)}function vo({ctx:e,
grid:t,colors:n},r){let{left:o,top:s,cell:a,rows:i,cols:l}=t;e.fillStyle=n.obstacle;for(let c=0;c<i*l;c++){if(!r.obstacles[c])continue;let[u,p]=[Math.floor(c/l),
c%l];e.fillRect(o+p*a,s+u*a,a,a)}bo({ctx:e,grid:t,colors:n})}function bo({ctx:e,grid:{left:t,top:n,cell:r,rows:o,cols:s},colors:a}){let i=Math.min(5,Math.max(2,
Math.round(r/18)));e.strokeStyle=a.frame,e.lineWidth=i,e.strokeRect(t-i/2,n-i/2,s*r+i,o*r+i)}function wo({ctx:e,grid:t,colors:n},r){let{left:o,top:s,cell:a,rows:i,
cols:l}=t,c=a<24*r?5:1;e.font=`500 ${Math.round(Math.min(15*r,Math.max(9*r,a*.32)))}px system-ui, sans-serif`,e.fillStyle=n.muted,e.textBaseline="alphabetic",e.
textAlign="center";let u=5*r+a/40;for(let p=0;p<l;p+=c)e.fillText(String(p),o+(p+.5)*a,s-u);e.textAlign="right",e.textBaseline="middle";for(let p=0;p<i;p+=c)e.fillText(
String(p),o-u,s+(p+.5)*a)}function xo({grid:e},t,n,r){let o=Math.floor(t.fov/2)+.5,[s,a]=[Math.max(0,n-o),Math.min(e.cols,n+o)],[i,l]=[Math.max(0,r-o),Math.min(
e.rows,r+o)];return[X(e,s),Q(e,i),(a-s)*e.cell,(l-i)*e.cell]}function So(e,t,n,r){let{ctx:o,grid:s,colors:a}=e;o.save(),o.beginPath(),o.rect(0,0,o.canvas.width,
o.canvas.height),o.rect(...xo(e,t,n,r)),o.clip("evenodd"),o.clearRect(0,0,o.canvas.width,o.canvas.height),o.fillStyle=a.line,o.fillRect(s.left,s.top,s.cols*s.cell,
s.rows*s.cell),o.restore(),bo(e)}function Ao({ctx:e,grid:t,colors:n},{x:r,y:o,alpha:s},a){let i=Math.max(t.cell,16*a)*1.06,[l,c]=[X(t,r),Q(t,o)];e.globalAlpha=Math.
max(s,.6),e.beginPath(),e.roundRect(l-i/2,c-i/2,i,i,i*.2),e.strokeStyle=n.focus,e.lineWidth=Math.max(2,2.5*a),e.stroke();let u=Math.max(11*a,Math.min(18*a,t.cell*
.5));e.font=`700 ${Math.round(u)}px system-ui, sans-serif`,e.textAlign="center",e.textBaseline="middle";let p=c-i/2<u*1.2,m=c+(p?1:-1)*(i/2+u*.7);e.strokeStyle=
n.paper,e.lineJoin="round",e.lineWidth=u*.35,e.strokeText("You",l,m),e.fillStyle=n.ink,e.fillText("You",l,m),e.globalAlpha=1}function To(e,t,n,r,o){let{ctx:s,grid:a}=e,
i=xo(e,t,r,o),l=He(e,t,n);s.globalAlpha=.11,s.fillStyle=l,s.fillRect(...i),s.globalAlpha=.8,s.strokeStyle=l,s.lineWidth=Math.max(1,a.cell/24),s.strokeRect(...i),
s.globalAlpha=1}function Co(e,t,n,r,o){let{ctx:s,grid:a}=e,i=Math.min(Math.ceil(n),t.moments.length-1),l=t.moments[i];s.lineCap="round",s.lineWidth=Math.min(Ka,
Math.max(1,a.cell*Ga));for(let c=Math.max(1,Math.floor(n-r)+1);c<=i;c++){let[u,p]=[t.moments[c-1],t.moments[c]],m=Math.max(0,Math.min(1,(n-c)/r));s.globalAlpha=
yo+(Ya-yo)*m;for(let h=0;h<p.alive.length;h++){let f=c===i&&n<i;if(!u.alive[h]||!(l.alive[h]||f))continue;let y=(Me(t,h)?-1:1)*Va,[g,v]=C(u,h),[x,b]=C(p,h);if(g===
x&&v===b)continue;let A=f?o[h].x:b+.5,E=f?o[h].y:x+.5;s.strokeStyle=He(e,t,h),s.beginPath(),s.moveTo(X(a,v+.5+y),Q(a,g+.5+y)),s.lineTo(X(a,A+y),Q(a,E+y)),s.stroke()}}
s.globalAlpha=1}function Mo(e,t,n){let r=Math.min(Math.ceil(n),t.moments.length-1);for(let o=Math.max(1,r-fo+1);o<=r;o++){let[s,a]=[t.moments[o-1],t.moments[o]],
i=o>n?Math.max(0,1-2*(o-n)):1-(n-o)/fo,l=jt(t,s,a);for(let c of Ht(s,a))l.includes(c)||qa(e,C(a,c),i);for(let c of l)Za(e,C(a,c),i)}e.ctx.globalAlpha=1}function Za({
ctx:e,grid:t,colors:n},[r,o],s){e.globalAlpha=s,mo(e,X(t,o+.5),Q(t,r+.5),Math.max(8,t.cell*Fa)),e.fillStyle=n.capture,e.fill(),e.strokeStyle=n.ink,e.lineWidth=Math.
max(1,t.cell/36),e.lineJoin="round",e.stroke()}function qa({ctx:e,grid:t,colors:n},[r,o],s){e.globalAlpha=s,po(e,X(t,o+.5),Q(t,r+.5),Math.max(7,t.cell*ja)),e.strokeStyle=
n.collision,e.lineWidth=Math.max(2,t.cell*.17),e.lineCap="round",e.stroke()}function Eo({ctx:e,grid:t,colors:n},r,o){let s=Math.max(1,t.cell*.07);e.strokeStyle=
e.fillStyle=n.collision,e.lineWidth=Math.max(1,t.cell*.05),e.setLineDash([t.cell*.14,t.cell*.1]);for(let[a,i]of r){if(a<0||i<0||a>=t.rows||i>=t.cols)continue;let l=[
X(t,i)+s,Q(t,a)+s,t.cell-2*s,t.cell-2*s];e.globalAlpha=.2*o,e.fillRect(...l),e.globalAlpha=o,e.strokeRect(...l)}e.setLineDash([]),e.globalAlpha=1}function ko({ctx:e,
grid:t,colors:n},r,o,s,a){e.globalAlpha=a,yt(e,X(t,r),Q(t,o),Math.max(8,t.cell*s*1.02)),e.strokeStyle=n.collision,e.lineWidth=Math.max(1.5,t.cell*.085*Math.sqrt(
s)),e.stroke(),e.globalAlpha=1}var Ja=.8,Xa=.92,Qa=15,ei=7,$n=9;function Oo(e,t,n,r,o,s){r.forEach((a,i)=>{a.alpha>0&&ti(e,t,n,i,a,o,s)}),e.ctx.globalAlpha=1;for(let a of ft(t,n).values())a.length>
$n&&ni(e,r[a[$n-1]],a.length-$n+1)}function ti(e,t,n,r,o,s,a){let{ctx:i,grid:l,colors:c}=e,u=Me(t,r),[p,m]=[l.left+o.x*l.cell,l.top+o.y*l.cell],h=Math.max(4,l.cell*
o.size*(u?Xa:Ja)),f=He(e,t,r),y=!u&&!!n.captured[r-t.nPursuers];if(i.globalAlpha=o.alpha,(u?uo:yt)(i,p,m,h),h>ei*a&&(i.strokeStyle=c.paper,i.lineWidth=Math.max(
2,h*.1),i.stroke()),i.fillStyle=y?c.paper:f,i.fill(),y&&(yt(i,p,m,h*.82),i.strokeStyle=f,i.lineWidth=h*.18,i.stroke()),!s||h<Qa*a)return;let g=String(u?r:r-t.nPursuers);
i.font=`700 ${Math.round(h*(u?.4:.5)*(g.length>1?.8:1))}px system-ui, sans-serif`,i.textAlign="center",i.textBaseline="middle",i.fillStyle=y?f:c.paper,i.fillText(
g,p,m+h*(u?.17:.03))}function ni({ctx:e,grid:t,colors:n},r,o){let[s,a]=[t.left+r.x*t.cell,t.top+r.y*t.cell];e.font=`700 ${Math.round(t.cell*.3)}px system-ui, sa\
ns-serif`,e.textAlign="center",e.textBaseline="middle",e.strokeStyle=n.paper,e.lineWidth=t.cell*.1,e.strokeText(`+${o}`,s,a),e.fillStyle=n.ink,e.fillText(`+${o}`,
s,a)}var ri=.46,oi=.86,si=.66,Ro=.48,ai=.78,ii=.58;function No(e,t,n,r){let[o,s]=[t.moments[n-1],t.moments[n]];if(!o)return;let{ctx:a,grid:i,colors:l}=e;a.strokeStyle=
l.collision,a.lineWidth=Math.max(1.5,i.cell*.07),a.lineCap="butt",a.globalAlpha=r;for(let c=0;c<s.alive.length;c++)Wt(o,s,c)&&li(e,t,C(o,c),Ft(o,s,c));a.globalAlpha=
1}function li({ctx:e,grid:t},n,r,o){let[s,a]=[o[1]-r[1],o[0]-r[0]],i=p=>X(t,r[1]+.5+s*p),l=p=>Q(t,r[0]+.5+a*p),c=ht(n,o)?ai:ii;e.setLineDash([t.cell*.09,t.cell*
.06]),e.beginPath(),e.moveTo(i(Ro),l(Ro)),e.lineTo(i(c),l(c)),e.stroke(),e.setLineDash([]);let u=.17*t.cell/Math.hypot(s,a);e.beginPath(),e.moveTo(i(c)-a*u,l(c)+
s*u),e.lineTo(i(c)+a*u,l(c)-s*u),e.stroke()}function _o(e,t,n,r,o,s){let a=ce[s];if(!s||!a)return;let{ctx:i,grid:l,colors:c}=e,u=ht(t,[r[0]+a[0],r[1]+a[1]])?oi:
si,p=ri*o.size,m=[X(l,o.x+a[1]*p),Q(l,o.y+a[0]*p),X(l,o.x+a[1]*u),Q(l,o.y+a[0]*u)],h=Math.max(1.5,l.cell*.085);i.lineCap=i.lineJoin="round";for(let[f,y]of[[c.paper,
h*2.1],[He(e,t,n),h]])i.strokeStyle=f,i.lineWidth=y,ho(i,...m,l.cell*.2),i.stroke()}var Po={numbers:!0,axes:!1,trail:6,viewers:[],plan:null,selected:null,cursor:null,you:null,fog:!1};function $o(e,t,n,r,o){let{ctx:s,grid:a,colors:i}=e,l=Math.min(
Math.ceil(n),t.moments.length-1),c=t.moments[l],u=n===l,p=Gt(t,n),m=u?1:Math.max(0,1-2*(l-n));s.clearRect(0,0,s.canvas.width,s.canvas.height),go(e);for(let y of r.
viewers)p[y]?.alpha&&To(e,t,y,...Pn(t,y,n));vo(e,t),r.axes&&wo(e,o),Co(e,t,n,r.trail,p),Eo(e,c.contested??[],m),Mo(e,t,n),No(e,t,l,m),p.forEach(({x:y,y:g,size:v},x)=>{
let b=no(c,x)?.4:0,A=Ln(c,x)?1:b;A&&ko(e,y,g,v,A*m)});let h=u?c:t.moments[Math.max(0,l-1)];if(Oo(e,t,h,p,r.numbers,o),u&&r.plan)for(let[y,g]of p.entries())g.alpha&&
_o(e,t,y,C(c,y),g,r.plan[y]??0);r.you!==null&&(r.fog&&So(e,t,...Pn(t,r.you,n)),Ao(e,p[r.you],o)),s.lineWidth=Math.max(2,2.5*o),s.strokeStyle=i.focus;let f=r.selected===
null?void 0:p[r.selected];f?.alpha&&Lo(e,f.x,f.y,f.size*.96),r.cursor&&(s.setLineDash([a.cell*.12,a.cell*.08]),Lo(e,r.cursor[1]+.5,r.cursor[0]+.5,.8),s.setLineDash(
[]))}function Lo({ctx:e,grid:t},n,r,o){let s=o*t.cell;e.beginPath(),e.roundRect(t.left+n*t.cell-s/2,t.top+r*t.cell-s/2,s,s,s*.1),e.stroke()}var Io=(e,t)=>(t+.24)/(e+.24);function Uo(e,t,n,r,o,s){let a=n?28*s:0,i=(c,u)=>(c-a)/(u+2*.12),l=Math.max(1,Math.floor(Math.min(i(r,t),i(o,e))));return{rows:e,cols:t,
cell:l,left:Math.round((r-t*l+a)/2),top:Math.round((o-e*l+a)/2)}}function zo(e,t,n){let r=Math.floor((n-e.top)/e.cell),o=Math.floor((t-e.left)/e.cell);return r>=
0&&r<e.rows&&o>=0&&o<e.cols?[r,o]:null}var ci={paper:"--board-paper",line:"--board-line",frame:"--board-frame",ink:"--board-ink",muted:"--board-muted",obstacle:"--board-obstacle",pursuer:"--pursuer",
evader:"--evader",capture:"--capture",collision:"--collision",focus:"--focus"};function Bo(e){let t=getComputedStyle(e),n=Object.entries(ci).map(([r,o])=>[r,t.getPropertyValue(
o).trim()]);return Object.fromEntries(n)}var gt=()=>matchMedia("(prefers-reduced-motion: reduce)").matches,Ge=class{canvas;#e=null;#n=0;#t;#r={rows:1,cols:1,left:0,top:0,cell:1};#o=0;constructor(t,n={}){
this.canvas=t,t.classList.add("board"),t.setAttribute("role","img"),this.#t={...Po,...n},new ResizeObserver(()=>this.#i()).observe(t),new MutationObserver(()=>this.
redraw()).observe(document.documentElement,{attributes:!0}),addEventListener("beforeprint",()=>this.drawNow())}get look(){return this.#t}set look(t){this.#t={...this.#t,
...t},this.#s(),this.redraw()}show(t,n){this.#e=t,this.#n=Math.min(Math.max(0,n),t.moments.length-1),this.#s(),this.redraw()}redraw(){this.#o||(this.#o=requestAnimationFrame(
()=>this.drawNow()))}drawNow(){cancelAnimationFrame(this.#o),this.#o=0;let t=this.canvas.getContext("2d");if(!t||!this.#e)return;let{rows:n,cols:r}=this.#e,o=devicePixelRatio||
1;this.#r=Uo(n,r,this.#t.axes,this.canvas.width,this.canvas.height,o);let s={ctx:t,grid:this.#r,colors:Bo(this.canvas)};$o(s,this.#e,this.#n,this.#t,o)}cellAt(t,n){
let r=this.canvas.getBoundingClientRect(),o=this.canvas.width/r.width;return zo(this.#r,(t-r.left)*o,(n-r.top)*o)}agentAt(t,n){let r=this.cellAt(t,n);if(!r||!this.#e)
return null;let o=this.#e.moments[Math.round(this.#n)],s=ft(this.#e,o).get(r[0]*this.#e.cols+r[1])??[],a=Gt(this.#e,Math.round(this.#n)),i=l=>{let[c,u]=this.pointOf(
a[l].x,a[l].y);return Math.hypot(c-t,u-n)};return s.length?s.reduce((l,c)=>i(c)<i(l)?c:l):null}pointOf(t,n){let r=this.canvas.getBoundingClientRect(),o=r.width/
this.canvas.width,{left:s,top:a,cell:i}=this.#r;return[r.left+(s+t*i)*o,r.top+(a+n*i)*o]}#s(){if(!this.#e)return;let{rows:t,cols:n}=this.#e;this.canvas.style.setProperty(
"--board-aspect",String(Io(t,n)))}#i(){let t=devicePixelRatio||1,{width:n,height:r}=this.canvas.getBoundingClientRect();this.canvas.width=Math.max(1,Math.round(
n*t)),this.canvas.height=Math.max(1,Math.round(r*t)),this.drawNow()}};function Kt(e,t,n){return{rows:e.rows,cols:e.cols,nPursuers:e.n_pursuers,fov:e.fov,interaction:e.rules.interaction,obstacles:t,moments:n}}function vt(e,t){return{
positions:e.read("last_positions"),alive:e.read("alive"),captured:e.read("captured"),everCaptured:e.read("ever_captured"),actions:t,involved:e.read("involved"),
fault:e.read("fault"),contested:e.conflicts().map(n=>n.cell)}}var In=.005,Wo=.05,ui=["pursuer","evader"],di=4,Ke=new Map;function Vt(e,t,n="capture-rate"){let r=JSON.stringify([{...t,rewards:null},n]),o=Ke.get(r)??(Ue(t)?Promise.
resolve(null):pi(e,t,n));return Ke.delete(r),Ke.set(r,o),Ke.size>di&&Ke.delete([...Ke.keys()][0]),o}var Yt=({n_evaders:e})=>e===1?"capture-time":"capture-rate",
Do=()=>new Promise(e=>setTimeout(e));async function pi(e,t,n){await Do();let r=e.solution(t,n);for(;r.goBack();)await Do();return r}function Zt(e,t,n){let{payoff:r}=e;
return n.flatMap((o,s)=>{let a=[0,0];for(let l=t.n_turns;l>0&&!t.over;l--)e.game(t)?.lost(o).forEach((c,u)=>a[u]+=c),t.playTurn(o);let i=r==="capture-rate"?In:Wo;
return ui.map((l,c)=>({step:s+1,team:l,lost:a[c],payoff:r})).filter(l=>l.lost>=i)})}var Fo=e=>e.map(t=>({step:t.step,kind:t.team,size:t.lost/Math.max(1,...e.map(
({lost:n})=>n)),text:bt(t)})),jo=({lost:e,payoff:t})=>t==="capture-rate"?`${e.toFixed(2)} of the capture rate`:`${e.toFixed(1)} steps`,bt=e=>`The ${e.team}s los\
e ${jo(e)} against a perfect opponent`;function Ho(e){let t=e.reduce((n,r)=>r.lost>n.lost?r:n);return`Your team's worst moves, in step ${t.step}, lost ${jo(t)} \
against a perfect opponent.`}function qt({config:e,payoff:t},{value:n},r){if(t==="capture-rate")return`value ${n.toFixed(2)}`;let[o,s]=[1-n,Math.min(e.max_steps-
r,xn)];return o>s-Wo?`free for ${s} steps`:`captured after ${o.toFixed(1)} steps`}function Jt(e,t){return(e.marginal(t)??[]).map((r,o)=>({share:r,action:o})).filter(
({share:r})=>r>=In).sort((r,o)=>o.share-r.share).map(({share:r,action:o})=>r>1-In?W[o]:`${W[o]} ${r.toFixed(2)}`).join(", ")}var Xt=class{recording;rules;outcomes=[];#e;#n;#t;#r=[];#o=[];constructor(t,n,r,o){this.#e=n,this.#n=o,this.rules=r;let s=We(n,r);this.#t=t.world(s),this.#t.restore(
mi(this.#t,n)),this.recording=Kt(s,this.#t.map(),this.#r),this.#i(void 0);for(let a of n.played)this.#s(a)}follow(t){if(!Un(this.#e,t))return!1;let n=this.#e.played,
r=t.played.findIndex((a,i)=>a!==n[i]),o=r<0?t.played.length:r,s=Math.min(o+1,this.#r.length);this.#r.length=this.outcomes.length=this.#o.length=s,this.#t.restore(
this.#o.at(-1));for(let a of t.played.slice(s-1))this.#s(a);return this.#e=t,!0}get length(){return this.#r.length-1}get over(){let{terminated:t,truncated:n}=this.
outcomes.at(-1);return t||n}actions(t){let n=Uint8Array.from(t,o=>typeof o=="number"?o:Se),r=new Set(t.filter(o=>typeof o=="string"));for(let o of this.over?[]:
r)for(let s of["pursuer","evader"]){let a=this.#t.decide(o===he?this.#n[s].policy:o,s,n);t.forEach((i,l)=>{i===o&&l<this.#e.pursuers.length==(s==="pursuer")&&(n[l]=
a[l])})}return n}scene(){let t=this.#t,[n,r]=[t.read("last_positions"),t.read("alive")],[o,s]=[t.read("captured"),t.read("ever_captured")],a=this.#e.pursuers.length,
i=ee(this.#e).map((l,c)=>({...Tn([n[2*c],n[2*c+1]]),gone:!r[c],captured:c>=a&&!!o[c-a],everCaptured:c>=a&&!!s[c-a]}));return{...this.#e,played:[],steps:t.steps,
ended:this.outcomes.at(-1).terminated,pursuers:i.slice(0,a),evaders:i.slice(a)}}perfect(t){let[n,r]=[this.#o.at(-2),this.#r.at(-1).actions];return n&&this.#t.restore(
n),{losses:n&&r?Zt(t,this.#t,[r]):[],game:t.game(this.#t)}}free(){this.#t.free()}#s(t){if(this.over)return;let n=this.actions(t);this.#t.step(n),this.#i(n)}#i(t){
let n=this.#t;this.#r.push(vt(n,t)),this.#o.push(n.snapshot()),this.outcomes.push({conflicts:t?n.conflicts():[],rewards:n.read("rewards"),captors:n.read("captor\
s"),terminated:!!n.read("terminated")[0],truncated:!!n.read("truncated")[0]})}};function mi(e,t){let n=ee(t),r=n.map(({cell:s})=>s[0]*t.cols+s[1]),o=s=>Uint8Array.
from(t.evaders,a=>Number(a[s]));return{...e.snapshot(),seed:BigUint64Array.of(t.seed),episode:BigUint64Array.of(t.episode),cells:Int32Array.from(r,(s,a)=>n[a].gone?
-1:s),last_cells:Int32Array.from(r,(s,a)=>n[a].gone?s:-1),captured:o("captured"),ever_captured:o("everCaptured"),capture_paid:o("everCaptured"),captors:new Int32Array(
t.evaders.length),rewards:new Float32Array(G(t)),report:new Int32Array(G(t)),participants:new Int32Array(0),steps:Int32Array.of(t.steps),terminated:Uint8Array.of(
Number(t.ended)),truncated:Uint8Array.of(+(t.steps>=t.maxSteps))}}function Un(e,t){return Object.keys(e).every(r=>["played","next","rules","others"].includes(r)||
e[r]===t[r])}var hi={SIMULTANEOUS:.45,SWARM_TURNS:.9,AGENT_TURNS:1.4},fi=200,Qt=class extends EventTarget{data;player;#e;#n;#t;#r=[];#o=[];#s=[];#i=!1;#h="act";#c=0;#m=null;#d;constructor(t,n,r,o=null){
super(),[this.#m,this.#d]=[o,r],this.#e=t,this.data=n,this.#n=r,this.#t=this.#f(r),this.player=new Fe(this.game.length,{still:gt()}),this.player.jump(this.game.
length),this.player.addEventListener("frame",()=>this.#y()),this.#a()}get scene(){return this.#n}get game(){return this.#t[0]}get games(){return this.#t}get mode(){
return this.#h}set mode(t){this.stop(),this.#h=t,this.#p()}get selected(){return this.#c}set selected(t){this.#c=t,this.#p()}get running(){return this.#i}get example(){
return Un(this.#d,this.#n)?this.#m:null}get canStep(){return!this.game.over&&this.#n.played.length<Be}change(t,n={}){let r;try{r=this.#f(t)}catch(o){if(!(o instanceof
H))throw o;return this.say(o.message,!0),!1}return n.part||(this.#r=[...this.#r,this.#n].slice(-fi)),this.#o=[],n.example!==void 0&&([this.#m,this.#d]=[n.example,
t]),this.#s=[],this.#l(t,r),!0}step(){if(!this.canStep){this.stop(),this.say(this.game.over?"The episode has ended. Go back, or restart.":`The playground plays ${Be}\
 steps.`,!0);return}let n=this.#s.at(-1)===this.#n.next?this.#s.slice(0,-1):[],r=Wr(this.#n);this.change({...r,next:n.at(-1)??r.next}),this.#s=n}back(){this.stop();
let{played:t}=this.#n;if(!this.game.length)return;let n=this.#n,r=this.#s.at(-1)===n.next?[...this.#s]:[];for(let o=t.length;o>=this.game.length;o--)n=Fr(n),r.push(
n.next);this.change(n),this.#s=r}restart(){this.stop();let{played:t}=this.#n;if(!t.length)return;let n=[...this.#s.at(-1)===this.#n.next?this.#s:[],...[...t].reverse()];
this.change({...this.#n,played:[],next:t[0]}),this.#s=n}run(){if(this.#i)return this.stop();this.#i=this.canStep,this.step()}stop(){this.#i&&(this.#i=!1,this.#p())}undo(){
this.#u(this.#r,this.#o)}redo(){this.#u(this.#o,this.#r)}solution(){let t=We(this.#n,this.#n.rules);return Vt(this.#e,t,Yt(t))}get canUndo(){return this.#r.length>
0}shownBy(t,n="step"){this.addEventListener("change",t),this.player.addEventListener(n,t),t()}say(t,n=!1){this.dispatchEvent(new CustomEvent("message",{detail:{
text:t,problem:n}}))}#u(t,n){let r=t.pop();r&&(this.stop(),n.push(this.#n),this.#s=[],this.#l(r,this.#f(r)))}#f(t){let n=t.others?[t.rules,t.others]:[t.rules],r=this.#t??
[];return n.map(o=>{let s=r.find(i=>i.rules===o),a=s?.follow(t)?s:new Xt(this.#e,t,o,this.data.champions);return a.actions(t.next),a})}#l(t,n){let[r,o]=[this.#n,
this.#t.length];for(let l of this.#t)n.includes(l)||l.free();this.#n=t,this.#t=n,this.#c!==null&&this.#c>=ee(t).length&&(this.#c=null);let s=this.game.length,[a,
i]=[this.player.step,r.rules!==t.rules||t.others!==null&&o<2];this.player.length=s,this.#a(),i&&s&&this.player.jump(s-1),i&&s||Math.abs(s-a)===1?this.player.move(
s-this.player.step):this.player.jump(s),this.#p()}#a(){this.player.glide=hi[this.#n.rules.interaction]}#y(){this.#i&&this.player.arrived&&this.step()}#p(){this.
dispatchEvent(new Event("change"))}};function Go(e,t,n){let r=s=>new Qt(e,t,dt(s,t),Vo(t,s)),o=t.gallery[0].scene;try{return{store:r(n||o),problem:""}}catch(s){return{store:r(o),problem:Ko(s)}}}function Ko(e){
if(e instanceof ut||e instanceof H)return`This link holds no scene. ${e.message}`;throw e}function Vo(e,t){return e.gallery.find(n=>n.scene===t)??null}function Ee(){
try{return decodeURIComponent(location.hash.slice(1))}catch{return location.hash.slice(1)}}var wt=e=>new URLSearchParams(e).has("moves"),yi=100;function Yo(e,t,n){
let[r,o,s]=[Nn(e.scene,e.data),Ee(),0],a=()=>{s=0,!(Ee()!==o||!t())&&(o=r,history.replaceState(null,"",`#${r}`))};e.addEventListener("change",()=>{r=Nn(e.scene,
e.data),t()&&(o=Ee(),r!==o&&!s&&(s=setTimeout(a,yi)))}),window.addEventListener("hashchange",()=>{if(o=Ee(),!(!o||o===r||wt(o))){t()||n();try{e.change(dt(o,e.data),
{example:Vo(e.data,o)})}catch(i){e.say(Ko(i),!0)}}})}function Zo(){let e=JSON.parse(document.getElementById("data").textContent),t=document.getElementById("champions")?.textContent;return t?{...e,champions:JSON.parse(
t,gi)}:e}var gi=(e,t)=>e==="genome"?Float32Array.from(t):t;var M=Uint8Array,Z=Uint16Array,Yn=Int32Array,tn=new M([0,0,0,0,0,0,0,0,1,1,1,1,2,2,2,2,3,3,3,3,4,4,4,4,5,5,5,5,0,0,0,0]),nn=new M([0,0,0,0,1,1,2,2,3,3,4,4,5,5,6,
6,7,7,8,8,9,9,10,10,11,11,12,12,13,13,0,0]),Fn=new M([16,17,18,0,8,7,9,6,10,5,11,4,12,3,13,2,14,1,15]),ts=function(e,t){for(var n=new Z(31),r=0;r<31;++r)n[r]=t+=
1<<e[r-1];for(var o=new Yn(n[30]),r=1;r<30;++r)for(var s=n[r];s<n[r+1];++s)o[s]=s-n[r]<<5|r;return{b:n,r:o}},ns=ts(tn,2),rs=ns.b,jn=ns.r;rs[28]=258,jn[258]=28;var os=ts(
nn,0),vi=os.b,qo=os.r,Hn=new Z(32768);for(T=0;T<32768;++T)ue=(T&43690)>>1|(T&21845)<<1,ue=(ue&52428)>>2|(ue&13107)<<2,ue=(ue&61680)>>4|(ue&3855)<<4,Hn[T]=((ue&65280)>>
8|(ue&255)<<8)>>1;var ue,T,ae=(function(e,t,n){for(var r=e.length,o=0,s=new Z(t);o<r;++o)e[o]&&++s[e[o]-1];var a=new Z(t);for(o=1;o<t;++o)a[o]=a[o-1]+s[o-1]<<1;
var i;if(n){i=new Z(1<<t);var l=15-t;for(o=0;o<r;++o)if(e[o])for(var c=o<<4|e[o],u=t-e[o],p=a[e[o]-1]++<<u,m=p|(1<<u)-1;p<=m;++p)i[Hn[p]>>l]=c}else for(i=new Z(
r),o=0;o<r;++o)e[o]&&(i[o]=Hn[a[e[o]-1]++]>>15-e[o]);return i}),ge=new M(288);for(T=0;T<144;++T)ge[T]=8;var T;for(T=144;T<256;++T)ge[T]=9;var T;for(T=256;T<280;++T)
ge[T]=7;var T;for(T=280;T<288;++T)ge[T]=8;var T,At=new M(32);for(T=0;T<32;++T)At[T]=5;var T,bi=ae(ge,9,0),wi=ae(ge,9,1),xi=ae(At,5,0),Si=ae(At,5,1),zn=function(e){
for(var t=e[0],n=1;n<e.length;++n)e[n]>t&&(t=e[n]);return t},ne=function(e,t,n){var r=t/8|0;return(e[r]|e[r+1]<<8)>>(t&7)&n},Bn=function(e,t){var n=t/8|0;return(e[n]|
e[n+1]<<8|e[n+2]<<16)>>(t&7)},Zn=function(e){return(e+7)/8|0},Tt=function(e,t,n){return(t==null||t<0)&&(t=0),(n==null||n>e.length)&&(n=e.length),new M(e.subarray(
t,n))};var Ai=["unexpected EOF","invalid block type","invalid length/literal","invalid distance","stream finished","no stream handler",,"no callback","invalid UTF-8 da\
ta","extra field too long","date not in range 1980-2099","filename too long","stream finishing","invalid zip data"],B=function(e,t,n){var r=new Error(t||Ai[e]);
if(r.code=e,Error.captureStackTrace&&Error.captureStackTrace(r,B),!n)throw r;return r},ss=function(e,t,n,r){var o=e.length,s=r?r.length:0;if(!o||t.f&&!t.l)return n||
new M(0);var a=!n,i=a||t.i!=2,l=t.i;a&&(n=new M(o*3));var c=function(Xe){var Qe=n.length;if(Xe>Qe){var Ne=new M(Math.max(Qe*2,Xe));Ne.set(n),n=Ne}},u=t.f||0,p=t.
p||0,m=t.b||0,h=t.l,f=t.d,y=t.m,g=t.n,v=o*8;do{if(!h){u=ne(e,p,1);var x=ne(e,p+1,3);if(p+=3,x)if(x==1)h=wi,f=Si,y=9,g=5;else if(x==2){var _=ne(e,p,31)+257,R=ne(
e,p+10,15)+4,S=_+ne(e,p+5,31)+1;p+=14;for(var w=new M(S),$=new M(19),L=0;L<R;++L)$[Fn[L]]=ne(e,p+L*3,7);p+=R*3;for(var D=zn($),pe=(1<<D)-1,K=ae($,D,1),L=0;L<S;){
var F=K[ne(e,p,pe)];p+=F&15;var b=F>>4;if(b<16)w[L++]=b;else{var I=0,k=0;for(b==16?(k=3+ne(e,p,3),p+=2,I=w[L-1]):b==17?(k=3+ne(e,p,7),p+=3):b==18&&(k=11+ne(e,p,
127),p+=7);k--;)w[L++]=I}}var j=w.subarray(0,_),U=w.subarray(_);y=zn(j),g=zn(U),h=ae(j,y,1),f=ae(U,g,1)}else B(1);else{var b=Zn(p)+4,A=e[b-4]|e[b-3]<<8,E=b+A;if(E>
o){l&&B(0);break}i&&c(m+A),n.set(e.subarray(b,E),m),t.b=m+=A,t.p=p=E*8,t.f=u;continue}if(p>v){l&&B(0);break}}i&&c(m+131072);for(var Je=(1<<y)-1,q=(1<<g)-1,ie=p;;ie=
p){var I=h[Bn(e,p)&Je],V=I>>4;if(p+=I&15,p>v){l&&B(0);break}if(I||B(2),V<256)n[m++]=V;else if(V==256){ie=p,h=null;break}else{var Y=V-254;if(V>264){var L=V-257,O=tn[L];
Y=ne(e,p,(1<<O)-1)+rs[L],p+=O}var oe=f[Bn(e,p)&q],Oe=oe>>4;oe||B(3),p+=oe&15;var U=vi[Oe];if(Oe>3){var O=nn[Oe];U+=Bn(e,p)&(1<<O)-1,p+=O}if(p>v){l&&B(0);break}i&&
c(m+131072);var Re=m+Y;if(m<U){var Rt=s-U,Nt=Math.min(U,Re);for(Rt+m<0&&B(3);m<Nt;++m)n[m]=r[Rt+m]}for(;m<Re;++m)n[m]=n[m-U]}}t.l=h,t.p=ie,t.b=m,t.f=u,h&&(u=1,t.
m=y,t.d=f,t.n=g)}while(!u);return m!=n.length&&a?Tt(n,0,m):n.subarray(0,m)},de=function(e,t,n){n<<=t&7;var r=t/8|0;e[r]|=n,e[r+1]|=n>>8},xt=function(e,t,n){n<<=
t&7;var r=t/8|0;e[r]|=n,e[r+1]|=n>>8,e[r+2]|=n>>16},Dn=function(e,t){for(var n=[],r=0;r<e.length;++r)e[r]&&n.push({s:r,f:e[r]});var o=n.length,s=n.slice();if(!o)
return{t:is,l:0};if(o==1){var a=new M(n[0].s+1);return a[n[0].s]=1,{t:a,l:1}}n.sort(function(E,_){return E.f-_.f}),n.push({s:-1,f:25001});var i=n[0],l=n[1],c=0,
u=1,p=2;for(n[0]={s:-1,f:i.f+l.f,l:i,r:l};u!=o-1;)i=n[n[c].f<n[p].f?c++:p++],l=n[c!=u&&n[c].f<n[p].f?c++:p++],n[u++]={s:-1,f:i.f+l.f,l:i,r:l};for(var m=s[0].s,r=1;r<
o;++r)s[r].s>m&&(m=s[r].s);var h=new Z(m+1),f=Gn(n[u-1],h,0);if(f>t){var r=0,y=0,g=f-t,v=1<<g;for(s.sort(function(_,R){return h[R.s]-h[_.s]||_.f-R.f});r<o;++r){
var x=s[r].s;if(h[x]>t)y+=v-(1<<f-h[x]),h[x]=t;else break}for(y>>=g;y>0;){var b=s[r].s;h[b]<t?y-=1<<t-h[b]++-1:++r}for(;r>=0&&y;--r){var A=s[r].s;h[A]==t&&(--h[A],
++y)}f=t}return{t:new M(h),l:f}},Gn=function(e,t,n){return e.s==-1?Math.max(Gn(e.l,t,n+1),Gn(e.r,t,n+1)):t[e.s]=n},Jo=function(e){for(var t=e.length;t&&!e[--t];)
;for(var n=new Z(++t),r=0,o=e[0],s=1,a=function(l){n[r++]=l},i=1;i<=t;++i)if(e[i]==o&&i!=t)++s;else{if(!o&&s>2){for(;s>138;s-=138)a(32754);s>2&&(a(s>10?s-11<<5|
28690:s-3<<5|12305),s=0)}else if(s>3){for(a(o),--s;s>6;s-=6)a(8304);s>2&&(a(s-3<<5|8208),s=0)}for(;s--;)a(o);s=1,o=e[i]}return{c:n.subarray(0,r),n:t}},St=function(e,t){
for(var n=0,r=0;r<t.length;++r)n+=e[r]*t[r];return n},as=function(e,t,n){var r=n.length,o=Zn(t+2);e[o]=r&255,e[o+1]=r>>8,e[o+2]=e[o]^255,e[o+3]=e[o+1]^255;for(var s=0;s<
r;++s)e[o+s+4]=n[s];return(o+4+r)*8},Xo=function(e,t,n,r,o,s,a,i,l,c,u){de(t,u++,n),++o[256];for(var p=Dn(o,15),m=p.t,h=p.l,f=Dn(s,15),y=f.t,g=f.l,v=Jo(m),x=v.c,
b=v.n,A=Jo(y),E=A.c,_=A.n,R=new Z(19),S=0;S<x.length;++S)++R[x[S]&31];for(var S=0;S<E.length;++S)++R[E[S]&31];for(var w=Dn(R,7),$=w.t,L=w.l,D=19;D>4&&!$[Fn[D-1]];--D)
;var pe=c+5<<3,K=St(o,ge)+St(s,At)+a,F=St(o,m)+St(s,y)+a+14+3*D+St(R,$)+2*R[16]+3*R[17]+7*R[18];if(l>=0&&pe<=K&&pe<=F)return as(t,u,e.subarray(l,l+c));var I,k,j,
U;if(de(t,u,1+(F<K)),u+=2,F<K){I=ae(m,h,0),k=m,j=ae(y,g,0),U=y;var Je=ae($,L,0);de(t,u,b-257),de(t,u+5,_-1),de(t,u+10,D-4),u+=14;for(var S=0;S<D;++S)de(t,u+3*S,
$[Fn[S]]);u+=3*D;for(var q=[x,E],ie=0;ie<2;++ie)for(var V=q[ie],S=0;S<V.length;++S){var Y=V[S]&31;de(t,u,Je[Y]),u+=$[Y],Y>15&&(de(t,u,V[S]>>5&127),u+=V[S]>>12)}}else
I=bi,k=ge,j=xi,U=At;for(var S=0;S<i;++S){var O=r[S];if(O>255){var Y=O>>18&31;xt(t,u,I[Y+257]),u+=k[Y+257],Y>7&&(de(t,u,O>>23&31),u+=tn[Y]);var oe=O&31;xt(t,u,j[oe]),
u+=U[oe],oe>3&&(xt(t,u,O>>5&8191),u+=nn[oe])}else xt(t,u,I[O]),u+=k[O]}return xt(t,u,I[256]),u+k[256]},Ti=new Yn([65540,131080,131088,131104,262176,1048704,1048832,
2114560,2117632]),is=new M(0),Ci=function(e,t,n,r,o,s){var a=s.z||e.length,i=new M(r+a+5*(1+Math.ceil(a/7e3))+o),l=i.subarray(r,i.length-o),c=s.l,u=(s.r||0)&7;if(t){
u&&(l[0]=s.r>>3);for(var p=Ti[t-1],m=p>>13,h=p&8191,f=(1<<n)-1,y=s.p||new Z(32768),g=s.h||new Z(f+1),v=Math.ceil(n/3),x=2*v,b=function(pn){return(e[pn]^e[pn+1]<<
v^e[pn+2]<<x)&f},A=new Yn(25e3),E=new Z(288),_=new Z(32),R=0,S=0,w=s.i||0,$=0,L=s.w||0,D=0;w+2<a;++w){var pe=b(w),K=w&32767,F=g[pe];if(y[K]=F,g[pe]=K,L<=w){var I=a-
w;if((R>7e3||$>24576)&&(I>423||!c)){u=Xo(e,l,0,A,E,_,S,$,D,w-D,u),$=R=S=0,D=w;for(var k=0;k<286;++k)E[k]=0;for(var k=0;k<30;++k)_[k]=0}var j=2,U=0,Je=h,q=K-F&32767;
if(I>2&&pe==b(w-q))for(var ie=Math.min(m,I)-1,V=Math.min(32767,w),Y=Math.min(258,I);q<=V&&--Je&&K!=F;){if(e[w+j]==e[w+j-q]){for(var O=0;O<Y&&e[w+O]==e[w+O-q];++O)
;if(O>j){if(j=O,U=q,O>ie)break;for(var oe=Math.min(q,O-2),Oe=0,k=0;k<oe;++k){var Re=w-q+k&32767,Rt=y[Re],Nt=Re-Rt&32767;Nt>Oe&&(Oe=Nt,F=Re)}}}K=F,F=y[K],q+=K-F&
32767}if(U){A[$++]=268435456|jn[j]<<18|qo[U];var Xe=jn[j]&31,Qe=qo[U]&31;S+=tn[Xe]+nn[Qe],++E[257+Xe],++_[Qe],L=w+j,++R}else A[$++]=e[w],++E[e[w]]}}for(w=Math.max(
w,L);w<a;++w)A[$++]=e[w],++E[e[w]];u=Xo(e,l,c,A,E,_,S,$,D,w-D,u),c||(s.r=u&7|l[u/8|0]<<3,u-=7,s.h=g,s.p=y,s.i=w,s.w=L)}else{for(var w=s.w||0;w<a+c;w+=65535){var Ne=w+
65535;Ne>=a&&(l[u/8|0]=c,Ne=a),u=as(l,u+1,e.subarray(w,Ne))}s.i=a}return Tt(i,0,r+Zn(u)+o)},Mi=(function(){for(var e=new Int32Array(256),t=0;t<256;++t){for(var n=t,
r=9;--r;)n=(n&1&&-306674912)^n>>>1;e[t]=n}return e})(),Ei=function(){var e=-1;return{p:function(t){for(var n=e,r=0;r<t.length;++r)n=Mi[n&255^t[r]]^n>>>8;e=n},d:function(){
return~e}}};var ki=function(e,t,n,r,o){if(!o&&(o={l:1},t.dictionary)){var s=t.dictionary.subarray(-32768),a=new M(s.length+e.length);a.set(s),a.set(e,s.length),e=a,o.w=s.length}
return Ci(e,t.level==null?6:t.level,t.mem==null?o.l?Math.ceil(Math.max(8,Math.min(13,Math.log(e.length)))*1.5):20:12+t.mem,n,r,o)},ls=function(e,t){var n={};for(var r in e)
n[r]=e[r];for(var r in t)n[r]=t[r];return n};var se=function(e,t){return e[t]|e[t+1]<<8},re=function(e,t){return(e[t]|e[t+1]<<8|e[t+2]<<16|e[t+3]<<24)>>>0},Wn=function(e,t){return re(e,t)+re(e,t+4)*4294967296},
z=function(e,t,n){for(;n;++t)e[t]=n,n>>>=8};var Oi=function(e,t){return((e[0]&15)!=8||e[0]>>4>7||(e[0]<<8|e[1])%31)&&B(6,"invalid zlib data"),(e[1]>>5&1)==+!t&&B(6,"invalid zlib data: "+(e[1]&32?"need":"u\
nexpected")+" dictionary"),(e[1]>>3&4)+2};function Ri(e,t){return ki(e,t||{},0,0)}function Ni(e,t){return ss(e,{i:2},t&&t.out,t&&t.dictionary)}function cs(e,t){return ss(e.subarray(Oi(e,t&&t.dictionary),-4),{i:2},t&&t.out,t&&t.dictionary)}var us=function(e,t,n,r){for(var o in e){var s=e[o],a=t+o,i=r;Array.isArray(s)&&(i=ls(r,s[1]),s=s[0]),s instanceof M?n[a]=[s,i]:(n[a+="/"]=[new M(0),i],us(s,a,n,
r))}},Qo=typeof TextEncoder<"u"&&new TextEncoder,Kn=typeof TextDecoder<"u"&&new TextDecoder,_i=0;try{Kn.decode(is,{stream:!0}),_i=1}catch{}var Li=function(e){for(var t="",
n=0;;){var r=e[n++],o=(r>127)+(r>223)+(r>239);if(n+o>e.length)return{s:t,r:Tt(e,n-1)};o?o==3?(r=((r&15)<<18|(e[n++]&63)<<12|(e[n++]&63)<<6|e[n++]&63)-65536,t+=String.
fromCharCode(55296|r>>10,56320|r&1023)):o&1?t+=String.fromCharCode((r&31)<<6|e[n++]&63):t+=String.fromCharCode((r&15)<<12|(e[n++]&63)<<6|e[n++]&63):t+=String.fromCharCode(
r)}};function en(e,t){if(t){for(var n=new M(e.length),r=0;r<e.length;++r)n[r]=e.charCodeAt(r);return n}if(Qo)return Qo.encode(e);for(var o=e.length,s=new M(e.length+
(e.length>>1)),a=0,i=function(u){s[a++]=u},r=0;r<o;++r){if(a+5>s.length){var l=new M(a+8+(o-r<<1));l.set(s),s=l}var c=e.charCodeAt(r);c<128||t?i(c):c<2048?(i(192|
c>>6),i(128|c&63)):c>55295&&c<57344?(c=65536+(c&1047552)|e.charCodeAt(++r)&1023,i(240|c>>18),i(128|c>>12&63),i(128|c>>6&63),i(128|c&63)):(i(224|c>>12),i(128|c>>
6&63),i(128|c&63))}return Tt(s,0,a)}function qn(e,t){if(t){for(var n="",r=0;r<e.length;r+=16384)n+=String.fromCharCode.apply(null,e.subarray(r,r+16384));return n}else{
if(Kn)return Kn.decode(e);var o=Li(e),s=o.s,n=o.r;return n.length&&B(8),s}}var Pi=function(e,t){return t+30+se(e,t+26)+se(e,t+28)},$i=function(e,t,n){var r=se(e,t+28),o=qn(e.subarray(t+46,t+46+r),!(se(e,t+8)&2048)),s=t+46+r,a=re(e,t+20),
i=n&&a==4294967295?Ii(e,s):[a,re(e,t+24),re(e,t+42)],l=i[0],c=i[1],u=i[2];return[se(e,t+10),l,c,o,s+se(e,t+30)+se(e,t+32),u]},Ii=function(e,t){for(;se(e,t)!=1;t+=
4+se(e,t+2));return[Wn(e,t+12),Wn(e,t+4),Wn(e,t+20)]},Vn=function(e){var t=0;if(e)for(var n in e){var r=e[n].length;r>65535&&B(9),t+=r+4}return t},es=function(e,t,n,r,o,s,a,i){
var l=r.length,c=n.extra,u=i&&i.length,p=Vn(c);z(e,t,a!=null?33639248:67324752),t+=4,a!=null&&(e[t++]=20,e[t++]=n.os),e[t]=20,t+=2,e[t++]=n.flag<<1|(s<0&&8),e[t++]=
o&&8,e[t++]=n.compression&255,e[t++]=n.compression>>8;var m=new Date(n.mtime==null?Date.now():n.mtime),h=m.getFullYear()-1980;if((h<0||h>119)&&B(10),z(e,t,h<<25|
m.getMonth()+1<<21|m.getDate()<<16|m.getHours()<<11|m.getMinutes()<<5|m.getSeconds()>>1),t+=4,s!=-1&&(z(e,t,n.crc),z(e,t+4,s<0?-s-2:s),z(e,t+8,n.size)),z(e,t+12,
l),z(e,t+14,p),t+=16,a!=null&&(z(e,t,u),z(e,t+6,n.attrs),z(e,t+10,a),t+=14),e.set(r,t),t+=l,p)for(var f in c){var y=c[f],g=y.length;z(e,t,+f),z(e,t+2,g),e.set(y,
t+4),t+=4+g}return u&&(e.set(i,t),t+=u),t},Ui=function(e,t,n,r,o){z(e,t,101010256),z(e,t+8,n),z(e,t+10,n),z(e,t+12,r),z(e,t+16,o)};function ds(e,t){t||(t={});var n={},r=[];us(e,"",n,t);var o=0,s=0;for(var a in n){var i=n[a],l=i[0],c=i[1],u=c.level==0?0:8,p=en(a),m=p.length,h=c.comment,f=h&&
en(h),y=f&&f.length,g=Vn(c.extra);m>65535&&B(11);var v=u?Ri(l,c):l,x=v.length,b=Ei();b.p(l),r.push(ls(c,{size:l.length,crc:b.d(),c:v,f:p,m:f,u:m!=a.length||f&&h.
length!=y,o,compression:u})),o+=30+m+g+x,s+=76+2*(m+g)+(y||0)+x}for(var A=new M(s+22),E=o,_=s-o,R=0;R<r.length;++R){var p=r[R];es(A,p.o,p,p.f,p.u,p.c.length);var S=30+
p.f.length+Vn(p.extra);A.set(p.c,p.o+S),es(A,o,p,p.f,p.u,p.c.length,p.o,p.m),o+=16+S+(p.m?p.m.length:0)}return Ui(A,o,r.length,_,E),A}function ps(e,t){for(var n={},r=e.length-22;re(e,r)!=101010256;--r)(!r||e.length-r>65558)&&B(13);var o=se(e,r+8);if(!o)return{};var s=re(e,r+16),a=s==4294967295||
o==65535;if(a){var i=re(e,r-12);a=re(e,i)==101075792,a&&(o=re(e,i+32),s=re(e,i+48))}for(var l=t&&t.filter,c=0;c<o;++c){var u=$i(e,s,a),p=u[0],m=u[1],h=u[2],f=u[3],
y=u[4],g=u[5],v=Pi(e,g);s=y,(!l||l({name:f,size:m,originalSize:h,compression:p}))&&(p?p==8?n[f]=Ni(e.subarray(v,v+m),{out:new M(h)}):B(14,"unknown compression t\
ype "+p):n[f]=Tt(e,v,v+m))}return n}var Ve=["pursuer","evader"];var Jn=4,ms=new Map;function hs(e,t){let n=ms.get(e);if(n)return n;let r=new Float32Array;try{let o=Bi(Di(e),t);o.every(Number.isFinite)&&(r=o)}catch(o){if(!(o instanceof DOMException||
o instanceof RangeError||zi(o)))throw o}return ms.set(e,r),r}var zi=e=>e instanceof Error&&"code"in e;function Bi(e,t){let n=cs(e),r=n.length/Jn,o=new Uint8Array(
n.length);for(let a=0;a<o.length;a++)o[a]=n[a%Jn*r+Math.floor(a/Jn)];let s=new Uint32Array(o.buffer);for(let a=t;a<s.length;a++)s[a]^=s[a-t];return new Float32Array(
o.buffer)}function Di(e){let t=atob(Wi(e)),n=new Uint8Array(t.length);for(let r=0;r<n.length;r++)n[r]=t.charCodeAt(r);return n}function Wi(e){return document.getElementById(
e)?.textContent??""}var Ct=class{config;start;recording;actions=[];#e;#n;#t=[[]];constructor(t,n,r){[this.config,this.start]=[n,r],this.#e=t.world(n),this.#e.reset(r),this.#n=[vt(this.#e)],
this.recording=Kt(n,this.#e.map(),this.#n)}get length(){return this.actions.length}get over(){return this.#e.over}get statistics(){return{capture_rate:this.#e.read(
"capture_rate")[0]}}conflicts(t){return this.#t[t]}game(t){return t.game(this.#e)}play(t){this.#e.step(t),this.#r(t)}step(t,n,r){let[o,s]=[this.#e,this.config.n_pursuers],
a=new Uint8Array(o.n_agents);for(let i=o.n_turns;i>0&&!o.over;--i){let[l,c]=o.actors;l<s&&(a=o.decide(t.pursuer,[l,Math.min(c,s)],a)),c>s&&(a=o.decide(t.evader,
[Math.max(l,s),c],a)),typeof r=="number"?a[n]=r:l<=n&&n<c&&(a=o.decide(r,[n,n+1],a)),o.playTurn(a)}this.#r(a)}#r(t){this.actions.push(t),this.#n.push(vt(this.#e,
t)),this.#t.push(this.#e.conflicts())}};function fs(e,t,n,r){let o=new Ct(e,t,n);for(let s of r)o.play(s);return o}var Fi={"|b1":e=>new Uint8Array(e),"|i1":e=>new Int8Array(e),"<i4":e=>new Int32Array(e),"<i8":e=>Int32Array.from(new BigInt64Array(e),Number),"<f4":e=>new Float32Array(
e)},gs="NUMPY\0",Ye=gs.length+2,ys=64;function vs(e){return ds(Object.fromEntries(Object.entries(e).map(([t,n])=>[`${t}.npy`,ji(n)])))}function ji({dtype:e,shape:t,
data:n}){let r=typeof n=="string"?Array.from(n,u=>u.codePointAt(0)):null,o=t.map(u=>`${u}, `).join(""),s=`{'descr': '${r?`<U${r.length}`:e}', 'fortran_order': F\
alse, 'shape': (${o}), }`,a=Math.ceil((Ye+s.length+1)/ys)*ys-Ye,i=gs+String.fromCharCode(a&255,a>>8)+s.padEnd(a-1)+`
`,l=r?Int32Array.from(r):n,c=new Uint8Array(i.length+l.byteLength);return c.set(en(i,!0)),c.set(new Uint8Array(l.buffer,l.byteOffset,l.byteLength),i.length),c}function bs(e){
return Object.fromEntries(Object.entries(ps(e)).map(([t,n])=>[t.replace(/\.npy$/,""),Hi(n)]))}function Hi(e){let t=Ye+e[Ye-2]+256*e[Ye-1],n=qn(e.subarray(Ye,t),
!0),r=/'descr': '([^']+)', 'fortran_order': False, 'shape': \(([\d, ]*)\)/.exec(n),[o,s]=[r?.[1]??"",(r?.[2]??"").split(",").filter(c=>c.trim()).map(Number)],a=e.
slice(t).buffer,i=o.startsWith("<U")&&String.fromCodePoint(...new Int32Array(a)),l=i===!1?Fi[o]?.(a):i.replace(/\0+$/,"");if(l===void 0)throw new TypeError(`exp\
ected an array of numbers or a text, got ${n.slice(0,80)}`);return{dtype:o,shape:s,data:l}}var Xn="matrixworld episode 3";function ws(e,t,n){let{config:r,actions:o,length:s,recording:a}=t,[i,l]=[r.n_pursuers+r.n_evaders,r.n_evaders],c={positions:["<i4",
i,2],last_positions:["<i4",i,2],alive:["|b1",i],captured:["|b1",l],ever_captured:["|b1",l]},u={rewards:["<f4",i],involved:["|b1",i,3],fault:["|b1",i,3]},p={},m=b=>{
for(let A of Object.keys(b))(p[A]??=[]).push(Array.from(h.read(A),Number))},h=e.world(r);h.reset(t.start);let f=[];m(c);for(let b of o)h.step(b),m({...c,...u}),
f.push(...h.conflictTable());h.free();let y={"<i4":Int32Array,"<f4":Float32Array,"|b1":Uint8Array},g={};for(let[b,[A,...E]]of Object.entries({...c,...u})){let _=s+
+(b in c);g[b]={dtype:A,shape:[_,...E],data:y[A].from((p[b]??[]).flat())}}let v=b=>({dtype:"<i8",shape:[],data:Int32Array.of(b,0)}),x=b=>({dtype:"<U",shape:[],data:b});
return vs({format:x(Xn),n_pursuers:v(r.n_pursuers),config:x(JSON.stringify(r)),seat:v(n),...g,actions:{dtype:"|i1",shape:[s,i],data:Int8Array.from(o.flatMap(b=>[
...b]))},map:{dtype:"|b1",shape:[r.rows,r.cols],data:Uint8Array.from(a.obstacles,Number)},conflict_table:{dtype:"<i4",shape:[f.length/11,11],data:Int32Array.from(
f)}})}function xs(e,t){let n=bs(t),r=h=>Array.from(n[h]?.data??[]);if(n.format?.data!==Xn)throw new H(`expected a file marked "${Xn}"`);let o=JSON.parse(n.config.
data),s=o.n_pursuers+o.n_evaders,a=r("positions"),i=(h,f)=>Array.from({length:f-h},(y,g)=>[a[2*(h+g)],a[2*(h+g)+1]]),l={pursuers:i(0,o.n_pursuers),evaders:i(o.n_pursuers,
s),obstacles:Uint8Array.from(r("map"))},c=Uint8Array.from(r("actions")),u=Array.from({length:c.length/s},(h,f)=>c.subarray(f*s,(f+1)*s)),p=fs(e,o,l,u);if(Array.
from(p.recording.moments.at(-1).positions).join()!==r("last_positions").slice(-2*s).join())throw new H("expected the moves of this start to lead to its end");return{
live:p,seat:r("seat")[0]??null}}var ve=(e,t)=>Ve[+(t>=e.n_pursuers)];function Qn(e,t){let n=new Ct(e,t.config,{seed:t.seed,episode:t.episode});for(let r of t.moves)n.over||n.step(t.policies,t.
seat,r);return n}function ke(e,t){let{moments:n,nPursuers:r}=e.recording,o=n.findIndex(({alive:a,captured:i})=>!a[t]||!!i[t-r]),s=o<0?e.length:o;return{lasted:s,
out:o>=0,captured:Array.from(n[s].everCaptured).filter(Boolean).length}}var rn=(e,t)=>e.over||ke(e,t).out;function Ss(e,t,n){let r=Qn(e,{...t,moves:t.moves.slice(
0,t.from)});for(;!rn(r,t.seat);)r.step(t.policies,t.seat,n);return ke(r,t.seat)}function er(e){let t=e.length-1;return[...new Set([0,Math.round(t/3),t])].map(n=>e[n])}
function As(e,{seat:t,from:n,moves:r}){let o={...e,seat:t,...n?{from:n}:{},moves:r.join("")};return`${location.href.split("#")[0]}#${Object.entries(o).map(([s,a])=>`${s}\
=${a}`).join("&")}`}function Ts(e,t){let[n,r,o]=[e.get("seat")??"",e.get("from")??"0",e.get("moves")??""];return/^\d{1,6}$/.test(n)&&Number(n)<t.n_pursuers+t.n_evaders&&
(t.diagonal?/^[0-8]+$/:/^[0-4]+$/).test(o)&&o.length<=t.max_steps&&/^\d{1,6}$/.test(r)&&Number(r)<=o.length?{seat:Number(n),from:Number(r),moves:[...o].map(Number)}:
null}var on=()=>crypto.getRandomValues(new BigUint64Array(1))[0];var Gi=20,tr=60;function Ki(e){let t=e.rules.capture==="SURROUND"?8:4,n=typeof e.obstacles!="number",r=o=>n?o:Math.min(o,Gi);return{...e,rows:r(e.rows),cols:r(e.
cols),max_steps:tr,n_evaders:1,n_pursuers:Math.min(e.n_pursuers,t)}}function nr(e,t,n){let[r,o,s]=[Ki(t),er(n),[]],a=()=>`${s.reduce((l,c)=>l+c,0)} of ${tr*o.length}`,
i=()=>e.play({title:`Can you escape it? Round ${s.length+1} of ${o.length}, pursuers: ${o[s.length].name}`,about:o[s.length].text&&`${o[s.length].name}: ${o[s.length].
text}`,played:{config:r,seed:on(),episode:0,seat:r.n_pursuers,from:0,moves:[],policies:{pursuer:o[s.length].policy(),evader:"still"}},ending:l=>{s.push(ke(l,r.n_pursuers).
lasted);let c=o.map(({name:p},m)=>d("tr",{},d("th",{scope:"row"},p),d("td",{},s[m]??""))),u=s.length<o.length;return[d("table",{class:"numbers"},d("caption",{},
`Steps of ${tr} in each round`),...c),d("p",{class:"play-score"},u?"Score so far: ":"Your score: ",d("strong",{},a())),u?d("button",{type:"button",class:"primar\
y",onclick:i},"Next round"):""]},again:()=>nr(e,t,n),link:()=>null});i()}function rr(e,t,n,r,o,s){t.play({title:n,played:r,ending:(a,i)=>[Vi(e,a,i,er(o))],again:()=>rr(
e,t,n,{...r,moves:r.moves.slice(0,r.from)},o,s),link:a=>s&&As(s,a)})}function Vi(e,t,n,r){let o=ve(n.config,n.seat)==="evader",s=o?n.config.max_steps:n.config.n_evaders,
a=d("table",{class:"numbers"},d("caption",{},o?"Steps in your seat: same start, same others":"Captures of your team: same start, same others")),i=c=>{let[u,p]=[
d("span",{class:o?"bar evader":"bar pursuer"}),d("td",{},"…")];return a.append(d("tr",{},d("th",{scope:"row"},c),d("td",{class:"track","aria-hidden":"true"},u),
p)),({lasted:m,captured:h})=>{u.style.width=`${100*(o?m:h)/s}%`,p.textContent=String(o?m:h)}};i("You")(ke(t,n.seat));for(let{name:c,policy:u}of r){let p=i(c);setTimeout(
()=>p(Ss(e,n,u())))}let l=n.from?`You took over at step ${n.from}. `:"";return d("div",{},a,d("p",{class:"small muted"},`${l}One match: luck has its part in it.`))}var Yi={first:"M6 5v14M19 5 9 12l10 7z",back:"M17 5 7 12l10 7z",play:"M7 4.5 19 12 7 19.5z",pause:"M8 5v14M16 5v14",forward:"M7 5l10 7-10 7z",last:"M18 5v14M5 5\
l10 7-10 7z"};function Et(e){return xe("svg",{viewBox:"0 0 24 24","aria-hidden":"true",class:"icon"},xe("path",{d:Yi[e]}))}function Mt(e,t,n,r){return d("button",
{type:"button",class:"player-button","aria-label":t,title:`${t} (${n})`,onclick:r},Et(e))}function Cs(e){let t=Mt("play","Play","Space",()=>e.toggle()),n=d("inp\
ut",{type:"range",class:"player-scrub",min:0,step:1,"aria-label":"Step",oninput:()=>{e.pause(),e.jump(Number(n.value))}}),r=d("div",{class:"captures","aria-hidd\
en":"true",title:"Captures"}),o=d("div",{class:"losses","aria-hidden":"true"}),s=d("select",{class:"player-speed","aria-label":"Speed",title:`Steps a second, or\
 the whole in ${Bt} s (+ and -)`,onchange:()=>e.speed=Number(s.value)},d("option",{value:to},`in ${Bt} s`),...pt.map(p=>d("option",{value:p},`${p} / s`))),a=d("\
output",{class:"player-count"}),i=d("div",{class:"player",role:"group","aria-label":"Player"},Mt("first","First step","Home",()=>e.move(-e.length)),Mt("back","S\
tep back","←",()=>e.move(-1)),t,Mt("forward","Step forward","→",()=>e.move(1)),Mt("last","Last step","End",()=>e.move(e.length)),d("div",{class:"scrub"},r,o,
n),a,s),l=(p,m={})=>{let h=d("i",m);return h.style.left=`${100*p/Math.max(1,e.length)}%`,h},c=()=>{r.replaceChildren(...e.marks.map(p=>l(p))),o.replaceChildren(
...e.ticks.map(({step:p,kind:m,size:h,text:f})=>{let y=l(p,{class:m,title:`Step ${p}: ${f}`});return y.style.height=`${100*h}%`,y}))},u=()=>{t.replaceChildren(Et(
e.playing?"pause":"play")),t.ariaLabel=e.playing?"Pause":"Play",t.title=`${t.ariaLabel} (Space)`,n.max=String(e.length),n.value=String(e.step),n.ariaValueText=`\
step ${e.step} of ${e.length}`,a.textContent=`${e.step} / ${e.length}`,a.style.minWidth=`${2*String(e.length).length+3}ch`,s.value=String(e.speed)};return e.addEventListener(
"step",u),e.addEventListener("state",u),e.addEventListener("state",c),i.addEventListener("keydown",p=>{!(p.target instanceof HTMLSelectElement||p.key===" "&&p.target!==
n)&&Dt(e,p)&&p.preventDefault()}),u(),i}function Ms(e,t,n){if(n===0)return[{kind:"start",text:Zi(e),agents:[]}];let[r,o]=[t.moments[n-1],t.moments[n]],s=u=>J(u,e.config.n_pursuers),a=jt(t,r,o),i=e.conflicts(
n),l=new Set(i.flatMap(u=>u.doomed)),c=a.map(u=>({kind:"capture",text:`${s(u)} is captured`,agents:[u]}));for(let u of Ht(r,o))!a.includes(u)&&!l.has(u)&&c.push(
{kind:"end",text:`${s(u)} disappears`,agents:[u]});return c.push(...i.map(({kind:u,text:p,agents:m})=>({kind:u,text:p,agents:m}))),n===e.length&&c.unshift({kind:"\
end",text:qi(e),agents:[]}),c}function Zi({config:e}){return`${e.n_pursuers} pursuers and ${e.n_evaders} evaders on ${e.rows} x ${e.cols} cells, at most ${e.max_steps}\
 steps`}function qi(e){let t=Math.round(e.statistics.capture_rate*e.config.n_evaders);return`The episode ends after ${e.length} steps with ${t} of ${e.config.n_evaders}\
 evaders captured`}function Es(e,t,...n){let r=d("dialog",{class:t,"aria-label":e,onclick:({target:o})=>o===r&&r.close()},d("div",{class:"dialog-head"},d("h2",{},e),d("button",{type:"\
button",class:"close","aria-label":"Close",onclick:()=>r.close()},"✕")),...n);return r}var or=e=>d("dl",{class:"keys"},...e.flatMap(([t,n])=>[d("dt",{},...t.map(
r=>d("kbd",{},r))),d("dd",{},n)])),ks=e=>d("input",{type:"text",readonly:!0,"aria-label":e});function Os(e,t){let n=URL.createObjectURL(new Blob([t],{type:"appl\
ication/octet-stream"}));d("a",{href:n,download:e}).click(),setTimeout(()=>URL.revokeObjectURL(n),6e4)}var kt=["·","↑","→","↓","←","↗","↘","↙","↖"],Rs=e=>typeof e=="number"?`${kt[e]} ${W[e]}`:e,Ji={obstacle:["obstacle"],teammate:["teammate"],adversary:[
"evader","pursuer"]},Xi=e=>e.length<2?e.join(""):`${e.slice(0,-1).join(", ")} and ${e.at(-1)}`;function sn(e,t,n){let[r,o,s]=[t.recording.moments[n-1],t.recording.
moments[n],t.outcomes[n]];if(!r||!o||!s)return[];let a=[...s.conflicts.map(l=>Qi(e,t.rules,l)),...el(e,r,o,s.captors)],i={kind:"calm",text:"No conflict, no capt\
ure.",turn:0,blame:"",cost:"",used:[]};return[...a.length?a:[i],...tl(e,t,n)]}function Qi(e,t,n){let r=n.at_fault.map(c=>te(e,c)),o=t.interaction==="SIMULTANEOU\
S"?0:n.turn+1,s=r.length?`At fault: ${Xi(r)}.`:"Nobody is at fault.",a=n.held.length+n.doomed.length>0,i=new Set(n.at_fault.map(c=>Ns(e,c,tt.indexOf(n.kind))));
i.delete(0);let l=a||!i.size?"":`Allowed, but it costs: ${[...i].map(an).join(" and ")}.`;return{kind:n.kind,text:`${n.text}.`,turn:o,blame:s,cost:l,used:Ji[n.kind]}}
function Ns({pursuers:e,rewards:t},n,r){let o=n<e.length?t.pursuer_collide:t.evader_collide;return typeof o=="number"?o:o[r]}function an(e){let t=String(Number(
Math.abs(e).toPrecision(5)));return e<0?`−${t}`:e>0?`+${t}`:"0"}function _s(e,t,n,r){let[o,s,a]=[t.recording.moments[n-1],t.recording.moments[n],t.outcomes[n]];
if(!o?.alive[r]||!s||!a)return"";let{rewards:i}=e,l=r<e.pursuers.length?"pursuer":"evader",c=i.blame==="FAULT"?s.fault:s.involved,u=tt.reduce((h,f,y)=>h+(c?.[3*
r+y]?Ns(e,r,y):0),0),p=a.rewards[r]-u-i[`${l}_step`],m=Array.from({length:e.evaders.length+1},(h,f)=>f*i[`${l}_capture`]);for(let h of[0,i[`${l}_neighbor`]]){let f=m.
find(v=>Math.abs(v+h-p)<1e-4);if(f===void 0)continue;let y={collision:u,capture:f,neighbour:h,step:i[`${l}_step`]},g=Object.entries(y).filter(([,v])=>v).map(([v,
x])=>`${an(x)} ${v}`);return g.length>1?g.join(", "):""}return""}function el(e,t,n,r){let o=[];for(let s=0;s<e.evaders.length;s++){let a=e.pursuers.length+s,i=te(
e,a),l=t.alive[a]&&!n.alive[a],c=r[s]?` by ${r[s]} ${r[s]===1?"pursuer":"pursuers"}`:"",u=["capture",...l?["captured_disappear"]:[]];n.captured[s]&&!t.captured[s]?
o.push({kind:"capture",text:`${i} is captured${c}${l?" and disappears":""}.`,turn:0,blame:"",cost:"",used:u}):t.captured[s]&&!n.captured[s]&&n.alive[a]&&o.push(
{kind:"capture",text:`${i} is free again.`,turn:0,blame:"",cost:"",used:["capture"]})}return o}function tl(e,t,n){let{terminated:r,truncated:o}=t.outcomes[n];if(!r&&
!o)return[];let s=t.recording.moments[n].alive,a=(c,u)=>Array.from(s).slice(c,u).some(Boolean),i=e.pursuers.length,l=`after ${e.maxSteps} steps`;return r&&(l=a(
0,i)?"every evader is captured or gone":"no pursuer is left"),r&&!a(i,G(e))&&(l="no evader is left"),[{kind:"end",text:`The episode has ended: ${l}.`,turn:0,blame:"",
cost:"",used:[]}]}function Ot(e){return e.split(/(\(-?\d+, -?\d+\)|-[A-Z]{1,3}\b)/).map((t,n)=>n%2?d("span",{class:"whole"},t):t)}var nl={" ":0,ArrowUp:1,w:1,ArrowRight:2,d:2,ArrowDown:3,s:3,ArrowLeft:4,a:4,e:5,c:6,y:7,z:7,q:8},sr=[8,1,5,4,0,2,7,3,6],rl=[7,8,9,4,5,6,1,2,3],ol=24,sl=Math.tan(
Math.PI/8);function Ps(e,t){if(e.ctrlKey||e.metaKey||e.altKey)return;let n=rl.findIndex(o=>e.code===`Numpad${o}`),r=sr[n]??nl[e.key.length===1?e.key.toLowerCase():
e.key];return r!==void 0&&r>4&&!t?void 0:r}function $s(e){let t=sr.map(n=>d("button",{type:"button","aria-label":W[n],onclick:()=>e(n)},kt[n]));return{element:d(
"div",{class:"play-pad",role:"group","aria-label":"Your move"},...t),show:n=>t.forEach((r,o)=>r.classList.toggle("absent",sr[o]>4&&!n))}}function Ls(e,t,n){let r=sl*
Math.max(Math.abs(e),Math.abs(t)),o=s=>Math.abs(s)<r?0:s;return mt([0,0],n?[o(e),o(t)]:[e,t],n)}function Is(e,t,n){let r=null,{canvas:o}=e;o.addEventListener("p\
ointerdown",({button:s,clientX:a,clientY:i})=>{r=s===0?[a,i]:null}),o.addEventListener("pointercancel",()=>{r=null}),o.addEventListener("pointerup",({clientX:s,
clientY:a})=>{let[i,l]=[r,t()];if(r=null,!i||!l)return;let[c,u]=[s-i[0],a-i[1]],p=e.cellAt(s,a);Math.hypot(c,u)>=ol?n(Ls(u,c,l.diagonal)):p&&n(Ls(p[0]-l.cell[0],
p[1]-l.cell[1],l.diagonal))})}function Us(e,t){let n=r=>{let o=t[r]-e[r],s=ce.findIndex(a=>a[r]===Math.sign(o)&&a[1-r]===0);return o?`${Math.abs(o)} ${W[s]}`:""};
return[n(0),n(1)].filter(Boolean).join(", ")||"on your cell"}var al=[0,1,2,4,8],ln=class{element;player=new Fe(0,{speed:4,still:gt()});#e;#n;#t=d("canvas",{tabindex:0,"aria-describedby":"play-keys"});#r=d("h2");#o=d("p",{
class:"play-told",role:"status"});#s=$s(t=>this.act(t));#i=it(al.map(t=>[t,t?`${t} / s`:"step by step"]),()=>this.#x());#h=d("input",{type:"checkbox",onchange:()=>this.#T()});#c=d(
"input",{type:"checkbox",onchange:()=>this.#S()});#m=d("label",{class:"play-choice"},this.#c,"Best move");#d=d("p",{class:"small muted play-keys",id:"play-keys"});#u=d(
"section",{class:"play-ending",tabindex:-1,"aria-labelledby":"play-headline"});#f=Cs(this.player);#l=null;#a=null;#y=[];#p=null;#g=null;#v=[];#b=0;#w=0;constructor(t){
this.#e=t,this.#n=new Ge(this.#t,{numbers:!1}),this.#t.setAttribute("role","application"),Is(this.#n,()=>{let n=this.#p!==null&&this.#a&&C(this.#a.recording.moments.
at(-1),this.#p);return n?{cell:n,diagonal:this.#a.config.diagonal}:null},n=>this.act(n)),this.player.addEventListener("frame",()=>this.#a&&this.#n.show(this.#a.
recording,this.player.time)),this.player.addEventListener("step",()=>this.#S()),this.element=d("div",{class:"play"},d("header",{class:"play-head"},this.#r,this.#o),
d("div",{class:"play-stage"},this.#t),d("div",{class:"play-side"},this.#u,this.#s.element,d("label",{class:"play-choice",title:"Steps a second"},"Pace ",this.#i),
d("label",{class:"play-choice"},this.#h,d("span",{},"Fog",d("span",{class:"at-length"},": see only what it sees"))),this.#m,this.#d),this.#f)}get played(){return this.#l&&
{...this.#l.played,moves:this.#y}}get live(){return this.#a}play(t){this.#A(Qn(this.#e,t.played),t.played.seat,t.title),[this.#l,this.#y,this.#b]=[t,[...t.played.
moves],0],this.element.dataset.state="playing",this.#t.focus({preventScroll:!0}),rn(this.#a,t.played.seat)&&this.#k()}watch(t,n,r){this.#l=null,this.#A(t,n,r),this.#O()}stop(){
this.#x(),this.player.pause(),this.#l=null}act(t){let[n,r]=[this.#l,this.#a];if(!n||!r||this.element.dataset.state!=="playing")return;this.#b=t;let o=Number(this.#i.
value);this.#w||(this.#E(),o&&this.element.dataset.state==="playing"&&(this.#w=setInterval(()=>this.#E(),1e3/o)))}key(t){let{target:n,key:r}=t;if(n instanceof HTMLSelectElement||
n instanceof HTMLInputElement&&(n.type==="text"||r===" ")||n instanceof HTMLButtonElement&&(r===" "||r==="Enter")||!this.#a)return!1;if(this.element.dataset.state!==
"playing")return Dt(this.player,t);let s=Ps(t,this.#a.config.diagonal);return s!==void 0&&this.act(s),s!==void 0}#A(t,n,r){this.#x(),this.player.pause(),[this.#a,
this.#p]=[t,n],this.#r.textContent=r,this.#t.ariaLabel=`Board, ${t.config.rows} by ${t.config.cols} cells`,this.#s.show(t.config.diagonal),this.#d.replaceChildren(
d("span",{class:"at-length"},`W A S D or the arrow keys move, Space stays${t.config.diagonal?"; Q E Z C and the numeric keypad move diagonally":""}. `),"On the \
board: swipe, or tap where to go."),this.#R(t),this.#u.replaceChildren(),this.player.length=t.length,this.player.jump(t.length),this.#S()}#T(){this.#n.look={you:this.#p,
fog:this.#h.checked,viewers:this.#p===null?[]:[this.#p],plan:this.#N()}}#R(t){this.#g=null,this.#v=this.player.ticks=[],this.#m.hidden=this.#c.disabled=!!Ue(t.config),
Vt(this.#e,t.config,Yt(t.config)).then(n=>{this.#a===t&&(this.#g=n,this.#C(),this.#S())})}#C(){let[t,n]=[this.#a,this.#g];if(!n||this.element.dataset.state==="p\
laying")return;let r=this.#e.world(t.config);r.reset(t.start),this.#v=Zt(n,r,t.actions),r.free(),this.player.ticks=Fo(this.#v)}get#M(){return this.#c.checked&&this.#l&&
this.element.dataset.state==="playing"&&this.#g&&this.#a.game(this.#g)||null}#N(){let[t,n]=[this.#p,this.#p!==null&&this.#M?.marginal(this.#p)];return t!==null&&
n?Object.assign(Array(t).fill(0),{[t]:n.indexOf(Math.max(...n))}):null}#x(){clearInterval(this.#w),this.#w=0,this.#o.ariaLive=Number(this.#i.value)?"off":"polit\
e"}#E(){let[{policies:t,seat:n},r]=[this.#l.played,this.#a];r.step(t,n,this.#b),this.#y.push(this.#b),this.player.length=r.length,this.player.glide=Math.min(.22,
.9/(Number(this.#i.value)||4)),this.player.move(r.length-this.player.step),rn(r,n)&&this.#k()}#k(){this.#x();let[t,n,r]=[this.#l,this.#a,this.played],o=lt()?t.link(
r):null;this.#u.replaceChildren(d("h3",{id:"play-headline"},cl(n,r.seat)),...t.ending(n,r),d("div",{class:"play-buttons"},d("button",{type:"button",class:"prima\
ry",onclick:()=>t.again()},"Again"),d("button",{type:"button",onclick:()=>this.#O()},"Watch it"),d("button",{type:"button",onclick:()=>this.#_(n,r.seat)},"Save"),
o&&d("button",{type:"button",onclick:({currentTarget:a})=>dl(a,o)},"Link"))),this.element.dataset.state="ended",this.#C();let s=this.#v.filter(({team:a})=>a===ve(
n.config,r.seat));s.length&&this.#u.children[0].after(d("p",{class:"small muted"},Ho(s))),this.#u.focus({preventScroll:!0}),this.#u.scrollIntoView({block:"neare\
st"})}#O(){this.element.dataset.state="watched",this.player.length=this.#a.length,this.player.jump(0),gt()||this.player.play()}#_(t,n){Os(`${J(n,t.config.n_pursuers)}\
-${t.length}-steps.npz`,ws(this.#e,t,n))}#S(){let[t,n,{step:r}]=[this.#a,this.#p,this.player];if(!t||r>t.length)return;let o=Ms(t,t.recording,r).filter(({agents:l})=>n===
null||l.includes(n)),s=this.#l&&r===0,a=s?[il(t.config,n),this.#l.about??""]:[`Step ${r} of ${t.config.max_steps}`,...o.map(({text:l})=>l)];!s&&n!==null&&a.push(
ll(t,r,n)),a.push(...this.#v.filter(l=>l.step===r).map(bt));let i=r===t.length&&n!==null?this.#M:null;i&&a.push(`Perfect play: ${Jt(i,n)||"decided in its turn"}\
; ${qt(this.#g,i,r)}`),this.#T(),this.#o.textContent=a.filter(Boolean).map(l=>`${l}.`).join(" ")}};function il(e,t){let n=e.rules.capture==="SURROUND";return ve(
e,t)==="evader"?`Run away: you win if ${n?"the pursuers do not surround you":"no pursuer reaches your cell"} in ${e.max_steps} steps`:`Capture evaders: ${n?"sur\
round them with your team":"move onto their cells"}`}function ll({config:e,recording:t},n,r){let o=t.moments[n],a=ve(e,r)==="pursuer"?"evader":"pursuer";if(!o.alive[r])
return"";let i=C(o,r),l=p=>{let[m,h]=C(o,p);return Math.max(Math.abs(m-i[0]),Math.abs(h-i[1]))},c=Array.from({length:o.alive.length},(p,m)=>m).filter(p=>ve(e,p)===
a&&o.alive[p]&&!o.captured[p-e.n_pursuers]&&2*l(p)<e.fov);if(!c.length)return`No ${a} in view`;let u=c.reduce((p,m)=>l(m)<l(p)?m:p);return`Nearest ${a}: ${Us(i,
C(o,u))}`}function cl(e,t){let[{lasted:n,out:r,captured:o},{config:s}]=[ke(e,t),e];return ve(s,t)==="pursuer"?`Your team captured ${o} of ${ul(s)} in ${n} steps\
.`:r?`You lasted ${n} of ${s.max_steps} steps.`:`You escaped: ${n} steps.`}var ul=({n_evaders:e})=>`${e} evader${e===1?"":"s"}`;function dl(e,t){let n=ks("Link \
to this match");n.value=t,e.replaceWith(n),n.select(),navigator.clipboard?.writeText(t).catch(()=>{})}var Bs={escape:"Can you escape it?",match:"One match",file:"A match from a file"},cn=class extends EventTarget{element;view;game="escape";#e;#n;#t;#r=it([[0,"an\
 evader"],[1,"a pursuer"]],()=>{});#o;#s;#i;#h=d("ul",{class:"small muted about"});#c=d("p",{class:"problem",role:"alert"});#m=d("input",{type:"file",accept:".n\
pz",hidden:!0,onchange:()=>this.#y()});#d;constructor(t,n){super(),[this.#e,this.#n,this.view]=[t,n,new ln(t)],this.#t={pursuer:zs(n,"pursuer"),evader:zs(n,"eva\
der")};let r=o=>it(this.#t[o].map(({name:s},a)=>[a,s]),()=>this.#f());this.#o={pursuer:r("pursuer"),evader:r("evader")};for(let o of Ve)this.#o[o].selectedIndex=
n.teams[o].usual;this.#s=d("div",{class:"of-match"},d("label",{},"You are ",this.#r),d("label",{},"Pursuers ",this.#o.pursuer),d("label",{},"Evaders ",this.#o.evader),
d("button",{type:"button",class:"primary",onclick:()=>this.#l()},"Play"),this.#h),this.#i=d("div",{class:"of-match"},d("button",{type:"button",class:"primary",onclick:()=>this.#m.
click()},"Choose a file"),this.#m,d("span",{class:"small muted"},"A match that this page or matrixworld.Episode has saved (.npz)."),this.#c),this.#d=d("section",
{class:"card","aria-label":"Match"},this.view.element),this.element=d("section",{class:"games","aria-label":"Play"},d("div",{class:"card setup"},this.#s,this.#i),
this.#d)}begin(t){this.#u(t),t==="escape"?nr(this.view,this.#n.world,this.#t.pursuer):t==="match"?this.#l():(this.view.stop(),this.#d.hidden=!0)}follow(t){let n=Ts(
t,this.#n.world),[r,o]=[Number(t.get("pursuers")??NaN),Number(t.get("evaders")??NaN)],s=/^\d{1,20}$/.test(t.get("seed")??"")?BigInt.asUintN(64,BigInt(t.get("see\
d"))):null;return!n||s===null||!this.#t.pursuer[r]||!this.#t.evader[o]?!1:([this.#o.pursuer.selectedIndex,this.#o.evader.selectedIndex]=[r,o],this.#r.selectedIndex=
+(n.seat<this.#n.world.n_pursuers),this.#u("match"),this.#a({pursuer:r,evader:o,seed:s},n),!0)}#u(t){this.game=t,this.#s.hidden=t!=="match",this.#i.hidden=t!=="\
file",this.#s.parentElement.hidden=t==="escape",this.#d.hidden=!1,this.#c.textContent="",this.#f(),this.dispatchEvent(new Event("game"))}#f(){this.#h.replaceChildren(
...Ve.map(t=>{let{name:n,text:r}=this.#t[t][this.#o[t].selectedIndex];return d("li",{},d("span",{class:t},n),r&&`: ${r}`)}))}#l(){let{pursuer:t,evader:n}=this.#o,
r=this.#r.selectedIndex?0:this.#n.world.n_pursuers;this.#a({pursuer:t.selectedIndex,evader:n.selectedIndex,seed:on()},{seat:r,from:0,moves:[]})}#a(t,n){let[r,o]=[
this.#n.world,this.#t],s=Ve[+(n.seat>=r.n_pursuers)],[a,i]=[o.pursuer[t.pursuer],o.evader[t.evader]],l={pursuer:a.policy(),evader:i.policy()},c=`You are ${J(n.seat,
r.n_pursuers)}. Pursuers: ${a.name}; evaders: ${i.name}`;rr(this.#e,this.view,c,{config:r,seed:t.seed,episode:0,policies:l,...n},o[s],{pursuers:t.pursuer,evaders:t.
evader,seed:t.seed})}#y(){let[t]=this.#m.files??[];this.#c.textContent="",t?.arrayBuffer().then(n=>xs(this.#e,new Uint8Array(n))).then(({live:n,seat:r})=>{this.#u(
"file"),this.view.watch(n,r,t.name)}).catch(n=>this.#c.textContent=`${t.name} holds no match: ${n.message}`),this.#m.value=""}};function zs({teams:e},t){let{names:n,
texts:r,scripts:o,network:s}=e[t],a=i=>{let l=o[i];if(l||!s)return l;let[c,u]=[s.genome_size,o.slice(0,i).filter(p=>p===null).length];return{...s,genome:hs(t,c).
subarray(u*c,(u+1)*c)}};return n.map((i,l)=>({name:i.replaceAll("-"," "),text:r[l],policy:()=>a(l)}))}var Fs={ArrowUp:1,ArrowRight:2,ArrowDown:3,ArrowLeft:4},pl={e:5,c:6,y:7,z:7,q:8};function js(e){let t=d("div",{class:"arena"}),n=[Ds(e,0),Ds(e,1)];return t.append(
...n.map(r=>r.element)),e.shownBy(()=>n.forEach(r=>r.update()),"frame"),t}function Ds(e,t){let n=d("canvas",{tabindex:0,"aria-describedby":"board-keys"}),r=d("h\
2",{class:"arm-name"}),o=d("figure",{class:"arm"},r,n),s=new Ge(n,{axes:!0,trail:1}),a={cell:[0,0]};ml(e,s);let i=()=>{let l=e.games[t];if(o.hidden=!l,!l)return;
let{mode:c,scene:u}=e;n.setAttribute("role","application"),n.ariaLabel=`Board, ${u.rows} by ${u.cols} cells`,n.dataset.mode=c,r.textContent=be(e,t),r.hidden=e.games.
length<2;let p=e.player.arrived&&e.player.step===e.game.length;s.look={plan:c==="act"&&p&&!l.over?l.actions(u.next):null,selected:c==="act"?e.selected:null,cursor:c===
"build"&&document.activeElement===n?a.cell:null},s.show(l.recording,e.player.time)};return n.addEventListener("focus",i),n.addEventListener("blur",i),yl(e,n,a,i),
{element:o,update:i}}function be(e,t){let n=t?e.scene.others:e.scene.rules;return n&&De(n,e.data.variants)||"own rules"}function ar(e,t){let n=ee(e.game.scene())[t];
return n&&!n.gone?n.cell:null}function ml(e,t){let n=null;t.canvas.addEventListener("pointerdown",r=>{let o=t.cellAt(r.clientX,r.clientY);if(!o||r.button!==0||e.
running)return;t.canvas.setPointerCapture(r.pointerId);let s=t.agentAt(r.clientX,r.clientY);n=e.mode==="build"?fl(e,o,s):hl(e,o,s)}),t.canvas.addEventListener("\
pointermove",r=>{let o=t.cellAt(r.clientX,r.clientY);o&&n?.(o)});for(let r of["pointerup","pointercancel"])t.canvas.addEventListener(r,()=>n=null)}function hl(e,t,n){
if(n===null){let s=e.selected===null?null:ar(e,e.selected);return s&&Math.max(Math.abs(s[0]-t[0]),Math.abs(s[1]-t[1]))===1&&Ze(e,mt(s,t,e.scene.diagonal)),null}
let r=e.selected===n;e.selected=n;let o=ar(e,n);return o?(r&&Ze(e,0),s=>Ze(e,mt(o,s,e.scene.diagonal))):null}function fl(e,t,n){let r=!1,o=i=>{e.change(i,{part:r}),
r=!0};if(n!==null)return e.selected=n,i=>{let l=e.game.scene();fe(l,i)===null&&!ye(l,i)&&o(En(l,n,i))};let s=!ye(e.game.scene(),t),a=i=>{let l=e.game.scene();fe(
l,i)===null&&ye(l,i)!==s&&o(kn(l,i,s))};return a(t),a}function Ze(e,t){let{selected:n,scene:r}=e;n===null||e.running||e.game.over||(r.next[n]!==t&&e.change(It(r,
n,t)),e.say(`${te(r,n)}: ${W[t]}.`))}function yl(e,t,n,r){t.addEventListener("keydown",o=>{if(o.ctrlKey||o.metaKey||o.altKey)return;let s=e.mode==="act"?ir(e,o):
gl(e,o,n);r(),s&&o.preventDefault()})}function ir(e,t){let n=t.key.length===1?t.key.toLowerCase():t.key,r=Fs[n]??(e.scene.diagonal?pl[n]:void 0)??{s:0,Delete:0}[n];
return r!==void 0?(e.selected===null&&Ws(e,1),Ze(e,r),!0):n!=="n"&&n!=="p"?!1:(Ws(e,n==="n"?1:-1),!0)}function Ws(e,t){let n=G(e.scene),r=e.game.recording.moments.
at(-1).alive,o=e.selected??(t>0?-1:n);for(let s=0;s<n;s++){if(o=(o+t+n)%n,!r[o])continue;e.selected=o;let[a,i]=ar(e,o);return e.say(`${te(e.scene,o)} at (${a}, ${i}\
).`)}}function gl(e,t,n){let r=e.game.scene(),o=Fs[t.key];if(o!==void 0){let a=t.shiftKey?fe(r,n.cell):null,i=[n.cell[0]+ce[o][0],n.cell[1]+ce[o][1]];ht(r,i)&&(n.
cell=i);let l=fe(r,n.cell)===null&&!ye(r,n.cell);a!==null&&l&&e.change(En(r,a,n.cell));let[c,u]=n.cell;return e.say(`(${c}, ${u}): ${vl(e,n.cell)}.`),!0}let s=fe(
r,n.cell);return t.key===" "||t.key==="Enter"?(s===null?e.change(kn(r,n.cell,!ye(r,n.cell))):e.selected=s,!0):t.key==="Delete"&&s!==null?(e.change(Ut(r,s)),!0):
!1}function vl(e,t){let n=e.game.scene(),r=fe(n,t);return r!==null?te(n,r):ye(n,t)?"obstacle":"free"}function lr(e){let t=e==="pursuers"?xe("path",{d:"M12 3 22 20H2z"}):xe("circle",{cx:12,cy:12,r:9.5});return xe("svg",{viewBox:"0 0 24 24",class:`glyph ${e}`,"ar\
ia-hidden":!0},t)}function Hs(e){let t=[0,1].map(()=>d("th",{class:"reward",scope:"col"})),n=d("tbody"),r=d("table",{class:"agents"},d("thead",{},d("tr",{},d("t\
h",{scope:"col"},"agent"),d("th",{scope:"col"},"next"),...t)),n),o=d("section",{class:"card agents-card"},d("h2",{},"Agents"),e.data.champions?d("button",{type:"\
button",title:"The networks of the match move all agents but the chosen one",onclick:()=>bl(e)},"Networks move all others"):"",d("div",{class:"agents-scroll"},r)),
s=[],a="",i=()=>{let{scene:l}=e,c=`${l.pursuers.length} ${l.evaders.length} ${l.diagonal}`;c!==a&&(a=c,s=Array.from({length:G(l)},(u,p)=>wl(e,p)),n.replaceChildren(
...s.map(u=>u.element))),t.forEach((u,p)=>{u.hidden=p>=e.games.length,u.textContent=e.games.length>1&&e.games[p]?be(e,p):"reward",u.title="Reward of the step"}),
s.forEach((u,p)=>Sl(e,u,p))};return e.shownBy(i),o}function bl(e){e.stop(),e.change({...e.scene,next:e.scene.next.map((t,n)=>n===e.selected?t:he)})}function wl(e,t){
let{scene:n}=e,r=te(n,t),o=d("select",{"aria-label":`${r} does next`,onchange:()=>{let u=o.value;e.stop(),e.change(It(e.scene,t,/^\d$/.test(u)?Number(u):u))}},...xl(
e,n,t)),s=d("span",{class:"state muted"}),a=d("span",{class:"heard"}),i=d("button",{type:"button",class:"agent-name",onclick:()=>e.selected=t},lr(Cn(n,t)),r,a),
l=[0,1].map(()=>d("td",{class:"reward numbers"}));return{element:d("tr",{},d("th",{scope:"row"},i),d("td",{},o,s),...l),choice:o,state:s,heard:a,rewards:l}}function xl(e,t,n){
let r=W.slice(0,t.diagonal?9:5).map((i,l)=>d("option",{value:l},Rs(l))),o=e.data.scripts.map(({name:i,text:l})=>d("option",{value:i,title:l},i)),s=[d("optgroup",
{label:"move"},...r),d("optgroup",{label:"script"},...o)],a=e.data.champions?.[n<t.pursuers.length?"pursuer":"evader"];return a?[d("option",{value:he},a.name),...s]:
s}function Sl(e,{element:t,choice:n,state:r,heard:o,rewards:s},a){let{scene:i,game:l,player:c}=e,u=l.recording.moments[Math.min(c.step,l.length)],p=a-i.pursuers.
length,m=p>=0&&!!u.captured[p];t.classList.toggle("chosen",e.selected===a),t.classList.toggle("gone",!u.alive[a]),n.value=String(i.next[a]),n.disabled=!u.alive[a]||
l.over,n.hidden=!u.alive[a],r.hidden=!!u.alive[a],r.textContent=m?"captured":"gone",t.classList.toggle("captured",m),o.textContent=m?" captured":"",s.forEach((h,f)=>{
let y=e.games[f];h.hidden=!y;let g=y?.outcomes[c.step]?.rewards[a],v=y?_s(i,y,c.step,a):"";h.replaceChildren(c.step&&g!==void 0?an(g):"",e.games.length>1?"":d("\
span",{class:"sum small muted"},v)),h.title=v;let x=l.outcomes[c.step]?.rewards[a];h.classList.toggle("differs",f>0&&g!==void 0&&x!==g)})}function Gs(e){let t=e.data.gallery.map(i=>d("button",{type:"button",class:"chip",onclick:()=>{e.stop(),e.mode="act",e.change(dt(i.scene,e.data),{example:i}),e.
selected=0}},i.title)),n=d("p",{class:"example-text"}),r=d("p"),o=d("details",{class:"reveal"},d("summary",{},"Reveal"),r),s=d("nav",{class:"gallery","aria-labe\
l":"Examples"},d("div",{class:"chips"},...t),n,o),a;return e.shownBy(()=>{e.data.gallery.forEach((i,l)=>t[l].setAttribute("aria-pressed",String(i===e.example))),
n.replaceChildren(...Ot(e.example?.ask??"A scene of your own. Choose an example, or change this one.")),r.replaceChildren(...Ot(e.example?.text??"")),o.hidden=!e.
example,a!==e.example&&(o.open=!1),a=e.example}),s}function Ks(e){let t=Al(e),n=Tl(e),r=Ml(e),o=Cl(e),s=d("p",{class:"message",role:"status"});e.addEventListener("message",i=>{let{text:l,problem:c}=i.detail;s.textContent=
l,s.classList.toggle("problem",c)});let a=[t,n,r,o];return e.addEventListener("change",()=>{s.textContent="",s.classList.remove("problem")}),e.shownBy(()=>a.forEach(
i=>i.update())),d("div",{class:"toolbar"},...a.map(i=>i.element),s)}function un(e,t,n,r){return d("button",{type:"button",title:`${t} (${n})`,onclick:r},Et(e),d(
"span",{},t))}function Al(e){let t=un("first","Restart","Home",()=>e.restart()),n=un("back","Back","Backspace",()=>e.back()),r=un("forward","Step","Enter",()=>e.
step()),o=un("play","Run","Space",()=>e.run());return r.classList.add("primary"),r.id="step",{element:d("div",{class:"buttons",role:"group","aria-label":"Steps"},
t,n,r,o),update:()=>{for(let s of[t,n])s.setAttribute("aria-disabled",String(!e.game.length));r.setAttribute("aria-disabled",String(!e.canStep)),o.setAttribute(
"aria-disabled",String(!e.canStep&&!e.running)),o.replaceChildren(Et(e.running?"pause":"play"),d("span",{},e.running?"Stop":"Run"))}}}function Tl(e){let t={act:"\
Move",build:"Build"},n={act:"Choose agents and their moves (M)",build:"Place agents and draw obstacles (M)"},r=Object.keys(t),o=r.map(s=>d("button",{type:"butto\
n",title:n[s],onclick:()=>e.mode=s},t[s]));return{element:d("div",{class:"buttons joined",role:"group","aria-label":"What the board does"},...o),update:()=>r.forEach(
(s,a)=>o[a].setAttribute("aria-pressed",String(e.mode===s)))}}function Cl(e){let t=(s,a,i)=>d("button",{type:"button",title:`Add ${a} (${i})`,"aria-label":`Add ${a}`,
onclick:()=>dn(e,s)},"+",lr(s)),n=d("button",{type:"button",title:"Remove the chosen agent (Delete)",onclick:()=>cr(e)},"Remove"),r=[t("pursuers","a pursuer","+"),
t("evaders","an evader","-"),n],o=d("div",{class:"buttons",role:"group","aria-label":"Agents"},...r);return{element:o,update:()=>{o.hidden=e.mode!=="build",n.setAttribute(
"aria-disabled",String(e.selected===null))}}}function Ml(e){let t=[8,7,4,1,0,3,2,5,6],n=t.map(o=>d("button",{type:"button","aria-label":W[o],title:`The chosen a\
gent: ${W[o]}`,onclick:()=>Ze(e,o)},kt[o])),r=d("div",{class:"buttons pad",role:"group","aria-label":"Move of the chosen agent"},...n);return{element:r,update:()=>{
r.hidden=e.mode==="build";let o=e.selected===null?void 0:e.scene.next[e.selected];t.forEach((s,a)=>{let i=n[a];i.hidden=s>4&&!e.scene.diagonal,i.setAttribute("a\
ria-disabled",String(e.selected===null||e.game.over)),i.setAttribute("aria-pressed",String(o===s))})}}}function Vs(e){let t=d("button",{type:"button",title:"Und\
o the last change (Ctrl+Z)",onclick:()=>e.undo()},"Undo");return e.shownBy(()=>t.setAttribute("aria-disabled",String(!e.canUndo))),t}function dn(e,t){let n=e.game.
scene(),r=Gr(n);if(!r)return e.say("Every cell is taken.",!0);if(n[t].length>=ze)return e.say(`${t}: expected at most ${ze}`,!0);let o=t==="pursuers"?n.pursuers.
length:G(n);e.change(jr(n,t,r))&&(e.selected=o)}function cr(e){let{selected:t}=e;if(t===null)return e.say("Choose an agent to remove.",!0);let n=Ut(e.game.scene(),
t);n.pursuers.length&&n.evaders.length?e.change(n):e.say("A team needs at least one agent.",!0)}function Ys(e,t,n){let r=Object.keys(e.data.variants),o={Enter:()=>e.step(),Backspace:()=>e.back(),Home:()=>e.restart()," ":()=>e.run(),m:()=>e.mode=e.mode==="a\
ct"?"build":"act",d:An,"?":t},s={"+":()=>dn(e,"pursuers"),"-":()=>dn(e,"evaders"),Delete:()=>cr(e)};document.addEventListener("keydown",a=>{if(!n()||a.defaultPrevented||
document.querySelector("dialog[open]"))return;let i=a.key.length===1?a.key.toLowerCase():a.key;if((a.ctrlKey||a.metaKey)&&!a.altKey){let u={z:()=>a.shiftKey?e.redo():
e.undo(),y:()=>e.redo()}[i];u&&!Zs(a.target)&&(a.preventDefault(),u());return}if(a.altKey||El(a.target,i))return;let l=r[Number(i)-1],c=o[i]??(e.mode==="build"?
s[i]:void 0);if(c)c();else if(l)e.change({...e.scene,rules:e.data.variants[l]});else if(e.mode!=="act"||!ir(e,a))return;a.preventDefault()})}var Zs=e=>e instanceof
HTMLInputElement&&!["radio","checkbox"].includes(e.type);function El(e,t){return Zs(e)||e instanceof HTMLSelectElement?!0:e instanceof HTMLInputElement?t===" "||
t.startsWith("Arrow"):e instanceof HTMLButtonElement?t===" "||t==="Enter":e instanceof HTMLElement&&e.classList.contains("story-body")&&t.startsWith("Arrow")}var kl=[
[["Enter"],"play a step"],[["Backspace"],"take the last step back"],[["Home"],"back to the start"],[["Space"],"run, or stop"],[["N","P"],"choose the next agent,\
 or the one before"],[["↑","→","↓","←"],"the chosen agent moves there next"],[["Q","E","C","Y"],"the same on a diagonal, where the board allows it"],[["\
S"],"the chosen agent stays"],[["1","… 9"],"choose a variant"],[["M"],"change between Move and Build"],[["Ctrl Z","Ctrl Y"],"undo, redo"],[["D"],"light or dar\
k"],[["?"],"these keys"]],Ol=[[["↑","→","↓","←"],"move the cursor on the board"],[["Space"],"draw or erase an obstacle, or choose the agent there"],[["S\
hift ↑"],"carry the agent under the cursor"],[["+","-"],"add a pursuer, an evader"],[["Delete"],"remove the agent under the cursor"]],qs=()=>Es("Keys","",d("d\
iv",{class:"keys-columns"},d("div",{},d("h3",{},"Anywhere"),or(kl)),d("div",{},d("h3",{},"On the board, in Build"),or(Ol),d("h3",{},"With mouse or finger"),d("p",
{},"Move: press an agent and drag it towards a cell beside it, or choose it and press that cell."),d("p",{},"Build: drag agents; draw on free cells to make obst\
acles, on obstacles to erase them."))));function Js(e){let t=d("ul",{class:"lines","aria-live":"polite"}),n=d("details",{class:"card perfect"},d("summary",{},d("h2",{},"Perfect play")),t,d("p",{class:"\
small muted"},"A team is one player here. An agent's shares are its part of the joint moves.")),r=0,o=(...a)=>t.replaceChildren(...a.filter(Boolean).map(i=>d("l\
i",{class:"line"},`${i}.`))),s=async()=>{let a=++r;if(!n.open)return;let i=Ue(We(e.scene,e.scene.rules));if(i)return o(`Not known: ${i}`);let l=await e.solution();
if(a!==r||!l)return;let{game:c,losses:u}=e.game.perfect(l),p=Array.from({length:G(e.scene)},(h,f)=>{let y=c&&Jt(c,f);return y?`${te(e.scene,f)}: ${y}`:""}),m=e.
game.over?"The episode has ended":"Not known: no start on distinct free cells leads to this moment";o(...u.map(h=>`In the last step: ${bt(h)}`),c?`From here: ${qt(
l,c,e.game.length)}`:m,...p)};for(let[a,i]of[[e,"change"],[n,"toggle"]])a.addEventListener(i,()=>{s()});return n}function Xs(e){let t=[Rl(e),...e.data.fields.map(n=>Nl(e,n)),Ll(e),Pl(e)];return e.shownBy(()=>t.forEach(n=>n.update())),d("section",{class:"card rules"},...t.map(
n=>n.element))}var qe=(e,t)=>{e.stop(),e.change(t)};function Rl(e){let t=Object.keys(e.data.variants),n=t.map(o=>d("button",{type:"button",class:"chip",title:e.
data.titles[o],onclick:()=>qe(e,{...e.scene,rules:e.data.variants[o]})},o)),r=d("p",{class:"muted small variant-title"});return{element:d("div",{class:"variants"},
d("h2",{},"Rules"),d("div",{class:"chips",role:"group","aria-label":"Variant"},...n),r),update:()=>{let o=De(e.scene.rules,e.data.variants);t.forEach((s,a)=>n[a].
setAttribute("aria-pressed",String(s===o))),r.textContent=o?e.data.titles[o]:"Rules of your own"}}}function Nl(e,t){let n=t.values.map(({name:a})=>d("input",{type:"\
radio",name:t.name,value:a,onchange:()=>qe(e,{...e.scene,rules:_l(e.scene.rules,t,a)})})),r=t.values.map(({label:a},i)=>d("label",{},n[i],d("span",{},a))),o=d("\
span",{class:"used-mark",title:"This rule decided what happened in the step that is shown"},d("span",{},"decided")),s=d("fieldset",{class:"field",title:t.text},
d("legend",{},t.label,o),d("div",{class:"segments"},...r));return{element:s,update:()=>{let{rules:a}=e.scene;n.forEach(l=>l.checked=l.value===String(a[t.name])),
s.disabled=t.name==="captured_disappear"&&a.capture==="OCCUPATION";let i=Math.min(e.player.step,e.game.length);o.hidden=!sn(e.scene,e.game,i).some(l=>l.used.includes(
t.name))||s.disabled}}}function _l(e,t,n){return{...e,[t.name]:n==="true"?!0:n==="false"?!1:n}}function Ll(e){let t=Object.keys(e.data.variants),n=d("select",{id:"\
compare"},d("option",{value:""},"nothing"),d("option",{value:"present"},"the present rules"),d("option",{value:"own",hidden:!0},"own rules"),...t.map(r=>d("opti\
on",{value:r},`${r}: ${e.data.titles[r]}`)));return n.addEventListener("change",()=>{let r={"":null,present:e.scene.rules}[n.value];qe(e,{...e.scene,others:r===
void 0?e.data.variants[n.value]:r})}),{element:d("div",{class:"pair"},d("label",{for:"compare"},"Compare with"),n),update:()=>{let{others:r}=e.scene,o=r&&t.find(
s=>Mn(r,e.data.variants[s]));n.value=r?o??"own":"",n.title=r?`Both boards play the same moves: ${be(e,0)} and ${be(e,1)}`:""}}}function Pl(e){let t=(a,i)=>{let l=d(
"input",{type:"number",min:1,max:Ae,"aria-label":i,onchange:()=>{let c={rows:e.scene.rows,cols:e.scene.cols,[a]:Math.round(Number(l.value))};c[a]>=1&&c[a]<=Ae?$l(
e,c.rows,c.cols):e.say(`${a}: expected 1 to ${Ae}, got ${l.value||"nothing"}`,!0),l.value=String(e.scene[a])}});return l},[n,r]=[t("rows","Rows"),t("cols","Colu\
mns")],o=d("input",{type:"checkbox",id:"diagonal",onchange:()=>qe(e,{...e.game.scene(),diagonal:o.checked,next:e.scene.next.map(a=>typeof a=="number"&&a>4?0:a)})}),
s=d("select",{id:"rewards",onchange:()=>qe(e,{...e.scene,rewards:e.data.rewards[s.value]})},...Object.keys(e.data.rewards).map(a=>d("option",{value:a},a)),d("op\
tion",{value:"own",hidden:!0},"those of the link"));return{element:d("div",{class:"board-settings"},d("div",{class:"pair"},d("span",{},"Board"),d("span",{class:"\
sides"},n,"×",r),d("label",{class:"sides"},o,"diagonal")),d("div",{class:"pair"},d("label",{for:"rewards"},"Rewards"),s)),update:()=>{let{scene:a}=e;document.activeElement!==
n&&(n.value=String(a.rows)),document.activeElement!==r&&(r.value=String(a.cols)),o.checked=a.diagonal;let i=JSON.stringify(a.rewards);s.value=Object.keys(e.data.
rewards).find(l=>JSON.stringify(e.data.rewards[l])===i)??"own"}}}function $l(e,t,n){let r=Hr(e.game.scene(),t,n);r.pursuers.length&&r.evaders.length?qe(e,r):e.say(
`No ${r.pursuers.length?"evader":"pursuer"} would be left on a ${t} × ${n} board.`,!0)}var Qs={obstacle:"obstacle",teammate:"teammates",adversary:"adversaries",capture:"capture",end:"end",calm:""};function ea(e){let t=d("h2"),n=d("div",{class:"sto\
ry-body",tabindex:0,role:"region","aria-label":"What happened"}),r=d("div",{class:"heard",role:"status"}),o=d("section",{class:"card story"},t,n,r),s="";return e.
shownBy(()=>{let a=Math.min(e.player.step,e.game.length),i=e.games.map((c,u)=>{let p=sn(e.scene,c,a);return{name:e.games.length>1?be(e,u):"",lines:p,ended:a>c.length}}),
l=JSON.stringify([a,i]);l!==s&&(s=l,t.textContent=a?`Step ${a}`:"Start",n.replaceChildren(...i.map(c=>Il(c,a))),r.textContent=a?`Step ${a}. ${i.map(zl).join(" ")}`:
"")}),o}function Il({name:e,lines:t,ended:n},r){let s=n||!r?d("p",{class:"muted"},n?"The episode had ended.":"Give agents their moves, then play a step."):d("ul",
{class:"lines"},...t.map(Ul));return d("div",{class:"story-part"},e&&d("h3",{},e),s)}function Ul({kind:e,text:t,turn:n,blame:r,cost:o}){let s=n?`${Qs[e]}, turn ${n}`:
Qs[e];return d("li",{class:`line line-${e}`},s&&d("span",{class:"tag"},s),d("span",{class:"line-text"},...Ot(t)),r&&d("span",{class:"line-blame muted"},r),o&&d(
"strong",{},o))}var zl=({name:e,lines:t,ended:n})=>[e,...n?["The episode had ended."]:t.map(({text:r,blame:o,cost:s})=>[r,o,s].filter(Boolean).join(" "))].filter(
Boolean).join(" ");function ta(e,t){let n=qs(),r=()=>n.showModal();return Ys(e,r,t),{element:d("section",{class:"scene","aria-label":"Rules and conflicts"},Gs(e),d("div",{class:"l\
ayout"},Xs(e),d("section",{class:"card stage","aria-label":"Board"},js(e),Ks(e)),d("div",{class:"side"},ea(e),Hs(e),Js(e)))),tools:[Vs(e),d("button",{type:"butt\
on",title:"Keys (?)","aria-label":"Keys (?)",onclick:r},"?")],dialog:n}}var na={...Bs,scene:"Rules and conflicts"},ra={games:"You move one agent. Scripts, or networks that evolved, move all others.",scene:"Give agents their moves, p\
redict what happens, and play the step."};async function Bl(e){let[t,n,r]=[Zo(),await $r(),Ee()],{store:o,problem:s}=Go(n,t,wt(r)?t.scene:r||t.scene),a=t.play&&
new cn(n,t.play),i="scene",l=ta(o,()=>i==="scene"),c=d("span"),u=Object.keys(na),p=u.map(f=>d("button",{type:"button",onclick:()=>f==="scene"?m(f):a.begin(f)},na[f])),
m=f=>{i=f;let y=i==="scene";u.forEach((g,v)=>p[v].setAttribute("aria-pressed",String(g===i)));for(let g of[l.element,...l.tools])g.hidden=!y;a&&(a.element.hidden=
y),c.textContent=y?ra.scene:ra.games,y?a?.view.stop():o.stop(),lt()&&(y?o.dispatchEvent(new Event("change")):history.replaceState(null,"",location.href.split("#")[0]))},
h=f=>wt(f)&&!!a?.follow(new URLSearchParams(f));a?.addEventListener("game",()=>m(a.game)),e.classList.add("playground"),e.replaceChildren(Dr("Playground",c,...l.
tools),d("nav",{class:"tabs buttons","aria-label":"What to play",hidden:!a},...p),d("main",{},a&&a.element,l.element),d("footer",{class:"muted small"},`${t.title}\
 · matrixworld ${t.version}`),l.dialog),document.addEventListener("keydown",f=>i!=="scene"&&a.view.key(f)&&f.preventDefault()),lt()&&Yo(o,()=>i==="scene",()=>m(
"scene")),window.addEventListener("hashchange",()=>h(Ee())),h(r)||(a&&!t.scene&&(!r||wt(r))?a.begin("escape"):m("scene")),s&&o.say(s,!0),Object.assign(window,{playground:o,
matrixworldPlay:a?.view})}Ur(Bl(document.getElementById("page")));})();
