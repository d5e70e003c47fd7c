/* built from web/ by "npm run build"; sources c5a95fe3a004d169923cbb5169ffed4ea856e5554092dbc969a9bf4432a8b4b4 */
"use strict";(()=>{var rn={SIMULTANEOUS:0,SWARM_TURNS:1,AGENT_TURNS:2},Ze={DISAPPEAR:0,REACH:1,BOUNCE:2},nn={OCCUPATION:0,SURROUND:1},on={FAULT:0,INVOLVED:1};var ir=["obstacle","teammate","adversary"],lr=["vertex","edge","chain"],sn=["turn","kind","form","first","second","row","col","at_fault","held","doomed"],cr=["p\
ursuer_{number}","evader_{number}"],an={obstacle:"{first} ran into the obstacle or border at {cell}",vertex:"{first} and {second} both headed for {cell}",edge:"\
{first} and {second} meant to swap, {first} to {cell}",chain:"{first} headed for {cell}, where {second} had to stay"},Je={"both held":"both bounce","both doomed":"\
both disappear",held:"{agent} bounces",doomed:"{agent} disappears",none:"nobody is stopped"},ln="{event}: {outcome}",ur={random:"any action, all equally likely",
still:"always stays",chaser:"moves to where the nearest adversary in view is nearest",fleer:"moves to where the nearest adversary in view is farthest","clumsy-c\
haser":"a chaser that takes any action in half of the steps",hunter:"a chaser of the nearest adversary in view to which no teammate in view is nearer",surrounder:"\
a chaser of the nearest free cell beside an adversary without a teammate","clumsy-fleer":"a fleer that takes any action in half of the steps",dodger:"moves to w\
here all adversaries in view together are farthest","team-surrounder":"shares the free cells beside adversaries with its teammates, and searches","careful-rando\
m":"as random, but takes only moves that right of way allows","careful-chaser":"as chaser, but takes only moves that right of way allows","careful-fleer":"as fl\
eer, but takes only moves that right of way allows","careful-clumsy-chaser":"as clumsy-chaser, but takes only moves that right of way allows","careful-hunter":"\
as hunter, but takes only moves that right of way allows","careful-surrounder":"as surrounder, but takes only moves that right of way allows","careful-clumsy-fl\
eer":"as clumsy-fleer, but takes only moves that right of way allows","careful-dodger":"as dodger, but takes only moves that right of way allows","careful-team-\
surrounder":"as team-surrounder, but takes only moves that right of way allows"},cn={free:".GS",blocked:"#@OTW"};var Pe=1+sn.length;function Xe(t,e){return t.replace(/\{(\w+)\}/g,(r,n)=>String(e[n]))}function K(t,e){return t<e?Xe(cr[0],{number:t}):Xe(cr[1],{number:t-e})}function ca(t,e){
let[r,n,o,s,a,i,l,...c]=Array.from(t),u=a<0?[s]:[s,a],[m,d,h]=c.map(w=>u.filter((b,v)=>w>>v&1)),y=u.map(w=>K(w,e)),f=Xe(an[a<0?"obstacle":lr[o]],{first:y[0],second:y[y.
length-1],cell:`(${i}, ${l})`}),g=Xe(ln,{event:f,outcome:ua(u.length,d,h,e)});return{kind:ir[n],form:lr[o],agents:u,cell:[i,l],at_fault:m,held:d,doomed:h,turn:r,
text:g}}function ua(t,e,r,n){if(t===2&&e.length===2)return Je["both held"];if(t===2&&r.length===2)return Je["both doomed"];let o=s=>a=>Xe(Je[s],{agent:K(a,n)});
return[...e.map(o("held")),...r.map(o("doomed"))].join(", ")||Je.none}function wt(t,e){let r=[];for(let n=0;n<t.length;n+=Pe)r.push(ca(t.subarray(n+1,n+Pe),e));
return r}var we=class extends Error{name="EngineError"};function I(t,e,r){let n=typeof r=="string"?`'${r}'`:typeof r=="object"?JSON.stringify(r):String(r);return new we(
`${t}: expected ${e}, got ${n}`)}var Le=class{bytes;constructor(e){this.bytes=e}},pn=0,pr=[Uint8Array,Uint8Array,Int32Array,BigInt64Array,BigUint64Array,Float32Array,Float64Array],un=4,mn=4,ma=new TextEncoder,
pa=new TextDecoder;function da(t){for(let e=pr.length-1;e>pn;--e)if(t instanceof pr[e])return e;throw new TypeError("array: expected a typed array of the engine\
's numbers, got another")}function mr(t){return new Uint8Array(t.buffer,t.byteOffset,t.byteLength)}function ha(t){return ma.encode(`${t}\0`)}var dr=class{engine;addresses=[];constructor(e){
this.engine=e}copy(e){let r=this.engine._malloc(Math.max(e.length,1));if(r===0)throw new we("memory: expected room for the arguments, got none");return this.addresses.
push(r),this.engine.HEAPU8.set(e,r),r}text(e){return this.copy(ha(e))}arrays(e){let r=Object.entries(e),n=r.flatMap(([s,a])=>{let i=a instanceof Le,l=i?a.bytes:
a;return[this.text(s),i?pn:da(l),l.length,this.copy(mr(l))]}),o=this.copy(mr(Int32Array.from(n)));return this.copy(mr(Int32Array.of(r.length,o)))}free(){for(let e of this.
addresses)this.engine._free(e)}};function dn(t,e){let r=t.HEAPU8;return pa.decode(r.subarray(e,r.indexOf(0,e)))}function Ne(t){let e=new Int32Array(t.HEAPU8.buffer),
r=t._last_outputs()/un,n=e[r+1]/un,o={};for(let s=n;s<n+e[r]*mn;s+=mn){let a=pr[e[s+1]],i=e[s+2]*a.BYTES_PER_ELEMENT,l=e[s+3];o[dn(t,e[s])]=new a(t.HEAPU8.slice(
l,l+i).buffer)}return o}function xe(t,e){let r=new dr(t);try{let n=e(r);if(n===0)throw new we(dn(t,t._last_error()));return n}finally{r.free()}}var fa=2**31-1,hn=["none","gru"],ya=2n**64n-1n,ga=34028234663852886e22;function he(t,e){if(typeof e!="number"||!Number.isInteger(e)||Math.abs(e)>fa)throw I(t,"a\
n integer",e);return Int32Array.of(e)}function xt(t,e){if(typeof e!="boolean")throw I(t,"true or false",e);return new Le(Uint8Array.of(Number(e)))}function Te(t,e,r){
let n=typeof e=="string"&&Object.hasOwn(r,e)?r[e]:void 0;if(n===void 0)throw I(t,`one of ${Object.keys(r).join(", ")}`,e);return Int32Array.of(n)}function hr(t,e){
if(typeof e!="number"||!(Math.abs(e)<=ga))throw I(t,"a finite number",e);return e}function Qe(t,e){let n=typeof e=="bigint"||typeof e=="number"&&Number.isSafeInteger(
e)?BigInt(e):-1n;if(n<0n||n>ya)throw I(t,"an integer from 0 to 2^64 - 1",e);return BigUint64Array.of(n)}function va(t){return{"rules.interaction":Te("interactio\
n",t.interaction,rn),"rules.obstacle":Te("obstacle",t.obstacle,Ze),"rules.teammate":Te("teammate",t.teammate,Ze),"rules.evader":Te("evader",t.evader,Ze),"rules.\
pursuer":Te("pursuer",t.pursuer,Ze),"rules.capture":Te("capture",t.capture,nn),"rules.captured_disappear":xt("captured_disappear",t.captured_disappear)}}function fn(t,e){
let r=typeof e=="number"?[e,e,e]:e;if(!Array.isArray(r)||r.length!==3)throw I(t,"1 or 3 numbers",e);return Float32Array.from(r,n=>hr(t,n))}function ba(t){let e=(r,n)=>Float32Array.
of(hr(r,t[r]),hr(n,t[n]));return{"rewards.capture":e("pursuer_capture","evader_capture"),"rewards.neighbor":e("pursuer_neighbor","evader_neighbor"),"rewards.ste\
p":e("pursuer_step","evader_step"),"rewards.pursuer_collide":fn("pursuer_collide",t.pursuer_collide),"rewards.evader_collide":fn("evader_collide",t.evader_collide),
"rewards.blame":Te("blame",t.blame,on),"rewards.capture_repeats":xt("capture_repeats",t.capture_repeats)}}function gn(t){if(t===void 0||typeof t=="number")return new Uint8Array(
0);if(t instanceof Uint8Array)return t;let{free:e,blocked:r}=cn;for(let[n,o]of t.entries()){if(o.length!==t[0]?.length)throw I(`map, row ${n}`,`${t[0]?.length} \
cells as in row 0`,o.length);let s=[...o].find(a=>!e.includes(a)&&!r.includes(a));if(s)throw I(`map, row ${n}`,`'${e}' (free) or '${r}' (obstacle)`,s)}return Uint8Array.
from([...t.join("")],n=>Number(r.includes(n)))}function vn(t,e){if(!Array.isArray(t))return;let r=[t.length,t[0]?.length??0];if(!(r[0]===e.rows&&r[1]===e.cols))
throw I("obstacle map",`shape (${e.rows}, ${e.cols}), the rows and cols`,r)}function Ie(t){vn(t.obstacles,t);let e=typeof t.obstacles=="number"?t.obstacles:0;return{
...va(t.rules),...ba(t.rewards),rows:he("rows",t.rows),cols:he("cols",t.cols),n_pursuers:he("n_pursuers",t.n_pursuers),n_evaders:he("n_evaders",t.n_evaders),fov:he(
"fov",t.fov),diagonal:xt("diagonal",t.diagonal),max_steps:he("max_steps",t.max_steps),density:Float64Array.of(e),map:gn(t.obstacles)}}function yn(t,e){return Int32Array.
from((e??[]).flat(),r=>he(t,r)[0])}function bn(t,e){return vn(t.obstacles,e),{seed:Qe("seed",t.seed??0n),episode:Qe("episode",t.episode??0),pursuers:yn("pursuer\
s",t.pursuers),evaders:yn("evaders",t.evaders),map:gn(t.obstacles)}}function St(t){return{actions:Int32Array.from(t,e=>he("actions",e)[0])}}function Ue(t){if(typeof t==
"string"){if(!Object.hasOwn(ur,t))throw I("policy",`one of ${Object.keys(ur).join(", ")}`,t);return{script:new TextEncoder().encode(t)}}if(t.activation!=="relu"&&
t.activation!=="tanh")throw I("activation","'relu' or 'tanh'",t.activation);if(!hn.includes(t.memory))throw I("memory",`one of ${hn.join(", ")}`,t.memory);return{
hidden:Int32Array.from(t.hidden,e=>he("hidden",e)[0]),activation:new TextEncoder().encode(t.activation),sampled:xt("sampled",t.sampled),memory:new TextEncoder().
encode(t.memory),genome:t.genome}}var wa=["first_turn","terminated","truncated"];function wn(t){let e={...t};for(let r of wa)e[r]=new Le(t[r]);return e}var xn="statistics.",Mt=class{config;seed;episode;n_agents;statistics;first_conflict;constructor(e,r,n,o){this.config=e,this.seed=r,this.episode=n,this.n_agents=
e.n_pursuers+e.n_evaders,this.statistics=Sa(Sn(o)),Object.assign(this,o),this.first_conflict=xa(this.conflict_table,this.length)}get length(){return this.actions.
length/this.n_agents}conflicts(e){this.check(e);let[r,n]=[this.first_conflict[e],this.first_conflict[e+1]],o=this.conflict_table.subarray(r*Pe,n*Pe);return wt(o,
this.config.n_pursuers)}seek(e,r,n){this.check(r),(!(e.seed===this.seed&&e.episode===BigInt(this.episode))||e.turn!==0||e.steps>r)&&e.reset({seed:this.seed,episode:this.
episode});for(let s=e.steps;s<r;++s){let a=this.actions.subarray(s*this.n_agents,(s+1)*this.n_agents);n?e.replay(a,{pursuer:n.pursuers,evader:n.evaders}):e.step(
a)}}check(e){if(!(Number.isInteger(e)&&e>=0&&e<=this.length))throw I("step",`0 to ${this.length}`,e)}};function xa(t,e){let r=new Int32Array(e+2);for(let n=0;n<
t.length;n+=Pe)++r[t[n]+1];for(let n=1;n<r.length;++n)r[n]+=r[n-1];return r}function Sa(t){let e=["capture_rate","ever_capture_rate","captured_fraction","length"];
return Object.fromEntries(Object.entries(t).map(([r,n])=>[r,e.includes(r)?Number(n[0]):n]))}var Sn=t=>Object.fromEntries(Object.entries(t).flatMap(([e,r])=>e.startsWith(
xn)?[[e.slice(xn.length),r]]:[]));function Mn(t,e,r,n){let o=[Ie(r.config),Ue(r.pursuers),Ue(r.evaders),n];return xe(t,s=>{let[a,i,l,c]=o.map(u=>s.arrays(u));return t[e](
a,i,l,c)}),Ne(t)}function An(t,e,r,n){let o={seed:Qe("seed",r),episode:Qe("episode",n)};return new Mt(e.config,r,n,Mn(t,"_play_match",e,o))}function Tn(t,e,r,n){
if(!Number.isInteger(n)||n<1)throw I("n_episodes","at least 1",n);let o=Mn(t,"_play_rollout",e,{...r,n_episodes:Int32Array.of(n)});return Sn(o)}var Ma=7e6,Aa=new FinalizationRegistry(([t,e])=>t._states_free(e));function Ta({rules:t,rows:e,cols:r,obstacles:n,diagonal:o,n_pursuers:s,n_evaders:a}){let i=typeof n==
"number"||t.obstacle==="REACH"?0:n.join("").split("#").length-1,l=e*r-i,c=[t.obstacle,t.teammate,t.pursuer].includes("DISAPPEAR"),u=t.capture==="SURROUND"||t.evader===
"REACH",m=t.interaction==="AGENT_TURNS",d=(f,g)=>Array.from({length:g},(w,b)=>m?f:(f+b)/(b+1)).reduce((w,b)=>w*b,1),h=d(l+Number(c),s)*d(l*(1+Number(u))+2,a);return{
SIMULTANEOUS:[s+a],SWARM_TURNS:[s,a],AGENT_TURNS:Array(s+a).fill(1)}[t.interaction].reduce((f,g)=>f+h*(o?9:5)**g,0)}function At(t){return typeof t.obstacles=="n\
umber"&&t.obstacles>0?"obstacles are drawn anew in each episode":Ta(t)>Ma?"the world is too large to be solved on the page":""}var fr=class{value;teams;matrix;n_actions;constructor(e,r){
let{matrix:n,rows:o,cols:s,value:a,agents:i}=r,[l,c]=e.actors,u=Array.from(i).filter(d=>l<=d&&d<c),m=d=>d<e.config.n_pursuers;[this.value,this.matrix,this.n_actions]=
[a[0],n,e.n_actions],this.teams=[{agents:u.filter(m),play:o},{agents:u.filter(d=>!m(d)),play:s}]}marginal(e){let r=this.teams.find(({agents:s})=>s.includes(e));
if(!r)return null;let n=this.n_actions**(r.agents.length-1-r.agents.indexOf(e)),o=Array(this.n_actions).fill(0);return r.play.forEach((s,a)=>o[Math.floor(a/n)%this.
n_actions]+=s),o}lost(e){let[r,n]=this.teams.map(({agents:l})=>l.reduce((c,u)=>c*this.n_actions+e[u],0)),[o,s]=this.teams.map(({play:l})=>l),a=s.reduce((l,c,u)=>l+
c*this.matrix[r*s.length+u],0),i=o.reduce((l,c,u)=>l+c*this.matrix[u*s.length+n],0);return[Math.max(0,this.value-a),Math.max(0,i-this.value)]}},yr=60,et=class{config;payoff;engine;states;n_turns;values;constructor(e,r,n){
[this.engine,this.config,this.payoff]=[e,r,n],this.states=xe(e,i=>e._states_new(i.arrays(Ie(r)))),Aa.register(this,[e,this.states]);let o={SIMULTANEOUS:1,SWARM_TURNS:2,
AGENT_TURNS:r.n_pursuers+r.n_evaders};this.n_turns=o[r.rules.interaction];let{payoffs:s}=this.call(()=>e._states_payoffs(this.states)),a=s;this.values=[[n==="ca\
pture-rate"?a:a.fill(0)]]}goBack(){let e=this.values.at(-1)[0],r=[];for(let o=this.n_turns-1;o>=0;o--){let s=r[o+1]??e;r[o]=this.backup(o,{next:s})}this.payoff===
"capture-time"&&(r[0]=r[0].map((o,s)=>s===this.config.n_evaders?0:o-1)),this.values.push(r);let n=this.payoff==="capture-rate"?this.config.max_steps:Math.min(this.
config.max_steps,yr);return this.values.length<=n&&r[0].some((o,s)=>o!==e[s])}backup(e,r){return this.call(n=>this.engine._states_backup(this.states,e,n.arrays(
r))).values}game(e){let[r,{turn:n}]=[this.config.max_steps-e.steps,e],o=n+1===this.n_turns,s=r>0?this.values[Math.min(r-Number(o),this.values.length-1)]?.[o?0:n+
1]:void 0;if(!s)return null;let a=this.call(i=>this.engine._states_game(this.states,e.address,i.arrays({next:s})));return a.agents.length?new fr(e,a):null}call(e){
return xe(this.engine,e),Ne(this.engine)}};var En=new FinalizationRegistry(([t,e])=>t._world_free(e)),tt=class{config;n_agents;n_actions;engine;at;freed=!1;constructor(e,r){this.engine=e,this.config=r,this.
n_agents=r.n_pursuers+r.n_evaders,this.n_actions=r.diagonal?9:5,this.at=xe(e,n=>e._world_new(n.arrays(Ie(r)))),En.register(this,[e,this.at],this)}free(){this.freed||
(this.freed=!0,En.unregister(this),this.engine._world_free(this.at))}get address(){if(this.freed)throw I("world","one that is in use","one that was freed");return this.
at}reset(e={}){let r=bn(e,this.config);this.call(n=>this.engine._world_reset(this.address,n.arrays(r)))}step(e){let r=St(e);this.call(n=>this.engine._world_step(
this.address,n.arrays(r)))}playTurn(e){let r=St(e);this.call(n=>this.engine._world_play_turn(this.address,n.arrays(r)))}decide(e,r,n){let{n_pursuers:o}=this.config,
s={pursuer:[0,o],evader:[o,this.n_agents]},[a,i]=typeof r=="string"?s[r]:r;if(n.length!==this.n_agents)throw I("actions",String(this.n_agents),n.length);let l=[
Ue(e),St(n)],{actions:c}=this.call(u=>this.engine._world_decide(this.address,u.arrays(l[0]),a,i,u.arrays(l[1])));return Uint8Array.from(c)}replay(e,r){let n=s=>typeof s!=
"string"&&s.memory!=="none";if(!n(r.pursuer)&&!n(r.evader))return this.step(e);let{n_pursuers:o}=this.config;for(let s=this.n_turns;s>0;--s){let[a,i]=this.actors;
a<o&&this.decide(r.pursuer,[a,Math.min(i,o)],e),i>o&&this.decide(r.evader,[Math.max(a,o),i],e),this.playTurn(e)}}get n_turns(){return this.turnNumbers()[1]}get turn(){
return this.turnNumbers()[0]}get actors(){let[,,e,r]=this.turnNumbers();return[e,r]}turnNumbers(){return this.call(()=>this.engine._world_turn(this.address)).turn}get steps(){
return this.read("steps")[0]}get seed(){return this.read("seed")[0]}get episode(){return this.read("episode")[0]}get over(){return this.read("terminated")[0]===
1||this.read("truncated")[0]===1}read(e){return this.call(r=>this.engine._world_read(this.address,r.text(e)))[e]}view(e){let r=3*this.config.fov**2;return this.
read("views").slice(e*r,(e+1)*r)}map(){return this.read("state").slice(2*this.config.rows*this.config.cols)}conflicts(){return wt(this.conflictTable(),this.config.
n_pursuers)}conflictTable(){return this.call(()=>this.engine._world_conflicts(this.address)).conflict_table}answer(e,r){let n=Ue(e),{logits:o,memory:s}=this.call(
l=>this.engine._world_logits(this.address,l.arrays(n),r)),a=o,i=this.decide(e,[r,r+1],new Uint8Array(this.n_agents))[r];return{logits:a,probabilities:Ea(a),action:i,
memory:s}}snapshot(){return this.call(()=>this.engine._world_snapshot(this.address))}restore(e){let r=wn(e);this.call(n=>this.engine._world_restore(this.address,
n.arrays(r)))}call(e){return xe(this.engine,e),Ne(this.engine)}};function Ea(t){let e=Math.max(...t),r=Array.from(t,o=>Math.exp(o-e)),n=r.reduce((o,s)=>o+s,0);return Float32Array.
from(r,o=>o/n)}var gr=class{compiled;constructor(e){this.compiled=e}world(e){return new tt(this.compiled,e)}solution(e,r="capture-rate"){return new et(this.compiled,e,r)}match(e,r,n,o,s=0){
return An(this.compiled,{config:e,pursuers:r,evaders:n},o,s)}rollouts(e,r,n,o,s){return Tn(this.compiled,{config:e,pursuers:r,evaders:n},o,s)}},Cn;function kn(t=globalThis.
matrixworldEngine){return Cn??=Ca(t),Cn}async function Ca(t){if(!t)throw new Error("matrixworldEngine: expected the script engine.js before this one, got none");
let e=Uint8Array.from(atob(t.binary),r=>r.charCodeAt(0));return new gr(await t({wasmBinary:e}))}var ka="http://www.w3.org/2000/svg";function p(t,e={},...r){return Rn(document.createElement(t),e,r)}function x(t,e={},...r){return Rn(document.createElementNS(
ka,t),e,r)}function Rn(t,e,r){for(let[o,s]of Object.entries(e))s==null||s===!1||(typeof s=="function"?t.addEventListener(o.slice(2),s):t.setAttribute(o,s===!0?"":
String(s)));let n=r.filter(o=>o!=null&&o!==!1);return t.append(...n.map(o=>typeof o=="number"?String(o):o)),t}function $n(t,e){let r=p("select",{onchange:()=>e(
r.value)},...t.map(([n,o])=>p("option",{value:n},o)));return r}async function On(t){try{await t}catch(e){throw(document.querySelector("#page, main")??document.body).
prepend(p("p",{class:"card problem",role:"alert"},`The page could not start: ${String(e)}`)),e}finally{document.body.dataset.ready="true"}}var _n=()=>["file:","\
http:","https:"].includes(location.protocol);var Pn=()=>document.documentElement.dataset.theme==="dark",rt=t=>{document.documentElement.dataset.theme=t?"dark":"light"},vr=()=>rt(!Pn());if(typeof document<"\
u"){let t=matchMedia("(prefers-color-scheme: dark)");t.addEventListener("change",()=>rt(t.matches)),rt(t.matches);let e=!1;addEventListener("beforeprint",()=>{e=
Pn(),rt(!1)}),addEventListener("afterprint",()=>rt(e))}function Ln(){return p("button",{type:"button",title:"Light or dark (D)","aria-label":"Light or dark",onclick:vr},
"◐")}var Nn=(t,e,...r)=>p("header",{class:"top"},p("div",{},p("h1",{},t),e?p("p",{class:"lead"},e):null),p("div",{class:"tools"},...r,Ln()));var Ra=2n**64n-1n;function nt(t,e,r){let n=new URLSearchParams(t.replace(/^#/,"")),o=(c,u,m)=>{let d=n.get(c)??"";return/^\d{1,9}$/.test(d)&&Number(d)<u?Number(
d):m},s=o("run",e.length,r.run),[a,i]=e[s].payoff.shape,l=n.get("seed")??"";return{run:s,pursuer:o("pursuers",a,Math.min(r.pursuer,a-1)),evader:o("evaders",i,Math.
min(r.evader,i-1)),episode:o("episode",1/0,r.episode),seed:/^\d{1,20}$/.test(l)&&BigInt(l)<=Ra?l:null,step:o("step",1/0,0)}}function Un(t,e,r){let[n,o,s]=["",JSON.
stringify(e.selected),-800],a=()=>{let{run:i,pursuer:l,evader:c,episode:u,seed:m}=e.selected,d={run:i,pursuers:l,evaders:c,episode:u,...m===null?{}:{seed:m},step:r.
player.step},h=JSON.stringify(e.selected),y=h!==o&&performance.now()-s>800;h!==o&&([o,s]=[h,performance.now()]),n=`#${Object.entries(d).map(([f,g])=>`${f}=${g}`).
join("&")}`;try{y?history.pushState(null,"",n):history.replaceState(null,"",n)}catch{}};a(),e.on("match",a),r.player.addEventListener("state",()=>r.player.playing||
a()),r.player.addEventListener("step",()=>r.player.playing||a()),window.addEventListener("hashchange",()=>{if(location.hash===n)return;let{step:i,...l}=nt(location.
hash,t,e.selected);for(let c of document.querySelectorAll("dialog[open]"))c.close();o=JSON.stringify(l),e.select(l),r.goTo(i)})}var $a=5e3,In=8e3;function Wn(t,e,r){
let n=-In;for(let o of["pointerdown","pointermove","keydown","wheel"])window.addEventListener(o,()=>n=performance.now(),{passive:!0});setInterval(()=>{if(r()||performance.
now()-n<In)return;let{run:o,pursuer:s,evader:a}=e.selected,[i,l]=t[o].payoff.shape;s===i-1&&a===l-1&&history.replaceState(null,"",`#run=${o}`),location.reload()},
$a)}var O=Uint8Array,ee=Uint16Array,Cr=Int32Array,Et=new O([0,0,0,0,0,0,0,0,1,1,1,1,2,2,2,2,3,3,3,3,4,4,4,4,5,5,5,5,0,0,0,0]),Ct=new O([0,0,0,0,1,1,2,2,3,3,4,4,5,5,
6,6,7,7,8,8,9,9,10,10,11,11,12,12,13,13,0,0]),Sr=new O([16,17,18,0,8,7,9,6,10,5,11,4,12,3,13,2,14,1,15]),Gn=function(t,e){for(var r=new ee(31),n=0;n<31;++n)r[n]=
e+=1<<t[n-1];for(var o=new Cr(r[30]),n=1;n<30;++n)for(var s=r[n];s<r[n+1];++s)o[s]=s-r[n]<<5|n;return{b:r,r:o}},jn=Gn(Et,2),Vn=jn.b,Mr=jn.r;Vn[28]=258,Mr[258]=28;
var Kn=Gn(Ct,0),Oa=Kn.b,Fn=Kn.r,Ar=new ee(32768);for(E=0;E<32768;++E)fe=(E&43690)>>1|(E&21845)<<1,fe=(fe&52428)>>2|(fe&13107)<<2,fe=(fe&61680)>>4|(fe&3855)<<4,Ar[E]=
((fe&65280)>>8|(fe&255)<<8)>>1;var fe,E,ce=(function(t,e,r){for(var n=t.length,o=0,s=new ee(e);o<n;++o)t[o]&&++s[t[o]-1];var a=new ee(e);for(o=1;o<e;++o)a[o]=a[o-
1]+s[o-1]<<1;var i;if(r){i=new ee(1<<e);var l=15-e;for(o=0;o<n;++o)if(t[o])for(var c=o<<4|t[o],u=e-t[o],m=a[t[o]-1]++<<u,d=m|(1<<u)-1;m<=d;++m)i[Ar[m]>>l]=c}else
for(i=new ee(n),o=0;o<n;++o)t[o]&&(i[o]=Ar[a[t[o]-1]++]>>15-t[o]);return i}),Se=new O(288);for(E=0;E<144;++E)Se[E]=8;var E;for(E=144;E<256;++E)Se[E]=9;var E;for(E=
256;E<280;++E)Se[E]=7;var E;for(E=280;E<288;++E)Se[E]=8;var E,at=new O(32);for(E=0;E<32;++E)at[E]=5;var E,_a=ce(Se,9,0),Pa=ce(Se,9,1),La=ce(at,5,0),Na=ce(at,5,1),
br=function(t){for(var e=t[0],r=1;r<t.length;++r)t[r]>e&&(e=t[r]);return e},se=function(t,e,r){var n=e/8|0;return(t[n]|t[n+1]<<8)>>(e&7)&r},wr=function(t,e){var r=e/
8|0;return(t[r]|t[r+1]<<8|t[r+2]<<16)>>(e&7)},kr=function(t){return(t+7)/8|0},Rr=function(t,e,r){return(e==null||e<0)&&(e=0),(r==null||r>t.length)&&(r=t.length),
new O(t.subarray(e,r))};var Ia=["unexpected EOF","invalid block type","invalid length/literal","invalid distance","stream finished","no stream handler",,"no callback","invalid UTF-8 da\
ta","extra field too long","date not in range 1980-2099","filename too long","stream finishing","invalid zip data"],Y=function(t,e,r){var n=new Error(e||Ia[t]);
if(n.code=t,Error.captureStackTrace&&Error.captureStackTrace(n,Y),!r)throw n;return n},Ua=function(t,e,r,n){var o=t.length,s=n?n.length:0;if(!o||e.f&&!e.l)return r||
new O(0);var a=!r,i=a||e.i!=2,l=e.i;a&&(r=new O(o*3));var c=function(Ye){var qe=r.length;if(Ye>qe){var _e=new O(Math.max(qe*2,Ye));_e.set(r),r=_e}},u=e.f||0,m=e.
p||0,d=e.b||0,h=e.l,y=e.d,f=e.m,g=e.n,w=o*8;do{if(!h){u=se(t,m,1);var b=se(t,m+1,3);if(m+=3,b)if(b==1)h=Pa,y=Na,f=9,g=5;else if(b==2){var P=se(t,m,31)+257,C=se(
t,m+10,15)+4,A=P+se(t,m+5,31)+1;m+=14;for(var M=new O(A),U=new O(19),N=0;N<C;++N)U[Sr[N]]=se(t,m+N*3,7);m+=C*3;for(var z=br(U),be=(1<<z)-1,J=ce(U,z,1),N=0;N<A;){
var j=J[se(t,m,be)];m+=j&15;var v=j>>4;if(v<16)M[N++]=v;else{var W=0,R=0;for(v==16?(R=3+se(t,m,3),m+=2,W=M[N-1]):v==17?(R=3+se(t,m,7),m+=3):v==18&&(R=11+se(t,m,
127),m+=7);R--;)M[N++]=W}}var V=M.subarray(0,P),F=M.subarray(P);f=br(V),g=br(F),h=ce(V,f,1),y=ce(F,g,1)}else Y(1);else{var v=kr(m)+4,S=t[v-4]|t[v-3]<<8,T=v+S;if(T>
o){l&&Y(0);break}i&&c(d+S),r.set(t.subarray(v,T),d),e.b=d+=S,e.p=m=T*8,e.f=u;continue}if(m>w){l&&Y(0);break}}i&&c(d+131072);for(var Ke=(1<<f)-1,re=(1<<g)-1,de=m;;de=
m){var W=h[wr(t,m)&Ke],X=W>>4;if(m+=W&15,m>w){l&&Y(0);break}if(W||Y(2),X<256)r[d++]=X;else if(X==256){de=m,h=null;break}else{var Q=X-254;if(X>264){var N=X-257,$=Et[N];
Q=se(t,m,(1<<$)-1)+Vn[N],m+=$}var le=y[wr(t,m)&re],$e=le>>4;le||Y(3),m+=le&15;var F=Oa[$e];if($e>3){var $=Ct[$e];F+=wr(t,m)&(1<<$)-1,m+=$}if(m>w){l&&Y(0);break}
i&&c(d+131072);var Oe=d+Q;if(d<F){var vt=s-F,bt=Math.min(F,Oe);for(vt+d<0&&Y(3);d<bt;++d)r[d]=n[vt+d]}for(;d<Oe;++d)r[d]=r[d-F]}}e.l=h,e.p=de,e.b=d,e.f=u,h&&(u=
1,e.m=f,e.d=y,e.n=g)}while(!u);return d!=r.length&&a?Rr(r,0,d):r.subarray(0,d)},ye=function(t,e,r){r<<=e&7;var n=e/8|0;t[n]|=r,t[n+1]|=r>>8},ot=function(t,e,r){
r<<=e&7;var n=e/8|0;t[n]|=r,t[n+1]|=r>>8,t[n+2]|=r>>16},xr=function(t,e){for(var r=[],n=0;n<t.length;++n)t[n]&&r.push({s:n,f:t[n]});var o=r.length,s=r.slice();if(!o)
return{t:qn,l:0};if(o==1){var a=new O(r[0].s+1);return a[r[0].s]=1,{t:a,l:1}}r.sort(function(T,P){return T.f-P.f}),r.push({s:-1,f:25001});var i=r[0],l=r[1],c=0,
u=1,m=2;for(r[0]={s:-1,f:i.f+l.f,l:i,r:l};u!=o-1;)i=r[r[c].f<r[m].f?c++:m++],l=r[c!=u&&r[c].f<r[m].f?c++:m++],r[u++]={s:-1,f:i.f+l.f,l:i,r:l};for(var d=s[0].s,n=1;n<
o;++n)s[n].s>d&&(d=s[n].s);var h=new ee(d+1),y=Tr(r[u-1],h,0);if(y>e){var n=0,f=0,g=y-e,w=1<<g;for(s.sort(function(P,C){return h[C.s]-h[P.s]||P.f-C.f});n<o;++n){
var b=s[n].s;if(h[b]>e)f+=w-(1<<y-h[b]),h[b]=e;else break}for(f>>=g;f>0;){var v=s[n].s;h[v]<e?f-=1<<e-h[v]++-1:++n}for(;n>=0&&f;--n){var S=s[n].s;h[S]==e&&(--h[S],
++f)}y=e}return{t:new O(h),l:y}},Tr=function(t,e,r){return t.s==-1?Math.max(Tr(t.l,e,r+1),Tr(t.r,e,r+1)):e[t.s]=r},Dn=function(t){for(var e=t.length;e&&!t[--e];)
;for(var r=new ee(++e),n=0,o=t[0],s=1,a=function(l){r[n++]=l},i=1;i<=e;++i)if(t[i]==o&&i!=e)++s;else{if(!o&&s>2){for(;s>138;s-=138)a(32754);s>2&&(a(s>10?s-11<<5|
28690:s-3<<5|12305),s=0)}else if(s>3){for(a(o),--s;s>6;s-=6)a(8304);s>2&&(a(s-3<<5|8208),s=0)}for(;s--;)a(o);s=1,o=t[i]}return{c:r.subarray(0,n),n:e}},st=function(t,e){
for(var r=0,n=0;n<e.length;++n)r+=t[n]*e[n];return r},Yn=function(t,e,r){var n=r.length,o=kr(e+2);t[o]=n&255,t[o+1]=n>>8,t[o+2]=t[o]^255,t[o+3]=t[o+1]^255;for(var s=0;s<
n;++s)t[o+s+4]=r[s];return(o+4+n)*8},zn=function(t,e,r,n,o,s,a,i,l,c,u){ye(e,u++,r),++o[256];for(var m=xr(o,15),d=m.t,h=m.l,y=xr(s,15),f=y.t,g=y.l,w=Dn(d),b=w.c,
v=w.n,S=Dn(f),T=S.c,P=S.n,C=new ee(19),A=0;A<b.length;++A)++C[b[A]&31];for(var A=0;A<T.length;++A)++C[T[A]&31];for(var M=xr(C,7),U=M.t,N=M.l,z=19;z>4&&!U[Sr[z-1]];--z)
;var be=c+5<<3,J=st(o,Se)+st(s,at)+a,j=st(o,d)+st(s,f)+a+14+3*z+st(C,U)+2*C[16]+3*C[17]+7*C[18];if(l>=0&&be<=J&&be<=j)return Yn(e,u,t.subarray(l,l+c));var W,R,V,
F;if(ye(e,u,1+(j<J)),u+=2,j<J){W=ce(d,h,0),R=d,V=ce(f,g,0),F=f;var Ke=ce(U,N,0);ye(e,u,v-257),ye(e,u+5,P-1),ye(e,u+10,z-4),u+=14;for(var A=0;A<z;++A)ye(e,u+3*A,
U[Sr[A]]);u+=3*z;for(var re=[b,T],de=0;de<2;++de)for(var X=re[de],A=0;A<X.length;++A){var Q=X[A]&31;ye(e,u,Ke[Q]),u+=U[Q],Q>15&&(ye(e,u,X[A]>>5&127),u+=X[A]>>12)}}else
W=_a,R=Se,V=La,F=at;for(var A=0;A<i;++A){var $=n[A];if($>255){var Q=$>>18&31;ot(e,u,W[Q+257]),u+=R[Q+257],Q>7&&(ye(e,u,$>>23&31),u+=Et[Q]);var le=$&31;ot(e,u,V[le]),
u+=F[le],le>3&&(ot(e,u,$>>5&8191),u+=Ct[le])}else ot(e,u,W[$]),u+=R[$]}return ot(e,u,W[256]),u+R[256]},Wa=new Cr([65540,131080,131088,131104,262176,1048704,1048832,
2114560,2117632]),qn=new O(0),Fa=function(t,e,r,n,o,s){var a=s.z||t.length,i=new O(n+a+5*(1+Math.ceil(a/7e3))+o),l=i.subarray(n,i.length-o),c=s.l,u=(s.r||0)&7;if(e){
u&&(l[0]=s.r>>3);for(var m=Wa[e-1],d=m>>13,h=m&8191,y=(1<<r)-1,f=s.p||new ee(32768),g=s.h||new ee(y+1),w=Math.ceil(r/3),b=2*w,v=function(ar){return(t[ar]^t[ar+1]<<
w^t[ar+2]<<b)&y},S=new Cr(25e3),T=new ee(288),P=new ee(32),C=0,A=0,M=s.i||0,U=0,N=s.w||0,z=0;M+2<a;++M){var be=v(M),J=M&32767,j=g[be];if(f[J]=j,g[be]=J,N<=M){var W=a-
M;if((C>7e3||U>24576)&&(W>423||!c)){u=zn(t,l,0,S,T,P,A,U,z,M-z,u),U=C=A=0,z=M;for(var R=0;R<286;++R)T[R]=0;for(var R=0;R<30;++R)P[R]=0}var V=2,F=0,Ke=h,re=J-j&32767;
if(W>2&&be==v(M-re))for(var de=Math.min(d,W)-1,X=Math.min(32767,M),Q=Math.min(258,W);re<=X&&--Ke&&J!=j;){if(t[M+V]==t[M+V-re]){for(var $=0;$<Q&&t[M+$]==t[M+$-re];++$)
;if($>V){if(V=$,F=re,$>de)break;for(var le=Math.min(re,$-2),$e=0,R=0;R<le;++R){var Oe=M-re+R&32767,vt=f[Oe],bt=Oe-vt&32767;bt>$e&&($e=bt,j=Oe)}}}J=j,j=f[J],re+=
J-j&32767}if(F){S[U++]=268435456|Mr[V]<<18|Fn[F];var Ye=Mr[V]&31,qe=Fn[F]&31;A+=Et[Ye]+Ct[qe],++T[257+Ye],++P[qe],N=M+V,++C}else S[U++]=t[M],++T[t[M]]}}for(M=Math.
max(M,N);M<a;++M)S[U++]=t[M],++T[t[M]];u=zn(t,l,c,S,T,P,A,U,z,M-z,u),c||(s.r=u&7|l[u/8|0]<<3,u-=7,s.h=g,s.p=f,s.i=M,s.w=N)}else{for(var M=s.w||0;M<a+c;M+=65535){
var _e=M+65535;_e>=a&&(l[u/8|0]=c,_e=a),u=Yn(l,u+1,t.subarray(M,_e))}s.i=a}return Rr(i,0,n+kr(u)+o)},Da=(function(){for(var t=new Int32Array(256),e=0;e<256;++e){
for(var r=e,n=9;--n;)r=(r&1&&-306674912)^r>>>1;t[e]=r}return t})(),za=function(){var t=-1;return{p:function(e){for(var r=t,n=0;n<e.length;++n)r=Da[r&255^e[n]]^r>>>
8;t=r},d:function(){return~t}}};var Ba=function(t,e,r,n,o){if(!o&&(o={l:1},e.dictionary)){var s=e.dictionary.subarray(-32768),a=new O(s.length+t.length);a.set(s),a.set(t,s.length),t=a,o.w=s.length}
return Fa(t,e.level==null?6:e.level,e.mem==null?o.l?Math.ceil(Math.max(8,Math.min(13,Math.log(t.length)))*1.5):20:12+e.mem,r,n,o)},Zn=function(t,e){var r={};for(var n in t)
r[n]=t[n];for(var n in e)r[n]=e[n];return r};var D=function(t,e,r){for(;r;++e)t[e]=r,r>>>=8};var Ha=function(t,e){return((t[0]&15)!=8||t[0]>>4>7||(t[0]<<8|t[1])%31)&&Y(6,"invalid zlib data"),(t[1]>>5&1)==+!e&&Y(6,"invalid zlib data: "+(t[1]&32?"need":"u\
nexpected")+" dictionary"),(t[1]>>3&4)+2};function Ga(t,e){return Ba(t,e||{},0,0)}function Jn(t,e){return Ua(t.subarray(Ha(t,e&&e.dictionary),-4),{i:2},e&&e.out,e&&e.dictionary)}var Xn=function(t,e,r,n){for(var o in t){var s=t[o],a=e+o,i=n;Array.isArray(s)&&(i=Zn(n,s[1]),s=s[0]),s instanceof O?r[a]=[s,i]:(r[a+="/"]=[new O(0),i],Xn(s,a,r,
n))}},Bn=typeof TextEncoder<"u"&&new TextEncoder,ja=typeof TextDecoder<"u"&&new TextDecoder,Va=0;try{ja.decode(qn,{stream:!0}),Va=1}catch{}function Tt(t,e){if(e){for(var r=new O(t.length),n=0;n<t.length;++n)r[n]=t.charCodeAt(n);return r}if(Bn)return Bn.encode(t);for(var o=t.length,s=new O(t.length+
(t.length>>1)),a=0,i=function(u){s[a++]=u},n=0;n<o;++n){if(a+5>s.length){var l=new O(a+8+(o-n<<1));l.set(s),s=l}var c=t.charCodeAt(n);c<128||e?i(c):c<2048?(i(192|
c>>6),i(128|c&63)):c>55295&&c<57344?(c=65536+(c&1047552)|t.charCodeAt(++n)&1023,i(240|c>>18),i(128|c>>12&63),i(128|c>>6&63),i(128|c&63)):(i(224|c>>12),i(128|c>>
6&63),i(128|c&63))}return Rr(s,0,a)}var Er=function(t){var e=0;if(t)for(var r in t){var n=t[r].length;n>65535&&Y(9),e+=n+4}return e},Hn=function(t,e,r,n,o,s,a,i){var l=n.length,c=r.extra,u=i&&i.length,
m=Er(c);D(t,e,a!=null?33639248:67324752),e+=4,a!=null&&(t[e++]=20,t[e++]=r.os),t[e]=20,e+=2,t[e++]=r.flag<<1|(s<0&&8),t[e++]=o&&8,t[e++]=r.compression&255,t[e++]=
r.compression>>8;var d=new Date(r.mtime==null?Date.now():r.mtime),h=d.getFullYear()-1980;if((h<0||h>119)&&Y(10),D(t,e,h<<25|d.getMonth()+1<<21|d.getDate()<<16|d.
getHours()<<11|d.getMinutes()<<5|d.getSeconds()>>1),e+=4,s!=-1&&(D(t,e,r.crc),D(t,e+4,s<0?-s-2:s),D(t,e+8,r.size)),D(t,e+12,l),D(t,e+14,m),e+=16,a!=null&&(D(t,e,
u),D(t,e+6,r.attrs),D(t,e+10,a),e+=14),t.set(n,e),e+=l,m)for(var y in c){var f=c[y],g=f.length;D(t,e,+y),D(t,e+2,g),t.set(f,e+4),e+=4+g}return u&&(t.set(i,e),e+=
u),e},Ka=function(t,e,r,n,o){D(t,e,101010256),D(t,e+8,r),D(t,e+10,r),D(t,e+12,n),D(t,e+16,o)};function Qn(t,e){e||(e={});var r={},n=[];Xn(t,"",r,e);var o=0,s=0;for(var a in r){var i=r[a],l=i[0],c=i[1],u=c.level==0?0:8,m=Tt(a),d=m.length,h=c.comment,y=h&&
Tt(h),f=y&&y.length,g=Er(c.extra);d>65535&&Y(11);var w=u?Ga(l,c):l,b=w.length,v=za();v.p(l),n.push(Zn(c,{size:l.length,crc:v.d(),c:w,f:m,m:y,u:d!=a.length||y&&h.
length!=f,o,compression:u})),o+=30+d+g+b,s+=76+2*(d+g)+(f||0)+b}for(var S=new O(s+22),T=o,P=s-o,C=0;C<n.length;++C){var m=n[C];Hn(S,m.o,m,m.f,m.u,m.c.length);var A=30+
m.f.length+Er(m.extra);S.set(m.c,m.o+A),Hn(S,o,m,m.f,m.u,m.c.length,m.o,m.m),o+=16+A+(m.m?m.m.length:0)}return Ka(S,o,n.length,P,T),S}var L=(t,e=2)=>t==null?"-":t.toFixed(e);function eo(t,e,r){return e===null||r===null?L(t):`${L(t)} (${L(e)} to ${L(r)})`}var to=t=>t.toLocaleString("en-GB"),ge=t=>t.
charAt(0).toUpperCase()+t.slice(1);function it(t,e,r,n=!1){let o=(e-t)/Math.max(1,r),s=10**Math.floor(Math.log10(o||1)),a=[1,2,5,10].map(c=>c*s).find(c=>c>=o)??
10*s;n&&(a=Math.max(1,Math.round(a)));let i=Math.ceil(t/a-1e-9),l=Math.floor(e/a+1e-9);return Array.from({length:Math.max(0,l-i+1)},(c,u)=>(i+u)*a)}var Ya={teams:{pursuer:"pursuers",evader:"evaders"},generation:{pursuer:"pursuer generation",evader:"evader generation"},score:"capture rate",means:{pursuer:"ca\
ptures",evader:"escapes"},curves:{pursuer:"captures",evader:"escapes"},ends:["0 all escape","1 all caught"],lead:"Each cell is a match between two generations: \
the brighter, the more evaders are captured. Click one to watch it.",click:"watch its match"},qa=([t,e])=>({teams:{pursuer:t,evader:e},generation:{pursuer:`gene\
ration of ${t}`,evader:`generation of ${e}`},score:`score of the ${t}`,means:{pursuer:t,evader:e},curves:{pursuer:"scores",evader:"scores"},ends:[`0 the ${e} wi\
n`,`1 the ${t} win`],lead:`Each cell is a pair of generations: the brighter, the higher the score of the ${t}. Click one to see more of it.`,click:"see more of \
it"}),_=({game:t})=>t?qa(t.teams):Ya,B=(t,e,r)=>`${_(t).teams[e]} of generation ${r}`,Za=200;function ro(t,e,{pursuer:r,evader:n},o){let{text:s,image:a}=e.shows[`${r}\
 ${n}`]??{},i=Me(t,r,n)?.rates??[],l=`Scores of the ${e.teams[0]} in ${i.length} episodes: ${i.map(c=>L(c)).join(", ")}`;return[s===void 0?null:p("pre",{tabindex:0,
"aria-label":"What the game shows of this pair"},s),a===void 0?null:p("img",{src:a,alt:"What the game shows of this pair",onload:({target:c})=>c.classList.toggle(
"pixels",c.naturalWidth<Za)}),...(s??a)===void 0?[p("p",{class:"muted"},e.missing),Ja(t,e,r,n,o)]:[],i.length>1?p("p",{class:"small numbers"},l):null].filter(c=>c!==
null)}function Ja(t,e,r,n,o){let s=Object.keys(e.shows).map(u=>u.split(" ").map(Number)),a=([u,m])=>(u-r)**2+(m-n)**2,[i,l]=s.sort((u,m)=>a(u)-a(m))[0]??[];if(i===
void 0||l===void 0)return null;let c=`${B(t,"pursuer",i)} against ${B(t,"evader",l)}`;return p("p",{},p("button",{type:"button",onclick:()=>o.select({pursuer:i,
evader:l})},`Nearest: ${c}`))}var ae=["pursuer","evader"],oo=()=>JSON.parse($t("data"));function Me(t,e,r){let[n,o]=[e-t.payoff.first[0],r-t.payoff.first[1]],s=t.payoff.capture_rate[n]?.[o];
return s===void 0?null:{rate:s,rates:t.payoff.capture_rates[n][o],lengths:t.payoff.lengths[n]?.[o]??[]}}function kt(t,e,r){let{script:n,network:o,kept:s,genomes:a}=t.
teams[e];if(n!==null||o===null)return"";if(!s.includes(r))return`The page holds no genome of ${B(t,e,r)}: it would be too large. Choose a generation of ${s.join(
", ")}.`;let i=s.length*o.genome_size;return so(a,o.genome_size).length===i?"":`The page is damaged: it does not hold the ${i} numbers of the ${e}s' genomes. Wr\
ite it again from its run.`}function ne(t,e,r){let{script:n,network:o,kept:s,genomes:a}=t.teams[e];if(n!==null||o===null)return n??"random";let i=s.indexOf(r);if(i<
0)throw new RangeError(`${e}: expected a generation whose genome the page holds, got ${r}`);let l=o.genome_size,c=so(a,l).subarray(i*l,(i+1)*l),{hidden:u,activation:m,
sampled:d,memory:h}=o;return{hidden:u,activation:m,sampled:d,memory:h,genome:c}}function Rt(t,e,{pursuer:r,evader:n,episode:o,seed:s}){let a=e.seeds[r][n];return t.
match(e.world,ne(e,"pursuer",r),ne(e,"evader",n),BigInt(s??a),o)}var $r=4,no=new Map;function so(t,e){let r=no.get(t);if(r)return r;let n=new Float32Array;try{let o=Qa(Or(t),e);o.every(Number.isFinite)&&(n=o)}catch(o){if(!(o instanceof DOMException||
o instanceof RangeError||Xa(o)))throw o}return no.set(t,n),n}var Xa=t=>t instanceof Error&&"code"in t;function Qa(t,e){let r=Jn(t),n=r.length/$r,o=new Uint8Array(
r.length);for(let a=0;a<o.length;a++)o[a]=r[a%$r*n+Math.floor(a/$r)];let s=new Uint32Array(o.buffer);for(let a=e;a<s.length;a++)s[a]^=s[a-e];return new Float32Array(
o.buffer)}function Or(t){let e=atob($t(t)),r=new Uint8Array(e.length);for(let n=0;n<r.length;n++)r[n]=e.charCodeAt(n);return r}var $t=t=>document.getElementById(
t)?.textContent??"";var lt=[.5,1,2,4,8,16,32,64],Ot=0,_t=12,ei=2,We=class extends EventTarget{#e;#r;#t;#n=0;#a=0;#s=!1;#u=null;#f=0;#d=[];#m=[];glide=.28;constructor(e,{speed:r=4,still:n=!1}={}){
super(),[this.#e,this.#r,this.#t]=[e,r,n]}get step(){return this.#n}get time(){return this.#t?this.#n:this.#a}get arrived(){return this.#a===this.#n}get playing(){
return this.#s}get length(){return this.#e}set length(e){this.#e=e,this.#n>e&&this.jump(e),this.#o("state")}get marks(){return this.#d}set marks(e){this.#d=e,this.#o(
"state")}get ticks(){return this.#m}set ticks(e){this.#m=e,this.#o("state")}get pace(){return this.#r||Math.max(ei,this.#e/_t)}get speed(){return this.#r}set speed(e){
this.#r=e,this.#o("state")}changeSpeed(e){let r=lt.findIndex(n=>n>=this.pace);this.speed=lt[Math.min(lt.length-1,Math.max(0,r+e))]}play(){this.#s||!this.#e||(this.#n===
this.#e&&this.jump(0),this.#s=!0,this.#o("state"),this.#l())}pause(){this.#s&&(this.#s=!1,this.#o("state"))}toggle(){this.#s?this.pause():this.play()}move(e){this.
pause();let r=Math.min(this.#e,Math.max(0,this.#n+e));Math.abs(r-this.#a)>1?this.jump(r):this.#p(r),this.#l()}jump(e){this.#a=Math.min(this.#e,Math.max(0,Math.round(
e))),this.#p(this.#a),this.#o("frame")}#p(e){e!==this.#n&&(this.#n=e,this.#o("step"),this.#t&&this.#o("frame"))}#l(){this.#u===null&&(this.#f=performance.now(),
this.#u=requestAnimationFrame(()=>this.#i()))}#i(){this.#u=null;let e=performance.now();this.#c(Math.min(.25,(e-this.#f)/1e3)),this.#f=e,(!this.#t||this.arrived)&&
this.#o("frame"),(this.#s||this.#a!==this.#n)&&(this.#u=requestAnimationFrame(()=>this.#i()))}#c(e){let r=e;for(;r>0;){if(this.#a===this.#n){if(!this.#s)return;
if(this.#n===this.#e)return this.pause();this.#p(this.#n+1)}let n=this.#s?this.pace:1/this.glide,o=this.#n-this.#a,s=Math.min(Math.abs(o),r*n);r-=s/n,this.#a=s===
Math.abs(o)?this.#n:this.#a+Math.sign(o)*s}this.#s&&this.#a===this.#e&&this.pause()}#o(e){this.dispatchEvent(new Event(e))}};function Fe(t,e){if(e.ctrlKey||e.metaKey||
e.altKey)return!1;let r=e.shiftKey?10:1,o={" ":()=>t.toggle(),ArrowRight:()=>t.move(r),ArrowLeft:()=>t.move(-r),Home:()=>t.move(-t.length),End:()=>t.move(t.length),
"+":()=>t.changeSpeed(1),"-":()=>t.changeSpeed(-1)}[e.key];return o?.(),o!==void 0}function ao(t,e,...r){let n=p("dialog",{class:e,"aria-label":t,onclick:({target:o})=>o===n&&n.close()},p("div",{class:"dialog-head"},p("h2",{},t),p("button",{type:"\
button",class:"close","aria-label":"Close",onclick:()=>n.close()},"✕")),...r);return n}var io=t=>p("dl",{class:"keys"},...t.flatMap(([e,r])=>[p("dt",{},...e.map(
n=>p("kbd",{},n))),p("dd",{},r)])),lo=t=>p("input",{type:"text",readonly:!0,"aria-label":t});function co(t,e){let r=URL.createObjectURL(new Blob([e],{type:"appl\
ication/octet-stream"}));p("a",{href:r,download:t}).click(),setTimeout(()=>URL.revokeObjectURL(r),6e4)}var ct=[[68,1,84],[72,26,108],[71,47,125],[65,68,135],[57,86,140],[49,104,142],[42,120,142],[35,136,142],[31,152,139],[34,168,132],[53,183,121],[84,197,104],[122,
209,81],[165,219,54],[210,226,27],[253,231,37]];function Pt(t){let e=Math.min(1,Math.max(0,t))*(ct.length-1),r=Math.min(ct.length-2,Math.floor(e)),[n,o]=[ct[r],
ct[r+1]],s=a=>Math.round(n[a]+(e-r)*(o[a]-n[a]));return[s(0),s(1),s(2)]}function uo(t){let[e,r,n]=Pt(t).map(o=>((o/255+.055)/1.055)**2.4);return .2126*e+.7152*r+
.0722*n>.179?"#000":"#fff"}var mo=t=>`rgb(${Pt(t).join(" ")})`,po=()=>`linear-gradient(to right, ${ct.map(t=>`rgb(${t.join(" ")})`).join(", ")})`;function Lt(t,e,r){let n=devicePixelRatio||1;for(let[a,i]of Object.entries(r))t.style.setProperty(a,`${i}px`);t.width=Math.round(r.width*n),t.height=Math.round(
r.height*n);let o=t.getContext("2d"),s=_r(e);!o||!s||(o.imageSmoothingEnabled=!1,o.drawImage(s,0,0,t.width,t.height))}function _r(t){let[e,r]=t.shape,n=document.
createElement("canvas");[n.width,n.height]=[r,e];let o=n.getContext("2d");if(!o)return null;let s=o.createImageData(r,e);return t.capture_rate.forEach((a,i)=>a.
forEach((l,c)=>{let u=4*((e-1-i-t.first[0])*r+c+t.first[1]);s.data.set([...Pt(l),255],u)})),o.putImageData(s,0,0),n}function Nt(t,e,r,n=2){t.textContent=L(e,n),
t.ariaLabel=`${r}: ${t.textContent}`,e!==void 0&&([t.style.backgroundColor,t.style.color]=[mo(e),uo(e)])}function ut(t,e){let r=p("span",{class:"gradient"});return r.
style.backgroundImage=po(),p("p",{class:"scale-of-rates small muted"},t,r,e)}var ti=84;function ho(t,e){let r=t.map((s,a)=>ri(s,a,e)),n=p("nav",{class:"races","aria-label":"Runs"},...r.map(s=>s.button)),o=()=>r.forEach((s,a)=>s.update(a===
e.selected.run));return e.on("match hover",o),o(),n.hidden=t.length<2,n}function ri(t,e,r){let[n,o]=t.payoff.shape,s=!t.name.startsWith(t.schedule),a=ti/Math.max(
n,o),i=p("canvas",{"aria-hidden":"true"});Lt(i,t.payoff,{left:0,top:0,width:o*a,height:n*a});let l=p("span",{class:"place"}),c=p("button",{type:"button",class:"\
race",title:`${t.name} (key ${e+1})`,onclick:()=>Pr(t,e,r)},p("span",{class:"small-matrix"},i,l),p("span",{class:"race-text"},p("strong",{},s?t.name:t.schedule),
p("span",{class:"small"},t.findings?t.findings.headline:`${t.learning.map(m=>_(t).teams[m]).join(" and ")} against ${ni(t)}`),p("span",{class:"small muted"},`${s?
`${t.schedule}, `:""}seed ${t.seed}`)));return{button:c,update:m=>{c.setAttribute("aria-current",String(m));let d=r.hover.pursuer??r.selected.pursuer,h=r.hover.
evader??r.selected.evader;l.hidden=d>=n||h>=o,l.style.left=`${(h+.5)*a}px`,l.style.top=`${(n-d-.5)*a}px`}}}var ni=t=>t.teams.pursuer.script??t.teams.evader.script??
"another run";function Pr(t,e,r){let[n,o]=t.payoff.shape,{pursuer:s,evader:a}=r.selected;r.select({run:e,pursuer:Math.min(s,n-1),evader:Math.min(a,o-1)})}var oi=t=>[[["Space"],"play or pause"],[["←","→"],"step back or forward; with Shift ten steps"],[["Home","End"],"first or last step"],[["+","−"],"faster o\
r slower"],[["N"],"next episode of the same pair; with Shift the one before"],[["R"],"another seed, not one of the evaluation"],[["O"],"the cell's own seed agai\
n"],[["P"],`next ${_(t).generation.pursuer}; with Shift the one before`],[["E"],`next ${_(t).generation.evader}; with Shift the one before`],[["M"],`to the matr\
ix: arrow keys choose a ${t.game?"pair, Enter shows it":"match, Enter plays it"}`],[["A"],"next agent: what it sees; with Shift the one before"],[["Esc"],"no ag\
ent"],[["T"],"take over the chosen agent, or an evader, from this step on"],[["G"],"this step in the playground: any other rules, actions and places"],[["1","9"],
"first to ninth run"],[["D"],"light or dark"],[["?"],"this list"]],si=["P","E","M","1","D","?"],ai="The page holds the genomes and the engine of this run. A cli\
ck on a cell plays that very match: same seed, same moves. ";function fo(t){let e=t.find(({game:n})=>!n),r=oi(e??t[0]).filter(([[n]])=>e||si.includes(n));return ao(
"Keys","help",io(r),p("p",{class:"muted small"},`${e?ai:""}The page loads nothing from elsewhere; share the file as it is.`))}function yo(t,e,r,n,o,s){let a=(l,c)=>()=>{
let u=t[e.selected.run].payoff.shape[l==="pursuer"?0:1];e.select({[l]:Math.min(u-1,Math.max(0,e.selected[l]+c))})},i={n:()=>e.select({episode:e.selected.episode+
1}),N:()=>e.select({episode:Math.max(0,e.selected.episode-1)}),r:()=>e.select({seed:String(crypto.getRandomValues(new BigUint64Array(1))[0]),episode:0}),o:()=>e.
select({seed:null,episode:0}),p:a("pursuer",1),P:a("pursuer",-1),e:a("evader",1),E:a("evader",-1),m:()=>document.getElementById("matrix")?.focus(),a:()=>r.inspector.
next(1),A:()=>r.inspector.next(-1),Escape:()=>r.inspector.choose(null),t:o,g:s,d:vr,"?":()=>n.showModal()};document.addEventListener("keydown",l=>{let c=l.target instanceof
HTMLSelectElement||l.target instanceof HTMLInputElement,u=l.target instanceof HTMLButtonElement&&(l.key===" "||l.key==="Enter");if(document.querySelector("dialo\
g[open]")||c||u||l.defaultPrevented||l.ctrlKey||l.metaKey||l.altKey)return;let m=i[l.key]??i[l.key.toLowerCase()],d=Number(l.key)-1;if(Fe(r.player,l)||m)m?.();else if(t[d])
Pr(t[d],d,e);else return;l.preventDefault()})}var De=[[0,0],[-1,0],[0,1],[1,0],[0,-1],[-1,1],[1,1],[1,-1],[-1,-1]];function go(t,e,r){let[n,o]=[e[0]-t[0],e[1]-t[1]];return!r&&Math.abs(n)>Math.abs(o)?o=0:r||
(n=0),De.findIndex(([s,a])=>s===Math.sign(n)&&a===Math.sign(o))}var Ee=(t,e)=>e<t.nPursuers,k=(t,e)=>[t.positions[2*e],t.positions[2*e+1]],Lr=({rows:t,cols:e},[
r,n])=>r>=0&&n>=0&&r<t&&n<e,Nr=(t,e,r=3)=>t!==void 0&&[0,1,2].slice(0,r).some(n=>t[3*e+n]),Ir=(t,e)=>Nr(t.fault,e),vo=(t,e)=>!Ir(t,e)&&Nr(t.involved,e,2);function It(t,e,r){
let[n,o]=[k(t,r),k(e,r)],s=n[0]!==o[0]||n[1]!==o[1],a=e.involved===void 0||Nr(e.involved,r);return!!(e.alive[r]&&e.actions?.[r]&&!s&&a)}function Ut(t,e,r){let[n,
o]=k(t,r),[s,a]=De[e.actions?.[r]??0];return[n+s,o+a]}function mt(t,e,r){return Array.from({length:r.everCaptured.length},(o,s)=>s).filter(o=>r.everCaptured[o]&&
!e.everCaptured[o]).map(o=>t.nPursuers+o)}var bo=t=>t.moments.flatMap((e,r)=>r&&mt(t,t.moments[r-1],e).length?[r]:[]);function Wt(t,e){return Array.from({length:e.
alive.length},(n,o)=>o).filter(n=>t.alive[n]&&!e.alive[n])}var wo=[-.31,0,.31],xo=[{size:1,at:[[0,0]]},{size:.62,at:[[-.2,.2],[.2,-.2]]},{size:.54,at:[[-.23,.22],[.23,.22],[0,-.22]]},{size:.54,at:[[-.23,.23],[.23,.23],[
-.23,-.23],[.23,-.23]]},{size:.36,at:wo.flatMap(t=>wo.map(e=>[e,t]))}],ii=.3,li=.35,ci=.55;function pt(t,e){let r=new Map;for(let n=0;n<e.alive.length;n++){if(!e.
alive[n])continue;let[o,s]=k(e,n),a=o*t.cols+s,i=r.get(a);i?i.push(n):r.set(a,[n])}return r}function So(t,e){let r=Array.from(e.alive,(n,o)=>{let[s,a]=k(e,o);return{
x:a+.5,y:s+.5,size:1,alpha:0}});for(let n of pt(t,e).values()){let o=xo[Math.min(n.length,xo.length)-1];n.forEach((s,a)=>{let[i,l]=o.at[Math.min(a,o.at.length-1)],
c=r[s];c.x+=i,c.y+=l,c.size=o.size,c.alpha=1})}return r}var Mo=t=>t*t*(3-2*t),ze=(t,e,r)=>t+(e-t)*r,Ao=t=>Math.min(1,Math.max(0,t));function To(t,e,r,n){let o={
SIMULTANEOUS:1,SWARM_TURNS:2,AGENT_TURNS:r}[t.interaction];if(o===1)return Mo(n);let s=o===r?e:+!Ee(t,e),a=Math.max(1/o,li);return Mo(Ao((n-s/(o-1)*(1-a))/a))}function Ft(t,e){
let r=t.moments.length-1,n=Math.min(Math.floor(e),r),o=t.moments[n],s=So(t,o);if(n===r||e===n)return s;let a=t.moments[n+1],i=So(t,a);return s.map((l,c)=>{let u=To(
t,c,s.length,e-n);return ui(o,a,c,l,i[c],u)})}function Ur(t,e,r){let n=t.moments.length-1,o=Math.min(Math.floor(r),n),[s,a]=[t.moments[o],t.moments[Math.min(o+1,
n)]],i=To(t,e,s.alive.length,r-o),[[l,c],[u,m]]=[k(s,e),k(a,e)];return[ze(c,m,i)+.5,ze(l,u,i)+.5]}function ui(t,e,r,n,o,s){let a=n.alpha>o.alpha,i={x:ze(n.x,o.x,
s),y:ze(n.y,o.y,s),size:a?n.size:ze(n.size,o.size,s),alpha:a?Ao((1-s)/(1-ci)):ze(n.alpha,o.alpha,s)};if(It(t,e,r)){let[l,c]=k(t,r),[u,m]=Ut(t,e,r),d=ii*Math.sin(
Math.PI*s);i.x+=(m-c)*d,i.y+=(u-l)*d}return i}var Eo=2*Math.PI;function Ce(t,e,r,n){t.beginPath(),t.arc(e,r,n/2,0,Eo)}function Dt(t,e,r,n){let o=n/2,s=[[0,-.97],[.97,.83],[-.97,.83]].map(([a,i])=>[e+a*o,r+i*
o]);t.beginPath(),t.moveTo((s[2][0]+s[0][0])/2,(s[2][1]+s[0][1])/2),s.forEach(([a,i],l)=>{let[c,u]=s[(l+1)%3];t.arcTo(a,i,c,u,n*.09)}),t.closePath()}function Co(t,e,r,n){
let o=n*.32;t.beginPath(),t.moveTo(e-o,r-o),t.lineTo(e+o,r+o),t.moveTo(e+o,r-o),t.lineTo(e-o,r+o)}function ko(t,e,r,n){t.beginPath();for(let o=0;o<16;o++){let s=n/
2*(o%2?.6:.95),a=Eo*o/16;t.lineTo(e+s*Math.sin(a),r-s*Math.cos(a))}t.closePath()}function Ro(t,e,r,n,o,s){let a=Math.atan2(o-r,n-e);t.beginPath(),t.moveTo(e,r),
t.lineTo(n,o);for(let i of[-1,1])t.moveTo(n,o),t.lineTo(n-s*Math.cos(a+i*.6),o-s*Math.sin(a+i*.6))}var $o=4,mi=1.6,pi=.95,di=5,hi=.16,fi=9,yi=.09,gi=.2,Oo=.75,H=(t,e)=>t.left+e*t.cell,G=(t,e)=>t.top+e*t.cell;function Be(t,e,r){return Ee(e,r)?t.colors.pursuer:
t.colors.evader}function zt({ctx:t,colors:e},r,n,o,s,a,i=0){t.font=`700 ${Math.round(s)}px system-ui, sans-serif`,t.textAlign="center",t.textBaseline="middle",t.
strokeStyle=e.paper,t.lineWidth=i,i&&t.strokeText(r,n,o),t.fillStyle=a,t.fillText(r,n,o)}function _o({ctx:t,grid:e,colors:r}){let{left:n,top:o,cell:s,rows:a,cols:i}=e,
[l,c]=[i*s,a*s];if(t.fillStyle=r.paper,t.fillRect(n,o,l,c),s<di)return;t.fillStyle=r.line;let u=Math.max(1,Math.round(s/60));for(let m=1;m<i;m++)t.fillRect(n+m*
s,o,u,c);for(let m=1;m<a;m++)t.fillRect(n,o+m*s,l,u)}function Po({ctx:t,grid:e,colors:r},n){let{left:o,top:s,cell:a,rows:i,cols:l}=e;t.fillStyle=r.obstacle;for(let c=0;c<
i*l;c++){if(!n.obstacles[c])continue;let[u,m]=[Math.floor(c/l),c%l];t.fillRect(o+m*a,s+u*a,a,a)}Lo({ctx:t,grid:e,colors:r})}function Lo({ctx:t,grid:{left:e,top:r,
cell:n,rows:o,cols:s},colors:a}){let i=Math.min(5,Math.max(2,Math.round(n/18)));t.strokeStyle=a.frame,t.lineWidth=i,t.strokeRect(e-i/2,r-i/2,s*n+i,o*n+i)}function No({
ctx:t,grid:e,colors:r},n){let{left:o,top:s,cell:a,rows:i,cols:l}=e,c=a<24*n?5:1;t.font=`500 ${Math.round(Math.min(15*n,Math.max(9*n,a*.32)))}px system-ui, sans-\
serif`,t.fillStyle=r.muted,t.textBaseline="alphabetic",t.textAlign="center";let u=5*n+a/40;for(let m=0;m<l;m+=c)t.fillText(String(m),o+(m+.5)*a,s-u);t.textAlign=
"right",t.textBaseline="middle";for(let m=0;m<i;m+=c)t.fillText(String(m),o-u,s+(m+.5)*a)}function Io({grid:t},e,r,n){let o=Math.floor(e.fov/2)+.5,[s,a]=[Math.max(
0,r-o),Math.min(t.cols,r+o)],[i,l]=[Math.max(0,n-o),Math.min(t.rows,n+o)];return[H(t,s),G(t,i),(a-s)*t.cell,(l-i)*t.cell]}function Uo(t,e,r,n){let{ctx:o,grid:s,
colors:a}=t;o.save(),o.beginPath(),o.rect(0,0,o.canvas.width,o.canvas.height),o.rect(...Io(t,e,r,n)),o.clip("evenodd"),o.clearRect(0,0,o.canvas.width,o.canvas.height),
o.fillStyle=a.line,o.fillRect(s.left,s.top,s.cols*s.cell,s.rows*s.cell),o.restore(),Lo(t)}function Wo(t,{x:e,y:r,alpha:n},o){let{ctx:s,grid:a,colors:i}=t,l=Math.
max(a.cell,16*o)*1.06,[c,u]=[H(a,e),G(a,r)];s.globalAlpha=Math.max(n,.6),s.beginPath(),s.roundRect(c-l/2,u-l/2,l,l,l*.2),s.strokeStyle=i.focus,s.lineWidth=Math.
max(2,2.5*o),s.stroke();let m=Math.max(11*o,Math.min(18*o,a.cell*.5)),d=u-l/2<m*1.2,h=u+(d?1:-1)*(l/2+m*.7);s.lineJoin="round",zt(t,"You",c,h,m,i.ink,m*.35),s.globalAlpha=
1}function Fo(t,e,r,n,o){let{ctx:s,grid:a}=t,i=Io(t,e,n,o),l=Be(t,e,r);s.globalAlpha=.11,s.fillStyle=l,s.fillRect(...i),s.globalAlpha=.8,s.strokeStyle=l,s.lineWidth=
Math.max(1,a.cell/24),s.strokeRect(...i),s.globalAlpha=1}function Do(t,e,r,n,o){let{ctx:s,grid:a}=t,i=Math.min(Math.ceil(r),e.moments.length-1),l=e.moments[i];s.
lineCap="round",s.lineWidth=Math.min(fi,Math.max(1,a.cell*hi));for(let c=Math.max(1,Math.floor(r-n)+1);c<=i;c++){let[u,m]=[e.moments[c-1],e.moments[c]],d=Math.max(
0,Math.min(1,(r-c)/n));s.globalAlpha=Oo+(gi-Oo)*d;for(let h=0;h<m.alive.length;h++){let y=c===i&&r<i;if(!u.alive[h]||!(l.alive[h]||y))continue;let f=(Ee(e,h)?-1:
1)*yi,[g,w]=k(u,h),[b,v]=k(m,h);if(g===b&&w===v)continue;let S=y?o[h].x:v+.5,T=y?o[h].y:b+.5;s.strokeStyle=Be(t,e,h),s.beginPath(),s.moveTo(H(a,w+.5+f),G(a,g+.5+
f)),s.lineTo(H(a,S+f),G(a,T+f)),s.stroke()}}s.globalAlpha=1}function zo(t,e,r){let n=Math.min(Math.ceil(r),e.moments.length-1);for(let o=Math.max(1,n-$o+1);o<=n;o++){
let[s,a]=[e.moments[o-1],e.moments[o]],i=o>r?Math.max(0,1-2*(o-r)):1-(r-o)/$o,l=mt(e,s,a);for(let c of Wt(s,a))l.includes(c)||bi(t,k(a,c),i);for(let c of l)vi(t,
k(a,c),i)}t.ctx.globalAlpha=1}function vi({ctx:t,grid:e,colors:r},[n,o],s){t.globalAlpha=s,ko(t,H(e,o+.5),G(e,n+.5),Math.max(8,e.cell*mi)),t.fillStyle=r.capture,
t.fill(),t.strokeStyle=r.ink,t.lineWidth=Math.max(1,e.cell/36),t.lineJoin="round",t.stroke()}function bi({ctx:t,grid:e,colors:r},[n,o],s){t.globalAlpha=s,Co(t,H(
e,o+.5),G(e,n+.5),Math.max(7,e.cell*pi)),t.strokeStyle=r.collision,t.lineWidth=Math.max(2,e.cell*.17),t.lineCap="round",t.stroke()}function Bo({ctx:t,grid:e,colors:r},n,o){
let s=Math.max(1,e.cell*.07);t.strokeStyle=t.fillStyle=r.collision,t.lineWidth=Math.max(1,e.cell*.05),t.setLineDash([e.cell*.14,e.cell*.1]);for(let[a,i]of n){if(a<
0||i<0||a>=e.rows||i>=e.cols)continue;let l=[H(e,i)+s,G(e,a)+s,e.cell-2*s,e.cell-2*s];t.globalAlpha=.2*o,t.fillRect(...l),t.globalAlpha=o,t.strokeRect(...l)}t.setLineDash(
[]),t.globalAlpha=1}function Ho({ctx:t,grid:e,colors:r},n,o,s,a){t.globalAlpha=a,Ce(t,H(e,n),G(e,o),Math.max(8,e.cell*s*1.02)),t.strokeStyle=r.collision,t.lineWidth=
Math.max(1.5,e.cell*.085*Math.sqrt(s)),t.stroke(),t.globalAlpha=1}var wi=.8,xi=.92,Si=15,Mi=7,Wr=9;function Go(t,e,r,n,o,s){n.forEach((a,i)=>{a.alpha>0&&Ai(t,e,r,i,a,o,s)}),t.ctx.globalAlpha=1;for(let a of pt(e,r).values())a.length>
Wr&&Ti(t,n[a[Wr-1]],a.length-Wr+1)}function Ai(t,e,r,n,o,s,a){let{ctx:i,grid:l,colors:c}=t,u=Ee(e,n),[m,d]=[H(l,o.x),G(l,o.y)],h=Math.max(4,l.cell*o.size*(u?xi:
wi)),y=Be(t,e,n),f=!u&&!!r.captured[n-e.nPursuers];if(i.globalAlpha=o.alpha,(u?Dt:Ce)(i,m,d,h),h>Mi*a&&(i.strokeStyle=c.paper,i.lineWidth=Math.max(2,h*.1),i.stroke()),
i.fillStyle=f?c.paper:y,i.fill(),f&&(Ce(i,m,d,h*.82),i.strokeStyle=y,i.lineWidth=h*.18,i.stroke()),!s||h<Si*a)return;let g=String(u?n:n-e.nPursuers),w=h*(u?.4:.5)*
(g.length>1?.8:1);zt(t,g,m,d+h*(u?.17:.03),w,f?y:c.paper)}function Ti(t,e,r){let{cell:n}=t.grid;zt(t,`+${r}`,H(t.grid,e.x),G(t.grid,e.y),n*.3,t.colors.ink,n*.1)}var Ei=.46,Ci=.86,ki=.66,jo=.48,Ri=.78,$i=.58;function Vo(t,e,r,n){let[o,s]=[e.moments[r-1],e.moments[r]];if(!o)return;let{ctx:a,grid:i,colors:l}=t;a.strokeStyle=
l.collision,a.lineWidth=Math.max(1.5,i.cell*.07),a.lineCap="butt",a.globalAlpha=n;for(let c=0;c<s.alive.length;c++)It(o,s,c)&&Oi(t,e,k(o,c),Ut(o,s,c));a.globalAlpha=
1}function Oi({ctx:t,grid:e},r,n,o){let[s,a]=[o[1]-n[1],o[0]-n[0]],i=m=>H(e,n[1]+.5+s*m),l=m=>G(e,n[0]+.5+a*m),c=Lr(r,o)?Ri:$i;t.setLineDash([e.cell*.09,e.cell*
.06]),t.beginPath(),t.moveTo(i(jo),l(jo)),t.lineTo(i(c),l(c)),t.stroke(),t.setLineDash([]);let u=.17*e.cell/Math.hypot(s,a);t.beginPath(),t.moveTo(i(c)-a*u,l(c)+
s*u),t.lineTo(i(c)+a*u,l(c)-s*u),t.stroke()}function Ko(t,e,r,n,o,s){let a=De[s];if(!s||!a)return;let{ctx:i,grid:l,colors:c}=t,u=Lr(e,[n[0]+a[0],n[1]+a[1]])?Ci:
ki,m=Ei*o.size,d=[H(l,o.x+a[1]*m),G(l,o.y+a[0]*m),H(l,o.x+a[1]*u),G(l,o.y+a[0]*u)],h=Math.max(1.5,l.cell*.085);i.lineCap=i.lineJoin="round";for(let[y,f]of[[c.paper,
h*2.1],[Be(t,e,r),h]])i.strokeStyle=y,i.lineWidth=f,Ro(i,...d,l.cell*.2),i.stroke()}var qo={numbers:!0,axes:!1,trail:6,viewers:[],plan:null,selected:null,cursor:null,you:null,fog:!1};function Zo(t,e,r,n,o){let{ctx:s,grid:a,colors:i}=t,l=Math.min(
Math.ceil(r),e.moments.length-1),c=e.moments[l],u=r===l,m=Ft(e,r),d=u?1:Math.max(0,1-2*(l-r));s.clearRect(0,0,s.canvas.width,s.canvas.height),_o(t);for(let f of n.
viewers)m[f]?.alpha&&Fo(t,e,f,...Ur(e,f,r));Po(t,e),n.axes&&No(t,o),Do(t,e,r,n.trail,m),Bo(t,c.contested??[],d),zo(t,e,r),Vo(t,e,l,d),m.forEach(({x:f,y:g,size:w},b)=>{
let v=vo(c,b)?.4:0,S=Ir(c,b)?1:v;S&&Ho(t,f,g,w,S*d)});let h=u?c:e.moments[Math.max(0,l-1)];if(Go(t,e,h,m,n.numbers,o),u&&n.plan)for(let[f,g]of m.entries())g.alpha&&
Ko(t,e,f,k(c,f),g,n.plan[f]??0);n.you!==null&&(n.fog&&Uo(t,e,...Ur(e,n.you,r)),Wo(t,m[n.you],o)),s.lineWidth=Math.max(2,2.5*o),s.strokeStyle=i.focus;let y=n.selected===
null?void 0:m[n.selected];y?.alpha&&Yo(t,y.x,y.y,y.size*.96),n.cursor&&(s.setLineDash([a.cell*.12,a.cell*.08]),Yo(t,n.cursor[1]+.5,n.cursor[0]+.5,.8),s.setLineDash(
[]))}function Yo({ctx:t,grid:e},r,n,o){let s=o*e.cell;t.beginPath(),t.roundRect(e.left+r*e.cell-s/2,e.top+n*e.cell-s/2,s,s,s*.1),t.stroke()}var Jo=(t,e)=>(e+.24)/(t+.24);function Xo(t,e,r,n,o,s){let a=r?28*s:0,i=(c,u)=>(c-a)/(u+2*.12),l=Math.max(1,Math.floor(Math.min(i(n,e),i(o,t))));return{rows:t,cols:e,
cell:l,left:Math.round((n-e*l+a)/2),top:Math.round((o-t*l+a)/2)}}function Qo(t,e,r){let n=Math.floor((r-t.top)/t.cell),o=Math.floor((e-t.left)/t.cell);return n>=
0&&n<t.rows&&o>=0&&o<t.cols?[n,o]:null}var _i=["paper","line","frame","ink","muted","obstacle"],Pi=["pursuer","evader","capture","collision","focus"];function Bt(t){let e=getComputedStyle(t),r=(n,o)=>[
n,e.getPropertyValue(o+n).trim()];return Object.fromEntries([..._i.map(n=>r(n,"--board-")),...Pi.map(n=>r(n,"--"))])}var Ge=()=>matchMedia("(prefers-reduced-motion: reduce)").matches,He=class{canvas;#e=null;#r=0;#t;#n={rows:1,cols:1,left:0,top:0,cell:1};#a=0;constructor(e,r={}){
this.canvas=e,e.classList.add("board"),e.setAttribute("role","img"),this.#t={...qo,...r},new ResizeObserver(()=>this.#u()).observe(e),new MutationObserver(()=>this.
redraw()).observe(document.documentElement,{attributes:!0}),addEventListener("beforeprint",()=>this.drawNow())}set look(e){this.#t={...this.#t,...e},this.#s(),this.
redraw()}show(e,r){this.#e=e,this.#r=Math.min(Math.max(0,r),e.moments.length-1),this.#s(),this.redraw()}redraw(){this.#a||(this.#a=requestAnimationFrame(()=>this.
drawNow()))}drawNow(){cancelAnimationFrame(this.#a),this.#a=0;let e=this.canvas.getContext("2d");if(!e||!this.#e)return;let{rows:r,cols:n}=this.#e,o=devicePixelRatio||
1;this.#n=Xo(r,n,this.#t.axes,this.canvas.width,this.canvas.height,o);let s={ctx:e,grid:this.#n,colors:Bt(this.canvas)};Zo(s,this.#e,this.#r,this.#t,o)}cellAt(e,r){
let n=this.canvas.getBoundingClientRect(),o=this.canvas.width/n.width;return Qo(this.#n,(e-n.left)*o,(r-n.top)*o)}agentAt(e,r){let n=this.cellAt(e,r);if(!n||!this.#e)
return null;let o=this.#e.moments[Math.round(this.#r)],s=pt(this.#e,o).get(n[0]*this.#e.cols+n[1])??[],a=Ft(this.#e,Math.round(this.#r)),i=l=>{let[c,u]=this.pointOf(
a[l].x,a[l].y);return Math.hypot(c-e,u-r)};return s.length?s.reduce((l,c)=>i(c)<i(l)?c:l):null}pointOf(e,r){let n=this.canvas.getBoundingClientRect(),o=n.width/
this.canvas.width,{left:s,top:a,cell:i}=this.#n;return[n.left+(s+e*i)*o,n.top+(a+r*i)*o]}#s(){if(!this.#e)return;let{rows:e,cols:r}=this.#e;this.canvas.style.setProperty(
"--board-aspect",String(Jo(e,r)))}#u(){let e=devicePixelRatio||1,{width:r,height:n}=this.canvas.getBoundingClientRect();this.canvas.width=Math.max(1,Math.round(
r*e)),this.canvas.height=Math.max(1,Math.round(n*e)),this.drawNow()}};function Fr(t,e,r){let{rows:n,cols:o,n_pursuers:s,fov:a,rules:{interaction:i}}=t;return{rows:n,cols:o,nPursuers:s,fov:a,interaction:i,obstacles:e,moments:r}}function Dr(t,e){
return{positions:t.read("last_positions"),alive:t.read("alive"),captured:t.read("captured"),everCaptured:t.read("ever_captured"),actions:e,involved:t.read("invo\
lved"),fault:t.read("fault"),contested:t.conflicts().map(r=>r.cell)}}function es(t){let e=Array.from({length:t.length+1},(r,n)=>Li(t,n));return Fr(t.config,t.map,
e)}function Li(t,e){let r=t.n_agents,n=t.config.n_evaders,o=(a,i,l)=>a.subarray(i*l,(i+1)*l),s={positions:o(t.last_positions,e,2*r),alive:o(t.alive,e,r),captured:o(
t.captured,e,n),everCaptured:o(t.ever_captured,e,n)};return e===0?s:{...s,actions:o(t.actions,e-1,r),involved:o(t.involved,e-1,3*r),fault:o(t.fault,e-1,3*r),get contested(){
return t.conflicts(e).map(a=>a.cell)}}}var Ni=Array.from({length:16},(t,e)=>{let[r,n]=[e%2?6.5:11,Math.PI*e/8];return`${12+r*Math.sin(n)} ${12-r*Math.cos(n)}`}).join(" ");function ts(){let t=[["pursu\
er",x("path",{d:"M12 3 22 20H2z",class:"filled-pursuer"})],["evader",x("circle",{cx:12,cy:12,r:9,class:"filled-evader"})],["capture",x("polygon",{points:Ni,class:"\
filled-capture"})],["captured evader",x("circle",{cx:12,cy:12,r:7.5,class:"ring-evader"})],["conflict",x("rect",{x:3,y:3,width:18,height:18,class:"dashed-confli\
ct"})]];return p("ul",{class:"shapes small","aria-label":"Shapes on the board"},...t.map(([e,r])=>p("li",{},x("svg",{viewBox:"0 0 24 24","aria-hidden":"true"},r),
e)))}var Ii={first:"M6 5v14M19 5 9 12l10 7z",back:"M17 5 7 12l10 7z",play:"M7 4.5 19 12 7 19.5z",pause:"M8 5v14M16 5v14",forward:"M7 5l10 7-10 7z",last:"M18 5v14M5 5\
l10 7-10 7z"};function rs(t){return x("svg",{viewBox:"0 0 24 24","aria-hidden":"true",class:"icon"},x("path",{d:Ii[t]}))}function dt(t,e,r,n){return p("button",
{type:"button",class:"player-button","aria-label":e,title:`${e} (${r})`,onclick:n},rs(t))}function Ht(t){let e=dt("play","Play","Space",()=>t.toggle()),r=p("inp\
ut",{type:"range",class:"player-scrub",min:0,step:1,"aria-label":"Step",oninput:()=>{t.pause(),t.jump(Number(r.value))}}),n=p("div",{class:"captures","aria-hidd\
en":"true",title:"Captures"}),o=p("div",{class:"losses","aria-hidden":"true"}),s=p("select",{class:"player-speed","aria-label":"Speed",title:`Steps a second, or\
 the whole in ${_t} s (+ and -)`,onchange:()=>t.speed=Number(s.value)},p("option",{value:Ot},`in ${_t} s`),...lt.map(m=>p("option",{value:m},`${m} / s`))),a=p("\
output",{class:"player-count"}),i=p("div",{class:"player",role:"group","aria-label":"Player"},dt("first","First step","Home",()=>t.move(-t.length)),dt("back","S\
tep back","←",()=>t.move(-1)),e,dt("forward","Step forward","→",()=>t.move(1)),dt("last","Last step","End",()=>t.move(t.length)),p("div",{class:"scrub"},n,o,
r),a,s),l=(m,d={})=>{let h=p("i",d);return h.style.left=`${100*m/Math.max(1,t.length)}%`,h},c=()=>{n.replaceChildren(...t.marks.map(m=>l(m))),o.replaceChildren(
...t.ticks.map(({step:m,kind:d,size:h,text:y})=>{let f=l(m,{class:d,title:`Step ${m}: ${y}`});return f.style.height=`${100*h}%`,f}))},u=()=>{e.replaceChildren(rs(
t.playing?"pause":"play")),e.ariaLabel=t.playing?"Pause":"Play",e.title=`${e.ariaLabel} (Space)`,r.max=String(t.length),r.value=String(t.step),r.ariaValueText=`\
step ${t.step} of ${t.length}`,a.textContent=`${t.step} / ${t.length}`,a.style.minWidth=`${2*String(t.length).length+3}ch`,s.value=String(t.speed)};return t.addEventListener(
"step",u),t.addEventListener("state",u),t.addEventListener("state",c),i.addEventListener("keydown",m=>{!(m.target instanceof HTMLSelectElement||m.key===" "&&m.target!==
r)&&Fe(t,m)&&m.preventDefault()}),u(),i}var Ui=40,Gt=class{element;#e;#r=p("div",{class:"episodes",role:"group","aria-label":"Episodes of this cell"});#t=p("p",{class:"check small numbers","aria-live":"\
polite"});constructor(e){this.#e=e,this.element=p("div",{class:"strip-of-episodes"},this.#r,this.#t)}show(e,r){let{pursuer:n,evader:o,episode:s,seed:a}=this.#e.
selected,i=Me(e,n,o);this.#r.replaceChildren(...(i?.rates??[]).slice(0,Ui).map((d,h)=>this.#n(d,h)));let l=a===null?i?.rates[s]:void 0,c=r.statistics.capture_rate,
u=l!==void 0&&Math.abs(c-l)<1e-6&&r.length===i?.lengths[s],m=i?"Not an episode of the evaluation":"The evaluation played no episodes of this pair.";this.#t.dataset.
equal=String(u),this.#t.textContent=u?"As in the evaluation":l===void 0?m:`Episode ${s+1} differs from the evaluation.`,this.#t.title=`Played here: capture rate\
 ${L(c,3)} in ${r.length} steps.${i?` The cell says ${L(i.rate,3)}.`:""}`}#n(e,r){let{selected:n}=this.#e,o=p("span",{class:"bar"});return o.style.height=`${Math.
round(100*e)}%`,p("button",{type:"button",class:"episode",title:`Episode ${r+1}: capture rate ${L(e)}`,"aria-label":`Episode ${r+1}, capture rate ${L(e)}`,"aria\
-pressed":String(r===n.episode&&n.seed===null),onclick:()=>this.#e.select({episode:r,seed:null})},o,p("span",{class:"count"},r+1))}};var ue=["stay","north","east","south","west","northeast","southeast","southwest","northwest"];var ns=0,os=1,Wi=2,Fi=176;function as(t,e,r,n){let o=devicePixelRatio||1,s=Bt(t);t.width=t.height=Fi*o;let a=t.getContext("2d");if(!a)return;let{fov:i}=e,l=t.width/
i;a.fillStyle=s.paper,a.fillRect(0,0,t.width,t.height);for(let u=0;r&&u<i*i;u++){let[m,d]=[(u%i+.5)*l,(Math.floor(u/i)+.5)*l],h=f=>!!r[f*i*i+u];h(Wi)&&(a.fillStyle=
s.obstacle,a.fillRect(m-l/2,d-l/2,l,l));let y=h(ns)&&h(os)?l*.18:0;h(ns)&&ss(a,Ce,m+y,d+y,l*.74,s.evader),h(os)&&ss(a,Dt,m-y,d-y,l*.86,s.pursuer)}a.strokeStyle=
n<e.n_pursuers?s.pursuer:s.evader,a.lineWidth=2*o;let c=Math.floor(i/2)*l;a.strokeRect(c,c,l,l)}function ss(t,e,r,n,o,s){e(t,r,n,o),t.fillStyle=s,t.fill()}var is="What it remembers: a number for each unit, from -1 to 1",jt=class{element;#e;#r=p("canvas",{class:"seen",role:"img"});#t=p("h3");#n=p("p",{class:"small \
muted"});#a=p("div",{class:"answers"});#s=p("div",{title:is});#u=null;#f=null;#d=null;#m=null;#p=null;#l=null;#i=0;constructor(e){this.#e=e,this.element=p("div",
{class:"inspector","data-open":"false"},p("p",{class:"hint small muted"},"Click an agent, or press A: what it sees, and what its network answers."),p("div",{class:"\
inspected"},this.#r,p("div",{class:"answer"},this.#t,this.#n,this.#s),this.#a))}get agent(){return this.#l}show(e,r,n,o){this.#u?.free(),this.#u=e.world(n.config),
this.#d!==r&&(this.#f=null,this.#l!==null&&this.choose(null)),[this.#d,this.#m,this.#p]=[r,n,o]}set solution(e){this.#f=e,this.at(this.#i)}choose(e){this.#l=e,this.
element.dataset.open=String(e!==null),this.#e(e),this.at(this.#i)}next(e){let r=this.#m;if(!r)return;let n=this.#l??(e>0?-1:0);for(let o=0;o<r.n_agents;o++)if(n=
(n+e+r.n_agents)%r.n_agents,r.alive[this.#i*r.n_agents+n])return this.choose(n)}at(e){this.#i=e;let[r,n,o,s,a]=[this.#m,this.#u,this.#d,this.#p,this.#l];if(!r||
!n||!o||!s||a===null)return;let i=a<r.config.n_pursuers?"pursuer":"evader";this.#s.replaceChildren(),this.#t.replaceChildren(p("span",{class:i},K(a,r.config.n_pursuers)));
let l={pursuers:ne(o,"pursuer",s.pursuer),evaders:ne(o,"evader",s.evader)};r.seek(n,e,l);let c=r.actions.subarray(e*r.n_agents,(e+1)*r.n_agents);for(;c.length&&
!n.over&&(a<n.actors[0]||a>=n.actors[1]);)n.playTurn(c);let u=!!(r.alive[e*r.n_agents+a]&&n.read("alive")[a]);as(this.#r,r.config,u?n.view(a):null,a),this.#r.ariaLabel=
`Field of view of ${K(a,r.config.n_pursuers)}: evaders, pursuers and obstacles around it`;let m=c[a]??null;if(!u)return this.#c([],"It is gone.");let d=l[`${i}s`],
h=typeof d=="string"?null:n.answer(d,a),y=h?.probabilities??null;h?.memory.length&&this.#s.replaceChildren(p("p",{class:"small muted"},"It remembers:"),Bi(h.memory));
let f=this.#f?.game(n)??null,g=typeof d=="string"?`The script "${d}" plays for it${m===null?"":`; it goes ${ue[m]}`}.`:d.sampled?"Its action is drawn from these\
 probabilities.":"It takes the most probable action.",w=[["network",y],["perfect",f?.marginal(a)??null]],b=v=>p("p",{class:"small muted"},v);this.#c([...f?[b(`V\
alue ${f.value.toFixed(2)} under perfect play.`)]:[],...Di(w,m)],m===null?"The episode is over.":g)}#c(e,r){this.#a.replaceChildren(...e),this.#n.textContent=r}};
function Di(t,e){let r=t.filter(([,s])=>s);if(!r.length)return[];let n=p("div",{class:"action muted"},p("span"),...r.map(([s])=>p("span",{class:"head"},s))),o=Array.
from(r[0][1],(s,a)=>p("div",{class:a===e?"action taken":"action"},p("span",{},ue[a]),...r.flatMap(([,i])=>zi(i[a]))));return r.length>1||r[0][0]!==t[0][0]?[n,...o]:
o}function zi(t){let e=p("span",{class:"filled"});return e.style.width=`${100*t}%`,[p("span",{class:"track"},e),p("span",{class:"numbers"},t.toFixed(2))]}function Bi(t){
let e=Array.from(t,r=>{let n=p("span",{title:r.toFixed(2)});return n.style.transform=`scaleY(${r})`,n});return p("div",{class:"units",role:"img","aria-label":is},
...e)}function ls(t){let e=JSON.stringify(t,(r,n)=>r==="genome"?Array.from(n):n);return p("script",{type:"application/json",id:"champions"},e.replaceAll("<","\\u003c")).
outerHTML}var cs="champion",us=0,zr=64,Br=100;var Hi=(t,e)=>Object.keys(t).every(r=>t[r]===e[r]);function ms(t,e){return Object.keys(e).find(r=>Hi(e[r],t))??null}var ht="_",Gi="n",tm=2n**64n-1n;var Hr={fov:11,maxSteps:500,rewards:"paper"},ji=["rules","others","rewards","size","diagonal","fov","limit","seed","ended","walls","pursuers","evaders","played",
"next"];function hs(t,e){let r=i=>i.map(l=>Ki(l,e)).join(""),n=i=>`${Math.floor(i/t.cols)}.${i%t.cols}`,o=Vi(t.rewards,e),s=[t.seed,t.episode,t.steps].join("."),a={rules:ds(
t.rules,e),others:t.others?ds(t.others,e):"",rewards:o===Hr.rewards?"":o,size:`${t.rows}x${t.cols}`,diagonal:t.diagonal?"1":"",fov:t.fov===Hr.fov?"":String(t.fov),
limit:t.maxSteps===Hr.maxSteps?"":String(t.maxSteps),seed:s==="0.0.0"?"":s,ended:t.ended?"1":"",walls:t.walls.map(n).join(ht),pursuers:t.pursuers.map(ps).join(ht),
evaders:t.evaders.map(ps).join(ht),played:t.played.map(r).join(ht),next:t.next.every(i=>i===us)?"":r(t.next)};return ji.filter(i=>a[i]).map(i=>`${i}=${a[i]}`).join(
"&")}function ps({cell:t,gone:e,captured:r,everCaptured:n}){let o=r?"c":n?"e":"";return`${t[0]}.${t[1]}${o}${e?"x":""}`}function ds(t,e){let r=e.fields.map(({name:n})=>String(
t[n]).toLowerCase());return ms(t,e.variants)??r.join(".")}function Vi(t,e){let r=JSON.stringify(t);return Object.keys(e.rewards).find(o=>JSON.stringify(e.rewards[o])===
r)??Object.values(t).map(o=>String(o)).join(ht)}function Ki(t,e){if(typeof t=="number")return String(t);if(t===cs)return Gi;let r=e.scripts.findIndex(({name:n})=>n===
t);return String.fromCharCode(97+r)}var Yi="/* the engine */";function fs(t,e){return p("button",{type:"button",class:"to-playground",title:"Open this step in the playground (G): the same agents a\
nd actions under any rules",onclick:()=>Gr(t(),e)},"What if?")}function Gr(t,e){let r=t!==null&&t.match.n_agents<=Br&&Math.max(t.match.config.rows,t.match.config.
cols)<=zr,n=r?hs(qi(t.match,t.step),e):"",o=new TextDecoder().decode(Or("playground")).replace(Yi,()=>$t("script-engine")).replace("</noscript>",s=>r?s+ls(t.champions):
s);window.open(`${URL.createObjectURL(new Blob([o],{type:"text/html"}))}#${n}`)}function qi(t,e){let{config:r,n_agents:n}=t,o=Math.max(0,e-1),s=i=>{let l=o*n+i,
c=o*r.n_evaders+i-r.n_pursuers,u=m=>i>=r.n_pursuers&&!!m[c];return{cell:[t.last_positions[2*l],t.last_positions[2*l+1]],gone:!t.alive[l],captured:u(t.captured),
everCaptured:u(t.ever_captured)}},a=Array.from({length:n},(i,l)=>s(l));return{rules:r.rules,others:null,rewards:r.rewards,rows:r.rows,cols:r.cols,diagonal:r.diagonal,
fov:r.fov,maxSteps:r.max_steps,seed:t.seed,episode:BigInt(t.episode),steps:o,ended:o===t.length,walls:Array.from(t.map.keys()).filter(i=>t.map[i]),pursuers:a.slice(
0,r.n_pursuers),evaders:a.slice(r.n_pursuers),played:[],next:Array.from(t.actions.subarray(o*n,(o+1)*n))}}var jr=.005,gs=.05,Zi=["pursuer","evader"],Ji=4,je=new Map;function Vt(t,e,r="capture-rate"){let n=JSON.stringify([{...e,rewards:null},r]),o=je.get(n)??(At(e)?Promise.
resolve(null):Xi(t,e,r));return je.delete(n),je.set(n,o),je.size>Ji&&je.delete([...je.keys()][0]),o}var vs=({n_evaders:t})=>t===1?"capture-time":"capture-rate",
ys=()=>new Promise(t=>setTimeout(t));async function Xi(t,e,r){await ys();let n=t.solution(e,r);for(;n.goBack();)await ys();return n}function Kt(t,e,r){let{payoff:n}=t;
return r.flatMap((o,s)=>{let a=[0,0];for(let l=e.n_turns;l>0&&!e.over;l--)t.game(e)?.lost(o).forEach((c,u)=>a[u]+=c),e.playTurn(o);let i=n==="capture-rate"?jr:gs;
return Zi.map((l,c)=>({step:s+1,team:l,lost:a[c],payoff:n})).filter(l=>l.lost>=i)})}var Yt=t=>t.map(e=>({step:e.step,kind:e.team,size:e.lost/Math.max(1,...t.map(
({lost:r})=>r)),text:ft(e)})),bs=({lost:t,payoff:e})=>e==="capture-rate"?`${t.toFixed(2)} of the capture rate`:`${t.toFixed(1)} steps`,ft=t=>`The ${t.team}s los\
e ${bs(t)} against a perfect opponent`;function ws(t){let e=t.reduce((r,n)=>n.lost>r.lost?n:r);return`Your team's worst moves, in step ${e.step}, lost ${bs(e)} \
against a perfect opponent.`}function xs({config:t,payoff:e},{value:r},n){if(e==="capture-rate")return`value ${r.toFixed(2)}`;let[o,s]=[1-r,Math.min(t.max_steps-
n,yr)];return o>s-gs?`free for ${s} steps`:`captured after ${o.toFixed(1)} steps`}function Ss(t,e){return(t.marginal(e)??[]).map((n,o)=>({share:n,action:o})).filter(
({share:n})=>n>=jr).sort((n,o)=>o.share-n.share).map(({share:n,action:o})=>n>1-jr?ue[o]:`${ue[o]} ${n.toFixed(2)}`).join(", ")}function qt(t,e,r){if(r===0)return[{kind:"start",text:Qi(t),agents:[]}];let[n,o]=[e.moments[r-1],e.moments[r]],s=u=>K(u,t.config.n_pursuers),a=mt(e,n,o),i=t.conflicts(
r),l=new Set(i.flatMap(u=>u.doomed)),c=a.map(u=>({kind:"capture",text:`${s(u)} is captured`,agents:[u]}));for(let u of Wt(n,o))!a.includes(u)&&!l.has(u)&&c.push(
{kind:"end",text:`${s(u)} disappears`,agents:[u]});return c.push(...i.map(({kind:u,text:m,agents:d})=>({kind:u,text:m,agents:d}))),r===t.length&&c.unshift({kind:"\
end",text:el(t),agents:[]}),c}function Qi({config:t}){return`${t.n_pursuers} pursuers and ${t.n_evaders} evaders on ${t.rows} x ${t.cols} cells, at most ${t.max_steps}\
 steps`}function el(t){let e=Math.round(t.statistics.capture_rate*t.config.n_evaders);return`The episode ends after ${t.length} steps with ${e} of ${t.config.n_evaders}\
 evaders captured`}var tl=60,Zt=class{element;player=new We(0,{speed:Ot,still:Ge()});inspector;match=null;recording=null;actions;#e;#r;#t;#n;#a=p("h2",{class:"match-title"});#s=p(
"p",{class:"tally numbers"});#u=p("ol",{class:"words",tabindex:0,"aria-live":"off","aria-label":"What happened in this step"});#f=p("p",{class:"problem",role:"a\
lert"});#d=p("div",{class:"shown","aria-live":"polite"});#m=null;#p=null;#l=0;#i=!1;#c=0;#o=[];constructor(e,r,n){[this.#r,this.#t]=[e,r];let o=p("canvas",{"ari\
a-label":"The match",onclick:({clientX:s,clientY:a})=>this.inspector.choose(this.#e.agentAt(s,a))});this.#e=new He(o,{numbers:!1}),this.#n=new Gt(r),this.inspector=
new jt(s=>this.#T(s)),this.actions=p("div",{class:"beside"},p("button",{type:"button",class:"to-play",title:"Move the chosen agent, or an evader, yourself from \
this step on (T)",onclick:()=>this.element.dispatchEvent(new Event("takeover"))},"Take over"),n&&fs(()=>this.shown,n)),this.element=p("section",{class:"card mat\
ch-card","aria-label":"Match",id:"match"},p("div",{class:"match"},p("header",{class:"match-head"},this.#a,this.#s),this.#f,this.#d,p("div",{class:"stage"},o),p(
"div",{class:"aside"},this.#u,ts(),this.actions,this.inspector.element),Ht(this.player),this.#n.element)),this.player.addEventListener("frame",()=>this.recording&&
this.#e.show(this.recording,this.player.time)),this.player.addEventListener("step",()=>this.#S()),r.on("match",()=>this.#g()),this.#x(),this.#M(0,0)}get#h(){return this.#r[this.#t.
selected.run]}reveal(){(this.#h.game?this.#d:this.#e.canvas).scrollIntoView({block:"nearest"})}get shown(){return this.match&&this.#p&&{match:this.match,step:this.
player.step,champions:this.#p}}start(e){this.#m=e,this.#v()}playSoon(){this.#i=!0,this.#l||this.#y()}goTo(e){this.#c=e,!this.#l&&this.match&&this.#v()}#y(){!this.#i||
!this.match||(this.#i=!1,this.player.jump(0),Ge()||this.player.play())}#g(){this.#x(),clearTimeout(this.#l),this.#l=setTimeout(()=>this.#v(),tl)}#v(){clearTimeout(
this.#l),this.#l=0,this.player.pause(),this.#x();let{selected:e}=this.#t,{game:r}=this.#h;if(this.#d.replaceChildren(...r?ro(this.#h,r,e,this.#t):[]),r){this.match=
this.recording=null,this.#i=!1,this.#b(e);return}let n=ae.map(a=>kt(this.#h,a,e[a])).find(Boolean)??"";if(this.#f.textContent=n,n||!this.#m)return;this.match=Rt(
this.#m,this.#h,e);let[o,s]=this.names(e);this.#p={pursuer:{name:o,policy:ne(this.#h,"pursuer",e.pursuer)},evader:{name:s,policy:ne(this.#h,"evader",e.evader)}},
this.recording=es(this.match),this.#n.show(this.#h,this.match),this.inspector.show(this.#m,this.#h,this.match,e),this.player.length=this.match.length,this.player.
marks=bo(this.recording),this.#o=this.player.ticks=[],this.player.jump(this.#c),this.#c=0,this.#S(),this.#w(this.#m,this.match),this.#b(e),this.#y()}#b({run:e,pursuer:r,
evader:n,episode:o,seed:s}){this.element.dataset.played=`${e} ${r} ${n} ${o} ${s??""}`}async#w(e,r){let n=await Vt(e,r.config);if(this.match!==r||!n)return;let o=e.
world(r.config);r.seek(o,0),this.#o=Kt(n,o,rl(r)),o.free(),this.player.ticks=Yt(this.#o),this.inspector.solution=n,this.#S()}names({run:e,pursuer:r,evader:n}){let o=this.#r[e],
{teams:s}=o;return[s.pursuer.script??B(o,"pursuer",r),s.evader.script??B(o,"evader",n)]}#x(){let{episode:e,seed:r}=this.#t.selected,{game:n,payoff:o}=this.#h;this.
element.classList.toggle("of-own-game",!!n);let[s,a]=this.names(this.#t.selected),i=r===null?e<o.episodes?`episode ${e+1} of ${o.episodes}`:`episode ${e+1}, not\
 part of the cell`:`seed ${r}`;this.#a.replaceChildren(p("span",{class:"pursuer"},ge(s))," against ",p("span",{class:"evader"},a),n?"":p("span",{class:"muted sm\
all"},i))}#S(){let e=this.match;if(!e||!this.recording)return;let r=this.player.step,n=this.recording.moments[r];this.#M(Array.from(n.everCaptured).filter(Boolean).
length,r),this.#u.replaceChildren(...this.#o.filter(o=>o.step===r).map(o=>p("li",{class:`loss-${o.team}`},ft(o))),...qt(e,this.recording,r).map(o=>p("li",{class:o.
kind,"data-agents":o.agents.join(" ")},o.text))),this.inspector.at(r),this.#A()}#M(e,r){let{world:n}=this.#h;n&&this.#s.replaceChildren(p("strong",{},e),` of ${n.
n_evaders} captured`,p("span",{class:"muted"},` · step ${r}`))}#T(e){this.#e.look={selected:e,viewers:e===null?[]:[e]},this.#A()}#A(){let e=this.inspector.agent;
for(let r of this.#u.children){let n=r.dataset.agents?.split(" ")??[];r.classList.toggle("about",e!==null&&n.includes(String(e)))}}},rl=({actions:t,length:e,n_agents:r})=>Array.
from({length:e},(n,o)=>t.subarray(o*r,(o+1)*r));var nl={ArrowUp:[1,0],ArrowDown:[-1,0],ArrowRight:[0,1],ArrowLeft:[0,-1]},ol=5;function ke(t,e,r,n="pursuer"){t.tabIndex=0,t.setAttribute("role","application"),
t.addEventListener("keydown",o=>{let s=nl[o.key];if(!s)return;let[a,i]=n==="pursuer"?s:[s[1],s[0]],[l,c]=r(),u=o.shiftKey?ol:1,{pursuer:m,evader:d}=e.selected;e.
select({pursuer:Ms(m+u*a,l),evader:Ms(d+u*i,c)}),o.preventDefault(),o.stopPropagation()})}var Ms=(t,e)=>Math.min(e-1,Math.max(0,t));var sl=24,Jt=7,Ts=t=>t<sl&&matchMedia("(pointer: coarse)").matches;function Es(t,e,r,n){let[o,s]=t.payoff.shape,[a,i]=[As(e,o),As(r,s)],[l,c]=[Math.min(Jt,o),Math.
min(Jt,s)],u=[];for(let f=a+l-1;f>=a;f--){u.push(p("span",{class:"pursuer"},f));for(let g=i;g<i+c;g++)u.push(al(t,f,g,n))}let m=Array.from({length:c},(f,g)=>p("\
span",{class:"evader"},i+g)),d=p("button",{type:"button","aria-label":"Close: all cells",onclick:()=>n(null)},"✕"),y=p("div",{class:"loupe numbers",role:"grou\
p","aria-label":"Cells around the tap",onclick:f=>f.stopPropagation()},...u,d,...m);return y.style.gridTemplateColumns=`2.4rem repeat(${c}, minmax(0, 1fr))`,y}function al(t,e,r,n){
let o=p("button",{type:"button",onclick:()=>n({pursuer:e,evader:r})});return Nt(o,Me(t,e,r)?.rate,`${B(t,"pursuer",e)} against ${B(t,"evader",r)}`),o}var As=(t,e)=>Math.
max(0,Math.min(e-Jt,t-Math.floor(Jt/2)));var oe={left:52,bottom:46,top:76,right:84},me=10,il=160,yt=oe.right-me-14,Re=oe.top-me-14,Xt=class{element;#e;#r;#t=p("canvas",{"aria-hidden":"true"});#n=x("svg",
{"aria-hidden":"true"});#a=x("g");#s;#u=p("h2");#f=p("strong",{class:"rate numbers"});#d=p("span",{class:"small muted"});#m=p("p",{class:"of-both-teams small mu\
ted numbers"});#p;#l=null;constructor(e,r){[this.#r,this.#e]=[e,r],this.#s=p("div",{class:"matrix",id:"matrix","aria-label":"Payoff matrix. Arrow keys choose a \
match, Enter plays it.",onpointermove:o=>this.#w(o),onpointerleave:()=>r.point({}),onclick:o=>this.#x(o),onkeydown:({key:o})=>o==="Enter"&&this.#M()},this.#t,this.#n);
let n=p("header",{class:"readout","aria-live":"polite"},p("div",{},this.#u,this.#m),p("div",{class:"of-cell"},this.#f,this.#d));this.#p=ut(..._(this.#i).ends),this.
element=p("section",{class:"card matrix-card","aria-label":"Payoff matrix"},n,this.#s,this.#p),this.#g(),new ResizeObserver(()=>this.#c()).observe(this.#s),this.#s.
addEventListener("mousedown",o=>{o.preventDefault(),document.activeElement instanceof HTMLElement&&document.activeElement.blur()}),ke(this.#s,r,()=>this.#i.payoff.
shape),r.on("run",()=>{let o=ut(..._(this.#i).ends);this.#p.replaceWith(o),this.#p=o,this.#c()}),r.on("match hover",()=>this.#y())}get#i(){return this.#r[this.#e.
selected.run]}#c(){let[e,r]=this.#i.payoff.shape,{clientWidth:n,clientHeight:o}=this.#s;if(n<50)return;let a=Math.max(il,Math.min(n-oe.left-oe.right,o-oe.top-oe.
bottom))/Math.max(e,r),i=Math.max(oe.left,(n-r*a-oe.right+oe.left)/2),l=oe.top+Math.max(0,(o-oe.top-oe.bottom-e*a)/2),c={width:n,height:o,left:i,top:l,cell:a,rows:e,
columns:r};this.#l=c,Lt(this.#t,this.#i.payoff,{left:i,top:l,width:r*a,height:e*a});for(let[u,m,d]of[["left",i,n],["top",l,o],["width",r*a,n],["height",e*a,o]])
this.#t.style.setProperty(u,`${100*m/d}%`);this.#s.style.setProperty("--shape",`${n} / ${o}`),this.#n.setAttribute("viewBox",`0 0 ${n} ${o}`),this.#n.replaceChildren(
ll(c,_(this.#i).generation),...cl(c),...this.#h(c),this.#a),this.#y()}#o(e){let r=this.#i.findings?.generalization;if(!r)return[];let{selected:n,hover:o}=this.#e,
[s,a]=[o.pursuer??n.pursuer,o.evader??n.evader],[i,l]=Cs(e,r.pursuers.mean[s]??0,s),[c,u]=ks(e,r.evaders.mean[a]??0,a);return[x("circle",{class:"dot of-pursuers",
cx:i,cy:l,r:5}),x("circle",{class:"dot of-evaders",cx:c,cy:u,r:5})]}#h(e){let r=this.#i.findings?.generalization;if(!r)return[];let{left:n,top:o,cell:s,rows:a,columns:i}=e,
{curves:l}=_(this.#i),[c,u]=[n+i*s+me,o-me],m={class:"side"};return[x("rect",{...m,x:c,y:o,width:yt,height:a*s}),x("rect",{...m,x:n,y:u-Re,width:i*s,height:Re}),
...Rs(r.pursuers,(d,h)=>Cs(e,d,h),"of-pursuers"),...Rs(r.evaders,(d,h)=>ks(e,d,h),"of-evaders"),x("text",{class:"tick",x:c,y:o+a*s+16,"text-anchor":"start"},"0"),
x("text",{class:"tick",x:c+yt,y:o+a*s+16,"text-anchor":"end"},"1"),x("text",{class:"tick",x:n-6,y:u-4,"text-anchor":"end"},"0"),x("text",{class:"tick",x:n-6,y:u-
Re+8,"text-anchor":"end"},"1"),x("text",{class:"label of-pursuers",x:c+yt,y:o+a*s+34,"text-anchor":"end"},l.pursuer),x("text",{class:"label of-evaders",x:n+i*s+
me,y:u-Re+10,"text-anchor":"start"},l.evader)]}#y(){let e=this.#l;if(!e)return;let{selected:r,hover:n}=this.#e,{left:o,top:s,cell:a,rows:i,columns:l}=e,c=y=>s+(i-
1-y)*a,u=[],m=(y,f)=>x("rect",{class:f,x:o,y:c(y),width:l*a+me+yt,height:a}),d=(y,f)=>x("rect",{class:f,x:o+y*a,y:s-me-Re,width:a,height:me+Re+i*a});u.push(m(r.
pursuer,"strip pursuer"),d(r.evader,"strip evader")),n.pursuer!==null&&n.pursuer<i&&u.push(m(n.pursuer,"strip hover")),n.evader!==null&&n.evader<l&&u.push(d(n.evader,
"strip hover")),u.push(...this.#o(e));let h={x:o+r.evader*a,y:c(r.pursuer),width:a,height:a};u.push(x("rect",{class:"chosen under",...h}),x("rect",{class:"chose\
n",...h})),this.#a.replaceChildren(...u),this.#g()}#g(){let{selected:e,hover:r}=this.#e,n=r.pursuer??e.pursuer,o=r.evader??e.evader,s=Me(this.#i,n,o);this.#u.replaceChildren(
p("span",{class:"pursuer"},ge(B(this.#i,"pursuer",n)))," against ",p("span",{class:"evader"},B(this.#i,"evader",o))),this.#f.textContent=s?L(s.rate,3):"-";let a=s&&
s.rates.length>1?`, mean of ${s.rates.length} episodes`:"";this.#d.textContent=s?_(this.#i).score+a:"no episodes were played",this.#m.textContent=this.#v(n,o)}#v(e,r){
let n=this.#i.findings?.generalization;if(!n)return"";let o=(a,i)=>eo(a.mean[i]??null,a.low?.[i]??null,a.high?.[i]??null),{means:s}=_(this.#i);return`Against al\
l: ${s.pursuer} ${o(n.pursuers,e)}, ${s.evader} ${o(n.evaders,r)}`}#b(e){let r=this.#l;if(!r)return null;let n=this.#s.getBoundingClientRect(),o=Math.floor((e.clientX-
n.left-r.left)/r.cell),s=r.rows-1-Math.floor((e.clientY-n.top-r.top)/r.cell),[a,i]=[s>=0&&s<r.rows,o>=0&&o<r.columns];return a||i?{g:a?s:-1,h:i?o:-1,inside:a&&i}:
null}#w(e){let r=this.#b(e);this.#e.point(r?{pursuer:r.g<0?null:r.g,evader:r.h<0?null:r.h}:{})}#x(e){let r=this.#b(e);if(r){if(r.inside&&Ts(this.#l.cell))return this.#S(
r.g,r.h);this.#e.select({...r.g<0?{}:{pursuer:r.g},...r.h<0?{}:{evader:r.h}}),r.inside&&this.#M()}}#S(e,r){let n=Es(this.#i,e,r,o=>{n.remove(),o&&(this.#e.select(
o),this.#M())});this.#s.append(n)}#M(){this.#s.dispatchEvent(new CustomEvent("play",{bubbles:!0}))}};function ll({left:t,top:e,cell:r,rows:n,columns:o},s){let a=x(
"g",{class:"axes"}),i=e+n*r,l=c=>it(0,c-1,Math.min(c,c*r/44),!0);for(let c of l(o))a.append(x("text",{class:"tick",x:t+(c+.5)*r,y:i+16,"text-anchor":"middle"},c));
for(let c of l(n))a.append(x("text",{class:"tick",x:t-7,y:i-(c+.5)*r,"text-anchor":"end","dominant-baseline":"middle"},c));return a.append(x("text",{class:"labe\
l of-evaders",x:t+o*r/2,y:i+36,"text-anchor":"middle"},s.evader),x("text",{class:"label of-pursuers",transform:`translate(${t-36} ${e+n*r/2}) rotate(-90)`,"text\
-anchor":"middle"},s.pursuer)),a}function cl({left:t,top:e,cell:r,rows:n,columns:o}){let s=x("g",{class:"diagonal"}),a=Math.min(n,o);if(a<3)return[];let i=e+n*r;
for(let u of["H","V"]){let m=`M${t} ${i}`;for(let d=1;d<=a;d++){let[h,y]=[`H${t+d*r}`,`V${i-d*r}`];m+=u==="H"?h+y:y+h}s.append(x("path",{d:m,class:"under"}),x("\
path",{d:m}))}let[l,c]=[t+a/2*r-.7*r-4,i-a/2*r-.7*r-4];return[s,x("text",{class:"on-cells",transform:`translate(${l} ${c}) rotate(-45)`,"text-anchor":"middle"},
"same generation")]}var Cs=({left:t,top:e,cell:r,rows:n,columns:o},s,a)=>[t+o*r+me+s*yt,e+(n-a-.5)*r],ks=({left:t,top:e,cell:r},n,o)=>[t+(o+.5)*r,e-me-n*Re];function Rs(t,e,r){
let n=s=>s.map((a,i)=>e(a??0,i).map(l=>l.toFixed(1)).join(" ")),o=[];return t.low&&t.high&&o.push(x("path",{class:`band ${r}`,d:`M${[...n(t.high),...n(t.low).reverse()].
join("L")}Z`})),o.push(x("path",{class:`line ${r}`,d:`M${n(t.mean).join("L")}`})),o}function ve(t,e,...r){return p("section",{class:"card panel","aria-label":t},p("header",{},p("h2",{},t),p("p",{class:"small muted"},e)),...r)}var ul={present:"●",
absent:"○","cannot tell":"?"};function $s(t){let{findings:e}=t;if(!e?.table.length)return null;let[,...r]=e.table,n=r.map(([s,a,i,l],c)=>{let u=ml(e.reasons[c]??
"");return p("li",{class:`finding ${a.replace(" ","-")}`},p("span",{class:"sign","aria-hidden":"true"},ul[a]??""),p("div",{},p("p",{},p("strong",{},s),` ${a}`,p(
"span",{class:"muted"},` · ${l}`)),u?p("p",{class:"small"},`${u}.`):null,p("p",{class:"small muted numbers"},i)))}),o=ve("What happened","Each condition is pre\
sent, absent, or its 95 % interval cannot tell. The intervals are about this run.",p("p",{class:"headline"},e.sentence),p("p",{},e.headline),...e.numbers.map(s=>p(
"p",{class:"numbers"},`${ge(s)}.`)),p("ul",{class:"findings"},...n),t.limits?p("p",{class:"small"},t.limits):null);return o.classList.add("diagnosis"),{element:o}}
function ml(t){let[,e=""]=t.split(/, because (.*)/s);return ge(e.replace(/\.$/,""))}function Os({settings:t,schedule:e,seed:r}){let n=t.map(({name:a,value:i,help:l})=>p(
"tr",{},p("th",{scope:"row"},`--${a.replaceAll("_","-")}`),p("td",{class:"numbers"},i),p("td",{class:"muted"},l))),o=p("table",{class:"small"},p("caption",{class:"\
heard"},"Settings other than the default"),...n),s=ve("Settings",`${e}, seed ${r}; all others are the defaults of matrixworld evolve.`,n.length?p("div",{class:"\
wide-table"},o):null);return s.classList.add("settings"),{element:s}}function _s(t,e,r){let{findings:n}=t,{teams:o,click:s}=_(t);if(!n?.table.length)return null;let a=n.checkerboards.map(i=>pl(t,i,(l,c)=>{e.select({pursuer:l,evader:c}),
r()}));return{element:ve("Checkerboards",`Two generations of each team: each generation of the ${o.pursuer} is better against another one of the ${o.evader}. Cl\
ick a cell to ${s}.`,a.length?p("div",{class:"boards"},...a):p("p",{},`No four cells differ by more than ${n.margin} in this way.`),a.length&&!t.game?.exact?p("\
p",{class:"small muted"},"The strongest of all pairs, so noise makes them look stronger than they are. The diagnosis says whether there are more than noise make\
s."):null)}}function pl(t,{pursuers:e,evaders:r},n){let o=(s,a)=>{let i=p("button",{type:"button",class:"cell",onclick:()=>n(s,a)});return Nt(i,t.payoff.capture_rate[s][a],
`${B(t,"pursuer",s)} against ${B(t,"evader",a)}`),i};return p("div",{class:"miniature numbers"},p("span"),...r.map(s=>p("span",{class:"evader"},s)),...e.flatMap(
s=>[p("span",{class:"pursuer"},s),...r.map(a=>o(s,a))]))}var Qt={pursuer:"evader",evader:"pursuer"};function Ps(t,e){let r=t.findings?.ciao;if(!r)return null;let n=["pursuer","evader"].map(o=>{let{fading:s,stripes:a,period:i}=r[`${o}\
s`],l=`fading ${L(s)}, stripes ${L(a)}${i===null?"":` every ${i} generations`}`;return dl(t,o,l,e)});return{element:ve("CIAO: current individuals against ancest\
ral opponents","The team's own score. Stripes: intransitive, since wins and losses alternate with the age of the opponent; whether a team returns to earlier str\
ategies is recurrence, under What happened. Darker away from the diagonal: forgetting.",p("div",{class:"triangles"},...n.map(o=>o.element)),ut("0 loses","1 wins")),
update:()=>n.forEach(o=>o.update())}}function dl(t,e,r,n){let o=e==="pursuer"?0:1,s=_(t),[a,i]=[t.payoff.shape[o],t.payoff.shape[1-o]],l=t.payoff.capture_rate,c=Array.
from({length:a},(b,v)=>Array.from({length:Math.min(v+1,i)},(S,T)=>e==="pursuer"?l[v][T]:1-l[T][v])),u=_r({shape:[a,i],first:[0,0],capture_rate:c}),m=x("rect",{class:"\
chosen",width:1,height:1}),d=x("rect",{class:"chosen under",width:1,height:1}),h=x("svg",{viewBox:`0 0 ${i} ${a}`,preserveAspectRatio:"none","aria-hidden":"true"},
d,m),y=p("div",{class:"triangle","aria-label":`CIAO of the ${s.teams[e]}: ${r}. Arrow keys choose a match.`,onpointermove:b=>n.point(f(b)??{}),onpointerleave:()=>n.
point({}),onclick:b=>f(b)&&n.select(f(b))},u,h);ke(y,n,()=>t.payoff.shape,e),y.style.aspectRatio=`${i} / ${a}`;let f=b=>{let v=y.getBoundingClientRect(),S=Math.
floor((b.clientX-v.left)/v.width*i),T=a-1-Math.floor((b.clientY-v.top)/v.height*a);return S>=0&&T<a&&S<=T?{[e]:T,[Qt[e]]:S}:null},g=()=>{let b=n.hover[e]??n.selected[e],
v=n.hover[Qt[e]]??n.selected[Qt[e]];for(let S of[m,d])S.setAttribute("x",String(v)),S.setAttribute("y",String(a-1-b)),S.style.display=v<=b?"":"none"};return{element:p(
"figure",{},p("figcaption",{class:"small"},p("span",{class:e},s.teams[e])),y,p("p",{class:"small muted"},`horizontal: ${s.generation[Qt[e]]}; vertical: ${s.generation[e]}`),
p("p",{class:"small numbers"},r)),update:g}}var er={left:46,right:12,top:10,bottom:42},Ls={x:56,y:34};function Vr(t,e,r,n){let[o,s]=[er.left,er.top],a=Math.max(o+40,t-er.right),i=Math.max(s+40,e-er.bottom),
l=(f,g,w)=>b=>g+(b-f.low)/(f.high-f.low||1)*(w-g),[c,u]=[l(r,o,a),l(n,i,s)],m=x("g"),d=x("svg",{width:t,height:e,viewBox:`0 0 ${t} ${e}`,class:"plot"}),h=x("g",
{class:"axes"});for(let f of it(n.low,n.high,(i-s)/Ls.y,n.whole))h.append(x("line",{x1:o,x2:a,y1:u(f),y2:u(f),class:"grid"}),x("text",{x:o-8,y:u(f),"text-anchor":"\
end","dominant-baseline":"middle"},Ns(f)));for(let f of it(r.low,r.high,(a-o)/Ls.x,r.whole))h.append(x("text",{x:c(f),y:i+16,"text-anchor":"middle"},Ns(f)));return h.
append(x("line",{x1:o,x2:a,y1:i,y2:i,class:"axis"}),x("text",{x:(o+a)/2,y:e-6,"text-anchor":"middle",class:"label"},r.label),x("text",{transform:`translate(12 ${(s+
i)/2}) rotate(-90)`,"text-anchor":"middle",class:"label"},n.label)),d.append(h,m),{root:d,marks:m,left:o,right:a,top:s,bottom:i,x:c,y:u,at:f=>{let g=f-d.getBoundingClientRect().
left;return r.low+(g-o)/(a-o)*(r.high-r.low)}}}var Ns=t=>String(Number(t.toPrecision(6))).replace("-","−");function Kr(t,e,r,n){let o="",s="M";r.forEach((a,i)=>{
a===null?s="M":(o+=`${s}${t.x(e[i]).toFixed(1)} ${t.y(a).toFixed(1)}`,s="L")}),t.root.insertBefore(x("path",{d:o,class:`line ${n}`}),t.marks)}function Is(t,{low:e,
high:r},n){if(!e||!r)return;let o=s=>s.map((a,i)=>`${t.x(i).toFixed(1)} ${t.y(a??0).toFixed(1)}`);t.root.insertBefore(x("path",{d:`M${[...o(r),...o(e).reverse()].
join("L")}Z`,class:`band ${n}`}),t.marks)}function Yr(t,e,r,n=null){let o=t.x(e);t.marks.append(x("line",{x1:o,x2:o,y1:t.top,y2:t.bottom,class:`mark ${r}`})),n!==
null&&t.marks.append(x("circle",{cx:o,cy:t.y(n),r:5,class:`dot ${r}`}))}function qr(...t){return p("p",{class:"legend small"},...t.map(([e,r])=>p("span",{class:`\
key ${r}`},e)))}function Zr(t,e,r,n){let o=p("div",{class:"chart chooses",role:"img","aria-label":t}),s=null,a=()=>{s?.marks.replaceChildren(),s&&r(s)};o.addEventListener(
"click",l=>s&&n(s.at(l.clientX),s,l));let i=()=>{let{clientWidth:l,clientHeight:c}=o;l<50||c<50||(s=e(l,c),o.replaceChildren(s.root),a())};return new ResizeObserver(
i).observe(o),{element:o,update:a,redraw:i}}var Jr=["of-pursuers","of-evaders","of-both"],hl=2500,Us="Arrow keys choose generations.";function Ws(t,e){let{training:r}=t,{score:n,teams:o}=_(t),{capture_rate:s,
generation:a,learner:i,epochs:l}=r,c=s.map((g,w)=>(w+1)*l),u=fl(s,r.window),m=c.at(-1)??1,d=c.length>hl?"dense":"",h=(g,w)=>{let b=a.flatMap((v,S)=>v===g&&(i[S]===
w||i[S]===2)?[S]:[]);return b.length?[c[b[0]],c[b.at(-1)]]:null},y=Zr(`${ge(n)} in ${m} epochs of training. ${Us}`,(g,w)=>{let b=Vr(g,w,{low:0,high:m,label:"epo\
ch",whole:!0},{low:0,high:1,label:n});for(let[v,S]of[["raw",s],[d,u]])for(let[T,P]of Jr.entries()){let C=S.map((A,M)=>i[M]===T||i[M+1]===T?A:null);C.some(A=>A!==
null)&&Kr(b,c,C,`${P} ${v}`)}return b},g=>ae.forEach((w,b)=>{let v=h(e.hover[w]??e.selected[w],b);v&&Yr(g,(v[0]+v[1])/2,Jr[b])}),g=>{let w=Math.min(c.length-1,Math.
max(0,Math.round(g/l)-1)),b=a[w];i[w]!==1&&e.select({pursuer:Math.min(b,t.payoff.shape[0]-1)}),i[w]!==0&&e.select({evader:Math.min(b,t.payoff.shape[1]-1)})});ke(
y.element,e,()=>t.payoff.shape);let f=[...new Set(i)].sort().map(g=>[`${[o.pursuer,o.evader,"both teams"][g]} learn`,Jr[g]]);return{element:ve("Training",`${to(
r.matches)} training matches. Lines: the generations that are selected.`,qr(...f),y.element),update:y.update}}function Fs(t,e){let r=t.findings?.ratings;if(!r)return null;
let n={pursuer:r.pursuers,evader:r.evaders},o={pursuer:n.pursuer.mean,evader:n.evader.mean},s=ae.flatMap(d=>[n[d].mean,n[d].low??[],n[d].high??[]]).flat().map(d=>d??
0),[a,i]=[Math.min(...s),Math.max(...s)],l=.06*(i-a||1),c=Math.max(...t.payoff.shape)-1,{teams:u}=_(t),m=Zr(`Elo ratings by generation. ${Us}`,(d,h)=>{let y=Vr(
d,h,{low:0,high:c,label:"generation",whole:!0},{low:a-l,high:i+l,label:"Elo points"});for(let f of ae)Is(y,n[f],`of-${f}s`),Kr(y,o[f].map((g,w)=>w),o[f],`of-${f}\
s`);return y},d=>{for(let h of ae){let y=e.hover[h]??e.selected[h];Yr(d,y,`of-${h}s`,o[h][y]??null)}},(d,h,y)=>{let f=Math.round(d),g=y.clientY-h.root.getBoundingClientRect().
top,w=v=>Math.abs(h.y(o[v][f]??1/0)-g),b=w("pursuer")<=w("evader")?"pursuer":"evader";f>=0&&f<o[b].length&&e.select({[b]:f})});return ke(m.element,e,()=>t.payoff.
shape),{element:ve("Ratings",`One number for each generation, which cycles do not fit${n.pursuer.low?", with 95 % intervals over episodes":""}. The game itself:\
 ${L(r.offset,0)} points for the ${u.pursuer}.`,qr([u.pursuer,"of-pursuers"],[u.evader,"of-evaders"]),m.element),update:m.update}}function fl(t,e){let r=[0];for(let n of t)
r.push(r.at(-1)+n);return t.map((n,o)=>{let[s,a]=[Math.max(0,o-Math.floor((e-1)/2)),Math.min(t.length,o+Math.floor(e/2)+1)];return(r[a]-r[s])/(a-s)})}function Ds(t,e,r){let n=new Map,o=p("div",{class:"panels"}),s=[],a=()=>s.forEach(l=>l.update?.()),i=()=>{let l=t[e.selected.run];s=n.get(l)??yl(l,e,r),n.set(l,
s),o.replaceChildren(...s.map(c=>c.element)),a()};return e.on("run",i),e.on("match hover",a),i(),o}function yl(t,e,r){return[$s(t),Ws(t,e),_s(t,e,r),Fs(t,e),Ps(
t,e),Os(t)].filter(o=>o!==null)}var zs={pursuer:null,evader:null},tr=class extends EventTarget{#e;#r=zs;constructor(e){super(),this.#e=e}get selected(){return this.#e}get hover(){return this.#r}select(e){
let r=this.#e,n=["run","pursuer","evader"].some(o=>o in e&&e[o]!==r[o]);this.#e={...r,...n?{episode:0,seed:null}:{},...e},this.#e.run!==r.run&&this.dispatchEvent(
new Event("run")),this.dispatchEvent(new Event("match"))}point(e){let r={...zs,...e};r.pursuer===this.#r.pursuer&&r.evader===this.#r.evader||(this.#r=r,this.dispatchEvent(
new Event("hover")))}on(e,r){for(let n of e.split(" "))this.addEventListener(n,r)}};var rr=class{config;start;recording;actions=[];#e;#r;#t=[[]];constructor(e,r,n){[this.config,this.start]=[r,n],this.#e=e.world(r),this.#e.reset(n),this.#r=[Dr(this.#e)],
this.recording=Fr(r,this.#e.map(),this.#r)}get length(){return this.actions.length}get over(){return this.#e.over}get statistics(){return{capture_rate:this.#e.read(
"capture_rate")[0]}}conflicts(e){return this.#t[e]}game(e){return e.game(this.#e)}play(e){this.#e.step(e),this.#n(e)}step(e,r,n){let[o,s]=[this.#e,this.config.n_pursuers],
a=new Uint8Array(o.n_agents);for(let i=o.n_turns;i>0&&!o.over;--i){let[l,c]=o.actors;l<s&&(a=o.decide(e.pursuer,[l,Math.min(c,s)],a)),c>s&&(a=o.decide(e.evader,
[Math.max(l,s),c],a)),typeof n=="number"?a[r]=n:l<=r&&r<c&&(a=o.decide(n,[r,r+1],a)),o.playTurn(a)}this.#n(a)}#n(e){this.actions.push(e),this.#r.push(Dr(this.#e,
e)),this.#t.push(this.#e.conflicts())}};var pe=(t,e)=>ae[+(e>=t.n_pursuers)];function Xr(t,e){let r=new rr(t,e.config,{seed:e.seed,episode:e.episode});for(let n of e.moves)r.over||r.step(e.policies,e.
seat,n);return r}function Ve(t,e){let{moments:r,nPursuers:n}=t.recording,o=r.findIndex(({alive:a,captured:i})=>!a[e]||!!i[e-n]),s=o<0?t.length:o;return{lasted:s,
out:o>=0,captured:Array.from(r[s].everCaptured).filter(Boolean).length}}var nr=(t,e)=>t.over||Ve(t,e).out;function Bs(t,e,r){let n=Xr(t,{...e,moves:e.moves.slice(
0,e.from)});for(;!nr(n,e.seat);)n.step(e.policies,e.seat,r);return Ve(n,e.seat)}function Hs(t){let e=t.length-1;return[...new Set([0,Math.round(e/3),e])].map(r=>t[r])}
function Gs(t,{seat:e,from:r,moves:n}){let o={...t,seat:e,...r?{from:r}:{},moves:n.join("")};return`${location.href.split("#")[0]}#${Object.entries(o).map(([s,a])=>`${s}\
=${a}`).join("&")}`}function js(t,e){let[r,n,o]=[t.get("seat")??"",t.get("from")??"0",t.get("moves")??""];return/^\d{1,6}$/.test(r)&&Number(r)<e.n_pursuers+e.n_evaders&&
(e.diagonal?/^[0-8]+$/:/^[0-4]+$/).test(o)&&o.length<=e.max_steps&&/^\d{1,6}$/.test(n)&&Number(n)<=o.length?{seat:Number(r),from:Number(n),moves:[...o].map(Number)}:
null}function Qr(t,e,r,n,o,s){e.play({title:r,played:n,ending:(a,i)=>[gl(t,a,i,Hs(o))],again:()=>Qr(t,e,r,{...n,moves:n.moves.slice(0,n.from)},o,s),link:a=>s&&Gs(s,a)})}
function gl(t,e,r,n){let o=pe(r.config,r.seat)==="evader",s=o?r.config.max_steps:r.config.n_evaders,a=p("table",{class:"numbers"},p("caption",{},o?"Steps in you\
r seat: same start, same others":"Captures of your team: same start, same others")),i=c=>{let[u,m]=[p("span",{class:o?"bar evader":"bar pursuer"}),p("td",{},"…")];
return a.append(p("tr",{},p("th",{scope:"row"},c),p("td",{class:"track","aria-hidden":"true"},u),m)),({lasted:d,captured:h})=>{u.style.width=`${100*(o?d:h)/s}%`,
m.textContent=String(o?d:h)}};i("You")(Ve(e,r.seat));for(let{name:c,policy:u}of n){let m=i(c);setTimeout(()=>m(Bs(t,r,u())))}let l=r.from?`You took over at step\
 ${r.from}. `:"";return p("div",{},a,p("p",{class:"small muted"},`${l}One match: luck has its part in it.`))}var Vs=["·","↑","→","↓","←","↗","↘","↙","↖"];var vl={" ":0,ArrowUp:1,w:1,ArrowRight:2,d:2,ArrowDown:3,s:3,ArrowLeft:4,a:4,e:5,c:6,y:7,z:7,q:8},en=[8,1,5,4,0,2,7,3,6],bl=[7,8,9,4,5,6,1,2,3],wl=24,xl=Math.tan(
Math.PI/8);function Ys(t,e){if(t.ctrlKey||t.metaKey||t.altKey)return;let r=bl.findIndex(o=>t.code===`Numpad${o}`),n=en[r]??vl[t.key.length===1?t.key.toLowerCase():
t.key];return n!==void 0&&n>4&&!e?void 0:n}function qs(t){let e=en.map(r=>p("button",{type:"button","aria-label":ue[r],onclick:()=>t(r)},Vs[r]));return{element:p(
"div",{class:"play-pad",role:"group","aria-label":"Your move"},...e),show:r=>e.forEach((n,o)=>n.classList.toggle("absent",en[o]>4&&!r))}}function Ks(t,e,r){let n=xl*
Math.max(Math.abs(t),Math.abs(e)),o=s=>Math.abs(s)<n?0:s;return go([0,0],r?[o(t),o(e)]:[t,e],r)}function Zs(t,e,r){let n=null,{canvas:o}=t;o.addEventListener("p\
ointerdown",({button:s,clientX:a,clientY:i})=>n=s===0?[a,i]:null),o.addEventListener("pointercancel",()=>n=null),o.addEventListener("pointerup",({clientX:s,clientY:a})=>{
let[i,l]=[n,e()];if(n=null,!i||!l)return;let[c,u]=[s-i[0],a-i[1]],m=t.cellAt(s,a);Math.hypot(c,u)>=wl?r(Ks(u,c,l.diagonal)):m&&r(Ks(m[0]-l.cell[0],m[1]-l.cell[1],
l.diagonal))})}function Js(t,e){let r=n=>{let o=e[n]-t[n],s=De.findIndex(a=>a[n]===Math.sign(o)&&a[1-n]===0);return o?`${Math.abs(o)} ${ue[s]}`:""};return[r(0),
r(1)].filter(Boolean).join(", ")||"on your cell"}var ea="NUMPY\0",Xs=ea.length+2,Qs=64;function ta(t){return Qn(Object.fromEntries(Object.entries(t).map(([e,r])=>[`${e}.npy`,Sl(r)])))}function Sl({dtype:t,shape:e,
data:r}){let n=typeof r=="string"?Array.from(r,u=>u.codePointAt(0)):null,o=e.map(u=>`${u}, `).join(""),s=`{'descr': '${n?`<U${n.length}`:t}', 'fortran_order': F\
alse, 'shape': (${o}), }`,a=Math.ceil((Xs+s.length+1)/Qs)*Qs-Xs,i=ea+String.fromCharCode(a&255,a>>8)+s.padEnd(a-1)+`
`,l=n?Int32Array.from(n):r,c=new Uint8Array(i.length+l.byteLength);return c.set(Tt(i,!0)),c.set(new Uint8Array(l.buffer,l.byteOffset,l.byteLength),i.length),c}var Ml="matrixworld episode 3";function ra(t,e,r){let{config:n,actions:o,length:s,recording:a}=e,[i,l]=[n.n_pursuers+n.n_evaders,n.n_evaders],c={positions:["<i4",
i,2],last_positions:["<i4",i,2],alive:["|b1",i],captured:["|b1",l],ever_captured:["|b1",l]},u={rewards:["<f4",i],involved:["|b1",i,3],fault:["|b1",i,3]},m={},d=v=>{
for(let S of Object.keys(v))(m[S]??=[]).push(Array.from(h.read(S),Number))},h=t.world(n);h.reset(e.start);let y=[];d(c);for(let v of o)h.step(v),d({...c,...u}),
y.push(...h.conflictTable());h.free();let f={"<i4":Int32Array,"<f4":Float32Array,"|b1":Uint8Array},g={};for(let[v,[S,...T]]of Object.entries({...c,...u})){let P=s+
+(v in c);g[v]={dtype:S,shape:[P,...T],data:f[S].from((m[v]??[]).flat())}}let w=v=>({dtype:"<i8",shape:[],data:Int32Array.of(v,0)}),b=v=>({dtype:"<U",shape:[],data:v});
return ta({format:b(Ml),n_pursuers:w(n.n_pursuers),config:b(JSON.stringify(n)),seat:w(r),...g,actions:{dtype:"|i1",shape:[s,i],data:Int8Array.from(o.flatMap(v=>[
...v]))},map:{dtype:"|b1",shape:[n.rows,n.cols],data:Uint8Array.from(a.obstacles,Number)},conflict_table:{dtype:"<i4",shape:[y.length/11,11],data:Int32Array.from(
y)}})}var Al=[0,1,2,4,8],or=class{element;player=new We(0,{speed:4,still:Ge()});#e;#r;#t=p("canvas",{tabindex:0,"aria-describedby":"play-keys"});#n=p("h2");#a=p("p",{
class:"play-told",role:"status"});#s=qs(e=>this.act(e));#u=$n(Al.map(e=>[e,e?`${e} / s`:"step by step"]),()=>this.#E());#f=p("input",{type:"checkbox",onchange:()=>this.#S()});#d=p(
"input",{type:"checkbox",onchange:()=>this.#C()});#m=p("label",{class:"play-choice"},this.#d,"Best move");#p=p("p",{class:"small muted play-keys",id:"play-keys"});#l=p(
"section",{class:"play-ending",tabindex:-1,"aria-labelledby":"play-headline"});#i=Ht(this.player);#c=null;#o=null;#h=[];#y=null;#g=null;#v=[];#b=0;#w=0;constructor(e){
this.#e=e,this.#r=new He(this.#t,{numbers:!1}),this.#t.setAttribute("role","application"),Zs(this.#r,()=>{let r=this.#y!==null&&this.#o&&k(this.#o.recording.moments.
at(-1),this.#y);return r?{cell:r,diagonal:this.#o.config.diagonal}:null},r=>this.act(r)),this.player.addEventListener("frame",()=>this.#o&&this.#r.show(this.#o.
recording,this.player.time)),this.player.addEventListener("step",()=>this.#C()),this.element=p("div",{class:"play"},p("header",{class:"play-head"},this.#n,this.#a),
p("div",{class:"play-stage"},this.#t),p("div",{class:"play-side"},this.#l,this.#s.element,p("label",{class:"play-choice",title:"Steps a second"},"Pace ",this.#u),
p("label",{class:"play-choice"},this.#f,p("span",{},"Fog",p("span",{class:"at-length"},": see only what it sees"))),this.#m,this.#p),this.#i)}get played(){return this.#c&&
{...this.#c.played,moves:this.#h}}get live(){return this.#o}play(e){this.#x(Xr(this.#e,e.played),e.played.seat,e.title),[this.#c,this.#h,this.#b]=[e,[...e.played.
moves],0],this.element.dataset.state="playing",this.#t.focus({preventScroll:!0}),nr(this.#o,e.played.seat)&&this.#R()}watch(e,r,n){this.#c=null,this.#x(e,r,n),this.#$()}stop(){
this.#E(),this.player.pause(),this.#c=null}act(e){let[r,n]=[this.#c,this.#o];if(!r||!n||this.element.dataset.state!=="playing")return;this.#b=e;let o=Number(this.#u.
value);this.#w||(this.#k(),o&&this.element.dataset.state==="playing"&&(this.#w=setInterval(()=>this.#k(),1e3/o)))}key(e){let{target:r,key:n}=e;if(r instanceof HTMLSelectElement||
r instanceof HTMLInputElement&&(r.type==="text"||n===" ")||r instanceof HTMLButtonElement&&(n===" "||n==="Enter")||!this.#o)return!1;if(this.element.dataset.state!==
"playing")return Fe(this.player,e);let s=Ys(e,this.#o.config.diagonal);return s!==void 0&&this.act(s),s!==void 0}#x(e,r,n){this.#E(),this.player.pause(),[this.#o,
this.#y]=[e,r],this.#n.textContent=n,this.#t.ariaLabel=`Board, ${e.config.rows} by ${e.config.cols} cells`,this.#s.show(e.config.diagonal),this.#p.replaceChildren(
p("span",{class:"at-length"},`W A S D or the arrow keys move, Space stays${e.config.diagonal?"; Q E Z C and the numeric keypad move diagonally":""}. `),"On the \
board: swipe, or tap where to go."),this.#M(e),this.#l.replaceChildren(),this.player.length=e.length,this.player.jump(e.length),this.#C()}#S(){this.#r.look={you:this.#y,
fog:this.#f.checked,viewers:this.#y===null?[]:[this.#y],plan:this.#O()}}#M(e){this.#g=null,this.#v=this.player.ticks=[],this.#m.hidden=this.#d.disabled=!!At(e.config),
Vt(this.#e,e.config,vs(e.config)).then(r=>{this.#o===e&&(this.#g=r,this.#T(),this.#C())})}#T(){let[e,r]=[this.#o,this.#g];if(!r||this.element.dataset.state==="p\
laying")return;let n=this.#e.world(e.config);n.reset(e.start),this.#v=Kt(r,n,e.actions),n.free(),this.player.ticks=Yt(this.#v)}get#A(){return this.#d.checked&&this.#c&&
this.element.dataset.state==="playing"&&this.#g&&this.#o.game(this.#g)||null}#O(){let[e,r]=[this.#y,this.#y!==null&&this.#A?.marginal(this.#y)];return e!==null&&
r?Object.assign(Array(e).fill(0),{[e]:r.indexOf(Math.max(...r))}):null}#E(){clearInterval(this.#w),this.#w=0,this.#a.ariaLive=Number(this.#u.value)?"off":"polit\
e"}#k(){let[{policies:e,seat:r},n]=[this.#c.played,this.#o];n.step(e,r,this.#b),this.#h.push(this.#b),this.player.length=n.length,this.player.glide=Math.min(.22,
.9/(Number(this.#u.value)||4)),this.player.move(n.length-this.player.step),nr(n,r)&&this.#R()}#R(){this.#E();let[e,r,n]=[this.#c,this.#o,this.played],o=_n()?e.link(
n):null,s=`${K(n.seat,r.config.n_pursuers)}-${r.length}-steps.npz`,a=()=>co(s,ra(this.#e,r,n.seat));this.#l.replaceChildren(p("h3",{id:"play-headline"},Cl(r,n.seat)),
...e.ending(r,n),p("div",{class:"play-buttons"},p("button",{type:"button",class:"primary",onclick:()=>e.again()},"Again"),p("button",{type:"button",onclick:()=>this.#$()},
"Watch it"),p("button",{type:"button",onclick:a},"Save"),o&&p("button",{type:"button",onclick:({currentTarget:l})=>Rl(l,o)},"Link"))),this.element.dataset.state=
"ended",this.#T();let i=this.#v.filter(({team:l})=>l===pe(r.config,n.seat));i.length&&this.#l.children[0].after(p("p",{class:"small muted"},ws(i))),this.#l.focus(
{preventScroll:!0}),this.#l.scrollIntoView({block:"nearest"})}#$(){this.element.dataset.state="watched",this.player.length=this.#o.length,this.player.jump(0),Ge()||
this.player.play()}#C(){let[e,r,{step:n}]=[this.#o,this.#y,this.player];if(!e||n>e.length)return;let o=qt(e,e.recording,n).filter(({agents:l})=>r===null||l.includes(
r)),s=this.#c&&n===0,a=s?[Tl(e.config,r),this.#c.about??""]:[`Step ${n} of ${e.config.max_steps}`,...o.map(({text:l})=>l)];!s&&r!==null&&a.push(El(e,n,r)),a.push(
...this.#v.filter(l=>l.step===n).map(ft));let i=n===e.length&&r!==null?this.#A:null;i&&a.push(`Perfect play: ${Ss(i,r)||"decided in its turn"}; ${xs(this.#g,i,n)}`),
this.#S(),this.#a.textContent=a.filter(Boolean).map(l=>`${l}.`).join(" ")}};function Tl(t,e){let r=t.rules.capture==="SURROUND";return pe(t,e)==="evader"?`Run a\
way: you win if ${r?"the pursuers do not surround you":"no pursuer reaches your cell"} in ${t.max_steps} steps`:`Capture evaders: ${r?"surround them with your t\
eam":"move onto their cells"}`}function El({config:t,recording:e},r,n){let o=e.moments[r],a=pe(t,n)==="pursuer"?"evader":"pursuer";if(!o.alive[n])return"";let i=k(
o,n),l=m=>{let[d,h]=k(o,m);return Math.max(Math.abs(d-i[0]),Math.abs(h-i[1]))},c=Array.from({length:o.alive.length},(m,d)=>d).filter(m=>pe(t,m)===a&&o.alive[m]&&
!o.captured[m-t.n_pursuers]&&2*l(m)<t.fov);if(!c.length)return`No ${a} in view`;let u=c.reduce((m,d)=>l(d)<l(m)?d:m);return`Nearest ${a}: ${Js(i,k(o,u))}`}function Cl(t,e){
let[{lasted:r,out:n,captured:o},{config:s}]=[Ve(t,e),t];return pe(s,e)==="pursuer"?`Your team captured ${o} of ${kl(s)} in ${r} steps.`:n?`You lasted ${r} of ${s.
max_steps} steps.`:`You escaped: ${r} steps.`}var kl=({n_evaders:t})=>`${t} evader${t===1?"":"s"}`;function Rl(t,e){let r=lo("Link to this match");r.value=e,t.replaceWith(
r),r.select(),navigator.clipboard?.writeText(e).catch(()=>{})}var sr=class{dialog=p("dialog",{class:"take-over","aria-label":"Play an agent",onclose:()=>this.view?.stop(),onkeydown:e=>this.view?.key(e)&&e.preventDefault()});view=null;#e;#r;#t;#n;#a=null;constructor(e,r,n,o=!0){
[this.#e,this.#r,this.#t,this.#n]=[e,r,n,o],n.element.addEventListener("takeover",()=>this.open())}start(e,r=""){this.#a=e;let n=nt(r,this.#e,this.#r.selected),
{world:o}=this.#e[n.run],s=o&&js(new URLSearchParams(r.replace(/^#/,"")),o);s&&this.play(n,s)}open(){let e=this.#t.shown;if(!e)return;let{match:r,step:n}=e;this.#t.
player.pause();let o=this.#t.inspector.agent,s=n<r.length?n:0,a=(m,d)=>!!r.alive[d*r.n_agents+m],i=Array.from({length:r.n_agents},(m,d)=>(d+r.config.n_pursuers)%
r.n_agents),l=o??i.find(m=>a(m,s)),c=a(l,s)?s:0,u=Array.from({length:c},(m,d)=>r.actions[d*r.n_agents+l]);this.play(this.#r.selected,{seat:l,from:c,moves:u})}play(e,r){
let[n,o]=[this.#a,this.#e[e.run]],{world:s}=o;if(!n||!s||ae.some(w=>kt(o,w,e[w])))return;let{run:a,pursuer:i,evader:l,episode:c,seed:u}=e,m=pe(s,r.seat),d=o.teams[m].
kept.map(w=>({name:o.teams[m].script??`generation ${w}`,text:"",policy:()=>ne(o,m,w)}));this.view||(this.view=new or(n),this.dialog.append(p("button",{type:"but\
ton",class:"leave",onclick:()=>this.dialog.close()},"Close"),this.view.element)),this.dialog.open||this.dialog.showModal();let h=`You are ${K(r.seat,s.n_pursuers)}\
: ${this.#t.names(e).join(" against ")}`,y={pursuer:ne(o,"pursuer",i),evader:ne(o,"evader",l)},f={config:s,seed:BigInt(u??o.seeds[i][l]),episode:c,policies:y,...r},
g={run:a,pursuers:i,evaders:l,episode:c,...u===null?{}:{seed:u}};Qr(n,this.view,h,f,d,this.#n?g:null)}};var ie=oo(),{runs:Z}=ie,[$l,Ol]=Z[0].payoff.shape,_l=nt(location.hash,Z,{run:0,pursuer:$l-1,evader:Ol-1,episode:0,seed:null}),{step:na,...Pl}=_l,te=new tr(Pl),q=new Zt(
Z,te,ie.playground),oa=new Xt(Z,te),gt=new sr(Z,te,q),tn=fo(Z),Ll=location.hash,Ae=null,sa=p("span",{class:"told","aria-live":"polite"}),aa=p("span",{class:"sma\
ll muted"}),ia=()=>{let t=Z[te.selected.run];[sa.textContent,aa.textContent]=[t.findings?.sentence??"",_(t).lead]};te.on("run",ia);ia();var la=()=>{q.playSoon(),
q.reveal()};document.getElementById("page").replaceWith(Nn(ie.heading,p("span",{},sa,aa),p("button",{type:"button",class:"keys-button",title:"Keys (?)","aria-la\
bel":"Keys (?)",onclick:()=>tn.showModal()},"?")),...ie.note?[p("aside",{class:"note small muted"},ie.note)]:[],ho(Z,te),p("main",{class:"stages"},oa.element,q.
element),Ds(Z,te,la),p("footer",{class:"muted small"},`${ie.title} · matrixworld ${ie.version}`),gt.dialog,tn);Object.assign(window,{matrixworldExplorer:{get match(){
return q.match},get step(){return q.player.step},get pace(){return q.player.pace},get playing(){return gt.view},play:t=>Ae&&Rt(Ae,Z[te.selected.run],{...te.selected,
episode:t}),get shape(){return Z[te.selected.run].payoff.shape}}});oa.element.addEventListener("play",la);q.goTo(na);na||q.playSoon();Un(Z,te,q);yo(Z,te,q,tn,()=>gt.
open(),()=>ie.playground&&Gr(q.shown,ie.playground));window.addEventListener("hashchange",({newURL:t})=>Ae&&gt.start(Ae,new URL(t).hash));ie.growing&&Wn(Z,te,()=>q.
player.playing||document.querySelector("dialog[open]")!==null);async function Nl(){Ae=ie.playground&&await kn(),q.start(Ae),Ae&&gt.start(Ae,Ll)}requestAnimationFrame(
()=>setTimeout(()=>On(Nl())));})();
